/* mechanics/flow.h - a free body with streams of mass */
#ifndef VARMASS_MECHANICS_FLOW_H
#define VARMASS_MECHANICS_FLOW_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "streams.h"
#include "vectors.h"

/* The free body in space. A vm_flow is the ctx of the right-hand sides below:

       vm_flow flow;
       ode_event empty;
       rk45_options options = rk45_defaults(NULL);
       rk45 s;
       vm_real y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
       memset(&flow, 0, sizeof flow); // what is not set is zero: not there
       flow.n = 1;
       flow.streams = &nozzle;
       flow.least_mass = dry;
       memset(&empty, 0, sizeof empty);
       empty.g = vm_flow_mass_left;
       empty.ctx = &flow;
       empty.direction = -1;
       empty.action = ODE_STOP;
       options.events = &empty;
       options.n_events = 1;
       if (vm_flow_start(&flow, &body, y) == VM_OK &&
           rk45_init(&s, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, &options, work) >= 0 && rk45_solve(&s, 3) >= 0)
           vm_flow_body(&flow, VM_FLOW_STATES, s.y, &body);

   What depends on the state is set by flow.update: weight is flow->force = y[VM_Y_MASS] g. The reference point of at
   and of stores stays in the body: it is at r - R c, which flow.centre = 0 makes the first mass centre.
   The momenta are the states, v = momentum/mass and omega follow from them: what keeps a momentum keeps it exactly
   here, and rates may jump. States, in inertial axes but for the last two:
     y[VM_Y_R] r 3, y[VM_Y_Q] attitude 4, y[VM_Y_P] momentum 3, y[VM_Y_H] angular momentum about the mass centre 3,
     y[VM_Y_MASS], and in body axes y[VM_Y_CENTRE] mass centre c from the reference point 3, y[VM_Y_INERTIA] xx, yy,
     zz, xy, xz, yz about the mass centre
     r' = v + R sum (M'/M) d,  p' = F + sum M' u,  H' = M_S + R sum [d x M' (u - v) + M' kappa omega2],
     q' = q omega/2 + |omega| (1 - |q|^2) q/8,  c' = sum (M'/M) d,  I' = sum M' (kappa + P(d))
   R turns body axes into inertial ones, d = at - c; these are (151), (152), which [1] prints with I' omega2, in the
   body. With a store at s, d_s = s - c replaces d in c' and P(d), its gyration kappa in I', and the flow on the way
   holds the momentum M' (s - at) and the angular momentum M' d x d_s. The last term of q' is 0 where |q| = 1; R is of
   q/|q|: the length is held, and the order of no integrator suffers.
   In a trial step beyond the end, the mass may not be positive, or the inertia may be one that no body has (a
   moment that is not positive, or larger than the two others together). The derivatives are then NaN, so that the
   step is shortened, and flow.status says why. Use the events below to stop before that. */
enum {
    VM_Y_R = 0,
    VM_Y_Q = 3,
    VM_Y_P = 7,
    VM_Y_H = 10,
    VM_Y_MASS = 13,
    VM_Y_CENTRE = 14,
    VM_Y_INERTIA = 17,
    VM_Y_BALANCE = 23,
    VM_FLOW_GIVEN_STATES = 13,   /* numbers of states: mass, centre and inertia given by flow.update */
    VM_FLOW_STATES = 23,         /* or states */
    VM_FLOW_BALANCED_STATES = 30 /* and the account of momenta and energy */
};

typedef struct VM_TAG(vm_flow) {
    int n;              /* streams */
    vm_stream *streams; /* the caller's */
    vm_vec3 force;      /* N, resultant of the outer forces, inertial axes */
    vm_vec3 moment;     /* N m, their moment about the mass centre and the torques, inertial axes */
    /* null, or called before each evaluation; it may change all that is here; nonzero stops the run. What switches in
       time belongs into an ODE_RESTART event's change, not here */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow) * flow);
    void *ctx;                         /* the caller's */
    vm_real mass;                      /* vm_flow_given_rhs, vm_flow_carried_rhs: the laws M(t), */
    vm_vec3 centre;                    /* c(t) (vm_flow_start: where the mass centre is at first), */
    vm_inertia inertia;                /* I(t) */
    vm_vec3 drift;                     /* and c'(t), vm_flow_carried_rhs */
    vm_real least_mass, least_inertia; /* of the events */
    int status;                        /* 0, or why the last evaluations gave NaN or ended the run */
    /* 0, or how many numbers y has room for, VM_LENGTH(y); all functions here check it. vm_flow_start writes no
       more than that: VM_FLOW_GIVEN_STATES or VM_FLOW_STATES numbers, and if there is room for all VM_FLOW_BALANCED_STATES, also the zeros
       of the account */
    int y_size;
} vm_flow;

/* The free body */
/* Whether there are as many streams as there should be */
VM_INLINE int vmi_flow_has(int n, const void *streams) { return n == 0 || (n > 0 && streams); }

/* Derivatives that make the integrator shorten its step */
VM_API int vmi_flow_refuse(int n, vm_real *dydt)
{
    int k;
    for (k = 0; k < n; k++) dydt[k] = VM_NAN;
    return 0;
}

/* Keeps the first reason of evaluations in a row that are refused: the others follow from its NaN */
VM_INLINE int vmi_flow_refused(int *kept, int status)
{
    if (!status || !*kept) *kept = status;
    return status;
}

/* q omega/2 + |omega| (1 - |q|^2) q/8, omega in body axes: the length comes back within some steps of any explicit
   method, at a rate that is below that of the rotation itself */
VM_INLINE void vmi_stream_turning(vm_quat q, vm_real square, vm_vec3 omega, vm_real *dydt)
{
    const vm_real back = VM_SQRT(vmi_dot(omega, omega)) * (1 - square) / 8, x = omega.x / 2, y = omega.y / 2,
                  z = omega.z / 2;
    dydt[0] = back * q.w - q.x * x - q.y * y - q.z * z;
    dydt[1] = back * q.x + q.w * x + q.y * z - q.z * y;
    dydt[2] = back * q.y + q.w * y + q.z * x - q.x * z;
    dydt[3] = back * q.z + q.w * z + q.x * y - q.y * x;
}

/* A state taken apart: rotation, velocity and angular velocity; VM_BAD_MASS, VM_BAD_INERTIA */
VM_INLINE int vmi_flow_motion(const vm_flow *flow, const vm_real *y, vm_real mass, const vm_inertia *inertia,
                              vm_vec3 centre, vmi_mat3 *turn, vmi_stream_seen *seen)
{
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_vec3 p = vmi_get3(y + VM_Y_P);
    const vm_real inverse = 1 / mass;
    vm_vec3 h;
    vmi_inertia_ldl factors;
    if (!(mass > 0)) return VM_BAD_MASS;
    if (!vmi_inertia_factor_if_possible(inertia, &factors)) return VM_BAD_INERTIA;
    *turn = vmi_rotation_of_square(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    h = vmi_times_transposed(turn, vmi_get3(y + VM_Y_H));
    vmi_stream_on_the_way(flow->n, flow->streams, centre, &seen->slip, &seen->omega);
    seen->turn = turn;
    seen->centre = centre;
    seen->v = vmi_scale(inverse, p);
    seen->slip = vmi_scale(-inverse, seen->slip);
    seen->omega = vmi_inertia_solve(&factors, vmi_sub(h, seen->omega));
    return VM_OK;
}

/* VM_Y_BALANCE on: momentum, angular momentum and energy carried off by streams less those brought by loads */
VM_INLINE void vmi_flow_balance(const vm_flow *flow, const vm_real *y, const vmi_stream_seen *seen,
                                const vmi_stream_sum *sum, vm_vec3 force, vm_vec3 moment, vm_real *dydt)
{
    const vm_vec3 omega = vmi_times(seen->turn, seen->omega), r = vmi_get3(y + VM_Y_R);
    const vm_vec3 drift = vmi_times(seen->turn, sum->crossing);
    vmi_set3(dydt, vmi_scale(-1, force));
    vmi_set3(dydt + 3, vmi_scale(-1, vmi_add(moment, vmi_add(vmi_cross(r, force), vmi_cross(drift, seen->v)))));
    dydt[6] = (sum->lost - sum->brought) / 2 - vmi_dot(flow->force, seen->v) - vmi_dot(flow->moment, omega);
}

VM_INLINE int vmi_flow_rates(vm_flow *flow, int n, vm_real t, const vm_real *y, vm_real *dydt)
{
    const int given = n == VM_FLOW_GIVEN_STATES;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    vm_real mass;
    vm_vec3 centre, force, moment;
    vm_inertia inertia;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    vmi_stream_sum sum;
    int status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return flow->status = VM_SHORT_ARRAY;
    mass = given ? flow->mass : y[VM_Y_MASS];
    centre = given ? flow->centre : vmi_get3(y + VM_Y_CENTRE);
    inertia = given ? flow->inertia : vmi_get_inertia(y + VM_Y_INERTIA);
    status = vmi_flow_motion(flow, y, mass, &inertia, centre, &turn, &seen);
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(n, dydt);
    seen.energy = n == VM_FLOW_BALANCED_STATES;
    if (!vmi_stream_sums(flow->n, flow->streams, &seen, &sum)) return flow->status = VM_BAD_ARGUMENT;
    force = vmi_add(vmi_times(&turn, sum.pushed), vmi_scale(sum.carried, seen.v));
    force = vmi_add(flow->force, vmi_add(sum.absolute, force));
    moment = vmi_add(flow->moment, vmi_times(&turn, vmi_add(sum.moment, sum.own)));
    vmi_set3(dydt + VM_Y_R, vmi_add(seen.v, vmi_times(&turn, vmi_scale(1 / mass, sum.crossing))));
    vmi_stream_turning(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, seen.omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P, force);
    vmi_set3(dydt + VM_Y_H, moment);
    if (given) return 0;
    dydt[VM_Y_MASS] = sum.rate;
    vmi_set3(dydt + VM_Y_CENTRE, vmi_scale(1 / mass, sum.stored));
    vmi_set_inertia(dydt + VM_Y_INERTIA, &sum.inertia);
    if (seen.energy) vmi_flow_balance(flow, y, &seen, &sum, force, moment, dydt + VM_Y_BALANCE);
    return 0;
}

/* Documented with vm_flow_body. */
VM_API int vm_flow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_STATES, t, y, dydt);
}

/* 13 states; flow.update sets mass, centre and inertia. With no streams this is (170): what joins or leaves does so
   at rest where the mass centre is */
VM_API int vm_flow_given_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_GIVEN_STATES, t, y, dydt);
}

/* vm_flow_rhs, and from y[VM_Y_BALANCE] on, zero at first, what streams have carried off less what outer loads have
   brought: of momentum 3, angular momentum about the origin 3, kinetic energy 1. With the body's own all seven stay
   constant (the energy but for streams with a store, where angular momentum is y[VM_Y_H] + r x p). The energy goes
   by the limit of (113), (118), for either sign of M':
     T' = F v + M_S omega + sum [M' u^2 + omega2 M' kappa omega2]/2 - sum [M' w^2 + omega_r M' kappa omega_r]/2,
     w = u - v - omega x d, omega_r = omega2 - omega:
   the first sum is what the streams bring, the second what engines give (M' < 0) or plastic impact takes (M' > 0). */
VM_API int vm_flow_balanced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_BALANCED_STATES, t, y, dydt);
}

/* The same for what moves with the body (166). The states are r, q, v (not the momentum), omega in body axes (not the
   angular momentum); streams are not looked at: v' = F/M + R (omega x c'), r' = v + R c', I omega' + omega x I
   omega = M_S */
VM_API int vm_flow_carried_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow *flow = (vm_flow *)ctx;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const vm_vec3 omega = vmi_get3(y + VM_Y_H);
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    int status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    if (flow->y_size && flow->y_size < VM_FLOW_GIVEN_STATES) return flow->status = VM_SHORT_ARRAY;
    if (!vmi_inertia_factor_if_possible(&flow->inertia, &factors)) status = VM_BAD_INERTIA;
    if (!(flow->mass > 0)) status = VM_BAD_MASS;
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(VM_FLOW_GIVEN_STATES, dydt);
    turn = vmi_rotation_of_square(q, square);
    vmi_set3(dydt + VM_Y_R, vmi_add(vmi_get3(y + VM_Y_P), vmi_times(&turn, flow->drift)));
    vmi_stream_turning(q, square, omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P,
               vmi_add(vmi_scale(1 / flow->mass, flow->force), vmi_times(&turn, vmi_cross(omega, flow->drift))));
    vmi_set3(dydt + VM_Y_H,
               vmi_stream_euler(&flow->inertia, &factors, omega, vmi_times_transposed(&turn, flow->moment)));
    return 0;
}

/* How many numbers of the state vm_flow_start makes: as far as it is known that y has room */
VM_API int vmi_flow_size_at_start(const vm_flow *flow)
{
    if (flow->y_size && flow->y_size < VM_FLOW_STATES) return VM_FLOW_GIVEN_STATES;
    return flow->y_size < VM_FLOW_BALANCED_STATES ? VM_FLOW_STATES : VM_FLOW_BALANCED_STATES;
}

/* y: the VM_FLOW_STATES first states for body (fewer where y_size says so), streams being as they are at first;
   VM_BAD_ARGUMENT (a null pointer, an unknown motion), VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA (that of a rod
   or a point too) */
VM_API int vm_flow_start(vm_flow *flow, const vm_body *body, vm_real *y)
{
    vm_vec3 p, h;
    vm_quat q;
    vmi_inertia_ldl factors;
    vmi_mat3 turn;
    vm_real start[VM_FLOW_BALANCED_STATES];
    int status, k;
    if (!flow || !body || !y) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_streams_are_valid(flow->n, flow->streams);
    if (!status &&
        !(vmi_vec3_finite(flow->centre) && vmi_vec3_finite(flow->force) && vmi_vec3_finite(flow->moment)))
        status = VM_NOT_FINITE;
    if (!status && !vmi_inertia_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    q = vmi_unit_quat(body->q);
    turn = vmi_rotation(q);
    vmi_stream_on_the_way(flow->n, flow->streams, flow->centre, &p, &h);
    start[VM_Y_Q] = q.w;
    start[VM_Y_Q + 1] = q.x;
    start[VM_Y_Q + 2] = q.y;
    start[VM_Y_Q + 3] = q.z;
    vmi_set3(start + VM_Y_R, body->r);
    vmi_set3(start + VM_Y_P, vm_momentum(body));
    vmi_set3(start + VM_Y_H, vmi_add(vmi_spin_momentum(body), vmi_times(&turn, h)));
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

/* The body of n states, with q of length 1: n = VM_FLOW_GIVEN_STATES takes mass, centre and inertia from flow, more from y.
   The states of vm_flow_carried_rhs are other ones: not for them. */
VM_API int vm_flow_body(const vm_flow *flow, int n, const vm_real *y, vm_body *body)
{
    const int given = n < VM_FLOW_STATES;
    vm_vec3 centre;
    vm_body b;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    int status;
    if (!flow || !y || !body || n < VM_FLOW_GIVEN_STATES || !vmi_flow_has(flow->n, flow->streams)) return VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return VM_SHORT_ARRAY;
    b.mass = given ? flow->mass : y[VM_Y_MASS];
    b.inertia = given ? flow->inertia : vmi_get_inertia(y + VM_Y_INERTIA);
    centre = given ? flow->centre : vmi_get3(y + VM_Y_CENTRE);
    status = vmi_flow_motion(flow, y, b.mass, &b.inertia, centre, &turn, &seen);
    if (status) return status;
    b.q = vmi_unit_quat(vmi_get_quat(y + VM_Y_Q));
    b.r = vmi_get3(y + VM_Y_R);
    b.v = seen.v;
    b.omega = vmi_times(&turn, seen.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* Event functions of vm_flow_rhs and vm_flow_balanced_rhs, ctx the flow: mass - least_mass; least pivot of I - least_inertia,
   0 where I is singular. They do not watch the triangle inequality, whose limit is near for thin bodies. */
VM_API vm_real vm_flow_mass_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    (void)t;
    return y[VM_Y_MASS] - ((const vm_flow *)flow)->least_mass;
}

/* Documented with vm_flow_mass_left. */
VM_API vm_real vm_flow_inertia_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    const vm_inertia i = vmi_get_inertia(y + VM_Y_INERTIA);
    vmi_inertia_ldl f;
    vm_real least = i.xx;
    (void)t;
    if (vmi_inertia_factor(&i, &f)) {
        if (1 / f.y < least) least = 1 / f.y;
        if (1 / f.z < least) least = 1 / f.z;
    } else least = 0;
    return least - ((const vm_flow *)flow)->least_inertia;
}

#endif
