// peers.cpp - special functions of the kit beside those of GSL and Boost.Math, on the same arguments in one run: times, and
// the largest errors against quadruple precision (exact.c). A peer wins where it takes less than MARGIN of the kit's
// time and its largest error is at most the kit's. A line of the table for each function, region and peer, with the
// word "wins" at its end where the peer does; the exit status is 1 where one does.
//
// Moduli k are numbers of 24 bits, so that m = k^2 is exact, and each library gets the same function. Boost.Math computes in
// long double by its default policy, as packaged.
//
// usage: peers [quick]
#include "timing.h"
#include "../varmass.h"
#include "exact.h"
#ifdef WITH_GSL
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf.h>
#endif
#ifdef WITH_BOOST
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/special_functions/lambert_w.hpp>
#endif

enum { ARGUMENTS = 16384, RUN = 256, SLOW_RUN = 16, CHECKED = 1024, MOST_RESULTS = 3 };
static const double MARGIN = 0.9; // what is not faster by a tenth may be noise

static double arg_x[ARGUMENTS], arg_a[ARGUMENTS], arg_b[ARGUMENTS];
static exact_value expected[CHECKED][MOST_RESULTS];
static double expected_size[CHECKED][MOST_RESULTS]; // what an error is divided by
static int results, run_length;
static const char *function_name, *region_name;
static int wins;
static volatile double sink;

// A function of three numbers with up to three results
typedef void (*function)(double x, double a, double b, double *result);

// ---- Arguments ----

static double random_number()
{
    static unsigned long long state = 1;
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(state >> 11) / 9007199254740992.;
}

static double between(double low, double high) { return low + (high - low) * random_number(); }
static double between_logs(double low, double high) { return low * pow(high / low, random_number()); }

// Arguments |x| < size, or |x| < -size K(m) for a negative size; moduli in b, parameters m = k^2 in a
static void fill_jacobi(double size, double least_m, double largest_m)
{
    for (int i = 0; i < ARGUMENTS; i++) {
        arg_b[i] = (float)sqrt(between(least_m, largest_m));
        arg_a[i] = arg_b[i] * arg_b[i];
        arg_x[i] = between(-1, 1) * (size > 0 ? size : -size * jacobi_K(arg_a[i]));
    }
}

// |x| from 10 to size, negative m in a
static void fill_negative(double size, double least_m)
{
    for (int i = 0; i < ARGUMENTS; i++) {
        arg_b[i] = 0;
        arg_a[i] = between(least_m, 0);
        arg_x[i] = between(-1, 1) * size;
    }
}

// m between -1e4 and -1, by the logarithm of -m
static void fill_far_negative(double size)
{
    fill_negative(size, -1);
    for (int i = 0; i < ARGUMENTS; i++) arg_a[i] = -between_logs(1, 1e4);
}

// a and b by their logarithms; x within three standard deviations of the mean of the beta distribution
static void fill_beta(double least, double largest)
{
    for (int i = 0; i < ARGUMENTS; i++) {
        const double a = between_logs(least, largest), b = between_logs(least, largest), s = a + b;
        const double wide = 3 * sqrt(a * b / (s + 1)) / s, mean = a / s;
        arg_a[i] = a;
        arg_b[i] = b;
        arg_x[i] = between(fmax(mean - wide, 1e-3), fmin(mean + wide, 0.999));
    }
}

static void fill_unit_beta(double least, double largest)
{
    fill_beta(least, largest);
    for (int i = 0; i < ARGUMENTS; i++) arg_x[i] = between(0.001, 0.999);
}

static void fill_plain(double least, double largest)
{
    for (int i = 0; i < ARGUMENTS; i++) arg_x[i] = between(least, largest);
}

static void fill_logs(double least, double largest)
{
    for (int i = 0; i < ARGUMENTS; i++) arg_x[i] = between_logs(least, largest);
}

// ---- The kit ----

static inline void kit_sncndn(double x, double a, double, double *r) { jacobi_sncndn(x, a, r, r + 1, r + 2); }
static inline void kit_K(double, double a, double, double *r) { *r = jacobi_K(a); }
static inline void kit_E(double, double a, double, double *r) { *r = jacobi_E(a); }
static inline void kit_F(double x, double a, double, double *r) { *r = jacobi_F(x, a); }
static inline void kit_Einc(double x, double a, double, double *r) { *r = jacobi_E_incomplete(x, a); }
static inline void kit_Pi(double x, double a, double, double *r) { *r = jacobi_Pi_incomplete(x, 0.25, a); }
static inline void kit_RF(double, double a, double b, double *r) { *r = jacobi_RF(1, a, b); }
static inline void kit_RJ(double, double a, double b, double *r) { *r = jacobi_RJ(1, a, b, 0.75); }
static inline void kit_inc(double x, double a, double b, double *r) { *r = ateb_beta_inc(x, a, b); }
static inline void kit_inv(double x, double a, double b, double *r) { *r = ateb_beta_inc_inv(x, a, b); }
static inline void kit_beta(double, double a, double b, double *r) { *r = ateb_beta(a, b); }
static inline void kit_lnbeta(double, double a, double b, double *r) { *r = ateb_ln_beta(a, b); }
static inline void kit_w0(double x, double, double, double *r) { *r = vm_lambert_w0(x); }

// ---- References ----

static void exact_jacobi(double x, double a, double, exact_value *v)
{
    exact_value all[4];
    exact_sncndn(x, a, all);
    for (int i = 0; i < 3; i++) v[i] = all[i];
}
static void exact_K(double, double a, double, exact_value *v)
{
    exact_value both[2];
    exact_complete(a, both);
    *v = both[0];
}
static void exact_E(double, double a, double, exact_value *v)
{
    exact_value both[2];
    exact_complete(a, both);
    *v = both[1];
}
static void exact_F(double x, double a, double, exact_value *v) { *v = exact_incomplete(x, a, 0.25, 'F'); }
static void exact_Einc(double x, double a, double, exact_value *v) { *v = exact_incomplete(x, a, 0.25, 'E'); }
static void exact_Pi(double x, double a, double, exact_value *v) { *v = exact_incomplete(x, a, 0.25, 'P'); }
static void exact_RF(double, double a, double b, exact_value *v) { *v = exact_carlson_rf(1, a, b); }
static void exact_RJ(double, double a, double b, exact_value *v) { *v = exact_carlson_rj(1, a, b, 0.75); }
static void exact_inc(double x, double a, double b, exact_value *v) { *v = exact_beta_inc(x, a, b); }
static void exact_inv(double x, double a, double b, exact_value *v)
{
    double at = ateb_beta_inc_inv(x, a, b);
    v->high = exact_beta_inc_inv(x, a, b, at);
    v->low = 0;
}
static void exact_B(double, double a, double b, exact_value *v) { *v = exact_beta(a, b); }
static void exact_lnB(double, double a, double b, exact_value *v) { *v = exact_ln_beta(a, b); }
static void exact_w0(double x, double, double, exact_value *v) { *v = exact_lambert_w0(x, vm_lambert_w0(x)); }

// ---- GSL and Boost ----

#ifdef WITH_GSL
static inline void gsl_jacobi(double x, double a, double, double *r) { gsl_sf_elljac_e(x, a, r, r + 1, r + 2); }
// m < -1, which elljac refuses, by the transformation to m/(m - 1) (DLMF 22.17.5-8)
static inline void gsl_far_jacobi(double x, double a, double, double *r)
{
    const double kp = sqrt(1 - a);
    double sn = 0, cn = 0, dn = 1;
    gsl_sf_elljac_e(kp * x, a / (a - 1), &sn, &cn, &dn);
    r[0] = sn / (kp * dn);
    r[1] = cn / dn;
    r[2] = 1 / dn;
}
static inline void gsl_K(double, double, double b, double *r) { *r = gsl_sf_ellint_Kcomp(b, GSL_PREC_DOUBLE); }
static inline void gsl_E(double, double, double b, double *r) { *r = gsl_sf_ellint_Ecomp(b, GSL_PREC_DOUBLE); }
static inline void gsl_F(double x, double, double b, double *r) { *r = gsl_sf_ellint_F(x, b, GSL_PREC_DOUBLE); }
static inline void gsl_Einc(double x, double, double b, double *r) { *r = gsl_sf_ellint_E(x, b, GSL_PREC_DOUBLE); }
static inline void gsl_Pi(double x, double, double b, double *r)
{
    *r = gsl_sf_ellint_P(x, b, -0.25, GSL_PREC_DOUBLE);
}
static inline void gsl_RF(double, double a, double b, double *r) { *r = gsl_sf_ellint_RF(1, a, b, GSL_PREC_DOUBLE); }
static inline void gsl_RJ(double, double a, double b, double *r)
{
    *r = gsl_sf_ellint_RJ(1, a, b, 0.75, GSL_PREC_DOUBLE);
}
static inline void gsl_inc(double x, double a, double b, double *r) { *r = gsl_sf_beta_inc(a, b, x); }
static inline void gsl_cdf(double x, double a, double b, double *r) { *r = gsl_cdf_beta_P(x, a, b); }
static inline void gsl_inv(double x, double a, double b, double *r) { *r = gsl_cdf_beta_Pinv(x, a, b); }
static inline void gsl_B(double, double a, double b, double *r) { *r = gsl_sf_beta(a, b); }
static inline void gsl_lnB(double, double a, double b, double *r) { *r = gsl_sf_lnbeta(a, b); }
static inline void gsl_w0(double x, double, double, double *r) { *r = gsl_sf_lambert_W0(x); }
#endif
#ifdef WITH_BOOST
// Boost.Math by its default policy, and in double throughout, without the promotion to long double
namespace packaged {
typedef boost::math::policies::policy<> policy;
#include "peers_boost.h"
} // namespace packaged
namespace plain {
typedef boost::math::policies::policy<boost::math::policies::promote_double<false> > policy;
#include "peers_boost.h"
} // namespace plain
#endif

// ---- Measuring ----

// A run of the function over the next arguments
template <function f> static void loop()
{
    const int first = bench_position = (bench_position + run_length) % (ARGUMENTS / run_length * run_length);
    double sum = 0, r[MOST_RESULTS] = {0, 0, 0};
    for (int i = first; i < first + run_length && i < ARGUMENTS; i++) {
        f(arg_x[i], arg_a[i], arg_b[i], r);
        sum += r[0] + r[1] + r[2];
    }
    sink = sum;
}

// Takes the arguments as they are now for this region, and computes what is expected. Errors are relative; those of sn,
// cn and dn absolute, by the function's largest value.
static void region(const char *what, const char *of, int count, void (*exact)(double, double, double, exact_value *))
{
    function_name = what;
    region_name = of;
    results = count;
    for (int i = 0; i < CHECKED; i++) {
        exact(arg_x[i], arg_a[i], arg_b[i], expected[i]);
        for (int k = 0; k < results; k++) {
            expected_size[i][k] = fabs(expected[i][k].high);
            if (results == 3) expected_size[i][k] = k == 2 ? fmax(1, sqrt(1 - arg_a[i])) : 1;
        }
    }
}

template <function f> static double largest_error()
{
    double error = 0;
    for (int i = 0; i < CHECKED; i++) {
        double r[MOST_RESULTS];
        f(arg_x[i], arg_a[i], arg_b[i], r);
        for (int k = 0; k < results; k++)
            error = larger(error, error_of(r[k], expected[i][k]) / expected_size[i][k]);
    }
    return error;
}

// The number as a table has it
static void write_error(double error)
{
    if (error == error) printf(" %.1e |", error);
    else printf(" no number |");
}

template <function kit, function peer> static void against(const char *peer_name)
{
    run_length = RUN;
    if (slice(loop<kit>, 1) + slice(loop<peer>, 1) > 1e-3) run_length = SLOW_RUN;
    const double error = largest_error<kit>(), peer_error = largest_error<peer>();
    const timing t = time_beside(loop<kit>, run_length, loop<peer>, run_length);
    const bool won = 1 / t.ratio < MARGIN && peer_error <= error;
    printf("| %s | %s |", function_name, region_name);
    write_error(error);
    printf(" %.4g | %s |", t.ns, peer_name);
    write_error(peer_error);
    printf(" %.4g | %.2f |%s\n", t.ns / t.ratio, t.ratio, won ? " wins" : "");
    fflush(stdout);
    wins += won;
}
#ifdef WITH_GSL
#define GSL(kit, peer, name) against<kit, peer>("GSL `" name "`")
#else
#define GSL(kit, peer, name) (void)0
#endif
#ifdef WITH_BOOST
#define BOOST(kit, peer, name)                           \
    (against<kit, packaged::peer>("Boost `" name "`"), \
     against<kit, plain::peer>("Boost `" name "`, double"))
#else
#define BOOST(kit, peer, name) (void)0
#endif

// ---- Lines ----

static void sncndn_region(const char *of)
{
    region("`jacobi_sncndn`", of, 3, exact_jacobi);
    GSL(kit_sncndn, gsl_jacobi, "elljac_e");
    if (arg_a[0] >= 0) BOOST(kit_sncndn, boost_jacobi, "jacobi_elliptic");
}

static void compare_sncndn()
{
    static const struct {
        const char *of;
        double size, least_m, largest_m;
    } regions[] = {{"\\|u\\| < 2K, 0 < m < 0.97", -2, 0, 0.97},    {"\\|u\\| < 2K, 0.97 < m < 1", -2, 0.97, 0.999999},
                   {"\\|u\\| < 10, 0 < m < 0.97", 10, 0, 0.97},    {"\\|u\\| < 10, 0.97 < m < 1", 10, 0.97, 0.999999},
                   {"\\|u\\| < 1e6, 0 < m < 0.97", 1e6, 0, 0.97},  {"\\|u\\| < 1e6, 0.97 < m < 1", 1e6, 0.97, 0.999999},
                   {"\\|u\\| < 1e9, 0 < m < 0.97", 1e9, 0, 0.97},  {"\\|u\\| < 1e9, 0.97 < m < 1", 1e9, 0.97, 0.999999}};
    for (size_t i = 0; i < sizeof regions / sizeof *regions; i++) {
        fill_jacobi(regions[i].size, regions[i].least_m, regions[i].largest_m);
        sncndn_region(regions[i].of);
    }
    fill_negative(2, -1);
    sncndn_region("\\|u\\| < 2, -1 < m < 0");
    fill_negative(1e6, -1);
    sncndn_region("\\|u\\| < 1e6, -1 < m < 0");
    fill_far_negative(2);
    region("`jacobi_sncndn`", "\\|u\\| < 2, -1e4 < m < -1", 3, exact_jacobi);
    GSL(kit_sncndn, gsl_far_jacobi, "elljac_e at m/(m - 1)");
    fill_far_negative(1e6);
    region("`jacobi_sncndn`", "\\|u\\| < 1e6, -1e4 < m < -1", 3, exact_jacobi);
    GSL(kit_sncndn, gsl_far_jacobi, "elljac_e at m/(m - 1)");
}

static void compare_integrals()
{
    static const struct {
        const char *complete, *incomplete;
        double phi, least_m, largest_m;
    } regions[] = {{"0 < m < 0.97", "\\|phi\\| < 1.5, 0 < m < 0.97", 1.5, 0, 0.97},
                   {"0.97 < m < 1", "\\|phi\\| < 1.5, 0.97 < m < 1", 1.5, 0.97, 0.999999},
                   {NULL, "\\|phi\\| < 10, 0 < m < 1", 10, 0, 0.999999}};
    for (size_t i = 0; i < sizeof regions / sizeof *regions; i++) {
        fill_jacobi(regions[i].phi, regions[i].least_m, regions[i].largest_m);
        if (regions[i].complete) {
            region("`jacobi_K`", regions[i].complete, 1, exact_K);
            GSL(kit_K, gsl_K, "ellint_Kcomp");
            BOOST(kit_K, boost_K, "ellint_1");
            region("`jacobi_E`", regions[i].complete, 1, exact_E);
            GSL(kit_E, gsl_E, "ellint_Ecomp");
            BOOST(kit_E, boost_E, "ellint_2");
        }
        region("`jacobi_F`", regions[i].incomplete, 1, exact_F);
        GSL(kit_F, gsl_F, "ellint_F");
        BOOST(kit_F, boost_F, "ellint_1");
        region("`jacobi_E_incomplete`", regions[i].incomplete, 1, exact_Einc);
        GSL(kit_Einc, gsl_Einc, "ellint_E");
        BOOST(kit_Einc, boost_Einc, "ellint_2");
        region("`jacobi_Pi_incomplete`", regions[i].incomplete, 1, exact_Pi);
        GSL(kit_Pi, gsl_Pi, "ellint_P");
        BOOST(kit_Pi, boost_Pi, "ellint_3");
    }
    fill_jacobi(1, 1e-6, 0.999999);
    region("`jacobi_RF`", "x = 1, 0 < y, z < 1", 1, exact_RF);
    GSL(kit_RF, gsl_RF, "ellint_RF");
    BOOST(kit_RF, boost_RF, "ellint_rf");
    region("`jacobi_RJ`", "x = 1, 0 < y, z < 1, p = 3/4", 1, exact_RJ);
    GSL(kit_RJ, gsl_RJ, "ellint_RJ");
    BOOST(kit_RJ, boost_RJ, "ellint_rj");
}

static void compare_beta()
{
    static const struct {
        const char *of;
        double least, largest;
    } regions[] = {
        {"0.01 < a, b < 1", 0.01, 1}, {"0.5 < a, b < 5", 0.5, 5},         {"5 < a, b < 100", 5, 100},
        {"100 < a, b < 1e4", 100, 1e4}, {"0.5 < a, b < 1000", 0.5, 1000}};
    for (size_t i = 0; i < sizeof regions / sizeof *regions; i++) {
        fill_beta(regions[i].least, regions[i].largest);
        region("`ateb_beta_inc`", regions[i].of, 1, exact_inc);
        GSL(kit_inc, gsl_inc, "sf_beta_inc");
        GSL(kit_inc, gsl_cdf, "cdf_beta_P");
        BOOST(kit_inc, boost_inc, "ibeta");
        if (regions[i].largest < 200) {
            region("`ateb_beta`", regions[i].of, 1, exact_B);
            GSL(kit_beta, gsl_B, "sf_beta");
            BOOST(kit_beta, boost_B, "beta");
        }
        region("`ateb_ln_beta`", regions[i].of, 1, exact_lnB);
        GSL(kit_lnbeta, gsl_lnB, "sf_lnbeta");
        fill_unit_beta(regions[i].least, regions[i].largest);
        region("`ateb_beta_inc_inv`", regions[i].of, 1, exact_inv);
        GSL(kit_inv, gsl_inv, "cdf_beta_Pinv");
        BOOST(kit_inv, boost_inv, "ibeta_inv");
    }
}

static void w0_region(const char *of)
{
    region("`vm_lambert_w0`", of, 1, exact_w0);
    GSL(kit_w0, gsl_w0, "lambert_W0");
    BOOST(kit_w0, boost_w0, "lambert_w0");
}

static void compare_w0()
{
    fill_plain(-0.3678, -1e-3);
    w0_region("-0.3678 < x < 0");
    fill_plain(1e-3, 10);
    w0_region("0 < x < 10");
    fill_logs(10, 1e9);
    w0_region("10 < x < 1e9");
}

int main(int argc, char **argv)
{
    bench_quick = argc > 1 && strcmp(argv[1], "quick") == 0;
#ifdef WITH_GSL
    gsl_set_error_handler_off();
#endif
    puts("| function | of | error | ns | peer | its error | ns | time, kit/peer |");
    puts("|---|---|---|---|---|---|---|---|");
    compare_sncndn();
    compare_integrals();
    compare_beta();
    compare_w0();
    return wins > 0;
}
