/* scenes/evaluate.h - the right-hand side of a scene

   The right-hand side gives the derivatives of the state. Each evaluation of the right-hand side sets the loads on all
   bodies to 0, lets each effect add its loads, and computes the acceleration of each body from the loads on it. The
   function vm_scene_rhs has the type ode_rhs, so that any integrator of the kit can integrate a scene without events:

       vm_real work[RK87_WORK(2)]; // 2 = vm_scene_size(&scene)
       rk87 run;
       rk87_init(&run, vm_scene_rhs, &scene, 2, 0, y, NULL, work); // scene and y after vm_scene_start

   Tests: tests/test_scene_effects.c. */
#ifndef VARMASS_SCENES_EVALUATE_H
#define VARMASS_SCENES_EVALUATE_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "scene.h"
#include "state.h"

/* Prepares the load of a body before the effects add to the load: the mass becomes the present mass, and all sums
   become 0. The forces on coordinates that the body does not have are not set. */
VM_INLINE void vmi_scene_clear(vm_scene_body *b, const vm_real *y, int with_budget)
{
    vm_load *load = &b->load;
    load->force[0] = 0;
    if (b->coordinates > 1) load->force[1] = load->force[2] = 0;
    if (b->coordinates > 3) load->force[3] = load->force[4] = load->force[5] = 0;
    load->mass = b->mass_is_state ? y[b->mass_at] : b->mass;
    load->extra_mass = load->mass_by_v = load->mass_rate = 0;
    if (b->begin) b->begin(b, y + b->at);
    if (with_budget) {
        memset(load->reactive, 0, sizeof load->reactive);
        memset(load->brought, 0, sizeof load->brought);
        load->brought_energy = load->mixing = 0;
    }
}

/* Computes the loads of all bodies in the state y */
VM_INLINE void vmi_scene_evaluate(vm_scene *s, vm_real t, const vm_real *y)
{
    const int with_budget = s->budget != NULL;
    int i;
    for (i = 0; i < s->n_bodies; i++) vmi_scene_clear(s->bodies + i, y, with_budget);
    for (i = 0; i < s->n_effects; i++) {
        const vm_effect *e = s->effects + i;
        if (!e->idle) e->apply(e, t, y, s);
    }
}

/* Computes the loads for a function that needs the masses. Returns VM_OK, or an error if the mass of a body that is
   present is not finite. If an effect could not act, the error is the status of this effect, else VM_NOT_FINITE;
   s->status becomes the same error. */
VM_API int vmi_scene_weigh(vm_scene *s, vm_real t, const vm_real *y)
{
    const int before = s->status;
    int i;
    s->status = VM_OK;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        if (s->bodies[i].away || VM_IS_FINITE(s->bodies[i].load.mass)) continue;
        if (!s->status) s->status = VM_NOT_FINITE;
        return s->status;
    }
    s->status = before;
    return VM_OK;
}

/* The status of a load with which the body cannot be accelerated: it says whether a mass is not finite, the mass is
   not positive, or the mass plus extra_mass is not positive */
VMI_APART int vmi_scene_mass_status(const vm_load *load)
{
    if (!VM_IS_FINITE(load->mass + load->extra_mass)) return VM_NOT_FINITE;
    if (load->mass > 0) return VM_NO_EFFECTIVE_MASS;
    return VM_BAD_MASS;
}

/* Writes the derivatives of the state of a body and returns a status. Not only load->mass, but also a mass that is a
   number of the state y must be positive, because an effect may have added to load->mass. */
VM_INLINE int vmi_scene_accelerate(const vm_scene_body *b, const vm_real *y, vm_real *dydt)
{
    const vm_load *load = &b->load;
    const vm_real effective = load->mass + load->extra_mass;
    if (!(load->mass > 0 && effective > 0 && effective <= VM_MAX)) return vmi_scene_mass_status(load);
    if (b->mass_is_state) {
        if (!(y[b->mass_at] > 0)) return VM_BAD_MASS;
        dydt[b->mass_at] = load->mass_rate;
    }
    return b->accelerate(b, y + b->at, dydt + b->at);
}

/* Sets n derivatives to the same value: to 0 for a body that is not present, to NaN after an error */
VMI_APART void vmi_scene_fill(int n, vm_real value, vm_real *dydt)
{
    int k;
    for (k = 0; k < n; k++) dydt[k] = value;
}

/* The right-hand side of a scene as an ode_rhs: writes the derivatives of the state y at time t to dydt. ctx is the
   scene, which must have been started. Returns 0, or VM_BAD_ARGUMENT if a pointer is NULL or the number of bodies or
   effects is negative. If a body cannot be accelerated, for example because its mass is not positive, or if an effect
   cannot act, scene.status is the reason and all derivatives are NaN, so that an integrator tries a shorter step. */
VM_API int vm_scene_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_scene *s = (vm_scene *)ctx;
    int i, before;
    if (!s || !y || !dydt || !vmi_scene_has_lists(s)) return VM_BAD_ARGUMENT;
    before = s->status;
    s->status = VM_OK;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        int status = 0;
        if (b->away) vmi_scene_fill(vmi_scene_body_size(b), 0, dydt + b->at);
        else status = vmi_scene_accelerate(b, y, dydt);
        if (status && !s->status) s->status = status;
    }
    if (s->budget) s->budget->rates(s, y, dydt + vm_scene_size(s) - VM_BUDGET_STATES);
    if (s->status) vmi_scene_fill(vm_scene_size(s), VM_NAN, dydt);
    if (s->status && before) s->status = before;
    return 0;
}

#endif
