/* ateb.h: every function at random alpha and s, plans of every accuracy, beta functions and their inverses. The
   logarithm, exponential, powers, sine and cosine, by which the other headers go, too. */

static void golden_kernels(void)
{
    int i;
    if (!vm_self_check()) fold_int(0); /* which would be another number */
    for (i = 0; i < COUNT; i++) {
        const vm_real x = uniform(0, 20), y = uniform(-20, 20);
        const vm_two l = vmi_log(x + VM_C(0.001));
        vm_real s, c;
        vmi_sincos(y * 100, &s, &c);
        fold(l.hi);
        fold(l.lo);
        fold(vmi_exp(y, 0));
        fold(vmi_pow_checked(x, y));
        fold(s);
        fold(c);
    }
}

/* alphas of all sizes, those among them whose power is square roots and products */
static vm_real some_alpha(int i)
{
    if (i % 4 == 0) return uniform(0, 1000);
    return i % 4 == 1 ? (vm_real)(i % 13) / 2 : uniform(0, 8);
}

static void try_ateb(void)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const vm_real alpha = some_alpha(i), s = uniform(-100, 100);
        vm_real sa, ca;
        ateb_saca(s, alpha, &sa, &ca);
        fold(sa);
        fold(ca);
        fold(ateb_pi(alpha));
        fold(ateb_phase(sa, ca, alpha));
        if (i % 8 == 0) {
            fold(ateb_sa(s, alpha));
            fold(ateb_ca(s, alpha));
        }
    }
    fold(ateb_pi(-1)); /* outside the domain */
}

static void try_ateb_plans(void)
{
    vm_real s[16], sa[16], ca[16];
    ateb_plan p;
    int i;
    for (i = 0; i < 30; i++) { /* 0, 1/2, ... 7 have powers of their own */
        const vm_real alpha = i % 2 ? some_alpha(i) : (vm_real)i / 4;
        draw_all(16, -30, 30, s);
        fold_int(ateb_plan_init(&p, alpha));
        ateb_plan_saca(&p, s[0], sa, ca);
        fold(sa[0]);
        fold(ca[0]);
        ateb_plan_saca_array(&p, 16, s, sa, ca);
        fold_all(16, sa);
        fold_all(16, ca);
        fold_int(ateb_plan_init(&p, -1)); /* refused: the plan stays */
        ateb_plan_saca(&p, s[1], sa, ca);
        fold(sa[0]);
        fold(ca[0]);
        fold_int(ateb_plan_init_to(&p, alpha, VM_C(1e-4)));
        ateb_plan_saca(&p, s[2], sa, ca);
        fold(sa[0]);
        fold(ca[0]);
    }
}

static void try_ateb_integrals(void)
{
    int i;
    for (i = 0; i < COUNT / 10; i++) {
        const vm_real alpha = uniform(0, 8), n = uniform(VM_C(0.5), 5), s = uniform(-10, 10);
        vm_real sa, ca;
        fold(ateb_integral_sa2(s, alpha));
        fold(ateb_integral_ca(s, alpha));
        fold(ateb_mean(alpha, 2, n));
        fold(ateb_pi_nm(n, alpha));
        ateb_saca_nm(s, n, alpha, &sa, &ca);
        fold(sa);
        fold(ca);
    }
}

static void golden_beta(void)
{
    int i;
    for (i = 0; i < COUNT / 10; i++) {
        const vm_real a = uniform(VM_C(0.1), i % 5 ? 3 : 100), b = i % 2 ? VM_C(0.5) : uniform(VM_C(0.1), 5);
        const vm_real x = uniform(0, 1), small = x * VM_C(1e-6);
        vm_real p, q, ln_x;
        fold(ateb_beta(a, b));
        fold(ateb_beta_inc(x, a, b));
        fold(ateb_beta_inc_inv(x, a, b));
        fold(ateb_ln_beta(a * 1000, b / 1000));
        fold(ateb_ln_beta_inc(small, 100 * a, b));
        fold(ateb_mean_nm(a, b, 2, x, 0));
        ateb_beta_inc_both(1 - small, small, a, b, &p, &q);
        fold(p);
        fold(q);
        ateb_beta_inc_inv_both(1 - small, small, a, b, &p, &q, &ln_x);
        fold(p);
        fold(q);
        fold(ln_x);
    }
}

static void golden_ateb(void) {
try_ateb();
try_ateb_plans();
try_ateb_integrals(); }
