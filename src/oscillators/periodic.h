/* oscillators/periodic.h - a strongly nonlinear oscillator under a periodic force that is not harmonic

   The oscillator of forced.h vibrates under a force F g(theta). The phase theta of the force grows at the rate nu,
   theta' = nu, and the shape g has the period 2 pi:
       m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + F g(theta),   g = sum over n of a_n cos(n theta) + b_n sin(n theta)
   for n = 0 to 9. Here m is the mass, k the stiffness, b the damping and r the field `reactive`. This file has the
   equation of motion, the exact equations of amplitude and phase, the averaged equations near a resonance, and the
   steady vibrations with their stability. The dissertation leaves this problem to the future.

       vm_periodic p;
       memset(&p, 0, sizeof p);
       p.oscillator = forced;          // as in forced.h, but vm_forced_init need not be called
       p.cosine[1] = 1;
       p.cosine[3] = VM_C(-0.333);     // a flattened force; vm_periodic_from_samples serves for other shapes
       p.vibrations = p.periods = 1;   // main resonance
       int status = vm_periodic_init(&p);

   Resonances. At a resonance the oscillator makes P vibrations in Q periods of the force; the fields `vibrations` and
   `periods` are P and Q. Near the resonance the frequency w(A) of the free vibration of amplitude A is about (P/Q) nu.
   P = Q = 1 is the main resonance. P = 3, Q = 1 is the resonance with the third harmonic of the force. P = 1, Q = 3 is
   a subharmonic resonance with a third of the frequency of the force, which exists where alpha is not 1. The vibration
   has odd harmonics only. Harmonic j of the vibration is in resonance with harmonic n = j P/Q of the force, if this n
   is a whole number. If Q is even after common factors of P and Q have been removed, n is not a whole number for any
   odd j. Then the averaged equations contain no force.

   The averaged equations use the phase phi of the vibration and delta = phi - (P/Q) theta. q is the rate at which slow
   changes and damping act (slow.h), and G_j is explained below:
       A' = -q A/(alpha+3) - F/(m w) S,   delta' = w(A) - (P/Q) nu - F/(m w A) C,
       S = sum of j G_j (a_n sin(j delta) + b_n cos(j delta)),   C = sum of G_j (a_n cos(j delta) - b_n sin(j delta)).
   The sums are over the odd j for which n = j P/Q is a whole number. G_j is Om1^2 c_j/2, where Om1 is the field of
   vm_forced and c_j the Fourier coefficient of cos(j phi) in ca. Terms with j > 9 are left out; for alpha = 3 these
   terms are below 5e-7 of the first term. Tests: tests/test_periodic.c. */
#ifndef VARMASS_OSCILLATORS_PERIODIC_H
#define VARMASS_OSCILLATORS_PERIODIC_H

#include "../base/arrays.h"
#include "../base/complex.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "forced.h"
#include "resonance.h"

/* The largest order n of a harmonic of the force. It is also the largest value of P and of Q in a resonance. */
enum { VM_PERIODIC_HARMONICS = 9 };

/* An oscillator under a periodic force. Set all fields, then call vm_periodic_init. The fields cosine, sine, vibrations
   and periods may change later without a new call; after a change of oscillator.alpha call vm_periodic_init again. */
typedef struct VM_TAG(vm_periodic) {
    vm_forced oscillator; /* the oscillator; its field `force` is the factor F of the shape g, N */
    vm_real cosine[VM_PERIODIC_HARMONICS + 1]; /* the coefficients a_n of cos(n theta) in g; a_0 is the mean of g */
    vm_real sine[VM_PERIODIC_HARMONICS + 1];   /* the coefficients b_n of sin(n theta) in g; b_0 has no effect */
    int vibrations; /* P, from 1 to 9: the number of vibrations in Q periods of the force, at the resonance */
    int periods;    /* Q, from 1 to 9: the number of periods of the force in which there are P vibrations */
} vm_periodic;

/* Writes the parameters of the oscillator at time t to *n. Checks these parameters, the coefficients of the shape, and
   P and Q. */
VM_API int vmi_periodic_at(const vm_periodic *p, vm_real t, vmi_forced_parameters *n)
{
    int status = vmi_forced_at(&p->oscillator, t, n);
    if (p->vibrations < 1 || p->vibrations > VM_PERIODIC_HARMONICS || p->periods < 1 ||
        p->periods > VM_PERIODIC_HARMONICS)
        status = vmi_first_error(status, VM_BAD_ARGUMENT);
    if (!vmi_all_finite(VM_PERIODIC_HARMONICS + 1, p->cosine) || !vmi_all_finite(VM_PERIODIC_HARMONICS + 1, p->sine))
        status = vmi_first_error(status, VM_NOT_FINITE);
    return status;
}

/* Prepares an oscillator under a periodic force: checks its fields at t = 0, and prepares the field `oscillator`. All
   other functions of this file except vm_periodic_from_samples and vm_periodic_shape need this call. Returns the
   statuses of vm_forced_init. In addition it returns VM_BAD_ARGUMENT where `vibrations` or `periods` is not from 1 to
   9, and VM_NOT_FINITE where a coefficient is infinite or NaN. An error leaves *p as it was. */
VM_API int vm_periodic_init(vm_periodic *p)
{
    vmi_forced_parameters now;
    int status;
    if (!p) return VM_BAD_ARGUMENT;
    status = vmi_periodic_at(p, 0, &now);
    if (status) return status;
    return vm_forced_init(&p->oscillator);
}

/* Sets the shape of a periodic force from n samples g[i] = g(2 pi i/n) over one period. Writes only the fields cosine
   and sine of *p. The function computes the coefficients of those harmonics up to the ninth whose order is below n/2.
   All other coefficients become 0. Apart from rounding the result is exact if g has no harmonics of an order >= n/2. g
   may have any shape, such as a rectangular wave. Its harmonics above the ninth are left out, since they excite the
   vibration only little. The function takes about as long as the computation of 20 n sines (docs/counts.md). Returns
   VM_BAD_ARGUMENT for a null pointer or n < 1, VM_NOT_FINITE for a sample that is infinite or NaN, and VM_OK otherwise.
   An error leaves *p as it was. */
VM_API int vm_periodic_from_samples(vm_periodic *p, int n, const vm_real *g)
{
    int k, i;
    if (!p || !g || n < 1) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(n, g)) return VM_NOT_FINITE;
    for (k = 0; k <= VM_PERIODIC_HARMONICS; k++) {
        vm_real even = 0, odd = 0;
        int step = 0; /* k i modulo n */
        for (i = 0; i < n && 2 * k < n; i++) {
            const vm_complex turn = vmi_c_turn(2 * VM_PI * (vm_real)step / (vm_real)n);
            even += g[i] / (vm_real)n * turn.re;
            odd += g[i] / (vm_real)n * turn.im;
            step = (step + k % n) % n;
        }
        p->cosine[k] = k > 0 ? 2 * even : even;
        p->sine[k] = 2 * odd;
    }
    return VM_OK;
}

/* Shape g(theta) of the force, a pure number. Returns NaN for a null pointer and for a theta that is infinite or NaN.
   The error is about nine times the rounding error of the largest term. */
VM_API vm_real vm_periodic_shape(const vm_periodic *p, vm_real theta)
{
    vm_complex turns[VM_PERIODIC_HARMONICS + 1];
    vm_real g;
    int n;
    if (!p || !VM_IS_FINITE(theta)) return VM_NAN;
    vmi_c_turns(VM_PERIODIC_HARMONICS, theta, turns);
    g = p->cosine[0];
    for (n = 1; n <= VM_PERIODIC_HARMONICS; n++) g += p->cosine[n] * turns[n].re + p->sine[n] * turns[n].im;
    return g;
}

/* Equation of motion of an oscillator under a periodic force, for rk45 or rk87. The array y = (x, x', theta) is in m,
   m/s and rad; `periodic` points to a prepared vm_periodic. Returns the statuses of vm_periodic_init, now for the
   fields at the time t, and VM_DOMAIN for a t at which a law has no value. These statuses stop the integration. */
VM_API int vm_periodic_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *periodic)
{
    if (!y || !dydt || !periodic) return VM_BAD_ARGUMENT;
    const vm_periodic *p = (const vm_periodic *)periodic;
    vmi_forced_parameters n;
    const int status = vmi_periodic_at(p, t, &n);
    if (status) return status;
    vmi_forced_motion(&p->oscillator, &n, y, vm_periodic_shape(p, y[2]), dydt);
    return VM_OK;
}

/* Exact equations of amplitude and phase under a periodic force, for rk45 or rk87. The array y = (A, psi, theta)
   contains the amplitude, the Ateb phase, and the phase of the force, as for vm_forced_exact_rhs. The equations neglect
   nothing, but they are singular at A = 0. The argument `periodic` and the statuses are those of vm_periodic_rhs. */
VM_API int vm_periodic_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *periodic)
{
    if (!y || !dydt || !periodic) return VM_BAD_ARGUMENT;
    const vm_periodic *p = (const vm_periodic *)periodic;
    vmi_forced_parameters n;
    const int status = vmi_periodic_at(p, t, &n);
    if (status) return status;
    vmi_forced_exact(&p->oscillator, &n, y, vm_periodic_shape(p, y[2]), dydt);
    return VM_OK;
}

/* The sums in the averaged equations at the phase delta = phi - (P/Q) theta */
typedef struct VM_TAG(vmi_periodic_sums) {
    vm_real S, C; /* the sums S and C at the top of this file */
    vm_real slope; /* dS/ddelta; dC/ddelta is -S */
} vmi_periodic_sums;

/* Returns the order n of the force's harmonic that is in resonance with the harmonic j of the vibration, or 0 where
   there is none. */
VM_API int vmi_periodic_partner(const vm_periodic *p, int j)
{
    const int n = j * p->vibrations / p->periods;
    if (n * p->periods != j * p->vibrations || n > VM_PERIODIC_HARMONICS) return 0;
    return n;
}

/* The terms of the sums at one phase delta. Harmonic j = 2i + 1 of the vibration adds j G[i] across[i] to S, and
   G[i] along[i] to C. All three numbers of a harmonic are 0 if it is in resonance with no harmonic of the force. */
typedef struct VM_TAG(vmi_periodic_terms) {
    vm_real G[VMI_FORCED_HARMONICS];      /* G_j at the top of this file */
    vm_real along[VMI_FORCED_HARMONICS];  /* a_n cos(j delta) - b_n sin(j delta) */
    vm_real across[VMI_FORCED_HARMONICS]; /* a_n sin(j delta) + b_n cos(j delta) */
} vmi_periodic_terms;

VM_API void vmi_periodic_terms_at(const vm_periodic *p, vm_real delta, vmi_periodic_terms *terms)
{
    const vm_forced *f = &p->oscillator;
    vm_complex turns[2 * VMI_FORCED_HARMONICS];
    int i;
    vmi_c_turns(2 * VMI_FORCED_HARMONICS - 1, delta, turns);
    for (i = 0; i < VMI_FORCED_HARMONICS; i++) {
        const int j = 2 * i + 1, n = vmi_periodic_partner(p, j);
        terms->G[i] = terms->along[i] = terms->across[i] = 0;
        if (n == 0) continue;
        terms->G[i] = f->Om1 * f->Om1 / 2 * f->c[i];
        terms->along[i] = p->cosine[n] * turns[j].re - p->sine[n] * turns[j].im;
        terms->across[i] = p->cosine[n] * turns[j].im + p->sine[n] * turns[j].re;
    }
}

VM_API vmi_periodic_sums vmi_periodic_sums_at(const vm_periodic *p, vm_real delta)
{
    vmi_periodic_terms terms;
    vmi_periodic_sums sums = {0, 0, 0};
    int i;
    vmi_periodic_terms_at(p, delta, &terms);
    for (i = 0; i < VMI_FORCED_HARMONICS; i++) {
        const vm_real order = (vm_real)(2 * i + 1), G = terms.G[i];
        sums.S += order * G * terms.across[i];
        sums.C += G * terms.along[i];
        sums.slope += order * order * G * terms.along[i];
    }
    return sums;
}

/* The frequency (P/Q) nu, rad/s, of the vibration at the resonance. nu is the frequency of the force. */
VM_API vm_real vmi_periodic_frequency(const vm_periodic *p, vm_real nu)
{
    return nu * (vm_real)p->vibrations / (vm_real)p->periods;
}

/* Averaged equations of an oscillator under a periodic force near a resonance, for rk45 or rk87. The equations are at
   the top of this file. The array y = (A, delta, theta) contains the mean amplitude A, delta = phi - (P/Q) theta with
   the phase phi of the vibration, and the phase theta of the force. Start with vm_periodic_to_averaged, and end with
   vm_periodic_from_averaged. Let e be the largest of the damping b, the mass rate m' and the force F. Near the
   resonance, for times up to the order of 1/e, the error of x is of the order of e for alpha = 1, and between e and
   sqrt(e) for other alpha. The error is larger for motions that come close to an unstable vibration. The argument
   `periodic` and the statuses are those of vm_periodic_rhs. */
VM_API int vm_periodic_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *periodic)
{
    if (!y || !dydt || !periodic) return VM_BAD_ARGUMENT;
    const vm_periodic *p = (const vm_periodic *)periodic;
    const vm_forced *f = &p->oscillator;
    vmi_forced_parameters n;
    vmi_periodic_sums sums;
    vm_real w;
    const int status = vmi_periodic_at(p, t, &n);
    if (status) return status;
    sums = vmi_periodic_sums_at(p, y[1]);
    w = vmi_forced_natural(f, &n, y[0]);
    dydt[0] = -vmi_forced_q(f, &n) * y[0] / (f->alpha + 3) - n.force / (n.mass * w) * sums.S;
    dydt[1] = w - vmi_periodic_frequency(p, n.nu) - n.force / (n.mass * w * y[0]) * sums.C;
    dydt[2] = n.nu;
    return VM_OK;
}

/* The ripple of the amplitude, which is the exact amplitude minus the mean amplitude, at the frequency w and the phase
   phi of the vibration and the phase theta of the force. The function has the type vmi_ripple_of_force. Slow changes
   and damping, which act at the rate q, give the ripple q A/((alpha+3) Om) sa ca, where Om is the rate of the Ateb
   phase. The force adds F/(m Om) times the sum over j and n of
     s_j/2 [(a_n cos u + b_n sin u)/(j w + n nu) + (a_n cos v - b_n sin v)/(j w - n nu)],
   where u = j phi + n theta, v = j phi - n theta, and s_j is the Fourier coefficient of sin(j phi) in sa. For a j and
   an n that are in resonance the second quotient is left out, since v does not vary at the resonance. */
VM_API vm_real vmi_periodic_ripple(const void *periodic, const vmi_forced_parameters *n, vm_real A, vm_real w,
                                   vm_real phi, vm_real theta)
{
    const vm_periodic *p = (const vm_periodic *)periodic;
    const vm_forced *f = &p->oscillator;
    const vm_real Om = vmi_slow_rate(A, n->k, n->mass, f->alpha);
    vm_complex vibration[2 * VMI_FORCED_HARMONICS], force[VM_PERIODIC_HARMONICS + 1];
    vm_real sa, ca, sum = 0;
    int i, k;
    ateb_saca(phi * (f->pi / VM_PI), f->alpha, &sa, &ca);
    vmi_c_turns(2 * VMI_FORCED_HARMONICS - 1, phi, vibration);
    vmi_c_turns(VM_PERIODIC_HARMONICS, theta, force);
    for (i = 0; i < VMI_FORCED_HARMONICS; i++) {
        const int j = 2 * i + 1;
        const vm_real rate = (vm_real)j * w;
        for (k = 0; k <= VM_PERIODIC_HARMONICS; k++) {
            const vm_complex u = vmi_c_times(vibration[j], force[k]);
            const vm_complex v = vmi_c_times(vibration[j], vmi_c_conjugate(force[k]));
            const vm_real a = p->cosine[k], b = k > 0 ? p->sine[k] : 0, turn = (vm_real)k * n->nu;
            sum += f->s[i] / 2 * (a * u.re + b * u.im) / (rate + turn);
            if (k == 0 || k != vmi_periodic_partner(p, j)) sum += f->s[i] / 2 * (a * v.re - b * v.im) / (rate - turn);
        }
    }
    return vmi_forced_q(f, n) * A / ((f->alpha + 3) * Om) * sa * ca + n->force / (n->mass * Om) * sum;
}

/* Converts a motion (x, x', theta) under a periodic force, near the resonance, to its mean y = (A, delta, theta) (see
   vm_periodic_averaged_rhs). A is the amplitude without its ripple within a period. Returns the statuses of
   vm_periodic_rhs. In addition it returns VM_NOT_FINITE where a number of the motion is infinite or NaN, and VM_DOMAIN
   where the amplitude minus its ripple is not positive, or where the ripple is about as large as the amplitude, as near
   x = x' = 0. y and motion may be the same array. */
VM_API int vm_periodic_to_averaged(const vm_periodic *p, vm_real t, const vm_real *motion, vm_real *y)
{
    if (!p || !motion || !y) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int status = vmi_periodic_at(p, t, &n);
    const vm_real theta = motion[2];
    vm_real resonance, A, phi;
    if (!vmi_all_finite(3, motion)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    resonance = vmi_periodic_frequency(p, n.nu);
    status = vmi_forced_split(&p->oscillator, &n, vmi_periodic_ripple, p, resonance, motion, &A, &phi);
    if (status) return status;
    y[0] = A;
    y[1] = phi - vmi_periodic_frequency(p, theta);
    y[2] = theta;
    return VM_OK;
}

/* Converts the mean y = (A, delta, theta) under a periodic force to the motion (x, x', theta). This is the inverse of
   vm_periodic_to_averaged: it adds the ripple again. Returns the statuses of vm_periodic_rhs. In addition it returns
   VM_NOT_FINITE where a number of y is infinite or NaN, and VM_DOMAIN where A <= 0 or A plus its ripple is negative.
   motion and y may be the same array. */
VM_API int vm_periodic_from_averaged(const vm_periodic *p, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!p || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int status = vmi_periodic_at(p, t, &n);
    if (!vmi_all_finite(3, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    return vmi_forced_join(&p->oscillator, &n, vmi_periodic_ripple, p, y[0], y[1] + vmi_periodic_frequency(p, y[2]),
                           y[2], motion);
}

/* What the search for steady vibrations needs. S and C are the sums at the top of this file. The amplitude follows from
   S. Near a phase where S = 0, the rounding error of the phase would cause a large relative error of S. Therefore the
   search takes such a phase as the origin, and counts phases from there. */
typedef struct VM_TAG(vmi_periodic_search) {
    const vm_periodic *p;
    vmi_resonance z; /* its field push is F/m here, without the factor G; its field nu is (P/Q) nu, where nu is the
                        frequency of the force */
    vm_real origin;           /* the phase delta from which phases are counted, rad */
    vm_real S_at_origin;      /* S at the origin; exactly 0 if the origin is a zero of S */
    vmi_periodic_terms terms; /* the terms of the sums at the origin */
} vmi_periodic_search;

/* Prepares the search, with phases counted from delta = 0. */
VM_API vmi_periodic_search vmi_periodic_search_of(const vm_periodic *p, const vmi_forced_parameters *n)
{
    vmi_periodic_search search;
    search.p = p;
    search.z = vmi_resonance_of(&p->oscillator, n);
    search.z.push = n->force / n->mass;
    search.z.nu = vmi_periodic_frequency(p, n->nu);
    search.origin = 0;
    search.S_at_origin = vmi_periodic_sums_at(p, 0).S;
    vmi_periodic_terms_at(p, 0, &search.terms);
    return search;
}

/* Counts phases from `zero`, a zero of S from 0 to pi, or from zero - pi if side is -1. All harmonics of the vibration
   are odd; therefore S and C only change their signs if pi is subtracted from the phase. */
VM_API void vmi_periodic_count_from(vmi_periodic_search *s, vm_real zero, int side)
{
    int i;
    vmi_periodic_terms_at(s->p, zero, &s->terms);
    s->origin = zero;
    s->S_at_origin = 0;
    if (side > 0) return;
    s->origin -= VM_PI;
    for (i = 0; i < VMI_FORCED_HARMONICS; i++) s->terms.G[i] = -s->terms.G[i];
}

/* The sums at a phase that is counted from the origin of the search */
VM_API vmi_periodic_sums vmi_periodic_sums_from(const vmi_periodic_search *s, vm_real phase)
{
    vm_complex turns[2 * VMI_FORCED_HARMONICS];
    vmi_periodic_sums sums = {0, 0, 0};
    int i;
    vmi_c_turns(2 * VMI_FORCED_HARMONICS - 1, phase, turns);
    sums.S = s->S_at_origin;
    for (i = 0; i < VMI_FORCED_HARMONICS; i++) {
        const vm_real order = (vm_real)(2 * i + 1), G = s->terms.G[i];
        const vm_real along = s->terms.along[i], across = s->terms.across[i];
        const vm_complex turn = turns[2 * i + 1];
        const vm_real now_along = along * turn.re - across * turn.im;
        vm_real versine = 1 - turn.re; /* 1 - cos(j phase) */
        if (turn.re > 0) versine = turn.im * turn.im / (1 + turn.re); /* the same without loss of digits */
        sums.S += order * G * (along * turn.im - across * versine);
        sums.C += G * now_along;
        sums.slope += order * order * G * now_along;
    }
    return sums;
}

/* Returns 1 if the phase of a steady vibration determines its amplitude, else 0. It does not if there is neither damping
   nor a slow change (q = 0), or if these are so weak that the quotient of force and p = q/(alpha+3) overflows. */
VM_INLINE int vmi_periodic_has_amplitudes(const vmi_resonance *z) { return VM_IS_FINITE(z->push / z->p); }

/* The amplitude for which the averaged equations give A' = 0 if the sum has the value S. This amplitude A follows from
   A w(A) = -S F/(m p), where p is q/(alpha+3), F/m the force per mass, and w(A) the frequency of the free vibration.
   The result is 0 where there is no such amplitude. */
VM_API vm_real vmi_periodic_amplitude(const vmi_resonance *z, vm_real S)
{
    const vm_real product = -z->push / z->p * S;
    if (!(product > 0)) return 0;
    return vmi_pow_checked(product / z->w1, 1 / (1 + z->exponent));
}

/* The excess, which is delta' of the averaged equations times the absolute value of the sum S, at a phase that is
   counted from the origin of the search, with the amplitude A for which A' = 0. The zeros of the excess with A > 0 are
   the steady vibrations. */
typedef struct VM_TAG(vmi_periodic_excess) {
    vm_real sum;   /* the excess; `limit` where no amplitude has A' = 0 */
    vm_real limit; /* the part of the excess that does not tend to 0 with A: p C sign(S) with p = q/(alpha+3), and for
                      alpha = 0 also w |S|, which is then constant */
    vm_real reach; /* a bound of |sum - limit|, which becomes smaller as A does */
} vmi_periodic_excess;

VM_API vmi_periodic_excess vmi_periodic_excess_at(const vmi_periodic_search *s, vm_real phase)
{
    const vmi_resonance *z = &s->z;
    const vmi_periodic_sums sums = vmi_periodic_sums_from(s, phase);
    const vm_real A = vmi_periodic_amplitude(z, sums.S);
    vmi_periodic_excess e;
    vm_real w;
    e.limit = -VM_COPYSIGN(z->p, z->push) * sums.C; /* p C sign(S), where sign(S) is -sign(push p) */
    e.reach = z->nu * VM_FABS(sums.S);
    if (z->exponent <= VM_C(-0.5)) { /* alpha = 0 */
        e.limit += z->w1 * z->w1 * VM_FABS(z->p / z->push);
        e.sum = e.limit - e.reach;
    } else {
        w = z->w1 * vmi_pow_checked(A, z->exponent);
        e.sum = e.limit + (w - z->nu) * VM_FABS(sums.S);
        e.reach += w * VM_FABS(sums.S);
    }
    if (A > 0) return e;
    e.sum = e.limit;
    e.reach = 0;
    return e;
}

/* The field `sum` of the excess, for vmi_find_zero */
VM_API vm_real vmi_periodic_excess_sum(vm_real phase, void *search)
{
    return vmi_periodic_excess_at((const vmi_periodic_search *)search, phase).sum;
}

/* Returns the steady vibration of a phase that is counted from the origin of the search, with trace and determinant of
   the linearized averaged equations. The frequency nu of the force follows from the phase. The field A is 0 where there
   is no such vibration. */
VM_API vm_steady_state vmi_periodic_state(const vmi_periodic_search *search, vm_real phase)
{
    const vmi_resonance *z = &search->z;
    const vmi_periodic_sums sums = vmi_periodic_sums_from(search, phase);
    const vm_real gain = 1 + z->exponent, p = z->p;
    vm_steady_state s;
    vm_real w, off;
    s.A = vmi_periodic_amplitude(z, sums.S);
    w = z->w1 * vmi_pow_checked(s.A, z->exponent);
    off = -p * sums.C / sums.S; /* w - (P/Q) nu */
    s.nu = (w - off) * (vm_real)search->p->periods / (vm_real)search->p->vibrations;
    s.delta = search->origin + phase;
    s.trace = -(1 + gain) * p;
    s.det = p * p * gain - p * sums.slope / sums.S * (z->exponent * w + gain * off);
    s.stable = s.det > 0 && s.trace < 0;
    return s;
}

/* Steady vibration of the phase delta under a periodic force: a point of the resonance curve. Each phase delta, rad,
   belongs to at most one amplitude and one frequency nu of the force, so that values of delta from -pi to pi give the
   whole curve. The field delta of *steady is the given delta, even if it is not between -pi and pi. The field nu of
   *steady is the frequency of the force; the frequency in the fields of the oscillator is not used.
   All other parameters are those at time t. Returns the statuses of vm_periodic_rhs. In addition it returns
   VM_NOT_FINITE where delta is not finite, and VM_DOMAIN in two cases: where no steady vibration has this phase, and
   where q = 0 in the averaged equations, or so small that the quotient of force and q overflows. q is 0 if there is
   neither damping nor a slow change; then the phase does not determine the amplitude. An error leaves *steady as it
   was. */
VM_API int vm_periodic_curve(const vm_periodic *p, vm_real t, vm_real delta, vm_steady_state *steady)
{
    if (!p || !steady) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    vmi_periodic_search search;
    vm_steady_state found;
    int status = vmi_periodic_at(p, t, &n);
    if (status != VM_BAD_ARGUMENT && !VM_IS_FINITE(delta)) status = VM_NOT_FINITE;
    if (status) return status;
    search = vmi_periodic_search_of(p, &n);
    if (!vmi_periodic_has_amplitudes(&search.z)) return VM_DOMAIN;
    found = vmi_periodic_state(&search, delta);
    if (!(found.A > 0) || !(found.nu > 0)) return VM_DOMAIN;
    if (!VM_IS_FINITE(found.A) || !VM_IS_FINITE(found.nu) || !VM_IS_FINITE(found.det)) return VM_NOT_FINITE;
    *steady = found;
    return VM_OK;
}

/* The steady vibrations that a search has found */
typedef struct VM_TAG(vmi_periodic_list) {
    int found, room;         /* how many have been found; how many places `steady` has */
    vm_steady_state *steady; /* those with the smallest amplitudes, sorted by amplitude */
    vm_real nu;              /* frequency of the force, rad/s */
} vmi_periodic_list;

/* Inserts a steady vibration into the list, unless its amplitude is below VM_MIN. If the list is full, the vibration
   with the largest amplitude is dropped. */
VM_API void vmi_periodic_insert(vmi_periodic_list *list, vm_steady_state state)
{
    int i = list->found;
    if (!(state.A >= VM_MIN)) return; /* below VM_MIN, A has too few digits for a search */
    if (i > list->room) i = list->room;
    state.nu = list->nu;
    if (state.delta > VM_PI) state.delta -= 2 * VM_PI;
    if (state.delta < -VM_PI) state.delta += 2 * VM_PI;
    for (; i > 0 && list->steady[i - 1].A > state.A; i--)
        if (i < list->room) list->steady[i] = list->steady[i - 1];
    if (i < list->room) list->steady[i] = state;
    list->found++;
}

/* Inserts the steady vibrations between the phase `outer`, where the excess is at_outer, and the origin of the search,
   which is a zero of S. The steps are one degree long. Near the origin, where this would be too long, each step is
   three tenths of the phase, because the amplitude varies there as a power of the phase. The walk ends where the excess
   cannot change its sign any more, at the latest where the phase is below VM_MIN. */
VM_API void vmi_periodic_walk(vmi_periodic_search *search, vm_real outer, vm_real at_outer, vmi_periodic_list *list)
{
    const vm_real degree = VM_COPYSIGN(VM_PI / 180, outer), ratio = VM_C(0.7);
    vm_real phase = outer, before = at_outer;
    vmi_periodic_excess e;
    do {
        const vm_real last = phase;
        phase *= ratio;
        if (VM_FABS(last - phase) > VM_FABS(degree)) phase = last - degree;
        e = vmi_periodic_excess_at(search, phase);
        if ((before > 0) != (e.sum > 0))
            vmi_periodic_insert(list, vmi_periodic_state(search, vmi_find_zero(vmi_periodic_excess_sum, search, phase,
                                                                               last, e.sum, before)));
        before = e.sum;
    } while (e.reach > VM_FABS(e.limit) / 2 && VM_FABS(phase) >= VM_MIN);
}

/* The sum S at the phase delta, for vmi_find_zero */
VM_API vm_real vmi_periodic_S(vm_real delta, void *search)
{
    return vmi_periodic_sums_at(((const vmi_periodic_search *)search)->p, delta).S;
}

/* Writes the zeros of S from 0 to pi to `zeros`, in ascending order, and returns how many there are. If S is positive
   just after zero i, rises[i] is 1, else 0. S(delta + pi) = -S(delta), so that S has at least one zero. It has at most
   nine, the largest j in S. The function looks for changes of sign in steps of one degree. */
VM_API int vmi_periodic_zeros(vmi_periodic_search *search, vm_real *zeros, int *rises)
{
    const vm_real first = vmi_periodic_S(0, search);
    vm_real before = first;
    int degree, n = 0;
    for (degree = 1; degree <= 180; degree++) {
        const vm_real left = VM_PI * (vm_real)(degree - 1) / 180, right = VM_PI * (vm_real)degree / 180;
        vm_real after = -first;
        int rise = !(first > 0);
        if (degree < 180) {
            after = vmi_periodic_S(right, search);
            rise = after > 0;
        }
        if (rise != (before > 0) && n < VM_PERIODIC_HARMONICS) {
            zeros[n] = vmi_find_zero(vmi_periodic_S, search, left, right, before, after);
            rises[n] = rise;
            n++;
        }
        before = after;
    }
    return n;
}

/* Steady vibrations under a periodic force, near the resonance, with their amplitudes, phases and stability. All
   parameters are those at time t. Writes at most `room` vibrations to steady, the smallest amplitudes first, and
   returns how many there are (this number may be larger than room), or a negative status. The function looks for
   changes of sign of delta' as a function of the phase, with the amplitude for which A' = 0. It computes delta' at
   phases that are one degree apart, or closer where the amplitudes are small. It may therefore miss two vibrations
   whose phases differ by less than a degree. Such vibrations lie next to a fold of the resonance curve. It leaves out
   vibrations with amplitudes below VM_MIN. It also leaves out vibrations whose phase differs by less than VM_MIN from a
   phase at which S = 0; there are such vibrations only if q is extremely small. For a harmonic force use
   vm_forced_steady_states. The function takes about as long as the computation of 5000 sines (docs/counts.md). The
   negative statuses are those of vm_periodic_rhs. In addition the function returns VM_BAD_ARGUMENT for room < 0, and
   VM_DOMAIN if q is 0 or very small, as the comment of vm_periodic_curve explains. */
VM_API int vm_periodic_steady_states(const vm_periodic *p, vm_real t, int room, vm_steady_state *steady)
{
    if (!p || !steady || room < 0) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    vmi_periodic_search search;
    vmi_periodic_list list;
    vm_real zeros[VM_PERIODIC_HARMONICS];
    int rises[VM_PERIODIC_HARMONICS], count, i;
    const int status = vmi_periodic_at(p, t, &n);
    if (status) return status;
    search = vmi_periodic_search_of(p, &n);
    if (!vmi_periodic_has_amplitudes(&search.z)) return VM_DOMAIN;
    if (search.z.push == 0) return 0;
    list.found = 0;
    list.room = room;
    list.steady = steady;
    list.nu = n.nu;
    count = vmi_periodic_zeros(&search, zeros, rises);
    /* Each round searches between two neighbouring zeros of S. Of any two phases that differ by pi, only the one at
       which S has the sign of -p push belongs to an amplitude; `side` says which one it is. */
    for (i = 0; i < count; i++) {
        const int is_last = i == count - 1, side = rises[i] == (search.z.push / search.z.p < 0) ? 1 : -1;
        const vm_real left = zeros[i], right = is_last ? zeros[0] : zeros[i + 1];
        const vm_real half = (is_last ? right + VM_PI - left : right - left) / 2;
        vm_real middle;
        vmi_periodic_count_from(&search, left, side);
        middle = vmi_periodic_excess_sum(half, &search);
        vmi_periodic_walk(&search, half, middle, &list);
        vmi_periodic_count_from(&search, right, is_last ? -side : side);
        vmi_periodic_walk(&search, -half, middle, &list);
    }
    return list.found;
}

#endif
