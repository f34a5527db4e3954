/* A rocket rises. A rocket of mass M and velocity v = x' loses gas at the rate M' = -5 kg/s. By equations (175) and (176),
   M x'' = -M g + M' (u - v), where u is the velocity of the gas. Here u - v is -2000 m/s, so that the thrust M' (u - v) is
   upward. The integrator rk45 computes the motion, and finds the time at which the fuel is used up. The weight lowers v by g t.
   Therefore the program compares v at 60 s with Tsiolkovsky's formula for a rocket without weight, less g t.

   cc -O2 04_rocket.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"
static int weight(vm_real t, const vm_real *y, vm_flow1 *rocket)
{
    (void)t;
    rocket->force = -9.81 * y[2];
    return 0;
}

static vm_real propellant(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[2] - 40;
}

static void burnt_out(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    ((vm_flow1 *)ctx)->streams[0].rate = 0;
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_stream1 jet = {-5, -2000, VM_RELATIVE}; /* 5 kg/s leave, downwards, at 2000 m/s against the rocket */
    vm_flow1 rocket = {1, &jet, 0, weight, NULL, 0};
    static ode_event empty;
    static rk45_options options; /* 0 stands for the default */
    vm_real y[3] = {0, 0, 100}, work[RK45_WORK(3)], t; /* x, momentum, mass */
    rk45 s;
    int status;
    empty.g = propellant;
    empty.ctx = &rocket;
    empty.direction = -1;
    empty.action = ODE_RESTART;
    empty.change = burnt_out;
    options.rtol = 1e-10;
    options.events = &empty;
    options.n_events = 1;
    status = rk45_init(&s, vm_flow1_rhs, &rocket, 3, 0, y, &options, work);
    if (csv) fprintf(csv, "t (s),\"height (10 km)\",\"velocity (km/s)\",\"mass (100 kg)\"\n");
    for (t = 0; t <= 60 && status >= 0; t += 0.5) {
        status = rk45_solve(&s, t);
        if (csv) fprintf(csv, "%g,%.6f,%.6f,%.6f\n", t, s.y[0] / 1e4, s.y[1] / s.y[2] / 1000, s.y[2] / 100);
    }
    printf("burnt out at t = %.9f s (12 s)\n", empty.t);
    printf("at 60 s: %.9f m/s, Tsiolkovsky less g t %.9f m/s; %ld evaluations\n", s.y[1] / s.y[2],
           vm_tsiolkovsky(0, 100, 40, -2000) - 9.81 * 60, s.evals);
    if (csv) fclose(csv);
    return status < 0;
}
