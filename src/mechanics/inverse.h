/* mechanics/inverse.h - how a part must leave for the rest to move as wanted */
#ifndef VARMASS_MECHANICS_INVERSE_H
#define VARMASS_MECHANICS_INVERSE_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "jumps.h"
#include "jumps2.h"
#include "vectors.h"

/* (24) for v2: v + (linear - M1 (v1 - v))/m */
VM_API vm_vec3 vmi_part_velocity(const vm_body *whole, const vm_body *part, const vm_impulse *external,
                                 vm_vec3 rest_v)
{
    vm_vec3 momentum = vmi_scale(part->mass - whole->mass, vmi_sub(rest_v, whole->v));
    if (external) momentum = vmi_add(momentum, external->linear);
    return vmi_add(whole->v, vmi_vec3(momentum.x / part->mass, momentum.y / part->mass, momentum.z / part->mass));
}

/* The I2 Omega_r of the part with which the rest turns with rest_omega: h - I1 (rest_omega - Omega), where h is what
   the rest has when the part does not turn relative to the whole */
VM_API vm_vec3 vmi_part_spin_momentum(const vmi_frame *frame, const vmi_lump *rest, vm_vec3 rest_omega)
{
    vm_vec3 turning = vmi_times_transposed(&frame->turn, vmi_sub(rest_omega, frame->omega));
    return vmi_sub(rest->h, vmi_times(&frame->turn, vmi_inertia_times(&rest->inertia, turning)));
}

/* The load that the rest would be, with the part leaving at b's velocity but turning with the whole */
VM_API int vmi_unturned_rest(const vm_body *whole, const vm_body *b, const vm_impulse *external, vmi_frame *frame,
                             vmi_lump *rest)
{
    vm_body unturned = *b;
    vmi_bodies list;
    vmi_principal p;
    int status = vmi_check_body(whole);
    list.n = 1;
    list.in_space = &unturned;
    list.in_plane = NULL;
    if (!status) status = vmi_check_bodies(&list);
    if (status) return status;
    unturned.omega = whole->omega;
    *frame = vmi_frame_of(whole, &list, -1);
    status = vmi_jump_total(frame, whole, -1, &list, external, rest);
    return status ? status : vmi_lump_clamp_moments(rest, &p);
}

/* The inverse question: how must the part leave for the rest to move as wanted? *moving is the part with the velocity
   that gives the rest the velocity *rest_v, and then the angular velocity that gives it *rest_omega; what is not
   asked for (NULL) stays the part's. *rest_omega = 0: no rotation (Table 2, 5 and 7; Table 4, 2); *rest_v = 0 too: at
   rest (Table 3, 6 and 8); the whole's own motion: unchanged (Table 3, 7).
   VM_NULL_AXIS where the part would have to spin about an axis without inertia; errors as vm_separate. */
VM_API int vm_separation_for_rest(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                           const vm_vec3 *rest_v_or_NULL, const vm_vec3 *rest_omega_or_NULL, vm_body *moving)
{
    vmi_frame frame, own;
    vmi_lump rest, load;
    vmi_principal p;
    vm_body b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    status = vmi_check_body(part); /* before the division by its mass */
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) b.v = vmi_part_velocity(whole, part, external_or_NULL, *rest_v_or_NULL);
    status = vmi_unturned_rest(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) {
        own = frame;
        own.q = b.q;
        own.turn = vmi_rotation(b.q); /* along the part's axes */
        load = vmi_lump_of(&own, &b);
        load.h = vmi_part_spin_momentum(&frame, &rest, *rest_omega_or_NULL);
        load.noise = rest.noise +
                     vmi_trace(&rest.inertia) * (vmi_norm1(*rest_omega_or_NULL) + vmi_norm1(frame.omega));
        status = vmi_lump_clamp_moments(&load, &p);
        if (status) return status;
        if (vmi_lump_spin(&own, &load, &p, vmi_sub(b.omega, own.omega), &b.omega)) status = VM_NULL_AXIS;
        b.omega = vmi_add(own.omega, b.omega);
    }
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* The same as vmi_unturned_rest */
VM_API int vmi_unturned_rest2(const vm_body2 *whole, const vm_body2 *b, const vm_impulse2 *external,
                              vmi_frame *frame, vmi_lump *rest)
{
    vm_body2 unturned = *b;
    vmi_bodies list;
    int status = vmi_check_body2(b);
    if (status) return status;
    unturned.omega = whole->omega;
    list.n = 1;
    list.in_space = NULL;
    list.in_plane = &unturned;
    return vmi_jump_total2(whole, &list, -1, external, frame, rest);
}

/* The same in the plane; *rest_v is vx, vy */
VM_API int vm_separation_for_rest2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                            const vm_real *rest_v_or_NULL, const vm_real *rest_omega_or_NULL, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_lump rest, load;
    vm_body2 b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    status = vmi_check_body2(part);
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) {
        const vm_body from = vmi_body_to_space(whole), leaving = vmi_body_to_space(part);
        vm_impulse blow;
        vm_vec3 v;
        if (external_or_NULL) blow = vmi_impulse_to_space(external_or_NULL);
        v = vmi_part_velocity(&from, &leaving, external_or_NULL ? &blow : NULL,
                              vmi_vec3(rest_v_or_NULL[0], rest_v_or_NULL[1], 0));
        b.vx = v.x;
        b.vy = v.y;
    }
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) {
        load = rest;
        load.inertia.zz = b.inertia;
        load.h = vmi_part_spin_momentum(&frame, &rest, vmi_vec3(0, 0, *rest_omega_or_NULL));
        load.noise += rest.inertia.zz * (VM_FABS(*rest_omega_or_NULL) + VM_FABS(whole->omega));
        if (vmi_lump_spin2(&load, b.omega - whole->omega, &b.omega)) status = VM_NULL_AXIS;
        b.omega += whole->omega;
    }
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* The part keeps its spin: which velocity gives the rest the angular velocity rest_omega? Of those that do, the one
   with the least v_r, which is orthogonal to SS2; any v_r along SS2 may be added (Table 3, 7, asked for v_r).
   VM_SINGULAR where SS2 = 0; errors as vm_separate2. */
/* What is left of h - I1 (rest_omega - Omega) must be m M/M1 SS2 x v_r, with v_r = c k x SS2 */
VM_API int vm_separation_for_spin2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_real rest_omega, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_lump rest;
    vm_body2 b;
    vm_real dx, dy, h, c;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(rest_omega)) return VM_NOT_FINITE;
    b = *part;
    dx = b.x - whole->x;
    dy = b.y - whole->y;
    b.vx = whole->vx - whole->omega * dy;
    b.vy = whole->vy + whole->omega * dx;
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (dx == 0 && dy == 0) return VM_SINGULAR;
    h = rest.h.z - b.inertia * (b.omega - whole->omega) - rest.inertia.zz * (rest_omega - whole->omega);
    c = h * rest.mass / (b.mass * whole->mass * (dx * dx + dy * dy));
    b.vx -= c * dy;
    b.vy += c * dx;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return VM_OK;
}

#endif
