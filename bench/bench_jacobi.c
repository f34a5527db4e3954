/* jacobi.h: time of a call in units of the C library's sin (float: sinf), of independent arguments and in a chain,
   and the largest error against quadruple precision; GSL's functions beside it. Errors are absolute, of K and E
   relative, of dn by its largest value. The last lines are one quantity by every route, the AGM's with its steps as
   the knob. */
#include "timing.h"
#include "../jacobi.h"
#include "arguments.h"
#include "exact.h"
#if defined(WITH_GSL) && !defined(VM_USE_FLOAT)
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf.h>
#define GSL 1
#else
#define GSL 0
#endif

enum { IS_FLOAT = sizeof(vm_real) == sizeof(float), CHECKED = 1024 };
static jacobi_plan plan;
static int steps;

/* ---- Routes ---- */

BODY(K, a = jacobi_K(m))
BODY(E, a = jacobi_E(m))
BODY(am, a = jacobi_am(u, m))
BODY(F, a = jacobi_F(u, m))
BODY(second_kind, a = jacobi_E_incomplete(u, m))
BODY(third_kind, a = jacobi_Pi_incomplete(u, VM_C(0.25), m))
BODY(Pi, a = jacobi_Pi(VM_C(0.25), m))
BODY(RF, a = jacobi_RF(1, w, m))
BODY(RJ, a = jacobi_RJ(1, w, m, VM_C(0.75)))
BODY(inverse_cn, a = jacobi_inverse_cn(w, m))
BODY(solve, a = jacobi_solve_kpK(m))
BODY(means, jacobi_cn_means(m, &a, &b, &c))
BODY(sncndn, jacobi_sncndn(u, m, &a, &b, &c))
BODY(plan, jacobi_plan_sncndn(&plan, u, &a, &b, &c))
APART(making, jacobi_plan_init(&plan, m); a = plan.m1)
BODY(agm, jacobi_agm_sncndn(u, m, steps, &a, &b, &c))
BODY(agm_K, a = jacobi_agm_K(m))

static void array(void)
{
    static vm_real sn[ARRAY], cn[ARRAY], dn[ARRAY];
    jacobi_plan_sncndn_array(&plan, ARRAY, arg + next_of(ARRAY), sn, cn, dn);
    sink = sn[0] + cn[ARRAY / 2] + dn[ARRAY - 1];
}

static vm_real by_K(vm_real m) { return jacobi_K(m); }
static vm_real by_E(vm_real m) { return jacobi_E(m); }
static vm_real by_agm_K(vm_real m) { return jacobi_agm_K(m); }
static void by_plan(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    (void)m;
    jacobi_plan_sncndn(&plan, u, sn, cn, dn);
}
static void by_agm(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    jacobi_agm_sncndn(u, m, steps, sn, cn, dn);
}

#if GSL
BODY(gsl_elljac, gsl_sf_elljac_e(u, m, &a, &b, &c))
APART(gsl_K, a = gsl_sf_ellint_Kcomp(w, GSL_PREC_DOUBLE))
APART(gsl_E, a = gsl_sf_ellint_Ecomp(w, GSL_PREC_DOUBLE))
BODY(gsl_F, a = gsl_sf_ellint_F(u, w, GSL_PREC_DOUBLE))
BODY(gsl_second_kind, a = gsl_sf_ellint_E(u, w, GSL_PREC_DOUBLE))
BODY(gsl_third_kind, a = gsl_sf_ellint_P(u, w, -0.25, GSL_PREC_DOUBLE))
BODY(gsl_Pi, a = gsl_sf_ellint_Pcomp(w, -0.25, GSL_PREC_DOUBLE))
BODY(gsl_RF, a = gsl_sf_ellint_RF(1, w, m, GSL_PREC_DOUBLE))
BODY(gsl_RJ, a = gsl_sf_ellint_RJ(1, w, m, 0.75, GSL_PREC_DOUBLE))
static void by_gsl(double u, double m, double *sn, double *cn, double *dn) { gsl_sf_elljac_e(u, m, sn, cn, dn); }
static double by_gsl_K(double m) { return gsl_sf_ellint_Kcomp(sqrt(m), GSL_PREC_DOUBLE); }
static double by_gsl_E(double m) { return gsl_sf_ellint_Ecomp(sqrt(m), GSL_PREC_DOUBLE); }
#endif

/* ---- Arguments and errors ---- */

/* Parameters between low and high, and arguments between +-size, or where size = 0 between +-quarters K(m) */
static void fill(double size, double quarters, double low, double high)
{
    int i;
    for (i = 0; i < POOL; i++) {
        parameter[i] = (vm_real)between(low, high);
        second[i] = VM_SQRT(VM_FABS(parameter[i])); /* the modulus, which some want */
        arg[i] = (vm_real)(between(-1, 1) * (size > 0 ? size : quarters * (double)jacobi_K(parameter[i])));
    }
}

/* The largest error of some of the arguments */
static double error_of_sncndn(void (*route)(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn))
{
    double error = 0;
    int i;
    for (i = 0; i < CHECKED; i++) {
        const double m = (double)parameter[i];
        exact_value exact[4];
        vm_real sn, cn, dn;
        exact_sncndn((double)arg[i], m, exact);
        route(arg[i], parameter[i], &sn, &cn, &dn);
        error = larger(larger(error, error_of((double)sn, exact[0])), error_of((double)cn, exact[1]));
        error = larger(error, error_of((double)dn, exact[2]) / fmax(1, sqrt(1 - m)));
    }
    return error;
}

static double error_of_am(void)
{
    double error = 0;
    int i;
    for (i = 0; i < CHECKED; i++) {
        exact_value exact[4];
        exact_sncndn((double)arg[i], (double)parameter[i], exact);
        error = larger(error, error_of((double)jacobi_am(arg[i], parameter[i]), exact[3]));
    }
    return error;
}

/* which: 0 for K, 1 for E */
static double error_of_complete(vm_real (*route)(vm_real m), int which)
{
    double error = 0;
    int i;
    for (i = 0; i < CHECKED; i++) {
        exact_value exact[2];
        exact_complete((double)parameter[i], exact);
        error = larger(error, error_of((double)route(parameter[i]), exact[which]) / exact[which].high);
    }
    return error;
}

/* ---- Lines ---- */

static void measure_complete(void)
{
    fill(1, 0, 0, 1);
    measure_function("K, 0 < m < 1", "jacobi_K", "", error_of_complete(by_K, 0), K_apart, K_chain);
    measure_function("K, 0 < m < 1", "jacobi_agm_K", "", error_of_complete(by_agm_K, 0), agm_K_apart, agm_K_chain);
    measure_function("E, 0 < m < 1", "jacobi_E", "", error_of_complete(by_E, 1), E_apart, E_chain);
#if GSL
    measure_function("K, 0 < m < 1", "gsl_sf_ellint_Kcomp", "", error_of_complete(by_gsl_K, 0), gsl_K_apart, NULL);
    measure_function("E, 0 < m < 1", "gsl_sf_ellint_Ecomp", "", error_of_complete(by_gsl_E, 1), gsl_E_apart, NULL);
#endif
    measure_function("means, 0 < m < 1", "jacobi_cn_means", "", NO_ERROR, means_apart, means_chain);
    measure_function("making a plan, 0 < m < 1", "jacobi_plan_init", "", NO_ERROR, making_apart, NULL);
    fill(1, 0, -30, -1);
    measure_function("K, -30 < m < -1", "jacobi_K", "", error_of_complete(by_K, 0), K_apart, K_chain);
    measure_function("E, -30 < m < -1", "jacobi_E", "", error_of_complete(by_E, 1), E_apart, E_chain);
    measure_function("means, -30 < m < -1", "jacobi_cn_means", "", NO_ERROR, means_apart, means_chain);
}

static void measure_any_m(void)
{
    static const double range[4][2] = {{0, 0.5}, {0.5, 1}, {-1, 0}, {-30, -1}};
    static const struct {
        const char *label;
        double size, quarters;
    } reach[3] = {
        {"|u| < K/2", 0, 0.5}, {"|u| < 2K", 0, 2}, {IS_FLOAT ? "|u| < 1e4" : "|u| < 1e9", IS_FLOAT ? 1e4 : 1e9, 0}};
    char job[80];
    int i, j;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            fill(reach[i].size, reach[i].quarters, range[j][0], range[j][1]);
            snprintf(job, sizeof job, "sncndn, %s, %g < m < %g", reach[i].label, range[j][0], range[j][1]);
            measure_function(job, "jacobi_sncndn", "", error_of_sncndn(jacobi_sncndn), sncndn_apart, sncndn_chain);
#if GSL
            if (range[j][0] >= -1) /* which it refuses below */
                measure_function(job, "gsl_sf_elljac_e", "", error_of_sncndn(by_gsl), gsl_elljac_apart,
                                 gsl_elljac_chain);
#endif
        }
}

static void measure_inverses(void)
{
    static const double c[3][2] = {{0, 1.3}, {1.32, 1.85}, {1.86, 20}};
    char job[80];
    int i;
    fill(0, 2, 0, 1);
    measure_function("am, |u| < 2K, 0 < m < 1", "jacobi_am", "", error_of_am(), am_apart, am_chain);
    for (i = 0; i < 3; i++) {
        fill(1, 0, c[i][0], c[i][1]);
        snprintf(job, sizeof job, "m of k'K = c, %g < c < %g", c[i][0], c[i][1]);
        measure_function(job, "jacobi_solve_kpK", "", NO_ERROR, solve_apart, solve_chain);
    }
}

/* Elliptic integrals up to |phi|, for 0 < m < 1 */
static void measure_integrals(double phi)
{
    char job[80];
    fill(phi, 0, 0, 1);
    snprintf(job, sizeof job, "F(phi | m), |phi| < %g", phi);
    measure_function(job, "jacobi_F", "", NO_ERROR, F_apart, F_chain);
#if GSL
    measure_function(job, "gsl_sf_ellint_F", "", NO_ERROR, gsl_F_apart, gsl_F_chain);
#endif
    snprintf(job, sizeof job, "E(phi | m), |phi| < %g", phi);
    measure_function(job, "jacobi_E_incomplete", "", NO_ERROR, second_kind_apart, second_kind_chain);
#if GSL
    measure_function(job, "gsl_sf_ellint_E", "", NO_ERROR, gsl_second_kind_apart, gsl_second_kind_chain);
#endif
    snprintf(job, sizeof job, "Pi(1/4; phi | m), |phi| < %g", phi);
    measure_function(job, "jacobi_Pi_incomplete", "", NO_ERROR, third_kind_apart, third_kind_chain);
#if GSL
    measure_function(job, "gsl_sf_ellint_P", "", NO_ERROR, gsl_third_kind_apart, gsl_third_kind_chain);
#endif
}

/* The complete integral of the third kind, Carlson's integrals, and an inverse, for 0 < m < 1 */
static void measure_symmetric(void)
{
    fill(1, 0, 0, 1);
    measure_function("Pi(1/4 | m)", "jacobi_Pi", "", NO_ERROR, Pi_apart, Pi_chain);
    measure_function("R_F(1, k, m)", "jacobi_RF", "", NO_ERROR, RF_apart, RF_chain);
    measure_function("R_J(1, k, m, 3/4)", "jacobi_RJ", "", NO_ERROR, RJ_apart, RJ_chain);
    measure_function("u of cn(u | m) = k", "jacobi_inverse_cn", "", NO_ERROR, inverse_cn_apart, inverse_cn_chain);
#if GSL
    measure_function("Pi(1/4 | m)", "gsl_sf_ellint_Pcomp", "", NO_ERROR, gsl_Pi_apart, gsl_Pi_chain);
    measure_function("R_F(1, k, m)", "gsl_sf_ellint_RF", "", NO_ERROR, gsl_RF_apart, gsl_RF_chain);
    measure_function("R_J(1, k, m, 3/4)", "gsl_sf_ellint_RJ", "", NO_ERROR, gsl_RJ_apart, gsl_RJ_chain);
#endif
}

/* One quantity, one m, by every route */
static void measure_routes(double m)
{
    char job[80], knob[16];
    snprintf(job, sizeof job, "sncndn, |u| < 2K, m = %g", m);
    fill(0, 2, m, m);
    jacobi_plan_init(&plan, (vm_real)m);
    for (steps = 1; steps < (IS_FLOAT ? 5 : 7) && m > 0; steps++) {
        snprintf(knob, sizeof knob, "%d", steps);
        measure_function(job, "jacobi_agm_sncndn", knob, error_of_sncndn(by_agm), agm_apart, agm_chain);
    }
    measure_function(job, "jacobi_sncndn", "", error_of_sncndn(jacobi_sncndn), sncndn_apart, sncndn_chain);
    measure_function(job, "jacobi_plan_sncndn", "", error_of_sncndn(by_plan), plan_apart, plan_chain);
    measure_array(job, "jacobi_plan_sncndn_array", "", error_of_sncndn(by_plan), array);
#if GSL
    if (m >= -1)
        measure_function(job, "gsl_sf_elljac_e", "", error_of_sncndn(by_gsl), gsl_elljac_apart, gsl_elljac_chain);
#endif
}

int main(int argc, char **argv)
{
    static const double m[] = {0.5, 0.1, 0.9, 0.99, -20};
    size_t i;
#if GSL
    gsl_set_error_handler_off();
#endif
    bench_start(argc, argv, "jacobi.h, beside the C library's sin of arguments that rise from -10 to 10");
    fill_angles();
    fill(10, 0, 0, 1);
    measure_function("sin, |x| < 10, rising", "sin", "", NO_ERROR, sin_apart, sin_chain);
    measure_function("sin, |x| < 10, random", "sin", "", NO_ERROR, random_sin_apart, random_sin_chain);
    measure_complete();
    measure_any_m();
    measure_inverses();
    measure_integrals(1.5);
    measure_integrals(10);
    measure_symmetric();
    for (i = 0; i < sizeof m / sizeof *m; i += bench_quick ? 2 : 1) measure_routes(m[i]);
    return bench_end();
}
