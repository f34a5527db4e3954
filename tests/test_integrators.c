/* integrators.h: measured orders, closed forms and high-precision solutions, and every way in which a run can end. */
#include "../integrators.h"
#include <stdlib.h>
#include "check.h"
#include "data/detest_table.h"
#include "detest.h"

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

/* ---- right-hand sides ---- */

static int linear_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* y = (cos t, sin t, exp(-t)) */
{
    (void)t;
    (void)ctx;
    dydt[0] = -y[1];
    dydt[1] = y[0];
    dydt[2] = -y[2];
    return 0;
}

static int time_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* y' = 2 t y: y = exp(t^2) */
{
    (void)ctx;
    dydt[0] = 2 * t * y[0];
    return 0;
}

/* (m x')' + x|x|^(alpha-1) = 0 with y = (x, m x'): ctx points at {alpha, m'/m0, power of the mass law} */
static int oscillator_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real *p = (const vm_real *)ctx;
    dydt[0] = y[1] / VM_LIBM(pow)(1 + p[1] * t, p[2]);
    dydt[1] = -VM_COPYSIGN(VM_LIBM(pow)(VM_FABS(y[0]), p[0]), y[0]);
    return 0;
}

static int blow_up_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* y = 1/(1 - t) */
{
    (void)t;
    (void)ctx;
    dydt[0] = y[0] * y[0];
    return 0;
}

typedef struct wall {
    vm_real at;
    int use_nan;
    long calls;
} wall; /* f exists for t < at */

static int wall_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    wall *w = (wall *)ctx;
    w->calls++;
    dydt[0] = -y[0];
    if (t < w->at) return 0;
    if (w->use_nan) dydt[0] = VM_NAN;
    return w->use_nan ? 0 : 7;
}

/* ---- orders ---- */

static double rk4_error(long steps)
{
    vm_real y[3] = {1, 0, 1}, work[RK4_WORK(3)], t = 0;
    CHECK(rk4_solve(linear_rhs, NULL, 3, &t, 2, steps, y, work) == ODE_OK && t == 2);
    return fmax(fabs((double)y[0] - cos(2.)), fmax(fabs((double)y[1] - sin(2.)), fabs((double)y[2] - exp(-2.))));
}

static double rk4_error_of_time(long steps)
{
    vm_real y[1] = {1}, work[RK4_WORK(1)], t = 0;
    CHECK(rk4_solve(time_rhs, NULL, 1, &t, 1, steps, y, work) == ODE_OK);
    return fabs((double)y[0] - exp(1.));
}

/* steps of fixed size h, because no error is ever too large; *inside is the error in the middle of the last step */
static double rk45_error(vm_real h, double *inside)
{
    vm_real y0[3] = {1, 0, 1}, y[3], work[RK45_WORK(3)];
    rk45_options o = {0};
    rk45 s;
    double t;
    o.atol = 1000;
    o.h0 = o.h_max = h;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK);
    CHECK(rk45_solve(&s, 2) == ODE_OK && s.t == 2 && s.rejected == 0 && s.evals == 6 * s.steps + 1);
    t = ((double)s.t_old + (double)s.t) / 2;
    CHECK(rk45_interpolate(&s, R(t), y) == ODE_OK);
    *inside = fmax(fabs((double)y[0] - cos(t)), fmax(fabs((double)y[1] - sin(t)), fabs((double)y[2] - exp(-t))));
    return fmax(fabs((double)s.y[0] - cos(2.)),
                fmax(fabs((double)s.y[1] - sin(2.)), fabs((double)s.y[2] - exp(-2.))));
}

/* the same by rk87 */
static double rk87_error(vm_real h, double *inside)
{
    vm_real y0[3] = {1, 0, 1}, y[3], work[RK87_WORK(3)];
    rk87_options o = {0};
    rk87 s;
    double t;
    o.atol = 1000;
    o.h0 = o.h_max = h;
    CHECK(rk87_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK);
    CHECK(rk87_solve(&s, 4) == ODE_OK && s.t == 4 && s.rejected == 0 && s.evals == 13 * s.steps + 1);
    t = ((double)s.t_old + (double)s.t) / 2;
    CHECK(rk87_interpolate(&s, R(t), y) == ODE_OK && s.evals == 13 * s.steps + 8);
    *inside = fmax(fabs((double)y[0] - cos(t)), fmax(fabs((double)y[1] - sin(t)), fabs((double)y[2] - exp(-t))));
    CHECK(rk87_interpolate(&s, s.t_old, y) == ODE_OK && s.evals == 13 * s.steps + 8);
    return fmax(fabs((double)s.y[0] - cos(4.)),
                fmax(fabs((double)s.y[1] - sin(4.)), fabs((double)s.y[2] - exp(-4.))));
}

/* y' = 2 t y to t = 1 by rk45 and rk87 with steps of fixed size */
static double error_of_time(vm_real h, int order)
{
    vm_real y0[1] = {1}, work[RK87_WORK(1)];
    rk45_options o = {0};
    rk45 s;
    o.atol = 1000;
    o.h0 = o.h_max = h;
    CHECK((order == 5 ? rk45_init : rk87_init)(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK);
    CHECK((order == 5 ? rk45_solve(&s, 1) : rk87_solve(&s, 1)) == ODE_OK);
    return fabs((double)s.y[0] - exp(1.));
}

static void check_order(const char *method, double order, double wanted, double allowed)
{
    printf("%s: measured order %.3f\n", method, order);
    CHECK(fabs(order - wanted) < allowed);
}

static void test_orders(void)
{
    double a, b, inside_a, inside_b;
    if (is_float) return; /* in float rounding hides them */
    check_order("rk4", log2(rk4_error(40) / rk4_error(80)), 4, 0.1);
    check_order("rk4, f of t", log2(rk4_error_of_time(40) / rk4_error_of_time(80)), 4, 0.2);
    a = rk45_error(0.125, &inside_a);
    b = rk45_error(0.0625, &inside_b);
    check_order("rk45", log2(a / b), 5, 0.3);
    check_order("rk45_interpolate (local error)", log2(inside_a / inside_b), 5, 0.5);
    check_order("rk45, f of t", log2(error_of_time(R(0.0625), 5) / error_of_time(R(0.03125), 5)), 5, 0.5);
    a = rk87_error(1, &inside_a);
    b = rk87_error(0.5, &inside_b);
    check_order("rk87", log2(a / b), 8, 0.5);
    check_order("rk87_interpolate (local error)", log2(inside_a / inside_b), 9, 0.7);
    check_order("rk87, f of t", log2(error_of_time(R(0.25), 8) / error_of_time(R(0.125), 8)), 8.5, 0.8);
}

/* ---- known solutions ---- */

typedef struct known {
    const char *name;
    vm_real p[3];
    double t, x;
} known;

/* Bessel functions, an elementary function, and 40-digit extrapolation; x(0) = 1, x'(0) = 0 */
static const known solutions[] = {
    {"m = 1 + 0.1 t", {1, R(0.1), 1}, 10, -0.3331145282992179077380452},
    {"m = 1 + 0.1 t", {1, R(0.1), 1}, 50, -0.4912946398391219988499127},
    {"m = (1 + 0.1 t)^2", {1, R(0.1), 2}, 10, 0.5884587582788442775617413},
    {"cubic (398)", {3, R(0.1), 1}, 10, 0.8329476745754213932},
    {"cubic (398)", {3, R(0.1), 1}, 20, 0.1626996653923250896},
};

static void test_known_solutions(void)
{
    size_t i;
    double tol;
    for (i = 0; i < sizeof solutions / sizeof *solutions; i++) {
        known k = solutions[i];
        for (tol = is_float ? 1e-5 : 1e-12; tol < 1e-3; tol *= 100) {
            vm_real y0[2] = {1, 0}, work[RK45_WORK(2)];
            rk45_options o = {0};
            rk45 s;
            o.rtol = o.atol = R(tol);
            CHECK(rk45_init(&s, oscillator_rhs, k.p, 2, 0, y0, &o, work) == ODE_OK);
            CHECK(rk45_solve(&s, R(k.t)) == ODE_OK && s.t == R(k.t));
            check_error("x(t)", k.name, "tol", fabs((double)s.y[0] - k.x) / tol, 30, k.t, tol);
            CHECK(rk45_solve(&s, 0) == ODE_OK && s.t == 0); /* and back */
            check_error("x(0), back", k.name, "tol", fabs((double)s.y[0] - 1) / tol, 12, k.t, tol);
        }
    }
}

static void test_interpolation(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)], y, before;
    double tol = is_float ? 1e-5 : 1e-9;
    rk45_options o = {0};
    rk45 s;
    o.rtol = R(tol);
    o.atol = -1;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, -2, y0, &o, work) == ODE_OK);
    while (s.t < 1) {
        double x;
        CHECK(rk45_step(&s) == ODE_OK);
        for (x = 0; x <= 1; x += 0.125) {
            double t = (double)s.t_old + x * (double)(s.t - s.t_old), exact;
            t = (double)(vm_real)t;
            exact = exp(t * t - 4);
            CHECK(rk45_interpolate(&s, (vm_real)t, &y) == ODE_OK);
            check_error("interpolate", "y = exp(t^2)", "tol", fabs((double)y / exact - 1) / tol, 30, t, tol);
        }
    }
    CHECK(rk45_interpolate(&s, s.t, &y) == ODE_OK && y == s.y[0]);
    before = y;
    CHECK(rk45_interpolate(&s, s.t + 1, &y) == ODE_BAD_ARGUMENT && y == before);
    CHECK(rk45_interpolate(&s, s.t_old - 1, &y) == ODE_BAD_ARGUMENT && y == before);
    CHECK(rk45_interpolate(&s, VM_NAN, &y) == ODE_BAD_ARGUMENT && y == before);
    CHECK(rk45_restart(&s, VM_NAN, &y) == ODE_BAD_ARGUMENT && rk45_restart(&s, 0, NULL) == ODE_BAD_ARGUMENT);
    y = VM_NAN;
    CHECK(rk45_restart(&s, 0, &y) == ODE_BAD_ARGUMENT && rk45_restart(NULL, 0, &y) == ODE_BAD_ARGUMENT);
    CHECK(s.t >= 1 && s.y[0] == before);
    y = 2;
    CHECK(rk45_restart(&s, s.t, &y) == ODE_OK && s.y[0] == 2 && s.t_old == s.t);
    CHECK(rk45_step(&s) == ODE_OK && s.y[0] > 2 && rk45_interpolate(&s, s.t_old, &y) == ODE_OK && y == 2);
    { /* the first step after a restart is that of a run that starts there, with the same step size */
        vm_real start = 3, other_work[RK45_WORK(1)];
        rk45 fresh;
        CHECK(rk45_restart(&s, R(0.5), &start) == ODE_OK);
        o.h0 = s.h;
        CHECK(rk45_init(&fresh, time_rhs, NULL, 1, R(0.5), &start, &o, other_work) == ODE_OK);
        CHECK(rk45_step(&s) == ODE_OK && rk45_step(&fresh) == ODE_OK && s.t == fresh.t && s.y[0] == fresh.y[0]);
    }
    { /* backward */
        vm_real middle;
        CHECK(rk45_solve(&s, R(-0.5)) == ODE_OK && s.t_old > s.t);
        middle = s.t + (s.t_old - s.t) / 2;
        CHECK(rk45_interpolate(&s, middle, &y) == ODE_OK &&
              rk45_interpolate(&s, s.t - 1, &before) == ODE_BAD_ARGUMENT);
        check_error("interpolate", "backward", "tol",
                    fabs((double)y / (double)s.y[0] / exp((double)(middle * middle - s.t * s.t)) - 1) / tol, 30,
                    (double)middle, tol);
    }
}

/* ---- step size control ---- */

static int arenstorf_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real mu = R(0.012277471), mu1 = 1 - mu;
    vm_real r1 = (y[0] + mu) * (y[0] + mu) + y[1] * y[1], r2 = (y[0] - mu1) * (y[0] - mu1) + y[1] * y[1];
    (void)t;
    (void)ctx;
    r1 *= VM_SQRT(r1);
    r2 *= VM_SQRT(r2);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = y[0] + 2 * y[3] - mu1 * (y[0] + mu) / r1 - mu * (y[0] - mu1) / r2;
    dydt[3] = y[1] - 2 * y[2] - mu1 * y[1] / r1 - mu * y[1] / r2;
    return 0;
}

static int stiff_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = -*(const vm_real *)ctx * y[0];
    return 0;
}

/* The Arenstorf orbit, which wants steps of very different sizes: what it took when the control was last measured */
static void test_control(void)
{
    vm_real y0[4] = {R(0.994), 0, 0, R(-2.00158510637908252240537862224)}, work[RK45_WORK(4)], h, slow = R(1e-8);
    rk45_options o = {0};
    rk45 s;
    if (!is_float) {
        o.rtol = o.atol = R(1e-9);
        CHECK(rk45_init(&s, arenstorf_rhs, NULL, 4, 0, y0, &o, work) == ODE_OK);
        CHECK(rk45_solve(&s, R(17.0652165601579625588917206249)) == ODE_OK);
        printf("Arenstorf orbit, 1e-9: %ld steps, %ld rejected, %ld evaluations\n", s.steps, s.rejected, s.evals);
        CHECK(labs(s.steps - 616) <= 4 && s.rejected >= 6 && s.rejected <= 14 &&
              s.evals == 6 * (s.steps + s.rejected) + 2);
        check_error("after one period", "Arenstorf", "tol", fabs((double)(s.y[0] - y0[0])) / 1e-9, 5, 17, 0);
    }
    y0[0] = 1;
    y0[1] = 0;
    y0[2] = 1;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, NULL, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    h = s.h; /* a step that was cut to meet t_end does not shorten the next one */
    CHECK(rk45_solve(&s, 1 + h / 100) == ODE_OK && s.h >= h && rk45_solve(&s, 1 + h / 50) == ODE_OK && s.h >= h);
    o.h_max = R(0.01);
    o.rtol = o.atol = 0;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    CHECK(s.steps >= 100 && s.steps <= 102);
    /* times far from 0, steps near the resolution of t, intervals of a few ulps */
    CHECK(rk45_init(&s, stiff_rhs, &slow, 1, R(1e6) / VM_EPSILON, y0, NULL, work) == ODE_OK &&
          rk45_step(&s) == ODE_OK);
    o.h_max = 0;
    o.h0 = VM_EPSILON * VM_EPSILON;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 1, y0, &o, work) == ODE_OK && rk45_solve(&s, 2) == ODE_OK);
    CHECK(rk45_restart(&s, 1 / VM_EPSILON, s.y) == ODE_OK && rk45_solve(&s, 1 / VM_EPSILON + 2) != ODE_MAX_STEPS);
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, -VM_MAX, y0, NULL, work) == ODE_OK && rk45_solve(&s, VM_MAX) < 0);
}

static int refusing_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)y;
    (void)ctx;
    dydt[0] = 1;
    return t > 1 ? -3 : 0;
}

static int growing_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    dydt[0] = VM_MAX / 100;
    return 0;
}

/* An interval in which no step can be short enough ends with a status, not in a loop. */
static void test_unresolvable(void)
{
    vm_real y0[1] = {5}, work[RK45_WORK(1)], rate, t0 = is_float ? R(1e4) : R(1e10), ulp = t0 * VM_EPSILON;
    rk45_options o = {0};
    rk45 s;
    o.max_steps = -1;
    for (rate = R(0.01) / ulp; rate < 100 / ulp; rate *= R(1.3)) {
        int status, k;
        for (k = 1; k < 6; k++) {
            CHECK(rk45_init(&s, stiff_rhs, &rate, 1, t0, y0, &o, work) == ODE_OK);
            status = rk45_solve(&s, t0 + (vm_real)k * ulp);
            CHECK(status == ODE_OK || status == ODE_STEP_TOO_SMALL);
        }
    }
    CHECK(rk45_init(&s, refusing_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK &&
          rk45_solve(&s, 2) == ODE_RHS_STOPPED);
    CHECK(s.rhs_status == -3 && s.t <= 1);
    CHECK(rk45_init(&s, refusing_rhs, NULL, 1, R(0.9999), y0, NULL, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    CHECK(rk45_init(&s, growing_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK && rk45_solve(&s, 1000) < 0);
    CHECK(VM_IS_FINITE(s.y[0]) && s.t > 20 && s.t < 101); /* the state would be infinite, its derivative is not */
    rate = R(1e6);
    o.max_steps = 7;
    o.h0 = 1;
    CHECK(rk45_init(&s, stiff_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 10) == ODE_MAX_STEPS);
    CHECK(s.rejected > 0 && s.steps + s.rejected == 7);
    o.h0 = R(1e-6);
    rate = R(1e-3);
    o.max_steps = 0; /* a step is at most ten times the one before */
    CHECK(rk45_init(&s, stiff_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK);
    CHECK(fabs((double)(s.h / o.h0) - 10) < 1e-5);
}

/* ---- the clock ---- */

static int turn_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* y = (cos, sin) of *ctx (t - t0) */
{
    const vm_real speed = *(const vm_real *)ctx;
    (void)t;
    dydt[0] = -speed * y[1];
    dydt[1] = speed * y[0];
    return 0;
}

/* The error at the end of a run of `span`, by rk45 (order 5) or rk87; *worst is the largest at the end of any step */
static double clock_error(int order, double speed, double t0, double span, double tol, double h_max, double *worst)
{
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)], rate = R(speed);
    const double end = (double)R(t0 + span);
    rk45_options o = {0};
    rk45 s;
    o.rtol = o.atol = R(tol);
    o.h_max = R(h_max);
    o.max_steps = -1;
    *worst = 0;
    CHECK((order == 5 ? rk45_init : rk87_init)(&s, turn_rhs, &rate, 2, R(t0), y0, &o, work) == ODE_OK);
    s.h = R(h_max);
    while ((double)s.t + (double)s.h < end) {
        const int status = order == 5 ? rk45_step(&s) : rk87_step(&s);
        const double angle = (double)rate * ((double)s.t - t0);
        if (status != ODE_OK) FAIL("a step failed");
        if (status != ODE_OK) break;
        *worst = fmax(*worst, fmax(fabs((double)s.y[0] - cos(angle)), fabs((double)s.y[1] - sin(angle))));
    }
    CHECK((order == 5 ? rk45_solve(&s, R(end)) : rk87_solve(&s, R(end))) == ODE_OK && (double)s.t == end);
    return fmax(fabs((double)s.y[0] - cos((double)rate * (end - t0))),
                fabs((double)s.y[1] - sin((double)rate * (end - t0))));
}

/* The time in s.t and the time that the motion has taken are the same, after any number of steps, at any time on the
   clock. In parentheses what the error was while t + h was rounded and h was not. */
static void test_clock(void)
{
    static const struct {
        int order;
        double speed, t0, span, tol, h_max, bound;
    } run[] = {
        {5, 1, 1.7e9, 1000, 1e-10, 0, 9e-9},            /* (2.4e-4) */
        {5, 1, 0, 3600, 1e-10, 1e-3, 2e-11},            /* (2.8e-7) */
        {5, 1, 0, 2000, 1e-13, 0, 2e-11},               /* (4e-9) */
        {8, 6.283185307179586, 0, 1000, 1e-12, 0, 2e-10}, /* (1.2e-9) */
        {8, 6.283185307179586, 1e6, 100, 1e-12, 0, 2e-11}, /* (1.3e-6) */
        {8, 6.283185307179586, 1.7e9, 100, 1e-12, 0, 2e-11}, /* (1.6e-3) */
        {5, 1, 1e12, 100, 1e-13, 0, 2e-12},             /* (0.08) */
        {8, 6.283185307179586, 1e12, 10, 1e-13, 0, 2e-12}, /* (0.06) */
    };
    double worst;
    size_t i;
    if (is_float) { /* (4.8e-3) */
        const double error = clock_error(5, 1, 0, 100, 1e-4, 0.02, &worst);
        check_error("clock", "h_max = 0.02", "", error, 3e-5, 100, 0);
        check_error("clock", "any step", "", worst, 3e-5, 100, 0);
        return;
    }
    for (i = 0; i < sizeof run / sizeof *run; i++) {
        const char *name = run[i].order == 5 ? "rk45" : "rk87";
        const double t0 = run[i].t0, tol = run[i].tol, bound = run[i].bound;
        const double error = clock_error(run[i].order, run[i].speed, t0, run[i].span, tol, run[i].h_max, &worst);
        check_error("clock: error over bound", name, "", error / bound, 1, t0, tol);
        check_error("any step", name, "", worst / bound, 1, t0, tol);
    }
}

/* The option work_size is looked at */
static void test_work_size(void)
{
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)];
    rk45_options o = {0};
    rk45 s;
    o.work_size = 8;
    CHECK(rk45_init(&s, oscillator_rhs, NULL, 2, 0, y0, &o, work) == ODE_WORK_TOO_SMALL);
    o.work_size = RK45_WORK(2);
    CHECK(rk45_init(&s, oscillator_rhs, NULL, 2, 0, y0, &o, work) == ODE_OK);
    CHECK(rk87_init(&s, oscillator_rhs, NULL, 2, 0, y0, &o, work) == ODE_WORK_TOO_SMALL);
    o.work_size = (long)(sizeof work / sizeof *work);
    CHECK(rk87_init(&s, oscillator_rhs, NULL, 2, 0, y0, &o, work) == ODE_OK);
    o.work_size = -1;
    CHECK(rk45_init(&s, oscillator_rhs, NULL, 2, 0, y0, &o, work) == ODE_WORK_TOO_SMALL);
    CHECK(strstr(ode_strerror(ODE_WORK_TOO_SMALL), "RK45_WORK") != NULL);
}

/* ---- the smallest step ---- */

typedef struct jump {
    vm_real from, to, slope; /* y' = slope at from <= t < to, else 0 */
} jump;

static int jump_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const jump *j = (const jump *)ctx;
    (void)y;
    dydt[0] = j->from <= t && t < j->to ? j->slope : 0;
    return 0;
}

static vm_real time_of_jump(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    return t - ((const jump *)ctx)->from;
}

/* From t0, y = 0, to t_end, without and with an event at the jump. Where missed is not negative it is what s.missed has to
   be. */
static void check_jump(int order, jump j, vm_real t0, vm_real t_end, rk45_options o, long missed, double wanted)
{
    const double allowed = 10 * (double)o.h_min + (is_float ? 1e-2 : 1e-4); /* 100 tolerances: the estimate is not
                                                                              right where f jumps */
    vm_real y0[1] = {0}, work[RK87_WORK(1)];
    ode_event event;
    rk45 s;
    memset(&event, 0, sizeof event);
    event.g = time_of_jump;
    event.ctx = &j;
    o.events = &event;
    for (o.n_events = 0; o.n_events < 2; o.n_events++) {
        CHECK((order == 5 ? rk45_init : rk87_init)(&s, jump_rhs, &j, 1, t0, y0, &o, work) == ODE_OK);
        CHECK((order == 5 ? rk45_solve(&s, t_end) : rk87_solve(&s, t_end)) == ODE_OK && s.t == t_end);
        CHECK(missed < 0 || s.missed == missed);
        CHECK(event.count == o.n_events);
        check_error("jump of f", order == 5 ? "rk45" : "rk87", "1",
                    fabs((double)s.y[0] / (double)j.slope - wanted) / allowed, 1, (double)j.from, (double)j.slope);
    }
}

/* A jump of f that no step can resolve to the tolerance does not end a run. */
static void test_unresolvable_jumps(void)
{
    const vm_real huge = VM_MAX / R(1e6), later = R(1.3);
    rk45_options fine = {0}, relative = {0}, coarse = {0};
    int order;
    fine.atol = VM_EPSILON;
    relative.atol = -1;
    coarse.h_min = R(0.01);
    for (order = 5; order <= 8; order += 3) {
        jump at_0 = {0, 100, 1}, at_1 = {1, 100, 1};
        at_0.slope = huge;
        check_jump(order, at_0, -1, 1, fine, is_float ? -1 : 1, 1);
        at_1.slope = huge;
        check_jump(order, at_1, 0, 2, fine, 1, 1);
        at_1.to = later; /* and back; h_max, for a step could pass over all of it */
        fine.h_max = R(0.1);
        check_jump(order, at_1, 0, 2, fine, -1, 0.3);
        fine.h_max = 0;
        at_1.slope = -1000;
        at_1.to = 100;
        check_jump(order, at_1, 0, 2, fine, 1, 1);
        at_1.slope = 1;
        check_jump(order, at_1, 0, 2, relative, 1, 1);
        check_jump(order, at_1, 2, 0, relative, -1, -1); /* from t = 2, backward */
        check_jump(order, at_1, 0, 2, coarse, 1, 1);
    }
}

/* Steps of h_min that keep the tolerance are good, also where the next step should be a little shorter than h_min */
static void test_least_step(void)
{
    vm_real y0[3] = {1, 0, 1}, work[RK45_WORK(3)];
    rk45_options o = {0};
    rk45 s;
    if (is_float) return;
    o.h_min = R(0.18);
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 20) == ODE_OK);
    CHECK(s.missed == 0);
    check_error("h_min", "0.18", "tol", fabs((double)s.y[0] - cos(20.)) / 1e-6, 20, 20, 0);
}

/* y' is 1 up to y = 1/2, and *ctx beyond */
static int threshold_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = y[0] > R(0.5) ? *(const vm_real *)ctx : R(1.0);
    return 0;
}

/* A jump where the state passes a threshold: the step that meets it does not throw the state back, however large the
   jump is and however coarse the time. rk87 ended at -7.9 with success for a jump to 1e12 at t0 = 1000. */
static void test_thresholds(void)
{
    static const double jumps[] = {10, 1e3, 1e6, 1e12}, starts[] = {1, 100, 1e4};
    int order, j, k;
    for (order = 5; order <= 8; order += 3)
        for (j = 0; j < 4; j++)
            for (k = 0; k < 3; k++) {
                const double wanted = 0.5 + 1.6 * jumps[j];
                vm_real start = R(0.1), work[RK87_WORK(1)], slope = R(jumps[j]), t0 = R(starts[k]);
                int status;
                rk45 s;
                status = (order == 5 ? rk45_init : rk87_init)(&s, threshold_rhs, &slope, 1, t0, &start, NULL, work);
                CHECK(status == ODE_OK);
                CHECK((order == 5 ? rk45_solve(&s, t0 + 2) : rk87_solve(&s, t0 + 2)) == ODE_OK && s.missed <= 1);
                check_error("threshold", order == 5 ? "rk45" : "rk87", "rel", fabs((double)s.y[0] / wanted - 1),
                            is_float ? 2e-3 : 1e-5, jumps[j], starts[k]);
            }
}

/* Where f is singular, or too stiff for t, a run ends, with the state before the two steps that missed the tolerance; and
   calls again do not get on. */
static void test_unresolvable_points(void)
{
    vm_real start = 1, work[RK87_WORK(1)], rate = 100 / VM_EPSILON;
    int order, k;
    for (order = 5; order <= 8; order += 3) {
        rk45 s;
        int status;
        CHECK((order == 5 ? rk45_init : rk87_init)(&s, stiff_rhs, &rate, 1, 1, &start, NULL, work) == ODE_OK);
        for (k = 0; k < 20; k++) {
            status = order == 5 ? rk45_solve(&s, 2) : rk87_solve(&s, 2);
            CHECK(status == ODE_STEP_TOO_SMALL || status == ODE_NOT_FINITE);
        }
        CHECK(s.y[0] == 1 && s.t == 1 && s.steps == 0 && s.missed == 0);
        CHECK((order == 5 ? rk45_init : rk87_init)(&s, blow_up_rhs, NULL, 1, 0, &start, NULL, work) == ODE_OK);
        status = order == 5 ? rk45_solve(&s, 2) : rk87_solve(&s, 2);
        CHECK(status == ODE_STEP_TOO_SMALL || status == ODE_NOT_FINITE);
        CHECK(fabs((double)s.t - 1) < (is_float ? 1e-4 : 1e-5) && s.missed == 0);
        CHECK(s.y[0] > R(0.01) / VM_EPSILON && s.y[0] < 1 / VM_EPSILON);
    }
}

/* ---- long runs, standard problems, proportionality ---- */

static int cubic_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

static int rigid_body_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* moments 1, 2, 3 */
{
    (void)t;
    (void)ctx;
    dydt[0] = -y[1] * y[2];
    dydt[1] = y[2] * y[0];
    dydt[2] = -y[0] * y[1] / 3;
    return 0;
}

static int varying_mass_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -(y[0] * y[0] * y[0] + R(0.1) * y[1]) / (1 + R(0.1) * t);
    return 0;
}

/* y at t_end by either method; the largest difference to wanted */
static double run(int order, ode_rhs f, void *ctx, int n, const vm_real *y0, double t_end, double tol,
                  const double *wanted, long *evals)
{
    vm_real work[RK87_WORK(4)];
    rk45_options o = {0};
    double error = 0;
    rk45 s;
    int i;
    o.rtol = o.atol = R(tol);
    o.max_steps = -1;
    CHECK((order == 5 ? rk45_init : rk87_init)(&s, f, ctx, n, 0, y0, &o, work) == ODE_OK);
    CHECK((order == 5 ? rk45_solve(&s, R(t_end)) : rk87_solve(&s, R(t_end))) == ODE_OK && s.t == R(t_end));
    for (i = 0; i < n; i++) error = fmax(error, fabs((double)s.y[i] - wanted[i]));
    *evals = s.evals;
    return error;
}

/* The ends in the table that have closed forms: A1 to A4, and D1 to D5 by Kepler's equation, to the roundings of their
   first values and of 20 radians */
static void test_detest_ends(void)
{
    const double closed[4] = {exp(-20.), 1 / sqrt(21.), exp(sin(20.)), 20 / (1 + 19 * exp(-5.))};
    const double *orbit = detest_ends;
    int k, i;
    for (k = 0; k < 4; k++)
        check_error("DETEST, the ends", "A", "eps", fabs(detest_ends[k] / closed[k] - 1) / DBL_EPSILON, 4, k + 1, 0);
    for (k = 0; k < 15; k++) orbit += detest_problems[k].n;
    for (k = 1; k <= 5; k++, orbit += 4) {
        const double e = 0.2 * k - 0.1, side = sqrt(1 - e * e);
        double E = 20, wanted[4];
        for (i = 0; i < 50; i++) E -= (E - e * sin(E) - 20) / (1 - e * cos(E));
        wanted[0] = cos(E) - e;
        wanted[1] = side * sin(E);
        wanted[2] = -sin(E) / (1 - e * cos(E));
        wanted[3] = side * cos(E) / (1 - e * cos(E));
        for (i = 0; i < 4; i++)
            check_error("DETEST, the ends", "D", "eps", fabs(orbit[i] - wanted[i]) / DBL_EPSILON, 250, e, i);
    }
}

/* The error of a problem of DETEST at t = 20, in tolerances of a step */
static double detest_error(const detest_problem *p, const double *y_end, int order, double tol, long *evals)
{
    double start[DETEST_LARGEST], error = 0;
    vm_real y0[DETEST_LARGEST], work[RK87_WORK(DETEST_LARGEST)];
    rk45_options o = {0};
    rk45 s;
    int i;
    detest_start(p, start);
    for (i = 0; i < p->n; i++) y0[i] = R(start[i]);
    o.rtol = o.atol = R(tol);
    CHECK((order == 5 ? rk45_init : rk87_init)(&s, p->f, NULL, p->n, 0, y0, &o, work) == ODE_OK);
    CHECK((order == 5 ? rk45_solve(&s, R(detest_t_end)) : rk87_solve(&s, R(detest_t_end))) == ODE_OK);
    for (i = 0; i < p->n; i++) error = fmax(error, fabs((double)s.y[i] - y_end[i]) / (tol * (1 + fabs(y_end[i]))));
    *evals += s.evals;
    return error;
}

/* DETEST's smooth problems. The problems of a class differ much, and so do tolerances: bounds are twice what was measured
   when the errors were last looked at. */
static void test_detest(void)
{
    static const char *const names[2][5] = {{"A, rk45", "B, rk45", "C, rk45", "D, rk45", "E, rk45"},
                                            {"A, rk87", "B, rk87", "C, rk87", "D, rk87", "E, rk87"}};
    static const double bounds[2][2][5] = {{{6, 18, 3, 150, 26}, {4, 11, 0.3, 20, 9}},
                                           {{5, 130, 4, 550, 100}, {1.1, 25, 0.3, 90, 20}}};
    int order, k, i;
    for (order = 5; order <= 8; order += 3) {
        const double *y_end = detest_ends;
        long evals = 0;
        for (k = 0; k < 25; k++) {
            const detest_problem *p = detest_problems + k;
            for (i = 0; i < (is_float ? 1 : 3); i++) {
                const double tol = is_float ? 1e-4 : pow(10, -6 - 3 * i);
                check_error("DETEST", names[order == 8][k / 5], "tol", detest_error(p, y_end, order, tol, &evals),
                            bounds[is_float][order == 8][k / 5], tol, k % 5 + 1);
            }
            y_end += p->n;
        }
        printf("DETEST A to E, order %d: %ld evaluations\n", order, evals);
    }
}

/* DETEST's class F, whose right-hand sides jump, or their slopes do: the geometric mean of the errors over the tolerances.
   rk87 had 2e4 at F1 and 2e3 at F5, before its error estimate saw jumps between its stages at c = 0 and 0.9. */
static void test_detest_jumps(void)
{
    static const char *const names[2][5] = {{"F1, rk45", "F2, rk45", "F3, rk45", "F4, rk45", "F5, rk45"},
                                            {"F1, rk87", "F2, rk87", "F3, rk87", "F4, rk87", "F5, rk87"}};
    static const double bounds[2][5] = {{1000, 15, 200, 1, 600}, {300, 5, 250, 1, 300}};
    int order, k, digits;
    if (is_float) return;
    for (order = 5; order <= 8; order += 3) {
        const double *y_end = detest_ends + (sizeof detest_ends / sizeof *detest_ends) - 7;
        for (k = 25; k < DETEST_PROBLEMS; k++) {
            double sum = 0;
            long evals = 0;
            for (digits = 3; digits <= 13; digits++)
                sum += log(detest_error(detest_problems + k, y_end, order, pow(10, -digits), &evals));
            check_error("DETEST", names[order == 8][k - 25], "tol", exp(sum / 11), bounds[order == 8][k - 25], 20, 0);
            y_end += detest_problems[k].n;
        }
    }
}

static int sign_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = R(y[0] > 0 ? -1 : y[0] < 0);
    return 0;
}

/* x'' = -sign x over ten periods, at tolerances from 1e-4 to 1e-12: the geometric mean of the errors, in tolerances.
   rk87 had 2e5. */
static void test_sign(void)
{
    const double ten_periods = 40 * sqrt(2.);
    int order, digits;
    if (is_float) return;
    for (order = 5; order <= 8; order += 3) {
        double sum = 0;
        for (digits = 4; digits <= 12; digits++) {
            static const vm_real y0[2] = {1, 0};
            const double tol = pow(10, -digits), wanted[2] = {1, 0};
            long evals;
            sum += log(run(order, sign_rhs, NULL, 2, y0, ten_periods, tol, wanted, &evals) / tol);
        }
        check_error("x'' = -sign x", order == 5 ? "rk45" : "rk87", "tol", exp(sum / 9), order == 5 ? 10000 : 2500, 0, 0);
    }
}

/* cn over 20 and 2000 periods; 22 digits by the pair of order 8 in quadruple precision for the others */
static void test_long_runs(void)
{
    const double period = 7.416298709205487673735401388781;
    static const double cubic_at_100[2] = {-0.9928219270246553026, -0.1191734455528570027},
                        varying_mass_at_50[2] = {-0.2102254653258942060, -0.1578403286848444388},
                        rigid_body_at_60[3] = {-0.8416044062440098099, -0.5492740876745121888,
                                               0.8442546962872701759},
                        start[2] = {1, 0};
    static const vm_real oscillator_y0[2] = {1, 0}, body_y0[3] = {1, R(0.1), R(0.9)};
    int order;
    for (order = 5; order <= 8; order += 3) {
        const char *name = order == 5 ? "rk45" : "rk87";
        double tol, error[2][3], last = 0;
        long evals = 0;
        int k = 0, few = is_float ? 2 : order == 5 ? 40 : 20;
        if (!is_float) {
            tol = order == 5 ? 1e-10 : 1e-12;
            check_error("cn, 20 periods", name, "tol",
                        run(order, cubic_rhs, NULL, 2, oscillator_y0, 20 * period, tol, start, &evals) / tol,
                        order == 5 ? 600 : 120, 20, tol);
            check_error("cn, 2000", name, "tol",
                        run(order, cubic_rhs, NULL, 2, oscillator_y0, 2000 * period, tol, start, &evals) / tol,
                        order == 5 ? 6e6 : 1e6, 2000, tol);
        }
        for (tol = is_float ? 1e-3 : 1e-5; tol > (is_float ? (order == 5 ? 5e-6 : 5e-4) : 1e-10); tol /= 100, k++) {
            error[k % 2][0] = run(order, cubic_rhs, NULL, 2, oscillator_y0, 100, tol, cubic_at_100, &evals);
            error[k % 2][1] = run(order, varying_mass_rhs, NULL, 2, oscillator_y0, 50, tol, varying_mass_at_50,
                                  &evals);
            error[k % 2][2] = run(order, rigid_body_rhs, NULL, 3, body_y0, 60, tol, rigid_body_at_60, &evals);
            check_error("x'' = -x^3", name, "tol", error[k % 2][0] / tol,
                        order == 5 ? 2000
                        : is_float ? 2000
                                   : 100,
                        100, tol);
            check_error("varying mass", name, "tol", error[k % 2][1] / tol,
                        order == 5 ? 80
                        : is_float ? 150
                                   : 20,
                        50, tol);
            check_error("rigid body", name, "tol", error[k % 2][2] / tol,
                        order == 5 ? 600
                        : is_float ? 200
                                   : 30, /* rk87 at 1e-5 has 18, by 697 evaluations; neighbouring tolerances 2 to 4 */
                        60, tol);
            if (k) { /* 100 times the tolerance: 100^(1/order) times the steps, and about 100 times the error */
                int i;
                CHECK(fabs(log((double)evals / last) / log(100.) * order - 1) < 0.35);
                for (i = 0; i < 3; i++) CHECK(error[(k + 1) % 2][i] > few / 2 * error[k % 2][i] || is_float);
            }
            last = (double)evals;
        }
    }
}

/* Energy over 1e6 steps of rk4: with compensation the roundings do not add up */
static void test_compensated(void)
{
    double energy[2], h = is_float ? 1. / 512 : 1. / 4096;
    int k;
    for (k = 0; k < 2; k++) {
        vm_real y[2] = {1, 0}, low[2] = {0, 0}, work[RK4_WORK(2)], t = 0, t_end = R(1e6 * h);
        CHECK((k ? rk4_solve_compensated(cubic_rhs, NULL, 2, &t, t_end, 1000000, y, low, work)
                 : rk4_solve(cubic_rhs, NULL, 2, &t, t_end, 1000000, y, work)) == ODE_OK &&
              t == t_end);
        energy[k] = fabs((double)y[1] * (double)y[1] / 2 + pow((double)y[0], 4) / 4 - 0.25) / 0.25;
    }
    printf("energy after 1e6 steps of rk4: off by %.1e, compensated %.1e\n", energy[0], energy[1]);
    CHECK(energy[1] < 4 * eps && energy[0] > 20 * energy[1] && energy[0] < 2000 * eps);
    {
        vm_real y[1] = {1}, work[RK4_WORK(1)], t = 0, low[1] = {0};
        CHECK(rk4_solve_compensated(time_rhs, NULL, 1, &t, 1, 10, y, NULL, work) == ODE_BAD_ARGUMENT && y[0] == 1);
        CHECK(rk4_solve_compensated(time_rhs, NULL, 1, &t, 1, 0, y, low, work) == ODE_BAD_ARGUMENT && t == 0);
    }
}

static int relaxation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    dydt[0] = -*(const vm_real *)ctx * (y[0] - VM_LIBM(cos)(t));
    return 0;
}

static int slow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* an oscillator */
{
    const vm_real rate = *(const vm_real *)ctx;
    (void)t;
    dydt[0] = rate * y[1];
    dydt[1] = -rate * y[0];
    return 0;
}

/* No oscillator is stiff, however long its period */
static void test_long_periods(void)
{
    const vm_real longest = VM_MAX / R(1e6);
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)], length, rate;
    rk45_options o = {0};
    rk45 s;
    o.rtol = o.atol = R(is_float ? 1e-4 : 1e-9);
    for (length = 1 / longest; length < longest / R(1e4); length *= R(1e4)) {
        rate = 1 / length;
        CHECK(rk45_init(&s, slow_rhs, &rate, 2, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 300 * length) == ODE_OK);
        CHECK(rk87_init(&s, slow_rhs, &rate, 2, 0, y0, &o, work) == ODE_OK && rk87_solve(&s, 300 * length) == ODE_OK);
        CHECK(s.steps > 100); /* so that the run is looked at */
    }
}

/* The warning comes where stability limits the step, and only there; the run goes on */
static void test_stiffness(void)
{
    vm_real y0[1] = {0}, work[RK87_WORK(1)], rate = 1000;
    rk45_options o = {0};
    rk45 s;
    o.rtol = o.atol = R(1e-3);
    CHECK(rk45_init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 5) == ODE_STIFF &&
          s.t == 5);
    CHECK(s.stiff && fabs((double)s.y[0] - cos(5.)) < 0.01 && rk45_solve(&s, 6) == ODE_OK && ODE_STIFF > 0);
    CHECK(rk87_init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk87_solve(&s, 5) == ODE_STIFF &&
          s.t == 5);
    CHECK(s.stiff && fabs((double)s.y[0] - cos(5.)) < 0.01 && rk87_solve(&s, 6) == ODE_OK);
    rate = 1;
    o.max_steps = -1;
    CHECK(rk45_init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 1000) == ODE_OK &&
          !s.stiff);
    CHECK(rk87_init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk87_solve(&s, 1000) == ODE_OK &&
          !s.stiff);
}

static void test_power(void)
{
    double x, p, worst = 0;
    for (x = 1e-30; x < 1e20; x *= 1.3)
        for (p = -0.2; p < 0.21; p += 0.04) {
            double wanted = pow(x, p);
            if (wanted > 0.1 && wanted < 10) worst = fmax(worst, fabs((double)vmi_pow_rough(R(x), R(p)) / wanted - 1));
        }
    check_error("step-size root", "0.1 .. 10", "1", worst, 0.016, 0, 0);
}

/* ---- how runs end ---- */

static void test_refusals(void)
{
    vm_real y0[2] = {1, 0}, bad[2], work[RK45_WORK(2)], t = 0, y[2] = {1, 0};
    rk45_options o = {0};
    rk45 s, before;
    memset(&s, 5, sizeof s);
    before = s;
    bad[0] = 1;
    bad[1] = VM_NAN;
#define REFUSED(call) CHECK((call) == ODE_BAD_ARGUMENT && memcmp(&s, &before, sizeof s) == 0)
    REFUSED(rk45_init(&s, linear_rhs, NULL, 0, 0, y0, NULL, work));
    REFUSED(rk45_init(&s, linear_rhs, NULL, -3, 0, y0, NULL, work));
    REFUSED(rk45_init(&s, NULL, NULL, 2, 0, y0, NULL, work));
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, NULL, NULL, work));
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, NULL, NULL));
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, bad, NULL, work));
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, VM_INFINITY, y0, NULL, work));
    o.rtol = o.atol = -1;
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.rtol = o.atol = 0;
    o.h_max = -1;
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.h_max = 0;
    o.h0 = VM_NAN;
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.h0 = 0;
    o.rtol = VM_NAN;
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.h0 = o.rtol = 0;
    o.h_min = R(-1e-3);
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.h_min = 0;
    o.atol_each = bad; /* 1, NaN */
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    bad[1] = -1;
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    bad[1] = 1;
    o.h_min = 1;
    o.h_max = R(0.5);
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.h_min = o.h_max = 0;
    o.atol_each = NULL;
    o.atol = VM_INFINITY;
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    o.atol = 0;
    o.atol_each = bad;
    bad[1] = 0;
    o.rtol = -1; /* no tolerance for one component */
    REFUSED(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, &o, work));
    CHECK(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, NULL, work) == ODE_OK);
    CHECK(rk45_interpolate(&s, VM_EPSILON * VM_EPSILON, y) == ODE_BAD_ARGUMENT &&
          rk45_interpolate(&s, 0, y) == ODE_OK);
    CHECK(rk45_solve(NULL, 1) == ODE_BAD_ARGUMENT && rk45_step(NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk87_solve(NULL, 1) == ODE_BAD_ARGUMENT && rk87_step(NULL) == ODE_BAD_ARGUMENT);
    before = s; /* the other method's, and another f or n than the one it was made for */
    REFUSED(rk87_solve(&s, 1));
    REFUSED(rk87_step(&s));
    REFUSED(rk87_interpolate(&s, 0, y));
    REFUSED(rk45_solve_with(&s, time_rhs, 2, 1));
    REFUSED(rk45_solve_with(&s, linear_rhs, 3, 1));
    REFUSED(rk45_solve(&s, VM_NAN));
    CHECK(rk4_step(time_rhs, NULL, 0, 0, 1, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(time_rhs, NULL, 1, &t, 1, 0, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(time_rhs, NULL, 1, &t, VM_INFINITY, 10, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(NULL, NULL, 1, &t, 1, 10, y, work) == ODE_BAD_ARGUMENT && t == 0 && y[0] == 1);
}

/* Each component has its own tolerance: a loose one for all that moves makes longer steps than a tight one. */
static void test_atol_each(void)
{
    vm_real y0[3] = {1, 0, 0}, work[RK45_WORK(3)], loose[3] = {R(1e-2), R(1e-2), R(1e-5)},
            tight[3] = {R(1e-5), R(1e-5), R(1e-5)};
    rk45_options o = {0};
    rk45 s;
    long evals;
    o.rtol = -1;
    o.atol_each = loose;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 30) == ODE_OK);
    evals = s.evals;
    o.atol_each = tight;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 30) == ODE_OK &&
          s.evals > 2 * evals);
    loose[0] = R(1e-5);
    loose[1] = 1;
    loose[2] = 1;
    o.atol_each = loose;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 30) == ODE_OK &&
          s.evals > 2 * evals);
}

static void test_tolerances(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)], each[1] = {R(1e-3)};
    rk45_options o = rk45_defaults(NULL);
    rk45 s;
    CHECK(o.rtol == (is_float ? R(1e-4) : R(1e-6)) && fabs((double)(o.atol / o.rtol) - 1e-3) < 1e-9 &&
          o.max_steps > 0 && o.h_max > 0);
    o.rtol = R(eps); /* below what the type holds: raised, said, and reached */
    o.atol = -1;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_RTOL_RAISED && ODE_RTOL_RAISED > 0);
    CHECK(s.options.rtol == 16 * VM_EPSILON && s.options.atol == 0);
    {
        vm_real work8[RK87_WORK(1)];
        rk87 s8;
        CHECK(rk87_init(&s8, time_rhs, NULL, 1, 0, y0, &o, work8) == ODE_RTOL_RAISED);
        CHECK(s8.options.rtol == 256 * VM_EPSILON && rk87_solve(&s8, 2) == ODE_OK);
        check_error("rk87, least", "y = exp(t^2)", "eps", fabs((double)s8.y[0] / exp(4.) - 1) / eps, 1000, 2, 0);
    }
    CHECK(rk45_solve(&s, 2) == ODE_OK);
    check_error("rtol = eps", "y = exp(t^2)", "eps", fabs((double)s.y[0] / exp(4.) - 1) / eps, 110, 2, 0);
    o.rtol = -1;
    o.atol = 0;
    o.atol_each = each;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    check_error("atol_each", "y = exp(t^2)", "tol", fabs((double)s.y[0] - exp(1.)) / 1e-3, 5, 1, 0);
    test_atol_each();
}

static void test_endings(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)], y[1], at, wanted;
    rk45_options o = {0};
    wall w = {1, 0, 0};
    rk45 s, again;
    int k;
    for (k = 0; k < 2; k++) { /* f refuses, or is NaN, from t = 1 on */
        w.use_nan = k;
        CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK);
        CHECK(rk45_solve(&s, 5) == (k ? ODE_NOT_FINITE : ODE_RHS_STOPPED));
        CHECK(s.t < 1 && s.rhs_status == (k ? 0 : 7));
        check_error("y before the end", "f stops", "tol",
                    fabs((double)s.y[0] * exp((double)s.t) - 1) / (is_float ? 1e-4 : 1e-6), 0.3, (double)s.t, k);
        if (k) CHECK((double)s.t > 1 - 100 * eps); /* shortened up to the end of f */
        at = 0;
        y[0] = 1;
        CHECK(rk4_solve(wall_rhs, &w, 1, &at, 2, 20, y, work) == (k ? ODE_NOT_FINITE : ODE_RHS_STOPPED));
        check_error("y before the end", "f stops, rk4", "1e-6", 1e6 * fabs((double)y[0] * exp((double)at) - 1), 2,
                    (double)at, k);
        CHECK(fabs((double)at - 0.9) < 1e-6);
    }
    w.at = -1; /* at once: NaN, then a refusal; and a refusal at the probe of the first step, and within a step */
    CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK && rk45_step(&s) == ODE_NOT_FINITE);
    CHECK(s.t == 0 && s.y[0] == 1 && s.steps == 0);
    w.use_nan = 0;
    CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK && rk45_step(&s) == ODE_RHS_STOPPED);
    w.at = R(1e-12);
    CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK && rk45_step(&s) == ODE_RHS_STOPPED);
    for (w.at = R(0.001); w.at < R(0.1); w.at += R(0.004)) {
        o.h0 = R(0.1);
        CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, &o, work) == ODE_OK && rk45_step(&s) == ODE_RHS_STOPPED &&
              s.t == 0);
    }
    o.h0 = 0;

    CHECK(rk45_init(&s, blow_up_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
    k = rk45_solve(&s, 2);
    CHECK((k == ODE_STEP_TOO_SMALL || k == ODE_NOT_FINITE) && fabs((double)s.t - 1) < (is_float ? 1e-2 : 1e-5));
    o.h_min = R(0.01);
    CHECK(rk45_init(&s, blow_up_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK &&
          rk45_solve(&s, 2) == ODE_STEP_TOO_SMALL && s.t < 1);

    o.h_min = 0;
    o.max_steps = 3; /* interrupted and continued: the same bits as in one go */
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK);
    for (k = 0; k < 1000 && rk45_solve(&s, 2) == ODE_MAX_STEPS; k++) continue;
    wanted = s.y[0];
    CHECK(s.t == 2 && k > 0 && rk45_solve(&s, 2) == ODE_OK);
    o.max_steps = -1;
    CHECK(rk45_init(&again, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&again, 2) == ODE_OK);
    CHECK(again.y[0] == wanted && again.steps == s.steps && again.evals == s.evals);

    CHECK(rk45_init(&s, time_rhs, NULL, 1, 2, &wanted, NULL, work) == ODE_OK);
    CHECK(rk45_solve(&s, 2) == ODE_OK && s.evals == 0); /* t_end = t succeeds at once */
    o.h0 = R(-0.01);                                    /* rk45_step backward */
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 2, &wanted, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK && s.t < 2);
    CHECK(strcmp(ode_strerror(ODE_MAX_STEPS), ode_strerror(-99)) != 0);
}

/* Two runs at once do not disturb each other. */
static void test_reentrancy(void)
{
    vm_real y0[1] = {1}, work[2][RK45_WORK(1)], alone;
    rk45 a, b;
    rk45_init(&a, time_rhs, NULL, 1, 0, y0, NULL, work[0]);
    CHECK(rk45_solve(&a, 1) == ODE_OK);
    alone = a.y[0];
    rk45_init(&a, time_rhs, NULL, 1, 0, y0, NULL, work[0]);
    rk45_init(&b, blow_up_rhs, NULL, 1, 0, y0, NULL, work[1]);
    a.options.max_steps = 1;
    while (rk45_solve(&a, 1) == ODE_MAX_STEPS) rk45_step(&b);
    CHECK(a.y[0] == alone);
}

int main(void)
{
    test_orders();
    test_known_solutions();
    test_interpolation();
    test_control();
    test_detest_ends();
    test_detest();
    test_detest_jumps();
    test_sign();
    test_long_runs();
    test_compensated();
    test_stiffness();
    test_long_periods();
    test_power();
    test_unresolvable();
    test_clock();
    test_work_size();
    test_unresolvable_jumps();
    test_least_step();
    test_unresolvable_points();
    test_thresholds();
    test_refusals();
    test_tolerances();
    test_endings();
    test_reentrancy();
    return check_finish("integrators.h");
}
