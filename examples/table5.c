/* Table 5: Omega_alpha (293), k^2 (307) and Omega_1* (300) of the oscillator x'' + x|x|^(alpha-1) = 0, the printed
   values, the true values, and the values that the kit computes. A star marks a printed number if its six decimals are
   not those of the rounded true value. The last column is the error of the printed number. */
#include <math.h>
#include <stdio.h>
#include "../varmass.h"

typedef struct table5_row {
    double alpha, printed[3], exact[3];
} table5_row;

static const table5_row table5[] = {
#include "table5_data.h"
};

static int is_off(double printed, double exact) { return fabs(printed - exact) > 0.5e-6; }

static double print_column(double printed, double exact, double kit)
{
    printf("  |%10.6f%c %12.9f %12.9f", printed, is_off(printed, exact) ? '*' : ' ', exact, kit);
    return fabs(kit - exact) / DBL_EPSILON;
}

int main(void)
{
    const char *names[] = {"Omega_alpha", "k^2", "Omega_1*"};
    const int rows = sizeof table5 / sizeof *table5;
    int i, k, off_rows = 0, off_numbers = 0;
    double worst = 0;
    puts("Table 5: constants of the oscillator with x|x|^(alpha-1)   (* the printed digits are not the true "
         "ones)\n");
    printf("%5s  | %-36s  | %-36s  | %-36s\n%5s", "", "Omega_alpha (293)", "k^2 (307)", "Omega_1* (300)", "alpha");
    for (k = 0; k < 3; k++) printf("  |%10s  %12s %12s", "printed", "true", "varmass");
    puts("  | printed - true, 1e-6");
    for (i = 0; i < rows; i++) {
        const table5_row *row = table5 + i;
        double kit[3];
        int off = 0, shown = 0;
        kit[0] = vm_osc_omega_trig(row->alpha);
        kit[1] = vm_osc_jacobi_parameter(row->alpha);
        kit[2] = vm_osc_omega_jacobi(row->alpha);
        printf("%5g", row->alpha);
        for (k = 0; k < 3; k++) {
            worst = fmax(worst, print_column(row->printed[k], row->exact[k], kit[k]));
            off += is_off(row->printed[k], row->exact[k]);
        }
        for (k = 0; k < 3; k++)
            if (is_off(row->printed[k], row->exact[k]))
                printf("%s %s %+.2f", shown++ ? "," : "  |", names[k], (row->printed[k] - row->exact[k]) * 1e6);
        puts("");
        off_rows += off > 0;
        off_numbers += off;
    }
    printf("\n%d rows; %d have a printed digit off (%d numbers, nearly all cut off instead of rounded);\n", rows,
           off_rows, off_numbers);
    printf("largest difference between the kit and the true values: %.1f eps\n", worst);
    return off_rows == 17 && worst < 8 ? 0 : 1;
}
