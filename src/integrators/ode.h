/* integrators/ode.h - ordinary differential equations y' = f(t, y): right-hand sides and statuses
   This file defines the type of every right-hand side f, and the statuses: the numbers by which the functions rk4_...,
   rk45_... and rk87_... report success or an error.

       #include "integrators.h"
       static int spring(double t, const double *y, double *dydt, void *ctx) // x'' = -x as y = (x, x')
       {
           (void)t;
           (void)ctx;
           dydt[0] = y[1];
           dydt[1] = -y[0];
           return 0;
       }
       int main(void)
       {
           double y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
           return rk4_solve(spring, NULL, 2, &t, 10.0, 1000, y, work); // 1000 steps from t = 0 to 10
       }

   Tests: tests/test_rk4.c, tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_ODE_H
#define VARMASS_INTEGRATORS_ODE_H

#include "../base/real.h"

enum {
    ODE_OK = 0,          /* success */
    ODE_RTOL_RAISED = 1, /* the option rtol was too small for the method: rk45_init has raised it to 16 eps, or
                            rk87_init has raised it to 256 eps */
    ODE_EVENT = 2,       /* an event has ended the run: s->t, s->y are its time and state, s->event is its index */
    ODE_STIFF = 3,       /* success, but during this call stability, not the tolerance, came to limit the step size;
                            later calls return ODE_OK, and s->stiff remains 1 */
    /* An argument is wrong: a pointer is NULL, n or `steps` is not positive, or a time, a state (not in rk4), rtol,
       atol or h0 is not finite (t_end may be infinite if an event can end the run). Or an option is wrong: a component
       has no tolerance, an element of atol_each is negative, h_min is negative or above h_max, or an event has no g, a
       negative room or a negative stop_after. Or a time of output is outside the last step, or the listed times are not
       in order. Or a saved run does not fit, or the init function of another method made the rk45. */
    ODE_BAD_ARGUMENT = -1,
    ODE_RHS_STOPPED = -2, /* f returned a number other than 0, which is s->rhs_status */
    ODE_NOT_FINITE = -3,  /* f or the state is infinite or NaN even in the shortest step (rk4: in a step), or an event
                             function is NaN */
    /* The errors of two steps of the smallest size (h_min, or the resolution of t) were above the tolerance, and fewer
       than three steps lay between these two steps. Then f is singular there, or too stiff for the resolution of t. A
       run also ends with this status if h_max is less than the resolution of t, or if t_end is infinite and t reaches
       the largest number of the type. A jump of f does not end a run: s->missed counts it. */
    ODE_STEP_TOO_SMALL = -4,
    ODE_MAX_STEPS = -5,     /* max_steps attempts did not reach t_end; another call continues the run */
    ODE_WORK_TOO_SMALL = -6 /* an array is too short: work needs RK45_WORK(n) or RK87_WORK(n) numbers, a saved run
                               RK45_SAVED or RK87_SAVED bytes */
};

/* A function that writes the n derivatives f(t, y) to dydt and returns 0, or any other number to stop the run. ctx is
   the pointer that the caller gave to the integrator. */
typedef int (*ode_rhs)(vm_real t, const vm_real *y, vm_real *dydt, void *ctx);

/* Text that describes a status of the integrators. */
VM_API const char *ode_strerror(int status)
{
    switch (status) {
    case ODE_OK: return "success";
    case ODE_RTOL_RAISED: return "rtol was raised to what the type can hold";
    case ODE_EVENT: return "a terminal event";
    case ODE_STIFF: return "success, but the equations look stiff";
    case ODE_BAD_ARGUMENT: return "bad argument";
    case ODE_RHS_STOPPED: return "the right-hand side stopped the run";
    case ODE_NOT_FINITE: return "the right-hand side, the state or an event function is not finite";
    case ODE_STEP_TOO_SMALL: return "the step size became too small";
    case ODE_MAX_STEPS: return "max_steps was reached";
    case ODE_WORK_TOO_SMALL:
        return "an array is too short: work needs RK45_WORK(n) or RK87_WORK(n) numbers, a saved run RK45_SAVED or "
               "RK87_SAVED bytes";
    default: return "unknown status";
    }
}

#endif
