/* jacobi/carlson.h - Carlson's symmetric elliptic integrals R_F, R_C, R_D, R_J and R_G

   Every elliptic integral is a sum of a few of these five:
     R_F(x, y, z)    = 1/2 integral from 0 to infinity of dt/s(t),  s(t) = sqrt((t + x)(t + y)(t + z)),
     R_J(x, y, z, p) = 3/2 integral from 0 to infinity of dt/((t + p) s(t)),
     R_C(x, y)       = R_F(x, y, y),
     R_D(x, y, z)    = R_J(x, y, z, z),
   and R_G, which gives the surface of an ellipsoid. No digits are lost. One method computes R_F, R_D and R_J for all
   arguments, without special formulas for some of them (such as m near 1).

       vm_real K = jacobi_RF(0, VM_C(0.75), 1); // K(m) = R_F(0, 1 - m, 1)

   Method: Carlson's duplication replaces each of the arguments x, y, z by a quarter of its sum with
   lambda = sqrt(x y) + sqrt(y z) + sqrt(z x). R_F keeps its value, and the new arguments are closer together. From R_D
   and R_J each duplication splits off a known term. Duplications are made until a power series about the mean of the
   arguments is exact enough. The equations are those of Carlson, Numer. Algorithms 10 (1995) 13-26, with more terms of
   the series, so that usually two or three duplications are enough. R_C is an arctangent or a logarithm, and R_G is a
   sum of terms with R_F and R_D. Source: DLMF 19.15 to 19.36. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_CARLSON_H
#define VARMASS_JACOBI_CARLSON_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* The three arguments of an integral, which duplications bring together. Each duplication makes the distances of the
   arguments from their mean, divided by the mean, about 4 times smaller. */
typedef struct VM_TAG(vmi_carlson) {
    vm_real x, y, z; /* the arguments */
    vm_real mean;    /* their mean (x + y + z)/3 */
    vm_real rest;    /* rounding error of the first mean, divided by 4 in each duplication: mean + rest is more exact */
    vm_real X, Y;    /* mean - x and mean - y; mean - z is -(X + Y) */
    vm_real a, b, c; /* the square roots of x, y, z in the last duplication */
    vm_real lambda;  /* a b + b c + c a in the last duplication */
} vmi_carlson;

/* The power series are used if each argument differs from the mean by at most this share of the mean. The largest terms
   that are left out have the degree 11 (float 5) in these differences; they are below 1e-17 (float 4e-9). */
#define VMI_CARLSON_CLOSE VM_C(0.0262)

/* Returns the numbers of vmi_carlson before the first duplication of x, y, z. */
VM_INLINE vmi_carlson vmi_carlson_begin(vm_real x, vm_real y, vm_real z)
{
    const vm_two part = vmi_two_sum(x, y), sum = vmi_two_sum(part.hi, z);
    vmi_carlson s;
    s.x = x;
    s.y = y;
    s.z = z;
    s.mean = sum.hi * VM_C(0.3333333333333333333);
    s.rest = (((sum.hi - 2 * s.mean) - s.mean) + (sum.lo + part.lo)) * VM_C(0.3333333333333333333);
    s.X = s.mean - x;
    s.Y = s.mean - y;
    s.a = s.b = s.c = s.lambda = 0;
    return s;
}

/* Returns the largest of the distances of x, y and z from their mean. */
VM_INLINE vm_real vmi_carlson_spread(const vmi_carlson *s)
{
    return vmi_larger(vmi_larger(VM_FABS(s->X), VM_FABS(s->Y)), VM_FABS(s->X + s->Y));
}

/* Makes one duplication (DLMF 19.26.18): replaces x by (x + lambda)/4, and y and z in the same way. No digits are lost,
   since no term is negative. */
VM_INLINE void vmi_carlson_duplicate(vmi_carlson *s)
{
    s->a = VM_SQRT(s->x);
    s->b = VM_SQRT(s->y);
    s->c = VM_SQRT(s->z);
    s->lambda = s->a * (s->b + s->c) + s->b * s->c;
    s->x = (s->x + s->lambda) * VM_C(0.25);
    s->y = (s->y + s->lambda) * VM_C(0.25);
    s->z = (s->z + s->lambda) * VM_C(0.25);
    s->mean = (s->mean + s->lambda) * VM_C(0.25);
    s->rest *= VM_C(0.25);
    s->X *= VM_C(0.25);
    s->Y *= VM_C(0.25);
}

/* Computes E2 = XY + YZ + ZX and E3 = XYZ. Here X, Y and Z are the differences mean - x, mean - y and mean - z, divided
   by the mean, so that X + Y + Z is 0. */
VM_INLINE void vmi_carlson_symmetric(const vmi_carlson *s, vm_real *E2, vm_real *E3)
{
    const vm_real per_mean = 1 / s->mean, X = s->X * per_mean, Y = s->Y * per_mean, Z = -(X + Y);
    *E2 = X * Y - Z * Z;
    *E3 = X * Y * Z;
}

/* Returns R_F from arguments that are close together. R_F is the sum over N >= 0 of t_N/(2N + 1), divided by the square
   root of the mean. Here t_N is the coefficient of s^N in the power series of (1 + E2 s^2 - E3 s^3)^(-1/2), with E2 and
   E3 of vmi_carlson_symmetric (DLMF 19.19.7). */
VM_INLINE vm_real vmi_carlson_first(const vmi_carlson *s)
{
    vm_real E2, E3, low, high = 0;
    vmi_carlson_symmetric(s, &E2, &E3);
    low = VM_C(0.07142857142857142857) * E3 - VM_C(0.1) * E2;
    low += E2 * (VM_C(0.04166666666666666667) * E2);
#if VM_MANT_DIG > 24
    {
        const vm_real E22 = E2 * E2, E33 = E3 * E3;
        const vm_real five = VM_C(-0.06818181818181818182) * (E2 * E3);                                 /* -3/44 */
        const vm_real six = VM_C(0.02884615384615384615) * E33 - VM_C(0.02403846153846153846) * (E22 * E2);
        const vm_real seven = VM_C(0.0625) * (E22 * E3);                                                /* 1/16 */
        const vm_real eight = E2 * (VM_C(0.01608455882352941176) * (E22 * E2) - VM_C(0.05514705882352941176) * E33);
        const vm_real nine = E3 * (VM_C(0.01644736842105263158) * E33 - VM_C(0.05756578947368421053) * (E22 * E2));
        const vm_real ten = E22 * (VM_C(0.078125) * E33 - VM_C(0.01171875) * (E22 * E2));
        high = (five + six) + ((seven + eight) + (nine + ten));
    }
#endif
    low -= s->rest / (2 * s->mean);
    return (1 + (low + high)) / VM_SQRT(s->mean);
}

/* Returns the product of `power` and R_J/3 from arguments x, y, z and p that are close together. The mean is that of x,
   y and z, and P is 1 - p/mean. R_J/3 is the sum over N >= 0 of T_N/(2N + 3), divided by mean^(3/2). Here T_N is the
   coefficient of s^N in the power series of (1 + E2 s^2 - E3 s^3)^(-1/2)/(1 - P s). `power` is divided by the mean
   first, because mean^(3/2) alone underflows if p was much larger than x, y and z before the duplications. */
VM_INLINE vm_real vmi_carlson_third(const vmi_carlson *s, vm_real P, vm_real power)
{
    vm_real E2, E3, t, T, sum;
    vmi_carlson_symmetric(s, &E2, &E3);
    T = P;
    sum = VM_C(0.6) * T;
    t = VM_C(-0.5) * E2;
    T = P * T + t;
    sum += VM_C(0.4285714285714285714) * T;
    t = VM_C(0.5) * E3;
    T = P * T + t;
    sum += VM_C(0.3333333333333333333) * T;
    t = VM_C(0.375) * (E2 * E2);
    T = P * T + t;
    sum += VM_C(0.2727272727272727273) * T;
#if VM_MANT_DIG > 24
    {
        const vm_real E22 = E2 * E2, E33 = E3 * E3, E222 = E22 * E2;
        T = P * T - VM_C(0.75) * (E2 * E3);
        sum += VM_C(0.2307692307692307692) * T;
        T = P * T + (VM_C(0.375) * E33 - VM_C(0.3125) * E222);
        sum += VM_C(0.2) * T;
        T = P * T + VM_C(0.9375) * (E22 * E3);
        sum += VM_C(0.1764705882352941176) * T;
        T = P * T + E2 * (VM_C(0.2734375) * E222 - VM_C(0.9375) * E33);
        sum += VM_C(0.1578947368421052632) * T;
        T = P * T + E3 * (VM_C(0.3125) * E33 - VM_C(1.09375) * E222);
        sum += VM_C(0.1428571428571428571) * T;
        T = P * T + E22 * (VM_C(1.640625) * E33 - VM_C(0.24609375) * E222);
        sum += VM_C(0.1304347826086956522) * T;
    }
#endif
    sum -= VM_C(1.5) * s->rest / s->mean;
    return (1 + sum) * (power / s->mean) / (3 * VM_SQRT(s->mean));
}

/* Returns R_F(x, y, z), within 5 ulp, for arguments >= 0 of which at most one is 0. */
VM_INLINE vm_real vmi_rf(vm_real x, vm_real y, vm_real z)
{
    vmi_carlson s = vmi_carlson_begin(x, y, z);
    vm_real spread = vmi_carlson_spread(&s);
    while (spread > VMI_CARLSON_CLOSE * s.mean) {
        vmi_carlson_duplicate(&s);
        spread *= VM_C(0.25);
    }
    return vmi_carlson_first(&s);
}

/* Adds a term to a sum. The rounding errors of the sum are collected in its low word. */
VM_INLINE void vmi_carlson_add(vm_two *sum, vm_real term)
{
    const vm_two more = vmi_two_sum(sum->hi, term);
    sum->hi = more.hi;
    sum->lo += more.lo;
}

/* Returns R_F(x, y, z), and R_D(x, y, z)/3 in *third, for x, y >= 0, of which at most one is 0, and z > 0. The same
   duplications serve both integrals. Each duplication adds a positive term to R_D/3, which is 1/(c (z + lambda)) times
   a power of 1/4 (DLMF 19.26.20); z + lambda is computed as (c + a)(c + b), with the fields a, b, c of vmi_carlson. */
VM_INLINE vm_real vmi_rf_rd(vm_real x, vm_real y, vm_real z, vm_real *third)
{
    vmi_carlson s = vmi_carlson_begin(x, y, z);
    vm_real spread = vmi_carlson_spread(&s), power = 1;
    vm_two sum = vmi_two(0, 0);
    while (spread > VMI_CARLSON_CLOSE * s.mean) {
        vmi_carlson_duplicate(&s);
        spread *= VM_C(0.25);
        vmi_carlson_add(&sum, power / (s.c * vmi_two_times(vmi_two_sum(s.c, s.a), vmi_two_sum(s.c, s.b)).hi));
        power *= VM_C(0.25);
    }
    *third = sum.hi + (sum.lo + vmi_carlson_third(&s, -(s.X + s.Y) / s.mean, power));
    return vmi_carlson_first(&s);
}

/* Returns R_C(1, 1 + e) for |e| <= 0.05 by its series 1 - e/3 + e^2/5 - ... */
VM_INLINE vm_real vmi_rc_series(vm_real e)
{
    const vm_real ee = e * e, e4 = ee * ee;
    const vm_real low = (VM_C(-0.3333333333333333333) + e * VM_C(0.2)) +
                        ee * (VM_C(-0.1428571428571428571) + e * VM_C(0.1111111111111111111));
#if VM_MANT_DIG > 24
    const vm_real middle = (VM_C(-0.09090909090909090909) + e * VM_C(0.07692307692307692308)) +
                           ee * (VM_C(-0.06666666666666666667) + e * VM_C(0.05882352941176470588));
    const vm_real high = VM_C(-0.05263157894736842105) + e * VM_C(0.04761904761904761905);
    return 1 + e * (low + e4 * (middle + e4 * high));
#else
    return 1 + e * (low - e4 * VM_C(0.09090909091));
#endif
}

/* Returns R_C(1, y) for y > 0 from both y and e = y - 1. Let r be sqrt(|e|). For y > 1 R_C(1, y) is arctan(r)/r. For
   y < 1 it is artanh(r)/r, which is computed as (ln(1 + r) - ln(y)/2)/r. For |e| < 0.18 these formulas would lose
   digits. There one duplication, which divides e by (1 + sqrt(y))^2, makes e small enough for the series of
   vmi_rc_series. */
VM_API vm_real vmi_rc_of_1(vm_real y, vm_real e)
{
    vm_real root;
    if (VM_FABS(e) < VM_C(0.18)) {
        const vm_real both = 1 + VM_SQRT(y);
        return 2 * vmi_rc_series(e / (both * both)) / both;
    }
    root = VM_SQRT(VM_FABS(e));
    if (e > 0) return vmi_arctan(root, 1) / root;
    return (vmi_two_log(vmi_two_sum(1, root)).hi - vmi_log(y).hi / 2) / root;
}

/* Returns R_C(x, y) for x >= 0 and y > 0 from x, y and e = y - x. If x, y and e have small relative errors, so has the
   result. */
VM_API vm_real vmi_rc_apart(vm_real x, vm_real y, vm_real e)
{
    if (e > x) return vmi_arctan(VM_SQRT(e), VM_SQRT(x)) / VM_SQRT(e);
    return vmi_rc_of_1(y / x, e / x) / VM_SQRT(x);
}

/* Returns R_C(x, y) for x >= 0 and y != 0. For y < 0 it is Cauchy's principal value (DLMF 19.2.17, 19.2.20). */
VM_API vm_real vmi_rc(vm_real x, vm_real y)
{
    vm_real factor = 1;
    if (y < 0) {
        factor = VM_SQRT(x) / VM_SQRT(x - y);
        x -= y;
        y = -y;
    }
    return factor * vmi_rc_apart(x, y, y - x);
}

/* A large power of 4, 2^500 (float 2^42), and its square root. jacobi_RJ for p > 0, and vmi_rf_rj_weighted where it
   scales the arguments, bring the largest argument to about this power instead of 1. The power 3/2 of the smallest
   argument then does not underflow, even if the arguments differ much in size. */
#if VM_MANT_DIG > 24
#define VMI_RJ_LIFT VM_C(3.273390607896142e+150)
#define VMI_ROOT_OF_RJ_LIFT VM_C(1.8092513943330656e+75)
#else
#define VMI_RJ_LIFT VM_C(4398046511104.0)
#define VMI_ROOT_OF_RJ_LIFT VM_C(2097152.0)
#endif

/* Returns R_F(x, y, z), and R_J(x, y, z, p)/3 in *third, for p > 0 and arguments x, y, z >= 0 of which at most one is
   0. Each duplication adds 2/d R_C(1, 1 + e), times a power of 1/4, to R_J/3 (DLMF 19.26.21 and Carlson 1995). Here
   d = (r + a)(r + b)(r + c) and r = sqrt(p), with the fields a, b, c of vmi_carlson. d grows as the power 3/2 of the
   arguments, and must neither overflow nor underflow: the callers choose arguments of which the largest is between eps
   and about 2^600 (float 2^80). d is computed as r p + p (a + b + c) + r lambda + a b c, which has fewer rounding
   errors than the product. Both 1 + e = 2 r (p + lambda)/d and e = (r - a)(r - b)(r - c)/d are computed, so that
   neither loses digits. */
VM_API vm_real vmi_rf_rj(vm_real x, vm_real y, vm_real z, vm_real p, vm_real *third)
{
    vmi_carlson s = vmi_carlson_begin(x, y, z);
    vm_real P = s.mean - p, spread = vmi_larger(vmi_carlson_spread(&s), VM_FABS(P)), power = 1;
    vm_two sum = vmi_two(0, 0);
    while (spread > VMI_CARLSON_CLOSE * s.mean) {
        const vm_real r = VM_SQRT(p);
        vm_real d, per_d, e;
        vmi_carlson_duplicate(&s);
        d = r * p + (p * (s.a + s.b + s.c) + (r * s.lambda + s.a * s.b * s.c));
        per_d = 1 / d;
        e = (r - s.a) * ((r - s.b) * (r - s.c)) * per_d;
        p += s.lambda;
        vmi_carlson_add(&sum, 2 * power * per_d * vmi_rc_of_1(2 * r * p * per_d, e));
        p *= VM_C(0.25);
        P *= VM_C(0.25);
        spread *= VM_C(0.25);
        power *= VM_C(0.25);
    }
    *third = sum.hi + (sum.lo + vmi_carlson_third(&s, P / s.mean, power));
    return vmi_carlson_first(&s);
}

/* The scale of the arguments of an integral. The arguments are multiplied by `factor`, a power of 4 that brings the
   largest of them to a number between 1 and 8, so that no power of this argument overflows or underflows. R_F and R_C
   of the new arguments are then multiplied by `root`, the square root of the factor, which gives their original
   values. */
typedef struct VM_TAG(vmi_carlson_scale) {
    vm_real factor, root;
} vmi_carlson_scale;

/* Returns the scale for arguments of which the largest is `largest`, a finite number > 0. A subnormal number is not
   brought to 1, since the factor would overflow; the product of such a number and the factor is at least eps. */
VM_API vmi_carlson_scale vmi_carlson_scale_of(vm_real largest)
{
    const int exponent = (int)(vmi_to_bits(largest) >> VMI_STORED_DIG) - VMI_BIAS;
    const int half = exponent < 1 - VMI_BIAS ? -(VMI_BIAS / 2) : (exponent - 1) / 2;
    vmi_carlson_scale scale;
    scale.factor = vmi_ldexp(1, -2 * half);
    scale.root = vmi_ldexp(1, -half);
    return scale;
}

/* Returns R_F(x, y, z), and the product of `weight` and R_D(x, y, z)/3 in *third, for arguments of any size. `top` is
   the largest argument; where it is not between eps and 1/eps, the arguments are scaled first. (A caller that has
   scaled them already passes top = 1.) With scaling, the product is right even if R_D itself would overflow or
   underflow. Without scaling, the product has two words, so that it is not rounded before it is used. */
VM_API vm_real vmi_rf_rd_weighted(vm_real x, vm_real y, vm_real z, vm_real top, vm_two weight, vm_two *third)
{
    vmi_carlson_scale by;
    vm_real rf, rd;
    if (top > VM_EPSILON && top < 1 / VM_EPSILON) {
        rf = vmi_rf_rd(x, y, z, &rd);
        *third = vmi_two_scaled(weight, rd);
        return rf;
    }
    by = vmi_carlson_scale_of(top);
    rf = vmi_rf_rd(by.factor * x, by.factor * y, by.factor * z, &rd);
    if (by.root < 1 && weight.hi < 1) *third = vmi_two(weight.hi * (by.root * (by.root * (by.root * rd))), 0);
    else *third = vmi_two(by.root * (by.root * weight.hi) * (by.root * rd), 0);
    return by.root * rf;
}

/* Returns R_F(x, y, z), and the product of `weight` and R_J(x, y, z, p)/3 in *third, for arguments of any size. `top`
   is the largest of x, y and z; where it is not between eps and 1/eps, the arguments are scaled first. (A caller that
   has scaled them already passes top = 1.) With scaling, the product is right even if R_J itself would overflow or
   underflow. Without scaling, the product has two words, so that it is not rounded before it is used. */
VM_API vm_real vmi_rf_rj_weighted(vm_real x, vm_real y, vm_real z, vm_real p, vm_real top, vm_real weight,
                                  vm_two *third)
{
    vmi_carlson_scale by;
    vm_real rf, rj;
    if (top > VM_EPSILON && top < 1 / VM_EPSILON) {
        rf = vmi_rf_rj(x, y, z, p, &rj);
        *third = vmi_two_product(weight, rj);
        return rf;
    }
    by = vmi_carlson_scale_of(top / VMI_RJ_LIFT);
    rf = vmi_rf_rj(by.factor * x, by.factor * y, by.factor * z, by.factor * p, &rj);
    *third = vmi_two(by.root * (by.root * weight) * (by.root * rj), 0);
    return by.root * rf;
}

/* Returns the product s (first + second), rounded to one word. The three arguments have two words each. Only two
   roundings change the result noticeably. */
VM_INLINE vm_real vmi_times_sum(vm_two s, vm_two first, vm_two second)
{
    vm_two sum = vmi_two_sum(first.hi, second.hi);
    sum.lo += first.lo + second.lo;
    return s.hi * sum.hi + (s.hi * sum.lo + s.lo * sum.hi);
}

/* Returns 1 if the scale `by` makes x > 0 subnormal or 0, else 0. It does so if x is much smaller than the largest
   argument, from which the scale was computed. */
VM_API int vmi_carlson_is_lost(vmi_carlson_scale by, vm_real x) { return x > 0 && by.factor * x < VM_MIN; }

/* Returns 1 if x, y, z >= 0, else 0. */
VM_API int vmi_carlson_allowed(vm_real x, vm_real y, vm_real z) { return x >= 0 && y >= 0 && z >= 0; }

/* Returns 1 if at least two of the three numbers, which are not negative, are 0, else returns 0. */
VM_API int vmi_two_zeros(vm_real x, vm_real y, vm_real z)
{
    return x + y == 0 || y + z == 0 || z + x == 0;
}

/* Returns the limit of R_F, R_C, R_D or R_J at arguments that are 0 or infinite. `zeros` is 1 if so many arguments are
   0 that the integral diverges: then the limit is infinity. `infinite` is 1 if an argument is infinite: then the limit
   is 0. If both are 1, there is no limit, and the result is NaN. */
VM_API vm_real vmi_carlson_limit(int zeros, int infinite)
{
    if (zeros && infinite) return VM_NAN;
    if (zeros) return VM_INFINITY;
    return 0;
}

/* Returns R_F where the largest argument is so great that sums of arguments would overflow. The function makes one
   duplication, divides the new arguments by 16, and takes R_F of the quotients, which is 4 times the result. Each term
   is divided before it is added, so that no sum overflows. After the duplication no argument is so small that products
   of arguments lose digits. */
VM_API vm_real vmi_rf_huge(vm_real x, vm_real y, vm_real z)
{
    const vm_real a = VM_SQRT(x) / 2, b = VM_SQRT(y) / 2, c = VM_SQRT(z) / 2;
    const vm_real lambda = a * (b / 16 + c / 16) + b / 16 * c;
    return VM_C(0.25) * vmi_rf(x / 64 + lambda, y / 64 + lambda, z / 64 + lambda);
}

/* R_F(x, y, z), Carlson's integral of the first kind, for x, y, z >= 0. R_F does not change if arguments are exchanged.
   The error is at most 8 ulp. R_F is infinite if two arguments are 0, and 0 if an argument is infinite. It is NaN if
   both hold, or if an argument is negative. K(m) is R_F(0, 1 - m, 1). With s = sin phi, F(phi | m) is s
   R_F(1 - s^2, 1 - m s^2, 1) for |phi| <= pi/2. DLMF 19.16.1. */
VM_API vm_real jacobi_RF(vm_real x, vm_real y, vm_real z)
{
    const vm_real largest = vmi_larger(vmi_larger(x, y), z);
    const int zeros = vmi_two_zeros(x, y, z), infinite = !VM_IS_FINITE(largest);
    vmi_carlson_scale by;
    if (!vmi_carlson_allowed(x, y, z)) return VM_NAN;
    if (zeros || infinite) return vmi_carlson_limit(zeros, infinite);
    if (largest > VM_MAX / 64) return vmi_rf_huge(x, y, z);
    if (largest > VM_MIN / vmi_fourth_power(VM_EPSILON)) return vmi_rf(x, y, z);
    by = vmi_carlson_scale_of(largest); /* without this scale products of two small arguments lose digits */
    return by.root * vmi_rf(by.factor * x, by.factor * y, by.factor * z);
}

/* R_C(x, y) = R_F(x, y, y), Carlson's elementary integral, for x >= 0 and any y. R_C is an arctangent for x < y and a
   logarithm for x > y. The error is at most 8 ulp. For y < 0 R_C is Cauchy's principal value. R_C is infinite if y is
   0, and 0 if an argument is infinite. It is NaN if both hold, or if x is negative. DLMF 19.2.17. */
VM_API vm_real jacobi_RC(vm_real x, vm_real y)
{
    const vm_real largest = vmi_larger(x, VM_FABS(y));
    vmi_carlson_scale by;
    if (!(x >= 0) || y != y) return VM_NAN;
    if (y == 0 || !VM_IS_FINITE(largest)) return vmi_carlson_limit(y == 0, !VM_IS_FINITE(largest));
    by = vmi_carlson_scale_of(largest);
    if (y < 0 && vmi_carlson_is_lost(by, x)) return -VM_SQRT(x) / y; /* the limit for a small x */
    if (!vmi_carlson_is_lost(by, VM_FABS(y))) return by.root * vmi_rc(by.factor * x, by.factor * y);
    return jacobi_RF(x, VM_FABS(y), VM_FABS(y)); /* R_C does not depend on the sign of a y this small */
}

/* R_D(x, y, z) = R_J(x, y, z, z), Carlson's integral of the second kind, for x, y, z >= 0. R_D does not change if x and
   y are exchanged. The error is at most 8 ulp. R_D is infinite if z = 0 or x = y = 0, and 0 if an argument is infinite.
   It is NaN if both hold, or if an argument is negative. It may be NaN, too, if one argument is more than 1e307 times
   (float 1e37) another one that is not 0. DLMF 19.16.5. */
VM_API vm_real jacobi_RD(vm_real x, vm_real y, vm_real z)
{
    const vm_real largest = vmi_larger(vmi_larger(x, y), z);
    const int zeros = z == 0 || x + y == 0, infinite = !VM_IS_FINITE(largest);
    vmi_carlson_scale by;
    vm_real rd;
    if (!vmi_carlson_allowed(x, y, z)) return VM_NAN;
    if (zeros || infinite) return vmi_carlson_limit(zeros, infinite);
    by = vmi_carlson_scale_of(largest);
    if (vmi_carlson_is_lost(by, x) || vmi_carlson_is_lost(by, y) || vmi_carlson_is_lost(by, z)) return VM_NAN;
    vmi_rf_rd(by.factor * x, by.factor * y, by.factor * z, &rd);
    return by.root * (by.root * (by.root * (3 * rd)));
}

/* Returns R_J(x, y, z, p) for p < 0, Cauchy's principal value of the integral, for 0 <= x, y <= z of which at most one
   is 0. R_J is computed from R_J(x, y, z, other), where `other` is a positive number (DLMF 19.20.14). */
VM_API vm_real vmi_rj_principal(vm_real x, vm_real y, vm_real z, vm_real p)
{
    const vm_real q = -p, other = (z * ((x + y) + q) - x * y) / (z + q), share = x * (y / other) + q;
    vm_real rf, rj, rest;
    rf = vmi_rf_rj(x, y, z, other, &rj);
    rest = 3 * ((other - z) * rj - rf);
    rest += 3 * VM_SQRT(x / other) * VM_SQRT(y / other) * VM_SQRT(z / share) * vmi_rc(share, q);
    return rest / (z + q);
}

/* R_J(x, y, z, p), Carlson's integral of the third kind, for x, y, z >= 0. R_J does not change if x, y and z are
   exchanged. For p > 0 the error is at most 8 ulp where no argument is more than 1e16 times another one, and at most 16
   ulp elsewhere. For p < 0 R_J is Cauchy's principal value, which has zeros: its error is at most 16 eps of R_J(x, y,
   z, |p|). R_J is infinite if p = 0; if two of x, y, z are 0, it is infinite with the sign of p. It is 0 if an argument
   is infinite. It is NaN if both hold, or if x, y or z is negative. It may be NaN, too, if one argument is more than
   1e307 times (float 1e37) another one that is not 0. DLMF 19.16.2. */
VM_API vm_real jacobi_RJ(vm_real x, vm_real y, vm_real z, vm_real p)
{
    const vm_real top = vmi_larger(vmi_larger(x, y), z), largest = vmi_larger(top, VM_FABS(p));
    const int zeros = p == 0 || vmi_two_zeros(x, y, z), infinite = !VM_IS_FINITE(largest);
    vmi_carlson_scale by;
    vm_real rj;
    if (!vmi_carlson_allowed(x, y, z) || p != p) return VM_NAN;
    if (zeros && !infinite && p < 0) return -VM_INFINITY;
    if (zeros || infinite) return vmi_carlson_limit(zeros, infinite);
    if (-p * VM_EPSILON * VM_EPSILON > top) return 3 * jacobi_RF(x, y, z) / p; /* the limit for a large |p| */
    by = vmi_carlson_scale_of(largest);
    if (vmi_carlson_is_lost(by, x) || vmi_carlson_is_lost(by, y) || vmi_carlson_is_lost(by, z)) return VM_NAN;
    if (vmi_carlson_is_lost(by, VM_FABS(p))) return VM_NAN;
    x *= by.factor;
    y *= by.factor;
    z *= by.factor;
    p *= by.factor;
    if (p > 0) {
        const vm_real lift = VMI_RJ_LIFT;
        vmi_rf_rj(lift * x, lift * y, lift * z, lift * p, &rj);
        rj *= 3 * lift * VMI_ROOT_OF_RJ_LIFT;
    }
    else if (x == by.factor * top) rj = vmi_rj_principal(y, z, x, p);
    else if (y == by.factor * top) rj = vmi_rj_principal(z, x, y, p);
    else rj = vmi_rj_principal(x, y, z, p);
    return by.root * (by.root * (by.root * rj));
}

/* R_G(x, y, z), Carlson's symmetric integral of the second kind, for x, y, z >= 0. The error is at most 10 ulp. R_G is
   infinite if an argument is infinite, and NaN if an argument is negative. E(m) is 2 R_G(0, 1 - m, 1), and an ellipsoid
   with the half axes a, b, c has the surface 4 pi R_G(a^2 b^2, b^2 c^2, c^2 a^2). DLMF 19.16.3. The function uses DLMF
   19.21.10 with the arguments exchanged so that z is neither the smallest nor the largest: then all terms are
   positive. */
VM_API vm_real jacobi_RG(vm_real x, vm_real y, vm_real z)
{
    const vm_real least = vmi_smaller(vmi_smaller(x, y), z), largest = vmi_larger(vmi_larger(x, y), z);
    vm_real middle = vmi_larger(vmi_smaller(x, y), vmi_smaller(vmi_larger(x, y), z)), low, high, rf, rd;
    vmi_carlson_scale by;
    if (!vmi_carlson_allowed(x, y, z)) return VM_NAN;
    if (!VM_IS_FINITE(largest)) return VM_INFINITY;
    by = vmi_carlson_scale_of(largest);
    if (middle == 0 || vmi_carlson_is_lost(by, middle)) return VM_SQRT(largest) / 2;
    low = by.factor * least;
    middle *= by.factor;
    high = by.factor * largest;
    rf = vmi_rf_rd(low, high, middle, &rd);
    rd *= (high - middle) * (middle - low);
    return (middle * rf + rd + VM_SQRT(low * high / middle)) / (2 * by.root);
}

#endif
