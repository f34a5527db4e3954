/* oscillators/routes.h - the motion x(t) of an oscillator at any time, by a given route or by the cheapest

   Seven routes lead to x(t) and x'(t), from a cosine to the integration of the equation of motion by rk87 (VM_ROUTE_...
   in oscillators/problem.h). vm_osc_within takes the cheapest whose error is estimated to be within a tolerance,
   vm_osc_by_route the one that is asked for; vm_osc_plan_within and vm_osc_plan_by_route do the same for many times of
   one problem. The shortest useful call:
       vm_osc_problem bucket = {1, vm_law_linear(10, -0.1), vm_law_linear(250, 0), 0, 0, 0.05, 0, NULL, NULL};
       vm_osc_motion motion;
       if (vm_osc_within(&bucket, 70, 1e-6, &motion) == VM_OK) printf("%g m\n", motion.x);
   Tests: tests/test_routes.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_ROUTES_H
#define VARMASS_OSCILLATORS_ROUTES_H

#include "../base/real.h"
#include "../base/status.h"
#include "integration.h"
#include "laws.h"
#include "mean_motion.h"
#include "problem.h"
#include "waves.h"

/* -- Which route for what, and what the estimate of the error covers --

   Cost. Without a force F the first four routes are averaged solutions in closed form: one or two sa, ca and the
   integrals of the laws of mass and stiffness, whatever t and the tolerance are. The other routes integrate from 0
   to t and work to the tolerance: each runs twice, the second time more strictly, and the difference of the two
   gives the error. By the default tolerance that takes 400 (variation), 700 (rk87) or 2200 (rk45) evaluations a
   period for alpha = 3. With F the averaged equations of the first three routes are integrated, too, and the
   second-order law does not exist.

   Choice. vm_osc_within takes the first of these four that is within the tolerance. Where none is, or F is given,
   it integrates: by rk87 for odd alpha without F, where it is two to four times as fast, else by the variation of
   constants.

   What the estimate covers. Of averaged solutions: what the solution leaves out, and the fastest changes of mass
   and stiffness between 0 and t. These are examined panel by panel (for functions see vm_law_user), tables from
   point to point. A change within a period makes the estimate large; vm_osc_within then integrates, in steps of at
   most a quarter of the shortest panel. Of averaged equations with F: the error of their integration, of averaging,
   and of cos and cn in place of the Ateb functions. Averaging leaves out the ripple within a period, its effect on
   phase and amplitude at the start, its square, and a force that changes within a period, as in a resonance. For
   this estimate F is called over a period at the start and at eight later times: a force that acts only for a short
   time between these is not seen.

   How good the estimate is. Random problems (tests/test_routes.c) have alpha in [0, 8], q from 3e-3 to 0.1 and end
   at t = 3/q; some of them change only in a part of the run, or have tables with a step. The true error is below 3
   times the estimate in 99 % of them, and above 10 times (by vm_osc_within at most 10.3) in 1 of 1000. Of 282 runs
   by the variation of constants one erred by 37 times the estimate, at alpha = 1.5. With rk87 the true error is
   above 3 times the estimate in 2 %, up to 20 times: if alpha is not an odd integer, its errors are not
   proportional to the tolerance. In the median the estimate is 3 to 4 (first order), 7 (second order), 5 to 20
   (integrators) and, with F, 5 to 10 (averaged) times the true error. Above alpha = 8 the estimate of first order
   is too large. */

/* -- The table of routes -- */

/* The solution of averaged equations without a force at t, where the mean motion has come to *mean */
typedef int (*vmi_osc_solution)(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                                vm_osc_motion *motion);

/* A route: without a force by its solution in closed form, if it has one, else by its method of integration */
typedef struct VM_TAG(vmi_osc_route) {
    const char *name;
    vmi_osc_solution solution; /* null: it has none */
    vmi_osc_method method;     /* with rhs null: it cannot be integrated */
} vmi_osc_route;

/* The entry of an averaged solution, whose equations with a force, by rk45, are rhs; null: there are none */
VM_API vmi_osc_route vmi_osc_route_averaged(const char *name, vmi_osc_solution solution, ode_rhs rhs)
{
    vmi_osc_route route;
    route.name = name;
    route.solution = solution;
    route.method = vmi_osc_method_rk45(rhs);
    route.method.averaged = 1;
    return route;
}

/* The entry of a route that always integrates */
VM_API vmi_osc_route vmi_osc_route_integrated(const char *name, vmi_osc_method method, int direct)
{
    vmi_osc_route route;
    route.name = name;
    route.solution = NULL;
    route.method = method;
    route.method.direct = direct;
    return route;
}

/* The table: entry VM_ROUTE_... */
VM_API vmi_osc_route vmi_osc_route_of(int route)
{
    const vmi_osc_method variation = vmi_osc_method_rk45(vmi_osc_variation_rhs);
    const vmi_osc_method rk45_direct = vmi_osc_method_rk45(vmi_osc_direct_rhs);
    const vmi_osc_method rk87_direct = vmi_osc_method_rk87(vmi_osc_direct_rhs);
    switch (route) {
    case VM_ROUTE_TRIG: return vmi_osc_route_averaged("trigonometric", vmi_osc_first_order, vmi_osc_averaged_rhs);
    case VM_ROUTE_JACOBI: return vmi_osc_route_averaged("Jacobi", vmi_osc_first_order, vmi_osc_averaged_rhs);
    case VM_ROUTE_ATEB: return vmi_osc_route_averaged("Ateb, first order", vmi_osc_first_order, vmi_osc_averaged_rhs);
    case VM_ROUTE_SECOND: return vmi_osc_route_averaged("second-order law", vmi_osc_second_order, NULL);
    case VM_ROUTE_VARIATION: return vmi_osc_route_integrated("variation of constants, rk45", variation, 0);
    case VM_ROUTE_RK45: return vmi_osc_route_integrated("direct, rk45", rk45_direct, 1);
    case VM_ROUTE_RK87: return vmi_osc_route_integrated("direct, rk87", rk87_direct, 1);
    default: return vmi_osc_route_averaged("unknown route", NULL, NULL);
    }
}

/* Name of a route VM_ROUTE_..., in English; "unknown route" for any other number. */
VM_API const char *vm_osc_route_name(int route) { return vmi_osc_route_of(route).name; }

/* -- One route -- */

/* Checks the arguments that all calls share, but for the problem */
VM_API int vmi_osc_check_arguments(int route, vm_real t, vm_real tolerance, const vm_osc_motion *motion)
{
    if (!motion || route < VM_ROUTE_TRIG || route > VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(tolerance)) return VM_NOT_FINITE;
    if (tolerance < 0) return VM_DOMAIN;
    return VM_OK;
}

/* Checks what all calls with a plan share, and puts the default for a tolerance of 0 */
VM_API int vmi_osc_check_call(const vm_osc_plan *p, int route, vm_real t, vm_real *tolerance,
                              const vm_osc_motion *motion)
{
    const int status = vmi_osc_check_arguments(route, t, *tolerance, motion);
    if (!p) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return status;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    return vmi_first_error(status, vmi_osc_check_laws(&p->problem, t));
}

/* The motion of a body at rest at x = 0: none, unless a force starts one, of which no route knows */
VM_API int vmi_osc_at_rest(const vm_osc_plan *p, int route, vm_osc_motion *motion)
{
    if (p->problem.force) return VM_NO_LAW;
    motion->x = 0;
    motion->v = 0;
    motion->amplitude = 0;
    motion->error = 0;
    motion->route = route;
    motion->evals = 0;
    return VM_OK;
}

/* Motion x(t), x'(t) at time t (s, either sign) by a given route, from a plan.
   route: VM_ROUTE_.... motion->error estimates the larger of |error of x|/A and |error of v|/vmax. tolerance is of
   the same number, for routes that integrate: 0 means 1e-6 (float 1e-3). See above for what a route costs.
   VM_TOLERANCE_MISSED: x and v are there, but the error of integration is larger than the tolerance. Errors leave
   *motion untouched: VM_BAD_ARGUMENT (null pointers, no such route), VM_NOT_FINITE, VM_BAD_MASS and VM_BAD_STIFFNESS
   (a law that is not positive between 0 and t), VM_DOMAIN (a negative tolerance, t outside a table, a table out of
   order, the function of a law fails, a change_time that is negative or too short), VM_NO_LAW (second-order law
   with F; F on a body at rest at x = 0), VM_NOT_INTEGRATED (the integrator gave up, or would need 2^13 steps a
   period, four times what its longest step asks for, or 2^23 of the present periods: so every call ends). */
VM_API int vm_osc_plan_by_route(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_route entry;
    vmi_osc_mean mean;
    vmi_osc_wave w;
    int status = vmi_osc_check_call(p, route, t, &tolerance, motion);
    if (status) return status;
    entry = vmi_osc_route_of(route);
    if (p->problem.force && !entry.method.rhs) return VM_NO_LAW;
    if (p->A == 0) return vmi_osc_at_rest(p, route, motion);
    if (p->problem.force || !entry.solution) return vmi_osc_integrate(p, route, &entry.method, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    w = vmi_osc_wave_of(p, route);
    return entry.solution(p, route, &w, &mean, motion);
}

/* -- The cheapest route -- */

/* The route that integrates where no averaged solution is good enough: rk87 only for odd alpha, where the elastic
   force has all derivatives at x = 0, so that rk87 holds its order, and where F, which may have none, is missing */
VM_API int vmi_osc_integrator(const vm_osc_problem *o)
{
    const vm_real half = (o->alpha - 1) / 2;
    return !o->force && half == VM_FLOOR(half) ? VM_ROUTE_RK87 : VM_ROUTE_VARIATION;
}

/* Motion at any time t (s) by integration, as vm_osc_plan_within does where no averaged solution is good enough */
VM_API int vmi_osc_integrate_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const int route = vmi_osc_integrator(&p->problem);
    const vmi_osc_route entry = vmi_osc_route_of(route);
    return vmi_osc_integrate(p, route, &entry.method, t, tolerance, motion);
}

/* Motion x(t), x'(t) at time t (s, either sign) within a tolerance, from a plan.
   Takes the cheapest route whose error is estimated to be within the tolerance; motion->route says which. The
   tolerance is relative, of the larger of |error of x|/A and |error of v|/vmax: for x within d metres ask for d/A;
   0 means 1e-6 (float 1e-3). Statuses as in vm_osc_plan_by_route. */
VM_API int vm_osc_plan_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_mean mean;
    vmi_osc_wave w;
    vm_real first;
    int route, status = vmi_osc_check_call(p, VM_ROUTE_TRIG, t, &tolerance, motion);
    if (status) return status;
    if (p->A == 0) return vmi_osc_at_rest(p, VM_ROUTE_TRIG, motion);
    if (p->problem.force) return vmi_osc_integrate_within(p, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    first = vmi_osc_first_error(p, &mean);
    for (route = VM_ROUTE_TRIG; first <= tolerance; route++) { /* ends at VM_ROUTE_ATEB, whose wave has no error */
        w = vmi_osc_wave_of(p, route);
        if (first + vmi_osc_wave_error(&w, p->mean_ca2) <= tolerance)
            return vmi_osc_first_order(p, route, &w, &mean, motion);
    }
    if (!(vmi_osc_second_error(p, &mean) <= tolerance)) return vmi_osc_integrate_within(p, t, tolerance, motion);
    w = vmi_osc_wave_of(p, VM_ROUTE_SECOND);
    return vmi_osc_second_order(p, VM_ROUTE_SECOND, &w, &mean, motion);
}

/* -- Without a plan -- */

/* The plan of a problem that is asked once, without the plan of the Ateb functions, which only many values repay */
VM_API int vmi_osc_once(const vm_osc_problem *problem, vm_osc_plan *plan)
{
    int status;
    if (!problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(plan, problem);
    if (status) return status;
    return vmi_osc_start(plan);
}

/* Motion x(t), x'(t) at time t (s, either sign) by a given route.
   For one time of a problem. Arguments, result and statuses of vm_osc_plan_by_route, and the statuses of
   vm_osc_plan_init. */
VM_API int vm_osc_by_route(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance,
                           vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_check_arguments(route, t, tolerance, motion);
    status = vmi_first_error(status, vmi_osc_once(problem, &plan));
    if (status) return status;
    return vm_osc_plan_by_route(&plan, route, t, tolerance, motion);
}

/* Motion x(t), x'(t) at time t (s, either sign) within a tolerance.
   For one time of a problem, by the cheapest route. Arguments, result and statuses of vm_osc_plan_within, and the
   statuses of vm_osc_plan_init. */
VM_API int vm_osc_within(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_check_arguments(VM_ROUTE_TRIG, t, tolerance, motion);
    status = vmi_first_error(status, vmi_osc_once(problem, &plan));
    if (status) return status;
    return vm_osc_plan_within(&plan, t, tolerance, motion);
}

#endif
