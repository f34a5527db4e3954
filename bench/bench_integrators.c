/* integrators.h: work against precision. For each problem and method the time of a run and the error at its end,
   over tolerances from 1e-3 to 1e-14 or numbers of steps; from that, by interpolation, the time to given errors, as
   a ratio to that of a hand-written Dormand-Prince loop (rk_loops.h); GSL's methods beside it. The CSV file has a
   line a setting (ratio: to 1000 steps of the hand-written RK4 loop) and a line an error; the table only the
   latter, with the evaluations as the knob. Then what right-hand sides that are not smooth cost, in evaluations. */
#include "timing.h"
#include "../integrators.h"
#include "problems.h"
#include "rk_loops.h"
#ifdef WITH_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#endif

enum { SETTINGS = 23, METHODS = 9, YARDSTICK_STEPS = 1000, TIMED_STEPS = 8192, MOST_EVALS = 100000 };
static volatile double sink;
static long calls; /* of f, where they are counted */

typedef struct result {
    long evals, steps;
} result;

/* ---- Methods, made for each problem ---- */

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
        r.evals = s.evals;                                                        \
        r.steps = s.steps + s.rejected;                                           \
        return r;                                                                 \
    }

/* The right-hand side as each method wants it, inlined, called through a pointer, and counted; and the methods made
   for it. knob: the tolerance, or the number of steps */
#define METHODS_FOR(name, n)                                                      \
    static inline void name##_counted(double t, const double *y, double *d)       \
    {                                                                             \
        calls++;                                                                  \
        name##_f(t, y, d);                                                        \
    }                                                                             \
    static inline int name##_rhs(double t, const double *y, double *d, void *ctx) \
    {                                                                             \
        (void)ctx;                                                                \
        name##_f(t, y, d);                                                        \
        return 0;                                                                 \
    }                                                                             \
    RK4_LOOP_OF(name, n, name##_f)                                                \
    DP54_LOOP_OF(name, n, name##_f)                                               \
    DP54_LOOP_OF(name##_counting, n, name##_counted)                              \
    static result name##_run_rk4_loop(double T, double knob, double *y)           \
    {                                                                             \
        result r = {4 * (long)knob, (long)knob};                                  \
        name##_rk4_loop(T, (long)knob, y);                                        \
        return r;                                                                 \
    }                                                                             \
    static result name##_run_rk4(double T, double knob, double *y)                \
    {                                                                             \
        result r = {4 * (long)knob, (long)knob};                                  \
        double work[RK4_WORK(n)], t = 0;                                          \
        rk4_solve(name##_rhs, NULL, n, &t, T, (long)knob, y, work);               \
        return r;                                                                 \
    }                                                                             \
    static result name##_run_dp54_loop(double T, double knob, double *y)          \
    {                                                                             \
        result r = {0, 0};                                                        \
        name##_dp54_loop(T, knob, y);                                             \
        return r;                                                                 \
    }                                                                             \
    static result name##_count_dp54_loop(double T, double knob, double *y)        \
    {                                                                             \
        result r;                                                                 \
        calls = 0;                                                                \
        name##_counting_dp54_loop(T, knob, y);                                    \
        r.evals = calls;                                                          \
        r.steps = calls / 6;                                                      \
        return r;                                                                 \
    }                                                                             \
    CONTROLLED_RUN(name, n, rk45, RK45_WORK)                                      \
    CONTROLLED_RUN(name, n, rk87, RK87_WORK)

METHODS_FOR(cubic, 2)
METHODS_FOR(mass, 2)
METHODS_FOR(momentum, 2)
METHODS_FOR(body, 3)
METHODS_FOR(orbit, 4)

typedef result (*runner)(double T, double knob, double *y);

#define METHODS_OF(name)                                                                               \
    {                                                                                                  \
        name##_rhs, name##_run_rk4_loop, name##_run_rk4, name##_run_dp54_loop, name##_count_dp54_loop, \
            name##_run_rk45, name##_run_rk87                                                           \
    }
static const struct methods {
    ode_rhs rhs;
    runner rk4_loop, rk4, dp54_loop, dp54_count, rk45, rk87;
} methods[PROBLEMS] = {METHODS_OF(cubic), METHODS_OF(mass), METHODS_OF(momentum), METHODS_OF(body),
                       METHODS_OF(orbit)};

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

static const gsl_odeiv2_step_type *gsl_type(int method)
{
    switch (method) {
    case GSL_RK4: return gsl_odeiv2_step_rk4;
    case GSL_RKF45: return gsl_odeiv2_step_rkf45;
    case GSL_RKCK: return gsl_odeiv2_step_rkck;
    default: return gsl_odeiv2_step_rk8pd;
    }
}

static result run_gsl(int k, int method, double knob, int count, double *y)
{
    const gsl_odeiv2_step_type *type = gsl_type(method);
    gsl_odeiv2_system system = {count ? count_calls : methods[k].rhs, NULL, (size_t)problems[k].n, NULL};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-3, knob, knob);
    double t = 0;
    result r;
    counted_rhs = methods[k].rhs;
    calls = 0;
    if (gsl_odeiv2_driver_apply(driver, &t, problems[k].T, y) != GSL_SUCCESS) puts("GSL failed");
    r.evals = calls;
    r.steps = (long)driver->n;
    gsl_odeiv2_driver_free(driver);
    return r;
}
#endif

static int fixed_step(int method) { return method == RK4_LOOP || method == RK4_SOLVE; }

static double knob_of(int method, int setting)
{
    return fixed_step(method) ? floor(pow(2, 8 + 0.5 * setting)) : pow(10, -3 - 0.5 * setting);
}

/* Problem k by a method; evaluations are counted where they are asked for */
static result run(int k, int method, double knob, int count, double *y)
{
    const struct methods *m = methods + k;
    const double T = problems[k].T;
    memcpy(y, problems[k].y0, sizeof problems[k].y0);
    switch (method) {
    case RK4_LOOP: return m->rk4_loop(T, knob, y);
    case RK4_SOLVE: return m->rk4(T, knob, y);
    case DP54_LOOP: return count ? m->dp54_count(T, knob, y) : m->dp54_loop(T, knob, y);
    case RK45_SOLVE: return m->rk45(T, knob, y);
    case RK87_SOLVE: return m->rk87(T, knob, y);
    }
#ifdef WITH_GSL
    return run_gsl(k, method, knob, count, y);
#else
    {
        const result none = {0, 0};
        return none;
    }
#endif
}

/* ---- Measuring ---- */

typedef struct curve {
    double error[SETTINGS];
    timing time[SETTINGS];
    result work[SETTINGS];
} curve;

static struct {
    int problem, method;
    double knob;
} now; /* what body runs */

static void body(void)
{
    double y[4];
    run(now.problem, now.method, now.knob, 0, y);
    sink = y[0];
}

static void yardstick(void)
{
    double y[4];
    run(now.problem, RK4_LOOP, YARDSTICK_STEPS, 0, y);
    sink = y[0];
}

/* Settings that a quick run leaves out are interpolated by their neighbours */
static int used(int setting) { return !bench_quick || setting % 3 == 0; }

/* A step of a fixed size takes as long as any other: of many only some are timed. The curves of the others end
   where a run takes too many evaluations to be timed in a slice. */
static void measure_curve(curve *c)
{
    int s;
    progress(method_names[now.method]);
    for (s = 0; s < SETTINGS; s++) {
        char knob[24];
        double y[4], runs;
        c->work[s].evals = 0;
        if (!used(s)) continue;
        now.knob = knob_of(now.method, s);
        c->work[s] = run(now.problem, now.method, now.knob, 1, y);
        c->error[s] = error_at_end(problems + now.problem, y);
        if (c->work[s].evals > MOST_EVALS && !fixed_step(now.method)) c->work[s].evals = 0;
        if (c->work[s].evals == 0) continue;
        snprintf(knob, sizeof knob, "%.3g", now.knob);
        runs = 1;
        if (fixed_step(now.method) && now.knob > TIMED_STEPS) {
            runs = TIMED_STEPS / now.knob;
            now.knob = TIMED_STEPS;
        }
        c->time[s] = time_beside(body, runs, yardstick, 1);
        bench_write_row(problems[now.problem].name, method_names[now.method], knob, c->error[s], c->time[s],
                        "rk4_loop; 1000 steps");
    }
}

/* In *time (ratio: to the yardstick) and evaluations, what an error takes, between the last setting that makes a
   larger one and the next; 0 if the error is not reached */
static int time_to(const curve *c, double goal, timing *time, double *evals)
{
    int before = -1, next = -1, s;
    double w;
    for (s = 0; s < SETTINGS; s++)
        if (used(s) && c->work[s].evals && !(c->error[s] <= goal)) before = s;
    for (s = SETTINGS - 1; s > before; s--)
        if (used(s)) next = s;
    if (before < 0 || next < 0 || c->work[next].evals == 0) return 0;
    w = log(goal / c->error[before]) / log(c->error[next] / c->error[before]);
    *evals = pow((double)c->work[before].evals, 1 - w) * pow((double)c->work[next].evals, w);
    time->ns = pow(c->time[before].ns, 1 - w) * pow(c->time[next].ns, w);
    time->ratio = pow(c->time[before].ratio, 1 - w) * pow(c->time[next].ratio, w);
    time->spread = fmax(c->time[before].spread, c->time[next].spread);
    return 1;
}

/* Time to errors, beside that of the hand-written Dormand-Prince loop */
static void print_times_to_errors(const curve *curves)
{
    int goal, method;
    for (goal = -4; goal >= -10; goal -= 2)
        for (method = 0; method < METHODS; method++) {
            timing time, loop;
            double evals, loop_evals;
            char job[40], knob[24];
            if (!time_to(curves + method, pow(10, goal), &time, &evals)) continue;
            if (!time_to(curves + DP54_LOOP, pow(10, goal), &loop, &loop_evals)) continue;
            time.ratio /= loop.ratio;
            snprintf(job, sizeof job, "%s to 1e%d", problems[now.problem].name, goal);
            snprintf(knob, sizeof knob, "%.0f f", evals);
            bench_row(job, method_names[method], knob, pow(10, goal), time, "dp54_loop");
        }
}

static void measure_problem(int k)
{
    static curve curves[METHODS];
    char job[40];
    double y[4];
    now.problem = k;
    for (now.method = 0; now.method < METHODS; now.method++) measure_curve(curves + now.method);
    print_times_to_errors(curves);
    now.method = RK4_SOLVE;
    now.knob = YARDSTICK_STEPS;
    run(k, now.method, now.knob, 0, y);
    snprintf(job, sizeof job, "%s, 1000 steps", problems[k].name);
    measure(job, "rk4_solve", "", error_at_end(problems + k, y), body, 1, "rk4_loop", yardstick, 1);
}

/* ---- Right-hand sides that are not smooth: x'' = -x|x|^(alpha-1) over ten periods ---- */

typedef struct spring {
    double alpha, sign; /* sign: that of x, or 0 when f is to look for itself */
} spring;

static int spring_rhs(double t, const double *y, double *d, void *ctx)
{
    const spring *p = (const spring *)ctx;
    double force = p->alpha == 0 ? 1 : pow(fabs(y[0]), p->alpha);
    (void)t;
    d[0] = y[1];
    d[1] = -(p->sign == 0 ? copysign(force, y[0]) : p->sign * force);
    return 0;
}

static double position(double t, const double *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static void turn_sign(double t, double *y, void *ctx)
{
    (void)t;
    (void)y;
    ((spring *)ctx)->sign *= -1;
}

/* Without events; an event at x = 0 restarts the run; the sign of x is kept between these events, too */
enum { PLAIN, RESTARTED, SIGN_KEPT };

/* The error after ten periods */
static double non_smooth(int order, double alpha, double period, double tol, int way, long *evals)
{
    double y[2] = {1, 0}, work[RK87_WORK(2)];
    spring p;
    ode_event zero;
    rk45_options o = {0};
    rk45 s;
    p.alpha = alpha;
    p.sign = way == SIGN_KEPT;
    memset(&zero, 0, sizeof zero);
    zero.g = position;
    zero.ctx = &p;
    zero.action = ODE_RESTART;
    zero.change = way == SIGN_KEPT ? turn_sign : NULL;
    o.rtol = o.atol = tol;
    o.events = &zero;
    o.n_events = way != PLAIN;
    if ((order == 5 ? rk45_init : rk87_init)(&s, spring_rhs, &p, 2, 0, y, &o, work) < 0) return -1;
    if ((order == 5 ? rk45_solve(&s, 10 * period) : rk87_solve(&s, 10 * period)) < 0) puts("failed");
    *evals = s.evals;
    return fmax(fabs(s.y[0] - 1), fabs(s.y[1]));
}

static void print_way(int order, double alpha, double period, int way)
{
    static const char *const ways[3] = {"plain", "restarted at 0", "sign kept"};
    double error[3];
    long evals[3] = {0, 0, 0};
    int i;
    printf("  %-5s alpha %-4g %-15s", order == 5 ? "rk45" : "rk87", alpha, ways[way]);
    for (i = 0; i < 3; i++) {
        const double tol = pow(10, -4 - 3 * i);
        error[i] = non_smooth(order, alpha, period, tol, way, evals + i);
        printf(" %7ld %8.2g", evals[i], error[i] / tol);
    }
    printf("   order %.1f\n", log(error[0] / error[2]) / log((double)evals[2] / (double)evals[0]));
}

static void print_non_smooth(void)
{
    static const double alpha[7] = {0, 0.25, 0.5, 1, 1.5, 2, 3};
    static const double period[7] = {5.6568542494923801952, 5.8167892020602425626, 5.9746736017774945048,
                                     6.2831853071795864769, 6.5813633886382630652, 6.8692613690176441976,
                                     7.4162987092054876737};
    int order, k;
    puts("\nx'' = -x|x|^(alpha-1), ten periods: evaluations and error/tolerance at 1e-4, 1e-7, 1e-10; the order "
         "that results");
    for (order = 5; order <= 8; order += 3) {
        for (k = 0; k < 7; k++) {
            print_way(order, alpha[k], period[k], PLAIN);
            print_way(order, alpha[k], period[k], RESTARTED);
            /* with its sign kept, |x|^alpha is smooth for these alone */
            if (alpha[k] == 0 || alpha[k] == 2) print_way(order, alpha[k], period[k], SIGN_KEPT);
        }
    }
}

int main(int argc, char **argv)
{
    int k;
    bench_start(argc, argv, "integrators.h, time of a run, beside a hand-written Dormand-Prince loop");
    for (k = 0; k < PROBLEMS; k++) measure_problem(k);
    print_non_smooth();
    return bench_end();
}
