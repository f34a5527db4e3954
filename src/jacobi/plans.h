/* jacobi/plans.h - sn, cn and dn for many arguments and one parameter

   A plan contains all numbers that depend only on m: the quarter period as a sum of numbers with few digits, and
   polynomials that replace the series of jacobi_sncndn or, for m near 1 or below about -21, the coefficients of the
   theta functions (jacobi/theta.h). A call with a plan is faster, most of all for arrays, where the compiler vectorises
   the loop (docs/cost.md has the times). A plan is plain data: it may be copied, and it may be a constant in flash.

       jacobi_plan p;
       vm_real sn, cn, dn;
       if (jacobi_plan_init(&p, VM_C(0.3)) == 0) jacobi_plan_sncndn(&p, VM_C(1.2), &sn, &cn, &dn);

   Tests: tests/test_jacobi.c, tests/test_plans.sh. Example: examples/print_plan.c. */
#ifndef VARMASS_JACOBI_PLANS_H
#define VARMASS_JACOBI_PLANS_H

#include <string.h>

#include "../base/bits.h"
#include "../base/chebyshev.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "agm.h"
#include "reduction.h"
#include "theta.h"

/* A plan for one parameter m, prepared by jacobi_plan_init. The field `form` tells which method is used for this m;
   fields that the method does not use are 0. */
typedef struct VM_TAG(jacobi_plan) {
    int form;            /* the method: VMI_NEAR_FORM uses a and b; VMI_HYPERBOLIC and VMI_RECIPROCAL use theta */
    vm_real m1;          /* complementary parameter 1 - m */
    vm_real K[VMI_PIECES], per_K; /* K as a sum, see vmi_pieces, and 1/K; for m = 1 both are 0 */
    vm_real a[VMI_TERMS], b[VMI_TERMS]; /* coefficients of two polynomials in v^2, for the reduced argument v */
    vmi_theta_form theta;               /* its field kp, which is k', is set for every method */
} jacobi_plan;

/* Returns the polynomial 1 + c[0] y + c[1] y^2 + ... with VMI_TERMS coefficients c. */
VM_INLINE vm_real vmi_plan_series(const vm_real *c, vm_real y)
{
    const vm_real yy = y * y, y4 = yy * yy, low = (c[0] + y * c[1]) + yy * (c[2] + y * c[3]);
#if VM_MANT_DIG > 24
    const vm_real high = ((c[4] + y * c[5]) + yy * (c[6] + y * c[7])) + y4 * (c[8] + y * c[9]);
#else
    const vm_real high = c[4];
#endif
    return 1 + y * (low + y4 * high);
}

/* The number of terms of the series from which a plan's polynomials are made. The terms that are left out are below
   eps/500 at u = K/2. */
enum { VMI_MORE_TERMS = VM_MANT_DIG > 24 ? 16 : 9 };

/* Replaces the polynomial 1 + c[1] t + ... + c[VMI_MORE_TERMS] t^VMI_MORE_TERMS by a polynomial of degree VMI_TERMS
   that is close to it for 0 <= t <= 1. Each step removes the highest power: it subtracts a multiple of Chebyshev's
   polynomial of the same degree. The constant coefficient stays 1. */
VM_API void vmi_shorten(vm_real *c)
{
    int n;
    for (n = VMI_MORE_TERMS; n > VMI_TERMS; n--) vmi_remove_highest(c, n, 1);
}

/* Computes p->a and p->b, the coefficients of two polynomials in v^2 for |v| <= longest. Let cs = cn/sn and w = v/2.
   The polynomial with the coefficients p->a approximates w^2 cs^2(w). The polynomial with p->b approximates -w^4 times
   the derivative of cs^2(w) with respect to w^2. Both are made from power series (vmi_laurent). Their constant
   coefficients are 1 and are not stored. */
VM_API void vmi_plan_prepare(jacobi_plan *p, vm_real longest)
{
    const vm_real theta = longest * longest / 4;
    vm_real a[VMI_MORE_TERMS + 1], b[VMI_MORE_TERMS + 1], power = 1;
    int k, i;
    vmi_laurent(theta, p->m1 * theta, a);
    for (k = 4; k <= VMI_MORE_TERMS; k++) {
        vm_real sum = 0;
        for (i = 2; i <= k - 2; i++) sum += a[i] * a[k - i];
        a[k] = 3 * sum / (vm_real)((2 * k + 1) * (k - 3));
    }
    for (k = 1; k <= VMI_MORE_TERMS; k++) b[k] = (vm_real)(1 - k) * a[k];
    vmi_shorten(a);
    vmi_shorten(b);
    for (k = 1; k <= VMI_TERMS; k++) {
        power *= longest * longest;
        p->a[k - 1] = a[k] / power;
        p->b[k - 1] = b[k] / power;
    }
}

/* Prepares a plan for 1 - m = m1 + m1_lo, a number in two words. Returns 0, or -1 where no elliptic function has this
   parameter; the plan then stays as it was. */
VM_API int vmi_plan_init(jacobi_plan *p, vm_real m1, vm_real m1_lo)
{
    vmi_three K;
    int is_near;
    if (vmi_refused(m1)) return -1;
    memset(p, 0, sizeof *p);
    p->m1 = m1;
    p->theta.kp = VM_SQRT(m1);
    if (m1 > 0) {
        K = vmi_K_three_words(m1, m1_lo);
        vmi_pieces(K, p->K);
        p->per_K = 1 / K.hi;
    }
    is_near = m1 > 0 && K.hi * K.hi / 4 * vmi_larger(m1, 1) <= VMI_NEAR;
    if (is_near) {
        p->form = VMI_NEAR_FORM;
        vmi_plan_prepare(p, K.hi / 2);
    } else {
        p->form = m1 < 1 ? VMI_HYPERBOLIC : VMI_RECIPROCAL;
        vmi_far_prepare(&p->theta, m1, m1_lo);
    }
    return 0;
}

/* Prepares a plan for the parameter m = k^2 <= 1. Returns 0. For m > 1, NaN and infinite m the result is -1, and the
   plan stays as it was. */
VM_API int jacobi_plan_init(jacobi_plan *p, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_plan_init(p, m1.hi, m1.lo);
}

/* Prepares a plan for the complementary parameter m1 = 1 - m >= 0.
   Domain and result are those of jacobi_plan_init. Use jacobi_plan_init_m1 for m close to 1, where the difference 1 - m
   would lose digits. */
VM_API int jacobi_plan_init_m1(jacobi_plan *p, vm_real m1) { return vmi_plan_init(p, m1 + 0, 0); } /* -0 + 0 is 0 */

/* Returns the theta functions of v, computed from the plan's two polynomials at w = v/2 and by one duplication, which
   leads from w to v (compare vmi_theta_near). The variables a and b are w^2 cs^2(w) and w^2, so that b/a = sc^2(w).
   theta.s is v times the polynomial with the coefficients p->b, since the derivative of cs^2(w) with respect to w is
   -2 cs ns ds. */
VM_INLINE vmi_thetas vmi_plan_near(const jacobi_plan *p, vm_real v)
{
    vmi_thetas theta;
    const vm_real y = v * v, a = vmi_plan_series(p->a, y), b = y / 4, s = p->m1 * b, aa = a * a, sb = s * b;
    theta.s = v * vmi_plan_series(p->b, y);
    theta.c = aa - sb;
    theta.d = aa + (2 * s * a + sb);
    theta.n = aa + (2 * b * a + sb);
    return theta;
}

/* Computes sn, cn and dn at one u, where |u| = j K + rest with an integer j. Of the number `quarters` only the last two
   bits are used; they are j modulo 4. If the compiler knows the form, the code has no branch. */
VM_INLINE void vmi_plan_point(const jacobi_plan *p, int form, vm_real u, vmi_three rest, vmi_bits quarters,
                              vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_thetas theta;
    if (form == VMI_NEAR_FORM) theta = vmi_plan_near(p, (rest.hi + rest.mid) + rest.lo);
    else {
        const vm_two sum = vmi_two_sum(rest.hi, rest.mid);
        vm_two v = vmi_fast_two_sum(sum.hi, sum.lo + rest.lo);
        if (form == VMI_RECIPROCAL) {
            const vm_two product = vmi_two_product(v.hi, p->theta.kp);
            v = vmi_fast_two_sum(product.hi, product.lo + (v.hi * p->theta.kp_lo + v.lo * p->theta.kp));
        }
        v.hi = vmi_smaller(vmi_larger(v.hi, -VMI_LONGEST), VMI_LONGEST); /* removes a NaN, but then v.lo is NaN, too */
        theta = vmi_theta_far(&p->theta, form == VMI_RECIPROCAL, v);
    }
    theta = vmi_theta_shift(theta, p->theta.kp, quarters);
    theta.s *= VM_COPYSIGN((vm_real)1, u);
    vmi_theta_ratios(theta, p->theta.kp, sn, cn, dn);
}

/* Returns u minus the nearest multiple j K, for a u >= 0 that is too large for vmi_reduce_pieces, infinite or NaN.
   *quarters becomes a number whose last two bits are j modulo 4. For an infinite u the result is NaN, except for m = 1,
   where there is no period: then the function returns the smaller of u and VMI_LONGEST. */
VM_API vmi_three vmi_plan_reduce_long(const jacobi_plan *p, vm_real u, vmi_bits *quarters)
{
    const vm_two head = vmi_two_sum(p->K[0], p->K[1]), K = vmi_two_sum(head.hi, head.lo + (p->K[2] + p->K[3]));
    vm_two v;
    int quarter;
    *quarters = 0;
    if (p->per_K == 0) { /* m = 1, where there is no period */
        const vm_real cut = u > VMI_LONGEST ? VMI_LONGEST : u;
        return vmi_three_words(cut, 0, 0);
    }
    if (!VM_IS_FINITE(u)) return vmi_three_words(VM_NAN, 0, 0);
    v = vmi_reduce(u, K, &quarter);
    *quarters = (vmi_bits)quarter;
    return vmi_three_words(v.hi, v.lo, 0);
}

/* Returns 1 if more digits of K are needed because `rest` is so small, else 0. The number `rest` is u minus a multiple
   of K, as vmi_reduce_pieces computes this difference. */
VM_INLINE int vmi_plan_is_close(vm_real rest, vm_real u) { return VM_FABS(rest) < VMI_PIECES_REACH * u; }

/* sn, cn and dn of the argument u for the plan's parameter.
   u may be any number; the accuracy is that of jacobi_sncndn. The results are NaN for infinite u, unless m = 1.
   docs/cost.md has the time of a call. */
VM_API void jacobi_plan_sncndn(const jacobi_plan *p, vm_real u, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real x = VM_FABS(u);
    vmi_bits quarters;
    vmi_three v;
    if (x * p->per_K < VMI_EXACT_QUARTERS) {
        v = vmi_reduce_pieces(x, p->K, p->per_K, &quarters);
        if (vmi_plan_is_close((v.hi + v.mid) + v.lo, x)) {
            const vm_two finely = vmi_reduce_finely(x, p->K, p->per_K, &quarters);
            v = vmi_three_words(finely.hi, finely.lo, 0);
        }
    } else v = vmi_plan_reduce_long(p, x, &quarters);
    if (p->form == VMI_NEAR_FORM) {
        vmi_plan_point(p, VMI_NEAR_FORM, u, v, quarters, sn, cn, dn);
        return;
    }
    vmi_plan_point(p, p->form, u, v, quarters, sn, cn, dn);
    if (*sn == 0) { /* where sn is 0, cn is exactly 1 or -1, and dn is 1 */
        *cn = VM_COPYSIGN((vm_real)1, *cn);
        *dn = 1;
    }
}

/* Computes sn, cn and dn of n arguments, each with |u| < VMI_EXACT_QUARTERS K, in a loop that compilers can
   vectorise. */
VM_INLINE void vmi_plan_loop(const jacobi_plan *p, int form, int n, const vm_real *u, vm_real *sn, vm_real *cn,
                             vm_real *dn)
{
    int i;
    for (i = 0; i < n; i++) {
        vmi_bits quarters;
        const vmi_three v = vmi_reduce_pieces(VM_FABS(u[i]), p->K, p->per_K, &quarters);
        vmi_plan_point(p, form, u[i], v, quarters, sn + i, cn + i, dn + i);
    }
    if (form == VMI_NEAR_FORM) return;
    for (i = 0; i < n; i++)
        if (sn[i] == 0) { /* where sn is 0, cn is exactly 1 or -1, and dn is 1 */
            cn[i] = VM_COPYSIGN((vm_real)1, cn[i]);
            dn[i] = 1;
        }
}

/* Computes those results again that are next to a zero of sn or cn, one by one and with more digits of K. Next to a
   zero j K, the size of sn is about the distance |u - j K|, and the size of cn is about k' times this distance. */
VM_API void vmi_plan_mend_close(const jacobi_plan *p, int n, const vm_real *u, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real kp = p->theta.kp;
    int i, any_close = 0;
    for (i = 0; i < n; i++) {
        const vm_real x = VM_FABS(u[i]);
        any_close |= vmi_plan_is_close(sn[i], x) | vmi_plan_is_close(cn[i], kp * x);
    }
    for (i = 0; any_close && i < n; i++)
        if (vmi_plan_is_close(sn[i], VM_FABS(u[i])) || vmi_plan_is_close(cn[i], kp * VM_FABS(u[i])))
            jacobi_plan_sncndn(p, u[i], sn + i, cn + i, dn + i);
}

/* sn, cn and dn of the n arguments in the array u, for the plan's parameter. The arrays sn, cn, dn have n elements each
   and must overlap neither each other nor u. The values are those of jacobi_plan_sncndn; where the compiler fuses
   multiplications and additions, the last bits may depend on the index in the array. docs/cost.md has the time of a
   call. */
VM_API void jacobi_plan_sncndn_array(const jacobi_plan *p, int n, const vm_real *u, vm_real *sn, vm_real *cn,
                                     vm_real *dn)
{
    const jacobi_plan local = *p; /* the compiler knows that no array overlaps this copy */
    int i, any_far = 0;
    for (i = 0; i < n; i++) any_far |= !(VM_FABS(u[i]) * local.per_K < VMI_EXACT_QUARTERS);
    if (any_far) {
        for (i = 0; i < n; i++) jacobi_plan_sncndn(p, u[i], sn + i, cn + i, dn + i);
        return;
    }
    if (local.form == VMI_NEAR_FORM) vmi_plan_loop(&local, VMI_NEAR_FORM, n, u, sn, cn, dn);
    else if (local.form == VMI_HYPERBOLIC) vmi_plan_loop(&local, VMI_HYPERBOLIC, n, u, sn, cn, dn);
    else vmi_plan_loop(&local, VMI_RECIPROCAL, n, u, sn, cn, dn);
    vmi_plan_mend_close(&local, n, u, sn, cn, dn);
}

#endif
