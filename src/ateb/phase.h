/* ateb/phase.h - the phase s for given values of sa and ca

   As atan2 computes an angle from its sine and cosine, ateb_phase computes the phase s from sa and ca, for example
   the phase of an oscillator from its position and velocity.

       vm_real sa, ca, s;
       ateb_saca(VM_C(0.7), VM_C(1.5), &sa, &ca);
       s = ateb_phase(sa, ca, VM_C(1.5)); // 0.7

   The symbols are those of ateb/inversion.h. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_PHASE_H
#define VARMASS_ATEB_PHASE_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "inversion.h"
#include "period.h"

/* Returns T with 1 + q T = 2F1(1, 2q; 1 + q; p), for p < 0.251. */
VM_API vm_real vmi_ateb_T(vm_real q, vm_real p)
{
    vm_real P, Q;
    vmi_ateb_p_fraction(q, p, &P, &Q);
    return 2 * p * Q / ((1 + q) * P - 2 * q * p * Q);
}

/* Returns r, the distance between s and the zero of sa, for w = sa^2 < 0.302. The argument h is ln(w/x) < 0, and sum is
   1 + e^h. Since x is 1 - w, w = e^h/(1 + e^h). */
VM_API vm_real vmi_ateb_phase_near_sa_zero(vm_two h, vm_real sum, vm_real q)
{
    const vm_real v = vmi_exp(h.hi / 2, h.lo / 2) / VM_SQRT(sum), w = v * v, b = q + VM_C(0.5);
    const vm_real one_minus_u = q * vmi_ateb_power_rest(-w / (2 - w), q);
    return v + v * (w * b * vmi_ateb_w_fraction(q, w) * (1 - one_minus_u) - one_minus_u);
}

/* Returns r, the distance between s and the zero of sa, for w = sa^2 >= 0.302. The arguments are h = ln(w/x) with
   x = 1 - w, e = e^-|h| and sum = 1 + e. The function computes u = ca = x^q by means of ln x = -ln(1 + e^h). Where u is
   well below 1, r is a quarter of the period minus d = u (n + T)/2. Where u is near 1, the function computes 1 - u
   without loss of digits, and r = (n (1 - u) + g - u T)/2. n = alpha + 1 and g = Pi_alpha - n are fields of *c, T is
   the result of vmi_ateb_T. */
VM_API vm_real vmi_ateb_phase_near_ca_zero(vm_two h, vm_real e, vm_real sum, const vmi_ateb *c)
{
    const vm_real large_ln = VM_C(0.69) * VMI_BIAS, n = c->n.hi, smaller = e / sum, larger = 1 / sum;
    vm_real w = smaller, x = larger, one_minus_u, low, T;
    vm_two minus_ln_u = vmi_log(sum);
    int k;
    if (h.hi > 0) {
        w = larger;
        x = smaller;
        minus_ln_u = vmi_two_plus(minus_ln_u, h);
    }
    T = vmi_ateb_T(c->q.hi, x / (2 + 2 * VM_SQRT(w)));
    minus_ln_u.lo += (1 - sum + e) / sum; /* the rounding error of 1 + e */
    minus_ln_u = vmi_two_times(minus_ln_u, c->q);
    if (!(minus_ln_u.hi <= large_ln)) return c->quarter.hi; /* ca is 0, or the logarithm of |ca|^(alpha+1) overflows */
    one_minus_u = -vmi_exp_core(-minus_ln_u.hi, -minus_ln_u.lo, &k, &low);
    if (k != 0) return c->quarter.hi - vmi_ldexp(1 - one_minus_u, k) * (n + T) / 2;
    return (n * one_minus_u + (c->g.hi - (1 - one_minus_u) * T)) / 2;
}

/* Returns r, the distance between s and the zero of sa, in the first quarter. The argument h is ln(w/(1 - w)), where
   w = sa^2. */
VM_API vm_real vmi_ateb_phase_r(vm_two h, const vmi_ateb *c)
{
    const vm_real change_over = VM_C(-0.84); /* ln(w/(1 - w)) for w = 0.302; vmi_ateb_w_fraction allows no larger w */
    vm_two minus_size = h;
    vm_real e;
    if (!(h.hi < 0)) minus_size = vmi_minus(h);
    e = vmi_exp(minus_size.hi, minus_size.lo);
    if (h.hi < change_over) return vmi_ateb_phase_near_sa_zero(h, 1 + e, c->q.hi);
    return vmi_ateb_phase_near_ca_zero(h, e, 1 + e, c);
}

/* Returns 1 if ateb_phase has a result for this alpha, else 0. */
VM_API int vmi_ateb_has_phase(vm_real alpha) { return alpha >= 0 && alpha <= VM_C(1e30); }

/* The phase s of given values of sa and ca, with -Pi_alpha <= s <= Pi_alpha. alpha lies between 0 and 1e30. The given
   values need not satisfy sa^2 + |ca|^(alpha+1) = 1: for every lambda > 0 the pair sa lambda^((alpha+1)/2) and ca
   lambda has the same phase as sa and ca. Therefore the phase of the oscillator x'' = -omega^2 x|x|^(alpha-1) is found
   with sa = -x' sqrt((alpha+1)/2)/omega and ca = x. Returns 0 for sa = 0 <= ca. If sa and ca come from ateb_saca(s,
   ...) with |s| <= Pi_alpha, the result is s with an error of at most 8 ulp plus the change of s that errors of 6 ulp
   in sa and in ca make. Returns NaN for alpha < 0, alpha > 1e30, NaN and infinite arguments. */
VM_API vm_real ateb_phase(vm_real sa, vm_real ca, vm_real alpha)
{
    vm_real r;
    vmi_ateb c;
    if (!vmi_ateb_has_phase(alpha) || !VM_IS_FINITE(sa) || !VM_IS_FINITE(ca)) return VM_NAN;
    vmi_ateb_constants(&c, alpha);
    if (sa == 0) r = 0;
    else if (ca == 0) r = c.quarter.hi;
    else {
        const vm_two ln_w = vmi_two_scaled(vmi_log(VM_FABS(sa)), 2);
        const vm_two ln_x = vmi_two_times(vmi_log(VM_FABS(ca)), c.n);
        r = vmi_ateb_phase_r(vmi_two_plus(ln_w, vmi_minus(ln_x)), &c);
    }
    if (ca < 0) r = (2 * c.quarter.hi - r) + 2 * c.quarter.lo;
    return VM_COPYSIGN(r, sa);
}

/* -- The phase by power series: shorter code, but slower -- */

/* Number of terms that give all digits up to sa^2 = 1/2 and |ca|^(alpha+1) = 1/2 */
enum { VMI_ATEB_PHASE_TERMS = VM_MANT_DIG > 24 ? 54 : 26 };

/* Returns the distance between the phase and a zero of sa, where u = |sa| and y = sa^2 <= 1/2. It is the integral from
   0 to u of (1 - x^2)^(-alpha/(alpha+1)) dx, whose power series has positive terms. The error of the result is below 4
   ulp. */
VM_API vm_real vmi_ateb_from_sa_0(vm_real alpha, vm_real u, vm_real y)
{
    const vm_real power = alpha / (alpha + 1);
    vm_real term = 1, sum = 0;
    int i;
    for (i = 1; i <= VMI_ATEB_PHASE_TERMS; i++) {
        sum += term / (vm_real)(2 * i - 1);
        term *= ((vm_real)(i - 1) + power) / (vm_real)i * y;
    }
    return u * sum;
}

/* Returns the distance between the phase and a zero of ca, where x = |ca| and w = x^(alpha+1) <= 1/2. It is (alpha+1)/2
   times the integral from 0 to x of (1 - z^(alpha+1))^(-1/2) dz. The error of the result is below 4 ulp. */
VM_API vm_real vmi_ateb_from_ca_0(vm_real alpha, vm_real x, vm_real w)
{
    const vm_real n = alpha + 1;
    vm_real term = 1, sum = 0;
    int i;
    for (i = 0; i < VMI_ATEB_PHASE_TERMS; i++) {
        sum += term / (1 + (vm_real)i * n);
        term *= ((vm_real)i + VM_C(0.5)) / (vm_real)(i + 1) * w;
    }
    return n / 2 * x * sum;
}

/* Returns the phase that ateb_phase returns, computed by power series, for sa and ca with sa^2 + |ca|^(alpha+1) = 1 and
   a valid alpha. `quarter` is the quarter period, Pi_alpha/2. */
VM_API vm_real vmi_ateb_phase_by_series(vm_two quarter, vm_real alpha, vm_real sa, vm_real ca)
{
    const vm_real y = sa * sa, x = VM_FABS(ca);
    vm_real r;
    if (y <= VM_C(0.5)) r = vmi_ateb_from_sa_0(alpha, VM_FABS(sa), y);
    else r = (quarter.hi - vmi_ateb_from_ca_0(alpha, x, vmi_pow_checked(x, alpha + 1))) + quarter.lo;
    if (ca < 0) r = (2 * quarter.hi - r) + 2 * quarter.lo;
    return VM_COPYSIGN(r, sa);
}

#endif
