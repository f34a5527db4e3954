/* jacobi/third_kind.h - elliptic integrals of the third kind, theta functions of complex argument

   The attitude of a body that rotates without torque needs, besides sn, cn and dn, the complete integral of the third
   kind Pi(-N | m) and theta functions of a complex argument. The integrals are computed here in two words, because the
   rates that follow from them are multiplied by long times; with two words the attitude stays right even after a
   million turns (mechanics/torque_free.h). The theta functions are computed in one word. All functions of this file are
   internal. p is the number of binary digits of vm_real.

   Source: DLMF 19.8, 19.36, 20.7. Tests: tests/test_torque_free.c. */
#ifndef VARMASS_JACOBI_THIRD_KIND_H
#define VARMASS_JACOBI_THIRD_KIND_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "theta.h"

/* Returns Carlson's symmetric integral R_F(x, y, z) in two words, for x, y, z >= 0 of which at most one is 0.
   Duplications (jacobi/carlson.h), usually 7, bring the arguments together, until the series in their differences (DLMF
   19.36.1) has an error of 2^-(2p - 4), where p is the number of binary digits of vm_real. If two of the arguments are
   much smaller than the third one, and the larger of these two is 2^-n times the third one, about log2(n) more
   duplications are needed. */
VM_API vm_two vmi_carlson_rf(vm_two x, vm_two y, vm_two z)
{
    const vm_real enough = VM_SQRT(VM_SQRT(VM_EPSILON));
    vm_two A, X, Y, Z, E2, E3, sum;
    vm_real e2, e3, rest;
    for (;;) {
        A = vmi_two_over(vmi_two_plus(vmi_two_plus(x, y), z), vmi_two(3, 0));
        X = vmi_two_over(vmi_two_minus(A, x), A);
        Y = vmi_two_over(vmi_two_minus(A, y), A);
        Z = vmi_two_shifted(vmi_two_plus(X, Y), -1);
        if (!(VM_FABS(X.hi) > enough || VM_FABS(Y.hi) > enough || VM_FABS(Z.hi) > enough)) break;
        X = vmi_two_root(x);
        Y = vmi_two_root(y);
        Z = vmi_two_root(z);
        A = vmi_two_plus(vmi_two_times(X, vmi_two_plus(Y, Z)), vmi_two_times(Y, Z));
        x = vmi_two_shifted(vmi_two_plus(x, A), VM_C(0.25));
        y = vmi_two_shifted(vmi_two_plus(y, A), VM_C(0.25));
        z = vmi_two_shifted(vmi_two_plus(z, A), VM_C(0.25));
    }
    E2 = vmi_two_times(X, Y);
    E3 = vmi_two_times(E2, Z);
    E2 = vmi_two_minus(E2, vmi_two_times(Z, Z));
    e2 = E2.hi;
    e3 = E3.hi;
    rest = e2 * e2 * (VM_C(1.0) / 24 - VM_C(5.0) / 208 * e2 + e3 / 16) +
           e3 * (VM_C(3.0) / 104 * e3 - VM_C(3.0) / 44 * e2);
    sum = vmi_two_minus(vmi_two_over(E3, vmi_two(14, 0)), vmi_two_over(E2, vmi_two(10, 0)));
    sum = vmi_two_plus(vmi_two(1, 0), vmi_two_plus(sum, vmi_two(rest, 0)));
    return vmi_two_over(sum, vmi_two_root(A));
}

/* The complete integral of the third kind, Pi(-N | m), divided by K(m), and the mean from which K(m) follows */
typedef struct VM_TAG(vmi_third_kind) {
    vm_two mean;  /* agm(1, k') = pi/(2K) */
    vm_two ratio; /* Pi(-N | m)/K(m) */
    vm_two rest;  /* 1 - Pi(-N | m)/K(m) */
} vmi_third_kind;

/* Returns the complete integral of the third kind for m1 = 1 - m > 0 and N >= 0, where share = N/(1 + N) and
   below = 1/(1 + N). The method begins with p = sqrt(1 + N), Q = 1 and the numbers a = 1, g = k' of the
   arithmetic-geometric mean (DLMF 19.8.6-7). Each step replaces a and g by their two means, and p and Q by p+ and Q+:
     e = (p^2 - a g)/(p^2 + a g),  p+ = (p^2 + a g)/(2p),  Q+ = Q e/2.
   The field rest = 1 - Pi/K is share/2 times the sum of all Q. This sum is also 2 minus the sum of all Q (1 - e).
   Therefore the field ratio = Pi/K is `below` plus share/2 times the sum of all Q (1 - e). For m >= 0 all terms of both
   fields are positive, so that both are accurate for any N. */
VM_API vmi_third_kind vmi_third_kind_ladder(vm_two m1, vm_two share, vm_two below)
{
    vm_two a = vmi_two(1, 0), g = vmi_two_root(m1), p = vmi_two_root(vmi_two_over(a, below)), Q = a, ag, pp, above;
    vm_two sum = vmi_two(0, 0), less = sum;
    vmi_third_kind result;
    int step;
    for (step = 0; step < 200; step++) { /* 5 to 10 steps, and one more for each binary digit of sqrt(1 + N) */
        const vm_real apart = VM_FABS(a.hi - g.hi);
        ag = vmi_two_times(a, g);
        pp = vmi_two_times(p, p);
        above = vmi_two_plus(pp, ag);
        sum = vmi_two_plus(sum, Q);
        less = vmi_two_plus(less, vmi_two_times(Q, vmi_two_over(vmi_two_shifted(ag, 2), above)));
        Q = vmi_two_shifted(vmi_two_times(Q, vmi_two_over(vmi_two_minus(pp, ag), above)), VM_C(0.5));
        p = vmi_two_over(above, vmi_two_shifted(p, 2));
        a = vmi_two_shifted(vmi_two_plus(a, g), VM_C(0.5));
        g = vmi_two_root(ag);
        if (!(apart > VM_EPSILON * a.hi) && !(VM_FABS(Q.hi) > VM_EPSILON * VM_EPSILON / 4 * less.hi)) break;
    }
    result.mean = a;
    share = vmi_two_shifted(share, VM_C(0.5));
    result.ratio = vmi_two_plus(below, vmi_two_times(share, less));
    result.rest = vmi_two_times(share, sum);
    return result;
}

/* Computes the sine and the cosine of an angle of x turns, that is of 2 pi x radians, for |x| < 2^13. */
VM_API void vmi_sincos_turns(vm_real x, vm_real *sine, vm_real *cosine)
{
    const vmi_three half_pi = vmi_half_pi();
    const int j = vmi_nearest(4 * x), quarter = j & 3;
    const vm_real rest = 4 * x - (vm_real)j;
    vm_two z = vmi_two_product(rest, half_pi.hi);
    vm_real s, c;
    z.lo += rest * half_pi.mid;
    vmi_sin_cos(z, &s, &c);
    vmi_turn_quarters(quarter, s, c, sine, cosine);
}

/* The numbers from which vmi_doubled_at computes theta_4(z + i zy), up to a real factor, which does not matter: only
   the angle of this complex number is used. This angle is the periodic part of the angle by which a torque-free body
   turns. z is pi u/(2K), and zy is pi y/(2K) with 0 <= y < K', where K' is K(1 - m). The nome of theta_4 is Q = q^2,
   where q is the nome of m. There are two forms of the series. The direct form is used for K <= 2K', so that
   Q <= exp(-pi):
     1 + sum over n >= 1 of (-1)^n (C_n cos 2nz - i S_n sin 2nz),
     C_n, S_n = e^(-(pi n/K)(2nK' - y)) +- e^(-(pi n/K)(2nK' + y)), with + for C_n and - for S_n.
   The transformed form, the theta series after Jacobi's imaginary transformation, is used for K > 2K'. Let Qd be
   exp(-pi K/(2K')), which is below exp(-pi), and v = (2n + 1) pi/(4K'). Then, for |u| <= K, the transformed form is
     e^(-i pi u y/(4KK')) times the sum over n >= 0 of
     Qd^(n(n+1)) (cosh vu cos vy + i sinh vu sin vy) e^(-pi |u|/(4K')).
   In both forms four terms leave an error of 1e-19. The sums are stored as polynomials: in cos 2z in the direct form,
   in Qd e^(+-pi |u|/(2K')) in the transformed form. */
typedef struct VM_TAG(vmi_doubled_theta) {
    vm_real decay; /* in the transformed form exp(-pi |u|/(2K')) is exp(-decay |x|), where x = u/(4K). If decay is 0,
                      the fields are those of the direct form, the Fourier series in cos 2nz and sin 2nz */
    vm_real shift; /* the angle of the factor e^(-i pi u y/(4KK')) is shift x turns, where x = u/(4K) */
    vm_real Q;     /* Qd = exp(-pi K/(2K')), the nome of the transformed form; 0 in the direct form */
    vm_real re[4], im[4]; /* coefficients of the two polynomials, for the real and the imaginary part */
} vmi_doubled_theta;

/* Prepares the direct form of theta_4, its Fourier series in cos 2nz and sin 2nz, z = pi u/(2K). Kc is
   K' = K(1 - m). */
VM_API vmi_doubled_theta vmi_doubled_direct(vm_real K, vm_real Kc, vm_real y)
{
    vmi_doubled_theta d;
    vm_real C[4], S[4];
    int n;
    for (n = 1; n < 4; n++) {
        const vm_real rate = (vm_real)n * VM_PI / K, more = vmi_exp(-rate * (2 * (vm_real)n * Kc - y), 0);
        const vm_real less = vmi_exp(-rate * (2 * (vm_real)n * Kc + y), 0);
        C[n] = more + less;
        S[n] = more - less;
    }
    d.decay = d.shift = d.Q = 0;
    d.re[0] = 1 - C[2];
    d.re[1] = 3 * C[3] - C[1];
    d.re[2] = 2 * C[2];
    d.re[3] = -4 * C[3];
    d.im[0] = S[1] - S[3];
    d.im[1] = -2 * S[2];
    d.im[2] = 4 * S[3];
    d.im[3] = 0;
    return d;
}

/* Prepares the transformed form of theta_4, the theta series after Jacobi's imaginary transformation. Kc is
   K' = K(1 - m). For m = 1, where K is infinite, the argument x of vmi_doubled_at is u itself, not u/(4K), and `shift`
   is 0. */
VM_API vmi_doubled_theta vmi_doubled_dual(vm_real K, vm_real Kc, vm_real y)
{
    const int aperiodic = !VM_IS_FINITE(K);
    vmi_doubled_theta d;
    vm_real power = 1, exponent = VMI_LONGEST, sine, cosine;
    int n;
    d.Q = d.shift = 0;
    d.decay = 1;
    if (!aperiodic) {
        d.Q = vmi_exp(-VM_PI * K / (2 * Kc), 0);
        d.decay = 2 * VM_PI * K / Kc;
        d.shift = -y / (2 * Kc);
    }
    if (d.Q > 0) exponent = VM_PI * K / (2 * Kc);
    for (n = 0; n < 4; n++) {
        vmi_sincos_turns((vm_real)(2 * n + 1) * y / (8 * Kc), &sine, &cosine);
        d.re[n] = power * cosine; /* power is Qd^(n^2) */
        d.im[n] = power * sine;
        power *= vmi_exp(-(vm_real)(2 * n + 1) * exponent, 0);
    }
    return d;
}

/* Returns the polynomial a[0] + a[1] x + a[2] x^2 + a[3] x^3. */
VM_INLINE vm_real vmi_cubic(const vm_real *a, vm_real x) { return (a[0] + a[1] * x) + (a[2] + a[3] * x) * (x * x); }

/* Computes the real and the imaginary part of theta_4 at x = u/(4K), |x| <= 1/4. (If K is infinite, x is u and may be
   any number.) The factor e^(2 pi i shift x) is left out: the caller multiplies by it. */
VM_API void vmi_doubled_at(const vmi_doubled_theta *d, vm_real x, vm_real *re, vm_real *im)
{
    if (d->decay > 0) {
        const vm_real g = vmi_exp(-d->decay * VM_FABS(x), 0), f = d->Q / g, h = d->Q * g;
        const vm_real size = vmi_cubic(d->im, f) - g * vmi_cubic(d->im, h);
        *re = vmi_cubic(d->re, f) + g * vmi_cubic(d->re, h);
        *im = size;
        if (x < 0) *im = -size;
    } else {
        vm_real sine, cosine;
        vmi_sincos_turns(2 * x, &sine, &cosine);
        *re = vmi_cubic(d->re, cosine);
        *im = sine * vmi_cubic(d->im, cosine);
    }
}

#endif
