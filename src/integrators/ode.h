/* integrators/ode.h - right-hand sides and statuses */
#ifndef VARMASS_INTEGRATORS_ODE_H
#define VARMASS_INTEGRATORS_ODE_H

#include <string.h>

#include "../base/bits.h"
#include "../base/real.h"

enum {
    ODE_OK = 0,
    ODE_RTOL_RAISED = 1, /* an init: rtol was less than the type can hold: 16 eps is used, by rk87 256 eps */
    ODE_EVENT = 2,       /* a terminal event: s->t, s->y are where it happened, s->event is its index */
    ODE_STIFF = 3,       /* t_end was reached, but for a while stability, not accuracy, held the steps short */
    /* n or steps <= 0, a null pointer, a component without tolerance, h_min < 0 or above h_max, a time, state or
       option that is not finite, a time outside the last step, an event without g, the other method's rk45 */
    ODE_BAD_ARGUMENT = -1,
    ODE_RHS_STOPPED = -2, /* f returned something else than 0 */
    ODE_NOT_FINITE = -3,  /* f or the state became infinite or NaN, however short the step; an event function NaN */
    /* Two steps of the smallest size (h_min, or what t can resolve) missed the tolerance, with fewer than three
       good steps between them: f is singular there, or too stiff for t. Or h_max is below what t can resolve. A
       jump of f does not end a run: see s->missed. */
    ODE_STEP_TOO_SMALL = -4,
    ODE_MAX_STEPS = -5,     /* max_steps attempts did not reach t_end; call again to go on */
    ODE_WORK_TOO_SMALL = -6 /* the option work_size is less than RK45_WORK(n) or RK87_WORK(n) */
};

/* dydt = f(t, y) */
typedef int (*ode_rhs)(vm_real t, const vm_real *y, vm_real *dydt, void *ctx);

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
    case ODE_WORK_TOO_SMALL: return "work is too small: it needs RK45_WORK(n) or RK87_WORK(n) numbers";
    default: return "unknown status";
    }
}

VM_INLINE vm_real vmi_pow_rough(vm_real x, vm_real p)
{
    const vm_real ln2 = VM_C(0.69314718055994531), middle = VM_C(0.043);
    vmi_signed_bits bits;
    vm_real v;
    memcpy(&bits, &x, sizeof x);
    v = ((vm_real)(bits - VMI_BITS_OF_1) + middle / VM_EPSILON) * (p * (ln2 / 16 * VM_EPSILON));
    v = 1 + v * (1 + v / 2);
    v *= v;
    v *= v;
    v *= v;
    v *= v;
    return v;
}

#endif
