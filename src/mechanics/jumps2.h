/* mechanics/jumps2.h - parts separate or are attached in a plane */
#ifndef VARMASS_MECHANICS_JUMPS2_H
#define VARMASS_MECHANICS_JUMPS2_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "jumps.h"
#include "vectors.h"

VM_API vm_impulse vmi_impulse_to_space(const vm_impulse2 *j)
{
    vm_impulse lifted;
    lifted.linear = vmi_vec3(j->jx, j->jy, 0);
    lifted.couple = vmi_vec3(0, 0, j->couple);
    lifted.at = vmi_vec3(j->x, j->y, 0);
    return lifted;
}

/* (44) and its like: a load's spin relative to the frame, which without inertia is the one before */
VM_API int vmi_lump_spin2(const vmi_lump *load, vm_real before, vm_real *omega)
{
    *omega = load->inertia.zz > 0 ? load->h.z / load->inertia.zz : before;
    return !(load->inertia.zz > 0) && VM_FABS(load->h.z) > 2 * VM_EPSILON * (load->noise + VM_FABS(load->h.z));
}

VM_API int vmi_lump_clamp_moments2(vmi_lump *load)
{
    if (!VM_IS_FINITE(load->inertia.zz)) return VM_NOT_FINITE;
    if (load->inertia.zz < -32 * VM_EPSILON * load->sizes.zz) return VM_BAD_INERTIA;
    if (load->inertia.zz <= 8 * VM_EPSILON * load->sizes.zz) load->inertia.zz = 0;
    return VM_OK;
}

/* Checks, and the total of vmi_jump_total for bodies of the plane */
VM_API int vmi_jump_total2(const vm_body2 *body, const vmi_bodies *others, vm_real sign,
                           const vm_impulse2 *external, vmi_frame *frame, vmi_lump *load)
{
    vm_impulse blow;
    vm_body lifted;
    int status = vmi_check_body2(body);
    if (!status) status = vmi_check_bodies(others);
    if (status) return status;
    lifted = vmi_body_to_space(body);
    if (external) blow = vmi_impulse_to_space(external);
    *frame = vmi_frame_of(&lifted, others, sign);
    status = vmi_jump_total(frame, &lifted, sign, others, external ? &blow : NULL, load);
    return status ? status : vmi_lump_clamp_moments2(load);
}

VM_API int vmi_jump2(const vm_body2 *body, int n, const vm_body2 *others, vm_real sign, const vm_impulse2 *external,
                     vm_body2 *result)
{
    vmi_bodies list;
    vmi_frame frame;
    vmi_lump load;
    vm_body2 b;
    int status;
    if (!body || !result || (n > 0 && !others)) return VM_BAD_ARGUMENT;
    list.n = n;
    list.in_space = NULL;
    list.in_plane = others;
    status = vmi_jump_total2(body, &list, sign, external, &frame, &load);
    if (status) return status;
    b.mass = load.mass;
    b.inertia = load.inertia.zz;
    b.angle = body->angle;
    b.x = frame.r.x + load.r.x;
    b.y = frame.r.y + load.r.y;
    b.vx = frame.v.x + load.v.x;
    b.vy = frame.v.y + load.v.y;
    if (vmi_lump_spin2(&load, body->omega - frame.omega.z, &b.omega)) status = VM_NULL_AXIS;
    b.omega += frame.omega.z;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* The same in the plane (35)-(39); *_all2 as above */
VM_API int vm_separate2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                        vm_body2 *rest)
{
    return vmi_jump2(whole, 1, part, -1, external_or_NULL, rest);
}

/* Documented with vm_separate2. */
VM_API int vm_attach2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                      vm_body2 *whole)
{
    return vmi_jump2(body, 1, added, 1, external_or_NULL, whole);
}

/* Documented with vm_separate2. */
VM_API int vm_separate_all2(const vm_body2 *whole, int n, const vm_body2 *parts,
                            const vm_impulse2 *external_or_NULL, vm_body2 *rest)
{
    return vmi_jump2(whole, n, parts, -1, external_or_NULL, rest);
}

/* Documented with vm_separate2. */
VM_API int vm_attach_all2(const vm_body2 *body, int n, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                          vm_body2 *whole)
{
    return vmi_jump2(body, n, added, 1, external_or_NULL, whole);
}

#endif
