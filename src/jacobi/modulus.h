/* jacobi/modulus.h - the parameter from K or from k' K */
#ifndef VARMASS_JACOBI_MODULUS_H
#define VARMASS_JACOBI_MODULUS_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* m = 16 q R, R = (theta_2(q)/(2 q^(1/4) theta_3(q)))^4, from (1 - R)/q, which rounds less; |q| <= 0.1. With
   b = R^(1/4) = (1 + q^2 + q^6 + q^12)/theta_3, (1 - b)/q = (2 - q + 2 q^3 - q^5 + 2 q^8 - q^11)/theta_3. */
VM_API vm_real vmi_theta_loss(vm_real q)
{
    const vm_real y = q * q, y2 = y * y, theta3 = 1 + 2 * (q + y2 * (1 + y2 * q));
    const vm_real rho = (2 - q + q * y * (2 - y) + y2 * y2 * (2 - q * y)) / theta3, b = 1 - q * rho;
    return rho * ((1 + b) * (1 + b * b));
}

/* A parameter by its nome q, which is that of m where circular, else exp(-L - L_lo) and that of 1 - m, or where
   upside that of 1/(1 - m) */
typedef struct VM_TAG(vmi_solution) {
    int circular, upside;
    vm_real q, L, L_lo;
} vmi_solution;

/* theta_4(q)^2 = 2 c/pi: the nome of k'K = c, minus that of K = c, for c within K(-1) and K(1/2) */
VM_API vm_real vmi_solve_middle(vm_real c)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real less = ((half_pi.hi - c) + half_pi.mid) / half_pi.hi; /* 1 - theta_4^2 */
    const vm_real start = less / (2 * (1 + VM_SQRT(1 - less)));         /* (1 - theta_4)/2 = q - q^4 + q^9 */
    vm_real q = start;
    int i;
    for (i = 0; i < 6; i++)
        q = start + vmi_fourth_power(q) * (1 - vmi_fourth_power(q) * q); /* each 3 digits more */
    return q;
}

#define VMI_SMALL_STEP (VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(2e-5)) /* Newton's next step is below an eps */

/* L = -ln q with K = L theta_3(q)^2/2 = c, c >= K(1/2): Newton's method for lambda = 2c - L = 2c (1 - theta_3^-2),
   0 <= lambda < 0.57, from 0, where seven steps do */
VM_API void vmi_solve_high(vm_real c, vmi_solution *s)
{
    vm_real lambda = 0, step = 1;
    vm_two L = vmi_two(2 * c, 0);
    int i;
    for (i = 0; i < 8 && VM_FABS(step) > VMI_SMALL_STEP; i++) {
        const vm_real q = vmi_exp(-L.hi, -L.lo), q3 = q * q * q, t = 2 * q * (1 + q3 * (1 + q3 * q * q));
        const vm_real over = 1 / (1 + t), value = 2 * c * (t * (2 + t)) * (over * over);
        step = (lambda - value) / (1 - 8 * c * q * (1 + 4 * q3) * (over * over * over));
        lambda -= step;
        L = vmi_two_sum(2 * c, -lambda);
    }
    s->L = L.hi;
    s->L_lo = L.lo;
}

/* ln(1 + x), 0 <= x < 0.0019 */
VM_API vm_real vmi_small_log(vm_real x)
{
    return x - x * x * (VM_C(0.5) - x * (VM_C(0.3333333333333333333) - x * (VM_C(0.25) - x * VM_C(0.2))));
}

/* L with k'K = 2 L sqrt(q) (1 + q^2 + q^6)^2 = c, 0 < c <= K(-1): Newton's method for
     L/2 - ln L - 2 ln(1 + q^2 + q^6) = ln(2/c),
   convex and rising, from above the root, where seven steps do; the last residual in two words */
VM_API void vmi_solve_low(vm_real c, vmi_solution *s)
{
    const vm_two ln_c = vmi_log(c), ln2 = vmi_log(2);
    const vm_two w = vmi_two_sum(ln2.hi, -ln_c.hi);
    const vm_real w_lo = w.lo + (ln2.lo - ln_c.lo);
    vm_real L = 2 * w.hi + 2 * vmi_log(2 * w.hi + 3).hi + 1, step = 1;
    vm_two sum = vmi_two(L, 0);
    int i;
    for (i = 0; i < 9 && VM_FABS(step) > VMI_SMALL_STEP; i++) {
        const vm_real q = vmi_exp(-L, 0), q2 = q * q, x = q2 * (1 + q2 * q2);
        const vm_two ln_L = vmi_log(L), r = vmi_two_sum(L / 2 - w.hi, -ln_L.hi);
        step = (r.hi + (r.lo - w_lo - ln_L.lo - 2 * vmi_small_log(x))) /
               (VM_C(0.5) - 1 / L + 4 * q2 * (1 + 3 * q2 * q2) / (1 + x));
        sum = vmi_two_sum(L, -step);
        L = sum.hi;
    }
    s->L = sum.hi;
    s->L_lo = sum.lo;
}

/* The parameter with k'K = c > 0, or with K = c: k'K of m is K of m/(m - 1), whose complement is 1/(1 - m). From
   c = 1000 on 1 - m is 0 or infinite in double precision, in single precision before. */
VM_API vmi_solution vmi_solve_parameter(vm_real c, int inverse_of_K)
{
    const vm_real least = VM_C(1.311028777146059905232), most = VM_C(1.854074677301371918434); /* K(-1), K(1/2) */
    vmi_solution s;
    if (c > 1000) c = 1000;
    s.circular = c >= least && c <= most;
    s.upside = (c > most) != inverse_of_K;
    s.q = s.L = s.L_lo = 0;
    if (s.circular) s.q = inverse_of_K ? -vmi_solve_middle(c) : vmi_solve_middle(c);
    else {
        if (c > most) vmi_solve_high(c, &s);
        else vmi_solve_low(c, &s);
        s.q = vmi_exp(-s.L, -s.L_lo);
    }
    return s;
}

/* 1 - m; 16 q and 1/(16 q) as exponentials, since q may underflow where they do not */
VM_API vm_real vmi_solution_m1(const vmi_solution *s)
{
    const vm_two ln2 = vmi_log(2);
    vm_real ratio;
    vm_two sum;
    ratio = 1 - s->q * vmi_theta_loss(s->q);
    if (s->circular) return 1 - 16 * s->q * ratio;
    sum = vmi_two_sum(4 * ln2.hi, -s->L);
    sum = vmi_fast_two_sum(sum.hi, sum.lo + (4 * ln2.lo - s->L_lo));
    return s->upside ? vmi_exp(-sum.hi, -sum.lo) / ratio : vmi_exp(sum.hi, sum.lo) * ratio;
}

VM_API vm_real vmi_solution_m(const vmi_solution *s)
{
    if (s->circular) return 16 * s->q * (1 - s->q * vmi_theta_loss(s->q));
    return 1 - vmi_solution_m1(s);
}

/* The modulus solver: the one m (or m1) with k'K(k^2) = c, for any c >= 0; m < 0 for c > pi/2. */
VM_API vm_real jacobi_solve_kpK(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return 1;
    s = vmi_solve_parameter(c, 0);
    return vmi_solution_m(&s);
}

/* Documented with jacobi_solve_kpK. */
VM_API vm_real jacobi_solve_kpK_m1(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return 0;
    s = vmi_solve_parameter(c, 0);
    return vmi_solution_m1(&s);
}

/* Documented with jacobi_solve_K. */
VM_API vm_real jacobi_solve_K_m1(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return VM_INFINITY;
    s = vmi_solve_parameter(c, 1);
    return vmi_solution_m1(&s);
}

/* The inverse of K: the one m (or m1) with K(m) = c, for any c >= 0; m < 0 for c < pi/2. */
VM_API vm_real jacobi_solve_K(vm_real c)
{
    vmi_solution s;
    if (!(c > 0) || !VM_IS_FINITE(c)) return 1 - jacobi_solve_K_m1(c);
    s = vmi_solve_parameter(c, 1);
    return vmi_solution_m(&s);
}

#endif
