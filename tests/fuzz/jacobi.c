/* Fuzz target: jacobi.h. Ranges, symmetries, identities, the inverses, what is outside the domain. */
#include "fuzz.h"

/* m of all kinds: around 0 and 1, far below, and what is refused */
static vm_real draw_m(void)
{
    switch (draw_below(5)) {
    case 0: return draw_in(0, 1);
    case 1: return drawn(1 - (double)draw_log(1e-17, 1));
    case 2: return drawn(-(double)draw_log(1e-20, IS_FLOAT ? 1e37 : 1e300));
    case 3: return draw_in(-30, 1);
    default: return draw_any();
    }
}

/* u of all kinds: next to multiples of K/2, of any size */
static vm_real draw_u(vm_real K)
{
    const int kind = draw_below(4);
    const vm_real scale = is_finite(K) ? K : 1;
    if (kind == 0) return draw_beside(scale / 2 * R((int)draw_byte() - 128));
    if (kind == 1) return drawn((double)(scale * draw_in(-4, 4)));
    if (kind == 2) return draw_signed(IS_FLOAT ? 1e4 : 1e9);
    return draw_any();
}

/* sn, cn, dn of one u by any route, kp = k'. held: u still holds a phase, bounds of the accuracy apply. */
static void check_triple(vm_real sn, vm_real cn, vm_real dn, vm_real m1, double tolerance, int held)
{
    const double kp = sqrt((double)m1), top = larger(1, kp), low = kp < 1 ? kp : 1;
    const double s = (double)sn, c = (double)cn, d = (double)dn;
    HOLDS(is_finite(sn) && is_finite(cn) && is_finite(dn));
    HOLDS(fabs(s) <= 1 && fabs(c) <= 1);
    HOLDS(d >= low * (1 - 2 * EPS) && d <= top * (1 + 2 * EPS));
    if (!held) return;
    HOLDS(fabs(s * s + c * c - 1) <= 3 * tolerance * EPS); /* 2 (|sn| + |cn|) tolerance */
    if (m1 < R(1e15))                                      /* where m itself overflows nothing here */
        HOLDS(fabs(d * d - c * c - (double)m1 * s * s) <= 6 * tolerance * EPS * top * top);
}

static void check_quotients(vm_real u, vm_real m, vm_real K)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    HOLDS(same_bits(jacobi_sn(-u, m), -jacobi_sn(u, m)) && same_bits(jacobi_cn(-u, m), jacobi_cn(u, m)));
    HOLDS(same_bits(jacobi_dn(-u, m), jacobi_dn(u, m)));
    if (!(VM_FABS(u) <= 100 * K)) return;
    HOLDS(close_to(jacobi_sn(u, m), sn, 16) && close_to(jacobi_cn(u, m), cn, 16) &&
          close_to(jacobi_dn(u, m), dn, 16));
    if (m < R(-1e30) || dn < VM_MIN / VM_EPSILON) return; /* products of these next to the ends of the range */
    HOLDS(close_to(jacobi_cd(u, m), cn / dn, 32) && close_to(jacobi_sd(u, m), sn / dn, 32));
    HOLDS(close_to(jacobi_nd(u, m), 1 / dn, 32));
    if (VM_FABS(cn) > VM_MIN / VM_EPSILON) {
        HOLDS(close_to(jacobi_sc(u, m), sn / cn, 32) && close_to(jacobi_dc(u, m), dn / cn, 32));
        HOLDS(close_to(jacobi_nc(u, m), 1 / cn, 32));
    }
    if (VM_FABS(sn) > VM_MIN / VM_EPSILON) {
        HOLDS(close_to(jacobi_cs(u, m), cn / sn, 32) && close_to(jacobi_ds(u, m), dn / sn, 32));
        HOLDS(close_to(jacobi_ns(u, m), 1 / sn, 32));
    }
}

static void check_amplitude(vm_real u, vm_real m, vm_real K)
{
    const vm_real am = jacobi_am(u, m), next = jacobi_am(neighbour(u, 1), m);
    vm_real sn, cn, dn;
    if (VM_FABS(u) / K > VM_MAX / 2 || VM_FABS(u) > VM_MAX / 2) return; /* the amplitude overflows */
    HOLDS(is_finite(am) && same_bits(jacobi_am(-u, m), -am));
    HOLDS(next >= am - 4 * VM_EPSILON * VM_FABS(am));
    if (!(VM_FABS(u) <= 100 * K)) return;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    HOLDS(within(sn, R(sin((double)am)), (8 + 4 * fabs((double)am)) * EPS));
    HOLDS(within(cn, R(cos((double)am)), (8 + 4 * fabs((double)am)) * EPS));
}

static void check_jacobi_plan(vm_real u, vm_real m, vm_real K, int held)
{
    const double top = larger(1, sqrt(1 - (double)m));
    vm_real us[9], sn[9], cn[9], dn[9], s, c, d;
    jacobi_plan p;
    int i;
    STAIN(p);
    if (jacobi_plan_init(&p, m)) {
        HOLDS(!(m <= 1) || !is_finite(m));
        HOLDS(UNTOUCHED(p));
        return;
    }
    for (i = 0; i < 9; i++) us[i] = u + R(i) * (is_finite(K) ? K / 8 : R(0.125));
    jacobi_plan_sncndn_array(&p, 9, us, sn, cn, dn);
    for (i = 0; i < 9; i++) {
        jacobi_plan_sncndn(&p, us[i], &s, &c, &d);
        HOLDS(within(s, sn[i], 4 * EPS) && within(c, cn[i], 4 * EPS) && within(d, dn[i], 4 * EPS * top));
    }
    jacobi_plan_sncndn(&p, u, &s, &c, &d);
    check_triple(s, c, d, 1 - m, 4, held);
    jacobi_sncndn(u, m, sn, cn, dn);
    if (held) HOLDS(within(s, sn[0], 8 * EPS) && within(c, cn[0], 8 * EPS) && within(d, dn[0], 8 * EPS * top));
}

static void check_functions(void)
{
    const vm_real m = draw_m(), K = jacobi_K(m), u = draw_u(K);
    vm_real sn, cn, dn, s, c, d;
    int held;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    if (!(m <= 1) || !is_finite(m) || (!is_finite(u) && m != 1) || is_nan(u)) {
        HOLDS(is_nan(sn) && is_nan(cn) && is_nan(dn));
        HOLDS(is_nan(jacobi_am(u, m)) && is_nan(jacobi_sn(u, m)) && is_nan(jacobi_ds(u, m)));
        if (is_finite(u)) check_jacobi_plan(u, m, K, 0);
        return;
    }
    if (!is_finite(u)) {
        HOLDS(VM_FABS(sn) == 1 && cn == 0 && dn == 0);
        return;
    }
    held = VM_FABS(u) <= (IS_FLOAT ? R(1e4) : R(1e9)) &&
           !(VM_FABS(u) > (IS_FLOAT ? R(131072.) : R(1099511627776.)) * K);
    check_triple(sn, cn, dn, 1 - m, 4, held);
    jacobi_sncndn(-u, m, &s, &c, &d);
    HOLDS(same_bits(s, -sn) && same_bits(c, cn) && same_bits(d, dn));
    if (m >= R(0.5)) { /* 1 - m is exact */
        jacobi_sncndn_m1(u, 1 - m, &s, &c, &d);
        HOLDS(same_bits(s, sn) && same_bits(c, cn) && same_bits(d, dn));
    }
    check_quotients(u, m, K);
    check_amplitude(u, m, K);
    check_jacobi_plan(u, m, K, held);
    if (m < 1 && VM_FABS(u) <= 3 * K) {
        const double top = larger(1, sqrt(1 - (double)m));
        jacobi_agm_sncndn(u, m, 16, &s, &c, &d);
        if (m > R(-1e30)) { /* some 32 eps, and what some eps of u k', made by the descent, moves */
            const double moves = (32 + 4 * fabs((double)u) * top) * EPS;
            HOLDS(within(s, sn, moves) && within(c, cn, moves) && within(d, dn, moves * top));
        }
        jacobi_agm_sncndn(u, m, 1 + draw_below(4), &s, &c, &d);
        HOLDS(is_finite(s) && is_finite(c) && is_finite(d));
    }
}

static void check_m1_functions(void)
{
    const vm_real m1 = MOSTLY(draw_log(IS_FLOAT ? 1e-37 : 1e-300, 1)), u = draw_u(jacobi_K_m1(m1));
    vm_real sn, cn, dn, s, c, d;
    jacobi_plan p;
    jacobi_sncndn_m1(u, m1, &sn, &cn, &dn);
    STAIN(p);
    if (jacobi_plan_init_m1(&p, m1)) {
        HOLDS(UNTOUCHED(p) && (!(m1 >= 0) || !is_finite(m1)));
        HOLDS(is_nan(sn) && is_nan(cn) && is_nan(dn));
        return;
    }
    HOLDS(m1 >= 0 && is_finite(m1));
    if (!is_finite(u)) return;
    check_triple(sn, cn, dn, m1, 4, 0);
    jacobi_plan_sncndn(&p, u, &s, &c, &d);
    check_triple(s, c, d, m1, 4, 0);
    if (VM_FABS(u) <= 100 && m1 <= 1) {
        check_triple(sn, cn, dn, m1, 4, 1);
        HOLDS(within(s, sn, 8 * EPS) && within(c, cn, 8 * EPS) && within(d, dn, 8 * EPS));
    }
}

static void check_integrals(void)
{
    const vm_real m = draw_m(), K = jacobi_K(m), E = jacobi_E(m);
    vm_real C2, C4, C6;
    if (!(m <= 1) || !is_finite(m)) {
        HOLDS(m == -VM_INFINITY ? K == 0 && E == VM_INFINITY : is_nan(K) && is_nan(E));
        HOLDS(is_nan(jacobi_kpK(m)));
        jacobi_cn_means(m, &C2, &C4, &C6);
        HOLDS(is_nan(C2) && is_nan(C4) && is_nan(C6));
        return;
    }
    HOLDS(K > 0 && E >= 1);
    HOLDS(m == 1 ? K > VM_MAX : is_finite(K) && is_finite(E));
    HOLDS(m >= 0 ? E <= K * (1 + 4 * VM_EPSILON) : E >= K * (1 - 4 * VM_EPSILON));
    jacobi_cn_means(m, &C2, &C4, &C6);
    HOLDS(C2 >= 0 && C2 <= 1 && C4 <= C2 * (1 + 16 * VM_EPSILON) && C6 <= C4 * (1 + 16 * VM_EPSILON) && C6 >= 0);
    if (C2 > VM_MIN / VM_EPSILON && C2 * C2 > VM_MIN) HOLDS(C4 >= C2 * C2 * (1 - 24 * VM_EPSILON));
    if (m == 1) return;
    if (m > -VM_MAX / 4) {
        HOLDS(jacobi_K(neighbour(m, -1)) <= K * (1 + 4 * VM_EPSILON));
        HOLDS(jacobi_E(neighbour(m, -1)) >= E * (1 - 4 * VM_EPSILON));
        HOLDS(close_to(jacobi_agm_K(m), K, 12));
    }
    HOLDS(close_to(jacobi_kpK(m), VM_SQRT(1 - m) * K, 8));
    if (m >= R(0.5)) HOLDS(same_bits(jacobi_K_m1(1 - m), K) && same_bits(jacobi_E_m1(1 - m), E));
    if (m > 0 && m < 1) { /* Legendre's relation */
        const double k = (double)K, e = (double)E, k1 = (double)jacobi_K_m1(m), e1 = (double)jacobi_E_m1(m);
        HOLDS(fabs(e * k1 + e1 * k - k * k1 - 1.57079632679489662) <= 6 * EPS * (e * k1 + e1 * k + k * k1));
    }
}

/* an inverse's c, and the round trip by m1, in which both functions are well conditioned */
static void check_solvers(void)
{
    const vm_real c = MOSTLY(draw_log(1e-4, 80));
    const vm_real m = jacobi_solve_kpK(c), m1 = jacobi_solve_kpK_m1(c);
    const vm_real n = jacobi_solve_K(c), n1 = jacobi_solve_K_m1(c);
    if (!(c >= 0) || !is_finite(c)) {
        HOLDS(is_nan(m) && is_nan(m1) && is_nan(n) && is_nan(n1));
        return;
    }
    HOLDS(m <= 1 && m1 >= 0 && n <= 1 && n1 >= 0);
    if (is_finite(m) && is_finite(m1)) HOLDS(within(m + m1, 1, 16 * EPS * larger(1, fabs((double)m))));
    if (is_finite(n) && is_finite(n1)) HOLDS(within(n + n1, 1, 16 * EPS * larger(1, fabs((double)n))));
    if (m1 > VM_MIN && m1 < VM_MAX / 4) {
        HOLDS(close_to(VM_SQRT(m1) * jacobi_K_m1(m1), c, 12));
        HOLDS(jacobi_solve_kpK_m1(neighbour(c, 1)) >= m1 * (1 - 16 * VM_EPSILON));
    }
    if (n1 > VM_MIN && n1 < VM_MAX / 4) {
        HOLDS(close_to(jacobi_K_m1(n1), c, 12));
        HOLDS(jacobi_solve_K_m1(neighbour(c, 1)) <= n1 * (1 + 16 * VM_EPSILON));
    }
}

static void fuzz_jacobi(void)
{
    HOLDS(vm_self_check());
    switch (draw_below(5)) {
    case 0: check_integrals(); break;
    case 1: check_solvers(); break;
    case 2: check_m1_functions(); break;
    default: check_functions();
    }
}
FUZZ_TARGET(jacobi)
