/* oscillators/mean_motion.h - the motion by first-order averaging and by the law of order five, with error estimates

   Without a force F the mean motion of an oscillator with slow mass and stiffness is known from integrals: the
   amplitude follows the adiabatic law (325), (344), (367), (389), and the phase is the integral of its rate (310),
   (329), (370). vmi_osc_first_order takes this mean motion for the motion, with the wave cos, cn or ca. vmi_osc_order_n
   goes from the mean motion to the motion by the transformation of oscillators/expansion.h, cut off after order 2, 3, 4
   or 5. Its error is of that order in the relative change of mass and stiffness within a radian.
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
#include "../base/scalars.h"
#include "../base/status.h"
#include "expansion.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"
#include "walk.h"
#include "waves.h"

/* -- The mean motion at t -- */

/* Computes the mean motion where mass and stiffness are exponentials in u = ln(1 + base t)/base. With el = 1 + base t
   and D = delta u, then p = p(0)/el, G_k = G_k(0)/el^(k+2), and E_k = E_k(0) exp(-(k+2) D). */
VM_API void vmi_osc_mean_closed(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_osc_problem *o = &p->problem;
    const vm_real u = t * vmi_log_ratio(p->base * t), el = 1 + p->base * t, delta = 2 * p->slow.p - p->slow.a + p->base;
    const vm_real D = delta * u, decay = vmi_exp(-D, 0), W = p->mean.W, growth = vmi_exp_ratio(D);
    vm_real E[VMI_OSC_G], ln_Om, e, power;
    int i;
    *mean = vmi_osc_mean_at_0(p);
    vmi_osc_disturbance(&p->slow, W, E);
    e = E[0];
    vmi_osc_adiabatic(p, p->rate_m * u, p->rate_k * u, o->damping * u / p->m0, &mean->ln_A, &ln_Om);
    mean->ratio = 1 / (decay * el);
    mean->inverse_mass = u / p->m0;
    mean->phase = u * growth;
    mean->first = vmi_expansion_first(&p->ripple) * W * e * u * (growth * decay);
    mean->second = vmi_expansion_second(&p->ripple) * W * e * e * u * vmi_exp_ratio(-3 * D);
    mean->psi += W * mean->phase + (mean->first + mean->second);
    mean->largest = VM_FABS(e) * vmi_larger(1, decay * decay);
    mean->third = W * VM_FABS(u * vmi_exp_ratio(-5 * D)) *
                  vmi_osc_third_rate(&p->ripple, VM_FABS(e * E[2]), VM_FABS(e * e * e));
    mean->now.m = p->m0 * vmi_exp(p->rate_m * u, 0);
    mean->now.k = p->k0 * vmi_exp(p->rate_k * u, 0);
    mean->now.a = p->slow.a / el;
    mean->now.p = p->slow.p / el;
    power = 1 / el;
    for (i = 0; i < VMI_OSC_G; i++) {
        power /= el;
        mean->now.G[i] = p->slow.G[i] * power;
    }
}

/* Computes the mean motion at a time t so close to 0 that the laws do not change between 0 and t. */
VM_API int vmi_osc_mean_near_0(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    int status = VM_OK;
    *mean = vmi_osc_mean_at_0(p);
    if (t < 0) status = vmi_osc_start_backward(p, mean);
    mean->inverse_mass = t / p->m0;
    mean->phase = t;
    mean->psi += p->mean.W * t;
    return status;
}

/* Computes the mean motion at t, by closed forms if there are any, else by a walk along the laws. */
VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_real too_short = 256 * VM_EPSILON; /* a phase in which differences of the laws are rounding errors */
    int status = VM_OK;
    if (!p->closed && p->Om * VM_FABS(t) < too_short) status = vmi_osc_mean_near_0(p, t, mean);
    else if (p->closed) vmi_osc_mean_closed(p, t, mean);
    else status = vmi_osc_walk_to(p, t, mean);
    if (status) return status;
    if (!VM_IS_FINITE(mean->phase) || !VM_IS_FINITE(mean->ln_A) || !VM_IS_FINITE(mean->ratio)) return VM_NOT_FINITE;
    return VM_OK;
}

/* -- Estimates of the larger of |error of x|/A and |error of v|/vmax -- */

/* The part of the error that comes from rounding of the phase and from the error of its integral */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return 4 * VM_EPSILON * (2 + VM_FABS(p->Om * mean->phase)) + p->Om * mean->error;
}

/* A bound of the change of ln J, where J is the action, that fast changes of mass and stiffness cause. The exact change
   of ln J is the integral of E_0 times a periodic function of the phase whose mean is 0. i integrations by parts turn
   it into the integral of the ith derivative of E_0 times the ith integral of the periodic function, and into terms at
   both ends, which the solutions contain. Each i gives a bound, and the function returns the smallest. It comes from a
   large i where the laws change slowly, and from i = 0 where they change within less than a period. */
VM_API vm_real vmi_osc_fast(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real turn = r->pi / (2 * VM_PI);
    const vm_real first = (r->alpha + 3) / 4; /* bound of (alpha+3)/2 |sa ca|; its integrals have others */
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

/* The error that fast changes of the laws between 0 and t cause in every averaged solution. An error of ln J makes an
   error of the phase that is larger by the factor gamma Om t. */
VM_API vm_real vmi_osc_way_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return (1 + VM_FABS(p->ripple.gamma * p->Om * mean->phase)) * vmi_osc_fast(p, mean);
}

/* Estimates the error of vmi_osc_first_order, except for the error of its wave. The solution takes the amplitude and
   the phase at the start for their mean values, and leaves out the ripple within a period and the term E_0 of the mean
   phase. An error of ln J makes an error of the phase that is larger by the factor gamma Om t. The phase of x and x' is
   that of x and V plus (alpha+1)/2 p/Om ca^2; the mean of this difference is the same at the start and at t. */
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
    if (!(error >= 0)) return VM_INFINITY; /* the laws are so far from slow that the mean motion has no numbers */
    return error;
}

/* Writes how large the first terms are that the transformation of an order leaves out at t, of the phase and of ln
   J, where the disturbances are e. Since the terms of the next weight may vanish, those of the weight after it
   count, too. */
VM_API void vmi_osc_left_out(const vmi_ripple *r, int order, const vm_real *e, vm_real *psi, vm_real *J)
{
    *psi = vmi_osc_size_psi(r, order, e);
    *J = vmi_osc_size_J(r, order, e) + vmi_osc_size_J(r, order + 1, e);
    if (order < 5) *psi += vmi_osc_size_psi(r, order + 1, e);
}

/* Estimates the error of vmi_osc_order_n for the order 2, 3, 4 or 5. It adds up how large the first terms are that
   are left out: by the transformation of this order at t; and by the mean motion, which is of the order of the
   start, at the start, at points of tables, and in the mean rate of the phase. Errors of ln J at the start grow
   with the phase. A factor of 2 in the sum fits the errors that tests/test_slow_motion.c finds. */
VM_API vm_real vmi_osc_order_error(const vm_osc_plan *p, int order, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real n = r->alpha + 1, g = VM_FABS(r->gamma), turns = p->Om * VM_FABS(mean->phase);
    const vmi_osc_reduced state = vmi_osc_mean_state(p, mean);
    const vm_real largest_known = VM_C(0.25); /* where the estimate is larger the error is unknown */
    vm_real e0[VMI_OSC_G], e[VMI_OSC_G], start_J, knot_J, phase, amplitude, error;
    int i;
    vmi_osc_disturbance(&mean->now, state.W, e);
    for (i = 0; i < VMI_OSC_G; i++) {
        e0[i] = VM_FABS(p->E[i]);
        e[i] = VM_FABS(e[i]);
    }
    if (!(r->scale * mean->largest < VM_C(0.5))) return VM_INFINITY; /* the laws are not slow */
    vmi_osc_left_out(r, order, e, &phase, &amplitude);
    start_J = vmi_osc_size_J(r, p->start_order + 1, e0);
    knot_J = VM_SQRT(mean->knots_J[p->start_order - 2]);
    phase += vmi_osc_size_psi(r, p->start_order, e0) + g * turns * (start_J + knot_J) + 2 * mean->third +
             VM_SQRT(mean->knots_psi[p->start_order - 2]);
    amplitude += start_J + knot_J;
    error = 4 / n * phase + 4 / (n + 2) * amplitude + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
    return error < largest_known ? error : VM_INFINITY;
}

/* -- The solutions -- */

/* Writes the motion of amplitude A. Om is the rate of the Ateb phase, so that the largest velocity is 2 A Om/(alpha+1);
   c and s are the values of the wave w. evals is set to 0. VM_NOT_FINITE leaves *motion untouched. */
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
   the integral of Om. w is the wave of the route. */
VM_API int vmi_osc_first_order(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                               vm_osc_motion *motion)
{
    const vm_real A = p->A * vmi_exp(mean->ln_A, 0), Om = p->Om * mean->ratio;
    const vm_real error = vmi_osc_first_error(p, mean) + vmi_osc_wave_error(w, p->ripple.mean2);
    vm_real c, s;
    vmi_osc_wave_at(w, p->psi + p->Om * mean->phase, &c, &s);
    return vmi_osc_motion_of(w, A, Om, c, s, error, route, motion);
}

/* Computes the motion at t from the mean motion, by the law of order five, cut off after the order of the route. route
   is one of VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5, w its wave. */
VM_API int vmi_osc_order_n(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                           vm_osc_motion *motion)
{
    const vmi_ripple *r = &p->ripple;
    const int order = vmi_osc_order_of(route);
    vmi_osc_reduced state = vmi_osc_mean_state(p, mean);
    vmi_ripple_values f;
    vm_osc_motion result;
    vm_real E[VMI_OSC_G], sa, ca, ln_J;
    vmi_osc_disturbance(&mean->now, state.W, E);
    vmi_osc_wave_at(w, state.psi, &ca, &sa);
    if (order > 2) {
        vmi_ripple_at(r, order, state.psi, sa, ca, &f);
        vmi_osc_wave_at(w, state.psi + vmi_expansion_psi_back(r, order, &f, E), &ca, &sa);
        ln_J = vmi_expansion_J_back(r, order, &f, E);
        state.A *= vmi_exp(2 / (r->alpha + 3) * ln_J, 0);
        state.W *= vmi_exp(r->gamma * ln_J, 0);
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
