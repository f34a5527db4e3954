/* broken_rotor.h - what the tests of the broken rotor share. States are x, y, psi and their rates. */
#ifndef BROKEN_ROTOR_H
#define BROKEN_ROTOR_H

#include "bodies.h"

/* A rotor of unit mass in the notation of (67): omega^2, s, p^2, k*, M* */
static inline vm_broken_rotor rotor_of(double omega2, double s, double p2, double k, double torque)
{
    vm_broken_rotor r;
    r.mass = 1;
    r.inertia = R(1 / p2);
    r.stiffness = R(omega2);
    r.s = R(s);
    r.damping = R(k / p2);
    r.torque = R(torque / p2);
    return r;
}

/* The rotor of the rows of the reference tables */
static inline vm_broken_rotor rotor_from(const double *p)
{
    vm_broken_rotor r;
    r.mass = R(p[0]);
    r.inertia = R(p[1]);
    r.stiffness = R(p[2]);
    r.damping = R(p[3]);
    r.torque = R(p[4]);
    r.s = R(p[5]);
    return r;
}

/* A random rotor, and its numbers of (67) in p[0] to p[4] */
static inline vm_broken_rotor random_rotor(double *p)
{
    p[0] = uniform(0, 4);
    p[1] = uniform(-1, 1);
    p[2] = uniform(0.3, 4);
    p[3] = uniform(0, 2);
    p[4] = uniform(-1, 1);
    return rotor_of(p[0], p[1], p[2], p[3], p[4]);
}

static inline void set_state(vm_real *state, double x, double y, double psi, double x_rate, double y_rate,
                             double psi_rate)
{
    state[0] = R(x);
    state[1] = R(y);
    state[2] = R(psi);
    state[3] = R(x_rate);
    state[4] = R(y_rate);
    state[5] = R(psi_rate);
}

static inline void random_state(vm_real *state, double size, double angle)
{
    int i;
    for (i = 0; i < 6; i++) {
        const double most = i == 2 ? angle : size;
        state[i] = R(uniform(-most, most));
    }
}

/* The error of got in eps of scale */
static inline void check_case(const char *what, const char *region, vm_real got, double expected, double scale,
                              double bound)
{
    check_error(what, region, "eps", ERROR_EPS(got, expected, 0, scale), bound, expected, 0);
}

/* Integrates the state to t about as accurately as the type allows: by the pair of order 8, in float by that of order
   5, whose fewer operations round less. */
static inline int integrate(ode_rhs f, void *ctx, vm_real *y, double t)
{
    vm_real work[RK87_WORK(6)];
    rk45_options o = {0};
    rk45 s;
    int status;
    o.rtol = is_float ? R(1e-5) : R(1e-13);
    o.atol = o.rtol;
    if (is_float) {
        rk45_init(&s, f, ctx, 6, 0, y, &o, work);
        status = rk45_solve(&s, R(t));
    } else {
        rk87_init(&s, f, ctx, 6, 0, y, &o, work);
        status = rk87_solve(&s, R(t));
    }
    memcpy(y, s.y, 6 * sizeof *y);
    return status;
}

/* The tolerance of integrate() */
#define TOLERANCE (is_float ? 1e-5 : 1e-13)

/* The largest difference of two states, in tolerances of integrate() */
static inline double state_error(const vm_real *y, const vm_real *z)
{
    double worst = 0;
    int i;
    for (i = 0; i < 6; i++) worst = fmax(worst, fabs((double)(y[i] - z[i])));
    return worst / TOLERANCE;
}

#endif
