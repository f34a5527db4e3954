/* integrators/steps.h - steps of an adaptive run and the control of their size
   vmi_advance is the loop over the steps. The compiler makes a version of this loop for each pair; if it knows n and f
   in a call and n is small, it makes a version for this n and this f. The manual in integrators.h explains how the
   size of the steps is chosen.

   Tests: tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_STEPS_H
#define VARMASS_INTEGRATORS_STEPS_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/bits.h"
#include "../base/real.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "runs.h"

/* Returns x^p with an error of at most 1.6 % if |p| <= 0.2 and the result is from 0.1 to 10. x must be positive, and
   the result must neither overflow nor underflow. The bits of x, read as an integer, give an approximate logarithm of
   x, which is linear between powers of 2. `middle` is half the largest error of this logarithm; it is added, so that
   the largest error is only half as large. The exponential function e^(16 v) is computed as (1 + v + v^2/2)^16. */
VM_INLINE vm_real vmi_pow_rough(vm_real x, vm_real p)
{
    const vm_real ln2 = VM_C(0.69314718055994531), middle = VM_C(0.043);
    vmi_signed_bits bits;
    vm_real v;
    memcpy(&bits, &x, sizeof x);
    v = ((vm_real)(bits - VMI_BITS_OF_1) + middle / VM_EPSILON) * (p * (ln2 / 16 * VM_EPSILON));
    v = 1 + v * (1 + v / 2);
    v *= v;
    v *= v;
    v *= v;
    v *= v;
    return v;
}

#define VMI_LARGEST_RATIO VM_C(1e10) /* upper limit of the ratios from which vmi_first_step chooses the first step */

/* Returns the largest ratio of |v_i| to the tolerance of component i, but at most VMI_LARGEST_RATIO. */
VM_API vm_real vmi_norm_by_tolerance(const rk45 *s, const vm_real *v)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < s->n; i++) {
        const vm_real ratio = VM_FABS(v[i]) / vmi_tolerance(&s->options, i, s->y[i]);
        if (ratio > largest) largest = ratio;
    }
    return VMI_SMALLER(largest, VMI_LARGEST_RATIO);
}

/* Chooses the size s->h of the first step from the magnitudes of y, y' and y'' (Hairer et al. [2, II.4]). The aim is an
   error of this step of 1 % of the tolerance. |s->h| is at most `longest`, and at most 100 times the size of a step
   that changes y by 1 % (at most 1e-4 if y or y' is below 1e-5 of the tolerance). A ratio of y, y' or y'' to the
   tolerance counts as at most VMI_LARGEST_RATIO; if y' is larger, the first step may be too long and be rejected.
   `direction`, 1 or -1, is the sign of s->h. The function overwrites k_2 and the part VMI_Z of work. Returns a status.
   */
VM_API int vmi_first_step(rk45 *s, vm_real direction, vm_real longest)
{
    vm_real *k1 = vmi_part(s, VMI_K), *k2 = vmi_part(s, VMI_K + 1), *z = vmi_part(s, VMI_Z);
    const vm_real size = vmi_norm_by_tolerance(s, s->y), speed = vmi_norm_by_tolerance(s, k1);
    vm_real h0 = VM_C(1e-6), h1 = VM_C(1e-6), fastest = 0;
    int i, status;
    if (size >= VM_C(1e-5) && speed >= VM_C(1e-5)) h0 = VM_C(0.01) * size / speed;
    if (h0 > longest) h0 = longest;
    for (i = 0; i < s->n; i++) z[i] = s->y[i] + direction * h0 * k1[i];
    status = vmi_eval(s, s->t + direction * h0, z, k2);
    if (status) return status;
    for (i = 0; i < s->n; i++) {
        vm_real ratio = VM_FABS((k2[i] - k1[i]) / h0) / vmi_tolerance(&s->options, i, s->y[i]);
        if (!(ratio < VMI_LARGEST_RATIO)) ratio = VMI_LARGEST_RATIO; /* also where f is NaN */
        if (ratio > fastest) fastest = ratio;
    }
    if (speed > fastest) fastest = speed;
    if (fastest > VM_C(1e-15)) h1 = vmi_pow_rough(VM_C(0.01) / fastest, 1 / (vm_real)s->pair.order);
    if (h1 > 100 * h0) h1 = 100 * h0;
    if (h1 < VM_C(1e-3) * h0) h1 = VM_C(1e-3) * h0;
    s->h = direction * VMI_SMALLER(h1, longest);
    return ODE_OK;
}

/* Returns the length of the shortest step that is tried at the time t. It is positive at t = 0 too, since otherwise
   failing steps could become shorter without end. */
VM_INLINE vm_real vmi_least_step(const rk45_options *o, vm_real t)
{
    const vm_real least = 2 * VM_EPSILON * VM_FABS(t) + VM_MIN;
    return VMI_LARGER(least, o->h_min);
}

/* Returns the time from the state y to t_end, negative if the run goes backward. */
VM_INLINE vm_real vmi_time_left(const rk45 *s, vm_real t_end) { return (t_end - s->t) - s->t_low; }

/* Returns the direction of the run to t_end: 1 forward, -1 backward. */
VM_INLINE vm_real vmi_direction(const rk45 *s, vm_real t_end) { return vmi_time_left(s, t_end) < 0 ? -1 : 1; }

/* Returns the factor by which the step size changes after an accepted step, by PI control (Hairer et al. [2, IV.2]). It
   is the smaller of 10 and
     0.9 error^(-4/(5 order)) error_before^(1/(5 order)),
   where error is the error of this step divided by its tolerance, and error_before is the same ratio for the previous
   step. */
VM_INLINE vm_real vmi_factor(int order, vm_real error, vm_real inverse_error_before)
{
    const vm_real square = error * error, power = VM_C(-0.2) / (vm_real)order;
    const vm_real factor = VM_C(0.9) * vmi_pow_rough(square * square * inverse_error_before, power);
    return VMI_SMALLER(factor, VM_C(10.0));
}

/* Returns the factor by which the step size changes after a rejected step: 0.9 error^(-1/order), at least 1/5, where
   error is the error of the step divided by its tolerance. It is 1/10 if error is NaN. */
VM_INLINE vm_real vmi_shrink(int order, vm_real error)
{
    vm_real factor;
    if (error != error) return VM_C(0.1);
    factor = VM_C(0.9) * vmi_pow_rough(error, -1 / (vm_real)order);
    return VMI_LARGER(factor, VM_C(0.2));
}

/* The fields of an rk45 that change from step to step. vmi_advance keeps these fields in a local variable while it
   makes steps, so that the compiler can put them in registers. */
typedef struct VM_TAG(vmi_progress) {
    vm_real direction;              /* direction to t_end: 1 forward, -1 backward */
    vm_real t, t_low;               /* y belongs to the time t + t_low */
    vm_real t_old, t_old_low;       /* the last step began at the time t_old + t_old_low */
    vm_real h_next;                 /* size of the next step */
    vm_real h_done;                 /* size of the last accepted step */
    vm_real inverse_error;          /* tolerance of the last accepted step divided by its error */
    vm_real t_missed, t_missed_low; /* their sum is the time at which the last step above the tolerance began */
    long steps, rejected, missed;   /* numbers of steps since vmi_advance was called */
    long next_miss;                 /* value of `steps` from which on a step may miss the tolerance again */
    long attempts;                  /* number of steps that may still be tried; negative means no limit */
    int k1, failed, stiff_wait;     /* the fields of rk45 with these names */
    int stopped;                    /* number that f returned last; if it is not 0, the run stops */
} vmi_progress;

/* Returns the fields that change from step to step, as they are before the loop. */
VMI_FOLDED vmi_progress vmi_begin_progress(const rk45 *s, vm_real t_end)
{
    vmi_progress p;
    p.direction = vmi_direction(s, t_end);
    p.t = s->t;
    p.t_low = s->t_low;
    p.t_old = s->t;
    p.t_old_low = s->t_low;
    p.h_next = s->h;
    p.h_done = s->h_done;
    p.inverse_error = s->inverse_error;
    p.t_missed = s->t;
    p.t_missed_low = s->t_low;
    p.steps = 0;
    p.rejected = 0;
    p.missed = 0;
    p.next_miss = s->next_miss - s->steps;
    p.attempts = s->attempts;
    p.k1 = VMI_K1_READY;
    p.failed = s->failed;
    p.stiff_wait = s->stiff_wait;
    p.stopped = 0;
    return p;
}

/* After the loop, stores in s the fields that change from step to step */
VMI_FOLDED void vmi_store_progress(rk45 *s, const vmi_progress *p)
{
    s->t = p->t;
    s->t_low = p->t_low;
    s->t_old = p->t_old;
    s->t_old_low = p->t_old_low;
    s->h = p->h_next;
    s->h_done = p->h_done;
    s->inverse_error = p->inverse_error;
    s->next_miss = vmi_count(s->steps, p->next_miss);
    s->steps = vmi_count(s->steps, p->steps);
    s->rejected = vmi_count(s->rejected, p->rejected);
    s->missed = vmi_count(s->missed, p->missed);
    s->attempts = p->attempts;
    s->k1 = p->k1;
    s->failed = p->failed;
    s->stiff_wait = p->stiff_wait;
    s->rhs_status = p->stopped;
    s->extended = 0;
}

/* A step that is tried */
typedef struct VM_TAG(vmi_trial) {
    vm_real h, t_new, t_new_low; /* size of the step, and its end, the time t_new + t_new_low */
    int last;                    /* 1 if the step ends at t_end */
    int shortest;                /* 1 if no shorter step can be tried */
} vmi_trial;

/* The size of a step is changed by at most this fraction, 1/64, so that the time at the end of the step is a number of
   the type vm_real. If this needs a larger change, the step is very short: its size then stays the same, and it ends
   between two numbers of the type. The time of the state y is t + t_low; after this step t_low is not 0. */
#define VMI_LANDING VM_C(0.015625)
#define VMI_NEARLY VM_C(0.999999) /* a step of at least this fraction of the time to t_end ends at t_end */

/* Chooses the next step towards t_end and brings p->h_next between the smallest and the largest size. Returns ODE_OK,
   or the status with which the run ends: ODE_STEP_TOO_SMALL if h_max is too small, ODE_MAX_STEPS if no attempt is
   left. */
VMI_FOLDED int vmi_choose_step(const rk45_options *o, vm_real t_end, vmi_progress *p, vmi_trial *trial)
{
    const vm_real left = (t_end - p->t) - p->t_low, least = vmi_least_step(o, p->t);
    vm_real h_to_t_new;
    int status = ODE_OK, lands;
    p->t_old = p->t;
    p->t_old_low = p->t_low;
    p->k1 = VMI_K1_READY;
    if (VM_FABS(p->h_next) < least) p->h_next = p->direction * least;
    if (VM_FABS(p->h_next) > o->h_max) {
        p->h_next = p->direction * o->h_max;
        if (o->h_max < least && o->h_max < VM_FABS(left)) status = ODE_STEP_TOO_SMALL;
    }
    trial->last = VM_FABS(p->h_next) >= VMI_NEARLY * VM_FABS(left);
    trial->t_new = trial->last ? t_end : p->t + (p->t_low + p->h_next);
    h_to_t_new = (trial->t_new - p->t) - p->t_low;
    lands = trial->last || VM_FABS(h_to_t_new - p->h_next) <= VMI_LANDING * VM_FABS(p->h_next);
    trial->h = lands ? h_to_t_new : p->h_next;
    trial->t_new_low = lands ? 0 : p->h_next - h_to_t_new;
    trial->shortest = VM_FABS(p->h_next) <= least || VM_FABS(trial->h) <= least;
    if (p->attempts == 0) status = ODE_MAX_STEPS;
    if (status == ODE_OK && p->attempts > 0) p->attempts--;
    return status;
}

/* The number of steps that must keep the tolerance between two steps that miss it. After a jump of f the next three
   steps keep the tolerance; they are 1, 10 and 100 times as long as the smallest step. Next to a singularity of f no
   step keeps the tolerance. */
enum { VMI_BETWEEN_MISSES = 3 };

/* Undoes the last accepted step, which missed the tolerance */
VMI_FOLDED void vmi_drop_missed_step(vmi_rk_system sys, vmi_progress *p)
{
    vmi_copy(sys.n, sys.w + VMI_Y_OLD * sys.m, sys.w + VMI_Y * sys.m);
    p->t = p->t_missed;
    p->t_old = p->t_missed;
    p->t_low = p->t_missed_low;
    p->t_old_low = p->t_missed_low;
    p->k1 = VMI_K1_MISSING;
    p->steps--;
    p->missed--;
    p->rejected++;
}

/* Rejects a step whose error is above the tolerance or NaN, and chooses the size of the next attempt. Returns ODE_OK if
   a shorter step can be tried. Otherwise returns the status with which the run ends. If the run ends and the last
   accepted step missed the tolerance and was made in this call of vmi_advance, that step is undone. */
VMI_FOLDED int vmi_reject(int order, const vmi_trial *trial, vm_real error, vmi_rk_system sys, vmi_progress *p)
{
    const int not_a_number = error != error;
    p->rejected++;
    p->failed = 1;
    p->h_next = trial->h * vmi_shrink(order, error);
    if (!trial->shortest) return ODE_OK;
    if (p->missed > 0 && p->steps == p->next_miss - VMI_BETWEEN_MISSES) vmi_drop_missed_step(sys, p);
    if (not_a_number) p->k1 = VMI_K1_MISSING; /* k_1 may be NaN: another call must evaluate it again */
    return not_a_number ? ODE_NOT_FINITE : ODE_STEP_TOO_SMALL;
}

/* Replaces the state after a step of the smallest size in which f jumps. Some weights of the stages are positive and
   others negative, so that the weighted sum of the derivatives may lead far away from the state at the jump. Therefore
   each component is continued with the mean of the smallest and the largest of its derivatives in the stages. The
   error of this mean is at most half the jump. Returns 0 if the new state is not finite because f is infinite in a
   stage, else 1. */
VM_INLINE int vmi_take_middle_slope(int stages, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    vm_real *w = sys.w;
    int i, part;
    VMI_EACH(i, sys.n)
    {
        vm_real least = w[VMI_K * m + i], largest = least;
        VMI_UNROLL for (part = VMI_K + 1; part < VMI_K + stages; part++)
        {
            least = VMI_SMALLER(least, w[part * m + i]);
            largest = VMI_LARGER(largest, w[part * m + i]);
        }
        w[VMI_Z * m + i] = w[VMI_Y * m + i] + h * (least / 2 + largest / 2);
    }
    return vmi_all_finite(sys.n, w + VMI_Z * m);
}

#define VMI_KEEP_TO VM_C(0.75)     /* an error below this fraction of the tolerance lets the step size stay the same */
#define VMI_LEAST_ERROR VM_C(1e-8) /* if a ratio of an error to its tolerance is smaller than this, it is set to this */

/* Chooses the size of the step after an accepted step. The size stays the same if the error is between keep_from and
   VMI_KEEP_TO times the tolerance. Then the processor can predict that the size stays the same, and begin the next
   step before the error is known. */
VMI_FOLDED void vmi_choose_size(int order, vm_real keep_from, const vmi_trial *trial, vm_real error, vmi_progress *p)
{
    vm_real factor;
    if (!(error < keep_from || error > VMI_KEEP_TO || p->failed || trial->last)) return;
    factor = vmi_factor(order, error, p->inverse_error);
    if (p->failed && factor > 1) factor = 1;
    if (!trial->last) {
        p->h_next = trial->h * factor;
    } else { /* a step may be short only because it ends at t_end; the next step need not be short */
        p->h_next = p->direction * VMI_LARGER(VM_FABS(p->h_next), VM_FABS(trial->h * factor));
    }
}

/* Makes steps until t_end is reached or a test of stiffness is due, or one accepted step if `single` is not 0. Returns
   a status. */
VMI_FOLDED int vmi_advance(rk45 *s, vmi_rk_stepper stepper, vmi_rk_system sys, vm_real t_end, int single)
{
    const rk45_options o = s->options;
    const vmi_rk_pair pair = stepper.pair;
    vm_real *y = sys.w + VMI_Y * sys.m, *z = sys.w + VMI_Z * sys.m, *last_k = sys.w + vmi_last_k(&pair) * sys.m;
    vmi_progress p = vmi_begin_progress(s, t_end);
    long evals = 0; /* not a field of p: make_stages gets its address, and p would then not stay in registers */
    int status;
    for (;;) {
        vmi_trial trial;
        vm_real error;
        int misses = 0; /* 1 if the step is accepted although its error is above the tolerance */
        status = vmi_choose_step(&o, t_end, &p, &trial);
        if (status) break;
        p.stopped = stepper.make_stages(sys, p.t, trial.t_new, trial.h, &evals);
        if (p.stopped) break;
        error = stepper.step_error(&o, sys, trial.h);
        if (!(error <= 1)) {
            misses = error > 1 && trial.shortest && p.steps >= p.next_miss;
            if (misses && !vmi_take_middle_slope(pair.stages, sys, trial.h)) {
                misses = 0;
                error = VM_NAN;
            }
            if (!misses) {
                status = vmi_reject(pair.order, &trial, error, sys, &p);
                if (status) break;
                continue;
            }
            error = 1;
        }
        if (misses || !pair.last_is_first) {
            evals++;
            p.stopped = sys.f(trial.t_new, z, last_k, sys.ctx);
            if (p.stopped) break;
        }
        p.steps++;
        if (misses) {
            p.missed++;
            p.next_miss = p.steps + VMI_BETWEEN_MISSES;
            p.t_missed = p.t;
            p.t_missed_low = p.t_low;
            if (p.stiff_wait < 2) p.stiff_wait = 2; /* the test of stiffness waits for a step within the tolerance */
        }
        error = VMI_LARGER(error, VMI_LEAST_ERROR);
        vmi_choose_size(pair.order, pair.keep_from, &trial, error, &p);
        p.inverse_error = 1 / error;
        vmi_copy(sys.n, y, sys.w + VMI_Y_OLD * sys.m);
        vmi_copy(sys.n, z, y);
        p.t = trial.t_new;
        p.t_low = trial.t_new_low;
        p.h_done = trial.h;
        p.failed = 0;
        p.k1 = VMI_K1_IS_LAST;
        p.stiff_wait--;
        if (p.stiff_wait <= 0 || single || trial.last) break;
        vmi_copy(sys.n, last_k, sys.w + VMI_K * sys.m);
    }
    s->evals = vmi_count(s->evals, evals);
    vmi_store_progress(s, &p);
    return p.stopped ? (int)ODE_RHS_STOPPED : status;
}

/* Does the work of vmi_advance in a local array, which the compiler keeps in registers if it knows that n is small */
VMI_FOLDED int vmi_advance_small(rk45 *s, vmi_rk_stepper stepper, vmi_rk_system sys, vm_real t_end, int single)
{
    const vmi_rk_pair pair = stepper.pair;
    vm_real w[(VMI_K + VMI_MOST_OWN) * VMI_SMALL] = {0}; /* 0, because unused parts are copied, too */
    const int n = sys.n;
    int part, status;
    vmi_copy(n, vmi_part(s, VMI_Y), w);
    vmi_copy(n, vmi_part(s, VMI_K), w + VMI_K * n);
    sys.w = w;
    sys.m = n;
    status = vmi_advance(s, stepper, sys, t_end, single);
    vmi_copy(n, w, vmi_part(s, VMI_Y));
    if (s->k1 == VMI_K1_IS_LAST) {
        vmi_copy(n, w + VMI_Y_OLD * n, vmi_part(s, VMI_Y_OLD));
        VMI_UNROLL for (part = VMI_K; part <= vmi_last_k(&pair); part++) vmi_copy(n, w + part * n, vmi_part(s, part));
    } else {
        vmi_copy(n, w + VMI_K * n, vmi_part(s, VMI_K));
    }
    return status;
}

/* Undoes the last accepted step, so that the next step is the same step again. vmi_advance must have returned after
   this step: its k_1 is then still in work. */
VM_API void vmi_take_back_step(rk45 *s)
{
    vmi_copy(s->n, vmi_part(s, VMI_Y_OLD), s->y);
    s->t = s->t_old;
    s->t_low = s->t_old_low;
    s->h = s->h_done;
    if (s->missed > 0 && s->next_miss - VMI_BETWEEN_MISSES == s->steps) {
        s->missed--;
        s->next_miss = 0;
    }
    s->steps--;
    s->k1 = VMI_K1_READY;
}

#endif
