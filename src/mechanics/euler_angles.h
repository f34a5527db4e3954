/* mechanics/euler_angles.h - Euler's angles

   The angles psi, theta, phi of the sequence 3-1-3 give the attitude of a body. It turns by psi about the z axis, then
   by theta about its own x axis (the line of nodes), then by phi about its own z axis. This chapter computes
     - the quaternion of three angles,
     - the axes about which the angles turn the body, which Lagrange's equations need as domega/dq'_i,
     - the time derivatives psi', theta', phi' of the angles from an angular velocity.

       vm_quat q = vm_euler_313(VM_C(0.1), VM_C(0.2), VM_C(0.3));

   Angles are in rad. Errors are within 8 eps for angles up to 1e9 (float 1e4). Beyond 2^(p-1) quarter turns, where p is
   the number of binary digits of vm_real, a result has no meaning: adjacent numbers differ by 1 rad or more.
   Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_EULER_ANGLES_H
#define VARMASS_MECHANICS_EULER_ANGLES_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "vectors.h"

/* Attitude from Euler's angles: a quaternion of length 1. It converts vectors from body axes to inertial axes. Infinite
   angles give NaN. */
VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi)
{
    vm_quat turn = {1, 0, 0, 0}, tilt = {1, 0, 0, 0}, spin = {1, 0, 0, 0};
    vmi_sincos(psi / 2, &turn.z, &turn.w);
    vmi_sincos(theta / 2, &tilt.x, &tilt.w);
    vmi_sincos(phi / 2, &spin.z, &spin.w);
    return vmi_quat_times(vmi_quat_times(turn, tilt), spin);
}

/* Unit vectors of the axes about which Euler's angles turn the body, along inertial axes. The angular velocity is
   omega = psi' axis[0] + theta' axis[1] + phi' axis[2]. Therefore axis[i] is domega/dq'_i if q'_0, q'_1, q'_2 are the
   rates psi', theta', phi'. A call with a null pointer does nothing. */
VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine; /* s, c: sine and cosine of psi; sine, cosine: those of theta */
    if (!axis) return;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(0, 0, 1);
    axis[1] = vmi_vec3(c, s, 0);
    axis[2] = vmi_vec3(sine * s, -sine * c, cosine);
}

/* Unit vectors of the axes about which Euler's angles turn the body, along body axes. The angular velocity is
   omega = psi' axis[0] + theta' axis[1] + phi' axis[2]. A call with a null pointer does nothing. */
VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine; /* s, c: sine and cosine of phi; sine, cosine: those of theta */
    if (!axis) return;
    vmi_sincos(phi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(sine * s, sine * c, cosine);
    axis[1] = vmi_vec3(c, -s, 0);
    axis[2] = vmi_vec3(0, 0, 1);
}

/* Rates psi', theta', phi' of Euler's angles from an angular velocity in inertial axes, rad/s. Returns VM_OK,
   VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, or VM_SINGULAR if sin(theta) is 0: psi and phi then turn the body
   about the same axis, so that their rates are not unique. */
VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3])
{
    vm_real s, c, sine, cosine, result[3]; /* s, c: sine and cosine of psi; sine, cosine: those of theta */
    if (!rates) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(psi) || !VM_IS_FINITE(theta) || !vmi_vec3_is_finite(omega)) return VM_NOT_FINITE;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    if (sine == 0) return VM_SINGULAR;
    result[2] = (s * omega.x - c * omega.y) / sine;
    result[1] = c * omega.x + s * omega.y;
    result[0] = omega.z - result[2] * cosine;
    return vmi_copy_if_finite(3, result, rates);
}

#endif
