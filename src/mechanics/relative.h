/* mechanics/relative.h - motion relative to a moving body, and jumps computed from relative motions
   This chapter computes the motion of one body relative to another body, that is, in a frame that moves and turns with
   the other body, by the equations (25), (26), (41) of the dissertation [1]. It also computes jumps from such relative
   motions, (28)-(31), (42)-(44). Use these functions if you know only the velocity of a part relative to the whole.

       vm_body part = whole, rest; // whole is a vm_body
       part.mass = 1;
       part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1;
       part.v.x = part.v.y = part.omega.x = part.omega.y = part.omega.z = 0;
       part.v.z = 2;                                     // the part leaves at 2 m/s, relative to the whole
       if (vm_separate_relative(&whole, &part, NULL, &rest) == VM_OK) vm_to_absolute(&whole, &rest, &rest);

   Tests: tests/test_relative.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_RELATIVE_H
#define VARMASS_MECHANICS_RELATIVE_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "jumps.h"
#include "jumps2.h"
#include "vectors.h"

/* Velocity, at the point r, of the frame that moves and turns with a body. The dissertation calls it dragging velocity
   (25). */
VM_API vm_vec3 vmi_velocity_at(const vm_body *body, vm_vec3 r)
{
    return vm_add(body->v, vm_cross(body->omega, vm_sub(r, body->r)));
}

/* The motion of b relative to the frame that moves and turns with the body `to`. Nothing is checked. */
VM_API vm_body vmi_relative_motion(const vm_body *to, vm_body b)
{
    b.v = vm_sub(vm_sub(b.v, to->v), vm_cross(to->omega, vm_sub(b.r, to->r)));
    b.omega = vm_sub(b.omega, to->omega);
    return b;
}

/* The absolute motion of b. The argument b has the motion relative to the body `to`. Nothing is checked. */
VM_API vm_body vmi_absolute_motion(const vm_body *to, vm_body b)
{
    b.v = vm_add(vmi_velocity_at(to, b.r), b.v);
    b.omega = vm_add(to->omega, b.omega);
    return b;
}

/* Copies b to *result. Returns VM_NOT_FINITE, and copies nothing, if a number is not finite. */
VM_API int vmi_put_body(const vm_body *b, vm_body *result)
{
    if (!vmi_body_is_finite(b)) return VM_NOT_FINITE;
    *result = *b;
    return VM_OK;
}

/* Copies b to *result as a body of the plane with the given angle. Returns VM_NOT_FINITE, and copies nothing, if a
   number is not finite. */
VM_API int vmi_put_body2(const vm_body *b, vm_real angle, vm_body2 *result)
{
    const vm_body2 flat = vmi_body_to_plane(b, angle);
    if (!vmi_body2_is_finite(&flat)) return VM_NOT_FINITE;
    *result = flat;
    return VM_OK;
}

/* Motion of a body relative to the frame that moves and turns with the body `to`. The body has the position r, velocity
   v and angular velocity omega; the body `to` has the position r_S, velocity v_S and angular velocity Omega. The
   function replaces v and omega by
     v_r = v - v_S - Omega x (r - r_S) (25), (26), (98), (101),  Omega_r = omega - Omega (41), (99), (102),
   and copies all other fields. The vectors remain along the inertial axes, and r remains the position from the inertial
   origin. The pointer relative may be equal to absolute. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if a
   number of *absolute, of the motion of `to` or of the result is infinite or NaN; VM_OK otherwise. The masses and
   inertias are not checked in any other way. */
VM_API int vm_to_relative(const vm_body *to, const vm_body *absolute, vm_body *relative)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = vmi_relative_motion(to, *absolute);
    return vmi_put_body(&b, relative);
}

/* Computes the absolute motion of a body from its motion relative to the body `to`. The function is the inverse of
   vm_to_relative and returns the same statuses. The pointer absolute may be equal to relative. */
VM_API int vm_to_absolute(const vm_body *to, const vm_body *relative, vm_body *absolute)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = vmi_absolute_motion(to, *relative);
    return vmi_put_body(&b, absolute);
}

/* Motion of a body in the plane, relative to the frame that moves and turns with the body `to`. vx, vy and omega change
   as in vm_to_relative, and all other fields are copied. The statuses are those of vm_to_relative. */
VM_API int vm_to_relative2(const vm_body2 *to, const vm_body2 *absolute, vm_body2 *relative)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_relative_motion(&whole, vmi_body_to_space(absolute));
    return vmi_put_body2(&b, absolute->angle, relative);
}

/* Computes the absolute plane motion of a body from its motion relative to the body `to`. The function is the inverse
   of vm_to_relative2 and returns the same statuses. */
VM_API int vm_to_absolute2(const vm_body2 *to, const vm_body2 *relative, vm_body2 *absolute)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_absolute_motion(&whole, vmi_body_to_space(relative));
    return vmi_put_body2(&b, relative->angle, absolute);
}

/* ---- jumps ---- */

/* Computes a jump; the motions before and after the jump are relative to `body`. In the frame that moves and turns
   with `body`, this body is at rest, and the equations of a jump have the same form as in an inertial frame. */
VM_API int vmi_jump_relative(const vm_body *body, const vm_body *other, vm_real sign,
                             const vm_impulse *external_or_NULL, vm_body *result)
{
    vm_body still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.v = still.omega = vmi_vec3(0, 0, 0);
    return vmi_jump(&still, 1, other, sign, external_or_NULL, result);
}

/* Computes a jump in the plane. The motions before and after the jump are given in the frame that moves and turns with
   `body`, in which `body` is at rest before the jump. */
VM_API int vmi_jump_relative2(const vm_body2 *body, const vm_body2 *other, vm_real sign,
                              const vm_impulse2 *external_or_NULL, vm_body2 *result)
{
    vm_body2 still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.vx = still.vy = still.omega = 0;
    return vmi_jump2(&still, 1, other, sign, external_or_NULL, result);
}

/* Separation, with motions given relative to the whole: (28)-(31), (42)-(44). v and omega of *part and of the result
   *rest are relative to the whole; the function does not read v and omega of *whole. In every other respect, its
   statuses included, the function works like vm_separate. */
VM_API int vm_separate_relative(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                vm_body *rest)
{
    return vmi_jump_relative(whole, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment, with motions given relative to the first body: (28)-(31), (42)-(44). v and omega of *added and of the
   result *whole are relative to `body`; the function does not read v and omega of *body. In every other respect, its
   statuses included, the function works like vm_attach. */
VM_API int vm_attach_relative(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL,
                              vm_body *whole)
{
    return vmi_jump_relative(body, added, VMI_ATTACH, external_or_NULL, whole);
}

/* Separation in the plane, with motions given relative to the whole. vx, vy and omega of *part and of the result *rest
   are relative to the whole; the function does not read vx, vy and omega of *whole. In every other respect, its
   statuses included, the function works like vm_separate2. */
VM_API int vm_separate_relative2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_body2 *rest)
{
    return vmi_jump_relative2(whole, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment in the plane, with motions given relative to the first body. vx, vy and omega of *added and of the result
   *whole are relative to `body`; the function does not read vx, vy and omega of *body. In every other respect, its
   statuses included, the function works like vm_attach2. */
VM_API int vm_attach_relative2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                               vm_body2 *whole)
{
    return vmi_jump_relative2(body, added, VMI_ATTACH, external_or_NULL, whole);
}

#endif
