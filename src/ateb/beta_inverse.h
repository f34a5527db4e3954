/* ateb/beta_inverse.h - inverse of the incomplete beta function

   p is I_x(a, b), as in ateb/beta.h, q is 1 - p, and y is 1 - x.

       vm_real x = ateb_beta_inc_inv(VM_C(0.3), VM_C(0.5), 2); // I_x(0.5, 2) = 0.3

   Method: ln I_x(a, b) is a concave function of t = ln(x/y). Steps of third order lead to the t where it is equal to
   ln p. The first steps use rough values of ln I_x, the later steps logarithms in two words. Tests:
   tests/test_ateb.c. */
#ifndef VARMASS_ATEB_BETA_INVERSE_H
#define VARMASS_ATEB_BETA_INVERSE_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "beta.h"
#include "powers.h"

/* Returns the point with x/y = e^t, where y = 1 - x. ln x and ln y are computed from the rounded value of e^-|t|, from
   which x and y are computed too. The two logarithms then belong to numbers whose sum is 1 in two words. */
VM_API vmi_beta_point vmi_beta_point_at(vm_real t)
{
    const vm_real size = VM_FABS(t), e = vmi_exp(-size, 0);
    const vm_two sum = vmi_two_sum(1, e);
    vmi_beta_point at;
    vm_two ln_e = vmi_two(-size, 0);
    if (e > VM_MIN) ln_e = vmi_log(e);
    at.ln_y = vmi_minus(vmi_two_log(sum));
    at.ln_x = vmi_two_plus(ln_e, at.ln_y);
    at.y = 1 / sum.hi;
    at.y -= at.y * (at.y * sum.lo);
    at.x = e * at.y;
    if (!(t < 0)) at = vmi_beta_mirrored(at);
    return at;
}

/* ln I_x(a, b) as a function of t = ln(x/y): its value, its slope (the derivative of `value` with respect to t), and
   its bend (the derivative of ln(slope) with respect to t). `noise` is the largest error of `value`. */
typedef struct VM_TAG(vmi_beta_slope) {
    vm_real value, slope, bend, noise;
} vmi_beta_slope;

/* Returns the fields of vmi_beta_slope at t = ln(x/y). ln_B is ln B(a, b). For x <= (a + 1)/(a + b + 2) the error of
   ln I_x is about 1e-8 (float 1e-4). For a larger x, I_x is computed as 1 - I_y(b, a), and the error of ln I_x is about
   1e-8/I_x (float 1e-4/I_x). */
VM_API vmi_beta_slope vmi_beta_rough(vm_real t, vm_real a, vm_real b, vm_real ln_B)
{
    const vm_real tolerance = VM_MANT_DIG > 24 ? VM_C(1e-8) : VM_C(1e-4), least_ln = VM_C(-0.69) * VMI_BIAS;
    const vm_real size = VM_FABS(t), e = vmi_ateb_exp(vmi_larger(-size, least_ln)), longer = 1 / (1 + e);
    const vm_real shorter = e * longer, ln_longer = -vmi_ateb_ln(1 + e), ln_shorter = ln_longer - size;
    vmi_beta_slope at;
    vm_real x = shorter, y = longer, ln_density = a * ln_shorter + b * ln_longer - ln_B, f, p;
    if (t > 0) {
        x = longer;
        y = shorter;
        ln_density = a * ln_longer + b * ln_shorter - ln_B;
    }
    at.noise = tolerance;
    if (x * (a + b + 2) <= a + 1) {
        f = vmi_beta_fraction(x, y, a, b, tolerance);
        at.value = ln_density + vmi_ateb_ln(f);
        at.slope = 1 / f;
    } else {
        p = 1 - vmi_beta_fraction(y, x, b, a, tolerance) * vmi_ateb_exp(vmi_larger(ln_density, least_ln));
        p = vmi_larger(p, tolerance);
        at.noise = tolerance / p;
        at.value = vmi_ateb_ln(p);
        at.slope = vmi_ateb_exp(vmi_larger(ln_density - at.value, least_ln));
    }
    at.bend = a * y - b * x - at.slope;
    return at;
}

/* Returns the step of t that changes ln I_x by `rest`. ln I_x is approximated by the parabola with this slope and bend
   (see vmi_beta_slope). If it does not reach the wanted value, the step is twice that of its tangent. */
VM_API vm_real vmi_beta_step(vm_real rest, vm_real slope, vm_real bend)
{
    const vm_real step = rest / slope;
    return 2 * step / (1 + VM_SQRT(vmi_larger(1 + 2 * step * bend, 0)));
}

/* Returns a start value of t = ln(x/y) for the solution of I_x(a, b) = p with p <= 1/2. For t to -infinity, ln I_x
   tends to the straight line a t - ln(a B(a, b)). This line is equal to ln p at a t that is smaller than the solution,
   and the function returns this t. For a, b > 1 it also computes the approximation by a normal distribution, and
   returns the larger number (Abramowitz and Stegun 26.5.22, with the quantile by 26.2.23). */
VM_API vm_real vmi_beta_start(vm_real ln_p, vm_real a, vm_real b, vm_real ln_B)
{
    const vm_real ln_a = vmi_ateb_ln(a), asymptote = (ln_p + ln_a + ln_B) / a;
    vm_real s, above, below, quantile, by_a, by_b, h, shift, w;
    if (!(a > 1) || !(b > 1)) return asymptote;
    s = VM_SQRT(-2 * ln_p);
    above = VM_C(2.515517) + s * (VM_C(0.802853) + s * VM_C(0.010328));
    below = 1 + s * (VM_C(1.432788) + s * (VM_C(0.189269) + s * VM_C(0.001308)));
    quantile = s - above / below;
    by_a = 1 / (2 * a - 1);
    by_b = 1 / (2 * b - 1);
    h = 2 / (by_a + by_b);
    shift = (quantile * quantile - 3) / 6;
    w = quantile * VM_SQRT(h + shift) / h - (by_b - by_a) * (shift + VM_C(0.83333333) - VM_C(0.66666667) / h);
    return vmi_larger(asymptote, ln_a - vmi_ateb_ln(b) - 2 * w);
}

/* Returns a t within about 1e-2 of the solution of I_x(a, b) = p, from the start value t. The search ends earlier where
   the rough values of ln I_x have errors above 0.01. */
VM_API vm_real vmi_beta_approach(vm_real t, vm_real ln_p, vm_real a, vm_real b, vm_real ln_B)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(2e-3) : VM_C(2e-2); /* a shorter step ends the search */
    const int most = 60; /* largest number of steps; in double 12 are enough */
    int i;
    for (i = 0; i < most; i++) {
        const vmi_beta_slope rough = vmi_beta_rough(t, a, b, ln_B);
        const vm_real step = vmi_beta_step(ln_p - rough.value, rough.slope, rough.bend);
        if (rough.noise > VM_C(0.01)) break;
        t += step;
        if (!(VM_FABS(step) * (1 + rough.slope) > enough)) break;
    }
    return t;
}

/* Returns the point whose t = ln(x/y) is larger than that of `at` by a short step. The function changes x, y, ln x and
   ln y directly, so that none of them loses digits. The error is about the third power of the step. */
VM_API vmi_beta_point vmi_beta_moved(const vmi_beta_point *at, vm_real step)
{
    const vm_real half = step / 2;
    vmi_beta_point moved;
    moved.x = at->x + at->x * (at->y * (step * (1 + (at->y - at->x) * half)));
    moved.y = at->y - at->y * (at->x * (step * (1 + (at->y - at->x) * half)));
    moved.ln_x = vmi_two_sum(at->ln_x.hi, at->ln_x.lo + at->y * (step * (1 - at->x * half)));
    moved.ln_y = vmi_two_sum(at->ln_y.hi, at->ln_y.lo - at->x * (step * (1 + at->y * half)));
    return moved;
}

/* Returns the point where I_x(a, b) = p, from ln p, for p <= 1/2. ln I_x is a concave function of t = ln(x/y). The
   method starts at vmi_beta_start and makes steps of third order by vmi_beta_step: the error after a step is about the
   third power of the step. The first steps, those of vmi_beta_approach, use rough values of ln I_x. Later steps use
   logarithms in two words. */
VM_API vmi_beta_point vmi_beta_invert(vm_two ln_p, vm_real a, vm_real b)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3); /* a shorter step is the last one */
    const int most = 60;                                               /* largest number of steps */
    const vm_two ln_B = vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0));
    vm_real t = vmi_beta_start(ln_p.hi, a, b, ln_B.hi), step;
    vmi_beta_point at;
    int i;
    t = vmi_beta_approach(t, ln_p.hi, a, b, ln_B.hi);
    for (i = 0; i < most; i++) {
        vm_two density, tail, other, rest;
        vm_real slope;
        at = vmi_beta_point_at(t);
        density = vmi_two_plus(vmi_two_scaled(at.ln_x, a), vmi_two_scaled(at.ln_y, b));
        density = vmi_two_plus(density, vmi_minus(ln_B));
        vmi_beta_tails(&at, a, b, density, &tail, &other);
        rest = vmi_two_plus(ln_p, vmi_minus(tail));
        slope = vmi_exp(density.hi - tail.hi, density.lo - tail.lo);
        step = vmi_beta_step(rest.hi, slope, a * at.y - b * at.x - slope);
        if (!(VM_FABS(step) * (1 + slope) > enough) || VM_FABS(step) <= VM_EPSILON * VM_FABS(t))
            return vmi_beta_moved(&at, step);
        t += step;
    }
    return vmi_beta_point_at(t);
}

/* Returns the point where I_x(a, b) = p, for p > 0, q > 0 and p + q = 1, from the smaller of p and q */
VM_API vmi_beta_point vmi_beta_invert_both(vm_real p, vm_real q, vm_real a, vm_real b)
{
    if (p <= q) return vmi_beta_invert(vmi_log(p), a, b);
    return vmi_beta_mirrored(vmi_beta_invert(vmi_log(q), b, a));
}

/* The inverse of ateb_beta_inc_both: x with I_x(a, b) = p, and y = 1 - x and ln x. All three are computed from the
   smaller of p and q = 1 - p: give this number with all its digits. ln x is right even where x underflows. For a and b
   from 1e-3 to 1e4 the errors of x, y and ln x are at most 16 ulp plus the change that an error of one ulp in the
   smaller of p and q makes. a and b may also lie between 1e-4 and 1e5, where the function is less accurate and slower.
   If a or b is 0 or infinite, x is the limit. This limit is 0 for p < 1 if a is 0 or b is infinite. It is 1 for p > 0
   if b is 0 or a is infinite. If both conditions hold, there is no limit. The results are NaN for other a or b, if
   there is no limit, if p or q is negative, and if p + q is not 1.
   docs/cost.md has the time of a call. */
VM_API void ateb_beta_inc_inv_both(vm_real p, vm_real q, vm_real a, vm_real b, vm_real *x, vm_real *y,
                                   vm_real *ln_x)
{
    const int side = vmi_beta_limit_side(a, b), is_at_0 = side < 0 && q > 0, is_at_1 = side > 0 && p > 0;
    vmi_beta_point at;
    *x = VM_NAN;
    *y = VM_NAN;
    *ln_x = VM_NAN;
    if (!vmi_beta_is_split_of_1(p, q)) return;
    if (!is_at_0 && !is_at_1 && !vmi_beta_is_in_domain(a, b)) return;
    if (is_at_0 || (p == 0 && !is_at_1)) {
        *x = 0;
        *y = 1;
        *ln_x = -VM_INFINITY;
    } else if (is_at_1 || q == 0) {
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

#endif
