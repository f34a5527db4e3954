/* For Frama-C's EVA (tests/eva.sh): every public function of ateb.h with any numbers, NaN and infinities among them. */
#define __AVX2__ 1 /* for the loops that are taken where registers are wide */
#define EVA_HEADER "../ateb.h"
#include "eva_words.h"

void eva_pi(void)
{
    sink[0] = ateb_pi(any);
    sink[1] = ateb_pi_nm(any, any);
}

void eva_saca(void)
{
    ateb_saca(any, any, sink, sink + 1);
    sink[2] = ateb_sa(any, any);
    sink[3] = ateb_ca(any, any);
    sink[4] = ateb_integral_sa2(any, any);
    sink[5] = ateb_integral_ca(any, any);
}

void eva_phase(void) { sink[0] = ateb_phase(any, any, any); }
void eva_saca_nm(void) { ateb_saca_nm(any, any, any, sink, sink + 1); }
void eva_beta(void) { sink[0] = ateb_beta(any, any); }
void eva_ln_beta(void) { sink[0] = ateb_ln_beta(any, any); }
void eva_ln_beta_inc(void) { sink[0] = ateb_ln_beta_inc(any, any, any); }
void eva_mean_nm(void) { sink[0] = ateb_mean_nm(any, any, any, any, any_int); }

void eva_beta_inc(void)
{
    ateb_beta_inc_both(any, any, any, any, sink, sink + 1);
    sink[2] = ateb_beta_inc(any, any, any);
}

void eva_beta_inc_inv(void)
{
    ateb_beta_inc_inv_both(any, any, any, any, sink, sink + 1, sink + 2);
    sink[3] = ateb_beta_inc_inv(any, any, any);
}

/* In four ranges of alpha, since the low word of alpha + 1 is small only beside alpha + 1 */
void eva_mean(void)
{
    const vm_real alpha = any;
    if (alpha < VM_C(1e8)) sink[0] = ateb_mean(alpha, any, any);
    else if (alpha < VM_C(1e16)) sink[0] = ateb_mean(alpha, any, any);
    else if (alpha < VM_C(1e24)) sink[0] = ateb_mean(alpha, any, any);
    else sink[0] = ateb_mean(alpha, any, any);
}

void eva_plan_init(void)
{
    ateb_plan p;
    if (ateb_plan_init_to(&p, any, any) == 0) {
        //@ assert length: 2 <= p.length <= ATEB_PLAN_LENGTH && p.length % 2 == 0;
        sink[0] = p.part[0].odd[0] + p.part[1].even[ATEB_PLAN_LENGTH - 1] + p.twice_q.lo + (vm_real)p.twice_alpha;
    }
    ateb_plan_init(&p, any);
}

/* Any plan that ateb_plan_init may make, and many more */
static void any_plan(ateb_plan *p)
{
    int i, j;
    p->quarter.hi = any;
    p->quarter.lo = any;
    p->twice_q.hi = any;
    p->twice_q.lo = any;
#if VM_MANT_DIG > 24
    p->quarter_low = any;
#endif
    for (i = 0; i < 3; i++) p->quarter_parts[i] = any;
    p->per_quarter = any;
    p->longest = any;
    p->change_over = any;
    p->n = any;
    p->g = any;
    p->twice_alpha = any_int;
    p->length = any_int;
    if (p->length < 2 || p->length > ATEB_PLAN_LENGTH || p->length % 2) p->length = 2;
    for (i = 0; i < ATEB_PLAN_LENGTH; i++)
        for (j = 0; j < 2; j++) {
            p->part[j].odd[i] = any;
            p->part[j].even[i] = any;
        }
}

void eva_plan_saca(void)
{
    ateb_plan p;
    any_plan(&p);
    ateb_plan_saca(&p, any, sink, sink + 1);
}

void eva_plan_saca_array(void)
{
    ateb_plan p;
    static vm_real s[70], sa[70], ca[70];
    int i, n = any_int;
    any_plan(&p);
    for (i = 0; i < 70; i++) s[i] = any;
    ateb_plan_saca_array(&p, n > 70 ? 70 : n, s, sa, ca);
}
