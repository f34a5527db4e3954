/* mechanics/lagrange_jump.h - Lagrange's equations across a jump */
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

/* (96): d(T2 - T1)/dqdot = impulse, where the part's velocity relative to the body is held while differentiating, so
   that d(T of the part)/dqdot is its generalized momentum part:
     after qdot_after = before qdot - part + impulse    separation
     after qdot_after = before qdot + part + impulse    attachment
   Mass matrices n by n; part and impulse may be null (zero); qdot_after may be qdot. A part of little mass changes
   qdot by little, and that to a few eps of the change. VM_SINGULAR where a coordinate, or several together, move no
   mass, or a negative one: an entry on after's diagonal is not positive, or a pivot below 4 n eps once that is scaled
   to 1. */
#define VM_LAGRANGE_WORK(n) ((n) * ((n) + 2))

/* Generalized coordinates q_i, i < n (or velocities qdot_i that are no derivatives, as those about the axes). A body
   enters by dr[i] = dv/dqdot_i of its mass centre and turn[i] = d omega/dqdot_i, in inertial axes (87)-(90). With
   these each function adds to its last argument: a body's share of the mass matrix (n by n, T = qdot^T matrix
   qdot/2), the generalized momentum of a body (as it moves), the generalized impulse (95) of what acts on a body
   whose mass centre is at r; its moment is that about r, as (23a) should have said. dr or turn may be null: no part
   of it. With another null pointer nothing is added. */
VM_API void vm_lagrange_mass(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *matrix)
{
    if (!body || !matrix) return;
    const vm_vec3 none = {0, 0, 0};
    int i, j;
    for (j = 0; j < n; j++) {
        vm_body moved = *body;
        vm_vec3 spin;
        moved.omega = turn ? turn[j] : none;
        spin = vmi_spin_momentum(&moved);
        for (i = 0; i < n; i++)
            matrix[i * n + j] +=
                (dr ? body->mass * vmi_dot(dr[i], dr[j]) : 0) + (turn ? vmi_dot(turn[i], spin) : 0);
    }
}

/* Documented with vm_lagrange_mass. */
VM_API void vm_lagrange_momentum(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *p)
{
    if (!body || !p) return;
    vm_lagrange_add_force(n, vm_momentum(body), dr, vmi_spin_momentum(body), turn, p);
}

/* Documented with vm_lagrange_mass. */
VM_API void vm_lagrange_impulse(int n, const vm_impulse *impulse, vm_vec3 r, const vm_vec3 *dr, const vm_vec3 *turn,
                                vm_real *p)
{
    if (!impulse || !p) return;
    const vm_vec3 moment = vmi_add(impulse->couple, vmi_cross(vmi_sub(impulse->at, r), impulse->linear));
    vm_lagrange_add_force(n, impulse->linear, dr, moment, turn, p);
}

/* matrix (qdot_after - qdot) = b, of which work has b behind room for the matrix */
VM_API int vmi_lagrange_solve(int n, const vm_real *matrix, const vm_real *qdot, vm_real *qdot_after, vm_real *work)
{
    vm_real *a = work, *b = a + n * n, *scale = b + n;
    int i;
    if (!vmi_all_finite(n * n, matrix) || !vmi_all_finite(n, qdot) || !vmi_all_finite(n, b)) return VM_NOT_FINITE;
    memcpy(a, matrix, (size_t)(n * n) * sizeof *a);
    if (vmi_solve_mass(n, a, b, scale)) return VM_SINGULAR;
    for (i = 0; i < n; i++) b[i] += qdot[i];
    return vmi_copy_if_finite(n, b, qdot_after);
}

/* after (qdot_after - qdot) = (before - after) qdot + sign part + impulse: so a small part changes qdot by little,
   with a small error */
VM_API int vmi_lagrange_jump(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                             const vm_real *part, vm_real sign, const vm_real *impulse, vm_real *qdot_after,
                             vm_real *work)
{
    int i, j;
    if (n <= 0 || !before || !after || !qdot || !qdot_after || !work) return VM_BAD_ARGUMENT;
    for (i = 0; i < n; i++) {
        vm_real sum = part ? sign * part[i] : 0;
        for (j = 0; j < n; j++) sum += (before[i * n + j] - after[i * n + j]) * qdot[j];
        work[n * n + i] = impulse ? sum + impulse[i] : sum;
    }
    return vmi_lagrange_solve(n, after, qdot, qdot_after, work);
}

VM_API int vm_lagrange_separate(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                                const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                                vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, -1, impulse_or_NULL, qdot_after, work);
}

VM_API int vm_lagrange_attach(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                              const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                              vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, 1, impulse_or_NULL, qdot_after, work);
}

/* matrix (qdot_after - qdot) = impulse: no mass changes. Also a separation, free of cancellation for m -> M, where
   matrix is that of the rest and -impulse the momentum of the part's motion relative to the body. */
VM_API int vm_lagrange_impact(int n, const vm_real *matrix, const vm_real *qdot, const vm_real *impulse,
                           vm_real *qdot_after, vm_real *work)
{
    if (!impulse) return VM_BAD_ARGUMENT;
    return vmi_lagrange_jump(n, matrix, matrix, qdot, NULL, 0, impulse, qdot_after, work);
}

#endif
