/* The law of order three for Van der Pol's oscillator of slow mass: its constants and ripple, its orders and estimates
   against motions that tests/gen/van_der_pol_reference.c computes in long double without the headers, its routes to a
   tolerance, the limit cycle to second order against integrations by rk87, and what is refused. */
#include <stdlib.h>

#include "../varmass.h"
#include "check.h"
#include "judgement.h"
#include "nearly_exhausted.h"
#include "oscillator_checks.h"
#include "routes_problems.h"

#define COUNT(cases) ((int)(sizeof(cases) / sizeof *(cases)))

/* A problem with its motion at T, and the motion at parts of T. The second of these times and the last are points of
   tables. */
enum { TIMES = 4 };
static const double parts[TIMES] = {33. / 40, 34. / 40, 37. / 40, 1};
typedef struct vdp_case {
    routes_case c;
    double x[TIMES], v[TIMES];
} vdp_case;
#include "data/van_der_pol_motions.h"

static vm_vdp oscillator(double alpha, double feed, double c, double reactive, vm_law mass)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = R(alpha);
    v.k = 1;
    v.feed = R(feed);
    v.c = R(c);
    v.reactive = R(reactive);
    v.mass = mass;
    return v;
}

/* The oscillator of a case: its force is size (1 - x^2) x', beside its damping. Its table is valid until the next
   call. */
static vm_vdp oscillator_of(const routes_case *c)
{
    static vm_real times[POINTS], values[POINTS];
    const double size = c->force ? c->size : 0;
    return oscillator(c->alpha, size - c->damping, size, c->reactive, law_of(&c->mass, c->T, times, values));
}

static vm_vdp_plan plan_of(const routes_case *c)
{
    const vm_vdp v = oscillator_of(c);
    vm_vdp_plan plan;
    memset(&plan, 0, sizeof plan);
    CHECK(vm_vdp_plan_init(&plan, &v, R(c->x0), R(c->v0)) == VM_OK);
    return plan;
}

/* The larger of the error of x relative to A and the error of v relative to vmax */
static double error_at(const vm_vdp_plan *p, const vdp_case *s, int i, const vm_osc_motion *motion)
{
    routes_case c = s->c;
    c.T = s->c.T * parts[i];
    c.x = s->x[i];
    c.v = s->v[i];
    return case_error(&c, &p->osc.problem, motion->x, motion->v);
}

static int route_of(int order) { return order == 1 ? (int)VM_ROUTE_ATEB : (int)VM_ROUTE_ORDER2 + order - 2; }

/* ---- Constants and ripple ---- */

static void prepare(double alpha, vmi_ripple *r, vmi_vdp_ripple *v)
{
    vmi_ripple_init(r, R(alpha), vmi_ateb_constants);
    vmi_ripple_complete(r, 5);
    vmi_vdp_ripple_init(v, r);
}

/* Constants to ten digits by an independent program in long double; those of alpha = 1 are fractions. The last two are
   those of the limit cycle. */
static void test_constants(void)
{
    static const double rows[][11] = {
        {0.5, 0, 0.020995796508, -0.036489513536, -0.003900337659, 0.003774954863, -0.041009127571, 0.081324869614,
         -0.030219573027, 0.0025891, -0.0470866},
        {1, -0.25, 1. / 32, -11. / 256, -5. / 1024, 1. / 256, -1. / 16, 1. / 8, -61. / 1536, 1. / 192, -1. / 16},
        {4. / 3, 0, 0.038911073796, -0.046576748524, -0.005524690877, 0.003711398682, -0.078832162442, 0.158412304315,
         -0.045729914468, 0.0070225, -0.0741030},
        {3, 0, 0.086267038612, -0.060419394250, -0.009025210507, 0, -0.182778632418, 0.373599466215, -0.071591003299,
         0.0155049, -0.1614520},
        {5, 0, 0.161159315639, -0.075, -0.014372830885, -0.008703175869, -0.352219055212, 0.729536958216,
         -0.092957958794, 0.0230416, -0.3631868}};
    static vmi_ripple r;
    static vmi_vdp_ripple v;
    int i, k;
    for (i = 0; i < COUNT(rows); i++) {
        vm_real kx, kw;
        prepare(rows[i][0], &r, &v);
        vmi_vdp_cycle_coefficients(&v, &r, &kx, &kw);
        {
            const vm_real got[10] = {v.F, v.mean_square, v.K2, v.K3, v.K1, v.KQ, v.KE, v.constant, kx, kw};
            for (k = rows[i][1] < 0 ? 0 : 1; k < 10; k++) {
                const double bound = rows[i][0] == 1 ? 1e-14 : k < 8 ? 1e-12 : 1e-7;
                check_error("constants", "spec", "bound", fabs((double)got[k] - rows[i][k + 1]) / by_precision(bound, 2e-6),
                            1, rows[i][0], k);
            }
        }
    }
}

/* The integrals of ca^6 - <ca^6> and of S^2 - <S^2> have these derivatives, and vanish where sa or ca is 0; by Gauss'
   rule of three points on short pieces. */
static void test_ripple(void)
{
    enum { PIECES = 160 };
    static const double alphas[] = {0, 0.25, 0.5, 1, 4. / 3, 2, 3, 5, 8, 12};
    const double node = sqrt(0.6), weights[3] = {5. / 18, 4. / 9, 5. / 18};
    static vmi_ripple r;
    static vmi_vdp_ripple v;
    int i, k, j;
    for (k = 0; k < COUNT(alphas); k++) {
        double h, ca6_size, square_size;
        prepare(alphas[k], &r, &v);
        h = (double)r.pi / PIECES;
        ca6_size = 0.1 * (double)r.pi;
        square_size = 0.1 * (double)(r.pi * v.mean_square);
        for (i = 0; i < PIECES; i++) {
            const double from = h * (i + 0.5);
            double sums[2] = {0, 0};
            vm_real sa, ca, before[2], after[2];
            ateb_saca(R(from), R(alphas[k]), &sa, &ca);
            vmi_vdp_integrals_at(&v, &r, R(from), sa, ca, &before[0], &before[1]);
            ateb_saca(R(from + h), R(alphas[k]), &sa, &ca);
            vmi_vdp_integrals_at(&v, &r, R(from + h), sa, ca, &after[0], &after[1]);
            for (j = 0; j < 3; j++) {
                const double at = from + h / 2 * (1 + node * (j - 1));
                vmi_ripple_values f;
                ateb_saca(R(at), R(alphas[k]), &sa, &ca);
                vmi_ripple_at(&r, 5, R(at), sa, ca, &f);
                sums[0] += h * weights[j] * (pow((double)ca, 6) - (double)v.mean6);
                sums[1] += h * weights[j] * (double)(f.S * f.S - v.mean_square);
            }
            check_error("ripple", "ca^6", "size", fabs((double)(after[0] - before[0]) - sums[0]) / ca6_size,
                        by_precision(3e-7, 2e-5), from, alphas[k]);
            check_error("ripple", "S^2", "size", fabs((double)(after[1] - before[1]) - sums[1]) / square_size,
                        by_precision(3e-7, 2e-4), from, alphas[k]);
        }
    }
}

/* One problem step by step, against numbers of an independent program in long double (its exact motion too) */
static void test_check_values(void)
{
    const double T = 299.990184959731;
    const vm_vdp v = oscillator(4. / 3, 0.01, 0.01, 0, vm_law_linear(1, R(0.01)));
    static vm_vdp_plan p;
    vmi_vdp_mean mean;
    vm_osc_motion m;
    double y;
    memset(&mean, 0, sizeof mean);
    memset(&m, 0, sizeof m);
    CHECK(vm_vdp_plan_init(&p, &v, R(0.9), R(-0.3)) == VM_OK);
    near("start", "t1", (double)p.start.t, 1.304353664602, 3e-12);
    near("start", "A", exp((double)p.start.ln_A), 0.958932806542, 2e-12);
    near("start", "phase", (double)p.start.psi, 1.751571330352, 3e-12);
    CHECK(vmi_vdp_mean_at(&p, R(T), &mean) == VM_OK);
    y = exp(-2 * (double)(mean.ln_A - p.start.ln_A)) *
        pow((1 + 0.01 * T) / (1 + 0.01 * (double)p.start.t), 2. / (13. / 3) * (1 + 2));
    near("mean motion", "y", y, 1.891525554936, 4e-12);
    if (is_float) return; /* 227 radians leave float too few digits */
    near("mean motion", "phase", (double)(mean.psi - p.start.psi), 227.305432794110, 1e-11);
    CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, R(T), 0, &m) == VM_OK);
    near("motion", "x", (double)m.x, -0.428889714783, 1e-11);
    CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_COLLOCATION, R(T), R(2e-10), &m) == VM_OK); /* its least estimate is 1.5e-10 */
    near("motion", "exact x", (double)m.x, -0.428889521257, 1e-10);
    near("motion", "exact v", (double)m.v, 0.904081426548, 1e-10);
}

/* ---- Orders ---- */

/* The largest error of an order at the four times of a case */
static double largest_error(const vdp_case *s, int order)
{
    const vm_vdp_plan plan = plan_of(&s->c);
    double worst = 0;
    int i;
    for (i = 0; i < TIMES; i++) {
        vm_osc_motion m = {0, 0, 0, 0, 0, 0};
        CHECK(vm_vdp_plan_by_route(&plan, route_of(order), R(s->c.T * parts[i]), 0, &m) == VM_OK);
        worst = fmax(worst, error_at(&plan, s, i, &m));
    }
    return worst;
}

/* Slopes between two rates, of seven laws and of a table with points at fixed parts of T, each at six alpha. At the
   larger rate there are less than two vibrations between two points of the table, and the errors of 20 points add up;
   so the slopes of tables scatter (measured for order three: 2.65, and 2.5 to 3.2 down to rates of 1/2048). */
static void test_orders(void)
{
    enum { LAWS = 8, ALPHAS = 6, SMOOTH = 7 * ALPHAS };
    double slope[LAWS * ALPHAS];
    int order, i;
    CHECK(COUNT(vdp_orders) == 2 * LAWS * ALPHAS);
    if (is_float) { /* float holds no such orders */
        check_skipped++;
        return;
    }
    for (order = 1; order <= 3; order++) {
        for (i = 0; i < LAWS * ALPHAS; i++)
            slope[i] = log(largest_error(vdp_orders + 2 * i, order) / largest_error(vdp_orders + 2 * i + 1, order)) /
                       log(4);
        check_error("order", "laws", "", fabs(median(slope, SMOOTH) - order), 0.2, order, median(slope, SMOOTH));
        check_error("order", "table", "", order - median(slope + SMOOTH, ALPHAS), 0.5, order,
                    median(slope + SMOOTH, ALPHAS));
    }
}

/* ---- Estimates ---- */

static void judge_table(const vdp_case *cases, int count, int order, judgement *j)
{
    int k, i;
    for (k = 0; k < count; k++) {
        const vm_vdp_plan plan = plan_of(&cases[k].c);
        for (i = 0; i < TIMES; i++) {
            vm_osc_motion m = {0, 0, 0, 0, 0, 0};
            const int status = vm_vdp_plan_by_route(&plan, route_of(order), R(cases[k].c.T * parts[i]), 0, &m);
            CHECK(status == VM_OK || status == VM_NOT_INTEGRATED);
            if (status != VM_OK || !(m.error < VM_INFINITY)) { /* the law knows that it does not hold */
                j->unknown++;
                continue;
            }
            judge(j, error_at(&plan, cases + k, i, &m), (double)m.error);
        }
    }
}

static void test_estimates(void)
{
    enum { MOST = TIMES * COUNT(vdp_random) };
    static double sharp[MOST];
    static const char *const names[] = {"order 1", "order 2", "order 3"};
    static const char *const tables[] = {"table, 1", "table, 2", "table, 3"};
    int order;
    for (order = 1; order <= 3; order++) {
        judgement laws = {NULL, 0, 0, 0, 0}, knots = {NULL, 0, 0, 0, 0};
        laws.sharp = sharp;
        judge_table(vdp_random, COUNT(vdp_random), order, &laws);
        report(names[order - 1], &laws, 40, 3);
        knots.sharp = sharp;
        judge_table(vdp_tables, COUNT(vdp_tables), order, &knots);
        report(tables[order - 1], &knots, by_precision(60, 3000), by_precision(5, 30)); /* p' is noisy in float */
    }
}

#ifndef VM_USE_FLOAT
/* The estimate of order three where only a table of the mass and a small c disturb the oscillator: feed = 0,
   reactive = 1/2, constant stiffness. The derivative of m'/m makes most of the error then. */
static void test_estimate_without_feed(void)
{
    static vm_vdp_plan p;
    int i, j;
    for (i = 0; i < 20; i++) {
        const double rate = uniform(0.005, 0.04), T = uniform(1.5, 3.3) / rate;
        vm_real time[8], value[8];
        vm_osc_motion law = {0, 0, 0, 0, 0, 0}, exact = law;
        vm_vdp v;
        for (j = 0; j < 8; j++) {
            time[j] = R(j * 0.5 / rate);
            value[j] = R(j == 0 ? 1 : uniform(0.8, 1.3));
        }
        v = oscillator(uniform(0.5, 5), 0, 0.002, 0.5, vm_law_table(8, time, value));
        CHECK(vm_vdp_plan_init(&p, &v, R(uniform(0.5, 1.5)), R(uniform(-0.5, 0.5))) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, R(T), 0, &law) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_COLLOCATION, R(T), R(1e-12), &exact) >= 0);
        check_error("without feed", "true/est", "", fabs(law.x - exact.x) / exact.amplitude / law.error, 3, v.alpha,
                    rate);
    }
}
#endif

/* ---- To a tolerance ---- */

static void test_within(void)
{
    static const double tolerances[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10};
    int k, i, missed = 0, count = 0, by_law = 0;
    for (k = 0; k < COUNT(vdp_random); k += 3) {
        const vm_vdp_plan plan = plan_of(&vdp_random[k].c);
        for (i = 0; i < COUNT(tolerances); i++) {
            vm_osc_motion m = {0, 0, 0, 0, 0, 0};
            const double tolerance = tolerances[i];
            int status;
            double error;
            if (is_float && tolerance < 1e-4) continue;
            status = vm_vdp_plan_within(&plan, R(vdp_random[k].c.T), R(tolerance), &m);
            CHECK(status == VM_OK || status == VM_TOLERANCE_MISSED);
            error = error_at(&plan, vdp_random + k, TIMES - 1, &m);
            check_error("within", "true/est", "", error / (double)m.error, 10, k, tolerance);
            if (status != VM_OK) continue;
            count++;
            by_law += m.route <= VM_ROUTE_ORDER3;
            missed += error > tolerance;
            check_error("within", "true/tolerance", "", error / tolerance, 2, k, tolerance);
        }
    }
    check_error("within", "above tolerance", "%", 100. * missed / count, 1, missed, count);
    check_error("within", "not by the law", "%", 100. * (count - by_law) / count, 70, by_law, count);
}

/* ---- Time, laws and limits ---- */

/* The law and the integration agree at times of both signs, also before the start of the mean motion. */
static void test_times(void)
{
    static const double times[] = {-200, -30, -1, -1e-9, 0, 1e-12, 0.1, 0.7, 2, 31, 180};
    static const double alphas[] = {0.5, 1, 3};
    int i, k;
    for (k = 0; k < COUNT(alphas); k++) {
        const vm_vdp v = oscillator(alphas[k], 0.004, 0.006, 0.5, vm_law_exponential(1, R(0.002)));
        vm_vdp_plan p;
        CHECK(vm_vdp_plan_init(&p, &v, R(0.8), R(0.5)) == VM_OK);
        for (i = 0; i < COUNT(times); i++) {
            vm_osc_motion law = {0, 0, 0, 0, 0, 0}, exact = {0, 0, 0, 0, 0, 0};
            CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, R(times[i]), 0, &law) == VM_OK);
            CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_COLLOCATION, R(times[i]), R(by_precision(1e-10, 1e-4)), &exact) >= 0);
            check_error("times", "true/est", "", fabs((double)(law.x - exact.x) / (double)exact.amplitude) /
                        ((double)law.error + (double)exact.error), 1, times[i], alphas[k]);
        }
    }
}

static int linear_function(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = 1 + R(0.01) * t;
    *rate = R(0.01);
    return 0;
}

/* A user's function gives the motion of the law that it is equal to; a table gives nearly this motion, to both sides. */
static void test_kinds_of_law(void)
{
    vm_real at[9], value[9];
    vm_vdp v = oscillator(3, 0.01, 0.02, 1, vm_law_linear(1, R(0.01)));
    vm_osc_motion linear = {0, 0, 0, 0, 0, 0}, other = {0, 0, 0, 0, 0, 0};
    double t;
    int i;
    for (i = 0; i < 9; i++) {
        at[i] = R(-80 + 40 * i);
        value[i] = 1 + R(0.01) * at[i];
    }
    for (t = -70; t < 200; t += 30) {
        vm_vdp_plan p;
        v.mass = vm_law_linear(1, R(0.01));
        CHECK(vm_vdp_plan_init(&p, &v, R(0.5), 0) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, R(t), 0, &linear) == VM_OK);
        v.mass = vm_law_user(linear_function, NULL);
        CHECK(vm_vdp_plan_init(&p, &v, R(0.5), 0) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, R(t), 0, &other) == VM_OK);
        check_error("kinds", "function", "A", fabs((double)(other.x - linear.x)), by_precision(1e-11, 2e-4), t, 0);
        v.mass = vm_law_table(9, at, value);
        CHECK(vm_vdp_plan_init(&p, &v, R(0.5), 0) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, R(t), 0, &other) == VM_OK);
        check_error("kinds", "table", "est", fabs((double)(other.x - linear.x)) /
                    (double)(other.error + linear.error + R(by_precision(1e-9, 1e-3))), 1, t, 0);
    }
}

/* Laws whose calls are counted: a constant one, one that grows, a slow wave, and a jump from 1 to 3 within 0.2 s, for
   which the law of the motion does not hold */
static long calls_of_law;
static int counted(vm_real t, double f, double rate, vm_real *value, vm_real *value_rate)
{
    (void)t;
    calls_of_law++;
    *value = R(f);
    *value_rate = R(rate);
    return 0;
}
static int counted_constant(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    return counted(t, 2, 0, f, rate);
}
static int counted_growth(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    return counted(t, 2 + 0.01 * (double)(t * t), 0.02 * (double)t, f, rate);
}
static int counted_wave(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    return counted(t, 2 + 0.3 * sin(0.5 * (double)t), 0.15 * cos(0.5 * (double)t), f, rate);
}
static int counted_jump(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const double e = 10 * ((double)t - 1);
    (void)ctx;
    return counted(t, 2 + tanh(e), 10 / (cosh(e) * cosh(e)), f, rate);
}

/* The law calls a user's functions a few thousand times at most, for any t: a panel of time needs 24 calls for each
   law, and there are 32 panels where the laws change slowly. On short panels rounding errors hide the changes of a law,
   so that panels that were halved until the changes are resolved would never be short enough. The bounds have some reserve
   over the largest numbers found: 3129 for the wave and |t| = 300 in double, and 2760 for the plan, which looks for fast changes
   in the first quarter vibration. */
static void test_calls(void)
{
    static const vm_law_function functions[] = {counted_constant, counted_growth, counted_wave, counted_jump};
    static const double times[] = {0.5, 3, -3, 30, 300, -300};
    int i, k, both;
    for (i = 0; i < COUNT(functions) * COUNT(times) * 2; i++) {
        const double t = times[i / 2 % COUNT(times)];
        vm_vdp v = oscillator(1, 0.1, 0.1, 1, vm_law_user(functions[i / 2 / COUNT(times)], NULL));
        vm_osc_motion motion = {0, 0, 0, 0, 0, 0};
        vm_vdp_plan p;
        both = i % 2;
        if (both) v.stiffness = v.mass;
        calls_of_law = 0;
        CHECK(vm_vdp_plan_init(&p, &v, 1, R(0.3)) == VM_OK);
        check_error("calls", "plan", "calls", (double)calls_of_law / (1 + both), 3000, t, i);
        for (k = 2; k <= 3; k++) {
            calls_of_law = 0;
            CHECK(vm_vdp_plan_by_route(&p, route_of(k), R(t), 0, &motion) == VM_OK);
            check_error("calls", "order", "calls", (double)calls_of_law / (1 + both), 3600, t, i);
        }
    }
}

/* Without feed, limit and change of mass the law is exact; without c it is that of the oscillator without feed. */
static void test_removable(void)
{
    static const double alphas[] = {0, 0.5, 1, 3, 10};
    int k;
    for (k = 0; k < COUNT(alphas); k++) {
        vm_vdp v = oscillator(alphas[k], 0, 0, 1, vm_law_linear(1, 0));
        vm_osc_motion m = {0, 0, 0, 0, 0, 0}, same = {0, 0, 0, 0, 0, 0};
        vm_osc_problem o = problem(alphas[k], vm_law_linear(1, R(0.003)), 1, 0.002);
        vm_vdp_plan p;
        vm_real x, rate;
        CHECK(vm_vdp_plan_init(&p, &v, R(0.75), R(0.25)) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, 20, 0, &m) == VM_OK);
        vm_osc_exact_from(20, R(0.75), R(0.25), 1, R(alphas[k]), &x, &rate);
        check_error("exact", "x", "eps", fabs((double)(m.x - x)) / eps, 200, alphas[k], 0);
        check_error("exact", "estimate", "eps", (double)m.error / eps, 1000, alphas[k], 0);
        v = oscillator(alphas[k], -0.002, 0, 1, o.mass);
        CHECK(vm_vdp_plan_init(&p, &v, R(0.75), R(0.25)) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, 200, 0, &m) == VM_OK);
        o.x = R(0.75);
        o.v = R(0.25);
        CHECK(vm_osc_within(&o, 200, R(by_precision(1e-10, 1e-4)), &same) >= 0);
        check_error("c = 0", "true/est", "", fabs((double)(m.x - same.x)) / ((double)m.error + (double)same.error), 1,
                    alphas[k], 0);
    }
}

/* x at t by order three, from x0 and v0 */
static double x_at(const vm_vdp *v, double x0, double v0, double t)
{
    static vm_vdp_plan plan;
    vm_osc_motion m = {0, 0, 0, 0, 0, 0};
    CHECK(vm_vdp_plan_init(&plan, v, R(x0), R(v0)) == VM_OK);
    CHECK(vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER3, R(t), 0, &m) == VM_OK);
    return (double)m.x;
}

/* Where something cancels, the motion is continuous: a mass that is nearly constant, a start next to the limit cycle, an
   amplitude that tends to 0, a feed that tends to 0, and a start next to a zero of sa or ca. */
static void test_hard_points(void)
{
    static const double alphas[3] = {1, 4. / 3, 3};
    const double tiny_rate = by_precision(1e-14, 1e-6), rounding = by_precision(1e-8, 1e-3), t = 300;
    int k, i;
    for (k = 0; k < 3; k++) {
        vm_vdp v = oscillator(alphas[k], 0.01, 0.01, 1, vm_law_linear(1, 0)), other = v;
        const double near_cycle = 2 / sqrt(1 + 0.01 * 0.01 / 4), one = x_at(&v, 0.5, 0.1, t);
        other.mass = vm_law_linear(1, R(tiny_rate));
        check_error("hard points", "mass -> const", "abs", fabs(x_at(&other, 0.5, 0.1, t) - one),
                    by_precision(3e-8, 0.3), alphas[k], 0); /* the closed form leaves out terms of order four */
        for (i = -1; i <= 1; i += 2) {
            const double next = by_precision(1e-11, 1e-6) * i;
            check_error("hard points", "limit cycle", "abs",
                        fabs(x_at(&v, near_cycle + next, 0, t) - x_at(&v, near_cycle, 0, t)), rounding, alphas[k], i);
            check_error("hard points", "sa -> 0", "abs", fabs(x_at(&v, 0.75, next, t) - x_at(&v, 0.75, 0, t)),
                        rounding, alphas[k], i);
            check_error("hard points", "ca -> 0", "abs", fabs(x_at(&v, next * 1e-3, 1, t) - x_at(&v, 0, 1, t)),
                        rounding, alphas[k], i);
        }
        if (alphas[k] != 1) continue;
        check_error("hard points", "amplitude -> 0", "rel",
                    fabs(x_at(&v, 1e-9, 0, t) / x_at(&v, 1e-12, 0, t) / 1e3 - 1), by_precision(1e-12, 1e-4), 0, 0);
        other = oscillator(1, 1e-10, 0.01, 1, vm_law_linear(1, 0)); /* z beyond the closed form */
        v = oscillator(1, 0, 0.01, 1, vm_law_linear(1, 0));
        check_error("hard points", "feed -> 0", "abs", fabs(x_at(&other, 1, 0, t) - x_at(&v, 1, 0, t)),
                    by_precision(1e-7, 1e-3), 0, 0);
    }
}

/* With c < 0 the amplitude becomes infinite: y = 1 - (1/4) 0.2 t = 0 for alpha = 1, A = 1, at t = 20. The law refuses
   times beyond, and so does the choice of a route. */
static void test_infinite(void)
{
    const vm_vdp v = oscillator(1, 0, -0.2, 1, vm_law_linear(1, 0));
    static vm_vdp_plan p;
    vm_osc_motion m, before;
    int order;
    memset(&m, 7, sizeof m);
    before = m;
    CHECK(vm_vdp_plan_init(&p, &v, 1, 0) == VM_OK);
    for (order = 1; order <= 3; order++) CHECK(vm_vdp_plan_by_route(&p, route_of(order), 40, 0, &m) == VM_NOT_FINITE);
    CHECK(vm_vdp_plan_within(&p, 40, 0, &m) < 0);
    CHECK(memcmp(&m, &before, sizeof m) == 0);
    CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, -40, 0, &m) == VM_OK); /* backward the amplitude falls */
}

/* The mean motion may have no start forward in time: a table has a point within a quarter of a vibration of t = 0, the mass
   soon becomes 0, or the amplitude soon becomes infinite. The motion backward in time is then found all the same, and is that
   of the problem mirrored in time, whose start is forward. */
static void test_no_start_forward(void)
{
    static const vm_real after[3] = {-30, R(0.1), 30}, before[3] = {-30, R(-0.1), 30};
    static const vm_real rising[3] = {1, R(1.01), R(1.02)}, falling[3] = {R(1.02), R(1.01), 1};
    static const double numbers[4][5] = {/* alpha, feed and c, x and x' at t = 0 */
                                         {1, 0.02, 0.02, 1, 0.3}, {1, 0, 0.02, 1, -0.01},
                                         {1, -1.29426, -2.53948, 1.05506, 1.09773},
                                         {1.5, -0.968685, -2.90063, -1.04538, -0.708437}};
    static const int statuses[4] = {VM_NOT_INTEGRATED, VM_BAD_MASS, VM_NOT_INTEGRATED, VM_NOT_INTEGRATED};
    const vm_law masses[4] = {vm_law_table(3, after, rising), vm_law_linear(1, R(-0.8)), vm_law_linear(1, 0),
                              vm_law_linear(1, 0)};
    const vm_law mirrored[4] = {vm_law_table(3, before, falling), vm_law_linear(1, R(0.8)), vm_law_linear(1, 0),
                                vm_law_linear(1, 0)};
    static vm_vdp_plan p, mirror;
    int i, order;
    for (i = 0; i < 4; i++) {
        const double *n = numbers[i];
        const vm_vdp v = oscillator(n[0], n[1], n[2], 1, masses[i]), w = oscillator(n[0], -n[1], -n[2], 1, mirrored[i]);
        vm_osc_motion m = {0, 0, 0, 0, 0, 0}, other = {0, 0, 0, 0, 0, 0}, exact = {0, 0, 0, 0, 0, 0};
        CHECK(vm_vdp_plan_init(&p, &v, R(n[3]), R(n[4])) == VM_OK && vm_vdp_plan_init(&mirror, &w, R(n[3]), R(-n[4])) == VM_OK);
        for (order = 1; order <= 3; order++) {
            CHECK(vm_vdp_plan_by_route(&p, route_of(order), 10, 0, &m) == statuses[i]);
            CHECK(vm_vdp_plan_by_route(&p, route_of(order), -10, 0, &m) == VM_OK);
            CHECK(vm_vdp_plan_by_route(&mirror, route_of(order), 10, 0, &other) == VM_OK);
            check_error("no start forward", "mirror", "abs", fabs((double)(m.x - other.x)), by_precision(1e-13, 1e-4), i, order);
            check_error("no start forward", "mirror, v", "abs", fabs((double)(m.v + other.v)), by_precision(1e-13, 1e-4), i,
                        order);
        }
        if (i > 0) continue; /* the mass or the amplitude changes fast: the law is coarse */
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_RK87, -10, R(by_precision(1e-9, 1e-4)), &exact) >= 0);
        check_error("no start forward", "true/est", "", fabs((double)(m.x - exact.x) / (double)exact.amplitude) /
                    ((double)m.error + (double)exact.error), 1, 0, 0);
        check_error("no start forward", "estimate", "rel", fabs((double)(m.error / other.error - 1)), 0.2, 0, 0);
        check_error("no start forward", "x(-10)", "abs", fabs((double)m.x + 0.660107), by_precision(1e-6, 1e-4), 0, 0);
    }
}

/* Fast changes, strong terms, and extreme alpha: the estimate says that the law does not hold, and the choice of a
   route integrates. */
static void test_not_slow(void)
{
    static const double strong[][3] = {{1, 5, 5}, {3, 1, 2}, {0.5, 0.5, 1}, {100, 0.1, 0.1}, {1000, 0.01, 0.01}};
    int i;
    for (i = 0; i < COUNT(strong); i++) {
        const vm_vdp v = oscillator(strong[i][0], strong[i][1], strong[i][2], 1, vm_law_linear(1, 0));
        const double tolerance = by_precision(1e-7, 1e-3);
        static vm_vdp_plan p;
        vm_osc_motion m = {0, 0, 0, 0, 0, 0}, exact = {0, 0, 0, 0, 0, 0};
        CHECK(vm_vdp_plan_init(&p, &v, 1, 0) == VM_OK);
        if (vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, 12, 0, &m) == VM_OK) CHECK(m.error > R(1e-4));
        CHECK(vm_vdp_plan_within(&p, 12, R(tolerance), &m) >= 0);
        CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_RK87, 12, R(tolerance / 10), &exact) >= 0);
        check_error("not slow", "x", "est", fabs((double)(m.x - exact.x)) / (double)(m.amplitude * (m.error + exact.error)),
                    3, strong[i][0], strong[i][1]);
    }
}

/* ---- The limit cycle ---- */

/* x', whose zeros are the turning points */
static vm_real turning(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1];
}

/* Largest x and period by rk87 on the limit cycle: the last of many turning points, and the mean distance of the last
   six. The run starts so close to the cycle that only 1e-10 of the difference is left. */
static void measure_cycle(vm_vdp *v, const vm_vdp_cycle *start, double *largest, double *period)
{
    enum { ROOM = 400, USED = 5 };
    static vm_real times[ROOM], states[2 * ROOM];
    ode_event event;
    rk87_options options;
    vm_real y[2], work[RK87_WORK(2)];
    rk87 s;
    memset(&event, 0, sizeof event);
    memset(&options, 0, sizeof options);
    event.g = turning;
    event.direction = -1;
    event.room = ROOM;
    event.times = times;
    event.states = states;
    options.rtol = options.atol = R(1e-12);
    options.events = &event;
    options.n_events = 1;
    y[0] = start->largest_x;
    y[1] = 0;
    CHECK(rk87_init(&s, vm_vdp_rhs, v, 2, 0, y, &options, work) >= 0);
    CHECK(rk87_solve(&s, R(20 / (double)v->feed)) >= 0);
    CHECK(event.count > USED && event.count <= ROOM);
    *largest = (double)states[2 * (event.count - 1)];
    *period = (double)(times[event.count - 1] - times[event.count - 1 - USED]) / USED;
}

/* The errors of both fall with epsilon^4. */
static void test_cycle(void)
{
    static const double alphas[] = {0.5, 1, 4. / 3, 3, 5};
    int i, k;
    if (is_float) { /* rk87 in float is less accurate than the series */
        check_skipped++;
        return;
    }
    for (i = 0; i < COUNT(alphas); i++) {
        double x_error[2] = {0, 0}, period_error[2] = {0, 0};
        for (k = 0; k < 2; k++) {
            vm_vdp v = oscillator(alphas[i], k ? 0.1 : 0.2, k ? 0.1 : 0.2, 1, vm_law_linear(1, 0));
            vm_vdp_cycle cycle = {0, 0, 0, 0};
            double largest = 0, period = 0, power;
            CHECK(vm_vdp_cycle_of(&v, &cycle) == VM_OK && cycle.stable == 1);
            measure_cycle(&v, &cycle, &largest, &period);
            x_error[k] = fabs((double)cycle.largest_x / largest - 1);
            period_error[k] = fabs((double)cycle.period / period - 1);
            power = pow((double)cycle.epsilon, 4);
            check_error("cycle", "largest x", "eps^4", x_error[k] / (power + eps * 100), 0.2, alphas[i], k);
            check_error("cycle", "period", "eps^4", period_error[k] / (power + eps * 100), 0.2, alphas[i], k);
        }
        check_error("cycle", "largest x, slope", "", fabs(log(x_error[0] / x_error[1]) / log(2) - 4), 0.1, alphas[i], 0);
        check_error("cycle", "period, slope", "", fabs(log(period_error[0] / period_error[1]) / log(2) - 4), 0.1, alphas[i],
                    0);
    }
}

/* The limit cycle is that of time 0: a stiffness that would be negative later is no error. */
static void test_cycle_of_time_0(void)
{
    vm_vdp v = oscillator(1, 0.1, 0.1, 1, vm_law_linear(1, 0));
    vm_vdp_cycle cycle, later;
    CHECK(vm_vdp_cycle_of(&v, &cycle) == VM_OK);
    v.stiffness = vm_law_linear(v.k, -2 * v.k);
    CHECK(vm_vdp_cycle_of(&v, &later) == VM_OK && later.largest_x == cycle.largest_x && later.period == cycle.period);
}

/* ---- Refusals ---- */

static void test_refusals(void)
{
    const vm_vdp good = oscillator(1, 0.1, 0.1, 1, vm_law_linear(1, 0));
    static const int routes[] = {VM_ROUTE_ATEB, VM_ROUTE_ORDER2, VM_ROUTE_ORDER3, VM_ROUTE_COLLOCATION, VM_ROUTE_RK87};
    static vm_vdp_plan p, q, untouched;
    vm_vdp bad = good;
    vm_osc_motion m, before;
    vm_vdp_cycle cycle, cycle_before;
    int i;
    memset(&m, 7, sizeof m);
    before = m;
    memset(&cycle, 7, sizeof cycle);
    cycle_before = cycle;
    memset(&q, 7, sizeof q);
    untouched = q;
    CHECK(vm_vdp_plan_init(&p, &good, 1, 0) == VM_OK);
    CHECK(vm_vdp_plan_init(NULL, &good, 1, 0) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_init(&q, NULL, 1, 0) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_init(&q, &good, VM_INFINITY, 0) == VM_NOT_FINITE);
    bad.alpha = -1;
    CHECK(vm_vdp_plan_init(&q, &bad, 1, 0) == VM_DOMAIN);
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_DOMAIN);
    bad.k = 0;
    CHECK(vm_vdp_plan_init(&q, &bad, 1, 0) == VM_BAD_STIFFNESS);
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_BAD_STIFFNESS);
    bad.mass = vm_law_linear(-1, 0);
    CHECK(vm_vdp_plan_init(&q, &bad, 1, 0) == VM_BAD_MASS);
    bad.c = VM_NAN;
    CHECK(vm_vdp_plan_init(&q, &bad, 1, 0) == VM_NOT_FINITE);
    CHECK(vm_vdp_within(&bad, 1, 0, 1, 0, &m) == VM_NOT_FINITE);
    CHECK(memcmp(&q, &untouched, sizeof q) == 0);
    CHECK(vm_vdp_plan_by_route(NULL, VM_ROUTE_ORDER3, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER3, 1, 0, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_ORDER4, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_by_route(&p, VM_ROUTE_TRIG, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_within(NULL, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_within(NULL, 1, 0, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_within(&good, 1, 0, 1, 0, NULL) == VM_BAD_ARGUMENT);
    for (i = 0; i < COUNT(routes); i++) {
        CHECK(vm_vdp_plan_by_route(&p, routes[i], VM_NAN, 0, &m) == VM_NOT_FINITE);
        CHECK(vm_vdp_plan_by_route(&p, routes[i], 1, -1, &m) == VM_DOMAIN);
    }
    CHECK(vm_vdp_plan_within(&p, 1, VM_INFINITY, &m) == VM_NOT_FINITE);
    CHECK(vm_vdp_cycle_of(NULL, &cycle) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_cycle_of(&good, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_NOT_FINITE);
    bad = good;
    bad.mass = vm_law_linear(0, 1);
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_BAD_MASS);
    bad = good;
    bad.method = 7;
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_plan_init(&q, &bad, 1, 0) == VM_BAD_ARGUMENT);
    bad = good;
    bad.c = -bad.c;
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_NO_LAW);
    CHECK(memcmp(&m, &before, sizeof m) == 0 && memcmp(&cycle, &cycle_before, sizeof cycle) == 0);
    bad.feed = -bad.feed;
    CHECK(vm_vdp_cycle_of(&bad, &cycle) == VM_OK && cycle.stable == 0);
    bad = good;
    bad.mass = vm_law_linear(1, R(-0.5));
    CHECK(vm_vdp_plan_init(&p, &bad, 1, 0) == VM_OK);
    CHECK(vm_vdp_plan_within(&p, 3, 0, &m) == VM_BAD_MASS);
    CHECK(vm_vdp_plan_init(&p, &good, 0, 0) == VM_OK); /* a body at rest stays at rest */
    CHECK(vm_vdp_plan_within(&p, 3, 0, &m) == VM_OK && m.x == 0 && m.v == 0 && m.error == 0);
}

/* ---- Slow stiffness ---- */

#ifndef VM_USE_FLOAT
/* Law number 0 to 2: the stiffness rises with constant mass, falls, and has a table */
static vm_vdp with_stiffness(int number, double alpha, double small_rate, vm_real *time, vm_real *value)
{
    vm_vdp v = oscillator(alpha, small_rate, small_rate, 0.5, vm_law_linear(1, number == 1 ? small_rate / 2 : 0));
    int i;
    if (number == 0) v.stiffness = vm_law_exponential(1, 0.4 * small_rate);
    if (number == 1) v.stiffness = vm_law_linear(1, -0.2 * small_rate);
    if (number < 2) return v;
    for (i = 0; i < 4; i++) {
        time[i] = 1.2 * i / small_rate;
        value[i] = 1 + 0.2 * i;
    }
    v.stiffness = vm_law_table(4, time, value);
    return v;
}

/* Order three keeps its order where the stiffness follows a law, and its estimate holds. */
static void test_slow_stiffness(void)
{
    static const double alphas[4] = {1, 4. / 3, 3, 5};
    static vm_vdp_plan plan;
    int number, k, n, i;
    for (number = 0; number < 3; number++)
        for (k = 0; k < 4; k++) {
            double error[2] = {0, 0}, share = 0;
            for (n = 0; n < 2; n++) {
                const double small_rate = 0.04 / (1 << (2 * n));
                vm_real time[4], value[4];
                const vm_vdp v = with_stiffness(number, alphas[k], small_rate, time, value);
                CHECK(vm_vdp_plan_init(&plan, &v, 1.3, 0.4) == VM_OK);
                for (i = 0; i < 8; i++) {
                    const double t = (2.1 + 0.1 * i) / small_rate;
                    vm_osc_motion exact = {0, 0, 0, 0, 0, 0}, m = exact;
                    double now;
                    CHECK(vm_vdp_plan_by_route(&plan, VM_ROUTE_COLLOCATION, t, 1e-12, &exact) >= 0);
                    CHECK(vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER3, t, 0, &m) == VM_OK);
                    now = fabs(m.x - exact.x) / exact.amplitude;
                    error[n] = fmax(error[n], now);
                    share = fmax(share, now / m.error);
                }
            }
            check_error("slow stiffness", "slope - 3", "abs", fabs(log(error[0] / error[1]) / log(4) - 3), 1, number,
                        alphas[k]);
            check_error("slow stiffness", "error/estimate", "", share, 1, number, alphas[k]);
        }
}
#endif

#ifndef VM_USE_FLOAT
/* With constant mass the mean motion in closed form (alpha = 1), or by a walk that ends on the limit cycle, is that of
   the walk to the end, forward and backward in time. */
static void test_constant_mass(void)
{
    static const double cases[6][3] = {{0.01, 0.01, 0.5}, {0.01, 0.01, 3.2},  {0.01, 0.01, 1.99},
                                       {-0.005, 0.01, 1}, {-0.01, -0.002, 0.5}, {0.01, 1e-5, 0.01}};
    static const double times[5] = {3, 100, 400, -60, 2500}, alphas[3] = {1, 4. / 3, 3};
    static vm_vdp_plan plan;
    int i, k, n;
    for (i = 0; i < 6; i++)
        for (k = 0; k < 3; k++) {
            const vm_vdp v = oscillator(alphas[k], cases[i][0], cases[i][1], 1, vm_law_linear(1, 0));
            CHECK(vm_vdp_plan_init(&plan, &v, cases[i][2], 0.3) == VM_OK);
            for (n = 0; n < (k == 0 ? 5 : 3); n++) {
                const double turns = 1 + fabs(times[n]);
                vmi_vdp_mean closed, walked;
                const int status = vmi_vdp_mean_at(&plan, times[n], &walked);
                CHECK(vmi_vdp_mean_motion(&plan, times[n], &closed) == status);
                if (status) continue; /* the amplitude becomes infinite */
                check_error("constant mass", "ln A", "abs", fabs(closed.ln_A - walked.ln_A), 1e-13, i, times[n]);
                check_error("constant mass", "psi/turn", "abs", fabs(closed.psi - walked.psi) / turns, 1e-8, i,
                            times[n]); /* the closed form leaves out terms of order four of the rate of psi */
                check_error("constant mass", "ln A, order 1", "abs", fabs(closed.first_ln_A - walked.first_ln_A), 1e-12, i,
                            times[n]);
                CHECK(closed.t == walked.t && closed.J_error <= 1.01 * walked.J_error + 1e-15);
            }
        }
}

/* On the limit cycle, which a motion reaches after some 600 s for feed = 0.1, the rest of the walk is one step. */
static void test_on_cycle(void)
{
    static const double alphas[2] = {4. / 3, 3}, times[3] = {800, 1000, -1000};
    static vm_vdp_plan plan;
    int k, n;
    for (k = 0; k < 2; k++)
        for (n = 0; n < 3; n++) {
            const double sign = times[n] > 0 ? 1 : -1; /* backward in time a motion tends to a cycle if the feed is < 0 */
            const vm_vdp v = oscillator(alphas[k], sign * 0.1, sign * 0.1, 1, vm_law_linear(1, 0));
            vmi_vdp_mean stayed, walked;
            CHECK(vm_vdp_plan_init(&plan, &v, 0.5, 0.3) == VM_OK);
            CHECK(vmi_vdp_mean_at(&plan, times[n], &walked) == VM_OK);
            CHECK(vmi_vdp_mean_motion(&plan, times[n], &stayed) == VM_OK && stayed.t == walked.t);
            check_error("on the cycle", "ln A", "abs", fabs(stayed.ln_A - walked.ln_A), 1e-13, alphas[k], times[n]);
            check_error("on the cycle", "psi", "rel", fabs(stayed.psi / walked.psi - 1), 1e-13, alphas[k], times[n]);
            check_error("on the cycle", "psi, order 1", "rel", fabs(stayed.first_psi / walked.first_psi - 1), 1e-13, alphas[k],
                        times[n]);
        }
}

/* A motion that has settled takes no more steps: the phase after 1e9 s, which grows at the rate of the cycle, is found at
   once. (Step by step it would take minutes.) */
static void test_long_after_settling(void)
{
    static vm_vdp_plan plan;
    const vm_vdp v = oscillator(3, 0.1, 0.1, 1, vm_law_linear(1, 0));
    vmi_vdp_mean first, second, last;
    CHECK(vm_vdp_plan_init(&plan, &v, 0.5, 0.3) == VM_OK && vmi_vdp_mean_motion(&plan, 1000, &first) == VM_OK);
    CHECK(vmi_vdp_mean_motion(&plan, 2000, &second) == VM_OK && vmi_vdp_mean_motion(&plan, 1e9, &last) == VM_OK);
    check_error("long after", "psi", "rel", fabs((last.psi - second.psi) / ((second.psi - first.psi) * (1e6 - 2)) - 1), 1e-11,
                1e9, 0);
}
#endif

static void test_stiffness_refused(void)
{
    vm_vdp v = oscillator(3, 0.01, 0.01, 1, vm_law_linear(1, 0));
    static vm_vdp_plan plan;
    vm_real y[2] = {1, 1}, d[2] = {7, 7};
    vm_osc_motion m;
    memset(&m, 0, sizeof m);
    v.stiffness = vm_law_linear(-1, 0);
    CHECK(vm_vdp_plan_init(&plan, &v, 1, 0) == VM_BAD_STIFFNESS && vm_vdp_rhs(0, y, d, &v) == VM_BAD_STIFFNESS);
    v.stiffness = vm_law_linear(1, VM_NAN);
    CHECK(vm_vdp_plan_init(&plan, &v, 1, 0) == VM_NOT_FINITE && vm_vdp_averaged_rhs(0, y, d, &v) == VM_NOT_FINITE);
    v.stiffness = vm_law_linear(1, R(-0.5));
    CHECK(vm_vdp_plan_init(&plan, &v, 1, 0) == VM_OK);
    CHECK(vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER3, 4, 0, &m) == VM_BAD_STIFFNESS);
    v.k = 0; /* the law takes the place of k */
    CHECK(vm_vdp_init(&v) == VM_OK && vm_vdp_rhs(0, y, d, &v) == VM_OK && !VM_IS_FINITE(vm_vdp_amplitude(&v, 1, 1)));
}

/* 1 + 0.3 tanh(z), z = (t - 0.1)/w, with w in ctx */
static int early_jump(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const double w = *(const double *)ctx, z = ((double)t - 0.1) / w;
    *f = (vm_real)(1 + 0.3 * tanh(z));
    *rate = (vm_real)(0.3 / w / (cosh(z) * cosh(z)));
    return 0;
}

/* The mass jumps within the first quarter vibration. One step of collocation integrated this quarter, and its nodes missed the
   jump: the error was 0.2 amplitudes, its estimate 1e-5. x and v by rk87 with the tolerance 1e-12 and steps of at most w/2. */
static void test_early_jump(void)
{
    static const struct {
        double w, t, x, v;
        int known; /* is change_time set? */
    } motions[] = {{0.003, 20, -0.3931957, 0.8219956, 1}, {0.003, 0.4, 0.967761, 0.270789, 0}};
    int i;
    for (i = 0; i < COUNT(motions); i++) {
        double w = motions[i].w;
        vm_osc_motion m;
        vm_vdp v;
        memset(&v, 0, sizeof v);
        v.alpha = 1;
        v.k = 1;
        v.feed = R(1e-4);
        v.c = R(1e-4);
        v.mass = vm_law_user(early_jump, &w);
        if (motions[i].known) v.mass.change_time = R(w);
        CHECK(vm_vdp_init(&v) == VM_OK && vm_vdp_within(&v, R(0.8), R(0.6), R(motions[i].t), R(1e-3), &m) >= 0);
        check_error("early jump", "x", "tol", fabs((double)m.x - motions[i].x) / 1e-3, 1, i, 0);
        check_error("early jump", "v", "tol", fabs((double)m.v - motions[i].v) / 1e-3, 1, i, 0);
    }
}

/* c is so small that the exact motion without it is right to the last digits. */
static void test_nearly_exhausted(void)
{
    double left;
    for (left = 1e-2; left > (is_float ? 1e-4 : 1e-9); left /= 3) {
        const exhausted_motion e = nearly_exhausted(left);
        vm_osc_motion m;
        vm_vdp v;
        memset(&v, 0, sizeof v);
        v.alpha = 1;
        v.k = e.stiffness;
        v.mass = e.mass;
        v.reactive = R(0.5);
        v.c = R(1e-18);
        CHECK(vm_vdp_init(&v) == VM_OK && vm_vdp_within(&v, 1, 1, e.t, R(by_precision(1e-6, 1e-2)), &m) == VM_OK);
        check_error("nearly exhausted", "law", "est", exhausted_ratio(&e, m.x, m.v, m.error), 1, left, (double)e.t);
    }
}

int main(void)
{
    test_constants();
    test_ripple();
    test_check_values();
    test_orders();
    test_estimates();
    test_within();
    test_times();
    test_kinds_of_law();
    test_calls();
    test_removable();
    test_hard_points();
    test_infinite();
    test_no_start_forward();
    test_not_slow();
    test_cycle();
    test_cycle_of_time_0();
#ifndef VM_USE_FLOAT
    test_slow_stiffness();
    test_estimate_without_feed();
    test_constant_mass();
    test_on_cycle();
    test_long_after_settling();
#endif
    test_stiffness_refused();
    test_refusals();
    test_early_jump();
    test_nearly_exhausted();
    return check_finish("van_der_pol_law");
}
