/* jacobi.h against arbitrary-precision tables, identities, closed forms and the edges of its domain. */
#include "../jacobi.h"
#include "check.h"
#include "least_powers.h"

static const int is_float = PRECISION[0] == 'f';
#if defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA)
enum { CONTRACTED = 1 };
#else
enum { CONTRACTED = 0 };
#endif

/* ---- Tables: absolute errors to |u| = 1e9 (float 1e4), relative ones to 100 K; make points has twenty times as many
   points in POINTS ---- */

typedef struct jacobi_row {
    const char *region;
    int complement; /* the parameter is m1 = 1 - m */
    double u, m, K, sn, sn_low, cn, cn_low, dn, dn_low;
} jacobi_row;

static const jacobi_row jacobi_table[] = {
#ifdef POINTS
#include "../build/points/jacobi_table.h"
#else
#include "data/jacobi_table.h"
#endif
};

static void check_three(const jacobi_row *row, int by_plan, vm_real sn, vm_real cn, vm_real dn)
{
    double m1 = row->complement ? row->m : 1 - row->m, largest_dn = m1 > 1 ? sqrt(m1) : 1;
    static const char *const names[2][3] = {{"sn", "cn", "dn"}, {"sn by plan", "cn by plan", "dn by plan"}};
    const char *const *name = names[by_plan];
    check_error(name[0], row->region, "eps", ERROR_EPS(sn, row->sn, row->sn_low, 1), 4, row->u, row->m);
    check_error(name[1], row->region, "eps", ERROR_EPS(cn, row->cn, row->cn_low, 1), 4, row->u, row->m);
    check_error(name[2], row->region, "eps", ERROR_EPS(dn, row->dn, row->dn_low, largest_dn), 4, row->u, row->m);
    if (fabs(row->u) > 100 * row->K) return;
    check_error(name[0], row->region, "ulp", ERROR_ULP(sn, row->sn, row->sn_low), 9, row->u, row->m);
    check_error(name[1], row->region, "ulp", ERROR_ULP(cn, row->cn, row->cn_low), 9, row->u, row->m);
    check_error(name[2], row->region, "ulp", ERROR_ULP(dn, row->dn, row->dn_low), 9, row->u, row->m);
}

static void test_table(void)
{
    size_t i;
    for (i = 0; i < sizeof jacobi_table / sizeof *jacobi_table; i++) {
        const jacobi_row *row = jacobi_table + i;
        const vm_real u = (vm_real)row->u, m = (vm_real)row->m;
        vm_real sn, cn, dn;
        jacobi_plan plan;
        if (!representable(row->u) || !representable(row->m)) continue;
        if (fabs(row->u) > row->K * (is_float ? 131072 : 1099511627776.0)) continue; /* K's words run out */
        if (row->complement) jacobi_sncndn_m1(u, m, &sn, &cn, &dn);
        else jacobi_sncndn(u, m, &sn, &cn, &dn);
        check_three(row, 0, sn, cn, dn);
        CHECK(row->complement || (jacobi_sn(u, m) == sn && jacobi_cn(u, m) == cn && jacobi_dn(u, m) == dn));
        CHECK((row->complement ? jacobi_plan_init_m1(&plan, m) : jacobi_plan_init(&plan, m)) == 0);
        jacobi_plan_sncndn(&plan, u, &sn, &cn, &dn);
        check_three(row, 1, sn, cn, dn);
    }
}

/* The twelve functions against quotients of the table's in two words, at zeros and poles too */
static void check_twelve(const jacobi_row *row)
{
    static const char *const name[12] = {"sn", "cn", "dn", "ns", "nc", "nd", "sc", "cs", "sd", "ds", "cd", "dc"};
    static const char theta[] = "scdn";
    const double high[4] = {row->sn, row->cn, row->dn, 1}, low[4] = {row->sn_low, row->cn_low, row->dn_low, 0};
    const vm_real u = (vm_real)row->u, m = (vm_real)row->m;
    const vm_real got[12] = {jacobi_sn(u, m), jacobi_cn(u, m), jacobi_dn(u, m), jacobi_ns(u, m),
                             jacobi_nc(u, m), jacobi_nd(u, m), jacobi_sc(u, m), jacobi_cs(u, m),
                             jacobi_sd(u, m), jacobi_ds(u, m), jacobi_cd(u, m), jacobi_dc(u, m)};
    int k;
    for (k = 0; k < 12; k++) {
        const int p = (int)(strchr(theta, name[k][0]) - theta), q = (int)(strchr(theta, name[k][1]) - theta);
        const double exact = high[p] / high[q];
        const double rest = (fma(-exact, high[q], high[p]) + (low[p] - exact * low[q])) / high[q];
        if (!(fabs(exact) <= (double)VM_MAX)) continue;
        check_error(name[k], "quotients", "ulp", ERROR_ULP(got[k], exact, rest), 8, row->u, row->m);
    }
}

static void test_quotient_table(void)
{
    size_t i;
    for (i = 0; i < sizeof jacobi_table / sizeof *jacobi_table; i++) {
        const jacobi_row *row = jacobi_table + i;
        if (!representable(row->u) || !representable(row->m) || row->complement) continue;
        if (fabs(row->u) <= 100 * row->K) check_twelve(row);
    }
}

static void test_amplitude_table(void)
{
    static const struct {
        const char *region;
        double u, m, am, am_low;
    } table[] = {
#ifdef POINTS
#include "../build/points/amplitude_table.h"
#else
#include "data/amplitude_table.h"
#endif
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const vm_real u = (vm_real)table[i].u, m = (vm_real)table[i].m;
        if (!representable(table[i].u) || !representable(table[i].m)) continue;
        check_error("am", table[i].region, "ulp", ERROR_ULP(jacobi_am(u, m), table[i].am, table[i].am_low), 8,
                    table[i].u, table[i].m);
    }
}

/* The solution of K(m) = c, where c is the K of the table, rounded: that moves it from the table's m by (c - K)/K'(m).
   What one ulp of c would move it is no error of the function. */
static void check_solve_K(const char *region, double m, double K, double K_low, double E)
{
    const vm_real c = (vm_real)K;
    const double slope = fabs(m) < 1e-4 ? 0.39269908 * (1 + 1.125 * m) : (E - (1 - m) * K) / (2 * m * (1 - m));
    const double moved = (((double)c - K) - K_low) / slope, by_one_ulp = ULP(K) / slope;
    const double error = fabs(((double)jacobi_solve_K(c) - m) - moved);
    check_error("solve_K", region, "ulp", fmax(0, error - by_one_ulp) / ULP(m), 4, (double)c, m);
}

/* E(m) for 0 < m < 0.97, by six steps of the arithmetic-geometric mean (DLMF 19.8.6) in long double */
static long double long_E(long double m)
{
    long double a = 1, b = sqrtl(1 - m), rest = 1 - m / 2, power = 1;
    int i;
    for (i = 0; i < 6; i++) {
        const long double half = (a - b) / 2;
        b = sqrtl(a * b);
        a -= half;
        rest -= power * half * half;
        power *= 2;
    }
    return acosl(-1) / 2 * rest / a;
}

/* The errors of E have both signs equally often, so that their mean is small. A low word that is left out, or has a wrong
   size, shows in the mean more than in the largest error. Where long double has no more digits than the type tested, the
   test is left out; valgrind, for one, computes with fewer digits than the compiler knows of. */
static void test_mean_error_of_E(void)
{
    const int n = 5000;
    volatile long double small = (long double)VM_EPSILON / 256;
    double sum = 0;
    int i;
    if (1 + small == 1) return;
    for (i = 0; i < n; i++) {
        const vm_real m = (vm_real)uniform(0, 0.97);
        const long double E = long_E((long double)m);
        sum += (double)((long double)jacobi_E(m) - E) / ULP((double)E);
    }
    check_error("E", "mean error", "ulp", fabs(sum) / n, 0.04, n, sum);
}

static void test_complete(void)
{
    static const struct {
        int complement;
        double m, K, K_low, E, E_low;
    } table[] = {
#ifdef POINTS
#include "../build/points/complete_table.h"
#else
#include "data/complete_table.h"
#endif
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const vm_real m = (vm_real)table[i].m;
        const char *region = table[i].complement ? "m1"
                             : table[i].m < -1   ? "m < -1"
                             : table[i].m < 0    ? "m < 0"
                                                 : "m > 0";
        if (!representable(table[i].m)) continue;
        check_error("K", region, "ulp",
                    ERROR_ULP(table[i].complement ? jacobi_K_m1(m) : jacobi_K(m), table[i].K, table[i].K_low), 2,
                    table[i].m, 0);
        check_error("E", region, "ulp",
                    ERROR_ULP(table[i].complement ? jacobi_E_m1(m) : jacobi_E(m), table[i].E, table[i].E_low), 2,
                    table[i].m, 0);
        if (table[i].complement || fabs(table[i].m) > 1e30) continue;
        check_error("k'K", region, "ulp", /* 1 - m and its root are rounded here: 2 ulp of the 5 */
                    ERROR_ULP(jacobi_kpK(m), sqrt(1 - table[i].m) * table[i].K, 0), 5, table[i].m, 0);
        check_error("K by AGM", region, "ulp", ERROR_ULP(jacobi_agm_K(m), table[i].K, table[i].K_low), 6,
                    table[i].m, 0);
        check_solve_K(region, table[i].m, table[i].K, table[i].K_low, table[i].E);
    }
    CHECK(jacobi_K(1) == VM_INFINITY && jacobi_E(1) == 1 && jacobi_agm_K(1) == VM_INFINITY && jacobi_kpK(1) == 0);
}

static void test_means(void)
{
    static const struct {
        double m, mean[3][2];
    } table[] = {
#ifdef POINTS
#include "../build/points/means_table.h"
#else
#include "data/means_table.h"
#endif
    };
    static const char *const name[3] = {"mean cn^2", "mean cn^4", "mean cn^6"};
    vm_real C[3];
    size_t i;
    int k;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        if (!representable(table[i].m)) continue;
        jacobi_cn_means((vm_real)table[i].m, C, C + 1, C + 2);
        for (k = 0; k < 3; k++)
            check_error(name[k], table[i].m < -1 ? "m < -1" : "m > -1", "ulp",
                        ERROR_ULP(C[k], table[i].mean[k][0], table[i].mean[k][1]), 8, table[i].m, 0);
    }
    jacobi_cn_means(0, C, C + 1, C + 2);
    CHECK(C[0] == (vm_real)0.5 && C[1] == (vm_real)0.375 && C[2] == (vm_real)0.3125);
    jacobi_cn_means(1, C, C + 1, C + 2);
    CHECK(C[0] == 0 && C[1] == 0 && C[2] == 0);
    jacobi_cn_means((vm_real)1.5, C, C + 1, C + 2);
    CHECK(isnan(C[0]) && isnan(C[1]) && isnan(C[2]));
}

/* ---- Identities ---- */

static void check_identities(double u, double m)
{
    const vm_real ur = (vm_real)u, mr = (vm_real)m;
    const double largest = m < 0 ? 1 - m : 1, kp = sqrt(1 - m);
    vm_real sn, cn, dn, s2, c2, d2, s3, c3, d3;
    double N, h = 0.37, K = (double)jacobi_K(mr);
    jacobi_sncndn(ur, mr, &sn, &cn, &dn);
    check_error("sn^2+cn^2-1", "random", "eps", ERROR_EPS(sn * sn + cn * cn, 1, 0, 1), 6, u, m);
    check_error("dn^2+m sn^2-1", "random", "eps", ERROR_EPS(dn * dn + mr * sn * sn, 1, 0, largest), 9, u, m);
    jacobi_sncndn(-ur, mr, &s2, &c2, &d2);
    CHECK(s2 == -sn && c2 == cn && d2 == dn);
    jacobi_sncndn((vm_real)h, mr, &s2, &c2,
                  &d2); /* addition theorem; u + h is rounded, an ulp of u times the slope */
    jacobi_sncndn(ur + (vm_real)h, mr, &s3, &c3, &d3);
    N = 1 - m * (double)(sn * sn) * (double)(s2 * s2);
    check_error("sn(u + v)", "random", "eps",
                ERROR_EPS(s3, ((double)sn * (double)c2 * (double)d2 + (double)s2 * (double)cn * (double)dn) / N, 0,
                          largest * (6 + fabs(u))),
                4, u, m);
    jacobi_sncndn(ur + (vm_real)K, mr, &s3, &c3, &d3); /* a quarter period, rounded as well */
    check_error("sn(u + K)", "random", "eps",
                ERROR_EPS(s3, (double)cn / (double)dn, 0, largest * (4 + fabs(u) + K)), 2, u, m);
    check_error("dn(u + K)", "random", "eps", ERROR_EPS(d3, kp / (double)dn, 0, largest * (4 + fabs(u) + K)), 2, u,
                m);
    if (m > 0) { /* Legendre's relation; Landen's transformation, m1 of the other kind m */
        const double E = (double)jacobi_E(mr), K1 = (double)jacobi_K_m1(mr), E1 = (double)jacobi_E_m1(mr);
        const double k1 = (1 - kp) / (1 + kp);
        check_error("Legendre", "random", "eps",
                    ERROR_EPS(E * K1 + E1 * K - K * K1, 1.5707963267948966, 6.1e-17, K * K1), 3, m, 0);
        jacobi_sncndn((vm_real)(u / (1 + k1)), (vm_real)(k1 * k1), &s2, &c2, &d2);
        check_error("Landen", "random", "eps",
                    ERROR_EPS(sn, (1 + k1) * (double)s2 / (1 + k1 * (double)(s2 * s2)), 0, 6 + fabs(u)), 3, u, m);
    } else { /* the imaginary modulus */
        jacobi_sncndn((vm_real)(u * kp), (vm_real)(-m / (1 - m)), &s2, &c2, &d2);
        check_error("imaginary modulus", "random", "eps",
                    ERROR_EPS(sn, (double)s2 / (kp * (double)d2), 0, 6 + kp * fabs(u)), 3, u, m);
    }
}

/* d sn/du = cn dn and its kin by differences; am as well, which never falls */
static void test_derivatives(void)
{
    const double h = is_float ? 0.01 : 1e-4, allowed = is_float ? 3e-4 : 3e-8;
    int i;
    for (i = 0; i < 2000; i++) {
        double u = (double)(vm_real)uniform(-6, 6), m = (double)(vm_real)uniform(-3, 1), step;
        vm_real sn, cn, dn, s1, c1, d1, s2, c2, d2, below = (vm_real)(u - h), above = (vm_real)(u + h);
        jacobi_sncndn((vm_real)u, (vm_real)m, &sn, &cn, &dn);
        jacobi_sncndn(below, (vm_real)m, &s1, &c1, &d1);
        jacobi_sncndn(above, (vm_real)m, &s2, &c2, &d2);
        step = (double)(above - below);
        check_error("sn' = cn dn", "random", "1", fabs((double)(s2 - s1) / step - (double)(cn * dn)), 4 * allowed,
                    u, m);
        check_error("cn' = -sn dn", "random", "1", fabs((double)(c2 - c1) / step + (double)(sn * dn)), 4 * allowed,
                    u, m);
        check_error("dn' = -m sn cn", "random", "1", fabs((double)(d2 - d1) / step + m * (double)(sn * cn)),
                    16 * allowed, u, m);
    }
}

static void test_amplitude(void)
{
    int i, rising = 1;
    for (i = 0; i < 20000; i++) {
        const double u = uniform(-40, 40), m = i % 3 ? uniform(0, 1) : uniform(-10, 0);
        const vm_real am = jacobi_am((vm_real)u, (vm_real)m);
        vm_real sn, cn, dn;
        jacobi_sncndn((vm_real)u, (vm_real)m, &sn, &cn, &dn);
        check_error("sin am - sn", "random", "eps", ERROR_EPS(sin((double)am), (double)sn, 0, 1 + fabs((double)am)),
                    4, u, m);
        check_error("cos am - cn", "random", "eps", ERROR_EPS(cos((double)am), (double)cn, 0, 1 + fabs((double)am)),
                    4, u, m);
        check_error("am - pi u/2K", "random", "1",
                    fabs((double)am - 1.5707963267948966 * u / (double)jacobi_K((vm_real)m)), 1.6, u, m);
        CHECK(jacobi_am(-(vm_real)u, (vm_real)m) == -am);
    }
    for (i = 0; i < 20000; i++) { /* where it rounds most */
        const vm_real u = (vm_real)uniform(0.2, 0.5), m = (vm_real)uniform(-40, -4), am = jacobi_am(u, m);
        check_error("am falls", "neighbours", "ulp",
                    (double)(am - jacobi_am(u * (1 + VM_EPSILON), m)) / ULP((double)am), 4, (double)u, (double)m);
    }
    for (i = 0; i < 40; i++) {
        const vm_real m = (vm_real)(i % 4 ? uniform(0, 1) : uniform(-30, 0)), K = jacobi_K(m);
        vm_real before = -VM_INFINITY, j, u;
        for (j = 0; j < 9; j++) { /* next to multiples of K and between */
            for (u = j * K * (1 - 20 * VM_EPSILON); u < j * K * (1 + 20 * VM_EPSILON);
                 u += K * VM_EPSILON * (1 + j)) {
                const vm_real am = jacobi_am(u, m);
                rising = rising && am >= before - 2 * VM_EPSILON * (1 + VM_FABS(am));
                before = am;
            }
            before = jacobi_am((j + (vm_real)0.5) * K, m);
        }
    }
    CHECK(rising);
    CHECK(jacobi_am(0, (vm_real)0.5) == 0);
    check_error("am(K) = pi/2", "m = 0.5", "ulp",
                ERROR_ULP(jacobi_am(jacobi_K((vm_real)0.5), (vm_real)0.5), (double)(VM_PI / 2), 0), 2, 0, 0.5);
    for (i = 0; i < 200; i++) { /* up to where u holds no phase and beyond */
        const vm_real u = (vm_real)uniform(1, 40) / VM_EPSILON;
        check_error("am = u", "m = 0", "ulp", ERROR_ULP(jacobi_am(u, 0), (double)u, 0), 2, (double)u, 0);
    }
    check_error("am = gd", "m = 1", "ulp", ERROR_ULP(jacobi_am(VM_INFINITY, 1), (double)(VM_PI / 2), 0), 1, 0, 1);
    CHECK(isnan(jacobi_am(1, 2)) && isnan(jacobi_am(VM_NAN, 0)));
}

/* pq = (pn)/(qn), zeros and poles included; one of the twelve by each pair */
static void test_quotients(void)
{
    int i;
    for (i = 0; i < 5000; i++) {
        const vm_real m = (vm_real)(i % 2 ? uniform(0, 1) : uniform(-20, 0));
        const vm_real u = i % 5 ? (vm_real)uniform(-10, 10) : jacobi_K(m) * (vm_real)(i % 7);
        vm_real sn, cn, dn;
        int k;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        {
            const vm_real got[12] = {jacobi_sn(u, m), jacobi_cn(u, m), jacobi_dn(u, m), jacobi_ns(u, m),
                                     jacobi_nc(u, m), jacobi_nd(u, m), jacobi_sc(u, m), jacobi_cs(u, m),
                                     jacobi_sd(u, m), jacobi_ds(u, m), jacobi_cd(u, m), jacobi_dc(u, m)};
            const vm_real expected[12] = {sn,      cn,      dn,      1 / sn,  1 / cn,  1 / dn,
                                          sn / cn, cn / sn, sn / dn, dn / sn, cn / dn, dn / cn};
            for (k = 0; k < 12; k++) {
                if (VM_FABS(expected[k]) == VM_INFINITY || expected[k] == 0)
                    CHECK(VM_FABS(got[k]) == VM_FABS(expected[k]));
                else
                    check_error("quotients", "random", "eps",
                                ERROR_EPS(got[k], (double)expected[k], 0, fabs((double)expected[k])), 4, (double)u,
                                (double)m);
            }
        }
    }
    CHECK(jacobi_ns(0, (vm_real)0.3) == VM_INFINITY && jacobi_cs(-(vm_real)0, (vm_real)0.3) == -VM_INFINITY);
    for (i = 0; i < 4; i++) { /* m = 1 where exp(-u) is 0 */
        const vm_real far[4] = {(vm_real)745, (vm_real)-1e5, VM_MAX, VM_INFINITY}, u = far[i];
        CHECK(jacobi_cd(u, 1) == 1 && jacobi_dc(u, 1) == 1 && jacobi_cn(u, 1) == 0 &&
              VM_FABS(jacobi_sn(u, 1)) == 1);
        CHECK(jacobi_ns(u, 1) == (u < 0 ? -1 : 1) && jacobi_cs(u, 1) == 0 && VM_FABS(jacobi_nd(u, 1)) > VM_MAX / 2);
    }
    CHECK(jacobi_nd(0, (vm_real)0.3) == 1 && jacobi_dc(0, (vm_real)0.3) == 1 && isnan(jacobi_cd(1, 3)));
}

static void test_identities(void)
{
    int i;
    for (i = 0; i < 20000; i++) check_identities(uniform(-20, 20), i % 2 ? uniform(0, 1) : uniform(-30, 1));
}

/* ---- Plans: arrays give the same bits; refusals leave the plan ---- */

/* Arguments next to a multiple jK, closer than random points come: m is the parameter for which jK is nearest to u. For
   even j the value is that of sn, for odd j that of cn, by mpmath with 60 digits. */
static void test_closest_to_zeros(void)
{
    static const struct {
        int j;
        double u, m, value;
    } rows[] = {
#if VM_MANT_DIG > 24
        {1, 0x1.921fbbdae4449p0, 0x1.0c6f7a0b1ecc3p-20, 2.7535370105253645617e-23},
        {2, 0x1.921fbbdae4449p1, 0x1.0c6f7a0b1ecc3p-20, 5.5070767745898046503e-23},
        {7, 0x1.5fdbc45f87bc0p3, 0x1.0c6f7a0b7bed0p-20, 4.456440926015000414e-23},
        {50, 0x1.3a28cac302559p6, 0x1.0c6f7a0b04b8cp-20, 1.1861345614524867945e-21},
        {99, 0x1.37048b4b4c8d1p7, 0x1.0c6f7a0ce5269p-20, -5.7137486951226621879e-22},
        {1, 0x1.921fb73e40009p0, 0x1.421f5f3eb163fp-22, -5.9882870567208230243e-24},
        {2, 0x1.921fb73e40009p1, 0x1.421f5f3eb163fp-22, -1.1976575909928166559e-23},
        {7, 0x1.5fdbc05678008p3, 0x1.421f5f4025e76p-22, 1.7514321970627237302e-23},
        {50, 0x1.3a28c728a2007p6, 0x1.421f5f3e49163p-22, -1.4032854688527731896e-22},
        {99, 0x1.370487ba25807p7, 0x1.421f5f3f35165p-22, -4.6469742670587621127e-22}
#else
        {1, 0x1.92224800p0, 0x1.a356ce00p-14, -1.2779566742757503423e-12},
        {2, 0x1.92224800p1, 0x1.a356ce00p-14, -2.5560411259763111489e-12},
        {7, 0x1.5fde0000p3, 0x1.a4110c00p-14, -7.4363292964715241283e-12},
        {50, 0x1.3a2ac800p6, 0x1.a322aa00p-14, 3.4901219445067395068e-11},
        {99, 0x1.37068400p7, 0x1.a398a600p-14, 2.4755882830607643578e-11},
        {1, 0x1.92207a00p0, 0x1.f4f80e00p-16, 5.64328967116041e-14},
        {2, 0x1.92207a00p1, 0x1.f4f80e00p-16, 1.1286747855159476904e-13},
        {7, 0x1.5fdc6c00p3, 0x1.f89b4e00p-16, 1.1305381574288474409e-12},
        {50, 0x1.3a296000p6, 0x1.f735b400p-16, -1.1157140593073969352e-11},
        {99, 0x1.37052000p7, 0x1.fa5ed200p-16, 2.1423921733887611355e-11},
        {50, 0x1.5f2bcc00p6, 0x1.78ac8800p-2, 1.9469742526351744055e-10}
#endif
    };
    static jacobi_plan plan;
    int i;
    for (i = 0; i < (int)(sizeof rows / sizeof *rows); i++) {
        const vm_real u = (vm_real)rows[i].u, m = (vm_real)rows[i].m;
        const double value = rows[i].value;
        const int odd = rows[i].j % 2;
        vm_real sn, cn, dn;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        check_error("next to jK", "sncndn", "ulp", ERROR_ULP(odd ? cn : sn, value, 0), 9, (double)u, (double)m);
        CHECK(jacobi_plan_init(&plan, m) == 0);
        jacobi_plan_sncndn(&plan, u, &sn, &cn, &dn);
        check_error("next to jK", "plan", "ulp", ERROR_ULP(odd ? cn : sn, value, 0), 9, (double)u, (double)m);
        jacobi_plan_sncndn_array(&plan, 1, &u, &sn, &cn, &dn);
        check_error("next to jK", "array", "ulp", ERROR_ULP(odd ? cn : sn, value, 0), 9, (double)u, (double)m);
    }
}

static void test_plans(void)
{
    enum { N = 257 };
    static const double parameter[] = {0.3, -0.5, 0.9, 0.999999, -20, -1e10, 1, 0};
    vm_real u[N], s[N], c[N], d[N], sn, cn, dn;
    jacobi_plan plan, kept;
    size_t k;
    int i, same = 1;
    for (k = 0; k < sizeof parameter / sizeof *parameter; k++) {
        const vm_real m = (vm_real)parameter[k];
        double longest = k == 5 ? 1e-4 : k % 2 ? 1e3 : 10;
        CHECK(jacobi_plan_init(&plan, m) == 0);
        for (i = 0; i < N; i++) u[i] = (vm_real)uniform(-longest, longest);
        u[0] = 0;
        u[1] = -(vm_real)0;
        jacobi_plan_sncndn_array(&plan, N, u, s, c, d);
        for (i = 0; i < N; i++) {
            jacobi_plan_sncndn(&plan, u[i], &sn, &cn, &dn);
            same = same && sn == s[i] && cn == c[i] && dn == d[i];
        }
        CHECK(s[0] == 0 && c[0] == 1 && d[0] == 1 && copysign(1, (double)s[1]) < 0);
        u[3] = VM_MAX;
        u[4] = VM_NAN;
        u[5] = VM_INFINITY; /* one such argument makes the loop go the long way */
        jacobi_plan_sncndn_array(&plan, N, u, s, c, d);
        CHECK(VM_FABS(s[3]) <= 1 && VM_FABS(c[3]) <= 1 && isnan(s[4]) && isnan(c[4]) && isnan(d[4]));
        CHECK(m == 1 ? s[5] == 1 && c[5] == 0 && d[5] == 0 : isnan(s[5]) && isnan(c[5]) && isnan(d[5]));
        for (i = 6; i < N; i++) {
            jacobi_plan_sncndn(&plan, u[i], &sn, &cn, &dn);
            same = same && sn == s[i] && cn == c[i] && dn == d[i];
        }
    }
    CHECK(same || CONTRACTED); /* contraction may differ from loop to loop */
    for (i = 0; i < 3; i++) { /* m1 = -0 is m1 = 0 */
        vm_real exact[3];
        jacobi_sncndn_m1((vm_real)i - 1, 0, exact, exact + 1, exact + 2);
        jacobi_sncndn_m1((vm_real)i - 1, -(vm_real)0, &sn, &cn, &dn);
        CHECK(sn == exact[0] && cn == exact[1] && dn == exact[2]);
        CHECK(jacobi_plan_init_m1(&plan, -(vm_real)0) == 0);
        jacobi_plan_sncndn(&plan, (vm_real)i - 1, &sn, &cn, &dn);
        CHECK(isfinite(sn) && isfinite(cn) && isfinite(dn));
    }
    kept = plan;
    CHECK(jacobi_plan_init(&plan, 2) < 0 && jacobi_plan_init(&plan, VM_NAN) < 0 &&
          jacobi_plan_init_m1(&plan, -1) < 0);
    CHECK(memcmp(&plan, &kept, sizeof plan) == 0);
}

/* ---- Far out: k' multiplies what the reduction leaves of u's phase. True values (mpmath), and the plan's ---- */

static void check_far(double u, double m1, double sn, double cn)
{
    const vm_real kp = VM_SQRT((vm_real)m1);
    const double top = kp > 1 ? (double)kp : 1;
    vm_real s, c, d, p_s, p_c, p_d;
    jacobi_plan plan;
    jacobi_plan_init_m1(&plan, (vm_real)m1);
    jacobi_sncndn_m1((vm_real)u, (vm_real)m1, &s, &c, &d);
    jacobi_plan_sncndn(&plan, (vm_real)u, &p_s, &p_c, &p_d);
    check_error("sn, far out", "by plan", "eps", ERROR_EPS(s, (double)p_s, 0, 1), 8, u, m1);
    check_error("cn, far out", "by plan", "eps", ERROR_EPS(c, (double)p_c, 0, 1), 8, u, m1);
    check_error("dn, far out", "by plan", "eps", ERROR_EPS(d, (double)p_d, 0, top), 8, u, m1);
    if (sn == 0) return;
    check_error("sn, far out", "m < -1e85", "eps", ERROR_EPS(s, sn, 0, 1), 4, u, m1);
    check_error("cn, far out", "m < -1e85", "eps", ERROR_EPS(c, cn, 0, 1), 4, u, m1);
}

static void test_far(void)
{
    const double longest = VM_MANT_DIG > 24 ? 1e9 : 1e4, most = VM_MANT_DIG > 24 ? 1e9 : 131072;
    const double size = VM_MANT_DIG > 24 ? 1e290 : 1e30;
    int i;
    if (representable(1.1259643796341058e+87)) {
        check_far(1.4871823851220019e-33, 1.1259643796341058e+87, 0.99996063659091773, 0.0088727261135774705);
        check_far(-2.6311726271857379e-34, 2.6911810008058163e+88, -0.97006289508605531, -0.24285382347671787);
    }
    for (i = 0; i < 20000; i++) {
        const vm_real m1 = (vm_real)pow(size, uniform(-1, 1)), K = jacobi_K_m1(m1);
        check_far(uniform(-1, 1) * fmin(longest, most * (double)K), (double)m1, 0, 0);
    }
}

/* ---- The route by the AGM: every step more brings it nearer, until the type's digits are reached ---- */

static void test_agm(void)
{
    int steps, i;
    double before = 1;
    for (steps = 1; steps < 9; steps++) {
        double worst = 0;
        for (i = 0; i < 500; i++) {
            const vm_real u = (vm_real)uniform(-4, 4), m = (vm_real)0.9;
            vm_real sn, cn, dn, s, c, d;
            jacobi_sncndn(u, m, &sn, &cn, &dn);
            jacobi_agm_sncndn(u, m, steps, &s, &c, &d);
            worst = fmax(worst, fmax(fabs((double)(s - sn)), fmax(fabs((double)(c - cn)), fabs((double)(d - dn)))));
        }
        CHECK(worst < fmax(before / 4, 30 * (double)VM_EPSILON));
        before = worst;
    }
    check_error("by AGM", "m = 0.9", "eps", before / (double)VM_EPSILON, 20, 0, 0.9);
    for (i = 0; i < 5000; i++) {
        const vm_real m = 1 - (vm_real)pow(10, uniform(is_float ? -6 : -15, 6));
        const vm_real u = (vm_real)uniform(-5, 5) * jacobi_K(m);
        const double M = fmax(1, sqrt(1 - (double)m));
        vm_real sn, cn, dn, s, c, d;
        if (m == 1) continue;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        jacobi_agm_sncndn(u, m, VMI_LADDER, &s, &c, &d);
        check_error("by AGM", "|u| < 5K", "eps M (1 + M |u|)",
                    fmax(fmax(fabs((double)(s - sn)), fabs((double)(c - cn))), fabs((double)(d - dn)) / M) /
                        (double)VM_EPSILON / M / (1 + M * fabs((double)u)),
                    3, (double)u, (double)m);
    }
}

static void test_closed_forms(void)
{
    int i;
    for (i = 0; i < 200; i++) {
        vm_real sn, cn, dn, u = (vm_real)uniform(-6, 6);
        jacobi_sncndn(u, 0, &sn, &cn, &dn);
        check_error("sn = sin", "m = 0", "eps", ERROR_EPS(sn, sin((double)u), 0, 1), 2, (double)u, 0);
        check_error("cn = cos", "m = 0", "eps", ERROR_EPS(cn, cos((double)u), 0, 1), 2, (double)u, 0);
        CHECK(dn == 1);
        jacobi_sncndn(u, 1, &sn, &cn, &dn);
        check_error("sn = tanh", "m = 1", "eps", ERROR_EPS(sn, tanh((double)u), 0, 1), 4, (double)u, 1);
        check_error("cn = sech", "m = 1", "eps", ERROR_EPS(cn, 1 / cosh((double)u), 0, 1), 4, (double)u, 1);
    }
    check_error("K(0) = pi/2", "m = 0", "ulp", ERROR_ULP(jacobi_K(0), (double)(VM_PI / 2), 0), 1, 0, 0);
    check_error("E(0) = pi/2", "m = 0", "ulp", ERROR_ULP(jacobi_E(0), (double)(VM_PI / 2), 0), 1, 0, 0);
}

static void test_solver_table(void)
{
    static const struct {
        double c, m1, m1_low, m, m_low;
    } table[] = {
#include "data/solver_table.h"
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        vm_real m, m1;
        if (!representable(table[i].c) || fabs(table[i].m) > (double)VM_MAX) continue;
        m = jacobi_solve_kpK((vm_real)table[i].c);
        m1 = jacobi_solve_kpK_m1((vm_real)table[i].c);
        check_error("solve_kpK_m1", "table", "ulp", ERROR_ULP(m1, table[i].m1, table[i].m1_low), 4, table[i].c, 0);
        check_error("solve_kpK", "table", "ulp", /* next to m = 0 what one ulp of c moves it */
                    ERROR_EPS(m, table[i].m, table[i].m_low, 1) * (double)VM_EPSILON /
                        fmax(ULP(table[i].m), (double)VM_EPSILON / 2),
                    4, table[i].c, 0);
    }
}

static void test_solver(void)
{
    double c;
    for (c = 1e-3; c < 40; c *= 1.07) {
        vm_real target = (vm_real)c, m = jacobi_solve_kpK(target), m1 = jacobi_solve_kpK_m1(target);
        check_error("k'K(solve_m1)", m < 0 ? "m < 0" : "m > 0", "ulp",
                    ERROR_ULP(VM_SQRT(m1) * jacobi_K_m1(m1), (double)target, 0), 8, c, (double)m);
        check_error("solve - solve_m1", m < 0 ? "m < 0" : "m > 0", "eps",
                    ERROR_EPS(m, 1 - (double)m1, 0, 1 + (double)m1), 2, c, (double)m);
        CHECK(m <= 1 && (m < 0) == (target > VM_PI / 2));
    }
    /* limits of (307), alpha -> infinity and alpha -> 0, and the cubic oscillator */
    check_error("solve_kpK", "R1", "eps", ERROR_EPS(jacobi_solve_kpK(1), 0.8061926420529121671171836, 0, 1), 4, 1,
                0);
    check_error("solve_kpK", "R1", "eps", ERROR_EPS(jacobi_solve_kpK(2), -1.807854731049967665276571, 0, 2), 4, 2,
                0);
    check_error("solve_kpK", "R1", "eps",
                ERROR_EPS(jacobi_solve_kpK((vm_real)1.3110287771460599052324198), 0.5, 0, 1), 4, 1.311, 0);
    CHECK(jacobi_kpK(1) == 0 && jacobi_solve_kpK(0) == 1 && jacobi_solve_kpK_m1(0) == 0);
    CHECK(jacobi_solve_kpK((vm_real)1e4) == -VM_INFINITY && jacobi_solve_kpK_m1((vm_real)1e4) == VM_INFINITY);
    for (c = 0.05; c < (is_float ? 40 : 350); c *= 1.07) { /* K = c, and the same by the other solver */
        vm_real target = (vm_real)c, m1 = jacobi_solve_K_m1(target);
        check_error("K(solve_K_m1)", m1 > 1 ? "m < 0" : "m > 0", "ulp",
                    ERROR_ULP(jacobi_K_m1(m1), (double)target, 0), 3, c, (double)m1);
        check_error("solve_K solve_kpK", "m1 m1' = 1", "eps", ERROR_EPS(m1 * jacobi_solve_kpK_m1(target), 1, 0, 1),
                    6, c, (double)m1);
        check_error("solve_K - solve_K_m1", "random", "eps",
                    ERROR_EPS(jacobi_solve_K(target), 1 - (double)m1, 0, 1 + (double)m1), 2, c, (double)m1);
    }
    CHECK(jacobi_solve_K(0) == -VM_INFINITY && jacobi_solve_K_m1(0) == VM_INFINITY);
    CHECK(jacobi_solve_K(VM_MAX) == 1 && jacobi_solve_K_m1(VM_MAX) == 0 &&
          jacobi_solve_kpK(VM_MAX) == -VM_INFINITY);
    CHECK(isnan(jacobi_solve_K(-1)) && isnan(jacobi_solve_K_m1(-1)) && isnan(jacobi_solve_K(VM_NAN)));
    for (c = 1; c > 0; c /= 3) { /* down to where k' is subnormal and cannot be moved by its step */
        vm_real m1 = jacobi_solve_kpK_m1((vm_real)c);
        if ((double)m1 > 1e6 * (is_float ? (double)FLT_MIN : DBL_MIN))
            check_error("k'K(solve_m1)", "c -> 0", "ulp",
                        ERROR_ULP(VM_SQRT(m1) * jacobi_K_m1(m1), (double)(vm_real)c, 0), 8, c, 0);
        CHECK(m1 >= 0 && m1 < 1);
    }
}

static void test_domain(void)
{
    const vm_real bad_m[] = {(vm_real)1.0001, VM_NAN, VM_INFINITY, -VM_INFINITY}, ok = (vm_real)0.5;
    const vm_real bad_u[] = {VM_NAN, VM_INFINITY, -VM_INFINITY};
    vm_real sn, cn, dn, largest = VM_MAX;
    int i, in_range = 1;
    for (i = 0; i < 3; i++) CHECK(isnan(jacobi_K(bad_m[i])) && isnan(jacobi_E(bad_m[i])));
    CHECK(jacobi_K(-VM_INFINITY) == 0 && jacobi_E(-VM_INFINITY) == VM_INFINITY); /* the limits */
    CHECK(jacobi_K_m1(VM_INFINITY) == 0 && jacobi_E_m1(VM_INFINITY) == VM_INFINITY);
    CHECK(isnan(jacobi_K_m1(-VM_INFINITY)) && isnan(jacobi_E_m1(-VM_INFINITY)));
    for (i = 0; i < 4; i++) {
        CHECK(jacobi_kpK(bad_m[i]) != jacobi_kpK(bad_m[i]));
        jacobi_sncndn(ok, bad_m[i], &sn, &cn, &dn);
        CHECK(sn != sn && cn != cn && dn != dn);
    }
    for (i = 0; i < 3; i++) {
        jacobi_sncndn(bad_u[i], ok, &sn, &cn, &dn);
        CHECK(sn != sn && cn != cn && dn != dn);
    }
    CHECK(jacobi_solve_kpK(-ok) != jacobi_solve_kpK(-ok) &&
          jacobi_solve_kpK(VM_INFINITY) != jacobi_solve_kpK(VM_INFINITY));
    CHECK(isnan(jacobi_solve_kpK_m1(VM_INFINITY)) && isnan(jacobi_solve_kpK_m1(-ok)) &&
          isnan(jacobi_solve_kpK(VM_NAN)));
    CHECK(isnan(jacobi_K_m1(-ok)) && isnan(jacobi_K_m1(VM_NAN)) && isnan(jacobi_E_m1(-ok)) &&
          isnan(jacobi_E_m1(VM_NAN)));
    jacobi_sncndn_m1(ok, -ok, &sn, &cn, &dn);
    CHECK(sn != sn && cn != cn && dn != dn);
    jacobi_sncndn_m1(ok, VM_INFINITY, &sn, &cn, &dn);
    CHECK(sn != sn && cn != cn && dn != dn);
    CHECK(jacobi_K(1) == VM_INFINITY && jacobi_E(1) == 1);
    jacobi_sncndn(jacobi_K(ok) * 2 / VM_EPSILON, ok, &sn, &cn,
                  &dn); /* from K/eps on there is no phase, before there is */
    CHECK(sn == 0 && cn == 1 && dn == 1);
    jacobi_sncndn(jacobi_K(ok) / 7 / VM_EPSILON, ok, &sn, &cn, &dn);
    CHECK(sn != 0);
    for (i = 0; i < 20; i++) { /* the largest |m| and periods about it */
        vm_real m = -largest * (1 - (vm_real)i * VM_EPSILON), root = VM_SQRT(largest);
        jacobi_sncndn(jacobi_K(m) * (vm_real)(0.3 + 0.35 * i), m, &sn, &cn, &dn);
        check_error("dn^2/m1-sn^2", "m = -VM_MAX", "eps",
                    ERROR_EPS(dn / root * (dn / root), (double)(sn * sn), 0, 1), 16, i, 0);
        check_error("sn^2+cn^2-1", "m = -VM_MAX", "eps", ERROR_EPS(sn * sn + cn * cn, 1, 0, 1), 12, i, 0);
    }
    jacobi_sncndn(0, ok, &sn, &cn, &dn);
    CHECK(sn == 0 && cn == 1 && dn == 1);
    jacobi_sncndn(-(vm_real)0, ok, &sn, &cn, &dn);
    CHECK(sn == 0 && copysign(1, (double)sn) < 0);
    for (i = 0; i < 2000; i++) { /* no phase left, still in range */
        vm_real u = largest * (vm_real)uniform(-1, 1), m = (vm_real)uniform(-5, 1), kp = VM_SQRT(1 - m);
        jacobi_sncndn(i % 2 ? u : (vm_real)uniform(-50, 50), m, &sn, &cn, &dn);
        in_range = in_range && VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn <= (kp > 1 ? kp : 1) &&
                   dn >= (kp > 1 ? 1 : kp);
    }
    for (i = 0; i < 20000; i++) { /* next to quarter and half periods, where rounding could lead outside */
        vm_real m = (vm_real)(i % 2 ? uniform(0, 1) : uniform(-30, 0)), kp = VM_SQRT(1 - m);
        vm_real u = jacobi_K(m) * (vm_real)(i % 5) * (1 + (vm_real)uniform(-4, 4) * VM_EPSILON);
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        in_range = in_range && VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn <= (kp > 1 ? kp : 1) &&
                   dn >= (kp > 1 ? 1 : kp);
    }
    CHECK(in_range);
    jacobi_sncndn(VM_EPSILON * VM_EPSILON, 1, &sn, &cn, &dn); /* tanh of small numbers */
    CHECK(sn == VM_EPSILON * VM_EPSILON && cn == 1 && dn == 1);
    jacobi_sncndn((vm_real)1e-3, -largest / 2, &sn, &cn, &dn);
    CHECK(VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn >= 1);
}

/* The kernels that ateb.h has, too, and what only varmass.h asks for, where this header stands alone. libm's double
   is the judge: of float, and of double to an ulp of its own */
static void test_kernels(void)
{
    const vm_real values[4] = {0, VM_C(-0.0), VM_C(1.5), VM_C(-2.5)};
    const double least = log(ldexp(1, is_float ? FLT_MIN_EXP : DBL_MIN_EXP));
    const vm_two third = vmi_two_over(vmi_two(1, 0), vmi_two(3, 0));
    const vm_two rest = vmi_two_plus(vmi_two_times(third, vmi_two(3, 0)), vmi_two(-1, 0));
    int i, k;
    for (i = 0; i < 4; i++)
        for (k = 0; k < 4; k++) {
            const double wanted = copysign((double)values[i], (double)values[k]);
            const double got = (double)vmi_copysign(values[i], values[k]);
            CHECK(got == wanted && !signbit(got) == !signbit(wanted));
        }
    CHECK(vmi_sum_of_products(1, 1, VM_EPSILON / 4, VM_C(1.5)) == 1); /* the low words change nothing */
    CHECK(vmi_ldexp(1, 30000) == VM_INFINITY && vmi_ldexp(1, -30000) == 0);
    for (i = 0; i < 200; i++) { /* down to subnormal results */
        const vm_real x = (vm_real)(i ? uniform(least - 2, least + 1) : least), base = (vm_real)uniform(0.1, 10);
        const vm_real y = (vm_real)uniform(-30, 30);
        check_error("exp", "towards 0", "ulp", ERROR_ULP(vmi_exp(x, 0), exp((double)x), 0), 2, (double)x, 0);
        check_error("pow", "", "ulp",
                    ERROR_ULP(vmi_pow_two(vmi_two(base, 0), vmi_two(y, 0)), pow((double)base, (double)y), 0), 2,
                    (double)base, (double)y);
    }
    CHECK(isnan((double)vmi_exp(VM_NAN, 0)));
    /* quarters too large to be split */
    CHECK(vmi_reduce(VM_MAX / 2, vmi_two(VM_MAX / 8, 0), &k).hi == 0 && k == 0);
    CHECK(VM_FABS(vmi_reduce(VM_MAX / 4 * 3, vmi_two(VM_MAX / 4, 0), &k).hi) < VM_MAX * VM_EPSILON && k == 3);
    CHECK(fabs((double)(rest.hi + rest.lo)) < 32 * (double)VM_EPSILON * (double)VM_EPSILON);
    CHECK(vmi_nearest(VM_C(2.6)) == 3 && vmi_nearest(VM_C(-2.6)) == -3 && vmi_nearest(VM_NAN) == 0);
}

/* Returns x - a b, rounded once, if the rounded product a b lies between x/2 and 2 x. Dekker's product gives the rounding error
   of a b; fma would do the same, but is not exact in the C library of mingw. */
static double minus_product(double x, double a, double b)
{
    const double split = 134217729; /* 2^27 + 1 */
    /* volatile rounds these products also where a compiler fuses products and sums */
    volatile double large_a = split * a, large_b = split * b, product = a * b;
    const double a1 = large_a - (large_a - a), a2 = a - a1, b1 = large_b - (large_b - b), b2 = b - b1;
    const double rest = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
    return (x - product) - rest;
}

/* The reduction by a quarter period q of any size. Where x/q has so few digits that its rounding changes the count of
   quarters, the remainder must be reduced once more. */
static void test_reduction_by_any_quarter(void)
{
    static const double quarters[6] = {1.3e-6, 0.011, 0.3, 0.77, 5.5, 1.7e6};
    int i, j;
    for (i = 0; i < 6; i++)
        for (j = 0; j < 2000; j++) {
            const vm_real q = (vm_real)quarters[i];
            const double many = ldexp(uniform(0.25, 0.5), j % 8) / 130 / (double)VM_EPSILON, x = (double)((vm_real)many * q);
            int quarter;
            const vm_two r = vmi_reduce((vm_real)x, vmi_two(q, 0), &quarter);
            const double count = floor((x - (double)r.hi) / (double)q + 0.5);
            CHECK(fabs((double)r.hi) <= 0.5011 * (double)q && quarter == (int)fmod(count, 4));
            CHECK(fabs((minus_product(x, count, (double)q) - (double)r.hi) - (double)r.lo) <= 1e-30 * x);
        }
}

/* The quarter period by the table, at both ends of each piece and inside, against the mean in three words */
static void test_period_table(void)
{
    const double unit = ldexp(1, PRECISION[0] == 'f' ? -36 : -71);
    int row, i;
    for (row = 0; row < VMI_PERIOD_ROWS; row++)
        for (i = 0; i <= 64; i++) {
            const double share = i < 64 ? i / 64. : 1 - 4 * (double)VM_EPSILON;
            const vm_real start = (vm_real)ldexp(1 + ((row + 3) % 8 + share) / 8, (row + 3) / 8 - 3);
            const vm_real m1 = start * start, kp = VM_SQRT(m1);
            const vmi_three wanted = vmi_K_three_words(m1, 0);
            vmi_period K;
            vm_real error;
            if (!VMI_IN_PERIOD_TABLE(kp)) continue; /* rounded up to the end of the table */
            K = vmi_period_by_table(m1, 0, kp);
            error = (((K.head - wanted.hi) + K.middle) + (K.low - wanted.mid)) - wanted.lo;
            check_error("K", "by its table", "2^-71 or 2^-36", fabs((double)(error / wanted.hi)) / unit, 1, (double)kp, row);
        }
}

/* R_F does not depend on the order of its arguments: R_F(0, 1, 2) [1, 19.20.2], and where one of three is apart by as
   much as the series takes */
static void test_carlson(void)
{
    const vm_real apart = VM_C(2.25) * VM_SQRT(VM_SQRT(VM_EPSILON));
    const vm_real arguments[2][3] = {{0, 1, 2}, {1, 1, 1 + apart}};
    const double d = (double)arguments[1][2] - 1;
    const double wanted[2] = {1.31102877714605990523, 1 - d / 6 + d * d * 3 / 40 - d * d * d * 5 / 112};
    int i, k;
    for (i = 0; i < 2; i++)
        for (k = 0; k < 6; k++) {
            const vm_real *a = arguments[i];
            const vm_two x = vmi_two(a[k % 3], 0), y = vmi_two(a[(k % 3 + 1 + k / 3) % 3], 0),
                         z = vmi_two(a[(k % 3 + 2 - k / 3) % 3], 0);
            check_error("R_F", "any order", "eps", ERROR_EPS(vmi_carlson_rf(x, y, z).hi, wanted[i], 0, 1), 2, i, k);
        }
}

/* Where the count of quarters takes all digits: no phase is promised there, but the functions stay in range, and of
   one phase, those of a plan too */
static void test_last_digits(void)
{
    int i, in_range = 1;
    for (i = 0; i < 16000; i++) {
        const vm_real m = (vm_real)uniform(-3, 1);
        const vm_real size = jacobi_K(m) * (vm_real)ldexp(uniform(1, 2), VM_MANT_DIG - 8 + i % 8);
        const vm_real u = i % 16 < 8 ? size : -size;
        vm_real sn, cn, dn;
        jacobi_plan plan;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        in_range = in_range && VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1;
        check_error("sn^2+cn^2-1", "u to 2 K/eps", "eps", fabs((double)(sn * sn + cn * cn - 1)) / (double)VM_EPSILON, 8,
                    (double)u, (double)m);
        CHECK(jacobi_plan_init(&plan, m) == 0);
        jacobi_plan_sncndn(&plan, u, &sn, &cn, &dn);
        check_error("sn^2+cn^2-1", "u to 2 K/eps, by plan", "eps",
                    fabs((double)(sn * sn + cn * cn - 1)) / (double)VM_EPSILON, 8, (double)u, (double)m);
    }
    CHECK(in_range);
}

/* u so large that its last digits are about as long as K: sn and cn still belong to one angle. */
static void test_largest_arguments(void)
{
    int i;
    for (i = 0; i < 200000; i++) {
        const vm_real m = (vm_real)(i % 3 ? uniform(0, 1) : -pow(10, uniform(0, 6)));
        const vm_real u = (vm_real)((double)jacobi_K(m) / (double)VM_EPSILON * pow(2, uniform(-5, 1)));
        vm_real sn, cn, dn;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        check_error("sn^2 + cn^2 = 1", "u to 2K/eps", "eps",
                    fabs((double)sn * (double)sn + (double)cn * (double)cn - 1) / (double)VM_EPSILON, 8, (double)u,
                    (double)m);
    }
}

int main(void)
{
    check_least_powers();
    test_table();
    test_quotient_table();
    test_amplitude_table();
    test_complete();
    test_mean_error_of_E();
    test_means();
    test_identities();
    test_derivatives();
    test_amplitude();
    test_quotients();
    test_closest_to_zeros();
    test_plans();
    test_far();
    test_agm();
    test_closed_forms();
    test_solver();
    test_solver_table();
    test_domain();
    test_kernels();
    test_reduction_by_any_quarter();
    test_period_table();
    test_carlson();
    test_last_digits();
    test_largest_arguments();
    return check_finish("jacobi.h");
}
