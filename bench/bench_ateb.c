/* ateb.h: time of a call in units of the C library's sin (float: sinf) and the largest absolute error (of Pi and
   the beta functions the largest relative one) against quadruple precision; sa and ca of any alpha, of a prepared
   one to three accuracies, one by one and as arrays. Beside them GSL, which has the inverse of the beta
   distribution function: one call for the smaller of sa^2 and 1 - sa^2, then a root and a power; Pi_alpha is made
   ready as a plan has it. */
#include "timing.h"
#include "../ateb.h"
#include "arguments.h"
#include "exact.h"
#if defined(WITH_GSL) && !defined(VM_USE_FLOAT)
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf.h>
#define GSL 1
#else
#define GSL 0
#endif

enum { LEVELS = 3, CHECKED = 512 };
static const double accuracies[LEVELS] = {0, 1e-8, 1e-4};
static const char *const accuracy_names[LEVELS] = {"", "1e-8", "1e-4"};
static ateb_plan plan;

/* ---- Routes ---- */

BODY(pi, a = ateb_pi(m))
BODY(saca, ateb_saca(u, m, &a, &b))
BODY(plan, ateb_plan_saca(&plan, u, &a, &b))
APART(making, ateb_plan_init(&plan, m); a = plan.g)
APART(phase, a = ateb_phase(u, w, m))
APART(mean, a = ateb_mean(m, w, 1))
APART(beta, a = ateb_beta(m, w))
APART(inc, a = ateb_beta_inc(u, m, w))
APART(inv, a = ateb_beta_inc_inv(u, m, w))
APART(nm, ateb_saca_nm(u, m, w, &a, &b))

static void array(void)
{
    static vm_real sa[ARRAY], ca[ARRAY];
    ateb_plan_saca_array(&plan, ARRAY, arg + next_of(ARRAY), sa, ca);
    sink = sa[0] + ca[ARRAY - 1];
}

static void by_plan(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca)
{
    (void)alpha;
    ateb_plan_saca(&plan, s, sa, ca);
}
static void by_saca(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca) { ateb_saca(s, alpha, sa, ca); }

static vm_real beta_of(vm_real x, vm_real a, vm_real b)
{
    (void)x;
    return ateb_beta(a, b);
}
static vm_real inc_of(vm_real x, vm_real a, vm_real b) { return ateb_beta_inc(x, a, b); }
static vm_real inv_of(vm_real p, vm_real a, vm_real b) { return ateb_beta_inc_inv(p, a, b); }

#if GSL
static double gsl_pi;

static void by_gsl(double s, double alpha, double *sa, double *ca)
{
    const double turned = fmod(fabs(s), 2 * gsl_pi), t = turned > gsl_pi ? 2 * gsl_pi - turned : turned;
    const double p = (t > gsl_pi / 2 ? gsl_pi - t : t) / (gsl_pi / 2), q = 1 / (alpha + 1);
    const double x = p < 0.5 ? gsl_cdf_beta_Pinv(p, 0.5, q) : gsl_cdf_beta_Pinv(1 - p, q, 0.5);
    *sa = sqrt(p < 0.5 ? x : 1 - x);
    *ca = pow(p < 0.5 ? 1 - x : x, q);
    if ((s < 0) != (turned > gsl_pi)) *sa = -*sa;
    if (t > gsl_pi / 2) *ca = -*ca;
}
APART(gsl, by_gsl(u, m, &a, &b))
APART(gsl_beta, a = gsl_sf_beta(m, w))
APART(gsl_inc, a = gsl_sf_beta_inc(m, w, u))
APART(gsl_inv, a = gsl_cdf_beta_Pinv(u, m, w))
static double gsl_beta_of(double x, double a, double b)
{
    (void)x;
    return gsl_sf_beta(a, b);
}
static double gsl_inc_of(double x, double a, double b) { return gsl_sf_beta_inc(a, b, x); }
static double gsl_inv_of(double p, double a, double b) { return gsl_cdf_beta_Pinv(p, a, b); }
#endif

/* ---- Arguments and errors ---- */

static exact_value exact[CHECKED][3]; /* sa, ca, Pi of the first arguments */

static void fill(const double argument[2], const double first[2], const double other[2])
{
    int i;
    for (i = 0; i < POOL; i++) {
        arg[i] = (vm_real)between(argument[0], argument[1]);
        parameter[i] = (vm_real)between(first[0], first[1]);
        second[i] = (vm_real)between(other[0], other[1]);
    }
}

static void fill_for_saca(const double alpha[2])
{
    static const double ten[2] = {-10, 10};
    int i;
    fill(ten, alpha, ten);
    for (i = 0; i < CHECKED; i++) exact_saca((double)arg[i], (double)parameter[i], exact[i]);
}

static double error_of_saca(void (*route)(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca))
{
    double error = 0;
    int i;
    for (i = 0; i < CHECKED; i++) {
        vm_real sa, ca;
        route(arg[i], parameter[i], &sa, &ca);
        error = larger(larger(error, error_of((double)sa, exact[i][0])), error_of((double)ca, exact[i][1]));
    }
    return error;
}

static double error_of_pi(void)
{
    double error = 0;
    int i;
    for (i = 0; i < CHECKED; i++)
        error = larger(error, error_of((double)ateb_pi(parameter[i]), exact[i][2]) / exact[i][2].high);
    return error;
}

/* Relative errors of B (of: 0), I_x (1) and its inverse (2) */
static double error_of_beta(vm_real (*route)(vm_real x, vm_real a, vm_real b), int of)
{
    double error = 0;
    int i;
    for (i = 0; i < CHECKED; i++) {
        const double x = (double)arg[i], a = (double)parameter[i], b = (double)second[i];
        const double got = (double)route(arg[i], parameter[i], second[i]);
        exact_value value = {0, 0};
        if (of < 2) value = of ? exact_beta_inc(x, a, b) : exact_beta(a, b);
        else value.high = exact_beta_inc_inv(x, a, b, got);
        error = larger(error, error_of(got, value) / value.high);
    }
    return error;
}

/* ---- Lines ---- */

static void measure_any_alpha(void)
{
    static const double range[2][2] = {{0, 5}, {5, 100}};
    char job[80];
    int i;
    for (i = 0; i < 2; i++) {
        fill_for_saca(range[i]);
        snprintf(job, sizeof job, "Pi, %g < alpha < %g", range[i][0], range[i][1]);
        measure_function(job, "ateb_pi", "", error_of_pi(), pi_apart, pi_chain);
        snprintf(job, sizeof job, "saca, |s| < 10, %g < alpha < %g", range[i][0], range[i][1]);
        measure_function(job, "ateb_saca", "", error_of_saca(by_saca), saca_apart, saca_chain);
    }
}

/* One alpha by every route */
static void measure_routes(double alpha)
{
    double same[2];
    char job[80];
    int i;
    same[0] = same[1] = alpha;
    fill_for_saca(same);
    snprintf(job, sizeof job, "saca, |s| < 10, alpha = %.4g", alpha);
    measure_function(job, "ateb_saca", "", error_of_saca(by_saca), saca_apart, NULL);
    for (i = 0; i < LEVELS; i++) {
        if (accuracies[i] > 0 && accuracies[i] < (double)VM_EPSILON) continue;
        ateb_plan_init_to(&plan, (vm_real)alpha, (vm_real)accuracies[i]);
        measure_function(job, "ateb_plan_saca", accuracy_names[i], error_of_saca(by_plan), plan_apart,
                         i == 0 ? plan_chain : NULL);
        measure_array(job, "ateb_plan_saca_array", accuracy_names[i], error_of_saca(by_plan), array);
    }
#if GSL
    gsl_pi = gsl_sf_beta(1 / (alpha + 1), 0.5);
    measure_function(job, "gsl_cdf_beta_Pinv", "", error_of_saca(by_gsl), gsl_apart, NULL);
#endif
}

static void measure_others(void)
{
    static const double unit[2] = {0.01, 0.99}, one[2] = {-1, 1}, some[2] = {0.5, 5}, ten[2] = {-10, 10};
    fill(one, some, one);
    measure_function("phase, 0.5 < alpha < 5", "ateb_phase", "", NO_ERROR, phase_apart, NULL);
    measure_function("making a plan, 0.5 < alpha < 5", "ateb_plan_init", "", NO_ERROR, making_apart, NULL);
    fill(unit, some, some);
    measure_function("B, 0.5 < a, b < 5", "ateb_beta", "", error_of_beta(beta_of, 0), beta_apart, NULL);
    measure_function("I_x, 0.5 < a, b < 5", "ateb_beta_inc", "", error_of_beta(inc_of, 1), inc_apart, NULL);
    measure_function("x of I_x, 0.5 < a, b < 5", "ateb_beta_inc_inv", "", error_of_beta(inv_of, 2), inv_apart,
                     NULL);
    measure_function("mean, 0.5 < alpha, p < 5", "ateb_mean", "", NO_ERROR, mean_apart, NULL);
#if GSL
    measure_function("B, 0.5 < a, b < 5", "gsl_sf_beta", "", error_of_beta(gsl_beta_of, 0), gsl_beta_apart, NULL);
    measure_function("I_x, 0.5 < a, b < 5", "gsl_sf_beta_inc", "", error_of_beta(gsl_inc_of, 1), gsl_inc_apart,
                     NULL);
    measure_function("x of I_x, 0.5 < a, b < 5", "gsl_cdf_beta_Pinv", "", error_of_beta(gsl_inv_of, 2),
                     gsl_inv_apart, NULL);
#endif
    fill(ten, some, some);
    measure_function("saca, two indices, 0.5 to 5", "ateb_saca_nm", "", NO_ERROR, nm_apart, NULL);
}

int main(int argc, char **argv)
{
    static const double alphas[] = {0, 0.1, 1 / 3., 0.5, 4 / 3., 1, 1.5, 2, 3, 5, 10, 33.3, 1e3};
    size_t i;
#if GSL
    gsl_set_error_handler_off();
#endif
    bench_start(argc, argv, "ateb.h, beside the C library's sin of arguments that rise from -10 to 10");
    fill_angles();
    measure_function("sin, |x| < 10, rising", "sin", "", NO_ERROR, sin_apart, sin_chain);
    measure_any_alpha();
    for (i = 0; i < sizeof alphas / sizeof *alphas; i += bench_quick ? 4 : 1) measure_routes(alphas[i]);
    measure_others();
    return bench_end();
}
