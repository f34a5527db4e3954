/* A motion as plain data. A bucket of sand rolls on a level floor. A cubic spring holds the bucket, and the sand leaks out. There
   is no exact formula for the solution x(t) of the equation m x'' + k x^3 = 0, because the mass m changes. Therefore the program
   uses an approximate formula for x(t), called a law. Its order can be 2, 3, 4 or 5; a law of higher order is more accurate.
   The struct vm_osc_closed stores all numbers that the formula contains; the size of the struct is the same for every order. The
   function vm_osc_closed_init computes these numbers once, on a PC or on a microcontroller. From these numbers vm_osc_closed_at
   computes the position x and the velocity v, in the same computing time for every time t. The field `error` of the struct is the
   estimated largest error of x, divided by the amplitude, between t = 0 and the last argument of vm_osc_closed_init. A
   microcontroller can store the struct as a constant in flash memory; the program examples/print_plan.c prints such constants.
   For one call of vm_osc_closed_at, docs/firmware.md lists the flash and stack memory and the number of instructions.

   cc -O2 18_law_as_data.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_osc_problem bucket = {3, vm_law_linear(10, -0.1), vm_law_linear(20000, 0), 0, 0, 0.05, 0, NULL, NULL};
    const double end = 70; /* s: then 7 of 10 kg have leaked out */
    vm_osc_motion exact;
    vm_osc_closed law;
    double x = 0, v = 0, t;
    int order, status = VM_OK;

    for (order = 2; order <= 5 && !status; order++) {
        status = vm_osc_closed_init(&law, &bucket, order, end);
        if (!status) status = vm_osc_closed_at(&law, end, &x, &v);
        if (!status) printf("order %d: x(70 s) = %.11f m, estimated error %.0e of the amplitude\n", order, x, law.error);
    }
    if (!status) status = vm_osc_by_route(&bucket, VM_ROUTE_COLLOCATION, end, 1e-13, &exact);
    if (status >= 0) printf("by integration:   %.11f m, in %ld evaluations\n", exact.x, exact.evals);
    printf("the law takes %d bytes\n", (int)sizeof law);
    if (csv) fprintf(csv, "t (s),\"x (mm)\",\"v (mm/s)\"\n");
    for (t = 0; csv && t <= end && status >= 0; t += 0.05) {
        status = vm_osc_closed_at(&law, t, &x, &v); /* order 5 */
        fprintf(csv, "%g,%.5f,%.5f\n", t, 1000 * x, 1000 * v);
    }
    if (csv) fclose(csv);
    if (status < 0) printf("%s\n", vm_strerror(status));
    return status < 0;
}
