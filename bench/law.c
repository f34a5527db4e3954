/* Numbers of docs/law.md: the largest error of x of the law of order five, cut off after each order, over the last
   tenth of a run of 3/eps, against the exact equations integrated by collocation to rounding; and the error of one
   motion against t.

   usage: law table          the table of errors and slopes, in Markdown
          law errors FILE    t and the errors of orders 2 to 5 along one motion, as CSV
          law slopes FILE    eps and the errors of orders 2 to 5 for one law of mass, as CSV */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../varmass.h"

enum { ORDERS = 4, EPSILONS = 5, CASES = 8 };
static const double epsilons[EPSILONS] = {0.1, 0.03, 0.01, 0.003, 0.001};

/* Laws of mass, stiffness and damping at the rate e, in the order of the list in docs/law.md */
static vm_osc_problem case_of(int i, double alpha, double e)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = alpha;
    o.mass = vm_law_linear(1, e);
    o.stiffness = vm_law_linear(1, 0);
    o.reactive = i == 0 ? 0 : i == 4 ? 0.3 : 1;
    o.x = 0.9;
    o.v = -0.3;
    if (i == 2) o.damping = e / 2;
    if (i == 3) o.mass = vm_law_exponential(1, e / 2);
    if (i == 4) o.mass = vm_law_power(1, e, 1.5);
    if (i == 5) {
        o.mass = vm_law_linear(1, 0);
        o.stiffness = vm_law_exponential(1, -e);
        o.damping = e / 4;
    }
    if (i == 6) o.mass = vm_law_quadratic(1, e, e * e / 2);
    if (i == 7) {
        o.mass = vm_law_linear(1, -e / 6);
        o.stiffness = vm_law_linear(1, e / 2);
    }
    return o;
}

static void check(int status)
{
    if (status >= 0) return;
    fprintf(stderr, "law: %s\n", vm_strerror(status));
    exit(1);
}

/* The errors of orders 2 to 5 at t, relative to the amplitude */
static void errors_at(const vm_osc_plan *plan, double t, double *error)
{
    vm_osc_motion exact, law;
    int i;
    check(vm_osc_plan_by_route(plan, VM_ROUTE_COLLOCATION, t, 1e-14, &exact));
    for (i = 0; i < ORDERS; i++) {
        check(vm_osc_plan_by_route(plan, VM_ROUTE_ORDER2 + i, t, 0, &law));
        error[i] = fabs(law.x - exact.x) / exact.amplitude;
    }
}

/* The largest errors over the last tenth of a run of 3/e */
static void largest_errors(int which, double alpha, double e, double *error)
{
    const vm_osc_problem o = case_of(which, alpha, e);
    const int times = 12;
    vm_osc_plan plan;
    int i, k;
    for (k = 0; k < ORDERS; k++) error[k] = 0;
    check(vm_osc_plan_init(&plan, &o));
    for (i = 0; i < times; i++) {
        double at[ORDERS];
        errors_at(&plan, 3 / e * (0.9 + 0.1 * i / (times - 1)), at);
        for (k = 0; k < ORDERS; k++) error[k] = fmax(error[k], at[k]);
    }
}

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, int n)
{
    qsort(values, (size_t)n, sizeof *values, rising);
    return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

static void table(void)
{
    static const double alphas[] = {0.5, 4. / 3, 3, 5};
    static const char *const labels[] = {"1/2", "4/3", "3", "5"};
    static double slopes[ORDERS][4 * CASES];
    int a, i, k, count = 0;
    puts("| alpha | eps | order 2 | order 3 | order 4 | order 5 |\n|---|---|---|---|---|---|");
    for (a = 0; a < 4; a++) {
        double error[EPSILONS][CASES][ORDERS];
        for (k = 0; k < EPSILONS; k++) {
            int order;
            for (i = 0; i < CASES; i++) largest_errors(i, alphas[a], epsilons[k], error[k][i]);
            printf("| %s | %g |", labels[a], epsilons[k]);
            for (order = 0; order < ORDERS; order++) {
                double values[CASES];
                for (i = 0; i < CASES; i++) values[i] = error[k][i][order];
                printf(" %.1e |", median(values, CASES));
            }
            puts("");
        }
        for (i = 0; i < CASES; i++, count++)
            for (k = 0; k < ORDERS; k++) slopes[k][count] = log(error[0][i][k] / error[1][i][k]) / log(10 / 3.);
    }
    printf("| all | slope, 0.1 to 0.03 |");
    for (k = 0; k < ORDERS; k++) printf(" %.2f |", median(slopes[k], count));
    puts("");
}

static void along(const char *path)
{
    const vm_osc_problem o = case_of(1, 4. / 3, 0.01);
    FILE *file = fopen(path, "w");
    vm_osc_plan plan;
    double t, error[ORDERS];
    if (!file) exit(1);
    check(vm_osc_plan_init(&plan, &o));
    for (t = 2; t <= 2000; t *= 1.02) {
        errors_at(&plan, t, error);
        fprintf(file, "%.6g,%.3g,%.3g,%.3g,%.3g\n", t, error[0], error[1], error[2], error[3]);
    }
    fclose(file);
}

static void slopes(const char *path)
{
    FILE *file = fopen(path, "w");
    double e, error[ORDERS];
    if (!file) exit(1);
    for (e = 0.2; e > 0.0009; e /= 1.3) {
        largest_errors(0, 4. / 3, e, error);
        fprintf(file, "%.6g,%.3g,%.3g,%.3g,%.3g\n", e, error[0], error[1], error[2], error[3]);
    }
    fclose(file);
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "table")) table();
    else if (argc == 3 && !strcmp(argv[1], "errors")) along(argv[2]);
    else if (argc == 3 && !strcmp(argv[1], "slopes")) slopes(argv[2]);
    else {
        fputs("usage: law table | law errors FILE | law slopes FILE\n", stderr);
        return 1;
    }
    return 0;
}
