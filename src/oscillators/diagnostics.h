/* oscillators/diagnostics.h - turning points and zeros of any motion, envelopes, how slow changes are

   The motion is given as a trajectory x(t), v(t). The trajectory may come from a method of oscillators/routes.h, from a
   closed form, or from the dense output of an integrator, which is its solution between the ends of a step. The |x| at
   the turning points of the trajectory is compared with an amplitude law. The zero crossings give the largest
   velocities and the periods.

       vm_sample turning[8]; // motion: a function of the user, see vm_motion_function
       long n = vm_find_samples(motion, NULL, VM_TURNING_POINTS, 0, 20, VM_C(0.1), 8, turning);

   Tests: tests/test_diagnostics.c. */
#ifndef VARMASS_OSCILLATORS_DIAGNOSTICS_H
#define VARMASS_OSCILLATORS_DIAGNOSTICS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "../integrators/dense.h"
#include "../integrators/runs.h"
#include "laws.h"
#include "problem.h"
#include "slow.h"

/* A user's function for a trajectory, which writes position x and velocity v at time t. ctx is the user's pointer. */
typedef void (*vm_motion_function)(vm_real t, vm_real *x, vm_real *v, void *ctx);

/* A point of a trajectory: time, position and velocity, in the units of the trajectory */
typedef struct VM_TAG(vm_sample) {
    vm_real t, x, v;
} vm_sample;

/* The kinds of points of a trajectory that can be searched for */
enum {
    VM_TURNING_POINTS = 0, /* where the velocity x' is 0 */
    VM_ZERO_CROSSINGS = 1  /* where the position x is 0 */
};

/* Returns 1 if a search is possible, else 0. A search is possible if the kind of point exists, if `room` is not
   negative, and if `samples` is not null where `room` is positive. */
VM_API int vmi_samples_are_possible(int kind, long room, const vm_sample *samples)
{
    return (kind == VM_TURNING_POINTS || kind == VM_ZERO_CROSSINGS) && (room == 0 || (room > 0 && samples));
}

/* A search for turning points or zero crossings along a trajectory */
typedef struct VM_TAG(vmi_sample_search) {
    vm_motion_function motion;
    void *ctx;
    int kind;
    vm_real x, v; /* position and velocity at the time of the last evaluation */
    int failed;   /* 1 if the trajectory was not finite at an evaluation, else 0 */
} vmi_sample_search;

/* The function of t whose zeros are sought: the position x for zero crossings, the velocity v for turning points */
VM_API vm_real vmi_sample_function(vm_real t, void *search)
{
    vmi_sample_search *s = (vmi_sample_search *)search;
    s->motion(t, &s->x, &s->v, s->ctx);
    if (!VM_IS_FINITE(s->x) || !VM_IS_FINITE(s->v)) s->failed = 1;
    if (s->kind == VM_ZERO_CROSSINGS) return s->x;
    return s->v;
}

/* Turning points or zero crossings of a trajectory in (t0, t1]. kind is VM_TURNING_POINTS or VM_ZERO_CROSSINGS. The
   function evaluates the trajectory at equal intervals of at most |step|. Where v (for turning points) or x (for zero
   crossings) changes its sign, the time of the point is found within 4 eps. step should be a small part of a period;
   step must be negative where t1 < t0. The first `room` points are written to samples, in the order in which they are
   found. Returns the number of points, which may be more than room, or a negative status. The statuses are
   VM_BAD_ARGUMENT for a null pointer, an unknown kind or a negative room; VM_NOT_FINITE for a step that is 0, infinite
   or of the wrong sign, for more than 2e9 steps, and where the trajectory is not finite. Points that were found before
   the error stay in samples. */
VM_API long vm_find_samples(vm_motion_function motion, void *ctx, int kind, vm_real t0, vm_real t1, vm_real step,
                            long room, vm_sample *samples)
{
    const vm_real most_steps = VM_C(2e9);
    vmi_sample_search s;
    vm_real t = t0, here, intervals;
    long found = 0, i, last;
    if (!motion || !vmi_samples_are_possible(kind, room, samples)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(step)) return VM_NOT_FINITE;
    if ((t1 > t0 && step < 0) || (t1 < t0 && step > 0)) return VM_NOT_FINITE;
    intervals = -VM_FLOOR(-(t1 - t0) / step);
    if (!(intervals >= 0) || !(intervals < most_steps)) return VM_NOT_FINITE;
    last = (long)intervals;
    s.motion = motion;
    s.ctx = ctx;
    s.kind = kind;
    s.failed = 0;
    here = vmi_sample_function(t0, &s);
    for (i = 1; i <= last; i++) {
        const vm_real before = t, value_before = here;
        t = i == last ? t1 : t0 + (t1 - t0) * ((vm_real)i / intervals);
        here = vmi_sample_function(t, &s);
        if (s.failed) return VM_NOT_FINITE;
        if (value_before == 0 || !(here == 0 || (here > 0) != (value_before > 0))) continue;
        if (found < room) {
            samples[found].t = vmi_find_zero(vmi_sample_function, &s, before, t, value_before, here);
            vmi_sample_function(samples[found].t, &s);
            samples[found].x = s.x;
            samples[found].v = s.v;
        }
        found++;
    }
    if (s.failed) return VM_NOT_FINITE;
    return found;
}

/* A trajectory from the dense output of the integrator s. x and v are the indices of position and velocity in the state
   of the integrator; buffer has room for a state. */
typedef struct VM_TAG(vmi_step_motion) {
    rk45 *s;
    int x, v;
    vm_real *buffer;
} vmi_step_motion;

/* The trajectory within the integrator's last step; writes NaN where the dense output fails */
VM_API void vmi_motion_of_step(vm_real t, vm_real *x, vm_real *v, void *step)
{
    const vmi_step_motion *m = (const vmi_step_motion *)step;
    const int status = vmi_interpolate(m->s, t, m->buffer);
    *x = VM_NAN;
    *v = VM_NAN;
    if (status) return;
    *x = m->buffer[m->x];
    *v = m->buffer[m->v];
}

/* Turning points or zero crossings in the last step of an rk45 or rk87. Call it after every step. x and v are the
   indices of position and velocity in the state; buffer has room for a state. kind, room, samples and the result are
   those of vm_find_samples. Returns VM_BAD_ARGUMENT also for an index outside the state, and 0 if the integrator has
   not made a step yet. */
VM_API long vm_find_samples_of_step(rk45 *s, int x, int v, int kind, vm_real *buffer, long room, vm_sample *samples)
{
    const vm_real parts = 4; /* each of 4 equal parts of the step is searched for a change of sign */
    vmi_step_motion m;
    vm_real length;
    if (!s || !buffer || x < 0 || v < 0 || x >= s->n || v >= s->n) return VM_BAD_ARGUMENT;
    if (!vmi_samples_are_possible(kind, room, samples)) return VM_BAD_ARGUMENT;
    length = s->t - s->t_old;
    if (length == 0) return 0;
    m.s = s;
    m.x = x;
    m.v = v;
    m.buffer = buffer;
    return vm_find_samples(vmi_motion_of_step, &m, kind, s->t_old, s->t, length / parts, room, samples);
}

/* Largest relative error of an amplitude law, |law(t)/observed - 1|, over n samples. The observed value is |x| for
   VM_TURNING_POINTS and |v| for VM_ZERO_CROSSINGS. The user's function `law` returns the amplitude or the largest
   velocity at time t; ctx is the last argument of this function. Returns 0 for n = 0. Returns NaN for null pointers,
   for an unknown kind, for n < 0, and where the function `law` returns NaN or a sample is infinite or NaN. */
VM_API vm_real vm_envelope_error(int kind, long n, const vm_sample *samples, vm_real (*law)(vm_real t, void *ctx),
                                 void *ctx)
{
    if (!samples || !law || !vmi_samples_are_possible(kind, n, samples)) return VM_NAN;
    vm_real worst = 0;
    long i;
    for (i = 0; i < n; i++) {
        vm_real observed = VM_FABS(samples[i].v), error;
        if (kind == VM_TURNING_POINTS) observed = VM_FABS(samples[i].x);
        error = VM_FABS(law(samples[i].t, ctx) / observed - 1);
        if (error != error || !VM_IS_FINITE(observed)) return VM_NAN;
        worst = vmi_larger(worst, error);
    }
    return worst;
}

/* Adiabaticity q/Om of an oscillator at time t and amplitude A. This quotient is the small parameter of averaging. q =
   ((2r-1) m' + 2 b)/m + k'/k is the rate at which mass, damping and stiffness change the motion, with r = reactive, b =
   damping, mass m and stiffness k. Om is the rate of the Ateb phase at the amplitude A, in m. The function uses only
   alpha, mass, stiffness, reactive and damping of the problem. For a motion that starts at rest, errors of amplitude
   laws are of order (q/Om)^2; errors of x(t) and v(t) are of order q/Om up to t = 1/q. The error is within 4 eps of
   (|2r-1| |m'|/m + 2 |b|/m + |k'|/k)/Om. Returns NaN for a null pointer; where A, mass or stiffness is not positive;
   where alpha is negative; and for numbers that are infinite or NaN. */
VM_API vm_real vm_adiabaticity(const vm_osc_problem *o, vm_real t, vm_real A)
{
    if (!o) return VM_NAN;
    vm_real mass, mass_rate, k, k_rate, q;
    if (!(A > 0) || vmi_law_at(&o->mass, VM_BAD_MASS, t, &mass, &mass_rate) ||
        vmi_law_at(&o->stiffness, VM_BAD_STIFFNESS, t, &k, &k_rate))
        return VM_NAN;
    q = vmi_slow_q(vmi_slow_drag(o->reactive, mass_rate, o->damping), mass, k, k_rate);
    if (!VM_IS_FINITE(q)) return VM_NAN;
    return q / vmi_slow_rate(A, k, mass, o->alpha);
}

#endif
