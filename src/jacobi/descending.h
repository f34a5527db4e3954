/* jacobi/descending.h - sn, cn, dn and K by the arithmetic-geometric mean, for comparison */
#ifndef VARMASS_JACOBI_DESCENDING_H
#define VARMASS_JACOBI_DESCENDING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"

/* Down the ladder by Gauss' transformation in homogeneous form, sn : cn : dn : 1 = s : c : d : q,
     s' = (a/a+) s q,  c' = c d,  d' = c^2 + (b/a+) s^2,  q' = c^2 + (a/a+) s^2     (a+ = a_(n+1))
   from sin and cos of the phase a_n u. No difference occurs, for m < 0 neither. */
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

/* The same functions by the arithmetic-geometric mean [1, 2], steps of the ladder counted: fewer cost less and give
   less (at least one); from VMI_LADDER - 1 on it climbs as far as the type needs. m < 1. The phase is reduced in two
   words of pi/2, not of K, so that the error grows with |u|: 3 eps M (1 + M |u|), M = max(1, k'), for |u| <= 5K. */
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
    *sn = quarter & 1 ? c / d : s / q;
    *cn = quarter & 1 ? -kp * s / d : c / q;
    *dn = quarter & 1 ? kp * q / d : d / q;
    if (quarter & 2) *cn = -*cn;
    if ((quarter & 2 ? -1 : 1) * VM_COPYSIGN((vm_real)1, u) < 0) *sn = -*sn;
}

/* Documented with jacobi_agm_sncndn. */
VM_API vm_real jacobi_agm_K(vm_real m)
{
    vmi_ladder l;
    if (!(m <= 1) || !VM_IS_FINITE(m)) return VM_NAN;
    if (m == 1) return VM_INFINITY;
    vmi_agm(&l, VM_SQRT(1 - m), VMI_LADDER);
    return VM_PI / 2 / l.a[l.n];
}

#endif
