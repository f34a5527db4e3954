/* scenes/events.h - when an event happens, and what it does

   An event is made in two steps: vm_event_... says when it happens, and vm_then_... says what it does. An event
   without a vm_then_... function only observes the motion and does not change it: event.count says how often the event
   has happened, and event.time when it last happened. An event can have only one vm_then_... function; with
   vm_then_all the event carries out a list of actions.

       vm_event empty = vm_event_mass(0, 70, -1);                             // the mass of body 0 falls to 70 kg
       vm_event staging[] = {vm_then_switch_range(empty, 0, 4, 1),            // effects 0 to 3 are switched off
                             vm_then_switch(empty, 4, 0)};                    // effect 4 is switched on
       vm_event events[] = {vm_then_all(empty, staging, 2),
                            vm_then_stop(vm_event_position(0, 0, 0.5, 1)),    // the run ends where x rises to 0.5 m
                            vm_event_velocity(0, 0, 0, -1)};                  // events[2].time: time of the greatest x
       ode_event located[3];                                                  // one for each of `events`
       vm_scene scene;
       memset(&scene, 0, sizeof scene);                                       // its bodies and effects: see scene.h
       scene.events = events;
       scene.located = located;
       scene.n_events = 3;

   The functions vm_event_... and vm_then_... do not fail. Instead vm_scene_start refuses an event with a wrong
   argument: it returns VM_NOT_FINITE if a time or value is infinite or NaN, VM_NO_SUCH_BODY if a body does not exist,
   and so on. The vm_scene_fault of vm_scene_start says which event is wrong.

   An event at a set time happens once. An event at which a quantity crosses a value happens at most event.most times,
   or without limit if event.most is 0. If direction > 0, this event happens where the quantity rises through the
   value; if direction < 0, where the quantity falls through it; if direction = 0, in both cases. Only motion causes a
   crossing: there is no crossing if another event moves a coordinate beyond the value, or while the body is not
   present. Events at the same instant happen in the order of the list. If the times of a jump and of a crossing differ
   only by rounding errors, the jump may happen before or after the crossing. To get the times (or states) of all
   crossings of one run, set scene.located[i].times (or .states) and .room after the start.

   Tests: tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_EVENTS_H
#define VARMASS_SCENES_EVENTS_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "check.h"
#include "evaluate.h"
#include "scene.h"

VM_API int vmi_event_check_coordinate(const vm_scene *s, const vm_event *e)
{
    return vmi_scene_check_coordinate(s, e->body, e->coordinate);
}

/* An event that happens when a quantity of a coordinate, such as the velocity, crosses a value. The caller must set
   e.when, the function that returns the quantity minus the value */
VM_API vm_event vmi_event(int body, int coordinate, vm_real value, int direction)
{
    vm_event e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.value = value;
    e.direction = direction;
    e.check_when = vmi_event_check_coordinate;
    return e;
}

/* An event at a set time, which is in s. It happens once. If the time is before the start of the run, the event
   happens when the run begins. */
VM_API vm_event vm_event_at(vm_real time)
{
    vm_event e = vmi_event(0, 0, 0, 0);
    e.time = time;
    e.check_when = NULL;
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

/* An event when a velocity crosses a value. The velocity is the rate of a coordinate of a body, and value is in m/s or
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

/* An event when the mass of a body crosses `value`, in kg. For a body on an axle the moment of inertia takes the place
   of the mass, and `value` is in kg m^2. `value` should be positive, since a run ends before a mass reaches 0. */
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
    e.check_when = NULL;
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

/* Stores the present masses of all bodies. vmi_event_hold_masses restores them after a jump or a switching. */
VM_API void vmi_scene_note_masses(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) s->bodies[i].noted_mass = s->bodies[i].load.mass;
}

/* Computes the loads, and with them the masses, before the action of an event changes anything. If a mass law fails,
   returns the status of the law; the next run then carries out the whole action. */
VM_API int vmi_event_weigh(vm_event *e, vm_real t, const vm_real *y)
{
    const int status = vmi_scene_weigh(e->scene, t, y);
    e->left = VMI_LEFT_NOTHING;
    if (status) e->left = VMI_LEFT_ALL;
    return status;
}

/* Gives all bodies the masses that vmi_scene_note_masses has stored. Without this function a jump, or the switching of
   a mass law, would change a mass although no stream brings or removes mass and momentum. The loads are evaluated
   twice: first to find by how much the present masses differ from the stored masses, then again with the corrected
   masses. A body with a mass law uses the field `law_offset`, any other body the field `mass`. Both fields of a body
   are corrected, because the field that it does not use has no effect. If a mass law fails, returns the status of the
   law, and the next run calls this function again. */
VM_API int vmi_event_hold_masses(vm_event *e, vm_real t, const vm_real *y)
{
    vm_scene *s = e->scene;
    int i, status;
    e->left = VMI_LEFT_MASSES;
    status = vmi_scene_weigh(s, t, y);
    if (status) return status;
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        const vm_real lacking = b->noted_mass - b->load.mass;
        if (b->away || b->mass_is_state) continue;
        b->mass += lacking;
        b->law_offset += lacking;
    }
    status = vmi_scene_weigh(s, t, y);
    if (!status) e->left = VMI_LEFT_NOTHING;
    return status;
}

VM_API int vmi_then_switch(vm_event *e, vm_real t, vm_real *y)
{
    vm_scene *s = e->scene;
    int i, status;
    if (e->left == VMI_LEFT_MASSES) return vmi_event_hold_masses(e, t, y);
    status = vmi_event_weigh(e, t, y);
    if (status) return status;
    vmi_scene_note_masses(s);
    for (i = 0; i < e->n_effects; i++) {
        vm_effect *effect = s->effects + e->effect + i;
        effect->idle &= VMI_IDLE_BODY_AWAY;
        if (e->off) effect->idle |= VMI_IDLE_SWITCHED_OFF;
    }
    return vmi_event_hold_masses(e, t, y);
}

VM_API int vmi_event_check_switch(const vm_scene *s, const vm_event *e)
{
    if (e->effect < 0 || e->n_effects > s->n_effects - e->effect) return VM_NO_SUCH_EFFECT;
    return VM_OK;
}

/* The event switches n effects that follow each other in the list off (off = 1) or on (off = 0). first is the index of
   the first of these effects. Switching a mass law does not change the mass at this instant: the law continues from
   the present mass. vm_scene_start returns VM_NO_SUCH_EFFECT if one of the effects does not exist, and VM_BAD_ARGUMENT
   if n is negative. */
VM_API vm_event vm_then_switch_range(vm_event event, int first, int n, int off)
{
    event.then = vmi_then_switch;
    event.check = vmi_event_check_switch;
    event.effect = first;
    event.n_effects = n;
    event.off = off != 0;
    if (n < 0) event.status = VM_BAD_ARGUMENT;
    return event;
}

/* The event switches an effect off (off = 1) or on (off = 0). effect is the index of the effect. Switching a mass law
   does not change the mass at this instant: the law continues from the present mass. vm_scene_start returns
   VM_NO_SUCH_EFFECT if no effect has this index. */
VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    return vm_then_switch_range(event, effect, 1, off);
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

/* The event calls a function of the caller. then(t, y, ctx) may change y and returns a status. After VM_OK the run
   continues; after VM_STOPPED or a negative number it ends with this status. vm_scene_start returns VM_BAD_ARGUMENT if
   then is NULL. */
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = vmi_then_user;
    if (!then) event.status = VM_BAD_ARGUMENT;
    event.user_then = then;
    event.then_ctx = ctx;
    return event;
}

/* Carries out the actions of an event in the order of their list. Returns the first status other than VM_OK that an
   action gives, or VM_OK if all give VM_OK. After an error (a negative status) no further action is carried out; the
   error is returned even if an earlier action has stopped the run. If a mass law has failed during an action, the next
   run carries out what is left of this action, and then the actions after it. */
VM_API int vmi_then_all(vm_event *e, vm_real t, vm_real *y)
{
    int i = e->next_action, status = e->so_far;
    e->left = VMI_LEFT_NOTHING;
    e->next_action = 0;
    e->so_far = VM_OK;
    for (; i < e->n_actions && status >= 0; i++) {
        vm_event *action = e->actions + i;
        int result = VM_OK;
        action->scene = e->scene;
        if (action->then) result = action->then(action, t, y);
        if (action->left) {
            e->left = VMI_LEFT_ALL;
            e->next_action = i;
            e->so_far = status;
            return result;
        }
        if (result < 0 || status == VM_OK) status = result;
    }
    return status;
}

/* Checks the actions of an event. A list of actions cannot contain another list. */
VM_API int vmi_event_check_all(const vm_scene *s, const vm_event *e)
{
    int i, status = VM_OK;
    for (i = 0; i < e->n_actions && !status; i++) {
        status = VM_BAD_ARGUMENT;
        if (!e->actions[i].actions) status = vmi_scene_check_event(s, e->actions + i);
    }
    return status;
}

/* The event carries out a list of actions, one after the other, at the same instant. actions is an array of n events
   made by vm_then_... functions. The times or conditions of these events are not used. Therefore all of them can be
   made from the same event, as in the example at the top of this file. The array is not copied and must stay at its
   place in memory. If an action stops the run, the actions after it are still carried out. vm_scene_start returns
   VM_BAD_ARGUMENT if actions is NULL, n is negative or an action is a list itself, and else the status of the first
   action that is wrong. */
VM_API vm_event vm_then_all(vm_event event, vm_event *actions, int n)
{
    event.then = vmi_then_all;
    event.check = vmi_event_check_all;
    event.actions = actions;
    event.n_actions = n;
    if (!actions || n < 0) event.status = VM_BAD_ARGUMENT;
    return event;
}

#endif
