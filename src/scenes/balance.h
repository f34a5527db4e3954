/* scenes/balance.h - the budget of momentum, angular momentum and energy of a scene

   A scene that keeps a budget integrates what is supplied to its bodies from outside: the impulse and the work of the
   effects, and the momentum and energy that streams bring. It integrates this supply together with the motion of the
   bodies. At any time the momentum and energy of the bodies must equal their values at the start plus this supply. The
   difference is called the defect. It shows the errors of the run. It also contains the reactions of constraints,
   which hold a body on its line, on its axle or in the plane.

       vm_real t = 0, y[2 + VM_BUDGET_STATES], work[VM_SCENE_WORK(2 + VM_BUDGET_STATES)];
       vm_budget budget, now;
       int status;
       vm_scene_keep_budget(&scene, &budget); // scene is a vm_scene, not yet started
       status = vm_scene_start(&scene, t, y, NULL);
       if (status == VM_OK) status = vm_scene_run(&scene, &t, 10, y, work, NULL);
       if (status >= 0) vm_scene_budget_at(&scene, t, y, &now); // now.momentum_defect, now.energy_defect

   Tests: tests/test_scene_runs.c, tests/test_scene_streams.c. */
#ifndef VARMASS_SCENES_BALANCE_H
#define VARMASS_SCENES_BALANCE_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/attitude.h"
#include "../mechanics/bodies.h"
#include "../mechanics/vectors.h"
#include "evaluate.h"
#include "motions.h"
#include "scene.h"
#include "start.h"
#include "state.h"

/* The budget adds VM_BUDGET_STATES numbers to the end of the state. Each of them is a sum over the time of the run so
   far. This list gives the index of each sum among the numbers of the budget; a vector has three numbers. vm_budget in
   scene.h explains each sum. */
enum {
    VMI_BUDGET_IMPULSE = 0,
    VMI_BUDGET_ANGULAR_IMPULSE = 3,
    VMI_BUDGET_BROUGHT = 6,
    VMI_BUDGET_BROUGHT_ANGULAR = 9,
    VMI_BUDGET_WORK = 12,
    VMI_BUDGET_BROUGHT_ENERGY = 13,
    VMI_BUDGET_MIXING = 14
};

VM_INLINE void vmi_add3(vm_vec3 a, vm_real *sum)
{
    sum[0] += a.x;
    sum[1] += a.y;
    sum[2] += a.z;
}

/* Adds the contribution of a body's load to the rates of the budget's sums: force, moment and power of the effects,
   and the momentum, angular momentum and energy that streams bring per second. The force, moment and power of the
   effects do not include reactive forces, because the momentum of the streams accounts for these forces. */
VM_API void vmi_scene_enter_loads(const vm_scene_body *b, const vm_real *y, vm_real *rates)
{
    const vm_load *load = &b->load;
    const vm_real *state = y + b->at;
    const vm_vec3 r = vmi_scene_moving(b, state), v = vmi_scene_moving(b, state + b->positions);
    const vm_vec3 force = vm_sub(vmi_scene_moving(b, load->force), vmi_scene_moving(b, load->reactive));
    const vm_vec3 torque = vm_sub(vmi_scene_turning(b, load->force), vmi_scene_turning(b, load->reactive));
    const vm_vec3 brought = vmi_scene_moving(b, load->brought), turning = vmi_scene_turning(b, load->brought);
    vmi_add3(force, rates + VMI_BUDGET_IMPULSE);
    vmi_add3(vm_add(torque, vm_cross(r, force)), rates + VMI_BUDGET_ANGULAR_IMPULSE);
    vmi_add3(brought, rates + VMI_BUDGET_BROUGHT);
    vmi_add3(vm_add(turning, vm_cross(r, brought)), rates + VMI_BUDGET_BROUGHT_ANGULAR);
    rates[VMI_BUDGET_WORK] += vm_dot(force, v) + vm_dot(torque, vmi_scene_spin(b, y));
    rates[VMI_BUDGET_BROUGHT_ENERGY] += load->brought_energy;
    rates[VMI_BUDGET_MIXING] += load->mixing;
}

/* Adds to the rates of the budget's sums the loads on a body and what streams bring to it. If the body has a mass law
   M(v), where v is the velocity, its mass also changes by dM/dv v' per second. The momentum and energy of this mass
   are added here and not by the effect, because the acceleration v' is known only after all effects have added their
   forces. */
VM_API void vmi_scene_enter(vm_scene_body *b, const vm_real *y, vm_real *rates)
{
    vm_load *load = &b->load;
    if (load->mass_by_v != 0) {
        const vm_real mass_rate = load->mass_by_v * (load->force[0] / (load->mass + load->extra_mass));
        const vm_real faster = load->joining_v - y[b->at + 1];
        load->brought[0] += mass_rate * load->joining_v;
        load->brought_energy += mass_rate * load->joining_v * load->joining_v / 2;
        load->mixing += mass_rate * faster * faster / 2;
    }
    vmi_scene_enter_loads(b, y, rates);
}

/* Computes the rates of the budget's sums. The loads on the bodies in the state y must have been computed before. */
VM_API void vmi_scene_rates(vm_scene *s, const vm_real *y, vm_real *rates)
{
    int i;
    for (i = 0; i < VM_BUDGET_STATES; i++) rates[i] = 0;
    for (i = 0; i < s->n_bodies; i++)
        if (!s->bodies[i].away) vmi_scene_enter(s->bodies + i, y, rates);
}

/* Momentum, angular momentum about the origin and kinetic energy of all bodies that are present. A body on an axle has
   a moment of inertia in place of the mass, and no momentum. */
VM_API void vmi_scene_totals(const vm_scene *s, const vm_real *y, vm_budget *budget)
{
    const vm_vec3 zero = {0, 0, 0};
    int i;
    budget->momentum = budget->angular_momentum = zero;
    budget->energy = 0;
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        vm_body now;
        vm_vec3 p, spin;
        if (b->away) continue;
        vmi_scene_body_now(s, i, y, &now);
        if (b->motion == VM_AXLE) now.mass = 0;
        p = vm_scale(now.mass, now.v);
        spin = vmi_spin_momentum(&now);
        budget->momentum = vm_add(budget->momentum, p);
        budget->angular_momentum = vm_add(budget->angular_momentum, vm_add(spin, vm_cross(now.r, p)));
        budget->energy += (vm_dot(p, now.v) + vm_dot(spin, now.omega)) / 2;
    }
}

/* Begins the budget at the start of the scene: stores the momentum and energy of the bodies, and sets the sums to 0 */
VM_API void vmi_scene_open_budget(vm_scene *s, const vm_real *y, vm_real *sums)
{
    const vm_budget functions = *s->budget;
    int i;
    memset(s->budget, 0, sizeof *s->budget);
    s->budget->open = functions.open;
    s->budget->rates = functions.rates;
    s->budget->totals = functions.totals;
    vmi_scene_totals(s, y, s->budget);
    for (i = 0; i < VM_BUDGET_STATES; i++) sums[i] = 0;
}

/* Makes a scene keep a budget of momentum, angular momentum and energy. If budget_or_NULL is NULL, the scene keeps no
   budget. Call this function before vm_scene_start. The state then has VM_BUDGET_STATES further numbers.
   *budget_or_NULL must stay at its place in memory; the scene stores its momentum and energy at the start there.
   Between two runs you may end a budget (with NULL), but not begin one. */
VM_API void vm_scene_keep_budget(vm_scene *scene, vm_budget *budget_or_NULL)
{
    if (!scene) return;
    scene->budget = budget_or_NULL;
    if (!budget_or_NULL) return;
    memset(budget_or_NULL, 0, sizeof *budget_or_NULL);
    budget_or_NULL->open = vmi_scene_open_budget;
    budget_or_NULL->rates = vmi_scene_rates;
    budget_or_NULL->totals = vmi_scene_totals;
}

/* Computes the budget of a scene in the state y at time t: the momentum and energy of the bodies, the supply from
   outside since the start, and the defects. Defects come from rounding, from the errors of the integrator, and from
   constraints: a line, an axle and the plane hold a body by reactions, which the supply does not include. Returns
   VM_BAD_ARGUMENT if the scene keeps no budget, `budget` is the struct given to vm_scene_keep_budget (which holds the
   values at the start), a pointer is NULL or a count is negative; VM_NOT_STARTED if the scene was not started;
   VM_NOT_FINITE if the state or a mass that a law gives is not finite; the status of a vm_law that fails; and else
   VM_OK. */
VM_API int vm_scene_budget_at(vm_scene *scene, vm_real t, const vm_real *y, vm_budget *budget)
{
    const vm_budget *start = scene ? scene->budget : NULL;
    const vm_real *sums;
    vm_budget b;
    int status;
    if (!start || !y || !budget || budget == start) return VM_BAD_ARGUMENT;
    if (!vmi_scene_has_lists(scene) || scene->n_events < 0) return VM_BAD_ARGUMENT;
    if (!vmi_scene_is_started(scene)) return VM_NOT_STARTED;
    if (!vmi_all_finite(vm_scene_size(scene), y)) return VM_NOT_FINITE;
    b = *start;
    sums = y + vm_scene_size(scene) - VM_BUDGET_STATES;
    status = vmi_scene_weigh(scene, t, y);
    if (status) return status;
    vmi_scene_totals(scene, y, &b);
    b.impulse = vm_add(start->impulse, vmi_get3(sums + VMI_BUDGET_IMPULSE));
    b.angular_impulse = vm_add(start->angular_impulse, vmi_get3(sums + VMI_BUDGET_ANGULAR_IMPULSE));
    b.brought = vmi_get3(sums + VMI_BUDGET_BROUGHT);
    b.brought_angular = vmi_get3(sums + VMI_BUDGET_BROUGHT_ANGULAR);
    b.work = sums[VMI_BUDGET_WORK];
    b.brought_energy = sums[VMI_BUDGET_BROUGHT_ENERGY];
    b.mixing = sums[VMI_BUDGET_MIXING];
    b.momentum_defect = vm_sub(vm_sub(b.momentum, start->momentum), vm_add(b.impulse, b.brought));
    b.angular_defect = vm_sub(vm_sub(b.angular_momentum, start->angular_momentum),
                               vm_add(b.angular_impulse, b.brought_angular));
    b.energy_defect = b.energy - start->energy - (b.work + b.brought_energy - b.mixing + b.jump_energy);
    *budget = b;
    return VM_OK;
}

#endif
