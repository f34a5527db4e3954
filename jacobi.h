/* jacobi.h - Jacobi's elliptic functions, complete elliptic integrals, and the modulus from its quarter period

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include <stdio.h>
       #include "jacobi.h"
       int main(void)
       {
           double sn, cn, dn;
           jacobi_sncndn(1.2, 0.3, &sn, &cn, &dn);
           printf("K(0.3) = %.16g, cn(1.2 | 0.3) = %.16g\n", jacobi_K(0.3), cn);
           return 0;
       }

   CONVENTIONS
     The variable comes first, then the parameter; results come last. The parameter is m = k^2, not the modulus k:
     jacobi_K(0.25) is K for k = 1/2. SciPy, Mathematica and GSL's elljac take m too; Boost, C++17 and GSL's Kcomp
     take k. Any m <= 1 is allowed, negative ones included. The complementary parameter is m1 = 1 - m, the
     complementary modulus k' = sqrt(m1). The functions with the suffix _m1 take or return m1, which keeps its digits
     where m is close to 1. sn and cn have the period 4 K(m), dn has 2 K(m). All arguments are pure numbers.

   WHAT TO CALL
     jacobi_sncndn        sn, cn and dn for one u and one m; the twelve quotients and the amplitude have functions of
                          their own
     jacobi_K, jacobi_E   complete elliptic integrals
     jacobi_plan_init     prepares a plan for one m; then call jacobi_plan_sncndn for one u, or
                          jacobi_plan_sncndn_array for many u. A plan is plain data and may be a constant in flash;
                          examples/jacobi_plan prints one. On AVR copy it from there to RAM, by memcpy_P, before it is
                          used.
     jacobi_solve_kpK     m from k'K(k^2); jacobi_solve_K returns m from K
     jacobi_cn_means      mean values of cn^2, cn^4 and cn^6 over a period
     jacobi_agm_...       sn, cn, dn and K by the arithmetic-geometric mean; for sn, cn and dn its number of steps is an
                          argument

   ERRORS
     m > 1, m1 < 0, c < 0 (the argument of the solvers), NaN and infinite arguments give NaN. m = 1 gives the limits:
     K is infinite, E is 1, sn is tanh u, cn and dn are 1/cosh u, for u = +-infinity too. A quotient at a pole is
     infinite. A plan refuses a bad m with -1 and stays as it was. Nothing else can fail. The functions allocate no
     memory and keep no state; the value of errno means nothing.

   METHOD
     Where u^2 max(1, 1 - m) is small, cs^2(u/4 | m) is computed by its Laurent series, and two duplications [1, 5] lead
     to u. This needs one square root, but not K.
     If u is beyond about K/2, it is first reduced by the quarter period K. The closer u is to a zero, the more words of
     K are used. K comes from two steps of the arithmetic-geometric mean and a series, or from the mean in two or three
     words.
     Far from 0, for m near 1 or below -20, theta functions of an imaginary phase are used [1], with the nome of 1 - m
     or 1/(1 - m), which is then at most 0.003.
     A plan has polynomials in u^2 in place of the series. No digits cancel, not even for m = 1.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double; the tests run both
     VM_API               linkage of every function, default static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If it is defined as VM_API,
                          the code is smaller and the results are the same.
     VM_SQRT, VM_FABS, VM_FLOOR, VM_COPYSIGN
                          the functions of the C library that are used; define all four or none.
                          These functions are exact, so that results are the same on every machine, unless the compiler
                          fuses products and sums.
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. Default:
                          static const and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables
                          take no RAM
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, although none of the bounds below holds then
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for
     zero. vm_self_check() returns 0 in these cases, and 1 where all is well; a program may call it once when it starts.
     On x87 units gcc in its gnu modes (gcc -m32, no -std=c99) keeps excess precision, with which neither the bounds
     below nor symmetry to the last bit hold; -fexcess-precision=standard, or -msse2 -mfpmath=sse, restores them.

   ACCURACY, as bounds that the tests check, with inputs taken as exact; docs/measurements.md has the errors found.
     sn, cn, dn   absolute error <= 4 eps max(1, k') for |u| <= 1e9 and |u| <= 2^40 K (float 1e4 and 2^17 K). Relative
                  error <= 8 ulp for |u| <= 100 K, at the zeros and next to them too (in float, except where u is
                  within 1/2000 ulp of a zero). A plan is as accurate. For |u| >= K/eps the digits of u say nothing
                  about the phase: then sn = 0 and cn = dn = 1.
     K, E         <= 2 ulp
     k'K          <= 5 ulp
     means        <= 8 ulp
     quotients    <= 8 ulp, the amplitude too
     solvers      m and m1: <= 4 ulp plus the change that one ulp of c makes

   COST
     docs/cost.md has the times, docs/counts.md the instructions of each function. A jacobi_plan has 304 bytes (float
     112). The largest stack frame is about 1 kB.

   REFERENCES
     [1] DLMF, chapters 19, 20 and 22, dlmf.nist.gov: 19.8 (AGM), 20.2, 20.7, 22.2 (theta functions), 22.20.
     [2] R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions, Numer. Math. 7 (1965) 78-90.
     [3] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [4] L. Cveticanin, Dynamics of Mass Variable System, dissertation; numbers like (307) are its equations.
     [5] DLMF, 23.9 (Laurent series of Weierstrass' function), 22.6 (duplication).

   INDEX
     base/self_check: whether this compiler and this processor compute as varmass needs
       vm_self_check                  Returns 1 if the compiler and the processor compute as varmass needs, else 0

     jacobi/integrals: complete elliptic integrals K and E
       jacobi_K_m1                    K(m), the complete elliptic integral of the first kind, from m1 = 1 - m >= 0
       jacobi_E_m1                    E(m), the complete elliptic integral of the second kind, from m1 = 1 - m >= 0
       jacobi_K                       K(m), the complete elliptic integral of the first kind, for m <= 1
       jacobi_E                       E(m), the complete elliptic integral of the second kind, for m <= 1
       jacobi_kpK                     k' K(m) = sqrt(1 - m) K(m), the left side of equation (307), for m <= 1

     jacobi/functions: the elliptic functions sn, cn, dn and their quotients
       jacobi_sncndn                  sn, cn and dn of the argument u for the parameter m = k^2 <= 1
       jacobi_sncndn_m1               sn, cn and dn for the complementary parameter m1 = 1 - m >= 0
       jacobi_cd                      cd(u | m) = cn/dn
       jacobi_sd                      sd(u | m) = sn/dn
       jacobi_nd                      nd(u | m) = 1/dn
       jacobi_sc                      sc(u | m) = sn/cn
       jacobi_dc                      dc(u | m) = dn/cn
       jacobi_nc                      nc(u | m) = 1/cn
       jacobi_cs                      cs(u | m) = cn/sn
       jacobi_ds                      ds(u | m) = dn/sn
       jacobi_ns                      ns(u | m) = 1/sn
       jacobi_sn                      sn(u | m) alone
       jacobi_cn                      cn(u | m) alone
       jacobi_dn                      dn(u | m) alone

     jacobi/amplitude: the amplitude am, the angle whose sine is sn
       jacobi_am                      Jacobi's amplitude am(u | m) in radians

     jacobi/plans: sn, cn and dn for many arguments and one parameter
       jacobi_plan_init               Prepares a plan for the parameter m = k^2 <= 1
       jacobi_plan_init_m1            Prepares a plan for the complementary parameter m1 = 1 - m >= 0
       jacobi_plan_sncndn             sn, cn and dn of the argument u for the plan's parameter
       jacobi_plan_sncndn_array       sn, cn and dn of the n arguments in the array u, for the plan's parameter

     jacobi/modulus: the parameter m from the quarter period
       jacobi_solve_kpK               The parameter m whose k' K(m) is c, for c >= 0
       jacobi_solve_kpK_m1            The complementary parameter 1 - m of jacobi_solve_kpK, with all its digits
       jacobi_solve_K_m1              The complementary parameter 1 - m of jacobi_solve_K, with all its digits
       jacobi_solve_K                 The parameter m whose quarter period K(m) is c, for c >= 0

     jacobi/means: mean values of cn^2, cn^4 and cn^6 over a period
       jacobi_cn_means                Means of cn^2, cn^4 and cn^6 over a period, for the parameter m <= 1

     jacobi/descending: sn, cn, dn and K by the arithmetic-geometric mean
       jacobi_agm_sncndn              sn, cn and dn by a given number of steps of the arithmetic-geometric mean, for m < 1
       jacobi_agm_K                   K(m) by the arithmetic-geometric mean, for m <= 1 */
#ifndef VARMASS_JACOBI_H
#define VARMASS_JACOBI_H

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
#define VM_INLINE VM_API /* the code is slower than with forced inlining, but the results are the same */
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
   macro of the compiler shows such an option, the headers do not compile. vm_self_check() finds other options and modes
   when the program runs: it computes a few numbers that show whether sums keep their order, whether results are
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
   the middle between two neighbours must be rounded to the one whose last bit is 0. */
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
#define VMI_STORED_DIG 52 /* number of bits that store the mantissa */
#define VMI_BIAS 1023     /* stored exponent of the number 1 */
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

/* Returns the largest power of two that is at most x, for a normal number x > 0. For a smaller x it is VM_MIN. */
VM_API vm_real vmi_power_below(vm_real x)
{
    const vmi_bits mantissa = ((vmi_bits)1 << VMI_STORED_DIG) - 1;
    if (x < VM_MIN) return VM_MIN;
    return vmi_from_bits(vmi_to_bits(x) & ~mantissa);
}

/* Returns x 2^k. The result is rounded at most once if |x| lies between 1/4 and 4 or is 0, or if x 2^(k/2) is a normal
   number. The function multiplies by about 2^(k/2) twice, because 2^k itself may overflow or underflow. */
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

/* Returns (y + y_lo) 2^k for y from 1/2 to 2 and its low word y_lo. The result is rounded once, even if subnormal. */
VM_API vm_real vmi_ldexp_two(vm_real y, vm_real y_lo, int k)
{
    if (k < 1 - VMI_BIAS || (k == 1 - VMI_BIAS && y < 1)) {
        /* A subnormal result has fewer digits than y + y_lo. Adding and subtracting a power of two removes the
           superfluous digits with one rounding. */
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
#define VMI_BITS_OF_1 ((vmi_signed_bits)1023 << 52)
#else
typedef int32_t vmi_signed_bits;
#define VMI_BITS_OF_1 ((vmi_signed_bits)127 << 23)
#endif

#endif
/* base/words.h - products, quotients and roots with two and three times the digits

   Where digits cancel, one vm_real is not enough. A number in two words (vm_two, hi + lo) has twice the digits, a
   number in three words (vmi_three, hi + mid + lo) has three times as many. p is the number of digits of vm_real, 53 or
   24 bits. The error of a product, quotient or root is given relative to the result; that of a sum, relative to its
   larger term.

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

/* The sum a b + c d of two products, within 2 eps of itself, however many digits cancel. No product may underflow. */
VM_API vm_real vmi_sum_of_products(vm_real a, vm_real b, vm_real c, vm_real d)
{
    const vm_two ab = vmi_two_product(a, b), cd = vmi_two_product(c, d);
    const vm_two high = vmi_two_sum(ab.hi, cd.hi), low = vmi_two_sum(ab.lo, cd.lo);
    const vm_two sum = vmi_two_sum(high.hi, low.hi);
    return sum.hi + (sum.lo + (high.lo + low.lo));
}

/* Reduces x >= 0 by the quarter period q > 0. Returns the distance of x from the nearest multiple of q, at most q/2
   apart from rounding, with an error of 2^-(2p) x, and writes the number of this multiple modulo 4 to *quarter.
   For x above 2^(p-1) q the digits of x do not determine its distance from a multiple: then both results are 0. */
VM_API vm_two vmi_reduce(vm_real x, vm_two q, int *quarter)
{
    const vm_real j = VM_FLOOR(x / q.hi + VM_C(0.5));
    const vm_real scale = q.hi > VM_MAX * VM_EPSILON ? VM_EPSILON : 1; /* keeps the product from overflowing */
    vm_two p;
    *quarter = 0;
    if (j == 0) return vmi_two(x, 0);
    if (!(j < 1 / VM_EPSILON)) return vmi_two(0, 0);
    *quarter = (int)(j - 4 * VM_FLOOR(j / 4));
    p = vmi_two_product(j, q.hi * scale);
    p = vmi_two_sum(x * scale - p.hi, -p.lo); /* x scale - p.hi has no rounding error */
    p = vmi_fast_two_sum(p.hi, p.lo - j * (q.lo * scale));
    return vmi_two(p.hi / scale, p.lo / scale);
}

/* Returns x with the second half of its digits set to zero. */
VM_API vm_real vmi_head(vm_real x)
{
    const vmi_bits above = (vmi_bits)1 << ((VM_MANT_DIG + 1) / 2);
    return vmi_from_bits(vmi_to_bits(x) & ~(above - 1));
}

/* The product x y of numbers in two words; the relative error is below 2^-(2p - 4) */
VM_API vm_two vmi_two_times(vm_two x, vm_two y)
{
    vm_two p = vmi_two_product(x.hi, y.hi);
    return vmi_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* The sum x + y of numbers in two words; the error is below 2^-(2p - 4) of the larger term */
VM_API vm_two vmi_two_plus(vm_two x, vm_two y)
{
    vm_two s = vmi_two_sum(x.hi, y.hi);
    return vmi_two_sum(s.hi, s.lo + (x.lo + y.lo));
}

/* The quotient x / y of numbers in two words; the relative error is below 2^-(2p - 4) */
VM_API vm_two vmi_two_over(vm_two x, vm_two y)
{
    vm_real z = vmi_rounded(x.hi / y.hi);
    vm_two p = vmi_two_product(z, y.hi);
    return vmi_two_sum(z, (((x.hi - p.hi) - p.lo) + (x.lo - z * y.lo)) / y.hi);
}

/* The number hi + mid + lo, where each word is below an ulp of the word before it. Each operation on such numbers has
   a relative error below 2^-(3p - 4). */
typedef struct VM_TAG(vmi_three) {
    vm_real hi, mid, lo;
} vmi_three;

/* Returns a + b + c as a number in three words, for |a| >= |b| >= |c|, at least approximately */
VM_API vmi_three vmi_three_words(vm_real a, vm_real b, vm_real c)
{
    const vm_two low = vmi_two_sum(b, c), high = vmi_two_sum(a, low.hi), rest = vmi_two_sum(high.lo, low.lo);
    vmi_three x;
    x.hi = high.hi;
    x.mid = rest.hi;
    x.lo = rest.lo;
    return x;
}

/* The sum x + y of numbers in three words */
VM_API vmi_three vmi_three_plus(vmi_three x, vmi_three y)
{
    const vm_two high = vmi_two_sum(x.hi, y.hi), mid = vmi_two_sum(x.mid, y.mid);
    const vm_two sum = vmi_two_sum(high.lo, mid.hi);
    return vmi_three_words(high.hi, sum.hi, sum.lo + mid.lo + (x.lo + y.lo));
}

/* The product x y of numbers in three words */
VM_API vmi_three vmi_three_times(vmi_three x, vmi_three y)
{
    const vm_two p = vmi_two_product(x.hi, y.hi), a = vmi_two_product(x.hi, y.mid);
    const vm_two b = vmi_two_product(x.mid, y.hi);
    const vm_two sum = vmi_two_sum(a.hi, b.hi), mid = vmi_two_sum(p.lo, sum.hi);
    return vmi_three_words(p.hi, mid.hi,
                           mid.lo + sum.lo + (a.lo + b.lo) + (x.hi * y.lo + x.mid * y.mid + x.lo * y.hi));
}

/* The quotient x / y by long division: each of three steps gives a word of the quotient */
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

/* The fourth power of x */
VM_API vm_real vmi_fourth_power(vm_real x) { return (x * x) * (x * x); }

/* The product of x and a power of two, which is exact */
VM_API vmi_three vmi_three_scaled(vmi_three x, vm_real power)
{
    return vmi_three_words(x.hi * power, x.mid * power, x.lo * power);
}

/* The square root of a: the root of the first word and two corrections by Newton's method, each of which adds a word */
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

/* The number pi/2 in three words */
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

/* Returns a - root^2 without loss of digits, where root is sqrt(a) after rounding. */
VM_API vm_real vmi_root_residual(vm_real a, vm_real root)
{
    const vm_real head = vmi_head(root), tail = root - head;
    return ((a - head * head) - 2 * head * tail) - tail * tail;
}

/* The square root of a + a_lo in two words, where a_lo is below an ulp of a */
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

/* The product of x and a power of two, which is exact */
VM_API vm_two vmi_two_shifted(vm_two x, vm_real power) { return vmi_two(x.hi * power, x.lo * power); }

/* The difference x - y of numbers in two words */
VM_API vm_two vmi_two_minus(vm_two x, vm_two y) { return vmi_two_plus(x, vmi_two(-y.hi, -y.lo)); }

/* The square root of x >= 0. For x below 2^-500 (float 2^-80) the low word of the result is not reliable. */
VM_API vm_two vmi_two_root(vm_two x)
{
    if (x.hi > 0) return vmi_root(x.hi, x.lo);
    return vmi_two(0, 0);
}

/* The number -x */
VM_API vm_two vmi_minus(vm_two x)
{
    x.hi = -x.hi;
    x.lo = -x.lo;
    return x;
}

/* The number x / 2 */
VM_API vm_two vmi_half(vm_two x)
{
    x.hi /= 2;
    x.lo /= 2;
    return x;
}

/* The product of x and a factor of one word */
VM_API vm_two vmi_two_scaled(vm_two x, vm_real factor)
{
    vm_two p = vmi_two_product(x.hi, factor);
    return vmi_fast_two_sum(p.hi, p.lo + x.lo * factor);
}

#endif
/* base/elementary.h - logarithm, exponential, power, sine, cosine and arctangent, with the same bits on every machine

   The C library's functions differ from machine to machine in the last bits. The functions of this file give the same
   bits everywhere: they use only basic operations, which every machine rounds in the same way. The logarithm and the
   exponential are computed in two words, so that a power made from them has all its digits. They branch only where a
   result is subnormal, so that a compiler can vectorise loops over them.

       vm_real y = vmi_exp(VM_C(1.5), 0); // e^1.5

   The tables and polynomials are computed by tests/gen/elementary.py. Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_ELEMENTARY_H
#define VARMASS_BASE_ELEMENTARY_H

#include <stdint.h>

/* Returns a constant for vmi_log, whose variable z is in interval number `row`, 0 to 31. c is a number close to all z
   of this interval. Column 0 is 1/c; columns 1 and 2 are the two words of ln c. The first words of ln c and of ln 2 are
   multiples of 2^-42 (float 2^-16), so that k ln 2 + ln c, formed from the first words for an integer k, has no
   rounding error. */
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

/* Returns ln x in two words for finite x > 0, with a relative error below 2^-64.8 (float 2^-32). Method: x = 2^k z,
   where z lies between 0.708 and 1.417. Let c be a constant close to z and r = z/c - 1; then
   ln x = k ln 2 + ln c + ln(1 + r). The constant 1/c has few digits, so that the square of the first half of r is
   exact. c is 1 where z is within 0.01 of 1. */
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

/* Writes e^(x + x_lo) as 2^k (1 + p + p_lo), |p| < 0.42, and returns p. |x| must be at most 1500 (float 200), and
   |x_lo| at most an ulp of x. 1 + p + p_lo has a relative error below 2^-58 (float 2^-29); for |x| < 0.34, where
   k = 0, p alone is within 0.6 ulp of e^x - 1. Method: x = k ln 2 + r and e^r = 1 + r + r^2/2 + r^3 E(r), where the
   square of the first half of r is exact. */
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

/* Returns e^(x + x_lo) within 0.53 ulp, also where the result is subnormal. x may be any number; |x_lo| is at most an
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

/* Returns the power x^y for x > 0, within 0.6 ulp if x.lo is 0 or |ln x| > 100 eps. */
VM_API vm_real vmi_pow_two(vm_two x, vm_two y)
{
    const vm_real t = x.lo / x.hi;
    vm_two l = vmi_log(x.hi), p;
    l = vmi_fast_two_sum(l.hi, l.lo + (t - t * t / 2));
    p = vmi_two_product(l.hi, y.hi);
    p = vmi_fast_two_sum(p.hi, p.lo + (l.hi * y.lo + l.lo * y.hi));
    return vmi_exp(p.hi, p.lo);
}

/* Returns the angle atan(y/x) for x >= 0 and y >= 0 that are not both 0. Method: an angle above pi/4 (steep) is
   subtracted from pi/2; if the result is above pi/8 (middle), pi/4 is subtracted from it. The angle is then at most
   pi/8, and the polynomial A gives it. */
VM_API vm_real vmi_arctan(vm_real y, vm_real x)
{
    const vmi_three half_pi = vmi_half_pi();
    const int steep = y > x;
    const vm_real low = vmi_smaller(x, y), high = vmi_larger(y, x);
    const int middle = low > VM_C(0.4142135623730950488) * high;
    const vm_real z = middle ? (low - high) / (low + high) : low / high, t = z * z, tt = t * t;
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

/* Computes the sine and the cosine of the angle z, |z| <= 0.79, which is a little more than pi/4. |z.lo| is at most an
   ulp of z.hi. */
VM_INLINE void vmi_sin_cos(vm_two z, vm_real *sine, vm_real *cosine)
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
    *sine = z.hi + (z.hi * t * S + z.lo * w);
    *cosine = w + (((1 - w) - t / 2) + (tt * C - z.hi * z.lo));
}

/* Returns the integer nearest to x, for |x| < 2^15, and 0 if x is NaN. */
VM_INLINE int vmi_nearest(vm_real x)
{
    if (x != x) return 0;
    return (int)(x + VM_COPYSIGN(VM_C(0.5), x));
}

/* The logarithm of x; argument and result are double-word numbers (hi + lo). */
VM_API vm_two vmi_two_log(vm_two x)
{
    const vm_two l = vmi_log(x.hi);
    const vm_real t = x.lo / x.hi;
    return vmi_two_sum(l.hi, l.lo + (t - t * t / 2));
}

/* Computes the sine and the cosine of any angle x in radians. First a multiple of pi/2, where pi/2 has two words, is
   subtracted from |x|. Both results are NaN if x is infinite or NaN. */
VM_API void vmi_sincos(vm_real x, vm_real *sine, vm_real *cosine)
{
    const vmi_three half_pi = vmi_half_pi();
    int quarter;
    vm_real s, c;
    vmi_sin_cos(vmi_reduce(VM_FABS(x), vmi_two(half_pi.hi, half_pi.mid), &quarter), &s, &c);
    if (!VM_IS_FINITE(x)) s = c = VM_NAN;
    *sine = s;
    *cosine = c;
    if (quarter & 1) {
        *sine = c;
        *cosine = s;
    }
    if (quarter & 2) *sine = -*sine;
    if (quarter == 1 || quarter == 2) *cosine = -*cosine;
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
/* jacobi/agm.h - the arithmetic-geometric mean and the quarter period from it

   The numbers a_0 = 1 and b_0 = k' = sqrt(1 - m) are replaced again and again by their arithmetic mean a_1 and their
   geometric mean b_1. Both sequences tend to one limit, agm(1, k'), and the quarter period is K = pi/(2 agm(1, k')).
   The number of right digits doubles in each step. The mean is computed in one word for comparison
   (jacobi/descending.h), and in two and three words to reduce arguments next to a zero of an elliptic function
   (jacobi/reduction.h). p is the number of digits of vm_real.

       vmi_three K = vmi_K_three_words(VM_C(0.7), 0); // K(0.3) with three times the digits

   Equations: DLMF 19.8. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_AGM_H
#define VARMASS_JACOBI_AGM_H

/* Returns 1 if m1 = 1 - m is negative, infinite or NaN, so that no elliptic function has this parameter, else 0. */
VM_API int vmi_refused(vm_real m1) { return !(m1 >= 0) || !VM_IS_FINITE(m1); }

/* The number of pairs a_n, b_n that a vmi_ladder can hold. The smallest m1 > 0, 5e-324, needs 13 of them. */
#define VMI_LADDER 16

/* The numbers a_n and b_n of all steps of the arithmetic-geometric mean. sn, cn and dn are computed from them,
   beginning with the last step and ending with the first. */
typedef struct VM_TAG(vmi_ladder) {
    int n;                                /* index of the last pair a_n, b_n */
    vm_real a[VMI_LADDER], b[VMI_LADDER]; /* a_0 = 1, b_0 = k'; a_(n+1) = (a_n + b_n)/2, b_(n+1) = sqrt(a_n b_n) */
    vm_real c;                            /* c_n = (a_(n-1) - b_(n-1))/2 for the last n */
} vmi_ladder;

/* Computes agm(1, b0) for a finite b0 > 0 in at most `steps` steps. It stops where (c_n/a_n)^2 <= eps/4. This is the
   parameter of the last sn, sn(a_n u), from which vmi_descend computes sn(u). Then sin(a_n u) may replace the last sn:
   they differ by at most eps/60 for |a_n u| <= pi/4. The relative error of the last a_n, as a value of agm(1, b0), is
   at most eps/16. */
VM_API void vmi_agm(vmi_ladder *l, vm_real b0, int steps)
{
    int n = 0;
    l->a[0] = 1;
    l->b[0] = b0;
    do {
        vm_real a = l->a[n], b = l->b[n];
        l->c = (a - b) / 2;
        n++;
        l->a[n] = (a + b) / 2;
        l->b[n] = VM_SQRT(a * b);
    } while (4 * l->c * l->c > VM_EPSILON * l->a[n] * l->a[n] && n < steps && n < VMI_LADDER - 1);
    l->n = n;
}

/* Returns the quarter period K in three words, with a relative error below 2^-(3p - 12), for 1 - m = m1 + m1_lo > 0.
   Plans (jacobi/plans.h) need so many digits, and so does the reduction of an argument next to a multiple of K. */
VM_API vmi_three vmi_K_three_words(vm_real m1, vm_real m1_lo)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON;
    vm_real lift = 1, c; /* lift: a factor that keeps the words of the square root from underflow and overflow */
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

/* Returns agm(1, k') = pi/(2K) in two words, for 1 - m = m1 + m1_lo > 0. The last step is replaced by the series
   agm(s + c, s - c) = s (1 - x/4 - 5 x^2/64 - ...) with x = (c/s)^2, where s is the mean of a_n and b_n and c half
   their difference. The relative error of the result is x eps/8 < 2^-85 (float 2^-41). Where the result serves to
   reduce the argument u, this error changes sn, cn and dn/k' by less than eps/8: their slope is at most max(1, k'). */
VM_API vm_two vmi_agm_two_words(vm_real m1, vm_real m1_lo, vm_real u)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON, last = VM_MANT_DIG > 24 ? VM_C(3e-5) : VM_C(4e-3);
    vm_real lift = 1, slope; /* lift: a factor that keeps the words of the square root from underflow */
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
/* jacobi/integrals.h - complete elliptic integrals K and E

   K(m) = integral from 0 to pi/2 of dx/sqrt(1 - m sin^2 x), E(m) = integral of sqrt(1 - m sin^2 x) dx
   between the same limits. The parameter is m = k^2 <= 1, negative ones included. The forms with suffix _m1 take
   m1 = 1 - m, which keeps its digits where m is close to 1. Between m = -33.5 and m = 0.971 K and E are computed by
   series after one or two steps of the arithmetic-geometric mean, for other m by sums with the logarithm of
   k' = sqrt(1 - m).

       vm_real K = jacobi_K(VM_C(0.5)); // 1.854...

   Equation (307) and DLMF 19. The polynomials are computed by tests/gen/jacobi_coefficients.py. Tests:
   tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_INTEGRALS_H
#define VARMASS_JACOBI_INTEGRALS_H

/* Is 1 if K and E are computed by series for this m1 = 1 - m, and 0 if they are computed by logarithms. */
#define VMI_MIDDLE(m1) ((m1) > VM_C(0.029) && (m1) < VM_C(34.5))

/* Returns ln(4/k') for m1 < 1 and ln(4 k') for m1 > 1 in two words, where k'^2 = m1 + m1_lo. */
VM_API vm_two vmi_log_4(vm_real m1, vm_real m1_lo)
{
#if VM_MANT_DIG > 24
    const vm_real ln4 = VM_C(1.386294361119890572454), ln4_lo = VM_C(4.638093627692599230990e-17);
#else
    const vm_real ln4 = VM_C(1.386294364929199218750), ln4_lo = VM_C(-3.809308599915535757084e-9);
#endif
    const vm_two L = vmi_log(m1);
    const vm_real half = m1 < 1 ? -VM_C(0.5) : VM_C(0.5);
    const vm_two sum = vmi_two_sum(ln4, half * L.hi);
    return vmi_two(sum.hi, sum.lo + (ln4_lo + half * (L.lo + m1_lo / m1)));
}

/* Returns K for 1 - m = c <= 1/2 and l = ln(4/k'), with a relative error of 2^-58 (float 2^-30):
   K = l + c (l - 1)/4 + c^2 (l A(c) - B(c)), where the polynomials A and B were fitted together. */
VM_API vm_two vmi_K_by_log(vm_real c, vm_two l)
{
    const vm_real cc = c * c, head = vmi_head(c), tail = c - head;
    const vm_real less = l.hi - 1, less_head = vmi_head(less), less_tail = less - less_head;
    const vm_two sum = vmi_fast_two_sum(l.hi, head * less_head / 4);
#if VM_MANT_DIG > 24
    const vm_real A01 = VM_C(0.140624999989917426) + c * VM_C(0.0976562379873884279);
    const vm_real A23 = VM_C(0.0747659708874116175) + c * VM_C(0.0604635753570759646);
    const vm_real A45 = VM_C(0.0492978880327891861) + c * VM_C(0.0339442681568997914);
    const vm_real A67 = VM_C(0.012474590931201476) + c * VM_C(6.09741459959139043e-4);
    const vm_real b01 = VM_C(0.164062499943033208) + c * VM_C(0.120442655878206961);
    const vm_real b23 = VM_C(0.0948766696910365165) + c * VM_C(0.0779033129747223191);
    const vm_real b45 = VM_C(0.0624531825687128506) + c * VM_C(0.037162517735165726);
    const vm_real b67 = VM_C(7.51299469689479475e-3) - c * VM_C(1.21456158984582113e-3);
    const vm_real A = (A01 + cc * A23) + cc * cc * ((A45 + cc * A67) - cc * cc * VM_C(1.47954745189517243e-4));
    const vm_real B = (b01 + cc * b23) + cc * cc * (b45 + cc * b67);
#else
    const vm_real A01 = VM_C(0.1406276673) + c * VM_C(0.09707102925);
    const vm_real A = A01 + cc * (VM_C(0.06059887633) + c * VM_C(0.012512994));
    const vm_real B = VM_C(0.1640692502) + c * (VM_C(0.1182833314) + c * VM_C(0.06061541289));
#endif
    const vm_real middle = (head * less_tail + tail * less) / 4 + cc * (l.hi * A - B);
    return vmi_fast_two_sum(sum.hi, sum.lo + (l.lo + middle));
}

/* Returns E - 1 for 1 - m = c <= 1/2 and l = ln(4/k'), with an error of 2^-56 (float 2^-29):
   E - 1 = c (l A(c) - B(c)), where A and B are polynomials. */
VM_API vm_real vmi_E_rest(vm_real c, vm_real l)
{
    const vm_real cc = c * c;
#if VM_MANT_DIG > 24
    const vm_real A01 = VM_C(0.499999999999303724) + c * VM_C(0.187499997923190304);
    const vm_real A23 = VM_C(0.117186821989593418) + c * VM_C(0.0853987891959771678);
    const vm_real A45 = VM_C(0.0661404122824279239) + c * VM_C(0.0462006550177885);
    const vm_real A67 = VM_C(0.0180993698311603043) + c * VM_C(5.73337947036873879e-4);
    const vm_real b01 = VM_C(0.24999999999566927) + c * VM_C(0.203124990160116814);
    const vm_real b23 = VM_C(0.140622372161008674) + c * VM_C(0.106750406049363547);
    const vm_real b45 = VM_C(0.0830562354113903306) + c * VM_C(0.0517296710396015144);
    const vm_real b67 = VM_C(0.0113912385296323967) + c * VM_C(-2.40808484454518293e-3);
    const vm_real A = (A01 + cc * A23) + cc * cc * ((A45 + cc * A67) - cc * cc * VM_C(3.4706602508716508e-4));
    const vm_real B = (b01 + cc * b23) + cc * cc * (b45 + cc * b67);
#else
    const vm_real A23 = VM_C(0.09726078063) + c * VM_C(0.01954176836);
    const vm_real b23 = VM_C(0.09307274967) + c * VM_C(1.615328365e-4);
    const vm_real A = VM_C(0.4999949038) + c * VM_C(0.1864423007) + cc * A23;
    const vm_real B = VM_C(0.2499748766) + c * VM_C(0.1995639652) + cc * b23;
#endif
    return c * (l * A - B);
}

/* Returns the series S(x) in K = pi/(1 + k') (1 + x S(x)), for x = ((1 - k')/(1 + k'))^2 <= 0.0295. The error of x S is
   2^-60 (float 2^-31). A step of the arithmetic-geometric mean replaces k' by 2 sqrt(k')/(1 + k'). One such step makes
   x small enough for every m1 for which VMI_MIDDLE(m1) is 1. */
VM_API vm_real vmi_K_series(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_real xx = x * x;
    const vm_real S01 = VM_C(0.250000000000002276) + x * VM_C(0.140624999998056721);
    const vm_real S23 = VM_C(0.0976562505663747388) + x * VM_C(0.0747679882260262468);
    const vm_real S45 = VM_C(0.0605678939898120217) + x * VM_C(0.0506567294491898287);
    return (S01 + xx * S23) + xx * xx * (S45 + xx * VM_C(0.0486832738964245657));
#else
    return VM_C(0.2500003576) + x * (VM_C(0.1405491382) + x * VM_C(0.1020393297));
#endif
}

/* Returns x S(x), where E = (pi/4) (1 + k') (1 + x S(x)), for x = ((1 - k')/(1 + k'))^2 <= 0.503. The error is
   2^-58.7 (float 2^-32.5). */
VM_API vm_real vmi_E_series(vm_real x)
{
    const vm_real xx = x * x, x4 = xx * xx;
#if VM_MANT_DIG > 24
    const vm_real S01 = VM_C(0.249999999999998501) + x * VM_C(0.015625000000338965);
    const vm_real S23 = VM_C(3.90624997325988814e-3) + x * VM_C(1.52587997709131905e-3);
    const vm_real S45 = VM_C(7.47655087182482977e-4) + x * VM_C(4.20968920831230303e-4);
    const vm_real S67 = VM_C(2.55356931163965744e-4) + x * VM_C(2.04222291722467767e-4);
    const vm_real S89 = VM_C(-6.44253151491566971e-5) + x * VM_C(8.41539381412701858e-4);
    const vm_real SAB = VM_C(-2.23033122391106189e-3) + x * VM_C(5.13605764430626315e-3);
    const vm_real SCD = VM_C(-7.99521933118507375e-3) + x * VM_C(8.6386328798905114e-3);
    const vm_real SEF = VM_C(-5.6395773761986805e-3) + x * VM_C(1.79039420508178429e-3);
    const vm_real low = (S01 + xx * S23) + x4 * (S45 + xx * S67);
    return x * (low + x4 * x4 * ((S89 + xx * SAB) + x4 * (SCD + xx * SEF)));
#else
    const vm_real S23 = VM_C(3.9256569e-3) + x * VM_C(1.379663823e-3);
    const vm_real S45 = VM_C(1.321772113e-3) + x * VM_C(-7.536308258e-4);
    return x * ((VM_C(0.2500000298) + x * VM_C(0.0156237958)) + xx * S23 + x4 * (S45 + xx * VM_C(1.340579358e-3)));
#endif
}

/* Returns K for 1 - m = m1 + m1_lo. Where VMI_MIDDLE(m1) is 1, K comes from two steps of the arithmetic-geometric mean
   and the series: K = 2 pi (1 + x S)/(1 + f)^2 with f^2 = k' and x = ((1 - f)/(1 + f))^4. For m > 0.971 K comes from
   logarithms (vmi_K_by_log), and for m < -33.5 too, since k' K(m) = K(mu) with 1 - mu = 1/(1 - m). */
VM_API vm_real vmi_K(vm_real m1, vm_real m1_lo)
{
    vm_two K, root;
    vm_real quotient;
    if (VMI_MIDDLE(m1)) {
        const vmi_three half_pi = vmi_half_pi();
        const vm_real kp = VM_SQRT(m1), f = VM_SQRT(kp), h = (1 - f) / (1 + f), x = vmi_fourth_power(h);
        const vm_two first = vmi_two_sum(1, kp), sum = vmi_fast_two_sum(first.hi, 2 * f);
        const vm_real start = 4 * half_pi.hi / sum.hi, low = (first.lo + sum.lo) * VM_C(0.1591549430918953358);
        return start + start * (x * vmi_K_series(x) - start * low + half_pi.mid / half_pi.hi);
    }
    if (vmi_refused(m1)) return VM_NAN;
    if (m1 == 0) return VM_INFINITY;
    K = vmi_K_by_log(m1 < 1 ? m1 : 1 / m1, vmi_log_4(m1, m1_lo));
    if (m1 < 1) return K.hi;
    root = vmi_root(m1, m1_lo);
    quotient = K.hi / root.hi;
    return quotient + (K.lo - quotient * root.lo) / root.hi;
}

/* Returns E for 1 - m = m1 + m1_lo. Where VMI_MIDDLE(m1) is 1, E comes from vmi_E_series, for m > 0.971 from
   vmi_E_rest, and for m < -33.5 from E(m) = k' E(mu) with 1 - mu = 1/(1 - m). */
VM_API vm_real vmi_E(vm_real m1, vm_real m1_lo)
{
    vm_two root;
    vm_real rest;
    if (VMI_MIDDLE(m1)) {
        const vmi_three half_pi = vmi_half_pi();
        const vm_real kp = VM_SQRT(m1), k1 = (1 - kp) / (1 + kp);
        const vm_two sum = vmi_two_sum(1, kp);
        const vm_real kp_lo = m1_lo * VM_C(0.09); /* low word of k', m1_lo/(2 k') for m < -15; else negligible */
        const vm_real more = (sum.lo + kp_lo) + sum.hi * vmi_E_series(k1 * k1);
        return half_pi.hi / 2 * sum.hi + (half_pi.hi / 2 * more + half_pi.mid / 2 * sum.hi);
    }
    if (vmi_refused(m1)) return VM_NAN;
    if (m1 == 0) return 1;
    rest = vmi_E_rest(vmi_smaller(m1, 1 / m1), vmi_log_4(m1, m1_lo).hi);
    if (m1 < 1) return 1 + rest;
    root = vmi_root(m1, m1_lo);
    return root.hi + (root.lo + root.hi * rest);
}

/* K(m), the complete elliptic integral of the first kind, from m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_K; m1 keeps its digits where m is close to 1. */
VM_API vm_real jacobi_K_m1(vm_real m1) { return vmi_K(m1, 0); }

/* E(m), the complete elliptic integral of the second kind, from m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_E; m1 keeps its digits where m is close to 1. */
VM_API vm_real jacobi_E_m1(vm_real m1) { return vmi_E(m1, 0); }

/* K(m), the complete elliptic integral of the first kind, for m <= 1: a quarter of the period of sn. The error is at
   most 2 ulp. Returns infinity for m = 1, and NaN for m > 1 and for infinite m. DLMF 19.2.8. */
VM_API vm_real jacobi_K(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_K(m1.hi, m1.lo);
}

/* E(m), the complete elliptic integral of the second kind, for m <= 1. The error is at most 2 ulp. Returns 1 for
   m = 1, and NaN for m > 1 and for infinite m. DLMF 19.2.8. */
VM_API vm_real jacobi_E(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_E(m1.hi, m1.lo);
}

/* k' K(m) = sqrt(1 - m) K(m), the left side of equation (307), for m <= 1.
   It falls from infinity, as m tends to -infinity, to 0 at m = 1. The error is at most 5 ulp. Returns NaN for m > 1
   and for infinite m. */
VM_API vm_real jacobi_kpK(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    if (vmi_refused(m1.hi)) return VM_NAN;
    if (m1.hi == 0) return 0;
    if (m1.hi > 10) return vmi_K_by_log(1 / m1.hi, vmi_log_4(m1.hi, m1.lo)).hi;
    return VM_SQRT(m1.hi) * vmi_K(m1.hi, m1.lo);
}

#endif
/* jacobi/theta.h - Neville's theta functions, from which sn, cn and dn are quotients

   Each of the twelve elliptic functions is a quotient of two of four theta functions: sn = theta_s/theta_n, and so on.
   The four theta functions are computed for an argument v that was reduced to |v| <= K/2, up to a common factor. No
   subtraction loses digits, so that each of them has a small relative error. Near 0 (see VMI_NEAR) they come from the
   Laurent series of cs^2 = (cn/sn)^2 and two duplications; far from 0, where m is near 1 or below -20, from series in a
   nome that is at most 0.003.

   Source: DLMF 20.2, 20.7, 22.6, 23.9. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_THETA_H
#define VARMASS_JACOBI_THETA_H

/* The numbers that the theta functions far from 0 need for one m. vmi_far_prepare computes them. */
typedef struct VM_TAG(vmi_theta_form) {
    vm_real kp, kp_lo; /* k' = sqrt(1 - m) in two words */
    vm_real q;         /* the nome of 1 - m, or of 1/(1 - m) in the reciprocal form */
    vm_real defect;    /* 1 - z/v, where v is the argument and z its phase (see vmi_far_prepare) */
    vm_real f[3], g[2], scale[2]; /* f for P and Q, g for E, scale for theta_s and theta_c: see vmi_far_prepare */
} vmi_theta_form;

/* The three methods: the series near 0; theta functions with the nome of 1 - m, for m near 1; theta functions with
   the nome of 1/(1 - m), for m < -20 */
enum { VMI_NEAR_FORM, VMI_HYPERBOLIC, VMI_RECIPROCAL };

/* The number of terms of a plan's polynomials */
enum { VMI_TERMS = VM_MANT_DIG > 24 ? 10 : 5 };

/* Neville's theta functions times a common factor. Each elliptic function is a quotient of two of them: sn = s/n and so
   on. */
typedef struct VM_TAG(vmi_thetas) {
    vm_real s, c, d, n;
} vmi_thetas;

/* The Laurent series is used if v^2 max(1, 1 - m) is at most this number. For -21.5 < m < 0.955 this holds for all
   |v| <= K/2. */
#define VMI_NEAR VM_C(2.2)

/* Computes the terms c_1, c_2, c_3 of w^2 cs^2(w) = 1 + c_1 + c_2 + ..., where c_k is proportional to w^(2k), from
   theta = w^2 and m1_theta = (1 - m) w^2.
   Since cs^2(w) + (2 - m)/3 is Weierstrass' function of w (DLMF 23.9), for k > 3
     c_k = 3/((2k + 1)(k - 3)) (c_2 c_(k-2) + c_3 c_(k-3) + ... + c_(k-2) c_2) */
VM_INLINE void vmi_laurent(vm_real theta, vm_real m1_theta, vm_real *c)
{
    const vm_real e = theta + m1_theta, product = theta * m1_theta, ee = e * e;
    c[1] = -e * VM_C(0.3333333333333333333);
    c[2] = (ee - 3 * product) * VM_C(0.06666666666666666667);
    c[3] = e * (9 * product - 2 * ee) * VM_C(5.291005291005291005e-3);
}

/* The theta functions near 0, from the series at w = v/4 to the ninth term (float: the fifth) and two duplications.
   Only theta.c and f are computed by subtractions, and both are far from 0. For b/a = sc^2(w), sc = sn/cn, at 2w
     sc^2(2w) = 4 a b (a + b)(a + m1 b)/(a^2 - m1 b^2)^2,
     s : c : d : n = 2 sqrt(a b (a + b)(a + m1 b)) : a^2 - m1 b^2 : a^2 + 2 m1 a b + m1 b^2 : a^2 + 2 a b + m1 b^2. */
VM_INLINE vmi_thetas vmi_theta_near(vm_real v, vm_real m1)
{
    vmi_thetas theta;
    const vm_real w = v / 4, w2 = w * w, r = m1 * w * w; /* m1 * w2 might underflow */
    vm_real c[4], more, a, f, g, b, s, aa, rb;
#if VM_MANT_DIG > 24
    vm_real c22;
#endif
    vmi_laurent(w2, r, c);
#if VM_MANT_DIG > 24
    c22 = c[2] * c[2];
    more = c22 * ((VM_C(0.3333333333333333333) + c22 * VM_C(7.541478129713423831e-3)) +
                  (c[2] * VM_C(0.05128205128205128205) + c[3] * VM_C(0.06060606060606060606))) +
           c[3] * (c[2] * ((VM_C(0.2727272727272727273) + c[3] * VM_C(0.02468120115178938708)) +
                           c22 * VM_C(0.01067353698932646301)) +
                   c[3] * (VM_C(0.07692307692307692308) + c[3] * VM_C(4.048582995951417004e-3)));
#else
    more = c[2] * (c[2] * VM_C(0.3333333333) + c[3] * VM_C(0.2727272727));
#endif
    a = 1 + ((c[1] + (c[2] + c[3])) + more);
    f = a * a - r * w2;
    g = a * ((a + w2) * (a + r)); /* now sc^2(2w) = 4 w^2 g/f^2, which is called b/a below */
    b = 4 * w2 * g;
    s = 4 * r * g;
    a = f * f;
    aa = a * a;
    rb = s * b;
    theta.s = v * (f * VM_SQRT(g * ((a + b) * (a + s))));
    theta.c = aa - rb;
    theta.d = aa + (2 * s * a + rb);
    theta.n = aa + (2 * b * a + rb);
    return theta;
}

/* Prepares the theta functions far from 0. They belong to a small parameter c with the nome q; k is sqrt(1 - c). Their
   argument i z is imaginary, and z is called the phase.
     For m near 1 (the hyperbolic form), c = 1 - m and z = u agm(1, k).
     For m < -20 (the reciprocal form), c = 1/(1 - m) and z = k' u agm(1, k), since sn(u | m) = sd(k' u | m/(m - 1))/k'.
   In both forms c <= 0.05. With X = q cosh 2z, which is at most sqrt(q)/2 = 0.03,
     theta_1, theta_2 ~ sinh z (P - Q), cosh z (P + Q),  P = f0 + f2 X^2,  Q = f1 X,
     theta_3, theta_4 = E + O, E - O,                    E = 1 + (g1 X^2 - g0),  O = 2 X.
   The terms that are left out are below 1e-18. The coefficients f contain the factor by which theta_d and theta_n must
   differ, so that f0 is near 1/2. The factors `scale` are near 1, but in the reciprocal form that of theta_s contains
   1/k'. x is the parameter after one step of the arithmetic-geometric mean from 1 and k. */
VM_API void vmi_far_prepare(vmi_theta_form *t, vm_real m1, vm_real m1_lo)
{
    const vm_real c = vmi_smaller(m1, 1 / m1), root = VM_SQRT(1 - c), fourth = VM_SQRT(root);
    const vm_real half = c / (2 * (1 + root)), k1 = 2 * half / (1 + root), x = k1 * k1;
    vm_two kp = vmi_two(VM_SQRT(m1), 0);
    vm_real q2, q4, q6, even, odd, f0, share;
    if (m1 > 1) kp = vmi_root(m1, m1_lo);
    t->kp = kp.hi;
    t->kp_lo = kp.lo;
    t->q = k1 / 4 * (1 + x * (VM_C(0.25) + x * (VM_C(0.1328125) + x * VM_C(0.087890625))));
    t->defect = half + (1 - half) * (x * (VM_C(0.25) + x * (VM_C(0.078125) + x * VM_C(0.04296875))));
    q2 = t->q * t->q;
    q4 = q2 * q2;
    q6 = q2 * q4;
    even = q2 + q6;
    odd = 2 * t->q + 2 * q4;
    f0 = ((odd - 2 * even) - even * odd) / (2 * (1 + even)); /* the field f[0] minus 1/2 */
    t->f[0] = VM_C(0.5) + f0;
    share = t->f[0] / (1 - even);
    t->f[1] = share * 2 * t->q * (1 - q4);
    t->f[2] = share * 4 * q4;
    t->g[0] = 2 * q4;
    t->g[1] = 4 * q2;
    t->scale[1] = 1 + 2 * half / ((1 + fourth) * fourth);
    t->scale[0] = t->scale[1];
    if (m1 > 1) t->scale[0] = (t->scale[1] - t->scale[1] * kp.lo / kp.hi) / kp.hi;
}

/* For m = 1 a larger argument is replaced by this number, since tanh then rounds to 1 and 1/cosh to 0. */
#define VMI_LONGEST (VM_MANT_DIG > 24 ? VM_C(1400.0) : VM_C(190.0))

/* The theta functions far from 0, for |argument| <= VMI_LONGEST. All four are multiplied by 2 exp(-z), so that sinh z
   becomes 1 - exp(-2z) and cosh z becomes 1 + exp(-2z). */
VM_INLINE vmi_thetas vmi_theta_far(const vmi_theta_form *t, int reciprocal, vm_two argument)
{
    vmi_thetas theta;
    const vm_real tiny = VM_EPSILON * VM_EPSILON; /* a smaller nome changes no result: X <= sqrt(q)/2 < eps */
    const vm_real sign = VM_COPYSIGN((vm_real)1, argument.hi), v = sign * argument.hi, product = v * t->defect;
    const vm_real z = v - product, z_lo = ((v - z) - product) + sign * argument.lo * (1 - t->defect);
    vm_real p, p_lo, power, root, less, e, X, XX, P, Q, E, O, d, n;
    int k;
    p = vmi_exp_core(-z, -z_lo, &k, &p_lo);
    power = vmi_ldexp(1, k);
    root = power + power * p;       /* exp(-z) */
    less = (1 - power) - power * p; /* 1 - exp(-z) */
    e = root * root;
    X = 0;
    if (t->q > tiny) X = t->q * ((e + 1 / e) / 2);
    XX = X * X;
    P = t->f[2] * XX; /* P without its term f[0] */
    Q = t->f[1] * X;
    E = t->g[1] * XX - t->g[0]; /* E without its term 1 */
    O = 2 * X;
    d = root * (1 + (E + O));
    n = (1 + e) * (t->f[0] + (P + Q));
    theta.s = sign * (t->scale[0] * (less * (1 + root) * (t->f[0] + (P - Q))));
    theta.c = t->scale[1] * (root * (1 + (E - O)));
    theta.d = d;
    theta.n = n;
    if (reciprocal) {
        theta.d = n;
        theta.n = d;
    }
    return theta;
}

/* The theta functions far from 0 for a single v and m, without a plan */
VM_API vmi_thetas vmi_theta_far_unprepared(vm_two v, vm_real m1, vm_real m1_lo)
{
    vmi_theta_form t;
    vmi_far_prepare(&t, m1, m1_lo);
    if (m1 > 1) v = vmi_two_times(v, vmi_two(t.kp, t.kp_lo));
    return vmi_theta_far(&t, m1 > 1, v);
}

/* The theta functions at an argument that is larger by the given number of quarter periods. One quarter period turns s,
   c, d, n into c, -k's, k'n, d; two quarter periods change the signs of s and c. Products with 0, 1 and -1 replace a
   branch, which would be mispredicted half the time. */
VM_INLINE vmi_thetas vmi_theta_shift(vmi_thetas theta, vm_real kp, vmi_bits quarters)
{
    const vmi_bits one = vmi_to_bits(1), odd = (vmi_bits)0 - (quarters & 1);
    const vmi_bits sign = (quarters >> 1 & 1) << (sizeof(vm_real) * 8 - 1);
    const vm_real stays = vmi_from_bits((one & ~odd) ^ sign), turns = vmi_from_bits((one & odd) ^ sign);
    const vm_real stay = stays * stays, turn = turns * turns;
    vmi_thetas shifted;
    shifted.s = stays * theta.s + turns * theta.c;
    shifted.c = stays * theta.c - turns * kp * theta.s;
    shifted.d = stay * theta.d + turn * kp * theta.n;
    shifted.n = stay * theta.n + turn * theta.d;
    return shifted;
}

/* sn, cn and dn from the theta functions, where dn is kept between 1 and bound */
VM_INLINE void vmi_theta_ratios(vmi_thetas theta, vm_real bound, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real low = vmi_smaller(bound, 1), high = vmi_larger(bound, 1), per_n = 1 / theta.n;
    *sn = vmi_clamp(theta.s, -theta.n, theta.n) * per_n; /* |sn| <= 1, since n (1/n) rounds to at most 1 */
    *cn = vmi_clamp(theta.c, -theta.n, theta.n) * per_n;
    *dn = vmi_clamp(theta.d * per_n, low, high);
}

#endif
/* jacobi/reduction.h - reduces the argument of an elliptic function by its quarter period

   The argument is written as u = j K + v, where K is the quarter period, j a whole number and |v| at most K/2 apart
   from rounding. v needs a small relative error, because next to a zero of sn the value of sn is nearly v or -v. The
   closer u is to a multiple of K, the more digits of K are needed. Therefore K is used in three forms: as one word with
   corrections, in two words, or in three words.

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_REDUCTION_H
#define VARMASS_JACOBI_REDUCTION_H

/* The product of a piece of K (see vmi_pieces) and a whole number below this limit (2^30, float 2^13) is exact. */
#define VMI_EXACT_QUARTERS (VM_MANT_DIG > 24 ? VM_C(1073741824.0) : VM_C(8192.0))

/* Writes K to `piece` as a sum of three short numbers, the pieces, and a last word. The pieces are so short that their
   products with a whole number below VMI_EXACT_QUARTERS are exact: they are multiples of 2^(e-21), 2^(e-44) and
   2^(e-67), where 2^e <= K < 2^(e+1) (float 2^(e-9), 2^(e-20), 2^(e-31)). */
VM_API void vmi_pieces(vmi_three K, vm_real *piece)
{
    const vmi_bits exponent = vmi_to_bits(K.hi) & ~(((vmi_bits)1 << VMI_STORED_DIG) - 1);
    vm_real large = 3 * VMI_EXACT_QUARTERS * vmi_from_bits(exponent);
    int i;
    for (i = 0; i < 3; i++) {
        const vm_real sum = vmi_rounded(K.hi + large);
        piece[i] = sum - large;
        K = vmi_three_plus(K, vmi_three_words(-piece[i], 0, 0));
        large *= VMI_EXACT_QUARTERS * VM_EPSILON / 2;
    }
    piece[3] = K.hi;
}

/* Returns the sum of the three terms of x in two words. */
VM_INLINE vm_two vmi_two_terms(vmi_three x)
{
    const vm_two sum = vmi_two_sum(x.hi, x.mid);
    return vmi_two_sum(sum.hi, sum.lo + x.lo);
}

/* Returns u minus the nearest multiple j K, as three terms, for 0 <= u < VMI_EXACT_QUARTERS K. The array K comes from
   vmi_pieces, and per_K is 1/K. The last bits of *quarters become those of j. Loops over this function can be
   vectorised. */
VM_INLINE vmi_three vmi_reduce_pieces(vm_real u, const vm_real *K, vm_real per_K, vmi_bits *quarters)
{
    const vm_real shifted = vmi_rounded(u * per_K + 1 / VM_EPSILON), j = shifted - 1 / VM_EPSILON;
    vmi_three rest;
    rest.hi = (u - j * K[0]) - j * K[1]; /* exact: the result is below K and a multiple of eps K/2 */
    rest.mid = -j * K[2];
    rest.lo = -j * K[3];
    *quarters = vmi_to_bits(shifted); /* the last bits of `shifted` are those of j */
    return rest;
}

/* Adding and subtracting this number rounds a number below 6 to a multiple of 2^-23 (float 2^-8). */
#define VMI_REDUCTION_GRID (VM_MANT_DIG > 24 ? VM_C(805306368.0) : VM_C(49152.0))

/* Returns u minus a multiple j K, for 0 < u < 2.5 K, where VMI_MIDDLE(m1) must be 1; kp is k'. The last bits of
   *quarters become those of j. The relative error of the result is at most about eps. A result below u/64 would
   lose digits: then the function returns NaN, and u must be reduced by vmi_reduce_long.
   Method: after two steps of the arithmetic-geometric mean the phase u (1 + f)^2 with f^2 = k' has the quarter period
   2 pi (1 + x S), where x S is small. The first halves (heads) of k' and f are multiples of 2^-23 and 2^-24 (float
   2^-8, 2^-9), so that the squares of these heads, the number (1 + f)^2 formed from them, and its product with the head
   of u are exact. */
VM_INLINE vm_real vmi_reduce_short(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vmi_bits *quarters)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real grid = VMI_REDUCTION_GRID, half_grid = grid / 2;
    const vm_real f = VM_SQRT(kp), kp_head = vmi_rounded(kp + grid) - grid;
    const vm_real f_head = vmi_rounded(f + half_grid) - half_grid;
    const vm_real kp_tail = ((m1 - kp_head * kp_head) + m1_lo) / (kp + kp_head);
    const vm_real f_tail = ((kp_head - f_head * f_head) + kp_tail) * (1 / (f + f_head));
    const vm_real rate_head = (1 + 2 * f_head) + kp_head, rate_tail = 2 * f_tail + kp_tail;
    const vm_real h = (1 - f) / (1 + f), x = vmi_fourth_power(h), S = vmi_K_series(x);
    const vm_real u_head = vmi_head(u), phase = u_head * rate_head;
    const vm_real phase_lo = (u - u_head) * rate_head + u * rate_tail;
    const int second = phase > 6 * half_pi.hi; /* 0 or 1, used in formulas: a branch would often be mispredicted */
    const vm_real j = (vm_real)(4 + 4 * second);
    const vm_real rest = (phase - j * half_pi.hi) + ((phase_lo - j * half_pi.mid) - j * half_pi.hi * x * S);
    *quarters = 0;
    if (phase < 2 * half_pi.hi) return u;
    *quarters = (vmi_bits)(1 + second);
    if (!(VM_FABS(rest) * 64 > phase && phase < 10 * half_pi.hi)) return VM_NAN;
    return rest / (rate_head + rate_tail);
}

/* Returns u minus the nearest multiple j K in two words, for any u > 0 and m1 > 0. The last bits of *quarters become
   those of j. K is used in two words, or in three if u is below 128 K and next to a multiple of K. Where u is so large
   that no digit of the phase is left, the result is 0. */
VM_API vm_two vmi_reduce_long(vm_real u, vm_real m1, vm_real m1_lo, vmi_bits *quarters)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real next = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(8e-6);
    const vm_two rate = vmi_agm_two_words(m1, m1_lo, u);
    const vm_real size = u * rate.hi, count = size * VM_C(0.6366197723675813431);
    const vm_real shifted = vmi_rounded(count + 1 / VM_EPSILON);
    const vm_real j = shifted - 1 / VM_EPSILON;
    vm_two phase, whole, rest, error;
    vm_real v;
    *quarters = 0;
    if (!(count < 1 / VM_EPSILON)) return vmi_two(0, 0);
    *quarters = vmi_to_bits(shifted);
    phase = vmi_two_product(u, rate.hi);
    whole = vmi_two_product(j, half_pi.hi);
    rest = vmi_two_sum(phase.hi - whole.hi, (phase.lo - whole.lo) + (u * rate.lo - j * half_pi.mid));
    if (VM_FABS(rest.hi) > VM_C(0.75) * half_pi.hi) { /* this may happen for u > K/(16 eps), since count is rounded */
        const vm_real side = VM_COPYSIGN((vm_real)1, rest.hi);
        rest = vmi_two_sum(rest.hi - side * half_pi.hi, rest.lo - side * half_pi.mid);
        *quarters += (vmi_bits)(side < 0 ? 3 : 1);
    }
    if (VM_FABS(rest.hi) < size * next && count < 128) {
        vm_real K[4];
        vmi_pieces(vmi_K_three_words(m1, m1_lo), K);
        return vmi_two_terms(vmi_reduce_pieces(u, K, rate.hi / half_pi.hi, quarters));
    }
    v = rest.hi / rate.hi;
    if (VMI_MIDDLE(m1)) return vmi_two(v, 0); /* here |v| < 2, and no caller needs the low word of v */
    error = vmi_two_product(v, rate.hi);
    return vmi_fast_two_sum(v, (((rest.hi - error.hi) - error.lo) + (rest.lo - v * rate.lo)) / rate.hi);
}

/* Returns u >= 0 minus the nearest multiple j K, or NaN if u or m1 is outside the domain of jacobi_sncndn. The low
   word of the result goes to *v_lo, the last bits of j to *quarters. reach is about (2u/K)^2; if reach is below 30,
   u < 2.5 K. */
VM_INLINE vm_real vmi_reduced(vm_real u, vm_real m1, vm_real m1_lo, vm_real reach, vm_real *v_lo,
                              vmi_bits *quarters)
{
    *v_lo = 0;
    if (reach < 30 && VMI_MIDDLE(m1)) {
        const vm_real v = vmi_reduce_short(u, m1, m1_lo, VM_SQRT(m1), quarters);
        if (v == v) return v;
    }
    *quarters = 0;
    if (m1 > 0 && VM_IS_FINITE(m1) && VM_IS_FINITE(u)) {
        const vm_two v = vmi_reduce_long(u, m1, m1_lo, quarters);
        *v_lo = v.lo;
        return v.hi;
    }
    if (m1 != 0) return VM_NAN;
    if (u > VMI_LONGEST) return VMI_LONGEST;
    return u;
}

#endif
/* jacobi/functions.h - the elliptic functions sn, cn, dn and their quotients

   sn(u | m), cn(u | m) and dn(u | m) of Jacobi, for every real argument u and every parameter m = k^2 <= 1, negative
   ones included. sn and cn have the period 4 K(m), dn has 2 K(m). The motions of oscillators with cubic springs and
   of bodies that rotate without torque are written with them. For many u and one m use a plan (jacobi/plans.h).

       vm_real sn, cn, dn;
       jacobi_sncndn(VM_C(1.2), VM_C(0.3), &sn, &cn, &dn);

   Method: u is reduced to |v| <= K/2 by a multiple of K. Near 0 a series is used (vmi_theta_near), far from 0 theta
   functions. Equations: DLMF 22. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_FUNCTIONS_H
#define VARMASS_JACOBI_FUNCTIONS_H

/* The theta functions of u for 1 - m = m1 + m1_lo, each with a small relative error, or NaN outside the domain of
   jacobi_sncndn. dn lies between 1 and *bound. For a small |u| the function computes neither K nor k'. */
VM_INLINE vmi_thetas vmi_thetas_of(vm_real u, vm_real m1, vm_real m1_lo, vm_real *bound)
{
    const vm_real reach = u * u * (VM_C(0.81) * (1 + m1) - VM_C(0.338) * VM_FABS(1 - m1)); /* about (2u/K)^2 */
    vm_real v, v_lo;
    vmi_bits quarters;
    vmi_thetas theta;
    *bound = m1; /* for |u| <= K/2 dn lies between 1 and sqrt(k'), so also between 1 and m1 */
    if (m1 >= 0 && reach <= 1) return vmi_theta_near(u, m1);
    *bound = VM_SQRT(m1);
    v = vmi_reduced(VM_FABS(u), m1, m1_lo, reach, &v_lo, &quarters);
    if (v * v * vmi_larger(m1, 1) > VMI_NEAR) theta = vmi_theta_far_unprepared(vmi_two(v, v_lo), m1, m1_lo);
    else theta = vmi_theta_near(v, m1);
    theta = vmi_theta_shift(theta, *bound, quarters);
    theta.s *= VM_COPYSIGN((vm_real)1, u);
    return theta;
}

/* sn, cn and dn for 1 - m = m1 + m1_lo */
VM_API void vmi_sncndn(vm_real u, vm_real m1, vm_real m1_lo, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_real bound;
    const vmi_thetas theta = vmi_thetas_of(u, m1, m1_lo, &bound);
    vmi_theta_ratios(theta, bound, sn, cn, dn);
    *cn = vmi_clamp(theta.c, -theta.n, theta.n) / theta.n; /* more accurate than the product of theta.c and 1/theta.n */
}

/* sn, cn and dn of the argument u for the parameter m = k^2 <= 1. All are pure numbers. |sn| <= 1, |cn| <= 1, dn lies
   between 1 and sqrt(1 - m). sn is odd in u, cn and dn are even, to the last bit. The error is at most 8 ulp for
   |u| <= 100 K, next to the zeros too, and at most 4 eps times the function's largest value for |u| <= 1e9 (float 1e4).
   The results are NaN for m > 1 and for infinite arguments. For m = 1 sn = tanh u and cn = dn = 1/cosh u, also for
   infinite u. docs/cost.md has the time. DLMF 22. */
VM_API void jacobi_sncndn(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    vmi_sncndn(u, m1.hi, m1.lo, sn, cn, dn);
}

/* sn, cn and dn for the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_sncndn; m1 keeps its digits where m is close to 1. */
VM_API void jacobi_sncndn_m1(vm_real u, vm_real m1, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_sncndn(u, m1, 0, sn, cn, dn);
}

/* Returns the theta function whose name is s, c, d or n. */
VM_API vm_real vmi_theta_named(vmi_thetas t, char name)
{
    if (name == 's') return t.s;
    if (name == 'c') return t.c;
    if (name == 'd') return t.d;
    return t.n;
}

/* The quotient pq = theta_p/theta_q. For m = 1 both theta functions may underflow to the same number: then the quotient
   is 1. */
VM_API vm_real vmi_quotient(vm_real u, vm_real m, char p, char q)
{
    vm_real bound;
    const vm_two m1 = vmi_two_sum(1, -m);
    const vmi_thetas t = vmi_thetas_of(u, m1.hi, m1.lo, &bound);
    const vm_real above = vmi_theta_named(t, p), below = vmi_theta_named(t, q);
    if (above == below) return 1;
    return above / below;
}

/* cd(u | m) = cn/dn.
   The error is at most 8 ulp for |u| <= 100 K; the domain is that of jacobi_sncndn. */
VM_API vm_real jacobi_cd(vm_real u, vm_real m) { return vmi_quotient(u, m, 'c', 'd'); }

/* sd(u | m) = sn/dn.
   The error is at most 8 ulp for |u| <= 100 K; the domain is that of jacobi_sncndn. */
VM_API vm_real jacobi_sd(vm_real u, vm_real m) { return vmi_quotient(u, m, 's', 'd'); }

/* nd(u | m) = 1/dn.
   The error is at most 8 ulp for |u| <= 100 K; the domain is that of jacobi_sncndn. */
VM_API vm_real jacobi_nd(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 'd'); }

/* sc(u | m) = sn/cn.
   It is infinite at odd multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_sc(vm_real u, vm_real m) { return vmi_quotient(u, m, 's', 'c'); }

/* dc(u | m) = dn/cn.
   It is infinite at odd multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_dc(vm_real u, vm_real m) { return vmi_quotient(u, m, 'd', 'c'); }

/* nc(u | m) = 1/cn.
   It is infinite at odd multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_nc(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 'c'); }

/* cs(u | m) = cn/sn.
   It is infinite at even multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_cs(vm_real u, vm_real m) { return vmi_quotient(u, m, 'c', 's'); }

/* ds(u | m) = dn/sn.
   It is infinite at even multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_ds(vm_real u, vm_real m) { return vmi_quotient(u, m, 'd', 's'); }

/* ns(u | m) = 1/sn.
   It is infinite at even multiples of K. The error is at most 8 ulp for |u| <= 100 K; the domain is that of
   jacobi_sncndn. */
VM_API vm_real jacobi_ns(vm_real u, vm_real m) { return vmi_quotient(u, m, 'n', 's'); }

/* sn(u | m) alone.
   Domain and accuracy are those of jacobi_sncndn, which computes all three functions in the same time. */
VM_API vm_real jacobi_sn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return sn;
}

/* cn(u | m) alone.
   Domain and accuracy are those of jacobi_sncndn, which computes all three functions in the same time. */
VM_API vm_real jacobi_cn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return cn;
}

/* dn(u | m) alone.
   Domain and accuracy are those of jacobi_sncndn, which computes all three functions in the same time. */
VM_API vm_real jacobi_dn(vm_real u, vm_real m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn(u, m, &sn, &cn, &dn);
    return dn;
}

#endif
/* jacobi/amplitude.h - the amplitude am, the angle whose sine is sn

       vm_real angle = jacobi_am(VM_C(1.2), VM_C(0.3)); // sin(angle) = sn(1.2 | 0.3)

   Equations: DLMF 22.16. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_AMPLITUDE_H
#define VARMASS_JACOBI_AMPLITUDE_H

/* Jacobi's amplitude am(u | m) in radians: sn = sin am and cn = cos am, for m <= 1. am is odd, continuous and rising
   (apart from errors of 4 ulp), and am(u + 2K) = am(u) + pi. The error is at most 8 ulp for |u| <= 100 K. Returns NaN
   for m > 1 and for infinite arguments. Method: am = j pi + atan(sn/cn), where 2 j K is the multiple of 2 K nearest to
   u. */
VM_API vm_real jacobi_am(vm_real u, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    const vmi_three half_pi = vmi_half_pi();
    vm_real K, turns, j, odd, am, bound;
    vm_two p;
    vmi_thetas theta = vmi_thetas_of(VM_FABS(u), m1.hi, m1.lo, &bound);
    if (theta.n != theta.n) return VM_NAN;
    if (m1.hi == 0) return VM_COPYSIGN(vmi_arctan(theta.s, theta.c), u);
    K = vmi_K(m1.hi, m1.lo);
    turns = VM_FABS(u) / (2 * K);
    j = VM_FLOOR(turns + VM_C(0.5));
    if (!(2 * j < 1 / VM_EPSILON)) return u / K * half_pi.hi;
    odd = j - 2 * VM_FLOOR(j / 2);
    if ((odd > 0) != (theta.c < 0)) { /* next to an odd multiple of K the sign of cn decides which j is right */
        if (turns > j) j += 1;
        else j -= 1;
    }
    am = vmi_arctan(VM_FABS(theta.s), VM_FABS(theta.c));
    if ((theta.s < 0) != (theta.c < 0)) am = -am;
    p = vmi_two_product(j, 2 * half_pi.hi);
    return VM_COPYSIGN(p.hi + (am + (p.lo + j * (2 * half_pi.mid))), u);
}

#endif
/* base/chebyshev.h - lowers the degree of a polynomial with the help of Chebyshev's polynomials

       vm_real c[3] = {1, 1, VM_C(0.5)};
       vmi_remove_highest(c, 2, 0); // 1 + t + t^2/2 is about c[0] + c[1] t for 0 <= t <= 1

   Source: Lanczos, Applied Analysis (1956). Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_CHEBYSHEV_H
#define VARMASS_BASE_CHEBYSHEV_H

/* Removes the highest power of c_0 + c_1 t + ... + c_n t^n by subtracting a multiple of Chebyshev's polynomial of
   degree n for the interval 0 <= t <= 1. The values in this interval change by at most |c_n| 2^(1-2n). Coefficients
   with an index below `lowest` stay as they are. */
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
/* jacobi/plans.h - sn, cn and dn for many arguments and one parameter

   A plan holds what depends on m alone: the quarter period as a sum of short numbers, and polynomials that replace the
   series of jacobi_sncndn. A call with a plan is faster, most of all for arrays, where the compiler vectorises the loop
   (docs/cost.md has the times). A plan is plain data: it may be copied, and it may be a constant in flash.

       jacobi_plan p;
       vm_real sn, cn, dn;
       if (jacobi_plan_init(&p, VM_C(0.3)) == 0) jacobi_plan_sncndn(&p, VM_C(1.2), &sn, &cn, &dn);

   Tests: tests/test_jacobi.c, tests/test_plans.sh. Example: examples/jacobi_plan.c. */
#ifndef VARMASS_JACOBI_PLANS_H
#define VARMASS_JACOBI_PLANS_H

#include <string.h>

/* One parameter m, prepared by jacobi_plan_init. Fields that the form (the method for this m) does not use are 0. */
typedef struct VM_TAG(jacobi_plan) {
    int form;            /* method: VMI_NEAR_FORM uses a and b; VMI_HYPERBOLIC and VMI_RECIPROCAL use theta */
    vm_real m1;          /* complementary parameter 1 - m */
    vm_real K[4], per_K; /* K: quarter period as a sum, see vmi_pieces; per_K: 1/K, or 0 for m = 1 */
    vm_real a[VMI_TERMS], b[VMI_TERMS]; /* coefficients of two polynomials in v^2, for the reduced argument v */
    vmi_theta_form theta;               /* its field kp = k' is set in every form */
} jacobi_plan;

/* The polynomial 1 + c[0] y + c[1] y^2 + ... with VMI_TERMS coefficients c */
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
   polynomial of the same degree. */
VM_API void vmi_shorten(vm_real *c)
{
    int n;
    for (n = VMI_MORE_TERMS; n > VMI_TERMS; n--) vmi_remove_highest(c, n, 1);
}

/* Computes the coefficients p->a of w^2 cs^2(w) and p->b of -theta^2 d(cs^2)/d theta in powers of v^2, where
   cs = cn/sn, w = v/2 and theta = w^2, for arguments |v| <= longest. The constant coefficients are 1 and are not
   stored. */
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

/* Prepares a plan for 1 - m = m1 + m1_lo. Returns 0, or -1 where no elliptic function has this parameter. */
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

/* Prepares a plan for the parameter m = k^2 <= 1. Returns 0, or -1 for m > 1, NaN and infinite m, where the plan
   stays as it was. */
VM_API int jacobi_plan_init(jacobi_plan *p, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_plan_init(p, m1.hi, m1.lo);
}

/* Prepares a plan for the complementary parameter m1 = 1 - m >= 0.
   Domain and result are those of jacobi_plan_init; m1 keeps its digits where m is close to 1. */
VM_API int jacobi_plan_init_m1(jacobi_plan *p, vm_real m1) { return vmi_plan_init(p, m1, 0); }

/* The theta functions near 0, from the plan's two polynomials at w = v/2 and one duplication, which leads from w to v
   (compare vmi_theta_near). theta_s is v times the polynomial p->b, since the derivative of sc^2 is 2 sc nc dc. */
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

/* sn, cn and dn at one u, where |u| = j K + rest and the last bits of `quarters` are those of the integer j. There is
   no branch if the compiler knows the form. */
VM_INLINE void vmi_plan_point(const jacobi_plan *p, int form, vm_real u, vmi_three rest, vmi_bits quarters,
                              vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_thetas theta;
    if (form == VMI_NEAR_FORM) theta = vmi_plan_near(p, (rest.hi + rest.mid) + rest.lo);
    else {
        vm_two v = vmi_two_terms(rest);
        if (form == VMI_RECIPROCAL) {
            const vm_two product = vmi_two_product(v.hi, p->theta.kp);
            v = vmi_fast_two_sum(product.hi, product.lo + (v.hi * p->theta.kp_lo + v.lo * p->theta.kp));
        }
        v.hi = vmi_smaller(vmi_larger(v.hi, -VMI_LONGEST), VMI_LONGEST); /* a NaN is lost in v.hi, but not in v.lo */
        theta = vmi_theta_far(&p->theta, form == VMI_RECIPROCAL, v);
    }
    theta = vmi_theta_shift(theta, p->theta.kp, quarters);
    theta.s *= VM_COPYSIGN((vm_real)1, u);
    vmi_theta_ratios(theta, p->theta.kp, sn, cn, dn);
}

/* Returns u minus the nearest multiple j K, for a u that is too large for vmi_reduce_pieces. The last bits of *quarters
   become those of j. For m = 1 returns the smaller of u and VMI_LONGEST. */
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

/* sn, cn and dn of the argument u for the plan's parameter.
   u may be any number; the accuracy is that of jacobi_sncndn. The results are NaN for infinite u, unless m = 1.
   docs/cost.md has the time. */
VM_API void jacobi_plan_sncndn(const jacobi_plan *p, vm_real u, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real x = VM_FABS(u);
    vmi_bits quarters;
    vmi_three v;
    if (x * p->per_K < VMI_EXACT_QUARTERS) v = vmi_reduce_pieces(x, p->K, p->per_K, &quarters);
    else v = vmi_plan_reduce_long(p, x, &quarters);
    if (p->form == VMI_NEAR_FORM) {
        vmi_plan_point(p, VMI_NEAR_FORM, u, v, quarters, sn, cn, dn);
        return;
    }
    vmi_plan_point(p, p->form, u, v, quarters, sn, cn, dn);
    if (*sn == 0) { /* then cn is exactly 1 or -1, and dn is 1 */
        *cn = VM_COPYSIGN((vm_real)1, *cn);
        *dn = 1;
    }
}

/* sn, cn and dn of n arguments, each with |u| < VMI_EXACT_QUARTERS K, in a loop that compilers can vectorise */
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
        if (sn[i] == 0) { /* then cn is exactly 1 or -1, and dn is 1 */
            cn[i] = VM_COPYSIGN((vm_real)1, cn[i]);
            dn[i] = 1;
        }
}

/* sn, cn and dn of the n arguments in the array u, for the plan's parameter. The arrays sn, cn, dn have n elements each
   and overlap neither each other nor u. The values are those of jacobi_plan_sncndn; where the compiler fuses
   multiplications and additions, the last bits may depend on the index in the array. docs/cost.md has the time. */
VM_API void jacobi_plan_sncndn_array(const jacobi_plan *p, int n, const vm_real *u, vm_real *sn, vm_real *cn,
                                     vm_real *dn)
{
    const jacobi_plan local = *p; /* the compiler can see that the arrays do not overlap this copy */
    int i, any_far = 0;
    for (i = 0; i < n; i++) any_far |= !(VM_FABS(u[i]) * local.per_K < VMI_EXACT_QUARTERS);
    if (any_far)
        for (i = 0; i < n; i++) jacobi_plan_sncndn(p, u[i], sn + i, cn + i, dn + i);
    else if (local.form == VMI_NEAR_FORM) vmi_plan_loop(&local, VMI_NEAR_FORM, n, u, sn, cn, dn);
    else if (local.form == VMI_HYPERBOLIC) vmi_plan_loop(&local, VMI_HYPERBOLIC, n, u, sn, cn, dn);
    else vmi_plan_loop(&local, VMI_RECIPROCAL, n, u, sn, cn, dn);
}

#endif
/* jacobi/modulus.h - the parameter m from the quarter period

   The functions solve K(m) = c and k' K(m) = c for m. The second equation is (307), which gives the Jacobi function
   whose period is that of a strongly nonlinear oscillator. Each equation has one solution for every c > 0.

       vm_real m = jacobi_solve_kpK(VM_C(1.2)); // sqrt(1 - m) K(m) = 1.2

   Method: Newton's method for the logarithm of the nome; for c between K(-1) and K(1/2) a fixed-point iteration for
   the nome itself. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_MODULUS_H
#define VARMASS_JACOBI_MODULUS_H

/* Returns (1 - R)/q for |q| <= 0.1, where m = 16 q R is the parameter with the nome q, and
   R = (theta_2(q)/(2 q^(1/4) theta_3(q)))^4. No digits are lost for small q. Method: for
   b = R^(1/4) = (1 + q^2 + q^6 + q^12)/theta_3 the quotient (1 - b)/q is
   (2 - q + 2 q^3 - q^5 + 2 q^8 - q^11)/theta_3. */
VM_API vm_real vmi_theta_loss(vm_real q)
{
    const vm_real y = q * q, y2 = y * y, theta3 = 1 + 2 * (q + y2 * (1 + y2 * q));
    const vm_real rho = (2 - q + q * y * (2 - y) + y2 * y2 * (2 - q * y)) / theta3, b = 1 - q * rho;
    return rho * ((1 + b) * (1 + b * b));
}

/* A parameter m, given by a nome q */
typedef struct VM_TAG(vmi_solution) {
    int circular;        /* 1 if q is the nome of m, else 0 */
    int upside;          /* used if circular is 0: 0 if q is the nome of 1 - m, 1 if q is the nome of 1/(1 - m) */
    vm_real q, L, L_lo;  /* the nome q, which is exp(-L - L_lo) if circular is 0 */
} vmi_solution;

/* Returns the nome q with theta_4(q)^2 = 2 c/pi, for c between K(-1) and K(1/2). q is the nome of the m that solves
   k' K = c, and -q is the nome of the m that solves K = c. */
VM_API vm_real vmi_solve_middle(vm_real c)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real less = ((half_pi.hi - c) + half_pi.mid) / half_pi.hi; /* less = 1 - theta_4(q)^2 */
    const vm_real start = less / (2 * (1 + VM_SQRT(1 - less)));         /* (1 - theta_4(q))/2 = q - q^4 + q^9 */
    vm_real q = start;
    int i;
    for (i = 0; i < 6; i++) /* each step gains about 3 digits of q */
        q = start + vmi_fourth_power(q) * (1 - vmi_fourth_power(q) * q);
    return q;
}

/* After a step of Newton's method that is shorter than this number, the error is below eps. */
#define VMI_SMALL_STEP (VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(2e-5))

/* Finds s->L = -ln q from K = L theta_3(q)^2/2 = c, for c >= K(1/2). The unknown of Newton's method is
   lambda = 2c - L = 2c (1 - theta_3^-2), between 0 and 0.57. The method starts at lambda = 0 and needs at most seven
   steps. */
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

/* Returns ln(1 + x) for 0 <= x < 0.0019, by its series. */
VM_API vm_real vmi_small_log(vm_real x)
{
    return x - x * x * (VM_C(0.5) - x * (VM_C(0.3333333333333333333) - x * (VM_C(0.25) - x * VM_C(0.2))));
}

/* Finds s->L = -ln q from k' K = 2 L sqrt(q) (1 + q^2 + q^6)^2 = c, for 0 < c <= K(-1). Newton's method solves
     L/2 - ln L - 2 ln(1 + q^2 + q^6) = ln(2/c),
   whose left side is a convex, rising function of L. The method starts above the solution and needs at most seven
   steps. The residual is computed in two words. */
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

/* Returns the parameter m with K(m) = c if inverse_of_K is 1, and with k' K(m) = c if it is 0, for c > 0. Both
   equations are one problem, since k' K(m) is K(m/(m - 1)). For c > 1000 the number 1 - m underflows to 0 or overflows
   (in float for much smaller c too), so that every such c gives the result of c = 1000. */
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

/* Returns 1 - m of the solution. 16 q and 1/(16 q) are computed as exponentials of -L, since q may underflow where
   16 q does not. */
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

/* Returns m of the solution. */
VM_API vm_real vmi_solution_m(const vmi_solution *s)
{
    if (s->circular) return 16 * s->q * (1 - s->q * vmi_theta_loss(s->q));
    return 1 - vmi_solution_m1(s);
}

/* The parameter m whose k' K(m) is c, for c >= 0: solves equation (307). m is negative for c > pi/2, and 1 for c = 0.
   The error is at most 4 ulp plus the change of m that one ulp of c makes. Returns NaN for c < 0 and infinite c. */
VM_API vm_real jacobi_solve_kpK(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return 1;
    s = vmi_solve_parameter(c, 0);
    return vmi_solution_m(&s);
}

/* The complementary parameter 1 - m of jacobi_solve_kpK, with all its digits. The error is at most 4 ulp plus the
   change of 1 - m that one ulp of c makes. Returns NaN for c < 0 and infinite c. */
VM_API vm_real jacobi_solve_kpK_m1(vm_real c)
{
    vmi_solution s;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    if (c == 0) return 0;
    s = vmi_solve_parameter(c, 0);
    return vmi_solution_m1(&s);
}

/* The complementary parameter 1 - m of jacobi_solve_K, with all its digits. Returns infinity for c = 0, and NaN for
   c < 0 and infinite c. */
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
/* jacobi/means.h - mean values of cn^2, cn^4 and cn^6 over a period

   Averaged equations of oscillators with a cubic spring need these means: equations (383), (384), (408). C2, C4 and
   C6 are the means of cn^2, cn^4 and cn^6.

       vm_real C2, C4, C6;
       jacobi_cn_means(VM_C(0.5), &C2, &C4, &C6);

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_MEANS_H
#define VARMASS_JACOBI_MEANS_H

/* Computes the means from the nome q of m, for |q| <= 0.1. The recurrences (384) and (408) would divide 0 by 0 at
   m = 0. In this form m is cancelled from both, by means of two series S and R in q: 1/2 - C2 = q S and m = 16 q R. */
VM_API void vmi_means_from_nome(vm_real q, vm_real *C2, vm_real *C4, vm_real *C6)
{
    const vm_real y = q * q, loss = vmi_theta_loss(q), R = 1 - q * loss;
    const vm_real low = -2 + y * (6 + y * (-16 + 37 * y));
    const vm_real high = -78 + y * (158 + y * (-312 + y * (594 - 1090 * y)));
    const vm_real series = low + (y * y) * (y * y) * high;             /* (S - 1)/q^2 */
    const vm_real S = 1 + y * series, d = q * S, delta = S / (16 * R); /* delta = d/m */
    const vm_real eta = (loss + q * series) / (256 * R * R);           /* eta = (delta - 1/16)/m */
    *C2 = VM_C(0.5) - d;
    *C4 = (1 - 4 * d + 2 * delta) / 3;
    *C6 = ((7 * delta - 8 * eta) / 3 + 8 * *C4 - VM_C(1.5) + 3 * d) / 5;
}

/* Returns C2 by (383) from K and E, for 1 - m = c <= 1/2 and l = ln(4/k'): C2 = (E/K - c)/m. E/K is a sum of two words
   here, because for m near 4/5 an error of C2 is doubled in the mean of sn^6. */
VM_API vm_real vmi_mean_from_K(vm_real c, vm_two l)
{
    const vm_two K = vmi_K_by_log(c, l);
    const vm_real rest = vmi_E_rest(c, l.hi), ratio = (1 + rest) / K.hi;
    const vm_two product = vmi_two_product(ratio, K.hi);
    const vm_real ratio_lo = ((1 - product.hi) + (rest - (product.lo + ratio * K.lo))) / K.hi;
    return ((ratio - c) + ratio_lo) / (1 - c);
}

/* Means of cn^2, cn^4 and cn^6 over a period, for the parameter m <= 1. The errors are at most 8 ulp. The means are 0
   for m = 1, where the period is infinite, and NaN for m > 1 and infinite m. Equations (383), (384), (408).
   Outside -4 <= m <= 1/2 the recurrences (384) and (408) are solved for the means of sn^2 cn^2 and sn^2 cn^4. These
   are small, and the others are sums of few of them, so that little is lost to rounding. */
VM_API void jacobi_cn_means(vm_real m, vm_real *C2, vm_real *C4, vm_real *C6)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    *C2 = *C4 = *C6 = VM_NAN;
    if (vmi_refused(m1.hi)) return;
    *C2 = *C4 = *C6 = 0;
    if (m1.hi == 0) return;
    if (m1.hi >= VM_C(0.5) && m1.hi <= 5) {
        const vm_real root = VM_SQRT(m1.hi), fourth = VM_SQRT(root);
        const vm_real e = m / (2 * (1 + root) * ((1 + fourth) * (1 + fourth))), e4 = vmi_fourth_power(e);
        vmi_means_from_nome(e * (1 + e4 * (2 + e4 * (15 + e4 * (150 + e4 * (1707 + e4 * 20910))))), C2, C4, C6);
    } else {
        /* For m < 0, cn(u | m) = cd(k' u | m/(m - 1)) with k' = sqrt(1 - m). cd has the same means as sn. The mean of
           sn^2 is 1 - C2. */
        const vm_real second = vmi_mean_from_K(vmi_smaller(m1.hi, 1 / m1.hi), vmi_log_4(m1.hi, m1.lo));
        vm_real ratio = m1.hi / m, s2c2, s2c4, fourth; /* ratio is (1 - M)/M for M = m or, if m < 0, M = m/(m - 1) */
        if (m < 0) ratio = -1 / m;
        s2c2 = (second - ratio * (1 - 2 * second)) / 3;
        fourth = second - s2c2;
        s2c4 = (fourth - ratio * (3 * second - 4 * fourth)) / 5;
        *C2 = second;
        *C4 = fourth;
        *C6 = fourth - s2c4;
        if (m < 0) {
            *C2 = 1 - second;
            *C4 = 1 - (second + s2c2);
            *C6 = 1 - (second + (2 * s2c2 - s2c4));
        }
    }
}

#endif
/* jacobi/descending.h - sn, cn, dn and K by the arithmetic-geometric mean

   In this classical method the number of steps shows what accuracy costs. It serves for comparison and teaching:
   jacobi_sncndn is faster and more accurate.

       vm_real sn, cn, dn;
       jacobi_agm_sncndn(VM_C(1.2), VM_C(0.3), 3, &sn, &cn, &dn); // with three steps

   Source: DLMF 19.8; Bulirsch, Numer. Math. 7 (1965). Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_DESCENDING_H
#define VARMASS_JACOBI_DESCENDING_H

/* Goes back through the steps of the arithmetic-geometric mean by Gauss' transformation, beginning with the sine and
   cosine of the phase a_n u. The results s, c, d, q give sn = s/q, cn = c/q and dn = d/q. The step back from n + 1 to n
   turns s, c, d, q into
     s' = (a/a+) s q,  c' = c d,  d' = c^2 + (b/a+) s^2,  q' = c^2 + (a/a+) s^2     with a = a_n, b = b_n, a+ = a_(n+1).
   No subtraction occurs, not even for m < 0. */
VM_API void vmi_descend(const vmi_ladder *l, vm_real phase, vm_real *s, vm_real *c, vm_real *d, vm_real *q)
{
    int n;
    vmi_sin_cos(vmi_two(phase, 0), s, c);
    *d = *q = 1;
    for (n = l->n - 1; n >= 0; n--) {
        const vm_real ra = l->a[n] / l->a[n + 1], rb = l->b[n] / l->a[n + 1];
        const vm_real ss = *s * *s, cc = *c * *c;
        *s *= ra * *q;
        *c *= *d;
        *d = cc + rb * ss;
        *q = cc + ra * ss;
    }
}

/* sn, cn and dn by a given number of steps of the arithmetic-geometric mean, for m < 1. Fewer steps (at least one) cost
   less and are less accurate. With steps >= 15 the function takes as many steps as the type needs; the error is then at
   most 3 eps M (1 + M |u|) with M = max(1, k') for |u| <= 5K. The error grows with |u|, since the phase a_n u is
   reduced by pi/2, instead of u by K. The results are NaN for m >= 1 and for infinite arguments. */
VM_API void jacobi_agm_sncndn(vm_real u, vm_real m, int steps, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real kp = VM_SQRT(1 - m);
    vm_real s, c, d, q, phase;
    vmi_ladder l;
    int quarter;
    *sn = *cn = *dn = VM_NAN;
    if (!(m < 1) || !VM_IS_FINITE(m) || !VM_IS_FINITE(u)) return;
    vmi_agm(&l, kp, steps);
    phase = vmi_reduce(l.a[l.n] * VM_FABS(u), vmi_two(half_pi.hi, half_pi.mid), &quarter).hi;
    vmi_descend(&l, phase, &s, &c, &d, &q);
    if (quarter & 1) {
        *sn = c / d;
        *cn = -kp * s / d;
        *dn = kp * q / d;
    } else {
        *sn = s / q;
        *cn = c / q;
        *dn = d / q;
    }
    if (quarter & 2) {
        *sn = -*sn;
        *cn = -*cn;
    }
    *sn *= VM_COPYSIGN((vm_real)1, u);
}

/* K(m) by the arithmetic-geometric mean, for m <= 1.
   The error is at most 6 ulp. Returns infinity for m = 1, and NaN for m > 1 and infinite m. */
VM_API vm_real jacobi_agm_K(vm_real m)
{
    vmi_ladder l;
    if (!(m <= 1) || !VM_IS_FINITE(m)) return VM_NAN;
    if (m == 1) return VM_INFINITY;
    vmi_agm(&l, VM_SQRT(1 - m), VMI_LADDER);
    return VM_PI / 2 / l.a[l.n];
}

#endif
/* jacobi/third_kind.h - elliptic integrals of the third kind, theta functions of complex argument

   The attitude of a body that rotates without torque needs, besides sn, cn and dn, the complete integral of the third
   kind Pi(-N | m) and theta functions of a complex argument. Both are computed here in two words, so that the
   attitude stays right after a million turns (mechanics/torque_free.h). All functions of this file are internal. p is
   the number of digits of vm_real.

   Source: DLMF 19.8, 19.36, 20.7. Tests: tests/test_torque_free.c. */
#ifndef VARMASS_JACOBI_THIRD_KIND_H
#define VARMASS_JACOBI_THIRD_KIND_H

/* Carlson's symmetric integral R_F(x, y, z) in two words, for x, y, z >= 0 of which at most one is 0. The arguments
   are brought together by duplications, usually 7, until the series in their differences (DLMF 19.36.1) has an error
   of 2^-(2p - 4). An argument that is 2^-n times the largest needs log2(n) duplications more. */
VM_API vm_two vmi_carlson_rf(vm_two x, vm_two y, vm_two z)
{
    const vm_real enough = VM_SQRT(VM_SQRT(VM_EPSILON));
    vm_two A, X, Y, Z, E2, E3, sum;
    vm_real e2, e3, rest;
    for (;;) {
        A = vmi_two_over(vmi_two_plus(vmi_two_plus(x, y), z), vmi_two(3, 0));
        X = vmi_two_over(vmi_two_minus(A, x), A);
        Y = vmi_two_over(vmi_two_minus(A, y), A);
        Z = vmi_two_shifted(vmi_two_plus(X, Y), -1);
        if (!(VM_FABS(X.hi) > enough || VM_FABS(Y.hi) > enough || VM_FABS(Z.hi) > enough)) break;
        X = vmi_two_root(x);
        Y = vmi_two_root(y);
        Z = vmi_two_root(z);
        A = vmi_two_plus(vmi_two_times(X, vmi_two_plus(Y, Z)), vmi_two_times(Y, Z));
        x = vmi_two_shifted(vmi_two_plus(x, A), VM_C(0.25));
        y = vmi_two_shifted(vmi_two_plus(y, A), VM_C(0.25));
        z = vmi_two_shifted(vmi_two_plus(z, A), VM_C(0.25));
    }
    E2 = vmi_two_times(X, Y);
    E3 = vmi_two_times(E2, Z);
    E2 = vmi_two_minus(E2, vmi_two_times(Z, Z));
    e2 = E2.hi;
    e3 = E3.hi;
    rest = e2 * e2 * (VM_C(1.0) / 24 - VM_C(5.0) / 208 * e2 + e3 / 16) +
           e3 * (VM_C(3.0) / 104 * e3 - VM_C(3.0) / 44 * e2);
    sum = vmi_two_minus(vmi_two_over(E3, vmi_two(14, 0)), vmi_two_over(E2, vmi_two(10, 0)));
    sum = vmi_two_plus(vmi_two(1, 0), vmi_two_plus(sum, vmi_two(rest, 0)));
    return vmi_two_over(sum, vmi_two_root(A));
}

/* The complete integral of the third kind, Pi(-N | m), as its quotient with K(m) */
typedef struct VM_TAG(vmi_third_kind) {
    vm_two mean;  /* agm(1, k') = pi/(2K) */
    vm_two ratio; /* Pi(-N | m)/K(m) */
    vm_two rest;  /* 1 - Pi(-N | m)/K(m) */
} vmi_third_kind;

/* The complete integral of the third kind for m1 = 1 - m > 0 and N >= 0, where share = N/(1 + N) and
   below = 1/(1 + N). With p = sqrt(1 + N) and the numbers a, g of the arithmetic-geometric mean (DLMF 19.8.6-7),
   starting with Q = 1, each step is
     e = (p^2 - a g)/(p^2 + a g),  p+ = (p^2 + a g)/(2p),  Q+ = Q e/2,  1 - Pi/K = share sum Q/2.
   Since sum Q = 2 - sum Q (1 - e), both ratio = Pi/K and rest = 1 - Pi/K are sums of positive terms. Therefore they are
   accurate for any N. */
VM_API vmi_third_kind vmi_third_kind_ladder(vm_two m1, vm_two share, vm_two below)
{
    vm_two a = vmi_two(1, 0), g = vmi_two_root(m1), p = vmi_two_root(vmi_two_over(a, below)), Q = a, ag, pp, above;
    vm_two sum = vmi_two(0, 0), less = sum;
    vmi_third_kind result;
    int step;
    for (step = 0; step < 200; step++) { /* 5 to 10 steps, and one for each binary digit of sqrt(1 + N) */
        const vm_real apart = VM_FABS(a.hi - g.hi);
        ag = vmi_two_times(a, g);
        pp = vmi_two_times(p, p);
        above = vmi_two_plus(pp, ag);
        sum = vmi_two_plus(sum, Q);
        less = vmi_two_plus(less, vmi_two_times(Q, vmi_two_over(vmi_two_shifted(ag, 2), above)));
        Q = vmi_two_shifted(vmi_two_times(Q, vmi_two_over(vmi_two_minus(pp, ag), above)), VM_C(0.5));
        p = vmi_two_over(above, vmi_two_shifted(p, 2));
        a = vmi_two_shifted(vmi_two_plus(a, g), VM_C(0.5));
        g = vmi_two_root(ag);
        if (!(apart > VM_EPSILON * a.hi) && !(VM_FABS(Q.hi) > VM_EPSILON * VM_EPSILON / 4 * less.hi)) break;
    }
    result.mean = a;
    share = vmi_two_shifted(share, VM_C(0.5));
    result.ratio = vmi_two_plus(below, vmi_two_times(share, less));
    result.rest = vmi_two_times(share, sum);
    return result;
}

/* The sine and the cosine of the angle of x turns, 2 pi x, for |x| < 2^13 */
VM_API void vmi_sincos_turns(vm_real x, vm_real *sine, vm_real *cosine)
{
    const vmi_three half_pi = vmi_half_pi();
    const int j = vmi_nearest(4 * x), quarter = j & 3;
    const vm_real rest = 4 * x - (vm_real)j;
    vm_two z = vmi_two_product(rest, half_pi.hi);
    vm_real s, c;
    z.lo += rest * half_pi.mid;
    vmi_sin_cos(z, &s, &c);
    *sine = s;
    *cosine = c;
    if (quarter & 1) {
        *sine = c;
        *cosine = s;
    }
    if (quarter & 2) *sine = -*sine;
    if (quarter == 1 || quarter == 2) *cosine = -*cosine;
}

/* The complex number theta_4(z + i zy), up to a real factor. z is pi u/(2K), and zy is pi y/(2K) with 0 <= y < K',
   where K' is K(1 - m). The nome is Q = q^2 (doubled lattice), where q is the nome of m. The angle of this number is
   the periodic part of the angle by which a torque-free body turns. There are two forms.
   The direct form is used for K <= 2K', so that Q <= exp(-pi):
     1 + sum over n >= 1 of (-1)^n (C_n cos 2nz - i S_n sin 2nz),
     C_n, S_n = e^(-(pi n/K)(2nK' - y)) +- e^(-(pi n/K)(2nK' + y)), with + for C_n and - for S_n.
   The transformed form, the theta series after Jacobi's imaginary transformation, is used for larger K. With
   Qd = exp(-pi K/(2K')) < exp(-pi), v = (2n + 1) pi/(4K') and |u| <= K it is
     e^(-i pi u y/(4KK')) times the sum over n >= 0 of
     Qd^(n(n+1)) (cosh vu cos vy + i sinh vu sin vy) e^(-pi |u|/(4K')).
   In both forms four terms leave an error of 1e-19. The sums are stored as polynomials: in cos 2z in the direct form,
   in exp(+-pi |u|/(2K')) in the transformed form. */
typedef struct VM_TAG(vmi_doubled_theta) {
    vm_real decay; /* in the transformed form exp(-pi |u|/(2K')) = exp(-decay |x|), where x = u/(4K); decay = 0 means
                      that the fields hold the direct form, the Fourier series in cos 2nz and sin 2nz */
    vm_real shift; /* the angle of the factor e^(-i pi u y/(4KK')) is shift x turns, where x = u/(4K) */
    vm_real Q;     /* Qd = exp(-pi K/(2K')), the nome of the transformed form; 0 in the direct form */
    vm_real re[4], im[4]; /* coefficients of the two polynomials, for the real and the imaginary part */
} vmi_doubled_theta;

/* Prepares the direct form of theta_4, its Fourier series in cos 2nz and sin 2nz, z = pi u/(2K). Kc is
   K' = K(1 - m). */
VM_API vmi_doubled_theta vmi_doubled_direct(vm_real K, vm_real Kc, vm_real y)
{
    vmi_doubled_theta d;
    vm_real C[4], S[4];
    int n;
    for (n = 1; n < 4; n++) {
        const vm_real rate = (vm_real)n * VM_PI / K, more = vmi_exp(-rate * (2 * (vm_real)n * Kc - y), 0);
        const vm_real less = vmi_exp(-rate * (2 * (vm_real)n * Kc + y), 0);
        C[n] = more + less;
        S[n] = more - less;
    }
    d.decay = d.shift = d.Q = 0;
    d.re[0] = 1 - C[2];
    d.re[1] = 3 * C[3] - C[1];
    d.re[2] = 2 * C[2];
    d.re[3] = -4 * C[3];
    d.im[0] = S[1] - S[3];
    d.im[1] = -2 * S[2];
    d.im[2] = 4 * S[3];
    d.im[3] = 0;
    return d;
}

/* Prepares the transformed form of theta_4, the theta series after Jacobi's imaginary transformation. Kc is
   K' = K(1 - m). K may be infinite: then the argument x of vmi_doubled_at is u itself, not u/(4K). */
VM_API vmi_doubled_theta vmi_doubled_dual(vm_real K, vm_real Kc, vm_real y)
{
    const int aperiodic = !VM_IS_FINITE(K);
    vmi_doubled_theta d;
    vm_real power = 1, exponent = VMI_LONGEST, sine, cosine;
    int n;
    d.Q = d.shift = 0;
    d.decay = 1;
    if (!aperiodic) {
        d.Q = vmi_exp(-VM_PI * K / (2 * Kc), 0);
        d.decay = 2 * VM_PI * K / Kc;
        d.shift = -y / (2 * Kc);
    }
    if (d.Q > 0) exponent = VM_PI * K / (2 * Kc);
    for (n = 0; n < 4; n++) {
        vmi_sincos_turns((vm_real)(2 * n + 1) * y / (8 * Kc), &sine, &cosine);
        d.re[n] = power * cosine; /* power is Qd^(n^2) */
        d.im[n] = power * sine;
        power *= vmi_exp(-(vm_real)(2 * n + 1) * exponent, 0);
    }
    return d;
}

/* The polynomial a[0] + a[1] x + a[2] x^2 + a[3] x^3 */
VM_INLINE vm_real vmi_cubic(const vm_real *a, vm_real x) { return (a[0] + a[1] * x) + (a[2] + a[3] * x) * (x * x); }

/* The theta function theta_4 at x = u/(4K), |x| <= 1/4, without the factor e^(2 pi i shift x), which the caller
   applies */
VM_API void vmi_doubled_at(const vmi_doubled_theta *d, vm_real x, vm_real *re, vm_real *im)
{
    if (d->decay > 0) {
        const vm_real g = vmi_exp(-d->decay * VM_FABS(x), 0), f = d->Q / g, h = d->Q * g;
        const vm_real size = vmi_cubic(d->im, f) - g * vmi_cubic(d->im, h);
        *re = vmi_cubic(d->re, f) + g * vmi_cubic(d->re, h);
        *im = size;
        if (x < 0) *im = -size;
    } else {
        vm_real sine, cosine;
        vmi_sincos_turns(2 * x, &sine, &cosine);
        *re = vmi_cubic(d->re, cosine);
        *im = sine * vmi_cubic(d->im, cosine);
    }
}

#endif

#endif
