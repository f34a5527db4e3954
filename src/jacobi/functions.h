/* jacobi/functions.h - sn, cn, dn and their quotients */
#ifndef VARMASS_JACOBI_FUNCTIONS_H
#define VARMASS_JACOBI_FUNCTIONS_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "reduction.h"
#include "theta.h"

/* The thetas of u, relatively accurate, for 1 - m = m1 + m1_lo, and what dn cannot pass; NaN where u or m is refused.
   Near 0 nothing is reduced, and neither K nor k' is asked for. */
VM_INLINE vmi_thetas vmi_thetas_of(vm_real u, vm_real m1, vm_real m1_lo, vm_real *bound)
{
    const vm_real reach = u * u * (VM_C(0.81) * (1 + m1) - VM_C(0.338) * VM_FABS(1 - m1)); /* (2u/K)^2, roughly */
    vm_real v, v_lo;
    vmi_bits quarters;
    vmi_thetas theta;
    *bound = m1; /* beyond k', and dn(K/2) is before */
    if (m1 >= 0 && reach <= 1) return vmi_theta_near(u, m1);
    *bound = VM_SQRT(m1);
    v = vmi_reduced(VM_FABS(u), m1, m1_lo, reach, &v_lo, &quarters);
    if (v * v * (m1 > 1 ? m1 : 1) > VMI_NEAR) theta = vmi_theta_far_unprepared(vmi_two(v, v_lo), m1, m1_lo);
    else theta = vmi_theta_near(v, m1);
    theta = vmi_theta_shift(theta, *bound, quarters);
    theta.s *= VM_COPYSIGN((vm_real)1, u);
    return theta;
}

VM_API void vmi_sncndn(vm_real u, vm_real m1, vm_real m1_lo, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_real bound;
    const vmi_thetas theta = vmi_thetas_of(u, m1, m1_lo, &bound);
    vmi_theta_ratios(theta, bound, sn, cn, dn);
    *cn = vmi_clamp(theta.c, -theta.n, theta.n) / theta.n; /* one rounding less, where K - u and k' have some more */
}

/* sn, cn, dn (u | m) for any real u and m <= 1. |sn|, |cn| <= 1, dn between 1 and sqrt(1 - m); sn is odd, cn and dn
   are even in u, to the bit. */
VM_API void jacobi_sncndn(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    vmi_sncndn(u, m1.hi, m1.lo, sn, cn, dn);
}

/* Documented with jacobi_sncndn. */
VM_API void jacobi_sncndn_m1(vm_real u, vm_real m1, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_sncndn(u, m1, 0, sn, cn, dn);
}

/* theta_p/theta_q; equal ones, which may both have underflown at m = 1, make 1 */
VM_API vm_real vmi_quotient(vm_real u, vm_real m, char p, char q)
{
    vm_real bound;
    const vm_two m1 = vmi_two_sum(1, -m);
    const vmi_thetas t = vmi_thetas_of(u, m1.hi, m1.lo, &bound);
    const vm_real above = p == 's' ? t.s : p == 'c' ? t.c : p == 'd' ? t.d : t.n;
    const vm_real below = q == 's' ? t.s : q == 'c' ? t.c : t.d; /* sn, cn, dn go another way */
    return above == below ? 1 : above / below;
}

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_cd(vm_real u, vm_real m) { return vmi_quotient(u, m, 'c', 'd'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_sd(vm_real u, vm_real m) { return vmi_quotient(u, m, 's', 'd'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_nd(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 'd'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_sc(vm_real u, vm_real m) { return vmi_quotient(u, m, 's', 'c'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_dc(vm_real u, vm_real m) { return vmi_quotient(u, m, 'd', 'c'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_nc(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 'c'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_cs(vm_real u, vm_real m) { return vmi_quotient(u, m, 'c', 's'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_ds(vm_real u, vm_real m) { return vmi_quotient(u, m, 'd', 's'); }

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_ns(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 's'); }

/* The twelve functions one by one: jacobi_pq = theta_p/theta_q, infinite at its poles, within 8 ulp as sn, cn, dn. */
VM_API vm_real jacobi_sn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return sn;
}

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_cn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return cn;
}

/* Documented with jacobi_sn. */
VM_API vm_real jacobi_dn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return dn;
}

#endif
