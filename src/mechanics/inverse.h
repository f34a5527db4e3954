/* mechanics/inverse.h - how a part must leave, so that the rest moves as wanted
   This chapter inverts a separation. It answers the questions of Tables 2 to 4 of the dissertation [1]: With which
   motion must a part leave so that the rest does not turn, is at rest, or moves on as the whole did?

       vm_vec3 none = {0, 0, 0};
       vm_body moving; // whole and part are vm_bodies
       int status = vm_separation_for_rest(&whole, &part, NULL, NULL, &none, &moving); // VM_OK: the rest does not
           // turn if the part leaves with the motion that is now in the variable `moving`

   Tests: tests/test_inverse.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_INVERSE_H
#define VARMASS_MECHANICS_INVERSE_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "jumps.h"
#include "jumps2.h"
#include "vectors.h"

/* The velocity v2 that the part must have so that the rest gets the velocity v1 = rest_v. By (24) it is
   v2 = v + (linear - M1 (v1 - v))/m, with the velocity v of the whole, the impulse `linear`, the mass M1 of the rest
   and the mass m of the part. */
VM_API vm_vec3 vmi_part_velocity(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                 vm_vec3 rest_v)
{
    vm_vec3 momentum = vm_scale(part->mass - whole->mass, vm_sub(rest_v, whole->v));
    if (external_or_NULL) momentum = vm_add(momentum, external_or_NULL->linear);
    return vm_add(whole->v, vmi_over(momentum, part->mass));
}

/* The angular momentum that the part must have, relative to the turning whole, so that the rest turns with the angular
   velocity rest_omega. It is h - I1 (rest_omega - Omega). Omega is the angular velocity of the whole, and I1 the
   inertia of the rest. h is the field h of *rest, that is, the angular momentum that the rest would have relative to
   the whole if the part left with the angular velocity Omega. */
VM_API vm_vec3 vmi_part_spin_momentum(const vmi_frame *frame, const vmi_lump *rest, vm_vec3 rest_omega)
{
    const vm_vec3 turning = vmi_times_transposed(&frame->turn, vm_sub(rest_omega, frame->omega));
    return vm_sub(rest->h, vmi_times(&frame->turn, vmi_inertia_times(&rest->inertia, turning)));
}

/* Sets *rest to what would remain if the part left with its own velocity but with the angular velocity of the whole,
   and *frame to the frame of the jump. The caller must have checked the bodies, except for the velocity of the part.
   Returns VM_OK or an error of vm_separate. */
VM_API int vmi_unturned_rest(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                             vmi_frame *frame, vmi_lump *rest)
{
    vm_body unturned = *part;
    const vmi_bodies list = vmi_bodies_in_space(1, &unturned);
    vmi_principal p;
    int status;
    if (!vmi_vec3_is_finite(part->v)) return VM_NOT_FINITE;
    unturned.omega = whole->omega;
    *frame = vmi_frame_of(whole, &list, VMI_SEPARATE);
    status = vmi_jump_total(frame, whole, VMI_SEPARATE, &list, external_or_NULL, rest);
    return status ? status : vmi_lump_clamp_moments(rest, &p);
}

/* Sets part->omega to the angular velocity that makes the rest turn with the angular velocity rest_omega. Returns
   VM_NULL_AXIS if the part would need angular momentum about an axis with zero moment of inertia; an error if the
   part's inertia is impossible; VM_OK otherwise. */
VM_API int vmi_turn_part(const vmi_frame *frame, const vmi_lump *rest, vm_vec3 rest_omega, vm_body *part)
{
    vmi_frame own = *frame; /* the frame of the jump, with the axes of the part */
    vmi_lump lump;
    vmi_principal p;
    vm_vec3 spin;
    int status;
    own.q = part->q;
    own.turn = vmi_rotation(part->q);
    lump = vmi_lump_of(&own, part);
    lump.h = vmi_part_spin_momentum(frame, rest, rest_omega);
    lump.noise = rest->noise + vmi_inertia_trace(&rest->inertia) * (vmi_norm1(rest_omega) + vmi_norm1(frame->omega));
    status = vmi_lump_clamp_moments(&lump, &p);
    if (status) return status;
    if (vmi_lump_spin(&own, &lump, &p, vm_sub(part->omega, own.omega), &spin)) status = VM_NULL_AXIS;
    part->omega = vm_add(own.omega, spin);
    return status;
}

/* How a part must leave, so that the rest moves as wanted: the inverse of vm_separate. *moving becomes a copy of *part
   with another motion. The velocity of *moving makes the rest move at the velocity *rest_v_or_NULL (m/s), and its
   angular velocity makes the rest turn with the angular velocity *rest_omega_or_NULL (rad/s). If one of these two
   pointers is NULL, *moving keeps the velocity, or the angular velocity, of *part.
     - If *rest_omega_or_NULL is the vector 0, the rest does not turn (Table 2 of [1], cases 5 and 7; Table 4, case 2).
     - If *rest_v_or_NULL is the vector 0, the mass centre of the rest is at rest (Table 2, case 7; Table 3, cases 6
       and 8).
     - If *rest_omega_or_NULL is the angular velocity of the whole, the rest turns as the whole did (Table 3, case 7).

   Returns VM_NULL_AXIS (> 0) if the part would need angular momentum about an axis with zero moment of inertia. In this
   case *moving has the needed angular momentum about all other axes, and the rest keeps what is missing. If the rest
   has no inertia about an axis (a rod or a point), no part can turn it about this axis: its spin about the axis remains
   that of the whole, and the status does not tell this. The other statuses are those of vm_separate. */
VM_API int vm_separation_for_rest(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                  const vm_vec3 *rest_v_or_NULL, const vm_vec3 *rest_omega_or_NULL, vm_body *moving)
{
    const vmi_bodies parts = vmi_bodies_in_space(1, part);
    vmi_frame frame;
    vmi_lump rest;
    vm_body b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (rest_v_or_NULL && !vmi_vec3_is_finite(*rest_v_or_NULL)) return VM_NOT_FINITE;
    if (rest_omega_or_NULL && !vmi_vec3_is_finite(*rest_omega_or_NULL)) return VM_NOT_FINITE;
    status = vmi_check_jump(whole, &parts, external_or_NULL);
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) b.v = vmi_part_velocity(whole, part, external_or_NULL, *rest_v_or_NULL);
    status = vmi_unturned_rest(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) status = vmi_turn_part(&frame, &rest, *rest_omega_or_NULL, &b);
    if (status < 0) return status;
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* ---- the plane ---- */

/* Sets vx and vy of *part to the velocity that the part must have so that the rest moves at the velocity rest_v
   (components x, y), in the plane */
VM_API void vmi_push_part2(const vm_body2 *whole, const vm_impulse2 *external_or_NULL, const vm_real *rest_v,
                           vm_body2 *part)
{
    const vm_body from = vmi_body_to_space(whole), leaving = vmi_body_to_space(part);
    const vm_impulse *given = NULL;
    vm_impulse impulse;
    vm_vec3 v;
    if (external_or_NULL) {
        impulse = vmi_impulse_to_space(external_or_NULL);
        given = &impulse;
    }
    v = vmi_part_velocity(&from, &leaving, given, vmi_vec3(rest_v[0], rest_v[1], 0));
    part->vx = v.x;
    part->vy = v.y;
}

/* Sets *rest, in the plane, to what would remain if the part left with its own velocity but with the angular velocity
   of the whole. Sets *frame to the frame of the jump. */
VM_API int vmi_unturned_rest2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                              vmi_frame *frame, vmi_lump *rest)
{
    vm_body2 unturned = *part;
    const vmi_bodies list = vmi_bodies_in_plane(1, &unturned);
    if (!VM_IS_FINITE(part->vx) || !VM_IS_FINITE(part->vy)) return VM_NOT_FINITE;
    unturned.omega = whole->omega;
    return vmi_jump_total2(whole, &list, VMI_SEPARATE, external_or_NULL, frame, rest);
}

/* Sets part->omega, in the plane, to the angular velocity that makes the rest turn with the angular velocity
   rest_omega. Returns VM_NULL_AXIS if the part is a point but would need angular momentum about itself, else VM_OK. */
VM_API int vmi_turn_part2(const vm_body2 *whole, const vmi_frame *frame, const vmi_lump *rest, vm_real rest_omega,
                          vm_body2 *part)
{
    vmi_lump lump = *rest;
    vm_real spin;
    int left;
    lump.inertia.zz = part->inertia;
    lump.h = vmi_part_spin_momentum(frame, rest, vmi_vec3(0, 0, rest_omega));
    lump.noise += rest->inertia.zz * (VM_FABS(rest_omega) + VM_FABS(whole->omega));
    left = vmi_lump_spin2(&lump, part->omega - whole->omega, &spin);
    part->omega = spin + whole->omega;
    return left ? VM_NULL_AXIS : VM_OK;
}

/* How a part must leave in the plane, so that the rest moves as wanted: the inverse of vm_separate2. *moving becomes a
   copy of *part with another motion. The velocity of *moving makes the rest move at (rest_v_or_NULL[0],
   rest_v_or_NULL[1]), in m/s along x and y. Its angular velocity makes the rest turn with the angular velocity
   *rest_omega_or_NULL, in rad/s. If one of these two pointers is NULL, *moving keeps the velocity, or the angular
   velocity, of *part. The statuses are those of vm_separation_for_rest. */
VM_API int vm_separation_for_rest2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                   const vm_real *rest_v_or_NULL, const vm_real *rest_omega_or_NULL,
                                   vm_body2 *moving)
{
    const vmi_bodies parts = vmi_bodies_in_plane(1, part);
    vmi_frame frame;
    vmi_lump rest;
    vm_body2 b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (rest_v_or_NULL && !(VM_IS_FINITE(rest_v_or_NULL[0]) && VM_IS_FINITE(rest_v_or_NULL[1])))
        return VM_NOT_FINITE;
    if (rest_omega_or_NULL && !VM_IS_FINITE(*rest_omega_or_NULL)) return VM_NOT_FINITE;
    status = vmi_check_jump2(whole, &parts, external_or_NULL);
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) vmi_push_part2(whole, external_or_NULL, rest_v_or_NULL, &b);
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) status = vmi_turn_part2(whole, &frame, &rest, *rest_omega_or_NULL, &b);
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* Velocity that a part must have in the plane, so that the rest turns with rest_omega (rad/s). *moving becomes a copy
   of *part with the new velocity; the velocity in *part is not read. The part keeps its angular velocity. Let S and S2
   be the mass centres of whole and part, and v_r the velocity of *moving relative to the turning whole. Only the
   component of v_r across the line SS2 turns the rest, so the function makes v_r orthogonal to SS2. If rest_omega is
   the angular velocity of the whole, this is case 7 of Table 3 in the dissertation, corrected. Returns VM_SINGULAR if S
   and S2 are one point, because then no velocity turns the rest. If the rest is a point, its angular velocity remains
   that of the whole. The other statuses are those of vm_separate2. */
VM_API int vm_separation_for_spin2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                   vm_real rest_omega, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_lump rest;
    vm_body2 b;
    vmi_bodies parts;
    vm_real dx, dy, h, c;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(rest_omega)) return VM_NOT_FINITE;
    b = *part;
    dx = b.x - whole->x; /* the vector SS2 */
    dy = b.y - whole->y;
    b.vx = whole->vx - whole->omega * dy; /* at first v_r = 0: the part moves as if it were fixed to the whole */
    b.vy = whole->vy + whole->omega * dx;
    parts = vmi_bodies_in_plane(1, &b);
    status = vmi_check_jump2(whole, &parts, external_or_NULL);
    if (!status) status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (dx == 0 && dy == 0) return VM_SINGULAR;
    /* h is the angular momentum, relative to the turning whole, that is still missing after the angular velocities of
       part and rest are set. The velocity v_r = c k x SS2 of the part must supply it: m M/M1 SS2 x v_r = h k. M, m and
       M1 are the masses of whole, part and rest; k is the unit vector along z. */
    h = rest.h.z - b.inertia * (b.omega - whole->omega) - rest.inertia.zz * (rest_omega - whole->omega);
    c = h / b.mass * (rest.mass / whole->mass) / (dx * dx + dy * dy); /* products of masses may overflow */
    b.vx -= c * dy;
    b.vy += c * dx;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return VM_OK;
}

#endif
