/* varmass.h: free rotation in closed form beside integration by rk4, rk45, rk87 (integrators.h) and GSL's rk8pd. The
   error of the attitude after 1 to 1e6 turns, in rad, is taken against 60-digit values (tests/gen/rotation_reference.py).
   The time is that from the body's numbers to the attitude; of the closed form also that of each further attitude.

   All methods integrate Euler's equations and q' = q omega/2, the kit with the right-hand side inlined, GSL through a
   pointer, its driver allocated beforehand; knob: the tolerance, or the steps in a turn. A run that would take longer
   than LIMIT seconds is left out; one that takes more than 0.05 s is timed once, and its spread is 0.

   usage: rotation [out.csv [quick]] */
#include "timing.h"

#include "../varmass.h"
#include "arguments.h"
#ifdef WITH_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#endif

enum { DECADES = 7, TIMES = 256 };
static const double LIMIT = 10, QUICK_LIMIT = 0.02; /* s, of one run; of all but the first body LIMIT/20 */

typedef struct turned_body {
    const char *name;
    vm_vec3 moments, omega;
    struct {
        double t;
        vm_quat q;
    } after[DECADES];
} turned_body;
#include "../tests/data/rotation_turns.h"

static const vm_quat unit = {1, 0, 0, 0};
static const turned_body *body;
static vm_vec3 moments;
static double t_end, turns, knob, some_times[TIMES];
static vm_torque_free motion;
static vm_quat reached;

/* ---- Routes: from the body's numbers to the attitude at t_end ---- */

static void by_closed_form(void)
{
    vm_vec3 omega;
    vm_torque_free_init_principal(&motion, body->moments, unit, body->omega, 0);
    vm_torque_free_attitude(&motion, t_end, &reached, &omega);
}

static int free_rhs(double t, const double *y, double *dydt, void *ctx)
{
    const vm_vec3 J = *(const vm_vec3 *)ctx;
    (void)t;
    dydt[0] = (J.y - J.z) * y[1] * y[2] / J.x;
    dydt[1] = (J.z - J.x) * y[2] * y[0] / J.y;
    dydt[2] = (J.x - J.y) * y[0] * y[1] / J.z;
    dydt[3] = -(y[4] * y[0] + y[5] * y[1] + y[6] * y[2]) / 2;
    dydt[4] = (y[3] * y[0] + y[5] * y[2] - y[6] * y[1]) / 2;
    dydt[5] = (y[3] * y[1] + y[6] * y[0] - y[4] * y[2]) / 2;
    dydt[6] = (y[3] * y[2] + y[4] * y[1] - y[5] * y[0]) / 2;
    return 0;
}

static void start(double *y)
{
    y[0] = body->omega.x;
    y[1] = body->omega.y;
    y[2] = body->omega.z;
    y[3] = 1;
    y[4] = y[5] = y[6] = 0;
}

static void take(const double *y, int ok)
{
    reached.w = ok ? y[3] : VM_NAN;
    reached.x = y[4];
    reached.y = y[5];
    reached.z = y[6];
}

static void by_rk4(void)
{
    double y[7], work[RK4_WORK(7)], t = 0;
    start(y);
    take(y, rk4_solve(free_rhs, &moments, 7, &t, t_end, (long)(knob * turns), y, work) >= 0);
}

#define BY_PAIR(name, WORK)                                           \
    static void by_##name(void)                                       \
    {                                                                 \
        double y[7], work[WORK(7)];                                   \
        rk45_options options = {0};                                   \
        rk45 s;                                                       \
        start(y);                                                     \
        options.rtol = options.atol = knob;                           \
        options.max_steps = -1;                                       \
        name##_init(&s, free_rhs, &moments, 7, 0, y, &options, work); \
        take(s.y, name##_solve_with(&s, free_rhs, 7, t_end) >= 0);    \
    }
BY_PAIR(rk45, RK45_WORK)
BY_PAIR(rk87, RK87_WORK)

#ifdef WITH_GSL
static gsl_odeiv2_driver *driver;

static void prepare_gsl(void)
{
    static gsl_odeiv2_system system;
    if (driver) gsl_odeiv2_driver_free(driver);
    system.function = free_rhs;
    system.dimension = 7;
    system.params = &moments;
    driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-2, knob, knob);
}

static void by_rk8pd(void)
{
    double y[7], t = 0;
    start(y);
    gsl_odeiv2_driver_reset_hstart(driver, 1e-2);
    take(y, gsl_odeiv2_driver_apply(driver, &t, t_end, y) == GSL_SUCCESS);
}
#endif

/* ---- Error and time over turns ---- */

/* The angle between an attitude and the one that was reached */
static double error_of(vm_quat q)
{
    const vm_quat r = reached;
    const double w = r.w * q.w + r.x * q.x + r.y * q.y + r.z * q.z;
    const double x = q.w * r.x - q.x * r.w + q.z * r.y - q.y * r.z;
    const double y = q.w * r.y - q.y * r.w + q.x * r.z - q.z * r.x;
    const double z = q.w * r.z - q.z * r.w + q.y * r.x - q.x * r.y;
    return 2 * atan2(sqrt(x * x + y * y + z * z), fabs(w));
}

/* The first run; long ones are not repeated */
static timing time_once(void (*run)(void), double sin_ns)
{
    const double from = seconds();
    timing t;
    run();
    t.ns = (seconds() - from) * 1e9;
    t.ratio = t.ns / sin_ns;
    t.spread = 0;
    return t.ns < 5e7 ? time_beside(run, 1, sin_apart, WINDOW) : t;
}

/* Seconds that a run of this body may take */
static double time_limit(void)
{
    if (bench_quick) return QUICK_LIMIT;
    return body == turned_bodies ? LIMIT : LIMIT / 20;
}

static void over_turns(const char *name, const char *knob_text, void (*run)(void))
{
    const double sin_ns = call_ns(sin_apart, WINDOW), limit = time_limit();
    timing t = {0, 0, 0};
    int i;
    for (i = 0, turns = 1; i < DECADES && t.ns * 10 < limit * 1e9; i++, turns *= 10) {
        char job[64];
        t_end = body->after[i].t;
        snprintf(job, sizeof job, "%s 1e%d", body->name, i);
        progress(name);
        t = time_once(run, sin_ns);
        bench_row(job, name, knob_text, error_of(body->after[i].q), t, "sin");
    }
}

static void compare(void)
{
    static const struct {
        const char *name, *knob;
        void (*run)(void);
    } integrators[] = {{"rk4_solve", "32", by_rk4},      {"rk4_solve", "128", by_rk4},
                       {"rk45_solve", "1e-06", by_rk45}, {"rk45_solve", "1e-09", by_rk45},
                       {"rk45_solve", "1e-12", by_rk45}, {"rk87_solve", "1e-06", by_rk87},
                       {"rk87_solve", "1e-09", by_rk87}, {"rk87_solve", "1e-12", by_rk87},
#ifdef WITH_GSL
                       {"GSL rk8pd", "1e-06", by_rk8pd}, {"GSL rk8pd", "1e-09", by_rk8pd},
                       {"GSL rk8pd", "1e-12", by_rk8pd}
#endif
    };
    size_t i;
    moments = body->moments;
    over_turns("exact", "", by_closed_form);
    for (i = 0; i < sizeof integrators / sizeof *integrators; i++) {
        knob = atof(integrators[i].knob);
#ifdef WITH_GSL
        if (integrators[i].run == by_rk8pd) prepare_gsl();
#endif
        over_turns(integrators[i].name, integrators[i].knob, integrators[i].run);
    }
}

/* ---- The closed form alone: at any time, and its preparation ---- */

static void evaluate(void)
{
    double sum = 0;
    int i;
    for (i = 0; i < TIMES; i++) {
        vm_vec3 omega;
        vm_torque_free_attitude(&motion, some_times[i], &reached, &omega);
        sum += omega.x;
    }
    sink = sum;
}

static void prepare(void) { vm_torque_free_init_principal(&motion, body->moments, unit, body->omega, 0); }

static void prepare_tilted(void)
{
    static const vm_inertia tilted = {3, 2, 2.5, 0.1, 0.2, -0.3};
    vm_body b = {1, {0, 0, 0, 0, 0, 0}, {1, 2, 3, 4}, {0, 0, 0}, {0, 0, 0}, {1, 2, 3}};
    b.inertia = tilted;
    if (vm_torque_free_init(&motion, &b, 0) == VM_OK) sink = motion.phase_rate.hi;
}

/* Bodies whose attitude after many turns is not compared */
enum { KINDS = 4 };
static const turned_body kinds_of_motion[KINDS] = {
    {"triaxial", {3, 2, 1}, {0.25, 0.5, 1.5}, {{0, {0, 0, 0, 0}}}},
    {"m > 1/2", {3, 2, 1}, {0.2, 1, 0.5}, {{0, {0, 0, 0, 0}}}},
    {"middle axis", {3, 2, 1}, {1e-6, 1, 1e-6}, {{0, {0, 0, 0, 0}}}},
    {"symmetric", {2, 2, 1}, {0.5, 1.25, -0.75}, {{0, {0, 0, 0, 0}}}},
};

static void closed_form(void)
{
    int i;
    for (i = 0; i < TIMES; i++) some_times[i] = between(0, 1e4);
    for (i = 0; i < KINDS; i++) {
        body = kinds_of_motion + i;
        prepare();
        measure(body->name, "prepared motion", "", NO_ERROR, evaluate, TIMES, "sin", sin_apart, WINDOW);
        measure(body->name, "preparation", "", NO_ERROR, prepare, 1, "sin", sin_apart, WINDOW);
    }
    measure("with products of inertia", "preparation", "", NO_ERROR, prepare_tilted, 1, "sin", sin_apart, WINDOW);
}

int main(int argc, char **argv)
{
    size_t i;
    bench_start(argc, argv, "free rotation in closed form and integrated; error in rad");
    fill_angles();
    closed_form();
    for (i = 0; i < sizeof turned_bodies / sizeof *turned_bodies; i++) {
        body = turned_bodies + i;
        if (i == 0 || !bench_quick) compare();
    }
    return bench_end();
}
