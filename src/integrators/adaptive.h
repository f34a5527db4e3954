/* integrators/adaptive.h - adaptive runs with rk45 and rk87 */
#ifndef VARMASS_INTEGRATORS_ADAPTIVE_H
#define VARMASS_INTEGRATORS_ADAPTIVE_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "events.h"
#include "ode.h"
#include "pairs.h"
#include "runs.h"
#include "steps.h"

/* Forgets which events have just happened. At another time the sign of g alone gives the side of each event. */
VM_API void vmi_forget_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) s->options.events[i].quiet = 0;
}

/* Go on from another time or state (after a jump), same n; step size and counters are kept. y may be s->y. If t is
   s->t, events that have just happened are not found again, and t_low, the rest of the time, is kept. */
VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y)
{
    if (!s || !y || !VM_IS_FINITE(t) || !vmi_all_finite(s->n, y)) return ODE_BAD_ARGUMENT;
    if (t != s->t) vmi_forget_events(s);
    if (t != s->t) s->t_low = 0;
    s->t = t;
    s->t_old = t;
    s->t_old_low = s->t_low;
    if (y != s->y) vmi_copy(s->n, y, s->y);
    s->k1 = VMI_K1_MISSING;
    s->failure = VMI_NONE_FAILED;
    s->next_miss = s->steps;
    return ODE_OK;
}

/* k_1, and a step that is not too short to be tried */
VMI_APART int vmi_prepare(rk45 *s, int method, vm_real t_end)
{
    const vm_real left = vmi_time_left(s, t_end);
    vm_real longest = VM_FABS(left), direction = left < 0 ? -1 : 1, *k1 = vmi_part(s, VMI_K), least;
    int status = ODE_OK;
    if (s->k1 == VMI_K1_IS_LAST) vmi_copy(s->n, vmi_part(s, vmi_last_k(method)), k1);
    if (s->k1 == VMI_K1_MISSING) {
        status = vmi_eval(s, s->t, s->y, k1);
        if (status) return status;
        if (!vmi_all_finite(s->n, k1)) return ODE_NOT_FINITE;
        status = vmi_watch_events(s);
        if (status) return status;
    }
    s->k1 = VMI_K1_READY;
    s->t_old = s->t;
    s->t_old_low = s->t_low;
    if (longest > s->options.h_max) longest = s->options.h_max;
    if (s->h == 0) status = vmi_first_step(s, method, direction, longest);
    if (status) return status;
    least = vmi_least_step(&s->options, s->t);
    s->h = direction * (VM_FABS(s->h) > least ? VM_FABS(s->h) : least);
    return ODE_OK;
}

/* Hairer's test [2, IV.2]: two stages at the end of the step, whose states differ by h dz and whose derivatives by dk,
   show |dk|/|dz|, about h times the largest eigenvalue. Stiff: 15 times beyond the end of the stability region,
   not 6 times within it in between. */
VM_API void vmi_look_for_stiffness(rk45 *s, int method)
{
    VM_TABLE vm_real rk45_dz[6] = {VM_C(-5.764994676128355), VM_C(12.93096931784711),   VM_C(-7.67947824816166),
                                   VM_C(1.4505935473851428), VM_C(-3.2618004650420125), VM_C(2.324710524099774)};
    VM_TABLE vm_real rk87_dz[13] = {VM_C(3.0837949279563885408),
                                    0,
                                    0,
                                    VM_C(109.26086808941762547),
                                    VM_C(9.2906424974002934497),
                                    VM_C(-8.0764000425924662677),
                                    VM_C(-113.95303182233748757),
                                    VM_C(-14.730474904623536115),
                                    VM_C(30.118949054360752405),
                                    VM_C(-37.696498610263199646),
                                    VM_C(22.938283273988783952),
                                    VM_C(-0.23613246330715421453),
                                    0};
    const int last = vmi_last_k(method), count = last - VMI_K;
    const vm_real edge = method == VMI_RK45 ? VM_C(3.4) : VM_C(5.69);
    vm_real dk = 0, dz = 0;
    int i, j;
    for (i = 0; i < s->n; i++) {
        vm_real d = VM_FABS(vmi_part(s, last)[i] - vmi_part(s, last - 1)[i]), sum = 0;
        dk = VMI_LARGER(dk, d);
        for (j = 0; j < count; j++)
            sum += (method == VMI_RK45 ? VM_READ(rk45_dz[j]) : VM_READ(rk87_dz[j])) * vmi_part(s, VMI_K + j)[i];
        dz = VMI_LARGER(dz, VM_FABS(sum));
    }
    if (dk > edge * dz) {
        s->stiff_misses = 0;
        if (s->stiff_hits < 15 && ++s->stiff_hits == 15) s->stiff = 1;
    } else if (s->stiff_misses < 6 && ++s->stiff_misses == 6) s->stiff_hits = 0;
    s->stiff_wait = s->stiff_hits ? 1 : (int)VMI_STIFF_WAIT;
}

VMI_APART int vmi_after_step(rk45 *s, int method)
{
    if (s->stiff_wait <= 0) vmi_look_for_stiffness(s, method);
    return s->options.n_events ? vmi_events(s, method) : (int)ODE_OK;
}

/* Whether y is still before t_end, even if only by less than t resolves */
VM_INLINE int vmi_is_before(const rk45 *s, vm_real t_end)
{
    return s->t != t_end || -s->t_low * s->h > 0;
}

VM_INLINE int vmi_run(rk45 *s, int method, ode_rhs f, int n, vm_real t_end, int single)
{
    const int was_stiff = s->stiff, one = single || s->options.n_events; /* a step, then what it calls for */
    int status = ODE_OK;
    s->event = -1;
    while (status == ODE_OK && vmi_is_before(s, t_end)) {
        status = vmi_prepare(s, method, t_end);
        if (status) break;
        if (VMI_IS_SMALL(n)) status = vmi_advance_small(s, method, f, n, t_end, one);
        else status = vmi_advance(s, method, f, n, t_end, one, s->work, n);
        if (status == ODE_OK) status = vmi_after_step(s, method);
        if (single && s->failure == VMI_NONE_FAILED) break;
    }
    return status == ODE_OK && s->stiff > was_stiff ? (int)ODE_STIFF : status;
}

VM_INLINE int vmi_step(rk45 *s, int method)
{
    const vm_real t_end = s && s->h < 0 ? -VM_MAX : VM_MAX;
    if (!s || s->method != method) return ODE_BAD_ARGUMENT;
    if (s->t == t_end) return ODE_STEP_TOO_SMALL;
    s->attempts = -1;
    return vmi_run(s, method, s->f, s->n, t_end, 1);
}

VM_INLINE int vmi_solve(rk45 *s, int method, ode_rhs f, int n, vm_real t_end)
{
    if (!VM_IS_FINITE(t_end) || s->method != method || f != s->f || n != s->n) return ODE_BAD_ARGUMENT;
    s->attempts = s->options.max_steps;
    return vmi_run(s, method, f, n, t_end, 0);
}

/* One accepted step, or less of it to a terminal event or a restart. */
VM_INLINE int rk45_step(rk45 *s) { return vmi_step(s, VMI_RK45); }

/* To t_end exactly, forward or backward, at once if s->t is there; or to a terminal event. */
VM_INLINE int rk45_solve(rk45 *s, vm_real t_end)
{
    return s ? vmi_solve(s, VMI_RK45, s->f, s->n, t_end) : (int)ODE_BAD_ARGUMENT;
}

/* The same for an s that was initialised with this f and n: constants here are inlined however s came about. */
VM_INLINE int rk45_solve_with(rk45 *s, ode_rhs f, int n, vm_real t_end)
{
    return s ? vmi_solve(s, VMI_RK45, f, n, t_end) : (int)ODE_BAD_ARGUMENT;
}

VM_INLINE int rk87_step(rk87 *s) { return vmi_step(s, VMI_RK87); }

VM_INLINE int rk87_solve(rk87 *s, vm_real t_end)
{
    return s ? vmi_solve(s, VMI_RK87, s->f, s->n, t_end) : (int)ODE_BAD_ARGUMENT;
}

VM_INLINE int rk87_solve_with(rk87 *s, ode_rhs f, int n, vm_real t_end)
{
    return s ? vmi_solve(s, VMI_RK87, f, n, t_end) : (int)ODE_BAD_ARGUMENT;
}

VM_API int rk87_restart(rk87 *s, vm_real t, const vm_real *y) { return rk45_restart(s, t, y); }

#endif
