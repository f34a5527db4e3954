/* Errors of the averaged laws for Duffing's oscillator and other odd forces, for docs/duffing.md:
   duffing table           prints the errors and their estimates over a time of 3/eps, as a table
   duffing slopes FILE     writes the errors over eps to a CSV file */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../varmass.h"

typedef struct one_case {
    const char *name;
    double k1, k3, x, v;
    int growing; /* 1 where the action must grow to stay away from the separatrix */
    double k1_rate, k3_rate; /* rates of k1 and k3, divided by eps; 0 where they are constant */
} one_case;

static const one_case cases[] = {
    {"x + x^3/2, hardening", 1, 0.5, 1.5, 0.4, 0, 0, 0},  {"x - x^3/5, softening", 1, -0.2, 1.2, 0.3, 0, 0, 0},
    {"x^3, purely cubic", 0, 1, 1, 0.5, 0, 0, 0}, {"x, linear", 1, 0, 1, 1, 0, 0, 0},
    {"x^3 - x, around both wells", -1, 1, 1.8, 0.2, 1, 0, 0}, {"x^3 - x, in one well", -1, 1, 1.2, 0.1, 0, 0, 0},
    {"sin x, by a user's function", 0, 0, 1.5, 0, 0, 0, 0},
    {"x + x^3/2, k1 rises and k3 falls", 1, 0.5, 1.5, 0.4, 0, 0.2, -0.1},
    {"x^3 - x, in one well, k1 and k3 apart", -1, 1, 1.2, 0.1, 0, 0.05, 0.1},
};
enum { CASES = sizeof cases / sizeof *cases };

static int sine(double x, double *f, void *ctx)
{
    (void)ctx;
    *f = sin(x);
    return 0;
}

/* Mass, stiffness and damping all drift with rates of the order of eps. */
static vm_odd_problem problem_of(const one_case *c, double eps)
{
    static vm_law laws[2];
    const double sign = c->growing ? -1 : 1;
    vm_odd_problem o;
    o.force = vm_duffing_force(c->k1, c->k3);
    if (c->k1 == 0 && c->k3 == 0) o.force = vm_odd_force_user(sine, NULL);
    laws[0] = vm_law_linear(c->k1, c->k1_rate * eps);
    laws[1] = vm_law_linear(c->k3, c->k3_rate * eps);
    if (c->k1_rate != 0 || c->k3_rate != 0) o.force = vm_duffing_force_of_laws(laws);
    o.mass = vm_law_linear(1, -0.2 * eps * sign);
    o.stiffness = vm_law_exponential(1, 0.1 * eps);
    o.damping = vm_law_linear(0.5 * eps * sign, 0.2 * eps * eps * sign);
    o.reactive = 0.3;
    o.x = c->x;
    o.v = c->v;
    return o;
}

/* The largest errors of x between 2.7/eps and 3/eps, and the estimates at 3/eps, both relative to half the distance of
   the turning points; the truth is an integration by rk87. Returns 0 where there is no averaged motion. */
static int errors_of(const one_case *c, double eps, double *error, double *estimate)
{
    static vm_odd_plan plan;
    static double work[RK87_WORK(2)];
    const vm_odd_problem o = problem_of(c, eps);
    vm_odd_problem same = o;
    rk45_options options;
    double y[2];
    rk87 s;
    int i, route;
    memset(&options, 0, sizeof options);
    options.rtol = options.atol = 1e-14;
    options.max_steps = -1;
    y[0] = o.x;
    y[1] = o.v;
    if (vm_odd_plan_init(&plan, &o, 3 / eps) || rk87_init(&s, vm_odd_rhs, &same, 2, 0, y, &options, work) < 0) return 0;
    error[0] = error[1] = 0;
    for (i = 0; i <= 90; i++) {
        const double t = (2.7 + 0.3 * i / 90) / eps;
        if (rk87_solve(&s, t) < 0) return 0;
        for (route = VM_ODD_MEAN; route <= VM_ODD_ORDER2; route++) {
            vm_odd_motion m;
            if (vm_odd_plan_by_route(&plan, route, t, 0, &m)) return 0;
            error[route] = fmax(error[route], fabs(m.x - s.y[0]) / plan.start.swing);
            estimate[route] = m.error;
        }
    }
    return 1;
}

static void print_table(void)
{
    int i, k;
    puts("| force | route | eps = 0.04 | 0.01 | 0.0025 | slope | estimated error at eps = 0.01 |\n|---|---|---|---|---|---|---|");
    for (i = 0; i < CASES; i++) {
        double error[3][2], estimate[3][2];
        int route;
        for (k = 0; k < 3; k++)
            if (!errors_of(cases + i, 0.04 / pow(4, k), error[k], estimate[k])) return;
        for (route = 0; route < 2; route++)
            printf("| %s | %s | %.1e | %.1e | %.1e | %.2f | %.1e |\n", route ? "" : cases[i].name,
                   route ? "with ripple" : "mean motion", error[0][route], error[1][route], error[2][route],
                   log(error[0][route] / error[2][route]) / log(16), estimate[1][route]);
    }
}

static int write_slopes(const char *name)
{
    FILE *csv = fopen(name, "w");
    double eps;
    int i, route;
    if (!csv) return 1;
    fprintf(csv, "eps");
    for (i = 0; i < 3; i++) { /* gnuplot takes a comma in a name for the next column */
        const int force = (int)strcspn(cases[i].name, ",");
        fprintf(csv, ",%.*s: mean motion,%.*s: with ripple", force, cases[i].name, force, cases[i].name);
    }
    for (eps = 0.1; eps > 0.0009; eps /= pow(10, 0.125)) {
        fprintf(csv, "\n%.6g", eps);
        for (i = 0; i < 3; i++) {
            double error[2] = {(double)NAN, (double)NAN}, estimate[2];
            errors_of(cases + i, eps, error, estimate);
            for (route = 0; route < 2; route++) fprintf(csv, ",%.4e", error[route]);
        }
    }
    fprintf(csv, "\n");
    return fclose(csv);
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "table") == 0) print_table();
    else if (argc == 3 && strcmp(argv[1], "slopes") == 0) return write_slopes(argv[2]);
    else return 1;
    return 0;
}
