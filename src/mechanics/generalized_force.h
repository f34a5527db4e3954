/* mechanics/generalized_force.h - generalized forces from forces and moments

   This chapter computes the generalized forces of a force and a moment, by equation (235) of the dissertation [1].
   Lagrange's equations (lagrange.h) need these generalized forces. For jumps the same function is called with momenta
   and impulses instead of forces and moments (lagrange_jump.h).

       vm_vec3 weight = {0, 0, VM_C(-9.8)}, no_moment = {0, 0, 0};
       vm_vec3 dr[1] = {{0, 0, 1}}; // dr/dq_0 of the point at which the weight acts
       vm_real Q[1] = {0};
       vm_lagrange_add_force(1, weight, dr, no_moment, NULL, Q); // Q[0] is -9.8

   Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_GENERALIZED_FORCE_H
#define VARMASS_MECHANICS_GENERALIZED_FORCE_H

#include "../base/real.h"
#include "vectors.h"

/* Adds the generalized forces of a force and a moment: Q_i += force.dr/dq_i + moment.domega/dq'_i (235).
   dr_or_NULL[i] is dr/dq_i, the derivative, with respect to the coordinate q_i, of the position r of the point at which
   the force acts. domega_or_NULL[i] is domega/dq'_i, the derivative of the body's angular velocity omega with respect
   to the rate q'_i. These arrays and Q have n entries. If dr_or_NULL or domega_or_NULL is NULL, its term is 0. If Q is
   NULL, nothing is done.

   For external loads, use their resultant force and their moment about r. For a stream with the mass rate M' (kg/s),
   the velocity u and the angular velocity omega2, use the force M' u at the point where the mass enters or leaves, and
   the moment M' kappa omega2. kappa is the inertia of the stream's mass per unit mass, about the mass centre of this
   mass. */
VM_API void vm_lagrange_add_force(int n, vm_vec3 force, const vm_vec3 *dr_or_NULL, vm_vec3 moment,
                                  const vm_vec3 *domega_or_NULL, vm_real *Q)
{
    int k;
    if (!Q) return;
    for (k = 0; k < n; k++) {
        vm_real sum = 0;
        if (dr_or_NULL) sum = vm_dot(force, dr_or_NULL[k]);
        if (domega_or_NULL) sum += vm_dot(moment, domega_or_NULL[k]);
        Q[k] += sum;
    }
}

#endif
