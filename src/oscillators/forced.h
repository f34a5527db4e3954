/* oscillators/forced.h - harmonic excitation */
#ifndef VARMASS_OSCILLATORS_FORCED_H
#define VARMASS_OSCILLATORS_FORCED_H

#include "../ateb/functions.h"
#include "../ateb/period.h"
#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "slow.h"

/* m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + force cos theta, theta' = nu, where m, k, nu, force may drift slowly:
   now holds them at all times, or drift, where not null, gets it so and changes what drifts. vm_forced_init checks
   alpha, b, reactive and now at t = 0, and prepares what the averaged functions need: call it first, and again
   when alpha is another. now, b and reactive may change without. */
typedef struct VM_TAG(vm_forced_parameters) {
    vm_real mass, mass_rate; /* kg, kg/s */
    vm_real k, k_rate;       /* N/m^alpha, per s */
    vm_real nu, nu_rate;     /* rad/s, rad/s^2 */
    vm_real force;           /* N */
} vm_forced_parameters;

typedef struct VM_TAG(vm_forced) {
    vm_real alpha, b, reactive; /* alpha >= 0; kg/s; r */
    vm_forced_parameters now;
    void (*drift)(vm_real t, vm_forced_parameters *now, void *ctx);
    void *drift_ctx;
    vm_real pi, Om1, G; /* Pi_alpha, w = Om1 sqrt(k/m) A^((alpha-1)/2), the force's share; by vm_forced_init */
    vm_real c[5], s[5]; /* ca = sum c[j] cos((2j+1) pi psi/Pi), sa = sum s[j] sin(...), j = 0 .. */
} vm_forced;

VM_API vm_forced_parameters vmi_forced_at(const vm_forced *f, vm_real t)
{
    vm_forced_parameters now = f->now;
    if (f->drift) f->drift(t, &now, f->drift_ctx);
    return now;
}

VM_API int vmi_forced_check(const vm_forced_parameters *n)
{
    if (!VM_IS_FINITE(n->mass) || !VM_IS_FINITE(n->mass_rate) || !VM_IS_FINITE(n->k) || !VM_IS_FINITE(n->k_rate) ||
        !VM_IS_FINITE(n->nu) || !VM_IS_FINITE(n->nu_rate) || !VM_IS_FINITE(n->force))
        return VM_NOT_FINITE;
    if (!(n->mass > 0)) return VM_BAD_MASS;
    return n->k > 0 && n->nu > 0 ? VM_OK : VM_DOMAIN;
}

/* c_j = 2 int_0^1 ca(Pi u/2) cos((2j+1) pi u/2) du by the tanh-sinh rule, u = 1/(1 + e^(-pi sinh t)): ca is not
   analytic at u = 1, and for large alpha bends sharply at u = 0 */
VM_API void vmi_forced_fourier(vm_forced *f)
{
    const int steps = VM_MANT_DIG > 24 ? 16 : 8, n = 13 * steps / 4; /* |t| <= 3.25: the rest is below eps */
    vm_real sum[5] = {0, 0, 0, 0, 0}, total = 0;
    int i, j;
    for (i = -n; i <= n; i++) {
        const vm_real t = (vm_real)i / (vm_real)steps, e = vmi_exp(t, 0), half_pi = VM_PI / 2;
        const vm_real g = vmi_exp(-half_pi * (e - 1 / e), 0), u = 1 / (1 + g);
        const vm_real weight = half_pi * (e + 1 / e) * u * (g * u);
        vm_real sa, ca, sine, c, before, twice;
        ateb_saca(f->pi / 2 * u, f->alpha, &sa, &ca);
        vmi_sincos(half_pi * u, &sine, &c);
        before = c;
        twice = 2 * (c - sine) * (c + sine);
        total += weight;
        for (j = 0; j < 5; j++) {
            const vm_real next = twice * c - before;
            sum[j] += weight * ca * c;
            before = c;
            c = next;
        }
    }
    for (j = 0; j < 5; j++) {
        f->c[j] = 2 * sum[j] / total;
        f->s[j] = (f->alpha + 1) * (vm_real)(2 * j + 1) * VM_PI / (2 * f->pi) * f->c[j];
    }
}

VM_API int vm_forced_init(vm_forced *f)
{
    vm_forced_parameters now;
    int status;
    if (!f) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(f->alpha) || !VM_IS_FINITE(f->b) || !VM_IS_FINITE(f->reactive)) return VM_NOT_FINITE;
    if (!(f->alpha >= 0)) return VM_DOMAIN;
    now = vmi_forced_at(f, 0);
    status = vmi_forced_check(&now);
    if (status) return status;
    f->pi = ateb_pi(f->alpha);
    f->Om1 = VM_PI / f->pi * VM_SQRT((f->alpha + 1) / 2);
    vmi_forced_fourier(f);
    f->G = f->Om1 * f->Om1 / 2 * f->c[0];
    return VM_OK;
}

/* (ln mu kappa)', the rate at which the action would change */
VM_API vm_real vmi_forced_q(const vm_forced *f, const vm_forced_parameters *n)
{
    return ((2 * f->reactive - 1) * n->mass_rate + 2 * f->b) / n->mass + n->k_rate / n->k;
}

VM_API vm_real vmi_forced_natural(const vm_forced *f, const vm_forced_parameters *n, vm_real A) /* w(A) */
{
    return f->Om1 * VM_SQRT(n->k / n->mass) * vmi_pow_checked(VM_FABS(A), (f->alpha - 1) / 2);
}

/* Equations for rk45 or rk87, ctx a vm_forced: of motion, y = (x, x', theta); the same in amplitude and Ateb phase,
   exactly, y = (A, psi, theta), singular at A = 0; averaged near the main resonance nu = w(A), y = (A, delta,
   theta), where delta is the phase before the force. The averaged ones err by the order of b, m' and force over
   times of their inverses, off the resonance by more. */
VM_API int vm_forced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    vm_real sine, cosine;
    const int status = vmi_forced_check(&n);
    if (status) return status;
    vmi_sincos(y[2], &sine, &cosine);
    dydt[0] = y[1];
    dydt[1] = (n.force * cosine - (f->reactive * n.mass_rate + f->b) * y[1] -
               n.k * vmi_osc_elastic(y[0], f->alpha)) /
              n.mass;
    dydt[2] = n.nu;
    return VM_OK;
}

/* Documented with vm_forced_rhs. */
VM_API int vm_forced_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vm_real q, Om, push, sa, ca, sine, cosine;
    if (status) return status;
    q = vmi_forced_q(f, &n);
    Om = vmi_slow_rate(y[0], n.k, n.mass, f->alpha);
    ateb_saca(y[1], f->alpha, &sa, &ca);
    vmi_sincos(y[2], &sine, &cosine);
    push = n.force / (n.mass * Om) * cosine;
    dydt[0] = -(q * y[0] / (f->alpha + 1) * sa + push) * sa;
    dydt[1] = Om - (q / 2 * sa + (f->alpha + 1) / (2 * y[0]) * push) * ca;
    dydt[2] = n.nu;
    return VM_OK;
}

/* Documented with vm_forced_rhs. */
VM_API int vm_forced_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vm_real w, push, sine, cosine;
    if (status) return status;
    w = vmi_forced_natural(f, &n, y[0]);
    push = n.force * f->G / (n.mass * w);
    vmi_sincos(y[1], &sine, &cosine);
    dydt[0] = -vmi_forced_q(f, &n) * y[0] / (f->alpha + 3) - push * sine;
    dydt[1] = w - n.nu - push / y[0] * cosine;
    dydt[2] = n.nu;
    return VM_OK;
}

/* R, the first ripple of the exact amplitude about its mean A: psi the Ateb phase, phi = pi psi/Pi that in radians */
VM_API vm_real vmi_forced_ripple(const vm_forced *f, const vm_forced_parameters *n, vm_real A, vm_real phi, vm_real theta)
{
    const vm_real Om = vmi_slow_rate(A, n->k, n->mass, f->alpha);
    vm_real sa, ca, sum = 0, unused, plus, minus;
    int j;
    ateb_saca(phi * (f->pi / VM_PI), f->alpha, &sa, &ca);
    for (j = 0; j < 5; j++) {
        const vm_real order = (vm_real)(2 * j + 1);
        vmi_sincos(order * phi + theta, &unused, &plus);
        vmi_sincos(order * phi - theta, &unused, &minus);
        sum += f->s[j] / 2 * (plus / (order + 1) + (j ? minus / (order - 1) : 0));
    }
    return vmi_forced_q(f, n) * A / ((f->alpha + 3) * Om) * sa * ca + n->force / (n->mass * Om * n->nu) * sum;
}

/* (x, x', theta) to the mean (A, delta, theta), and back, at time t. The ripple of the amplitude is taken out and put
   back: without that the error is of order 1 where alpha != 1. */
VM_API int vm_forced_to_averaged(const vm_forced *f, vm_real t, const vm_real *motion, vm_real *y)
{
    if (!f || !motion || !y) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    const vm_real theta = motion[2];
    vm_real exact, A, phi;
    int i;
    if (status) return status;
    if (!vmi_all_finite(3, motion)) return VM_NOT_FINITE;
    vmi_slow_phase(motion[0], motion[1], n.k, n.mass, f->alpha, &exact, &phi);
    phi *= VM_PI / f->pi;
    A = exact;
    for (i = 0; i < 3; i++) A = exact - vmi_forced_ripple(f, &n, A, phi, theta);
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_DOMAIN; /* the motion is smaller than its ripple */
    y[0] = A;
    y[1] = phi - theta;
    y[2] = theta;
    return VM_OK;
}

/* Documented with vm_forced_to_averaged. */
VM_API int vm_forced_from_averaged(const vm_forced *f, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!f || !y || !motion) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    const vm_real theta = y[2], phi = y[1] + theta;
    vm_real A, r[3];
    if (status) return status;
    if (!vmi_all_finite(3, y)) return VM_NOT_FINITE;
    A = y[0] + vmi_forced_ripple(f, &n, y[0], phi, theta);
    if (!(y[0] > 0) || !(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, phi * (f->pi / VM_PI), n.k, n.mass, f->alpha, &r[0], &r[1]);
    r[2] = theta;
    return vmi_copy_if_finite(3, r, motion);
}

#endif
