/* scenes/evaluate.h - the right-hand side of a scene */
#ifndef VARMASS_SCENES_EVALUATE_H
#define VARMASS_SCENES_EVALUATE_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "scene.h"
#include "state.h"

/* Before the effects of an evaluation */
VM_INLINE void vmi_scene_clear(vm_scene_body *b, const vm_real *y, int book)
{
    vm_load *load = &b->load;
    load->force[0] = 0;
    if (b->coordinates > 1) load->force[1] = load->force[2] = 0;
    if (b->coordinates > 3) load->force[3] = load->force[4] = load->force[5] = 0;
    load->mass = b->mass_is_state ? y[b->mass_at] : b->mass;
    load->extra = load->by_v = load->mass_rate = 0;
    if (b->begin) b->begin(b, y + b->at);
    if (book) {
        memset(load->reactive, 0, sizeof load->reactive);
        memset(load->brought, 0, sizeof load->brought);
        load->brought_energy = load->mixing = 0;
    }
}

/* What acts on each body now */
VM_INLINE void vmi_scene_evaluate(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) vmi_scene_clear(s->bodies + i, y, s->book != NULL);
    for (i = 0; i < s->n_effects; i++) {
        const vm_effect *e = s->effects + i;
        if (!e->idle) e->apply(e, t, y, s);
    }
}

/* Why a body with this load cannot be accelerated */
VM_API int vmi_scene_mass_status(const vm_load *load)
{
    if (!VM_IS_FINITE(load->mass) || !VM_IS_FINITE(load->extra)) return VM_NOT_FINITE;
    return load->mass > 0 ? VM_NO_EFFECTIVE_MASS : VM_BAD_MASS;
}

VM_INLINE int vmi_scene_accelerate(const vm_scene_body *b, const vm_real *y, vm_real *dydt)
{
    const vm_load *load = &b->load;
    const vm_real effective = load->mass + load->extra;
    if (!(load->mass > 0 && effective > 0 && effective <= VM_MAX)) return vmi_scene_mass_status(load);
    if (b->mass_is_state) {
        if (!(y[b->mass_at] > 0)) return VM_BAD_MASS; /* whatever an effect has added to it */
        dydt[b->mass_at] = load->mass_rate;
    }
    return b->accelerate(b, y + b->at, dydt + b->at);
}

/* An ode_rhs; ctx is the scene, which has been started. Returns 0; where a mass is not positive or a body cannot be
   accelerated a derivative is NaN and scene.status says why, so that an integrator tries a shorter step. */
VM_API int vm_scene_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_scene *s = (vm_scene *)ctx;
    int i, before;
    if (!s || !y || !dydt) return VM_BAD_ARGUMENT;
    before = s->status;
    s->status = VM_OK;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        int k;
        if (b->away) {
            for (k = 0; k < vmi_scene_body_size(b); k++) dydt[b->at + k] = 0;
            continue;
        }
        k = vmi_scene_accelerate(b, y, dydt);
        if (k && !s->status) s->status = k;
    }
    if (s->book) s->book->rates(s, y, dydt + vm_scene_size(s) - VM_BUDGET);
    if (s->status) {
        dydt[0] = VM_NAN; /* the integrator tries a shorter step */
        if (before) s->status = before; /* of several in a row the first: the others follow from its NaN */
    }
    return 0;
}

#endif
