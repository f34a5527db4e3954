/* oscillators/collocation.h - the motion of an oscillator by collocation, to a tolerance

   Two runs compute the same motion side by side, in steps from each zero of x to the next (oscillators/course.h). One
   of them, the strict run, has more points per step than the other one, the loose run. The difference between the
   results of the two runs gives an estimate of the error. If the error is larger than the tolerance, another pair of
   runs with more points follows. A pair of runs is stopped as soon as its error is too large, even before the end. So
   it costs little computing time to try a pair with few points first.
       vm_osc_motion motion;
       int status = vmi_osc_collocate(&plan, VM_ROUTE_COLLOCATION, 300, VM_C(1e-8), &motion); // plan is a vm_osc_plan
   Tests: tests/test_collocation.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_COLLOCATION_H
#define VARMASS_OSCILLATORS_COLLOCATION_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "averaging.h"
#include "course.h"
#include "integration.h"
#include "laws.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "walk.h"
#include "waves.h"

/* -- Two runs side by side -- */

/* Advances both runs to the time t, which is a point of a law's table or the end. At the ends of steps the function
   compares the two runs: the absolute difference of their phases and that of their ln A are added. *difference becomes
   the largest of these sums. The runs stop before t where *difference is larger than `most`. */
VM_API int vmi_osc_courses_to(vmi_osc_course *loose, vmi_osc_course *strict, vm_real t, vm_real most,
                              vm_real *difference)
{
    const vm_real most_steps = VM_C(16777216.); /* 2^24: after more steps a phase in float has no correct digits */
    vm_real steps = 0;
    int status = VM_OK;
    loose->stop = t;
    strict->stop = t;
    while (!status && !(*difference > most) && (loose->t != t || strict->t != t)) {
        vm_real apart;
        if (loose->t != t) status = vmi_osc_course_step(loose);
        if (!status && strict->t != t) status = vmi_osc_course_step(strict);
        if (status) break;
        apart = VM_FABS(loose->psi - strict->psi) + VM_FABS(loose->ln_A - strict->ln_A);
        if (loose->t != t && strict->t != t && loose->psi == strict->psi)
            apart += VM_FABS((loose->t - strict->t) * strict->rate);
        if (loose->psi == strict->psi || (loose->t == t && strict->t == t))
            *difference = vmi_larger(apart, *difference);
        steps += 1;
        if (steps > most_steps) status = VM_NOT_INTEGRATED;
    }
    return status;
}

/* Numbers of points per step in the loose run and in the strict run, and number of parts into which both runs divide
   each half period */
typedef struct VM_TAG(vmi_osc_points) {
    signed char loose, strict, parts;
} vmi_osc_points;

/* The number of pairs of runs that can be tried one after the other */
enum { VMI_OSC_PAIRS = 6 };

/* Pair number i, 0 to VMI_OSC_PAIRS - 1. Pair i is more accurate than pair i - 1. With a force the rates of ln A and
   phase may have kinks in the middle of a half period, where x' = 0, and the errors of Gauss' rule have no closed form.
   Therefore with a force a half period has two parts and more points. For alpha > 3 the rates change quickly in the
   middle of a half period; two parts that meet there give smaller errors than one. */
VM_API vmi_osc_points vmi_osc_pair(const vm_osc_problem *o, int i)
{
    static const vmi_osc_points alone[VMI_OSC_PAIRS] = {{2, 3, 1}, {3, 4, 1},  {4, 6, 1},
                                                        {6, 9, 1}, {8, 11, 2}, {14, 20, 2}};
    static const vmi_osc_points forced[VMI_OSC_PAIRS] = {{4, 6, 2},  {5, 7, 2},   {6, 8, 2},
                                                         {8, 11, 2}, {10, 14, 2}, {14, 20, 2}};
    vmi_osc_points points = alone[i];
    if (o->force) points = forced[i];
    if (o->alpha > 3) points.parts = 2;
    return points;
}

/* The kinds of problems, in the order of the rows of vmi_osc_first_pair */
enum { VMI_OSC_SLOW, VMI_OSC_QUICK, VMI_OSC_BY_FUNCTION, VMI_OSC_FORCED };

/* The index of the pair of runs that is tried first. Each kind of problem has a row in the table at_least, with a least
   tolerance for each pair of runs. The pair that is tried first is the first one in this row whose least tolerance is
   not above the given tolerance. `change` is the relative change of mass and stiffness while the phase grows by 1
   (vmi_osc_change_at). A problem is quick if `change` is more than 1/16, else slow. The rows were found with changes of
   up to 0.01 for the slow problems, and of about 0.1 for the quick ones. If a user's function gives mass or stiffness,
   more points are needed, because the derivative of the rate p is then found numerically. */
VM_API int vmi_osc_first_pair(const vm_osc_problem *o, vm_real tolerance, vm_real change)
{
    static const vm_real at_least[][VMI_OSC_PAIRS] = {
        {VM_C(1e-8), VM_C(1e-9), VM_C(1e-11), 0},               /* slow */
        {VM_INFINITY, VM_C(1e-6), VM_C(1e-7), VM_C(1e-9), 0},   /* quick */
        {VM_INFINITY, VM_INFINITY, VM_C(1e-8), 0},              /* mass or stiffness by a user's function */
        {VM_INFINITY, VM_INFINITY, VM_C(1e-6), VM_INFINITY, 0}, /* forced */
    };
    int i = 0, kind = VMI_OSC_SLOW;
    if (change > VM_C(0.0625)) kind = VMI_OSC_QUICK;
    if (vmi_osc_has_user_law(o)) kind = VMI_OSC_BY_FUNCTION;
    if (o->force) kind = VMI_OSC_FORCED;
    while (tolerance < at_least[kind][i]) i++;
    return i;
}

/* The index of the pair of runs that is tried after pair i. `error` is the estimated error of pair i, which is larger
   than the tolerance. To predict the errors of the next pairs, the function assumes that errors fall as fast as
   1/(number of points)^10. It skips a pair whose predicted error is larger than the tolerance. */
VM_API int vmi_osc_next_pair(const vm_osc_problem *o, int i, vm_real error, vm_real tolerance)
{
    const vmi_osc_points last = vmi_osc_pair(o, i);
    int next;
    for (next = i + 1; next < VMI_OSC_PAIRS - 1; next++) {
        const vmi_osc_points points = vmi_osc_pair(o, next);
        const vm_real ratio = (vm_real)(last.strict * last.parts) / (vm_real)(points.strict * points.parts);
        const vm_real power_5 = ratio * ratio * ratio * ratio * ratio;
        if (error * power_5 * power_5 <= tolerance) break;
    }
    return next;
}

/* Computes how fast mass, damping and stiffness change at t: the sum of the rates |p|, |a| and |k'/k| of
   oscillators/reduction.h, divided by the rate of the phase. Writes this quotient to *change if it is larger than
   *change. */
VM_API int vmi_osc_change_at(const vm_osc_plan *plan, vm_real t, int side, vm_real *change)
{
    vmi_osc_rates now;
    vm_real rate;
    const int status = vmi_osc_rates_at(&plan->problem, t, side, &now);
    if (status) return status;
    rate = plan->Om * VM_SQRT((now.k / plan->k0) / (now.m / plan->m0));
    *change = vmi_larger((VM_FABS(now.p) + VM_FABS(now.a) + VM_FABS(now.k_rate)) / rate, *change);
    return VM_OK;
}

/* Returns the estimated error of the strict run divided by the difference of the two runs. This difference is nearly
   the error of the loose run. Let n be the number of points per step. Where no force acts, the error falls about as
   n^-8 for alpha from 1 to 5. For alpha < 1 it falls as n^-6, because the rates have terms proportional to d^(alpha+2),
   where d is the distance from a zero of x, and Gauss' rule is less accurate for these terms. The error falls more
   slowly than n^-8 also if a step has few points, or if mass or stiffness changes by more than 1/32 of itself per
   radian. The same holds for alpha > 5, where the velocity reverses suddenly, for a force with kinks, and if a user's
   function gives mass or stiffness. In a graded rule (vmi_gauss_rule_grade) the points are densest at both ends of a
   step, where x or x' is 0, so kinks of the force at these places cause smaller errors. docs/routes.md compares the
   estimated errors with the true ones. */
VM_API vm_real vmi_osc_strict_share(const vm_osc_problem *o, vmi_osc_points points, vm_real change)
{
    const vm_real ratio = (vm_real)points.loose / (vm_real)points.strict, squared = ratio * ratio;
    const vm_real fourth = squared * squared;
    const int graded = vmi_osc_needs_grading(o), kinks = o->force && !graded;
    if (points.strict <= 4 || vmi_osc_has_user_law(o)) return squared;
    if (kinks || o->alpha > 5 || (graded && points.strict <= 8)) return fourth;
    if (o->alpha < 1 || (!o->force && change > VM_C(0.03125))) return fourth * squared;
    return fourth * fourth;
}

/* A pair of runs */
typedef struct VM_TAG(vmi_osc_pair_run) {
    vm_real change;        /* relative change of mass and stiffness per radian (vmi_osc_change_at), the larger of its
                              values at 0 and at t */
    vm_real longest;       /* the longest step, s */
    vm_real sweep_limit;   /* sweep_limit of the strict run (see vmi_osc_course) */
    vm_real most;          /* the pair is stopped when its error is larger than this number */
    vmi_osc_course strict; /* the strict run; it ends before t if the pair was stopped */
    vmi_osc_rates now;     /* mass, stiffness and rates at t; only valid if the pair was not stopped */
    vmi_osc_reduced state; /* amplitude and phase of the strict run at t; only valid if the pair was not stopped */
    vm_real error;         /* estimated error at t; if the pair was stopped, it is extrapolated to t */
} vmi_osc_pair_run;

/* Sets amplitude and phase at t from the strict run. Before the call r->error is the error of ln A and of the phase;
   after the call r->error is the error of x and v. Without a force this error is larger, because v = -2/(alpha+1) W A
   sa - p x also contains the error of x. With a force v = -2/(alpha+1) W A sa. */
VM_API int vmi_osc_end_pair(const vm_osc_plan *plan, vm_real t, vmi_osc_pair_run *r)
{
    const vmi_osc_course *strict = &r->strict;
    const vmi_osc_rates *now = &r->now;
    const int status = vmi_osc_rates_at(&plan->problem, t, -strict->side, &r->now);
    vm_real by_time;
    if (status) return status;
    r->state.psi = strict->psi;
    r->state.A = plan->A * vmi_exp(strict->ln_A, 0);
    r->state.W = plan->Om * vmi_osc_Om_ratio(plan, &r->now, strict->ln_A);
    by_time = vmi_osc_relative_rate(plan->problem.alpha, now->p, now->a, now->k_rate);
    r->error = vmi_larger(vmi_osc_time_rounding(t, r->state.W, by_time), r->error);
    if (!plan->problem.force) r->error *= 1 + (plan->problem.alpha + 1) / 2 * VM_FABS(r->now.p / r->state.W);
    return VM_OK;
}

/* Makes one pair of runs from 0 to t, with the numbers of points and parts in `points`. */
VM_API int vmi_osc_collocate_pair(const vm_osc_plan *plan, vm_real t, vmi_osc_points points, vmi_osc_pair_run *r)
{
    const int side = vmi_time_side(t);
    const vm_real looser = 16; /* sweep_limit of the loose run divided by that of the strict run */
    vm_real share = vmi_osc_strict_share(&plan->problem, points, r->change);
    const vm_real most = r->most / share;
    vmi_osc_course loose, *strict = &r->strict;
    vmi_osc_slow start;
    vm_real difference = 0;
    int status = vmi_osc_rates_at(&plan->problem, 0, side, &r->now);
    if (status) return status;
    start.m = r->now.m;
    start.k = r->now.k;
    start.p = plan->problem.force ? 0 : r->now.p; /* with a force V is x' (oscillators/course.h) */
    r->state = vmi_osc_reduce(&start, plan->problem.alpha, plan->problem.x, plan->problem.v);
    vmi_osc_course_start(&loose, plan, &r->state, side, points.loose, points.parts, looser * r->sweep_limit);
    vmi_osc_course_start(strict, plan, &r->state, side, points.strict, points.parts, r->sweep_limit);
    loose.longest = r->longest;
    strict->longest = r->longest;
    while (!status && strict->t != t && !(difference > most)) {
        const vm_real next = vmi_osc_next_knot(&plan->problem, strict->t, t);
        status = vmi_osc_courses_to(&loose, strict, next, most, &difference);
    }
    if (status) return status;
    strict->evals += loose.evals;
    if (loose.halved || strict->halved) share = 1; /* such errors fall slowly as the number of points grows */
    if (loose.halved != strict->halved) difference = vmi_larger(1, difference);
    r->error = share * difference + strict->left + 4 * VM_EPSILON * (2 + VM_FABS(strict->psi - r->state.psi));
    if (strict->t == t) return vmi_osc_end_pair(plan, t, r);
    r->error *= t / strict->t; /* errors grow in proportion to time, or faster */
    return VM_OK;
}

/* Returns 1 if a law may change within a time that is much shorter than f/f', as a power law near the time at which its
   base is 0, or a quadratic law near its minimum; else 0. */
VM_API int vmi_law_may_hide_changes(const vm_law *law)
{
    return law->derivatives == vmi_law_power_derivatives || law->derivatives == vmi_law_quadratic_derivatives;
}

/* Returns VM_NOT_INTEGRATED if mass or stiffness change so fast somewhere between 0 and t that a step of collocation
   might contain the whole change without a node near it; both runs of a pair would then miss it. The test is for laws
   that the nodes alone do not show to be fast (vmi_law_may_hide_changes). It uses the shortest panel of the integration
   along the laws (oscillators/walk.h). If a user's function gives mass or stiffness, the panels are short anyway, and
   limit the steps (vmi_osc_law_step). Returns VM_OK if there is no such change, or the status of a law that fails. */
VM_API int vmi_osc_check_steps(const vm_osc_plan *plan, vm_real t)
{
    const vm_osc_problem *o = &plan->problem;
    const vm_real least = VM_C(0.5); /* length of a panel in phase */
    vmi_osc_mean mean;
    vmi_osc_rates now;
    vm_real slower;
    int status;
    if (vmi_osc_has_user_law(o)) return VM_OK;
    if (!vmi_law_may_hide_changes(&o->mass) && !vmi_law_may_hide_changes(&o->stiffness)) return VM_OK;
    status = vmi_osc_walk_along(plan, t, &mean);
    if (!status) status = vmi_osc_rates_at(o, t, -vmi_time_side(t), &now);
    if (status) return status;
    slower = vmi_smaller(1, VM_SQRT((now.k / plan->k0) / (now.m / plan->m0)));
    if (mean.shortest < VM_FABS(t) / 2 && mean.shortest * plan->Om * slower < least) return VM_NOT_INTEGRATED;
    return VM_OK;
}

/* Computes the motion at t by collocation. Returns VM_TOLERANCE_MISSED where the motion is computed, but its estimated
   error is larger than the tolerance. Returns VM_NOT_INTEGRATED if more than 2^24 steps would be needed. Also returns
   VM_NOT_INTEGRATED if mass, stiffness or force change as fast as the phase, or if the plan has no phase
   (vmi_osc_has_phase), because amplitude and phase then do not describe the motion. Where the law of the mass or of the
   stiffness fails, returns the status of this law. */
VM_API int vmi_osc_collocate(const vm_osc_plan *plan, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_osc_problem *o = &plan->problem;
    const vm_real knots = (vm_real)(o->mass.n + o->stiffness.n);
    const vm_real steps = 2 + plan->Om * VM_FABS(t) / plan->ripple.pi + knots;
    const vm_real share = 4 * steps; /* the iterations of all steps may together cause an error of a quarter of the
                                        tolerance, or of half of it if a half period has two parts */
    const vm_real most_half_periods = VM_C(1073741824.); /* 2^30 */
    vmi_osc_pair_run r;
    vm_osc_motion result;
    vm_real sa, ca;
    int i, status;
    if (!vmi_osc_has_phase(plan)) return VM_NOT_INTEGRATED;
    status = vmi_osc_law_step(plan, t, &r.longest);
    r.change = 0;
    status = vmi_first_error(status, vmi_osc_change_at(plan, 0, vmi_time_side(t), &r.change));
    status = vmi_first_error(status, vmi_osc_change_at(plan, t, -vmi_time_side(t), &r.change));
    if (status) return status;
    if (!(plan->Om * VM_FABS(t) <= most_half_periods * plan->ripple.pi)) return VM_NOT_INTEGRATED;
    status = vmi_osc_check_steps(plan, t);
    if (status) return status;
    r.longest *= 2;
    r.sweep_limit = vmi_larger(tolerance / share, VM_EPSILON);
    r.error = VM_INFINITY;
    result.evals = 0;
    i = vmi_osc_first_pair(o, tolerance, r.change);
    while (i < VMI_OSC_PAIRS && !(r.error <= tolerance)) {
        r.most = i < VMI_OSC_PAIRS - 1 ? tolerance : VM_INFINITY;
        status = vmi_osc_collocate_pair(plan, t, vmi_osc_pair(o, i), &r);
        if (status) return status;
        result.evals += r.strict.evals;
        r.sweep_limit = vmi_larger(r.sweep_limit / 16, VM_EPSILON); /* the iterations of the steps may have caused the
                                                                       error */
        i = vmi_osc_next_pair(o, i, r.error, tolerance);
    }
    vmi_osc_wave_at(&r.strict.wave, r.state.psi, &ca, &sa);
    vmi_osc_unreduce(&r.state, o->force ? 0 : r.now.p, o->alpha, sa, ca, &result.x, &result.v);
    result.amplitude = r.state.A;
    result.error = r.error;
    result.route = route;
    if (!VM_IS_FINITE(result.x) || !VM_IS_FINITE(result.v)) return VM_NOT_FINITE;
    *motion = result;
    return result.error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

#endif
