// peers_ode.cpp - the kit beside the integrators of GSL, Boost.odeint and SUNDIALS: integrators on the problems of
// problems.h; the motion x(3/eps) of an oscillator with growing mass in the twelve cases of tests/data/oscillator_table.h;
// and the attitude of a free body after 100 turns. Each method runs with tolerances from 1e-3 to 1e-14, four a decade,
// for motions two; the time to an error is that of its quickest run whose error at the end is no larger. The error of an
// oscillator is the largest at four ends, by the amplitude. A peer wins where it takes less than MARGIN of the time of
// the kit's quickest method.
// A line of the first table for each problem, error and library, by the library's quickest method, and of the second table
// for each motion and error, by the quickest of all peers. A line ends with the word "wins" where the peer does; the exit
// status is 1 where one does. All call the same right-hand side through a pointer, odeint by a function object.
#include "timing.h"
#include "../varmass.h"
#include "problems.h"
#ifdef WITH_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#endif
#ifdef WITH_BOOST
#include <array>
#include <boost/numeric/odeint.hpp>
#endif
#ifdef WITH_SUNDIALS
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#endif

enum { SETTINGS = 45, GOALS = 6, MOST_CALLS = 200000, TIMED_RUNS = 7, MOST_COMPONENTS = 7 };
// A change of the orbit's initial values by their rounding moves its end by 5e-11: lesser errors there than this are chance.
static const double MARGIN = 0.9, LEAST_OF_ORBIT = 1e-9, goals[GOALS] = {1e-4, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12};

// What is integrated now, from 0 to T
struct task {
    void (*f)(double t, const double *y, double *d);
    int n;
    double T, y0[MOST_COMPONENTS];
};
static task now;
static long calls;

static int rhs(double t, const double *y, double *d, void *)
{
    now.f(t, y, d);
    return ++calls > MOST_CALLS; // which makes every method give up
}

// ---- Motions that the kit knows without integrating ----

enum { ANSWERS = 16, DECADES = 7, TURNS = 2 }; // the attitude after 10^TURNS turns
struct oscillator_case {
    double alpha, eps, psi0, x0, v0, x[ANSWERS], A[ANSWERS];
};
#include "../tests/data/oscillator_table.h"
struct turned_body {
    const char *name;
    vm_vec3 moments, omega;
    struct {
        double t;
        vm_quat q;
    } after[DECADES];
};
#include "../tests/data/rotation_turns.h"

static const oscillator_case *oscillator; // NULL where the task is none
static const turned_body *body;

// y = x, m x', with m = 1 + eps t
static void oscillator_f(double t, const double *y, double *d)
{
    d[0] = y[1] / (1 + oscillator->eps * t);
    if (oscillator->alpha == 3) d[1] = -y[0] * y[0] * y[0];
    else d[1] = -fabs(y[0]) * cbrt(y[0]); // alpha = 4/3
}

// Angular velocity and attitude
static void rotation_f(double, const double *y, double *d)
{
    const vm_vec3 J = body->moments;
    d[0] = (J.y - J.z) * y[1] * y[2] / J.x;
    d[1] = (J.z - J.x) * y[2] * y[0] / J.y;
    d[2] = (J.x - J.y) * y[0] * y[1] / J.z;
    d[3] = -(y[4] * y[0] + y[5] * y[1] + y[6] * y[2]) / 2;
    d[4] = (y[3] * y[0] + y[5] * y[2] - y[6] * y[1]) / 2;
    d[5] = (y[3] * y[1] + y[6] * y[0] - y[4] * y[2]) / 2;
    d[6] = (y[3] * y[2] + y[4] * y[1] - y[5] * y[0]) / 2;
}

// The angle between the attitude in y and the one after 100 turns
static double attitude_error(const double *y)
{
    const vm_quat q = body->after[TURNS].q;
    const double w = y[3] * q.w + y[4] * q.x + y[5] * q.y + y[6] * q.z;
    const double a = q.w * y[4] - q.x * y[3] + q.z * y[5] - q.y * y[6];
    const double b = q.w * y[5] - q.y * y[3] + q.x * y[6] - q.z * y[4];
    const double c = q.w * y[6] - q.z * y[3] + q.y * y[4] - q.x * y[5];
    return 2 * atan2(sqrt(a * a + b * b + c * c), fabs(w));
}

// Each returns 1, with y at T, or 0 where it gave up
typedef int (*method)(double tolerance, double *y);

// ---- The kit ----

static int by_osc_within(double tolerance, double *y)
{
    vm_osc_problem o = vm_osc_problem();
    vm_osc_motion motion = vm_osc_motion();
    if (!oscillator) return 0;
    o.alpha = oscillator->alpha;
    o.mass = vm_law_linear(1, oscillator->eps);
    o.stiffness = vm_law_linear(1, 0);
    o.reactive = 1;
    o.x = oscillator->x0;
    o.v = oscillator->v0;
    if (vm_osc_within(&o, now.T, tolerance, &motion) < 0) return 0;
    y[0] = motion.x;
    return 1;
}

static int by_torque_free(double, double *y)
{
    const vm_quat start = {1, 0, 0, 0};
    vm_torque_free motion;
    vm_quat q = start;
    vm_vec3 omega;
    if (!body || vm_torque_free_init_principal(&motion, body->moments, start, body->omega, 0)) return 0;
    if (vm_torque_free_attitude(&motion, now.T, &q, &omega)) return 0;
    y[3] = q.w, y[4] = q.x, y[5] = q.y, y[6] = q.z;
    return 1;
}

static int by_rk45(double tolerance, double *y)
{
    double work[RK45_WORK(MOST_COMPONENTS)];
    rk45_options o = rk45_options();
    rk45 s;
    o.rtol = o.atol = tolerance;
    if (rk45_init(&s, rhs, NULL, now.n, 0, y, &o, work) < 0 || rk45_solve(&s, now.T) < 0) return 0;
    memcpy(y, s.y, (size_t)now.n * sizeof *y);
    return 1;
}

static int by_rk87(double tolerance, double *y)
{
    double work[RK87_WORK(MOST_COMPONENTS)];
    rk45_options o = rk45_options();
    rk45 s;
    o.rtol = o.atol = tolerance;
    if (rk87_init(&s, rhs, NULL, now.n, 0, y, &o, work) < 0 || rk87_solve(&s, now.T) < 0) return 0;
    memcpy(y, s.y, (size_t)now.n * sizeof *y);
    return 1;
}

// ---- GSL ----

#ifdef WITH_GSL
static int by_gsl(const gsl_odeiv2_step_type *type, double tolerance, double *y)
{
    gsl_odeiv2_system system = {rhs, NULL, (size_t)now.n, NULL};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-3, tolerance, tolerance);
    double t = 0;
    const int status = gsl_odeiv2_driver_apply(driver, &t, now.T, y);
    gsl_odeiv2_driver_free(driver);
    return status == GSL_SUCCESS;
}
static int by_gsl_rkf45(double tolerance, double *y) { return by_gsl(gsl_odeiv2_step_rkf45, tolerance, y); }
static int by_gsl_rkck(double tolerance, double *y) { return by_gsl(gsl_odeiv2_step_rkck, tolerance, y); }
static int by_gsl_rk8pd(double tolerance, double *y) { return by_gsl(gsl_odeiv2_step_rk8pd, tolerance, y); }
static int by_gsl_msadams(double tolerance, double *y) { return by_gsl(gsl_odeiv2_step_msadams, tolerance, y); }
#endif

// ---- Boost.odeint ----

#ifdef WITH_BOOST
struct too_many_calls {};

template <size_t n> struct state_rhs {
    void operator()(const std::array<double, n> &y, std::array<double, n> &d, double t) const
    {
        if (rhs(t, y.data(), d.data(), NULL)) throw too_many_calls();
    }
};

template <template <class...> class stepper, size_t n> static int by_odeint_of(double tolerance, double *y)
{
    typedef std::array<double, n> state;
    state at;
    for (size_t i = 0; i < n; i++) at[i] = y[i];
    try {
        boost::numeric::odeint::integrate_adaptive(
            boost::numeric::odeint::make_controlled(tolerance, tolerance, stepper<state>()), state_rhs<n>(), at, 0.,
            now.T, 1e-3);
    } catch (...) {
        return 0;
    }
    for (size_t i = 0; i < n; i++) y[i] = at[i];
    return 1;
}


#define ODEINT(name)                                              \
    static int by_odeint_##name(double tolerance, double *y)      \
    {                                                             \
        switch (now.n) {                                         \
        case 2: return by_odeint_of<name##_any, 2>(tolerance, y); \
        case 3: return by_odeint_of<name##_any, 3>(tolerance, y); \
        case 4: return by_odeint_of<name##_any, 4>(tolerance, y); \
        default: return by_odeint_of<name##_any, 7>(tolerance, y); \
        }                                                         \
    }
template <class... state> using dopri5_any = boost::numeric::odeint::runge_kutta_dopri5<state...>;
template <class... state> using fehlberg78_any = boost::numeric::odeint::runge_kutta_fehlberg78<state...>;
ODEINT(dopri5)
ODEINT(fehlberg78)
#endif

// ---- SUNDIALS ----

#ifdef WITH_SUNDIALS
static SUNContext context;

static int sundials_rhs(realtype t, N_Vector y, N_Vector d, void *)
{
    return rhs(t, N_VGetArrayPointer(y), N_VGetArrayPointer(d), NULL) ? -1 : 0;
}

static int by_cvode(double tolerance, double *y)
{
    N_Vector at = N_VMake_Serial(now.n, y, context);
    void *solver = CVodeCreate(CV_ADAMS, context);
    SUNNonlinearSolver nonlinear = SUNNonlinSol_FixedPoint(at, 0, context);
    double t;
    int ok = CVodeInit(solver, sundials_rhs, 0, at) == CV_SUCCESS;
    ok = ok && CVodeSStolerances(solver, tolerance, tolerance) == CV_SUCCESS;
    ok = ok && CVodeSetNonlinearSolver(solver, nonlinear) == CV_SUCCESS;
    ok = ok && CVodeSetMaxNumSteps(solver, MOST_CALLS) == CV_SUCCESS;
    ok = ok && CVodeSetStopTime(solver, now.T) == CV_SUCCESS;
    ok = ok && CVode(solver, now.T, at, &t, CV_NORMAL) >= 0;
    CVodeFree(&solver);
    SUNNonlinSolFree(nonlinear);
    N_VDestroy(at);
    return ok;
}

static int by_arkode(ARKODE_ERKTableID table, double tolerance, double *y)
{
    N_Vector at = N_VMake_Serial(now.n, y, context);
    void *solver = ERKStepCreate(sundials_rhs, 0, at, context);
    double t;
    int ok = ERKStepSetTableNum(solver, table) == ARK_SUCCESS;
    ok = ok && ERKStepSStolerances(solver, tolerance, tolerance) == ARK_SUCCESS;
    ok = ok && ERKStepSetMaxNumSteps(solver, MOST_CALLS) == ARK_SUCCESS;
    ok = ok && ERKStepSetStopTime(solver, now.T) == ARK_SUCCESS;
    ok = ok && ERKStepEvolve(solver, now.T, at, &t, ARK_NORMAL) >= 0;
    ERKStepFree(&solver);
    N_VDestroy(at);
    return ok;
}
static int by_dormand_prince(double tolerance, double *y)
{
    return by_arkode(ARKODE_DORMAND_PRINCE_7_4_5, tolerance, y);
}
static int by_verner(double tolerance, double *y) { return by_arkode(ARKODE_VERNER_8_5_6, tolerance, y); }
static int by_fehlberg(double tolerance, double *y) { return by_arkode(ARKODE_FEHLBERG_13_7_8, tolerance, y); }
#endif

static const struct {
    const char *maker, *name;
    method run;
} methods[] = {{"", "`rk45_solve`", by_rk45},
               {"", "`rk87_solve`", by_rk87},
               {"", "`vm_osc_within`", by_osc_within},
               {"", "`vm_torque_free_attitude`", by_torque_free},
#ifdef WITH_GSL
               {"GSL", "`rkf45`", by_gsl_rkf45},
               {"GSL", "`rkck`", by_gsl_rkck},
               {"GSL", "`rk8pd`", by_gsl_rk8pd},
               {"GSL", "`msadams`", by_gsl_msadams},
#endif
#ifdef WITH_BOOST
               {"odeint", "`dopri5`", by_odeint_dopri5},
               {"odeint", "`fehlberg78`", by_odeint_fehlberg78},
#endif
#ifdef WITH_SUNDIALS
               {"CVODE", "Adams", by_cvode},
               {"ARKODE", "Dormand and Prince", by_dormand_prince},
               {"ARKODE", "Verner 8(5,6)", by_verner},
               {"ARKODE", "Fehlberg 7(8)", by_fehlberg},
#endif
};
enum { METHODS = sizeof methods / sizeof *methods };

// ---- Measuring ----

static double error[METHODS][SETTINGS], least[METHODS][SETTINGS]; // least: seconds, HUGE_VAL where it gave up

static const problem *smooth; // the problem of problems.h, NULL where the task is a motion

static int run(int k, double tolerance, double *y)
{
    calls = 0;
    memcpy(y, now.y0, sizeof now.y0);
    return methods[k].run(tolerance, y);
}

// The error of method k at this tolerance, HUGE_VAL where it gives up
static double error_at(int k, double tolerance)
{
    const int ends = oscillator ? 4 : 1;
    double y[MOST_COMPONENTS], largest = 0;
    for (int end = ANSWERS - ends; end < ANSWERS; end++) {
        double e;
        if (oscillator) now.T = 3 / oscillator->eps * (end + 1) / ANSWERS; // the last one is that which is timed
        if (!run(k, tolerance, y)) return HUGE_VAL;
        if (oscillator) e = fabs(y[0] - oscillator->x[end]) / oscillator->A[end];
        else if (body) e = attitude_error(y);
        else e = error_at_end(smooth, y);
        if (!(e <= largest)) largest = e;
    }
    return largest;
}

// Errors and least times of all methods at one tolerance; runs of the methods take turns
static void measure_setting(int setting, int turns)
{
    const double tolerance = pow(10, -3 - 0.25 * setting);
    for (int k = 0; k < METHODS; k++) {
        least[k][setting] = HUGE_VAL;
        error[k][setting] = error_at(k, tolerance);
    }
    for (int turn = 0; turn < turns; turn++)
        for (int k = 0; k < METHODS; k++) {
            double y[MOST_COMPONENTS];
            const double start = seconds();
            long runs = 0;
            if (error[k][setting] == HUGE_VAL) continue;
            do {
                run(k, tolerance, y);
                runs++;
            } while (seconds() - start < SLICE);
            least[k][setting] = fmin(least[k][setting], (seconds() - start) / (double)runs);
        }
}

// Every so many of the tolerances
static void measure_all(int step, int turns)
{
    for (int s = 0; s < SETTINGS; s++)
        for (int k = 0; k < METHODS; k++) error[k][s] = least[k][s] = HUGE_VAL;
    for (int s = 0; s < SETTINGS; s += step) measure_setting(s, turns);
}

// Seconds of the quickest run of method k with no more than this error, HUGE_VAL where there is none
static double time_to(int k, double goal)
{
    double quickest = HUGE_VAL;
    for (int s = 0; s < SETTINGS; s++)
        if (error[k][s] <= goal) quickest = fmin(quickest, least[k][s]);
    return quickest;
}

// The first method of the next library
static int next_library(int k)
{
    const char *maker = methods[k].maker;
    while (k < METHODS && strcmp(methods[k].maker, maker) == 0) k++;
    return k;
}

// The quickest method from `first` up to the one before `end`
static int quickest_of(int first, int end, double goal)
{
    int best = first;
    for (int k = first; k < end; k++)
        if (time_to(k, goal) < time_to(best, goal)) best = k;
    return best;
}

// A line of a table; returns 1 where the peer wins
static int print_line(const char *what, double goal, int ours, int peer)
{
    const double kit = time_to(ours, goal), theirs = time_to(peer, goal);
    const int won = theirs < MARGIN * kit;
    if (theirs == HUGE_VAL) return 0;
    printf("| %s | %.0e | %s | %.1f | %s %s | %.1f | %.2g |%s\n", what, goal, methods[ours].name, 1e6 * kit,
           methods[peer].maker, methods[peer].name, 1e6 * theirs, kit / theirs, won ? " wins" : "");
    fflush(stdout);
    return won;
}

// The lines of a problem, a line a library; returns how often a peer wins
static int compare()
{
    const int first_peer = next_library(0);
    int wins = 0;
    measure_all(1, TIMED_RUNS);
    for (int g = 0; g < GOALS; g++) {
        const int ours = quickest_of(0, first_peer, goals[g]);
        if (now.f == orbit_f && goals[g] < LEAST_OF_ORBIT) continue;
        for (int first = first_peer; first < METHODS; first = next_library(first))
            wins += print_line(smooth->what, goals[g], ours, quickest_of(first, next_library(first), goals[g]));
    }
    return wins;
}

// The lines of a motion, by the quickest of all peers; returns how often a peer wins
static int compare_motion(const char *what)
{
    const int first_peer = next_library(0), motion_turns = 3;
    int wins = 0;
    measure_all(2, motion_turns);
    for (int g = 0; g < GOALS; g++)
        wins += print_line(what, goals[g], quickest_of(0, first_peer, goals[g]),
                           quickest_of(first_peer, METHODS, goals[g]));
    return wins;
}

static int compare_problems()
{
    int wins = 0;
    for (int i = 0; i < PROBLEMS; i++) {
        smooth = problems + i;
        now.f = smooth->f;
        now.n = smooth->n;
        now.T = smooth->T;
        memcpy(now.y0, smooth->y0, sizeof smooth->y0);
        wins += compare();
    }
    smooth = NULL;
    return wins;
}

static int compare_oscillators()
{
    int wins = 0;
    now.f = oscillator_f;
    now.n = 2;
    for (const oscillator_case &c : oscillator_table) {
        char what[80];
        oscillator = &c;
        now.y0[0] = c.x0;
        now.y0[1] = c.v0;
        snprintf(what, sizeof what, "oscillator, alpha = %s, psi0 = %g, eps = %g", c.alpha == 3 ? "3" : "4/3", c.psi0, c.eps);
        wins += compare_motion(what);
    }
    oscillator = NULL;
    return wins;
}

static int compare_rotations()
{
    int wins = 0;
    now.f = rotation_f;
    now.n = 7;
    for (const turned_body &b : turned_bodies) {
        const double y0[MOST_COMPONENTS] = {b.omega.x, b.omega.y, b.omega.z, 1, 0, 0, 0};
        char what[80];
        body = &b;
        now.T = b.after[TURNS].t;
        memcpy(now.y0, y0, sizeof y0);
        snprintf(what, sizeof what, "free rotation, 100 turns, %s", b.name);
        wins += compare_motion(what);
    }
    body = NULL;
    return wins;
}

// usage: peers_ode [motions]; with "motions" the second table alone
int main(int argc, char **)
{
    int wins = 0;
#ifdef WITH_GSL
    gsl_set_error_handler_off();
#endif
#ifdef WITH_SUNDIALS
    SUNContext_Create(NULL, &context);
#endif
    if (argc < 2) {
        puts("| problem | to the error | by | µs | peer | µs | time, kit/peer |");
        puts("|---|---|---|---|---|---|---|");
        wins += compare_problems();
        puts("");
    }
    puts("| motion | to the error | by | µs | the quickest peer | µs | time, kit/peer |");
    puts("|---|---|---|---|---|---|---|");
    wins += compare_oscillators();
    wins += compare_rotations();
    return wins > 0;
}
