/* jacobi/means.h - mean values of cn^2, cn^4 and cn^6 over a period

   Averaged equations of oscillators with a cubic spring need these means: equations (383), (384), (408). C2, C4 and
   C6 are the means of cn^2, cn^4 and cn^6.

       vm_real C2, C4, C6;
       jacobi_cn_means(VM_C(0.5), &C2, &C4, &C6);

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_MEANS_H
#define VARMASS_JACOBI_MEANS_H

#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"
#include "integrals.h"
#include "modulus.h"

/* Computes the means C2, C4, C6 of cn^2, cn^4, cn^6 from the nome q of m, for |q| <= 0.1. At m = 0 the recurrences
   (384) and (408) would divide 0 by 0. Here all numerators and denominators were divided by m beforehand. For this
   purpose 1/2 - C2 and m are written as q S and 16 q R, where S and R are power series in q. */
VM_API void vmi_means_from_nome(vm_real q, vm_real *C2, vm_real *C4, vm_real *C6)
{
    const vm_real y = q * q, loss = vmi_theta_loss(q), R = 1 - q * loss;
    const vm_real low = -2 + y * (6 + y * (-16 + 37 * y));
    const vm_real high = -78 + y * (158 + y * (-312 + y * (594 - 1090 * y)));
    const vm_real series = low + (y * y) * (y * y) * high;             /* (S - 1)/q^2 */
    const vm_real S = 1 + y * series, d = q * S, delta = S / (16 * R); /* delta = d/m */
    const vm_real eta = (loss + q * series) / (256 * R * R);           /* eta = (delta - 1/16)/m */
    *C2 = VM_C(0.5) - d;
    *C4 = (1 - 4 * d + 2 * delta) / 3;
    *C6 = ((7 * delta - 8 * eta) / 3 + 8 * *C4 - VM_C(1.5) + 3 * d) / 5;
}

/* Returns the mean C2 of cn^2 by (383), C2 = (E/K - c)/m, where c = 1 - m <= 1/2 and l = ln(4/k'). E/K is computed in
   two words: near m = 4/5 the mean of sn^6, which is made from C2, has twice the error of C2. */
VM_API vm_real vmi_mean_from_K(vm_real c, vm_two l)
{
    const vm_two K = vmi_K_by_log(c, l);
    const vm_real rest = vmi_E_rest(c, l.hi), ratio = (1 + rest) / K.hi;
    const vm_two product = vmi_two_product(ratio, K.hi);
    const vm_real ratio_lo = ((1 - product.hi) + (rest - (product.lo + ratio * K.lo))) / K.hi;
    return ((ratio - c) + ratio_lo) / (1 - c);
}

/* Means of cn^2, cn^4 and cn^6 over a period, for the parameter m <= 1. The errors are at most 8 ulp. The means are 0
   for m = 1, where the period is infinite, and NaN for m > 1 and infinite m. Equations (383), (384), (408).
   Method: for -4 <= m <= 1/2 the means come from the nome of m. For any other m the recurrences (384) and (408) are
   solved for the means of sn^2 cn^2 and sn^2 cn^4. These two are small, and C4 and C6 follow by subtracting them from
   C2, so that rounding errors stay small. */
VM_API void jacobi_cn_means(vm_real m, vm_real *C2, vm_real *C4, vm_real *C6)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    *C2 = *C4 = *C6 = VM_NAN;
    if (vmi_refused(m1.hi)) return;
    *C2 = *C4 = *C6 = 0;
    if (m1.hi == 0) return;
    if (m1.hi >= VM_C(0.5) && m1.hi <= 5) {
        const vm_real root = VM_SQRT(m1.hi), fourth = VM_SQRT(root);
        const vm_real e = m / (2 * (1 + root) * ((1 + fourth) * (1 + fourth))), e4 = vmi_fourth_power(e);
        vmi_means_from_nome(e * (1 + e4 * (2 + e4 * (15 + e4 * (150 + e4 * (1707 + e4 * 20910))))), C2, C4, C6);
    } else {
        /* For m < 0, cn(u | m) = cd(k' u | M) with M = m/(m - 1) and k' = sqrt(1 - m). The mean of a power of cd is the
           mean of the same power of sn. The mean of sn^2 is 1 minus the mean of cn^2. */
        const vm_real second = vmi_mean_from_K(vmi_smaller(m1.hi, 1 / m1.hi), vmi_log_4(m1.hi, m1.lo));
        vm_real ratio = m1.hi / m, s2c2, s2c4, fourth; /* ratio is (1 - M)/M; M is m or, if m < 0, m/(m - 1) */
        if (m < 0) ratio = -1 / m;
        s2c2 = (second - ratio * (1 - 2 * second)) / 3;
        fourth = second - s2c2;
        s2c4 = (fourth - ratio * (3 * second - 4 * fourth)) / 5;
        *C2 = second;
        *C4 = fourth;
        *C6 = fourth - s2c4;
        if (m < 0) {
            *C2 = 1 - second;
            *C4 = 1 - (second + s2c2);
            *C6 = 1 - (second + (2 * s2c2 - s2c4));
        }
    }
}

#endif
