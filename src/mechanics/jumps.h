/* mechanics/jumps.h - parts separate from a body or are attached to it */
#ifndef VARMASS_MECHANICS_JUMPS_H
#define VARMASS_MECHANICS_JUMPS_H

#include "../base/real.h"
#include "../base/status.h"
#include "bodies.h"
#include "inertia.h"
#include "vectors.h"

/* Separation (sign = -1) and attachment (+1) of another body, with d = SS2, M1 = M + sign m, every inertia about its
   own mass centre, and the impulse's moment about S1:
     r1 = r + sign m/M1 d (15),  v1 = (M v + sign m v2 + linear)/M1 (24),  I1 = I + sign (I2 + m M/M1 P(d)),
     I1 omega1 = I omega + sign (I2 omega2 + m M/M1 d x (v2 - v)) + moment (33), (34)
   which is the same law for both with a negative mass and inertia for what leaves, and the same in a frame that turns
   with any Omega, when omegas and v2 - v are those relative to it, (42) in space. The frame is chosen so that what
   cancels is small: it moves with the heaviest body, and for a separation it turns with the whole. */
typedef struct VM_TAG(vmi_frame) {
    vm_quat q; /* of the first body, along whose axes inertias are added up */
    vmi_mat3 turn;
    vm_vec3 r, v, omega;
} vmi_frame;

/* What a body brings into the jump, or a sum of such */
typedef struct VM_TAG(vmi_lump) {
    vm_real mass;
    vm_vec3 r, v;              /* from the frame's */
    vm_vec3 h;                 /* I (omega - Omega) */
    vm_inertia inertia, sizes; /* and the sizes of the terms that its entries are sums of */
    vm_real noise;             /* h is right to some eps of this */
} vmi_lump;

VM_API vmi_lump vmi_lump_of(const vmi_frame *frame, const vm_body *body)
{
    vmi_mat3 turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, own = vmi_rotation(body->q);
    const vm_quat p = body->q, q = frame->q;
    vm_vec3 spin = vmi_sub(body->omega, frame->omega);
    vmi_lump load;
    if (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z) { /* equal attitudes cost no digits */
        turn.x = vmi_times_transposed(&own, frame->turn.x);
        turn.y = vmi_times_transposed(&own, frame->turn.y);
        turn.z = vmi_times_transposed(&own, frame->turn.z);
    }
    load.mass = body->mass;
    load.r = vmi_sub(body->r, frame->r);
    load.v = vmi_sub(body->v, frame->v);
    load.h = vmi_times(&own, vmi_inertia_times(&body->inertia, vmi_times_transposed(&own, spin)));
    load.inertia = vmi_inertia_along(&body->inertia, &turn);
    load.sizes = vmi_inertia_sizes(&body->inertia, &turn);
    load.noise = vmi_trace(&body->inertia) * (vmi_norm1(body->omega) + vmi_norm1(frame->omega));
    return load;
}

/* P(d) in the frame's axes, and the sizes of its terms when d has the rounding errors of positions of size reach */
VM_API vm_inertia vmi_moved_inertia(const vmi_frame *frame, vm_vec3 d, vm_vec3 reach, vm_inertia *sizes)
{
    vmi_mat3 turn;
    vm_vec3 size;
    turn.x = vmi_abs(frame->turn.x);
    turn.y = vmi_abs(frame->turn.y);
    turn.z = vmi_abs(frame->turn.z);
    size = vmi_times_transposed(&turn, vmi_abs(d));
    reach = vmi_times_transposed(&turn, reach);
    *sizes = vmi_inertia_of_point(vmi_add(size, reach)); /* d^2 and 2 d reach */
    *sizes = vmi_inertia_plus(*sizes, -1, vmi_inertia_of_point(reach));
    sizes->xy = VM_FABS(sizes->xy);
    sizes->xz = VM_FABS(sizes->xz);
    sizes->yz = VM_FABS(sizes->yz);
    return vmi_inertia_of_point(vmi_times_transposed(&frame->turn, d));
}

/* a + sign b */
VM_API int vmi_join(const vmi_frame *frame, vmi_lump *a, vm_real sign, const vmi_lump *b)
{
    const vm_real mass = a->mass + sign * b->mass, share = sign * (b->mass / mass), reduced = a->mass * share;
    vm_vec3 origin = vmi_abs(frame->r), d = vmi_sub(b->r, a->r), v = vmi_sub(b->v, a->v);
    vm_vec3 reach = vmi_add(vmi_add(vmi_abs(a->r), vmi_abs(b->r)), vmi_add(origin, origin));
    vm_vec3 u = vmi_sub(v, vmi_cross(frame->omega, d));
    vm_real speeds = vmi_norm1(a->v) + vmi_norm1(b->v) + 2 * vmi_norm1(frame->v), turning = vmi_norm1(frame->omega);
    vm_inertia sizes, moved = vmi_moved_inertia(frame, d, reach, &sizes);
    if (!(mass > 0)) return VM_BAD_MASS;
    a->inertia = vmi_inertia_plus(vmi_inertia_plus(a->inertia, sign, b->inertia), reduced, moved);
    a->sizes = vmi_inertia_plus(vmi_inertia_plus(a->sizes, 1, b->sizes), VM_FABS(reduced), sizes);
    a->h = vmi_add(a->h, vmi_add(vmi_scale(sign, b->h), vmi_scale(reduced, vmi_cross(d, u))));
    a->noise += b->noise + VM_FABS(reduced) * vmi_norm1(d) * speeds +
                (sign < 0 ? b->mass : reduced) * vmi_norm1(reach) * (vmi_norm1(d) * turning + vmi_norm1(u));
    if (b->mass > a->mass) { /* from the heavier, so that a light body's motion costs no digits of it */
        a->r = vmi_sub(b->r, vmi_scale(a->mass / mass, d));
        a->v = vmi_sub(b->v, vmi_scale(a->mass / mass, v));
    } else {
        a->r = vmi_add(a->r, vmi_scale(share, d));
        a->v = vmi_add(a->v, vmi_scale(share, v));
    }
    a->mass = mass;
    return VM_OK;
}

VM_API void vmi_apply_impulse(const vmi_frame *frame, vmi_lump *a, const vm_impulse *external)
{
    vm_vec3 at = vmi_sub(vmi_sub(external->at, frame->r), a->r), j = external->linear;
    a->v = vmi_add(a->v, vmi_vec3(j.x / a->mass, j.y / a->mass, j.z / a->mass));
    a->h = vmi_add(a->h, vmi_add(external->couple, vmi_cross(at, j)));
    a->noise += vmi_norm1(external->couple) + (vmi_norm1(at) + vmi_norm1(frame->r)) * vmi_norm1(j);
}

VM_API vmi_frame vmi_frame_of(const vm_body *body, const vmi_bodies *others, vm_real sign)
{
    vm_real mass = body->mass;
    vmi_frame frame;
    int i;
    frame.q = body->q;
    frame.turn = vmi_rotation(body->q);
    frame.r = body->r;
    frame.v = body->v;
    frame.omega = sign < 0 || others->n == 0 ? body->omega : vmi_vec3(0, 0, 0);
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

/* The body with the others joined (sign = 1) or without them (-1), struck by the impulse */
VM_API int vmi_jump_total(const vmi_frame *frame, const vm_body *body, vm_real sign, const vmi_bodies *others,
                          const vm_impulse *external, vmi_lump *total)
{
    vmi_lump sum = vmi_lump_of(frame, body);
    int i, status = VM_OK;
    *total = sum;
    for (i = 0; i < others->n && !status; i++) {
        const vm_body other = vmi_list_body(others, i);
        const vmi_lump load = vmi_lump_of(frame, &other);
        if (i == 0) sum = load;
        else status = vmi_join(frame, &sum, 1, &load);
    }
    if (others->n > 0 && !status) status = vmi_join(frame, total, sign, &sum);
    if (status || !external) return status;
    if (!vmi_impulse_finite(external)) return VM_NOT_FINITE;
    vmi_apply_impulse(frame, total, external);
    return VM_OK;
}

/* The angular velocity, relative to the frame, of a load whose inertia has been settled */
VM_API int vmi_lump_spin(const vmi_frame *frame, const vmi_lump *load, const vmi_principal *p, vm_vec3 before,
                         vm_vec3 *omega)
{
    const vm_real noise = 2 * VM_EPSILON * (load->noise + vmi_norm1(load->h));
    int left = vmi_solve_spin(&load->inertia, p, vmi_times_transposed(&frame->turn, load->h), noise,
                              vmi_times_transposed(&frame->turn, before), omega);
    *omega = vmi_times(&frame->turn, *omega);
    return left;
}

VM_API int vmi_lump_clamp_moments(vmi_lump *load, vmi_principal *p)
{
    if (!vmi_inertia_finite(&load->inertia)) return VM_NOT_FINITE;
    *p = vmi_principal_axes(&load->inertia);
    if (!vmi_inertia_is_possible(p, vmi_slack(&load->sizes))) return VM_BAD_INERTIA;
    if (vmi_clamp_moments(p, &load->sizes)) load->inertia = vmi_inertia_from(p);
    return VM_OK;
}

VM_API int vmi_jump(const vm_body *body, int n, const vm_body *others, vm_real sign, const vm_impulse *external,
                    vm_body *result)
{
    vmi_bodies list;
    vmi_frame frame;
    vmi_lump load;
    vmi_principal p;
    vm_body b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    list.n = n;
    list.in_space = others;
    list.in_plane = NULL;
    status = vmi_check_body(body);
    if (!status) status = vmi_check_bodies(&list);
    if (status) return status;
    frame = vmi_frame_of(body, &list, sign);
    status = vmi_jump_total(&frame, body, sign, &list, external, &load);
    if (!status) status = vmi_lump_clamp_moments(&load, &p);
    if (status) return status;
    b.mass = load.mass;
    b.inertia = load.inertia;
    b.q = body->q;
    b.r = vmi_add(frame.r, load.r);
    b.v = vmi_add(frame.v, load.v);
    if (vmi_lump_spin(&frame, &load, &p, vmi_sub(body->omega, frame.omega), &b.omega)) status = VM_NULL_AXIS;
    b.omega = vmi_add(frame.omega, b.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* A part, which moved as given the instant after, has left the whole: rest gets mass, mass centre (15), inertia by
   the parallel axes, velocity (24) and angular velocity (34) of what remains; its attitude is the whole's.
   external, where not NULL, acted during the instant. Exact in space: momentum and angular momentum of rest and
   part are those of the whole plus the impulse. Where the rest is a rod or a point the spin about its null axis
   stays the whole's; VM_NULL_AXIS says that there was angular momentum left which that axis cannot carry.

   A part that moves on as before leaves the rest's motion as it was, however little of the inertia is left: only
   motions relative to the whole are added up, so that neither its speed nor a place far from the origin costs digits
   of omega. The rest's inertia is right to 8 eps of the whole's, far from the origin to what an eps of the positions
   changes; a moment below that counts as none.
   VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS (a part as heavy as the whole, for one), VM_BAD_INERTIA (a part that
   cannot have been in the whole, for one). */
VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL, vm_body *rest)
{
    return vmi_jump(whole, 1, part, -1, external_or_NULL, rest);
}

/* Two bodies, moving as given the instant before, have become one (which is plastic impact) (24), (33): its attitude
   is body's, and so is the spin about a null axis. */
VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole)
{
    return vmi_jump(body, 1, added, 1, external_or_NULL, whole);
}

/* n parts at once, n >= 0: but for rounding errors what comes of one after another. n = 0 is a blow on the body. */
VM_API int vm_separate_all(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                           vm_body *rest)
{
    return vmi_jump(whole, n, parts, -1, external_or_NULL, rest);
}

/* Documented with vm_separate_all. */
VM_API int vm_attach_all(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                         vm_body *whole)
{
    return vmi_jump(body, n, added, 1, external_or_NULL, whole);
}

VM_API vm_body vmi_body_at_rest(vm_real mass, const vm_inertia *inertia, vm_vec3 r)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = mass;
    b.inertia = *inertia;
    b.r = r;
    return b;
}

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

/* Inertia, about its own mass centre, of a and b together, and of what is left of the whole without the part
   (13)-(15), (40). d leads from the mass centre of the first to that of the second, *centre from that of the first to
   the result's: SS2 and SS1 of (15). One set of axes. Accuracy and errors are those of vm_attach and vm_separate. */
VM_API int vm_combine_inertia(vm_real mass_a, const vm_inertia *a, vm_real mass_b, const vm_inertia *b, vm_vec3 d,
                              vm_inertia *whole, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass_a, a, 1, mass_b, b, d, whole, centre);
}

/* Documented with vm_combine_inertia. */
VM_API int vm_split_inertia(vm_real mass, const vm_inertia *whole, vm_real part_mass, const vm_inertia *part,
                            vm_vec3 d, vm_inertia *rest, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass, whole, -1, part_mass, part, d, rest, centre);
}

#endif
