/* A band winds up on a drum. A band moves with the constant velocity v towards a drum and winds up on it (Fig. 20 of the
   dissertation). The moment of inertia of the drum grows with the angle phi through which the drum has turned. Equation (196)
   gives the angular velocity Omega for each angle phi, and equation (197) gives the time at which the drum has turned through
   phi. At the start Omega is 10 rad/s. The program computes the motion for three values of D, the damping of the drum. With D = 0
   the band drives the drum, and Omega tends to v/R = 12 rad/s, where R is the radius of the drum. With D = 0.00156 N m s, Omega
   stays 10 rad/s, because the torque D Omega of the damping is then equal to mu R (v - R Omega) Omega, the torque by which the
   band drives the drum; mu is the mass of the band per radian. With the largest D the drum cannot turn beyond a certain angle,
   the last number of its row; "inf" means that there is no such limit.

   cc -O2 06_winding_drum.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const double damping[3] = {0, 0.00156, 0.05};
    vm_drum drum[3];
    double t, phi;
    int k;
    for (k = 0; k < 3; k++) {
        vm_drum d = {0.1, 4, 0.02, 0, 1.2, 0, 0, 10};
        d.band = vm_drum_band(d.radius, 1e-3, 0.1, 7800); /* 1 mm of steel, 0.1 m broad: kg/rad (181) */
        d.damping = damping[k];
        drum[k] = d;
        printf("D = %-7g N m s: after 0.5 s turned by %.9f rad, now %.6f rad/s; can turn by %g rad\n", damping[k],
               vm_drum_angle(&d, 0.5), vm_drum_rate(&d, vm_drum_angle(&d, 0.5)), vm_drum_stop(&d));
    }
    if (csv)
        fprintf(csv, "t (s),\"rad/s where D = %g N m s\",\"%g N m s\",\"%g N m s\"\n", damping[0], damping[1],
                damping[2]);
    for (t = 0; csv && t <= 1; t += 0.005) {
        fprintf(csv, "%g", t);
        for (k = 0; k < 3; k++) {
            phi = vm_drum_angle(&drum[k], t);
            if (phi <= 2 * 3.14159265358979) /* the model is for the first layer */
                fprintf(csv, ",%.9f", vm_drum_rate(&drum[k], phi));
            else fprintf(csv, ",");
        }
        fprintf(csv, "\n");
    }
    if (csv) fclose(csv);
    return 0;
}
