/* jacobi/agm.h - the arithmetic-geometric mean */
#ifndef VARMASS_JACOBI_AGM_H
#define VARMASS_JACOBI_AGM_H

#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* 1 - m < 0, NaN or infinite */
VM_API int vmi_refused(vm_real m1) { return !(m1 >= 0) || !VM_IS_FINITE(m1); }
#define VMI_LADDER 16 /* levels; 13 are needed at m1 = 5e-324 */

typedef struct VM_TAG(vmi_ladder) {
    int n;                                /* last level */
    vm_real a[VMI_LADDER], b[VMI_LADDER]; /* a_0 = 1, b_0 = k'; a_(n+1) = (a_n + b_n)/2, b_(n+1) = sqrt(a_n b_n) */
    vm_real c;                            /* c_n = (a_(n-1) - b_(n-1))/2 of the last level */
} vmi_ladder;

/* agm(1, b0) climbed until k_n^2 = (c_n/a_n)^2 <= eps/4, or for so many steps: there sn differs from sin by at most
   eps/60, and a_n from its limit by c_n^2/(4 a_n) <= eps/16 a_n. b0 > 0, finite. */
VM_API void vmi_agm(vmi_ladder *l, vm_real b0, int steps)
{
    int n = 0;
    l->a[0] = 1;
    l->b[0] = b0;
    do {
        vm_real a = l->a[n], b = l->b[n];
        l->c = (a - b) / 2;
        n++;
        l->a[n] = (a + b) / 2;
        l->b[n] = VM_SQRT(a * b);
    } while (4 * l->c * l->c > VM_EPSILON * l->a[n] * l->a[n] && n < steps && n < VMI_LADDER - 1);
    l->n = n;
}

/* K in three words, for plans and for arguments next to a multiple of it: relative error < 2^-(3p - 12) */
VM_API vmi_three vmi_K_three_words(vm_real m1, vm_real m1_lo)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON; /* keeps the square of b from under- and overflow */
    const vm_real lift = m1 < tiny ? 1 / tiny : m1 > 1 / tiny ? VM_EPSILON : 1;
    vmi_three a = vmi_three_words(1, 0, 0);
    vmi_three b = vmi_three_sqrt(vmi_three_words(m1 * lift * lift, m1_lo * lift * lift, 0));
    vm_real c;
    b = vmi_three_scaled(b, 1 / lift);
    do {
        const vmi_three sum = vmi_three_plus(a, b);
        c = (a.hi - b.hi) / 2 + (a.mid - b.mid) / 2;
        b = vmi_three_sqrt(vmi_three_times(a, b));
        a = vmi_three_scaled(sum, VM_C(0.5));
    } while (VM_FABS(c) > VM_EPSILON * a.hi);
    return vmi_three_over(vmi_half_pi(), vmi_three_plus(a, vmi_three_words(-c * c / (4 * a.hi), 0, 0)));
}

/* agm(1, k') = pi/(2K) in two words until the last step is a series: agm(s + c, s - c) = s (1 - x/4 - 5 x^2/64 - ..),
   x = (c/s)^2, which leaves a relative error of x eps/8 < 2^-85 (float 2^-41), and less than an eighth of an eps of
   sn, cn, dn/k', whose slope in u is max(1, k'). m1 > 0. */
VM_API vm_two vmi_agm_two_words(vm_real m1, vm_real m1_lo, vm_real u)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON, last = VM_MANT_DIG > 24 ? VM_C(3e-5) : VM_C(4e-3);
    const vm_real lift = m1 < tiny ? 1 / tiny : 1; /* keeps the square of the root from underflow */
    const vm_two root = vmi_root(m1 * lift * lift, m1_lo * lift * lift);
    const vm_two kp = vmi_two(root.hi / lift, root.lo / lift);
    const vm_real slope = kp.hi > 1 ? kp.hi : 1;
    vm_two a = vmi_two_sum(1, kp.hi), b = vmi_root(kp.hi, kp.lo), p;
    a = vmi_two(a.hi / 2, (a.lo + kp.lo) / 2);
    for (;;) {
        const vm_real c = ((a.hi - b.hi) + (a.lo - b.lo)) / 2;
        const vm_two sum = vmi_two_sum(a.hi, b.hi), s = vmi_two(sum.hi / 2, (sum.lo + (a.lo + b.lo)) / 2);
        const int enough = c * c * (u * slope) < s.hi * s.hi / 4 || VM_FABS(c) < VM_EPSILON * s.hi;
        if (VM_FABS(c) < last * s.hi && enough) {
            const vm_real x = (c / s.hi) * (c / s.hi);
            return vmi_two_sum(s.hi, s.lo - s.hi * x * (VM_C(0.25) + x * VM_C(0.078125)));
        }
        p = vmi_two_product(a.hi, b.hi);
        b = vmi_root(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
        a = s;
    }
}

#endif
