/* mechanics/jumps.h - parts separate from a body or are attached to it, in space
   At the instant of a jump a body's mass, mass centre, inertia, velocity and angular velocity change, by the equations
   (13)-(15), (24), (33), (34), (40) of the dissertation [1]. The attitude stays the same. An impulse may act at the
   same instant. Any number of parts may separate or be attached at once.

       vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
       vm_body part = {1, {0.1, 0.1, 0.1, 0, 0, 0}, {1, 0, 0, 0}, {0.4, 0, 0}, {10, 2, 0}, {0, 0, 3}}, rest;
       int status = vm_separate(&whole, &part, NULL, &rest); // VM_OK: `rest` has the motion after the separation

   The functions for jumps in the plane are in jumps2.h. For parts whose motion is known relative to the body, use
   relative.h. Functions in inverse.h find how a part must leave, so that the rest moves as wanted. The energy of a
   jump is in jump_energy.h. Tests: tests/test_jumps.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_JUMPS_H
#define VARMASS_MECHANICS_JUMPS_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "vectors.h"

/* How a jump is computed. A body has the mass M, the velocity v, the inertia I, the angular velocity omega and the
   mass centre S at r. Another body, with m, v2, I2, omega2 and S2, is attached to the first body (sign = 1) or
   separates from it (sign = -1). After the jump the first body has the mass M1 = M + sign m, and v1, I1, omega1, and
   S1 at r1. Each inertia is about the body's own mass centre. The vector d leads from S to S2. x is the cross product,
   E the unit matrix, and P(d) = |d|^2 E - d d^T. An impulse `linear` with the moment `moment` about S1 may act. Then
     r1 = r + sign m/M1 d (15),  v1 = (M v + sign m v2 + linear)/M1 (24),  I1 = I + sign (I2 + m M/M1 P(d)),
     I1 omega1 = I omega + sign (I2 omega2 + m M/M1 d x (v2 - v)) + moment (33), (34)
   A separation is therefore computed as an attachment of negative mass and inertia.

   These equations also hold in a frame that moves, and turns with any angular velocity Omega, if all omegas and v2 - v
   are taken relative to the frame (42). The code uses a frame in which terms that cancel are small, so that few digits
   are lost. This frame moves with the heaviest body, and at a separation it also turns with the whole. */
enum { VMI_SEPARATE = -1, VMI_ATTACH = 1 }; /* the values of all parameters named `sign` */

/* The frame of a jump */
typedef struct VM_TAG(vmi_frame) {
    vm_quat q;           /* attitude of the body that the jump changes; inertias are added along this body's axes */
    vmi_mat3 turn;       /* the rotation matrix of q */
    vm_vec3 r, v, omega; /* position, velocity and angular velocity of the frame */
} vmi_frame;

/* A lump: the mass, motion and inertia of a body, or of several bodies joined, relative to the frame of a jump */
typedef struct VM_TAG(vmi_lump) {
    vm_real mass;
    vm_vec3 r, v;       /* position and velocity of the mass centre, minus r and v of the frame */
    vm_vec3 h;          /* angular momentum about the mass centre, relative to the frame; inertial axes */
    vm_inertia inertia; /* inertia about the lump's mass centre, along the axes given by the frame's q */
    vm_inertia sizes;   /* for each entry of `inertia`, the sum of the absolute values of the entry's terms */
    vm_real noise;      /* the sum of the absolute values of the terms of h; the error of h is a few eps times noise */
} vmi_lump;

VM_API vmi_lump vmi_lump_of(const vmi_frame *frame, const vm_body *body)
{
    const vmi_mat3 own = vmi_rotation(body->q);
    const vm_quat p = body->q, q = frame->q;
    const vm_vec3 spin = vm_sub(body->omega, frame->omega);
    vmi_mat3 turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; /* its columns are the frame's axes in body axes */
    vmi_lump lump;
    if (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z) { /* for equal attitudes `turn` stays the identity */
        turn.x = vmi_times_transposed(&own, frame->turn.x);
        turn.y = vmi_times_transposed(&own, frame->turn.y);
        turn.z = vmi_times_transposed(&own, frame->turn.z);
    }
    lump.mass = body->mass;
    lump.r = vm_sub(body->r, frame->r);
    lump.v = vm_sub(body->v, frame->v);
    lump.h = vmi_times(&own, vmi_inertia_times(&body->inertia, vmi_times_transposed(&own, spin)));
    lump.inertia = vmi_inertia_along(&body->inertia, &turn);
    lump.sizes = vmi_inertia_sizes(&body->inertia, &turn);
    lump.noise = vmi_inertia_trace(&body->inertia) * (vmi_norm1(body->omega) + vmi_norm1(frame->omega));
    return lump;
}

/* Returns P(d) = |d|^2 E - d d^T, with the unit matrix E, along the frame's axes. d is the difference of two positions;
   `reach` contains, for each coordinate, the sum of the absolute values of all numbers from which the difference is
   computed. The errors of P(d) are a few eps times *sizes. */
VM_API vm_inertia vmi_moved_inertia(const vmi_frame *frame, vm_vec3 d, vm_vec3 reach, vm_inertia *sizes)
{
    vmi_mat3 turn;
    vm_vec3 size;
    turn.x = vmi_abs(frame->turn.x);
    turn.y = vmi_abs(frame->turn.y);
    turn.z = vmi_abs(frame->turn.z);
    size = vmi_times_transposed(&turn, vmi_abs(d));
    reach = vmi_times_transposed(&turn, reach);
    *sizes = vmi_inertia_of_point(vm_add(size, reach)); /* (|d| + reach)^2; the next line subtracts reach^2 again */
    *sizes = vmi_inertia_plus(*sizes, -1, vmi_inertia_of_point(reach));
    sizes->xy = VM_FABS(sizes->xy);
    sizes->xz = VM_FABS(sizes->xz);
    sizes->yz = VM_FABS(sizes->yz);
    return vmi_inertia_of_point(vmi_times_transposed(&frame->turn, d));
}

/* Returns by how much a->noise, the measure of rounding errors, grows when the lump b joins or leaves the lump a. The
   result is b->noise plus the absolute values of the terms of the product reduced (d x slip), where `slip` is the
   velocity of b relative to a. vmi_join computes d, `reduced`, `reach` and `slip`. */
VM_API vm_real vmi_join_noise(const vmi_frame *frame, const vmi_lump *a, vm_real sign, const vmi_lump *b,
                              vm_real reduced, vm_vec3 reach, vm_vec3 slip)
{
    const vm_real distance = vmi_norm1(vm_sub(b->r, a->r));
    const vm_real speeds = vmi_norm1(a->v) + vmi_norm1(b->v) + 2 * vmi_norm1(frame->v);
    const vm_real moved = sign < 0 ? b->mass : reduced;
    return b->noise + VM_FABS(reduced) * distance * speeds +
           moved * vmi_norm1(reach) * (distance * vmi_norm1(frame->omega) + vmi_norm1(slip));
}

/* Attaches lump b to a (sign 1) or separates b from a (sign -1). Returns VM_BAD_MASS if no mass is left, else VM_OK. */
VM_API int vmi_join(const vmi_frame *frame, vmi_lump *a, vm_real sign, const vmi_lump *b)
{
    const vm_real mass = a->mass + sign * b->mass;
    const vm_real share = sign * (b->mass / mass), reduced = a->mass * share; /* b's share of mass; reduced mass */
    const vm_vec3 d = vm_sub(b->r, a->r), v = vm_sub(b->v, a->v);
    const vm_vec3 slip = vm_sub(v, vm_cross(frame->omega, d)); /* velocity of b relative to a in the turning frame */
    const vm_vec3 origin = vmi_abs(frame->r);
    const vm_vec3 reach = vm_add(vm_add(vmi_abs(a->r), vmi_abs(b->r)), vm_add(origin, origin));
    vm_inertia sizes, moved = vmi_moved_inertia(frame, d, reach, &sizes);
    if (!(mass > 0)) return VM_BAD_MASS;
    a->noise += vmi_join_noise(frame, a, sign, b, reduced, reach, slip);
    a->inertia = vmi_inertia_plus(vmi_inertia_plus(a->inertia, sign, b->inertia), reduced, moved);
    a->sizes = vmi_inertia_plus(vmi_inertia_plus(a->sizes, 1, b->sizes), VM_FABS(reduced), sizes);
    a->h = vm_add(a->h, vm_add(vm_scale(sign, b->h), vm_scale(reduced, vm_cross(d, slip))));
    if (b->mass > a->mass) { /* start from r and v of the heavier body, so that no digits are lost */
        a->r = vm_sub(b->r, vm_scale(a->mass / mass, d));
        a->v = vm_sub(b->v, vm_scale(a->mass / mass, v));
    } else {
        a->r = vm_add(a->r, vm_scale(share, d));
        a->v = vm_add(a->v, vm_scale(share, v));
    }
    a->mass = mass;
    return VM_OK;
}

/* Adds the effect of an impulse to the velocity and the angular momentum of the lump a */
VM_API void vmi_apply_impulse(const vmi_frame *frame, vmi_lump *a, const vm_impulse *external)
{
    const vm_vec3 at = vm_sub(vm_sub(external->at, frame->r), a->r), j = external->linear;
    a->v = vm_add(a->v, vmi_over(j, a->mass));
    a->h = vm_add(a->h, vm_add(external->couple, vm_cross(at, j)));
    a->noise += vmi_norm1(external->couple) + (vmi_norm1(at) + vmi_norm1(frame->r)) * vmi_norm1(j);
}

/* The frame of a jump. The frame moves with the heaviest of all bodies. At a separation, or if only an impulse acts,
   the frame turns with `body`. At an attachment it does not turn. */
VM_API vmi_frame vmi_frame_of(const vm_body *body, const vmi_bodies *others, vm_real sign)
{
    vm_real mass = body->mass;
    vmi_frame frame;
    int i;
    frame.q = body->q;
    frame.turn = vmi_rotation(body->q);
    frame.r = body->r;
    frame.v = body->v;
    frame.omega = vmi_vec3(0, 0, 0);
    if (sign < 0 || others->n == 0) frame.omega = body->omega;
    for (i = 0; i < others->n; i++) {
        const vm_body b = vmi_list_body(others, i);
        if (b.mass > mass) {
            mass = b.mass;
            frame.r = b.r;
            frame.v = b.v;
        }
    }
    return frame;
}

/* Returns VM_OK if the bodies are valid and the impulse is finite, else the error that vmi_first_error selects. */
VM_API int vmi_check_jump(const vm_body *body, const vmi_bodies *others, const vm_impulse *external_or_NULL)
{
    const int status = vmi_first_error(vmi_check_body(body), vmi_check_bodies(others));
    if (!external_or_NULL || vmi_impulse_is_finite(external_or_NULL)) return status;
    return vmi_first_error(status, VM_NOT_FINITE);
}

/* Sets *total to `body` as it is after the jump and the impulse. The bodies `others` are first joined to each other.
   Then they are attached to `body` (sign = 1) or separate from it (sign = -1). Returns VM_BAD_MASS if no mass is left,
   else VM_OK. */
VM_API int vmi_jump_total(const vmi_frame *frame, const vm_body *body, vm_real sign, const vmi_bodies *others,
                          const vm_impulse *external_or_NULL, vmi_lump *total)
{
    vmi_lump sum;
    int i, status = VM_OK;
    *total = vmi_lump_of(frame, body);
    for (i = 0; i < others->n && !status; i++) {
        const vm_body other = vmi_list_body(others, i);
        const vmi_lump lump = vmi_lump_of(frame, &other);
        if (i == 0) sum = lump;
        else status = vmi_join(frame, &sum, 1, &lump);
    }
    if (others->n > 0 && !status) status = vmi_join(frame, total, sign, &sum);
    if (!status && external_or_NULL) vmi_apply_impulse(frame, total, external_or_NULL);
    return status;
}

/* Finds the principal axes of a lump, and corrects rounding errors that make its moments of inertia impossible. Returns
   VM_NOT_FINITE if the inertia is infinite or NaN; VM_BAD_INERTIA if a moment clearly exceeds the sum of the other two;
   else VM_OK. */
VM_API int vmi_lump_clamp_moments(vmi_lump *lump, vmi_principal *p)
{
    if (!vmi_inertia_is_finite(&lump->inertia)) return VM_NOT_FINITE;
    *p = vmi_principal_axes(&lump->inertia);
    if (!vmi_moments_are_possible(p, vmi_inertia_slack(&lump->sizes))) return VM_BAD_INERTIA;
    if (vmi_clamp_moments(p, &lump->sizes)) lump->inertia = vmi_inertia_from(p);
    return VM_OK;
}

/* Sets *omega to the angular velocity, relative to the frame and along inertial axes, of the lump whose principal axes
   are *p. `before` is the angular velocity of the body relative to the frame before the jump. Returns 1 if the lump has
   angular momentum about an axis with zero moment of inertia, which is impossible. Returns 0 otherwise. */
VM_API int vmi_lump_spin(const vmi_frame *frame, const vmi_lump *lump, const vmi_principal *p, vm_vec3 before,
                         vm_vec3 *omega)
{
    const vm_real noise = 2 * VM_EPSILON * (lump->noise + vmi_norm1(lump->h));
    vm_vec3 spin;
    const int left = vmi_solve_spin(&lump->inertia, p, vmi_times_transposed(&frame->turn, lump->h), noise,
                                    vmi_times_transposed(&frame->turn, before), &spin);
    *omega = vmi_times(&frame->turn, spin);
    return left;
}

/* Sets *result to the body `body` after n others are attached to it (sign = 1) or separate from it (sign = -1), while
   an impulse acts. The statuses are those of vm_separate. */
VM_API int vmi_jump(const vm_body *body, int n, const vm_body *others, vm_real sign,
                    const vm_impulse *external_or_NULL, vm_body *result)
{
    const vmi_bodies list = vmi_bodies_in_space(n, others);
    vmi_frame frame;
    vmi_lump lump;
    vmi_principal p;
    vm_body b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_jump(body, &list, external_or_NULL);
    if (status) return status;
    frame = vmi_frame_of(body, &list, sign);
    status = vmi_jump_total(&frame, body, sign, &list, external_or_NULL, &lump);
    if (!status) status = vmi_lump_clamp_moments(&lump, &p);
    if (status) return status;
    b.mass = lump.mass;
    b.inertia = lump.inertia;
    b.q = body->q;
    b.r = vm_add(frame.r, lump.r);
    b.v = vm_add(frame.v, lump.v);
    if (vmi_lump_spin(&frame, &lump, &p, vm_sub(body->omega, frame.omega), &b.omega)) status = VM_NULL_AXIS;
    b.omega = vm_add(frame.omega, b.omega);
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* Separation of a part from a body: *rest is what remains of the whole. The caller sets v and omega of *part to the
   motion after the separation. The function computes mass, mass centre (15), inertia (40), velocity (24) and angular
   velocity (34) of *rest, and copies the attitude of *whole. The impulse, if there is one, acts during the separation.
   The equations are exact in three dimensions: the momentum of rest and part together is that of the whole plus the
   impulse, and the same holds for angular momentum. The pointer rest may be equal to whole or to part.

   If the separation does not change the part's motion, the rest keeps its motion, too, even if little inertia is left.
   The rest's omega loses no digits at high speed or far from the origin, because only motions relative to the whole are
   added. The entries of the rest's inertia are first computed with errors of at most 8 eps of the trace of the whole's
   inertia. If the bodies are at a distance R from the origin, the rounding of positions by eps R adds to these errors.
   A principal moment of the rest that may be only such an error (without R, below 50 eps of the trace) becomes 0, and
   one above the sum of the other two becomes this sum. The angular momentum changes by up to the moment times omega.

   Returns VM_OK, VM_NULL_AXIS or an error. VM_NULL_AXIS (> 0) is a warning: the rest is a rod or a point, which has an
   axis without inertia, but the equations demand angular momentum about this axis. *rest is then set, and turns about
   this axis as the whole did. The errors are VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument or the
   result is infinite or NaN; VM_BAD_MASS if a mass, that of the rest included, is not positive; and VM_BAD_INERTIA for
   an inertia that no body can have. If the part cannot have been in the whole, the rest has an impossible inertia. */
VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL, vm_body *rest)
{
    return vmi_jump(whole, 1, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of one body to another (plastic impact): *whole is the body that the two form together, (24), (33). The
   caller sets v and omega of *body and *added to the motions just before the impact. The impulse, if there is one, acts
   during the impact. The whole has the attitude of `body`. The statuses are those of vm_separate. VM_NULL_AXIS means
   that the whole is a rod or a point that would need angular momentum about an axis without inertia. The spin about
   this axis remains that of `body`. */
VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole)
{
    return vmi_jump(body, 1, added, VMI_ATTACH, external_or_NULL, whole);
}

/* Separation of n parts from a body at once: *rest is what remains. Except for rounding errors, n calls of
   vm_separate, one after the other, give the same result if only one of them gets the impulse. For n = 0 only the
   impulse acts on the body. The statuses are those of vm_separate, and VM_BAD_ARGUMENT for n < 0. */
VM_API int vm_separate_all(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                           vm_body *rest)
{
    return vmi_jump(whole, n, parts, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of n bodies to a body at once: *whole is the body that all of them form together. Except for rounding
   errors, n calls of vm_attach, one after the other, give the same result if only one of them gets the impulse. For
   n = 0 only the impulse acts on the body. The statuses are those of vm_attach, and VM_BAD_ARGUMENT for n < 0. */
VM_API int vm_attach_all(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                         vm_body *whole)
{
    return vmi_jump(body, n, added, VMI_ATTACH, external_or_NULL, whole);
}

/* ---- the inertia of a whole and of its parts ---- */

/* A body at rest, with the mass centre r, whose body axes are parallel to the inertial axes */
VM_API vm_body vmi_body_at_rest(vm_real mass, const vm_inertia *inertia, vm_vec3 r)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = mass;
    b.inertia = *inertia;
    b.r = r;
    return b;
}

/* Sets *joined to the inertia, and *centre to the mass centre, of a body after another body has joined it (sign = 1) or
   left it (sign = -1). The mass centre of the first body is at the origin, and the mass centre of the other body is at
   d. The first body has the mass mass_a and the inertia *a. The other body has the mass mass_b and the inertia *b. */
VM_API int vmi_joined_inertia(vm_real mass_a, const vm_inertia *a, vm_real sign, vm_real mass_b,
                              const vm_inertia *b, vm_vec3 d, vm_inertia *joined, vm_vec3 *centre)
{
    vm_body first, second;
    int status;
    if (!a || !b || !joined || !centre) return VM_BAD_ARGUMENT;
    first = vmi_body_at_rest(mass_a, a, vmi_vec3(0, 0, 0));
    second = vmi_body_at_rest(mass_b, b, d);
    status = vmi_jump(&first, 1, &second, sign, NULL, &first);
    if (!status) {
        *joined = first.inertia;
        *centre = first.r;
    }
    return status;
}

/* Inertia of two bodies together, about their common mass centre: (13)-(15), (40). The axes of all inertias (kg m^2)
   are parallel, and each inertia is about its body's own mass centre. d (m) leads from the mass centre of a to that of
   b. The result *centre (m) leads from the mass centre of a to the common mass centre. Returns VM_BAD_ARGUMENT for a
   null pointer; VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA under the conditions of vm_attach; VM_OK otherwise. */
VM_API int vm_combine_inertia(vm_real mass_a, const vm_inertia *a, vm_real mass_b, const vm_inertia *b, vm_vec3 d,
                              vm_inertia *whole, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass_a, a, VMI_ATTACH, mass_b, b, d, whole, centre);
}

/* Inertia of the rest of a body after a part has left it, about the mass centre of the rest: (13)-(15), (40). This
   function is the inverse of vm_combine_inertia. d (m) leads from the mass centre of the whole to that of the part. The
   result *centre (m) leads from the mass centre of the whole to that of the rest. Statuses: see vm_combine_inertia. */
VM_API int vm_split_inertia(vm_real mass, const vm_inertia *whole, vm_real part_mass, const vm_inertia *part,
                            vm_vec3 d, vm_inertia *rest, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass, whole, VMI_SEPARATE, part_mass, part, d, rest, centre);
}

#endif
