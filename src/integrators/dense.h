/* integrators/dense.h - the solution inside the last step of an adaptive run
   The continuous extension of a step of rk45 or rk87 is a polynomial in time. It gives the state at any time within the
   step, to about the accuracy of the step itself. Users call rk45_interpolate and rk87_interpolate.

   Tests: tests/test_dense.c. */
#ifndef VARMASS_INTEGRATORS_DENSE_H
#define VARMASS_INTEGRATORS_DENSE_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"
#include "runs.h"

/* Computes the derivatives that the continuous extension of the last step needs, if they are not known yet. Returns a
   status. */
VM_API int vmi_extend(rk45 *s)
{
    int status = ODE_OK;
    if (!s->extended && s->pair.extend) status = s->pair.extend(s);
    if (status == ODE_OK) s->extended = 1;
    return status;
}

/* Computes the state y at the fraction x of the last step, 0 <= x <= 1. The derivatives that the continuous extension
   needs must be known (vmi_extend). */
VM_API void vmi_inside(const rk45 *s, vm_real x, vm_real *y) { s->pair.inside(s, x, y); }

/* Returns 1 if the time t is within the last step or at one of its ends, else 0. */
VM_API int vmi_is_in_last_step(const rk45 *s, vm_real t)
{
    return (s->t_old <= t && t <= s->t) || (s->t <= t && t <= s->t_old);
}

/* Returns the fraction of the last step at which the time t lies: 0 at the beginning of the step, 1 at its end */
VM_API vm_real vmi_place_of(const rk45 *s, vm_real t)
{
    const vm_real x = ((t - s->t_old) - s->t_old_low) / s->h_done;
    if (x < 0) return 0;
    return VMI_SMALLER(x, VM_C(1.0));
}

/* Computes the state y at a time t within the last step of a run by the pair whose number is `method`. The derivatives
   that the continuous extension needs must be known (vmi_extend). Returns a status. */
VM_API int vmi_interpolate_ready(const rk45 *s, int method, vm_real t, vm_real *y)
{
    if (!s || !y || s->pair.method != method || !vmi_is_in_last_step(s, t)) return ODE_BAD_ARGUMENT;
    if (t == s->t) vmi_copy(s->n, s->y, y);
    else vmi_inside(s, vmi_place_of(s, t), y);
    return ODE_OK;
}

/* Computes the state y at a time t within the last step of a run by any pair. At the time s->t the function needs no
   evaluation of f. Returns a status. */
VM_API int vmi_interpolate(rk45 *s, vm_real t, vm_real *y)
{
    if (!y || !vmi_is_in_last_step(s, t)) return ODE_BAD_ARGUMENT;
    if (t != s->t) {
        const int status = vmi_extend(s);
        if (status) return status;
    }
    return vmi_interpolate_ready(s, s->pair.method, t, y);
}

#endif
