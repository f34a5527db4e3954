/* ateb/beta.h - beta functions, their inverses, and mean values of sa and ca

   B(a, b) is the complete beta function, I_x(a, b) the regularised incomplete one, 0 <= I_x <= 1. Ateb functions are
   inverses of incomplete beta functions, and their mean values are quotients of complete beta functions (316).

       vm_real p = ateb_beta_inc(VM_C(0.3), VM_C(0.5), 2); // I_0.3(0.5, 2)

   In this file y = 1 - x and q = 1 - p. The functions with the suffix _both also take and return y and q, which keep
   their digits where x or p is close to 1.

   Method: the functions are computed from logarithms in two words. i, j and k are the least whole numbers for which
   A = a + i, B = b + j and S = a + b + k are at least 10. Stirling's formula gives
     ln(x^a y^b/B(a, b)) = a ln x + b ln y + (a + k - j) ln S/A + (b + k - i) ln S/B
                           + (k - i - j + 1/2) ln(A B/S) + (i + j - k) - ln(2 pi)/2
                           + delta(S) - delta(A) - delta(B) + ln((a)_i (b)_j/(a+b)_k)
   where delta is the remainder of Stirling's formula and (a)_i = a (a + 1) ... (a + i - 1). If this sum is not large,
   no large terms cancel in it. The products (a)_i, (b)_j and (a+b)_k neither overflow nor underflow, since i, j and
   k are at most 10.

   Source of the continued fraction (vmi_beta_fraction): Didonato and Morris, Algorithm 708, ACM TOMS 18 (1992). Tests:
   tests/test_ateb.c. */
#ifndef VARMASS_ATEB_BETA_H
#define VARMASS_ATEB_BETA_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* Returns delta(z) = ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2 for z >= 10, by Stirling's series */
VM_API vm_real vmi_beta_stirling(vm_real z)
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

/* Returns the product (z)_i = z (z + 1) ... (z + i - 1) with the least i for which z + i >= 10. *count becomes i, and
   *z becomes z + i. */
VM_API vm_two vmi_beta_rise(vm_two *z, int *count)
{
    const vm_two one = {1, 0};
    vm_two product = {1, 0};
    for (*count = 0; z->hi < 10; ++*count) {
        product = vmi_two_times(product, *z);
        *z = vmi_two_plus(*z, one);
    }
    return product;
}

/* Returns ln(x^a y^b/B(a, b)), by the formula at the top of this file. */
VM_API vm_two vmi_beta_ln_density(vm_two a, vm_two b, vm_two ln_x, vm_two ln_y)
{
#if VM_MANT_DIG > 24
    const vm_two half_ln_2pi = {VM_C(-0.91893853320467278056), VM_C(3.8782941580672414498e-17)};
#else
    const vm_two half_ln_2pi = {VM_C(-0.9189385175705), VM_C(-1.5634176619983e-8)};
#endif
    vm_two A = a, B = b, S = vmi_two_plus(a, b), rise, ln_SA, ln_SB, sum;
    vm_real delta;
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
    delta = vmi_beta_stirling(S.hi) - vmi_beta_stirling(A.hi) - vmi_beta_stirling(B.hi);
    return vmi_two_sum(sum.hi, sum.lo + delta);
}

/* Returns ln B(a, b). */
VM_API vm_two vmi_beta_ln(vm_two a, vm_two b)
{
    const vm_two none = {0, 0};
    return vmi_minus(vmi_beta_ln_density(a, b, none, none));
}

/* Returns 1 if a and b lie between 1e-4 and 1e5, else 0. Outside these limits the series and continued fractions would
   need too many terms, and float would have no digits left. */
VM_API int vmi_beta_is_in_domain(vm_real a, vm_real b)
{
    return a >= VM_C(1e-4) && a <= VM_C(1e5) && b >= VM_C(1e-4) && b <= VM_C(1e5);
}

/* The complete beta function B(a, b), for a and b from 1e-4 to 1e5.
   The error is at most 1 ulp. Returns NaN for other a or b. Equation (261). */
VM_API vm_real ateb_beta(vm_real a, vm_real b)
{
    vm_two l;
    if (!vmi_beta_is_in_domain(a, b)) return VM_NAN;
    l = vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0));
    return vmi_exp(l.hi, l.lo);
}

/* Returns I_x(a, b) B(a, b)/(x^a y^b) for y = 1 - x, a > 1 and x <= (a + 1)/(a + b + 2). The result is 1/f_0 of the
   continued fraction f_n = constant + ratio/f_(n+1) of Didonato and Morris. The loop evaluates it from its end; m is
   the index n. All terms are positive except for the last ones. Where a and b are large, digits cancel in
   excess = a y - b x; therefore `excess` is computed in two words. */
VM_API vm_real vmi_beta_fraction(vm_real x, vm_real y, vm_real a, vm_real b)
{
    const vm_real digits = VM_MANT_DIG > 24 ? 10 : 5;
    const vm_two product = vmi_two_scaled(vmi_two_sum(a, b), vmi_smaller(x, y));
    const vm_real terms = 20 + digits / VM_SQRT(y) + 4 * VM_SQRT(vmi_larger(a, b));
    vm_real excess = (product.hi - b) + product.lo, f;
    long m = 0;
    if (x <= y) excess = (a - product.hi) - product.lo;
    if (terms <= VM_C(1e8)) m = (long)terms; /* terms is at most 2e7, or NaN */
    f = (a + (vm_real)m) / 2;
    for (; m >= 0; m--) {
        const vm_real n = (vm_real)m, c = a + 2 * n, next = n + 1, share = (a + n) / (c + 1) * x;
        const vm_real constant = n * (1 + (b - n) * x / (c - 1)) + (a + n) * (excess + 1 + n * (1 + y)) / (c + 1);
        const vm_real ratio = share * ((a + b + n) / (c + 1) * x) * next * (b - next);
        f = constant + ratio / f;
    }
    return 1 / f;
}

/* Returns I_x(a, b) a B(a, b)/x^a - 1 for a <= 1 and x <= 2/3. This is a times the sum over n >= 1 of (1 - b)_n/n!
   x^n/(a + n), where (z)_n = z (z + 1) ... (z + n - 1). Term n is below the larger of x^n and (b x)^n/n!, and
   b x < 2. */
VM_API vm_real vmi_beta_series(vm_real x, vm_real a, vm_real b)
{
    const vm_real most = 200; /* limit of the loop if x is NaN; otherwise 96 terms are enough */
    vm_real power = 1, term, sum = 0, n = 0;
    do {
        n += 1;
        power *= x * (n - b) / n;
        term = power / (a + n);
        sum += term;
    } while (VM_FABS(term) > VM_EPSILON / 8 * VM_FABS(sum) && n < most);
    return a * sum;
}

/* Returns ln(1 - e^l) for l < 0, where e^l = 2^k (1 + p). If k = 0, the number 1 - e^l is -p, so that no digits are
   lost. */
VM_API vm_two vmi_ln_one_minus_exp(vm_two l)
{
    vm_two rest = {0, 0};
    vm_real p, p_lo;
    int k;
    if (!(l.hi >= -2 * VM_C(0.6931471805599453) * VM_MANT_DIG)) { /* the result is -e^l, which is tiny, or NaN */
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

/* A point between 0 and 1: x, y = 1 - x and their logarithms */
typedef struct VM_TAG(vmi_beta_point) {
    vm_real x, y;
    vm_two ln_x, ln_y;
} vmi_beta_point;

/* The point with x and y exchanged */
VM_API vmi_beta_point vmi_beta_mirrored(vmi_beta_point at)
{
    vmi_beta_point mirrored;
    mirrored.x = at.y;
    mirrored.y = at.x;
    mirrored.ln_x = at.ln_y;
    mirrored.ln_y = at.ln_x;
    return mirrored;
}

/* Returns ln I_x(a, b) at the point x with y = 1 - x, for x <= (a + 1)/(a + b + 2). Where a is small, I_x is close
   to 1, and 1 - I_x must keep its digits. Therefore a series is used for a <= 1: it loses no digits and has no factor
   y^b. */
VM_API vm_two vmi_beta_ln_tail(vmi_beta_point at, vm_real a, vm_real b)
{
    vm_two f;
    if (a <= 1) {
        f = vmi_two_plus(vmi_two_log(vmi_two_sum(1, vmi_beta_series(at.x, a, b))), vmi_minus(vmi_log(a)));
        at.ln_y = vmi_two(0, 0);
    } else f = vmi_log(vmi_beta_fraction(at.x, at.y, a, b));
    return vmi_two_plus(vmi_beta_ln_density(vmi_two(a, 0), vmi_two(b, 0), at.ln_x, at.ln_y), f);
}

/* Computes *ln_p = ln I_x(a, b) and *ln_q = ln I_y(b, a), where y = 1 - x and p + q = 1. The logarithm of the shorter
   tail of the distribution is computed; the other logarithm follows from p + q = 1. */
VM_API void vmi_beta_tails(const vmi_beta_point *at, vm_real a, vm_real b, vm_two *ln_p, vm_two *ln_q)
{
    if (at->x * (a + b + 2) <= a + 1) {
        *ln_p = vmi_beta_ln_tail(*at, a, b);
        *ln_q = vmi_ln_one_minus_exp(*ln_p);
    } else {
        *ln_q = vmi_beta_ln_tail(vmi_beta_mirrored(*at), b, a);
        *ln_p = vmi_ln_one_minus_exp(*ln_q);
    }
}

/* Returns 1 if x and y are not negative and add up to 1, apart from rounding, else 0. */
VM_API int vmi_beta_is_split_of_1(vm_real x, vm_real y)
{
    return x >= 0 && y >= 0 && VM_FABS((x + y) - 1) <= 4 * VM_EPSILON;
}

/* The regularised incomplete beta function p = I_x(a, b) and q = 1 - p. They are computed from x and y = 1 - x; the
   smaller of x and y carries the digits. For a and b from 1e-3 to 1e4 the errors of p and q are at most 30 ulp each.
   a and b may also lie between 1e-4 and 1e5, where the function is less accurate and slower. The results are NaN for
   other a or b, for x or y below 0, and if x + y is not 1. docs/cost.md has the time. DLMF 8.17, equation (273). */
VM_API void ateb_beta_inc_both(vm_real x, vm_real y, vm_real a, vm_real b, vm_real *p, vm_real *q)
{
    vmi_beta_point at;
    vm_two ln_p, ln_q;
    *p = VM_NAN;
    *q = VM_NAN;
    if (!vmi_beta_is_in_domain(a, b) || !vmi_beta_is_split_of_1(x, y)) return;
    if (x == 0) {
        *p = 0;
        *q = 1;
        return;
    }
    if (y == 0) {
        *p = 1;
        *q = 0;
        return;
    }
    at.x = x;
    at.y = y;
    if (x <= y) {
        at.ln_x = vmi_log(x);
        at.ln_y = vmi_two_log(vmi_two_sum(1, -x));
    } else {
        at.ln_x = vmi_two_log(vmi_two_sum(1, -y));
        at.ln_y = vmi_log(y);
    }
    vmi_beta_tails(&at, a, b, &ln_p, &ln_q);
    *p = vmi_exp(ln_p.hi, ln_p.lo);
    *q = vmi_exp(ln_q.hi, ln_q.lo);
}

/* The regularised incomplete beta function I_x(a, b), for 0 <= x <= 1.
   Domain and accuracy are those of ateb_beta_inc_both. */
VM_API vm_real ateb_beta_inc(vm_real x, vm_real a, vm_real b)
{
    vm_real p, q;
    ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
    return p;
}

/* Returns the point with x/y = e^t, where y = 1 - x. ln x and ln y are computed from the rounded value of e^-|t|, so
   that x + y = 1 in two words. */
VM_API vmi_beta_point vmi_beta_point_at(vm_real t)
{
    const vm_real size = VM_FABS(t), e = vmi_exp(-size, 0);
    vmi_beta_point at;
    vm_two ln_e = vmi_two(-size, 0);
    if (e > VM_MIN) ln_e = vmi_log(e);
    at.ln_y = vmi_minus(vmi_two_log(vmi_two_sum(1, e)));
    at.ln_x = vmi_two_plus(ln_e, at.ln_y);
    at.x = vmi_exp(at.ln_x.hi, at.ln_x.lo);
    at.y = vmi_exp(at.ln_y.hi, at.ln_y.lo);
    if (!(t < 0)) at = vmi_beta_mirrored(at);
    return at;
}

/* Returns the point where I_x(a, b) = p, from ln p, for p <= 1/2. Newton's method is used for ln I_x as a function of
   t = ln(x/y). This function is concave. The first t is the one where the asymptote of ln I_x for t to -infinity equals
   ln p. This t lies left of the solution, so that all steps go to the right. The last step changes x, y, ln x and ln y
   directly instead of t. */
VM_API vmi_beta_point vmi_beta_invert(vm_two ln_p, vm_real a, vm_real b)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(1e-5); /* a step shorter than this is the last one */
    const int most = 60;                                               /* largest number of steps; 20 are enough */
    const vm_two a2 = vmi_two(a, 0), b2 = vmi_two(b, 0);
    const vm_two start = vmi_two_plus(ln_p, vmi_two_plus(vmi_log(a), vmi_beta_ln(a2, b2)));
    vm_real t = start.hi / a, step;
    vmi_beta_point at, result;
    int i;
    for (i = 0;; i++) {
        vm_two density, tail, other, rest;
        at = vmi_beta_point_at(t);
        density = vmi_beta_ln_density(a2, b2, at.ln_x, at.ln_y);
        vmi_beta_tails(&at, a, b, &tail, &other);
        rest = vmi_two_plus(ln_p, vmi_minus(tail));
        step = rest.hi * vmi_exp(tail.hi - density.hi, tail.lo - density.lo);
        if (VM_FABS(step) <= enough || VM_FABS(step) <= VM_EPSILON * VM_FABS(t) || i > most) break;
        t += step;
    }
    result.x = at.x + at.x * (at.y * step);
    result.y = at.y - at.y * (at.x * step);
    result.ln_x = vmi_two_sum(at.ln_x.hi, at.ln_x.lo + at.y * step);
    result.ln_y = vmi_two_sum(at.ln_y.hi, at.ln_y.lo - at.x * step);
    return result;
}

/* Returns the point where I_x(a, b) = p, for p > 0, q > 0 and p + q = 1, from the smaller of p and q */
VM_API vmi_beta_point vmi_beta_invert_both(vm_real p, vm_real q, vm_real a, vm_real b)
{
    if (p <= q) return vmi_beta_invert(vmi_log(p), a, b);
    return vmi_beta_mirrored(vmi_beta_invert(vmi_log(q), b, a));
}

/* The inverse of ateb_beta_inc_both: x with I_x(a, b) = p, and y = 1 - x and ln x. They are computed from p and
   q = 1 - p; the smaller of p and q carries the digits. ln x is also right where x underflows. For a and b from 1e-3 to
   1e4 the errors of x, y and ln x are at most 16 ulp plus the changes that one ulp of the smaller of p and q makes. a
   and b may also lie between 1e-4 and 1e5, where the function is less accurate and slower. The results are NaN for
   other a or b, for p or q below 0, and if p + q is not 1. docs/cost.md has the time. */
VM_API void ateb_beta_inc_inv_both(vm_real p, vm_real q, vm_real a, vm_real b, vm_real *x, vm_real *y,
                                   vm_real *ln_x)
{
    vmi_beta_point at;
    *x = VM_NAN;
    *y = VM_NAN;
    *ln_x = VM_NAN;
    if (!vmi_beta_is_in_domain(a, b) || !vmi_beta_is_split_of_1(p, q)) return;
    if (p == 0) {
        *x = 0;
        *y = 1;
        *ln_x = -VM_INFINITY;
    } else if (q == 0) {
        *x = 1;
        *y = 0;
        *ln_x = 0;
    } else {
        at = vmi_beta_invert_both(p, q, a, b);
        *x = at.x;
        *y = at.y;
        *ln_x = at.ln_x.hi;
    }
}

/* The inverse of ateb_beta_inc: x with I_x(a, b) = p, for 0 <= p <= 1.
   Domain and accuracy are those of ateb_beta_inc_inv_both. */
VM_API vm_real ateb_beta_inc_inv(vm_real p, vm_real a, vm_real b)
{
    vm_real x, y, ln_x;
    ateb_beta_inc_inv_both(p, 1 - p, a, b, &x, &y, &ln_x);
    return x;
}

/* The mean of |sa|^p |ca|^q over a period, for alpha >= 0 and p, q > -1. Averaged equations of oscillators need this
   mean. alpha may be up to 1e30, p and q up to 1e6; for larger ones the result is NaN. The error is at most 2 ulp.
   Equation (316). */
VM_API vm_real ateb_mean(vm_real alpha, vm_real p, vm_real q)
{
    const vm_real largest_alpha = VM_C(1e30), largest_power = VM_C(1e6);
    const vm_two half = {VM_C(0.5), 0}, one = {1, 0};
    vm_two n, ln_above, ln_below, ln_mean;
    if (!(alpha >= 0) || !(alpha <= largest_alpha)) return VM_NAN;
    if (!(p > -1) || !(q > -1) || !(p <= largest_power) || !(q <= largest_power)) return VM_NAN;
    n = vmi_two_sum(alpha, 1);
    ln_above = vmi_beta_ln(vmi_half(vmi_two_sum(p, 1)), vmi_two_over(vmi_two_sum(q, 1), n));
    ln_below = vmi_beta_ln(half, vmi_two_over(one, n));
    ln_mean = vmi_two_plus(ln_above, vmi_minus(ln_below));
    return vmi_exp(ln_mean.hi, ln_mean.lo);
}

#endif
