/* oscillators/mean_motion.h - the motion by first-order averaging and by the laws of order 2 to 5, with error estimates

   The mean motion is the amplitude A and the phase without their small changes within a period. Numbers in brackets are
   equations of the dissertation. If no force F acts, and mass m and stiffness k change slowly, integrals give the mean
   motion. By the adiabatic law (325), (344), (367), (389) the amplitude is
     A = constant (k m^(2r-1))^(-1/(alpha+3)) exp(-2 d/(alpha+3)),
   where r is the field `reactive` and d the integral of damping/mass over time. The phase is the integral of its rate
   over time (310), (329), (370). vmi_osc_first_order puts this A and this phase into x = A cos, A cn or A ca.
   vmi_osc_order_n first adds the changes within a period, by the series of oscillators/expansion.h, which is cut off
   after an order N from 2 to 5. The error of vmi_osc_order_n is of the order epsilon^N, where epsilon is the relative
   change of mass and stiffness while the phase grows by 1.
       vmi_osc_mean mean;
       vm_osc_motion motion;
       vmi_osc_wave w = vmi_osc_wave_of(&plan, VM_ROUTE_ORDER5);
       int status = vmi_osc_mean_at(&plan, 10, &mean);
       if (!status) status = vmi_osc_order_n(&plan, VM_ROUTE_ORDER5, &w, &mean, &motion);
   Tests: tests/test_slow_motion.c, tests/test_averaging.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_MEAN_MOTION_H
#define VARMASS_OSCILLATORS_MEAN_MOTION_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "closed.h"
#include "expansion.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"
#include "walk.h"
#include "waves.h"

/* -- The mean motion at t -- */

/* Computes the mean motion where mass and stiffness have the closed forms of oscillators/closed.h. */
VM_API void vmi_osc_mean_closed(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    vmi_osc_closed_now now;
    vmi_osc_closed_mean_at(&p->closed_mean, t, &now);
    *mean = vmi_osc_mean_at_0(p);
    mean->ln_A = now.ln_A;
    mean->ratio = now.ratio;
    mean->phase = now.phase;
    mean->first = now.first;
    mean->psi = now.state.psi;
    mean->third = vmi_osc_closed_third(&p->closed_mean, &now, &p->ripple);
    mean->now.p = p->slow.p / now.el;
    mean->now.a = p->slow.a / now.el;
    mean->now.k_rate = p->slow.k_rate / now.el;
    vmi_osc_closed_disturbance_at(&p->closed_mean, &now, VMI_OSC_G, mean->E);
    mean->largest = vmi_larger(mean->largest, VM_FABS(mean->E[0]));
}

/* Computes the mean motion at a time t so close to 0 that mass and stiffness do not change between 0 and t. The same
   motion stands for that of a plan without a phase (vmi_osc_has_phase). */
VM_API int vmi_osc_mean_near_0(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const int status = vmi_osc_walk_start(p, t, mean);
    mean->phase = t;
    mean->psi += p->mean.W * t;
    return status;
}

/* Computes the mean motion at t. It uses closed forms of the integrals if there are any, else integration along the
   laws of mass and stiffness (oscillators/walk.h). */
VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_real too_short = 256 * VM_EPSILON; /* while the phase grows by less than this, a change of the laws that
                                                   does not last has no effect */
    int near_0 = !p->closed && p->Om * VM_FABS(t) < too_short, status = VM_OK;
    vmi_osc_rates now;
    vm_real relative_rate, phase;
    if (near_0) { /* mass or stiffness may change even in so short a time */
        status = vmi_osc_rates_at(&p->problem, t, -vmi_time_side(t), &now);
        if (status) return status;
        near_0 = VM_FABS(now.m / p->m0 - 1) + VM_FABS(now.k / p->k0 - 1) < too_short;
    }
    if (near_0 || !vmi_osc_has_phase(p)) status = vmi_osc_mean_near_0(p, t, mean);
    else if (p->closed) vmi_osc_mean_closed(p, t, mean);
    else status = vmi_osc_walk_to(p, t, mean);
    if (status) return status;
    if (!p->closed) vmi_osc_disturbance(&mean->now, vmi_osc_mean_state(p, mean).W, mean->E);
    if (!VM_IS_FINITE(mean->phase) || !VM_IS_FINITE(mean->ln_A) || !VM_IS_FINITE(mean->ratio)) return VM_NOT_FINITE;
    phase = VM_FABS(p->Om * mean->phase);
    relative_rate = vmi_osc_relative_rate(p->problem.alpha, mean->now.p, mean->now.a, mean->now.k_rate);
    mean->rounding = vmi_larger(vmi_osc_time_rounding(t, p->Om * mean->ratio, relative_rate),
                                4 * VM_EPSILON * (2 + phase));
    return VM_OK;
}

/* -- Estimates of the larger of |error of x|/A and |error of v|/vmax -- */

/* The part of the error that comes from rounding of phase and time, and from the error of the integral of the phase */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return mean->rounding + p->Om * mean->error;
}

/* Fast changes of mass and stiffness change the action J. This function returns a bound of the change of ln J. E_0
   measures how strongly these changes disturb the motion (oscillators/expansion.h). The exact change of ln J is the
   integral over the phase of E_0 times a periodic function whose mean is 0. This integral is integrated by parts i
   times. The result has terms at both ends, which the solutions already contain, and the integral of the ith derivative
   of E_0 times the ith integral of the periodic function. This last integral has a bound for each i, and the function
   returns the smallest of these bounds. A large i gives the smallest bound where the laws change slowly, and i = 0
   gives it where the laws change within less than a period. */
VM_API vm_real vmi_osc_fast(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real turn = r->pi / (2 * VM_PI);
    const vm_real first = (r->alpha + 3) / 4; /* bound of the periodic function (alpha+3)/2 |sa ca| */
    vm_real size = first, least = VM_INFINITY;
    int i;
    for (i = 0; i < VMI_WALK_ORDERS; i++) {
        const vm_real bound = size * mean->change[i];
        if (!(bound >= least)) least = bound;
        if (i == 0) size = r->scale / 4;
        else size *= turn;
    }
    return least + first * mean->dropped;
}

/* The error that fast changes of mass and stiffness between 0 and t cause in every averaged solution. An error of ln J,
   where J is the action, causes an error of the phase that is larger by the factor gamma Om t. gamma is a field of
   vmi_ripple, and Om is the rate of the phase. */
VM_API vm_real vmi_osc_way_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return (1 + VM_FABS(p->ripple.gamma * p->Om * mean->phase)) * vmi_osc_fast(p, mean);
}

/* Estimates the error of vmi_osc_first_order, except for the error of cos or cn in place of ca. vmi_osc_first_order
   uses the amplitude and the phase at t = 0 as if they were the mean amplitude and the mean phase. It leaves out the
   ripple within a period, and the part of the mean phase that is proportional to the number E_0
   (oscillators/expansion.h). An error of ln J, where J is the action, causes an error of the phase that is larger by
   the factor gamma Om t, where gamma is a field of vmi_ripple. The phase that follows from x and x' is larger by
   (alpha+1)/2 p/Om ca^2 than the phase that follows from x and V = x' + p x, where p is the rate of
   oscillators/reduction.h and Om the rate of the phase. The mean of this difference over a period is the same at t = 0
   and at t. */
VM_API vm_real vmi_osc_first_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real n = r->alpha + 1, e = VM_FABS((n + 2) * mean->now.p) / (p->Om * mean->ratio), M = r->mean2;
    const vm_real ripple = e * n / (2 * (n + 2)) * vmi_larger(M, 1 - M), turns = p->Om * VM_FABS(mean->phase);
    const vm_real ln_A = VM_FABS(vmi_log(p->mean.A / p->A).hi) + VM_FABS(mean->ln_J) * 2 / (n + 2);
    const vm_real shift = (p->mean.psi - p->psi) + n / 2 * p->slow.p / p->Om * M;
    const vm_real phase = VM_FABS(r->gamma) * (n + 2) / 2 * ln_A * turns + VM_FABS(shift) + ripple +
                          VM_FABS(mean->first);
    const vm_real error = phase + ln_A + e / (2 * (n + 2)) + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
    if (!(error >= 0)) return VM_INFINITY; /* the laws change so fast that the mean motion is not finite */
    return error;
}

/* Estimates the error of vmi_osc_order_n for the order 2, 3, 4 or 5. The estimate is the sum of the sizes of the first
   terms that two computations leave out. The first computation is the transformation from the mean motion to the motion
   at t, of the order `order`. The second computation is the mean motion, of the order p->start_order: it leaves out
   terms at t = 0, at points of tables, and in the mean rate of the phase. */
VM_API vm_real vmi_osc_order_error(const vm_osc_plan *p, int order, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real largest_known = VM_C(0.25); /* an estimate larger than this says nothing about the error */
    vm_real e0[VMI_OSC_G], e[VMI_OSC_G], error;
    vmi_left_out start;
    int i;
    for (i = 0; i < VMI_OSC_G; i++) {
        e0[i] = VM_FABS(p->E[i]);
        e[i] = VM_FABS(mean->E[i]);
    }
    if (!(r->scale * mean->largest < VM_C(0.5))) return VM_INFINITY; /* the laws are not slow */
    start = vmi_expansion_left_out_at_start(r, p->start_order, e0);
    start.J += VM_SQRT(mean->knots_J[p->start_order - 2]);
    start.psi += VM_SQRT(mean->knots_psi[p->start_order - 2]);
    error = vmi_expansion_error(r, vmi_expansion_left_out_at(r, order, e), start, p->Om * VM_FABS(mean->phase),
                                mean->third) +
            vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
    return error < largest_known ? error : VM_INFINITY;
}

/* -- The solutions -- */

/* Writes the motion with the amplitude A. w describes the periodic functions of position and velocity
   (oscillators/waves.h), and c and s are their values. Om is the rate of the Ateb phase, so that the largest velocity
   is 2 A Om/(alpha+1). The field evals becomes 0. Returns VM_NOT_FINITE, and leaves *motion untouched, if position or
   velocity is not finite; else VM_OK. */
VM_API int vmi_osc_motion_of(const vmi_osc_wave *w, vm_real A, vm_real Om, vm_real c, vm_real s, vm_real error,
                             int route, vm_osc_motion *motion)
{
    vm_osc_motion r;
    r.x = A * c;
    r.v = -w->speed * (2 * A * Om / (w->alpha + 1)) * s;
    r.amplitude = A;
    r.error = error;
    r.route = route;
    r.evals = 0;
    if (!VM_IS_FINITE(r.x) || !VM_IS_FINITE(r.v)) return VM_NOT_FINITE;
    *motion = r;
    return VM_OK;
}

/* Computes the motion to first order (310), (329), (370): the amplitude A follows the adiabatic law, and the phase is
   the integral of its rate Om. w is the periodic function that the route uses. */
VM_API int vmi_osc_first_order(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                               vm_osc_motion *motion)
{
    const vm_real A = p->A * vmi_exp(mean->ln_A, 0), Om = p->Om * mean->ratio;
    const vm_real error = vmi_osc_first_error(p, mean) + vmi_osc_wave_error(w, p->ripple.mean2);
    vm_real c, s;
    vmi_osc_wave_at(w, p->psi + p->Om * mean->phase, &c, &s);
    return vmi_osc_motion_of(w, A, Om, c, s, error, route, motion);
}

/* Computes the motion at t from the mean motion, by the terms of the law of order five up to the order of the route.
   route is one of VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5, and w describes the functions ca and sa. */
VM_API int vmi_osc_order_n(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                           vm_osc_motion *motion)
{
    const vmi_ripple *r = &p->ripple;
    const int order = vmi_osc_order_of(route);
    vmi_osc_reduced state = vmi_osc_mean_state(p, mean);
    vm_osc_motion result;
    vm_real sa, ca;
    vmi_osc_wave_at(w, state.psi, &ca, &sa);
    if (order > 2) {
        state = vmi_expansion_from_mean(r, order, &state, sa, ca, mean->E);
        vmi_osc_wave_at(w, state.psi, &ca, &sa);
    }
    vmi_osc_unreduce(&state, mean->now.p, r->alpha, sa, ca, &result.x, &result.v);
    result.amplitude = state.A;
    result.error = vmi_osc_order_error(p, order, mean);
    result.route = route;
    result.evals = 0;
    if (!VM_IS_FINITE(result.x) || !VM_IS_FINITE(result.v)) return VM_NOT_FINITE;
    if (!(result.error >= 0)) result.error = VM_INFINITY;
    *motion = result;
    return VM_OK;
}

#endif
