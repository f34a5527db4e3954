/* oscillators/expansion.h - the law of order five: what lies between the motion of an oscillator and its mean motion

   The oscillator d(mu x')/dt + kappa x|x|^(alpha-1) = 0 has slow mu(t) and kappa(t): mu'/mu = a is what mass, reactive
   force and damping make of the momentum, and kappa/mu = k/m. With
     p = (ln mu kappa)'/(alpha+3),   V = x' + p x,   x = A ca(psi),   V = -(2/(alpha+1)) W A sa(psi)
   amplitude A and phase psi obey, without any approximation,
     A'/A = -p + (G0/W) sa ca,   psi' = W + (alpha+1)/2 (G0/W) ca^2,   G0 = p^2 - a p - p',
   where W is the rate of the phase at amplitude A. So the mean motion is disturbed by G0/W^2 alone, which is of second
   order in the small rate epsilon at which mass and stiffness change within a radian. A canonical transformation in
   powers of E_k = G_k/W^(k+2), of order epsilon^(k+2), with G_(k+1) = G_k' - (k+2) (2p - a) G_k, leads to mean
   values: of the action J, which is constant, and of the phase. This file has that transformation, there and back.
   Errors of order N are O(epsilon^N) over times of 1/epsilon. It is new; docs/law.md derives it.
   The functions C, S, S2, S3, Q of the phase are those of oscillators/ripple.h. The weight of a term is the power of
   epsilon in it: E_k has weight k + 2.
       dJ = vmi_expansion_J(&ripple, 5, &f, E); // ln of the mean action less ln of the action, at the phase of f
   Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_EXPANSION_H
#define VARMASS_OSCILLATORS_EXPANSION_H

#include "../base/real.h"
#include "ripple.h"

/* The numbers E_0 ... E_3 that order five needs at the start */
enum { VMI_EXPANSION_E = 4 };

/* -- From the motion to the mean motion -- */

/* ln of the mean action less ln of the action J, at the motion's phase, with all terms up to weight `order` */
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

/* The mean phase less the phase psi, at the motion's phase, with all terms up to weight order - 1 */
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

/* The phase less the mean phase, at the mean phase, with all terms up to weight order - 1 */
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

/* ln of the action less ln of the mean action, at the mean phase, with all terms up to weight order - 1 */
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

/* The mean rate of the phase is W (1 + first E0 + second E0^2), with W at the mean action. The factor `first` is used
   from order 2 on, `second` from order 4 on. */
VM_API vm_real vmi_expansion_first(const vmi_ripple *r) { return (r->alpha + 1) / 2 * r->mean2; }

VM_API vm_real vmi_expansion_second(const vmi_ripple *r)
{
    return -r->scale * r->scale / 8 * r->variance * (2 - 3 * r->gamma) * (1 - 3 * r->gamma);
}

#endif
