/* integrators/steps.h - step size control */
#ifndef VARMASS_INTEGRATORS_STEPS_H
#define VARMASS_INTEGRATORS_STEPS_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"
#include "pairs.h"
#include "rk45_pair.h"
#include "rk87_pair.h"
#include "runs.h"

/* The first step, from the sizes of y, y' and y'' [2, II.4]: 100 h0 at the most, where h0 moves y by 1 % of itself,
   and such that the error of the method should be 1 % of the tolerance. Uses k_2 and z. */
VM_API int vmi_first_step(rk45 *s, int method, vm_real direction, vm_real longest)
{
    const vm_real largest = VM_C(1e10), order = method == VMI_RK45 ? 5 : 8;
    vm_real *k1 = vmi_part(s, VMI_K), *k2 = vmi_part(s, VMI_K + 1), *z = vmi_part(s, VMI_Z);
    vm_real d0 = 0, d1 = 0, d2 = 0, h0, h1;
    int i, status;
    for (i = 0; i < s->n; i++) {
        vm_real tolerance = vmi_tolerance(&s->options, i, s->y[i]);
        if (VM_FABS(s->y[i]) / tolerance > d0) d0 = VM_FABS(s->y[i]) / tolerance;
        if (VM_FABS(k1[i]) / tolerance > d1) d1 = VM_FABS(k1[i]) / tolerance;
    }
    if (d0 > largest) d0 = largest;
    if (d1 > largest) d1 = largest;
    h0 = d0 < VM_C(1e-5) || d1 < VM_C(1e-5) ? VM_C(1e-6) : VM_C(0.01) * d0 / d1;
    if (h0 > longest) h0 = longest;
    for (i = 0; i < s->n; i++) z[i] = s->y[i] + direction * h0 * k1[i];
    status = vmi_eval(s, s->t + direction * h0, z, k2);
    if (status) return status;
    for (i = 0; i < s->n; i++) {
        vm_real c = VM_FABS((k2[i] - k1[i]) / h0) / vmi_tolerance(&s->options, i, s->y[i]);
        if (!(c < largest)) c = largest; /* or f does not reach so far */
        if (c > d2) d2 = c;
    }
    if (d1 > d2) d2 = d1;
    h1 = d2 <= VM_C(1e-15) ? VM_C(1e-6) : vmi_pow_rough(VM_C(0.01) / d2, 1 / order);
    if (h1 > 100 * h0) h1 = 100 * h0;
    if (h1 < VM_C(1e-3) * h0) h1 = VM_C(1e-3) * h0;
    s->h = direction * (h1 < longest ? h1 : longest);
    return ODE_OK;
}

/* The shortest step that is tried; not 0 at t = 0, where steps that fail would become shorter without end */
VM_INLINE vm_real vmi_least_step(const rk45_options *o, vm_real t)
{
    vm_real least = 2 * VM_EPSILON * VM_FABS(t) + VM_MIN;
    return least > o->h_min ? least : o->h_min;
}

/* The time from where y is to t_end */
VM_INLINE vm_real vmi_time_left(const rk45 *s, vm_real t_end) { return (t_end - s->t) - s->t_low; }

/* PI control [2, IV.2]: after an accepted step the next is 0.9 error^(-4/(5 order)) error_before^(1/(5 order)) times
   as long, at most 10 times */
VM_INLINE vm_real vmi_factor(int method, vm_real error, vm_real inverse_error_before)
{
    vm_real square = error * error, factor;
    factor = VM_C(0.9) *
             vmi_pow_rough(square * square * inverse_error_before, method == VMI_RK45 ? VM_C(-0.04) : VM_C(-0.025));
    return VMI_SMALLER(factor, VM_C(10.0));
}

/* After a rejected step: 0.9 error^(-1/order), at least 1/5; 1/10 where something was not finite */
VM_INLINE vm_real vmi_shrink(int method, vm_real error)
{
    vm_real factor;
    if (error != error) return VM_C(0.1);
    factor = VM_C(0.9) * vmi_pow_rough(error, method == VMI_RK45 ? VM_C(-0.2) : VM_C(-0.125));
    return VMI_LARGER(factor, VM_C(0.2));
}

/* The state after a step of the smallest size in which f jumps. The weights of the stages are of both signs, so that
   the step's own state may be thrown back from the jump, and far. Instead each component goes on with the middle of
   the least and the largest derivative that the stages have met: that is wrong by half the jump times h at most. */
VM_INLINE int vmi_take_middle_slope(int method, ode_rhs f, void *ctx, int n, vm_real t_new, vm_real h, vm_real *w,
                                    ptrdiff_t m, long *evals)
{
    const int last_stage = VMI_K + (method == VMI_RK45 ? 6 : 12);
    int i, part;
    VMI_EACH(i, n)
    {
        vm_real least = w[VMI_K * m + i], largest = least;
        VMI_UNROLL for (part = VMI_K + 1; part <= last_stage; part++)
        {
            least = VMI_SMALLER(least, w[part * m + i]);
            largest = VMI_LARGER(largest, w[part * m + i]);
        }
        w[VMI_Z * m + i] = w[VMI_Y * m + i] + h * (least / 2 + largest / 2);
    }
    if (method == VMI_RK87) return 0; /* whose derivative at the end is evaluated for every accepted step */
    ++*evals;
    return f(t_new, w + VMI_Z * m, w + last_stage * m, ctx);
}

/* The length of a step is changed by up to this fraction, so that it ends at a time that the type can hold and y
   belongs to t exactly. Shorter steps leave the rest in t_low. So t does not drift away from the motion. */
#define VMI_LANDING VM_C(0.015625)

/* Steps towards t_end, not past it, until it is reached, or only one if `single`, or a look for stiffness is due.
   A step whose error is within keep_from .. keep_to is followed by one of the same size, which the processor can
   predict: it does not wait for the error before it goes on. */
VM_INLINE int vmi_advance(rk45 *s, int method, ode_rhs f, int n, vm_real t_end, int single, vm_real *w, ptrdiff_t m)
{
    const rk45_options o = s->options;
    const vm_real direction = vmi_time_left(s, t_end) < 0 ? -1 : 1, nearly = VM_C(0.999999);
    const vm_real keep_from = method == VMI_RK45 ? VM_C(0.25) : VM_C(0.1), keep_to = VM_C(0.75);
    vm_real t = s->t, t_low = s->t_low, t_old = t, t_old_low = t_low, t_missed = t, t_missed_low = t_low;
    vm_real h_next = s->h, h_done = s->h_done, inverse_error = s->inverse_error;
    long attempts = s->attempts, steps = 0, rejections = 0, evals = 0, missed = 0, next_miss = s->next_miss - s->steps;
    int failure = s->failure, stopped = 0, status = ODE_OK, stiff_wait = s->stiff_wait, k1 = VMI_K1_READY;
    void *ctx = s->ctx;
    for (;;) {
        const vm_real left = (t_end - t) - t_low, least = vmi_least_step(&o, t);
        vm_real h, h_to_t_new, t_new, t_new_low, error, factor;
        int last, lands, shortest;
        t_old = t;
        t_old_low = t_low;
        k1 = VMI_K1_READY;
        if (VM_FABS(h_next) < least) h_next = direction * least;
        if (VM_FABS(h_next) > o.h_max) {
            h_next = direction * o.h_max;
            if (o.h_max < least && o.h_max < VM_FABS(left)) status = ODE_STEP_TOO_SMALL;
        }
        last = VM_FABS(h_next) >= nearly * VM_FABS(left);
        t_new = last ? t_end : t + (t_low + h_next);
        h_to_t_new = (t_new - t) - t_low;
        lands = last || VM_FABS(h_to_t_new - h_next) <= VMI_LANDING * VM_FABS(h_next);
        h = lands ? h_to_t_new : h_next;
        t_new_low = lands ? 0 : h_next - h_to_t_new;
        shortest = VM_FABS(h_next) <= least || VM_FABS(h) <= least;
        if (attempts == 0) status = ODE_MAX_STEPS;
        if (status) break;
        attempts -= attempts > 0;
        stopped = method == VMI_RK45 ? vmi_rk45_stages(f, ctx, n, t, t_new, h, w, m, &evals)
                                     : vmi_rk87_stages(f, ctx, n, t, t_new, h, w, m, &evals);
        if (stopped) break;
        error = method == VMI_RK45 ? vmi_rk45_error(&o, n, h, w, m) : vmi_rk87_error(&o, n, h, w, m);
        if (!(error <= 1)) {
            if (error > 1 && shortest && steps >= next_miss) {
                missed++;
                t_missed = t;
                t_missed_low = t_low;
                stopped = vmi_take_middle_slope(method, f, ctx, n, t_new, h, w, m, &evals);
                if (stopped) break;
                next_miss = steps + 1 + VMI_BETWEEN_MISSES;
                error = 1;
            } else {
                rejections++;
                failure = error != error ? VMI_NOT_FINITE : VMI_REJECTED;
                h_next = h * vmi_shrink(method, error);
                if (!shortest) continue;
                status = error != error ? ODE_NOT_FINITE : ODE_STEP_TOO_SMALL;
                if (missed > 0 && steps == next_miss - VMI_BETWEEN_MISSES) { /* undo the step before: it missed */
                    vmi_copy(n, w + VMI_Y_OLD * m, w + VMI_Y * m);
                    t = t_missed;
                    t_old = t_missed;
                    t_low = t_missed_low;
                    t_old_low = t_missed_low;
                    k1 = VMI_K1_MISSING;
                    steps--;
                    missed--;
                    rejections++;
                }
                break;
            }
        }
        if (method == VMI_RK87) {
            evals++;
            stopped = f(t_new, w + VMI_Z * m, w + vmi_last_k(method) * m, ctx);
            if (stopped) break;
        }
        steps++;
        error = VMI_LARGER(error, VM_C(1e-8));
        if (error < keep_from || error > keep_to || failure || last) {
            factor = vmi_factor(method, error, inverse_error);
            if (failure && factor > 1) factor = 1;
            if (!last) h_next = h * factor;
            else
                h_next = direction *
                         VMI_LARGER(VM_FABS(h_next), VM_FABS(h * factor)); /* being cut shortens no other */
        }
        inverse_error = 1 / error;
        vmi_copy(n, w + VMI_Y * m, w + VMI_Y_OLD * m);
        vmi_copy(n, w + VMI_Z * m, w + VMI_Y * m);
        t = t_new;
        t_low = t_new_low;
        h_done = h;
        failure = VMI_NONE_FAILED;
        k1 = VMI_K1_IS_LAST;
        if (--stiff_wait <= 0 || single || last) break;
        vmi_copy(n, w + vmi_last_k(method) * m, w + VMI_K * m);
    }
    s->t = t;
    s->t_low = t_low;
    s->t_old = t_old;
    s->t_old_low = t_old_low;
    s->h = h_next;
    s->h_done = h_done;
    s->inverse_error = inverse_error;
    s->steps += steps;
    s->rejected += rejections;
    s->evals += evals;
    s->missed += missed;
    s->next_miss = s->steps - steps + next_miss;
    s->attempts = attempts;
    s->stiff_wait = stiff_wait;
    s->rhs_status = stopped;
    s->failure = failure;
    s->k1 = k1;
    s->extended = 0;
    return stopped ? (int)ODE_RHS_STOPPED : status;
}

/* The same in registers, where the compiler knows that n is small */
VM_INLINE int vmi_advance_small(rk45 *s, int method, ode_rhs f, int n, vm_real t_end, int single)
{
    vm_real w[(VMI_K + 14) * VMI_SMALL] = {0}; /* all is copied back, used or not */
    int status;
    vmi_copy(n, vmi_part(s, VMI_Y), w);
    vmi_copy(n, vmi_part(s, VMI_K), w + VMI_K * n);
    status = vmi_advance(s, method, f, n, t_end, single, w, n);
    vmi_copy(n, w, vmi_part(s, VMI_Y));
    if (s->k1 == VMI_K1_IS_LAST) {
        int part;
        vmi_copy(n, w + VMI_Y_OLD * n, vmi_part(s, VMI_Y_OLD));
        VMI_UNROLL for (part = VMI_K; part <= vmi_last_k(method); part++)
            vmi_copy(n, w + part * n, vmi_part(s, part));
    } else vmi_copy(n, w + VMI_K * n, vmi_part(s, VMI_K));
    return status;
}

#endif
