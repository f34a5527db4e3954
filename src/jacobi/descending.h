/* jacobi/descending.h - sn, cn, dn and K by the arithmetic-geometric mean

   In this classical method the caller chooses the accuracy by the number of steps. The method serves for comparison and
   teaching: jacobi_sncndn is faster and more accurate.

       vm_real sn, cn, dn;
       jacobi_agm_sncndn(VM_C(1.2), VM_C(0.3), 3, &sn, &cn, &dn); // with three steps

   Source: DLMF 19.8; Bulirsch, Numer. Math. 7 (1965). Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_DESCENDING_H
#define VARMASS_JACOBI_DESCENDING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"

/* Goes back through the steps of the arithmetic-geometric mean by Gauss' transformation. At the last step n the sine
   and cosine of the phase a_n u are known. The results s, c, d, q give sn = s/q, cn = c/q and dn = d/q. With a = a_n,
   b = b_n and a+ = a_(n+1) the step back from n + 1 to n replaces
     s by (a/a+) s q,  c by c d,  d by c^2 + (b/a+) s^2,  q by c^2 + (a/a+) s^2.
   No subtraction occurs, not even for m < 0. */
VM_API void vmi_descend(const vmi_ladder *l, vm_real phase, vm_real *s, vm_real *c, vm_real *d, vm_real *q)
{
    int n;
    vmi_sin_cos(vmi_two(phase, 0), s, c);
    *d = *q = 1;
    for (n = l->n - 1; n >= 0; n--) {
        const vm_real ra = l->a[n] / l->a[n + 1], rb = l->b[n] / l->a[n + 1];
        const vm_real ss = *s * *s, cc = *c * *c;
        *s *= ra * *q;
        *c *= *d;
        *d = cc + rb * ss;
        *q = cc + ra * ss;
    }
}

/* sn, cn and dn of u by a given number of steps of the arithmetic-geometric mean, for m < 1. Fewer steps cost less and
   are less accurate; at least one step is made. With steps >= 15 the function makes as many steps as the type needs;
   the error is then at most 3 eps M (1 + M |u|) with M = max(1, k') for |u| <= 5K. The error grows with |u|, since the
   function rounds the phase a_n u, where a_n is the last arithmetic mean, and reduces a_n u by pi/2; jacobi_sncndn
   reduces u itself by K. The results are NaN for m >= 1 and for infinite arguments. */
VM_API void jacobi_agm_sncndn(vm_real u, vm_real m, int steps, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real kp = VM_SQRT(1 - m);
    vm_real s, c, d, q, phase;
    vmi_ladder l;
    int quarter;
    *sn = *cn = *dn = VM_NAN;
    if (!(m < 1) || !VM_IS_FINITE(m) || !VM_IS_FINITE(u)) return;
    vmi_agm(&l, kp, steps);
    phase = vmi_reduce(l.a[l.n] * VM_FABS(u), vmi_two(half_pi.hi, half_pi.mid), &quarter).hi;
    vmi_descend(&l, phase, &s, &c, &d, &q);
    if (quarter & 1) {
        *sn = c / d;
        *cn = -kp * s / d;
        *dn = kp * q / d;
    } else {
        *sn = s / q;
        *cn = c / q;
        *dn = d / q;
    }
    if (quarter & 2) {
        *sn = -*sn;
        *cn = -*cn;
    }
    *sn *= VM_COPYSIGN((vm_real)1, u);
}

/* K(m) by the arithmetic-geometric mean, for m <= 1.
   The error is at most 6 ulp. Returns infinity for m = 1, and NaN for m > 1 and infinite m. */
VM_API vm_real jacobi_agm_K(vm_real m)
{
    vmi_ladder l;
    if (!(m <= 1) || !VM_IS_FINITE(m)) return VM_NAN;
    if (m == 1) return VM_INFINITY;
    vmi_agm(&l, VM_SQRT(1 - m), VMI_LADDER);
    return VM_PI / 2 / l.a[l.n];
}

#endif
