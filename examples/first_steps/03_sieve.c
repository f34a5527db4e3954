/* A vibrating sieve that is being loaded. The program of this section describes a machine as a scene: a list of bodies, a list of
   effects that act on the bodies (such as a spring), and a list of events that change the scene. A motor shakes a sieve of 20 kg,
   held by a spring and a damper, with a force of up to 60 N. From t = 4 s on, 2 kg of gravel per second fall straight down into
   the sieve, until it holds 20 kg of gravel; the equation of motion is (175). As the mass grows, the natural frequency falls.
   When it passes the frequency of the motor, there is resonance. The vibration needs time to grow, and is widest about 2 s later.

   cc -O2 03_sieve.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"
int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    enum { SIEVE };                          /* the body */
    enum { SPRING, DAMPER, MOTOR, GRAVEL }; /* the effects */
    const vm_vec3 at_rest = {0, 0, 0};
    vm_scene_body bodies[] = {vm_scene_body_with_mass_state(vm_scene_body_line(20, 0, 0))};
    vm_effect effects[4];
    vm_event events[] = {vm_then_switch(vm_event_at(4), GRAVEL, 0),
                         vm_then_switch(vm_event_mass(SIEVE, 40, 1), GRAVEL, 1)};
    ode_event located[2];
    vm_scene scene;
    vm_scene_fault culprit;
    vm_real t = 0, y[3], work[VM_SCENE_WORK(3)], next, widest = 0, when = 0; /* y: x, v, mass */
    int status;

    effects[SPRING] = vm_effect_linear_spring(SIEVE, 0, VM_GROUND, 0, 8000, 0);
    effects[DAMPER] = vm_effect_damper(SIEVE, 0, VM_GROUND, 0, 30);
    effects[MOTOR] = vm_effect_harmonic(SIEVE, 0, 60, 17, 0);
    effects[GRAVEL] = vm_effect_stream(SIEVE, 2, at_rest, 1);
    effects[GRAVEL].off = 1; /* until the first event switches it on */
    memset(&scene, 0, sizeof scene);
    scene.bodies = bodies;
    scene.n_bodies = 1;
    scene.effects = effects;
    scene.n_effects = 4;
    scene.events = events;
    scene.n_events = 2;
    scene.located = located;
    status = vm_scene_start(&scene, t, y, &culprit);
    if (status < 0) {
        printf("%s %d: %s\n", culprit.kind, culprit.index, vm_strerror(status));
        return 1;
    }
    if (csv) fprintf(csv, "t (s),\"x (mm)\",\"mass (kg)\"\n");
    for (next = 0.01; next <= 20 && status >= 0; next += 0.01) {
        status = vm_scene_run(&scene, &t, next, y, work, NULL);
        if (fabs(y[0]) > widest) {
            widest = fabs(y[0]);
            when = t;
        }
        if (csv) fprintf(csv, "%.2f,%.6f,%.4f\n", t, 1000 * y[0], y[2]);
    }
    printf("widest at t = %.2f s: %.2f mm; the gravel stops at t = %.6f s with %.6f kg in all\n", when,
           1000 * widest, events[1].time, y[2]);
    printf("sqrt(k/m) is the motor's 17 rad/s at m = %.2f kg, which is there at t = %.2f s\n", 8000 / (17. * 17),
           4 + (8000 / (17. * 17) - 20) / 2);
    if (csv) fclose(csv);
    return status < 0;
}
