/* integrators/rk4.h - rk4: the classical Runge-Kutta method of order 4 with fixed steps
   A step takes four evaluations of f, and the error at the end of a run is proportional to h^4. Use rk4 where each
   step must take the same time, as in a control loop; rk45 needs less time for the same error.

       double y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
       int status = rk4_solve(spring, NULL, 2, &t, 10.0, 1000, y, work); // spring is the ode_rhs of ode.h; 1000 steps

   Tests: tests/test_rk4.c. */
#ifndef VARMASS_INTEGRATORS_RK4_H
#define VARMASS_INTEGRATORS_RK4_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "ode.h"

#define RK4_WORK(n) (3 * (n)) /* number of elements of the array work for n components */

/* Computes the four stages of a step of size h from the state y at t; k_1 ... k_4 are the values of f in these stages.
   The array `sum` becomes k_1 + 2 k_2 + 2 k_3, and the array k becomes k_4. The array z has the state at which f is
   evaluated. Returns 0, or the number with which f has stopped the run. */
VM_INLINE int vmi_rk4_stages(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, const vm_real *y, vm_real *k,
                             vm_real *sum, vm_real *z)
{
    int i, stopped = f(t, y, k, ctx);
    if (stopped) return stopped;
    VMI_EACH(i, n) {
        sum[i] = k[i];
        z[i] = y[i] + h / 2 * k[i];
    }
    stopped = f(t + h / 2, z, k, ctx);
    if (stopped) return stopped;
    VMI_EACH(i, n) {
        sum[i] += 2 * k[i];
        z[i] = y[i] + h / 2 * k[i];
    }
    stopped = f(t + h / 2, z, k, ctx);
    if (stopped) return stopped;
    VMI_EACH(i, n) {
        sum[i] += 2 * k[i];
        z[i] = y[i] + h * k[i];
    }
    return f(t + h, z, k, ctx);
}

/* Makes `steps` steps of size h from *t. If low_or_NULL is not NULL, the summation is compensated: the state is then
   the sum of the arrays y and low_or_NULL. w is a work array of 3 m numbers, m >= n. y and *t become the state and the
   time at the end of the last complete step. Returns a status. */
VM_INLINE int vmi_rk4_run(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y,
                          vm_real *low_or_NULL, vm_real *w, ptrdiff_t m)
{
    const vm_real t0 = *t, h_6 = h / 6;
    vm_real *k = w, *sum = w + m, *z = w + 2 * m;
    long step;
    int i, status = ODE_OK;
    for (step = 0; step < steps; step++) {
        vm_real bad = 0; /* becomes NaN if a component of z is not finite */
        if (vmi_rk4_stages(f, ctx, n, t0 + (vm_real)step * h, h, y, k, sum, z)) {
            status = ODE_RHS_STOPPED;
            break;
        }
        VMI_EACH(i, n)
        {
            if (low_or_NULL) {
                sum[i] = (h_6 * sum[i] + h_6 * k[i]) + low_or_NULL[i];
                z[i] = y[i] + sum[i];
            } else {
                z[i] = (y[i] + h_6 * sum[i]) + h_6 * k[i];
            }
            bad += z[i] - z[i];
        }
        if (bad != 0) {
            status = ODE_NOT_FINITE;
            break;
        }
        if (low_or_NULL) VMI_EACH(i, n) low_or_NULL[i] = vmi_two_sum(y[i], sum[i]).lo;
        vmi_copy(n, z, y);
    }
    *t = t0 + (vm_real)step * h;
    return status;
}

/* Does the work of vmi_rk4_run in local arrays, which the compiler keeps in registers if it knows that n is small */
VM_INLINE int vmi_rk4_run_small(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y,
                                vm_real *low_or_NULL)
{
    vm_real w[3 * VMI_SMALL], y_here[VMI_SMALL], low_here[VMI_SMALL];
    vm_real *low_here_or_NULL = low_or_NULL ? low_here : NULL;
    int status;
    vmi_copy(n, y, y_here);
    if (low_or_NULL) vmi_copy(n, low_or_NULL, low_here);
    status = vmi_rk4_run(f, ctx, n, t, h, steps, y_here, low_here_or_NULL, w, n);
    vmi_copy(n, y_here, y);
    if (low_or_NULL) vmi_copy(n, low_here, low_or_NULL);
    return status;
}

/* Checks the arguments of an rk4 function and makes the steps. Returns a status. */
VM_INLINE int vmi_rk4(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y, vm_real *low_or_NULL,
                      vm_real *work)
{
    if (!f || n <= 0 || !y || !work || !VM_IS_FINITE(*t) || !VM_IS_FINITE(h)) return ODE_BAD_ARGUMENT;
    if (VMI_IS_SMALL(n)) return vmi_rk4_run_small(f, ctx, n, t, h, steps, y, low_or_NULL);
    return vmi_rk4_run(f, ctx, n, t, h, steps, y, low_or_NULL, work, n);
}

/* Does the work of rk4_solve and of rk4_solve_compensated */
VM_INLINE int vmi_rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                            vm_real *low_or_NULL, vm_real *work)
{
    int status;
    if (!t || steps <= 0 || !VM_IS_FINITE(t_end)) return ODE_BAD_ARGUMENT;
    status = vmi_rk4(f, ctx, n, t, (t_end - *t) / (vm_real)steps, steps, y, low_or_NULL, work);
    if (status == ODE_OK) *t = t_end;
    return status;
}

/* Makes one step of size h, positive or negative, by the classical Runge-Kutta method. y has n numbers; it is the state
   at time t and becomes the state at t + h. f receives the pointer ctx; work has RK4_WORK(n) numbers. Returns ODE_OK;
   ODE_BAD_ARGUMENT if a pointer other than ctx is NULL, n is not positive, or t or h is not finite; ODE_RHS_STOPPED if
   f returns a number other than 0; ODE_NOT_FINITE if the new state is not finite. After an error y is unchanged. */
VM_INLINE int rk4_step(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, vm_real *y, vm_real *work)
{
    return vmi_rk4(f, ctx, n, &t, h, 1, y, NULL, work);
}

/* Makes `steps` equal steps from *t to t_end by the classical Runge-Kutta method. y has n numbers and becomes the state
   at t_end; *t becomes t_end exactly. If f stops the run or the state is not finite, y and *t are the state and the
   time at the end of the last complete step. Returns the same statuses as rk4_step, and ODE_BAD_ARGUMENT also if
   `steps` is not positive or t_end - *t overflows. */
VM_INLINE int rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                        vm_real *work)
{
    return vmi_rk4_solve(f, ctx, n, t, t_end, steps, y, NULL, work);
}

/* Makes equal steps with compensated summation [3], so that rounding errors do not add up. The steps are those of
   rk4_solve, but the state is y + y_low. y_low has n numbers, which the caller sets to zero before the first call. The
   summation takes additional time; use this function for runs of millions of steps. */
VM_INLINE int rk4_solve_compensated(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                                    vm_real *y_low, vm_real *work)
{
    if (!y_low) return ODE_BAD_ARGUMENT;
    return vmi_rk4_solve(f, ctx, n, t, t_end, steps, y, y_low, work);
}

#endif
