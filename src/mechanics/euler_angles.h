/* mechanics/euler_angles.h - Euler's angles */
#ifndef VARMASS_MECHANICS_EULER_ANGLES_H
#define VARMASS_MECHANICS_EULER_ANGLES_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "vectors.h"

/* Euler's angles psi, theta, phi (3-1-3: about z, the line of nodes, the body's z): the attitude, and domega/dq'_i in
   inertial and in body axes, omega = psi' axis[0] + theta' axis[1] + phi' axis[2]; rates of an omega in inertial
   axes, VM_SINGULAR where sin(theta) = 0, VM_NOT_FINITE. Within 4 eps for angles up to
   0.1/eps (4e14, float 8e5); from 2^(p-1) quarters on they hold no phase. */
VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi)
{
    vm_quat turn, tilt, spin;
    turn.x = turn.y = tilt.y = tilt.z = spin.x = spin.y = 0;
    vmi_sincos(psi / 2, &turn.z, &turn.w);
    vmi_sincos(theta / 2, &tilt.x, &tilt.w);
    vmi_sincos(phi / 2, &spin.z, &spin.w);
    return vmi_quat_times(vmi_quat_times(turn, tilt), spin);
}

/* Documented with vm_euler_313. */
VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3])
{
    if (!axis) return;
    vm_real s, c, sine, cosine;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(0, 0, 1);
    axis[1] = vmi_vec3(c, s, 0);
    axis[2] = vmi_vec3(sine * s, -sine * c, cosine);
}

/* Documented with vm_euler_313. */
VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3])
{
    if (!axis) return;
    vm_real s, c, sine, cosine;
    vmi_sincos(phi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(sine * s, sine * c, cosine);
    axis[1] = vmi_vec3(c, -s, 0);
    axis[2] = vmi_vec3(0, 0, 1);
}

/* Documented with vm_euler_313. */
VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3])
{
    vm_real s, c, sine, cosine, result[3];
    if (!rates) return VM_BAD_ARGUMENT;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    if (sine == 0) return VM_SINGULAR;
    result[2] = (s * omega.x - c * omega.y) / sine;
    result[1] = c * omega.x + s * omega.y;
    result[0] = omega.z - result[2] * cosine;
    return vmi_copy_if_finite(3, result, rates);
}

#endif
