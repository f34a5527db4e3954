/* mechanics/streams.h - streams of mass: reactive force and torque */
#ifndef VARMASS_MECHANICS_STREAMS_H
#define VARMASS_MECHANICS_STREAMS_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "vectors.h"

/* A stream carries mass into a body (rate > 0) or out of it (rate < 0) at one point. Zero fields are fair defaults,
   and what does not act costs nothing; the loads of several streams add. Its velocity is given as its motion says: */
enum {
    VM_RELATIVE = 0, /* velocity against the point of the body where it crosses, spin against the body: body axes */
    VM_ABSOLUTE = 1, /* velocity and spin as they are: inertial axes */
    VM_CARRIED = 2,  /* moves with the body: no torque, but M' omega x d is left of the force that (166) has as 0 */
    VM_AT_REST = 3   /* has neither velocity nor spin (167)-(169) */
};

typedef struct VM_TAG(vm_store) {
    vm_vec3 at;          /* m, body axes, from the body's reference point */
    vm_inertia gyration; /* m^2, body axes: inertia per unit mass of what is stored there, about its mass centre */
} vm_store;

typedef struct VM_TAG(vm_stream) {
    vm_real rate;        /* kg/s */
    int motion;          /* VM_RELATIVE ... */
    vm_vec3 at;          /* m, where it crosses, body axes, from the body's reference point */
    vm_vec3 velocity;    /* m/s */
    vm_vec3 spin;        /* rad/s */
    vm_inertia gyration; /* m^2, body axes: inertia per unit mass of what crosses, about its own mass centre */
    /* where the mass is taken from or put; null: where it crosses. Between the two it flows in a straight line, with
       what it has of momentum on the way */
    const vm_store *from;
} vm_stream;

/* Reactive loads at an instant, inertial axes but for inertia_rate. With d = SS2 from the mass centre to the crossing
   point, M' the rate, u the velocity, kappa the gyration, omega2 the angular velocity of each stream:
     force   sum M' (u - v)                             (156)
     moment  sum d x M' (u - v)                         (158)
     torque  sum M' kappa omega2 - I' omega             (157) corrected: printed I' (omega2 - omega), which is right
                                                        only for P(d) omega2 = 0
     drift   sum (M'/M) d:  dr/dt = v + drift           not in [1]
     inertia_rate  I' = sum M' (kappa + P(d)), body axes
   Then M v' = F + force (159) and I omega' + omega x I omega = M_S + moment + torque (160): v' is the rate of
   momentum/mass, which v is. */
typedef struct VM_TAG(vm_reactive) {
    vm_vec3 force, moment, torque, drift; /* N, N m, N m, m/s */
    vm_real mass_rate;                    /* kg/s */
    vm_inertia inertia_rate;              /* kg m^2/s */
} vm_reactive;

VM_INLINE int vmi_stream_motion_is_known(int motion) { return motion >= VM_RELATIVE && motion <= VM_AT_REST; }

/* What the streams of a moving body add up to, body axes */
typedef struct VM_TAG(vmi_stream_sum) {
    vm_real rate, carried;    /* sum M'; that of the streams whose velocity is given relative to the body, */
    vm_vec3 pushed;           /* their sum M' (u - v), */
    vm_vec3 absolute;         /* and sum M' u of the others, inertial axes: exact where u = 0 */
    vm_vec3 moment;           /* sum d x M' (u - v) */
    vm_vec3 own;              /* sum M' kappa omega2 */
    vm_vec3 crossing, stored; /* sum M' d, sum M' d_s */
    vm_inertia inertia;       /* I' */
    vm_real brought, lost;    /* twice the sums of T' */
} vmi_stream_sum;

/* Momentum, and angular momentum about the mass centre, of what is between the stores and the points of crossing */
VM_INLINE void vmi_stream_on_the_way(int n, const vm_stream *s, vm_vec3 centre, vm_vec3 *p, vm_vec3 *h)
{
    int k;
    *p = *h = vmi_vec3(0, 0, 0);
    for (k = 0; k < n; k++) {
        if (!s[k].from) continue;
        *p = vmi_add(*p, vmi_scale(s[k].rate, vmi_sub(s[k].from->at, s[k].at)));
        *h = vmi_add(*h, vmi_scale(s[k].rate, vmi_cross(vmi_sub(s[k].at, centre), vmi_sub(s[k].from->at, centre))));
    }
}

/* M' kappa */
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

/* The motion of a body as the streams see it: v = momentum/mass in inertial axes; in body axes slip, the velocity
   of its material at the mass centre less v, omega and the mass centre. energy: brought and lost are wanted */
typedef struct VM_TAG(vmi_stream_seen) {
    const vmi_mat3 *turn;
    vm_vec3 v, slip, omega, centre;
    int energy;
} vmi_stream_seen;

/* M' (u - v) and omega2 of a stream, body axes, and its part of the momentum's rate; 0 for an unknown motion */
VM_INLINE int vmi_stream_motion(const vm_stream *s, const vmi_stream_seen *b, vm_vec3 carried, vmi_stream_sum *sum,
                                vm_vec3 *push, vm_vec3 *spin)
{
    switch (s->motion) {
    case VM_RELATIVE:
        carried = vmi_add(carried, s->velocity);
        *spin = vmi_add(b->omega, s->spin);
        break;
    case VM_ABSOLUTE:
        *push = vmi_scale(s->rate, vmi_times_transposed(b->turn, vmi_sub(s->velocity, b->v)));
        *spin = vmi_times_transposed(b->turn, s->spin);
        sum->absolute = vmi_add(sum->absolute, vmi_scale(s->rate, s->velocity));
        return 1;
    case VM_CARRIED: *spin = b->omega; break;
    case VM_AT_REST:
        *push = vmi_times_transposed(b->turn, vmi_scale(-s->rate, b->v));
        *spin = vmi_vec3(0, 0, 0);
        return 1;
    default: return 0;
    }
    *push = vmi_scale(s->rate, carried);
    sum->carried += s->rate;
    sum->pushed = vmi_add(sum->pushed, *push);
    return 1;
}

VM_INLINE void vmi_stream_energy(const vm_stream *s, const vmi_stream_seen *b, const vm_inertia *own, vm_vec3 push,
                                 vm_vec3 spin, vm_vec3 carried, vmi_stream_sum *sum)
{
    const vm_vec3 u = s->rate != 0 ? vmi_scale(1 / s->rate, push) : push, relative = vmi_sub(spin, b->omega);
    const vm_vec3 absolute = vmi_add(u, vmi_times_transposed(b->turn, b->v)), w = vmi_sub(u, carried);
    sum->brought += s->rate * vmi_dot(absolute, absolute) + vmi_dot(spin, vmi_inertia_times(own, spin));
    sum->lost += s->rate * vmi_dot(w, w) + vmi_dot(relative, vmi_inertia_times(own, relative));
}

VM_INLINE int vmi_stream_sums(int n, const vm_stream *s, const vmi_stream_seen *b, vmi_stream_sum *sum)
{
    const vmi_stream_sum none = {0,         0,         {0, 0, 0},          {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
                                 {0, 0, 0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0}, 0,         0};
    int k;
    *sum = none;
    for (k = 0; k < n; k++, s++) {
        const vm_vec3 d = vmi_sub(s->at, b->centre), carried = vmi_add(b->slip, vmi_cross(b->omega, d));
        vm_inertia own = vmi_stream_own(s->rate, &s->gyration);
        vm_vec3 push, spin, stored = d;
        if (!vmi_stream_motion(s, b, carried, sum, &push, &spin)) return 0;
        if (b->energy) vmi_stream_energy(s, b, &own, push, spin, carried, sum);
        sum->rate += s->rate;
        sum->moment = vmi_add(sum->moment, vmi_cross(d, push));
        sum->own = vmi_add(sum->own, vmi_inertia_times(&own, spin));
        sum->crossing = vmi_add(sum->crossing, vmi_scale(s->rate, d));
        if (s->from) {
            stored = vmi_sub(s->from->at, b->centre);
            own = vmi_stream_own(s->rate, &s->from->gyration);
        }
        sum->stored = vmi_add(sum->stored, vmi_scale(s->rate, stored));
        /* as a whole, so that opposite streams cancel */
        own = vmi_inertia_plus(own, s->rate, vmi_inertia_of_point(stored));
        sum->inertia = vmi_inertia_plus(sum->inertia, 1, own);
    }
    return 1;
}

/* The loads of an instant */
/* VM_OK if i is finite and has no negative moment. Only the body has to satisfy the triangle inequality: in plane
   motion a tensor with zz alone is enough, as long as the body is not that flat itself */
VM_API int vmi_gyration_is_valid(const vm_inertia *i)
{
    if (!vmi_inertia_finite(i)) return VM_NOT_FINITE;
    return i->xx >= 0 && i->yy >= 0 && i->zz >= 0 ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_stream_is_valid(const vm_stream *s)
{
    int status;
    if (!vmi_stream_motion_is_known(s->motion)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(s->rate) || !vmi_vec3_finite(s->at) || !vmi_vec3_finite(s->velocity) ||
        !vmi_vec3_finite(s->spin))
        return VM_NOT_FINITE;
    status = vmi_gyration_is_valid(&s->gyration);
    if (status || !s->from) return status;
    return vmi_vec3_finite(s->from->at) ? vmi_gyration_is_valid(&s->from->gyration) : VM_NOT_FINITE;
}

VM_API int vmi_streams_are_valid(int n, const vm_stream *s)
{
    int k, status = n < 0 || (n > 0 && !s) ? VM_BAD_ARGUMENT : VM_OK;
    for (k = 0; !status && k < n; k++) status = vmi_stream_is_valid(s + k);
    return status;
}

/* centre: mass centre from the reference point, body axes. VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA,
   VM_BAD_ARGUMENT (a null pointer, an unknown motion, n < 0), VM_STORED_STREAM */
VM_API int vm_reactive_loads(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams,
                             vm_reactive *result)
{
    vmi_mat3 turn;
    vmi_stream_sum sum;
    vmi_stream_seen seen;
    vm_reactive r;
    int status, k;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_streams_are_valid(n, streams);
    if (!status && !vmi_vec3_finite(centre)) status = VM_NOT_FINITE;
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
    r.force = vmi_add(vmi_times(&turn, sum.pushed),
                      vmi_sub(sum.absolute, vmi_scale(sum.rate - sum.carried, body->v)));
    r.moment = vmi_times(&turn, sum.moment);
    r.torque = vmi_times(&turn, vmi_sub(sum.own, vmi_inertia_times(&sum.inertia, seen.omega)));
    r.drift = vmi_scale(1 / body->mass, vmi_times(&turn, sum.crossing));
    r.mass_rate = sum.rate;
    r.inertia_rate = sum.inertia;
    if (!vmi_vec3_finite(r.force) || !vmi_vec3_finite(r.moment) || !vmi_vec3_finite(r.torque) ||
        !vmi_vec3_finite(r.drift) || !VM_IS_FINITE(r.mass_rate) || !vmi_inertia_finite(&r.inertia_rate))
        return VM_NOT_FINITE;
    *result = r;
    return VM_OK;
}

/* I^-1 (moment - omega x I omega), body axes */
VM_INLINE vm_vec3 vmi_stream_euler(const vm_inertia *i, const vmi_inertia_ldl *factors, vm_vec3 omega,
                                   vm_vec3 moment)
{
    return vmi_inertia_solve(factors, vmi_sub(moment, vmi_cross(omega, vmi_inertia_times(i, omega))));
}

/* v' (159) and omega' (160), inertial axes, under the resultant F of the outer loads and their moment M_S about the
   mass centre; VM_BAD_INERTIA where the inertia is singular */
VM_API int vm_accelerations(const vm_body *body, const vm_reactive *loads, vm_vec3 force, vm_vec3 moment,
                            vm_vec3 *acceleration, vm_vec3 *angular_acceleration)
{
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    vm_vec3 straight, turning;
    int status;
    if (!body || !loads || !acceleration || !angular_acceleration) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status && !vmi_inertia_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    turn = vmi_rotation(body->q);
    moment = vmi_add(moment, vmi_add(loads->moment, loads->torque));
    straight = vmi_scale(1 / body->mass, vmi_add(force, loads->force));
    turning = vmi_stream_euler(&body->inertia, &factors, vmi_times_transposed(&turn, body->omega),
                               vmi_times_transposed(&turn, moment));
    turning = vmi_times(&turn, turning);
    if (!vmi_vec3_finite(straight) || !vmi_vec3_finite(turning)) return VM_NOT_FINITE;
    *acceleration = straight;
    *angular_acceleration = turning;
    return VM_OK;
}

/* Closed forms, for mass and velocity or, about a fixed axle, for inertia and angular velocity. v when the mass has
   come from m0 to m: where what crosses has the absolute velocity u, impulse being that of the outer forces (151),
   (171), Levi-Civita's case for u = 0; where it has the relative velocity w and there is no outer force (175), (176),
   Tsiolkovsky's. Within 4 eps of the terms; NaN where a mass is not positive and for infinite arguments. */
VM_API vm_real vm_velocity_by_momentum(vm_real v0, vm_real m0, vm_real m, vm_real u, vm_real impulse)
{
    if (!(m0 > 0 && m > 0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(u) || !VM_IS_FINITE(impulse)) return VM_NAN;
    return v0 * (m0 / m) + ((m - m0) * u + impulse) / m;
}

#endif
