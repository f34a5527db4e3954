/* scenes/mass.h - laws of mass */
#ifndef VARMASS_SCENES_MASS_H
#define VARMASS_SCENES_MASS_H

#include "../base/real.h"
#include "../mechanics/streams.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "scene.h"

enum { VM_MASS_OF_T, VM_MASS_OF_X, VM_MASS_OF_V2 }; /* M0 + c t, M0 + c x, M0 + c v^2, M0 as the body was made */

/* rate (u + (share - 1) v) on each coordinate that moves the mass */
VM_INLINE void vmi_scene_reactive(const vm_effect *e, const vm_real *y, vm_scene *s, vm_real rate, const vm_real *u,
                                  vm_real share)
{
    vm_load *load = e->load;
    const vm_real *v = y + e->v;
    const int motion = s->bodies[e->body].motion, n = motion <= VM_AXLE ? 1 : motion == VM_PLANE ? 2 : 3;
    int i;
    for (i = 0; i < n; i++) {
        const vm_real own = u[i] + share * v[i], push = rate * (own - v[i]);
        load->force[i] += push;
        if (!s->book) continue;
        load->reactive[i] += push;
        load->brought[i] += rate * own;
        load->brought_energy += rate * own * own / 2;
        load->mixing += push * (own - v[i]) / 2;
    }
}

/* The mass is now that of the law; M' = by_t + by_x v + by_v v' */
VM_INLINE void vmi_scene_apply_law(const vm_effect *e, const vm_real *y, vm_scene *s, const vm_mass_now *now,
                                const vm_real *u, vm_real share)
{
    vm_load *load = e->load;
    const vm_real v = y[e->v];
    load->mass = now->mass + s->bodies[e->body].jumped;
    load->extra = now->by_v * ((1 - share) * v - u[0]);
    load->by_v = now->by_v;
    load->own = u[0] + share * v;
    vmi_scene_reactive(e, y, s, now->by_t + now->by_x * v, u, share);
}

VM_API void vmi_apply_mass_law(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_mass_now now = e->law(t, y[e->x], y[e->v], e->ctx);
    vmi_scene_apply_law(e, y, s, &now, e->p, e->p[3]);
}

/* A mass law: M(t, x, v), with the reactive force M' (u + share v - v). share = 1, u = 0: what joins or leaves has
   the body's velocity, no reactive force; 0: its own velocity is u, of which u.x counts on a line and, in rad/s, on
   an axle. x and v are those of a line or an axle (J(phi), J(omega)); of any other body the law is M(t). What jumps
   add comes on top of the law. If an event switches a law off, the mass stays as it is; if it switches a law on,
   the law goes on from the mass that is there: of M0 + c t then only c counts. So a switch never makes a mass
   jump. */
VM_API vm_effect vm_effect_mass_law(int body, vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
                                    void *ctx, vm_vec3 u, vm_real share)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_ALL_MOTIONS, u.x, u.y, u.z);
    e.p[3] = share;
    e.order = 0;
    e.apply = law ? vmi_apply_mass_law : NULL;
    e.law = law;
    e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = y[e->x], v = y[e->v], c = e->p[4];
    vm_mass_now now = {0, 0, 0, 0};
    now.mass = s->bodies[e->body].start.mass;
    if (e->other_coordinate == VM_MASS_OF_T) {
        now.mass += c * t;
        now.by_t = c;
    } else if (e->other_coordinate == VM_MASS_OF_X) {
        now.mass += c * x;
        now.by_x = c;
    } else {
        now.mass += c * v * v;
        now.by_v = 2 * c * v;
    }
    vmi_scene_apply_law(e, y, s, &now, e->p, e->p[3]);
}

VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real share)
{
    const unsigned motions = kind == VM_MASS_OF_T ? VMI_ALL_MOTIONS : VMI_SINGLE;
    vm_effect e = vmi_effect(body, 0, VM_GROUND, kind, motions, u, 0, 0);
    e.p[3] = share;
    e.p[4] = c;
    e.order = 0;
    e.apply = kind >= VM_MASS_OF_T && kind <= VM_MASS_OF_V2 ? vmi_apply_mass : NULL;
    return e;
}

/* The same, of a stream that varies: vary writes what is otherwise than in effect.stream at t and y, the point of
   contact that moves in the body, the rate, the velocity */
VM_API vm_effect vm_effect_varying(vm_effect effect,
                                   void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx),
                                   void *ctx)
{
    effect.vary = vary;
    effect.ctx = ctx;
    if (!effect.stream || !vary) effect.apply = NULL; /* which vm_scene_check refuses */
    return effect;
}

#endif
