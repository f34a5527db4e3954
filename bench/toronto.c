/* DETEST's problems A1 to F5 (tests/detest.h) by rk45, rk87 and DOP853 (dop853.h), at tolerances from 1e-3 to 1e-13.
   The error is that of the end, |error_i|/(tolerance (1 + |y_i|)), the largest of all components: that over the
   tolerance of a step. Nothing is timed; the cost is the number of evaluations of the right-hand side.

   usage: toronto [csv] [LIST]       a line for each problem and method, or the same numbers as CSV; LIST: only these
                                     problems or classes, for example F1,D
          toronto markdown BEFORE    docs/toronto.md, with the results of an older integrators.h from the file BEFORE,
                                     which is what `toronto csv` printed with it */
#include "../integrators.h"
#include <stdio.h>
#include "../tests/detest.h"
#include "../tests/data/detest_table.h"
#include "dop853.h"

enum { METHODS = 3, TOLERANCES = 11, FIRST_DIGITS = 3 }; /* tolerances 1e-3, 1e-4 ... */
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
            for (digits = FIRST_DIGITS; digits < FIRST_DIGITS + TOLERANCES; digits++) {
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
    printf("%8s-%-2d", "1e", FIRST_DIGITS);
    for (digits = FIRST_DIGITS + 1; digits < FIRST_DIGITS + TOLERANCES; digits++) printf("%14s-%-2d", "1e", digits);
    puts("");
    for (problem = 0; problem < DETEST_PROBLEMS; y_end += detest_problems[problem++].n) {
        const detest_problem *p = detest_problems + problem;
        if (!is_wanted(list, p->name)) continue;
        for (method = 0; method < METHODS; method++) {
            printf("%s %-22s %-6s", p->name, p->what, methods[method]);
            for (digits = FIRST_DIGITS; digits < FIRST_DIGITS + TOLERANCES; digits++) {
                const result r = solve(p, y_end, method, pow(10, -digits));
                printf(" %9.2g/%-5ld", r.error, r.evals);
                if (r.status) printf("(%d)", r.status);
            }
            puts("");
        }
    }
}

/* ---- docs/toronto.md ---- */

typedef result results[DETEST_PROBLEMS][METHODS][TOLERANCES];

static void solve_all(results all)
{
    const double *y_end = detest_ends;
    int problem, method, i;
    for (problem = 0; problem < DETEST_PROBLEMS; y_end += detest_problems[problem++].n)
        for (method = 0; method < METHODS; method++)
            for (i = 0; i < TOLERANCES; i++)
                all[problem][method][i] = solve(detest_problems + problem, y_end, method, pow(10, -FIRST_DIGITS - i));
}

/* What `toronto csv` printed; returns how many results there were */
static int read_all(const char *name, results all)
{
    FILE *file = fopen(name, "r");
    char line[200], problem_name[3], method_name[8];
    int count = 0, problem, method, digits;
    result r;
    if (!file) return 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "%2[^,],%7[^,],1e-%d,%lf,%ld,%d", problem_name, method_name, &digits, &r.error, &r.evals,
                   &r.status) != 6)
            continue;
        for (problem = 0; problem < DETEST_PROBLEMS; problem++)
            for (method = 0; method < METHODS; method++)
                if (!strcmp(problem_name, detest_problems[problem].name) && !strcmp(method_name, methods[method])) {
                    all[problem][method][digits - FIRST_DIGITS] = r;
                    count++;
                }
    }
    fclose(file);
    return count;
}

static void print_head(const char *first)
{
    int i;
    printf("\n| %s | by |", first);
    for (i = 0; i < TOLERANCES; i++) printf(" 1e-%d |", FIRST_DIGITS + i);
    printf("\n|---|---|");
    for (i = 0; i < TOLERANCES; i++) printf("---|");
    puts("");
}

/* One class: the geometric mean of the errors, and the sum of the evaluations */
static void print_mean_row(const char *by, int class, int method, results all)
{
    int i, k;
    printf("| %c | %s |", 'A' + class, by);
    for (i = 0; i < TOLERANCES; i++) {
        double sum = 0;
        long evals = 0;
        for (k = 5 * class; k < 5 * class + 5; k++) {
            sum += log(fmax(all[k][method][i].error, 1e-9));
            evals += all[k][method][i].evals;
        }
        printf(" %.2g / %ld |", exp(sum / 5), evals);
    }
    puts("");
}

/* A text in a cell of a table, where a bar needs a backslash */
static void print_cell(const char *text)
{
    for (; *text; text++) {
        if (*text == '|') putchar('\\');
        putchar(*text);
    }
}

static void print_row(const char *by, const detest_problem *p, const result *row)
{
    int i;
    printf("| %s ", p->name);
    print_cell(p->what);
    printf(" | %s |", by);
    for (i = 0; i < TOLERANCES; i++)
        printf(" %.2g / %ld%s |", row[i].error, row[i].evals, row[i].status < 0 ? " (failed)" : "");
    puts("");
}

static int print_markdown(const char *name)
{
    static results before, now;
    static const char *const rows[5] = {"rk45, 0.1", "rk45", "rk87, 0.1", "rk87", "DOP853"};
    int k, row;
    if (read_all(name, before) < DETEST_PROBLEMS * 2 * TOLERANCES) return fprintf(stderr, "%s is not complete\n", name);
    solve_all(now);
    puts("# The Toronto test set\n\n"
         "The command `make toronto` (bench/toronto.c) writes this page. The Toronto test set, also called DETEST,\n"
         "is a set of thirty differential equations, called problems here, on which programs for numerical\n"
         "integration are tested. Each problem is solved from t = 0 to t = 20. Hull, Enright, Fellen and Sedgwick\n"
         "published the set in 1972; Enright and Pryce added five of the problems (class F) in 1987. The file\n"
         "tests/detest.h contains the thirty problems. Their solutions at t = 20 are known to 20 digits\n"
         "(tests/gen/detest_reference.c).\n"
         "\n"
         "The thirty problems are divided into six classes of five problems. Class A consists of single equations,\n"
         "class B of small systems of equations and class C of larger systems. The problems of class D are orbits\n"
         "of a body around a fixed centre of attraction (Kepler's problem), and those of class E are differential\n"
         "equations of second order. In the problems of class F, the right-hand side of the differential equation\n"
         "is not smooth: it jumps, or its slope jumps or is infinite.\n"
         "\n"
         "Each cell of both tables below contains two numbers: the error of the solution and, after the slash, the\n"
         "number of evaluations of the right-hand side. The number of evaluations measures how much the integrator\n"
         "has to compute. The number at the top of a column is the tolerance, that is, the relative and absolute\n"
         "error that the integrator may make in one step. For each component y of the solution, the error at t = 20\n"
         "is |y - true y| / (tolerance (1 + |true y|)). So an error of 1 means that y at t = 20 is wrong by as much\n"
         "as the tolerance allows in one step. Errors above 1 are possible, because the errors of many steps may add\n"
         "up. The second table has one row for each problem and integrator; its cells contain the error of the\n"
         "component with the largest error. The first table has one row for each class and integrator. Its cells\n"
         "contain the geometric mean of the errors of the five problems in the class, and the sum of the evaluations\n"
         "for these five problems.\n"
         "\n"
         "The column \"by\" names the integrator. The integrators `rk45` (order 5) and `rk87` (order 8) are the two\n"
         "integrators of varmass that choose the length of their steps themselves. Rows with \"0.1\" in the column\n"
         "\"by\" are results of the older version 0.1 of varmass (commit dd359b9); they are read from the file\n"
         "bench/toronto_before.csv. DOP853 is not a part of varmass but an integrator for comparison. DOP853 is the\n"
         "Runge-Kutta method of order 8 by Dormand and Prince, with Hairer's error estimate and the step size\n"
         "control of SciPy's function `solve_ivp` (bench/dop853.h). In class F, the error depends on where in a\n"
         "step the right-hand side is not smooth, and this place is a matter of chance. So a single cell of class F\n"
         "tells little; compare whole rows instead.\n"
         "\n"
         "## Classes: geometric mean of the errors / sum of the evaluations");
    print_head("class");
    for (k = 0; k < 6; k++)
        for (row = 0; row < 5; row++) print_mean_row(rows[row], k, row / 2, row % 2 || row == 4 ? now : before);
    puts("\n## Problems");
    print_head("problem");
    for (k = 0; k < DETEST_PROBLEMS; k++)
        for (row = 0; row < 5; row++)
            print_row(rows[row], detest_problems + k, (row % 2 || row == 4 ? now : before)[k][row / 2]);
    return 0;
}

int main(int argc, char **argv)
{
    const int csv = argc > 1 && strcmp(argv[1], "csv") == 0;
    const char *list = argc > 1 + csv ? argv[1 + csv] : "A,B,C,D,E,F";
    if (argc == 3 && strcmp(argv[1], "markdown") == 0) return print_markdown(argv[2]) != 0;
    if (csv) print_csv(list);
    else print_lines(list);
    return 0;
}
