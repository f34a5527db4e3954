/* jacobi/theta.h - Neville's theta functions, from which sn, cn and dn are quotients

   There are four theta functions, theta_s, theta_c, theta_d and theta_n. Each of the twelve elliptic functions is a
   quotient of two theta functions: sn = theta_s/theta_n, and so on. The theta functions are computed for an argument v
   that was reduced to |v| <= K/2. A factor that all four have in common does not matter, since the factor cancels in
   every quotient. No subtraction loses digits, so that each theta function has a small relative error.
   Near 0 (see VMI_NEAR) the theta functions come from the power series of cs^2 = (cn/sn)^2, which begins with 1/v^2 (a
   Laurent series), and from two duplications. An argument far from 0 occurs only for m near 1 or below about -21. There
   the theta functions come from series in a nome, which is at most 0.003. The nome of a parameter m is the number
   exp(-pi K(1 - m)/K(m)).

   Source: DLMF 20.2, 20.7, 22.6, 23.9. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_THETA_H
#define VARMASS_JACOBI_THETA_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* The numbers from which the theta functions far from 0 are computed for a parameter m. vmi_far_prepare writes these
   numbers, and its comment explains them. */
typedef struct VM_TAG(vmi_theta_form) {
    vm_real kp, kp_lo; /* k' = sqrt(1 - m); its low word kp_lo is used in the reciprocal form only */
    vm_real q;         /* the nome of 1 - m, or of 1/(1 - m) in the reciprocal form */
    vm_real defect;    /* 1 - z/v, where z is the phase and v is u, or k' u in the reciprocal form */
    vm_real f[3], g[2], scale[2]; /* coefficients of P and Q, coefficients of E, factors of theta_s and theta_c */
} vmi_theta_form;

/* The three methods, in this order: the series near 0; theta functions with the nome of 1 - m, for m near 1; theta
   functions with the nome of 1/(1 - m), for m below about -21 */
enum { VMI_NEAR_FORM, VMI_HYPERBOLIC, VMI_RECIPROCAL };

/* The number of terms of a plan's polynomials, without the constant term */
enum { VMI_TERMS = VM_MANT_DIG > 24 ? 10 : 5 };

/* The four theta functions theta_s, theta_c, theta_d and theta_n, all multiplied by one common factor. Each elliptic
   function is a quotient of two of them, such as sn = s/n. */
typedef struct VM_TAG(vmi_thetas) {
    vm_real s, c, d, n;
} vmi_thetas;

/* The Laurent series is used if v^2 max(1, 1 - m) is at most this number. For -21.5 < m < 0.955 all v with |v| <= K/2
   satisfy this condition. */
#define VMI_NEAR VM_C(2.2)

/* Computes the terms c_1, c_2, c_3 of w^2 cs^2(w) = 1 + c_1 + c_2 + ..., where c_k is proportional to w^(2k), from
   theta = w^2 and m1_theta = (1 - m) w^2.
   Since cs^2(w) + (2 - m)/3 is Weierstrass' function of w (DLMF 23.9), for k > 3
     c_k = 3/((2k + 1)(k - 3)) (c_2 c_(k-2) + c_3 c_(k-3) + ... + c_(k-2) c_2) */
VM_INLINE void vmi_laurent(vm_real theta, vm_real m1_theta, vm_real *c)
{
    const vm_real e = theta + m1_theta, product = theta * m1_theta, ee = e * e;
    c[1] = -e * VM_C(0.3333333333333333333);
    c[2] = (ee - 3 * product) * VM_C(0.06666666666666666667);
    c[3] = e * (9 * product - 2 * ee) * VM_C(5.291005291005291005e-3);
}

/* Returns the theta functions near 0, from the series at w = v/4 to the ninth term (float: the fifth) and two
   duplications. Only theta.c and the local variables a and f are computed by subtractions; none of them is near 0.
   A duplication leads from w to 2w. Let sc = sn/cn, and let a and b be numbers with b/a = sc^2(w). Then
     sc^2(2w) = 4 a b (a + b)(a + m1 b)/(a^2 - m1 b^2)^2,
   and the four theta functions s, c, d and n of 2w have the ratios
     s : c : d : n = 2 sqrt(a b (a + b)(a + m1 b)) : a^2 - m1 b^2 : a^2 + 2 m1 a b + m1 b^2 : a^2 + 2 a b + m1 b^2. */
VM_INLINE vmi_thetas vmi_theta_near(vm_real v, vm_real m1)
{
    vmi_thetas theta;
    const vm_real w = v / 4, w2 = w * w, r = m1 * w * w; /* m1 * w2 might underflow */
    vm_real c[4], more, a, f, g, b, s, aa, rb;
#if VM_MANT_DIG > 24
    vm_real c22;
#endif
    vmi_laurent(w2, r, c);
#if VM_MANT_DIG > 24
    c22 = c[2] * c[2];
    more = c22 * ((VM_C(0.3333333333333333333) + c22 * VM_C(7.541478129713423831e-3)) +
                  (c[2] * VM_C(0.05128205128205128205) + c[3] * VM_C(0.06060606060606060606))) +
           c[3] * (c[2] * ((VM_C(0.2727272727272727273) + c[3] * VM_C(0.02468120115178938708)) +
                           c22 * VM_C(0.01067353698932646301)) +
                   c[3] * (VM_C(0.07692307692307692308) + c[3] * VM_C(4.048582995951417004e-3)));
#else
    more = c[2] * (c[2] * VM_C(0.3333333333) + c[3] * VM_C(0.2727272727));
#endif
    a = 1 + ((c[1] + (c[2] + c[3])) + more);
    f = a * a - r * w2;
    g = a * ((a + w2) * (a + r)); /* now sc^2(2w) = 4 w^2 g/f^2; the lines below write this as b/a */
    b = 4 * w2 * g;
    s = 4 * r * g;
    a = f * f;
    aa = a * a;
    rb = s * b;
    theta.s = v * (f * VM_SQRT(g * ((a + b) * (a + s))));
    theta.c = aa - rb;
    theta.d = aa + (2 * s * a + rb);
    theta.n = aa + (2 * b * a + rb);
    return theta;
}

/* Prepares the theta functions far from 0. They belong to a small parameter c <= 0.05, whose nome is q; k is
   sqrt(1 - c). The argument of these theta functions is an imaginary number i z, and z is called the phase.
     For m near 1 (the hyperbolic form), c = 1 - m and z = u agm(1, k).
     For m below about -21 (the reciprocal form), c = 1/(1 - m) and z = k' u agm(1, k), since
       sn(u | m) = sd(k' u | m/(m - 1))/k'.
   Here agm(1, k) is the arithmetic-geometric mean (jacobi/agm.h). theta_s, theta_c, theta_d, theta_n are multiples of
   the classical theta functions theta_1, theta_4, theta_3, theta_2; in the reciprocal form theta_d and theta_n change
   places. With X = q cosh 2z, which is at most sqrt(q)/2 = 0.03,
     theta_1, theta_2 ~ 2 sinh z (P - Q), 2 cosh z (P + Q),  P = f0 + f2 X^2,  Q = f1 X,
     theta_3, theta_4 = E + O, E - O,                        E = 1 + (g1 X^2 - g0),  O = 2 X.
   f0, f1, f2 and g0, g1 are the elements of the fields f and g. The terms that are left out are below 1e-18. f contains
   the constant factor that makes theta_d/theta_n = dn, so that f0 is near 1/2. The factors `scale` belong to theta_s
   and theta_c. They are near 1, but in the reciprocal form the factor of theta_s contains 1/k'. The variable x is the
   parameter that one step of the arithmetic-geometric mean from 1 and k makes of c. */
VM_API void vmi_far_prepare(vmi_theta_form *t, vm_real m1, vm_real m1_lo)
{
    const vm_real c = vmi_smaller(m1, 1 / m1), root = VM_SQRT(1 - c), fourth = VM_SQRT(root);
    const vm_real half = c / (2 * (1 + root)), k1 = 2 * half / (1 + root), x = k1 * k1;
    vm_two kp = vmi_two(VM_SQRT(m1), 0);
    vm_real q2, q4, q6, even, odd, f0, share;
    if (m1 > 1) kp = vmi_root(m1, m1_lo);
    t->kp = kp.hi;
    t->kp_lo = kp.lo;
    t->q = k1 / 4 * (1 + x * (VM_C(0.25) + x * (VM_C(0.1328125) + x * VM_C(0.087890625))));
    t->defect = half + (1 - half) * (x * (VM_C(0.25) + x * (VM_C(0.078125) + x * VM_C(0.04296875))));
    q2 = t->q * t->q;
    q4 = q2 * q2;
    q6 = q2 * q4;
    even = q2 + q6;
    odd = 2 * t->q + 2 * q4;
    f0 = ((odd - 2 * even) - even * odd) / (2 * (1 + even)); /* the field f[0] minus 1/2 */
    t->f[0] = VM_C(0.5) + f0;
    share = t->f[0] / (1 - even);
    t->f[1] = share * 2 * t->q * (1 - q4);
    t->f[2] = share * 4 * q4;
    t->g[0] = 2 * q4;
    t->g[1] = 4 * q2;
    t->scale[1] = 1 + 2 * half / ((1 + fourth) * fourth);
    t->scale[0] = t->scale[1];
    if (m1 > 1) t->scale[0] = (t->scale[1] - t->scale[1] * kp.lo / kp.hi) / kp.hi;
}

/* For m = 1 this number replaces every larger argument, for which tanh rounds to 1 and 1/cosh to 0. The number is below
   2 VMI_BIAS ln 2, a condition of vmi_far_exponentials. */
#define VMI_LONGEST (VM_MANT_DIG > 24 ? VM_C(1400.0) : VM_C(170.0))

/* The result of vmi_far_exponentials for a number z. With the whole number n that is nearest to z/ln 2, the fields are
   sine = 2^(1-n) sinh z, cosine = 2^(1-n) cosh z, power = 2^-n, and lift = 2^n. */
typedef struct VM_TAG(vmi_exponentials) {
    vm_real sine, cosine, power, lift;
} vmi_exponentials;

/* Returns the four numbers of vmi_exponentials for the argument z + z_lo, where 0 <= z <= VMI_LONGEST and |z_lo| is at
   most an ulp of z. The relative errors are at most 1.3 ulp. The field `lift` is wrong for n > VMI_BIAS, where 2^n
   overflows. Method: z = n ln 2 + r with |r| < 0.35. Polynomials in r^2 give S = sinh r and C = cosh r - 1. Then
     sine = (1 - 4^-n) + (S (1 + 4^-n) + C (1 - 4^-n)),
     cosine = (1 + 4^-n) + (C (1 + 4^-n) + S (1 - 4^-n)). */
VM_INLINE vmi_exponentials vmi_far_exponentials(vm_real z, vm_real z_lo)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360), to_integer = VM_C(1.5) / VM_EPSILON;
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const vm_real shifted = vmi_rounded(z * one_over_ln2 + to_integer), n = vmi_rounded(shifted - to_integer);
    const vmi_bits n_bits = vmi_to_bits(shifted) & 4095, half = n_bits >> 1; /* the last bits of `shifted` are n */
    const vm_real z_rest = z - n * ln2_hi, subtract = n * ln2_lo - z_lo; /* z_rest has no rounding error */
    const vm_real r = z_rest - subtract, r_lo = (z_rest - r) - subtract, y = r * r;
#if VM_MANT_DIG > 24
    const vm_real P01 = VM_C(0.16666666666666668517) + y * VM_C(0.0083333333333300511209);
    const vm_real P23 = VM_C(1.9841269863105952189e-4) + y * VM_C(2.7557268378709607623e-6);
    const vm_real C01 = VM_C(0.50000000000000011102) + y * VM_C(0.041666666666623990156);
    const vm_real C23 = VM_C(0.0013888888917281772082) + y * VM_C(2.4801521190250773045e-5);
    const vm_real yy = y * y, P = P01 + yy * (P23 + yy * VM_C(2.5100424144926962655e-8));
    const vm_real C = y * (C01 + yy * (C23 + yy * VM_C(2.7620138704027969927e-7)));
#else
    const vm_real P = VM_C(0.166666671634) + y * (VM_C(0.00833331048489) + y * VM_C(1.9891030388e-4));
    const vm_real C = y * (VM_C(0.5) + y * (VM_C(0.0416664630175) + y * VM_C(0.0013933685841)));
#endif
    const vm_real S = r + (r_lo + r * y * P);
    vmi_exponentials e;
    vm_real sum, difference; /* 1 + 4^-n and 1 - 4^-n */
    e.power = vmi_from_bits((VMI_BIAS - half) << VMI_STORED_DIG) *
              vmi_from_bits((VMI_BIAS - (n_bits - half)) << VMI_STORED_DIG); /* 2^-n may be subnormal */
    e.lift = vmi_from_bits((VMI_BIAS + n_bits) << VMI_STORED_DIG);
    sum = 1 + e.power * e.power;
    difference = 1 - e.power * e.power;
    e.sine = difference + (S * sum + C * difference);
    e.cosine = sum + (C * sum + S * difference);
    return e;
}

/* Returns the theta functions far from 0, for |argument| <= VMI_LONGEST. In the reciprocal form the argument is k'
   times that of the elliptic functions. All four theta functions are multiplied by the power of two 2^-n, with the n of
   vmi_exponentials, so that they do not overflow. */
VM_INLINE vmi_thetas vmi_theta_far(const vmi_theta_form *t, int reciprocal, vm_two argument)
{
    vmi_thetas theta;
    const vm_real tiny = VM_EPSILON * VM_EPSILON; /* a smaller nome changes no result: X <= sqrt(q)/2 < eps */
    const vm_real sign = VM_COPYSIGN((vm_real)1, argument.hi), v = sign * argument.hi, product = v * t->defect;
    const vm_real z = v - product, z_lo = ((v - z) - product) + sign * argument.lo;
    const vmi_exponentials e = vmi_far_exponentials(z, z_lo);
    vm_real X = 0, XX, P, Q, E, O, d, n;
    if (t->q > tiny) X = (t->q / 2 * e.lift * e.lift) * (e.cosine * e.cosine) - t->q; /* cosh 2z is 2 cosh^2 z - 1 */
    XX = X * X;
    P = t->f[2] * XX; /* P without its term f[0] */
    Q = t->f[1] * X;
    E = t->g[1] * XX - t->g[0]; /* E without its term 1 */
    O = 2 * X;
    d = e.power * (1 + (E + O));
    n = e.cosine * (t->f[0] + (P + Q));
    theta.s = (sign * t->scale[0]) * e.sine * (t->f[0] + (P - Q));
    theta.c = (t->scale[1] * e.power) * (1 + (E - O));
    theta.d = d;
    theta.n = n;
    if (reciprocal) {
        theta.d = n;
        theta.n = d;
    }
    return theta;
}

/* Returns the theta functions far from 0 for a single v and m, without a plan. */
VMI_APART vmi_thetas vmi_theta_far_unprepared(vm_two v, vm_real m1, vm_real m1_lo)
{
    vmi_theta_form t;
    vmi_far_prepare(&t, m1, m1_lo);
    if (m1 > 1) v = vmi_two_times(v, vmi_two(t.kp, t.kp_lo));
    return vmi_theta_far(&t, m1 > 1, v);
}

/* Returns the theta functions at an argument that is larger by `quarters` quarter periods; only the last two bits of
   `quarters` are used. One quarter period turns s, c, d, n into c, -k' s, k' n, d. Two quarter periods change the signs
   of s and c; a common factor is left out. Products with 0, 1 and -1 replace a branch, which the processor would
   predict wrongly half the time. */
VM_INLINE vmi_thetas vmi_theta_shift(vmi_thetas theta, vm_real kp, vmi_bits quarters)
{
    const vmi_bits one = vmi_to_bits(1), odd = (vmi_bits)0 - (quarters & 1);
    const vmi_bits sign = (quarters >> 1 & 1) << (sizeof(vm_real) * 8 - 1);
    const vm_real stays = vmi_from_bits((one & ~odd) ^ sign), turns = vmi_from_bits((one & odd) ^ sign);
    const vm_real stay = stays * stays, turn = turns * turns;
    vmi_thetas shifted;
    shifted.s = stays * theta.s + turns * theta.c;
    shifted.c = stays * theta.c - turns * kp * theta.s;
    shifted.d = stay * theta.d + turn * kp * theta.n;
    shifted.n = stay * theta.n + turn * theta.d;
    return shifted;
}

/* Computes sn, cn and dn as quotients of the theta functions. A dn that is not between 1 and `bound` is replaced by the
   nearer of these two numbers. */
VM_INLINE void vmi_theta_ratios(vmi_thetas theta, vm_real bound, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real low = vmi_smaller(bound, 1), high = vmi_larger(bound, 1), per_n = 1 / theta.n;
    *sn = vmi_clamp(theta.s, -theta.n, theta.n) * per_n; /* |sn| <= 1, since n (1/n) rounds to at most 1 */
    *cn = vmi_clamp(theta.c, -theta.n, theta.n) * per_n;
    *dn = vmi_clamp(theta.d * per_n, low, high);
}

#endif
