/* jacobi/incomplete.h - incomplete elliptic integrals F, E, D and Pi, and the complete D and Pi

     F(phi | m)     = integral of dx/sqrt(1 - m sin^2 x), the inverse of the amplitude am(u | m)
     E(phi | m)     = integral of sqrt(1 - m sin^2 x) dx
     D(phi | m)     = integral of sin^2 x dx/sqrt(1 - m sin^2 x), which is (F - E)/m
     Pi(n; phi | m) = integral of dx/((1 - n sin^2 x) sqrt(1 - m sin^2 x)), where n is the characteristic
   All integrals are from 0 to phi; with phi = pi/2 they are the complete integrals. For m = k^2 <= 1 the angle phi is
   any number of radians. For m > 1 it lies between -arcsin(1/k) and arcsin(1/k), where the square roots are real
   (jacobi/above_one.h). F is the time in which a pendulum reaches an angle, E the length of an arc of an ellipse, and
   Pi the precession of a spherical pendulum or a top.

       vm_real u = jacobi_F(VM_C(1.2), VM_C(0.5)); // am(u | 0.5) = 1.2

   Method: a multiple of pi is subtracted from phi, so that a rest theta with |theta| <= pi/2 is left. For this
   subtraction pi has three words, that is, it is a sum of three floating-point numbers. Each pi that was subtracted
   adds twice the complete integral. The integral from 0 to theta is a sum of Carlson's integrals. The terms of the sum
   are all positive, so that no digits are lost; the exception is Pi for n > 1 (see vmi_Pi_part). Source: DLMF 19.2,
   19.7, 19.25. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_INCOMPLETE_H
#define VARMASS_JACOBI_INCOMPLETE_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "above_one.h"
#include "carlson.h"
#include "integrals.h"

/* An angle as the sum of a multiple of pi and a rest theta, |theta| <= pi/2 */
typedef struct VM_TAG(vmi_angle) {
    vm_real turns; /* phi = turns pi/2 + theta, with an even number `turns`. An integral from 0 to phi is the integral
                      from 0 to theta plus `turns` times the complete integral */
    vm_two s, c;   /* sin theta and cos theta, each within 0.4 ulp */
} vmi_angle;

/* Returns turns, sin theta and cos theta for the finite angle phi. If phi is so large that its digits do not determine
   theta, theta is taken as 0, and turns is 2 phi/pi, which then need not be an even number. */
VM_INLINE vmi_angle vmi_angle_of(vm_real phi)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real x = VM_FABS(phi), count = x * VM_C(0.6366197723675813431), j = VM_FLOOR(count + VM_C(0.5));
    vm_two rest = vmi_two(x, 0);
    vmi_angle angle;
    vm_two sine, cosine;
    angle.turns = 0;
    if (j > 0) {
        const vm_two p = vmi_two_product(j, half_pi.hi), sum = vmi_two_sum(x - p.hi, -p.lo);
        rest = vmi_two_sum(sum.hi, sum.lo - j * half_pi.mid);
        rest.lo -= j * half_pi.lo;
        angle.turns = j;
    }
    if (!(j < VM_C(0.25) / VM_EPSILON)) {
        angle.turns = count;
        rest = vmi_two(0, 0);
    }
    vmi_sin_cos_words(rest, &sine, &cosine);
    angle.s = sine;
    angle.c = cosine;
    if (j < VM_C(0.25) / VM_EPSILON && j - 2 * VM_FLOOR(j / 2) > 0) { /* theta is rest + pi/2 or rest - pi/2 */
        const vm_real side = VM_COPYSIGN((vm_real)1, rest.hi);
        angle.turns = j + side;
        angle.s = vmi_two_shifted(cosine, -side);
        angle.c = vmi_two_shifted(sine, side);
    }
    if (phi < 0) {
        angle.turns = -angle.turns;
        angle.s = vmi_minus(angle.s);
    }
    return angle;
}

/* Returns 1 if an integral from 0 to phi for m <= 1 has no ordinary value, else 0. It has none if phi or m1 is infinite
   or NaN, or if m1 < 0. For m1 < 0, that is m > 1, jacobi/above_one.h has the integrals. */
VM_INLINE int vmi_incomplete_special(vm_real phi, vm_real m1)
{
    return !(VM_IS_FINITE(phi) && m1 >= 0 && VM_IS_FINITE(m1));
}

/* Returns turns * complete + part, an integral from 0 to phi. `complete` is the integral from 0 to pi/2, `part` the
   integral from 0 to theta. Where the terms are not huge, the result is rounded only once. If `complete` is infinite,
   the result is infinite with the sign of turns * complete, even if `part` is infinite with the other sign. */
VM_INLINE vm_real vmi_with_turns(vm_real turns, vm_real complete, vm_real part)
{
    const vm_real limit = VM_MAX * VM_EPSILON;
    const int safe = VM_FABS(turns) < 1 / VM_EPSILON && VM_FABS(complete) < limit && VM_FABS(part) < limit;
    if (safe) return vmi_two_plus(vmi_two_product(turns, complete), vmi_two(part, 0)).hi;
    if (!VM_IS_FINITE(complete)) return turns * complete;
    return turns * complete + part;
}

/* Returns F(phi | m) for 1 - m = m1 + m1_lo, a number in two words. */
VM_API vm_real vmi_F(vm_real phi, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real cc, ss, part;
    if (m1 < 0) return vmi_F_above(phi, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1)) {
        if (!(m1 >= 0) || phi != phi) return VM_NAN;
        if (VM_IS_FINITE(phi)) return 0 * phi; /* m is -infinity */
        if (VM_IS_FINITE(m1)) return phi;
        return VM_NAN;
    }
    angle = vmi_angle_of(phi);
    cc = angle.c.hi * angle.c.hi;
    ss = angle.s.hi * angle.s.hi;
    part = angle.s.hi * vmi_rf(cc, cc + m1 * ss, 1);
    if (angle.turns == 0) return part;
    return vmi_with_turns(angle.turns, vmi_K(m1, m1_lo), part);
}

/* F(phi | m), the incomplete elliptic integral of the first kind. F is the inverse of the amplitude. F is odd in phi,
   and for m <= 1, F(phi + pi) = F(phi) + 2K. The error is at most 8 ulp for |phi| <= 1e9 (float 1e4). For m <= 1 F is
   phi for infinite phi, 0 for m = -infinity, and NaN if both are infinite. For m = 1 F is infinite for |phi| > pi/2.
   For m > 1 F is NaN where m sin^2 phi > 1, for |phi| > pi/2, and for infinite m. docs/peers.md has the time of a call.
   DLMF 19.2.4, 19.25.5. */
VM_API vm_real jacobi_F(vm_real phi, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_F(phi, m1.hi, m1.lo);
}

/* F(phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_F. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_F_m1(vm_real phi, vm_real m1) { return vmi_F(phi, m1, 0); }

/* Returns x^2 for a number in two words, with two roundings. */
VM_INLINE vm_real vmi_squared(vm_two x) { return x.hi * x.hi + 2 * x.hi * x.lo; }

/* Returns E(theta | m) for |theta| <= pi/2 and m <= 1, from s = sin theta and c = cos theta. Both m and m1 = 1 - m are
   arguments, so that each has all its digits. One formula serves for m < 0, another one for m >= 0. All terms of both
   are positive (DLMF 19.25.9-10). */
VM_API vm_real vmi_E_part(vm_two s, vm_two c, vm_real m, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), dd = cc + m1 * ss;
    vm_real rf, rd;
    vm_two third;
    if (m < 0) {
        rf = vmi_rf_rd_weighted(cc, dd, 1, vmi_larger(dd, 1), vmi_two(-m * ss, 0), &third);
        return vmi_times_sum(s, vmi_two(rf, 0), third);
    }
    rf = vmi_rf_rd(cc, 1, dd, &rd);
    return vmi_times_sum(s, vmi_two_product(m1, rf + m * ss * rd), vmi_two_product(m, c.hi / VM_SQRT(dd)));
}

/* Returns E(phi | m) for 1 - m = m1 + m1_lo, a number in two words. */
VM_API vm_real vmi_E_incomplete(vm_real phi, vm_real m, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real part;
    if (m1 < 0) return vmi_E_above(phi, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1)) {
        if (!(m1 >= 0) || phi != phi) return VM_NAN;
        if (phi == 0 || !VM_IS_FINITE(phi)) return phi;
        return VM_COPYSIGN(VM_INFINITY, phi); /* m is -infinity */
    }
    angle = vmi_angle_of(phi);
    part = vmi_E_part(angle.s, angle.c, m, m1);
    if (angle.turns == 0) return part;
    return vmi_with_turns(angle.turns, vmi_E(m1, m1_lo), part);
}

/* E(phi | m), the incomplete elliptic integral of the second kind. E is odd in phi, and for m <= 1, E(phi + pi) =
   E(phi) + 2E(m). The error is at most 8 ulp for |phi| <= 1e9 (float 1e4). For m <= 1 E is phi for infinite phi. For m
   = -infinity E is infinite with the sign of phi, but 0 for phi = 0. For m > 1 E is NaN where m sin^2 phi > 1, for
   |phi| > pi/2, and for infinite m. docs/peers.md has the time of a call. DLMF 19.2.5. */
VM_API vm_real jacobi_E_incomplete(vm_real phi, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_E_incomplete(phi, m, m1.hi, m1.lo);
}

/* E(phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_E_incomplete. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_E_incomplete_m1(vm_real phi, vm_real m1) { return vmi_E_incomplete(phi, 1 - m1, m1, 0); }

/* Returns `lift`, a power of 2 that keeps Carlson's integrals from losing digits where a product of small arguments
   would underflow or a sum of large ones would overflow. The caller multiplies all arguments, and the weight of R_D or
   R_J, by lift^2, and the integral by lift, which gives the value for the original arguments. lift is 1 for ordinary
   arguments. It is above 1 only if m1 < 1, and below 1 only for a huge m1. `least` is about the smallest of the
   arguments. */
VM_INLINE vm_real vmi_lift_of(vm_real least, vm_real m1)
{
    if (m1 < 1 && least < VM_MIN / VM_EPSILON) return vmi_ldexp(1, VM_MANT_DIG > 24 ? 300 : 40);
    if (m1 > VM_MAX * VM_EPSILON) return VM_EPSILON;
    return 1;
}

/* Returns D(theta | m) for 0 <= theta <= pi/2 and m <= 1, from s = sin theta and c = cos theta, as s^3
   R_D(c^2, 1 - m s^2, 1)/3. */
VM_API vm_real vmi_D_part(vm_two s, vm_two c, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss;
    vm_two third;
    vmi_rf_rd_weighted(cc, d, 1, vmi_larger(d, 1), vmi_two_scaled(s, ss), &third);
    return third.hi;
}

/* Returns D(m) - D(theta | m) for 0 <= theta <= pi/2 and m <= 1, from s = sin theta and c = cos theta. With
   d = 1 - m s^2 the difference is c (s/sqrt(d) + c^2 R_D(m1 s^2, m1, d)/3), a sum of positive terms. */
VM_API vm_real vmi_D_complement(vm_two s, vm_two c, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss;
    const vm_real lift = vmi_lift_of(m1 * ss, m1), more = lift * lift, y = more * m1, z = more * d;
    vm_two third;
    vmi_rf_rd_weighted(y * ss, y, z, lift > 1 ? 1 : vmi_larger(z, y), vmi_two(more * cc, 0), &third);
    return vmi_times_sum(c, vmi_two(s.hi / VM_SQRT(d), 0), vmi_two_shifted(third, lift));
}

/* Returns D(m) for m1 = 1 - m. */
VM_API vm_real vmi_D(vm_real m1)
{
    if (!(m1 >= 0)) return VM_NAN;
    if (m1 == 0) return VM_INFINITY;
    if (!VM_IS_FINITE(m1)) return 0;
    return vmi_D_part(vmi_two(1, 0), vmi_two(0, 0), m1);
}

/* D(m) = (K(m) - E(m))/m, the complete elliptic integral D, for m <= 1. The error is at most 8 ulp for m >= -1e300
   (float -1e30). D is pi/4 for m = 0, infinite for m = 1, 0 for m = -infinity, and NaN for m > 1. DLMF 19.2.8. */
VM_API vm_real jacobi_D(vm_real m) { return vmi_D(1 - m); }

/* D(m) from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_D. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_D_m1(vm_real m1) { return vmi_D(m1); }

/* Returns D(phi | m) for 1 - m = m1 + m1_lo, a number in two words. For phi between pi/2 and pi, D(phi | m) is 2 D(m) -
   D(pi - phi | m), but this difference would triple the errors. Therefore the function adds the result of
   vmi_D_complement to D(m) there. */
VM_API vm_real vmi_D_incomplete(vm_real phi, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real turns, sum;
    vm_two s;
    if (m1 < 0) return vmi_D_above(phi, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1)) {
        if (!(m1 >= 0) || phi != phi) return VM_NAN;
        if (VM_IS_FINITE(phi)) return 0 * phi; /* m is -infinity */
        if (VM_IS_FINITE(m1)) return phi;
        return VM_NAN;
    }
    angle = vmi_angle_of(VM_FABS(phi));
    turns = angle.turns;
    s = angle.s.hi < 0 ? vmi_minus(angle.s) : angle.s;
    if (turns == 0) sum = vmi_D_part(s, angle.c, m1);
    else if (turns == 2 && angle.s.hi < 0 && m1 > 0) sum = vmi_D(m1) + vmi_D_complement(s, angle.c, m1);
    else sum = vmi_with_turns(turns, vmi_D(m1), VM_COPYSIGN(vmi_D_part(s, angle.c, m1), angle.s.hi));
    return VM_COPYSIGN(sum, phi);
}

/* D(phi | m) = (F(phi | m) - E(phi | m))/m, the incomplete integral of sin^2 x/sqrt(1 - m sin^2 x). No digits are lost,
   not even for m = 0. D is odd in phi, and for m <= 1, D(phi + pi) = D(phi) + 2D(m). The error is at most 8 ulp for
   |phi| <= 1e9 (float 1e4) and m >= -1e300 (float -1e30), unless phi^3 underflows. For m <= 1 D is phi for infinite
   phi, 0 for m = -infinity, and NaN if both are infinite. For m = 1 D is infinite for |phi| > pi/2. For m > 1 D is NaN
   where m sin^2 phi > 1, for |phi| > pi/2, and for infinite m. A call takes as long as one of jacobi_E_incomplete. DLMF
   19.2.6, 19.25.13. */
VM_API vm_real jacobi_D_incomplete(vm_real phi, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_D_incomplete(phi, m1.hi, m1.lo);
}

/* D(phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_D_incomplete. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_D_incomplete_m1(vm_real phi, vm_real m1) { return vmi_D_incomplete(phi, m1, 0); }

/* Returns 1 - m/n for n > 1 and m1 = 1 - m >= 0. All terms are divided by 4 first, so that no sum overflows. */
VM_INLINE vm_real vmi_share_below_pole(vm_real n, vm_real m1)
{
    return ((n - 1) * VM_C(0.25) + m1 * VM_C(0.25)) / (n * VM_C(0.25));
}

/* Returns Pi(n; theta | m) for |theta| <= pi/2, from s = sin theta and c = cos theta, with 1 - m = m1. Let
   p = 1 - n s^2 and d = 1 - m s^2. There are three formulas:
     n < 0: the characteristic N = (m - n)/(1 - n), which lies between m and 1, replaces n (DLMF 19.7.9). q is
            1 - N s^2 = c^2 + s^2 m1/(1 - n). R_C depends on `gap`, the difference p q - d, which is -n N s^2 c^2.
     n >= 0 and p > 0: the result is s R_F + n s^3 R_J/3 (DLMF 19.25.14).
     p < 0: the characteristic m/n replaces n (DLMF 19.7.8). q is 1 - s^2 m/n, and R_C is Cauchy's principal value.
   Each formula is a sum of positive terms, except that the third one has a negative term if m > 0. For p = 0 the result
   is infinite, with the sign of s. */
VM_API vm_real vmi_Pi_part(vm_two s, vm_two c, vm_real n, vm_real m, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss, top = vmi_larger(d, 1);
    const vm_real p = cc + (1 - n) * ss;
    vm_real q, share, rf, gap;
    vm_two third, sum;
    if (n < 0) {
        share = m1 / (1 - n);
        q = cc + share * ss;
        gap = n / (1 - n) * (n - m) * ss * cc;
        rf = vmi_rf_rj_weighted(cc, d, 1, q, top, share * ss, &third);
        sum = vmi_two_plus(vmi_two_product(c.hi, vmi_rc_apart(d, p * q, gap)), third);
        return vmi_times_sum(s, vmi_two(rf / (1 - n), 0), vmi_two_scaled(sum, n / (n - 1)));
    }
    if (p > 0) {
        rf = vmi_rf_rj_weighted(cc, d, 1, p, top, n * ss, &third);
        return vmi_times_sum(s, vmi_two(rf, 0), third);
    }
    if (p == 0) return VM_COPYSIGN(VM_INFINITY, s.hi);
    q = cc + vmi_share_below_pole(n, m1) * ss;
    vmi_rf_rj_weighted(cc, d, 1, q, top, m / n * ss, &third);
    return vmi_times_sum(s, vmi_two(vmi_rc(cc * d, p * q), 0), vmi_minus(third));
}

/* Returns Pi(n | m) for n < 0 and m1 = 1 - m > 0. The factor `lift`, a power of 2 from vmi_lift_of, keeps numbers from
   underflowing. For a very large -n, however, (1 - m)/(1 - n) may underflow even after it is multiplied by lift^2.
   There the result is the sum (pi/2)/sqrt(1 - n) + K(m)/(1 - n), which begins a series; the next term, -E(m)/(1 - n),
   is far below an ulp. */
VM_API vm_real vmi_Pi_negative(vm_real n, vm_real m1)
{
    const vm_real lift = vmi_lift_of(m1 / (1 - n), m1), more = lift * lift, share = more * m1 / (1 - n);
    vm_real rf;
    vm_two third;
    if (lift > 1 && n < -1000 / (VM_EPSILON * VM_EPSILON))
        return VM_PI / 2 / VM_SQRT(1 - n) + vmi_K(m1, 0) / (1 - n);
    rf = vmi_rf_rj_weighted(0, more * m1, more, share, lift > 1 ? 1 : more * vmi_larger(m1, 1), share, &third);
    return lift * vmi_two_plus(vmi_two(rf / (1 - n), 0), vmi_two_scaled(third, n / (n - 1))).hi;
}

/* Returns Pi(n | m), from both m and m1 = 1 - m. The formulas for n < 0, 0 <= n < 1 and n > 1 are those of vmi_Pi_part
   for theta = pi/2. */
VM_API vm_real vmi_Pi(vm_real n, vm_real m, vm_real m1)
{
    const vm_real top = vmi_larger(m1, 1);
    vm_real rf;
    vm_two third;
    if (!(m1 >= 0) || n != n) return VM_NAN;
    if (!VM_IS_FINITE(n) || !VM_IS_FINITE(m1)) {
        if (VM_IS_FINITE(n) && n < 1) return 0; /* m is -infinity */
        if (!VM_IS_FINITE(n) && VM_IS_FINITE(m1) && m1 > 0) return 0;
        return VM_NAN;
    }
    if (n == 1) return VM_INFINITY;
    if (m1 == 0) return VM_COPYSIGN(VM_INFINITY, 1 - n);
    if (n < 0) return vmi_Pi_negative(n, m1);
    if (n < 1) {
        rf = vmi_rf_rj_weighted(0, m1, 1, 1 - n, top, n, &third);
        return vmi_two_plus(vmi_two(rf, 0), third).hi;
    }
    vmi_rf_rj_weighted(0, m1, 1, vmi_share_below_pole(n, m1), top, m / n, &third);
    return 0 - third.hi;
}

/* Pi(n | m), the complete elliptic integral of the third kind, for m <= 1. The characteristic n is any number. The
   error is at most 8 ulp. For n > 1 Pi is Cauchy's principal value. Pi is infinite for n = 1 and a finite m. For m = 1
   Pi is infinite for every finite n, with the sign of 1 - n. Pi is 0 for infinite n and a finite m < 1, and for
   m = -infinity and a finite n < 1. Pi is NaN for m > 1, for infinite n with m = 1 or m = -infinity, and for
   m = -infinity with n >= 1. DLMF 19.2.8, 19.6.5. */
VM_API vm_real jacobi_Pi(vm_real n, vm_real m) { return vmi_Pi(n, m, 1 - m); }

/* Pi(n | m) from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_Pi. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_Pi_m1(vm_real n, vm_real m1) { return vmi_Pi(n, 1 - m1, m1); }

/* Returns Pi(n | m) - Pi(n; theta | m) for n < 1 and 0 <= theta <= pi/2, from s = sin theta and c = cos theta. Let psi
   be the angle for which tan theta tan psi = 1/k', and N = (m - n)/(1 - n). Then the result is the integral from 0 to
   psi of (1 - m sin^2 x)/((1 - n)(1 - N sin^2 x)) dx/sqrt(1 - m sin^2 x). The function computes this integral as the
   sum of a term with R_F and a term with R_J. For n > 0 the term with R_J is negative, so that the sum has larger
   errors than its terms. `complete` is Pi(n | m). If the term with R_F is larger than `complete`, *exact becomes 0;
   then the difference 2 Pi(n | m) - Pi(n; theta | m) is a more exact way to Pi(n; pi - theta | m). Otherwise *exact
   becomes 1. */
VM_API vm_real vmi_Pi_complement(vm_two s, vm_two c, vm_real n, vm_real m1, vm_real complete, int *exact)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss;
    const vm_real least = vmi_smaller(ss, 1 / (1 - n)) * m1, lift = vmi_lift_of(least, m1);
    const vm_real more = lift * lift;
    const vm_real y = more * m1, z = more * d, share = y / (1 - n), p = y * ss + share * cc;
    const vm_real top = lift > 1 ? 1 : vmi_larger(z, y);
    vm_two third;
    const vm_real rf = vmi_rf_rj_weighted(y * ss, y, z, p, top, -n * share * cc, &third);
    *exact = lift * (c.hi * rf / (1 - n)) <= complete;
    return lift * (vmi_times_sum(c, vmi_two(rf, 0), third) / (1 - n));
}

/* Returns Pi(n; phi | m) for 1 - m = m1 + m1_lo, a number in two words. For phi between pi/2 and pi, Pi(n; phi | m) is
   2 Pi(n | m) - Pi(n; pi - phi | m), but this difference usually triples the errors. Therefore, for n < 1, the function
   adds the result of vmi_Pi_complement to Pi(n | m) there, if vmi_Pi_complement reports that this sum is more exact. */
VM_API vm_real vmi_Pi_incomplete(vm_real phi, vm_real n, vm_real m, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real part;
    if (m1 < 0 && VM_IS_FINITE(n)) return vmi_Pi_above(phi, n, m, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1) || !VM_IS_FINITE(n)) {
        const vm_real complete = vmi_Pi(n, m, m1);
        if (!(m1 >= 0) || phi != phi || complete != complete) return VM_NAN;
        if (VM_IS_FINITE(phi)) return 0 * phi; /* n or m is infinite, and Pi(n | m) is 0 */
        if (complete == 0) return VM_NAN;
        return VM_COPYSIGN(phi, phi * complete);
    }
    angle = vmi_angle_of(phi);
    if (VM_FABS(angle.turns) == 2 && angle.s.hi * angle.turns < 0 && n < 1 && m1 > 0) {
        const vm_two s = angle.s.hi < 0 ? vmi_minus(angle.s) : angle.s;
        const vm_real complete = vmi_Pi(n, m, m1);
        int exact;
        part = vmi_Pi_complement(s, angle.c, n, m1, complete, &exact);
        if (exact) return VM_COPYSIGN(complete + part, phi);
    }
    part = vmi_Pi_part(angle.s, angle.c, n, m, m1);
    if (angle.turns == 0) return part;
    return vmi_with_turns(angle.turns, vmi_Pi(n, m, m1), part);
}

/* Pi(n; phi | m), the incomplete elliptic integral of the third kind. The characteristic n is any number. Pi is odd in
   phi, and for m <= 1, Pi(phi + pi) = Pi(phi) + 2 Pi(n | m). The error is at most 8 ulp for n <= 1 and |phi| <= 1e9
   (float 1e4). For n > 1 Pi has poles where n sin^2 phi = 1; if rounding makes n sin^2 phi equal to 1, Pi is infinite.
   Beyond the first pole Pi is Cauchy's principal value. For n > 1 the error is at most 16 eps max(|F|, |Pi|), plus the
   effect of changing n by 4 ulp. For a finite phi, Pi is 0 for infinite n and a finite m < 1, and for m = -infinity and
   a finite n < 1. Pi is NaN for those infinite n or m for which jacobi_Pi(n, m) is NaN. For infinite phi and m <= 1, Pi
   is infinite with the sign of phi Pi(n | m), and NaN if Pi(n | m) is 0 or NaN. For m > 1 Pi is NaN where m sin^2 phi >
   1, for |phi| > pi/2, and for infinite m or n. docs/peers.md has the time of a call. DLMF 19.2.7. */
VM_API vm_real jacobi_Pi_incomplete(vm_real phi, vm_real n, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_Pi_incomplete(phi, n, m, m1.hi, m1.lo);
}

/* Pi(n; phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_Pi_incomplete. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_Pi_incomplete_m1(vm_real phi, vm_real n, vm_real m1)
{
    return vmi_Pi_incomplete(phi, n, 1 - m1, m1, 0);
}

#endif
