/* jacobi/reduction.h - the argument of an elliptic function as a fraction of the quarter period */
#ifndef VARMASS_JACOBI_REDUCTION_H
#define VARMASS_JACOBI_REDUCTION_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"
#include "integrals.h"
#include "theta.h"

#define VMI_EXACT_QUARTERS (VM_MANT_DIG > 24 ? VM_C(1073741824.0) : VM_C(8192.0)) /* 2^30, 2^13 */

/* K as three pieces so short that a product with j < VMI_EXACT_QUARTERS is exact, and a last word: multiples of
   2^(e-21), 2^(e-44), 2^(e-67) where 2^e <= K < 2^(e+1) (float 2^(e-9), 2^(e-20), 2^(e-31)) */
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
}

VM_INLINE vm_two vmi_two_terms(vmi_three x)
{
    const vm_two sum = vmi_two_sum(x.hi, x.mid);
    return vmi_two_sum(sum.hi, sum.lo + x.lo);
}

/* u less the next multiple of K in pieces, as three terms, for 0 <= u < VMI_EXACT_QUARTERS K and per_K = 1/K, and
   which multiple it is; so that loops over it vectorise */
VM_INLINE vmi_three vmi_reduce_pieces(vm_real u, const vm_real *K, vm_real per_K, vmi_bits *quarters)
{
    const vm_real shifted = vmi_rounded(u * per_K + 1 / VM_EPSILON), j = shifted - 1 / VM_EPSILON;
    vmi_three rest;
    rest.hi = (u - j * K[0]) - j * K[1]; /* exact: a multiple of 2^-p K, below K */
    rest.mid = -j * K[2];
    rest.lo = -j * K[3];
    *quarters = vmi_to_bits(shifted); /* its last bits count */
    return rest;
}

/* u less a multiple of K; which multiple, in the last bits of *quarters. For 0 < u < 2.5 K, VMI_MIDDLE, kp = k': two
   steps of the AGM reach (1 + f)^2/4 with f^2 = k' and the parameter x, so that u (1 + f)^2 has the quarter period
   2 pi (1 + x S); the series and its rounding errors are small. The heads of k' and f are multiples of 2^-23 and
   2^-24 (float 2^-8, 2^-9), so that their squares, (1 + f)^2 of them and its product with the head of u are exact.
   Within an eps of the result if that is no less than u/64, else NaN. */
VM_INLINE vm_real vmi_reduce_short(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vmi_bits *quarters)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real grid = VM_MANT_DIG > 24 ? VM_C(805306368.0) : VM_C(49152.0), half_grid = grid / 2;
    const vm_real f = VM_SQRT(kp), kp_head = vmi_rounded(kp + grid) - grid;
    const vm_real f_head = vmi_rounded(f + half_grid) - half_grid;
    const vm_real kp_tail = ((m1 - kp_head * kp_head) + m1_lo) / (kp + kp_head);
    const vm_real f_tail = ((kp_head - f_head * f_head) + kp_tail) * (1 / (f + f_head));
    const vm_real rate_head = (1 + 2 * f_head) + kp_head, rate_tail = 2 * f_tail + kp_tail;
    const vm_real h = (1 - f) / (1 + f), x = vmi_fourth_power(h), S = vmi_K_series(x);
    const vm_real u_head = vmi_head(u), phase = u_head * rate_head;
    const vm_real phase_lo = (u - u_head) * rate_head + u * rate_tail;
    const int second = phase > 6 * half_pi.hi; /* added, not branched on, which would be mispredicted */
    const vm_real j = (vm_real)(4 + 4 * second);
    const vm_real rest = (phase - j * half_pi.hi) + ((phase_lo - j * half_pi.mid) - j * half_pi.hi * x * S);
    *quarters = 0;
    if (phase < 2 * half_pi.hi) return u;
    *quarters = (vmi_bits)(1 + second);
    return VM_FABS(rest) * 64 > phase && phase < 10 * half_pi.hi ? rest / (rate_head + rate_tail) : VM_NAN;
}

/* The same in two words for any u > 0 and m1 > 0, by the period in two words, in three for less than 128 K and next
   to a multiple */
VM_API vm_two vmi_reduce_long(vm_real u, vm_real m1, vm_real m1_lo, vmi_bits *quarters)
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
    if (!(count < 1 / VM_EPSILON)) return vmi_two(0, 0); /* no phase is left */
    *quarters = vmi_to_bits(shifted);
    phase = vmi_two_product(u, rate.hi);
    whole = vmi_two_product(j, half_pi.hi);
    rest = vmi_two_sum(phase.hi - whole.hi, (phase.lo - whole.lo) + (u * rate.lo - j * half_pi.mid));
    if (VM_FABS(rest.hi) > VM_C(0.75) * half_pi.hi) { /* by count's rounding, from K/(16 eps) on */
        const vm_real side = VM_COPYSIGN((vm_real)1, rest.hi);
        rest = vmi_two_sum(rest.hi - side * half_pi.hi, rest.lo - side * half_pi.mid);
        *quarters += side < 0 ? (vmi_bits)3 : (vmi_bits)1;
    }
    if (VM_FABS(rest.hi) < size * next && count < 128) {
        vm_real K[4];
        vmi_pieces(vmi_K_three_words(m1, m1_lo), K);
        return vmi_two_terms(vmi_reduce_pieces(u, K, rate.hi / half_pi.hi, quarters));
    }
    v = rest.hi / rate.hi;
    if (VMI_MIDDLE(m1)) return vmi_two(v, 0); /* |v| < 2 there: the low word is not asked for */
    error = vmi_two_product(v, rate.hi);
    return vmi_fast_two_sum(v, (((rest.hi - error.hi) - error.lo) + (rest.lo - v * rate.lo)) / rate.hi);
}

/* The same for any u >= 0 and m, NaN where one is refused; reach < 30 for u < 2.5 K. The result's low word, if it has
   one, is *v_lo. */
VM_INLINE vm_real vmi_reduced(vm_real u, vm_real m1, vm_real m1_lo, vm_real reach, vm_real *v_lo,
                              vmi_bits *quarters)
{
    *v_lo = 0;
    if (reach < 30 && VMI_MIDDLE(m1)) {
        const vm_real v = vmi_reduce_short(u, m1, m1_lo, VM_SQRT(m1), quarters);
        if (v == v) return v;
    }
    *quarters = 0;
    if (m1 > 0 && VM_IS_FINITE(m1) && VM_IS_FINITE(u)) {
        const vm_two v = vmi_reduce_long(u, m1, m1_lo, quarters);
        *v_lo = v.lo;
        return v.hi;
    }
    return m1 != 0 ? VM_NAN : u > VMI_LONGEST ? VMI_LONGEST : u;
}

#endif
