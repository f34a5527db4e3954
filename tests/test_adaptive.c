/* integrators.h: how rk45 and rk87 choose their steps, and how their runs end. The step size control, the smallest
   step, jumps and singular points of the right-hand side, the clock, the warning of stiffness, tolerances, refusals
   and early ends; against closed forms and the numbers of steps that the control took when it was last measured. */
#include "integrator_check.h"
#include <stdlib.h>

/* y' = -rate y */
static int decay_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = -*(const vm_real *)ctx * y[0];
    return 0;
}

/* y' = y^2: y = 1/(1 - t) */
static int blow_up_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[0] * y[0];
    return 0;
}

/* Returns an event of the event function g, called with the context ctx. */
static ode_event event_of(vm_real (*g)(vm_real t, const vm_real *y, void *ctx), void *ctx)
{
    ode_event event;
    memset(&event, 0, sizeof event);
    event.g = g;
    event.ctx = ctx;
    return event;
}

/* Returns the options of a run with one event. */
static rk45_options options_with(ode_event *event)
{
    rk45_options o = {0};
    o.events = event;
    o.n_events = 1;
    return o;
}

/* ---- Step size control ---- */

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

/* The Arenstorf orbit, whose steps have very different sizes: the numbers are those of the control when it was last
   measured. */
static void test_arenstorf(void)
{
    vm_real y0[4] = {R(0.994), 0, 0, R(-2.00158510637908252240537862224)}, work[RK45_WORK(4)];
    rk45_options o = {0};
    rk45 s;
    if (is_float) return;
    o.rtol = o.atol = R(1e-9);
    CHECK(rk45_init(&s, arenstorf_rhs, NULL, 4, 0, y0, &o, work) == ODE_OK);
    CHECK(rk45_solve(&s, R(17.0652165601579625588917206249)) == ODE_OK);
    printf("Arenstorf orbit, 1e-9: %ld steps, %ld rejected, %ld evaluations\n", s.steps, s.rejected, s.evals);
    CHECK(labs(s.steps - 616) <= 4 && s.rejected >= 6 && s.rejected <= 14);
    CHECK(s.evals == 6 * (s.steps + s.rejected) + 2);
    check_error("after one period", "Arenstorf", "tol", fabs((double)(s.y[0] - y0[0])) / 1e-9, 5, 17, 0);
}

/* A step that was cut to meet t_end does not shorten the next one; h_max is kept; a step grows to ten times the one
   before at most. */
static void test_step_sizes(void)
{
    vm_real y0[3] = {1, 0, 1}, work[RK45_WORK(3)], h, rate = R(1e-3);
    rk45_options o = {0};
    rk45 s;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, NULL, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    h = s.h;
    CHECK(rk45_solve(&s, 1 + h / 100) == ODE_OK && s.h >= h && rk45_solve(&s, 1 + h / 50) == ODE_OK && s.h >= h);
    o.h_max = R(0.01);
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    CHECK(s.steps >= 100 && s.steps <= 102);
    o.h_max = 0;
    o.h0 = R(1e-6);
    CHECK(rk45_init(&s, decay_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK);
    CHECK(fabs((double)(s.h / o.h0) - 10) < 1e-5);
}

/* Times far from 0, and first steps far below what the time can resolve */
static void test_extreme_times(void)
{
    vm_real y0[3] = {1, 0, 1}, work[RK45_WORK(3)], slow = R(1e-8);
    rk45_options o = {0};
    rk45 s;
    CHECK(rk45_init(&s, decay_rhs, &slow, 1, R(1e6) / VM_EPSILON, y0, NULL, work) == ODE_OK);
    CHECK(rk45_step(&s) == ODE_OK);
    o.h0 = VM_EPSILON * VM_EPSILON;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 1, y0, &o, work) == ODE_OK && rk45_solve(&s, 2) == ODE_OK);
    CHECK(rk45_restart(&s, 1 / VM_EPSILON, s.y) == ODE_OK && rk45_solve(&s, 1 / VM_EPSILON + 2) != ODE_MAX_STEPS);
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, -VM_MAX, y0, NULL, work) == ODE_OK && rk45_solve(&s, VM_MAX) < 0);
}

/* y' is what the context holds. */
static int given_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)y;
    dydt[0] = *(const vm_real *)ctx;
    return 0;
}

/* y less the level in the context */
static vm_real above_level(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    return y[0] - *(const vm_real *)ctx;
}

/* After an event the time of the state is s.t + s.t_low. A run from there to s.t or to a neighbouring time is so short that
   the low word of the time decides how long it is. A run to s.t does nothing where s.t_low > 0: this state is there already. */
static void test_low_word_of_time(void)
{
    vm_real zero = 0, work[RK87_WORK(1)], slope, level;
    ode_event stop = event_of(above_level, &level);
    const rk45_options o = options_with(&stop);
    int m, i, ulps, apart = 0;
    stop.action = ODE_STOP;
    for (m = 0; m < METHODS; m++)
        for (i = 1; i < 60; i++)
            for (ulps = -2; ulps <= 2; ulps++) {
                rk45 s;
                double left;
                slope = 1;
                level = R(0.5 + 0.0079 * i);
                CHECK(methods[m].init(&s, given_rhs, &slope, 1, 0, &zero, &o, work) == ODE_OK);
                CHECK(methods[m].solve(&s, 2) == ODE_EVENT);
                apart += s.t_low != 0;
                left = ulps == 0 && s.t_low > 0 ? 0 : ulps * eps - (double)s.t_low;
                slope = 1 / VM_EPSILON;
                level = 100; /* no further event */
                CHECK(methods[m].restart(&s, s.t, &zero) == ODE_OK && methods[m].solve(&s, s.t + R(ulps) * VM_EPSILON) == ODE_OK);
                check_error("y' = 1/eps", methods[m].name, "abs", fabs((double)s.y[0] - left / eps), 1e-3, i, ulps);
            }
    CHECK(apart > 50);
}

/* y' = cos t */
static int cosine_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)y;
    (void)ctx;
    dydt[0] = VM_LIBM(cos)(t);
    return 0;
}

/* y' = -27 (y - 1) */
static int near_rest_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = -27 * (y[0] - 1);
    return 0;
}

/* The first step of y' = -y and of y' = y is within a factor of 2 of (0.01 tol)^(1/order) s, where tol is the tolerance.
   From y = 0 nothing tells the time scale of the problem, and the first step is 1e-4 s. */
static void test_first_steps(void)
{
    const double tolerance = is_float ? 1e-3 : 1e-6;
    vm_real work[RK87_WORK(1)], start = 1, zero = 0;
    rk45_options o = {0};
    rk45 s;
    int m, sign;
    o.rtol = o.atol = R(tolerance / 2);
    for (m = 0; m < METHODS; m++) {
        const double expected = pow(0.01 * tolerance, 1.0 / methods[m].order);
        for (sign = -1; sign <= 1; sign += 2) {
            vm_real rate = (vm_real)sign;
            CHECK(methods[m].init(&s, decay_rhs, &rate, 1, 0, &start, &o, work) == ODE_OK);
            CHECK(methods[m].step(&s) == ODE_OK && s.rejected == 0);
            check_error("first step", methods[m].name, "log2", fabs(log((double)s.t / expected)) / log(2.0), 1, sign, 0);
        }
        CHECK(methods[m].init(&s, cosine_rhs, NULL, 1, 0, &zero, &o, work) == ODE_OK);
        CHECK(methods[m].step(&s) == ODE_OK && fabs((double)s.t / 1e-4 - 1) < 1e-3);
    }
    if (!is_float) { /* the second derivative, 27^2 1e-4, determines the first step */
        const double expected = pow(0.01 * 1e-8 / (27 * 27 * 1e-4), 0.2);
        start = R(1.0001);
        o.rtol = o.atol = R(5e-9);
        CHECK(rk45_init(&s, near_rest_rhs, NULL, 1, 0, &start, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK);
        check_error("first step", "near rest", "log2", fabs(log((double)s.t / expected)) / log(2.0), 0.2, 0, 0);
        CHECK(s.rejected == 0);
    }
}

/* Where steps are rejected, max_steps counts them too. */
static void test_rejected_steps(void)
{
    vm_real y0[1] = {5}, work[RK45_WORK(1)], rate = R(1e6);
    rk45_options o = {0};
    rk45 s;
    o.max_steps = 7;
    o.h0 = 1;
    CHECK(rk45_init(&s, decay_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 10) == ODE_MAX_STEPS);
    CHECK(s.rejected > 0 && s.steps + s.rejected == 7);
}

/* y' = -y, but NaN at the call whose number ctx points to; this number counts down. */
static int missing_once_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    int *left = (int *)ctx;
    (void)t;
    *left -= 1;
    dydt[0] = *left == 0 ? VM_NAN : -y[0];
    return 0;
}

static vm_real above_two(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] - 2;
}

/* A step in which f is NaN once is undone and counts as one step that was rejected, also where f is evaluated only for
   the continuous extension, in which the integrator looks for events. In rk87 every twentieth call is the one at the end
   of a step, which is made again without undoing the step. */
static void test_step_of_nan(void)
{
    int m, missing;
    for (m = 0; m < METHODS; m++)
        for (missing = 4; missing < 50; missing++) {
            vm_real work[RK87_WORK(1)], start = 1;
            int left = missing;
            ode_event event = event_of(above_two, NULL);
            rk45_options o = options_with(&event);
            rk45 s;
            o.rtol = o.atol = R(is_float ? 1e-3 : 1e-6);
            CHECK(methods[m].init(&s, missing_once_rhs, &left, 1, 0, &start, &o, work) == ODE_OK);
            CHECK(methods[m].solve(&s, 10) == ODE_OK && left <= 0);
            CHECK(s.rejected == (m == 1 && missing % 20 == 15 ? 0 : 1));
        }
}

/* The weights by which the test of stiffness compares two states at the same time: their sum is 0, because a constant
   slope leads to the same state twice. */
static void test_end_differences(void)
{
    rk45 s;
    int m, j;
    for (m = 0; m < METHODS; m++) {
        vm_real work[RK87_WORK(1)], start = 1, rate = 1;
        double sum = 0, size = 0;
        rk45_options o = {0};
        CHECK(methods[m].init(&s, decay_rhs, &rate, 1, 0, &start, &o, work) == ODE_OK);
        for (j = 0; j < s.pair.stages - s.pair.last_is_first; j++) {
            const double weight = (double)s.pair.end_difference(j);
            sum += weight;
            size += fabs(weight);
        }
        CHECK(fabs(sum) <= 2 * eps * size);
    }
}

/* The rough power by which the step size follows the error */
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

/* ---- The clock ---- */

/* y = (cos, sin) of *ctx (t - t0) */
static int turn_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real speed = *(const vm_real *)ctx;
    (void)t;
    dydt[0] = -speed * y[1];
    dydt[1] = speed * y[0];
    return 0;
}

static double turn_error(const vm_real *y, double angle)
{
    return fmax(fabs((double)y[0] - cos(angle)), fabs((double)y[1] - sin(angle)));
}

typedef struct clock_run {
    int method;
    double speed, t0, span, tol, h_max, bound;
} clock_run;

/* The error at the end of a run; *worst is the largest at the end of any step. */
static double clock_error(const clock_run *c, double *worst)
{
    const method *m = methods + c->method;
    const double end = (double)R(c->t0 + c->span);
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)], rate = R(c->speed);
    rk45_options o = {0};
    rk45 s;
    o.rtol = o.atol = R(c->tol);
    o.h_max = R(c->h_max);
    o.max_steps = -1;
    *worst = 0;
    CHECK(m->init(&s, turn_rhs, &rate, 2, R(c->t0), y0, &o, work) == ODE_OK);
    s.h = R(c->h_max);
    while ((double)s.t + (double)s.h < end) {
        if (m->step(&s) != ODE_OK) {
            FAIL("a step failed");
            break;
        }
        *worst = fmax(*worst, turn_error(s.y, (double)rate * ((double)s.t - c->t0)));
    }
    CHECK(m->solve(&s, R(end)) == ODE_OK && (double)s.t == end);
    return turn_error(s.y, (double)rate * (end - c->t0));
}

/* The time in s.t and the time that the motion has taken are the same, after any number of steps, at any time on the
   clock. In parentheses what the error was while t + h was rounded and h was not. */
static void test_clock(void)
{
    static const clock_run runs[] = {
        {0, 1, 1.7e9, 1000, 1e-10, 0, 9e-9},                 /* (2.4e-4) */
        {0, 1, 0, 3600, 1e-10, 1e-3, 2e-11},                 /* (2.8e-7) */
        {0, 1, 0, 2000, 1e-13, 0, 2e-11},                    /* (4e-9) */
        {1, 6.283185307179586, 0, 1000, 1e-12, 0, 2e-10},    /* (1.2e-9) */
        {1, 6.283185307179586, 1e6, 100, 1e-12, 0, 2e-11},   /* (1.3e-6) */
        {1, 6.283185307179586, 1.7e9, 100, 1e-12, 0, 2e-11}, /* (1.6e-3) */
        {0, 1, 1e12, 100, 1e-13, 0, 2e-12},                  /* (0.08) */
        {1, 6.283185307179586, 1e12, 10, 1e-13, 0, 2e-12},   /* (0.06) */
    };
    static const clock_run in_float = {0, 1, 0, 100, 1e-4, 0.02, 3e-5}; /* (4.8e-3) */
    const clock_run *c = is_float ? &in_float : runs, *end = c + (is_float ? 1 : sizeof runs / sizeof *runs);
    for (; c < end; c++) {
        const char *name = methods[c->method].name;
        double worst;
        const double error = clock_error(c, &worst);
        check_error("clock: error over bound", name, "", error / c->bound, 1, c->t0, c->tol);
        check_error("any step", name, "", worst / c->bound, 1, c->t0, c->tol);
    }
}

/* ---- Jumps of the right-hand side ---- */

/* y' = slope at from <= t < to, else 0 */
typedef struct jump {
    vm_real from, to, slope;
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

/* From t0, y = 0, to t_end, without and with an event at the jump. Where missed is not negative, s.missed has to be
   it. */
static void check_jump(const method *m, jump j, vm_real t0, vm_real t_end, rk45_options o, long missed, double wanted)
{
    /* 100 tolerances, since the estimate of the error is not right where f jumps */
    const double allowed = 10 * (double)o.h_min + (is_float ? 1e-2 : 1e-4);
    vm_real y0[1] = {0}, work[RK87_WORK(1)];
    ode_event event = event_of(time_of_jump, &j);
    rk45 s;
    o.events = &event;
    for (o.n_events = 0; o.n_events < 2; o.n_events++) {
        CHECK(m->init(&s, jump_rhs, &j, 1, t0, y0, &o, work) == ODE_OK);
        CHECK(m->solve(&s, t_end) == ODE_OK && s.t == t_end);
        CHECK(missed < 0 || s.missed == missed);
        CHECK(event.count == o.n_events);
        check_error("jump of f", m->name, "1", fabs((double)s.y[0] / (double)j.slope - wanted) / allowed, 1,
                    (double)j.from, (double)j.slope);
    }
}

/* A jump of f that no step can resolve to the tolerance does not end a run. */
static void test_unresolvable_jumps(void)
{
    const vm_real huge = VM_MAX / R(1e6), later = R(1.3);
    rk45_options fine = {0}, relative = {0}, coarse = {0};
    int i;
    fine.atol = VM_EPSILON;
    relative.atol = -1;
    coarse.h_min = R(0.01);
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        jump at_0 = {0, 100, 1}, at_1 = {1, 100, 1};
        at_0.slope = huge;
        check_jump(m, at_0, -1, 1, fine, is_float ? -1 : 1, 1);
        at_1.slope = huge;
        check_jump(m, at_1, 0, 2, fine, 1, 1);
        at_1.to = later; /* and back; h_max, since a step could pass over all of it */
        fine.h_max = R(0.1);
        check_jump(m, at_1, 0, 2, fine, -1, 0.3);
        fine.h_max = 0;
        at_1.slope = -1000;
        at_1.to = 100;
        check_jump(m, at_1, 0, 2, fine, 1, 1);
        at_1.slope = 1;
        check_jump(m, at_1, 0, 2, relative, 1, 1);
        check_jump(m, at_1, 2, 0, relative, -1, -1); /* from t = 2, backward */
        check_jump(m, at_1, 0, 2, coarse, 1, 1);
    }
}

/* The derivative of each stage counts in the mean of the smallest and the largest one, whichever stage it belongs to. The
   parts of work are M numbers apart, as for M components, and are 1 where no other number is set. */
static void test_middle_slope(void)
{
    enum { STAGES = 7, M = 4 };
    vm_real w[(VMI_K + STAGES) * M];
    vmi_rk_system sys;
    int extreme, i;
    memset(&sys, 0, sizeof sys);
    sys.n = 2;
    sys.m = M;
    sys.w = w;
    for (extreme = 0; extreme < STAGES; extreme++) {
        vm_real *k = w + (VMI_K + extreme) * M;
        for (i = 0; i < (VMI_K + STAGES) * M; i++) w[i] = 1;
        k[0] = 5;
        k[1] = 9;
        CHECK(vmi_take_middle_slope(STAGES, sys, R(0.5)));
        CHECK(w[VMI_Z * M] == R(2.5) && w[VMI_Z * M + 1] == R(3.5)); /* 1 + 0.5 * (1 + 5)/2 and 1 + 0.5 * (1 + 9)/2 */
        k[0] = -3;
        k[1] = -7;
        CHECK(vmi_take_middle_slope(STAGES, sys, R(0.5)));
        CHECK(w[VMI_Z * M] == R(0.5) && w[VMI_Z * M + 1] == R(-0.5));
        k[1] = -VM_INFINITY;
        CHECK(!vmi_take_middle_slope(STAGES, sys, R(0.5)));
    }
}

/* f jumps in the middle of a step of the size h, and is infinite at times between two fractions of h. */
typedef struct pole_and_jump {
    vm_real h, from, to;
} pole_and_jump;

static int pole_and_jump_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const pole_and_jump *p = (const pole_and_jump *)ctx;
    (void)y;
    dydt[0] = t > p->h / 2 ? 100 : -100;
    if (t > p->from * p->h && t < p->to * p->h) dydt[0] = VM_INFINITY;
    return 0;
}

/* If f is infinite in stage 2, this is not seen in the estimate of the error, to which stage 2 does not contribute. A step of
   the smallest size over a jump must not lead to an infinite state then. */
static void test_pole_at_jump(void)
{
    vm_real y0[1] = {1}, work[RK87_WORK(1)];
    rk45_options o = {0};
    pole_and_jump p;
    rk45 s;
    int i;
    o.h0 = o.h_min = o.h_max = p.h = R(0.0625);
    o.rtol = o.atol = R(1e-3);
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        p.from = R(i == 0 ? 0.15 : 0.04); /* stage 2 of rk45 is at 0.2 of the step, that of rk87 at 0.056 */
        p.to = R(i == 0 ? 0.25 : 0.07);
        CHECK(m->init(&s, pole_and_jump_rhs, &p, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(m->solve(&s, 1) == ODE_NOT_FINITE && s.t == 0 && s.y[0] == 1);
        p.to = p.from; /* without the infinite value the step is accepted */
        CHECK(m->init(&s, pole_and_jump_rhs, &p, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(m->solve(&s, 1) == ODE_OK && s.missed == 1);
    }
}

/* An event's function that is NaN once, at its first call after the jump */
typedef struct spoiled_jump {
    jump j; /* first, for jump_rhs */
    int calls;
} spoiled_jump;

static vm_real nan_after_jump(vm_real t, const vm_real *y, void *ctx)
{
    spoiled_jump *s = (spoiled_jump *)ctx;
    (void)y;
    if (t > s->j.from && ++s->calls == 1) return VM_NAN;
    return t + 10;
}

/* A step of the smallest size over a jump is taken back where the event's function fails, and is counted once although it is
   made twice. */
static void test_missed_step_taken_back(void)
{
    int i;
    for (i = 0; i < METHODS; i++) {
        spoiled_jump spoiled = {{1, 100, -1000}, 0};
        vm_real y0[1] = {0}, work[RK87_WORK(1)];
        ode_event event = event_of(nan_after_jump, &spoiled);
        rk45_options o = options_with(&event);
        rk45 s;
        o.atol = VM_EPSILON;
        CHECK(methods[i].init(&s, jump_rhs, &spoiled, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(methods[i].solve(&s, 2) == ODE_NOT_FINITE && s.missed == 0 && s.t <= 1);
        CHECK(methods[i].solve(&s, 2) == ODE_OK && s.t == 2 && s.missed == 1);
    }
}

/* y' is 1 up to y = 1/2, and *ctx beyond */
static int threshold_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = y[0] > R(0.5) ? *(const vm_real *)ctx : R(1.0);
    return 0;
}

/* From y = 0.1 at t0: the state passes 1/2 at t0 + 0.4 and goes on with the slope `after` up to t0 + 2. */
static void check_threshold(const method *m, double after, double t0)
{
    const double wanted = 0.5 + 1.6 * after;
    vm_real start = R(0.1), work[RK87_WORK(1)], slope = R(after);
    rk45 s;
    CHECK(m->init(&s, threshold_rhs, &slope, 1, R(t0), &start, NULL, work) == ODE_OK);
    CHECK(m->solve(&s, R(t0) + 2) == ODE_OK && s.missed <= 1);
    check_error("threshold", m->name, "rel", fabs((double)s.y[0] / wanted - 1), is_float ? 2e-3 : 1e-5, after, t0);
}

/* A jump where the state passes a threshold: the step that meets it does not throw the state back, however large the
   jump is and however coarse the time. rk87 ended at -7.9 with success for a jump to 1e12 at t0 = 1000. */
static void test_thresholds(void)
{
    static const double jumps[] = {10, 1e3, 1e6, 1e12}, starts[] = {1, 100, 1e4};
    int i, j, k;
    for (i = 0; i < METHODS; i++) {
        for (j = 0; j < 4; j++) {
            for (k = 0; k < 3; k++) check_threshold(methods + i, jumps[j], starts[k]);
        }
    }
}

/* ---- The smallest step ---- */

/* Steps of h_min that keep the tolerance are good, even where the next step should be a little shorter than h_min. */
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

/* An interval in which no step can be short enough ends with a status, not in a loop. */
static void test_intervals_of_few_ulps(void)
{
    const vm_real t0 = is_float ? R(1e4) : R(1e10), ulp = t0 * VM_EPSILON;
    vm_real y0[1] = {5}, work[RK45_WORK(1)], rate;
    rk45_options o = {0};
    rk45 s;
    o.max_steps = -1;
    for (rate = R(0.01) / ulp; rate < 100 / ulp; rate *= R(1.3)) {
        int k;
        for (k = 1; k < 6; k++) {
            int status;
            CHECK(rk45_init(&s, decay_rhs, &rate, 1, t0, y0, &o, work) == ODE_OK);
            status = rk45_solve(&s, t0 + (vm_real)k * ulp);
            CHECK(status == ODE_OK || status == ODE_STEP_TOO_SMALL);
        }
    }
}

/* Where f is singular, or too stiff for t, a run ends with the state before the two steps that missed the tolerance.
   Further calls do not get on. */
static void test_unresolvable_points(void)
{
    vm_real start = 1, work[RK87_WORK(1)], rate = 100 / VM_EPSILON;
    int i, k;
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        rk45 s;
        int status;
        CHECK(m->init(&s, decay_rhs, &rate, 1, 1, &start, NULL, work) == ODE_OK);
        for (k = 0; k < 20; k++) {
            status = m->solve(&s, 2);
            CHECK(status == ODE_STEP_TOO_SMALL || status == ODE_NOT_FINITE);
        }
        CHECK(s.y[0] == 1 && s.t == 1 && s.steps == 0 && s.missed == 0);
        CHECK(m->init(&s, blow_up_rhs, NULL, 1, 0, &start, NULL, work) == ODE_OK);
        status = m->solve(&s, 2);
        CHECK(status == ODE_STEP_TOO_SMALL || status == ODE_NOT_FINITE);
        CHECK(fabs((double)s.t - 1) < (is_float ? 1e-4 : 1e-5) && s.missed == 0);
        CHECK(s.y[0] > R(0.01) / VM_EPSILON && s.y[0] < 1 / VM_EPSILON);
    }
}

/* Two steps of the smallest size that follow each other and miss the tolerance are both dropped, also if a test of
   stiffness is due after the first of them. This test comes after every 100 steps; here the first one comes after `wait`
   steps, and the run ends after fewer than 400. */
static void test_missed_at_stiffness_test(void)
{
    vm_real y0[1] = {1}, work[RK87_WORK(1)];
    rk45_options o = {0};
    rk45 plain, s;
    int i, wait;
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        int status;
        CHECK(m->init(&plain, blow_up_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
        plain.stiff_wait = 400;
        status = m->solve(&plain, 3);
        CHECK(status < 0 && plain.missed == 0 && plain.steps < 400);
        for (wait = 1; wait <= 400; wait++) {
            CHECK(m->init(&s, blow_up_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
            s.stiff_wait = wait;
            CHECK(m->solve(&s, 3) == status && s.missed == 0 && s.t == plain.t && s.steps == plain.steps);
        }
    }
    if (is_float) return;
    o.rtol = R(1e-4) / 237; /* with this tolerance step 200 is the first that misses it */
    CHECK(rk45_init(&s, blow_up_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK);
    CHECK(rk45_solve(&s, 3) == ODE_STEP_TOO_SMALL && s.missed == 0 && s.steps == 199);
}

static void test_blow_up_with_h_min(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)];
    rk45_options o = {0};
    rk45 s;
    int status;
    CHECK(rk45_init(&s, blow_up_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
    status = rk45_solve(&s, 2);
    CHECK((status == ODE_STEP_TOO_SMALL || status == ODE_NOT_FINITE) &&
          fabs((double)s.t - 1) < (is_float ? 1e-2 : 1e-5));
    o.h_min = R(0.01);
    CHECK(rk45_init(&s, blow_up_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK &&
          rk45_solve(&s, 2) == ODE_STEP_TOO_SMALL && s.t < 1);
}

/* ---- Stiffness ---- */

/* y' = -rate (y - cos t) */
static int relaxation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    dydt[0] = -*(const vm_real *)ctx * (y[0] - VM_LIBM(cos)(t));
    return 0;
}

/* An oscillator of the frequency *ctx */
static int slow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real rate = *(const vm_real *)ctx;
    (void)t;
    dydt[0] = rate * y[1];
    dydt[1] = -rate * y[0];
    return 0;
}

/* The warning comes where stability limits the step, and only there; the run goes on. */
static void test_stiffness(void)
{
    const vm_real times[2] = {4, 5};
    vm_real y0[1] = {0}, work[RK87_WORK(1)], rows[2], rate;
    rk45_options o = {0};
    rk45 s;
    int i;
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        rate = 1000;
        o.rtol = o.atol = R(1e-3);
        o.max_steps = 0;
        CHECK(m->init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(m->solve(&s, 5) == ODE_STIFF && s.t == 5 && ODE_STIFF > 0);
        CHECK(s.stiff && fabs((double)s.y[0] - cos(5.)) < 0.01 && m->solve(&s, 6) == ODE_OK);
        CHECK(m->init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(m->solve_at(&s, 2, times, rows, NULL) == ODE_STIFF && fabs((double)rows[1] - cos(5.)) < 0.01);
        rate = 1;
        o.max_steps = -1;
        CHECK(m->init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(m->solve(&s, 1000) == ODE_OK && !s.stiff);
    }
}

/* The search for stiffness counts a step inside the stability region only if it follows the last step at its edge. */
static void test_misses_of_stiffness(void)
{
    vm_real y0[1] = {0}, work[RK87_WORK(1)], rate = 1000;
    rk45_options o = {0};
    rk45 s;
    int i;
    o.rtol = o.atol = R(1e-3);
    for (i = 0; i < METHODS; i++) {
        int hits = 0, found = 0;
        CHECK(methods[i].init(&s, relaxation_rhs, &rate, 1, 0, y0, &o, work) == ODE_OK);
        while (!s.stiff && s.steps < 100000 && methods[i].step(&s) >= 0) {
            if (s.stiff_hits > hits) {
                CHECK(s.stiff_misses == 0);
                found = 1;
            }
            hits = s.stiff_hits;
        }
        CHECK(s.stiff && found);
    }
}

/* y' = -(y - 1 - slope t) + slope: y = 1 + slope t. The errors of the steps are rounding errors alone. */
static int nearly_constant_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real slope = *(const vm_real *)ctx;
    dydt[0] = -(y[0] - 1 - slope * t) + slope;
    return 0;
}

/* Rounding errors alone do not look stiff. */
static void test_stiffness_of_rounding(void)
{
    vm_real y0[1] = {1}, work[RK87_WORK(1)], slope = R(1e-8);
    rk45_options o = {0};
    rk45 s;
    o.h_max = R(1e-4);
    CHECK(rk45_init(&s, nearly_constant_rhs, &slope, 1, 0, y0, &o, work) == ODE_OK);
    CHECK(rk45_solve(&s, R(0.03)) == ODE_OK && !s.stiff);
}

/* No oscillator is stiff, however long its period. */
static void test_long_periods(void)
{
    const vm_real longest = VM_MAX / R(1e6);
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)], length;
    rk45_options o = {0};
    rk45 s;
    int i;
    o.rtol = o.atol = R(is_float ? 1e-4 : 1e-9);
    for (length = 1 / longest; length < longest / R(1e4); length *= R(1e4)) {
        vm_real rate = 1 / length;
        for (i = 0; i < METHODS; i++) {
            CHECK(methods[i].init(&s, slow_rhs, &rate, 2, 0, y0, &o, work) == ODE_OK);
            CHECK(methods[i].solve(&s, 300 * length) == ODE_OK);
            CHECK(s.steps > 100); /* enough for the search for stiffness to look at the run */
        }
    }
}

/* ---- Tolerances and options ---- */

static void test_defaults(void)
{
    const rk45_options o = rk45_defaults(NULL);
    CHECK(o.rtol == (is_float ? R(1e-4) : R(1e-6)) && fabs((double)(o.atol / o.rtol) - 1e-3) < 1e-9);
    CHECK(o.max_steps > 0 && o.h_max > 0);
}

/* A relative tolerance below what the type holds is raised, which the status says, and reached. */
static void test_least_tolerances(void)
{
    static const double least[METHODS] = {16, 256}, bounds[METHODS] = {110, 1000}; /* in eps */
    int i;
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        vm_real y0[1] = {1}, work[RK87_WORK(1)];
        rk45_options o = rk45_defaults(NULL);
        rk45 s;
        o.rtol = VM_EPSILON;
        o.atol = -1;
        CHECK(m->init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_RTOL_RAISED && ODE_RTOL_RAISED > 0);
        CHECK(s.options.rtol == R(least[i]) * VM_EPSILON && s.options.atol == 0 && m->solve(&s, 2) == ODE_OK);
        check_error("least rtol", m->name, "eps", fabs((double)s.y[0] / exp(4.) - 1) / eps, bounds[i], 2, 0);
        s.options.rtol = VM_EPSILON; /* the options may be those of the run itself */
        CHECK(m->init(&s, time_rhs, NULL, 1, 0, y0, &s.options, work) == ODE_RTOL_RAISED);
    }
}

static long evaluations_with(const vm_real *atol_each)
{
    vm_real y0[3] = {1, 0, 0}, work[RK45_WORK(3)];
    rk45_options o = {0};
    rk45 s;
    o.rtol = -1;
    o.atol_each = atol_each;
    CHECK(rk45_init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 30) == ODE_OK);
    return s.evals;
}

/* Each component has its own tolerance: a loose one for all components that move makes longer steps than a tight one,
   also if only one of them has that. */
static void test_atol_each(void)
{
    static const vm_real loose[3] = {R(1e-2), R(1e-2), R(1e-5)}, tight[3] = {R(1e-5), R(1e-5), R(1e-5)};
    static const vm_real tight_for_one[3] = {R(1e-5), 1, 1};
    const long few = evaluations_with(loose);
    vm_real y0[1] = {1}, work[RK45_WORK(1)], each[1] = {R(1e-3)};
    rk45_options o = rk45_defaults(NULL);
    rk45 s;
    CHECK(evaluations_with(tight) > 2 * few);
    CHECK(evaluations_with(tight_for_one) > 2 * few);
    o.rtol = -1;
    o.atol = 0;
    o.atol_each = each;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    check_error("atol_each", "y = exp(t^2)", "tol", fabs((double)s.y[0] - exp(1.)) / 1e-3, 5, 1, 0);
}

/* A work array that is too short is refused where its length is given. */
static void test_work_size(void)
{
    vm_real y0[2] = {1, 0}, work[RK87_WORK(2)];
    rk45_options o = {0};
    rk45 s;
    o.work_size = 8;
    CHECK(rk45_init(&s, cubic_rhs, NULL, 2, 0, y0, &o, work) == ODE_WORK_TOO_SMALL);
    o.work_size = RK45_WORK(2);
    CHECK(rk45_init(&s, cubic_rhs, NULL, 2, 0, y0, &o, work) == ODE_OK);
    CHECK(rk87_init(&s, cubic_rhs, NULL, 2, 0, y0, &o, work) == ODE_WORK_TOO_SMALL);
    o.work_size = (long)(sizeof work / sizeof *work);
    CHECK(rk87_init(&s, cubic_rhs, NULL, 2, 0, y0, &o, work) == ODE_OK);
    o.work_size = -1;
    CHECK(rk45_init(&s, cubic_rhs, NULL, 2, 0, y0, &o, work) == ODE_WORK_TOO_SMALL);
    CHECK(strstr(ode_strerror(ODE_WORK_TOO_SMALL), "RK45_WORK") != NULL);
}

/* ---- Refusals ---- */

/* A refused call leaves the state as it is. */
static void refused_options(const rk45_options *o, const vm_real *y0)
{
    vm_real work[RK45_WORK(2)];
    rk45 s, before;
    memset(&s, 5, sizeof s);
    before = s;
    CHECK(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, o, work) == ODE_BAD_ARGUMENT);
    CHECK(same_bytes(&s, &before, sizeof s));
}

static void refused_start(ode_rhs f, int n, vm_real t0, const vm_real *y0, vm_real *work)
{
    rk45 s, before;
    memset(&s, 5, sizeof s);
    before = s;
    CHECK(rk45_init(&s, f, NULL, n, t0, y0, NULL, work) == ODE_BAD_ARGUMENT);
    CHECK(same_bytes(&s, &before, sizeof s));
}

static void test_refused_starts(void)
{
    const vm_real good[2] = {1, 0}, bad[2] = {1, VM_NAN};
    vm_real work[RK45_WORK(2)];
    refused_start(linear_rhs, 0, 0, good, work);
    refused_start(linear_rhs, -3, 0, good, work);
    refused_start(NULL, 2, 0, good, work);
    refused_start(linear_rhs, 2, 0, NULL, work);
    refused_start(linear_rhs, 2, 0, good, NULL);
    refused_start(linear_rhs, 2, 0, bad, work);
    refused_start(linear_rhs, 2, VM_INFINITY, good, work);
}

static void test_refused_options(void)
{
    const vm_real y0[2] = {1, 0};
    const rk45_options none = {0};
    vm_real each[2] = {1, VM_NAN};
    rk45_options o = none;
    o.rtol = o.atol = -1; /* no tolerance at all */
    refused_options(&o, y0);
    o = none;
    o.rtol = VM_NAN;
    refused_options(&o, y0);
    o = none;
    o.atol = VM_INFINITY;
    refused_options(&o, y0);
    o = none;
    o.h0 = VM_NAN;
    refused_options(&o, y0);
    o = none;
    o.h_max = -1;
    refused_options(&o, y0);
    o = none;
    o.h_min = R(-1e-3);
    refused_options(&o, y0);
    o.h_min = 1;
    o.h_max = R(0.5);
    refused_options(&o, y0);
    o = none;
    o.atol_each = each;
    refused_options(&o, y0);
    each[1] = -1;
    refused_options(&o, y0);
    each[1] = 0;
    o.rtol = -1; /* no tolerance for one component */
    refused_options(&o, y0);
}

/* A state without a method, that of the other method, another f or n than it was made for, and a time that is none */
static void test_refused_runs(void)
{
    vm_real y0[2] = {1, 0}, y[2], work[RK45_WORK(2)];
    rk45 s, before;
    CHECK(rk45_solve(NULL, 1) == ODE_BAD_ARGUMENT && rk45_step(NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk87_solve(NULL, 1) == ODE_BAD_ARGUMENT && rk87_step(NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk45_init(&s, linear_rhs, NULL, 2, 0, y0, NULL, work) == ODE_OK);
    before = s;
    CHECK(rk87_solve(&s, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk87_step(&s) == ODE_BAD_ARGUMENT);
    CHECK(rk87_interpolate(&s, 0, y) == ODE_BAD_ARGUMENT);
    CHECK(rk45_solve_with(&s, time_rhs, 2, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk45_solve_with(&s, linear_rhs, 3, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk45_solve(&s, VM_NAN) == ODE_BAD_ARGUMENT);
    CHECK(same_bytes(&s, &before, sizeof s));
}

/* ---- Runs that end early, and go on ---- */

/* f ends at t = 1, by a refusal or by NaN: the run goes up to there, and keeps the last good state. */
static void test_wall(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)];
    wall w = {1, 0};
    rk45 s;
    for (w.use_nan = 0; w.use_nan < 2; w.use_nan++) {
        CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK);
        CHECK(rk45_solve(&s, 5) == (w.use_nan ? ODE_NOT_FINITE : ODE_RHS_STOPPED));
        CHECK(s.t < 1 && s.rhs_status == (w.use_nan ? 0 : 7));
        check_error("y before the end", "f stops", "tol",
                    fabs((double)s.y[0] * exp((double)s.t) - 1) / (is_float ? 1e-4 : 1e-6), 0.3, (double)s.t,
                    w.use_nan);
        if (w.use_nan) CHECK((double)s.t > 1 - 100 * eps); /* steps were shortened up to the end of f */
    }
}

/* f ends at once, at the evaluation that chooses the first step, and within the first step. */
static void test_wall_at_the_start(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)];
    rk45_options o = {0};
    wall w = {-1, 1};
    rk45 s;
    CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK && rk45_step(&s) == ODE_NOT_FINITE);
    CHECK(s.t == 0 && s.y[0] == 1 && s.steps == 0);
    w.use_nan = 0;
    CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK && rk45_step(&s) == ODE_RHS_STOPPED);
    w.at = R(1e-12);
    CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, NULL, work) == ODE_OK && rk45_step(&s) == ODE_RHS_STOPPED);
    o.h0 = R(0.1);
    for (w.at = R(0.001); w.at < R(0.1); w.at += R(0.004)) {
        CHECK(rk45_init(&s, wall_rhs, &w, 1, 0, y0, &o, work) == ODE_OK);
        CHECK(rk45_step(&s) == ODE_RHS_STOPPED && s.t == 0);
    }
}

/* y' = 1 up to t = 1, where f refuses with status -3 */
static int refusing_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)y;
    (void)ctx;
    dydt[0] = 1;
    return t > 1 ? -3 : 0;
}

static void test_refusing_rhs(void)
{
    vm_real y0[1] = {5}, work[RK45_WORK(1)];
    rk45 s;
    CHECK(rk45_init(&s, refusing_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
    CHECK(rk45_solve(&s, 2) == ODE_RHS_STOPPED && s.rhs_status == -3 && s.t <= 1);
    CHECK(rk45_init(&s, refusing_rhs, NULL, 1, R(0.9999), y0, NULL, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
}

static int growing_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    dydt[0] = VM_MAX / 100;
    return 0;
}

/* A state that would become infinite, while its derivative does not, ends the run. */
static void test_overflow(void)
{
    vm_real y0[1] = {5}, work[RK45_WORK(1)];
    rk45 s;
    CHECK(rk45_init(&s, growing_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK && rk45_solve(&s, 1000) < 0);
    CHECK(VM_IS_FINITE(s.y[0]) && s.t > 20 && s.t < 101);
}

/* A run that is interrupted after each three steps and continued has the bits of one run. */
static void test_interrupted(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)], wanted;
    rk45_options o = {0};
    rk45 s, again;
    int k = 0;
    o.max_steps = 3;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK);
    while (k < 1000 && rk45_solve(&s, 2) == ODE_MAX_STEPS) k++;
    wanted = s.y[0];
    CHECK(s.t == 2 && k > 0 && rk45_solve(&s, 2) == ODE_OK);
    o.max_steps = -1;
    CHECK(rk45_init(&again, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK && rk45_solve(&again, 2) == ODE_OK);
    CHECK(again.y[0] == wanted && again.steps == s.steps && again.evals == s.evals);
}

/* A run to the time where it is succeeds without an evaluation; rk45_step goes backward where h0 is negative. */
static void test_no_time_and_backward(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)];
    rk45_options o = {0};
    rk45 s;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 2, y0, NULL, work) == ODE_OK);
    CHECK(rk45_solve(&s, 2) == ODE_OK && s.evals == 0);
    o.h0 = R(-0.01);
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 2, y0, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK && s.t < 2);
    CHECK(strcmp(ode_strerror(ODE_MAX_STEPS), ode_strerror(-99)) != 0);
}

/* Counts of steps and evaluations stop at LONG_MAX; the run goes on as before. */
static void test_largest_counts(void)
{
    vm_real y0[1] = {1}, work[RK45_WORK(1)], wanted;
    rk45 s;
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK && rk45_solve(&s, 2) == ODE_OK);
    wanted = s.y[0];
    CHECK(rk45_init(&s, time_rhs, NULL, 1, 0, y0, NULL, work) == ODE_OK);
    s.steps = s.rejected = LONG_MAX;
    s.evals = LONG_MAX - 3;
    CHECK(rk45_solve(&s, 2) == ODE_OK && s.y[0] == wanted);
    CHECK(s.steps == LONG_MAX && s.rejected == LONG_MAX && s.evals == LONG_MAX);
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
    test_arenstorf();
    test_step_sizes();
    test_extreme_times();
    test_low_word_of_time();
    test_first_steps();
    test_rejected_steps();
    test_step_of_nan();
    test_end_differences();
    test_power();
    test_clock();
    test_unresolvable_jumps();
    test_middle_slope();
    test_pole_at_jump();
    test_missed_step_taken_back();
    test_thresholds();
    test_least_step();
    test_intervals_of_few_ulps();
    test_unresolvable_points();
    test_missed_at_stiffness_test();
    test_blow_up_with_h_min();
    test_stiffness();
    test_misses_of_stiffness();
    test_stiffness_of_rounding();
    test_long_periods();
    test_defaults();
    test_least_tolerances();
    test_atol_each();
    test_work_size();
    test_refused_starts();
    test_refused_options();
    test_refused_runs();
    test_wall();
    test_wall_at_the_start();
    test_refusing_rhs();
    test_overflow();
    test_interrupted();
    test_no_time_and_backward();
    test_largest_counts();
    test_reentrancy();
    return check_finish("adaptive");
}
