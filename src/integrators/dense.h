/* integrators/dense.h - the solution inside a step */
#ifndef VARMASS_INTEGRATORS_DENSE_H
#define VARMASS_INTEGRATORS_DENSE_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"
#include "pairs.h"
#include "rk45_pair.h"
#include "rk87_pair.h"
#include "runs.h"

/* y at t_old + x h, 0 <= x <= 1. The weights add up to x, so those of the differences to k_1 do as well, with less
   rounding. Not inlined, so that it is contracted in one way only: the same x has the same y. */
VMI_APART void vmi_inside(const rk45 *s, int method, vm_real x, vm_real *y)
{
    const vm_real *y_old = vmi_part(s, VMI_Y_OLD), *k1 = vmi_part(s, VMI_K);
    vm_real b[21];
    int i, j, count = method == VMI_RK45 ? vmi_rk45_weights(x, b) : vmi_rk87_weights(x, b);
    for (i = 0; i < s->n; i++) {
        vm_real sum = 0;
        for (j = 1; j < count; j++) sum += b[j] * (vmi_part(s, VMI_K + j)[i] - k1[i]);
        y[i] = y_old[i] + s->h_done * (x * k1[i] + sum);
    }
}

VM_API int vmi_within_last_step(const rk45 *s, int method, vm_real t)
{
    return s->method == method && ((s->t_old <= t && t <= s->t) || (s->t <= t && t <= s->t_old));
}

/* Where t, which is within the last step, is in it: 0 at its beginning, 1 at its end */
VM_API vm_real vmi_place_of(const rk45 *s, vm_real t)
{
    const vm_real x = ((t - s->t_old) - s->t_old_low) / s->h_done;
    if (x < 0) return 0;
    return VMI_SMALLER(x, VM_C(1.0));
}

/* y(t) for t within the last step, to about the step's own accuracy; refuses other t. */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y)
{
    if (!s || !y || !vmi_within_last_step(s, VMI_RK45, t)) return ODE_BAD_ARGUMENT;
    if (t == s->t) vmi_copy(s->n, s->y, y);
    else vmi_inside(s, VMI_RK45, vmi_place_of(s, t), y);
    return ODE_OK;
}

VM_API int rk87_interpolate(rk87 *s, vm_real t, vm_real *y)
{
    if (!s || !y || !vmi_within_last_step(s, VMI_RK87, t)) return ODE_BAD_ARGUMENT;
    if (t == s->t) {
        vmi_copy(s->n, s->y, y);
        return ODE_OK;
    }
    if (!s->extended) {
        int status = vmi_rk87_extend(s);
        if (status) return status;
    }
    vmi_inside(s, VMI_RK87, vmi_place_of(s, t), y);
    return ODE_OK;
}

#endif
