/* base/power_of_two.h - a power of two of about the size of a number, for scaling without rounding errors

       vm_real power = vmi_power_below(12); // 8

   Tests: tests/test_attitude.c, tests/test_jeffcott.c. */
#ifndef VARMASS_BASE_POWER_OF_TWO_H
#define VARMASS_BASE_POWER_OF_TWO_H

#include "bits.h"
#include "real.h"

/* Returns the largest power of two that is at most x, or VM_MIN if x is smaller than VM_MIN. */
VM_API vm_real vmi_power_below(vm_real x)
{
    const vmi_bits mantissa = ((vmi_bits)1 << VMI_STORED_DIG) - 1;
    if (x < VM_MIN) return VM_MIN;
    return vmi_from_bits(vmi_to_bits(x) & ~mantissa);
}

#endif
