/* A spinning shell bursts into three. A spinning shell bursts into three pieces, and the motions of two of these pieces are
   given. The function vm_separate_all computes the motion of the third piece, "the rest" in the output, by the equations (15),
   (24) and (34). The function vm_energy_gain computes by equation (113) how much kinetic energy the explosive charge gave to the
   pieces. The mass centre of all three pieces moves on as if the shell had not burst, until one of the pieces hits the ground.

   cc -O2 07_bursting_shell.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const double g = 9.81;
    vm_body shell = {10, {0.3, 0.1, 0.3, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 500}, {200, 0, 0}, {0, 100, 0}};
    vm_body piece[3], pair[2];
    vm_balance balance;
    double t;
    int k, status;

    piece[0] = piece[1] = piece[2] = shell;
    piece[0].mass = 3;
    piece[0].r.y = 0.15;
    piece[0].v.x = 260;
    piece[0].v.y = 90;
    piece[0].v.z = 80;
    piece[1].mass = 2;
    piece[1].r.y = -0.15;
    piece[1].v.x = 120;
    piece[1].v.y = -80;
    for (k = 0; k < 2; k++) {
        piece[k].inertia.xx = piece[k].inertia.zz = 0.01;
        piece[k].inertia.yy = 0.008;
        piece[k].omega.y = 150;
    }
    pair[0] = piece[0];
    pair[1] = piece[1];
    status = vm_separate_all(&shell, 2, pair, NULL, &piece[2]);
    printf("%s: the rest of %g kg flies at (%.4f, %.4f, %.4f) m/s, spins at (%.4f, %.4f, %.4f) rad/s\n",
           vm_strerror(status), piece[2].mass, piece[2].v.x, piece[2].v.y, piece[2].v.z, piece[2].omega.x,
           piece[2].omega.y, piece[2].omega.z);
    printf("energy from the charge: %.3f kJ\n", vm_energy_gain(&shell, 2, pair, NULL, &piece[2]) / 1000);
    memset(&balance, 0, sizeof balance);
    vm_balance_between(1, &shell, 3, piece, NULL, shell.r, &balance);
    printf("momentum changed by (%.1e, %.1e, %.1e) of %g kg m/s\n", balance.momentum.x, balance.momentum.y,
           balance.momentum.z, shell.mass * shell.v.x);
    if (csv) fprintf(csv, "x (m),\"z of piece 1 (m)\",\"piece 2\",\"the rest\",\"mass centre\"\n");
    for (k = 0; csv && k < 4; k++) { /* each piece until it is on the ground; the mass centre until the first is */
        const vm_body *b = k < 3 ? &piece[k] : &shell;
        const double up = k < 3 ? b->v.z : piece[2].v.z;
        for (t = 0; t <= (up + sqrt(up * up + 2 * g * 500)) / g; t += 0.05)
            fprintf(csv, "%.4f%.*s%.4f%.*s\n", b->r.x + b->v.x * t, k + 1, ",,,,",
                    b->r.z + b->v.z * t - g * t * t / 2, 3 - k, ",,,,");
    }
    if (csv) fclose(csv);
    return status < 0;
}
