/* oscillator_checks.h - what the tests of one oscillator share (constant mass, laws, averaging, routes):
   comparisons with reference numbers, the two functions of a motion. Include it after ../varmass.h and check.h.
   */
#ifndef OSCILLATOR_CHECKS_H
#define OSCILLATOR_CHECKS_H

#include "precision.h"
#include "oscillator_problem.h"

/* |got - want| is within the tolerance. In float a tolerance below 3e-5 becomes 3e-5 max(1, |want|). */
static inline void near(const char *equation, const char *what, double got, double want, double tolerance)
{
    double scale = tolerance;
    if (is_float && tolerance < 3e-5) scale = 3e-5 * fmax(1, fabs(want));
    check_error(equation, what, "tol", fabs(got - want) / scale, 1, got, want);
}

/* A printed form differs from the truth by a known amount. Does it, to 5 % of that (in float to 10 %)? In float
   the amount shows only where it is large beside the errors of differences and integrations; elsewhere the answer
   says whether the two differ at all. */
static inline int misses(const char *equation, double printed, double truth, double known_miss)
{
    const double error = fabs(fabs(printed - truth) / known_miss - 1) / by_precision(0.05, 0.1);
    if (is_float && known_miss < 0.5 * fabs(truth)) return printed != truth;
    check_error(equation, "printed", "5 %", error, 1, printed, truth);
    return error <= 1;
}

/* |x|^alpha with the sign of x */
static inline double signed_power(double x, double alpha) { return copysign(pow(fabs(x), alpha), x); }

static inline void saca(double s, double alpha, double *sa, double *ca)
{
    vm_real a, c;
    ateb_saca(R(s), R(alpha), &a, &c);
    *sa = (double)a;
    *ca = (double)c;
}

/* Every route to x(t) of this problem, and the choice among them, ends with the same status and leaves its result
   alone. */
static inline void refuses(vm_osc_problem o, double t, int status)
{
    vm_osc_motion m, before;
    int route;
    memset(&m, 7, sizeof m);
    before = m;
    for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_RK87; route++) {
        CHECK(vm_osc_by_route(&o, route, R(t), 0, &m) == status);
        CHECK(memcmp(&m, &before, sizeof m) == 0);
    }
    CHECK(vm_osc_within(&o, R(t), 0, &m) == status && memcmp(&m, &before, sizeof m) == 0);
}

#endif
