/* ateb/powers.h - a logarithm and an exponential that are quicker but less accurate

   vmi_log and vmi_exp (base/elementary.h) return two words. The functions in this file return one word, with an error
   of one or two ulp. ateb/inversion.h and ateb/plans.h use them where the error is later multiplied by a number below
   about 1/2.

       vm_real y = vmi_ateb_exp(vmi_ateb_ln(3) / 2); // the square root of 3

   The polynomials are computed by tests/gen/ateb_coefficients.py. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_POWERS_H
#define VARMASS_ATEB_POWERS_H

#include <stdint.h>

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* Returns a if all bits of the mask are set, and b if none is set. */
VM_INLINE vm_real vmi_select(vmi_bits mask, vm_real a, vm_real b)
{
    return vmi_from_bits((vmi_to_bits(a) & mask) | (vmi_to_bits(b) & ~mask));
}

/* Returns a mask with all bits set if x < 0, and with no bit set if x > 0. */
VM_INLINE vmi_bits vmi_mask_of_sign(vm_real x) { return 0 - (vmi_to_bits(x) >> (8 * sizeof(vm_real) - 1)); }

/* Returns L(x), where ln((1 + t)/(1 - t)) = 2 t + t^3 L(t^2), by a polynomial for |t| < 0.18. */
VM_INLINE vm_real vmi_ateb_ln_series(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_real xx = x * x;
    const vm_real L01 = VM_C(0.66666666666666727634) + x * VM_C(0.39999999999816214631);
    const vm_real L23 = VM_C(0.28571428661769779675) + x * VM_C(0.2222220559437561072);
    const vm_real L45 = VM_C(0.18183272190739985335) + x * VM_C(0.15319628746766105066);
    return (L01 + xx * L23) + (xx * xx) * (L45 + xx * VM_C(0.1475852205325647575));
#else
    return VM_C(0.666666914868) + x * (VM_C(0.399862738125) + x * VM_C(0.296881029198));
#endif
}

/* Returns ln((1 + t)/(1 - t)) for |t| < 0.18. */
VM_API vm_real vmi_ateb_ln_ratio(vm_real t)
{
    const vm_real x = t * t;
    return 2 * t + t * x * vmi_ateb_ln_series(x);
}

/* Writes a normal number x > 0 as 2^k z with z between sqrt(1/2) and sqrt(2). Returns z, and k in *k. When the bits
   of sqrt(1/2) are subtracted from those of x, the exponent of the difference is k. Older processors cannot convert
   long integers in vector registers to floating point; therefore the code makes k from the bits of the exponent. */
VM_INLINE vm_real vmi_ateb_mantissa(vm_real x, vm_real *k)
{
#if VM_MANT_DIG > 24
    const vmi_bits least = UINT64_C(0x3fe6a09e667f3bcd); /* sqrt(1/2) */
#else
    const vmi_bits least = UINT32_C(0x3f3504f3);
#endif
    const vm_real to_integer = 1 / VM_EPSILON; /* the last bits of this number plus an integer are the integer's bits */
    const vmi_bits one = (vmi_bits)1 << VMI_STORED_DIG, above = vmi_to_bits(x) - least;
    const vmi_bits exponent = (above + (VMI_BIAS + 1) * one) >> VMI_STORED_DIG;
    *k = vmi_from_bits(vmi_to_bits(to_integer) | exponent) - (to_integer + (VMI_BIAS + 1));
    return vmi_from_bits((above & (one - 1)) + least);
}

/* Returns ln(2^k (1 + t)/(1 - t)) for |t| < 0.18. The product of k and the first word of ln 2 has no rounding error. */
VM_API vm_real vmi_ateb_ln_of(vm_real k, vm_real t)
{
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    return k * ln2_hi + (vmi_ateb_ln_ratio(t) + k * ln2_lo);
}

/* Returns ln x for a normal number x > 0. */
VM_API vm_real vmi_ateb_ln(vm_real x)
{
    vm_real k;
    const vm_real z = vmi_ateb_mantissa(x, &k);
    return vmi_ateb_ln_of(k, (z - 1) / (z + 1));
}

/* Returns (e^z - 1 - z)/z^2 for |z| < 0.36, by a polynomial. */
VM_API vm_real vmi_ateb_exp_series(vm_real z)
{
    const vm_real zz = z * z;
#if VM_MANT_DIG > 24
    const vm_real E01 = VM_C(0.50000000000000000036) + z * VM_C(0.16666666666666673812);
    const vm_real E23 = VM_C(0.041666666666666509662) + z * VM_C(0.0083333333333225907093);
    const vm_real E45 = VM_C(0.0013888888888994840818) + z * VM_C(1.9841269886522535599e-4);
    const vm_real E67 = VM_C(2.4801587060781651877e-5) + z * VM_C(2.7557241366121292995e-6);
    const vm_real E89 = VM_C(2.7557527466964916697e-7) + z * VM_C(2.5110746416563258294e-8);
    const vm_real high = E89 + zz * VM_C(2.0830505426946652755e-9);
    return (E01 + zz * E23) + (zz * zz) * ((E45 + zz * E67) + (zz * zz) * high);
#else
    const vm_real E01 = VM_C(0.500000001824) + z * VM_C(0.166666664398);
    const vm_real E23 = VM_C(0.0416664198173) + z * VM_C(0.00833340486371);
    const vm_real E45 = VM_C(0.00139382863335) + z * VM_C(1.98219343782e-4);
    return E01 + zz * (E23 + zz * E45); /* this form avoids z^4, which could be subnormal and slow */
#endif
}

/* Returns e^x if e^x is a normal number. Method: x is written as k ln 2 + z with a whole k, so that e^x = 2^k
   (1 + z + z^2 E(z)), where E is vmi_ateb_exp_series. */
VM_INLINE vm_real vmi_ateb_exp(vm_real x)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360), to_integer = VM_C(1.5) / VM_EPSILON;
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const vm_real shifted = vmi_rounded(x * one_over_ln2 + to_integer), k = vmi_rounded(shifted - to_integer);
    const vm_real z = (x - k * ln2_hi) - k * ln2_lo;
    const vm_real scale = vmi_from_bits((vmi_to_bits(shifted) + VMI_BIAS) << VMI_STORED_DIG);
    return scale + scale * (z + z * z * vmi_ateb_exp_series(z));
}

/* Computes the logarithm to the base 2 of (2^k (1 + t)/(1 - t))^n as a sum *whole + *rest, for |t| < 0.18. *whole is
   n k, without the last digits of n, and has no rounding error. *rest has an error of at most 2 ulp. */
VM_INLINE void vmi_ateb_log2_of_power(vm_real n, vm_real k, vm_real t, vm_real *whole, vm_real *rest)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360), n_head = vmi_head(n);
    const vm_real slope = n * (t * one_over_ln2), x = t * t;
    *whole = n_head * k;
    *rest = (2 * slope + (n - n_head) * k) + (slope * x) * vmi_ateb_ln_series(x);
}

/* The least logarithm to the base 2 for which vmi_ateb_exp2 gives a normal number */
#define VMI_LEAST_LOG2 ((vm_real)(3 - VMI_BIAS))

/* Returns 2^(whole + rest) if the sum is at least VMI_LEAST_LOG2. Method: whole + rest = k + z/ln 2 with an integer k
   and |z| < 0.36, so that the result is 2^k (1 + z + z^2 E(z)), where E is vmi_ateb_exp_series. */
VM_INLINE vm_real vmi_ateb_exp2(vm_real whole, vm_real rest)
{
    const vm_real ln2 = VM_C(0.69314718055994530942), to_integer = VM_C(1.5) / VM_EPSILON;
    const vm_real shifted = vmi_rounded(whole + rest + to_integer), k = vmi_rounded(shifted - to_integer);
    const vm_real z = ((whole - k) + rest) * ln2;
    const vm_real scale = vmi_from_bits((vmi_to_bits(shifted) + VMI_BIAS) << VMI_STORED_DIG);
    return scale + scale * (z + z * z * vmi_ateb_exp_series(z));
}

#endif
