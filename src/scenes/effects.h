/* scenes/effects.h - springs, dampers, motors and other forces on a coordinate

   An effect of this file exerts a force on a coordinate of a body; forces.h has the formulas of most of these forces.
   x and v are the position and the velocity of this coordinate. If an effect acts against another body, x and v are
   relative to a coordinate of that body, and the opposite force acts on that coordinate. If it acts against VM_GROUND,
   x and v are relative to a point at rest. In the list of effects a mass law must stand before all other effects on
   its body, and a link must stand after them.

       vm_effect effects[] = {vm_effect_gravity(0, 0, -9.81),                       // weight of body 0
                              vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1000, 0), // 1000 N/m to the ground
                              vm_effect_damper(1, 0, 0, 0, 5)};                     // 5 N s/m between bodies 1 and 0

   In all constructors of this file `body` and `other` are indices of bodies, `coordinate` and `other_coordinate` are
   their coordinates (scene.h has a list). A constructor checks only whether a function of the caller is NULL;
   vm_scene_check and vm_scene_start refuse an effect that cannot act on its body, and parameters that are infinite,
   NaN or outside their domain.

   Tests: tests/test_scene_effects.c. */
#ifndef VARMASS_SCENES_EFFECTS_H
#define VARMASS_SCENES_EFFECTS_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/vectors.h"
#include "forces.h"
#include "motions.h"
#include "scene.h"

/* To add a new kind of effect, write one block of code like that of the spring (vm_effect_spring). The other code of
   the headers does not change. The block has these parts:
     an enum          names the indices of the parameters in p[6];
     vmi_apply_NAME   adds the force to the loads, at each evaluation;
     vmi_NAME_check   checks the parameters and returns a status; it is needed only if some finite values are
                      not allowed;
     vm_effect_NAME   is the constructor: it calls vmi_effect and sets the parameters and all that differs from the
                      defaults (the motions on which the effect can act, the check).
   The force itself may be a function of forces.h. */

/* An effect on a coordinate of a body, with the opposite force on a coordinate of another body. The effect can act on
   all kinds of motion, it is neither a mass law nor a link, and its parameters are 0. */
VM_API vm_effect vmi_effect_between(int body, int coordinate, int other, int other_coordinate,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene))
{
    vm_effect e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.other = other;
    e.other_coordinate = other_coordinate;
    e.apply = apply;
    e.motions = VMI_ALL_MOTIONS;
    e.other_motions = VMI_ALL_MOTIONS;
    e.order = VMI_ORDER_FORCE;
    return e;
}

/* An effect on a coordinate of a body against the ground, with the defaults of vmi_effect_between */
VM_API vm_effect vmi_effect(int body, int coordinate,
                            void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene))
{
    return vmi_effect_between(body, coordinate, VM_GROUND, 0, apply);
}

enum { VMI_GRAVITY_G };

VM_API void vmi_apply_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)y;
    (void)s;
    e->load->force[e->coordinate] += vm_force_gravity(e->load->mass, e->p[VMI_GRAVITY_G]);
}

/* Gravity along a coordinate, the force M g. M is the present mass of the body. g in m/s^2 is -9.81 if the coordinate
   points up. Gravity cannot act on an axle (VM_BAD_MOTION) or on the angle of a body in the plane (VM_NOT_ON_ANGLE). */
VM_API vm_effect vm_effect_gravity(int body, int coordinate, vm_real g)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_gravity);
    e.p[VMI_GRAVITY_G] = g;
    e.motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.not_on_angle = 1;
    return e;
}

enum { VMI_SPRING_STIFFNESS, VMI_SPRING_EXPONENT, VMI_SPRING_REST };

VM_API void vmi_apply_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real extension = vmi_effect_x(e, y) - e->p[VMI_SPRING_REST];
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_spring(extension, e->p[VMI_SPRING_STIFFNESS], e->p[VMI_SPRING_EXPONENT]));
}

VM_API int vmi_spring_check(const vm_effect *e) { return e->p[VMI_SPRING_EXPONENT] >= 0 ? VM_OK : VM_DOMAIN; }

/* A nonlinear spring, the force -k z |z|^(alpha-1) with z = x - rest (248). The stiffness k in N/m^alpha may have
   either sign; rest, the position without force, is in m or rad. vm_scene_start returns VM_DOMAIN if alpha < 0. */
VM_API vm_effect vm_effect_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                  vm_real alpha, vm_real rest)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, vmi_apply_spring);
    e.p[VMI_SPRING_STIFFNESS] = k;
    e.p[VMI_SPRING_EXPONENT] = alpha;
    e.p[VMI_SPRING_REST] = rest;
    e.check = vmi_spring_check;
    return e;
}

VM_API void vmi_apply_linear_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real extension = vmi_effect_x(e, y) - e->p[VMI_SPRING_REST];
    (void)t;
    (void)s;
    vmi_effect_act(e, -e->p[VMI_SPRING_STIFFNESS] * extension);
}

/* A linear spring, the force -k (x - rest). The stiffness k in N/m may have either sign; rest, the position without
   force, is in m or rad. Unlike vm_effect_spring, this effect does not need the power function, so that a program with
   it is smaller. */
VM_API vm_effect vm_effect_linear_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                         vm_real rest)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, vmi_apply_linear_spring);
    e.p[VMI_SPRING_STIFFNESS] = k;
    e.p[VMI_SPRING_REST] = rest;
    return e;
}

enum { VMI_DAMPER_DAMPING };

VM_API void vmi_apply_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_damper(vmi_effect_v(e, y), e->p[VMI_DAMPER_DAMPING]));
}

/* A linear damper, the force -damping v. v is the velocity of the coordinate relative to other_coordinate of the body
   `other`. damping is in N s/m; if it is positive, the damper takes energy out. */
VM_API vm_effect vm_effect_damper(int body, int coordinate, int other, int other_coordinate, vm_real damping)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, vmi_apply_damper);
    e.p[VMI_DAMPER_DAMPING] = damping;
    return e;
}

VM_API void vmi_apply_rotational_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    const vm_vec3 torque = vm_scale(-e->p[VMI_DAMPER_DAMPING], vmi_scene_spin(b, y));
    (void)t;
    vmi_scene_add(b, e->load->force, vmi_vec3(0, 0, 0), torque);
}

/* A damper of the rotation, the torque -damping omega. damping is in N m s; if it is positive, the damper takes energy
   out. omega is the angular velocity of a body on an axle, in the plane, or free. */
VM_API vm_effect vm_effect_rotational_damper(int body, vm_real damping)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_rotational_damper);
    e.p[VMI_DAMPER_DAMPING] = damping;
    e.motions = 1 << VM_AXLE | 1 << VM_PLANE | 1 << VM_FREE;
    return e;
}

enum { VMI_VAN_DER_POL_FEEDING, VMI_VAN_DER_POL_LIMITING };

VM_API void vmi_apply_van_der_pol(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real b = e->p[VMI_VAN_DER_POL_FEEDING], c = e->p[VMI_VAN_DER_POL_LIMITING];
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_van_der_pol(vmi_effect_x(e, y), vmi_effect_v(e, y), b, c));
}

/* Van der Pol's damper, the force (b - c x^2) v (404). x and v are the position and velocity of the coordinate. A
   positive b in N s/m feeds energy in; a positive c in N s/m^3 takes energy out at large amplitudes. */
VM_API vm_effect vm_effect_van_der_pol(int body, int coordinate, vm_real b, vm_real c)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_van_der_pol);
    e.p[VMI_VAN_DER_POL_FEEDING] = b;
    e.p[VMI_VAN_DER_POL_LIMITING] = c;
    return e;
}

enum { VMI_MOTOR_STALL_TORQUE, VMI_MOTOR_KAPPA };

VM_API void vmi_apply_motor(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_motor(vmi_effect_v(e, y), e->p[VMI_MOTOR_STALL_TORQUE], e->p[VMI_MOTOR_KAPPA]));
}

/* A motor, the torque stall_torque - kappa v. v is the angular velocity in rad/s, stall_torque the torque at rest in
   N m, and kappa in N m s the decrease of the torque per rad/s. On a coordinate that is a length the units are N and
   N s/m. */
VM_API vm_effect vm_effect_motor(int body, int coordinate, vm_real stall_torque, vm_real kappa)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_motor);
    e.p[VMI_MOTOR_STALL_TORQUE] = stall_torque;
    e.p[VMI_MOTOR_KAPPA] = kappa;
    return e;
}

enum { VMI_HARMONIC_AMPLITUDE, VMI_HARMONIC_FREQUENCY, VMI_HARMONIC_PHASE };

VM_API void vmi_apply_harmonic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real frequency = e->p[VMI_HARMONIC_FREQUENCY], phase = e->p[VMI_HARMONIC_PHASE];
    (void)y;
    (void)s;
    vmi_effect_act(e, vm_force_harmonic(t, e->p[VMI_HARMONIC_AMPLITUDE], frequency, phase));
}

/* Harmonic excitation, the force amplitude cos(frequency t + phase). amplitude is in N (N m on an angle), frequency in
   rad/s, phase in rad. */
VM_API vm_effect vm_effect_harmonic(int body, int coordinate, vm_real amplitude, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_harmonic);
    e.p[VMI_HARMONIC_AMPLITUDE] = amplitude;
    e.p[VMI_HARMONIC_FREQUENCY] = frequency;
    e.p[VMI_HARMONIC_PHASE] = phase;
    return e;
}

VM_API void vmi_apply_force(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)s;
    vmi_effect_act(e, e->force(t, vmi_effect_x(e, y), vmi_effect_v(e, y), e->ctx));
}

/* A force that the caller's function returns, between two coordinates. force(t, x, v, ctx) returns the force in N (on
   an angle the torque in N m). x and v are position and velocity of the coordinate, relative to other_coordinate of
   the body `other`, on which the opposite force acts. vm_scene_start returns VM_BAD_ARGUMENT if force is NULL. */
VM_API vm_effect vm_effect_force_between(int body, int coordinate, int other, int other_coordinate,
                                        vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, force ? vmi_apply_force : NULL);
    e.force = force;
    e.ctx = ctx;
    return e;
}

/* A force that the caller's function returns. force(t, x, v, ctx) returns the force in N (on an angle the torque in
   N m) for the time t and the position x and velocity v of the coordinate. vm_scene_start returns VM_BAD_ARGUMENT if
   force is NULL. */
VM_API vm_effect vm_effect_force(int body, int coordinate,
                                vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    return vm_effect_force_between(body, coordinate, VM_GROUND, 0, force, ctx);
}

/* An effect that the caller's function applies. It may depend on the whole state. The function `apply` adds to
     effect->load->force[coordinate]   the force;
     effect->load->mass_rate           the rate of the mass, only if the mass is a state;
     effect->load->mass                further mass, only if the mass is neither a state nor given by a law.
   It may read
     y[effect->x], y[effect->v]        position and velocity of coordinate 0;
     y[scene->bodies[i].at], ...       the state of body i;
     effect->load->mass                the present mass;
     effect->load->force               the sum of the forces of the effects that stand before it in the list;
     effect->p, effect->ctx            parameters, and a pointer of the caller.
   Since effect->load->force can be read, an effect that is listed last can act as a rigid obstacle: it subtracts the
   force with which the other effects press the body against the obstacle. other is another body, or VM_GROUND. The
   effect acts only while both bodies are present; effect->other_load, effect->other_x and effect->other_v belong to
   the body `other`. vm_scene_start returns VM_BAD_ARGUMENT if apply is NULL. */
VM_API vm_effect vm_effect_custom(int body, int other,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene),
                                    void *ctx)
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, apply);
    e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_shaft(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real k = e->p[VMI_SPRING_STIFFNESS], alpha = e->p[VMI_SPRING_EXPONENT];
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_shaft(y[e->x], y[e->x + 1], k, alpha, &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* An elastic shaft, the force -k r |r|^(alpha-1) on a body at r = (x, y). The stiffness k is in N/m^alpha;
   vm_scene_start returns VM_DOMAIN if alpha < 0. The effect acts on coordinates 0 and 1 of a body in the plane or of a
   point. */
VM_API vm_effect vm_effect_shaft(int body, vm_real k, vm_real alpha)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_shaft);
    e.p[VMI_SPRING_STIFFNESS] = k;
    e.p[VMI_SPRING_EXPONENT] = alpha;
    e.motions = VMI_FLAT;
    e.check = vmi_spring_check;
    return e;
}

enum { VMI_UNBALANCE_SIZE, VMI_UNBALANCE_FREQUENCY, VMI_UNBALANCE_PHASE };

VM_API void vmi_apply_unbalance(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real frequency = e->p[VMI_UNBALANCE_FREQUENCY], phase = e->p[VMI_UNBALANCE_PHASE];
    vm_real fx, fy;
    (void)y;
    (void)s;
    vm_force_unbalance(t, e->p[VMI_UNBALANCE_SIZE], frequency, phase, &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* A rotating unbalance, the force m e Omega^2 (cos a, sin a) at the angle a = Omega t + phase. unbalance is the mass
   m times its eccentricity e in kg m, frequency the angular velocity Omega in rad/s, and phase is in rad. The effect
   acts on coordinates 0 and 1 of a body in the plane or of a point. */
VM_API vm_effect vm_effect_unbalance(int body, vm_real unbalance, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_unbalance);
    e.p[VMI_UNBALANCE_SIZE] = unbalance;
    e.p[VMI_UNBALANCE_FREQUENCY] = frequency;
    e.p[VMI_UNBALANCE_PHASE] = phase;
    e.motions = VMI_FLAT;
    return e;
}

enum { VMI_GYROSCOPIC_GYRO };

VM_API void vmi_apply_gyroscopic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_gyroscopic(y[e->v], y[e->v + 1], e->p[VMI_GYROSCOPIC_GYRO], &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* A gyroscopic force normal to the velocity (vx, vy), 2 gyro (-vy, vx). gyro in kg/s is the coefficient in the term
   2 i gyro z' of the equation of Laval's rotor, where i is the imaginary unit and z = x + i y the deflection. The
   effect acts on coordinates 0 and 1 of a body in the plane or of a point. It does no work. */
VM_API vm_effect vm_effect_gyroscopic(int body, vm_real gyro)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_gyroscopic);
    e.p[VMI_GYROSCOPIC_GYRO] = gyro;
    e.motions = VMI_FLAT;
    return e;
}

#endif
