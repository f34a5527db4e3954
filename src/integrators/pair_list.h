/* integrators/pair_list.h - the list of the Runge-Kutta pairs
   These functions tell the pairs apart by their number, `method`; all others work for any pair. Where method is a
   constant, as in the loop over the steps, the compiler leaves nothing of the choice.

   Tests: tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_PAIR_LIST_H
#define VARMASS_INTEGRATORS_PAIR_LIST_H

#include "../base/real.h"
#include "options.h"
#include "pairs.h"
#include "rk45_pair.h"
#include "rk87_pair.h"
#include "runs.h"

#define VMI_MOST_OWN 14 /* the most k_i that a step of any pair makes, without those of the continuous extension */

/* The descriptor of a pair */
VMI_FOLDED vmi_rk_pair vmi_pair_of(int method)
{
    switch (method) {
    case VMI_RK87: return vmi_rk87_pair();
    case VMI_RK45:
    default: return vmi_rk45_pair();
    }
}

/* Stages 2, 3 ... of a step from t to t_new = t + h: part VMI_Z becomes the new state. Returns what f returns. */
VMI_FOLDED int vmi_make_stages(int method, vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    switch (method) {
    case VMI_RK87: return vmi_rk87_stages(sys, t, t_new, h, evals);
    case VMI_RK45:
    default: return vmi_rk45_stages(sys, t, t_new, h, evals);
    }
}

/* The largest error of a component over its tolerance; NaN where anything is not finite */
VMI_FOLDED vm_real vmi_step_error(int method, const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    switch (method) {
    case VMI_RK87: return vmi_rk87_error(o, sys, h);
    case VMI_RK45:
    default: return vmi_rk45_error(o, sys, h);
    }
}

#endif
