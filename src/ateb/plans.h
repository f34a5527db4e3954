/* ateb/plans.h - sa and ca for many arguments and one alpha

   A plan contains all numbers that depend only on alpha: Pi_alpha/2 and polynomials for two parts of a quarter of the
   period. A call with a plan is faster, most of all for arrays, where the compiler vectorises the loop (docs/cost.md
   has the times). A plan of less accuracy has shorter polynomials and is quicker. A plan is plain data: it may be
   copied, and it may be a constant in flash.

       ateb_plan p;
       vm_real sa, ca;
       if (ateb_plan_init(&p, VM_C(1.5)) == 0) ateb_plan_saca(&p, VM_C(0.7), &sa, &ca);

   Method: let r and d be the distances of s from the nearest zeros of sa and ca, and q = 1/(alpha + 1). A and C are
   polynomials. Up to a certain r, the field change_over,
     sa = r (1 + tau A(tau)) and ca = 1 + tau C(tau), where tau = r^2;
   for larger r, with two other polynomials,
     ca = 2 q d (1 + tau A(tau)) and sa = 1 + tau C(tau), where tau is X = (2 q d)^(alpha+1) up to a factor.
   The polynomials are Taylor series that follow from the differential equations (275). The series are economised: their
   last terms are removed by Chebyshev polynomials. For alpha = 0, 1/2, 1, ..., 7, tau is d d^alpha and is computed by
   products and a square root; for any other alpha, tau is X and is computed by an exponential. Source: Lanczos, Applied
   Analysis (1956). Tests: tests/test_ateb.c, tests/test_plans.sh. Example: examples/print_plan.c. */
#ifndef VARMASS_ATEB_PLANS_H
#define VARMASS_ATEB_PLANS_H

#include "../base/arrays.h"
#include "../base/bits.h"
#include "../base/chebyshev.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "functions.h"
#include "inversion.h"
#include "period.h"
#include "powers.h"

/* The largest number of terms of a plan's polynomials */
#if VM_MANT_DIG > 24
#define ATEB_PLAN_LENGTH 14
#else
#define ATEB_PLAN_LENGTH 8
#endif

/* The polynomials of one part of a quarter. `odd` contains A, for the function that has its zero in this part. `even`
   contains C, for the other function. The comment at the top of this file defines A and C. The constant terms come
   first; coefficients that are not used are 0. */
typedef struct VM_TAG(vmi_ateb_part) {
    vm_real odd[ATEB_PLAN_LENGTH], even[ATEB_PLAN_LENGTH];
} vmi_ateb_part;

/* The numbers from which sa and ca are computed for one alpha. ateb_plan_init writes them. All fields are pure
   numbers. */
typedef struct VM_TAG(ateb_plan) {
    vm_two quarter;           /* Pi_alpha/2 */
#if VM_MANT_DIG > 24
    vm_real quarter_low; /* Pi_alpha/2 minus its two words in `quarter`; a float plan lacks this field */
#endif
    vm_real quarter_parts[3]; /* three numbers with the sum `quarter`; the first two have at most half of the digits */
    vm_real per_quarter;      /* 2/Pi_alpha */
    vm_real longest;          /* for |s| < longest, the number of quarters times quarter_parts[0] or [1] is exact */
    vm_real change_over;      /* part[0] is used up to this distance r from a zero of sa */
    vm_real n, g;             /* alpha + 1 and Pi_alpha - (alpha + 1) */
    vm_two twice_q;           /* 2/(alpha + 1) */
    int length;               /* number of terms of the polynomials, an even number */
    int twice_alpha;          /* 2 alpha where tau is computed by products, -1 where it is an exponential */
    vmi_ateb_part part[2];    /* polynomials for r up to the change-over, and for larger r */
} ateb_plan;

/* Returns d^(1 + alpha) from d + d_lo, where alpha = twice_alpha/2 and twice_alpha = 0 ... 14. Each bit of twice_alpha
   stands for a factor: 1 for sqrt(d), 2 for d, 4 for d^2, and 8 for d^4. */
VM_INLINE vm_real vmi_ateb_product(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    const vm_real d2 = d * d;
    vm_real low = 1, high = 1, power;
    if (p->twice_alpha & 1) low = VM_SQRT(d);
    if (p->twice_alpha & 2) low *= d;
    if (p->twice_alpha & 4) high = d2;
    if (p->twice_alpha & 8) high *= d2 * d2;
    power = low * high;
    return power * d + power * (p->n * d_lo);
}

/* Returns 2 q d = 2 d/(alpha + 1) in two words, from d + d_lo. */
VM_INLINE vm_two vmi_ateb_twice_q_d(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    return vmi_two(p->twice_q.hi * d, p->twice_q.lo * d + p->twice_q.hi * d_lo);
}

/* Returns X = (2 q d)^(alpha+1), where q = 1/(alpha+1). r and d, each in two words, are the distances of s from the
   zeros of sa and ca; 2 q d is computed as in vmi_ateb_base_of and is written to *y. Where X would be subnormal, the
   result is about the smallest normal number instead. */
VM_INLINE vm_real vmi_ateb_exponential(const ateb_plan *p, vm_two r, vm_two d, vm_two *y)
{
    const vm_real z = (2 * r.hi - p->g) + 2 * r.lo;
    const vmi_ateb_base base = vmi_ateb_base_of(p->twice_q, r.hi, z, d.hi, d.lo);
    vm_real whole, rest;
    vmi_ateb_log2_of_power(p->n, base.k, base.t, &whole, &rest);
    *y = base.y;
    if (!(whole + rest > VMI_LEAST_LOG2)) return vmi_ateb_exp2(VMI_LEAST_LOG2, 0);
    return vmi_ateb_exp2(whole, rest);
}

/* Returns the polynomial c[0] + c[1] x + c[2] x^2 + c[3] x^3, where xx = x^2. */
VM_INLINE vm_real vmi_ateb_four_terms(const vm_real *c, vm_real x, vm_real xx)
{
    return (c[0] + x * c[1]) + xx * (c[2] + x * c[3]);
}

/* Returns the terms c[1] x + c[2] x^2 + ... of a polynomial, computed with at least `length` - 1 terms. The
   coefficients beyond `length` are 0. The terms are grouped by four, so that the processor can compute the groups at
   the same time. The constant c[0], which is larger than all terms, is left to the caller: it is added last, because
   a sum that contains it has a rounding error as large as half an ulp of the result. */
VM_INLINE vm_real vmi_ateb_part_terms(const vm_real *c, int length, vm_real x)
{
    const vm_real xx = x * x, x4 = xx * xx;
    vm_real more;
    if (length <= 5) return x * vmi_ateb_four_terms(c + 1, x, xx);
    more = (c[5] + x * c[6]) + xx * c[7];
#if ATEB_PLAN_LENGTH > 8
    if (length > 8) more = vmi_ateb_four_terms(c + 5, x, xx) + x4 * (vmi_ateb_four_terms(c + 9, x, xx) + x4 * c[13]);
#endif
    return x * (vmi_ateb_four_terms(c + 1, x, xx) + x4 * more);
}

/* Computes *odd = base (1 + tau A(tau)) and *even = 1 + tau C(tau), where A and C are the polynomials part->odd and
   part->even, and base is r or 2 q d. The two largest terms of *even are 1 and tau c, where c is the constant of C.
   What rounding takes from their sum is added again. */
VM_INLINE void vmi_ateb_part_at(const vmi_ateb_part *part, int length, vm_two base, vm_real tau, vm_real *odd,
                                vm_real *even)
{
    const vm_real first = tau * part->even[0], sum = vmi_rounded(1 + first), lost = (1 - sum) + first;
    const vm_real A = part->odd[0] + vmi_ateb_part_terms(part->odd, length, tau);
    *odd = base.hi + (base.lo + (base.hi * tau) * A);
    *even = sum + (lost + tau * vmi_ateb_part_terms(part->even, length, tau));
}

/* Returns |s| minus the nearest multiple of Pi_alpha/2 in two words, for |s| < p->longest, which is 2^26 quarters
   (float 2^12). *quarter becomes a number whose last two bits are the number of quarters modulo 4. The first difference
   is exact; the low word is what rounding takes from the other two. */
VM_INLINE vm_two vmi_ateb_plan_reduce(const ateb_plan *p, vm_real s, vmi_bits *quarter)
{
    const vm_real x = VM_FABS(s), to_integer = VM_C(1.5) / VM_EPSILON;
    const vm_real shifted = vmi_rounded(x * p->per_quarter + to_integer), count = vmi_rounded(shifted - to_integer);
    const vm_real second = count * p->quarter_parts[1], third = count * p->quarter_parts[2];
    const vm_real after_first = x - count * p->quarter_parts[0];
    const vm_real after_second = vmi_rounded(after_first - second), rest = vmi_rounded(after_second - third);
    *quarter = vmi_to_bits(shifted);
    return vmi_two(rest, ((after_first - after_second) - second) + ((after_second - rest) - third));
}

/* `rest` is s minus the nearest multiple of Pi_alpha/2, computed with Pi_alpha/2 in two words. Returns 1 if this `rest`
   is so small that it must be computed again with a third word of Pi_alpha/2, else 0. A plan in float has no third
   word: then the result is always 0. */
VM_INLINE int vmi_ateb_plan_is_close(vm_real rest, vm_real s)
{
    return VM_MANT_DIG > 24 && VM_FABS(rest) < VMI_ATEB_FINE_REACH * VM_FABS(s);
}

/* Returns x minus the nearest multiple of Pi_alpha/2, for an x > 0 that is close to a multiple (see
   vmi_ateb_plan_is_close). `rest` is this difference, computed with two words of Pi_alpha/2. In double the result is
   computed with three words; in float it is `rest`. */
VM_API vm_real vmi_ateb_plan_reduce_finely(const ateb_plan *p, vm_real x, vm_real rest)
{
#if VM_MANT_DIG > 24
    const vmi_three quarter = {p->quarter.hi, p->quarter.lo, p->quarter_low};
    return vmi_ateb_rest_in_three_words(x, quarter, rest);
#else
    (void)p;
    (void)x;
    return rest;
#endif
}

/* Returns |x|, without a branch. */
VM_INLINE vm_two vmi_ateb_absolute(vm_two x) { return vmi_two(VM_FABS(x.hi), VM_COPYSIGN(1, x.hi) * x.lo); }

/* Returns the distance of s from the zero at the other end of its quarter, in two words: Pi_alpha/2 minus the distance
   near_zero from the nearest zero. */
VM_INLINE vm_two vmi_ateb_plan_far_zero(const ateb_plan *p, vm_two near_zero)
{
    const vm_real far_zero = vmi_rounded((p->quarter.hi - near_zero.hi) + p->quarter.lo);
    return vmi_two(far_zero, ((p->quarter.hi - far_zero) - near_zero.hi) + (p->quarter.lo - near_zero.lo));
}

/* sa and ca of the argument s for the plan's alpha. s may be any number. For alpha up to 1e6 and |s| <= 100 Pi_alpha,
   the error of a plan of full accuracy is at most 2 ulp. In float, next to a zero of sa or ca, it is at most 2 ulp plus
   the change that an error of 2^-42 |s| in s makes. Any other plan has the accuracy that was given to
   ateb_plan_init_to. The results are NaN for infinite and NaN s. docs/cost.md has the time of a call. */
VM_API void ateb_plan_saca(const ateb_plan *p, vm_real s, vm_real *sa, vm_real *ca)
{
    vm_two rest, near_zero, far_zero, r, d; /* r and d are the distances of s from the zeros of sa and ca */
    vm_real v, u;
    vmi_bits quarter;
    if (VM_FABS(s) < p->longest) rest = vmi_ateb_plan_reduce(p, s, &quarter);
    else if (VM_IS_FINITE(s)) {
        int count;
        rest = vmi_reduce(VM_FABS(s), p->quarter, &count);
        quarter = (vmi_bits)count;
    } else {
        *sa = VM_NAN;
        *ca = VM_NAN;
        return;
    }
    if (vmi_ateb_plan_is_close(rest.hi, s))
        rest = vmi_two(vmi_ateb_plan_reduce_finely(p, VM_FABS(s), rest.hi), 0);
    near_zero = vmi_ateb_absolute(rest);
    far_zero = vmi_ateb_plan_far_zero(p, near_zero);
    r = far_zero;
    d = near_zero;
    if (!(quarter & 1)) {
        r = near_zero;
        d = far_zero;
    }
    if (r.hi <= p->change_over) vmi_ateb_part_at(p->part, p->length, r, r.hi * r.hi, &v, &u);
    else {
        vm_two base;
        vm_real tau;
        if (p->twice_alpha >= 0) {
            base = vmi_ateb_twice_q_d(p, d.hi, d.lo);
            tau = vmi_ateb_product(p, d.hi, d.lo);
        } else tau = vmi_ateb_exponential(p, r, d, &base);
        vmi_ateb_part_at(p->part + 1, p->length, base, tau, &u, &v);
    }
    vmi_ateb_signs(s, rest.hi, quarter, &v, &u);
    *sa = v;
    *ca = u;
}

/* Arrays are computed in blocks of VMI_ATEB_BLOCK arguments, by loops without branches, which compilers turn into
   vector instructions. VMI_ATEB_WIDE is 1 on processors with wide vector registers, else 0. With narrow vector
   registers such a loop takes longer than single calls. */
enum { VMI_ATEB_BLOCK = 32 };
#if defined(__AVX2__) || defined(__ARM_NEON) || defined(__ARM_FEATURE_SVE)
#define VMI_ATEB_WIDE 1
#else
#define VMI_ATEB_WIDE 0
#endif

/* Intermediate results for the arguments s of a block. `quarter` has the bits of the number of quarters, and `rest` is
   |s| minus the nearest multiple of the quarter period. r and d are the distances of s from the zeros of sa and ca,
   with the low words r_lo and d_lo. base, base_lo and tau are arguments of vmi_ateb_part_at. */
typedef struct VM_TAG(vmi_ateb_block) {
    vmi_bits quarter[VMI_ATEB_BLOCK];
    vm_real rest[VMI_ATEB_BLOCK];
    vm_real r[VMI_ATEB_BLOCK], r_lo[VMI_ATEB_BLOCK], d[VMI_ATEB_BLOCK], d_lo[VMI_ATEB_BLOCK];
    vm_real base[VMI_ATEB_BLOCK], base_lo[VMI_ATEB_BLOCK], tau[VMI_ATEB_BLOCK];
} vmi_ateb_block;

/* Fills the fields up to d_lo from the arguments, each with |s| < p->longest. */
VM_INLINE void vmi_ateb_block_places(const ateb_plan *p, const vm_real *s, vmi_ateb_block *at)
{
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        vmi_bits quarter;
        const vm_two rest = vmi_ateb_plan_reduce(p, s[i], &quarter), near_zero = vmi_ateb_absolute(rest);
        const vm_two far_zero = vmi_ateb_plan_far_zero(p, near_zero);
        const vmi_bits odd = 0 - (quarter & 1);
        at->quarter[i] = quarter;
        at->rest[i] = rest.hi;
        at->r[i] = vmi_select(odd, far_zero.hi, near_zero.hi);
        at->r_lo[i] = vmi_select(odd, far_zero.lo, near_zero.lo);
        at->d[i] = vmi_select(odd, near_zero.hi, far_zero.hi);
        at->d_lo[i] = vmi_select(odd, near_zero.lo, far_zero.lo);
    }
}

/* Sets base to 2 q d and tau to d^(1 + alpha), for alpha = 0, 1/2, ..., 7 (vmi_ateb_product). The factors of
   vmi_ateb_product that this alpha does not need are replaced by 1. */
VM_INLINE void vmi_ateb_block_products(const ateb_plan *p, vmi_ateb_block *at)
{
    const vm_real one = (vm_real)(p->twice_alpha >> 1 & 1), two = (vm_real)(p->twice_alpha >> 2 & 1);
    const vm_real four = (vm_real)(p->twice_alpha >> 3 & 1);
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) at->tau[i] = 1;
    if (p->twice_alpha & 1)
        for (i = 0; i < VMI_ATEB_BLOCK; i++) at->tau[i] = VM_SQRT(at->d[i]);
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        const vm_real d = at->d[i], d2 = d * d, low = at->tau[i] * (one * d + (1 - one));
        const vm_real power = low * ((two * d2 + (1 - two)) * (four * (d2 * d2) + (1 - four)));
        at->tau[i] = power * d + power * (p->n * at->d_lo[i]);
        at->base[i] = p->twice_q.hi * d;
        at->base_lo[i] = p->twice_q.lo * d + p->twice_q.hi * at->d_lo[i];
    }
}

/* Sets base to 2 q d and tau to X = (2 q d)^(alpha+1), for any other alpha below 1/VM_EPSILON. The steps are those of
   vmi_ateb_exponential; where that function branches, both results are computed and one is selected. */
VM_INLINE void vmi_ateb_block_exponentials(const ateb_plan *p, vmi_ateb_block *at)
{
    const vm_real sqrt_half = VM_C(0.70710678118654752);
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        const vm_real r = at->r[i], d = at->d[i], z = (2 * r - p->g) + 2 * at->r_lo[i];
        const vm_real qz = p->twice_q.hi * (z / 2), by_r = 1 - qz;
        const vm_two by_d = vmi_ateb_twice_q_times(p->twice_q, d, at->d_lo[i]);
        const vmi_bits is_near = vmi_mask_of_sign(r - d) & vmi_mask_of_sign(qz - VM_C(0.29));
        const vm_real scale = VM_C(1.5) - VM_COPYSIGN(VM_C(0.5), by_d.hi - sqrt_half);
        vm_real k, mantissa, numerator, denominator, whole, rest;
        vmi_bits is_normal;
        mantissa = vmi_ateb_mantissa(by_d.hi, &k);
        k = vmi_select(is_near, 0, k);
        numerator = vmi_select(is_near, -qz, (mantissa - 1) + scale * by_d.lo);
        denominator = vmi_select(is_near, 2 - qz, mantissa + 1);
        vmi_ateb_log2_of_power(p->n, k, numerator / denominator, &whole, &rest);
        is_normal = vmi_mask_of_sign(VMI_LEAST_LOG2 - (whole + rest));
        at->tau[i] = vmi_ateb_exp2(vmi_select(is_normal, whole, VMI_LEAST_LOG2), vmi_select(is_normal, rest, 0));
        at->base[i] = vmi_select(is_near, by_r, by_d.hi);
        at->base_lo[i] = vmi_select(is_near, (1 - by_r) - qz, by_d.lo);
    }
}

/* Computes sa and ca of a block whose fields are filled, with polynomials of `length` terms. `part` becomes the
   polynomials of the part of the quarter in which an argument lies. */
VM_INLINE void vmi_ateb_block_sums(const ateb_plan *p, int length, const vmi_ateb_block *at, const vm_real *s,
                                   vm_real *sa, vm_real *ca)
{
    const vmi_ateb_part *near_sa = p->part, *near_ca = p->part + 1; /* the parts with a zero of sa and of ca */
    const vm_real change_over = p->change_over;
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        const vm_real r = at->r[i];
        const vmi_bits beyond = vmi_mask_of_sign(change_over - r);
        const vm_real tau = vmi_select(beyond, at->tau[i], r * r);
        const vm_real base = vmi_select(beyond, at->base[i], r);
        const vm_real base_lo = vmi_select(beyond, at->base_lo[i], at->r_lo[i]);
        vmi_ateb_part part;
        vm_real odd, even, v, u;
        int j;
        VMI_UNROLL for (j = 0; j < length; j++) {
            part.odd[j] = vmi_select(beyond, near_ca->odd[j], near_sa->odd[j]);
            part.even[j] = vmi_select(beyond, near_ca->even[j], near_sa->even[j]);
        }
        vmi_ateb_part_at(&part, length, vmi_two(base, base_lo), tau, &odd, &even);
        v = vmi_select(beyond, even, odd);
        u = vmi_select(beyond, odd, even);
        vmi_ateb_signs(s[i], at->rest[i], at->quarter[i], &v, &u);
        sa[i] = v;
        ca[i] = u;
    }
}

/* Computes sa and ca of a block of arguments, each with |s| < p->longest. Each call of vmi_ateb_block_sums has a
   constant number of terms, so that compilers can vectorise its loop over the arguments. For the same numbers of terms
   vmi_ateb_part_terms has separate cases. Arguments next to a zero of sa or ca are computed once more, one by one. The
   function copies the plan, so that the compiler knows that writing the results does not change the plan. */
VM_API void vmi_ateb_block_saca(const ateb_plan *plan, const vm_real *s, vm_real *sa, vm_real *ca)
{
    const ateb_plan p = *plan;
    vmi_ateb_block at;
    int i, any_close = 0;
    vmi_ateb_block_places(&p, s, &at);
    if (p.twice_alpha >= 0) vmi_ateb_block_products(&p, &at);
    else vmi_ateb_block_exponentials(&p, &at);
    if (p.length > 8) vmi_ateb_block_sums(&p, ATEB_PLAN_LENGTH, &at, s, sa, ca);
    else if (p.length > 5) vmi_ateb_block_sums(&p, 8, &at, s, sa, ca);
    else vmi_ateb_block_sums(&p, 5, &at, s, sa, ca);
    for (i = 0; i < VMI_ATEB_BLOCK; i++) any_close |= vmi_ateb_plan_is_close(at.rest[i], s[i]);
    for (i = 0; any_close && i < VMI_ATEB_BLOCK; i++)
        if (vmi_ateb_plan_is_close(at.rest[i], s[i])) ateb_plan_saca(plan, s[i], sa + i, ca + i);
}

/* sa and ca of n arguments for the plan's alpha. The arrays s, sa and ca have n elements each. s may be the array sa or
   the array ca; otherwise the three arrays must not overlap. Domain and accuracy are those of ateb_plan_saca. Unless
   the compiler fuses products and sums, the results have the same bits as those of ateb_plan_saca. Arguments are
   computed in blocks of 32. Arguments with |s| >= p->longest, and those that are not finite, are computed one by one.
   Arrays are faster than single calls on processors with wide vector registers (docs/cost.md has the times). */
VM_API void ateb_plan_saca_array(const ateb_plan *p, int n, const vm_real *s, vm_real *sa, vm_real *ca)
{
    const int wide = VMI_ATEB_WIDE && p->quarter.hi < 1 / VM_EPSILON;
    vm_real x[VMI_ATEB_BLOCK], v[VMI_ATEB_BLOCK], u[VMI_ATEB_BLOCK];
    int i, j, count, any_outside;
    for (i = 0; !wide && i < n; i++) ateb_plan_saca(p, s[i], sa + i, ca + i);
    for (i = 0; wide && i < n; i += VMI_ATEB_BLOCK) {
        count = VMI_ATEB_BLOCK;
        if (n - i < VMI_ATEB_BLOCK) count = n - i;
        any_outside = 0;
        for (j = 0; j < VMI_ATEB_BLOCK; j++) x[j] = 0;
        for (j = 0; j < count; j++) {
            const int inside = VM_FABS(s[i + j]) < p->longest;
            x[j] = inside ? s[i + j] : 0;
            any_outside |= !inside;
        }
        vmi_ateb_block_saca(p, x, v, u);
        for (j = 0; any_outside && j < count; j++)
            if (!(VM_FABS(s[i + j]) < p->longest)) ateb_plan_saca(p, s[i + j], v + j, u + j);
        for (j = 0; j < count; j++) {
            sa[i + j] = v[j];
            ca[i + j] = u[j];
        }
    }
}

/* Returns the coefficient w_j of the power series w = b^alpha, where b is a power series with b_0 = 1. The function
   computes it from w_0 ... w_(j-1) and b_1 ... b_j by Euler's recurrence. */
VM_API vm_real vmi_ateb_series_power(vm_real alpha, int j, const vm_real *b, const vm_real *w)
{
    vm_real sum = 0;
    int i;
    for (i = 1; i <= j; i++) sum += (alpha * (vm_real)i - (vm_real)(j - i)) * b[i] * w[j - i];
    return sum / (vm_real)j;
}

/* The number of terms of the Taylor series from which the polynomials are made */
enum { VMI_ATEB_TERMS = VM_MANT_DIG > 24 ? 56 : 26 };

/* Computes Taylor coefficients, term by term from the differential equations (275). For beyond = 0, the array `odd`
   becomes the coefficients of sa/r, and `even` those of ca, in powers of r^2. For beyond = 1, `odd` becomes the
   coefficients of ca/(2 q d), and `even` those of sa, in powers of X = (2 q d)^(alpha+1). r and d are the distances
   from the nearest zeros of sa and ca, and q = 1/(alpha + 1). */
VM_API void vmi_ateb_series(int beyond, vm_real alpha, vm_real q, vm_real *odd, vm_real *even)
{
    const vm_real large = VM_C(1e30); /* a larger alpha counts as this one, since alpha j might overflow */
    vm_real *w = odd; /* series of ca^alpha, for beyond = 1 of (ca/(2 q d))^alpha; overwritten at the end */
    int j;
    if (beyond) w = even;
    if (alpha > large) {
        alpha = large;
        q = 1 / large;
    }
    odd[0] = 1;
    even[0] = 1;
    for (j = 1; j < VMI_ATEB_TERMS; j++) {
        const vm_real i = (vm_real)j;
        if (beyond) {
            odd[j] = -w[j - 1] / (2 * i) * (q / (q + i));
            w[j] = vmi_ateb_series_power(alpha, j, odd, w);
        } else {
            even[j] = -q * (w[j - 1] / (2 * i - 1)) / i;
            w[j] = vmi_ateb_series_power(alpha, j, even, w);
        }
    }
    for (j = VMI_ATEB_TERMS - 1; j > 0; j--) {
        if (beyond) even[j] = -w[j - 1] / (2 * (vm_real)j);
        else odd[j] = w[j] / (2 * (vm_real)j + 1);
    }
}

/* Economises the power series c_1 + c_2 x + c_3 x^2 + ... for 0 <= x <= limit: the function replaces it by a polynomial
   in x/unit with at most ATEB_PLAN_LENGTH terms, and returns the number of terms. `result` becomes the array of these
   coefficients times unit. The error of the polynomial is at most tolerance/limit if ATEB_PLAN_LENGTH terms are enough.
   The largest coefficient is computed as c_1 plus its change, so that it has no rounding errors from multiplying and
   dividing by limit. c is overwritten. */
VM_API int vmi_ateb_economise(vm_real *c, vm_real limit, vm_real unit, vm_real tolerance, vm_real *result)
{
    const int highest = VMI_ATEB_TERMS - 2;
    const vm_real largest = c[1];
    vm_real power = 1, height = vmi_ldexp(1, 1 - 2 * highest);
    int i, k;
    for (i = 0; i <= highest; i++) { /* now c is limit times the series, in powers of x/limit */
        power *= limit;
        c[i] = c[i + 1] * power;
    }
    for (k = highest; k > 0; k--) { /* removing c[k] adds an error |c[k]| height, where height = 2^(1-2k) */
        tolerance -= VM_FABS(c[k]) * height;
        if (tolerance < 0 && k < ATEB_PLAN_LENGTH) break;
        vmi_remove_highest(c, k, 0);
        height *= 4;
    }
    power = 1;
    for (i = 0; i < ATEB_PLAN_LENGTH; i++) {
        power *= unit / limit;
        result[i] = 0;
        if (i <= k) result[i] = c[i] * power;
    }
    result[0] = largest * unit + (c[0] - largest * limit) * (unit / limit);
    return k + 1;
}

/* Fills part 0 or 1 of the plan (the argument `beyond` chooses it) and returns the number of terms of its polynomials
   in tau. In part 0, tau = r^2, where r is the distance from a zero of sa, and unit is 1. In part 1, tau = X/unit,
   where X = (2 d/(alpha + 1))^(alpha+1) and d is the distance from a zero of ca. */
VM_API int vmi_ateb_part_init(vmi_ateb_part *part, int beyond, const ateb_plan *p, vm_real alpha, vm_real unit,
                              vm_real tolerance)
{
    vm_real odd[VMI_ATEB_TERMS], even[VMI_ATEB_TERMS], limit = p->change_over * p->change_over;
    int length, even_length;
    if (beyond) {
        vm_two y;
        limit = vmi_ateb_exponential(p, vmi_two(p->change_over, 0), vmi_two(p->quarter.hi - p->change_over, 0), &y);
    }
    vmi_ateb_series(beyond, alpha, p->twice_q.hi / 2, odd, even);
    length = vmi_ateb_economise(odd, limit, unit, tolerance, part->odd);
    even_length = vmi_ateb_economise(even, limit, unit, tolerance, part->even);
    if (even_length > length) length = even_length;
    return length;
}

/* Sets the fields that reduce s: the quarter period as a sum of parts, and `longest`. For |s| < longest, the products
   of the first two parts and the number of quarters are exact. */
VM_API void vmi_ateb_plan_period(ateb_plan *p, const vmi_ateb *c)
{
#if VM_MANT_DIG > 24
    const vmi_three quarter = vmi_ateb_quarter_in_words(c);
    p->quarter = vmi_two(quarter.hi, quarter.mid);
    p->quarter_low = quarter.lo;
#else
    p->quarter = c->quarter;
#endif
    p->quarter_parts[0] = vmi_head(p->quarter.hi);
    p->quarter_parts[1] = vmi_head(p->quarter.hi - p->quarter_parts[0]);
    p->quarter_parts[2] = ((p->quarter.hi - p->quarter_parts[0]) - p->quarter_parts[1]) + p->quarter.lo;
    p->per_quarter = 1 / p->quarter.hi;
    p->longest = p->quarter.hi * (vm_real)((1L << VM_MANT_DIG / 2) - 1);
}

/* Prepares a plan for alpha >= 0 and a given accuracy. `accuracy` is the largest absolute error of sa and ca that is
   allowed, such as 1e-4 or 1e-8; 0 means full accuracy. A plan of less accuracy has shorter polynomials and is quicker.
   Returns 0, or -1 if alpha < 0 or an argument is NaN or infinite; if it returns -1, the plan stays as it was. */
VM_API int ateb_plan_init_to(ateb_plan *p, vm_real alpha, vm_real accuracy)
{
    /* For r beyond the change-over, sa is computed from X = (2 q d)^(alpha+1). A relative rounding error of X causes an
       error of sa that is X/(2 sa) times as large. The factor X/(2 sa) is 0.33 for a change-over at r = 0.92; for a
       change-over at r = 0.73 it would be 0.5, and the error of sa would be 2.3 ulp. For a change-over beyond 0.92 the
       polynomials would have too few terms. */
    const vm_real share = VM_C(0.5), farthest = VM_MANT_DIG > 24 ? VM_C(0.92) : VM_C(0.95);
    vm_real tolerance = VM_EPSILON / 16, unit = 1;
    int length, length_beyond;
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(accuracy)) return -1;
    if (accuracy > VM_EPSILON) tolerance = accuracy / 2;
    vmi_ateb_fine_constants(&c, alpha);
    vmi_ateb_plan_period(p, &c);
    p->change_over = vmi_smaller(share * p->quarter.hi, farthest);
    p->n = c.n.hi;
    p->twice_q = vmi_two(2 * c.q.hi, 2 * c.q.lo);
    p->g = c.g.hi;
    p->twice_alpha = -1;
    if (alpha <= 7 && 2 * alpha == VM_FLOOR(2 * alpha)) {
        p->twice_alpha = (int)(2 * alpha);
        unit = vmi_pow_two(p->twice_q, c.n);
    }
    length = vmi_ateb_part_init(p->part, 0, p, alpha, 1, tolerance);
    length_beyond = vmi_ateb_part_init(p->part + 1, 1, p, alpha, unit, tolerance);
    if (length_beyond > length) length = length_beyond;
    p->length = (length + 1) / 2 * 2;
    return 0;
}

/* Prepares a plan of full accuracy for alpha >= 0.
   Returns 0, or -1 for alpha < 0, NaN and infinite alpha; if it returns -1, the plan stays as it was. */
VM_API int ateb_plan_init(ateb_plan *p, vm_real alpha) { return ateb_plan_init_to(p, alpha, 0); }

#endif
