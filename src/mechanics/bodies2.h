/* mechanics/bodies2.h - angular momentum and energy of bodies in the plane, and their conversion to bodies in space
   In the plane a body has one moment of inertia and one angular velocity, as in the equations (35)-(39) of the
   dissertation [1]. The type of such a body, vm_body2, is in bodies.h.

       vm_body2 plate = {2, 0.1, 0, 0, 0, 3, 0, 8}; // mass, inertia, x, y, angle, vx, vy, omega
       vm_real T = vm_kinetic_energy2(&plate);      // (2 3^2 + 0.1 8^2)/2 = 12.2 J

   Tests: tests/test_bodies.c, tests/test_jumps2.c. */
#ifndef VARMASS_MECHANICS_BODIES2_H
#define VARMASS_MECHANICS_BODIES2_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "bodies.h"

/* Angular momentum of a body that moves in the plane about the point (x, y), N m s. It is positive anticlockwise. The
   body is not checked. The result is NaN for a null pointer, and if a field that the function uses is NaN. */
VM_API vm_real vm_angular_momentum2(const vm_body2 *body, vm_real x, vm_real y)
{
    if (!body) return VM_NAN;
    return body->inertia * body->omega + body->mass * ((body->x - x) * body->vy - (body->y - y) * body->vx);
}

/* Kinetic energy of a body that moves in the plane, J. It is (M v^2 + I omega^2)/2, with mass M, speed v and inertia I.
   The body is not checked. The result is NaN for a null pointer, and if a field that the function uses is NaN. */
VM_API vm_real vm_kinetic_energy2(const vm_body2 *body)
{
    if (!body) return VM_NAN;
    return (body->mass * (body->vx * body->vx + body->vy * body->vy) + body->inertia * body->omega * body->omega) /
           2;
}

/* Converts a body that moves in the plane to a body in space: a thin plate in the plane z = 0. Its inertia has the
   entries xx = yy = zz/2, its quaternion q has length 1, and its motion is that of *body. *body is not checked. For a
   null pointer all numbers of the result that depend on the body are NaN. */
VM_API vm_body vm_body_from_body2(const vm_body2 *body)
{
    const vm_body2 none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vm_body b;
    if (!body) body = &none;
    b = vmi_body_to_space(body);
    b.inertia.xx = b.inertia.yy = b.inertia.zz / 2;
    vmi_sincos(body->angle / 2, &b.q.z, &b.q.w);
    return b;
}

#endif
