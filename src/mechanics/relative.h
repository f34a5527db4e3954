/* mechanics/relative.h - motion relative to a moving body */
#ifndef VARMASS_MECHANICS_RELATIVE_H
#define VARMASS_MECHANICS_RELATIVE_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "jumps.h"
#include "jumps2.h"
#include "vectors.h"

/* Velocity of the point r of what moves on rigidly with a body: the dragging velocity of (25) */
VM_API vm_vec3 vmi_velocity_at(const vm_body *by, vm_vec3 r)
{
    return vmi_add(by->v, vmi_cross(by->omega, vmi_sub(r, by->r)));
}

/* Motion relative to what moves on rigidly with a body: v_r = v - v_S - Omega x (r - r_S) (25), (26), (98), (101) and
   Omega_r = omega - Omega (41), (99), (102) in v and omega; and back. All else is copied. VM_BAD_ARGUMENT. */
VM_API int vm_to_relative(const vm_body *to, const vm_body *absolute, vm_body *relative)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = *absolute;
    b.v = vmi_sub(vmi_sub(b.v, to->v), vmi_cross(to->omega, vmi_sub(b.r, to->r)));
    b.omega = vmi_sub(b.omega, to->omega);
    *relative = b;
    return VM_OK;
}

/* Documented with vm_to_relative. */
VM_API int vm_to_absolute(const vm_body *to, const vm_body *relative, vm_body *absolute)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = *relative;
    b.v = vmi_add(vmi_velocity_at(to, b.r), b.v);
    b.omega = vmi_add(to->omega, b.omega);
    *absolute = b;
    return VM_OK;
}

/* Documented with vm_to_relative. */
VM_API int vm_to_relative2(const vm_body2 *to, const vm_body2 *absolute, vm_body2 *relative)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_body_to_space(absolute);
    vm_to_relative(&whole, &b, &b);
    *relative = vmi_body_to_plane(&b, absolute->angle);
    return VM_OK;
}

/* Documented with vm_to_relative. */
VM_API int vm_to_absolute2(const vm_body2 *to, const vm_body2 *relative, vm_body2 *absolute)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_body_to_space(relative);
    vm_to_absolute(&whole, &b, &b);
    *absolute = vmi_body_to_plane(&b, relative->angle);
    return VM_OK;
}

/* The law has the same form in the frame that moves and turns with the first body */
VM_API int vmi_jump_relative(const vm_body *body, const vm_body *other, vm_real sign, const vm_impulse *external,
                             vm_body *result)
{
    vm_body still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.v = still.omega = vmi_vec3(0, 0, 0);
    return vmi_jump(&still, 1, other, sign, external, result);
}

VM_API int vmi_jump_relative2(const vm_body2 *body, const vm_body2 *other, vm_real sign,
                              const vm_impulse2 *external, vm_body2 *result)
{
    vm_body2 still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.vx = still.vy = still.omega = 0;
    return vmi_jump2(&still, 1, other, sign, external, result);
}

/* The jump in relative motions, (28)-(31), (42)-(44): those of the part given and of the rest returned are relative
   to the whole, those of the body added and of the whole relative to the body; what the first body itself does does
   not matter. */
VM_API int vm_separate_relative(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                vm_body *rest)
{
    return vmi_jump_relative(whole, part, -1, external_or_NULL, rest);
}

/* Documented with vm_separate_relative. */
VM_API int vm_attach_relative(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL,
                              vm_body *whole)
{
    return vmi_jump_relative(body, added, 1, external_or_NULL, whole);
}

/* Documented with vm_separate_relative. */
VM_API int vm_separate_relative2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_body2 *rest)
{
    return vmi_jump_relative2(whole, part, -1, external_or_NULL, rest);
}

/* Documented with vm_separate_relative. */
VM_API int vm_attach_relative2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                               vm_body2 *whole)
{
    return vmi_jump_relative2(body, added, 1, external_or_NULL, whole);
}

#endif
