/* A Duffing oscillator whose mass grows. A spring with the force k1 x + k3 x^3, where k1 = 100 N/m and k3 = 20000 N/m^3, holds a
   box of 2 kg. Each second 0.02 kg of sand trickle into the box. The equation of motion is m x'' + k1 x + k3 x^3 = -(b + m') x',
   with mass m and damping b. For a constant mass and b = 0, the function vm_duffing_exact_from computes x exactly. If mass and
   damping change slowly, the function vm_odd_plan_within tries two approximate methods. The first method, "mean motion" in the
   output, uses averaged equations, which describe the slow changes of amplitude and phase. The second method, "with ripple", adds
   to the mean motion the small swing of amplitude and phase within each vibration. If the estimated error of both methods is too
   large, vm_odd_plan_within integrates the equation of motion. Here it does so from t = 40 s on, because from then on the allowed
   error is 1e-8 of the amplitude instead of 1e-4. The function vm_duffing_force describes the spring force k1 x + k3 x^3. For any
   other odd spring force (one with F(-x) = -F(x)), use vm_odd_force_user.

   cc -O2 11_duffing.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    static const char *names[] = {"mean motion", "with ripple", "integration"};
    static vm_odd_plan plan;
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_odd_problem box;
    vm_odd_motion now;
    double t, x, v;

    puts("amplitude (m)  period (s) with constant mass");
    for (x = 0.025; x < 0.3; x *= 2) printf("%13.3f %11.6f\n", x, vm_duffing_period(x, 100 / 2., 20000 / 2.));

    box.force = vm_duffing_force(100, 20000);
    box.mass = vm_law_linear(2, 0.02);
    box.stiffness = vm_law_linear(1, 0); /* a factor of the whole spring force */
    box.damping = vm_law_linear(0.02, 0);
    box.reactive = 1; /* the sand arrives at rest */
    box.x = 0.1;
    box.v = 0;
    if (vm_odd_plan_init(&plan, &box, 60)) return 1;
    puts("\nt (s)        x (m)  amplitude (m)  estimated error  route");
    for (t = 0; t <= 60; t += 10) {
        if (vm_odd_plan_within(&plan, t, t < 35 ? 1e-4 : 1e-8, &now)) return 1;
        printf("%5g %12.8f %14.8f %16.1e  %s\n", t, now.x, now.amplitude, now.error, names[now.route]);
    }
    if (csv) fprintf(csv, "t (s),\"x (m)\",\"x with constant mass (m)\",\"amplitude (m)\"\n");
    for (t = 0; csv && t <= 6; t += 0.01) {
        if (vm_odd_plan_by_route(&plan, VM_ODD_ORDER2, t, 0, &now)) return 1;
        vm_duffing_exact_from(t, 0.1, 0, 50, 10000, &x, &v);
        fprintf(csv, "%.2f,%.9f,%.9f,%.9f\n", t, now.x, x, now.amplitude);
    }
    if (csv) fclose(csv);
    return 0;
}
