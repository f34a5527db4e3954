/* oscillators/expansion.h - the law of order five: from the motion of an oscillator to its mean motion and back

   With slow mass and stiffness, amplitude A and phase psi of oscillators/reduction.h obey the exact equations
     A'/A = -p + (G_0/W) sa ca,   psi' = W + (alpha+1)/2 (G_0/W) ca^2,
   where W is the rate of the phase at the amplitude A. The slow motion A'/A = -p, psi' = W is disturbed by G_0/W^2
   only. This number is of second order in epsilon, the relative change of mass and stiffness within a radian.

   A canonical transformation leads from A and psi to mean values without ripple: a mean action, which is constant, and
   a mean phase, whose rate varies slowly. The action is J = A^((alpha+3)/2) sqrt(mu kappa). The transformation is a
   series in powers of the numbers E_k of order epsilon^(k+2), k = 0, 1 ...
     E_k = G_k/W^(k+2),   G_(k+1) = G_k' - (k+2) (2p - a) G_k.
   This file has the transformation in both directions, and the mean rate of the phase. Cut off after order N, it gives
   the motion with an error of O(epsilon^N) over times of 1/epsilon. The law is new; docs/law.md derives it.

   C, S, S2, S3 and Q are the functions of the phase in oscillators/ripple.h. The weight of a term is the power of
   epsilon in it: E_k has weight k + 2.
       vmi_ripple r;
       vmi_ripple_values f;
       vm_real E[VMI_EXPANSION_E] = {VM_C(1e-4), 0, 0, 0}, ln_J;
       vmi_ripple_init(&r, 1, VM_PI);      // a linear spring
       vmi_ripple_at(&r, 2, 0, 0, 1, &f);  // phase 0: sa = 0, ca = 1
       ln_J = vmi_expansion_J(&r, 2, &f, E); // ln of the mean action over the action
   Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_EXPANSION_H
#define VARMASS_OSCILLATORS_EXPANSION_H

#include "../base/real.h"
#include "ripple.h"

/* How many E_k order five needs at the start of a motion: E_0 ... E_3 */
enum { VMI_EXPANSION_E = 4 };

/* -- From the motion to the mean motion -- */

/* Returns ln(mean action/action) with all terms up to weight `order`. f holds C, S ... at the phase psi. */
VM_API vm_real vmi_expansion_J(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, m = r->mean2, half = r->scale / 2, square = r->scale * r->scale / 8;
    vm_real sum = half * E[0] * f->C;
    if (order >= 3) sum -= half * E[1] * f->S;
    if (order >= 4) {
        const vm_real ripple = (2 - 3 * g) * r->variance - (1 + g) * f->C * f->C - 2 * (1 - g) * m * f->C;
        sum += half * E[2] * f->S2 + square * E[0] * E[0] * ripple;
    }
    if (order >= 5) {
        const vm_real ripple = 6 * (1 - g) * m * f->S + 2 * (2 - 3 * g) * f->Q + 6 * g * f->C * f->S;
        sum += square * E[0] * E[1] * ripple - half * E[3] * f->S3;
    }
    return sum;
}

/* Returns the mean phase minus the phase psi, with all terms up to weight order - 1. f holds C, S ... at psi. */
VM_API vm_real vmi_expansion_psi(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, m = r->mean2, half = r->scale / 2, square = r->scale * r->scale / 8;
    vm_real sum = 0;
    if (order >= 3) sum -= half * (1 - 2 * g) * E[0] * f->S;
    if (order >= 4) sum += half * (1 - 3 * g) * E[1] * f->S2;
    if (order >= 5) {
        const vm_real ripple = 4 * g * (1 - 2 * g) * f->C * f->S + (1 - 4 * g) * (2 - 3 * g) * f->Q +
                               2 * (1 - 4 * g) * (1 - g) * m * f->S;
        sum += square * E[0] * E[0] * ripple - half * (1 - 4 * g) * E[2] * f->S3;
    }
    return sum;
}

/* -- From the mean motion to the motion -- */

/* Returns the phase psi minus the mean phase, with all terms up to weight order - 1. f holds C, S ... at the mean
   phase. */
VM_API vm_real vmi_expansion_psi_back(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, m = r->mean2, half = r->scale / 2, square = r->scale * r->scale / 8;
    vm_real sum = 0;
    if (order >= 3) sum += half * (1 - 2 * g) * E[0] * f->S;
    if (order >= 4) sum -= half * (1 - 3 * g) * E[1] * f->S2;
    if (order >= 5) {
        const vm_real ripple = 2 * (1 - 2 * g) * (1 - 2 * g) * f->C * f->S - (1 - 4 * g) * (2 - 3 * g) * f->Q -
                               2 * (1 - 4 * g) * (1 - g) * m * f->S;
        sum += half * (1 - 4 * g) * E[2] * f->S3 + square * E[0] * E[0] * ripple;
    }
    return sum;
}

/* Returns ln(action/mean action) with all terms up to weight order - 1. f holds C, S ... at the mean phase. */
VM_API vm_real vmi_expansion_J_back(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, m = r->mean2, half = r->scale / 2, square = r->scale * r->scale / 8;
    vm_real sum = 0;
    if (order >= 3) sum -= half * E[0] * f->C;
    if (order >= 4) sum += half * E[1] * f->S;
    if (order >= 5) {
        const vm_real ripple = 8 / (r->alpha + 1) * (1 - 2 * g) * f->sa * f->ca * f->S + (1 - 3 * g) * f->C * f->C -
                               (2 - 3 * g) * r->variance + 2 * (1 - g) * m * f->C;
        sum += square * E[0] * E[0] * ripple - half * E[2] * f->S2;
    }
    return sum;
}

/* -- The mean rate of the phase -- */

/* The factor `first` of the mean rate of the phase, W (1 + first E_0 + second E_0^2), where W belongs to the mean
   action. Laws of all orders from 2 on need it. */
VM_API vm_real vmi_expansion_first(const vmi_ripple *r) { return (r->alpha + 1) / 2 * r->mean2; }

/* The factor `second` of the mean rate of the phase, W (1 + first E_0 + second E_0^2), which orders 4 and 5 need */
VM_API vm_real vmi_expansion_second(const vmi_ripple *r)
{
    return -r->scale * r->scale / 8 * r->variance * (2 - 3 * r->gamma) * (1 - 3 * r->gamma);
}

#endif
