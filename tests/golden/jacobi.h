/* jacobi.h: every function at random u and m, also by m1 = 1 - m, plans, arrays, inverses */

static void fold_three(vm_real sn, vm_real cn, vm_real dn) {
fold(sn);
fold(cn);
fold(dn); }

static void fold_quotients(vm_real u, vm_real m)
{
    fold(jacobi_sn(u, m));
    fold(jacobi_cn(u, m));
    fold(jacobi_dn(u, m));
    fold(jacobi_cd(u, m));
    fold(jacobi_sd(u, m));
    fold(jacobi_nd(u, m));
    fold(jacobi_sc(u, m));
    fold(jacobi_dc(u, m));
    fold(jacobi_nc(u, m));
    fold(jacobi_cs(u, m));
    fold(jacobi_ds(u, m));
    fold(jacobi_ns(u, m));
    fold(jacobi_am(u, m));
}

static void try_jacobi(void)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const vm_real m = i % 3 ? uniform(-2, 1) : -uniform(0, 1000), u = uniform(-30, 30);
        const vm_real m1 = uniform(0, i % 2 ? VM_C(1e-6) : 3);
        vm_real s, c, d;
        jacobi_sncndn(u, m, &s, &c, &d);
        fold_three(s, c, d);
        jacobi_sncndn_m1(u, m1, &s, &c, &d);
        fold_three(s, c, d);
        jacobi_sncndn(1000 * u, m, &s, &c, &d);
        fold_three(s, c, d);
        if (i % 4 == 0) fold_quotients(u, m);
    }
    fold(jacobi_sn(1, 2)); /* outside the domain */
}

static void try_jacobi_plans(void)
{
    vm_real us[5], s[5], c[5], d[5];
    int i, k;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real m = i % 3 ? uniform(-2, 1) : -uniform(0, 1000), m1 = uniform(0, i % 2 ? VM_C(1e-6) : 3);
        jacobi_plan p;
        for (k = 0; k < 5; k++) us[k] = uniform(-30, 30);
        fold_int(jacobi_plan_init(&p, m));
        jacobi_plan_sncndn(&p, us[0], s, c, d);
        fold_three(s[0], c[0], d[0]);
        jacobi_plan_sncndn_array(&p, 5, us, s, c, d);
        for (k = 0; k < 5; k++) fold_three(s[k], c[k], d[k]);
        fold_int(jacobi_plan_init(&p, 2)); /* refused: the plan stays */
        jacobi_plan_sncndn(&p, us[1], s, c, d);
        fold_three(s[0], c[0], d[0]);
        fold_int(jacobi_plan_init_m1(&p, m1));
        jacobi_plan_sncndn(&p, us[2], s, c, d);
        fold_three(s[0], c[0], d[0]);
    }
}

static void try_jacobi_integrals(void)
{
    int i;
    for (i = 0; i < COUNT / 2; i++) {
        const vm_real m = i % 3 ? uniform(-2, 1) : -uniform(0, 1000), m1 = uniform(0, i % 2 ? VM_C(1e-6) : 3);
        const vm_real u = uniform(-2, 2), k = uniform(0, 10);
        vm_real s, c, d;
        fold(jacobi_K(m));
        fold(jacobi_E(m));
        fold(jacobi_K_m1(m1));
        fold(jacobi_E_m1(m1));
        fold(jacobi_kpK(m));
        fold(jacobi_solve_kpK(k));
        fold(jacobi_solve_kpK_m1(k));
        fold(jacobi_solve_K(k));
        fold(jacobi_solve_K_m1(k));
        jacobi_cn_means(m, &s, &c, &d);
        fold_three(s, c, d);
        jacobi_agm_sncndn(u, m, 1 + i % 9, &s, &c, &d);
        fold_three(s, c, d);
        fold(jacobi_agm_K(m));
    }
}

static void golden_jacobi(void) {
try_jacobi();
try_jacobi_plans();
try_jacobi_integrals(); }
