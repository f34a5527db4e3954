/* scenes/state.h - the state of a scene */
#ifndef VARMASS_SCENES_STATE_H
#define VARMASS_SCENES_STATE_H

#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/runs.h"
#include "../mechanics/bodies.h"
#include "../mechanics/vectors.h"
#include "scene.h"

enum { VM_BUDGET = 15 };
#define VM_SCENE_WORK(size) (RK45_WORK(size) + (size))

/* numbers in the state; VM_BAD_ARGUMENT for null pointers */
VM_API int vm_scene_size(const vm_scene *scene)
{
    int i, size = scene && scene->book ? VM_BUDGET : 0;
    if (!scene || (scene->n_bodies > 0 && !scene->bodies)) return VM_BAD_ARGUMENT;
    for (i = 0; i < scene->n_bodies; i++) size += vmi_scene_body_size(scene->bodies + i);
    return size;
}

VM_API void vmi_scene_body_now(const vm_scene *s, int body, const vm_real *y, vm_body *now)
{
    const vm_scene_body *b = s->bodies + body;
    *now = b->start;
    now->mass = b->mass_is_state ? y[b->mass_at] : b->load.mass;
    now->inertia = b->inertia;
    b->get(b, y + b->at, now);
}

/* Body 0 <= body < n_bodies of a scene that has been started as it moves in state y; where its mass is of a law, that
   when the right-hand side was last evaluated. NaN where there is no such body, for null pointers and before a
   start */
VM_API void vm_scene_body_at(const vm_scene *scene, int body, const vm_real *y, vm_body *now)
{
    const vm_vec3 none = {VM_NAN, VM_NAN, VM_NAN};
    if (!now) return;
    if (scene && scene->size && y && body >= 0 && body < scene->n_bodies) {
        vmi_scene_body_now(scene, body, y, now);
        return;
    }
    now->mass = now->q.w = now->q.x = now->q.y = now->q.z = VM_NAN;
    now->inertia.xx = now->inertia.yy = now->inertia.zz = VM_NAN;
    now->inertia.xy = now->inertia.xz = now->inertia.yz = VM_NAN;
    now->r = now->v = now->omega = none;
}

/* The state of a body that moves as now; its angle is given apart, since a turn more or less does not show in now */
VM_API void vmi_scene_put(vm_scene *s, int body, const vm_body *now, vm_real angle, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    b->mass = now->mass;
    b->inertia = now->inertia;
    if (b->mass_is_state) y[b->mass_at] = now->mass;
    b->put(b, now, angle, y + b->at);
}

/* Effects on bodies that are not there do not act */
VM_API void vmi_scene_presence(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_effects; i++) {
        vm_effect *e = s->effects + i;
        const int gone = s->bodies[e->body].away || (e->other >= 0 && s->bodies[e->other].away);
        e->idle = (e->idle & 1) | (gone ? 2 : 0);
    }
}

#endif
