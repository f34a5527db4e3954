/* integrators.h: events, by both methods. The cases are those that other programs get wrong: two of three events
   missed in one step, a terminal event lost between output times, a root exactly at the end of a step, a root found
   again after a restart, a body on the wrong side of its wall. */
#include "integrator_check.h"

static const double pi = 3.14159265358979323846;

static const method *m; /* the one under test */
static double noise;    /* how much more rounding it has than rk45: in float that shows */

/* y = (cos t, sin t) */
static int circle(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = -y[1];
    dydt[1] = y[0];
    return 0;
}

/* y = (t, ...): uniform motion, whose steps grow as they like */
static int uniform_motion(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    dydt[0] = 1;
    return 0;
}

/* a ball: y = (height, velocity), unit gravity */
static int fall(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -1;
    return 0;
}

/* y0 minus what ctx points at; null: y0 */
static vm_real level(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    return ctx ? y[0] - *(const vm_real *)ctx : y[0];
}

static vm_real second(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1];
}

static vm_real first(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static vm_real wave(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return VM_LIBM(sin)(y[0]);
}

static vm_real clock_at(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    return t - *(const vm_real *)ctx;
}

/* 1, then no number, then -1 */
static vm_real not_a_number_between(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    if (t < R(1.01)) return R(1.0);
    return t < R(1.02) ? VM_NAN : R(-1.0);
}

static vm_real not_a_number(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t > 1 ? VM_NAN : R(1.0);
}

static ode_event event(ode_event_function g, void *ctx, int direction, int action)
{
    ode_event e;
    memset(&e, 0, sizeof e);
    e.g = g;
    e.ctx = ctx;
    e.direction = direction;
    e.action = action;
    return e;
}

static rk45_options with_events(double tol, ode_event *events, int n)
{
    rk45_options o = {0};
    o.rtol = o.atol = R(tol);
    if (is_float && tol < 1e-4) o.rtol = o.atol = R(m == methods ? 1e-5 : 1e-4);
    o.events = events;
    o.n_events = n;
    return o;
}

/* An event that another run has used begins anew: its internal fields are those of an event that was never used. */
static void test_used_event(void)
{
    const vm_real y0[2] = {1, 0};
    vm_real work[RK87_WORK(2)];
    const ode_event fresh = event(level, NULL, 0, ODE_RECORD);
    ode_event used = fresh;
    const rk45_options o = with_events(1e-3, &used, 1);
    rk45 s;
    used.count = 3;
    used.t = used.slack = used.slack_ahead = used.quiet = used.quiet_ahead = used.from = R(0.5);
    used.side = used.side_ahead = used.happens = 1;
    CHECK(m->init(&s, circle, NULL, 2, 0, y0, &o, work) == ODE_OK);
    CHECK(used.count == fresh.count && used.t == fresh.t && used.from == fresh.from && used.happens == fresh.happens);
    CHECK(used.side == fresh.side && used.slack == fresh.slack && used.quiet == fresh.quiet);
    CHECK(used.side_ahead == fresh.side_ahead && used.slack_ahead == fresh.slack_ahead && used.quiet_ahead == fresh.quiet_ahead);
}

/* Zeros of cos t and sin t up to t = 20, recorded: all of them, in order, none at the start, where sin t is 0 */
static void test_record(void)
{
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)], times[2][10], states[2][20];
    ode_event e[2];
    double tol = !is_float ? 1e-10 : m == methods ? 1e-5 : 1e-4;
    rk45_options o;
    rk45 s;
    int k;
    e[0] = event(level, NULL, 0, ODE_RECORD);
    e[1] = event(second, NULL, 0, ODE_RECORD);
    for (k = 0; k < 2; k++) {
        e[k].room = 10;
        e[k].times = times[k];
        e[k].states = states[k];
    }
    e[1].room = 4; /* more happen than are kept */
    o = with_events(tol, e, 2);
    CHECK(m->init(&s, circle, NULL, 2, 0, y0, &o, work) == ODE_OK && m->solve(&s, 20) == ODE_OK);
    CHECK(e[0].count == 6 && e[1].count == 6 && s.event == -1);
    for (k = 0; k < 6; k++) {
        check_error("event time", m->name, "tol", fabs((double)times[0][k] - (k + 0.5) * pi) / tol, 30, k, 0);
        check_error("g at the event", m->name, "eps", fabs((double)states[0][2 * k]) / eps, 40 * noise, k, 0);
        if (k < 4)
            check_error("event time", m->name, "tol", fabs((double)times[1][k] - (k + 1) * pi) / tol, 30, k, 1);
    }
    check_error("event time", m->name, "tol", fabs((double)e[1].t - 6 * pi) / tol, 30, 5, 1);
    /* directions: cos falls at pi/2, rises at 3 pi/2; backward it is the other way round */
    e[0] = event(level, NULL, 1, ODE_RECORD);
    e[1] = event(level, NULL, -1, ODE_RECORD);
    CHECK(m->init(&s, circle, NULL, 2, 0, y0, &o, work) == ODE_OK && m->solve(&s, 6) == ODE_OK);
    CHECK(e[0].count == 1 && e[1].count == 1 && fabs((double)e[0].t - 1.5 * pi) < 0.001 &&
          fabs((double)e[1].t - 0.5 * pi) < 0.001);
    CHECK(m->solve(&s, 0) == ODE_OK && e[0].count == 2 && e[1].count == 2 &&
          fabs((double)e[0].t - 0.5 * pi) < 0.001 && fabs((double)e[1].t - 1.5 * pi) < 0.001);
}

/* Steps of uniform motion are as long as they may be: many events in one step, of several functions and of one */
static void test_many_in_a_step(void)
{
    vm_real y0[1] = {0}, work[RK87_WORK(1)], at[3] = {7, 2, 5}, times[10];
    ode_event e[3];
    rk45_options o;
    rk45 s;
    int k;
    for (k = 0; k < 3; k++) e[k] = event(level, at + k, 0, ODE_STOP);
    o = with_events(1e-6, e, 3);
    o.h0 = 10;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, 20) == ODE_EVENT && s.event == 1 && fabs((double)s.t - 2) < 400 * eps && s.steps == 1);
    CHECK(m->solve(&s, 20) == ODE_EVENT && s.event == 2 && fabs((double)s.t - 5) < 400 * eps);
    CHECK(m->solve(&s, 20) == ODE_EVENT && s.event == 0 && fabs((double)s.t - 7) < 400 * eps);
    CHECK(m->solve(&s, 20) == ODE_OK && s.t == 20 && e[0].count == 1 && e[1].count == 1 && e[2].count == 1);
    for (k = 0; k < 2; k++) { /* one function with three zeros in the step: seen if it is looked at often enough */
        e[0] = event(wave, NULL, 0, ODE_RECORD);
        e[0].checks = k ? 9 : -1;
        e[0].room = 10;
        e[0].times = times;
        o = with_events(1e-6, e, 1);
        o.h0 = 10;
        CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->step(&s) == ODE_OK);
        CHECK(s.steps == 1 && s.t == 10 && e[0].count == (k ? 3 : 1));
        if (k)
            CHECK(fabs((double)times[0] - pi) < 200 * eps && fabs((double)times[1] - 2 * pi) < 200 * eps &&
                  fabs((double)times[2] - 3 * pi) < 200 * eps);
    }
    for (k = 0; k < 3; k++) {
        at[k] = 3;
        e[k] = event(level, at + k, 0, k == 1 ? ODE_STOP : ODE_RECORD);
    }
    o = with_events(1e-6, e, 3);
    o.h0 = 10; /* at the same time: all happen */
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 20) == ODE_EVENT);
    CHECK(s.event == 1 && e[0].count == 1 && e[1].count == 1 && e[2].count == 1);
    CHECK(m->solve(&s, 20) == ODE_OK && e[0].count == 1 && e[1].count == 1 && e[2].count == 1);
}

/* A terminal event between output times, on one, and at the end of the run */
static void test_output_times(void)
{
    vm_real y0[1] = {0}, work[RK87_WORK(1)], at[2] = {R(0.5), R(0.625)}, t;
    ode_event e[2];
    rk45_options o;
    rk45 s;
    int stops = 0;
    e[0] = event(level, at, 0, ODE_STOP);
    e[1] = event(level, at + 1, 0, ODE_STOP);
    o = with_events(1e-6, e, 2);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK);
    for (t = R(0.25); t <= 1; t += R(0.25)) {
        int status;
        while ((status = m->solve(&s, t)) == ODE_EVENT) {
            stops++;
            CHECK(fabs((double)s.t - (stops == 1 ? 0.5 : 0.625)) < 40 * eps);
        }
        CHECK(status == ODE_OK && s.t == t);
    }
    CHECK(stops == 2 && e[0].count == 1 && e[1].count == 1);
    at[0] = 1;
    e[0] = event(clock_at, at, 0, ODE_STOP); /* exactly zero at the end of the step */
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 1) == ODE_EVENT);
    CHECK(m->solve(&s, 1) == ODE_EVENT && s.event == 0 && s.t == 1);
    CHECK(m->solve(&s, 2) == ODE_OK && s.t == 2 && e[0].count == 1);
    CHECK(m->solve(&s, 0) == ODE_EVENT && s.event == 0 && e[0].count == 2); /* and on the way back */
    CHECK(m->solve(&s, 0) == ODE_EVENT && s.event == 1 && m->solve(&s, 0) == ODE_OK && s.t == 0);
    e[0] = event(clock_at, at, 0, ODE_RECORD); /* recorded on a step's end */
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 1) == ODE_EVENT);
    CHECK(m->solve(&s, 1) == ODE_OK && e[0].count == 1 && m->solve(&s, 2) == ODE_OK && e[0].count == 1);
    /* restarted by hand at a root, unchanged: it is not found again */
    at[0] = R(0.3);
    at[1] = 50;
    e[0] = event(level, at, 0, ODE_STOP);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 1) == ODE_EVENT);
    CHECK(m->restart(&s, s.t, s.y) == ODE_OK && m->solve(&s, 1) == ODE_OK && e[0].count == 1);
    y0[0] = R(0.3); /* and a run that starts on one does not find it */
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 1) == ODE_OK);
    CHECK(e[0].count == 0);
}

/* A ball bouncing with restitution 0.8 from height 1/2: hits at t = 1, then after 2 v each time. Any direction is an
   event, so that a hit found again, or one from below, would be counted. */
static void bounce(int direction, vm_real h_max)
{
    vm_real y0[2] = {R(0.5), 0}, work[RK87_WORK(2)], y[2];
    ode_event e[1];
    rk45_options o;
    rk45 s;
    double v = 1, hit = 1, bound = h_max > 0 ? 0.1 : 1;
    int k;
    e[0] = event(level, NULL, direction, ODE_STOP);
    o = with_events(1e-8, e, 1);
    if (is_float)
        o.h_max = 1; /* free fall is exact in any step; one of 100 falls so deep that its eps hides a bounce */
    CHECK(m->init(&s, fall, NULL, 2, 0, y0, &o, work) == ODE_OK);
    for (k = 0; k < 25; k++) {
        CHECK(m->solve(&s, 100) == ODE_EVENT && s.event == 0);
        CHECK(s.y[0] <= 0 &&
              (double)s.y[0] > -bound * 1e-8 - 100 * noise * eps); /* the far side, next to the wall */
        /* float: steps are no longer exactly 1, whose products with the coefficients are exact; errors are those of
           any other step now (rk45, h_max = 0.97: up to 20) */
        check_error(h_max > 0 ? "bounce: time" : "in one step: time", m->name, "tol",
                    fabs((double)s.t - hit) / (double)o.rtol, is_float ? 20 * noise : 0.05, k, direction);
        check_error(h_max > 0 ? "bounce: velocity" : "in one step: v", m->name, "tol",
                    fabs((double)s.y[1] + v) / (double)o.rtol, is_float ? 10 * noise : bound, k, direction);
        v *= 0.8;
        hit += 2 * v;
        y[0] = s.y[0];
        y[1] = R(-0.8) * s.y[1];
        CHECK(m->restart(&s, s.t, y) == ODE_OK);
    }
    CHECK(e[0].count == 25);
}

/* A ball that comes to rest after ever shorter bounces (at t = 9) does not get below the floor */
static void test_zeno(void)
{
    vm_real y0[2] = {R(0.5), 0}, work[RK87_WORK(2)], y[2];
    ode_event e[1];
    rk45_options o;
    rk45 s;
    long k;
    int status = ODE_EVENT;
    e[0] = event(level, NULL, -1, ODE_STOP);
    o = with_events(1e-6, e, 1);
    CHECK(m->init(&s, fall, NULL, 2, 0, y0, &o, work) == ODE_OK);
    for (k = 0; k < 1000 && status == ODE_EVENT && (double)s.t < 8.999; k++) {
        status = m->solve(&s, 10);
        CHECK(status == ODE_EVENT && s.y[0] <= 0 && (double)s.y[0] > -1e-4);
        y[0] = 0;
        y[1] = R(-0.8) * s.y[1];
        CHECK(m->restart(&s, s.t, y) == ODE_OK);
    }
    CHECK(k > 30 && k < 1000);
}

/* x'' = -sign(x) jumps at x = 0. Left to the step size control; with the sign kept and changed at the event. */
typedef struct spring {
    int kept;
    vm_real sign;
} spring;

static int sign_force(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const spring *p = (const spring *)ctx;
    (void)t;
    dydt[0] = y[1];
    dydt[1] = p->kept ? -p->sign : y[0] > 0 ? R(-1.0) : R(1.0);
    return 0;
}

static vm_real height(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static void change_sign(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    ((spring *)ctx)->sign *= -1;
}

static void test_restart_at_a_jump(void)
{
    vm_real y0[2] = {R(0.5), 0}, work[RK87_WORK(2)]; /* period 4: four parabolas of duration 1 */
    double tol = !is_float ? 1e-9 : m == methods ? 1e-5 : 1e-4, error[2];
    long evals[2];
    spring p;
    ode_event e[1];
    rk45_options o;
    rk45 s;
    for (p.kept = 0; p.kept < 2; p.kept++) {
        p.sign = 1;
        e[0] = event(height, &p, 0, ODE_RESTART);
        o = with_events(tol, e, p.kept);
        e[0].change = change_sign;
        CHECK(m->init(&s, sign_force, &p, 2, 0, y0, &o, work) == ODE_OK && m->solve(&s, 40) == ODE_OK);
        evals[p.kept] = s.evals;
        error[p.kept] = fabs((double)s.y[0] - 0.5);
    }
    printf(
        "x'' = -sign(x), 10 periods, %s, tol %g: %ld evaluations, error %.1e; sign changed at events: %ld, %.1e\n",
        m->name, tol, evals[0], error[0], evals[1], error[1]);
    CHECK(e[0].count == 20 && (double)evals[1] * 10 / noise < (double)evals[0]);
    check_error("sign force", m->name, "tol", error[1] / tol, is_float ? 100 : 2, 40, 0);
}

/* A restart at another time forgets that an event has just happened: a zero of g next to the new state is found, though g
   is as small there as at the event before. */
static void test_restart_next_to_a_zero(void)
{
    vm_real y = R(-0.5), work[RK87_WORK(1)];
    ode_event e[1];
    rk45_options o = with_events(1e-6, e, 1);
    rk45 s;
    e[0] = event(first, NULL, 0, ODE_STOP);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, &y, &o, work) == ODE_OK && m->solve(&s, 2) == ODE_EVENT);
    y = -VM_EPSILON / 256;
    CHECK(m->restart(&s, s.t + 1, &y) == ODE_OK && m->solve(&s, s.t + 1) == ODE_EVENT && e[0].count == 2);
}

static void test_bad_events(void)
{
    vm_real y0[1] = {0}, work[RK87_WORK(1)];
    ode_event e[1];
    rk45_options o;
    rk45 s;
    e[0] = event(not_a_number, NULL, 0, ODE_STOP);
    o = with_events(1e-6, e, 1);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 5) == ODE_NOT_FINITE);
    CHECK(VM_IS_FINITE(s.y[0]) && fabs((double)(s.y[0] - s.t)) < 100 * eps);
    e[0] = event(not_a_number_between, NULL, 0, ODE_STOP);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 5) == ODE_NOT_FINITE);
    CHECK(e[0].count == 0);
    e[0] = event(NULL, NULL, 0, ODE_STOP);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_BAD_ARGUMENT);
    o.events = NULL;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_BAD_ARGUMENT);
    o.events = e;
    o.n_events = -1;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_BAD_ARGUMENT);
    e[0] = event(level, NULL, 0, ODE_RECORD);
    e[0].room = -1;
    o.n_events = 1;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_BAD_ARGUMENT);
    e[0].room = 0;
    e[0].stop_after = -1;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_BAD_ARGUMENT);
}

static vm_real clock_reading(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t;
}

/* The state and the time that are moved on purpose, to weigh rounding errors, are moved no further than promised. */
static void test_moved_values(void)
{
    vm_real y0[2] = {1, 2}, work[RK87_WORK(2)], t;
    ode_event by_state = event(first, NULL, 0, ODE_RECORD), by_time = event(clock_reading, NULL, 0, ODE_RECORD);
    rk45_options o = with_events(1e-6, NULL, 0);
    rk45 s;
    int direction;
    CHECK(m->init(&s, circle, NULL, 2, 0, y0, &o, work) >= 0 && m->step(&s) >= 0);
    t = s.t / 2;
    for (direction = -1; direction <= 1; direction += 2) {
        const vm_real moved = vmi_event_value_moved(&s, &by_state, R(0.5), 0, direction);
        const vm_real x = vmi_event_value(&s, &by_state, R(0.5)), rounding = vmi_least_rtol(&s.pair);
        CHECK(moved != x && VM_FABS(moved - x) <= rounding * (y0[0] + VM_FABS(x) + VM_FABS(s.y[0]) / 2) * R(1.01));
        CHECK(VM_FABS(vmi_event_value_moved(&s, &by_time, R(0.5), 0, direction) - t) <= 2 * VM_EPSILON * t);
    }
}

/* The run ends when an event has happened 4 times, 8 times and so on, for each action, forward and backward; its end is
   infinite. The zeros of cos t are known. */
static void test_stop_after(int action, double direction)
{
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)], times[12];
    ode_event e = event(first, NULL, 0, action);
    rk45_options o = with_events(1e-8, &e, 1);
    rk45 s;
    int i, k;
    e.stop_after = 4;
    e.times = times;
    e.room = 12;
    CHECK(m->init(&s, circle, NULL, 2, 0, y0, &o, work) >= 0);
    for (k = 1; k <= 3; k++) {
        CHECK(m->solve(&s, R(direction) * VM_INFINITY) == ODE_EVENT && s.event == 0 && e.count == 4 * k);
        CHECK(s.t == times[4 * k - 1] && s.t == e.t);
    }
    for (i = 0; i < 12; i++) {
        const double error = fabs((double)times[i] - direction * (i + 0.5) * pi);
        check_error(m->name, "stop after k", "tol", error / (double)s.options.rtol, 100, i, action);
    }
    CHECK(m->solve(&s, s.t + R(direction)) == ODE_OK && e.count == 12);
}

/* Several passings in one step: none is lost, and the run ends at the right one. */
static void test_stop_after_in_a_step(void)
{
    vm_real y0[1] = {R(0.5)}, work[RK87_WORK(1)];
    ode_event e[2];
    rk45_options o;
    rk45 s;
    int k;
    e[0] = event(wave, NULL, 0, ODE_RECORD);
    e[0].checks = 200;
    e[0].stop_after = 7;
    e[1] = event(wave, NULL, 0, ODE_RECORD);
    e[1].checks = 200;
    o = with_events(1e-6, e, 2);
    o.h_max = 50; /* 16 zeros in a step */
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) >= 0);
    for (k = 1; k <= 5; k++) {
        CHECK(m->solve(&s, VM_INFINITY) == ODE_EVENT && e[0].count == 7 * k && e[1].count == 7 * k);
        CHECK(fabs((double)s.y[0] - 7 * k * pi) <= 1e3 * eps * (1 + 7 * k));
    }
}

/* An infinite end needs an event that can stop the run; where it never happens, the run ends with an error. */
static void test_infinite_end(void)
{
    vm_real y0[1] = {1}, work[RK87_WORK(1)];
    ode_event e = event(level, NULL, 0, ODE_RECORD);
    rk45_options o = with_events(1e-6, &e, 1);
    rk45 s;
    int status;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) >= 0);
    CHECK(m->solve(&s, VM_INFINITY) == ODE_BAD_ARGUMENT && m->solve(&s, VM_NAN) == ODE_BAD_ARGUMENT && s.evals == 0);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, NULL, work) >= 0);
    CHECK(m->solve(&s, -VM_INFINITY) == ODE_BAD_ARGUMENT && s.evals == 0);
    e.action = ODE_STOP;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) >= 0);
    CHECK(m->solve(&s, VM_NAN) == ODE_BAD_ARGUMENT);
    status = m->solve(&s, VM_INFINITY); /* y = 1 + t never falls to 0 */
    CHECK(status == ODE_STEP_TOO_SMALL || status == ODE_NOT_FINITE || status == ODE_MAX_STEPS);
    CHECK(VM_IS_FINITE(s.t) && VM_IS_FINITE(s.y[0]) && e.count == 0);
    o.h_max = 10;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) >= 0);
    CHECK(m->solve(&s, -VM_INFINITY) == ODE_EVENT && fabs((double)s.t + 1) < 1e-5);
}

static int turning_state(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real rate = *(const vm_real *)ctx;
    (void)t;
    dydt[0] = rate * y[1];
    dydt[1] = -rate * y[0];
    return 0;
}
static vm_real time_left(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    return t - *(const vm_real *)ctx;
}

/* The continuous extension of a step may overflow between two finite states close to the largest number, because it
   adds products with y'. The step is then made again, shorter: the run stops at the event, and its state is finite. */
static void test_large_states(void)
{
    int i;
    for (i = 0; i < 1024; i++) {
        const double largest = 0.99 / 512 * (double)VM_MAX, angle = 0.4 * (i / 4 % 16);
        vm_real y0[2], work[RK87_WORK(2)], rate = R(4 * (1 + i % 4)), at = R((1 + i / 64) / 16.);
        ode_event e = event(time_left, &at, 0, ODE_STOP);
        const rk45_options o = with_events(1e-4, &e, 1);
        rk45 s;
        y0[0] = R(largest * cos(angle));
        y0[1] = R(largest * sin(angle));
        CHECK(m->init(&s, turning_state, &rate, 2, 0, y0, &o, work) >= 0);
        CHECK(m->solve(&s, 2) == ODE_EVENT && s.event == 0 && e.count == 1);
        CHECK(VM_IS_FINITE(s.y[0]) && VM_IS_FINITE(s.y[1]));
    }
}

/* What a run that goes on meets: a function that is no number where the run begins; an event that has been, from
   elsewhere; one exactly where the run ends, with room for states alone; two at one instant, of which one restarts
   without a change and the other stops; a function that is no number before another's */
static void test_corners(void)
{
    vm_real y0[1] = {0}, work[RK87_WORK(1)], one = 1, two = 2, states[2];
    ode_event e[2];
    rk45_options o;
    rk45 s;
    e[0] = event(not_a_number, NULL, 0, ODE_STOP);
    o = with_events(1e-6, e, 1);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 2, y0, &o, work) == ODE_OK && m->solve(&s, 5) == ODE_NOT_FINITE);
    CHECK(s.t == 2 && s.y[0] == 0 && s.steps == 0);
    e[0] = event(level, &one, 0, ODE_STOP);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 5) == ODE_EVENT);
    y0[0] = R(0.5);
    CHECK(m->restart(&s, s.t, y0) == ODE_OK && m->solve(&s, 5) == ODE_EVENT && e[0].count == 2);
    check_error(m->name, "event again", "eps", fabs((double)s.t - 1.5) / eps, 8, 0, 0);
    y0[0] = 0;
    e[0] = event(clock_at, &two, 0, ODE_RECORD);
    e[0].room = 2;
    e[0].states = states;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 2) == ODE_OK);
    CHECK(s.t == 2 && e[0].count == 1 && e[0].t == 2 && states[0] == s.y[0]);
    e[0] = event(clock_at, &one, 0, ODE_RESTART);
    e[1] = event(clock_at, &one, 0, ODE_STOP);
    o = with_events(1e-6, e, 2);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 2) == ODE_EVENT);
    CHECK(s.event == 1 && e[0].count == 1 && e[1].count == 1 && fabs((double)s.t - 1) < 8 * eps);
    CHECK(fabs((double)(s.y[0] - s.t)) < 8 * eps);
    CHECK(m->solve(&s, 2) == ODE_OK && s.t == 2 && e[0].count == 1 && e[1].count == 1);
    e[0] = event(not_a_number, NULL, 0, ODE_RECORD);
    e[1] = event(level, &two, 0, ODE_RECORD);
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_OK && m->solve(&s, 5) == ODE_NOT_FINITE);
    CHECK(e[1].count == 0 && s.t <= 5);
    CHECK(m->init(NULL, uniform_motion, NULL, 1, 0, y0, &o, work) == ODE_BAD_ARGUMENT);
    CHECK(m->init(&s, uniform_motion, NULL, 1, VM_MAX, y0, NULL, work) == ODE_OK &&
          m->step(&s) == ODE_STEP_TOO_SMALL && s.t == VM_MAX);
}

/* The right-hand side fails at one evaluation: stops the run, or is once no number, which a shorter step passes
   over; also among those that rk87 makes to look inside of a step. Until then the state is good. */
static long countdown;
static int fails_once(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    circle(t, y, dydt, NULL);
    if (--countdown) return 0;
    dydt[0] = ctx ? VM_NAN : 1000;
    return ctx ? 0 : 9;
}

static void test_one_failure(void)
{
    const vm_real y0[2] = {1, 0};
    int kind, when;
    for (when = 1; when < 12; when++) { /* where the compiler knows n: the state is that of the last step made */
        vm_real work[RK87_WORK(2)];
        int status;
        rk45 s;
        CHECK(m->init(&s, fails_once, NULL, 2, 0, y0, NULL, work) == ODE_OK);
        countdown = when;
        status = m == methods ? rk45_solve_with(&s, fails_once, 2, 2) : rk87_solve_with(&s, fails_once, 2, 2);
        CHECK(status == ODE_RHS_STOPPED && s.rhs_status == 9 && (s.steps > 0) == (s.t > 0));
        CHECK(s.steps > 0 || (s.y[0] == 1 && s.y[1] == 0));
        CHECK(m->solve(&s, 2) == ODE_OK && fabs((double)s.y[0] - cos(2)) < 1e-3);
    }
    for (kind = 0; kind < 3; kind++) /* stops, is no number, is none where the step must not be shorter */
        for (when = 1; when < 80; when++) {
            vm_real work[RK87_WORK(2)];
            ode_event e = event(level, NULL, 0, ODE_RECORD);
            rk45_options o = with_events(1e-6, &e, 1);
            int status;
            rk45 s;
            o.h0 = R(0.25);
            o.h_max = R(0.25);
            o.h_min = kind == 2 ? R(0.125) : 0;
            CHECK(m->init(&s, fails_once, kind ? &kind : NULL, 2, 0, y0, &o, work) == ODE_OK);
            countdown = when;
            status = m->solve(&s, 2);
            CHECK(status == ODE_OK || status == (kind ? ODE_NOT_FINITE : ODE_RHS_STOPPED) ||
                  (kind == 2 && status == ODE_STEP_TOO_SMALL));
            CHECK((status == ODE_OK) == (s.t == 2) && (kind || countdown > 0 || s.rhs_status == 9));
            CHECK(kind != 1 || when == 1 || status == ODE_OK); /* at the first state there is nothing to shorten */
            CHECK(fabs((double)s.y[0] - cos((double)s.t)) < (is_float ? 1e-3 : 1e-5));
            CHECK(status != ODE_OK || (e.count == 1 && fabs((double)e.t - pi / 2) < (is_float ? 1e-3 : 1e-5)));
        }
}

/* Where the right-hand side stops the run, also in the first evaluation after an event, the state between s.t_old and
   s.t is still that of the last step. */
static void test_inside_after_failure(void)
{
    const vm_real y0[2] = {1, 0};
    int when;
    for (when = 1; when < 80; when++) {
        vm_real work[RK87_WORK(2)], y[2] = {0, 0}, middle;
        ode_event e = event(level, NULL, 0, ODE_RESTART);
        rk45_options o = with_events(1e-6, &e, 1);
        rk45 s;
        o.h_max = R(0.25);
        CHECK(m->init(&s, fails_once, NULL, 2, 0, y0, &o, work) == ODE_OK);
        countdown = when;
        if (m->solve(&s, 2) == ODE_OK) continue;
        middle = s.t_old + (s.t - s.t_old) / 2;
        CHECK(m->interpolate(&s, middle, y) == ODE_OK);
        CHECK(fabs((double)y[0] - cos((double)middle)) < (is_float ? 1e-3 : 1e-5));
    }
}

/* y' = (A, -A - D): g = y0 + y1 falls through 0 once, slowly. */
static int slow_fall(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real *slopes = (const vm_real *)ctx;
    (void)t;
    (void)y;
    dydt[0] = slopes[0];
    dydt[1] = -slopes[0] - slopes[1];
    return 0;
}

static vm_real sum_of_two(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] + y[1];
}

/* Where g passes 0 in the direction that does not count, rounding errors after this passage are no event, also if the
   passage is at the end of a step. */
static void test_passage_at_end_of_step(void)
{
    static const int actions[3] = {ODE_RECORD, ODE_STOP, ODE_RESTART};
    int k, action, wrong = 0;
    for (action = 0; action < 3; action++)
        for (k = 0; k < 3000; k++) {
            vm_real slopes[2], y0[2], work[RK87_WORK(2)];
            ode_event e = event(sum_of_two, NULL, 1, actions[action]);
            rk45_options o = with_events(1e-6, &e, 1);
            rk45 s;
            slopes[0] = 1 + R(k) / 1024;
            slopes[1] = R(is_float ? 1e-3 : 1e-11);
            y0[0] = R(k % 37) / 16;
            y0[1] = -y0[0] + slopes[1];
            o.h0 = o.h_max = R(0.25);
            CHECK(m->init(&s, slow_fall, slopes, 2, 0, y0, &o, work) == ODE_OK);
            wrong += m->solve(&s, 2) != ODE_OK || e.count > 0;
        }
    CHECK(wrong == 0);
}

static vm_real above_half(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] - R(0.5);
}

static vm_real cube_above_eighth(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] * y[0] * y[0] - R(0.125);
}

/* Two functions with the same zero, both of which stop the run: neither is lost because the other was located first.
   x = cos t passes 1/2 twenty times up to t = 62.8. */
static void test_same_zero(double tol)
{
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)];
    ode_event e[2];
    rk45_options o;
    rk45 s;
    int status;
    e[0] = event(above_half, NULL, 0, ODE_STOP);
    e[1] = event(cube_above_eighth, NULL, 0, ODE_STOP);
    o = with_events(tol, e, 2);
    CHECK(m->init(&s, circle, NULL, 2, 0, y0, &o, work) == ODE_OK);
    do status = m->solve(&s, R(62.8));
    while (status == ODE_EVENT && e[0].count < 100);
    CHECK(status == ODE_OK && e[0].count == 20 && e[1].count == 20);
}

static int two_rates(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real *rate = (const vm_real *)ctx;
    (void)t;
    (void)y;
    dydt[0] = rate[0];
    dydt[1] = rate[1];
    return 0;
}

static void turn_back(vm_real t, vm_real *y, void *ctx)
{
    vm_real *rate = (vm_real *)ctx;
    (void)t;
    (void)y;
    rate[0] = -rate[0];
    rate[1] = -rate[1];
}

/* y0 and y1 reach 0 at the same time, at which one call ends and the next begins. The event of y0 turns both back:
   that of y1 happens all the same, unless the roundings of many steps have parted the two. */
static void test_together_at_an_end(void)
{
    int i, lost = 0;
    for (i = 0; i < 200; i++) {
        const double end = uniform(1, 9);
        vm_real rate[2] = {R(uniform(0.5, 2)), R(uniform(0.5, 2))}, work[RK87_WORK(2)], y0[2];
        ode_event e[2];
        rk45_options o;
        rk45 s;
        y0[0] = R(-(double)rate[0] * end);
        y0[1] = R(-(double)rate[1] * end);
        e[0] = event(level, rate, 1, ODE_RESTART);
        e[1] = event(second, NULL, 1, ODE_RECORD);
        e[0].g = first;
        e[0].change = turn_back;
        o = with_events(1e-6, e, 2);
        CHECK(m->init(&s, two_rates, rate, 2, 0, y0, &o, work) == ODE_OK && m->solve(&s, R(end)) == ODE_OK);
        CHECK(m->solve(&s, R(end + 0.5)) == ODE_OK && e[0].count == 1);
        lost += e[1].count == 0;
    }
    check_error("lost at an end", m->name, "%", lost / 2., is_float ? 5 : 2, 200, lost);
}

static int two_balls(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    fall(t, y, dydt, ctx);
    return fall(t, y + 2, dydt + 2, ctx);
}

static vm_real second_ball(vm_real t, const vm_real *y, void *ctx) { return level(t, y + 2, ctx); }

static void bounce_first(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[1] = -y[1];
}

static void bounce_second(vm_real t, vm_real *y, void *ctx) { bounce_first(t, y + 2, ctx); }

/* Two balls that hit the floor together both bounce: what each ODE_RESTART changes is changed */
static void test_two_changes(void)
{
    const vm_real y0[4] = {R(0.5), 0, R(0.5), 0};
    vm_real work[RK87_WORK(4)];
    ode_event e[2];
    rk45_options o;
    rk45 s;
    e[0] = event(level, NULL, -1, ODE_RESTART);
    e[1] = event(second_ball, NULL, -1, ODE_RESTART);
    e[0].change = bounce_first;
    e[1].change = bounce_second;
    o = with_events(1e-8, e, 2);
    CHECK(m->init(&s, two_balls, NULL, 4, 0, y0, &o, work) == ODE_OK && m->solve(&s, R(1.5)) == ODE_OK);
    CHECK(e[0].count == 1 && e[1].count == 1 && s.y[0] == s.y[2] && s.y[1] == s.y[3]);
    check_error("two balls", m->name, "", fabs((double)s.y[0] - 0.375), is_float ? 1e-3 : 1e-9, 1.5, 0);
}

/* Negative for y0 between 1/4 and 3/4 */
static vm_real dip(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return (y[0] - R(0.25)) * (y[0] - R(0.75));
}

/* One step reaches from 0 to 1. The first event's function has the same sign at both ends, so that its zeros are not seen
   until the second event ends the step at 1/2. Then the zero at 1/4 must be found, which comes earlier. */
static void test_dip_before_another_event(void)
{
    const vm_real y0 = 0;
    vm_real work[RK87_WORK(1)];
    ode_event e[2];
    rk45_options o;
    rk45 s;
    e[0] = event(dip, NULL, 0, ODE_STOP);
    e[1] = event(above_half, NULL, 0, ODE_STOP);
    e[0].checks = -1;
    o = with_events(1e-6, e, 2);
    o.h0 = 2;
    CHECK(m->init(&s, uniform_motion, NULL, 1, 0, &y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, 1) == ODE_EVENT && s.event == 0 && s.steps == 1);
    check_error("dip", m->name, "eps", fabs((double)s.t - 0.25) / eps, 4, 0.25, 0);
    CHECK(m->solve(&s, 1) == ODE_EVENT && s.event == 1);
}

/* A ball that bounces for ever, whose contact counts in both directions: it touches the floor once each time, however
   far from 0 the clock began and however short the steps are. Ten bounces up to t0 + 20. */
static void test_reversal(double t0, double h_max)
{
    vm_real y0[2] = {R(0.5), 0}, work[RK87_WORK(2)];
    ode_event e[1];
    rk45_options o;
    rk45 s;
    e[0] = event(level, NULL, 0, ODE_RESTART);
    e[0].change = bounce_first;
    o = with_events(1e-9, e, 1);
    o.h_max = R(h_max);
    CHECK(m->init(&s, fall, NULL, 2, R(t0), y0, &o, work) == ODE_OK && m->solve(&s, R(t0 + 20)) == ODE_OK);
    CHECK(e[0].count == 10);
    check_error("bounce for ever", m->name, "", fabs((double)s.y[0] - 0.5), is_float ? 1e-4 : 1e-8, t0, h_max);
}

int main(void)
{
    int k, action;
    for (k = 0; k < 2; k++) {
        m = methods + k;
        noise = is_float && k ? 10 : 1;
        test_same_zero(1e-3);
        test_same_zero(1e-6);
        if (!is_float) test_same_zero(1e-12);
        test_used_event();
        test_two_changes();
        test_dip_before_another_event();
        test_together_at_an_end();
        test_reversal(0, 1e-2);
        if (!is_float) {
            test_reversal(1e5, 1e-3);
            test_reversal(1e9, 0.5);
            test_reversal(1e12, 0.5);
        }
        test_record();
        test_many_in_a_step();
        test_output_times();
        bounce(-1, 1);
        bounce(0, 1);
        if (!is_float)
            bounce(0, 0); /* free fall is exact in any step; one of 100 falls so deep that it costs digits */
        if (noise == 1) test_zeno();
        test_restart_at_a_jump();
        test_restart_next_to_a_zero();
        test_bad_events();
        for (action = ODE_RECORD; action <= ODE_RESTART; action++) {
            test_stop_after(action, 1);
            test_stop_after(action, -1);
        }
        test_moved_values();
        test_stop_after_in_a_step();
        test_infinite_end();
        test_large_states();
        test_corners();
        test_one_failure();
        test_inside_after_failure();
        test_passage_at_end_of_step();
    }
    return check_finish("events");
}
