/* scenes/jumps.h - separation and attachment as events of a scene

   An event can separate a part from a body, or attach one body to another, by the laws of mechanics/jumps.h. A part
   that separates becomes another body of the scene, which must be absent before the event. A body that is attached is
   absent after the event.

       vm_scene_body bodies[] = {vm_scene_body_line(5, 0, 10), vm_scene_body_absent(vm_scene_body_line(1, 0, 0))};
       vm_body part;
       memset(&part, 0, sizeof part);
       part.mass = 1;   // kg
       part.v.x = 2;    // m/s faster than the body
       vm_event drop = vm_then_separate_on_line(vm_event_at(3), 0, 1, &part, 1);

   The caller gives the motion that a part has just after the jump. If the argument `relative` is 0, this motion is
   given in inertial axes. If `relative` is 1, it is given in the axes of the body: r leads from the mass centre of the
   body to the part, and q, v and omega are relative to the motion of the body at this point, just before the jump. In
   the plane and on an axle the new body has the angle of the body from which it separates, plus the angle that its
   constructor received. The field `external` of the event is an impulse that acts from outside during the jump. On a
   line only its component along x acts, on an axle only its moment about the z axis, and in the plane only what lies in
   the plane; the guides of these bodies take up the rest.

   Two bodies can take part in the same jump if they have the same kind of motion. A body in the plane or a free body
   can also take up or give off a point. The functions whose names end in _on_line (for a line or an axle) and in
   _in_plane do the same as vm_then_separate and vm_then_attach, but only for these kinds of motion. A program with
   these functions is smaller (docs/scene-sizes.md). If a point takes up a body at another place, the angular momentum
   of both bodies about their common mass centre is lost, since a point does not rotate. If the scene keeps a budget
   (vm_budget in scene.h), its field angular_defect shows this loss.

   A run ends with VM_IS_THERE if a part would become a body that is present already, with VM_IS_AWAY if a body that
   jumps is not present, and with the errors that vm_separate and vm_attach return. vm_scene_start returns
   VM_BAD_MOTION if the two bodies cannot take part in the same jump, VM_SAME_BODY if both are the same body, and the
   status of vm_scene_check if a part cannot be a body.

   Tests: tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_JUMPS_H
#define VARMASS_SCENES_JUMPS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/bodies.h"
#include "../mechanics/jumps.h"
#include "../mechanics/jumps2.h"
#include "../mechanics/vectors.h"
#include "check.h"
#include "events.h"
#include "growing.h"
#include "motions.h"
#include "scene.h"
#include "state.h"

/* The part of the external impulse that acts on the body of a jump. The rest is taken up by what guides the body. */
VM_API vm_impulse vmi_event_impulse(const vm_event *e)
{
    const int motion = e->scene->bodies[e->jump_body].motion;
    const vm_vec3 zero = vmi_vec3(0, 0, 0);
    const vm_impulse j = e->external;
    vm_impulse acts = j;
    if (motion == VM_POINT || motion == VM_FREE) return acts;
    acts.linear.z = acts.at.z = acts.couple.x = acts.couple.y = 0;
    if (motion == VM_PLANE) return acts;
    acts.at = acts.linear = acts.couple = zero;
    if (motion == VM_LINE) acts.linear.x = j.linear.x;
    else acts.couple.z = vmi_impulse_moment(&j, zero).z;
    return acts;
}

/* Computes the jump on a line and on an axle. Let `sign` be -1 for a part that separates and 1 for a body that is
   attached. The velocity of the body becomes v1 = v + (sign m (v2 - v) + impulse)/(M + sign m) (24), and its mass
   centre moves by the fraction sign m/(M + sign m) of the way to the mass centre of the part (15). M and v are mass and
   velocity of the body, m and v2 those of the part or of the attached body; on an axle M and m are moments of inertia.
   Line and axle use the same formulas, because the numbers that a line or an axle does not need are 0. */
VM_API int vmi_event_jump_on_line(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const vm_impulse external = vmi_event_impulse(e);
    const vm_real m = e->jump_kind == VMI_JUMP_SEPARATES ? -other->mass : other->mass, mass = body->mass + m;
    if (e->relative) {
        other->r.x += body->r.x;
        other->v.x += body->v.x;
        other->omega.z += body->omega.z;
    }
    *b = *body;
    if (!(mass > 0)) return VM_BAD_MASS;
    b->mass = mass;
    b->v.x = body->v.x + (m * (other->v.x - body->v.x) + external.linear.x) / mass;
    b->omega.z = body->omega.z + (m * (other->omega.z - body->omega.z) + external.couple.z) / mass;
    b->r.x = body->r.x + m / mass * (other->r.x - body->r.x);
    return VM_OK;
}

/* Converts the motion of *part. Before the call the motion is relative to *body, in the axes of *body; after the call
   it is absolute, in inertial axes */
VM_API void vmi_event_jump_place(const vm_body *body, vm_body *part)
{
    const vmi_mat3 turn = vmi_rotation(body->q);
    const vm_vec3 d = vmi_times(&turn, part->r);
    part->r = vm_add(body->r, d);
    part->v = vm_add(vmi_times(&turn, part->v), vm_add(body->v, vm_cross(body->omega, d)));
    part->omega = vm_add(vmi_times(&turn, part->omega), body->omega);
    part->q = vmi_quat_is_none(part->q) ? body->q : vm_quat_times(body->q, part->q);
}

VM_API vm_impulse2 vmi_event_impulse2(const vm_impulse *external)
{
    vm_impulse2 j;
    j.jx = external->linear.x;
    j.jy = external->linear.y;
    j.couple = external->couple.z;
    j.x = external->at.x;
    j.y = external->at.y;
    return j;
}

/* Computes the jump in the plane. Returns VM_BAD_INERTIA if the remaining body has no inertia, because it is then a
   point and cannot be a body in the plane. */
VM_API int vmi_event_jump_in_plane(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const vm_impulse2 external = vmi_event_impulse2(&e->external);
    vm_body2 one, two, result;
    int status;
    if (e->relative) vmi_event_jump_place(body, other);
    one = vmi_body_to_plane(body, 0);
    two = vmi_body_to_plane(other, 0);
    if (e->jump_kind == VMI_JUMP_SEPARATES) status = vm_separate2(&one, &two, &external, &result);
    else status = vm_attach2(&one, &two, &external, &result);
    if (status < 0) return status;
    *b = *body;
    b->mass = result.mass;
    b->inertia.zz = result.inertia;
    b->r.x = result.x;
    b->r.y = result.y;
    b->v.x = result.vx;
    b->v.y = result.vy;
    b->omega.z = result.omega;
    return result.inertia > 0 ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_event_jump_any(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const int motion = e->scene->bodies[e->jump_body].motion;
    if (motion == VM_LINE || motion == VM_AXLE) return vmi_event_jump_on_line(e, body, other, b);
    if (motion == VM_PLANE) return vmi_event_jump_in_plane(e, body, other, b);
    if (e->relative) vmi_event_jump_place(body, other);
    if (e->jump_kind == VMI_JUMP_SEPARATES) return vm_separate(body, other, &e->external, b);
    return vm_attach(body, other, &e->external, b);
}

/* The angle of a body in the plane or on an axle, complete turns included. For a body with another kind of motion the
   result has no meaning, and the function `put` of the body does not use it. */
VM_API vm_real vmi_scene_angle(const vm_scene *s, int body, const vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    return b->motion == VM_PLANE ? y[b->at + VMI_PLANE_ANGLE] : y[b->at];
}

/* Updates the position of the mass centre in body axes, after a jump has moved the mass centre of a body to r. For a
   growing body this position is a part of the state. For any other body, the field `centre` is the vector by which
   jumps have moved the mass centre. */
VM_API void vmi_scene_shift_centre(const vm_scene *s, int body, vm_vec3 r, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    vm_real *state = y + b->at;
    vm_vec3 step;
    if (b->shift) b->shift(b, vm_sub(r, vmi_scene_moving(b, state)), state);
    if (!b->grows) return;
    step = vmi_times_transposed(&b->axes, vm_sub(r, vmi_scene_moving(b, state)));
    vmi_growth_put_centre(b, vm_add(vmi_growth_centre(b, state), step), state);
}

/* Lets each effect that holds bodies together (that is, joints) act even if its first body is not present. The effect
   itself leaves out the joints of bodies that are not present */
VM_API void vmi_scene_wake(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_effects; i++)
        if (s->effects[i].settle) s->effects[i].idle &= VMI_IDLE_SWITCHED_OFF;
}

/* Writes the bodies after a jump into the state: the body that lost or gained mass, and the part that separated.
   part_or_NULL is NULL if the body `other` was attached. Stores the masses that all bodies must have after the jump,
   because the mass that a law gives does not include the mass that a jump adds or takes away. */
VM_API void vmi_scene_put_jump(vm_event *e, vm_real *y, const vm_body *result, const vm_body *part_or_NULL)
{
    vm_scene *s = e->scene;
    vm_scene_body *body = s->bodies + e->jump_body, *other = s->bodies + e->other;
    const vm_real angle = vmi_scene_angle(s, e->jump_body, y);
    vmi_scene_note_masses(s);
    body->noted_mass = result->mass;
    other->away = part_or_NULL == NULL;
    vmi_scene_shift_centre(s, e->jump_body, result->r, y);
    if (part_or_NULL) {
        other->noted_mass = part_or_NULL->mass;
        other->centre = vmi_vec3(0, 0, 0);
        if (other->grows) vmi_growth_put_centre(other, vmi_vec3(0, 0, 0), y + other->at);
        vmi_scene_put(s, e->other, part_or_NULL, angle + other->angle, y);
    }
    vmi_scene_put(s, e->jump_body, result, angle, y);
    vmi_scene_presence(s);
    vmi_scene_wake(s);
}

/* Lets effects that hold bodies together (that is, joints) give their impulses after a jump. The loads must have been
   computed before. Returns VM_OK, or the first error of these effects. */
VM_API int vmi_scene_settle(vm_scene *s, vm_real *y)
{
    int i, status = VM_OK;
    for (i = 0; i < s->n_effects; i++) {
        const vm_effect *e = s->effects + i;
        if (e->settle && !e->idle) status = vmi_first_error(status, e->settle(e, y, s));
    }
    return status;
}

/* Adjusts the masses after the bodies have been written into the state. Adds to the budget the energy that the jump
   adds to the bodies, and the impulse from outside. Returns VM_OK, the status of an effect that cannot hold the bodies
   together, or the status of a mass law that fails. If a mass law fails, the next run calls this function again. */
VM_API int vmi_scene_finish_jump(vm_event *e, vm_real t, vm_real *y)
{
    vm_scene *s = e->scene;
    vm_budget *budget = s->budget;
    vm_budget after;
    vm_impulse external;
    int status = vmi_event_hold_masses(e, t, y);
    if (status) return status;
    status = vmi_scene_settle(s, y);
    if (!budget) return status;
    budget->totals(s, y, &after);
    budget->jump_energy += after.energy - e->energy;
    external = vmi_event_impulse(e);
    budget->impulse = vm_add(budget->impulse, external.linear);
    budget->angular_impulse = vm_add(budget->angular_impulse, vmi_impulse_moment(&external, vmi_vec3(0, 0, 0)));
    return status;
}

/* Writes the bodies after a jump into the state and finishes the jump */
VM_API int vmi_scene_jump(vm_event *e, vm_real t, vm_real *y, const vm_body *result, const vm_body *part_or_NULL)
{
    vm_scene *s = e->scene;
    vm_budget before;
    if (s->budget) {
        s->budget->totals(s, y, &before);
        e->energy = before.energy;
    }
    vmi_scene_put_jump(e, y, result, part_or_NULL);
    return vmi_scene_finish_jump(e, t, y);
}

VM_API int vmi_then_separate(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, part = e->part, rest;
    int status;
    if (e->left == VMI_LEFT_MASSES) return vmi_scene_finish_jump(e, t, y);
    if (e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    if (!e->scene->bodies[e->other].away) return VM_IS_THERE;
    status = vmi_event_weigh(e, t, y);
    if (status) return status;
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    status = e->jump(e, &body, &part, &rest);
    if (status < 0) return status;
    return vmi_scene_jump(e, t, y, &rest, &part);
}

/* The event separates a part from a body on a line or on an axle. The part has the motion *part and becomes the body
   with the index `into`, which was absent. If relative is 1, this motion is given relative to the body. vm_scene_start
   returns VM_BAD_ARGUMENT if part is NULL. */
VM_API vm_event vm_then_separate_on_line(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event.then = vmi_then_separate;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_kind = VMI_JUMP_SEPARATES;
    event.jump_body = body;
    event.other = into;
    event.relative = relative;
    if (part) event.part = *part;
    else event.status = VM_BAD_ARGUMENT;
    return event;
}

/* The event separates a part from a body in the plane. The part has the motion *part and becomes the body with the
   index `into`, which was absent. If relative is 1, this motion is given relative to the body. vm_scene_start returns
   VM_BAD_ARGUMENT if part is NULL. */
VM_API vm_event vm_then_separate_in_plane(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event = vm_then_separate_on_line(event, body, into, part, relative);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* The event separates a part from a body, which may have any kind of motion. The part has the motion *part and becomes
   the body with the index `into`, which was absent. If relative is 1, this motion is given relative to the body.
   vm_scene_start returns VM_BAD_ARGUMENT if part is NULL. */
VM_API vm_event vm_then_separate(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event = vm_then_separate_on_line(event, body, into, part, relative);
    event.jump = vmi_event_jump_any;
    event.motions = VMI_ALL_MOTIONS;
    return event;
}

VM_API int vmi_then_attach(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, added, whole;
    int status;
    if (e->left == VMI_LEFT_MASSES) return vmi_scene_finish_jump(e, t, y);
    if (e->scene->bodies[e->other].away || e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    status = vmi_event_weigh(e, t, y);
    if (status) return status;
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    vmi_scene_body_now(e->scene, e->other, y, &added);
    status = e->jump(e, &body, &added, &whole);
    if (status < 0) return status;
    return vmi_scene_jump(e, t, y, &whole, NULL);
}

/* The event attaches a body to another body on the same line or axle. The body `added` becomes a part of `body` and is
   no longer present. */
VM_API vm_event vm_then_attach_on_line(vm_event event, int body, int added)
{
    event.then = vmi_then_attach;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_kind = VMI_JUMP_ATTACHES;
    event.jump_body = body;
    event.other = added;
    event.relative = 0;
    return event;
}

/* The event attaches a body to another body in the plane. The body `added` becomes a part of `body` and is no longer
   present. */
VM_API vm_event vm_then_attach_in_plane(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* The event attaches a body to another body; both may have any kind of motion. The body `added` becomes a part of
   `body` and is no longer present. vm_scene_start returns VM_BAD_MOTION if the kinds of motion of the two bodies do
   not allow that one is attached to the other. */
VM_API vm_event vm_then_attach(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_any;
    event.motions = VMI_ALL_MOTIONS;
    return event;
}

#endif
