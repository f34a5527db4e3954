/* A wing nut that spins about its middle axis turns over again and again (Dzhanibekov, 1985). The program compares the
   closed form with rk45 at two tolerances. At first the angular velocity off this axis is 1e-5 of the spin. The errors
   of an integrator change this small number, which shifts the times of all later turn-overs.

   usage: dzhanibekov [file.csv]
   The columns of the file are t, omega_y by the closed form and by rk45 with the tolerances 1e-3 and 1e-8, and the
   errors, in rad, of the two attitudes that rk45 gives. */
#include "../varmass.h"
#include <stdio.h>

enum { ROWS = 800, RUNS = 2 };

static const vm_vec3 moments = {3e-5, 2e-5, 1e-5}, spin = {1e-4, 10, 1e-4}; /* kg m^2, rad/s */
static const double tolerances[RUNS] = {1e-3, 1e-8}, duration = 40;

static int free_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_quat q, half_omega;
    (void)t;
    (void)ctx;
    q.w = y[3];
    q.x = y[4];
    q.y = y[5];
    q.z = y[6];
    half_omega.w = 0;
    half_omega.x = y[0] / 2;
    half_omega.y = y[1] / 2;
    half_omega.z = y[2] / 2;
    q = vm_quat_times(q, half_omega);
    dydt[0] = (moments.y - moments.z) * y[1] * y[2] / moments.x;
    dydt[1] = (moments.z - moments.x) * y[2] * y[0] / moments.y;
    dydt[2] = (moments.x - moments.y) * y[0] * y[1] / moments.z;
    dydt[3] = q.w;
    dydt[4] = q.x;
    dydt[5] = q.y;
    dydt[6] = q.z;
    return 0;
}

/* Interpolates the state at t; the steps are as long as the tolerance allows. Returns 0 if a step fails. */
static int follow(rk45 *run, double t, vm_real *y)
{
    while (run->t < t)
        if (rk45_step(run) < 0) return 0;
    return rk45_interpolate(run, t, y) == ODE_OK;
}

/* The angle between the attitude q and the quaternion at y + 3, whose length is not exactly 1 */
static double attitude_error(vm_quat q, const vm_real *y)
{
    const double n = sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5] + y[6] * y[6]);
    const double w = q.w - y[3] / n, x = q.x - y[4] / n, v = q.y - y[5] / n, z = q.z - y[6] / n;
    const double s = sqrt(w * w + x * x + v * v + z * z) / 2;
    return 4 * asin(s < 1 ? s : 1);
}

int main(int argc, char **argv)
{
    const vm_quat upright = {1, 0, 0, 0};
    vm_real work[RUNS][RK45_WORK(7)], y[RUNS][7];
    rk45 runs[RUNS];
    vm_torque_free motion;
    vm_quat q = {1, 0, 0, 0};
    vm_vec3 omega = spin, before = spin;
    double error[RUNS], worst[RUNS] = {0, 0};
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    int row, run, turned = 0;

    puts("A wing nut spun about its middle axis: closed form, and rk45 at two tolerances");
    if (argc > 1 && !csv) {
        perror(argv[1]);
        return 1;
    }
    if (vm_torque_free_init_principal(&motion, moments, upright, spin, 0) != VM_OK) return 1;
    for (run = 0; run < RUNS; run++) {
        const vm_real y0[7] = {spin.x, spin.y, spin.z, 1, 0, 0, 0};
        rk45_options options = rk45_defaults(NULL);
        options.rtol = options.atol = tolerances[run];
        if (rk45_init(runs + run, free_rhs, NULL, 7, 0, y0, &options, work[run]) != ODE_OK) return 1;
    }
    printf("it turns over every %.9f s, for the first time after %.9f s:\n", 0.5 / motion.phase_rate.hi,
           ((motion.phase.hi < 0 ? 0 : 0.5) - motion.phase.hi) / motion.phase_rate.hi); /* where sn is 0 */
    for (row = 0; row <= ROWS; row++) {
        const double t = duration * row / ROWS;
        vm_torque_free_attitude(&motion, t, &q, &omega);
        for (run = 0; run < RUNS; run++) {
            if (!follow(runs + run, t, y[run])) return 1;
            error[run] = attitude_error(q, y[run]);
            if (error[run] > worst[run]) worst[run] = error[run];
        }
        if (before.y * omega.y < 0) {
            printf("  turned over before t = %6.3f s: omega_y = %+.6f rad/s\n", t, omega.y);
            turned++;
        }
        before = omega;
        if (csv) fprintf(csv, "%.6f,%.9g,%.9g,%.9g,%.3e,%.3e\n", t, omega.y, y[0][1], y[1][1], error[0], error[1]);
    }
    printf("after %d turn-overs, %.0f s, the largest errors of attitude:\n", turned, duration);
    for (run = 0; run < RUNS; run++)
        printf("  rk45 to %.0e   %9.2e rad, %6ld evaluations\n", tolerances[run], worst[run], runs[run].evals);
    if (csv && fclose(csv)) {
        perror(argv[1]);
        return 1;
    }
    return 0;
}
