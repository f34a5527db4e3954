// peers_ode.cpp - the kit's integrators beside those of GSL, Boost.odeint and SUNDIALS on the problems of problems.h. Each
// method runs with tolerances from 1e-3 to 1e-14, four a decade; the time to an error is that of its quickest run whose
// error at the end is no larger. A peer wins where it takes less than MARGIN of the time of the kit's quicker method.
// A line of the table for each problem, error and library, by the library's quickest method, with the word "wins" at its
// end where that wins; the exit status is 1 where one does. All call the same right-hand side through a pointer, odeint by a function object.
#include "timing.h"
#include "../integrators.h"
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

enum { SETTINGS = 45, GOALS = 6, MOST_CALLS = 200000, TIMED_RUNS = 7 };
// A change of the orbit's initial values by their rounding moves its end by 5e-11: lesser errors there than this are chance.
static const double MARGIN = 0.9, LEAST_OF_ORBIT = 1e-9, goals[GOALS] = {1e-4, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12};

static const problem *now;
static long calls;

static int rhs(double t, const double *y, double *d, void *)
{
    now->f(t, y, d);
    return ++calls > MOST_CALLS; // which makes every method give up
}

// Each returns 1, with y at T, or 0 where it gave up
typedef int (*method)(double tolerance, double *y);

// ---- The kit ----

static int by_rk45(double tolerance, double *y)
{
    double work[RK45_WORK(4)];
    rk45_options o = rk45_options();
    rk45 s;
    o.rtol = o.atol = tolerance;
    if (rk45_init(&s, rhs, NULL, now->n, 0, y, &o, work) < 0 || rk45_solve(&s, now->T) < 0) return 0;
    memcpy(y, s.y, (size_t)now->n * sizeof *y);
    return 1;
}

static int by_rk87(double tolerance, double *y)
{
    double work[RK87_WORK(4)];
    rk45_options o = rk45_options();
    rk45 s;
    o.rtol = o.atol = tolerance;
    if (rk87_init(&s, rhs, NULL, now->n, 0, y, &o, work) < 0 || rk87_solve(&s, now->T) < 0) return 0;
    memcpy(y, s.y, (size_t)now->n * sizeof *y);
    return 1;
}

// ---- GSL ----

#ifdef WITH_GSL
static int by_gsl(const gsl_odeiv2_step_type *type, double tolerance, double *y)
{
    gsl_odeiv2_system system = {rhs, NULL, (size_t)now->n, NULL};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-3, tolerance, tolerance);
    double t = 0;
    const int status = gsl_odeiv2_driver_apply(driver, &t, now->T, y);
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
            now->T, 1e-3);
    } catch (...) {
        return 0;
    }
    for (size_t i = 0; i < n; i++) y[i] = at[i];
    return 1;
}


#define ODEINT(name)                                              \
    static int by_odeint_##name(double tolerance, double *y)      \
    {                                                             \
        switch (now->n) {                                         \
        case 2: return by_odeint_of<name##_any, 2>(tolerance, y); \
        case 3: return by_odeint_of<name##_any, 3>(tolerance, y); \
        default: return by_odeint_of<name##_any, 4>(tolerance, y); \
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
    N_Vector at = N_VMake_Serial(now->n, y, context);
    void *solver = CVodeCreate(CV_ADAMS, context);
    SUNNonlinearSolver nonlinear = SUNNonlinSol_FixedPoint(at, 0, context);
    double t;
    int ok = CVodeInit(solver, sundials_rhs, 0, at) == CV_SUCCESS;
    ok = ok && CVodeSStolerances(solver, tolerance, tolerance) == CV_SUCCESS;
    ok = ok && CVodeSetNonlinearSolver(solver, nonlinear) == CV_SUCCESS;
    ok = ok && CVodeSetMaxNumSteps(solver, MOST_CALLS) == CV_SUCCESS;
    ok = ok && CVodeSetStopTime(solver, now->T) == CV_SUCCESS;
    ok = ok && CVode(solver, now->T, at, &t, CV_NORMAL) >= 0;
    CVodeFree(&solver);
    SUNNonlinSolFree(nonlinear);
    N_VDestroy(at);
    return ok;
}

static int by_arkode(ARKODE_ERKTableID table, double tolerance, double *y)
{
    N_Vector at = N_VMake_Serial(now->n, y, context);
    void *solver = ERKStepCreate(sundials_rhs, 0, at, context);
    double t;
    int ok = ERKStepSetTableNum(solver, table) == ARK_SUCCESS;
    ok = ok && ERKStepSStolerances(solver, tolerance, tolerance) == ARK_SUCCESS;
    ok = ok && ERKStepSetMaxNumSteps(solver, MOST_CALLS) == ARK_SUCCESS;
    ok = ok && ERKStepSetStopTime(solver, now->T) == ARK_SUCCESS;
    ok = ok && ERKStepEvolve(solver, now->T, at, &t, ARK_NORMAL) >= 0;
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

static int run(int k, double tolerance, double *y)
{
    calls = 0;
    memcpy(y, now->y0, sizeof now->y0);
    return methods[k].run(tolerance, y);
}

// Errors and least times of all methods at one tolerance; runs of the methods take turns
static void measure_setting(int setting)
{
    const double tolerance = pow(10, -3 - 0.25 * setting);
    for (int k = 0; k < METHODS; k++) {
        double y[4];
        error[k][setting] = least[k][setting] = HUGE_VAL;
        if (run(k, tolerance, y)) error[k][setting] = error_at_end(now, y);
    }
    for (int turn = 0; turn < TIMED_RUNS; turn++)
        for (int k = 0; k < METHODS; k++) {
            double y[4];
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

// The quickest method of a library, whose methods begin at `first`
static int quickest_from(int first, double goal)
{
    int best = first;
    for (int k = first; k < next_library(first); k++)
        if (time_to(k, goal) < time_to(best, goal)) best = k;
    return best;
}

// The lines of a problem; returns how often a peer wins
static int compare()
{
    int wins = 0;
    for (int s = 0; s < SETTINGS; s++) measure_setting(s);
    for (int g = 0; g < GOALS; g++) {
        const int best = quickest_from(0, goals[g]);
        const double kit = time_to(best, goals[g]);
        if (now->f == orbit_f && goals[g] < LEAST_OF_ORBIT) continue;
        for (int first = next_library(0); first < METHODS; first = next_library(first)) {
            const int k = quickest_from(first, goals[g]);
            const double peer = time_to(k, goals[g]);
            const int won = peer < MARGIN * kit;
            if (peer == HUGE_VAL) continue;
            printf("| %s | %.0e | %s | %.1f | %s %s | %.1f | %.2f |%s\n", now->what, goals[g], methods[best].name,
                   1e6 * kit, methods[k].maker, methods[k].name, 1e6 * peer, kit / peer, won ? " wins" : "");
            wins += won;
        }
    }
    fflush(stdout);
    return wins;
}

int main()
{
    int wins = 0;
#ifdef WITH_GSL
    gsl_set_error_handler_off();
#endif
#ifdef WITH_SUNDIALS
    SUNContext_Create(NULL, &context);
#endif
    puts("| problem | to the error | by | µs | peer | µs | time, kit/peer |");
    puts("|---|---|---|---|---|---|---|");
    for (int i = 0; i < PROBLEMS; i++) {
        now = problems + i;
        wins += compare();
    }
    return wins > 0;
}
