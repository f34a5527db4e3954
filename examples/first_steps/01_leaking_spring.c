/* A spring with a leaking mass. A bucket of sand hangs on a spring, and the sand leaks out. The equation of motion is m
   x'' + k x = 0, with the mass m and the stiffness k. The coordinate x is measured from the position of rest, which
   rises while sand leaks out. The sand leaves with the velocity of the bucket, so that its loss causes no force. As the
   mass falls, the vibration becomes faster and narrower: its amplitude is A = A0 (m/m0)^(1/4), where A0 and m0 are
   amplitude and mass at the start. If the sand were brought to rest before it leaves, its loss would cause a force on
   the bucket, the reactive force. This force would make the vibration wider: A = A0 (m0/m)^(1/4), which is (325) for a
   linear spring (alpha = 1). The function vm_osc_amplitude_law computes A/A0 in both cases. Its third argument is 0
   without the reactive force and 1 with it. In the output, "its law" is this A, and the "route" is the method that
   computed the motion.

   cc -O2 01_leaking_spring.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_osc_problem bucket = {1, vm_law_linear(10, -0.1), vm_law_linear(250, 0), 0, 0, 0.05, 0, NULL, NULL};
    const double end = 70; /* s: then 7 of 10 kg have leaked out */
    vm_osc_motion motion;
    double mass = 0, rate, t;
    int status = VM_OK;

    puts("   t (s)  mass (kg)  amplitude (m)   its law    route that was taken");
    for (t = 0; t <= end && status >= 0; t += 10) {
        status = vm_osc_within(&bucket, t, 1e-6, &motion); /* the cheapest route within an error of 1e-6 */
        vm_law_at(&bucket.mass, t, &mass, &rate);
        printf("%8.0f %10.1f %14.6f %10.6f   %s\n", t, mass, motion.amplitude,
               0.05 * vm_osc_amplitude_law(mass / 10, 0, 0, 1), vm_osc_route_name(motion.route));
    }
    if (csv) fprintf(csv, "t (s),\"x (m)\",\"amplitude\",\"with a reactive force (325)\"\n");
    for (t = 0; csv && t <= end && status >= 0; t += 0.05) {
        status = vm_osc_within(&bucket, t, 1e-3, &motion);
        vm_law_at(&bucket.mass, t, &mass, &rate);
        fprintf(csv, "%g,%.6f,%.6f,%.6f\n", t, motion.x, 0.05 * vm_osc_amplitude_law(mass / 10, 0, 0, 1),
                0.05 * vm_osc_amplitude_law(mass / 10, 0, 1, 1));
    }
    if (csv) fclose(csv);
    if (status < 0) printf("%s\n", vm_strerror(status));
    return status < 0;
}
