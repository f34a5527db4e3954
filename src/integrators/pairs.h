/* integrators/pairs.h - what a Runge-Kutta pair is: a descriptor, and what the stages of all pairs share
   A pair of orders p and p - 1 makes a step of size h from y at t in stages, each of which evaluates f once:

       k_i = f(t + c_i h, y + h (a_i1 k_1 + a_i2 k_2 + ...)),    y_new = y + h (b_1 k_1 + b_2 k_2 + ...),

   and estimates the error by another sum of the k_i. A file for each pair has its coefficients and its descriptor, a
   vmi_rk_pair, with all that an adaptive run needs to know of it, and its public functions: rk45.h, rk87.h. To
   add a pair, write such a file and include it in src/integrators.h.

   Tests: tests/gen/order_conditions.py, every order condition; tests/test_adaptive.c, measured orders. */
#ifndef VARMASS_INTEGRATORS_PAIRS_H
#define VARMASS_INTEGRATORS_PAIRS_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"
#include "options.h"

struct VM_TAG(rk45);

/* The parts of a run's work, of n numbers each: y, y at t_old, an argument of f, and the derivatives k_1, k_2 ... */
enum { VMI_Y, VMI_Y_OLD, VMI_Z, VMI_K };

/* The equations that a step solves, and its parts of work: part p begins at w + p m, and m >= n. */
typedef struct VM_TAG(vmi_rk_system) {
    ode_rhs f;
    void *ctx;
    int n;
    vm_real *w;
    ptrdiff_t m;
} vmi_rk_system;

/* What a run needs to know of its pair */
typedef struct VM_TAG(vmi_rk_pair) {
    int method;           /* the number of the pair: VMI_RK45 ... */
    int order;            /* of the state after a step. That of the error estimate is one less. */
    int stages;           /* evaluations of f that make the new state and the error estimate */
    int last_is_first;    /* 1: the last stage is f at the new state, the next step's k_1; 0: that is evaluated apart */
    int derivatives;      /* all k_i of a step: stages, f at its end, and those of the continuous extension alone */
    int rounding;         /* bound of the rounding within a step, relative to y, in eps: the smallest rtol */
    vm_real keep_from;    /* after a step whose error is above this part of the tolerance the size may stay */
    vm_real stiff_beyond; /* the run looks stiff where |h lambda| is larger, about the end of the stability region */
    /* The weight of k_{j+1} in the difference, over h, of the last two states for which f is evaluated at t + h */
    vm_real (*end_difference)(int j);
    /* The continuous extension: y(t_old + x h) = y_old + h (b_1 k_1 + b_2 k_2 + ...), 0 <= x <= 1, by vmi_weigh_inside
       with weights b_j that depend on x */
    void (*inside)(const struct VM_TAG(rk45) * s, vm_real x, vm_real *y);
    /* NULL, or what evaluates the k_i that only the continuous extension needs. Returns a status. */
    int (*extend)(struct VM_TAG(rk45) * s);
} vmi_rk_pair;

/* A pair as the loop over the steps takes it. It is a constant of the call, and so the compiler inlines both functions
   into the loop. They are no part of vmi_rk_pair, which each run holds: there they would be compiled a second time. */
typedef struct VM_TAG(vmi_rk_stepper) {
    vmi_rk_pair pair;
    /* Stages 2, 3 ... of a step from t to t_new = t + h: part VMI_Z becomes the new state. Returns what f returns. */
    int (*make_stages)(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals);
    /* The largest error of a component over its tolerance; NaN where anything is not finite */
    vm_real (*step_error)(const rk45_options *o, vmi_rk_system sys, vm_real h);
} vmi_rk_stepper;

#define VMI_MOST_OWN 14 /* the most k_i that a step of any pair makes, without those of the continuous extension */

/* Linkage of descriptors and of the parts of vmi_advance. Inlining makes the descriptors constants, and each part is
   called in one place only. So the code becomes smaller too, and they are inlined even where VM_INLINE, for the sake of
   size, does not inline. */
#if defined(__GNUC__) && !defined(__CUDACC__) && defined(__OPTIMIZE__)
#define VMI_FOLDED static inline __attribute__((always_inline))
#else
#define VMI_FOLDED VM_INLINE
#endif

/* Linkage of the loop over the steps of one pair. It is inlined where it is to be fast, and never where it is to be
   short: there one copy for any n is enough. */
#ifdef __OPTIMIZE_SIZE__
#define VMI_LOOP VMI_APART
#else
#define VMI_LOOP VM_INLINE
#endif

/* The part of work with f at the end of a step */
VMI_FOLDED int vmi_last_k(const vmi_rk_pair *pair) { return VMI_K + pair->stages - pair->last_is_first; }

/* The smallest rtol */
VMI_FOLDED vm_real vmi_least_rtol(const vmi_rk_pair *pair) { return (vm_real)pair->rounding * VM_EPSILON; }

/* In the stages of a pair: h times a coefficient, and an evaluation of f. h is folded into the coefficients and the
   newest k comes last in every sum, so that the chain from one evaluation of f to the next is a multiplication and an
   addition long. */
#define VMI_H(c) (h * VM_C(c))
#define VMI_EVAL(t, y, k)                \
    do {                                 \
        int stop_;                       \
        ++*evals;                        \
        stop_ = sys.f(t, y, k, sys.ctx); \
        if (stop_) return stop_;         \
    } while (0)

#define VMI_LARGER(a, b) ((a) > (b) ? (a) : (b))
#define VMI_SMALLER(a, b) ((a) < (b) ? (a) : (b))
#define VMI_WORST VM_C(1e4) /* larger errors, in tolerances, count as this one */

/* Takes up an error e of component i, whose state goes from y to z: *worst becomes the largest error over its
   tolerance so far, and *bad becomes NaN if e or z is not finite, since x - x is 0 or NaN. */
VM_INLINE void vmi_weigh(const rk45_options *o, int i, vm_real e, vm_real y, vm_real z, vm_real *worst, vm_real *bad)
{
    const vm_real ratio = VM_FABS(e) / vmi_tolerance(o, i, VMI_LARGER(VM_FABS(y), VM_FABS(z)));
    const vm_real sum = e + z;
    *worst = VMI_LARGER(ratio, *worst);
    *bad += sum - sum;
}

#endif
