/* integrator_check.h - what the tests of integrators.h share: the two methods that choose their steps, as a table,
   and right-hand sides whose solutions are known. */
#ifndef INTEGRATOR_CHECK_H
#define INTEGRATOR_CHECK_H
#include "../integrators.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

/* Both methods have the state rk45 and the options rk45_options; rk87 and rk87_options are other names of these. */
typedef struct method {
    const char *name;
    int order, stages; /* evaluations of an accepted step */
    int (*init)(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0, const rk45_options *o,
                vm_real *work);
    int (*step)(rk45 *s);
    int (*solve)(rk45 *s, vm_real t_end);
    int (*restart)(rk45 *s, vm_real t, const vm_real *y);
    int (*interpolate)(rk45 *s, vm_real t, vm_real *y);
    int (*solve_at)(rk45 *s, int n_times, const vm_real *times, vm_real *rows, int *n_done_or_NULL);
    int (*save)(const rk45 *s, long size, unsigned char *bytes);
    int (*resume)(rk45 *s, long size, const unsigned char *bytes);
} method;
/* rk45_interpolate takes a const rk45. */
static inline int interpolate_rk45(rk45 *s, vm_real t, vm_real *y) { return rk45_interpolate(s, t, y); }

enum { METHODS = 2 };
static const method methods[METHODS] = {
    {"rk45", 5, 6, rk45_init, rk45_step, rk45_solve, rk45_restart, interpolate_rk45, rk45_solve_at, rk45_save,
     rk45_resume},
    {"rk87", 8, 13, rk87_init, rk87_step, rk87_solve, rk87_restart, rk87_interpolate, rk87_solve_at, rk87_save,
     rk87_resume}};

/* y = (cos t, sin t, exp(-t)) */
static inline int linear_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = -y[1];
    dydt[1] = y[0];
    dydt[2] = -y[2];
    return 0;
}

/* The largest error of linear_rhs's y at t */
static inline double linear_error(const vm_real *y, double t)
{
    const double of_circle = fmax(fabs((double)y[0] - cos(t)), fabs((double)y[1] - sin(t)));
    return fmax(of_circle, fabs((double)y[2] - exp(-t)));
}

/* y' = 2 t y: y = exp(t^2) */
static inline int time_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)ctx;
    dydt[0] = 2 * t * y[0];
    return 0;
}

/* x'' = -x^3 */
static inline int cubic_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

/* y' = -y for t < at; from there on f is NaN, or refuses with status 7. */
typedef struct wall {
    vm_real at;
    int use_nan;
} wall;

static inline int wall_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const wall *w = (const wall *)ctx;
    dydt[0] = -y[0];
    if (t < w->at) return 0;
    if (!w->use_nan) return 7;
    dydt[0] = VM_NAN;
    return 0;
}

static inline void check_order(const char *name, double order, double wanted, double allowed)
{
    printf("%s: measured order %.3f\n", name, order);
    CHECK(fabs(order - wanted) < allowed);
}

#endif
