/* A self-excited vibration whose mass grows. Equation (404), m x'' + x = (feed - c x^2) x' - m' x', describes a Van der Pol
   oscillator whose mass m grows. The constants feed and c describe a damping that feeds energy to small vibrations and takes
   energy from large ones. Any amplitude at the start, here 0.3 or 3, tends to the steady value of equation (425). This value is
   smaller than 2 sqrt(feed/c), the steady amplitude with constant mass, because mass that joins at rest slows the motion. A
   closed formula gives the amplitudes in the output and in the figure; the integrator rk45 computes x(t) for the figure.

   cc -O2 09_growing_van_der_pol.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_real starts[2] = {0.3, 3};
    const double growth = 0.02; /* kg/s */
    vm_vdp v;
    vm_real work[2][RK45_WORK(2)], t;
    rk45_options options;
    rk45 s[2];
    int k, status;

    memset(&v, 0, sizeof v); /* method VM_VDP_ATEB */
    v.alpha = 1;
    v.k = 1;
    v.feed = 0.1;
    v.c = 0.1;
    v.reactive = 1;
    v.mass = vm_law_linear(1, growth);
    status = vm_vdp_init(&v);
    memset(&options, 0, sizeof options); /* 0 stands for the default */
    options.rtol = 1e-8;
    for (k = 0; k < 2 && status >= 0; k++) {
        vm_real y[2] = {0, 0};
        y[0] = starts[k];
        status = rk45_init(&s[k], vm_vdp_rhs, &v, 2, 0, y, &options, work[k]);
    }
    if (csv) fprintf(csv, "t,\"x from 0.3\",\"x from 3\",\"amplitude from 0.3\",\"amplitude from 3\"\n");
    for (t = 0; t <= 100 && status >= 0; t += 0.1) {
        for (k = 0; k < 2 && status >= 0; k++) status = rk45_solve(&s[k], t);
        if (csv)
            fprintf(csv, "%g,%.6f,%.6f,%.6f,%.6f\n", t, s[0].y[0], s[1].y[0],
                    vm_vdp_amplitude(&v, t, starts[0]), vm_vdp_amplitude(&v, t, starts[1]));
    }
    printf("amplitude at t = 100 s: %.6f m from 0.3 m, %.6f m from 3 m; steady: %.6f m (425), with constant mass %.6f m\n",
           vm_vdp_amplitude(&v, 100, 0.3), vm_vdp_amplitude(&v, 100, 3),
           vm_vdp_limit_cycle(&v, growth, NULL), vm_vdp_limit_cycle(&v, 0, NULL));
    if (csv) fclose(csv);
    return status < 0;
}
