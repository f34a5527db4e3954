/* oscillators/odd_routes.h - vibration under an odd elastic force, by a given method or by the cheapest

   The methods that compute the motion are called routes. vm_odd_plan_by_route takes the route that its argument names.
   vm_odd_plan_within takes the cheapest route whose estimated error is within a tolerance, and vm_odd_within does so
   without a plan. oscillators/odd_motion.h has the problem and the averaged solutions, and shows the shortest useful
   call. vm_odd_rhs is the equation of motion. tests/test_odd_force.c compares the estimates with the true errors of
   random problems. The true error is below three times the estimate in 99 % of the problems, and never above ten times
   the estimate. If the force has a kink, as x + x|x| has, the integration needs very short steps. The integration may
   then miss tolerances below 1e-6. In this case the function returns VM_TOLERANCE_MISSED. Tests:
   tests/test_odd_force.c. */
#ifndef VARMASS_OSCILLATORS_ODD_ROUTES_H
#define VARMASS_OSCILLATORS_ODD_ROUTES_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/rk87.h"
#include "averaging.h"
#include "integration.h"
#include "laws.h"
#include "odd_force.h"
#include "odd_motion.h"

/* -- The equation of motion -- */

/* Writes the acceleration, m/s^2, at the time t, the position x and the velocity v. */
VM_API int vmi_odd_acceleration(const vm_odd_problem *o, vm_real t, int side, vm_real x, vm_real v, vm_real *a)
{
    vmi_odd_now now;
    vm_real f;
    int status = vmi_odd_read_laws(o, t, side, &now);
    if (!status) status = vmi_odd_elastic(o, &now, x, &f);
    if (status) return status;
    *a = -(now.k * f + (o->reactive * now.m_rate + now.b) * v) / now.m;
    return VM_OK;
}

/* Checks all laws at t. If several laws are wrong, it returns the status that comes first in the table of errors in
   src/base/status.h. */
VM_API int vmi_odd_statuses_at(const vm_odd_problem *o, vm_real t)
{
    const vm_law *laws[VMI_ODD_LAWS];
    int statuses[VMI_ODD_LAWS], i, status = VM_OK;
    const int n = vmi_odd_all_laws(o, laws, statuses);
    for (i = 0; i < n; i++) {
        vm_real f, rate;
        status = vmi_first_error(status, vmi_law_at(laws[i], statuses[i], t, &f, &rate));
    }
    return status;
}

/* Equation of motion of a vibration under an odd elastic force, for rk45 or rk87. The array y = (x, x') is in m and
   m/s. `problem` points to a vm_odd_problem, whose fields x and v are not used. Returns VM_BAD_ARGUMENT for null
   pointers and for a law or a force that no constructor made, VM_NOT_FINITE for a number that is infinite or NaN,
   VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive, and VM_DOMAIN for t outside a table
   and where a user's function fails. These statuses stop the integration. */
VM_API int vm_odd_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *problem)
{
    const vm_odd_problem *o = (const vm_odd_problem *)problem;
    vm_real a;
    int status;
    if (!y || !dydt || !o || !o->force.at) return VM_BAD_ARGUMENT;
    if (!vmi_odd_has_laws(o)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(y[0]) || !VM_IS_FINITE(y[1])) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(o->reactive)) return VM_NOT_FINITE;
    status = vmi_odd_acceleration(o, t, 1, y[0], y[1], &a);
    if (!status && !VM_IS_FINITE(a)) status = VM_NOT_FINITE;
    if (status) /* return the status that comes first in the table of errors in src/base/status.h */
        return vmi_first_error(status, vmi_odd_statuses_at(o, t));
    dydt[0] = y[1];
    dydt[1] = a;
    return VM_OK;
}

/* -- Integration -- */

/* One integration by rk87 from time 0 to t, called a run. Its two unknowns are x/length and v/velocity, so that both
   are of the order of 1. */
typedef struct VM_TAG(vmi_odd_run) {
    const vm_odd_plan *plan;
    int side;                 /* 1 forward, -1 backward in time */
    int status;               /* the status of a law or of the force that stopped the integration, or VM_OK */
    vm_real length, velocity; /* units of the state */
    vm_real longest;          /* longest step, s */
    long evals;               /* number of evaluations of the right-hand side by all runs so far */
    rk87 s;
    vm_real work[RK87_WORK(2)];
} vmi_odd_run;

/* Right-hand side of the equation of motion for a run, in the units of the run */
VM_API int vmi_odd_run_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *run)
{
    vmi_odd_run *c = (vmi_odd_run *)run;
    const vm_real v = c->velocity * y[1];
    vm_real a;
    c->status = vmi_odd_acceleration(&c->plan->problem, t, c->side, c->length * y[0], v, &a);
    if (c->status) return c->status;
    dydt[0] = v / c->length;
    dydt[1] = a / c->velocity;
    return VM_OK;
}

/* Chooses the units of x and v, and the longest step for an integration over `whole` seconds. */
VM_API void vmi_odd_units(vmi_odd_run *c, vm_real whole)
{
    const vm_odd_plan *p = c->plan;
    const vm_odd_problem *o = &p->problem;
    const vm_law *laws[VMI_ODD_LAWS];
    int statuses[VMI_ODD_LAWS], i;
    const int n = vmi_odd_all_laws(o, laws, statuses);
    c->longest = whole;
    c->length = VM_FABS(o->x);
    c->velocity = VM_FABS(o->v);
    if (p->start.size > 0) {
        c->length = vmi_orbit_amplitude(&p->start);
        c->velocity = p->start.vmax * p->speed0;
        c->longest = vmi_smaller(VMI_OSC_LONGEST * 2 * VM_PI / (p->start.w * p->speed0), whole);
    }
    if (!(c->length > 0)) c->length = c->velocity;
    if (!(c->velocity > 0)) c->velocity = c->length;
    for (i = 0; i < n; i++)
        if (laws[i]->function) c->longest = vmi_smaller(vmi_law_longest_panel(laws[i], whole) / 4, c->longest);
}

/* Integrates from the present time to t. The function restarts the integrator at every point of a table between these
   times. */
VM_API int vmi_odd_solve(vmi_odd_run *c, vm_real t)
{
    const vm_odd_problem *o = &c->plan->problem;
    while (c->s.t != t) {
        const vm_real stop = vmi_odd_next_knot(o, c->s.t, t);
        vm_real y[2];
        int status;
        status = rk87_solve(&c->s, stop);
        if (c->status) return c->status;
        if (status < 0) return VM_NOT_INTEGRATED;
        y[0] = c->s.y[0];
        y[1] = c->s.y[1];
        if (stop != t) status = rk87_restart(&c->s, stop, y);
        if (status < 0) return VM_NOT_INTEGRATED;
    }
    return VM_OK;
}

/* Writes the motion at the time that the run has reached, and the swing (half the distance between the turning points)
   and the largest velocity of the vibration at this time. Where there is no vibration, the amplitude is NaN, *swing is
   c->length and *vmax is c->velocity. */
VM_API int vmi_odd_motion_now(const vmi_odd_run *c, vm_odd_motion *motion, vm_real *swing, vm_real *vmax)
{
    const vm_odd_problem *o = &c->plan->problem;
    vm_odd_force force = o->force;
    vmi_odd_now now;
    vmi_orbit orbit;
    vm_real speed;
    int status = vmi_odd_read_laws(o, c->s.t, -c->side, &now);
    if (status) return status;
    speed = VM_SQRT(now.k / now.m);
    if (o->force.laws) { /* the orbit under the force that acts at this time */
        force.k1 = now.k1;
        force.k3 = now.k3;
    }
    motion->x = c->length * c->s.y[0];
    motion->v = c->velocity * c->s.y[1];
    motion->amplitude = VM_NAN;
    motion->error = VM_NAN;
    motion->route = VM_ODD_RK87;
    motion->evals = 0;
    *swing = c->length;
    *vmax = c->velocity;
    if (!VM_IS_FINITE(motion->x) || !VM_IS_FINITE(motion->v)) return VM_NOT_INTEGRATED;
    if (vmi_orbit_of_state(&force, motion->x, motion->v / speed, &orbit) || !(orbit.size > 0)) return VM_OK;
    motion->amplitude = vmi_orbit_amplitude(&orbit);
    *swing = orbit.swing;
    *vmax = orbit.vmax * speed;
    return VM_OK;
}

/* Makes one run from 0 to t. Writes the motions at the times of vmi_osc_check_time, with the swing (half the distance
   between the turning points) and the largest velocity of each. */
VM_API int vmi_odd_run_once(vmi_odd_run *c, vm_real t, vm_real tolerance, vm_odd_motion *motion, vm_real *swing,
                            vm_real *vmax)
{
    const vm_real most_steps = VM_C(4e6);
    const vm_real steps = 1000 + 400 * VM_FABS(t) / c->longest;
    rk45_options options;
    vm_real y[2];
    int i, status;
    memset(&options, 0, sizeof options);
    options.rtol = tolerance;
    options.atol = tolerance;
    options.h_max = c->longest;
    options.max_steps = (long)vmi_smaller(steps, most_steps);
    y[0] = c->plan->problem.x / c->length;
    y[1] = c->plan->problem.v / c->velocity;
    c->status = VM_OK;
    status = rk87_init(&c->s, vmi_odd_run_rhs, c, 2, 0, y, &options, c->work);
    if (c->status) return c->status;
    if (status < 0) return VM_NOT_INTEGRATED;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        status = vmi_odd_solve(c, vmi_osc_check_time(t, i));
        if (!status) status = vmi_odd_motion_now(c, &motion[i], &swing[i], &vmax[i]);
        if (status) return status;
    }
    c->evals += c->s.evals;
    return VM_OK;
}

/* Makes two runs, which are integrations from 0 to t: one with a loose tolerance and one with a strict tolerance and
   half the longest step. Writes the motion at t from the strict run. Its error is estimated from the largest difference
   between the two runs and from the strict tolerance. */
VM_API int vmi_odd_pair(vmi_odd_run *c, vm_real t, vm_real step_tolerance, vm_odd_motion *motion)
{
    const vmi_osc_tuning tuning = vmi_osc_method_rk87(vmi_odd_run_rhs).tuning;
    const vm_real longest = c->longest, turns = VM_FABS(t) * VMI_OSC_LONGEST * 2 * VM_PI / longest;
    vm_odd_motion loose[VMI_OSC_CHECKS], strict[VMI_OSC_CHECKS];
    vm_real swing[VMI_OSC_CHECKS], vmax[VMI_OSC_CHECKS], largest = 0, by_time;
    vmi_odd_now now;
    int i, status = vmi_odd_run_once(c, t, tuning.ratio * step_tolerance, loose, swing, vmax);
    if (!status) status = vmi_odd_read_laws(&c->plan->problem, t, -c->side, &now);
    if (status) return status;
    c->longest = longest / 2;
    status = vmi_odd_run_once(c, t, step_tolerance, strict, swing, vmax);
    c->longest = longest;
    if (status) return status;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        largest = vmi_larger(VM_FABS(strict[i].x - loose[i].x) / swing[i], largest);
        largest = vmi_larger(VM_FABS(strict[i].v - loose[i].v) / vmax[i], largest);
    }
    by_time = (VM_FABS(now.m_rate) + VM_FABS(now.b)) / now.m;
    by_time = vmi_osc_time_rounding(t, vmax[VMI_OSC_CHECKS - 1] / swing[VMI_OSC_CHECKS - 1], by_time);
    *motion = strict[VMI_OSC_CHECKS - 1];
    motion->error = vmi_larger(tuning.by_chance * step_tolerance, tuning.factor * largest) +
                    vmi_larger(by_time, 4 * VM_EPSILON * (2 + turns));
    return VM_OK;
}

/* Computes the motion at t by rk87. It makes at most eight pairs of integrations, called runs, with stricter and
   stricter tolerances, until the estimated error is within `tolerance`. If the error of a pair is not below half of the
   smallest error so far, the longest step is halved. After three such pairs no further pair is made. The result is that
   of the pair with the smallest error. */
VM_API int vmi_odd_integrate(const vm_odd_plan *p, vm_real t, vm_real tolerance, vm_odd_motion *motion)
{
    const int most_attempts = 8, most_stalled = 3;
    const vm_real least = vmi_osc_method_rk87(vmi_odd_run_rhs).tuning.least;
    vmi_odd_run c;
    vm_odd_motion now;
    vm_real step_tolerance = vmi_osc_first_tolerance(tolerance), best = VM_INFINITY;
    int attempt, stalled = 0, status = VM_NOT_INTEGRATED;
    c.plan = p;
    c.side = vmi_time_side(t);
    c.evals = 0;
    vmi_odd_units(&c, VM_FABS(t));
    for (attempt = 0; attempt < most_attempts && stalled < most_stalled; attempt++) {
        step_tolerance = vmi_larger(step_tolerance, least);
        status = vmi_odd_pair(&c, t, step_tolerance, &now);
        if (status) break;
        if (!(now.error < best / 2)) {
            stalled++;
            c.longest /= 2;
        }
        if (now.error < best) {
            *motion = now;
            best = now.error;
        }
        if (best <= tolerance) break;
        step_tolerance = vmi_osc_next_tolerance(step_tolerance, tolerance, now.error);
    }
    if (!(best < VM_INFINITY)) return status ? status : VM_NOT_INTEGRATED;
    motion->evals = c.evals;
    return best <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

/* -- Routes -- */

/* Checks the arguments that all functions with a plan have in common. A tolerance of 0 becomes the default, 1e-6 (float
   1e-3). */
VM_API int vmi_odd_check_call(const vm_odd_plan *p, int route, vm_real t, vm_real *tolerance,
                              const vm_odd_motion *motion)
{
    if (!p || !motion || route < VM_ODD_MEAN || route > VM_ODD_RK87) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(*tolerance)) return VM_NOT_FINITE;
    if (*tolerance < 0) return VM_DOMAIN;
    if (t * p->t_end < 0 || VM_FABS(t) > VM_FABS(p->t_end)) return VM_DOMAIN;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    return VM_OK;
}

/* Returns 1 and writes the motion if t is 0 or the body is at rest, so that nothing has to be computed; else returns
   0. */
VM_API int vmi_odd_is_known(const vm_odd_plan *p, int route, vm_real t, vm_odd_motion *motion)
{
    if (t != 0 && !p->at_rest) return 0;
    motion->x = p->problem.x;
    motion->v = p->problem.v;
    motion->amplitude = VM_NAN;
    if (p->at_rest) motion->amplitude = VM_FABS(p->problem.x);
    if (p->start.size > 0) motion->amplitude = vmi_orbit_amplitude(&p->start);
    motion->error = 0;
    motion->route = route;
    motion->evals = 0;
    return 1;
}

/* Motion under an odd elastic force at time t (s, between 0 and the plan's t_end) by a given route: VM_ODD_MEAN,
   VM_ODD_ORDER2 or VM_ODD_RK87. The field motion->error estimates the larger of |error of x|/swing and
   |error of v|/vmax, where swing is half the distance between the turning points of the vibration, and vmax its largest
   velocity. This estimate is infinite where the averaged solution is not valid. Only VM_ODD_RK87 uses `tolerance`, a
   bound for this error; 0 means 1e-6 (float 1e-3). Returns VM_OK, or VM_TOLERANCE_MISSED where the integration misses
   the tolerance. After an error *motion is unchanged. The errors are
     VM_BAD_ARGUMENT for null pointers or a route that does not exist,
     VM_NOT_FINITE for a number that is infinite or NaN,
     VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive between 0 and t,
     VM_DOMAIN for a negative tolerance, for t that is not between 0 and t_end, and where a user's function fails,
     VM_NO_LAW for t beyond the plan's field `reach` and where there is no vibration, but never for VM_ODD_RK87,
     VM_NOT_INTEGRATED where the integrator cannot reach t, for example because the motion becomes infinite. */
VM_API int vm_odd_plan_by_route(const vm_odd_plan *p, int route, vm_real t, vm_real tolerance, vm_odd_motion *motion)
{
    vm_odd_motion r;
    int status = vmi_odd_check_call(p, route, t, &tolerance, motion);
    if (status) return status;
    if (vmi_odd_is_known(p, route, t, &r)) status = VM_OK;
    else if (route == VM_ODD_RK87) status = vmi_odd_integrate(p, t, tolerance, &r);
    else status = vmi_odd_averaged(p, route, t, &r);
    if (status >= 0) *motion = r;
    return status;
}

/* Motion under an odd elastic force at time t (s, between 0 and the plan's t_end) within a tolerance.
   The function takes the cheapest route whose estimated error is within the tolerance; motion->route is this route. The
   error is the larger of |error of x|/swing and |error of v|/vmax, where swing is half the distance between the turning
   points of the vibration, and vmax its largest velocity. A tolerance of 0 means 1e-6 (float 1e-3). For t beyond the
   plan's field `reach` the function integrates by rk87. Returns the statuses of vm_odd_plan_by_route except
   VM_NO_LAW. */
VM_API int vm_odd_plan_within(const vm_odd_plan *p, vm_real t, vm_real tolerance, vm_odd_motion *motion)
{
    vm_odd_motion r;
    int route, status = vmi_odd_check_call(p, VM_ODD_MEAN, t, &tolerance, motion);
    if (status) return status;
    for (route = VM_ODD_MEAN; route <= VM_ODD_ORDER2; route++) {
        status = vm_odd_plan_by_route(p, route, t, tolerance, &r);
        if (status && status != VM_NO_LAW) return status;
        if (status || !(r.error <= tolerance)) continue;
        *motion = r;
        return VM_OK;
    }
    return vm_odd_plan_by_route(p, VM_ODD_RK87, t, tolerance, motion);
}

/* Motion under an odd elastic force at time t (s, either sign) within a tolerance, without a plan.
   Use this function for a single t; for several values of t make a plan. Arguments, result and statuses are those of
   vm_odd_plan_within and of vm_odd_plan_init. */
VM_API int vm_odd_within(const vm_odd_problem *problem, vm_real t, vm_real tolerance, vm_odd_motion *motion)
{
    vm_odd_plan plan;
    int status = VM_OK;
    if (!problem || !motion) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(tolerance)) status = VM_NOT_FINITE;
    else if (tolerance < 0) status = VM_DOMAIN;
    status = vmi_first_error(status, vm_odd_plan_init(&plan, problem, t));
    if (status) return status;
    return vm_odd_plan_within(&plan, t, tolerance, motion);
}

#endif
