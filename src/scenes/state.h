/* scenes/state.h - the state of a scene: its size, and the bodies in it

   A scene's state y holds the numbers of each body one after the other, and at the end, where the scene keeps a budget,
   the VM_BUDGET_STATES numbers of it. scene.h has a table of the numbers of each body.

       vm_body now;
       vm_scene_body_at(&scene, 0, y, &now); // now.r.x, now.v.x, now.mass: body 0 in the state y

   Tests: tests/test_scene_bodies.c. */
#ifndef VARMASS_SCENES_STATE_H
#define VARMASS_SCENES_STATE_H

#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/runs.h"
#include "../mechanics/bodies.h"
#include "../mechanics/vectors.h"
#include "scene.h"

enum { VM_BUDGET_STATES = 15 }; /* how many numbers a budget adds to the state */

/* How many numbers of work vm_scene_run needs for a state of so many numbers */
#define VM_SCENE_WORK(size) (RK45_WORK(size) + (size))

/* Whether a list of so many elements can be there */
VM_INLINE int vmi_scene_is_list(int n, const void *list)
{
    if (n > 0) return list != NULL;
    return n == 0;
}

/* Whether the lists that an evaluation reads can be there */
VM_INLINE int vmi_scene_has_lists(const vm_scene *s)
{
    return vmi_scene_is_list(s->n_bodies, s->bodies) && vmi_scene_is_list(s->n_effects, s->effects);
}

/* How many numbers the state of a scene has. It depends on the bodies and on whether the scene keeps a budget.
   VM_BAD_ARGUMENT where scene is NULL, its bodies are missing or their number is negative. */
VM_API int vm_scene_size(const vm_scene *scene)
{
    int i, size = 0;
    if (!scene || !vmi_scene_is_list(scene->n_bodies, scene->bodies)) return VM_BAD_ARGUMENT;
    for (i = 0; i < scene->n_bodies; i++) size += vmi_scene_body_size(scene->bodies + i);
    if (scene->budget) size += VM_BUDGET_STATES;
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

/* The motion of a body in the state y. The scene must have been started; 0 <= body < n_bodies. A mass that is given by
   a law is that of the last evaluation of the right-hand side. All numbers of *now are NaN for an index that does not
   exist, for NULL pointers, and before a start. */
VM_API void vm_scene_body_at(const vm_scene *scene, int body, const vm_real *y, vm_body *now)
{
    const vm_vec3 none = {VM_NAN, VM_NAN, VM_NAN};
    if (!now) return;
    if (scene && scene->bodies && scene->size && y && body >= 0 && body < scene->n_bodies) {
        vmi_scene_body_now(scene, body, y, now);
        return;
    }
    now->mass = now->q.w = now->q.x = now->q.y = now->q.z = VM_NAN;
    now->inertia.xx = now->inertia.yy = now->inertia.zz = VM_NAN;
    now->inertia.xy = now->inertia.xz = now->inertia.yz = VM_NAN;
    now->r = now->v = now->omega = none;
}

/* Writes a body that moves as `now` into the state. Its angle comes apart, since `now` does not tell complete turns. */
VM_API void vmi_scene_put(vm_scene *s, int body, const vm_body *now, vm_real angle, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    b->mass = now->mass;
    b->inertia = now->inertia;
    if (b->mass_is_state) y[b->mass_at] = now->mass;
    b->put(b, now, angle, y + b->at);
}

/* Makes the effects idle that act on or against a body that is not present, and the others of these not */
VM_API void vmi_scene_presence(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_effects; i++) {
        vm_effect *e = s->effects + i;
        const int away = s->bodies[e->body].away || (e->other >= 0 && s->bodies[e->other].away);
        e->idle &= VMI_IDLE_SWITCHED_OFF;
        if (away) e->idle |= VMI_IDLE_BODY_AWAY;
    }
}

#endif
