/* ateb.h - Ateb functions: sine and cosine of the oscillator x'' + x|x|^(alpha-1) = 0

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include <stdio.h>
       #include "ateb.h"
       int main(void)
       {
           double sa, ca;
           ateb_saca(0.7, 1.5, &sa, &ca);
           printf("sa = %.16g, ca = %.16g, period %.16g\n", sa, ca, 2 * ateb_pi(1.5));
           return 0;
       }

   CONVENTIONS
     The variable comes first, then the parameter alpha, any real number >= 0; results come last. All arguments are
     pure numbers. Names are those of the dissertation [1], and numbers like (275) are its equations: sa always means
     sa(1, alpha, s), and ca always means ca(alpha, 1, s). Both have the period 2 Pi_alpha. An oscillator m x'' + k
     x|x|^(alpha-1) = 0 with amplitude A moves by x = A ca and x' = -sqrt(2/(alpha+1)) omega A^((alpha+1)/2) sa, where
     omega = sqrt(k/m).

   WHAT THE FUNCTIONS ARE
     v = sa and u = ca solve v' = u|u|^(alpha-1), u' = -2 v/(alpha+1) with v(0) = 0 and u(0) = 1 (275), where ' is the
     derivative with respect to s. So v^2 + |u|^(alpha+1) = 1 (279), and in the first quarter, 0 <= s <= Pi_alpha/2, v^2
     is an inverse incomplete beta function of s: s = (1/2) B_(v^2)(1/2, 1/(alpha+1)).
     alpha = 0              sa is a triangular wave, ca consists of arcs of parabolas
     alpha = 1              sa = sin, ca = cos
     alpha = 3              sa = sqrt(2) sn dn and ca = cn of the argument s/sqrt(2) and the parameter 1/2
     alpha to infinity      sa tends to tanh s; as a function of s/Pi_alpha it tends to a square wave
     With the generalised sine sin_(p,q) of other authors, and p = (alpha+1)/alpha,
     sa = sin_(p,2)(s) and ca = sin_(2,alpha+1)((Pi_alpha - 2s)/(alpha+1)).

   WHAT TO CALL
     ateb_saca             sa and ca for one s and one alpha; ateb_sa and ateb_ca return one of them
     ateb_pi               Pi_alpha, half the period
     ateb_plan_init        prepares a plan for one alpha; then call ateb_plan_saca for one s, or ateb_plan_saca_array
                           for many s. ateb_plan_init_to makes a shorter and quicker plan of less accuracy. A plan is
                           plain data and may be a constant in flash; examples/print_plan prints one. On AVR copy it
                           from there to RAM, by memcpy_P, before it is used.
     ateb_phase            s from sa and ca, as atan2 computes an angle from its sine and cosine
     ateb_mean             the mean of |sa|^p |ca|^q over a period (316); ateb_mean_nm takes two indices and the signs
                           of sa and ca into account
     ateb_integral_...     integrals of sa^2 and of |ca|^(alpha+1) from 0 to s
     ateb_saca_nm          sa(n, m, s) and ca(m, n, s) with any two indices
     ateb_beta...          beta function, incomplete beta function and its inverse
     ateb_ln_beta...       logarithms of the beta functions, where these overflow or underflow

   ERRORS
     alpha < 0, NaN and infinite arguments give NaN; so do probabilities outside [0, 1], parameters of beta functions
     outside 1e-4 to 1e5 (for ateb_ln_beta outside 1e-30 to 1e30; but the parameters 0 and infinity give limits), and
     all arguments outside the domain that the comment of a function gives. For a bad alpha ateb_plan_init returns -1
     and leaves the plan as it was. Nothing else can fail. The functions allocate no memory and keep no state; errno
     says nothing about their errors.

   METHOD
     First s is reduced to the first quarter of the period, which needs Pi_alpha. Pi_alpha comes from a table of
     polynomials. Where s is large or close to a zero, Pi_alpha needs more digits: it comes from one polynomial in two
     or three words (a word is one number of the type; a sum of three words has three times the digits). In the first
     quarter the incomplete beta function is inverted. An approximation of sa is taken as exact, and the s that belongs
     to it is computed by a continued fraction of 12 levels (float 6) and one power. A Taylor series then corrects sa
     and ca for the difference from the given s.
     A plan has polynomials for two parts of a quarter: Taylor series that solve (275), shortened to the accuracy that
     is wanted.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double; the tests run both
     VM_API               linkage of every function; the default is static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If it is defined as VM_API,
                          the code is smaller and the results are the same.
     VM_SQRT, VM_FABS, VM_FLOOR, VM_COPYSIGN
                          the functions of the C library that are used; define all four or none. Where the compiler says
                          that fma is fast (FP_FAST_FMA, in float FP_FAST_FMAF), fma is used, too. All these functions
                          round correctly, so that results are the same on every machine, unless the compiler fuses
                          products and sums.
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. The defaults
                          are static const and (x); on AVR they are static const PROGMEM and pgm_read_float(&(x)), so
                          that tables take no RAM
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but none of the bounds below holds
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
     once when it starts. On x87 units gcc in its gnu modes (gcc -m32, no -std=c99) computes with more digits than the
     type has (excess precision). Then the bounds below do not hold, and odd and even functions may lose their symmetry
     in the last bit. The options -fexcess-precision=standard, or -msse2 -mfpmath=sse, prevent this.

   ACCURACY: bounds of the error, which the tests check; docs/measurements.md has the errors found.
     eps, ulp               eps is 2.2e-16 (float 1.2e-7). An ulp is the distance between two neighbouring numbers of
                            the type, next to the true value. The bounds take the inputs as exact.
     sa, ca                 absolute error <= 4 eps for |s| <= 1e9 (float 1e4), relative error <= 8 ulp for
                            |s| <= 100 Pi_alpha, for alpha = 0 and alpha from 1e-300 to 1e30. Between their extremes sa
                            and ca only rise or only fall, apart from errors of 2 ulp. sa^2 + |ca|^(alpha+1) is 1 to
                            within 1.5 eps (2 sa^2 + (alpha+1) |ca|^(alpha+1)).
     the zeros              of sa and ca have a relative error <= 2^-125 (float 2^-58); for alpha above 5e8 (float 2e4)
                            and for plans in float, it is <= 2^-100 (float 2^-42). This error, times |s| and the slope
                            of sa or ca, comes in addition to the errors above. It matters only where s is within an
                            ulp of a zero.
     Pi_alpha               <= 1 ulp
     sa, ca by a plan       <= 2 ulp for |s| <= 100 Pi_alpha and alpha up to 1e6, or the absolute error that the plan
                            was made for
     phase                  <= 8 ulp plus the change of s that 6 ulp of sa and of ca make, where sa and ca come from
                            ateb_saca
     beta, mean, Pi(n, m)   <= 1 ulp, 2 ulp and 1 ulp, in this order
     beta_inc               <= 30 ulp of p = I_x(a, b) and of q = 1 - p
     beta_inc_inv           <= 16 ulp of x and of y = 1 - x, plus the change that one ulp of the smaller of p and q
                            makes
     sa(n, m), ca(m, n)     <= 8 ulp plus the change that an error of 2^-102 |s| (float 2^-44 |s|) in s makes
     integrals              the integrals of sa^2 and |ca|^(alpha+1) add up to s within 3 eps (1 + |s|)

   COST
     docs/cost.md has the times of the functions that are used most, docs/counts.md the number of instructions of a call
     of nearly all. An ateb_plan has 560 [ateb_plan_bytes] bytes, in float 184 [ateb_plan_bytes_float]; the name in
     brackets is that of the row of docs/numbers.md with this number. On processors with wide vector registers
     ateb_plan_saca_array needs 4 to 6 kB of stack (float 2 to 3 kB); the stack frame of any other function is below 2
     kB.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation; numbers like (277) are its equations. Where [1]
         has a misprint, this file uses the corrected equation: in [1], (278) and (280) mix up the indices and have a
         wrong sign, and (279) lacks the bars of |u|.
     [2] R. M. Rosenberg, The Ateb(h)-functions and their properties, Q. Appl. Math. 21 (1963) 37-47.
     [3] DLMF, dlmf.nist.gov: 8.17 (incomplete beta functions), 15.7 (continued fractions), 15.8(iii) (quadratic
         transformations).
     [4] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [5] C. Lanczos, Applied Analysis, Prentice-Hall 1956: economisation of power series.
     [6] A. R. Didonato, A. H. Morris, Algorithm 708, ACM Trans. Math. Softw. 18 (1992) 360-373.

   INDEX
     base/self_check: a test of whether this compiler and this processor compute as varmass needs
       vm_self_check                  Returns 1 if the compiler and the processor compute as varmass needs, else 0

     ateb/period: Pi_alpha, half the period of the Ateb functions
       ateb_pi                        Pi_alpha, half the period of sa and ca, for alpha >= 0

     ateb/functions: the Ateb functions sa and ca for any real argument and any alpha >= 0
       ateb_saca                      sa(1, alpha, s) and ca(alpha, 1, s), the Ateb sine and cosine
       ateb_sa                        sa(1, alpha, s), the Ateb sine, alone
       ateb_ca                        ca(alpha, 1, s), the Ateb cosine, alone

     ateb/phase: the phase s for given values of sa and ca
       ateb_phase                     The phase s of given values of sa and ca, with -Pi_alpha <= s <= Pi_alpha

     ateb/integrals: integrals of Ateb functions
       ateb_integral_sa2              The integral of sa(1, alpha, s)^2 from 0 to s
       ateb_integral_ca               The integral of |ca(alpha, 1, s)|^(alpha+1) from 0 to s

     ateb/plans: sa and ca for many arguments and one alpha
       ateb_plan_saca                 sa and ca of the argument s for the plan's alpha
       ateb_plan_saca_array           sa and ca of n arguments for the plan's alpha
       ateb_plan_init_to              Prepares a plan for alpha >= 0 and a given accuracy
       ateb_plan_init                 Prepares a plan of full accuracy for alpha >= 0

     ateb/beta: beta functions, and mean values of sa and ca
       ateb_beta                      The complete beta function B(a, b), for a and b from 1e-4 to 1e5
       ateb_ln_beta                   The logarithm of the complete beta function, ln B(a, b), for a and b from 1e-30 to 1e30
       ateb_beta_inc_both             The regularised incomplete beta function p = I_x(a, b) and q = 1 - p
       ateb_beta_inc                  The regularised incomplete beta function I_x(a, b), for 0 <= x <= 1
       ateb_ln_beta_inc               The logarithm of the regularised incomplete beta function, ln I_x(a, b), for 0 <= x <= 1
       ateb_mean_nm                   The mean of |sa(n, m, s)|^p |ca(m, n, s)|^q over a period, with or without the signs of sa and ca
       ateb_mean                      The mean of |sa|^p |ca|^q over a period, for alpha >= 0 and p, q > -1

     ateb/beta_inverse: inverse of the incomplete beta function
       ateb_beta_inc_inv_both         The inverse of ateb_beta_inc_both
       ateb_beta_inc_inv              The inverse of ateb_beta_inc

     ateb/two_indices: Ateb functions with two indices, sa(n, m, s) and ca(m, n, s)
       ateb_pi_nm                     Pi(n, m), half the period of sa(n, m, s) and ca(m, n, s)
       ateb_saca_nm                   sa(n, m, s) and ca(m, n, s), the Ateb functions with two indices */
#ifndef VARMASS_ATEB_H
#define VARMASS_ATEB_H

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
/* base/words.h - products, quotients and roots with two and three times the digits

   Where the difference of nearly equal numbers loses digits (they cancel), one vm_real is not enough. A number in two
   words (vm_two, hi + lo) has twice the digits, and a number in three words (vmi_three, hi + mid + lo) has three times
   the digits. p is the number of binary digits of a vm_real, 53 or 24. Errors of products, quotients and roots are
   given relative to the result, errors of sums relative to the larger term.

       vm_two third = vmi_two_over(vmi_two(1, 0), vmi_two(3, 0)); // 1/3 with 2p digits

   Source: Dekker, Numer. Math. 18 (1971). Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_WORDS_H
#define VARMASS_BASE_WORDS_H

/* The factor of Veltkamp's method, which splits a vm_real into two halves of p/2 digits each */
#if VM_MANT_DIG > 24
#define VM_SPLIT VM_C(134217729.0)
#else
#define VM_SPLIT VM_C(4097.0)
#endif

/* Returns the exact product a b as a pair, for |a|, |b| < VM_MAX/VM_SPLIT, if the product neither overflows nor
   underflows. A fused multiply-add is used where the processor has one; elsewhere both factors are split into halves,
   with the same result. Each "+ 0" makes a product a sum: a compiler that fuses operations then cannot use the
   unrounded product in a later sum. */
VM_API vm_two vmi_two_product(vm_real a, vm_real b)
{
    vm_two p;
#ifdef VM_FAST_FMA
    p.hi = a * b + 0;
    p.lo = VM_LIBM(fma)(a, b, -p.hi);
#else
    vm_real ta = vmi_rounded(VM_SPLIT * a + 0), a_rest = vmi_rounded(ta - a), ah = ta - a_rest, al = a - ah;
    vm_real tb = vmi_rounded(VM_SPLIT * b + 0), b_rest = vmi_rounded(tb - b), bh = tb - b_rest, bl = b - bh;
    p.hi = vmi_rounded(a * b + 0);
    p.lo = vmi_rounded(((ah * bh - p.hi) + ah * bl + al * bh) + al * bl);
#endif
    return p;
}

/* Reduces x >= 0 by the quarter period q > 0. Let j q be the multiple of q that is nearest to x. Returns x - j q, which
   lies between -q/2 and q/2 (or slightly outside by rounding), with an error below x 2^-(2p - 2), and writes j modulo 4
   to *quarter; p is the number of bits of vm_real. For one x the error is larger: if q.hi is a power of two and x is
   the number just below q.hi/2, the result is -q.hi/2 with an error of x 2^-p. For x above 2^(p-1) q the digits of x do
   not determine x - j q, and both results are 0. */
VM_API vm_two vmi_reduce(vm_real x, vm_two q, int *quarter)
{
    vm_real j = VM_FLOOR(x / q.hi + VM_C(0.5));
    const vm_real scale = q.hi > VM_MAX * VM_EPSILON ? VM_EPSILON : 1; /* keeps the product from overflowing */
    const vm_real hi = q.hi * scale, lo = q.lo * scale;
    vm_two p;
    *quarter = 0;
    if (j == 0) return vmi_two(x, 0);
    if (!(j < 1 / VM_EPSILON)) return vmi_two(0, 0);
    p = vmi_two_product(j, hi);
    p = vmi_two_sum(x * scale - p.hi, -p.lo); /* x scale - p.hi is exact, except for the x named above */
    p = vmi_fast_two_sum(p.hi, p.lo - j * lo);
    if (VM_FABS(p.hi) > VM_C(0.501) * hi) { /* for x > q/(1000 eps), where the rounding of the quotient changes j */
        const vm_real further = VM_FLOOR(p.hi / hi + VM_C(0.5));
        p = vmi_two_sum(p.hi - further * hi, p.lo - further * lo);
        j += further;
    }
    *quarter = (int)(j - 4 * VM_FLOOR(j / 4));
    return vmi_two(p.hi / scale, p.lo / scale);
}

/* Returns x with the second half of its digits set to zero. */
VM_API vm_real vmi_head(vm_real x)
{
    const vmi_bits above = (vmi_bits)1 << ((VM_MANT_DIG + 1) / 2);
    return vmi_from_bits(vmi_to_bits(x) & ~(above - 1));
}

/* The product x y of numbers in two words; the relative error is below 2^-(2p - 4), where p is the number of binary
   digits of vm_real. */
VM_API vm_two vmi_two_times(vm_two x, vm_two y)
{
    vm_two p = vmi_two_product(x.hi, y.hi);
    return vmi_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* The sum x + y of numbers in two words; the error is below 2^-(2p - 4) of the larger term, where p is the number of
   binary digits of vm_real. */
VM_API vm_two vmi_two_plus(vm_two x, vm_two y)
{
    vm_two s = vmi_two_sum(x.hi, y.hi);
    return vmi_two_sum(s.hi, s.lo + (x.lo + y.lo));
}

/* The quotient x / y of numbers in two words; the relative error is below 2^-(2p - 4), where p is the number of binary
   digits of vm_real. */
VM_API vm_two vmi_two_over(vm_two x, vm_two y)
{
    vm_real z = vmi_rounded(x.hi / y.hi);
    vm_two p = vmi_two_product(z, y.hi);
    return vmi_two_sum(z, (((x.hi - p.hi) - p.lo) + (x.lo - z * y.lo)) / y.hi);
}

/* The number hi + mid + lo, where mid is below an ulp of hi, and lo below an ulp of mid. Each operation on these
   numbers has a relative error below 2^-(3p - 4); p is 53 or 24. */
typedef struct VM_TAG(vmi_three) {
    vm_real hi, mid, lo;
} vmi_three;

/* Returns a + b + c as a number in three words. |a| >= |b| >= |c| must hold at least approximately. */
VM_API vmi_three vmi_three_words(vm_real a, vm_real b, vm_real c)
{
    const vm_two low = vmi_two_sum(b, c), high = vmi_two_sum(a, low.hi), rest = vmi_two_sum(high.lo, low.lo);
    vmi_three x;
    x.hi = high.hi;
    x.mid = rest.hi;
    x.lo = rest.lo;
    return x;
}

/* Returns the sum x + y of numbers in three words. */
VM_API vmi_three vmi_three_plus(vmi_three x, vmi_three y)
{
    const vm_two high = vmi_two_sum(x.hi, y.hi), mid = vmi_two_sum(x.mid, y.mid);
    const vm_two sum = vmi_two_sum(high.lo, mid.hi);
    return vmi_three_words(high.hi, sum.hi, sum.lo + mid.lo + (x.lo + y.lo));
}

/* Returns the product x y of numbers in three words. */
VM_API vmi_three vmi_three_times(vmi_three x, vmi_three y)
{
    const vm_two p = vmi_two_product(x.hi, y.hi), a = vmi_two_product(x.hi, y.mid);
    const vm_two b = vmi_two_product(x.mid, y.hi);
    const vm_two sum = vmi_two_sum(a.hi, b.hi), mid = vmi_two_sum(p.lo, sum.hi);
    return vmi_three_words(p.hi, mid.hi,
                           mid.lo + sum.lo + (a.lo + b.lo) + (x.hi * y.lo + x.mid * y.mid + x.lo * y.hi));
}

/* Returns the quotient x / y of numbers in three words, by long division: each of three steps gives a word of the
   quotient. */
VM_API vmi_three vmi_three_over(vmi_three x, vmi_three y)
{
    vm_real quotient[3];
    int i;
    for (i = 0; i < 3; i++) {
        quotient[i] = vmi_rounded(x.hi / y.hi);
        x = vmi_three_plus(x, vmi_three_times(y, vmi_three_words(-quotient[i], 0, 0)));
    }
    return vmi_three_words(quotient[0], quotient[1], quotient[2]);
}

/* Returns the fourth power of x. */
VM_API vm_real vmi_fourth_power(vm_real x) { return (x * x) * (x * x); }

/* Returns the product of x and a power of two, which is exact. */
VM_API vmi_three vmi_three_scaled(vmi_three x, vm_real power)
{
    return vmi_three_words(x.hi * power, x.mid * power, x.lo * power);
}

/* Returns the square root of a. The start value is the root of the first word. Each of two steps of Newton's method
   adds a word. */
VM_API vmi_three vmi_three_sqrt(vmi_three a)
{
    const vm_real root = VM_SQRT(a.hi);
    vmi_three x = vmi_three_words(root, 0, 0);
    int i;
    for (i = 0; i < 2; i++) {
        const vmi_three rest = vmi_three_plus(a, vmi_three_scaled(vmi_three_times(x, x), -1));
        x = vmi_three_plus(x, vmi_three_words((rest.hi + (rest.mid + rest.lo)) / (2 * root), 0, 0));
    }
    return x;
}

/* Returns the number pi/2 in three words. */
VM_API vmi_three vmi_half_pi(void)
{
#if VM_MANT_DIG > 24
    return vmi_three_words(VM_C(1.570796326794896557999), VM_C(6.123233995736766035869e-17),
                           VM_C(-1.497384904859169832944e-33));
#else
    return vmi_three_words(VM_C(1.570796370506286621094), VM_C(-4.371138828673792886548e-8),
                           VM_C(-1.715124510005881872804e-15));
#endif
}

/* Returns a - root^2 without loss of digits. The argument `root` must be the rounded square root of a. */
VM_API vm_real vmi_root_residual(vm_real a, vm_real root)
{
    const vm_real head = vmi_head(root), tail = root - head;
    return ((a - head * head) - 2 * head * tail) - tail * tail;
}

/* Returns the square root of a + a_lo in two words, where a_lo is below an ulp of a. */
VM_API vm_two vmi_root(vm_real a, vm_real a_lo)
{
    const vm_real root = vmi_rounded(VM_SQRT(a));
    return vmi_two(root, (vmi_root_residual(a, root) + a_lo) / (2 * root));
}

/* Returns x if it lies between low and high, else the nearer of these bounds. A NaN stays NaN. */
VM_INLINE vm_real vmi_clamp(vm_real x, vm_real low, vm_real high)
{
    if (x > high) x = high;
    if (x < low) x = low;
    return x;
}

/* Returns the product of x and a power of two, which is exact. */
VM_API vm_two vmi_two_shifted(vm_two x, vm_real power) { return vmi_two(x.hi * power, x.lo * power); }

/* Returns the difference x - y of numbers in two words. */
VM_API vm_two vmi_two_minus(vm_two x, vm_two y) { return vmi_two_plus(x, vmi_two(-y.hi, -y.lo)); }

/* Returns the square root of x >= 0. For x below 2^-500 (float 2^-80) the low word of the result is not reliable. */
VM_API vm_two vmi_two_root(vm_two x)
{
    if (x.hi > 0) return vmi_root(x.hi, x.lo);
    return vmi_two(0, 0);
}

/* Returns the number -x. */
VM_API vm_two vmi_minus(vm_two x)
{
    x.hi = -x.hi;
    x.lo = -x.lo;
    return x;
}

/* Returns the number x / 2. */
VM_API vm_two vmi_half(vm_two x)
{
    x.hi /= 2;
    x.lo /= 2;
    return x;
}

/* Returns the product of x and a factor of one word. */
VM_API vm_two vmi_two_scaled(vm_two x, vm_real factor)
{
    vm_two p = vmi_two_product(x.hi, factor);
    return vmi_fast_two_sum(p.hi, p.lo + x.lo * factor);
}

/* Returns the sum a b + c d of two products, with a relative error of at most 2 eps, even where the products nearly
   cancel each other. No product may underflow. */
VM_API vm_real vmi_sum_of_products(vm_real a, vm_real b, vm_real c, vm_real d)
{
    const vm_two ab = vmi_two_product(a, b), cd = vmi_two_product(c, d);
    const vm_two high = vmi_two_sum(ab.hi, cd.hi), low = vmi_two_sum(ab.lo, cd.lo);
    const vm_two sum = vmi_two_sum(high.hi, low.hi);
    return sum.hi + (sum.lo + (high.lo + low.lo));
}

#endif
/* ateb/period.h - Pi_alpha, half the period of the Ateb functions

   sa and ca have the period 2 Pi_alpha, where Pi_alpha = B(1/(alpha + 1), 1/2) by (277) and B is the complete beta
   function. Pi_alpha is 2 for alpha = 0 and pi for alpha = 1. ateb_pi returns Pi_alpha; the internal functions return a
   quarter of the period, Pi_alpha/2, in two or three words, as the reduction of an argument needs them.

       vm_real period = 2 * ateb_pi(3);

   There are two methods. A table of polynomials gives Pi_alpha - (alpha + 1). This method is quick, and it is accurate
   enough for most arguments of sa and ca. For the other arguments one polynomial of degree 33 (float 17) is evaluated
   in two or three words. In the comments of this file n = alpha + 1 and q = 1/n. The tables are computed by
   tests/gen/ateb_coefficients.py. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_PERIOD_H
#define VARMASS_ATEB_PERIOD_H

/* Returns coefficient i of a polynomial in t = 2q - 1, which approximates (1 + q)(2 + q)(3 + q) f(q), where
     f(q) = sqrt(pi) Gamma(1 + q)/Gamma(q + 1/2) = q Pi_alpha with q = 1/(alpha + 1), between 1 and 2 for 0 < q <= 1.
   The polynomial is exact at Chebyshev's points. From the fourth coefficient on, each is less than 1/8 of the previous
   one. A coefficient has up to three words; which_word = 0 selects the largest word. Words that are too small to change
   the result are 0. */
VM_API vm_real vmi_ateb_coefficient(int which_word, int i)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real high[34] = {
        VM_C(2.0616701789183018434e+1),   VM_C(2.0267110471870335431e+1),   VM_C(6.3635705553078754093),
        VM_C(7.3329082227506181546e-1),   VM_C(1.9708227491367229928e-2),   VM_C(-4.0000651288112700496e-4),
        VM_C(1.9327295440373642315e-5),   VM_C(-1.2789187658911751561e-6),  VM_C(9.9916872651209047445e-8),
        VM_C(-8.6358235237752655812e-9),  VM_C(7.9763568164635901392e-10),  VM_C(-7.7130262679616792355e-11),
        VM_C(7.7070743924391761201e-12),  VM_C(-7.8886573293367475069e-13), VM_C(8.2211271037952946036e-14),
        VM_C(-8.6854809713564620063e-15), VM_C(9.2729461017836547871e-16),  VM_C(-9.9811923844216788706e-17),
        VM_C(1.081230028747049329e-17),   VM_C(-1.1771637894488280204e-18), VM_C(1.2867238266427922807e-19),
        VM_C(-1.4109468128426003026e-20), VM_C(1.5510876021633897508e-21),  VM_C(-1.7086157884284126588e-22),
        VM_C(1.8852205416028078608e-23),  VM_C(-2.0828212289555137945e-24), VM_C(2.3035767011988879034e-25),
        VM_C(-2.5499329020418479467e-26), VM_C(2.8250575586442172435e-27),  VM_C(-3.1311422081625854324e-28),
        VM_C(3.4527226049922925084e-29),  VM_C(-3.8299883133411974758e-30), VM_C(4.7469491485808577813e-31),
        VM_C(-5.2687713493837014328e-32)};
    VM_TABLE vm_real low[22] = {
        VM_C(-3.0654856268470599668e-16), VM_C(1.210856509558633265e-15),   VM_C(3.0240525334513940988e-16),
        VM_C(-2.7717839450259092574e-19), VM_C(5.4666001892695387149e-19),  VM_C(-9.4064217969122898471e-21),
        VM_C(-1.1974064187521360439e-21), VM_C(-6.1449037626015888544e-23), VM_C(8.7901834551117892935e-25),
        VM_C(-5.9540578421884869214e-26), VM_C(-3.1215006189736638565e-26), VM_C(-4.2737260635061168349e-27),
        VM_C(1.0083140101962316162e-28),  VM_C(-2.861198322244910502e-29),  VM_C(-2.8146374107301775257e-30),
        VM_C(1.3516503830597232673e-31),  VM_C(9.335454088442542743e-32),   VM_C(-1.6623091458375181777e-33),
        VM_C(4.8535695583016722406e-34),  VM_C(4.2966913431290166353e-35),  VM_C(6.443494554591900988e-36),
        VM_C(1.4556914938291642103e-36)};
    VM_TABLE vm_real lowest[10] = {VM_C(-2.1193920831105467827e-32), VM_C(-7.808521102450774183e-32),
                                   VM_C(-1.2473656445091337713e-32), VM_C(-9.1883466313042762769e-36),
                                   VM_C(-4.7367768879157581675e-35), VM_C(6.8348014068649053378e-37),
                                   VM_C(-8.2912063937409743857e-38), VM_C(3.4431687262560826523e-39),
                                   VM_C(-3.7393247709997878888e-41), VM_C(1.2854247930563996123e-42)};
#else
    VM_TABLE vm_real high[18] = {VM_C(2.06167011261e+1),  VM_C(2.02671108246e+1),   VM_C(6.36357069016),
                                 VM_C(7.33290851116e-1),  VM_C(1.97082273662e-2),   VM_C(-4.00006509153e-4),
                                 VM_C(1.93272953766e-5),  VM_C(-1.27891871671e-6),  VM_C(9.9916874774e-8),
                                 VM_C(-8.63582361177e-9), VM_C(7.97635624217e-10),  VM_C(-7.71302535729e-11),
                                 VM_C(7.70717083903e-12), VM_C(-7.88876234302e-13), VM_C(8.21161511727e-14),
                                 VM_C(-8.6751217104e-15), VM_C(9.7750746723e-16),   VM_C(-1.05279968328e-16)};
    VM_TABLE vm_real low[11] = {VM_C(6.63084392727e-7),  VM_C(-3.52714636165e-7),  VM_C(-1.34847155664e-7),
                                VM_C(-2.88411179383e-8), VM_C(1.25158203246e-10),  VM_C(-3.72795457698e-12),
                                VM_C(6.37998226298e-14), VM_C(-4.91834898546e-14), VM_C(-2.10293378035e-15),
                                VM_C(8.58360954133e-17), VM_C(3.02997111408e-19)};
    VM_TABLE vm_real lowest[5] = {VM_C(-7.41197620451e-15), VM_C(1.18689975044e-14), VM_C(2.07874802509e-15),
                                  VM_C(-6.6640947106e-16), VM_C(-2.54688931285e-18)};
#endif
    if (which_word == 0) return VM_READ(high[i]);
    if (which_word == 1) return i < (int)(sizeof low / sizeof *low) ? VM_READ(low[i]) : 0;
    return i < (int)(sizeof lowest / sizeof *lowest) ? VM_READ(lowest[i]) : 0;
}

/* The degree of the polynomial of vmi_ateb_coefficient */
enum { VMI_ATEB_DEGREE = VM_MANT_DIG > 24 ? 33 : 17 };

/* Returns the polynomial of vmi_ateb_coefficient in two words. From index TWO_WORDS on the coefficients are so small
   that one word is enough. The relative error of the polynomial is below 2^-105 (float 2^-47.7), without rounding. No
   coefficient has a smaller binary exponent than the sum of the terms after it, so that Dekker's faster sum
   (vmi_fast_two_sum) is exact for the high words. */
VM_API vm_two vmi_ateb_polynomial(vm_two t)
{
    enum { TWO_WORDS = VM_MANT_DIG > 24 ? 17 : 8 };
    vm_two sum;
    vm_real tail = vmi_ateb_coefficient(0, VMI_ATEB_DEGREE);
    int i;
    for (i = VMI_ATEB_DEGREE - 1; i >= TWO_WORDS; i--) tail = vmi_ateb_coefficient(0, i) + tail * t.hi;
    sum = vmi_two(tail, 0);
    for (i = TWO_WORDS - 1; i >= 0; i--) {
        const vm_real high = vmi_ateb_coefficient(0, i), low = vmi_ateb_coefficient(1, i);
        const vm_two p = vmi_two_product(sum.hi, t.hi);
        const vm_real hi = high + p.hi;
        sum.lo = (p.hi - (hi - high)) + (p.lo + (sum.hi * t.lo + sum.lo * t.hi) + low);
        sum.hi = hi;
    }
    return sum;
}

/* Returns f(q) = q Pi_alpha, where q = 1/(alpha + 1), with a relative error below 2^-98.8 (float 2^-40.8) */
VM_API vm_two vmi_ateb_gamma_ratio(vm_two q)
{
    const vm_two one = {1, 0}, minus_one = {-1, 0}, twice_q = vmi_two(2 * q.hi, 2 * q.lo);
    const vm_two q_plus_1 = vmi_two_plus(one, q), q_plus_2 = vmi_two_plus(one, q_plus_1);
    const vm_two q_plus_3 = vmi_two_plus(one, q_plus_2);
    const vm_two divisor = vmi_two_times(vmi_two_times(q_plus_1, q_plus_2), q_plus_3);
    return vmi_two_over(vmi_ateb_polynomial(vmi_two_plus(minus_one, twice_q)), divisor);
}

/* Returns Pi_alpha/2 in three words, with a relative error of 2^-125 (float 2^-58), for n = alpha + 1 < 1e9 (float
   3e4). The result is n f(q)/2. The polynomial of vmi_ateb_coefficient, divided by 1 + q, 2 + q and 3 + q, is f(q). The
   quotient 1/(i + q) is computed as n/(i n + 1). */
VM_API vmi_three vmi_ateb_finest_quarter(vm_two n_two)
{
    const vmi_three one = vmi_three_words(1, 0, 0), n = vmi_three_words(n_two.hi, n_two.lo, 0);
    const vmi_three t = vmi_three_over(vmi_three_plus(vmi_three_words(2, 0, 0), vmi_three_words(-n.hi, -n.mid, 0)),
                                       n);
    vmi_three sum = vmi_three_words(vmi_ateb_coefficient(0, VMI_ATEB_DEGREE), 0, 0), above = one;
    int i;
    for (i = VMI_ATEB_DEGREE - 1; i >= 0; i--)
        sum = vmi_three_plus(
            vmi_three_times(sum, t),
            vmi_three_words(vmi_ateb_coefficient(0, i), vmi_ateb_coefficient(1, i), vmi_ateb_coefficient(2, i)));
    for (i = 1; i <= 3; i++) {
        above = vmi_three_plus(above, n);
        sum = vmi_three_times(sum, vmi_three_over(n, above));
    }
    return vmi_three_times(sum, vmi_three_words(n.hi / 2, n.mid / 2, 0));
}

/* The columns of the table of g(q) = Pi_alpha - (alpha + 1), where q = 1/(alpha + 1). The row with the index `row` is
   for q = row/32. The columns are, in this order: the low word of g, the low word of the slope of g, g, the slope, and
   the further coefficients of the Taylor series of g about this q. The slope has only half of the digits of a vm_real;
   its product with another number of half of the digits is exact. */
enum {
    VMI_ATEB_G_LOW,
    VMI_ATEB_G_SLOPE_LOW,
    VMI_ATEB_G_VALUE,
    VMI_ATEB_G_SLOPE,
    VMI_ATEB_G_SERIES,
    VMI_ATEB_G_COLUMNS = VM_MANT_DIG > 24 ? 12 : 8
};

/* Returns a number from the table of g(q), where q = 1/(alpha + 1). Row 0 is for q = 0 (g = 2 ln 2), row 32 for q = 1
   (g = 1). */
VM_INLINE vm_real vmi_ateb_g_constant(int row, int column)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real table[33][VMI_ATEB_G_COLUMNS] = {
        {VM_C(4.6381784140415292946e-17), VM_C(5.331171102802348789e-9), VM_C(1.3862943611198905725),
         VM_C(-0.68402804434299468994), VM_C(0.5677838543520554726), VM_C(-0.52915485716514631953),
         VM_C(0.51340603033793608123), VM_C(-0.50637868382441575399), VM_C(0.50309358102303392002),
         VM_C(-0.50151740078556006353), VM_C(0.50105490721077416971), VM_C(-0.50067714700750998169)},
        {VM_C(-3.746949124584277166e-17), VM_C(-3.375761016203596395e-10), VM_C(1.3654572877816153476),
         VM_C(-0.65003146231174468994), VM_C(0.52103618593312694962), VM_C(-0.4696330854200412297),
         VM_C(0.44114986130835415201), VM_C(-0.42153445212145007615), VM_C(0.40589002564213277902),
         VM_C(-0.39223584488976526163), VM_C(0.37991845750708058693), VM_C(-0.36809154922123549225)},
        {VM_C(-7.8406819950210754769e-17), VM_C(3.3966535452023658325e-9), VM_C(1.3456387054272960224),
         VM_C(-0.61879067122936248779), VM_C(0.47946987489163483964), VM_C(-0.41837065067676054708),
         VM_C(0.38083583828521405668), VM_C(-0.35286673006145163889), VM_C(0.32959475277592498177),
         VM_C(-0.30903951242953936474), VM_C(0.29046700106892275883), VM_C(-0.27311845414073881999)},
        {VM_C(-9.1553345977383271773e-17), VM_C(5.0567374634387609403e-9), VM_C(1.3267573146735365253),
         VM_C(-0.59000463783740997314), VM_C(0.44237592877439152472), VM_C(-0.37402081765250377865),
         VM_C(0.3302167737610899878), VM_C(-0.2969402684662968972), VM_C(0.26927906310655541633),
         VM_C(-0.24518921345206348694), VM_C(0.22381875903490874857), VM_C(-0.20441471614701206549)},
        {VM_C(6.654971387994451498e-17), VM_C(3.3436286599409676238e-9), VM_C(1.3087405697461549359),
         VM_C(-0.5634129643440246582), VM_C(0.40915942629353885263), VM_C(-0.33548699941222598353),
         VM_C(0.28751668597927382276), VM_C(-0.25111964491493382612), VM_C(0.22127227394038748165),
         VM_C(-0.19581235997028939577), VM_C(0.17373966474009477912), VM_C(-0.15425084140040531966)},
        {VM_C(2.2024860108414943077e-17), VM_C(5.4446360580413684035e-9), VM_C(1.2915235131302789107),
         VM_C(-0.5387894362211227417), VM_C(0.37931859969562842227), VM_C(-0.30187095778239825261),
         VM_C(0.25132242412520844344), VM_C(-0.21336754591646725498), VM_C(0.18281734294869281254),
         VM_C(-0.15735295297007001469), VM_C(0.13580929352374890295), VM_C(-0.11730133905365178193)},
        {VM_C(9.9540672703090293547e-18), VM_C(4.8101252302153244851e-9), VM_C(1.2750477928546863904),
         VM_C(-0.51593671739101409912), VM_C(0.35242819529002022971), VM_C(-0.27243277384856789958),
         VM_C(0.22050230344455343245), VM_C(-0.18209763033984616154), VM_C(0.15182681678020867877),
         VM_C(-0.12719288577525503237), VM_C(0.10686296199078124114), VM_C(-0.089858625474818029644)},
        {VM_C(5.4062922199915057231e-17), VM_C(2.9913058690087808791e-9), VM_C(1.2592608297557805752),
         VM_C(-0.49468202143907546997), VM_C(0.32812615163036995547), VM_C(-0.24655968937155745002),
         VM_C(0.19414452552092564819), VM_C(-0.15606625168439275386), VM_C(0.12670819938059293963),
         VM_C(-0.10338845876742652763), VM_C(0.084614317519929316269), VM_C(-0.069315954758375611378)},
        {VM_C(-6.0802945081877102697e-17), VM_C(-1.6253271077599876218e-9), VM_C(1.2441151085842396817),
         VM_C(-0.47487349808216094971), VM_C(0.30610286869586122993), VM_C(-0.2237416866522687342),
         VM_C(0.17151021694609555612), VM_C(-0.13429210727999726926), VM_C(0.10623784786903479882),
         VM_C(-0.084485231450717512836), VM_C(0.067397287639013842009), VM_C(-0.053823392856868976231)},
        {VM_C(2.2922259916551777034e-17), VM_C(3.7121489121588666953e-9), VM_C(1.2295675719059040443),
         VM_C(-0.45637725293636322021), VM_C(0.28609251412274883108), VM_C(-0.20355222507963094403),
         VM_C(0.15199735733327637832), VM_C(-0.11599613738196930257), VM_C(0.089469120401370685891),
         VM_C(-0.069386696616545145977), VM_C(0.053987849279679638037), VM_C(-0.042056431764961578479)},
        {VM_C(-8.0795939207491025052e-18), VM_C(-2.7226562956162019136e-9), VM_C(1.2155790997479136717),
         VM_C(-0.43907479196786880493), VM_C(0.26786594113039835507), VM_C(-0.18563295171266502859),
         VM_C(0.13511288180544195336), VM_C(-0.10055623188728740613), VM_C(0.075664922022792471812),
         VM_C(-0.057260299500816687346), VM_C(0.043479743608099391539), VM_C(-0.033058757380318597174)},
        {VM_C(4.7816802184330405841e-19), VM_C(1.9756706117912506114e-9), VM_C(1.2021140611045799673),
         VM_C(-0.42286099493503570557), VM_C(0.25122488928148434262), VM_C(-0.16968149496366849438),
         VM_C(0.12045096510876490692), VM_C(-0.087472852038395138008), VM_C(0.064247780831554288095),
         VM_C(-0.047469612515712286682), VM_C(0.035197017012146607218), VM_C(-0.026134360033998466077)},
        {VM_C(-9.5450403254978507853e-17), VM_C(-8.1999868771171600589e-10), VM_C(1.1891399259348427453),
         VM_C(-0.40764225274324417114), VM_C(0.23599721216040245308), VM_C(-0.15544166538668593991),
         VM_C(0.10767601302138693486), VM_C(-0.07634275918323399357), VM_C(0.054762624157525252588),
         VM_C(-0.039524992157935145976), VM_C(0.02863194225078574337), VM_C(-0.020772813788626273007)},
        {VM_C(-9.4063424025832752954e-17), VM_C(3.1812021489420587423e-9), VM_C(1.1766269282978578659),
         VM_C(-0.39333503693342208862), VM_C(0.22203293158224132742), VM_C(-0.142695547155390845),
         VM_C(0.096509262200188850045), VM_C(-0.066838808725968895663), VM_C(0.046848827808788760796),
         VM_C(-0.033047406672723836363), VM_C(0.023400590533385924596), VM_C(-0.016597068906664874666)},
        {VM_C(-1.0211730748417630065e-16), VM_C(5.9013741946619049536e-11), VM_C(1.16454777289448419),
         VM_C(-0.37986455857753753662), VM_C(0.20920096049727193721), VM_C(-0.13125708315803222281),
         VM_C(0.08671816364546579281), VM_C(-0.058694313043688293996), VM_C(0.040219086904567845353),
         VM_C(-0.027741725268581755859), VM_C(0.019210785527825898628), VM_C(-0.013326666437091310227)},
        {VM_C(-2.7048390872224065209e-18), VM_C(-2.6736593886606200744e-9), VM_C(1.1528773785938013496),
         VM_C(-0.36716372519731521606), VM_C(0.19738636957224631185), VM_C(-0.12096684650876125822),
         VM_C(0.07810792647354045104), VM_C(-0.051690868937492417956), VM_C(0.034643340757513838013),
         VM_C(-0.023376856621966111971), VM_C(0.015838814906640776015), VM_C(-0.010751610539873293626)},
        {VM_C(-9.9579915187844247504e-17), VM_C(-9.6786481397990003401e-10), VM_C(1.141592653589793338),
         VM_C(-0.35517217963933944702), VM_C(0.18648809789096257306), VM_C(-0.11168775940024938675),
         VM_C(0.070514747928371840358), VM_C(-0.045648828685767445235), VM_C(0.02993646779208306713),
         VM_C(-0.019770882078257778769), VM_C(0.01311238479152660244), VM_C(-8.7136680256610331285e-3)},
        {VM_C(-3.0462765550502953801e-17), VM_C(-1.4459812228645864948e-9), VM_C(1.130672297703971374),
         VM_C(-0.343835487961769104), VM_C(0.17641702808535342228), VM_C(-0.10330157218996104118),
         VM_C(0.063800366849676534708), VM_C(-0.040419800419741531983), VM_C(0.02594881102450546928),
         VM_C(-0.016779856704295884745), VM_C(0.010898058030344666414), VM_C(-7.0928854257970115268e-3)},
        {VM_C(6.8274309249854587011e-17), VM_C(2.3320810199713432271e-9), VM_C(1.1200966280640243244),
         VM_C(-0.33310446888208389282), VM_C(0.16709436179882838913), VM_C(-0.095705955493318242699),
         VM_C(0.057847661342177718324), VM_C(-0.035880715239089804036), VM_C(0.022558841989770438835),
         VM_C(-0.01428932191598817833), VM_C(9.0919360921870237546e-3), VM_C(-5.7977994985198063466e-3)},
        {VM_C(-5.9217966342746265894e-17), VM_C(-2.6690627410852378943e-9), VM_C(1.1098474249771592692),
         VM_C(-0.32293456047773361206), VM_C(0.1584502436816834503), VM_C(-0.088812088838981742556),
         VM_C(0.052557074474749915227), VM_C(-0.031929110593007251073), VM_C(0.019667449875678016252),
         VM_C(-0.012207835613912186926), VM_C(7.6127035867722099918e-3), VM_C(-4.758281525726736072e-3)},
        {VM_C(-5.3337385117691098856e-17), VM_C(3.0639526436566566665e-9), VM_C(1.0999077953037963429),
         VM_C(-0.31328535079956054688), VM_C(0.15042259186848722097), VM_C(-0.082542653331753937374),
         VM_C(0.047843699768046837884), VM_C(-0.028479362836590253055), VM_C(0.017193472869526747054),
         VM_C(-0.010462012666557350682), VM_C(6.3964050715056017596e-3), VM_C(-3.9202730131148678591e-3)},
        {VM_C(-2.5852775620714354257e-18), VM_C(-3.5400502752691179151e-9), VM_C(1.090262051041828828),
         VM_C(-0.3041200488805770874), VM_C(0.14295610065487995843), VM_C(-0.076830154408312603675),
         VM_C(0.043634894854055736313), VM_C(-0.025459664276221493501), VM_C(0.015070184188516319232),
         VM_C(-8.9927027536845730721e-3), VM_C(5.3925000300142390819e-3), VM_C(-3.2418888508938324515e-3)},
        {VM_C(9.9246083430337476394e-17), VM_C(2.5509443956017458929e-9), VM_C(1.0808956011689900834),
         VM_C(-0.29540517926216125488), VM_C(0.1360013873081173108), VM_C(-0.0716155153879257933),
         VM_C(0.039868319831367071693), VM_C(-0.022809586996830531064), VM_C(0.013242515682736362079),
         VM_C(-7.7520295532411713155e-3), VM_C(4.5608666894276376005e-3), VM_C(-2.690515550255248578e-3)},
        {VM_C(-5.9897851285567459795e-17), VM_C(1.6172271141304440397e-9), VM_C(1.0717948550731974944),
         VM_C(-0.28711014240980148315), VM_C(0.12951425994374426987), VM_C(-0.066846894038539286798),
         VM_C(0.036490318575518543298), VM_C(-0.020478111332291881741), VM_C(0.011664854158522162952),
         VM_C(-6.7010857957690893663e-3), VM_C(3.8695143163100156197e-3), VM_C(-2.2406380947033741405e-3)},
        {VM_C(3.016465714228832098e-18), VM_C(2.4695120036208870772e-9), VM_C(1.0629471361378510785),
         VM_C(-0.27920698374509811401), VM_C(0.12345508743621315395), VM_C(-0.062478683497586805229),
         VM_C(0.033454578137507531843), VM_C(-0.018422023916637494251), VM_C(0.010299284580012418866),
         VM_C(-5.8081303452508096022e-3), VM_C(3.292827492278427564e-3), VM_C(-1.8722034976943724947e-3)},
        {VM_C(-6.7885816850207377254e-17), VM_C(-2.8352089103464824646e-9), VM_C(1.0543406042488874252),
         VM_C(-0.27167008072137832642), VM_C(0.11778825560291796004), VM_C(-0.058470666138846466575),
         VM_C(0.030721014526891188279), VM_C(-0.01660461097402374589), VM_C(9.1141835909442688729e-3),
         VM_C(-5.0471714890422533437e-3), VM_C(2.8102120006443902234e-3), VM_C(-1.5693819858547722844e-3)},
        {VM_C(-4.8884482001293992351e-18), VM_C(3.2918614272578414737e-9), VM_C(1.045964186159314746),
         VM_C(-0.26447594910860061646), VM_C(0.11248169656410501871), VM_C(-0.054787294768893747554),
         VM_C(0.028254843492921118825), VM_C(-0.01499458844181024951), VM_C(8.0830889010808874146e-3),
         VM_C(-4.3968487820084424522e-3), VM_C(2.4050454828868908161e-3), VM_C(-1.3196244049906852291e-3)},
        {VM_C(-3.5398554210224009345e-18), VM_C(-3.1171937288947575956e-9), VM_C(1.0378075127902413044),
         VM_C(-0.25760296732187271118), VM_C(0.10750648035697503435), VM_C(-0.051397080182324583753),
         VM_C(0.026025803039909273934), VM_C(-0.013565222837864510455), VM_C(7.1837868506000896601e-3),
         VM_C(-3.8395467648870318551e-3), VM_C(2.0638605358970648317e-3), VM_C(-1.112941487533637263e-3)},
        {VM_C(-4.0391380447778101554e-17), VM_C(3.1769042596508692042e-10), VM_C(1.0298608626692795642),
         VM_C(-0.25103127956390380859), VM_C(0.10283645966668036875), VM_C(-0.048272067845909656658),
         VM_C(0.024007500836052152182), VM_C(-0.012293606347121809053), VM_C(6.3975732522676739128e-3),
         VM_C(-3.3606895825154759969e-3), VM_C(1.7757059442108575394e-3), VM_C(-9.4135014507881330671e-4)},
        {VM_C(1.1004437886233412308e-16), VM_C(4.701498157302724517e-10), VM_C(1.022115110811197658),
         VM_C(-0.24474254995584487915), VM_C(0.098447960005484252966), VM_C(-0.04538738950603821154),
         VM_C(0.022176864775268808477), VM_C(-0.011160057062385228197), VM_C(5.7086524083553797163e-3),
         VM_C(-2.9481773484921723616e-3), VM_C(1.5316450665393398917e-3), VM_C(-7.9844612972935396014e-4)},
        {VM_C(2.1474828901899838984e-17), VM_C(1.4754166857551727581e-9), VM_C(1.0145616824346503915),
         VM_C(-0.23871986940503120422), VM_C(0.09431950888413269396), VM_C(-0.042720877967710867151),
         VM_C(0.020513679018043618624), VM_C(-0.010147621158607981681), VM_C(5.1036467410569058209e-3),
         VM_C(-2.5919340443829423648e-3), VM_C(1.3243602998215997426e-3), VM_C(-6.7907276417713006902e-4)},
        {VM_C(-3.2951293899217698702e-17), VM_C(-1.6841489971875676284e-9), VM_C(1.0071925109851387337),
         VM_C(-0.2329475991427898407), VM_C(0.09043159852436784274), VM_C(-0.040252735291690058816),
         VM_C(0.019000191092083566075), VM_C(-9.2416583776976160558e-3), VM_C(4.5711953070301878516e-3),
         VM_C(-2.2835435377179360075e-3), VM_C(1.1478399428764794743e-3), VM_C(-5.7906304505224133819e-4)},
        {VM_C(4.1737691769177295977e-25), VM_C(-1.6803660290724359071e-10), VM_C(1.0),
         VM_C(-0.22741127759218215942), VM_C(0.086766477496790353485), VM_C(-0.037965246289469310736),
         VM_C(0.017620778248648341635), VM_C(-8.4294958327997809161e-3), VM_C(4.1016239960195060091e-3),
         VM_C(-2.015955492573712985e-3), VM_C(9.9712933651232107425e-4), VM_C(-4.9503803745002848344e-4)}};
#else
    VM_TABLE vm_real table[33][VMI_ATEB_G_COLUMNS] = {
        {VM_C(-3.80907971831e-9), VM_C(5.39922366443e-5), VM_C(1.38629436493), VM_C(-0.68408203125),
         VM_C(0.56778383255), VM_C(-0.529154837132), VM_C(0.513590335846), VM_C(-0.506562411785)},
        {VM_C(-8.58965965023e-9), VM_C(1.15021728561e-4), VM_C(1.36545729637), VM_C(-0.650146484375),
         VM_C(0.521036148071), VM_C(-0.469633072615), VM_C(0.441298544407), VM_C(-0.421678125858)},
        {VM_C(-4.65561953433e-8), VM_C(1.0581654351e-4), VM_C(1.34563875198), VM_C(-0.618896484375),
         VM_C(0.479469865561), VM_C(-0.418370634317), VM_C(0.380956560373), VM_C(-0.352979928255)},
        {VM_C(2.85267498512e-9), VM_C(8.32578443806e-5), VM_C(1.32675731182), VM_C(-0.590087890625),
         VM_C(0.442375928164), VM_C(-0.374020814896), VM_C(0.330315411091), VM_C(-0.297030091286)},
        {VM_C(-4.60984708184e-8), VM_C(6.36015029158e-5), VM_C(1.30874061584), VM_C(-0.5634765625),
         VM_C(0.409159421921), VM_C(-0.335486978292), VM_C(0.287597745657), VM_C(-0.25119137764)},
        {VM_C(5.6556874739e-8), VM_C(2.89285981125e-5), VM_C(1.29152345657), VM_C(-0.538818359375),
         VM_C(0.379318594933), VM_C(-0.301870942116), VM_C(0.25138938427), VM_C(-0.213425189257)},
        {VM_C(1.37715039372e-8), VM_C(-6.75719566061e-5), VM_C(1.27504777908), VM_C(-0.515869140625),
         VM_C(0.352428197861), VM_C(-0.272432774305), VM_C(0.220557913184), VM_C(-0.182144224644)},
        {VM_C(5.60970860874e-8), VM_C(-5.31121986569e-5), VM_C(1.25926077366), VM_C(-0.49462890625),
         VM_C(0.328126132488), VM_C(-0.246559679508), VM_C(0.1941909343), VM_C(-0.156104117632)},
        {VM_C(-5.62774804536e-9), VM_C(-1.99840833375e-5), VM_C(1.24411511421), VM_C(-0.474853515625),
         VM_C(0.306102871895), VM_C(-0.223741680384), VM_C(0.171549126506), VM_C(-0.134323045611)},
        {VM_C(4.4134949917e-8), VM_C(4.36492118752e-5), VM_C(1.22956752777), VM_C(-0.456420898438),
         VM_C(0.28609251976), VM_C(-0.203552216291), VM_C(0.15203012526), VM_C(-0.116021551192)},
        {VM_C(-5.23592902368e-8), VM_C(1.21193716041e-5), VM_C(1.21557915211), VM_C(-0.439086914063),
         VM_C(0.267865926027), VM_C(-0.185632944107), VM_C(0.13514059782), VM_C(-0.10057720542)},
        {VM_C(-4.41200000978e-8), VM_C(-9.43045961321e-6), VM_C(1.20211410522), VM_C(-0.4228515625),
         VM_C(0.25122487545), VM_C(-0.169681489468), VM_C(0.120474494994), VM_C(-0.0874902382493)},
        {VM_C(-3.62614827054e-8), VM_C(-4.94801242894e-5), VM_C(1.1891399622), VM_C(-0.407592773438),
         VM_C(0.235997214913), VM_C(-0.155441656709), VM_C(0.107696071267), VM_C(-0.0763572379947)},
        {VM_C(7.59780593995e-9), VM_C(-2.44868770096e-5), VM_C(1.1766269207), VM_C(-0.393310546875),
         VM_C(0.222032934427), VM_C(-0.14269554615), VM_C(0.0965264216065), VM_C(-0.0668509155512)},
        {VM_C(-2.81232583887e-8), VM_C(1.82539806701e-5), VM_C(1.16454780102), VM_C(-0.3798828125),
         VM_C(0.209200963378), VM_C(-0.131257086992), VM_C(0.0867328941822), VM_C(-0.0587044730783)},
        {VM_C(4.78137884841e-8), VM_C(2.37721287704e-5), VM_C(1.15287733078), VM_C(-0.3671875),
         VM_C(0.197386369109), VM_C(-0.120966844261), VM_C(0.078120611608), VM_C(-0.0516994297504)},
        {VM_C(3.17865236354e-8), VM_C(5.24287679582e-5), VM_C(1.1415926218), VM_C(-0.355224609375),
         VM_C(0.186488091946), VM_C(-0.111687757075), VM_C(0.0705257132649), VM_C(-0.0456560701132)},
        {VM_C(-3.79207101275e-8), VM_C(3.65809064533e-5), VM_C(1.13067233562), VM_C(-0.343872070313),
         VM_C(0.176417022943), VM_C(-0.103301569819), VM_C(0.0638098716736), VM_C(-0.0404259450734)},
        {VM_C(-5.54381642814e-8), VM_C(2.54162623605e-5), VM_C(1.1200966835), VM_C(-0.333129882813),
         VM_C(0.167094364762), VM_C(-0.0957059562206), VM_C(0.0578559227288), VM_C(-0.0358859486878)},
        {VM_C(-1.43732159508e-9), VM_C(-5.85865855101e-5), VM_C(1.10984742641), VM_C(-0.322875976563),
         VM_C(0.158450245857), VM_C(-0.0888120904565), VM_C(0.052564278245), VM_C(-0.0319335833192)},
        {VM_C(3.94520576208e-8), VM_C(-5.29258613824e-5), VM_C(1.09990775585), VM_C(-0.313232421875),
         VM_C(0.150422587991), VM_C(-0.0825426504016), VM_C(0.0478499978781), VM_C(-0.0284831952304)},
        {VM_C(-4.35519798003e-9), VM_C(-4.29039828305e-5), VM_C(1.0902620554), VM_C(-0.304077148438),
         VM_C(0.142956092954), VM_C(-0.0768301561475), VM_C(0.0436404161155), VM_C(-0.0254629570991)},
        {VM_C(5.80705474817e-8), VM_C(4.97953897138e-6), VM_C(1.0808955431), VM_C(-0.29541015625),
         VM_C(0.136001393199), VM_C(-0.0716155171394), VM_C(0.0398731715977), VM_C(-0.0228124260902)},
        {VM_C(-1.24423609194e-8), VM_C(-7.65792549373e-7), VM_C(1.07179486752), VM_C(-0.287109375),
         VM_C(0.12951426208), VM_C(-0.0668468922377), VM_C(0.036494590342), VM_C(-0.0204805657268)},
        {VM_C(-1.7907249017e-8), VM_C(-3.21765874105e-5), VM_C(1.06294715405), VM_C(-0.279174804688),
         VM_C(0.12345508486), VM_C(-0.0624786838889), VM_C(0.0334583483636), VM_C(-0.0184241514653)},
        {VM_C(3.28148419548e-9), VM_C(5.84320696362e-5), VM_C(1.05434060097), VM_C(-0.271728515625),
         VM_C(0.117788255215), VM_C(-0.0584706664085), VM_C(0.0307243522257), VM_C(-0.0166064593941)},
        {VM_C(-5.48685150648e-8), VM_C(5.04213712702e-5), VM_C(1.04596424103), VM_C(-0.264526367188),
         VM_C(0.112481698394), VM_C(-0.0547872930765), VM_C(0.0282578039914), VM_C(-0.0149961989373)},
        {VM_C(4.81906354821e-8), VM_C(-3.46110646205e-5), VM_C(1.0378074646), VM_C(-0.257568359375),
         VM_C(0.107506483793), VM_C(-0.0513970814645), VM_C(0.0260284338146), VM_C(-0.0135666290298)},
        {VM_C(8.52041726063e-9), VM_C(-5.47167473997e-5), VM_C(1.02986085415), VM_C(-0.2509765625),
         VM_C(0.102836459875), VM_C(-0.0482720695436), VM_C(0.0240098442882), VM_C(-0.0122948372737)},
        {VM_C(-5.39812805567e-10), VM_C(8.42707686388e-6), VM_C(1.02211511135), VM_C(-0.244750976563),
         VM_C(0.0984479561448), VM_C(-0.045387391001), VM_C(0.0221789553761), VM_C(-0.0111611364409)},
        {VM_C(2.92974462468e-8), VM_C(-1.13718360808e-5), VM_C(1.01456165314), VM_C(-0.238708496094),
         VM_C(0.0943195074797), VM_C(-0.0427208766341), VM_C(0.0205155480653), VM_C(-0.0101485708728)},
        {VM_C(1.85000939013e-8), VM_C(2.3590579076e-5), VM_C(1.00719249249), VM_C(-0.232971191406),
         VM_C(0.0904316008091), VM_C(-0.0402527339756), VM_C(0.0190018657595), VM_C(-9.24249459058e-3)},
        {VM_C(1.86536877897e-15), VM_C(5.71442706132e-6), VM_C(1.0), VM_C(-0.227416992188), VM_C(0.086766473949),
         VM_C(-0.0379652455449), VM_C(0.0176222808659), VM_C(-8.43023415655e-3)}};
#endif
    return VM_READ(table[row][column]);
}

/* Returns g(q) = Pi_alpha - (alpha + 1), where q = 1/(alpha + 1). g lies between 2 ln 2 (for q = 0) and 1 (for q = 1)
   and has an absolute error below 2^-62.5 (float 2^-33.5). g is computed as a polynomial in the distance h of q from
   the nearest multiple of 1/32. The low word of the result may be as large as 2^-13. */
VM_INLINE vm_two vmi_ateb_g(vm_two q)
{
#if VM_MANT_DIG > 24
    const vm_real to_row = VM_C(211106232532992.0); /* 1.5 2^47; adding it rounds a number to a multiple of 1/32 */
#else
    const vm_real to_row = VM_C(393216.0); /* 1.5 2^18; adding it rounds a number to a multiple of 1/32 */
#endif
    enum { S = VMI_ATEB_G_SERIES };
    const vm_real shifted = vmi_rounded(q.hi + to_row), h = q.hi - vmi_rounded(shifted - to_row);
    const vm_real h_head = vmi_head(h), hh = (h + q.lo) * (h + q.lo);
    const int row = (int)(vmi_to_bits(shifted) & 63);
    const vm_real slope = vmi_ateb_g_constant(row, VMI_ATEB_G_SLOPE);
    vm_two g = vmi_fast_two_sum(vmi_ateb_g_constant(row, VMI_ATEB_G_VALUE), slope * h_head); /* the product is exact */
    vm_real series = (vmi_ateb_g_constant(row, S) + h * vmi_ateb_g_constant(row, S + 1)) +
                     hh * (vmi_ateb_g_constant(row, S + 2) + h * vmi_ateb_g_constant(row, S + 3));
#if VM_MANT_DIG > 24
    series += (hh * hh) * ((vmi_ateb_g_constant(row, S + 4) + h * vmi_ateb_g_constant(row, S + 5)) +
                           hh * (vmi_ateb_g_constant(row, S + 6) + h * vmi_ateb_g_constant(row, S + 7)));
#endif
    g.lo += (slope * ((h - h_head) + q.lo) + vmi_ateb_g_constant(row, VMI_ATEB_G_SLOPE_LOW) * h +
             vmi_ateb_g_constant(row, VMI_ATEB_G_LOW)) +
            hh * series;
    return g;
}

/* The numbers from which sa, ca and Pi_alpha are computed for one alpha. Each low word is below an ulp of its high
   word, unless the comment of the function that sets it says otherwise. */
typedef struct VM_TAG(vmi_ateb) {
    vm_two n;       /* alpha + 1 */
    vm_two q;       /* 1/(alpha + 1) */
    vm_two g;       /* Pi_alpha - (alpha + 1) */
    vm_two quarter; /* Pi_alpha/2, a quarter of the period */
} vmi_ateb;

/* Sets the fields n = alpha + 1 and q = 1/n, and sets g and quarter to 0. The remainder 1 - n q is computed from the
   halves of n and q: the product of the first halves is exact. */
VM_INLINE void vmi_ateb_index_constants(vmi_ateb *c, vm_real alpha)
{
    vm_real n_head, n_tail, q_head;
    c->n = vmi_two_sum(alpha, 1);
    c->q.hi = 1 / c->n.hi;
    c->g = vmi_two(0, 0);
    c->quarter = vmi_two(0, 0);
    n_head = vmi_head(c->n.hi);
    q_head = vmi_head(c->q.hi);
    n_tail = (c->n.hi - n_head) + c->n.lo;
    c->q.lo = (((1 - n_head * q_head) - n_tail * q_head) - c->n.hi * (c->q.hi - q_head)) * c->q.hi;
}

/* Sets the fields g and quarter, whose low words may be as large as 2^-13. Where an argument is reduced by multiples of
   Pi_alpha/2, the absolute error of Pi_alpha is important. This error is small for a large alpha too, since Pi_alpha is
   computed as the sum of n = alpha + 1 and g. */
VM_INLINE void vmi_ateb_period_constants(vmi_ateb *c)
{
    c->g = vmi_ateb_g(c->q);
    c->quarter = vmi_fast_two_sum(c->n.hi, c->g.hi); /* exact, as n >= 1 and g < 2 */
    c->quarter.lo += c->n.lo + c->g.lo;
    c->quarter = vmi_half(c->quarter);
}

/* Sets the fields n, q, g and quarter. Each low word is below an ulp of its high word. */
VM_API void vmi_ateb_constants(vmi_ateb *c, vm_real alpha)
{
    vmi_ateb_index_constants(c, alpha);
    vmi_ateb_period_constants(c);
    c->g = vmi_fast_two_sum(c->g.hi, c->g.lo);
    c->quarter = vmi_fast_two_sum(c->quarter.hi, c->quarter.lo);
}

/* Pi_alpha, half the period of sa and ca, for alpha >= 0. Pi_alpha = B(1/(alpha + 1), 1/2) is a pure number: 2 for
   alpha = 0, pi for alpha = 1, and close to alpha + 1 + 2 ln 2 for a large alpha. The error is at most 1 ulp. Returns
   NaN for alpha < 0, NaN and infinite alpha. docs/cost.md has the time of a call. Equation (277). */
VM_API vm_real ateb_pi(vm_real alpha)
{
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha)) return VM_NAN;
    vmi_ateb_index_constants(&c, alpha);
    vmi_ateb_period_constants(&c);
    return 2 * vmi_fast_two_sum(c.quarter.hi, c.quarter.lo).hi;
}

/* Returns 1 if alpha is so large that three terms of the Taylor series of g(q) at q = 0 give the quarter period in two
   words, else 0. */
VM_API int vmi_ateb_is_large(const vmi_ateb *c) { return 8 * c->q.hi < VM_SQRT(VM_EPSILON); }

/* Returns g(q) = Pi_alpha - (alpha + 1) in two words for a large alpha: 2 ln 2 + q g'(0) + q^2 g''(0)/2. The product
   with g'(0) is in two words, too: in float one word is not enough next to a zero of ca. */
VM_API vm_two vmi_ateb_g_of_large(vm_two q)
{
#if VM_MANT_DIG > 24
    const vm_two two_ln2 = {VM_C(1.386294361119890618835), VM_C(4.638093627692599231e-17)};
    const vm_two slope = {VM_C(-0.6840280390118236297781), VM_C(4.2639853945799391236e-17)};
#else
    const vm_two two_ln2 = {VM_C(1.386294361119890618835), VM_C(-3.80930859992e-9)};
    const vm_two slope = {VM_C(-0.68402802944183349609), VM_C(-9.56999009104446e-9)};
#endif
    vm_two product = vmi_two_times(q, slope);
    product.lo += q.hi * q.hi * VM_C(0.5677838543520556957);
    return vmi_two_plus(two_ln2, product);
}

/* Returns Pi_alpha/2 with a relative error below 2^-98.6 (float 2^-40.6). Let n = alpha + 1 and q = 1/n. For a large
   alpha Pi_alpha is n + g(q); for any other alpha it is n f(q), where f is vmi_ateb_gamma_ratio. */
VM_API vm_two vmi_ateb_fine_quarter(const vmi_ateb *c)
{
    const vm_two one = {1, 0};
    if (vmi_ateb_is_large(c)) return vmi_half(vmi_two_plus(c->n, vmi_ateb_g_of_large(c->q)));
    return vmi_half(vmi_two_times(c->n, vmi_ateb_gamma_ratio(vmi_two_over(one, c->n))));
}

/* Returns Pi_alpha/2 in three words, with a relative error of 2^-122 (float 2^-52), from the fields n and q of *c. For
   alpha = 0 it is exact: then n = 1, Pi_alpha/2 = 1, and the zeros of sa and ca are the integers. */
VM_API vmi_three vmi_ateb_quarter_in_words(const vmi_ateb *c)
{
    vm_two g;
    if (c->n.hi == 1 && c->n.lo == 0) return vmi_three_words(1, 0, 0);
    if (!vmi_ateb_is_large(c)) return vmi_ateb_finest_quarter(c->n);
    g = vmi_ateb_g_of_large(c->q);
    return vmi_three_plus(vmi_three_words(c->n.hi / 2, c->n.lo / 2, 0), vmi_three_words(g.hi / 2, g.lo / 2, 0));
}

/* A function that sets all constants of one alpha: vmi_ateb_constants, or vmi_ateb_fine_constants */
typedef void (*vmi_ateb_constants_of)(vmi_ateb *c, vm_real alpha);

/* Sets the fields n, q, g and quarter, as vmi_ateb_constants does, but without the table of g: the code is shorter and
   the results are more accurate, but the function takes longer. */
VM_API void vmi_ateb_fine_constants(vmi_ateb *c, vm_real alpha)
{
    vmi_ateb_index_constants(c, alpha);
    c->quarter = vmi_ateb_fine_quarter(c);
    c->g = vmi_two_minus(vmi_two_scaled(c->quarter, 2), c->n);
    if (vmi_ateb_is_large(c)) c->g = vmi_ateb_g_of_large(c->q);
}

#endif
/* ateb/powers.h - a logarithm and an exponential that are quicker but less accurate

   vmi_log and vmi_exp (base/elementary.h) return two words. The functions in this file return one word, with an error
   of one or two ulp. ateb/inversion.h and ateb/plans.h use them where the error is later multiplied by a number below
   about 1/2.

       vm_real y = vmi_ateb_exp(vmi_ateb_ln(3) / 2); // the square root of 3

   The polynomials are computed by tests/gen/ateb_coefficients.py. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_POWERS_H
#define VARMASS_ATEB_POWERS_H

#include <stdint.h>

/* Returns a if all bits of the mask are set, and b if none is set. */
VM_INLINE vm_real vmi_select(vmi_bits mask, vm_real a, vm_real b)
{
    return vmi_from_bits((vmi_to_bits(a) & mask) | (vmi_to_bits(b) & ~mask));
}

/* Returns a mask with all bits set if x < 0, and with no bit set if x > 0. */
VM_INLINE vmi_bits vmi_mask_of_sign(vm_real x) { return 0 - (vmi_to_bits(x) >> (8 * sizeof(vm_real) - 1)); }

/* Returns L(x), where ln((1 + t)/(1 - t)) = 2 t + t^3 L(t^2), by a polynomial for |t| < 0.18. */
VM_INLINE vm_real vmi_ateb_ln_series(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_real xx = x * x;
    const vm_real L01 = VM_C(0.66666666666666727634) + x * VM_C(0.39999999999816214631);
    const vm_real L23 = VM_C(0.28571428661769779675) + x * VM_C(0.2222220559437561072);
    const vm_real L45 = VM_C(0.18183272190739985335) + x * VM_C(0.15319628746766105066);
    return (L01 + xx * L23) + (xx * xx) * (L45 + xx * VM_C(0.1475852205325647575));
#else
    return VM_C(0.666666914868) + x * (VM_C(0.399862738125) + x * VM_C(0.296881029198));
#endif
}

/* Returns ln((1 + t)/(1 - t)) for |t| < 0.18. */
VM_API vm_real vmi_ateb_ln_ratio(vm_real t)
{
    const vm_real x = t * t;
    return 2 * t + t * x * vmi_ateb_ln_series(x);
}

/* Writes a normal number x > 0 as 2^k z with z between sqrt(1/2) and sqrt(2). Returns z, and k in *k. When the bits
   of sqrt(1/2) are subtracted from those of x, the exponent of the difference is k. Older processors cannot convert
   long integers in vector registers to floating point; therefore the code makes k from the bits of the exponent. */
VM_INLINE vm_real vmi_ateb_mantissa(vm_real x, vm_real *k)
{
#if VM_MANT_DIG > 24
    const vmi_bits least = UINT64_C(0x3fe6a09e667f3bcd); /* sqrt(1/2) */
#else
    const vmi_bits least = UINT32_C(0x3f3504f3);
#endif
    const vm_real to_integer = 1 / VM_EPSILON; /* the last bits of this number plus an integer are the integer's bits */
    const vmi_bits one = (vmi_bits)1 << VMI_STORED_DIG, above = vmi_to_bits(x) - least;
    const vmi_bits exponent = (above + (VMI_BIAS + 1) * one) >> VMI_STORED_DIG;
    *k = vmi_from_bits(vmi_to_bits(to_integer) | exponent) - (to_integer + (VMI_BIAS + 1));
    return vmi_from_bits((above & (one - 1)) + least);
}

/* Returns ln(2^k (1 + t)/(1 - t)) for |t| < 0.18. The product of k and the first word of ln 2 has no rounding error. */
VM_API vm_real vmi_ateb_ln_of(vm_real k, vm_real t)
{
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    return k * ln2_hi + (vmi_ateb_ln_ratio(t) + k * ln2_lo);
}

/* Returns ln x for a normal number x > 0. */
VM_API vm_real vmi_ateb_ln(vm_real x)
{
    vm_real k;
    const vm_real z = vmi_ateb_mantissa(x, &k);
    return vmi_ateb_ln_of(k, (z - 1) / (z + 1));
}

/* Returns (e^z - 1 - z)/z^2 for |z| < 0.36, by a polynomial. */
VM_API vm_real vmi_ateb_exp_series(vm_real z)
{
    const vm_real zz = z * z;
#if VM_MANT_DIG > 24
    const vm_real E01 = VM_C(0.50000000000000000036) + z * VM_C(0.16666666666666673812);
    const vm_real E23 = VM_C(0.041666666666666509662) + z * VM_C(0.0083333333333225907093);
    const vm_real E45 = VM_C(0.0013888888888994840818) + z * VM_C(1.9841269886522535599e-4);
    const vm_real E67 = VM_C(2.4801587060781651877e-5) + z * VM_C(2.7557241366121292995e-6);
    const vm_real E89 = VM_C(2.7557527466964916697e-7) + z * VM_C(2.5110746416563258294e-8);
    const vm_real high = E89 + zz * VM_C(2.0830505426946652755e-9);
    return (E01 + zz * E23) + (zz * zz) * ((E45 + zz * E67) + (zz * zz) * high);
#else
    const vm_real E01 = VM_C(0.500000001824) + z * VM_C(0.166666664398);
    const vm_real E23 = VM_C(0.0416664198173) + z * VM_C(0.00833340486371);
    const vm_real E45 = VM_C(0.00139382863335) + z * VM_C(1.98219343782e-4);
    return E01 + zz * (E23 + zz * E45); /* this form avoids z^4, which could be subnormal and slow */
#endif
}

/* Returns e^x if e^x is a normal number. Method: x is written as k ln 2 + z with a whole k, so that e^x = 2^k
   (1 + z + z^2 E(z)), where E is vmi_ateb_exp_series. */
VM_INLINE vm_real vmi_ateb_exp(vm_real x)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360), to_integer = VM_C(1.5) / VM_EPSILON;
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const vm_real shifted = vmi_rounded(x * one_over_ln2 + to_integer), k = vmi_rounded(shifted - to_integer);
    const vm_real z = (x - k * ln2_hi) - k * ln2_lo;
    const vm_real scale = vmi_from_bits((vmi_to_bits(shifted) + VMI_BIAS) << VMI_STORED_DIG);
    return scale + scale * (z + z * z * vmi_ateb_exp_series(z));
}

/* Computes the logarithm to the base 2 of (2^k (1 + t)/(1 - t))^n as a sum *whole + *rest, for |t| < 0.18. *whole is
   n k, without the last digits of n, and has no rounding error. *rest has an error of at most 2 ulp. */
VM_INLINE void vmi_ateb_log2_of_power(vm_real n, vm_real k, vm_real t, vm_real *whole, vm_real *rest)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360), n_head = vmi_head(n);
    const vm_real slope = n * (t * one_over_ln2), x = t * t;
    *whole = n_head * k;
    *rest = (2 * slope + (n - n_head) * k) + (slope * x) * vmi_ateb_ln_series(x);
}

/* The least logarithm to the base 2 for which vmi_ateb_exp2 gives a normal number */
#define VMI_LEAST_LOG2 ((vm_real)(3 - VMI_BIAS))

/* Returns 2^(whole + rest) if the sum is at least VMI_LEAST_LOG2. Method: whole + rest = k + z/ln 2 with an integer k
   and |z| < 0.36, so that the result is 2^k (1 + z + z^2 E(z)), where E is vmi_ateb_exp_series. */
VM_INLINE vm_real vmi_ateb_exp2(vm_real whole, vm_real rest)
{
    const vm_real ln2 = VM_C(0.69314718055994530942), to_integer = VM_C(1.5) / VM_EPSILON;
    const vm_real shifted = vmi_rounded(whole + rest + to_integer), k = vmi_rounded(shifted - to_integer);
    const vm_real z = ((whole - k) + rest) * ln2;
    const vm_real scale = vmi_from_bits((vmi_to_bits(shifted) + VMI_BIAS) << VMI_STORED_DIG);
    return scale + scale * (z + z * z * vmi_ateb_exp_series(z));
}

#endif
/* ateb/inversion.h - inversion of the incomplete beta function, for sa and ca in the first quarter of the period

   Symbols, for s in the first quarter and q = 1/(alpha + 1):
     r, d    distances of s from the zero of sa and from the zero of ca; r + d = Pi_alpha/2
     v, u    sa and ca
     w, x    v^2 and 1 - w = u^(alpha+1)
     y, X    2 q d and y^(alpha+1)
     p       (1 - v)/2
   These numbers satisfy two equations. The second one follows from the quadratic transformation of
   2F1(1/2, q; 1 + q; x) (DLMF 15.8(iii)) and defines T:
     r = B_w(1/2, q)/2 = v u 2F1(1, q + 1/2; 3/2; w),
     2 q d = q B_x(q, 1/2) = u (1 + q T), where 1 + q T = 2F1(1, 2q; 1 + q; p).

   Up to r = 0.55 (VMI_ATEB_CHANGE_OVER) the first equation is solved for v; for larger r the second is solved for p. At
   r = 0.55, w < 0.303 and p < 0.251. The code takes a rough v and computes the r that belongs to it by the first
   equation. This r differs little from the given r, and a Taylor series in the difference gives sa and ca. The second
   equation is used in the same way, with p and ln X instead of v and r. Therefore one continued fraction for 2F1 and
   one power are enough.

   Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_INVERSION_H
#define VARMASS_ATEB_INVERSION_H

/* Up to this distance r from a zero of sa, sa is computed by vmi_ateb_near_sa_zero; for larger r by
   vmi_ateb_near_ca_zero. */
#define VMI_ATEB_CHANGE_OVER VM_C(0.55)

/* Gauss's continued fraction (DLMF 15.7) is 2F1(1, b; c; z) = 1/(1 - b z/(c Y_1)), where Y_j = 1 - e_j/Y_(j+1) and
     e_(2n-1) = n (c - b + n - 1) z/((c + 2n - 2) (c + 2n - 1)),
     e_(2n) = (b + n) (c + n - 1) z/((c + 2n - 1) (c + 2n)).
   For z < 0.303, two further levels of the fraction give at least 7 more bits. For large j, e_j is nearly z/4; from
   this value the last Y is estimated. VMI_ATEB_W_LEVELS and VMI_ATEB_P_LEVELS are the numbers of levels of the fraction
   in w and of the fraction in p. */
enum { VMI_ATEB_W_LEVELS = VM_MANT_DIG > 24 ? 12 : 6, VMI_ATEB_P_LEVELS = VM_MANT_DIG > 24 ? 12 : 6 };

/* Computes Y_1 = P/Q of Gauss's continued fraction (see above) without a division. Y is the value of Y_(levels+1).
   Element j of e_by_z is e_(j+1)/z, beginning with e_1/z. These elements do not depend on z, so that the processor
   can compute them while it waits for z. */
VM_INLINE void vmi_ateb_fraction(const vm_real *e_by_z, vm_real z, int levels, vm_real Y, vm_real *P, vm_real *Q)
{
    int j;
    *P = Y;
    *Q = 1;
    for (j = levels - 2; j >= 0; j -= 2) {
        const vm_real next = *P - (e_by_z[j + 1] * z) * *Q;
        *P = next - (e_by_z[j] * z) * *P;
        *Q = next;
    }
}

/* Returns (F - 1)/(w (q + 1/2)) for F = 2F1(1, q + 1/2; 3/2; w) and w < 0.303. In Gauss's continued fraction of F,
   e_(j+1)/w is constant[j] + q slope[j]. */
VM_API vm_real vmi_ateb_w_fraction(vm_real q, vm_real w)
{
    VM_TABLE vm_real constant[13] = {VM_C(4.0) / 15,    VM_C(9.0) / 35,    VM_C(16.0) / 63,   VM_C(25.0) / 99,
                                     VM_C(36.0) / 143,  VM_C(49.0) / 195,  VM_C(64.0) / 255,  VM_C(81.0) / 323,
                                     VM_C(100.0) / 399, VM_C(121.0) / 483, VM_C(144.0) / 575, VM_C(169.0) / 675,
                                     VM_C(196.0) / 783};
    VM_TABLE vm_real slope[13] = {VM_C(-4.0) / 15,   VM_C(6.0) / 35,   VM_C(-8.0) / 63,   VM_C(10.0) / 99,
                                  VM_C(-12.0) / 143, VM_C(14.0) / 195, VM_C(-16.0) / 255, VM_C(18.0) / 323,
                                  VM_C(-20.0) / 399, VM_C(22.0) / 483, VM_C(-24.0) / 575, VM_C(26.0) / 675,
                                  VM_C(-28.0) / 783};
    vm_real e_by_w[VMI_ATEB_W_LEVELS + 1], P, Q;
    int j;
    for (j = 0; j <= VMI_ATEB_W_LEVELS; j++) e_by_w[j] = VM_READ(constant[j]) + q * VM_READ(slope[j]);
    vmi_ateb_fraction(e_by_w, w, VMI_ATEB_W_LEVELS, 1 - e_by_w[VMI_ATEB_W_LEVELS] * w * (1 + w * (1 + w / 2) / 4),
                      &P, &Q);
    return Q / (VM_C(1.5) * P - (q + VM_C(0.5)) * w * Q);
}

/* Computes two numbers P and Q with 2F1(1, 2q; 1 + q; p) = P/(P - 2 q p Q/(1 + q)), for p < 0.251. In Gauss's continued
   fraction of this function, e_(j+1)/p is (constant + q slope + q^2 square)/((q + index)(q + index + 1)), where each
   name stands for element j of the table with this name. */
VM_INLINE void vmi_ateb_p_fraction(vm_real q, vm_real p, vm_real *P, vm_real *Q)
{
    VM_TABLE vm_real index[13] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
    VM_TABLE vm_real constant[12] = {1, 1, 4, 4, 9, 9, 16, 16, 25, 25, 36, 36};
    VM_TABLE vm_real slope[12] = {-1, 3, -2, 6, -3, 9, -4, 12, -5, 15, -6, 18};
    VM_TABLE vm_real square[12] = {0, 2, 0, 2, 0, 2, 0, 2, 0, 2, 0, 2};
    vm_real e_by_p[VMI_ATEB_P_LEVELS];
    int j;
    for (j = 0; j < VMI_ATEB_P_LEVELS; j++)
        e_by_p[j] = (VM_READ(constant[j]) + q * (VM_READ(slope[j]) + q * VM_READ(square[j]))) /
                    ((q + VM_READ(index[j])) * (q + VM_READ(index[j + 1])));
    vmi_ateb_fraction(e_by_p, p, VMI_ATEB_P_LEVELS, 1 - p * (1 + p / 2) / 4, P, Q);
}

/* Returns (1 - a^q)/q for a = (1 + t)/(1 - t), where ln a is small. No digits are lost. */
VM_API vm_real vmi_ateb_power_rest(vm_real t, vm_real q)
{
    const vm_real l = vmi_ateb_ln_ratio(t), z = q * l;
    return -l - l * z * vmi_ateb_exp_series(z);
}

/* Computes sa and ca at the distance r from the zero of sa, for 0 <= r <= VMI_ATEB_CHANGE_OVER. q is 1/(alpha + 1).
   `guess` is the power series of sa up to r^9, which is right to 1e-5; its coefficients are polynomials in k = 1 - q. v
   is the guess shortened to half of its digits, so that w = v^2 is exact. u is the ca that belongs to sa = v, and h is
   r minus the r that belongs to v. A Taylor series in e = h/u gives sa and ca. */
VM_API void vmi_ateb_near_sa_zero(vm_real r, vm_real q, vm_real *sa, vm_real *ca)
{
    const vm_real k = 1 - q, rr = r * r, b = q + VM_C(0.5);
    const vm_real c1 = -1 / VM_C(3.0);
    const vm_real c2 = (7 * k - 3) * (1 / VM_C(30.0));
    const vm_real c3 = ((-127 * k + 123) * k - 30) * (1 / VM_C(630.0));
    const vm_real c4 = (((4369 * k - 6822) * k + 3579) * k - 630) * (1 / VM_C(22680.0));
    const vm_real guess = r * (1 + k * rr * ((c1 + rr * c2) + rr * rr * (c3 + rr * c4)));
    const vm_real v = vmi_head(guess), w = v * v, x = 1 - w;
    const vm_real one_minus_u = q * vmi_ateb_power_rest(-w / (2 - w), q), u = 1 - one_minus_u, by_u = 1 / u;
    const vm_real h = (r - v) - v * (w * b * vmi_ateb_w_fraction(q, w) * u - one_minus_u), e = h * by_u;
    *sa = v + x * e * (1 - k * e * (v + (x - (2 - 4 * q) * w) * (e / 3)));
    *ca = 1 - (one_minus_u + h * q * (2 * v + x * e * (1 - k * v * e * VM_C(0.66666666666666667))));
}

/* Returns (2^k (1 + t)/(1 - t))^n/4 with a relative error of 2e-7 (1 + |logarithm of the result|), if the result is a
   normal number. The result is 2^power/4, where power is split into an integer and z between -1/2 and 1/2. */
VM_INLINE vm_real vmi_ateb_rough_power(vm_real k, vm_real t, vm_real n)
{
    const vm_real to_integer = VM_C(1.5) / VM_EPSILON, tt = t * t;
    const vm_real log2 = (VM_C(2.885390422) + tt * VM_C(0.9615889072)) + (tt * tt) * VM_C(0.5957613972);
    const vm_real power = n * k + (n * t) * log2, shifted = vmi_rounded(power + to_integer);
    const vm_real z = power - vmi_rounded(shifted - to_integer), zz = z * z;
    const vm_real low = VM_C(0.2500000189) + z * VM_C(0.173286797);
    const vm_real mid = VM_C(0.06005526871) + z * VM_C(0.01387589279);
    const vm_real high = VM_C(0.00241900798) + z * VM_C(0.0003347715841);
    return vmi_from_bits(vmi_to_bits((low + zz * mid) + (zz * zz) * high) +
                         (vmi_to_bits(shifted) << VMI_STORED_DIG));
}

/* The number y = 2 q d in two words, where q = 1/(alpha + 1) and d is the distance from a zero of ca. The power
   y^(alpha + 1) is X; ln y is vmi_ateb_ln_of(k, t). */
typedef struct VM_TAG(vmi_ateb_base) {
    vm_two y;
    vm_real k, t;
} vmi_ateb_base;

/* Returns 2 q d in two words, for q and d in two words. q and d are split into halves, whose products are exact. */
VM_INLINE vm_two vmi_ateb_twice_q_times(vm_two twice_q, vm_real d, vm_real d_lo)
{
    const vm_real q = twice_q.hi, q_head = vmi_head(q), d_head = vmi_head(d);
    vm_two y;
    y.hi = q * d + 0; /* "+ 0" keeps the compiler from fusing (vmi_two_product) */
    y.lo = (q_head * d_head - y.hi) + (q_head * (d - d_head) + (q - q_head) * d) + (twice_q.lo * d + q * d_lo);
    return y;
}

/* Returns the base y from the distances r and d of s from the zeros of sa and ca. y = 2 q d is also 1 - q z, where z
   = 2 r - (Pi_alpha - (alpha + 1)); this form is used for r < d and y > 0.71. The low word of y matters: for a large
   alpha, a small change of y is a large change of X = y^(alpha+1). For y < 1/2, X is so small that an inexact y.lo is
   enough: it is multiplied by 2 instead of 2^-k. */
VM_INLINE vmi_ateb_base vmi_ateb_base_of(vm_two twice_q, vm_real r, vm_real z, vm_real d, vm_real d_lo)
{
    const vm_real sqrt_half = VM_C(0.70710678118654752), qz = twice_q.hi * (z / 2);
    vmi_ateb_base base;
    vm_real mantissa, scale;
    if (r < d && qz < VM_C(0.29)) {
        base.y.hi = 1 - qz;
        base.y.lo = (1 - base.y.hi) - qz;
        base.k = 0;
        base.t = -qz / (2 - qz);
        return base;
    }
    base.y = vmi_ateb_twice_q_times(twice_q, d, d_lo);
    mantissa = vmi_ateb_mantissa(base.y.hi, &base.k);
    scale = VM_C(1.5) - VM_COPYSIGN(VM_C(0.5), base.y.hi - sqrt_half); /* 2^-k for y > 1/2 */
    base.t = ((mantissa - 1) + scale * base.y.lo) / (mantissa + 1);
    return base;
}

/* Returns p = (1 - sa)/2 within 1e-5, from X4 = X/4, where X = (2 q d)^(alpha+1). p/X4 is computed as a product of two
   factors: a quotient of two linear functions of X4 (a Pade approximant), and the correction 1 + X4^3 q (1 - q)
   (lack0 + lack1 X4). The polynomials lack0 and lack1 in q are fitted by tests/gen/ateb_coefficients.py. */
VM_INLINE vm_real vmi_ateb_guess_p(vm_real q, vm_real X4)
{
    const vm_real k = 1 - q, m = (1 + q) * (2 + q);
    const vm_real lack0 = VM_C(0.1695201) + q * (VM_C(-0.4597204) + q * (VM_C(0.3548526) - q * VM_C(0.1130212)));
    const vm_real lack1 = VM_C(-0.0790485) + q * VM_C(0.1329593);
    return ((m - (q + q * q) * X4) / (m + 2 * (k - q * q) * X4)) *
           (X4 + (X4 * X4) * (X4 * X4) * (q * k * (lack0 + X4 * lack1)));
}

/* Computes sa and ca at the distances r >= VMI_ATEB_CHANGE_OVER from the zero of sa and d from the zero of ca. The
   numbers q = 1/(alpha + 1), y = 2 q d and X = y^(alpha+1) are known. The unknown is p = (1 - sa)/2. From p follow
     v = sa = 1 - 2 p,   x = 1 - v^2 = 4 p (1 - p),   u = ca = x^q,   E = 2F1(1, 2q; 1 + q; p).
   Since y = u E, the wanted p is the solution of ln X = ln x + (alpha + 1) ln E. The derivatives with respect to ln X
   are
     dp/d(ln X) = x E/4,   d ln(u/y)/d(ln X) = -q (1 - v E).
   The function starts from a guess of p. rho is ln X minus the ln X that belongs to the guess; a Taylor series in
   rho gives sa and ca. */
VM_API void vmi_ateb_near_ca_zero(vm_real r, vm_real d, const vmi_ateb *c, vm_real *sa, vm_real *ca)
{
    const vm_real least_ln = -(vm_real)(VM_MANT_DIG + 2) * VM_C(0.6931471805599453); /* X < eps/8 may be neglected */
    const vm_real n = c->n.hi, q = c->q.hi, twice_q = 2 * q;
    const vmi_ateb_base base = vmi_ateb_base_of(vmi_two(twice_q, 2 * c->q.lo), r, (2 * r - c->g.hi) - c->g.lo, d, 0);
    const vm_real y = base.y.hi, ln_X = n * vmi_ateb_ln_of(base.k, base.t);
    vm_real p, v, P, Q;       /* a guess of p, its v = 1 - 2 p, and the results of vmi_ateb_p_fraction */
    vm_real B, E, E_loss;     /* B = 2 q p Q/(1 + q), E = P/(P - B), E_loss = 1 - 1/E, so that u = y (1 - E_loss) */
    vm_real rho, vE;          /* vE = v E */
    vm_real sa_rate, ca_rate; /* -d(sa)/d(ln X) and -d ln(ca/y)/d(ln X) */
    vm_real sa_change, ca_change;
    *sa = 1;
    *ca = y + base.y.lo;
    if (!(y > VM_MIN) || !(ln_X > least_ln)) return;
    p = vmi_ateb_guess_p(q, vmi_ateb_rough_power(base.k, base.t, n));
    v = 1 - 2 * p;
    vmi_ateb_p_fraction(q, p, &P, &Q);
    B = twice_q / (1 + q) * p * Q;
    E = P / (P - B);
    E_loss = B / P;
    rho = (ln_X - vmi_ateb_ln(4 * p * (1 - p))) - n * vmi_ateb_ln_ratio(B / (2 * P - B));
    vE = v * E;
    sa_rate = 2 * p * (1 - p) * E;
    ca_rate = q * (1 - vE);
    sa_change = (sa_rate * rho) * (1 + rho * ((q + (1 - q) * vE) / 2));
    ca_change = ((1 - E_loss) * rho) * (ca_rate - rho * ((ca_rate * (ca_rate + q * vE) - q * sa_rate * E) / 2));
    *sa = 1 - (2 * p + sa_change);
    *ca = y - (y * (E_loss + ca_change) - base.y.lo);
}

#endif
/* ateb/functions.h - the Ateb functions sa and ca for any real argument and any alpha >= 0

   v = sa(1, alpha, s) and u = ca(alpha, 1, s) solve v' = u|u|^(alpha-1), u' = -2 v/(alpha + 1) with v(0) = 0 and
   u(0) = 1: equations (275), (276). They have the period 2 Pi_alpha (ateb/period.h) and describe the motion of the
   oscillator with the restoring force x|x|^(alpha-1). For many arguments and one alpha prepare a plan (ateb/plans.h).

       vm_real sa, ca;
       ateb_saca(VM_C(0.7), VM_C(1.5), &sa, &ca);

   Method: s is reduced to the first quarter of the period, where an incomplete beta function is inverted
   (ateb/inversion.h). r is the distance of s from the nearest zero of sa, and d the distance from the nearest zero of
   ca, so that r + d = Pi_alpha/2. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_FUNCTIONS_H
#define VARMASS_ATEB_FUNCTIONS_H

/* The position of s in the period. s is `quarter` quarters of the period plus rest, where whole periods (4 quarters)
   are not counted. r and d are the distances of s from the nearest zeros of sa and ca. */
typedef struct VM_TAG(vmi_ateb_place) {
    vm_real rest, r, d;
    int quarter;
} vmi_ateb_place;

/* If s minus the nearest multiple of the quarter period is less than this number times s, the quarter period is needed
   in three words. */
#define VMI_ATEB_FINE_REACH (VM_MANT_DIG > 24 ? VM_C(6e-14) : VM_C(1.5e-5))

/* Returns s minus a multiple of the quarter period Q, which is given in three words. `rest` is the same difference,
   computed with two words. A division alone does not find the right multiple if it is larger than 1/(1000 eps);
   therefore it is corrected so that the result agrees with `rest`. */
VM_API vm_real vmi_ateb_rest_in_three_words(vm_real s, vmi_three Q, vm_real rest)
{
    const vm_real count = VM_FLOOR(s / Q.hi + VM_C(0.5));
    const vm_two high = vmi_two_product(count, Q.hi), mid = vmi_two_product(count, Q.mid);
    vm_real fine, further;
    if (!(count * VM_EPSILON < 1)) return rest; /* the digits of s do not determine the phase */
    fine = (((s - high.hi) - high.lo) - mid.hi) - (mid.lo + count * Q.lo);
    further = VM_FLOOR((fine - rest) / Q.hi + VM_C(0.5));
    return (fine - further * Q.hi) - further * Q.mid;
}

/* Returns s > 0 minus the nearest multiple of the quarter period, for an s that is large, or close to a zero of sa or
   ca. c->quarter becomes a sum of two words with a relative error below 2^-98.6 (float 2^-40.6). If the result is so
   small that this error would matter, the quarter period is used in three words. */
VM_API vm_real vmi_ateb_reduce_finely(vm_real s, vmi_ateb *c, int *quarter)
{
    vm_real rest;
    c->quarter = vmi_ateb_fine_quarter(c);
    rest = vmi_reduce(s, c->quarter, quarter).hi;
    if (!(VM_FABS(rest) < VMI_ATEB_FINE_REACH * s)) return rest;
    return vmi_ateb_rest_in_three_words(s, vmi_ateb_quarter_in_words(c), rest);
}

/* Returns a for the weight 1 and b for the weight 0. A condition would become a branch, and the processor would
   mispredict it half the time. */
VM_API vm_real vmi_choose(vm_real weight, vm_real a, vm_real b) { return weight * a + (1 - weight) * b; }

/* Returns the position of s >= 0 in the period, by the first of three methods that is accurate enough.
     1. An s <= (alpha + 1)/2 lies in the first quarter. Then r = s, which is known without Pi_alpha.
     2. For s <= 128 (alpha + 1), c->quarter is accurate enough, unless s is close to a zero of sa or ca. The high word
        of c->quarter is split into halves, whose products with the number of quarters are exact. The number of quarters
        is computed from the high word of c->quarter alone, so that the rest may be a little longer than half a quarter.
     3. Any other s is reduced by vmi_ateb_reduce_finely. */
VM_INLINE vmi_ateb_place vmi_ateb_locate(vm_real s, vmi_ateb *c)
{
    const vm_real n = c->n.hi, to_integer = VM_C(1.5) / VM_EPSILON;
    vmi_ateb_place at;
    vm_real size, other, odd;
    int is_coarse = s / 128 <= n;
    at.quarter = 0;
    at.rest = 0;
    if (s <= n / 2) {
        at.rest = s;
        at.r = s;
        at.d = (c->quarter.hi - s) + c->quarter.lo;
        return at;
    }
    if (is_coarse) { /* the last bits of the rounded quotient are the number of quarters */
        const vm_real high = vmi_head(c->quarter.hi), low = c->quarter.hi - high;
        const vm_real shifted = vmi_rounded(s / c->quarter.hi + to_integer);
        const vm_real count = vmi_rounded(shifted - to_integer);
        at.quarter = (int)(vmi_to_bits(shifted) & 3);
        at.rest = ((s - count * high) - count * low) - count * c->quarter.lo;
        is_coarse = VM_FABS(at.rest) * n * 1024 >= s;
    }
    if (!is_coarse) at.rest = vmi_ateb_reduce_finely(s, c, &at.quarter);
    odd = (vm_real)(at.quarter & 1);
    size = VM_FABS(at.rest);
    other = (c->quarter.hi - size) + c->quarter.lo;
    at.r = vmi_choose(odd, other, size);
    at.d = vmi_choose(odd, size, other);
    return at;
}

/* Gives *sa and *ca the signs of sa and ca at s. Before the call, *sa and *ca are the values in the first quarter. |s|
   is `quarter` quarters plus rest. The function works on the bits of the signs, without a branch. */
VM_INLINE void vmi_ateb_signs(vm_real s, vm_real rest, vmi_bits quarter, vm_real *sa, vm_real *ca)
{
    const int last = 8 * (int)sizeof(vm_real) - 1;
    const vmi_bits sign = (vmi_bits)1 << last, odd = quarter & 1;
    const vmi_bits half = quarter >> 1 << last, rest_bits = vmi_to_bits(rest);
    *sa = vmi_from_bits(vmi_to_bits(*sa) ^ half ^ ((vmi_to_bits(s) ^ (rest_bits & (odd - 1))) & sign));
    *ca = vmi_from_bits(vmi_to_bits(*ca) ^ half ^ (~rest_bits & (odd << last)));
}

/* sa(1, alpha, s) and ca(alpha, 1, s), the Ateb sine and cosine. s is any real number and alpha >= 0; both are pure
   numbers. |sa| <= 1 and |ca| <= 1. sa is odd in s and ca is even, to the last bit. The errors are at most 4 VM_EPSILON
   for |s| <= 1e9 (float 1e4), and at most 8 ulp for |s| <= 100 Pi_alpha, also next to the zeros of sa and ca. The
   results are NaN for alpha < 0 and for NaN and infinite arguments. docs/cost.md has the time of a call. Equations
   (275), (276). */
VM_API void ateb_saca(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca)
{
    vmi_ateb c;
    vmi_ateb_place at;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(s)) {
        *sa = VM_NAN;
        *ca = VM_NAN;
        return;
    }
    vmi_ateb_index_constants(&c, alpha);
    at.quarter = 0;
    at.rest = VM_FABS(s);
    at.r = at.rest;
    at.d = 0;
    if (at.r > VMI_ATEB_CHANGE_OVER) {
        vmi_ateb_period_constants(&c);
        at = vmi_ateb_locate(at.r, &c);
    }
    if (at.r <= VMI_ATEB_CHANGE_OVER) vmi_ateb_near_sa_zero(at.r, c.q.hi, sa, ca);
    else vmi_ateb_near_ca_zero(at.r, at.d, &c, sa, ca);
    vmi_ateb_signs(s, at.rest, (vmi_bits)at.quarter, sa, ca);
}

/* sa(1, alpha, s), the Ateb sine, alone.
   Domain and accuracy are those of ateb_saca, which computes both functions in the same time. */
VM_API vm_real ateb_sa(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return sa;
}

/* ca(alpha, 1, s), the Ateb cosine, alone.
   Domain and accuracy are those of ateb_saca, which computes both functions in the same time. */
VM_API vm_real ateb_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return ca;
}

#endif
/* base/elementary.h - logarithm, exponential, power, sine, cosine and arctangent, with the same bits on every machine

   The results of the C library's functions differ from machine to machine in the last bits. The functions of this file
   give the same bits everywhere: they use only basic operations, which every machine rounds in the same way. The
   logarithm and the exponential are computed in two words (see base/sums.h), so that a power made from them has all its
   digits. The logarithm and the exponential branch only where a number is subnormal, so that a compiler can vectorise
   loops over them.

       vm_real y = vmi_exp(VM_C(1.5), 0); // e^1.5

   The tables and polynomials are computed by tests/gen/elementary.py. docs/proof.md proves the bounds of the errors.
   Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_ELEMENTARY_H
#define VARMASS_BASE_ELEMENTARY_H

#include <stdint.h>

/* Returns a constant for vmi_log. The variable z of vmi_log lies in one of 32 intervals; `row` is the interval's
   number. Let c be a number close to all z of this interval. Column 0 is 1/c; columns 1 and 2 are the two words of ln
   c. The first words of ln c and of ln 2 are multiples of 2^-42 (float 2^-16). Therefore k ln 2 + ln c, computed from
   the first words for an integer k, has no rounding error. */
VM_INLINE vm_real vmi_log_constant(int row, int column)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real table[32][3] = {
        {VM_C(1.4189453125), VM_C(-0.34991385797093244037), VM_C(1.0263080618141573753e-13)},
        {VM_C(1.375), VM_C(-0.31845373111855224124), VM_C(1.7625431312172662057e-14)},
        {VM_C(1.3330078125), VM_C(-0.28743790201951924246), VM_C(-8.7770524478057945722e-14)},
        {VM_C(1.2939453125), VM_C(-0.25769593282097957854), VM_C(1.1008936326855972656e-13)},
        {VM_C(1.2568359375), VM_C(-0.22859740199669431604), VM_C(2.0747306192914545005e-14)},
        {VM_C(1.22265625), VM_C(-0.20102574606062262319), VM_C(3.1881849375437737022e-14)},
        {VM_C(1.189453125), VM_C(-0.1734936426703370671), VM_C(-5.2171826698845917966e-14)},
        {VM_C(1.158203125), VM_C(-0.14686977395831490867), VM_C(9.7240876868206596417e-14)},
        {VM_C(1.1279296875), VM_C(-0.12038381735646908055), VM_C(2.8259559616440998507e-14)},
        {VM_C(1.099609375), VM_C(-0.09495500310026727675), VM_C(8.4679504198281513406e-14)},
        {VM_C(1.0732421875), VM_C(-0.070684148804275537259), VM_C(1.0726890146864022217e-13)},
        {VM_C(1.0478515625), VM_C(-0.046741937031356428633), VM_C(1.1105125439752240142e-13)},
        {VM_C(1.0234375), VM_C(-0.023167059281604451826), VM_C(7.0073597043100356586e-14)},
        {VM_C(1.0), VM_C(0.0), VM_C(0.0)},
        {VM_C(0.9775390625), VM_C(0.022717026284226449206), VM_C(6.0597450660084316691e-15)},
        {VM_C(0.9560546875), VM_C(0.044940163068986294093), VM_C(-4.3582300048382453133e-14)},
        {VM_C(0.9365234375), VM_C(0.065580730715964818955), VM_C(5.0054796379247145689e-14)},
        {VM_C(0.9169921875), VM_C(0.086656326391221227823), VM_C(-3.1041724514644213313e-14)},
        {VM_C(0.8984375), VM_C(0.1070981355562707904), VM_C(9.6310110335192174531e-14)},
        {VM_C(0.8798828125), VM_C(0.12796654799103635014), VM_C(7.8829637969380855345e-14)},
        {VM_C(0.8623046875), VM_C(0.14814660499541787431), VM_C(7.5206341283980230625e-14)},
        {VM_C(0.845703125), VM_C(0.16758689703692652984), VM_C(9.1408198894914123398e-14)},
        {VM_C(0.830078125), VM_C(0.18623545611512781761), VM_C(-3.6862307174239401374e-14)},
        {VM_C(0.814453125), VM_C(0.2052384032406280312), VM_C(7.8304972192271964422e-14)},
        {VM_C(0.7998046875), VM_C(0.22338772174634868861), VM_C(3.4981611229820216869e-14)},
        {VM_C(0.7861328125), VM_C(0.24062952818098892749), VM_C(-9.9203828758961551027e-14)},
        {VM_C(0.771484375), VM_C(0.25943886013828887371), VM_C(9.7042267920673565155e-14)},
        {VM_C(0.7587890625), VM_C(0.27603145523175953713), VM_C(4.6116175827277368694e-14)},
        {VM_C(0.74609375), VM_C(0.29290401643288532796), VM_C(4.7274529405144062921e-14)},
        {VM_C(0.7333984375), VM_C(0.31006615383535063302), VM_C(-3.2283099979657674925e-14)},
        {VM_C(0.7216796875), VM_C(0.32617388465132535202), VM_C(-7.4032069124645893097e-14)},
        {VM_C(0.7099609375), VM_C(0.34254532806585302751), VM_C(8.0700749411504883334e-14)}};
#else
    VM_TABLE vm_real table[32][3] = {
        {VM_C(1.41796875), VM_C(-0.349227905273), VM_C(2.51548817687e-6)},
        {VM_C(1.375), VM_C(-0.318450927734), VM_C(-2.80338417724e-6)},
        {VM_C(1.33203125), VM_C(-0.286712646484), VM_C(7.61368028179e-6)},
        {VM_C(1.29296875), VM_C(-0.256942749023), VM_C(1.81812595201e-6)},
        {VM_C(1.2578125), VM_C(-0.229370117188), VM_C(-3.98387737732e-6)},
        {VM_C(1.22265625), VM_C(-0.201019287109), VM_C(-6.45895124762e-6)},
        {VM_C(1.1875), VM_C(-0.171844482422), VM_C(-5.77450464334e-6)},
        {VM_C(1.15625), VM_C(-0.14518737793), VM_C(5.36808511242e-6)},
        {VM_C(1.12890625), VM_C(-0.121246337891), VM_C(-2.90574234896e-6)},
        {VM_C(1.1015625), VM_C(-0.0967254638672), VM_C(-4.16259126723e-6)},
        {VM_C(1.07421875), VM_C(-0.0715942382813), VM_C(5.85094255712e-7)},
        {VM_C(1.046875), VM_C(-0.0458068847656), VM_C(-2.6512657314e-6)},
        {VM_C(1.0234375), VM_C(-0.0231628417969), VM_C(-4.21748472945e-6)},
        {VM_C(1.0), VM_C(0.0), VM_C(0.0)},
        {VM_C(0.9765625), VM_C(0.0237121582031), VM_C(4.36841401097e-6)},
        {VM_C(0.95703125), VM_C(0.0439147949219), VM_C(4.43901308245e-6)},
        {VM_C(0.9375), VM_C(0.0645446777344), VM_C(-6.15659700998e-6)},
        {VM_C(0.91796875), VM_C(0.0855865478516), VM_C(5.38248377779e-6)},
        {VM_C(0.8984375), VM_C(0.10710144043), VM_C(-3.30487341671e-6)},
        {VM_C(0.87890625), VM_C(0.12907409668), VM_C(2.94559549729e-6)},
        {VM_C(0.86328125), VM_C(0.147018432617), VM_C(-3.68965538655e-6)},
        {VM_C(0.84765625), VM_C(0.165283203125), VM_C(-3.11218582283e-6)},
        {VM_C(0.83203125), VM_C(0.183883666992), VM_C(1.61177797509e-6)},
        {VM_C(0.81640625), VM_C(0.202850341797), VM_C(-7.14928228263e-6)},
        {VM_C(0.80078125), VM_C(0.22216796875), VM_C(-5.03408841723e-7)},
        {VM_C(0.78515625), VM_C(0.24186706543), VM_C(5.47099079995e-6)},
        {VM_C(0.7734375), VM_C(0.256912231445), VM_C(-1.81766029073e-6)},
        {VM_C(0.7578125), VM_C(0.277313232422), VM_C(6.05299419476e-6)},
        {VM_C(0.74609375), VM_C(0.292907714844), VM_C(-3.69841086467e-6)},
        {VM_C(0.734375), VM_C(0.308731079102), VM_C(4.40254825662e-6)},
        {VM_C(0.72265625), VM_C(0.324829101563), VM_C(-7.4821614362e-6)},
        {VM_C(0.7109375), VM_C(0.341171264648), VM_C(-5.0724565881e-7)}};
#endif
    return VM_READ(table[row][column]);
}

/* Returns ln x in two words for finite x > 0, with a relative error below 2^-64.2 (float 2^-32). Method: x = 2^k z,
   where z lies between 0.708 and 1.417. Let c be a constant close to z and r = z/c - 1; then
   ln x = k ln 2 + ln c + ln(1 + r). The constant 1/c has few digits, so that the square of r_head, the first half of
   r, is exact. If z is within 0.01 of 1, c is 1. */
VM_API vm_two vmi_log(vm_real x)
{
#if VM_MANT_DIG > 24
    const vmi_bits least_z = UINT64_C(0x3fe6aaaaaaaaaaab), half_tail = UINT64_C(0x40000000);
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vmi_bits least_z = UINT32_C(0x3f355556), half_tail = UINT32_C(0x4000);
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const int subnormal = x < VM_MIN;
    const vm_real normal = subnormal ? x * (4 / VM_EPSILON) : x;
    const vmi_bits one = (vmi_bits)1 << VMI_STORED_DIG;
    const vmi_bits above = vmi_to_bits(normal) - least_z;
    const int k = (int)((above + (VMI_BIAS + 1) * one) >> VMI_STORED_DIG) - (VMI_BIAS + 1);
    const vm_real k_real = (vm_real)(k - (subnormal ? VMI_STORED_DIG + 2 : 0));
    const vmi_bits z_bits = (above & (one - 1)) + least_z;
    const vm_real z = vmi_from_bits(z_bits), z_head = vmi_from_bits((z_bits + half_tail) & ~(2 * half_tail - 1));
    const int row = (int)(44 * z - VM_C(30.5));
    const vm_real by_c = vmi_log_constant(row, 0);
    const vm_real r_head = z_head * by_c - 1, r_tail = (z - z_head) * by_c; /* no rounding error */
    const vm_two r = vmi_fast_two_sum(r_head, r_tail);                      /* |r| < 0.0162 */
    const vm_two sum = vmi_fast_two_sum(k_real * ln2_hi + vmi_log_constant(row, 1), r.hi);
    const vm_two high = vmi_fast_two_sum(sum.hi, -(r_head * r_head) / 2);
    const vm_real rr = r.hi * r.hi;
#if VM_MANT_DIG > 24
    const vm_real L01 = VM_C(0.33333333333333331483) - r.hi * VM_C(0.25);
    const vm_real L23 = VM_C(0.20000000000035858538) - r.hi * VM_C(0.1666666666669953667);
    const vm_real L45 = VM_C(0.1428571357080885007) - r.hi * VM_C(0.12499999344666766488);
    const vm_real L67 = VM_C(0.11115671970945563418) - r.hi * VM_C(0.10004180804025793183);
    const vm_real L = L01 + rr * (L23 + rr * (L45 + rr * L67)); /* ln(1 + r) = r - r^2/2 + r^3 L(r) */
#else
    const vm_real L01 = VM_C(0.333333343267) - r.hi * VM_C(0.25);
    const vm_real L = L01 + rr * (VM_C(0.20003709197) - r.hi * VM_C(0.166699126363));
#endif
    const vm_real low = sum.lo + high.lo + (k_real * ln2_lo + vmi_log_constant(row, 2)) +
                        (r.lo - r_tail * (r.hi + r_head) / 2);
    return vmi_fast_two_sum(high.hi, low + r.hi * rr * L);
}

/* Computes k, p, p_lo with e^(x + x_lo) = 2^k (1 + p + p_lo) and |p| < 0.42, and returns p. |x| must be at most 1500
   (float 200), and |x_lo| at most an ulp of x. 1 + p + p_lo has a relative error below 2^-57 (float 2^-28.3). For
   |x| < 0.34, k is 0, and p alone is within 0.6 ulp of e^x - 1. Method: x = k ln 2 + r and e^r = 1 + r + r^2/2 +
   r^3 E(r) with a polynomial E. The square of the first half of r's digits is computed exactly. */
VM_INLINE vm_real vmi_exp_core(vm_real x, vm_real x_lo, int *k, vm_real *p_lo)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360);
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const vm_real t = x * one_over_ln2;
    const int n = (int)(t + VM_COPYSIGN(VM_C(0.5), t));
    const vm_two r = vmi_fast_two_sum(x - (vm_real)n * ln2_hi, x_lo - (vm_real)n * ln2_lo);
    const vm_real split = vmi_rounded(VM_SPLIT * r.hi + 0), excess = vmi_rounded(split - r.hi);
    const vm_real head = split - excess, tail = r.hi - head;
    const vm_two p = vmi_fast_two_sum(r.hi, head * head / 2);
    const vm_real rr = r.hi * r.hi;
#if VM_MANT_DIG > 24
    const vm_real E01 = VM_C(0.16666666666666668517) + r.hi * VM_C(0.041666666666666664354);
    const vm_real E23 = VM_C(0.0083333333333300649987) + r.hi * VM_C(0.0013888888888886554047);
    const vm_real E45 = VM_C(1.9841269863040544982e-4) + r.hi * VM_C(2.4801587317135163907e-5);
    const vm_real E67 = VM_C(2.75572684803100238e-6) + r.hi * VM_C(2.7557282984055877379e-7);
    const vm_real E89 = VM_C(2.510037583256123403e-8) + r.hi * VM_C(2.091122972975856191e-9);
    const vm_real E = (E01 + rr * E23) + rr * rr * (E45 + rr * (E67 + rr * E89));
#else
    const vm_real E01 = VM_C(0.166666671634) + r.hi * VM_C(0.0416666679084);
    const vm_real E23 = VM_C(0.00833331048489) + r.hi * VM_C(0.00138888659421);
    const vm_real E45 = VM_C(1.98909809114e-4) + r.hi * VM_C(2.48512878898e-5);
    const vm_real E = E01 + rr * (E23 + rr * E45);
#endif
    const vm_real low = p.lo + tail * (r.hi + head) / 2 + (r.lo + r.lo * p.hi);
    const vm_two sum = vmi_fast_two_sum(p.hi, low + r.hi * rr * E);
    *k = n;
    *p_lo = sum.lo;
    return sum.hi;
}

/* Returns e^(x + x_lo) within 0.545 ulp, also where the result is subnormal. x may be any number; |x_lo| is at most an
   ulp of x. */
VM_API vm_real vmi_exp(vm_real x, vm_real x_lo)
{
    const vm_real largest = VM_C(0.6931471805599453094) * (VMI_BIAS + 2);
    const vm_real least = VM_C(-0.6931471805599453094) * (VMI_BIAS + VM_MANT_DIG + 2);
    const vm_real inside = vmi_smaller(vmi_larger(x, least), largest); /* a NaN becomes `least` */
    vm_real p_lo, p;
    vm_two y;
    int k;
    if (x != inside) x_lo = 0;
    p = vmi_exp_core(inside, x_lo, &k, &p_lo);
    y = vmi_fast_two_sum(1, p);
    if (x != x) return x;
    return vmi_ldexp_two(y.hi, y.lo + p_lo, k);
}

/* Returns the power x^y for x > 0, within 0.9 ulp if x.lo is 0 or |ln x| > 2^14 eps. For an x closer to 1 the last
   digits of the low word of x are not used. The error then grows in proportion to eps/|ln x|; it is 2.7 ulp at
   |ln x| = 130 eps. */
VM_API vm_real vmi_pow_two(vm_two x, vm_two y)
{
    const vm_real t = x.lo / x.hi;
    vm_two l = vmi_log(x.hi), p;
    l = vmi_fast_two_sum(l.hi, l.lo + (t - t * t / 2));
    p = vmi_two_product(l.hi, y.hi);
    p = vmi_fast_two_sum(p.hi, p.lo + (l.hi * y.lo + l.lo * y.hi));
    return vmi_exp(p.hi, p.lo);
}

/* Returns the angle atan(y/x) for x >= 0 and y >= 0 that are not both 0. Method: if the angle is above pi/4 (steep), it
   is replaced by pi/2 minus the angle; if the new angle is above pi/8 (middle), pi/4 is subtracted from it. The
   remaining angle lies between -pi/8 and pi/8. It is z + z^3 A, where z is its tangent and A a polynomial in z^2. */
VM_API vm_real vmi_arctan(vm_real y, vm_real x)
{
    const vmi_three half_pi = vmi_half_pi();
    const int steep = y > x;
    const vm_real low = vmi_smaller(x, y), high = vmi_larger(y, x);
    const int middle = low > VM_C(0.4142135623730950488) * high;
    const vm_real half = high > VM_MAX / 2 ? VM_C(0.5) : VM_C(1.0); /* keeps the sum of low and high from overflowing */
    const vm_real z = middle ? half * (low - high) / (half * low + half * high) : low / high, t = z * z, tt = t * t;
    vm_real angle;
#if VM_MANT_DIG > 24
    const vm_real A01 = VM_C(-0.333333333333301951) + t * VM_C(0.199999999990984639);
    const vm_real A23 = VM_C(-0.142857141959989442) + t * VM_C(0.111111066814559886);
    const vm_real A45 = VM_C(-0.090907830050303437) + t * VM_C(0.0769007587545607746);
    const vm_real A67 = VM_C(-0.0664118057808822659) + t * VM_C(0.0569281822630746878);
    const vm_real A89 = VM_C(-0.0435981713871582341) + t * VM_C(0.0212677217547787116);
    const vm_real A = (A01 + tt * A23) + tt * tt * (A45 + tt * (A67 + tt * A89));
#else
    const vm_real A01 = VM_C(-0.3333331645) + t * VM_C(0.1999848485);
    const vm_real A = A01 + tt * (VM_C(-0.1424376816) + t * (VM_C(0.1059537232) + t * VM_C(-0.06081775203)));
#endif
    angle = z + z * (t * A);
    if (middle) angle = half_pi.hi / 2 + (angle + half_pi.mid / 2);
    if (steep) angle = (half_pi.hi - angle) + half_pi.mid;
    return angle;
}

/* Computes the sine and the cosine of the angle z in two words, for |z| <= 0.79, a limit slightly above pi/4. |z.lo|
   must be at most an ulp of z.hi. The first word of the sine is within 0.94 ulp, that of the cosine within 0.95 ulp.
   Both words together were within 0.34 ulp at 4 million random angles. */
VM_INLINE void vmi_sin_cos_words(vm_two z, vm_two *sine, vm_two *cosine)
{
    const vm_real t = z.hi * z.hi, tt = t * t, w = 1 - t / 2;
#if VM_MANT_DIG > 24
    const vm_real S01 = VM_C(-0.166666666666666269) + t * VM_C(8.33333333332120924e-3);
    const vm_real S23 = VM_C(-1.98412698288076529e-4) + t * VM_C(2.75573133340740356e-6);
    const vm_real S45 = VM_C(-2.5050700566966798e-8) + t * VM_C(1.58933807848550637e-10);
    const vm_real C01 = VM_C(0.041666666666666588) + t * VM_C(-1.38888888888725006e-3);
    const vm_real C23 = VM_C(2.48015872884295392e-5) + t * VM_C(-2.75573140380815829e-7);
    const vm_real C45 = VM_C(2.08756793176115783e-9) + t * VM_C(-1.13573139592429182e-11);
    const vm_real S = S01 + tt * (S23 + tt * S45), C = C01 + tt * (C23 + tt * C45);
#else
    const vm_real S = VM_C(-0.1666666716) + t * VM_C(8.333329111e-3) +
                      tt * (VM_C(-1.983925176e-4) + t * VM_C(2.717518782e-6));
    const vm_real C = VM_C(0.04166664556) + t * (VM_C(-1.388730248e-3) + t * VM_C(2.443077574e-5));
#endif
    *sine = vmi_fast_two_sum(z.hi, z.hi * t * S + z.lo * w);
    *cosine = vmi_fast_two_sum(w, ((1 - w) - t / 2) + (tt * C - z.hi * z.lo));
}

/* Computes the sine and the cosine of the angle z, as vmi_sin_cos_words does, in one word each. */
VM_INLINE void vmi_sin_cos(vm_two z, vm_real *sine, vm_real *cosine)
{
    vm_two s, c;
    vmi_sin_cos_words(z, &s, &c);
    *sine = s.hi;
    *cosine = c.hi;
}

/* Returns the integer nearest to x, for |x| < 2^15, and 0 if x is NaN. */
VM_INLINE int vmi_nearest(vm_real x)
{
    if (x != x) return 0;
    return (int)(x + VM_COPYSIGN(VM_C(0.5), x));
}

/* Returns ln x. The argument and the result are numbers in two words, hi + lo. */
VM_API vm_two vmi_two_log(vm_two x)
{
    const vm_two l = vmi_log(x.hi);
    const vm_real t = x.lo / x.hi;
    return vmi_two_sum(l.hi, l.lo + (t - t * t / 2));
}

/* Turns a point of the unit circle, with the sine s and the cosine c, by `quarter` quarters of a turn, 0 to 3. */
VM_API void vmi_turn_quarters(int quarter, vm_real s, vm_real c, vm_real *sine, vm_real *cosine)
{
    *sine = s;
    *cosine = c;
    if (quarter & 1) {
        *sine = c;
        *cosine = s;
    }
    if (quarter & 2) *sine = -*sine;
    if (quarter == 1 || quarter == 2) *cosine = -*cosine;
}

/* Computes the sine and the cosine of any angle x in radians. The function first subtracts from |x| the nearest
   multiple of pi/2, computed with pi/2 in two words. Both results are NaN if x is infinite or NaN. */
VM_API void vmi_sincos(vm_real x, vm_real *sine, vm_real *cosine)
{
    const vmi_three half_pi = vmi_half_pi();
    int quarter;
    vm_real s, c;
    vmi_sin_cos(vmi_reduce(VM_FABS(x), vmi_two(half_pi.hi, half_pi.mid), &quarter), &s, &c);
    if (!VM_IS_FINITE(x)) s = c = VM_NAN;
    vmi_turn_quarters(quarter, s, c, sine, cosine);
    if (x < 0) *sine = -*sine;
}

/* Returns the angle of the point (x, y) in radians, between -pi and pi, and 0 for x = y = 0. */
VM_API vm_real vmi_atan2(vm_real y, vm_real x)
{
    vm_real angle = 0;
    if (x != 0 || y != 0) angle = vmi_arctan(VM_FABS(y), VM_FABS(x));
    if (x < 0) angle = VM_PI - angle;
    return VM_COPYSIGN(angle, y);
}

#endif
/* base/scalars.h - functions that are accurate where the usual formula loses digits

   The functions compute e^y - 1 and ln(1 + x) accurately for small arguments, quotients that become 0/0 at x = 0, and a
   power that has the values of the C library's pow at 0 and infinity.

       vm_two p = vmi_expm1(vmi_two(VM_C(1e-9), 0)); // e^1e-9 - 1 with all its digits

   Tests: tests/test_lambert.c, tests/test_drum.c, tests/test_laws.c. */
#ifndef VARMASS_BASE_SCALARS_H
#define VARMASS_BASE_SCALARS_H

/* Returns infinity if the condition holds, else 0. */
VM_API vm_real vmi_infinity_if(int condition) { return condition ? VM_INFINITY : 0; }

/* Returns x^y for x >= 0 within 0.9 ulp; NaN if x < 0 or an argument is NaN. At 0 and infinity the result is that of
   the C library's pow. */
VM_API vm_real vmi_pow_checked(vm_real x, vm_real y)
{
    const vm_real beyond = 1 / (VM_EPSILON * VM_EPSILON); /* with such a y the power is 0 or infinite */
    if (x != x || y != y || x < 0) return VM_NAN;
    if (y == 0 || x == 1) return 1;
    if (x == 0 || x > VM_MAX) return vmi_infinity_if((y > 0) == (x > 0));
    y = vmi_clamp(y, -beyond, beyond);
    return vmi_pow_two(vmi_two(x, 0), vmi_two(y, 0));
}

/* Returns e^y - 1 in two words. The error is below 2^-(p+4) (1 + e^y), where p is the number of binary digits of
   vm_real; for small y the error is below 2^-p times the result. Where e^y overflows, the result is infinity. */
VM_API vm_two vmi_expm1(vm_two y)
{
    const vm_real largest = VM_C(0.6931471805599453094) * (VMI_BIAS + 1);
    const vm_real least = VM_C(-0.6931471805599453094) * (2 * VM_MANT_DIG);
    vm_real p_lo, p;
    vm_two sum, power;
    int k;
    if (y.hi > largest) return vmi_two(VM_INFINITY, 0);
    if (y.hi != y.hi) return vmi_two(y.hi, 0);
    if (!(y.hi > least)) return vmi_two(-1, 0);
    p = vmi_exp_core(y.hi, y.lo, &k, &p_lo);
    if (k == 0) return vmi_two(p, p_lo);
    sum = vmi_fast_two_sum(1, p);
    power = vmi_fast_two_sum(sum.hi, sum.lo + p_lo);
    power = vmi_two(vmi_ldexp(power.hi, k), vmi_ldexp(power.lo, k));
    sum = vmi_two_sum(power.hi, -1);
    if (!VM_IS_FINITE(power.hi)) return vmi_two(power.hi, 0);
    return vmi_fast_two_sum(sum.hi, sum.lo + power.lo);
}

/* Returns ln(1 + x) in two words for -1 < x < 1e299 (float 1e34); a larger x may give NaN. The relative error is below
   2^-(p+7), where p is the number of binary digits of vm_real. Method: 1 + x = y (1 + t), where y is one word and t is
   below an ulp of 1. */
VM_API vm_two vmi_log1p(vm_two x)
{
    const vm_two sum = vmi_two_sum(1, x.hi), low = vmi_two_sum(sum.lo, x.lo);
    const vm_two y = vmi_two_sum(sum.hi, low.hi);
    const vm_two t = vmi_two_over(vmi_two_sum(y.lo, low.lo), vmi_two(y.hi, 0));
    return vmi_two_plus(vmi_log(y.hi), vmi_two(t.hi, t.lo - t.hi * t.hi / 2));
}

/* Returns (e^x - 1)/x, which is 1 at x = 0, and infinity where e^x overflows. */
VM_API vm_real vmi_exp_ratio(vm_real x)
{
    if (x > VM_MAX) return x;
    if (x == 0) return 1;
    return vmi_expm1(vmi_two(x, 0)).hi / x;
}

/* Returns ln(1 + x)/x, which is 1 at x = 0, and NaN for x <= -1 and infinite x. */
VM_API vm_real vmi_log_ratio(vm_real x)
{
    if (!(x > -1) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return 1;
    return vmi_two_log(vmi_two_sum(1, x)).hi / x;
}

/* Returns (x - y)/x^2, where y must be ln(1 + x). For |x| >= 1/4 the result has two words; its error comes from the
   errors of x and y, which the subtraction amplifies. For a smaller |x| the result has one word and is computed by the
   series of ln((1 + u)/(1 - u)) with u = x/(2 + x), where |u| <= 1/7. */
VM_API vm_two vmi_log1p_rest(vm_two x, vm_two y)
{
#if VM_MANT_DIG > 24
    enum { degree = 9 };
#else
    enum { degree = 4 };
#endif
    const vm_real u = x.hi / (2 + x.hi);
    vm_real P = 0;
    int n;
    if (!(VM_FABS(x.hi) < VM_C(0.25))) return vmi_two_over(vmi_two_over(vmi_two_plus(x, vmi_minus(y)), x), x);
    for (n = degree; n >= 0; n--) P = P * (u * u) + 1 / (vm_real)(2 * n + 3);
    return vmi_two((1 - u) / 2 * (1 - u * (1 - u) * P), 0);
}

#endif
/* ateb/phase.h - the phase s for given values of sa and ca

   As atan2 computes an angle from its sine and cosine, ateb_phase computes the phase s from sa and ca, for example
   the phase of an oscillator from its position and velocity.

       vm_real sa, ca, s;
       ateb_saca(VM_C(0.7), VM_C(1.5), &sa, &ca);
       s = ateb_phase(sa, ca, VM_C(1.5)); // 0.7

   The symbols are those of ateb/inversion.h. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_PHASE_H
#define VARMASS_ATEB_PHASE_H

/* Returns T with 1 + q T = 2F1(1, 2q; 1 + q; p), for p < 0.251. */
VM_API vm_real vmi_ateb_T(vm_real q, vm_real p)
{
    vm_real P, Q;
    vmi_ateb_p_fraction(q, p, &P, &Q);
    return 2 * p * Q / ((1 + q) * P - 2 * q * p * Q);
}

/* Returns r, the distance between s and the zero of sa, for w = sa^2 < 0.302. The argument h is ln(w/x) < 0, and sum is
   1 + e^h. Since x is 1 - w, w = e^h/(1 + e^h). */
VM_API vm_real vmi_ateb_phase_near_sa_zero(vm_two h, vm_real sum, vm_real q)
{
    const vm_real v = vmi_exp(h.hi / 2, h.lo / 2) / VM_SQRT(sum), w = v * v, b = q + VM_C(0.5);
    const vm_real one_minus_u = q * vmi_ateb_power_rest(-w / (2 - w), q);
    return v + v * (w * b * vmi_ateb_w_fraction(q, w) * (1 - one_minus_u) - one_minus_u);
}

/* Returns r, the distance between s and the zero of sa, for w = sa^2 >= 0.302. The arguments are h = ln(w/x) with
   x = 1 - w, e = e^-|h| and sum = 1 + e. The function computes u = ca = x^q by means of ln x = -ln(1 + e^h). Where u is
   well below 1, r is a quarter of the period minus d = u (n + T)/2. Where u is near 1, the function computes 1 - u
   without loss of digits, and r = (n (1 - u) + g - u T)/2. n = alpha + 1 and g = Pi_alpha - n are fields of *c, T is
   the result of vmi_ateb_T. */
VM_API vm_real vmi_ateb_phase_near_ca_zero(vm_two h, vm_real e, vm_real sum, const vmi_ateb *c)
{
    const vm_real large_ln = VM_C(0.69) * VMI_BIAS, n = c->n.hi, smaller = e / sum, larger = 1 / sum;
    vm_real w = smaller, x = larger, one_minus_u, low, T;
    vm_two minus_ln_u = vmi_log(sum);
    int k;
    if (h.hi > 0) {
        w = larger;
        x = smaller;
        minus_ln_u = vmi_two_plus(minus_ln_u, h);
    }
    T = vmi_ateb_T(c->q.hi, x / (2 + 2 * VM_SQRT(w)));
    minus_ln_u.lo += (1 - sum + e) / sum; /* the rounding error of 1 + e */
    minus_ln_u = vmi_two_times(minus_ln_u, c->q);
    if (!(minus_ln_u.hi <= large_ln)) return c->quarter.hi; /* ca is 0, or the logarithm of |ca|^(alpha+1) overflows */
    one_minus_u = -vmi_exp_core(-minus_ln_u.hi, -minus_ln_u.lo, &k, &low);
    if (k != 0) return c->quarter.hi - vmi_ldexp(1 - one_minus_u, k) * (n + T) / 2;
    return (n * one_minus_u + (c->g.hi - (1 - one_minus_u) * T)) / 2;
}

/* Returns r, the distance between s and the zero of sa, in the first quarter. The argument h is ln(w/(1 - w)), where
   w = sa^2. */
VM_API vm_real vmi_ateb_phase_r(vm_two h, const vmi_ateb *c)
{
    const vm_real change_over = VM_C(-0.84); /* ln(w/(1 - w)) for w = 0.302; vmi_ateb_w_fraction allows no larger w */
    vm_two minus_size = h;
    vm_real e;
    if (!(h.hi < 0)) minus_size = vmi_minus(h);
    e = vmi_exp(minus_size.hi, minus_size.lo);
    if (h.hi < change_over) return vmi_ateb_phase_near_sa_zero(h, 1 + e, c->q.hi);
    return vmi_ateb_phase_near_ca_zero(h, e, 1 + e, c);
}

/* Returns 1 if ateb_phase has a result for this alpha, else 0. */
VM_API int vmi_ateb_has_phase(vm_real alpha) { return alpha >= 0 && alpha <= VM_C(1e30); }

/* The phase s of given values of sa and ca, with -Pi_alpha <= s <= Pi_alpha. alpha lies between 0 and 1e30. The given
   values need not satisfy sa^2 + |ca|^(alpha+1) = 1: for every lambda > 0 the pair sa lambda^((alpha+1)/2) and ca
   lambda has the same phase as sa and ca. Therefore the phase of the oscillator x'' = -omega^2 x|x|^(alpha-1) is found
   with sa = -x' sqrt((alpha+1)/2)/omega and ca = x. Returns 0 for sa = 0 <= ca. If sa and ca come from ateb_saca(s,
   ...) with |s| <= Pi_alpha, the result is s with an error of at most 8 ulp plus the change of s that errors of 6 ulp
   in sa and in ca make. Returns NaN for alpha < 0, alpha > 1e30, NaN and infinite arguments. */
VM_API vm_real ateb_phase(vm_real sa, vm_real ca, vm_real alpha)
{
    vm_real r;
    vmi_ateb c;
    if (!vmi_ateb_has_phase(alpha) || !VM_IS_FINITE(sa) || !VM_IS_FINITE(ca)) return VM_NAN;
    vmi_ateb_constants(&c, alpha);
    if (sa == 0) r = 0;
    else if (ca == 0) r = c.quarter.hi;
    else {
        const vm_two ln_w = vmi_two_scaled(vmi_log(VM_FABS(sa)), 2);
        const vm_two ln_x = vmi_two_times(vmi_log(VM_FABS(ca)), c.n);
        r = vmi_ateb_phase_r(vmi_two_plus(ln_w, vmi_minus(ln_x)), &c);
    }
    if (ca < 0) r = (2 * c.quarter.hi - r) + 2 * c.quarter.lo;
    return VM_COPYSIGN(r, sa);
}

/* -- The phase by power series: shorter code, but slower -- */

/* Number of terms that give all digits up to sa^2 = 1/2 and |ca|^(alpha+1) = 1/2 */
enum { VMI_ATEB_PHASE_TERMS = VM_MANT_DIG > 24 ? 54 : 26 };

/* Returns the distance between the phase and a zero of sa, where u = |sa| and y = sa^2 <= 1/2. It is the integral from
   0 to u of (1 - x^2)^(-alpha/(alpha+1)) dx, whose power series has positive terms. The error of the result is below 4
   ulp. */
VM_API vm_real vmi_ateb_from_sa_0(vm_real alpha, vm_real u, vm_real y)
{
    const vm_real power = alpha / (alpha + 1);
    vm_real term = 1, sum = 0;
    int i;
    for (i = 1; i <= VMI_ATEB_PHASE_TERMS; i++) {
        sum += term / (vm_real)(2 * i - 1);
        term *= ((vm_real)(i - 1) + power) / (vm_real)i * y;
    }
    return u * sum;
}

/* Returns the distance between the phase and a zero of ca, where x = |ca| and w = x^(alpha+1) <= 1/2. It is (alpha+1)/2
   times the integral from 0 to x of (1 - z^(alpha+1))^(-1/2) dz. The error of the result is below 4 ulp. */
VM_API vm_real vmi_ateb_from_ca_0(vm_real alpha, vm_real x, vm_real w)
{
    const vm_real n = alpha + 1;
    vm_real term = 1, sum = 0;
    int i;
    for (i = 0; i < VMI_ATEB_PHASE_TERMS; i++) {
        sum += term / (1 + (vm_real)i * n);
        term *= ((vm_real)i + VM_C(0.5)) / (vm_real)(i + 1) * w;
    }
    return n / 2 * x * sum;
}

/* Returns the phase that ateb_phase returns, computed by power series, for sa and ca with sa^2 + |ca|^(alpha+1) = 1 and
   a valid alpha. `quarter` is the quarter period, Pi_alpha/2. */
VM_API vm_real vmi_ateb_phase_by_series(vm_two quarter, vm_real alpha, vm_real sa, vm_real ca)
{
    const vm_real y = sa * sa, x = VM_FABS(ca);
    vm_real r;
    if (y <= VM_C(0.5)) r = vmi_ateb_from_sa_0(alpha, VM_FABS(sa), y);
    else r = (quarter.hi - vmi_ateb_from_ca_0(alpha, x, vmi_pow_checked(x, alpha + 1))) + quarter.lo;
    if (ca < 0) r = (2 * quarter.hi - r) + 2 * quarter.lo;
    return VM_COPYSIGN(r, sa);
}

#endif
/* ateb/integrals.h - integrals of Ateb functions

   This file has functions for two integrals from 0 to s,
     integral of sa^2 = (s - sa ca) (alpha+1)/(alpha+3),
     integral of |ca|^(alpha+1) = s - integral of sa^2.
   Two other integrals are so simple that no function is needed: the integral of sa is (1 - ca) (alpha+1)/2, and that of
   ca |ca|^(alpha-1) is sa.

       vm_real work = ateb_integral_sa2(VM_C(0.7), VM_C(1.5));

   Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_INTEGRALS_H
#define VARMASS_ATEB_INTEGRALS_H

/* The integral of sa(1, alpha, s)^2 from 0 to s.
   No digits cancel for a small s. The domain is that of ateb_saca; the result is NaN outside it. */
VM_API vm_real ateb_integral_sa2(vm_real s, vm_real alpha)
{
    const vm_real q = 1 / (alpha + 1), b = q + VM_C(0.5);
    vm_real sa, ca, w, rest; /* rest = s - sa ca, which for small s is sa ca w b vmi_ateb_w_fraction(q, w) */
    ateb_saca(s, alpha, &sa, &ca);
    w = sa * sa;
    if (VM_FABS(s) < VMI_ATEB_CHANGE_OVER) rest = sa * ca * (w * b * vmi_ateb_w_fraction(q, w));
    else rest = s - sa * ca;
    return rest / (1 + 2 * q);
}

/* The integral of |ca(alpha, 1, s)|^(alpha+1) from 0 to s.
   The domain is that of ateb_saca; the result is NaN outside it. */
VM_API vm_real ateb_integral_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return (2 * s / (alpha + 1) + sa * ca) / (1 + 2 / (alpha + 1));
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
/* base/chebyshev.h - lowers the degree of a polynomial with the help of Chebyshev's polynomials

       vm_real c[3] = {1, 1, VM_C(0.5)};
       vmi_remove_highest(c, 2, 0); // 1 + t + t^2/2 is about c[0] + c[1] t for 0 <= t <= 1

   Source: Lanczos, Applied Analysis (1956). Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_CHEBYSHEV_H
#define VARMASS_BASE_CHEBYSHEV_H

/* Removes the term c_n t^n of the polynomial c_0 + c_1 t + ... + c_n t^n by subtracting a multiple of Chebyshev's
   polynomial of degree n for the interval 0 <= t <= 1. In this interval the values of the polynomial change by at most
   |c_n| 2^(1-2n) if `lowest` is 0. Coefficients with an index below `lowest` stay as they are. */
VM_API void vmi_remove_highest(vm_real *c, int n, int lowest)
{
    vm_real term = c[n];
    int k;
    for (k = n; k > lowest; k--) {
        term *= -(vm_real)(k * (2 * k - 1)) / (vm_real)(2 * (n + k - 1) * (n - k + 1));
        c[k - 1] -= term;
    }
}

#endif
/* ateb/plans.h - sa and ca for many arguments and one alpha

   A plan contains all numbers that depend only on alpha: Pi_alpha/2 and polynomials for two parts of a quarter of the
   period. A call with a plan is faster, most of all for arrays, where the compiler vectorises the loop (docs/cost.md
   has the times). A plan of less accuracy has shorter polynomials and is quicker. A plan is plain data: it may be
   copied, and it may be a constant in flash.

       ateb_plan p;
       vm_real sa, ca;
       if (ateb_plan_init(&p, VM_C(1.5)) == 0) ateb_plan_saca(&p, VM_C(0.7), &sa, &ca);

   Method: let r and d be the distances of s from the nearest zeros of sa and ca, and q = 1/(alpha + 1). A and C are
   polynomials. Up to a certain r, the field change_over,
     sa = r (1 + tau A(tau)) and ca = 1 + tau C(tau), where tau = r^2;
   for larger r, with two other polynomials,
     ca = 2 q d (1 + tau A(tau)) and sa = 1 + tau C(tau), where tau is X = (2 q d)^(alpha+1) up to a factor.
   The polynomials are Taylor series that follow from the differential equations (275). The series are economised: their
   last terms are removed by Chebyshev polynomials. For alpha = 0, 1/2, 1, ..., 7, tau is d d^alpha and is computed by
   products and a square root; for any other alpha, tau is X and is computed by an exponential. Source: Lanczos, Applied
   Analysis (1956). Tests: tests/test_ateb.c, tests/test_plans.sh. Example: examples/print_plan.c. */
#ifndef VARMASS_ATEB_PLANS_H
#define VARMASS_ATEB_PLANS_H

/* The largest number of terms of a plan's polynomials */
#if VM_MANT_DIG > 24
#define ATEB_PLAN_LENGTH 14
#else
#define ATEB_PLAN_LENGTH 8
#endif

/* The polynomials of one part of a quarter. `odd` contains A, for the function that has its zero in this part. `even`
   contains C, for the other function. The comment at the top of this file defines A and C. The constant terms come
   first; coefficients that are not used are 0. */
typedef struct VM_TAG(vmi_ateb_part) {
    vm_real odd[ATEB_PLAN_LENGTH], even[ATEB_PLAN_LENGTH];
} vmi_ateb_part;

/* The numbers from which sa and ca are computed for one alpha. ateb_plan_init writes them. All fields are pure
   numbers. */
typedef struct VM_TAG(ateb_plan) {
    vm_two quarter;           /* Pi_alpha/2 */
#if VM_MANT_DIG > 24
    vm_real quarter_low; /* Pi_alpha/2 minus its two words in `quarter`; a float plan lacks this field */
#endif
    vm_real quarter_parts[3]; /* three numbers with the sum `quarter`; the first two have at most half of the digits */
    vm_real per_quarter;      /* 2/Pi_alpha */
    vm_real longest;          /* for |s| < longest, the number of quarters times quarter_parts[0] or [1] is exact */
    vm_real change_over;      /* part[0] is used up to this distance r from a zero of sa */
    vm_real n, g;             /* alpha + 1 and Pi_alpha - (alpha + 1) */
    vm_two twice_q;           /* 2/(alpha + 1) */
    int length;               /* number of terms of the polynomials, an even number */
    int twice_alpha;          /* 2 alpha where tau is computed by products, -1 where it is an exponential */
    vmi_ateb_part part[2];    /* polynomials for r up to the change-over, and for larger r */
} ateb_plan;

/* Returns d^(1 + alpha) from d + d_lo, where alpha = twice_alpha/2 and twice_alpha = 0 ... 14. Each bit of twice_alpha
   stands for a factor: 1 for sqrt(d), 2 for d, 4 for d^2, and 8 for d^4. */
VM_INLINE vm_real vmi_ateb_product(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    const vm_real d2 = d * d;
    vm_real low = 1, high = 1, power;
    if (p->twice_alpha & 1) low = VM_SQRT(d);
    if (p->twice_alpha & 2) low *= d;
    if (p->twice_alpha & 4) high = d2;
    if (p->twice_alpha & 8) high *= d2 * d2;
    power = low * high;
    return power * d + power * (p->n * d_lo);
}

/* Returns 2 q d = 2 d/(alpha + 1) in two words, from d + d_lo. */
VM_INLINE vm_two vmi_ateb_twice_q_d(const ateb_plan *p, vm_real d, vm_real d_lo)
{
    return vmi_two(p->twice_q.hi * d, p->twice_q.lo * d + p->twice_q.hi * d_lo);
}

/* Returns X = (2 q d)^(alpha+1), where q = 1/(alpha+1). r and d, each in two words, are the distances of s from the
   zeros of sa and ca; 2 q d is computed as in vmi_ateb_base_of and is written to *y. Where X would be subnormal, the
   result is about the smallest normal number instead. */
VM_INLINE vm_real vmi_ateb_exponential(const ateb_plan *p, vm_two r, vm_two d, vm_two *y)
{
    const vm_real z = (2 * r.hi - p->g) + 2 * r.lo;
    const vmi_ateb_base base = vmi_ateb_base_of(p->twice_q, r.hi, z, d.hi, d.lo);
    vm_real whole, rest;
    vmi_ateb_log2_of_power(p->n, base.k, base.t, &whole, &rest);
    *y = base.y;
    if (!(whole + rest > VMI_LEAST_LOG2)) return vmi_ateb_exp2(VMI_LEAST_LOG2, 0);
    return vmi_ateb_exp2(whole, rest);
}

/* Returns the polynomial c[0] + c[1] x + c[2] x^2 + c[3] x^3, where xx = x^2. */
VM_INLINE vm_real vmi_ateb_four_terms(const vm_real *c, vm_real x, vm_real xx)
{
    return (c[0] + x * c[1]) + xx * (c[2] + x * c[3]);
}

/* Returns the terms c[1] x + c[2] x^2 + ... of a polynomial, computed with at least `length` - 1 terms. The
   coefficients beyond `length` are 0. The terms are grouped by four, so that the processor can compute the groups at
   the same time. The constant c[0], which is larger than all terms, is left to the caller: it is added last, because
   a sum that contains it has a rounding error as large as half an ulp of the result. */
VM_INLINE vm_real vmi_ateb_part_terms(const vm_real *c, int length, vm_real x)
{
    const vm_real xx = x * x, x4 = xx * xx;
    vm_real more;
    if (length <= 5) return x * vmi_ateb_four_terms(c + 1, x, xx);
    more = (c[5] + x * c[6]) + xx * c[7];
#if ATEB_PLAN_LENGTH > 8
    if (length > 8) more = vmi_ateb_four_terms(c + 5, x, xx) + x4 * (vmi_ateb_four_terms(c + 9, x, xx) + x4 * c[13]);
#endif
    return x * (vmi_ateb_four_terms(c + 1, x, xx) + x4 * more);
}

/* Computes *odd = base (1 + tau A(tau)) and *even = 1 + tau C(tau), where A and C are the polynomials part->odd and
   part->even, and base is r or 2 q d. The two largest terms of *even are 1 and tau c, where c is the constant of C.
   What rounding takes from their sum is added again. */
VM_INLINE void vmi_ateb_part_at(const vmi_ateb_part *part, int length, vm_two base, vm_real tau, vm_real *odd,
                                vm_real *even)
{
    const vm_real first = tau * part->even[0], sum = vmi_rounded(1 + first), lost = (1 - sum) + first;
    const vm_real A = part->odd[0] + vmi_ateb_part_terms(part->odd, length, tau);
    *odd = base.hi + (base.lo + (base.hi * tau) * A);
    *even = sum + (lost + tau * vmi_ateb_part_terms(part->even, length, tau));
}

/* Returns |s| minus the nearest multiple of Pi_alpha/2 in two words, for |s| < p->longest, which is 2^26 quarters
   (float 2^12). *quarter becomes a number whose last two bits are the number of quarters modulo 4. The first difference
   is exact; the low word is what rounding takes from the other two. */
VM_INLINE vm_two vmi_ateb_plan_reduce(const ateb_plan *p, vm_real s, vmi_bits *quarter)
{
    const vm_real x = VM_FABS(s), to_integer = VM_C(1.5) / VM_EPSILON;
    const vm_real shifted = vmi_rounded(x * p->per_quarter + to_integer), count = vmi_rounded(shifted - to_integer);
    const vm_real second = count * p->quarter_parts[1], third = count * p->quarter_parts[2];
    const vm_real after_first = x - count * p->quarter_parts[0];
    const vm_real after_second = vmi_rounded(after_first - second), rest = vmi_rounded(after_second - third);
    *quarter = vmi_to_bits(shifted);
    return vmi_two(rest, ((after_first - after_second) - second) + ((after_second - rest) - third));
}

/* `rest` is s minus the nearest multiple of Pi_alpha/2, computed with Pi_alpha/2 in two words. Returns 1 if this `rest`
   is so small that it must be computed again with a third word of Pi_alpha/2, else 0. A plan in float has no third
   word: then the result is always 0. */
VM_INLINE int vmi_ateb_plan_is_close(vm_real rest, vm_real s)
{
    return VM_MANT_DIG > 24 && VM_FABS(rest) < VMI_ATEB_FINE_REACH * VM_FABS(s);
}

/* Returns x minus the nearest multiple of Pi_alpha/2, for an x > 0 that is close to a multiple (see
   vmi_ateb_plan_is_close). `rest` is this difference, computed with two words of Pi_alpha/2. In double the result is
   computed with three words; in float it is `rest`. */
VM_API vm_real vmi_ateb_plan_reduce_finely(const ateb_plan *p, vm_real x, vm_real rest)
{
#if VM_MANT_DIG > 24
    const vmi_three quarter = {p->quarter.hi, p->quarter.lo, p->quarter_low};
    return vmi_ateb_rest_in_three_words(x, quarter, rest);
#else
    (void)p;
    (void)x;
    return rest;
#endif
}

/* Returns |x|, without a branch. */
VM_INLINE vm_two vmi_ateb_absolute(vm_two x) { return vmi_two(VM_FABS(x.hi), VM_COPYSIGN(1, x.hi) * x.lo); }

/* Returns the distance of s from the zero at the other end of its quarter, in two words: Pi_alpha/2 minus the distance
   near_zero from the nearest zero. */
VM_INLINE vm_two vmi_ateb_plan_far_zero(const ateb_plan *p, vm_two near_zero)
{
    const vm_real far_zero = vmi_rounded((p->quarter.hi - near_zero.hi) + p->quarter.lo);
    return vmi_two(far_zero, ((p->quarter.hi - far_zero) - near_zero.hi) + (p->quarter.lo - near_zero.lo));
}

/* sa and ca of the argument s for the plan's alpha. s may be any number. For alpha up to 1e6 and |s| <= 100 Pi_alpha,
   the error of a plan of full accuracy is at most 2 ulp. In float, next to a zero of sa or ca, it is at most 2 ulp plus
   the change that an error of 2^-42 |s| in s makes. Any other plan has the accuracy that was given to
   ateb_plan_init_to. The results are NaN for infinite and NaN s. docs/cost.md has the time of a call. */
VM_API void ateb_plan_saca(const ateb_plan *p, vm_real s, vm_real *sa, vm_real *ca)
{
    vm_two rest, near_zero, far_zero, r, d; /* r and d are the distances of s from the zeros of sa and ca */
    vm_real v, u;
    vmi_bits quarter;
    if (VM_FABS(s) < p->longest) rest = vmi_ateb_plan_reduce(p, s, &quarter);
    else if (VM_IS_FINITE(s)) {
        int count;
        rest = vmi_reduce(VM_FABS(s), p->quarter, &count);
        quarter = (vmi_bits)count;
    } else {
        *sa = VM_NAN;
        *ca = VM_NAN;
        return;
    }
    if (vmi_ateb_plan_is_close(rest.hi, s))
        rest = vmi_two(vmi_ateb_plan_reduce_finely(p, VM_FABS(s), rest.hi), 0);
    near_zero = vmi_ateb_absolute(rest);
    far_zero = vmi_ateb_plan_far_zero(p, near_zero);
    r = far_zero;
    d = near_zero;
    if (!(quarter & 1)) {
        r = near_zero;
        d = far_zero;
    }
    if (r.hi <= p->change_over) vmi_ateb_part_at(p->part, p->length, r, r.hi * r.hi, &v, &u);
    else {
        vm_two base;
        vm_real tau;
        if (p->twice_alpha >= 0) {
            base = vmi_ateb_twice_q_d(p, d.hi, d.lo);
            tau = vmi_ateb_product(p, d.hi, d.lo);
        } else tau = vmi_ateb_exponential(p, r, d, &base);
        vmi_ateb_part_at(p->part + 1, p->length, base, tau, &u, &v);
    }
    vmi_ateb_signs(s, rest.hi, quarter, &v, &u);
    *sa = v;
    *ca = u;
}

/* Arrays are computed in blocks of VMI_ATEB_BLOCK arguments, by loops without branches, which compilers turn into
   vector instructions. VMI_ATEB_WIDE is 1 on processors with wide vector registers, else 0. With narrow vector
   registers such a loop takes longer than single calls. */
enum { VMI_ATEB_BLOCK = 32 };
#if defined(__AVX2__) || defined(__ARM_NEON) || defined(__ARM_FEATURE_SVE)
#define VMI_ATEB_WIDE 1
#else
#define VMI_ATEB_WIDE 0
#endif

/* Intermediate results for the arguments s of a block. `quarter` has the bits of the number of quarters, and `rest` is
   |s| minus the nearest multiple of the quarter period. r and d are the distances of s from the zeros of sa and ca,
   with the low words r_lo and d_lo. base, base_lo and tau are arguments of vmi_ateb_part_at. */
typedef struct VM_TAG(vmi_ateb_block) {
    vmi_bits quarter[VMI_ATEB_BLOCK];
    vm_real rest[VMI_ATEB_BLOCK];
    vm_real r[VMI_ATEB_BLOCK], r_lo[VMI_ATEB_BLOCK], d[VMI_ATEB_BLOCK], d_lo[VMI_ATEB_BLOCK];
    vm_real base[VMI_ATEB_BLOCK], base_lo[VMI_ATEB_BLOCK], tau[VMI_ATEB_BLOCK];
} vmi_ateb_block;

/* Fills the fields up to d_lo from the arguments, each with |s| < p->longest. */
VM_INLINE void vmi_ateb_block_places(const ateb_plan *p, const vm_real *s, vmi_ateb_block *at)
{
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        vmi_bits quarter;
        const vm_two rest = vmi_ateb_plan_reduce(p, s[i], &quarter), near_zero = vmi_ateb_absolute(rest);
        const vm_two far_zero = vmi_ateb_plan_far_zero(p, near_zero);
        const vmi_bits odd = 0 - (quarter & 1);
        at->quarter[i] = quarter;
        at->rest[i] = rest.hi;
        at->r[i] = vmi_select(odd, far_zero.hi, near_zero.hi);
        at->r_lo[i] = vmi_select(odd, far_zero.lo, near_zero.lo);
        at->d[i] = vmi_select(odd, near_zero.hi, far_zero.hi);
        at->d_lo[i] = vmi_select(odd, near_zero.lo, far_zero.lo);
    }
}

/* Sets base to 2 q d and tau to d^(1 + alpha), for alpha = 0, 1/2, ..., 7 (vmi_ateb_product). The factors of
   vmi_ateb_product that this alpha does not need are replaced by 1. */
VM_INLINE void vmi_ateb_block_products(const ateb_plan *p, vmi_ateb_block *at)
{
    const vm_real one = (vm_real)(p->twice_alpha >> 1 & 1), two = (vm_real)(p->twice_alpha >> 2 & 1);
    const vm_real four = (vm_real)(p->twice_alpha >> 3 & 1);
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) at->tau[i] = 1;
    if (p->twice_alpha & 1)
        for (i = 0; i < VMI_ATEB_BLOCK; i++) at->tau[i] = VM_SQRT(at->d[i]);
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        const vm_real d = at->d[i], d2 = d * d, low = at->tau[i] * (one * d + (1 - one));
        const vm_real power = low * ((two * d2 + (1 - two)) * (four * (d2 * d2) + (1 - four)));
        at->tau[i] = power * d + power * (p->n * at->d_lo[i]);
        at->base[i] = p->twice_q.hi * d;
        at->base_lo[i] = p->twice_q.lo * d + p->twice_q.hi * at->d_lo[i];
    }
}

/* Sets base to 2 q d and tau to X = (2 q d)^(alpha+1), for any other alpha below 1/VM_EPSILON. The steps are those of
   vmi_ateb_exponential; where that function branches, both results are computed and one is selected. */
VM_INLINE void vmi_ateb_block_exponentials(const ateb_plan *p, vmi_ateb_block *at)
{
    const vm_real sqrt_half = VM_C(0.70710678118654752);
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        const vm_real r = at->r[i], d = at->d[i], z = (2 * r - p->g) + 2 * at->r_lo[i];
        const vm_real qz = p->twice_q.hi * (z / 2), by_r = 1 - qz;
        const vm_two by_d = vmi_ateb_twice_q_times(p->twice_q, d, at->d_lo[i]);
        const vmi_bits is_near = vmi_mask_of_sign(r - d) & vmi_mask_of_sign(qz - VM_C(0.29));
        const vm_real scale = VM_C(1.5) - VM_COPYSIGN(VM_C(0.5), by_d.hi - sqrt_half);
        vm_real k, mantissa, numerator, denominator, whole, rest;
        vmi_bits is_normal;
        mantissa = vmi_ateb_mantissa(by_d.hi, &k);
        k = vmi_select(is_near, 0, k);
        numerator = vmi_select(is_near, -qz, (mantissa - 1) + scale * by_d.lo);
        denominator = vmi_select(is_near, 2 - qz, mantissa + 1);
        vmi_ateb_log2_of_power(p->n, k, numerator / denominator, &whole, &rest);
        is_normal = vmi_mask_of_sign(VMI_LEAST_LOG2 - (whole + rest));
        at->tau[i] = vmi_ateb_exp2(vmi_select(is_normal, whole, VMI_LEAST_LOG2), vmi_select(is_normal, rest, 0));
        at->base[i] = vmi_select(is_near, by_r, by_d.hi);
        at->base_lo[i] = vmi_select(is_near, (1 - by_r) - qz, by_d.lo);
    }
}

/* Computes sa and ca of a block whose fields are filled, with polynomials of `length` terms. `part` becomes the
   polynomials of the part of the quarter in which an argument lies. */
VM_INLINE void vmi_ateb_block_sums(const ateb_plan *p, int length, const vmi_ateb_block *at, const vm_real *s,
                                   vm_real *sa, vm_real *ca)
{
    const vmi_ateb_part *near_sa = p->part, *near_ca = p->part + 1; /* the parts with a zero of sa and of ca */
    const vm_real change_over = p->change_over;
    int i;
    for (i = 0; i < VMI_ATEB_BLOCK; i++) {
        const vm_real r = at->r[i];
        const vmi_bits beyond = vmi_mask_of_sign(change_over - r);
        const vm_real tau = vmi_select(beyond, at->tau[i], r * r);
        const vm_real base = vmi_select(beyond, at->base[i], r);
        const vm_real base_lo = vmi_select(beyond, at->base_lo[i], at->r_lo[i]);
        vmi_ateb_part part;
        vm_real odd, even, v, u;
        int j;
        VMI_UNROLL for (j = 0; j < length; j++) {
            part.odd[j] = vmi_select(beyond, near_ca->odd[j], near_sa->odd[j]);
            part.even[j] = vmi_select(beyond, near_ca->even[j], near_sa->even[j]);
        }
        vmi_ateb_part_at(&part, length, vmi_two(base, base_lo), tau, &odd, &even);
        v = vmi_select(beyond, even, odd);
        u = vmi_select(beyond, odd, even);
        vmi_ateb_signs(s[i], at->rest[i], at->quarter[i], &v, &u);
        sa[i] = v;
        ca[i] = u;
    }
}

/* Computes sa and ca of a block of arguments, each with |s| < p->longest. Each call of vmi_ateb_block_sums has a
   constant number of terms, so that compilers can vectorise its loop over the arguments. For the same numbers of terms
   vmi_ateb_part_terms has separate cases. Arguments next to a zero of sa or ca are computed once more, one by one. The
   function copies the plan, so that the compiler knows that writing the results does not change the plan. */
VM_API void vmi_ateb_block_saca(const ateb_plan *plan, const vm_real *s, vm_real *sa, vm_real *ca)
{
    const ateb_plan p = *plan;
    vmi_ateb_block at;
    int i, any_close = 0;
    vmi_ateb_block_places(&p, s, &at);
    if (p.twice_alpha >= 0) vmi_ateb_block_products(&p, &at);
    else vmi_ateb_block_exponentials(&p, &at);
    if (p.length > 8) vmi_ateb_block_sums(&p, ATEB_PLAN_LENGTH, &at, s, sa, ca);
    else if (p.length > 5) vmi_ateb_block_sums(&p, 8, &at, s, sa, ca);
    else vmi_ateb_block_sums(&p, 5, &at, s, sa, ca);
    for (i = 0; i < VMI_ATEB_BLOCK; i++) any_close |= vmi_ateb_plan_is_close(at.rest[i], s[i]);
    for (i = 0; any_close && i < VMI_ATEB_BLOCK; i++)
        if (vmi_ateb_plan_is_close(at.rest[i], s[i])) ateb_plan_saca(plan, s[i], sa + i, ca + i);
}

/* sa and ca of n arguments for the plan's alpha. The arrays s, sa and ca have n elements each. s may be the array sa or
   the array ca; otherwise the three arrays must not overlap. Domain and accuracy are those of ateb_plan_saca. Unless
   the compiler fuses products and sums, the results have the same bits as those of ateb_plan_saca. Arguments are
   computed in blocks of 32. Arguments with |s| >= p->longest, and those that are not finite, are computed one by one.
   Arrays are faster than single calls on processors with wide vector registers (docs/cost.md has the times). */
VM_API void ateb_plan_saca_array(const ateb_plan *p, int n, const vm_real *s, vm_real *sa, vm_real *ca)
{
    const int wide = VMI_ATEB_WIDE && p->quarter.hi < 1 / VM_EPSILON;
    vm_real x[VMI_ATEB_BLOCK], v[VMI_ATEB_BLOCK], u[VMI_ATEB_BLOCK];
    int i, j, count, any_outside;
    for (i = 0; !wide && i < n; i++) ateb_plan_saca(p, s[i], sa + i, ca + i);
    for (i = 0; wide && i < n; i += VMI_ATEB_BLOCK) {
        count = VMI_ATEB_BLOCK;
        if (n - i < VMI_ATEB_BLOCK) count = n - i;
        any_outside = 0;
        for (j = 0; j < VMI_ATEB_BLOCK; j++) x[j] = 0;
        for (j = 0; j < count; j++) {
            const int inside = VM_FABS(s[i + j]) < p->longest;
            x[j] = inside ? s[i + j] : 0;
            any_outside |= !inside;
        }
        vmi_ateb_block_saca(p, x, v, u);
        for (j = 0; any_outside && j < count; j++)
            if (!(VM_FABS(s[i + j]) < p->longest)) ateb_plan_saca(p, s[i + j], v + j, u + j);
        for (j = 0; j < count; j++) {
            sa[i + j] = v[j];
            ca[i + j] = u[j];
        }
    }
}

/* Returns the coefficient w_j of the power series w = b^alpha, where b is a power series with b_0 = 1. The function
   computes it from w_0 ... w_(j-1) and b_1 ... b_j by Euler's recurrence. */
VM_API vm_real vmi_ateb_series_power(vm_real alpha, int j, const vm_real *b, const vm_real *w)
{
    vm_real sum = 0;
    int i;
    for (i = 1; i <= j; i++) sum += (alpha * (vm_real)i - (vm_real)(j - i)) * b[i] * w[j - i];
    return sum / (vm_real)j;
}

/* The number of terms of the Taylor series from which the polynomials are made */
enum { VMI_ATEB_TERMS = VM_MANT_DIG > 24 ? 56 : 26 };

/* Computes Taylor coefficients, term by term from the differential equations (275). For beyond = 0, the array `odd`
   becomes the coefficients of sa/r, and `even` those of ca, in powers of r^2. For beyond = 1, `odd` becomes the
   coefficients of ca/(2 q d), and `even` those of sa, in powers of X = (2 q d)^(alpha+1). r and d are the distances
   from the nearest zeros of sa and ca, and q = 1/(alpha + 1). */
VM_API void vmi_ateb_series(int beyond, vm_real alpha, vm_real q, vm_real *odd, vm_real *even)
{
    const vm_real large = VM_C(1e30); /* a larger alpha counts as this one, since alpha j might overflow */
    vm_real *w = odd; /* series of ca^alpha, for beyond = 1 of (ca/(2 q d))^alpha; overwritten at the end */
    int j;
    if (beyond) w = even;
    if (alpha > large) {
        alpha = large;
        q = 1 / large;
    }
    odd[0] = 1;
    even[0] = 1;
    for (j = 1; j < VMI_ATEB_TERMS; j++) {
        const vm_real i = (vm_real)j;
        if (beyond) {
            odd[j] = -w[j - 1] / (2 * i) * (q / (q + i));
            w[j] = vmi_ateb_series_power(alpha, j, odd, w);
        } else {
            even[j] = -q * (w[j - 1] / (2 * i - 1)) / i;
            w[j] = vmi_ateb_series_power(alpha, j, even, w);
        }
    }
    for (j = VMI_ATEB_TERMS - 1; j > 0; j--) {
        if (beyond) even[j] = -w[j - 1] / (2 * (vm_real)j);
        else odd[j] = w[j] / (2 * (vm_real)j + 1);
    }
}

/* Economises the power series c_1 + c_2 x + c_3 x^2 + ... for 0 <= x <= limit: the function replaces it by a polynomial
   in x/unit with at most ATEB_PLAN_LENGTH terms, and returns the number of terms. `result` becomes the array of these
   coefficients times unit. The error of the polynomial is at most tolerance/limit if ATEB_PLAN_LENGTH terms are enough.
   The largest coefficient is computed as c_1 plus its change, so that it has no rounding errors from multiplying and
   dividing by limit. c is overwritten. */
VM_API int vmi_ateb_economise(vm_real *c, vm_real limit, vm_real unit, vm_real tolerance, vm_real *result)
{
    const int highest = VMI_ATEB_TERMS - 2;
    const vm_real largest = c[1];
    vm_real power = 1, height = vmi_ldexp(1, 1 - 2 * highest);
    int i, k;
    for (i = 0; i <= highest; i++) { /* now c is limit times the series, in powers of x/limit */
        power *= limit;
        c[i] = c[i + 1] * power;
    }
    for (k = highest; k > 0; k--) { /* removing c[k] adds an error |c[k]| height, where height = 2^(1-2k) */
        tolerance -= VM_FABS(c[k]) * height;
        if (tolerance < 0 && k < ATEB_PLAN_LENGTH) break;
        vmi_remove_highest(c, k, 0);
        height *= 4;
    }
    power = 1;
    for (i = 0; i < ATEB_PLAN_LENGTH; i++) {
        power *= unit / limit;
        result[i] = 0;
        if (i <= k) result[i] = c[i] * power;
    }
    result[0] = largest * unit + (c[0] - largest * limit) * (unit / limit);
    return k + 1;
}

/* Fills part 0 or 1 of the plan (the argument `beyond` chooses it) and returns the number of terms of its polynomials
   in tau. In part 0, tau = r^2, where r is the distance from a zero of sa, and unit is 1. In part 1, tau = X/unit,
   where X = (2 d/(alpha + 1))^(alpha+1) and d is the distance from a zero of ca. */
VM_API int vmi_ateb_part_init(vmi_ateb_part *part, int beyond, const ateb_plan *p, vm_real alpha, vm_real unit,
                              vm_real tolerance)
{
    vm_real odd[VMI_ATEB_TERMS], even[VMI_ATEB_TERMS], limit = p->change_over * p->change_over;
    int length, even_length;
    if (beyond) {
        vm_two y;
        limit = vmi_ateb_exponential(p, vmi_two(p->change_over, 0), vmi_two(p->quarter.hi - p->change_over, 0), &y);
    }
    vmi_ateb_series(beyond, alpha, p->twice_q.hi / 2, odd, even);
    length = vmi_ateb_economise(odd, limit, unit, tolerance, part->odd);
    even_length = vmi_ateb_economise(even, limit, unit, tolerance, part->even);
    if (even_length > length) length = even_length;
    return length;
}

/* Sets the fields that reduce s: the quarter period as a sum of parts, and `longest`. For |s| < longest, the products
   of the first two parts and the number of quarters are exact. */
VM_API void vmi_ateb_plan_period(ateb_plan *p, const vmi_ateb *c)
{
#if VM_MANT_DIG > 24
    const vmi_three quarter = vmi_ateb_quarter_in_words(c);
    p->quarter = vmi_two(quarter.hi, quarter.mid);
    p->quarter_low = quarter.lo;
#else
    p->quarter = c->quarter;
#endif
    p->quarter_parts[0] = vmi_head(p->quarter.hi);
    p->quarter_parts[1] = vmi_head(p->quarter.hi - p->quarter_parts[0]);
    p->quarter_parts[2] = ((p->quarter.hi - p->quarter_parts[0]) - p->quarter_parts[1]) + p->quarter.lo;
    p->per_quarter = 1 / p->quarter.hi;
    p->longest = p->quarter.hi * (vm_real)((1L << VM_MANT_DIG / 2) - 1);
}

/* Prepares a plan for alpha >= 0 and a given accuracy. `accuracy` is the largest absolute error of sa and ca that is
   allowed, such as 1e-4 or 1e-8; 0 means full accuracy. A plan of less accuracy has shorter polynomials and is quicker.
   Returns 0, or -1 if alpha < 0 or an argument is NaN or infinite; if it returns -1, the plan stays as it was. */
VM_API int ateb_plan_init_to(ateb_plan *p, vm_real alpha, vm_real accuracy)
{
    /* For r beyond the change-over, sa is computed from X = (2 q d)^(alpha+1). A relative rounding error of X causes an
       error of sa that is X/(2 sa) times as large. The factor X/(2 sa) is 0.33 for a change-over at r = 0.92; for a
       change-over at r = 0.73 it would be 0.5, and the error of sa would be 2.3 ulp. For a change-over beyond 0.92 the
       polynomials would have too few terms. */
    const vm_real share = VM_C(0.5), farthest = VM_MANT_DIG > 24 ? VM_C(0.92) : VM_C(0.95);
    vm_real tolerance = VM_EPSILON / 16, unit = 1;
    int length, length_beyond;
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(accuracy)) return -1;
    if (accuracy > VM_EPSILON) tolerance = accuracy / 2;
    vmi_ateb_fine_constants(&c, alpha);
    vmi_ateb_plan_period(p, &c);
    p->change_over = vmi_smaller(share * p->quarter.hi, farthest);
    p->n = c.n.hi;
    p->twice_q = vmi_two(2 * c.q.hi, 2 * c.q.lo);
    p->g = c.g.hi;
    p->twice_alpha = -1;
    if (alpha <= 7 && 2 * alpha == VM_FLOOR(2 * alpha)) {
        p->twice_alpha = (int)(2 * alpha);
        unit = vmi_pow_two(p->twice_q, c.n);
    }
    length = vmi_ateb_part_init(p->part, 0, p, alpha, 1, tolerance);
    length_beyond = vmi_ateb_part_init(p->part + 1, 1, p, alpha, unit, tolerance);
    if (length_beyond > length) length = length_beyond;
    p->length = (length + 1) / 2 * 2;
    return 0;
}

/* Prepares a plan of full accuracy for alpha >= 0.
   Returns 0, or -1 for alpha < 0, NaN and infinite alpha; if it returns -1, the plan stays as it was. */
VM_API int ateb_plan_init(ateb_plan *p, vm_real alpha) { return ateb_plan_init_to(p, alpha, 0); }

#endif
/* ateb/beta.h - beta functions, and mean values of sa and ca

   B(a, b) is the complete beta function, and I_x(a, b) the regularised incomplete beta function, which lies between 0
   and 1. Ateb functions are inverses of incomplete beta functions, and their mean values are quotients of complete beta
   functions (316).

       vm_real p = ateb_beta_inc(VM_C(0.3), VM_C(0.5), 2); // I_0.3(0.5, 2)

   In this file p stands for I_x(a, b), q for 1 - p, and y for 1 - x. A function with the suffix _both takes y too and
   returns q too: if x or p is close to 1, a computed difference 1 - x or 1 - p has lost digits.

   Method: the functions are computed from logarithms in two words, by Stirling's formula, which needs numbers of at
   least 6. Let A = a + i, where i is 6 for a < 6 and 0 for any other a. In the same way let B = b + j and
   S = a + b + k, where j and k are 0 or 6, so that A, B and S are at least 6. Then Stirling's formula gives
     ln(x^a y^b/B(a, b)) = a ln x + b ln y + (a + k - j) ln S/A + (b + k - i) ln S/B
                           + (k - i - j + 1/2) ln(A B/S) + (i + j - k) - ln(2 pi)/2
                           + delta(S) - delta(A) - delta(B) + ln((a)_i (b)_j/(a+b)_k)
   where delta is the remainder of Stirling's formula (vmi_beta_stirling) and (a)_i = a (a + 1) ... (a + i - 1). If this
   sum is not large, it contains no large terms that cancel each other. The products (a)_i, (b)_j and (a+b)_k neither
   overflow nor underflow, since each of them has at most 6 factors. The function vmi_beta_density computes
   x^a y^b/B(a, b) without this sum, in less time and with an error of a few ulp.

   Source of the continued fraction (vmi_beta_fraction): Didonato and Morris, Algorithm 708, ACM TOMS 18 (1992). Tests:
   tests/test_ateb.c. */
#ifndef VARMASS_ATEB_BETA_H
#define VARMASS_ATEB_BETA_H

/* Returns delta(z) = ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2 for z >= 6, from by_z = 1/z. The product z delta(z)
   is computed by a polynomial in 1/z^2, which is equal to z delta(z) at Chebyshev's points. The polynomial has a
   relative error of 2^-60 (float 2^-34) and fewer terms than Stirling's series. */
VM_INLINE vm_real vmi_beta_stirling(vm_real by_z)
{
    const vm_real w = by_z * by_z, ww = w * w;
#if VM_MANT_DIG > 24
    const vm_real c12 = VM_C(-0.0027777777777775510905) + w * VM_C(7.9365079343166191487e-4);
    const vm_real c34 = VM_C(-5.9523801316430247565e-4) + w * VM_C(8.417353128972759356e-4);
    const vm_real c56 = VM_C(-0.0019158553219707499218) + w * VM_C(0.0063022220719276690833);
    const vm_real c78 = VM_C(-0.025300456155614599805) + w * VM_C(0.079449609966698245323);
    const vm_real sum = (c12 + ww * c34) + (ww * ww) * (c56 + ww * c78);
#else
    const vm_real sum = VM_C(-0.00277777376716) + w * (VM_C(7.92921561308e-4) - w * VM_C(5.52149873404e-4));
    (void)ww;
#endif
    return by_z * (VM_C(0.083333333333333333295) + w * sum);
}

/* Returns (z)_i = z (z + 1) ... (z + i - 1), where i is 6 for z < 6 and 0 for any other z. *count becomes i, and *z
   becomes z + i. For i = 6 the product is computed as p (p + 4) (p + 6) with p = z (z + 5). */
VM_API vm_two vmi_beta_rise(vm_two *z, int *count)
{
    vm_two product = {1, 0}, p;
    *count = 0;
    if (!(z->hi < 6)) return product;
    *count = 6;
    p = vmi_two_times(*z, vmi_two_plus(*z, vmi_two(5, 0)));
    product = vmi_two_times(vmi_two_plus(p, vmi_two(4, 0)), vmi_two_plus(p, vmi_two(6, 0)));
    *z = vmi_two_plus(*z, vmi_two(6, 0));
    return vmi_two_times(product, p);
}

/* Returns ln(x^a y^b/B(a, b)), by the formula at the top of this file. */
VM_API vm_two vmi_beta_ln_density(vm_two a, vm_two b, vm_two ln_x, vm_two ln_y)
{
#if VM_MANT_DIG > 24
    const vm_two half_ln_2pi = {VM_C(-0.91893853320467278056), VM_C(3.8782941580672414498e-17)};
#else
    const vm_two half_ln_2pi = {VM_C(-0.9189385175705), VM_C(-1.5634176619983e-8)};
#endif
    vm_two A = a, B = b, S = vmi_two_plus(a, b), rise, rise_a, rise_b, rise_s, ln_SA, ln_SB, sum;
    vm_real delta;
    int i, j, k;
    /* (a)_i (b)_j/(S)_k, where (a)_i (b)_j alone, or the smaller of them divided by (S)_k, may underflow in float */
    rise_a = vmi_beta_rise(&A, &i);
    rise_b = vmi_beta_rise(&B, &j);
    rise_s = vmi_beta_rise(&S, &k);
    if (a.hi < b.hi) rise = vmi_two_times(vmi_two_over(rise_b, rise_s), rise_a);
    else rise = vmi_two_times(vmi_two_over(rise_a, rise_s), rise_b);
    ln_SA = vmi_two_log(vmi_two_over(S, A));
    ln_SB = vmi_two_log(vmi_two_over(S, B));
    sum = vmi_two_scaled(vmi_two_log(vmi_two_times(A, vmi_two_over(B, S))), (vm_real)(k - i - j) + VM_C(0.5));
    sum = vmi_two_plus(sum, vmi_two_plus(half_ln_2pi, vmi_two((vm_real)(i + j - k), 0)));
    sum = vmi_two_plus(sum, vmi_two_log(rise));
    sum = vmi_two_plus(sum, vmi_two_scaled(ln_SA, (vm_real)(k - j)));
    sum = vmi_two_plus(sum, vmi_two_scaled(ln_SB, (vm_real)(k - i)));
    sum = vmi_two_plus(sum, vmi_two_plus(vmi_two_times(vmi_two_plus(ln_x, ln_SA), a),
                                         vmi_two_times(vmi_two_plus(ln_y, ln_SB), b)));
    delta = vmi_beta_stirling(1 / S.hi) - vmi_beta_stirling(1 / A.hi) - vmi_beta_stirling(1 / B.hi);
    return vmi_two_sum(sum.hi, sum.lo + delta);
}

/* Returns ln B(a, b). */
VM_API vm_two vmi_beta_ln(vm_two a, vm_two b)
{
    const vm_two none = {0, 0};
    return vmi_minus(vmi_beta_ln_density(a, b, none, none));
}

/* Returns 1 if a and b lie between 1e-4 and 1e5, else 0. Outside these limits the series and continued fractions would
   need too many terms, and in float the results would have no right digits. */
VM_API int vmi_beta_is_in_domain(vm_real a, vm_real b)
{
    return a >= VM_C(1e-4) && a <= VM_C(1e5) && b >= VM_C(1e-4) && b <= VM_C(1e5);
}

/* Returns the limit of B(a, b) where a or b is 0 or infinite, and NaN where there is no limit. */
VM_API vm_real vmi_beta_limit(vm_real a, vm_real b)
{
    const int is_zero = a == 0 || b == 0, is_infinite = a == VM_INFINITY || b == VM_INFINITY;
    if (!(a >= 0) || !(b >= 0) || is_zero == is_infinite) return VM_NAN;
    if (is_zero) return VM_INFINITY;
    return 0;
}

/* The complete beta function B(a, b), for a and b from 1e-4 to 1e5.
   The error is at most 1 ulp. If a or b is 0 or infinite, the result is the limit: infinity if a or b is 0 and neither
   is infinite, and 0 if a or b is infinite and neither is 0. Returns NaN for other a or b. Equation (261). */
VM_API vm_real ateb_beta(vm_real a, vm_real b)
{
    vm_two l;
    if (!vmi_beta_is_in_domain(a, b)) return vmi_beta_limit(a, b);
    l = vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0));
    return vmi_exp(l.hi, l.lo);
}

/* The logarithm of the complete beta function, ln B(a, b), for a and b from 1e-30 to 1e30.
   B(a, b) itself may overflow or underflow. The error is at most 1 ulp plus 2^-57 (float 2^-28). The second term is
   important only where B is close to 1, so that ln B is close to 0. If a or b is 0 or infinite, the result is the
   logarithm of the limit that ateb_beta returns. Returns NaN for other a or b. */
VM_API vm_real ateb_ln_beta(vm_real a, vm_real b)
{
    const vm_real least = VM_C(1e-30), largest = VM_C(1e30);
    const vm_real limit = vmi_beta_limit(a, b);
    if (limit > 0) return VM_INFINITY;
    if (limit == 0) return -VM_INFINITY;
    if (!(a >= least) || !(b >= least) || !(a <= largest) || !(b <= largest)) return VM_NAN;
    return vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0)).hi;
}

/* The numbers from which the gamma function of z > 0 is computed, and by_Z = 1/Z. Z is z + i, where i is 6 for z < 6
   and 0 for any other z. The formulas are
     Gamma(z) = sqrt(2 pi) Z^(z - 1/2) e^(delta - z)/factor, factor = (z)_i e^i/Z^i, delta = vmi_beta_stirling(1/Z) */
typedef struct VM_TAG(vmi_beta_gamma) {
    vm_two Z;
    vm_real by_Z, factor, delta;
} vmi_beta_gamma;

/* Returns the numbers of vmi_beta_gamma for z. `rest` is 1 - Z by_Z, the remainder of the division 1/Z; the two largest
   of its four products are exact. The function tests z < 6 without a branch, since the processor would mispredict this
   branch half the time. */
VM_INLINE vmi_beta_gamma vmi_beta_gamma_of(vm_two z)
{
    const vm_real e6 = VM_C(403.42879349273512), t = z.hi, shifted = (vm_real)(t < 6);
    const vm_real rise = (t * (t + 5)) * (((t + 1) * (t + 4)) * ((t + 2) * (t + 3)));
    vmi_beta_gamma g;
    vm_real cube, head, by_head, rest;
    g.Z = vmi_two_sum(t, 6 * shifted);
    g.Z.lo += z.lo;
    g.by_Z = 1 / g.Z.hi;
    head = vmi_head(g.Z.hi);
    by_head = vmi_head(g.by_Z);
    rest = ((1 - head * by_head) - (g.Z.hi - head) * by_head) - g.Z.hi * (g.by_Z - by_head) - g.Z.lo * g.by_Z;
    cube = g.by_Z * g.by_Z * g.by_Z;
    g.factor = shifted * ((rise * cube) * (e6 * cube) * (1 + 6 * rest)) + (1 - shifted);
    g.delta = vmi_beta_stirling(g.by_Z);
    return g;
}

/* Returns ln(x S/A) in two words. t is the rounded quotient x S/A, and `lost` is x S - t A, which the rounding causes.
   The result is ln t, corrected by `lost`. The processor can compute ln t and `lost` at the same time. */
VM_INLINE vm_two vmi_beta_ln_quotient(vm_two x, vm_two S, const vmi_beta_gamma *A)
{
    const vm_real t = (x.hi * S.hi) * A->by_Z;
    const vm_two above = vmi_two_product(x.hi, S.hi), below = vmi_two_product(t, A->Z.hi);
    const vm_real lost = (above.hi - below.hi) + ((above.lo - below.lo) + (x.hi * S.lo + x.lo * S.hi - t * A->Z.lo));
    const vm_two l = vmi_log(t);
    return vmi_two(l.hi, l.lo + lost / above.hi);
}

/* Returns x^a y^b/B(a, b) for numbers x and y in two words with the sum 1. The relative error is a few ulp, unless x or
   y is close to the smallest number. Let A, B and S be the fields Z of vmi_beta_gamma for a, b and a + b. The fields
   factor and delta have the suffixes _a, _b and _s for a, b and a + b. Then the result is
     (x S/A)^a (y S/B)^b sqrt(A B/(2 pi S)) factor_a factor_b/factor_s e^(delta_s - delta_a - delta_b). */
VM_API vm_real vmi_beta_density(vm_two x, vm_two y, vm_real a, vm_real b)
{
    const vm_real by_2pi = VM_C(0.15915494309189533577);
    const vmi_beta_gamma A = vmi_beta_gamma_of(vmi_two(a, 0)), B = vmi_beta_gamma_of(vmi_two(b, 0));
    const vmi_beta_gamma S = vmi_beta_gamma_of(vmi_two_sum(a, b));
    const vm_real root = VM_SQRT(A.Z.hi * (B.Z.hi * S.by_Z) * by_2pi);
    const vm_two power_x = vmi_two_scaled(vmi_beta_ln_quotient(x, S.Z, &A), a);
    const vm_two power_y = vmi_two_scaled(vmi_beta_ln_quotient(y, S.Z, &B), b);
    vm_two sum = vmi_two_sum(power_x.hi, power_y.hi);
    sum = vmi_two_sum(sum.hi, sum.lo + (power_x.lo + power_y.lo) + (S.delta - A.delta - B.delta));
    return vmi_exp(sum.hi, sum.lo) * (root * (A.factor * B.factor / S.factor));
}

/* The continued fraction of Didonato and Morris, f_n = C_n + D_n/f_(n+1), at x and y = 1 - x. vmi_beta_level computes
   C_n and D_n, the numbers of level n. excess is a y - b x. */
typedef struct VM_TAG(vmi_beta_levels) {
    vm_real x, y, a, b, excess;
} vmi_beta_levels;

/* Sets the fields of vmi_beta_levels. Where a and b are large, digits cancel in the difference a y - b x; therefore it
   is computed in two words, from the smaller of x and y. */
VM_INLINE vmi_beta_levels vmi_beta_levels_of(vm_real x, vm_real y, vm_real a, vm_real b)
{
    const vm_two product = vmi_two_scaled(vmi_two_sum(a, b), vmi_smaller(x, y));
    vmi_beta_levels levels;
    levels.x = x;
    levels.y = y;
    levels.a = a;
    levels.b = b;
    levels.excess = (product.hi - b) + product.lo;
    if (x <= y) levels.excess = (a - product.hi) - product.lo;
    return levels;
}

/* Computes C_n and D_n, the numbers of level n. `before` is 1/(a + 2 n - 1), or any number for n = 0, and `after` is
   1/(a + 2 n + 1). */
VM_INLINE void vmi_beta_level(const vmi_beta_levels *l, vm_real n, vm_real before, vm_real after, vm_real *C,
                              vm_real *D)
{
    const vm_real an = l->a + n, share = l->x * after, next = n + 1;
    *C = n * (1 + (l->b - n) * l->x * before) + an * ((l->excess + 1) + n * (1 + l->y)) * after;
    *D = ((an * share) * ((an + l->b) * share)) * (next * (l->b - next));
}

/* Returns 1/f_0, where f_0 is the continued fraction of vmi_beta_levels with the levels 0 ... count. The evaluation
   begins with a rough value of f_(count+1) and goes down to level 0. A rough value is enough, since an error of f_(n+1)
   hardly changes f_n. */
VM_API vm_real vmi_beta_backward(const vmi_beta_levels *l, int count)
{
    vm_real f = (l->a + (vm_real)count) / 2, before, after = 1 / (l->a + 2 * (vm_real)count + 1), C, D;
    int n;
    for (n = count; n >= 0; n--) {
        before = 0;
        if (n > 0) before = 1 / (l->a + 2 * (vm_real)n - 1);
        vmi_beta_level(l, (vm_real)n, before, after, &C, &D);
        f = C + D / f;
        after = before;
    }
    return 1 / f;
}

/* The tolerance for which the result of vmi_beta_fraction has all its digits */
#define VMI_BETA_FULL (2 * VM_EPSILON)

/* A tolerance below VMI_BETA_FULL, for which vmi_beta_fraction always evaluates the fraction from its last level */
#define VMI_BETA_FINE VM_EPSILON

/* Returns 1/f_0 = I_x(a, b) B(a, b)/(x^a y^b) for x <= (a + 1)/(a + b + 2), with a relative error of about
   `tolerance`. The convergents P/Q of the fraction, which are its values after 1, 2, 3, ... levels, are computed two at
   a time, until two of them agree within the tolerance. Rounding errors add up in P and Q; therefore a fraction of more
   than SAFE levels is evaluated once more by vmi_beta_backward, from its last level. */
VM_API vm_real vmi_beta_fraction(vm_real x, vm_real y, vm_real a, vm_real b, vm_real tolerance)
{
    enum { MOST = 20000, SAFE = 20 }; /* MOST is a precaution: some 250 levels are enough, and a NaN ends the loop */
    const vmi_beta_levels l = vmi_beta_levels_of(x, y, a, b);
    vm_real P0 = 1, Q0 = 0, P1, Q1 = 1, P2, Q2, C, D, D_next, last, ratio = 0, before, after = 1 / (a + 1);
    int levels = 0;
    vmi_beta_level(&l, 0, 0, after, &P1, &D);
    do {
        const vm_real n = (vm_real)levels;
        before = after;
        after = 1 / (a + 2 * n + 3);
        vmi_beta_level(&l, n + 1, before, after, &C, &D_next);
        P2 = C * P1 + D * P0;
        Q2 = C * Q1 + D * Q0;
        before = after;
        after = 1 / (a + 2 * n + 5);
        vmi_beta_level(&l, n + 2, before, after, &C, &D);
        P1 = 1 / (C * P2 + D_next * P1); /* from here on, all four numbers are divided by the new P */
        Q1 = (C * Q2 + D_next * Q1) * P1;
        P0 = P2 * P1;
        Q0 = Q2 * P1;
        P1 = 1;
        last = ratio;
        ratio = Q1;
        levels += 2;
    } while (VM_FABS(ratio - last) > tolerance * ratio && levels < MOST);
    if (levels > SAFE || tolerance < VMI_BETA_FULL) return vmi_beta_backward(&l, levels);
    return ratio;
}

/* Returns I_x(a, b) a B(a, b)/x^a - 1 for a <= 1, x <= 2/3 and b x < 2. The result is a times the sum over n >= 1 of
   (1 - b)_n/n! x^n/(a + n), where (z)_n = z (z + 1) ... (z + n - 1). Term n is below the larger of x^n and (b x)^n/n!,
   so that the terms soon become small. */
VM_API vm_real vmi_beta_series(vm_real x, vm_real a, vm_real b)
{
    const vm_real most = 200; /* a precaution: 96 terms are enough, and a NaN ends the loop at once */
    vm_real power = 1, term, sum = 0, n = 0;
    do {
        n += 1;
        power *= x * (n - b) / n;
        term = power / (a + n);
        sum += term;
    } while (VM_FABS(term) > VM_EPSILON / 8 * VM_FABS(sum) && n < most);
    return a * sum;
}

/* Returns ln(1 - e^l) for l < 0, where e^l = 2^k (1 + p) with an integer k. If k = 0, the number 1 - e^l is -p, so that
   no digits are lost. */
VM_API vm_two vmi_ln_one_minus_exp(vm_two l)
{
    vm_two rest = {0, 0};
    vm_real p, p_lo;
    int k;
    if (!(l.hi >= -2 * VM_C(0.6931471805599453) * VM_MANT_DIG)) { /* the result is -e^l, which is tiny, or NaN */
        rest.hi = -vmi_exp(l.hi, l.lo);
        return rest;
    }
    p = vmi_exp_core(l.hi, l.lo, &k, &p_lo);
    if (k == 0) {
        rest.hi = -p;
        rest.lo = -p_lo;
    } else {
        vm_two e = vmi_fast_two_sum(1, p);
        e.lo += p_lo;
        rest = vmi_two_sum(1, -vmi_ldexp(e.hi, k));
        rest.lo -= vmi_ldexp(e.lo, k);
    }
    return vmi_two_log(rest);
}

/* A point between 0 and 1: x, y = 1 - x and their logarithms */
typedef struct VM_TAG(vmi_beta_point) {
    vm_real x, y;
    vm_two ln_x, ln_y;
} vmi_beta_point;

/* Returns the point with x and y exchanged. */
VM_API vmi_beta_point vmi_beta_mirrored(vmi_beta_point at)
{
    vmi_beta_point mirrored;
    mirrored.x = at.y;
    mirrored.y = at.x;
    mirrored.ln_x = at.ln_y;
    mirrored.ln_y = at.ln_x;
    return mirrored;
}

/* Returns ln I_x(a, b) at the point `at`, for x <= (a + 1)/(a + b + 2), where ln_density = ln(x^a y^b/B(a, b)). Where a
   is small, I_x is close to 1, and the caller also computes 1 - I_x from the result. Therefore the function uses
   vmi_beta_series for a <= 1: this series loses no digits. It does not need the factor y^b of the density. */
VM_API vm_two vmi_beta_ln_tail(vmi_beta_point at, vm_real a, vm_real b, vm_two ln_density)
{
    vm_two f;
    if (a <= 1) {
        f = vmi_two_plus(vmi_two_log(vmi_two_sum(1, vmi_beta_series(at.x, a, b))), vmi_minus(vmi_log(a)));
        f = vmi_two_plus(f, vmi_two_scaled(at.ln_y, -b));
    } else f = vmi_log(vmi_beta_fraction(at.x, at.y, a, b, VMI_BETA_FINE));
    return vmi_two_plus(ln_density, f);
}

/* Computes *ln_p = ln I_x(a, b) and *ln_q = ln I_y(b, a), where y = 1 - x, from ln_density = ln(x^a y^b/B(a, b)). For
   x <= (a + 1)/(a + b + 2) *ln_p is computed directly, for a larger x *ln_q is computed directly. The other logarithm
   follows from p + q = 1. */
VM_API void vmi_beta_tails(const vmi_beta_point *at, vm_real a, vm_real b, vm_two ln_density, vm_two *ln_p,
                           vm_two *ln_q)
{
    if (at->x * (a + b + 2) <= a + 1) {
        *ln_p = vmi_beta_ln_tail(*at, a, b, ln_density);
        *ln_q = vmi_ln_one_minus_exp(*ln_p);
    } else {
        *ln_q = vmi_beta_ln_tail(vmi_beta_mirrored(*at), b, a, ln_density);
        *ln_p = vmi_ln_one_minus_exp(*ln_q);
    }
}

/* Returns 1 if x and y are not negative and add up to 1, apart from rounding, else 0. */
VM_API int vmi_beta_is_split_of_1(vm_real x, vm_real y)
{
    return x >= 0 && y >= 0 && VM_FABS((x + y) - 1) <= 4 * VM_EPSILON;
}

/* Computes ln I_x(a, b) and ln I_y(b, a) for x and y = 1 - x in two words. */
VM_API void vmi_beta_logarithms(vm_two x, vm_two y, vm_real a, vm_real b, vm_two *ln_p, vm_two *ln_q)
{
    vmi_beta_point at;
    vm_two ln_density;
    at.x = x.hi;
    at.y = y.hi;
    at.ln_x = vmi_two_log(x);
    at.ln_y = vmi_two_log(y);
    ln_density = vmi_beta_ln_density(vmi_two(a, 0), vmi_two(b, 0), at.ln_x, at.ln_y);
    vmi_beta_tails(&at, a, b, ln_density, ln_p, ln_q);
}

/* If a or b is 0 or infinite, the limit of I_x(a, b) jumps from 0 to 1 at one value of x. Returns -1 if this jump is at
   x = 0, and 1 if it is at x = 1. Returns 0 for other a and b, and if there is no limit. */
VM_API int vmi_beta_limit_side(vm_real a, vm_real b)
{
    const int at_0 = a == 0 || b == VM_INFINITY, at_1 = b == 0 || a == VM_INFINITY;
    if (!(a >= 0) || !(b >= 0)) return 0;
    return at_1 - at_0;
}

/* The regularised incomplete beta function p = I_x(a, b) and q = 1 - p. Both are computed from the smaller of x and
   y = 1 - x: give this number with all its digits. For a and b from 1e-3 to 1e4 the errors of p and q are at most 30
   ulp each. a and b may also lie between 1e-4 and 1e5, where the function is less accurate and slower. If a or b is 0
   or infinite, p is the limit of I_x(a, b). This limit is 1 for x > 0 if a is 0 or b is infinite. It is 0 for x < 1 if
   b is 0 or a is infinite. If both conditions hold, as for a = b = 0, there is no limit. The results are NaN for other
   a or b, if there is no limit, if x or y is negative, and if x + y is not 1.
   docs/cost.md has the time of a call. DLMF 8.17, equation (273). */
VM_API void ateb_beta_inc_both(vm_real x, vm_real y, vm_real a, vm_real b, vm_real *p, vm_real *q)
{
    const vm_real longest = VM_C(0.6); /* 1 minus a larger tail would lose digits; then logarithms are used */
    const vm_real least = VM_MIN / (VM_EPSILON * VM_EPSILON); /* products with smaller numbers may underflow */
    vm_two x2 = vmi_two(x, 0), y2 = vmi_two(y, 0);
    vm_real tail, density;
    vm_two ln_p, ln_q;
    const int side = vmi_beta_limit_side(a, b);
    int left;
    *p = VM_NAN;
    *q = VM_NAN;
    if (!vmi_beta_is_split_of_1(x, y)) return;
    if ((side < 0 && x > 0) || (side > 0 && y > 0)) {
        *p = (vm_real)(side < 0);
        *q = (vm_real)(side > 0);
        return;
    }
    if (!vmi_beta_is_in_domain(a, b)) return;
    if (x == 0 || y == 0) {
        *p = (vm_real)(x != 0);
        *q = (vm_real)(x == 0);
        return;
    }
    if (x <= y) y2 = vmi_two_sum(1, -x);
    else x2 = vmi_two_sum(1, -y);
    left = x * (a + b + 2) <= a + 1;
    density = vmi_beta_density(x2, y2, a, b);
    if (left) tail = density * vmi_beta_fraction(x2.hi, y2.hi, a, b, VMI_BETA_FULL);
    else tail = density * vmi_beta_fraction(y2.hi, x2.hi, b, a, VMI_BETA_FULL);
    if (!(density > least) || !(vmi_smaller(x, y) > least) || tail > longest) {
        vmi_beta_logarithms(x2, y2, a, b, &ln_p, &ln_q);
        *p = vmi_exp(ln_p.hi, ln_p.lo);
        *q = vmi_exp(ln_q.hi, ln_q.lo);
    } else {
        *p = 1 - tail;
        *q = tail;
        if (left) {
            *p = tail;
            *q = 1 - tail;
        }
    }
}

/* The regularised incomplete beta function I_x(a, b), for 0 <= x <= 1.
   Domain and accuracy are those of ateb_beta_inc_both. */
VM_API vm_real ateb_beta_inc(vm_real x, vm_real a, vm_real b)
{
    vm_real p, q;
    ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
    return p;
}

/* The logarithm of the regularised incomplete beta function, ln I_x(a, b), for 0 <= x <= 1.
   I_x itself may underflow. Domain and limits are those of ateb_beta_inc. For a and b from 1e-3 to 1e4 the error is at
   most 30 ulp. ln(1 - I_x(a, b)) is ln I_(1-x)(b, a). */
VM_API vm_real ateb_ln_beta_inc(vm_real x, vm_real a, vm_real b)
{
    const int side = vmi_beta_limit_side(a, b);
    vm_two ln_p, ln_q;
    if (!(x >= 0) || !(x <= 1)) return VM_NAN;
    if (side < 0 && x > 0) return 0;
    if (side > 0 && x < 1) return -VM_INFINITY;
    if (!vmi_beta_is_in_domain(a, b)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x == 1) return 0;
    vmi_beta_logarithms(vmi_two(x, 0), vmi_two_sum(1, -x), a, b, &ln_p, &ln_q);
    return ln_p.hi;
}

/* The signs by which ateb_mean_nm multiplies the powers. For both signs the two constants are added. */
enum { ATEB_SIGN_OF_SA = 1, ATEB_SIGN_OF_CA = 2 };

/* The mean of |sa(n, m, s)|^p |ca(m, n, s)|^q over a period, with or without the signs of sa and ca.
   The indices n and m of sa and ca lie between 0 and 1e30. The powers p and q are above -1 and at most 1e6. signs is 0,
   ATEB_SIGN_OF_SA, ATEB_SIGN_OF_CA or their sum. A power with the sign of its base, such as sa^3, is as often negative
   as positive, so that the mean is 0. For example, the mean of sa^2 ca^3 is ateb_mean_nm(n, m, 2, 3, ATEB_SIGN_OF_CA).
   The mean without signs is B((p+1)/(n+1), (q+1)/(m+1))/B(1/(n+1), 1/(m+1)), with an error of at most 2 ulp. Returns
   NaN for an argument outside these limits. Equation (316). */
VM_API vm_real ateb_mean_nm(vm_real n, vm_real m, vm_real p, vm_real q, int signs)
{
    const vm_real largest_index = VM_C(1e30), largest_power = VM_C(1e6);
    const vm_two one = {1, 0};
    vm_two n1, m1, ln_above, ln_below, ln_mean;
    if (!(n >= 0) || !(n <= largest_index) || !(m >= 0) || !(m <= largest_index)) return VM_NAN;
    if (!(p > -1) || !(q > -1) || !(p <= largest_power) || !(q <= largest_power)) return VM_NAN;
    if (signs < 0 || signs > ATEB_SIGN_OF_SA + ATEB_SIGN_OF_CA) return VM_NAN;
    if (signs != 0) return 0;
    n1 = vmi_two_sum(n, 1);
    m1 = vmi_two_sum(m, 1);
    ln_above = vmi_beta_ln(vmi_two_over(vmi_two_sum(p, 1), n1), vmi_two_over(vmi_two_sum(q, 1), m1));
    ln_below = vmi_beta_ln(vmi_two_over(one, n1), vmi_two_over(one, m1));
    ln_mean = vmi_two_plus(ln_above, vmi_minus(ln_below));
    return vmi_exp(ln_mean.hi, ln_mean.lo);
}

/* The mean of |sa|^p |ca|^q over a period, for alpha >= 0 and p, q > -1. Averaged equations of oscillators need this
   mean. alpha may be up to 1e30, p and q up to 1e6; for larger numbers the result is NaN. The error is at most 2 ulp.
   ateb_mean_nm computes means for two indices and with signs. Equation (316). */
VM_API vm_real ateb_mean(vm_real alpha, vm_real p, vm_real q) { return ateb_mean_nm(1, alpha, p, q, 0); }

#endif
/* ateb/beta_inverse.h - inverse of the incomplete beta function

   p is I_x(a, b), as in ateb/beta.h, q is 1 - p, and y is 1 - x.

       vm_real x = ateb_beta_inc_inv(VM_C(0.3), VM_C(0.5), 2); // I_x(0.5, 2) = 0.3

   Method: ln I_x(a, b) is a concave function of t = ln(x/y). Steps of third order lead to the t where it is equal to
   ln p. The first steps use rough values of ln I_x, the later steps logarithms in two words. Tests:
   tests/test_ateb.c. */
#ifndef VARMASS_ATEB_BETA_INVERSE_H
#define VARMASS_ATEB_BETA_INVERSE_H

/* Returns the point with x/y = e^t, where y = 1 - x. ln x and ln y are computed from the rounded value of e^-|t|, from
   which x and y are computed too. The two logarithms then belong to numbers whose sum is 1 in two words. */
VM_API vmi_beta_point vmi_beta_point_at(vm_real t)
{
    const vm_real size = VM_FABS(t), e = vmi_exp(-size, 0);
    const vm_two sum = vmi_two_sum(1, e);
    vmi_beta_point at;
    vm_two ln_e = vmi_two(-size, 0);
    if (e > VM_MIN) ln_e = vmi_log(e);
    at.ln_y = vmi_minus(vmi_two_log(sum));
    at.ln_x = vmi_two_plus(ln_e, at.ln_y);
    at.y = 1 / sum.hi;
    at.y -= at.y * (at.y * sum.lo);
    at.x = e * at.y;
    if (!(t < 0)) at = vmi_beta_mirrored(at);
    return at;
}

/* ln I_x(a, b) as a function of t = ln(x/y): its value, its slope (the derivative of `value` with respect to t), and
   its bend (the derivative of ln(slope) with respect to t). `noise` is the largest error of `value`. */
typedef struct VM_TAG(vmi_beta_slope) {
    vm_real value, slope, bend, noise;
} vmi_beta_slope;

/* Returns the fields of vmi_beta_slope at t = ln(x/y). ln_B is ln B(a, b). For x <= (a + 1)/(a + b + 2) the error of
   ln I_x is about 1e-8 (float 1e-4). For a larger x, I_x is computed as 1 - I_y(b, a), and the error of ln I_x is about
   1e-8/I_x (float 1e-4/I_x). */
VM_API vmi_beta_slope vmi_beta_rough(vm_real t, vm_real a, vm_real b, vm_real ln_B)
{
    const vm_real tolerance = VM_MANT_DIG > 24 ? VM_C(1e-8) : VM_C(1e-4), least_ln = VM_C(-0.69) * VMI_BIAS;
    const vm_real size = VM_FABS(t), e = vmi_ateb_exp(vmi_larger(-size, least_ln)), longer = 1 / (1 + e);
    const vm_real shorter = e * longer, ln_longer = -vmi_ateb_ln(1 + e), ln_shorter = ln_longer - size;
    vmi_beta_slope at;
    vm_real x = shorter, y = longer, ln_density = a * ln_shorter + b * ln_longer - ln_B, f, p;
    if (t > 0) {
        x = longer;
        y = shorter;
        ln_density = a * ln_longer + b * ln_shorter - ln_B;
    }
    at.noise = tolerance;
    if (x * (a + b + 2) <= a + 1) {
        f = vmi_beta_fraction(x, y, a, b, tolerance);
        at.value = ln_density + vmi_ateb_ln(f);
        at.slope = 1 / f;
    } else {
        p = 1 - vmi_beta_fraction(y, x, b, a, tolerance) * vmi_ateb_exp(vmi_larger(ln_density, least_ln));
        p = vmi_larger(p, tolerance);
        at.noise = tolerance / p;
        at.value = vmi_ateb_ln(p);
        at.slope = vmi_ateb_exp(vmi_larger(ln_density - at.value, least_ln));
    }
    at.bend = a * y - b * x - at.slope;
    return at;
}

/* Returns the step of t that changes ln I_x by `rest`. ln I_x is approximated by the parabola with this slope and bend
   (see vmi_beta_slope). If it does not reach the wanted value, the step is twice that of its tangent. */
VM_API vm_real vmi_beta_step(vm_real rest, vm_real slope, vm_real bend)
{
    const vm_real step = rest / slope;
    return 2 * step / (1 + VM_SQRT(vmi_larger(1 + 2 * step * bend, 0)));
}

/* Returns a start value of t = ln(x/y) for the solution of I_x(a, b) = p with p <= 1/2. For t to -infinity, ln I_x
   tends to the straight line a t - ln(a B(a, b)). This line is equal to ln p at a t that is smaller than the solution,
   and the function returns this t. For a, b > 1 it also computes the approximation by a normal distribution, and
   returns the larger number (Abramowitz and Stegun 26.5.22, with the quantile by 26.2.23). */
VM_API vm_real vmi_beta_start(vm_real ln_p, vm_real a, vm_real b, vm_real ln_B)
{
    const vm_real ln_a = vmi_ateb_ln(a), asymptote = (ln_p + ln_a + ln_B) / a;
    vm_real s, above, below, quantile, by_a, by_b, h, shift, w;
    if (!(a > 1) || !(b > 1)) return asymptote;
    s = VM_SQRT(-2 * ln_p);
    above = VM_C(2.515517) + s * (VM_C(0.802853) + s * VM_C(0.010328));
    below = 1 + s * (VM_C(1.432788) + s * (VM_C(0.189269) + s * VM_C(0.001308)));
    quantile = s - above / below;
    by_a = 1 / (2 * a - 1);
    by_b = 1 / (2 * b - 1);
    h = 2 / (by_a + by_b);
    shift = (quantile * quantile - 3) / 6;
    w = quantile * VM_SQRT(h + shift) / h - (by_b - by_a) * (shift + VM_C(0.83333333) - VM_C(0.66666667) / h);
    return vmi_larger(asymptote, ln_a - vmi_ateb_ln(b) - 2 * w);
}

/* Returns a t within about 1e-2 of the solution of I_x(a, b) = p, from the start value t. The search ends earlier where
   the rough values of ln I_x have errors above 0.01. */
VM_API vm_real vmi_beta_approach(vm_real t, vm_real ln_p, vm_real a, vm_real b, vm_real ln_B)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(2e-3) : VM_C(2e-2); /* a shorter step ends the search */
    const int most = 60; /* largest number of steps; in double 12 are enough */
    int i;
    for (i = 0; i < most; i++) {
        const vmi_beta_slope rough = vmi_beta_rough(t, a, b, ln_B);
        const vm_real step = vmi_beta_step(ln_p - rough.value, rough.slope, rough.bend);
        if (rough.noise > VM_C(0.01)) break;
        t += step;
        if (!(VM_FABS(step) * (1 + rough.slope) > enough)) break;
    }
    return t;
}

/* Returns the point whose t = ln(x/y) is larger than that of `at` by a short step. The function changes x, y, ln x and
   ln y directly, so that none of them loses digits. The error is about the third power of the step. */
VM_API vmi_beta_point vmi_beta_moved(const vmi_beta_point *at, vm_real step)
{
    const vm_real half = step / 2;
    vmi_beta_point moved;
    moved.x = at->x + at->x * (at->y * (step * (1 + (at->y - at->x) * half)));
    moved.y = at->y - at->y * (at->x * (step * (1 + (at->y - at->x) * half)));
    moved.ln_x = vmi_two_sum(at->ln_x.hi, at->ln_x.lo + at->y * (step * (1 - at->x * half)));
    moved.ln_y = vmi_two_sum(at->ln_y.hi, at->ln_y.lo - at->x * (step * (1 + at->y * half)));
    return moved;
}

/* Returns the point where I_x(a, b) = p, from ln p, for p <= 1/2. ln I_x is a concave function of t = ln(x/y). The
   method starts at vmi_beta_start and makes steps of third order by vmi_beta_step: the error after a step is about the
   third power of the step. The first steps, those of vmi_beta_approach, use rough values of ln I_x. Later steps use
   logarithms in two words. */
VM_API vmi_beta_point vmi_beta_invert(vm_two ln_p, vm_real a, vm_real b)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3); /* a shorter step is the last one */
    const int most = 60;                                               /* largest number of steps */
    const vm_two ln_B = vmi_beta_ln(vmi_two(a, 0), vmi_two(b, 0));
    vm_real t = vmi_beta_start(ln_p.hi, a, b, ln_B.hi), step;
    vmi_beta_point at;
    int i;
    t = vmi_beta_approach(t, ln_p.hi, a, b, ln_B.hi);
    for (i = 0; i < most; i++) {
        vm_two density, tail, other, rest;
        vm_real slope;
        at = vmi_beta_point_at(t);
        density = vmi_two_plus(vmi_two_scaled(at.ln_x, a), vmi_two_scaled(at.ln_y, b));
        density = vmi_two_plus(density, vmi_minus(ln_B));
        vmi_beta_tails(&at, a, b, density, &tail, &other);
        rest = vmi_two_plus(ln_p, vmi_minus(tail));
        slope = vmi_exp(density.hi - tail.hi, density.lo - tail.lo);
        step = vmi_beta_step(rest.hi, slope, a * at.y - b * at.x - slope);
        if (!(VM_FABS(step) * (1 + slope) > enough) || VM_FABS(step) <= VM_EPSILON * VM_FABS(t))
            return vmi_beta_moved(&at, step);
        t += step;
    }
    return vmi_beta_point_at(t);
}

/* Returns the point where I_x(a, b) = p, for p > 0, q > 0 and p + q = 1, from the smaller of p and q */
VM_API vmi_beta_point vmi_beta_invert_both(vm_real p, vm_real q, vm_real a, vm_real b)
{
    if (p <= q) return vmi_beta_invert(vmi_log(p), a, b);
    return vmi_beta_mirrored(vmi_beta_invert(vmi_log(q), b, a));
}

/* The inverse of ateb_beta_inc_both: x with I_x(a, b) = p, and y = 1 - x and ln x. All three are computed from the
   smaller of p and q = 1 - p: give this number with all its digits. ln x is right even where x underflows. For a and b
   from 1e-3 to 1e4 the errors of x, y and ln x are at most 16 ulp plus the change that an error of one ulp in the
   smaller of p and q makes. a and b may also lie between 1e-4 and 1e5, where the function is less accurate and slower.
   If a or b is 0 or infinite, x is the limit. This limit is 0 for p < 1 if a is 0 or b is infinite. It is 1 for p > 0
   if b is 0 or a is infinite. If both conditions hold, there is no limit. The results are NaN for other a or b, if
   there is no limit, if p or q is negative, and if p + q is not 1.
   docs/cost.md has the time of a call. */
VM_API void ateb_beta_inc_inv_both(vm_real p, vm_real q, vm_real a, vm_real b, vm_real *x, vm_real *y,
                                   vm_real *ln_x)
{
    const int side = vmi_beta_limit_side(a, b), is_at_0 = side < 0 && q > 0, is_at_1 = side > 0 && p > 0;
    vmi_beta_point at;
    *x = VM_NAN;
    *y = VM_NAN;
    *ln_x = VM_NAN;
    if (!vmi_beta_is_split_of_1(p, q)) return;
    if (!is_at_0 && !is_at_1 && !vmi_beta_is_in_domain(a, b)) return;
    if (is_at_0 || (p == 0 && !is_at_1)) {
        *x = 0;
        *y = 1;
        *ln_x = -VM_INFINITY;
    } else if (is_at_1 || q == 0) {
        *x = 1;
        *y = 0;
        *ln_x = 0;
    } else {
        at = vmi_beta_invert_both(p, q, a, b);
        *x = at.x;
        *y = at.y;
        *ln_x = at.ln_x.hi;
    }
}

/* The inverse of ateb_beta_inc: x with I_x(a, b) = p, for 0 <= p <= 1.
   Domain and accuracy are those of ateb_beta_inc_inv_both. */
VM_API vm_real ateb_beta_inc_inv(vm_real p, vm_real a, vm_real b)
{
    vm_real x, y, ln_x;
    ateb_beta_inc_inv_both(p, 1 - p, a, b, &x, &y, &ln_x);
    return x;
}

#endif
/* ateb/two_indices.h - Ateb functions with two indices, sa(n, m, s) and ca(m, n, s)

   sa(n, m, s) and ca(m, n, s) satisfy |sa|^(n+1) + |ca|^(m+1) = 1 and have the period 2 Pi(n, m), where
   Pi(n, m) = B(1/(n+1), 1/(m+1)). For n = 1 and m = alpha they are sa and ca of ateb/functions.h, where they are
   computed much faster. The swapped pair sa(alpha, 1, s), ca(1, alpha, s), which (278) and (280) need, comes from
   ateb_saca_nm(s, alpha, 1, &sa, &ca).

       vm_real sa, ca;
       ateb_saca_nm(VM_C(0.7), 2, 3, &sa, &ca);

   Method: inversion of the incomplete beta function (ateb/beta_inverse.h). Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_TWO_INDICES_H
#define VARMASS_ATEB_TWO_INDICES_H

/* Returns 1 if n may be an index, that is, if it is 0 or lies between 1e-4 and 1e5, else 0. */
VM_API int vmi_ateb_index_is_in_domain(vm_real n) { return n == 0 || (n >= VM_C(1e-4) && n <= VM_C(1e5)); }

/* Returns 1/(n + 1) in two words. */
VM_API vm_two vmi_ateb_exponent(vm_real n) { return vmi_two_over(vmi_two(1, 0), vmi_two_sum(n, 1)); }

/* Returns B_(1/2)(a, b) 2^(a+b) = 2F1(1, a+b; a+1; 1/2)/a for b <= 1 (DLMF 8.17.8). B_(1/2) is the incomplete beta
   function at x = 1/2 (not regularised). 2F1 is a power series, in which each term is at most half of the previous
   term, so that 2 VM_MANT_DIG terms are enough for two words. */
VM_API vm_two vmi_ateb_half_beta(vm_two a, vm_two b)
{
    const vm_two one = {1, 0}, c = vmi_two_plus(a, b);
    vm_two sum = one;
    int j;
    for (j = 2 * VM_MANT_DIG; j > 0; j--) {
        const vm_two above = vmi_two_plus(c, vmi_two((vm_real)(j - 1), 0));
        const vm_two below = vmi_two_plus(a, vmi_two((vm_real)j, 0));
        sum = vmi_two_plus(one, vmi_half(vmi_two_times(sum, vmi_two_over(above, below))));
    }
    return vmi_two_over(sum, a);
}

/* Returns Pi(n, m) = B(a, b) for a = 1/(n + 1) and b = 1/(m + 1), with a relative error of 2^-102 (float 2^-44); the
   logarithms of ateb/beta.h would give only 2^-64. Pi(n, m) is B_(1/2)(a, b) + B_(1/2)(b, a). vmi_ateb_half_beta
   returns each of them times 2^(a+b); therefore the sum is divided by 2^(a+b) = e^y, which is computed by the power
   series of e^y. */
VM_API vm_two vmi_ateb_pi_nm(vm_real n, vm_real m)
{
    enum { TERMS = VM_MANT_DIG > 24 ? 32 : 18 };
#if VM_MANT_DIG > 24
    const vm_two ln2 = {VM_C(0.69314718055994528623), VM_C(2.3190468138462995584e-17)};
#else
    const vm_two ln2 = {VM_C(0.693147182465), VM_C(-1.90465429995e-9)};
#endif
    const vm_two one = {1, 0}, a = vmi_ateb_exponent(n), b = vmi_ateb_exponent(m);
    const vm_two y = vmi_two_times(vmi_two_plus(a, b), ln2); /* at most 1.39 */
    vm_two power = one;
    int j;
    for (j = TERMS; j > 0; j--)
        power = vmi_two_plus(one, vmi_two_over(vmi_two_times(power, y), vmi_two((vm_real)j, 0)));
    return vmi_two_over(vmi_two_plus(vmi_ateb_half_beta(a, b), vmi_ateb_half_beta(b, a)), power);
}

/* Pi(n, m), half the period of sa(n, m, s) and ca(m, n, s). Each index is 0 or lies between 1e-4 and 1e5.
   Pi(n, m) = B(1/(n+1), 1/(m+1)); Pi(1, alpha) is ateb_pi(alpha). The error is at most 1 ulp. Returns NaN for other
   indices. */
VM_API vm_real ateb_pi_nm(vm_real n, vm_real m)
{
    if (!vmi_ateb_index_is_in_domain(n) || !vmi_ateb_index_is_in_domain(m)) return VM_NAN;
    return vmi_ateb_pi_nm(n, m).hi;
}

/* Returns x^a for the x with I_x(a, b) = p, where q = 1 - p. The function uses logarithms, since x itself may
   underflow. */
VM_API vm_real vmi_ateb_nm_first(vm_real p, vm_real q, vm_real a, vm_real b)
{
    vm_two power;
    if (p == 0) return 0;
    if (q == 0) return 1;
    power = vmi_two_scaled(vmi_beta_invert_both(p, q, a, b).ln_x, a);
    return vmi_exp(power.hi, power.lo);
}

/* sa(n, m, s) and ca(m, n, s), the Ateb functions with two indices. s is any real number; each index is 0 or lies
   between 1e-3 and 1e3. s, sa and ca are pure numbers. The errors are at most 8 ulp plus the change that an error of
   2^-102 |s| (float 2^-44 |s|) in s makes. Indices between 1e-4 and 1e5 are allowed too, with less accuracy. The
   results are NaN for other indices and for NaN and infinite s. */
VM_API void ateb_saca_nm(vm_real s, vm_real n, vm_real m, vm_real *sa, vm_real *ca)
{
    vm_real a, b, rest, r, d; /* r and d: the distances of s from the nearest zeros of sa and ca */
    vm_two quarter_period;
    int quarter;
    if (!vmi_ateb_index_is_in_domain(n) || !vmi_ateb_index_is_in_domain(m) || !VM_IS_FINITE(s)) {
        *sa = VM_NAN;
        *ca = VM_NAN;
        return;
    }
    a = 1 / (n + 1);
    b = 1 / (m + 1);
    quarter_period = vmi_half(vmi_ateb_pi_nm(n, m));
    rest = vmi_reduce(VM_FABS(s), quarter_period, &quarter).hi;
    d = VM_FABS(rest);
    r = (quarter_period.hi - d) + quarter_period.lo;
    if (!(quarter & 1)) {
        const vm_real other = r;
        r = d;
        d = other;
    }
    *sa = vmi_ateb_nm_first(r / quarter_period.hi, d / quarter_period.hi, a, b);
    *ca = vmi_ateb_nm_first(d / quarter_period.hi, r / quarter_period.hi, b, a);
    vmi_ateb_signs(s, rest, (vmi_bits)quarter, sa, ca);
}

#endif

VMI_QUIET_END

#endif
