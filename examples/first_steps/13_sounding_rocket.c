/* A sounding rocket in two stages. Two motors, one after the other, drive a rocket straight up. At its highest point, the apogee,
   the rocket opens a parachute. The function drag computes the force of the air, whose density falls to 37 % every 8 km upwards.

   cc -O2 13_sounding_rocket.c -lm && ./a.out [file.csv] */
#include <math.h>
#include <stdio.h>
#include "../../varmass.h"

static void drag(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_real height = y[e->x], v = y[e->v], area = *(const vm_real *)e->ctx; /* times the drag coefficient */
    (void)t;
    (void)scene;
    e->load->force[0] -= 1.225 * exp(-height / 8000) / 2 * area * v * fabs(v);
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    enum { ROCKET, BOOSTER };                                          /* the bodies */
    enum { MOTOR_1, MOTOR_2, PARACHUTE, DRAG, WEIGHT, EFFECTS };       /* the effects */
    enum { EMPTY, STAGING, IGNITION, BURNT, APOGEE, LANDING, EVENTS }; /* the events */
    const vm_vec3 jet = {-2200, 0, 0};                               /* m/s, relative to the rocket */
    const vm_body stage = {20, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {-5, 0, 0}, {0, 0, 0}}; /* left behind */
    vm_real slim = 0.01, wide = 8, t = 0, y[5], work[VM_SCENE_WORK(5)], next, top = 0; /* y: x, v, mass; x, v */
    vm_scene_body bodies[] = {vm_scene_body_with_mass_state(vm_scene_body_line(150, 0, 0)),
                              vm_scene_body_absent(vm_scene_body_line(20, 0, 0))};
    vm_effect effects[] = {vm_effect_stream(ROCKET, -10, jet, 0), vm_effect_stream(ROCKET, -4, jet, 0), /* 10, 4 kg/s */
                           vm_effect_custom(ROCKET, VM_GROUND, drag, &wide),
                           vm_effect_custom(ROCKET, VM_GROUND, drag, &slim), vm_effect_gravity(ROCKET, 0, -9.81)};
    vm_event events[EVENTS];
    ode_event located[EVENTS];
    static vm_scene scene; /* fields that are not set are 0 */
    effects[MOTOR_2].off = effects[PARACHUTE].off = 1;
    events[EMPTY] = vm_then_switch(vm_event_mass(ROCKET, 70, -1), MOTOR_1, 1);
    events[STAGING] = vm_then_separate_on_line(vm_event_at(8.5), ROCKET, BOOSTER, &stage, 1);
    events[IGNITION] = vm_then_switch(vm_event_at(10), MOTOR_2, 0);
    events[BURNT] = vm_then_switch(vm_event_mass(ROCKET, 20, -1), MOTOR_2, 1);
    events[APOGEE] = vm_then_switch(vm_event_velocity(ROCKET, 0, 0, -1), PARACHUTE, 0);
    events[LANDING] = vm_then_stop(vm_event_position(ROCKET, 0, 0, -1));
    scene.bodies = bodies;
    scene.n_bodies = 2;
    scene.effects = effects;
    scene.n_effects = EFFECTS;
    scene.events = events;
    scene.located = located;
    scene.n_events = EVENTS;
    int status = vm_scene_start(&scene, t, y, NULL);
    if (csv) fprintf(csv, "t (s),\"height (km)\",\"velocity (100 m/s)\",\"mass (kg)\"\n");
    for (next = 1; status == VM_OK; next += 1) {
        status = vm_scene_run(&scene, &t, next, y, work, NULL);
        if (y[0] > top) top = y[0];
        if (csv && t <= 600) fprintf(csv, "%.3f,%.6f,%.6f,%.4f\n", t, y[0] / 1000, y[1] / 100, y[2]);
    }
    printf("burnt out at %.3f s and %.3f s; apogee %.2f km at %.2f s; lands at %.0f s with %.2f m/s\n",
           events[EMPTY].time, events[BURNT].time, top / 1000, events[APOGEE].time, t, y[1]);
    if (csv) fclose(csv);
    return status < 0;
}
