/* Work against precision: for each problem and method the error at the end, evaluations, steps, microseconds and the
   nanoseconds that an evaluation takes beyond f itself, over tolerances from 1e-3 to 1e-14 (or numbers of steps);
   then the time to given errors, and the ratios that the project promises. Hand-written loops beside (rk_loops.h),
   and GSL where it is there. Medians of interleaved repeats.
   usage: integrators [CSV FILE] */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200112L
#endif
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
#include "../integrators.h"
#include "rk_loops.h"
#ifdef WITH_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#endif

enum { REPEATS = 7, SETTINGS = 23, METHODS = 9 };
static volatile double sink;
static long calls; /* of f, where they are counted */

typedef struct result {
    long evals, steps;
} result;

/* ---- problems ---- */

#define CONTROLLED_RUN(name, n, method, WORK)                                     \
    static result name##_run_##method(double T, double knob, double *y)           \
    {                                                                             \
        result r = {0, 0};                                                        \
        double work[WORK(n)];                                                     \
        rk45_options o = {0};                                                     \
        rk45 s;                                                                   \
        o.rtol = o.atol = knob;                                                   \
        if (method##_init(&s, name##_rhs, NULL, n, 0, y, &o, work) < 0) return r; \
        if (method##_solve(&s, T) < 0) puts(#method "_solve failed");             \
        memcpy(y, s.y, (n) * sizeof *y);                                          \
        r.evals = s.evals, r.steps = s.steps + s.rejected;                        \
        return r;                                                                 \
    }

/* The right-hand side as each method wants it, inlined, called through a pointer, and counted; and the methods made
   for it. knob: the tolerance, or the number of steps. */
#define PROBLEM(name, n, ...)                                                                     \
    static inline void name##_f(double t, const double *y, double *d)                             \
    {                                                                                             \
        (void)t;                                                                                  \
        __VA_ARGS__                                                                               \
    }                                                                                             \
    static inline void name##_counted(double t, const double *y, double *d)                       \
    {                                                                                             \
        calls++;                                                                                  \
        name##_f(t, y, d);                                                                        \
    }                                                                                             \
    static inline int name##_rhs(double t, const double *y, double *d, void *ctx)                 \
    {                                                                                             \
        (void)ctx;                                                                                \
        name##_f(t, y, d);                                                                        \
        return 0;                                                                                 \
    }                                                                                             \
    RK4_LOOP_OF(name, n, name##_f)                                                                \
    DP54_LOOP_OF(name, n, name##_f)                                                               \
    DP54_LOOP_OF(name##_counting, n, name##_counted)                                              \
    static result name##_run_rk4_loop(double T, double knob, double *y)                           \
    {                                                                                             \
        result r = {4 * (long)knob, (long)knob};                                                  \
        name##_rk4_loop(T, (long)knob, y);                                                        \
        return r;                                                                                 \
    }                                                                                             \
    static result name##_run_rk4(double T, double knob, double *y)                                \
    {                                                                                             \
        result r = {4 * (long)knob, (long)knob};                                                  \
        double work[RK4_WORK(n)], t = 0;                                                          \
        rk4_solve(name##_rhs, NULL, n, &t, T, (long)knob, y, work);                               \
        return r;                                                                                 \
    }                                                                                             \
    static result name##_run_dp54_loop(double T, double knob, double *y)                          \
    {                                                                                             \
        result r = {0, 0};                                                                        \
        name##_dp54_loop(T, knob, y);                                                             \
        return r;                                                                                 \
    }                                                                                             \
    static result name##_count_dp54_loop(double T, double knob, double *y)                        \
    {                                                                                             \
        result r;                                                                                 \
        calls = 0;                                                                                \
        name##_counting_dp54_loop(T, knob, y);                                                    \
        r.evals = calls, r.steps = calls / 6;                                                     \
        return r;                                                                                 \
    }                                                                                             \
    CONTROLLED_RUN(name, n, rk45, RK45_WORK)                                                      \
    CONTROLLED_RUN(name, n, rk87, RK87_WORK)                                                      \
    static double name##_ns(double *y) /* a call of f whose argument depends on the one before */ \
    {                                                                                             \
        double d[n];                                                                              \
        clock_t start = clock();                                                                  \
        long i, count = 2000000;                                                                  \
        int j;                                                                                    \
        for (i = 0; i < count; i++) {                                                             \
            name##_f(1e-9 * (double)i, y, d);                                                     \
            for (j = 0; j < (n); j++) y[j] += 1e-12 * d[j];                                       \
        }                                                                                         \
        sink = y[0];                                                                              \
        return (double)(clock() - start) / CLOCKS_PER_SEC / (double)count * 1e9;                  \
    }

PROBLEM(cubic, 2, d[0] = y[1]; d[1] = -y[0] * y[0] * y[0];)
PROBLEM(mass, 2, d[0] = y[1]; d[1] = -(y[0] * y[0] * y[0] + 0.1 * y[1]) / (1 + 0.1 * t);)
PROBLEM(momentum, 2, d[0] = y[1] / (1 + 0.1 * t); d[1] = -y[0] * y[0] * y[0];)
PROBLEM(body, 3, d[0] = -y[1] * y[2]; d[1] = y[2] * y[0]; d[2] = -y[0] * y[1] * (1. / 3);)
PROBLEM(orbit, 4, const double mu = 0.012277471, mu1 = 1 - mu;
        double r1 = (y[0] + mu) * (y[0] + mu) + y[1] * y[1], r2 = (y[0] - mu1) * (y[0] - mu1) + y[1] * y[1];
        r1 = mu1 / (r1 * sqrt(r1)), r2 = mu / (r2 * sqrt(r2)); d[0] = y[2]; d[1] = y[3];
        d[2] = y[0] + 2 * y[3] - r1 * (y[0] + mu) - r2 * (y[0] - mu1);
        d[3] = y[1] - 2 * y[2] - r1 * y[1] - r2 * y[1];)

typedef result (*runner)(double T, double knob, double *y);

typedef struct problem {
    const char *name, *what;
    int n;
    ode_rhs rhs;
    double (*ns)(double *y);
    runner rk4_loop, rk4, dp54_loop, dp54_count, rk45, rk87;
    double T, y0[4], y_end[4]; /* to 20 digits: rk87 in quadruple precision */
} problem;

#define METHODS_OF(name)                                                                                      \
    name##_rhs, name##_ns, name##_run_rk4_loop, name##_run_rk4, name##_run_dp54_loop, name##_count_dp54_loop, \
        name##_run_rk45, name##_run_rk87
static const problem problems[] = {
    {"cubic", "x'' = -x^3", 2, METHODS_OF(cubic), 100, {1, 0}, {-0.9928219270246553026, -0.1191734455528570027}},
    {"mass",
     "(m x')' = -x^3, m = 1 + 0.1 t, y = (x, x')",
     2,
     METHODS_OF(mass),
     50,
     {1, 0},
     {-0.2102254653258942060, -0.1578403286848444388}},
    {"momentum",
     "(m x')' = -x^3, m = 1 + 0.1 t, y = (x, m x')",
     2,
     METHODS_OF(momentum),
     50,
     {1, 0},
     {-0.2102254653258942054, -0.9470419721090666763}},
    {"body",
     "Euler's rigid body",
     3,
     METHODS_OF(body),
     60,
     {1, 0.1, 0.9},
     {-0.8416044062440098099, -0.5492740876745121888, 0.8442546962872701759}},
    {"orbit",
     "Arenstorf's orbit",
     4,
     METHODS_OF(orbit),
     17.0652165601579625588917206249,
     {0.994, 0, 0, -2.00158510637908252240537862224},
     {0.9939999999999739958, -8.8546999e-14, -1.43879814e-11, -2.001585106383129013}}};

/* ---- methods ---- */

static const char *const method_names[METHODS] = {"rk4_loop", "rk4_solve", "dp54_loop", "rk45_solve", "rk87_solve",
                                                  "gsl_rk4",  "gsl_rkf45", "gsl_rkck",  "gsl_rk8pd"};
enum { RK4_LOOP, RK4_SOLVE, DP54_LOOP, RK45_SOLVE, RK87_SOLVE, GSL_RK4, GSL_RKF45, GSL_RKCK, GSL_RK8PD };

#ifdef WITH_GSL
static ode_rhs counted_rhs;
static int count_calls(double t, const double *y, double *d, void *ctx)
{
    calls++;
    return counted_rhs(t, y, d, ctx);
}

static result run_gsl(const problem *p, int method, double knob, int count, double *y)
{
    const gsl_odeiv2_step_type *type = method == GSL_RK4     ? gsl_odeiv2_step_rk4
                                       : method == GSL_RKF45 ? gsl_odeiv2_step_rkf45
                                       : method == GSL_RKCK  ? gsl_odeiv2_step_rkck
                                                             : gsl_odeiv2_step_rk8pd;
    gsl_odeiv2_system system = {count ? count_calls : p->rhs, NULL, (size_t)p->n, NULL};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-3, knob, knob);
    double t = 0;
    result r;
    counted_rhs = p->rhs, calls = 0;
    if (gsl_odeiv2_driver_apply(driver, &t, p->T, y) != GSL_SUCCESS) puts("GSL failed");
    r.evals = calls, r.steps = (long)driver->n;
    gsl_odeiv2_driver_free(driver);
    return r;
}
#endif

static int fixed_step(int method) { return method == RK4_LOOP || method == RK4_SOLVE; }

static double knob_of(int method, int setting)
{
    return fixed_step(method) ? floor(pow(2, 8 + 0.5 * setting)) : pow(10, -3 - 0.5 * setting);
}

static result run(const problem *p, int method, double knob, int count, double *y)
{
    memcpy(y, p->y0, sizeof p->y0);
    switch (method) {
    case RK4_LOOP: return p->rk4_loop(p->T, knob, y);
    case RK4_SOLVE: return p->rk4(p->T, knob, y);
    case DP54_LOOP: return count ? p->dp54_count(p->T, knob, y) : p->dp54_loop(p->T, knob, y);
    case RK45_SOLVE: return p->rk45(p->T, knob, y);
    case RK87_SOLVE: return p->rk87(p->T, knob, y);
    default:
#ifdef WITH_GSL
        return run_gsl(p, method, knob, count, y);
#else
    {
        result none = {0, 0};
        return none;
    }
#endif
    }
}

/* ---- measuring ---- */

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* One run, from as many as take 0.2 ms and more */
static double microseconds(const problem *p, int method, double knob)
{
    double y[4], start, elapsed;
    int i, runs = 1;
    do {
        for (start = seconds(), i = 0; i < runs; i++) run(p, method, knob, 0, y);
        elapsed = seconds() - start;
        runs *= 2;
    } while (elapsed < 2e-4);
    sink = y[0];
    return elapsed / (runs / 2) * 1e6;
}

typedef struct curve {
    double error[SETTINGS], us[SETTINGS];
    result work[SETTINGS];
} curve;

static void measure(const problem *p, curve *curves)
{
    static double time[METHODS][SETTINGS][REPEATS];
    int repeat, method, k, i;
    for (repeat = 0; repeat < REPEATS; repeat++) {
        if (isatty(2)) fprintf(stderr, "\r%s: %d of %d ", p->name, repeat + 1, REPEATS);
        for (k = 0; k < SETTINGS; k++)
            for (method = 0; method < METHODS; method++)
                time[method][k][repeat] = microseconds(p, method, knob_of(method, k));
    }
    if (isatty(2)) fprintf(stderr, "\r%40s\r", "");
    for (method = 0; method < METHODS; method++)
        for (k = 0; k < SETTINGS; k++) {
            curve *c = curves + method;
            double y[4];
            qsort(time[method][k], REPEATS, sizeof(double), ascending);
            c->us[k] = time[method][k][REPEATS / 2];
            c->work[k] = run(p, method, knob_of(method, k), 1, y);
            for (c->error[k] = 0, i = 0; i < p->n; i++) c->error[k] = fmax(c->error[k], fabs(y[i] - p->y_end[i]));
        }
}

/* Microseconds (and evaluations) to an error, between the last setting that makes a larger one and the next; 0 if the
   error is not reached */
static double time_to(const curve *c, double goal, double *evals)
{
    int k = SETTINGS - 1;
    double w;
    while (k >= 0 && c->error[k] <= goal) k--;
    if (k < 0 || k == SETTINGS - 1) return 0;
    w = log(goal / c->error[k]) / log(c->error[k + 1] / c->error[k]);
    *evals = exp((1 - w) * log((double)c->work[k].evals) + w * log((double)c->work[k + 1].evals));
    return exp((1 - w) * log(c->us[k]) + w * log(c->us[k + 1]));
}

/* the times of methods a and b to an error of goal, as a ratio; "-" where one of them does not reach it */
static void print_ratio(const char *what, const curve *curves, int a, int b, double goal, const char *promised)
{
    double evals, top = time_to(curves + a, goal, &evals), bottom = time_to(curves + b, goal, &evals);
    if (top > 0 && bottom > 0) printf("%s %.2f %s", what, top / bottom, promised);
    else printf("%s - %s", what, promised);
}

static void print_problem(const problem *p, const curve *curves, double f_ns)
{
    static const double goals[4] = {1e-4, 1e-6, 1e-8, 1e-10};
    double loop[SETTINGS], evals = 0;
    int method, k;
    printf("\n%s, to t = %g; a call of f alone, dependent: %.1f ns\n", p->what, p->T, f_ns);
    printf("  %-12s microseconds (evaluations) to an error of\n  %-12s", "", "");
    for (k = 0; k < 4; k++) printf("%20.0e", goals[k]);
    puts("    ns/evaluation");
    for (method = 0; method < METHODS; method++) {
        const curve *c = curves + method;
        if (c->work[0].evals == 0) continue;
        printf("  %-12s", method_names[method]);
        for (k = 0; k < 4; k++) {
            double us = time_to(c, goals[k], &evals);
            if (us > 0) printf("%10.1f %9.0f", us, evals);
            else printf("%20s", "-");
        }
        printf("%17.1f\n", c->us[SETTINGS - 7] / (double)c->work[SETTINGS - 7].evals * 1e3);
    }
    for (k = 0; k < SETTINGS; k++) loop[k] = curves[RK4_SOLVE].us[k] / curves[RK4_LOOP].us[k];
    qsort(loop, SETTINGS, sizeof *loop, ascending);
    printf("  rk4_solve/rk4_loop %.2f (promised 1.05)", loop[SETTINGS / 2]);
    print_ratio("   to 1e-6: rk45_solve/dp54_loop", curves, RK45_SOLVE, DP54_LOOP, 1e-6, "(0.9)");
#ifdef WITH_GSL
    print_ratio(", gsl_rkf45/rk45_solve", curves, GSL_RKF45, RK45_SOLVE, 1e-6, "(2.5)");
    print_ratio("   to 1e-8: rk87_solve/gsl_rk8pd", curves, RK87_SOLVE, GSL_RK8PD, 1e-8, "(0.5)");
    print_ratio(", to 1e-10:", curves, RK87_SOLVE, GSL_RK8PD, 1e-10, "(0.5)");
#endif
    puts("");
}

static void write_csv(FILE *csv, const problem *p, const curve *curves, double f_ns)
{
    int method, k;
    for (method = 0; method < METHODS; method++)
        for (k = 0; k < SETTINGS; k++) {
            const curve *c = curves + method;
            double ns = c->us[k] * 1e3 / (double)c->work[k].evals;
            if (c->work[k].evals == 0) continue;
            fprintf(csv, "%s,%s,%g,%.3g,%ld,%ld,%.4g,%.3g,%.3g\n", p->name, method_names[method],
                    knob_of(method, k), c->error[k], c->work[k].evals, c->work[k].steps, c->us[k], ns, ns - f_ns);
        }
}

/* ---- right-hand sides that are not smooth: x'' = -x|x|^(alpha-1) over ten periods ---- */

typedef struct spring {
    double alpha, sign; /* sign: that of x, or 0 when f is to look for itself */
} spring;

static int spring_rhs(double t, const double *y, double *d, void *ctx)
{
    const spring *p = (const spring *)ctx;
    double force = p->alpha == 0 ? 1 : pow(fabs(y[0]), p->alpha);
    (void)t;
    d[0] = y[1], d[1] = -(p->sign == 0 ? copysign(force, y[0]) : p->sign * force);
    return 0;
}

static double position(double t, const double *y, void *ctx)
{
    (void)t, (void)ctx;
    return y[0];
}

static void turn_sign(double t, double *y, void *ctx)
{
    (void)t, (void)y;
    ((spring *)ctx)->sign *= -1;
}

/* error after ten periods; way: 0 plain, 1 restarted at x = 0, 2 with the sign kept in between */
static double non_smooth(int order, double alpha, double period, double tol, int way, long *evals)
{
    double y[2] = {1, 0}, work[RK87_WORK(2)];
    spring p;
    ode_event zero;
    rk45_options o = {0};
    rk45 s;
    p.alpha = alpha, p.sign = way == 2;
    memset(&zero, 0, sizeof zero);
    zero.g = position, zero.ctx = &p, zero.action = ODE_RESTART, zero.change = way == 2 ? turn_sign : NULL;
    o.rtol = o.atol = tol, o.events = &zero, o.n_events = way > 0;
    if ((order == 5 ? rk45_init : rk87_init)(&s, spring_rhs, &p, 2, 0, y, &o, work) < 0) return -1;
    if ((order == 5 ? rk45_solve(&s, 10 * period) : rk87_solve(&s, 10 * period)) < 0) puts("failed");
    *evals = s.evals;
    return fmax(fabs(s.y[0] - 1), fabs(s.y[1]));
}

static void print_non_smooth(void)
{
    static const double alpha[7] = {0, 0.25, 0.5, 1, 1.5, 2, 3},
                        period[7] = {5.6568542494923801952, 5.8167892020602425626, 5.9746736017774945048,
                                     6.2831853071795864769, 6.5813633886382630652, 6.8692613690176441976,
                                     7.4162987092054876737};
    static const char *const ways[3] = {"plain", "restarted at 0", "sign kept"};
    int k, way, order;
    puts("\nx'' = -x|x|^(alpha-1), ten periods: evaluations and error/tolerance at 1e-4, 1e-7, 1e-10; the order "
         "that results");
    for (order = 5; order <= 8; order += 3)
        for (k = 0; k < 7; k++)
            for (way = 0; way < (alpha[k] == 0 || alpha[k] == 2 ? 3 : 2);
                 way++) { /* sign |x|^alpha is smooth there */
                double error[3];
                long evals[3] = {0, 0, 0};
                int i;
                printf("  %-5s alpha %-4g %-15s", order == 5 ? "rk45" : "rk87", alpha[k], ways[way]);
                for (i = 0; i < 3; i++) {
                    error[i] = non_smooth(order, alpha[k], period[k], pow(10, -4 - 3 * i), way, evals + i);
                    printf(" %7ld %8.2g", evals[i], error[i] / pow(10, -4 - 3 * i));
                }
                printf("   order %.1f\n", log(error[0] / error[2]) / log((double)evals[2] / (double)evals[0]));
            }
}

int main(int argc, char **argv)
{
    static curve curves[METHODS];
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    size_t k;
    if (csv)
        fprintf(csv, "problem,method,tolerance or steps,error,evaluations,steps,us,ns per evaluation,beyond f\n");
    printf("Work and precision, medians of %d repeats\n", REPEATS);
    for (k = 0; k < sizeof problems / sizeof *problems; k++) {
        double y[4], f_ns;
        memcpy(y, problems[k].y0, sizeof y);
        f_ns = problems[k].ns(y);
        measure(problems + k, curves);
        print_problem(problems + k, curves, f_ns);
        if (csv) write_csv(csv, problems + k, curves, f_ns);
    }
    print_non_smooth();
    if (csv) {
        fclose(csv);
        printf("\nwrote %s\n", argv[1]);
    }
    return 0;
}
