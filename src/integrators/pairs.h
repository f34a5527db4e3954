/* integrators/pairs.h - the descriptor of a Runge-Kutta pair, and code that the stages of all pairs use
   A pair of orders p and p - 1 makes a step of size h from y at t in stages, each of which evaluates f once:

       k_i = f(t + c_i h, y + h (a_i1 k_1 + a_i2 k_2 + ...)),    y_new = y + h (b_1 k_1 + b_2 k_2 + ...),

   where c_i, a_ij and b_i are the coefficients of the pair. Another sum of the k_i estimates the error. For each pair
   there is a file with its public functions, its coefficients and its descriptor: rk45.h, rk87.h. The descriptor, a
   vmi_rk_pair, contains all that an adaptive run needs to know of the pair. To add a pair, write such a file and
   include it in src/integrators.h.

   Tests: tests/gen/order_conditions.py, every order condition; tests/test_adaptive.c, measured orders. */
#ifndef VARMASS_INTEGRATORS_PAIRS_H
#define VARMASS_INTEGRATORS_PAIRS_H

#include "../base/real.h"
#include "ode.h"
#include "options.h"

struct VM_TAG(rk45);

/* Indices of the parts of a run's work array. Each part has n numbers: VMI_Y is the state y, VMI_Y_OLD the state at
   t_old, VMI_Z the state at which a stage evaluates f. After the last stage, VMI_Z is the new state. VMI_K is k_1; the
   parts k_2, k_3 ... follow. */
enum { VMI_Y, VMI_Y_OLD, VMI_Z, VMI_K };

/* The n equations y' = f(t, y) that a step solves, and the array w in which the step stores its numbers. The part of w
   with the index p, such as VMI_Y, begins at w + p m, where m >= n. ctx is the pointer that f receives. */
typedef struct VM_TAG(vmi_rk_system) {
    ode_rhs f;
    void *ctx;
    int n;
    vm_real *w;
    ptrdiff_t m;
} vmi_rk_system;

/* The data and functions of a Runge-Kutta pair that a run uses. k_i is the value of f in stage i of a step from t to
   t + h. */
typedef struct VM_TAG(vmi_rk_pair) {
    int method;           /* the number of the pair, VMI_RK45 or VMI_RK87 */
    int order;            /* the order of the state after a step; the order of the error estimate is one less */
    int stages;           /* number of evaluations of f for the new state and the error estimate */
    int last_is_first;    /* 1: the last stage evaluates f at the new state (k_1 of the next step); 0: it does not */
    int derivatives;      /* number of all k_i of a step: stages, f at its end, stages of the continuous extension */
    int rounding;         /* bound of a step's relative rounding error, in units of VM_EPSILON; it is the least rtol */
    vm_real keep_from;    /* the step size may stay the same after an error above this fraction of the tolerance */
    vm_real stiff_beyond; /* the run looks stiff if h times the largest eigenvalue of f's Jacobian exceeds this */
    /* For the test of stiffness, which compares two states at the end t + h of a step. With rk45 these are the states
       of the last two stages; with rk87 they are the new state and the state of the last stage. The difference of the
       two states is h times a weighted sum of k_1, k_2 ...; the function returns the weight of k_{j+1}. */
    vm_real (*end_difference)(int j);
    /* Computes the state y at the fraction x of the step by the continuous extension, y_old + h (b_1 k_1 + ...), whose
       weights b_j depend on x */
    void (*inside)(const struct VM_TAG(rk45) * s, vm_real x, vm_real *y);
    /* NULL, or the function that evaluates the k_i of the continuous extension alone. Returns a status. */
    int (*extend)(struct VM_TAG(rk45) * s);
} vmi_rk_pair;

/* The functions of a pair that the loop over the steps calls. vmi_run gets this struct as a constant, so that the
   compiler inlines make_stages and step_error into the loop. The two functions are not fields of vmi_rk_pair, because
   each run stores a vmi_rk_pair: for a stored pointer to a function, the compiler would have to compile the function
   once more, outside the loop. */
typedef struct VM_TAG(vmi_rk_stepper) {
    vmi_rk_pair pair;
    /* Computes stages 2, 3 ... of a step from t to t_new = t + h, after which the part VMI_Z of work is the new state.
       Adds the number of evaluations of f to *evals. Returns 0, or the number with which f has stopped the run. */
    int (*make_stages)(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals);
    /* Returns the largest ratio of the error of a component to its tolerance in a step of size h, at most VMI_WORST, or
       NaN if the error or the new state is not finite. */
    vm_real (*step_error)(const rk45_options *o, vmi_rk_system sys, vm_real h);
} vmi_rk_stepper;

#define VMI_MOST_OWN 14 /* the largest number of k_i in a step of any pair, without those of the continuous extension */

/* The keywords for the functions that return descriptors and for the parts of vmi_advance. These functions are inlined
   even where VM_INLINE does not inline. This makes the code smaller, since the descriptors become constants and each
   part is called in one place only. */
#if defined(__GNUC__) && !defined(__CUDACC__) && defined(__OPTIMIZE__)
#define VMI_FOLDED static inline __attribute__((always_inline))
#else
#define VMI_FOLDED VM_INLINE
#endif

/* The keywords for the loop over the steps of one pair. The loop is inlined, because this makes it fast. If the
   compiler optimises for size, the loop is not inlined, so that the program has only one copy of it, for every n. */
#ifdef __OPTIMIZE_SIZE__
#define VMI_LOOP VMI_APART
#else
#define VMI_LOOP VM_INLINE
#endif

/* Returns the index of the part of work that contains f at the end of a step. */
VMI_FOLDED int vmi_last_k(const vmi_rk_pair *pair) { return VMI_K + pair->stages - pair->last_is_first; }

/* Returns the least rtol that a run by this pair accepts. */
VMI_FOLDED vm_real vmi_least_rtol(const vmi_rk_pair *pair) { return (vm_real)pair->rounding * VM_EPSILON; }

/* Macros for the stages of a pair. VMI_H is h times a coefficient. VMI_EVAL evaluates k = f(t, y) and counts it; if f
   stops the run, it returns from the function that makes the stages. In every sum the latest k is the last term, and
   its coefficient is multiplied by h first. So only one multiplication and one addition come between one evaluation of
   f and the next. (In stage 8 of rk87, k_7 is in an earlier term, too.) */
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
#define VMI_WORST VM_C(1e4) /* if a ratio of an error to its tolerance is larger than this, it is set to this */

/* Takes the error e of component i into account; the component is y before the step and z after it. *worst becomes the
   largest ratio of an error to its tolerance so far. *bad becomes NaN if e or z is not finite, since infinity minus
   infinity is NaN. */
VM_INLINE void vmi_weigh(const rk45_options *o, int i, vm_real e, vm_real y, vm_real z, vm_real *worst, vm_real *bad)
{
    const vm_real ratio = VM_FABS(e) / vmi_tolerance(o, i, VMI_LARGER(VM_FABS(y), VM_FABS(z)));
    const vm_real sum = e + z;
    *worst = VMI_LARGER(ratio, *worst);
    *bad += sum - sum;
}

#endif
