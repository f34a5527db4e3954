/* scenes/effects.h - effects that act on coordinates */
#ifndef VARMASS_SCENES_EFFECTS_H
#define VARMASS_SCENES_EFFECTS_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/vectors.h"
#include "forces.h"
#include "motions.h"
#include "scene.h"

/* An effect on one coordinate, against another */
VM_API vm_effect vmi_effect(int body, int coordinate, int other, int other_coordinate, unsigned motions, vm_real p0,
                            vm_real p1, vm_real p2)
{
    vm_effect e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.other = other;
    e.other_coordinate = other_coordinate;
    e.motions = motions;
    e.other_motions = VMI_ALL_MOTIONS;
    e.order = 1;
    e.p[0] = p0;
    e.p[1] = p1;
    e.p[2] = p2;
    return e;
}

VM_API void vmi_apply_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)y;
    (void)s;
    e->load->force[e->coordinate] += vm_force_gravity(e->load->mass, e->p[0]);
}

/* Effects, the forces above on a coordinate of a body, x and v its position and velocity; where there is an other
   body, or VM_GROUND, x and v are relative to its coordinate, and it takes the reaction. A mass law of a body stands
   before what else acts on it. */
/* M g, along the coordinate: g = -9.81 where it points upwards; not on an angle */
VM_API vm_effect vm_effect_gravity(int body, int coordinate, vm_real g)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS & ~(1 << VM_AXLE), g, 0, 0);
    e.not_on_angle = 1;
    e.apply = vmi_apply_gravity;
    return e;
}

VM_API void vmi_apply_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_spring(e->p[0], e->p[1], vmi_effect_x(e, y) - e->p[2]));
}

VM_API int vmi_power_check(const vm_effect *e) { return e->p[1] >= 0 ? VM_OK : VM_DOMAIN; } /* alpha */

/* vm_force_spring of x - rest */
VM_API vm_effect vm_effect_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                  vm_real alpha, vm_real rest)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, k, alpha, rest);
    e.apply = vmi_apply_spring;
    e.check = vmi_power_check;
    return e;
}

VM_API void vmi_apply_linear_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, -e->p[0] * (vmi_effect_x(e, y) - e->p[2]));
}

/* the same with alpha = 1: no power is linked */
VM_API vm_effect vm_effect_linear_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                         vm_real rest)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, k, 1, rest);
    e.apply = vmi_apply_linear_spring;
    return e;
}

VM_API void vmi_apply_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_damper(e->p[0], vmi_effect_v(e, y)));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_damper(int body, int coordinate, int other, int other_coordinate, vm_real b)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, b, 0, 0);
    e.apply = vmi_apply_damper;
    return e;
}

VM_API void vmi_apply_rotational_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    const vm_vec3 torque = vmi_scale(-e->p[0], vmi_scene_spin(b, y));
    (void)t;
    vmi_scene_add(b, e->load->force, vmi_vec3(0, 0, 0), torque);
}

/* -b omega: on an axle, in the plane, free */
VM_API vm_effect vm_effect_rotational_damper(int body, vm_real b)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, 1 << VM_AXLE | 1 << VM_PLANE | 1 << VM_FREE, b, 0, 0);
    e.apply = vmi_apply_rotational_damper;
    return e;
}

VM_API void vmi_apply_van_der_pol(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_van_der_pol(e->p[0], e->p[1], vmi_effect_x(e, y), vmi_effect_v(e, y)));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_van_der_pol(int body, int coordinate, vm_real b, vm_real c)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, b, c, 0);
    e.apply = vmi_apply_van_der_pol;
    return e;
}

VM_API void vmi_apply_drive(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_motor(e->p[0], e->p[1], vmi_effect_v(e, y)));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_motor(int body, int coordinate, vm_real torque, vm_real kappa)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, torque, kappa, 0);
    e.apply = vmi_apply_drive;
    return e;
}

VM_API void vmi_apply_harmonic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)y;
    (void)s;
    vmi_effect_act(e, vm_force_harmonic(e->p[0], e->p[1], e->p[2], t));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_harmonic(int body, int coordinate, vm_real force, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, force, frequency, phase);
    e.apply = vmi_apply_harmonic;
    return e;
}

VM_API void vmi_apply_user(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)s;
    vmi_effect_act(e, e->force(t, vmi_effect_x(e, y), vmi_effect_v(e, y), e->ctx));
}

/* Documented with vm_effect_force. */
VM_API vm_effect vm_effect_force_between(int body, int coordinate, int other, int other_coordinate,
                                        vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, 0, 0, 0);
    e.apply = force ? vmi_apply_user : NULL;
    e.force = force;
    e.ctx = ctx;
    return e;
}

/* a force of one's own, which depends on t and the coordinate, and on what ctx points to */
VM_API vm_effect vm_effect_force(int body, int coordinate,
                                vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    return vm_effect_force_between(body, coordinate, VM_GROUND, 0, force, ctx);
}

/* an effect of one's own, which may depend on everything: apply adds to effect->load->force[coordinate], to
   load->mass_rate where the mass is a state, to load->mass where it is neither a state nor of a law; it may read
   load->mass, y[effect->x] and y[effect->v], the first coordinate's, y[scene->bodies[i].at] and what follows of body
   i, effect->p and effect->ctx, and load->force, which is what the effects before it in the list have made: a stop,
   listed last, can take from it what it holds. other, or VM_GROUND: a body without which it does not act either,
   effect->other_load and so on */
VM_API vm_effect vm_effect_custom(int body, int other,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene),
                                    void *ctx)
{
    vm_effect e = vmi_effect(body, 0, other, 0, VMI_ALL_MOTIONS, 0, 0, 0);
    e.apply = apply;
    e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_shaft(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_shaft(e->p[0], e->p[1], y[e->x], y[e->x + 1], &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* an elastic shaft: -k r |r|^(alpha-1) towards the origin, in coordinates 0 and 1 of a body in the plane, a point */
VM_API vm_effect vm_effect_shaft(int body, vm_real k, vm_real alpha)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, k, alpha, 0);
    e.apply = vmi_apply_shaft;
    e.check = vmi_power_check;
    return e;
}

VM_API void vmi_apply_unbalance(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)y;
    (void)s;
    vm_force_unbalance(e->p[0], e->p[1], e->p[2], t, &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* an unbalance m e (kg m) that turns with Omega = frequency: m e Omega^2 (cos, sin)(Omega t + phase) */
VM_API vm_effect vm_effect_unbalance(int body, vm_real unbalance, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, unbalance, frequency, phase);
    e.apply = vmi_apply_unbalance;
    return e;
}

VM_API void vmi_apply_gyroscopic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_gyroscopic(e->p[0], y[e->v], y[e->v + 1], &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* force coupling (-vy, vx) */
VM_API vm_effect vm_effect_gyroscopic(int body, vm_real coupling)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, coupling, 0, 0);
    e.apply = vmi_apply_gyroscopic;
    return e;
}

#endif
