/* Integration from zero to zero of x: Gauss' rules, motions of smooth and non-smooth forces of the spring, with tables,
   further forces and backward in time, and the estimates of their errors. tests/gen/slow_motion_reference.c computes the
   motions without the headers. */
#include <fenv.h>
#include <stdlib.h>
#include "../varmass.h"
#include "check.h"
#include "oscillator_checks.h"
#include "routes_problems.h"
#include "slow_motions.h"

/* ---- Gauss' rules ---- */

/* Chebyshev's polynomial T_k(2x - 1) on [0, 1], its derivative, and its integral from 0 to x */
static double chebyshev(int k, double x) { return cos(k * acos(2 * x - 1)); }

static double chebyshev_slope(int k, double x)
{
    const double angle = acos(2 * x - 1);
    return 2 * k * sin(k * angle) / sin(angle);
}

static double chebyshev_integral(int k, double x)
{
    const double at_0 = k % 2 ? 1 : -1; /* T_(k+1) and T_(k-1) where x = 0 */
    if (k == 0) return x;
    if (k == 1) return x * x - x;
    return (chebyshev(k + 1, x) - at_0) / (4 * (k + 1)) - (chebyshev(k - 1, x) - at_0) / (4 * (k - 1));
}

/* Weights, integrals and derivatives of a rule of n points are right for polynomials of degree 2n - 1, n - 1, n - 1. */
static void test_rules(void)
{
    static vmi_gauss_rule rule;
    int n, k, i, j;
    for (n = 2; n <= VMI_NODES; n++) {
        vmi_gauss_rule_init(&rule, n);
        CHECK(rule.n == n);
        for (k = 0; k < 2 * n; k++) {
            double sum = 0;
            for (j = 0; j < n; j++) sum += (double)rule.weight[j] * chebyshev(k, (double)rule.node[j]);
            check_error("Gauss' rule", "weights", "eps", fabs(sum - (k % 2 ? 0 : 1. / (1 - k * k))) / eps, 25, n, k);
        }
        for (k = 0; k < n; k++)
            for (i = 0; i < n; i++) {
                const double x = (double)rule.node[i];
                double integral = 0, derivative = 0;
                for (j = 0; j < n; j++) {
                    integral += (double)rule.integral[i][j] * chebyshev(k, (double)rule.node[j]);
                    derivative += (double)rule.derivative[i][j] * chebyshev(k, (double)rule.node[j]);
                }
                check_error("Gauss' rule", "integrals", "eps", fabs(integral - chebyshev_integral(k, x)) / eps, 15, n, k);
                check_error("Gauss' rule", "derivatives", "eps n^4",
                            fabs(derivative - chebyshev_slope(k, x)) / (eps * pow(n, 4)), 1, n, k);
            }
    }
}

/* A graded rule integrates x^(1/2) on [0, 1] with an error that falls as n^-8, that of Gauss' rule falls as n^-3. */
static void test_grading(void)
{
    static vmi_gauss_rule rule;
    int n, i, j;
    for (n = 4; n <= VMI_NODES; n += 4) {
        double whole = 0;
        vmi_gauss_rule_init(&rule, n);
        vmi_gauss_rule_grade(&rule);
        for (j = 0; j < n; j++) whole += (double)rule.weight[j] * sqrt((double)rule.node[j]);
        check_error("graded rule", "root", "n^-8 + eps", fabs(whole - 2. / 3) / (pow(n, -8) + eps), 20, n, 0);
        for (i = 0; i < n; i++) {
            double sum = 0;
            for (j = 0; j < n; j++) sum += (double)rule.integral[i][j];
            check_error("graded rule", "integrals of 1", "eps", fabs(sum - (double)rule.node[i]) / eps, 15, n, i);
        }
    }
}

/* ---- What the rules miss ---- */

/* One of the four functions of VMI_MISSES at the part x of a step */
static double missed_function(int k, double x, vm_real sa, vm_real ca)
{
    const double f = (double)ca * (double)(k < VMI_MISSES_SACA ? ca : sa);
    return k == VMI_MISSES_CA2_X || k == VMI_MISSES_SACA_X ? f * (x - 0.5) : f;
}

/* The integral of the function from 0 to x by Simpson's rule on short intervals that become shorter towards both ends,
   which may be zeros of x */
static double missed_integral(const vmi_osc_course *c, int k, double from, double length, double x)
{
    enum { INTERVALS = 400 };
    double sum = 0;
    int i;
    for (i = 0; i <= 2 * INTERVALS; i++) {
        const double u = i / (2. * INTERVALS), at = x * u * u * (3 - 2 * u), slope = 6 * x * u * (1 - u);
        const double weight = i == 0 || i == 2 * INTERVALS ? 1 : 2 + 2 * (i % 2);
        vm_real sa, ca;
        vmi_osc_wave_at(&c->wave, R(from + length * at), &ca, &sa);
        sum += weight / (6. * INTERVALS) * slope * missed_function(k, at, sa, ca);
    }
    return sum;
}

/* The rule plus what it misses is the integral, for whole half periods, for parts of them, and backward. */
static void test_misses(void)
{
    static const double alphas[4] = {0, 0.5, 4. / 3, 5}, starts[3] = {-0.5, 0.1, 0.5}, lengths[3] = {1, 0.3, -1};
    static vm_osc_plan plan;
    static vmi_osc_course c;
    static vmi_step_waves w;
    int a, s, n, i, j, k;
    for (a = 0; a < 4; a++) {
        const vm_osc_problem o = problem(alphas[a], vm_law_linear(1, R(0.01)), 1, 0);
        CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
        for (n = 2; n <= 5; n += 3) {
            vmi_osc_course_start(&c, &plan, &plan.mean, 1, n, 1, R(1e-6));
            for (s = 0; s < 3; s++) {
                const double half = (double)plan.ripple.pi, from = starts[s] * half, length = lengths[s] * half;
                vmi_osc_course_waves(&c, R(from), R(length), &w);
                for (k = 0; k < VMI_MISSES; k++)
                    for (i = 0; i <= n; i++) {
                        double sum = (double)w.misses[i][k];
                        for (j = 0; j < n; j++)
                            sum += (double)c.rule.integral[i][j] *
                                   missed_function(k, (double)c.rule.node[j], w.sa[j], w.ca[j]);
                        sum -= missed_integral(&c, k, from, length, i < n ? (double)c.rule.node[i] : 1);
                        check_error("misses", "rule + misses", "", fabs(sum), by_precision(1e-9, 2e-6), alphas[a], k);
                    }
            }
        }
    }
}

/* ---- Motions ---- */

typedef struct judgement {
    const char *name;
    double sharp[4000]; /* estimate by true error */
    int count, beyond, missed, refused;
    double worst;
} judgement;

static int rising(const void *a, const void *b)
{
    const double d = *(const double *)a - *(const double *)b;
    return d < 0 ? -1 : d > 0;
}

/* One motion that was asked for to a tolerance: its status, its true error, and what the route says of it */
static void judge(judgement *j, int status, double error, const vm_osc_motion *m, double tolerance)
{
    CHECK(status == VM_OK || status == VM_TOLERANCE_MISSED || status == VM_NOT_INTEGRATED);
    if (status == VM_NOT_INTEGRATED) {
        j->refused++;
        return;
    }
    CHECK(m->route == VM_ROUTE_COLLOCATION && m->evals > 0);
    CHECK((status == VM_OK) == ((double)m->error <= tolerance));
    j->missed += status == VM_TOLERANCE_MISSED;
    j->sharp[j->count++] = (double)m->error / fmax(error, 1e-300);
    j->beyond += error > 3 * (double)m->error;
    j->worst = fmax(j->worst, error / (double)m->error);
}

/* sharp: the median of estimate by true error; missed: the share whose tolerance is missed, in % */
static void report(judgement *j, double sharp, double missed)
{
    const int all = j->count + j->refused;
    qsort(j->sharp, (size_t)j->count, sizeof *j->sharp, rising);
    check_error(j->name, "true > 3 est", "%", 100. * j->beyond / j->count, 1, j->count, 0);
    check_error(j->name, "true/est, worst", "", j->worst, 10, 0, 0);
    check_error(j->name, "est/true, median", "", j->sharp[j->count / 2], sharp, 0, 0);
    check_error(j->name, "missed", "%", 100. * j->missed / all, missed, j->missed, 0);
    check_error(j->name, "not integrated", "%", 100. * j->refused / all, 1, j->refused, 0);
}

enum { TOLERANCES = 4 };
static double tolerance_of(int i)
{
    static const double in_double[TOLERANCES] = {1e-4, 1e-7, 1e-10, 1e-12}, in_float[TOLERANCES] = {1e-2, 3e-3, 1e-3, 3e-4};
    return by_precision(in_double[i], in_float[i]);
}

/* Forward to two times of each case, and backward from two times to its start. A force by the cosine of time is not
   moved, and goes forward only. */
static void judge_case(const slow_case *s, judgement *j)
{
    int k, i;
    for (k = 0; k < TOLERANCES; k++)
        for (i = 1; i < TIMES; i += 2) {
            const double tolerance = tolerance_of(k);
            vm_osc_problem o = problem_of(&s->c);
            vm_osc_motion m = {0, 0, 0, 0, 0, 0};
            routes_case back;
            int status = vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, R(slow_time(s, i)), R(tolerance), &m);
            judge(j, status, slow_error(s, &o, i, &m), &m, tolerance);
            if (s->c.force == COSINE) continue;
            o = slow_from(s, i, &back);
            status = vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, R(back.T), R(tolerance), &m);
            judge(j, status, case_error(&back, &o, m.x, m.v), &m, tolerance);
        }
}

static void test_motions(void)
{
    static judgement free_motion, tables, forced;
    int i;
    if (only_a_sample()) return;
    free_motion.name = "no force";
    tables.name = "table";
    forced.name = "force";
    for (i = 0; i < COUNT(slow_exact); i++) {
        const routes_case *c = &slow_exact[i].c;
        if (c->force) judge_case(slow_exact + i, &forced);
        else judge_case(slow_exact + i, c->mass.kind == LAW_TABLE ? &tables : &free_motion);
    }
    for (i = 0; i < COUNT(slow_wide); i += 4) judge_case(slow_wide + i, &free_motion);
    for (i = 0; i < COUNT(slow_tables); i += 2) judge_case(slow_tables + i, &tables);
    /* Float takes few points a step, for which the estimate credits the strict run with little. In double the median of
       the tables is 25 without and 26 with fused multiply-adds. */
    report(&free_motion, by_precision(25, 32), 1);
    report(&tables, by_precision(28, 32), by_precision(1, 6));
    /* With a force the rates jump at most at the ends of steps, where x or x' is 0. There the rules are better than their
       estimate says, which allows for kinks inside the steps: the median for alpha = 10 is 5000 in double. */
    report(&forced, by_precision(60, 25), by_precision(40, 5));
}

/* The least error, each alpha by itself. Where alpha is small or no integer, sa has a singularity of the power alpha + 1
   at the ends of the steps. Without a force the integrals of ca^2 and sa ca in closed form take it up; with a force the
   graded rule does. */
static void test_least_error(void)
{
    enum { ALPHAS = 6, EACH = 8, FREE = 3 }; /* motions of an alpha, the first three without a force */
    static const char *const names[ALPHAS] = {"alpha = 0", "alpha = 0.1", "alpha = 0.5", "alpha = 4/3", "alpha = 2.3",
                                              "alpha = 10"};
    static const double free_motion[ALPHAS] = {1e-13, 1e-13, 1e-13, 1e-13, 1e-13, 1e-13};
    static const double forced[ALPHAS] = {1e-13, 2e-8, 1e-13, 5e-13, 3e-12, 3e-11};
    int i;
    CHECK(COUNT(slow_exact) == ALPHAS * EACH);
    for (i = 0; i < COUNT(slow_exact); i++) {
        const slow_case *s = slow_exact + i;
        const int alpha = i / EACH;
        const vm_osc_problem o = problem_of(&s->c);
        vm_osc_motion m = {0, 0, 0, 0, 0, 0};
        CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, R(s->c.T), R(by_precision(1e-14, 3e-5)), &m) >= 0);
        if (i % EACH < FREE)
            check_error(names[alpha], "no force", "A", slow_error(s, &o, TIMES - 1, &m),
                        by_precision(free_motion[alpha], 5e-5), i, 0);
        else
            check_error(names[alpha], "forces", "A", slow_error(s, &o, TIMES - 1, &m), by_precision(forced[alpha], 5e-5), i,
                        s->c.force);
    }
}

/* Evaluations, both runs together, of alpha = 4/3, m = 1 + t/100, from rest to T = 300, which takes 24 vibrations */
static void test_evaluations(void)
{
    static const double tolerances[3] = {1e-6, 1e-8, 1e-10};
    static const long most[3] = {420, 440, 960};
    const vm_osc_problem o = problem(4. / 3, vm_law_linear(1, R(0.01)), 1, 0);
    int i;
    if (is_float) return;
    for (i = 0; i < 3; i++) {
        vm_osc_motion m = {0, 0, 0, 0, 0, 0};
        CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, 300, R(tolerances[i]), &m) == VM_OK);
        check_error("evaluations", "24 vibrations", "most", (double)m.evals / (double)most[i], 1, tolerances[i],
                    (double)m.evals);
    }
}

static int nearly_constant(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *rate = R(0.01);
    *f = 1 + *rate * t;
    return VM_OK;
}

/* A step that is shortened ends at a phase that is a number of the type, so that no roundings add up over many steps. */
static void test_short_steps(void)
{
    const vm_real phases[] = {0, 1, R(4.654), -1000}, t = R(0.05);
    vm_osc_problem o = problem(3, vm_law_user(nearly_constant, NULL), 1, 0);
    vm_osc_motion m, few;
    int i, k;
    for (i = 0; i < 4; i++)
        for (k = -1; k <= 1; k += 2) {
            const vm_real length = vmi_osc_short_length(phases[i], (vm_real)k * R(0.001) * VM_EPSILON);
            const vm_real end = phases[i] + length;
            CHECK(length * (vm_real)k > 0 && end - phases[i] == length);
        }
    CHECK(vmi_osc_short_length(0, 0) == 0);
    if (is_float && only_a_sample()) return;
    o.x = 1;
    o.v = 0;
    CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, t, R(1e-4), &few) == VM_OK);
    o.mass.change_time = t / R(by_precision(5000, 500000)); /* in double there is nothing to see, and it takes seconds */
    CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, t, R(1e-4), &m) == VM_OK && m.evals > 10 * few.evals);
    check_error("many short steps", "v", "estimate", fabs((double)((m.v - few.v) / m.error)), 1, 3, 0);
}

/* The stiffness falls nearly to 0, so that amplitude and phase do not describe the motion. The rounds of a step then led to
   rates with which time went back, so that in float the motion became infinite. */
static void test_time_grows(void)
{
    vm_osc_problem o = problem(7, vm_law_linear(10, 0), 0.0033550188, -0.0199996568);
    const vm_real t = R(1.60784316);
    vm_osc_motion m;
    vm_osc_plan plan;
    o.stiffness = vm_law_linear(R(0.1), R(-0.0552941188));
    o.x = R(-0.535294116);
    o.v = R(-0.535294116);
    CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
    CHECK(vm_osc_plan_within(&plan, t, R(0.0413), &m) == VM_OK);
    check_error("stiffness near 0", "|x - rk87|/A", "tol", fabs((double)m.x + 1.39348354) / (0.0413 * (double)m.amplitude), 1, 7, 0);
}

/* The stiffness falls nearly to 0. The rounds of a step put nodes before its start, at times at which the mass is not positive,
   so that in float vm_osc_within returned VM_BAD_MASS, although the mass is positive throughout. */
static void test_laws_within_steps(void)
{
    vm_osc_problem o = problem(4, vm_law_linear(R(0.100000001), R(0.0993658081)), 0.827450991, 0.0379215702);
    const vm_real t = R(4.13148022), tolerances[] = {R(1e-4), R(2e-3), R(2e-2), R(0.1)};
    vm_osc_motion m;
    int i;
    o.stiffness = vm_law_quadratic(R(0.150488332), R(-0.062337622), R(0.00654901983));
    o.x = R(-0.923529387);
    o.v = R(0.982352912);
    for (i = 0; i < 4; i++) {
        const double most = (double)tolerances[i];
        CHECK(vm_osc_within(&o, t, tolerances[i], &m) == VM_OK);
        check_error("stiffness near 0", "|x - rk87|/A", "tol", fabs((double)m.x - 0.7032599) / (most * (double)m.amplitude), 1, 7, 0);
    }
}

/* ---- Forces that jump, quick laws ---- */

/* Dry friction, which jumps where x' = 0 */
static vm_real dry_friction(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_real size = *(const vm_real *)ctx;
    (void)t;
    (void)x;
    if (v == 0) return 0;
    return v > 0 ? -size : size;
}

/* The position at t of x'' + 2 d x' + x = -f sign(x') from rest at x = 1, from one turning point to the next */
static double with_friction(double d, double f, double t)
{
    const double w = sqrt(1 - d * d), half = 3.14159265358979323846 / w;
    double turning = 1;
    while (t > half) {
        const double middle = copysign(f, turning);
        turning = middle - (turning - middle) * exp(-d * half);
        t -= half;
    }
    return copysign(f, turning) + (turning - copysign(f, turning)) * exp(-d * t) * (cos(w * t) + d / w * sin(w * t));
}

/* With damping, V = x' + p x is not 0 where dry friction jumps. The jumps then lay inside the steps, and the estimate of
   the error did not notice them: at t = 20 the true error was 4000 times the estimate. */
static void test_dry_friction(void)
{
    const double tolerance = by_precision(1e-8, 1e-4);
    vm_real size = R(0.01);
    vm_osc_problem o = problem(1, vm_law_linear(1, 0), 0, 0.02);
    int i;
    o.force = dry_friction;
    o.ctx = &size;
    for (i = 1; i <= 8; i++) {
        const vm_real t = R(5 * i);
        vm_osc_motion m;
        CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, t, R(tolerance), &m) == VM_OK);
        check_error("dry friction", "x", "tol A",
                    fabs((double)m.x - with_friction((double)o.damping / 2, (double)size, (double)t)) /
                        (tolerance * (double)m.amplitude), 1, i, 0);
    }
}

/* ln(A/A0) at t by a run with these errors of the iterations */
static double amplitude_of_run(const vm_osc_plan *plan, vm_real t, double sweep_limit)
{
    const vm_osc_problem *o = &plan->problem;
    static vmi_osc_course c;
    vmi_osc_slow start;
    vmi_osc_reduced state;
    CHECK(vmi_osc_slow_at(o, 0, 1, 1, 1, &start) == VM_OK);
    state = vmi_osc_reduce(&start, o->alpha, o->x, o->v);
    vmi_osc_course_start(&c, plan, &state, 1, 9, 1, R(sweep_limit));
    c.stop = t;
    while (c.t != t && vmi_osc_course_step(&c) == VM_OK) continue;
    CHECK(c.t == t);
    return (double)c.ln_A;
}

/* Where ln A changes several times as fast as the phase, the last step must end so close to t that the error of ln A, too,
   is within the limit. */
static void test_landing(void)
{
    static const double rates[] = {-9.316, 20.421, -7.28}, times[] = {0.0784, 0.0403, 0.1003};
    static vm_osc_plan plan;
    int i;
    for (i = 0; i < 3; i++) {
        vm_osc_problem o = problem(0, vm_law_linear(1, R(rates[i])), 0, 0);
        double error;
        o.x = 0;
        o.v = 1;
        CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
        error = fabs(amplitude_of_run(&plan, R(times[i]), 1e-3) - amplitude_of_run(&plan, R(times[i]), by_precision(1e-12, 1e-6)));
        check_error("landing", "ln A", "limit", error / 1e-3, 4, rates[i], times[i]);
    }
}

/* A body with almost no spring keeps its velocity while mass joins it and leaves again. */
static void test_mass_that_comes_and_goes(void)
{
    vm_real time[4] = {0, R(1e-5), R(2e-5), R(3e-5)}, mass[4] = {1, 2, R(1.5), R(1.5)};
    vm_osc_problem o = problem(3, vm_law_table(4, time, mass), 0, 0);
    vm_osc_motion m;
    o.x = 0;
    o.v = 1;
    CHECK(vm_osc_within(&o, time[2], R(1e-3), &m) == VM_OK);
    check_error("mass comes and goes", "v", "tol", fabs((double)m.v - 1) / 1e-3, 1, 3, 0);
}

/* Where mass changes much faster than the phase, the motion is no vibration: collocation refuses it, and a route that
   integrates the equation of motion is taken. */
static void test_quick_laws(void)
{
    vm_osc_problem o = problem(9.75, vm_law_quadratic(R(0.324112), R(0.00640656), R(-49.0743)), 1, 0.181248);
    vm_osc_motion m, direct;
    double vmax;
    o.stiffness = vm_law_linear(R(1.60158), 0);
    o.x = R(-0.0762726);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, R(-0.02457), R(9.9e-5), &m) == VM_NOT_INTEGRATED);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_RK87, R(-0.02457), R(by_precision(1e-10, 1e-5)), &direct) >= 0);
    CHECK(vm_osc_within(&o, R(-0.02457), R(9.9e-5), &m) >= 0);
    vmax = (double)vm_osc_vmax(direct.amplitude, VM_SQRT(R(1.60158) / R(0.294331)), R(9.75));
    check_error("quick laws", "v", "est", fabs((double)(m.v - direct.v)) / (3 * vmax * (double)m.error), 1, 9.75, 0);
    o = problem(1, vm_law_quadratic(1, 0, -400), 1, 0); /* here the amplitude was 0.76, not 0.1 */
    o.x = R(0.1);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, R(0.03), R(1e-4), &m) == VM_NOT_INTEGRATED);
    CHECK(vm_osc_within(&o, R(0.03), R(1e-4), &m) == VM_OK);
    check_error("quick laws", "A", "1e-3", fabs((double)m.amplitude / 0.100015 - 1) / 1e-3, 1, 1, 0);
}

/* vmi_osc_remember reads no memory before it writes it: signaling NaNs there would raise the flag of invalid operations. */
static void test_history(void)
{
#ifdef FE_INVALID
    static vmi_osc_course c;
    static vmi_step_rates rates;
    vmi_bits signaling = vmi_to_bits(VM_INFINITY) + 1;
    vm_real *number = &c.difference[0][0].ln_A[0];
    size_t i;
    int k;
    for (i = 0; i < sizeof c.difference / sizeof *number; i++) memcpy(number + i, &signaling, sizeof signaling);
    c.rule.n = 4;
    c.known[0] = 0;
    feclearexcept(FE_ALL_EXCEPT);
    for (k = 0; k < VMI_HISTORY + 2; k++) {
        vmi_osc_remember(&c, 0, &rates);
        CHECK(c.known[0] == (k < VMI_HISTORY ? k + 1 : VMI_HISTORY));
    }
    CHECK(!fetestexcept(FE_INVALID));
#endif
}

int main(void)
{
    test_rules();
    test_grading();
    test_misses();
    test_motions();
    test_least_error();
    test_short_steps();
    test_time_grows();
    test_laws_within_steps();
    test_dry_friction();
    test_landing();
    test_mass_that_comes_and_goes();
    test_quick_laws();
    test_history();
    test_evaluations();
    return check_finish("collocation");
}
