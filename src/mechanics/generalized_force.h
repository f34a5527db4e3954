/* mechanics/generalized_force.h - generalized forces of forces and moments

   This chapter turns a force and a moment into generalized forces (235). Lagrange's equations (mechanics/lagrange.h)
   need them, and so do jumps (mechanics/lagrange_jump.h), where the "forces" are momenta and impulses.

       vm_vec3 weight = {0, 0, VM_C(-9.8)}, no_moment = {0, 0, 0};
       vm_vec3 dr[1] = {{0, 0, 1}}; // dr/dq_0 of the point at which the weight acts
       vm_real Q[1] = {0};
       vm_lagrange_add_force(1, weight, dr, no_moment, NULL, Q); // Q[0] is -9.8

   Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_GENERALIZED_FORCE_H
#define VARMASS_MECHANICS_GENERALIZED_FORCE_H

#include "../base/real.h"
#include "vectors.h"

/* Add the generalized forces of a force and a moment: Q_i += force dr/dq_i + moment domega/dq'_i (235).
   dr[i] and domega[i] are these derivatives, by the coordinate q_i and its rate q'_i, of the place r at which the
   force acts and of the angular velocity omega. For outer loads give their resultant and moment. For a stream of rate
   M' give the force M' u at the point where the mass crosses with the velocity u, and the moment M' kappa omega2,
   with the gyration kappa and the spin omega2 of the mass. dr, domega and Q are arrays of n. Without dr or domega its
   term is left out. Without Q nothing is done. */
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
