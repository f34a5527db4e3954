/* base/lambert.h - Lambert's function W

   w = W(x) solves w e^w = x. The equation has one solution for x >= 0 and two for -1/e <= x < 0: the branch W_0 >= -1
   (vm_lambert_w0) and the branch W_-1 <= -1 (vm_lambert_wm1). The functions that take the logarithm of the argument
   work where the argument itself would overflow or underflow.

       vm_real w = vm_lambert_w0(1); // 0.567..., the solution of w e^w = 1

   Method: a start value is improved by the steps of Fritsch, Shafer and Crowley (Comm. ACM 16, 1973), which have order
   four. This means that the error after a step is proportional to the fourth power of the error before it. A start
   value needs two steps if its error is at most 2 %, and one step if its error is at most 1e-4. The residual
   ln(x/w) - w is computed in two words, so that the final error is little more than one rounding error.
   Tests: tests/test_lambert.c. */
#ifndef VARMASS_BASE_LAMBERT_H
#define VARMASS_BASE_LAMBERT_H

#include "elementary.h"
#include "real.h"
#include "scalars.h"
#include "sums.h"
#include "words.h"

/* Returns the relative correction of w, which is the correction divided by w, by the method of Fritsch, Shafer and
   Crowley. The arguments are w1 = 1 + w and the residual z = ln(x/w) - w. */
VM_API vm_real vmi_lambert_correction(vm_real w1, vm_real z)
{
    const vm_real first = z / w1, half_q = w1 + 2 * z / 3;
    return first * ((half_q - first / 2) / (half_q - first));
}

/* Returns Lambert's W of a number x that is not close to -1/e, from l = ln|x| in two words and a rough value w of W.
   Two steps are enough if the error of w is at most 2 %, and one step if it is at most 1e-4. */
VM_API vm_real vmi_lambert_far(vm_two l, vm_real w, int steps)
{
    int i;
    for (i = 0; i < steps; i++) {
        const vm_two ln = vmi_log(VM_FABS(w));
        const vm_two z = vmi_two_plus(vmi_two_plus(l, vmi_minus(ln)), vmi_two(-w, 0));
        w += w * vmi_lambert_correction(1 + w, z.hi);
    }
    return w;
}

/* Returns W_0(x) for x from -1/4 to 55. The number g is W_0(x)/x with an error of at most 1e-4, computed as a quotient
   of polynomials in r = sqrt(1 + e x). One step of vmi_lambert_correction then improves w = g x, which has two words;
   for this w the logarithm ln(x/w) is -ln g. */
VM_API vm_real vmi_lambert_middle(vm_real x)
{
    const vm_real r = VM_SQRT(1 + VM_C(2.718281828459045) * x);
    vm_real g, z;
    vm_two w, ln;
    if (r < VM_C(2.97))
        g = (VM_C(2.724123732) + r * (VM_C(0.2279612433) - r * VM_C(0.008327681558))) /
            (1 + r * (VM_C(1.510476714) + r * VM_C(0.4332891023)));
    else
        g = (VM_C(3.123770417) + r * (VM_C(0.07756765143) - r * VM_C(0.0009571950887))) /
            (1 + r * (VM_C(1.818644339) + r * VM_C(0.3351457891)));
    w = vmi_two_product(x, g);
    ln = vmi_log(g);
    z = -((ln.hi + w.hi) + (ln.lo + w.lo));
    return w.hi + (w.lo + w.hi * vmi_lambert_correction(1 + w.hi, z));
}

/* Returns a rough value of W_0(e^l), right to 6e-5, for l from 3.95 to 712. */
VM_API vm_real vmi_lambert_rational(vm_real l)
{
    vm_real above, below;
    if (l < 24) {
        above = VM_C(0.662180417) + l * (VM_C(0.3951587621) + l * (VM_C(0.2108913562) + l * VM_C(0.005136464812)));
        below = 1 + l * (VM_C(0.2373079821) + l * VM_C(0.005161503917));
    } else if (l < 120) {
        above = VM_C(-0.7963177685) + l * (VM_C(0.7513901587) + l * VM_C(0.05372887458));
        below = 1 + l * (VM_C(0.05415434916) - l * VM_C(6.990819291e-7));
    } else {
        above = VM_C(-2.789606648) + l * (VM_C(0.9409089019) + l * VM_C(0.009304151471));
        below = 1 + l * (VM_C(0.009316976902) - l * VM_C(3.625903141e-9));
    }
    return above / below;
}

/* Returns Lambert's W of x < 0 from s = -1 - ln(-x). The result is W_-1 if `lower` is 1. It is W_0 if `lower` is 0, for
   x close to -1/e. Method: W = -1 - v, where v solves v - ln(1 + v) = s; v is positive for W_-1 and negative for W_0. A
   value of s between -eps/2 and 0 is caused by rounding and means x = -1/e. The start value of v comes from a formula
   by Barry, Culligan-Hensley and Barry (ACM TOMS 21, 1995) for W_-1, and from a series in sqrt(2s), which is good for
   s < 0.4, for W_0. */
VM_API vm_real vmi_lambert_near(vm_two s, int lower)
{
    const vm_real barry = VM_C(0.3361), root = VM_SQRT(2 * s.hi);
    vm_real v, dv = 0;
    vm_two sum;
    int i;
    if (!(s.hi > -VM_EPSILON / 2)) return VM_NAN;
    if (s.hi <= 0) return -1;
    if (lower) v = s.hi + 2 / barry * (1 - 1 / (1 + barry / 2 * root));
    else v = -root * (1 - root * (VM_C(1.) / 3 - root / 36));
    for (i = 0; i < 2; i++) {
        vm_two x, z, ln;
        v += dv;
        x = vmi_two(v, 0);
        ln = vmi_log1p(x);
        if (VM_FABS(v) < VM_C(0.25)) z = vmi_two_times(vmi_log1p_rest(x, ln), vmi_two_product(v, v));
        else z = vmi_two_plus(x, vmi_minus(ln));
        z = vmi_two_plus(z, vmi_minus(s));
        dv = (1 + v) * vmi_lambert_correction(-v, z.hi);
    }
    sum = vmi_two_sum(1, v);
    return -(sum.hi + (sum.lo + dv));
}

/* Returns s = -1 - ln(-x), the argument of vmi_lambert_near, for x < -1/4. It is computed from 1 + e x in two words, so
   that it keeps its digits where x is close to -1/e. */
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

/* Returns a rough value of W_0(x), right to 2 %, for -0.253 < x < 1. */
VM_API vm_real vmi_lambert_pade(vm_real x) { return x * (3 + 4 * x) / (3 + x * (7 + x * VM_C(2.5))); }

/* Returns a rough value of W_0(x), right to 2 %, for x >= 1, from L = ln(1 + x) (by Winitzki). */
VM_API vm_real vmi_lambert_winitzki(vm_real L) { return L * (1 - vmi_log(1 + L).hi / (2 + L)); }

/* Lambert's W_0(x), the upper branch: the solution w >= -1 of w e^w = x, for x >= -1/e. x is a pure number and taken
   as exact. The error is at most 1 ulp. Returns infinity for x = infinity, and NaN for x < -1/e. The vm_real that is
   nearest to -1/e counts as -1/e and gives -1. */
VM_API vm_real vm_lambert_w0(vm_real x)
{
    vm_two l;
    if (VM_FABS(x) < VM_EPSILON / 8 || x != x || x == VM_INFINITY) return x; /* W_0(x) = x - x^2 + ... */
    if (x == -VM_INFINITY) return VM_NAN;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 0);
    if (x < 55) return vmi_lambert_middle(x);
    l = vmi_log(x);
    return vmi_lambert_far(l, vmi_lambert_rational(l.hi), 1);
}

/* Lambert's W_-1(x), the lower branch: the solution w <= -1 of w e^w = x, for -1/e <= x < 0. x is a pure number and
   taken as exact. The error is at most 1 ulp. Returns -infinity for x = 0, and NaN for x > 0 and for x < -1/e. The
   vm_real that is nearest to -1/e counts as -1/e and gives -1. */
VM_API vm_real vm_lambert_wm1(vm_real x)
{
    vm_two ln;
    if (!(x <= 0) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 1);
    ln = vmi_log(-x);
    return vmi_lambert_near(vmi_two_plus(vmi_two(-1, 0), vmi_minus(ln)), 1);
}

#define VMI_LAMBERT_TINY (-(VM_MANT_DIG + 2) * VM_C(0.7)) /* if ln|x| is less than this number, W_0(x) rounds to x */

/* Wright's omega function W_0(e^l), the solution w of w + ln w = l, for any l. It also works where e^l itself
   overflows or underflows. l is taken as exact. The error is at most 1 ulp. Returns infinity for l = infinity
   and 0 for l = -infinity. */
VM_API vm_real vm_wright_omega(vm_real l)
{
    const vm_real direct_from = 40; /* for l >= 40, ln(1 + e^l) rounds to l */
    vm_real start;
    if (l != l || l == VM_INFINITY) return l;
    if (l < VMI_LAMBERT_TINY) return vmi_exp(l, 0);
    if (l > 4 && l < 712) return vmi_lambert_far(vmi_two(l, 0), vmi_lambert_rational(l), 1);
    if (l < 0) start = vmi_lambert_pade(vmi_exp(l, 0));
    else if (l < direct_from) start = vmi_lambert_winitzki(vmi_log(1 + vmi_exp(l, 0)).hi);
    else start = vmi_lambert_winitzki(l);
    return vmi_lambert_far(vmi_two(l, 0), start, 2);
}

/* W_0(-e^l), the upper branch for the negative argument -e^l with l <= -1. The function also works where e^l itself
   underflows. l is taken as exact. The error is at most 1 ulp. Returns 0 for l = -infinity and NaN for l > -1. */
VM_API vm_real vm_lambert_w0_neg_exp(vm_real l)
{
    if (!(l <= -1)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return -vmi_exp(l, 0);
    if (l > VM_C(-1.375)) return vmi_lambert_near(vmi_two(-1 - l, 0), 0);
    return vmi_lambert_far(vmi_two(l, 0), vmi_lambert_pade(-vmi_exp(l, 0)), 2);
}

/* W_-1(-e^l), the lower branch for the negative argument -e^l with l <= -1. The function also works where e^l itself
   underflows. l is taken as exact. The error is at most 1 ulp. Returns -infinity for l = -infinity and NaN for
   l > -1. */
VM_API vm_real vm_lambert_wm1_neg_exp(vm_real l)
{
    if (!(l <= -1)) return VM_NAN;
    if (l == -VM_INFINITY) return l;
    if (l < -1 / VM_EPSILON) return vmi_lambert_far(vmi_two(l, 0), l, 2);
    return vmi_lambert_near(vmi_two_sum(-1, -l), 1);
}

#endif
