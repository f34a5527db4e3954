/* DETEST's problems A1 to F5 (tests/detest.h) by rk45, rk87 and DOP853 (dop853.h), at tolerances from 1e-3 to 1e-13.
   The error is that of the end, |error_i|/(tolerance (1 + |y_i|)), the largest of all components: that over the
   tolerance of a step. Nothing is timed; the cost is the number of evaluations of the right-hand side.

   usage: toronto [csv] [LIST]   a line for each problem and method, or the same numbers as CSV; LIST: only these problems
                                 or classes, for example F1,D */
#include "../integrators.h"
#include <stdio.h>
#include "../tests/detest.h"
#include "../tests/data/detest_table.h"
#include "dop853.h"

enum { METHODS = 3, TOLERANCES = 11 };
static const char *const methods[METHODS] = {"rk45", "rk87", "DOP853"};

typedef struct result {
    double error; /* in tolerances */
    long evals;
    int status; /* of solve: ODE_OK, ODE_STIFF ... */
} result;

static result solve(const detest_problem *p, const double *y_end, int method, double tolerance)
{
    double y[DETEST_LARGEST], work[RK87_WORK(DETEST_LARGEST)];
    rk45_options o = {0};
    rk45 s;
    result r = {0, 0, 0};
    int i;
    detest_start(p, y);
    if (method == 2) {
        r.evals = dop853_solve(p->f, NULL, p->n, 0, detest_t_end, y, tolerance);
        if (r.evals < 0) r.status = ODE_STEP_TOO_SMALL;
    } else {
        o.rtol = o.atol = tolerance;
        (method == 0 ? rk45_init : rk87_init)(&s, p->f, NULL, p->n, 0, y, &o, work);
        r.status = method == 0 ? rk45_solve(&s, detest_t_end) : rk87_solve(&s, detest_t_end);
        r.evals = s.evals;
        for (i = 0; i < p->n; i++) y[i] = s.y[i];
    }
    for (i = 0; i < p->n; i++) r.error = fmax(r.error, fabs(y[i] - y_end[i]) / (tolerance * (1 + fabs(y_end[i]))));
    return r;
}

/* Is the problem, or its class, in the list? */
static int is_wanted(const char *list, const char *name)
{
    for (; list; list = strchr(list, ',')) {
        list += *list == ',';
        if (list[0] == name[0] && (list[1] == name[1] || list[1] == ',' || list[1] == 0)) return 1;
    }
    return 0;
}

static void print_csv(const char *list)
{
    const double *y_end = detest_ends;
    int problem, method, digits;
    printf("problem,method,tolerance,error,evaluations,status\n");
    for (problem = 0; problem < DETEST_PROBLEMS; y_end += detest_problems[problem++].n) {
        const detest_problem *p = detest_problems + problem;
        if (!is_wanted(list, p->name)) continue;
        for (method = 0; method < METHODS; method++)
            for (digits = 3; digits < 3 + TOLERANCES; digits++) {
                const result r = solve(p, y_end, method, pow(10, -digits));
                printf("%s,%s,1e-%d,%.3g,%ld,%d\n", p->name, methods[method], digits, r.error, r.evals, r.status);
            }
    }
}

/* A line for each problem and method: error/evaluations at each tolerance, and the status where it is not ODE_OK */
static void print_lines(const char *list)
{
    const double *y_end = detest_ends;
    int problem, method, digits;
    printf("error in tolerances/evaluations   ");
    for (digits = 3; digits < 3 + TOLERANCES; digits++) printf("%*s-%-2d", digits == 3 ? 8 : 14, "1e", digits);
    puts("");
    for (problem = 0; problem < DETEST_PROBLEMS; y_end += detest_problems[problem++].n) {
        const detest_problem *p = detest_problems + problem;
        if (!is_wanted(list, p->name)) continue;
        for (method = 0; method < METHODS; method++) {
            printf("%s %-22s %-6s", p->name, p->what, methods[method]);
            for (digits = 3; digits < 3 + TOLERANCES; digits++) {
                const result r = solve(p, y_end, method, pow(10, -digits));
                printf(" %9.2g/%-5ld", r.error, r.evals);
                if (r.status) printf("(%d)", r.status);
            }
            puts("");
        }
    }
}

int main(int argc, char **argv)
{
    const int csv = argc > 1 && strcmp(argv[1], "csv") == 0;
    const char *list = argc > 1 + csv ? argv[1 + csv] : "A,B,C,D,E,F";
    if (csv) print_csv(list);
    else print_lines(list);
    return 0;
}
