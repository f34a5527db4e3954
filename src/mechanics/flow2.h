/* mechanics/flow2.h - a body in a plane with streams of mass

   This chapter has the right-hand side of mechanics/flow.h for motion in a plane. The state has 10 numbers instead of
   23. The equations are those of motion in space, except that streams in the plane have no stores.

       vm_stream2 jet = {-1, VM_RELATIVE, -0.5, 0, -2000, 0, 0, 0}; // 1 kg/s, 0.5 m behind, 2000 m/s backwards
       vm_flow2 flow;
       vm_real y[VM_FLOW2_STATES] = {0, 0, 0, 0, 0, 1, 100, 0, 0, 20}; // spins slowly, 100 kg, 20 kg m^2
       vm_real dydt[VM_FLOW2_STATES];
       memset(&flow, 0, sizeof flow);
       flow.n = 1;
       flow.streams = &jet;
       int status = vm_flow2_rhs(0, y, dydt, &flow); // or integrate it: rk45_init(&s, vm_flow2_rhs, &flow, ...)

   Tests: tests/test_flow2.c. */
#ifndef VARMASS_MECHANICS_FLOW2_H
#define VARMASS_MECHANICS_FLOW2_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "flow.h"
#include "streams.h"

/* Indices of the states of vm_flow2_rhs in y, and their number. Vectors are along inertial axes unless body axes are
   named. */
enum {
    VM_FLOW2_X = 0,       /* position of the mass centre, 2 numbers x, y, m */
    VM_FLOW2_ANGLE = 2,   /* angle of the body axes, rad, anticlockwise */
    VM_FLOW2_P = 3,       /* momentum, 2 numbers, kg m/s */
    VM_FLOW2_H = 5,       /* angular momentum about the mass centre, kg m^2/s */
    VM_FLOW2_MASS = 6,    /* mass, kg */
    VM_FLOW2_CENTRE = 7,  /* vector from the reference point to the mass centre, 2 numbers, body axes, m */
    VM_FLOW2_INERTIA = 9, /* moment of inertia about the mass centre, kg m^2 */
    VM_FLOW2_STATES = 10
};

/* A stream of mass in the plane */
typedef struct VM_TAG(vm_stream2) {
    vm_real rate;     /* mass per time, kg/s; > 0: mass joins the body, < 0: mass leaves it */
    int motion;       /* what velocity and spin mean: VM_RELATIVE, VM_ABSOLUTE, VM_CARRIED or VM_AT_REST */
    vm_real x, y;     /* point at which the mass enters or leaves, from the body's reference point, m, body axes */
    vm_real vx, vy;   /* velocity of the mass as it enters or leaves the body, m/s */
    vm_real spin;     /* angular velocity of the mass as it enters or leaves the body, rad/s */
    vm_real gyration; /* inertia per unit mass of the mass that enters or leaves, about its own mass centre, m^2 */
} vm_stream2;

/* The streams and loads of a body in the plane. vm_flow2_rhs gets a pointer to this struct as its last argument. Set
   the whole struct to zero first. */
typedef struct VM_TAG(vm_flow2) {
    int n;               /* number of streams */
    vm_stream2 *streams; /* array of n streams, provided by the caller */
    vm_real fx, fy;      /* resultant of the outer forces, N, inertial axes */
    vm_real moment;      /* moment of the outer forces about the mass centre, plus all torques, N m */
    /* NULL, or a function that is called before each evaluation and may set every field from t and y, as
       vm_flow.update does. It returns 0 to go on; any other number ends the run. */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow2) * flow);
    void *ctx;  /* pointer for the caller's `update`; not used by the functions below */
    int status; /* VM_OK, or the reason why the last evaluations gave NaN or ended the run: see vm_flow.status */
} vm_flow2;

/* Computes sine and cosine of x, with errors below 0.6 eps, in fewer operations than vmi_sincos. For |x| up to 2^20
   quarter turns (float 2^10) the function subtracts j pi/2 from x, where j is the integer nearest to x/(pi/2). The
   function replaces pi/2 by the sum of two numbers: `first` has 33 (float 14) bits, so that j times `first` is exact.
   The sum of `first` and `second` differs from pi/2 by 2^-87 (float 2^-38). The product of j and `second` has a
   rounding error of at most 2^-67 (float 2^-28). For larger |x| the function calls vmi_sincos. */
VM_INLINE void vmi_sincos_of_angle(vm_real x, vm_real *sine, vm_real *cosine)
{
#if VM_MANT_DIG > 24
    const vm_real most = VM_C(1048576.0);
    const vm_real first = VM_C(1.570796326734125614166), second = VM_C(6.077100506506192601e-11);
#else
    const vm_real most = VM_C(1024.0);
    const vm_real first = VM_C(1.5706787109375), second = VM_C(1.176158573966192321e-4);
#endif
    const vm_real quarters = x * VM_C(0.63661977236758134308);
    vm_real s, c, rest, tail;
    vm_two z;
    long j;
    if (!(VM_FABS(quarters) < most)) {
        vmi_sincos(x, sine, cosine);
        return;
    }
    j = (long)(quarters + VM_COPYSIGN(VM_C(0.5), quarters));
    rest = x - (vm_real)j * first;
    tail = (vm_real)j * second;
    z.hi = rest - tail;
    z.lo = (rest - z.hi) - tail;
    vmi_sin_cos(z, &s, &c);
    *sine = (j & 1 ? c : s) * (vm_real)(1 - (j & 2));
    *cosine = (j & 1 ? s : c) * (vm_real)(1 - ((j + 1) & 2));
}

/* The motion of a body in the plane, in the form that the sums over its streams need */
typedef struct VM_TAG(vmi_stream_seen2) {
    vm_real sine, cosine;       /* sine and cosine of the body's angle */
    vm_real vx, vy;             /* velocity, which is momentum/mass, body axes */
    vm_real omega;              /* angular velocity, rad/s */
    vm_real centre_x, centre_y; /* vector from the reference point to the mass centre, body axes */
} vmi_stream_seen2;

/* The sums over the streams of a body in the plane, in body axes except fx, fy. The letters M', u, v, d, kappa,
   omega2 are explained at vm_reactive. */
typedef struct VM_TAG(vmi_stream_sum2) {
    vm_real rate;    /* total mass rate, the sum of M' over all streams, kg/s */
    vm_real carried; /* sum of M' of the streams whose velocity is relative to the body */
    vm_real px, py;  /* force of the streams whose velocity is relative to the body: sum of M' (u - v) */
    vm_real fx, fy;  /* outer force, plus the sum of M' u of the streams whose velocity is absolute, inertial axes */
    vm_real moment;  /* outer moment, plus the sum of d x M' (u - v) + M' kappa omega2 over all streams */
    vm_real sx, sy;  /* sum of M' d over all streams; divided by M it is the rate of the mass centre in the body */
    vm_real inertia; /* rate of the body's inertia: sum of M' (kappa + d^2) over all streams */
} vmi_stream_sum2;

/* Adds the terms of the stream *s to the sums *sum. The field `motion` of the stream must have one of the known
   values. */
VM_INLINE void vmi_stream_add2(const vm_stream2 *s, const vmi_stream_seen2 *b, vmi_stream_sum2 *sum)
{
    const int given = vmi_stream_velocity_is_given(s->motion);
    const vm_real dx = s->x - b->centre_x, dy = s->y - b->centre_y;
    vm_real ux, uy, spin = 0; /* ux, uy become M' (u - v); spin is the angular velocity omega2 of the mass */
    if (vmi_stream_moves_with_body(s->motion)) {
        ux = -b->omega * dy;
        uy = b->omega * dx;
        spin = b->omega;
        if (given) {
            ux += s->vx;
            uy += s->vy;
            spin += s->spin;
        }
        ux *= s->rate;
        uy *= s->rate;
        sum->carried += s->rate;
        sum->px += ux;
        sum->py += uy;
    } else {
        ux = -s->rate * b->vx;
        uy = -s->rate * b->vy;
        if (given) {
            const vm_real fx = s->rate * s->vx, fy = s->rate * s->vy;
            sum->fx += fx;
            sum->fy += fy;
            spin = s->spin;
            ux += b->cosine * fx + b->sine * fy;
            uy += b->cosine * fy - b->sine * fx;
        }
    }
    sum->rate += s->rate;
    sum->moment += dx * uy - dy * ux + s->rate * s->gyration * spin;
    sum->sx += s->rate * dx;
    sum->sy += s->rate * dy;
    sum->inertia += s->rate * (s->gyration + dx * dx + dy * dy);
}

/* Returns VM_NOT_FINITE if the mass of the state y is infinite or NaN; VM_BAD_MASS or VM_BAD_INERTIA if its mass or its
   inertia is not positive; else VM_OK. */
VM_INLINE int vmi_flow2_check_state(const vm_real *y)
{
    const int status = vmi_flow_check_mass(y[VM_FLOW2_MASS]);
    if (status) return status;
    if (!(y[VM_FLOW2_INERTIA] > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Right-hand side of the equations of motion of a body in the plane with streams of mass, (151), (152).
   Its type is ode_rhs, so that integrators such as rk45 can call it. The state y has VM_FLOW2_STATES numbers. `ctx`
   must point to a vm_flow2. The equations are those at the top of mechanics/flow.h. Returns 0 or another number, which
   ends the run: VM_BAD_ARGUMENT for a null pointer, for n < 0 and for an unknown `motion` of a stream; or the number
   that flow.update returns. */
VM_API int vm_flow2_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow2 *flow = (vm_flow2 *)ctx;
    vmi_stream_sum2 sum = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    vmi_stream_seen2 seen;
    vm_real sine = 0, cosine = 1, inverse, vx, vy, sx, sy;
    int k, status = 0;
    if (flow->update) status = flow->update(t, y, flow);
    if (status) return status;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    status = vmi_flow2_check_state(y);
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(VM_FLOW2_STATES, dydt);
    if (flow->n) vmi_sincos_of_angle(y[VM_FLOW2_ANGLE], &sine, &cosine);
    inverse = 1 / y[VM_FLOW2_MASS];
    vx = y[VM_FLOW2_P] * inverse;
    vy = y[VM_FLOW2_P + 1] * inverse;
    seen.sine = sine;
    seen.cosine = cosine;
    seen.vx = cosine * vx + sine * vy;
    seen.vy = cosine * vy - sine * vx;
    seen.omega = y[VM_FLOW2_H] / y[VM_FLOW2_INERTIA];
    seen.centre_x = y[VM_FLOW2_CENTRE];
    seen.centre_y = y[VM_FLOW2_CENTRE + 1];
    sum.fx = flow->fx;
    sum.fy = flow->fy;
    sum.moment = flow->moment;
    for (k = 0; k < flow->n; k++) {
        if (!vmi_stream_motion_is_known(flow->streams[k].motion)) return flow->status = VM_BAD_ARGUMENT;
        vmi_stream_add2(flow->streams + k, &seen, &sum);
    }
    sx = sum.sx * inverse;
    sy = sum.sy * inverse;
    dydt[VM_FLOW2_X] = vx + cosine * sx - sine * sy;
    dydt[VM_FLOW2_X + 1] = vy + sine * sx + cosine * sy;
    dydt[VM_FLOW2_ANGLE] = seen.omega;
    dydt[VM_FLOW2_P] = sum.fx + sum.carried * vx + cosine * sum.px - sine * sum.py;
    dydt[VM_FLOW2_P + 1] = sum.fy + sum.carried * vy + sine * sum.px + cosine * sum.py;
    dydt[VM_FLOW2_H] = sum.moment;
    dydt[VM_FLOW2_MASS] = sum.rate;
    dydt[VM_FLOW2_CENTRE] = sx;
    dydt[VM_FLOW2_CENTRE + 1] = sy;
    dydt[VM_FLOW2_INERTIA] = sum.inertia;
    return 0;
}

#endif
