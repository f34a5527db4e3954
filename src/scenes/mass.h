/* scenes/mass.h - mass that follows a law, and its reactive force

   A mass law M(t, x, v) gives the mass of a body at any time; the mass is then not a number of the state. The mass
   that joins or leaves has the velocity u + (1 - reactive) v, where v is the velocity of the body; the caller chooses
   the velocity u and the number `reactive`. Therefore the equation of motion under the force F is M v' = F + M' (u -
   reactive v). The mass that joins or leaves has, for
     reactive = 1  the absolute velocity u: the reactive force is M' (u - v) (156), Levi-Civita's (167)-(169) if u = 0;
     reactive = 0  the velocity u relative to the body: the reactive force is M' u, which is 0 if u = 0 (166).
   Only on a line or an axle may a law depend on the position x and the velocity v. On an axle x is the angle, v the
   angular velocity, and the law gives the moment of inertia. u is a vector in m/s; on a line and on an axle only u.x
   is used, which is in rad/s on an axle.

       vm_effect leak = vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 0); // body 0 loses 10 g/s, which keeps its velocity

   In the list of effects a mass law must stand before all other effects on its body, and a body has at most one mass
   law. If a jump adds mass to the body, this mass is added to the mass that the law gives. If an event switches a law
   off, the mass remains constant. If an event switches a law on, the law continues from the present mass: of a law M0
   + c t only the rate c then matters, and not M0. Therefore switching never changes a mass suddenly.

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_MASS_H
#define VARMASS_SCENES_MASS_H

#include "../base/real.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "scene.h"

/* Indices of the parameters p of mass laws and of streams: the velocity u (three numbers), `reactive`, and the
   coefficient c of a law or the rate of a stream */
enum { VMI_MASS_U = 0, VMI_MASS_REACTIVE = 3, VMI_MASS_COEFFICIENT = 4, VMI_MASS_RATE = 4 };

/* Adds the reactive force rate (u - reactive v) to each coordinate of the mass centre (on an axle to the angle), and
   adds to the budget the momentum and the energy that the mass brings. u and v are the components along this
   coordinate. */
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

/* Gives a body the mass M of a law, and adds the reactive force. *now has M, and the partial derivatives of M with
   respect to time t, position x and velocity v: by_t, by_x and by_v. Thus the mass changes at the rate M' = by_t +
   by_x v + by_v v'. The acceleration v' is not known yet. Therefore this function adds only the reactive force of the
   first two terms of M'. The reactive force of the last term is by_v v' (u - reactive v). It is moved to the left side
   of the equation of motion M v' = F + M' (u - reactive v), which then is (M + extra_mass) v' with extra_mass = by_v
   (reactive v - u). So extra_mass acts like an additional mass. */
VM_INLINE void vmi_scene_apply_law(const vm_effect *e, const vm_real *y, vm_scene *s, const vm_mass_law_values *now,
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
    const vm_mass_law_values now = e->law(t, y[e->x], y[e->v], e->ctx);
    vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A mass law M(t, x, v) that the caller's function returns. The effect includes the reactive force. The velocity of
   the mass that joins or leaves is u + (1 - reactive) v, where v is the velocity of the body: u is absolute if
   reactive is 1, and relative to the body if reactive is 0. vm_scene_start returns VM_BAD_ARGUMENT if law is NULL. A
   run ends with VM_BAD_MASS if the mass is not positive, and with VM_NO_EFFECTIVE_MASS if M + dM/dv (reactive v - u)
   is not positive. */
VM_API vm_effect vm_effect_mass_law(int body, vm_mass_law_values (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
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

/* The argument `kind` of vm_effect_mass says on what the mass depends. M0 is the mass with which the body was made, c
   a constant. */
enum {
    VM_MASS_OF_T, /* the mass is M0 + c t at the time t, with c in kg/s */
    VM_MASS_OF_X, /* the mass is M0 + c x at the position x, with c in kg/m */
    VM_MASS_OF_V2 /* the mass is M0 + c v^2 at the velocity v, with c in kg s^2/m^2 */
};

VM_API void vmi_apply_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = y[e->x], v = y[e->v], c = e->p[VMI_MASS_COEFFICIENT];
    vm_mass_law_values now = {0, 0, 0, 0};
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

/* A mass that is M0 + c t, M0 + c x or M0 + c v^2, with its reactive force. M0 is the mass with which the body was
   made. kind is VM_MASS_OF_T, VM_MASS_OF_X or VM_MASS_OF_V2; the last two are for a line or an axle. The velocity of
   the mass that joins or leaves is u + (1 - reactive) v along coordinate 0, where v is the velocity of the body: u is
   absolute if reactive is 1, and relative to the body if reactive is 0. vm_scene_start returns VM_BAD_ARGUMENT if kind
   is unknown. A run can end with the same errors as a run with vm_effect_mass_law. */
VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_mass);
    if (kind < VM_MASS_OF_T || kind > VM_MASS_OF_V2) e.apply = NULL; /* vm_scene_check then refuses the effect */
    e.variant = kind;
    e.p[VMI_MASS_U] = u;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.p[VMI_MASS_COEFFICIENT] = c;
    if (kind != VM_MASS_OF_T) e.motions = VMI_SINGLE;
    e.order = VMI_ORDER_MASS_LAW;
    return e;
}

#endif
