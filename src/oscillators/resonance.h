/* oscillators/resonance.h - steady vibrations, resonance curves, passage through resonance */
#ifndef VARMASS_OSCILLATORS_RESONANCE_H
#define VARMASS_OSCILLATORS_RESONANCE_H

#include "../ateb/phase.h"
#include "../base/complex.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "forced.h"

/* Steady vibrations, all quantities as they are at time t: at most three, their amplitudes growing. The number of
   them, or a negative status. A is the mean amplitude; the waveform, with its ripple, is vm_forced_from_averaged's. For the
   response at each frequency let now.nu run. Those far from w(A) = nu are labels only: the averaged equations hold
   near the resonance. */
typedef struct VM_TAG(vm_steady_state) {
    vm_real nu, A, delta;
    vm_real trace, det; /* of the averaged equations there: rates lambda^2 - trace lambda + det = 0 */
    int stable;         /* det > 0 and trace < 0; det < 0 is a saddle */
} vm_steady_state;

/* Passage through the resonance, all rates as they are at time t. The backbone's amplitude A at nu; torque: the
   drift of w - nu over the force's hold on it, below 1 the vibration may be captured and follow A, with the phase
   delta, above 1 it passes; jump: half the range of the relative change of A in a quick passage, torque >> 1, over
   all phases. For alpha = 1 A cannot be told from nu: it is the amplitude given. */
typedef struct VM_TAG(vm_passage) {
    vm_real A, torque, delta, jump; /* delta NaN where torque > 1 */
} vm_passage;

/* The resonance with all quantities frozen, p = q/(alpha+3) */
typedef struct VM_TAG(vmi_forced_frozen_state) {
    vm_real w1, exponent, nu, p, push; /* w = w1 A^exponent; push = force G/m, signed */
} vmi_forced_frozen_state;

VM_API vmi_forced_frozen_state vmi_forced_freeze(const vm_forced *f, const vm_forced_parameters *n)
{
    vmi_forced_frozen_state z;
    z.w1 = vmi_forced_natural(f, n, 1);
    z.exponent = (f->alpha - 1) / 2;
    z.nu = n->nu;
    z.p = vmi_forced_q(f, n) / (f->alpha + 3);
    z.push = n->force * f->G / n->mass;
    return z;
}

/* ln of A w sqrt((w - nu)^2 + p^2)/|push|, 0 at a steady amplitude A = e^x */
VM_API vm_real vmi_forced_excess(vm_real x, void *frozen)
{
    const vmi_forced_frozen_state *z = (const vmi_forced_frozen_state *)frozen;
    const vm_real w = z->w1 * vmi_exp(z->exponent * x, 0), detuning = vmi_c_modulus(vmi_complex(w - z->nu, z->p));
    if (!(detuning > 0)) return -VM_MAX;
    return (1 + z->exponent) * x + vmi_log(z->w1 / VM_FABS(z->push) * detuning).hi;
}

VM_API vm_steady_state vmi_forced_state(const vmi_forced_frozen_state *z, vm_real alpha, vm_real A)
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

/* The values of x = ln A between which the excess is monotonic: w of det = 0, which is 2 alpha w^2 - (3 alpha + 1)
   nu w + (alpha + 1)(nu^2 + p^2) = 0; their number */
VM_API int vmi_forced_turns(const vmi_forced_frozen_state *z, vm_real alpha, vm_real *x)
{
    const vm_real bend = (alpha - 1) * z->nu, square = bend * bend - 8 * alpha * (alpha + 1) * z->p * z->p;
    const vm_real half = (3 * alpha + 1) * z->nu + (square > 0 ? VM_SQRT(square) : 0);
    int n = 0;
    if (!(square > 0)) return 0; /* so for alpha = 1 */
    x[n++] = vmi_log(2 * (alpha + 1) * (z->nu * z->nu + z->p * z->p) / (half * z->w1)).hi / z->exponent;
    if (alpha > 0) x[n++] = vmi_log(half / (4 * alpha * z->w1)).hi / z->exponent;
    if (n == 2 && x[0] > x[1]) {
        x[2] = x[0];
        x[0] = x[1];
        x[1] = x[2];
    }
    return n;
}

/* The steady amplitudes of alpha != 1: one at most below, between and above the turns */
VM_API int vmi_forced_roots(vmi_forced_frozen_state *z, vm_real alpha, vm_real *A)
{
    const vm_real steep = VM_FABS(z->exponent) > 1 ? VM_FABS(z->exponent) : 1;
    const vm_real reach = -vmi_log(VM_MIN).hi / steep; /* A and w are numbers to there */
    vm_real ends[5], turns[3], left, right;
    int i, n = vmi_forced_turns(z, alpha, turns), found = 0;
    ends[0] = -reach;
    ends[n + 1] = reach;
    for (i = 0; i < n; i++) ends[i + 1] = turns[i] < -reach ? -reach : turns[i] > reach ? reach : turns[i];
    for (i = 0; i <= n; i++) {
        left = vmi_forced_excess(ends[i], z);
        right = vmi_forced_excess(ends[i + 1], z);
        if (!((left > 0) != (right > 0))) continue;
        A[found++] = vmi_exp(vmi_find_zero(vmi_forced_excess, z, ends[i], ends[i + 1], left, right), 0);
    }
    return found;
}

VM_API int vm_forced_steady_states(const vm_forced *f, vm_real t, vm_steady_state steady[3])
{
    if (!f || !steady) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    int i, found = 0;
    const int status = vmi_forced_check(&n);
    vm_real A[3];
    vmi_forced_frozen_state z;
    if (status) return status;
    z = vmi_forced_freeze(f, &n);
    if (z.push == 0) return 0;
    if (f->alpha == 1) {
        A[0] = VM_FABS(z.push) / (z.w1 * vmi_c_modulus(vmi_complex(z.w1 - z.nu, z.p)));
        found = VM_IS_FINITE(A[0]);
    } else found = vmi_forced_roots(&z, f->alpha, A);
    for (i = 0; i < found; i++) steady[i] = vmi_forced_state(&z, f->alpha, A[i]);
    return found;
}

/* The amplitude-frequency curve, traced by its amplitude: the steady vibrations of amplitude A at any nu > 0, the
   backbone w(A) in the middle between two. Their number, 0 where the force is too small for A, or a negative
   status. */
VM_API int vm_forced_curve(const vm_forced *f, vm_real t, vm_real A, vm_steady_state curve[2])
{
    if (!f || !curve) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vmi_forced_frozen_state z;
    vm_real w, hold, width, p;
    int found = 0;
    if (status) return status;
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_DOMAIN;
    z = vmi_forced_freeze(f, &n);
    w = vmi_forced_natural(f, &n, A);
    hold = VM_FABS(z.push) / (w * A);
    p = VM_FABS(z.p);
    if (!(hold >= p) || z.push == 0) return 0;
    width = VM_SQRT(hold - p) * VM_SQRT(hold + p);
    z.nu = w - width;
    if (z.nu > 0) curve[found++] = vmi_forced_state(&z, f->alpha, A);
    z.nu = w + width;
    if (width > 0) curve[found++] = vmi_forced_state(&z, f->alpha, A); /* NaN: overflow */
    return found;
}

/* The amplitude where the curve meets the backbone, its largest; infinite without damping */
VM_API vm_real vm_forced_peak(const vm_forced *f, vm_real t)
{
    if (!f) return VM_NAN;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    vmi_forced_frozen_state z;
    if (vmi_forced_check(&n)) return VM_NAN;
    z = vmi_forced_freeze(f, &n);
    return vmi_pow_checked(VM_FABS(z.push / z.p) / z.w1, 2 / (f->alpha + 1));
}

/* delta'' = -(gamma push/A) sin delta - nu D, a pendulum under a torque, gamma = (alpha - 1)/2, D the relative
   drift of w - nu; and for gamma = 0 the same jump */
VM_API int vm_forced_passage(const vm_forced *f, vm_real t, vm_real amplitude, vm_passage *passage)
{
    if (!f || !passage) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vmi_forced_frozen_state z;
    vm_passage r;
    vm_real D, sine;
    if (status) return status;
    z = vmi_forced_freeze(f, &n);
    r.A = z.exponent == 0 ? amplitude : vmi_pow_checked(z.nu / z.w1, 1 / z.exponent);
    if (!(r.A > 0) || !VM_IS_FINITE(r.A) || z.push == 0) return VM_DOMAIN;
    D = n.mass_rate / (2 * n.mass) - n.k_rate / (2 * n.k) + n.nu_rate / n.nu + z.exponent * z.p;
    sine = z.exponent == 0 ? VM_INFINITY : -z.nu * D * r.A / (z.exponent * z.push);
    r.torque = VM_FABS(sine);
    r.delta = r.torque <= 1
                  ? ateb_phase(sine, VM_COPYSIGN(VM_SQRT((1 - sine) * (1 + sine)), z.exponent * z.push), 1)
                  : VM_NAN;
    r.jump = VM_FABS(z.push) / (z.nu * r.A) * VM_SQRT(2 * VM_PI / (z.nu * VM_FABS(D)));
    *passage = r;
    return VM_OK;
}

#endif
