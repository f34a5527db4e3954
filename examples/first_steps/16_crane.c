/* A crane draws in its load. A crane with a load on a rope travels at 0.05 m/s and stops at t = 0. Then the load of m = 200 kg
   swings; phi is the angle of the rope, and L is the length of the rope, at first 20 m. While the load swings, the crane shortens
   the rope by 0.25 m each second. The program treats the load as a body that turns about the upper end of the rope and has the
   moment of inertia m L(t)^2. The equation of motion is (m L^2 phi')' = -m g L sin phi; this is equation (170) with the moment of
   inertia in place of the mass. While the rope slowly becomes shorter, the largest angle of a swing grows in proportion to
   L^(-3/4). For small angles sin phi is nearly phi; then a formula with Bessel functions gives the motion (Lorentz's pendulum).

   cc -O2 16_crane.c -lm && ./a.out [file.csv] */
#include <math.h>
#include <stdio.h>
#include "../../varmass.h"

static const double m = 200, g = 9.81, length = 20, speed = 0.25; /* kg, m/s^2, m, m/s */

static vm_real weight(vm_real t, vm_real phi, vm_real omega, void *sine_or_NULL)
{
    (void)omega;
    return -m * g * (length - speed * t) * (sine_or_NULL ? sin(phi) : phi);
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_vec3 zero = {0, 0, 0};
    const vm_law inertia = vm_law_quadratic(m * length * length, -2 * m * length * speed, m * speed * speed);
    vm_scene_body bodies[] = {vm_scene_body_axle(1, 0, 0.05 / length), vm_scene_body_axle(1, 0, 0.05 / length)};
    int sine = 1, status;
    vm_effect effects[] = {vm_effect_mass_of_time(0, &inertia, zero, 1), vm_effect_mass_of_time(1, &inertia, zero, 1),
                           vm_effect_force(0, 0, weight, &sine), vm_effect_force(1, 0, weight, NULL)};
    vm_event events[] = {vm_then_stop(vm_event_velocity(0, 0, 0, -1))}; /* where a swing to one side ends */
    vm_real y[4], work[VM_SCENE_WORK(4)], t = 0, next = 0, now = length, law = 0;
    ode_event located[1];
    static vm_scene scene; /* fields that are not set are 0 */
    rk45_options options = rk45_defaults(NULL);
    options.rtol = 1e-11;
    options.atol = 1e-14;
    scene.bodies = bodies;
    scene.n_bodies = 2;
    scene.effects = effects;
    scene.n_effects = 4;
    scene.events = events;
    scene.located = located;
    scene.n_events = 1;
    status = vm_scene_start(&scene, t, y, NULL);
    if (csv) fprintf(csv, "t (s),\"angle (mrad)\",\"path of the load (cm)\"\n");
    while (status >= VM_OK && t < 70) {
        status = vm_scene_run(&scene, &t, next, y, work, &options);
        now = length - speed * t;
        if (events[0].count == 1 && law == 0) law = y[0] * pow(now, 0.75);
        if (status == VM_STOPPED && events[0].count % 3 == 1)
            printf("a swing ends at %9.6f s: rope %.4f m, angle %.6f rad (by L^(-3/4): %.6f)\n", t, now, y[0],
                   law * pow(now, -0.75));
        if (csv) fprintf(csv, "%g,%.6f,%.6f\n", t, 1000 * y[0], 100 * now * y[0]);
        if (status == VM_OK) next += 0.125;
    }
    printf("at %g s: %.9f rad; for small angles %.9f rad (by Bessel functions -0.002976876)\n", t, y[0], y[2]);
    if (csv) fclose(csv);
    return status < 0;
}
