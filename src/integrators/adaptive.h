/* integrators/adaptive.h - adaptive runs: rk45 and rk87, whose steps keep a tolerance
   rk45 is Tsitouras' pair of orders 5 and 4 [1]: six evaluations of f in a step, and none for states between steps. It
   is the pair to begin with, and the better one in float, for loose tolerances, for right-hand sides that are not
   smooth, and for many events. rk87 is Verner's pair of orders 8 and 7 [4]: 13 evaluations in a step, and seven more
   for states between steps. It is the pair for a smooth f in double and small errors.

       double y0[2] = {1, 0}, work[RK45_WORK(2)];
       rk45 s;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       if (rk45_solve(&s, 10.0) >= 0) printf("x(10) = %g\n", s.y[0]);

   Tests: tests/test_adaptive.c, tests/test_dense.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_ADAPTIVE_H
#define VARMASS_INTEGRATORS_ADAPTIVE_H

#include "../base/real.h"
#include "dense.h"
#include "loop.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "rk45_pair.h"
#include "rk87_pair.h"
#include "runs.h"

#define RK45_WORK(n) (10 * (n)) /* how many numbers the work of an rk45 with n components has */
#define RK87_WORK(n) (24 * (n)) /* how many numbers the work of an rk87 with n components has */

/* All options and fields mean for rk87 what they mean for rk45. */
typedef rk45_options rk87_options;
typedef rk45 rk87;

/* The options with their defaults in place of zeros, as rk45_init takes them. rtol becomes at least 16 eps. NULL means
   all defaults. */
VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL)
{
    const vmi_rk_pair pair = vmi_rk45_pair();
    return vmi_defaults(vmi_least_rtol(&pair), options_or_NULL);
}

/* Begins a run of y' = f(t, y) by rk45 from state y0 at time t0. y0 has n numbers; f gets ctx. work has RK45_WORK(n)
   numbers and must live as long as s. y0 is copied, and so are the options, but not what they point at. f is not
   evaluated yet. Returns ODE_OK, ODE_RTOL_RAISED, ODE_BAD_ARGUMENT or ODE_WORK_TOO_SMALL. */
VM_INLINE int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk45_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk45_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Begins a run by rk87, as rk45_init does by rk45. work has RK87_WORK(n) numbers; rtol is at least 256 eps. */
VM_INLINE int rk87_init(rk87 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk87_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk87_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Goes on with rk45 from another time or state, such as after a jump. The step size and the counters are kept. y, n
   numbers, may be s->y. If t is s->t, events that have just happened are not found again. Returns ODE_OK or
   ODE_BAD_ARGUMENT. */
VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* Goes on with rk87 from another time or state, as rk45_restart does with rk45. */
VM_API int rk87_restart(rk87 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* One accepted step of rk45, or less of it, up to an event that ends it. The direction is the sign of s->h, which at
   first is that of the option h0: forward unless it is negative. Returns a status. */
VM_INLINE int rk45_step(rk45 *s) { return vmi_step(s, VMI_RK45); }

/* One accepted step of rk87, as rk45_step makes one of rk45. */
VM_INLINE int rk87_step(rk87 *s) { return vmi_step(s, VMI_RK87); }

/* Steps of rk45 to t_end exactly, forward or backward, or to a terminal event. Nothing happens if s->t is t_end. After
   an error s->t and s->y are those of the last accepted step. Returns a status: ODE_MAX_STEPS after options.max_steps
   attempts, and another call goes on. */
VM_INLINE int rk45_solve(rk45 *s, vm_real t_end) { return vmi_solve(s, VMI_RK45, t_end); }

/* Steps of rk87 to t_end exactly, as rk45_solve makes them of rk45. */
VM_INLINE int rk87_solve(rk87 *s, vm_real t_end) { return vmi_solve(s, VMI_RK87, t_end); }

/* Steps of rk45 to t_end with f and n given once more, so that f is inlined. That takes constants in the call, but s
   may have been made anywhere. f and n have to be those of s, else the status is ODE_BAD_ARGUMENT. Everything else is
   as in rk45_solve. */
VM_INLINE int rk45_solve_with(rk45 *s, ode_rhs f, int n, vm_real t_end)
{
    return vmi_solve_with(s, VMI_RK45, f, n, t_end);
}

/* Steps of rk87 to t_end with f and n given once more, so that f is inlined, as in rk45_solve_with. */
VM_INLINE int rk87_solve_with(rk87 *s, ode_rhs f, int n, vm_real t_end)
{
    return vmi_solve_with(s, VMI_RK87, f, n, t_end);
}

/* The state y(t) at a time t within the last step of rk45, of order 4. y gets n numbers; f is not evaluated. A t that
   is not from s->t_old to s->t is ODE_BAD_ARGUMENT. */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y) { return vmi_interpolate_ready(s, VMI_RK45, t, y); }

/* The state y(t) at a time t within the last step of rk87, of order 8. y gets n numbers. The first use in a step
   evaluates f seven times, unless t is s->t. A t that is not from s->t_old to s->t is ODE_BAD_ARGUMENT. f may stop the
   run there, ODE_RHS_STOPPED, or not be finite, ODE_NOT_FINITE, though the step itself has succeeded. */
VM_API int rk87_interpolate(rk87 *s, vm_real t, vm_real *y)
{
    if (!s || s->pair.method != VMI_RK87) return ODE_BAD_ARGUMENT;
    return vmi_interpolate(s, t, y);
}

#endif
