/* jacobi/integrals.h - complete elliptic integrals K and E

     K(m) = integral from 0 to pi/2 of dx/sqrt(1 - m sin^2 x),
     E(m) = integral from 0 to pi/2 of sqrt(1 - m sin^2 x) dx.
   The parameter m = k^2 is any number <= 1, also a negative one. The functions with the suffix _m1 take m1 = 1 - m; use
   them for m close to 1, where the difference 1 - m would lose digits. For m between -33.5 and 0.971 K and E are
   computed by series after steps of the arithmetic-geometric mean: two steps for K, one for E. For any other m they are
   computed by sums that contain the logarithm of k' = sqrt(1 - m).

       vm_real K = jacobi_K(VM_C(0.5)); // 1.854...

   Source: equation (307) of the dissertation, and DLMF 19. The polynomials are computed by
   tests/gen/jacobi_coefficients.py. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_INTEGRALS_H
#define VARMASS_JACOBI_INTEGRALS_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"

/* VMI_MIDDLE(m1) is 1 if K and E are computed by series for this m1 = 1 - m, and 0 if they are computed by
   logarithms. */
#define VMI_MIDDLE(m1) ((m1) > VM_C(0.029) && (m1) < VM_C(34.5))

/* Returns ln(4/k') for m1 < 1 and ln(4 k') for m1 > 1 in two words, where k'^2 = m1 + m1_lo. */
VM_API vm_two vmi_log_4(vm_real m1, vm_real m1_lo)
{
#if VM_MANT_DIG > 24
    const vm_real ln4 = VM_C(1.386294361119890572454), ln4_lo = VM_C(4.638093627692599230990e-17);
#else
    const vm_real ln4 = VM_C(1.386294364929199218750), ln4_lo = VM_C(-3.809308599915535757084e-9);
#endif
    const vm_two L = vmi_log(m1);
    const vm_real half = m1 < 1 ? -VM_C(0.5) : VM_C(0.5);
    const vm_two sum = vmi_two_sum(ln4, half * L.hi);
    return vmi_two(sum.hi, sum.lo + (ln4_lo + half * (L.lo + m1_lo / m1)));
}

/* Returns K in two words for 1 - m = c <= 1/2 and l = ln(4/k'), as K = l + c (l - 1)/4 + c^2 (l A(c) - B(c)). The
   polynomials A and B were fitted together; the relative error that they make in K is below 2^-58 (float 2^-30). */
VM_API vm_two vmi_K_by_log(vm_real c, vm_two l)
{
    const vm_real cc = c * c, head = vmi_head(c), tail = c - head;
    const vm_real less = l.hi - 1, less_head = vmi_head(less), less_tail = less - less_head;
    const vm_two sum = vmi_fast_two_sum(l.hi, head * less_head / 4);
#if VM_MANT_DIG > 24
    const vm_real A01 = VM_C(0.140624999989917426) + c * VM_C(0.0976562379873884279);
    const vm_real A23 = VM_C(0.0747659708874116175) + c * VM_C(0.0604635753570759646);
    const vm_real A45 = VM_C(0.0492978880327891861) + c * VM_C(0.0339442681568997914);
    const vm_real A67 = VM_C(0.012474590931201476) + c * VM_C(6.09741459959139043e-4);
    const vm_real b01 = VM_C(0.164062499943033208) + c * VM_C(0.120442655878206961);
    const vm_real b23 = VM_C(0.0948766696910365165) + c * VM_C(0.0779033129747223191);
    const vm_real b45 = VM_C(0.0624531825687128506) + c * VM_C(0.037162517735165726);
    const vm_real b67 = VM_C(7.51299469689479475e-3) - c * VM_C(1.21456158984582113e-3);
    const vm_real A = (A01 + cc * A23) + cc * cc * ((A45 + cc * A67) - cc * cc * VM_C(1.47954745189517243e-4));
    const vm_real B = (b01 + cc * b23) + cc * cc * (b45 + cc * b67);
#else
    const vm_real A01 = VM_C(0.1406276673) + c * VM_C(0.09707102925);
    const vm_real A = A01 + cc * (VM_C(0.06059887633) + c * VM_C(0.012512994));
    const vm_real B = VM_C(0.1640692502) + c * (VM_C(0.1182833314) + c * VM_C(0.06061541289));
#endif
    const vm_real middle = (head * less_tail + tail * less) / 4 + cc * (l.hi * A - B);
    return vmi_fast_two_sum(sum.hi, sum.lo + (l.lo + middle));
}

/* Returns E - 1 for 1 - m = c <= 1/2 and l = ln(4/k'), as E - 1 = c (l A(c) - B(c)). The error that the polynomials A
   and B make is below 2^-54.5 (float 2^-25.7). */
VM_API vm_real vmi_E_rest(vm_real c, vm_real l)
{
    const vm_real cc = c * c;
#if VM_MANT_DIG > 24
    const vm_real A01 = VM_C(0.499999999999303724) + c * VM_C(0.187499997923190304);
    const vm_real A23 = VM_C(0.117186821989593418) + c * VM_C(0.0853987891959771678);
    const vm_real A45 = VM_C(0.0661404122824279239) + c * VM_C(0.0462006550177885);
    const vm_real A67 = VM_C(0.0180993698311603043) + c * VM_C(5.73337947036873879e-4);
    const vm_real b01 = VM_C(0.24999999999566927) + c * VM_C(0.203124990160116814);
    const vm_real b23 = VM_C(0.140622372161008674) + c * VM_C(0.106750406049363547);
    const vm_real b45 = VM_C(0.0830562354113903306) + c * VM_C(0.0517296710396015144);
    const vm_real b67 = VM_C(0.0113912385296323967) + c * VM_C(-2.40808484454518293e-3);
    const vm_real A = (A01 + cc * A23) + cc * cc * ((A45 + cc * A67) - cc * cc * VM_C(3.4706602508716508e-4));
    const vm_real B = (b01 + cc * b23) + cc * cc * (b45 + cc * b67);
#else
    const vm_real A23 = VM_C(0.09726078063) + c * VM_C(0.01954176836);
    const vm_real b23 = VM_C(0.09307274967) + c * VM_C(1.615328365e-4);
    const vm_real A = VM_C(0.4999949038) + c * VM_C(0.1864423007) + cc * A23;
    const vm_real B = VM_C(0.2499748766) + c * VM_C(0.1995639652) + cc * b23;
#endif
    return c * (l * A - B);
}

/* Returns S(x) for x = ((1 - k')/(1 + k'))^2. S is the power series for which K = pi/(1 + k') (1 + x S(x)), and it is
   computed by a polynomial. The polynomial's error of x S is below 2^-58.7 (float 2^-29.6) for x <= 0.0299. vmi_K
   makes x so small by a step of the arithmetic-geometric mean, which replaces k' by 2 sqrt(k')/(1 + k'). One such step
   leads to x < 0.0299 for every m1 for which VMI_MIDDLE(m1) is 1. */
VM_API vm_real vmi_K_series(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_real xx = x * x;
    const vm_real S01 = VM_C(0.250000000000002276) + x * VM_C(0.140624999998056721);
    const vm_real S23 = VM_C(0.0976562505663747388) + x * VM_C(0.0747679882260262468);
    const vm_real S45 = VM_C(0.0605678939898120217) + x * VM_C(0.0506567294491898287);
    return (S01 + xx * S23) + xx * xx * (S45 + xx * VM_C(0.0486832738964245657));
#else
    return VM_C(0.2500003576) + x * (VM_C(0.1405491382) + x * VM_C(0.1020393297));
#endif
}

/* Returns x S(x) for x = ((1 - k')/(1 + k'))^2 <= 0.503. S is the power series for which E = (pi/4) (1 + k') (1 + x
   S(x)), not the S of vmi_K_series, and it is computed by a polynomial. The polynomial's error of x S is below 2^-56.7
   (float 2^-28.5). */
VM_API vm_real vmi_E_series(vm_real x)
{
    const vm_real xx = x * x, x4 = xx * xx;
#if VM_MANT_DIG > 24
    const vm_real S01 = VM_C(0.249999999999998501) + x * VM_C(0.015625000000338965);
    const vm_real S23 = VM_C(3.90624997325988814e-3) + x * VM_C(1.52587997709131905e-3);
    const vm_real S45 = VM_C(7.47655087182482977e-4) + x * VM_C(4.20968920831230303e-4);
    const vm_real S67 = VM_C(2.55356931163965744e-4) + x * VM_C(2.04222291722467767e-4);
    const vm_real S89 = VM_C(-6.44253151491566971e-5) + x * VM_C(8.41539381412701858e-4);
    const vm_real SAB = VM_C(-2.23033122391106189e-3) + x * VM_C(5.13605764430626315e-3);
    const vm_real SCD = VM_C(-7.99521933118507375e-3) + x * VM_C(8.6386328798905114e-3);
    const vm_real SEF = VM_C(-5.6395773761986805e-3) + x * VM_C(1.79039420508178429e-3);
    const vm_real low = (S01 + xx * S23) + x4 * (S45 + xx * S67);
    return x * (low + x4 * x4 * ((S89 + xx * SAB) + x4 * (SCD + xx * SEF)));
#else
    const vm_real S23 = VM_C(3.9256569e-3) + x * VM_C(1.379663823e-3);
    const vm_real S45 = VM_C(1.321772113e-3) + x * VM_C(-7.536308258e-4);
    return x * ((VM_C(0.2500000298) + x * VM_C(0.0156237958)) + xx * S23 + x4 * (S45 + xx * VM_C(1.340579358e-3)));
#endif
}

/* Returns K for 1 - m = m1 + m1_lo, a number in two words. Where VMI_MIDDLE(m1) is 1, K comes from two steps of the
   arithmetic-geometric mean and the series S(x) of vmi_K_series: K = 2 pi (1 + x S(x))/(1 + f)^2 with f^2 = k' and
   x = ((1 - f)/(1 + f))^4. For m > 0.971 K comes from a logarithm (vmi_K_by_log). For m < -33.5 K is K(mu)/k', where mu
   is the parameter with 1 - mu = 1/(1 - m), and K(mu) comes from a logarithm, too. */
VM_API vm_real vmi_K(vm_real m1, vm_real m1_lo)
{
    vm_two K, root;
    vm_real quotient;
    if (VMI_MIDDLE(m1)) {
        const vmi_three half_pi = vmi_half_pi();
        const vm_real kp = VM_SQRT(m1), f = VM_SQRT(kp), h = (1 - f) / (1 + f), x = vmi_fourth_power(h);
        const vm_two first = vmi_two_sum(1, kp), sum = vmi_fast_two_sum(first.hi, 2 * f);
        const vm_real start = 4 * half_pi.hi / sum.hi, low = (first.lo + sum.lo) * VM_C(0.1591549430918953358);
        return start + start * (x * vmi_K_series(x) - start * low + half_pi.mid / half_pi.hi);
    }
    if (m1 == VM_INFINITY) return 0;
    if (vmi_refused(m1)) return VM_NAN;
    if (m1 == 0) return VM_INFINITY;
    K = vmi_K_by_log(m1 < 1 ? m1 : 1 / m1, vmi_log_4(m1, m1_lo));
    if (m1 < 1) return K.hi;
    root = vmi_root(m1, m1_lo);
    quotient = K.hi / root.hi;
    return quotient + (K.lo - quotient * root.lo) / root.hi;
}

/* Returns E for 1 - m = m1 + m1_lo, a number in two words. Where VMI_MIDDLE(m1) is 1, E comes from vmi_E_series. For
   m > 0.971 E comes from vmi_E_rest. For m < -33.5 E is k' E(mu), where mu is the parameter with 1 - mu = 1/(1 - m),
   and E(mu) comes from vmi_E_rest, too. */
VM_API vm_real vmi_E(vm_real m1, vm_real m1_lo)
{
    vm_two root;
    vm_real rest;
    if (VMI_MIDDLE(m1)) {
        const vmi_three half_pi = vmi_half_pi();
        const vm_real kp = VM_SQRT(m1), k1 = (1 - kp) / (1 + kp);
        const vm_two sum = vmi_two_sum(1, kp);
        const vm_real kp_lo = m1_lo * VM_C(0.09); /* low word of k': about m1_lo/(2 k') for m < -15, else negligible */
        const vm_real more = (sum.lo + kp_lo) + sum.hi * vmi_E_series(k1 * k1);
        return half_pi.hi / 2 * sum.hi + (half_pi.hi / 2 * more + half_pi.mid / 2 * sum.hi);
    }
    if (m1 == VM_INFINITY) return VM_INFINITY;
    if (vmi_refused(m1)) return VM_NAN;
    if (m1 == 0) return 1;
    rest = vmi_E_rest(vmi_smaller(m1, 1 / m1), vmi_log_4(m1, m1_lo).hi);
    if (m1 < 1) return 1 + rest;
    root = vmi_root(m1, m1_lo);
    return root.hi + (root.lo + root.hi * rest);
}

/* K(m), the complete elliptic integral of the first kind, from m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_K. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_K_m1(vm_real m1) { return vmi_K(m1, 0); }

/* E(m), the complete elliptic integral of the second kind, from m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_E. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_E_m1(vm_real m1) { return vmi_E(m1, 0); }

/* K(m), the complete elliptic integral of the first kind, for m <= 1: a quarter of the period of sn. The error is at
   most 2 ulp. Returns infinity for m = 1, 0 for m = -infinity, and NaN for m > 1. DLMF 19.2.8. */
VM_API vm_real jacobi_K(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_K(m1.hi, m1.lo);
}

/* E(m), the complete elliptic integral of the second kind, for m <= 1. The error is at most 2 ulp. Returns 1 for
   m = 1, infinity for m = -infinity, and NaN for m > 1. DLMF 19.2.8. */
VM_API vm_real jacobi_E(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_E(m1.hi, m1.lo);
}

/* k' K(m) = sqrt(1 - m) K(m), the left side of equation (307), for m <= 1. The product falls from infinity, as m tends
   to -infinity, to 0 at m = 1. The error is at most 5 ulp. Returns NaN for m > 1 and for infinite m. */
VM_API vm_real jacobi_kpK(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    if (vmi_refused(m1.hi)) return VM_NAN;
    if (m1.hi == 0) return 0;
    if (m1.hi > 10) return vmi_K_by_log(1 / m1.hi, vmi_log_4(m1.hi, m1.lo)).hi;
    return VM_SQRT(m1.hi) * vmi_K(m1.hi, m1.lo);
}

#endif
