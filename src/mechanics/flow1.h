/* mechanics/flow1.h - translation, and bodies on a line or an axle, with streams of mass

   This chapter has the right-hand sides of equations of motion with streams of mass that need fewer states (numbers to
   integrate) than a free body in space. These motions are translation in space (172), straight motion (175), (176),
   and rotation about a fixed axle (173a), by the equations of the dissertation [1]. The equation of rotation is the
   equation of straight motion with the moment of inertia instead of the mass.

       vm_stream1 jet = {-1, -2000, VM_RELATIVE}; // 1 kg/s leaves at 2000 m/s backwards
       vm_flow1 flow;
       vm_real y[VM_FLOW1_STATES] = {0, 0, 100}; // at rest, 100 kg
       vm_real dydt[VM_FLOW1_STATES];
       memset(&flow, 0, sizeof flow);
       flow.n = 1;
       flow.streams = &jet;
       int status = vm_flow1_rhs(0, y, dydt, &flow); // or integrate it: rk45_init(&s, vm_flow1_rhs, &flow, ...)

   Tests: tests/test_flow1.c. */
#ifndef VARMASS_MECHANICS_FLOW1_H
#define VARMASS_MECHANICS_FLOW1_H

#include "../base/real.h"
#include "../base/status.h"
#include "attitude.h"
#include "flow.h"
#include "streams.h"
#include "vectors.h"

/* Indices of the states of vm_translation_rhs in y, and their number */
enum {
    VM_TRANSLATION_R = 0,    /* position of the mass centre, 3 numbers, m */
    VM_TRANSLATION_P = 3,    /* momentum, 3 numbers, kg m/s */
    VM_TRANSLATION_MASS = 6, /* mass, kg */
    VM_TRANSLATION_STATES = 7
};

/* Indices of the states of vm_flow1_rhs in y, and their number. For an axle the states are the angle (rad), the
   angular momentum (kg m^2/s) and the moment of inertia about the axle (kg m^2). */
enum {
    VM_FLOW1_X = 0,    /* position, m */
    VM_FLOW1_P = 1,    /* momentum, kg m/s */
    VM_FLOW1_MASS = 2, /* mass, kg */
    VM_FLOW1_STATES = 3
};

/* A stream of mass that enters or leaves a body on a line or an axle. For a body on an axle let M' be the mass per
   time, rho the distance from the axle at which the mass enters or leaves, and kappa the inertia per unit mass of this
   mass about its own mass centre. Then `rate` must be M' (kappa + rho^2), the rate of the moment of inertia. `velocity`
   must be the angular momentum per unit mass, about the axle, of this mass, divided by kappa + rho^2. If `motion` is
   VM_RELATIVE, this is the angular momentum of the motion relative to the body. */
typedef struct VM_TAG(vm_stream1) {
    vm_real rate;     /* mass per time, kg/s (axle: kg m^2/s); > 0: mass joins, < 0: mass leaves */
    vm_real velocity; /* velocity of the stream's mass, m/s (axle: rad/s) */
    int motion;       /* what `velocity` means: VM_RELATIVE, VM_ABSOLUTE, VM_CARRIED or VM_AT_REST */
} vm_stream1;

/* The streams and the load of a body on a line or an axle. vm_flow1_rhs gets a pointer to this struct as its last
   argument. Set the whole struct to 0 first. */
typedef struct VM_TAG(vm_flow1) {
    int n;               /* number of streams */
    vm_stream1 *streams; /* array of n streams, provided by the caller */
    vm_real force;       /* resultant of the outer forces, N (axle: their moment about the axle, N m) */
    /* NULL, or a function that is called before each evaluation and may set every field from t and y, as
       vm_flow.update does. It returns 0 to go on; any other number ends the run. */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow1) * flow);
    void *ctx;  /* pointer for the caller's `update`; not used by the functions below */
    int status; /* VM_OK, or the reason why the last evaluations gave NaN or ended the run: see vm_flow.status */
} vm_flow1;

/* Returns the velocity u of a stream's mass. `motion` and `given` are the fields `motion` and `velocity` of the stream,
   and v is the velocity of the body. The components of u, v and `given` are along the same axes. */
VM_INLINE vm_vec3 vmi_translation_velocity(int motion, vm_vec3 v, vm_vec3 given)
{
    vm_vec3 u = vmi_vec3(0, 0, 0);
    if (vmi_stream_moves_with_body(motion)) u = v;
    if (vmi_stream_velocity_is_given(motion)) u = vm_add(u, given);
    return u;
}

/* Evaluates the right-hand side of vm_translation_rhs. The caller must have called flow->update before, if this pointer
   is not NULL. */
VM_INLINE int vmi_translation_rates(vm_flow *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real mass = y[VM_TRANSLATION_MASS];
    const vm_vec3 v = vm_scale(1 / mass, vmi_get3(y + VM_TRANSLATION_P));
    vm_real rate = 0;
    vm_vec3 force = flow->force;
    int k;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < VM_TRANSLATION_STATES) return flow->status = VM_SHORT_ARRAY;
    if (vmi_flow_note_status(&flow->status, vmi_flow_check_mass(mass)))
        return vmi_flow_reject_step(VM_TRANSLATION_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream *s = flow->streams + k;
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        rate += s->rate;
        force = vm_add(force, vm_scale(s->rate, vmi_translation_velocity(s->motion, v, s->velocity)));
    }
    vmi_set3(dydt + VM_TRANSLATION_R, v);
    vmi_set3(dydt + VM_TRANSLATION_P, force);
    dydt[VM_TRANSLATION_MASS] = rate;
    return 0;
}

/* Calls flow->update, then evaluates the right-hand side of vm_translation_rhs. This function is not inlined. If it
   were inlined, a flow without `update` would lose time, because it would save the processor's registers for a call of
   `update` that does not happen. */
VMI_APART int vmi_translation_updated_rates(vm_real t, const vm_real *y, vm_real *dydt, vm_flow *flow)
{
    const int status = flow->update(t, y, flow);
    if (status) return status;
    return vmi_translation_rates(flow, y, dydt);
}

/* Right-hand side of the equations of translation with streams of mass: r' = p/M, p' = F + sum M' u (172).
   Its type is ode_rhs, so that integrators such as rk45 can call it. The state y has VM_TRANSLATION_STATES numbers.
   `flow` must point to a vm_flow, of which n, streams, force, update, y_size and status are used. r is the position of
   the mass centre, p the momentum, M the mass and F the outer force. The sum is over all streams; M' is the rate of a
   stream and u the velocity of its mass. The rate of the body's mass M is the sum of all M'. The body axes must be
   parallel to the inertial axes. The function does not read the fields at, spin, gyration and from of the streams.
   Returns 0 or another number, which ends the run: VM_BAD_ARGUMENT for a null pointer, for n < 0 and for an unknown
   `motion` of a stream; VM_SHORT_ARRAY if y_size is too small; or the number that flow.update returns. */
VM_API int vm_translation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    vm_flow *f = (vm_flow *)flow;
    if (f->update) return vmi_translation_updated_rates(t, y, dydt, f);
    return vmi_translation_rates(f, y, dydt);
}

/* Evaluates the right-hand side of vm_flow1_rhs. The caller must have called flow->update before, if this pointer is
   not NULL. */
VM_INLINE int vmi_flow1_rates(vm_flow1 *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real v = y[VM_FLOW1_P] / y[VM_FLOW1_MASS];
    vm_real force = flow->force, rate = 0;
    int k;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (vmi_flow_note_status(&flow->status, vmi_flow_check_mass(y[VM_FLOW1_MASS])))
        return vmi_flow_reject_step(VM_FLOW1_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream1 *s = flow->streams + k;
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        rate += s->rate;
        force += s->rate * vmi_stream_velocity1(s->motion, v, s->velocity);
    }
    dydt[VM_FLOW1_X] = v;
    dydt[VM_FLOW1_P] = force;
    dydt[VM_FLOW1_MASS] = rate;
    return 0;
}

/* Calls flow->update, then evaluates the right-hand side of vm_flow1_rhs. The comment of vmi_translation_updated_rates
   says why this function is not inlined. */
VMI_APART int vmi_flow1_updated_rates(vm_real t, const vm_real *y, vm_real *dydt, vm_flow1 *flow)
{
    const int status = flow->update(t, y, flow);
    if (status) return status;
    return vmi_flow1_rates(flow, y, dydt);
}

/* Right-hand side of the equations of motion of a body on a line or an axle with streams, (173a), (175), (176).
   Its type is ode_rhs. The state y has VM_FLOW1_STATES numbers. `flow1` must point to a vm_flow1. The equations for the
   position x, the momentum p and the mass M are x' = p/M, p' = F + sum of M_i u_i, M' = sum of M_i. F is the outer
   force. Each sum is over all streams; M_i is the rate of stream number i, and u_i is the velocity of its mass. Returns
   0 or another number, which ends the run: VM_BAD_ARGUMENT for a null pointer, for n < 0 and for an unknown `motion` of
   a stream; or the number that flow.update returns. */
VM_API int vm_flow1_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow1)
{
    if (!y || !dydt || !flow1) return VM_BAD_ARGUMENT;
    vm_flow1 *f = (vm_flow1 *)flow1;
    if (f->update) return vmi_flow1_updated_rates(t, y, dydt, f);
    return vmi_flow1_rates(f, y, dydt);
}

#endif
