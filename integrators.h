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
     rk4    the classical method of order 4 with fixed steps, for control loops, where every step must take the same
            time. In rk4_solve_compensated the rounding errors of millions of steps do not add up.
     rk45   Tsitouras' pair of orders 5 and 4 [1] chooses the size of its steps so that the error stays within a
            tolerance. A step takes six evaluations of f; the solution inside a step takes no further evaluation. Begin
            with this method. It is also the best one in float, for an f that is not smooth, for loose tolerances, for
            many events and for output at many times.
     rk87   Verner's pair of orders 8 and 7 [4]. A step takes 13 evaluations of f, and seven more if the run has events
            or the caller asks for the solution inside the step. It is the fastest for a smooth f in double. Its
            rounding errors are larger than those of rk45: rtol is at least 256 eps (eps is 2.2e-16, in float 1.2e-7),
            which is too coarse for most uses in float.
     None of these methods is meant for stiff equations, in which stability and not accuracy limits the step size; these
     need an implicit method. rk45 and rk87 report an equation that looks stiff (ODE_STIFF). docs/cost.md has the time
     that each method needs for a given error.

   CONVENTIONS
     The right-hand side f gets t, the n numbers y, room for the n derivatives, and the caller's pointer ctx. It returns
     0, or any other number to stop the run. t may run backward. All times and steps have the unit of t.
     The caller owns the memory: work has RK4_WORK(n), RK45_WORK(n) or RK87_WORK(n) numbers and must live as long as the
     rk45 does. An rk45, its work and its events contain the whole state of a run. An rk87 is an rk45 that rk87_init
     made. The functions of rk45 refuse it, and those of rk87 refuse an rk45 that rk45_init made. Only rk45_restart and
     rk87_restart, which do the same, accept both.

   STEP SIZE CONTROL
     A step gives two results, one of each order of the pair. Their difference is the estimate of the error; the run
     goes on with the result of the higher order. A step is accepted when |error_i| <= atol + rtol max(|y_i|, |y_i after
     the step|) for every component i. The size of the next step is chosen by a proportional-integral (PI) control [2]
     from the errors of the last two steps. The step size stays the same after an error of 0.25 to 0.75 of the tolerance
     (rk87: 0.1 to 0.75).
     The tolerance is for each step; the error at the end of a run is larger, in proportion to the length of the run.
     A zero in rk45_options means the default. A negative rtol or atol counts as 0; a negative number in atol_each is an
     error. rk45_defaults() fills in the defaults.
     No step is shorter than h_min, or than 2 eps |t|, the resolution of t, except a step that ends at t_end or at an
     event. If even a step of this smallest size misses the tolerance, the run assumes a jump of f: it accepts the step,
     counts it in s.missed, and goes on after the jump. If another such step misses the tolerance before three steps
     have kept it, the run ends with ODE_STEP_TOO_SMALL: f is then singular there, or too stiff for the resolution of t.
     If the two steps follow each other directly, in one call of rk45_solve without events, both are dropped: s.t and
     s.y are then those before both steps.

   TIME
     A step ends at a time that is a number of the type, and its length is the difference of the times at its two ends,
     rounded to the type (exact for a step shorter than |t|/2). So s.t does not drift away from the motion, however far
     from 0 the run began and however many steps it takes. There are two exceptions: a step so short that rounding the
     time of its end would change its length by more than 1/64, and a step that ends at an event. Then y belongs to a
     time between two numbers of the type, s.t is the nearer of them, and the run stores the difference.

   EVENTS
     An event happens when g(t, y) reaches zero or changes its sign. The run finds the time of the event on the
     continuous extension, a polynomial that gives the state anywhere inside a step. It then records the event
     (ODE_RECORD), ends there (ODE_STOP), or restarts there (ODE_RESTART). Every event is found exactly once, even if
     several events lie in one step, at its end or at the same instant, and after rk45_restart too.
     Events whose times differ by no more than rounding errors happen together: all are counted, and their `change`
     functions are called in the order of the list, before the run stops or goes on. After a stop, g(s.t, s.y) of an
     event that happened alone is 0 or already has its new sign; of several that happened together, this is certain for
     one. If g stays 0 for a while, the event happens when g reaches 0, not when it leaves 0. If g jumps, the event
     happens at the jump. After an event the sign of g is ignored as long as rounding errors alone could cause it. So
     one contact of a body that bounces off the ground is one event.
     A run ends at each event with the action ODE_STOP. An event with stop_after > 0 is different: whatever its action
     is, it ends the run only when it has happened stop_after times, twice as many times, and so on. The t_end of such a
     run may be infinite. Set h_max in this case if the solution is so smooth that the steps would grow without end.
     Two zeros, or any even number of them, between two evaluations of g are not found. A larger `checks` or a smaller
     h_max makes evaluations more frequent.

   OUTPUT AND SAVED RUNS
     rk45_solve_at and rk87_solve_at fill a table with the states at listed times, without shortening the steps.
     rk45_save and rk87_save write a run to an array of bytes; rk45_resume and rk87_resume continue it. The results have
     the same bits as those of a run without interruption.

   RIGHT-HAND SIDES THAT ARE NOT SMOOTH
     The step size control finds the places where f is not smooth and takes some short steps there. No error estimate is
     right in a step in which f jumps: the error at the end may be thousands of tolerances, so run again with a tighter
     tolerance and compare. If f consists of smooth branches, such as those of a sign or of |x|, store the present
     branch in ctx and change it at an ODE_RESTART event: the run then needs far fewer evaluations, and its error is
     small again. For this, f must take the branch from ctx and must not choose it itself. docs/toronto.md has the
     errors and the numbers of evaluations of f for the Toronto test set of equations; the equations of its class F have
     jumps.

   STATUS
     0 (ODE_OK) is success; positive numbers are information, negative ones errors; ode_strerror() gives the text. After
     an error s.t and s.y are those of the last accepted step, also if f itself stopped the run (the value that f
     returned is in s.rhs_status). Where f or the state is not finite, the run tries shorter and shorter steps until
     they are too small. So it ends close to the last point at which f is finite. A call with wrong arguments changes
     nothing.

   SPEED
     The compiler inlines f and keeps the state in registers if f is static, n <= 8 is a constant, and one function
     calls rk45_init, tests its status, and calls rk45_solve. Where the compiler cannot see which f and n belong to s,
     call rk45_solve_with, which gets them as arguments once more. Otherwise f is called through a pointer, and the
     state is in work.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double (tests run both)
     VM_API               linkage of the functions; the default is static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If it is defined as VM_API,
                          the code is smaller and the results are the same.
     VM_FABS, VM_COPYSIGN the functions of the C library that are used; vm_self_check() also uses VM_SQRT and VM_FLOOR.
                          Define all four or none.
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. The defaults
                          are static const and (x); on AVR they are static const PROGMEM and pgm_read_float(&(x)), so
                          that tables take no RAM
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but the checks for NaN do not work
                          then
     VM_MIXED_PRECISIONS  allows a program in which some files define VM_USE_FLOAT and others do not. Without it gcc and
                          MSVC, and clang for Windows, refuse to link such a program.
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. But clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor treats subnormal numbers, the
     smallest of all, as zero. vm_self_check() returns 0 in these cases, and 1 where all is well; a program may call it
     once when it starts.

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
     base/self_check: a test of whether this compiler and this processor compute as varmass needs
       vm_self_check                  Returns 1 if the compiler and the processor compute as varmass needs, else 0

     integrators/ode: ordinary differential equations y' = f(t, y): right-hand sides and statuses
       ode_strerror                   Text that describes a status of the integrators

     integrators/rk4: rk4: the classical Runge-Kutta method of order 4 with fixed steps
       rk4_step                       Makes one step of size h, positive or negative, by the classical Runge-Kutta method
       rk4_solve                      Makes `steps` equal steps from *t to t_end by the classical Runge-Kutta method
       rk4_solve_compensated          Makes equal steps with compensated summation [3], so that rounding errors do not add up

     integrators/rk45: rk45: adaptive runs by a Runge-Kutta pair of orders 5 and 4
       rk45_defaults                  Returns the options of rk45 as rk45_init uses them
       rk45_init                      Begins a run of y' = f(t, y) by rk45 from state y0 at time t0
       rk45_restart                   Continues a run of rk45 from another time or state, such as after a jump
       rk45_step                      Makes one accepted step of rk45, or the part of it before an event that ends the step
       rk45_solve_with                Makes steps of rk45 to t_end
       rk45_solve                     Makes steps of rk45 to t_end exactly, forward or backward, or to an event that ends the run
       rk45_interpolate               Computes the state y(t) at a time t within the last step of rk45, accurate to order 4

     integrators/rk87: rk87: adaptive runs by a Runge-Kutta pair of orders 8 and 7
       rk87_init                      Begins a run of y' = f(t, y) by rk87, as rk45_init begins one by rk45
       rk87_restart                   Continues a run of rk87 from another time or state, such as after a jump
       rk87_step                      Makes one accepted step of rk87, or the part of it before an event that ends the step
       rk87_solve_with                Makes steps of rk87 to t_end
       rk87_solve                     Makes steps of rk87 to t_end exactly, forward or backward, or to an event that ends the run
       rk87_interpolate               Computes the state y(t) at a time t within the last step of rk87, accurate to order 8

     integrators/output: the solution at listed times
       rk45_solve_at                  Continues a run of rk45 to the last of n_times times and writes the state at each of them to a row of n numbers
       rk87_solve_at                  Continues a run of rk87 to the last of n_times times and writes the state at each of them to a row of n numbers

     integrators/saved: runs that are saved as bytes and resumed later
       rk45_save                      Saves a run of rk45 between two calls as bytes
       rk45_resume                    Copies the numbers of a saved run of rk45 into s, which rk45_init has made with the f, n, options and events of the saved run
       rk87_save                      Saves a run of rk87 as bytes
       rk87_resume                    Copies the numbers of a saved run of rk87 into s, which rk87_init has made */
#ifndef VARMASS_INTEGRATORS_H
#define VARMASS_INTEGRATORS_H

/* base/real.h - the number type, the macros that a user may set, the functions of the C library

   All other files include this one. It defines vm_real (double, or float where VM_USE_FLOAT is defined) and gives a
   default to each macro that the user has not set. It stops the compiler with an error if a compiler option changes the
   results, and the linker if a program has files in float and in double. It names the functions of the C library that
   the kit uses: sqrt, fabs, floor, copysign, and fma where FP_FAST_FMA says that it is fast.

       vm_real x = VM_C(0.1); // the number 0.1 as a vm_real, in double and in float

   Tests: tests/test_headers.sh, tests/test_options.sh. */
#ifndef VARMASS_BASE_REAL_H
#define VARMASS_BASE_REAL_H

#define VARMASS_VERSION "0.2.0"

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
#define VM_INLINE VM_API /* the code is slower than with forced inlining, but the results are the same */
#endif

/* Between VMI_QUIET_BEGIN and VMI_QUIET_END the compiler does not warn of code that is written so on purpose, such as
   casts that C and C++ both accept and comparisons with exact numbers. A project that turns these warnings on gets them
   for its own files only. */
#if defined(__GNUC__) && !defined(__CUDACC__)
#define VMI_IGNORE(warning) VMI_PRAGMA(GCC diagnostic ignored warning)
#define VMI_PRAGMA(text) _Pragma(#text)
#if defined(__clang__)
#define VMI_QUIET_MORE                                                                                              \
    VMI_IGNORE("-Wunknown-warning-option") VMI_IGNORE("-Wold-style-cast") VMI_IGNORE("-Wused-but-marked-unused")     \
    VMI_IGNORE("-Wconditional-uninitialized") VMI_IGNORE("-Wzero-as-null-pointer-constant")                         \
    VMI_IGNORE("-Wdeclaration-after-statement") VMI_IGNORE("-Wbad-function-cast") VMI_IGNORE("-Wuseless-cast")       \
    VMI_IGNORE("-Wunsafe-buffer-usage")
#elif defined(__cplusplus)
#define VMI_QUIET_MORE                                                                                              \
    VMI_IGNORE("-Wold-style-cast") VMI_IGNORE("-Wuseless-cast") VMI_IGNORE("-Wzero-as-null-pointer-constant")
#else
#define VMI_QUIET_MORE                                                                                              \
    VMI_IGNORE("-Wdeclaration-after-statement") VMI_IGNORE("-Wbad-function-cast")                                    \
    VMI_IGNORE("-Wunsuffixed-float-constants")
#endif
#define VMI_QUIET_BEGIN                                                                                             \
    VMI_PRAGMA(GCC diagnostic push) VMI_QUIET_MORE VMI_IGNORE("-Wfloat-equal") VMI_IGNORE("-Wcast-qual")             \
    VMI_IGNORE("-Wpadded") VMI_IGNORE("-Wstrict-overflow")
#define VMI_QUIET_END VMI_PRAGMA(GCC diagnostic pop)
#else
#define VMI_QUIET_BEGIN
#define VMI_QUIET_END
#endif

#ifdef __cplusplus
#define VMI_CAST(type, x) static_cast<type>(x)
#else
#define VMI_CAST(type, x) ((type)(x))
#endif

#ifdef VM_USE_FLOAT
typedef float vm_real;
#define VM_C(x) x##f            /* the constant x as a vm_real */
#define VM_LIBM(name) name##f   /* the name of the C library's function for a vm_real */
#define VM_TAG(tag) tag##_float /* the tag of a struct, one for each precision: a C++ program can use both */
#define VM_EPSILON FLT_EPSILON
#define VM_MAX FLT_MAX
#define VM_MIN FLT_MIN /* the smallest normal number */
#define VM_MANT_DIG FLT_MANT_DIG
#define VM_NAN NAN
#define VM_INFINITY INFINITY
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
#define VM_MANT_DIG DBL_MANT_DIG /* bits; 24 where double is as short as float (AVR). Table lengths depend on it. */
#define VM_NAN VMI_CAST(double, NAN)
#define VM_INFINITY VMI_CAST(double, INFINITY)
#ifdef FP_FAST_FMA
#define VM_FAST_FMA
#endif
#endif

/* A struct in float and the same struct in double differ in size. A linker of C programs does not notice if a file in
   float passes such a struct to a file in double. Therefore each file marks its precision here, and the linker refuses
   files of both precisions, unless all files of one precision define VM_MIXED_PRECISIONS. With gcc the mark is a symbol
   whose value must be equal in all files. With clang there is no mark: -flto would refuse equal values too. */
#if defined(VM_MIXED_PRECISIONS) || defined(__CUDACC__)
#elif defined(_MSC_VER)
#ifdef VM_USE_FLOAT
#pragma detect_mismatch("varmass in float and in double: see VM_MIXED_PRECISIONS", "float")
#else
#pragma detect_mismatch("varmass in float and in double: see VM_MIXED_PRECISIONS", "double")
#endif
#elif defined(__GNUC__) && !defined(__clang__) && (defined(__ELF__) || defined(__MINGW32__))
#define VMI_MARK "varmass_in_float_and_in_double__see_VM_MIXED_PRECISIONS"
#ifdef VM_USE_FLOAT
#define VMI_MARKED "4"
#else
#define VMI_MARKED "8"
#endif
#ifdef __ELF__
#define VMI_HIDDEN ".hidden " VMI_MARK "\n"
#else
#define VMI_HIDDEN
#endif
__asm__(".globl " VMI_MARK "\n" VMI_HIDDEN ".ifdef " VMI_MARK "\n.if " VMI_MARK " - " VMI_MARKED "\n.error \"" VMI_MARK
        "\"\n.endif\n.else\n.set " VMI_MARK ", " VMI_MARKED "\n.endif");
#endif

VMI_QUIET_BEGIN

/* -fsingle-precision-constant makes constants shorter than vm_real. This array then has -1 elements, an error. */
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

/* Linkage of functions that a fast loop calls rarely and that would slow down the loop if they were inlined into it */
#if defined(__GNUC__) && !defined(__CUDACC__)
#define VMI_APART static __attribute__((noinline, unused))
#else
#define VMI_APART VM_API
#endif

VMI_QUIET_END

#endif

VMI_QUIET_BEGIN

/* base/sums.h - sums without rounding error, numbers in two words

   A sum of two numbers of type vm_real is rounded. The functions here return the rounded sum (hi) and its rounding
   error (lo), so that hi + lo is the exact sum. Such a pair, a vm_two, is a number in two words: it has twice the
   digits of a vm_real.

       vm_two s = vmi_two_sum(1, VM_C(1e-20)); // s.hi = 1, s.lo = 1e-20

   Tests: tests/test_jacobi.c, tests/test_headers.sh. */
#ifndef VARMASS_BASE_SUMS_H
#define VARMASS_BASE_SUMS_H

/* The number hi + lo, where |lo| is at most half an ulp of hi */
typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two;

/* Returns x rounded to the type vm_real. The function is needed where the processor's x87 unit computes with more
   digits and gcc in its gnu modes keeps the additional digits in variables. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2)
VM_API vm_real vmi_rounded(vm_real x)
{
    volatile vm_real stored = x;
    return stored;
}
#else
#define vmi_rounded(x) (x)
#endif

/* Returns the exact sum a + b as a pair, by Knuth's method. */
VM_API vm_two vmi_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    vm_real b_part;
    s.hi = vmi_rounded(a + b);
    b_part = vmi_rounded(s.hi - a);
    s.lo = vmi_rounded((a - (s.hi - b_part)) + (b - b_part));
    return s;
}

/* Returns the exact sum a + b as a pair, for |a| >= |b|, by Dekker's method. */
VM_API vm_two vmi_fast_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    s.hi = vmi_rounded(a + b);
    s.lo = vmi_rounded((a - s.hi) + b);
    return s;
}

/* Returns the pair with the words hi and lo, which are stored as they are. */
VM_API vm_two vmi_two(vm_real hi, vm_real lo)
{
    vm_two x;
    x.hi = hi;
    x.lo = lo;
    return x;
}

#endif
/* base/self_check.h - a test of whether this compiler and this processor compute as varmass needs

   Some options of compilers and some modes of processors change the results of floating-point arithmetic. If a macro of
   the compiler shows such an option, the headers do not compile. vm_self_check() finds the other options and modes when
   the program runs. It computes numbers that show whether sums are computed in the order in which they are written,
   whether results are rounded to the nearest number, and whether NaN, infinity, -0 and subnormal numbers exist.

       int trustworthy = vm_self_check(); // once, when the program starts

   Tests: tests/test_options.sh. */
#ifndef VARMASS_BASE_SELF_CHECK_H
#define VARMASS_BASE_SELF_CHECK_H

/* Returns 1 if sums are computed in the order in which they are written, as arithmetic in two words needs, and if a
   product is rounded when 0 is added to it. `one` must be 1, `eps` VM_EPSILON, and `split` 2^27 + 1 (float 2^12 + 1),
   the factor that splits a number into two halves. The caller reads them from volatile variables, so that the compiler
   cannot know their values. */
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
   the middle between two neighbouring numbers must be rounded to the number whose last bit is 0. */
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

/* Returns 1 if the compiler and the processor compute as varmass needs, else 0. If it returns 0, results of the kit are
   wrong. This happens, for example, with options of clang that its macros do not show, with another rounding mode, or
   where the processor takes subnormal numbers for zero. Call it once, when the program starts. */
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
   writes a loop over the n components of a state. Where the compiler knows that n is small, it unrolls the loop and
   keeps the components in registers.

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

/* `VMI_EACH(i, n) statement` executes the statement for i = 0, 1, ..., n - 1. gcc unrolls the loop where it knows n. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) && __GNUC__ >= 8 && defined(__OPTIMIZE__) && \
    !defined(__OPTIMIZE_SIZE__)
#define VMI_UNROLL _Pragma("GCC unroll 16")
#else
#define VMI_UNROLL
#endif
#define VMI_EACH(i, n) VMI_UNROLL for (i = 0; i < (n); i++)

/* VMI_IS_SMALL(n) is 1 where the compiler knows n and n <= VMI_SMALL, else 0. If it is 1, an integrator keeps a state
   of n components in local arrays, which is faster; if it is 0, it keeps the state in the caller's array `work`. */
#define VMI_SMALL 8
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__CUDACC__)
#define VMI_IS_SMALL(n) (__builtin_constant_p(n) && (n) <= VMI_SMALL)
#else
#define VMI_IS_SMALL(n) 0
#endif

/* Copies n numbers. The arrays `from` and `to` may be one and the same array, but must not overlap in any other way. */
VM_INLINE void vmi_copy(int n, const vm_real *from, vm_real *to)
{
    int i;
    VMI_EACH(i, n) to[i] = from[i];
}

#endif
/* integrators/ode.h - ordinary differential equations y' = f(t, y): right-hand sides and statuses
   This file defines the type of every right-hand side f, and the statuses: the numbers by which the functions rk4_...,
   rk45_... and rk87_... report success or an error.

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
    ODE_RTOL_RAISED = 1, /* the option rtol was too small for the method: rk45_init has raised it to 16 eps, or
                            rk87_init has raised it to 256 eps */
    ODE_EVENT = 2,       /* an event has ended the run: s->t, s->y are its time and state, s->event is its index */
    ODE_STIFF = 3,       /* success, but during this call stability, not the tolerance, came to limit the step size;
                            later calls return ODE_OK, and s->stiff remains 1 */
    /* An argument is wrong: a pointer is NULL, n or `steps` is not positive, or a time, a state (not in rk4), rtol,
       atol or h0 is not finite (t_end may be infinite if an event can end the run). Or an option is wrong: a component
       has no tolerance, an element of atol_each is negative, h_min is negative or above h_max, or an event has no g, a
       negative room or a negative stop_after. Or a time of output is outside the last step, or the listed times are not
       in order. Or a saved run does not fit, or the init function of another method made the rk45. */
    ODE_BAD_ARGUMENT = -1,
    ODE_RHS_STOPPED = -2, /* f returned a number other than 0, which is s->rhs_status */
    ODE_NOT_FINITE = -3,  /* f or the state is infinite or NaN even in the shortest step (rk4: in a step), or an event
                             function is NaN */
    /* The errors of two steps of the smallest size (h_min, or the resolution of t) were above the tolerance, and fewer
       than three steps lay between these two steps. Then f is singular there, or too stiff for the resolution of t. A
       run also ends with this status if h_max is less than the resolution of t, or if t_end is infinite and t reaches
       the largest number of the type. A jump of f does not end a run: s->missed counts it. */
    ODE_STEP_TOO_SMALL = -4,
    ODE_MAX_STEPS = -5,     /* max_steps attempts did not reach t_end; another call continues the run */
    ODE_WORK_TOO_SMALL = -6 /* an array is too short: work needs RK45_WORK(n) or RK87_WORK(n) numbers, a saved run
                               RK45_SAVED or RK87_SAVED bytes */
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
    case ODE_WORK_TOO_SMALL:
        return "an array is too short: work needs RK45_WORK(n) or RK87_WORK(n) numbers, a saved run RK45_SAVED or "
               "RK87_SAVED bytes";
    default: return "unknown status";
    }
}

#endif
/* integrators/rk4.h - rk4: the classical Runge-Kutta method of order 4 with fixed steps
   A step takes four evaluations of f, and the error at the end of a run is proportional to h^4. Use rk4 where each
   step must take the same time, as in a control loop; rk45 needs less time for the same error.

       double y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
       int status = rk4_solve(spring, NULL, 2, &t, 10.0, 1000, y, work); // spring is the ode_rhs of ode.h; 1000 steps

   Tests: tests/test_rk4.c. */
#ifndef VARMASS_INTEGRATORS_RK4_H
#define VARMASS_INTEGRATORS_RK4_H

#define RK4_WORK(n) (3 * (n)) /* number of elements of the array work for n components */

/* Computes the four stages of a step of size h from the state y at t; k_1 ... k_4 are the values of f in these stages.
   The array `sum` becomes k_1 + 2 k_2 + 2 k_3, and the array k becomes k_4. The array z has the state at which f is
   evaluated. Returns 0, or the number with which f has stopped the run. */
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

/* Makes `steps` steps of size h from *t. If low_or_NULL is not NULL, the summation is compensated: the state is then
   the sum of the arrays y and low_or_NULL. w is a work array of 3 m numbers, m >= n. y and *t become the state and the
   time at the end of the last complete step. Returns a status. */
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

/* Makes one step of size h, positive or negative, by the classical Runge-Kutta method. y has n numbers; it is the state
   at time t and becomes the state at t + h. f receives the pointer ctx; work has RK4_WORK(n) numbers. Returns ODE_OK;
   ODE_BAD_ARGUMENT if a pointer other than ctx is NULL, n is not positive, or t or h is not finite; ODE_RHS_STOPPED if
   f returns a number other than 0; ODE_NOT_FINITE if the new state is not finite. After an error y is unchanged. */
VM_INLINE int rk4_step(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, vm_real *y, vm_real *work)
{
    return vmi_rk4(f, ctx, n, &t, h, 1, y, NULL, work);
}

/* Makes `steps` equal steps from *t to t_end by the classical Runge-Kutta method. y has n numbers and becomes the state
   at t_end; *t becomes t_end exactly. If f stops the run or the state is not finite, y and *t are the state and the
   time at the end of the last complete step. Returns the same statuses as rk4_step, and ODE_BAD_ARGUMENT also if
   `steps` is not positive or t_end - *t overflows. */
VM_INLINE int rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                        vm_real *work)
{
    return vmi_rk4_solve(f, ctx, n, t, t_end, steps, y, NULL, work);
}

/* Makes equal steps with compensated summation [3], so that rounding errors do not add up. The steps are those of
   rk4_solve, but the state is y + y_low. y_low has n numbers, which the caller sets to zero before the first call. The
   summation takes additional time; use this function for runs of millions of steps. */
VM_INLINE int rk4_solve_compensated(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y,
                                    vm_real *y_low, vm_real *work)
{
    if (!y_low) return ODE_BAD_ARGUMENT;
    return vmi_rk4_solve(f, ctx, n, t, t_end, steps, y, y_low, work);
}

#endif
/* integrators/options.h - options and events of an adaptive run
   An rk45_options has the options of a run. If a field is 0, the run uses the default of this option. An event is a
   change of sign of a function g(t, y) along a run, such as a bounce, where g is a height.

       ode_event touch;
       rk45_options options;
       memset(&touch, 0, sizeof touch);
       memset(&options, 0, sizeof options);
       touch.g = height; // double height(double t, const double *y, void *ctx) returns y[0]
       touch.action = ODE_STOP;
       options.rtol = 1e-9;
       options.events = &touch;
       options.n_events = 1;

   Tests: tests/test_adaptive.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_OPTIONS_H
#define VARMASS_INTEGRATORS_OPTIONS_H

/* A function of time and state whose zeros are events. */
typedef vm_real (*ode_event_function)(vm_real t, const vm_real *y, void *ctx);

/* What a run does at an event. */
enum {
    ODE_RECORD = 0, /* the run counts the event and goes on */
    ODE_STOP = 1,   /* the run ends at the event with the status ODE_EVENT */
    ODE_RESTART = 2 /* the run ends the step at the event, calls `change`, and begins a new step */
};

/* The values that some fields of an ode_event have at the beginning of a step. Each field here has the same name as
   the field of ode_event. A run stores these values so that it can undo the step */
typedef struct VM_TAG(vmi_event_past) {
    long count;
    vm_real t, slack, quiet;
    int side;
} vmi_event_past;

/* An event of a run: it happens when g(t, y) reaches zero or changes its sign. The caller makes an array of events, to
   which the field `events` of rk45_options points. The caller first sets all fields to 0, and then sets the fields
   that it needs among the fields from g to stop_after. The integrator sets the fields from count on. */
typedef struct VM_TAG(ode_event) {
    ode_event_function g; /* the function whose zeros are the event */
    void *ctx;            /* pointer that g and change receive */
    int direction; /* > 0: an event is a change of the sign of g from - to +, < 0: from + to -, 0: both */
    int action;    /* ODE_RECORD, ODE_STOP or ODE_RESTART */
    int checks;    /* number of points inside each step at which g is evaluated, at most 9999; 0: 3 points; < 0: none */
    /* NULL, or the function that an event with ODE_RESTART calls. It may change y, and in ctx the data on which f
       depends. */
    void (*change)(vm_real t, vm_real *y, void *ctx);
    long room;       /* number of events for which `times` and `states` have room; later events are only counted */
    vm_real *times;  /* NULL, or an array that receives the times of the first `room` events */
    vm_real *states; /* NULL, or an array that receives the states of the first `room` events, n numbers each */
    /* 0, or a number k > 0: the run ends with ODE_EVENT when this event happens for the kth time, the 2kth time and so
       on, whatever its action is. For k > 0 an event with ODE_STOP stops the run at these times only. Each time that
       such an event happens, it ends a step. */
    long stop_after;
    long count;      /* number of events so far */
    vm_real t;       /* time of the last event; the start of the run before the first one */
    /* The fields from here on are internal. */
    int side;       /* sign of g at the present time of the run, 0 while it is uncertain */
    int side_ahead; /* sign of g at the end of the step, if no event ends the step earlier */
    vm_real slack_ahead, quiet_ahead; /* slack and quiet at the end of the step, if no event ends the step earlier */
    int happens;    /* nonzero if this event happens at the end of the step */
    vm_real from;   /* g has been evaluated up to this fraction of the step */
    vm_real slack;  /* after the event, the sign of g is uncertain while |g| <= slack */
    vm_real quiet;  /* time after the event for which the sign of g may still be uncertain */
    vmi_event_past past; /* the fields at the beginning of the step, for a step that is undone */
} ode_event;

/* Options of a run. A zero in any field means its default; rk45_defaults shows all defaults. */
typedef struct VM_TAG(rk45_options) {
    vm_real rtol;             /* relative tolerance of a step; the default is 1e-6 (float 1e-4), negative means none */
    vm_real atol;             /* absolute tolerance of every component; the default is rtol/1000, negative means none */
    vm_real h0;               /* size of the first step, 0: computed from f. Its sign is the direction of rk45_step. */
    /* Where t has few digits left, rounding may make a step longer than h_max or shorter than h_min by 1/64 (TIME). */
    vm_real h_min;            /* size of the shortest step, except at t_end and events; default: the resolution of t */
    vm_real h_max;            /* size of the longest step; the default is no limit */
    long max_steps;           /* steps that a call of rk45_solve may try; default 1000000, negative means no limit */
    const vm_real *atol_each; /* NULL, or n absolute tolerances of the components, in place of atol; 0 means none */
    ode_event *events;        /* array of n_events events, or NULL */
    int n_events;             /* number of events */
    long work_size; /* number of elements of work, e.g. sizeof work / sizeof *work; 0 means that it is not checked */
} rk45_options;

#if VM_MANT_DIG > 24
#define VMI_DEFAULT_RTOL VM_C(1e-6)
#else
#define VMI_DEFAULT_RTOL VM_C(1e-4)
#endif

/* Returns the options with each zero replaced by its default, a positive rtol raised to at least least_rtol, and a
   negative rtol or atol replaced by 0. */
VM_API rk45_options vmi_defaults(vm_real least_rtol, const rk45_options *options_or_NULL)
{
    rk45_options o = {0, 0, 0, 0, 0, 0, NULL, NULL, 0, 0};
    if (options_or_NULL) o = *options_or_NULL;
    if (o.rtol == 0) o.rtol = VMI_DEFAULT_RTOL;
    if (o.rtol > 0 && o.rtol < least_rtol) o.rtol = least_rtol;
    if (o.atol == 0 && o.rtol > 0) o.atol = o.rtol * VM_C(1e-3);
    if (o.rtol < 0) o.rtol = 0;
    if (o.atol < 0) o.atol = 0;
    if (o.h_max == 0) o.h_max = VM_MAX;
    if (o.max_steps == 0) o.max_steps = 1000000L;
    return o;
}

/* Returns the absolute tolerance of component i. */
VM_INLINE vm_real vmi_atol(const rk45_options *o, int i) { return o->atol_each ? o->atol_each[i] : o->atol; }

/* Returns 1 if every component has a tolerance and no tolerance is negative or NaN, else 0. */
VM_API int vmi_tolerances_are_valid(const rk45_options *o, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        const vm_real atol = vmi_atol(o, i);
        if (!(atol >= 0) || !(atol + o->rtol > 0)) return 0;
    }
    return 1;
}

/* Returns 1 if a run of n components can begin with these options, else 0. vmi_defaults must have replaced the
   zeros. */
VM_API int vmi_options_are_valid(const rk45_options *o, int n)
{
    int i;
    if (!VM_IS_FINITE(o->rtol) || !VM_IS_FINITE(o->atol) || !vmi_tolerances_are_valid(o, n)) return 0;
    if (!VM_IS_FINITE(o->h0) || !(o->h_min >= 0) || !(o->h_max >= o->h_min)) return 0;
    if (o->n_events < 0 || (o->n_events > 0 && !o->events)) return 0;
    for (i = 0; i < o->n_events; i++)
        if (!o->events[i].g || o->events[i].room < 0 || o->events[i].stop_after < 0) return 0;
    return 1;
}

/* Returns 1 if the event ends the step in which it happens, else 0. */
VM_INLINE int vmi_ends_step(const ode_event *e) { return e->action != ODE_RECORD || e->stop_after > 0; }

/* Returns 1 if n >= 0 is a multiple of k > 0, else 0. The function does not divide: it subtracts k 2^j for smaller and
   smaller j. So a program for a processor without a division instruction needs no division routine for this
   function. */
VM_API int vmi_is_multiple(long n, long k)
{
    long part = k;
    while (part <= n - part) part *= 2;
    while (part > k) {
        if (n >= part) n -= part;
        part /= 2;
    }
    return n == 0 || n == k;
}

/* Returns 1 if the event, which has just been counted, ends the run, else 0. */
VM_API int vmi_stops_now(const ode_event *e)
{
    if (e->stop_after > 0) return vmi_is_multiple(e->count, e->stop_after);
    return e->action == ODE_STOP;
}

/* Returns 1 if any event can end the run, else 0. */
VM_API int vmi_an_event_stops(const rk45_options *o)
{
    int i;
    for (i = 0; i < o->n_events; i++)
        if (o->events[i].action == ODE_STOP || o->events[i].stop_after > 0) return 1;
    return 0;
}

/* Returns the tolerance of component i in a step, atol + rtol |y|, where y is the value of the component. VM_MIN is
   added so that the result is positive. */
VM_INLINE vm_real vmi_tolerance(const rk45_options *o, int i, vm_real y)
{
    return vmi_atol(o, i) + o->rtol * VM_FABS(y) + VM_MIN;
}

#endif
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
/* integrators/runs.h - what an adaptive run is: its state, its work and its beginning
   A variable of the type rk45 contains the state of a run, which may be a run by the method rk45 or by the method
   rk87. Its array `work`, which the caller provides, contains arrays of n numbers each, such as y. The functions that
   make and use an rk45 are in rk45.h and rk87.h.

   Tests: tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_RUNS_H
#define VARMASS_INTEGRATORS_RUNS_H

#include <limits.h>

/* An adaptive run. The caller may read the fields from t to options. */
typedef struct VM_TAG(rk45) {
    vm_real t;            /* current time */
    vm_real *y;           /* current state, n numbers (in work) */
    vm_real t_old;        /* the last accepted step is from t_old to t (rk45_interpolate); t_old is t after an error */
    vm_real h;            /* size of the next step to be tried, with its sign; at first the option h0, which may be 0 */
    long steps;           /* number of accepted steps; these counts stop at LONG_MAX */
    long rejected;        /* number of rejected steps */
    long evals;           /* number of evaluations of f */
    long missed;          /* number of steps of the smallest size that were accepted above the tolerance */
    int rhs_status;       /* number that f returned last */
    int event;            /* index of the event that ended the last call, else -1 */
    int stiff;            /* nonzero after the equations have looked stiff (ODE_STIFF) */
    ode_rhs f;            /* the right-hand side */
    void *ctx;            /* pointer that f receives */
    int n;                /* number of components */
    rk45_options options; /* the options, with the defaults in place of zeros */
    /* The fields from here on are internal. */
    vmi_rk_pair pair;
    vm_real *work;
    vm_real t_low;         /* y belongs to the time t + t_low; |t_low| <= ulp(t)/2 */
    vm_real t_old_low;     /* the last step began at the time t_old + t_old_low */
    vm_real h_done;        /* size of the last accepted step */
    vm_real inverse_error; /* tolerance of the last accepted step divided by its error */
    long attempts;         /* number of steps that may still be tried; negative means no limit */
    int k1;                /* where k_1 of the next step is: VMI_K1_MISSING, VMI_K1_READY or VMI_K1_IS_LAST */
    int extended;          /* nonzero if the continuous extension of the last step is ready */
    int failed;            /* 1 if the last attempt to make a step failed, else 0 */
    long next_miss;        /* value of `steps` from which on a step of the smallest size may miss the tolerance again */
    int stiff_wait;        /* number of steps until the next test of stiffness */
    int stiff_hits;        /* number of tests that found stiffness since VMI_STIFF_MISSES tests in a row found none */
    int stiff_misses;      /* number of tests since the last test that found stiffness */
} rk45;

enum { VMI_K1_MISSING, VMI_K1_READY, VMI_K1_IS_LAST };  /* k_1 is unknown, ready, or the last k of the step before */
enum { VMI_STIFF_WAIT = 100 };                          /* accepted steps from one test of stiffness to the next */

/* Returns the part of work with the index `part`, such as VMI_Y: an array of n numbers. */
VM_API vm_real *vmi_part(const rk45 *s, int part) { return s->work + (ptrdiff_t)part * s->n; }

/* Sets the fields of a new run that do not depend on the options or the pair */
VM_API void vmi_init_fields(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, vm_real *work)
{
    s->f = f;
    s->ctx = ctx;
    s->n = n;
    s->work = work;
    s->y = work;
    s->t = t0;
    s->t_old = t0;
    s->t_low = 0;
    s->t_old_low = 0;
    s->h_done = 0;
    s->inverse_error = 1;
    s->steps = 0;
    s->rejected = 0;
    s->evals = 0;
    s->missed = 0;
    s->next_miss = 0;
    s->rhs_status = 0;
    s->event = -1;
    s->k1 = VMI_K1_MISSING;
    s->extended = 0;
    s->failed = 0;
    s->stiff = 0;
    s->stiff_wait = VMI_STIFF_WAIT;
    s->stiff_hits = 0;
    s->stiff_misses = 0;
}

/* Sets the fields of an event that belong to the integrator to their first values. An earlier run may have used the
   event. */
VM_API void vmi_init_event(ode_event *e, vm_real t0)
{
    e->count = 0;
    e->t = t0;
    e->side = 0;
    e->side_ahead = 0;
    e->slack_ahead = 0;
    e->quiet_ahead = 0;
    e->happens = 0;
    e->from = 0;
    e->slack = 0;
    e->quiet = 0;
}

/* Does the work of rk45_init for any pair */
VMI_APART int vmi_init(rk45 *s, const vmi_rk_pair *pair, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                       const rk45_options *options_or_NULL, vm_real *work)
{
    const rk45_options o = vmi_defaults(vmi_least_rtol(pair), options_or_NULL);
    const int is_raised = options_or_NULL && options_or_NULL->rtol > 0 && options_or_NULL->rtol < o.rtol;
    int i;
    if (!s || !f || n <= 0 || !y0 || !work || !VM_IS_FINITE(t0) || !vmi_all_finite(n, y0) ||
        !vmi_options_are_valid(&o, n))
        return ODE_BAD_ARGUMENT;
    if (o.work_size && o.work_size < (long)(VMI_K + pair->derivatives) * n) return ODE_WORK_TOO_SMALL;
    for (i = 0; i < o.n_events; i++) vmi_init_event(o.events + i, t0);
    vmi_init_fields(s, f, ctx, n, t0, work);
    s->pair = *pair;
    s->options = o;
    s->h = o.h0;
    s->attempts = o.max_steps;
    vmi_copy(n, y0, s->y);
    for (i = n; i < (VMI_K + pair->derivatives) * n; i++) work[i] = 0; /* then all bytes of a saved run are defined */
    return is_raised ? (int)ODE_RTOL_RAISED : (int)ODE_OK;
}

/* Computes the state y = y_old + h (b[0] k_1 + b[1] k_2 + ...) at the fraction x of the last step; the sum in brackets
   has `count` terms. The weights b add up to x. Therefore the sum is equal to x k_1 plus the terms b[j] (k_{j+1} -
   k_1). It is computed in this form, because the differences make the rounding errors smaller. */
VM_INLINE void vmi_weigh_inside(const rk45 *s, int count, const vm_real *b, vm_real x, vm_real *y)
{
    const vm_real *y_old = vmi_part(s, VMI_Y_OLD), *k1 = vmi_part(s, VMI_K);
    int i, j;
    for (i = 0; i < s->n; i++) {
        vm_real sum = 0;
        for (j = 1; j < count; j++) sum += b[j] * (vmi_part(s, VMI_K + j)[i] - k1[i]);
        y[i] = y_old[i] + s->h_done * (x * k1[i] + sum);
    }
}

/* Returns count + more for count >= 0, or LONG_MAX if this sum is larger. On many machines the type long has 32 bits,
   and a long run may take more steps than such a number can count. */
VM_API long vmi_count(long count, long more)
{
    if (more > 0 && count > LONG_MAX - more) return LONG_MAX;
    return count + more;
}

/* Evaluates k = f(t, y) and counts this evaluation. Returns a status. */
VM_API int vmi_eval(rk45 *s, vm_real t, const vm_real *y, vm_real *k)
{
    s->evals = vmi_count(s->evals, 1);
    s->rhs_status = s->f(t, y, k, s->ctx);
    return s->rhs_status ? ODE_RHS_STOPPED : ODE_OK;
}

#endif
/* integrators/dense.h - the solution inside the last step of an adaptive run
   The continuous extension of a step of rk45 or rk87 is a polynomial in time. It gives the state at any time within the
   step, to about the accuracy of the step itself. Users call rk45_interpolate and rk87_interpolate.

   Tests: tests/test_dense.c. */
#ifndef VARMASS_INTEGRATORS_DENSE_H
#define VARMASS_INTEGRATORS_DENSE_H

/* Computes the derivatives that the continuous extension of the last step needs, if they are not known yet. Returns a
   status. */
VM_API int vmi_extend(rk45 *s)
{
    int status = ODE_OK;
    if (!s->extended && s->pair.extend) status = s->pair.extend(s);
    if (status == ODE_OK) s->extended = 1;
    return status;
}

/* Computes the state y at the fraction x of the last step, 0 <= x <= 1. The derivatives that the continuous extension
   needs must be known (vmi_extend). */
VM_API void vmi_inside(const rk45 *s, vm_real x, vm_real *y) { s->pair.inside(s, x, y); }

/* Returns 1 if the time t is within the last step or at one of its ends, else 0. */
VM_API int vmi_is_in_last_step(const rk45 *s, vm_real t)
{
    return (s->t_old <= t && t <= s->t) || (s->t <= t && t <= s->t_old);
}

/* Returns the fraction of the last step at which the time t lies: 0 at the beginning of the step, 1 at its end */
VM_API vm_real vmi_place_of(const rk45 *s, vm_real t)
{
    const vm_real x = ((t - s->t_old) - s->t_old_low) / s->h_done;
    if (x < 0) return 0;
    return VMI_SMALLER(x, VM_C(1.0));
}

/* Computes the state y at a time t within the last step of a run by the pair whose number is `method`. The derivatives
   that the continuous extension needs must be known (vmi_extend). Returns a status. */
VM_API int vmi_interpolate_ready(const rk45 *s, int method, vm_real t, vm_real *y)
{
    if (!s || !y || s->pair.method != method || !vmi_is_in_last_step(s, t)) return ODE_BAD_ARGUMENT;
    if (t == s->t) vmi_copy(s->n, s->y, y);
    else vmi_inside(s, vmi_place_of(s, t), y);
    return ODE_OK;
}

/* Computes the state y at a time t within the last step of a run by any pair. At the time s->t the function needs no
   evaluation of f. Returns a status. */
VM_API int vmi_interpolate(rk45 *s, vm_real t, vm_real *y)
{
    if (!y || !vmi_is_in_last_step(s, t)) return ODE_BAD_ARGUMENT;
    if (t != s->t) {
        const int status = vmi_extend(s);
        if (status) return status;
    }
    return vmi_interpolate_ready(s, s->pair.method, t, y);
}

#endif
/* base/bits.h - the bits of a number, and products with powers of two

   A vm_real is stored as a sign, an exponent and a mantissa. The functions here read and write these bits as an
   integer, and multiply by 2^k without a function of the C library, so that every machine gives the same bits.

       vm_real y = vmi_ldexp(3, 4); // 3 * 2^4 = 48

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_BASE_BITS_H
#define VARMASS_BASE_BITS_H

#include <stdint.h>
#include <string.h>

#if VM_MANT_DIG > 24
typedef uint64_t vmi_bits;
#define VMI_STORED_DIG 52 /* number of bits in which the mantissa is stored */
#define VMI_BIAS 1023     /* the number that is stored as the exponent of 1 */
#else
typedef uint32_t vmi_bits;
#define VMI_STORED_DIG 23
#define VMI_BIAS 127
#endif

/* Returns the bits of x as an integer. */
VM_API vmi_bits vmi_to_bits(vm_real x)
{
    vmi_bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Returns the number whose bits are the given integer. */
VM_API vm_real vmi_from_bits(vmi_bits bits)
{
    vm_real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Returns x 2^k. The function multiplies x twice by about 2^(k/2), because 2^k itself may overflow or underflow. It
   rounds at most once if |x| lies between 1/4 and 4 or is 0, or if x 2^(k/2) is a normal number. */
VM_API vm_real vmi_ldexp(vm_real x, int k)
{
    const int limit = 2 * VMI_BIAS - 2;
    int half, rest;
    if (k > limit) k = limit;
    if (k < -limit) k = -limit;
    half = k / 2;
    rest = k - half;
    return x * vmi_from_bits((vmi_bits)(VMI_BIAS + half) << VMI_STORED_DIG) *
           vmi_from_bits((vmi_bits)(VMI_BIAS + rest) << VMI_STORED_DIG);
}

/* Returns (y + y_lo) 2^k for 1/2 <= y <= 2 and a low word y_lo of y. The result is rounded once, even if subnormal. */
VM_API vm_real vmi_ldexp_two(vm_real y, vm_real y_lo, int k)
{
    if (k < 1 - VMI_BIAS || (k == 1 - VMI_BIAS && y < 1)) {
        /* A subnormal result has fewer digits than y + y_lo. The code adds a power of two and subtracts it again, which
           removes the superfluous digits with one rounding. */
        const int most = VM_MANT_DIG + 1, lost = 1 - VMI_BIAS - k < most ? 1 - VMI_BIAS - k : most;
        const vm_real large = vmi_ldexp(1, lost);
        const vm_two sum = vmi_fast_two_sum(large, y);
        y = (sum.hi + (sum.lo + y_lo)) - large;
        y_lo = 0;
    }
    return vmi_ldexp(y + y_lo, k);
}

/* The signed integer type that holds the bits of a vm_real, and the bits of the number 1 */
#if VM_MANT_DIG > 24
typedef int64_t vmi_signed_bits;
#else
typedef int32_t vmi_signed_bits;
#endif
#define VMI_BITS_OF_1 ((vmi_signed_bits)VMI_BIAS << VMI_STORED_DIG)

#endif
/* integrators/steps.h - steps of an adaptive run and the control of their size
   vmi_advance is the loop over the steps. The compiler makes a version of this loop for each pair; if it knows n and f
   in a call and n is small, it makes a version for this n and this f. The manual in integrators.h explains how the
   size of the steps is chosen.

   Tests: tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_STEPS_H
#define VARMASS_INTEGRATORS_STEPS_H

#include <string.h>

/* Returns x^p with an error of at most 1.6 % if |p| <= 0.2 and the result is from 0.1 to 10. x must be positive, and
   the result must neither overflow nor underflow. The bits of x, read as an integer, give an approximate logarithm of
   x, which is linear between powers of 2. `middle` is half the largest error of this logarithm; it is added, so that
   the largest error is only half as large. The exponential function e^(16 v) is computed as (1 + v + v^2/2)^16. */
VM_INLINE vm_real vmi_pow_rough(vm_real x, vm_real p)
{
    const vm_real ln2 = VM_C(0.69314718055994531), middle = VM_C(0.043);
    vmi_signed_bits bits;
    vm_real v;
    memcpy(&bits, &x, sizeof x);
    v = ((vm_real)(bits - VMI_BITS_OF_1) + middle / VM_EPSILON) * (p * (ln2 / 16 * VM_EPSILON));
    v = 1 + v * (1 + v / 2);
    v *= v;
    v *= v;
    v *= v;
    v *= v;
    return v;
}

#define VMI_LARGEST_RATIO VM_C(1e10) /* upper limit of the ratios from which vmi_first_step chooses the first step */

/* Returns the largest ratio of |v_i| to the tolerance of component i, but at most VMI_LARGEST_RATIO. */
VM_API vm_real vmi_norm_by_tolerance(const rk45 *s, const vm_real *v)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < s->n; i++) {
        const vm_real ratio = VM_FABS(v[i]) / vmi_tolerance(&s->options, i, s->y[i]);
        if (ratio > largest) largest = ratio;
    }
    return VMI_SMALLER(largest, VMI_LARGEST_RATIO);
}

/* Chooses the size s->h of the first step from the magnitudes of y, y' and y'' (Hairer et al. [2, II.4]). The aim is an
   error of this step of 1 % of the tolerance. |s->h| is at most `longest`, and at most 100 times the size of a step
   that changes y by 1 % (at most 1e-4 if y or y' is below 1e-5 of the tolerance). A ratio of y, y' or y'' to the
   tolerance counts as at most VMI_LARGEST_RATIO; if y' is larger, the first step may be too long and be rejected.
   `direction`, 1 or -1, is the sign of s->h. The function overwrites k_2 and the part VMI_Z of work. Returns a status.
   */
VM_API int vmi_first_step(rk45 *s, vm_real direction, vm_real longest)
{
    vm_real *k1 = vmi_part(s, VMI_K), *k2 = vmi_part(s, VMI_K + 1), *z = vmi_part(s, VMI_Z);
    const vm_real size = vmi_norm_by_tolerance(s, s->y), speed = vmi_norm_by_tolerance(s, k1);
    vm_real h0 = VM_C(1e-6), h1 = VM_C(1e-6), fastest = 0;
    int i, status;
    if (size >= VM_C(1e-5) && speed >= VM_C(1e-5)) h0 = VM_C(0.01) * size / speed;
    if (h0 > longest) h0 = longest;
    for (i = 0; i < s->n; i++) z[i] = s->y[i] + direction * h0 * k1[i];
    status = vmi_eval(s, s->t + direction * h0, z, k2);
    if (status) return status;
    for (i = 0; i < s->n; i++) {
        vm_real ratio = VM_FABS((k2[i] - k1[i]) / h0) / vmi_tolerance(&s->options, i, s->y[i]);
        if (!(ratio < VMI_LARGEST_RATIO)) ratio = VMI_LARGEST_RATIO; /* also where f is NaN */
        if (ratio > fastest) fastest = ratio;
    }
    if (speed > fastest) fastest = speed;
    if (fastest > VM_C(1e-15)) h1 = vmi_pow_rough(VM_C(0.01) / fastest, 1 / (vm_real)s->pair.order);
    if (h1 > 100 * h0) h1 = 100 * h0;
    if (h1 < VM_C(1e-3) * h0) h1 = VM_C(1e-3) * h0;
    s->h = direction * VMI_SMALLER(h1, longest);
    return ODE_OK;
}

/* Returns the length of the shortest step that is tried at the time t. It is positive at t = 0 too, since otherwise
   failing steps could become shorter without end. */
VM_INLINE vm_real vmi_least_step(const rk45_options *o, vm_real t)
{
    const vm_real least = 2 * VM_EPSILON * VM_FABS(t) + VM_MIN;
    return VMI_LARGER(least, o->h_min);
}

/* Returns the time from the state y to t_end, negative if the run goes backward. */
VM_INLINE vm_real vmi_time_left(const rk45 *s, vm_real t_end) { return (t_end - s->t) - s->t_low; }

/* Returns the direction of the run to t_end: 1 forward, -1 backward. */
VM_INLINE vm_real vmi_direction(const rk45 *s, vm_real t_end) { return vmi_time_left(s, t_end) < 0 ? -1 : 1; }

/* Returns the factor by which the step size changes after an accepted step, by PI control (Hairer et al. [2, IV.2]). It
   is the smaller of 10 and
     0.9 error^(-4/(5 order)) error_before^(1/(5 order)),
   where error is the error of this step divided by its tolerance, and error_before is the same ratio for the previous
   step. */
VM_INLINE vm_real vmi_factor(int order, vm_real error, vm_real inverse_error_before)
{
    const vm_real square = error * error, power = VM_C(-0.2) / (vm_real)order;
    const vm_real factor = VM_C(0.9) * vmi_pow_rough(square * square * inverse_error_before, power);
    return VMI_SMALLER(factor, VM_C(10.0));
}

/* Returns the factor by which the step size changes after a rejected step: 0.9 error^(-1/order), at least 1/5, where
   error is the error of the step divided by its tolerance. It is 1/10 if error is NaN. */
VM_INLINE vm_real vmi_shrink(int order, vm_real error)
{
    vm_real factor;
    if (error != error) return VM_C(0.1);
    factor = VM_C(0.9) * vmi_pow_rough(error, -1 / (vm_real)order);
    return VMI_LARGER(factor, VM_C(0.2));
}

/* The fields of an rk45 that change from step to step. vmi_advance keeps these fields in a local variable while it
   makes steps, so that the compiler can put them in registers. */
typedef struct VM_TAG(vmi_progress) {
    vm_real direction;              /* direction to t_end: 1 forward, -1 backward */
    vm_real t, t_low;               /* y belongs to the time t + t_low */
    vm_real t_old, t_old_low;       /* the last step began at the time t_old + t_old_low */
    vm_real h_next;                 /* size of the next step */
    vm_real h_done;                 /* size of the last accepted step */
    vm_real inverse_error;          /* tolerance of the last accepted step divided by its error */
    vm_real t_missed, t_missed_low; /* their sum is the time at which the last step above the tolerance began */
    long steps, rejected, missed;   /* numbers of steps since vmi_advance was called */
    long next_miss;                 /* value of `steps` from which on a step may miss the tolerance again */
    long attempts;                  /* number of steps that may still be tried; negative means no limit */
    int k1, failed, stiff_wait;     /* the fields of rk45 with these names */
    int stopped;                    /* number that f returned last; if it is not 0, the run stops */
} vmi_progress;

/* Returns the fields that change from step to step, as they are before the loop. */
VMI_FOLDED vmi_progress vmi_begin_progress(const rk45 *s, vm_real t_end)
{
    vmi_progress p;
    p.direction = vmi_direction(s, t_end);
    p.t = s->t;
    p.t_low = s->t_low;
    p.t_old = s->t;
    p.t_old_low = s->t_low;
    p.h_next = s->h;
    p.h_done = s->h_done;
    p.inverse_error = s->inverse_error;
    p.t_missed = s->t;
    p.t_missed_low = s->t_low;
    p.steps = 0;
    p.rejected = 0;
    p.missed = 0;
    p.next_miss = s->next_miss - s->steps;
    p.attempts = s->attempts;
    p.k1 = VMI_K1_READY;
    p.failed = s->failed;
    p.stiff_wait = s->stiff_wait;
    p.stopped = 0;
    return p;
}

/* After the loop, stores in s the fields that change from step to step */
VMI_FOLDED void vmi_store_progress(rk45 *s, const vmi_progress *p)
{
    s->t = p->t;
    s->t_low = p->t_low;
    s->t_old = p->t_old;
    s->t_old_low = p->t_old_low;
    s->h = p->h_next;
    s->h_done = p->h_done;
    s->inverse_error = p->inverse_error;
    s->next_miss = vmi_count(s->steps, p->next_miss);
    s->steps = vmi_count(s->steps, p->steps);
    s->rejected = vmi_count(s->rejected, p->rejected);
    s->missed = vmi_count(s->missed, p->missed);
    s->attempts = p->attempts;
    s->k1 = p->k1;
    s->failed = p->failed;
    s->stiff_wait = p->stiff_wait;
    s->rhs_status = p->stopped;
    s->extended = 0;
}

/* A step that is tried */
typedef struct VM_TAG(vmi_trial) {
    vm_real h, t_new, t_new_low; /* size of the step, and its end, the time t_new + t_new_low */
    int last;                    /* 1 if the step ends at t_end */
    int shortest;                /* 1 if no shorter step can be tried */
} vmi_trial;

/* The size of a step is changed by at most this fraction, 1/64, so that the time at the end of the step is a number of
   the type vm_real. If this needs a larger change, the step is very short: its size then stays the same, and it ends
   between two numbers of the type. The time of the state y is t + t_low; after this step t_low is not 0. */
#define VMI_LANDING VM_C(0.015625)
#define VMI_NEARLY VM_C(0.999999) /* a step of at least this fraction of the time to t_end ends at t_end */

/* Chooses the next step towards t_end and brings p->h_next between the smallest and the largest size. Returns ODE_OK,
   or the status with which the run ends: ODE_STEP_TOO_SMALL if h_max is too small, ODE_MAX_STEPS if no attempt is
   left. */
VMI_FOLDED int vmi_choose_step(const rk45_options *o, vm_real t_end, vmi_progress *p, vmi_trial *trial)
{
    const vm_real left = (t_end - p->t) - p->t_low, least = vmi_least_step(o, p->t);
    vm_real h_to_t_new;
    int status = ODE_OK, lands;
    p->t_old = p->t;
    p->t_old_low = p->t_low;
    p->k1 = VMI_K1_READY;
    if (VM_FABS(p->h_next) < least) p->h_next = p->direction * least;
    if (VM_FABS(p->h_next) > o->h_max) {
        p->h_next = p->direction * o->h_max;
        if (o->h_max < least && o->h_max < VM_FABS(left)) status = ODE_STEP_TOO_SMALL;
    }
    trial->last = VM_FABS(p->h_next) >= VMI_NEARLY * VM_FABS(left);
    trial->t_new = trial->last ? t_end : p->t + (p->t_low + p->h_next);
    h_to_t_new = (trial->t_new - p->t) - p->t_low;
    lands = trial->last || VM_FABS(h_to_t_new - p->h_next) <= VMI_LANDING * VM_FABS(p->h_next);
    trial->h = lands ? h_to_t_new : p->h_next;
    trial->t_new_low = lands ? 0 : p->h_next - h_to_t_new;
    trial->shortest = VM_FABS(p->h_next) <= least || VM_FABS(trial->h) <= least;
    if (p->attempts == 0) status = ODE_MAX_STEPS;
    if (status == ODE_OK && p->attempts > 0) p->attempts--;
    return status;
}

/* The number of steps that must keep the tolerance between two steps that miss it. After a jump of f the next three
   steps keep the tolerance; they are 1, 10 and 100 times as long as the smallest step. Next to a singularity of f no
   step keeps the tolerance. */
enum { VMI_BETWEEN_MISSES = 3 };

/* Undoes the last accepted step, which missed the tolerance */
VMI_FOLDED void vmi_drop_missed_step(vmi_rk_system sys, vmi_progress *p)
{
    vmi_copy(sys.n, sys.w + VMI_Y_OLD * sys.m, sys.w + VMI_Y * sys.m);
    p->t = p->t_missed;
    p->t_old = p->t_missed;
    p->t_low = p->t_missed_low;
    p->t_old_low = p->t_missed_low;
    p->k1 = VMI_K1_MISSING;
    p->steps--;
    p->missed--;
    p->rejected++;
}

/* Rejects a step whose error is above the tolerance or NaN, and chooses the size of the next attempt. Returns ODE_OK if
   a shorter step can be tried. Otherwise returns the status with which the run ends. If the run ends and the last
   accepted step missed the tolerance and was made in this call of vmi_advance, that step is undone. */
VMI_FOLDED int vmi_reject(int order, const vmi_trial *trial, vm_real error, vmi_rk_system sys, vmi_progress *p)
{
    const int not_a_number = error != error;
    p->rejected++;
    p->failed = 1;
    p->h_next = trial->h * vmi_shrink(order, error);
    if (!trial->shortest) return ODE_OK;
    if (p->missed > 0 && p->steps == p->next_miss - VMI_BETWEEN_MISSES) vmi_drop_missed_step(sys, p);
    if (not_a_number) p->k1 = VMI_K1_MISSING; /* k_1 may be NaN: another call must evaluate it again */
    return not_a_number ? ODE_NOT_FINITE : ODE_STEP_TOO_SMALL;
}

/* Replaces the state after a step of the smallest size in which f jumps. Some weights of the stages are positive and
   others negative, so that the weighted sum of the derivatives may lead far away from the state at the jump. Therefore
   each component is continued with the mean of the smallest and the largest of its derivatives in the stages. The
   error of this mean is at most half the jump. Returns 0 if the new state is not finite because f is infinite in a
   stage, else 1. */
VM_INLINE int vmi_take_middle_slope(int stages, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    vm_real *w = sys.w;
    int i, part;
    VMI_EACH(i, sys.n)
    {
        vm_real least = w[VMI_K * m + i], largest = least;
        VMI_UNROLL for (part = VMI_K + 1; part < VMI_K + stages; part++)
        {
            least = VMI_SMALLER(least, w[part * m + i]);
            largest = VMI_LARGER(largest, w[part * m + i]);
        }
        w[VMI_Z * m + i] = w[VMI_Y * m + i] + h * (least / 2 + largest / 2);
    }
    return vmi_all_finite(sys.n, w + VMI_Z * m);
}

#define VMI_KEEP_TO VM_C(0.75)     /* an error below this fraction of the tolerance lets the step size stay the same */
#define VMI_LEAST_ERROR VM_C(1e-8) /* if a ratio of an error to its tolerance is smaller than this, it is set to this */

/* Chooses the size of the step after an accepted step. The size stays the same if the error is between keep_from and
   VMI_KEEP_TO times the tolerance. Then the processor can predict that the size stays the same, and begin the next
   step before the error is known. */
VMI_FOLDED void vmi_choose_size(int order, vm_real keep_from, const vmi_trial *trial, vm_real error, vmi_progress *p)
{
    vm_real factor;
    if (!(error < keep_from || error > VMI_KEEP_TO || p->failed || trial->last)) return;
    factor = vmi_factor(order, error, p->inverse_error);
    if (p->failed && factor > 1) factor = 1;
    if (!trial->last) {
        p->h_next = trial->h * factor;
    } else { /* a step may be short only because it ends at t_end; the next step need not be short */
        p->h_next = p->direction * VMI_LARGER(VM_FABS(p->h_next), VM_FABS(trial->h * factor));
    }
}

/* Makes steps until t_end is reached or a test of stiffness is due, or one accepted step if `single` is not 0. Returns
   a status. */
VMI_FOLDED int vmi_advance(rk45 *s, vmi_rk_stepper stepper, vmi_rk_system sys, vm_real t_end, int single)
{
    const rk45_options o = s->options;
    const vmi_rk_pair pair = stepper.pair;
    vm_real *y = sys.w + VMI_Y * sys.m, *z = sys.w + VMI_Z * sys.m, *last_k = sys.w + vmi_last_k(&pair) * sys.m;
    vmi_progress p = vmi_begin_progress(s, t_end);
    long evals = 0; /* not a field of p: make_stages gets its address, and p would then not stay in registers */
    int status;
    for (;;) {
        vmi_trial trial;
        vm_real error;
        int misses = 0; /* 1 if the step is accepted although its error is above the tolerance */
        status = vmi_choose_step(&o, t_end, &p, &trial);
        if (status) break;
        p.stopped = stepper.make_stages(sys, p.t, trial.t_new, trial.h, &evals);
        if (p.stopped) break;
        error = stepper.step_error(&o, sys, trial.h);
        if (!(error <= 1)) {
            misses = error > 1 && trial.shortest && p.steps >= p.next_miss;
            if (misses && !vmi_take_middle_slope(pair.stages, sys, trial.h)) {
                misses = 0;
                error = VM_NAN;
            }
            if (!misses) {
                status = vmi_reject(pair.order, &trial, error, sys, &p);
                if (status) break;
                continue;
            }
            error = 1;
        }
        if (misses || !pair.last_is_first) {
            evals++;
            p.stopped = sys.f(trial.t_new, z, last_k, sys.ctx);
            if (p.stopped) break;
        }
        p.steps++;
        if (misses) {
            p.missed++;
            p.next_miss = p.steps + VMI_BETWEEN_MISSES;
            p.t_missed = p.t;
            p.t_missed_low = p.t_low;
            if (p.stiff_wait < 2) p.stiff_wait = 2; /* the test of stiffness waits for a step within the tolerance */
        }
        error = VMI_LARGER(error, VMI_LEAST_ERROR);
        vmi_choose_size(pair.order, pair.keep_from, &trial, error, &p);
        p.inverse_error = 1 / error;
        vmi_copy(sys.n, y, sys.w + VMI_Y_OLD * sys.m);
        vmi_copy(sys.n, z, y);
        p.t = trial.t_new;
        p.t_low = trial.t_new_low;
        p.h_done = trial.h;
        p.failed = 0;
        p.k1 = VMI_K1_IS_LAST;
        p.stiff_wait--;
        if (p.stiff_wait <= 0 || single || trial.last) break;
        vmi_copy(sys.n, last_k, sys.w + VMI_K * sys.m);
    }
    s->evals = vmi_count(s->evals, evals);
    vmi_store_progress(s, &p);
    return p.stopped ? (int)ODE_RHS_STOPPED : status;
}

/* Does the work of vmi_advance in a local array, which the compiler keeps in registers if it knows that n is small */
VMI_FOLDED int vmi_advance_small(rk45 *s, vmi_rk_stepper stepper, vmi_rk_system sys, vm_real t_end, int single)
{
    const vmi_rk_pair pair = stepper.pair;
    vm_real w[(VMI_K + VMI_MOST_OWN) * VMI_SMALL] = {0}; /* 0, because unused parts are copied, too */
    const int n = sys.n;
    int part, status;
    vmi_copy(n, vmi_part(s, VMI_Y), w);
    vmi_copy(n, vmi_part(s, VMI_K), w + VMI_K * n);
    sys.w = w;
    sys.m = n;
    status = vmi_advance(s, stepper, sys, t_end, single);
    vmi_copy(n, w, vmi_part(s, VMI_Y));
    if (s->k1 == VMI_K1_IS_LAST) {
        vmi_copy(n, w + VMI_Y_OLD * n, vmi_part(s, VMI_Y_OLD));
        VMI_UNROLL for (part = VMI_K; part <= vmi_last_k(&pair); part++) vmi_copy(n, w + part * n, vmi_part(s, part));
    } else {
        vmi_copy(n, w + VMI_K * n, vmi_part(s, VMI_K));
    }
    return status;
}

/* Undoes the last accepted step, so that the next step is the same step again. vmi_advance must have returned after
   this step: its k_1 is then still in work. */
VM_API void vmi_take_back_step(rk45 *s)
{
    vmi_copy(s->n, vmi_part(s, VMI_Y_OLD), s->y);
    s->t = s->t_old;
    s->t_low = s->t_old_low;
    s->h = s->h_done;
    if (s->missed > 0 && s->next_miss - VMI_BETWEEN_MISSES == s->steps) {
        s->missed--;
        s->next_miss = 0;
    }
    s->steps--;
    s->k1 = VMI_K1_READY;
}

#endif
/* integrators/events.h - events: where a function g(t, y) of the solution changes its sign
   After each step, g is evaluated at several points inside the step, with the states of the continuous extension. If
   the sign of g changes between two of these points, the time of the change is found as exactly as rounding allows.
   The first event that stops or restarts the run ends the step at its time. Events whose times differ by no more than
   rounding errors happen together. Users describe events in the options of a run (options.h). The side of an event is
   the sign of its g, -1 or 1, or 0 while rounding leaves this sign uncertain. The place x of an event in a step is a
   fraction of the step, from 0 to 1.

       double y0[2] = {20, 0}, work[RK45_WORK(2)]; // 20 m high, at rest
       rk45 s;
       ode_event touch;
       rk45_options options;
       memset(&touch, 0, sizeof touch);
       memset(&options, 0, sizeof options);
       touch.g = height; // height and fall are functions of the user: an ode_event_function and an ode_rhs
       touch.action = ODE_STOP;
       options.events = &touch;
       options.n_events = 1;
       rk45_init(&s, fall, NULL, 2, 0.0, y0, &options, work);
       if (rk45_solve(&s, 10.0) == ODE_EVENT) printf("on the ground at %g\n", s.t);

   Tests: tests/test_events.c, tests/test_coincidences.c. */
#ifndef VARMASS_INTEGRATORS_EVENTS_H
#define VARMASS_INTEGRATORS_EVENTS_H

/* Returns the sign of x: 1, 0 or -1. */
VM_API int vmi_sign(vm_real x) { return (x > 0) - (x < 0); }

/* Stands for the place of an event that does not happen in the step. A place is a fraction of the step, from 0 to 1. */
#define VMI_NONE VM_C(2.0)

/* After an event, g is also evaluated at points just after the event, so that two further changes of its sign in a
   short time are found. The distance of the first point from the event is the fraction VMI_FIRST_LOOK of the step;
   each further distance is VMI_WIDER times as long as the distance before. The sign of g may count as uncertain (side
   0) until the fraction VMI_QUIET of the step has passed after the event. */
#if VM_MANT_DIG > 24
#define VMI_FIRST_LOOK VM_C(1.4901161193847656e-8) /* 2^-26 of a step, the square root of VM_EPSILON */
#define VMI_QUIET VM_C(6.103515625e-5)             /* 2^-14 of a step, the longest time for which a sign is uncertain */
#define VMI_WIDER 64
#else
#define VMI_FIRST_LOOK VM_C(2.44140625e-4) /* 2^-12 of a step, about the square root of VM_EPSILON */
#define VMI_QUIET VM_C(0.0009765625)       /* 2^-10 of a step, the longest time for which a sign is uncertain */
#define VMI_WIDER 8
#endif

/* Sets the side of each event, the sign of its g, at the start or the restart of a run. The side is 0 if g is 0, or if
   the event has just happened and g is so small that rounding could decide its sign. Returns a status. */
VM_API int vmi_watch_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        const vm_real g = e->g(s->t, s->y, e->ctx);
        if (g != g) return ODE_NOT_FINITE;
        if (!(VM_FABS(g) <= e->slack)) e->quiet = 0;
        e->side = 0;
        if (!(e->quiet > 0)) e->side = vmi_sign(g);
    }
    return ODE_OK;
}

/* Returns the time at the fraction x of the last step. */
VM_API vm_real vmi_time_inside(const rk45 *s, vm_real x)
{
    if (x == 1) return s->t;
    return s->t_old + (s->t_old_low + x * s->h_done);
}

/* Computes the state y at the fraction x of the last step. At x = 1 this is exactly s->y. */
VM_API void vmi_state_inside(const rk45 *s, vm_real x, vm_real *y)
{
    if (x == 1) vmi_copy(s->n, s->y, y);
    else vmi_inside(s, x, y);
}

/* Returns the value of g at the fraction x of the last step. The function overwrites the part VMI_Z of work. */
VM_API vm_real vmi_event_value(const rk45 *s, const ode_event *e, vm_real x)
{
    vm_real *z = vmi_part(s, VMI_Z);
    if (x == 1) return e->g(s->t, s->y, e->ctx);
    vmi_inside(s, x, z);
    return e->g(vmi_time_inside(s, x), z, e->ctx);
}

/* A bound of the relative change of a state that the rounding errors of all steps of a run so far may have caused. It
   serves only to decide whether events happen at the same time. */
#define VMI_EARLIER_ROUNDING (256 * VM_EPSILON)

/* Returns the value of g at the fraction x of the last step, in a state to which a rounding error is added on purpose.
   The error is the largest rounding error that this step may have made; if `earlier` is not 0, it is the largest that
   the whole run so far may have made. `direction`, -1 or 1, is the sign of the error. The size of the error is
   different for each component, so that the differences of components change, too. */
VM_API vm_real vmi_event_value_moved(const rk45 *s, const ode_event *e, vm_real x, int earlier,
                                     int direction)
{
    const vm_real relative = earlier ? VMI_EARLIER_ROUNDING : vmi_least_rtol(&s->pair);
    const vm_real end = earlier ? 1 : x; /* weight of s->y in `size`; the rounding error is proportional to `size` */
    const vm_real rounding = (vm_real)direction * relative, golden = VM_C(0.6180339887498949);
    const vm_real *y_old = vmi_part(s, VMI_Y_OLD);
    vm_real *z = vmi_part(s, VMI_Z), phase = 0;
    int i;
    vmi_state_inside(s, x, z);
    for (i = 0; i < s->n; i++) {
        const vm_real size = VM_FABS(y_old[i]) + VM_FABS(z[i]) + end * VM_FABS(s->y[i]);
        const vm_real share = phase - VM_C(0.5);
        z[i] += rounding * size * (share + VM_COPYSIGN(VM_C(0.5), share));
        phase += golden;
        if (phase >= 1) phase -= 1;
    }
    return e->g(vmi_time_inside(s, x) * (1 + (vm_real)direction * VM_EPSILON), z, e->ctx);
}

/* Sets e->slack to the largest |g| that rounding can cause at the fraction x of the last step; if `earlier` is not 0,
   the errors of all earlier steps of the run are included. Returns 1 if g certainly has the sign `side` there, in spite
   of rounding, else 0. */
VM_API int vmi_weigh_rounding(const rk45 *s, ode_event *e, vm_real x, int earlier, int side)
{
    int direction, certain = 1;
    e->slack = 0;
    for (direction = -1; direction <= 1; direction++) {
        vm_real g;
        if (direction == 0) g = vmi_event_value(s, e, x);
        else g = vmi_event_value_moved(s, e, x, earlier, direction);
        if (VM_FABS(g) > e->slack) e->slack = VM_FABS(g);
        if (vmi_sign(g) != side) certain = 0;
    }
    return certain;
}

/* Returns 1 if the field `direction` of the event lets it happen when g changes from the sign `side` to another sign,
   else 0. */
VM_API int vmi_counts_from(const ode_event *e, int side)
{
    return side && (e->direction == 0 || (e->direction > 0) == (side < 0));
}

/* Sets *at to a fraction of the last step between a and b at which g loses the sign that it has at a. ga and gb are
   the values of g at the fractions a and b. The interval from a to b is made smaller until its length is the
   resolution of such fractions, and *at becomes its right end. The method is false position in the Illinois form, with
   bisection in every third step and while g stays 0 at the right end. If g is 0 at the initial b, and the time there
   equals the time at *at, then *at becomes the initial b. Returns a status. */
VM_API int vmi_locate(const rk45 *s, const ode_event *e, vm_real a, vm_real ga, vm_real b, vm_real gb,
                      vm_real *at)
{
    const vm_real resolution = 2 * VM_EPSILON, look = b, g_look = gb;
    const int side = vmi_sign(ga);
    int count, kept = 0; /* 1 if the last x has become a, -1 if it has become b, 0 before the first x */
    for (count = 1; b - a > resolution; count++) {
        const int bisect = count % 3 == 0 || (gb == 0 && kept < 0);
        vm_real x = b - gb * ((b - a) / (gb - ga)), g;
        if (bisect) x = a + (b - a) / 2;
        x = VMI_SMALLER(VMI_LARGER(x, a + resolution / 2), b - resolution / 2);
        g = vmi_event_value(s, e, x);
        if (g != g) return ODE_NOT_FINITE;
        if (vmi_sign(g) == side) {
            a = x;
            ga = g;
            if (kept > 0) gb /= 2;
            kept = 1;
        } else {
            b = x;
            gb = g;
            if (kept < 0) ga /= 2;
            kept = -1;
        }
    }
    *at = b;
    if (g_look == 0 && vmi_time_inside(s, b) == vmi_time_inside(s, look)) *at = look;
    return ODE_OK;
}

enum { VMI_CHECKS = 3, VMI_MOST_CHECKS = 9999 }; /* default and limit of an event's `checks` */

/* Returns the fraction of the step at which g is evaluated next after e->from. It is the nearest of three fractions:
   the sum start + *gap, the next of the points that divide the step evenly, and `to`. *gap is short at first and grows
   with each call, so that two changes of sign of g in a time much shorter than the step are seen. */
VM_API vm_real vmi_next_look(const ode_event *e, vm_real start, vm_real *gap, vm_real to)
{
    const int wanted = e->checks == 0 ? (int)VMI_CHECKS : e->checks;
    const int checks = VMI_SMALLER(VMI_LARGER(wanted, 0), (int)VMI_MOST_CHECKS);
    const vm_real parts = (vm_real)(checks + 1);
    const int before = (int)(e->from * parts);
    const vm_real even = (vm_real)(before + 1) / parts;
    vm_real next = even;
    if (!(even > e->from)) next = (vm_real)(before + 2) / parts; /* rounding has made `even` equal to e->from */
    next = VMI_SMALLER(next, to);
    if (start + *gap < next) next = start + *gap;
    *gap *= VMI_WIDER;
    return next;
}

/* Sets the side of the event to 0 (uncertain), because g has just reached or passed 0 at the fraction x of the step.
   The side stays 0 while rounding could decide the sign of g, that is while |g| <= e->slack. But it stays 0 at most
   for the time e->quiet: if g has jumped, e->slack is much too large, so that |g| <= e->slack could be true for a long
   time. */
VM_API void vmi_quieten_event(const rk45 *s, ode_event *e, vm_real x)
{
    vmi_weigh_rounding(s, e, x, 0, 0);
    e->side = 0;
    e->quiet = VMI_QUIET * VM_FABS(s->h_done);
}

/* Handles a g that has passed 0 before the fraction x of the step in a direction that does not count. `side` is the
   sign of g at x. If rounding alone could have caused this sign, the side of the event becomes 0 and the result is 1,
   because no event may happen if rounding takes g back across 0. Otherwise nothing changes and the result is 0. */
VM_API int vmi_quieten_passing(const rk45 *s, ode_event *e, vm_real x, int side)
{
    ode_event look = *e;
    if (vmi_weigh_rounding(s, &look, x, 0, side)) return 0;
    vmi_quieten_event(s, e, x);
    return 1;
}

/* Evaluates g along the step from the fraction e->from to the fraction `to`, or until the event happens. *at becomes
   the fraction at which it happens, or VMI_NONE if it does not happen. e->from, e->side and e->quiet become those at
   the last evaluation. Returns a status. */
VM_API int vmi_follow_event(const rk45 *s, ode_event *e, vm_real to, vm_real *at)
{
    const vm_real h = VM_FABS(s->h_done);
    vm_real start = e->from, gap = e->side ? VM_C(1.0) : VMI_FIRST_LOOK;
    *at = VMI_NONE;
    while (e->from < to) {
        const vm_real before = e->from, x = vmi_next_look(e, start, &gap, to);
        const vm_real g = vmi_event_value(s, e, x);
        const int side = vmi_sign(g);
        if (g != g) return ODE_NOT_FINITE;
        if (side != e->side && vmi_counts_from(e, e->side)) {
            const vm_real g_before = vmi_event_value(s, e, before);
            int status = ODE_OK;
            if (g_before != g_before) return ODE_NOT_FINITE;
            *at = x;
            if (vmi_sign(g_before) == e->side) status = vmi_locate(s, e, before, g_before, x, g, at);
            e->from = *at;
            return status;
        }
        e->from = x;
        e->quiet = VMI_LARGER(e->quiet - (x - before) * h, VM_C(0.0));
        if (e->side && side != e->side && vmi_quieten_passing(s, e, x, side)) {
            start = x;
            gap = VMI_FIRST_LOOK;
            continue;
        }
        if (e->side || e->quiet == 0 || VM_FABS(g) > e->slack) e->side = side;
        /* Inside the step (start > 0), gap = 1 ends the evaluations of g at short distances as soon as its sign is
           certain; the evaluations at evenly spaced points go on. At the start of the step the evaluations at short
           distances go on, too: an event there may have changed y or f, so that g may change its sign twice in a short
           time. */
        if (e->side && start > 0) gap = 1;
    }
    return ODE_OK;
}

/* Counts an event that happens at the fraction x of the step. Stores its time and state if the caller's arrays have
   room. */
VM_API void vmi_record(const rk45 *s, ode_event *e, vm_real x)
{
    e->t = vmi_time_inside(s, x);
    if (e->count < e->room) {
        if (e->times) e->times[e->count] = e->t;
        if (e->states) vmi_state_inside(s, x, e->states + e->count * s->n);
    }
    e->count = vmi_count(e->count, 1);
    vmi_quieten_event(s, e, x);
}

/* Finds the first event that ends the step: *cut becomes the fraction of the step at which this event happens, and
   *owner the index of the event. Both stay as they are if no event ends the step. When an event is found, the functions
   g of all other events that can end a step are followed again up to *cut, because their values at *cut may show that
   one of them has an earlier zero. The search ends when there is no earlier zero. Returns a status. */
VM_API int vmi_find_cut(const rk45 *s, vm_real *cut, int *owner)
{
    int i, pass, found = 1;
    for (pass = 0; found; pass++) {
        found = 0;
        for (i = 0; i < s->options.n_events; i++) {
            ode_event *e = s->options.events + i, look;
            vm_real at;
            int status;
            if (!vmi_ends_step(e) || i == *owner) continue;
            look = *e;
            status = vmi_follow_event(s, &look, VMI_SMALLER(*cut, VM_C(1.0)), &at);
            if (status) return status;
            e->side_ahead = look.side;
            e->slack_ahead = look.slack;
            e->quiet_ahead = look.quiet;
            if (pass == 0 && !(at < *cut)) continue;
            if (pass > 0 && !(at < *cut - VMI_FIRST_LOOK)) continue;
            *cut = at;
            *owner = i;
            found = 1;
        }
        if (*cut == VMI_NONE) return ODE_OK;
    }
    return ODE_OK;
}

/* Counts how often the event e, which ends no step, happens up to the fraction `to` of the step, and stores its times
   and states (vmi_record). Returns a status. */
VM_API int vmi_record_until(const rk45 *s, ode_event *e, vm_real to)
{
    for (;;) {
        vm_real at;
        const int status = vmi_follow_event(s, e, to, &at);
        if (status || at == VMI_NONE) return status;
        vmi_record(s, e, at);
    }
}

/* Sets e->happens to 1 if the event e happens at the fraction x of the step, where the step ends, else to 0. The event
   happens if its g has changed sign before x or at x, in a direction that counts. It also happens if g at x is so
   small that rounding could have caused its sign, and g changes sign in such a direction just after x. Events at one
   instant must happen together, because the change that one event makes may keep the others from happening. Returns a
   status. */
VM_API int vmi_happens_at_cut(const rk45 *s, ode_event *e, vm_real x)
{
    ode_event look;
    vm_real at;
    int status = vmi_follow_event(s, e, x, &at);
    e->happens = at != VMI_NONE;
    if (status || e->happens || e->side == 0) return status;
    look = *e;
    if (vmi_weigh_rounding(s, &look, x, 1, e->side)) return ODE_OK;
    if (!vmi_counts_from(e, e->side)) {
        vmi_quieten_event(s, e, x);
        return ODE_OK;
    }
    /* g is followed up to x + VMI_QUIET, which may be after the end of the step (x = 1). The continuous extension
       gives a state there, too, but g may be NaN; the event then does not happen. */
    e->happens = vmi_follow_event(s, &look, x + VMI_QUIET, &at) == ODE_OK && at != VMI_NONE;
    return ODE_OK;
}

/* Ends the step at its fraction x: counts all events that happen there, then calls their `change` functions. Returns
   ODE_EVENT if one of these events stops the run, else ODE_OK. */
VM_API int vmi_cut_step(rk45 *s, vm_real x)
{
    const int n_events = s->options.n_events;
    int i;
    for (i = 0; i < n_events; i++) {
        ode_event *e = s->options.events + i;
        if (!e->happens) continue;
        vmi_record(s, e, x);
        if (vmi_stops_now(e) && s->event < 0) s->event = i;
    }
    if (x < 1) {
        const vm_two t = vmi_two_sum(s->t_old, s->t_old_low + x * s->h_done);
        vmi_inside(s, x, s->y);
        s->t = t.hi;
        s->t_low = t.lo;
    }
    s->k1 = VMI_K1_MISSING;
    for (i = 0; i < n_events; i++) {
        ode_event *e = s->options.events + i;
        if (e->happens && e->action == ODE_RESTART && e->change) e->change(s->t, s->y, e->ctx);
    }
    return s->event < 0 ? (int)ODE_OK : (int)ODE_EVENT;
}

/* Makes the next step a quarter as long as the last one. The last step was undone, because f or the state is not finite
   inside it. Returns ODE_NOT_FINITE if the next step would be shorter than the shortest step allowed, else ODE_OK. */
VM_API int vmi_shorten_step(rk45 *s)
{
    s->h = s->h_done / 4;
    s->rejected = vmi_count(s->rejected, 1);
    s->failed = 1;
    return VM_FABS(s->h) >= vmi_least_step(&s->options, s->t) ? (int)ODE_OK : (int)ODE_NOT_FINITE;
}

/* Decides for each event whether it happens at the fraction `cut` of the step, where the event with the index `owner`
   happens. Returns a status. */
VM_API int vmi_meet_at_cut(rk45 *s, vm_real cut, int owner)
{
    int i, status = ODE_OK;
    for (i = 0; i < s->options.n_events && status == ODE_OK; i++) {
        ode_event *e = s->options.events + i;
        e->happens = 1;
        if (i != owner) status = vmi_happens_at_cut(s, e, cut);
    }
    return status;
}

/* Sets side, slack and quiet of each event to those at the end of the step, if no event has ended the step earlier */
VM_API void vmi_pass_on_sides(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->happens = 0;
        if (!vmi_ends_step(e)) continue;
        e->side = e->side_ahead;
        e->slack = e->slack_ahead;
        e->quiet = e->quiet_ahead;
    }
}

/* Stores in the field `past` of each event the values that its fields have at the beginning of a step */
VM_API void vmi_keep_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->past.count = e->count;
        e->past.t = e->t;
        e->past.slack = e->slack;
        e->past.quiet = e->quiet;
        e->past.side = e->side;
    }
}

/* Undoes the last step, and takes back the counts of its events, because a function of the user failed during the
   search for events or the state at an event is not finite. The next call then makes the same step again, and no event
   is lost. */
VM_API void vmi_take_back_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->count = e->past.count;
        e->t = e->past.t;
        e->slack = e->past.slack;
        e->quiet = e->past.quiet;
        e->side = e->past.side;
    }
    vmi_take_back_step(s);
}

/* Finds the events of the last step, up to the first instant at which an event ends the step. *cut becomes the
   fraction of the step at this instant, or VMI_NONE. The derivatives that the continuous extension needs must be known
   (vmi_extend). Returns a status. */
VM_API int vmi_find_events(rk45 *s, vm_real *cut)
{
    const int n_events = s->options.n_events;
    ode_event *events = s->options.events;
    int i, owner = -1, status;
    *cut = VMI_NONE;
    for (i = 0; i < n_events; i++) events[i].from = 0;
    status = vmi_find_cut(s, cut, &owner);
    for (i = 0; i < n_events && status == ODE_OK; i++)
        if (!vmi_ends_step(events + i)) status = vmi_record_until(s, events + i, VMI_SMALLER(*cut, VM_C(1.0)));
    if (status == ODE_OK && *cut != VMI_NONE) status = vmi_meet_at_cut(s, *cut, owner);
    return status;
}

/* Returns 1 if the state at the fraction x of the last step is finite, else 0. Between two finite states the continuous
   extension may overflow if these states are close to the largest number of the type. The function overwrites the part
   VMI_Z of work. */
VM_API int vmi_is_finite_inside(const rk45 *s, vm_real x)
{
    vm_real *z = vmi_part(s, VMI_Z);
    if (x == 1) return 1;
    vmi_inside(s, x, z);
    return vmi_all_finite(s->n, z);
}

/* Handles the events of the last step, up to the first instant at which an event ends the step. Returns a status.
   After an error the step is undone. If the state at the instant of the event is not finite, the step is undone, too,
   and the next step is shorter. */
VM_API int vmi_events(rk45 *s)
{
    vm_real cut = VMI_NONE;
    int status = vmi_extend(s);
    if (status == ODE_NOT_FINITE) {
        vmi_take_back_step(s);
        return vmi_shorten_step(s);
    }
    vmi_keep_events(s);
    if (status == ODE_OK) status = vmi_find_events(s, &cut);
    if (status) {
        vmi_take_back_events(s);
        return status;
    }
    if (cut != VMI_NONE && !vmi_is_finite_inside(s, cut)) {
        vmi_take_back_events(s);
        return vmi_shorten_step(s);
    }
    if (cut != VMI_NONE) return vmi_cut_step(s, cut);
    vmi_pass_on_sides(s);
    return ODE_OK;
}

#endif
/* integrators/loop.h - the loop of an adaptive run by any pair: it begins or restarts a run and makes its steps
   Users call the functions of rk45.h and rk87.h, which call the functions of this file.

   Tests: tests/test_adaptive.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_LOOP_H
#define VARMASS_INTEGRATORS_LOOP_H

/* Does the work of rk45_init for any pair. The function is inlined, so that the compiler sees which f and n the caller
   gives and can inline f in the steps. */
VM_INLINE int vmi_ode_init(rk45 *s, vmi_rk_pair pair, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                           const rk45_options *options_or_NULL, vm_real *work)
{
    const int status = vmi_init(s, &pair, f, ctx, n, t0, y0, options_or_NULL, work);
    if (status >= 0) {
        s->f = f;
        s->n = n;
    }
    return status;
}

/* Forgets which events have just happened, because the run continues at another time. The side of each event then
   becomes the sign of its g at the new time, even if g is small. */
VM_API void vmi_forget_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) s->options.events[i].quiet = 0;
}

/* Does the work of rk45_restart for any pair */
VM_API int vmi_restart(rk45 *s, vm_real t, const vm_real *y)
{
    if (!s || !y || !VM_IS_FINITE(t) || !vmi_all_finite(s->n, y)) return ODE_BAD_ARGUMENT;
    if (t != s->t) {
        vmi_forget_events(s);
        s->t_low = 0;
    }
    s->t = t;
    s->t_old = t;
    s->t_old_low = s->t_low;
    if (y != s->y) vmi_copy(s->n, y, s->y);
    s->k1 = VMI_K1_MISSING;
    s->failed = 0;
    s->next_miss = s->steps;
    return ODE_OK;
}

/* Prepares a step: evaluates its first derivative k_1 = f(t, y) unless k_1 is known. Gives the step size s->h the sign
   of the direction to t_end. Returns a status. */
VMI_APART int vmi_prepare(rk45 *s, vm_real t_end)
{
    const vm_real left = VM_FABS(vmi_time_left(s, t_end)), longest = VMI_SMALLER(left, s->options.h_max);
    const vm_real direction = vmi_direction(s, t_end);
    vm_real *k1 = vmi_part(s, VMI_K);
    int status = ODE_OK;
    s->t_old = s->t; /* the k of the step before this one are overwritten, even if an error follows */
    s->t_old_low = s->t_low;
    if (s->k1 == VMI_K1_IS_LAST) vmi_copy(s->n, vmi_part(s, vmi_last_k(&s->pair)), k1);
    if (s->k1 == VMI_K1_MISSING) {
        status = vmi_eval(s, s->t, s->y, k1);
        if (status) return status;
        if (!vmi_all_finite(s->n, k1)) return ODE_NOT_FINITE;
        status = vmi_watch_events(s);
        if (status) return status;
    }
    s->k1 = VMI_K1_READY;
    if (s->h == 0) status = vmi_first_step(s, direction, longest);
    if (status) return status;
    s->h = direction * VM_FABS(s->h);
    return ODE_OK;
}

/* A run counts as stiff when VMI_STIFF_HITS tests have found steps at the edge of the pair's stability region. The
   number of such tests is set to 0 when VMI_STIFF_MISSES tests in succession have found steps inside the region. */
enum { VMI_STIFF_HITS = 15, VMI_STIFF_MISSES = 6 };

/* Makes Hairer's test of stiffness [2, IV.2]. A step evaluates f for two states at its end. The two states differ by h
   dz and their derivatives by dk. Then |dk|/|dz| is about h times the largest eigenvalue of the Jacobian of f, if the
   components of y are of similar magnitude; otherwise it may be larger. The test is made only if the two states differ
   by more than 1/1000 of the tolerance, because otherwise dk and dz may be rounding errors. */
VM_API void vmi_look_for_stiffness(rk45 *s)
{
    const int last = vmi_last_k(&s->pair), count = last - VMI_K;
    vm_real dk = 0, dz = 0;
    int i, j, differ = 0;
    for (i = 0; i < s->n; i++) {
        const vm_real difference = VM_FABS(vmi_part(s, last)[i] - vmi_part(s, last - 1)[i]);
        vm_real sum = 0;
        dk = VMI_LARGER(dk, difference);
        for (j = 0; j < count; j++) sum += s->pair.end_difference(j) * vmi_part(s, VMI_K + j)[i];
        dz = VMI_LARGER(dz, VM_FABS(sum));
        if (VM_FABS(s->h_done * sum) > VM_C(1e-3) * vmi_tolerance(&s->options, i, s->y[i])) differ = 1;
    }
    if (differ && dk > s->pair.stiff_beyond * dz) {
        s->stiff_misses = 0;
        if (s->stiff_hits < VMI_STIFF_HITS) s->stiff_hits++;
        if (s->stiff_hits == VMI_STIFF_HITS) s->stiff = 1;
    } else {
        if (s->stiff_misses < VMI_STIFF_MISSES) s->stiff_misses++;
        if (s->stiff_misses == VMI_STIFF_MISSES) s->stiff_hits = 0;
    }
    s->stiff_wait = VMI_STIFF_WAIT;
    if (s->stiff_hits) s->stiff_wait = 1;
}

/* Does what must follow an accepted step: tests for stiffness if a test is due, and handles the events within the step.
   Returns a status. */
VMI_APART int vmi_after_step(rk45 *s)
{
    if (s->stiff_wait <= 0) vmi_look_for_stiffness(s);
    if (s->options.n_events == 0) return ODE_OK;
    return vmi_events(s);
}

/* Returns 1 if the time s->t + s->t_low of the state is still before t_end in the direction of the run, else 0. */
VM_INLINE int vmi_is_before(const rk45 *s, vm_real t_end) { return s->t != t_end || -s->t_low * s->h > 0; }

/* Makes steps to t_end, or one accepted step if `single` is not 0. f and n are those of s. Returns a status. */
VMI_FOLDED int vmi_run(rk45 *s, vmi_rk_stepper stepper, ode_rhs f, int n, vm_real t_end, int single)
{
    const int was_stiff = s->stiff;
    const int apart = single || s->options.n_events; /* not 0: vmi_advance returns after each step */
    vmi_rk_system sys;
    int status = ODE_OK;
    sys.f = f;
    sys.ctx = s->ctx;
    sys.n = n;
    sys.w = s->work;
    sys.m = n;
    s->event = -1;
    while (status == ODE_OK && vmi_is_before(s, t_end)) {
        status = vmi_prepare(s, t_end);
        if (status) break;
        if (VMI_IS_SMALL(n)) status = vmi_advance_small(s, stepper, sys, t_end, apart);
        else status = vmi_advance(s, stepper, sys, t_end, apart);
        if (status == ODE_OK) status = vmi_after_step(s);
        if (single && s->failed == 0) break;
    }
    return status == ODE_OK && s->stiff > was_stiff ? (int)ODE_STIFF : status;
}

/* Prepares the one step of rk45_step, for the pair whose number is `method`. *t_end becomes VM_MAX, or -VM_MAX if the
   run goes backward. Returns a status; the step may be made if the status is ODE_OK. */
VM_INLINE int vmi_begin_step(rk45 *s, int method, vm_real *t_end)
{
    if (!s || s->pair.method != method) return ODE_BAD_ARGUMENT;
    *t_end = VM_MAX;
    if (s->h < 0) *t_end = -VM_MAX;
    if (s->t == *t_end) return ODE_STEP_TOO_SMALL;
    s->attempts = -1;
    return ODE_OK;
}

/* Prepares the steps of rk45_solve_with, for the pair whose number is `method`. t_end may be infinite if an event can
   end the run. Returns a status; the steps may be made if the status is ODE_OK. */
VM_INLINE int vmi_begin_solve(rk45 *s, int method, ode_rhs f, int n, vm_real t_end)
{
    if (!s || t_end != t_end || s->pair.method != method || f != s->f || n != s->n) return ODE_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t_end) && !vmi_an_event_stops(&s->options)) return ODE_BAD_ARGUMENT;
    s->attempts = s->options.max_steps;
    return ODE_OK;
}

/* Returns the time at which the steps of a run to t_end end: t_end, or the largest number of the type if t_end is
   infinite */
VM_INLINE vm_real vmi_last_time(vm_real t_end)
{
    if (t_end > VM_MAX) return VM_MAX;
    if (t_end < -VM_MAX) return -VM_MAX;
    return t_end;
}

/* Returns the status of a run to t_end whose steps have ended with `status`. If t_end is infinite and the steps have
   ended without an error or an event, t has reached the largest number of the type, and the status is
   ODE_STEP_TOO_SMALL. */
VM_INLINE int vmi_end_solve(vm_real t_end, int status)
{
    if (!VM_IS_FINITE(t_end) && (status == ODE_OK || status == ODE_STIFF)) return ODE_STEP_TOO_SMALL;
    return status;
}

#endif
/* integrators/rk45.h - rk45: adaptive runs by a Runge-Kutta pair of orders 5 and 4
   Tsitouras' pair [1] has seven stages. The last stage of a step is also the first stage of the next step, so that a
   step takes six evaluations of f. The continuous extension of order 4, which gives the states inside a step, takes no
   further evaluation. Try this method first. It is better than rk87 in float, for loose tolerances, for right-hand
   sides that are not smooth, and for many events.

       double y0[2] = {1, 0}, work[RK45_WORK(2)];
       rk45 s;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       if (rk45_solve(&s, 10.0) >= 0) printf("x(10) = %g\n", s.y[0]);

   Tests: tests/gen/order_conditions.py, tests/test_adaptive.c, tests/test_dense.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_RK45_H
#define VARMASS_INTEGRATORS_RK45_H

enum { VMI_RK45 = 45 }; /* the value of the field `method` for this pair, rk45 */

/* Computes stages 2 to 7 of a step of Tsitouras' pair [1]. Its coefficients, which are published to 16 digits, satisfy
   the order conditions with an error of 2e-14. */
VMI_FOLDED int vmi_rk45_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m;
    int i;
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.161) * k1[i];
    VMI_EVAL(t + VMI_H(0.161), z, k2);
    VMI_EACH(i, sys.n) z[i] = y[i] - VMI_H(0.008480655492356989) * k1[i] + VMI_H(0.335480655492357) * k2[i];
    VMI_EVAL(t + VMI_H(0.327), z, k3);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(2.8971530571054935) * k1[i] - VMI_H(6.359448489975075) * k2[i] +
           VMI_H(4.3622954328695815) * k3[i];
    VMI_EVAL(t + VMI_H(0.9), z, k4);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(5.325864828439257) * k1[i] - VMI_H(11.748883564062828) * k2[i] +
           VMI_H(7.4955393428898365) * k3[i] - VMI_H(0.09249506636175525) * k4[i];
    VMI_EVAL(t + VMI_H(0.9800255409045097), z, k5);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(5.86145544294642) * k1[i] - VMI_H(12.92096931784711) * k2[i] +
           VMI_H(8.159367898576159) * k3[i] - VMI_H(0.071584973281401) * k4[i] -
           VMI_H(0.028269050394068383) * k5[i];
    VMI_EVAL(t_new, z, k6);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(0.09646076681806523) * k1[i] + VMI_H(0.01) * k2[i] + VMI_H(0.4798896504144996) * k3[i] +
           VMI_H(1.379008574103742) * k4[i] - VMI_H(3.290069515436081) * k5[i] + VMI_H(2.324710524099774) * k6[i];
    VMI_EVAL(t_new, z, k7);
    return 0;
}

/* Returns the largest ratio of the error of a component to its tolerance, at most VMI_WORST, or NaN if the error or the
   new state is not finite. The error is the difference of the two new states, of order 5 and of order 4. */
VMI_FOLDED vm_real vmi_rk45_error(const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m, *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m,
                  *k4 = k3 + m, *k5 = k4 + m, *k6 = k5 + m, *k7 = k6 + m;
    vm_real worst = 0, bad = 0;
    int i;
    VMI_EACH(i, sys.n)
    vmi_weigh(o, i,
              h * (VM_C(-0.00178001105222577714) * k1[i] - VM_C(0.0008164344596567469) * k2[i] +
                   VM_C(0.007880878010261995) * k3[i] - VM_C(0.1447110071732629) * k4[i] +
                   VM_C(0.5823571654525552) * k5[i] - VM_C(0.45808210592918697) * k6[i] +
                   VM_C(0.01515151515151515152) * k7[i]),
              y[i], z[i], &worst, &bad);
    return VMI_SMALLER(worst, VMI_WORST) + bad;
}

/* Returns, for the test of stiffness, the factor of k_{j+1} in the state of stage 7 minus its factor in the state of
   stage 6. Both stages evaluate f at the end of the step. */
VM_API vm_real vmi_rk45_end_difference(int j)
{
    VM_TABLE vm_real weights[6] = {VM_C(-5.764994676128355), VM_C(12.93096931784711),   VM_C(-7.67947824816166),
                                   VM_C(1.4505935473851428), VM_C(-3.2618004650420125), VM_C(2.324710524099774)};
    return VM_READ(weights[j]);
}

/* Computes the weights b[0], b[1] ... of k_1, k_2 ... in Tsitouras' continuous extension [1], which has order 4, at
   the fraction x of the step */
VM_API void vmi_rk45_weights(vm_real x, vm_real *b)
{
    const vm_real xx = x * x;
    b[0] = VM_C(-1.0530884977290216) * x * (x - VM_C(1.3299890189751412)) *
           ((x - VM_C(1.4364028541716351)) * x + VM_C(0.7139816917074209));
    b[1] = VM_C(0.1017) * xx * ((x - VM_C(2.1966568338249754)) * x + VM_C(1.2949852507374631));
    b[2] = VM_C(2.490627285651252793) * xx * ((x - VM_C(2.38535645472061657)) * x + VM_C(1.57803468208092486));
    b[3] = VM_C(-16.54810288924490272) * xx * (x - VM_C(1.21712927295533244)) * (x - VM_C(0.61620406037800089));
    b[4] = VM_C(47.37952196281928122) * xx * (x - VM_C(1.203071208372362603)) * (x - VM_C(0.658047292653547382));
    b[5] = VM_C(-34.87065786149660974) * xx * (x - VM_C(1.2)) * (x - VM_C(0.666666666666666667));
    b[6] = VM_C(2.5) * xx * (x - 1) * (x - VM_C(0.6));
}

/* Computes the state y at the fraction x of the last step by the continuous extension. The function is not inlined, so
   that the compiler fuses its multiplications and additions in one way only: equal x give equal y. */
VMI_APART void vmi_rk45_inside(const rk45 *s, vm_real x, vm_real *y)
{
    vm_real b[7];
    vmi_rk45_weights(x, b);
    vmi_weigh_inside(s, 7, b, x, y);
}

/* Returns the descriptor of rk45: its vmi_rk_pair. */
VMI_FOLDED vmi_rk_pair vmi_rk45_pair(void)
{
    vmi_rk_pair pair;
    pair.method = VMI_RK45;
    pair.order = 5;
    pair.stages = 7;
    pair.last_is_first = 1;
    pair.derivatives = 7;
    pair.rounding = 16;
    pair.keep_from = VM_C(0.25);
    pair.stiff_beyond = VM_C(3.4);
    pair.end_difference = vmi_rk45_end_difference;
    pair.inside = vmi_rk45_inside;
    pair.extend = NULL;
    return pair;
}

/* Makes steps of rk45 to t_end, or only one if `single` is not 0. f and n are those of s. Returns a status. */
VMI_LOOP int vmi_rk45_run(rk45 *s, ode_rhs f, int n, vm_real t_end, int single)
{
    vmi_rk_stepper stepper;
    stepper.pair = vmi_rk45_pair();
    stepper.make_stages = vmi_rk45_stages;
    stepper.step_error = vmi_rk45_error;
    return vmi_run(s, stepper, f, n, t_end, single);
}

/* -- Functions for users -- */

#define RK45_WORK(n) (10 * (n)) /* number of elements of the array work for n components */

/* Returns the options of rk45 as rk45_init uses them. Each zero is replaced by its default (h0 and h_min stay 0), each
   negative tolerance by 0, and a positive rtol below 16 VM_EPSILON by 16 VM_EPSILON. If options_or_NULL is NULL, all
   options have their defaults. Do not pass a result with a tolerance 0 to rk45_init, which would replace this 0 by the
   default. */
VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL)
{
    const vmi_rk_pair pair = vmi_rk45_pair();
    return vmi_defaults(vmi_least_rtol(&pair), options_or_NULL);
}

/* Begins a run of y' = f(t, y) by rk45 from state y0 at time t0. y0 has n numbers, f receives the pointer ctx, and work
   has RK45_WORK(n) numbers and must exist as long as s. y0 and the options are copied, but not the arrays to which the
   options point. f is not evaluated yet. Returns ODE_OK; ODE_RTOL_RAISED if rtol was too small and was raised;
   ODE_BAD_ARGUMENT if an argument or an option is wrong; ODE_WORK_TOO_SMALL if options_or_NULL->work_size is too
   small. */
VM_INLINE int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk45_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk45_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Continues a run of rk45 from another time or state, such as after a jump. The step size and the counters are kept. y
   has n numbers and may be s->y. If t is s->t, events that have just happened are not found again. Returns ODE_OK, or
   ODE_BAD_ARGUMENT if s or y is NULL or a number is not finite. */
VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* Makes one accepted step of rk45, or the part of it before an event that ends the step. The step goes forward if s->h
   is positive or 0, and backward if s->h is negative; s->h is at first the option h0. Returns a status. */
VM_INLINE int rk45_step(rk45 *s)
{
    vm_real t_end;
    const int status = vmi_begin_step(s, VMI_RK45, &t_end);
    if (status) return status;
    return vmi_rk45_run(s, s->f, s->n, t_end, 1);
}

/* Makes steps of rk45 to t_end. The caller gives f and n once more, so that the compiler can inline f. It inlines f if
   f and n are constants in this call, wherever rk45_init was called. Returns ODE_BAD_ARGUMENT if f or n differs from
   the f or n of s. All else is as in rk45_solve. */
VM_INLINE int rk45_solve_with(rk45 *s, ode_rhs f, int n, vm_real t_end)
{
    const int status = vmi_begin_solve(s, VMI_RK45, f, n, t_end);
    if (status) return status;
    return vmi_end_solve(t_end, vmi_rk45_run(s, f, n, vmi_last_time(t_end), 0));
}

/* Makes steps of rk45 to t_end exactly, forward or backward, or to an event that ends the run. t_end may be infinite if
   there is such an event. If s->t is t_end already, s->event becomes -1 and s->y changes only by rounding errors: if an
   event has ended the last step just before t_end, a step shorter than the resolution of t is made. After an error s->t
   and s->y are those of the last accepted step. Returns a status. The status is ODE_MAX_STEPS after options.max_steps
   attempts; another call then continues the run. */
VM_INLINE int rk45_solve(rk45 *s, vm_real t_end)
{
    if (!s) return ODE_BAD_ARGUMENT;
    return rk45_solve_with(s, s->f, s->n, t_end);
}

/* Computes the state y(t) at a time t within the last step of rk45, accurate to order 4. y receives n numbers; f is not
   evaluated. Returns ODE_OK, or ODE_BAD_ARGUMENT if t is not between s->t_old and s->t. */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y) { return vmi_interpolate_ready(s, VMI_RK45, t, y); }

#endif
/* integrators/rk87.h - rk87: adaptive runs by a Runge-Kutta pair of orders 8 and 7
   Verner's "most efficient" pair [4] has 13 stages. Its continuous extension of order 8, which gives the states inside
   a step, takes seven more evaluations of f in each step in which it is used. The coefficients of the pair are up to
   123, so that its rounding errors are larger than those of rk45. Use rk87 for a smooth f in double, where the errors
   must be small.

   Tests: tests/gen/order_conditions.py, tests/test_adaptive.c, tests/test_dense.c. */
#ifndef VARMASS_INTEGRATORS_RK87_H
#define VARMASS_INTEGRATORS_RK87_H

enum { VMI_RK87 = 87 }; /* the value of the field `method` for this pair, rk87 */

/* Computes stages 2 to 7 of a step of Verner's pair [4]. Returns 0, or the number with which f has stopped the run. */
VMI_FOLDED int vmi_rk87_early_stages(vmi_rk_system sys, vm_real t, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m;
    int i;
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.05) * k1[i];
    VMI_EVAL(t + VMI_H(0.05), z, k2);
    VMI_EACH(i, sys.n) z[i] = y[i] - VMI_H(0.0069931640625) * k1[i] + VMI_H(0.1135556640625) * k2[i];
    VMI_EVAL(t + VMI_H(0.1065625), z, k3);
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.0399609375) * k1[i] + VMI_H(0.1198828125) * k3[i];
    VMI_EVAL(t + VMI_H(0.15984375), z, k4);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + h * (VM_C(0.36139756280045751241) * k1[i] - VM_C(1.3415240667004927718) * k3[i]) +
           VMI_H(1.3701265039000352594) * k4[i];
    VMI_EVAL(t + VMI_H(0.39), z, k5);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + h * (VM_C(0.049047202797202797203) * k1[i] + VM_C(0.23509720422144047399) * k4[i]) +
           VMI_H(0.18085559298135672881) * k5[i];
    VMI_EVAL(t + VMI_H(0.465), z, k6);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(0.06169289044289044289) * k1[i] + VM_C(0.11236568314640276623) * k4[i] -
                VM_C(0.03885046071451366767) * k5[i]) +
           VMI_H(0.019791887125220458554) * k6[i];
    VMI_EVAL(t + VMI_H(0.155), z, k7);
    return 0;
}

/* Computes stages 8 to 13 of a step of Verner's pair [4], and the new state, whose derivative is evaluated only after
   the step is accepted. Some large coefficients, which have opposite signs, belong to derivatives k at nearly equal
   times, such as k_4 and k_7. Therefore the sums use the differences of these derivatives. The difference of two
   nearly equal numbers has no rounding error, so that the rounding errors of the sums are small. Returns 0, or the
   number with which f has stopped the run. */
VMI_FOLDED int vmi_rk87_late_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k4 = k1 + 3 * m, *k5 = k4 + m, *k6 = k5 + m, *k7 = k6 + m,
            *k8 = k7 + m, *k9 = k8 + m, *k10 = k9 + m, *k11 = k10 + m, *k12 = k11 + m, *k13 = k12 + m;
    int i;
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.7676302402223268757) * k1[i] - VM_C(6.0618893773766691008) * k5[i] +
                VM_C(5.6508231982227631386) * k6[i] + VM_C(3.121696419376232838) * k7[i]) -
           VMI_H(62.5) * (k4[i] - k7[i]);
    VMI_EVAL(t + VMI_H(0.943), z, k8);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.1809450665549707998) * k1[i] - VM_C(4.4344383191037250112) * k5[i] +
                VM_C(4.2604081885861330248) * k6[i] + VM_C(2.2489058133185074338) * k7[i] -
                VM_C(41.504734411143208416) * (k4[i] - k7[i])) +
           VMI_H(0.0078714254899123106874) * k8[i];
    VMI_EVAL(t + VMI_H(0.90180204173585695826), z, k9);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.2814059994414884055) * k1[i] - VM_C(4.7313620694495764773) * k5[i] +
                VM_C(4.5149670165938078412) * k6[i] + VM_C(2.4019556115899850465) * k7[i] -
                VM_C(45.047139960139866302) * (k4[i] - k7[i]) + VM_C(0.010592282971116611357) * k8[i]) -
           VMI_H(0.0057468422638446162544) * k9[i];
    VMI_EVAL(t + VMI_H(0.909), z, k10);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.7244701342624851918) * k1[i] - VM_C(5.9515183762223924552) * k5[i] +
                VM_C(5.556523730698456236) * k6[i] + VM_C(3.0595218955025132032) * k7[i] -
                VM_C(60.923490084830540165) * (k4[i] - k7[i]) + VM_C(0.014642028250414961593) * k8[i] +
                VM_C(0.064604087723582036036) * k9[i]) -
           VMI_H(0.07930323169008878984) * k10[i];
    VMI_EVAL(t + VMI_H(0.94), z, k11);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-3.3016226677470790164) * k1[i] - VM_C(10.141422388456112486) * k5[i] +
                VM_C(9.1393113322320579235) * k6[i] + VM_C(5.3646704686517598018) * k7[i] -
                VM_C(118.01127235975250857) * (k4[i] - k7[i]) + VM_C(4.6232443788745804748) * k8[i] -
                VM_C(3.3832777380682019237) * k9[i] + VM_C(4.5275921003246181895) * k10[i]) -
           VMI_H(5.8284954858116229632) * k11[i];
    VMI_EVAL(t_new, z, k12);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-3.03951503376630903) * k1[i] - VM_C(9.2906424974002934497) * k5[i] +
                VM_C(8.4305049817649111421) * k6[i] + VM_C(4.9401329484155058871) * k7[i] -
                VM_C(109.26086808941762547) * (k4[i] - k7[i]) - VM_C(0.96372713421454793582) * k8[i] -
                VM_C(5.0348840888021897912) * k9[i]) +
           VMI_H(5.9581308240029231775) * k10[i];
    VMI_EVAL(t_new, z, k13);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(0.044279894190079510747) * k1[i] + VM_C(0.35410493917244487448) * k6[i] +
                VM_C(0.24796921549564378287) * k7[i] - VM_C(6.6543028207017138549) * k10[i] +
                VM_C(25.084064965558562613) * (k9[i] - k10[i]) + VM_C(7.2440812351506999013) * k11[i] -
                VM_C(15.694202038838084051) * (k8[i] - k11[i])) -
           VMI_H(0.23613246330715421453) * k12[i];
    return 0;
}

/* Computes stages 2 to 13 and the new state of a step */
VMI_FOLDED int vmi_rk87_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const int stopped = vmi_rk87_early_stages(sys, t, h, evals);
    if (stopped) return stopped;
    return vmi_rk87_late_stages(sys, t, t_new, h, evals);
}

/* Estimates the error that a jump of f inside a step of size 1 causes in a component whose derivatives are k1 ... k13.
   This error is up to a quarter of the jump. The difference of the results of orders 8 and 7 is nearly the same with
   and without a jump in the first nine tenths of the step: in this difference the weights of the k before the jump add
   up to 4.2e-4 at most. `seen` is the magnitude of another sum of the k, of order 5. In this sum the weights of the k
   before the jump add up in magnitude to
     0.11 for a jump before 0.155 of the step (only k1 is before it), 0.17 for a jump between 0.155 and 0.465 (k1 and
     k7 are before it), 0.25 for a jump between 0.465 and 0.9 (k1, k7 and k6 are before it).
   If f is smooth, `seen` is much smaller than `change`, the change of f along the step. The returned value
   seen^2/(seen + change) is then of order 9. It is smaller than the difference of the results of orders 8 and 7,
   unless the tolerance is loose. */
VM_INLINE vm_real vmi_rk87_jump(vm_real k1, vm_real k6, vm_real k7, vm_real k9, vm_real k10, vm_real k13)
{
    const vm_real seen = VM_FABS(VM_C(-0.10566347241843193175) * (k1 - k6) + VM_C(0.27305974723615654296) * (k7 - k6) -
                                 VM_C(1.2953622033829957737) * (k10 - k6) + VM_C(1.5453622033829957737) * (k13 - k6) +
                                 VM_C(30.024202087387960709) * (k9 - k10));
    const vm_real change = VM_FABS(k1 - k6) + VM_FABS(k13 - k6);
    return seen * (seen / (seen + change + VM_MIN));
}

/* Returns the largest ratio of the error of a component to its tolerance, at most VMI_WORST, or NaN if the error or the
   new state is not finite. The error is the larger of two numbers: the difference of the new states of orders 8 and 7,
   and the error that a jump of f may cause (vmi_rk87_jump). */
VMI_FOLDED vm_real vmi_rk87_error(const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m, *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m;
    const vm_real *k6 = k1 + 5 * m, *k7 = k6 + m, *k8 = k7 + m, *k9 = k8 + m, *k10 = k9 + m, *k11 = k10 + m,
                  *k12 = k11 + m, *k13 = k12 + m;
    vm_real worst = 0, bad = 0;
    int i;
    VMI_EACH(i, sys.n)
    {
        const vm_real smooth = VM_C(-0.000032721039010281377697) * k1[i] - VM_C(0.00050462506187777030476) * k6[i] +
                               VM_C(0.00012117235897847590476) * k7[i] - VM_C(20.142336771313868544) * k8[i] +
                               VM_C(5.2371785994398289141) * k9[i] - VM_C(8.1567444087946580486) * k10[i] +
                               VM_C(22.938283273988783952) * k11[i] - VM_C(0.23613246330715421453) * k12[i] +
                               VM_C(0.36016794372897751621) * k13[i];
        const vm_real jump = vmi_rk87_jump(k1[i], k6[i], k7[i], k9[i], k10[i], k13[i]);
        vmi_weigh(o, i, h * (jump > VM_FABS(smooth) ? jump : smooth), y[i], z[i], &worst, &bad);
    }
    return VMI_SMALLER(worst, VMI_WORST) + bad;
}

/* Returns, for the test of stiffness, the factor of k_{j+1} in the new state minus its factor in the state of stage 13.
   The run evaluates f for both states at the end of the step. */
VM_API vm_real vmi_rk87_end_difference(int j)
{
    VM_TABLE vm_real weights[13] = {VM_C(3.0837949279563885408),
                                    0,
                                    0,
                                    VM_C(109.26086808941762547),
                                    VM_C(9.2906424974002934497),
                                    VM_C(-8.0764000425924662677),
                                    VM_C(-113.95303182233748757),
                                    VM_C(-14.730474904623536115),
                                    VM_C(30.118949054360752405),
                                    VM_C(-37.696498610263199646),
                                    VM_C(22.938283273988783952),
                                    VM_C(-0.23613246330715421453),
                                    0};
    return VM_READ(weights[j]);
}

/* The number of k_i that a step itself computes, and the number that the continuous extension adds */
#define VMI_RK87_OWN 14
#define VMI_RK87_EXTRA 7

/* Returns the coefficient of k_{j+1} in the stage of the continuous extension that evaluates k_{15+stage}. */
VM_API vm_real vmi_rk87_extra_coefficient(int stage, int j)
{
    VM_TABLE vm_real a[7][20] = {
        {VM_C(0.046207006467549631017), 0, 0, 0, 0, VM_C(0.045039041608424808668), VM_C(0.23368166977134244108),
         VM_C(37.839013684210674108), VM_C(-15.949113289454246103), VM_C(23.028368351816102851),
         VM_C(-44.855785077694125248), VM_C(-0.063798587686474440095), 0, VM_C(-0.012595035543861662682)},
        {VM_C(0.050379468554820409931), 0, 0, 0, 0, VM_C(0.041098361310460793399), VM_C(0.17180541533481957833),
         VM_C(4.6141053199815188697), VM_C(-1.7916678830853964497), VM_C(2.5316589304850414085),
         VM_C(-5.3249778602057307193), VM_C(-0.030655325953856347349), 0, VM_C(-0.0052544799794296135705),
         VM_C(-0.083991946442247929975)},
        {VM_C(0.040828971329970796202), 0, 0, 0, 0, VM_C(0.42444795142476322189), VM_C(0.23260915312752345395),
         VM_C(2.6779825207118060628), VM_C(0.74208266573389452165), VM_C(0.14603778479414611939),
         VM_C(-3.579344509890565218), VM_C(0.11388443896001737045), 0, VM_C(0.012677906510331900474),
         VM_C(-0.074434363499466744298), VM_C(0.047827480797578515546)},
        {VM_C(0.052126823936684136299), 0, 0, 0, 0, VM_C(0.053925083967447977182), VM_C(0.016607580974346408285),
         VM_C(-4.4544857579267796554), VM_C(6.8352182786321463817), VM_C(-8.7113348221819937398),
         VM_C(6.4916358392329170537), VM_C(-0.070725518098443464221), 0, VM_C(-0.018540314919932164291),
         VM_C(0.023504021054353846451), VM_C(0.23447951034078220906), VM_C(-0.082410725011528988858)},
        {VM_C(0.050201028703557135987), 0, 0, 0, 0, VM_C(0.15522090347954981149), VM_C(0.12642684240892349147),
         VM_C(-5.149206303539847017), VM_C(8.4683409990369292661), VM_C(-10.662130681081495275),
         VM_C(7.5418332249597283629), VM_C(-0.074369681138321424394), 0, VM_C(-0.020558876866183826193),
         VM_C(0.077537952647102980726), VM_C(0.10462592203525442963), VM_C(-0.11792133064519793521)},
        {VM_C(0.037373414464578256928), 0, 0, 0, 0, VM_C(0.35049307053383164068), VM_C(0.49226528193730254333),
         VM_C(8.5536954393593122423), VM_C(-10.353172990305913485), VM_C(13.833204272529149904),
         VM_C(-12.280924330784618637), VM_C(0.17191515956565097627), 0, VM_C(0.036415831143144963801),
         VM_C(0.029619205802887630549), VM_C(-0.26517939386270670026), VM_C(0.094295039617380665532)},
        {VM_C(0.039390583455282509434), 0, 0, 0, 0, VM_C(0.35585161412344241831), VM_C(0.41973822259526100294),
         VM_C(0.87204497780719416629), VM_C(0.89895208348765948613), VM_C(-0.63058061610598835902),
         VM_C(-1.1218872205954835507), VM_C(0.04298219512400197177), 0, VM_C(0.01332557566873915707),
         VM_C(0.018762270539641480344), VM_C(-0.18594111329221055705), VM_C(0.17736142719246027452)}};
    return VM_READ(a[stage][j]);
}

/* Evaluates the seven further stages that the continuous extension of order 8 needs. If the derivative at the end of
   the step is not finite, it is evaluated again first. Returns a status. If one of these stages lies outside the
   domain of f, the status is ODE_NOT_FINITE; this may happen even if all stages of the step itself lie inside the
   domain. */
VM_API int vmi_rk87_extend(rk45 *s)
{
    VM_TABLE vm_real c[7] = {
        VM_C(0.31101776349538638639), VM_C(0.1725), VM_C(0.7846), VM_C(0.37), VM_C(0.5), VM_C(0.7), VM_C(0.9)};
    const vm_real *k1 = vmi_part(s, VMI_K), *y_old = vmi_part(s, VMI_Y_OLD);
    vm_real *z = vmi_part(s, VMI_Z), *last_k = vmi_part(s, vmi_last_k(&s->pair));
    int i, j, stage, status = ODE_OK;
    if (!vmi_all_finite(s->n, last_k)) status = vmi_eval(s, s->t, s->y, last_k);
    if (status) return status;
    if (!vmi_all_finite(s->n, last_k)) return ODE_NOT_FINITE;
    for (stage = 0; stage < VMI_RK87_EXTRA; stage++) {
        vm_real *k = vmi_part(s, VMI_K + VMI_RK87_OWN + stage);
        for (i = 0; i < s->n; i++) {
            vm_real sum = 0;
            for (j = 1; j < VMI_RK87_OWN + stage; j++)
                sum += vmi_rk87_extra_coefficient(stage, j) * (vmi_part(s, VMI_K + j)[i] - k1[i]);
            z[i] = y_old[i] + s->h_done * (VM_READ(c[stage]) * k1[i] + sum);
        }
        status = vmi_eval(s, s->t_old + VM_READ(c[stage]) * s->h_done, z, k);
        if (status) return status;
        if (!vmi_all_finite(s->n, k)) return ODE_NOT_FINITE;
    }
    return ODE_OK;
}

/* Returns coefficient i of the polynomial b_{j+1}(x)/x, if this polynomial is written as a sum of Bernstein's
   polynomials of degree 7. b_{j+1}(x) is the weight of k_{j+1} in the continuous extension. In powers of x the
   coefficients would be larger [4]. */
VM_API vm_real vmi_rk87_bernstein(int i, int j)
{
    VM_TABLE vm_real c[8][21] = {
        {VM_C(1.0)},
        {VM_C(-0.43416495007921699754), 0, 0, 0, 0, VM_C(22.599667701739659115), VM_C(15.825878858282545737),
         VM_C(-1001.6345768873305842), VM_C(1600.9139385497353343), VM_C(-2025.6045200650977012),
         VM_C(1463.9659668459635268), VM_C(-15.07043425264423982), 0, VM_C(-2.1233733390382044607),
         VM_C(2.0499551075579231761), VM_C(-14.649321001586286937), VM_C(-5.4474375904092477119),
         VM_C(-9.4832565472422686612), VM_C(-12.916982247390083982), VM_C(-8.5341205186269588664),
         VM_C(-8.4572196638341962641)},
        {VM_C(0.69319890739505714536), 0, 0, 0, 0, VM_C(-28.322636845067825264), VM_C(-19.833504880369087028),
         VM_C(1255.2809513415663983), VM_C(-2006.3172919246540112), VM_C(2538.5533084238865914),
         VM_C(-1834.6896502962782204), VM_C(18.886757189012005795), 0, VM_C(2.6943768290163844672),
         VM_C(-3.0569914252730377376), VM_C(21.845770438002692514), VM_C(8.1234803348592602041),
         VM_C(9.4063330192350021072), VM_C(18.54462542925865921), VM_C(8.8787596622304847795),
         VM_C(10.312513797179645635)},
        {VM_C(-0.3338485911070980487), 0, 0, 0, 0, VM_C(25.558764868971263012), VM_C(17.898047082901598187),
         VM_C(-1132.7840290910181075), VM_C(1810.5302905715595678), VM_C(-2290.8279152212470487),
         VM_C(1655.6509775545015219), VM_C(-17.043688014358484614), 0, VM_C(-2.3369125341274148978),
         VM_C(2.6643387606508049922), VM_C(-19.039809026959079785), VM_C(-7.0800668096793834609),
         VM_C(-5.8665758746530908169), VM_C(-18.840844904715375167), VM_C(-7.4879415981794647994),
         VM_C(-9.6607871725402081249)},
        {VM_C(0.28379400641185437856), 0, 0, 0, 0, VM_C(-12.759481686923881245), VM_C(-8.9350876365402469061),
         VM_C(565.50999817576301139), VM_C(-903.85541729421673952), VM_C(1143.6302568613132692),
         VM_C(-826.5363540196210053), VM_C(8.5085733294123855395), 0, VM_C(1.0603712833693789051),
         VM_C(-1.4442533272143088419), VM_C(10.320875086467535406), VM_C(3.837879100734673622),
         VM_C(2.5580949193757614888), VM_C(11.224293673899100669), VM_C(2.4797359224550151757),
         VM_C(5.1167216053141960113)},
        {VM_C(0.0072914402964293461022), 0, 0, 0, 0, VM_C(3.7687355910342448606), VM_C(2.6391340660294149651),
         VM_C(-167.03324707890411572), VM_C(266.9694713223930137), VM_C(-337.79115467001014473),
         VM_C(244.13193663420704719), VM_C(-2.5131556220142955157), 0, VM_C(-0.17281686321712024563),
         VM_C(0.3583670958947128915), VM_C(-2.5609510202503622271), VM_C(-0.95230494665234715357),
         VM_C(-0.5896647722763897408), VM_C(-2.8631165722737584704), VM_C(-0.47177361047292321216),
         VM_C(-1.9267509937834059465)},
        {VM_C(0.050605593360090869425), 0, 0, 0, 0, VM_C(0.40469135905422271369), VM_C(0.28339338913787860899),
         VM_C(-17.936230901529238915), VM_C(28.667502817781214415), VM_C(-36.272420327154601678),
         VM_C(26.215180884558610231), VM_C(-0.26986567235103338803), 0, VM_C(-0.14285714285714285714)},
        {VM_C(0.044279894190079510747), 0, 0, 0, 0, VM_C(0.35410493917244487448), VM_C(0.24796921549564378287),
         VM_C(-15.694202038838084051), VM_C(25.084064965558562613), VM_C(-31.738367786260276468),
         VM_C(22.938283273988783952), VM_C(-0.23613246330715421453)}};
    return VM_READ(c[i][j]);
}

/* Computes the weights b[0], b[1] ... of k_1, k_2 ... in Verner's continuous extension [4], which has order 8, at the
   fraction x of the step */
VM_API void vmi_rk87_weights(vm_real x, vm_real *b)
{
    VM_TABLE vm_real binomial[8] = {1, 7, 21, 35, 35, 21, 7, 1};
    const int count = VMI_RK87_OWN + VMI_RK87_EXTRA;
    const vm_real u = 1 - x;
    vm_real powers[8], power = x; /* powers[i] is (1 - x)^i, and power is x^(i + 1) */
    int i, j;
    powers[0] = 1;
    for (i = 1; i < 8; i++) powers[i] = powers[i - 1] * u;
    for (j = 0; j < count; j++) b[j] = 0;
    for (i = 0; i < 8; i++) {
        const vm_real bernstein = VM_READ(binomial[i]) * power * powers[7 - i];
        for (j = 0; j < count; j++) b[j] += bernstein * vmi_rk87_bernstein(i, j);
        power *= x;
    }
}

/* Computes the state y at the fraction x of the last step by the continuous extension. The function is not inlined, so
   that the compiler fuses its multiplications and additions in one way only: equal x give equal y. */
VMI_APART void vmi_rk87_inside(const rk45 *s, vm_real x, vm_real *y)
{
    vm_real b[VMI_RK87_OWN + VMI_RK87_EXTRA];
    vmi_rk87_weights(x, b);
    vmi_weigh_inside(s, VMI_RK87_OWN + VMI_RK87_EXTRA, b, x, y);
}

/* Returns the descriptor of rk87: its vmi_rk_pair. */
VMI_FOLDED vmi_rk_pair vmi_rk87_pair(void)
{
    vmi_rk_pair pair;
    pair.method = VMI_RK87;
    pair.order = 8;
    pair.stages = 13;
    pair.last_is_first = 0;
    pair.derivatives = VMI_RK87_OWN + VMI_RK87_EXTRA;
    pair.rounding = 256;
    pair.keep_from = VM_C(0.1);
    pair.stiff_beyond = VM_C(5.69);
    pair.end_difference = vmi_rk87_end_difference;
    pair.inside = vmi_rk87_inside;
    pair.extend = vmi_rk87_extend;
    return pair;
}

/* Makes steps of rk87 to t_end, or only one if `single` is not 0. f and n are those of s. Returns a status. */
VMI_LOOP int vmi_rk87_run(rk45 *s, ode_rhs f, int n, vm_real t_end, int single)
{
    vmi_rk_stepper stepper;
    stepper.pair = vmi_rk87_pair();
    stepper.make_stages = vmi_rk87_stages;
    stepper.step_error = vmi_rk87_error;
    return vmi_run(s, stepper, f, n, t_end, single);
}

/* -- Functions for users -- */

#define RK87_WORK(n) (24 * (n)) /* number of elements of the array work for n components */

/* A run by rk87 has the options and the fields of a run by rk45, with the same meanings. */
typedef rk45_options rk87_options;
typedef rk45 rk87;

/* Begins a run of y' = f(t, y) by rk87, as rk45_init begins one by rk45. work has RK87_WORK(n) numbers, and rtol
   becomes at least 256 VM_EPSILON. */
VM_INLINE int rk87_init(rk87 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk87_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk87_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Continues a run of rk87 from another time or state, such as after a jump. All else is as in rk45_restart. */
VM_API int rk87_restart(rk87 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* Makes one accepted step of rk87, or the part of it before an event that ends the step. All else is as in
   rk45_step. */
VM_INLINE int rk87_step(rk87 *s)
{
    vm_real t_end;
    const int status = vmi_begin_step(s, VMI_RK87, &t_end);
    if (status) return status;
    return vmi_rk87_run(s, s->f, s->n, t_end, 1);
}

/* Makes steps of rk87 to t_end. The caller gives f and n once more, so that the compiler can inline f. All else is as
   in rk45_solve_with. */
VM_INLINE int rk87_solve_with(rk87 *s, ode_rhs f, int n, vm_real t_end)
{
    const int status = vmi_begin_solve(s, VMI_RK87, f, n, t_end);
    if (status) return status;
    return vmi_end_solve(t_end, vmi_rk87_run(s, f, n, vmi_last_time(t_end), 0));
}

/* Makes steps of rk87 to t_end exactly, forward or backward, or to an event that ends the run. All else is as in
   rk45_solve. */
VM_INLINE int rk87_solve(rk87 *s, vm_real t_end)
{
    if (!s) return ODE_BAD_ARGUMENT;
    return rk87_solve_with(s, s->f, s->n, t_end);
}

/* Computes the state y(t) at a time t within the last step of rk87, accurate to order 8. y receives n numbers. The
   first call after a step evaluates f seven times, unless t is s->t or the run has events: then the search for events
   has made these evaluations. Returns ODE_BAD_ARGUMENT if t is not between s->t_old and s->t. In these evaluations f
   may also stop the run (then the status is ODE_RHS_STOPPED) or give a number that is not finite (ODE_NOT_FINITE),
   although the step itself has succeeded. */
VM_API int rk87_interpolate(rk87 *s, vm_real t, vm_real *y)
{
    if (!s || s->pair.method != VMI_RK87) return ODE_BAD_ARGUMENT;
    return vmi_interpolate(s, t, y);
}

#endif
/* integrators/output.h - the solution at listed times
   rk45_solve_at and rk87_solve_at fill a table with the state at times that the caller lists. If a listed time is
   inside a step, the continuous extension of the step gives the state. So the steps need not end at the listed times,
   and the list does not make them shorter.

       double times[3] = {1, 2, 5}, rows[3][2], y0[2] = {1, 0}, work[RK45_WORK(2)];
       rk45 s;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       if (rk45_solve_at(&s, 3, times, rows[0], NULL) >= 0) printf("x(5) = %g\n", rows[2][0]);

   Tests: tests/test_dense.c. */
#ifndef VARMASS_INTEGRATORS_OUTPUT_H
#define VARMASS_INTEGRATORS_OUTPUT_H

/* Returns 1 if a run at the time t has reached `time`, else 0. The run goes forward (direction 1) or backward (-1). */
VM_API int vmi_has_reached(vm_real t, vm_real time, int direction)
{
    if (direction > 0) return t >= time;
    return t <= time;
}

/* Returns 1 if the times begin at t or later, as seen in the direction of the run, and follow each other in this
   direction, else 0. */
VM_API int vmi_times_are_in_order(vm_real t, int n_times, const vm_real *times, int direction)
{
    int i;
    for (i = 0; i < n_times; i++) {
        if (!VM_IS_FINITE(times[i]) || !vmi_has_reached(times[i], t, direction)) return 0;
        t = times[i];
    }
    return 1;
}

/* Writes the state to the row of each listed time that the run has reached, beginning with the row *done. *done
   becomes the number of filled rows. Returns a status. */
VM_API int vmi_fill_rows(rk45 *s, int n_times, const vm_real *times, int direction, vm_real *rows, int *done)
{
    while (*done < n_times && vmi_has_reached(s->t, times[*done], direction)) {
        const int status = vmi_interpolate(s, times[*done], rows + (ptrdiff_t)*done * s->n);
        if (status) { /* f failed in the continuous extension; another call begins with this step */
            vmi_take_back_step(s);
            return status;
        }
        ++*done;
    }
    return ODE_OK;
}

/* Make one step by rk45 or rk87. These two functions are not inlined, because gcc -O1 refuses to inline a function that
   is called by a pointer. */
VMI_APART int vmi_rk45_step_to(rk45 *s, vm_real t_end) { return vmi_rk45_run(s, s->f, s->n, t_end, 1); }
VMI_APART int vmi_rk87_step_to(rk45 *s, vm_real t_end) { return vmi_rk87_run(s, s->f, s->n, t_end, 1); }

/* Does the work of rk45_solve_at for the pair whose number is `method`. The function `step` makes one step by this
   pair. */
VM_API int vmi_solve_at(rk45 *s, int method, int (*step)(rk45 *s, vm_real t_end), int n_times, const vm_real *times,
                        vm_real *rows, int *n_done_or_NULL)
{
    int direction = 1, done = 0, status = ODE_OK, was_stiff;
    if (!s || s->pair.method != method || n_times < 0) return ODE_BAD_ARGUMENT;
    if (n_times > 0 && (!times || !rows)) return ODE_BAD_ARGUMENT;
    if (n_times > 0 && times[n_times - 1] < s->t) direction = -1;
    if (!vmi_times_are_in_order(s->t, n_times, times, direction)) return ODE_BAD_ARGUMENT;
    was_stiff = s->stiff;
    s->attempts = s->options.max_steps;
    s->event = -1;
    for (;;) {
        const int filled = vmi_fill_rows(s, n_times, times, direction, rows, &done);
        if (filled) status = filled;
        if (done == n_times || (status != ODE_OK && status != ODE_STIFF)) break;
        status = step(s, times[n_times - 1]);
    }
    if (n_done_or_NULL) *n_done_or_NULL = done;
    return status == ODE_OK && s->stiff > was_stiff ? (int)ODE_STIFF : status;
}

/* Continues a run of rk45 to the last of n_times times and writes the state at each of them to a row of n numbers. The
   times start at s->t or later and rise, or start at s->t or earlier and fall; equal times are allowed. The array rows
   has n_times times n numbers. *n_done_or_NULL becomes the number of rows that are filled. If neither an event nor an
   error ends the run, all rows are filled; else another call with the remaining times continues the run. If an event
   changes the state at a listed time, the row has the new state. The values are those of rk45_interpolate; the row of
   the last time has the values of s->y. Returns a status, as rk45_solve does. The status is ODE_BAD_ARGUMENT if times
   are not finite or neither rise nor fall in this way. */
VM_API int rk45_solve_at(rk45 *s, int n_times, const vm_real *times, vm_real *rows, int *n_done_or_NULL)
{
    return vmi_solve_at(s, VMI_RK45, vmi_rk45_step_to, n_times, times, rows, n_done_or_NULL);
}

/* Continues a run of rk87 to the last of n_times times and writes the state at each of them to a row of n numbers.
   All else is as in rk45_solve_at. A step with listed times before its end takes seven more evaluations of f, which may
   also end the run with ODE_RHS_STOPPED or ODE_NOT_FINITE. */
VM_API int rk87_solve_at(rk87 *s, int n_times, const vm_real *times, vm_real *rows, int *n_done_or_NULL)
{
    return vmi_solve_at(s, VMI_RK87, vmi_rk87_step_to, n_times, times, rows, n_done_or_NULL);
}

#endif
/* integrators/saved.h - runs that are saved as bytes and resumed later

   A saved run has the numbers of an rk45 except its options, and those of its work and of its events, but no pointers.
   The program that resumes it calls rk45_init with the f, n, options and events of the saved run, then rk45_resume. The
   resumed run has the same bits as a run that was not interrupted. A plain copy of an rk45 is not enough: y, work,
   options.events and options.atol_each are pointers to arrays of the caller, and f, ctx and the fields of the pair
   point to functions and data of the program.

       unsigned char bytes[RK45_SAVED(2, 0)]; // n = 2, no events
       double y0[2] = {1, 0}, work[RK45_WORK(2)], other_work[RK45_WORK(2)];
       rk45 s, again;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       rk45_solve(&s, 10.0);
       rk45_save(&s, sizeof bytes, bytes); // the bytes may go to a file
       rk45_init(&again, spring, NULL, 2, 0.0, y0, NULL, other_work);
       rk45_resume(&again, sizeof bytes, bytes); // continues from the time of s

   A saved run can be resumed only with the same type vm_real and the same version of this header. The bytes are the
   same on every machine, so that a run that was saved on one machine can be resumed on another one, with the same bits.
   Tests: tests/test_saved_runs.c. */
#ifndef VARMASS_INTEGRATORS_SAVED_H
#define VARMASS_INTEGRATORS_SAVED_H

#include <limits.h>
#include <stdint.h>
#include <string.h>

/* Indices of the numbers at the beginning of a saved run, its head. A run can resume a saved run only if its own head
   would have the same numbers. */
enum {
    VMI_SAVED_FORMAT,
    VMI_SAVED_REAL,
    VMI_SAVED_LONG,
    VMI_SAVED_METHOD,
    VMI_SAVED_N,
    VMI_SAVED_EVENTS,
    VMI_SAVED_HEAD /* how many numbers the head has */
};

enum {
    VMI_SAVED_FORMAT_NOW = 0x7601, /* "v" and the number of this format */
    VMI_SAVED_RUN_INTS = VMI_SAVED_HEAD + 9,
    VMI_SAVED_INT_BYTES = 4,  /* an int is saved as a number of 32 bits, whatever its size here */
    VMI_SAVED_LONG_BYTES = 8, /* a long is saved as a number of 64 bits */
    VMI_SAVED_SUM_BYTES = 4,
    VMI_SAVED_RUN_BYTES = 7 * sizeof(vm_real) + 6 * VMI_SAVED_LONG_BYTES + VMI_SAVED_RUN_INTS * VMI_SAVED_INT_BYTES +
                          VMI_SAVED_SUM_BYTES,
    VMI_SAVED_EVENT_BYTES = 4 * sizeof(vm_real) + VMI_SAVED_LONG_BYTES + 3 * VMI_SAVED_INT_BYTES
};

/* The number of bytes of a saved run with `numbers` numbers in work and n_events events */
#define VMI_SAVED(numbers, n_events) \
    (VMI_SAVED_RUN_BYTES + (numbers) * (int)sizeof(vm_real) + (n_events) * VMI_SAVED_EVENT_BYTES)
#define RK45_SAVED(n, n_events) VMI_SAVED(RK45_WORK(n), n_events)
#define RK87_SAVED(n, n_events) VMI_SAVED(RK87_WORK(n), n_events)

/* A place in the bytes of a saved run. If `saves` is not 0, the numbers are written to the bytes; else they are read
   from the bytes. */
typedef struct VM_TAG(vmi_saved_place) {
    unsigned char *to;
    const unsigned char *from;
    int saves;
} vmi_saved_place;

/* Writes the lowest `count` bytes of *bits, the lowest byte first, or reads them. Afterwards *p is the place behind
   these bytes */
VM_API void vmi_saved_bits(vmi_saved_place *p, uint64_t *bits, int count)
{
    uint64_t read = 0;
    int i;
    for (i = 0; i < count; i++) {
        if (p->saves) *p->to++ = (unsigned char)(*bits >> (8 * i) & 0xff);
        else read |= (uint64_t)*p->from++ << (8 * i);
    }
    if (!p->saves) *bits = read;
}

/* Writes or reads the bits of a number of type vm_real */
VM_API void vmi_saved_real(vmi_saved_place *p, vm_real *x)
{
    vmi_signed_bits own;
    uint64_t bits;
    memcpy(&own, x, sizeof own);
    bits = (uint64_t)own;
    vmi_saved_bits(p, &bits, (int)sizeof own);
    if (p->saves) return;
    own = (vmi_signed_bits)bits;
    memcpy(x, &own, sizeof own);
}

/* Writes or reads a number of type long. If the number is outside the range of a machine's long, the nearest long is
   read. */
VM_API void vmi_saved_long(vmi_saved_place *p, long *x)
{
    uint64_t bits = (uint64_t)(int64_t)*x;
    int64_t value;
    vmi_saved_bits(p, &bits, VMI_SAVED_LONG_BYTES);
    if (p->saves) return;
    value = (int64_t)bits;
    if (value > LONG_MAX) value = LONG_MAX;
    if (value < LONG_MIN) value = LONG_MIN;
    *x = (long)value;
}

/* Writes or reads a number of type int */
VM_API void vmi_saved_int(vmi_saved_place *p, int *x)
{
    uint64_t bits = (uint64_t)(int64_t)*x;
    vmi_saved_bits(p, &bits, VMI_SAVED_INT_BYTES);
    if (!p->saves) *x = (int)(int32_t)(uint32_t)bits;
}

/* Writes or reads the numbers of an event. */
VM_API void vmi_saved_move_event(vmi_saved_place *p, ode_event *e)
{
    vmi_saved_long(p, &e->count);
    vmi_saved_real(p, &e->t);
    vmi_saved_real(p, &e->from);
    vmi_saved_real(p, &e->slack);
    vmi_saved_real(p, &e->quiet);
    vmi_saved_int(p, &e->side);
    vmi_saved_int(p, &e->side_ahead);
    vmi_saved_int(p, &e->happens);
}

/* Returns the number of vm_real numbers in the work of the run s that belong to the integrator. */
VM_API long vmi_saved_numbers(const rk45 *s) { return (long)(VMI_K + s->pair.derivatives) * s->n; }

/* Writes all numbers of the run, its work and its events, or reads them */
VM_API void vmi_saved_move_run(vmi_saved_place *p, rk45 *s)
{
    const long numbers = vmi_saved_numbers(s);
    long number;
    int i;
    vmi_saved_real(p, &s->t);
    vmi_saved_real(p, &s->t_low);
    vmi_saved_real(p, &s->t_old);
    vmi_saved_real(p, &s->t_old_low);
    vmi_saved_real(p, &s->h);
    vmi_saved_real(p, &s->h_done);
    vmi_saved_real(p, &s->inverse_error);
    vmi_saved_long(p, &s->steps);
    vmi_saved_long(p, &s->rejected);
    vmi_saved_long(p, &s->evals);
    vmi_saved_long(p, &s->missed);
    vmi_saved_long(p, &s->next_miss);
    vmi_saved_long(p, &s->attempts);
    vmi_saved_int(p, &s->rhs_status);
    vmi_saved_int(p, &s->event);
    vmi_saved_int(p, &s->k1);
    vmi_saved_int(p, &s->extended);
    vmi_saved_int(p, &s->failed);
    vmi_saved_int(p, &s->stiff);
    vmi_saved_int(p, &s->stiff_wait);
    vmi_saved_int(p, &s->stiff_hits);
    vmi_saved_int(p, &s->stiff_misses);
    for (number = 0; number < numbers; number++) vmi_saved_real(p, s->work + number);
    for (i = 0; i < s->options.n_events; i++) vmi_saved_move_event(p, s->options.events + i);
}

/* Writes the numbers at the beginning of a saved run. */
VM_API void vmi_saved_head(const rk45 *s, int *head)
{
    head[VMI_SAVED_FORMAT] = VMI_SAVED_FORMAT_NOW;
    head[VMI_SAVED_REAL] = (int)sizeof(vm_real);
    head[VMI_SAVED_LONG] = VMI_SAVED_LONG_BYTES;
    head[VMI_SAVED_METHOD] = s->pair.method;
    head[VMI_SAVED_N] = s->n;
    head[VMI_SAVED_EVENTS] = s->options.n_events;
}

/* Writes or reads the numbers at the beginning of a saved run */
VM_API void vmi_saved_move_head(vmi_saved_place *p, int *head)
{
    int i;
    for (i = 0; i < VMI_SAVED_HEAD; i++) vmi_saved_int(p, head + i);
}

/* Writes or reads a checksum */
VM_API void vmi_saved_move_sum(vmi_saved_place *p, uint32_t *sum)
{
    uint64_t bits = *sum;
    vmi_saved_bits(p, &bits, VMI_SAVED_SUM_BYTES);
    *sum = (uint32_t)bits;
}

/* Returns the checksum of bytes (FNV-1a). A saved run ends with its checksum, so that damaged bytes are refused. */
VM_API uint32_t vmi_saved_checksum(const unsigned char *bytes, long count)
{
    uint32_t sum = 2166136261u;
    long i;
    for (i = 0; i < count; i++) sum = (sum ^ bytes[i]) * 16777619u;
    return sum;
}

/* Returns the number of bytes of the saved run s. */
VM_API long vmi_saved_size(const rk45 *s)
{
    return (long)VMI_SAVED_RUN_BYTES + vmi_saved_numbers(s) * (long)sizeof(vm_real) +
           (long)s->options.n_events * (long)VMI_SAVED_EVENT_BYTES;
}

/* Does the work of rk45_save for the pair whose number is `method` */
VM_API int vmi_save(const rk45 *s, int method, long size, unsigned char *bytes)
{
    vmi_saved_place place;
    int head[VMI_SAVED_HEAD];
    uint32_t sum;
    rk45 copy;
    if (!s || !bytes || size < 0 || s->pair.method != method) return ODE_BAD_ARGUMENT;
    if (size < vmi_saved_size(s)) return ODE_WORK_TOO_SMALL;
    copy = *s;
    place.to = bytes;
    place.from = NULL;
    place.saves = 1;
    vmi_saved_head(s, head);
    vmi_saved_move_head(&place, head);
    vmi_saved_move_run(&place, &copy);
    sum = vmi_saved_checksum(bytes, (long)(place.to - bytes));
    vmi_saved_move_sum(&place, &sum);
    return ODE_OK;
}

/* Does the work of rk45_resume for the pair whose number is `method` */
VM_API int vmi_resume(rk45 *s, int method, long size, const unsigned char *bytes)
{
    vmi_saved_place place;
    int wanted[VMI_SAVED_HEAD], head[VMI_SAVED_HEAD] = {0}, i;
    uint32_t sum = 0;
    long before; /* number of bytes before the checksum */
    if (!s || !bytes || size < 0 || s->pair.method != method) return ODE_BAD_ARGUMENT;
    if (size < vmi_saved_size(s)) return ODE_WORK_TOO_SMALL;
    before = vmi_saved_size(s) - VMI_SAVED_SUM_BYTES;
    place.to = NULL;
    place.from = bytes + before;
    place.saves = 0;
    vmi_saved_move_sum(&place, &sum);
    if (sum != vmi_saved_checksum(bytes, before)) return ODE_BAD_ARGUMENT;
    vmi_saved_head(s, wanted);
    place.from = bytes;
    vmi_saved_move_head(&place, head);
    for (i = 0; i < VMI_SAVED_HEAD; i++)
        if (head[i] != wanted[i]) return ODE_BAD_ARGUMENT;
    vmi_saved_move_run(&place, s);
    return ODE_OK;
}

/* Saves a run of rk45 between two calls as bytes. The array `bytes` has `size` elements, at least RK45_SAVED(n, number
   of events). The arrays `times` and `states` of events, ctx and the options are not saved, because they belong to the
   caller. The time of a call is proportional to the number of bytes. Returns ODE_OK; ODE_BAD_ARGUMENT for a null
   pointer, a negative size or a run by rk87; ODE_WORK_TOO_SMALL if `size` is too small. */
VM_API int rk45_save(const rk45 *s, long size, unsigned char *bytes) { return vmi_save(s, VMI_RK45, size, bytes); }

/* Copies the numbers of a saved run of rk45 into s, which rk45_init has made with the f, n, options and events of the
   saved run. The next step then has the same bits as the next step of the run that was saved. Returns ODE_OK;
   ODE_WORK_TOO_SMALL if size is less than the number of bytes of such a run; ODE_BAD_ARGUMENT for a null pointer, for
   bytes of a run with another method, n, number of events or type, and for damaged bytes. If the status is not ODE_OK,
   s is unchanged. */
VM_API int rk45_resume(rk45 *s, long size, const unsigned char *bytes) { return vmi_resume(s, VMI_RK45, size, bytes); }

/* Saves a run of rk87 as bytes. The array `bytes` has `size` elements, at least RK87_SAVED(n, number of events). All
   else is as in rk45_save. */
VM_API int rk87_save(const rk87 *s, long size, unsigned char *bytes) { return vmi_save(s, VMI_RK87, size, bytes); }

/* Copies the numbers of a saved run of rk87 into s, which rk87_init has made. All else is as in rk45_resume. */
VM_API int rk87_resume(rk87 *s, long size, const unsigned char *bytes) { return vmi_resume(s, VMI_RK87, size, bytes); }

#endif

VMI_QUIET_END

#endif
