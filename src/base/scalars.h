/* base/scalars.h - functions that are accurate where the usual formula loses digits

   The functions compute e^y - 1 and ln(1 + x) accurately for small arguments, quotients that become 0/0 at x = 0, and a
   power that has the values of the C library's pow at 0 and infinity.

       vm_two p = vmi_expm1(vmi_two(VM_C(1e-9), 0)); // e^1e-9 - 1 with all its digits

   Tests: tests/test_lambert.c, tests/test_drum.c, tests/test_laws.c. */
#ifndef VARMASS_BASE_SCALARS_H
#define VARMASS_BASE_SCALARS_H

#include "bits.h"
#include "elementary.h"
#include "real.h"
#include "sums.h"
#include "words.h"

/* Returns infinity if the condition holds, else 0. */
VM_API vm_real vmi_infinity_if(int condition) { return condition ? VM_INFINITY : 0; }

/* Returns x^y for x >= 0 within 0.9 ulp; NaN if x < 0 or an argument is NaN. At 0 and infinity the result is that of
   the C library's pow. */
VM_API vm_real vmi_pow_checked(vm_real x, vm_real y)
{
    const vm_real beyond = 1 / (VM_EPSILON * VM_EPSILON); /* with such a y the power is 0 or infinite */
    if (x != x || y != y || x < 0) return VM_NAN;
    if (y == 0 || x == 1) return 1;
    if (x == 0 || x > VM_MAX) return vmi_infinity_if((y > 0) == (x > 0));
    y = vmi_clamp(y, -beyond, beyond);
    return vmi_pow_two(vmi_two(x, 0), vmi_two(y, 0));
}

/* Returns e^y - 1 in two words. The error is below 2^-(p+4) (1 + e^y), where p is the number of binary digits of
   vm_real; for small y the error is below 2^-p times the result. Where e^y overflows, the result is infinity. */
VM_API vm_two vmi_expm1(vm_two y)
{
    const vm_real largest = VM_C(0.6931471805599453094) * (VMI_BIAS + 1);
    const vm_real least = VM_C(-0.6931471805599453094) * (2 * VM_MANT_DIG);
    vm_real p_lo, p;
    vm_two sum, power;
    int k;
    if (y.hi > largest) return vmi_two(VM_INFINITY, 0);
    if (y.hi != y.hi) return vmi_two(y.hi, 0);
    if (!(y.hi > least)) return vmi_two(-1, 0);
    p = vmi_exp_core(y.hi, y.lo, &k, &p_lo);
    if (k == 0) return vmi_two(p, p_lo);
    sum = vmi_fast_two_sum(1, p);
    power = vmi_fast_two_sum(sum.hi, sum.lo + p_lo);
    power = vmi_two(vmi_ldexp(power.hi, k), vmi_ldexp(power.lo, k));
    sum = vmi_two_sum(power.hi, -1);
    if (!VM_IS_FINITE(power.hi)) return vmi_two(power.hi, 0);
    return vmi_fast_two_sum(sum.hi, sum.lo + power.lo);
}

/* Returns ln(1 + x) in two words for -1 < x < 1e299 (float 1e34); a larger x may give NaN. The relative error is below
   2^-(p+7), where p is the number of binary digits of vm_real. Method: 1 + x = y (1 + t), where y is one word and t is
   below an ulp of 1. */
VM_API vm_two vmi_log1p(vm_two x)
{
    const vm_two sum = vmi_two_sum(1, x.hi), low = vmi_two_sum(sum.lo, x.lo);
    const vm_two y = vmi_two_sum(sum.hi, low.hi);
    const vm_two t = vmi_two_over(vmi_two_sum(y.lo, low.lo), vmi_two(y.hi, 0));
    return vmi_two_plus(vmi_log(y.hi), vmi_two(t.hi, t.lo - t.hi * t.hi / 2));
}

/* Returns (e^x - 1)/x, which is 1 at x = 0, and infinity where e^x overflows. */
VM_API vm_real vmi_exp_ratio(vm_real x)
{
    if (x > VM_MAX) return x;
    if (x == 0) return 1;
    return vmi_expm1(vmi_two(x, 0)).hi / x;
}

/* Returns ln(1 + x)/x, which is 1 at x = 0, and NaN for x <= -1 and infinite x. */
VM_API vm_real vmi_log_ratio(vm_real x)
{
    if (!(x > -1) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return 1;
    return vmi_two_log(vmi_two_sum(1, x)).hi / x;
}

/* Returns (x - y)/x^2, where y must be ln(1 + x). For |x| >= 1/4 the result has two words; its error comes from the
   errors of x and y, which the subtraction amplifies. For a smaller |x| the result has one word and is computed by the
   series of ln((1 + u)/(1 - u)) with u = x/(2 + x), where |u| <= 1/7. */
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
