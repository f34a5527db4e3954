/* oscillators/routes.h - routes to x(t), and the cheapest within a tolerance */
#ifndef VARMASS_OSCILLATORS_ROUTES_H
#define VARMASS_OSCILLATORS_ROUTES_H

#include "../base/real.h"
#include "../base/status.h"
#include "integration.h"
#include "laws.h"
#include "mean_laws.h"
#include "problem.h"
#include "walk.h"
#include "waves.h"

/* -- By a given route, and by the cheapest -- */
VM_API int vmi_osc_arguments(const vm_osc_plan *p, vm_real t, vm_real *tolerance, const vm_osc_motion *motion)
{
    int status;
    if (!p || !motion) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(*tolerance)) return VM_NOT_FINITE;
    if (*tolerance < 0) return VM_BAD_ARGUMENT;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    status = vmi_law_check(&p->problem.mass, t);
    return status ? status : vmi_law_check(&p->problem.stiffness, t);
}

/* No motion, and nothing to start one */
VM_API int vmi_osc_at_rest(const vm_osc_plan *p, int route, vm_osc_motion *motion)
{
    if (p->problem.force) return VM_NO_LAW;
    motion->x = motion->v = motion->amplitude = motion->error = 0;
    motion->route = route;
    motion->evals = 0;
    return VM_OK;
}

/* Documented with vm_osc_plan_init. */
VM_API int vm_osc_plan_by_route(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_mean mean;
    vmi_osc_wave w;
    int status = vmi_osc_arguments(p, t, &tolerance, motion);
    if (status) return status;
    if (route < 0 || route > VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    if (p->problem.force && route == VM_ROUTE_SECOND) return VM_NO_LAW;
    if (p->A == 0) return vmi_osc_at_rest(p, route, motion);
    if (route > VM_ROUTE_SECOND || p->problem.force) return vmi_osc_integrate(p, route, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    w = vmi_osc_wave_of(route == VM_ROUTE_SECOND ? VM_ROUTE_ATEB : route, p->problem.alpha, p->pi,
                        p->has_ateb ? &p->ateb : NULL);
    return route == VM_ROUTE_SECOND ? vmi_osc_second_order(p, &w, &mean, motion)
                                    : vmi_osc_first_order(p, &w, &mean, motion);
}

/* Where no law is good enough: rk87, three times as fast, where it holds its order, which is where alpha is odd, so
   that the force has all derivatives at x = 0 */
VM_API int vmi_osc_integrator(vm_real alpha)
{
    const vm_real half = (alpha - 1) / 2;
    return half == VM_FLOOR(half) ? VM_ROUTE_RK87 : VM_ROUTE_VARIATION;
}

/* Documented with vm_osc_plan_init. */
VM_API int vm_osc_plan_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_mean mean;
    vmi_osc_wave w;
    vm_real first;
    int method, status = vmi_osc_arguments(p, t, &tolerance, motion);
    if (status) return status;
    if (p->A == 0) return vmi_osc_at_rest(p, VM_ROUTE_TRIG, motion);
    if (p->problem.force) return vmi_osc_integrate(p, VM_ROUTE_VARIATION, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    first = vmi_osc_first_error(p, &mean);
    for (method = VM_ROUTE_TRIG; first <= tolerance; method++) { /* the Ateb functions' wave has no error */
        w = vmi_osc_wave_of(method, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
        if (first + vmi_osc_wave_error(p, &w) <= tolerance) return vmi_osc_first_order(p, &w, &mean, motion);
    }
    if (!(vmi_osc_second_error(p, &mean) <= tolerance))
        return vmi_osc_integrate(p, vmi_osc_integrator(p->problem.alpha), t, tolerance, motion);
    w = vmi_osc_wave_of(VM_ROUTE_ATEB, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    return vmi_osc_second_order(p, &w, &mean, motion);
}

/* The plan of a problem that is asked once, without what only many values repay */
VM_API int vmi_osc_once(const vm_osc_problem *problem, vm_osc_plan *plan)
{
    int status = problem ? vmi_osc_prepare(plan, problem) : VM_BAD_ARGUMENT;
    return status ? status : vmi_osc_start(plan);
}

/* The same for a problem that is asked once */
VM_API int vm_osc_by_route(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_once(problem, &plan);
    return status ? status : vm_osc_plan_by_route(&plan, route, t, tolerance, motion);
}

/* Documented with vm_osc_by_route. */
VM_API int vm_osc_within(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_once(problem, &plan);
    return status ? status : vm_osc_plan_within(&plan, t, tolerance, motion);
}

#endif
