/* jacobi/functions.h - the elliptic functions sn, cn, dn and their quotients

   This file has Jacobi's functions sn(u | m), cn(u | m) and dn(u | m) for every real argument u and every parameter
   m = k^2 <= 1, also for negative m. sn and cn have the period 4 K(m), dn has the period 2 K(m), where the quarter
   period K(m) is an integral (jacobi/integrals.h). The functions describe the motions of oscillators with cubic springs
   and of bodies that rotate without torque. For many u and one m use a plan (jacobi/plans.h).

       vm_real sn, cn, dn;
       jacobi_sncndn(VM_C(1.2), VM_C(0.3), &sn, &cn, &dn);

   Method: a multiple of K is subtracted from u, so that the rest v has |v| <= K/2. Four theta functions of v are
   computed, and sn, cn and dn are quotients of them (jacobi/theta.h). For v near 0 the theta functions come from a
   series of (cn/sn)^2 (vmi_theta_near), for v far from 0 from series of their own (vmi_theta_far). Equations: DLMF 22.
   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_FUNCTIONS_H
#define VARMASS_JACOBI_FUNCTIONS_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "reduction.h"
#include "theta.h"

/* Returns the theta functions of u for 1 - m = m1 + m1_lo, a number in two words. Each theta function has a small
   relative error, or is NaN outside the domain of jacobi_sncndn. *bound becomes a number for which dn(u | m) lies
   between 1 and *bound. For a small |u| the function computes neither K nor k'. */
VM_INLINE vmi_thetas vmi_thetas_of(vm_real u, vm_real m1, vm_real m1_lo, vm_real *bound)
{
    const vm_real reach = u * u * (VM_C(0.81) * (1 + m1) - VM_C(0.338) * VM_FABS(1 - m1)); /* about (2u/K)^2 */
    vm_real v, v_lo;
    vmi_bits quarters;
    vmi_thetas theta;
    *bound = m1; /* dn lies between 1 and k' = sqrt(m1), and therefore also between 1 and m1 */
    if (m1 >= 0 && reach <= 1) return vmi_theta_near(u, m1);
    *bound = VM_SQRT(m1);
    v = vmi_reduced(VM_FABS(u), m1, m1_lo, *bound, reach, &v_lo, &quarters);
    if (v * v * vmi_larger(m1, 1) > VMI_NEAR) theta = vmi_theta_far_unprepared(vmi_two(v, v_lo), m1, m1_lo);
    else theta = vmi_theta_near(v, m1);
    theta = vmi_theta_shift(theta, *bound, quarters);
    theta.s *= VM_COPYSIGN((vm_real)1, u);
    return theta;
}

/* Computes sn, cn and dn of u for 1 - m = m1 + m1_lo, a number in two words. */
VM_API void vmi_sncndn(vm_real u, vm_real m1, vm_real m1_lo, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_real bound;
    const vmi_thetas theta = vmi_thetas_of(u, m1, m1_lo, &bound);
    vmi_theta_ratios(theta, bound, sn, cn, dn);
    *cn = vmi_clamp(theta.c, -theta.n, theta.n) / theta.n; /* more accurate than the product theta.c (1/theta.n) */
}

/* sn, cn and dn of the argument u for the parameter m = k^2 <= 1. All are pure numbers. |sn| <= 1, |cn| <= 1, and dn
   lies between 1 and sqrt(1 - m). sn is odd in u, cn and dn are even, to the last bit. The error is at most 9 ulp for
   |u| <= 100 K, next to the zeros too. The absolute error is at most 4 eps times the function's largest value for
   |u| <= 1e9 and |u| <= 2^40 K (float 1e4 and 2^17 K). The results are NaN for m > 1 and for infinite arguments, with
   one exception: for m = 1, sn = tanh u and cn = dn = 1/cosh u, also for infinite u. docs/cost.md has the time of a
   call. DLMF 22. */
VM_API void jacobi_sncndn(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    vmi_sncndn(u, m1.hi, m1.lo, sn, cn, dn);
}

/* sn, cn and dn for the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_sncndn. Use jacobi_sncndn_m1 for m close to 1, where the difference 1 - m
   would lose digits. */
VM_API void jacobi_sncndn_m1(vm_real u, vm_real m1, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_sncndn(u, m1 + 0, 0, sn, cn, dn); /* m1 + 0 turns -0 into 0 */
}

/* Returns the theta function whose name is s, c, d or n. */
VM_API vm_real vmi_theta_named(vmi_thetas t, char name)
{
    if (name == 's') return t.s;
    if (name == 'c') return t.c;
    if (name == 'd') return t.d;
    return t.n;
}

/* Returns the elliptic function whose name consists of the letters p and q, such as cd. This function is the quotient
   theta_p/theta_q. For m = 1 both theta functions may underflow to 0; where they are equal, the result is 1. */
VM_API vm_real vmi_quotient(vm_real u, vm_real m, char p, char q)
{
    vm_real bound;
    const vm_two m1 = vmi_two_sum(1, -m);
    const vmi_thetas t = vmi_thetas_of(u, m1.hi, m1.lo, &bound);
    const vm_real above = vmi_theta_named(t, p), below = vmi_theta_named(t, q);
    if (above == below) return 1;
    return above / below;
}

/* cd(u | m) = cn/dn.
   The error is at most 8 ulp for |u| <= 100 K; the domain is that of jacobi_sncndn. */
VM_API vm_real jacobi_cd(vm_real u, vm_real m) { return vmi_quotient(u, m, 'c', 'd'); }

/* sd(u | m) = sn/dn.
   The error is at most 8 ulp for |u| <= 100 K; the domain is that of jacobi_sncndn. */
VM_API vm_real jacobi_sd(vm_real u, vm_real m) { return vmi_quotient(u, m, 's', 'd'); }

/* nd(u | m) = 1/dn.
   The error is at most 8 ulp for |u| <= 100 K; the domain is that of jacobi_sncndn. */
VM_API vm_real jacobi_nd(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 'd'); }

/* sc(u | m) = sn/cn.
   It is infinite at odd multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_sc(vm_real u, vm_real m) { return vmi_quotient(u, m, 's', 'c'); }

/* dc(u | m) = dn/cn.
   It is infinite at odd multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_dc(vm_real u, vm_real m) { return vmi_quotient(u, m, 'd', 'c'); }

/* nc(u | m) = 1/cn.
   It is infinite at odd multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_nc(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 'c'); }

/* cs(u | m) = cn/sn.
   It is infinite at even multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_cs(vm_real u, vm_real m) { return vmi_quotient(u, m, 'c', 's'); }

/* ds(u | m) = dn/sn.
   It is infinite at even multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_ds(vm_real u, vm_real m) { return vmi_quotient(u, m, 'd', 's'); }

/* ns(u | m) = 1/sn.
   It is infinite at even multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_ns(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 's'); }

/* sn(u | m) alone.
   Domain and accuracy are those of jacobi_sncndn, which computes all three functions in the same time. */
VM_API vm_real jacobi_sn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return sn;
}

/* cn(u | m) alone.
   Domain and accuracy are those of jacobi_sncndn, which computes all three functions in the same time. */
VM_API vm_real jacobi_cn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return cn;
}

/* dn(u | m) alone.
   Domain and accuracy are those of jacobi_sncndn, which computes all three functions in the same time. */
VM_API vm_real jacobi_dn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return dn;
}

#endif
