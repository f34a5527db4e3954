/* ateb/plans.h - sa and ca for many arguments and one alpha */
#ifndef VARMASS_ATEB_PLANS_H
#define VARMASS_ATEB_PLANS_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "functions.h"
#include "inversion.h"
#include "period.h"
#include "powers.h"

/* One alpha prepared: plain data, that may lie in flash as static const (examples/ateb_plan.c prints it), on AVR as
   PROGMEM, of which memcpy_P makes a copy in RAM.
   ateb_plan_init returns 0, or -1 for alpha < 0, NaN or infinite, and then leaves the plan as it was. A plan for less
   accuracy, 1e-4 or 1e-8 of the largest value, is shorter and quicker; 0 means full. Arrays may overlap exactly. */
#if VM_MANT_DIG > 24
#define ATEB_PLAN_LENGTH 14
#else
#define ATEB_PLAN_LENGTH 8
#endif

typedef struct VM_TAG(vmi_ateb_part) {
    vm_real odd[ATEB_PLAN_LENGTH], even[ATEB_PLAN_LENGTH];
} vmi_ateb_part;

typedef struct VM_TAG(ateb_plan) {
    vm_two quarter;           /* Pi/2 */
    vm_real quarter_parts[3]; /* the same, two with half of the digits or less */
    vm_real per_quarter, longest, change_over, n, g;
    vm_two twice_q; /* 2/(alpha + 1) */
    int length, twice_alpha;
    vmi_ateb_part part[2];
} ateb_plan;

/* ---- One alpha prepared ---------------------------------------------------------------------------------------

   Two parts of a quarter. Up to the change-over, with tau = r^2,
     sa = r (1 + tau A(tau)),   ca = 1 + tau C(tau);
   beyond it, with tau = X = (2 q d)^(alpha+1) up to a factor,
     ca = 2 q d (1 + tau A(tau)), sa = 1 + tau C(tau).
   The polynomials are Taylor series from (275), economised: their last terms are taken off by Chebyshev
   polynomials. For alpha = 0, 1/2, 1, ..., 7 tau = d d^alpha is made of products and a square root; d^alpha takes the
   rounding of d = Pi/2 - r along. Else tau = X is an exponential. */
/* d d^alpha, twice_alpha = 0 .. 14; d_lo is what d lost by rounding */
VM_INLINE vm_real vmi_ateb_product(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    const vm_real d2 = d * d;
    vm_real low = p->twice_alpha & 1 ? VM_SQRT(d) : 1, high = 1, power;
    if (p->twice_alpha & 2) low *= d;
    if (p->twice_alpha & 4) high = d2;
    if (p->twice_alpha & 8) high *= d2 * d2;
    power = low * high;
    return power * d + power * (p->n * d_lo);
}

/* The same without branches, with the same roundings */
VM_INLINE vm_real vmi_ateb_product_wide(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    const vm_real half = (vm_real)(p->twice_alpha & 1), one = (vm_real)(p->twice_alpha >> 1 & 1);
    const vm_real two = (vm_real)(p->twice_alpha >> 2 & 1), four = (vm_real)(p->twice_alpha >> 3 & 1), d2 = d * d;
    const vm_real low = VM_SQRT(half * d + (1 - half)) * (one * d + (1 - one));
    const vm_real power = low * ((two * d2 + (1 - two)) * (four * (d2 * d2) + (1 - four)));
    return power * d + power * (p->n * d_lo);
}

/* 2 q d */
VM_INLINE vm_two vmi_ateb_twice_q(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    return vmi_two(p->twice_q.hi * d, p->twice_q.lo * d + p->twice_q.hi * d_lo);
}

/* X = (2 q d)^(alpha+1) and its base */
VM_INLINE vm_real vmi_ateb_exponential(const ateb_plan *p, vm_real r, vm_real d, vm_real d_lo, vm_two *y)
{
    const vm_real least = VM_C(-0.69) * VMI_BIAS;
    const vmi_ateb_base base = vmi_ateb_base_of(p->twice_q, r, 2 * r - p->g, d, d_lo);
    const vm_real l = p->n * vmi_ateb_ln_of(base.k, base.t);
    *y = base.y;
    return vmi_ateb_exp(l > least ? l : least);
}

/* base (1 + tau odd(tau)) and 1 + tau even(tau) */
VM_INLINE void vmi_ateb_part_at(const vmi_ateb_part *part, int length, vm_two base, vm_real tau, vm_real *odd,
                                vm_real *even)
{
    const vm_real square = tau * tau;
    vm_real odd0 = 0, odd1 = 0, even0 = 0, even1 = 0;
    int j;
    for (j = length - 2; j >= 0; j -= 2) {
        odd0 = part->odd[j] + square * odd0;
        odd1 = part->odd[j + 1] + square * odd1;
        even0 = part->even[j] + square * even0;
        even1 = part->even[j + 1] + square * even1;
    }
    *odd = base.hi + (base.lo + base.hi * tau * (odd0 + tau * odd1));
    *even = 1 + tau * (even0 + tau * even1);
}

/* |s| from the nearest multiple of Pi/2, for |s| < p->longest: 2^26 quarters (float 2^12), whose products with the
   first parts are exact; the last bits of *quarter count them */
VM_INLINE vm_real vmi_ateb_plan_reduce(const ateb_plan *p, vm_real s, vmi_bits *quarter)
{
    const vm_real x = VM_FABS(s), to_integer = VM_C(1.5) / VM_EPSILON;
    const vm_real shifted = vmi_rounded(x * p->per_quarter + to_integer), j = vmi_rounded(shifted - to_integer);
    *quarter = vmi_to_bits(shifted);
    return ((x - j * p->quarter_parts[0]) - j * p->quarter_parts[1]) - j * p->quarter_parts[2];
}

VM_API void ateb_plan_saca(const ateb_plan *p, vm_real s, vm_real *sa, vm_real *ca)
{
    vm_real rest, near_zero, far_zero, lost, r, r_lo, d, d_lo;
    vmi_bits quarter;
    if (VM_FABS(s) < p->longest) rest = vmi_ateb_plan_reduce(p, s, &quarter);
    else if (VM_IS_FINITE(s)) {
        int count;
        rest = vmi_reduce(VM_FABS(s), p->quarter, &count).hi;
        quarter = (vmi_bits)count;
    } else {
        *sa = *ca = VM_NAN;
        return;
    }
    near_zero = VM_FABS(rest);
    far_zero = vmi_rounded((p->quarter.hi - near_zero) + p->quarter.lo);
    lost = ((p->quarter.hi - far_zero) - near_zero) + p->quarter.lo;
    r = far_zero;
    r_lo = lost;
    d = near_zero;
    d_lo = 0;
    if (!(quarter & 1)) {
        r = near_zero;
        r_lo = 0;
        d = far_zero;
        d_lo = lost;
    }
    if (r <= p->change_over) vmi_ateb_part_at(p->part, p->length, vmi_two(r, r_lo), r * r, sa, ca);
    else if (p->twice_alpha >= 0)
        vmi_ateb_part_at(p->part + 1, p->length, vmi_ateb_twice_q(p, d, d_lo), vmi_ateb_product(p, d, d_lo), ca,
                         sa);
    else {
        vm_two base;
        const vm_real X = vmi_ateb_exponential(p, r, d, d_lo, &base);
        vmi_ateb_part_at(p->part + 1, p->length, base, X, ca, sa);
    }
    vmi_ateb_signs(s, rest, quarter, sa, ca);
}

/* a where the bits of the mask are set, else b */
VM_INLINE vm_real vmi_select(vmi_bits mask, vm_real a, vm_real b)
{
    return vmi_from_bits((vmi_to_bits(a) & mask) | (vmi_to_bits(b) & ~mask));
}

/* The same for twice_alpha >= 0 and |s| < p->longest, both parts and no branch */
VM_INLINE void vmi_ateb_plan_both(const ateb_plan *p, int length, vm_real s, vm_real *sa, vm_real *ca)
{
    vmi_bits quarter;
    const vm_real rest = vmi_ateb_plan_reduce(p, s, &quarter), near_zero = VM_FABS(rest);
    const vm_real far_zero = vmi_rounded((p->quarter.hi - near_zero) + p->quarter.lo);
    const vm_real lost = ((p->quarter.hi - far_zero) - near_zero) + p->quarter.lo;
    const vmi_bits odd = 0 - (quarter & 1);
    const vm_real r = vmi_select(odd, far_zero, near_zero), d = vmi_select(odd, near_zero, far_zero);
    const vm_real r_lo = vmi_select(odd, lost, 0), d_lo = vmi_select(odd, 0, lost);
    const vmi_bits beyond = 0 - (vmi_to_bits(p->change_over - r) >> (8 * sizeof(vm_real) - 1));
    vm_real sa0, ca0, sa1, ca1;
    vmi_ateb_part_at(p->part, length, vmi_two(r, r_lo), r * r, &sa0, &ca0);
    vmi_ateb_part_at(p->part + 1, length, vmi_ateb_twice_q(p, d, d_lo), vmi_ateb_product_wide(p, d, d_lo), &ca1,
                     &sa1);
    *sa = vmi_select(beyond, sa1, sa0);
    *ca = vmi_select(beyond, ca1, ca0);
    vmi_ateb_signs(s, rest, quarter, sa, ca);
}

#define VMI_ATEB_LOOP(name, length) /* with a constant length it vectorises */              \
    VM_API void name(const ateb_plan *p, int n, const vm_real *s, vm_real *sa, vm_real *ca) \
    {                                                                                       \
        int i;                                                                              \
        for (i = 0; i < n; i++) {                                                           \
            vm_real v, u;                                                                   \
            vmi_ateb_plan_both(p, length, s[i], &v, &u);                                    \
            sa[i] = v;                                                                      \
            ca[i] = u;                                                                      \
        }                                                                                   \
    }

VMI_ATEB_LOOP(vmi_ateb_loop_4, 4)
VMI_ATEB_LOOP(vmi_ateb_loop_8, 8)
VMI_ATEB_LOOP(vmi_ateb_loop_10, VM_MANT_DIG > 24 ? 10 : 8)
VMI_ATEB_LOOP(vmi_ateb_loop_12, VM_MANT_DIG > 24 ? 12 : 8)
VMI_ATEB_LOOP(vmi_ateb_loop_14, ATEB_PLAN_LENGTH)
#undef VMI_ATEB_LOOP

#if defined(__AVX2__) || defined(__ARM_NEON) || defined(__ARM_FEATURE_SVE)
#define VMI_ATEB_WIDE 1 /* without wide registers both parts take longer than one */
#else
#define VMI_ATEB_WIDE 0
#endif

VM_API void ateb_plan_saca_array(const ateb_plan *p, int n, const vm_real *s, vm_real *sa, vm_real *ca)
{
    enum { BLOCK = 64 };
    vm_real x[BLOCK], inside[BLOCK];
    int i, j, count, outside;
    for (i = 0; i < n; i += BLOCK) {
        count = n - i < BLOCK ? n - i : BLOCK;
        for (j = 0, outside = 0; j < count; j++) {
            x[j] = s[i + j];
            inside[j] = VM_FABS(x[j]) < p->longest ? x[j] : 0;
            outside |= !(VM_FABS(x[j]) < p->longest);
        }
        if (p->twice_alpha < 0 || !VMI_ATEB_WIDE) {
            for (j = 0; j < count; j++) ateb_plan_saca(p, x[j], sa + i + j, ca + i + j);
            continue;
        }
        if (p->length <= 4) vmi_ateb_loop_4(p, count, inside, sa + i, ca + i);
        else if (p->length <= 8) vmi_ateb_loop_8(p, count, inside, sa + i, ca + i);
        else if (p->length <= 10) vmi_ateb_loop_10(p, count, inside, sa + i, ca + i);
        else if (p->length <= 12) vmi_ateb_loop_12(p, count, inside, sa + i, ca + i);
        else vmi_ateb_loop_14(p, count, inside, sa + i, ca + i);
        for (j = 0; outside && j < count; j++)
            if (inside[j] != x[j]) ateb_plan_saca(p, x[j], sa + i + j, ca + i + j);
    }
}

/* w_j of w = b^alpha, b_0 = 1, from w_0 .. w_(j-1) and b_1 .. b_j (Euler) */
VM_API vm_real vmi_ateb_series_power(vm_real alpha, int j, const vm_real *b, const vm_real *w)
{
    vm_real sum = 0;
    int i;
    for (i = 1; i <= j; i++) sum += (alpha * (vm_real)i - (vm_real)(j - i)) * b[i] * w[j - i];
    return sum / (vm_real)j;
}

enum { VMI_ATEB_TERMS = VM_MANT_DIG > 24 ? 56 : 26 };

/* Taylor coefficients in r^2 of sa/r and ca, in X of ca/(2 q d) and sa */
VM_API void vmi_ateb_series(int beyond, vm_real alpha, vm_real q, vm_real *odd, vm_real *even)
{
    const vm_real large = VM_C(1e30); /* beyond it alpha j could overflow, and nothing changes */
    vm_real w[VMI_ATEB_TERMS];
    int j;
    if (alpha > large) {
        alpha = large;
        q = 1 / large;
    }
    odd[0] = even[0] = w[0] = 1;
    for (j = 1; j < VMI_ATEB_TERMS; j++) {
        const vm_real i = (vm_real)j;
        even[j] = beyond ? -w[j - 1] / (2 * i) : -q * odd[j - 1] / i;
        if (beyond) odd[j] = even[j] * (q / (q + i));
        w[j] = vmi_ateb_series_power(alpha, j, beyond ? odd : even, w);
        if (!beyond) odd[j] = w[j] / (2 * i + 1);
    }
}

/* The polynomial c_1 + c_2 tau + ... [5], 0 <= tau <= limit, but for at most tolerance/limit: the highest powers go
   with Chebyshev polynomials that end in them. The result is for tau/unit; returned is
   how many terms it has. */
VM_API int vmi_ateb_economise(vm_real *c, vm_real limit, vm_real unit, vm_real tolerance, vm_real *result)
{
    vm_real power = limit, quarter = 2;
    int i, k;
    for (k = 1; k < VMI_ATEB_TERMS; k++, power *= limit, quarter /= 4) c[k - 1] = c[k] * power;
    for (k = VMI_ATEB_TERMS - 2, quarter *= 4; k > 0; k--, quarter *= 4) { /* quarter = 2^(1-2k) */
        vm_real term = c[k];
        tolerance -= VM_FABS(term) * quarter;
        if (tolerance < 0 && k < ATEB_PLAN_LENGTH) break;
        for (i = k; i > 0; i--) {
            term *= -((vm_real)i * (vm_real)(2 * i - 1)) / (2 * (vm_real)(k - i + 1) * (vm_real)(k + i - 1));
            c[i - 1] -= term;
        }
    }
    power = unit / limit;
    for (i = 0; i < ATEB_PLAN_LENGTH; i++, power *= unit / limit) result[i] = i <= k ? c[i] * power : 0;
    return k + 1;
}

/* One part, whose tau is X/unit there, r^2 here; returns the length of its polynomials */
VM_API int vmi_ateb_part_init(vmi_ateb_part *part, int beyond, const ateb_plan *p, vm_real alpha, vm_real unit,
                              vm_real tolerance)
{
    vm_real odd[VMI_ATEB_TERMS], even[VMI_ATEB_TERMS], limit = p->change_over * p->change_over;
    int length, even_length;
    if (beyond) {
        vm_two y;
        limit = vmi_ateb_exponential(p, p->change_over, p->quarter.hi - p->change_over, 0, &y);
    }
    vmi_ateb_series(beyond, alpha, p->twice_q.hi / 2, odd, even);
    length = vmi_ateb_economise(odd, limit, unit, tolerance, part->odd);
    even_length = vmi_ateb_economise(even, limit, unit, tolerance, part->even);
    return length > even_length ? length : even_length;
}

VM_API int ateb_plan_init_to(ateb_plan *p, vm_real alpha, vm_real accuracy)
{
    /* Beyond the change-over sa comes from X, whose roundings count X/(2 sa) times: 0.33 at r = 0.92; 0.5, at 0.73,
       makes 2.3 ulp of them. Further out sa would take more terms than there are. */
    const vm_real share = VM_C(0.5), most = VM_MANT_DIG > 24 ? VM_C(0.92) : VM_C(0.95);
    const vm_real tolerance = accuracy > VM_EPSILON ? accuracy / 2 : VM_EPSILON / 16;
    int length, length_beyond;
    vm_two n;
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha)) return -1;
    vmi_ateb_constants(&c, alpha);
    n = c.n;
    p->quarter = vmi_ateb_fine_quarter(&c);
    p->quarter_parts[0] = vmi_head(p->quarter.hi);
    p->quarter_parts[1] = vmi_head(p->quarter.hi - p->quarter_parts[0]);
    p->quarter_parts[2] = ((p->quarter.hi - p->quarter_parts[0]) - p->quarter_parts[1]) + p->quarter.lo;
    p->per_quarter = 1 / p->quarter.hi;
    p->longest = p->quarter.hi * (vm_real)((1L << VM_MANT_DIG / 2) - 1);
    p->change_over = share * p->quarter.hi < most ? share * p->quarter.hi : most;
    p->n = c.n.hi;
    p->twice_q = vmi_two(2 * c.q.hi, 2 * c.q.lo);
    p->g = c.g.hi;
    p->twice_alpha = alpha <= 7 && 2 * alpha == VM_FLOOR(2 * alpha) ? (int)(2 * alpha) : -1;
    length = vmi_ateb_part_init(p->part, 0, p, alpha, 1, tolerance);
    length_beyond = vmi_ateb_part_init(p->part + 1, 1, p, alpha, p->twice_alpha < 0 ? 1 : vmi_pow_two(p->twice_q, n),
                                       tolerance);
    p->length = (length > length_beyond ? length + 1 : length_beyond + 1) / 2 * 2;
    return 0;
}

VM_API int ateb_plan_init(ateb_plan *p, vm_real alpha) { return ateb_plan_init_to(p, alpha, 0); }

#endif
