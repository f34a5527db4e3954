/* ateb/two_indices.h - Ateb functions with two indices */
#ifndef VARMASS_ATEB_TWO_INDICES_H
#define VARMASS_ATEB_TWO_INDICES_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "beta.h"
#include "functions.h"

VM_API int vmi_ateb_index(vm_real n) { return n == 0 || (n >= VM_C(1e-4) && n <= VM_C(1e5)); }
VM_API vm_two vmi_ateb_exponent(vm_real n) { return vmi_two_over(vmi_two(1, 0), vmi_two_sum(n, 1)); }

/* B_(1/2)(a, b) 2^(a+b) = 2F1(1, a+b; a+1; 1/2)/a [3, 8.17.8]; b <= 1, so that each term is half of the one before it
   or less */
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

/* Pi(n, m) = B(a, b), a = 1/(n+1), b = 1/(m+1), within 2^-102 (float 2^-44), where logarithms would leave 2^-64: the
   halves of the integral, over 2^(a+b) by its power series */
VM_API vm_two vmi_ateb_pi_nm(vm_real n, vm_real m)
{
#if VM_MANT_DIG > 24
    const vm_two ln2 = {VM_C(0.69314718055994528623), VM_C(2.3190468138462995584e-17)};
#else
    const vm_two ln2 = {VM_C(0.693147182465), VM_C(-1.90465429995e-9)};
#endif
    const vm_two one = {1, 0}, a = vmi_ateb_exponent(n), b = vmi_ateb_exponent(m);
    const vm_two y = vmi_two_times(vmi_two_plus(a, b), ln2); /* <= 1.39 */
    vm_two power = one;
    int j;
    for (j = VM_MANT_DIG > 24 ? 32 : 18; j > 0; j--)
        power = vmi_two_plus(one, vmi_two_over(vmi_two_times(power, y), vmi_two((vm_real)j, 0)));
    return vmi_two_over(vmi_two_plus(vmi_ateb_half_beta(a, b), vmi_ateb_half_beta(b, a)), power);
}

/* sa(n, m, s) and ca(m, n, s), |sa|^(n+1) + |ca|^(m+1) = 1, for real n, m = 0 or 1e-3 to 1e3
   (1e-4 to 1e5 less accurately, NaN beyond), of period 2 Pi(n, m); the functions above are those of n = 1, m = alpha,
   and ateb_saca_nm(s, alpha, 1, ...) gives the swapped pair sa(alpha, 1, s), ca(1, alpha, s) that (278) and (280)
   need. Slow, by inversion of the incomplete beta function. */
VM_API vm_real ateb_pi_nm(vm_real n, vm_real m)
{
    return vmi_ateb_index(n) && vmi_ateb_index(m) ? vmi_ateb_pi_nm(n, m).hi : VM_NAN;
}

/* x^a with I_x(a, b) = p, q = 1 - p */
VM_API vm_real vmi_ateb_nm_first(vm_real p, vm_real q, vm_real a, vm_real b)
{
    vm_real x, y;
    vm_two ln_x, ignored, power;
    if (p == 0 || q == 0) return p == 0 ? 0 : 1;
    if (p <= q) vmi_beta_invert(vmi_log(p), a, b, &x, &y, &ln_x, &ignored);
    else vmi_beta_invert(vmi_log(q), b, a, &y, &x, &ignored, &ln_x);
    power = vmi_two_scaled(ln_x, a);
    return vmi_exp(power.hi, power.lo);
}

/* Documented with ateb_pi_nm. */
VM_API void ateb_saca_nm(vm_real s, vm_real n, vm_real m, vm_real *sa, vm_real *ca)
{
    vm_real a, b, other, rest, r, d;
    vm_two pi;
    int quarter;
    if (!vmi_ateb_index(n) || !vmi_ateb_index(m) || !VM_IS_FINITE(s)) {
        *sa = *ca = VM_NAN;
        return;
    }
    a = 1 / (n + 1);
    b = 1 / (m + 1);
    pi = vmi_half(vmi_ateb_pi_nm(n, m));
    rest = vmi_reduce(VM_FABS(s), pi, &quarter).hi;
    d = VM_FABS(rest);
    r = (pi.hi - d) + pi.lo;
    if (!(quarter & 1)) {
        other = r;
        r = d;
        d = other;
    }
    *sa = vmi_ateb_nm_first(r / pi.hi, d / pi.hi, a, b);
    *ca = vmi_ateb_nm_first(d / pi.hi, r / pi.hi, b, a);
    vmi_ateb_signs(s, rest, (vmi_bits)quarter, sa, ca);
}

#endif
