/* mechanics/streams.h - streams of mass: reactive force, moment and torque

   A stream brings mass into a body, or takes mass out of it, at one point. This mass has momentum and angular
   momentum. Therefore a reactive force, a reactive moment and a reactive torque act on the body, by the equations
   (156), (158), (157) of the dissertation [1]. Force, moment and torque together are called reactive loads here. This
   chapter computes the reactive loads at an instant and the accelerations that follow from them, (159) and (160). To
   integrate a motion, use mechanics/flow.h (in space), flow2.h (in a plane) or flow1.h (on a line or an axle).

       vm_vec3 centre = {0, 0, 0}; // the mass centre is the reference point
       vm_stream nozzle;
       vm_reactive loads;
       memset(&nozzle, 0, sizeof nozzle);
       nozzle.rate = -2;          // 2 kg/s leave
       nozzle.velocity.x = -2500; // m/s, relative to the body: VM_RELATIVE is 0
       if (vm_reactive_loads(&body, centre, 1, &nozzle, &loads) == VM_OK) printf("%g N\n", loads.force.x); // 5000 N

   Tests: tests/test_streams.c. */
#ifndef VARMASS_MECHANICS_STREAMS_H
#define VARMASS_MECHANICS_STREAMS_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "inertia_factors.h"
#include "vectors.h"

/* How the fields velocity and spin of a stream describe the motion of its mass. Spin means angular velocity. "The
   point" is the point of the body's surface at which the mass enters or leaves. */
enum {
    VM_RELATIVE = 0, /* velocity relative to the point, spin relative to the body, both in body axes */
    VM_ABSOLUTE = 1, /* absolute velocity and spin, in inertial axes */
    VM_CARRIED = 2,  /* the mass has the velocity of the point and the spin of the body; the fields velocity and spin of
                        the stream are not used, but must be finite. If the stream has no store, its reactive moment
                        and its reactive torque cancel. Its reactive force is M' omega x d, which (166) of [1]
                        neglects. M' is the rate of the stream, omega the body's spin, and d the vector from the mass
                        centre to the point. */
    VM_AT_REST = 3   /* the mass is at rest (167)-(169); the fields velocity and spin of the stream are not used, but
                        must be finite */
};

/* A store of mass inside a body, for example a tank. A stream that leaves the body takes its mass from the store, and a
   stream that enters puts its mass into the store. A stream needs a store if the body stores the mass at another
   position than the point at which the stream crosses the surface of the body. */
typedef struct VM_TAG(vm_store) {
    vm_vec3 at;          /* position from the body's reference point, m, body axes */
    vm_inertia gyration; /* inertia per unit mass of the stored mass, about its own mass centre, m^2, body axes */
} vm_store;

/* A stream of mass in space. Every field may be zero. */
typedef struct VM_TAG(vm_stream) {
    vm_real rate;         /* mass per time, kg/s; > 0: mass joins the body, < 0: mass leaves it */
    int motion;           /* what velocity and spin mean: VM_RELATIVE, VM_ABSOLUTE, VM_CARRIED or VM_AT_REST */
    vm_vec3 at;           /* point at which the mass enters or leaves, from the body's reference point, m, body axes */
    vm_vec3 velocity;     /* velocity of the mass as it enters or leaves the body, m/s */
    vm_vec3 spin;         /* angular velocity of the mass as it enters or leaves the body, rad/s */
    vm_inertia gyration;  /* inertia per unit mass of the mass that enters or leaves, about its own mass centre, m^2,
                             body axes */
    const vm_store *from; /* the store that the mass comes from or goes to, or NULL for none. Between the store and the
                             point `at` the mass flows in a straight line. While the mass flows there, its momentum is
                             a part of the body's momentum. */
} vm_stream;

/* The reactive loads at an instant. All vectors are in inertial axes; only inertia_rate is in body axes. The body has
   the mass M, the inertia I, the velocity v (momentum/mass) and the angular velocity omega. For each stream M' is the
   rate (> 0 if mass joins, < 0 if mass leaves), u the absolute velocity of the stream's mass, omega2 the angular
   velocity of this mass and kappa its gyration. u - v is the velocity of this mass relative to a frame that moves at
   the velocity v and does not turn. The vector d leads from the body's mass centre to the point at which the mass
   enters or leaves, and P(d) = |d|^2 E - d d^T with the unit matrix E is the inertia per unit mass of a point mass at
   d. Each sum is over all streams:
     force   sum M' (u - v)                             (156)
     moment  sum d x M' (u - v)                         (158)
     torque  (sum M' kappa omega2) - I' omega           (157) corrected: [1] prints I' (omega2 - omega), which is right
                                                        only for P(d) omega2 = 0
     drift   sum (M'/M) d:  dr/dt = v + drift           not in [1]
     inertia_rate  I' = sum M' (kappa + P(d)), body axes
   The equations of motion are M v' = F + force (159) and I omega' + omega x I omega = M_S + moment + torque (160),
   with the outer force F and the outer moment M_S about the mass centre. v' is the rate of v. */
typedef struct VM_TAG(vm_reactive) {
    vm_vec3 force;           /* reactive force, N */
    vm_vec3 moment;          /* reactive moment about the mass centre, N m */
    vm_vec3 torque;          /* reactive torque, N m */
    vm_vec3 drift;           /* velocity of the mass centre relative to the body's material, m/s */
    vm_real mass_rate;       /* rate of the body's mass, the sum of M' over all streams, kg/s */
    vm_inertia inertia_rate; /* rate of the body's inertia, kg m^2/s, body axes */
} vm_reactive;

VM_INLINE int vmi_stream_motion_is_known(int motion) { return motion >= VM_RELATIVE && motion <= VM_AT_REST; }

/* For every value of the field `motion`, the velocity u of a stream's mass is the sum of two terms. The first term is
   the velocity of the body's point, or zero; the second term is the stream's field `velocity`, or zero. The spin of the
   mass is also a sum of two terms: the spin of the body, or zero, and the field `spin`, or zero.
   vmi_stream_moves_with_body returns 1 if the first term is the velocity of the point, and vmi_stream_velocity_is_given
   returns 1 if the second term is the field `velocity`. Apart from vmi_stream_motion_is_known, no other function
   depends on the four values VM_RELATIVE ... VM_AT_REST. */
VM_INLINE int vmi_stream_moves_with_body(int motion) { return motion == VM_RELATIVE || motion == VM_CARRIED; }
VM_INLINE int vmi_stream_velocity_is_given(int motion) { return motion == VM_RELATIVE || motion == VM_ABSOLUTE; }

/* Returns the velocity u of the mass of a stream, for a body that moves along a line. `own` is the velocity of the
   body. The arguments `motion` and `given` are the fields `motion` and `velocity` of the stream. */
VM_INLINE vm_real vmi_stream_velocity1(int motion, vm_real own, vm_real given)
{
    vm_real u = 0;
    if (vmi_stream_moves_with_body(motion)) u = own;
    if (vmi_stream_velocity_is_given(motion)) u += given;
    return u;
}

/* Returns the product M' kappa of the rate M' of a stream and the gyration kappa of its mass. Gyration means inertia
   per unit mass. */
VM_INLINE vm_inertia vmi_stream_own(vm_real rate, const vm_inertia *gyration)
{
    vm_inertia i;
    i.xx = rate * gyration->xx;
    i.yy = rate * gyration->yy;
    i.zz = rate * gyration->zz;
    i.xy = rate * gyration->xy;
    i.xz = rate * gyration->xz;
    i.yz = rate * gyration->yz;
    return i;
}

/* Sets *p to the momentum, and *h to the angular momentum about the mass centre, of the mass that flows between the
   stores of the streams and the surface of the body. `centre` is the position of the mass centre, from the body's
   reference point. If a stream of rate M' flows in a straight line between its store at the position a and the surface
   at the position b, the flowing mass has the momentum M' (a - b). This momentum does not depend on the speed of the
   flow, because a faster flow has less mass on its way. */
VM_INLINE void vmi_stream_on_the_way(int n, const vm_stream *s, vm_vec3 centre, vm_vec3 *p, vm_vec3 *h)
{
    int k;
    *p = *h = vmi_vec3(0, 0, 0);
    for (k = 0; k < n; k++) {
        if (!s[k].from) continue;
        *p = vm_add(*p, vm_scale(s[k].rate, vm_sub(s[k].from->at, s[k].at)));
        *h = vm_add(*h, vm_scale(s[k].rate, vm_cross(vm_sub(s[k].at, centre), vm_sub(s[k].from->at, centre))));
    }
}

/* The motion of a body, in the form that the sums over its streams need */
typedef struct VM_TAG(vmi_stream_seen) {
    const vmi_mat3 *turn; /* the rotation from body axes to inertial ones */
    vm_vec3 v;            /* velocity, which is momentum/mass, inertial axes */
    vm_vec3 slip;         /* velocity of the body's material at the mass centre minus v, body axes */
    vm_vec3 omega;        /* angular velocity, body axes */
    vm_vec3 centre;       /* vector from the reference point to the mass centre, body axes */
    int energy;           /* 1 if the sums `brought` and `lost` of vmi_stream_sum must be computed */
} vmi_stream_seen;

/* The sums over the streams of a moving body, in body axes except `absolute`. The letters M', u, v, d, kappa, omega2
   are explained at vm_reactive. If a stream's velocity is given relative to the body, the sums use this velocity as the
   difference u - v, which is then not computed from u and v: if the body is fast, it would lose digits. */
typedef struct VM_TAG(vmi_stream_sum) {
    vm_real rate;       /* total mass rate, the sum of M' over all streams, kg/s */
    vm_real carried;    /* sum of M' of the streams whose velocity is relative to the body */
    vm_vec3 pushed;     /* force of the streams whose velocity is relative to the body: sum of M' (u - v) */
    vm_vec3 absolute;   /* sum of M' u of the streams whose velocity u is absolute, inertial axes */
    vm_vec3 moment;     /* moment of all streams about the mass centre: sum of d x M' (u - v) */
    vm_vec3 own;        /* sum of M' kappa omega2: angular momentum that the streams bring per second by their spin */
    vm_vec3 crossing;   /* sum of M' d, where d leads from the mass centre to the point of the surface */
    vm_vec3 stored;     /* sum of M' d_s, where d_s leads from the mass centre to the store; d_s = d without a store */
    vm_inertia inertia; /* I', the rate of the body's inertia */
    vm_real brought;    /* sum of M' u^2 + omega2 M' kappa omega2: twice the kinetic energy that the streams bring per
                           second */
    vm_real lost;       /* the sum `brought`, but with the velocity relative to the point of the surface and the spin
                           relative to the body: twice the power lost by mixing; < 0 if the mass leaves */
} vmi_stream_sum;

/* Adds the terms of one stream to sum->carried, sum->pushed and sum->absolute. The field `motion` of the stream must
   have one of the known values. Sets *push = M' (u - v), where M' is the rate, u the absolute velocity of the mass and
   v the velocity of the body. Sets *spin to the angular velocity of the mass. The argument `carried` is the velocity
   of the body's point at which the mass enters or leaves, minus v. All vectors are in body axes. */
VM_INLINE void vmi_stream_motion(const vm_stream *s, const vmi_stream_seen *b, vm_vec3 carried, vmi_stream_sum *sum,
                                 vm_vec3 *push, vm_vec3 *spin)
{
    const int given = vmi_stream_velocity_is_given(s->motion);
    if (vmi_stream_moves_with_body(s->motion)) {
        *spin = b->omega;
        if (given) {
            carried = vm_add(carried, s->velocity);
            *spin = vm_add(b->omega, s->spin);
        }
        *push = vm_scale(s->rate, carried);
        sum->carried += s->rate;
        sum->pushed = vm_add(sum->pushed, *push);
    } else if (given) {
        *push = vm_scale(s->rate, vmi_times_transposed(b->turn, vm_sub(s->velocity, b->v)));
        *spin = vmi_times_transposed(b->turn, s->spin);
        sum->absolute = vm_add(sum->absolute, vm_scale(s->rate, s->velocity));
    } else {
        *push = vmi_times_transposed(b->turn, vm_scale(-s->rate, b->v));
        *spin = vmi_vec3(0, 0, 0);
    }
}

/* Adds the terms of one stream to sum->brought and sum->lost. `own` is the product M' kappa of the stream's rate and
   gyration. `push` and `spin` are results of vmi_stream_motion, and `carried` is an argument of that function. */
VM_INLINE void vmi_stream_energy(const vm_stream *s, const vmi_stream_seen *b, const vm_inertia *own, vm_vec3 push,
                                 vm_vec3 spin, vm_vec3 carried, vmi_stream_sum *sum)
{
    const vm_vec3 relative = vm_sub(spin, b->omega);
    vm_vec3 u = push, absolute, w;
    if (s->rate != 0) u = vmi_over(push, s->rate);
    absolute = vm_add(u, vmi_times_transposed(b->turn, b->v));
    w = vm_sub(u, carried);
    sum->brought += s->rate * vm_dot(absolute, absolute) + vm_dot(spin, vmi_inertia_times(own, spin));
    sum->lost += s->rate * vm_dot(w, w) + vm_dot(relative, vmi_inertia_times(own, relative));
}

/* Computes the sums of vmi_stream_sum over the n streams of a moving body. Returns 0 if the `motion` of a stream is
   unknown, else 1. */
VM_INLINE int vmi_stream_sums(int n, const vm_stream *s, const vmi_stream_seen *b, vmi_stream_sum *sum)
{
    const vmi_stream_sum none = {0,         0,         {0, 0, 0},          {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
                                 {0, 0, 0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0}, 0,         0};
    int k;
    *sum = none;
    for (k = 0; k < n; k++, s++) {
        const vm_vec3 d = vm_sub(s->at, b->centre), carried = vm_add(b->slip, vm_cross(b->omega, d));
        vm_inertia own = vmi_stream_own(s->rate, &s->gyration);
        vm_vec3 push, spin, stored = d;
        if (!vmi_stream_motion_is_known(s->motion)) return 0;
        vmi_stream_motion(s, b, carried, sum, &push, &spin);
        if (b->energy) vmi_stream_energy(s, b, &own, push, spin, carried, sum);
        sum->rate += s->rate;
        sum->moment = vm_add(sum->moment, vm_cross(d, push));
        sum->own = vm_add(sum->own, vmi_inertia_times(&own, spin));
        sum->crossing = vm_add(sum->crossing, vm_scale(s->rate, d));
        if (s->from) {
            stored = vm_sub(s->from->at, b->centre);
            own = vmi_stream_own(s->rate, &s->from->gyration);
        }
        sum->stored = vm_add(sum->stored, vm_scale(s->rate, stored));
        /* add the term M' (kappa + P(d)) as a whole, so that the terms of opposite streams cancel exactly */
        own = vmi_inertia_plus(own, s->rate, vmi_inertia_of_point(stored));
        sum->inertia = vmi_inertia_plus(sum->inertia, 1, own);
    }
    return 1;
}

/* Gyration means the inertia per unit mass of the mass in a stream or a store. Returns VM_NOT_FINITE if an entry of the
   gyration is infinite or NaN; VM_BAD_INERTIA if one of its moments xx, yy, zz is negative; else VM_OK. Only the
   inertia of the body must satisfy the triangle inequality zz <= xx + yy; a gyration need not. Therefore a gyration
   for motion in a plane may consist of the entry zz alone, with zero for all other entries. */
VM_API int vmi_check_gyration(const vm_inertia *i)
{
    if (!vmi_inertia_is_finite(i)) return VM_NOT_FINITE;
    if (!(i->xx >= 0 && i->yy >= 0 && i->zz >= 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Checks a stream. Returns VM_BAD_ARGUMENT if its field `motion` has none of the four values VM_RELATIVE ...
   VM_AT_REST; VM_NOT_FINITE if a number is infinite or NaN; VM_BAD_INERTIA if a moment xx, yy or zz of the gyration
   (the inertia per unit mass) of the stream or of its store is negative; else VM_OK. */
VM_API int vmi_check_stream(const vm_stream *s)
{
    int status;
    if (!vmi_stream_motion_is_known(s->motion)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(s->rate) || !vmi_vec3_is_finite(s->at) || !vmi_vec3_is_finite(s->velocity) ||
        !vmi_vec3_is_finite(s->spin))
        return VM_NOT_FINITE;
    status = vmi_check_gyration(&s->gyration);
    if (!s->from) return status;
    if (!vmi_vec3_is_finite(s->from->at)) return VM_NOT_FINITE;
    return vmi_first_error(status, vmi_check_gyration(&s->from->gyration));
}

/* Returns VM_OK if all n streams are valid, else the error that vmi_first_error selects from their errors. */
VM_API int vmi_check_streams(int n, const vm_stream *s)
{
    int k, status = VM_OK;
    if (n < 0 || (n > 0 && !s)) return VM_BAD_ARGUMENT;
    for (k = 0; k < n; k++) status = vmi_first_error(status, vmi_check_stream(s + k));
    return status;
}

VM_API int vmi_reactive_finite(const vm_reactive *r)
{
    return vmi_vec3_is_finite(r->force) && vmi_vec3_is_finite(r->moment) && vmi_vec3_is_finite(r->torque) &&
           vmi_vec3_is_finite(r->drift) && VM_IS_FINITE(r->mass_rate) && vmi_inertia_is_finite(&r->inertia_rate);
}

/* Reactive force, moment and torque of n streams on a moving body, (156)-(158). `centre` is the vector from the
   body's reference point to its mass centre, in body axes (m). Each load is a sum over all streams; the comment of
   vm_reactive has the formulas. Returns
   - VM_BAD_ARGUMENT for a null pointer, for n < 0 and for an unknown `motion` of a stream;
   - VM_NOT_FINITE if an argument or the result is infinite or NaN;
   - VM_BAD_MASS if the body's mass is not positive;
   - VM_BAD_INERTIA if no body can have the inertia of the body, or if a moment of a gyration is negative;
   - VM_STORED_STREAM if a stream has a store (integrate vm_flow_rhs instead);
   - VM_OK otherwise. */
VM_API int vm_reactive_loads(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams,
                             vm_reactive *result)
{
    vmi_mat3 turn;
    vmi_stream_sum sum;
    vmi_stream_seen seen;
    vm_reactive r;
    int status, k;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_first_error(vmi_check_body(body), vmi_check_streams(n, streams));
    if (!vmi_vec3_is_finite(centre)) status = vmi_first_error(status, VM_NOT_FINITE);
    for (k = 0; !status && k < n; k++)
        if (streams[k].from) status = VM_STORED_STREAM;
    if (status) return status;
    turn = vmi_rotation(body->q);
    seen.turn = &turn;
    seen.v = body->v;
    seen.slip = vmi_vec3(0, 0, 0);
    seen.centre = centre;
    seen.energy = 0;
    seen.omega = vmi_times_transposed(&turn, body->omega);
    vmi_stream_sums(n, streams, &seen, &sum);
    r.force = vm_add(vmi_times(&turn, sum.pushed),
                      vm_sub(sum.absolute, vm_scale(sum.rate - sum.carried, body->v)));
    r.moment = vmi_times(&turn, sum.moment);
    r.torque = vmi_times(&turn, vm_sub(sum.own, vmi_inertia_times(&sum.inertia, seen.omega)));
    r.drift = vm_scale(1 / body->mass, vmi_times(&turn, sum.crossing));
    r.mass_rate = sum.rate;
    r.inertia_rate = sum.inertia;
    if (!vmi_reactive_finite(&r)) return VM_NOT_FINITE;
    *result = r;
    return VM_OK;
}

/* Returns the angular acceleration I^-1 (moment - omega x I omega) by Euler's equations, for the inertia I = *i and its
   factors *factors (vmi_inertia_factor). All vectors are in body axes. */
VM_INLINE vm_vec3 vmi_stream_euler(const vm_inertia *i, const vmi_inertia_ldl *factors, vm_vec3 omega,
                                   vm_vec3 moment)
{
    return vmi_inertia_solve(factors, vm_sub(moment, vm_cross(omega, vmi_inertia_times(i, omega))));
}

/* Accelerations v' (159) and omega' (160) of a body under reactive and outer loads.
   All vectors are in inertial axes. `force` is the resultant of the outer forces (N), `moment` their moment about the
   mass centre (N m). *acceleration is v', the rate of momentum/mass (m/s^2), and *angular_acceleration is omega'
   (rad/s^2). Of *loads only the fields force, moment and torque are used. Returns VM_BAD_ARGUMENT for a null pointer;
   VM_NOT_FINITE if a number that is used, or the result, is infinite or NaN; VM_BAD_MASS if the body's mass is not
   positive; VM_BAD_INERTIA if no body can have the inertia, and also for the singular inertia of a rod or a point;
   VM_OK otherwise. */
VM_API int vm_accelerations(const vm_body *body, const vm_reactive *loads, vm_vec3 force, vm_vec3 moment,
                            vm_vec3 *acceleration, vm_vec3 *angular_acceleration)
{
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    vm_vec3 sum, linear, angular;
    int status;
    if (!body || !loads || !acceleration || !angular_acceleration) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!vmi_vec3_is_finite(force) || !vmi_vec3_is_finite(moment) || !vmi_vec3_is_finite(loads->force) ||
        !vmi_vec3_is_finite(loads->moment) || !vmi_vec3_is_finite(loads->torque))
        status = vmi_first_error(status, VM_NOT_FINITE);
    if (!status && !vmi_inertia_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    turn = vmi_rotation(body->q);
    sum = vm_add(moment, vm_add(loads->moment, loads->torque));
    linear = vm_scale(1 / body->mass, vm_add(force, loads->force));
    angular = vmi_stream_euler(&body->inertia, &factors, vmi_times_transposed(&turn, body->omega),
                               vmi_times_transposed(&turn, sum));
    angular = vmi_times(&turn, angular);
    if (!vmi_vec3_is_finite(linear) || !vmi_vec3_is_finite(angular)) return VM_NOT_FINITE;
    *acceleration = linear;
    *angular_acceleration = angular;
    return VM_OK;
}

#endif
