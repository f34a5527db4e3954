/* scenes/balance.h - the book of momentum, angular momentum and energy */
#ifndef VARMASS_SCENES_BALANCE_H
#define VARMASS_SCENES_BALANCE_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/bodies.h"
#include "../mechanics/vectors.h"
#include "evaluate.h"
#include "motions.h"
#include "scene.h"
#include "start.h"
#include "state.h"

VM_INLINE void vmi_add3(vm_vec3 a, vm_real *d) {
d[0] += a.x;
d[1] += a.y;
d[2] += a.z; }

/* What a body's load adds to the book by the second: impulse, angular impulse, momentum and angular momentum brought,
   work, energy brought, mixing */
VM_API void vmi_scene_enter_loads(const vm_scene_body *b, const vm_real *y, vm_real *d)
{
    const vm_load *load = &b->load;
    const vm_vec3 at = vmi_scene_moving(b, y + b->at);
    const vm_vec3 force = vmi_sub(vmi_scene_moving(b, load->force), vmi_scene_moving(b, load->reactive));
    const vm_vec3 torque = vmi_sub(vmi_scene_turning(b, load->force), vmi_scene_turning(b, load->reactive));
    const vm_vec3 brought = vmi_scene_moving(b, load->brought);
    vmi_add3(force, d);
    vmi_add3(vmi_add(torque, vmi_cross(at, force)), d + 3);
    vmi_add3(brought, d + 6);
    vmi_add3(vmi_add(vmi_scene_turning(b, load->brought), vmi_cross(at, brought)), d + 9);
    d[12] += vmi_dot(force, vmi_scene_moving(b, y + b->at + b->positions)) + vmi_dot(torque, vmi_scene_spin(b, y));
    d[13] += load->brought_energy;
    d[14] += load->mixing;
}

VM_API void vmi_scene_enter(vm_scene_body *b, const vm_real *y, vm_real *d)
{
    vm_load *load = &b->load;
    if (load->by_v != 0) { /* M'(v) v' is known only now */
        const vm_real rate = load->by_v * (load->force[0] / (load->mass + load->extra));
        const vm_real faster = load->own - y[b->at + 1];
        load->brought[0] += rate * load->own;
        load->brought_energy += rate * load->own * load->own / 2;
        load->mixing += rate * faster * faster / 2;
    }
    vmi_scene_enter_loads(b, y, d);
}

VM_API void vmi_scene_rates(vm_scene *s, const vm_real *y, vm_real *rates)
{
    int i;
    for (i = 0; i < VM_BUDGET; i++) rates[i] = 0;
    for (i = 0; i < s->n_bodies; i++)
        if (!s->bodies[i].away) vmi_scene_enter(s->bodies + i, y, rates);
}

/* Momentum, angular momentum about the origin and kinetic energy of all bodies that are there */
VM_API void vmi_scene_totals(const vm_scene *s, const vm_real *y, vm_budget *book)
{
    const vm_vec3 zero = {0, 0, 0};
    int i;
    book->momentum = book->angular_momentum = zero;
    book->energy = 0;
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        vm_body now;
        vm_vec3 p, spin;
        if (b->away) continue;
        vmi_scene_body_now(s, i, y, &now);
        if (b->motion == VM_AXLE) now.mass = 0;
        p = vmi_scale(now.mass, now.v);
        spin = vmi_spin_momentum(&now);
        book->momentum = vmi_add(book->momentum, p);
        book->angular_momentum = vmi_add(book->angular_momentum, vmi_add(spin, vmi_cross(now.r, p)));
        book->energy += (vmi_dot(p, now.v) + vmi_dot(spin, now.omega)) / 2;
    }
}

VM_API void vmi_scene_open_book(vm_scene *s, const vm_real *y, vm_real *sums)
{
    const vm_budget hooks = *s->book;
    int i;
    memset(s->book, 0, sizeof *s->book);
    s->book->open = hooks.open;
    s->book->rates = hooks.rates;
    s->book->totals = hooks.totals;
    vmi_scene_totals(s, y, s->book);
    for (i = 0; i < VM_BUDGET; i++) sums[i] = 0;
}

/* Before vm_scene_start: the scene keeps book of momentum, angular momentum and energy, in VM_BUDGET more numbers of
   the state; NULL: no longer */
VM_API void vm_scene_keep_budget(vm_scene *scene, vm_budget *book)
{
    if (!scene) return;
    scene->book = book;
    if (!book) return;
    memset(book, 0, sizeof *book);
    book->open = vmi_scene_open_book;
    book->rates = vmi_scene_rates;
    book->totals = vmi_scene_totals;
}

/* Momentum, angular momentum and energy in state y, what came in since the start, and the defects: what rounding and
   the integrator's errors leave, and what a constraint takes (a line, an axle, the plane hold their bodies).
   VM_BAD_ARGUMENT where there is no book. */
VM_API int vm_scene_budget_at(vm_scene *scene, vm_real t, const vm_real *y, vm_budget *book)
{
    const vm_budget *start = scene ? scene->book : NULL;
    const vm_real *d;
    vm_budget b;
    if (!start || !y || !book) return VM_BAD_ARGUMENT;
    if (!vmi_scene_is_started(scene)) return VM_NOT_STARTED;
    b = *start;
    d = y + vm_scene_size(scene) - VM_BUDGET;
    vmi_scene_evaluate(scene, t, y);
    vmi_scene_totals(scene, y, &b);
    b.impulse = vmi_add(start->impulse, vmi_vec3(d[0], d[1], d[2]));
    b.angular_impulse = vmi_add(start->angular_impulse, vmi_vec3(d[3], d[4], d[5]));
    b.brought = vmi_vec3(d[6], d[7], d[8]);
    b.brought_angular = vmi_vec3(d[9], d[10], d[11]);
    b.work = d[12];
    b.brought_energy = d[13];
    b.mixing = d[14];
    b.momentum_defect = vmi_sub(vmi_sub(b.momentum, start->momentum), vmi_add(b.impulse, b.brought));
    b.angular_defect = vmi_sub(vmi_sub(b.angular_momentum, start->angular_momentum),
                               vmi_add(b.angular_impulse, b.brought_angular));
    b.energy_defect = b.energy - start->energy - (b.work + b.brought_energy - b.mixing + b.jump_energy);
    *book = b;
    return VM_OK;
}

#endif
