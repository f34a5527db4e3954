/* base/bits.h - the bits of a number, scaling by powers of two */
#ifndef VARMASS_BASE_BITS_H
#define VARMASS_BASE_BITS_H

#include <stdint.h>
#include <string.h>

#include "real.h"
#include "sums.h"

/* Logarithm, exponential and power with a low word. No branch but where a result is subnormal, no function of the C
   library, so that they are the same everywhere and loops over them vectorise. Tables: tests/gen/elementary.py. */
#if VM_MANT_DIG > 24
typedef uint64_t vmi_bits;
#define VMI_STORED_DIG 52 /* of the mantissa */
#define VMI_BIAS 1023     /* of the exponent */
#else
typedef uint32_t vmi_bits;
#define VMI_STORED_DIG 23
#define VMI_BIAS 127
#endif

VM_API vmi_bits vmi_to_bits(vm_real x)
{
    vmi_bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

VM_API vm_real vmi_from_bits(vmi_bits bits)
{
    vm_real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* x 2^k, rounded at most once, for |x| from 2^-2 to 4 or 0; for any x, if x 2^(k/2) is a normal number */
VM_API vm_real vmi_ldexp(vm_real x, int k)
{
    const int limit = 2 * VMI_BIAS - 2;
    const int bounded = k > limit ? limit : k < -limit ? -limit : k, half = bounded / 2, rest = bounded - half;
    return x * vmi_from_bits((vmi_bits)(VMI_BIAS + half) << VMI_STORED_DIG) *
           vmi_from_bits((vmi_bits)(VMI_BIAS + rest) << VMI_STORED_DIG);
}

/* (y + y_lo) 2^k, rounded once also where it is subnormal, for y from 1/2 to 2 */
VM_API vm_real vmi_ldexp_two(vm_real y, vm_real y_lo, int k)
{
    if (k < 1 - VMI_BIAS || (k == 1 - VMI_BIAS && y < 1)) { /* added to a larger number, y loses the same digits */
        const vm_real large = vmi_ldexp(1, k < -VMI_BIAS - VM_MANT_DIG ? VM_MANT_DIG + 1 : 1 - VMI_BIAS - k);
        const vm_two sum = vmi_fast_two_sum(large, y);
        y = (sum.hi + (sum.lo + y_lo)) - large;
        y_lo = 0;
    }
    return vmi_ldexp(y + y_lo, k);
}

/* x^p, to 1.5 % for results within 0.1 .. 10 and to a factor of 2 for 1e-4 .. 1e4; x normal, > 0. The bits of
   2^k (1 + f), read as an integer, are k + f, which is within 0.043 of log2 x - 0.043; exp(16 v) is
   (1 + v + v^2/2)^16. Basic operations only, so that the same steps are taken everywhere. */
#if VM_MANT_DIG > 24
typedef int64_t vmi_signed_bits;
#define VMI_BITS_OF_1 ((vmi_signed_bits)1023 << 52)
#else
typedef int32_t vmi_signed_bits;
#define VMI_BITS_OF_1 ((vmi_signed_bits)127 << 23)
#endif

#endif
