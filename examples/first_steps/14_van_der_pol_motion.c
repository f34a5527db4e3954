/* The motion of a Van der Pol oscillator long after its start. Equation (404), m x'' + k x = (feed - c x^2) x' - m' x', describes
   a Van der Pol oscillator with the mass m, the stiffness k and two constants, feed and c. The program computes two motions of
   such an oscillator. In the first motion mass and stiffness are constant. The program computes this motion by an approximate
   formula for x(t), the law of order three (a higher order is more accurate), which takes the same computing time for every t. In
   the second motion mass joins the oscillator, and its spring becomes softer; therefore the program sets the fields mass and
   stiffness of the struct vm_vdp to functions of time. The function vm_vdp_plan_within computes this motion by an approximate
   formula, too, or by integration if the estimated error is too large. The second motion ends before t = 1000 s, because the
   stiffness falls to 0 at this time. In the output, the limit cycle is the steady vibration to which the first motion tends.

   cc -O2 14_van_der_pol_motion.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_vdp v;
    vm_vdp_plan constant, slow;
    vm_vdp_cycle cycle;
    vm_osc_motion a, b;
    double t;

    memset(&v, 0, sizeof v);
    v.alpha = 1;
    v.k = 1;
    v.feed = 0.05;
    v.c = 0.05;
    v.reactive = 1;
    v.mass = vm_law_linear(1, 0);
    if (vm_vdp_cycle_of(&v, &cycle) || vm_vdp_plan_init(&constant, &v, 0.5, 0)) return 1;
    printf("limit cycle: largest x %.8f m, period %.8f s\n", cycle.largest_x, cycle.period);
    v.mass = vm_law_linear(1, 0.002);
    v.stiffness = vm_law_linear(1, -0.001); /* used in place of the field k */
    if (vm_vdp_plan_init(&slow, &v, 0.5, 0)) return 1;
    puts("\n   t (s)   x, constant mass (m)  estimated error   x, slow mass and stiffness (m)  estimated error");
    for (t = 10; t < 2e6; t *= 10) {
        if (vm_vdp_plan_by_route(&constant, VM_ROUTE_ORDER3, t, 0, &a)) return 1;
        printf("%8g %22.8f %16.1e", t, a.x, a.error);
        if (t < 900 && !vm_vdp_plan_within(&slow, t, 1e-6, &b)) printf(" %32.8f %16.1e", b.x, b.error);
        puts("");
    }
    if (csv) fprintf(csv, "t (s),\"x with constant mass (m)\",\"x with slow mass and stiffness (m)\",\"amplitude (m)\"\n");
    for (t = 0; csv && t <= 120; t += 0.2) {
        if (vm_vdp_plan_by_route(&constant, VM_ROUTE_ORDER3, t, 0, &a)) return 1;
        if (vm_vdp_plan_by_route(&slow, VM_ROUTE_ORDER3, t, 0, &b)) return 1;
        fprintf(csv, "%.1f,%.9f,%.9f,%.9f\n", t, a.x, b.x, b.amplitude);
    }
    if (csv) fclose(csv);
    return 0;
}
