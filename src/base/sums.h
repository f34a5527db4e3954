/* base/sums.h - sums without rounding error, numbers in two words

   A sum of two numbers of type vm_real is rounded. The functions here return the rounded sum (hi) and its rounding
   error (lo), so that hi + lo is the exact sum. Such a pair, a vm_two, is a number in two words: it has twice the
   digits of a vm_real.

       vm_two s = vmi_two_sum(1, VM_C(1e-20)); // s.hi = 1, s.lo = 1e-20

   Tests: tests/test_jacobi.c, tests/test_headers.sh. */
#ifndef VARMASS_BASE_SUMS_H
#define VARMASS_BASE_SUMS_H

#include "real.h"

/* The number hi + lo, where |lo| is at most half an ulp of hi */
typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two;

/* Returns x rounded to the type vm_real. The function is needed where the processor's x87 unit computes with more
   digits and gcc in its gnu modes keeps the additional digits in variables. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2)
VM_API vm_real vmi_rounded(vm_real x)
{
    volatile vm_real stored = x;
    return stored;
}
#else
#define vmi_rounded(x) (x)
#endif

/* Returns the exact sum a + b as a pair, by Knuth's method. */
VM_API vm_two vmi_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    vm_real b_part;
    s.hi = vmi_rounded(a + b);
    b_part = vmi_rounded(s.hi - a);
    s.lo = vmi_rounded((a - (s.hi - b_part)) + (b - b_part));
    return s;
}

/* Returns the exact sum a + b as a pair, for |a| >= |b|, by Dekker's method. */
VM_API vm_two vmi_fast_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    s.hi = vmi_rounded(a + b);
    s.lo = vmi_rounded((a - s.hi) + b);
    return s;
}

/* Returns the pair with the words hi and lo, which are stored as they are. */
VM_API vm_two vmi_two(vm_real hi, vm_real lo)
{
    vm_two x;
    x.hi = hi;
    x.lo = lo;
    return x;
}

#endif
