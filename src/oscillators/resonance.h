/* oscillators/resonance.h - steady vibrations, resonance curves, passage through resonance

   For an oscillator under harmonic excitation (forced.h, which explains the symbols), this file computes all steady
   vibrations and their stability, and the amplitude-frequency curve with its peak. It also tells whether the vibration
   passes through the resonance or is captured by it while frequency, mass or stiffness change slowly. The results
   follow from the averaged equations. Therefore they hold near the main resonance, where the natural frequency w(A) at
   the amplitude A is about the frequency nu of the force. All functions use mass, stiffness, frequency, force and their
   rates at one time t.

       vm_steady_state steady[3];
       int n = vm_forced_steady_states(&forced, 0, steady); // forced is a vm_forced after vm_forced_init

   Tests: tests/test_forced.c. */
#ifndef VARMASS_OSCILLATORS_RESONANCE_H
#define VARMASS_OSCILLATORS_RESONANCE_H

#include "../ateb/phase.h"
#include "../base/complex.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/words.h"
#include "../base/zero.h"
#include "forced.h"

/* A steady vibration: a solution of the averaged equations with A' = delta' = 0 */
typedef struct VM_TAG(vm_steady_state) {
    vm_real nu;         /* frequency of the force, rad/s */
    vm_real A;          /* mean amplitude, m; vm_forced_from_averaged gives the motion with its ripple */
    vm_real delta;      /* phase by which the vibration leads the force, rad, -pi <= delta <= pi */
    vm_real trace, det; /* trace and determinant of the linearized equations: small deviations from the steady vibration
                           vary as e^(lambda t), where lambda^2 - trace lambda + det = 0 */
    int stable;         /* 1 if the vibration is stable, which means det > 0 and trace < 0; else 0. If det < 0, the
                           vibration is a saddle */
} vm_steady_state;

/* The passage through the resonance, for the rates of mass, stiffness and frequency at one time */
typedef struct VM_TAG(vm_passage) {
    vm_real A;              /* amplitude, m, whose natural frequency w(A) is the frequency nu of the force; for alpha =
                               1 the argument `amplitude` */
    vm_real drift_ratio;    /* rate at which w - nu changes without the force, divided by the largest rate of change
                               that the force can balance. If the ratio is below 1, the vibration may be captured, so
                               that its amplitude follows A; if the ratio is above 1, the vibration passes through the
                               resonance */
    vm_real delta;          /* phase by which the captured vibration leads the force, rad; NaN for drift_ratio > 1 */
    vm_real amplitude_jump; /* largest relative change of the amplitude in a quick passage (drift_ratio much larger
                               than 1). The change depends on the phase at the start and may have either sign */
} vm_passage;

/* The quantities that determine the resonance at one time */
typedef struct VM_TAG(vmi_resonance) {
    vm_real w1, exponent; /* natural frequency w = w1 A^exponent, rad/s */
    vm_real nu;           /* frequency of the force, rad/s */
    vm_real p;            /* decay rate of free vibrations, 1/s: their amplitude follows A' = -p A */
    vm_real push;         /* F G/m, the force per mass that drives the mean motion; F is the force, m the mass, G a
                             field of vm_forced */
} vmi_resonance;

/* Computes the quantities of vmi_resonance for the oscillator f with the parameters n. */
VM_API vmi_resonance vmi_resonance_of(const vm_forced *f, const vmi_forced_parameters *n)
{
    vmi_resonance z;
    z.w1 = vmi_forced_natural(f, n, 1);
    z.exponent = (f->alpha - 1) / 2;
    z.nu = n->nu;
    z.p = vmi_forced_q(f, n) / (f->alpha + 3);
    z.push = n->force * f->G / n->mass;
    return z;
}

/* The excess ln(A w sqrt((w - nu)^2 + p^2)/|push|) at the amplitude A = e^x. The excess is 0 if A is the amplitude of a
   steady vibration. w = w1 A^exponent, nu, p and push are those of vmi_resonance. */
VM_API vm_real vmi_resonance_excess(vm_real x, void *resonance)
{
    const vmi_resonance *z = (const vmi_resonance *)resonance;
    const vm_real w = z->w1 * vmi_exp(z->exponent * x, 0), detuning = vmi_c_modulus(vmi_complex(w - z->nu, z->p));
    if (!(detuning > 0)) return -VM_MAX;
    return (1 + z->exponent) * x + vmi_log(z->w1 / VM_FABS(z->push) * detuning).hi;
}

/* Returns the steady vibration of amplitude A, with trace and determinant of the linearized averaged equations. */
VM_API vm_steady_state vmi_resonance_state(const vmi_resonance *z, vm_real alpha, vm_real A)
{
    const vm_real w = z->w1 * vmi_pow_checked(A, z->exponent), gain = (alpha + 1) / 2, off = w - z->nu, p = z->p;
    vm_steady_state s;
    s.nu = z->nu;
    s.A = A;
    s.delta = ateb_phase(-p * A * w / z->push, off * A * w / z->push, 1);
    s.trace = -(alpha + 3) * p / 2;
    s.det = p * p * gain + off * (z->exponent * w + gain * off);
    s.stable = s.det > 0 && s.trace < 0;
    return s;
}

/* The extrema of the function vmi_resonance_excess of x = ln A, for alpha != 1. Writes the x of at most two extrema, in
   ascending order, and returns how many there are. At an extremum the field det of vm_steady_state is 0, so that w
   solves 2 alpha w^2 - (3 alpha + 1) nu w + (alpha + 1)(nu^2 + p^2) = 0. */
VM_API int vmi_resonance_turns(const vmi_resonance *z, vm_real alpha, vm_real x[2])
{
    const vm_real bend = (alpha - 1) * z->nu, square = bend * bend - 8 * alpha * (alpha + 1) * z->p * z->p;
    vm_real half, first;
    if (!(square > 0)) return 0;
    half = (3 * alpha + 1) * z->nu + VM_SQRT(square);
    x[0] = vmi_log(2 * (alpha + 1) * (z->nu * z->nu + z->p * z->p) / (half * z->w1)).hi / z->exponent;
    if (!(alpha > 0)) return 1;
    x[1] = vmi_log(half / (4 * alpha * z->w1)).hi / z->exponent;
    if (x[0] > x[1]) {
        first = x[1];
        x[1] = x[0];
        x[0] = first;
    }
    return 2;
}

/* The amplitudes of the steady vibrations for alpha != 1. Writes at most three amplitudes, in ascending order, and
   returns how many there are. The amplitudes are the zeros of vmi_resonance_excess, a function of x = ln A. Between two
   neighbouring extrema, and outside the extrema, this function only rises or only falls. Therefore each of these
   intervals contains at most one zero. */
VM_API int vmi_resonance_roots(vmi_resonance *z, vm_real alpha, vm_real A[3])
{
    const vm_real steep = vmi_larger(VM_FABS(z->exponent), 1);
    const vm_real reach = -vmi_log(VM_MIN).hi / steep; /* for |x| <= reach, A and w neither overflow nor underflow */
    vm_real ends[4], turns[2], left, right;
    int i, found = 0;
    const int n = vmi_resonance_turns(z, alpha, turns);
    ends[0] = -reach;
    ends[n + 1] = reach;
    for (i = 0; i < n; i++) ends[i + 1] = vmi_clamp(turns[i], -reach, reach);
    for (i = 0; i <= n; i++) {
        left = vmi_resonance_excess(ends[i], z);
        right = vmi_resonance_excess(ends[i + 1], z);
        if (!((left > 0) != (right > 0))) continue;
        A[found++] = vmi_exp(vmi_find_zero(vmi_resonance_excess, z, ends[i], ends[i + 1], left, right), 0);
    }
    return found;
}

/* Steady vibrations of an oscillator under a harmonic force, with their amplitudes, phases and stability. All
   parameters are those at time t. Writes at most three vibrations to steady, the smallest amplitude first, and returns
   how many there are, 0 where the force is 0, or a negative status. In the tests the relative error of amplitudes,
   compared with solutions of the averaged equations, is at most 3e-14 (float 3e-5). To get the response at several
   frequencies nu of the force, call the function for each nu. The averaged equations are valid only near the resonance,
   where the natural frequency w(A) is about nu; far from the resonance a solution may differ from every real motion.
   The negative statuses are those of vm_forced_rhs. */
VM_API int vm_forced_steady_states(const vm_forced *f, vm_real t, vm_steady_state steady[3])
{
    if (!f || !steady) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int i, found = 0;
    const int status = vmi_forced_at(f, t, &n);
    vm_real A[3];
    vmi_resonance z;
    if (status) return status;
    z = vmi_resonance_of(f, &n);
    if (z.push == 0) return 0;
    if (f->alpha == 1) {
        A[0] = VM_FABS(z.push) / (z.w1 * vmi_c_modulus(vmi_complex(z.w1 - z.nu, z.p)));
        found = VM_IS_FINITE(A[0]);
    } else {
        found = vmi_resonance_roots(&z, f->alpha, A);
    }
    for (i = 0; i < found; i++) steady[i] = vmi_resonance_state(&z, f->alpha, A[i]);
    return found;
}

/* Steady vibrations of a given amplitude A, m, at any frequency nu > 0: points of the amplitude-frequency curve. Writes
   at most two vibrations to curve, the lower frequency first. The two vibrations lie on both sides of the backbone, the
   curve nu = w(A) with the natural frequency w. Returns how many there are, 0 where the force is too small for the
   amplitude A, or a negative status. The negative statuses are those of vm_forced_rhs; VM_DOMAIN also means that A is
   not positive. Results that overflow are infinite or NaN. */
VM_API int vm_forced_curve(const vm_forced *f, vm_real t, vm_real A, vm_steady_state curve[2])
{
    if (!f || !curve) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vmi_resonance z;
    vm_real w, hold, width, p;
    int found = 0;
    if (status == VM_BAD_ARGUMENT) return status;
    if (!VM_IS_FINITE(A)) return VM_NOT_FINITE;
    if (status) return status;
    if (!(A > 0)) return VM_DOMAIN;
    z = vmi_resonance_of(f, &n);
    w = vmi_forced_natural(f, &n, A);
    hold = VM_FABS(z.push) / (w * A);
    p = VM_FABS(z.p);
    if (!(hold >= p) || z.push == 0) return 0;
    width = VM_SQRT(hold - p) * VM_SQRT(hold + p); /* |w - nu| */
    z.nu = w - width;
    if (z.nu > 0) curve[found++] = vmi_resonance_state(&z, f->alpha, A);
    z.nu = w + width;
    if (width > 0) curve[found++] = vmi_resonance_state(&z, f->alpha, A);
    return found;
}

/* Largest amplitude, m, of the amplitude-frequency curve. The curve has this amplitude where it crosses the backbone nu
   = w(A), on which the frequency of the force is the natural frequency. The result is infinite without damping, but NaN
   if the force is 0, too. The relative error is at most 1e-14 (float 2e-5), unless damping and the rates of mass and
   stiffness nearly cancel; their rounding errors then make a larger error. Returns NaN for a null pointer and where
   the parameters at time t are not in their domain. */
VM_API vm_real vm_forced_peak(const vm_forced *f, vm_real t)
{
    if (!f) return VM_NAN;
    vmi_forced_parameters n;
    vmi_resonance z;
    if (vmi_forced_at(f, t, &n)) return VM_NAN;
    z = vmi_resonance_of(f, &n);
    return vmi_pow_checked(VM_FABS(z.push / z.p) / z.w1, 2 / (f->alpha + 1));
}

/* Passage through the resonance: tells whether the vibration passes through the resonance or is captured by it, while
   mass, stiffness and frequency change slowly with the rates that they have at time t. The argument `amplitude`, m, is
   used for alpha = 1 only, where the natural frequency w is the same for all amplitudes. Let nu be the frequency of the
   force, and delta the phase by which the vibration leads the force. Near w(A) = nu the averaged equations give delta''
   = -(gamma push/A) sin(delta) - nu D, which is the equation of a pendulum under a torque. Here gamma = (alpha - 1)/2,
   push is the field of vmi_resonance (a force per mass), and D is the rate at which ln(w/nu) would fall without the
   force. The field drift_ratio is the torque |nu D| divided by |gamma push/A|, the largest torque that the pendulum can
   balance. Returns the statuses of vm_forced_rhs; VM_DOMAIN also means that the force is 0, or that the amplitude is
   not positive and finite. An error leaves *passage as it was. */
VM_API int vm_forced_passage(const vm_forced *f, vm_real t, vm_real amplitude, vm_passage *passage)
{
    if (!f || !passage) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vmi_resonance z;
    vm_passage r;
    vm_real D, sine = VM_INFINITY, cosine;
    if (status) return status;
    z = vmi_resonance_of(f, &n);
    r.A = amplitude;
    if (z.exponent != 0) r.A = vmi_pow_checked(z.nu / z.w1, 1 / z.exponent);
    if (!(r.A > 0) || !VM_IS_FINITE(r.A) || z.push == 0) return VM_DOMAIN;
    D = n.mass_rate / (2 * n.mass) - n.k_rate / (2 * n.k) + n.nu_rate / n.nu + z.exponent * z.p;
    if (z.exponent != 0) sine = -z.nu * D * r.A / (z.exponent * z.push);
    r.drift_ratio = VM_FABS(sine);
    r.delta = VM_NAN;
    if (r.drift_ratio <= 1) {
        cosine = VM_COPYSIGN(VM_SQRT((1 - sine) * (1 + sine)), z.exponent * z.push);
        r.delta = ateb_phase(sine, cosine, 1);
    }
    r.amplitude_jump = VM_FABS(z.push) / (z.nu * r.A) * VM_SQRT(2 * VM_PI / (z.nu * VM_FABS(D)));
    *passage = r;
    return VM_OK;
}

#endif
