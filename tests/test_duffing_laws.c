/* Duffing's oscillator whose coefficients k1 and k3 follow laws of their own: the order of the averaged motion, the same
   motion by a common factor, estimates of errors against integration, tables, a coefficient that passes 0, and what is
   refused. */
#include <stdlib.h>
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

static vm_odd_plan plan;

static vm_odd_problem problem_of(const vm_law *laws, double x, double v)
{
    vm_odd_problem o;
    o.force = vm_duffing_force_of_laws(laws);
    o.mass = vm_law_linear(1, 0);
    o.stiffness = vm_law_linear(1, 0);
    o.damping = vm_law_linear(0, 0);
    o.reactive = 1;
    o.x = R(x);
    o.v = R(v);
    return o;
}

/* The error of a motion at t, as its field error defines it, with the vibration of the present coefficients */
static double error_of(const vm_odd_problem *o, double t, const vm_odd_motion *m, const vm_odd_motion *truth)
{
    vmi_odd_now now;
    vm_odd_force force;
    vmi_orbit orbit;
    double speed;
    CHECK(vmi_odd_read_laws(o, R(t), -1, &now) == VM_OK);
    force = vm_duffing_force(now.k1, now.k3);
    speed = sqrt((double)(now.k / now.m));
    if (vmi_orbit_of_state(&force, truth->x, R((double)truth->v / speed), &orbit)) return 0;
    return fmax(fabs((double)(m->x - truth->x)) / (double)orbit.swing,
                fabs((double)(m->v - truth->v)) / ((double)orbit.vmax * speed));
}

#ifndef VM_USE_FLOAT
/* ---- Orders ---- */

/* The largest errors of x and v of both averaged laws between 2.4/rate and 3/rate */
static void waveform_errors(vm_odd_problem *o, double rate, double *error)
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
    CHECK(vm_odd_plan_init(&plan, o, 3 / rate) == VM_OK && plan.reach == 3 / rate);
    CHECK(rk87_init(&s, vm_odd_rhs, o, 2, 0, y, &options, work) >= 0);
    error[0] = error[1] = 0;
    for (i = 0; i <= 60; i++) {
        const double t = (2.4 + 0.01 * i) / rate;
        CHECK(rk87_solve(&s, t) >= 0);
        for (route = VM_ODD_MEAN; route <= VM_ODD_ORDER2; route++) {
            vm_odd_motion m = {0, 0, 0, 0, 0, 0};
            CHECK(vm_odd_plan_by_route(&plan, route, t, 0, &m) == VM_OK);
            error[route] = fmax(error[route], fmax(fabs(m.x - s.y[0]), fabs(m.v - s.y[1])));
        }
    }
}

/* k1 and k3 as they are at t = 0, their rates divided by a small number, x and v */
static const double cases[8][6] = {
    {1, 0.5, 0.3, -0.1, 1.5, 0.4},   {1, -0.2, 0.3, 0, 1.2, 0.3},      {-1, 1, 0.06, 0.1, 2.2, 0.2},
    {-1, 1, 0.12, 0.09, 1.2, 0.1},   {-1, 1, 0.12, 0.09, -1.2, 0.1},   {0, 1, 0, 0.3, 1, 0.5},
    {1, 0, 0.3, 0, 1, 1},            {0.05, 1, 0.015, 0.12, 1, 0.2}};

static vm_odd_problem numbered(int number, double rate, vm_law *laws)
{
    const double *c = cases[number], sign = number == 2 ? -1 : 1;
    vm_odd_problem o;
    laws[0] = vm_law_linear(c[0], c[2] * rate);
    laws[1] = vm_law_linear(c[1], c[3] * rate);
    o = problem_of(laws, c[4], c[5]);
    o.mass = vm_law_linear(1, 0.1 * rate * sign);
    o.stiffness = vm_law_exponential(1, 0.1 * rate);
    o.damping = vm_law_linear((number == 2 ? -0.6 : 0.2) * rate, 0);
    o.reactive = 0.3;
    return o;
}

/* The errors of the mean motion fall as the rate of the laws, those with its ripple as its square, over a time of
   3/rate. */
static void test_orders(void)
{
    int number, route, k;
    for (number = 0; number < 8; number++) {
        double error[2][2];
        for (k = 0; k < 2; k++) {
            const double rate = 0.04 / (1 << (4 * k));
            vm_law laws[2];
            vm_odd_problem o = numbered(number, rate, laws);
            waveform_errors(&o, rate, error[k]);
        }
        for (route = 0; route < 2; route++) {
            const double slope = log(error[0][route] / error[1][route]) / log(16);
            check_error("slope in eps", route ? "order 2" : "mean", "abs", fabs(slope - 1 - route),
                        0.25, number, slope);
        }
    }
}

/* If k1 and k3 keep their ratio, the motion is that of a common factor of both. */
static void test_common_factor(void)
{
    const vm_law laws[2] = {vm_law_exponential(100, 0.01), vm_law_exponential(2000, 0.01)};
    vm_odd_problem apart = problem_of(laws, 0.2, 0.5), together = apart;
    vm_odd_motion a = {0, 0, 0, 0, 0, 0}, b = a;
    int route;
    together.force = vm_duffing_force(100, 2000);
    together.stiffness = vm_law_exponential(1, 0.01);
    for (route = VM_ODD_MEAN; route <= VM_ODD_RK87; route++) {
        CHECK(vm_odd_plan_init(&plan, &apart, 30) == VM_OK);
        CHECK(vm_odd_plan_by_route(&plan, route, 30, 1e-9, &a) == VM_OK);
        CHECK(vm_odd_plan_init(&plan, &together, 30) == VM_OK);
        CHECK(vm_odd_plan_by_route(&plan, route, 30, 1e-9, &b) == VM_OK);
        near("common factor", "x", a.x, b.x, 1e-9, 1e-9);
        near("common factor", "v", a.v, b.v, 1e-9, 1e-9);
        near("common factor", "amplitude", a.amplitude, b.amplitude, 1e-9, 1e-9);
    }
}

/* ---- Estimates ---- */

static double log_uniform(double low, double high) { return exp(uniform(log(low), log(high))); }

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* A law that starts at f0 and changes at a relative rate of at most `rate` until T, without passing 0 */
static vm_law random_law(double f0, double rate, double T)
{
    const double r = fmax(uniform(-1, 1) * rate, -0.7 / T);
    if (uniform(0, 1) < 0.4) return vm_law_linear(f0, f0 * r);
    if (uniform(0, 1) < 0.5) return vm_law_exponential(f0, r);
    return vm_law_power(f0, r, uniform(-1, 2));
}

/* Random problems: the true error is above 3 estimates in at most 1 % of them, and never above 10. */
static void test_estimates(void)
{
    enum { PROBLEMS = 240 };
    static double ratio[3][PROBLEMS];
    static const char *names[3] = {"mean", "order 2", "rk87"};
    int n[3] = {0, 0, 0}, i, route;
    for (i = 0; i < PROBLEMS; i++) {
        const double rate = log_uniform(0.004, 0.1), T = uniform(0.5, 2) / rate, c = log_uniform(0.1, 1);
        const double k1 = i % 4 < 2 ? 1 : -1, k3 = i % 4 == 1 ? -c : 1;
        double A = uniform(0.3, 2);
        vm_law laws[2];
        vm_odd_problem o;
        vm_odd_motion truth = {0, 0, 0, 0, 0, 0}, m = truth;
        if (i % 4 == 1) A = uniform(0.1, 0.8) / sqrt(c);
        if (i % 4 == 2) A = uniform(1.5, 3);
        if (i % 4 == 3) A = uniform(1.02, 1.38);
        laws[0] = random_law(k1, rate, T);
        laws[1] = random_law(k3, rate, T);
        o = problem_of(laws, A, uniform(-0.1, 0.1));
        o.mass = random_law(1, rate, T);
        o.damping = vm_law_linear(rate * uniform(-0.2, 0.3), 0);
        o.reactive = uniform(0, 1);
        CHECK(vm_odd_plan_init(&plan, &o, T) == VM_OK);
        if (vm_odd_plan_by_route(&plan, VM_ODD_RK87, T, 1e-12, &truth) < 0) continue; /* runs away */
        for (route = 0; route < 3; route++) {
            const int status = vm_odd_plan_by_route(&plan, route, T, 1e-7, &m);
            CHECK(status == VM_OK || status == VM_NO_LAW);
            if (status == VM_NO_LAW || !(m.error < 1) || truth.error > m.error / 3) continue;
            ratio[route][n[route]] = error_of(&o, T, &m, &truth) / m.error;
            n[route]++;
        }
    }
    for (route = 0; route < 3; route++) {
        qsort(ratio[route], (size_t)n[route], sizeof(double), rising);
        CHECK(n[route] > PROBLEMS / 2);
        check_error("error/estimate", names[route], "1", ratio[route][n[route] - 1], 10, n[route], 0);
        check_error("99 % of them", names[route], "1", ratio[route][n[route] * 99 / 100], 3, n[route], 0);
        check_error("1/median", names[route], "1", 1 / ratio[route][n[route] / 2], route == VM_ODD_RK87 ? 40 : 12,
                    n[route], 0);
    }
}

/* ---- Tables, backward, a coefficient that passes 0 ---- */

/* A table of k1 whose second derivative jumps at its points keeps second order. */
static void test_table(void)
{
    double error[2][2];
    int k;
    for (k = 0; k < 2; k++) {
        const double rate = 0.04 / (1 << (4 * k));
        vm_real time[4], value[4] = {1, 1.2, 1.7, 1.8};
        vm_law laws[2];
        vm_odd_problem o;
        int i;
        for (i = 0; i < 4; i++) time[i] = i / rate;
        laws[0] = vm_law_table(4, time, value);
        laws[1] = vm_law_linear(0.5, 0);
        o = problem_of(laws, 1.5, 0.4);
        waveform_errors(&o, rate, error[k]);
    }
    check_error("table of k1", "slope, mean", "abs", fabs(log(error[0][0] / error[1][0]) / log(16) - 1), 0.25,
                error[0][0], error[1][0]);
    check_error("table of k1", "slope, order 2", "abs", fabs(log(error[0][1] / error[1][1]) / log(16) - 2), 0.35,
                error[0][1], error[1][1]);
}

static void test_backward(void)
{
    int number;
    for (number = 0; number < 8; number++) {
        vm_law laws[2];
        vm_odd_problem o = numbered(number, -0.01, laws);
        vm_odd_motion m = {0, 0, 0, 0, 0, 0}, same = m;
        CHECK(vm_odd_plan_init(&plan, &o, -100) == VM_OK && plan.reach == -100);
        CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, -100, 1e-11, &same) >= 0);
        CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, -100, 0, &m) == VM_OK);
        CHECK(error_of(&o, -100, &m, &same) < 3 * m.error && m.error < 2e-2);
    }
}

/* k1 falls through 0: a column buckles. The averaged motion ends before, and within integrates. */
static void test_through_zero(void)
{
    const vm_law buckling[2] = {vm_law_linear(1, -0.02), vm_law_linear(1, 0)};
    const vm_law from_zero[2] = {vm_law_linear(0, 0.02), vm_law_linear(1, 0)};
    vm_odd_problem o = problem_of(buckling, 1, 0);
    vm_odd_motion m = {0, 0, 0, 0, 0, 0}, again = m;
    CHECK(vm_odd_plan_init(&plan, &o, 100) == VM_OK && plan.reach > 5 && plan.reach < 50);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, 60, 0, &m) == VM_NO_LAW);
    CHECK(vm_odd_plan_within(&plan, 100, 1e-7, &m) == VM_OK && m.route == VM_ODD_RK87);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, 100, 1e-10, &again) == VM_OK);
    CHECK(fabs(m.x - again.x) < 3e-7 && fabs(m.amplitude - again.amplitude) < 1e-5);
    o = problem_of(from_zero, 1, 0);
    CHECK(vm_odd_plan_init(&plan, &o, 50) == VM_OK && plan.reach == 0);
    CHECK(vm_odd_plan_within(&plan, 50, 1e-7, &m) == VM_OK && m.amplitude < 1 && m.amplitude > 0.5);
    /* The place of rest in a well moves with the laws, so that a body does not stay at rest there. */
    {
        const vm_law deeper[2] = {vm_law_linear(-1, -0.01), vm_law_linear(1, 0)};
        o = problem_of(deeper, 1, 0);
        CHECK(vm_odd_within(&o, 40, 1e-6, &m) == VM_OK && fabs(m.x - sqrt(1.4)) < 0.02 && m.x != 1);
    }
}
#endif

/* In any precision: the averaged motion against integration, and the equation of motion */
static void test_any_precision(void)
{
    const vm_law laws[2] = {vm_law_linear(1, R(0.004)), vm_law_linear(R(0.5), R(-0.002))};
    vm_odd_problem o = problem_of(laws, 1.5, 0.4);
    vm_odd_motion a = {0, 0, 0, 0, 0, 0}, b = a;
    vm_real y[2] = {R(1.5), R(0.5)}, d[2];
    o.mass = vm_law_linear(1, R(0.003));
    CHECK(vm_odd_plan_init(&plan, &o, 60) == VM_OK && plan.reach == 60);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, 60, 0, &a) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, 60, R(1e-4), &b) >= 0);
    CHECK(error_of(&o, 60, &a, &b) < 3 * (double)(a.error + b.error) && (double)a.error < 5e-3);
    CHECK(vm_odd_rhs(10, y, d, &o) == VM_OK && d[0] == y[1]);
    near("equation of motion", "x''", (double)d[1], -(1.04 * 1.5 + 0.48 * 1.5 * 1.5 * 1.5 + 0.003 * 0.5) / 1.03, 1e-14,
         1e-6);
    o.x = 0;
    o.v = 0;
    CHECK(vm_odd_plan_init(&plan, &o, 60) == VM_OK && plan.at_rest);
    CHECK(vm_odd_plan_within(&plan, 60, 0, &a) == VM_OK && a.x == 0 && a.v == 0);
}

static void test_refused(void)
{
    vm_law laws[2] = {vm_law_linear(1, 0), vm_law_linear(1, 0)};
    vm_odd_problem o = problem_of(laws, 1, 0);
    vm_real x = 7, v = 7, y[2] = {1, 1}, d[2] = {7, 7};
    vm_odd_motion m;
    const vm_odd_force none = vm_duffing_force_of_laws(NULL);
    memset(&m, 0, sizeof m);
    CHECK(vm_odd_exact_from(&o.force, 1, 1, 0, &x, &v) == VM_NO_LAW && is_nan(vm_odd_period(&o.force, 1)));
    CHECK(vm_odd_exact_from(&none, 1, 1, 0, &x, &v) == VM_BAD_ARGUMENT);
    laws[1] = vm_law_user(NULL, NULL);
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_BAD_ARGUMENT && vm_odd_rhs(0, y, d, &o) == VM_BAD_ARGUMENT);
    laws[1] = vm_law_linear(VM_NAN, 0);
    CHECK(vm_odd_plan_init(&plan, &o, 4) == VM_NOT_FINITE && vm_odd_rhs(0, y, d, &o) == VM_NOT_FINITE);
    laws[0] = vm_law_linear(-1, 0); /* nothing vibrates: it runs away */
    laws[1] = vm_law_linear(-1, 0);
    CHECK(vm_odd_plan_init(&plan, &o, R(0.5)) == VM_OK && plan.reach == 0);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_MEAN, R(0.5), 0, &m) == VM_NO_LAW);
    o.force = none;
    CHECK(vm_odd_within(&o, 4, 0, &m) == VM_BAD_ARGUMENT && vm_odd_rhs(0, y, d, &o) == VM_BAD_ARGUMENT);
    CHECK(x == 7 && v == 7 && d[0] == 7 && m.x == 0);
}

int main(void)
{
#ifndef VM_USE_FLOAT
    test_orders();
    test_common_factor();
    test_estimates();
    test_table();
    test_backward();
    test_through_zero();
#endif
    test_any_precision();
    test_refused();
    return check_finish("duffing_laws");
}
