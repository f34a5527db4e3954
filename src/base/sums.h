/* base/sums.h - exact sums: numbers in two words */
#ifndef VARMASS_BASE_SUMS_H
#define VARMASS_BASE_SUMS_H

#include "real.h"

typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two; /* hi + lo, |lo| <= ulp(hi)/2 */

/* x without the excess precision in which x87 units compute, and gcc in gnu modes keeps it */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2)
VM_API vm_real vmi_rounded(vm_real x)
{
    volatile vm_real stored = x;
    return stored;
}
#else
#define vmi_rounded(x) (x)
#endif

/* a + b exactly (Knuth) */
VM_API vm_two vmi_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    vm_real b_part;
    s.hi = vmi_rounded(a + b);
    b_part = vmi_rounded(s.hi - a);
    s.lo = vmi_rounded((a - (s.hi - b_part)) + (b - b_part));
    return s;
}

/* a + b exactly, for |a| >= |b| (Dekker) */
VM_API vm_two vmi_fast_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    s.hi = vmi_rounded(a + b);
    s.lo = vmi_rounded((a - s.hi) + b);
    return s;
}

VM_API vm_two vmi_two(vm_real hi, vm_real lo)
{
    vm_two x;
    x.hi = hi;
    x.lo = lo;
    return x;
}

#endif
