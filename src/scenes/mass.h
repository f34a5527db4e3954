/* scenes/mass.h - mass that follows a law, and its reactive force

   A mass law M(t, x, v) says what mass a body has at any time; the mass is then no state of the scene. What joins or
   leaves has the velocity u + (1 - reactive) v, where v is that of the body. So M v' = F + M' (u - reactive v), with
     reactive = 1  the absolute velocity u: the full reactive force (156), with u = 0 Levi-Civita's (167)-(169);
     reactive = 0  the velocity of the body and u beyond it: no reactive force if u = 0 (166).
   x and v are those of a line or an axle: J(phi), J(omega). For any other motion a law is M(t). u is in m/s; on a line
   u.x alone counts, on an axle too, in rad/s.

       vm_effect leak = vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 0); // body 0 loses 10 g/s, which keeps its velocity

   A law stands before the other effects on its body, and a body has one at the most. What jumps add comes on top of the
   law. If an event switches a law off, the mass stays as it is; if it switches a law on, the law goes on from the mass
   that is there (of M0 + c t then only c counts). So a switch never changes a mass suddenly.

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_MASS_H
#define VARMASS_SCENES_MASS_H

#include "../base/real.h"
#include "../mechanics/streams.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "scene.h"

/* Places of the parameters of mass laws and of streams: the velocity u (three numbers), `reactive`, and the coefficient
   of a law or the rate of a stream */
enum { VMI_MASS_U = 0, VMI_MASS_REACTIVE = 3, VMI_MASS_COEFFICIENT = 4, VMI_MASS_RATE = 4 };

/* Adds the reactive force rate (u - reactive v) to each coordinate in which the mass moves, and to the budget what the
   mass brings */
VM_INLINE void vmi_scene_reactive(const vm_effect *e, const vm_real *y, vm_scene *s, vm_real rate, const vm_real *u,
                                  vm_real reactive)
{
    vm_load *load = e->load;
    const vm_real *v = y + e->v;
    const int n = vmi_scene_directions(s->bodies[e->body].motion);
    int i;
    for (i = 0; i < n; i++) {
        const vm_real joining = u[i] + (1 - reactive) * v[i], push = rate * (joining - v[i]);
        load->force[i] += push;
        if (!s->budget) continue;
        load->reactive[i] += push;
        load->brought[i] += rate * joining;
        load->brought_energy += rate * joining * joining / 2;
        load->mixing += push * (joining - v[i]) / 2;
    }
}

/* Gives the body the mass of a law. M' = by_t + by_x v + by_v v'; the last term is not known before the acceleration
   is, so that (M'(v) (v - u)) v' goes to the other side of the equation, into extra_mass. */
VM_INLINE void vmi_scene_apply_law(const vm_effect *e, const vm_real *y, vm_scene *s, const vm_mass_now *now,
                                const vm_real *u, vm_real reactive)
{
    vm_load *load = e->load;
    const vm_real v = y[e->v];
    load->mass = now->mass + s->bodies[e->body].law_offset;
    load->extra_mass = now->by_v * (reactive * v - u[0]);
    load->mass_by_v = now->by_v;
    load->joining_v = u[0] + (1 - reactive) * v;
    vmi_scene_reactive(e, y, s, now->by_t + now->by_x * v, u, reactive);
}

VM_API void vmi_apply_mass_law(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_mass_now now = e->law(t, y[e->x], y[e->v], e->ctx);
    vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A mass law M(t, x, v) that the caller's function returns. The effect includes the reactive force. The velocity of
   the mass that joins or leaves is u + (1 - reactive) v. VM_BAD_ARGUMENT at the start where law is NULL. A run ends
   with VM_BAD_MASS where the mass is not positive, with VM_NO_EFFECTIVE_MASS where M + M'(v) (v - u) is not. */
VM_API vm_effect vm_effect_mass_law(int body, vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
                                    void *ctx, vm_vec3 u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, law ? vmi_apply_mass_law : NULL);
    e.p[VMI_MASS_U] = u.x;
    e.p[VMI_MASS_U + 1] = u.y;
    e.p[VMI_MASS_U + 2] = u.z;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.order = VMI_ORDER_MASS_LAW;
    e.law = law;
    e.ctx = ctx;
    return e;
}

/* The kinds of vm_effect_mass. M0 is the mass with which the body was made. */
enum {
    VM_MASS_OF_T, /* M0 + c t, c in kg/s */
    VM_MASS_OF_X, /* M0 + c x, c in kg/m */
    VM_MASS_OF_V2 /* M0 + c v^2, c in kg s^2/m^2 */
};

VM_API void vmi_apply_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = y[e->x], v = y[e->v], c = e->p[VMI_MASS_COEFFICIENT];
    vm_mass_now now = {0, 0, 0, 0};
    now.mass = s->bodies[e->body].start.mass;
    if (e->variant == VM_MASS_OF_T) {
        now.mass += c * t;
        now.by_t = c;
    } else if (e->variant == VM_MASS_OF_X) {
        now.mass += c * x;
        now.by_x = c;
    } else {
        now.mass += c * v * v;
        now.by_v = 2 * c * v;
    }
    vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A mass that is M0 + c t, M0 + c x or M0 + c v^2, with its reactive force. kind is VM_MASS_OF_T, VM_MASS_OF_X or
   VM_MASS_OF_V2; the last two are for a line or an axle. The velocity of the mass that joins or leaves is
   u + (1 - reactive) v, with u along coordinate 0. VM_BAD_ARGUMENT at the start for another kind; errors of a run as in
   vm_effect_mass_law. */
VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_mass);
    if (kind < VM_MASS_OF_T || kind > VM_MASS_OF_V2) e.apply = NULL; /* refused by vm_scene_check */
    e.variant = kind;
    e.p[VMI_MASS_U] = u;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.p[VMI_MASS_COEFFICIENT] = c;
    if (kind != VM_MASS_OF_T) e.motions = VMI_SINGLE;
    e.order = VMI_ORDER_MASS_LAW;
    return e;
}

#endif
