/* A hopper fills a bag by its own scale. A hopper (a funnel) with 500 kg of grain hangs on a spring, which serves as its scale.
   The grain flows into a bag through two gates, a coarse one and a fine one. When the scale shows that 45 kg of grain have left,
   the coarse gate shuts. When the scale shows that 50 kg have left, the fine gate shuts, too, and the computation ends. The grain
   leaves with the velocity of the hopper, so that no reactive force acts on the hopper (equation (166)). But the hopper becomes
   lighter and swings on its spring. Therefore the mass that the scale shows is not exactly the true mass, and the bag does not
   get exactly 50 kg. Of the three fine gates in the output, the gate with the largest flow makes the largest error.

   cc -O2 15_hopper.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

static const double stiffness = 2e5, g = 9.81; /* N/m, m/s^2 */

static vm_real scale(vm_real t, const vm_real *y, void *ctx) /* kg, less the weight at which a gate shuts */
{
    (void)t;
    return stiffness * y[0] / g - *(const vm_real *)ctx;
}

int main(int argc, char **argv)
{
    enum { COARSE, FINE, SPRING, DAMPER, WEIGHT, EFFECTS };
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_vec3 zero = {0, 0, 0};
    vm_real coarse_shuts = 455, fine_shuts = 450, fine, t, next, y[3], work[VM_SCENE_WORK(3)];
    int status = 0;
    if (csv) fprintf(csv, "t (s),\"in the bag (kg)\",\"by the scale (kg)\"\n");
    for (fine = 8; fine > 1; fine /= 2) {
        vm_scene_body bodies[] = {vm_scene_body_with_mass_state(vm_scene_body_line(500, 500 * g / stiffness, 0))};
        vm_effect effects[] = {vm_effect_stream(0, -20, zero, 0), vm_effect_stream(0, -fine, zero, 0),
                               vm_effect_linear_spring(0, 0, VM_GROUND, 0, stiffness, 0),
                               vm_effect_damper(0, 0, VM_GROUND, 0, 1000), vm_effect_gravity(0, 0, g)}; /* x: downwards */
        vm_event full = vm_event_user(scale, &fine_shuts, -1), shut[2], events[2];
        ode_event located[2];
        static vm_scene scene; /* fields that are not set are 0 */
        shut[0] = vm_then_switch(full, FINE, 1);
        shut[1] = vm_then_stop(full);
        events[0] = vm_then_switch(vm_event_user(scale, &coarse_shuts, -1), COARSE, 1);
        events[1] = vm_then_all(full, shut, 2);
        scene.bodies = bodies;
        scene.n_bodies = 1;
        scene.effects = effects;
        scene.n_effects = EFFECTS;
        scene.events = events;
        scene.located = located;
        scene.n_events = 2;
        t = 0;
        status = vm_scene_start(&scene, t, y, NULL);
        for (next = 0; status == VM_OK; next += 0.01) {
            status = vm_scene_run(&scene, &t, next, y, work, NULL);
            if (csv && fine < 4) fprintf(csv, "%.3f,%.6f,%.6f\n", t, 500 - y[2], 500 - stiffness * y[0] / g);
        }
        printf("fine gate %g kg/s: full after %.3f s, %.4f kg in the bag, %+.1f g\n", fine, t, 500 - y[2],
               1000 * (450 - y[2]));
    }
    if (csv) fclose(csv);
    return status < 0;
}
