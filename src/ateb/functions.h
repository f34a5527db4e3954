/* ateb/functions.h - the Ateb functions sa and ca for any real argument and any alpha >= 0

   v = sa(1, alpha, s) and u = ca(alpha, 1, s) solve v' = u|u|^(alpha-1), u' = -2 v/(alpha + 1) with v(0) = 0 and
   u(0) = 1: equations (275), (276). They have the period 2 Pi_alpha (ateb/period.h) and describe the motion of the
   oscillator with the restoring force x|x|^(alpha-1). For many arguments and one alpha prepare a plan (ateb/plans.h).

       vm_real sa, ca;
       ateb_saca(VM_C(0.7), VM_C(1.5), &sa, &ca);

   Method: s is reduced to the first quarter of the period, where an incomplete beta function is inverted
   (ateb/inversion.h). r is the distance of s from the nearest zero of sa, and d the distance from the nearest zero of
   ca, so that r + d = Pi_alpha/2. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_FUNCTIONS_H
#define VARMASS_ATEB_FUNCTIONS_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "inversion.h"
#include "period.h"

/* The position of s in the period. s is `quarter` quarters of the period plus rest, where whole periods (4 quarters)
   are not counted. r and d are the distances of s from the nearest zeros of sa and ca. */
typedef struct VM_TAG(vmi_ateb_place) {
    vm_real rest, r, d;
    int quarter;
} vmi_ateb_place;

/* If s minus the nearest multiple of the quarter period is less than this number times s, the quarter period is needed
   in three words. */
#define VMI_ATEB_FINE_REACH (VM_MANT_DIG > 24 ? VM_C(6e-14) : VM_C(1.5e-5))

/* Returns s minus a multiple of the quarter period Q, which is given in three words. `rest` is the same difference,
   computed with two words. A division alone does not find the right multiple if it is larger than 1/(1000 eps);
   therefore it is corrected so that the result agrees with `rest`. */
VM_API vm_real vmi_ateb_rest_in_three_words(vm_real s, vmi_three Q, vm_real rest)
{
    const vm_real count = VM_FLOOR(s / Q.hi + VM_C(0.5));
    const vm_two high = vmi_two_product(count, Q.hi), mid = vmi_two_product(count, Q.mid);
    vm_real fine, further;
    if (!(count * VM_EPSILON < 1)) return rest; /* the digits of s do not determine the phase */
    fine = (((s - high.hi) - high.lo) - mid.hi) - (mid.lo + count * Q.lo);
    further = VM_FLOOR((fine - rest) / Q.hi + VM_C(0.5));
    return (fine - further * Q.hi) - further * Q.mid;
}

/* Returns s > 0 minus the nearest multiple of the quarter period, for an s that is large, or close to a zero of sa or
   ca. c->quarter becomes a sum of two words with a relative error below 2^-98.6 (float 2^-40.6). If the result is so
   small that this error would matter, the quarter period is used in three words. */
VM_API vm_real vmi_ateb_reduce_finely(vm_real s, vmi_ateb *c, int *quarter)
{
    vm_real rest;
    c->quarter = vmi_ateb_fine_quarter(c);
    rest = vmi_reduce(s, c->quarter, quarter).hi;
    if (!(VM_FABS(rest) < VMI_ATEB_FINE_REACH * s)) return rest;
    return vmi_ateb_rest_in_three_words(s, vmi_ateb_quarter_in_words(c), rest);
}

/* Returns a for the weight 1 and b for the weight 0. A condition would become a branch, and the processor would
   mispredict it half the time. */
VM_API vm_real vmi_choose(vm_real weight, vm_real a, vm_real b) { return weight * a + (1 - weight) * b; }

/* Returns the position of s >= 0 in the period, by the first of three methods that is accurate enough.
     1. An s <= (alpha + 1)/2 lies in the first quarter. Then r = s, which is known without Pi_alpha.
     2. For s <= 128 (alpha + 1), c->quarter is accurate enough, unless s is close to a zero of sa or ca. The high word
        of c->quarter is split into halves, whose products with the number of quarters are exact. The number of quarters
        is computed from the high word of c->quarter alone, so that the rest may be a little longer than half a quarter.
     3. Any other s is reduced by vmi_ateb_reduce_finely. */
VM_INLINE vmi_ateb_place vmi_ateb_locate(vm_real s, vmi_ateb *c)
{
    const vm_real n = c->n.hi, to_integer = VM_C(1.5) / VM_EPSILON;
    vmi_ateb_place at;
    vm_real size, other, odd;
    int is_coarse = s / 128 <= n;
    at.quarter = 0;
    at.rest = 0;
    if (s <= n / 2) {
        at.rest = s;
        at.r = s;
        at.d = (c->quarter.hi - s) + c->quarter.lo;
        return at;
    }
    if (is_coarse) { /* the last bits of the rounded quotient are the number of quarters */
        const vm_real high = vmi_head(c->quarter.hi), low = c->quarter.hi - high;
        const vm_real shifted = vmi_rounded(s / c->quarter.hi + to_integer);
        const vm_real count = vmi_rounded(shifted - to_integer);
        at.quarter = (int)(vmi_to_bits(shifted) & 3);
        at.rest = ((s - count * high) - count * low) - count * c->quarter.lo;
        is_coarse = VM_FABS(at.rest) * n * 1024 >= s;
    }
    if (!is_coarse) at.rest = vmi_ateb_reduce_finely(s, c, &at.quarter);
    odd = (vm_real)(at.quarter & 1);
    size = VM_FABS(at.rest);
    other = (c->quarter.hi - size) + c->quarter.lo;
    at.r = vmi_choose(odd, other, size);
    at.d = vmi_choose(odd, size, other);
    return at;
}

/* Gives *sa and *ca the signs of sa and ca at s. Before the call, *sa and *ca are the values in the first quarter. |s|
   is `quarter` quarters plus rest. The function works on the bits of the signs, without a branch. */
VM_INLINE void vmi_ateb_signs(vm_real s, vm_real rest, vmi_bits quarter, vm_real *sa, vm_real *ca)
{
    const int last = 8 * (int)sizeof(vm_real) - 1;
    const vmi_bits sign = (vmi_bits)1 << last, odd = quarter & 1;
    const vmi_bits half = quarter >> 1 << last, rest_bits = vmi_to_bits(rest);
    *sa = vmi_from_bits(vmi_to_bits(*sa) ^ half ^ ((vmi_to_bits(s) ^ (rest_bits & (odd - 1))) & sign));
    *ca = vmi_from_bits(vmi_to_bits(*ca) ^ half ^ (~rest_bits & (odd << last)));
}

/* sa(1, alpha, s) and ca(alpha, 1, s), the Ateb sine and cosine. s is any real number and alpha >= 0; both are pure
   numbers. |sa| <= 1 and |ca| <= 1. sa is odd in s and ca is even, to the last bit. The errors are at most 4 VM_EPSILON
   for |s| <= 1e9 (float 1e4), and at most 8 ulp for |s| <= 100 Pi_alpha, also next to the zeros of sa and ca. The
   results are NaN for alpha < 0 and for NaN and infinite arguments. docs/cost.md has the time of a call. Equations
   (275), (276). */
VM_API void ateb_saca(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca)
{
    vmi_ateb c;
    vmi_ateb_place at;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(s)) {
        *sa = VM_NAN;
        *ca = VM_NAN;
        return;
    }
    vmi_ateb_index_constants(&c, alpha);
    at.quarter = 0;
    at.rest = VM_FABS(s);
    at.r = at.rest;
    at.d = 0;
    if (at.r > VMI_ATEB_CHANGE_OVER) {
        vmi_ateb_period_constants(&c);
        at = vmi_ateb_locate(at.r, &c);
    }
    if (at.r <= VMI_ATEB_CHANGE_OVER) vmi_ateb_near_sa_zero(at.r, c.q.hi, sa, ca);
    else vmi_ateb_near_ca_zero(at.r, at.d, &c, sa, ca);
    vmi_ateb_signs(s, at.rest, (vmi_bits)at.quarter, sa, ca);
}

/* sa(1, alpha, s), the Ateb sine, alone.
   Domain and accuracy are those of ateb_saca, which computes both functions in the same time. */
VM_API vm_real ateb_sa(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return sa;
}

/* ca(alpha, 1, s), the Ateb cosine, alone.
   Domain and accuracy are those of ateb_saca, which computes both functions in the same time. */
VM_API vm_real ateb_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return ca;
}

#endif
