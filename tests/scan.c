/* The largest errors of jacobi.h and ateb.h, region by region, at millions of random arguments, against quadruple
   precision (gcc's libquadmath). The tests' tables have fewer points, but more digits.

   usage: scan POINTS [SEED] */
#include <stdlib.h>
#include "../ateb.h"
#include "../jacobi.h"
#include "check.h"
#include "quad.h"

static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

static double uniform48(double low, double high) { return low + (high - low) * drand48(); }
static double log_uniform(double low, double high) { return pow(10, uniform48(low, high)); }
static double ulps(vm_real got, quad exact)
{
    return (double)(fabsq((quad)got - exact) / (quad)ULP((double)exact));
}

/* ---- Jacobi ---- */

/* The functions that are called directly and those of a plan, in turns */
static void scan_jacobi(const char *region, double m, double u)
{
    static int by_plan;
    vm_real mr = (vm_real)m, ur = (vm_real)u, sn, cn, dn;
    quad m1 = 1 - (quad)mr, s, c, d, turns, sign;
    quad E, Kq = quarter_period(m1 > 0 ? m1 : 1, &E);
    double K = (double)Kq, largest = fmax(1, sqrt((double)m1)), own;
    jacobi_plan plan;
    if (m1 <= 0) return;
    check_error("K", region, "ulp", ulps(jacobi_K(mr), Kq), 2, (double)mr, 0);
    if (m < 0.999) check_error("E", region, "ulp", ulps(jacobi_E(mr), E), 2, (double)mr, 0); /* the sum cancels */
    if (fabs((double)ur) * eps > K) return;
    sncndn(ur, m1, &s, &c, &d);
    by_plan = !by_plan;
    jacobi_plan_init(&plan, mr);
    if (by_plan) jacobi_plan_sncndn(&plan, ur, &sn, &cn, &dn);
    else jacobi_sncndn(ur, mr, &sn, &cn, &dn);
    check_error("sn", region, "eps", (double)fabsq(sn - s) / eps, 4, (double)ur, (double)mr);
    check_error("cn", region, "eps", (double)fabsq(cn - c) / eps, 4, (double)ur, (double)mr);
    check_error("dn", region, "eps", (double)fabsq(dn - d) / eps / largest, 4, (double)ur, (double)mr);
    if (fabs((double)ur) > 100 * K) return;
    own = (is_float ? 3e-17 : 2e-32) * fabs((double)ur) * largest; /* of K in float's words, of the reference */
    check_error("sn", region, "ulp", fmax(0, ulps(sn, s) - own / ULP((double)s)), 9, (double)ur, (double)mr);
    check_error("cn", region, "ulp", fmax(0, ulps(cn, c) - own / ULP((double)c)), 9, (double)ur, (double)mr);
    check_error("dn", region, "ulp", ulps(dn, d), 9, (double)ur, (double)mr);
    if (by_plan) return;
    turns = rintq(ur / (2 * Kq));
    sign = fmodq(turns, 2) != 0 ? -1 : 1;
    check_error("am", region, "ulp", ulps(jacobi_am(ur, mr), turns * M_PIq + atan2q(sign * s, sign * c)), 8,
                (double)ur, (double)mr);
}

/* Where one form or series gives way to another: u about multiples of K/2, next to them and up to 10 % off, for m
   about the edges of the theta functions, of the middle of K, about 0 and -1, and very negative with u large */
static void scan_seams(double largest)
{
    static const double edge[] = {0.05, 20, 0.029, 34.5, 1, 2};
    const double apart = (drand48() < 0.5 ? 1 : -1) * log_uniform(-15, -1), half = floor(uniform48(1, 20)) / 2;
    const double m1 = edge[(int)(6 * drand48())] * (1 + uniform48(-0.1, 0.1));
    vm_real m = (vm_real)(1 - m1);
    quad E;
    scan_jacobi("seams", (double)m, half * (1 + apart) * (double)quarter_period(1 - (quad)m, &E));
    scan_jacobi("seams", (double)m, uniform48(-2, 2) * (double)quarter_period(1 - (quad)m, &E));
    m = (vm_real)(floor(2 * drand48()) - 1 + apart);
    scan_jacobi("m near 0, -1", (double)m, half * (1 + apart) * (double)quarter_period(1 - (quad)m, &E));
    scan_jacobi("m near 0, -1", (double)m, uniform48(-100, 100) * (double)quarter_period(1 - (quad)m, &E));
    scan_jacobi("m << -1, far", -log_uniform(1, 5), uniform48(-largest, largest));
}

/* u = j K +- v with v just above a power of two, where an ulp of v is largest, relative to v. Where sn(v) or sd(v) lies
   just below that power, an ulp of the result is smallest, so that the same relative error is twice as many ulp. This
   meets most errors for m a little below 0, v about 1/2 and odd j, where cn(u) = -k' sd(v) has the error of k' too. */
static void scan_binades(void)
{
    const double m[3] = {-log_uniform(-6, -1), uniform48(-0.3, 0.3), -log_uniform(-1, 1.5)};
    const double v[3] = {0.5, 0.25, 0.125}, j = floor(uniform48(0, 50));
    int i;
    for (i = 0; i < 3; i++) {
        const vm_real mr = (vm_real)m[i];
        const double side = (drand48() < 0.5 ? -1 : 1) * (1 + uniform48(0, 0.05));
        quad E, K = quarter_period(1 - (quad)mr, &E);
        scan_jacobi("v > 1/2, j odd", (double)mr, (double)((2 * j + 1) * K + side * v[0]));
        scan_jacobi("v above 2^-n", (double)mr, (double)((j + i) * K + side * v[i]));
    }
}

/* The root of k' K1(k') = c next to the kit's answer, by Newton's method with a difference quotient. What one ulp of c
   moves m and m1 is taken off the errors. */
static void scan_solver(double c)
{
    vm_real cr = (vm_real)c, m = jacobi_solve_kpK(cr), m1 = jacobi_solve_kpK_m1(cr);
    quad kp = sqrtq(m1), slope = 1, E, exact;
    double moved;
    int i;
    for (i = 0; i < 4; i++) {
        quad h = 1e-15Q * kp, f = kp * quarter_period(kp * kp, &E);
        slope = ((kp + h) * quarter_period((kp + h) * (kp + h), &E) - f) / h;
        kp -= (f - cr) / slope;
    }
    moved = (double)fabsq(2 * kp / slope) * ULP((double)cr);
    exact = 1 - kp * kp;
    check_error("solve_kpK_m1", "0 < c < 40", "ulp", fmax(0, ulps(m1, kp * kp) - moved / ULP((double)m1)), 4,
                (double)cr, 0);
    check_error("solve_kpK", "0 < c < 40", "ulp", fmax(0, ulps(m, exact) - moved / ULP((double)exact)), 4,
                (double)cr, 0);
}

/* ---- Elliptic integrals ---- */

/* phi of one of four kinds: inside the first quarter, in the second one, far, next to the end of the quarter or, for
   m > 1, next to the angle where the integrals end */
static vm_real some_phi(int kind, double end)
{
    const double apart = log_uniform(-8, -1);
    if (kind == 0) return (vm_real)(end * (drand48() < 0.5 ? drand48() : log_uniform(-3, 0)));
    if (kind == 1) return (vm_real)(end * (1 - apart));
    if (end < 1.57) return (vm_real)(end * drand48());
    if (kind == 2) return (vm_real)uniform48(1.5709, 3.1415);
    return (vm_real)(drand48() < 0.5 ? uniform48(0, 30) : end * (1 + apart));
}

/* Compares F, E, D and Pi at phi, n and the parameter m, or at m1 where `by_m1` is 1. */
static void scan_integrals(const char *region, vm_real phi, vm_real n, vm_real m, vm_real m1, int by_m1)
{
    const quad exact_m1 = by_m1 ? (quad)m1 : 1 - (quad)m;
    const double parameter = (double)(by_m1 ? m1 : m);
    const quad s = sinq(phi);
    if (n == 1 || exact_m1 == 0 || 1 - (1 - exact_m1) * s * s <= 0) return;
    check_error("F(phi)", region, "ulp",
                ulps(by_m1 ? jacobi_F_m1(phi, m1) : jacobi_F(phi, m), elliptic_integral('F', phi, 0, exact_m1)), 8,
                (double)phi, parameter);
    check_error("E(phi)", region, "ulp",
                ulps(by_m1 ? jacobi_E_incomplete_m1(phi, m1) : jacobi_E_incomplete(phi, m),
                     elliptic_integral('E', phi, 0, exact_m1)), 8, (double)phi, parameter);
    check_error("D(phi)", region, "ulp",
                ulps(by_m1 ? jacobi_D_incomplete_m1(phi, m1) : jacobi_D_incomplete(phi, m),
                     elliptic_integral('D', phi, 0, exact_m1)), 8, (double)phi, parameter);
    check_error(n < 0 ? "Pi(phi), n < 0" : "Pi(phi)", region, "ulp",
                ulps(by_m1 ? jacobi_Pi_incomplete_m1(phi, n, m1) : jacobi_Pi_incomplete(phi, n, m),
                     elliptic_integral('P', phi, n, exact_m1)), 8, (double)phi, (double)n);
    if (exact_m1 < 0) return;
    check_error("complete D", region, "ulp",
                ulps(by_m1 ? jacobi_D_m1(m1) : jacobi_D(m), elliptic_part('D', 1, 0, 0, exact_m1)), 8, parameter, 0);
    check_error(n < 0 ? "complete Pi, n < 0" : "complete Pi", region, "ulp",
                ulps(by_m1 ? jacobi_Pi_m1(n, m1) : jacobi_Pi(n, m), elliptic_part('P', 1, 0, n, exact_m1)), 8,
                (double)n, parameter);
}

/* Carlson's integrals of arguments between 10^-size and 10^size, one time in five with a zero */
static void scan_carlson(const char *region, double size)
{
    const vm_real x = drand48() < 0.2 ? 0 : (vm_real)log_uniform(-size, size), y = (vm_real)log_uniform(-size, size);
    const vm_real z = (vm_real)log_uniform(-size, size), p = (vm_real)log_uniform(-size, size);
    check_error("R_F", region, "ulp", ulps(jacobi_RF(x, y, z), carlson_rf(x, y, z)), 8, (double)x, (double)y);
    check_error("R_C", region, "ulp", ulps(jacobi_RC(x, y), carlson_rf(x, y, y)), 8, (double)x, (double)y);
    check_error("R_D", region, "ulp", ulps(jacobi_RD(x, y, z), carlson_rj(x, y, z, z)), 8, (double)x, (double)y);
    check_error("R_J", region, "ulp", ulps(jacobi_RJ(x, y, z, p), carlson_rj(x, y, z, p)), 8, (double)x, (double)y);
}

/* The integrals at a random phi and n for each region of m */
static void scan_all_integrals(void)
{
    static const char *region[] = {"0 < m < 1", "m < 0",     "m << 0", "m near 1",
                                   "m above 1", "1 < m < 5", "m >> 1", "m1"};
    const double most = is_float ? 20 : 30;
    const double m[] = {drand48(), -log_uniform(-3, 3), -log_uniform(3, most), 1 - log_uniform(-7, -1),
                        1 + log_uniform(-6, -1), uniform48(1.001, 5), log_uniform(0.5, most), 0.5};
    const double n[] = {drand48(), -log_uniform(-6, 6), 1 - log_uniform(-6, -1)};
    int i;
    for (i = 0; i < 8; i++) {
        const vm_real parameter = (vm_real)m[i], m1 = (vm_real)log_uniform(-30, 0);
        const double end = parameter > 1 ? asin(1 / sqrt((double)parameter)) : acos(0);
        scan_integrals(region[i], some_phi((int)(4 * drand48()), end), (vm_real)n[(int)(3 * drand48())], parameter, m1,
                       i == 7);
    }
}

/* ---- Ateb ---- */

/* The errors in eps for any s, and in ulp as far as |s| < 100 Pi. pi_error is the error of Pi_alpha, by its size. */
static void compare_ateb(const char *functions[2], const char *region, const vm_real got[2], const quad exact[2],
                         double eps_bound, double ulp_bound, double pi_error, double s, double alpha, double pi)
{
    const double moved = (pi_error + 1e-31) * fabs(s); /* 1e-31: the reference's own */
    int i;
    for (i = 0; i < 2; i++) {
        const double slope = i == 0 ? 1 : 2 / (alpha + 1);
        check_error(functions[i], region, "eps", (double)fabsq(got[i] - exact[i]) / eps, eps_bound, s, alpha);
        if (fabs(s) > 100 * pi) continue;
        check_error(functions[i], region, "ulp",
                    fmax(0, ulps(got[i], exact[i]) - slope * moved / ULP((double)exact[i])), ulp_bound, s, alpha);
    }
}

static void scan_ateb(const char *region, double alpha, double s)
{
    static const char *any[2] = {"sa", "ca"}, *prepared[2] = {"plan sa", "plan ca"};
    const vm_real ar = (vm_real)alpha, sr = (vm_real)s;
    vm_real got[2];
    quad exact[2], pi;
    ateb_plan plan;
    saca(sr, ar, exact, exact + 1, &pi);
    check_error("Pi", region, "ulp", ulps(ateb_pi(ar), pi), 1, (double)ar, 0);
    ateb_saca(sr, ar, got, got + 1);
    compare_ateb(any, region, got, exact, 4, 8, 0, (double)sr, (double)ar, (double)pi);
    ateb_plan_init(&plan, ar);
    ateb_plan_saca(&plan, sr, got, got + 1);
    compare_ateb(prepared, region, got, exact, 2, 2, is_float ? 2.3e-13 : 0, (double)sr, (double)ar,
                 (double)pi); /* a float plan has Pi_alpha in two words, known to 2^-42 */
}

int main(int argc, char **argv)
{
    const double largest = is_float ? 1e4 : 1e9;
    long points = argc > 1 ? atol(argv[1]) : 100000, i;
    srand48(argc > 2 ? atol(argv[2]) : 1);
    for (i = 0; i < points; i++) {
        double m = drand48(), K, alpha, half, part;
        quad E;
        scan_jacobi("|u| < 10", m, uniform48(-10, 10));
        scan_jacobi("m < 0", -log_uniform(-4, 6), uniform48(-10, 10));
        scan_jacobi("m near 1", 1 - log_uniform(-16, -1), uniform48(-100, 100));
        scan_jacobi("|u| large", uniform48(-5, 1), uniform48(-largest, largest));
        scan_seams(largest);
        scan_binades();
        m = (double)(vm_real)(i % 2 ? m : 1 - log_uniform(-4, 4));
        K = (double)quarter_period(1 - (quad)m, &E);
        scan_jacobi("u near jK", m,
                    K * floor(uniform48(1, 100)) * (1 + (is_float ? 1e-7 : 2e-16) * uniform48(-4, 4)));
        if (i % 10) continue;                            /* these are slow */
        part = fmod((double)i * 0.06180339887498949, 1); /* equidistributed */
        scan_all_integrals();
        scan_carlson("alike", 0.3);
        scan_carlson("to 1e7", 7);
        scan_solver(i % 20 ? 0.5 + 2.5 * part : pow(10, 4.6 * part - 3));
        scan_ateb("2 alpha = 0, 1, ..., 14", (double)(i / 10 % 15) / 2, uniform48(-30, 30));
        alpha = (double)(vm_real)log_uniform(-4, 6);
        half = (double)ateb_pi((vm_real)alpha) / 2;
        scan_ateb("first quarter", alpha, uniform48(0, half));
        scan_ateb("s < 3", alpha, uniform48(0, 3));
        scan_ateb("alpha < 10", uniform48(0, 10), uniform48(-30, 30));
        scan_ateb("|s| < 100 Pi", alpha, uniform48(-200, 200) * half);
        scan_ateb("|s| large", alpha, uniform48(-largest, largest));
        scan_ateb("s near j Pi/2", alpha,
                  half * floor(uniform48(1, 200)) * (1 + (is_float ? 1e-7 : 2e-16) * uniform48(-4, 4)));
    }
    return check_finish("scan");
}
