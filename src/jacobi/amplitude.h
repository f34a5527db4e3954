/* jacobi/amplitude.h - the amplitude am, which is the angle whose sine is sn and whose cosine is cn

       vm_real angle = jacobi_am(VM_C(1.2), VM_C(0.3)); // sin(angle) = sn(1.2 | 0.3)

   Equations: DLMF 22.16. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_AMPLITUDE_H
#define VARMASS_JACOBI_AMPLITUDE_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "functions.h"
#include "integrals.h"
#include "theta.h"

/* Jacobi's amplitude am(u | m) in radians: sn = sin am and cn = cos am, for m <= 1. The amplitude is odd, continuous
   and rising (apart from errors of 4 ulp), and am(u + 2K) = am(u) + pi. The error is at most 8 ulp for |u| <= 100 K.
   Returns NaN for m > 1 and for infinite arguments, except that for m = 1 and an infinite u it returns the limit, pi/2
   or -pi/2. Method: am = j pi + atan(sn/cn), where 2 j K is the multiple of 2 K nearest to u. */
VM_API vm_real jacobi_am(vm_real u, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    const vmi_three half_pi = vmi_half_pi();
    vm_real K, turns, j, odd, am, bound;
    vm_two p;
    vmi_thetas theta = vmi_thetas_of(VM_FABS(u), m1.hi, m1.lo, &bound);
    if (theta.n != theta.n) return VM_NAN;
    if (m1.hi == 0) return VM_COPYSIGN(vmi_arctan(theta.s, theta.c), u);
    K = vmi_K(m1.hi, m1.lo);
    turns = VM_FABS(u) / (2 * K);
    j = VM_FLOOR(turns + VM_C(0.5));
    if (!(2 * j < 1 / VM_EPSILON)) return u / K * half_pi.hi;
    odd = j - 2 * VM_FLOOR(j / 2);
    if ((odd > 0) != (theta.c < 0)) { /* next to an odd multiple of K the sign of cn decides which j is right */
        if (turns > j) j += 1;
        else j -= 1;
    }
    am = vmi_arctan(VM_FABS(theta.s), VM_FABS(theta.c));
    if ((theta.s < 0) != (theta.c < 0)) am = -am;
    p = vmi_two_product(j, 2 * half_pi.hi);
    return VM_COPYSIGN(p.hi + (am + (p.lo + j * (2 * half_pi.mid))), u);
}

#endif
