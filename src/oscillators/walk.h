/* oscillators/walk.h - integrals along the mean motion of an oscillator, where they have no closed form

   The three integrals of vmi_osc_integrals determine the averaged motion from 0 to t. Where the laws of mass and
   stiffness give no closed forms of them, vmi_osc_walk_to sums over the panels of oscillators/panels.h along both laws
   from 0 to t. It also computes what the estimates of the error need: how fast the small parameter epsilon = q/Om
   changes with the mean phase psi, and how the derivatives of tables jump at their points. oscillators/problem.h
   explains q, h and Om.
       vmi_osc_walk w;
       int status = vmi_osc_walk_to(&w, &plan, 10); // plan is a vm_osc_plan; w.integral.phase, w.integral.drift, ...
   Tests: tests/test_averaging.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_WALK_H
#define VARMASS_OSCILLATORS_WALK_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "laws.h"
#include "legendre.h"
#include "panels.h"
#include "problem.h"
#include "waves.h"

/* Number of derivatives of epsilon that the error estimate uses, from the order 0 (epsilon itself) to the order 4 */
enum { VMI_WALK_ORDERS = 5 };

/* The results of a walk along the laws from 0 to t; psi is the mean phase. */
typedef struct VM_TAG(vmi_osc_walk) {
    const vm_osc_plan *plan;
    int side;                        /* 1 forward, -1 backward in time */
    vmi_osc_integrals integral;      /* integrals from 0 to the present time */
    vm_real fourth;                  /* integral of epsilon^4 + (depsilon/dpsi)^2 dpsi */
    vm_real change[VMI_WALK_ORDERS]; /* integral of |d^i epsilon/dpsi^i| dpsi, without jumps at points of tables */
    vm_real ln_A;                    /* sum of the changes of ln(mean amplitude) by jumps of q' */
    vm_real kicks;                   /* sum of the absolute values of these changes */
    vm_real kick2, kick3;            /* sums of squares of the jumps of h/Om^2, and of (q h + h')/Om^3 */
    vm_real shortest;                /* length of the shortest panel so far, s */
    vm_real error;                   /* estimated error of integral.phase, s */
} vmi_osc_walk;

/* A panel of the walk: three series on it, and its contributions to two integrals */
typedef struct VM_TAG(vmi_osc_panel) {
    vm_real edge;               /* largest relative error of the series of 1/m and of k at the panel's ends */
    vm_real inverse[VMI_GAUSS]; /* series of 1/m */
    vm_real ratio[VMI_GAUSS];   /* at first series of k, then series of Om/Om0, where Om0 is Om at t = 0 */
    vm_real epsilon[VMI_GAUSS]; /* series of epsilon = q/Om */
    vm_real drift;              /* integral of q^2 Om0/Om dt over the panel */
    vm_real fourth;             /* integral of epsilon^4 dpsi over the panel, where psi is the mean phase */
} vmi_osc_panel;

/* Om/Om0, where mass and stiffness are m and k, and inverse_mass is the integral of dt/m */
VM_API vm_real vmi_osc_walk_ratio(const vmi_osc_walk *w, vm_real m, vm_real k, vm_real inverse_mass)
{
    const vm_osc_plan *p = w->plan;
    vm_real ln_A, ln_Om;
    vmi_osc_adiabatic(p, vmi_log(m / p->m0).hi, vmi_log(k / p->k0).hi, p->problem.damping * inverse_mass, &ln_A,
                      &ln_Om);
    return vmi_exp(ln_Om + (p->problem.alpha - 1) / 2 * w->ln_A, 0);
}

/* Computes the rates r at the points of Gauss' rule, the series of 1/m and of k, and their relative errors at the
   panel's ends */
VM_API int vmi_osc_panel_laws(const vmi_osc_walk *w, vm_real start, vm_real length, vmi_osc_rates *r,
                              vmi_osc_panel *panel)
{
    const vm_osc_problem *o = &w->plan->problem;
    vm_real inverse[VMI_GAUSS], stiffness[VMI_GAUSS];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        status = vmi_osc_rates_at(w->plan, t, w->side, 0, &r[i]);
        if (status) return status;
        inverse[i] = 1 / r[i].m;
        stiffness[i] = r[i].k;
    }
    vmi_legendre_fit(inverse, stiffness, panel->inverse, panel->ratio);
    panel->edge = 0;
    status = vmi_panel_edge(&o->mass, VM_BAD_MASS, 1, start, length, panel->inverse, &panel->edge);
    if (status) return status;
    return vmi_panel_edge(&o->stiffness, VM_BAD_STIFFNESS, 0, start, length, panel->ratio, &panel->edge);
}

/* Computes the panel of a length from start on; the length is negative backward in time. */
VM_API int vmi_osc_panel_of(const vmi_osc_walk *w, vm_real start, vm_real length, vmi_osc_panel *panel)
{
    const vm_osc_plan *p = w->plan;
    const int damped = p->problem.damping != 0;
    vmi_osc_rates r[VMI_GAUSS];
    vm_real ratios[VMI_GAUSS], epsilons[VMI_GAUSS];
    int i, status = vmi_osc_panel_laws(w, start, length, r, panel);
    if (status) return status;
    panel->drift = 0;
    panel->fourth = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real way = damped ? length / 2 * vmi_legendre_integral(panel->inverse, vmi_gauss_node(i)) : 0;
        const vm_real ratio = vmi_osc_walk_ratio(w, r[i].m, r[i].k, w->integral.inverse_mass + way);
        const vm_real share = vmi_gauss_weight(i) / 2 * length, drift = r[i].q * r[i].q / ratio;
        const vm_real epsilon = r[i].q / (p->Om * ratio);
        panel->drift += share * drift;
        panel->fourth += VM_FABS(share * drift) * epsilon * epsilon / p->Om;
        ratios[i] = ratio;
        epsilons[i] = epsilon;
    }
    vmi_legendre_fit(ratios, epsilons, panel->ratio, panel->epsilon);
    return VM_OK;
}

/* Whether the panel is short enough for its series. The series of epsilon may be less accurate than the series of the
   laws. If a law has a kink, no panel is short enough, and halving ends where the part that is left out no longer
   matters. whole is the walk's length, s. */
VM_API int vmi_osc_panel_is_resolved(const vmi_osc_walk *w, const vmi_osc_panel *panel, vm_real length, vm_real whole)
{
    const vm_real epsilon_enough = VM_C(1e-3), phase_matters = 16 * VM_EPSILON;
    const vm_real limit = vmi_panel_limit(length, whole);
    vm_real phase;
    if (!(panel->edge <= vmi_panel_edge_limit(limit))) return 0;
    if (!vmi_panel_is_resolved(panel->inverse, limit)) return 0;
    if (!vmi_panel_is_resolved(panel->ratio, limit)) return 0;
    phase = w->plan->Om * panel->ratio[0] * VM_FABS(length);
    return vmi_legendre_tail(panel->epsilon) <=
           epsilon_enough * VM_SQRT(vmi_legendre_square(panel->epsilon)) + phase_matters / phase;
}

/* Adds the panel's integrals of |d^i epsilon/dpsi^i|, each taken as the root of the mean square times the length.
   Coefficients of epsilon that are mere rounding errors are set to 0 first. The function destroys the series of
   epsilon. */
VM_API void vmi_osc_walk_add_changes(vmi_osc_walk *w, vmi_osc_panel *panel, vm_real length)
{
    const vm_real noise = 1024 * VM_EPSILON, size = VM_FABS(length), Om = w->plan->Om * panel->ratio[0];
    const vm_real least = noise * VM_SQRT(vmi_legendre_square(panel->epsilon));
    vm_real rate = 1; /* (dx/dpsi)^i, where x runs over [-1, 1] on the panel */
    int i;
    for (i = 0; i < VMI_GAUSS; i++)
        if (VM_FABS(panel->epsilon[i]) <= least) panel->epsilon[i] = 0;
    for (i = 0; i < VMI_WALK_ORDERS; i++) {
        const vm_real square = vmi_legendre_square(panel->epsilon) * rate * rate;
        w->change[i] += Om * size * VM_SQRT(square);
        if (i == 1) w->fourth += Om * size * square;
        vmi_legendre_derive(panel->epsilon);
        rate *= 2 / (size * Om);
    }
}

/* Adds the panel's contributions to all results of the walk */
VM_API void vmi_osc_walk_add(vmi_osc_walk *w, vmi_osc_panel *panel, vm_real length)
{
    w->integral.inverse_mass += length * panel->inverse[0];
    w->integral.phase += length * panel->ratio[0];
    w->integral.drift += panel->drift;
    vmi_osc_walk_add_changes(w, panel, length);
    w->fourth += panel->fourth;
}

/* Passes the point t of a table, where q' jumps. The motion itself does not jump, so it continues with another mean
   amplitude. This holds for small jumps only; a larger jump changes only the error estimate. */
VM_API int vmi_osc_walk_past_knot(vmi_osc_walk *w, vm_real t)
{
    const vm_osc_plan *p = w->plan;
    const vm_real n = p->problem.alpha + 1, largest = VM_C(0.5);
    const vmi_osc_wave wave = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vmi_osc_rates before, after;
    vm_real ca, sa, jump, third, kick, Om; /* jump of h/Om^2, of (q h + h')/Om^3, of ln A */
    int status = vmi_osc_rates_at(p, t, -w->side, 1, &before);
    if (!status) status = vmi_osc_rates_at(p, t, w->side, 1, &after);
    if (status || before.h == after.h) return status;
    Om = p->Om * vmi_osc_walk_ratio(w, after.m, after.k, w->integral.inverse_mass);
    jump = (before.h - after.h) / (Om * Om);
    if (VM_FABS(jump) < largest) {
        const vm_real slope = after.q * n / (2 * (n + 2) * Om);
        vmi_osc_phase_from_mean(p, &wave, vmi_osc_mean_phase(p, &w->integral), slope, &ca, &sa);
        kick = n / (4 * (n + 2)) * (ca * ca - p->mean_ca2) * jump;
        w->ln_A += kick;
        w->kicks += VM_FABS(kick);
    }
    w->kick2 += jump * jump;
    third = jump * jump + (VM_FABS(jump * after.q) + VM_FABS(before.h_rate - after.h_rate) / (Om * Om)) / Om;
    w->kick3 += third * third;
    return VM_OK;
}

/* Walks from start to end by panels of at most `longest`; a table must have no point between them. `whole` is the
   length of the walk. */
VM_API int vmi_osc_walk_piece(vmi_osc_walk *w, vm_real start, vm_real end, vm_real longest, vm_real whole)
{
    vmi_panels p = vmi_panels_from(start, end, longest, whole);
    while (vmi_panels_next(&p)) {
        const vm_real length = p.side * p.step;
        vmi_osc_panel panel;
        int status = vmi_osc_panel_of(w, p.t, length, &panel);
        if (status) return status;
        if (!vmi_osc_panel_is_resolved(w, &panel, p.step, whole)) {
            if (vmi_panels_halve(&p)) continue;
            w->error += p.step * vmi_legendre_tail(panel.ratio);
        }
        vmi_osc_walk_add(w, &panel, length);
        if (p.step < w->shortest && p.step < p.left) w->shortest = p.step;
        vmi_panels_advance(&p);
    }
    return VM_OK;
}

/* Begins a walk at t = 0 for the plan p, forward in time for side = 1 and backward for side = -1 */
VM_API void vmi_osc_walk_start(vmi_osc_walk *w, const vm_osc_plan *p, int side, vm_real longest)
{
    int i;
    w->plan = p;
    w->side = side;
    w->integral.inverse_mass = 0;
    w->integral.phase = 0;
    w->integral.drift = 0;
    w->fourth = 0;
    for (i = 0; i < VMI_WALK_ORDERS; i++) w->change[i] = 0;
    w->ln_A = 0;
    w->kicks = 0;
    w->kick2 = 0;
    w->kick3 = 0;
    w->shortest = longest;
    w->error = 0;
}

/* Walks along both laws of the plan from 0 to t, from one point of a table to the next. */
VM_API int vmi_osc_walk_to(vmi_osc_walk *w, const vm_osc_plan *p, vm_real t)
{
    const vm_law *mass = &p->problem.mass, *stiffness = &p->problem.stiffness;
    const vm_real whole = VM_FABS(t), other = vmi_law_longest_panel(stiffness, whole);
    vm_real at = 0, longest = vmi_law_longest_panel(mass, whole);
    int status = VM_OK;
    if (other < longest) longest = other;
    vmi_osc_walk_start(w, p, vmi_time_side(t), longest);
    if (w->side < 0) status = vmi_osc_walk_past_knot(w, 0); /* the plan has the rates after t = 0 */
    while (!status && at != t) {
        const vm_real next = vmi_law_next_knot(stiffness, at, vmi_law_next_knot(mass, at, t));
        status = vmi_osc_walk_piece(w, at, next, longest, whole);
        at = next;
        if (!status && at != t) status = vmi_osc_walk_past_knot(w, at);
    }
    return status;
}

#endif
