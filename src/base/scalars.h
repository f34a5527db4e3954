/* base/scalars.h - expm1, log1p, checked powers and quotients that tend to 0/0 */
#ifndef VARMASS_BASE_SCALARS_H
#define VARMASS_BASE_SCALARS_H

#include "bits.h"
#include "elementary.h"
#include "real.h"
#include "sums.h"
#include "words.h"

/* x^y for x >= 0, within 0.6 ulp, with the limits of pow at 0 and infinity; NaN for x < 0 */
VM_API vm_real vmi_pow_checked(vm_real x, vm_real y)
{
    if (x != x || y != y || x < 0) return VM_NAN;
    if (y == 0 || x == 1) return 1;
    if (x == 0 || x > VM_MAX) return (y > 0) == (x > 0) ? VM_INFINITY : 0;
    if (!VM_IS_FINITE(y)) return (y > 0) == (x > 1) ? VM_INFINITY : 0;
    return vmi_pow_two(vmi_two(x, 0), vmi_two(y, 0));
}

/* e^y - 1 in two words: within 2^-(p+4) (1 + e^y), p the type's digits; relative to the result below 2^-p for small
   y. Infinity where it overflows */
VM_API vm_two vmi_expm1(vm_two y)
{
    const vm_real largest = VM_C(0.6931471805599453094) * (VMI_BIAS + 1);
    const vm_real least = VM_C(-0.6931471805599453094) * (2 * VM_MANT_DIG);
    vm_real p_lo, p;
    vm_two sum, power;
    int k;
    if (y.hi > largest) return vmi_two(VM_INFINITY, 0);
    if (!(y.hi > least)) return vmi_two(y.hi == y.hi ? -1 : y.hi, 0);
    p = vmi_exp_core(y.hi, y.lo, &k, &p_lo);
    if (k == 0) return vmi_two(p, p_lo);
    sum = vmi_fast_two_sum(1, p);
    power = vmi_fast_two_sum(sum.hi, sum.lo + p_lo);
    power = vmi_two(vmi_ldexp(power.hi, k), vmi_ldexp(power.lo, k));
    sum = vmi_two_sum(power.hi, -1);
    return VM_IS_FINITE(power.hi) ? vmi_fast_two_sum(sum.hi, sum.lo + power.lo) : vmi_two(power.hi, 0);
}

/* ln(1 + x) in two words, for -1 < x < 1e299 (float 1e34; NaN beyond): relative error below 2^-(p+7), p the type's
   digits. 1 + x = y (1 + t) with y one word: ln y has it, and t is below an ulp of 1 */
VM_API vm_two vmi_log1p(vm_two x)
{
    const vm_two sum = vmi_two_sum(1, x.hi), low = vmi_two_sum(sum.lo, x.lo);
    const vm_two y = vmi_two_sum(sum.hi, low.hi);
    const vm_two t = vmi_two_over(vmi_two_sum(y.lo, low.lo), vmi_two(y.hi, 0));
    return vmi_two_plus(vmi_log(y.hi), vmi_two(t.hi, t.lo - t.hi * t.hi / 2));
}

/* (e^x - 1)/x and ln(1 + x)/x, 1 at x = 0, within 2 eps */
VM_API vm_real vmi_exp_ratio(vm_real x)
{
    if (x > VM_MAX) return x;
    return x == 0 ? 1 : vmi_expm1(vmi_two(x, 0)).hi / x;
}

VM_API vm_real vmi_log_ratio(vm_real x)
{
    if (!(x > -1) || !VM_IS_FINITE(x)) return VM_NAN;
    return x == 0 ? 1 : vmi_log1p(vmi_two(x, 0)).hi / x;
}

/* (x - y)/x^2 with y = ln(1 + x), both given: in two words for |x| >= 1/4, but for what the words of x and y lose in
   the difference; below that within 2 ulp, by x = 2u/(1 - u), ln(1 + x) = 2 u + 2 u^3 P(u^2), |u| <= 1/7 */
VM_API vm_two vmi_log1p_rest(vm_two x, vm_two y)
{
#if VM_MANT_DIG > 24
    enum { degree = 9 };
#else
    enum { degree = 4 };
#endif
    const vm_real u = x.hi / (2 + x.hi);
    vm_real P = 0;
    int n;
    if (!(VM_FABS(x.hi) < VM_C(0.25))) return vmi_two_over(vmi_two_over(vmi_two_plus(x, vmi_minus(y)), x), x);
    for (n = degree; n >= 0; n--) P = P * (u * u) + 1 / (vm_real)(2 * n + 3);
    return vmi_two((1 - u) / 2 * (1 - u * (1 - u) * P), 0);
}

#endif
