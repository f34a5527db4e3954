/* mechanics/attitude.h - how the attitude of a rotating body changes

       vm_quat q = {1, 0, 0, 0};  // the attitude: body axes are inertial axes
       vm_vec3 omega = {0, 0, 2}; // 2 rad/s about the third axis
       vm_real rates[4];          // w', x', y', z' of q, the derivatives with respect to time
       vmi_attitude_rates(q, vmi_quat_square(q), omega, rates);

   Tests: tests/test_flow.c, tests/test_scene_bodies.c. */
#ifndef VARMASS_MECHANICS_ATTITUDE_H
#define VARMASS_MECHANICS_ATTITUDE_H

#include "../base/real.h"
#include "vectors.h"

/* Writes the time derivatives of w, x, y, z of the quaternion q to rates. q is the attitude of a body with the angular
   velocity omega (rad/s, body axes): q' = q (0, omega)/2 + |omega| (1 - |q|^2) q/8. square is |q|^2. q should have
   length 1, but errors of an integration change its length. The second term lets the length return to 1. It acts more
   slowly than the body rotates, so that it does not make the equations of a slow rotation stiff. */
VM_INLINE void vmi_attitude_rates(vm_quat q, vm_real square, vm_vec3 omega, vm_real *rates)
{
    const vm_real back = VM_SQRT(vmi_dot(omega, omega)) * (1 - square) / 8;
    const vm_real x = omega.x / 2, y = omega.y / 2, z = omega.z / 2;
    rates[0] = back * q.w - q.x * x - q.y * y - q.z * z;
    rates[1] = back * q.x + q.w * x + q.y * z - q.z * y;
    rates[2] = back * q.y + q.w * y + q.z * x - q.x * z;
    rates[3] = back * q.z + q.w * z + q.x * y - q.y * x;
}

#endif
