/* A satellite throws off a panel. A satellite turns about the axis whose moment of inertia is neither the largest nor the
   smallest. This rotation is unstable: the satellite tumbles again and again. At t = 250 s a spring pushes off a panel; the
   equations (15), (24) and (34) give the angular velocity just after the separation. Without the panel, the moment of inertia
   about the same axis is the largest, and the satellite only wobbles. Apart from the separation no torque acts on the satellite.
   Therefore vm_torque_free_attitude computes the attitude and the angular velocity at any time without integration.

   cc -O2 10_satellite.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"
/* Converts the vector a from body axes to inertial axes: q a q* with |q| = 1 */
static vm_vec3 turned(vm_quat q, vm_vec3 a)
{
    const double x = 2 * (q.y * a.z - q.z * a.y), y = 2 * (q.z * a.x - q.x * a.z), z = 2 * (q.x * a.y - q.y * a.x);
    const vm_vec3 b = {a.x + q.w * x + q.y * z - q.z * y, a.y + q.w * y + q.z * x - q.x * z,
                       a.z + q.w * z + q.x * y - q.y * x};
    return b;
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_body satellite = {500, {120, 150, 180, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.01, 0.3, 0.02}};
    vm_body now = satellite, panel, rest = satellite;
    vm_torque_free before, after;
    vm_vec3 offset = {0, 1.4, 0}, push = {0.2, 0.5, 0}, omega;
    const vm_inertia light = {2, 0.5, 2.4, 0, 0, 0};
    vm_quat q;
    double t, jump = 250;
    int status = vm_torque_free_init(&before, &satellite, 0);

    if (status >= 0) status = vm_torque_free_at(&before, jump, &now);
    /* the panel sits on the satellite's y axis, and leaves with a push against the place where it sat, unturned */
    panel = now;
    panel.mass = 25;
    panel.inertia = light;
    offset = turned(now.q, offset);
    panel.v = turned(now.q, push);
    panel.r.x += offset.x;
    panel.r.y += offset.y;
    panel.r.z += offset.z;
    panel.omega.x = panel.omega.y = panel.omega.z = 0;
    vm_to_absolute(&now, &panel, &panel);
    if (status >= 0) status = vm_separate(&now, &panel, NULL, &rest);
    if (status >= 0) status = vm_torque_free_init(&after, &rest, jump);
    if (status < 0) {
        printf("%s\n", vm_strerror(status));
        return 1;
    }
    printf("%g kg leave: angular velocity (%.6f, %.6f, %.6f) -> (%.6f, %.6f, %.6f) rad/s\n", panel.mass,
           now.omega.x, now.omega.y, now.omega.z, rest.omega.x, rest.omega.y, rest.omega.z);
    printf("the spring gave %.6f J\n", vm_energy_gain(&now, 1, &panel, NULL, &rest));
    if (csv) fprintf(csv, "t (s),\"omega x (rad/s in body axes)\",\"omega y\",\"omega z\"\n");
    for (t = 0; t <= 600; t += 0.5) {
        status = vm_torque_free_attitude(t < jump ? &before : &after, t, &q, &omega);
        if (csv) fprintf(csv, "%g,%.9f,%.9f,%.9f\n", t, omega.x, omega.y, omega.z);
    }
    if (csv) fclose(csv);
    return status < 0;
}
