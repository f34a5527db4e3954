/* oscillators/expansion.h - the law of order five: from the motion of an oscillator to its mean motion and back

   If mass and stiffness vary slowly, amplitude A and phase psi of oscillators/reduction.h obey the exact equations
     A'/A = -p + (G_0/W) sa ca,   psi' = W + (alpha+1)/2 (G_0/W) ca^2,
   where W is the rate of the phase at the amplitude A for constant mass and stiffness; p and G_0 are defined in
   oscillators/reduction.h. Only the number G_0/W^2 disturbs the slow motion A'/A = -p, psi' = W. This number is of
   second order in epsilon, the relative change of mass and stiffness within a radian of the phase.

   A canonical transformation, which is a change of variables that keeps the form of Hamilton's equations, leads from A
   and psi to two mean values: a mean action, which is constant, and a mean phase, whose rate varies slowly. The mean
   values do not contain the ripple, the small swing within a period. The action is J = A^((alpha+3)/2) sqrt(mu kappa),
   with mu and kappa of oscillators/reduction.h. The transformation is a series in powers of the numbers E_k, k = 0, 1
   ..., which are of order epsilon^(k+2):
     E_k = G_k/W^(k+2),   G_(k+1) = G_k' - (k+2) (2p - a) G_k.
   Here a is the rate of oscillators/reduction.h. This file has the transformation in both directions, and the mean rate
   of the phase. If the series is cut off after the order N, the error of the motion is of the order epsilon^N, up to
   times of the order of 1/epsilon. The law is new; docs/law.md derives it.

   C, S, S2, S3 and Q are the functions of the phase in oscillators/ripple.h. The weight of a term is the power of
   epsilon in it: E_k has weight k + 2.
       vmi_ripple r;
       vmi_ripple_values f;
       vm_real E[VMI_EXPANSION_E] = {VM_C(1e-4), 0, 0, 0}, ln_ratio;
       vmi_ripple_init(&r, 1, vmi_ateb_constants); // a linear spring
       vmi_ripple_at(&r, 2, 0, 0, 1, &f);          // phase 0: sa = 0, ca = 1
       ln_ratio = vmi_expansion_J(&r, 2, &f, E);   // ln(mean action/action)
   Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_EXPANSION_H
#define VARMASS_OSCILLATORS_EXPANSION_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "reduction.h"
#include "ripple.h"

/* The number of E_k that the law of order five needs at the start of a motion: E_0 ... E_3 */
enum { VMI_EXPANSION_E = 4 };

/* -- From the motion to the mean motion -- */

/* Returns ln(mean action/action) at the phase psi: the sum of all terms of the series with a weight of at most `order`.
   The weight of a term is the power of epsilon in it. f contains the functions C, S ... of oscillators/ripple.h at psi,
   and E the numbers E_k. */
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

/* Returns the mean phase minus the phase psi: the sum of all terms of the series with a weight of at most order - 1.
   The weight of a term is the power of epsilon in it. f contains the functions C, S ... of oscillators/ripple.h at psi,
   and E the numbers E_k. */
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

/* Returns the phase psi minus the mean phase: the sum of all terms of the series with a weight of at most order - 1.
   The weight of a term is the power of epsilon in it. f contains the functions C, S ... of oscillators/ripple.h at the
   mean phase, and E the numbers E_k. The result is -vmi_expansion_psi, evaluated at the mean phase, plus a product of
   two terms with E_0. */
VM_API vm_real vmi_expansion_psi_back(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real product = r->scale * r->scale / 4 * (1 - 2 * r->gamma) * E[0] * E[0] * f->C * f->S;
    const vm_real sum = -vmi_expansion_psi(r, order, f, E);
    return order >= 5 ? sum + product : sum;
}

/* Returns ln(action/mean action): the sum of all terms of the series with a weight of at most order - 1. The weight of
   a term is the power of epsilon in it, and `order` is from 3 to 5. f contains the functions C, S ... of
   oscillators/ripple.h at the mean phase, and E the numbers E_k. The result is -vmi_expansion_J, evaluated at the mean
   phase, plus a product of two terms with E_0. */
VM_API vm_real vmi_expansion_J_back(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, square = r->scale * r->scale / 2 * E[0] * E[0];
    const vm_real product = square * (2 / (r->alpha + 1) * (1 - 2 * g) * f->sa * f->ca * f->S - g * f->C * f->C);
    const vm_real sum = -vmi_expansion_J(r, order - 1, f, E);
    return order >= 5 ? sum + product : sum;
}

/* -- The mean rate of the phase -- */

/* The factor `first` in the mean rate of the phase, which is W (1 + first E_0 + second E_0^2). W is the rate of the
   phase that belongs to the mean action for E_0 = 0. The laws of all orders from 2 to 5 need `first`. */
VM_API vm_real vmi_expansion_first(const vmi_ripple *r) { return (r->alpha + 1) / 2 * r->mean2; }

/* The factor `second` in the mean rate of the phase, which is W (1 + first E_0 + second E_0^2). W is the rate of the
   phase that belongs to the mean action for E_0 = 0. The laws of the orders 4 and 5 need `second`. */
VM_API vm_real vmi_expansion_second(const vmi_ripple *r)
{
    return -r->scale * r->scale / 8 * r->variance * (2 - 3 * r->gamma) * (1 - 3 * r->gamma);
}

/* -- From state to mean state and back -- */

/* Returns the state whose action is e^ln_J times the action of *state, and whose phase is larger by shift, at the same
   mass and stiffness. */
VM_API vmi_osc_reduced vmi_expansion_shifted(const vmi_ripple *r, const vmi_osc_reduced *state, vm_real ln_J,
                                             vm_real shift)
{
    vmi_osc_reduced other;
    other.A = state->A * vmi_exp(2 / (r->alpha + 3) * ln_J, 0);
    other.psi = state->psi + shift;
    other.W = state->W * vmi_exp(r->gamma * ln_J, 0);
    return other;
}

/* The mean motion that belongs to a reduced state (amplitude and phase of oscillators/reduction.h), by the law of this
   order, 2 to 5. sa and ca are the Ateb functions of the state's phase, and E contains the state's numbers E_k. For
   orders above 2 the polynomials of *r must be set (vmi_ripple_complete). */
VM_API vmi_osc_reduced vmi_expansion_to_mean(const vmi_ripple *r, int order, const vmi_osc_reduced *state, vm_real sa,
                                             vm_real ca, const vm_real *E)
{
    vmi_ripple_values f;
    vmi_ripple_at(r, order, state->psi, sa, ca, &f);
    return vmi_expansion_shifted(r, state, vmi_expansion_J(r, order, &f, E), vmi_expansion_psi(r, order, &f, E));
}

/* The reduced state that belongs to a mean motion, by the law of this order, 3 to 5. (For order 2 the reduced state and
   the mean motion are equal.) sa and ca are the Ateb functions of the mean phase, and E contains the numbers E_k of the
   mean motion. */
VM_API vmi_osc_reduced vmi_expansion_from_mean(const vmi_ripple *r, int order, const vmi_osc_reduced *mean, vm_real sa,
                                               vm_real ca, const vm_real *E)
{
    vmi_ripple_values f;
    vmi_ripple_at(r, order, mean->psi, sa, ca, &f);
    return vmi_expansion_shifted(r, mean, vmi_expansion_J_back(r, order, &f, E),
                                 vmi_expansion_psi_back(r, order, &f, E));
}

/* -- What the law of order five leaves out -- */

/* The sizes of the terms of weight w. J[w], for w = 2 to 6, is the size of the terms in vmi_expansion_J, and psi[w],
   for w = 2 to 5, the size of the terms in vmi_expansion_psi. The terms of weight w are of order epsilon^w, where
   epsilon is the relative change of mass and stiffness within a radian of the phase. */
typedef struct VM_TAG(vmi_expansion_sizes) {
    vm_real J[7], psi[6];
} vmi_expansion_sizes;

/* Writes the sizes of all terms to *size, where e[k] is the absolute value of E_k = G_k/W^(k+2). */
VM_API void vmi_expansion_find_sizes(const vmi_ripple *r, const vm_real *e, vmi_expansion_sizes *size)
{
    const vm_real d = r->pi / (2 * VM_PI), L = r->scale, square = L * L / 8;
    vm_real power = L / 4;
    int w;
    for (w = 2; w <= 6; w++) {
        size->J[w] = e[w - 2] * power;
        power *= d;
        if (w < 6) size->psi[w] = VM_FABS(1 - (vm_real)w * r->gamma) * e[w - 2] * power;
    }
    size->J[4] += square / 2 * e[0] * e[0];
    size->J[5] += square * e[0] * e[1] * d;
    size->J[6] += square * (e[0] * e[2] + e[1] * e[1]) * d * d + square * L / 2 * e[0] * e[0] * e[0];
    size->psi[4] += VM_C(0.3) * square * e[0] * e[0] * d;
    size->psi[5] += square * e[0] * e[1] * d * d;
}

/* An upper bound of the terms of order epsilon^6 in the mean rate of the phase, divided by W. These terms are the
   largest ones that the law of order five leaves out of this rate. The argument product is |E_0 E_2|, and cube is
   |E_0|^3. If product and cube are instead the integrals of these numbers over the phase, the result is a bound of the
   error of the phase. */
VM_API vm_real vmi_expansion_third_rate(const vmi_ripple *r, vm_real product, vm_real cube)
{
    const vm_real d = r->pi / (2 * VM_PI), L = r->scale, g = r->gamma;
    return L * L / 64 * VM_FABS((1 - 5 * g) * (2 - 5 * g)) * d * d * product + VM_C(0.01) * L * L * L * cube;
}

/* Sizes of the terms that the law of some order leaves out: in ln J, where J is the action, and in the phase psi */
typedef struct VM_TAG(vmi_left_out) {
    vm_real J, psi;
} vmi_left_out;

/* The sizes of the terms that the law of this order leaves out when it computes the motion at t from the mean motion,
   where e[k] = |E_k|. The largest of these terms may be 0 at t. Therefore the sizes also contain the next terms, which
   are smaller by a factor epsilon. */
VM_API vmi_left_out vmi_expansion_left_out_at(const vmi_ripple *r, int order, const vm_real *e)
{
    vmi_expansion_sizes size;
    vmi_left_out now;
    vmi_expansion_find_sizes(r, e, &size);
    now.psi = size.psi[order];
    if (order < 5) now.psi += size.psi[order + 1];
    now.J = size.J[order] + size.J[order + 1];
    return now;
}

/* The sizes of the largest terms that the law of this order leaves out when it computes the mean motion from the state
   at the start, where e[k] = |E_k| */
VM_API vmi_left_out vmi_expansion_left_out_at_start(const vmi_ripple *r, int order, const vm_real *e)
{
    vmi_expansion_sizes size;
    vmi_left_out start;
    vmi_expansion_find_sizes(r, e, &size);
    start.psi = size.psi[order];
    start.J = size.J[order + 1];
    return start;
}

/* The estimate of the larger of |error of x|/A and |error of v|/vmax, from the terms that the law leaves out. `now`
   contains the sizes of these terms at t, `start` their sizes at the start and on the way. `third` is a bound of the
   error of the phase, the integral of vmi_expansion_third_rate. `turns` is the angle by which the phase advances from 0
   to t. An error of ln J at the start causes an error of the phase that grows in proportion to `turns`. The estimate
   includes a factor of 2, which was chosen to fit the errors that tests/test_slow_motion.c finds. */
VM_API vm_real vmi_expansion_error(const vmi_ripple *r, vmi_left_out now, vmi_left_out start, vm_real turns,
                                   vm_real third)
{
    const vm_real n = r->alpha + 1;
    const vm_real phase = now.psi + (start.psi + VM_FABS(r->gamma) * turns * start.J + 2 * third);
    return 4 / n * phase + 4 / (n + 2) * (now.J + start.J);
}

#endif
