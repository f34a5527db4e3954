/* scenes/start.h - how a scene starts */
#ifndef VARMASS_SCENES_START_H
#define VARMASS_SCENES_START_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/runs.h"
#include "check.h"
#include "evaluate.h"
#include "scene.h"
#include "state.h"

/* Whether bodies, effects and events are those of the last start, as far as can be seen: a book may be given up */
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

VM_API vm_real vmi_scene_when(vm_real t, const vm_real *y, void *ctx)
{
    const vm_event *e = (const vm_event *)ctx;
    return e->when ? e->when(e, t, y) : 1;
}

VM_API void vmi_scene_locate(vm_scene *s, int i)
{
    ode_event *located = s->located + i;
    memset(located, 0, sizeof *located);
    located->g = vmi_scene_when;
    located->ctx = s->events + i;
    located->direction = s->events[i].direction;
    /* what is only counted, and without end, need not end a step */
    located->action = s->events[i].then || s->events[i].most ? ODE_STOP : ODE_RECORD;
}

/* Where an effect finds what it needs, so that it need not look for it at each evaluation */
VM_API void vmi_scene_bind(vm_scene *s, vm_effect *e)
{
    vm_scene_body *b = s->bodies + e->body, *other = e->other >= 0 ? s->bodies + e->other : NULL;
    e->idle = e->off != 0;
    e->load = &b->load;
    e->other_load = NULL;
    e->x = b->at + e->coordinate;
    e->v = e->x + b->positions;
    e->other_x = e->x;
    e->other_v = e->v;
    if (!other) return; /* other_coordinate may be anything then */
    e->other_load = &other->load;
    e->other_x = other->at + e->other_coordinate;
    e->other_v = e->other_x + other->positions;
}

/* Checks the scene, and makes the state at the start: vm_scene_size numbers */
VM_API int vm_scene_start(vm_scene *scene, vm_real t, vm_real *y, vm_scene_fault *culprit)
{
    int i, k, at = 0, status = vm_scene_check(scene, culprit);
    if (status) return status;
    if (!y) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (scene->y_size && scene->y_size < vm_scene_size(scene)) return VM_SHORT_ARRAY;
    scene->size = vm_scene_size(scene);
    for (i = 0; i < scene->n_bodies; i++) {
        vm_scene_body *b = scene->bodies + i;
        b->at = at;
        b->mass_at = at + vmi_scene_mass_at(b);
        b->away = b->absent;
        b->jumped = 0;
        for (k = 0; k < vmi_scene_body_size(b); k++) y[at++] = 0;
        vmi_scene_put(scene, i, &b->start, b->angle, y);
    }
    for (i = 0; i < scene->n_effects; i++) vmi_scene_bind(scene, scene->effects + i);
    for (i = 0; i < scene->n_events; i++) {
        vm_event *e = scene->events + i;
        e->scene = scene;
        e->count = e->seen = 0;
        if (e->when) e->time = t;
        vmi_scene_locate(scene, i);
    }
    vmi_scene_presence(scene);
    vmi_scene_evaluate(scene, t, y);
    scene->status = VM_OK;
    if (scene->book) scene->book->open(scene, y, y + at);
    return VM_OK;
}

#endif
