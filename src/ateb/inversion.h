/* ateb/inversion.h - inversion of the incomplete beta function, for sa and ca in the first quarter of the period

   Symbols, for s in the first quarter and q = 1/(alpha + 1):
     r, d    distances of s from the zero of sa and from the zero of ca; r + d = Pi_alpha/2
     v, u    sa and ca
     w, x    v^2 and 1 - w = u^(alpha+1)
     y, X    2 q d and y^(alpha+1)
     p       (1 - v)/2
   These numbers satisfy two equations. The second one follows from the quadratic transformation of
   2F1(1/2, q; 1 + q; x) (DLMF 15.8(iii)) and defines T:
     r = B_w(1/2, q)/2 = v u 2F1(1, q + 1/2; 3/2; w),
     2 q d = q B_x(q, 1/2) = u (1 + q T), where 1 + q T = 2F1(1, 2q; 1 + q; p).

   Up to r = 0.55 (VMI_ATEB_CHANGE_OVER) the first equation is solved for v; for larger r the second is solved for p. At
   r = 0.55, w < 0.303 and p < 0.251. The code takes a rough v and computes the r that belongs to it by the first
   equation. This r differs little from the given r, and a Taylor series in the difference gives sa and ca. The second
   equation is used in the same way, with p and ln X instead of v and r. Therefore one continued fraction for 2F1 and
   one power are enough.

   Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_INVERSION_H
#define VARMASS_ATEB_INVERSION_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "period.h"
#include "powers.h"

/* Up to this distance r from a zero of sa, sa is computed by vmi_ateb_near_sa_zero; for larger r by
   vmi_ateb_near_ca_zero. */
#define VMI_ATEB_CHANGE_OVER VM_C(0.55)

/* Gauss's continued fraction (DLMF 15.7) is 2F1(1, b; c; z) = 1/(1 - b z/(c Y_1)), where Y_j = 1 - e_j/Y_(j+1) and
     e_(2n-1) = n (c - b + n - 1) z/((c + 2n - 2) (c + 2n - 1)),
     e_(2n) = (b + n) (c + n - 1) z/((c + 2n - 1) (c + 2n)).
   For z < 0.303, two further levels of the fraction give at least 7 more bits. For large j, e_j is nearly z/4; from
   this value the last Y is estimated. VMI_ATEB_W_LEVELS and VMI_ATEB_P_LEVELS are the numbers of levels of the fraction
   in w and of the fraction in p. */
enum { VMI_ATEB_W_LEVELS = VM_MANT_DIG > 24 ? 12 : 6, VMI_ATEB_P_LEVELS = VM_MANT_DIG > 24 ? 12 : 6 };

/* Computes Y_1 = P/Q of Gauss's continued fraction (see above) without a division. Y is the value of Y_(levels+1).
   Element j of e_by_z is e_(j+1)/z, beginning with e_1/z. These elements do not depend on z, so that the processor
   can compute them while it waits for z. */
VM_INLINE void vmi_ateb_fraction(const vm_real *e_by_z, vm_real z, int levels, vm_real Y, vm_real *P, vm_real *Q)
{
    int j;
    *P = Y;
    *Q = 1;
    for (j = levels - 2; j >= 0; j -= 2) {
        const vm_real next = *P - (e_by_z[j + 1] * z) * *Q;
        *P = next - (e_by_z[j] * z) * *P;
        *Q = next;
    }
}

/* Returns (F - 1)/(w (q + 1/2)) for F = 2F1(1, q + 1/2; 3/2; w) and w < 0.303. In Gauss's continued fraction of F,
   e_(j+1)/w is constant[j] + q slope[j]. */
VM_API vm_real vmi_ateb_w_fraction(vm_real q, vm_real w)
{
    VM_TABLE vm_real constant[13] = {VM_C(4.0) / 15,    VM_C(9.0) / 35,    VM_C(16.0) / 63,   VM_C(25.0) / 99,
                                     VM_C(36.0) / 143,  VM_C(49.0) / 195,  VM_C(64.0) / 255,  VM_C(81.0) / 323,
                                     VM_C(100.0) / 399, VM_C(121.0) / 483, VM_C(144.0) / 575, VM_C(169.0) / 675,
                                     VM_C(196.0) / 783};
    VM_TABLE vm_real slope[13] = {VM_C(-4.0) / 15,   VM_C(6.0) / 35,   VM_C(-8.0) / 63,   VM_C(10.0) / 99,
                                  VM_C(-12.0) / 143, VM_C(14.0) / 195, VM_C(-16.0) / 255, VM_C(18.0) / 323,
                                  VM_C(-20.0) / 399, VM_C(22.0) / 483, VM_C(-24.0) / 575, VM_C(26.0) / 675,
                                  VM_C(-28.0) / 783};
    vm_real e_by_w[VMI_ATEB_W_LEVELS + 1], P, Q;
    int j;
    for (j = 0; j <= VMI_ATEB_W_LEVELS; j++) e_by_w[j] = VM_READ(constant[j]) + q * VM_READ(slope[j]);
    vmi_ateb_fraction(e_by_w, w, VMI_ATEB_W_LEVELS, 1 - e_by_w[VMI_ATEB_W_LEVELS] * w * (1 + w * (1 + w / 2) / 4),
                      &P, &Q);
    return Q / (VM_C(1.5) * P - (q + VM_C(0.5)) * w * Q);
}

/* Computes two numbers P and Q with 2F1(1, 2q; 1 + q; p) = P/(P - 2 q p Q/(1 + q)), for p < 0.251. In Gauss's continued
   fraction of this function, e_(j+1)/p is (constant + q slope + q^2 square)/((q + index)(q + index + 1)), where each
   name stands for element j of the table with this name. */
VM_INLINE void vmi_ateb_p_fraction(vm_real q, vm_real p, vm_real *P, vm_real *Q)
{
    VM_TABLE vm_real index[13] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
    VM_TABLE vm_real constant[12] = {1, 1, 4, 4, 9, 9, 16, 16, 25, 25, 36, 36};
    VM_TABLE vm_real slope[12] = {-1, 3, -2, 6, -3, 9, -4, 12, -5, 15, -6, 18};
    VM_TABLE vm_real square[12] = {0, 2, 0, 2, 0, 2, 0, 2, 0, 2, 0, 2};
    vm_real e_by_p[VMI_ATEB_P_LEVELS];
    int j;
    for (j = 0; j < VMI_ATEB_P_LEVELS; j++)
        e_by_p[j] = (VM_READ(constant[j]) + q * (VM_READ(slope[j]) + q * VM_READ(square[j]))) /
                    ((q + VM_READ(index[j])) * (q + VM_READ(index[j + 1])));
    vmi_ateb_fraction(e_by_p, p, VMI_ATEB_P_LEVELS, 1 - p * (1 + p / 2) / 4, P, Q);
}

/* Returns (1 - a^q)/q for a = (1 + t)/(1 - t), where ln a is small. No digits are lost. */
VM_API vm_real vmi_ateb_power_rest(vm_real t, vm_real q)
{
    const vm_real l = vmi_ateb_ln_ratio(t), z = q * l;
    return -l - l * z * vmi_ateb_exp_series(z);
}

/* Computes sa and ca at the distance r from the zero of sa, for 0 <= r <= VMI_ATEB_CHANGE_OVER. q is 1/(alpha + 1).
   `guess` is the power series of sa up to r^9, which is right to 1e-5; its coefficients are polynomials in k = 1 - q. v
   is the guess shortened to half of its digits, so that w = v^2 is exact. u is the ca that belongs to sa = v, and h is
   r minus the r that belongs to v. A Taylor series in e = h/u gives sa and ca. */
VM_API void vmi_ateb_near_sa_zero(vm_real r, vm_real q, vm_real *sa, vm_real *ca)
{
    const vm_real k = 1 - q, rr = r * r, b = q + VM_C(0.5);
    const vm_real c1 = -1 / VM_C(3.0);
    const vm_real c2 = (7 * k - 3) * (1 / VM_C(30.0));
    const vm_real c3 = ((-127 * k + 123) * k - 30) * (1 / VM_C(630.0));
    const vm_real c4 = (((4369 * k - 6822) * k + 3579) * k - 630) * (1 / VM_C(22680.0));
    const vm_real guess = r * (1 + k * rr * ((c1 + rr * c2) + rr * rr * (c3 + rr * c4)));
    const vm_real v = vmi_head(guess), w = v * v, x = 1 - w;
    const vm_real one_minus_u = q * vmi_ateb_power_rest(-w / (2 - w), q), u = 1 - one_minus_u, by_u = 1 / u;
    const vm_real h = (r - v) - v * (w * b * vmi_ateb_w_fraction(q, w) * u - one_minus_u), e = h * by_u;
    *sa = v + x * e * (1 - k * e * (v + (x - (2 - 4 * q) * w) * (e / 3)));
    *ca = 1 - (one_minus_u + h * q * (2 * v + x * e * (1 - k * v * e * VM_C(0.66666666666666667))));
}

/* Returns (2^k (1 + t)/(1 - t))^n/4 with a relative error of 2e-7 (1 + |logarithm of the result|), if the result is a
   normal number. The result is 2^power/4, where power is split into an integer and z between -1/2 and 1/2. */
VM_INLINE vm_real vmi_ateb_rough_power(vm_real k, vm_real t, vm_real n)
{
    const vm_real to_integer = VM_C(1.5) / VM_EPSILON, tt = t * t;
    const vm_real log2 = (VM_C(2.885390422) + tt * VM_C(0.9615889072)) + (tt * tt) * VM_C(0.5957613972);
    const vm_real power = n * k + (n * t) * log2, shifted = vmi_rounded(power + to_integer);
    const vm_real z = power - vmi_rounded(shifted - to_integer), zz = z * z;
    const vm_real low = VM_C(0.2500000189) + z * VM_C(0.173286797);
    const vm_real mid = VM_C(0.06005526871) + z * VM_C(0.01387589279);
    const vm_real high = VM_C(0.00241900798) + z * VM_C(0.0003347715841);
    return vmi_from_bits(vmi_to_bits((low + zz * mid) + (zz * zz) * high) +
                         (vmi_to_bits(shifted) << VMI_STORED_DIG));
}

/* The number y = 2 q d in two words, where q = 1/(alpha + 1) and d is the distance from a zero of ca. The power
   y^(alpha + 1) is X; ln y is vmi_ateb_ln_of(k, t). */
typedef struct VM_TAG(vmi_ateb_base) {
    vm_two y;
    vm_real k, t;
} vmi_ateb_base;

/* Returns 2 q d in two words, for q and d in two words. q and d are split into halves, whose products are exact. */
VM_INLINE vm_two vmi_ateb_twice_q_times(vm_two twice_q, vm_real d, vm_real d_lo)
{
    const vm_real q = twice_q.hi, q_head = vmi_head(q), d_head = vmi_head(d);
    vm_two y;
    y.hi = q * d + 0; /* "+ 0" keeps the compiler from fusing (vmi_two_product) */
    y.lo = (q_head * d_head - y.hi) + (q_head * (d - d_head) + (q - q_head) * d) + (twice_q.lo * d + q * d_lo);
    return y;
}

/* Returns the base y from the distances r and d of s from the zeros of sa and ca. y = 2 q d is also 1 - q z, where z
   = 2 r - (Pi_alpha - (alpha + 1)); this form is used for r < d and y > 0.71. The low word of y matters: for a large
   alpha, a small change of y is a large change of X = y^(alpha+1). For y < 1/2, X is so small that an inexact y.lo is
   enough: it is multiplied by 2 instead of 2^-k. */
VM_INLINE vmi_ateb_base vmi_ateb_base_of(vm_two twice_q, vm_real r, vm_real z, vm_real d, vm_real d_lo)
{
    const vm_real sqrt_half = VM_C(0.70710678118654752), qz = twice_q.hi * (z / 2);
    vmi_ateb_base base;
    vm_real mantissa, scale;
    if (r < d && qz < VM_C(0.29)) {
        base.y.hi = 1 - qz;
        base.y.lo = (1 - base.y.hi) - qz;
        base.k = 0;
        base.t = -qz / (2 - qz);
        return base;
    }
    base.y = vmi_ateb_twice_q_times(twice_q, d, d_lo);
    mantissa = vmi_ateb_mantissa(base.y.hi, &base.k);
    scale = VM_C(1.5) - VM_COPYSIGN(VM_C(0.5), base.y.hi - sqrt_half); /* 2^-k for y > 1/2 */
    base.t = ((mantissa - 1) + scale * base.y.lo) / (mantissa + 1);
    return base;
}

/* Returns p = (1 - sa)/2 within 1e-5, from X4 = X/4, where X = (2 q d)^(alpha+1). p/X4 is computed as a product of two
   factors: a quotient of two linear functions of X4 (a Pade approximant), and the correction 1 + X4^3 q (1 - q)
   (lack0 + lack1 X4). The polynomials lack0 and lack1 in q are fitted by tests/gen/ateb_coefficients.py. */
VM_INLINE vm_real vmi_ateb_guess_p(vm_real q, vm_real X4)
{
    const vm_real k = 1 - q, m = (1 + q) * (2 + q);
    const vm_real lack0 = VM_C(0.1695201) + q * (VM_C(-0.4597204) + q * (VM_C(0.3548526) - q * VM_C(0.1130212)));
    const vm_real lack1 = VM_C(-0.0790485) + q * VM_C(0.1329593);
    return ((m - (q + q * q) * X4) / (m + 2 * (k - q * q) * X4)) *
           (X4 + (X4 * X4) * (X4 * X4) * (q * k * (lack0 + X4 * lack1)));
}

/* Computes sa and ca at the distances r >= VMI_ATEB_CHANGE_OVER from the zero of sa and d from the zero of ca. The
   numbers q = 1/(alpha + 1), y = 2 q d and X = y^(alpha+1) are known. The unknown is p = (1 - sa)/2. From p follow
     v = sa = 1 - 2 p,   x = 1 - v^2 = 4 p (1 - p),   u = ca = x^q,   E = 2F1(1, 2q; 1 + q; p).
   Since y = u E, the wanted p is the solution of ln X = ln x + (alpha + 1) ln E. The derivatives with respect to ln X
   are
     dp/d(ln X) = x E/4,   d ln(u/y)/d(ln X) = -q (1 - v E).
   The function starts from a guess of p. rho is ln X minus the ln X that belongs to the guess; a Taylor series in
   rho gives sa and ca. */
VM_API void vmi_ateb_near_ca_zero(vm_real r, vm_real d, const vmi_ateb *c, vm_real *sa, vm_real *ca)
{
    const vm_real least_ln = -(vm_real)(VM_MANT_DIG + 2) * VM_C(0.6931471805599453); /* X < eps/8 may be neglected */
    const vm_real n = c->n.hi, q = c->q.hi, twice_q = 2 * q;
    const vmi_ateb_base base = vmi_ateb_base_of(vmi_two(twice_q, 2 * c->q.lo), r, (2 * r - c->g.hi) - c->g.lo, d, 0);
    const vm_real y = base.y.hi, ln_X = n * vmi_ateb_ln_of(base.k, base.t);
    vm_real p, v, P, Q;       /* a guess of p, its v = 1 - 2 p, and the results of vmi_ateb_p_fraction */
    vm_real B, E, E_loss;     /* B = 2 q p Q/(1 + q), E = P/(P - B), E_loss = 1 - 1/E, so that u = y (1 - E_loss) */
    vm_real rho, vE;          /* vE = v E */
    vm_real sa_rate, ca_rate; /* -d(sa)/d(ln X) and -d ln(ca/y)/d(ln X) */
    vm_real sa_change, ca_change;
    *sa = 1;
    *ca = y + base.y.lo;
    if (!(y > VM_MIN) || !(ln_X > least_ln)) return;
    p = vmi_ateb_guess_p(q, vmi_ateb_rough_power(base.k, base.t, n));
    v = 1 - 2 * p;
    vmi_ateb_p_fraction(q, p, &P, &Q);
    B = twice_q / (1 + q) * p * Q;
    E = P / (P - B);
    E_loss = B / P;
    rho = (ln_X - vmi_ateb_ln(4 * p * (1 - p))) - n * vmi_ateb_ln_ratio(B / (2 * P - B));
    vE = v * E;
    sa_rate = 2 * p * (1 - p) * E;
    ca_rate = q * (1 - vE);
    sa_change = (sa_rate * rho) * (1 + rho * ((q + (1 - q) * vE) / 2));
    ca_change = ((1 - E_loss) * rho) * (ca_rate - rho * ((ca_rate * (ca_rate + q * vE) - q * sa_rate * E) / 2));
    *sa = 1 - (2 * p + sa_change);
    *ca = y - (y * (E_loss + ca_change) - base.y.lo);
}

#endif
