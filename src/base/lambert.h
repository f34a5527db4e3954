/* base/lambert.h - Lambert's function W */
#ifndef VARMASS_BASE_LAMBERT_H
#define VARMASS_BASE_LAMBERT_H

#include "elementary.h"
#include "real.h"
#include "scalars.h"
#include "sums.h"
#include "words.h"

/* -- Lambert's W: two steps of Fritsch, Shafer and Crowley (Comm. ACM 16, 1973), of fourth order, from 2 % and less.
   The residual is taken in two words, so that the last step leaves little but its own rounding -- */
/* The relative correction of w, whose residual is z = ln(x/w) - w; w1 = 1 + w */
VM_API vm_real vmi_lambert_correction(vm_real w1, vm_real z)
{
    const vm_real first = z / w1, half_q = w1 + 2 * z / 3;
    return first * ((half_q - first / 2) / (half_q - first));
}

/* w from l = ln|x|, away from the branch point */
VM_API vm_real vmi_lambert_far(vm_two l, vm_real w)
{
    int i;
    for (i = 0; i < 2; i++) {
        const vm_two ln = vmi_log(VM_FABS(w));
        const vm_two z = vmi_two_plus(vmi_two_plus(l, vmi_minus(ln)), vmi_two(-w, 0));
        w += w * vmi_lambert_correction(1 + w, z.hi);
    }
    return w;
}

/* w = -1 - v from s = -1 - ln(-x): v - ln(1 + v) = s, with v > 0 for W_-1 and < 0 for W_0; s down to -eps/2, less
   than an ulp of x beyond the branch point, counts as 0. Starts: of W_-1 by Barry, Culligan-Hensley and Barry (ACM
   TOMS 21, 1995); of W_0, for s < 0.4, the series in sqrt(2s) */
VM_API vm_real vmi_lambert_near(vm_two s, int lower)
{
    const vm_real barry = VM_C(0.3361), root = VM_SQRT(2 * s.hi);
    vm_real v, dv = 0;
    vm_two sum;
    int i;
    if (!(s.hi > 0)) return s.hi > -VM_EPSILON / 2 ? -1 : VM_NAN;
    if (lower) v = s.hi + 2 / barry * (1 - 1 / (1 + barry / 2 * root));
    else v = -root * (1 - root * (VM_C(1.) / 3 - root / 36));
    for (i = 0; i < 2; i++) {
        vm_two x, z, ln;
        v += dv;
        x = vmi_two(v, 0);
        ln = vmi_log1p(x);
        z = VM_FABS(v) < VM_C(0.25) ? vmi_two_times(vmi_log1p_rest(x, ln), vmi_two_product(v, v))
                                    : vmi_two_plus(x, vmi_minus(ln));
        z = vmi_two_plus(z, vmi_minus(s));
        dv = (1 + v) * vmi_lambert_correction(-v, z.hi);
    }
    sum = vmi_two_sum(1, v);
    return -(sum.hi + (sum.lo + dv));
}

/* -1 - ln(-x) for x < -1/4: from 1 + e x in two words, which keeps every digit of the distance to -1/e */
VM_API vm_two vmi_lambert_depth(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_two e = vmi_two(VM_C(2.718281828459045091), VM_C(1.445646891729250137e-16));
#else
    const vm_two e = vmi_two(VM_C(2.71828174591064453125), VM_C(8.2548400704e-8));
#endif
    const vm_two q = vmi_two_plus(vmi_two(1, 0), vmi_two_times(vmi_two(x, 0), e));
    const vm_two ln = vmi_log1p(vmi_minus(q));
    return vmi_minus(ln);
}

/* Start of W_0 for -1/4 <= x < 1: within 0.02 */
VM_API vm_real vmi_lambert_pade(vm_real x) { return x * (3 + 4 * x) / (3 + x * (7 + x * VM_C(2.5))); }

/* and above, from L = ln(1 + x) (Winitzki) */
VM_API vm_real vmi_lambert_winitzki(vm_real L) { return L * (1 - vmi_log(1 + L).hi / (2 + L)); }

/* Lambert's W, w e^w = x: the branches W_0 >= -1 for x >= -1/e, and W_-1 <= -1 for -1/e <= x < 0. The number next to
   -1/e, a little below it, counts as -1/e and gives -1; W_-1(0) = -infinity. Within 1 ulp, x taken as exact. */
VM_API vm_real vm_lambert_w0(vm_real x)
{
    if (x == 0 || x != x) return x;
    if (!VM_IS_FINITE(x)) return VM_NAN;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 0);
    return vmi_lambert_far(vmi_log(VM_FABS(x)),
                           x < 1 ? vmi_lambert_pade(x) : vmi_lambert_winitzki(vmi_log(1 + x).hi));
}

/* Documented with vm_lambert_w0. */
VM_API vm_real vm_lambert_wm1(vm_real x)
{
    vm_two ln;
    if (!(x <= 0) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 1);
    ln = vmi_log(-x);
    return vmi_lambert_near(vmi_two_plus(vmi_two(-1, 0), vmi_minus(ln)), 1);
}

#define VMI_LAMBERT_TINY (-(VM_MANT_DIG + 2) * VM_C(0.7)) /* W_0(x) = x for ln|x| below */

/* The same from the logarithm of the argument, which itself may be too large or too small to be a number:
   W_0(e^l) for all l (Wright's omega), W_0(-e^l) and W_-1(-e^l) for l <= -1 */
VM_API vm_real vm_wright_omega(vm_real l)
{
    if (!VM_IS_FINITE(l)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return vmi_exp(l, 0);
    return vmi_lambert_far(vmi_two(l, 0), l < 0    ? vmi_lambert_pade(vmi_exp(l, 0))
                                          : l < 40 ? vmi_lambert_winitzki(vmi_log(1 + vmi_exp(l, 0)).hi)
                                                   : vmi_lambert_winitzki(l));
}

/* Documented with vm_wright_omega. */
VM_API vm_real vm_lambert_w0_neg_exp(vm_real l)
{
    if (!(l <= -1) || !VM_IS_FINITE(l)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return -vmi_exp(l, 0);
    if (l > VM_C(-1.375)) return vmi_lambert_near(vmi_two(-1 - l, 0), 0);
    return vmi_lambert_far(vmi_two(l, 0), vmi_lambert_pade(-vmi_exp(l, 0)));
}

/* Documented with vm_wright_omega. */
VM_API vm_real vm_lambert_wm1_neg_exp(vm_real l)
{
    if (!(l <= -1) || !VM_IS_FINITE(l)) return VM_NAN;
    if (l < -1 / VM_EPSILON) return vmi_lambert_far(vmi_two(l, 0), l);
    return vmi_lambert_near(vmi_two_sum(-1, -l), 1);
}

#endif
