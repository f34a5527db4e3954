/* base/hypot.h - the length of a vector in the plane

   Tests: tests/test_jumps.c, tests/test_laws.c. */
#ifndef VARMASS_BASE_HYPOT_H
#define VARMASS_BASE_HYPOT_H

#include "real.h"

/* Returns the length sqrt(x^2 + y^2), also where the squares overflow or underflow, and NaN if x or y is NaN. */
VM_API vm_real vmi_hypot(vm_real x, vm_real y)
{
    const vm_real a = VM_FABS(x), b = VM_FABS(y), most = vmi_larger(a, b), least = vmi_smaller(b, a);
    vm_real q = 0;
    if (x != x || y != y) return VM_NAN;
    if (most > VM_MAX) return most;
    if (most > 0) q = least / most;
    return most * VM_SQRT(1 + q * q);
}

#endif
