/* mechanics/jumps2.h - parts separate from a body or are attached to it, in the plane
   This chapter computes the jumps of jumps.h for motion in the plane, by the equations (35)-(39) of the dissertation
   [1]. A body in the plane has one moment of inertia and one angular velocity. The functions here use the functions of
   jumps.h to join or separate the masses. Only the last step, from angular momentum to angular velocity, is different
   in the plane.

       vm_body2 plate = {2, 0.1, 0, 0, 0, 3, 0, 8}, chip = {0.1, 0, 0.2, 0, 0, 5, 1, 8}, rest;
       int status = vm_separate2(&plate, &chip, NULL, &rest); // VM_OK: `rest` has the motion after the separation

   Tests: tests/test_jumps2.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_JUMPS2_H
#define VARMASS_MECHANICS_JUMPS2_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "jumps.h"
#include "vectors.h"

/* Converts an impulse in the plane to an impulse in space */
VM_API vm_impulse vmi_impulse_to_space(const vm_impulse2 *j)
{
    vm_impulse lifted;
    lifted.linear = vmi_vec3(j->jx, j->jy, 0);
    lifted.couple = vmi_vec3(0, 0, j->couple);
    lifted.at = vmi_vec3(j->x, j->y, 0);
    return lifted;
}

/* A lump is the mass, motion and inertia of a body, or of several bodies joined (vmi_lump). Sets the moment of inertia
   of a lump in the plane to 0 if this moment is smaller than its rounding errors. Returns VM_NOT_FINITE if the moment
   is not finite, VM_BAD_INERTIA if it is clearly negative, and VM_OK otherwise. */
VM_API int vmi_lump_clamp_moments2(vmi_lump *lump)
{
    if (!VM_IS_FINITE(lump->inertia.zz)) return VM_NOT_FINITE;
    if (lump->inertia.zz < -32 * VM_EPSILON * lump->sizes.zz) return VM_BAD_INERTIA;
    if (lump->inertia.zz <= VMI_LOST_SHARE * lump->sizes.zz) lump->inertia.zz = 0;
    return VM_OK;
}

/* Sets *omega to the angular velocity of *lump (a body, or several bodies joined) relative to the frame of the jump,
   (44). For a lump without inertia, *omega becomes `before`, the angular velocity of the body relative to this frame
   before the jump. Returns 1 if a lump without inertia has angular momentum, which is impossible, else 0. */
VM_API int vmi_lump_spin2(const vmi_lump *lump, vm_real before, vm_real *omega)
{
    if (lump->inertia.zz > 0) {
        *omega = lump->h.z / lump->inertia.zz;
        return 0;
    }
    *omega = before;
    return VM_FABS(lump->h.z) > 2 * VM_EPSILON * (lump->noise + VM_FABS(lump->h.z));
}

/* Returns VM_OK if the bodies of a jump in the plane are valid and the impulse is finite, else the error that
   vmi_first_error selects. */
VM_API int vmi_check_jump2(const vm_body2 *body, const vmi_bodies *others, const vm_impulse2 *external_or_NULL)
{
    const int status = vmi_first_error(vmi_check_body2(body), vmi_check_bodies(others));
    vm_impulse impulse;
    if (!external_or_NULL) return status;
    impulse = vmi_impulse_to_space(external_or_NULL);
    return vmi_impulse_is_finite(&impulse) ? status : vmi_first_error(status, VM_NOT_FINITE);
}

/* Sets *total to `body` as it is after a jump in the plane and the impulse, and *frame to the frame of the jump.
   Returns VM_BAD_MASS if no mass is left; VM_NOT_FINITE if the inertia is infinite or NaN; VM_BAD_INERTIA if it is
   negative; else VM_OK. */
VM_API int vmi_jump_total2(const vm_body2 *body, const vmi_bodies *others, vm_real sign,
                           const vm_impulse2 *external_or_NULL, vmi_frame *frame, vmi_lump *total)
{
    const vm_body lifted = vmi_body_to_space(body);
    const vm_impulse *given = NULL;
    vm_impulse impulse;
    int status;
    if (external_or_NULL) {
        impulse = vmi_impulse_to_space(external_or_NULL);
        given = &impulse;
    }
    *frame = vmi_frame_of(&lifted, others, sign);
    status = vmi_jump_total(frame, &lifted, sign, others, given, total);
    return status ? status : vmi_lump_clamp_moments2(total);
}

/* Sets *result to the body `body` in the plane after n others are attached to it (sign = 1) or separate from it
   (sign = -1), while an impulse acts. The statuses are those of vm_separate2. */
VM_API int vmi_jump2(const vm_body2 *body, int n, const vm_body2 *others, vm_real sign,
                     const vm_impulse2 *external_or_NULL, vm_body2 *result)
{
    const vmi_bodies list = vmi_bodies_in_plane(n, others);
    vmi_frame frame;
    vmi_lump lump;
    vm_body2 b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_jump2(body, &list, external_or_NULL);
    if (!status) status = vmi_jump_total2(body, &list, sign, external_or_NULL, &frame, &lump);
    if (status) return status;
    b.mass = lump.mass;
    b.inertia = lump.inertia.zz;
    b.angle = body->angle;
    b.x = frame.r.x + lump.r.x;
    b.y = frame.r.y + lump.r.y;
    b.vx = frame.v.x + lump.v.x;
    b.vy = frame.v.y + lump.v.y;
    if (vmi_lump_spin2(&lump, body->omega - frame.omega.z, &b.omega)) status = VM_NULL_AXIS;
    b.omega += frame.omega.z;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* Separation of a part from a body in the plane: *rest is what remains of the whole, (35)-(39). The caller sets vx, vy
   and omega of *part to the motion after the separation. The impulse, if there is one, acts during the separation.
   The total momentum of rest and part is the momentum of the whole plus the impulse, and their total angular momentum
   is that of the whole plus the moment of the impulse. The pointer rest may be equal to whole or to part. The accuracy
   is that of vm_separate.

   Returns VM_OK, VM_NULL_AXIS or an error. VM_NULL_AXIS is a warning: the rest is a point without inertia, but the
   equations demand angular momentum of the point about itself, which a point cannot have. *rest is then set, with
   omega = whole->omega.
   The errors are VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument or the result is infinite or NaN;
   VM_BAD_MASS if a mass, that of the rest included, is not positive; and VM_BAD_INERTIA if an inertia, that of the rest
   included, is negative. */
VM_API int vm_separate2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                        vm_body2 *rest)
{
    return vmi_jump2(whole, 1, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of one body to another in the plane (plastic impact): *whole is the body that the two form together.
   Before the call, set the fields vx, vy and omega of both bodies, *body and *added, to their values just before the
   impact. The impulse, if there is one, acts during the impact. The whole has the angle of `body`. The statuses are
   those of vm_separate2. VM_NULL_AXIS means that the bodies are points at one position, to which the impulse would
   give angular momentum. The omega of the whole is then that of `body`. */
VM_API int vm_attach2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                      vm_body2 *whole)
{
    return vmi_jump2(body, 1, added, VMI_ATTACH, external_or_NULL, whole);
}

/* Separation of n parts from a body at once, in the plane: *rest is what remains. Except for rounding errors, n calls
   of vm_separate2, one after the other, give the same result if the impulse is passed to only one of these calls. With
   n = 0 only the impulse acts on the body. The statuses are those of vm_separate2. For n < 0 the status is
   VM_BAD_ARGUMENT. */
VM_API int vm_separate_all2(const vm_body2 *whole, int n, const vm_body2 *parts,
                            const vm_impulse2 *external_or_NULL, vm_body2 *rest)
{
    return vmi_jump2(whole, n, parts, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of n bodies to a body at once, in the plane: *whole is the body that all of them form together. Except
   for rounding errors, n calls of vm_attach2, one after the other, give the same result if the impulse is passed to
   only one of these calls. With n = 0 only the impulse acts on the body. The statuses are those of vm_attach2. For n <
   0 the status is VM_BAD_ARGUMENT. */
VM_API int vm_attach_all2(const vm_body2 *body, int n, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                          vm_body2 *whole)
{
    return vmi_jump2(body, n, added, VMI_ATTACH, external_or_NULL, whole);
}

#endif
