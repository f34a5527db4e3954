/* integrators/steps.h - steps of an adaptive run and the control of their size
   vmi_advance is the loop over the steps. It is specialised at compile time for a pair and, where the compiler knows
   that n is small, for n and f too. The rules of step size control stand in the manual of integrators.h.

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

/* x^p to about 3 %, for x > 0 and results that neither overflow nor underflow: the bits of x, taken as an integer, are
   a piecewise linear logarithm, `middle` is half its largest error, and the exponential is (1 + v + v^2/2)^16. */
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

#define VMI_LARGEST_RATIO VM_C(1e10) /* of a component or a derivative to its tolerance, for the first step */

/* The largest |v_i| over the tolerance of component i, at most VMI_LARGEST_RATIO */
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

/* Sets s->h to the first step, from the sizes of y, y' and y'' [2, II.4]: 100 h0 at the most, where h0 moves y by 1 %
   of itself, and such that the error of the method should be 1 % of the tolerance. Uses k_2 and z. */
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
        if (!(ratio < VMI_LARGEST_RATIO)) ratio = VMI_LARGEST_RATIO; /* also where f does not reach so far */
        if (ratio > fastest) fastest = ratio;
    }
    if (speed > fastest) fastest = speed;
    if (fastest > VM_C(1e-15)) h1 = vmi_pow_rough(VM_C(0.01) / fastest, 1 / (vm_real)s->pair.order);
    if (h1 > 100 * h0) h1 = 100 * h0;
    if (h1 < VM_C(1e-3) * h0) h1 = VM_C(1e-3) * h0;
    s->h = direction * VMI_SMALLER(h1, longest);
    return ODE_OK;
}

/* The shortest step that is tried. It is not 0 at t = 0, where steps that fail would become shorter without end. */
VM_INLINE vm_real vmi_least_step(const rk45_options *o, vm_real t)
{
    const vm_real least = 2 * VM_EPSILON * VM_FABS(t) + VM_MIN;
    return VMI_LARGER(least, o->h_min);
}

/* The time from where y is to t_end */
VM_INLINE vm_real vmi_time_left(const rk45 *s, vm_real t_end) { return (t_end - s->t) - s->t_low; }

/* The direction to t_end: 1 or -1 */
VM_INLINE vm_real vmi_direction(const rk45 *s, vm_real t_end) { return vmi_time_left(s, t_end) < 0 ? -1 : 1; }

/* PI control [2, IV.2]: after an accepted step the next is 0.9 error^(-4/(5 order)) error_before^(1/(5 order)) times
   as long, at most 10 times */
VM_INLINE vm_real vmi_factor(int order, vm_real error, vm_real inverse_error_before)
{
    const vm_real square = error * error, power = VM_C(-0.2) / (vm_real)order;
    const vm_real factor = VM_C(0.9) * vmi_pow_rough(square * square * inverse_error_before, power);
    return VMI_SMALLER(factor, VM_C(10.0));
}

/* After a rejected step the next is 0.9 error^(-1/order) times as long, at least 1/5; 1/10 where something was not
   finite */
VM_INLINE vm_real vmi_shrink(int order, vm_real error)
{
    vm_real factor;
    if (error != error) return VM_C(0.1);
    factor = VM_C(0.9) * vmi_pow_rough(error, -1 / (vm_real)order);
    return VMI_LARGER(factor, VM_C(0.2));
}

/* Where a run is. While vmi_advance makes steps, it keeps this apart from the rk45, so that it can be in registers. */
typedef struct VM_TAG(vmi_progress) {
    vm_real direction;              /* 1 or -1, towards t_end */
    vm_real t, t_low;               /* y belongs to t + t_low */
    vm_real t_old, t_old_low;       /* where the last step began */
    vm_real h_next;                 /* the next step */
    vm_real h_done;                 /* the last accepted step */
    vm_real inverse_error;          /* 1 over its error, in tolerances */
    vm_real t_missed, t_missed_low; /* where the last step that missed the tolerance began */
    long steps, rejected, missed;   /* counted from the beginning of this loop */
    long next_miss;                 /* a step may miss the tolerance again when `steps` is this large */
    long attempts;                  /* steps that may still be tried; negative: no limit */
    int k1, failure, stiff_wait;    /* as in rk45 */
    int stopped;                    /* what f returned last */
} vmi_progress;

/* Where the run is before the loop */
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
    p.failure = s->failure;
    p.stiff_wait = s->stiff_wait;
    p.stopped = 0;
    return p;
}

/* Stores where the run is after the loop */
VMI_FOLDED void vmi_store_progress(rk45 *s, const vmi_progress *p)
{
    s->t = p->t;
    s->t_low = p->t_low;
    s->t_old = p->t_old;
    s->t_old_low = p->t_old_low;
    s->h = p->h_next;
    s->h_done = p->h_done;
    s->inverse_error = p->inverse_error;
    s->next_miss = s->steps + p->next_miss;
    s->steps += p->steps;
    s->rejected += p->rejected;
    s->missed += p->missed;
    s->attempts = p->attempts;
    s->k1 = p->k1;
    s->failure = p->failure;
    s->stiff_wait = p->stiff_wait;
    s->rhs_status = p->stopped;
    s->extended = 0;
}

/* A step that is tried */
typedef struct VM_TAG(vmi_trial) {
    vm_real h, t_new, t_new_low; /* it leads to t_new + t_new_low */
    int last;                    /* it leads to t_end */
    int shortest;                /* no shorter step can be tried */
} vmi_trial;

/* The length of a step is changed by up to this fraction, so that it ends at a time that the type can hold and y
   belongs to t exactly. Shorter steps leave the rest in t_low. So t does not drift away from the motion. */
#define VMI_LANDING VM_C(0.015625)
#define VMI_NEARLY VM_C(0.999999) /* a step that is this part of the way to t_end goes all the way */

/* Chooses the next step towards t_end and brings p->h_next between the smallest and the largest size. Returns the
   status that keeps it from being tried, if any. */
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

/* So many steps must keep the tolerance between two steps that may miss it. Behind a jump these steps are 1, 10 and
   100 times as long as the smallest step; next to a singularity there are none. */
enum { VMI_BETWEEN_MISSES = 3 };

/* Goes back to where the last accepted step began, which missed the tolerance */
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

/* Rejects a step, because its error is above the tolerance, or NaN. Returns the status with which the run ends if no
   shorter step can be tried; then a step before that missed the tolerance is dropped as well. */
VMI_FOLDED int vmi_reject(int order, const vmi_trial *trial, vm_real error, vmi_rk_system sys, vmi_progress *p)
{
    const int not_a_number = error != error;
    p->rejected++;
    p->failure = VMI_REJECTED;
    if (not_a_number) p->failure = VMI_NOT_FINITE;
    p->h_next = trial->h * vmi_shrink(order, error);
    if (!trial->shortest) return ODE_OK;
    if (p->missed > 0 && p->steps == p->next_miss - VMI_BETWEEN_MISSES) vmi_drop_missed_step(sys, p);
    return not_a_number ? ODE_NOT_FINITE : ODE_STEP_TOO_SMALL;
}

/* The state after a step of the smallest size in which f jumps. The weights of the stages are of both signs, so that
   the step's own state may be thrown back from the jump, and far. Instead each component goes on with the middle of
   the least and the largest derivative that the stages have met: that is wrong by half the jump times h at most. */
VM_INLINE void vmi_take_middle_slope(int stages, vmi_rk_system sys, vm_real h)
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
}

#define VMI_KEEP_TO VM_C(0.75)     /* after a step whose error is below this part of the tolerance the size may stay */
#define VMI_LEAST_ERROR VM_C(1e-8) /* smaller errors, in tolerances, count as this one */

/* Sets the size of the step after an accepted one. If the error is within keep_from .. VMI_KEEP_TO, the size stays:
   the processor can guess this branch, and go on with the next step before the error is known. */
VMI_FOLDED void vmi_choose_size(int order, vm_real keep_from, const vmi_trial *trial, vm_real error, vmi_progress *p)
{
    vm_real factor;
    if (!(error < keep_from || error > VMI_KEEP_TO || p->failure || trial->last)) return;
    factor = vmi_factor(order, error, p->inverse_error);
    if (p->failure && factor > 1) factor = 1;
    if (!trial->last) {
        p->h_next = trial->h * factor;
    } else { /* a step that is short because it ends at t_end does not make the next one short */
        p->h_next = p->direction * VMI_LARGER(VM_FABS(p->h_next), VM_FABS(trial->h * factor));
    }
}

/* Steps towards t_end, not past it, until it is reached, or only one if `single`, or until a look for stiffness is
   due. Returns a status. */
VMI_FOLDED int vmi_advance(rk45 *s, vmi_rk_stepper stepper, vmi_rk_system sys, vm_real t_end, int single)
{
    const rk45_options o = s->options;
    const vmi_rk_pair pair = stepper.pair;
    vm_real *y = sys.w + VMI_Y * sys.m, *z = sys.w + VMI_Z * sys.m, *last_k = sys.w + vmi_last_k(&pair) * sys.m;
    vmi_progress p = vmi_begin_progress(s, t_end);
    long evals = 0; /* a variable of its own, so that the address of p is not taken */
    int status;
    for (;;) {
        vmi_trial trial;
        vm_real error;
        int misses = 0; /* whether the step is accepted though it misses the tolerance */
        status = vmi_choose_step(&o, t_end, &p, &trial);
        if (status) break;
        p.stopped = stepper.make_stages(sys, p.t, trial.t_new, trial.h, &evals);
        if (p.stopped) break;
        error = stepper.step_error(&o, sys, trial.h);
        if (!(error <= 1)) {
            misses = error > 1 && trial.shortest && p.steps >= p.next_miss;
            if (!misses) {
                status = vmi_reject(pair.order, &trial, error, sys, &p);
                if (status) break;
                continue;
            }
            vmi_take_middle_slope(pair.stages, sys, trial.h);
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
        }
        error = VMI_LARGER(error, VMI_LEAST_ERROR);
        vmi_choose_size(pair.order, pair.keep_from, &trial, error, &p);
        p.inverse_error = 1 / error;
        vmi_copy(sys.n, y, sys.w + VMI_Y_OLD * sys.m);
        vmi_copy(sys.n, z, y);
        p.t = trial.t_new;
        p.t_low = trial.t_new_low;
        p.h_done = trial.h;
        p.failure = VMI_NONE_FAILED;
        p.k1 = VMI_K1_IS_LAST;
        p.stiff_wait--;
        if (p.stiff_wait <= 0 || single || trial.last) break;
        vmi_copy(sys.n, last_k, sys.w + VMI_K * sys.m);
    }
    s->evals += evals;
    vmi_store_progress(s, &p);
    return p.stopped ? (int)ODE_RHS_STOPPED : status;
}

/* vmi_advance in registers, where the compiler knows that n is small */
VMI_FOLDED int vmi_advance_small(rk45 *s, vmi_rk_stepper stepper, vmi_rk_system sys, vm_real t_end, int single)
{
    const vmi_rk_pair pair = stepper.pair;
    vm_real w[(VMI_K + VMI_MOST_OWN) * VMI_SMALL] = {0}; /* all is copied back, used or not */
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

#endif
