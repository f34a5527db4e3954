/* Fuzz target: jacobi.h's elliptic integrals, their inverses, and m > 1. Ranges, symmetries, periods, inverses,
   order, and what is outside the domain. */
#include "fuzz.h"

/* m of all kinds: around 0 and 1, far below, and what is refused */
static vm_real draw_parameter(void)
{
    switch (draw_below(5)) {
    case 0: return draw_in(0, 1);
    case 1: return drawn(1 - (double)draw_log(IS_FLOAT ? 1e-7 : 1e-16, 1));
    case 2: return drawn(-(double)draw_log(1e-20, IS_FLOAT ? 1e30 : 1e200));
    case 3: return draw_in(-30, 1);
    default: return draw_any();
    }
}

/* An angle: next to multiples of pi/4, small, large, any */
static vm_real draw_angle(void)
{
    const int kind = draw_below(5);
    if (kind == 0) return draw_beside(R(0.785398163397448310) * R((int)draw_byte() - 128));
    if (kind == 1) return draw_in(-1.5, 1.5);
    if (kind == 2) return draw_in(-30, 30);
    if (kind == 3) return draw_signed(IS_FLOAT ? 1e4 : 1e9);
    return draw_any();
}

static int regular(vm_real phi, vm_real m) { return is_finite(phi) && is_finite(m) && m < 1; }

static void check_first_and_second(void)
{
    const vm_real m = draw_parameter(), phi = draw_angle(), F = jacobi_F(phi, m), E = jacobi_E_incomplete(phi, m);
    const vm_real D = jacobi_D_incomplete(phi, m), complete = jacobi_D(m);
    vm_real next;
    if (is_nan(phi) || is_nan(m) || m > 1) {
        HOLDS((is_nan(F) && is_nan(E) && is_nan(D)) || (m > 1 && VM_FABS(phi) < R(1.5708)));
        HOLDS(m <= 1 || is_nan(complete));
        return;
    }
    HOLDS(same_bits(jacobi_D_incomplete(-phi, m), -D) && complete >= 0);
    HOLDS(same_bits(jacobi_F(-phi, m), -F) && same_bits(jacobi_E_incomplete(-phi, m), -E));
    if (!regular(phi, m)) return;
    HOLDS(!is_nan(F) && !is_nan(E) && (phi < 0 ? F <= 0 && E <= 0 : F >= 0 && E >= 0));
    HOLDS(!is_nan(D) && (phi < 0 ? D <= 0 : D >= 0) && VM_FABS(D) <= VM_FABS(F) * (1 + 16 * VM_EPSILON));
    if (m >= R(0.5))
        HOLDS(same_bits(jacobi_D_incomplete_m1(phi, 1 - m), D) && same_bits(jacobi_D_m1(1 - m), complete));
    if (m >= R(0.5))
        HOLDS(same_bits(jacobi_F_m1(phi, 1 - m), F) && same_bits(jacobi_E_incomplete_m1(phi, 1 - m), E));
    if (VM_FABS(phi) > (IS_FLOAT ? R(1e4) : R(1e9))) return;
    HOLDS(m >= 0 ? VM_FABS(E) <= VM_FABS(F) * (1 + 16 * VM_EPSILON)
                 : VM_FABS(E) >= VM_FABS(F) * (1 - 16 * VM_EPSILON));
    HOLDS(F * E <= VM_MAX ? VM_FABS(F) / 4 * VM_FABS(E) >= phi / 4 * phi * (1 - 32 * VM_EPSILON) - VM_MIN
                          : 1); /* Schwarz */
    next = neighbour(phi, 1);
    HOLDS(jacobi_F(next, m) >= F - 16 * VM_EPSILON * VM_FABS(F));
    HOLDS(jacobi_E_incomplete(next, m) >= E - 16 * VM_EPSILON * VM_FABS(E));
    if (m > R(-1e15) && VM_FABS(phi) < 20) { /* the amplitude leads back, but for what an ulp of F moves */
        const double moved = larger(1, sqrt(1 - (double)m));
        HOLDS(within(jacobi_am(F, m), phi, 32 * EPS * (fabs((double)phi) + moved * fabs((double)F))));
    }
}

/* m > 1: E <= phi <= F, D <= F, and Pi is below F for n < 0 and above it for 0 < n < 1 */
static void check_above_one(void)
{
    const vm_real m = MOSTLY(1 + draw_log(IS_FLOAT ? 1e-7 : 1e-15, IS_FLOAT ? 1e30 : 1e200));
    const vm_real share = MOSTLY(draw_in(-1, 1)), n = MOSTLY(draw_byte() & 1 ? draw_in(-3, 1) : -draw_log(1e-9, 1e9));
    const vm_real phi = share / VM_SQRT(m), F = jacobi_F(phi, m), E = jacobi_E_incomplete(phi, m);
    const vm_real D = jacobi_D_incomplete(phi, m), P = jacobi_Pi_incomplete(phi, n, m);
    const vm_real x = VM_FABS(phi), f = VM_FABS(F);
    HOLDS(same_bits(jacobi_F(-phi, m), -F) && same_bits(jacobi_E_incomplete(-phi, m), -E));
    HOLDS(same_bits(jacobi_D_incomplete(-phi, m), -D) && same_bits(jacobi_Pi_incomplete(-phi, n, m), -P));
    if (fuzz.wild || !(m > 1) || !(VM_FABS(share) <= R(0.999))) return; /* next to 1 phi may be outside by rounding */
    HOLDS(is_finite(F) && is_finite(E) && is_finite(D));
    HOLDS(VM_FABS(E) <= x * (1 + 16 * VM_EPSILON) && f >= x * (1 - 16 * VM_EPSILON) && VM_FABS(D) <= f);
    if (VM_FABS(n) <= 1)
        HOLDS(n < 0 ? VM_FABS(P) <= f * (1 + 24 * VM_EPSILON) : VM_FABS(P) >= f * (1 - 24 * VM_EPSILON));
    if (m < 2) {
        HOLDS(same_bits(jacobi_F_m1(phi, 1 - m), F) && same_bits(jacobi_E_incomplete_m1(phi, 1 - m), E));
        HOLDS(same_bits(jacobi_D_incomplete_m1(phi, 1 - m), D) && same_bits(jacobi_Pi_incomplete_m1(phi, n, 1 - m), P));
    }
}

static void check_third(void)
{
    const vm_real m = draw_parameter(), phi = draw_angle();
    const vm_real n = MOSTLY(draw_byte() & 1 ? draw_in(-3, 1) : -draw_log(1e-9, 1e9));
    const vm_real P = jacobi_Pi_incomplete(phi, n, m), complete = jacobi_Pi(n, m);
    if (is_nan(phi) || is_nan(m) || is_nan(n) || m > 1) {
        HOLDS(is_nan(P) || (m > 1 && VM_FABS(phi) < R(1.5708)));
        return;
    }
    HOLDS(same_bits(jacobi_Pi_incomplete(-phi, n, m), -P));
    if (!regular(phi, m) || !is_finite(n)) return;
    if (n > 1) {
        HOLDS(!is_nan(P) || fuzz.wild);
        return;
    }
    if (fuzz.wild) return;
    HOLDS(n == 1 ? complete > VM_MAX : complete > 0 && is_finite(complete));
    HOLDS(phi < 0 ? P <= 0 : P >= 0);
    if (VM_FABS(phi) > (IS_FLOAT ? R(1e4) : R(1e9))) return;
    if (n < 1) { /* the integrand lies between those of n = 0 and 1/(1 - n) times it */
        const vm_real F = VM_FABS(jacobi_F(phi, m)), bound = F / (1 - n), size = VM_FABS(P);
        HOLDS(n < 0 ? size <= F * (1 + 24 * VM_EPSILON) && size >= bound * (1 - 24 * VM_EPSILON)
                    : size >= F * (1 - 24 * VM_EPSILON) && size <= bound * (1 + 24 * VM_EPSILON));
    }
    if (m >= R(0.5)) {
        HOLDS(same_bits(jacobi_Pi_m1(n, 1 - m), complete));
        HOLDS(same_bits(jacobi_Pi_incomplete_m1(phi, n, 1 - m), P));
    }
}

static void check_symmetric(void)
{
    const vm_real x = MOSTLY(draw_log(1e-8, 1e8)), y = MOSTLY(draw_log(1e-8, 1e8)), z = MOSTLY(draw_log(1e-8, 1e8));
    const vm_real p = MOSTLY(draw_log(1e-8, 1e8)), F = jacobi_RF(x, y, z), G = jacobi_RG(x, y, z);
    const vm_real C = jacobi_RC(x, y), D = jacobi_RD(x, y, z), J = jacobi_RJ(x, y, z, p);
    if (!(x >= 0 && y >= 0 && z >= 0)) {
        HOLDS(is_nan(F) && is_nan(G) && is_nan(D) && is_nan(J));
        return;
    }
    HOLDS(!is_nan(G) && G >= 0 && ((x > VM_MAX && y == 0) || C >= 0)); /* R_C(infinity, 0) has no limit */
    if (fuzz.wild || x == 0 || y == 0 || z == 0 || p == 0) return;
    HOLDS(F > 0 && D > 0 && is_finite(F) && is_finite(D) && close_to(jacobi_RF(z, x, y), F, 16));
    HOLDS(close_to(jacobi_RJ(x, y, z, z), D, 24) && close_to(jacobi_RF(x, y, y), C, 16));
    HOLDS(p > 0 ? J > 0 : is_finite(J));
    HOLDS(F * G >= 1 - 64 * VM_EPSILON); /* Schwarz: they are means of f^(-1/2) and f^(1/2) */
    HOLDS(is_finite(jacobi_RC(x, -y)) && is_finite(jacobi_RJ(x, y, z, -p)));
}

static void check_inverses(void)
{
    const vm_real m = draw_parameter(), x = MOSTLY(draw_in(-1, 1)), K = jacobi_K(m);
    const vm_real s = jacobi_inverse_sn(x, m), c = jacobi_inverse_cn(x, m), d = jacobi_inverse_dn(x, m);
    if (!(m <= 1) || !(VM_FABS(x) <= 1)) {
        HOLDS(is_nan(s) && is_nan(c) && (m < 0 || is_nan(d)));
        return;
    }
    HOLDS(same_bits(jacobi_inverse_sn(-x, m), -s) && !is_nan(s) && (m == 1 || !is_nan(c)));
    if (!is_finite(m) || m == 1) return;
    HOLDS(VM_FABS(s) <= K * (1 + 16 * VM_EPSILON) && c >= 0 && c <= 2 * K * (1 + 16 * VM_EPSILON));
    HOLDS(is_nan(d) || (d >= 0 && d <= K * (1 + 16 * VM_EPSILON)));
    HOLDS(within(jacobi_sn(s, m), x, 32 * EPS * larger(1, sqrt(1 - (double)m) * fabs((double)s))));
    HOLDS(within(jacobi_cn(c, m), x, 32 * EPS * larger(1, sqrt(1 - (double)m) * (double)c)));
    if (m >= R(0.5)) {
        HOLDS(same_bits(jacobi_inverse_sn_m1(x, 1 - m), s) && same_bits(jacobi_inverse_cn_m1(x, 1 - m), c));
        HOLDS(same_bits(jacobi_inverse_dn_m1(x, 1 - m), d));
    }
}

static void check_any_m(void)
{
    const vm_real m = MOSTLY(1 + draw_log(1e-6, 1e6)), u = MOSTLY(draw_in(-100, 100));
    vm_real sn, cn, dn, s, c, d;
    jacobi_sncndn_any(u, m, &sn, &cn, &dn);
    jacobi_sncndn_any(-u, m, &s, &c, &d);
    HOLDS(same_bits(s, -sn) && same_bits(c, cn) && same_bits(d, dn));
    if (!is_finite(m) || !is_finite(u) || fuzz.wild) return;
    HOLDS(within(sn * sn + cn * cn, 1, 24 * EPS));
    HOLDS(within(dn * dn + m * sn * sn, 1, 24 * EPS * larger(1, fabs((double)m))));
}

static void fuzz_elliptic(void)
{
    switch (draw_below(6)) {
    case 0: check_first_and_second(); break;
    case 1: check_third(); break;
    case 2: check_symmetric(); break;
    case 3: check_inverses(); break;
    case 4: check_above_one(); break;
    default: check_any_m();
    }
}
FUZZ_TARGET(elliptic)
