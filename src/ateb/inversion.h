/* ateb/inversion.h - inversion of the incomplete beta function */
#ifndef VARMASS_ATEB_INVERSION_H
#define VARMASS_ATEB_INVERSION_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "period.h"
#include "powers.h"

/* ---- Inversion of the incomplete beta function ---------------------------------------------------------------

   With w = sa^2, x = 1 - w = |ca|^(alpha+1), r the distance of s from the zero of sa and d from that of ca,
     r = B_w(1/2, q)/2 = sa |ca| 2F1(1, q + 1/2; 3/2; w)
     2 q d = q B_x(q, 1/2) = |ca| (1 + q T),  1 + q T = 2F1(1, 2q; 1+q; p),           p = (1 - sa)/2
   the second by the quadratic transformation of 2F1(1/2, q; 1+q; x). At the change-over, r = 0.55, w < 0.303
   and p < 0.251. */
/* Gauss's continued fraction [3, 15.7]: 2F1(1, b; c; z) = 1/(1 - b z/(c Y_1)), Y_j = 1 - e_j/Y_(j+1), e_(2n-1) =
   n (c - b + n - 1) z/((c + 2n - 2) (c + 2n - 1)), e_2n = (b + n) (c + n - 1) z/((c + 2n - 1) (c + 2n)). What does
   not depend on z is made ahead of it. Two levels gain 7 bits or more for z < 0.303; e_j tends to z/4. */
enum { VMI_ATEB_W_LEVELS = VM_MANT_DIG > 24 ? 12 : 6, VMI_ATEB_P_LEVELS = VM_MANT_DIG > 24 ? 12 : 6 };

/* Y_1 = P/Q from the Y after the last of the levels */
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

/* (F - 1)/(w (q + 1/2)) for F = 2F1(1, q + 1/2; 3/2; w), w < 0.303 */
VM_API vm_real vmi_ateb_w_fraction(vm_real q, vm_real w)
{
    VM_TABLE vm_real constant[14] = {VM_C(4.0) / 15,    VM_C(9.0) / 35,    VM_C(16.0) / 63,   VM_C(25.0) / 99,
                                     VM_C(36.0) / 143,  VM_C(49.0) / 195,  VM_C(64.0) / 255,  VM_C(81.0) / 323,
                                     VM_C(100.0) / 399, VM_C(121.0) / 483, VM_C(144.0) / 575, VM_C(169.0) / 675,
                                     VM_C(196.0) / 783, VM_C(225.0) / 899};
    VM_TABLE vm_real slope[14] = {VM_C(-4.0) / 15,   VM_C(6.0) / 35,   VM_C(-8.0) / 63,   VM_C(10.0) / 99,
                                  VM_C(-12.0) / 143, VM_C(14.0) / 195, VM_C(-16.0) / 255, VM_C(18.0) / 323,
                                  VM_C(-20.0) / 399, VM_C(22.0) / 483, VM_C(-24.0) / 575, VM_C(26.0) / 675,
                                  VM_C(-28.0) / 783, VM_C(30.0) / 899};
    vm_real e_by_w[VMI_ATEB_W_LEVELS + 2], P, Q;
    int j;
    for (j = 0; j < VMI_ATEB_W_LEVELS + 2; j++) e_by_w[j] = VM_READ(constant[j]) + q * VM_READ(slope[j]);
    vmi_ateb_fraction(e_by_w, w, VMI_ATEB_W_LEVELS, 1 - e_by_w[VMI_ATEB_W_LEVELS] * w * (1 + w * (1 + w / 2) / 4),
                      &P, &Q);
    return Q / (VM_C(1.5) * P - (q + VM_C(0.5)) * w * Q);
}

/* P and Q of F = 2F1(1, 2 q; 1 + q; p) = P/(P - 2 q p Q/(1 + q)), p < 0.251 */
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

/* T with 1 + q T = 2F1(1, 2 q; 1 + q; p) */
VM_API vm_real vmi_ateb_T(vm_real q, vm_real p)
{
    vm_real P, Q;
    vmi_ateb_p_fraction(q, p, &P, &Q);
    return 2 * p * Q / ((1 + q) * P - 2 * q * p * Q);
}

/* (1 - a^q)/q with a = (1 + t)/(1 - t) of which ln a is small */
VM_API vm_real vmi_ateb_power_rest(vm_real t, vm_real q)
{
    const vm_real l = vmi_ateb_ln_ratio(t), z = q * l;
    return -l - l * z * vmi_ateb_exp_series(z);
}

/* sa and ca for 0 <= r <= 0.55. The guess v, the Taylor series of the inverse to r^9, is within 1e-5; its r is
   computed, and Taylor's series in what is left of r leads from there. */
VM_API void vmi_ateb_near_sa_zero(vm_real r, vm_real q, vm_real *sa, vm_real *ca)
{
    const vm_real k = 1 - q, rr = r * r, b = q + VM_C(0.5);
    const vm_real c1 = -1 / VM_C(3.0);
    const vm_real c2 = (7 * k - 3) * (1 / VM_C(30.0));
    const vm_real c3 = ((-127 * k + 123) * k - 30) * (1 / VM_C(630.0));
    const vm_real c4 = (((4369 * k - 6822) * k + 3579) * k - 630) * (1 / VM_C(22680.0));
    const vm_real guess = r * (1 + k * rr * ((c1 + rr * c2) + rr * rr * (c3 + rr * c4)));
    const vm_real v = vmi_head(guess), w = v * v /* exact */, x = 1 - w;
    const vm_real one_minus_u = q * vmi_ateb_power_rest(-w / (2 - w), q), u = 1 - one_minus_u, by_u = 1 / u;
    const vm_real h = (r - v) - v * (w * b * vmi_ateb_w_fraction(q, w) * u - one_minus_u), e = h * by_u;
    *sa = v + x * e * (1 - k * e * (v + (x - (2 - 4 * q) * w) * (e / 3)));
    *ca = 1 - (one_minus_u + h * q * (2 * v + x * e * (1 - k * v * e * VM_C(0.66666666666666667))));
}

/* (2^k (1 + t)/(1 - t))^n/4 to a relative error of 2e-7 (1 + |its logarithm|), for a normal result */
VM_INLINE vm_real vmi_ateb_rough_power(vm_real k, vm_real t, vm_real n)
{
    const vm_real to_integer = VM_C(1.5) / VM_EPSILON, x = t * t;
    const vm_real log2 = (VM_C(2.885390422) + x * VM_C(0.9615889072)) + (x * x) * VM_C(0.5957613972);
    const vm_real power = n * k + (n * t) * log2, shifted = vmi_rounded(power + to_integer);
    const vm_real z = power - vmi_rounded(shifted - to_integer), zz = z * z;
    const vm_real low = VM_C(0.2500000189) + z * VM_C(0.173286797);
    const vm_real mid = VM_C(0.06005526871) + z * VM_C(0.01387589279);
    const vm_real high = VM_C(0.00241900798) + z * VM_C(0.0003347715841);
    return vmi_from_bits(vmi_to_bits((low + zz * mid) + (zz * zz) * high) +
                         (vmi_to_bits(shifted) << VMI_STORED_DIG));
}

/* y = 2 q d = 1 - q z in two words and ln y = vmi_ateb_ln_of(k, t) */
typedef struct VM_TAG(vmi_ateb_base) {
    vm_two y;
    vm_real k, t;
} vmi_ateb_base;

/* With z = 2 r - g. From r or d, whichever is smaller; for r < d is y > 1/2. Where alpha ln y is large, so is its
   derivative by y: the low word counts. */
VM_INLINE vmi_ateb_base vmi_ateb_base_of(vm_two twice_q, vm_real r, vm_real z, vm_real d, vm_real d_lo)
{
    const vm_real sqrt_half = VM_C(0.70710678118654752), qz = twice_q.hi * (z / 2);
    vmi_ateb_base base;
    vm_real mantissa, scale;
    if (r < d) {
        base.y.hi = 1 - qz;
        base.y.lo = (1 - base.y.hi) - qz;
    } else if (d < 1 / VM_EPSILON) {
        base.y = vmi_two_product(twice_q.hi, d);
        base.y.lo += twice_q.lo * d + twice_q.hi * d_lo;
    } else base.y = vmi_two(twice_q.hi * d, 0); /* where X underflows */
    mantissa = vmi_ateb_mantissa(base.y.hi, &base.k);
    scale = VM_C(1.5) - VM_COPYSIGN(VM_C(0.5), base.y.hi - sqrt_half); /* 1 or 2 for y > 1/2 */
    base.t = ((mantissa - 1) + scale * base.y.lo) / (mantissa + 1);
    return base;
}

/* sa and ca for r >= 0.55. In terms of y = 2 q d = u (1 + q T) and of l = (alpha + 1) ln y = ln X,
     l = ln x + (alpha + 1) ln(1 + q T),   dp/dl = x (1 + q T)/4,   d ln(u/y)/dl = -q (1 - v (1 + q T)).
   For a p within 1e-5 of the right one, l is computed; Taylor's series leads from there. The guess: the (1, 1) Pade
   approximant of p/X and what it lacks. */
VM_API void vmi_ateb_near_ca_zero(vm_real r, vm_real d, const vmi_ateb *c, vm_real *sa, vm_real *ca)
{
    const vm_real negligible = -(vm_real)(VM_MANT_DIG + 2) * VM_C(0.6931471805599453); /* ln(eps/8) */
    const vm_real n = c->n.hi, q = c->q.hi, k1 = 1 - q, two_q = 2 * q, m = (1 + q) * (2 + q),
                  share = two_q / (1 + q);
    const vm_real lack0 = VM_C(0.1695201) + q * (VM_C(-0.4597204) + q * (VM_C(0.3548526) - q * VM_C(0.1130212)));
    const vm_real lack1 = VM_C(-0.0790485) + q * VM_C(0.1329593);
    const vmi_ateb_base base = vmi_ateb_base_of(vmi_two(two_q, 2 * c->q.lo), r, (2 * r - c->g.hi) - c->g.lo, d, 0);
    const vm_real y = base.y.hi, l = n * vmi_ateb_ln_of(base.k, base.t);
    vm_real X4, p, v, P, Q, B, E, F, rho, w, dv, da;
    *sa = 1;
    *ca = y + base.y.lo;
    if (!(y > VM_MIN) || !(l > negligible)) return;
    X4 = vmi_ateb_rough_power(base.k, base.t, n);
    p = ((m - (q + q * q) * X4) / (m + 2 * (k1 - q * q) * X4)) *
        (X4 + (X4 * X4) * (X4 * X4) * (q * k1 * (lack0 + X4 * lack1)));
    v = 1 - 2 * p;
    vmi_ateb_p_fraction(q, p, &P, &Q);
    B = share * p * Q; /* 1 + q T = P/(P - B) */
    E = P / (P - B);
    F = B / P;
    rho = (l - vmi_ateb_ln(4 * p * (1 - p))) - n * vmi_ateb_ln_ratio(B / (2 * P - B));
    w = v * E;
    dv = 2 * p * (1 - p) * E;
    da = q * (1 - w);
    *sa = 1 - (2 * p + (dv * rho) * (1 + rho * ((q + k1 * w) / 2)));
    *ca = y - (y * (F + ((1 - F) * rho) * (da - rho * ((da * (da + q * w) - q * dv * E) / 2))) - base.y.lo);
}

#endif
