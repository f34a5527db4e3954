/* jacobi/reciprocal.h - sn, cn and dn for any parameter, also for m > 1

   For m > 1 the roles of cn and dn change: dn oscillates between 1 and -1, and cn stays positive. A pendulum whose
   small oscillations have the frequency w0, and which passes its lowest point with the angular velocity W at t = 0,
   has the modulus k = W/(2 w0). It swings for m = k^2 < 1 and rotates for m > 1. In both cases its angle is given by
   sin(angle/2) = k sn(w0 t | m), cos(angle/2) = dn(w0 t | m), and its angular velocity is W cn(w0 t | m).

       vm_real sn, cn, dn;
       jacobi_sncndn_any(VM_C(1.2), VM_C(2.5), &sn, &cn, &dn);

   Equations: DLMF 22.17.2-4. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_RECIPROCAL_H
#define VARMASS_JACOBI_RECIPROCAL_H

#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "functions.h"

/* sn, cn and dn of the argument u for any finite parameter m. For m <= 1 the results are those of jacobi_sncndn. For
   m > 1 they are
     sn(u | m) = sn(k u | 1/m)/k,  cn(u | m) = dn(k u | 1/m),  dn(u | m) = cn(k u | 1/m),  k = sqrt(m).
   For m > 1 the error is at most 4 eps (4 eps/k for sn) for |k u| <= 1e9 (float 1e4). For |u| <= 100 K(1/m)/k it is at
   most 8 ulp plus the change that the error of k u, a number in two words, makes; this change matters only next to a
   zero of sn or dn. Returns NaN for infinite m. For m > 1 the product k u is computed in two words. Its second word,
   the variable h, changes sn, cn and dn a little; two terms of their Taylor series in h add this change. */
VM_API void jacobi_sncndn_any(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_two k, phase, m1;
    vm_real s, c, d, h, scale = 1;
    if (!(m > 1) || !VM_IS_FINITE(m) || !VM_IS_FINITE(u)) {
        jacobi_sncndn(u, m, sn, cn, dn);
        return;
    }
    k = vmi_root(m, 0);
    if (VM_FABS(u) > 20 / VM_EPSILON / k.hi) { /* k u is above K/eps for every m > 1 */
        *sn = 0 * u;
        *cn = *dn = 1;
        return;
    }
    if (m > VM_MAX * VM_EPSILON) scale = VM_EPSILON; /* keeps the quotient m1 from overflowing */
    m1 = vmi_two_over(vmi_two_sum(m * scale, -scale), vmi_two(m * scale, 0));
    phase = vmi_two_scaled(k, u);
    vmi_sncndn(phase.hi, m1.hi, m1.lo, &s, &c, &d);
    h = phase.lo;
    if (!(VM_FABS(phase.hi) < 1 / VM_EPSILON)) h = 0; /* the series needs a small h */
    *sn = vmi_clamp(s + h * (c * d - h / 2 * s * (d * d + c * c / m)), -1, 1) / k.hi;
    *cn = vmi_clamp(d - h / m * (s * c + h / 2 * d * (c * c - s * s)), 0, 1);
    *dn = vmi_clamp(c - h * (s * d + h / 2 * c * (d * d - s * s / m)), -1, 1);
}

#endif
