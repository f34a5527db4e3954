/* mechanics/flow.h - a free body in space with streams of mass

   This chapter has right-hand sides of equations of motion, for the integrators rk45 and rk87. The body is rigid, and
   its mass, mass centre and inertia change while it moves. In vm_flow_rhs streams cause these changes, as in the
   equations (151), (152) of the dissertation [1]. In vm_flow_given_rhs mass, mass centre and inertia are given
   functions of time (170). In vm_flow_carried_rhs mass, inertia and the rate of the mass centre are given functions of
   time, and the mass that is lost or gained moves with the body (166). In vm_flow_rhs and vm_flow_given_rhs momentum
   and angular momentum are states (numbers to integrate), from which velocity and angular velocity follow. Therefore a
   momentum that is conserved stays exactly constant. The rate of a stream may jump, because momentum and angular
   momentum do not jump with this rate.

       vm_flow flow;
       ode_event empty;
       rk45_options options = rk45_defaults(NULL);
       rk45 s;
       vm_real y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
       memset(&flow, 0, sizeof flow); // a field that is zero has no effect
       flow.n = 1;
       flow.streams = &nozzle;
       flow.least_mass = dry;
       memset(&empty, 0, sizeof empty);
       empty.g = vm_flow_mass_left; // stops the run when the tank is empty
       empty.ctx = &flow;
       empty.direction = -1;
       empty.action = ODE_STOP;
       options.events = &empty;
       options.n_events = 1;
       if (vm_flow_start(&flow, &body, y) == VM_OK &&
           rk45_init(&s, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, &options, work) >= 0 && rk45_solve(&s, 3) >= 0)
           vm_flow_body(&flow, VM_FLOW_STATES, s.y, &body);

   The equations. The letters M', u, d, kappa, omega2, P(d) of a stream are explained at vm_reactive. The body has the
   mass M, the inertia I and the angular velocity omega; F is the outer force on it and M_S the outer moment about the
   mass centre. Each sum is over all streams, and q omega is a product of quaternions:
     r' = v + R sum (M'/M) d,  p' = F + sum M' u,  H' = M_S + R sum [d x M' (u - v) + M' kappa omega2],
     q' = q omega/2 + |omega| (1 - |q|^2) q/8,  c' = sum (M'/M) d,  I' = sum M' (kappa + P(d))
   r is the position of the mass centre, p = M v the momentum, H the angular momentum about the mass centre, and q the
   attitude as a quaternion. The vector c leads from the reference point to the mass centre, and d = at - c, where `at`
   is the field of vm_stream; all three are in body axes. R is the rotation of q/|q| from body axes to inertial axes.
   The last term of q' is 0 for |q| = 1. This term brings the length of q back to 1 and does not lower the order of an
   integrator. The dissertation [1] prints I' omega2 in (152) instead of M' kappa omega2.
   If a stream has a store (vm_store) at the position s, let d_s = s - c. The equations then differ in three points.
   The vector d_s replaces d in c' and in P(d). The store's gyration (its inertia per unit mass) replaces kappa in I'.
   The mass that flows between the store and the surface adds M' (s - at) to the body's momentum and M' d x d_s to its
   angular momentum.
   The reference point, from which `at`, s and c are measured, is fixed in the body; its position is r - R c. If
   flow.centre is 0 at the start, the reference point is the initial mass centre.
   Tests: tests/test_flow.c. */
#ifndef VARMASS_MECHANICS_FLOW_H
#define VARMASS_MECHANICS_FLOW_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "attitude.h"
#include "bodies.h"
#include "inertia.h"
#include "inertia_factors.h"
#include "streams.h"
#include "vectors.h"

/* Indices of the states in y, and numbers of states. Vectors are along inertial axes unless body axes are named. */
enum {
    VM_Y_R = 0,        /* position of the mass centre, 3 numbers, m */
    VM_Y_Q = 3,        /* attitude, 4 numbers w, x, y, z; its length should be 1 (vm_flow_start sets it), and not 0 */
    VM_Y_P = 7,        /* momentum, 3 numbers, kg m/s; for vm_flow_carried_rhs the velocity v, m/s */
    VM_Y_H = 10,       /* angular momentum about the mass centre, 3 numbers, kg m^2/s; for vm_flow_carried_rhs the
                          angular velocity in body axes, rad/s */
    VM_Y_MASS = 13,    /* mass, kg */
    VM_Y_CENTRE = 14,  /* vector from the reference point to the mass centre, 3 numbers, body axes, m */
    VM_Y_INERTIA = 17, /* inertia xx, yy, zz, xy, xz, yz about the mass centre, body axes, kg m^2 */
    VM_Y_BALANCE = 23, /* integrals of vm_flow_balanced_rhs: 3 of momentum, 3 of angular momentum, 1 of energy */
    VM_FLOW_GIVEN_STATES = 13,   /* number of states of vm_flow_given_rhs and vm_flow_carried_rhs */
    VM_FLOW_STATES = 23,         /* number of states of vm_flow_rhs; mass, mass centre and inertia are among them */
    VM_FLOW_BALANCED_STATES = 30 /* number of states of vm_flow_balanced_rhs: those of vm_flow_rhs and the 7
                                    integrals */
};

/* The streams and loads of a body. The right-hand sides below get a pointer to this struct as their last argument. Set
   the whole struct to zero first; a field that stays zero has no effect. */
typedef struct VM_TAG(vm_flow) {
    int n;              /* number of streams */
    vm_stream *streams; /* array of n streams, provided by the caller */
    vm_vec3 force;      /* resultant of the outer forces, N, inertial axes */
    vm_vec3 moment;     /* moment of the outer forces about the mass centre, plus all torques, N m, inertial axes */
    /* NULL, or a function that is called before each evaluation of a right-hand side and sets what depends on time and
       state. It may set every field of the flow and of its streams: for example the weight (flow->force = mass times g,
       with the mass y[VM_Y_MASS]), the rate of a stream that a valve changes, the mass M(t), mass centre c(t) and
       inertia I(t) for vm_flow_given_rhs, or M(t), I(t) and the rate c'(t), the field `drift`, for vm_flow_carried_rhs.
       The function returns 0 to go on. If it returns another number, the run ends with the integrator's status
       ODE_RHS_STOPPED. The values that it sets must be smooth functions of t and y. To switch something at an instant,
       use an event with the action ODE_RESTART and set the event's function `change`. */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow) * flow);
    void *ctx;             /* pointer for the caller's `update`; not used by the functions below */
    vm_real mass;          /* mass for vm_flow_given_rhs and vm_flow_carried_rhs, kg */
    vm_vec3 centre;        /* vector from the reference point to the mass centre, m, body axes; for vm_flow_given_rhs
                              and vm_flow_start */
    vm_inertia inertia;    /* inertia for vm_flow_given_rhs and vm_flow_carried_rhs, kg m^2, body axes */
    vm_vec3 drift;         /* rate c'(t) of the mass centre for vm_flow_carried_rhs, m/s, body axes */
    vm_real least_mass;    /* the event function vm_flow_mass_left is 0 when the mass has fallen to this value, kg */
    vm_real least_inertia; /* the event function vm_flow_inertia_left is 0 when the smallest pivot of the inertia has
                              fallen to this value, kg m^2 */
    /* VM_OK, or the reason why the last evaluations gave NaN or ended the run. A trial step of the integrator may go
       beyond the end of a motion, where the mass is not positive or no body can have the inertia. The derivatives are
       then NaN, so that the integrator shortens its step. An event should stop the run before the mass or the inertia
       becomes impossible. If `update` ends the run, this field does not change. */
    int status;
    /* Length of the array y, VM_LENGTH(y), which the right-hand sides, vm_flow_start and vm_flow_body check (the two
       event functions do not); 0 means unknown. vm_flow_start writes VM_FLOW_GIVEN_STATES or VM_FLOW_STATES numbers, as
       many as y_size allows. If y_size allows all VM_FLOW_BALANCED_STATES, it also sets the seven integrals of the
       balance to 0. */
    int y_size;
} vm_flow;

/* Returns 1 if the number n of streams is 0, or if n is positive and there is an array of streams. Returns 0
   otherwise. */
VM_INLINE int vmi_flow_has_streams(int n, const void *streams) { return n == 0 || (n > 0 && streams); }

/* Sets n derivatives to NaN, which makes the integrator shorten its step. Returns 0, so that the run goes on. */
VM_API int vmi_flow_reject_step(int n, vm_real *dydt)
{
    int k;
    for (k = 0; k < n; k++) dydt[k] = VM_NAN;
    return 0;
}

/* Stores the status of an evaluation of a right-hand side in *kept and returns this status. After several failures in a
   row *kept is the status of the first failure, because its NaN derivatives may be the cause of the later failures. */
VM_INLINE int vmi_flow_note_status(int *kept, int status)
{
    if (!status || !*kept) *kept = status;
    return status;
}

/* Mass, vector from the reference point to the mass centre, and inertia of a body at an instant, in body axes */
typedef struct VM_TAG(vmi_flow_mass) {
    vm_real mass;
    vm_vec3 centre;
    vm_inertia inertia;
} vmi_flow_mass;

/* Returns the present mass, mass centre and inertia of the body. These quantities are fields of the flow if given = 1,
   and parts of the state y if given = 0. */
VM_INLINE vmi_flow_mass vmi_flow_mass_at(const vm_flow *flow, int given, const vm_real *y)
{
    vmi_flow_mass b;
    if (given) {
        b.mass = flow->mass;
        b.centre = flow->centre;
        b.inertia = flow->inertia;
    } else {
        b.mass = y[VM_Y_MASS];
        b.centre = vmi_get3(y + VM_Y_CENTRE);
        b.inertia = vmi_get_inertia(y + VM_Y_INERTIA);
    }
    return b;
}

VM_API int vmi_flow_mass_is_finite(const vmi_flow_mass *b)
{
    return VM_IS_FINITE(b->mass) && vmi_vec3_is_finite(b->centre) && vmi_inertia_is_finite(&b->inertia);
}

VM_INLINE int vmi_flow_check_mass(vm_real mass)
{
    if (!VM_IS_FINITE(mass)) return VM_NOT_FINITE;
    if (!(mass > 0)) return VM_BAD_MASS;
    return VM_OK;
}

/* Computes from the state y the rotation *turn from body axes to inertial axes. Sets *seen to the velocity, the
   angular velocity and the other quantities that the sums over the streams need. Returns VM_NOT_FINITE if the mass is
   infinite or NaN; VM_BAD_MASS if it is not positive; VM_BAD_INERTIA if no body can have the inertia, or if it is
   singular; else VM_OK. */
VM_INLINE int vmi_flow_motion(const vm_flow *flow, const vm_real *y, const vmi_flow_mass *b, vmi_mat3 *turn,
                              vmi_stream_seen *seen)
{
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_vec3 p = vmi_get3(y + VM_Y_P);
    const vm_real inverse = 1 / b->mass;
    vm_vec3 h, p_on_the_way, h_on_the_way;
    vmi_inertia_ldl factors;
    const int status = vmi_flow_check_mass(b->mass);
    if (status) return status;
    if (!vmi_inertia_factor_if_possible(&b->inertia, &factors)) return VM_BAD_INERTIA;
    *turn = vmi_rotation_of_square(q, vmi_quat_square(q));
    h = vmi_times_transposed(turn, vmi_get3(y + VM_Y_H));
    vmi_stream_on_the_way(flow->n, flow->streams, b->centre, &p_on_the_way, &h_on_the_way);
    seen->turn = turn;
    seen->centre = b->centre;
    seen->v = vm_scale(inverse, p);
    seen->slip = vm_scale(-inverse, p_on_the_way);
    seen->omega = vmi_inertia_solve(&factors, vm_sub(h, h_on_the_way));
    return VM_OK;
}

/* Sets dydt[0] ... dydt[6] to the rates of the seven integrals of vm_flow_balanced_rhs: the momentum, angular momentum
   and energy that the streams take out of the body per second, minus the momentum, angular momentum and energy that the
   outer loads put into it per second */
VM_INLINE void vmi_flow_balance(const vm_flow *flow, const vm_real *y, const vmi_stream_seen *seen,
                                const vmi_stream_sum *sum, vm_vec3 force, vm_vec3 moment, vm_real *dydt)
{
    const vm_vec3 omega = vmi_times(seen->turn, seen->omega), r = vmi_get3(y + VM_Y_R);
    const vm_vec3 drift = vmi_times(seen->turn, sum->crossing);
    vmi_set3(dydt, vm_scale(-1, force));
    vmi_set3(dydt + 3, vm_scale(-1, vm_add(moment, vm_add(vm_cross(r, force), vm_cross(drift, seen->v)))));
    dydt[6] = (sum->lost - sum->brought) / 2 - vm_dot(flow->force, seen->v) - vm_dot(flow->moment, omega);
}

/* Evaluates one of the right-hand sides vm_flow_given_rhs, vm_flow_rhs and vm_flow_balanced_rhs. The number n of
   states tells which one of the three it is. */
VM_INLINE int vmi_flow_rates(vm_flow *flow, int n, vm_real t, const vm_real *y, vm_real *dydt)
{
    const int given = n == VM_FLOW_GIVEN_STATES;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    vm_vec3 force, moment;
    vmi_flow_mass body;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    vmi_stream_sum sum;
    int status = 0;
    if (flow->update) status = flow->update(t, y, flow);
    if (status) return status;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return flow->status = VM_SHORT_ARRAY;
    body = vmi_flow_mass_at(flow, given, y);
    status = vmi_flow_motion(flow, y, &body, &turn, &seen);
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(n, dydt);
    seen.energy = n == VM_FLOW_BALANCED_STATES;
    if (!vmi_stream_sums(flow->n, flow->streams, &seen, &sum)) return flow->status = VM_BAD_ARGUMENT;
    force = vm_add(vmi_times(&turn, sum.pushed), vm_scale(sum.carried, seen.v));
    force = vm_add(flow->force, vm_add(sum.absolute, force));
    moment = vm_add(flow->moment, vmi_times(&turn, vm_add(sum.moment, sum.own)));
    vmi_set3(dydt + VM_Y_R, vm_add(seen.v, vmi_times(&turn, vm_scale(1 / body.mass, sum.crossing))));
    vmi_attitude_rates(q, vmi_quat_square(q), seen.omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P, force);
    vmi_set3(dydt + VM_Y_H, moment);
    if (given) return 0;
    dydt[VM_Y_MASS] = sum.rate;
    vmi_set3(dydt + VM_Y_CENTRE, vm_scale(1 / body.mass, sum.stored));
    vmi_set_inertia(dydt + VM_Y_INERTIA, &sum.inertia);
    if (seen.energy) vmi_flow_balance(flow, y, &seen, &sum, force, moment, dydt + VM_Y_BALANCE);
    return 0;
}

/* Right-hand side of the equations of motion of a free body whose streams change its mass (151), (152).
   Its type is ode_rhs, so that integrators such as rk45 can call it. The state y has VM_FLOW_STATES numbers. `flow`
   must point to a vm_flow. The equations are given at the top of mechanics/flow.h. Returns 0 or another number, which
   ends the run: VM_BAD_ARGUMENT for a null pointer, for n < 0 and for an unknown `motion` of a stream; VM_SHORT_ARRAY
   if y_size is too small; or the number that flow.update returns. */
VM_API int vm_flow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_STATES, t, y, dydt);
}

/* Right-hand side of the equations of motion of a free body with given laws of mass, mass centre and inertia.
   Its type is ode_rhs. The state y has VM_FLOW_GIVEN_STATES numbers. `flow` must point to a vm_flow, whose function
   `update` must set mass, centre and inertia for the time t. The streams cause forces and moments as in vm_flow_rhs,
   but do not change the mass. Without streams the equations are (170): the mass that joins or leaves is at rest, and
   it joins or leaves at the mass centre. The statuses are those of vm_flow_rhs. */
VM_API int vm_flow_given_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_GIVEN_STATES, t, y, dydt);
}

/* Right-hand side of the equations of vm_flow_rhs, with seven more states: integrals that check the balances.
   Its type is ode_rhs. The state y has VM_FLOW_BALANCED_STATES numbers. `flow` must point to a vm_flow. The integrals
   are the numbers from y[VM_Y_BALANCE] on and are zero at the start. The integrals are the momentum (3 numbers), the
   angular momentum about the origin (3 numbers) and the kinetic energy that the streams have taken out of the body,
   minus the momentum, angular momentum and energy that the outer loads have put into the body.
   The sum of an integral and the corresponding quantity of the body stays constant. (There are two exceptions if a
   stream has a store. The angular momentum in this sum is then y[VM_Y_H] + r x p, and the sum of the energies does not
   stay constant.)
   (113) and (118) give the change of the kinetic energy T by a sudden change of mass. For a continuous stream, with M'
   > 0 or M' < 0, they give in the limit the rate T'. With the letters of the equations at the top of mechanics/flow.h:
     T' = F v + M_S omega + sum [M' u^2 + omega2 M' kappa omega2]/2 - sum [M' w^2 + omega_r M' kappa omega_r]/2,
     w = u - v - omega x d, omega_r = omega2 - omega.
   The first sum is the power that the streams bring. The second sum is subtracted. For M' < 0 this gives a positive
   power, which engines supply. For M' > 0 it gives a negative power, which is lost by plastic impact. The statuses are
   those of vm_flow_rhs. */
VM_API int vm_flow_balanced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_BALANCED_STATES, t, y, dydt);
}

/* Right-hand side of the equations of motion of a free body whose lost or gained mass moves with the body (166).
   Its type is ode_rhs. The state y has VM_FLOW_GIVEN_STATES numbers. `ctx` must point to a vm_flow, whose function
   `update` must set mass, inertia and drift for the time t. The states are r, q, the velocity v (not the momentum) and
   omega in body axes (not the angular momentum). The function does not use the streams of the flow. The equations are
     v' = F/M + R (omega x c'), r' = v + R c', I omega' + omega x I omega = M_S.
   The letters are explained at the top of mechanics/flow.h; here c' is flow.drift, and M_S stands for R^T M_S, the
   components of flow.moment along body axes. The statuses are those of vm_flow_rhs; the streams are not checked. */
VM_API int vm_flow_carried_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow *flow = (vm_flow *)ctx;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_real square = vmi_quat_square(q);
    const vm_vec3 omega = vmi_get3(y + VM_Y_H);
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    int status = 0;
    if (flow->update) status = flow->update(t, y, flow);
    if (status) return status;
    if (flow->y_size && flow->y_size < VM_FLOW_GIVEN_STATES) return flow->status = VM_SHORT_ARRAY;
    status = vmi_flow_check_mass(flow->mass);
    if (!vmi_inertia_factor_if_possible(&flow->inertia, &factors)) status = vmi_first_error(status, VM_BAD_INERTIA);
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(VM_FLOW_GIVEN_STATES, dydt);
    turn = vmi_rotation_of_square(q, square);
    vmi_set3(dydt + VM_Y_R, vm_add(vmi_get3(y + VM_Y_P), vmi_times(&turn, flow->drift)));
    vmi_attitude_rates(q, square, omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P,
             vm_add(vm_scale(1 / flow->mass, flow->force), vmi_times(&turn, vm_cross(omega, flow->drift))));
    vmi_set3(dydt + VM_Y_H,
             vmi_stream_euler(&flow->inertia, &factors, omega, vmi_times_transposed(&turn, flow->moment)));
    return 0;
}

/* Returns how many numbers vm_flow_start writes: VM_FLOW_STATES if y_size is unknown (0) or large enough, and
   VM_FLOW_GIVEN_STATES if y_size is smaller. If y_size is known and large enough for the integrals of the balance, the
   result is VM_FLOW_BALANCED_STATES. */
VM_API int vmi_flow_size_at_start(const vm_flow *flow)
{
    if (flow->y_size >= VM_FLOW_BALANCED_STATES) return VM_FLOW_BALANCED_STATES;
    if (flow->y_size && flow->y_size < VM_FLOW_STATES) return VM_FLOW_GIVEN_STATES;
    return VM_FLOW_STATES;
}

/* Returns VM_OK if the arguments of vm_flow_start are valid, else the error. The inertia must be possible for a body
   and not singular. */
VM_API int vmi_flow_check_start(const vm_flow *flow, const vm_body *body)
{
    vmi_inertia_ldl factors;
    int status = vmi_first_error(vmi_check_body(body), vmi_check_streams(flow->n, flow->streams));
    if (!vmi_vec3_is_finite(flow->centre) || !vmi_vec3_is_finite(flow->force) || !vmi_vec3_is_finite(flow->moment))
        status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    if (!vmi_inertia_factor(&body->inertia, &factors)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Initial state y of a body with streams. Writes the first VM_FLOW_STATES states, or as many as flow.y_size allows.
   Before the call flow.centre and flow.streams must contain the mass centre and the streams at the start. The function
   sets flow.mass and flow.inertia, too. For vm_flow_given_rhs y must have room for at least VM_FLOW_GIVEN_STATES
   numbers. If y has room for fewer than VM_FLOW_STATES numbers, set flow.y_size before the call. vm_flow_carried_rhs
   has different states, which the caller sets. Returns
   - VM_BAD_ARGUMENT for a null pointer, for n < 0 and for an unknown `motion` of a stream;
   - VM_NOT_FINITE if an argument or a number of the state is infinite or NaN;
   - VM_BAD_MASS if the mass is not positive;
   - VM_BAD_INERTIA if no body can have the inertia, for a rod or a point, and if a moment of a gyration is negative;
   - VM_SHORT_ARRAY if flow.y_size is below VM_FLOW_GIVEN_STATES but not 0;
   - VM_OK otherwise. */
VM_API int vm_flow_start(vm_flow *flow, const vm_body *body, vm_real *y)
{
    vm_vec3 p, h;
    vm_quat q;
    vmi_mat3 turn;
    vm_real start[VM_FLOW_BALANCED_STATES];
    int status, k;
    if (!flow || !body || !y) return VM_BAD_ARGUMENT;
    status = vmi_flow_check_start(flow, body);
    if (status) return status;
    q = vm_unit_quat(body->q);
    turn = vmi_rotation(q);
    vmi_stream_on_the_way(flow->n, flow->streams, flow->centre, &p, &h);
    start[VM_Y_Q] = q.w;
    start[VM_Y_Q + 1] = q.x;
    start[VM_Y_Q + 2] = q.y;
    start[VM_Y_Q + 3] = q.z;
    vmi_set3(start + VM_Y_R, body->r);
    vmi_set3(start + VM_Y_P, vm_momentum(body));
    vmi_set3(start + VM_Y_H, vm_add(vmi_spin_momentum(body), vmi_times(&turn, h)));
    start[VM_Y_MASS] = body->mass;
    vmi_set3(start + VM_Y_CENTRE, flow->centre);
    vmi_set_inertia(start + VM_Y_INERTIA, &body->inertia);
    if (flow->y_size && flow->y_size < VM_FLOW_GIVEN_STATES) return VM_SHORT_ARRAY;
    for (k = VM_Y_BALANCE; k < VM_FLOW_BALANCED_STATES; k++) start[k] = 0;
    status = vmi_copy_if_finite(vmi_flow_size_at_start(flow), start, y);
    if (status) return status;
    flow->mass = body->mass;
    flow->inertia = body->inertia;
    flow->status = VM_OK;
    return VM_OK;
}

/* Sets *body to the body that the n numbers of the state y describe. Its quaternion gets the length 1. If n <
   VM_FLOW_STATES, mass, mass centre and inertia are taken from the fields of *flow; otherwise they are in y. y must not
   be a state of vm_flow_carried_rhs, which has different states. Returns
   - VM_BAD_ARGUMENT for a null pointer, and if n < VM_FLOW_GIVEN_STATES or the number of streams is negative;
   - VM_SHORT_ARRAY if flow.y_size is below n but not 0;
   - VM_NOT_FINITE if a number of y that describes the body, or a number of the result, is infinite or NaN;
   - VM_BAD_MASS if the mass is not positive;
   - VM_BAD_INERTIA if no body can have the inertia, and also for a rod or a point;
   - VM_OK otherwise. */
VM_API int vm_flow_body(const vm_flow *flow, int n, const vm_real *y, vm_body *body)
{
    vm_body b;
    vmi_flow_mass now;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    int status;
    if (!flow || !y || !body || n < VM_FLOW_GIVEN_STATES) return VM_BAD_ARGUMENT;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return VM_SHORT_ARRAY;
    now = vmi_flow_mass_at(flow, n < VM_FLOW_STATES, y);
    if (!vmi_all_finite(VM_FLOW_GIVEN_STATES, y) || !vmi_flow_mass_is_finite(&now)) return VM_NOT_FINITE;
    status = vmi_flow_motion(flow, y, &now, &turn, &seen);
    if (status) return status;
    b.mass = now.mass;
    b.inertia = now.inertia;
    b.q = vm_unit_quat(vmi_get_quat(y + VM_Y_Q));
    b.r = vmi_get3(y + VM_Y_R);
    b.v = seen.v;
    b.omega = vmi_times(&turn, seen.omega);
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* Mass minus flow.least_mass, kg: an event function that stops a run before the mass is used up.
   The function works with vm_flow_rhs and vm_flow_balanced_rhs. The field ctx of the event must point to the vm_flow.
   Returns NaN for a null pointer. */
VM_API vm_real vm_flow_mass_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    (void)t;
    return y[VM_Y_MASS] - ((const vm_flow *)flow)->least_mass;
}

/* Smallest pivot of the inertia minus flow.least_inertia, kg m^2: an event function.
   The pivots are the diagonal entries of D in the factorization L D L^T of the inertia. The event stops a run before a
   pivot becomes 0, which would make the inertia singular. The function works with vm_flow_rhs and
   vm_flow_balanced_rhs. The field ctx of the event must point to the vm_flow. The event does not check the triangle
   inequality of the moments, because thin bodies are always close to its limit. Returns NaN for a null pointer or an
   inertia that is not finite. */
VM_API vm_real vm_flow_inertia_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    const vm_inertia i = vmi_get_inertia(y + VM_Y_INERTIA);
    vmi_inertia_ldl f;
    vm_real least = 0;
    (void)t;
    if (!vmi_inertia_is_finite(&i)) return VM_NAN;
    if (vmi_inertia_factor(&i, &f)) least = vmi_smaller(1 / f.z, vmi_smaller(1 / f.y, i.xx));
    return least - ((const vm_flow *)flow)->least_inertia;
}

#endif
