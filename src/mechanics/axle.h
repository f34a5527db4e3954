/* mechanics/axle.h - jumps of a body that turns about a fixed axle

   A body on a fixed axle can only turn about this axle. When a part separates from the body, or another body is
   attached to it, the axle exerts an unknown impulse on the body. Therefore only the balance of the angular momentum
   about the axle determines the motion. The pendulum of the equations (119)-(132) of the dissertation [1] is a special
   case. Here the body may have any shape, and the axle any position and direction. The results are the motion of the
   body after the jump and the impulse of the axle. With n = 0 parts, the functions compute the motion of a body after
   an impulse has hit it, or after an axle has caught it in flight.

       vm_axle hinge = {{0, 0, 0}, {0, 0, 1}};                       // through the origin, along z
       vm_body door = {20, {2, 2, 2, 0, 0, 0}, {1, 0, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, {0, 0, 2}};
       vm_body part = {1, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, 0, 0}}; // leaves at 5 m/s
       vm_impulse reaction;                                          // of the axle on the door
       int status = vm_separate_on_axle(&hinge, &door, 1, &part, NULL, &door, &reaction);

   The equations. e is the unit vector along the axle, which passes through the point O. All motions are measured in a
   frame that turns about the axle at the rate w = e . omega, where omega is the angular velocity of the body before the
   jump. The balances of momentum and angular momentum have the same form in this frame as in an inertial frame (42).
   If the body turned about the axle before the jump, it was at rest in this frame. Let P be the momentum of the body
   before the jump, plus the momenta of the bodies that join, minus those of the bodies that leave, plus the external
   impulse. Let L be the corresponding sum of the angular momenta about O and of the moment of the impulse. Let I be
   the inertia of the body after the jump about O. Then the jump increases the angular velocity w of the body about the
   axle by (e . L)/(e . I e). The axle exerts the impulse M1 v1 - P at O, where M1 is the mass of the body after the
   jump and v1 the velocity of its mass centre in the frame. The axle also exerts a couple, which is orthogonal to the
   axle.
   Tests: tests/test_axle.c. */
#ifndef VARMASS_MECHANICS_AXLE_H
#define VARMASS_MECHANICS_AXLE_H

#include "../base/real.h"
#include "../base/status.h"
#include "attitude.h"
#include "bodies.h"
#include "inertia.h"
#include "jumps.h"
#include "vectors.h"

/* A fixed axle without friction */
typedef struct VM_TAG(vm_axle) {
    vm_vec3 at;   /* a point O of the axle, m */
    vm_vec3 axis; /* direction of the axle, a vector of any length > 0; positive rotations are right-handed about it */
} vm_axle;

/* The sums P and L of the equations above, relative to the turning frame: `linear` is the momentum P (N s), and
   `angular` is the angular momentum L about the point O of the axle (N m s). `arm` is the vector from O to the mass
   centre of the body after the jump (m). */
typedef struct VM_TAG(vmi_axle_sum) {
    vm_vec3 linear, angular, arm;
} vmi_axle_sum;

/* Adds `sign` times the momentum and the angular momentum of a body to *sum. Both are relative to the frame that turns
   about the point O with the angular velocity omega. */
VM_API void vmi_axle_add(vmi_axle_sum *sum, vm_real sign, const vm_body *body, vm_vec3 O, vm_vec3 omega)
{
    const vm_vec3 d = vm_sub(body->r, O), slip = vm_sub(body->v, vm_cross(omega, d));
    const vm_vec3 momentum = vm_scale(body->mass, slip), spin = vmi_spin_momentum_at(body, vm_sub(body->omega, omega));
    sum->linear = vm_add(sum->linear, vm_scale(sign, momentum));
    sum->angular = vm_add(sum->angular, vm_scale(sign, vm_add(spin, vm_cross(d, momentum))));
}

/* The vector from the point O to the mass centre of a body after the jump. `mass` is the mass of the body after the
   jump. The function adds only differences of positions. Far from the origin the position of the new mass centre would
   be rounded, so that its difference from O would lose digits. */
VM_API vm_vec3 vmi_axle_arm(vm_vec3 O, const vm_body *body, int n, const vm_body *others, vm_real sign, vm_real mass)
{
    vm_vec3 shift = {0, 0, 0};
    int i;
    for (i = 0; i < n; i++) {
        const vm_real share = sign * (others[i].mass / mass);
        shift = vm_add(shift, vm_scale(share, vm_sub(others[i].r, body->r)));
    }
    return vm_add(vm_sub(body->r, O), shift);
}

/* Sets *e to the unit vector along the axle. Returns VM_NOT_FINITE if a number of the axle is infinite or NaN;
   VM_DOMAIN if axle->axis is 0; else VM_OK. */
VM_API int vmi_axle_direction(const vm_axle *axle, vm_vec3 *e)
{
    if (!vmi_vec3_is_finite(axle->at) || !vmi_vec3_is_finite(axle->axis)) return VM_NOT_FINITE;
    if (vmi_norm_max(axle->axis) == 0) return VM_DOMAIN;
    *e = vmi_unit_vector(axle->axis);
    return VM_OK;
}

/* The rounding error of the moment of inertia of *b about the axle through O along the unit vector e. The rounding
   errors of e, of the attitude and of the positions enter with their squares, because the moment of a rod about its own
   axis is the least one. */
VM_API vm_real vmi_axle_inertia_error(const vm_body *b, vm_vec3 O, vm_vec3 e)
{
    const vmi_mat3 turn = vmi_rotation(b->q);
    const vm_real reach = VMI_LOST_SHARE * (vmi_norm1(b->r) + vmi_norm1(O));
    const vm_real turned = VMI_LOST_SHARE * vmi_inertia_trace(&b->inertia);
    vmi_mat3 own;
    own.x = own.y = own.z = vmi_times_transposed(&turn, e);
    return VMI_LOST_SHARE * (vmi_inertia_sizes(&b->inertia, &own).xx + turned) + b->mass * (reach * reach);
}

/* Sets the motion of the body *b about the axle, and computes the impulse of the axle. *b must already have the mass,
   the inertia and the position after the jump. *sum contains the quantities that vmi_axle_sum describes. `before` is
   the angular velocity of the body about the axle before the jump. Returns VM_NULL_AXIS if *b has no inertia about the
   axle, apart from rounding errors, but would need angular momentum about it, else VM_OK. */
VM_API int vmi_axle_turn(vm_vec3 O, vm_vec3 e, vm_vec3 before, const vmi_axle_sum *sum, vm_body *b,
                         vm_impulse *reaction)
{
    const vm_vec3 d = sum->arm, speed = vm_cross(e, d); /* velocity of the mass centre at 1 rad/s */
    const vm_vec3 column = vm_add(vmi_spin_momentum_at(b, e), vm_scale(b->mass, vm_cross(d, speed)));
    const vm_real inertia = vm_dot(e, column), momentum = vm_dot(e, sum->angular);
    const vm_real reach = vmi_norm1(b->r) + vmi_norm1(O);
    const vm_real momentum_error = VMI_LOST_SHARE * (vmi_norm1(sum->angular) + reach * vmi_norm1(sum->linear));
    vm_real change = 0;
    vm_vec3 couple;
    int status = VM_OK;
    if (inertia > vmi_axle_inertia_error(b, O, e)) change = momentum / inertia;
    else if (VM_FABS(momentum) > momentum_error) status = VM_NULL_AXIS;
    b->omega = vm_add(before, vm_scale(change, e));
    b->v = vm_cross(b->omega, d);
    reaction->at = O;
    reaction->linear = vm_sub(vm_scale(b->mass * change, speed), sum->linear);
    couple = vm_sub(vm_scale(change, column), sum->angular);
    reaction->couple = vm_sub(couple, vm_scale(vm_dot(e, couple), e)); /* the axle turns freely */
    return status;
}

/* Computes the jump for vm_separate_on_axle and vm_attach_on_axle; `sign` is VMI_SEPARATE or VMI_ATTACH. */
VM_API int vmi_axle_jump(const vm_axle *axle, const vm_body *body, int n, const vm_body *others, vm_real sign,
                         const vm_impulse *external_or_NULL, vm_body *result, vm_impulse *reaction_or_NULL)
{
    vmi_axle_sum sum = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    vm_impulse reaction;
    vm_vec3 e, turning;
    vm_body b;
    int i, status, axle_status;
    if (!axle || !body || !result) return VM_BAD_ARGUMENT;
    axle_status = vmi_axle_direction(axle, &e);
    status = vmi_jump(body, n, others, sign, external_or_NULL, &b);
    if (status < 0 || axle_status) return vmi_first_error(status < 0 ? status : VM_OK, axle_status);
    turning = vm_scale(vm_dot(e, body->omega), e);
    sum.arm = vmi_axle_arm(axle->at, body, n, others, sign, b.mass);
    vmi_axle_add(&sum, 1, body, axle->at, turning);
    for (i = 0; i < n; i++) vmi_axle_add(&sum, sign, &others[i], axle->at, turning);
    if (external_or_NULL) {
        sum.linear = vm_add(sum.linear, external_or_NULL->linear);
        sum.angular = vm_add(sum.angular, vmi_impulse_moment(external_or_NULL, axle->at));
    }
    status = vmi_axle_turn(axle->at, e, turning, &sum, &b, &reaction);
    if (!vmi_body_is_finite(&b) || !vmi_impulse_is_finite(&reaction)) return VM_NOT_FINITE;
    *result = b;
    if (reaction_or_NULL) *reaction_or_NULL = reaction;
    return status;
}

/* Separation of n parts from a body on a fixed axle: *rest is the body that remains on the axle.
   `parts` must contain the motions that the parts have after the separation. The external impulse, if there is one,
   acts during the separation. *reaction_or_NULL is the impulse of the axle on the body: `linear` acts at the point
   axle->at, and `couple` is orthogonal to the axle. If the parts keep the motion that they had in the whole, the
   motion of the rest does not change. With n = 0 no part leaves, and only the impulse acts. If the whole did not
   turn about the axle before the separation, the axle catches the body at the instant of the separation. Let I be
   the inertia of the rest about the axle. The error of the angular velocity is at most 4 eps H/I. This holds if
   rounding of the inputs, positions included, changes I by much less than I. H is the sum of (J + m d^2) w + m d v
   over the whole, the parts and the rest, plus the absolute values of the impulse's couple and moment about
   axle->at. Here m, J and v are the mass, the trace of the inertia and the speed of a body, d is the distance of its
   mass centre from axle->at, and w is the largest angular velocity of all these bodies. If I is small, it is a small
   difference of large numbers, and many digits are lost. Returns VM_OK, an error status of vm_separate_all,
   VM_DOMAIN if axle->axis is 0, and VM_NULL_AXIS (> 0) if the rest has no inertia about the axle, but would need
   angular momentum about it. In the last case the rest turns as the whole did. The pointer `rest` may be equal to
   `whole`. */
VM_API int vm_separate_on_axle(const vm_axle *axle, const vm_body *whole, int n, const vm_body *parts,
                               const vm_impulse *external_or_NULL, vm_body *rest, vm_impulse *reaction_or_NULL)
{
    return vmi_axle_jump(axle, whole, n, parts, VMI_SEPARATE, external_or_NULL, rest, reaction_or_NULL);
}

/* Attachment of n bodies to a body on a fixed axle (plastic impact): *whole is the body that all of them form together;
   the axle guides it. `body` and `added` must contain the motions just before the impact. The other arguments and the
   statuses are those of vm_separate_on_axle. */
VM_API int vm_attach_on_axle(const vm_axle *axle, const vm_body *body, int n, const vm_body *added,
                             const vm_impulse *external_or_NULL, vm_body *whole, vm_impulse *reaction_or_NULL)
{
    return vmi_axle_jump(axle, body, n, added, VMI_ATTACH, external_or_NULL, whole, reaction_or_NULL);
}

#endif
