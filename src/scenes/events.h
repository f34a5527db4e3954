/* scenes/events.h - when an event happens, and what it does

   An event is made in two steps: vm_event_... says when it happens, and vm_then_... says what happens then. An event
   takes only one vm_then_... function. An event without such a function is only counted: event.count says how often
   it has happened and event.time when it last happened, and the motion is the same as without the event.

       vm_event events[] = {vm_then_switch(vm_event_at(60), 3, 1),              // at 60 s effect 3 goes off
                            vm_then_stop(vm_event_position(0, 0, 0.5, 1))};     // the run ends where x rises to 0.5 m
       ode_event located[2];                                                    // one for each event
       vm_scene scene;
       memset(&scene, 0, sizeof scene);                                         // its bodies and effects: see scene.h
       scene.events = events;
       scene.located = located;
       scene.n_events = 2;

   An event at a time happens once. A crossing of a value happens at most event.most times, or without limit if
   event.most is 0; direction > 0 counts rising values, direction < 0 falling values, and direction = 0 both. Only
   motion causes a crossing: there is none if an event moves a coordinate beyond the value, or while the body is not
   present. Events at one instant happen in the order of the list; if the times of a jump and of a crossing differ
   only by rounding errors, either of the two may happen first. To get the times (or states) of all events of one run,
   set scene.located[i].times (or .states) and .room after the start.

   Tests: tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_EVENTS_H
#define VARMASS_SCENES_EVENTS_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "evaluate.h"
#include "scene.h"

/* An event that watches a coordinate of a body */
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

/* An event at a time in s, which happens once. If the time is before the start of the run, the event happens as the run
   begins. */
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

/* An event when a position crosses a value. The position is a coordinate of a body, and value is in m or rad. */
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

/* An event when a velocity crosses a value. The velocity is that of a coordinate of a body, and value is in m/s or
   rad/s. */
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

/* An event when a mass crosses a value. value in kg (on an axle kg m^2) should be positive, since a run ends before a
   mass reaches 0. */
VM_API vm_event vm_event_mass(int body, vm_real value, int direction)
{
    vm_event e = vmi_event(body, 0, value, direction);
    e.when = vmi_when_mass;
    return e;
}

VM_API vm_real vmi_when_user(const vm_event *e, vm_real t, const vm_real *y) { return e->user_when(t, y, e->ctx); }

/* An event when a function of the caller crosses zero. when(t, y, ctx) receives the state of the whole scene.
   vm_scene_start returns VM_BAD_ARGUMENT if when is NULL. */
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

/* The event ends the run. vm_scene_run then returns VM_STOPPED. */
VM_API vm_event vm_then_stop(vm_event event)
{
    event.then = vmi_then_stop;
    return event;
}

/* Stores the masses of all bodies, which vmi_scene_hold_masses restores after a change */
VM_API void vmi_scene_note_masses(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) s->bodies[i].noted_mass = s->bodies[i].load.mass;
}

/* Gives all bodies the masses that vmi_scene_note_masses has stored. Otherwise a jump, or the switching of a mass
   law, would change a mass although no stream carries mass and momentum. The loads are evaluated twice: first to find
   by how much the masses of the laws differ from the stored ones, then again with the corrected masses. A body with a
   mass law uses the field `law_offset`, any other body the field `mass`. Both fields are corrected, because the
   unused one has no effect. */
VM_API void vmi_scene_hold_masses(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        const vm_real lacking = b->noted_mass - b->load.mass;
        if (b->away || b->mass_is_state) continue;
        b->mass += lacking;
        b->law_offset += lacking;
    }
    vmi_scene_evaluate(s, t, y);
}

VM_API int vmi_then_switch(vm_event *e, vm_real t, vm_real *y)
{
    vm_scene *s = e->scene;
    vm_effect *effect = s->effects + e->effect;
    vmi_scene_evaluate(s, t, y);
    vmi_scene_note_masses(s);
    effect->idle &= VMI_IDLE_BODY_AWAY;
    if (e->off) effect->idle |= VMI_IDLE_SWITCHED_OFF;
    vmi_scene_hold_masses(s, t, y);
    return VM_OK;
}

/* The event switches an effect off (off = 1) or on (off = 0). effect is the index of the effect. Switching a mass law
   does not change the mass at this instant: the law continues from the present mass. vm_scene_start returns
   VM_NO_SUCH_EFFECT if no effect has this index. */
VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    event.then = vmi_then_switch;
    event.effect = effect;
    event.off = off != 0;
    event.switches = 1;
    return event;
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

/* The event calls a function of the caller. then(t, y, ctx) may change y and returns a status: VM_OK to continue, or
   VM_STOPPED or a negative number, with which the run ends. vm_scene_start returns VM_BAD_ARGUMENT if then is NULL. */
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = vmi_then_user;
    if (!then) event.status = VM_BAD_ARGUMENT;
    event.user_then = then;
    event.then_ctx = ctx;
    return event;
}

#endif
