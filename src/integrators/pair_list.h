/* integrators/pair_list.h - the list of the Runge-Kutta pairs
   The functions of this file choose a pair by its number, `method`. All other functions of the integrators work for any
   pair. Where method is a constant, as in the loop over the steps, the compiler removes the choice.

   Tests: tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_PAIR_LIST_H
#define VARMASS_INTEGRATORS_PAIR_LIST_H

#include "../base/real.h"
#include "options.h"
#include "pairs.h"
#include "rk45_pair.h"
#include "rk87_pair.h"
#include "runs.h"

#define VMI_MOST_OWN 14 /* the largest number of k_i in a step of any pair, without those of the continuous extension */

/* The descriptor of the pair with the number `method` */
VMI_FOLDED vmi_rk_pair vmi_pair_of(int method)
{
    switch (method) {
    case VMI_RK87: return vmi_rk87_pair();
    case VMI_RK45:
    default: return vmi_rk45_pair();
    }
}

/* Computes stages 2, 3 ... of a step from t to t_new = t + h, after which the part VMI_Z of work is the new state. Adds
   the number of evaluations of f to *evals. Returns 0, or the number with which f has stopped the run. */
VMI_FOLDED int vmi_make_stages(int method, vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    switch (method) {
    case VMI_RK87: return vmi_rk87_stages(sys, t, t_new, h, evals);
    case VMI_RK45:
    default: return vmi_rk45_stages(sys, t, t_new, h, evals);
    }
}

/* The largest ratio of the error of a component to its tolerance in a step of size h, or NaN if the error or the new
   state is not finite */
VMI_FOLDED vm_real vmi_step_error(int method, const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    switch (method) {
    case VMI_RK87: return vmi_rk87_error(o, sys, h);
    case VMI_RK45:
    default: return vmi_rk45_error(o, sys, h);
    }
}

#endif
