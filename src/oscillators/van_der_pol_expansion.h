/* oscillators/van_der_pol_expansion.h - Van der Pol's oscillator: from the motion to its mean motion and back

   The oscillator is that of oscillators/van_der_pol.h. The feed is treated as a negative damping; therefore the rates a
   and p of oscillators/reduction.h contain the feed. Then the amplitude A and the phase psi of oscillators/reduction.h
   obey the exact equations
     (ln A)' = -p + W [-(2/n) e ca^2 sa^2 + E0 sa ca - Q0 ca^3 sa],
     psi'    =      W [1 - e ca^3 sa + (n/2) E0 ca^2 - (n/2) Q0 ca^4],
   with n = alpha + 1. W is the rate of the phase at the amplitude A for constant mass and stiffness. Let epsilon be the
   relative change of the vibration while the phase grows by 1. The numbers e, e1, Q0 and E0, called the disturbances,
   are
     e = (c/m) A^2/W,  e1 = e nu/W,  Q0 = e p/W,  E0 = (p^2 - a p - p')/W^2,  nu = -m'/m - 4 p + a;
   where m is the mass. e is of the order epsilon; e1, Q0 and E0 are of the order epsilon^2. For c = 0 all disturbances
   except E0 are 0.

   A transformation leads from A and psi to mean values, whose rates do not vary within a period. Let J be
   A^((alpha+3)/2) times a factor that varies slowly, chosen so that J is constant if A'/A = -p. Then the mean values of
   J and psi obey
     (ln J)' = W [F e + K_3 e^3 + K_1 e e1 + K_Q e Q0 + K_E e E0],
     psi'    = W [1 + K_2 e^2 - (n/2) <ca^4> Q0 + (n/2) <ca^2> E0],
   where < > is the mean over a period. F and K_1, K_2, K_3, K_Q, K_E are constants that depend on alpha only. This file
   has these constants, and the transformation in both directions. These equations and the transformation are called the
   law of order three: the motion that this law gives has an error of O(epsilon^3) over times of 1/epsilon. The law is
   new; docs/van-der-pol.md shows how large its errors are.
       vmi_ripple r;
       vmi_vdp_ripple v;
       vmi_ripple_init(&r, 1, vmi_ateb_constants);
       vmi_ripple_complete(&r, 5);
       vmi_vdp_ripple_init(&v, &r); // v.F is -1/4, v.K2 -11/256
   Tests: tests/test_van_der_pol_law.c. */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_EXPANSION_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_EXPANSION_H

#include "../base/real.h"
#include "constant_mass.h"
#include "ripple.h"

/* The indices of the polynomials for phases near a zero of sa. The law of order three needs these polynomials in
   addition to the polynomials of oscillators/ripple.h. CA6 gives the integral over the phase of ca^6. SQUARE gives the
   integral of S^2, where S is the integral of C = ca^2 - <ca^2>. */
enum { VMI_VDP_CA6, VMI_VDP_SQUARE, VMI_VDP_TURN_FUNCTIONS };

/* The indices of the polynomials for phases near a zero of ca. VMI_VDP_CA6 gives the integral of ca^6. The polynomials
   listed here give three parts of the integral of S^2. Let I be the integral of ca^2, and d the phase since the zero.
   Then S is I - <ca^2> d, so that S^2 has terms in d^2 (PHASE2), I d (PRODUCT) and I^2 (INTEGRAL2). */
enum { VMI_VDP_PHASE2 = 1, VMI_VDP_PRODUCT, VMI_VDP_INTEGRAL2, VMI_VDP_ZERO_FUNCTIONS };

/* Constants and polynomials of the law of order three for one alpha, prepared by vmi_vdp_ripple_init. F, K2, K3, K1, KQ
   and KE are the constants in the equations at the top of this file. */
typedef struct VM_TAG(vmi_vdp_ripple) {
    vm_real q;               /* (alpha+3)/(alpha+7) */
    vm_real mean6, mean8;    /* the means of ca^6 and of ca^8 over a period */
    vm_real mean_square;     /* the mean of S^2, where S is the integral of ca^2 - <ca^2> and < > is the mean over a
                                period */
    vm_real F, K2, K3, K1, KQ, KE;
    vm_real constant;        /* the constant part of the factor of e^2 in the transformation of ln J */
    /* The functions of the transformation as polynomials: the coefficients of the powers of 4 w - 1 and of 4 y - 1 */
    vm_real near_ca_0[VMI_VDP_ZERO_FUNCTIONS][VMI_RIPPLE_TERMS]; /* where w = |ca|^(alpha+1) */
    vm_real near_sa_0[VMI_VDP_TURN_FUNCTIONS][VMI_RIPPLE_TERMS]; /* where y = sa^2 */
} vmi_vdp_ripple;

/* The disturbances e, e1, Q0 and E0 of the top of this file, at one time and one amplitude */
typedef struct VM_TAG(vmi_vdp_disturbance) {
    vm_real e, e1, Q0, E0;
} vmi_vdp_disturbance;

/* -- Making the polynomials -- */

/* Writes the product of two power series of VMI_RIPPLE_SERIES terms each. */
VM_API void vmi_vdp_multiply(const vm_real *f, const vm_real *g, vm_real *product)
{
    int i, j;
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) {
        product[i] = 0;
        for (j = 0; j <= i; j++) product[i] += f[j] * g[i - j];
    }
}

/* Writes the coefficients of the power series of (1-y)^exponent in y. */
VM_API void vmi_vdp_binomial(vm_real exponent, vm_real *series)
{
    vm_real before = 0;
    int i;
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) {
        series[i] = vmi_binomial_next(before, i, exponent);
        before = series[i];
    }
}

/* Turns a power series in w, for w from 0 to 1/2, into a polynomial in 4 w - 1. The polynomial differs from the series
   only by about the size of rounding errors. */
VM_API void vmi_vdp_economise(const vm_real *series, vm_real *polynomial)
{
    vm_real w_power[VMI_RIPPLE_KEPT]; /* coefficients of the Chebyshev series of w^i */
    int i, k;
    for (k = 0; k < VMI_RIPPLE_TERMS; k++) polynomial[k] = 0;
    for (k = 0; k < VMI_RIPPLE_KEPT; k++) w_power[k] = 0;
    w_power[0] = 1;
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) {
        for (k = 0; k < VMI_RIPPLE_TERMS; k++) polynomial[k] += series[i] * w_power[k];
        vmi_chebyshev_times_w(w_power);
    }
    vmi_chebyshev_to_powers(polynomial);
}

/* Makes the polynomials for phases psi close to a zero of sa. For these phases du = (1-y)^(alpha/n) dpsi with u = |sa|,
   y = u^2 and n = alpha + 1, so that the integral of (1-y)^b dpsi is u times the sum of [(1-y)^(b-alpha/n)]_i
   y^i/(2i+1), where [ ]_i is coefficient i of the power series. */
VM_API void vmi_vdp_make_near_sa_0(vmi_vdp_ripple *v, const vmi_ripple *r)
{
    const vm_real alpha = r->alpha, n = alpha + 1;
    vm_real slope[VMI_RIPPLE_SERIES], power[VMI_RIPPLE_SERIES], S[VMI_RIPPLE_SERIES], square[VMI_RIPPLE_SERIES];
    int i;
    vmi_vdp_binomial((6 - alpha) / n, power);
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) power[i] /= (vm_real)(2 * i + 1);
    vmi_vdp_economise(power, v->near_sa_0[VMI_VDP_CA6]);
    vmi_vdp_binomial(-alpha / n, slope);
    vmi_vdp_binomial((2 - alpha) / n, power);
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) S[i] = (power[i] - r->mean2 * slope[i]) / (vm_real)(2 * i + 1);
    vmi_vdp_multiply(S, S, square);
    vmi_vdp_multiply(square, slope, power);
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) power[i] /= (vm_real)(2 * i + 3);
    vmi_vdp_economise(power, v->near_sa_0[VMI_VDP_SQUARE]);
}

/* Makes one of the polynomials for the integral of S^2 close to a zero of ca. The integrand is a product: f and g are
   the power series of its two factors, and `slope` is the power series of dpsi/dx, where x = |ca|. x_power is the power
   of x that multiplies the polynomial. */
VM_API void vmi_vdp_make_part(const vm_real *f, const vm_real *g, const vm_real *slope, vm_real x_power, vm_real n,
                              vm_real *polynomial)
{
    vm_real product[VMI_RIPPLE_SERIES], series[VMI_RIPPLE_SERIES];
    int i;
    vmi_vdp_multiply(f, g, product);
    vmi_vdp_multiply(product, slope, series);
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) series[i] /= x_power + (vm_real)i * n;
    vmi_vdp_economise(series, polynomial);
}

/* Makes the polynomials for phases psi close to a zero of ca. For these phases dpsi = (n/2) (1-w)^(-1/2) dx with x =
   |ca|, w = x^n and n = alpha + 1. The phase since the zero is x times a power series in w, and the integral of ca^2 is
   x^3 times a second power series. */
VM_API void vmi_vdp_make_near_ca_0(vmi_vdp_ripple *v, const vmi_ripple *r)
{
    const vm_real n = r->alpha + 1;
    vm_real slope[VMI_RIPPLE_SERIES], phase[VMI_RIPPLE_SERIES], ca2[VMI_RIPPLE_SERIES], ca6[VMI_RIPPLE_SERIES];
    int i;
    vmi_vdp_binomial(VM_C(-0.5), slope);
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) {
        const vm_real now = (vm_real)i * n;
        slope[i] *= n / 2;
        phase[i] = slope[i] / (1 + now);
        ca2[i] = slope[i] / (3 + now);
        ca6[i] = slope[i] / (7 + now);
    }
    vmi_vdp_economise(ca6, v->near_ca_0[VMI_VDP_CA6]);
    vmi_vdp_make_part(phase, phase, slope, 3, n, v->near_ca_0[VMI_VDP_PHASE2]);
    vmi_vdp_make_part(phase, ca2, slope, 5, n, v->near_ca_0[VMI_VDP_PRODUCT]);
    vmi_vdp_make_part(ca2, ca2, slope, 7, n, v->near_ca_0[VMI_VDP_INTEGRAL2]);
}

/* -- The integrals of ca^6 and of S^2 -- */

/* The integral of S^2 over the phase, from the nearest zero of ca to a phase where |ca| = x and sa^2 = y. S is the
   integral of ca^2 minus its mean mean2. */
VM_API vm_real vmi_vdp_square_from_ca_0(const vmi_vdp_ripple *v, vm_real mean2, vm_real x, vm_real y)
{
    const vm_real z = 4 * (1 - y) - 1, x2 = x * x;
    const vm_real phase2 = vmi_ripple_polynomial(v->near_ca_0[VMI_VDP_PHASE2], z);
    const vm_real product = vmi_ripple_polynomial(v->near_ca_0[VMI_VDP_PRODUCT], z);
    const vm_real integral2 = vmi_ripple_polynomial(v->near_ca_0[VMI_VDP_INTEGRAL2], z);
    return x2 * x * (mean2 * mean2 * phase2 + x2 * (x2 * integral2 - 2 * mean2 * product));
}

/* The integral of S^2 over the phase, from the nearest zero of sa to a phase where |sa| = u and sa^2 = y. S is the
   integral of ca^2 minus its mean. */
VM_API vm_real vmi_vdp_square_from_sa_0(const vmi_vdp_ripple *v, vm_real u, vm_real y)
{
    return y * u * vmi_ripple_polynomial(v->near_sa_0[VMI_VDP_SQUARE], 4 * y - 1);
}

/* Writes the integrals over the phase of ca^6 - <ca^6> and of S^2 - <S^2>, where < > is the mean over a period. The
   constants of integration are such that both integrals are 0 where ca or sa is 0. sa and ca are the Ateb functions of
   psi. */
VM_API void vmi_vdp_integrals_at(const vmi_vdp_ripple *v, const vmi_ripple *r, vm_real psi, vm_real sa, vm_real ca,
                                 vm_real *ca6, vm_real *square)
{
    const vm_real y = sa * sa, from_sa_0 = psi - r->pi * VM_FLOOR(psi / r->pi + VM_C(0.5));
    const vm_real side = from_sa_0 < 0 ? -1 : 1, t = VM_FABS(from_sa_0), s = r->pi / 2 - t;
    const vm_real x = VM_FABS(ca), u = VM_FABS(sa);
    if (y > VM_C(0.5)) {
        const vm_real power7 = x * (ca * ca) * (ca * ca) * (ca * ca);
        const vm_real integral = power7 * vmi_ripple_polynomial(v->near_ca_0[VMI_VDP_CA6], 4 * (1 - y) - 1);
        *ca6 = -side * (integral - v->mean6 * s);
        *square = -side * (vmi_vdp_square_from_ca_0(v, r->mean2, x, y) - v->mean_square * s);
    } else {
        *ca6 = side * (u * vmi_ripple_polynomial(v->near_sa_0[VMI_VDP_CA6], 4 * y - 1) - v->mean6 * t);
        *square = side * (vmi_vdp_square_from_sa_0(v, u, y) - v->mean_square * t);
    }
}

/* -- Preparing an alpha -- */

/* Computes the constants F, K2, K3, K1, KQ and KE of the equations of the mean motion, from the means of powers of ca
   and of S^2. */
VM_API void vmi_vdp_find_constants(vmi_vdp_ripple *v, const vmi_ripple *r)
{
    const vm_real alpha = r->alpha, n = alpha + 1, g = r->gamma, q = v->q;
    const vm_real m2 = r->mean2, m4 = r->mean4, m6 = v->mean6, m8 = v->mean8;
    const vm_real g11 = n * m6 / (alpha + 15);
    const vm_real H = (alpha + 3) / 8 * (g11 - n * m2 * m4 / (alpha + 7));
    const vm_real Z = q * q * (v->mean_square - n / 4 * (m6 - m2 * m4) + g11);
    const vm_real y = -n / 6 * (m8 - m2 * m6) + n / 4 * m2 * (m6 - m2 * m4) + n * m8 / (alpha + 19) - m2 * g11;
    const vm_real Y = q * q * y;
    v->F = -q * m2;
    v->K2 = g * (1 - 2 * g) / 2 * Z + (1 - 2 * g) * H - g11;
    v->K3 = -(1 - 2 * g) * (v->F * H + Y / 2) - v->F * g11 - (alpha + 3) * n * m8 / ((alpha + 7) * (alpha + 19));
    v->K1 = -H;
    v->KQ = -r->scale / 4 * (m6 - m2 * m4);
    v->KE = r->scale / 2 * r->variance;
    v->constant = g / 2 * Z + H - (alpha + 3) * n / (2 * (alpha + 7)) * (VM_C(1.) / 6 + 1 / (alpha + 15)) * m6;
}

/* Computes *v for the alpha of *r, whose polynomials must be ready. For the mean of S^2 the function integrates S^2
   over a quarter of the period, in two parts that meet where sa^2 = 1/2. */
VM_API void vmi_vdp_ripple_init(vmi_vdp_ripple *v, const vmi_ripple *r)
{
    const vm_real half = VM_C(0.5), sa = VM_SQRT(half), ca = vmi_pow_checked(half, 1 / (r->alpha + 1));
    v->q = (r->alpha + 3) / (r->alpha + 7);
    v->mean6 = vmi_osc_mean_ca(6, r->alpha, r->pi, vmi_ateb_constants);
    v->mean8 = vmi_osc_mean_ca(8, r->alpha, r->pi, vmi_ateb_constants);
    vmi_vdp_make_near_sa_0(v, r);
    vmi_vdp_make_near_ca_0(v, r);
    v->mean_square = 2 / r->pi *
                     (vmi_vdp_square_from_sa_0(v, sa, half) + vmi_vdp_square_from_ca_0(v, r->mean2, ca, half));
    vmi_vdp_find_constants(v, r);
}

/* -- The functions of the transformation -- */

/* Functions of the phase from which the factors of the disturbances in the transformation follow. */
typedef struct VM_TAG(vmi_vdp_values) {
    vmi_ripple_values f;
    vm_real C4;         /* ca^4 minus its mean over a period */
    vm_real U, U1, P1;  /* U is the factor of e, and U1 that of e1, in ln J; P1 is the factor of e in the phase */
    vm_real X;          /* a part of the factor of e^2 in the transformation of ln J */
} vmi_vdp_values;

/* Writes the functions of the transformation at the phase psi, where sa and ca are the Ateb functions of psi. */
VM_API void vmi_vdp_values_at(const vmi_vdp_ripple *v, const vmi_ripple *r, vm_real psi, vm_real sa, vm_real ca,
                              vmi_vdp_values *f)
{
    const vm_real n = r->alpha + 1, ca2 = ca * ca, ca4 = ca2 * ca2;
    vmi_ripple_at(r, 5, psi, sa, ca, &f->f);
    f->C4 = ca4 - r->mean4;
    f->U = -v->q * (f->f.S - sa * ca * ca2);
    f->U1 = v->q * (f->f.S2 + n / 8 * f->C4);
    f->P1 = (n * f->C4 - (r->alpha - 1) * f->f.S2) / (r->alpha + 7);
    f->X = v->q * n / 2 * ca4 * ca2 * (VM_C(1.) / 6 + sa * sa / n);
}

/* -- From the motion to the mean motion -- */

/* Returns ln(mean J/J) with all terms up to order epsilon^2; at phases where sa or ca is 0, with all terms up to
   epsilon^3. *f contains the functions of the transformation at the phase of the motion, and *now the disturbances at
   its amplitude. */
VM_API vm_real vmi_vdp_J(const vmi_vdp_ripple *v, const vmi_ripple *r, const vmi_vdp_values *f,
                         const vmi_vdp_disturbance *now)
{
    const vm_real g = r->gamma, half = r->scale / 2;
    const vm_real square = (1 - 2 * g) / 2 * f->U * f->U - v->F * f->P1 - f->X - v->constant;
    return -now->e * f->U + now->e * now->e * square - now->e1 * f->U1 - half / 2 * now->Q0 * f->C4 +
           half * now->E0 * f->f.C;
}

/* Returns the mean phase minus the phase, with all terms up to order epsilon; at phases where sa or ca is 0, with all
   terms up to epsilon^2. */
VM_API vm_real vmi_vdp_psi(const vmi_vdp_values *f, const vmi_vdp_disturbance *now) { return -now->e * f->P1; }

/* -- From the mean motion to the motion -- */

/* Returns the terms of order epsilon^2 in ln(J/mean J). *f contains the functions of the transformation at the mean
   phase. */
VM_API vm_real vmi_vdp_J_back_second(const vmi_vdp_ripple *v, const vmi_ripple *r, const vmi_vdp_values *f,
                                     const vmi_vdp_disturbance *now)
{
    const vm_real n = r->alpha + 1, half = r->scale / 2, sa_ca = f->f.sa * f->f.ca;
    const vm_real slope = -(r->alpha + 3) / n * sa_ca * sa_ca;
    const vm_real square = (1 - 2 * r->gamma) / 2 * f->U * f->U + slope * f->P1 + f->X + v->constant;
    return now->e * now->e * square + now->e1 * f->U1 + half / 2 * now->Q0 * f->C4 - half * now->E0 * f->f.C;
}

/* Returns the terms of order epsilon^2 in the difference (phase) - (mean phase). *f contains the functions of the
   transformation at the mean phase psi. */
VM_API vm_real vmi_vdp_psi_back_second(const vmi_vdp_ripple *v, const vmi_ripple *r, vm_real psi,
                                       const vmi_vdp_values *f, const vmi_vdp_disturbance *now)
{
    const vm_real alpha = r->alpha, n = alpha + 1, g = r->gamma, q = v->q;
    const vm_real ca = f->f.ca, sa = f->f.sa, ca3 = ca * ca * ca;
    vm_real ca6, square, ca4, V, T, odd;
    vmi_vdp_integrals_at(v, r, psi, sa, ca, &ca6, &square);
    ca4 = f->f.Q + 2 * r->mean2 * f->f.S;
    V = n / (alpha + 15) * (ca6 - sa * ca3 * ca3 * ca);
    T = -n / 8 * (f->f.S * ca3 * ca - ca6 + r->mean2 * ca4);
    odd = g * q * q / 2 * (square - 2 * T + V) + q * (T - V) -
          v->F / (alpha + 7) * (n * ca4 - (alpha - 1) * f->f.S3);
    odd = (1 - 3 * g) * odd - V + g * q / 2 * (n * ca6 / 6 + V);
    odd += (g * f->U - ca3 * sa) * f->P1;
    return now->e * now->e * odd +
           now->e1 * (2 * (alpha - 1) * f->f.S3 + n / 8 * (alpha - 9) * ca4) / (alpha + 7) +
           n / 16 * (alpha - 9) * now->Q0 * ca4 + r->scale / 2 * (1 - 2 * g) * now->E0 * f->f.S;
}

/* -- The mean motion -- */

/* Returns (ln J)'/(W e) - F, which is of order epsilon^2. Multiplied by W e, this number gives all terms except W F e
   in the equation of (ln J)' at the top of this file. */
VM_API vm_real vmi_vdp_mean_second(const vmi_vdp_ripple *v, const vmi_vdp_disturbance *now)
{
    return v->K3 * now->e * now->e + v->K1 * now->e1 + v->KQ * now->Q0 + v->KE * now->E0;
}

/* Returns the mean rate of the phase divided by W, with all terms up to order epsilon^3. */
VM_API vm_real vmi_vdp_mean_rate(const vmi_vdp_ripple *v, const vmi_ripple *r, const vmi_vdp_disturbance *now)
{
    const vm_real n = r->alpha + 1;
    return 1 + v->K2 * now->e * now->e - n / 2 * r->mean4 * now->Q0 + n / 2 * r->mean2 * now->E0;
}

/* -- Sizes of the terms, for estimates of errors -- */

/* Bounds of the terms that the law of order three leaves out if it is cut off after order two, at one time. The fields
   psi and J are for the transformation from the mean motion to the motion, the field `start` for the transformation to
   the mean motion. */
typedef struct VM_TAG(vmi_vdp_sizes) {
    vm_real psi, J; /* terms of order epsilon^2 in the phase and in ln J, in the transformation to the motion */
    vm_real start;  /* terms of order epsilon^3 in ln J, in the transformation to the mean motion */
    vm_real third;  /* terms of order epsilon^3 with the derivative of m'/m, in the phase and in ln J */
    vm_real ratio;  /* estimated ratio of the terms of one order to the terms of the next lower order */
} vmi_vdp_sizes;

/* Computes the bounds in vmi_vdp_sizes for the disturbances *now. `rate` is (|nu| + |p| + |a|)/W, with the symbols at
   the top of this file, and `bend` is the derivative of m'/m, divided by W^2. The numerical factors are fitted to the
   largest values of the functions of the transformation for alpha from 0.2 to 12. */
VM_API vmi_vdp_sizes vmi_vdp_sizes_of(const vmi_ripple *r, const vmi_vdp_disturbance *now, vm_real rate, vm_real bend)
{
    const vm_real d = r->pi / (2 * VM_PI), d2 = d * d, d3 = d2 * d, d4 = d2 * d2;
    const vm_real e = VM_FABS(now->e), e1 = VM_FABS(now->e1), Q = VM_FABS(now->Q0), E = VM_FABS(now->E0);
    vmi_vdp_sizes s;
    s.psi = VM_C(0.11) * d3 * e * e + VM_C(0.45) * d3 * e1 + VM_C(0.75) * d * Q +
            r->scale / 4 * VM_FABS(1 - 2 * r->gamma) * d * E;
    s.J = VM_C(0.18) * d2 * (e * e + d * e1) + VM_C(1.5) * d2 * Q + VM_C(2.4) * d2 * E;
    s.start = e * (VM_C(0.06) * d4 * e * e + VM_C(0.12) * d3 * e1 + VM_C(0.5) * d4 * Q + VM_C(0.9) * d4 * E) +
              rate * (VM_C(0.14) * d4 * e1 + VM_C(1.1) * d3 * Q + VM_C(2.1) * d3 * E);
    s.third = VM_C(0.06) * d4 * e * bend;
    s.ratio = d * (e + rate);
    return s;
}

#endif
