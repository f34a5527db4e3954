/* integrators.h - ordinary differential equations y' = f(t, y) by explicit Runge-Kutta methods

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include "integrators.h"
       static int spring(double t, const double *y, double *dydt, void *ctx)
       {
           (void)t;   // which this spring does not need
           (void)ctx;
           dydt[0] = y[1];
           dydt[1] = -y[0] * y[0] * y[0];
           return 0;
       }
       int main(void)
       {
           double y0[2] = {1, 0}, work[RK45_WORK(2)];
           rk45 s;
           rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work);
           return rk45_solve(&s, 10.0) < 0; // the result is in s.y, at s.t
       }

   METHODS, and when to take which method
     rk4    the classical method of order 4 with fixed steps: for control loops, where every step must take the same
            time. rk4_solve_compensated keeps the roundings of millions of steps from adding up.
     rk45   Tsitouras' pair of orders 5 and 4 [1] chooses its steps to keep a tolerance: six evaluations of f in a step,
            and none for the solution between steps. Begin with this method. It is also the best one in float,
            for an f that is not smooth, for loose tolerances, for many events and for output at many times.
     rk87   Verner's pair of orders 8 and 7 [4]: 13 evaluations of f in a step, and seven more if the solution inside
            the step is asked for. It is the fastest for a smooth f in double. Its rounding errors are larger than those
            of rk45: rtol is at least 256 eps, which is too coarse for most uses in float.
     None of these methods is meant for stiff equations, which need an implicit method; rk45 and rk87 report an equation
     that looks stiff (ODE_STIFF). docs/cost.md has the time that each method takes for an error.

   CONVENTIONS
     The right-hand side f gets t, the n numbers y, room for the n derivatives, and the caller's pointer ctx. It returns
     0, or any other number to stop the run. t may run backward. All times and steps have the unit of t.
     The caller owns the memory: work has RK4_WORK(n), RK45_WORK(n) or RK87_WORK(n) numbers and must live as long as the
     rk45 does. An rk45, its work and its events hold the whole state of a run. An rk87 is an rk45 that rk87_init made;
     the functions of rk45 refuse it, and those of rk87 refuse an rk45 that rk45_init made.

   STEP SIZE CONTROL
     A step gives two results, by the two orders of the pair. Their difference is the estimate of the error; the run
     goes on with the result of the higher order. A step is accepted when |error_i| <= atol + rtol max(|y_i|, |y_i after
     the step|) for every component i. The size of the next step is chosen by PI control. It stays the same after an
     error of 0.25 to 0.75 of the tolerance (rk87: 0.1 to 0.75).
     The tolerance is for each step; the error at the end of a run is larger, in proportion to its length.
     A zero in rk45_options means the default, and a negative tolerance counts as 0. rk45_defaults() fills in the
     defaults.
     No step is shorter than h_min, or than 2 eps |t|, which is what t can resolve. If even a step of this smallest size
     misses the tolerance, the run assumes a jump of f: it accepts the step, counts it in s.missed, and goes on after
     the jump. If another such step misses the tolerance before three steps have kept it, f is singular there, or too
     stiff for the resolution of t, and the run ends with ODE_STEP_TOO_SMALL. If the two steps follow each other
     directly, in one call of rk45_solve without events, both are dropped: s.t and s.y are then those before both steps.

   TIME
     A step ends at a time that the type can hold, and its length is exactly the difference of the two times. So s.t
     does not drift away from the motion, however far from 0 the run began and however many steps it takes. There are
     two exceptions: a step so short that this would change its length by more than 1/64, and a step that ends at an
     event. Then y belongs to a time between two numbers of the type, s.t is the nearest of them, and the run keeps the
     difference.

   EVENTS
     An event happens when g(t, y) reaches zero or changes its sign. The run finds its time on the continuous extension,
     and then records it, ends there, or restarts there (ODE_RECORD, ODE_STOP, ODE_RESTART). Every event happens once,
     also if several lie in one step, at its end or at the same instant, and after rk45_restart.
     Events whose times rounding cannot tell apart happen together: all are counted, and their `change` functions are
     called in the order of the list, before the run stops or goes on. After a stop s.y is on the far side of the zero,
     or on it. If g stays 0 for a while, the event happens when g reaches 0, not when it leaves 0. If g jumps, the event
     happens at the jump. After an event the sign of g counts again as soon as rounding cannot have caused it, so that a
     motion that is reversed on contact does not touch twice.
     Two zeros, or any even number of them, between two evaluations of g are not found. A larger `checks` or a smaller
     h_max makes evaluations more frequent.

   RIGHT-HAND SIDES THAT ARE NOT SMOOTH
     The step size control finds the places where f is not smooth and takes some short steps there. No error estimate is
     right in a step in which f jumps: the error at the end may be thousands of tolerances, so run again with a tighter
     tolerance and compare. If f has smooth branches, such as those of a sign or of |x|, keep the branch in ctx and
     change it at an ODE_RESTART event: the run then needs far fewer evaluations, and its error is small again. This
     helps only if f does not choose its branch itself. docs/toronto.md has errors and evaluations on the Toronto test
     set, whose class F has jumps.

   STATUS
     0 (ODE_OK) is success; positive numbers are information, negative ones errors; ode_strerror() gives the text. After
     an error s.t and s.y are those of the last accepted step, also if f itself stopped the run (the value that f
     returned is in s.rhs_status). Where f or the state is not finite, the step is shortened until it is too small, so
     that a run ends next to the point where f ceases to exist. A call that refuses its arguments changes nothing.

   SPEED
     The compiler inlines f and keeps the state in registers if f is static, n <= 8 is a constant, and one function
     calls rk45_init, tests its status, and calls rk45_solve. Where the compiler cannot see which f and n belong to s,
     call rk45_solve_with, which gets them as arguments once more. Otherwise f is called through a pointer, and the
     state is in work.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If it is defined as VM_API,
                          the code is smaller and the results are the same.
     VM_SQRT, VM_FABS     the functions of the C library that are used; define these two and VM_FLOOR and
                          VM_COPYSIGN, or none of the four
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; both or none. Default: static const
                          and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables take no RAM
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, although the checks for NaN do not work then
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for zero.
     vm_self_check() returns 0 in these cases, and 1 where all is well; a program may call it once when it starts.

   REFERENCES
     [1] Ch. Tsitouras, Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption,
         Computers & Mathematics with Applications 62 (2011) 770-775.
     [2] E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993:
         II.4 (first step, step size control), II.6 (continuous extensions); E. Hairer, G. Wanner, volume II, 1996:
         IV.2 (PI control, stiffness).
     [3] E. Hairer, R. I. McLachlan, A. Razakarivony, Achieving Brouwer's law with implicit Runge-Kutta methods,
         BIT 48 (2008) 231-243 (compensated summation).
     [4] J. H. Verner, Numerically optimal Runge-Kutta pairs with interpolants, Numerical Algorithms 53 (2010)
         383-396: the "most efficient" pair of orders 8 and 7. tests/gen/order_conditions.py checks every order
         condition of all coefficients here.

   INDEX
     base/self_check: whether this compiler and this processor compute as varmass needs
       vm_self_check                  Returns 1 if the compiler and the processor compute as varmass needs, else 0

     integrators/ode: ordinary differential equations y' = f(t, y): right-hand sides and statuses
       ode_strerror                   Text that describes a status of the integrators

     integrators/rk4: rk4: the classical Runge-Kutta method of order 4 with fixed steps
       rk4_step                       One step of size h, positive or negative, by the classical Runge-Kutta method
       rk4_solve                      Equal steps from *t to t_end, `steps` of them, by the classical Runge-Kutta method
       rk4_solve_compensated          Equal steps with compensated summation [3], so that roundings do not add up */
#ifndef VARMASS_INTEGRATORS_H
#define VARMASS_INTEGRATORS_H

/* base/real.h - the number type, the macros that a user may set, the functions of the C library

   All other files are built on this one. It chooses vm_real (double, or float where VM_USE_FLOAT is defined), gives
   each macro that the user has not set its default, refuses compilers whose options change the values of results, and
   names the four functions of the C library that are used: sqrt, fabs, floor, copysign.

       vm_real x = VM_C(0.1); // the number 0.1 as a vm_real, in double and in float

   Tests: tests/test_headers.sh, tests/test_options.sh. */
#ifndef VARMASS_BASE_REAL_H
#define VARMASS_BASE_REAL_H

#define VARMASS_VERSION "0.1.0"

#if defined(__STRICT_ANSI__) && !defined(__cplusplus) && (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L)
#error "varmass is C99 or C++11: compile with -std=c99 or later"
#endif

#include <float.h>
#include <math.h>
#include <stddef.h>

#if !defined(VM_ALLOW_FAST_MATH) &&                                                                                 \
    (defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                      \
     defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) ||                  \
     defined(_M_FP_FAST) || defined(__ARM_FP_FAST))
#error "-ffast-math or a part of it (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, \
-ffinite-math-only, -fno-signed-zeros, /fp:fast) changes results; VM_ALLOW_FAST_MATH compiles anyway"
#endif

#ifndef VM_API
#define VM_API static inline /* linkage of every function; CUDA, for example, needs static inline __host__ __device__ */
#if !defined(VM_INLINE) && defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define VM_INLINE static inline __attribute__((always_inline)) /* linkage of functions that are fast only if inlined */
#endif
#endif
#ifndef VM_INLINE
#define VM_INLINE VM_API /* slower than with inlining, with the same results */
#endif

#ifdef VM_USE_FLOAT
typedef float vm_real;
#define VM_C(x) x##f            /* the constant x as a vm_real */
#define VM_LIBM(name) name##f   /* the function of the C library for a vm_real */
#define VM_TAG(tag) tag##_float /* the tag of a struct, one for each precision: a C++ program can use both */
#define VM_EPSILON FLT_EPSILON
#define VM_MAX FLT_MAX
#define VM_MIN FLT_MIN /* the smallest normal number */
#define VM_MANT_DIG FLT_MANT_DIG
#ifdef FP_FAST_FMAF
#define VM_FAST_FMA
#endif
#else
typedef double vm_real;
#define VM_C(x) x
#define VM_LIBM(name) name
#define VM_TAG(tag) tag
#define VM_EPSILON DBL_EPSILON
#define VM_MAX DBL_MAX
#define VM_MIN DBL_MIN
#define VM_MANT_DIG DBL_MANT_DIG /* digits; 24 where double is as short as float (AVR). Table lengths depend on it. */
#ifdef FP_FAST_FMA
#define VM_FAST_FMA
#endif
#endif

/* -fsingle-precision-constant makes constants shorter than vm_real. This array then has -1 elements, which is an
   error. */
typedef char vmi_constants_are_vm_real[sizeof(VM_C(1.0)) == sizeof(vm_real) ? 1 : -1];

#if defined(VM_TABLE) != defined(VM_READ)
#error "define both VM_TABLE and VM_READ, or neither: VM_READ(x) reads x, an element of a table, e.g. as (x)"
#elif !defined(VM_TABLE) && defined(__AVR__) && defined(__GNUC__) && VM_MANT_DIG == 24
#include <avr/pgmspace.h>
#define VM_TABLE static const PROGMEM /* tables stay in flash, which an ordinary read cannot reach */
#define VM_READ(x) pgm_read_float(&(x))
#elif !defined(VM_TABLE)
#define VM_TABLE static const /* storage of every table */
#define VM_READ(x) (x)        /* reads x, an element of a table, which is always written as table[i] or table[i][j] */
#endif

#ifndef VM_SQRT /* To use another library, define all four macros. The casts keep C++ from choosing a template. */
#define VM_SQRT(x) VM_LIBM(sqrt)((vm_real)(x))
#define VM_FABS(x) VM_LIBM(fabs)((vm_real)(x))
#define VM_FLOOR(x) VM_LIBM(floor)((vm_real)(x))
#if defined(__GNUC__) && !defined(__clang__) && defined(__thumb2__) && defined(__SOFTFP__)
#define VM_COPYSIGN(x, y) vmi_copysign(x, y) /* for this processor gcc compiles "x = copysign(x, y)" to x = y */
#else
#define VM_COPYSIGN(x, y) VM_LIBM(copysign)((vm_real)(x), (vm_real)(y))
#endif
#endif

#define VM_NAN ((vm_real)NAN)
#define VM_INFINITY ((vm_real)INFINITY)
#define VM_IS_FINITE(x) ((x) - (x) == 0)
#define VM_PI VM_C(3.141592653589793238463)

/* Returns |x| with the sign of y, which may be -0. */
VM_API vm_real vmi_copysign(vm_real x, vm_real y)
{
    const int negative = y < 0 || (y == 0 && 1 / y < 0);
    x = VM_FABS(x);
    if (negative) x = -x;
    return x;
}

/* The larger and the smaller of two numbers. Both functions return b if a or b is NaN. */
VM_INLINE vm_real vmi_larger(vm_real a, vm_real b) { return a > b ? a : b; }
VM_INLINE vm_real vmi_smaller(vm_real a, vm_real b) { return a < b ? a : b; }

/* Linkage of functions that are rarely called from a fast loop and would slow it down if they were inlined into it */
#if defined(__GNUC__) && !defined(__CUDACC__)
#define VMI_APART static __attribute__((noinline, unused))
#else
#define VMI_APART VM_API
#endif

#endif
/* base/sums.h - sums without rounding error, numbers in two words

   A sum of two numbers of type vm_real is rounded. The functions here return the rounded sum (hi) and its rounding
   error (lo), so that hi + lo is the exact sum. Such a pair, vm_two, holds a number with twice the digits.

       vm_two s = vmi_two_sum(1, VM_C(1e-20)); // s.hi = 1, s.lo = 1e-20

   Tests: tests/test_jacobi.c, tests/test_headers.sh. */
#ifndef VARMASS_BASE_SUMS_H
#define VARMASS_BASE_SUMS_H

/* The number hi + lo, where |lo| is at most half an ulp of hi */
typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two;

/* Returns x rounded to the type vm_real. x87 units compute with more digits, and gcc in its gnu modes keeps the
   additional digits in variables. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2)
VM_API vm_real vmi_rounded(vm_real x)
{
    volatile vm_real stored = x;
    return stored;
}
#else
#define vmi_rounded(x) (x)
#endif

/* Returns the exact sum a + b as a pair (by Knuth). */
VM_API vm_two vmi_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    vm_real b_part;
    s.hi = vmi_rounded(a + b);
    b_part = vmi_rounded(s.hi - a);
    s.lo = vmi_rounded((a - (s.hi - b_part)) + (b - b_part));
    return s;
}

/* Returns the exact sum a + b as a pair, for |a| >= |b| (by Dekker). */
VM_API vm_two vmi_fast_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    s.hi = vmi_rounded(a + b);
    s.lo = vmi_rounded((a - s.hi) + b);
    return s;
}

/* Makes a pair from its words hi and lo, which are not changed. */
VM_API vm_two vmi_two(vm_real hi, vm_real lo)
{
    vm_two x;
    x.hi = hi;
    x.lo = lo;
    return x;
}

#endif
/* base/self_check.h - whether this compiler and this processor compute as varmass needs

   Some options of compilers and some modes of processors change the results of floating-point arithmetic. Where a
   macro of the compiler shows such an option, the headers do not compile. vm_self_check() finds the others when the
   program runs: it computes a few numbers whose results show whether sums keep their order, whether results are
   rounded to the nearest number, and whether NaN, infinity, -0 and subnormal numbers exist.

       int trustworthy = vm_self_check(); // once, when the program starts

   Tests: tests/test_options.sh. */
#ifndef VARMASS_BASE_SELF_CHECK_H
#define VARMASS_BASE_SELF_CHECK_H

/* Returns 1 if sums are computed in the order in which they are written, as arithmetic in two words needs, and if a
   product is rounded when 0 is added to it. eps is VM_EPSILON; split is VM_SPLIT, the factor that splits a number into
   two halves. */
VM_API int vmi_keeps_order(vm_real one, vm_real eps, vm_real split)
{
    const vm_real above = one + eps, third = one / 3;
    const vm_two sum = vmi_two_sum(one, eps / 4), other = vmi_two_sum(eps / 4, -one);
    const vm_real hi = vmi_rounded(third + eps), lo = (third - hi) + eps; /* Dekker's sum of third and eps */
    const vm_real scaled = vmi_rounded(split * above + 0), rest = vmi_rounded(scaled - above), head = scaled - rest;
    const vm_real to_integer = VM_C(1.5) / eps, shifted = vmi_rounded(third + to_integer);
    const vm_real product = vmi_rounded(third * above + 0);
    volatile vm_real stored = third * above;
    return sum.hi == one && sum.lo == eps / 4 && other.hi == -one && other.lo == eps / 4 && (hi - third) + lo == eps &&
           head == one && above - head == eps && shifted - to_integer == 0 && product - stored == 0;
}

/* Returns 1 if quotients and square roots are rounded to the nearest number. A compiler that multiplies by a reciprocal
   instead of dividing gets 1 - eps/2 instead of 1 for some of the quotients tested here. */
VM_API int vmi_divides(vm_real one)
{
    const vm_real root_of_2 = VM_C(1.4142135623730950488);
    volatile vm_real numbers[4] = {41, 47, 49, 55};
    int i, right = numbers[0] / 41 == 1 && numbers[1] / 47 == 1 && numbers[2] / 49 == 1 && numbers[3] / 55 == 1;
    for (i = 0; i < 4; i++) {
        const vm_real divisor = numbers[i], same = numbers[i];
        right &= one / divisor > 0 && same / divisor == 1 && 3 * same / divisor == 3 && 7 * same / divisor == 7;
    }
    return right && VM_SQRT(49 * one) == 7 && vmi_rounded(VM_SQRT(2 * one)) == root_of_2 && VM_FLOOR(-one / 2) == -1;
}

/* Returns 1 if sums next to 1 are rounded to the nearest number and do not keep more digits than vm_real has. A sum in
   the middle between two numbers must be rounded to the even number. */
VM_API int vmi_rounds(vm_real one, vm_real eps)
{
    const vm_real below = one + eps / 4, middle = one + eps / 2, above = one + eps * VM_C(0.75);
    const vm_real minus_below = -one - eps / 4, minus_above = -one - eps * VM_C(0.75);
    return below - one == 0 && middle - one == 0 && above - one == eps && minus_below + one == 0 &&
           minus_above + one == -eps;
}

/* Returns 1 if NaN, infinity, -0 and the subnormal numbers below VM_MIN exist and compare as they should. */
VM_API int vmi_has_all_numbers(vm_real zero, vm_real infinity, vm_real smallest)
{
    const vm_real nan = infinity - infinity, minus_zero = -zero, subnormal = smallest / 8;
    const int nan_compares = (nan < 1) | (nan >= 1);
    return nan != nan && !nan_compares && !VM_IS_FINITE(nan) && !VM_IS_FINITE(infinity) &&
           1 / minus_zero < 0 && 1 / (minus_zero + 0) > 0 && VM_COPYSIGN(1, minus_zero) == -1 && subnormal > 0 &&
           subnormal * 8 == smallest;
}

/* Returns 1 if the compiler and the processor compute as varmass needs, else 0. If it returns 0, results are wrong.
   This happens, for example, with options of clang that its macros do not show, with another rounding mode, or where
   the processor takes subnormal numbers for zero. Call it once, when the program starts. */
VM_API int vm_self_check(void)
{
    volatile vm_real zero = 0, one = 1, eps = VM_EPSILON, infinity = VM_INFINITY, smallest = VM_MIN;
    volatile vm_real split = VM_MANT_DIG > 24 ? VM_C(134217729.0) : VM_C(4097.0);
    return vmi_keeps_order(one, eps, split) && vmi_divides(one) && vmi_rounds(one, eps) &&
           vmi_has_all_numbers(zero, infinity, smallest);
}

#endif
/* base/arrays.h - loops over arrays of numbers
   vmi_all_finite tests whether all numbers of an array are finite, and vmi_copy copies an array. The macro VMI_EACH
   writes a loop over the n components of a state. Where the compiler knows a small n, it unrolls such loops and keeps
   the components in registers.

       vm_real y[3] = {1, 2, 3}, z[3];
       if (vmi_all_finite(3, y)) vmi_copy(3, y, z);

   Tests: tests/test_rk4.c and the other tests of the integrators. */
#ifndef VARMASS_BASE_ARRAYS_H
#define VARMASS_BASE_ARRAYS_H

/* Returns 1 if all n numbers are finite, and 0 if one of them is infinite or NaN. */
VM_API int vmi_all_finite(int n, const vm_real *y)
{
    int i;
    for (i = 0; i < n; i++)
        if (!VM_IS_FINITE(y[i])) return 0;
    return 1;
}

/* `VMI_EACH(i, n) statement` executes the statement for i = 0 ... n - 1. gcc unrolls this loop where it knows n. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) && __GNUC__ >= 8 && defined(__OPTIMIZE__) && \
    !defined(__OPTIMIZE_SIZE__)
#define VMI_UNROLL _Pragma("GCC unroll 16")
#else
#define VMI_UNROLL
#endif
#define VMI_EACH(i, n) VMI_UNROLL for (i = 0; i < (n); i++)

/* VMI_IS_SMALL(n) is 1 where the compiler knows n and n <= VMI_SMALL. An integrator then keeps a state of n
   components in local arrays; otherwise it keeps the state in the caller's array `work`. */
#define VMI_SMALL 8
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define VMI_IS_SMALL(n) (__builtin_constant_p(n) && (n) <= VMI_SMALL)
#else
#define VMI_IS_SMALL(n) 0
#endif

/* Copies n numbers. The arrays `from` and `to` must not overlap, but they may be one and the same array. */
VM_INLINE void vmi_copy(int n, const vm_real *from, vm_real *to)
{
    int i;
    VMI_EACH(i, n) to[i] = from[i];
}

#endif
/* integrators/ode.h - ordinary differential equations y' = f(t, y): right-hand sides and statuses
   This file has the type of every right-hand side f, and the statuses of the functions rk4_..., rk45_... and rk87_...

       #include "integrators.h"
       static int spring(double t, const double *y, double *dydt, void *ctx) // x'' = -x as y = (x, x')
       {
           (void)t;
           (void)ctx;
           dydt[0] = y[1];
           dydt[1] = -y[0];
           return 0;
       }
       int main(void)
       {
           double y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
           return rk4_solve(spring, NULL, 2, &t, 10.0, 1000, y, work); // 1000 steps from t = 0 to 10
       }

   Tests: tests/test_rk4.c, tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_ODE_H
#define VARMASS_INTEGRATORS_ODE_H

enum {
    ODE_OK = 0,          /* success */
    ODE_RTOL_RAISED = 1, /* rk45_init has raised rtol to 16 eps, or rk87_init to 256 eps, which is the least */
    ODE_EVENT = 2,       /* an event has ended the run: s->t, s->y are its time and state, s->event is its index */
    ODE_STIFF = 3,       /* t_end was reached, but for a while stability, not accuracy, kept the steps short */
    /* An argument is wrong: n or steps is not positive, a pointer is NULL, a component has no tolerance, h_min is
       negative or above h_max, a time, a state or an option is not finite, a time is outside the last step, an event
       has no g, or the rk45 was made by the init function of another method. */
    ODE_BAD_ARGUMENT = -1,
    ODE_RHS_STOPPED = -2, /* f returned a number other than 0, which is s->rhs_status */
    ODE_NOT_FINITE = -3,  /* f or the state is infinite or NaN even in the shortest step, or an event function is NaN */
    /* Two steps of the smallest size (h_min, or the resolution of t) missed the tolerance, with fewer than three steps
       between them that kept it: f is singular there, or too stiff for the resolution of t. The run also ends so if
       h_max is less than the resolution of t. A jump of f does not end a run: s->missed counts it. */
    ODE_STEP_TOO_SMALL = -4,
    ODE_MAX_STEPS = -5,     /* max_steps attempts did not reach t_end; another call continues the run */
    ODE_WORK_TOO_SMALL = -6 /* the option work_size is less than RK45_WORK(n) or RK87_WORK(n) */
};

/* A function that writes the n derivatives f(t, y) to dydt and returns 0, or any other number to stop the run. ctx is
   the pointer that the caller gave to the integrator. */
typedef int (*ode_rhs)(vm_real t, const vm_real *y, vm_real *dydt, void *ctx);

/* Text that describes a status of the integrators. */
VM_API const char *ode_strerror(int status)
{
    switch (status) {
    case ODE_OK: return "success";
    case ODE_RTOL_RAISED: return "rtol was raised to what the type can hold";
    case ODE_EVENT: return "a terminal event";
    case ODE_STIFF: return "success, but the equations look stiff";
    case ODE_BAD_ARGUMENT: return "bad argument";
    case ODE_RHS_STOPPED: return "the right-hand side stopped the run";
    case ODE_NOT_FINITE: return "the right-hand side, the state or an event function is not finite";
    case ODE_STEP_TOO_SMALL: return "the step size became too small";
    case ODE_MAX_STEPS: return "max_steps was reached";
    case ODE_WORK_TOO_SMALL: return "work is too small: it needs RK45_WORK(n) or RK87_WORK(n) numbers";
    default: return "unknown status";
    }
}

#endif
/* integrators/rk4.h - rk4: the classical Runge-Kutta method of order 4 with fixed steps
   A step takes four evaluations of f, and the error at the end of a run is proportional to h^4. It is the method where
   each step must take the same time, as in a control loop; rk45 needs less time for the same error.

       double y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
       int status = rk4_solve(spring, NULL, 2, &t, 10.0, 1000, y, work); // spring is the ode_rhs of ode.h; 1000 steps

   Tests: tests/test_rk4.c. */
#ifndef VARMASS_INTEGRATORS_RK4_H
#define VARMASS_INTEGRATORS_RK4_H

#define RK4_WORK(n) (3 * (n)) /* number of elements of the work of rk4 with n components */

/* Computes the four stages of a step of size h from the state y at t. sum becomes k_1 + 2 k_2 + 2 k_3, and k becomes
   k_4; z holds the argument of f. Returns 0, or the number with which f has stopped the run. */
VM_INLINE int vmi_rk4_stages(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, const vm_real *y, vm_real *k,
                             vm_real *sum, vm_real *z)
{
    int i, stopped = f(t, y, k, ctx);
    if (stopped) return stopped;
    VMI_EACH(i, n) {
        sum[i] = k[i];
        z[i] = y[i] + h / 2 * k[i];
    }
    stopped = f(t + h / 2, z, k, ctx);
    if (stopped) return stopped;
    VMI_EACH(i, n) {
        sum[i] += 2 * k[i];
        z[i] = y[i] + h / 2 * k[i];
    }
    stopped = f(t + h / 2, z, k, ctx);
    if (stopped) return stopped;
    VMI_EACH(i, n) {
        sum[i] += 2 * k[i];
        z[i] = y[i] + h * k[i];
    }
    return f(t + h, z, k, ctx);
}

/* Makes `steps` steps of size h from *t. The state is y, or y + low_or_NULL with compensated summation. w is a work
   array of 3 m numbers, m >= n. y and *t become those at the end of the last complete step. Returns a status. */
VM_INLINE int vmi_rk4_run(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y,
                          vm_real *low_or_NULL, vm_real *w, ptrdiff_t m)
{
    const vm_real t0 = *t, h_6 = h / 6;
    vm_real *k = w, *sum = w + m, *z = w + 2 * m;
    long step;
    int i, status = ODE_OK;
    for (step = 0; step < steps; step++) {
        vm_real bad = 0; /* becomes NaN if a component of z is not finite */
        if (vmi_rk4_stages(f, ctx, n, t0 + (vm_real)step * h, h, y, k, sum, z)) {
            status = ODE_RHS_STOPPED;
            break;
        }
        VMI_EACH(i, n)
        {
            if (low_or_NULL) {
                sum[i] = (h_6 * sum[i] + h_6 * k[i]) + low_or_NULL[i];
                z[i] = y[i] + sum[i];
            } else {
                z[i] = (y[i] + h_6 * sum[i]) + h_6 * k[i];
            }
            bad += z[i] - z[i];
        }
        if (bad != 0) {
            status = ODE_NOT_FINITE;
            break;
        }
        if (low_or_NULL) VMI_EACH(i, n) low_or_NULL[i] = vmi_two_sum(y[i], sum[i]).lo;
        vmi_copy(n, z, y);
    }
    *t = t0 + (vm_real)step * h;
    return status;
}

/* Does the work of vmi_rk4_run in local arrays, which the compiler keeps in registers if it knows that n is small */
VM_INLINE int vmi_rk4_run_small(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y,
                                vm_real *low_or_NULL)
{
    vm_real w[3 * VMI_SMALL], y_here[VMI_SMALL], low_here[VMI_SMALL];
    vm_real *low_here_or_NULL = low_or_NULL ? low_here : NULL;
    int status;
    vmi_copy(n, y, y_here);
    if (low_or_NULL) vmi_copy(n, low_or_NULL, low_here);
    status = vmi_rk4_run(f, ctx, n, t, h, steps, y_here, low_here_or_NULL, w, n);
    vmi_copy(n, y_here, y);
    if (low_or_NULL) vmi_copy(n, low_here, low_or_NULL);
    return status;
}

/* Checks the arguments of an rk4 function and makes the steps. Returns a status. */
VM_INLINE int vmi_rk4(ode_rhs f, void *ctx, int n, vm_real *t, vm_real h, long steps, vm_real *y, vm_real *low_or_NULL,
                      vm_real *work)
{
    if (!f || n <= 0 || !y || !work || !VM_IS_FINITE(*t) || !VM_IS_FINITE(h)) return ODE_BAD_ARGUMENT;
    if (VMI_IS_SMALL(n)) return vmi_rk4_run_small(f, ctx, n, t, h, steps, y, low_or_NULL);
    return vmi_rk4_run(f, ctx, n, t, h, steps, y, low_or_NULL, work, n);
}

/* Does the work of rk4_solve and of rk4_solve_compensated */
VM_INLINE int vmi_rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                            vm_real *low_or_NULL, vm_real *work)
{
    int status;
    if (!t || steps <= 0 || !VM_IS_FINITE(t_end)) return ODE_BAD_ARGUMENT;
    status = vmi_rk4(f, ctx, n, t, (t_end - *t) / (vm_real)steps, steps, y, low_or_NULL, work);
    if (status == ODE_OK) *t = t_end;
    return status;
}

/* One step of size h, positive or negative, by the classical Runge-Kutta method. y has n numbers; it is the state at
   time t and becomes the state at t + h. f receives the pointer ctx; work has RK4_WORK(n) numbers. Returns ODE_OK, or,
   with y unchanged, ODE_BAD_ARGUMENT, ODE_RHS_STOPPED or ODE_NOT_FINITE. */
VM_INLINE int rk4_step(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, vm_real *y, vm_real *work)
{
    return vmi_rk4(f, ctx, n, &t, h, 1, y, NULL, work);
}

/* Equal steps from *t to t_end, `steps` of them, by the classical Runge-Kutta method. y has n numbers and becomes the
   state at t_end; *t becomes t_end exactly. If f stops the run or the state is not finite, y and *t are those at the
   end of the last complete step. Returns the statuses of rk4_step. */
VM_INLINE int rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                        vm_real *work)
{
    return vmi_rk4_solve(f, ctx, n, t, t_end, steps, y, NULL, work);
}

/* Equal steps with compensated summation [3], so that roundings do not add up. The steps are those of rk4_solve, but
   the state is y + y_low. y_low has n numbers, which the caller sets to zero before the first call. The summation is
   worth its time when there are millions of steps. */
VM_INLINE int rk4_solve_compensated(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                                    vm_real *y_low, vm_real *work)
{
    if (!y_low) return ODE_BAD_ARGUMENT;
    return vmi_rk4_solve(f, ctx, n, t, t_end, steps, y, y_low, work);
}

#endif

#endif
