/* ateb/two_indices.h - Ateb functions with two indices, sa(n, m, s) and ca(m, n, s)

   sa(n, m, s) and ca(m, n, s) satisfy |sa|^(n+1) + |ca|^(m+1) = 1 and have the period 2 Pi(n, m), where
   Pi(n, m) = B(1/(n+1), 1/(m+1)). For n = 1 and m = alpha they are sa and ca of ateb/functions.h, where they are
   computed much faster. The swapped pair sa(alpha, 1, s), ca(1, alpha, s), which (278) and (280) need, comes from
   ateb_saca_nm(s, alpha, 1, &sa, &ca).

       vm_real sa, ca;
       ateb_saca_nm(VM_C(0.7), 2, 3, &sa, &ca);

   Method: inversion of the incomplete beta function (ateb/beta_inverse.h). Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_TWO_INDICES_H
#define VARMASS_ATEB_TWO_INDICES_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "beta.h"
#include "beta_inverse.h"
#include "functions.h"

/* Returns 1 if n may be an index, that is, if it is 0 or lies between 1e-4 and 1e5, else 0. */
VM_API int vmi_ateb_index_is_in_domain(vm_real n) { return n == 0 || (n >= VM_C(1e-4) && n <= VM_C(1e5)); }

/* Returns 1/(n + 1) in two words. */
VM_API vm_two vmi_ateb_exponent(vm_real n) { return vmi_two_over(vmi_two(1, 0), vmi_two_sum(n, 1)); }

/* Returns B_(1/2)(a, b) 2^(a+b) = 2F1(1, a+b; a+1; 1/2)/a for b <= 1 (DLMF 8.17.8). B_(1/2) is the incomplete beta
   function at x = 1/2 (not regularised). 2F1 is a power series, in which each term is at most half of the previous
   term, so that 2 VM_MANT_DIG terms are enough for two words. */
VM_API vm_two vmi_ateb_half_beta(vm_two a, vm_two b)
{
    const vm_two one = {1, 0}, c = vmi_two_plus(a, b);
    vm_two sum = one;
    int j;
    for (j = 2 * VM_MANT_DIG; j > 0; j--) {
        const vm_two above = vmi_two_plus(c, vmi_two((vm_real)(j - 1), 0));
        const vm_two below = vmi_two_plus(a, vmi_two((vm_real)j, 0));
        sum = vmi_two_plus(one, vmi_half(vmi_two_times(sum, vmi_two_over(above, below))));
    }
    return vmi_two_over(sum, a);
}

/* Returns Pi(n, m) = B(a, b) for a = 1/(n + 1) and b = 1/(m + 1), with a relative error of 2^-102 (float 2^-44); the
   logarithms of ateb/beta.h would give only 2^-64. Pi(n, m) is B_(1/2)(a, b) + B_(1/2)(b, a). vmi_ateb_half_beta
   returns each of them times 2^(a+b); therefore the sum is divided by 2^(a+b) = e^y, which is computed by the power
   series of e^y. */
VM_API vm_two vmi_ateb_pi_nm(vm_real n, vm_real m)
{
    enum { TERMS = VM_MANT_DIG > 24 ? 32 : 18 };
#if VM_MANT_DIG > 24
    const vm_two ln2 = {VM_C(0.69314718055994528623), VM_C(2.3190468138462995584e-17)};
#else
    const vm_two ln2 = {VM_C(0.693147182465), VM_C(-1.90465429995e-9)};
#endif
    const vm_two one = {1, 0}, a = vmi_ateb_exponent(n), b = vmi_ateb_exponent(m);
    const vm_two y = vmi_two_times(vmi_two_plus(a, b), ln2); /* at most 1.39 */
    vm_two power = one;
    int j;
    for (j = TERMS; j > 0; j--)
        power = vmi_two_plus(one, vmi_two_over(vmi_two_times(power, y), vmi_two((vm_real)j, 0)));
    return vmi_two_over(vmi_two_plus(vmi_ateb_half_beta(a, b), vmi_ateb_half_beta(b, a)), power);
}

/* Pi(n, m), half the period of sa(n, m, s) and ca(m, n, s). Each index is 0 or lies between 1e-4 and 1e5.
   Pi(n, m) = B(1/(n+1), 1/(m+1)); Pi(1, alpha) is ateb_pi(alpha). The error is at most 1 ulp. Returns NaN for other
   indices. */
VM_API vm_real ateb_pi_nm(vm_real n, vm_real m)
{
    if (!vmi_ateb_index_is_in_domain(n) || !vmi_ateb_index_is_in_domain(m)) return VM_NAN;
    return vmi_ateb_pi_nm(n, m).hi;
}

/* Returns x^a for the x with I_x(a, b) = p, where q = 1 - p. The function uses logarithms, since x itself may
   underflow. */
VM_API vm_real vmi_ateb_nm_first(vm_real p, vm_real q, vm_real a, vm_real b)
{
    vm_two power;
    if (p == 0) return 0;
    if (q == 0) return 1;
    power = vmi_two_scaled(vmi_beta_invert_both(p, q, a, b).ln_x, a);
    return vmi_exp(power.hi, power.lo);
}

/* sa(n, m, s) and ca(m, n, s), the Ateb functions with two indices. s is any real number; each index is 0 or lies
   between 1e-3 and 1e3. s, sa and ca are pure numbers. The errors are at most 8 ulp plus the change that an error of
   2^-102 |s| (float 2^-44 |s|) in s makes. Indices between 1e-4 and 1e5 are allowed too, with less accuracy. The
   results are NaN for other indices and for NaN and infinite s. */
VM_API void ateb_saca_nm(vm_real s, vm_real n, vm_real m, vm_real *sa, vm_real *ca)
{
    vm_real a, b, rest, r, d; /* r and d: the distances of s from the nearest zeros of sa and ca */
    vm_two quarter_period;
    int quarter;
    if (!vmi_ateb_index_is_in_domain(n) || !vmi_ateb_index_is_in_domain(m) || !VM_IS_FINITE(s)) {
        *sa = VM_NAN;
        *ca = VM_NAN;
        return;
    }
    a = 1 / (n + 1);
    b = 1 / (m + 1);
    quarter_period = vmi_half(vmi_ateb_pi_nm(n, m));
    rest = vmi_reduce(VM_FABS(s), quarter_period, &quarter).hi;
    d = VM_FABS(rest);
    r = (quarter_period.hi - d) + quarter_period.lo;
    if (!(quarter & 1)) {
        const vm_real other = r;
        r = d;
        d = other;
    }
    *sa = vmi_ateb_nm_first(r / quarter_period.hi, d / quarter_period.hi, a, b);
    *ca = vmi_ateb_nm_first(d / quarter_period.hi, r / quarter_period.hi, b, a);
    vmi_ateb_signs(s, rest, (vmi_bits)quarter, sa, ca);
}

#endif
