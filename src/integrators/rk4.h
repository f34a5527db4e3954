/* integrators/rk4.h - the classical Runge-Kutta method with fixed steps */
#ifndef VARMASS_INTEGRATORS_RK4_H
#define VARMASS_INTEGRATORS_RK4_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "ode.h"

/* One step of size h (of either sign) from t: y becomes y(t + h). steps equal steps from *t to t_end, after which
   *t == t_end. Error O(h^4). On failure y (and *t) are those of the last complete step. */
#define RK4_WORK(n) (3 * (n))

/* The four stages of a step of h from y: leaves k_1 + 2 k_2 + 2 k_3 in sum and k_4 in k. Returns what f does. */
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

/* steps steps of h from *t, the state y or, where low is not null, y + low; w has 3 m numbers */
VM_INLINE int vmi_rk4_run(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y, vm_real *low,
                          vm_real *w, ptrdiff_t m)
{
    const vm_real t0 = *t, h_6 = h / 6;
    vm_real *k = w, *sum = w + m, *z = w + 2 * m;
    long step;
    int i, status = ODE_OK;
    for (step = 0; step < steps; step++) {
        vm_real bad = 0; /* x - x is 0 or NaN */
        if (vmi_rk4_stages(f, ctx, n, t0 + (vm_real)step * h, h, y, k, sum, z)) {
            status = ODE_RHS_STOPPED;
            break;
        }
        VMI_EACH(i, n)
        {
            if (low) {
                sum[i] = (h_6 * sum[i] + h_6 * k[i]) + low[i];
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
        if (low) VMI_EACH(i, n) low[i] = vmi_two_sum(y[i], sum[i]).lo;
        vmi_copy(n, z, y);
    }
    *t = t0 + (vm_real)step * h;
    return status;
}

/* The same in registers, where the compiler knows that n is small */
VM_INLINE int vmi_rk4_run_small(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y,
                                vm_real *low)
{
    vm_real w[3 * VMI_SMALL], y_here[VMI_SMALL], low_here[VMI_SMALL];
    int status;
    vmi_copy(n, y, y_here);
    if (low) vmi_copy(n, low, low_here);
    status = vmi_rk4_run(f, ctx, n, t, h, steps, y_here, low ? low_here : NULL, w, n);
    vmi_copy(n, y_here, y);
    if (low) vmi_copy(n, low_here, low);
    return status;
}

VM_INLINE int vmi_rk4(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y, vm_real *low,
                      vm_real *work)
{
    if (!f || n <= 0 || !y || !work || !VM_IS_FINITE(*t) || !VM_IS_FINITE(h)) return ODE_BAD_ARGUMENT;
    if (VMI_IS_SMALL(n)) return vmi_rk4_run_small(f, ctx, n, t, h, steps, y, low);
    return vmi_rk4_run(f, ctx, n, t, h, steps, y, low, work, n);
}

VM_INLINE int rk4_step(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, vm_real *y, vm_real *work)
{
    return vmi_rk4(f, ctx, n, &t, h, 1, y, NULL, work);
}

VM_INLINE int rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                        vm_real *work)
{
    int status;
    if (!t || steps <= 0 || !VM_IS_FINITE(t_end)) return ODE_BAD_ARGUMENT;
    status = vmi_rk4(f, ctx, n, t, (t_end - *t) / (vm_real)steps, steps, y, NULL, work);
    if (status == ODE_OK) *t = t_end;
    return status;
}

/* The same with y + y_low as the state (y_low: n values, zero at first), so that the roundings of millions of steps
   do not add up [3]. */
VM_INLINE int rk4_solve_compensated(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                                    vm_real *y_low, vm_real *work)
{
    int status;
    if (!t || steps <= 0 || !VM_IS_FINITE(t_end) || !y_low) return ODE_BAD_ARGUMENT;
    status = vmi_rk4(f, ctx, n, t, (t_end - *t) / (vm_real)steps, steps, y, y_low, work);
    if (status == ODE_OK) *t = t_end;
    return status;
}

#endif
