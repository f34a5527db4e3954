/* mechanics/attitude.h - how the attitude of a rotating body changes

       vm_real rates[4]; // of w, x, y, z
       vmi_attitude_rates(q, vmi_quat_square(q), omega, rates);

   Tests: tests/test_flow.c, tests/test_scene_bodies.c. */
#ifndef VARMASS_MECHANICS_ATTITUDE_H
#define VARMASS_MECHANICS_ATTITUDE_H

#include "../base/real.h"
#include "vectors.h"

/* q' = q (0, omega)/2 + |omega| (1 - |q|^2) q/8, omega in body axes, square = |q|^2. The second term brings the length
   back to 1 within some steps of any explicit method, at a rate below that of the rotation itself, so that a slow
   rotation is not stiff. */
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
