/* scenes/start.h - the start of a scene

   vm_scene_start checks a scene, fills its state, and connects effects and events with the bodies on which they act.

       vm_real y[2]; // 2 = vm_scene_size(&scene)
       vm_scene_fault fault;
       int status = vm_scene_start(&scene, 0, y, &fault); // at t = 0

   Tests: tests/test_scene_runs.c. */
#ifndef VARMASS_SCENES_START_H
#define VARMASS_SCENES_START_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/options.h"
#include "check.h"
#include "evaluate.h"
#include "scene.h"
#include "state.h"

/* Returns 1 if vm_scene_start has started the scene, and if the lists of the scene show no change since then; else 0.
   The state may be shorter than at the start, since the caller may end the budget of a scene between two runs. */
VM_API int vmi_scene_is_started(const vm_scene *s)
{
    int i;
    if (!s->size || vm_scene_size(s) > s->size) return 0;
    for (i = 0; i < s->n_effects; i++)
        if (!s->effects[i].load || !s->effects[i].apply) return 0;
    for (i = 0; i < s->n_events; i++)
        if (s->events[i].scene != s) return 0;
    return 1;
}

/* The function whose zeros the integrator locates to find the time of an event. ctx points to a vm_event of the scene.
   For an event at a set time the function returns 1, so that it has no zeros. */
VM_API vm_real vmi_scene_when(vm_real t, const vm_real *y, void *ctx)
{
    const vm_event *e = (const vm_event *)ctx;
    if (e->when) return e->when(e, t, y);
    return 1;
}

/* Prepares s->located[i], the event by which the integrator locates the event s->events[i] of the scene. If
   s->events[i] has no action and no limit of its number, it is only counted: located->action is then ODE_RECORD, with
   which the event does not end a step. Else located->action is ODE_STOP. */
VM_API void vmi_scene_locate(vm_scene *s, int i)
{
    ode_event *located = s->located + i;
    memset(located, 0, sizeof *located);
    located->g = vmi_scene_when;
    located->ctx = s->events + i;
    located->direction = s->events[i].direction;
    located->action = ODE_STOP;
    if (!s->events[i].then && !s->events[i].most) located->action = ODE_RECORD;
}

/* Stores in an effect the indices of its coordinates in the state and the pointers to the loads of its bodies. If the
   effect acts against the ground, its field other_coordinate is not used. */
VM_API void vmi_scene_bind(vm_scene *s, vm_effect *e)
{
    vm_scene_body *b = s->bodies + e->body, *other = e->other >= 0 ? s->bodies + e->other : NULL;
    e->idle = 0;
    if (e->off) e->idle = VMI_IDLE_SWITCHED_OFF;
    e->load = &b->load;
    e->other_load = NULL;
    e->x = b->at + e->coordinate;
    e->v = e->x + b->positions;
    e->other_x = e->x;
    e->other_v = e->v;
    if (!other) return;
    e->other_load = &other->load;
    e->other_x = other->at + e->other_coordinate;
    e->other_v = e->other_x + other->positions;
}

/* Writes the motions of all bodies at the start into the state. Returns the index of the first number of the budget. */
VM_API int vmi_scene_place_bodies(vm_scene *s, vm_real *y)
{
    int i, k, at = 0;
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        b->at = at;
        b->mass_at = at + vmi_scene_mass_at(b);
        b->away = b->absent;
        b->law_offset = 0;
        b->centre.x = b->centre.y = b->centre.z = 0;
        for (k = 0; k < vmi_scene_body_size(b); k++) y[at++] = 0;
        vmi_scene_put(s, i, &b->start, b->angle, y);
    }
    return at;
}

VM_API void vmi_scene_reset_events(vm_scene *s, vm_real t)
{
    int i, k;
    for (i = 0; i < s->n_events; i++) {
        vm_event *e = s->events + i;
        e->scene = s;
        e->count = e->seen = 0;
        e->left = VMI_LEFT_NOTHING;
        e->next_action = 0;
        e->so_far = VM_OK;
        for (k = 0; e->actions && k < e->n_actions; k++) e->actions[k].left = VMI_LEFT_NOTHING;
        if (e->when) e->time = t;
        vmi_scene_locate(s, i);
    }
}

/* Starts a scene at time t: checks the scene and fills its state y, an array of vm_scene_size(scene) numbers. Returns
   VM_OK, or an error: the status of vm_scene_check, which writes to *fault_or_NULL which part of the scene is wrong;
   VM_BAD_ARGUMENT if y is NULL; VM_NOT_FINITE if t is not finite; VM_SHORT_ARRAY if scene.y_size is set and too small.
   After these errors y is unchanged. If the scene has none of these errors but a mass law fails at t, y is filled, but
   the scene is not started: the function returns the status of the law, or VM_NOT_FINITE. After the start the arrays
   of the scene must stay at their places in memory. */
VM_API int vm_scene_start(vm_scene *scene, vm_real t, vm_real *y, vm_scene_fault *fault_or_NULL)
{
    int i, end, status = vm_scene_check(scene, fault_or_NULL);
    if (status) return status;
    if (!y) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (scene->y_size && scene->y_size < vm_scene_size(scene)) return VM_SHORT_ARRAY;
    scene->size = vm_scene_size(scene);
    end = vmi_scene_place_bodies(scene, y);
    for (i = 0; i < scene->n_effects; i++) vmi_scene_bind(scene, scene->effects + i);
    vmi_scene_reset_events(scene, t);
    vmi_scene_presence(scene);
    scene->status = VM_OK;
    status = vmi_scene_weigh(scene, t, y);
    if (status) {
        scene->size = 0; /* not started */
        return status;
    }
    if (scene->budget) scene->budget->open(scene, y, y + end);
    return VM_OK;
}

#endif
