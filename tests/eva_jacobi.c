/* For Frama-C's EVA (tests/eva.sh): every public function of jacobi.h with any numbers, NaN and infinities among them. */
#define EVA_HEADER "../jacobi.h"
#include "eva_words.h"

void eva_K_E(void)
{
    sink[0] = jacobi_K(any);
    sink[1] = jacobi_K_m1(any);
    sink[2] = jacobi_E(any);
    sink[3] = jacobi_E_m1(any);
    sink[4] = jacobi_kpK(any);
    sink[5] = jacobi_agm_K(any);
}

void eva_sncndn(void)
{
    jacobi_sncndn(any, any, sink, sink + 1, sink + 2);
    jacobi_sncndn_m1(any, any, sink, sink + 1, sink + 2);
    sink[3] = jacobi_sn(any, any);
    sink[4] = jacobi_cn(any, any);
    sink[5] = jacobi_dn(any, any);
}

void eva_quotients(void)
{
    sink[0] = jacobi_cd(any, any);
    sink[1] = jacobi_sd(any, any);
    sink[2] = jacobi_nd(any, any);
    sink[3] = jacobi_sc(any, any);
    sink[4] = jacobi_dc(any, any);
    sink[5] = jacobi_nc(any, any);
    sink[6] = jacobi_cs(any, any);
    sink[7] = jacobi_ds(any, any);
    sink[0] = jacobi_ns(any, any);
}

void eva_incomplete(void)
{
    sink[0] = jacobi_F(any, any);
    sink[1] = jacobi_F_m1(any, any);
    sink[2] = jacobi_E_incomplete(any, any);
    sink[3] = jacobi_E_incomplete_m1(any, any);
    sink[4] = jacobi_Pi(any, any);
    sink[5] = jacobi_Pi_m1(any, any);
    sink[6] = jacobi_Pi_incomplete(any, any, any);
    sink[7] = jacobi_Pi_incomplete_m1(any, any, any);
}

void eva_D(void)
{
    sink[0] = jacobi_D(any);
    sink[1] = jacobi_D_m1(any);
    sink[2] = jacobi_D_incomplete(any, any);
    sink[3] = jacobi_D_incomplete_m1(any, any);
}

void eva_carlson(void)
{
    sink[0] = jacobi_RF(any, any, any);
    sink[1] = jacobi_RC(any, any);
    sink[2] = jacobi_RD(any, any, any);
    sink[3] = jacobi_RJ(any, any, any, any);
    sink[4] = jacobi_RG(any, any, any);
}

void eva_inverse(void)
{
    sink[0] = jacobi_inverse_sn(any, any);
    sink[1] = jacobi_inverse_sn_m1(any, any);
    sink[2] = jacobi_inverse_cn(any, any);
    sink[3] = jacobi_inverse_cn_m1(any, any);
    sink[4] = jacobi_inverse_dn(any, any);
    sink[5] = jacobi_inverse_dn_m1(any, any);
}

void eva_sncndn_any(void) { jacobi_sncndn_any(any, any, sink, sink + 1, sink + 2); }

void eva_am(void) { sink[0] = jacobi_am(any, any); }
void eva_solve(void)
{
    sink[0] = jacobi_solve_kpK(any);
    sink[1] = jacobi_solve_kpK_m1(any);
    sink[2] = jacobi_solve_K(any);
    sink[3] = jacobi_solve_K_m1(any);
}
void eva_cn_means(void) { jacobi_cn_means(any, sink, sink + 1, sink + 2); }
void eva_agm_sncndn(void) { jacobi_agm_sncndn(any, any, any_int, sink, sink + 1, sink + 2); }

void eva_plan(void)
{
    jacobi_plan p;
    if (jacobi_plan_init(&p, any) == 0) jacobi_plan_sncndn(&p, any, sink, sink + 1, sink + 2);
}

void eva_plan_m1(void)
{
    jacobi_plan p;
    if (jacobi_plan_init_m1(&p, any) == 0) jacobi_plan_sncndn(&p, any, sink, sink + 1, sink + 2);
}

void eva_plan_array(void)
{
    vm_real u[5], sn[5], cn[5], dn[5];
    int i, n = any_int;
    jacobi_plan p;
    for (i = 0; i < 5; i++) u[i] = any;
    if (jacobi_plan_init(&p, any) == 0) jacobi_plan_sncndn_array(&p, n > 5 ? 5 : n, u, sn, cn, dn);
}

/* The internal functions of jacobi.h that torque-free rotation uses, within their bounds: |turns| < 2^13 */
void eva_rotation(void)
{
    const vm_two x = {any, any}, y = {any, any}, z = {any, any};
    vmi_doubled_theta theta = vmi_doubled_direct(any, any, any);
    const vm_real turns = any;
    sink[0] = vmi_carlson_rf(x, y, z).hi;
    sink[1] = vmi_third_kind_ladder(x, y, z).rest.hi;
    if (-8192 < turns && turns < 8192) vmi_sincos_turns(turns, sink + 2, sink + 3);
    vmi_doubled_at(&theta, VM_C(0.25), sink + 4, sink + 5);
}
