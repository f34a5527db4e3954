/* mechanics/flow2.h - a body in a plane with streams of mass */
#ifndef VARMASS_MECHANICS_FLOW2_H
#define VARMASS_MECHANICS_FLOW2_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "flow.h"
#include "streams.h"

/* The plane: as in space. States: x, y, angle, momentum 2, angular momentum about the mass centre, mass, mass centre
   from the reference point in body axes 2, inertia about it. No stores. */
typedef struct VM_TAG(vm_stream2) {
    vm_real rate;
    int motion;
    vm_real x, y;   /* where it crosses */
    vm_real vx, vy; /* velocity */
    vm_real spin;
    vm_real gyration; /* m^2 */
} vm_stream2;

typedef struct VM_TAG(vm_flow2) {
    int n;
    vm_stream2 *streams;
    vm_real fx, fy, moment;
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow2) * flow);
    void *ctx;
    int status;
} vm_flow2;

enum { VM_FLOW2_STATES = 10 };

/* sin and cos of x within 0.6 eps of 1: vmi_sincos, with a shorter reduction below 2^20 quarters (float 2^10). pi/2
   less its first piece, of 33 (14) bits, whose products are exact, is known to 2^-87 (2^-38); rounding j times it
   costs 2^-67 (2^-28) */
VM_INLINE void vmi_sincos_of_angle(vm_real x, vm_real *sine, vm_real *cosine)
{
#if VM_MANT_DIG > 24
    const vm_real most = VM_C(1048576.0), first = VM_C(1.570796326734125614166),
                  second = VM_C(6.077100506506192601e-11);
#else
    const vm_real most = VM_C(1024.0), first = VM_C(1.5706787109375), second = VM_C(1.176158573966192321e-4);
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

/* Sums of the streams in the plane, body axes but for fx, fy */
typedef struct VM_TAG(vmi_stream_sum2) {
    vm_real rate, carried, px, py, fx, fy, moment, sx, sy, inertia;
} vmi_stream_sum2;

/* bx, by: v in body axes, of which sine and cosine are the direction */
VM_INLINE void vmi_stream_add2(const vm_stream2 *s, vm_real dx, vm_real dy, vm_real omega, vm_real bx, vm_real by,
                               vm_real sine, vm_real cosine, vmi_stream_sum2 *sum)
{
    vm_real ux, uy, spin = 0; /* M' (u - v) */
    if (s->motion == VM_RELATIVE || s->motion == VM_CARRIED) {
        ux = -omega * dy;
        uy = omega * dx;
        spin = omega;
        if (s->motion == VM_RELATIVE) {
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
        ux = -s->rate * bx;
        uy = -s->rate * by;
        if (s->motion == VM_ABSOLUTE) {
            const vm_real ax = s->rate * s->vx, ay = s->rate * s->vy;
            sum->fx += ax;
            sum->fy += ay;
            spin = s->spin;
            ux += cosine * ax + sine * ay;
            uy += cosine * ay - sine * ax;
        }
    }
    sum->rate += s->rate;
    sum->moment += dx * uy - dy * ux + s->rate * s->gyration * spin;
    sum->sx += s->rate * dx;
    sum->sy += s->rate * dy;
    sum->inertia += s->rate * (s->gyration + dx * dx + dy * dy);
}

VM_API int vm_flow2_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow2 *flow = (vm_flow2 *)ctx;
    vmi_stream_sum2 sum = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    vm_real sine, cosine, inverse, vx, vy, omega, sx, sy;
    int k, status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    status = !(y[6] > 0) ? VM_BAD_MASS : y[9] > 0 ? VM_OK : VM_BAD_INERTIA;
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(VM_FLOW2_STATES, dydt);
    sine = 0;
    cosine = 1;
    if (flow->n) vmi_sincos_of_angle(y[2], &sine, &cosine);
    inverse = 1 / y[6];
    vx = y[3] * inverse;
    vy = y[4] * inverse;
    omega = y[5] / y[9];
    sum.fx = flow->fx;
    sum.fy = flow->fy;
    sum.moment = flow->moment;
    for (k = 0; k < flow->n; k++) {
        if (!vmi_stream_motion_is_known(flow->streams[k].motion)) return flow->status = VM_BAD_ARGUMENT;
        vmi_stream_add2(flow->streams + k, flow->streams[k].x - y[7], flow->streams[k].y - y[8], omega,
                        cosine * vx + sine * vy, cosine * vy - sine * vx, sine, cosine, &sum);
    }
    sx = sum.sx * inverse;
    sy = sum.sy * inverse;
    dydt[0] = vx + cosine * sx - sine * sy;
    dydt[1] = vy + sine * sx + cosine * sy;
    dydt[2] = omega;
    dydt[3] = sum.fx + sum.carried * vx + cosine * sum.px - sine * sum.py;
    dydt[4] = sum.fy + sum.carried * vy + sine * sum.px + cosine * sum.py;
    dydt[5] = sum.moment;
    dydt[6] = sum.rate;
    dydt[7] = sx;
    dydt[8] = sy;
    dydt[9] = sum.inertia;
    return 0;
}

#endif
