/* ateb.h against arbitrary-precision tables, identities, closed forms and the edges of its domain. */
#include "../ateb.h"
#include "../jacobi.h"
#include "check.h"
#include "least_powers.h"
#include <stdlib.h>

typedef struct ateb_row {
    const char *region;
    double s, alpha, sa, sa_low, ca, ca_low, pi, pi_low;
} ateb_row;

static const ateb_row ateb_table[] = {
#ifdef POINTS /* a longer one: make points */
#include "../build/points/ateb_table.h"
#else
#include "data/ateb_table.h"
#endif
};

/* Pi_alpha in two words is known to a relative error of 2^-100 (float 2^-42), in three, for alpha < 5e8 (2e4), to
   2^-125 (2^-58), which moves the zeros; Pi(n, m) in two words is known to 2^-102 (float 2^-44) */
#ifdef VM_USE_FLOAT
static const double pi_error = 2.3e-13, pi_nm_error = 5.7e-14, finest_pi_error = 3.5e-18, largest_of_three = 2e4;
#else
static const double pi_error = 7.9e-31, pi_nm_error = 2e-31, finest_pi_error = 2.4e-38, largest_of_three = 5e8;
#endif

/* The relative error of the zeros of ateb_saca, and of those of a plan, which in float has Pi_alpha in two words */
static double zeros_error(double alpha) { return alpha < largest_of_three ? finest_pi_error : pi_error; }
static double plan_zeros_error(double alpha) { return PRECISION[0] == 'f' ? pi_error : zeros_error(alpha); }

static void check_pi_two_words(const ateb_row *row)
{
    vmi_ateb c;
    vm_two quarter;
    vmi_ateb_constants(&c, (vm_real)row->alpha);
    quarter = vmi_ateb_fine_quarter(&c);
    check_error("Pi, two words", "", "bound",
                fabs((2 * (double)quarter.hi - row->pi) + (2 * (double)quarter.lo - row->pi_low)) / row->pi /
                    pi_error,
                1, row->alpha, 0);
}

/* Pi by a table of 33 cells serves for |s| <= 128 (alpha + 1) but within |s|/(1024 (alpha + 1)) of the zeros: what is
   right to 2^-66 (float 2^-36) and an ulp of its low word, below 2^-11, leaves less than an ulp of sa and ca there,
   also at the cells' edges. */
static void check_cells(const ateb_row *row, vm_real sa, vm_real ca)
{
    const double unit = PRECISION[0] == 'f' ? 6e-12 : 1.4e-20; /* 2^-37, enough for float, and 2^-66 */
    vmi_ateb c;
    vmi_ateb_constants(&c, (vm_real)row->alpha);
    check_error("Pi, short", row->region, "2^-66",
                fabs((2 * (double)c.quarter.hi - row->pi) + (2 * (double)c.quarter.lo - row->pi_low)) / unit /
                    (2 + row->pi / 16),
                1, row->alpha, 0);
    if (fabs(row->sa) < fabs(row->ca))
        check_error("sa", "next to 0", "ulp", ERROR_ULP(sa, row->sa, row->sa_low), 2, row->s, row->alpha);
    else check_error("ca", "next to 0", "ulp", ERROR_ULP(ca, row->ca, row->ca_low), 2, row->s, row->alpha);
}

static void test_table(void)
{
    size_t i;
    for (i = 0; i < sizeof ateb_table / sizeof *ateb_table; i++) {
        const ateb_row *row = ateb_table + i;
        vm_real sa, ca;
        double sa_moved, ca_moved;
        if (!representable(row->s) || !representable(row->alpha)) continue;
        ateb_saca((vm_real)row->s, (vm_real)row->alpha, &sa, &ca);
        CHECK(ateb_sa((vm_real)row->s, (vm_real)row->alpha) == sa);
        CHECK(ateb_ca((vm_real)row->s, (vm_real)row->alpha) == ca);
        check_error("sa", row->region, "eps", ERROR_EPS(sa, row->sa, row->sa_low, 1), 4, row->s, row->alpha);
        check_error("ca", row->region, "eps", ERROR_EPS(ca, row->ca, row->ca_low, 1), 4, row->s, row->alpha);
        check_error("Pi", "", "ulp", ERROR_ULP(ateb_pi((vm_real)row->alpha), row->pi, row->pi_low), 1, row->alpha,
                    0);
        check_pi_two_words(row);
        if (!strcmp(row->region, "cells of Pi")) check_cells(row, sa, ca);
        if (fabs(row->s) > 100 * row->pi) continue;
        sa_moved = zeros_error(row->alpha) * fabs(row->s);
        ca_moved = 2 / (row->alpha + 1) * sa_moved / ULP(row->ca);
        sa_moved /= ULP(row->sa);
        check_error("sa", row->region, "ulp", ERROR_ULP(sa, row->sa, row->sa_low) - sa_moved, 8, row->s,
                    row->alpha);
        check_error("ca", row->region, "ulp", ERROR_ULP(ca, row->ca, row->ca_low) - ca_moved, 8, row->s,
                    row->alpha);
    }
}

typedef struct elementary_row {
    double x, y, log, log_low, exp, exp_low, pow, pow_low;
} elementary_row;

static const elementary_row elementary_table[] = {
#include "data/elementary_table.h"
};

/* The bounds that tests/proof proves: of ln x and e^y in two words, relative; of g in two words, absolute; of the others in
   ulps */
#ifdef VM_USE_FLOAT
static const double log_unit = 2.3283e-10, exp_unit = 3.0258e-9, g_unit = 8.2318e-11; /* 2^-32, 2^-28.3, 2^-33.5 */
#else
static const double log_unit = 4.7192e-20, exp_unit = 6.9389e-18, g_unit = 1.5332e-19; /* 2^-64.2, 2^-57, 2^-62.5 */
#endif
static const double exp_ulp = 0.545, pow_ulp = 0.9, sine_ulp = 0.94, cosine_ulp = 0.95;
static const double pow_two_ulp = 2.7; /* not proved; from the comment of vmi_pow_two, where x has a low word and is close to 1 */

/* Where the kernels' errors are largest: the first column says whether the point is one of float. */
typedef struct kernel_point {
    int single;
    const char *kernel;
    double hi, lo, y, value, value_low;
} kernel_point;

static const kernel_point kernel_points[] = {
#include "data/kernel_points.h"
};

/* Relative errors are measured in units of the bounds; values of float need no low word. */
static void check_kernel_point(const kernel_point *point)
{
    const vm_two x = vmi_two((vm_real)point->hi, (vm_real)point->lo);
    const double value = point->value, low = point->value_low;
    vm_real sine, cosine, p, p_lo;
    vmi_ateb c;
    vm_two l;
    int k;
    if (strcmp(point->kernel, "pow") == 0)
        check_error("pow", "worst", "ulp", ERROR_ULP(vmi_pow_two(x, vmi_two((vm_real)point->y, 0)), value, low), pow_ulp,
                    point->hi, point->y);
    if (strcmp(point->kernel, "pow_two") == 0)
        check_error("pow", "x in two words", "ulp", ERROR_ULP(vmi_pow_two(x, vmi_two((vm_real)point->y, 0)), value, low),
                    pow_two_ulp, point->hi, point->y);
    if (strcmp(point->kernel, "log") == 0) {
        l = vmi_log(x.hi);
        check_error("ln", "worst", "bound", fabs(((double)l.hi - value) + ((double)l.lo - low)) / fabs(value) / log_unit,
                    1, point->hi, 0);
    }
    if (strcmp(point->kernel, "exp") == 0) {
        check_error("exp", "worst", "ulp", ERROR_ULP(vmi_exp(x.hi, x.lo), value, low), exp_ulp, point->hi, point->lo);
        p = vmi_exp_core(x.hi, x.lo, &k, &p_lo);
        check_error("exp in two words", "worst", "bound",
                    fabs((((1 - ldexp(value, -k)) + (double)p) + (double)p_lo) - ldexp(low, -k)) / ldexp(value, -k) /
                        exp_unit,
                    1, point->hi, point->lo);
    }
    if (strcmp(point->kernel, "g") == 0) {
        vmi_ateb_index_constants(&c, x.hi);
        l = vmi_ateb_g(c.q);
        check_error("g", "worst", "bound", fabs(((double)l.hi - value) + ((double)l.lo - low)) / g_unit, 1, point->hi, 0);
    }
    vmi_sin_cos(x, &sine, &cosine);
    if (strcmp(point->kernel, "sine") == 0)
        check_error("sine", "worst", "ulp", ERROR_ULP(sine, value, low), sine_ulp, point->hi, point->lo);
    if (strcmp(point->kernel, "cosine") == 0)
        check_error("cosine", "worst", "ulp", ERROR_ULP(cosine, value, low), cosine_ulp, point->hi, point->lo);
}

static void test_kernel_points(void)
{
    size_t i;
    for (i = 0; i < sizeof kernel_points / sizeof *kernel_points; i++)
        if (kernel_points[i].single == (PRECISION[0] == 'f')) check_kernel_point(kernel_points + i);
}

/* The one x for which the reduction is not exact in two words: the number just below half a quarter period, where the
   quarter period is a power of two. The number below that x and the half itself are reduced exactly. */
static void test_reduction(void)
{
    const vm_real half = VM_C(0.5), below = half - VM_EPSILON / 4, lower = below - VM_EPSILON / 4;
    const vm_two one = vmi_two(1, 0);
    vm_two r;
    int quarter;
    r = vmi_reduce(lower, one, &quarter);
    CHECK(quarter == 0 && r.hi == lower && r.lo == 0);
    r = vmi_reduce(below, one, &quarter);
    CHECK(VM_FABS((r.hi + (vm_real)quarter) - half) <= VM_EPSILON / 4 && r.lo == 0);
    r = vmi_reduce(half, one, &quarter);
    CHECK(quarter == 1 && r.hi == -half && r.lo == 0);
}

/* A number is split into a power of two and a factor next to 1 without rounding. */
static void test_mantissa(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real x = (vm_real)ldexp(uniform(1, 2), i % 200 - 100);
        vm_real k;
        const vm_real z = vmi_ateb_mantissa(x, &k);
        CHECK(ldexp((double)z, (int)k) == (double)x && (double)z > 0.70710678 && (double)z < 1.41421357);
    }
}

/* The kernels: ln x in two words, e^y, x^y; underflow, overflow, NaN. */
static void test_elementary(void)
{
    size_t i;
    int k;
    for (i = 0; i < sizeof elementary_table / sizeof *elementary_table; i++) {
        const elementary_row *row = elementary_table + i;
        const vm_real x = (vm_real)row->x, y = (vm_real)row->y;
        vm_two l;
        if (!representable(row->x) || !representable(row->y)) continue;
        l = vmi_log(x);
        check_error("ln", "", "bound",
                    fabs(((double)l.hi - row->log) + ((double)l.lo - row->log_low)) / fabs(row->log) / log_unit, 1,
                    row->x, 0);
        check_error("exp", "", "ulp", ERROR_ULP(vmi_exp(y, 0), row->exp, row->exp_low), exp_ulp, row->y,
                    0);
        if (row->pow != 0)
            check_error("pow", "", "ulp",
                        ERROR_ULP(vmi_pow_two(vmi_two(x, 0), vmi_two(y, 0)), row->pow, row->pow_low), pow_ulp,
                        row->x, row->y);
    }
    for (k = -(VMI_BIAS + VM_MANT_DIG - 2); k <= VMI_BIAS; k++) { /* exact, subnormal numbers too */
        vm_two l = vmi_log(vmi_ldexp(1, k));
        CHECK((double)vmi_ldexp(1, k) == ldexp(1, k));
        check_error("ln", "2^k", "eps*",
                    fabs((double)l.hi - k * 0.69314718055994530942) / (1 + abs(k)) / (double)VM_EPSILON, 1, k, 0);
        CHECK(vmi_exp(l.hi, l.lo) == vmi_ldexp(1, k));
    }
    check_least_powers();
    CHECK(vmi_exp(VM_INFINITY, 0) == VM_INFINITY && vmi_exp(VM_MAX, 0) == VM_INFINITY);
    CHECK(vmi_exp(-VM_INFINITY, 0) == 0 && vmi_exp(-VM_MAX, 0) == 0 && vmi_exp(0, 0) == 1);
    CHECK(vmi_exp(VM_NAN, 0) != vmi_exp(VM_NAN, 0));
    CHECK(vmi_ldexp(1, 30000) == VM_INFINITY && vmi_ldexp(1, -30000) == 0);
    CHECK(vmi_copysign(2, VM_C(-0.0)) == -2 && vmi_copysign(-2, 0) == 2 && vmi_copysign(-2, 3) == 2 &&
          vmi_copysign(-2, -3) == -2);
    CHECK(vmi_log(1).hi == 0 && vmi_log(1).lo == 0);
}

/* A power so large that its product with a logarithm overflows */
static void test_huge_powers(void)
{
    const vm_real huge = VM_MAX / 200;
    CHECK(vmi_pow_checked(2, huge) == VM_INFINITY && vmi_pow_checked((vm_real)0.5, huge) == 0);
    CHECK(vmi_pow_checked(2, -huge) == 0 && vmi_pow_checked((vm_real)0.5, -huge) == VM_INFINITY);
    CHECK(vmi_pow_checked((vm_real)1e10, VM_MAX / 2) == VM_INFINITY && vmi_pow_checked(VM_MIN, VM_MAX) == 0);
    CHECK(vmi_pow_checked(1 + VM_EPSILON, huge) == VM_INFINITY && vmi_pow_checked(1 - VM_EPSILON, huge) == 0);
    CHECK(vmi_pow_checked(2, VM_INFINITY) == VM_INFINITY && vmi_pow_checked(2, -VM_INFINITY) == 0);
}

static double signed_power(double x, double p) { return copysign(pow(fabs(x), p), x); }

/* sa^2 + |ca|^(alpha+1) = 1 (279), oddness and evenness, half and whole periods and reflections, (278) and (280) with
   their signs corrected, and v' = u|u|^(alpha-1) (275). */
static void test_identities(void)
{
    int i, k, symmetric = 1;
    for (i = 0; i < 20000; i++) {
        double alpha = i % 8 == 0 ? 0 : uniform(0, i % 2 ? 5 : 40), s = uniform(-30, 30);
        double eps = (double)VM_EPSILON, power, h = 1e-3, rounded;
        vm_real sa, ca, sa2, ca2, ca_minus, ca_plus, pi = ateb_pi((vm_real)alpha);
        ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
        power = pow(fabs((double)ca), alpha + 1);
        rounded = 2 * (double)sa * (double)sa + (alpha + 1) * power; /* what an eps in sa and in ca makes */
        check_error("sa^2+|ca|^(a+1)-1", "random", "eps*",
                    fabs((double)sa * (double)sa + power - 1) / eps / rounded, 1.5, s, alpha);
        ateb_saca((vm_real)-s, (vm_real)alpha, &sa2, &ca2);
        symmetric = symmetric && sa2 == -sa && ca2 == ca;
        for (k = 0; k < 4; k++) { /* Pi + s, Pi - s, 2 Pi + s, 2 Pi - s */
            vm_real shifted = (vm_real)(1 + k / 2) * pi + (vm_real)(k % 2 ? -s : s);
            double sign_sa = k == 0 || k == 3 ? -1 : 1, sign_ca = k < 2 ? -1 : 1;
            ateb_saca(shifted, (vm_real)alpha, &sa2, &ca2);
            rounded = 4 + 2 * (fabs(s) + 2 * (double)pi); /* the sum and pi are rounded; slopes are at most 2 */
            check_error("sa shifted", "random", "eps*", fabs((double)sa2 - sign_sa * (double)sa) / eps / rounded, 1,
                        s, alpha);
            check_error("ca shifted", "random", "eps*", fabs((double)ca2 - sign_ca * (double)ca) / eps / rounded, 1,
                        s, alpha);
        }
        if (PRECISION[0] == 'f' || i % 10) continue;
        ateb_saca((vm_real)(s + h), (vm_real)alpha, &sa2, &ca_plus);
        ateb_saca((vm_real)(s - h), (vm_real)alpha, &sa, &ca_minus);
        if (fabs((double)ca) < 0.1) continue; /* ca^alpha has no third derivative at ca = 0 */
        check_error("dsa/ds", "random", "1e-6",
                    1e6 * fabs((double)(sa2 - sa) / (2 * h) - signed_power((double)ca, alpha)), 2, s, alpha);
    }
    CHECK(symmetric);
}

static void test_derivative_of_ca(void)
{
    double s, h = 1e-4;
    for (s = 0.05; s < 12; s += 0.1) {
        double alpha;
        for (alpha = 0.25; alpha < 9; alpha *= 2) {
            vm_real sa, ca, minus = ateb_ca((vm_real)(s - h), (vm_real)alpha),
                            plus = ateb_ca((vm_real)(s + h), (vm_real)alpha);
            ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
            if (PRECISION[0] == 'd')
                check_error("dca/ds", "grid", "1e-6",
                            1e6 * fabs((double)(plus - minus) / (2 * h) + 2 / (alpha + 1) * (double)sa), 1, s,
                            alpha);
        }
    }
}

/* The quarter-period shifts, (278) row 2 and (280) row 2 as corrected, lead to the functions of swapped index:
     sa(1,alpha,s) = ca(1,alpha,Pi/2 - s),  ca(alpha,1,s) = sa(alpha,1,Pi/2 - s).
   So f(z) = sa(1,alpha,Pi/2 - z), g(z) = ca(alpha,1,Pi/2 - z) must be the solution of the swapped system
     f' = -g|g|^(alpha-1), g' = 2 f/(alpha + 1), f(0) = 1, g(0) = 0,
   integrated here by Taylor steps of its own. The printed forms, without the swap, fail by what is known. */
static void test_quarter_period(void)
{
    const vm_real alpha = (vm_real)1.5, s = (vm_real)0.7;
    double a;
    for (a = 0.5; a < 9; a *= 1.7) {
        const int steps = 4000;
        double half = (double)ateb_pi((vm_real)a) / 2, h = 0.9 * half / steps, f = 1, g = 0, z = 0;
        int i;
        for (i = 0; i < steps; i++, z += h) { /* midpoint rule; its error is below 1e-6 */
            double fm = f - h / 2 * signed_power(g, a), gm = g + h / 2 * 2 / (a + 1) * f;
            f -= h * signed_power(gm, a);
            g += h * 2 / (a + 1) * fm;
            if (i % 500) continue;
            check_error("f(z)", "swapped index", "1e-6",
                        1e6 * fabs(f - (double)ateb_sa((vm_real)(half - z - h), (vm_real)a)), 3, z, a);
            check_error("g(z)", "swapped index", "1e-6",
                        1e6 * fabs(g - (double)ateb_ca((vm_real)(half - z - h), (vm_real)a)), 3, z, a);
        }
    }
    CHECK(fabs((double)ateb_sa(s, alpha) - 0.635289) < 1e-6);
    CHECK(fabs((double)ateb_ca(ateb_pi(alpha) / 2 - s, alpha) - 0.541498) < 1e-6); /* printed (278) row 2 */
    CHECK(fabs((double)ateb_ca(s, alpha) - 0.813238) < 1e-6);
    CHECK(fabs((double)ateb_sa(ateb_pi(alpha) / 2 + s, alpha) - 0.885567) < 1e-6); /* printed (280) row 2 */
    CHECK(fabs((double)ateb_sa(ateb_pi(alpha) + s, alpha) + 0.635289) < 1e-6);     /* (278) row 3 as corrected */
}

/* The two methods of ateb.h meet at the change-over. */
static void test_change_over(void)
{
    double a;
    for (a = 0; a < 1000; a = 1.3 * a + 0.01) {
        vm_real s = (vm_real)0.55, below_sa, below_ca, above_sa, above_ca;
        ateb_saca(s * (1 - 2 * VM_EPSILON), (vm_real)a, &below_sa, &below_ca);
        ateb_saca(s * (1 + 2 * VM_EPSILON), (vm_real)a, &above_sa, &above_ca);
        check_error("sa step", "s = 0.55", "eps", fabs((double)(above_sa - below_sa)) / (double)VM_EPSILON, 4, a,
                    0);
        check_error("ca step", "s = 0.55", "eps", fabs((double)(above_ca - below_ca)) / (double)VM_EPSILON, 4, a,
                    0);
    }
}

static void test_closed_forms(void)
{
    int i;
    for (i = 0; i < 2000; i++) {
        double s = uniform(-30, 30), wave = s - 4 * floor(s / 4 + 0.5); /* alpha = 0: triangles and parabolas */
        vm_real sa, ca, sn, cn, dn;
        ateb_saca((vm_real)s, 1, &sa, &ca);
        check_error("sa = sin", "alpha = 1", "eps", ERROR_EPS(sa, sin(s), 0, 1), 2, s, 1);
        check_error("ca = cos", "alpha = 1", "eps", ERROR_EPS(ca, cos(s), 0, 1), 2, s, 1);
        ateb_saca((vm_real)s, 3, &sa, &ca); /* the cubic oscillator; s sqrt(1/2) is rounded, slopes are at most 1 */
        jacobi_sncndn((vm_real)s * VM_SQRT((vm_real)0.5), (vm_real)0.5, &sn, &cn, &dn);
        check_error("ca = cn", "alpha = 3", "eps*", ERROR_EPS(ca, (double)cn, 0, 4 + fabs(s)), 1, s, 3);
        check_error("sa = sqrt 2 sn dn", "alpha = 3", "eps*",
                    ERROR_EPS(sa, (double)(VM_SQRT(2) * sn * dn), 0, 4 + fabs(s)), 1, s, 3);
        ateb_saca((vm_real)s, 0, &sa, &ca);
        if (fabs(wave) > 1) {
            wave = copysign(2, wave) - wave;
            check_error("ca = (2-s)^2-1", "alpha = 0", "eps", ERROR_EPS(ca, wave * wave - 1, 0, 1), 3, s, 0);
        } else check_error("ca = 1-s^2", "alpha = 0", "eps", ERROR_EPS(ca, 1 - wave * wave, 0, 1), 3, s, 0);
        check_error("sa = s", "alpha = 0", "eps", ERROR_EPS(sa, wave, 0, 1), 3, s, 0);
    }
    check_error("Pi_0 = 2", "", "ulp", ERROR_ULP(ateb_pi(0), 2, 0), 1, 0, 0);
    check_error("Pi_1 = pi", "", "ulp", ERROR_ULP(ateb_pi(1), (double)VM_PI, 0), 1, 1, 0);
    check_error("Pi", "", "ulp", ERROR_ULP(ateb_pi(3), 5.244115108584239620929679, 0), 1, 3, 0);
}

/* For alpha = 0 the zeros of sa are the even integers and those of ca the odd ones. Both functions are exact there, by a
   plan and without one, for each integer that has all its digits. */
static void test_zeros_of_triangles(void)
{
    const vm_real farthest = VM_C(0.25) / VM_EPSILON;
    ateb_plan plan;
    vm_real x = 1;
    CHECK(ateb_plan_init(&plan, 0) == 0);
    for (; x < farthest; x = 2 * x + 1) { /* ... 1111 in binary digits: an odd number */
        const vm_real sign = fmod((double)x, 4) == 1 ? 1 : -1;
        vm_real sa, ca;
        ateb_saca(x, 0, &sa, &ca);
        CHECK(sa == sign && ca == 0);
        ateb_plan_saca(&plan, x, &sa, &ca);
        CHECK(sa == sign && ca == 0);
        ateb_saca(x + 1, 0, &sa, &ca);
        CHECK(sa == 0 && fabs((double)ca) == 1);
        ateb_plan_saca(&plan, x + 1, &sa, &ca);
        CHECK(sa == 0 && fabs((double)ca) == 1);
    }
}

/* A zero of ca at which a float of |s| < 100 Pi_alpha is very close, for an alpha so large that Pi_alpha comes from its
   series: ca by mpmath with 50 digits. The error is 0.2 ulp; a wrong low word in the series causes 1.8 ulp. */
static void test_zero_of_large_alpha(void)
{
    const vm_real s = VM_C(1141565.125), alpha = VM_C(43075.54296875);
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    check_error("ca", "s near 53 Pi/2", "ulp", ERROR_ULP(ca, 2.3980420430227674508e-9, 0), 1, (double)s, (double)alpha);
}

/* Next to its largest value, sa is 1 - X/2 - X^2/8 ... with X = ca^(alpha+1). Where X is as small as a few roundings of 1, the
   error of sa is at most 1 ulp. */
static void test_sa_next_to_1(void)
{
    const double farthest = VM_MANT_DIG > 24 ? 40 : 12; /* X is from 2^-farthest down to 2^-(farthest + 20) */
    double worst = 0, X;
    int i, k;
    for (i = 0; i <= 80; i++) {
        const vm_real alpha = (vm_real)(i * 0.25), half = ateb_pi(alpha) / 2;
        vm_real sa, ca;
        for (k = 0; k < 200; k++) {
            ateb_saca(half - (vm_real)pow(2, -(farthest + k * 0.1) / (1 + (double)alpha)), alpha, &sa, &ca);
            X = pow((double)ca, 1 + (double)alpha);
            worst = fmax(worst, fabs((double)sa - 1 + X / 2 + X * X / 8) / ((double)VM_EPSILON / 2));
        }
    }
    check_error("sa", "next to 1", "ulp", worst, 1, 0, 0);
}

/* The limits, which are approached as alpha or 1/alpha: parabolas, and tanh; and no alpha differs from its
   neighbours, be it one of closed forms or of plans without a power. An eps of alpha moves Pi by less than one. */
static void test_limits(void)
{
    static const double special[] = {0.5, 1, 1.5, 2, 3, 7};
    const vm_real small = VM_EPSILON / 8, large = 1 / VM_EPSILON;
    int i;
    for (i = 0; i < 2000; i++) {
        const double s = uniform(-6, 6);
        const vm_real alpha = (vm_real)special[i % 6], next = alpha * (1 + VM_EPSILON);
        vm_real sa, ca, sa2, ca2;
        ateb_plan plan, plan_next;
        ateb_saca((vm_real)s, large, &sa, &ca);
        check_error("sa", "to tanh", "eps", ERROR_EPS(sa, tanh(s), 0, 1), 2, s, (double)large);
        check_error("1 - ca", "to 0", "eps", (1 - (double)ca) / (double)VM_EPSILON, 2 * log(cosh(6.0)) + 2, s,
                    (double)large);
        ateb_saca((vm_real)s, small, &sa, &ca);
        ateb_saca((vm_real)s, 0, &sa2, &ca2);
        check_error("sa", "to a triangle", "eps", fabs((double)(sa - sa2)) / (double)VM_EPSILON, 3, s, 0);
        check_error("ca", "to a parabola", "eps", fabs((double)(ca - ca2)) / (double)VM_EPSILON, 3, s, 0);
        ateb_saca((vm_real)s, alpha, &sa, &ca);
        ateb_saca((vm_real)s, next, &sa2, &ca2);
        check_error("sa, ca", "next alpha", "eps*",
                    fmax(fabs((double)(sa - sa2)), fabs((double)(ca - ca2))) / (double)VM_EPSILON / (3 + fabs(s)),
                    1, s, special[i % 6]);
        CHECK(ateb_plan_init(&plan, alpha) == 0 && ateb_plan_init(&plan_next, next) == 0);
        CHECK(plan.twice_alpha >= 0 && plan_next.twice_alpha < 0);
        ateb_plan_saca(&plan, (vm_real)s, &sa, &ca);
        ateb_plan_saca(&plan_next, (vm_real)s, &sa2, &ca2);
        check_error("plan", "next alpha", "eps*",
                    fmax(fabs((double)(sa - sa2)), fabs((double)(ca - ca2))) / (double)VM_EPSILON / (3 + fabs(s)),
                    1, s, special[i % 6]);
    }
}

static void test_domain(void)
{
    const vm_real bad_alpha[] = {(vm_real)-1e-3, VM_NAN, VM_INFINITY, -VM_INFINITY}, ok = (vm_real)0.5;
    const vm_real bad_s[] = {VM_NAN, VM_INFINITY, -VM_INFINITY};
    vm_real sa, ca;
    int i, in_range = 1;
    for (i = 0; i < 4; i++) {
        CHECK(ateb_pi(bad_alpha[i]) != ateb_pi(bad_alpha[i]));
        ateb_saca(ok, bad_alpha[i], &sa, &ca);
        CHECK(sa != sa && ca != ca);
    }
    for (i = 0; i < 3; i++) {
        ateb_saca(bad_s[i], ok, &sa, &ca);
        CHECK(sa != sa && ca != ca);
    }
    ateb_saca(-(vm_real)0, ok, &sa, &ca);
    CHECK(sa == 0 && copysign(1, (double)sa) < 0 && ca == 1);
    for (i = 0; i < 20000; i++) { /* in range whatever the size of s and alpha */
        double s = uniform(-1, 1) * pow(10, uniform(-37, 37)), alpha = uniform(0, 1) * pow(10, uniform(-37, 37));
        ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
        in_range = in_range && VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1;
    }
    CHECK(in_range);
    ateb_saca(VM_MAX, VM_MAX, &sa, &ca);
    CHECK(VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
    ateb_saca(VM_MAX, ok, &sa, &ca);
    CHECK(VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
}

/* The relative errors of a plan of full accuracy where it promises 2 ulp, by single calls or by arrays */
static void check_plan_ulp(const char *sa_name, const char *ca_name, const ateb_row *row, vm_real sa, vm_real ca)
{
    const double moved = plan_zeros_error(row->alpha) * fabs(row->s);
    if (fabs(row->s) > 100 * row->pi) return;
    check_error(sa_name, "full", "ulp", ERROR_ULP(sa, row->sa, row->sa_low) - moved / ULP(row->sa), 2, row->s,
                row->alpha);
    check_error(ca_name, "full", "ulp",
                ERROR_ULP(ca, row->ca, row->ca_low) - 2 / (row->alpha + 1) * moved / ULP(row->ca), 2, row->s,
                row->alpha);
}

/* The prepared alpha against the same table, to the last digits and to those that were asked for; its array form; s
   so large that it is reduced otherwise; refusals. */
static void test_plan(void)
{
    static const double accuracies[] = {0, 1e-8, 1e-4};
    size_t i;
    int k;
    for (i = 0; i < sizeof ateb_table / sizeof *ateb_table; i++) {
        const ateb_row *row = ateb_table + i;
        const vm_real s = (vm_real)row->s;
        if (!representable(row->s) || !representable(row->alpha)) continue;
        for (k = 0; k < 3; k++) {
            const char *region = k == 0 ? "full" : k == 1 ? "1e-8" : "1e-4";
            const double allowed = accuracies[k] > (double)VM_EPSILON ? accuracies[k] / (double)VM_EPSILON : 2;
            vm_real sa, ca, sa2, ca2;
            ateb_plan plan;
            CHECK(ateb_plan_init_to(&plan, (vm_real)row->alpha, (vm_real)accuracies[k]) == 0);
            ateb_plan_saca(&plan, s, &sa, &ca);
            check_error("plan sa", region, "eps", ERROR_EPS(sa, row->sa, row->sa_low, 1), allowed, row->s,
                        row->alpha);
            check_error("plan ca", region, "eps", ERROR_EPS(ca, row->ca, row->ca_low, 1), allowed, row->s,
                        row->alpha);
            if (k == 0) check_plan_ulp("plan sa", "plan ca", row, sa, ca);
            sa2 = s;
            ateb_plan_saca_array(&plan, 1, &sa2, &sa2, &ca2);
            if (k == 0) check_plan_ulp("plan array sa", "plan array ca", row, sa2, ca2);
            check_error("plan array", region, "eps",
                        fmax(fabs((double)(sa2 - sa)), fabs((double)(ca2 - ca))) / (double)VM_EPSILON, 3, row->s,
                        row->alpha);
        }
    }
}

/* The points at which a plan had errors between 2.1 and 2.2 ulp: sa in double, and ca in float; values by mpmath with 40
   digits */
static void test_plan_hardest(void)
{
    static const struct {
        double alpha, s, sa, sa_low, ca, ca_low;
    } rows[] = {
        {0.00035980927383384383, 2.6378136254798896, -0.6373362168924643, 2.1039358e-17, -0.5939138761508992, -6.6780584e-19},
        {0.00017624656902626157, -86.72105407714844, 0.7117266809944172, 3.1880403e-18, -0.4935065538574013, -1.269894e-17},
        {0.0001812509581213817, -1.4960429668426514, -0.5041710820450288, 1.8859698e-17, -0.7458511595306259, 3.4271201e-17},
        {0.005414554383605719, 0.7221201658248901, 0.7213021557957878, 7.4843002e-18, 0.4816246572510089, -2.2505705e-17},
        {3.5, -234.30783081054688, -0.9778674213027927, 5.2173019e-17, -0.4989429977283814, 5.0598198e-18},
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double alpha = rows[i].alpha, s = rows[i].s;
        vm_real sa, ca;
        ateb_plan plan;
        if (!representable(alpha) || !representable(s)) continue;
        ateb_plan_init(&plan, (vm_real)alpha);
        ateb_plan_saca(&plan, (vm_real)s, &sa, &ca);
        check_error("plan sa", "hardest", "ulp", ERROR_ULP(sa, rows[i].sa, rows[i].sa_low), 2, s, alpha);
        check_error("plan ca", "hardest", "ulp", ERROR_ULP(ca, rows[i].ca, rows[i].ca_low), 2, s, alpha);
    }
}

static void test_plan_domain(void)
{
    const vm_real bad_alpha[] = {(vm_real)-1e-3, VM_NAN, VM_INFINITY, -VM_INFINITY};
    vm_real s[130], sa[130], ca[130], one_sa, one_ca;
    ateb_plan plan, copy;
    int i, same = 1;
    ateb_plan_init(&plan, 2);
    memcpy(&copy, &plan, sizeof plan);
    for (i = 0; i < 4; i++) CHECK(ateb_plan_init(&plan, bad_alpha[i]) == -1);
    CHECK(memcmp(&copy, &plan, sizeof plan) == 0);
    for (i = 0; i < 130; i++) s[i] = (vm_real)uniform(-1, 1) * (vm_real)pow(10, uniform(-3, 36));
    s[0] = VM_NAN;
    s[70] = VM_INFINITY;
    s[129] = -VM_INFINITY;
    ateb_plan_saca_array(&plan, 130, s, sa, ca);
    for (i = 0; i < 130; i++) {
        ateb_plan_saca(&plan, s[i], &one_sa, &one_ca);
        if (!VM_IS_FINITE(s[i])) {
            CHECK(sa[i] != sa[i] && ca[i] != ca[i] && one_sa != one_sa && one_ca != one_ca);
            continue;
        }
        same = same && VM_FABS(one_sa - sa[i]) < 4 * VM_EPSILON && VM_FABS(one_ca - ca[i]) < 4 * VM_EPSILON;
        CHECK(VM_FABS(one_sa) <= 1 + VM_EPSILON && VM_FABS(one_ca) <= 1 + VM_EPSILON);
    }
    CHECK(same);
}

/* Blocks, in which processors with wide registers compute arrays, have the bits of single calls. This test runs on any
   processor. Where the compiler fuses products and sums, it need not fuse the same ones in both, and nothing is
   compared. */
static void test_plan_blocks(void)
{
    const vm_real alphas[] = {0, VM_C(0.07), VM_C(0.5), VM_C(4.0) / 3, 3, 7, VM_C(20.3), 1000, VM_C(3e4), VM_C(1e6)};
    const vm_real accuracies[] = {0, VM_C(1e-5), VM_C(1e-3)};
    volatile vm_real above = 1 + VM_EPSILON, below = 1 - VM_EPSILON;
    const int is_fused = above * below - 1 != 0;
    vm_real s[VMI_ATEB_BLOCK], sa[VMI_ATEB_BLOCK], ca[VMI_ATEB_BLOCK], one_sa, one_ca;
    ateb_plan plan;
    int i, j, k, differing = 0;
    for (i = 0; i < 10; i++)
        for (j = 0; j < 3; j++) {
            CHECK(ateb_plan_init_to(&plan, alphas[i], accuracies[j]) == 0);
            for (k = 0; !is_fused && k < 300 * VMI_ATEB_BLOCK; k++) {
                int at = k % VMI_ATEB_BLOCK;
                const vm_real quarters = k & 1 ? 0 : plan.quarter.hi * VM_FLOOR((vm_real)uniform(-4, 5));
                s[at] = quarters + (vm_real)(uniform(-1, 1) * pow(10, uniform(-12, 2)));
                if (at < VMI_ATEB_BLOCK - 1) continue;
                vmi_ateb_block_saca(&plan, s, sa, ca);
                for (at = 0; at < VMI_ATEB_BLOCK; at++) {
                    ateb_plan_saca(&plan, s[at], &one_sa, &one_ca);
                    differing += memcmp(sa + at, &one_sa, sizeof one_sa) || memcmp(ca + at, &one_ca, sizeof one_ca);
                }
            }
        }
    CHECK(differing == 0);
}

/* Beyond the tables a plan still gives what ateb_saca does; y of the change-over rounds to 1 - eps, 1 or 1 + eps, the
   series' alpha j could overflow. */
static void test_plan_large(void)
{
    const vm_real alpha[] = {VM_C(3e17), VM_C(1e30), VM_C(7e36), VM_MAX / 100, VM_MAX / 4};
    const vm_real s[] = {VM_C(0.3), VM_C(0.9), VM_C(1.0), VM_C(3.0), VM_C(1e4), VM_C(1e16)};
    vm_real sa, ca, plan_sa, plan_ca;
    ateb_plan plan;
    int i, j;
    for (i = 0; i < 5; i++) {
        CHECK(ateb_plan_init(&plan, alpha[i]) == 0);
        for (j = 0; j < 6; j++) {
            ateb_saca(s[j], alpha[i], &sa, &ca);
            ateb_plan_saca(&plan, s[j], &plan_sa, &plan_ca);
            CHECK(VM_FABS(plan_sa - sa) <= 2 * VM_EPSILON && VM_FABS(plan_ca - ca) <= 2 * VM_EPSILON);
        }
    }
}

/* ateb_phase inverts ateb_saca, in all four quarters, at any scale, to what an ulp of each input makes. */
static void test_phase(void)
{
    int i;
    for (i = 0; i < 20000; i++) {
        double alpha = i % 8 == 0 ? 0 : i % 8 == 1 ? pow(10, uniform(1, 6)) : uniform(0, 12), moved, phase, lambda;
        vm_real pi = ateb_pi((vm_real)alpha), s, sa, ca;
        s = (vm_real)uniform(-1, 1) * (pi > 20 ? 20 : pi);
        if (i % 3 == 0) s *= (vm_real)pow(10, uniform(-6, 0));
        ateb_saca(s, (vm_real)alpha, &sa, &ca);
        if (sa == 0 || ca == 0) continue;
        phase = (double)ateb_phase(sa, ca, (vm_real)alpha);
        /* ds = |ca| dsa - (alpha + 1)/2 sa dca on the curve, where the scale is free */
        moved = 3 * (fabs((double)ca) * ULP((double)sa) + (alpha + 1) / 2 * fabs((double)sa) * ULP((double)ca)) +
                4 * ULP((double)s);
        check_error("phase", "round trip", "bound", fabs(phase - (double)s) / moved, 2, (double)s, alpha);
        if (alpha > 12) continue;
        lambda = uniform(0.2, 5);
        check_error("phase", "scaled", "bound",
                    fabs((double)ateb_phase((vm_real)(pow(lambda, (alpha + 1) / 2) * (double)sa),
                                            (vm_real)(lambda * (double)ca), (vm_real)alpha) -
                         (double)s) /
                        (moved + (alpha + 1) * (double)VM_EPSILON * (fabs((double)s) + 1)),
                    2, (double)s, alpha);
    }
    CHECK(ateb_phase(0, 1, 3) == 0);
    CHECK(ateb_phase(0, -1, 3) == ateb_pi(3));
    CHECK(ateb_phase(-(vm_real)0, -1, 3) == -ateb_pi(3));
    CHECK(ateb_phase(1, 0, 3) == ateb_pi(3) / 2);
    CHECK(ateb_phase(-2, 0, 3) == -ateb_pi(3) / 2);
    CHECK(ateb_phase(1, 0, -1) != ateb_phase(1, 0, -1));
    CHECK(ateb_phase(VM_NAN, 0, 1) != ateb_phase(VM_NAN, 0, 1));
}

typedef struct beta_row {
    double x, a, b, p, p_low, q, q_low, beta, beta_low, tail;
    int of_y;
    double inverse, inverse_low, complement, complement_low, log_x, log_x_low, slope;
} beta_row;

static const beta_row beta_table[] = {
#include "data/beta_table.h"
};

static void test_beta(void)
{
    size_t i;
    for (i = 0; i < sizeof beta_table / sizeof *beta_table; i++) {
        const beta_row *row = beta_table + i;
        const vm_real x = (vm_real)row->x, a = (vm_real)row->a, b = (vm_real)row->b, tail = (vm_real)row->tail;
        const double least = PRECISION[0] == 'f' ? 1e-37 : 1e-300;
        const double moved = row->slope * ULP(row->tail) / row->tail; /* of ln(x/y), by an ulp of the tail */
        vm_real p, q, y, inverse, log_x;
        if (!representable(row->x) || !representable(row->a) || !representable(row->b)) continue;
        ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
        if (row->beta > least && row->beta < 1 / least)
            check_error("beta", "", "ulp", ERROR_ULP(ateb_beta(a, b), row->beta, row->beta_low), 1, row->a, row->b);
        check_error("beta_inc", "p", "ulp", ERROR_ULP(p, row->p, row->p_low), 30, row->x, row->a);
        check_error("beta_inc", "q", "ulp", ERROR_ULP(q, row->q, row->q_low), 30, row->x, row->a);
        CHECK(ateb_beta_inc(x, a, b) == p);
        if (!representable(row->tail)) continue;
        if (row->of_y) ateb_beta_inc_inv_both(1 - tail, tail, a, b, &inverse, &y, &log_x);
        else ateb_beta_inc_inv_both(tail, 1 - tail, a, b, &inverse, &y, &log_x);
        if (!row->of_y) CHECK(ateb_beta_inc_inv(tail, a, b) == inverse);
        if (row->inverse > least)
            check_error("beta_inc_inv", "x", "ulp",
                        ERROR_ULP(inverse, row->inverse, row->inverse_low) -
                            row->complement * row->inverse * moved / ULP(row->inverse),
                        16, row->tail, row->a);
        if (row->complement > least)
            check_error("beta_inc_inv", "y", "ulp",
                        ERROR_ULP(y, row->complement, row->complement_low) -
                            row->complement * row->inverse * moved / ULP(row->complement),
                        16, row->tail, row->a);
        if (row->inverse < 0.5)
            check_error("beta_inc_inv", "ln x", "ulp",
                        ERROR_ULP(log_x, row->log_x, row->log_x_low) - row->complement * moved / ULP(row->log_x),
                        16, row->tail, row->a);
    }
}

/* One index small, the other large: (a)_i (b)_j/(a+b)_(i+j) underflowed in float. a, b, B(a, b); and the mean of
   |sa|^16384 |ca|^32768, whose second index is 32769/(alpha + 1). */
static void test_beta_corners(void)
{
    static const double beta[3][4] = {{0.0009765625, 61381.75, 1012.4641975062358, -2.7380625848528827e-14},
                                      {99999, 0.015625, 52.993758709500966, -7.648226022558271e-16},
                                      {0.001953125, 0.0078125, 639.9840501070859, 4.554551895558147e-14}};
    const double alpha = 1125899906842624, mean = 3.051664682233022e-05, mean_low = 1.4440926060013984e-21;
    int i;
    for (i = 0; i < 3; i++)
        check_error("beta", "corners", "ulp",
                    ERROR_ULP(ateb_beta((vm_real)beta[i][0], (vm_real)beta[i][1]), beta[i][2], beta[i][3]), 1,
                    beta[i][0], beta[i][1]);
    check_error("mean", "corner", "ulp", ERROR_ULP(ateb_mean((vm_real)alpha, 16384, 32768), mean, mean_low), 2,
                alpha, 16384);
}

/* Where a or b is 0 or infinite, the beta distribution lies at x = 0 (side -1) or at x = 1 (side 1), or there is no limit
   (side 0). */
static void test_beta_limits(void)
{
    const vm_real half = (vm_real)0.5, inf = VM_INFINITY, ends[6][3] = {{0, 2, -1}, {2, inf, -1}, {0, inf, -1},
                                                                      {2, 0, 1},  {inf, 2, 1},  {inf, 0, 1}};
    vm_real x, y, ln_x;
    int i;
    for (i = 0; i < 6; i++) {
        const vm_real a = ends[i][0], b = ends[i][1], p = (vm_real)(ends[i][2] < 0);
        CHECK(ateb_beta_inc(half, a, b) == p && ateb_beta_inc(p, a, b) == p && isnan(ateb_beta_inc(1 - p, a, b)));
        CHECK(ateb_beta_inc_inv(half, a, b) == 1 - p && ateb_beta_inc_inv(1 - p, a, b) == 1 - p);
        CHECK(isnan(ateb_beta_inc_inv(p, a, b)));
        CHECK(ateb_ln_beta_inc(half, a, b) == (p > 0 ? 0 : -inf) && isnan(ateb_ln_beta_inc(1 - p, a, b)));
        ateb_beta_inc_inv_both(half, half, a, b, &x, &y, &ln_x);
        CHECK(x == 1 - p && y == p && ln_x == (p > 0 ? -inf : 0));
    }
    CHECK(ateb_beta(0, 1) == inf && ateb_beta(2, 0) == inf && ateb_beta(0, 0) == inf);
    CHECK(ateb_beta(inf, 1) == 0 && ateb_beta(2, inf) == 0 && ateb_beta(inf, inf) == 0 && isnan(ateb_beta(0, inf)));
    CHECK(ateb_ln_beta(0, 1) == inf && ateb_ln_beta(inf, 1) == -inf && isnan(ateb_ln_beta(inf, 0)));
    CHECK(isnan(ateb_beta_inc(half, 0, 0)) && isnan(ateb_beta_inc(half, inf, inf)));
    CHECK(isnan(ateb_beta(-1, 0)) && isnan(ateb_beta_inc(half, 0, -1)) && isnan(ateb_beta_inc_inv(half, -inf, 0)));
}

/* Logarithms where the functions themselves overflow or underflow, and means for two indices. The values were computed
   with 120 digits: a, b, ln B; x, a, b, ln I_x; n, m, p, q, the mean; and the low words. All arguments are exact in
   float. */
static void test_ln_beta(void)
{
    static const double ln_beta[6][4] = {{1099511627776.0, 1099511627776.0, -1524246769584.2183, -7.037471789072285e-05},
                                         {8.673617379884035e-19, 3.0, 41.58883083359672, 1.83421625555086e-15},
                                         {0.25, 0.5, 1.6571065161914822, -1.9862623052755077e-17},
                                         {1.2379400392853803e+27, 2.5, -155.67343275551477, -8.236396128226683e-15},
                                         {1.5777218104420236e-30, 1.5777218104420236e-30, 69.31471805599453, -1.6777560748042639e-15},
                                         {6.310887241768095e-30, 8.673617379884035e-19, 67.23527651432197, 3.914809919898866e-15}};
    static const double ln_inc[2][5] = {{0.125, 2048.0, 512.5, -3050.6622939623016, 1.104072164818014e-13},
                                        {7.888609052210118e-31, 1000.0, 0.25, -69321.18698873627, -5.195492043595726e-12}};
    static const double mean[2][6] = {{2.0, 5.0, 3.0, 0.5, 0.4315441428873204, -4.800324850665741e-18},
                                      {0.25, 1000.0, -0.5, 40.0, 0.02632870189266028, -1.540949964373392e-18}};
    int i;
    for (i = 0; i < 6; i++) {
        const double *r = ln_beta[i];
        check_error("ln B", "", "ulp", ERROR_ULP(ateb_ln_beta((vm_real)r[0], (vm_real)r[1]), r[2], r[3]), 1, r[0], r[1]);
    }
    for (i = 0; i < 2; i++) {
        const double *r = ln_inc[i];
        check_error("ln I_x", "", "ulp",
                    ERROR_ULP(ateb_ln_beta_inc((vm_real)r[0], (vm_real)r[1], (vm_real)r[2]), r[3], r[4]), 2, r[0], r[1]);
    }
    for (i = 0; i < 2; i++) {
        const double *r = mean[i];
        const vm_real n = (vm_real)r[0], m = (vm_real)r[1], p = (vm_real)r[2], q = (vm_real)r[3];
        check_error("mean", "two indices", "ulp", ERROR_ULP(ateb_mean_nm(n, m, p, q, 0), r[4], r[5]), 2, r[0], r[1]);
        CHECK(ateb_mean_nm(n, m, p, q, ATEB_SIGN_OF_SA) == 0 && ateb_mean_nm(n, m, p, q, ATEB_SIGN_OF_CA) == 0);
        CHECK(ateb_mean_nm(n, m, p, q, ATEB_SIGN_OF_SA + ATEB_SIGN_OF_CA) == 0);
    }
    for (i = 0; i < 500; i++) { /* the logarithm of the functions, where they are normal numbers */
        const double a = pow(10, uniform(-2, 2)), b = pow(10, uniform(-2, 2)), x = uniform(0, 1);
        const double ln_B = log((double)ateb_beta((vm_real)a, (vm_real)b)), eps = (double)VM_EPSILON;
        const double p = (double)ateb_beta_inc((vm_real)x, (vm_real)a, (vm_real)b);
        if (ln_B > log((double)VM_MIN / eps))
            check_error("ln B", "= ln of B", "eps",
                        fabs((double)ateb_ln_beta((vm_real)a, (vm_real)b) - ln_B) / eps / (1 + fabs(ln_B)), 3, a, b);
        if (p > (double)VM_MIN / eps)
            check_error("ln I_x", "= ln of I_x", "eps",
                        fabs((double)ateb_ln_beta_inc((vm_real)x, (vm_real)a, (vm_real)b) - log(p)) / eps /
                            (1 + fabs(log(p))),
                        34, a, b);
    }
}

/* The density that I_x(a, b) is computed from. A wrong density need not make I_x wrong: where it is NaN or 0, the slower way by
   logarithms is taken. */
static void test_beta_density(void)
{
    const double eps = (double)VM_EPSILON;
    int i;
    for (i = 0; i < 2000; i++) {
        const double a = exp(uniform(-3, 5)), b = exp(uniform(-3, 5)), x = uniform(0.01, 0.99);
        const vm_real ar = (vm_real)a, br = (vm_real)b, xr = (vm_real)x;
        const double ln_x = (double)ar * log((double)xr), ln_y = (double)br * log1p(-(double)xr);
        const double ln_beta = (double)ateb_ln_beta(ar, br), expected = exp(ln_x + ln_y - ln_beta);
        const double size = 1 + fabs(ln_x) + fabs(ln_y) + fabs(ln_beta); /* of the numbers whose roundings count here */
        const double got = (double)vmi_beta_density(vmi_two(xr, 0), vmi_two_sum(1, -xr), ar, br);
        if (expected < 1e-30) continue;
        check_error("beta", "density", "eps", fabs(got / expected - 1) / size / eps, 5, a, b);
    }
}

/* The last step of the inverse of I_x: the error of the point that it leads to is of the third power of the step. */
static void test_beta_moved(void)
{
    const double eps = (double)VM_EPSILON, step = VM_MANT_DIG > 24 ? 1e-4 : 4e-3, allowed = step * step * step + 4 * eps;
    int i;
    for (i = 0; i < 1000; i++) {
        const double t = uniform(-3, 3);
        const vmi_beta_point from = vmi_beta_point_at((vm_real)t), wanted = vmi_beta_point_at((vm_real)t + (vm_real)step);
        const vmi_beta_point got = vmi_beta_moved(&from, ((vm_real)t + (vm_real)step) - (vm_real)t);
        check_error("beta point", "x", "allowed", fabs((double)(got.x / wanted.x - 1)) / allowed, 1, t, 0);
        check_error("beta point", "y", "allowed", fabs((double)(got.y / wanted.y - 1)) / allowed, 1, t, 0);
        check_error("beta point", "ln x", "allowed", fabs((double)(got.ln_x.hi - wanted.ln_x.hi)) / allowed, 1, t, 0);
        check_error("beta point", "ln y", "allowed", fabs((double)(got.ln_y.hi - wanted.ln_y.hi)) / allowed, 1, t, 0);
    }
}

/* The continued fraction beside its power series, whose terms are positive: sum of (q + 3/2)_k/(5/2)_k w^k/(3/2). In double the
   sum itself has an error of 2 eps. */
static void test_w_fraction(void)
{
    const double eps = (double)VM_EPSILON;
    int i;
    for (i = 0; i < 2000; i++) {
        const vm_real q = (vm_real)uniform(0, 1), w = (vm_real)uniform(0, 0.302);
        double sum = 0, term = 1 / 1.5;
        int k;
        for (k = 0; k < 60; k++) {
            sum += term;
            term *= ((double)q + 1.5 + k) / (2.5 + k) * (double)w;
        }
        check_error("w fraction", "", "eps", fabs((double)vmi_ateb_w_fraction(q, w) / sum - 1) / eps, 6, (double)q, (double)w);
    }
}

/* Where one index is small and the other large, a small I_x(a, b) is computed as 1 minus a tail near 1. In float the
   inverse was then outside 0 to 1. */
static void test_beta_inverse_of_small(void)
{
    int i;
    for (i = 0; i < 500; i++) {
        const vm_real a = (vm_real)uniform(9e4, 1e5), b = (vm_real)pow(10, uniform(-4, -3));
        const vm_real tail = (vm_real)exp(-uniform(7, 12));
        vm_real x, y, ln_x, p, q;
        ateb_beta_inc_inv_both(tail, 1 - tail, a, b, &x, &y, &ln_x);
        CHECK(x >= 0 && x <= 1 && y >= 0 && y <= 1 && VM_FABS(x + y - 1) <= 2 * VM_EPSILON);
        ateb_beta_inc_both(x, y, a, b, &p, &q);
        if (x > VM_MIN && y > VM_MIN)
            check_error("beta_inc_inv", "small tail, there and back", "eps",
                        fabs((double)p / (double)tail - 1) / (double)VM_EPSILON, 1000, (double)a, (double)b);
    }
}

/* For an x so small that a product with it may underflow: x^a/(a B(a, b)) by mpmath */
static void test_beta_of_subnormal(void)
{
    const int is_double = VM_MANT_DIG > 24;
    const vm_real x = (vm_real)ldexp(1, is_double ? -1070 : -146);
    const double slow = is_double ? 8.265506025354488429449e-6 : 0.1833960633643274250229; /* a = 1/64, b = 1/8 */
    const double quick = is_double ? 6.540748380655208565708e-81 : 2.257129312073169080836e-11; /* a = 1/4, b = 16 */
    check_error("beta_inc", "x subnormal", "ulp", ERROR_ULP(ateb_beta_inc(x, (vm_real)0.015625, (vm_real)0.125), slow, 0), 2,
                (double)x, 1 / 64.);
    check_error("beta_inc", "x subnormal", "ulp", ERROR_ULP(ateb_beta_inc(x, (vm_real)0.25, 16), quick, 0), 2, (double)x, 0.25);
}

static void test_beta_domain(void)
{
    const vm_real half = (vm_real)0.5, below = -half, above = 1 + half;
    CHECK(ateb_beta_inc_inv(below, 1, 1) != ateb_beta_inc_inv(below, 1, 1));
    CHECK(ateb_beta_inc_inv(above, 1, 1) != ateb_beta_inc_inv(above, 1, 1));
    CHECK(ateb_beta_inc(above, 1, 1) != ateb_beta_inc(above, 1, 1));
    CHECK(isnan(ateb_beta_inc(half, (vm_real)1.01e12, 1)) && isnan(ateb_beta_inc(half, 1, VM_MAX)));
    CHECK(isnan(ateb_beta_inc_inv(half, VM_MAX, VM_MAX)) && isnan(ateb_beta_inc_inv(half, 1, (vm_real)1.01e12)));
    CHECK(ateb_beta(1, VM_NAN) != ateb_beta(1, VM_NAN));
    CHECK(ateb_beta_inc_inv(0, 2, 3) == 0 && ateb_beta_inc_inv(1, 2, 3) == 1);
    CHECK(ateb_beta_inc(0, 2, 3) == 0 && ateb_beta_inc(1, 2, 3) == 1);
    CHECK(ateb_beta(1, 1) == 1 && ateb_beta(1, 4) == (vm_real)0.25);
    CHECK(VM_FABS(ateb_beta_inc_inv(half, 7, 7) - half) <= 4 * VM_EPSILON);
}

typedef struct nm_row {
    double s, n, m, sa, sa_low, ca, ca_low, pi, pi_low;
} nm_row;

static const nm_row nm_table[] = {
#include "data/ateb_nm_table.h"
};

static void test_two_indices(void)
{
    size_t i;
    double s, alpha = 1.5;
    vm_real sa, ca, swapped_sa, swapped_ca, plain_sa, plain_ca, sn, cn, dn;
    for (i = 0; i < sizeof nm_table / sizeof *nm_table; i++) {
        const nm_row *row = nm_table + i;
        const double moved = pi_nm_error * fabs(row->s); /* of the phase, as Pi(n, m) has two words */
        double sa_moved, ca_moved;
        if (!representable(row->s) || !representable(row->n) || !representable(row->m)) continue;
        ateb_saca_nm((vm_real)row->s, (vm_real)row->n, (vm_real)row->m, &sa, &ca);
        sa_moved = 2 / (row->n + 1) * pow(fabs(row->ca), row->m) * moved / ULP(row->sa);
        ca_moved = 2 / (row->m + 1) * pow(fabs(row->sa), row->n) * moved / ULP(row->ca);
        check_error("sa(n, m)", "table", "ulp", ERROR_ULP(sa, row->sa, row->sa_low) - sa_moved, 8, row->s, row->n);
        check_error("ca(m, n)", "table", "ulp", ERROR_ULP(ca, row->ca, row->ca_low) - ca_moved, 8, row->s, row->m);
        check_error("Pi(n, m)", "table", "ulp",
                    ERROR_ULP(ateb_pi_nm((vm_real)row->n, (vm_real)row->m), row->pi, row->pi_low), 1, row->n,
                    row->m);
    }
    for (s = -9.8; s < 10; s += 0.7) { /* (278), (280), corrected: a quarter on, the swapped pair */
        vm_real quarter = ateb_pi((vm_real)alpha) / 2;
        ateb_saca((vm_real)s, (vm_real)alpha, &plain_sa, &plain_ca);
        ateb_saca_nm((vm_real)s, 1, (vm_real)alpha, &sa, &ca);
        ateb_saca_nm(quarter - (vm_real)s, (vm_real)alpha, 1, &swapped_sa, &swapped_ca);
        check_error("sa(1, m)", "= sa", "eps", fabs((double)(sa - plain_sa)) / (double)VM_EPSILON, 8, s, alpha);
        check_error("ca(m, 1)", "= ca", "eps", fabs((double)(ca - plain_ca)) / (double)VM_EPSILON, 8, s, alpha);
        check_error("sa = ca swapped", "(278)", "eps", fabs((double)(swapped_ca - plain_sa)) / (double)VM_EPSILON,
                    40, s, alpha);
        check_error("ca = sa swapped", "(280)", "eps", fabs((double)(swapped_sa - plain_ca)) / (double)VM_EPSILON,
                    40, s, alpha);
        ateb_saca_nm((vm_real)s, 3, 1, &sa, &ca); /* sa(3, 1, s) = sn(s/2 | -1) */
        jacobi_sncndn((vm_real)s / 2, -1, &sn, &cn, &dn);
        check_error("sa(3, 1) = sn", "m = -1", "eps", fabs((double)(sa - sn)) / (double)VM_EPSILON, 20, s, 3);
    }
    ateb_saca_nm(1, -1, 1, &sa, &ca);
    CHECK(sa != sa && ca != ca);
    CHECK(ateb_pi_nm(-1, 1) != ateb_pi_nm(-1, 1));
}

/* (316) at the values of the recomputation, the closed integrals by their derivatives and over a quarter */
static void test_means_and_integrals(void)
{
    static const double mean[4][4] = {{1.5, 2, 0, 4.087882200450978690808038},
                                      {1.5, 2, 2, 1.05355514690521619068528},
                                      {3, 4, 2, 1.278016250384631687935917},
                                      {0.5, 0, 2, 2.666666666666666666666667}};
    int i;
    for (i = 0; i < 4; i++) {
        const double alpha = mean[i][0], period = 2 * (double)ateb_pi((vm_real)alpha);
        check_error("mean", "(316)", "eps*",
                    fabs((double)ateb_mean((vm_real)alpha, (vm_real)mean[i][1], (vm_real)mean[i][2]) * period -
                         mean[i][3]) /
                        (double)VM_EPSILON / mean[i][3],
                    2, alpha, mean[i][1]);
    }
    CHECK(ateb_mean(1, -1, 0) != ateb_mean(1, -1, 0) && ateb_mean(-1, 1, 1) != ateb_mean(-1, 1, 1));
    for (i = 0; i < 4000; i++) {
        const double alpha = uniform(0, 20), s = uniform(-10, 10), h = 1e-3;
        const vm_real half = ateb_pi((vm_real)alpha) / 2;
        vm_real sa, ca,
            both = ateb_integral_sa2((vm_real)s, (vm_real)alpha) + ateb_integral_ca((vm_real)s, (vm_real)alpha);
        ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
        check_error("integrals", "sum = s", "eps*", fabs((double)both - s) / (double)VM_EPSILON / (1 + fabs(s)), 3,
                    s, alpha);
        check_error("integral sa^2", "quarter = mean", "eps*",
                    fabs((double)ateb_integral_sa2(half, (vm_real)alpha) -
                         (double)(half * ateb_mean((vm_real)alpha, 2, 0))) /
                        (double)VM_EPSILON / (double)half,
                    3, alpha, 0);
        if (PRECISION[0] == 'f' || fabs((double)ca) < 0.1) continue;
        check_error("integral sa^2", "derivative", "1e-6",
                    1e6 * fabs((double)(ateb_integral_sa2((vm_real)(s + h), (vm_real)alpha) -
                                        ateb_integral_sa2((vm_real)(s - h), (vm_real)alpha)) /
                                   (2 * h) -
                               (double)(sa * sa)),
                    20, s, alpha);
    }
    check_error("integral sa^2", "small s", "ulp",
                ERROR_ULP(ateb_integral_sa2((vm_real)0.0009765625, 3), 3.1044076938733873515e-10,
                          -2.413058897574063709e-26),
                8, 9.765625e-4, 3);
}

/* The mean in float of a power next to -1, where n is so large that the product of two powers underflows: 2^24. In
   double the mean is that of the same numbers. */
static void test_mean_next_to_minus_1(void)
{
    const double n = 8.3833376529426953e+29, p = -0.99999994039535522, q = 9.1956281661987305;
    const vm_real mean = ateb_mean_nm((vm_real)n, 1, (vm_real)p, (vm_real)q, 0);
    check_error("mean", "p next to -1", "ulp", ERROR_ULP(mean, 16777216, 0), 2, n, p);
}

/* sa grows and ca falls from one number to the next, but for an ulp or two */
static void test_monotone(void)
{
    static const double alphas[] = {0, 0.1, 0.5, 1, 1.5, 3, 10, 100, 1e4, 1e6};
    int i, j;
    double steps = 0;
    for (i = 0; i < 10; i++)
        for (j = 0; j < 400; j++) {
            vm_real half = ateb_pi((vm_real)alphas[i]) / 2, s = (vm_real)uniform(0, 1) * (half < 3 ? half : 3), sa,
                    ca;
            vm_real next = s * (1 + VM_EPSILON), sa2, ca2;
            if (j < 20) {
                s = (vm_real)(0.55 * (1 + (double)VM_EPSILON * (j - 10)));
                next = s * (1 + VM_EPSILON);
            }
            if (next >= half) continue;
            ateb_saca(s, (vm_real)alphas[i], &sa, &ca);
            ateb_saca(next, (vm_real)alphas[i], &sa2, &ca2);
            steps = fmax(steps, (double)(sa - sa2) / ULP((double)sa));
            steps = fmax(steps, (double)(ca2 - ca) / ULP((double)ca));
        }
    check_error("against monotony", "neighbours", "ulp", steps, 2, 0, 0);
}

/* Where quarters take all digits of s, and beyond: in range, and of one phase */
static void test_last_digits(void)
{
    static const double alphas[] = {0, 0.3, 1, 2, 3, 17, 1000};
    int i, k, in_range = 1;
    for (i = 0; i < (int)(sizeof alphas / sizeof *alphas); i++)
        for (k = 0; k < 2000; k++) {
            const vm_real alpha = (vm_real)alphas[i];
            const vm_real s = ateb_pi(alpha) * (vm_real)ldexp(uniform(1, 2), VM_MANT_DIG - 6 + k % 8);
            vm_real sa, ca;
            ateb_saca(s, alpha, &sa, &ca);
            in_range = in_range && VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1;
            check_error("sa^2+|ca|^(a+1)", "s to 4 Pi/eps", "eps (a+1)",
                        ERROR_EPS(sa * sa + VM_LIBM(pow)(VM_FABS(ca), alpha + 1), 1, 0, alphas[i] + 1), 4,
                        (double)s, alphas[i]);
        }
    CHECK(in_range);
}

/* So many quarters that a division finds the wrong one: alpha = 1 and 3, values by mpmath with 60 digits */
static void test_many_quarters(void)
{
    static const struct {
        double alpha, s, sa, ca;
    } rows[] = {
        {1, 27765793144043.773, -0.7045912614956976, -0.7096133836279452},
        {1, 282189854079179.88, 0.6931260897391353, 0.7208163592226082},
        {1, 4736814257840515, -0.6109925387239973, -0.7916363544100312},
        {1, 3416969049410982.5, -0.691246246224865, -0.7226192822503654},
        {1, 6136475335124204, 0.2904294836536845, 0.9568963972262902},
        {1, 1097504508138181.5, -0.7783069814625383, 0.6278839403955734},
        {3, 5444365776167750, -0.9891961491308504, 0.3828812046198816},
        {3, 3357066435474581.5, 0.96478298310887, -0.5128812099470176},
        {3, 6195150494791365, 0.9931509263613317, -0.3418164861559716},
        {3, 4768726242643262, 0.7797531752038526, 0.7912566228962251},
        {3, 1030581012968278.1, -0.9423567669263641, 0.5784546726634603},
        {1, 1876830.625, -0.7232878095014529, 0.6905466998158705},
        {1, 3891890.5, -0.6424808465519146, -0.7663017433191283},
        {1, 5311414.5, -0.7181920239465559, 0.6958449660229997},
        {1, 948416.1875, 0.7042085341335407, 0.70999319746987},
        {1, 6942110, 0.6935975342640363, 0.7203627283964996},
        {3, 3808083.5, -0.8559584290524896, -0.7190581671312536},
        {3, 4598387.5, 0.8961799617107166, 0.6661011514074716},
        {3, 6445024, -0.9037311413962307, -0.654293881687844},
        {3, 2765189, -0.9384951663147646, 0.5876158378824369},
        {3, 5344140, -0.9226087845935064, 0.6210772871859075},
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double alpha = rows[i].alpha, s = rows[i].s;
        vm_real sa, ca, plan_sa, plan_ca;
        ateb_plan plan;
        if (!representable(s)) continue;
        ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
        CHECK(ateb_plan_init(&plan, (vm_real)alpha) == 0);
        ateb_plan_saca(&plan, (vm_real)s, &plan_sa, &plan_ca);
        check_error("sa, ca", "many quarters", "abs",
                    fmax(fabs((double)sa - rows[i].sa), fabs((double)ca - rows[i].ca)), 1e-3, s, alpha);
        check_error("plan sa, ca", "many quarters", "abs",
                    fmax(fabs((double)plan_sa - rows[i].sa), fabs((double)plan_ca - rows[i].ca)), 1e-3, s, alpha);
    }
}

int main(void)
{
    test_elementary();
    test_huge_powers();
    test_kernel_points();
    test_reduction();
    test_mantissa();
    test_table();
    test_identities();
    test_derivative_of_ca();
    test_quarter_period();
    test_change_over();
    test_closed_forms();
    test_zeros_of_triangles();
    test_zero_of_large_alpha();
    test_sa_next_to_1();
    test_limits();
    test_domain();
    test_plan();
    test_plan_hardest();
    test_plan_domain();
    test_plan_blocks();
    test_plan_large();
    test_phase();
    test_beta();
    test_beta_corners();
    test_beta_inverse_of_small();
    test_beta_of_subnormal();
    test_beta_density();
    test_beta_moved();
    test_w_fraction();
    test_beta_domain();
    test_beta_limits();
    test_ln_beta();
    test_two_indices();
    test_means_and_integrals();
    test_mean_next_to_minus_1();
    test_monotone();
    test_last_digits();
    test_many_quarters();
    return check_finish("ateb.h");
}
