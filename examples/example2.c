/* Example 2, (402): d/dt(m x') + x|x|^(1/2) = 0 with m = (1 + 0.1 t)^2 and reactive force, x(0) = 1, x'(0) = 0. For
   Fig. 25 the program integrates the motion by rk45 and computes the envelope from the Ateb functions, as printed in
   (403) and as corrected. The printed (403) is wrong, because it forgets that the mass is a square. The dissertation
   prints no other envelopes for this example. The program adds the envelopes by the general laws of the dissertation:
   by (363) and (364) with the printed 5 - alpha, and by (389), (390), (395) with C_2 = 1/2 and C_4 = 3/8, the values
   that the dissertation uses for (396).

   usage: example2 [file.csv]
   The columns of the file are t, x, x', then amplitude and velocity of each envelope, in the order of the array
   `laws`. */
#include "envelope.h"

int main(int argc, char **argv)
{
    const oscillator o = {1.5, 2};
    const double a = 1 / (o.alpha + 3), v = (o.alpha + 2) / (o.alpha + 3);
    const double vmax = vm_osc_vmax(1, 1, o.alpha), trig = vm_osc_omega_trig(o.alpha), m = vm_osc_jacobi_parameter(o.alpha);
    const double s = (1 - m - (1 - 2 * m) / 2 - m * 3 / 8) / (1 - m + m * 3 / 8),
                 divisor = 2 + (o.alpha - 1) * s; /* (390) */
    envelope laws[] = {
        /* (1 + 0.1 t)^(-2/9) and 2/sqrt(5) (1 + 0.1 t)^(-7/9) */
        {"Ateb (403) as printed", 1. / 9, vmax, 3.5 / 9, 0, 0},
        {"Ateb corrected", a, vmax, v, 0, 0},
        {"trigonometric (363), (364) as printed", 1 / (5 - o.alpha), trig, 3 / (5 - o.alpha), 0, 0},
        {"trigonometric, (335) corrected", a, trig, v, 0, 0},
        {"Jacobi (389), (395) as for (396)", s / divisor, vmax, (s * o.alpha + 1) / divisor, 0, 0},
        {"Jacobi, exact means of cn^2, cn^4", a, vmax, v, 0, 0},
    };
    puts("Example 2, (402): d/dt(m x') + x|x|^(1/2) = 0, m = (1 + 0.1 t)^2, x(0) = 1, x'(0) = 0");
    return envelope_report(&o, laws, sizeof laws / sizeof *laws, argc > 1 ? argv[1] : NULL);
}
