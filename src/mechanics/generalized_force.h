/* mechanics/generalized_force.h - generalized forces of forces and moments

   What a force and a moment do in generalized coordinates (235): used by Lagrange's equations (mechanics/lagrange.h)
   and by their jumps (mechanics/lagrange_jump.h), where the "forces" are momenta and impulses.

       vm_vec3 weight = {0, 0, VM_C(-9.8)}, no_moment = {0, 0, 0};
       vm_vec3 dr[1] = {{0, 0, 1}}; // dr/dq_0 of the point at which the weight acts
       vm_real Q[1] = {0};
       vm_lagrange_add_force(1, weight, dr, no_moment, NULL, Q); // Q[0] is -9.8

   Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_GENERALIZED_FORCE_H
#define VARMASS_MECHANICS_GENERALIZED_FORCE_H

#include "../base/real.h"
#include "vectors.h"

/* Adds the generalized forces of a force and a moment: Q_i += force dr/dq_i + moment domega/dq'_i (235).
   For outer loads give their resultant and moment; for a stream the force M' u at the point where it crosses and the
   moment M' kappa omega2. dr, domega and Q are arrays of n; without dr or domega their term is left out; without Q
   nothing is done. */
VM_API void vm_lagrange_add_force(int n, vm_vec3 force, const vm_vec3 *dr_or_NULL, vm_vec3 moment,
                                  const vm_vec3 *domega_or_NULL, vm_real *Q)
{
    int k;
    if (!Q) return;
    for (k = 0; k < n; k++) {
        vm_real sum = 0;
        if (dr_or_NULL) sum = vmi_dot(force, dr_or_NULL[k]);
        if (domega_or_NULL) sum += vmi_dot(moment, domega_or_NULL[k]);
        Q[k] += sum;
    }
}

#endif
