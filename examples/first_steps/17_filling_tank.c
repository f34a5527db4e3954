/* A satellite whose tank is filled in orbit. A satellite turns, with a little wobble, about the axis of its tank, into which
   300 kg of liquid flow. The function vm_supply_at computes level, mass centre and inertia of the liquid. The liquid brings no
   angular momentum, so the satellite turns more slowly. In the output, angular momentum "from nowhere" is a numerical error.

   cc -O2 17_filling_tank.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"
static const vm_supply tank = {VM_TANK_OF_LIQUID, {0, 0, 0.2}, {0, 0, 1}, 1.2, 0.4, 0, 300}; /* 1.2 m long, 300 kg */

static void fill(vm_real t, const vm_real *y, vm_stream *line, void *ctx)
{
    vm_supply_left *left = (vm_supply_left *)ctx;
    vm_supply_at(&tank, y[13] - 700, left); /* y[13] is the mass, 700 kg without the liquid */
    line->from = &left->store;
    (void)t;
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_body empty = {700, {300, 310, 250, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.02, 0, 0.5}};
    vm_scene_body bodies[] = {vm_scene_body_growing_free(vm_scene_body_free(&empty))};
    vm_effect (*const make[4])(int, const vm_stream *) = {vm_effect_stream_mass, vm_effect_stream_force,
                                                         vm_effect_stream_moment, vm_effect_stream_torque};
    vm_effect effects[4];
    vm_event full = vm_then_switch_range(vm_event_mass(0, 1000, 1), 0, 4, 1);
    ode_event located;
    static vm_supply_left left;
    vm_real t = 0, next, y[23 + VM_BUDGET_STATES], work[VM_SCENE_WORK(23 + VM_BUDGET_STATES)];
    static vm_stream filler;
    static vm_scene scene; /* fields that are not set are 0 */
    vm_budget budget;
    int i, status;
    filler.rate = 1; /* kg/s */
    filler.motion = VM_AT_REST;
    filler.at.z = 1.5;
    for (i = 0; i < 4; i++) effects[i] = vm_effect_varying(make[i](0, &filler), fill, &left);
    scene.bodies = bodies;
    scene.n_bodies = 1;
    scene.effects = effects;
    scene.n_effects = 4;
    scene.events = &full;
    scene.located = &located;
    scene.n_events = 1;
    vm_scene_keep_budget(&scene, &budget);
    status = vm_scene_start(&scene, t, y, NULL);
    if (csv) fprintf(csv, "t (s),\"omega x (0.1 rad/s)\",\"omega z (rad/s)\",\"level (m)\"\n");
    for (next = 0; next <= 400 && status == VM_OK; next += 1) {
        status = vm_scene_run(&scene, &t, next, y, work, NULL);
        if (csv) fprintf(csv, "%g,%.6f,%.6f,%.6f\n", t, 10 * y[10], y[12], left.size);
    }
    vm_scene_budget_at(&scene, t, y, &budget);
    printf("full at %.6f s: turns with %.6f rad/s, was 0.5; inertia %.3f, %.3f, %.3f kg m^2, mass centre at %.4f m\n",
           full.time, y[12], y[17], y[18], y[19], y[16]);
    printf("angular momentum %.3f N m s, %.1e of it from nowhere\n", vm_norm(budget.angular_momentum),
           vm_norm(budget.angular_defect) / vm_norm(budget.angular_momentum));
    if (csv) fclose(csv);
    return status < 0;
}
