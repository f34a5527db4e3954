/* slow_vibrations.h - what the tests of slow vibrations share (Van der Pol, Jeffcott's rotor, the pair, harmonic
   excitation, diagnostics): comparisons with reference numbers, direct integration, and laws of mass.
   Include it after ../varmass.h and check.h. */
#ifndef SLOW_VIBRATIONS_H
#define SLOW_VIBRATIONS_H

#include "precision.h"

static inline double relative_error(double got, double want)
{
    const double scale = want != 0 ? fabs(want) : 1;
    return fabs(got - want) / scale;
}

/* The relative error of got (the absolute one where want is 0) is within the bound of the type tested. */
static inline void near(const char *equation, const char *what, double got, double want, double bound,
                        double float_bound)
{
    check_error(equation, what, "rel", relative_error(got, want), by_precision(bound, float_bound), got, want);
}

/* The relative error of got is within a bound in units of eps. */
static inline void near_eps(const char *equation, const char *what, double got, double want, double bound)
{
    check_error(equation, what, "eps", relative_error(got, want) / eps, bound, got, want);
}

/* The form as printed has a known relative error. Does it have that error, to 2 % (in float to 10 %)? */
static inline int printed_fails(const char *equation, double printed, double truth, double known_error)
{
    const double error = fabs(fabs(printed / truth - 1) / known_error - 1), bound = by_precision(0.02, 0.1);
    check_error(equation, "as printed", "share", error, bound, printed, truth);
    return error <= bound;
}

/* The largest difference |a_k - b_k| of n numbers. It is not found by fmax, for which gcc 12 for AArch64 ends with an internal
   error when it vectorises this loop in float. */
static inline double largest_difference(int n, const vm_real *a, const vm_real *b)
{
    double largest = 0;
    int k;
    for (k = 0; k < n; k++) {
        const double difference = fabs((double)(a[k] - b[k]));
        if (difference > largest) largest = difference;
    }
    return largest;
}

static inline int is_nan(vm_real x) { return x != x; }

/* ---- Direct integration ---- */

/* Set where the right-hand side is not smooth: rk45 then integrates in double too. In float it always does. */
static int rough;

enum { MOST_COMPONENTS = 5 };
typedef struct integration {
    rk45 s;
    vm_real work[RK87_WORK(MOST_COMPONENTS)];
} integration;

static inline int integration_init(integration *run, ode_rhs f, void *ctx, int n, double t0, const vm_real *y,
                                   double tolerance)
{
    rk45_options o = {0};
    o.rtol = o.atol = R(by_precision(tolerance, 2e-6));
    if (is_float || rough) return rk45_init(&run->s, f, ctx, n, R(t0), y, &o, run->work);
    return rk87_init(&run->s, f, ctx, n, R(t0), y, &o, run->work);
}

static inline int integration_step(integration *run)
{
    if (is_float || rough) return rk45_step(&run->s);
    return rk87_step(&run->s);
}

/* Integrate y' = f from t0 to t1, in place. */
static inline void solve(ode_rhs f, void *ctx, int n, double t0, double t1, double tolerance, vm_real *y)
{
    integration run;
    int status = integration_init(&run, f, ctx, n, t0, y, tolerance);
    if (status >= 0 && (is_float || rough)) status = rk45_solve(&run.s, R(t1));
    else if (status >= 0) status = rk87_solve(&run.s, R(t1));
    CHECK(status >= 0);
    memcpy(y, run.s.y, (size_t)n * sizeof *y);
}

enum { MOST_POINTS = 2000 };
static vm_sample points[MOST_POINTS];

/* Integrate y' = f from 0 to t1, in place, and put into `points` all points of the kind (VM_TURNING_POINTS or
   VM_ZERO_CROSSINGS) of the position y[x], whose velocity is y[v]. Returns how many there are. */
static inline long track(ode_rhs f, void *ctx, int n, double t1, double tolerance, vm_real *y, int x, int v,
                         int kind)
{
    integration run;
    vm_real buffer[MOST_COMPONENTS];
    long found = 0, more;
    int status = integration_init(&run, f, ctx, n, 0, y, tolerance);
    while (status >= 0 && (double)run.s.t < t1) {
        status = integration_step(&run);
        more = vm_find_samples_of_step(&run.s, x, v, kind, buffer, MOST_POINTS - found, points + found);
        if (more < 0) status = -1;
        found += more;
        while (found > 0 && (double)points[found - 1].t > t1) found--;
    }
    CHECK(status >= 0 && found < MOST_POINTS);
    memcpy(y, run.s.y, (size_t)n * sizeof *y);
    return found;
}

/* ---- Oscillators and laws of mass ---- */

/* The law m = mass + rate t */
static inline vm_law linear(double mass, double rate) { return vm_law_linear(R(mass), R(rate)); }

/* The law m = (1 + e t)^2, where ctx points to e */
static inline int quadratic_mass(vm_real t, vm_real *mass, vm_real *rate, void *ctx)
{
    const vm_real e = *(const vm_real *)ctx;
    *mass = (1 + e * t) * (1 + e * t);
    *rate = 2 * e * (1 + e * t);
    return 0;
}

/* A Van der Pol oscillator of stiffness 1, prepared; its mass is the caller's to set. */
static inline vm_vdp vdp(double alpha, double feed, double c, double reactive, int method)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = R(alpha);
    v.k = 1;
    v.feed = R(feed);
    v.c = R(c);
    v.reactive = R(reactive);
    v.method = method;
    CHECK(vm_vdp_init(&v) == VM_OK);
    return v;
}

#endif
