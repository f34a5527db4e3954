/* Numbers of docs/van-der-pol.md: the largest error of x of first-order averaging and of the law of orders one, two and
   three over the last 30 % of a run of 3/eps, against collocation to rounding; the coefficients of the limit cycle; and
   the last vibrations of one motion.

   usage: van_der_pol table        the table of errors and slopes, in Markdown
          van_der_pol cycle        the coefficients of the limit cycle, in Markdown
          van_der_pol wave FILE    t and x: exact, first-order averaging, orders one and three, as CSV
          van_der_pol slopes FILE  eps and the errors of the same methods and of order two for one law, as CSV */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../varmass.h"

enum { METHODS = 4, REFERENCE = 4, EPSILONS = 4, CASES = 7, ALPHAS = 5 };
static const double epsilons[EPSILONS] = {0.1, 0.03, 0.01, 0.003};
static const double alphas[ALPHAS] = {0.5, 1, 4. / 3, 3, 5};
static const char *const labels[ALPHAS] = {"1/2", "1", "4/3", "3", "5"};

static void check(int status)
{
    if (status >= 0) return;
    fprintf(stderr, "van_der_pol: %s\n", vm_strerror(status));
    exit(1);
}

/* A motion: the oscillator and its start */
typedef struct {
    vm_vdp v;
    double x, rate;
} start;

/* The laws of docs/van-der-pol.md at the rate e, in the order of its list */
static start case_of(int i, double alpha, double e)
{
    static const double share[CASES] = {0.5, 1.6, 0.5, 1.6, 0, 0, 0}, angle[CASES] = {0.7, 2, 2, 0.7, 2, 0.7, 0.4};
    start s;
    vm_vdp_cycle cycle;
    double A = 1, sa, ca;
    memset(&s, 0, sizeof s);
    s.v.alpha = alpha;
    s.v.k = 1;
    s.v.feed = e;
    s.v.c = e;
    s.v.reactive = 1;
    s.v.mass = vm_law_linear(1, 0);
    check(vm_vdp_init(&s.v));
    check(vm_vdp_cycle_of(&s.v, &cycle));
    if (share[i] > 0) A = share[i] * vm_vdp_limit_cycle(&s.v, 0, NULL);
    if (i == 2 || i == 3) s.v.mass = vm_law_linear(1, e);
    if (i == 3 || i == 4) s.v.reactive = 0;
    if (i == 4) {
        s.v.mass = vm_law_linear(1, -e / 5);
        s.v.feed = 0;
    }
    if (i == 5) s.v.mass = vm_law_exponential(1, e / 2);
    if (i == 6) s.v.feed = -e / 2;
    ateb_saca(angle[i], alpha, &sa, &ca);
    s.x = A * ca;
    s.rate = -vm_osc_vmax(A, 1, alpha) * sa;
    return s;
}

/* First-order averaging (410) from the amplitude and the phase of x and x' at t = 0, at the times t[0] < t[1] ... */
static void averaged(const start *s, int n, const double *t, double *x)
{
    vm_vdp v = s->v;
    rk87 run;
    rk87_options options;
    double y[2], work[RK87_WORK(2)], sa, ca;
    int i;
    memset(&options, 0, sizeof options);
    options.rtol = options.atol = 1e-12;
    vm_osc_amplitude_phase(s->x, s->rate, 1, v.alpha, &y[0], &y[1]);
    check(rk87_init(&run, vm_vdp_averaged_rhs, &v, 2, 0, y, &options, work));
    for (i = 0; i < n; i++) {
        check(rk87_solve(&run, t[i]));
        ateb_saca(run.y[1], v.alpha, &sa, &ca);
        x[i] = run.y[0] * ca;
    }
}

/* The largest errors over the last 30 % of a run of 3/e, relative to the amplitude: of first-order averaging, and of
   the orders one to three. error[REFERENCE] is the estimated error of the integration that stands for the exact
   motion. */
static void largest_errors(int which, double alpha, double e, double *error)
{
    enum { TIMES = 12 };
    const start s = case_of(which, alpha, e);
    double t[TIMES], x[TIMES];
    vm_vdp_plan plan;
    int i, k;
    for (k = 0; k <= METHODS; k++) error[k] = 0;
    for (i = 0; i < TIMES; i++) t[i] = 3 / e * (0.7 + 0.3 * i / (TIMES - 1));
    check(vm_vdp_plan_init(&plan, &s.v, s.x, s.rate));
    averaged(&s, TIMES, t, x);
    for (i = 0; i < TIMES; i++) {
        static const int routes[METHODS] = {0, VM_ROUTE_ATEB, VM_ROUTE_ORDER2, VM_ROUTE_ORDER3};
        vm_osc_motion exact, law;
        check(vm_vdp_plan_by_route(&plan, VM_ROUTE_COLLOCATION, t[i], 1e-13, &exact));
        error[REFERENCE] = fmax(error[REFERENCE], exact.error);
        error[0] = fmax(error[0], fabs(x[i] - exact.x) / exact.amplitude);
        for (k = 1; k < METHODS; k++) {
            check(vm_vdp_plan_by_route(&plan, routes[k], t[i], 0, &law));
            error[k] = fmax(error[k], fabs(law.x - exact.x) / exact.amplitude);
        }
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
    static double slopes[METHODS][ALPHAS * CASES];
    int a, i, k, method, count = 0;
    puts("| alpha | eps | averaging (410) | order 1 | order 2 | order 3 |\n|---|---|---|---|---|---|");
    for (a = 0; a < ALPHAS; a++) {
        double error[EPSILONS][CASES][METHODS + 1];
        for (k = 0; k < EPSILONS; k++) {
            for (i = 0; i < CASES; i++) largest_errors(i, alphas[a], epsilons[k], error[k][i]);
            printf("| %s | %g |", labels[a], epsilons[k]);
            for (method = 0; method < METHODS; method++) {
                double values[CASES], reference[CASES], middle;
                for (i = 0; i < CASES; i++) {
                    values[i] = error[k][i][method];
                    reference[i] = error[k][i][REFERENCE];
                }
                middle = median(values, CASES);
                printf(" %s%.1e |", median(reference, CASES) > middle / 4 ? "< " : "", middle);
            }
            puts("");
        }
        for (i = 0; i < CASES; i++, count++)
            for (k = 0; k < METHODS; k++) slopes[k][count] = log(error[2][i][k] / error[3][i][k]) / log(10 / 3.);
    }
    printf("| all | slope, 0.01 to 0.003 |");
    for (k = 0; k < METHODS; k++) printf(" %.2f |", median(slopes[k], count));
    puts("");
}

static void limit_cycles(void)
{
    int a;
    puts("| alpha | A sqrt(c/b) | kx | kw |\n|---|---|---|---|");
    for (a = 0; a < ALPHAS; a++) {
        vmi_ripple r;
        vmi_vdp_ripple v;
        double kx, kw;
        vmi_ripple_init(&r, alphas[a], vmi_ateb_constants);
        vmi_ripple_complete(&r, 5);
        vmi_vdp_ripple_init(&v, &r);
        vmi_vdp_cycle_coefficients(&v, &r, &kx, &kw);
        printf("| %s | %.9f | %.9f | %.9f |\n", labels[a], sqrt(-1 / v.F), kx, kw);
    }
}

static FILE *opened(const char *path)
{
    FILE *file = fopen(path, "w");
    if (!file) exit(1);
    return file;
}

static void wave(const char *path)
{
    enum { POINTS = 600 };
    const double e = 0.1;
    const start s = case_of(1, 3, e);
    static double t[POINTS], x[POINTS];
    FILE *file = opened(path);
    vm_vdp_plan plan;
    int i;
    for (i = 0; i < POINTS; i++) t[i] = 3 / e - 9 + 9. * i / (POINTS - 1);
    averaged(&s, POINTS, t, x);
    check(vm_vdp_plan_init(&plan, &s.v, s.x, s.rate));
    for (i = 0; i < POINTS; i++) {
        vm_osc_motion exact, first, third;
        check(vm_vdp_plan_by_route(&plan, VM_ROUTE_COLLOCATION, t[i], 1e-9, &exact));
        check(vm_vdp_plan_by_route(&plan, VM_ROUTE_ATEB, t[i], 0, &first));
        check(vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER3, t[i], 0, &third));
        fprintf(file, "%.6g,%.6g,%.6g,%.6g,%.6g\n", t[i], exact.x, x[i], first.x, third.x);
    }
    fclose(file);
}

static void slopes(const char *path)
{
    FILE *file = opened(path);
    double e, error[METHODS + 1];
    for (e = 0.2; e > 0.0009; e /= 1.3) {
        largest_errors(1, 3, e, error);
        fprintf(file, "%.6g,%.3g,%.3g,%.3g,%.3g\n", e, error[0], error[1], error[2], error[3]);
    }
    fclose(file);
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "table")) table();
    else if (argc == 2 && !strcmp(argv[1], "cycle")) limit_cycles();
    else if (argc == 3 && !strcmp(argv[1], "wave")) wave(argv[2]);
    else if (argc == 3 && !strcmp(argv[1], "slopes")) slopes(argv[2]);
    else {
        fputs("usage: van_der_pol table | cycle | wave FILE | slopes FILE\n", stderr);
        return 1;
    }
    return 0;
}
