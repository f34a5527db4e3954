/* A spring that stiffens. The equation of motion of a mass on a cubic spring is x'' + x^3 = 0. Equation (262) gives the period of
   the vibration, which is shorter if the amplitude is larger. By equation (282), the exact motion x(t) is the amplitude times
   ca(3, 1, s), where ca is the Ateb cosine, a function similar to the cosine. The argument 3 is the power of x in the force, the
   argument 1 is fixed, and s is proportional to the time. For the force x |x|^(alpha-1) the first argument is alpha instead of 3.
   For the cubic spring the program compares two other formulas with the exact motion. The first formula, (291), is a cosine with
   the exact period; its error is up to 7 % of the amplitude. The second formula, (297), contains Jacobi's function cn. For the
   cubic spring this formula is exact, and its error in the output is only an error of rounding.

   cc -O2 02_cubic_spring.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const double period = vm_osc_period(1, 1, 3);
    double x0, x, cosine, cn, v, t, off = 0, off_cn = 0;
    vm_osc_errors table = vm_osc_approximation_errors(3);

    puts("amplitude (m)  period (s)  largest velocity (m/s)");
    for (x0 = 0.25; x0 <= 4; x0 *= 2)
        printf("%13g %11.6f %23.6f\n", x0, vm_osc_period(x0, 1, 3), vm_osc_vmax(x0, 1, 3));

    if (csv) fprintf(csv, "t (s),\"x (282)\",\"cosine (291)\",\"velocity\"\n");
    for (t = 0; t <= 1.5 * period; t += period / 400) {
        vm_osc_exact(t, 1, 1, 3, &x, &v);
        if (csv) fprintf(csv, "%.6f,%.9f,", t, x);
        vm_osc_trig(t, 1, 1, 3, &cosine, &cn);
        if (csv) fprintf(csv, "%.9f,%.9f\n", cosine, v);
        vm_osc_jacobi(t, 1, 1, 3, &cn, &v);
        if (fabs(x - cosine) > off) off = fabs(x - cosine);
        if (fabs(x - cn) > off_cn) off_cn = fabs(x - cn);
    }
    printf("the cosine is off by %.4f of the amplitude (vm_osc_approximation_errors says %.4f), cn by %.1e\n", off, table.trig_x,
           off_cn);
    if (csv) fclose(csv);
    return 0;
}
