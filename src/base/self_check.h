/* base/self_check.h - a test of whether this compiler and this processor compute as varmass needs

   Some options of compilers and some modes of processors change the results of floating-point arithmetic. If a macro of
   the compiler shows such an option, the headers do not compile. vm_self_check() finds the other options and modes when
   the program runs. It computes numbers that show whether sums are computed in the order in which they are written,
   whether results are rounded to the nearest number, and whether NaN, infinity, -0 and subnormal numbers exist.

       int trustworthy = vm_self_check(); // once, when the program starts

   Tests: tests/test_options.sh. */
#ifndef VARMASS_BASE_SELF_CHECK_H
#define VARMASS_BASE_SELF_CHECK_H

#include "real.h"
#include "sums.h"

/* Returns 1 if sums are computed in the order in which they are written, as arithmetic in two words needs, and if a
   product is rounded when 0 is added to it. `one` must be 1, `eps` VM_EPSILON, and `split` 2^27 + 1 (float 2^12 + 1),
   the factor that splits a number into two halves. The caller reads them from volatile variables, so that the compiler
   cannot know their values. */
VM_API int vmi_keeps_order(vm_real one, vm_real eps, vm_real split)
{
    const vm_real above = one + eps, third = one / 3;
    const vm_two sum = vmi_two_sum(one, eps / 4), other = vmi_two_sum(eps / 4, -one);
    const vm_real hi = vmi_rounded(third + eps), lo = (third - hi) + eps; /* Dekker's sum of third and eps */
    const vm_real scaled = vmi_rounded(split * above + 0), rest = vmi_rounded(scaled - above), head = scaled - rest;
    const vm_real to_integer = VM_C(1.5) / eps, shifted = vmi_rounded(third + to_integer);
    const vm_real product = vmi_rounded(third * above + 0);
    volatile vm_real stored = third * above;
    return sum.hi == one && sum.lo == eps / 4 && other.hi == -one && other.lo == eps / 4 && (hi - third) + lo == eps &&
           head == one && above - head == eps && shifted - to_integer == 0 && product - stored == 0;
}

/* Returns 1 if quotients and square roots are rounded to the nearest number. A compiler that multiplies by a reciprocal
   instead of dividing gets 1 - eps/2 instead of 1 for some of the quotients tested here. */
VM_API int vmi_divides(vm_real one)
{
    const vm_real root_of_2 = VM_C(1.4142135623730950488);
    volatile vm_real numbers[4] = {41, 47, 49, 55};
    int i, right = numbers[0] / 41 == 1 && numbers[1] / 47 == 1 && numbers[2] / 49 == 1 && numbers[3] / 55 == 1;
    for (i = 0; i < 4; i++) {
        const vm_real divisor = numbers[i], same = numbers[i];
        right &= one / divisor > 0 && same / divisor == 1 && 3 * same / divisor == 3 && 7 * same / divisor == 7;
    }
    return right && VM_SQRT(49 * one) == 7 && vmi_rounded(VM_SQRT(2 * one)) == root_of_2 && VM_FLOOR(-one / 2) == -1;
}

/* Returns 1 if sums next to 1 are rounded to the nearest number and do not keep more digits than vm_real has. A sum in
   the middle between two neighbouring numbers must be rounded to the number whose last bit is 0. */
VM_API int vmi_rounds(vm_real one, vm_real eps)
{
    const vm_real below = one + eps / 4, middle = one + eps / 2, above = one + eps * VM_C(0.75);
    const vm_real minus_below = -one - eps / 4, minus_above = -one - eps * VM_C(0.75);
    return below - one == 0 && middle - one == 0 && above - one == eps && minus_below + one == 0 &&
           minus_above + one == -eps;
}

/* Returns 1 if NaN, infinity, -0 and the subnormal numbers below VM_MIN exist and compare as they should. */
VM_API int vmi_has_all_numbers(vm_real zero, vm_real infinity, vm_real smallest)
{
    const vm_real nan = infinity - infinity, minus_zero = -zero, subnormal = smallest / 8;
    const int nan_compares = (nan < 1) | (nan >= 1);
    return nan != nan && !nan_compares && !VM_IS_FINITE(nan) && !VM_IS_FINITE(infinity) &&
           1 / minus_zero < 0 && 1 / (minus_zero + 0) > 0 && VM_COPYSIGN(1, minus_zero) == -1 && subnormal > 0 &&
           subnormal * 8 == smallest;
}

/* Returns 1 if the compiler and the processor compute as varmass needs, else 0. If it returns 0, results of the kit are
   wrong. This happens, for example, with options of clang that its macros do not show, with another rounding mode, or
   where the processor takes subnormal numbers for zero. Call it once, when the program starts. */
VM_API int vm_self_check(void)
{
    volatile vm_real zero = 0, one = 1, eps = VM_EPSILON, infinity = VM_INFINITY, smallest = VM_MIN;
    volatile vm_real split = VM_MANT_DIG > 24 ? VM_C(134217729.0) : VM_C(4097.0);
    return vmi_keeps_order(one, eps, split) && vmi_divides(one) && vmi_rounds(one, eps) &&
           vmi_has_all_numbers(zero, infinity, smallest);
}

#endif
