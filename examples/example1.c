/* Example 1, (398): the cubic oscillator d/dt(m x') + x^3 = 0 with m = 1 + 0.1 t and reactive force, x(0) = 1, x'(0) =
   0. For Figs 22-24 the program integrates the motion by rk45 and computes the envelopes from the Ateb, trigonometric
   and Jacobi functions, as printed in (399)-(401) and as corrected. Numbers in brackets are equations of the
   dissertation.

   usage: example1 [file.csv]
   The columns of the file are t, x, x', then amplitude and velocity of each envelope, in the order of the array
   `laws`. */
#include "envelope.h"

int main(int argc, char **argv)
{
    const oscillator o = {3, 1};
    const double a = 1 / (o.alpha + 3), v = (o.alpha + 2) / (o.alpha + 3);
    const double vmax = vm_osc_vmax(1, 1, o.alpha), trig = vm_osc_omega_trig(o.alpha);
    envelope laws[] = {
        {"Ateb (399) as printed", 0.16667, 0.70711, 0.83333, 0, 0},
        {"Ateb corrected", a, vmax, v, 0, 0},
        {"trigonometric (400) as printed", 0.5, 0.84721, 1.5, 0, 0},
        {"trigonometric, (335) corrected", a, trig, v, 0, 0},
        {"Jacobi (401) as printed", 0.15625, 0.70711, 0.8125, 0, 0},
        {"Jacobi, exact means of cn^2, cn^4", a, vmax, v, 0, 0},
    };
    puts("Example 1, (398): d/dt(m x') + x^3 = 0, m = 1 + 0.1 t, x(0) = 1, x'(0) = 0");
    return envelope_report(&o, laws, sizeof laws / sizeof *laws, argc > 1 ? argv[1] : NULL);
}
