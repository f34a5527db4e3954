/* integrators/loop.h - the loop of an adaptive run by any pair: it begins or restarts a run and makes its steps
   Users call the functions of rk45.h and rk87.h, which call the functions of this file.

   Tests: tests/test_adaptive.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_LOOP_H
#define VARMASS_INTEGRATORS_LOOP_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "events.h"
#include "ode.h"
#include "pairs.h"
#include "runs.h"
#include "steps.h"

/* Does the work of rk45_init for any pair. The function is inlined, so that the compiler sees which f and n the caller
   gives and can inline f in the steps. */
VM_INLINE int vmi_ode_init(rk45 *s, vmi_rk_pair pair, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                           const rk45_options *options_or_NULL, vm_real *work)
{
    const int status = vmi_init(s, &pair, f, ctx, n, t0, y0, options_or_NULL, work);
    if (status >= 0) {
        s->f = f;
        s->n = n;
    }
    return status;
}

/* Forgets which events have just happened, because the run continues at another time. The side of each event then
   becomes the sign of its g at the new time, even if g is small. */
VM_API void vmi_forget_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) s->options.events[i].quiet = 0;
}

/* Does the work of rk45_restart for any pair */
VM_API int vmi_restart(rk45 *s, vm_real t, const vm_real *y)
{
    if (!s || !y || !VM_IS_FINITE(t) || !vmi_all_finite(s->n, y)) return ODE_BAD_ARGUMENT;
    if (t != s->t) {
        vmi_forget_events(s);
        s->t_low = 0;
    }
    s->t = t;
    s->t_old = t;
    s->t_old_low = s->t_low;
    if (y != s->y) vmi_copy(s->n, y, s->y);
    s->k1 = VMI_K1_MISSING;
    s->failed = 0;
    s->next_miss = s->steps;
    return ODE_OK;
}

/* Prepares a step: evaluates its first derivative k_1 = f(t, y) unless k_1 is known. Gives the step size s->h the sign
   of the direction to t_end. Returns a status. */
VMI_APART int vmi_prepare(rk45 *s, vm_real t_end)
{
    const vm_real left = VM_FABS(vmi_time_left(s, t_end)), longest = VMI_SMALLER(left, s->options.h_max);
    const vm_real direction = vmi_direction(s, t_end);
    vm_real *k1 = vmi_part(s, VMI_K);
    int status = ODE_OK;
    s->t_old = s->t; /* the k of the step before this one are overwritten, even if an error follows */
    s->t_old_low = s->t_low;
    if (s->k1 == VMI_K1_IS_LAST) vmi_copy(s->n, vmi_part(s, vmi_last_k(&s->pair)), k1);
    if (s->k1 == VMI_K1_MISSING) {
        status = vmi_eval(s, s->t, s->y, k1);
        if (status) return status;
        if (!vmi_all_finite(s->n, k1)) return ODE_NOT_FINITE;
        status = vmi_watch_events(s);
        if (status) return status;
    }
    s->k1 = VMI_K1_READY;
    if (s->h == 0) status = vmi_first_step(s, direction, longest);
    if (status) return status;
    s->h = direction * VM_FABS(s->h);
    return ODE_OK;
}

/* A run counts as stiff when VMI_STIFF_HITS tests have found steps at the edge of the pair's stability region. The
   number of such tests is set to 0 when VMI_STIFF_MISSES tests in succession have found steps inside the region. */
enum { VMI_STIFF_HITS = 15, VMI_STIFF_MISSES = 6 };

/* Makes Hairer's test of stiffness [2, IV.2]. A step evaluates f for two states at its end. The two states differ by h
   dz and their derivatives by dk. Then |dk|/|dz| is about h times the largest eigenvalue of the Jacobian of f, if the
   components of y are of similar magnitude; otherwise it may be larger. The test is made only if the two states differ
   by more than 1/1000 of the tolerance, because otherwise dk and dz may be rounding errors. */
VM_API void vmi_look_for_stiffness(rk45 *s)
{
    const int last = vmi_last_k(&s->pair), count = last - VMI_K;
    vm_real dk = 0, dz = 0;
    int i, j, differ = 0;
    for (i = 0; i < s->n; i++) {
        const vm_real difference = VM_FABS(vmi_part(s, last)[i] - vmi_part(s, last - 1)[i]);
        vm_real sum = 0;
        dk = VMI_LARGER(dk, difference);
        for (j = 0; j < count; j++) sum += s->pair.end_difference(j) * vmi_part(s, VMI_K + j)[i];
        dz = VMI_LARGER(dz, VM_FABS(sum));
        if (VM_FABS(s->h_done * sum) > VM_C(1e-3) * vmi_tolerance(&s->options, i, s->y[i])) differ = 1;
    }
    if (differ && dk > s->pair.stiff_beyond * dz) {
        s->stiff_misses = 0;
        if (s->stiff_hits < VMI_STIFF_HITS) s->stiff_hits++;
        if (s->stiff_hits == VMI_STIFF_HITS) s->stiff = 1;
    } else {
        if (s->stiff_misses < VMI_STIFF_MISSES) s->stiff_misses++;
        if (s->stiff_misses == VMI_STIFF_MISSES) s->stiff_hits = 0;
    }
    s->stiff_wait = VMI_STIFF_WAIT;
    if (s->stiff_hits) s->stiff_wait = 1;
}

/* Does what must follow an accepted step: tests for stiffness if a test is due, and handles the events within the step.
   Returns a status. */
VMI_APART int vmi_after_step(rk45 *s)
{
    if (s->stiff_wait <= 0) vmi_look_for_stiffness(s);
    if (s->options.n_events == 0) return ODE_OK;
    return vmi_events(s);
}

/* Returns 1 if the time s->t + s->t_low of the state is still before t_end in the direction of the run, else 0. */
VM_INLINE int vmi_is_before(const rk45 *s, vm_real t_end) { return s->t != t_end || -s->t_low * s->h > 0; }

/* Makes steps to t_end, or one accepted step if `single` is not 0. f and n are those of s. Returns a status. */
VMI_FOLDED int vmi_run(rk45 *s, vmi_rk_stepper stepper, ode_rhs f, int n, vm_real t_end, int single)
{
    const int was_stiff = s->stiff;
    const int apart = single || s->options.n_events; /* not 0: vmi_advance returns after each step */
    vmi_rk_system sys;
    int status = ODE_OK;
    sys.f = f;
    sys.ctx = s->ctx;
    sys.n = n;
    sys.w = s->work;
    sys.m = n;
    s->event = -1;
    while (status == ODE_OK && vmi_is_before(s, t_end)) {
        status = vmi_prepare(s, t_end);
        if (status) break;
        if (VMI_IS_SMALL(n)) status = vmi_advance_small(s, stepper, sys, t_end, apart);
        else status = vmi_advance(s, stepper, sys, t_end, apart);
        if (status == ODE_OK) status = vmi_after_step(s);
        if (single && s->failed == 0) break;
    }
    return status == ODE_OK && s->stiff > was_stiff ? (int)ODE_STIFF : status;
}

/* Prepares the one step of rk45_step, for the pair whose number is `method`. *t_end becomes VM_MAX, or -VM_MAX if the
   run goes backward. Returns a status; the step may be made if the status is ODE_OK. */
VM_INLINE int vmi_begin_step(rk45 *s, int method, vm_real *t_end)
{
    if (!s || s->pair.method != method) return ODE_BAD_ARGUMENT;
    *t_end = VM_MAX;
    if (s->h < 0) *t_end = -VM_MAX;
    if (s->t == *t_end) return ODE_STEP_TOO_SMALL;
    s->attempts = -1;
    return ODE_OK;
}

/* Prepares the steps of rk45_solve_with, for the pair whose number is `method`. t_end may be infinite if an event can
   end the run. Returns a status; the steps may be made if the status is ODE_OK. */
VM_INLINE int vmi_begin_solve(rk45 *s, int method, ode_rhs f, int n, vm_real t_end)
{
    if (!s || t_end != t_end || s->pair.method != method || f != s->f || n != s->n) return ODE_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t_end) && !vmi_an_event_stops(&s->options)) return ODE_BAD_ARGUMENT;
    s->attempts = s->options.max_steps;
    return ODE_OK;
}

/* Returns the time at which the steps of a run to t_end end: t_end, or the largest number of the type if t_end is
   infinite */
VM_INLINE vm_real vmi_last_time(vm_real t_end)
{
    if (t_end > VM_MAX) return VM_MAX;
    if (t_end < -VM_MAX) return -VM_MAX;
    return t_end;
}

/* Returns the status of a run to t_end whose steps have ended with `status`. If t_end is infinite and the steps have
   ended without an error or an event, t has reached the largest number of the type, and the status is
   ODE_STEP_TOO_SMALL. */
VM_INLINE int vmi_end_solve(vm_real t_end, int status)
{
    if (!VM_IS_FINITE(t_end) && (status == ODE_OK || status == ODE_STIFF)) return ODE_STEP_TOO_SMALL;
    return status;
}

#endif
