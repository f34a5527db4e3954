/* drum.h - what the tests of the drum share. */
#ifndef DRUM_H
#define DRUM_H

#include "bodies.h"

static inline vm_drum drum_of(double radius, double mass, double inertia_of_drum, double band, double speed,
                              double damping, double stiffness, double omega)
{
    vm_drum d;
    d.radius = R(radius);
    d.mass = R(mass);
    d.inertia = R(inertia_of_drum);
    d.band = R(band);
    d.speed = R(speed);
    d.damping = R(damping);
    d.stiffness = R(stiffness);
    d.omega = R(omega);
    return d;
}

/* The error of got in eps of scale is at most 16. */
static inline void close_to(const char *what, const char *where, double got, double expected, double scale)
{
    check_error(what, where, "eps", fabs(got - expected) / scale / eps, 16, expected, 0);
}

/* Integrates y from t0 to t1, in time or in another independent variable, by the pair of order 8 (float: of order 5).
   Returns 0, or the integrator's status where it did not get there. */
static inline int integrate(ode_rhs f, void *ctx, int n, double t0, double t1, vm_real *y)
{
    vm_real work[RK87_WORK(12)];
    rk45_options options;
    rk45 s;
    int status;
    memset(&options, 0, sizeof options);
    options.rtol = R(is_float ? 1e-6 : 1e-13);
    options.atol = R(is_float ? 1e-9 : 1e-16);
    if (is_float) {
        status = rk45_init(&s, f, ctx, n, R(t0), y, &options, work);
        if (status >= 0) status = rk45_solve(&s, R(t1));
    } else {
        status = rk87_init(&s, f, ctx, n, R(t0), y, &options, work);
        if (status >= 0) status = rk87_solve(&s, R(t1));
    }
    if (status < 0) return status;
    memcpy(y, s.y, (size_t)n * sizeof *y);
    return 0;
}

/* The error that such an integration leaves, relative to the amplitude */
#define INTEGRATED (is_float ? 2e-4 : 1e-10)

/* The equation (194) of the rigid shaft: {phi, phi'} */
static inline int rigid_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_drum *d = (const vm_drum *)ctx;
    const vm_real j = d->band * d->radius * d->radius, J = d->inertia + j * y[0];
    (void)t;
    dydt[0] = y[1];
    dydt[1] = (-d->damping * y[1] - j * y[1] * y[1] + d->band * y[1] * d->speed * d->radius) / J;
    return 0;
}

#endif
