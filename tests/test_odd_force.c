/* Vibration under an odd elastic force: with constant mass a user's force against Duffing's closed form, the pendulum
   and the power law; with slow mass, stiffness and damping the order of the averaged laws, closed solutions,
   estimates of errors against integration, tables, the way to a separatrix and across it, and what is refused. */
#include <stdlib.h>
#include "../varmass.h"
#include "check.h"
#include "nearly_exhausted.h"
#include "slow_vibrations.h"

/* ---- Forces ---- */

static int cubic(vm_real x, vm_real *f, void *ctx)
{
    const vm_real *k = (const vm_real *)ctx;
    *f = x * (k[0] + k[1] * (x * x));
    return 0;
}
static int sine(vm_real x, vm_real *f, void *ctx)
{
    (void)ctx;
    *f = R(sin((double)x));
    return 0;
}
static int saturating(vm_real x, vm_real *f, void *ctx)
{
    (void)ctx;
    *f = R(tanh((double)x));
    return 0;
}
static int with_kink(vm_real x, vm_real *f, void *ctx) /* x + x|x|; the kit asks for x >= 0 only */
{
    (void)ctx;
    *f = x + x * x;
    return 0;
}
static int rough_force(vm_real x, vm_real *f, void *ctx) /* jumps at x = 0.3 */
{
    (void)ctx;
    *f = x + (x > R(0.3) ? 1 : 0);
    return 0;
}
static int failing(vm_real x, vm_real *f, void *ctx)
{
    (void)ctx;
    *f = x;
    return x > 1 ? 5 : 0;
}

/* ---- Constant mass ---- */

/* A user's function for Duffing's force gives what the closed form gives. */
static void test_against_duffing(void)
{
    int i;
    for (i = 0; i < 120; i++) {
        vm_real k[2];
        vm_odd_force user, closed;
        vmi_orbit orbit;
        vm_real x = 0, v = 0, want_x = 0, want_v = 0;
        const double x0 = uniform(-1.5, 1.5), v0 = uniform(-1, 1), t = uniform(-30, 30);
        k[0] = R(i % 3 == 0 ? 0.0625 : uniform(0.5, 2));
        k[1] = R(i % 3 == 2 ? uniform(-0.1, 0) : uniform(0, 2));
        user = vm_odd_force_user(cubic, k);
        closed = vm_duffing_force(k[0], k[1]);
        if (vmi_orbit_of_state(&closed, R(x0), R(v0), &orbit)) continue;
        CHECK(vm_odd_exact_from(&user, R(t), R(x0), R(v0), &x, &v) == VM_OK);
        CHECK(vm_odd_exact_from(&closed, R(t), R(x0), R(v0), &want_x, &want_v) == VM_OK);
        check_error("user force", "x", "rel", fabs((double)(x - want_x)) / ((double)orbit.swing * (1 + fabs(t))),
                    by_precision(1e-13, 2e-5), (double)k[0], (double)k[1]);
        check_error("user force", "v", "rel", fabs((double)(v - want_v)) / ((double)orbit.vmax * (1 + fabs(t))),
                    by_precision(1e-13, 2e-5), (double)k[0], (double)k[1]);
        near("user force", "period", (double)vm_odd_period(&user, R(x0)), (double)vm_odd_period(&closed, R(x0)), 1e-13,
             1e-5);
        near("user force", "action", (double)vm_odd_action(&user, R(x0)), (double)vm_odd_action(&closed, R(x0)), 1e-13,
             1e-5);
    }
}

/* The pendulum has the period 4 K(sin^2(A/2)), and sin(x/2) = sin(A/2) cd(t). */
static void test_pendulum(void)
{
    const vm_odd_force force = vm_odd_force_user(sine, NULL);
    double A;
    for (A = 0.125; A < 3; A += 0.125) {
        const double k = sin(A / 2), t = 7.5;
        const vm_real cd = jacobi_cd(R(t), R(k * k));
        vm_real x, v;
        near("pendulum", "period", (double)vm_odd_period(&force, R(A)), 4 * (double)jacobi_K(R(k * k)), 1e-13, 1e-5);
        if (vm_odd_exact_from(&force, R(t), R(A), 0, &x, &v)) FAIL("pendulum refused");
        else near("pendulum", "x", A + (double)x, A + 2 * asin(k * (double)cd), 1e-12, 1e-4);
    }
    /* Near the separatrix: at these amplitudes the integral over the orbit only just has the accuracy that is required. */
    A = by_precision(3.116, 3.139);
    near("pendulum", "last period", (double)vm_odd_period(&force, R(A)), by_precision(22.98045207063136, 32.137978446531747), 1e-13,
         3e-5);
    /* Closer to the separatrix it is refused, beyond it there is no vibration. */
    CHECK(is_nan(vm_odd_period(&force, R(3.1415926))) && is_nan(vm_odd_period(&force, R(3.5))));
}

/* Forces with a kink at x = 0 and forces that saturate: energy and the way back */
static void test_other_forces(void)
{
    const vm_odd_force kink = vm_odd_force_user(with_kink, NULL), tanh_force = vm_odd_force_user(saturating, NULL);
    int i;
    for (i = 0; i < 40; i++) {
        const double x0 = uniform(-3, 3), v0 = uniform(-2, 2), t = uniform(0, 30);
        vm_real x = 0, v = 0, back_x = 0, back_v = 0;
        double before, after;
        CHECK(vm_odd_exact_from(&kink, R(t), R(x0), R(v0), &x, &v) == VM_OK);
        before = v0 * v0 / 2 + x0 * x0 / 2 + fabs(x0 * x0 * x0) / 3;
        after = (double)(v * v / 2 + x * x / 2 + VM_FABS(x * x * x) / 3);
        near("x + x|x|", "energy", after, before, 1e-12, 2e-4);
        CHECK(vm_odd_exact_from(&tanh_force, R(t), R(x0), R(v0), &x, &v) == VM_OK);
        before = v0 * v0 / 2 + log(cosh(x0));
        after = (double)(v * v) / 2 + log(cosh((double)x));
        near("tanh", "energy", after, before, 1e-12, 2e-4);
        CHECK(vm_odd_exact_from(&tanh_force, R(-t), x, v, &back_x, &back_v) == VM_OK);
        near("tanh", "way back", 4 + (double)back_x, 4 + x0, 1e-12, 2e-4);
    }
}

static int walled(vm_real x, vm_real *f, void *ctx) /* x/(1 - x^2), which exists for x < 1 */
{
    (void)ctx;
    if (x >= 1) return 1;
    *f = x / (1 - x * x);
    return 0;
}

/* States whose amplitude lies just below the place where the force changes its sign, or where its function fails: they
   have a motion, and it keeps its energy. */
static void test_amplitude_below_the_end(void)
{
    static const double swings[][2] = {{0, 1.9}, {2, 0.8}, {2.5, 0.1}, {-2, -0.8}, {2.9, 0.05}};
    static const double bounded[][2] = {{0.6, 0.1}, {-0.3, -0.4}, {0.7, -0.05}};
    const vm_odd_force pendulum = vm_odd_force_user(sine, NULL), wall = vm_odd_force_user(walled, NULL);
    vm_real x = 0, v = 0;
    int i;
    for (i = 0; i < (int)(sizeof swings / sizeof *swings); i++) {
        const double x0 = swings[i][0], v0 = swings[i][1];
        CHECK(vm_odd_exact_from(&pendulum, R(7.5), R(x0), R(v0), &x, &v) == VM_OK);
        near("below the end", "pendulum", (double)(v * v) / 2 + 1 - cos((double)x), v0 * v0 / 2 + 1 - cos(x0), 1e-13,
             2e-5);
    }
    for (i = 0; i < (int)(sizeof bounded / sizeof *bounded); i++) {
        const double x0 = bounded[i][0], v0 = bounded[i][1];
        CHECK(vm_odd_exact_from(&wall, R(7.5), R(x0), R(v0), &x, &v) == VM_OK);
        near("below the end", "wall", ((double)(v * v) - log(1 - (double)(x * x))) / 2,
             (v0 * v0 - log(1 - x0 * x0)) / 2, 1e-12, 1e-4);
    }
}

/* ---- The ripple ---- */

/* The ripple of Duffing's force in closed form against its quadrature, on orbits of every kind */
static void test_ripple(void)
{
    static const double k[9][4] = {{1, 0.5, 1.5, 0.4},  {1, -0.2, 1.2, 0.3},  {0, 1, 1, 0.5},
                                   {1, 0, 1, 1},        {-1, 1, 1.8, 0.2},    {-1, 1, 1.2, 0.1},
                                   {-1, 1, -1.2, -0.2}, {1, -1e-6, 1, 0},     {1, 100, 1, 0}};
    static vmi_orbit_ripple closed, summed;
    int i, n;
    for (i = 0; i < 9; i++) {
        const vm_odd_force force = vm_duffing_force(R(k[i][0]), R(k[i][1]));
        vm_odd_force by_quadrature = force;
        vmi_orbit orbit;
        double largest = 0, largest_B = 0, largest_B_j = 0;
        by_quadrature.ripple = NULL;
        CHECK(vmi_orbit_of_state(&force, R(k[i][2]), R(k[i][3]), &orbit) == VM_OK);
        vmi_orbit_ripple_init(&closed, &orbit);
        orbit.force = &by_quadrature;
        vmi_orbit_ripple_init(&summed, &orbit);
        for (n = -30; n < 30; n++) {
            vmi_orbit_ripple_values a, b;
            vmi_orbit_ripple_at(&closed, &orbit, R(0.23 * n), &a);
            vmi_orbit_ripple_at(&summed, &orbit, R(0.23 * n), &b);
            largest = fmax(largest, fabs((double)(a.a - b.a)));
            largest_B = fmax(largest_B, fabs((double)(a.B - b.B)));
            largest_B_j = fmax(largest_B_j, fabs((double)(a.B_j - b.B_j)));
        }
        check_error("ripple", "a/j", "abs", largest / (double)orbit.j, by_precision(1e-10, 1e-5), k[i][0], k[i][1]);
        check_error("ripple", "B/j", "abs", largest_B / (double)orbit.j, by_precision(1e-10, 1e-5), k[i][0], k[i][1]);
        check_error("ripple", "(B/w)_j w", "abs", largest_B_j * (double)orbit.w, by_precision(1e-10, 1e-4), k[i][0],
                    k[i][1]);
        near("ripple", "M", (double)closed.M, (double)summed.M, 1e-12, 1e-4);
        near("ripple", "M by size", (double)closed.M_size, (double)summed.M_size, 1e-12, 1e-3);
        check_error("ripple", "w by size", "abs",
                    fabs((double)((closed.w_size - summed.w_size) * orbit.size / orbit.w)), by_precision(1e-12, 1e-4),
                    k[i][0], k[i][1]);
    }
}

/* ---- Slow mass, stiffness and damping ---- */

static vm_odd_problem problem_of(vm_odd_force force, double x, double v)
{
    vm_odd_problem o;
    o.force = force;
    o.mass = vm_law_linear(1, 0);
    o.stiffness = vm_law_linear(1, 0);
    o.damping = vm_law_linear(0, 0);
    o.reactive = 1;
    o.x = R(x);
    o.v = R(v);
    return o;
}

static vm_odd_plan plan;

#ifndef VM_USE_FLOAT
static vm_real cubic_coefficients[2] = {1, 0.5};

/* Force number 0 to 6 with a state on it: hard, soft, cubic, linear, outer and inner motion in two wells, by a user */
static vm_odd_problem numbered(int number)
{
    static const double k[6][4] = {{1, 0.5, 1.5, 0.4}, {1, -0.2, 1.2, 0.3}, {0, 1, 1, 0.5},
                                   {1, 0, 1, 1},       {-1, 1, 1.8, 0.2},   {-1, 1, 1.2, 0.1}};
    if (number == 6) return problem_of(vm_odd_force_user(cubic, cubic_coefficients), 1.5, 0.4);
    return problem_of(vm_duffing_force(k[number][0], k[number][1]), k[number][2], k[number][3]);
}

/* The largest errors of x of both averaged laws between `from` and T */
static void waveform_errors(vm_odd_problem *o, double from, double T, double *error)
{
    static vm_real work[RK87_WORK(2)];
    rk45_options options;
    vm_real y[2];
    rk87 s;
    int i, route;
    memset(&options, 0, sizeof options);
    options.rtol = options.atol = 1e-13;
    y[0] = o->x;
    y[1] = o->v;
    CHECK(vm_odd_plan_init(&plan, o, T) == VM_OK && plan.reach == T);
    CHECK(rk87_init(&s, vm_odd_rhs, o, 2, 0, y, &options, work) >= 0);
    error[0] = error[1] = 0;
    for (i = 0; i <= 120; i++) {
        const double t = from + (T - from) * i / 120;
        CHECK(rk87_solve(&s, t) >= 0);
        for (route = VM_ODD_MEAN; route <= VM_ODD_ORDER2; route++) {
            vm_odd_motion m = {0, 0, 0, 0, 0, 0};
            CHECK(vm_odd_plan_by_route(&plan, route, t, 0, &m) == VM_OK);
            error[route] = fmax(error[route], fabs(m.x - s.y[0]));
        }
    }
}

/* The errors of the mean motion fall as eps, those with its ripple as eps^2, over a time of 3/eps. */
static void test_orders(void)
{
    double sums[2] = {0, 0};
    int number, k, route, n = 0;
    for (number = 0; number < 7; number++) {
        double error[3][2];
        for (k = 0; k < 3; k++) {
            const double eps_now = 0.04 / (1 << (2 * k)), sign = number == 4 ? -1 : 1;
            vm_odd_problem o = numbered(number);
            o.mass = vm_law_linear(1, -0.2 * eps_now * sign);
            o.stiffness = vm_law_exponential(1, 0.1 * eps_now);
            o.damping = vm_law_linear(0.5 * eps_now * sign, 0.2 * eps_now * eps_now * sign);
            o.reactive = 0.3;
            waveform_errors(&o, 2.7 / eps_now, 3 / eps_now, error[k]);
        }
        for (route = 0; route < 2; route++) {
            const double slope = log(error[0][route] / error[2][route]) / log(16);
            check_error("slope in eps", route ? "order 2" : "mean", "abs", fabs(slope - 1 - route), 0.25, number,
                        slope);
            sums[route] += slope;
        }
        n++;
    }
    for (route = 0; route < 2; route++)
        check_error("mean slope", route ? "order 2" : "mean", "abs", fabs(sums[route] / n - 1 - route), 0.06, route,
                    sums[route] / n);
}

/* ---- Estimates ---- */

static double log_uniform(double low, double high) { return exp(uniform(log(low), log(high))); }

/* A law with relative rates up to eps that stays positive up to T */
static vm_law random_law(double f0, double rate_most, double T)
{
    double r = uniform(-1, 1) * rate_most;
    switch ((int)uniform(0, 5)) {
    case 0: return vm_law_linear(f0, f0 * fmax(r, -0.8 / T));
    case 1: return vm_law_exponential(f0, r);
    case 2: return vm_law_power(f0, fmax(r, -0.8 / T), uniform(-1, 2));
    case 3: return vm_law_quadratic(f0, f0 * fabs(r), f0 * rate_most * rate_most * uniform(0, 0.3));
    default: return vm_law_linear(f0, 0);
    }
}

static vm_odd_problem random_problem(int number, double rate, double T)
{
    const double m = log_uniform(0.5, 2), k = log_uniform(0.5, 2), c = log_uniform(0.1, 1);
    vm_odd_problem o;
    vm_real x = 0, v = 0;
    vmi_orbit orbit;
    double A = uniform(0.3, 2);
    vm_odd_force force;
    switch (number % 8) {
    case 0: force = vm_duffing_force(1, log_uniform(0.01, 10)); break;
    case 1: force = vm_duffing_force(0, 1); break;
    case 2:
        force = vm_duffing_force(1, -c);
        A = uniform(0.1, 0.9) / sqrt(c);
        break;
    case 3:
        force = vm_duffing_force(-1, 1);
        A = uniform(1.5, 3);
        break;
    case 4:
        force = vm_duffing_force(-1, 1);
        A = uniform(1.02, 1.38);
        break;
    case 5: force = vm_odd_force_user(sine, NULL); break;
    case 6: force = vm_odd_force_user(saturating, NULL); break;
    default: force = vm_odd_force_user(with_kink, NULL); break;
    }
    CHECK(vmi_orbit_of_state(&force, A, 0, &orbit) == VM_OK);
    CHECK(force.at_phase(&orbit, uniform(-3, 3), &x, &v) == VM_OK);
    o = problem_of(force, x, v * sqrt(k / m));
    o.mass = random_law(m, rate, T);
    o.stiffness = random_law(k, rate, T);
    if (number % 3) o.damping = random_law(m * rate * uniform(-0.3, 0.5), rate, T);
    o.reactive = number % 2 ? 1 : uniform(0, 1);
    return o;
}

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The error of a motion, as its field error defines it */
static double error_of(const vm_odd_problem *o, double t, const vm_odd_motion *m, const vm_odd_motion *truth)
{
    vmi_odd_rates now;
    vmi_orbit orbit;
    CHECK(vmi_odd_rates_at(o, t, -1, &now) == VM_OK);
    if (vmi_orbit_of_state(&o->force, truth->x, truth->v / now.speed, &orbit)) return 0;
    return fmax(fabs(m->x - truth->x) / orbit.swing, fabs(m->v - truth->v) / (orbit.vmax * now.speed));
}

/* Random problems: the true error is above 3 estimates in at most 1 % of them, and never above 10; and the estimates
   are sharp. The truth is an integration to 1e-12; where it is not much better than the estimate, nothing can be
   said. */
static void test_estimates(void)
{
    enum { PROBLEMS = 480 };
    static double ratio[3][PROBLEMS];
    static const char *names[3] = {"mean", "order 2", "rk87"};
    int n[3] = {0, 0, 0}, i, route;
    for (i = 0; i < PROBLEMS; i++) {
        const double rate = log_uniform(0.004, 0.1), T = uniform(0.5, 2) / rate;
        vm_odd_problem o = random_problem(i, rate, T);
        vm_odd_motion truth, m;
        CHECK(vm_odd_plan_init(&plan, &o, T) == VM_OK);
        if (vm_odd_plan_by_route(&plan, VM_ODD_RK87, T, 1e-12, &truth) < 0) continue; /* runs away */
        for (route = 0; route < 3; route++) {
            const int status = vm_odd_plan_by_route(&plan, route, T, 1e-7, &m);
            CHECK(status == VM_OK || status == VM_NO_LAW || (i % 8 == 7 && status == VM_TOLERANCE_MISSED));
            if (status == VM_NO_LAW || !(m.error < 1) || truth.error > m.error / 3) continue;
            ratio[route][n[route]] = error_of(&o, T, &m, &truth) / m.error;
            n[route]++;
        }
    }
    for (route = 0; route < 3; route++) {
        qsort(ratio[route], (size_t)n[route], sizeof(double), rising);
        CHECK(n[route] > 3 * PROBLEMS / 4);
        check_error("error/estimate", names[route], "1", ratio[route][n[route] - 1], 10, n[route], 0);
        check_error("99 % of them", names[route], "1", ratio[route][n[route] * 99 / 100], 3, n[route], 0);
        check_error("1/median", names[route], "1", 1 / ratio[route][n[route] / 2], route == VM_ODD_RK87 ? 40 : 10,
                    n[route], 0);
    }
}

/* vm_odd_within and vm_odd_plan_within keep their tolerance, whichever route they take. */
static void test_within(void)
{
    static const double tolerances[3] = {3e-2, 1e-3, 1e-8};
    int i, k, taken[3] = {0, 0, 0};
    for (i = 0; i < 48; i++) {
        const double rate = log_uniform(0.004, 0.03), T = 1 / rate;
        vm_odd_problem o = random_problem(i, rate, T);
        vm_odd_motion truth, m, once;
        CHECK(vm_odd_plan_init(&plan, &o, T) == VM_OK);
        if (vm_odd_plan_by_route(&plan, VM_ODD_RK87, T, 1e-11, &truth) < 0) continue;
        for (k = 0; k < 3; k++) {
            const int status = vm_odd_plan_within(&plan, T, tolerances[k], &m);
            if (i % 8 == 7 && status == VM_TOLERANCE_MISSED) continue; /* a kink */
            CHECK(status == VM_OK && m.error <= tolerances[k]);
            check_error("within", "error/tolerance", "1", error_of(&o, T, &m, &truth) / tolerances[k], 3, i, k);
            taken[m.route]++;
        }
        if (i % 8) continue;
        CHECK(vm_odd_within(&o, T, 1e-3, &once) == VM_OK && vm_odd_plan_within(&plan, T, 1e-3, &m) == VM_OK);
        CHECK(once.x == m.x && once.v == m.v && once.error == m.error && once.route == m.route);
    }
    for (i = 0; i < 3; i++) CHECK(taken[i] > 4);
}

/* ---- Tables, users' laws, backward ---- */

static int breathing(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const vm_real w = *(const vm_real *)ctx;
    *f = 1 + sin(w * t) / 4;
    *rate = w * cos(w * t) / 4;
    return 0;
}

/* A table's second derivative jumps at its points, a user's law has no formula: both keep second order. */
static void test_tables_and_users(void)
{
    double error[3][2];
    int k, kind;
    for (kind = 0; kind < 2; kind++) {
        for (k = 0; k < 3; k++) {
            const double rate = 0.04 / (1 << (2 * k));
            vm_real time[4], value[4] = {1, 1.2, 1.7, 1.8}, w = rate;
            vm_odd_problem o = numbered(0);
            int i;
            for (i = 0; i < 4; i++) time[i] = i / rate;
            if (kind == 0) o.mass = vm_law_table(4, time, value);
            else o.mass = vm_law_user(breathing, &w);
            waveform_errors(&o, 0.3 / rate, 3 / rate, error[k]);
        }
        check_error(kind ? "user's law" : "table", "slope, mean", "abs",
                    fabs(log(error[0][0] / error[2][0]) / log(16) - 1), 0.25, error[0][0], error[2][0]);
        check_error(kind ? "user's law" : "table", "slope, order 2", "abs",
                    fabs(log(error[0][1] / error[2][1]) / log(16) - 2), 0.35, error[0][1], error[2][1]);
    }
}

/* A plan backward in time leads to the state from which the motion came. */
static void test_backward(void)
{
    int number;
    for (number = 0; number < 7; number++) {
        vm_odd_problem o = numbered(number);
        vm_odd_motion m, same;
        o.mass = vm_law_linear(1, 0.002);
        o.damping = vm_law_linear(0.003, 0);
        if (number == 4) o.damping = vm_law_linear(-0.003, 0);
        CHECK(vm_odd_plan_init(&plan, &o, -60) == VM_OK && plan.reach == -60);
        CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, -60, 1e-11, &same) >= 0);
        CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, -60, 0, &m) == VM_OK);
        CHECK(error_of(&o, -60, &m, &same) < 3 * m.error && m.error < 1e-3);
    }
}

/* ---- Separatrices ---- */

/* With damping an outer motion falls into a well. The plan's reach ends before, and within integrates across. */
static void test_crossing(void)
{
    vm_real softening[2] = {1, -1};
    vm_odd_problem o = numbered(4);
    vm_odd_motion m, again;
    o.damping = vm_law_linear(0.02, 0);
    CHECK(vm_odd_plan_init(&plan, &o, 200) == VM_OK);
    CHECK(plan.reach > 5 && plan.reach < 200);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, 199, 0, &m) == VM_NO_LAW);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_MEAN, plan.reach / 2, 0, &m) == VM_OK);
    CHECK(vm_odd_plan_within(&plan, 200, 1e-6, &m) == VM_OK && m.route == VM_ODD_RK87);
    CHECK(fabs(m.x) < sqrt(2) && m.amplitude < sqrt(2) && m.amplitude > 1);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, 200, 1e-8, &again) == VM_OK);
    CHECK(fabs(m.x - again.x) < 3e-6);
    /* A softening spring that is driven by negative damping runs away. */
    o = problem_of(vm_duffing_force(1, -1), 0.5, 0);
    o.damping = vm_law_linear(-0.05, 0);
    CHECK(vm_odd_plan_init(&plan, &o, 100) == VM_OK && plan.reach < 40 && plan.reach > 5);
    CHECK(vm_odd_plan_within(&plan, 100, 1e-6, &m) == VM_NOT_INTEGRATED);
    /* Closer to the separatrix than rounding errors of the orbit's size there is no averaged motion. */
    o = problem_of(vm_duffing_force(-1, 1), 0, ldexp(1, -30));
    CHECK(vm_odd_plan_init(&plan, &o, 8) == VM_OK && plan.reach == 0);
    CHECK(vm_odd_plan_within(&plan, 8, 0, &m) == VM_OK && m.route == VM_ODD_RK87);
    CHECK(fabs(m.x / (o.v * sinh(8.)) - 1) < 0.02 && fabs(m.amplitude / sqrt(2) - 1) < 1e-6);
    /* A start on the separatrix and one outside the well have no averaged motion at all. */
    o = problem_of(vm_duffing_force(-1, 1), 0, 0.001);
    o.v = 0;
    CHECK(vm_odd_plan_init(&plan, &o, 1) == VM_OK && vm_odd_plan_within(&plan, 1, 0, &m) == VM_OK && m.x == 0);
    o = problem_of(vm_duffing_force(1, -1), 2, 0);
    CHECK(vm_odd_plan_init(&plan, &o, 0.5) == VM_OK && plan.reach == 0);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_MEAN, 0.5, 0, &m) == VM_NO_LAW);
    CHECK(vm_odd_plan_within(&plan, 0.5, 1e-8, &m) == VM_OK && is_nan(m.amplitude) && m.x > 2);
    o.force = vm_odd_force_user(cubic, softening);
    CHECK(vm_odd_plan_init(&plan, &o, 0.5) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, 0.5, 0, &m) == VM_OK && is_nan(m.amplitude) && m.x > 2);
}

/* Where the laws are constant the averaged motion is the exact one. */
static void test_constant_laws(void)
{
    int number;
    for (number = 0; number < 7; number++) {
        const vm_odd_problem o = numbered(number);
        vm_odd_motion m = {0, 0, 0, 0, 0, 0};
        vm_real x = 0, v = 0;
        CHECK(vm_odd_exact_from(&o.force, 300, o.x, o.v, &x, &v) == VM_OK);
        CHECK(vm_odd_within(&o, 300, 1e-9, &m) == VM_OK && m.route == VM_ODD_MEAN);
        check_error("constant laws", "x", "abs", fabs(m.x - x), 2e-12, number, 0);
        check_error("constant laws", "v", "abs", fabs(m.v - v), 2e-12, number, 0);
    }
}

/* For k3 = 0 and a mass exp(s t) with the full reactive force the motion is elementary: x = exp(-s t/2) cos(w t) ...
   with m x'' + m' x' + k x = 0 and k = m, so that x'' + s x' + x = 0. */
static void test_linear_solution(void)
{
    const double s = 0.01, w = sqrt(1 - s * s / 4), t = 200;
    const double x = exp(-s * t / 2) * (cos(w * t) + s / (2 * w) * sin(w * t));
    vm_odd_problem o = problem_of(vm_duffing_force(1, 0), 1, 0);
    vm_odd_motion m;
    o.mass = vm_law_exponential(1, s);
    o.stiffness = vm_law_exponential(1, s);
    CHECK(vm_odd_plan_init(&plan, &o, t) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, t, 0, &m) == VM_OK);
    check_error("x'' + s x' + x", "order 2", "rel", fabs(m.x - x) / (m.error * m.amplitude), 1, m.x, x);
    CHECK(vm_odd_plan_within(&plan, t, 1e-10, &m) == VM_OK);
    check_error("x'' + s x' + x", "within 1e-10", "rel", fabs(m.x - x) / m.amplitude, 1e-10, m.x, x);
}
#endif

/* In float: the averaged law and the integration agree within their estimates. */
static void test_any_precision(void)
{
    vm_odd_problem o = problem_of(vm_duffing_force(1, R(0.5)), 1.5, 0.25);
    vm_odd_motion a, b;
    o.mass = vm_law_linear(1, R(0.004));
    o.damping = vm_law_linear(R(0.002), 0);
    CHECK(vm_odd_plan_init(&plan, &o, 60) == VM_OK && plan.reach == 60);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, 60, 0, &a) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, 60, R(1e-4), &b) >= 0);
    CHECK(fabs((double)(a.x - b.x)) < 3 * 1.5 * (double)(a.error + b.error) && (double)a.error < 5e-3);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_MEAN, 0, 0, &a) == VM_OK && a.x == o.x && a.v == o.v && a.error == 0);
}

/* A constant mass by a user's function */
static int constant_mass(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)t;
    (void)ctx;
    *f = 1;
    *rate = 0;
    return 0;
}

/* A spring so stiff that powers of its rate overflow gives the motion of the unit spring in another unit of time. */
static void test_stiff_spring(void)
{
    const vm_real rate = R(ldexp(1, is_float ? 40 : 240)); /* 1/s */
    vm_odd_problem o = problem_of(vm_duffing_force(1, 0), 1, 0);
    int route, user;
    for (user = 0; user < 2; user++)
        for (route = VM_ODD_MEAN; route <= VM_ODD_ORDER2; route++) {
            vm_odd_motion m = {0, 0, 0, 0, 0, 0}, n = m;
            o.mass = user ? vm_law_user(constant_mass, NULL) : vm_law_exponential(1, R(0.02));
            o.stiffness = vm_law_linear(1, 0);
            o.damping = vm_law_linear(R(0.01), R(0.001));
            CHECK(vm_odd_plan_init(&plan, &o, 3) == VM_OK);
            CHECK(vm_odd_plan_by_route(&plan, route, 3, 0, &m) == VM_OK);
            if (!user) o.mass = vm_law_exponential(1, R(0.02) * rate);
            o.stiffness = vm_law_linear(rate * rate, 0);
            o.damping = vm_law_linear(R(0.01) * rate, R(0.001) * rate * rate);
            CHECK(vm_odd_plan_init(&plan, &o, 3 / rate) == VM_OK);
            CHECK(vm_odd_plan_by_route(&plan, route, 3 / rate, 0, &n) == VM_OK);
            check_error("stiff spring", "x", "eps", fabs((double)(m.x - n.x)) / eps, 16, user, route);
            check_error("stiff spring", "v", "eps", fabs((double)(m.v - n.v / rate)) / eps, 16, user, route);
            check_error("stiff spring", "estimate", "rel", fabs((double)(n.error / m.error) - 1), 1e-3, user, route);
        }
}

/* ---- Refusals ---- */

static void test_forces_refused(void)
{
    const vm_odd_force none = vm_odd_force_user(NULL, NULL), jumps = vm_odd_force_user(rough_force, NULL);
    const vm_odd_force fails = vm_odd_force_user(failing, NULL), sine_force = vm_odd_force_user(sine, NULL);
    vm_real x = 7, v = 7;
    CHECK(vm_odd_exact_from(&none, 1, 1, 0, &x, &v) == VM_BAD_ARGUMENT && is_nan(vm_odd_period(&none, 1)));
    CHECK(vm_odd_exact_from(&jumps, 1, 1, 0, &x, &v) == VM_NO_LAW && is_nan(vm_odd_action(&jumps, 1)));
    CHECK(vm_odd_exact_from(&fails, 1, 2, 0, &x, &v) == VM_DOMAIN && is_nan(vm_odd_period(&fails, 2)));
    CHECK(vm_odd_exact_from(&sine_force, 1, 0, R(2.5), &x, &v) == VM_NO_LAW); /* it goes round */
    CHECK(vm_odd_exact_from(&sine_force, VM_INFINITY, 0, 1, &x, &v) == VM_NOT_FINITE);
    CHECK(vm_odd_exact_from(&sine_force, 1, VM_NAN, 1, &x, &v) == VM_NOT_FINITE);
    CHECK(is_nan(vm_odd_period(&sine_force, 0)) && vm_odd_action(&sine_force, 0) == 0);
    CHECK(x == 7 && v == 7);
    CHECK(vm_odd_exact_from(&sine_force, 1, 0, 0, &x, &v) == VM_OK && x == 0 && v == 0);
}

/* A Duffing force with a coefficient that is infinite or NaN, also for a body at rest */
static void test_duffing_not_finite(void)
{
    const vm_odd_force bad[4] = {vm_duffing_force(VM_NAN, 1), vm_duffing_force(VM_INFINITY, 1),
                                 vm_duffing_force(1, VM_NAN), vm_duffing_force(1, -VM_INFINITY)};
    vm_real x = 7, v = 7;
    int i;
    for (i = 0; i < 4; i++) {
        CHECK(vm_odd_exact_from(&bad[i], 1, 1, 0, &x, &v) == VM_NOT_FINITE);
        CHECK(vm_odd_exact_from(&bad[i], 1, 0, R(0.5), &x, &v) == VM_NOT_FINITE);
        CHECK(vm_odd_exact_from(&bad[i], 1, 0, 0, &x, &v) == VM_NOT_FINITE);
    }
    CHECK(x == 7 && v == 7);
}

static void test_problems_refused(void)
{
    const vm_odd_problem good = problem_of(vm_duffing_force(1, 1), 1, 0);
    vm_odd_problem o = good;
    vm_odd_motion m;
    vm_real y[2] = {1, 1}, d[2] = {7, 7};
    memset(&m, 0, sizeof m);
    o.mass = vm_law_linear(1, R(-0.5));
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_BAD_MASS && vm_odd_within(&o, 4, 0, &m) == VM_BAD_MASS);
    o = good;
    o.stiffness = vm_law_linear(-1, 0);
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_BAD_STIFFNESS);
    CHECK(vm_odd_rhs(0, y, d, &o) == VM_BAD_STIFFNESS);
    o = good;
    o.damping = vm_law_user(NULL, NULL);
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_BAD_ARGUMENT && vm_odd_rhs(0, y, d, &o) == VM_BAD_ARGUMENT);
    o = good;
    o.force = vm_odd_force_user(NULL, NULL);
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_BAD_ARGUMENT);
    o = good;
    o.x = VM_INFINITY;
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_NOT_FINITE && vm_odd_plan_init(&plan, &good, VM_NAN) == VM_NOT_FINITE);
    CHECK(vm_odd_within(&good, 4, -1, &m) == VM_DOMAIN && vm_odd_within(&good, 4, VM_NAN, &m) == VM_NOT_FINITE);
    CHECK(vm_odd_plan_init(&plan, &good, 4) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, 3, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_odd_plan_by_route(&plan, -1, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_odd_plan_within(&plan, 5, 0, &m) == VM_DOMAIN && vm_odd_plan_within(&plan, -1, 0, &m) == VM_DOMAIN);
    CHECK(vm_odd_plan_within(&plan, VM_NAN, 0, &m) == VM_NOT_FINITE);
    CHECK(m.x == 0 && m.route == 0 && d[0] == 7);
}

static void test_nearly_exhausted(void)
{
    double left;
    for (left = 1e-2; left > (is_float ? 1e-3 : 1e-6); left /= 3) {
        const exhausted_motion e = nearly_exhausted(left);
        vm_odd_problem o;
        vm_odd_motion m;
        memset(&o, 0, sizeof o);
        o.force = vm_duffing_force(e.stiffness, 0);
        o.mass = e.mass;
        o.stiffness = vm_law_linear(1, 0);
        o.damping = vm_law_linear(0, 0);
        o.reactive = R(0.5);
        o.x = 1;
        o.v = 1;
        CHECK(vm_odd_within(&o, e.t, R(by_precision(1e-6, 1e-2)), &m) == VM_OK);
        check_error("nearly exhausted", "odd force", "est", exhausted_ratio(&e, m.x, m.v, m.error), 1, left, (double)e.t);
    }
}

int main(void)
{
    test_against_duffing();
    test_pendulum();
    test_other_forces();
    test_amplitude_below_the_end();
    test_ripple();
#ifndef VM_USE_FLOAT
    test_orders();
    test_estimates();
    test_within();
    test_tables_and_users();
    test_backward();
    test_crossing();
    test_constant_laws();
    test_linear_solution();
#endif
    test_any_precision();
    test_stiff_spring();
    test_forces_refused();
    test_duffing_not_finite();
    test_problems_refused();
    test_nearly_exhausted();
    return check_finish("odd_force");
}
