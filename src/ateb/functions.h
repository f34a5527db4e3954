/* ateb/functions.h - sa and ca */
#ifndef VARMASS_ATEB_FUNCTIONS_H
#define VARMASS_ATEB_FUNCTIONS_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "inversion.h"
#include "period.h"
#include "powers.h"

/* As vmi_reduce, with as many words of the quarter as s needs, two of them left in c: so that an error of the quarter
   is felt neither in a large s nor near to a zero. */
VM_API vm_real vmi_ateb_reduce_finely(vm_real s, vmi_ateb *c, int *quarter)
{
    const vm_real near_zero = VM_MANT_DIG > 24 ? VM_C(6e-14) : VM_C(1.5e-5); /* 2^-44, 2^-16 */
    vm_real rest, j;
    c->quarter = vmi_ateb_fine_quarter(c);
    rest = vmi_reduce(s, c->quarter, quarter).hi;
    j = VM_FLOOR(s / c->quarter.hi + VM_C(0.5));
    if (VM_FABS(rest) < near_zero * s && 8 * c->q.hi >= VM_SQRT(VM_EPSILON)) {
        const vmi_three q = vmi_ateb_finest_quarter(c->n);
        const vm_two high = vmi_two_product(j, q.hi), mid = vmi_two_product(j, q.mid);
        if (j * VM_EPSILON < 1) rest = (((s - high.hi) - high.lo) - mid.hi) - (mid.lo + j * q.lo);
    }
    return VM_FABS(rest) < c->quarter.hi ? rest : 0; /* s beyond 2^52 quarters */
}

/* The quarter of s >= 0; what s has more than so many quarters; its distances r and d from the zeros of sa and ca. In
   the first of the ways r does not wait for Pi; in the second, quarters are counted by the high word, so that the
   rest may exceed half of one. */
VM_INLINE vm_real vmi_ateb_locate(vm_real s, vmi_ateb *c, int *quarter, vm_real *r, vm_real *d)
{
    const vm_real n = c->n.hi, to_integer = VM_C(1.5) / VM_EPSILON;
    vm_real rest = 0, size, other, odd;
    int coarse = s / 128 <= n;
    if (s <= n / 2) {
        *quarter = 0;
        *d = (c->quarter.hi - s) + c->quarter.lo;
        return *r = s;
    }
    if (coarse) { /* products with half of the quarter's digits are exact */
        const vm_real high = vmi_head(c->quarter.hi), low = c->quarter.hi - high;
        const vm_real shifted = vmi_rounded(s / c->quarter.hi + to_integer), j = vmi_rounded(shifted - to_integer);
        *quarter = (int)(vmi_to_bits(shifted) & 3);
        rest = ((s - j * high) - j * low) - j * c->quarter.lo;
        coarse = VM_FABS(rest) * n * 1024 >= s;
    }
    if (!coarse) rest = vmi_ateb_reduce_finely(s, c, quarter);
    odd = (vm_real)(*quarter & 1);
    size = VM_FABS(rest);
    other = (c->quarter.hi - size) + c->quarter.lo;
    *r = vmi_choose(odd, other, size);
    *d = vmi_choose(odd, size, other);
    return rest;
}

/* From the first quarter to that of s = +-(quarter Pi/2 + rest), on the bits of the signs */
VM_INLINE void vmi_ateb_signs(vm_real s, vm_real rest, vmi_bits quarter, vm_real *sa, vm_real *ca)
{
    const int last = 8 * (int)sizeof(vm_real) - 1;
    const vmi_bits sign = (vmi_bits)1 << last, odd = quarter & 1;
    const vmi_bits half = quarter >> 1 << last, rest_bits = vmi_to_bits(rest);
    *sa = vmi_from_bits(vmi_to_bits(*sa) ^ half ^ ((vmi_to_bits(s) ^ (rest_bits & (odd - 1))) & sign));
    *ca = vmi_from_bits(vmi_to_bits(*ca) ^ half ^ (~rest_bits & (odd << last)));
}

/* sa(1, alpha, s) and ca(alpha, 1, s) for any real s and alpha >= 0 (276). |sa|, |ca| <= 1; sa is odd, ca is even, to
   the bit. s is reduced with Pi_alpha in two words. */
VM_API void ateb_saca(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca)
{
    const vm_real change_over = VM_C(0.55);
    vm_real rest, r, d = 0;
    int quarter;
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(s)) {
        *sa = *ca = VM_NAN;
        return;
    }
    vmi_ateb_index_constants(&c, alpha);
    rest = r = VM_FABS(s);
    quarter = 0;
    if (r > change_over) {
        vmi_ateb_period_constants(&c);
        rest = vmi_ateb_locate(rest, &c, &quarter, &r, &d);
    }
    if (r <= change_over) vmi_ateb_near_sa_zero(r, c.q.hi, sa, ca);
    else vmi_ateb_near_ca_zero(r, d, &c, sa, ca);
    vmi_ateb_signs(s, rest, (vmi_bits)quarter, sa, ca);
}

/* Documented with ateb_saca. */
VM_API vm_real ateb_sa(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return sa;
}

/* Documented with ateb_saca. */
VM_API vm_real ateb_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return ca;
}

#endif
