/* oscillators/gauss_rule.h - Gauss' rule of n points on [0, 1], and polynomials through values at these points

   The points are called nodes. The rule integrates polynomials of degree 2n - 1 exactly. Two matrices belong to the
   rule. Both are for polynomials of degree n - 1. The first matrix turns the values of a polynomial at the nodes into
   the integrals of the polynomial from 0 to each node. The second matrix turns the same values into the derivatives of
   the polynomial at the nodes. The method of collocation (oscillators/collocation.h) solves differential equations with
   these matrices.
       vmi_gauss_rule rule;
       vmi_gauss_rule_init(&rule, 8);
   Tests: tests/test_collocation.c. */
#ifndef VARMASS_OSCILLATORS_GAUSS_RULE_H
#define VARMASS_OSCILLATORS_GAUSS_RULE_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "legendre.h"

/* The largest number n of nodes */
enum { VMI_NODES = VMI_GAUSS };

/* Gauss' rule, and the two matrices `integral` and `derivative`. Polynomial j in the comments of these two fields has
   degree n - 1; it is 1 at node j and 0 at all other nodes. */
typedef struct VM_TAG(vmi_gauss_rule) {
    int n;      /* number of nodes */
    int graded; /* 1 after vmi_gauss_rule_grade, else 0 */
    vm_real place[VMI_NODES]; /* the nodes x; they differ from node[] only in a graded rule */
    vm_real node[VMI_NODES], weight[VMI_NODES];
    vm_real integral[VMI_NODES + 1][VMI_NODES]; /* [i][j]: integral of polynomial j from 0 to node i; to 1 if i is n */
    vm_real derivative[VMI_NODES][VMI_NODES]; /* [i][j]: derivative of polynomial j at node i */
} vmi_gauss_rule;

/* Returns Legendre's polynomial P_n(x), and writes its derivative to *slope. */
VM_API vm_real vmi_legendre_polynomial(int n, vm_real x, vm_real *slope)
{
    vm_real before = 0, now = 1;
    int k;
    for (k = 0; k < n; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        before = now;
        now = next;
    }
    *slope = (vm_real)n * (x * now - before) / (x * x - 1);
    return now;
}

/* Computes nodes and weights. Newton's method finds the nodes, which are zeros of Legendre's polynomial, from an
   approximation by cosines. */
VM_API void vmi_gauss_rule_nodes(vmi_gauss_rule *rule)
{
    const int rounds = 6;
    int i, j;
    for (i = 0; i < rule->n; i++) {
        vm_real x, sine, slope = 1;
        vmi_sincos(VM_PI * ((vm_real)i + VM_C(0.75)) / ((vm_real)rule->n + VM_C(0.5)), &sine, &x);
        for (j = 0; j < rounds; j++) {
            const vm_real value = vmi_legendre_polynomial(rule->n, x, &slope);
            x -= value / slope;
        }
        vmi_legendre_polynomial(rule->n, x, &slope);
        rule->node[i] = (1 - x) / 2;
        rule->weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* Adds the part of Legendre's polynomial P_k to both matrices of the rule. `values` contains P_k at the nodes,
   `integrals` the integrals of P_k from 0 to the nodes, and `derivatives` the derivatives of P_k at the nodes.
   Integrals and derivatives are taken with respect to the variable that goes from 0 to 1. */
VM_API void vmi_gauss_rule_add(vmi_gauss_rule *rule, int k, const vm_real *values, const vm_real *integrals,
                               const vm_real *derivatives)
{
    int i, j;
    for (j = 0; j < rule->n; j++) {
        const vm_real share = (vm_real)(2 * k + 1) * rule->weight[j] * values[j];
        for (i = 0; i < rule->n; i++) {
            rule->integral[i][j] += share * integrals[i];
            rule->derivative[i][j] += share * derivatives[i];
        }
    }
}

/* Computes the rule of n points, 2 <= n <= VMI_NODES. */
VM_API void vmi_gauss_rule_init(vmi_gauss_rule *rule, int n)
{
    vm_real before[VMI_NODES], now[VMI_NODES], slope_before[VMI_NODES], slope[VMI_NODES];
    vm_real integrals[VMI_NODES], derivatives[VMI_NODES];
    int i, j, k;
    rule->n = n;
    rule->graded = 0;
    vmi_gauss_rule_nodes(rule);
    for (i = 0; i < n; i++) {
        rule->place[i] = rule->node[i];
        before[i] = 0;
        now[i] = 1;
        slope_before[i] = 0;
        slope[i] = 0;
        for (j = 0; j < n; j++) {
            rule->integral[i][j] = 0;
            rule->derivative[i][j] = 0;
        }
    }
    for (j = 0; j < n; j++) rule->integral[n][j] = rule->weight[j];
    for (k = 0; k < n; k++) { /* with x = 2 node - 1, integrals are 1/2 of those over x, derivatives twice those by x */
        for (i = 0; i < n; i++) {
            const vm_real x = 2 * rule->node[i] - 1, next = vmi_legendre_next(k, x, now[i], before[i]);
            integrals[i] = k == 0 ? rule->node[i] : (next - before[i]) / (vm_real)(2 * (2 * k + 1));
            derivatives[i] = 2 * slope[i];
        }
        vmi_gauss_rule_add(rule, k, now, integrals, derivatives);
        for (i = 0; i < n; i++) { /* derivatives: P'_(k+1) = P'_(k-1) + (2k+1) P_k */
            const vm_real x = 2 * rule->node[i] - 1, next = vmi_legendre_next(k, x, now[i], before[i]);
            const vm_real next_slope = slope_before[i] + (vm_real)(2 * k + 1) * now[i];
            slope_before[i] = slope[i];
            slope[i] = next_slope;
            before[i] = now[i];
            now[i] = next;
        }
    }
}

/* The point z = x^2 (3 - 2x) of a graded rule, which replaces the point x of the rule */
VM_API vm_real vmi_graded(vm_real x) { return x * x * (3 - 2 * x); }

/* Changes the rule so that it suits functions of z on [0, 1] that have singularities at the ends, such as fractional
   powers. The polynomials of the rule become polynomials in x, where z = x^2 (3 - 2x). As a function of x such a power
   is twice as high, so that the error falls faster when n grows. */
VM_API void vmi_gauss_rule_grade(vmi_gauss_rule *rule)
{
    const int n = rule->n;
    int i, j;
    rule->graded = 1;
    for (j = 0; j < n; j++) {
        const vm_real x = rule->place[j], slope = 6 * x * (1 - x); /* dz/dx */
        rule->node[j] = vmi_graded(x);
        rule->weight[j] *= slope;
        for (i = 0; i <= n; i++) rule->integral[i][j] *= slope;
        for (i = 0; i < n; i++) rule->derivative[j][i] /= slope;
    }
}

#endif
