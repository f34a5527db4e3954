/* jacobi.h: incomplete elliptic integrals, Pi, Carlson's integrals, inverses of sn, cn, dn, and m > 1 */

static void try_elliptic_integrals(void)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const vm_real m = i % 3 ? uniform(-2, 1) : -uniform(0, 1000), m1 = uniform(0, i % 2 ? VM_C(1e-6) : 3);
        const vm_real phi = uniform(-20, 20), n = uniform(-3, i % 5 ? 1 : 4);
        fold(jacobi_F(phi, m));
        fold(jacobi_F_m1(phi, m1));
        fold(jacobi_F(1000 * phi, m));
        fold(jacobi_E_incomplete(phi, m));
        fold(jacobi_E_incomplete_m1(phi, m1));
        fold(jacobi_Pi(n, m));
        fold(jacobi_Pi_m1(n, m1));
        fold(jacobi_Pi_incomplete(phi, n, m));
        fold(jacobi_Pi_incomplete_m1(phi, n, m1));
        fold(jacobi_D(m));
        fold(jacobi_D_m1(m1));
        fold(jacobi_D_incomplete(phi, m));
        fold(jacobi_D_incomplete_m1(phi, m1));
    }
    fold(jacobi_F(1, 2)); /* outside the domain */
}

static void try_integrals_above_one(void)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const vm_real m = i % 2 ? uniform(1, 2) : uniform(1, 1000), n = uniform(-3, 4);
        const vm_real phi = uniform(-1, 1) / VM_SQRT(m);
        fold(jacobi_F(phi, m));
        fold(jacobi_E_incomplete(phi, m));
        fold(jacobi_D_incomplete(phi, m));
        fold(jacobi_Pi_incomplete(phi, n, m));
        fold(jacobi_F_m1(phi, 1 - m));
    }
}

static void try_carlson(void)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const vm_real x = uniform(0, 2), y = uniform(0, i % 4 ? 2 : 1000), z = uniform(VM_C(0.001), 2), p = uniform(-1, 3);
        fold(jacobi_RF(x, y, z));
        fold(jacobi_RC(x, p));
        fold(jacobi_RD(x, y, z));
        fold(jacobi_RJ(x, y, z, p));
        fold(jacobi_RG(x, y, z));
    }
}

static void try_inverses(void)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const vm_real m = i % 3 ? uniform(-2, 1) : -uniform(0, 1000), m1 = uniform(0, i % 2 ? VM_C(1e-6) : 3);
        const vm_real x = uniform(-1, 1), share = uniform(0, 1), u = uniform(-30, 30), large = uniform(1, 50);
        vm_real s, c, d;
        fold(jacobi_inverse_sn(x, m));
        fold(jacobi_inverse_cn(x, m));
        fold(jacobi_inverse_dn(1 + share * (VM_SQRT(1 - m) - 1), m));
        fold(jacobi_inverse_sn_m1(x, m1));
        fold(jacobi_inverse_cn_m1(x, m1));
        fold(jacobi_inverse_dn_m1(1 + share * (VM_SQRT(m1) - 1), m1));
        jacobi_sncndn_any(u, large, &s, &c, &d);
        fold_three(s, c, d);
    }
}

static void golden_elliptic(void)
{
    try_elliptic_integrals();
    try_carlson();
    try_inverses();
    try_integrals_above_one();
}
