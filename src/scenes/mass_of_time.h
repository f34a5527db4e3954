/* scenes/mass_of_time.h - mass that follows a vm_law, and its reactive force

   A vm_law (oscillators/laws.h) is a number that depends on time: linear, quadratic, exponential, a power, a table,
   or a function. vm_effect_mass_of_time makes this number the mass of a body, which may have any kind of motion.
   mass.h explains the arguments u and reactive, and the switching of a law. For a law that depends on position or
   velocity use vm_effect_mass_law.

       vm_vec3 zero = {0, 0, 0};
       vm_law mass = vm_law_exponential(2, -0.01);                     // 2 kg at t = 0, 1 % less in each second
       vm_effect leak = vm_effect_mass_of_time(0, &mass, zero, 0);     // lost mass keeps the velocity of body 0

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_MASS_OF_TIME_H
#define VARMASS_SCENES_MASS_OF_TIME_H

#include "../base/real.h"
#include "../mechanics/vectors.h"
#include "../oscillators/laws.h"
#include "effects.h"
#include "mass.h"
#include "scene.h"

/* Gives a body the mass of its law. If the law fails at t, the mass is NaN, the scene receives the status of the law,
   and the integrator refuses the step. */
VM_API void vmi_apply_mass_of_time(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_mass_law_values now = {0, 0, 0, 0};
    const int status = vmi_law_at((const vm_law *)e->ctx, VM_BAD_MASS, t, &now.mass, &now.by_t);
    if (status) s->status = status;
    if (status) e->load->mass = VM_NAN;
    else vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* Returns VM_OK if a constructor made the law, else VM_BAD_ARGUMENT. vm_scene_check calls this function before it
   checks the parameters. If both the law and a parameter are wrong, the status is therefore VM_BAD_ARGUMENT and not
   VM_NOT_FINITE. */
VM_API int vmi_check_mass_of_time(const vm_scene *s, const vm_effect *e)
{
    (void)s;
    if (!((const vm_law *)e->ctx)->derivatives) return VM_BAD_ARGUMENT;
    return VM_OK;
}

/* A mass that follows a vm_law, with its reactive force. The mass is the value of *law at the time t of the scene; the
   mass that the constructor of the body received is not used, but it must be positive. The velocity of the mass that
   joins or leaves is u + (1 - reactive) v, where v is the velocity of the body: u is absolute if reactive is 1, and
   relative to the body if reactive is 0. *law is not copied and must stay at its place in memory. vm_scene_start
   returns VM_BAD_ARGUMENT if law is NULL or no constructor made *law. A run ends with VM_BAD_MASS if the mass is not
   positive, and with the status of vm_law_at if this function fails. */
VM_API vm_effect vm_effect_mass_of_time(int body, const vm_law *law, vm_vec3 u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_mass_of_time);
    if (!law) e.apply = NULL; /* vm_scene_check then refuses the effect */
    e.p[VMI_MASS_U] = u.x;
    e.p[VMI_MASS_U + 1] = u.y;
    e.p[VMI_MASS_U + 2] = u.z;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.order = VMI_ORDER_MASS_LAW;
    e.check_in_scene = vmi_check_mass_of_time;
    e.ctx = (void *)law;
    return e;
}

#endif
