/* jacobi/reduction.h - reduces the argument of an elliptic function by its quarter period

   The argument is written as u = j K + v, where K is the quarter period, j a whole number and |v| at most K/2 apart
   from rounding. v needs a small relative error, because next to a zero of sn the value of sn is nearly v or -v. The
   closer u is to a multiple of K, the more digits of K are needed. Therefore K is used in four forms: from a table (for
   m between -1.25 and 0.97), in one word with corrections, in two words, or in three words. A word is one vm_real.

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_REDUCTION_H
#define VARMASS_JACOBI_REDUCTION_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"
#include "integrals.h"
#include "period_table.h"
#include "theta.h"

/* The limit 2^30 (float 2^13). The product of a piece of K (see vmi_pieces) and a whole number below this limit is
   exact. */
#define VMI_EXACT_QUARTERS (VM_MANT_DIG > 24 ? VM_C(1073741824.0) : VM_C(8192.0))

/* The number of parts of K that vmi_pieces writes into an array */
enum { VMI_PIECES = 5 };

/* Writes K to the array `piece` as a sum of five numbers. The first three are called the pieces. They have few digits:
   they are multiples of 2^(e-21), 2^(e-44) and 2^(e-67) (float 2^(e-9), 2^(e-20) and 2^(e-31)), where
   2^e <= K < 2^(e+1). Their products with a whole number below VMI_EXACT_QUARTERS are therefore exact. The last two
   numbers are the first two words of the rest. */
VM_API void vmi_pieces(vmi_three K, vm_real *piece)
{
    const vmi_bits exponent = vmi_to_bits(K.hi) & ~(((vmi_bits)1 << VMI_STORED_DIG) - 1);
    vm_real large = 3 * VMI_EXACT_QUARTERS * vmi_from_bits(exponent);
    int i;
    for (i = 0; i < 3; i++) {
        const vm_real sum = vmi_rounded(K.hi + large);
        piece[i] = sum - large;
        K = vmi_three_plus(K, vmi_three_words(-piece[i], 0, 0));
        large *= VMI_EXACT_QUARTERS * VM_EPSILON / 2;
    }
    piece[3] = K.hi;
    piece[4] = K.mid;
}

/* The function vmi_reduce_pieces is not accurate enough where the distance of u from the nearest multiple of K is below
   this number times u. */
#define VMI_PIECES_REACH (VM_MANT_DIG > 24 ? VM_C(5.4e-20) : VM_C(4.7e-10))

/* Returns u minus the nearest multiple j K, as three terms, for 0 <= u < VMI_EXACT_QUARTERS K. The array K comes from
   vmi_pieces, and per_K is 1/K. *quarters becomes a number whose last two bits are j modulo 4. The product of j and
   K[3] is rounded, and K[4] is not used: the error is therefore u eps^2/1000 or less. Where the result is below
   VMI_PIECES_REACH times u, it is not accurate enough, and vmi_reduce_finely must be used instead. Loops over this
   function can be vectorised. */
VM_INLINE vmi_three vmi_reduce_pieces(vm_real u, const vm_real *K, vm_real per_K, vmi_bits *quarters)
{
    const vm_real shifted = vmi_rounded(u * per_K + 1 / VM_EPSILON), j = shifted - 1 / VM_EPSILON;
    vmi_three rest;
    rest.hi = (u - j * K[0]) - j * K[1]; /* exact: a multiple of eps 2^e/2, at most about 2^e (see vmi_pieces) */
    rest.mid = -j * K[2];
    rest.lo = -j * K[3];
    *quarters = vmi_to_bits(shifted); /* the last bits of `shifted` are those of j */
    return rest;
}

/* Returns u minus the nearest multiple j K in two words. The arguments are those of vmi_reduce_pieces, but all elements
   of the array K are used. The distance of u from j K must be less than 1e-9 u (float 8e-6 u): then the products and
   differences with the three pieces are exact. The relative error is below eps for every result above 2^-90 u
   (float 2^-44 u). */
VM_API vm_two vmi_reduce_finely(vm_real u, const vm_real *K, vm_real per_K, vmi_bits *quarters)
{
    const vmi_three rest = vmi_reduce_pieces(u, K, per_K, quarters);
    const vm_real j = VM_FLOOR(u * per_K + VM_C(0.5));
    const vm_two product = vmi_two_product(j, K[3]), sum = vmi_two_sum(rest.hi + rest.mid, -product.hi);
    return vmi_two_sum(sum.hi, sum.lo - (product.lo + j * K[4]));
}

/* Rounds a number below 6 to a multiple of 2^-23 (float 2^-8): if this constant is added to the number and then
   subtracted again, the sum is rounded to such a multiple. */
#define VMI_REDUCTION_GRID (VM_MANT_DIG > 24 ? VM_C(805306368.0) : VM_C(49152.0))

/* Returns u minus the nearest multiple j K for u > 0, where VMI_MIDDLE(m1) must be 1; kp is k'. *quarters becomes a
   number whose last two bits are j modulo 4. The relative error of the result is at most about eps. The function
   returns NaN, and u must be reduced by vmi_reduce_long, in two cases: where u is 2.5 K or more, and where the result
   is below u/64 and would lose digits.
   Method: K (1 + f)^2 = 2 pi (1 + x S) with f^2 = k', where x S is small (vmi_K). The number u (1 + f)^2 is called the
   phase; a multiple of 2 pi (1 + x S) is subtracted from the phase, and the rest is divided by (1 + f)^2. The first
   halves (heads) of k' and f are multiples of 2^-23 and 2^-24 (float 2^-8 and 2^-9). Therefore the squares of these
   heads, the number (1 + f)^2 that is formed from the heads, and the product of this number and the head of u are
   exact. */
VMI_APART vm_real vmi_reduce_short(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vmi_bits *quarters)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real grid = VMI_REDUCTION_GRID, half_grid = grid / 2;
    const vm_real f = VM_SQRT(kp), kp_head = vmi_rounded(kp + grid) - grid;
    const vm_real f_head = vmi_rounded(f + half_grid) - half_grid;
    const vm_real kp_tail = ((m1 - kp_head * kp_head) + m1_lo) / (kp + kp_head);
    const vm_real f_tail = ((kp_head - f_head * f_head) + kp_tail) * (1 / (f + f_head));
    const vm_real rate_head = (1 + 2 * f_head) + kp_head, rate_tail = 2 * f_tail + kp_tail;
    const vm_real h = (1 - f) / (1 + f), x = vmi_fourth_power(h), S = vmi_K_series(x);
    const vm_real u_head = vmi_head(u), phase = u_head * rate_head;
    const vm_real phase_lo = (u - u_head) * rate_head + u * rate_tail;
    const int second = phase > 6 * half_pi.hi; /* 0 or 1; it replaces a branch, which would often be mispredicted */
    const vm_real j = (vm_real)(4 + 4 * second); /* 4 times the j above, since 2 pi is 4 times pi/2 */
    const vm_real rest = (phase - j * half_pi.hi) + ((phase_lo - j * half_pi.mid) - j * half_pi.hi * x * S);
    *quarters = 0;
    if (phase < 2 * half_pi.hi) return u;
    *quarters = (vmi_bits)(1 + second);
    if (!(VM_FABS(rest) * 64 > phase && phase < 10 * half_pi.hi)) return VM_NAN;
    return rest / (rate_head + rate_tail);
}

/* Returns u minus the nearest multiple j K in two words, for any u > 0 and m1 > 0. *quarters becomes a number whose
   last two bits are j modulo 4. K is used in two words, or in three if u is below 128 K and next to a multiple of K.
   From u = K/eps on, the digits of u do not determine the result; then the result is 0. */
VMI_APART vm_two vmi_reduce_long(vm_real u, vm_real m1, vm_real m1_lo, vmi_bits *quarters)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real next = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(8e-6);
    const vm_two rate = vmi_agm_two_words(m1, m1_lo, u);
    const vm_real size = u * rate.hi, count = size * VM_C(0.6366197723675813431);
    const vm_real shifted = vmi_rounded(count + 1 / VM_EPSILON);
    const vm_real j = shifted - 1 / VM_EPSILON;
    vm_two phase, whole, rest, error;
    vm_real v;
    *quarters = 0;
    if (!(count < 1 / VM_EPSILON)) return vmi_two(0, 0);
    *quarters = vmi_to_bits(shifted);
    phase = vmi_two_product(u, rate.hi);
    whole = vmi_two_product(j, half_pi.hi);
    rest = vmi_two_sum(phase.hi - whole.hi, (phase.lo - whole.lo) + (u * rate.lo - j * half_pi.mid));
    if (VM_FABS(rest.hi) > VM_C(0.501) * half_pi.hi) { /* for u > K/(1000 eps): rounding of `count` changed j */
        const vm_real further = VM_FLOOR(rest.hi / half_pi.hi + VM_C(0.5));
        rest = vmi_two_sum(rest.hi - further * half_pi.hi, rest.lo - further * half_pi.mid);
        *quarters += (vmi_bits)(further + 4);
    }
    if (VM_FABS(rest.hi) < size * next && count < 128) {
        vm_real K[VMI_PIECES];
        vmi_pieces(vmi_K_three_words(m1, m1_lo), K);
        return vmi_reduce_finely(u, K, rate.hi / half_pi.hi, quarters);
    }
    v = rest.hi / rate.hi;
    if (VMI_MIDDLE(m1)) return vmi_two(v, 0); /* here |v| < 2, and an error of 1.5 ulp of v is small enough */
    error = vmi_two_product(v, rate.hi);
    return vmi_fast_two_sum(v, (((rest.hi - error.hi) - error.lo) + (rest.lo - v * rate.lo)) / rate.hi);
}

/* The limit of the arguments that vmi_reduce_by_table reduces. Below this limit j is less than 2^20 (float 8700), since
   K is above 1.26. */
#define VMI_TABLE_REACH (VM_MANT_DIG > 24 ? VM_C(1048576.0) : VM_C(11000.0))

/* Returns u minus the nearest multiple j K, for 0 <= u < VMI_TABLE_REACH and for a k' = kp for which
   VMI_IN_PERIOD_TABLE is 1. *quarters becomes a number whose last two bits are j modulo 4. K has a relative error below
   2^-71 (float 2^-36), so that the result is within half an ulp plus 2^-71 u (float 2^-36 u) of the exact difference.
   Next to a multiple of K this error is too large: for j < 128 the result is then NaN, and u must be reduced by
   vmi_reduce_long. For j >= 128 the result is never NaN, since for such j only the absolute error of the result is
   important. */
VMI_APART vm_real vmi_reduce_by_table(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vmi_bits *quarters)
{
    const vm_real closest = VM_MANT_DIG > 24 ? VM_C(1048576.0) : VM_C(1024.0);
    const vmi_period K = vmi_period_by_table(m1, m1_lo, kp);
    vm_real divisor = K.rough, shifted, j, rest;
    if (u < VM_C(2.5) * K.early) divisor = K.early; /* K.early is known sooner than K.rough */
    shifted = vmi_rounded(u / divisor + 1 / VM_EPSILON);
    j = shifted - 1 / VM_EPSILON;
    rest = ((u - j * K.head) - j * K.middle) - j * K.low; /* only the last product and difference round */
    *quarters = vmi_to_bits(shifted); /* the last bits of `shifted` are those of j */
    if (j < 128 && VM_FABS(rest) * closest < u) return VM_NAN;
    return rest;
}

/* Returns u >= 0 minus the nearest multiple j K, or NaN if u or m1 is outside the domain of jacobi_sncndn. For m = 1,
   where there is no period, the result is the smaller of u and VMI_LONGEST. *v_lo becomes the low word of the result,
   and *quarters a number whose last two bits are j modulo 4. kp is k'. The argument reach must be about (2u/K)^2, as
   vmi_thetas_of computes it: for reach < 30, u is below 3 K, and vmi_reduce_short is tried. */
VM_INLINE vm_real vmi_reduced(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vm_real reach, vm_real *v_lo,
                              vmi_bits *quarters)
{
    *v_lo = 0;
    if (VMI_IN_PERIOD_TABLE(kp) && u < VMI_TABLE_REACH) {
        const vm_real v = vmi_reduce_by_table(u, m1, m1_lo, kp, quarters);
        if (v == v) return v;
    } else if (reach < 30 && VMI_MIDDLE(m1)) {
        const vm_real v = vmi_reduce_short(u, m1, m1_lo, kp, quarters);
        if (v == v) return v;
    }
    *quarters = 0;
    if (m1 > 0 && VM_IS_FINITE(m1) && VM_IS_FINITE(u)) {
        const vm_two v = vmi_reduce_long(u, m1, m1_lo, quarters);
        *v_lo = v.lo;
        return v.hi;
    }
    if (m1 != 0) return VM_NAN;
    if (u > VMI_LONGEST) return VMI_LONGEST;
    return u;
}

#endif
