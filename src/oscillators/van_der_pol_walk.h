/* oscillators/van_der_pol_walk.h - the mean motion of a Van der Pol oscillator with slowly varying mass and stiffness

   The transformation of oscillators/van_der_pol_expansion.h, from the motion to the mean motion, has the full order
   three only at phases where sa or ca is 0. The plan therefore integrates the exact equations (by collocation) from t =
   0 to the next such phase, and starts the mean motion there. The mean amplitude and the mean phase at any other time
   are integrals along the laws of mass and stiffness, so the cost does not depend on the number of vibrations. The laws
   are integrated on panels, which are short intervals of time (oscillators/panels.h). On a panel that starts with the
   mean amplitude A_0 and the mean phase psi_0, let B = c/m and r = exp(-2 integral of p dt from the start of the
   panel). Here m is the mass and p the slow rate of oscillators/reduction.h. Then the mean amplitude A and the mean
   phase psi are
     A^2 = A_0^2 r/y,  y = 1 + 4/(alpha+3) A_0^2 integral of B r (-F - second order terms) dt,
     psi = psi_0 + integral of W (1 + second order terms) dt,
   where W is the rate of the phase, and the constant F and the terms of second order are those of
   oscillators/van_der_pol_expansion.h. At the points of a table p' jumps. Since E0 in the transformation contains p',
   the mean motion jumps, too. Around such a point the exact equations are integrated: from the last phase with sa = 0
   or ca = 0 before the point to the first such phase after the point.
       vm_vdp_plan plan;
       vmi_vdp_mean mean;
       int status = vm_vdp_plan_init(&plan, &vdp, VM_C(0.3), 0); // vdp is a vm_vdp; from rest at x = 0.3 m
       if (!status) status = vmi_vdp_mean_at(&plan, 100, &mean); // mean.ln_A, mean.psi
   Tests: tests/test_van_der_pol_law.c. */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_WALK_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_WALK_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "averaging.h"
#include "collocation.h"
#include "laws.h"
#include "legendre.h"
#include "panels.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"
#include "van_der_pol.h"
#include "van_der_pol_expansion.h"
#include "walk.h"
#include "waves.h"

/* The mean motion at one time, and the numbers on which its error depends. J is the quantity of
   oscillators/van_der_pol_expansion.h */
typedef struct VM_TAG(vmi_vdp_mean) {
    vm_real t;                    /* the time, s */
    vm_real ln_A, psi;            /* ln of the mean amplitude in metres, and mean phase */
    vm_real first_ln_A, first_psi; /* ln of the mean amplitude, and mean phase, by the equations of first order */
    vm_real segment;              /* time, s, of the last point of a table before t, or 0; between this time and t the
                                     laws are smooth */
    vmi_osc_slow now;             /* mass, stiffness and rates at t; valid only at the end of a walk, the integration
                                     along the laws */
    vm_real J_error;              /* error of ln J at t, caused by the terms that order two leaves out where the mean
                                     motion is started; such an error grows or decays with time */
    vm_real psi_error;            /* size of the terms of psi that order two leaves out */
    vm_real J_third, psi_third;   /* sizes of those terms of ln J and of psi that order three leaves out and that do not
                                     depend on c */
    vm_real ratio;                /* where the mean motion was started, the largest value of (terms of one order)/(terms
                                     of the next lower order) */
    vmi_osc_mean fast;            /* its fields change, dropped, shortest and error describe fast changes of mass and
                                     stiffness; its other fields are not used */
} vmi_vdp_mean;

/* A plan: numbers that vm_vdp_plan_init computes once for a Van der Pol oscillator and its state at t = 0. Read the
   fields of the plan, but do not change them. The plan contains pointers to the tables of the laws, to the user's
   functions and to their ctx. */
typedef struct VM_TAG(vm_vdp_plan) {
    vm_vdp vdp;            /* a copy of the oscillator */
    vm_osc_plan osc;       /* plan of the oscillator without its term -c x^2 x'; the feed is a negative damping */
    vmi_vdp_ripple ripple; /* constants and polynomials of the law of order three */
    int start_status;      /* VM_OK if `start` is set; else the status that says why the mean motion cannot be started
                              forward in time, VM_NO_LAW for a body at rest */
    vmi_vdp_mean start;    /* the start of the mean motion forward in time; if start_status is not VM_OK, only its field
                              psi may be used, the phase at t = 0, and not even this for a body at rest */
} vm_vdp_plan;

/* The force -c x^2 x', N, of the Van der Pol oscillator; ctx points to c. */
VM_API vm_real vmi_vdp_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_real *c = (const vm_real *)ctx;
    (void)t;
    return -*c * x * x * v;
}

/* -- The disturbances -- */

/* The rate of the Ateb phase, 1/s, at the amplitude exp(ln_A) */
VM_API vm_real vmi_vdp_rate(const vm_vdp_plan *p, vm_real mass, vm_real k, vm_real ln_A)
{
    const vm_real alpha = p->vdp.alpha;
    return VM_SQRT((alpha + 1) / 2 * k / mass) * vmi_exp((alpha - 1) / 2 * ln_A, 0);
}

/* Returns nu = -m'/m - 4 p + a, 1/s, from the rates a and p of oscillators/reduction.h and from k'/k. The relative rate
   m'/m of the mass follows from p = (k'/k + 2 a - m'/m)/(alpha+3). */
VM_API vm_real vmi_vdp_nu(const vm_vdp_plan *p, vm_real rate_a, vm_real rate_p, vm_real k_rate)
{
    return (p->vdp.alpha - 1) * rate_p - rate_a - k_rate;
}

/* Returns the disturbances e, e1, Q0 and E0 of oscillators/van_der_pol_expansion.h. The disturbances follow from the
   mass, from nu (see vmi_vdp_nu), from the rate p, from G0 = p^2 - a p - p', and from the amplitude exp(ln_A). W is the
   rate of the phase at this amplitude. */
VM_API vmi_vdp_disturbance vmi_vdp_disturbance_of(const vm_vdp_plan *p, vm_real mass, vm_real nu, vm_real rate_p,
                                                  vm_real G0, vm_real ln_A, vm_real W)
{
    vmi_vdp_disturbance d;
    d.e = p->vdp.c / mass * vmi_exp(2 * ln_A, 0) / W;
    d.e1 = d.e * nu / W;
    d.Q0 = d.e * rate_p / W;
    d.E0 = G0 / W / W;
    return d;
}

/* Returns the disturbances e, e1, Q0 and E0 for the mass and the rates in *now, and for the amplitude exp(ln_A), at
   which the phase has the rate W. */
VM_API vmi_vdp_disturbance vmi_vdp_disturbance_at(const vm_vdp_plan *p, const vmi_osc_slow *now, vm_real ln_A,
                                                  vm_real W)
{
    const vm_real G0 = now->G[0] / now->unit / now->unit, nu = vmi_vdp_nu(p, now->a, now->p, now->k_rate);
    return vmi_vdp_disturbance_of(p, now->m, nu, now->p, G0, ln_A, W);
}

/* Returns the sizes of terms that estimates of the error need (vmi_vdp_sizes), for the mass and the rates in *now, and
   for the amplitude exp(ln_A), at which the phase has the rate W. */
VM_API vmi_vdp_sizes vmi_vdp_sizes_at(const vm_vdp_plan *p, const vmi_osc_slow *now, vm_real ln_A, vm_real W)
{
    const vmi_vdp_disturbance d = vmi_vdp_disturbance_at(p, now, ln_A, W);
    const vm_real rate = (VM_FABS(vmi_vdp_nu(p, now->a, now->p, now->k_rate)) + VM_FABS(now->p) +
                          VM_FABS(now->a)) /
                         W;
    return vmi_vdp_sizes_of(&p->osc.ripple, &d, rate, now->bend / W / W);
}

/* Writes the absolute values of the numbers E_k = G_k/W^(k+2) of oscillators/expansion.h, for the oscillator without
   the force -c x^2 x'. W is the rate of the phase. */
VM_API void vmi_vdp_absolute_E(const vmi_osc_slow *now, vm_real W, vm_real *E)
{
    int i;
    vmi_osc_disturbance(now, W, E);
    for (i = 0; i < VMI_OSC_G; i++) E[i] = VM_FABS(E[i]);
}

/* -- The start -- */

/* Starts the mean motion from the reduced state *r, at whose phase sa or ca must be 0. mean->t and mean->now must
   already be set for the time of this state. The errors that the start causes are added to the errors in *mean. */
VM_API void vmi_vdp_start_at(const vm_vdp_plan *p, const vmi_osc_reduced *r, vmi_vdp_mean *mean)
{
    const vmi_osc_wave wave = vmi_osc_wave_of(&p->osc, VM_ROUTE_ATEB);
    const vm_real ln_A = vmi_log(r->A).hi;
    const vmi_vdp_disturbance now = vmi_vdp_disturbance_at(p, &mean->now, ln_A, r->W);
    const vmi_vdp_sizes sizes = vmi_vdp_sizes_at(p, &mean->now, ln_A, r->W);
    vmi_vdp_values f;
    vmi_expansion_sizes terms;
    vm_real E[VMI_OSC_G], sa, ca;
    vmi_osc_wave_at(&wave, r->psi, &ca, &sa);
    vmi_vdp_values_at(&p->ripple, &p->osc.ripple, r->psi, sa, ca, &f);
    vmi_vdp_absolute_E(&mean->now, r->W, E);
    mean->ln_A = ln_A + 2 / (p->vdp.alpha + 3) * vmi_vdp_J(&p->ripple, &p->osc.ripple, &f, &now);
    mean->psi = r->psi + vmi_vdp_psi(&f, &now);
    mean->first_ln_A = mean->ln_A;
    mean->first_psi = mean->psi;
    mean->J_error += sizes.start;
    mean->psi_error += sizes.psi;
    vmi_expansion_find_sizes(&p->osc.ripple, E, &terms);
    mean->J_third += terms.J[4] + sizes.third;
    mean->psi_third += terms.psi[3] + sizes.third;
    mean->ratio = vmi_larger(sizes.ratio, mean->ratio);
}

/* Finds the longest step, s, of the integration of vmi_vdp_bridge, which starts at the time t, where the rate of the
   phase is W. No step may miss a change of a law that is a function of the user (vmi_osc_law_step). Returns
   VM_NOT_INTEGRATED if a step might miss a change of another law (vmi_osc_check_steps). */
VM_API int vmi_vdp_longest_step(const vm_vdp_plan *p, vm_real t, int side, vm_real W, vm_real *longest)
{
    const vm_real quarter = (vm_real)side * p->osc.ripple.pi / (2 * W); /* the time of a quarter vibration */
    const vm_law *laws[2];
    int i, status;
    *longest = VM_INFINITY;
    if (t == 0) {
        status = vmi_osc_check_steps(&p->osc, quarter);
        if (status || !vmi_osc_has_user_law(&p->osc.problem)) return status;
        return vmi_osc_law_step(&p->osc, quarter, longest);
    }
    laws[0] = &p->osc.problem.mass;
    laws[1] = &p->osc.problem.stiffness;
    for (i = 0; i < 2; i++)
        if (laws[i]->function && laws[i]->change_time > 0) *longest = vmi_smaller(*longest, laws[i]->change_time);
    return VM_OK;
}

/* Integrates the exact equations from the state *r at the time t to the first phase at which sa or ca is 0, and starts
   the mean motion there. If `knots` is 1, the function integrates to the first phase of this kind after the next point
   of a table. `side` is 1 forward, -1 backward in time. VM_NOT_INTEGRATED means that amplitude and phase do not
   describe the motion, or that a further table point lies before the end of this integration. */
VM_API int vmi_vdp_bridge(const vm_vdp_plan *p, vm_real t, int side, const vmi_osc_reduced *r, int knots,
                          vmi_vdp_mean *mean)
{
    const int nodes = 14, most_steps = 16384;
    vm_osc_plan exact = p->osc;
    vm_real c = p->vdp.c;
    vmi_osc_course course;
    vmi_osc_reduced end;
    vmi_osc_rates rates;
    vm_real sign, longest;
    int i, part, landed = 0, status = vmi_vdp_longest_step(p, t, side, r->W, &longest);
    if (status) return status;
    exact.problem.force = vmi_vdp_force;
    exact.problem.ctx = &c;
    vmi_osc_course_start(&course, &exact, r, side, nodes, 2, 16 * VM_EPSILON);
    course.by_velocity = 0; /* the force is smooth, and the mean motion starts from x and x' + p x */
    course.t = t;
    course.longest = longest;
    for (i = 0; i < most_steps; i++) {
        course.stop = vmi_osc_next_knot(&exact.problem, course.t, VM_COPYSIGN(VM_INFINITY, (vm_real)side));
        status = vmi_osc_course_step(&course);
        if (status) return status;
        vmi_osc_next_phase(&course, &part, &sign);
        if (course.t == course.stop) landed++;
        else if (landed >= knots && part >= 0) break;
        if (landed > knots) return VM_NOT_INTEGRATED;
    }
    if (i == most_steps) return VM_NOT_INTEGRATED;
    status = vmi_osc_rates_at(&exact.problem, course.t, side, &rates);
    if (!status)
        status = vmi_osc_slow_at(&exact.problem, course.t, side, vmi_osc_sampling_time(&p->osc), 1 / p->osc.Om,
                                 &mean->now);
    if (status) return status;
    end.psi = course.psi;
    end.A = exact.A * vmi_exp(course.ln_A, 0);
    end.W = exact.Om * vmi_osc_Om_ratio(&exact, &rates, course.ln_A);
    mean->t = course.t;
    mean->segment = knots ? mean->segment : t;
    vmi_vdp_start_at(p, &end, mean);
    return VM_OK;
}

/* Starts the mean motion from position and velocity at t = 0. With side = 1 the mean motion is for times t > 0, with
   side = -1 for times t < 0. */
VM_API int vmi_vdp_start(const vm_vdp_plan *p, int side, vmi_vdp_mean *mean)
{
    const vm_osc_problem *o = &p->osc.problem;
    const vm_real quarter = p->osc.ripple.pi / 2;
    vmi_osc_reduced r;
    vm_real from_multiple;
    int i, status;
    if (!vmi_osc_has_phase(&p->osc)) return VM_NO_LAW;
    status = vmi_osc_slow_at(o, 0, side, vmi_osc_sampling_time(&p->osc), 1 / p->osc.Om, &mean->now);
    if (status) return status;
    mean->t = 0;
    mean->segment = 0;
    mean->J_error = 0;
    mean->psi_error = 0;
    mean->J_third = 0;
    mean->psi_third = 0;
    mean->ratio = 0;
    mean->fast = vmi_osc_mean_at_0(&p->osc);
    for (i = 0; i < VMI_WALK_ORDERS; i++) mean->fast.change[i] = 0;
    r = vmi_osc_reduce(&mean->now, o->alpha, o->x, o->v);
    if (!(r.A > 0) || !VM_IS_FINITE(r.A)) return VM_NOT_FINITE;
    from_multiple = r.psi - quarter * VM_FLOOR(r.psi / quarter + VM_C(0.5));
    if (VM_FABS(from_multiple) > 64 * VM_EPSILON * quarter) return vmi_vdp_bridge(p, 0, side, &r, 0, mean);
    vmi_vdp_start_at(p, &r, mean);
    return VM_OK;
}

/* Prepares a plan, by which the motion of a Van der Pol oscillator is computed at many times.
   x is the position, m, and x_rate the velocity, m/s, at t = 0. vm_vdp_plan_by_route and vm_vdp_plan_within use the
   plan. The field `method` of *v must be valid, but the results do not depend on `method`, a1, a2 and a3. The
   oscillator is copied; the tables of its laws and what ctx points to must exist as long as the plan is used. Errors
   leave the plan untouched. Returns VM_BAD_ARGUMENT for null pointers, an unknown method, and a mass that no
   constructor made, VM_NOT_FINITE for numbers that are infinite or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a
   stiffness that is not positive at t = 0 or in a table, and VM_DOMAIN for alpha < 0, for a table whose times do not
   rise or do not contain t = 0, and where a user's function fails. */
VM_API int vm_vdp_plan_init(vm_vdp_plan *p, const vm_vdp *v, vm_real x, vm_real x_rate)
{
    vm_vdp_plan plan;
    vm_osc_problem o;
    int status;
    if (!p || !v || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    o.alpha = v->alpha;
    o.mass = v->mass;
    o.stiffness = vmi_vdp_stiffness(v);
    o.reactive = v->reactive;
    o.damping = -v->feed;
    o.x = x;
    o.v = x_rate;
    o.force = NULL;
    o.ctx = NULL;
    plan.vdp = *v;
    status = vmi_vdp_check(v);
    status = vmi_first_error(status, vm_osc_plan_init(&plan.osc, &o));
    if (status) return status;
    plan.start_status = VM_NO_LAW;
    if (plan.osc.A > 0) {
        vmi_vdp_ripple_init(&plan.ripple, &plan.osc.ripple);
        plan.start.psi = plan.osc.psi;
        plan.start_status = vmi_vdp_start(&plan, 1, &plan.start);
    }
    *p = plan;
    return VM_OK;
}

/* -- A panel -- */

/* Legendre series and integrals of the mean motion on a panel, a short interval of time. J is the quantity of
   oscillators/van_der_pol_expansion.h */
typedef struct VM_TAG(vmi_vdp_panel) {
    vmi_osc_panel laws;                   /* the laws of mass and stiffness; its fields E and noise are used to find
                                             fast changes of the laws */
    vm_real r[VMI_GAUSS];                 /* series of r/m with r = exp(-2 integral of p dt) from the panel's start */
    vm_real rate[VMI_GAUSS], first_rate[VMI_GAUSS]; /* series of the rate of the mean phase: `rate` by the law of order
                                                       three, first_rate by the law of order one */
    vm_real ln_A, first_ln_A;             /* change of ln A over the panel, where A is the mean amplitude: ln_A by the
                                             law of order three, first_ln_A by that of order one */
    vm_real loss;                         /* the factor by which an error of ln J changes from the start to the end of
                                             the panel */
    vm_real rounding;                     /* size of the errors of E_0 that rounding errors of the rate p cause
                                             (vmi_vdp_rounding) */
    vm_real kept;                         /* the integral, over the phases of the panel, of the factor by which an error
                                             of ln J changes from the start of the panel to the phase */
} vmi_vdp_panel;

/* Numbers of the mean motion at the nodes, which are the points of Gauss' rule on a panel */
typedef struct VM_TAG(vmi_vdp_nodes) {
    vm_real r[VMI_GAUSS], ln_r[VMI_GAUSS];      /* r/m with the r of vmi_vdp_panel, and ln r */
    vm_real first_ln_A[VMI_GAUSS], first_rate[VMI_GAUSS];
    vm_real G0[VMI_GAUSS], E[VMI_GAUSS];        /* G_0 = p^2 - a p - p', and E_0 = G_0/W^2 */
    vm_real second[VMI_GAUSS];                  /* r/m times the result of vmi_vdp_mean_second */
    vm_real rate[VMI_GAUSS];
} vmi_vdp_nodes;

/* Returns ln r, where r = exp(-2 integral of p dt) with the rate p of oscillators/reduction.h, for an interval of time
   in which mass and stiffness change by the factors exp(ln_m) and exp(ln_k). `way` is the integral of dt/m over this
   interval. */
VM_API vm_real vmi_vdp_ln_r(const vm_vdp_plan *p, vm_real ln_m, vm_real ln_k, vm_real way)
{
    vm_real ln_A, ln_Om;
    vmi_osc_adiabatic(&p->osc, ln_m, ln_k, p->osc.problem.damping * way, &ln_A, &ln_Om);
    return 2 * ln_A;
}

/* ln(k/k_start); for a constant stiffness, which is the usual case, no logarithm is computed */
VM_API vm_real vmi_vdp_ln_k(vm_real k, vm_real k_start)
{
    if (k == k_start) return 0;
    return vmi_log(k / k_start).hi;
}

/* The size of the rounding errors in the last terms of the Legendre series of E_0. *now contains the rates of the laws,
   and W is the rate of the phase. E_0 contains p'/W^2, where p is a slow rate, and p' is the derivative of a series of
   p on the panel. The rounding errors of p are at most a few eps (|a| + |p|). In the last terms of p' they are larger
   by a factor of up to 250/length; on short panels they are larger than the terms themselves. */
VM_API vm_real vmi_vdp_rounding(const vmi_osc_rates *now, vm_real W, vm_real length)
{
    return 256 * VM_EPSILON / VM_FABS(length) / W * ((VM_FABS(now->p) + VM_FABS(now->a)) / W);
}

/* Computes the mean motion of first order at the nodes of a panel, and from this motion the terms of second order.
   *mean is the mean motion, and *start contains mass and stiffness, at the start of the panel. */
VM_API void vmi_vdp_first_order(const vm_vdp_plan *p, const vmi_vdp_mean *mean, vm_real length,
                                const vmi_osc_rates *start, const vmi_osc_panel_laws *at, vmi_vdp_nodes *nodes,
                                vmi_vdp_panel *panel)
{
    const vm_real gain = -4 / (p->vdp.alpha + 3) * p->ripple.F * p->vdp.c * vmi_exp(2 * mean->first_ln_A, 0);
    vm_real unused[VMI_GAUSS];
    int i;
    panel->laws.noise = 0;
    panel->rounding = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vmi_osc_rates *now = &at->rates[i];
        const vm_real way = length / 2 * vmi_legendre_integral(panel->laws.inverse, vmi_gauss_node(i));
        const vm_real ln_k = vmi_vdp_ln_k(now->k, start->k);
        nodes->ln_r[i] = vmi_vdp_ln_r(p, vmi_log(now->m / start->m).hi, ln_k, way);
        nodes->r[i] = vmi_exp(nodes->ln_r[i], 0) / now->m;
        nodes->G0[i] = now->p * (now->p - now->a) - at->p_rate[i];
    }
    vmi_legendre_fit(nodes->r, nodes->r, panel->r, unused);
    for (i = 0; i < VMI_GAUSS; i++) {
        const vmi_osc_rates *now = &at->rates[i];
        const vm_real y = 1 + gain * (length / 2) * vmi_legendre_integral(panel->r, vmi_gauss_node(i));
        const vm_real ln_A = mean->first_ln_A + (nodes->ln_r[i] - vmi_log(y).hi) / 2;
        const vm_real W = vmi_vdp_rate(p, now->m, now->k, ln_A), nu = vmi_vdp_nu(p, now->a, now->p, now->k_rate);
        const vm_real p_noise = vmi_osc_rate_noise() / VM_FABS(length);
        vmi_vdp_disturbance d = vmi_vdp_disturbance_of(p, now->m, nu, now->p, nodes->G0[i], ln_A, W);
        nodes->first_ln_A[i] = ln_A;
        nodes->first_rate[i] = y > 0 ? W : VM_NAN;
        nodes->second[i] = nodes->r[i] * vmi_vdp_mean_second(&p->ripple, &d);
        nodes->E[i] = d.E0;
        panel->rounding = vmi_larger(vmi_vdp_rounding(now, W, length), panel->rounding);
        panel->laws.noise = vmi_larger(p_noise / W * ((VM_FABS(now->p) + VM_FABS(now->a)) / W), panel->laws.noise);
    }
    panel->first_ln_A = 1 + gain * length * panel->r[0]; /* y at the end of the panel */
}

/* Computes the mean motion of order three at the nodes of a panel. `second` is the Legendre series of nodes->second. */
VM_API void vmi_vdp_second_order(const vm_vdp_plan *p, const vmi_vdp_mean *mean, vm_real length,
                                 const vmi_osc_panel_laws *at, const vm_real *second, vmi_vdp_nodes *nodes,
                                 vmi_vdp_panel *panel)
{
    const vm_real gain = -4 / (p->vdp.alpha + 3) * p->vdp.c * vmi_exp(2 * mean->ln_A, 0);
    int i;
    panel->kept = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vmi_osc_rates *now = &at->rates[i];
        const vm_real node = vmi_gauss_node(i);
        const vm_real sum = p->ripple.F * vmi_legendre_integral(panel->r, node) + vmi_legendre_integral(second, node);
        const vm_real y = 1 + gain * (length / 2) * sum;
        const vm_real ln_A = mean->ln_A + (nodes->ln_r[i] - vmi_log(y).hi) / 2;
        const vm_real W = vmi_vdp_rate(p, now->m, now->k, ln_A), nu = vmi_vdp_nu(p, now->a, now->p, now->k_rate);
        const vmi_vdp_disturbance d = vmi_vdp_disturbance_of(p, now->m, nu, now->p, nodes->G0[i], ln_A, W);
        nodes->rate[i] = y > 0 ? W * vmi_vdp_mean_rate(&p->ripple, &p->osc.ripple, &d) : VM_NAN;
        panel->kept += vmi_gauss_weight(i) / 2 * VM_FABS(length) * W / y;
    }
    panel->loss = 1 / (1 + gain * length * (p->ripple.F * panel->r[0] + second[0]));
}

/* Computes the panel from mean->t to mean->t + length; length is negative backward in time. */
VM_API int vmi_vdp_panel_of(const vm_vdp_plan *p, const vmi_vdp_mean *mean, vm_real length, vmi_vdp_panel *panel)
{
    const vm_osc_problem *o = &p->osc.problem;
    const int side = vmi_time_side(length);
    vmi_osc_panel_laws at;
    vmi_vdp_nodes nodes;
    vmi_osc_rates start, end;
    vm_real second[VMI_GAUSS], ln_r;
    int status = vmi_osc_rates_at(o, mean->t, side, &start);
    if (!status) status = vmi_osc_rates_at(o, mean->t + length, -side, &end);
    if (!status) status = vmi_osc_read_laws(o, side, mean->t, length, &at, &panel->laws);
    if (status) return status;
    vmi_vdp_first_order(p, mean, length, &start, &at, &nodes, panel);
    vmi_legendre_fit(nodes.second, nodes.E, second, panel->laws.E);
    vmi_vdp_second_order(p, mean, length, &at, second, &nodes, panel);
    vmi_legendre_fit(nodes.rate, nodes.first_rate, panel->rate, panel->first_rate);
    ln_r = vmi_vdp_ln_r(p, vmi_log(end.m / start.m).hi, vmi_vdp_ln_k(end.k, start.k),
                        length * panel->laws.inverse[0]);
    panel->first_ln_A = (ln_r - vmi_log(panel->first_ln_A).hi) / 2;
    panel->ln_A = (ln_r + vmi_log(panel->loss).hi) / 2;
    return VM_OK;
}

/* Returns 1 if the last terms of a Legendre series of the phase rate are at most `limit` times the mean rate, else 0.
   The limit is for absolute values, because the rate may be negative where the law of order three is not valid. */
VM_API int vmi_vdp_rate_is_resolved(const vm_real *rate, vm_real limit)
{
    return vmi_legendre_tail(rate) <= limit * VM_FABS(rate[0]);
}

/* Returns 1 if the panel is so short that its series are accurate enough, else 0. `whole` is the length of the whole
   interval of integration, s. The series of E_0 may leave out terms that do not matter, and terms that are rounding
   errors: on a panel of half the length the rounding errors would be larger. The series of the phase rate may leave out
   such terms, too, since it contains E_0. */
VM_API int vmi_vdp_panel_is_resolved(const vmi_vdp_panel *panel, vm_real length, vm_real whole)
{
    const vm_real E_enough = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    const vm_real limit = vmi_panel_limit(length, whole);
    const vm_real noise = vmi_panel_E_noise(panel->rate[0] * length) + panel->rounding;
    if (!(panel->laws.edge <= vmi_panel_edge_limit(limit))) return 0;
    if (!vmi_panel_is_resolved(panel->laws.inverse, limit) || !vmi_panel_is_resolved(panel->r, limit)) return 0;
    if (!vmi_panel_is_resolved(panel->laws.ratio, limit)) return 0; /* the series of the stiffness */
    if (!vmi_vdp_rate_is_resolved(panel->rate, limit + noise)) return 0;
    if (!vmi_vdp_rate_is_resolved(panel->first_rate, limit)) return 0;
    return vmi_legendre_tail(panel->laws.E) <= E_enough * VM_SQRT(vmi_legendre_square(panel->laws.E)) + noise;
}

/* Advances the mean motion from the start to the end of a panel. */
VM_API void vmi_vdp_add_panel(const vm_vdp_plan *p, vmi_vdp_panel *panel, vm_real length, vmi_vdp_mean *mean)
{
    const vm_real g = VM_FABS(p->osc.ripple.gamma), phase = panel->rate[0] * VM_FABS(length);
    const vm_real second = VM_FABS(vmi_expansion_second(&p->osc.ripple)) * vmi_legendre_square(panel->laws.E);
    mean->t += length;
    mean->psi += length * panel->rate[0];
    mean->first_psi += length * panel->first_rate[0];
    mean->ln_A += panel->ln_A;
    mean->first_ln_A += panel->first_ln_A;
    mean->psi_error += g * mean->J_error * panel->kept;
    mean->psi_third += g * mean->J_third * panel->kept + phase * second;
    mean->J_error *= panel->loss;
    mean->J_third *= panel->loss;
    panel->laws.ratio[0] = panel->rate[0] / p->osc.mean.W; /* vmi_osc_add_changes needs the rate in this form */
    panel->laws.cube = 0;
    vmi_osc_add_changes(&p->osc, &panel->laws, length, &mean->fast);
}

/* Advances the mean motion to `end` by panels of at most `longest`. No table may have a point between these times.
   `whole` is the length of the whole interval of integration, s. Returns VM_NOT_FINITE where the amplitude becomes
   infinite between these times. */
VM_API int vmi_vdp_walk_piece(const vm_vdp_plan *p, vm_real end, vm_real longest, vm_real whole, vmi_vdp_mean *mean)
{
    vmi_panels panels = vmi_panels_from(mean->t, end, longest, whole);
    while (vmi_panels_next(&panels)) {
        const vm_real length = panels.side * panels.step;
        vmi_vdp_panel panel;
        int status = vmi_vdp_panel_of(p, mean, length, &panel);
        if (status) return status;
        if (!vmi_vdp_panel_is_resolved(&panel, panels.step, whole)) {
            if (vmi_panels_halve(&panels)) continue;
            if (!VM_IS_FINITE(panel.ln_A) || !VM_IS_FINITE(panel.rate[0])) return VM_NOT_FINITE;
            mean->fast.error += panels.step * vmi_legendre_tail(panel.rate) / p->osc.Om;
        }
        vmi_vdp_add_panel(p, &panel, length, mean);
        if (panels.step < mean->fast.shortest && panels.step < panels.left) mean->fast.shortest = panels.step;
        vmi_panels_advance(&panels);
        mean->t = panels.t;
    }
    return VM_OK;
}

/* -- The motion that belongs to a mean motion -- */

/* Returns amplitude, phase and phase rate of the motion at mean->t, by the law of order three cut off after order 1, 2
   or 3. Mass, stiffness and rates are those in mean->now. */
VM_API vmi_osc_reduced vmi_vdp_state(const vm_vdp_plan *p, int order, const vmi_vdp_mean *mean)
{
    const vmi_ripple *r = &p->osc.ripple;
    const vmi_osc_wave wave = vmi_osc_wave_of(&p->osc, VM_ROUTE_ATEB);
    const vm_real share = 2 / (r->alpha + 3);
    vm_real ln_A = order == 1 ? mean->first_ln_A : mean->ln_A, sa, ca, ln_J;
    vmi_osc_reduced state;
    vmi_vdp_disturbance now;
    vmi_vdp_values f;
    state.W = vmi_vdp_rate(p, mean->now.m, mean->now.k, ln_A);
    state.psi = order == 1 ? mean->first_psi : mean->psi;
    if (order > 1) {
        now = vmi_vdp_disturbance_at(p, &mean->now, ln_A, state.W);
        vmi_osc_wave_at(&wave, state.psi, &ca, &sa);
        vmi_vdp_values_at(&p->ripple, r, state.psi, sa, ca, &f);
        ln_J = now.e * f.U;
        state.psi += now.e * f.P1;
        if (order > 2) {
            ln_J += vmi_vdp_J_back_second(&p->ripple, r, &f, &now);
            state.psi += vmi_vdp_psi_back_second(&p->ripple, r, mean->psi, &f, &now);
        }
        ln_A += share * ln_J;
        state.W *= vmi_exp(r->gamma * ln_J, 0);
    }
    state.A = vmi_exp(ln_A, 0);
    return state;
}

/* -- The walk -- */

/* Sets mean->now for the time mean->t. `side` is the direction of the integration along the laws: 1 forward, -1
   backward in time. Where derivatives of the laws jump at this time, the function takes their values before the jump
   for side = 1, and after the jump for side = -1. */
VM_API int vmi_vdp_mean_update(const vm_vdp_plan *p, int side, vmi_vdp_mean *mean)
{
    const vm_real sampling = vmi_osc_sampling_time(&p->osc), way = VM_FABS(mean->t);
    const vm_real unit = 1 / p->osc.Om;
    if (way == 0) return vmi_osc_slow_at(&p->osc.problem, 0, side, sampling, unit, &mean->now);
    return vmi_osc_slow_at(&p->osc.problem, mean->t, -side, vmi_smaller(sampling, way), unit, &mean->now);
}

/* Continues the mean motion beyond mean->t, the time of a table point. First it goes back to the last phase before this
   time at which sa or ca is 0. From there it integrates the exact equations to the first such phase after this time. */
VM_API int vmi_vdp_walk_past_knot(const vm_vdp_plan *p, int side, vmi_vdp_mean *mean)
{
    const vm_real quarter = p->osc.ripple.pi / 2, turns = (vm_real)side * mean->psi / quarter;
    const vm_real W = vmi_vdp_rate(p, mean->now.m, mean->now.k, mean->ln_A), knot = mean->t;
    const vm_real back = -(vm_real)side * quarter * (turns - VM_FLOOR(turns)) / W;
    vmi_vdp_panel panel;
    vmi_osc_reduced state;
    int status = VM_OK;
    /* If the time to which the mean motion goes back lies before the previous table point, or before t = 0, the two
       points are too close together. */
    if ((vm_real)side * (knot + back - mean->segment) < 0) return VM_NOT_INTEGRATED;
    if (back != 0) {
        status = vmi_vdp_panel_of(p, mean, back, &panel);
        if (status) return status;
        vmi_vdp_add_panel(p, &panel, back, mean);
    }
    mean->t = knot + back;
    status = vmi_vdp_mean_update(p, side, mean);
    if (status) return status;
    state = vmi_vdp_state(p, 3, mean);
    mean->segment = knot;
    return vmi_vdp_bridge(p, mean->t, side, &state, 1, mean);
}

/* Writes the start of the mean motion to *mean, for times t > 0 with side = 1, for times t < 0 with side = -1. The body
   must not be at rest. Where no law is a table, the start forward in time also serves backward, if there is one. */
VM_API int vmi_vdp_start_of(const vm_vdp_plan *p, int side, vmi_vdp_mean *mean)
{
    const vm_osc_problem *o = &p->osc.problem;
    if (side < 0 && (p->start_status || o->mass.time || o->stiffness.time)) return vmi_vdp_start(p, -1, mean);
    if (!p->start_status) *mean = p->start;
    return p->start_status;
}

/* Advances the mean motion from its start to t by integration along the laws of mass and stiffness, from one point of a
   table to the next. Before the call *mean must be the start for the direction of t (vmi_vdp_start_of). Returns the
   statuses of vmi_vdp_mean_at. */
VM_API int vmi_vdp_walk(const vm_vdp_plan *p, vm_real t, vmi_vdp_mean *mean)
{
    const vm_osc_problem *o = &p->osc.problem;
    const int side = vmi_time_side(t);
    const vm_real whole = vmi_larger(VM_FABS(t), VM_FABS(mean->t));
    const vm_real longest = vmi_smaller(vmi_law_longest_panel(&o->mass, whole),
                                        vmi_law_longest_panel(&o->stiffness, whole));
    vm_real at = 0;
    int status = VM_OK;
    mean->fast.shortest = longest;
    while (!status) {
        const vm_real next = vmi_osc_next_knot(o, at, t);
        if (next != t && (vm_real)side * (mean->t - next) > 0) return VM_NOT_INTEGRATED;
        status = vmi_vdp_walk_piece(p, next, longest, whole, mean);
        if (!status) status = vmi_vdp_mean_update(p, side, mean);
        if (status || next == t) return status;
        status = vmi_vdp_walk_past_knot(p, side, mean);
        at = next;
    }
    return status;
}

/* Computes the mean motion at t by integration along the laws of mass and stiffness. Returns VM_NOT_INTEGRATED where
   amplitude and phase do not describe the motion, or where two points of a table, or t = 0 and a point of a table,
   are closer than a quarter of a vibration, and VM_NOT_FINITE where the amplitude becomes infinite between 0 and t. */
VM_API int vmi_vdp_mean_at(const vm_vdp_plan *p, vm_real t, vmi_vdp_mean *mean)
{
    const int status = vmi_vdp_start_of(p, vmi_time_side(t), mean);
    if (status) return status;
    return vmi_vdp_walk(p, t, mean);
}

#endif
