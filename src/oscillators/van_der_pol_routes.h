/* oscillators/van_der_pol_routes.h - the motion x(t) of a Van der Pol oscillator, and its limit cycle to second order

   Five methods, called routes, lead from x and x' at t = 0 to x and x' at any t. Three routes are the law of
   oscillators/van_der_pol_expansion.h, cut off after order one, two or three. The other two routes are numerical
   integrations. The names of the routes are those of oscillators/problem.h:
     VM_ROUTE_ATEB           law of order one, with a start of order three; errors are O(epsilon)
     VM_ROUTE_ORDER2         law of order two; errors are O(epsilon^2)
     VM_ROUTE_ORDER3         the whole law, of order three; errors are O(epsilon^3)
     VM_ROUTE_COLLOCATION    integration from each zero of x or x' to the next, within a tolerance
     VM_ROUTE_RK87           integration of the equation of motion by rk87, within a tolerance
   epsilon is the relative change of the vibration while the phase grows by 1. The cost of the first three routes does
   not depend on t. vm_vdp_within takes the cheapest route whose estimated error is within a tolerance. The shortest
   useful call:
       vm_vdp v;
       vm_osc_motion motion;
       memset(&v, 0, sizeof v);
       v.alpha = 3;
       v.k = 1;
       v.feed = v.c = VM_C(0.01);
       v.mass = vm_law_linear(1, VM_C(-0.001)); // a mass of 1 kg, which leaks 1 g/s
       int status = vm_vdp_within(&v, VM_C(0.5), 0, 300, VM_C(1e-6), &motion); // from rest at 0.5 m, after 300 s
   Tests: tests/test_van_der_pol_law.c. */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_ROUTES_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_ROUTES_H

#include "../ateb/period.h"
#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "collocation.h"
#include "mean_motion.h"
#include "problem.h"
#include "ripple.h"
#include "routes.h"
#include "van_der_pol.h"
#include "van_der_pol_constant.h"
#include "van_der_pol_expansion.h"
#include "van_der_pol_walk.h"

/* -- The law of orders one to three -- */

/* Returns the order, 1 to 3, after which a route cuts off the law of order three, or 0 for a route that does not use
   this law. */
VM_API int vmi_vdp_order_of(int route)
{
    switch (route) {
    case VM_ROUTE_ATEB: return 1;
    case VM_ROUTE_ORDER2: return 2;
    case VM_ROUTE_ORDER3: return 3;
    default: return 0;
    }
}

/* Returns the estimated error of the route VM_ROUTE_ORDER3, and writes that of VM_ROUTE_ORDER2 to *second. Each
   estimate is the sum of the terms that the route leaves out, in the transformations at the start and at t and in the
   mean motion. An error of ln J at the start causes an error of the mean phase that grows with the phase; J is the
   quantity of oscillators/van_der_pol_expansion.h. The effects of fast changes of the mass and of rounding errors are
   added. The estimates contain a factor of 2, which fits the errors that tests/test_van_der_pol_law.c finds. */
VM_API vm_real vmi_vdp_error(const vm_vdp_plan *p, const vmi_vdp_mean *mean, vm_real *second)
{
    const vmi_ripple *r = &p->osc.ripple;
    const vm_real n = r->alpha + 1, largest_known = VM_C(0.25); /* where the estimate is larger than this, it says
                                                                   nothing about the error */
    const vm_real W = vmi_vdp_rate(p, mean->now.m, mean->now.k, mean->ln_A), turns = VM_FABS(mean->psi - p->start.psi);
    const vmi_vdp_sizes now = vmi_vdp_sizes_at(p, &mean->now, mean->ln_A, W);
    const vm_real back = 2 / n * now.psi + 2 / (n + 2) * now.J;
    const vm_real all = back + 2 / n * mean->psi_error + 2 / (n + 2) * mean->J_error;
    vm_real E[VMI_OSC_G], third = all * vmi_larger(now.ratio, mean->ratio), error;
    const vm_real fast = (1 + VM_FABS(r->gamma) * turns) * vmi_osc_fast(&p->osc, &mean->fast);
    const vm_real fastest = vmi_osc_relative_rate(r->alpha, mean->now.p, mean->now.a, mean->now.k_rate);
    const vm_real by_time = vmi_osc_time_rounding(mean->t, W, fastest);
    const vm_real rounding = vmi_larger(by_time, 4 * VM_EPSILON * (2 + turns)) + W * mean->fast.error;
    vmi_expansion_sizes terms;
    vmi_vdp_absolute_E(&mean->now, W, E);
    vmi_expansion_find_sizes(r, E, &terms);
    third += 2 / n * (mean->psi_third + terms.psi[3] + terms.psi[4] + now.third);
    third += 2 / (n + 2) * (mean->J_third + terms.J[3] + terms.J[4] + now.third);
    error = 2 * third + fast + rounding;
    *second = 2 * back + error;
    if (!(*second < largest_known)) *second = VM_INFINITY;
    return error < largest_known ? error : VM_INFINITY;
}

/* Computes the motion from the mean motion by the law of order three, cut off after the order 1, 2 or 3 of the route,
   with an estimate of the terms that are left out. Writes amplitude, phase and rate of the phase to *state. */
VM_API int vmi_vdp_truncated(const vm_vdp_plan *p, int route, const vmi_vdp_mean *mean, vmi_osc_reduced *state,
                             vm_osc_motion *motion)
{
    const int order = vmi_vdp_order_of(route);
    const vmi_osc_wave wave = vmi_osc_wave_of(&p->osc, VM_ROUTE_ATEB);
    vm_real sa, ca, second;
    *state = vmi_vdp_state(p, order, mean);
    vmi_osc_wave_at(&wave, state->psi, &ca, &sa);
    vmi_osc_unreduce(state, mean->now.p, p->vdp.alpha, sa, ca, &motion->x, &motion->v);
    motion->amplitude = state->A;
    motion->error = vmi_vdp_error(p, mean, &second);
    if (order < 3) motion->error = second;
    motion->route = route;
    motion->evals = 0;
    if (!VM_IS_FINITE(motion->x) || !VM_IS_FINITE(motion->v)) return VM_NOT_FINITE;
    return VM_OK;
}

/* Computes the motion from the mean motion by the law of order three, cut off after the order 1, 2 or 3 of the route,
   with an estimate of the error. For order 1 the estimate is the estimate for order 2, plus the difference between the
   motions by order 1 and by order 2. */
VM_API int vmi_vdp_order_n(const vm_vdp_plan *p, int route, const vmi_vdp_mean *mean, vm_osc_motion *motion)
{
    vmi_osc_reduced state, unused;
    vm_osc_motion result, better;
    int status = vmi_vdp_truncated(p, route, mean, &state, &result);
    if (status) return status;
    if (vmi_vdp_order_of(route) == 1) {
        const vm_real vmax = 2 / (p->vdp.alpha + 1) * state.A * state.W;
        status = vmi_vdp_truncated(p, VM_ROUTE_ORDER2, mean, &unused, &better);
        if (status) return status;
        result.error += vmi_larger(VM_FABS(result.x - better.x) / state.A, VM_FABS(result.v - better.v) / vmax);
    }
    if (!(result.error >= 0)) result.error = VM_INFINITY;
    *motion = result;
    return VM_OK;
}

/* -- One route -- */

/* Integrates the exact equations within the tolerance. It uses the functions for an oscillator with a further force F
   (oscillators/problem.h), where F is the term -c x^2 x'. */
VM_API int vmi_vdp_integrate(const vm_vdp_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan exact = p->osc;
    vm_real c = p->vdp.c;
    exact.problem.force = vmi_vdp_force;
    exact.problem.ctx = &c;
    if (route == VM_ROUTE_COLLOCATION) return vmi_osc_collocate(&exact, route, t, tolerance, motion);
    if (route == VM_ROUTE_RK87) return vmi_osc_integrate_rk87(&exact, route, t, tolerance, motion);
    return vmi_osc_integrate_within(&exact, t, tolerance, motion);
}

/* Checks those arguments that the functions with a plan have in common, and replaces a tolerance of 0 by the
   default. */
VM_API int vmi_vdp_check_call(const vm_vdp_plan *p, vm_real t, vm_real *tolerance, const vm_osc_motion *motion)
{
    if (!p) return VM_BAD_ARGUMENT;
    return vmi_osc_check_call(&p->osc, VM_ROUTE_ATEB, t, tolerance, motion);
}

/* Motion x(t), x'(t) of a Van der Pol oscillator by a given route, from a plan.
   t is in seconds, of either sign. `route` is VM_ROUTE_ATEB, VM_ROUTE_ORDER2, VM_ROUTE_ORDER3, VM_ROUTE_COLLOCATION or
   VM_ROUTE_RK87. motion->error estimates the larger of |error of x|/A and |error of v|/vmax, where vmax is the largest
   velocity at the amplitude A. This estimate is infinite where the law of order three is not valid. The last two of
   these routes integrate numerically and keep this error within the tolerance; a tolerance of 0 means 1e-6 (float
   1e-3). The first three routes do not use the tolerance. Returns VM_OK, or VM_TOLERANCE_MISSED where x and v are
   computed but the error of integration is larger than the tolerance. After an error *motion is unchanged. The errors
   are
     VM_BAD_ARGUMENT for null pointers or a route that is not one of these five,
     VM_NOT_FINITE for a number that is infinite or NaN, and for the first three routes where the amplitude becomes
       infinite before t,
     VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive between 0 and t,
     VM_DOMAIN for a negative tolerance, t outside a table, a table whose times do not rise, or a user's function that
       fails,
     VM_NO_LAW, for the first three routes, where the elastic force is so weak that the rate of the phase underflows,
       for example for alpha = 5 and x = 1e-200 m,
     VM_NOT_INTEGRATED, for all routes but VM_ROUTE_RK87, where amplitude and phase do not describe the motion,
     VM_NOT_INTEGRATED, for the first three routes, where two points of a table, or t = 0 and a point of a table, are
       closer than a quarter of a vibration, if these points lie between 0 and t,
     VM_NOT_INTEGRATED, for the last two routes, where the integrator cannot reach t.
   The first three routes may use the laws up to a quarter of a vibration beyond t = 0 or beyond a point of a table, in
   the direction of t, even if t itself is nearer; what the laws are there can also cause these errors. */
VM_API int vm_vdp_plan_by_route(const vm_vdp_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const int by_law = vmi_vdp_order_of(route) > 0;
    vmi_vdp_mean mean;
    int status;
    if (!by_law && route != VM_ROUTE_COLLOCATION && route != VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    status = vmi_vdp_check_call(p, t, &tolerance, motion);
    if (status) return status;
    if (p->osc.A == 0) return vmi_osc_at_rest(&p->osc, route, motion);
    if (!by_law) return vmi_vdp_integrate(p, route, t, tolerance, motion);
    status = vmi_vdp_mean_motion(p, t, &mean);
    if (status) return status;
    return vmi_vdp_order_n(p, route, &mean, motion);
}

/* -- The cheapest route -- */

/* Writes the motion by the first of the routes VM_ROUTE_ATEB, VM_ROUTE_ORDER2 and VM_ROUTE_ORDER3 for which 1.5 times
   the estimated error is within the tolerance. If there is no such route, it returns VM_TOLERANCE_MISSED and leaves
   *motion untouched. */
VM_API int vmi_vdp_law_within(const vm_vdp_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_real reserve = VM_C(1.5); /* a factor on the estimate, the same as in vmi_osc_averaged_within */
    vmi_vdp_mean mean;
    vm_osc_motion result;
    int route;
    if (vmi_vdp_mean_motion(p, t, &mean)) return VM_TOLERANCE_MISSED;
    for (route = VM_ROUTE_ATEB; route <= VM_ROUTE_ORDER3; route++) {
        if (vmi_vdp_order_n(p, route, &mean, &result)) return VM_TOLERANCE_MISSED;
        if (!(reserve * result.error <= tolerance)) continue;
        *motion = result;
        return VM_OK;
    }
    return VM_TOLERANCE_MISSED;
}

/* Motion x(t), x'(t) of a Van der Pol oscillator within a tolerance, from a plan. t is in seconds, of either sign. The
   function takes the first of the routes VM_ROUTE_ATEB, VM_ROUTE_ORDER2 and VM_ROUTE_ORDER3 for which 1.5 times the
   estimated error is within the tolerance. If there is no such route, it integrates numerically; motion->route is the
   route that it took. The error is the larger of |error of x|/A and |error of v|/vmax (see vm_osc_motion); a tolerance
   of 0 means 1e-6 (float 1e-3). Returns the statuses of vm_vdp_plan_by_route. */
VM_API int vm_vdp_plan_within(const vm_vdp_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    int status = vmi_vdp_check_call(p, t, &tolerance, motion);
    if (status) return status;
    if (p->osc.A == 0) return vmi_osc_at_rest(&p->osc, VM_ROUTE_ATEB, motion);
    status = vmi_vdp_law_within(p, t, tolerance, motion);
    if (status != VM_TOLERANCE_MISSED) return status;
    return vmi_vdp_integrate(p, VM_ROUTE_TRIG, t, tolerance, motion); /* integrates by collocation, or else by rk87 */
}

/* Motion x(t), x'(t) of a Van der Pol oscillator within a tolerance, for a single t.
   x (m) and x_rate (m/s) are position and velocity at t = 0. All other arguments, the result and the statuses are those
   of vm_vdp_plan_within and vm_vdp_plan_init. */
VM_API int vm_vdp_within(const vm_vdp *v, vm_real x, vm_real x_rate, vm_real t, vm_real tolerance,
                         vm_osc_motion *motion)
{
    vm_vdp_plan plan;
    int status = vmi_osc_check_arguments(VM_ROUTE_ATEB, t, tolerance, motion);
    status = vmi_first_error(status, vm_vdp_plan_init(&plan, v, x, x_rate));
    if (status) return status;
    return vm_vdp_plan_within(&plan, t, tolerance, motion);
}

/* -- The limit cycle -- */

/* The limit cycle, that is the steady vibration, of a Van der Pol oscillator of constant mass */
typedef struct VM_TAG(vm_vdp_cycle) {
    vm_real largest_x; /* the largest position, m */
    vm_real period;    /* s */
    vm_real epsilon;   /* the number feed/(m W), where W is the rate of the phase; largest_x and period are series in
                          powers of epsilon */
    int stable;        /* 1 where motions close to the cycle tend to it, else 0 */
} vm_vdp_cycle;

/* Writes two coefficients of epsilon^2, where epsilon = feed/(m W): *kx is the coefficient in the series of the largest
   x, *kw the coefficient in the series of the rate of the phase. The disturbances (oscillators/van_der_pol_expansion.h)
   follow from the constant amplitude of the limit cycle; the code uses their values for epsilon = 1. The largest x is
   reached where x' = 0, that is where V = p x with V and p of oscillators/reduction.h. At this point the phase is
   `late` times epsilon; the phase is 0 where V = 0. */
VM_API void vmi_vdp_cycle_coefficients(const vmi_vdp_ripple *v, const vmi_ripple *r, vm_real *kx, vm_real *kw)
{
    const vm_real n = r->alpha + 1, s = 4 / (r->alpha + 3);
    vmi_vdp_disturbance d;
    vmi_vdp_values f;
    vm_real kA, late;
    d.e = -1 / v->F;
    d.e1 = (2 * s - 1) * d.e;
    d.Q0 = -s / 2 * d.e;
    d.E0 = -s * (2 - s) / 4;
    kA = -vmi_vdp_mean_second(v, &d) / v->F; /* relative change of A^2 by the terms of second order */
    *kw = (r->alpha - 1) / 4 * kA + vmi_vdp_mean_rate(v, r, &d) - 1;
    vmi_vdp_values_at(v, r, 0, 0, 1, &f);
    late = n * s / 4;
    *kx = kA / 2 + 2 / (n + 2) * (late - d.e * f.P1 + vmi_vdp_J_back_second(v, r, &f, &d)) - late * late / n;
}

/* Limit cycle of a Van der Pol oscillator of constant mass, to second order in epsilon. epsilon is feed/(m W), where m
   is the mass, and W the rate of the Ateb phase, 1/s, at the amplitude A of vm_vdp_limit_cycle. Then the largest x is A
   (1 + kx epsilon^2) and the period is 2 Pi_alpha/(W (1 + kw epsilon^2)), with kx = 1/192 and kw = -1/16 for alpha = 1.
   The number epsilon must be small: where it is above 4, the computed period is negative for alpha = 1. The errors of
   both results are O(epsilon^4). Mass and stiffness are those at t = 0. The fields method and reactive must be valid,
   but the result does not depend on them, nor on a1 to a3. Returns VM_BAD_ARGUMENT for null pointers, an unknown
   method, and a mass that no constructor made, VM_NOT_FINITE for numbers that are infinite or NaN, VM_BAD_MASS for a
   mass that is not positive, VM_BAD_STIFFNESS for a stiffness that is not positive, VM_DOMAIN for alpha < 0, for a
   table whose times do not rise or do not contain t = 0, and where a user's function fails, and VM_NO_LAW where there
   is no limit cycle, that is where feed and c do not have the same sign. An error leaves *cycle untouched. */
VM_API int vm_vdp_cycle_of(const vm_vdp *v, vm_vdp_cycle *cycle)
{
    vmi_ripple r;
    vmi_vdp_ripple ripple;
    vm_vdp_cycle result;
    vm_real mass, mass_rate, k, k_rate, A, W, kx, kw, numbers[3];
    int status;
    if (!v || !cycle || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    status = vmi_first_error(vmi_vdp_check(v), vmi_law_check(&v->mass, VM_BAD_MASS, 0));
    if (vmi_vdp_has_stiffness_law(v))
        status = vmi_first_error(status, vmi_law_check(&v->stiffness, VM_BAD_STIFFNESS, 0));
    if (!status) status = vmi_vdp_laws_at(v, 0, &mass, &mass_rate, &k, &k_rate);
    if (status) return status;
    if (!((v->feed > 0 && v->c > 0) || (v->feed < 0 && v->c < 0))) return VM_NO_LAW;
    vmi_ripple_init(&r, v->alpha, vmi_ateb_constants);
    vmi_ripple_complete(&r, 5);
    vmi_vdp_ripple_init(&ripple, &r);
    vmi_vdp_cycle_coefficients(&ripple, &r, &kx, &kw);
    A = VM_SQRT(v->feed / v->c / -ripple.F);
    W = vmi_slow_rate(A, k, mass, v->alpha);
    result.epsilon = v->feed / mass / W;
    result.largest_x = A * (1 + kx * result.epsilon * result.epsilon);
    result.period = 2 * r.pi / (W * (1 + kw * result.epsilon * result.epsilon));
    result.stable = v->c > 0;
    numbers[0] = result.largest_x;
    numbers[1] = result.period;
    numbers[2] = result.epsilon;
    if (!vmi_all_finite(3, numbers)) return VM_NOT_FINITE;
    *cycle = result;
    return VM_OK;
}

#endif
