/* scenes/events.h - events of a scene and what they do */
#ifndef VARMASS_SCENES_EVENTS_H
#define VARMASS_SCENES_EVENTS_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "evaluate.h"
#include "scene.h"

VM_API vm_event vmi_event(int body, int coordinate, vm_real value, int direction)
{
    vm_event e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.value = value;
    e.direction = direction;
    e.watches = 1;
    return e;
}

/* Events: one at a time happens once, a crossing (direction > 0 rising, < 0 falling, 0 both) as often as it may, or
   event.most times. A crossing is what motion does: what jumps over the value does not cross it. At one instant
   events happen in their order; where a jump comes within rounding of a crossing, either may come first. Nothing of a
   body that is not there crosses anything. If no vm_then_... says what happens, an event is only counted:
   event.count says how often it was, event.time when it was last, and the motion is what it would be without the
   event. Set scene.located[i].times (or states) and room after the start to get the times (or states) of all events
   of one run. */
VM_API vm_event vm_event_at(vm_real time)
{
    vm_event e = vmi_event(0, 0, 0, 0);
    e.time = time;
    e.watches = 0;
    e.most = 1;
    return e;
}

VM_API vm_real vmi_when_position(const vm_event *e, vm_real t, const vm_real *y)
{
    (void)t;
    return y[e->scene->bodies[e->body].at + e->coordinate] - e->value;
}

/* passes value */
VM_API vm_event vm_event_position(int body, int coordinate, vm_real value, int direction)
{
    vm_event e = vmi_event(body, coordinate, value, direction);
    e.when = vmi_when_position;
    return e;
}

VM_API vm_real vmi_when_velocity(const vm_event *e, vm_real t, const vm_real *y)
{
    const vm_scene_body *b = e->scene->bodies + e->body;
    (void)t;
    return y[b->at + b->positions + e->coordinate] - e->value;
}

/* Documented with vm_event_at. */
VM_API vm_event vm_event_velocity(int body, int coordinate, vm_real value, int direction)
{
    vm_event e = vmi_event(body, coordinate, value, direction);
    e.when = vmi_when_velocity;
    return e;
}

VM_API vm_real vmi_when_mass(const vm_event *e, vm_real t, const vm_real *y)
{
    const vm_scene_body *b = e->scene->bodies + e->body;
    if (b->mass_is_state) return y[b->mass_at] - e->value;
    vmi_scene_evaluate(e->scene, t, y);
    return b->load.mass - e->value;
}

/* > 0: a mass of 0 cannot be accelerated */
VM_API vm_event vm_event_mass(int body, vm_real value, int direction)
{
    vm_event e = vmi_event(body, 0, value, direction);
    e.when = vmi_when_mass;
    return e;
}

VM_API vm_real vmi_when_user(const vm_event *e, vm_real t, const vm_real *y) { return e->user_when(t, y, e->ctx); }

/* Documented with vm_event_at. */
VM_API vm_event vm_event_user(vm_real (*when)(vm_real t, const vm_real *y, void *ctx), void *ctx, int direction)
{
    vm_event e = vmi_event(0, 0, 0, direction);
    e.watches = 0;
    e.when = when ? vmi_when_user : NULL;
    e.user_when = when;
    e.ctx = ctx;
    if (!when) e.status = VM_BAD_ARGUMENT;
    return e;
}

VM_API int vmi_then_stop(vm_event *e, vm_real t, vm_real *y)
{
    (void)e;
    (void)t;
    (void)y;
    return VM_STOPPED;
}

/* ... and what happens then, one thing an event: vm_then_switch(vm_event_at(60), tap, 1). The run ends with
   VM_STOPPED; an effect goes off (1) or on (0); a part leaves body and becomes into, which was absent; added becomes
   a part of body and is no longer there; then is called, may change y, and returns a status (VM_STOPPED, < 0 end the
   run).
   A part is described as the instant after, in inertial axes; where relative is set, in the body's axes, r from its
   mass centre, q, v and omega relative to the body as it moves there. In the plane and on an axle into takes the
   body's angle, plus the angle with which it was made. event.external is an impulse from outside during the jump.
   A jump is between bodies of one motion, or between a body in the plane or free and a point. The run ends with
   VM_IS_THERE if `into` is there already, with VM_IS_AWAY if `body` or `added` is not there; the other errors are
   those of vm_separate.
   A point that takes up a body elsewhere than where it is loses the spin of the two: angular_defect has it. */
VM_API vm_event vm_then_stop(vm_event event)
{
    event.then = vmi_then_stop;
    return event;
}

/* Events switch effects on and off, also mass laws. A mass must not jump at that moment, since nothing would carry
   off the mass and its momentum. So the masses are noted before the event and restored after it: a law then goes on
   from the mass that is there. */
VM_API void vmi_scene_note_masses(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) s->bodies[i].held = s->bodies[i].load.mass;
}

VM_API void vmi_scene_hold_masses(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        const vm_real more = b->held - b->load.mass;
        if (b->away || b->mass_is_state) continue;
        b->mass += more;
        b->jumped += more; /* a body uses only one of them: `jumped` if it has a mass law */
    }
    vmi_scene_evaluate(s, t, y);
}

VM_API int vmi_then_switch(vm_event *e, vm_real t, vm_real *y)
{
    vm_scene *s = e->scene;
    vm_effect *effect = s->effects + e->effect;
    vmi_scene_evaluate(s, t, y);
    vmi_scene_note_masses(s);
    effect->idle = (effect->idle & 2) | e->off;
    vmi_scene_hold_masses(s, t, y);
    return VM_OK;
}

/* Documented with vm_then_stop. */
VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    event.then = vmi_then_switch;
    event.effect = effect;
    event.off = off != 0;
    event.switches = 1;
    return event;
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = vmi_then_user;
    if (!then) event.status = VM_BAD_ARGUMENT;
    event.user_then = then;
    event.then_ctx = ctx;
    return event;
}

#endif
