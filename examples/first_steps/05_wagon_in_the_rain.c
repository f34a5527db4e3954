/* A wagon in the rain. A wagon rolls along a rail without friction, and rain falls straight down into the wagon. The rain has no
   velocity along the rail, so that the momentum M v of the wagon stays the same. Therefore the velocity v of the wagon falls as
   the mass M grows. In equations (151) and (170), u is the velocity of the mass that joins; along the rail u is 0 for this rain.
   After 60 s the rain stops, and the wagon begins to leak. The water leaves with the velocity of the wagon, so that now the
   velocity v stays the same. The classic mistake is to think that the momentum M v still stays the same while the wagon leaks, so
   that v would grow again. In fact the momentum falls, because the water that leaks out takes its share of the momentum away. In
   the output, "Levi-Civita's form" means the equation (M v)' = 0, which holds while it rains.

   cc -O2 05_wagon_in_the_rain.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_stream1 rain = {10, 0, VM_ABSOLUTE}, leak = {-10, 0, VM_RELATIVE}; /* kg/s, m/s */
    const vm_real m0 = 1000, v0 = 5, end = 60;
    vm_real t, x = 0, v = 0, x_full = 0, v_full = 0, mass;

    vm_linear_flow(&rain, end, 0, v0, m0, 0, &x_full, &v_full); /* closed forms, no integration */
    if (csv) fprintf(csv, "t (s),\"v (m/s)\",\"mass (t)\",\"M v/(M v at first)\",\"the mistake\"\n");
    for (t = 0; t <= 2 * end; t += 0.5) {
        if (t <= end) {
            vm_linear_flow(&rain, t, 0, v0, m0, 0, &x, &v);
            mass = m0 + rain.rate * t;
        } else {
            vm_linear_flow(&leak, t - end, x_full, v_full, m0 + rain.rate * end, 0, &x, &v);
            mass = m0 + rain.rate * end + leak.rate * (t - end);
        }
        if (csv) fprintf(csv, "%g,%.9f,%.4f,%.9f,%.9f\n", t, v, mass / 1000, mass * v / (m0 * v0), m0 * v0 / mass);
        if (t == 0 || t == end || t == 2 * end)
            printf("t = %3g s: mass %4g kg, v = %.6f m/s, momentum %.4f kg m/s, at x = %.4f m\n", t, mass, v,
                   mass * v, x);
    }
    printf("by Levi-Civita's form: %.6f m/s after the rain\n", vm_velocity_by_momentum(v0, m0, m0 + rain.rate * end, 0, 0));
    if (csv) fclose(csv);
    return 0;
}
