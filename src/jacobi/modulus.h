/* jacobi/modulus.h - the parameter m for a given quarter period

   The functions solve K(m) = c and k' K(m) = c for m, where K(m) is the quarter period and k' = sqrt(1 - m). The second
   equation is (307); its solution belongs to the Jacobi function whose period is that of a strongly nonlinear
   oscillator. Each equation has one solution for every c > 0. The nome of a parameter m is q = exp(-pi K(1 - m)/K(m)).

       vm_real m = jacobi_solve_kpK(VM_C(1.2)); // sqrt(1 - m) K(m) = 1.2

   Method: for c between K(-1) and K(1/2) a fixed-point iteration finds the nome of m or of m/(m - 1); for other c
   Newton's method finds the logarithm of the nome of 1 - m or 1/(1 - m). Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_MODULUS_H
#define VARMASS_JACOBI_MODULUS_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* Returns (1 - R)/q for |q| <= 0.1 without loss of digits for small q. The number R is defined by m = 16 q R, where m
   is the parameter with the nome q; with theta functions R = (theta_2(q)/(2 q^(1/4) theta_3(q)))^4. Method: for the
   number b = R^(1/4) = (1 + q^2 + q^6 + q^12)/theta_3 the quotient (1 - b)/q is
   (2 - q + 2 q^3 - q^5 + 2 q^8 - q^11)/theta_3. */
VM_API vm_real vmi_theta_loss(vm_real q)
{
    const vm_real y = q * q, y2 = y * y, theta3 = 1 + 2 * (q + y2 * (1 + y2 * q));
    const vm_real rho = (2 - q + q * y * (2 - y) + y2 * y2 * (2 - q * y)) / theta3, b = 1 - q * rho;
    return rho * ((1 + b) * (1 + b * b));
}

/* A parameter m, which is given by a nome q */
typedef struct VM_TAG(vmi_solution) {
    int circular;        /* 1 if q is the nome of m, else 0 */
    int upside;          /* used if circular is 0: 0 if q is the nome of 1 - m, 1 if q is the nome of 1/(1 - m) */
    vm_real q, L, L_lo;  /* the nome q, which is exp(-L - L_lo) if circular is 0 */
} vmi_solution;

/* Returns the nome q with theta_4(q)^2 = 2 c/pi, for c between K(-1) and K(1/2). The parameter whose nome is q solves
   k' K = c, and the parameter whose nome is -q solves K = c. The method solves q - q^4 + q^9 = (1 - theta_4(q))/2 for q
   by a fixed-point iteration. */
VM_API vm_real vmi_solve_middle(vm_real c)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real less = ((half_pi.hi - c) + half_pi.mid) / half_pi.hi; /* less = 1 - theta_4(q)^2 */
    const vm_real start = less / (2 * (1 + VM_SQRT(1 - less)));         /* (1 - theta_4(q))/2 */
    vm_real q = start;
    int i;
    for (i = 0; i < 6; i++) /* each step gains about 3 digits of q */
        q = start + vmi_fourth_power(q) * (1 - vmi_fourth_power(q) * q);
    return q;
}

/* Newton's method ends with the first step that is not longer than this number, since the error is then below eps. */
#define VMI_SMALL_STEP (VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(2e-5))

/* Finds s->L = -ln q for c >= K(1/2) from L theta_3(q)^2/2 = c. The left side is K(m) if q is the nome of 1 - m, and k'
   K(m) if q is the nome of 1/(1 - m). The unknown of Newton's method is lambda = 2c - L = 2c (1 - theta_3^-2), which
   lies between 0 and 0.57. The method starts at lambda = 0 and needs at most seven steps. */
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

/* Returns ln(1 + x) for 0 <= x < 0.0019, by the power series of the logarithm. */
VM_API vm_real vmi_small_log(vm_real x)
{
    return x - x * x * (VM_C(0.5) - x * (VM_C(0.3333333333333333333) - x * (VM_C(0.25) - x * VM_C(0.2))));
}

/* Finds s->L = -ln q for 0 < c <= K(-1) from 2 L sqrt(q) (1 + q^2 + q^6)^2 = c. The left side is k' K(m) if q is the
   nome of 1 - m, and K(m) if q is the nome of 1/(1 - m). Newton's method solves
     L/2 - ln L - 2 ln(1 + q^2 + q^6) = ln(2/c),
   whose left side is a convex, rising function of L. The method starts above the solution and needs at most seven
   steps. The difference of the two sides is computed in two words. */
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

/* Returns the solution m of K(m) = c if inverse_of_K is 1, and of k' K(m) = c if inverse_of_K is 0, for c > 0. One
   method is enough for both equations, since k' K(m) is K(m/(m - 1)). For c > 1000 the result is that of c = 1000:
   there 1 - m underflows to 0 or overflows (in float for much smaller c too). */
VM_API vmi_solution vmi_solve_parameter(vm_real c, int inverse_of_K)
{
    const vm_real least = VM_C(1.311028777146059905232), most = VM_C(1.854074677301371918434); /* K(-1) and K(1/2) */
    vmi_solution s;
    if (c > 1000) c = 1000;
    s.circular = c >= least && c <= most;
    s.upside = (c > most) != inverse_of_K;
    s.q = s.L = s.L_lo = 0;
    if (s.circular) {
        s.q = vmi_solve_middle(c);
        if (inverse_of_K) s.q = -s.q;
    } else {
        if (c > most) vmi_solve_high(c, &s);
        else vmi_solve_low(c, &s);
        s.q = vmi_exp(-s.L, -s.L_lo);
    }
    return s;
}

/* Returns 1 - m of the solution. 16 q is computed as exp(ln 16 - L), and 1/(16 q) as exp(L - ln 16), since q may
   underflow where 16 q does not. */
VM_API vm_real vmi_solution_m1(const vmi_solution *s)
{
    const vm_two ln2 = vmi_log(2);
    vm_real ratio;
    vm_two sum;
    ratio = 1 - s->q * vmi_theta_loss(s->q);
    if (s->circular) return 1 - 16 * s->q * ratio;
    sum = vmi_two_sum(4 * ln2.hi, -s->L);
    sum = vmi_fast_two_sum(sum.hi, sum.lo + (4 * ln2.lo - s->L_lo));
    if (s->upside) return vmi_exp(-sum.hi, -sum.lo) / ratio;
    return vmi_exp(sum.hi, sum.lo) * ratio;
}

/* Returns the parameter m of the solution. */
VM_API vm_real vmi_solution_m(const vmi_solution *s)
{
    if (s->circular) return 16 * s->q * (1 - s->q * vmi_theta_loss(s->q));
    return 1 - vmi_solution_m1(s);
}

/* The parameter m for which k' K(m) = c, the solution of equation (307), for c >= 0. m is negative for c > pi/2, and 1
   for c = 0. The error is at most 4 ulp plus the change of m that one ulp of c makes. Returns NaN for c < 0 and
   infinite c. */
VM_API vm_real jacobi_solve_kpK(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return 1;
    s = vmi_solve_parameter(c, 0);
    return vmi_solution_m(&s);
}

/* Solves k' K(m) = c as jacobi_solve_kpK does, but returns 1 - m with all its digits. The error is at most 4 ulp plus
   the change of 1 - m that one ulp of c makes. Returns NaN for c < 0 and infinite c. */
VM_API vm_real jacobi_solve_kpK_m1(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return 0;
    s = vmi_solve_parameter(c, 0);
    return vmi_solution_m1(&s);
}

/* Solves K(m) = c as jacobi_solve_K does, but returns 1 - m with all its digits. Returns infinity for c = 0, and NaN
   for c < 0 and infinite c. */
VM_API vm_real jacobi_solve_K_m1(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return VM_INFINITY;
    s = vmi_solve_parameter(c, 1);
    return vmi_solution_m1(&s);
}

/* The parameter m whose quarter period K(m) is c, for c >= 0: the inverse of jacobi_K. m is negative for c < pi/2, and
   -infinity for c = 0. The error is at most 4 ulp plus the change of m that one ulp of c makes. Returns NaN for c < 0
   and infinite c. */
VM_API vm_real jacobi_solve_K(vm_real c)
{
    vmi_solution s;
    if (!(c > 0) || !VM_IS_FINITE(c)) return 1 - jacobi_solve_K_m1(c);
    s = vmi_solve_parameter(c, 1);
    return vmi_solution_m(&s);
}

#endif
