/* faults_integrators.h - rk4, rk45 and rk87 with right-hand sides and event functions that fail */
#ifndef FAULTS_INTEGRATORS_H
#define FAULTS_INTEGRATORS_H

#include "faults.h"

enum { FAULT_N = 2, FAULT_MOST_CALLS = 5 };

/* x'' = -x^3, as y = (x, x') */
static inline int faulty_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const int strikes = fault_strikes();
    (void)t;
    (void)ctx;
    dydt[0] = fault_value(strikes, y[1]);
    dydt[1] = fault_value(strikes, -y[0] * y[0] * y[0]);
    return fault_status(strikes);
}

/* The same right-hand side, without faults */
static inline int sound_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

/* ---- rk4 ---- */

static inline void fault_rk4_step(outcome *o)
{
    vm_real y[FAULT_N] = {1, R(0.5)}, work[RK4_WORK(FAULT_N)];
    o->status = o->again = rk4_step(faulty_rhs, NULL, FAULT_N, 0, R(0.1), y, work);
    if (o->status) {
        o->sound = y[0] == 1 && y[1] == R(0.5);
        o->again = rk4_step(faulty_rhs, NULL, FAULT_N, 0, R(0.1), y, work);
    }
    o->result = (double)fault_sum(FAULT_N, y);
}

/* Six steps from 0 to 1.5, each of a size that the type can hold. After an error the run goes on from the last complete
   step, with the steps that are left. */
static inline void fault_rk4_solve_with(outcome *o, int compensated)
{
    const long steps = 6;
    vm_real y[FAULT_N] = {1, R(0.5)}, low[FAULT_N] = {0, 0}, work[RK4_WORK(FAULT_N)], t = 0;
    long left = steps;
    int i;
    for (i = 0; i < 2 && left > 0; i++) {
        if (compensated) o->again = rk4_solve_compensated(faulty_rhs, NULL, FAULT_N, &t, R(1.5), left, y, low, work);
        else o->again = rk4_solve(faulty_rhs, NULL, FAULT_N, &t, R(1.5), left, y, work);
        if (i == 0) o->status = o->again;
        left = steps - (long)(t * 4);
        o->sound = o->sound && t == (vm_real)(steps - left) / 4 && vmi_all_finite(FAULT_N, y);
    }
    o->result = (double)fault_sum(FAULT_N, y) + (double)fault_sum(FAULT_N, low);
}
static inline void fault_rk4_solve(outcome *o) { fault_rk4_solve_with(o, 0); }
static inline void fault_rk4_solve_compensated(outcome *o) { fault_rk4_solve_with(o, 1); }

/* ---- rk45 and rk87 ---- */

typedef struct fault_method {
    int (*init)(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0, const rk45_options *o,
                vm_real *work);
    int (*step)(rk45 *s);
    int (*solve)(rk45 *s, vm_real t_end);
    int (*solve_at)(rk45 *s, int n_times, const vm_real *times, vm_real *rows, int *n_done_or_NULL);
} fault_method;
static const fault_method fault_rk45 = {rk45_init, rk45_step, rk45_solve, rk45_solve_at};
static const fault_method fault_rk87 = {rk87_init, rk87_step, rk87_solve, rk87_solve_at};

/* An adaptive run with its arrays, and what is needed to see whether it is sound after an error */
typedef struct fault_ode {
    rk45 s;
    rk45_options options;
    ode_event events[3];
    vm_real work[RK87_WORK(FAULT_N)];
} fault_ode;

static inline void fault_begin(const fault_method *m, fault_ode *r, ode_rhs f, int n_events)
{
    const vm_real y0[FAULT_N] = {1, R(0.5)};
    r->options.rtol = R(1e-5);
    r->options.events = r->events;
    r->options.n_events = n_events;
    m->init(&r->s, f, NULL, FAULT_N, 0, y0, &r->options, r->work);
}

/* After an error, time and state are those of an accepted step. */
static inline int fault_ode_is_sound(const fault_ode *r, vm_real t_end)
{
    return r->s.t >= 0 && r->s.t <= t_end && vmi_all_finite(FAULT_N, r->s.y);
}

static inline void fault_solve(outcome *o, const fault_method *m)
{
    const vm_real t_end = 3;
    fault_ode r;
    int i;
    memset(&r, 0, sizeof r);
    fault_begin(m, &r, faulty_rhs, 0);
    o->status = o->again = m->solve(&r.s, t_end);
    for (i = 0; i < FAULT_MOST_CALLS && o->again < 0; i++) {
        o->sound = o->sound && fault_ode_is_sound(&r, t_end);
        o->again = m->solve(&r.s, t_end);
    }
    o->result = (double)fault_sum(FAULT_N, r.s.y);
}
static inline void fault_rk45_solve(outcome *o) { fault_solve(o, &fault_rk45); }
static inline void fault_rk87_solve(outcome *o) { fault_solve(o, &fault_rk87); }

static inline void fault_rk45_solve_with(outcome *o)
{
    fault_ode r;
    memset(&r, 0, sizeof r);
    fault_begin(&fault_rk45, &r, faulty_rhs, 0);
    o->status = o->again = rk45_solve_with(&r.s, faulty_rhs, FAULT_N, 3);
    if (o->again < 0) o->again = rk45_solve_with(&r.s, faulty_rhs, FAULT_N, 3);
    o->result = (double)fault_sum(FAULT_N, r.s.y);
}
static inline void fault_rk87_solve_with(outcome *o)
{
    fault_ode r;
    memset(&r, 0, sizeof r);
    fault_begin(&fault_rk87, &r, faulty_rhs, 0);
    o->status = o->again = rk87_solve_with(&r.s, faulty_rhs, FAULT_N, 3);
    if (o->again < 0) o->again = rk87_solve_with(&r.s, faulty_rhs, FAULT_N, 3);
    o->result = (double)fault_sum(FAULT_N, r.s.y);
}

/* Five accepted steps, and after an error the state in the middle of the last step */
static inline void fault_step(outcome *o, const fault_method *m)
{
    fault_ode r;
    int steps = 0, calls;
    memset(&r, 0, sizeof r);
    fault_begin(m, &r, faulty_rhs, 0);
    for (calls = 0; steps < 5 && calls < 5 + FAULT_MOST_CALLS; calls++) {
        o->again = m->step(&r.s);
        if (o->again < 0 && o->status == 0) o->status = o->again;
        o->sound = o->sound && fault_ode_is_sound(&r, 10);
        steps += o->again >= 0;
    }
    o->result = (double)fault_sum(FAULT_N, r.s.y) + (double)r.s.t;
}
static inline void fault_rk45_step(outcome *o) { fault_step(o, &fault_rk45); }
static inline void fault_rk87_step(outcome *o) { fault_step(o, &fault_rk87); }

/* Rows at listed times. After an error the call goes on with the times that are left. */
static inline void fault_solve_at(outcome *o, const fault_method *m)
{
    const vm_real times[5] = {0, R(0.5), 1, R(1.75), 2};
    vm_real rows[5 * FAULT_N];
    fault_ode r;
    int done = 0, i, k, more;
    memset(&r, 0, sizeof r);
    fault_begin(m, &r, faulty_rhs, 0);
    for (i = 0; i < FAULT_MOST_CALLS && done < 5; i++) {
        o->again = m->solve_at(&r.s, 5 - done, times + done, rows + done * FAULT_N, &more);
        if (o->status == 0) o->status = o->again;
        done += more;
        o->sound = o->sound && fault_ode_is_sound(&r, 2) && vmi_all_finite(done * FAULT_N, rows);
    }
    for (k = 0; k < done * FAULT_N; k++) o->result += (k + 1) * (double)rows[k];
}
static inline void fault_rk45_solve_at(outcome *o) { fault_solve_at(o, &fault_rk45); }
static inline void fault_rk87_solve_at(outcome *o) { fault_solve_at(o, &fault_rk87); }

/* ---- Events ---- */

static inline vm_real faulty_position(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return fault_value(fault_strikes(), y[0]);
}

static inline vm_real faulty_velocity(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return fault_value(fault_strikes(), y[1]);
}

static inline void fault_halve(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[1] /= 2;
}

/* A run with three events: the velocity's zeros are counted, the falling zeros of the position halve the velocity, and
   its third rising zero ends the run. `f` is the right-hand side. The counts belong to the result. */
static inline void fault_events(outcome *o, const fault_method *m, ode_rhs f)
{
    fault_ode r;
    int i;
    memset(&r, 0, sizeof r);
    r.events[0].g = faulty_velocity;
    r.events[1].g = faulty_position;
    r.events[1].direction = -1;
    r.events[1].action = ODE_RESTART;
    r.events[1].change = fault_halve;
    r.events[2].g = faulty_position;
    r.events[2].direction = 1;
    r.events[2].stop_after = 2;
    fault_begin(m, &r, f, 3);
    o->status = o->again = m->solve(&r.s, 100);
    for (i = 0; i < FAULT_MOST_CALLS && o->again < 0; i++) {
        o->sound = o->sound && fault_ode_is_sound(&r, 100);
        o->again = m->solve(&r.s, 100);
    }
    if (o->status == ODE_EVENT) o->status = ODE_OK;
    o->sound = o->sound && o->again == ODE_EVENT && r.s.event == 2;
    o->result = (double)r.s.t + 100 * (double)r.events[0].count + 1000 * (double)r.events[1].count;
}
static inline void fault_rk45_events(outcome *o) { fault_events(o, &fault_rk45, sound_rhs); }
static inline void fault_rk87_events(outcome *o) { fault_events(o, &fault_rk87, sound_rhs); }
static inline void fault_rk45_both(outcome *o) { fault_events(o, &fault_rk45, faulty_rhs); }
static inline void fault_rk87_both(outcome *o) { fault_events(o, &fault_rk87, faulty_rhs); }

/* A step over a NaN is shorter than the step would have been without it, so that the results differ within the
   tolerance, here 1e-5. */
#define FAULT_STEPS (3e-4 / (double)VM_EPSILON)

/* A run of an integrator, with the kinds of faults that its functions have and the difference of its results. Where an
   error may come from each of several functions, or a step may be shorter, they differ within the tolerance. */
#define FAULT_OF_RUN(name, run, kinds, difference) \
    {name, run, {kinds, ODE_RHS_STOPPED, ODE_NOT_FINITE, difference, 0, 0}, NULL, NULL}

static const scenario fault_integrators[] = {
    FAULT_OF_RUN("rk4_step", fault_rk4_step, FAULT_ALL, 0),
    FAULT_OF_RUN("rk4_solve", fault_rk4_solve, FAULT_ALL, 0),
    FAULT_OF_RUN("rk4_solve_compensated", fault_rk4_solve_compensated, FAULT_ALL, 0),
    FAULT_OF_RUN("rk45_step", fault_rk45_step, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk87_step", fault_rk87_step, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk45_solve", fault_rk45_solve, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk87_solve", fault_rk87_solve, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk45_solve_with", fault_rk45_solve_with, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk87_solve_with", fault_rk87_solve_with, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk45_solve_at", fault_rk45_solve_at, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk87_solve_at", fault_rk87_solve_at, FAULT_STATUS + FAULT_BOTH, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve", fault_rk45_solve, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve", fault_rk87_solve, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve_at", fault_rk45_solve_at, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve_at", fault_rk87_solve_at, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve, event g", fault_rk45_events, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve, event g", fault_rk87_events, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve, f and g", fault_rk45_both, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve, f and g", fault_rk87_both, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
};

#endif
