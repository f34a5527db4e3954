/* scenes/state.h - the state of a scene: its size, and the bodies in it

   The state y of a scene contains the state variables of the bodies, one body after the other. If the scene keeps a
   budget, the VM_BUDGET_STATES numbers of the budget follow. scene.h has a table of the numbers of each body.

       vm_body now;
       vm_scene_body_at(&scene, 0, y, &now); // now.r.x, now.v.x, now.mass: body 0 in the state y

   Tests: tests/test_scene_bodies.c. */
#ifndef VARMASS_SCENES_STATE_H
#define VARMASS_SCENES_STATE_H

#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/rk45.h"
#include "../mechanics/bodies.h"
#include "../mechanics/vectors.h"
#include "scene.h"

enum { VM_BUDGET_STATES = 15 }; /* number of elements that a budget adds to the state */

/* The number of elements of the array `work` that vm_scene_run needs for a state of `size` numbers */
#define VM_SCENE_WORK(size) (RK45_WORK(size) + (size))

/* Returns 1 if a list can have n elements, else 0: n must not be negative, and `list` must not be NULL unless n is
   0 */
VM_INLINE int vmi_scene_is_list(int n, const void *list)
{
    if (n > 0) return list != NULL;
    return n == 0;
}

/* Returns 1 if the lists of bodies and effects of a scene are possible lists (vmi_scene_is_list), else 0 */
VM_INLINE int vmi_scene_has_lists(const vm_scene *s)
{
    return vmi_scene_is_list(s->n_bodies, s->bodies) && vmi_scene_is_list(s->n_effects, s->effects);
}

/* Number of elements of the state of a scene. These are the elements of all bodies, and VM_BUDGET_STATES more if the
   scene keeps a budget. Returns VM_BAD_ARGUMENT if scene is NULL, or if the list of its bodies is missing or has a
   negative length. */
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

/* The motion of a body in the state y. The scene must have been started, and 0 <= body < n_bodies. If a law gives the
   mass, now->mass is the mass at the last evaluation of the right-hand side. All numbers of *now are NaN if no body
   has this index, if scene or y is NULL, or if the scene was not started. */
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

/* Writes the motion *now of a body into the state. The angle is a separate argument, since the attitude in *now cannot
   tell how many complete turns the angle includes. */
VM_API void vmi_scene_put(vm_scene *s, int body, const vm_body *now, vm_real angle, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    b->mass = now->mass;
    b->inertia = now->inertia;
    if (b->mass_is_state) y[b->mass_at] = now->mass;
    b->put(b, now, angle, y + b->at);
}

/* Updates the field `idle` of all effects. It is 0 if the effect acts. It is not 0 if the effect is switched off, or
   if its body, or the body on which the opposite force acts, is not present. */
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
