/* What a digit of x(t) costs, by every route: the oscillator (m x')' + x|x|^(alpha-1) = 0, m = 1 + eps t, at 3/eps.

   alpha = 3 and 4/3, amplitude 1 at the start, at the Ateb phase psi0 = 0 (at rest) and 0.7. Routes:
     cos, cn, ca         closed forms of first order, x = m^-P cos(...) or alike, with the exponent P as the
                         dissertation prints it and as corrected, written down with the constants of Table 5 known
     vm_osc_by_route ...       the kit's routes: any laws of mass and stiffness, preparation and an estimate of the error in
                         the time; the integrators among them run twice or more for that
     vm_osc_plan_by_route ...  the same where the plan has been made beforehand
     vm_osc_closed_at ...    the law of order 2 or 5 as plain data, made beforehand
     vm_osc_within           the cheapest of these within a tolerance, by the kit's own choice
     ..._solve, GSL ...  integration of (x, m x') from 0 to t, nothing known of the error; the same right-hand side,
                         inlined by the kit, called through a pointer by GSL, whose driver is allocated beforehand
   ns is the time of one answer, x(3/eps), from the problem's numbers. error: the largest |error of x|/A at the times
   3/eps i/16, 0 < i <= 16, against the values of tests/gen/oscillator_reference.py, A the exact amplitude there. Who
   wants many answers pays less: "of 16" is the time of these sixteen, in one pass, by 16. The summary interpolates
   between the settings of a route.

   usage: oscillator [out.csv [quick]]. alpha = 3, psi0 = 0.7, eps = 0.01 is measured in full, the eleven other cases
   with fewer settings and repeats; quick: that one case alone, so. */
#include "timing.h"

#include "../varmass.h"
#include "arguments.h"
#ifdef WITH_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#endif

enum { ANSWERS = 16 };
static const double LONGEST_ANSWER = 2e7; /* ns */
/* Steps after which an integrator gives up: a motion that it lets grow without bound would never reach its end. */
enum { MOST_STEPS = 2000000 };
typedef struct oscillator_case {
    double alpha, eps, psi0, x0, v0, x[ANSWERS], A[ANSWERS];
} oscillator_case;
#include "../tests/data/oscillator_table.h"

static const oscillator_case *now;
static vm_osc_problem problem;
static double knob, times[ANSWERS], answers[ANSWERS];

/* ---- Closed forms of first order, as a reader of the dissertation would write them ---- */

enum { PRINTED, CORRECTED };
enum { COS, CN, CA };
typedef struct envelope {
    int wave;
    double P, start, rate, m; /* A = m^-P; angle of the wave at t = 0 and its rate; k^2 of cn */
} envelope;
static envelope form;

static double printed_exponent(int wave, double alpha, double m)
{
    const double C2 = 0.5, C4 = 0.375; /* as (396) takes them */
    const double s = (1 - m - (1 - 2 * m) * C2 - m * C4) / (1 - m + m * C4);
    if (wave == COS) return 1 / (5 - alpha);
    if (wave == CN) return s / (2 + (alpha - 1) * s);
    return 2 / (alpha + 3);
}

/* (293), (300), (307): the constants of Table 5 */
static void prepare_envelope(int wave, int corrected)
{
    const double alpha = now->alpha, rate = sqrt((alpha + 1) / 2); /* of the Ateb phase */
    double turn = 1;
    form.wave = wave;
    form.m = vm_osc_jacobi_parameter(alpha);
    if (wave == COS) turn = VM_PI / ateb_pi(alpha);
    if (wave == CN) turn = 2 * jacobi_K(form.m) / ateb_pi(alpha);
    form.P = corrected ? 1 / (alpha + 3) : printed_exponent(wave, alpha, form.m);
    form.start = turn * now->psi0;
    form.rate = turn * rate;
}

static double by_envelope_at(double t)
{
    const double m = 1 + now->eps * t, n = 0.5 - (now->alpha - 1) / 2 * form.P; /* the rate goes as m^(n-1) */
    const double way = (n == 0 ? log(m) : (pow(m, n) - 1) / n) / now->eps, theta = form.start + form.rate * way;
    const double amplitude = pow(m, -form.P);
    if (form.wave == COS) return amplitude * cos(theta);
    if (form.wave == CN) return amplitude * jacobi_cn(theta, form.m);
    return amplitude * ateb_ca(theta, now->alpha);
}

static void by_envelope(int n, const double *t, double *x)
{
    int i;
    for (i = 0; i < n; i++) x[i] = by_envelope_at(t[i]);
}

static void by_constant_mass(int n, const double *t, double *x)
{
    double v;
    int i;
    for (i = 0; i < n; i++) vm_osc_exact_from(t[i], now->x0, now->v0, 1, now->alpha, x + i, &v);
}

/* ---- The kit's routes ---- */

enum { AT = -1 };
static int route, prepared;
static vm_osc_plan plan;

static double by_plan(double t)
{
    vm_osc_motion motion;
    const int status = route == AT ? vm_osc_plan_within(&plan, t, knob, &motion)
                                   : vm_osc_plan_by_route(&plan, route, t, knob, &motion);
    return status < 0 ? VM_NAN : motion.x;
}

static double by_problem(double t)
{
    vm_osc_motion motion;
    const int status = route == AT ? vm_osc_within(&problem, t, knob, &motion)
                                   : vm_osc_by_route(&problem, route, t, knob, &motion);
    return status < 0 ? VM_NAN : motion.x;
}

static void by_kit(int n, const double *t, double *x)
{
    int i;
    if (n > 1 && !prepared) vm_osc_plan_init(&plan, &problem);
    for (i = 0; i < n; i++) x[i] = n > 1 || prepared ? by_plan(t[i]) : by_problem(t[i]);
}

static vm_osc_closed closed;

static void by_closed(int n, const double *t, double *x)
{
    double v;
    int i;
    for (i = 0; i < n; i++)
        if (vm_osc_closed_at(&closed, t[i], x + i, &v)) x[i] = VM_NAN;
}

/* ---- Integration of y = (x, m x') ---- */

static int cubic(double t, const double *y, double *dydt, void *ctx)
{
    dydt[0] = y[1] / (1 + *(const double *)ctx * t);
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

static int four_thirds(double t, const double *y, double *dydt, void *ctx)
{
    dydt[0] = y[1] / (1 + *(const double *)ctx * t);
    dydt[1] = -fabs(y[0]) * cbrt(y[0]);
    return 0;
}

static ode_rhs rhs(void) { return now->alpha == 3 ? cubic : four_thirds; }

/* The knob is the number of steps in a unit of time. */
static void by_rk4(int n, const double *t, double *x)
{
    double y[2] = {now->x0, now->v0}, work[RK4_WORK(2)], at = 0, eps = now->eps;
    int i;
    for (i = 0; i < n; i++) {
        const long steps = (long)ceil((t[i] - at) * knob);
        if (now->alpha == 3) rk4_solve(cubic, &eps, 2, &at, t[i], steps, y, work);
        else rk4_solve(four_thirds, &eps, 2, &at, t[i], steps, y, work);
        x[i] = y[0];
    }
}

#define BY_PAIR(name, WORK)                                                             \
    static void by_##name(int n, const double *t, double *x)                            \
    {                                                                                   \
        double y0[2] = {now->x0, now->v0}, work[WORK(2)], eps = now->eps;               \
        rk45_options options = {0};                                                     \
        rk45 s;                                                                         \
        int i, status;                                                                  \
        options.rtol = options.atol = knob;                                             \
        options.max_steps = MOST_STEPS;                                                 \
        status = name##_init(&s, rhs(), &eps, 2, 0, y0, &options, work);                \
        for (i = 0; i < n; i++) {                                                       \
            if (status >= 0)                                                            \
                status = now->alpha == 3 ? name##_solve_with(&s, cubic, 2, t[i])        \
                                         : name##_solve_with(&s, four_thirds, 2, t[i]); \
            x[i] = status < 0 ? VM_NAN : s.y[0];                                        \
        }                                                                               \
    }
BY_PAIR(rk45, RK45_WORK)
BY_PAIR(rk87, RK87_WORK)

#ifdef WITH_GSL
static gsl_odeiv2_driver *driver;
static gsl_odeiv2_system gsl_system;
static double gsl_eps;

static void prepare_gsl(int high)
{
    if (driver) gsl_odeiv2_driver_free(driver);
    gsl_eps = now->eps;
    gsl_system.function = rhs();
    gsl_system.dimension = 2;
    gsl_system.params = &gsl_eps;
    driver = gsl_odeiv2_driver_alloc_y_new(&gsl_system, high ? gsl_odeiv2_step_rk8pd : gsl_odeiv2_step_rkf45, 1e-2,
                                           knob, knob);
    gsl_odeiv2_driver_set_nmax(driver, MOST_STEPS);
}

static void by_gsl(int n, const double *t, double *x)
{
    double y[2] = {now->x0, now->v0}, at = 0;
    int i, status = gsl_odeiv2_driver_reset_hstart(driver, 1e-2);
    for (i = 0; i < n; i++) {
        if (status == GSL_SUCCESS) status = gsl_odeiv2_driver_apply(driver, &at, t[i], y);
        x[i] = status == GSL_SUCCESS ? y[0] : VM_NAN;
    }
}
#endif

/* ---- What is measured ---- */

static void (*through)(int n, const double *t, double *x); /* the route: x at n times */
static void one_answer(void) { through(1, times + ANSWERS - 1, answers + ANSWERS - 1); }
static void all_answers(void) { through(ANSWERS, times, answers); }

typedef struct result {
    const char *route;
    double error, ns;
} result;
static result results[256];
static int count, many; /* how many results; whether the sixteen answers are timed, or one */

/* The case of which more is measured */
static int is_flagship(const oscillator_case *c) { return c->alpha == 3 && c->psi0 > 0 && c->eps == 0.01; }

static double largest_error(void)
{
    double error = 0;
    int i;
    all_answers();
    for (i = 0; i < ANSWERS; i++) {
        const double e = fabs(answers[i] - now->x[i]) / now->A[i];
        if (!(e <= error) && error == error) error = e; /* NaN is the largest */
    }
    return error;
}

/* The line of the route `through` at the present knob. Without an answer there is no line. Returns the time, ns, or 0. */
static double measure_route(const char *name, const char *knob_format)
{
    char job[64], setting[16];
    const double error = largest_error();
    timing t;
    if (!(error < HUGE_VAL)) return 0;
    snprintf(job, sizeof job, "alpha=%s psi0=%g eps=%g%s", now->alpha == 3 ? "3" : "4/3", now->psi0, now->eps,
             many ? " of 16" : "");
    snprintf(setting, sizeof setting, knob_format, knob);
    if (many) t = measure(job, name, setting, error, all_answers, ANSWERS, "sin", sin_apart, WINDOW);
    else t = measure(job, name, setting, error, one_answer, 1, "sin", sin_apart, WINDOW);
    results[count].route = name;
    results[count].error = error;
    results[count].ns = t.ns;
    count++;
    return t.ns;
}

/* Lines over tolerances from 0.1 down, until it takes too long */
static void measure_tolerances(const char *name, double least, void (*prepare)(int), int argument)
{
    for (knob = 1e-1; knob > least * 0.99; knob /= bench_quick && is_flagship(now) ? 100 : 10) {
        prepare(argument);
        if (measure_route(name, "%.0e") > LONGEST_ANSWER) break;
    }
}

static void set_route(int which) { route = which; }
static void set_pair(int high) { through = high ? by_rk87 : by_rk45; }

static void measure_closed_forms(void)
{
    static const struct {
        const char *name;
        int wave, corrected;
    } forms[] = {{"cos (360) printed", COS, PRINTED}, {"cos corrected", COS, CORRECTED},
                 {"cn (396) printed", CN, PRINTED},   {"cn corrected", CN, CORRECTED},
                 {"ca (321) printed", CA, PRINTED},   {"ca (325)", CA, CORRECTED}};
    int i;
    through = by_constant_mass;
    measure_route("mass held constant (282)", "");
    through = by_envelope;
    for (i = 0; i < 6; i++) {
        prepare_envelope(forms[i].wave, forms[i].corrected);
        measure_route(forms[i].name, "");
    }
}

static void measure_kit(void)
{
    static const char *const names[] = {"vm_osc_by_route trig",        "vm_osc_by_route Jacobi",  "vm_osc_by_route Ateb",
                                        "vm_osc_by_route order 2",     "vm_osc_by_route order 3", "vm_osc_by_route order 4",
                                        "vm_osc_by_route order 5",     "vm_osc_by_route collocation",
                                        "vm_osc_by_route rk45",        "vm_osc_by_route rk87"};
    static const char *const planned[] = {"vm_osc_plan_by_route trig",    "vm_osc_plan_by_route Jacobi",
                                          "vm_osc_plan_by_route Ateb",    "vm_osc_plan_by_route order 2",
                                          "vm_osc_plan_by_route order 3", "vm_osc_plan_by_route order 4",
                                          "vm_osc_plan_by_route order 5"};
    through = by_kit;
    knob = 0;
    for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_ORDER5; route++) measure_route(names[route], "");
    prepared = vm_osc_plan_init(&plan, &problem) == VM_OK;
    for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_ORDER5; route++) measure_route(planned[route], "");
    prepared = 0;
    through = by_closed;
    if (!vm_osc_closed_init(&closed, &problem, 2, 3 / now->eps)) measure_route("vm_osc_closed_at order 2", "");
    if (!vm_osc_closed_init(&closed, &problem, 5, 3 / now->eps)) measure_route("vm_osc_closed_at order 5", "");
    through = by_kit;
    measure_tolerances("vm_osc_within", 1e-11, set_route, AT);
    for (route = VM_ROUTE_COLLOCATION; route <= (is_flagship(now) ? VM_ROUTE_RK87 : VM_ROUTE_COLLOCATION); route++)
        measure_tolerances(names[route], 1e-11, set_route, route);
}

static void measure_integrators(void)
{
    through = by_rk4;
    for (knob = 2; knob <= (bench_quick ? 32 : 256); knob *= 2) measure_route("rk4_solve", "h 1/%.0f");
    measure_tolerances("rk45_solve", 1e-13, set_pair, 0);
    measure_tolerances("rk87_solve", 1e-13, set_pair, 1);
#ifdef WITH_GSL
    through = by_gsl;
    measure_tolerances("GSL rkf45", 1e-13, prepare_gsl, 0);
    measure_tolerances("GSL rk8pd", 1e-13, prepare_gsl, 1);
#endif
}

/* ---- Summary: the cheapest route to an error ---- */

/* Time of results[i]'s route to an error: log-log between this setting and the one after, but by vm_osc that one's,
   since it may go from a law to an integrator there; VM_NAN: not by these */
static double time_to(double error, int i)
{
    const result *a = results + i, *b = a + 1;
    if (a->error <= error) return a->ns;
    if (i + 1 == count || b->route != a->route || !(b->error <= error)) return VM_NAN;
    if (!(a->error < HUGE_VAL) || strncmp(a->route, "vm_osc", 6) == 0) return b->ns;
    return a->ns * pow(b->ns / a->ns, log(error / a->error) / log(b->error / a->error));
}

/* Not what is made beforehand, plans and the law as data: they answer many questions, not one */
static int is_of(int gsl, const char *name)
{
    if (strncmp(name, "vm_osc_plan", 11) == 0 || strncmp(name, "vm_osc_closed", 13) == 0) return 0;
    return (strncmp(name, "GSL", 3) == 0) == gsl;
}

static double cheapest(double error, int gsl, const char **name)
{
    double least = VM_NAN;
    int i;
    *name = "-";
    for (i = 0; i < count; i++) {
        const double ns = time_to(error, i);
        if (is_of(gsl, results[i].route) && ns == ns && !(ns >= least)) {
            least = ns;
            *name = results[i].route;
        }
    }
    return least;
}

static void print_summary(void)
{
    double error;
    printf("\n%-9s %-24s %12s   %-10s %12s %9s\n", "error to", "the kit's cheapest", "ns", "GSL's", "ns",
           "GSL/kit");
    for (error = 1e-1; error > 0.99e-11; error /= 10) {
        const char *kit, *gsl;
        const double ours = cheapest(error, 0, &kit), theirs = cheapest(error, 1, &gsl);
        printf("%-9.0e %-24s", error, kit);
        if (ours == ours) printf(" %12.0f", ours);
        if (theirs == theirs) printf("   %-10s %12.0f", gsl, theirs);
        if (theirs / ours == theirs / ours) printf(" %9.2f%s", theirs / ours, theirs < ours ? "  GSL wins" : "");
        putchar('\n');
    }
    putchar('\n');
}

static void measure_case(const oscillator_case *c)
{
    int i;
    now = c;
    count = 0;
    for (i = 0; i < ANSWERS; i++) times[i] = 3 / c->eps * (i + 1) / ANSWERS;
    memset(&problem, 0, sizeof problem);
    problem.alpha = c->alpha;
    problem.mass = vm_law_linear(1, c->eps);
    problem.stiffness = vm_law_linear(1, 0);
    problem.reactive = 1;
    problem.x = c->x0;
    problem.v = c->v0;
    measure_closed_forms();
    measure_kit();
    measure_integrators();
    print_summary();
}

int main(int argc, char **argv)
{
    size_t i;
    int quick;
    bench_start(argc, argv, "x(3/eps) of (m x')' + x|x|^(alpha-1) = 0, m = 1 + eps t; error by the amplitude");
    quick = bench_quick;
    fill_angles();
#ifdef WITH_GSL
    gsl_set_error_handler_off();
#endif
    for (i = 0; i < sizeof oscillator_table / sizeof *oscillator_table; i++) {
        const oscillator_case *c = oscillator_table + i;
        const int flagship = is_flagship(c);
        if (quick && !flagship) continue;
        bench_quick = quick || !flagship; /* less often, else it takes ten minutes */
        measure_case(c);
        many = !bench_quick;
        if (many) measure_case(c);
        many = 0;
    }
    return bench_end();
}
