/* envelope.h - the comparison in examples 1 and 2: the oscillator d/dt(m x') + x|x|^(alpha-1) = 0 with x(0) = 1, x'(0)
   = 0 and m = (1 + 0.1 t)^power is integrated by rk45 and compared with the envelopes A = m^-a and x'_max = c m^-v.

   The error of an envelope is its largest relative error: for the amplitude at the turning points of the integrated
   motion, for the velocity at the passages through x = 0. */
#ifndef ENVELOPE_H
#define ENVELOPE_H

#include <math.h>
#include <stdio.h>
#include "../varmass.h"

typedef struct oscillator {
    vm_real alpha, power;
} oscillator;

typedef struct envelope {
    const char *name;
    double a;    /* A = m^-a */
    double c, v; /* x'_max = c m^-v */
    double amplitude_error, velocity_error;
} envelope;

static inline vm_real oscillator_mass(const oscillator *o, vm_real t)
{
    return VM_LIBM(pow)(1 + VM_C(0.1) * t, o->power);
}

/* y = (x, m x') */
static inline int oscillator_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const oscillator *o = (const oscillator *)ctx;
    dydt[0] = y[1] / oscillator_mass(o, t);
    dydt[1] = -VM_COPYSIGN(VM_LIBM(pow)(VM_FABS(y[0]), o->alpha), y[0]);
    return 0;
}

/* Compares an envelope with one observed value: the amplitude at a turning point, or the velocity at x = 0 */
static inline void envelope_compare(envelope *e, double m, int turning_point, double observed)
{
    double law = turning_point ? pow(m, -e->a) : e->c * pow(m, -e->v), error = fabs(law / observed - 1);
    double *worst = turning_point ? &e->amplitude_error : &e->velocity_error;
    if (!(error <= *worst)) *worst = error;
}

/* The time in the last step of s at which y[i] is zero, by bisection of the interpolated solution */
static inline vm_real zero_in_step(const rk45 *s, int i)
{
    vm_real low = s->t_old, high = s->t, y[2];
    int first, k;
    rk45_interpolate(s, low, y);
    first = y[i] > 0;
    for (k = 0; k < VM_MANT_DIG; k++) {
        vm_real middle = low + (high - low) / 2;
        rk45_interpolate(s, middle, y);
        if ((y[i] > 0) == first) low = middle;
        else high = middle;
    }
    return low;
}

/* Writes x, x' and the envelopes at the multiples of 0.2 that lie in the last step of s, from *t_next on */
static inline void write_rows(FILE *csv, const rk45 *s, const oscillator *o, const envelope *e, int n,
                              double *t_next)
{
    const double spacing = 0.2;
    int i;
    for (; *t_next <= (double)s->t; *t_next += spacing) {
        double m = (double)oscillator_mass(o, (vm_real)*t_next);
        vm_real y[2];
        rk45_interpolate(s, (vm_real)*t_next, y);
        fprintf(csv, "%.6g,%.6g,%.6g", *t_next, (double)y[0], (double)y[1] / m);
        for (i = 0; i < n; i++) fprintf(csv, ",%.6g,%.6g", pow(m, -e[i].a), e[i].c * pow(m, -e[i].v));
        fputc('\n', csv);
    }
}

/* Computes the errors of n envelopes over 0 <= t <= t_end. If csv is not NULL, motion and envelopes are written to
   this file. Returns the last status of rk45; *points becomes the number of turning points and of passages through x =
   0. */
static inline int envelope_errors(const oscillator *o, double t_end, envelope *e, int n, FILE *csv, int *points)
{
    vm_real y0[2] = {1, 0}, work[RK45_WORK(2)], y[2], last[2] = {1, -1}; /* x' is negative after the start */
    oscillator ctx = *o;
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    double t_next = 0;
    int i, k, status;
    options.rtol = options.atol = VM_MANT_DIG > 24 ? VM_C(1e-11) : VM_C(3e-6);
    status = rk45_init(&s, oscillator_rhs, &ctx, 2, 0, y0, &options, work);
    for (i = 0; i < n; i++) e[i].amplitude_error = e[i].velocity_error = 0;
    for (*points = 0; status >= 0 && (double)s.t < t_end;) {
        status = rk45_step(&s);
        if (csv) write_rows(csv, &s, o, e, n, &t_next);
        for (k = 0; k < 2; k++) { /* k = 1: a turning point; k = 0: x = 0 */
            int crossed = (s.y[k] > 0) != (last[k] > 0);
            double m, t;
            last[k] = s.y[k];
            t = crossed ? (double)zero_in_step(&s, k) : 0;
            if (!crossed || t > t_end) continue;
            rk45_interpolate(&s, (vm_real)t, y);
            m = (double)oscillator_mass(o, (vm_real)t);
            ++*points;
            for (i = 0; i < n; i++) envelope_compare(e + i, m, k, fabs((double)y[!k]) / (k ? 1 : m));
        }
    }
    return status;
}

static inline void envelope_print(const envelope *e, int n)
{
    int i;
    printf("  %-38s %-14s %-10s %-22s %s\n", "", "amplitude", "error", "largest velocity", "error");
    for (i = 0; i < n; i++) {
        char amplitude[40], velocity[40];
        snprintf(amplitude, sizeof amplitude, "m^-%.5f", e[i].a);
        snprintf(velocity, sizeof velocity, "%.5f m^-%.5f", e[i].c, e[i].v);
        printf("  %-38s %-14s %-10.1e %-22s %.1e\n", e[i].name, amplitude, e[i].amplitude_error, velocity,
               e[i].velocity_error);
    }
}

/* Runs the whole example: computes the errors up to t = 50 and up to t = 200. If csv_path is not NULL, the motion up
   to t = 50 is written to this file. Returns 0 if there was no error. */
static inline int envelope_report(const oscillator *o, envelope *e, int n, const char *csv_path)
{
    FILE *csv = csv_path ? fopen(csv_path, "w") : NULL;
    double t_end;
    int status = ODE_OK, points;
    if (csv_path && !csv) {
        perror(csv_path);
        return 1;
    }
    for (t_end = 50; t_end <= 200 && status >= 0; t_end *= 4) {
        status = envelope_errors(o, t_end, e, n, csv, &points);
        printf(
            "\nt <= %g, largest relative error of the envelopes at %d turning points and passages through x = 0:\n",
            t_end, points);
        envelope_print(e, n);
        if (csv) fclose(csv);
        csv = NULL;
    }
    if (status < 0) printf("integration: %s\n", ode_strerror(status));
    return status < 0;
}

#endif
