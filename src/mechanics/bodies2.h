/* mechanics/bodies2.h - bodies that move in a plane */
#ifndef VARMASS_MECHANICS_BODIES2_H
#define VARMASS_MECHANICS_BODIES2_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "bodies.h"

/* Documented with vm_momentum. */
VM_API vm_real vm_angular_momentum2(const vm_body2 *body, vm_real x, vm_real y)
{
    if (!body) return VM_NAN;
    return body->inertia * body->omega + body->mass * ((body->x - x) * body->vy - (body->y - y) * body->vx);
}

/* Documented with vm_momentum. */
VM_API vm_real vm_kinetic_energy2(const vm_body2 *body)
{
    if (!body) return VM_NAN;
    return (body->mass * (body->vx * body->vx + body->vy * body->vy) + body->inertia * body->omega * body->omega) /
           2;
}

/* The plane's body as a lamina in the plane z = 0 of space, which moves as it does. NaN for a null pointer. */
VM_API vm_body vm_body_from_body2(const vm_body2 *body)
{
    const vm_body2 none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vm_body b = vmi_body_to_space(body ? body : &none);
    b.inertia.xx = b.inertia.yy = b.inertia.zz / 2;
    vmi_sincos((body ? body : &none)->angle / 2, &b.q.z, &b.q.w);
    return b;
}

#endif
