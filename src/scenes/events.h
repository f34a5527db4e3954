/* scenes/events.h - when an event happens, and what it does

   An event is made in two steps: vm_event_... says when it happens, vm_then_... says what happens then, one thing for
   an event. An event without vm_then_... is only counted: event.count says how often it has happened, event.time when
   it last did, and the motion is what it would be without the event.

       vm_event events[] = {vm_then_switch(vm_event_at(60), 3, 1),              // at 60 s effect 3 goes off
                            vm_then_stop(vm_event_position(0, 0, 0.5, 1))};     // the run ends where x rises to 0.5 m
       ode_event located[2];                                                    // as many
       vm_scene scene;
       memset(&scene, 0, sizeof scene);                                         // its bodies and effects: see scene.h
       scene.events = events;
       scene.located = located;
       scene.n_events = 2;

   An event at a time happens once. A crossing happens as often as it may, or event.most times: direction > 0 counts
   rising values, < 0 falling ones, 0 both. Only motion crosses a value; an event that sets a coordinate beyond it does
   not. Bodies that are not present cross nothing. Events at one instant happen in the order of the list; where a jump
   and a crossing are within rounding of each other, either may be the first. To get the times (or states) of all events
   of one run, set scene.located[i].times (or .states) and .room after the start.

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

/* An event at a time (s), which happens once. A time before the start of the run is due as the run begins. */
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

/* An event when a position crosses a value. The position is a coordinate of a body, value is in m or rad. */
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

/* An event when a velocity crosses a value. The velocity is that of a coordinate of a body, value is in m/s or
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

/* An event when a function of the caller's crosses zero. when(t, y, ctx) gets the state of the whole scene.
   VM_BAD_ARGUMENT at the start where when is NULL. */
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

/* The event ends the run, which returns VM_STOPPED. */
VM_API vm_event vm_then_stop(vm_event event)
{
    event.then = vmi_then_stop;
    return event;
}

/* Notes the masses of all bodies, for vmi_scene_hold_masses after a change */
VM_API void vmi_scene_note_masses(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) s->bodies[i].noted_mass = s->bodies[i].load.mass;
}

/* Gives all bodies the mass that was noted. Switching a mass law, and a jump, would otherwise change a mass without
   anything that carries off the mass and its momentum. The loads are evaluated twice: first to see which masses the
   laws give now, and what they lack; then anew, since the masses have changed and the loads depend on them.
   A body uses only one of `mass` and `law_offset`, the latter where it has a mass law, so that both may be changed. */
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

/* The event switches an effect off (off = 1) or on (0). effect is its index. Switching a mass law does not change the
   mass at this instant: the law goes on from the mass that is there. VM_NO_SUCH_EFFECT at the start. */
VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    event.then = vmi_then_switch;
    event.effect = effect;
    event.off = off != 0;
    event.switches = 1;
    return event;
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

/* The event calls a function of the caller's. then(t, y, ctx) may change y; it returns a status: VM_OK to go on,
   VM_STOPPED or a negative number to end the run with it. VM_BAD_ARGUMENT at the start where then is NULL. */
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = vmi_then_user;
    if (!then) event.status = VM_BAD_ARGUMENT;
    event.user_then = then;
    event.then_ctx = ctx;
    return event;
}

#endif
