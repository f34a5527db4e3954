/* oscillators/forced.h - harmonic excitation of a strongly nonlinear oscillator

   Chapter 8 of the dissertation leaves harmonic excitation to future work. In the equation of motion b is the damping,
   and r (`reactive`) the share of the reactive force. The mass m, the stiffness k, and the frequency nu and amplitude F
   of the force may vary slowly:
       m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + F cos(theta),   theta' = nu
   This file has the equation of motion, the exact equations of amplitude and phase, and averaged equations of amplitude
   and phase near the main resonance. Steady vibrations, resonance curves and the passage through the resonance are in
   resonance.h.

       vm_forced f;
       memset(&f, 0, sizeof f);
       f.alpha = 3;
       f.damping = VM_C(0.02);
       f.mass = f.stiffness = f.frequency = vm_law_linear(1, 0);
       f.force = vm_law_linear(VM_C(0.1), 0);
       int status = vm_forced_init(&f); // then vm_forced_rhs integrates x, x', theta

   Forces that are periodic, but not harmonic, are in periodic.h.

   Symbols: A is the amplitude, psi the Ateb phase, Om the rate of psi, and 2 Pi the period of ca (Pi = Pi_alpha). w(A)
   is the frequency of the free vibration of amplitude A, phi = pi psi/Pi the phase of the vibration in radians, theta
   the phase of the force, and delta = phi - theta.
   Tests: tests/test_forced.c. */
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
#include "laws.h"
#include "slow.h"

/* Number of harmonics of the Ateb functions ca and sa, of the orders 1, 3, 5, 7 and 9 */
enum { VMI_FORCED_HARMONICS = 5 };

/* An oscillator under harmonic excitation. Fill the fields above `pi`, then call vm_forced_init. After a change of
   alpha call vm_forced_init again; after a change of the other fields no new call is needed. The constructors of
   oscillators/laws.h make the laws; vm_law_linear(value, 0) is a constant. */
typedef struct VM_TAG(vm_forced) {
    vm_real alpha;     /* exponent of the spring, >= 0 */
    vm_real damping;   /* damping b, kg/s; a positive b takes energy out */
    vm_real reactive;  /* r: 1 where mass that joins or leaves is at rest, 0 where it has the body's velocity */
    vm_law mass;       /* mass m, kg, > 0 */
    vm_law stiffness;  /* stiffness k, N/m^alpha, > 0 */
    vm_law frequency;  /* frequency nu of the force, rad/s, > 0 */
    vm_law force;      /* amplitude F of the force, N, of either sign */
    vm_real pi;        /* Pi_alpha; vm_forced_init writes this field and those below */
    vm_real Om1;       /* the constant in the natural frequency w(A) = Om1 sqrt(k/m) A^((alpha-1)/2) */
    vm_real G;         /* the factor Om1^2 c[0]/2 of F/m in the averaged equations */
    /* Fourier coefficients: ca is the sum of c[j] cos((2j+1) phi), sa the sum of s[j] sin((2j+1) phi). */
    vm_real c[VMI_FORCED_HARMONICS], s[VMI_FORCED_HARMONICS];
} vm_forced;

/* The parameters of an excited oscillator that may vary with time, at one time; rates are per second */
typedef struct VM_TAG(vmi_forced_parameters) {
    vm_real mass, mass_rate; /* mass, kg, and its rate */
    vm_real k, k_rate;       /* stiffness, N/m^alpha, and its rate */
    vm_real nu, nu_rate;     /* frequency of the force, rad/s, and its rate */
    vm_real force;           /* amplitude of the force, N */
} vmi_forced_parameters;

/* Writes the parameters at time t, and checks them and the fields that do not vary. Of several errors it returns the
   first in the order of base/status.h. */
VM_API int vmi_forced_at(const vm_forced *f, vm_real t, vmi_forced_parameters *n)
{
    const vm_real numbers[3] = {f->alpha, f->damping, f->reactive};
    vm_real force_rate;
    int status = vmi_law_at(&f->mass, VM_BAD_MASS, t, &n->mass, &n->mass_rate);
    status = vmi_first_error(status, vmi_law_at(&f->stiffness, VM_BAD_STIFFNESS, t, &n->k, &n->k_rate));
    status = vmi_first_error(status, vmi_law_at(&f->frequency, VM_DOMAIN, t, &n->nu, &n->nu_rate));
    status = vmi_first_error(status, vmi_law_at(&f->force, VM_OK, t, &n->force, &force_rate));
    if (!vmi_all_finite(3, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (f->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    return status;
}

/* Computes the Fourier coefficients of ca, within 8 eps, and from them those of sa. The coefficients of ca are
     c[j] = 2 int_0^1 ca(Pi u/2) cos((2j+1) pi u/2) du,
   computed by the tanh-sinh rule u = 1/(1 + e^(-pi sinh t)), because ca is not analytic at u = 1 and, for large
   alpha, bends sharply at u = 0. With x = pi u/2 the cosines follow from cos((2j+3) x) = 2 cos(2x) cos((2j+1) x) -
   cos((2j-1) x). For alpha = 1 all coefficients after the first are exactly 0. */
VM_API void vmi_forced_fourier(vm_forced *f)
{
    const int steps = VM_MANT_DIG > 24 ? 16 : 8; /* number of points of the rule in an interval of t of length 1 */
    const int n = 13 * steps / 4;                /* |t| is at most 3.25; the rest of the integral is below eps */
    vm_real sum[VMI_FORCED_HARMONICS] = {0, 0, 0, 0, 0}, total = 0;
    int i, j;
    for (i = -n; i <= n; i++) {
        const vm_real t = (vm_real)i / (vm_real)steps, e = vmi_exp(t, 0), half_pi = VM_PI / 2;
        const vm_real g = vmi_exp(-half_pi * (e - 1 / e), 0), u = 1 / (1 + g);
        const vm_real weight = half_pi * (e + 1 / e) * u * (g * u);
        vm_real sa, ca, sine, cosine, before, twice;
        ateb_saca(f->pi / 2 * u, f->alpha, &sa, &ca);
        vmi_sincos(half_pi * u, &sine, &cosine);
        before = cosine;
        twice = 2 * (cosine - sine) * (cosine + sine);
        total += weight;
        for (j = 0; j < VMI_FORCED_HARMONICS; j++) {
            const vm_real next = twice * cosine - before;
            sum[j] += weight * ca * cosine;
            before = cosine;
            cosine = next;
        }
    }
    for (j = 0; j < VMI_FORCED_HARMONICS; j++) {
        f->c[j] = 2 * sum[j] / total;
        if (f->alpha == 1 && j > 0) f->c[j] = 0; /* ca is a cosine */
        f->s[j] = (f->alpha + 1) * (vm_real)(2 * j + 1) * VM_PI / (2 * f->pi) * f->c[j];
    }
}

/* Prepares an excited oscillator: checks its fields at t = 0, and writes pi, Om1, G, c and s. Call it before all other
   functions for this oscillator. Returns VM_BAD_ARGUMENT for a null pointer or a law that no constructor made;
   VM_NOT_FINITE for a number that is infinite or NaN; VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is
   not positive; VM_DOMAIN for alpha < 0, a frequency that is not positive, or a law that has no value at t = 0; VM_OK
   otherwise. An error leaves f as it was. */
VM_API int vm_forced_init(vm_forced *f)
{
    vmi_forced_parameters now;
    int status;
    if (!f) return VM_BAD_ARGUMENT;
    status = vmi_forced_at(f, 0, &now);
    if (status) return status;
    f->pi = ateb_pi(f->alpha);
    f->Om1 = VM_PI / f->pi * VM_SQRT((f->alpha + 1) / 2);
    vmi_forced_fourier(f);
    f->G = f->Om1 * f->Om1 / 2 * f->c[0];
    return VM_OK;
}

/* q = ((2r - 1) m' + 2 b)/m + k'/k, 1/s: the rate at which mass, damping and stiffness change the vibration */
VM_API vm_real vmi_forced_q(const vm_forced *f, const vmi_forced_parameters *n)
{
    return vmi_slow_q(vmi_slow_drag(f->reactive, n->mass_rate, f->damping), n->mass, n->k, n->k_rate);
}

/* The natural frequency w(A), rad/s: the frequency of the free vibration of amplitude A */
VM_API vm_real vmi_forced_natural(const vm_forced *f, const vmi_forced_parameters *n, vm_real A)
{
    return f->Om1 * VM_SQRT(n->k / n->mass) * vmi_pow_checked(VM_FABS(A), (f->alpha - 1) / 2);
}

/* Writes the rates of y = (x, x', theta) by the equation of motion. shape is the force divided by F, cos(theta) for a
   harmonic force. */
VM_API void vmi_forced_motion(const vm_forced *f, const vmi_forced_parameters *n, const vm_real *y, vm_real shape,
                              vm_real *dydt)
{
    dydt[0] = y[1];
    dydt[1] = (n->force * shape - (f->reactive * n->mass_rate + f->damping) * y[1] -
               n->k * vmi_osc_elastic(y[0], f->alpha)) /
              n->mass;
    dydt[2] = n->nu;
}

/* Equation of motion of an excited oscillator, for rk45 or rk87. y = (x, x', theta) is in m, m/s and rad; forced points
   to a prepared vm_forced. Returns VM_BAD_ARGUMENT for a null pointer or a law that no constructor made; VM_NOT_FINITE
   for t or a field that is infinite or NaN (y is not checked); VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a
   stiffness that is not positive; VM_DOMAIN for alpha < 0, a frequency that is not positive or a t at which a law has
   no value. These statuses stop the run. */
VM_API int vm_forced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    vmi_forced_parameters n;
    vm_real sine, cosine;
    const int status = vmi_forced_at(f, t, &n);
    if (status) return status;
    vmi_sincos(y[2], &sine, &cosine);
    vmi_forced_motion(f, &n, y, cosine, dydt);
    return VM_OK;
}

/* Writes the rates of y = (A, psi, theta) by the exact equations. shape is the force divided by F, cos(theta) for a
   harmonic force. */
VM_API void vmi_forced_exact(const vm_forced *f, const vmi_forced_parameters *n, const vm_real *y, vm_real shape,
                             vm_real *dydt)
{
    const vm_real q = vmi_forced_q(f, n), Om = vmi_slow_rate(y[0], n->k, n->mass, f->alpha);
    const vm_real push = n->force / (n->mass * Om) * shape;
    vm_real sa, ca;
    ateb_saca(y[1], f->alpha, &sa, &ca);
    dydt[0] = -(q * y[0] / (f->alpha + 1) * sa + push) * sa;
    dydt[1] = Om - (q / 2 * sa + (f->alpha + 1) / (2 * y[0]) * push) * ca;
    dydt[2] = n->nu;
}

/* Exact equations of amplitude and phase of an excited oscillator, for rk45 or rk87.
   The state is y = (A, psi, theta): the amplitude A and the Ateb phase psi of x = A ca(psi), and the phase theta of the
   force. These equations neglect nothing, but they are singular at A = 0. The argument forced and the statuses are
   those of vm_forced_rhs. */
VM_API int vm_forced_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vm_real sine, cosine;
    if (status) return status;
    vmi_sincos(y[2], &sine, &cosine);
    vmi_forced_exact(f, &n, y, cosine, dydt);
    return VM_OK;
}

/* Averaged equations of an excited oscillator near its main resonance, for rk45 or rk87. At the main resonance the
   frequency nu of the force is the natural frequency w(A). The state is y = (A, delta, theta): A is the mean amplitude,
   theta the phase of the force, and delta the phase by which the vibration leads the force. Start with
   vm_forced_to_averaged, and end with vm_forced_from_averaged. Let e be the largest of the damping b, the mass rate m'
   and the force F. Near the resonance the error of the averaged motion is of the order of e up to times of the order of
   1/e; away from the resonance it is larger. The argument forced and the statuses are those of vm_forced_rhs. */
VM_API int vm_forced_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
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

/* The ripple of the exact amplitude about its mean A, m, to first order in the force and in the slow changes: exact
   amplitude = A + ripple. The ripple is
     q A sa ca/((alpha+3) Om) + F/(m Om nu) sum of s[j]/2 (cos(n phi + theta)/(n + 1) + cos(n phi - theta)/(n - 1))
   with n = 2j + 1, with q of vmi_forced_q, and with F as the amplitude of the force. For n = 1 the function leaves out
   cos(n phi - theta)/(n - 1), since phi - theta does not vary within a period at the resonance. */
VM_API vm_real vmi_forced_ripple(const void *forced, const vmi_forced_parameters *n, vm_real A, vm_real w, vm_real phi,
                                 vm_real theta)
{
    const vm_forced *f = (const vm_forced *)forced;
    const vm_real Om = vmi_slow_rate(A, n->k, n->mass, f->alpha);
    vm_real sa, ca, sum = 0, unused, plus, minus;
    int j;
    (void)w; /* nu, as at the resonance */
    ateb_saca(phi * (f->pi / VM_PI), f->alpha, &sa, &ca);
    for (j = 0; j < VMI_FORCED_HARMONICS; j++) {
        const vm_real order = (vm_real)(2 * j + 1);
        vm_real second = 0;
        vmi_sincos(order * phi + theta, &unused, &plus);
        vmi_sincos(order * phi - theta, &unused, &minus);
        if (j > 0) second = minus / (order - 1);
        sum += f->s[j] / 2 * (plus / (order + 1) + second);
    }
    return vmi_forced_q(f, n) * A / ((f->alpha + 3) * Om) * sa * ca + n->force / (n->mass * Om * n->nu) * sum;
}

/* A function that returns the ripple of the amplitude for one kind of force, for the mean amplitude A, the frequency w
   and the phase phi of the vibration, and the phase theta of the force; `object` points to the oscillator with its
   force. */
typedef vm_real (*vmi_ripple_of_force)(const void *object, const vmi_forced_parameters *n, vm_real A, vm_real w,
                                       vm_real phi, vm_real theta);

/* Returns the ripple for the frequency of the free vibration of amplitude A. */
VM_API vm_real vmi_forced_free_ripple(const vm_forced *f, const vmi_forced_parameters *n, vmi_ripple_of_force ripple,
                                      const void *object, vm_real A, vm_real phi, vm_real theta)
{
    return ripple(object, n, A, vmi_forced_natural(f, n, A), phi, theta);
}

/* Writes the mean amplitude A and the phase phi, rad, of a motion (x, x', theta). Six iterations solve A + ripple(A) =
   exact, where `exact` is the amplitude at this instant. The first three use the frequency `resonance`, rad/s, that the
   vibration has at the resonance. The divisors of the ripple are then not small; with the frequency of the free
   vibration they may be nearly 0 at the exact amplitude, although they are not at the mean one. Returns VM_NOT_FINITE
   where the exact amplitude overflows, and VM_DOMAIN where A, the exact amplitude minus its ripple, is not positive, or
   six iterations are not enough. */
VM_API int vmi_forced_split(const vm_forced *f, const vmi_forced_parameters *n, vmi_ripple_of_force ripple,
                            const void *object, vm_real resonance, const vm_real *motion, vm_real *A, vm_real *phi)
{
    const vm_real theta = motion[2];
    vm_real exact = 0, mean, again;
    int i;
    vmi_slow_phase(motion[0], motion[1], n->k, n->mass, f->alpha, &exact, phi);
    if (!VM_IS_FINITE(exact)) return VM_NOT_FINITE;
    *phi *= VM_PI / f->pi;
    mean = exact;
    for (i = 0; i < 3; i++) mean = exact - ripple(object, n, mean, resonance, *phi, theta);
    for (i = 0; i < 3; i++) mean = exact - vmi_forced_free_ripple(f, n, ripple, object, mean, *phi, theta);
    again = mean + vmi_forced_free_ripple(f, n, ripple, object, mean, *phi, theta);
    if (!(mean > 0) || !vmi_slow_is_solved(again, exact)) return VM_DOMAIN;
    *A = mean;
    return VM_OK;
}

/* Writes the motion (x, x', theta) of the mean amplitude `mean` and the phase phi, rad. Returns VM_DOMAIN where `mean`
   is not positive or mean + ripple is negative. */
VM_API int vmi_forced_join(const vm_forced *f, const vmi_forced_parameters *n, vmi_ripple_of_force ripple,
                           const void *object, vm_real mean, vm_real phi, vm_real theta, vm_real *motion)
{
    const vm_real A = mean + vmi_forced_free_ripple(f, n, ripple, object, mean, phi, theta);
    vm_real r[3];
    if (!(mean > 0) || !(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, phi * (f->pi / VM_PI), n->k, n->mass, f->alpha, &r[0], &r[1]);
    r[2] = theta;
    return vmi_copy_if_finite(3, r, motion);
}

/* Converts a motion (x, x', theta) of an excited oscillator to its mean y = (A, delta, theta). A is the amplitude minus
   its ripple within a period. If the ripple stayed in A, averaged motions would have errors of order 1 where alpha is
   not 1. The statuses are those of vm_forced_rhs; VM_NOT_FINITE also means that a number of the motion is infinite or
   NaN, and VM_DOMAIN that the amplitude minus its ripple is not positive, or that the ripple is about as large as the
   amplitude, as near x = x' = 0. y and motion may be the same array. */
VM_API int vm_forced_to_averaged(const vm_forced *f, vm_real t, const vm_real *motion, vm_real *y)
{
    if (!f || !motion || !y) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int status = vmi_forced_at(f, t, &n);
    const vm_real theta = motion[2];
    vm_real A, phi;
    if (!vmi_all_finite(3, motion)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (!status) status = vmi_forced_split(f, &n, vmi_forced_ripple, f, n.nu, motion, &A, &phi);
    if (status) return status;
    y[0] = A;
    y[1] = phi - theta;
    y[2] = theta;
    return VM_OK;
}

/* Converts the mean y = (A, delta, theta) of an excited oscillator to the motion (x, x', theta). This is the inverse of
   vm_forced_to_averaged: it adds the ripple to the mean amplitude. The statuses are those of vm_forced_rhs;
   VM_NOT_FINITE also means that a number of y is infinite or NaN, and VM_DOMAIN that A <= 0 or that A plus its ripple
   is negative. motion and y may be the same array. */
VM_API int vm_forced_from_averaged(const vm_forced *f, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!f || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int status = vmi_forced_at(f, t, &n);
    if (!vmi_all_finite(3, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    return vmi_forced_join(f, &n, vmi_forced_ripple, f, y[0], y[1] + y[2], y[2], motion);
}

#endif
