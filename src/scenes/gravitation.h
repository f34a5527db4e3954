/* scenes/gravitation.h - Newton's gravitation between bodies and towards a fixed centre

   The attraction falls with the inverse square of the distance and acts at the mass centres. It is computed from the
   present masses, even if streams, laws or events change the masses. The bodies move in the plane or in space, or are
   points. For uniform gravity use vm_effect_gravity.

       vm_vec3 zero = {0, 0, 0};
       vm_effect effects[] = {vm_effect_gravitation(0, 1, 6.6743e-11),                // between the bodies 0 and 1
                              vm_effect_central_gravity(2, zero, 3.986004418e14)};    // towards the Earth's centre

   Tests: tests/test_orbit.c. */
#ifndef VARMASS_SCENES_GRAVITATION_H
#define VARMASS_SCENES_GRAVITATION_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "motions.h"
#include "scene.h"

enum { VMI_GRAVITATION_G = 0, VMI_CENTRAL_CENTRE = 0, VMI_CENTRAL_MU = 3 };

/* The attraction a b/r^2 along d, the vector to the other mass. r is the length of d, and a b is G times the product
   of the two masses. Each of the factors a and b is divided by r before the multiplication, because the product a b
   could overflow. If the force is not finite, because the masses are at the same place, the scene gets the status
   VM_NOT_FINITE, and the integrator refuses the step. */
VM_INLINE vm_vec3 vmi_gravitation(vm_real a, vm_real b, vm_vec3 d, vm_scene *s)
{
    const vm_real r = VM_SQRT(vm_dot(d, d));
    const vm_vec3 force = vm_scale(a / r * (b / r), vm_scale(1 / r, d));
    if (!vmi_vec3_is_finite(force)) s->status = VM_NOT_FINITE;
    return force;
}

/* An effect of gravitation, which can act on bodies in the plane, points and free bodies */
VM_API vm_effect vmi_effect_gravitation(int body, int other,
                                        void (*apply)(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s))
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, apply);
    e.motions = VMI_FLAT | 1 << VM_FREE;
    e.other_motions = VMI_FLAT | 1 << VM_FREE;
    return e;
}

VM_API void vmi_apply_gravitation(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body, *other = s->bodies + e->other;
    const vm_vec3 d = vm_sub(vmi_scene_moving(other, y + other->at), vmi_scene_moving(b, y + b->at));
    const vm_vec3 force = vmi_gravitation(e->p[VMI_GRAVITATION_G] * e->load->mass, e->other_load->mass, d, s);
    const vm_vec3 none = {0, 0, 0};
    (void)t;
    vmi_scene_add(b, e->load->force, force, none);
    vmi_scene_add(other, e->other_load->force, vm_scale(-1, force), none);
}

VM_API int vmi_gravitation_check(const vm_effect *e)
{
    if (e->other == VM_GROUND) return VM_NO_SUCH_BODY;
    return e->other == e->body ? (int)VM_SAME_BODY : (int)VM_OK;
}

/* Gravitation between two bodies, the force G M1 M2/r^2. G is in m^3/(kg s^2), 6.6743e-11 in nature; M1 and M2 are the
   present masses and r is the distance of the mass centres. The force on a body in the plane stays in the plane.
   vm_scene_start returns VM_NO_SUCH_BODY if `other` is VM_GROUND, VM_SAME_BODY if `other` is equal to `body`, and
   VM_BAD_MOTION if one of the bodies is on a line or an axle. If the bodies fall onto each other, a run ends with
   VM_STEP_TOO_SMALL, since the force grows without limit; if they are at one place when a run starts, it ends with
   VM_NOT_FINITE. */
VM_API vm_effect vm_effect_gravitation(int body, int other, vm_real G)
{
    vm_effect e = vmi_effect_gravitation(body, other, vmi_apply_gravitation);
    e.p[VMI_GRAVITATION_G] = G;
    e.check = vmi_gravitation_check;
    return e;
}

VM_API void vmi_apply_central_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    const vm_vec3 d = vm_sub(vmi_scene_moving(b, e->p + VMI_CENTRAL_CENTRE), vmi_scene_moving(b, y + b->at));
    const vm_vec3 none = {0, 0, 0};
    (void)t;
    vmi_scene_add(b, e->load->force, vmi_gravitation(e->load->mass, e->p[VMI_CENTRAL_MU], d, s), none);
}

/* Gravitation towards a centre at rest, the force mu M/r^2. mu is G times the mass in the centre, in m^3/s^2
   (3.986004418e14 for the Earth); M is the present mass of the body and r its distance from the centre. The argument
   centre is in m and inertial axes; for a body in the plane centre.z is not used. vm_scene_start returns VM_BAD_MOTION
   if the body is on a line or an axle. If the body falls into the centre, a run ends as for vm_effect_gravitation. */
VM_API vm_effect vm_effect_central_gravity(int body, vm_vec3 centre, vm_real mu)
{
    vm_effect e = vmi_effect_gravitation(body, VM_GROUND, vmi_apply_central_gravity);
    e.p[VMI_CENTRAL_CENTRE] = centre.x;
    e.p[VMI_CENTRAL_CENTRE + 1] = centre.y;
    e.p[VMI_CENTRAL_CENTRE + 2] = centre.z;
    e.p[VMI_CENTRAL_MU] = mu;
    return e;
}

#endif
