/* oscillators/walk.h - the mean motion of an oscillator if its integrals have no closed form

   The mean motion at t follows from integrals along the laws of mass and stiffness from 0 to t. vmi_osc_walk_to adds up
   these integrals over panels, which are short intervals of time (oscillators/panels.h), from one point of a table to
   the next. At such a point the second derivatives of the laws jump. E_0 = G_0/W^2 contains these derivatives;
   therefore the mean motion jumps, too. This integration, called the walk, also measures how large E_0 and its
   derivatives are; the estimates of the error need these numbers. E_0 measures how strongly the damping and the changes
   of mass and stiffness disturb the motion (oscillators/expansion.h).
       vmi_osc_mean mean;
       int status = vmi_osc_walk_to(&plan, 10, &mean); // plan is a vm_osc_plan; mean.psi, mean.inverse_mass, ...
   Tests: tests/test_slow_motion.c, tests/test_averaging.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_WALK_H
#define VARMASS_OSCILLATORS_WALK_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "expansion.h"
#include "laws.h"
#include "legendre.h"
#include "panels.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"
#include "waves.h"

/* The number of elements of the field `change`. The elements measure how large E_0 and its first six derivatives with
   respect to the phase are; the top of this file explains E_0. */
enum { VMI_WALK_ORDERS = 7 };

/* The mean motion at one time t, and the numbers on which its errors depend. According to the adiabatic law, by which
   the action stays constant, the amplitude is A = A0 exp(ln_A), and the rate of the phase is `ratio` times the rate at
   t = 0. A0 is the amplitude at t = 0. J is the action. */
typedef struct VM_TAG(vmi_osc_mean) {
    vmi_osc_slow now;      /* mass, stiffness and the numbers G_k just before t, or for t < 0 just after t; where closed
                              forms are used, only its fields p, a and k_rate belong to t */
    vm_real E[VMI_OSC_G];  /* the numbers E_k = G_k/W^(k+2) at t, for the rate W of the mean phase */
    vm_real ln_A, ratio;   /* ln(A/A0), and (phase rate at t)/(phase rate at t = 0), by the adiabatic law */
    vm_real inverse_mass;  /* the integral of dt/m from 0 to t, s/kg; 0 where closed forms are used and near time 0 */
    vm_real phase;         /* the integral of `ratio` over time from 0 to t, s */
    vm_real psi;           /* the mean phase */
    vm_real ln_J;          /* ln of (mean action at t)/(mean action at t = 0); it changes only at points of tables */
    vm_real first;         /* the part of psi that is proportional to E_0 */
    vm_real third;         /* a bound of the terms of psi that the law of order five leaves out */
    vm_real knots_J[4];    /* element i is for order i + 2: sum of the squares of the errors of ln J at points of
                              tables */
    vm_real knots_psi[4];  /* element i is for order i + 2: sum of the squares of the errors of psi at points of
                              tables */
    vm_real largest;       /* largest |E_0| between 0 and t; E_0 = G_0/W^2 measures how much the motion is disturbed */
    /* Element i, from 0 to 6, is the integral of |d^i E_0/dpsi^i| over psi from time 0 to t, where d^i/dpsi^i is the
       ith derivative with respect to the phase. All elements are 0 where closed forms of the laws are used. */
    vm_real change[VMI_WALK_ORDERS];
    vm_real dropped;       /* integral over psi of the part of |E_0| that is not in `change` */
    vm_real shortest;      /* length of the shortest panel that was needed, s */
    vm_real error;         /* estimated error of `phase`, s */
    vm_real rounding;      /* error of the motion by rounding of phase and time */
} vmi_osc_mean;

/* Writes ln(A/A0) and ln(Om/Om0) by the adiabatic law. A is the amplitude, Om the rate of the phase, m the mass and k
   the stiffness; A0, Om0, m0 and k0 are their values at t = 0. The arguments are ln_m = ln(m/m0), ln_k = ln(k/k0) and
   `decay`, the integral of b/m over time, where b is the damping. */
VM_API void vmi_osc_adiabatic(const vm_osc_plan *p, vm_real ln_m, vm_real ln_k, vm_real decay, vm_real *ln_A,
                              vm_real *ln_Om)
{
    const vm_real alpha = p->problem.alpha, r = 2 * p->problem.reactive - 1, g = p->ripple.gamma;
    *ln_A = -(ln_k + r * ln_m + 2 * decay) / (alpha + 3);
    *ln_Om = ((1 - g) * ln_k - (1 + g * r) * ln_m) / 2 - g * decay;
}

/* The mean motion at t = 0 of the oscillator for which the plan was made; only the numbers E_k are not written */
VM_API vmi_osc_mean vmi_osc_mean_at_0(const vm_osc_plan *p)
{
    vmi_osc_mean mean;
    int i;
    mean.now = p->slow;
    mean.ln_A = 0;
    mean.ratio = 1;
    mean.inverse_mass = 0;
    mean.phase = 0;
    mean.psi = p->mean.psi;
    mean.ln_J = 0;
    mean.first = 0;
    mean.third = 0;
    mean.largest = VM_FABS(p->E[0]);
    for (i = 0; i < 4; i++) {
        mean.knots_J[i] = 0;
        mean.knots_psi[i] = 0;
    }
    for (i = 0; i < VMI_WALK_ORDERS; i++) mean.change[i] = 0;
    mean.dropped = 0;
    mean.shortest = VM_INFINITY;
    mean.error = 0;
    mean.rounding = 0;
    return mean;
}

/* The amplitude, phase and rate of the mean motion *mean */
VM_API vmi_osc_reduced vmi_osc_mean_state(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    vmi_osc_reduced state;
    state.A = p->mean.A * vmi_exp(mean->ln_A + 2 / (r->alpha + 3) * mean->ln_J, 0);
    state.W = p->mean.W * mean->ratio * vmi_exp(r->gamma * mean->ln_J, 0);
    state.psi = mean->psi;
    return state;
}

/* -- A panel -- */

/* A panel, which is a short interval of time: the Legendre series of the laws on the panel, and what the panel adds to
   the integrals */
typedef struct VM_TAG(vmi_osc_panel) {
    vm_real edge;               /* largest relative difference between 1/m or k and its series at the panel's ends */
    vm_real inverse[VMI_GAUSS]; /* series of 1/m */
    vm_real ratio[VMI_GAUSS];   /* at first the series of k, later the series of (phase rate)/(phase rate at t = 0) */
    vm_real E[VMI_GAUSS];       /* series of E_0 = G_0/W^2 */
    vm_real noise;              /* size of those coefficients of the series E that only rounding errors of p' cause
                                   (vmi_osc_rate_noise) */
    vm_real first, second;      /* integrals of E_0 and of E_0^2 over the phase */
    vm_real cube;               /* integral of |E_0|^3 over the phase */
    vm_real largest;            /* largest |E_0| on the panel */
} vmi_osc_panel;

/* Mass, stiffness, and the rates a and p of oscillators/reduction.h, at the points of Gauss' rule on a panel */
typedef struct VM_TAG(vmi_osc_panel_laws) {
    vmi_osc_rates rates[VMI_GAUSS];
    vm_real p_rate[VMI_GAUSS]; /* time derivatives p' of the rate p of `rates`, 1/s^2 */
} vmi_osc_panel_laws;

/* Reads the laws at the points of Gauss' rule on a panel. Writes the Legendre series of 1/m to panel->inverse, the
   series of k to panel->ratio, and to panel->edge the largest relative difference between these series and the laws at
   the ends of the panel. */
VM_API int vmi_osc_read_laws(const vm_osc_problem *o, int side, vm_real start, vm_real length, vmi_osc_panel_laws *at,
                             vmi_osc_panel *panel)
{
    vm_real inverse[VMI_GAUSS], stiffness[VMI_GAUSS], rate[VMI_GAUSS], p[VMI_GAUSS], same[VMI_GAUSS];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        status = vmi_osc_rates_at(o, t, side, &at->rates[i]);
        if (status) return status;
        inverse[i] = 1 / at->rates[i].m;
        stiffness[i] = at->rates[i].k;
        rate[i] = at->rates[i].p;
    }
    vmi_legendre_fit(inverse, stiffness, panel->inverse, panel->ratio);
    vmi_legendre_fit(rate, rate, p, same);
    vmi_legendre_derive(p);
    for (i = 0; i < VMI_GAUSS; i++) at->p_rate[i] = 2 / length * vmi_legendre_at(p, vmi_gauss_node(i));
    panel->edge = 0;
    status = vmi_panel_edge(&o->mass, VM_BAD_MASS, 1, start, length, panel->inverse, &panel->edge);
    if (status) return status;
    return vmi_panel_edge(&o->stiffness, VM_BAD_STIFFNESS, 0, start, length, panel->ratio, &panel->edge);
}

/* Returns the size of the errors of p' that rounding errors of the slow rates a and p cause on a panel of 1 s, divided
   by |a| + |p|. In float the result is 0: such errors cannot be distinguished from fast changes of the laws, and count
   as fast changes. */
VM_API vm_real vmi_osc_rate_noise(void) { return VM_MANT_DIG > 24 ? 2048 * VM_EPSILON : 0; }

/* Computes the panel from the time start to start + length, where length < 0 means backward in time. *mean is the mean
   motion at the time start. */
VM_API int vmi_osc_panel_of(const vm_osc_plan *p, const vmi_osc_mean *mean, vm_real start, vm_real length,
                            vmi_osc_panel *panel)
{
    const int damped = p->problem.damping != 0;
    const vm_real W0 = p->mean.W * vmi_exp(p->ripple.gamma * mean->ln_J, 0);
    const vm_real p_noise = vmi_osc_rate_noise() / VM_FABS(length);
    vmi_osc_panel_laws at;
    vm_real ratios[VMI_GAUSS], E[VMI_GAUSS];
    int i, status = vmi_osc_read_laws(&p->problem, vmi_time_side(length), start, length, &at, panel);
    if (status) return status;
    panel->noise = 0;
    panel->first = 0;
    panel->second = 0;
    panel->cube = 0;
    panel->largest = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real way = damped ? length / 2 * vmi_legendre_integral(panel->inverse, vmi_gauss_node(i)) : 0;
        const vmi_osc_rates *now = &at.rates[i];
        vm_real ln_A, ln_Om, W, share;
        vmi_osc_adiabatic(p, vmi_log(now->m / p->m0).hi, vmi_log(now->k / p->k0).hi,
                          p->problem.damping * (mean->inverse_mass + way), &ln_A, &ln_Om);
        ratios[i] = vmi_exp(ln_Om, 0);
        W = W0 * ratios[i];
        E[i] = now->p / W * ((now->p - now->a) / W) - at.p_rate[i] / W / W;
        panel->noise = vmi_larger(p_noise / W * ((VM_FABS(now->p) + VM_FABS(now->a)) / W), panel->noise);
        share = vmi_gauss_weight(i) / 2 * length * W;
        panel->first += share * E[i];
        panel->second += share * E[i] * E[i];
        panel->cube += VM_FABS(share * E[i]) * E[i] * E[i];
        panel->largest = vmi_larger(VM_FABS(E[i]), panel->largest);
    }
    vmi_legendre_fit(ratios, E, panel->ratio, panel->E);
    return VM_OK;
}

/* Returns 1 if the panel is so short that its series are accurate enough, else 0. If a law has a kink, the series is
   never accurate near the kink, however short the panel is. Therefore a panel also counts as short enough if the terms
   that its series leave out do not matter for the result. `whole` is the length of the whole interval of integration,
   s. */
VM_API int vmi_osc_panel_is_resolved(const vm_osc_plan *p, const vmi_osc_panel *panel, vm_real length, vm_real whole)
{
    const vm_real E_enough = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    const vm_real limit = vmi_panel_limit(length, whole);
    vm_real phase;
    if (!(panel->edge <= vmi_panel_edge_limit(limit))) return 0;
    if (!vmi_panel_is_resolved(panel->inverse, limit)) return 0;
    if (!vmi_panel_is_resolved(panel->ratio, limit)) return 0;
    phase = p->mean.W * panel->ratio[0] * length;
    return vmi_legendre_tail(panel->E) <=
           E_enough * VM_SQRT(vmi_legendre_square(panel->E)) + vmi_panel_E_noise(phase);
}

/* Adds what the panel contributes to mean->change and to mean->third, the bound of the terms of psi that the law of
   order five leaves out. For the integrals of |d^i E_0/dpsi^i| in mean->change, it uses the root mean square over the
   panel in place of the absolute value. Before that, coefficients in the series of E_0 that are as small as rounding
   errors are set to 0, and their integral is added to mean->dropped. The series of E_0 is overwritten. */
VM_API void vmi_osc_add_changes(const vm_osc_plan *p, vmi_osc_panel *panel, vm_real length, vmi_osc_mean *mean)
{
    const vm_real noise = 1024 * VM_EPSILON, W = p->mean.W * panel->ratio[0], phase_length = W * VM_FABS(length);
    const vm_real least = vmi_larger(noise * VM_SQRT(vmi_legendre_square(panel->E)), panel->noise);
    vm_real rate = 1, size[VMI_WALK_ORDERS]; /* rate is (dx/dpsi)^i; x, the variable of the series, goes from -1 to 1 */
    vm_real dropped[VMI_GAUSS];
    int i;
    for (i = 0; i < VMI_GAUSS; i++) {
        dropped[i] = 0;
        if (VM_FABS(panel->E[i]) > least) continue;
        dropped[i] = panel->E[i];
        panel->E[i] = 0;
    }
    mean->dropped += phase_length * VM_SQRT(vmi_legendre_square(dropped));
    for (i = 0; i < VMI_WALK_ORDERS; i++) {
        size[i] = rate * VM_SQRT(vmi_legendre_square(panel->E));
        mean->change[i] += phase_length * size[i];
        vmi_legendre_derive(panel->E);
        rate *= 2 / phase_length;
    }
    mean->third += vmi_expansion_third_rate(&p->ripple, phase_length * size[0] * size[2], panel->cube);
}

/* Advances the mean motion from the start to the end of a panel. */
VM_API void vmi_osc_add_panel(const vm_osc_plan *p, vmi_osc_panel *panel, vm_real length, vmi_osc_mean *mean)
{
    const vm_real W0 = p->mean.W * vmi_exp(p->ripple.gamma * mean->ln_J, 0);
    const vm_real first = vmi_expansion_first(&p->ripple) * panel->first;
    const vm_real second = vmi_expansion_second(&p->ripple) * panel->second;
    mean->inverse_mass += length * panel->inverse[0];
    mean->phase += length * panel->ratio[0];
    mean->psi += W0 * (length * panel->ratio[0]) + (first + second);
    mean->first += first;
    mean->largest = vmi_larger(panel->largest, mean->largest);
    vmi_osc_add_changes(p, panel, length, mean);
}

/* Advances the mean motion from start to end by panels of at most `longest`. No table may have a point between start
   and end. `whole` is the length of the whole interval of integration, s. */
VM_API int vmi_osc_walk_piece(const vm_osc_plan *p, vm_real start, vm_real end, vm_real longest, vm_real whole,
                              vmi_osc_mean *mean)
{
    vmi_panels panels = vmi_panels_from(start, end, longest, whole);
    while (vmi_panels_next(&panels)) {
        const vm_real length = panels.side * panels.step;
        vmi_osc_panel panel;
        int status = vmi_osc_panel_of(p, mean, panels.t, length, &panel);
        if (status) return status;
        if (!vmi_osc_panel_is_resolved(p, &panel, panels.step, whole)) {
            if (vmi_panels_halve(&panels)) continue;
            mean->error += panels.step * vmi_legendre_tail(panel.ratio);
        }
        vmi_osc_add_panel(p, &panel, length, mean);
        if (panels.step < mean->shortest && panels.step < panels.left) mean->shortest = panels.step;
        vmi_panels_advance(&panels);
    }
    return VM_OK;
}

/* Sets the fields `now`, `ln_A` and `ratio` of *mean for the time t. `side` is the direction of the integration along
   the laws: 1 forward, -1 backward in time. Where derivatives of the laws jump at t, the function takes their values
   before t for side = 1, and after t for side = -1. */
VM_API int vmi_osc_mean_update(const vm_osc_plan *p, vm_real t, int side, vmi_osc_mean *mean)
{
    const vm_real sampling = vmi_osc_sampling_time(p), length = t == 0 ? sampling : vmi_smaller(sampling, VM_FABS(t));
    vm_real ln_Om;
    int status = vmi_osc_slow_at(&p->problem, t, -side, length, p->slow.unit, &mean->now);
    if (status) return status;
    vmi_osc_adiabatic(p, vmi_log(mean->now.m / p->m0).hi, vmi_log(mean->now.k / p->k0).hi,
                      p->problem.damping * mean->inverse_mass, &mean->ln_A, &ln_Om);
    mean->ratio = vmi_exp(ln_Om, 0);
    return VM_OK;
}

/* -- Points of tables -- */

/* Adds to the fields knots_J and knots_psi the squares of the terms that the law of order five, cut off after each of
   the orders 2 to 5, leaves out at a point of a table. At this point the numbers E_k jump from `before` to `after`. */
VM_API void vmi_osc_add_knot_error(const vm_osc_plan *p, const vm_real *before, const vm_real *after,
                                   vmi_osc_mean *mean)
{
    vmi_expansion_sizes size;
    vm_real e[VMI_OSC_G];
    int i, order;
    for (i = 0; i < VMI_OSC_G; i++) e[i] = VM_FABS(before[i] - after[i]);
    vmi_expansion_find_sizes(&p->ripple, e, &size);
    for (order = 2; order <= 5; order++) {
        mean->knots_J[order - 2] += size.J[order + 1] * size.J[order + 1];
        mean->knots_psi[order - 2] += size.psi[order] * size.psi[order];
    }
}

/* Continues the mean motion beyond the time t of a table point. At this time the motion itself does not jump, but the
   second derivatives of mass and stiffness do. The step from the motion to the mean motion contains these derivatives;
   therefore the mean motion jumps. The function computes the motion at t from the mean motion before t, and from the
   motion at t the mean motion after t. The action at t is found by iteration with vmi_expansion_J, because the terms of
   vmi_expansion_J go up to the full order, while the terms of vmi_expansion_J_back end one order earlier. */
VM_API int vmi_osc_walk_past_knot(const vm_osc_plan *p, vm_real t, int side, vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vmi_osc_wave wave = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    const int order = p->start_order, rounds = 3;
    vm_real before[VMI_OSC_G], after[VMI_OSC_G], sa, ca, ln_J = 0, to_mean;
    vmi_osc_reduced state;
    vmi_osc_slow beyond;
    vmi_ripple_values f;
    int i, status = vmi_osc_mean_update(p, t, side, mean);
    if (!status) status = vmi_osc_slow_at(&p->problem, t, side, vmi_osc_sampling_time(p), p->slow.unit, &beyond);
    if (status) return status;
    state = vmi_osc_mean_state(p, mean);
    vmi_osc_disturbance(&mean->now, state.W, before);
    vmi_osc_wave_at(&wave, state.psi, &ca, &sa);
    vmi_ripple_at(r, order, state.psi, sa, ca, &f);
    state.psi += vmi_expansion_psi_back(r, order, &f, before);
    vmi_osc_wave_at(&wave, state.psi, &ca, &sa);
    vmi_ripple_at(r, order, state.psi, sa, ca, &f);
    for (i = 0; i < rounds; i++) {
        vmi_osc_disturbance(&mean->now, state.W * vmi_exp(r->gamma * ln_J, 0), before);
        ln_J = -vmi_expansion_J(r, order, &f, before);
    }
    vmi_osc_disturbance(&beyond, state.W * vmi_exp(r->gamma * ln_J, 0), after);
    to_mean = vmi_expansion_J(r, order, &f, after);
    mean->ln_J += ln_J + to_mean;
    mean->psi = state.psi + vmi_expansion_psi(r, order, &f, after);
    mean->now = beyond;
    vmi_osc_add_knot_error(p, before, after, mean);
    return VM_OK;
}

/* -- The walk -- */

/* Sets the mean motion at t = 0 for an integration backward in time. The plan contains the mean motion that follows
   from the derivatives of the laws just after t = 0; *mean becomes the mean motion that follows from their derivatives
   just before t = 0. */
VM_API int vmi_osc_start_backward(const vm_osc_plan *p, vmi_osc_mean *mean)
{
    const vm_osc_problem *o = &p->problem;
    vm_real E[VMI_OSC_G];
    vmi_osc_reduced start;
    int status = vmi_osc_slow_at(o, 0, -1, vmi_osc_sampling_time(p), p->slow.unit, &mean->now);
    if (status) return status;
    start = vmi_osc_reduce(&mean->now, o->alpha, o->x, o->v);
    vmi_osc_disturbance(&mean->now, start.W, E);
    start = vmi_osc_mean_of(p, p->start_order, &start, E);
    mean->ln_J = (o->alpha + 3) / 2 * vmi_log(start.A / p->mean.A).hi;
    mean->psi = start.psi;
    mean->largest = VM_FABS(E[0]);
    return VM_OK;
}

/* Sets *mean to the mean motion at t = 0 with which the way to t begins. Backward in time it differs from the one
   forward in time only where the second derivative of a law jumps at t = 0. */
VM_API int vmi_osc_walk_start(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const int jumps = vmi_law_has_knot(&p->problem.mass, 0) || vmi_law_has_knot(&p->problem.stiffness, 0);
    *mean = vmi_osc_mean_at_0(p);
    if (t < 0 && jumps && vmi_osc_has_phase(p)) return vmi_osc_start_backward(p, mean);
    return VM_OK;
}

/* Integrates along the laws of mass and stiffness from 0 to t, from one point of a table to the next. Afterwards those
   fields of *mean that vmi_osc_mean_update sets are not those at t: they belong to the last point of a table before t,
   or to t = 0. */
VM_API int vmi_osc_walk_along(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_law *mass = &p->problem.mass, *stiffness = &p->problem.stiffness;
    const int side = vmi_time_side(t);
    const vm_real whole = VM_FABS(t);
    const vm_real longest = vmi_smaller(vmi_law_longest_panel(mass, whole), vmi_law_longest_panel(stiffness, whole));
    vm_real at = 0;
    int status = vmi_osc_walk_start(p, t, mean);
    mean->shortest = longest;
    while (!status && at != t) {
        const vm_real next = vmi_osc_next_knot(&p->problem, at, t);
        status = vmi_osc_walk_piece(p, at, next, longest, whole, mean);
        at = next;
        if (!status && at != t) status = vmi_osc_walk_past_knot(p, at, side, mean);
    }
    return status;
}

/* Computes the mean motion at t by integrals along the laws of mass and stiffness. */
VM_API int vmi_osc_walk_to(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    int status = vmi_osc_walk_along(p, t, mean);
    if (!status) status = vmi_osc_mean_update(p, t, vmi_time_side(t), mean);
    return status;
}

#endif
