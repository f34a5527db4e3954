/* oscillators/ripple.h - the ripple of ca^2 within a period, and its integrals over the Ateb phase

   Amplitude and phase of an oscillator whose mass or stiffness varies slowly swing a little about mean values. This
   swing, the ripple, is computed from five functions of the Ateb phase psi. The first is C = ca^2(psi) - <ca^2>, where
   < > is the mean over a period. The other four are integrals over psi, each with the mean 0 and the period Pi_alpha:
     S = integral of C,   S2 = integral of S,   S3 = integral of S2,   Q = integral of C^2 - <C^2>.
   A vmi_ripple contains what is computed once for an alpha: polynomials that approximate these integrals, and constants
   of the law of order five (oscillators/expansion.h). A vmi_ripple contains no pointers; therefore a constant
   vmi_ripple may lie in flash memory.
       vmi_ripple r;
       vmi_ripple_values f;
       vm_real sa, ca;
       vmi_ripple_init(&r, VM_C(1.5), vmi_ateb_constants);
       vmi_ripple_complete(&r, 5);
       ateb_saca(VM_C(0.7), VM_C(1.5), &sa, &ca);
       vmi_ripple_at(&r, 5, VM_C(0.7), sa, ca, &f); // f.S, f.S2, f.S3, f.Q at psi = 0.7

   Method: let w = |ca|^(alpha+1) and y = sa^2, so that w + y = 1. An integral over psi that begins at a zero of ca is
   |ca|^3, |ca|^4 or |ca|^5 times a power series in w. An integral that begins at a zero of sa is a power series in y,
   times a power of sa. The series in w are used for w < 1/2, the series in y for y <= 1/2. On the
   interval from 0 to 1/2 each power series is replaced by the first terms of its Chebyshev series, a sum of
   Chebyshev polynomials. For every alpha, 15 terms give an error of 1e-12, and 8 terms an error of 1e-7.
   Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_RIPPLE_H
#define VARMASS_OSCILLATORS_RIPPLE_H

#include "../ateb/period.h"
#include "../ateb/phase.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "constant_mass.h"

/* The numbers of terms: VMI_RIPPLE_TERMS of each polynomial, VMI_RIPPLE_KEPT of the Chebyshev series of each power w^i,
   and VMI_RIPPLE_SERIES of each power series in w = |ca|^(alpha+1) or y = sa^2 */
#if VM_MANT_DIG > 24
enum { VMI_RIPPLE_TERMS = 15, VMI_RIPPLE_KEPT = 24, VMI_RIPPLE_SERIES = 56 };
#else
enum { VMI_RIPPLE_TERMS = 8, VMI_RIPPLE_KEPT = 13, VMI_RIPPLE_SERIES = 28 };
#endif

/* The indices of the four polynomials of a set. CA2 and CA4 give the integrals of ca^2 and of ca^4 over the phase.
   FIRST gives the integral of the integral of ca^2, and SECOND gives the integral of the result of FIRST. There are two
   sets: in one all integrals begin at the nearest zero of ca, in the other at the nearest zero of sa. */
enum { VMI_RIPPLE_CA2, VMI_RIPPLE_CA4, VMI_RIPPLE_FIRST, VMI_RIPPLE_SECOND, VMI_RIPPLE_FUNCTIONS };

/* Constants and polynomials for one alpha, prepared by vmi_ripple_init and vmi_ripple_complete */
typedef struct VM_TAG(vmi_ripple) {
    vm_real alpha;
    vm_real gamma;              /* (alpha-1)/(alpha+3): for constant mass and stiffness the rate of the phase is
                                   proportional to (action)^gamma */
    vm_real scale;              /* (alpha+1)(alpha+3)/4, a factor in the law of order five (L in docs/law.md) */
    vm_real pi;                 /* Pi_alpha, the period of C, S, S2, S3 and Q */
    vm_real mean2, mean4;       /* the means of ca^2 and ca^4 */
    vm_real variance;           /* the mean of C^2, where C = ca^2 - mean2 */
    int has_polynomials;        /* 1 where the fields below this line are set, else 0 */
    vm_real at_sa_0, at_ca_0;   /* values of S2 at the phases with sa = 0 and with ca = 0 */
    vm_real near_ca_0[VMI_RIPPLE_FUNCTIONS][VMI_RIPPLE_TERMS]; /* coefficients of polynomials in 4 w - 1, where w =
                                                                  |ca|^(alpha+1) */
    vm_real near_sa_0[VMI_RIPPLE_FUNCTIONS][VMI_RIPPLE_TERMS]; /* coefficients of polynomials in 4 y - 1, where y =
                                                                  sa^2 */
} vmi_ripple;

/* The functions of the ripple at one phase */
typedef struct VM_TAG(vmi_ripple_values) {
    vm_real sa, ca;
    vm_real C, S, S2, S3, Q; /* the functions at the top of this file; S is valid for orders from 3 on, S2 from 4 on, S3
                                and Q for order 5 */
} vmi_ripple_values;

/* -- Making the polynomials -- */

/* The coefficients with the index i of all power series in w = |ca|^(alpha+1) or y = sa^2. For example the integral of
   ca^2 from a zero of ca is |ca|^3 times the sum of near_ca_0[VMI_RIPPLE_CA2] w^i over all i. */
typedef struct VM_TAG(vmi_ripple_series) {
    vm_real root;                 /* coefficient i of the power series of (1-w)^(-1/2) */
    vm_real power2, power3, power4; /* coefficients i of the power series of (1-y)^((j-alpha)/(alpha+1)) for j = 2, 3,
                                       4 */
    vm_real product;              /* coefficient i of the power series of (1-y)^(1-nu) T, where nu = 2 alpha/(alpha+1)
                                     and T |sa| is the integral of ca^2 from a zero of sa */
    vm_real near_ca_0[VMI_RIPPLE_FUNCTIONS], near_sa_0[VMI_RIPPLE_FUNCTIONS];
} vmi_ripple_series;

/* Coefficient i of the power series of (1-y)^exponent in y. `before` is coefficient i - 1. */
VM_API vm_real vmi_binomial_next(vm_real before, int i, vm_real exponent)
{
    if (i == 0) return 1;
    return before * ((vm_real)(i - 1) - exponent) / (vm_real)i;
}

/* Replaces the coefficients i - 1 of the power series in *s by the coefficients i; before the call with i = 0 all must
   be 0. For `order` up to 3 the function computes only the series for the integral of ca^2. Method: let I be the
   integral of ca^2 over the phase from a zero of ca or sa, D the integral of I, and E the integral of D. The
   differential equations D'' = ca^2 and E'' = I give each coefficient of D and E from the previous coefficient. */
VM_API void vmi_ripple_next_terms(vmi_ripple_series *s, int order, int i, vm_real alpha)
{
    const vm_real n = alpha + 1, nu = 2 * alpha / n, k = (vm_real)(2 * i);
    const vm_real now = (vm_real)i * n, before = now - n;
    vm_real *zero = s->near_ca_0, *turn = s->near_sa_0;
    s->root = vmi_binomial_next(s->root, i, VM_C(-0.5));
    s->power2 = vmi_binomial_next(s->power2, i, (2 - alpha) / n);
    zero[VMI_RIPPLE_CA2] = n / 2 * s->root / (3 + now);
    turn[VMI_RIPPLE_CA2] = s->power2 / (k + 1);
    if (order <= 3) return;
    s->power3 = vmi_binomial_next(s->power3, i, (3 - alpha) / n);
    s->power4 = vmi_binomial_next(s->power4, i, (4 - alpha) / n);
    s->product = (s->product * (k - 3 + 2 * nu) + s->power4) / (k + 1);
    zero[VMI_RIPPLE_CA4] = n / 2 * s->root / (5 + now);
    if (i == 0) zero[VMI_RIPPLE_FIRST] = n * n / 48;
    else zero[VMI_RIPPLE_FIRST] *= (4 + before) * (3 + before + n / 2) / ((4 + now) * (3 + now));
    zero[VMI_RIPPLE_SECOND] =
        (zero[VMI_RIPPLE_SECOND] * (5 + before) * (4 + before + n / 2) + n * n / 4 * zero[VMI_RIPPLE_CA2]) /
        ((5 + now) * (4 + now));
    turn[VMI_RIPPLE_CA4] = s->power4 / (k + 1);
    turn[VMI_RIPPLE_FIRST] = (turn[VMI_RIPPLE_FIRST] * k * (k - 1 + nu) + s->power3) / ((k + 2) * (k + 1));
    turn[VMI_RIPPLE_SECOND] = (turn[VMI_RIPPLE_SECOND] * (k + 1) * (k + nu) + s->product) / ((k + 3) * (k + 2));
}

/* Multiplies the Chebyshev series, which is the sum of c[k] T_k(z) over k, by w = (1 + z)/4. T_k is Chebyshev's
   polynomial, and z T_k = (T_(k+1) + T_(k-1))/2. */
VM_API void vmi_chebyshev_times_w(vm_real *c)
{
    const int last = VMI_RIPPLE_KEPT - 1;
    vm_real below = 0, first = c[0] + c[1] / 2; /* coefficient 0 of (1 + z) times the series */
    int k;
    for (k = 0; k <= last; k++) {
        const vm_real own = c[k], above = k < last ? c[k + 1] : 0;
        vm_real share = (below + above) / 2;
        if (k == 1) share += below / 2; /* z T_0 = T_1 */
        c[k] = (own + share) / 4;
        below = own;
    }
    c[0] = first / 4;
}

/* Turns a Chebyshev series into a polynomial in powers of z, by the recurrence T_k = 2 z T_(k-1) - T_(k-2). */
VM_API void vmi_chebyshev_to_powers(vm_real *c)
{
    int j, k;
    for (j = 0; j < VMI_RIPPLE_TERMS; j++) {
        for (k = VMI_RIPPLE_TERMS - 1; k >= j + 2; k--) c[k - 2] -= c[k];
        for (k = j + 2; k < VMI_RIPPLE_TERMS; k++) c[k] *= 2;
    }
}

/* Makes the eight polynomials, four in each set. For `order` = 3 only the two polynomials CA2 are made, and all others
   become 0; for the orders 4 and 5 all are made. The function adds up the power series; in the sum it replaces each
   power w^i or y^i by the Chebyshev series of this power. */
VMI_APART void vmi_ripple_make_polynomials(vmi_ripple *r, int order)
{
    vm_real w_power[VMI_RIPPLE_KEPT]; /* coefficients of the Chebyshev series of w^i */
    vmi_ripple_series s;
    int i, j, k;
    s.root = s.power2 = s.power3 = s.power4 = s.product = 0;
    for (j = 0; j < VMI_RIPPLE_FUNCTIONS; j++) {
        s.near_ca_0[j] = 0;
        s.near_sa_0[j] = 0;
        for (k = 0; k < VMI_RIPPLE_TERMS; k++) {
            r->near_ca_0[j][k] = 0;
            r->near_sa_0[j][k] = 0;
        }
    }
    for (k = 0; k < VMI_RIPPLE_KEPT; k++) w_power[k] = 0;
    w_power[0] = 1;
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) {
        vmi_ripple_next_terms(&s, order, i, r->alpha);
        for (j = 0; j < VMI_RIPPLE_FUNCTIONS; j++)
            for (k = 0; k < VMI_RIPPLE_TERMS; k++) {
                r->near_ca_0[j][k] += s.near_ca_0[j] * w_power[k];
                r->near_sa_0[j][k] += s.near_sa_0[j] * w_power[k];
            }
        vmi_chebyshev_times_w(w_power);
    }
    for (j = 0; j < VMI_RIPPLE_FUNCTIONS; j++) {
        vmi_chebyshev_to_powers(r->near_ca_0[j]);
        vmi_chebyshev_to_powers(r->near_sa_0[j]);
    }
}

/* The value at z of a polynomial with the coefficients c */
VM_API vm_real vmi_ripple_polynomial(const vm_real *c, vm_real z)
{
    vm_real sum = c[VMI_RIPPLE_TERMS - 1];
    int k;
    for (k = VMI_RIPPLE_TERMS - 2; k >= 0; k--) sum = sum * z + c[k];
    return sum;
}

/* -- The integrals from a zero of ca or sa -- */

/* Integrals over the phase from the nearest zero of ca (or of sa) to a given phase */
typedef struct VM_TAG(vmi_ripple_integrals) {
    vm_real ca2, ca4, first, second; /* the integrals of ca^2 and ca^4, the integral of the integral ca2, and the
                                        integral of `first` */
} vmi_ripple_integrals;

/* A place is a phase between a zero of ca or sa and the phase where sa^2 = 1/2. The struct has the numbers that give
   the integrals from the zero to this place. At sa^2 = 1/2 one set of polynomials replaces the other. */
typedef struct VM_TAG(vmi_ripple_place) {
    const vm_real (*polynomial)[VMI_RIPPLE_TERMS]; /* near_ca_0 or near_sa_0 */
    vm_real z;        /* variable of the polynomials */
    vm_real x;        /* |ca| or |sa| */
    vm_real power2;   /* the integral of ca^2 is this power of x times its polynomial */
    vm_real power4;   /* the integral of ca^4 is this power of x times its polynomial */
} vmi_ripple_place;

/* The place near a zero of ca where |ca| = x and sa^2 = y >= 1/2 */
VM_API vmi_ripple_place vmi_ripple_near_ca_0(const vmi_ripple *r, vm_real x, vm_real y)
{
    vmi_ripple_place at;
    at.polynomial = r->near_ca_0;
    at.z = 4 * (1 - y) - 1;
    at.x = x;
    at.power2 = x * x * x;
    at.power4 = at.power2 * x * x;
    return at;
}

/* The place near a zero of sa where |sa| = u and sa^2 = y <= 1/2 */
VM_API vmi_ripple_place vmi_ripple_near_sa_0(const vmi_ripple *r, vm_real u, vm_real y)
{
    vmi_ripple_place at;
    at.polynomial = r->near_sa_0;
    at.z = 4 * y - 1;
    at.x = u;
    at.power2 = u;
    at.power4 = u;
    return at;
}

/* Returns the integrals over the phase from the nearest zero of ca or sa to the place *at. Integrals that the law of
   the given order, 2 to 5, does not need become 0. */
VM_API vmi_ripple_integrals vmi_ripple_integrals_at(const vmi_ripple_place *at, int order)
{
    const vm_real once = at->power2 * at->x;
    vmi_ripple_integrals d;
    d.ca2 = at->power2 * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_CA2], at->z);
    d.ca4 = d.first = d.second = 0;
    if (order >= 4) d.first = once * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_FIRST], at->z);
    if (order >= 5) {
        d.ca4 = at->power4 * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_CA4], at->z);
        d.second = once * at->x * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_SECOND], at->z);
    }
    return d;
}

/* -- Preparing an alpha, and the functions -- */

/* Prepares the ripple for an alpha >= 0, without the polynomials. Without the polynomials, only the first of the five
   functions at the top of this file, C, can be computed. `constants` is the function that computes Pi_alpha. */
VM_API void vmi_ripple_init(vmi_ripple *r, vm_real alpha, vmi_ateb_constants_of constants)
{
    vmi_ateb c;
    constants(&c, alpha);
    r->alpha = alpha;
    r->gamma = (alpha - 1) / (alpha + 3);
    r->scale = (alpha + 1) * (alpha + 3) / 4;
    r->pi = 2 * c.quarter.hi;
    r->mean2 = vmi_osc_mean_ca(2, alpha, r->pi, constants);
    r->mean4 = vmi_osc_mean_ca(4, alpha, r->pi, constants);
    r->variance = r->mean4 - r->mean2 * r->mean2;
    r->has_polynomials = 0;
}

/* Sets at_sa_0 and at_ca_0, the values of S2 at the zeros of sa and of ca. These values follow from the condition that
   both sets of polynomials give the same S2 and S3 at the phase where sa^2 = 1/2. */
VM_API void vmi_ripple_join(vmi_ripple *r)
{
    const vm_real half = VM_C(0.5), sa = VM_SQRT(half), ca = vmi_pow_checked(half, 1 / (r->alpha + 1));
    const vm_real t = vmi_ateb_from_sa_0(r->alpha, sa, half), s = vmi_ateb_from_ca_0(r->alpha, ca, half);
    vmi_ripple_place place = vmi_ripple_near_ca_0(r, ca, half);
    const vmi_ripple_integrals zero = vmi_ripple_integrals_at(&place, 5);
    vmi_ripple_integrals turn;
    vm_real jump; /* the difference at_sa_0 - at_ca_0 */
    place = vmi_ripple_near_sa_0(r, sa, half);
    turn = vmi_ripple_integrals_at(&place, 5);
    jump = (zero.first - r->mean2 * s * s / 2) - (turn.first - r->mean2 * t * t / 2);
    r->at_ca_0 = -((turn.second - r->mean2 * t * t * t / 6) + (zero.second - r->mean2 * s * s * s / 6) + jump * t) /
                 (r->pi / 2);
    r->at_sa_0 = r->at_ca_0 + jump;
}

/* Adds to *r what the law of order five needs if it is cut off after `order`, 3 to 5: the polynomials, and the values
   of S2 at the zeros of sa and of ca. For `order` = 3 these two values, and all polynomials except CA2, become 0. */
VM_API void vmi_ripple_complete(vmi_ripple *r, int order)
{
    vmi_ripple_make_polynomials(r, order);
    r->at_ca_0 = 0;
    r->at_sa_0 = 0;
    if (order > 3) vmi_ripple_join(r);
    r->has_polynomials = 1;
}

/* Writes the functions C, S, S2, S3 and Q at the phase psi. Functions that the law of the given order, 2 to 5, does not
   need are not valid. sa and ca are the Ateb functions of psi. For orders above 2, vmi_ripple_complete must have been
   called before. */
VM_API void vmi_ripple_at(const vmi_ripple *r, int order, vm_real psi, vm_real sa, vm_real ca, vmi_ripple_values *f)
{
    const vm_real m = r->mean2, y = sa * sa, from_sa_0 = psi - r->pi * VM_FLOOR(psi / r->pi + VM_C(0.5));
    vm_real side = VM_COPYSIGN(1, from_sa_0), way = VM_FABS(from_sa_0); /* way: phase since the nearest zero of sa */
    vm_real S2_at_0;
    vmi_ripple_place place;
    vmi_ripple_integrals d;
    f->sa = sa;
    f->ca = ca;
    f->C = ca * ca - m;
    f->S = f->S2 = f->S3 = f->Q = 0;
    if (order < 3) return;
    S2_at_0 = r->at_sa_0;
    if (y > VM_C(0.5)) {
        place = vmi_ripple_near_ca_0(r, VM_FABS(ca), y);
        side = -side;
        way = r->pi / 2 - way;
        S2_at_0 = r->at_ca_0;
    } else place = vmi_ripple_near_sa_0(r, VM_FABS(sa), y);
    d = vmi_ripple_integrals_at(&place, order);
    f->S = side * (d.ca2 - m * way);
    f->S2 = S2_at_0 + d.first - m * way * way / 2;
    f->S3 = side * (S2_at_0 * way + d.second - m * way * way * way / 6);
    f->Q = side * (d.ca4 - 2 * m * d.ca2 + (2 * m * m - r->mean4) * way);
}

#endif
