/* faults_flow.h - bodies with streams of mass, whose function `update` fails, alone and in runs of the integrators */
#ifndef FAULTS_FLOW_H
#define FAULTS_FLOW_H

#include "faults_integrators.h"
#include "valid_objects.h"

/* A right-hand side with the object that it needs, and a state */
typedef struct fault_system {
    ode_rhs f;
    int n;
    void *ctx;
    vm_real y[VM_FLOW_BALANCED_STATES];
    const int *status; /* NULL, or the object's field `status`, which an evaluation without a fault sets to VM_OK */
} fault_system;

/* ---- Single evaluations ---- */

/* An evaluation, and where it failed, a second one with the same object. An error leaves the derivatives; without one
   the fault shows as NaN in them. */
static inline void fault_evaluate(outcome *o, fault_system *s)
{
    vm_real dydt[VM_FLOW_BALANCED_STATES];
    int i;
    for (i = 0; i < s->n; i++) dydt[i] = FAULT_UNTOUCHED;
    o->status = o->again = s->f(1, s->y, dydt, s->ctx);
    if (o->status) o->sound = fault_is_untouched(s->n, dydt);
    if (o->status || !vmi_all_finite(s->n, dydt)) o->again = s->f(1, s->y, dydt, s->ctx);
    if (s->status && *s->status != VM_OK) o->sound = 0;
    o->result = (double)fault_sum(s->n, dydt);
}

/* ---- Runs ---- */

/* A run to t = 1, and on to t = 2. After an error the state is that of an accepted step, the number that the user's
   function has returned is in rhs_status, and another call goes on. */
static inline void fault_integrate(outcome *o, fault_system *s, const fault_method *m)
{
    vm_real work[RK87_WORK(VM_FLOW_BALANCED_STATES)], t_end = 1;
    rk45_options options;
    rk45 run;
    int calls;
    memset(&options, 0, sizeof options);
    options.rtol = R(1e-5);
    o->again = m->init(&run, s->f, s->ctx, s->n, 0, s->y, &options, work);
    for (calls = 0; calls < 2 + FAULT_MOST_CALLS && o->again >= 0 && run.t < 2; calls++) {
        o->again = m->solve(&run, t_end);
        if (o->again == ODE_RHS_STOPPED && run.rhs_status != (int)FAULT_NUMBER) o->sound = 0;
        o->sound = o->sound && run.t >= 0 && run.t <= t_end && vmi_all_finite(s->n, run.y);
        if (o->again < 0) o->status = o->again;
        if (o->again < 0) o->again = 0;
        else t_end = 2;
    }
    if (run.t != 2) o->again = -1;
    o->result = (double)fault_sum(s->n, run.y);
}

/* ---- A free body in space ---- */

static const vm_inertia fault_sizes = {2, R(2.5), 3, 0, 0, 0};

/* A nozzle whose rate and a force that depend on time and state; for the given laws also mass, mass centre, inertia
   and drift */
static inline int faulty_update(vm_real t, const vm_real *y, vm_flow *flow)
{
    const int strikes = fault_strikes();
    flow->force.x = fault_value(strikes, t / 2 - y[VM_Y_R]);
    flow->streams[0].rate = fault_value(strikes, R(-0.125) - t / 32);
    flow->mass = fault_value(strikes, 5 - t / 8);
    flow->centre.z = fault_value(strikes, t / 16);
    flow->drift.z = R(0.0625);
    flow->inertia = fault_sizes;
    flow->inertia.zz = fault_value(strikes, 3 - t / 8);
    return fault_status(strikes);
}

/* ---- Translation, a line, the plane ---- */

static inline int faulty_update1(vm_real t, const vm_real *y, vm_flow1 *flow)
{
    const int strikes = fault_strikes();
    flow->force = fault_value(strikes, t / 2 - y[VM_FLOW1_X]);
    flow->streams[0].rate = fault_value(strikes, R(-0.125) - t / 32);
    return fault_status(strikes);
}

static inline int faulty_update2(vm_real t, const vm_real *y, vm_flow2 *flow)
{
    const int strikes = fault_strikes();
    flow->fx = fault_value(strikes, t / 2 - y[VM_FLOW2_X]);
    flow->streams[0].rate = fault_value(strikes, R(-0.125) - t / 32);
    return fault_status(strikes);
}

/* ---- The systems ---- */

/* The system of a right-hand side, with the objects that it points to */
typedef struct fault_flow_objects {
    vm_flow flow;
    vm_flow1 flow1;
    vm_flow2 flow2;
    vm_stream stream;
    vm_stream1 stream1;
    vm_stream2 stream2;
    fault_system system;
} fault_flow_objects;

/* A flow of one stream, which is not yet filled in. Its update fails. */
static inline void begin_flow(fault_flow_objects *b)
{
    b->flow.n = 1;
    b->flow.streams = &b->stream;
    b->flow.update = faulty_update;
    b->system.ctx = &b->flow;
    b->system.status = &b->flow.status;
}

/* A free body. Its four right-hand sides use the first numbers of one state. */
static inline void begin_free_body(fault_flow_objects *b)
{
    vm_body body = a_body(5);
    body.inertia = fault_sizes;
    begin_flow(b);
    b->stream.at = vmi_vec3(R(0.25), 0, -1);
    b->stream.velocity = vmi_vec3(0, R(0.5), -8);
    b->flow.y_size = VM_FLOW_BALANCED_STATES;
    vm_flow_start(&b->flow, &body, b->system.y);
}

static inline void begin_translation(fault_flow_objects *b)
{
    static const vm_real y[VM_TRANSLATION_STATES] = {1, 0, 2, R(0.5), 1, 0, 5};
    begin_flow(b);
    b->stream.velocity = vmi_vec3(0, R(0.5), -8);
    memcpy(b->system.y, y, sizeof y);
}

static inline void begin_line(fault_flow_objects *b)
{
    static const vm_real y[VM_FLOW1_STATES] = {1, R(0.5), 5};
    b->stream1.velocity = -8;
    b->flow1.n = 1;
    b->flow1.streams = &b->stream1;
    b->flow1.update = faulty_update1;
    b->system.ctx = &b->flow1;
    b->system.status = &b->flow1.status;
    memcpy(b->system.y, y, sizeof y);
}

static inline void begin_plane(fault_flow_objects *b)
{
    static const vm_real y[VM_FLOW2_STATES] = {1, 2, R(0.5), R(0.25), 0, 2, 5, 0, 0, 3};
    b->stream2.x = R(-0.5);
    b->stream2.vx = -8;
    b->stream2.vy = 1;
    b->flow2.n = 1;
    b->flow2.streams = &b->stream2;
    b->flow2.update = faulty_update2;
    b->system.ctx = &b->flow2;
    b->system.status = &b->flow2.status;
    memcpy(b->system.y, y, sizeof y);
}

/* ---- The table ---- */

/* A right-hand side, the number of its states, its system, and the method of a run */
typedef struct fault_flow_row {
    const char *name;
    ode_rhs f;
    int n;
    void (*begin)(fault_flow_objects *b);
    const fault_method *method; /* NULL: single evaluations */
} fault_flow_row;

static const fault_flow_row fault_flows[] = {
    {"vm_flow_rhs", vm_flow_rhs, VM_FLOW_STATES, begin_free_body, NULL},
    {"vm_flow_given_rhs", vm_flow_given_rhs, VM_FLOW_GIVEN_STATES, begin_free_body, NULL},
    {"vm_flow_balanced_rhs", vm_flow_balanced_rhs, VM_FLOW_BALANCED_STATES, begin_free_body, NULL},
    {"vm_flow_carried_rhs", vm_flow_carried_rhs, VM_FLOW_GIVEN_STATES, begin_free_body, NULL},
    {"vm_translation_rhs", vm_translation_rhs, VM_TRANSLATION_STATES, begin_translation, NULL},
    {"vm_flow1_rhs", vm_flow1_rhs, VM_FLOW1_STATES, begin_line, NULL},
    {"vm_flow2_rhs", vm_flow2_rhs, VM_FLOW2_STATES, begin_plane, NULL},
    {"rk45, vm_flow_rhs", vm_flow_rhs, VM_FLOW_STATES, begin_free_body, &fault_rk45},
    {"rk87, vm_flow_rhs", vm_flow_rhs, VM_FLOW_STATES, begin_free_body, &fault_rk87},
    {"rk45, vm_flow_given_rhs", vm_flow_given_rhs, VM_FLOW_GIVEN_STATES, begin_free_body, &fault_rk45},
    {"rk45, vm_flow_balanced_rhs", vm_flow_balanced_rhs, VM_FLOW_BALANCED_STATES, begin_free_body, &fault_rk45},
    {"rk87, vm_flow_carried_rhs", vm_flow_carried_rhs, VM_FLOW_GIVEN_STATES, begin_free_body, &fault_rk87},
    {"rk45, vm_translation_rhs", vm_translation_rhs, VM_TRANSLATION_STATES, begin_translation, &fault_rk45},
    {"rk87, vm_flow1_rhs", vm_flow1_rhs, VM_FLOW1_STATES, begin_line, &fault_rk87},
    {"rk45, vm_flow2_rhs", vm_flow2_rhs, VM_FLOW2_STATES, begin_plane, &fault_rk45},
};

static inline void fault_flow(outcome *o, const void *of)
{
    const fault_flow_row *row = (const fault_flow_row *)of;
    fault_flow_objects b;
    memset(&b, 0, sizeof b);
    row->begin(&b);
    b.system.f = row->f;
    b.system.n = row->n;
    if (row->method) fault_integrate(o, &b.system, row->method);
    else fault_evaluate(o, &b.system);
}

/* A right-hand side returns the number of the user's function. In a run this number is rhs_status. The run may step
   over a NaN, so that the results differ within the tolerance. */
static inline void check_flow(const fault_flow_row *row)
{
    static const fault_promise evaluation = {FAULT_ALL, FAULT_NUMBER, VM_NOT_FINITE, 0, 0, 0};
    static const fault_promise stopped_run = {FAULT_STATUS + FAULT_BOTH, ODE_RHS_STOPPED, ODE_NOT_FINITE, 0, 0, 0};
    static const fault_promise run_over_nan = {FAULT_NAN, ODE_RHS_STOPPED, ODE_NOT_FINITE, FAULT_STEPS, 0, 0};
    if (!row->method) {
        check_faults_of_row(row->name, &evaluation, fault_flow, row);
        return;
    }
    check_faults_of_row(row->name, &stopped_run, fault_flow, row);
    check_faults_of_row(row->name, &run_over_nan, fault_flow, row);
}

#endif
