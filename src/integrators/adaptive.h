/* integrators/adaptive.h - adaptive runs: rk45 and rk87, whose steps keep a tolerance
   rk45 is Tsitouras' pair of orders 5 and 4 [1]. It takes six evaluations of f in a step, and none for states between
   steps. It is the pair to begin with, and the better one in float, for loose tolerances, for right-hand sides that are
   not smooth, and for many events. rk87 is Verner's pair of orders 8 and 7 [4]. It takes 13 evaluations in a step, and
   seven more for states between steps. It is the pair for a smooth f in double and small errors.

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

#define RK45_WORK(n) (10 * (n)) /* number of elements of the work of an rk45 with n components */
#define RK87_WORK(n) (24 * (n)) /* number of elements of the work of an rk87 with n components */

/* A run by rk87 has the options and the fields of a run by rk45, with the same meanings. */
typedef rk45_options rk87_options;
typedef rk45 rk87;

/* Options of rk45 with each zero replaced by its default, as rk45_init uses them. rtol becomes at least 16 VM_EPSILON.
   If options_or_NULL is NULL, all options have their defaults. */
VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL)
{
    const vmi_rk_pair pair = vmi_rk45_pair();
    return vmi_defaults(vmi_least_rtol(&pair), options_or_NULL);
}

/* Begins a run of y' = f(t, y) by rk45 from state y0 at time t0. y0 has n numbers, f receives the pointer ctx, and work
   has RK45_WORK(n) numbers and must exist as long as s. y0 and the options are copied, but not the arrays to which the
   options point. f is not evaluated yet. Returns ODE_OK, ODE_RTOL_RAISED, ODE_BAD_ARGUMENT or ODE_WORK_TOO_SMALL. */
VM_INLINE int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk45_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk45_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Begins a run of y' = f(t, y) by rk87, as rk45_init begins one by rk45. work has RK87_WORK(n) numbers, and rtol
   becomes at least 256 VM_EPSILON. */
VM_INLINE int rk87_init(rk87 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk87_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk87_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Continues a run of rk45 from another time or state, such as after a jump. The step size and the counters are kept. y
   has n numbers and may be s->y. If t is s->t, events that have just happened are not found again. Returns ODE_OK or
   ODE_BAD_ARGUMENT. */
VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* Continues a run of rk87 from another time or state, such as after a jump. All else is as in rk45_restart. */
VM_API int rk87_restart(rk87 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* One accepted step of rk45, or the part of it before an event that ends the step. The step goes forward if s->h is
   positive or 0, and backward if s->h is negative; s->h is at first the option h0. Returns a status. */
VM_INLINE int rk45_step(rk45 *s) { return vmi_step(s, VMI_RK45); }

/* One accepted step of rk87, or the part of it before an event that ends the step. All else is as in rk45_step. */
VM_INLINE int rk87_step(rk87 *s) { return vmi_step(s, VMI_RK87); }

/* Steps of rk45 to t_end exactly, forward or backward, or to an ODE_STOP event. Nothing changes if s->t is
   t_end. After an error s->t and s->y are those of the last accepted step. Returns a status. After ODE_MAX_STEPS, that
   is after options.max_steps attempts, another call continues the run. */
VM_INLINE int rk45_solve(rk45 *s, vm_real t_end) { return vmi_solve(s, VMI_RK45, t_end); }

/* Steps of rk87 to t_end exactly, forward or backward, or to an ODE_STOP event. All else is as in
   rk45_solve. */
VM_INLINE int rk87_solve(rk87 *s, vm_real t_end) { return vmi_solve(s, VMI_RK87, t_end); }

/* Steps of rk45 to t_end, with f and n named again so that f is inlined. The compiler inlines f if f and n are
   constants in this call; rk45_init may have been called anywhere. Returns ODE_BAD_ARGUMENT if f or n is not that of s;
   all else is as in rk45_solve. */
VM_INLINE int rk45_solve_with(rk45 *s, ode_rhs f, int n, vm_real t_end)
{
    return vmi_solve_with(s, VMI_RK45, f, n, t_end);
}

/* Steps of rk87 to t_end, with f and n named again so that f is inlined. All else is as in rk45_solve_with. */
VM_INLINE int rk87_solve_with(rk87 *s, ode_rhs f, int n, vm_real t_end)
{
    return vmi_solve_with(s, VMI_RK87, f, n, t_end);
}

/* State y(t) at a time t within the last step of rk45, accurate to order 4. y receives n numbers; f is not evaluated.
   Returns ODE_BAD_ARGUMENT if t is not between s->t_old and s->t. */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y) { return vmi_interpolate_ready(s, VMI_RK45, t, y); }

/* State y(t) at a time t within the last step of rk87, accurate to order 8. y receives n numbers. The first call after
   a step evaluates f seven times, unless t is s->t. Returns ODE_BAD_ARGUMENT if t is not between s->t_old and s->t.
   These evaluations may also give ODE_RHS_STOPPED (f stops the run) or ODE_NOT_FINITE, although the step itself has
   succeeded. */
VM_API int rk87_interpolate(rk87 *s, vm_real t, vm_real *y)
{
    if (!s || s->pair.method != VMI_RK87) return ODE_BAD_ARGUMENT;
    return vmi_interpolate(s, t, y);
}

#endif
