#include "varmass.h"

/* The weight of a pendulum on axle 0, of the length 0.5 m. y[e->x] and y[e->v] are its angle and angular velocity,
   e->load->mass is its moment of inertia now. */
static void weight(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_real length = 0.5, mass = e->load->mass / (length * length);
    (void)t;
    (void)scene;
    e->load->force[0] -= mass * 9.81 * length * sin(y[e->x]);
}

/* A stop on which the pendulum rests until it is lifted. e->load->force is what the effects before this one gave. */
static void rest(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)t;
    (void)scene;
    if (y[e->x] <= 0 && e->load->force[0] < 0) e->load->force[0] = 0;
}

void list_effects(vm_effect *effects)
{
    effects[0] = vm_effect_callback(0, VM_GROUND, weight, NULL);
    effects[1] = vm_effect_callback(0, VM_GROUND, rest, NULL);
}
