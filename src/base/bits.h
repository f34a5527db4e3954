/* base/bits.h - the bits of a number, and products with powers of two

   A vm_real is stored as a sign, an exponent and a mantissa. The functions here read and write these bits as an
   integer, and multiply by 2^k without a function of the C library, so that every machine gives the same bits.

       vm_real y = vmi_ldexp(3, 4); // 3 * 2^4 = 48

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_BASE_BITS_H
#define VARMASS_BASE_BITS_H

#include <stdint.h>
#include <string.h>

#include "real.h"
#include "sums.h"

#if VM_MANT_DIG > 24
typedef uint64_t vmi_bits;
#define VMI_STORED_DIG 52 /* number of bits in which the mantissa is stored */
#define VMI_BIAS 1023     /* the number that is stored as the exponent of 1 */
#else
typedef uint32_t vmi_bits;
#define VMI_STORED_DIG 23
#define VMI_BIAS 127
#endif

/* Returns the bits of x as an integer. */
VM_API vmi_bits vmi_to_bits(vm_real x)
{
    vmi_bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Returns the number whose bits are the given integer. */
VM_API vm_real vmi_from_bits(vmi_bits bits)
{
    vm_real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Returns x 2^k. The function multiplies x twice by about 2^(k/2), because 2^k itself may overflow or underflow. It
   rounds at most once if |x| lies between 1/4 and 4 or is 0, or if x 2^(k/2) is a normal number. */
VM_API vm_real vmi_ldexp(vm_real x, int k)
{
    const int limit = 2 * VMI_BIAS - 2;
    int half, rest;
    if (k > limit) k = limit;
    if (k < -limit) k = -limit;
    half = k / 2;
    rest = k - half;
    return x * vmi_from_bits((vmi_bits)(VMI_BIAS + half) << VMI_STORED_DIG) *
           vmi_from_bits((vmi_bits)(VMI_BIAS + rest) << VMI_STORED_DIG);
}

/* Returns (y + y_lo) 2^k for 1/2 <= y <= 2 and a low word y_lo of y. The result is rounded once, even if subnormal. */
VM_API vm_real vmi_ldexp_two(vm_real y, vm_real y_lo, int k)
{
    if (k < 1 - VMI_BIAS || (k == 1 - VMI_BIAS && y < 1)) {
        /* A subnormal result has fewer digits than y + y_lo. The code adds a power of two and subtracts it again, which
           removes the superfluous digits with one rounding. */
        const int most = VM_MANT_DIG + 1, lost = 1 - VMI_BIAS - k < most ? 1 - VMI_BIAS - k : most;
        const vm_real large = vmi_ldexp(1, lost);
        const vm_two sum = vmi_fast_two_sum(large, y);
        y = (sum.hi + (sum.lo + y_lo)) - large;
        y_lo = 0;
    }
    return vmi_ldexp(y + y_lo, k);
}

/* The signed integer type that holds the bits of a vm_real, and the bits of the number 1 */
#if VM_MANT_DIG > 24
typedef int64_t vmi_signed_bits;
#else
typedef int32_t vmi_signed_bits;
#endif
#define VMI_BITS_OF_1 ((vmi_signed_bits)VMI_BIAS << VMI_STORED_DIG)

#endif
