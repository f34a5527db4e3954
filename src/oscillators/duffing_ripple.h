/* oscillators/duffing_ripple.h - how slow changes disturb Duffing's oscillator within a period, in closed form

   oscillators/orbit_ripple.h defines a(phi), a function of the phase phi on an orbit. The whole ripple, the small swing
   of the motion about its mean within a period, follows from a(phi). For Duffing's force c1 x + c3 x^3 this function is
   a Fourier series whose terms have a closed form, so that no numerical integration is needed. Let zeta be 2 phi for an
   orbit around 0 and phi for an orbit in a well, and let Omega be the rate of zeta. Let q be the nome of the parameter
   m of Jacobi's functions. For 0 < m < 1 the nome is exp(-pi K(1-m)/K(m)), where K is the complete elliptic integral.
   Then
       a = sum over n >= 1 of a_n sin(n zeta),   a_n = -(2 Omega/(3 c3)) (2 c1 + n^2 Omega^2) q^n/(1 - q^(2n)).
   Method: a is the periodic part of an integral of v^2 over time, and v^2 is a polynomial in sn^2(u) with the argument
   u of Jacobi's functions. So the integrals of sn^2 and sn^4 are needed. The integral of sn^2 is a multiple of u minus
   Z(u)/m, where Jacobi's zeta function Z is periodic. Because (sn cn dn)' = 1 - 2 (1 + m) sn^2 + 3 m sn^4, the integral
   of sn^4 consists of u, the integral of sn^2 and sn cn dn = -Z''/(2m). So a is a combination of Z and Z''. The Fourier
   series of Z is known (DLMF 22.11, 22.16(iii)), and gives the series of Z'' and of a.
       vmi_orbit_ripple ripple;
       vmi_duffing_ripple(&orbit, &ripple); // orbit is a complete orbit of vm_duffing_force
   Tests: tests/test_odd_force.c. */
#ifndef VARMASS_OSCILLATORS_DUFFING_RIPPLE_H
#define VARMASS_OSCILLATORS_DUFFING_RIPPLE_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../jacobi/integrals.h"
#include "odd_force.h"
#include "orbit_ripple.h"

/* Returns the nome q of the parameter m = 1 - m1 (see the top of this file), and writes q/m to *by_m. The quotient q/m
   has a limit for m -> 0. The argument K is the complete elliptic integral K(m). q and q/m have an error of some 1e-13
   (float: some rounding errors), which is small enough for the ripple. Close to m = 0 the code uses a power series in e
   = (1 - k'^(1/2))/(2 (1 + k'^(1/2))), where k' = sqrt(m1). For m < 0 the nome of m is minus the nome of m/(m - 1). */
VM_API vm_real vmi_duffing_nome(vm_real m, vm_real m1, vm_real K, vm_real *by_m)
{
    const vm_real series_holds = VM_C(0.1), kp = VM_SQRT(m1), root = VM_SQRT(kp);
    const vm_real e_by_m = 1 / (2 * (1 + kp) * ((1 + root) * (1 + root))), e = m * e_by_m, e4 = (e * e) * (e * e);
    vm_real q;
    if (VM_FABS(e) <= series_holds) {
        *by_m = e_by_m * (1 + e4 * (2 + e4 * (15 + e4 * 150)));
        return m * *by_m;
    }
    if (m > 0) q = vmi_exp(-VM_PI * jacobi_K_m1(m) / K, 0);
    else q = -vmi_exp(-VM_PI * jacobi_K_m1(-m / m1) / (kp * K), 0);
    *by_m = q / m;
    return q;
}

/* The number 2 c1/Omega^2 + 1 for an orbit in a well with the nome q; the top of this file explains c1 and Omega. For
   small orbits 2 c1/Omega^2 and 1 nearly cancel, and digits would be lost. Therefore the function computes the number
   as -24 times the sum of d q^(2d)/(1 - q^(2d)) over odd d. */
VM_API vm_real vmi_duffing_well_term(vm_real q)
{
    const vm_real q2 = q * q;
    vm_real power = q2, sum = 0;
    int d;
    for (d = 1; (vm_real)d * power > VM_EPSILON * sum; d += 2) {
        sum += (vm_real)d * power / (1 - power);
        power *= q2 * q2;
    }
    return -24 * sum;
}

/* The numbers from which the terms a_n of the Fourier series at the top of this file are computed. A derivative "by
   size" is the derivative with respect to the field `size` of the orbit. */
typedef struct VM_TAG(vmi_duffing_terms) {
    vm_real Omega, Omega_size; /* the rate Omega of the angle zeta, and its derivative by size */
    vm_real q, q_by_k3;        /* the nome q, and q/c3 */
    vm_real ln_q_size;         /* derivative of ln |q| by size */
} vmi_duffing_terms;

/* Computes the numbers of vmi_duffing_terms for an orbit around 0, where m = c3 A^2/(2 lambda^2) with the amplitude
   A. */
VM_API vmi_duffing_terms vmi_duffing_outer_terms(const vmi_orbit *orbit)
{
    const vm_real k1 = orbit->force->k1, k3 = orbit->force->k3, A = orbit->size, m1 = orbit->m1;
    const vm_real lambda2 = orbit->lambda * orbit->lambda, m_by_k3 = A * A / (2 * lambda2), m = k3 * m_by_k3;
    vmi_duffing_terms r;
    vm_real by_m;
    r.Omega = 2 * orbit->w;
    r.Omega_size = r.Omega * (m / A) * (2 - orbit->C2 * (k1 / lambda2) / m1);
    r.q = vmi_duffing_nome(m, m1, VM_PI / 2 * orbit->lambda / orbit->w, &by_m);
    r.q_by_k3 = by_m * m_by_k3;
    r.ln_q_size = 2 / A * (orbit->w * orbit->w / lambda2) * (k1 / lambda2) / m1;
    return r;
}

/* Computes the numbers of vmi_duffing_terms for an orbit in a well, where m = 2 s/(rest^2 + s), s is the orbit's size
   and rest^2 = -c1/c3. */
VM_API vmi_duffing_terms vmi_duffing_inner_terms(const vmi_orbit *orbit)
{
    const vm_real k3 = orbit->force->k3, rest2 = -orbit->force->k1 / k3, size = orbit->size, m1 = orbit->m1;
    const vm_real top2 = rest2 + size, lambda2 = orbit->lambda * orbit->lambda;
    vmi_duffing_terms r;
    vm_real by_m;
    r.Omega = orbit->w;
    r.Omega_size = r.Omega / top2 * (VM_C(0.5) - orbit->C2 * rest2 / (m1 * top2));
    r.q = vmi_duffing_nome(2 * size / top2, m1, VM_PI * orbit->lambda / orbit->w, &by_m);
    r.q_by_k3 = r.q / k3;
    r.ln_q_size = orbit->w * orbit->w / (4 * lambda2 * m1) * (rest2 / (size * top2));
    return r;
}

/* Writes the mean of x^2 over a period to *X, and its derivative with respect to the orbit's size to *X_size. Both are
   computed from C2 and C4, the means of cn^2 and cn^4. The derivative of C2 with respect to the parameter m of cn is
   1/2 - 2 C2 + 3 C4/2 - C2^2/(2 m1). */
VM_API void vmi_duffing_mean_square(const vmi_orbit *orbit, vm_real *X, vm_real *X_size)
{
    const vm_real k1 = orbit->force->k1, k3 = orbit->force->k3, size = orbit->size, m1 = orbit->m1, C2 = orbit->C2;
    if (orbit->place == VMI_ORBIT_AROUND_0) {
        const vm_real lambda2 = orbit->lambda * orbit->lambda, m = k3 * size * size / (2 * lambda2);
        const vm_real C2_m = VM_C(0.5) - 2 * C2 + VM_C(1.5) * orbit->C4 - C2 * C2 / (2 * m1);
        *X = size * size * C2;
        *X_size = 2 * size * (C2 + C2_m * m * (k1 / lambda2));
    } else {
        const vm_real rest2 = -k1 / k3, top2 = rest2 + size, m = 2 * size / top2, dn2 = m1 + m * C2; /* mean of dn^2 */
        *X = top2 * dn2;
        *X_size = dn2 - (m * C2 * C2 + m1) / m1 * (rest2 / top2);
    }
}

/* Computes the numbers of vmi_duffing_terms for any orbit of Duffing's force. */
VM_API vmi_duffing_terms vmi_duffing_terms_of(const vmi_orbit *orbit)
{
    if (orbit->place == VMI_ORBIT_AROUND_0) return vmi_duffing_outer_terms(orbit);
    return vmi_duffing_inner_terms(orbit);
}

/* Writes the ripple of an orbit of Duffing's force whose fields are all set. The Fourier series ends where its
   terms are below about 1e-11 (float 1e-6) of the largest term. 96 terms are enough even for an orbit that is only a
   rounding error away from a separatrix. */
VM_API void vmi_duffing_ripple(const vmi_orbit *orbit, vmi_orbit_ripple *r)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-11) : VM_C(1e-6);
    const vmi_duffing_terms t = vmi_duffing_terms_of(orbit);
    const vm_real square = t.Omega * t.Omega;
    vm_real power = t.q_by_k3, q_n = t.q, largest = 0;
    int n;
    r->w_size = orbit->w * (t.Omega_size / t.Omega);
    r->j_size = orbit->energy_slope / orbit->w;
    for (n = 1; n <= VMI_RIPPLE_HARMONICS; n++) {
        const vm_real N = (vm_real)n, Q = power / (1 - q_n * q_n);
        const vm_real ln_Q_size = N * t.ln_q_size * (1 + q_n * q_n) / (1 - q_n * q_n);
        const vm_real factor = -2 * t.Omega / 3 * Q, factor_size = factor * (t.Omega_size / t.Omega + ln_Q_size);
        vm_real term = 2 * orbit->force->k1 + N * N * square;
        if (orbit->place != VMI_ORBIT_AROUND_0 && n == 1) term = square * vmi_duffing_well_term(t.q);
        r->a[n] = factor * term;
        r->a_size[n] = factor_size * term + factor * (2 * N * N * t.Omega * t.Omega_size);
        r->harmonics = n;
        largest = vmi_larger(VM_FABS(r->a[n]), largest);
        if (n > 2 && VM_FABS(r->a[n]) + VM_FABS(r->a_size[n] * orbit->size) <= enough * largest) break;
        power *= t.q;
        q_n *= t.q;
    }
    vmi_duffing_mean_square(orbit, &r->X, &r->X_size);
    vmi_orbit_ripple_of_harmonics(orbit, r);
}

#endif
