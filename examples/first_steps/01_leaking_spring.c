/* A spring with a leaking mass. A bucket of sand hangs on a spring, and the sand leaks out. The equation of motion is
   m x'' + k x = 0, where m is the mass of the bucket with the sand, k the stiffness of the spring, and x the coordinate of the
   bucket. The coordinate is measured from the position at which the bucket would hang at rest; this position rises while sand
   leaks out. The sand leaves with the velocity of the bucket, so that the loss of sand causes no force. As the mass m falls, the
   vibration becomes faster, and its amplitude A falls as A0 (m/m0)^(1/4), where A0 and m0 are the amplitude and the mass at the
   start. If the sand were brought to rest before it leaves, the loss of sand would cause a force on the bucket, the reactive
   force. With this force the amplitude would grow as A0 (m0/m)^(1/4), which is equation (325) for a linear spring. The function
   vm_osc_amplitude_law computes A/A0 for both cases: its third argument is 0 without the reactive force and 1 with this force. In
   the output, the column "amplitude" is taken from the computed motion, and "its law" is A0 (m/m0)^(1/4). The last column names
   the method that computed the motion, here an approximate formula for the motion, called the law of order three.

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

    puts("   t (s)  mass (kg)  amplitude (m)  its law (m)  route that was taken");
    for (t = 0; t <= end && status >= 0; t += 10) {
        status = vm_osc_within(&bucket, t, 1e-6, &motion); /* the cheapest route within an error of 1e-6 */
        vm_law_at(&bucket.mass, t, &mass, &rate);
        printf("%8.0f %10.1f %14.6f %12.6f  %s\n", t, mass, motion.amplitude,
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
