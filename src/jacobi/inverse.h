/* jacobi/inverse.h - the inverses of sn, cn and dn

   Each function returns the solution u of sn(u | m) = x, cn(u | m) = x or dn(u | m) = x that is nearest to 0. The
   solutions for cn and dn are pairs u, -u; for these the positive u is returned. All other solutions follow from the
   period 4 K and the symmetries. The inverse of the amplitude is F(phi | m), which jacobi_F computes.

       vm_real u = jacobi_inverse_cn(VM_C(0.3), VM_C(0.5)); // cn(u | 0.5) = 0.3

   Equations: DLMF 22.15, 19.25.31. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_INVERSE_H
#define VARMASS_JACOBI_INVERSE_H

#include "../base/elementary.h"
#include "../base/hypot.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "carlson.h"
#include "integrals.h"

/* Returns the inverse of sn for 1 - m = m1 + m1_lo, a number in two words. The difference 1 - x^2 is computed as the
   product (1 - x)(1 + x), so that no digits are lost. */
VM_API vm_real vmi_inverse_sn(vm_real x, vm_real m1, vm_real m1_lo)
{
    const vm_real cc = (1 - x) * (1 + x);
    if (!(VM_FABS(x) <= 1) || !(m1 >= 0)) return VM_NAN;
    if (!VM_IS_FINITE(m1)) return 0 * x;
    if (cc == 0) return x * vmi_K(m1, m1_lo);
    return x * vmi_rf(cc, cc + m1 * (x * x), 1);
}

/* The inverse of sn: u with sn(u | m) = x and |u| <= K, for |x| <= 1 and m <= 1. The result is odd in x. The error is
   at most 8 ulp; for x = 1 the result has the same bits as jacobi_K(m). For m = 1 the function is the inverse of tanh,
   infinite for |x| = 1. Returns 0 for m = -infinity, and NaN for |x| > 1 and for m > 1. DLMF 22.15.12. */
VM_API vm_real jacobi_inverse_sn(vm_real x, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_inverse_sn(x, m1.hi, m1.lo);
}

/* The inverse of sn from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_inverse_sn. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_inverse_sn_m1(vm_real x, vm_real m1) { return vmi_inverse_sn(x, m1, 0); }

/* Returns ln(4/(x + root)), the limit of u for tiny numbers x = dn u and root = |cn u|, or the reverse, where m is 1 or
   next to it. */
VM_API vm_real vmi_inverse_next_to_1(vm_real x, vm_real root)
{
    return VM_C(1.386294361119890572454) - vmi_log(x + root).hi;
}

/* Returns the inverse of cn for 1 - m = m1 + m1_lo, a number in two words. For x >= 0 the inverse is at most K. For
   x < 0 it is 2 K minus the inverse at |x|. */
VM_API vm_real vmi_inverse_cn(vm_real x, vm_real m1, vm_real m1_lo)
{
    const vm_real ss = (1 - x) * (1 + x), cc = x * x;
    vm_real u;
    if (!(VM_FABS(x) <= 1) || !(m1 >= 0)) return VM_NAN;
    if (!VM_IS_FINITE(m1)) return 0;
    if (m1 == 0 && x < 0) return VM_NAN;
    if (x == 0) return vmi_K(m1, m1_lo);
    if (cc + m1 < VM_MIN / VM_EPSILON) u = vmi_inverse_next_to_1(VM_FABS(x), vmi_hypot(x, VM_SQRT(m1)));
    else u = VM_SQRT(ss) * vmi_rf(cc, cc + m1 * ss, 1);
    if (x < 0) return 2 * vmi_K(m1, m1_lo) - u;
    return u;
}

/* The inverse of cn: u with cn(u | m) = x and 0 <= u <= 2K, for |x| <= 1 and m <= 1. The error is at most 8 ulp; for
   x = 0 the result has the same bits as jacobi_K(m). For m = 1 the function is the inverse of 1/cosh, infinite for
   x = 0 and NaN for x < 0. Returns 0 for m = -infinity, and NaN for |x| > 1 and for m > 1. DLMF 22.15.13. */
VM_API vm_real jacobi_inverse_cn(vm_real x, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_inverse_cn(x, m1.hi, m1.lo);
}

/* The inverse of cn from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_inverse_cn. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_inverse_cn_m1(vm_real x, vm_real m1) { return vmi_inverse_cn(x, m1, 0); }

/* Returns the inverse of dn for a tiny x, whose square may underflow; then m1 <= x^2 is tiny, too. |cn u| is the root
   of x^2 - m1, which is computed with x and m1 multiplied by large powers of 4. */
VM_API vm_real vmi_inverse_dn_next_to_1(vm_real x, vm_real m1, vm_real m1_lo)
{
    const vm_real lift = VMI_RJ_LIFT;
    const vm_two lifted = vmi_two_product(lift * x, lift * x);
    const vm_real rest = (lifted.hi - lift * lift * m1) + lifted.lo;
    if (x == 0) return VM_INFINITY;
    if (m1 == 0) return vmi_inverse_next_to_1(x, x);
    if (!(rest > 0)) return vmi_K(m1, m1_lo);
    return vmi_inverse_next_to_1(x, VM_SQRT(rest) / lift);
}

/* Returns the inverse of dn for 1 - m = m1 + m1_lo, a number in two words. With s = sn u and c = cn u, s^2 is
   (1 - x^2)/m, and c^2 is (x^2 - m1)/m. The difference x^2 - m1 is computed from the exact square of x. If x is the
   rounded value of k', the computed c^2 may be negative, and s^2 above 1; then c is 0, and the inverse is K. */
VM_API vm_real vmi_inverse_dn(vm_real x, vm_real m, vm_real m1, vm_real m1_lo)
{
    const vm_real bound = VM_SQRT(m1);
    const vm_two square = vmi_two_product(x, x);
    vm_real ss, cc;
    if (!(x >= vmi_smaller(bound, 1) && x <= vmi_larger(bound, 1)) || !(m1 >= 0)) return VM_NAN;
    if (x == 1) return 0;
    if (square.hi < VM_MIN / VM_EPSILON) return vmi_inverse_dn_next_to_1(x, m1, m1_lo);
    cc = ((square.hi - m1) + (square.lo - m1_lo)) / m;
    if (!(cc > 0)) return vmi_K(m1, m1_lo);
    ss = vmi_smaller((1 - x) * (1 + x) / m, 1);
    return VM_SQRT(ss) * vmi_rf(cc, square.hi, 1);
}

/* The inverse of dn: u with dn(u | m) = x and 0 <= u <= K, for x between 1 and sqrt(1 - m), m <= 1. The error is at
   most 8 ulp. For m = 1 the function is the inverse of 1/cosh, infinite for x = 0. Returns NaN for m > 1, for infinite
   m, and for an x that is not between 1 and sqrt(1 - m). For m = 0 dn is 1 everywhere; then u is 0 for x = 1. DLMF
   22.15.14. */
VM_API vm_real jacobi_inverse_dn(vm_real x, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    if (!VM_IS_FINITE(m)) return VM_NAN;
    return vmi_inverse_dn(x, m, m1.hi, m1.lo);
}

/* The inverse of dn from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_inverse_dn. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_inverse_dn_m1(vm_real x, vm_real m1)
{
    if (!VM_IS_FINITE(m1)) return VM_NAN;
    return vmi_inverse_dn(x, 1 - m1, m1, 0);
}

#endif
