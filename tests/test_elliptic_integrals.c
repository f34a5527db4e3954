/* Elliptic integrals, their inverses and Jacobi's functions for m > 1 (jacobi/carlson.h, above_one.h, incomplete.h,
   inverse.h, reciprocal.h) against arbitrary-precision tables, identities, and the limits at the edges of their domains. */
#include "../jacobi.h"
#include "check.h"
#include "precision.h"

/* ---- Tables ---- */

static vm_real F(const vm_real *x) { return jacobi_F(x[0], x[1]); }
static vm_real F_m1(const vm_real *x) { return jacobi_F_m1(x[0], x[1]); }
static vm_real E(const vm_real *x) { return jacobi_E_incomplete(x[0], x[1]); }
static vm_real E_m1(const vm_real *x) { return jacobi_E_incomplete_m1(x[0], x[1]); }
static vm_real D(const vm_real *x) { return jacobi_D_incomplete(x[0], x[1]); }
static vm_real D_m1(const vm_real *x) { return jacobi_D_incomplete_m1(x[0], x[1]); }
static vm_real complete_D(const vm_real *x) { return jacobi_D(x[0]); }
static vm_real complete_D_m1(const vm_real *x) { return jacobi_D_m1(x[0]); }
static vm_real Pi(const vm_real *x) { return jacobi_Pi_incomplete(x[0], x[1], x[2]); }
static vm_real Pi_m1(const vm_real *x) { return jacobi_Pi_incomplete_m1(x[0], x[1], x[2]); }
static vm_real complete_Pi(const vm_real *x) { return jacobi_Pi(x[0], x[1]); }
static vm_real complete_Pi_m1(const vm_real *x) { return jacobi_Pi_m1(x[0], x[1]); }
static vm_real RF(const vm_real *x) { return jacobi_RF(x[0], x[1], x[2]); }
static vm_real RC(const vm_real *x) { return jacobi_RC(x[0], x[1]); }
static vm_real RD(const vm_real *x) { return jacobi_RD(x[0], x[1], x[2]); }
static vm_real RJ(const vm_real *x) { return jacobi_RJ(x[0], x[1], x[2], x[3]); }
static vm_real RG(const vm_real *x) { return jacobi_RG(x[0], x[1], x[2]); }
static vm_real inverse_sn(const vm_real *x) { return jacobi_inverse_sn(x[0], x[1]); }
static vm_real inverse_cn(const vm_real *x) { return jacobi_inverse_cn(x[0], x[1]); }
static vm_real inverse_dn(const vm_real *x) { return jacobi_inverse_dn(x[0], x[1]); }
static vm_real inverse_sn_m1(const vm_real *x) { return jacobi_inverse_sn_m1(x[0], x[1]); }
static vm_real inverse_cn_m1(const vm_real *x) { return jacobi_inverse_cn_m1(x[0], x[1]); }
static vm_real inverse_dn_m1(const vm_real *x) { return jacobi_inverse_dn_m1(x[0], x[1]); }

/* sn, cn or dn (which = 0, 1, 2) for any m */
static vm_real any_of(int which, const vm_real *x)
{
    vm_real value[3];
    jacobi_sncndn_any(x[0], x[1], value, value + 1, value + 2);
    return value[which];
}
static vm_real any_sn(const vm_real *x) { return any_of(0, x); }
static vm_real any_cn(const vm_real *x) { return any_of(1, x); }
static vm_real any_dn(const vm_real *x) { return any_of(2, x); }

/* The functions of the table, with the bound of rows that have a scale, in eps of it: 4 for functions with |f| <= 1,
   16 for principal values */
static const struct {
    const char *name;
    vm_real (*value)(const vm_real *x);
    double bound;
} functions[] = {{"F", F, 4},
                 {"F_m1", F_m1, 4},
                 {"E", E, 4},
                 {"E_m1", E_m1, 4},
                 {"D", D, 4},
                 {"D_m1", D_m1, 4},
                 {"complete D", complete_D, 4},
                 {"complete D_m1", complete_D_m1, 4},
                 {"Pi", Pi, 16},
                 {"Pi_m1", Pi_m1, 16},
                 {"complete Pi", complete_Pi, 4},
                 {"complete Pi_m1", complete_Pi_m1, 4},
                 {"R_F", RF, 4},
                 {"R_C", RC, 4},
                 {"R_D", RD, 4},
                 {"R_J", RJ, 16},
                 {"R_G", RG, 4},
                 {"inverse sn", inverse_sn, 4},
                 {"inverse cn", inverse_cn, 4},
                 {"inverse dn", inverse_dn, 4},
                 {"inverse sn_m1", inverse_sn_m1, 4},
                 {"inverse cn_m1", inverse_cn_m1, 4},
                 {"inverse dn_m1", inverse_dn_m1, 4},
                 {"sn, m > 1", any_sn, 4},
                 {"cn, m > 1", any_cn, 4},
                 {"dn, m > 1", any_dn, 4}};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

typedef struct table_row {
    const char *function, *region;
    double x[4], high, low, scale;
} table_row;

static const table_row table[] = {
#ifdef POINTS
#include "../build/points/elliptic_integrals_table.h"
#else
#include "data/elliptic_integrals_table.h"
#endif
};

/* Is the row one that the type tested can hold, and within the promised range? */
static int row_applies(const table_row *row)
{
    int i;
    for (i = 0; i < 4; i++)
        if (!representable(row->x[i])) return 0;
    if (is_float && fabs(row->x[0]) > 1e4 && row->function[0] != 'R') return 0;
    return fabs(row->high) < (double)VM_MAX;
}

static void check_table_row(const table_row *row)
{
    vm_real x[4];
    int i, f = 0;
    for (i = 0; i < 4; i++) x[i] = R(row->x[i]);
    while (f < FUNCTIONS && strcmp(functions[f].name, row->function) != 0) f++;
    if (f == FUNCTIONS)
        FAIL("no such function");
    else if (row->scale > 0)
        check_error(row->function, row->region, "eps",
                    ERROR_EPS(functions[f].value(x), row->high, row->low, row->scale), functions[f].bound,
                    row->x[0], row->x[1]);
    else
        check_error(row->function, row->region, "ulp", ERROR_ULP(functions[f].value(x), row->high, row->low),
                    functions[f].value == RG ? 10 : 8, row->x[0], row->x[1]);
}

static void test_table(void)
{
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++)
        if (row_applies(table + i)) check_table_row(table + i);
}

/* R_J of arguments more than 1e16 apart, most of which are numbers of float too: x, y, z, p and the value, mpmath's
   elliprj with 40 digits and more, as high and low word */
static const struct {
    double x[4], high, low;
} far_apart[] = {
    {{536870912.0, 6.67572021484375e-06, 21990232555520.0, 0.03125}, 2.4308069907236773e-10, -1.5038551e-26},
    {{2.6645352591003757e-15, 10995116277760.0, 2.086162567138672e-07, 5.0}, 1.6627467606084009e-06, 2.5395531e-23},
    {{246290604621824.0, 5.684341886080801e-13, 1.4551915228366852e-10, 536870912.0}, 7.836425726674167e-15, 2.7605471e-31},
    {{1.1102230246251565e-15, 7.450580596923828e-08, 844424930131968.0, 1.7881393432617188e-07}, 0.7597770187578777, -2.1647138e-17},
    {{3.725290298461914e-08, 655360.0, 85899345920.0, 1879048192.0}, 2.5336040609597445e-14, 5.4831933e-31},
    {{1099511627776.0, 5.587935447692871e-09, 1.9895196601282805e-13, 3.814697265625e-06}, 2.964551659372632, 9.1201179e-17},
    {{1835008.0, 1125899906842624.0, 14.0, 0.0625}, 6.002228607662447e-11, -1.3482583e-27},
    {{1099511627776.0, 9.313225746154785e-09, 939524096.0, 4.470348358154297e-08}, 5.441986901914643e-07, -1.0118836e-23},
    {{4.57763671875e-05, 824633720832.0, 786432.0, 2.2737367544323206e-12}, 5.011635460999148e-06, 3.6496433e-23},
    {{1.3642420526593924e-12, 1879048192.0, 5.820766091346741e-10, 4398046511104.0}, 3.558869086354079e-16, -1.075145e-32},
    {{9.094947017729282e-13, 83886080.0, 393216.0, 3.0}, 4.728797530005259e-07, -5.932165e-24},
    {{256.0, 8589934592.0, 14.0, 3.4924596548080444e-10}, 6.8613454043510696e-06, 2.1639764e-22},
    {{0.8999999761581421, 0.9900000095367432, 390.0, 6.000000090284797e+29}, 9.38981126597611e-31, 2.1861156e-47},
    {{2.0000000063421537e-30, 300000.0, 1.5, 40000.0}, 7.805651360589355e-07, -8.3951127e-24},
    {{1e-200, 2e+100, 3.5, 4e-90}, 8.905578087927944e-06, 7.6584909e-22},
    {{0.8865, 0.75, 396.5, 5.75e+211}, 9.927994100578149e-213, 3.1605368e-229},
    {{0.9995611505508061, 1.1450433083547655, 6.143664376601279e+35, -5.231589129137024e-267}, 1.0968957038186403e-15,
     -1.1456353e-32},
};

static void test_far_apart(void)
{
    size_t i;
    for (i = 0; i < sizeof far_apart / sizeof *far_apart; i++) {
        const double *x = far_apart[i].x;
        if (!representable(x[0]) || !representable(x[3])) continue;
        const vm_real got = jacobi_RJ(R(x[0]), R(x[1]), R(x[2]), R(x[3]));
        check_error("R_J", "beyond 1e16", "ulp", ERROR_ULP(got, far_apart[i].high, far_apart[i].low), 16, x[0], x[3]);
    }
}

/* ---- Identities ---- */

static vm_real some_m(int kind)
{
    if (kind % 3 == 0) return R(uniform(0, 1));
    if (kind % 3 == 1) return R(-pow(10, uniform(-3, by_precision(30, 8))));
    return R(1 - pow(10, uniform(by_precision(-12, -5), -1)));
}

/* F(am u) = u: an error of the angle is multiplied by the slope of F, which is 1/dn */
static void test_amplitude(void)
{
    int i;
    for (i = 0; i < 6000; i++) {
        const vm_real m = some_m(i), K = jacobi_K(m), u = R(uniform(-20, 20)) * K, phi = jacobi_am(u, m);
        const double dn = fabs((double)jacobi_dn(u, m)), moved = fabs((double)phi) / dn / fabs((double)u);
        check_error("F(am u) = u", "|u| < 20 K", "eps",
                    ERROR_EPS(jacobi_F(phi, m), (double)u, 0, fabs((double)u) * (1 + moved)), 16, (double)u,
                    (double)m);
    }
}

/* Each inverse leads back to u: an error of the function's value is divided by its slope */
static void test_round_trips(void)
{
    int i;
    for (i = 0; i < 6000; i++) {
        const vm_real m = some_m(i), K = jacobi_K(m), u = R(uniform(0.01, 0.99)) * K;
        vm_real sn, cn, dn;
        double s, c, d, size = (double)u;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        s = (double)sn;
        c = (double)cn;
        d = (double)dn;
        check_error("sn", "there and back", "eps", ERROR_EPS(jacobi_inverse_sn(sn, m), size, 0, size + s / (c * d)),
                    16, size, (double)m);
        check_error("cn", "there and back", "eps", ERROR_EPS(jacobi_inverse_cn(cn, m), size, 0, size + c / (s * d)),
                    16, size, (double)m);
        check_error("dn", "there and back", "eps",
                    ERROR_EPS(jacobi_inverse_dn(dn, m), size, 0, size + d / fabs((double)m * s * c)), 16, size,
                    (double)m);
        check_error("cn", "beyond K", "eps",
                    ERROR_EPS(jacobi_inverse_cn(-cn, m), 2 * (double)K - size, 0, (double)K + c / (s * d)), 16,
                    size, (double)m);
    }
}

/* Pi(0) = F, Pi(m) and E in closed form, Legendre's relation with R_G, Pi(n) Pi(m/n), and quadratic forms of R_J */
static void test_relations(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real m = R(uniform(0.01, 0.99)), phi = R(uniform(-30, 30)), K = jacobi_K(m), G = jacobi_K_m1(m);
        const double k = (double)K, g = (double)G, e = 2 * (double)jacobi_RG(0, 1 - m, 1),
                     h = 2 * (double)jacobi_RG(0, m, 1);
        const vm_real n = R(-pow(10, uniform(-4, 4))), other = m / n;
        const double s = sin((double)phi), c = cos((double)phi), D = sqrt(1 - (double)m * s * s);
        const double p = (double)jacobi_Pi(n, m), q = (double)jacobi_Pi(other, m), nn = (double)n;
        check_error("Legendre", "R_G", "eps", ERROR_EPS(e * g + h * k - k * g, pi / 2, 0, e * g + h * k + k * g), 8,
                    (double)m, 0);
        check_error("Pi(0) = F", "random", "ulp",
                    ERROR_ULP(jacobi_Pi_incomplete(phi, 0, m), (double)jacobi_F(phi, m), 0), 8, (double)phi,
                    (double)m);
        check_error("Pi(m)", "closed form", "eps",
                    ERROR_EPS((double)jacobi_Pi_incomplete(phi, m, m) * (1 - (double)m),
                              (double)jacobi_E_incomplete(phi, m) - (double)m * s * c / D, 0,
                              1 + fabs((double)phi)),
                    16, (double)phi, (double)m);
        check_error("Pi(n) + Pi(m/n)", "n < 0", "eps", /* DLMF 19.7.8 at pi/2 */
                    ERROR_EPS(p + q, k + pi / 2 * sqrt(nn / ((1 - nn) * (nn - (double)m))), 0, p + q + k), 16, nn,
                    (double)m);
    }
}

/* F, E and Pi are odd to the last bit, and grow by twice the complete integral from phi to phi + pi */
static void test_periods(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real m = some_m(i), n = R(uniform(-3, 0.9)), phi = R(uniform(-1.5, 1.5));
        const vm_real next = R((double)phi + pi);
        const double moved = ULP((double)next), s = sin((double)phi), dn = sqrt(1 - (double)m * s * s);
        const double P = (double)jacobi_Pi(n, m), slip = moved / (1 - (double)n * s * s);
        CHECK(jacobi_F(-phi, m) == -jacobi_F(phi, m) &&
              jacobi_E_incomplete(-phi, m) == -jacobi_E_incomplete(phi, m) &&
              jacobi_Pi_incomplete(-phi, n, m) == -jacobi_Pi_incomplete(phi, n, m));
        check_error("F(phi + pi)", "2 K", "",
                    fabs((double)jacobi_F(next, m) - (double)jacobi_F(phi, m) - 2 * (double)jacobi_K(m)) /
                        (moved / dn + 16 * eps * (double)jacobi_K(m)),
                    1, (double)phi, (double)m);
        check_error("E(phi + pi)", "2 E", "",
                    fabs((double)jacobi_E_incomplete(next, m) - (double)jacobi_E_incomplete(phi, m) -
                         2 * (double)jacobi_E(m)) /
                        (moved * dn + 16 * eps * (double)jacobi_E(m)),
                    1, (double)phi, (double)m);
        check_error(
            "Pi(phi + pi)", "2 Pi", "",
            fabs((double)jacobi_Pi_incomplete(next, n, m) - (double)jacobi_Pi_incomplete(phi, n, m) - 2 * P) /
                (slip / dn + 24 * eps * P),
            1, (double)phi, (double)m);
    }
}

/* Carlson's integrals are homogeneous and symmetric: two orders of the arguments may each have an error, so that
   the bound between them is 12 ulp. A factor of 16 changes no digit, and neither do very large or very
   small arguments. */
static void test_symmetric(void)
{
    const vm_real huge = R(ldexp(1, is_float ? 120 : 1000));
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real x = R(uniform(0, 3)), y = R(uniform(0, 3)), z = R(uniform(0.01, 3)), p = R(uniform(0.01, 3));
        const vm_real rf = jacobi_RF(x, y, z), rd = jacobi_RD(x, y, z), rg = jacobi_RG(x, y, z);
        CHECK(jacobi_RF(huge * x, huge * y, huge * z) == rf / VM_SQRT(huge));
        CHECK(jacobi_RC(huge * x, huge * z) == jacobi_RC(x, z) / VM_SQRT(huge));
        CHECK(jacobi_RD(16 * x, 16 * y, 16 * z) == rd / 64 &&
              jacobi_RG(huge * x, huge * y, huge * z) == VM_SQRT(huge) * rg);
        CHECK(jacobi_RJ(16 * x, 16 * y, 16 * z, 16 * p) == jacobi_RJ(x, y, z, p) / 64);
        CHECK(ERROR_ULP(jacobi_RJ(p, p, p, p), 1 / ((double)p * sqrt((double)p)), 0) <= 6);
        check_error("R_F", "any order", "ulp", ERROR_ULP(jacobi_RF(z, x, y), (double)rf, 0), 12, (double)x,
                    (double)y);
        check_error("R_D", "any order", "ulp", ERROR_ULP(jacobi_RD(y, x, z), (double)rd, 0), 12, (double)x,
                    (double)y);
        check_error("R_G", "any order", "ulp", ERROR_ULP(jacobi_RG(y, z, x), (double)rg, 0), 12, (double)x,
                    (double)y);
        check_error("R_J(z) = R_D", "random", "ulp", ERROR_ULP(jacobi_RJ(x, y, z, z), (double)rd, 0), 12, (double)x,
                    (double)z);
        check_error("R_F(y, y) = R_C", "random", "ulp", ERROR_ULP(jacobi_RF(x, z, z), (double)jacobi_RC(x, z), 0),
                    8, (double)x, (double)z);
    }
}

/* Next to phi = 0 the integrals are phi, and next to pi/2, for m near 1, F grows as a logarithm */
static void test_zeros_and_seams(void)
{
    vm_real phi;
    int i;
    for (phi = R(1e-3); phi > 0; phi *= R(1e-3)) {
        CHECK(VM_FABS(jacobi_F(phi, R(0.5)) / phi - 1) <= phi * phi + 4 * VM_EPSILON);
        CHECK(VM_FABS(jacobi_E_incomplete(phi, R(-2)) / phi - 1) <= phi * phi + 4 * VM_EPSILON);
        CHECK(VM_FABS(jacobi_Pi_incomplete(phi, R(-1), R(0.5)) / phi - 1) <= phi * phi + 4 * VM_EPSILON);
    }
    for (i = 1; i < 40; i++) { /* across pi/4, pi/2, ... the functions stay in order */
        const vm_real seam = R(i * pi / 4), before = seam * (1 - 8 * VM_EPSILON),
                      after = seam * (1 + 8 * VM_EPSILON);
        CHECK(jacobi_F(before, R(0.9)) < jacobi_F(after, R(0.9)) * (1 + 4 * VM_EPSILON));
        CHECK(jacobi_E_incomplete(before, R(-3)) < jacobi_E_incomplete(after, R(-3)) * (1 + 4 * VM_EPSILON));
    }
    check_error("F", "m = 1", "ulp", ERROR_ULP(jacobi_F(R(1.25), 1), asinh(tan(1.25)), 0), 8, 1.25, 1);
    CHECK(jacobi_E_incomplete(R(1.25), 1) <= 1 && jacobi_F(R(1.6), 1) == VM_INFINITY &&
          jacobi_F(-R(1.6), 1) == -VM_INFINITY);
}

/* Pi(n | m) from m and from m1 = 1 - m is the same where 1 - m has no rounding error, for n on each side of the pole. */
static void test_complete_from_m1(void)
{
    static const double ns[] = {-1e6, -2, -0.125, 0, 0.25, 0.875, 1.0625, 1.5, 3, 100, 1e6};
    static const double m1s[] = {0.0625, 0.25, 0.5, 0.75, 1, 1.5, 2, 5, 64};
    int i, k;
    for (i = 0; i < (int)(sizeof ns / sizeof *ns); i++) {
        for (k = 0; k < (int)(sizeof m1s / sizeof *m1s); k++)
            CHECK(jacobi_Pi_m1(R(ns[i]), R(m1s[k])) == jacobi_Pi(R(ns[i]), 1 - R(m1s[k])));
    }
}

/* ---- Limits at infinity, and what is outside the domain ---- */

static int is_nan(vm_real x) { return x != x; }

/* Next to the poles of Pi, n sin^2 phi = 1, Pi is never NaN, although it is infinite at some of these arguments. */
static void check_next_to_pole(vm_real phi, vm_real m, int *infinite)
{
    const vm_real pole = 1 / (VM_LIBM(sin)(phi) * VM_LIBM(sin)(phi));
    int k;
    for (k = -8; k <= 8; k++) {
        const vm_real n = pole * (1 + R(k) * VM_EPSILON), P = jacobi_Pi_incomplete(phi, n, m);
        CHECK(!is_nan(P) && jacobi_Pi_incomplete(-phi, n, m) == -P);
        *infinite += VM_FABS(P) > VM_MAX;
    }
}
static void test_poles(void)
{
    static const double parameters[] = {-3, 0.375, 0.875, 1};
    int i, j, infinite = 0;
    for (i = 0; i < 4; i++)
        for (j = 0; j < 400; j++) {
            const vm_real phi = j < 200 ? VM_PI / 4 * R(2 * j + 1) : R(0.1) + R(0.047) * R(j - 200);
            if (VM_FABS(VM_LIBM(sin)(phi)) > R(0.01)) check_next_to_pole(phi, R(parameters[i]), &infinite);
        }
    CHECK(infinite >= 1000);
    for (j = 1; j < 200; j++) check_next_to_pole(R(0.00125) * R(j), 15, &infinite);
    CHECK(jacobi_Pi_incomplete(2, R(0.5), 1) == VM_INFINITY && jacobi_Pi_incomplete(-2, 3, 1) == VM_INFINITY);
}

/* The square of a number in two words, as one word */
static void test_squared(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real a = R(uniform(0.5, 1));
        const vm_two s = vmi_two(a, a * VM_EPSILON / 4 * R(uniform(-1, 1))), wanted = vmi_two_times(s, s);
        check_error("s^2", "", "ulp", ERROR_ULP(vmi_squared(s), (double)wanted.hi, (double)wanted.lo), 1.01, (double)a, 0);
    }
}

/* The product of numbers in two words that Pi and D are, rounded to one word */
static void test_times_sum(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real a = R(uniform(0.5, 1)), b = R(uniform(0, 3)), c = R(uniform(-1, 3));
        const vm_two s = vmi_two(a, a * VM_EPSILON / 4 * R(uniform(-1, 1)));
        const vm_two first = vmi_two(b, b * VM_EPSILON / 4 * R(uniform(-1, 1)));
        const vm_two second = vmi_two(c, c * VM_EPSILON / 4 * R(uniform(-1, 1)));
        const vm_two wanted = vmi_two_times(s, vmi_two_plus(first, second));
        if (b + c > R(0.5))
            check_error("s (a + b)", "", "ulp", ERROR_ULP(vmi_times_sum(s, first, second), (double)wanted.hi, (double)wanted.lo),
                        1.01, (double)b, (double)c);
    }
}

/* Where x is 1, 0 or k' the inverse is K, with the same bits. */
static void test_inverses_at_the_end(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real m = R(i % 2 ? uniform(0, 1) : 1 - pow(2, uniform(-20, 40))), K = jacobi_K(m), K1 = jacobi_K_m1(1 - m);
        CHECK(jacobi_inverse_sn(1, m) == K && jacobi_inverse_sn(-1, m) == -K && jacobi_inverse_cn(0, m) == K);
        CHECK(jacobi_inverse_sn_m1(1, 1 - m) == K1 && jacobi_inverse_cn_m1(0, 1 - m) == K1);
    }
    CHECK(jacobi_inverse_dn(R(0.5), R(0.75)) == jacobi_K(R(0.75)) && jacobi_inverse_dn(3, -8) == jacobi_K(-8));
    CHECK(jacobi_inverse_dn_m1(R(0.25), R(0.0625)) == jacobi_K_m1(R(0.0625)));
}

static void test_limits(void)
{
    const vm_real inf = VM_INFINITY, half = R(0.5);
    CHECK(jacobi_F(inf, half) == inf && jacobi_F(-inf, half) == -inf && jacobi_F(1, -inf) == 0);
    CHECK(is_nan(jacobi_F(inf, -inf)) && jacobi_F_m1(2, inf) == 0 && jacobi_F(inf, 1) == inf);
    CHECK(jacobi_E_incomplete(inf, half) == inf && jacobi_E_incomplete(-1, -inf) == -inf);
    CHECK(jacobi_E_incomplete(0, -inf) == 0 && jacobi_E_incomplete_m1(-inf, 2) == -inf);
    CHECK(jacobi_D_incomplete(inf, half) == inf && jacobi_D_incomplete(-1, -inf) == 0 && jacobi_D(-inf) == 0);
    CHECK(is_nan(jacobi_D_incomplete(inf, -inf)) && jacobi_D(1) == inf && jacobi_D_m1(0) == inf);
    CHECK(jacobi_D_incomplete(0, -inf) == 0 && jacobi_Pi_incomplete(0, half, -inf) == 0 && jacobi_F(0, -inf) == 0);
    CHECK(jacobi_D_incomplete(-R(1.6), 1) == -inf && jacobi_D_m1(inf) == 0);
    CHECK(jacobi_Pi(-inf, half) == 0 && jacobi_Pi(half, -inf) == 0 && jacobi_Pi(1, half) == inf);
    CHECK(jacobi_Pi(half, 1) == inf && jacobi_Pi(2, 1) == -inf && jacobi_Pi_m1(2, 0) == -inf);
    CHECK(jacobi_Pi_incomplete(inf, half, half) == inf && jacobi_Pi_incomplete(-inf, half, half) == -inf);
    CHECK(jacobi_Pi_incomplete(inf, 2, half) == -inf && jacobi_Pi_incomplete(1, -inf, half) == 0);
    CHECK(jacobi_Pi_incomplete(1, half, -inf) == 0 && jacobi_Pi_incomplete_m1(2, 1, half) == inf);
    CHECK(jacobi_Pi(R(0.99), -VM_MAX) > 0 && jacobi_Pi(R(0.99), -VM_MAX) < R(1e-17));
    CHECK(jacobi_Pi_incomplete(R(1.5707964), R(0.99), -VM_MAX) > 0 && jacobi_Pi_incomplete(2, R(0.3), -VM_MAX) > 0);
    CHECK(jacobi_D_incomplete(2, R(by_precision(-1e300, -1e30))) > 0 && jacobi_Pi_incomplete(2, R(-0.3), -VM_MAX) > 0);
    CHECK(jacobi_inverse_sn(1, 1) == inf && jacobi_inverse_sn(-1, 1) == -inf && jacobi_inverse_cn(0, 1) == inf);
    CHECK(jacobi_inverse_dn(0, 1) == inf && jacobi_inverse_dn_m1(0, 0) == inf && jacobi_inverse_dn(1, 0) == 0);
    CHECK(jacobi_inverse_dn(1 - VM_EPSILON / 2, VM_EPSILON / 2) <= jacobi_K(VM_EPSILON / 2)); /* dn rounds to k' */
    CHECK(jacobi_inverse_sn(half, -inf) == 0 && jacobi_inverse_cn_m1(half, inf) == 0);
    CHECK(jacobi_RF(inf, 1, 2) == 0 && jacobi_RF(0, 0, 1) == inf && is_nan(jacobi_RF(0, 0, inf)));
    CHECK(jacobi_RC(1, 0) == inf && jacobi_RC(1, inf) == 0 && jacobi_RC(inf, -1) == 0);
    CHECK(jacobi_RD(0, 0, 1) == inf && jacobi_RD(1, 2, 0) == inf && jacobi_RD(1, 2, inf) == 0);
    CHECK(jacobi_RJ(1, 2, 3, 0) == inf && jacobi_RJ(1, 2, 3, -inf) == 0 && jacobi_RG(inf, 0, 0) == inf);
    CHECK(jacobi_RJ(0, 0, 1, -1) == -inf && jacobi_RJ(0, 3, 0, -2) == -inf && jacobi_RJ(0, 0, 0, -1) == -inf);
    CHECK(jacobi_RJ(VM_MIN, VM_MIN, 1, -1) < -50 && is_nan(jacobi_RJ(0, 0, 1, -inf)));
    CHECK(jacobi_RG(0, 0, 4) == 1 && jacobi_RG(0, 0, 0) == 0);
}

/* Arguments of Carlson's integrals whose quotients are larger than the largest number: of R_F(y, y, x) and R_C(x, y), two
   elementary functions of one quotient, ln(4 x/y)/(2 sqrt(x)) is left. R_D and R_J refuse them. */
static void test_quotients(void)
{
    const double size = by_precision(1e300, 1e30);
    const vm_real x = R(size), y = R(1 / size);
    const double exact = (log(4.) + log((double)x) - log((double)y)) / (2 * sqrt((double)x));
    int i;
    check_error("R_F", "quotients", "eps", fabs((double)jacobi_RF(y, x, y) / exact - 1) / eps, 8, 0, 0);
    check_error("R_C", "quotients", "eps", fabs((double)jacobi_RC(x, y) / exact - 1) / eps, 8, 0, 0);
    check_error("R_C", "quotients", "eps", fabs((double)jacobi_RC(x, -y) / exact - 1) / eps, 8, 0, 0);
    for (i = 1; i < 8; i += 2) { /* subnormal arguments: R_C(0, y) = pi/(2 sqrt(y)) and R_G(y, y, y) = sqrt(y) */
        const vm_real least = VM_MIN * VM_EPSILON * R(i), large = i < 4 ? 8 : VM_MAX / R(i);
        const double root = sqrt((double)least), logarithm = log(4.) + log((double)large) - log((double)least);
        const vm_real lifted = R(ldexp((double)least, is_float ? 100 : 1000)), lift = R(ldexp(1, is_float ? 50 : 500));
        check_error("R_C", "subnormal", "eps",
                    fabs((double)jacobi_RC(large, least) * 2 * sqrt((double)large) / logarithm - 1) / eps, 8, 0, 0);
        CHECK(jacobi_RF(least, 3 * least, 7 * least) == jacobi_RF(lifted, 3 * lifted, 7 * lifted) * lift);
        check_error("R_C", "subnormal", "eps", fabs((double)jacobi_RC(0, least) * root / (pi / 2) - 1) / eps, 8, 0, 0);
        check_error("R_G", "subnormal", "eps", fabs((double)jacobi_RG(least, least, least) / root - 1) / eps, 8, 0, 0);
    }
    check_error("R_G", "quotients", "eps", fabs((double)(jacobi_RG(y, y, x) / VM_SQRT(x)) - 0.5) / eps, 1, 0, 0);
    CHECK(is_nan(jacobi_RD(y, y, x)) && is_nan(jacobi_RD(x, 1, y)));
    CHECK(is_nan(jacobi_RJ(y, y, x, 1)) && is_nan(jacobi_RJ(1, 1, y, x)) && is_nan(jacobi_RJ(x, 1, 1, -y)));
}

static void test_domain(void)
{
    const vm_real half = R(0.5), bad[3] = {R(1.5), VM_NAN, VM_INFINITY};
    vm_real sn, cn, dn;
    int i;
    for (i = 0; i < 3; i++) {
        const vm_real m = bad[i], m1 = 1 - m; /* negative or NaN */
        CHECK(is_nan(jacobi_F(1, m)) && is_nan(jacobi_F_m1(1, m1)) && is_nan(jacobi_E_incomplete(1, m)));
        CHECK(is_nan(jacobi_E_incomplete_m1(1, m1)) && is_nan(jacobi_Pi(half, m)) &&
              is_nan(jacobi_Pi_m1(half, m1)));
        CHECK(is_nan(jacobi_D(m)) && is_nan(jacobi_D_m1(m1)) && is_nan(jacobi_D_incomplete(1, m)) &&
              is_nan(jacobi_D_incomplete_m1(1, m1)));
        CHECK(is_nan(jacobi_Pi_incomplete(1, half, m)) && is_nan(jacobi_Pi_incomplete_m1(1, half, m1)));
        CHECK(is_nan(jacobi_inverse_sn(half, m)) && is_nan(jacobi_inverse_sn(m, half)));
        CHECK(is_nan(jacobi_inverse_cn(half, m)) && is_nan(jacobi_inverse_cn(m, half)));
        CHECK(is_nan(jacobi_inverse_dn(half, m)) && is_nan(jacobi_inverse_dn(m, half)));
        CHECK(is_nan(jacobi_inverse_sn_m1(half, m1)) && is_nan(jacobi_inverse_cn_m1(half, m1)));
        CHECK(is_nan(jacobi_inverse_dn_m1(half, m1)) && is_nan(jacobi_RF(m1, 1, 2)) && is_nan(jacobi_RG(m1, 1, 2)));
        CHECK(is_nan(jacobi_RC(m1, 1)) && is_nan(jacobi_RD(m1, 1, 2)) && is_nan(jacobi_RJ(1, 2, m1, 3)));
    }
    CHECK(is_nan(jacobi_D_incomplete(VM_NAN, half)) && is_nan(jacobi_D_incomplete(VM_NAN, 2)));
    CHECK(is_nan(jacobi_F(VM_NAN, half)) && is_nan(jacobi_E_incomplete(VM_NAN, half)) &&
          is_nan(jacobi_Pi(VM_NAN, half)));
    CHECK(is_nan(jacobi_Pi_incomplete(VM_NAN, half, half)) && is_nan(jacobi_Pi_incomplete(1, VM_NAN, half)));
    CHECK(is_nan(jacobi_RC(1, VM_NAN)) && is_nan(jacobi_RJ(1, 2, 3, VM_NAN)) &&
          is_nan(jacobi_inverse_cn(-half, 1)));
    jacobi_sncndn_any(1, VM_INFINITY, &sn, &cn, &dn);
    CHECK(is_nan(sn) && is_nan(cn) && is_nan(dn));
    jacobi_sncndn_any(VM_INFINITY, 2, &sn, &cn, &dn);
    CHECK(is_nan(sn) && is_nan(cn) && is_nan(dn));
}

/* m > 1: F leads back to u by the amplitude's sine, (F - E)/m is D, the integrals are odd, they have a value at
   arcsin(1/k), K(1/m)/k for F, and none beyond. Each step of phi there moves F by the slope of F, which is 1/dn. */
static void test_integrals_above_one(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real m = R(1 + pow(10, uniform(by_precision(-12, -5), 3)));
        const double end = atan(1 / sqrt((double)m - 1)); /* arcsin(1/k), exact next to pi/2 too */
        const vm_real phi = R(end * uniform(0.001, 0.98)), n = R(uniform(-3, 1)), beyond = R(end + 8 * eps * (1 + end));
        const vm_real F = jacobi_F(phi, m), E = jacobi_E_incomplete(phi, m), P = jacobi_Pi_incomplete(phi, n, m);
        const double size = (double)phi, slope = 1 / sqrt(1 - (double)m * sin(size) * sin(size));
        vm_real sn, cn, dn;
        jacobi_sncndn_any(F, m, &sn, &cn, &dn);
        check_error("sn(F(phi)) = sin phi", "m > 1", "eps", ERROR_EPS(sn, sin(size), 0, sin(size) * slope), 16, size,
                    (double)m);
        CHECK(E > 0 && E <= phi * (1 + 8 * VM_EPSILON) && F * (1 + 8 * VM_EPSILON) >= phi);
        CHECK(jacobi_F(-phi, m) == -F && jacobi_E_incomplete(-phi, m) == -E && jacobi_Pi_incomplete(-phi, n, m) == -P);
        check_error("D = (F - E)/m", "m > 1", "eps",
                    ERROR_EPS((double)m * (double)jacobi_D_incomplete(phi, m), (double)F - (double)E, 0, (double)F), 16,
                    size, (double)m);
        CHECK(is_nan(jacobi_F(beyond, m)) && is_nan(jacobi_E_incomplete(-beyond, m)) &&
              is_nan(jacobi_D_incomplete(beyond, m)) && is_nan(jacobi_Pi_incomplete(beyond, n, m)));
    }
    for (i = 0; i <= 8; i++) { /* the largest angles for which there are values, for m = 2 and 4 */
        const double end = asin(i % 2 ? 0.5 : sqrt(0.5)), m = i % 2 ? 4 : 2, before = end * (1 - (1 + i) * eps);
        const double slack = sqrt(2 * (1 + i) * eps * end) + 16 * eps;
        const double K = (double)jacobi_K(R(1 / m)) / sqrt(m), F = (double)jacobi_F(R(before), R(m));
        CHECK(F <= K * (1 + 8 * eps) && F >= K - 2 * slack);
    }
    CHECK(is_nan(jacobi_F(VM_NAN, 2)) && is_nan(jacobi_F(VM_INFINITY, 2)) && is_nan(jacobi_F(R(1.6), R(1.0625))));
    CHECK(jacobi_F(0, 2) == 0 && jacobi_E_incomplete(0, 2) == 0 && jacobi_Pi_incomplete(0, 3, 2) == 0);
    CHECK(is_nan(jacobi_Pi_incomplete(R(0.1), VM_INFINITY, 2)) && is_nan(jacobi_Pi_incomplete(R(0.1), VM_NAN, 2)));
}

/* For m <= 1 jacobi_sncndn_any is jacobi_sncndn. For m > 1 its values satisfy the two algebraic equations. */
static void test_any_parameter(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real u = R(uniform(-50, 50)), m = some_m(i), large = R(1 + pow(10, uniform(-6, 3)));
        vm_real sn, cn, dn, s, c, d;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        jacobi_sncndn_any(u, m, &s, &c, &d);
        CHECK(s == sn && c == cn && d == dn);
        jacobi_sncndn_any(u, large, &sn, &cn, &dn);
        check_error("sn^2+cn^2-1", "m > 1", "eps", ERROR_EPS(sn * sn + cn * cn, 1, 0, 1), 12, (double)u,
                    (double)large);
        check_error("dn^2+m sn^2-1", "m > 1", "eps", ERROR_EPS(dn * dn + large * (sn * sn), 1, 0, 1), 12, (double)u,
                    (double)large);
        CHECK(VM_FABS(dn) <= 1 && cn >= 0 && cn <= 1);
    }
}

/* Pi between pi/2 and pi, where the other way to compute it would have an error of 6 ulp: the value is by mpmath. */
static void test_Pi_beyond_quarter(void)
{
    const double phi = 2.874661922454834, n = 0.93713384866714478, m = 0.36673146486282349;
    if (!representable(phi) || !representable(n) || !representable(m)) return;
    check_error("Pi", "beyond pi/2", "ulp",
                ERROR_ULP(jacobi_Pi_incomplete(R(phi), R(n), R(m)), 14.732939788873678, 2.53953e-17), is_float ? 8 : 3, phi, n);
}

/* m > 1 where k u has lost its digits, and where m is next to the largest number: the functions stay within their
   limits, and for u beyond 20/(k eps) they are 0, 1 and 1. */
static void test_any_parameter_far_out(void)
{
    static const double lost[][2] = {{8e15, 2}, {3e16, 2}, {1e15, 40}, {7e7, 2}, {5e6, 900}, {1e8, 2}};
    static const double beyond[][2] = {{1e18, 2},   {-1e18, 2},   {1e100, 2}, {0.5, 1e305}, {1e300, 1e20},
                                       {1e302, 4}, {1e12, 2}, {-2e30, 3}, {0.5, 1e35}, {1e38, 1e38}};
    const vm_real unit = R(ldexp(1, is_float ? 58 : 507)); /* the root of an m next to the largest number */
    vm_real sn, cn, dn;
    int i, k;
    for (i = 0; i < (int)(sizeof lost / sizeof *lost); i++)
        for (k = 0; k < 100; k++) {
            const vm_real u = R(lost[i][0] * (1 + 0.01 * k)), m = R(lost[i][1]);
            jacobi_sncndn_any(u, m, &sn, &cn, &dn);
            CHECK(fabs((double)sn) * sqrt((double)m) <= 1 + 4 * eps && cn >= 0 && cn <= 1 && VM_FABS(dn) <= 1);
        }
    for (i = 0; i < (int)(sizeof beyond / sizeof *beyond); i++) {
        if (is_float && (fabs(beyond[i][0]) > 3e38 || beyond[i][1] > 3e38)) continue;
        if (fabs(beyond[i][0]) < 20.001 / eps / sqrt(beyond[i][1])) continue;
        jacobi_sncndn_any(R(beyond[i][0]), R(beyond[i][1]), &sn, &cn, &dn);
        CHECK(sn == 0 && cn == 1 && dn == 1);
    }
    jacobi_sncndn_any(1 / unit, unit * unit, &sn, &cn, &dn); /* k u = 1, and 1/m is almost 0 */
    check_error("any sn, cn, dn", "huge m", "eps", ERROR_EPS(sn * unit, 0.8414709848078965, 0, 1), 4, 1, 0);
    check_error("any sn, cn, dn", "huge m", "eps", ERROR_EPS(cn, 1, 0, 1), 4, 1, 1);
    check_error("any sn, cn, dn", "huge m", "eps", ERROR_EPS(dn, 0.5403023058681398, 0, 1), 4, 1, 2);
}

/* R_J for p < 0, with |p| or z much larger than the other arguments: the error is measured by R_J(x, y, z, |p|). */
static void test_RJ_principal_far_apart(void)
{
    static const double rows[][6] = {
        {1, 2, 3, -1e210, -2.1808378064067248e-210, 2.1808378064067248e-210},
        {1, 2, 3, -1e300, -2.1808378064067245e-300, 2.1808378064067245e-300},
        {1, 2, 1e200, -3, -2.4866451345004956e-101, 7.0442142160255171e-101},
        {0, 2, 1e200, -3, -7.9916574037795524e-101, 1.1405189944514195e-100},
        {1, 2, 1e160, -3, -2.4866451345004956e-81, 7.0442142160255170e-81},
        {1, 2, 3, -9.9999994421196898e+27, -2.1808379280713786e-28, 2.1808379280713315e-28},
        {1, 2, 1.0000000150474662e+30, -3, -2.4866451157916414e-16, 7.0442141630267299e-16},
        {1, 2, 9.9999997781963084e+21, -3, -2.4866451620778496e-12, 7.0442142941471542e-12}};
    int i;
    for (i = 0; i < (int)(sizeof rows / sizeof *rows); i++) {
        const double *x = rows[i];
        if (!representable(x[2]) || !representable(x[3])) continue;
        check_error("R_J, p < 0", "far apart", "eps",
                    ERROR_EPS(jacobi_RJ(R(x[0]), R(x[1]), R(x[2]), R(x[3])), x[4], 0, x[5]), 16, x[2], x[3]);
    }
}

/* R_C for y < 0 and an x so small that R_C is sqrt(x)/|y| */
static void test_RC_of_small(void)
{
    static const double rows[][2] = {{1e-300, -1e15}, {1e-300, -1e40}, {1e-30, -1e10}, {4e-38, -3e5}, {1e-20, -1e18}};
    int i;
    for (i = 0; i < (int)(sizeof rows / sizeof *rows); i++) {
        const vm_real x = R(rows[i][0]), y = R(rows[i][1]);
        if (x == 0 || !VM_IS_FINITE(y)) continue;
        check_error("R_C, y < 0", "small x", "ulp", ERROR_ULP(jacobi_RC(x, y), sqrt((double)x) / -(double)y, 0), 8,
                    rows[i][0], rows[i][1]);
    }
}

/* The inverses of cn and dn for m = 1 and next to it, at values so small that their squares underflow */
static void test_inverses_of_tiny(void)
{
    static const double at_1[][3] = {{1e-160, 369.10676205960726, -8.1632155e-15},
                                     {1e-170, 392.13261298954774, -2.6315892e-14},
                                     {1e-300, 691.46867507877369, -3.5037511e-14},
                                     {9.9999996826552254e-22, 49.047434165169385, -2.1736517e-15},
                                     {1.0000000195414814e-25, 58.257774485869604, 2.6135496e-15},
                                     {9.9999999109757897e-38, 85.888795630242058, -9.6260908e-16}};
    static const double cn[][4] = {{-7.8e-163, 6.9e-322, 371.1651625183402, 1.8521154e-14},
                                   {7.8e-163, 6.9e-322, 371.10585570267153, -8.8332805e-15},
                                   {1e-158, 1e-318, 364.49910119998066, 1.6349863e-14},
                                   {-3.0000001572320573e-23, 1.9618178500547439e-44, 51.918812320053611, 5.87e-16}};
    static const double dn[][4] = {{1e-160, 5e-321, 369.26510693775475, -6.6097771e-15},
                                   {1e-159, 3e-319, 366.8893759488742, 1.0463825e-15},
                                   {1.000000031374395e-22, 5.6051938572992683e-45, 51.53458324399265, 7.7356209e-16}};
    int i;
    for (i = 0; i < (int)(sizeof at_1 / sizeof *at_1); i++) {
        const double *x = at_1[i];
        if (!representable(x[0])) continue;
        check_error("inverse_cn", "m = 1, tiny x", "ulp", ERROR_ULP(jacobi_inverse_cn(R(x[0]), 1), x[1], x[2]), 8,
                    x[0], 1);
        check_error("inverse_dn", "m = 1, tiny x", "ulp", ERROR_ULP(jacobi_inverse_dn(R(x[0]), 1), x[1], x[2]), 8,
                    x[0], 1);
    }
    for (i = 0; i < (int)(sizeof cn / sizeof *cn); i++) {
        const double *x = cn[i];
        if (!representable(x[0]) || !representable(x[1])) continue;
        check_error("inverse_cn_m1", "tiny x and m1", "ulp",
                    ERROR_ULP(jacobi_inverse_cn_m1(R(x[0]), R(x[1])), x[2], x[3]), 8, x[0], x[1]);
    }
    for (i = 0; i < (int)(sizeof dn / sizeof *dn); i++) {
        const double *x = dn[i];
        if (!representable(x[0]) || !representable(x[1])) continue;
        check_error("inverse_dn_m1", "tiny x and m1", "ulp",
                    ERROR_ULP(jacobi_inverse_dn_m1(R(x[0]), R(x[1])), x[2], x[3]), 8, x[0], x[1]);
    }
}

int main(void)
{
    test_table();
    test_far_apart();
    test_amplitude();
    test_round_trips();
    test_relations();
    test_periods();
    test_symmetric();
    test_zeros_and_seams();
    test_complete_from_m1();
    test_poles();
    test_squared();
    test_times_sum();
    test_inverses_at_the_end();
    test_limits();
    test_quotients();
    test_domain();
    test_any_parameter();
    test_integrals_above_one();
    test_Pi_beyond_quarter();
    test_any_parameter_far_out();
    test_RJ_principal_far_apart();
    test_RC_of_small();
    test_inverses_of_tiny();
    return check_finish("integrals");
}
