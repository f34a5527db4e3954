/* jacobi/agm.h - the arithmetic-geometric mean and the quarter period from it

   m is the parameter of an elliptic function. From a_0 = 1 and b_0 = k' = sqrt(1 - m) each step makes the next pair:
   a_(n+1) is the arithmetic mean of a_n and b_n, and b_(n+1) their geometric mean. Both sequences tend to one limit,
   agm(1, k'), and the quarter period is K = pi/(2 agm(1, k')). The number of right digits doubles in each step. The
   limit is computed in one word (one vm_real) for jacobi/descending.h, and in two and three words for arguments that
   are large or next to a zero of an elliptic function (jacobi/reduction.h).

       vmi_three K = vmi_K_three_words(VM_C(0.7), 0); // K(0.3) with three times the digits

   Equations: DLMF 19.8. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_AGM_H
#define VARMASS_JACOBI_AGM_H

#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* Returns 1 if m1 = 1 - m is negative, infinite or NaN, so that no elliptic function has this parameter, else 0. */
VM_API int vmi_refused(vm_real m1) { return !(m1 >= 0) || !VM_IS_FINITE(m1); }

/* The largest number of pairs a_n, b_n in a vmi_ladder. m = -1.8e308 needs most pairs, 13. */
#define VMI_LADDER 16

/* The numbers a_n and b_n of all steps of the arithmetic-geometric mean. sn, cn and dn are computed from these numbers,
   from the last step back to the first. */
typedef struct VM_TAG(vmi_ladder) {
    int n;                                /* index of the last pair a_n, b_n */
    vm_real a[VMI_LADDER], b[VMI_LADDER]; /* a_0 = 1, b_0 = k'; a_(n+1) = (a_n + b_n)/2, b_(n+1) = sqrt(a_n b_n) */
} vmi_ladder;

/* Computes agm(1, b0) for a finite b0 > 0 in at most `steps` steps, but at least one. If the number of steps allows,
   the function stops at the first n for which x = (c_n/a_n)^2 <= eps/4. The relative error of the last a_n, as a value
   of agm(1, b0), is then at most eps/16. vmi_descend, which computes sn(u), would have to begin with sn(a_n u) for the
   parameter x. Because x is so small, vmi_descend may begin with sin(a_n u) instead: the two differ by at most eps/60
   for |a_n u| <= pi/4. */
VM_API void vmi_agm(vmi_ladder *l, vm_real b0, int steps)
{
    vm_real c; /* c_n = (a_(n-1) - b_(n-1))/2 */
    int n = 0;
    l->a[0] = 1;
    l->b[0] = b0;
    do {
        vm_real a = l->a[n], b = l->b[n];
        c = (a - b) / 2;
        n++;
        l->a[n] = (a + b) / 2;
        l->b[n] = VM_SQRT(a * b);
    } while (4 * c * c > VM_EPSILON * l->a[n] * l->a[n] && n < steps && n < VMI_LADDER - 1);
    l->n = n;
}

/* Returns the quarter period K in three words, with a relative error below 2^-(3p - 12), for 1 - m = m1 + m1_lo > 0; p
   is the number of binary digits of vm_real. Plans (jacobi/plans.h) and the reduction of an argument next to a multiple
   of K need so many digits. */
VM_API vmi_three vmi_K_three_words(vm_real m1, vm_real m1_lo)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON;
    vm_real lift = 1, c; /* lift is a power of 2: the root of m1 lift^2 is taken, so that no word over- or underflows */
    vmi_three a = vmi_three_words(1, 0, 0), b;
    if (m1 < tiny) lift = 1 / tiny;
    if (m1 > 1 / tiny) lift = VM_EPSILON;
    b = vmi_three_sqrt(vmi_three_words(m1 * lift * lift, m1_lo * lift * lift, 0));
    b = vmi_three_scaled(b, 1 / lift);
    do {
        const vmi_three sum = vmi_three_plus(a, b);
        c = (a.hi - b.hi) / 2 + (a.mid - b.mid) / 2;
        b = vmi_three_sqrt(vmi_three_times(a, b));
        a = vmi_three_scaled(sum, VM_C(0.5));
    } while (VM_FABS(c) > VM_EPSILON * a.hi);
    return vmi_three_over(vmi_half_pi(), vmi_three_plus(a, vmi_three_words(-c * c / (4 * a.hi), 0, 0)));
}

/* Returns agm(1, k') = pi/(2K) in two words, for 1 - m = m1 + m1_lo > 0. Let s be the mean of the last a_n and b_n, c
   half their difference, and x = (c/s)^2. The series agm(s + c, s - c) = s (1 - x/4 - 5 x^2/64 - ...) replaces a
   further step of the mean. The relative error of the result is x eps/8 < 2^-85 (float 2^-41). The argument u is the
   number that will be reduced by means of the result; the larger u is, the smaller x is made. The error of the result
   therefore changes sn, cn and dn/max(1, k') by less than eps/8, since the slopes of these functions are at most
   max(1, k'). */
VM_API vm_two vmi_agm_two_words(vm_real m1, vm_real m1_lo, vm_real u)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON, last = VM_MANT_DIG > 24 ? VM_C(3e-5) : VM_C(4e-3);
    vm_real lift = 1, slope; /* lift is a power of 2: the root of m1 lift^2 is taken, so that no word underflows */
    vm_two root, kp, a, b, p;
    if (m1 < tiny) lift = 1 / tiny;
    root = vmi_root(m1 * lift * lift, m1_lo * lift * lift);
    kp = vmi_two(root.hi / lift, root.lo / lift);
    slope = vmi_larger(kp.hi, 1);
    a = vmi_two_sum(1, kp.hi);
    b = vmi_root(kp.hi, kp.lo);
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
