/* A force that is not harmonic. A valve pushes and pulls a piston of 1 kg with a periodic force of up to 0.01 N. The frequency of
   this force is nu, and 16 values describe the force within one period. A spring with the force x^3 holds the piston, whose
   position is x. The first harmonic of the force drives the piston if it vibrates once in a period of the force, the third
   harmonic if it vibrates three times. By averaged equations, without integration, the program computes the amplitude A of the
   steady vibration. As a check, the program integrates the motion over 100 periods of the force; "by integration" is the
   amplitude at the end. For the last row of the output, the figure shows two more periods of the shape of the force and of x.

   cc -O2 20_valve.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"
static int valve(vm_periodic *p, double nu, int vibrations)
{
    static const vm_real samples[16] = {0, 0.7, 1, 1, 1, 1, 1, 0.7, 0, -0.7, -1, -1, -1, -1, -1, -0.7};
    memset(p, 0, sizeof *p);
    p->oscillator.alpha = 3;
    p->oscillator.mass = vm_law_linear(1, 0);
    p->oscillator.stiffness = vm_law_linear(1, 0);
    p->oscillator.damping = 0.005;
    p->oscillator.force = vm_law_linear(0.01, 0);
    p->oscillator.frequency = vm_law_linear(nu, 0);
    p->vibrations = vibrations;
    p->periods = 1;
    vm_periodic_from_samples(p, 16, samples);
    return vm_periodic_init(p);
}

static int compare(double nu, int vibrations, FILE *csv)
{
    vm_steady_state steady[8];
    vm_periodic p;
    vm_real y[3] = {0}, work[RK45_WORK(3)];
    rk45 run;
    double t;
    int n, status = valve(&p, nu, vibrations);
    n = vm_periodic_steady_states(&p, 0, 8, steady); /* the smallest amplitude first */
    if (status || n < 1 || n > 8) return -1;
    y[0] = steady[n - 1].A;
    y[1] = steady[n - 1].delta;
    status = vm_periodic_from_averaged(&p, 0, y, y);
    if (!status) status = rk45_init(&run, vm_periodic_rhs, &p, 3, 0, y, NULL, work);
    if (status >= 0) status = rk45_solve(&run, 200 * VM_PI / nu);
    if (status >= 0) status = vm_periodic_to_averaged(&p, run.t, run.y, y);
    printf("%10.2f %11d %18.4f %15.4f\n", nu, vibrations, steady[n - 1].A, y[0]);
    for (t = 200 * VM_PI / nu; csv && t <= 204 * VM_PI / nu && status >= 0; t += 0.1) {
        status = rk45_solve(&run, t);
        fprintf(csv, "%.1f,%.6f,%.6f\n", t - 200 * VM_PI / nu, vm_periodic_shape(&p, run.y[2]), run.y[0]);
    }
    return status < 0;
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    if (csv) fprintf(csv, "t (s),shape of the force,x (m)\n");
    puts("nu (rad/s)  vibrations in a period  A (m)  by integration");
    if (compare(0.8, 1, NULL) || compare(1, 1, NULL) || compare(1.2, 1, NULL)) return 1;
    if (compare(0.16, 3, NULL) || compare(0.18, 3, NULL)) return 1;
    return compare(0.2, 3, csv);
}
