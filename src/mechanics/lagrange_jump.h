/* mechanics/lagrange_jump.h - Lagrange's equations for a jump

   This chapter computes generalized velocities qdot just after a part separates from a system or is attached to it, by
   equation (96) of the dissertation [1], and just after an impact. A mass matrix is an array of n*n numbers, row after
   row. Velocities, momenta and impulses are arrays of n numbers. For rigid bodies, vm_lagrange_mass and
   vm_lagrange_momentum compute matrices and momenta from dr[i] = dv/dqdot_i and turn[i] = domega/dqdot_i, (87)-(90).
   Here v is the velocity of a body's mass centre and omega the body's angular velocity, both along inertial axes.

       vm_real before[4] = {3, 0, 0, 5}, after[4] = {2, 0, 0, 5}; // mass matrices, as vm_lagrange_mass makes them
       vm_real part[2] = {4, 0}, qdot[2] = {1, 1};                // momenta of the part, velocities of the system
       vm_real work[VM_LAGRANGE_WORK(2)];
       int status = vm_lagrange_separate(2, before, after, qdot, part, NULL, qdot, work); // no impulse

   The velocities qdot_i need not be derivatives of coordinates. The qdot_i may, for example, be angular velocities
   about body axes (derivatives of quasi-coordinates). Tests: tests/test_lagrange_jump.c. */
#ifndef VARMASS_MECHANICS_LAGRANGE_JUMP_H
#define VARMASS_MECHANICS_LAGRANGE_JUMP_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/linear.h"
#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "generalized_force.h"
#include "vectors.h"

/* Length of the array `work` for n generalized velocities */
#define VM_LAGRANGE_WORK(n) ((n) * ((n) + 2))

/* Adds the share of a body to the mass matrix of the kinetic energy T = qdot^T matrix qdot/2.
   dr and turn have n vectors: dr[i] = dv/dqdot_i and turn[i] = domega/dqdot_i. v is the velocity of the body's mass
   centre, and omega the body's angular velocity. With the mass M and the inertia I of the body, about its mass centre
   and along inertial axes, the element (i, j) grows by M dr[i].dr[j] + turn[i].(I turn[j]). If dr or turn is NULL, the
   term that contains it is 0. If body or matrix is NULL, the function does nothing. */
VM_API void vm_lagrange_mass(int n, const vm_body *body, const vm_vec3 *dr_or_NULL, const vm_vec3 *turn_or_NULL,
                             vm_real *matrix)
{
    int i, j;
    if (!body || !matrix) return;
    for (j = 0; j < n; j++) {
        vm_vec3 spin = vmi_vec3(0, 0, 0);
        if (turn_or_NULL) spin = vmi_spin_momentum_at(body, turn_or_NULL[j]);
        for (i = 0; i < n; i++) {
            vm_real sum = 0;
            if (dr_or_NULL) sum = body->mass * vm_dot(dr_or_NULL[i], dr_or_NULL[j]);
            if (turn_or_NULL) sum += vm_dot(turn_or_NULL[i], spin);
            matrix[i * n + j] += sum;
        }
    }
}

/* Adds to p the generalized momentum of a body.
   The function computes this momentum from the velocity body->v and the angular velocity body->omega. p has n numbers.
   vm_lagrange_mass explains dr and turn. The number p[i] grows by the scalar product of dr[i] and the momentum, plus
   the scalar product of turn[i] and the angular momentum about the mass centre. If dr or turn is NULL, the product that
   contains it is 0. If body or p is NULL, the function does nothing. */
VM_API void vm_lagrange_momentum(int n, const vm_body *body, const vm_vec3 *dr_or_NULL, const vm_vec3 *turn_or_NULL,
                                 vm_real *p)
{
    if (!body || !p) return;
    vm_lagrange_add_force(n, vm_momentum(body), dr_or_NULL, vmi_spin_momentum(body), turn_or_NULL, p);
}

/* Adds to p the generalized impulse (95) of an impulse on a body with the mass centre r.
   r is in m, in inertial axes. The moment of the impulse is taken about r; equation (23a) does not say about which
   point. p has n numbers. vm_lagrange_mass explains dr and turn. The number p[i] grows by the scalar product of dr[i]
   and the impulse, plus the scalar product of turn[i] and the moment of the impulse. If dr or turn is NULL, the
   product that contains it is 0. If impulse or p is NULL, the function does nothing. */
VM_API void vm_lagrange_impulse(int n, const vm_impulse *impulse, vm_vec3 r, const vm_vec3 *dr_or_NULL,
                                const vm_vec3 *turn_or_NULL, vm_real *p)
{
    if (!impulse || !p) return;
    const vm_vec3 moment = vmi_impulse_moment(impulse, r);
    vm_lagrange_add_force(n, impulse->linear, dr_or_NULL, moment, turn_or_NULL, p);
}

/* Solves matrix*(qdot_after - qdot) = b. `work` has three parts: n*n numbers of space for a copy of the matrix, the n
   numbers of b, which the caller has set, and n numbers of space. Returns VM_NOT_FINITE if an input or the result is
   infinite or NaN; VM_SINGULAR if the matrix is singular (see vm_lagrange_separate); else VM_OK. */
VM_API int vmi_lagrange_jump_solve(int n, const vm_real *matrix, const vm_real *qdot, vm_real *qdot_after,
                                   vm_real *work)
{
    vm_real *a = work, *b = a + n * n, *scale = b + n;
    int i;
    if (!vmi_all_finite(n * n, matrix) || !vmi_all_finite(n, qdot) || !vmi_all_finite(n, b)) return VM_NOT_FINITE;
    memcpy(a, matrix, (size_t)(n * n) * sizeof *a);
    if (vmi_solve_mass(n, a, b, scale)) return VM_SINGULAR;
    for (i = 0; i < n; i++) b[i] += qdot[i];
    return vmi_copy_if_finite(n, b, qdot_after);
}

/* Solves after*(qdot_after - qdot) = (before - after)*qdot + sign*part + impulse, where `before` and `after` are mass
   matrices, and `part` is the vector of generalized momenta of the part that joins or separates. The unknown is the
   change qdot_after - qdot. If the part has little mass, this change is small. The error is small even compared with a
   small change, because the function solves for the change itself. */
VM_API int vmi_lagrange_jump(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                             const vm_real *part_or_NULL, vm_real sign, const vm_real *impulse_or_NULL,
                             vm_real *qdot_after, vm_real *work)
{
    int i, j;
    if (n <= 0 || !before || !after || !qdot || !qdot_after || !work) return VM_BAD_ARGUMENT;
    for (i = 0; i < n; i++) {
        vm_real sum = 0;
        if (part_or_NULL) sum = sign * part_or_NULL[i];
        for (j = 0; j < n; j++) sum += (before[i * n + j] - after[i * n + j]) * qdot[j];
        if (impulse_or_NULL) sum += impulse_or_NULL[i];
        work[n * n + i] = sum;
    }
    return vmi_lagrange_jump_solve(n, after, qdot, qdot_after, work);
}

/* Velocities after a part separates: after*qdot_after = before*qdot - part + impulse (96).
   `before` and `after` are the mass matrices with and without the part; `part` is the generalized momentum of the part
   after the separation. (96) is d(T2 - T1)/dqdot = impulse, where T1 and T2 are the kinetic energies of rest and part
   together before and after the separation. The velocity of the part relative to the body is held constant in this
   derivative, so that the part adds the array `part` to dT2/dqdot. If part or impulse is NULL, its term is 0.
   The array qdot_after may be the array qdot. work has VM_LAGRANGE_WORK(n) numbers. A part of little mass changes qdot
   little, and this small change is accurate relative to its own size. Returns VM_BAD_ARGUMENT for a null pointer and n
   <= 0; VM_NOT_FINITE if an argument or the result is infinite or NaN; VM_SINGULAR if the matrix `after` is not
   positive definite, that is, if some change of the coordinates moves no mass or a negative mass; VM_OK otherwise. The
   matrix counts as singular if an entry on the diagonal of `after` is not positive, or if a pivot is below 4 n eps
   after the diagonal has been scaled to 1. */
VM_API int vm_lagrange_separate(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                                const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                                vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, -1, impulse_or_NULL, qdot_after, work);
}

/* Velocities after a part is attached: after*qdot_after = before*qdot + part + impulse (96).
   `part` is the generalized momentum of the part before it is attached. The other arguments, the accuracy and the
   statuses are those of vm_lagrange_separate. */
VM_API int vm_lagrange_attach(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                              const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                              vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, 1, impulse_or_NULL, qdot_after, work);
}

/* Velocities after an impact that changes no mass: matrix*(qdot_after - qdot) = impulse.
   If the part that separates is nearly the whole body, this function computes the velocities of the rest more
   accurately than vm_lagrange_separate. For this use, `matrix` must be the mass matrix of the rest, and `impulse` must
   be minus the generalized momentum of the part's motion relative to the body. The array sizes, the statuses and
   `work` are those of vm_lagrange_separate, but here `impulse` must not be NULL. */
VM_API int vm_lagrange_impact(int n, const vm_real *matrix, const vm_real *qdot, const vm_real *impulse,
                              vm_real *qdot_after, vm_real *work)
{
    if (!impulse) return VM_BAD_ARGUMENT;
    return vmi_lagrange_jump(n, matrix, matrix, qdot, NULL, 0, impulse, qdot_after, work);
}

#endif
