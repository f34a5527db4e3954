/* scenes/jumps.h - separation and attachment as events */
#ifndef VARMASS_SCENES_JUMPS_H
#define VARMASS_SCENES_JUMPS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/bodies.h"
#include "../mechanics/jumps.h"
#include "../mechanics/jumps2.h"
#include "../mechanics/vectors.h"
#include "check.h"
#include "evaluate.h"
#include "events.h"
#include "growing.h"
#include "motions.h"
#include "scene.h"
#include "state.h"

/* The angle of a body in the plane or on an axle, which may be more than a turn */
VM_API vm_real vmi_scene_angle(const vm_scene *s, int body, const vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    return b->motion == VM_PLANE ? y[b->at + 2] : y[b->at];
}

/* (M v + m v2 + impulse)/(M + m), m < 0 for a part that separates, and m/(M + m) of the way to its mass centre */
VM_API int vmi_event_jump_single(const vm_event *e, const vm_body *body, const vm_body *other, vm_body *b)
{
    const vm_real m = e->jumps > 0 ? -other->mass : other->mass, mass = body->mass + m;
    *b = *body;
    if (!(mass > 0)) return VM_BAD_MASS;
    b->mass = mass;
    b->v.x = (body->mass * body->v.x + m * other->v.x + e->external.linear.x) / mass;
    b->omega.z = (body->mass * body->omega.z + m * other->omega.z + e->external.couple.z) / mass;
    b->r.x = body->r.x + m / mass * (other->r.x - body->r.x);
    return VM_OK;
}

/* On a line and on an axle, whose own numbers the other's formulas leave alone: they are 0 */
VM_API int vmi_event_jump_on_line(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    if (e->relative) {
        other->r.x += body->r.x;
        other->v.x += body->v.x;
        other->omega.z += body->omega.z;
    }
    return vmi_event_jump_single(e, body, other, b);
}

/* Where a part is whose motion is relative to the body */
VM_API void vmi_event_jump_place(const vm_body *body, vm_body *part)
{
    const vmi_mat3 turn = vmi_rotation(body->q);
    const vm_vec3 d = vmi_times(&turn, part->r);
    part->r = vmi_add(body->r, d);
    part->v = vmi_add(vmi_times(&turn, part->v), vmi_add(body->v, vmi_cross(body->omega, d)));
    part->omega = vmi_add(vmi_times(&turn, part->omega), body->omega);
    part->q = vmi_quat_is_none(part->q) ? body->q : vmi_quat_times(body->q, part->q);
}

VM_API vm_body2 vmi_scene_to_plane(const vm_body *b)
{
    vm_body2 flat;
    flat.mass = b->mass;
    flat.inertia = b->inertia.zz;
    flat.x = b->r.x;
    flat.y = b->r.y;
    flat.angle = 0;
    flat.vx = b->v.x;
    flat.vy = b->v.y;
    flat.omega = b->omega.z;
    return flat;
}

VM_API int vmi_event_jump_in_plane(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const vm_impulse *external = &e->external;
    vm_body2 one, two, flat;
    vm_impulse2 blow;
    int status;
    if (e->relative) vmi_event_jump_place(body, other);
    one = vmi_scene_to_plane(body);
    two = vmi_scene_to_plane(other);
    blow.jx = external->linear.x;
    blow.jy = external->linear.y;
    blow.couple = external->couple.z;
    blow.x = external->at.x;
    blow.y = external->at.y;
    status = e->jumps > 0 ? vm_separate2(&one, &two, &blow, &flat) : vm_attach2(&one, &two, &blow, &flat);
    if (status < 0) return status;
    *b = *body;
    b->mass = flat.mass;
    b->inertia.zz = flat.inertia;
    b->r.x = flat.x;
    b->r.y = flat.y;
    b->v.x = flat.vx;
    b->v.y = flat.vy;
    b->omega.z = flat.omega;
    return flat.inertia > 0 ? VM_OK : VM_BAD_INERTIA; /* a rest that is a point cannot move on as a body */
}

VM_API int vmi_event_jump_any(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const int motion = e->scene->bodies[e->jump_body].motion;
    if (motion == VM_LINE || motion == VM_AXLE) return vmi_event_jump_on_line(e, body, other, b);
    if (motion == VM_PLANE) return vmi_event_jump_in_plane(e, body, other, b);
    if (e->relative) vmi_event_jump_place(body, other);
    return e->jumps > 0 ? vm_separate(body, other, &e->external, b) : vm_attach(body, other, &e->external, b);
}

/* The mass centre of a growing body, which a jump moves to r, moves in the body, too */
VM_API void vmi_scene_shift(const vm_scene *s, int body, vm_vec3 r, vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    vm_real *state = y + b->at;
    vm_vec3 step;
    if (!b->grows) return;
    step = vmi_times_transposed(&b->axes, vmi_sub(r, vmi_scene_moving(b, state)));
    vmi_growth_put_centre(b, vmi_add(vmi_growth_centre(b, state), step), state);
}

VM_API void vmi_scene_jumped(vm_event *e, vm_real t, vm_real *y, int into_is_new, const vm_body *b,
                             const vm_body *other)
{
    vm_scene *s = e->scene;
    vm_budget before, after;
    const vm_real angle = vmi_scene_angle(s, e->jump_body, y);
    if (s->book) s->book->totals(s, y, &before);
    vmi_scene_note_masses(s);
    s->bodies[e->jump_body].held = b->mass;
    if (into_is_new) s->bodies[e->other].held = other->mass;
    s->bodies[e->other].away = !into_is_new;
    vmi_scene_shift(s, e->jump_body, b->r, y);
    if (into_is_new && s->bodies[e->other].grows)
        vmi_growth_put_centre(s->bodies + e->other, vmi_vec3(0, 0, 0), y + s->bodies[e->other].at);
    if (into_is_new) vmi_scene_put(s, e->other, other, angle + s->bodies[e->other].angle, y);
    vmi_scene_put(s, e->jump_body, b, angle, y);
    vmi_scene_presence(s);
    vmi_scene_hold_masses(s, t, y);
    if (!s->book) return;
    s->book->totals(s, y, &after);
    s->book->jump_energy += after.energy - before.energy;
    s->book->impulse = vmi_add(s->book->impulse, e->external.linear);
    s->book->angular_impulse = vmi_add(s->book->angular_impulse,
                                       vmi_add(e->external.couple, vmi_cross(e->external.at, e->external.linear)));
}

VM_API int vmi_then_separate(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, part = e->part, rest;
    int status;
    if (e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    if (!e->scene->bodies[e->other].away) return VM_IS_THERE;
    vmi_scene_evaluate(e->scene, t, y);
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    status = e->jump(e, &body, &part, &rest);
    if (status < 0) return status;
    vmi_scene_jumped(e, t, y, 1, &rest, &part);
    return VM_OK;
}

/* The same, of bodies on a line or on an axle, or in the plane, which link no more than that (docs/scene-sizes.md) */
VM_API vm_event vm_then_separate_on_line(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event.then = vmi_then_separate;
    if (!part) event.status = VM_BAD_ARGUMENT;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_body = body;
    event.other = into;
    event.jumps = 1;
    event.relative = relative;
    if (part) event.part = *part;
    return event;
}

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_separate_in_plane(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event = vm_then_separate_on_line(event, body, into, part, relative);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* Documented with vm_then_stop. */
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
    if (e->scene->bodies[e->other].away || e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    vmi_scene_evaluate(e->scene, t, y);
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    vmi_scene_body_now(e->scene, e->other, y, &added);
    status = e->jump(e, &body, &added, &whole);
    if (status < 0) return status;
    vmi_scene_jumped(e, t, y, 0, &whole, NULL);
    return VM_OK;
}

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_attach_on_line(vm_event event, int body, int added)
{
    event.then = vmi_then_attach;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_body = body;
    event.other = added;
    event.jumps = -1;
    event.relative = 0;
    return event;
}

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_attach_in_plane(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* Documented with vm_then_stop. */
VM_API vm_event vm_then_attach(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_any;
    event.motions = VMI_ALL_MOTIONS;
    return event;
}

#endif
