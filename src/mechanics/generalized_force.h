/* mechanics/generalized_force.h - generalised forces */
#ifndef VARMASS_MECHANICS_GENERALIZED_FORCE_H
#define VARMASS_MECHANICS_GENERALIZED_FORCE_H

#include "../base/real.h"
#include "vectors.h"

/* Q_i += force dr/dq_i + moment domega/dq'_i, i < n (235): of outer loads F, M; of streams M' u at the point where
   they cross, and M' kappa omega2. dr or domega may be null: no part of it. */
VM_API void vm_lagrange_add_force(int n, vm_vec3 force, const vm_vec3 *dr, vm_vec3 moment, const vm_vec3 *domega, vm_real *Q)
{
    if (!Q) return;
    int k;
    for (k = 0; k < n; k++) Q[k] += (dr ? vmi_dot(force, dr[k]) : 0) + (domega ? vmi_dot(moment, domega[k]) : 0);
}

#endif
