/* ateb/beta.h - beta functions and their inverses */
#ifndef VARMASS_ATEB_BETA_H
#define VARMASS_ATEB_BETA_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* ---- Beta functions -------------------------------------------------------------------------------------------

   All in logarithms of two words. With A = a + i, B = b + j, S = a + b + k >= 10, by Stirling's formula
     ln(x^a y^b/B(a, b)) = a ln x + b ln y + (a + k - j) ln S/A + (b + k - i) ln S/B + (k - i - j + 1/2) ln(A B/S)
                           + (i + j - k) - ln(2 pi)/2 + delta(S) - delta(A) - delta(B) + ln((a)_i (b)_j/(a+b)_k)
   in which nothing large cancels where the whole is not large, and no product leaves the range: i, j, k <= 10. */
/* delta(z) = ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2, z >= 10 */
VM_API vm_real vmi_stirling(vm_real z)
{
    VM_TABLE vm_real c[9] = {
        VM_C(0.083333333333333333333),  VM_C(-0.0027777777777777777778), VM_C(7.9365079365079365079e-4),
        VM_C(-5.952380952380952381e-4), VM_C(8.4175084175084175084e-4),  VM_C(-0.0019175269175269175269),
        VM_C(0.0064102564102564102564), VM_C(-0.029550653594771241830),  VM_C(0.17964437236883057316)};
    const vm_real square = 1 / (z * z);
    vm_real sum = VM_READ(c[8]);
    int i;
    for (i = 7; i >= 0; i--) sum = VM_READ(c[i]) + square * sum;
    return sum / z;
}

/* (z)_i with the least i for which z + i >= 10, z becomes z + i */
VM_API vm_two vmi_beta_rise(vm_two *z, int *count)
{
    vm_two product = {1, 0}, one = {1, 0};
    for (*count = 0; z->hi < 10; ++*count) {
        product = vmi_two_times(product, *z);
        *z = vmi_two_plus(*z, one);
    }
    return product;
}

/* ln(x^a y^b/B(a, b)) */
VM_API vm_two vmi_beta_ln_density(vm_two a, vm_two b, vm_two ln_x, vm_two ln_y)
{
#if VM_MANT_DIG > 24
    const vm_two half_ln_2pi = {VM_C(-0.91893853320467278056), VM_C(3.8782941580672414498e-17)};
#else
    const vm_two half_ln_2pi = {VM_C(-0.9189385175705), VM_C(-1.5634176619983e-8)};
#endif
    vm_two A = a, B = b, S = vmi_two_plus(a, b), rise, ln_SA, ln_SB, sum;
    int i, j, k;
    rise = vmi_beta_rise(&A, &i);
    rise = vmi_two_times(rise, vmi_beta_rise(&B, &j));
    rise = vmi_two_over(rise, vmi_beta_rise(&S, &k));
    ln_SA = vmi_two_log(vmi_two_over(S, A));
    ln_SB = vmi_two_log(vmi_two_over(S, B));
    sum = vmi_two_scaled(vmi_two_log(vmi_two_over(vmi_two_times(A, B), S)), (vm_real)(k - i - j) + VM_C(0.5));
    sum = vmi_two_plus(sum, vmi_two_plus(half_ln_2pi, vmi_two((vm_real)(i + j - k), 0)));
    sum = vmi_two_plus(sum, vmi_two_log(rise));
    sum = vmi_two_plus(sum, vmi_two_scaled(ln_SA, (vm_real)(k - j)));
    sum = vmi_two_plus(sum, vmi_two_scaled(ln_SB, (vm_real)(k - i)));
    sum = vmi_two_plus(sum, vmi_two_plus(vmi_two_times(vmi_two_plus(ln_x, ln_SA), a),
                                         vmi_two_times(vmi_two_plus(ln_y, ln_SB), b)));
    return vmi_two_sum(sum.hi, sum.lo + (vmi_stirling(S.hi) - vmi_stirling(A.hi) - vmi_stirling(B.hi)));
}

VM_API vm_two vmi_beta_ln(vm_two a, vm_two b)
{
    const vm_two none = {0, 0};
    return vmi_minus(vmi_beta_ln_density(a, b, none, none));
}

/* Beyond, series and fractions have no bound that a caller would wait for, and float no digits */
VM_API int vmi_beta_is_in_domain(vm_real a, vm_real b)
{
    return a >= VM_C(1e-4) && a <= VM_C(1e5) && b >= VM_C(1e-4) && b <= VM_C(1e5);
}

/* B(a, b), a and b from 1e-4 to 1e5; I_x(a, b), regularised, and x of which it is p, from 1e-3 to 1e4, less accurate
   and slower to 1e-4 and 1e5; NaN beyond. The forms with both take and return complements too, y = 1 - x and
   q = 1 - p, where these carry the information; ln x tells x where it underflows. */
VM_API vm_real ateb_beta(vm_real a, vm_real b)
{
    vm_two l;
    if (!vmi_beta_is_in_domain(a, b)) return VM_NAN;
    l = vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0));
    return vmi_exp(l.hi, l.lo);
}

/* I_x(a, b) B(a, b)/(x^a y^b), a > 1, x <= (a + 1)/(a + b + 2), by the continued fraction of Didonato and Morris [6],
   from its end. Its terms are positive but for the last; a y - b x is where the digits of large a and b could go. */
VM_API vm_real vmi_beta_fraction(vm_real x, vm_real y, vm_real a, vm_real b)
{
    const vm_real digits = VM_MANT_DIG > 24 ? 10 : 5;
    const vm_two product = vmi_two_scaled(vmi_two_sum(a, b), x <= y ? x : y);
    const vm_real excess = x <= y ? (a - product.hi) - product.lo : (product.hi - b) + product.lo;
    const vm_real terms = 20 + digits / VM_SQRT(y) + 4 * VM_SQRT(a > b ? a : b);
    long m = terms <= VM_C(1e8) ? (long)terms : 0; /* 2e7 at most, or NaN */
    vm_real f = (a + (vm_real)m) / 2;
    for (; m >= 0; m--) {
        const vm_real n = (vm_real)m, c = a + 2 * n, top = n + 1, ratio = (a + n) / (c + 1) * x;
        f = n * (1 + (b - n) * x / (c - 1)) + (a + n) * (excess + 1 + n * (1 + y)) / (c + 1) +
            ratio * ((a + b + n) / (c + 1) * x) * top * (b - top) / f;
    }
    return 1 / f;
}

/* ln(1 - e^l), l < 0 */
VM_API vm_two vmi_ln_one_minus_exp(vm_two l)
{
    vm_two rest = {0, 0};
    vm_real p, p_lo;
    int k;
    if (!(l.hi >= -2 * VM_C(0.6931471805599453) * VM_MANT_DIG)) { /* -e^l, which no longer matters beside 1, or NaN */
        rest.hi = -vmi_exp(l.hi, 0);
        return rest;
    }
    p = vmi_exp_core(l.hi, l.lo, &k, &p_lo);
    if (k == 0) {
        rest.hi = -p;
        rest.lo = -p_lo;
    } else {
        vm_two e = vmi_fast_two_sum(1, p);
        e.lo += p_lo;
        rest = vmi_two_sum(1, -vmi_ldexp(e.hi, k));
        rest.lo -= vmi_ldexp(e.lo, k);
    }
    return vmi_two_log(rest);
}

typedef struct VM_TAG(vmi_beta_point) {
    vm_real x, y;
    vm_two ln_x, ln_y;
} vmi_beta_point;

/* ln I_x(a, b) for x <= (a + 1)/(a + b + 2). For small a I_x is near to 1, and what it lacks counts: there
   I_x a B/x^a = 2F1(a, 1-b; a+1; x) = 1 + a sum_(n>=1) (1-b)_n/n! x^n/(a+n), terms of (b x)^n/n!, b x < 2, or x^n. */
VM_API vm_two vmi_beta_ln_tail(vm_real x, vm_real y, vm_two ln_x, vm_two ln_y, vm_real a, vm_real b)
{
    vm_two f;
    if (a <= 1) {
        vm_real power = 1, term, sum = 0, n = 0;
        do {
            n += 1;
            power *= x * (n - b) / n;
            term = power / (a + n);
            sum += term;
        } while (VM_FABS(term) > VM_EPSILON / 8 * VM_FABS(sum) && n < 200); /* x <= 2/3: 96, unless x is NaN */
        f = vmi_two_plus(vmi_two_log(vmi_two_sum(1, a * sum)), vmi_minus(vmi_log(a)));
        ln_y.hi = ln_y.lo = 0;
    } else f = vmi_log(vmi_beta_fraction(x, y, a, b));
    return vmi_two_plus(vmi_beta_ln_density(vmi_two(a, 0), vmi_two(b, 0), ln_x, ln_y), f);
}

/* ln I_x(a, b) and ln I_y(b, a) */
VM_API void vmi_beta_tails(const vmi_beta_point *at, vm_real a, vm_real b, vm_two *ln_p, vm_two *ln_q)
{
    if (at->x * (a + b + 2) <= a + 1) {
        *ln_p = vmi_beta_ln_tail(at->x, at->y, at->ln_x, at->ln_y, a, b);
        *ln_q = vmi_ln_one_minus_exp(*ln_p);
    } else {
        *ln_q = vmi_beta_ln_tail(at->y, at->x, at->ln_y, at->ln_x, b, a);
        *ln_p = vmi_ln_one_minus_exp(*ln_q);
    }
}

/* Documented with ateb_beta. */
VM_API void ateb_beta_inc_both(vm_real x, vm_real y, vm_real a, vm_real b, vm_real *p, vm_real *q)
{
    vmi_beta_point at;
    vm_two ln_p, ln_q;
    if (!vmi_beta_is_in_domain(a, b) || !(x >= 0) || !(y >= 0) || !(VM_FABS((x + y) - 1) <= 4 * VM_EPSILON)) {
        *p = *q = VM_NAN;
        return;
    }
    if (x == 0 || y == 0) {
        *p = x == 0 ? 0 : 1;
        *q = x == 0 ? 1 : 0;
        return;
    }
    at.x = x;
    at.y = y;
    at.ln_x = x <= y ? vmi_log(x) : vmi_two_log(vmi_two_sum(1, -y));
    at.ln_y = x <= y ? vmi_two_log(vmi_two_sum(1, -x)) : vmi_log(y);
    vmi_beta_tails(&at, a, b, &ln_p, &ln_q);
    *p = vmi_exp(ln_p.hi, ln_p.lo);
    *q = vmi_exp(ln_q.hi, ln_q.lo);
}

/* Documented with ateb_beta. */
VM_API vm_real ateb_beta_inc(vm_real x, vm_real a, vm_real b)
{
    vm_real p, q;
    ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
    return p;
}

/* The point x/y = e^t */
VM_API void vmi_beta_point_at(vm_real t, vmi_beta_point *at)
{
    const vm_real size = VM_FABS(t);
    const vm_real e = vmi_exp(-size, 0); /* rounded; y = 1 - x holds in two words if its own logarithm is taken */
    const vm_two ln_e = e > VM_MIN ? vmi_log(e) : vmi_two(-size, 0);
    const vm_two l = vmi_minus(vmi_two_log(vmi_two_sum(1, e))), ln_small = vmi_two_plus(ln_e, l);
    at->ln_x = t < 0 ? ln_small : l;
    at->ln_y = t < 0 ? l : ln_small;
    at->x = vmi_exp(at->ln_x.hi, at->ln_x.lo);
    at->y = vmi_exp(at->ln_y.hi, at->ln_y.lo);
}

/* I_x(a, b) = p <= q = 1 - p, by Newton's method for ln I as a function of t = ln(x/y), which is concave: from the
   asymptote at its left, whose zero lies left, it goes one way. The last step is taken in ln x and ln y. */
VM_API void vmi_beta_invert(vm_two ln_p, vm_real a, vm_real b, vm_real *x, vm_real *y, vm_two *ln_x, vm_two *ln_y)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(1e-5);
    const vm_two a2 = vmi_two(a, 0), b2 = vmi_two(b, 0);
    vm_two start = vmi_two_plus(ln_p, vmi_two_plus(vmi_log(a), vmi_beta_ln(a2, b2))), tail, other, density, rest;
    vm_real t = start.hi / a, step;
    vmi_beta_point at;
    int i;
    for (i = 0;; i++) {
        vmi_beta_point_at(t, &at);
        density = vmi_beta_ln_density(a2, b2, at.ln_x, at.ln_y);
        vmi_beta_tails(&at, a, b, &tail, &other);
        rest = vmi_two_plus(ln_p, vmi_minus(tail));
        step = rest.hi * vmi_exp(tail.hi - density.hi, tail.lo - density.lo);
        if (VM_FABS(step) <= enough || VM_FABS(step) <= VM_EPSILON * VM_FABS(t) || i > 60) break;
        t += step;
    }
    *x = at.x + at.x * (at.y * step);
    *y = at.y - at.y * (at.x * step);
    *ln_x = vmi_two_sum(at.ln_x.hi, at.ln_x.lo + at.y * step);
    *ln_y = vmi_two_sum(at.ln_y.hi, at.ln_y.lo - at.x * step);
}

/* Documented with ateb_beta. */
VM_API void ateb_beta_inc_inv_both(vm_real p, vm_real q, vm_real a, vm_real b, vm_real *x, vm_real *y,
                                   vm_real *ln_x)
{
    vm_two l, ignored;
    if (!vmi_beta_is_in_domain(a, b) || !(p >= 0) || !(q >= 0) || !(VM_FABS((p + q) - 1) <= 4 * VM_EPSILON)) {
        *x = *y = *ln_x = VM_NAN;
        return;
    }
    if (p == 0 || q == 0) {
        *x = p == 0 ? 0 : 1;
        *y = p == 0 ? 1 : 0;
        *ln_x = p == 0 ? -VM_INFINITY : 0;
        return;
    }
    if (p <= q) vmi_beta_invert(vmi_log(p), a, b, x, y, &l, &ignored);
    else vmi_beta_invert(vmi_log(q), b, a, y, x, &ignored, &l);
    *ln_x = l.hi;
}

/* Documented with ateb_beta. */
VM_API vm_real ateb_beta_inc_inv(vm_real p, vm_real a, vm_real b)
{
    vm_real x, y, ln_x;
    ateb_beta_inc_inv_both(p, 1 - p, a, b, &x, &y, &ln_x);
    return x;
}

/* Mean of |sa|^p |ca|^q over a period, -1 < p, q <= 1e6 (316), alpha <= 1e30; NaN beyond */
VM_API vm_real ateb_mean(vm_real alpha, vm_real p, vm_real q)
{
    const vm_two half = {VM_C(0.5), 0};
    vm_two above, n;
    const vm_real most = VM_C(1e6);
    if (!(alpha >= 0) || !(alpha <= VM_C(1e30)) || !(p > -1) || !(q > -1) || !(p <= most) || !(q <= most))
        return VM_NAN;
    n = vmi_two_sum(alpha, 1);
    above = vmi_beta_ln(vmi_half(vmi_two_sum(p, 1)), vmi_two_over(vmi_two_sum(q, 1), n));
    above = vmi_two_plus(above, vmi_minus(vmi_beta_ln(half, vmi_two_over(vmi_two(1, 0), n))));
    return vmi_exp(above.hi, above.lo);
}

#endif
