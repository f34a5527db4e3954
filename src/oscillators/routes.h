/* oscillators/routes.h - the motion x(t) of an oscillator at any time, by a given method or by the cheapest

   Ten methods, called routes, compute x(t) and x'(t), from a cosine to the integration of the equation of motion by
   rk87 (VM_ROUTE_... in oscillators/problem.h). vm_osc_within takes the cheapest route whose estimated error is within
   a tolerance. vm_osc_by_route takes the route that its argument names. vm_osc_plan_within and vm_osc_plan_by_route do
   this with a plan (oscillators/plan.h), which saves time if one problem is solved at many values of t. The shortest
   useful call:
       vm_osc_problem bucket = {1, vm_law_linear(10, -0.1), vm_law_linear(250, 0), 0, 0, 0.05, 0, NULL, NULL};
       vm_osc_motion motion;
       if (vm_osc_within(&bucket, 70, 1e-6, &motion) == VM_OK) printf("%g m\n", motion.x);
   Tests: tests/test_routes.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_ROUTES_H
#define VARMASS_OSCILLATORS_ROUTES_H

#include "../base/real.h"
#include "../base/status.h"
#include "collocation.h"
#include "integration.h"
#include "mean_motion.h"
#include "plan.h"
#include "problem.h"
#include "ripple.h"
#include "waves.h"

/* -- What each route costs, which route is chosen, what the estimate of the error covers, and how good it is --

   Cost. If the problem has no force F, the first seven routes (VM_ROUTE_TRIG to VM_ROUTE_ORDER5) are averaged solutions
   in closed form: they need one or two evaluations of sa and ca and the integrals of the laws of mass and stiffness,
   for every t and every tolerance. The last three routes integrate from 0 to t within the tolerance. Each of them makes
   pairs of runs until the error is within the tolerance. The second run of a pair is more accurate (rk45 and rk87 then
   use a stricter tolerance, collocation more points for each step), and the difference of the two results gives the
   error. With a force F the averaged equations of the first three routes are integrated numerically, too, and the
   routes VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5 do not exist. docs/cost.md has the times.

   Choice. vm_osc_within takes the first of the seven averaged solutions whose estimated error is within the tolerance;
   for the orders 2 to 5 the estimated error is multiplied by 1.5 before this comparison. If there is no such solution,
   or if there is a force F, it integrates numerically: by collocation (oscillators/collocation.h) if amplitude and
   phase describe the motion, otherwise by rk87.

   What the estimate of an averaged solution covers:
     - the terms that the solution leaves out, the error of cos and cn in place of ca, and rounding errors of the phase;
     - fast changes of mass and stiffness between 0 and t. The integration along the laws looks for such changes on each
       panel, a short interval of time, and in tables between the points (for users' functions see vm_law_user). A fast
       change makes the estimate large, so that vm_osc_within integrates numerically. If the law is a user's function,
       no step of this integration is longer than half the shortest panel or |t|/4096, whichever is longer. If its field
       change_time is set, no step is longer than twice this time.
   What the estimate covers where averaged equations with a force F are integrated:
     - the error of this integration, and the error of cos and cn in place of ca;
     - what averaging leaves out: the ripple within a period, the effect of the ripple at t = 0, and the terms of the
       ripple of second order.
     - a force that changes within a period, as in a resonance. To find such changes, the function F is called over one
       period at the start and over one period at each of eight later times. Therefore the estimate misses a force that
       acts only for a short time between these periods.

   How good the estimate is. tests/test_routes.c compares the estimate with the true error of random problems. In these
   problems alpha is from 1/8 to 8, the relative rate q of change of mass and stiffness from 2e-3 to 0.1, and t from 1/q
   to 3/q. In double the test demands these bounds:
     - the true error is above 3 times the estimate in at most 1 % of the problems for vm_osc_within, 4 % for rk87, and
       2 % for all other routes.
     - the true error is at most 30 times the estimate for rk87, 40 times for rk45, and 10 times for all other routes.
     - the median of estimate/(true error) is at most 55 for collocation, 25 for rk87, 13 for rk45, 15 for orders 4 and
       5 and for averaged solutions with F, and 10 for all other routes.
   The estimate is worse for rk87, because the errors of rk87 are not proportional to its tolerance if alpha is not an
   odd integer. */

/* -- The table of routes -- */

/* A function that computes the motion at t from the mean motion *mean at t, for a problem without a force */
typedef int (*vmi_osc_solution)(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                                vm_osc_motion *motion);

/* A function that computes the motion at t by numerical integration from 0 to t, within a tolerance */
typedef int (*vmi_osc_integration)(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance,
                                   vm_osc_motion *motion);

/* Integrates the averaged equations numerically. A problem with a force F needs this function, since with F there is no
   solution in closed form. */
VM_API int vmi_osc_integrate_averaged(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance,
                                      vm_osc_motion *motion)
{
    vmi_osc_method method = vmi_osc_method_rk45(vmi_osc_averaged_rhs);
    method.averaged = 1;
    return vmi_osc_integrate(p, route, &method, t, tolerance, motion);
}

/* Integrates the equation of motion by rk45. */
VM_API int vmi_osc_integrate_rk45(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_method method = vmi_osc_method_rk45(vmi_osc_direct_rhs);
    method.direct = 1;
    return vmi_osc_integrate(p, route, &method, t, tolerance, motion);
}

/* Integrates the equation of motion by rk87. */
VM_API int vmi_osc_integrate_rk87(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_method method = vmi_osc_method_rk87(vmi_osc_direct_rhs);
    method.direct = 1;
    return vmi_osc_integrate(p, route, &method, t, tolerance, motion);
}

/* A route. If the problem has no force F and the route has a solution in closed form, the route uses this solution;
   otherwise it integrates numerically. */
typedef struct VM_TAG(vmi_osc_route) {
    const char *name;
    vmi_osc_solution solution;     /* the solution in closed form, or null if there is none */
    vmi_osc_integration integrate; /* the integration, or null if there is none */
} vmi_osc_route;

/* Makes the entry of a route in the table of routes. `solution` or `integrate` may be null, if the route has none. */
VM_API vmi_osc_route vmi_osc_route_by(const char *name, vmi_osc_solution solution, vmi_osc_integration integrate)
{
    vmi_osc_route route;
    route.name = name;
    route.solution = solution;
    route.integrate = integrate;
    return route;
}

/* Returns the entry of the table of routes for `route`, a VM_ROUTE_ constant. */
VM_API vmi_osc_route vmi_osc_route_of(int route)
{
    switch (route) {
    case VM_ROUTE_TRIG: return vmi_osc_route_by("trigonometric", vmi_osc_first_order, vmi_osc_integrate_averaged);
    case VM_ROUTE_JACOBI: return vmi_osc_route_by("Jacobi", vmi_osc_first_order, vmi_osc_integrate_averaged);
    case VM_ROUTE_ATEB: return vmi_osc_route_by("Ateb, first order", vmi_osc_first_order, vmi_osc_integrate_averaged);
    case VM_ROUTE_ORDER2: return vmi_osc_route_by("law of order two", vmi_osc_order_n, NULL);
    case VM_ROUTE_ORDER3: return vmi_osc_route_by("law of order three", vmi_osc_order_n, NULL);
    case VM_ROUTE_ORDER4: return vmi_osc_route_by("law of order four", vmi_osc_order_n, NULL);
    case VM_ROUTE_ORDER5: return vmi_osc_route_by("law of order five", vmi_osc_order_n, NULL);
    case VM_ROUTE_COLLOCATION: return vmi_osc_route_by("collocation", NULL, vmi_osc_collocate);
    case VM_ROUTE_RK45: return vmi_osc_route_by("direct, rk45", NULL, vmi_osc_integrate_rk45);
    case VM_ROUTE_RK87: return vmi_osc_route_by("direct, rk87", NULL, vmi_osc_integrate_rk87);
    default: return vmi_osc_route_by("unknown route", NULL, NULL);
    }
}

/* Name of a route VM_ROUTE_..., in English; "unknown route" for any other number. */
VM_API const char *vm_osc_route_name(int route) { return vmi_osc_route_of(route).name; }

/* -- One route -- */

/* Checks those arguments that the functions with and without a plan have in common: the route, t, the tolerance and
   `motion`. */
VM_API int vmi_osc_check_arguments(int route, vm_real t, vm_real tolerance, const vm_osc_motion *motion)
{
    if (!motion || route < VM_ROUTE_TRIG || route > VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(tolerance)) return VM_NOT_FINITE;
    if (tolerance < 0) return VM_DOMAIN;
    return VM_OK;
}

/* Checks the arguments of the functions with a plan, and replaces a tolerance of 0 by the default. */
VM_API int vmi_osc_check_call(const vm_osc_plan *p, int route, vm_real t, vm_real *tolerance,
                              const vm_osc_motion *motion)
{
    const int status = vmi_osc_check_arguments(route, t, *tolerance, motion);
    if (!p) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return status;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    return vmi_first_error(status, vmi_osc_check_laws(&p->problem, t));
}

/* Writes the motion of a body at rest at x = 0, which stays at rest. With a force it returns VM_NO_LAW, since no route
   can compute the motion that the force starts. */
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

/* Motion x(t), x'(t) at time t (s, either sign) by a given route, from a plan. `route` is a VM_ROUTE_ constant.
   motion->error estimates the larger of |error of x|/A and |error of v|/vmax (see vm_osc_motion). Routes that integrate
   numerically keep the error of the integration within the tolerance; a tolerance of 0 means 1e-6 (float 1e-3). A
   comment at the start of oscillators/routes.h says what a route costs. Returns VM_OK, or VM_TOLERANCE_MISSED where x
   and v are computed but the error of integration is larger than the tolerance. After an error *motion is unchanged.
   The errors are
     VM_BAD_ARGUMENT for null pointers or a route that does not exist,
     VM_NOT_FINITE for a number that is infinite or NaN,
     VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive between 0 and t,
     VM_DOMAIN for a negative tolerance, t outside a table, a table whose times do not rise, a user's law that fails,
       or a change_time that is negative or too short,
     VM_NO_LAW for VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5 with a force F, and for all routes with F if x = v = 0 at t = 0,
     VM_NO_LAW for VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5, and VM_NOT_INTEGRATED for collocation, where the elastic force is
       so weak that the rate of the phase underflows, as for alpha = 5 and x = 1e-200 m (the routes of first order then
       leave the body where it is, and vm_osc_plan_within takes rk87 if their estimated error is too large),
     VM_NOT_INTEGRATED, for collocation only, where amplitude and phase do not describe the motion,
     VM_NOT_INTEGRATED where the integrator cannot reach t, where |t| is more than 2^23 of the present periods, or where
       there are too many steps: more than 2^13 in each period, plus four times the number of steps of the greatest
       length that is allowed.
   The limit of |t| and the limit of the number of steps guarantee that every call ends. */
VM_API int vm_osc_plan_by_route(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_route entry;
    vmi_osc_mean mean;
    vmi_osc_wave w;
    int status = vmi_osc_check_call(p, route, t, &tolerance, motion);
    if (status) return status;
    entry = vmi_osc_route_of(route);
    if (p->A == 0) return vmi_osc_at_rest(p, route, motion);
    if ((p->problem.force || p->start_order == 0) && !entry.integrate) return VM_NO_LAW;
    if (p->problem.force || !entry.solution) return entry.integrate(p, route, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    w = vmi_osc_wave_of(p, route);
    return entry.solution(p, route, &w, &mean, motion);
}

/* -- The cheapest route -- */

/* Writes the motion at t by the first of the routes VM_ROUTE_TRIG to VM_ROUTE_ORDER5 whose estimated error is within
   the tolerance; the estimates of VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5 are multiplied by `reserve` before. If there is no
   such route, it returns VM_TOLERANCE_MISSED and leaves *motion untouched. */
VM_API int vmi_osc_averaged_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_real reserve = VM_C(1.5); /* a factor on the estimate: in one of 400 cases the true error is larger than
                                          the estimate, by a factor of up to 1.9 */
    vmi_osc_mean mean;
    vmi_osc_wave w;
    vm_real first;
    int route, order, status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    first = vmi_osc_first_error(p, &mean);
    for (route = VM_ROUTE_TRIG; first <= tolerance; route++) { /* this loop ends at VM_ROUTE_ATEB at the latest, since
                                                                  ca has no error */
        w = vmi_osc_wave_of(p, route);
        if (first + vmi_osc_wave_error(&w, p->ripple.mean2) <= tolerance)
            return vmi_osc_first_order(p, route, &w, &mean, motion);
    }
    w = vmi_osc_wave_of(p, VM_ROUTE_ORDER5);
    for (order = 2; order <= p->start_order; order++)
        if (reserve * vmi_osc_order_error(p, order, &mean) <= tolerance)
            return vmi_osc_order_n(p, vmi_osc_route_of_order(order), &w, &mean, motion);
    return VM_TOLERANCE_MISSED;
}

/* Computes the motion at any time t (s) by numerical integration, for vm_osc_plan_within where no averaged solution is
   accurate enough: by collocation, or by rk87 where amplitude and phase do not describe the motion. If collocation and
   rk87 both miss the tolerance, the result with the smaller error is taken. */
VM_API int vmi_osc_integrate_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_motion direct;
    int direct_status, status = vmi_osc_collocate(p, VM_ROUTE_COLLOCATION, t, tolerance, motion);
    if (status == VM_NOT_INTEGRATED) return vmi_osc_integrate_rk87(p, VM_ROUTE_RK87, t, tolerance, motion);
    if (status != VM_TOLERANCE_MISSED) return status;
    direct_status = vmi_osc_integrate_rk87(p, VM_ROUTE_RK87, t, tolerance, &direct);
    if (direct_status < 0 || !(direct.error < motion->error)) return status;
    *motion = direct;
    return direct_status;
}

/* Motion x(t), x'(t) at time t (s, either sign) within a tolerance, from a plan. The function takes the cheapest route
   whose estimated error is within the tolerance; for VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5, 1.5 times the estimated error
   must be within it. motion->route is the route that was taken. The error is the larger of |error of x|/A and |error of
   v|/vmax (see vm_osc_motion). To keep the error of x below d metres, set the tolerance to d/A. A tolerance of 0 means
   1e-6 (float 1e-3). The statuses are those of vm_osc_plan_by_route. */
VM_API int vm_osc_plan_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    int status = vmi_osc_check_call(p, VM_ROUTE_TRIG, t, &tolerance, motion);
    if (status) return status;
    if (p->A == 0) return vmi_osc_at_rest(p, VM_ROUTE_TRIG, motion);
    if (p->problem.force) return vmi_osc_integrate_within(p, t, tolerance, motion);
    status = vmi_osc_averaged_within(p, t, tolerance, motion);
    if (status != VM_TOLERANCE_MISSED) return status;
    return vmi_osc_integrate_within(p, t, tolerance, motion);
}

/* -- Without a plan -- */

/* Makes the plan of a problem for one call. It does not make the plan of the Ateb functions, which saves time only for
   many calls. If `complete` is 1, it also makes the polynomials of the ripple, which the routes VM_ROUTE_ORDER3 to
   VM_ROUTE_ORDER5 and collocation need. */
VM_API int vmi_osc_once(const vm_osc_problem *problem, int complete, vm_osc_plan *plan)
{
    int status;
    if (!problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(plan, problem, 0);
    if (status) return status;
    if (complete) vmi_ripple_complete(&plan->ripple, 5);
    return vmi_osc_start(plan);
}

/* Computes x(t), x'(t) at time t (s, either sign) by a given route. Use this function for a single t; for several
   values of t make a plan. Arguments, result and statuses are those of vm_osc_plan_by_route; the function also returns
   the statuses of vm_osc_plan_init. */
VM_API int vm_osc_by_route(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance,
                           vm_osc_motion *motion)
{
    const int complete = route >= VM_ROUTE_ORDER3 && route <= VM_ROUTE_COLLOCATION;
    vm_osc_plan plan;
    int status = vmi_osc_check_arguments(route, t, tolerance, motion);
    status = vmi_first_error(status, vmi_osc_once(problem, complete, &plan));
    if (status) return status;
    return vm_osc_plan_by_route(&plan, route, t, tolerance, motion);
}

/* Computes x(t), x'(t) at time t (s, either sign) within a tolerance, by the cheapest route. Use this function for a
   single t; for several values of t make a plan. Arguments, result and statuses are those of vm_osc_plan_within; the
   function also returns the statuses of vm_osc_plan_init. */
VM_API int vm_osc_within(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_check_arguments(VM_ROUTE_TRIG, t, tolerance, motion);
    status = vmi_first_error(status, vmi_osc_once(problem, 0, &plan));
    if (!status) status = vmi_osc_check_call(&plan, VM_ROUTE_TRIG, t, &tolerance, motion);
    if (status) return status;
    if (plan.A == 0) return vmi_osc_at_rest(&plan, VM_ROUTE_TRIG, motion);
    if (!problem->force) {
        status = vmi_osc_averaged_within(&plan, t, tolerance, motion);
        if (status != VM_TOLERANCE_MISSED) return status;
    }
    vmi_ripple_complete(&plan.ripple, 5);
    status = vmi_osc_start(&plan);
    if (status) return status;
    return vm_osc_plan_within(&plan, t, tolerance, motion);
}

#endif
