/* integrators.h: dense output. rk45_interpolate and rk87_interpolate within the last step, forward and backward,
   after a restart and where they are refused: the measured order and the error, against closed forms. */
#include "integrator_check.h"

/* ---- Order ---- */

/* The error in the middle of the last step to t_end, with steps of size h: the tolerance is so large that none is
   rejected. The seven evaluations that rk87 needs for it are made once for a step. */
static double error_inside(const method *m, double h, double t_end)
{
    vm_real y0[3] = {1, 0, 1}, y[3], work[RK87_WORK(3)];
    rk45_options o = {0};
    const long extra = m->order == 8 ? 7 : 0;
    rk45 s;
    double t;
    o.atol = 1000;
    o.h0 = o.h_max = R(h);
    CHECK(m->init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, R(t_end)) == ODE_OK && s.rejected == 0);
    t = ((double)s.t_old + (double)s.t) / 2;
    CHECK(m->interpolate(&s, R(t), y) == ODE_OK && s.evals == m->stages * s.steps + 1 + extra);
    CHECK(m->interpolate(&s, s.t_old, y0) == ODE_OK && s.evals == m->stages * s.steps + 1 + extra);
    return linear_error(y, t);
}

static void test_orders(void)
{
    if (is_float) return; /* in float rounding hides them */
    check_order("rk45_interpolate (local error)",
                log2(error_inside(methods, 0.125, 2) / error_inside(methods, 0.0625, 2)), 5, 0.5);
    check_order("rk87_interpolate (local error)",
                log2(error_inside(methods + 1, 1, 4) / error_inside(methods + 1, 0.5, 4)), 9, 0.7);
}

/* ---- Errors ---- */

/* In float rk87 cannot have less than 256 eps. */
static double tolerance_of(const method *m)
{
    if (!is_float) return 1e-9;
    return m->order == 5 ? 1e-5 : 1e-4;
}

/* Of a solution of y' = 2 t y that is 1 at the time start */
static double relative_error(vm_real y, double t, double start)
{
    return fabs((double)y / exp(t * t - start * start) - 1);
}

/* Nine points of each step of y' = 2 t y from t = -2, forward */
static void test_every_step(void)
{
    int k;
    for (k = 0; k < METHODS; k++) {
        const method *m = methods + k;
        vm_real y0[1] = {1}, work[RK87_WORK(1)], y;
        const double tol = tolerance_of(m);
        rk45_options o = {0};
        rk45 s;
        o.rtol = R(tol);
        o.atol = -1;
        CHECK(m->init(&s, time_rhs, NULL, 1, -2, y0, &o, work) == ODE_OK);
        while (s.t < 1) {
            double x;
            CHECK(m->step(&s) == ODE_OK);
            for (x = 0; x <= 1; x += 0.125) {
                const double t = (double)R((double)s.t_old + x * (double)(s.t - s.t_old));
                CHECK(m->interpolate(&s, R(t), &y) == ODE_OK);
                check_error(m->name, "y = exp(t^2)", "tol", relative_error(y, t, 2) / tol, 30, t, tol);
            }
        }
        CHECK(m->interpolate(&s, s.t, &y) == ODE_OK && y == s.y[0]);
    }
}

/* The middle of the last step of a run backward, relative to its end */
static void test_backward(void)
{
    int k;
    for (k = 0; k < METHODS; k++) {
        const method *m = methods + k;
        vm_real y0[1] = {3}, work[RK87_WORK(1)], y, middle;
        const double tol = tolerance_of(m);
        rk45_options o = {0};
        rk45 s;
        o.rtol = R(tol);
        o.atol = -1;
        CHECK(m->init(&s, time_rhs, NULL, 1, R(0.75), y0, &o, work) == ODE_OK);
        CHECK(m->solve(&s, R(-0.5)) == ODE_OK && s.t_old > s.t);
        middle = s.t + (s.t_old - s.t) / 2;
        CHECK(m->interpolate(&s, middle, &y) == ODE_OK && m->interpolate(&s, s.t - 1, y0) == ODE_BAD_ARGUMENT);
        check_error(m->name, "backward", "tol",
                    relative_error(y / s.y[0], (double)middle, (double)s.t) / tol, 30, (double)middle, tol);
    }
}

/* ---- Refusals and restarts ---- */

/* Times outside the last step are refused, and the result is left as it is. */
static void test_refusals(void)
{
    int k;
    for (k = 0; k < METHODS; k++) {
        const method *m = methods + k;
        vm_real y0[1] = {1}, work[RK87_WORK(1)], y = 5;
        rk45 s;
        CHECK(m->init(&s, time_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
        CHECK(m->interpolate(&s, VM_EPSILON * VM_EPSILON, &y) == ODE_BAD_ARGUMENT); /* no step has been made */
        CHECK(y == 5 && m->interpolate(&s, 0, &y) == ODE_OK && y == 1);
        CHECK(m->solve(&s, 1) == ODE_OK);
        CHECK(m->interpolate(&s, s.t + 1, &y) == ODE_BAD_ARGUMENT && y == 1);
        CHECK(m->interpolate(&s, s.t_old - 1, &y) == ODE_BAD_ARGUMENT && y == 1);
        CHECK(m->interpolate(&s, VM_NAN, &y) == ODE_BAD_ARGUMENT && y == 1);
        CHECK(methods[1 - k].interpolate(&s, s.t, &y) == ODE_BAD_ARGUMENT && y == 1); /* the other method's */
    }
}

static void test_restart(void)
{
    int k;
    for (k = 0; k < METHODS; k++) {
        const method *m = methods + k;
        vm_real y0[1] = {1}, work[RK87_WORK(1)], y, end;
        rk45 s;
        CHECK(m->init(&s, time_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK && m->solve(&s, 1) == ODE_OK);
        end = s.y[0];
        y = VM_NAN;
        CHECK(m->restart(&s, 0, &y) == ODE_BAD_ARGUMENT && m->restart(NULL, 0, &y) == ODE_BAD_ARGUMENT);
        CHECK(m->restart(&s, VM_NAN, &end) == ODE_BAD_ARGUMENT && m->restart(&s, 0, NULL) == ODE_BAD_ARGUMENT);
        CHECK(s.t == 1 && s.y[0] == end);
        y = 2;
        CHECK(m->restart(&s, s.t, &y) == ODE_OK && s.y[0] == 2 && s.t_old == s.t);
        CHECK(m->step(&s) == ODE_OK && s.y[0] > 2 && m->interpolate(&s, s.t_old, &y) == ODE_OK && y == 2);
    }
}

/* The first step after a restart is that of a run that starts there with the same step size. */
static void test_restart_is_a_start(void)
{
    int k;
    for (k = 0; k < METHODS; k++) {
        const method *m = methods + k;
        vm_real y0[1] = {1}, start = 3, work[RK87_WORK(1)], other_work[RK87_WORK(1)];
        rk45_options o = {0};
        rk45 s, fresh;
        CHECK(m->init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 1) == ODE_OK);
        CHECK(m->restart(&s, R(0.5), &start) == ODE_OK);
        o.h0 = s.h;
        CHECK(m->init(&fresh, time_rhs, NULL, 1, R(0.5), &start, &o, other_work) == ODE_OK);
        CHECK(m->step(&s) == ODE_OK && m->step(&fresh) == ODE_OK && s.t == fresh.t && s.y[0] == fresh.y[0]);
    }
}

/* Listed times, rising or falling, with equal ones, the start and the end among them: the rows are the solution, and
   the steps are those of a run without the list. */
static void test_listed_times(const method *m, double direction)
{
    enum { TIMES = 60 };
    const vm_real y0[3] = {1, 0, 1};
    vm_real times[TIMES], rows[TIMES][3], work[RK87_WORK(3)], other_work[RK87_WORK(3)];
    rk45_options o;
    rk45 s, plain;
    int i, done = -1;
    memset(&o, 0, sizeof o);
    o.rtol = o.atol = R(is_float ? 1e-5 : 1e-9);
    for (i = 0; i < TIMES; i++) times[i] = R(direction * floor(i / 2) * 2.6 / 29);
    CHECK(m->init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) >= 0);
    CHECK(m->init(&plain, linear_rhs, NULL, 3, 0, y0, &o, other_work) >= 0);
    CHECK(m->solve_at(&s, TIMES, times, rows[0], &done) == ODE_OK && done == TIMES);
    CHECK(m->solve(&plain, times[TIMES - 1]) == ODE_OK && plain.steps == s.steps);
    CHECK(s.t == times[TIMES - 1] && !memcmp(rows[TIMES - 1], s.y, sizeof rows[0]));
    CHECK(!memcmp(plain.y, s.y, sizeof rows[0]) && !memcmp(rows[0], y0, sizeof y0));
    for (i = 0; i < TIMES; i++)
        check_error(m->name, "listed times", "tol", linear_error(rows[i], (double)times[i]) / (double)o.rtol, 60,
                    (double)times[i], direction);
}

static int stops_at_one(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)y;
    (void)ctx;
    dydt[0] = 2 * t;
    return t > 1;
}

static vm_real half(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] - R(0.25);
}

/* What ends the run before the last time: the rows before it are filled, and no others; another call goes on. */
static void test_listed_times_interrupted(const method *m)
{
    const vm_real y0[1] = {0}, times[5] = {R(0.125), R(0.25), R(0.375), R(0.75), 3};
    vm_real rows[5] = {7, 7, 7, 7, 7}, work[RK87_WORK(1)];
    ode_event event;
    rk45_options o;
    rk45 s;
    vm_real now, half_way;
    int done;
    memset(&event, 0, sizeof event);
    memset(&o, 0, sizeof o);
    event.g = half;
    event.action = ODE_STOP;
    o.events = &event;
    o.n_events = 1;
    o.h_max = R(0.1);
    CHECK(m->init(&s, stops_at_one, NULL, 1, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve_at(&s, 5, times, rows, &done) == ODE_EVENT && done == 3 && s.event == 0);
    CHECK(fabs((double)s.t - 0.5) < 1e-4 && fabs((double)rows[2] - 0.140625) < 1e-4 && rows[3] == 7);
    now = s.t;
    CHECK(m->solve_at(&s, 1, &now, &half_way, &done) == ODE_OK && done == 1 && half_way == s.y[0] && s.event == -1);
    CHECK(m->solve_at(&s, 2, times + 3, rows + 3, &done) == ODE_RHS_STOPPED && done == 1 && s.event == -1);
    CHECK(fabs((double)rows[3] - 0.5625) < 1e-4 && rows[4] == 7);
    o.max_steps = 1;
    CHECK(m->init(&s, stops_at_one, NULL, 1, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve_at(&s, 5, times, rows, NULL) == ODE_MAX_STEPS);
}

static void test_listed_times_refused(const method *m, const method *other)
{
    const vm_real y0[3] = {1, 0, 1}, rising[3] = {1, 3, 2}, falling[2] = {1, -1}, endless[2] = {1, VM_INFINITY};
    vm_real rows[9] = {7}, work[RK87_WORK(3)];
    rk45 s;
    int done = 5;
    CHECK(m->init(&s, linear_rhs, NULL, 3, 0, y0, NULL, work) == ODE_OK);
    CHECK(m->solve_at(&s, 3, rising, rows, &done) == ODE_BAD_ARGUMENT && m->solve_at(&s, 2, falling, rows, &done) < 0);
    CHECK(m->solve_at(&s, 2, endless, rows, &done) == ODE_BAD_ARGUMENT);
    CHECK(m->solve_at(&s, -1, rising, rows, &done) == ODE_BAD_ARGUMENT);
    CHECK(m->solve_at(NULL, 1, rising, rows, &done) == ODE_BAD_ARGUMENT);
    CHECK(m->solve_at(&s, 1, NULL, rows, &done) == ODE_BAD_ARGUMENT && m->solve_at(&s, 1, rising, NULL, &done) < 0);
    CHECK(other->solve_at(&s, 1, rising, rows, &done) == ODE_BAD_ARGUMENT);
    CHECK(done == 5 && rows[0] == 7 && s.steps == 0 && s.evals == 0);
    CHECK(m->solve_at(&s, 0, NULL, NULL, &done) == ODE_OK && done == 0 && s.steps == 0);
}

/* y = (t, an integral of sqrt(end - t)): at the end of the domain the right-hand side is NaN beyond `end`. */
static int until_end_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = 1;
    dydt[1] = y[0] > *(const vm_real *)ctx ? VM_NAN : VM_SQRT(*(const vm_real *)ctx - y[0]);
    return 0;
}

/* A step may end, by rounding, where the right-hand side is NaN. States within this step are then refused, or are
   numbers, but never NaN with the status ODE_OK. */
static void test_inside_of_last_step(void)
{
    int i, k;
    for (i = 0; i < METHODS; i++)
        for (k = 0; k < 4000; k++) {
            const method *m = methods + i;
            vm_real end = 1 + R(k) / 8192, h = R(0.375) + R(k % 64) / 1024, y[2] = {end - h, 0}, work[RK87_WORK(2)];
            rk45_options o = {0};
            rk45 s;
            int status;
            o.h0 = h;
            o.rtol = o.atol = R(1e-2);
            end -= R(k % 3) * VM_EPSILON;
            if (m->init(&s, until_end_rhs, &end, 2, 0, y, &o, work) != ODE_OK || m->step(&s) != ODE_OK) continue;
            y[0] = y[1] = 7;
            status = m->interpolate(&s, s.t_old + (s.t - s.t_old) / 2, y);
            CHECK(status == ODE_OK ? y[1] == y[1] && y[0] < end : y[0] == 7 && y[1] == 7);
        }
}

int main(void)
{
    int i;
    for (i = 0; i < METHODS; i++) {
        test_listed_times(methods + i, 1);
        test_listed_times(methods + i, -1);
        test_listed_times_interrupted(methods + i);
        test_listed_times_refused(methods + i, methods + 1 - i);
    }
    test_inside_of_last_step();
    test_orders();
    test_every_step();
    test_backward();
    test_refusals();
    test_restart();
    test_restart_is_a_start();
    return check_finish("dense output");
}
