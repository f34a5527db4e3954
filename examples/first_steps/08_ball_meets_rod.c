/* A ball hits a rod that lies on ice. A rod lies at rest on ice; a ball flies towards the rod and sticks to it. The place where
   the ball hits the rod, measured from the middle of the rod, decides how fast the rod spins afterwards and how much energy is
   lost. The function vm_attach2 computes by equations (35)-(39) how rod and ball move together after the impact. The lost energy
   is the difference of the kinetic energies; Carnot's theorem (118) gives the same value. Rod and ball move in a plane, so each
   is a `vm_body2`, a struct with mass, moment of inertia, position of the mass centre, angle, velocity and angular velocity.

   cc -O2 08_ball_meets_rod.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const double length = 1, mass = 2;
    vm_body2 rod = {0, 0, 0, 0, 0, 0, 0, 0}, ball = rod, both = rod;
    double at, lost;
    int status = VM_OK;

    rod.mass = mass;
    rod.inertia = mass * length * length / 12; /* along y, at rest */
    ball.mass = 0.5;
    ball.inertia = 1e-4;
    ball.vx = 3; /* flies along x */
    if (csv) fprintf(csv, "where it hits (m from the middle),\"omega (rad/s)\",\"v (m/s)\",\"energy lost (J)\"\n");
    puts("hits at (m)  spin (rad/s)  mass centre's v (m/s)  energy lost (J)");
    for (at = 0; at <= 0.5001; at += 0.01) {
        ball.y = at;
        status = vm_attach2(&rod, &ball, NULL, &both);
        if (status < 0) {
            printf("%s\n", vm_strerror(status));
            return 1;
        }
        lost = vm_kinetic_energy2(&ball) - vm_kinetic_energy2(&both);
        if (csv) fprintf(csv, "%.3f,%.9f,%.9f,%.9f\n", at, both.omega, both.vx, lost);
        if ((int)(at * 100 + 0.5) % 10 == 0)
            printf("%11.2f %13.6f %22.6f %16.6f\n", at, both.omega, both.vx, lost);
    }
    puts("(the further out, the more spin and the less loss: the ball is slowed less)");
    if (csv) fclose(csv);
    return 0;
}
