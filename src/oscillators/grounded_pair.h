/* oscillators/grounded_pair.h - two strongly nonlinear oscillators with slow masses and a weak coupling

   Each of two bodies is on a spring of its own, which is fixed to the ground. A weak spring kappa and a weak damper c
   join the bodies. Averaged equations exist for this system of two degrees of freedom, because without the coupling
   each body vibrates as an oscillator of one degree of freedom. The index i is 0 or 1 for one body, and o = 1 - i is
   the index of the other body. The equations of motion are
       m_i x_i'' + k_i x_i|x_i|^(alpha_i-1) = -(r_i m_i' + b_i) x_i' + kappa (x_o - x_i) + c (x_o' - x_i')
   m_i is the mass of body i, k_i the stiffness of its spring, b_i its damping, and r_i the share of the reactive force.
   m_i and k_i may vary slowly. This file has the equations of motion, the averaged equations for amplitudes and phases,
   and functions that convert the motion to amplitudes and phases and back. For two bodies without springs to the
   ground, whose coupling may be strong, see oscillators/coupled_pair.h.

       vm_grounded_pair p;
       memset(&p, 0, sizeof p);
       p.oscillator[0].alpha = p.oscillator[1].alpha = 3;
       p.oscillator[0].mass = p.oscillator[1].mass = vm_law_linear(1, VM_C(0.001));
       p.oscillator[0].stiffness = p.oscillator[1].stiffness = vm_law_linear(1, 0);
       p.spring = VM_C(0.01);
       p.vibrations[0] = p.vibrations[1] = 1; // equal frequencies
       int status = vm_grounded_pair_init(&p);

   The state of the averaged equations is (A_0, phi_0, A_1, phi_1): the mean amplitudes and the phases in radians.
   oscillators/forced.h explains the symbols of the averaged equations. V = 2 Om A/(alpha+1) is the largest velocity of
   a vibration, <ca^2> the mean of ca^2 over a period, and q_i the rate q of vmi_forced_q with the damping b_i + c. The
   equations are
       A_i' = -q_i A_i/(alpha_i+3) - S_i/(m_i Om_i),
       phi_i' = w_i(A_i) + h_i kappa <ca^2> - h_i C_i/A_i,   h_i = (alpha_i+1) pi/(2 Pi_i m_i Om_i),
       S_i = sum of s_j/2 (kappa A_o c_n sin u - c V_o s_n cos u),
       C_i = sum of c_j/2 (kappa A_o c_n cos u + c V_o s_n sin u),   u = j phi_i - n phi_o.
   The sums are over those odd j and n up to 9 for which u varies slowly. These are the j and n with j P_i = n P_o,
   where the frequencies of the two bodies have the ratio P_0 : P_1. c_j and s_j are the Fourier coefficients of ca and
   sa of body i, and c_n and s_n those of body o. If the frequencies have no such ratio, the sums contain no terms, and
   each body vibrates on its own. Tests: tests/test_grounded_pair.c. */
#ifndef VARMASS_OSCILLATORS_GROUNDED_PAIR_H
#define VARMASS_OSCILLATORS_GROUNDED_PAIR_H

#include "../ateb/beta.h"
#include "../ateb/functions.h"
#include "../base/arrays.h"
#include "../base/complex.h"
#include "../base/real.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "forced.h"
#include "slow.h"

/* Two oscillators and the coupling between them. Set the fields above `mean`, then call vm_grounded_pair_init. After a
   change of alpha call vm_grounded_pair_init again. */
typedef struct VM_TAG(vm_grounded_pair) {
    vm_forced oscillator[2]; /* the oscillators: set their fields alpha, damping, reactive, mass and stiffness;
                                vm_grounded_pair_init writes the other fields */
    vm_real spring;          /* stiffness kappa of the coupling, N/m, of either sign; it must be small */
    vm_real damper;          /* damping c of the coupling, kg/s; it must be small */
    int vibrations[2];       /* P_0 and P_1, from 1 to 9: at the resonance body 0 makes P_0 vibrations while body 1
                                makes P_1 vibrations. Set both to 0 if there is no resonance */
    vm_real mean[2];         /* means of ca^2 over a period; vm_grounded_pair_init writes this field */
} vm_grounded_pair;

/* The parameters of both oscillators at one time, and the rates q that follow from them */
typedef struct VM_TAG(vmi_grounded_now) {
    vmi_forced_parameters n[2];
    vm_real q[2]; /* rates of the slow changes, 1/s; they include the damper of the coupling */
} vmi_grounded_now;

/* Returns 1 if both numbers of `vibrations` are 0, or if both are from 1 to 9, else 0. */
VM_API int vmi_grounded_ratio_is_valid(const int *vibrations)
{
    if (vibrations[0] == 0 && vibrations[1] == 0) return 1;
    return vibrations[0] > 0 && vibrations[1] > 0 && vibrations[0] < 2 * VMI_FORCED_HARMONICS &&
           vibrations[1] < 2 * VMI_FORCED_HARMONICS;
}

/* Writes the parameters at time t to *now, and checks them and the fields of the pair. */
VM_API int vmi_grounded_at(const vm_grounded_pair *p, vm_real t, vmi_grounded_now *now)
{
    int i, status = VM_OK;
    for (i = 0; i < 2; i++) {
        const vm_forced *f = &p->oscillator[i];
        status = vmi_first_error(status, vmi_forced_at(f, t, &now->n[i]));
    }
    if (!vmi_grounded_ratio_is_valid(p->vibrations)) status = vmi_first_error(status, VM_BAD_ARGUMENT);
    if (!VM_IS_FINITE(p->spring) || !VM_IS_FINITE(p->damper)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    for (i = 0; i < 2; i++)
        now->q[i] = vmi_forced_q(&p->oscillator[i], &now->n[i]) + 2 * p->damper / now->n[i].mass;
    return VM_OK;
}

/* Prepares a pair of coupled oscillators: checks it at t = 0 and writes the constants of the averaged equations.
   Call it before all other functions for this pair. Returns VM_BAD_ARGUMENT for a null pointer, a law that no
   constructor made, or `vibrations` that are neither both 0 nor both from 1 to 9; VM_NOT_FINITE for a number that is
   infinite or NaN; VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive; VM_DOMAIN for alpha
   < 0; VM_OK otherwise. An error leaves *p as it was. */
VM_API int vm_grounded_pair_init(vm_grounded_pair *p)
{
    vmi_grounded_now now;
    vm_grounded_pair r;
    int i, status;
    if (!p) return VM_BAD_ARGUMENT;
    r = *p;
    for (i = 0; i < 2; i++) {
        r.oscillator[i].frequency = vm_law_linear(1, 0); /* not used, but vm_forced_init checks them */
        r.oscillator[i].force = vm_law_linear(0, 0);
    }
    status = vmi_grounded_at(&r, 0, &now);
    for (i = 0; i < 2 && !status; i++) {
        status = vm_forced_init(&r.oscillator[i]);
        r.mean[i] = ateb_mean(r.oscillator[i].alpha, 0, 2);
    }
    if (!status) *p = r;
    return status;
}

/* Equations of motion of two weakly coupled oscillators, for rk45 or rk87. y = (x_0, x_1, x_0', x_1') is in m and m/s;
   pair points to a prepared vm_grounded_pair. The statuses are those of vm_grounded_pair_init at the time t, and
   VM_DOMAIN for a t at which a law has no value; they stop the run. y is not checked. */
VM_API int vm_grounded_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_grounded_pair *p = (const vm_grounded_pair *)pair;
    vmi_grounded_now now;
    vm_real pull; /* the force of the coupling on body 0 */
    int i;
    const int status = vmi_grounded_at(p, t, &now);
    if (status) return status;
    pull = p->spring * (y[1] - y[0]) + p->damper * (y[3] - y[2]);
    for (i = 0; i < 2; i++) {
        const vm_forced *f = &p->oscillator[i];
        const vmi_forced_parameters *n = &now.n[i];
        vm_real force = pull;
        if (i == 1) force = -pull;
        dydt[i] = y[2 + i];
        dydt[2 + i] = (force - (f->reactive * n->mass_rate + f->damping) * y[2 + i] -
                       n->k * vmi_osc_elastic(y[i], f->alpha)) /
                      n->mass;
    }
    return VM_OK;
}

/* The numbers of one body at one time that the averaged equations contain */
typedef struct VM_TAG(vmi_grounded_body) {
    vm_real Om, w; /* rate of the Ateb phase, 1/s; frequency of the free vibration, rad/s */
    vm_real rate;  /* the frequency with which the ripple is computed: w, or the one of vmi_grounded_tune */
    vm_real pull;  /* kappa A, N: amplitude of the force that this body's motion exerts by the spring */
    vm_real drag;  /* c V, N: amplitude of the force that this motion exerts by the damper */
    vm_complex turns[2 * VMI_FORCED_HARMONICS]; /* turns[k] is e^(i k phi) with the imaginary unit i */
} vmi_grounded_body;

/* Sets b[0] and b[1] from the amplitudes A (m) and the phases phi of the two bodies at the instant *now */
VM_API void vmi_grounded_bodies(const vm_grounded_pair *p, const vmi_grounded_now *now, const vm_real *A,
                                const vm_real *phi, vmi_grounded_body *b)
{
    int i;
    for (i = 0; i < 2; i++) {
        const vm_forced *f = &p->oscillator[i];
        b[i].Om = vmi_slow_rate(A[i], now->n[i].k, now->n[i].mass, f->alpha);
        b[i].w = VM_PI / f->pi * b[i].Om;
        b[i].pull = p->spring * A[i];
        b[i].drag = p->damper * 2 * b[i].Om * A[i] / (f->alpha + 1);
        b[i].rate = b[i].w;
        vmi_c_turns(2 * VMI_FORCED_HARMONICS - 1, phi[i], b[i].turns);
    }
}

/* Sets the fields `rate`, with which the ripple is computed, to the frequencies P_0 W and P_1 W at the resonance, where
   W is the mean of w_0/P_0 and w_1/P_1. The absolute value of each divisor of the ripple is then at least W. Does
   nothing if no resonance is given. */
VM_API void vmi_grounded_tune(const vm_grounded_pair *p, vmi_grounded_body *b)
{
    const vm_real first = (vm_real)p->vibrations[0], second = (vm_real)p->vibrations[1];
    vm_real common;
    if (p->vibrations[0] == 0) return;
    common = (b[0].w / first + b[1].w / second) / 2;
    b[0].rate = first * common;
    b[1].rate = second * common;
}

/* Writes the sums S_i and C_i of the averaged equations at the top of this file for the body i. */
VM_API void vmi_grounded_sums(const vm_grounded_pair *p, const vmi_grounded_body *b, int i, vm_real *S, vm_real *C)
{
    const vm_forced *f = &p->oscillator[i], *other = &p->oscillator[1 - i];
    const vmi_grounded_body *o = &b[1 - i];
    int j, n;
    *S = *C = 0;
    if (p->vibrations[0] == 0) return;
    for (j = 0; j < VMI_FORCED_HARMONICS; j++)
        for (n = 0; n < VMI_FORCED_HARMONICS; n++) {
            const vm_real spring = o->pull * other->c[n], damper = o->drag * other->s[n];
            vm_complex u;
            if ((2 * j + 1) * p->vibrations[i] != (2 * n + 1) * p->vibrations[1 - i]) continue;
            u = vmi_c_times(b[i].turns[2 * j + 1], vmi_c_conjugate(o->turns[2 * n + 1]));
            *S += f->s[j] / 2 * (spring * u.im - damper * u.re);
            *C += f->c[j] / 2 * (spring * u.re + damper * u.im);
        }
}

/* Averaged equations of two weakly coupled oscillators, for rk45 or rk87. The equations are at the top of this file.
   The state is y = (A_0, phi_0, A_1, phi_1): mean amplitudes (m) and phases (rad). Start with
   vm_grounded_pair_to_averaged, and end with vm_grounded_pair_from_averaged. Let e be the largest of the couplings,
   dampings and mass rates. Up to times of the order of 1/e the error of the amplitudes is of the order of e. For alpha
   = 1 the error of the positions is of this order, too. For other alpha the rates of the phases depend on the
   amplitudes, so that errors of the amplitudes cause larger errors of the positions. In the tests the errors of the
   positions are at most 0.04 of the amplitude for e = 0.005. For smaller e these errors are smaller, but not in
   proportion to e. The equations are singular where an amplitude is 0: in this case integrate vm_grounded_pair_rhs. The
   argument pair and the statuses are those of vm_grounded_pair_rhs. */
VM_API int vm_grounded_pair_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_grounded_pair *p = (const vm_grounded_pair *)pair;
    const vm_real A[2] = {y[0], y[2]}, phi[2] = {y[1], y[3]};
    vmi_grounded_body b[2];
    vmi_grounded_now now;
    int i;
    const int status = vmi_grounded_at(p, t, &now);
    if (status) return status;
    vmi_grounded_bodies(p, &now, A, phi, b);
    for (i = 0; i < 2; i++) {
        const vm_forced *f = &p->oscillator[i];
        const vm_real turn = (f->alpha + 1) * VM_PI / (2 * f->pi * now.n[i].mass * b[i].Om); /* h_i of the top of this
                                                                                                file */
        vm_real S, C;
        vmi_grounded_sums(p, b, i, &S, &C);
        dydt[2 * i] = -now.q[i] * A[i] / (f->alpha + 3) - S / (now.n[i].mass * b[i].Om);
        dydt[2 * i + 1] = b[i].w + turn * (p->spring * p->mean[i] - C / A[i]);
    }
    return VM_OK;
}

/* The ripple of the amplitude of body i, which is the exact amplitude minus the mean amplitude. The ripple has three
   parts:
     q A/((alpha+3) Om) sa ca                               by the slow changes and the dampings,
     -(alpha+1) kappa A/(4 m Om^2) (ca^2 - <ca^2>)          by this body's own motion in the coupling,
     1/(m Om) times the sum over j and n of s_j/2 [(kappa A_o c_n cos v - c V_o s_n sin v)/(j w_i + n w_o)
       + (kappa A_o c_n cos u + c V_o s_n sin u)/(j w_i - n w_o)]    by the other body,
   where v = j phi_i + n phi_o and u = j phi_i - n phi_o. The quotient with j w_i - n w_o is left out for those j and n
   for which j P_i = n P_o, since u then varies slowly. The frequencies w_i and w_o are the fields `rate`. */
VM_API vm_real vmi_grounded_ripple(const vm_grounded_pair *p, const vmi_grounded_now *now, const vmi_grounded_body *b,
                                   const vm_real *A, const vm_real *phi, int i)
{
    const vm_forced *f = &p->oscillator[i], *other = &p->oscillator[1 - i];
    const vmi_grounded_body *o = &b[1 - i];
    const vm_real mass = now->n[i].mass, Om = b[i].Om;
    vm_real sa, ca, own, sum = 0;
    int j, n;
    ateb_saca(phi[i] * (f->pi / VM_PI), f->alpha, &sa, &ca);
    own = now->q[i] / (f->alpha + 3) * sa * ca - (f->alpha + 1) * p->spring / (4 * mass * Om) * (ca * ca - p->mean[i]);
    for (j = 0; j < VMI_FORCED_HARMONICS; j++)
        for (n = 0; n < VMI_FORCED_HARMONICS; n++) {
            const int J = 2 * j + 1, N = 2 * n + 1;
            const vm_complex v = vmi_c_times(b[i].turns[J], o->turns[N]);
            const vm_complex u = vmi_c_times(b[i].turns[J], vmi_c_conjugate(o->turns[N]));
            const vm_real spring = o->pull * other->c[n], damper = o->drag * other->s[n];
            const vm_real own_rate = (vm_real)J * b[i].rate, other_rate = (vm_real)N * o->rate;
            sum += f->s[j] / 2 * (spring * v.re - damper * v.im) / (own_rate + other_rate);
            if (p->vibrations[0] > 0 && J * p->vibrations[i] == N * p->vibrations[1 - i]) continue;
            sum += f->s[j] / 2 * (spring * u.re + damper * u.im) / (own_rate - other_rate);
        }
    return A[i] / Om * own + sum / (mass * Om);
}

/* Converts a motion (x_0, x_1, x_0', x_1') of two weakly coupled oscillators to its mean y = (A_0, phi_0, A_1, phi_1).
   A_0 and A_1 are the amplitudes minus their ripple within a period. The statuses are those of vm_grounded_pair_rhs;
   VM_NOT_FINITE also means that the motion is infinite or NaN. VM_DOMAIN also means that a body is at rest in its
   equilibrium (x_i = x_i' = 0), that an amplitude minus its ripple is not positive, that a ripple is about as large as
   its amplitude, or that the frequencies are in a resonance that the field `vibrations` does not give. y and motion may
   be the same array. */
VM_API int vm_grounded_pair_to_averaged(const vm_grounded_pair *p, vm_real t, const vm_real *motion, vm_real *y)
{
    if (!p || !motion || !y) return VM_BAD_ARGUMENT;
    vmi_grounded_now now;
    vmi_grounded_body b[2];
    vm_real exact[2], A[2], phi[2], ripple[2];
    int i, step, status = vmi_grounded_at(p, t, &now);
    if (status != VM_BAD_ARGUMENT && !vmi_all_finite(4, motion)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    for (i = 0; i < 2; i++) {
        const vm_forced *f = &p->oscillator[i];
        vmi_slow_phase(motion[i], motion[2 + i], now.n[i].k, now.n[i].mass, f->alpha, &exact[i], &phi[i]);
        phi[i] *= VM_PI / f->pi;
        A[i] = exact[i];
    }
    for (step = 0; step < 6; step++) {
        vmi_grounded_bodies(p, &now, A, phi, b);
        if (step < 3) vmi_grounded_tune(p, b); /* A divisor of the ripple may be nearly 0 at the exact amplitudes. */
        for (i = 0; i < 2; i++) ripple[i] = vmi_grounded_ripple(p, &now, b, A, phi, i);
        for (i = 0; i < 2; i++) A[i] = exact[i] - ripple[i];
        if (!(A[0] > 0) || !(A[1] > 0) || !vmi_all_finite(2, A)) return VM_DOMAIN;
    }
    vmi_grounded_bodies(p, &now, A, phi, b);
    for (i = 0; i < 2; i++)
        if (!vmi_slow_is_solved(A[i] + vmi_grounded_ripple(p, &now, b, A, phi, i), exact[i])) return VM_DOMAIN;
    for (i = 0; i < 2; i++) {
        y[2 * i] = A[i];
        y[2 * i + 1] = phi[i];
    }
    return VM_OK;
}

/* Converts the mean y = (A_0, phi_0, A_1, phi_1) of two weakly coupled oscillators to the motion (x_0, x_1, x_0',
   x_1'). This is the inverse of vm_grounded_pair_to_averaged: it adds the ripples to the mean amplitudes. The statuses
   are those of vm_grounded_pair_rhs; VM_NOT_FINITE also means that y is infinite or NaN, and VM_DOMAIN also means that
   an amplitude is not positive or that an amplitude plus its ripple is negative. Both also occur where the frequencies
   are in a resonance that the field `vibrations` does not give. motion and y may be the same array. */
VM_API int vm_grounded_pair_from_averaged(const vm_grounded_pair *p, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!p || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_grounded_now now;
    vmi_grounded_body b[2];
    vm_real A[2], phi[2], found[4];
    int i, status = vmi_grounded_at(p, t, &now);
    if (status != VM_BAD_ARGUMENT && !vmi_all_finite(4, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    for (i = 0; i < 2; i++) {
        A[i] = y[2 * i];
        phi[i] = y[2 * i + 1];
        if (!(A[i] > 0)) return VM_DOMAIN;
    }
    vmi_grounded_bodies(p, &now, A, phi, b);
    for (i = 0; i < 2; i++) {
        const vm_forced *f = &p->oscillator[i];
        const vm_real exact = A[i] + vmi_grounded_ripple(p, &now, b, A, phi, i);
        if (!(exact >= 0)) return VM_DOMAIN;
        vmi_slow_motion(exact, phi[i] * (f->pi / VM_PI), now.n[i].k, now.n[i].mass, f->alpha, &found[i],
                        &found[2 + i]);
    }
    return vmi_copy_if_finite(4, found, motion);
}

#endif
