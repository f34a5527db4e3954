/* mechanics/flow1.h - translation, bodies on a line or an axle with streams of mass */
#ifndef VARMASS_MECHANICS_FLOW1_H
#define VARMASS_MECHANICS_FLOW1_H

#include "../base/real.h"
#include "../base/status.h"
#include "flow.h"
#include "streams.h"
#include "vectors.h"

/* Translation (172): 7 states r, momentum, mass; the flow's streams without at, spin and gyration, body axes along
   the inertial ones */
enum { VM_TRANSLATION_STATES = 7 };

/* One degree of freedom: straight motion (175), (176), and rotation about a fixed axle (173a), which is the same
   equation. States: x, momentum, mass; or angle, angular momentum, inertia about the axle, with rate M' (kappa +
   rho^2), rho the distance from the axle, and velocity the stream's angular momentum per unit mass over that. */
typedef struct VM_TAG(vm_stream1) {
    vm_real rate, velocity;
    int motion;
} vm_stream1;

typedef struct VM_TAG(vm_flow1) {
    int n;
    vm_stream1 *streams;
    vm_real force; /* or moment */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow1) * flow);
    void *ctx;
    int status;
} vm_flow1;

enum { VM_FLOW1_STATES = 3 };

VM_INLINE int vmi_translation_rates(vm_flow *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real inverse = 1 / y[6];
    const vm_vec3 v = vmi_scale(inverse, vmi_get3(y + 3));
    vm_real rate = 0;
    vm_vec3 force = flow->force;
    int k;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < VM_TRANSLATION_STATES) return flow->status = VM_SHORT_ARRAY;
    if (vmi_flow_refused(&flow->status, y[6] > 0 ? VM_OK : VM_BAD_MASS))
        return vmi_flow_refuse(VM_TRANSLATION_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream *s = flow->streams + k;
        vm_vec3 u = vmi_add(v, s->velocity);
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        if (s->motion != VM_RELATIVE)
            u = s->motion == VM_ABSOLUTE ? s->velocity : s->motion == VM_CARRIED ? v : vmi_vec3(0, 0, 0);
        rate += s->rate;
        force = vmi_add(force, vmi_scale(s->rate, u));
    }
    vmi_set3(dydt, v);
    vmi_set3(dydt + 3, force);
    dydt[6] = rate;
    return 0;
}

VM_INLINE int vmi_rates1(vm_flow1 *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real v = y[1] / y[2];
    vm_real force = flow->force, rate = 0;
    int k;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (vmi_flow_refused(&flow->status, y[2] > 0 ? VM_OK : VM_BAD_MASS)) return vmi_flow_refuse(VM_FLOW1_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream1 *s = flow->streams + k;
        vm_real u = v + s->velocity;
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        if (s->motion != VM_RELATIVE) u = s->motion == VM_ABSOLUTE ? s->velocity : s->motion == VM_CARRIED ? v : 0;
        rate += s->rate;
        force += s->rate * u;
    }
    dydt[0] = v;
    dydt[1] = force;
    dydt[2] = rate;
    return 0;
}

/* Apart, so that nothing is saved for a call that is not made */
VMI_APART int vmi_translation_updated(vm_real t, const vm_real *y, vm_real *dydt, vm_flow *flow)
{
    const int status = flow->update(t, y, flow);
    return status ? status : vmi_translation_rates(flow, y, dydt);
}

VMI_APART int vmi_updated1(vm_real t, const vm_real *y, vm_real *dydt, vm_flow1 *flow)
{
    const int status = flow->update(t, y, flow);
    return status ? status : vmi_rates1(flow, y, dydt);
}

VM_API int vm_translation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    vm_flow *f = (vm_flow *)flow;
    return f->update ? vmi_translation_updated(t, y, dydt, f) : vmi_translation_rates(f, y, dydt);
}

VM_API int vm_flow1_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow1)
{
    if (!y || !dydt || !flow1) return VM_BAD_ARGUMENT;
    vm_flow1 *f = (vm_flow1 *)flow1;
    return f->update ? vmi_updated1(t, y, dydt, f) : vmi_rates1(f, y, dydt);
}

#endif
