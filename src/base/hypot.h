/* base/hypot.h - the length of a plane vector without overflow */
#ifndef VARMASS_BASE_HYPOT_H
#define VARMASS_BASE_HYPOT_H

#include "real.h"

/* sqrt(x^2 + y^2), within 2 ulp, where the squares overflow too */
VM_API vm_real vmi_hypot(vm_real x, vm_real y)
{
    const vm_real a = VM_FABS(x), b = VM_FABS(y), most = a > b ? a : b, least = a > b ? b : a;
    const vm_real q = most > 0 ? least / most : 0;
    return x == x && y == y ? most * VM_SQRT(1 + q * q) : VM_NAN;
}

#endif
