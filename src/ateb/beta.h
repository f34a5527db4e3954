/* ateb/beta.h - beta functions, and mean values of sa and ca

   B(a, b) is the complete beta function, and I_x(a, b) the regularised incomplete beta function, which lies between 0
   and 1. Ateb functions are inverses of incomplete beta functions, and their mean values are quotients of complete beta
   functions (316).

       vm_real p = ateb_beta_inc(VM_C(0.3), VM_C(0.5), 2); // I_0.3(0.5, 2)

   In this file p stands for I_x(a, b), q for 1 - p, and y for 1 - x. A function with the suffix _both takes y too and
   returns q too: if x or p is close to 1, a computed difference 1 - x or 1 - p has lost digits.

   Method: the functions are computed from logarithms in two words, by Stirling's formula, which needs numbers of at
   least 6. Let A = a + i, where i is 6 for a < 6 and 0 for any other a. In the same way let B = b + j and
   S = a + b + k, where j and k are 0 or 6, so that A, B and S are at least 6. Then Stirling's formula gives
     ln(x^a y^b/B(a, b)) = a ln x + b ln y + (a + k - j) ln S/A + (b + k - i) ln S/B
                           + (k - i - j + 1/2) ln(A B/S) + (i + j - k) - ln(2 pi)/2
                           + delta(S) - delta(A) - delta(B) + ln((a)_i (b)_j/(a+b)_k)
   where delta is the remainder of Stirling's formula (vmi_beta_stirling) and (a)_i = a (a + 1) ... (a + i - 1). If this
   sum is not large, it contains no large terms that cancel each other. The products (a)_i, (b)_j and (a+b)_k neither
   overflow nor underflow, since each of them has at most 6 factors. The function vmi_beta_density computes
   x^a y^b/B(a, b) without this sum, in less time and with an error of a few ulp.

   Source of the continued fraction (vmi_beta_fraction): Didonato and Morris, Algorithm 708, ACM TOMS 18 (1992). Tests:
   tests/test_ateb.c. */
#ifndef VARMASS_ATEB_BETA_H
#define VARMASS_ATEB_BETA_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* Returns delta(z) = ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2 for z >= 6, from by_z = 1/z. The product z delta(z)
   is computed by a polynomial in 1/z^2, which is equal to z delta(z) at Chebyshev's points. The polynomial has a
   relative error of 2^-60 (float 2^-34) and fewer terms than Stirling's series. */
VM_INLINE vm_real vmi_beta_stirling(vm_real by_z)
{
    const vm_real w = by_z * by_z, ww = w * w;
#if VM_MANT_DIG > 24
    const vm_real c12 = VM_C(-0.0027777777777775510905) + w * VM_C(7.9365079343166191487e-4);
    const vm_real c34 = VM_C(-5.9523801316430247565e-4) + w * VM_C(8.417353128972759356e-4);
    const vm_real c56 = VM_C(-0.0019158553219707499218) + w * VM_C(0.0063022220719276690833);
    const vm_real c78 = VM_C(-0.025300456155614599805) + w * VM_C(0.079449609966698245323);
    const vm_real sum = (c12 + ww * c34) + (ww * ww) * (c56 + ww * c78);
#else
    const vm_real sum = VM_C(-0.00277777376716) + w * (VM_C(7.92921561308e-4) - w * VM_C(5.52149873404e-4));
    (void)ww;
#endif
    return by_z * (VM_C(0.083333333333333333295) + w * sum);
}

/* Returns (z)_i = z (z + 1) ... (z + i - 1), where i is 6 for z < 6 and 0 for any other z. *count becomes i, and *z
   becomes z + i. For i = 6 the product is computed as p (p + 4) (p + 6) with p = z (z + 5). */
VM_API vm_two vmi_beta_rise(vm_two *z, int *count)
{
    vm_two product = {1, 0}, p;
    *count = 0;
    if (!(z->hi < 6)) return product;
    *count = 6;
    p = vmi_two_times(*z, vmi_two_plus(*z, vmi_two(5, 0)));
    product = vmi_two_times(vmi_two_plus(p, vmi_two(4, 0)), vmi_two_plus(p, vmi_two(6, 0)));
    *z = vmi_two_plus(*z, vmi_two(6, 0));
    return vmi_two_times(product, p);
}

/* Returns ln(x^a y^b/B(a, b)), by the formula at the top of this file. */
VM_API vm_two vmi_beta_ln_density(vm_two a, vm_two b, vm_two ln_x, vm_two ln_y)
{
#if VM_MANT_DIG > 24
    const vm_two half_ln_2pi = {VM_C(-0.91893853320467278056), VM_C(3.8782941580672414498e-17)};
#else
    const vm_two half_ln_2pi = {VM_C(-0.9189385175705), VM_C(-1.5634176619983e-8)};
#endif
    vm_two A = a, B = b, S = vmi_two_plus(a, b), rise, rise_a, rise_b, rise_s, ln_SA, ln_SB, sum;
    vm_real delta;
    int i, j, k;
    /* (a)_i (b)_j/(S)_k, where (a)_i (b)_j alone, or the smaller of them divided by (S)_k, may underflow in float */
    rise_a = vmi_beta_rise(&A, &i);
    rise_b = vmi_beta_rise(&B, &j);
    rise_s = vmi_beta_rise(&S, &k);
    if (a.hi < b.hi) rise = vmi_two_times(vmi_two_over(rise_b, rise_s), rise_a);
    else rise = vmi_two_times(vmi_two_over(rise_a, rise_s), rise_b);
    ln_SA = vmi_two_log(vmi_two_over(S, A));
    ln_SB = vmi_two_log(vmi_two_over(S, B));
    sum = vmi_two_scaled(vmi_two_log(vmi_two_times(A, vmi_two_over(B, S))), (vm_real)(k - i - j) + VM_C(0.5));
    sum = vmi_two_plus(sum, vmi_two_plus(half_ln_2pi, vmi_two((vm_real)(i + j - k), 0)));
    sum = vmi_two_plus(sum, vmi_two_log(rise));
    sum = vmi_two_plus(sum, vmi_two_scaled(ln_SA, (vm_real)(k - j)));
    sum = vmi_two_plus(sum, vmi_two_scaled(ln_SB, (vm_real)(k - i)));
    sum = vmi_two_plus(sum, vmi_two_plus(vmi_two_times(vmi_two_plus(ln_x, ln_SA), a),
                                         vmi_two_times(vmi_two_plus(ln_y, ln_SB), b)));
    delta = vmi_beta_stirling(1 / S.hi) - vmi_beta_stirling(1 / A.hi) - vmi_beta_stirling(1 / B.hi);
    return vmi_two_sum(sum.hi, sum.lo + delta);
}

/* Returns ln B(a, b). */
VM_API vm_two vmi_beta_ln(vm_two a, vm_two b)
{
    const vm_two none = {0, 0};
    return vmi_minus(vmi_beta_ln_density(a, b, none, none));
}

/* Returns 1 if a and b lie between 1e-4 and 1e5, else 0. Outside these limits the series and continued fractions would
   need too many terms, and in float the results would have no right digits. */
VM_API int vmi_beta_is_in_domain(vm_real a, vm_real b)
{
    return a >= VM_C(1e-4) && a <= VM_C(1e5) && b >= VM_C(1e-4) && b <= VM_C(1e5);
}

/* Returns the limit of B(a, b) where a or b is 0 or infinite, and NaN where there is no limit. */
VM_API vm_real vmi_beta_limit(vm_real a, vm_real b)
{
    const int is_zero = a == 0 || b == 0, is_infinite = a == VM_INFINITY || b == VM_INFINITY;
    if (!(a >= 0) || !(b >= 0) || is_zero == is_infinite) return VM_NAN;
    if (is_zero) return VM_INFINITY;
    return 0;
}

/* The complete beta function B(a, b), for a and b from 1e-4 to 1e5.
   The error is at most 1 ulp. If a or b is 0 or infinite, the result is the limit: infinity if a or b is 0 and neither
   is infinite, and 0 if a or b is infinite and neither is 0. Returns NaN for other a or b. Equation (261). */
VM_API vm_real ateb_beta(vm_real a, vm_real b)
{
    vm_two l;
    if (!vmi_beta_is_in_domain(a, b)) return vmi_beta_limit(a, b);
    l = vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0));
    return vmi_exp(l.hi, l.lo);
}

/* The logarithm of the complete beta function, ln B(a, b), for a and b from 1e-30 to 1e30.
   B(a, b) itself may overflow or underflow. The error is at most 1 ulp plus 2^-57 (float 2^-28). The second term is
   important only where B is close to 1, so that ln B is close to 0. If a or b is 0 or infinite, the result is the
   logarithm of the limit that ateb_beta returns. Returns NaN for other a or b. */
VM_API vm_real ateb_ln_beta(vm_real a, vm_real b)
{
    const vm_real least = VM_C(1e-30), largest = VM_C(1e30);
    const vm_real limit = vmi_beta_limit(a, b);
    if (limit > 0) return VM_INFINITY;
    if (limit == 0) return -VM_INFINITY;
    if (!(a >= least) || !(b >= least) || !(a <= largest) || !(b <= largest)) return VM_NAN;
    return vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0)).hi;
}

/* The numbers from which the gamma function of z > 0 is computed, and by_Z = 1/Z. Z is z + i, where i is 6 for z < 6
   and 0 for any other z. The formulas are
     Gamma(z) = sqrt(2 pi) Z^(z - 1/2) e^(delta - z)/factor, factor = (z)_i e^i/Z^i, delta = vmi_beta_stirling(1/Z) */
typedef struct VM_TAG(vmi_beta_gamma) {
    vm_two Z;
    vm_real by_Z, factor, delta;
} vmi_beta_gamma;

/* Returns the numbers of vmi_beta_gamma for z. `rest` is 1 - Z by_Z, the remainder of the division 1/Z; the two largest
   of its four products are exact. The function tests z < 6 without a branch, since the processor would mispredict this
   branch half the time. */
VM_INLINE vmi_beta_gamma vmi_beta_gamma_of(vm_two z)
{
    const vm_real e6 = VM_C(403.42879349273512), t = z.hi, shifted = (vm_real)(t < 6);
    const vm_real rise = (t * (t + 5)) * (((t + 1) * (t + 4)) * ((t + 2) * (t + 3)));
    vmi_beta_gamma g;
    vm_real cube, head, by_head, rest;
    g.Z = vmi_two_sum(t, 6 * shifted);
    g.Z.lo += z.lo;
    g.by_Z = 1 / g.Z.hi;
    head = vmi_head(g.Z.hi);
    by_head = vmi_head(g.by_Z);
    rest = ((1 - head * by_head) - (g.Z.hi - head) * by_head) - g.Z.hi * (g.by_Z - by_head) - g.Z.lo * g.by_Z;
    cube = g.by_Z * g.by_Z * g.by_Z;
    g.factor = shifted * ((rise * cube) * (e6 * cube) * (1 + 6 * rest)) + (1 - shifted);
    g.delta = vmi_beta_stirling(g.by_Z);
    return g;
}

/* Returns ln(x S/A) in two words. t is the rounded quotient x S/A, and `lost` is x S - t A, which the rounding causes.
   The result is ln t, corrected by `lost`. The processor can compute ln t and `lost` at the same time. */
VM_INLINE vm_two vmi_beta_ln_quotient(vm_two x, vm_two S, const vmi_beta_gamma *A)
{
    const vm_real t = (x.hi * S.hi) * A->by_Z;
    const vm_two above = vmi_two_product(x.hi, S.hi), below = vmi_two_product(t, A->Z.hi);
    const vm_real lost = (above.hi - below.hi) + ((above.lo - below.lo) + (x.hi * S.lo + x.lo * S.hi - t * A->Z.lo));
    const vm_two l = vmi_log(t);
    return vmi_two(l.hi, l.lo + lost / above.hi);
}

/* Returns x^a y^b/B(a, b) for numbers x and y in two words with the sum 1. The relative error is a few ulp, unless x or
   y is close to the smallest number. Let A, B and S be the fields Z of vmi_beta_gamma for a, b and a + b. The fields
   factor and delta have the suffixes _a, _b and _s for a, b and a + b. Then the result is
     (x S/A)^a (y S/B)^b sqrt(A B/(2 pi S)) factor_a factor_b/factor_s e^(delta_s - delta_a - delta_b). */
VM_API vm_real vmi_beta_density(vm_two x, vm_two y, vm_real a, vm_real b)
{
    const vm_real by_2pi = VM_C(0.15915494309189533577);
    const vmi_beta_gamma A = vmi_beta_gamma_of(vmi_two(a, 0)), B = vmi_beta_gamma_of(vmi_two(b, 0));
    const vmi_beta_gamma S = vmi_beta_gamma_of(vmi_two_sum(a, b));
    const vm_real root = VM_SQRT(A.Z.hi * (B.Z.hi * S.by_Z) * by_2pi);
    const vm_two power_x = vmi_two_scaled(vmi_beta_ln_quotient(x, S.Z, &A), a);
    const vm_two power_y = vmi_two_scaled(vmi_beta_ln_quotient(y, S.Z, &B), b);
    vm_two sum = vmi_two_sum(power_x.hi, power_y.hi);
    sum = vmi_two_sum(sum.hi, sum.lo + (power_x.lo + power_y.lo) + (S.delta - A.delta - B.delta));
    return vmi_exp(sum.hi, sum.lo) * (root * (A.factor * B.factor / S.factor));
}

/* The continued fraction of Didonato and Morris, f_n = C_n + D_n/f_(n+1), at x and y = 1 - x. vmi_beta_level computes
   C_n and D_n, the numbers of level n. excess is a y - b x. */
typedef struct VM_TAG(vmi_beta_levels) {
    vm_real x, y, a, b, excess;
} vmi_beta_levels;

/* Sets the fields of vmi_beta_levels. Where a and b are large, digits cancel in the difference a y - b x; therefore it
   is computed in two words, from the smaller of x and y. */
VM_INLINE vmi_beta_levels vmi_beta_levels_of(vm_real x, vm_real y, vm_real a, vm_real b)
{
    const vm_two product = vmi_two_scaled(vmi_two_sum(a, b), vmi_smaller(x, y));
    vmi_beta_levels levels;
    levels.x = x;
    levels.y = y;
    levels.a = a;
    levels.b = b;
    levels.excess = (product.hi - b) + product.lo;
    if (x <= y) levels.excess = (a - product.hi) - product.lo;
    return levels;
}

/* Computes C_n and D_n, the numbers of level n. `before` is 1/(a + 2 n - 1), or any number for n = 0, and `after` is
   1/(a + 2 n + 1). */
VM_INLINE void vmi_beta_level(const vmi_beta_levels *l, vm_real n, vm_real before, vm_real after, vm_real *C,
                              vm_real *D)
{
    const vm_real an = l->a + n, share = l->x * after, next = n + 1;
    *C = n * (1 + (l->b - n) * l->x * before) + an * ((l->excess + 1) + n * (1 + l->y)) * after;
    *D = ((an * share) * ((an + l->b) * share)) * (next * (l->b - next));
}

/* Returns 1/f_0, where f_0 is the continued fraction of vmi_beta_levels with the levels 0 ... count. The evaluation
   begins with a rough value of f_(count+1) and goes down to level 0. A rough value is enough, since an error of f_(n+1)
   hardly changes f_n. */
VM_API vm_real vmi_beta_backward(const vmi_beta_levels *l, int count)
{
    vm_real f = (l->a + (vm_real)count) / 2, before, after = 1 / (l->a + 2 * (vm_real)count + 1), C, D;
    int n;
    for (n = count; n >= 0; n--) {
        before = 0;
        if (n > 0) before = 1 / (l->a + 2 * (vm_real)n - 1);
        vmi_beta_level(l, (vm_real)n, before, after, &C, &D);
        f = C + D / f;
        after = before;
    }
    return 1 / f;
}

/* The tolerance for which the result of vmi_beta_fraction has all its digits */
#define VMI_BETA_FULL (2 * VM_EPSILON)

/* A tolerance below VMI_BETA_FULL, for which vmi_beta_fraction always evaluates the fraction from its last level */
#define VMI_BETA_FINE VM_EPSILON

/* Returns 1/f_0 = I_x(a, b) B(a, b)/(x^a y^b) for x <= (a + 1)/(a + b + 2), with a relative error of about
   `tolerance`. The convergents P/Q of the fraction, which are its values after 1, 2, 3, ... levels, are computed two at
   a time, until two of them agree within the tolerance. Rounding errors add up in P and Q; therefore a fraction of more
   than SAFE levels is evaluated once more by vmi_beta_backward, from its last level. */
VM_API vm_real vmi_beta_fraction(vm_real x, vm_real y, vm_real a, vm_real b, vm_real tolerance)
{
    enum { MOST = 20000, SAFE = 20 }; /* MOST is a precaution: some 250 levels are enough, and a NaN ends the loop */
    const vmi_beta_levels l = vmi_beta_levels_of(x, y, a, b);
    vm_real P0 = 1, Q0 = 0, P1, Q1 = 1, P2, Q2, C, D, D_next, last, ratio = 0, before, after = 1 / (a + 1);
    int levels = 0;
    vmi_beta_level(&l, 0, 0, after, &P1, &D);
    do {
        const vm_real n = (vm_real)levels;
        before = after;
        after = 1 / (a + 2 * n + 3);
        vmi_beta_level(&l, n + 1, before, after, &C, &D_next);
        P2 = C * P1 + D * P0;
        Q2 = C * Q1 + D * Q0;
        before = after;
        after = 1 / (a + 2 * n + 5);
        vmi_beta_level(&l, n + 2, before, after, &C, &D);
        P1 = 1 / (C * P2 + D_next * P1); /* from here on, all four numbers are divided by the new P */
        Q1 = (C * Q2 + D_next * Q1) * P1;
        P0 = P2 * P1;
        Q0 = Q2 * P1;
        P1 = 1;
        last = ratio;
        ratio = Q1;
        levels += 2;
    } while (VM_FABS(ratio - last) > tolerance * ratio && levels < MOST);
    if (levels > SAFE || tolerance < VMI_BETA_FULL) return vmi_beta_backward(&l, levels);
    return ratio;
}

/* Returns I_x(a, b) a B(a, b)/x^a - 1 for a <= 1, x <= 2/3 and b x < 2. The result is a times the sum over n >= 1 of
   (1 - b)_n/n! x^n/(a + n), where (z)_n = z (z + 1) ... (z + n - 1). Term n is below the larger of x^n and (b x)^n/n!,
   so that the terms soon become small. */
VM_API vm_real vmi_beta_series(vm_real x, vm_real a, vm_real b)
{
    const vm_real most = 200; /* a precaution: 96 terms are enough, and a NaN ends the loop at once */
    vm_real power = 1, term, sum = 0, n = 0;
    do {
        n += 1;
        power *= x * (n - b) / n;
        term = power / (a + n);
        sum += term;
    } while (VM_FABS(term) > VM_EPSILON / 8 * VM_FABS(sum) && n < most);
    return a * sum;
}

/* Returns ln(1 - e^l) for l < 0, where e^l = 2^k (1 + p) with an integer k. If k = 0, the number 1 - e^l is -p, so that
   no digits are lost. */
VM_API vm_two vmi_ln_one_minus_exp(vm_two l)
{
    vm_two rest = {0, 0};
    vm_real p, p_lo;
    int k;
    if (!(l.hi >= -2 * VM_C(0.6931471805599453) * VM_MANT_DIG)) { /* the result is -e^l, which is tiny, or NaN */
        rest.hi = -vmi_exp(l.hi, l.lo);
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

/* Returns the point with x and y exchanged. */
VM_API vmi_beta_point vmi_beta_mirrored(vmi_beta_point at)
{
    vmi_beta_point mirrored;
    mirrored.x = at.y;
    mirrored.y = at.x;
    mirrored.ln_x = at.ln_y;
    mirrored.ln_y = at.ln_x;
    return mirrored;
}

/* Returns ln I_x(a, b) at the point `at`, for x <= (a + 1)/(a + b + 2), where ln_density = ln(x^a y^b/B(a, b)). Where a
   is small, I_x is close to 1, and the caller also computes 1 - I_x from the result. Therefore the function uses
   vmi_beta_series for a <= 1: this series loses no digits. It does not need the factor y^b of the density. */
VM_API vm_two vmi_beta_ln_tail(vmi_beta_point at, vm_real a, vm_real b, vm_two ln_density)
{
    vm_two f;
    if (a <= 1) {
        f = vmi_two_plus(vmi_two_log(vmi_two_sum(1, vmi_beta_series(at.x, a, b))), vmi_minus(vmi_log(a)));
        f = vmi_two_plus(f, vmi_two_scaled(at.ln_y, -b));
    } else f = vmi_log(vmi_beta_fraction(at.x, at.y, a, b, VMI_BETA_FINE));
    return vmi_two_plus(ln_density, f);
}

/* Computes *ln_p = ln I_x(a, b) and *ln_q = ln I_y(b, a), where y = 1 - x, from ln_density = ln(x^a y^b/B(a, b)). For
   x <= (a + 1)/(a + b + 2) *ln_p is computed directly, for a larger x *ln_q is computed directly. The other logarithm
   follows from p + q = 1. */
VM_API void vmi_beta_tails(const vmi_beta_point *at, vm_real a, vm_real b, vm_two ln_density, vm_two *ln_p,
                           vm_two *ln_q)
{
    if (at->x * (a + b + 2) <= a + 1) {
        *ln_p = vmi_beta_ln_tail(*at, a, b, ln_density);
        *ln_q = vmi_ln_one_minus_exp(*ln_p);
    } else {
        *ln_q = vmi_beta_ln_tail(vmi_beta_mirrored(*at), b, a, ln_density);
        *ln_p = vmi_ln_one_minus_exp(*ln_q);
    }
}

/* Returns 1 if x and y are not negative and add up to 1, apart from rounding, else 0. */
VM_API int vmi_beta_is_split_of_1(vm_real x, vm_real y)
{
    return x >= 0 && y >= 0 && VM_FABS((x + y) - 1) <= 4 * VM_EPSILON;
}

/* Computes ln I_x(a, b) and ln I_y(b, a) for x and y = 1 - x in two words. */
VM_API void vmi_beta_logarithms(vm_two x, vm_two y, vm_real a, vm_real b, vm_two *ln_p, vm_two *ln_q)
{
    vmi_beta_point at;
    vm_two ln_density;
    at.x = x.hi;
    at.y = y.hi;
    at.ln_x = vmi_two_log(x);
    at.ln_y = vmi_two_log(y);
    ln_density = vmi_beta_ln_density(vmi_two(a, 0), vmi_two(b, 0), at.ln_x, at.ln_y);
    vmi_beta_tails(&at, a, b, ln_density, ln_p, ln_q);
}

/* If a or b is 0 or infinite, the limit of I_x(a, b) jumps from 0 to 1 at one value of x. Returns -1 if this jump is at
   x = 0, and 1 if it is at x = 1. Returns 0 for other a and b, and if there is no limit. */
VM_API int vmi_beta_limit_side(vm_real a, vm_real b)
{
    const int at_0 = a == 0 || b == VM_INFINITY, at_1 = b == 0 || a == VM_INFINITY;
    if (!(a >= 0) || !(b >= 0)) return 0;
    return at_1 - at_0;
}

/* The regularised incomplete beta function p = I_x(a, b) and q = 1 - p. Both are computed from the smaller of x and
   y = 1 - x: give this number with all its digits. For a and b from 1e-3 to 1e4 the errors of p and q are at most 30
   ulp each. a and b may also lie between 1e-4 and 1e5, where the function is less accurate and slower. If a or b is 0
   or infinite, p is the limit of I_x(a, b). This limit is 1 for x > 0 if a is 0 or b is infinite. It is 0 for x < 1 if
   b is 0 or a is infinite. If both conditions hold, as for a = b = 0, there is no limit. The results are NaN for other
   a or b, if there is no limit, if x or y is negative, and if x + y is not 1.
   docs/cost.md has the time of a call. DLMF 8.17, equation (273). */
VM_API void ateb_beta_inc_both(vm_real x, vm_real y, vm_real a, vm_real b, vm_real *p, vm_real *q)
{
    const vm_real longest = VM_C(0.6); /* 1 minus a larger tail would lose digits; then logarithms are used */
    const vm_real least = VM_MIN / (VM_EPSILON * VM_EPSILON); /* products with smaller numbers may underflow */
    vm_two x2 = vmi_two(x, 0), y2 = vmi_two(y, 0);
    vm_real tail, density;
    vm_two ln_p, ln_q;
    const int side = vmi_beta_limit_side(a, b);
    int left;
    *p = VM_NAN;
    *q = VM_NAN;
    if (!vmi_beta_is_split_of_1(x, y)) return;
    if ((side < 0 && x > 0) || (side > 0 && y > 0)) {
        *p = (vm_real)(side < 0);
        *q = (vm_real)(side > 0);
        return;
    }
    if (!vmi_beta_is_in_domain(a, b)) return;
    if (x == 0 || y == 0) {
        *p = (vm_real)(x != 0);
        *q = (vm_real)(x == 0);
        return;
    }
    if (x <= y) y2 = vmi_two_sum(1, -x);
    else x2 = vmi_two_sum(1, -y);
    left = x * (a + b + 2) <= a + 1;
    density = vmi_beta_density(x2, y2, a, b);
    if (left) tail = density * vmi_beta_fraction(x2.hi, y2.hi, a, b, VMI_BETA_FULL);
    else tail = density * vmi_beta_fraction(y2.hi, x2.hi, b, a, VMI_BETA_FULL);
    if (!(density > least) || !(vmi_smaller(x, y) > least) || tail > longest) {
        vmi_beta_logarithms(x2, y2, a, b, &ln_p, &ln_q);
        *p = vmi_exp(ln_p.hi, ln_p.lo);
        *q = vmi_exp(ln_q.hi, ln_q.lo);
    } else {
        *p = 1 - tail;
        *q = tail;
        if (left) {
            *p = tail;
            *q = 1 - tail;
        }
    }
}

/* The regularised incomplete beta function I_x(a, b), for 0 <= x <= 1.
   Domain and accuracy are those of ateb_beta_inc_both. */
VM_API vm_real ateb_beta_inc(vm_real x, vm_real a, vm_real b)
{
    vm_real p, q;
    ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
    return p;
}

/* The logarithm of the regularised incomplete beta function, ln I_x(a, b), for 0 <= x <= 1.
   I_x itself may underflow. Domain and limits are those of ateb_beta_inc. For a and b from 1e-3 to 1e4 the error is at
   most 30 ulp. ln(1 - I_x(a, b)) is ln I_(1-x)(b, a). */
VM_API vm_real ateb_ln_beta_inc(vm_real x, vm_real a, vm_real b)
{
    const int side = vmi_beta_limit_side(a, b);
    vm_two ln_p, ln_q;
    if (!(x >= 0) || !(x <= 1)) return VM_NAN;
    if (side < 0 && x > 0) return 0;
    if (side > 0 && x < 1) return -VM_INFINITY;
    if (!vmi_beta_is_in_domain(a, b)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x == 1) return 0;
    vmi_beta_logarithms(vmi_two(x, 0), vmi_two_sum(1, -x), a, b, &ln_p, &ln_q);
    return ln_p.hi;
}

/* The signs by which ateb_mean_nm multiplies the powers. For both signs the two constants are added. */
enum { ATEB_SIGN_OF_SA = 1, ATEB_SIGN_OF_CA = 2 };

/* The mean of |sa(n, m, s)|^p |ca(m, n, s)|^q over a period, with or without the signs of sa and ca.
   The indices n and m of sa and ca lie between 0 and 1e30. The powers p and q are above -1 and at most 1e6. signs is 0,
   ATEB_SIGN_OF_SA, ATEB_SIGN_OF_CA or their sum. A power with the sign of its base, such as sa^3, is as often negative
   as positive, so that the mean is 0. For example, the mean of sa^2 ca^3 is ateb_mean_nm(n, m, 2, 3, ATEB_SIGN_OF_CA).
   The mean without signs is B((p+1)/(n+1), (q+1)/(m+1))/B(1/(n+1), 1/(m+1)), with an error of at most 2 ulp. Returns
   NaN for an argument outside these limits. Equation (316). */
VM_API vm_real ateb_mean_nm(vm_real n, vm_real m, vm_real p, vm_real q, int signs)
{
    const vm_real largest_index = VM_C(1e30), largest_power = VM_C(1e6);
    const vm_two one = {1, 0};
    vm_two n1, m1, ln_above, ln_below, ln_mean;
    if (!(n >= 0) || !(n <= largest_index) || !(m >= 0) || !(m <= largest_index)) return VM_NAN;
    if (!(p > -1) || !(q > -1) || !(p <= largest_power) || !(q <= largest_power)) return VM_NAN;
    if (signs < 0 || signs > ATEB_SIGN_OF_SA + ATEB_SIGN_OF_CA) return VM_NAN;
    if (signs != 0) return 0;
    n1 = vmi_two_sum(n, 1);
    m1 = vmi_two_sum(m, 1);
    ln_above = vmi_beta_ln(vmi_two_over(vmi_two_sum(p, 1), n1), vmi_two_over(vmi_two_sum(q, 1), m1));
    ln_below = vmi_beta_ln(vmi_two_over(one, n1), vmi_two_over(one, m1));
    ln_mean = vmi_two_plus(ln_above, vmi_minus(ln_below));
    return vmi_exp(ln_mean.hi, ln_mean.lo);
}

/* The mean of |sa|^p |ca|^q over a period, for alpha >= 0 and p, q > -1. Averaged equations of oscillators need this
   mean. alpha may be up to 1e30, p and q up to 1e6; for larger numbers the result is NaN. The error is at most 2 ulp.
   ateb_mean_nm computes means for two indices and with signs. Equation (316). */
VM_API vm_real ateb_mean(vm_real alpha, vm_real p, vm_real q) { return ateb_mean_nm(1, alpha, p, q, 0); }

#endif
