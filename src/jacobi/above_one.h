/* jacobi/above_one.h - incomplete elliptic integrals for m > 1

   For m > 1 the root sqrt(1 - m sin^2 x) is real only up to the angle arcsin(1/k), where k = sqrt(m). Up to this angle,
   and at it, the integrals F, E, D and Pi have ordinary values; beyond this angle they are NaN. F gives the time in
   which a pendulum reaches an angle. Let a pendulum swing to and fro up to the angle A, let w0 be the frequency of its
   small oscillations in rad/s, and k = 1/sin(A/2). From its lowest point to the angle a it needs k F(a/2 | m)/w0
   seconds.

       vm_real u = jacobi_F(VM_C(0.4), VM_C(2.5)); // sn(u | 2.5) = sin 0.4

   Method: the reciprocal transformation leads to the parameter 1/m and the angle whose sine is k sin phi. In Carlson's
   integrals this transformation only exchanges the arguments cos^2 phi and 1 - m sin^2 phi. Near the angle arcsin(1/k)
   the number 1 - m sin^2 phi is a difference of nearly equal numbers, which loses digits, and the integrals change as
   the square root of this number. Therefore the sine and the cosine of phi are computed in two words: each is the sum
   of two floating-point numbers (a vm_two of base/words.h), which together have twice the digits of one. All functions
   of this file are internal; jacobi/incomplete.h calls them. Source: DLMF 19.7.4, 19.25. Tests:
   tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_ABOVE_ONE_H
#define VARMASS_JACOBI_ABOVE_ONE_H

#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "carlson.h"

/* Returns the sine of t in two words for 0 <= t <= 0.1, by its power series. The terms from t^11 on are so small that
   one word is enough for them. */
VM_API vm_two vmi_two_sine_series(vm_two t)
{
    const vm_two square = vmi_two_times(t, t);
    vm_real rest = 1;
    vm_two sum;
    int n;
    for (n = 19; n > 9; n -= 2) rest = 1 - square.hi / (vm_real)(n * (n - 1)) * rest;
    sum = vmi_two(rest, 0);
    for (; n > 1; n -= 2) {
        const vm_two part = vmi_two_over(square, vmi_two((vm_real)(n * (n - 1)), 0));
        sum = vmi_two_minus(vmi_two(1, 0), vmi_two_times(part, sum));
    }
    return vmi_two_times(t, sum);
}

/* Computes the sine and the cosine of z in two words for 0 <= z <= pi/4. The angle z/8, whose sine is computed by a
   power series, is doubled three times. */
VM_API void vmi_two_sin_cos(vm_two z, vm_two *sine, vm_two *cosine)
{
    const vm_two one = vmi_two(1, 0);
    vm_two s = vmi_two_sine_series(vmi_two_shifted(z, VM_C(0.125))), ss = vmi_two_times(s, s);
    vm_two c = vmi_two_root(vmi_two_minus(one, ss));
    int i;
    for (i = 0; i < 3; i++) {
        s = vmi_two_shifted(vmi_two_times(s, c), 2);
        c = vmi_two_minus(one, vmi_two_shifted(ss, 2));
        ss = vmi_two_times(s, s);
    }
    *sine = s;
    *cosine = c;
}

/* An angle phi between 0 and arcsin(1/k), with the numbers from which the integrals for m > 1 are computed */
typedef struct VM_TAG(vmi_above) {
    vm_two s, c;   /* sin phi and cos phi */
    vm_real cc;    /* cos^2 phi */
    vm_two share;  /* (m - 1) sin^2 phi, the difference cc - d */
    vm_real d;     /* 1 - m sin^2 phi = cc - share; d is below 0 or NaN where the integrals have no real value */
} vmi_above;

/* Returns sqrt(|x|) sin phi in two words. The root of |x| is taken first, so that the product neither overflows nor
   underflows. */
VM_API vm_two vmi_root_times_sine(vm_two x, const vmi_above *angle)
{
    if (x.hi < 0) x = vmi_minus(x);
    return vmi_two_times(vmi_two_root(x), angle->s);
}

/* Returns c^2 - x^2, computed as (c - x) (c + x), which has a small relative error. */
VM_API vm_real vmi_difference_of_squares(vm_two c, vm_two x)
{
    return vmi_two_times(vmi_two_minus(c, x), vmi_two_plus(c, x)).hi;
}

/* Returns the numbers of vmi_above for the angle |phi| and the number m1 = 1 - m < 0, which is given in two words. */
VM_API vmi_above vmi_above_of(vm_real phi, vm_two m1)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real x = VM_FABS(phi);
    vmi_above angle;
    vm_two z = vmi_two(x, 0), root;
    if (x <= half_pi.hi / 2) vmi_two_sin_cos(z, &angle.s, &angle.c);
    else {
        const vm_two sum = vmi_two_sum(half_pi.hi - x, half_pi.mid);
        z = vmi_fast_two_sum(sum.hi, sum.lo + half_pi.lo);
        vmi_two_sin_cos(z, &angle.c, &angle.s);
    }
    root = vmi_root_times_sine(m1, &angle);
    angle.cc = vmi_two_times(angle.c, angle.c).hi;
    angle.share = vmi_two_times(root, root);
    angle.d = vmi_difference_of_squares(angle.c, root);
    if (!(z.hi >= 0) || !VM_IS_FINITE(m1.hi)) angle.d = VM_NAN; /* |phi| is above pi/2 or NaN, or m is infinite */
    return angle;
}

/* Returns F(phi | m) for m > 1. With the fields s, cc, d of vmi_above, F is s R_F(cc, d, 1). */
VM_API vm_real vmi_F_above(vm_real phi, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    if (!(angle.d >= 0)) return VM_NAN;
    return VM_COPYSIGN(angle.s.hi * vmi_rf(angle.cc, angle.d, 1), phi);
}

/* Returns E(phi | m) for m > 1. Let s be sin phi, k = sqrt(m), M = 1/m, and B the angle whose sine is k s. Then E is
   k (E(B | M) - (1 - M) F(B | M)), but this difference would lose digits. The formula here is a sum of positive terms
   (DLMF 19.25.11). */
VM_API vm_real vmi_E_above(vm_real phi, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    vm_real third;
    if (!(angle.d >= 0)) return VM_NAN;
    vmi_rf_rd(angle.d, 1, angle.cc, &third);
    return VM_COPYSIGN(
        vmi_times_sum(angle.s, vmi_two(VM_SQRT(angle.d / angle.cc), 0), vmi_two_scaled(angle.share, third)), phi);
}

/* Returns D(phi | m) for m > 1. With the fields s, cc, d of vmi_above, D is s^3 R_D(cc, d, 1)/3. */
VM_API vm_real vmi_D_above(vm_real phi, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    const vm_two cube = vmi_two_times(vmi_two_times(angle.s, angle.s), angle.s);
    vm_real third;
    if (!(angle.d >= 0)) return VM_NAN;
    vmi_rf_rd(angle.cc, angle.d, 1, &third);
    return VM_COPYSIGN(vmi_two_scaled(cube, third).hi, phi);
}

/* Returns Pi(n; phi | m) for m > 1, n < 0 and phi >= 0. Let s be sin phi; p is 1 - n s^2. The reciprocal transformation
   leads to the parameter 1/m and the characteristic n/m. Then the characteristic N = (1 - n)/(m - n) replaces n/m (DLMF
   19.7.9), so that all terms are positive. In the function, q is 1 - N m s^2, and `gap` is p q - cos^2 phi. */
VM_API vm_real vmi_Pi_above_negative(const vmi_above *angle, vm_real n, vm_real m, vm_real m1, vm_real p)
{
    const vm_real s = angle->s.hi, ratio = n / m, per = 1 / (1 - ratio);
    const vm_real weight = -m1 / m * per * (angle->share.hi + s * s), q = angle->d + weight;
    const vm_real gap = -ratio * per * (1 - n) * s * s * angle->d;
    vm_two third, sum;
    const vm_real rf = vmi_rf_rj_weighted(angle->cc, angle->d, 1, q, 1, weight, &third);
    sum = vmi_two_plus(vmi_two_product(VM_SQRT(angle->d), vmi_rc_apart(angle->cc, p * q, gap)), third);
    return vmi_times_sum(angle->s, vmi_two(rf * per, 0), vmi_two_scaled(sum, ratio / (ratio - 1)));
}

/* Returns Pi(n; phi | m) for m > 1 and a finite n. Let s be sin phi and p = 1 - n s^2. For n > 1, p falls to 0 at a
   pole; therefore p is computed there from numbers in two words. For p < 0, which implies n > m, the formula of
   vmi_Pi_part for p < 0 is used: q is 1 - s^2 m/n, and R_C is Cauchy's principal value. */
VM_API vm_real vmi_Pi_above(vm_real phi, vm_real n, vm_real m, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    const vm_two less = vmi_two_sum(n, -1), root = vmi_root_times_sine(less, &angle);
    const vm_real s = angle.s.hi;
    vm_real p = angle.cc + root.hi * root.hi, q, rf;
    vm_two third;
    if (!(angle.d >= 0)) return VM_NAN;
    if (n < 0) return VM_COPYSIGN(vmi_Pi_above_negative(&angle, n, m, m1.hi, p), phi);
    if (n > 1) p = vmi_difference_of_squares(angle.c, root);
    if (p == 0) return VM_COPYSIGN(VM_INFINITY, phi);
    if (p > 0) {
        rf = vmi_rf_rj_weighted(angle.cc, angle.d, 1, p, 1, n * s * s, &third);
        return VM_COPYSIGN(vmi_times_sum(angle.s, vmi_two(rf, 0), third), phi);
    }
    q = angle.cc + vmi_two_plus(less, m1).hi / n * s * s;
    vmi_rf_rj_weighted(angle.cc, angle.d, 1, q, 1, m / n * s * s, &third);
    rf = vmi_rc(angle.cc * angle.d, p * q);
    return VM_COPYSIGN((vm_real)1, phi) * vmi_times_sum(angle.s, vmi_two(rf, 0), vmi_minus(third));
}

#endif
