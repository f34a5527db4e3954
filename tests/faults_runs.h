/* faults_runs.h - what faults_integrators.h leaves out: states too long for registers, runs backward, steps and rows
   with events, the continuous extension, the search for turning points in a step, restarts and saved runs, all with
   functions of a user that fail */
#ifndef FAULTS_RUNS_H
#define FAULTS_RUNS_H

#include "faults_integrators.h"

/* Six oscillators, each slower than the one before, as y = (x_1, ..., x_6, x_1', ..., x_6'). The compiler keeps only
   states of at most eight numbers in registers. */
enum { FAULT_LONG = 12 };

static inline int faulty_chain(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const int strikes = fault_strikes(), half = FAULT_LONG / 2;
    int i;
    (void)t;
    (void)ctx;
    for (i = 0; i < half; i++) {
        dydt[i] = fault_value(strikes, y[half + i]);
        dydt[half + i] = fault_value(strikes, -y[i] / (vm_real)(i + 1));
    }
    return fault_status(strikes);
}

static inline void fault_chain_start(vm_real *y)
{
    int i;
    for (i = 0; i < FAULT_LONG; i++) y[i] = R(0.125) * (vm_real)(i + 1);
}

/* ---- rk4 ---- */

/* Six steps, backward from 1.5 to 0. After an error the run goes on from the last complete step. */
static inline void fault_rk4_long(outcome *o, int compensated)
{
    const long steps = 6;
    vm_real y[FAULT_LONG], low[FAULT_LONG] = {0}, work[RK4_WORK(FAULT_LONG)], t = R(1.5);
    long left = steps;
    int i;
    fault_chain_start(y);
    for (i = 0; i < 2 && left > 0; i++) {
        if (compensated) o->again = rk4_solve_compensated(faulty_chain, NULL, FAULT_LONG, &t, 0, left, y, low, work);
        else o->again = rk4_solve(faulty_chain, NULL, FAULT_LONG, &t, 0, left, y, work);
        if (i == 0) o->status = o->again;
        left = (long)(t * 4);
        o->sound = o->sound && t == (vm_real)left / 4 && vmi_all_finite(FAULT_LONG, y);
    }
    o->result = (double)fault_sum(FAULT_LONG, y) + (double)fault_sum(FAULT_LONG, low);
}
static inline void fault_rk4_long_solve(outcome *o) { fault_rk4_long(o, 0); }
static inline void fault_rk4_long_compensated(outcome *o) { fault_rk4_long(o, 1); }

/* ---- rk45 and rk87: a long state, backward from 2 to 0 ---- */

static inline void fault_backward(outcome *o, const fault_method *m)
{
    vm_real y0[FAULT_LONG], work[RK87_WORK(FAULT_LONG)];
    rk45_options options;
    rk45 s;
    int i;
    memset(&options, 0, sizeof options);
    options.rtol = R(1e-5);
    fault_chain_start(y0);
    m->init(&s, faulty_chain, NULL, FAULT_LONG, 2, y0, &options, work);
    o->status = o->again = m->solve(&s, 0);
    for (i = 0; i < FAULT_MOST_CALLS && o->again < 0; i++) {
        o->sound = o->sound && s.t >= 0 && s.t <= 2 && vmi_all_finite(FAULT_LONG, s.y);
        o->again = m->solve(&s, 0);
    }
    o->result = (double)fault_sum(FAULT_LONG, s.y);
}
static inline void fault_rk45_backward(outcome *o) { fault_backward(o, &fault_rk45); }
static inline void fault_rk87_backward(outcome *o) { fault_backward(o, &fault_rk87); }

/* ---- The continuous extension ---- */

/* Single steps beyond t = 1, then the state there. A step that steps over a NaN is shorter. */
static inline void fault_interpolate(outcome *o, const fault_method *m, int (*inside)(rk45 *s, vm_real t, vm_real *y))
{
    vm_real y[FAULT_N] = {FAULT_UNTOUCHED, FAULT_UNTOUCHED};
    fault_ode r;
    int calls, status;
    memset(&r, 0, sizeof r);
    fault_begin(m, &r, faulty_rhs, 0);
    for (calls = 0; calls < 200 && r.s.t < 1; calls++) {
        status = m->step(&r.s);
        if (status < 0) o->status = status;
        o->sound = o->sound && fault_ode_is_sound(&r, 10);
    }
    o->again = inside(&r.s, 1, y);
    if (o->again < 0) {
        o->status = o->again;
        o->sound = o->sound && y[0] == FAULT_UNTOUCHED && y[1] == FAULT_UNTOUCHED;
        o->again = inside(&r.s, 1, y);
    }
    o->result = (double)fault_sum(FAULT_N, y);
    status = m->solve(&r.s, 3); /* the run goes on from the last step */
    if (status < 0 && o->status == 0) o->status = status;
    if (status < 0) status = m->solve(&r.s, 3);
    if (status < 0) o->again = status;
    o->result += (double)fault_sum(FAULT_N, r.s.y);
}
static inline int fault_inside_45(rk45 *s, vm_real t, vm_real *y) { return rk45_interpolate(s, t, y); }
static inline int fault_inside_87(rk45 *s, vm_real t, vm_real *y) { return rk87_interpolate(s, t, y); }
static inline void fault_rk45_interpolate(outcome *o) { fault_interpolate(o, &fault_rk45, fault_inside_45); }
static inline void fault_rk87_interpolate(outcome *o) { fault_interpolate(o, &fault_rk87, fault_inside_87); }

/* Turning points and zero crossings in steps of rk87. The right-hand side fails only in the search, where rk87
   evaluates it for the continuous extension. Another search in the same step finds the points, and the run goes on. */
static inline long fault_search(rk45 *s, int kind, vm_real *sum)
{
    vm_real buffer[FAULT_N];
    vm_sample samples[4];
    long found, i;
    fault_fill(FAULT_N, buffer);
    found = vm_find_samples_of_step(s, 0, 1, kind, buffer, 4, samples);
    for (i = 0; i < found && i < 4; i++) *sum += samples[i].t + samples[i].x + samples[i].v;
    return found;
}
static inline void fault_samples_of_steps(outcome *o)
{
    vm_real sum = 0;
    fault_ode r;
    int calls, kind;
    memset(&r, 0, sizeof r);
    fault_begin(&fault_rk87, &r, faulty_rhs, 0);
    for (calls = 0; calls < 200 && r.s.t < 5; calls++) {
        const struct fault_now before = fault_hold();
        if (rk87_step(&r.s) < 0) o->sound = 0;
        fault = before;
        for (kind = VM_TURNING_POINTS; kind <= VM_ZERO_CROSSINGS; kind++) {
            long found = fault_search(&r.s, kind, &sum);
            if (found < 0) o->status = (int)found;
            if (found < 0) found = fault_search(&r.s, kind, &sum);
            if (found < 0) o->again = (int)found;
        }
    }
    o->sound = o->sound && fault_ode_is_sound(&r, 10);
    o->result = (double)sum + (double)fault_sum(FAULT_N, r.s.y);
}

/* ---- Events in single steps and with rows ---- */

enum { FAULT_ROOM = 8 };

/* An oscillator that is followed to t = 9, with an event that is recorded with its states, and one that halves the
   velocity. g is the function of both. */
typedef struct fault_recorded {
    fault_ode ode;
    vm_real times[FAULT_ROOM], states[FAULT_ROOM * FAULT_N];
} fault_recorded;

static inline void fault_begin_recorded(const fault_method *m, fault_recorded *r, ode_rhs f)
{
    memset(r, 0, sizeof *r);
    r->ode.options.h_max = R(0.5);
    r->ode.events[0].g = faulty_velocity;
    r->ode.events[0].room = FAULT_ROOM;
    r->ode.events[0].times = r->times;
    r->ode.events[0].states = r->states;
    r->ode.events[1].g = faulty_position;
    r->ode.events[1].direction = -1;
    r->ode.events[1].action = ODE_RESTART;
    r->ode.events[1].change = fault_halve;
    fault_begin(m, &r->ode, f, 2);
}

/* A number that depends on what the events have recorded and on the state at the end */
static inline double fault_sum_of_records(const fault_recorded *r)
{
    const int n = (int)r->ode.events[0].count;
    double sum = 100 * (double)n + 1000 * (double)r->ode.events[1].count;
    if (n > FAULT_ROOM) return -1;
    return sum + (double)fault_sum(n, r->times) + (double)fault_sum(n * FAULT_N, r->states);
}

/* Single short steps to t = 8, and a run to t = 9. After an error the next call goes on. */
static inline void fault_event_steps(outcome *o, const fault_method *m, ode_rhs f)
{
    fault_recorded r;
    int calls;
    fault_begin_recorded(m, &r, f);
    for (calls = 0; calls < 1000 && r.ode.s.t < 9; calls++) {
        if (r.ode.s.t < 8) o->again = m->step(&r.ode.s);
        else o->again = m->solve(&r.ode.s, 9);
        if (o->again < 0 && o->status == 0) o->status = o->again;
        o->sound = o->sound && fault_ode_is_sound(&r.ode, 9);
    }
    o->result = fault_sum_of_records(&r);
}
static inline void fault_rk45_event_steps(outcome *o) { fault_event_steps(o, &fault_rk45, sound_rhs); }
static inline void fault_rk87_event_steps(outcome *o) { fault_event_steps(o, &fault_rk87, sound_rhs); }
static inline void fault_rk45_steps_both(outcome *o) { fault_event_steps(o, &fault_rk45, faulty_rhs); }
static inline void fault_rk87_steps_both(outcome *o) { fault_event_steps(o, &fault_rk87, faulty_rhs); }

/* Rows at listed times. After an error the call goes on with the times that are left. */
static inline void fault_event_rows(outcome *o, const fault_method *m, ode_rhs f)
{
    static const vm_real times[6] = {0, R(1.5), 3, R(4.5), 6, 9};
    vm_real rows[6 * FAULT_N];
    fault_recorded r;
    int done = 0, calls, more;
    fault_begin_recorded(m, &r, f);
    for (calls = 0; calls < FAULT_MOST_CALLS && done < 6; calls++) {
        o->again = m->solve_at(&r.ode.s, 6 - done, times + done, rows + done * FAULT_N, &more);
        if (o->status == 0) o->status = o->again;
        done += more;
        o->sound = o->sound && fault_ode_is_sound(&r.ode, 9) && vmi_all_finite(done * FAULT_N, rows);
    }
    if (done < 6) o->again = -1;
    o->result = fault_sum_of_records(&r) + (double)fault_sum(6 * FAULT_N, rows);
}
static inline void fault_rk45_event_rows(outcome *o) { fault_event_rows(o, &fault_rk45, sound_rhs); }
static inline void fault_rk87_event_rows(outcome *o) { fault_event_rows(o, &fault_rk87, sound_rhs); }
static inline void fault_rk45_rows_both(outcome *o) { fault_event_rows(o, &fault_rk45, faulty_rhs); }
static inline void fault_rk87_rows_both(outcome *o) { fault_event_rows(o, &fault_rk87, faulty_rhs); }

/* ---- Events whose `change` writes NaN ---- */

/* The velocity after each zero of the position */
#define FAULT_VELOCITY R(-0.75)

static inline vm_real sound_position(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}
static inline vm_real sound_velocity(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1];
}
static inline void faulty_change(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[1] = fault_value(fault_strikes(), FAULT_VELOCITY);
}

/* Four ways to t = 9: each of them goes on from the present time of the run. */
static inline int fault_go_by_steps(const fault_method *m, rk45 *s)
{
    int status = ODE_OK;
    while (s->t < 8 && status >= 0) status = m->step(s);
    return status < 0 ? status : m->solve(s, 9);
}
static inline int fault_go(const fault_method *m, rk45 *s) { return m->solve(s, 9); }
static inline int fault_go_with(const fault_method *m, rk45 *s)
{
    if (m == &fault_rk45) return rk45_solve_with(s, sound_rhs, FAULT_N, 9);
    return rk87_solve_with(s, sound_rhs, FAULT_N, 9);
}
static inline int fault_go_by_rows(const fault_method *m, rk45 *s)
{
    static const vm_real times[3] = {3, 6, 9};
    vm_real rows[3 * FAULT_N];
    int first = 0;
    while (first < 2 && times[first] < s->t) first++;
    return m->solve_at(s, 3 - first, times + first, rows, NULL);
}

/* The run of fault_recorded, but the second event sets the velocity at every zero of the position, and only its
   function `change` fails. Where this function writes NaN, the run ends at the time of the event, and is then restarted
   with the right velocity. */
static inline void fault_change(outcome *o, const fault_method *m, int (*go)(const fault_method *m, rk45 *s))
{
    fault_recorded r;
    int calls;
    fault_begin_recorded(m, &r, sound_rhs);
    r.ode.events[0].g = sound_velocity;
    r.ode.events[1].g = sound_position;
    r.ode.events[1].direction = 0;
    r.ode.events[1].change = faulty_change;
    o->status = o->again = go(m, &r.ode.s);
    for (calls = 0; calls < FAULT_MOST_CALLS && o->again < 0; calls++) {
        const vm_real y[FAULT_N] = {r.ode.s.y[0], FAULT_VELOCITY}, t = r.ode.s.t;
        int restarted;
        o->sound = o->sound && t > 0 && t < 9 && t == r.ode.events[1].t && r.ode.s.y[1] != r.ode.s.y[1];
        if (m == &fault_rk45) restarted = rk45_restart(&r.ode.s, t, y);
        else restarted = rk87_restart(&r.ode.s, t, y);
        o->sound = o->sound && restarted == ODE_OK;
        o->again = go(m, &r.ode.s);
    }
    o->result = fault_sum_of_records(&r) + (double)fault_sum(FAULT_N, r.ode.s.y);
}
static inline void fault_rk45_change_step(outcome *o) { fault_change(o, &fault_rk45, fault_go_by_steps); }
static inline void fault_rk87_change_step(outcome *o) { fault_change(o, &fault_rk87, fault_go_by_steps); }
static inline void fault_rk45_change(outcome *o) { fault_change(o, &fault_rk45, fault_go); }
static inline void fault_rk87_change(outcome *o) { fault_change(o, &fault_rk87, fault_go); }
static inline void fault_rk45_change_with(outcome *o) { fault_change(o, &fault_rk45, fault_go_with); }
static inline void fault_rk87_change_with(outcome *o) { fault_change(o, &fault_rk87, fault_go_with); }
static inline void fault_rk45_change_rows(outcome *o) { fault_change(o, &fault_rk45, fault_go_by_rows); }
static inline void fault_rk87_change_rows(outcome *o) { fault_change(o, &fault_rk87, fault_go_by_rows); }

/* ---- Restarts and saved runs ---- */

/* After an error the run is restarted from its own time and state. */
static inline void fault_restart(outcome *o, const fault_method *m,
                                 int (*restart)(rk45 *s, vm_real t, const vm_real *y))
{
    fault_ode r;
    int i;
    memset(&r, 0, sizeof r);
    fault_begin(m, &r, faulty_rhs, 0);
    o->status = o->again = m->solve(&r.s, 3);
    for (i = 0; i < FAULT_MOST_CALLS && o->again < 0; i++) {
        o->sound = o->sound && restart(&r.s, r.s.t, r.s.y) == ODE_OK;
        o->again = m->solve(&r.s, 3);
    }
    o->result = (double)fault_sum(FAULT_N, r.s.y);
}
static inline void fault_rk45_restart(outcome *o) { fault_restart(o, &fault_rk45, rk45_restart); }
static inline void fault_rk87_restart(outcome *o) { fault_restart(o, &fault_rk87, rk87_restart); }

/* After an error the run is saved and resumed in another rk45, which has the bits of the run itself. */
static inline void fault_saved(outcome *o, const fault_method *m)
{
    unsigned char bytes[RK87_SAVED(FAULT_N, 2)];
    fault_recorded r, other;
    int i;
    fault_begin_recorded(m, &r, faulty_rhs);
    o->status = o->again = m->solve(&r.ode.s, 9);
    for (i = 0; i < FAULT_MOST_CALLS && o->again < 0; i++) {
        int status;
        fault_begin_recorded(m, &other, faulty_rhs);
        memcpy(other.times, r.times, sizeof r.times);
        memcpy(other.states, r.states, sizeof r.states);
        if (m == &fault_rk45) status = rk45_save(&r.ode.s, sizeof bytes, bytes);
        else status = rk87_save(&r.ode.s, sizeof bytes, bytes);
        if (m == &fault_rk45) status += rk45_resume(&other.ode.s, sizeof bytes, bytes);
        else status += rk87_resume(&other.ode.s, sizeof bytes, bytes);
        o->again = m->solve(&r.ode.s, 9);
        o->sound = o->sound && status == 0 && m->solve(&other.ode.s, 9) == o->again;
        o->sound = o->sound && fault_sum_of_records(&other) == fault_sum_of_records(&r);
    }
    o->result = fault_sum_of_records(&r);
}
static inline void fault_rk45_saved(outcome *o) { fault_saved(o, &fault_rk45); }
static inline void fault_rk87_saved(outcome *o) { fault_saved(o, &fault_rk87); }

static const scenario fault_runs[] = {
    FAULT_OF_RUN("rk4_solve, 12 numbers", fault_rk4_long_solve, FAULT_ALL, 0),
    FAULT_OF_RUN("rk4_compensated, 12", fault_rk4_long_compensated, FAULT_ALL, 0),
    FAULT_OF_RUN("rk45_solve, backward", fault_rk45_backward, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk87_solve, backward", fault_rk87_backward, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk45_solve, backward", fault_rk45_backward, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve, backward", fault_rk87_backward, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_interpolate", fault_rk45_interpolate, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk87_interpolate", fault_rk87_interpolate, FAULT_STATUS + FAULT_BOTH, 0),
    FAULT_OF_RUN("rk45_interpolate", fault_rk45_interpolate, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_interpolate", fault_rk87_interpolate, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_step, event g", fault_rk45_event_steps, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_step, event g", fault_rk87_event_steps, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_step, f and g", fault_rk45_steps_both, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_step, f and g", fault_rk87_steps_both, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve_at, event g", fault_rk45_event_rows, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve_at, event g", fault_rk87_event_rows, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve_at, f and g", fault_rk45_rows_both, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve_at, f and g", fault_rk87_rows_both, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_step, change", fault_rk45_change_step, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_step, change", fault_rk87_change_step, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve, change", fault_rk45_change, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve, change", fault_rk87_change, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve_with, change", fault_rk45_change_with, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve_with, change", fault_rk87_change_with, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk45_solve_at, change", fault_rk45_change_rows, FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_solve_at, change", fault_rk87_change_rows, FAULT_NAN, FAULT_STEPS),
    {"vm_find_samples_of_step", fault_samples_of_steps, {FAULT_ALL, VM_NOT_FINITE, VM_NOT_FINITE, 0, 0, 0}, NULL, NULL},
    FAULT_OF_RUN("rk45_restart", fault_rk45_restart, FAULT_ALL, FAULT_STEPS),
    FAULT_OF_RUN("rk87_restart", fault_rk87_restart, FAULT_ALL, FAULT_STEPS),
    FAULT_OF_RUN("rk45_save, rk45_resume", fault_rk45_saved, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
    FAULT_OF_RUN("rk87_save, rk87_resume", fault_rk87_saved, FAULT_STATUS + FAULT_NAN, FAULT_STEPS),
};

#endif
