/* oscillators/diagnostics.h - turning points, zero crossings, envelopes */
#ifndef VARMASS_OSCILLATORS_DIAGNOSTICS_H
#define VARMASS_OSCILLATORS_DIAGNOSTICS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "../integrators/dense.h"
#include "../integrators/runs.h"
#include "slow.h"

/* Any trajectory, x(t) and x'(t): a route's, a law's, an integrator's dense output. */
typedef void (*vm_motion_function)(vm_real t, vm_real *x, vm_real *v, void *ctx);

typedef struct VM_TAG(vm_sample) {
    vm_real t, x, v;
} vm_sample;

enum {
    VM_TURNING_POINTS = 0, /* x' = 0 */
    VM_ZERO_CROSSINGS = 1  /* x = 0 */
};

typedef struct VM_TAG(vmi_sample_search) {
    vm_motion_function motion;
    void *ctx;
    int kind;
    vm_real x, v; /* where it was looked last */
} vmi_sample_search;

/* What vanishes at a point of the kind looked for */
VM_API vm_real vmi_sample_function(vm_real t, void *search)
{
    vmi_sample_search *s = (vmi_sample_search *)search;
    s->motion(t, &s->x, &s->v, s->ctx);
    return s->kind == VM_ZERO_CROSSINGS ? s->x : s->v;
}

/* The number of changes of sign in (t0, t1], looked for every step (or a little less; a small part of a period,
   negative where t1 < t0) and located to an eps of t; the first room of them are written. A negative status for a
   step of the wrong sign, or a trajectory that is not finite. */
VM_API long vm_find_samples(vm_motion_function motion, void *ctx, int kind, vm_real t0, vm_real t1, vm_real step, long room,
                           vm_sample *points)
{
    vmi_sample_search s;
    vm_real t = t0, here, there, intervals;
    long found = 0, i = 0, last;
    if (!motion || (room > 0 && !points) || (kind != VM_TURNING_POINTS && kind != VM_ZERO_CROSSINGS))
        return VM_BAD_ARGUMENT;
    intervals = -VM_FLOOR(-(t1 - t0) / step);
    if (!(intervals >= 0) || !(intervals < VM_C(2e9))) return VM_NOT_FINITE;
    last = (long)intervals;
    s.motion = motion;
    s.ctx = ctx;
    s.kind = kind;
    for (here = vmi_sample_function(t0, &s); i < last; here = there) {
        const vm_real before = t;
        i++;
        t = i == last ? t1 : t0 + (t1 - t0) * ((vm_real)i / intervals);
        there = vmi_sample_function(t, &s);
        if (!VM_IS_FINITE(there)) return VM_NOT_FINITE;
        if (here == 0 || !(there == 0 || (there > 0) != (here > 0))) continue;
        if (found < room) {
            points[found].t = vmi_find_zero(vmi_sample_function, &s, before, t, here, there);
            motion(points[found].t, &points[found].x, &points[found].v, ctx);
        }
        found++;
    }
    if (!VM_IS_FINITE(here)) return VM_NOT_FINITE;
    return found;
}

typedef struct VM_TAG(vmi_step_motion) {
    rk45 *s;
    int x, v;
    vm_real *buffer;
} vmi_step_motion;

VM_API void vmi_motion_of_step(vm_real t, vm_real *x, vm_real *v, void *step)
{
    const vmi_step_motion *m = (const vmi_step_motion *)step;
    const int status = vmi_interpolate(m->s, t, m->buffer);
    *x = status ? VM_NAN : m->buffer[m->x];
    *v = status ? VM_NAN : m->buffer[m->v];
}

/* The same in the last step of an rk45 or rk87, for components x and v of its state; to be called after every step.
   buffer: room for a state. */
VM_API long vm_find_samples_of_step(rk45 *s, int x, int v, int kind, vm_real *buffer, long room, vm_sample *points)
{
    vmi_step_motion m;
    vm_real length;
    if (!s || !buffer || x < 0 || v < 0 || x >= s->n || v >= s->n) return VM_BAD_ARGUMENT;
    length = s->t - s->t_old;
    if (length == 0) return 0;
    m.s = s;
    m.x = x;
    m.v = v;
    m.buffer = buffer;
    return vm_find_samples(vmi_motion_of_step, &m, kind, s->t_old, s->t, length / 4, room, points);
}

/* Largest |law(t)/observed - 1|, observed |x| at turning points, |v| at zero crossings */
VM_API vm_real vm_envelope_error(int kind, long n, const vm_sample *points, vm_real (*law)(vm_real t, void *ctx),
                                 void *ctx)
{
    if (!points || !law || n < 0) return VM_NAN;
    vm_real worst = 0;
    long i;
    for (i = 0; i < n; i++) {
        const vm_real observed = kind == VM_TURNING_POINTS ? points[i].x : points[i].v;
        const vm_real error = VM_FABS(law(points[i].t, ctx) / VM_FABS(observed) - 1);
        if (!(error <= worst)) worst = error;
    }
    return worst;
}

/* q/Om, what averaging takes for small: q = ((2r-1) m' + 2b)/m + k'/k and the rate Om of the Ateb phase at
   amplitude A. The amplitude laws err by about (q/Om)^2, waveforms by q/Om over times of order 1/q. */
VM_API vm_real vm_adiabaticity(vm_real A, vm_real mass, vm_real mass_rate, vm_real k, vm_real k_rate, vm_real b,
                               vm_real reactive, vm_real alpha)
{
    const vm_real q = ((2 * reactive - 1) * mass_rate + 2 * b) / mass + k_rate / k;
    if (!(A > 0) || !(mass > 0) || !(k > 0) || !VM_IS_FINITE(mass) || !VM_IS_FINITE(k) || !VM_IS_FINITE(q))
        return VM_NAN;
    return q / vmi_slow_rate(A, k, mass, alpha);
}

#endif
