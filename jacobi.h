/* jacobi.h - Jacobi's elliptic functions, elliptic integrals, and the modulus from its quarter period

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
     The functions sn(u | m), cn(u | m) and dn(u | m) are defined by an angle phi, the amplitude: u is the integral of
     dx/sqrt(1 - m sin^2 x) from 0 to phi, and sn = sin phi, cn = cos phi, dn = sqrt(1 - m sin^2 phi). K(m) is the same
     integral from 0 to pi/2. sn and cn have the period 4 K(m), dn has the period 2 K(m); K is the quarter period.
     The variable is the first argument, then comes the parameter; the results come last. The parameter is m = k^2, not
     the modulus k: jacobi_K(0.25) is K for k = 1/2. In SciPy, Mathematica and GSL's elljac the argument is m, too; in
     Boost, C++17 and GSL's Kcomp the argument is k. Any m <= 1 is allowed, also a negative m. The complementary
     parameter is m1 = 1 - m, the complementary modulus k' = sqrt(m1). The functions with the suffix _m1 take or return
     m1. Use them where m is close to 1: m1 then has all its digits, while a computed difference 1 - m has only a few.
     All arguments are pure numbers; angles are in radians.

   WHAT TO CALL
     jacobi_sncndn        sn, cn and dn for one u and one m; the twelve quotients and the amplitude have functions of
                          their own
     jacobi_sncndn_any    sn, cn and dn for m > 1 too, as a rotating pendulum needs them
     jacobi_K, jacobi_E, jacobi_Pi, jacobi_D
                          complete elliptic integrals of the first, second and third kind; D is (K - E)/m
     jacobi_F, jacobi_E_incomplete, jacobi_Pi_incomplete, jacobi_D_incomplete
                          incomplete elliptic integrals from 0 to any angle phi; F is the inverse function of the
                          amplitude. For m > 1 these integrals have values up to phi = arcsin(1/sqrt(m)).
     jacobi_inverse_sn    u from sn(u | m); jacobi_inverse_cn and jacobi_inverse_dn do the same for cn and dn
     jacobi_RF            Carlson's integrals R_F, R_C, R_D, R_J, R_G; all other elliptic integrals are sums of these
     jacobi_plan_init     prepares a plan, the numbers that depend only on m; then call jacobi_plan_sncndn for one u, or
                          jacobi_plan_sncndn_array for many u. A plan is plain data and may be a constant in flash;
                          examples/print_plan prints such a constant. On AVR a plan in flash must be copied to RAM, by
                          memcpy_P, before the plan is used.
     jacobi_solve_kpK     m from the value of k'K(m); jacobi_solve_K returns m from the value of K(m)
     jacobi_cn_means      mean values of cn^2, cn^4 and cn^6 over a period
     jacobi_agm_...       sn, cn, dn and K by the classical method, the arithmetic-geometric mean (see METHOD);
                          jacobi_agm_sncndn takes the number of its steps as an argument

   ERRORS
     These arguments give NaN: m > 1, or m1 < 0 in functions that take m1 = 1 - m (jacobi_sncndn_any and the incomplete
     integrals allow both); c < 0 in the functions jacobi_solve_...; arguments outside the domain that the comment of a
     function gives; NaN; and infinite numbers, with two exceptions. The first exception: jacobi_K, jacobi_E, jacobi_D,
     jacobi_Pi, the incomplete integrals, the inverses of sn and cn, and Carlson's integrals return the limit at an
     infinite argument, and NaN where there is no limit. The second: m = 1 gives the limits, for u = +-infinity too: K
     is infinite, E is 1, sn is tanh u, cn and dn are 1/cosh u. But jacobi_agm_sncndn gives NaN for m = 1.
     A quotient such as sn/cn is infinite at its poles, where the denominator is 0. For m > 1 and for an infinite or NaN
     m, jacobi_plan_init returns -1 and leaves the plan as it was. No other error is possible. The functions allocate no
     memory and keep no state; errno says nothing about their errors.

   METHOD
     Where u^2 max(1, 1 - m) is small, (cn/sn)^2 at u/4 is computed by its power series (a Laurent series, whose first
     term is a multiple of 1/u^2). Then two duplications, each of which doubles the argument, lead from u/4 to u [1, 5].
     This method needs one square root, but not K.
     If |u| is above about K/2, a multiple of the quarter period K is subtracted from u first. The closer u is to a zero
     of sn or cn, the more digits of K are needed. K comes from a table, from two steps of the arithmetic-geometric mean
     and a series, or from more steps in two or three words. A step of this mean replaces two numbers by their
     arithmetic and their geometric mean. A word is one number of the type; a sum of two or three words has two or three
     times the digits.
     For m near 1 or below about -21, u^2 max(1, 1 - m) may still be large after this subtraction. Then theta functions
     of an imaginary argument are used [1]. They are series in powers of the nome of 1 - m or of 1/(1 - m), where the
     nome of m is the number exp(-pi K(1 - m)/K(m)). The nome is here at most 0.003, so that few terms are enough.
     The incomplete integrals and the inverses use Carlson's duplication, which brings the arguments of an integral
     closer together, and then a power series up to the terms of degree 10 (float 4). For the incomplete integrals a
     multiple of pi is subtracted from the angle first. Where jacobi_sncndn uses the Laurent series, a plan has
     polynomials in the square of the reduced u. No subtraction loses digits, not even for m = 1.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double; the tests run both
     VM_API               linkage of every function; the default is static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If VM_INLINE is defined as
                          VM_API, the code is smaller and the results are the same.
     VM_SQRT, VM_FABS, VM_FLOOR, VM_COPYSIGN
                          the functions of the C library that are used; define all four or none. Where the compiler
                          says that fma is fast (FP_FAST_FMA, in float FP_FAST_FMAF), fma is used, too. All these
                          functions round correctly, so that results are the same on every machine, unless the compiler
                          fuses products and sums.
     VM_TABLE, VM_READ    VM_TABLE is the storage of the tables, and VM_READ(x) reads x, an element of a table; define
                          both or none. The defaults are static const and (x); on AVR they are static const PROGMEM and
                          pgm_read_float(&(x)), so that tables take no RAM
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but none of the bounds below holds
                          then
     VM_MIXED_PRECISIONS  allows a program in which some files define VM_USE_FLOAT and others do not. Without this macro
                          gcc and MSVC, and clang for Windows, refuse to link such a program.
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
     eps, ulp     eps is 2.2e-16 (float 1.2e-7). An ulp is the distance between two neighbouring numbers of the type,
                  next to the true value. The bounds take the inputs as exact.
     sn, cn, dn   absolute error <= 4 eps max(1, k') for |u| <= 1e9 and |u| <= 2^40 K (float 1e4 and 2^17 K). Relative
                  error <= 9 ulp for |u| <= 100 K, at the zeros and next to them too (in float, except where u is
                  within a millionth of an ulp of a zero). A plan is as accurate. For |u| >= K/eps the digits of u do
                  not tell at which point of a period u lies: then sn = 0 and cn = dn = 1.
     K, E         <= 2 ulp
     k'K          <= 5 ulp
     means        <= 8 ulp, for the means of cn^2, cn^4 and cn^6
     quotients    <= 8 ulp, for sn/cn and the other quotients; the amplitude has the same bound
     F, E, D, Pi  <= 8 ulp for |phi| <= 1e9 (float 1e4) and n <= 1; the comment of jacobi_Pi_incomplete has the bound
                  for n > 1
     inverses of sn, cn and dn, Carlson's integrals   <= 8 ulp; R_G <= 10 ulp; the comment of jacobi_RJ has the bound of
                  R_J
     m > 1        the absolute bounds of sn, cn, dn hold with k u in place of u; the comment of jacobi_sncndn_any has
                  the relative bound
     solvers      <= 4 ulp of m and of m1, plus the change of m or m1 that one ulp of the argument c of
                  jacobi_solve_... makes

   COST
     docs/cost.md has the times of the functions that are used most, docs/peers.md those of the incomplete integrals and
     of R_F and R_J, docs/counts.md the number of instructions of a call of many functions. A jacobi_plan has 312
     [jacobi_plan_bytes] bytes, in float 116 [jacobi_plan_bytes_float]; the name in brackets is that of the row of
     docs/numbers.md with this number. The largest stack frame is about 1 kB; that of jacobi_plan_sncndn_array has up to
     3 kB where the compiler vectorises its loop for wide registers.

   REFERENCES
     [1] DLMF, chapters 19, 20 and 22, dlmf.nist.gov: 19.8 (AGM), 20.2, 20.7, 22.2 (theta functions), 22.20.
     [2] R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions, Numer. Math. 7 (1965) 78-90.
     [3] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [4] L. Cveticanin, Dynamics of Mass Variable System, dissertation; numbers like (307) are its equations.
     [5] DLMF, 23.9 (Laurent series of Weierstrass' function), 22.6 (duplication).
     [6] B. C. Carlson, Numerical computation of real or complex elliptic integrals, Numer. Algorithms 10 (1995) 13-26.

   INDEX
     base/self_check: a test of whether this compiler and this processor compute as varmass needs
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

     jacobi/amplitude: the amplitude am, which is the angle whose sine is sn and whose cosine is cn
       jacobi_am                      Jacobi's amplitude am(u | m) in radians

     jacobi/plans: sn, cn and dn for many arguments and one parameter
       jacobi_plan_init               Prepares a plan for the parameter m = k^2 <= 1
       jacobi_plan_init_m1            Prepares a plan for the complementary parameter m1 = 1 - m >= 0
       jacobi_plan_sncndn             sn, cn and dn of the argument u for the plan's parameter
       jacobi_plan_sncndn_array       sn, cn and dn of the n arguments in the array u, for the plan's parameter

     jacobi/modulus: the parameter m for a given quarter period
       jacobi_solve_kpK               The parameter m for which k' K(m) = c, the solution of equation (307), for c >= 0
       jacobi_solve_kpK_m1            Solves k' K(m) = c as jacobi_solve_kpK does, but returns 1 - m with all its digits
       jacobi_solve_K_m1              Solves K(m) = c as jacobi_solve_K does, but returns 1 - m with all its digits
       jacobi_solve_K                 The parameter m whose quarter period K(m) is c, for c >= 0

     jacobi/means: mean values of cn^2, cn^4 and cn^6 over a period
       jacobi_cn_means                Means of cn^2, cn^4 and cn^6 over a period, for the parameter m <= 1

     jacobi/descending: sn, cn, dn and K by the arithmetic-geometric mean
       jacobi_agm_sncndn              sn, cn and dn of u by a given number of steps of the arithmetic-geometric mean, for m < 1
       jacobi_agm_K                   K(m) by the arithmetic-geometric mean, for m <= 1

     jacobi/carlson: Carlson's symmetric elliptic integrals R_F, R_C, R_D, R_J and R_G
       jacobi_RF                      R_F(x, y, z), Carlson's integral of the first kind, for x, y, z >= 0
       jacobi_RC                      R_C(x, y) = R_F(x, y, y), Carlson's elementary integral, for x >= 0 and any y
       jacobi_RD                      R_D(x, y, z) = R_J(x, y, z, z), Carlson's integral of the second kind, for x, y, z >= 0
       jacobi_RJ                      R_J(x, y, z, p), Carlson's integral of the third kind, for x, y, z >= 0
       jacobi_RG                      R_G(x, y, z), Carlson's symmetric integral of the second kind, for x, y, z >= 0

     jacobi/incomplete: incomplete elliptic integrals F, E, D and Pi, and the complete D and Pi
       jacobi_F                       F(phi | m), the incomplete elliptic integral of the first kind
       jacobi_F_m1                    F(phi | m) from the complementary parameter m1 = 1 - m
       jacobi_E_incomplete            E(phi | m), the incomplete elliptic integral of the second kind
       jacobi_E_incomplete_m1         E(phi | m) from the complementary parameter m1 = 1 - m
       jacobi_D                       D(m) = (K(m) - E(m))/m, the complete elliptic integral D, for m <= 1
       jacobi_D_m1                    D(m) from the complementary parameter m1 = 1 - m >= 0
       jacobi_D_incomplete            D(phi | m) = (F(phi | m) - E(phi | m))/m, the incomplete integral of sin^2 x/sqrt(1 - m sin^2 x)
       jacobi_D_incomplete_m1         D(phi | m) from the complementary parameter m1 = 1 - m
       jacobi_Pi                      Pi(n | m), the complete elliptic integral of the third kind, for m <= 1
       jacobi_Pi_m1                   Pi(n | m) from the complementary parameter m1 = 1 - m >= 0
       jacobi_Pi_incomplete           Pi(n; phi | m), the incomplete elliptic integral of the third kind
       jacobi_Pi_incomplete_m1        Pi(n; phi | m) from the complementary parameter m1 = 1 - m

     jacobi/inverse: the inverses of sn, cn and dn
       jacobi_inverse_sn              The inverse of sn
       jacobi_inverse_sn_m1           The inverse of sn from the complementary parameter m1 = 1 - m >= 0
       jacobi_inverse_cn              The inverse of cn
       jacobi_inverse_cn_m1           The inverse of cn from the complementary parameter m1 = 1 - m >= 0
       jacobi_inverse_dn              The inverse of dn
       jacobi_inverse_dn_m1           The inverse of dn from the complementary parameter m1 = 1 - m >= 0

     jacobi/reciprocal: sn, cn and dn for any parameter, also for m > 1
       jacobi_sncndn_any              sn, cn and dn of the argument u for any finite parameter m */
#ifndef VARMASS_JACOBI_H
#define VARMASS_JACOBI_H

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
/* jacobi/agm.h - the arithmetic-geometric mean and the quarter period from it

   m is the parameter of an elliptic function. From a_0 = 1 and b_0 = k' = sqrt(1 - m) each step makes the next pair:
   a_(n+1) is the arithmetic mean of a_n and b_n, and b_(n+1) their geometric mean. Both sequences tend to one limit,
   agm(1, k'), and the quarter period is K = pi/(2 agm(1, k')). The number of right digits doubles in each step. The
   limit is computed in one word (one vm_real) for jacobi/descending.h, and in two and three words for arguments that
   are large or next to a zero of an elliptic function (jacobi/reduction.h).

       vmi_three K = vmi_K_three_words(VM_C(0.7), 0); // K(0.3) with three times the digits

   Equations: DLMF 19.8. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_AGM_H
#define VARMASS_JACOBI_AGM_H

/* Returns 1 if m1 = 1 - m is negative, infinite or NaN, so that no elliptic function has this parameter, else 0. */
VM_API int vmi_refused(vm_real m1) { return !(m1 >= 0) || !VM_IS_FINITE(m1); }

/* The largest number of pairs a_n, b_n in a vmi_ladder. m = -1.8e308 needs most pairs, 13. */
#define VMI_LADDER 16

/* The numbers a_n and b_n of all steps of the arithmetic-geometric mean. sn, cn and dn are computed from these numbers,
   from the last step back to the first. */
typedef struct VM_TAG(vmi_ladder) {
    int n;                                /* index of the last pair a_n, b_n */
    vm_real a[VMI_LADDER], b[VMI_LADDER]; /* a_0 = 1, b_0 = k'; a_(n+1) = (a_n + b_n)/2, b_(n+1) = sqrt(a_n b_n) */
} vmi_ladder;

/* Computes agm(1, b0) for a finite b0 > 0 in at most `steps` steps, but at least one. If the number of steps allows,
   the function stops at the first n for which x = (c_n/a_n)^2 <= eps/4. The relative error of the last a_n, as a value
   of agm(1, b0), is then at most eps/16. vmi_descend, which computes sn(u), would have to begin with sn(a_n u) for the
   parameter x. Because x is so small, vmi_descend may begin with sin(a_n u) instead: the two differ by at most eps/60
   for |a_n u| <= pi/4. */
VM_API void vmi_agm(vmi_ladder *l, vm_real b0, int steps)
{
    vm_real c; /* c_n = (a_(n-1) - b_(n-1))/2 */
    int n = 0;
    l->a[0] = 1;
    l->b[0] = b0;
    do {
        vm_real a = l->a[n], b = l->b[n];
        c = (a - b) / 2;
        n++;
        l->a[n] = (a + b) / 2;
        l->b[n] = VM_SQRT(a * b);
    } while (4 * c * c > VM_EPSILON * l->a[n] * l->a[n] && n < steps && n < VMI_LADDER - 1);
    l->n = n;
}

/* Returns the quarter period K in three words, with a relative error below 2^-(3p - 12), for 1 - m = m1 + m1_lo > 0; p
   is the number of binary digits of vm_real. Plans (jacobi/plans.h) and the reduction of an argument next to a multiple
   of K need so many digits. */
VM_API vmi_three vmi_K_three_words(vm_real m1, vm_real m1_lo)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON;
    vm_real lift = 1, c; /* lift is a power of 2: the root of m1 lift^2 is taken, so that no word over- or underflows */
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

/* Returns agm(1, k') = pi/(2K) in two words, for 1 - m = m1 + m1_lo > 0. Let s be the mean of the last a_n and b_n, c
   half their difference, and x = (c/s)^2. The series agm(s + c, s - c) = s (1 - x/4 - 5 x^2/64 - ...) replaces a
   further step of the mean. The relative error of the result is x eps/8 < 2^-85 (float 2^-41). The argument u is the
   number that will be reduced by means of the result; the larger u is, the smaller x is made. The error of the result
   therefore changes sn, cn and dn/max(1, k') by less than eps/8, since the slopes of these functions are at most
   max(1, k'). */
VM_API vm_two vmi_agm_two_words(vm_real m1, vm_real m1_lo, vm_real u)
{
    const vm_real tiny = VM_EPSILON * VM_EPSILON, last = VM_MANT_DIG > 24 ? VM_C(3e-5) : VM_C(4e-3);
    vm_real lift = 1, slope; /* lift is a power of 2: the root of m1 lift^2 is taken, so that no word underflows */
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

     K(m) = integral from 0 to pi/2 of dx/sqrt(1 - m sin^2 x),
     E(m) = integral from 0 to pi/2 of sqrt(1 - m sin^2 x) dx.
   The parameter m = k^2 is any number <= 1, also a negative one. The functions with the suffix _m1 take m1 = 1 - m; use
   them for m close to 1, where the difference 1 - m would lose digits. For m between -33.5 and 0.971 K and E are
   computed by series after steps of the arithmetic-geometric mean: two steps for K, one for E. For any other m they are
   computed by sums that contain the logarithm of k' = sqrt(1 - m).

       vm_real K = jacobi_K(VM_C(0.5)); // 1.854...

   Source: equation (307) of the dissertation, and DLMF 19. The polynomials are computed by
   tests/gen/jacobi_coefficients.py. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_INTEGRALS_H
#define VARMASS_JACOBI_INTEGRALS_H

/* VMI_MIDDLE(m1) is 1 if K and E are computed by series for this m1 = 1 - m, and 0 if they are computed by
   logarithms. */
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

/* Returns K in two words for 1 - m = c <= 1/2 and l = ln(4/k'), as K = l + c (l - 1)/4 + c^2 (l A(c) - B(c)). The
   polynomials A and B were fitted together; the relative error that they make in K is below 2^-58 (float 2^-30). */
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

/* Returns E - 1 for 1 - m = c <= 1/2 and l = ln(4/k'), as E - 1 = c (l A(c) - B(c)). The error that the polynomials A
   and B make is below 2^-54.5 (float 2^-25.7). */
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

/* Returns S(x) for x = ((1 - k')/(1 + k'))^2. S is the power series for which K = pi/(1 + k') (1 + x S(x)), and it is
   computed by a polynomial. The polynomial's error of x S is below 2^-58.7 (float 2^-29.6) for x <= 0.0299. vmi_K
   makes x so small by a step of the arithmetic-geometric mean, which replaces k' by 2 sqrt(k')/(1 + k'). One such step
   leads to x < 0.0299 for every m1 for which VMI_MIDDLE(m1) is 1. */
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

/* Returns x S(x) for x = ((1 - k')/(1 + k'))^2 <= 0.503. S is the power series for which E = (pi/4) (1 + k') (1 + x
   S(x)), not the S of vmi_K_series, and it is computed by a polynomial. The polynomial's error of x S is below 2^-56.7
   (float 2^-28.5). */
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

/* Returns K for 1 - m = m1 + m1_lo, a number in two words. Where VMI_MIDDLE(m1) is 1, K comes from two steps of the
   arithmetic-geometric mean and the series S(x) of vmi_K_series: K = 2 pi (1 + x S(x))/(1 + f)^2 with f^2 = k' and
   x = ((1 - f)/(1 + f))^4. For m > 0.971 K comes from a logarithm (vmi_K_by_log). For m < -33.5 K is K(mu)/k', where mu
   is the parameter with 1 - mu = 1/(1 - m), and K(mu) comes from a logarithm, too. */
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
    if (m1 == VM_INFINITY) return 0;
    if (vmi_refused(m1)) return VM_NAN;
    if (m1 == 0) return VM_INFINITY;
    K = vmi_K_by_log(m1 < 1 ? m1 : 1 / m1, vmi_log_4(m1, m1_lo));
    if (m1 < 1) return K.hi;
    root = vmi_root(m1, m1_lo);
    quotient = K.hi / root.hi;
    return quotient + (K.lo - quotient * root.lo) / root.hi;
}

/* Returns E for 1 - m = m1 + m1_lo, a number in two words. Where VMI_MIDDLE(m1) is 1, E comes from vmi_E_series. For
   m > 0.971 E comes from vmi_E_rest. For m < -33.5 E is k' E(mu), where mu is the parameter with 1 - mu = 1/(1 - m),
   and E(mu) comes from vmi_E_rest, too. */
VM_API vm_real vmi_E(vm_real m1, vm_real m1_lo)
{
    vm_two root;
    vm_real rest;
    if (VMI_MIDDLE(m1)) {
        const vmi_three half_pi = vmi_half_pi();
        const vm_real kp = VM_SQRT(m1), k1 = (1 - kp) / (1 + kp);
        const vm_two sum = vmi_two_sum(1, kp);
        const vm_real kp_lo = m1_lo * VM_C(0.09); /* low word of k': about m1_lo/(2 k') for m < -15, else negligible */
        const vm_real more = (sum.lo + kp_lo) + sum.hi * vmi_E_series(k1 * k1);
        return half_pi.hi / 2 * sum.hi + (half_pi.hi / 2 * more + half_pi.mid / 2 * sum.hi);
    }
    if (m1 == VM_INFINITY) return VM_INFINITY;
    if (vmi_refused(m1)) return VM_NAN;
    if (m1 == 0) return 1;
    rest = vmi_E_rest(vmi_smaller(m1, 1 / m1), vmi_log_4(m1, m1_lo).hi);
    if (m1 < 1) return 1 + rest;
    root = vmi_root(m1, m1_lo);
    return root.hi + (root.lo + root.hi * rest);
}

/* K(m), the complete elliptic integral of the first kind, from m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_K. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_K_m1(vm_real m1) { return vmi_K(m1, 0); }

/* E(m), the complete elliptic integral of the second kind, from m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_E. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_E_m1(vm_real m1) { return vmi_E(m1, 0); }

/* K(m), the complete elliptic integral of the first kind, for m <= 1: a quarter of the period of sn. The error is at
   most 2 ulp. Returns infinity for m = 1, 0 for m = -infinity, and NaN for m > 1. DLMF 19.2.8. */
VM_API vm_real jacobi_K(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_K(m1.hi, m1.lo);
}

/* E(m), the complete elliptic integral of the second kind, for m <= 1. The error is at most 2 ulp. Returns 1 for
   m = 1, infinity for m = -infinity, and NaN for m > 1. DLMF 19.2.8. */
VM_API vm_real jacobi_E(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_E(m1.hi, m1.lo);
}

/* k' K(m) = sqrt(1 - m) K(m), the left side of equation (307), for m <= 1. The product falls from infinity, as m tends
   to -infinity, to 0 at m = 1. The error is at most 5 ulp. Returns NaN for m > 1 and for infinite m. */
VM_API vm_real jacobi_kpK(vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    if (vmi_refused(m1.hi)) return VM_NAN;
    if (m1.hi == 0) return 0;
    if (m1.hi > 10) return vmi_K_by_log(1 / m1.hi, vmi_log_4(m1.hi, m1.lo)).hi;
    return VM_SQRT(m1.hi) * vmi_K(m1.hi, m1.lo);
}

#endif
/* jacobi/period_table.h - the quarter period K from a table of polynomials

   To reduce a large argument, the quarter period K is needed with more digits than a vm_real has. The
   arithmetic-geometric mean gives these digits (jacobi/agm.h), but this method is slow, since it takes one square root
   after another. Here K comes from one of 25 polynomials in k' = sqrt(1 - m), for k' from 0.171875 to 1.5. Each octave
   of k', an interval from 2^n to 2^(n+1), is divided into eight pieces of equal length. Each piece has its own
   polynomial c_0 + c_1 t + c_2 t^2 + ..., where t is k' minus the middle of the piece. The table takes 3.8 kB (float
   1 kB).

       vmi_period K = vmi_period_by_table(VM_C(0.5), 0, VM_SQRT(VM_C(0.5))); // K(0.5) = K.head + K.middle + K.low

   The table is computed by tests/gen/period_table.py. Tests: tests/test_jacobi.c, tests/scan.c. */
#ifndef VARMASS_JACOBI_PERIOD_TABLE_H
#define VARMASS_JACOBI_PERIOD_TABLE_H

/* VMI_IN_PERIOD_TABLE(kp) is 1 if the table gives the quarter period for k' = kp, else 0. */
#define VMI_IN_PERIOD_TABLE(kp) ((kp) >= VM_C(0.171875) && (kp) < VM_C(1.5))

/* The number of polynomials and the number of constants of each. The first five coefficients (float three) have two
   words, the others one: constants 0 and 1 are the two words of c_0, constants 2 and 3 those of c_1, and so on. */
enum { VMI_PERIOD_ROWS = 25, VMI_PERIOD_COLUMNS = VM_MANT_DIG > 24 ? 19 : 10 };

/* Returns a constant of the polynomial number `row`. */
VM_INLINE vm_real vmi_period_constant(vmi_bits row, int column)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real table[VMI_PERIOD_ROWS][VMI_PERIOD_COLUMNS] = {
        {VM_C(3.1200943840667605), VM_C(3.2234590877852483e-10), VM_C(-5.415517104032915),
         VM_C(7.073287238700407e-12), VM_C(15.67579460144043), VM_C(2.3814758196689725e-07), VM_C(-57.8125),
         VM_C(-0.004351889902599495), VM_C(240.48583984375), VM_C(4.312139751079842e-05),
         VM_C(-1069.2008992812432), VM_C(4955.6961400199425), VM_C(-23632.804742462962),
         VM_C(115063.07701061308), VM_C(-569144.8978358798), VM_C(2850452.894803547), VM_C(-14420605.228307953),
         VM_C(73983142.13974646), VM_C(-380075184.2342842)},
        {VM_C(3.039096879772842), VM_C(-1.458724772615982e-10), VM_C(-4.964618488345877),
         VM_C(-6.175192369676107e-13), VM_C(13.281128406524658), VM_C(1.381353788217289e-07), VM_C(-45.0625),
         VM_C(-0.00017478324492667952), VM_C(172.36865234375), VM_C(-7.019827812869866e-05),
         VM_C(-704.879174359522), VM_C(3005.383099578208), VM_C(-13184.823964719959), VM_C(59056.77147964698),
         VM_C(-268742.5292560721), VM_C(1238259.1472850563), VM_C(-5763222.833350258), VM_C(27178129.55499403),
         VM_C(-128451143.02714698)},
        {VM_C(2.964604936540127), VM_C(1.9806473684746738e-10), VM_C(-4.580152494309004),
         VM_C(7.386454342880199e-13), VM_C(11.396871089935303), VM_C(-1.9109587175333132e-07), VM_C(-35.8125),
         VM_C(0.0065342859157047194), VM_C(126.7637939453125), VM_C(4.2992866992529755e-05),
         VM_C(-479.868687700217), VM_C(1894.2261774170013), VM_C(-7694.073914388595), VM_C(31909.02329123051),
         VM_C(-134445.94694798795), VM_C(573580.5560160861), VM_C(-2471841.4973641424),
         VM_C(10785726.811449626), VM_C(-47199635.01901083)},
        {VM_C(2.8956930385902524), VM_C(4.1164163562992076e-10), VM_C(-4.248424245524802),
         VM_C(4.832487385927097e-12), VM_C(9.887404918670654), VM_C(9.076335017600868e-08), VM_C(-28.921875),
         VM_C(-0.0029242539858942334), VM_C(95.3026123046875), VM_C(1.9727003929496146e-05),
         VM_C(-335.80561273979396), VM_C(1233.9778410987187), VM_C(-4666.2620355323), VM_C(18016.743212843427),
         VM_C(-70675.1519620111), VM_C(280720.2490710035), VM_C(-1126319.126381069), VM_C(4573134.735204485),
         VM_C(-18632196.255222023)},
        {VM_C(2.8316203728318214), VM_C(-8.791794729532627e-11), VM_C(-3.9592674190644175),
         VM_C(-9.551979322508738e-13), VM_C(8.659367561340332), VM_C(-2.149465674630339e-07), VM_C(-23.703125),
         VM_C(0.0001730894316877254), VM_C(73.0313720703125), VM_C(5.3992389736135624e-05),
         VM_C(-240.6668341401514), VM_C(827.2039203726936), VM_C(-2926.0370678765626), VM_C(10568.326069653982),
         VM_C(-38781.32801349843), VM_C(144098.6089929801), VM_C(-540852.9836640635), VM_C(2053386.2619395081),
         VM_C(-7826226.208588889)},
        {VM_C(2.743297071196139), VM_C(-4.324482224456551e-10), VM_C(-3.588990932039451),
         VM_C(-2.1011362891506352e-12), VM_C(7.2058265209198), VM_C(-1.183130746249538e-08), VM_C(-18.0),
         VM_C(0.007523341960603012), VM_C(50.518798828125), VM_C(2.5398078091927636e-06),
         VM_C(-151.72906408506452), VM_C(475.39277780075594), VM_C(-1533.0350234303698),
         VM_C(5048.159731634414), VM_C(-16889.44514976924), VM_C(57214.73175744805), VM_C(-195795.2365218889),
         VM_C(682723.7911603191), VM_C(-2372688.2581241406)},
        {VM_C(2.637673015706241), VM_C(4.582302920084496e-10), VM_C(-3.1858196995963226),
         VM_C(-2.5706228498877993e-12), VM_C(5.774693489074707), VM_C(1.56321033874785e-08), VM_C(-12.9140625),
         VM_C(0.0009709230250467727), VM_C(32.42059326171875), VM_C(-2.599290676722129e-06),
         VM_C(-87.07568404833184), VM_C(244.02739796700465), VM_C(-703.9766422779214), VM_C(2073.9207337842554),
         VM_C(-6207.893140363168), VM_C(18815.774182295358), VM_C(-57610.361505866495),
         VM_C(179358.90847286125), VM_C(-557696.5257574626)},
        {VM_C(2.543389955535531), VM_C(-6.998650763845314e-12), VM_C(-2.859150813128508),
         VM_C(9.20059316502088e-13), VM_C(4.730580806732178), VM_C(-1.050051139737992e-07), VM_C(-9.5859375),
         VM_C(0.0035496619016598917), VM_C(21.75604248046875), VM_C(-6.919248586850534e-07),
         VM_C(-52.83916534421908), VM_C(133.93211746283637), VM_C(-349.50633690730655), VM_C(931.4836962327715),
         VM_C(-2522.5085366296844), VM_C(6917.194648024937), VM_C(-19161.532296368427), VM_C(53891.22274350994),
         VM_C(-151604.9414096268)},
        {VM_C(2.458388057537377), VM_C(3.1958700654394143e-10), VM_C(-2.589137242663128),
         VM_C(1.5206249533558837e-12), VM_C(3.9453024864196777), VM_C(8.870598428335426e-09), VM_C(-7.30859375),
         VM_C(0.0011621316776115117), VM_C(15.142410278320312), VM_C(-3.661931022144613e-06),
         VM_C(-33.56094033694419), VM_C(77.64253467351422), VM_C(-184.9566634907376), VM_C(450.01612867375326),
         VM_C(-1112.6135828030247), VM_C(2785.5734925581996), VM_C(-7045.181847351141),
         VM_C(18070.358700058467), VM_C(-46413.10856679214)},
        {VM_C(2.3811208568513393), VM_C(-4.3722812720431884e-10), VM_C(-2.3622631463149446),
         VM_C(-1.2551230255063407e-12), VM_C(3.3397194147109985), VM_C(2.27236017674481e-08), VM_C(-5.69921875),
         VM_C(-0.0012671740458013976), VM_C(10.864639282226562), VM_C(5.428470841603015e-06),
         VM_C(-22.14239082874157), VM_C(47.11055252332709), VM_C(-103.22330184124286), VM_C(231.0280247532738),
         VM_C(-525.4514133942547), VM_C(1210.2327706551507), VM_C(-2815.9090916350087), VM_C(6638.799347956145),
         VM_C(-15686.96240964093)},
        {VM_C(2.310397354885936), VM_C(4.4943816132307236e-10), VM_C(-2.1690028555094614),
         VM_C(-3.0783638039106183e-12), VM_C(2.8628164529800415), VM_C(-2.5583690594056026e-08), VM_C(-4.53125),
         VM_C(-0.0017327659072434464), VM_C(7.9983978271484375), VM_C(1.9241405468772697e-06),
         VM_C(-15.08634941208909), VM_C(29.709247137296842), VM_C(-60.25911522122658), VM_C(124.85952509436666),
         VM_C(-262.9214083418343), VM_C(560.6784331117852), VM_C(-1207.876384583304), VM_C(2634.8666661904936),
         VM_C(-5764.636354385284)},
        {VM_C(2.2452806038782), VM_C(1.5929193583224803e-11), VM_C(-2.002447675258736),
         VM_C(-1.1918382274065734e-12), VM_C(2.480501174926758), VM_C(3.6031066842354633e-08), VM_C(-3.6640625),
         VM_C(-0.00013660238446397286), VM_C(6.019432067871094), VM_C(3.0679851098781218e-06),
         VM_C(-10.566113124379067), VM_C(19.36536050048058), VM_C(-36.560543713436246), VM_C(70.519329850864),
         VM_C(-138.24030764786906), VM_C(274.4485002912677), VM_C(-550.4479429683332), VM_C(1117.2897640245117),
         VM_C(-2275.7912322351303)},
        {VM_C(2.185020098462701), VM_C(2.7877055985495364e-10), VM_C(-1.8574636568991991),
         VM_C(7.748472886003439e-14), VM_C(2.1692839860916138), VM_C(1.1799983102101875e-08), VM_C(-3.00390625),
         VM_C(-0.0003410611792930962), VM_C(4.617340087890625), VM_C(-1.311959866136205e-06),
         VM_C(-7.579132163491498), VM_C(12.989870488169153), VM_C(-22.935822624351733), VM_C(41.37828055920222),
         VM_C(-75.87315650410629), VM_C(140.90305008340616), VM_C(-264.3573180102745), VM_C(501.728185710565),
         VM_C(-956.0015902139925)},
        {VM_C(2.102429259568453), VM_C(-8.077842563041762e-11), VM_C(-1.6721612590772565),
         VM_C(9.554872956093813e-13), VM_C(1.8007213473320007), VM_C(9.801283481440577e-09), VM_C(-2.28125),
         VM_C(-0.00043303059970795874), VM_C(3.198528289794922), VM_C(-5.475212897755724e-07),
         VM_C(-4.784629973738347), VM_C(7.472772359459962), VM_C(-12.025358494248854), VM_C(19.775197584239713),
         VM_C(-33.055383179012274), VM_C(55.96157541211502), VM_C(-95.72132853472863), VM_C(166.84665767150673),
         VM_C(-289.87326983903307)},
        {VM_C(2.004440844990313), VM_C(-4.5010771996226664e-10), VM_C(-1.4710127689540968),
         VM_C(-1.8072160687858196e-12), VM_C(1.4376887083053589), VM_C(-1.4029519873472607e-08),
         VM_C(-1.6376953125), VM_C(-0.00027706738645310783), VM_C(2.056182861328125),
         VM_C(-5.616458750896704e-07), VM_C(-2.7507567275484277), VM_C(3.8414042271742685),
         VM_C(-5.5279349969667395), VM_C(8.1304038333738), VM_C(-12.156675369508667), VM_C(18.411441765190272),
         VM_C(-28.174077697187347), VM_C(43.84389519643396), VM_C(-68.14882879730841)},
        {VM_C(1.9177475841715932), VM_C(-1.9997115215481755e-10), VM_C(-1.3086786530438985),
         VM_C(1.6026422324320387e-12), VM_C(1.172825574874878), VM_C(-1.359834957426624e-08), VM_C(-1.21484375),
         VM_C(-0.0003492524285075808), VM_C(1.3818416595458984), VM_C(-6.872390288395432e-07),
         VM_C(-1.672148490159854), VM_C(2.1114992966434434), VM_C(-2.7476562871197405),
         VM_C(3.6548373291234326), VM_C(-4.942879942200957), VM_C(6.771814195753297), VM_C(-9.374360314146198),
         VM_C(13.17750883114574), VM_C(-18.53015252836741)},
        {VM_C(1.8402594467625022), VM_C(2.0249718952219971e-10), VM_C(-1.1750830864621093),
         VM_C(3.4135389345175896e-13), VM_C(0.9737151265144348), VM_C(7.838856940231847e-09),
         VM_C(-0.92626953125), VM_C(0.00023426604361437487), VM_C(0.962921142578125),
         VM_C(-5.9133252239829695e-09), VM_C(-1.0638615813542538), VM_C(1.2259680921838525),
         VM_C(-1.4558498195354896), VM_C(1.7673865438206877), VM_C(-2.181731462041832), VM_C(2.728508285359651),
         VM_C(-3.4481530399745504), VM_C(4.420051305238651), VM_C(-5.674456749708208)},
        {VM_C(1.7704079924151301), VM_C(2.6181450039848477e-11), VM_C(-1.0633550278726034),
         VM_C(-3.364736394299506e-13), VM_C(0.8203088045120239), VM_C(-8.14803002160217e-09),
         VM_C(-0.7216796875), VM_C(0.0001108432531028098), VM_C(0.6915140151977539),
         VM_C(2.9924920657377865e-07), VM_C(-0.7030076017095191), VM_C(0.7450335571706033),
         VM_C(-0.8135644938649125), VM_C(0.9082656052187542), VM_C(-1.0311707468404132),
         VM_C(1.1861554969375157), VM_C(-1.3788502991192686), VM_C(1.6244718612624807),
         VM_C(-1.9184651339803893)},
        {VM_C(1.7069863928481936), VM_C(1.2317388542324716e-10), VM_C(-0.9686466927578294),
         VM_C(-8.279890501249515e-13), VM_C(0.6996612846851349), VM_C(1.3190958932255998e-08),
         VM_C(-0.57275390625), VM_C(-0.0001503992077719784), VM_C(0.5093860626220703),
         VM_C(3.8547769831121483e-07), VM_C(-0.4796712194666632), VM_C(0.47056519124915314),
         VM_C(-0.4755809964528156), VM_C(0.4914101522145601), VM_C(-0.5164101564199564),
         VM_C(0.5498886327854214), VM_C(-0.5917615430237934), VM_C(0.6450016691606806),
         VM_C(-0.7052326221747047)},
        {VM_C(1.6490464988164604), VM_C(1.4092343928193297e-10), VM_C(-0.8874393933547253),
         VM_C(-2.528730806555513e-13), VM_C(0.6031083464622498), VM_C(2.189236526603104e-09),
         VM_C(-0.462158203125), VM_C(-6.906982244360925e-05), VM_C(0.3834667205810547),
         VM_C(-9.968686271711333e-08), VM_C(-0.33637856935369204), VM_C(0.307188734190347),
         VM_C(-0.28894367051935693), VM_C(0.2778620518313248), VM_C(-0.27177003940302646),
         VM_C(0.2693613149724727), VM_C(-0.2698285538482113), VM_C(0.2736310673498627),
         VM_C(-0.2785177170135954)},
        {VM_C(1.5958301280625165), VM_C(7.69171178984451e-11), VM_C(-0.8171171152152965),
         VM_C(1.5509128100481976e-13), VM_C(0.5246719419956207), VM_C(8.270597045298386e-09),
         VM_C(-0.378173828125), VM_C(3.264455219463898e-05), VM_C(0.2941460609436035),
         VM_C(-2.0350739001975062e-07), VM_C(-0.24155078309886438), VM_C(0.20635129762942256),
         VM_C(-0.1815167284418184), VM_C(0.16323414616929355), VM_C(-0.14930603573692017),
         VM_C(0.13839877507572465), VM_C(-0.1296676858274509), VM_C(0.12293726084348575),
         VM_C(-0.117045268979489)},
        {VM_C(1.5235462966375053), VM_C(-1.2886668387630985e-11), VM_C(-0.727827285798412),
         VM_C(-1.0217751327455818e-13), VM_C(0.4320553094148636), VM_C(5.25174499193368e-09),
         VM_C(-0.2861328125), VM_C(3.470758866239467e-05), VM_C(0.20365238189697266),
         VM_C(3.252511456354899e-08), VM_C(-0.15268466389224913), VM_C(0.11894494932474993),
         VM_C(-0.09536559352129662), VM_C(0.07815535992883661), VM_C(-0.06514827183541826),
         VM_C(0.05503631242369706), VM_C(-0.046999257487729075), VM_C(0.040915197290837244),
         VM_C(-0.0355132551090007)},
        {VM_C(1.4388054376468062), VM_C(-7.04474549608874e-11), VM_C(-0.6318001541621925),
         VM_C(-8.80018187608036e-13), VM_C(0.3412606567144394), VM_C(-7.212091968073193e-09),
         VM_C(-0.2042236328125), VM_C(4.1587680610485594e-05), VM_C(0.1307060718536377),
         VM_C(-1.0142484379213166e-07), VM_C(-0.08787019289171061), VM_C(0.061282373736543154),
         VM_C(-0.04395293481649985), VM_C(0.03221290353535262), VM_C(-0.02401165321698189),
         VM_C(0.01814022373011364), VM_C(-0.013854397242689116), VM_C(0.010764983943842649),
         VM_C(-0.00835760518341378)},
        {VM_C(1.3647932666353881), VM_C(-1.1412976847678343e-10), VM_C(-0.5551319894857443),
         VM_C(1.7007059522883908e-13), VM_C(0.2754291743040085), VM_C(5.062714522143538e-09),
         VM_C(-0.1505126953125), VM_C(2.0460565836481268e-05), VM_C(0.08761632442474365),
         VM_C(4.843781452732208e-08), VM_C(-0.05342725032689799), VM_C(0.033743858299197294),
         VM_C(-0.021898365172745352), VM_C(0.014515892499805274), VM_C(-0.00978506735286864),
         VM_C(0.006685153923027192), VM_C(-0.0046174324161999784), VM_C(0.003239959921404032),
         VM_C(-0.002275114409322478)},
        {VM_C(1.2994312979280949), VM_C(1.351882297858641e-11), VM_C(-0.4927040895308892),
         VM_C(-1.3683568870972404e-13), VM_C(0.22627606242895126), VM_C(1.305123317913712e-09),
         VM_C(-0.1138916015625), VM_C(1.255884387467134e-05), VM_C(0.06085127592086792),
         VM_C(-1.451458574211298e-08), VM_C(-0.033973749717431355), VM_C(0.019615519649488076),
         VM_C(-0.011626502976192107), VM_C(0.00703569952421879), VM_C(-0.004328736981299801),
         VM_C(0.0026990880049220754), VM_C(-0.0017014422088708497), VM_C(0.001088409261990386),
         VM_C(-0.0006975974769562036)}};
#else
    VM_TABLE vm_real table[VMI_PERIOD_ROWS][VMI_PERIOD_COLUMNS] = {
        {VM_C(3.1200943), VM_C(8.50726991e-8), VM_C(-5.41552734), VM_C(1.0239135e-5), VM_C(16.0),
         VM_C(-0.32420516), VM_C(-57.8167763), VM_C(240.485504), VM_C(-1071.72986), VM_C(4968.00928)},
        {VM_C(3.03909683), VM_C(4.73515804e-8), VM_C(-4.96484375), VM_C(2.25261319e-4), VM_C(13.0),
         VM_C(0.281128556), VM_C(-45.0626335), VM_C(172.368393), VM_C(-706.289673), VM_C(3011.70117)},
        {VM_C(2.96460485), VM_C(8.21544504e-8), VM_C(-4.58007813), VM_C(-7.43694982e-5), VM_C(11.0),
         VM_C(0.396870911), VM_C(-35.8059387), VM_C(126.763733), VM_C(-480.691589), VM_C(1897.63916)},
        {VM_C(2.89569306), VM_C(-2.47340672e-8), VM_C(-4.24853516), VM_C(1.10910616e-4), VM_C(10.0),
         VM_C(-0.112594992), VM_C(-28.9247837), VM_C(95.3025742), VM_C(-336.304596), VM_C(1235.90454)},
        {VM_C(2.83162045), VM_C(-8.2044302e-8), VM_C(-3.95922852), VM_C(-3.89035122e-5), VM_C(9.0),
         VM_C(-0.340632647), VM_C(-23.7029419), VM_C(73.031395), VM_C(-240.979691), VM_C(828.333923)},
        {VM_C(2.7432971), VM_C(-2.93034486e-8), VM_C(-3.58911133), VM_C(1.20393634e-4), VM_C(7.0),
         VM_C(0.205826521), VM_C(-17.9923954), VM_C(50.5185356), VM_C(-152.386261), VM_C(477.557068)},
        {VM_C(2.6376729), VM_C(1.15010906e-7), VM_C(-3.18579102), VM_C(-2.86850991e-5), VM_C(6.0),
         VM_C(-0.225306496), VM_C(-12.9130545), VM_C(32.4204826), VM_C(-87.3772659), VM_C(244.915939)},
        {VM_C(2.54339004), VM_C(-8.01007403e-8), VM_C(-2.85913086), VM_C(-1.99543101e-5), VM_C(4.5),
         VM_C(0.230580702), VM_C(-9.5823698), VM_C(21.7559929), VM_C(-52.9888191), VM_C(134.330994)},
        {VM_C(2.45838809), VM_C(-3.22767022e-8), VM_C(-2.58911133), VM_C(-2.5914831e-5), VM_C(4.0),
         VM_C(-0.0546975024), VM_C(-7.30742216), VM_C(15.1423826), VM_C(-33.6401062), VM_C(77.8351669)},
        {VM_C(2.38112092), VM_C(-6.37671604e-8), VM_C(-2.36230469), VM_C(4.15410177e-5), VM_C(3.25),
         VM_C(0.0897194371), VM_C(-5.70048046), VM_C(10.8646326), VM_C(-22.1865616), VM_C(47.2094154)},
        {VM_C(2.31039739), VM_C(-3.12155279e-8), VM_C(-2.16894531), VM_C(-5.75431077e-5), VM_C(2.75),
         VM_C(0.112816431), VM_C(-4.53297949), VM_C(7.99839306), VM_C(-15.1121292), VM_C(29.7626667)},
        {VM_C(2.2452805), VM_C(9.96674459e-8), VM_C(-2.00244141), VM_C(-6.26906831e-6), VM_C(2.5),
         VM_C(-0.0194987897), VM_C(-3.66419721), VM_C(6.01943159), VM_C(-10.5817518), VM_C(19.395525)},
        {VM_C(2.18502021), VM_C(-1.09617297e-7), VM_C(-1.85742188), VM_C(-4.17819356e-5), VM_C(2.25),
         VM_C(-0.080715999), VM_C(-3.004246), VM_C(4.61733675), VM_C(-7.5889411), VM_C(13.0075674)},
        {VM_C(2.10242915), VM_C(1.07952637e-7), VM_C(-1.67211914), VM_C(-4.21196819e-5), VM_C(1.75),
         VM_C(0.0507213585), VM_C(-2.28167295), VM_C(3.19851112), VM_C(-4.80525017), VM_C(7.50668478)},
        {VM_C(2.00444078), VM_C(6.00858598e-8), VM_C(-1.47106934), VM_C(5.65664159e-5), VM_C(1.5),
         VM_C(-0.0623113066), VM_C(-1.63796771), VM_C(2.05617547), VM_C(-2.76022935), VM_C(3.85533738)},
        {VM_C(1.91774762), VM_C(-3.27962617e-8), VM_C(-1.30871582), VM_C(3.71669885e-5), VM_C(1.125),
         VM_C(0.04782556), VM_C(-1.21519065), VM_C(1.38183796), VM_C(-1.67685449), VM_C(2.11775947)},
        {VM_C(1.84025943), VM_C(1.41723362e-8), VM_C(-1.17504883), VM_C(-3.42584863e-5), VM_C(1.0),
         VM_C(-0.026284866), VM_C(-0.926034033), VM_C(0.962919652), VM_C(-1.06635416), VM_C(1.22899425)},
        {VM_C(1.77040803), VM_C(-4.18833359e-8), VM_C(-1.06335449), VM_C(-5.35768493e-7), VM_C(0.8125),
         VM_C(0.0078087966), VM_C(-0.721568167), VM_C(0.691513538), VM_C(-0.704400122), VM_C(0.74658823)},
        {VM_C(1.70698643), VM_C(-3.43357627e-8), VM_C(-0.96862793), VM_C(-1.87631194e-5), VM_C(0.6875),
         VM_C(0.0121612977), VM_C(-0.572903931), VM_C(0.509386063), VM_C(-0.480485052), VM_C(0.471406162)},
        {VM_C(1.64904654), VM_C(-4.13029326e-8), VM_C(-0.887451172), VM_C(1.17784903e-5), VM_C(0.625),
         VM_C(-0.0218916517), VM_C(-0.462227017), VM_C(0.383466393), VM_C(-0.336872935), VM_C(0.307664156)},
        {VM_C(1.59583008), VM_C(4.52460611e-8), VM_C(-0.817138672), VM_C(2.15566415e-5), VM_C(0.5),
         VM_C(0.0246719494), VM_C(-0.378141046), VM_C(0.294145733), VM_C(-0.241861299), VM_C(0.206630558)},
        {VM_C(1.52354634), VM_C(-4.14567403e-8), VM_C(-0.727844238), VM_C(1.69518589e-5), VM_C(0.4375),
         VM_C(-0.005444685), VM_C(-0.286096811), VM_C(0.203651369), VM_C(-0.15333876), VM_C(0.119481057)},
        {VM_C(1.43880546), VM_C(-2.33535111e-8), VM_C(-0.631774902), VM_C(-2.52521077e-5), VM_C(0.34375),
         VM_C(-0.00248935027), VM_C(-0.204181463), VM_C(0.130705535), VM_C(-0.0881714523), VM_C(0.0615031868)},
        {VM_C(1.3647933), VM_C(-3.41074049e-8), VM_C(-0.555114746), VM_C(-1.72435357e-5), VM_C(0.28125),
         VM_C(-0.00582082057), VM_C(-0.150491938), VM_C(0.0876161754), VM_C(-0.0535772741), VM_C(0.0338433124)},
        {VM_C(1.29943132), VM_C(-2.6063514e-8), VM_C(-0.492706299), VM_C(2.20922107e-6), VM_C(0.21875),
         VM_C(0.00752606383), VM_C(-0.113878883), VM_C(0.0608511679), VM_C(-0.0340533741), VM_C(0.0196637064)}};
#endif
    return VM_READ(table[row][column]);
}

/* The quarter period as the sum head + middle + low. The numbers head and middle have few digits: their products with a
   whole number below 2^20 are exact (in float below 2^13, and for head < 2 below 2^14). rough is the sum in one word,
   with a relative error below 2^-27 (float 2^-23). early approximates the sum with a relative error below 2^-13 and is
   ready sooner. */
typedef struct VM_TAG(vmi_period) {
    vm_real head, middle, low, rough, early;
} vmi_period;

/* VMI_PERIOD_CUT is the number of last digits of k' that are set to 0 in the head of k'. Each of the other constants
   rounds a number: the constant is added to the number and subtracted again. VMI_SQUARE_GRID rounds t^2 to a multiple
   of 2^-21, VMI_SLOPE_GRID c_1 to a multiple of 2^-16, and VMI_MIDDLE_GRID the sum of c_1 t, c_2 t^2, ... to a multiple
   of 2^-36. In float VMI_MIDDLE_GRID rounds the sum to a multiple of 2^-14, and VMI_HEAD_GRID c_0 to a multiple of
   2^-9. */
#if VM_MANT_DIG > 24
#define VMI_PERIOD_CUT 34
#define VMI_SQUARE_GRID VM_C(3221225472.0)
#define VMI_SLOPE_GRID VM_C(103079215104.0)
#define VMI_MIDDLE_GRID VM_C(98304.0)
#else
#define VMI_PERIOD_CUT 9
#define VMI_HEAD_GRID VM_C(24576.0)
#define VMI_MIDDLE_GRID VM_C(768.0)
#endif

/* Returns K for 1 - m = m1 + m1_lo, a number in two words, where kp is k' in one word and VMI_IN_PERIOD_TABLE(kp) is 1.
   The relative error is below 2^-71 (float 2^-36).
   Method: in two words k' is kp + kp_lo. The variable t is kp minus the middle of the piece; t does not contain kp_lo.
   t is the sum of head, which has at most 14 binary digits (float 10), and kp_tail. The products b1, b2, ... are exact,
   since their factors have few digits: b1, b2 and b3 are the first words of c_1, c_2 and c_3 times head, head^2 and
   head^3; b4 is the first word of c_4 times g^2, where g is t^2 with few digits; b5 is c_1 with few digits times
   kp_tail (float: only b1 and b2). The sums in which K.middle is subtracted are exact, too. All other terms are so
   small that one word is enough for them. The effect of kp_lo is kp_lo times the derivative of the polynomial; of this
   derivative, the terms up to those that come from c_5 t^5 (float c_4 t^4) are used. */
VM_INLINE vmi_period vmi_period_by_table(vm_real m1, vm_real m1_lo, vm_real kp)
{
    const vmi_bits bits = vmi_to_bits(kp), half = (vmi_bits)1 << (VMI_STORED_DIG - 4);
    const vmi_bits row = (bits >> (VMI_STORED_DIG - 3)) - (8 * (VMI_BIAS - 3) + 3);
    const vm_real middle = vmi_from_bits((bits & ~(2 * half - 1)) | half);
    const vm_real kp_head = vmi_from_bits(bits & ~(((vmi_bits)1 << VMI_PERIOD_CUT) - 1)), kp_tail = kp - kp_head;
#if VM_MANT_DIG > 24
    const vm_real residual = ((m1 - kp_head * kp_head) - 2 * kp_head * kp_tail) - (kp_tail * kp_tail - m1_lo);
#else
    const vm_real residual = vmi_root_residual(m1, kp) + m1_lo;
#endif
    const vm_real kp_lo = residual * (VM_C(0.5) / kp);
    const vm_real head = kp_head - middle, t = kp - middle, tt = t * t, hh = head * head;
    const vm_real c0 = vmi_period_constant(row, 0), c0_lo = vmi_period_constant(row, 1);
    const vm_real c1 = vmi_period_constant(row, 2), c1_lo = vmi_period_constant(row, 3);
    const vm_real c2 = vmi_period_constant(row, 4), c2_lo = vmi_period_constant(row, 5);
    const vm_real b1 = c1 * head, b2 = c2 * hh;
    vmi_period K;
#if VM_MANT_DIG > 24
    const vm_real c3 = vmi_period_constant(row, 6), c3_lo = vmi_period_constant(row, 7);
    const vm_real c4 = vmi_period_constant(row, 8), c4_lo = vmi_period_constant(row, 9);
    const vm_real c5 = vmi_period_constant(row, 10), t4 = tt * tt;
    const vm_real g = vmi_rounded(tt + VMI_SQUARE_GRID) - VMI_SQUARE_GRID; /* the head of t^2 */
    const vm_real c1_head = vmi_rounded(c1 + VMI_SLOPE_GRID) - VMI_SLOPE_GRID, c1_rest = (c1 - c1_head) + c1_lo;
    const vm_real b3 = c3 * (head * hh), b4 = c4 * g * g, b5 = c1_head * kp_tail;
    const vm_real b = b1 + (b2 + (b3 + (b4 + b5)));
    const vm_real p56 = c5 + t * vmi_period_constant(row, 11);
    const vm_real p78 = vmi_period_constant(row, 12) + t * vmi_period_constant(row, 13);
    const vm_real p9A = vmi_period_constant(row, 14) + t * vmi_period_constant(row, 15);
    const vm_real pBC = vmi_period_constant(row, 16) + t * vmi_period_constant(row, 17);
    const vm_real p = (p56 + tt * p78) + t4 * ((p9A + tt * pBC) + t4 * vmi_period_constant(row, 18));
    const vm_real words = (c0_lo + (c1_lo * head + (c2_lo + c3_lo * head) * hh)) + c4_lo * (g * g);
    const vm_real rest4 = (c4 + c4_lo) * ((tt - g) * (tt + g)), slope45 = tt * t * (4 * c4 + 5 * t * c5);
    const vm_real slope3 = (c3 + c3_lo) * (3 * head * t + kp_tail * kp_tail);
    const vm_real slope = (c2 + c2_lo) * (head + t) + slope3; /* (terms of c_2, c_3 at t less those at head)/kp_tail */
    const vm_real rest1 = kp_tail * (c1_rest + slope) + kp_lo * (c1 + slope + slope45);
    K.middle = vmi_rounded(b + VMI_MIDDLE_GRID) - VMI_MIDDLE_GRID;
    K.low = (((((b1 - K.middle) + b2) + b3) + b4) + b5) + (((words + rest4) + t4 * t * p) + rest1);
    K.head = c0;
    K.early = c0 + (b1 + b2);
    K.rough = c0 + (b + ((words + rest4) + (rest1 + t4 * (t * c5))));
#else
    const vm_real p34 = vmi_period_constant(row, 6) + t * vmi_period_constant(row, 7);
    const vm_real p56 = vmi_period_constant(row, 8) + t * vmi_period_constant(row, 9);
    const vm_real rest = tt * (t * (p34 + tt * p56)), slope = (c1 + c1_lo) + (c2 + c2_lo) * (head + t);
    const vm_real words = c0_lo + (c1_lo * head + c2_lo * hh), tail = kp_tail + kp_lo;
    const vm_real slope34 = tt * (3 * vmi_period_constant(row, 6) + 4 * t * vmi_period_constant(row, 7));
    const vm_real c0_head = vmi_rounded(c0 + VMI_HEAD_GRID) - VMI_HEAD_GRID, c0_mid = c0 - c0_head;
    const vm_real sum = c0_mid + (b1 + (b2 + rest));
    K.middle = vmi_rounded(sum + VMI_MIDDLE_GRID) - VMI_MIDDLE_GRID;
    K.low = (((b1 - K.middle) + c0_mid) + b2) + ((rest + words) + (tail * slope + kp_lo * slope34));
    K.head = c0_head;
    K.early = c0 + (b1 + b2);
    K.rough = c0_head + (sum + (words + tail * slope));
#endif
    return K;
}

#endif
/* jacobi/theta.h - Neville's theta functions, from which sn, cn and dn are quotients

   There are four theta functions, theta_s, theta_c, theta_d and theta_n. Each of the twelve elliptic functions is a
   quotient of two theta functions: sn = theta_s/theta_n, and so on. The theta functions are computed for an argument v
   that was reduced to |v| <= K/2. A factor that all four have in common does not matter, since the factor cancels in
   every quotient. No subtraction loses digits, so that each theta function has a small relative error.
   Near 0 (see VMI_NEAR) the theta functions come from the power series of cs^2 = (cn/sn)^2, which begins with 1/v^2 (a
   Laurent series), and from two duplications. An argument far from 0 occurs only for m near 1 or below about -21. There
   the theta functions come from series in a nome, which is at most 0.003. The nome of a parameter m is the number
   exp(-pi K(1 - m)/K(m)).

   Source: DLMF 20.2, 20.7, 22.6, 23.9. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_THETA_H
#define VARMASS_JACOBI_THETA_H

/* The numbers from which the theta functions far from 0 are computed for a parameter m. vmi_far_prepare writes these
   numbers, and its comment explains them. */
typedef struct VM_TAG(vmi_theta_form) {
    vm_real kp, kp_lo; /* k' = sqrt(1 - m); its low word kp_lo is used in the reciprocal form only */
    vm_real q;         /* the nome of 1 - m, or of 1/(1 - m) in the reciprocal form */
    vm_real defect;    /* 1 - z/v, where z is the phase and v is u, or k' u in the reciprocal form */
    vm_real f[3], g[2], scale[2]; /* coefficients of P and Q, coefficients of E, factors of theta_s and theta_c */
} vmi_theta_form;

/* The three methods, in this order: the series near 0; theta functions with the nome of 1 - m, for m near 1; theta
   functions with the nome of 1/(1 - m), for m below about -21 */
enum { VMI_NEAR_FORM, VMI_HYPERBOLIC, VMI_RECIPROCAL };

/* The number of terms of a plan's polynomials, without the constant term */
enum { VMI_TERMS = VM_MANT_DIG > 24 ? 10 : 5 };

/* The four theta functions theta_s, theta_c, theta_d and theta_n, all multiplied by one common factor. Each elliptic
   function is a quotient of two of them, such as sn = s/n. */
typedef struct VM_TAG(vmi_thetas) {
    vm_real s, c, d, n;
} vmi_thetas;

/* The Laurent series is used if v^2 max(1, 1 - m) is at most this number. For -21.5 < m < 0.955 all v with |v| <= K/2
   satisfy this condition. */
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

/* Returns the theta functions near 0, from the series at w = v/4 to the ninth term (float: the fifth) and two
   duplications. Only theta.c and the local variables a and f are computed by subtractions; none of them is near 0.
   A duplication leads from w to 2w. Let sc = sn/cn, and let a and b be numbers with b/a = sc^2(w). Then
     sc^2(2w) = 4 a b (a + b)(a + m1 b)/(a^2 - m1 b^2)^2,
   and the four theta functions s, c, d and n of 2w have the ratios
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
    g = a * ((a + w2) * (a + r)); /* now sc^2(2w) = 4 w^2 g/f^2; the lines below write this as b/a */
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

/* Prepares the theta functions far from 0. They belong to a small parameter c <= 0.05, whose nome is q; k is
   sqrt(1 - c). The argument of these theta functions is an imaginary number i z, and z is called the phase.
     For m near 1 (the hyperbolic form), c = 1 - m and z = u agm(1, k).
     For m below about -21 (the reciprocal form), c = 1/(1 - m) and z = k' u agm(1, k), since
       sn(u | m) = sd(k' u | m/(m - 1))/k'.
   Here agm(1, k) is the arithmetic-geometric mean (jacobi/agm.h). theta_s, theta_c, theta_d, theta_n are multiples of
   the classical theta functions theta_1, theta_4, theta_3, theta_2; in the reciprocal form theta_d and theta_n change
   places. With X = q cosh 2z, which is at most sqrt(q)/2 = 0.03,
     theta_1, theta_2 ~ 2 sinh z (P - Q), 2 cosh z (P + Q),  P = f0 + f2 X^2,  Q = f1 X,
     theta_3, theta_4 = E + O, E - O,                        E = 1 + (g1 X^2 - g0),  O = 2 X.
   f0, f1, f2 and g0, g1 are the elements of the fields f and g. The terms that are left out are below 1e-18. f contains
   the constant factor that makes theta_d/theta_n = dn, so that f0 is near 1/2. The factors `scale` belong to theta_s
   and theta_c. They are near 1, but in the reciprocal form the factor of theta_s contains 1/k'. The variable x is the
   parameter that one step of the arithmetic-geometric mean from 1 and k makes of c. */
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

/* For m = 1 this number replaces every larger argument, for which tanh rounds to 1 and 1/cosh to 0. The number is below
   2 VMI_BIAS ln 2, a condition of vmi_far_exponentials. */
#define VMI_LONGEST (VM_MANT_DIG > 24 ? VM_C(1400.0) : VM_C(170.0))

/* The result of vmi_far_exponentials for a number z. With the whole number n that is nearest to z/ln 2, the fields are
   sine = 2^(1-n) sinh z, cosine = 2^(1-n) cosh z, power = 2^-n, and lift = 2^n. */
typedef struct VM_TAG(vmi_exponentials) {
    vm_real sine, cosine, power, lift;
} vmi_exponentials;

/* Returns the four numbers of vmi_exponentials for the argument z + z_lo, where 0 <= z <= VMI_LONGEST and |z_lo| is at
   most an ulp of z. The relative errors are at most 1.3 ulp. The field `lift` is wrong for n > VMI_BIAS, where 2^n
   overflows. Method: z = n ln 2 + r with |r| < 0.35. Polynomials in r^2 give S = sinh r and C = cosh r - 1. Then
     sine = (1 - 4^-n) + (S (1 + 4^-n) + C (1 - 4^-n)),
     cosine = (1 + 4^-n) + (C (1 + 4^-n) + S (1 - 4^-n)). */
VM_INLINE vmi_exponentials vmi_far_exponentials(vm_real z, vm_real z_lo)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360), to_integer = VM_C(1.5) / VM_EPSILON;
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const vm_real shifted = vmi_rounded(z * one_over_ln2 + to_integer), n = vmi_rounded(shifted - to_integer);
    const vmi_bits n_bits = vmi_to_bits(shifted) & 4095, half = n_bits >> 1; /* the last bits of `shifted` are n */
    const vm_real z_rest = z - n * ln2_hi, subtract = n * ln2_lo - z_lo; /* z_rest has no rounding error */
    const vm_real r = z_rest - subtract, r_lo = (z_rest - r) - subtract, y = r * r;
#if VM_MANT_DIG > 24
    const vm_real P01 = VM_C(0.16666666666666668517) + y * VM_C(0.0083333333333300511209);
    const vm_real P23 = VM_C(1.9841269863105952189e-4) + y * VM_C(2.7557268378709607623e-6);
    const vm_real C01 = VM_C(0.50000000000000011102) + y * VM_C(0.041666666666623990156);
    const vm_real C23 = VM_C(0.0013888888917281772082) + y * VM_C(2.4801521190250773045e-5);
    const vm_real yy = y * y, P = P01 + yy * (P23 + yy * VM_C(2.5100424144926962655e-8));
    const vm_real C = y * (C01 + yy * (C23 + yy * VM_C(2.7620138704027969927e-7)));
#else
    const vm_real P = VM_C(0.166666671634) + y * (VM_C(0.00833331048489) + y * VM_C(1.9891030388e-4));
    const vm_real C = y * (VM_C(0.5) + y * (VM_C(0.0416664630175) + y * VM_C(0.0013933685841)));
#endif
    const vm_real S = r + (r_lo + r * y * P);
    vmi_exponentials e;
    vm_real sum, difference; /* 1 + 4^-n and 1 - 4^-n */
    e.power = vmi_from_bits((VMI_BIAS - half) << VMI_STORED_DIG) *
              vmi_from_bits((VMI_BIAS - (n_bits - half)) << VMI_STORED_DIG); /* 2^-n may be subnormal */
    e.lift = vmi_from_bits((VMI_BIAS + n_bits) << VMI_STORED_DIG);
    sum = 1 + e.power * e.power;
    difference = 1 - e.power * e.power;
    e.sine = difference + (S * sum + C * difference);
    e.cosine = sum + (C * sum + S * difference);
    return e;
}

/* Returns the theta functions far from 0, for |argument| <= VMI_LONGEST. In the reciprocal form the argument is k'
   times that of the elliptic functions. All four theta functions are multiplied by the power of two 2^-n, with the n of
   vmi_exponentials, so that they do not overflow. */
VM_INLINE vmi_thetas vmi_theta_far(const vmi_theta_form *t, int reciprocal, vm_two argument)
{
    vmi_thetas theta;
    const vm_real tiny = VM_EPSILON * VM_EPSILON; /* a smaller nome changes no result: X <= sqrt(q)/2 < eps */
    const vm_real sign = VM_COPYSIGN((vm_real)1, argument.hi), v = sign * argument.hi, product = v * t->defect;
    const vm_real z = v - product, z_lo = ((v - z) - product) + sign * argument.lo;
    const vmi_exponentials e = vmi_far_exponentials(z, z_lo);
    vm_real X = 0, XX, P, Q, E, O, d, n;
    if (t->q > tiny) X = (t->q / 2 * e.lift * e.lift) * (e.cosine * e.cosine) - t->q; /* cosh 2z is 2 cosh^2 z - 1 */
    XX = X * X;
    P = t->f[2] * XX; /* P without its term f[0] */
    Q = t->f[1] * X;
    E = t->g[1] * XX - t->g[0]; /* E without its term 1 */
    O = 2 * X;
    d = e.power * (1 + (E + O));
    n = e.cosine * (t->f[0] + (P + Q));
    theta.s = (sign * t->scale[0]) * e.sine * (t->f[0] + (P - Q));
    theta.c = (t->scale[1] * e.power) * (1 + (E - O));
    theta.d = d;
    theta.n = n;
    if (reciprocal) {
        theta.d = n;
        theta.n = d;
    }
    return theta;
}

/* Returns the theta functions far from 0 for a single v and m, without a plan. */
VMI_APART vmi_thetas vmi_theta_far_unprepared(vm_two v, vm_real m1, vm_real m1_lo)
{
    vmi_theta_form t;
    vmi_far_prepare(&t, m1, m1_lo);
    if (m1 > 1) v = vmi_two_times(v, vmi_two(t.kp, t.kp_lo));
    return vmi_theta_far(&t, m1 > 1, v);
}

/* Returns the theta functions at an argument that is larger by `quarters` quarter periods; only the last two bits of
   `quarters` are used. One quarter period turns s, c, d, n into c, -k' s, k' n, d. Two quarter periods change the signs
   of s and c; a common factor is left out. Products with 0, 1 and -1 replace a branch, which the processor would
   predict wrongly half the time. */
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

/* Computes sn, cn and dn as quotients of the theta functions. A dn that is not between 1 and `bound` is replaced by the
   nearer of these two numbers. */
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
   closer u is to a multiple of K, the more digits of K are needed. Therefore K is used in four forms: from a table (for
   m between -1.25 and 0.97), in one word with corrections, in two words, or in three words. A word is one vm_real.

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_REDUCTION_H
#define VARMASS_JACOBI_REDUCTION_H

/* The limit 2^30 (float 2^13). The product of a piece of K (see vmi_pieces) and a whole number below this limit is
   exact. */
#define VMI_EXACT_QUARTERS (VM_MANT_DIG > 24 ? VM_C(1073741824.0) : VM_C(8192.0))

/* The number of parts of K that vmi_pieces writes into an array */
enum { VMI_PIECES = 5 };

/* Writes K to the array `piece` as a sum of five numbers. The first three are called the pieces. They have few digits:
   they are multiples of 2^(e-21), 2^(e-44) and 2^(e-67) (float 2^(e-9), 2^(e-20) and 2^(e-31)), where
   2^e <= K < 2^(e+1). Their products with a whole number below VMI_EXACT_QUARTERS are therefore exact. The last two
   numbers are the first two words of the rest. */
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
    piece[4] = K.mid;
}

/* The function vmi_reduce_pieces is not accurate enough where the distance of u from the nearest multiple of K is below
   this number times u. */
#define VMI_PIECES_REACH (VM_MANT_DIG > 24 ? VM_C(5.4e-20) : VM_C(4.7e-10))

/* Returns u minus the nearest multiple j K, as three terms, for 0 <= u < VMI_EXACT_QUARTERS K. The array K comes from
   vmi_pieces, and per_K is 1/K. *quarters becomes a number whose last two bits are j modulo 4. The product of j and
   K[3] is rounded, and K[4] is not used: the error is therefore u eps^2/1000 or less. Where the result is below
   VMI_PIECES_REACH times u, it is not accurate enough, and vmi_reduce_finely must be used instead. Loops over this
   function can be vectorised. */
VM_INLINE vmi_three vmi_reduce_pieces(vm_real u, const vm_real *K, vm_real per_K, vmi_bits *quarters)
{
    const vm_real shifted = vmi_rounded(u * per_K + 1 / VM_EPSILON), j = shifted - 1 / VM_EPSILON;
    vmi_three rest;
    rest.hi = (u - j * K[0]) - j * K[1]; /* exact: a multiple of eps 2^e/2, at most about 2^e (see vmi_pieces) */
    rest.mid = -j * K[2];
    rest.lo = -j * K[3];
    *quarters = vmi_to_bits(shifted); /* the last bits of `shifted` are those of j */
    return rest;
}

/* Returns u minus the nearest multiple j K in two words. The arguments are those of vmi_reduce_pieces, but all elements
   of the array K are used. The distance of u from j K must be less than 1e-9 u (float 8e-6 u): then the products and
   differences with the three pieces are exact. The relative error is below eps for every result above 2^-90 u
   (float 2^-44 u). */
VM_API vm_two vmi_reduce_finely(vm_real u, const vm_real *K, vm_real per_K, vmi_bits *quarters)
{
    const vmi_three rest = vmi_reduce_pieces(u, K, per_K, quarters);
    const vm_real j = VM_FLOOR(u * per_K + VM_C(0.5));
    const vm_two product = vmi_two_product(j, K[3]), sum = vmi_two_sum(rest.hi + rest.mid, -product.hi);
    return vmi_two_sum(sum.hi, sum.lo - (product.lo + j * K[4]));
}

/* Rounds a number below 6 to a multiple of 2^-23 (float 2^-8): if this constant is added to the number and then
   subtracted again, the sum is rounded to such a multiple. */
#define VMI_REDUCTION_GRID (VM_MANT_DIG > 24 ? VM_C(805306368.0) : VM_C(49152.0))

/* Returns u minus the nearest multiple j K for u > 0, where VMI_MIDDLE(m1) must be 1; kp is k'. *quarters becomes a
   number whose last two bits are j modulo 4. The relative error of the result is at most about eps. The function
   returns NaN, and u must be reduced by vmi_reduce_long, in two cases: where u is 2.5 K or more, and where the result
   is below u/64 and would lose digits.
   Method: K (1 + f)^2 = 2 pi (1 + x S) with f^2 = k', where x S is small (vmi_K). The number u (1 + f)^2 is called the
   phase; a multiple of 2 pi (1 + x S) is subtracted from the phase, and the rest is divided by (1 + f)^2. The first
   halves (heads) of k' and f are multiples of 2^-23 and 2^-24 (float 2^-8 and 2^-9). Therefore the squares of these
   heads, the number (1 + f)^2 that is formed from the heads, and the product of this number and the head of u are
   exact. */
VMI_APART vm_real vmi_reduce_short(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vmi_bits *quarters)
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
    const int second = phase > 6 * half_pi.hi; /* 0 or 1; it replaces a branch, which would often be mispredicted */
    const vm_real j = (vm_real)(4 + 4 * second); /* 4 times the j above, since 2 pi is 4 times pi/2 */
    const vm_real rest = (phase - j * half_pi.hi) + ((phase_lo - j * half_pi.mid) - j * half_pi.hi * x * S);
    *quarters = 0;
    if (phase < 2 * half_pi.hi) return u;
    *quarters = (vmi_bits)(1 + second);
    if (!(VM_FABS(rest) * 64 > phase && phase < 10 * half_pi.hi)) return VM_NAN;
    return rest / (rate_head + rate_tail);
}

/* Returns u minus the nearest multiple j K in two words, for any u > 0 and m1 > 0. *quarters becomes a number whose
   last two bits are j modulo 4. K is used in two words, or in three if u is below 128 K and next to a multiple of K.
   From u = K/eps on, the digits of u do not determine the result; then the result is 0. */
VMI_APART vm_two vmi_reduce_long(vm_real u, vm_real m1, vm_real m1_lo, vmi_bits *quarters)
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
    if (VM_FABS(rest.hi) > VM_C(0.501) * half_pi.hi) { /* for u > K/(1000 eps): rounding of `count` changed j */
        const vm_real further = VM_FLOOR(rest.hi / half_pi.hi + VM_C(0.5));
        rest = vmi_two_sum(rest.hi - further * half_pi.hi, rest.lo - further * half_pi.mid);
        *quarters += (vmi_bits)(further + 4);
    }
    if (VM_FABS(rest.hi) < size * next && count < 128) {
        vm_real K[VMI_PIECES];
        vmi_pieces(vmi_K_three_words(m1, m1_lo), K);
        return vmi_reduce_finely(u, K, rate.hi / half_pi.hi, quarters);
    }
    v = rest.hi / rate.hi;
    if (VMI_MIDDLE(m1)) return vmi_two(v, 0); /* here |v| < 2, and an error of 1.5 ulp of v is small enough */
    error = vmi_two_product(v, rate.hi);
    return vmi_fast_two_sum(v, (((rest.hi - error.hi) - error.lo) + (rest.lo - v * rate.lo)) / rate.hi);
}

/* The limit of the arguments that vmi_reduce_by_table reduces. Below this limit j is less than 2^20 (float 8700), since
   K is above 1.26. */
#define VMI_TABLE_REACH (VM_MANT_DIG > 24 ? VM_C(1048576.0) : VM_C(11000.0))

/* Returns u minus the nearest multiple j K, for 0 <= u < VMI_TABLE_REACH and for a k' = kp for which
   VMI_IN_PERIOD_TABLE is 1. *quarters becomes a number whose last two bits are j modulo 4. K has a relative error below
   2^-71 (float 2^-36), so that the result is within half an ulp plus 2^-71 u (float 2^-36 u) of the exact difference.
   Next to a multiple of K this error is too large: for j < 128 the result is then NaN, and u must be reduced by
   vmi_reduce_long. For j >= 128 the result is never NaN, since for such j only the absolute error of the result is
   important. */
VMI_APART vm_real vmi_reduce_by_table(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vmi_bits *quarters)
{
    const vm_real closest = VM_MANT_DIG > 24 ? VM_C(1048576.0) : VM_C(1024.0);
    const vmi_period K = vmi_period_by_table(m1, m1_lo, kp);
    vm_real divisor = K.rough, shifted, j, rest;
    if (u < VM_C(2.5) * K.early) divisor = K.early; /* K.early is known sooner than K.rough */
    shifted = vmi_rounded(u / divisor + 1 / VM_EPSILON);
    j = shifted - 1 / VM_EPSILON;
    rest = ((u - j * K.head) - j * K.middle) - j * K.low; /* only the last product and difference round */
    *quarters = vmi_to_bits(shifted); /* the last bits of `shifted` are those of j */
    if (j < 128 && VM_FABS(rest) * closest < u) return VM_NAN;
    return rest;
}

/* Returns u >= 0 minus the nearest multiple j K, or NaN if u or m1 is outside the domain of jacobi_sncndn. For m = 1,
   where there is no period, the result is the smaller of u and VMI_LONGEST. *v_lo becomes the low word of the result,
   and *quarters a number whose last two bits are j modulo 4. kp is k'. The argument reach must be about (2u/K)^2, as
   vmi_thetas_of computes it: for reach < 30, u is below 3 K, and vmi_reduce_short is tried. */
VM_INLINE vm_real vmi_reduced(vm_real u, vm_real m1, vm_real m1_lo, vm_real kp, vm_real reach, vm_real *v_lo,
                              vmi_bits *quarters)
{
    *v_lo = 0;
    if (VMI_IN_PERIOD_TABLE(kp) && u < VMI_TABLE_REACH) {
        const vm_real v = vmi_reduce_by_table(u, m1, m1_lo, kp, quarters);
        if (v == v) return v;
    } else if (reach < 30 && VMI_MIDDLE(m1)) {
        const vm_real v = vmi_reduce_short(u, m1, m1_lo, kp, quarters);
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

   This file has Jacobi's functions sn(u | m), cn(u | m) and dn(u | m) for every real argument u and every parameter
   m = k^2 <= 1, also for negative m. sn and cn have the period 4 K(m), dn has the period 2 K(m), where the quarter
   period K(m) is an integral (jacobi/integrals.h). The functions describe the motions of oscillators with cubic springs
   and of bodies that rotate without torque. For many u and one m use a plan (jacobi/plans.h).

       vm_real sn, cn, dn;
       jacobi_sncndn(VM_C(1.2), VM_C(0.3), &sn, &cn, &dn);

   Method: a multiple of K is subtracted from u, so that the rest v has |v| <= K/2. Four theta functions of v are
   computed, and sn, cn and dn are quotients of them (jacobi/theta.h). For v near 0 the theta functions come from a
   series of (cn/sn)^2 (vmi_theta_near), for v far from 0 from series of their own (vmi_theta_far). Equations: DLMF 22.
   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_FUNCTIONS_H
#define VARMASS_JACOBI_FUNCTIONS_H

/* Returns the theta functions of u for 1 - m = m1 + m1_lo, a number in two words. Each theta function has a small
   relative error, or is NaN outside the domain of jacobi_sncndn. *bound becomes a number for which dn(u | m) lies
   between 1 and *bound. For a small |u| the function computes neither K nor k'. */
VM_INLINE vmi_thetas vmi_thetas_of(vm_real u, vm_real m1, vm_real m1_lo, vm_real *bound)
{
    const vm_real reach = u * u * (VM_C(0.81) * (1 + m1) - VM_C(0.338) * VM_FABS(1 - m1)); /* about (2u/K)^2 */
    vm_real v, v_lo;
    vmi_bits quarters;
    vmi_thetas theta;
    *bound = m1; /* dn lies between 1 and k' = sqrt(m1), and therefore also between 1 and m1 */
    if (m1 >= 0 && reach <= 1) return vmi_theta_near(u, m1);
    *bound = VM_SQRT(m1);
    v = vmi_reduced(VM_FABS(u), m1, m1_lo, *bound, reach, &v_lo, &quarters);
    if (v * v * vmi_larger(m1, 1) > VMI_NEAR) theta = vmi_theta_far_unprepared(vmi_two(v, v_lo), m1, m1_lo);
    else theta = vmi_theta_near(v, m1);
    theta = vmi_theta_shift(theta, *bound, quarters);
    theta.s *= VM_COPYSIGN((vm_real)1, u);
    return theta;
}

/* Computes sn, cn and dn of u for 1 - m = m1 + m1_lo, a number in two words. */
VM_API void vmi_sncndn(vm_real u, vm_real m1, vm_real m1_lo, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_real bound;
    const vmi_thetas theta = vmi_thetas_of(u, m1, m1_lo, &bound);
    vmi_theta_ratios(theta, bound, sn, cn, dn);
    *cn = vmi_clamp(theta.c, -theta.n, theta.n) / theta.n; /* more accurate than the product theta.c (1/theta.n) */
}

/* sn, cn and dn of the argument u for the parameter m = k^2 <= 1. All are pure numbers. |sn| <= 1, |cn| <= 1, and dn
   lies between 1 and sqrt(1 - m). sn is odd in u, cn and dn are even, to the last bit. The error is at most 9 ulp for
   |u| <= 100 K, next to the zeros too. The absolute error is at most 4 eps times the function's largest value for
   |u| <= 1e9 and |u| <= 2^40 K (float 1e4 and 2^17 K). The results are NaN for m > 1 and for infinite arguments, with
   one exception: for m = 1, sn = tanh u and cn = dn = 1/cosh u, also for infinite u. docs/cost.md has the time of a
   call. DLMF 22. */
VM_API void jacobi_sncndn(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    vmi_sncndn(u, m1.hi, m1.lo, sn, cn, dn);
}

/* sn, cn and dn for the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_sncndn. Use jacobi_sncndn_m1 for m close to 1, where the difference 1 - m
   would lose digits. */
VM_API void jacobi_sncndn_m1(vm_real u, vm_real m1, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_sncndn(u, m1 + 0, 0, sn, cn, dn); /* m1 + 0 turns -0 into 0 */
}

/* Returns the theta function whose name is s, c, d or n. */
VM_API vm_real vmi_theta_named(vmi_thetas t, char name)
{
    if (name == 's') return t.s;
    if (name == 'c') return t.c;
    if (name == 'd') return t.d;
    return t.n;
}

/* Returns the elliptic function whose name consists of the letters p and q, such as cd. This function is the quotient
   theta_p/theta_q. For m = 1 both theta functions may underflow to 0; where they are equal, the result is 1. */
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
/* jacobi/amplitude.h - the amplitude am, which is the angle whose sine is sn and whose cosine is cn

       vm_real angle = jacobi_am(VM_C(1.2), VM_C(0.3)); // sin(angle) = sn(1.2 | 0.3)

   Equations: DLMF 22.16. Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_AMPLITUDE_H
#define VARMASS_JACOBI_AMPLITUDE_H

/* Jacobi's amplitude am(u | m) in radians: sn = sin am and cn = cos am, for m <= 1. The amplitude is odd, continuous
   and rising (apart from errors of 4 ulp), and am(u + 2K) = am(u) + pi. The error is at most 8 ulp for |u| <= 100 K.
   Returns NaN for m > 1 and for infinite arguments, except that for m = 1 and an infinite u it returns the limit, pi/2
   or -pi/2. Method: am = j pi + atan(sn/cn), where 2 j K is the multiple of 2 K nearest to u. */
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
/* jacobi/modulus.h - the parameter m for a given quarter period

   The functions solve K(m) = c and k' K(m) = c for m, where K(m) is the quarter period and k' = sqrt(1 - m). The second
   equation is (307); its solution belongs to the Jacobi function whose period is that of a strongly nonlinear
   oscillator. Each equation has one solution for every c > 0. The nome of a parameter m is q = exp(-pi K(1 - m)/K(m)).

       vm_real m = jacobi_solve_kpK(VM_C(1.2)); // sqrt(1 - m) K(m) = 1.2

   Method: for c between K(-1) and K(1/2) a fixed-point iteration finds the nome of m or of m/(m - 1); for other c
   Newton's method finds the logarithm of the nome of 1 - m or 1/(1 - m). Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_MODULUS_H
#define VARMASS_JACOBI_MODULUS_H

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
/* jacobi/means.h - mean values of cn^2, cn^4 and cn^6 over a period

   Averaged equations of oscillators with a cubic spring need these means: equations (383), (384), (408). C2, C4 and
   C6 are the means of cn^2, cn^4 and cn^6.

       vm_real C2, C4, C6;
       jacobi_cn_means(VM_C(0.5), &C2, &C4, &C6);

   Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_MEANS_H
#define VARMASS_JACOBI_MEANS_H

/* Computes the means C2, C4, C6 of cn^2, cn^4, cn^6 from the nome q of m, for |q| <= 0.1. At m = 0 the recurrences
   (384) and (408) would divide 0 by 0. Here all numerators and denominators were divided by m beforehand. For this
   purpose 1/2 - C2 and m are written as q S and 16 q R, where S and R are power series in q. */
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

/* Returns the mean C2 of cn^2 by (383), C2 = (E/K - c)/m, where c = 1 - m <= 1/2 and l = ln(4/k'). E/K is computed in
   two words: near m = 4/5 the mean of sn^6, which is made from C2, has twice the error of C2. */
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
   Method: for -4 <= m <= 1/2 the means come from the nome of m. For any other m the recurrences (384) and (408) are
   solved for the means of sn^2 cn^2 and sn^2 cn^4. These two are small, and C4 and C6 follow by subtracting them from
   C2, so that rounding errors stay small. */
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
        /* For m < 0, cn(u | m) = cd(k' u | M) with M = m/(m - 1) and k' = sqrt(1 - m). The mean of a power of cd is the
           mean of the same power of sn. The mean of sn^2 is 1 minus the mean of cn^2. */
        const vm_real second = vmi_mean_from_K(vmi_smaller(m1.hi, 1 / m1.hi), vmi_log_4(m1.hi, m1.lo));
        vm_real ratio = m1.hi / m, s2c2, s2c4, fourth; /* ratio is (1 - M)/M; M is m or, if m < 0, m/(m - 1) */
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

   In this classical method the caller chooses the accuracy by the number of steps. The method serves for comparison and
   teaching: jacobi_sncndn is faster and more accurate.

       vm_real sn, cn, dn;
       jacobi_agm_sncndn(VM_C(1.2), VM_C(0.3), 3, &sn, &cn, &dn); // with three steps

   Source: DLMF 19.8; Bulirsch, Numer. Math. 7 (1965). Tests: tests/test_jacobi.c. */
#ifndef VARMASS_JACOBI_DESCENDING_H
#define VARMASS_JACOBI_DESCENDING_H

/* Goes back through the steps of the arithmetic-geometric mean by Gauss' transformation. At the last step n the sine
   and cosine of the phase a_n u are known. The results s, c, d, q give sn = s/q, cn = c/q and dn = d/q. With a = a_n,
   b = b_n and a+ = a_(n+1) the step back from n + 1 to n replaces
     s by (a/a+) s q,  c by c d,  d by c^2 + (b/a+) s^2,  q by c^2 + (a/a+) s^2.
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

/* sn, cn and dn of u by a given number of steps of the arithmetic-geometric mean, for m < 1. Fewer steps cost less and
   are less accurate; at least one step is made. With steps >= 15 the function makes as many steps as the type needs;
   the error is then at most 3 eps M (1 + M |u|) with M = max(1, k') for |u| <= 5K. The error grows with |u|, since the
   function rounds the phase a_n u, where a_n is the last arithmetic mean, and reduces a_n u by pi/2; jacobi_sncndn
   reduces u itself by K. The results are NaN for m >= 1 and for infinite arguments. */
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
   kind Pi(-N | m) and theta functions of a complex argument. The integrals are computed here in two words, because the
   rates that follow from them are multiplied by long times; with two words the attitude stays right even after a
   million turns (mechanics/torque_free.h). The theta functions are computed in one word. All functions of this file are
   internal. p is the number of binary digits of vm_real.

   Source: DLMF 19.8, 19.36, 20.7. Tests: tests/test_torque_free.c. */
#ifndef VARMASS_JACOBI_THIRD_KIND_H
#define VARMASS_JACOBI_THIRD_KIND_H

/* Returns Carlson's symmetric integral R_F(x, y, z) in two words, for x, y, z >= 0 of which at most one is 0.
   Duplications (jacobi/carlson.h), usually 7, bring the arguments together, until the series in their differences (DLMF
   19.36.1) has an error of 2^-(2p - 4), where p is the number of binary digits of vm_real. If two of the arguments are
   much smaller than the third one, and the larger of these two is 2^-n times the third one, about log2(n) more
   duplications are needed. */
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

/* The complete integral of the third kind, Pi(-N | m), divided by K(m), and the mean from which K(m) follows */
typedef struct VM_TAG(vmi_third_kind) {
    vm_two mean;  /* agm(1, k') = pi/(2K) */
    vm_two ratio; /* Pi(-N | m)/K(m) */
    vm_two rest;  /* 1 - Pi(-N | m)/K(m) */
} vmi_third_kind;

/* Returns the complete integral of the third kind for m1 = 1 - m > 0 and N >= 0, where share = N/(1 + N) and
   below = 1/(1 + N). The method begins with p = sqrt(1 + N), Q = 1 and the numbers a = 1, g = k' of the
   arithmetic-geometric mean (DLMF 19.8.6-7). Each step replaces a and g by their two means, and p and Q by p+ and Q+:
     e = (p^2 - a g)/(p^2 + a g),  p+ = (p^2 + a g)/(2p),  Q+ = Q e/2.
   The field rest = 1 - Pi/K is share/2 times the sum of all Q. This sum is also 2 minus the sum of all Q (1 - e).
   Therefore the field ratio = Pi/K is `below` plus share/2 times the sum of all Q (1 - e). For m >= 0 all terms of both
   fields are positive, so that both are accurate for any N. */
VM_API vmi_third_kind vmi_third_kind_ladder(vm_two m1, vm_two share, vm_two below)
{
    vm_two a = vmi_two(1, 0), g = vmi_two_root(m1), p = vmi_two_root(vmi_two_over(a, below)), Q = a, ag, pp, above;
    vm_two sum = vmi_two(0, 0), less = sum;
    vmi_third_kind result;
    int step;
    for (step = 0; step < 200; step++) { /* 5 to 10 steps, and one more for each binary digit of sqrt(1 + N) */
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

/* Computes the sine and the cosine of an angle of x turns, that is of 2 pi x radians, for |x| < 2^13. */
VM_API void vmi_sincos_turns(vm_real x, vm_real *sine, vm_real *cosine)
{
    const vmi_three half_pi = vmi_half_pi();
    const int j = vmi_nearest(4 * x), quarter = j & 3;
    const vm_real rest = 4 * x - (vm_real)j;
    vm_two z = vmi_two_product(rest, half_pi.hi);
    vm_real s, c;
    z.lo += rest * half_pi.mid;
    vmi_sin_cos(z, &s, &c);
    vmi_turn_quarters(quarter, s, c, sine, cosine);
}

/* The numbers from which vmi_doubled_at computes theta_4(z + i zy), up to a real factor, which does not matter: only
   the angle of this complex number is used. This angle is the periodic part of the angle by which a torque-free body
   turns. z is pi u/(2K), and zy is pi y/(2K) with 0 <= y < K', where K' is K(1 - m). The nome of theta_4 is Q = q^2,
   where q is the nome of m. There are two forms of the series. The direct form is used for K <= 2K', so that
   Q <= exp(-pi):
     1 + sum over n >= 1 of (-1)^n (C_n cos 2nz - i S_n sin 2nz),
     C_n, S_n = e^(-(pi n/K)(2nK' - y)) +- e^(-(pi n/K)(2nK' + y)), with + for C_n and - for S_n.
   The transformed form, the theta series after Jacobi's imaginary transformation, is used for K > 2K'. Let Qd be
   exp(-pi K/(2K')), which is below exp(-pi), and v = (2n + 1) pi/(4K'). Then, for |u| <= K, the transformed form is
     e^(-i pi u y/(4KK')) times the sum over n >= 0 of
     Qd^(n(n+1)) (cosh vu cos vy + i sinh vu sin vy) e^(-pi |u|/(4K')).
   In both forms four terms leave an error of 1e-19. The sums are stored as polynomials: in cos 2z in the direct form,
   in Qd e^(+-pi |u|/(2K')) in the transformed form. */
typedef struct VM_TAG(vmi_doubled_theta) {
    vm_real decay; /* in the transformed form exp(-pi |u|/(2K')) is exp(-decay |x|), where x = u/(4K). If decay is 0,
                      the fields are those of the direct form, the Fourier series in cos 2nz and sin 2nz */
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
   K' = K(1 - m). For m = 1, where K is infinite, the argument x of vmi_doubled_at is u itself, not u/(4K), and `shift`
   is 0. */
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

/* Returns the polynomial a[0] + a[1] x + a[2] x^2 + a[3] x^3. */
VM_INLINE vm_real vmi_cubic(const vm_real *a, vm_real x) { return (a[0] + a[1] * x) + (a[2] + a[3] * x) * (x * x); }

/* Computes the real and the imaginary part of theta_4 at x = u/(4K), |x| <= 1/4. (If K is infinite, x is u and may be
   any number.) The factor e^(2 pi i shift x) is left out: the caller multiplies by it. */
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
/* jacobi/carlson.h - Carlson's symmetric elliptic integrals R_F, R_C, R_D, R_J and R_G

   Every elliptic integral is a sum of a few of these five:
     R_F(x, y, z)    = 1/2 integral from 0 to infinity of dt/s(t),  s(t) = sqrt((t + x)(t + y)(t + z)),
     R_J(x, y, z, p) = 3/2 integral from 0 to infinity of dt/((t + p) s(t)),
     R_C(x, y)       = R_F(x, y, y),
     R_D(x, y, z)    = R_J(x, y, z, z),
   and R_G, which gives the surface of an ellipsoid. No digits are lost. One method computes R_F, R_D and R_J for all
   arguments, without special formulas for some of them (such as m near 1).

       vm_real K = jacobi_RF(0, VM_C(0.75), 1); // K(m) = R_F(0, 1 - m, 1)

   Method: Carlson's duplication replaces each of the arguments x, y, z by a quarter of its sum with
   lambda = sqrt(x y) + sqrt(y z) + sqrt(z x). R_F keeps its value, and the new arguments are closer together. From R_D
   and R_J each duplication splits off a known term. Duplications are made until a power series about the mean of the
   arguments is exact enough. The equations are those of Carlson, Numer. Algorithms 10 (1995) 13-26, with more terms of
   the series, so that usually two or three duplications are enough. R_C is an arctangent or a logarithm, and R_G is a
   sum of terms with R_F and R_D. Source: DLMF 19.15 to 19.36. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_CARLSON_H
#define VARMASS_JACOBI_CARLSON_H

/* The three arguments of an integral, which duplications bring together. Each duplication makes the distances of the
   arguments from their mean, divided by the mean, about 4 times smaller. */
typedef struct VM_TAG(vmi_carlson) {
    vm_real x, y, z; /* the arguments */
    vm_real mean;    /* their mean (x + y + z)/3 */
    vm_real rest;    /* rounding error of the first mean, divided by 4 in each duplication: mean + rest is more exact */
    vm_real X, Y;    /* mean - x and mean - y; mean - z is -(X + Y) */
    vm_real a, b, c; /* the square roots of x, y, z in the last duplication */
    vm_real lambda;  /* a b + b c + c a in the last duplication */
} vmi_carlson;

/* The power series are used if each argument differs from the mean by at most this share of the mean. The largest terms
   that are left out have the degree 11 (float 5) in these differences; they are below 1e-17 (float 4e-9). */
#define VMI_CARLSON_CLOSE VM_C(0.0262)

/* Returns the numbers of vmi_carlson before the first duplication of x, y, z. */
VM_INLINE vmi_carlson vmi_carlson_begin(vm_real x, vm_real y, vm_real z)
{
    const vm_two part = vmi_two_sum(x, y), sum = vmi_two_sum(part.hi, z);
    vmi_carlson s;
    s.x = x;
    s.y = y;
    s.z = z;
    s.mean = sum.hi * VM_C(0.3333333333333333333);
    s.rest = (((sum.hi - 2 * s.mean) - s.mean) + (sum.lo + part.lo)) * VM_C(0.3333333333333333333);
    s.X = s.mean - x;
    s.Y = s.mean - y;
    s.a = s.b = s.c = s.lambda = 0;
    return s;
}

/* Returns the largest of the distances of x, y and z from their mean. */
VM_INLINE vm_real vmi_carlson_spread(const vmi_carlson *s)
{
    return vmi_larger(vmi_larger(VM_FABS(s->X), VM_FABS(s->Y)), VM_FABS(s->X + s->Y));
}

/* Makes one duplication (DLMF 19.26.18): replaces x by (x + lambda)/4, and y and z in the same way. No digits are lost,
   since no term is negative. */
VM_INLINE void vmi_carlson_duplicate(vmi_carlson *s)
{
    s->a = VM_SQRT(s->x);
    s->b = VM_SQRT(s->y);
    s->c = VM_SQRT(s->z);
    s->lambda = s->a * (s->b + s->c) + s->b * s->c;
    s->x = (s->x + s->lambda) * VM_C(0.25);
    s->y = (s->y + s->lambda) * VM_C(0.25);
    s->z = (s->z + s->lambda) * VM_C(0.25);
    s->mean = (s->mean + s->lambda) * VM_C(0.25);
    s->rest *= VM_C(0.25);
    s->X *= VM_C(0.25);
    s->Y *= VM_C(0.25);
}

/* Computes E2 = XY + YZ + ZX and E3 = XYZ. Here X, Y and Z are the differences mean - x, mean - y and mean - z, divided
   by the mean, so that X + Y + Z is 0. */
VM_INLINE void vmi_carlson_symmetric(const vmi_carlson *s, vm_real *E2, vm_real *E3)
{
    const vm_real per_mean = 1 / s->mean, X = s->X * per_mean, Y = s->Y * per_mean, Z = -(X + Y);
    *E2 = X * Y - Z * Z;
    *E3 = X * Y * Z;
}

/* Returns R_F from arguments that are close together. R_F is the sum over N >= 0 of t_N/(2N + 1), divided by the square
   root of the mean. Here t_N is the coefficient of s^N in the power series of (1 + E2 s^2 - E3 s^3)^(-1/2), with E2 and
   E3 of vmi_carlson_symmetric (DLMF 19.19.7). */
VM_INLINE vm_real vmi_carlson_first(const vmi_carlson *s)
{
    vm_real E2, E3, low, high = 0;
    vmi_carlson_symmetric(s, &E2, &E3);
    low = VM_C(0.07142857142857142857) * E3 - VM_C(0.1) * E2;
    low += E2 * (VM_C(0.04166666666666666667) * E2);
#if VM_MANT_DIG > 24
    {
        const vm_real E22 = E2 * E2, E33 = E3 * E3;
        const vm_real five = VM_C(-0.06818181818181818182) * (E2 * E3);                                 /* -3/44 */
        const vm_real six = VM_C(0.02884615384615384615) * E33 - VM_C(0.02403846153846153846) * (E22 * E2);
        const vm_real seven = VM_C(0.0625) * (E22 * E3);                                                /* 1/16 */
        const vm_real eight = E2 * (VM_C(0.01608455882352941176) * (E22 * E2) - VM_C(0.05514705882352941176) * E33);
        const vm_real nine = E3 * (VM_C(0.01644736842105263158) * E33 - VM_C(0.05756578947368421053) * (E22 * E2));
        const vm_real ten = E22 * (VM_C(0.078125) * E33 - VM_C(0.01171875) * (E22 * E2));
        high = (five + six) + ((seven + eight) + (nine + ten));
    }
#endif
    low -= s->rest / (2 * s->mean);
    return (1 + (low + high)) / VM_SQRT(s->mean);
}

/* Returns the product of `power` and R_J/3 from arguments x, y, z and p that are close together. The mean is that of x,
   y and z, and P is 1 - p/mean. R_J/3 is the sum over N >= 0 of T_N/(2N + 3), divided by mean^(3/2). Here T_N is the
   coefficient of s^N in the power series of (1 + E2 s^2 - E3 s^3)^(-1/2)/(1 - P s). `power` is divided by the mean
   first, because mean^(3/2) alone underflows if p was much larger than x, y and z before the duplications. */
VM_INLINE vm_real vmi_carlson_third(const vmi_carlson *s, vm_real P, vm_real power)
{
    vm_real E2, E3, t, T, sum;
    vmi_carlson_symmetric(s, &E2, &E3);
    T = P;
    sum = VM_C(0.6) * T;
    t = VM_C(-0.5) * E2;
    T = P * T + t;
    sum += VM_C(0.4285714285714285714) * T;
    t = VM_C(0.5) * E3;
    T = P * T + t;
    sum += VM_C(0.3333333333333333333) * T;
    t = VM_C(0.375) * (E2 * E2);
    T = P * T + t;
    sum += VM_C(0.2727272727272727273) * T;
#if VM_MANT_DIG > 24
    {
        const vm_real E22 = E2 * E2, E33 = E3 * E3, E222 = E22 * E2;
        T = P * T - VM_C(0.75) * (E2 * E3);
        sum += VM_C(0.2307692307692307692) * T;
        T = P * T + (VM_C(0.375) * E33 - VM_C(0.3125) * E222);
        sum += VM_C(0.2) * T;
        T = P * T + VM_C(0.9375) * (E22 * E3);
        sum += VM_C(0.1764705882352941176) * T;
        T = P * T + E2 * (VM_C(0.2734375) * E222 - VM_C(0.9375) * E33);
        sum += VM_C(0.1578947368421052632) * T;
        T = P * T + E3 * (VM_C(0.3125) * E33 - VM_C(1.09375) * E222);
        sum += VM_C(0.1428571428571428571) * T;
        T = P * T + E22 * (VM_C(1.640625) * E33 - VM_C(0.24609375) * E222);
        sum += VM_C(0.1304347826086956522) * T;
    }
#endif
    sum -= VM_C(1.5) * s->rest / s->mean;
    return (1 + sum) * (power / s->mean) / (3 * VM_SQRT(s->mean));
}

/* Returns R_F(x, y, z), within 5 ulp, for arguments >= 0 of which at most one is 0. */
VM_INLINE vm_real vmi_rf(vm_real x, vm_real y, vm_real z)
{
    vmi_carlson s = vmi_carlson_begin(x, y, z);
    vm_real spread = vmi_carlson_spread(&s);
    while (spread > VMI_CARLSON_CLOSE * s.mean) {
        vmi_carlson_duplicate(&s);
        spread *= VM_C(0.25);
    }
    return vmi_carlson_first(&s);
}

/* Adds a term to a sum. The rounding errors of the sum are collected in its low word. */
VM_INLINE void vmi_carlson_add(vm_two *sum, vm_real term)
{
    const vm_two more = vmi_two_sum(sum->hi, term);
    sum->hi = more.hi;
    sum->lo += more.lo;
}

/* Returns R_F(x, y, z), and R_D(x, y, z)/3 in *third, for x, y >= 0, of which at most one is 0, and z > 0. The same
   duplications serve both integrals. Each duplication adds a positive term to R_D/3, which is 1/(c (z + lambda)) times
   a power of 1/4 (DLMF 19.26.20); z + lambda is computed as (c + a)(c + b), with the fields a, b, c of vmi_carlson. */
VM_INLINE vm_real vmi_rf_rd(vm_real x, vm_real y, vm_real z, vm_real *third)
{
    vmi_carlson s = vmi_carlson_begin(x, y, z);
    vm_real spread = vmi_carlson_spread(&s), power = 1;
    vm_two sum = vmi_two(0, 0);
    while (spread > VMI_CARLSON_CLOSE * s.mean) {
        vmi_carlson_duplicate(&s);
        spread *= VM_C(0.25);
        vmi_carlson_add(&sum, power / (s.c * vmi_two_times(vmi_two_sum(s.c, s.a), vmi_two_sum(s.c, s.b)).hi));
        power *= VM_C(0.25);
    }
    *third = sum.hi + (sum.lo + vmi_carlson_third(&s, -(s.X + s.Y) / s.mean, power));
    return vmi_carlson_first(&s);
}

/* Returns R_C(1, 1 + e) for |e| <= 0.05 by its series 1 - e/3 + e^2/5 - ... */
VM_INLINE vm_real vmi_rc_series(vm_real e)
{
    const vm_real ee = e * e, e4 = ee * ee;
    const vm_real low = (VM_C(-0.3333333333333333333) + e * VM_C(0.2)) +
                        ee * (VM_C(-0.1428571428571428571) + e * VM_C(0.1111111111111111111));
#if VM_MANT_DIG > 24
    const vm_real middle = (VM_C(-0.09090909090909090909) + e * VM_C(0.07692307692307692308)) +
                           ee * (VM_C(-0.06666666666666666667) + e * VM_C(0.05882352941176470588));
    const vm_real high = VM_C(-0.05263157894736842105) + e * VM_C(0.04761904761904761905);
    return 1 + e * (low + e4 * (middle + e4 * high));
#else
    return 1 + e * (low - e4 * VM_C(0.09090909091));
#endif
}

/* Returns R_C(1, y) for y > 0 from both y and e = y - 1. Let r be sqrt(|e|). For y > 1 R_C(1, y) is arctan(r)/r. For
   y < 1 it is artanh(r)/r, which is computed as (ln(1 + r) - ln(y)/2)/r. For |e| < 0.18 these formulas would lose
   digits. There one duplication, which divides e by (1 + sqrt(y))^2, makes e small enough for the series of
   vmi_rc_series. */
VM_API vm_real vmi_rc_of_1(vm_real y, vm_real e)
{
    vm_real root;
    if (VM_FABS(e) < VM_C(0.18)) {
        const vm_real both = 1 + VM_SQRT(y);
        return 2 * vmi_rc_series(e / (both * both)) / both;
    }
    root = VM_SQRT(VM_FABS(e));
    if (e > 0) return vmi_arctan(root, 1) / root;
    return (vmi_two_log(vmi_two_sum(1, root)).hi - vmi_log(y).hi / 2) / root;
}

/* Returns R_C(x, y) for x >= 0 and y > 0 from x, y and e = y - x. If x, y and e have small relative errors, so has the
   result. */
VM_API vm_real vmi_rc_apart(vm_real x, vm_real y, vm_real e)
{
    if (e > x) return vmi_arctan(VM_SQRT(e), VM_SQRT(x)) / VM_SQRT(e);
    return vmi_rc_of_1(y / x, e / x) / VM_SQRT(x);
}

/* Returns R_C(x, y) for x >= 0 and y != 0. For y < 0 it is Cauchy's principal value (DLMF 19.2.17, 19.2.20). */
VM_API vm_real vmi_rc(vm_real x, vm_real y)
{
    vm_real factor = 1;
    if (y < 0) {
        factor = VM_SQRT(x) / VM_SQRT(x - y);
        x -= y;
        y = -y;
    }
    return factor * vmi_rc_apart(x, y, y - x);
}

/* A large power of 4, 2^500 (float 2^42), and its square root. jacobi_RJ for p > 0, and vmi_rf_rj_weighted where it
   scales the arguments, bring the largest argument to about this power instead of 1. The power 3/2 of the smallest
   argument then does not underflow, even if the arguments differ much in size. */
#if VM_MANT_DIG > 24
#define VMI_RJ_LIFT VM_C(3.273390607896142e+150)
#define VMI_ROOT_OF_RJ_LIFT VM_C(1.8092513943330656e+75)
#else
#define VMI_RJ_LIFT VM_C(4398046511104.0)
#define VMI_ROOT_OF_RJ_LIFT VM_C(2097152.0)
#endif

/* Returns R_F(x, y, z), and R_J(x, y, z, p)/3 in *third, for p > 0 and arguments x, y, z >= 0 of which at most one is
   0. Each duplication adds 2/d R_C(1, 1 + e), times a power of 1/4, to R_J/3 (DLMF 19.26.21 and Carlson 1995). Here
   d = (r + a)(r + b)(r + c) and r = sqrt(p), with the fields a, b, c of vmi_carlson. d grows as the power 3/2 of the
   arguments, and must neither overflow nor underflow: the callers choose arguments of which the largest is between eps
   and about 2^600 (float 2^80). d is computed as r p + p (a + b + c) + r lambda + a b c, which has fewer rounding
   errors than the product. Both 1 + e = 2 r (p + lambda)/d and e = (r - a)(r - b)(r - c)/d are computed, so that
   neither loses digits. */
VM_API vm_real vmi_rf_rj(vm_real x, vm_real y, vm_real z, vm_real p, vm_real *third)
{
    vmi_carlson s = vmi_carlson_begin(x, y, z);
    vm_real P = s.mean - p, spread = vmi_larger(vmi_carlson_spread(&s), VM_FABS(P)), power = 1;
    vm_two sum = vmi_two(0, 0);
    while (spread > VMI_CARLSON_CLOSE * s.mean) {
        const vm_real r = VM_SQRT(p);
        vm_real d, per_d, e;
        vmi_carlson_duplicate(&s);
        d = r * p + (p * (s.a + s.b + s.c) + (r * s.lambda + s.a * s.b * s.c));
        per_d = 1 / d;
        e = (r - s.a) * ((r - s.b) * (r - s.c)) * per_d;
        p += s.lambda;
        vmi_carlson_add(&sum, 2 * power * per_d * vmi_rc_of_1(2 * r * p * per_d, e));
        p *= VM_C(0.25);
        P *= VM_C(0.25);
        spread *= VM_C(0.25);
        power *= VM_C(0.25);
    }
    *third = sum.hi + (sum.lo + vmi_carlson_third(&s, P / s.mean, power));
    return vmi_carlson_first(&s);
}

/* The scale of the arguments of an integral. The arguments are multiplied by `factor`, a power of 4 that brings the
   largest of them to a number between 1 and 8, so that no power of this argument overflows or underflows. R_F and R_C
   of the new arguments are then multiplied by `root`, the square root of the factor, which gives their original
   values. */
typedef struct VM_TAG(vmi_carlson_scale) {
    vm_real factor, root;
} vmi_carlson_scale;

/* Returns the scale for arguments of which the largest is `largest`, a finite number > 0. A subnormal number is not
   brought to 1, since the factor would overflow; the product of such a number and the factor is at least eps. */
VM_API vmi_carlson_scale vmi_carlson_scale_of(vm_real largest)
{
    const int exponent = (int)(vmi_to_bits(largest) >> VMI_STORED_DIG) - VMI_BIAS;
    const int half = exponent < 1 - VMI_BIAS ? -(VMI_BIAS / 2) : (exponent - 1) / 2;
    vmi_carlson_scale scale;
    scale.factor = vmi_ldexp(1, -2 * half);
    scale.root = vmi_ldexp(1, -half);
    return scale;
}

/* Returns R_F(x, y, z), and the product of `weight` and R_D(x, y, z)/3 in *third, for arguments of any size. `top` is
   the largest argument; where it is not between eps and 1/eps, the arguments are scaled first. (A caller that has
   scaled them already passes top = 1.) With scaling, the product is right even if R_D itself would overflow or
   underflow. Without scaling, the product has two words, so that it is not rounded before it is used. */
VM_API vm_real vmi_rf_rd_weighted(vm_real x, vm_real y, vm_real z, vm_real top, vm_two weight, vm_two *third)
{
    vmi_carlson_scale by;
    vm_real rf, rd;
    if (top > VM_EPSILON && top < 1 / VM_EPSILON) {
        rf = vmi_rf_rd(x, y, z, &rd);
        *third = vmi_two_scaled(weight, rd);
        return rf;
    }
    by = vmi_carlson_scale_of(top);
    rf = vmi_rf_rd(by.factor * x, by.factor * y, by.factor * z, &rd);
    if (by.root < 1 && weight.hi < 1) *third = vmi_two(weight.hi * (by.root * (by.root * (by.root * rd))), 0);
    else *third = vmi_two(by.root * (by.root * weight.hi) * (by.root * rd), 0);
    return by.root * rf;
}

/* Returns R_F(x, y, z), and the product of `weight` and R_J(x, y, z, p)/3 in *third, for arguments of any size. `top`
   is the largest of x, y and z; where it is not between eps and 1/eps, the arguments are scaled first. (A caller that
   has scaled them already passes top = 1.) With scaling, the product is right even if R_J itself would overflow or
   underflow. Without scaling, the product has two words, so that it is not rounded before it is used. */
VM_API vm_real vmi_rf_rj_weighted(vm_real x, vm_real y, vm_real z, vm_real p, vm_real top, vm_real weight,
                                  vm_two *third)
{
    vmi_carlson_scale by;
    vm_real rf, rj;
    if (top > VM_EPSILON && top < 1 / VM_EPSILON) {
        rf = vmi_rf_rj(x, y, z, p, &rj);
        *third = vmi_two_product(weight, rj);
        return rf;
    }
    by = vmi_carlson_scale_of(top / VMI_RJ_LIFT);
    rf = vmi_rf_rj(by.factor * x, by.factor * y, by.factor * z, by.factor * p, &rj);
    *third = vmi_two(by.root * (by.root * weight) * (by.root * rj), 0);
    return by.root * rf;
}

/* Returns the product s (first + second), rounded to one word. The three arguments have two words each. Only two
   roundings change the result noticeably. */
VM_INLINE vm_real vmi_times_sum(vm_two s, vm_two first, vm_two second)
{
    vm_two sum = vmi_two_sum(first.hi, second.hi);
    sum.lo += first.lo + second.lo;
    return s.hi * sum.hi + (s.hi * sum.lo + s.lo * sum.hi);
}

/* Returns 1 if the scale `by` makes x > 0 subnormal or 0, else 0. It does so if x is much smaller than the largest
   argument, from which the scale was computed. */
VM_API int vmi_carlson_is_lost(vmi_carlson_scale by, vm_real x) { return x > 0 && by.factor * x < VM_MIN; }

/* Returns 1 if x, y, z >= 0, else 0. */
VM_API int vmi_carlson_allowed(vm_real x, vm_real y, vm_real z) { return x >= 0 && y >= 0 && z >= 0; }

/* Returns 1 if at least two of the three numbers, which are not negative, are 0, else returns 0. */
VM_API int vmi_two_zeros(vm_real x, vm_real y, vm_real z)
{
    return x + y == 0 || y + z == 0 || z + x == 0;
}

/* Returns the limit of R_F, R_C, R_D or R_J at arguments that are 0 or infinite. `zeros` is 1 if so many arguments are
   0 that the integral diverges: then the limit is infinity. `infinite` is 1 if an argument is infinite: then the limit
   is 0. If both are 1, there is no limit, and the result is NaN. */
VM_API vm_real vmi_carlson_limit(int zeros, int infinite)
{
    if (zeros && infinite) return VM_NAN;
    if (zeros) return VM_INFINITY;
    return 0;
}

/* Returns R_F where the largest argument is so great that sums of arguments would overflow. The function makes one
   duplication, divides the new arguments by 16, and takes R_F of the quotients, which is 4 times the result. Each term
   is divided before it is added, so that no sum overflows. After the duplication no argument is so small that products
   of arguments lose digits. */
VM_API vm_real vmi_rf_huge(vm_real x, vm_real y, vm_real z)
{
    const vm_real a = VM_SQRT(x) / 2, b = VM_SQRT(y) / 2, c = VM_SQRT(z) / 2;
    const vm_real lambda = a * (b / 16 + c / 16) + b / 16 * c;
    return VM_C(0.25) * vmi_rf(x / 64 + lambda, y / 64 + lambda, z / 64 + lambda);
}

/* R_F(x, y, z), Carlson's integral of the first kind, for x, y, z >= 0. R_F does not change if arguments are exchanged.
   The error is at most 8 ulp. R_F is infinite if two arguments are 0, and 0 if an argument is infinite. It is NaN if
   both hold, or if an argument is negative. K(m) is R_F(0, 1 - m, 1). With s = sin phi, F(phi | m) is s
   R_F(1 - s^2, 1 - m s^2, 1) for |phi| <= pi/2. DLMF 19.16.1. */
VM_API vm_real jacobi_RF(vm_real x, vm_real y, vm_real z)
{
    const vm_real largest = vmi_larger(vmi_larger(x, y), z);
    const int zeros = vmi_two_zeros(x, y, z), infinite = !VM_IS_FINITE(largest);
    vmi_carlson_scale by;
    if (!vmi_carlson_allowed(x, y, z)) return VM_NAN;
    if (zeros || infinite) return vmi_carlson_limit(zeros, infinite);
    if (largest > VM_MAX / 64) return vmi_rf_huge(x, y, z);
    if (largest > VM_MIN / vmi_fourth_power(VM_EPSILON)) return vmi_rf(x, y, z);
    by = vmi_carlson_scale_of(largest); /* without this scale products of two small arguments lose digits */
    return by.root * vmi_rf(by.factor * x, by.factor * y, by.factor * z);
}

/* R_C(x, y) = R_F(x, y, y), Carlson's elementary integral, for x >= 0 and any y. R_C is an arctangent for x < y and a
   logarithm for x > y. The error is at most 8 ulp. For y < 0 R_C is Cauchy's principal value. R_C is infinite if y is
   0, and 0 if an argument is infinite. It is NaN if both hold, or if x is negative. DLMF 19.2.17. */
VM_API vm_real jacobi_RC(vm_real x, vm_real y)
{
    const vm_real largest = vmi_larger(x, VM_FABS(y));
    vmi_carlson_scale by;
    if (!(x >= 0) || y != y) return VM_NAN;
    if (y == 0 || !VM_IS_FINITE(largest)) return vmi_carlson_limit(y == 0, !VM_IS_FINITE(largest));
    by = vmi_carlson_scale_of(largest);
    if (y < 0 && vmi_carlson_is_lost(by, x)) return -VM_SQRT(x) / y; /* the limit for a small x */
    if (!vmi_carlson_is_lost(by, VM_FABS(y))) return by.root * vmi_rc(by.factor * x, by.factor * y);
    return jacobi_RF(x, VM_FABS(y), VM_FABS(y)); /* R_C does not depend on the sign of a y this small */
}

/* R_D(x, y, z) = R_J(x, y, z, z), Carlson's integral of the second kind, for x, y, z >= 0. R_D does not change if x and
   y are exchanged. The error is at most 8 ulp. R_D is infinite if z = 0 or x = y = 0, and 0 if an argument is infinite.
   It is NaN if both hold, or if an argument is negative. It may be NaN, too, if one argument is more than 1e307 times
   (float 1e37) another one that is not 0. DLMF 19.16.5. */
VM_API vm_real jacobi_RD(vm_real x, vm_real y, vm_real z)
{
    const vm_real largest = vmi_larger(vmi_larger(x, y), z);
    const int zeros = z == 0 || x + y == 0, infinite = !VM_IS_FINITE(largest);
    vmi_carlson_scale by;
    vm_real rd;
    if (!vmi_carlson_allowed(x, y, z)) return VM_NAN;
    if (zeros || infinite) return vmi_carlson_limit(zeros, infinite);
    by = vmi_carlson_scale_of(largest);
    if (vmi_carlson_is_lost(by, x) || vmi_carlson_is_lost(by, y) || vmi_carlson_is_lost(by, z)) return VM_NAN;
    vmi_rf_rd(by.factor * x, by.factor * y, by.factor * z, &rd);
    return by.root * (by.root * (by.root * (3 * rd)));
}

/* Returns R_J(x, y, z, p) for p < 0, Cauchy's principal value of the integral, for 0 <= x, y <= z of which at most one
   is 0. R_J is computed from R_J(x, y, z, other), where `other` is a positive number (DLMF 19.20.14). */
VM_API vm_real vmi_rj_principal(vm_real x, vm_real y, vm_real z, vm_real p)
{
    const vm_real q = -p, other = (z * ((x + y) + q) - x * y) / (z + q), share = x * (y / other) + q;
    vm_real rf, rj, rest;
    rf = vmi_rf_rj(x, y, z, other, &rj);
    rest = 3 * ((other - z) * rj - rf);
    rest += 3 * VM_SQRT(x / other) * VM_SQRT(y / other) * VM_SQRT(z / share) * vmi_rc(share, q);
    return rest / (z + q);
}

/* R_J(x, y, z, p), Carlson's integral of the third kind, for x, y, z >= 0. R_J does not change if x, y and z are
   exchanged. For p > 0 the error is at most 8 ulp where no argument is more than 1e16 times another one, and at most 16
   ulp elsewhere. For p < 0 R_J is Cauchy's principal value, which has zeros: its error is at most 16 eps of R_J(x, y,
   z, |p|). R_J is infinite if p = 0; if two of x, y, z are 0, it is infinite with the sign of p. It is 0 if an argument
   is infinite. It is NaN if both hold, or if x, y or z is negative. It may be NaN, too, if one argument is more than
   1e307 times (float 1e37) another one that is not 0. DLMF 19.16.2. */
VM_API vm_real jacobi_RJ(vm_real x, vm_real y, vm_real z, vm_real p)
{
    const vm_real top = vmi_larger(vmi_larger(x, y), z), largest = vmi_larger(top, VM_FABS(p));
    const int zeros = p == 0 || vmi_two_zeros(x, y, z), infinite = !VM_IS_FINITE(largest);
    vmi_carlson_scale by;
    vm_real rj;
    if (!vmi_carlson_allowed(x, y, z) || p != p) return VM_NAN;
    if (zeros && !infinite && p < 0) return -VM_INFINITY;
    if (zeros || infinite) return vmi_carlson_limit(zeros, infinite);
    if (-p * VM_EPSILON * VM_EPSILON > top) return 3 * jacobi_RF(x, y, z) / p; /* the limit for a large |p| */
    by = vmi_carlson_scale_of(largest);
    if (vmi_carlson_is_lost(by, x) || vmi_carlson_is_lost(by, y) || vmi_carlson_is_lost(by, z)) return VM_NAN;
    if (vmi_carlson_is_lost(by, VM_FABS(p))) return VM_NAN;
    x *= by.factor;
    y *= by.factor;
    z *= by.factor;
    p *= by.factor;
    if (p > 0) {
        const vm_real lift = VMI_RJ_LIFT;
        vmi_rf_rj(lift * x, lift * y, lift * z, lift * p, &rj);
        rj *= 3 * lift * VMI_ROOT_OF_RJ_LIFT;
    }
    else if (x == by.factor * top) rj = vmi_rj_principal(y, z, x, p);
    else if (y == by.factor * top) rj = vmi_rj_principal(z, x, y, p);
    else rj = vmi_rj_principal(x, y, z, p);
    return by.root * (by.root * (by.root * rj));
}

/* R_G(x, y, z), Carlson's symmetric integral of the second kind, for x, y, z >= 0. The error is at most 10 ulp. R_G is
   infinite if an argument is infinite, and NaN if an argument is negative. E(m) is 2 R_G(0, 1 - m, 1), and an ellipsoid
   with the half axes a, b, c has the surface 4 pi R_G(a^2 b^2, b^2 c^2, c^2 a^2). DLMF 19.16.3. The function uses DLMF
   19.21.10 with the arguments exchanged so that z is neither the smallest nor the largest: then all terms are
   positive. */
VM_API vm_real jacobi_RG(vm_real x, vm_real y, vm_real z)
{
    const vm_real least = vmi_smaller(vmi_smaller(x, y), z), largest = vmi_larger(vmi_larger(x, y), z);
    vm_real middle = vmi_larger(vmi_smaller(x, y), vmi_smaller(vmi_larger(x, y), z)), low, high, rf, rd;
    vmi_carlson_scale by;
    if (!vmi_carlson_allowed(x, y, z)) return VM_NAN;
    if (!VM_IS_FINITE(largest)) return VM_INFINITY;
    by = vmi_carlson_scale_of(largest);
    if (middle == 0 || vmi_carlson_is_lost(by, middle)) return VM_SQRT(largest) / 2;
    low = by.factor * least;
    middle *= by.factor;
    high = by.factor * largest;
    rf = vmi_rf_rd(low, high, middle, &rd);
    rd *= (high - middle) * (middle - low);
    return (middle * rf + rd + VM_SQRT(low * high / middle)) / (2 * by.root);
}

#endif
/* jacobi/above_one.h - incomplete elliptic integrals for m > 1

   For m > 1 the root sqrt(1 - m sin^2 x) is real only up to the angle arcsin(1/k), where k = sqrt(m). Up to this angle,
   and at it, the integrals F, E, D and Pi have ordinary values; beyond this angle they are NaN. F gives the time in
   which a pendulum reaches an angle. Let a pendulum swing to and fro up to the angle A, let w0 be the frequency of its
   small oscillations in rad/s, and k = 1/sin(A/2). From its lowest point to the angle a it needs k F(a/2 | m)/w0
   seconds.

       vm_real u = jacobi_F(VM_C(0.4), VM_C(2.5)); // sn(u | 2.5) = sin 0.4

   Method: the reciprocal transformation leads to the parameter 1/m and the angle whose sine is k sin phi. In Carlson's
   integrals this transformation only exchanges the arguments cos^2 phi and 1 - m sin^2 phi. Near the angle arcsin(1/k)
   the number 1 - m sin^2 phi is a difference of nearly equal numbers, which loses digits, and the integrals change as
   the square root of this number. Therefore the sine and the cosine of phi are computed in two words: each is the sum
   of two floating-point numbers (a vm_two of base/words.h), which together have twice the digits of one. All functions
   of this file are internal; jacobi/incomplete.h calls them. Source: DLMF 19.7.4, 19.25. Tests:
   tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_ABOVE_ONE_H
#define VARMASS_JACOBI_ABOVE_ONE_H

/* Returns the sine of t in two words for 0 <= t <= 0.1, by its power series. The terms from t^11 on are so small that
   one word is enough for them. */
VM_API vm_two vmi_two_sine_series(vm_two t)
{
    const vm_two square = vmi_two_times(t, t);
    vm_real rest = 1;
    vm_two sum;
    int n;
    for (n = 19; n > 9; n -= 2) rest = 1 - square.hi / (vm_real)(n * (n - 1)) * rest;
    sum = vmi_two(rest, 0);
    for (; n > 1; n -= 2) {
        const vm_two part = vmi_two_over(square, vmi_two((vm_real)(n * (n - 1)), 0));
        sum = vmi_two_minus(vmi_two(1, 0), vmi_two_times(part, sum));
    }
    return vmi_two_times(t, sum);
}

/* Computes the sine and the cosine of z in two words for 0 <= z <= pi/4. The angle z/8, whose sine is computed by a
   power series, is doubled three times. */
VM_API void vmi_two_sin_cos(vm_two z, vm_two *sine, vm_two *cosine)
{
    const vm_two one = vmi_two(1, 0);
    vm_two s = vmi_two_sine_series(vmi_two_shifted(z, VM_C(0.125))), ss = vmi_two_times(s, s);
    vm_two c = vmi_two_root(vmi_two_minus(one, ss));
    int i;
    for (i = 0; i < 3; i++) {
        s = vmi_two_shifted(vmi_two_times(s, c), 2);
        c = vmi_two_minus(one, vmi_two_shifted(ss, 2));
        ss = vmi_two_times(s, s);
    }
    *sine = s;
    *cosine = c;
}

/* An angle phi between 0 and arcsin(1/k), with the numbers from which the integrals for m > 1 are computed */
typedef struct VM_TAG(vmi_above) {
    vm_two s, c;   /* sin phi and cos phi */
    vm_real cc;    /* cos^2 phi */
    vm_two share;  /* (m - 1) sin^2 phi, the difference cc - d */
    vm_real d;     /* 1 - m sin^2 phi = cc - share; d is below 0 or NaN where the integrals have no real value */
} vmi_above;

/* Returns sqrt(|x|) sin phi in two words. The root of |x| is taken first, so that the product neither overflows nor
   underflows. */
VM_API vm_two vmi_root_times_sine(vm_two x, const vmi_above *angle)
{
    if (x.hi < 0) x = vmi_minus(x);
    return vmi_two_times(vmi_two_root(x), angle->s);
}

/* Returns c^2 - x^2, computed as (c - x) (c + x), which has a small relative error. */
VM_API vm_real vmi_difference_of_squares(vm_two c, vm_two x)
{
    return vmi_two_times(vmi_two_minus(c, x), vmi_two_plus(c, x)).hi;
}

/* Returns the numbers of vmi_above for the angle |phi| and the number m1 = 1 - m < 0, which is given in two words. */
VM_API vmi_above vmi_above_of(vm_real phi, vm_two m1)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real x = VM_FABS(phi);
    vmi_above angle;
    vm_two z = vmi_two(x, 0), root;
    if (x <= half_pi.hi / 2) vmi_two_sin_cos(z, &angle.s, &angle.c);
    else {
        const vm_two sum = vmi_two_sum(half_pi.hi - x, half_pi.mid);
        z = vmi_fast_two_sum(sum.hi, sum.lo + half_pi.lo);
        vmi_two_sin_cos(z, &angle.c, &angle.s);
    }
    root = vmi_root_times_sine(m1, &angle);
    angle.cc = vmi_two_times(angle.c, angle.c).hi;
    angle.share = vmi_two_times(root, root);
    angle.d = vmi_difference_of_squares(angle.c, root);
    if (!(z.hi >= 0) || !VM_IS_FINITE(m1.hi)) angle.d = VM_NAN; /* |phi| is above pi/2 or NaN, or m is infinite */
    return angle;
}

/* Returns F(phi | m) for m > 1. With the fields s, cc, d of vmi_above, F is s R_F(cc, d, 1). */
VM_API vm_real vmi_F_above(vm_real phi, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    if (!(angle.d >= 0)) return VM_NAN;
    return VM_COPYSIGN(angle.s.hi * vmi_rf(angle.cc, angle.d, 1), phi);
}

/* Returns E(phi | m) for m > 1. Let s be sin phi, k = sqrt(m), M = 1/m, and B the angle whose sine is k s. Then E is
   k (E(B | M) - (1 - M) F(B | M)), but this difference would lose digits. The formula here is a sum of positive terms
   (DLMF 19.25.11). */
VM_API vm_real vmi_E_above(vm_real phi, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    vm_real third;
    if (!(angle.d >= 0)) return VM_NAN;
    vmi_rf_rd(angle.d, 1, angle.cc, &third);
    return VM_COPYSIGN(
        vmi_times_sum(angle.s, vmi_two(VM_SQRT(angle.d / angle.cc), 0), vmi_two_scaled(angle.share, third)), phi);
}

/* Returns D(phi | m) for m > 1. With the fields s, cc, d of vmi_above, D is s^3 R_D(cc, d, 1)/3. */
VM_API vm_real vmi_D_above(vm_real phi, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    const vm_two cube = vmi_two_times(vmi_two_times(angle.s, angle.s), angle.s);
    vm_real third;
    if (!(angle.d >= 0)) return VM_NAN;
    vmi_rf_rd(angle.cc, angle.d, 1, &third);
    return VM_COPYSIGN(vmi_two_scaled(cube, third).hi, phi);
}

/* Returns Pi(n; phi | m) for m > 1, n < 0 and phi >= 0. Let s be sin phi; p is 1 - n s^2. The reciprocal transformation
   leads to the parameter 1/m and the characteristic n/m. Then the characteristic N = (1 - n)/(m - n) replaces n/m (DLMF
   19.7.9), so that all terms are positive. In the function, q is 1 - N m s^2, and `gap` is p q - cos^2 phi. */
VM_API vm_real vmi_Pi_above_negative(const vmi_above *angle, vm_real n, vm_real m, vm_real m1, vm_real p)
{
    const vm_real s = angle->s.hi, ratio = n / m, per = 1 / (1 - ratio);
    const vm_real weight = -m1 / m * per * (angle->share.hi + s * s), q = angle->d + weight;
    const vm_real gap = -ratio * per * (1 - n) * s * s * angle->d;
    vm_two third, sum;
    const vm_real rf = vmi_rf_rj_weighted(angle->cc, angle->d, 1, q, 1, weight, &third);
    sum = vmi_two_plus(vmi_two_product(VM_SQRT(angle->d), vmi_rc_apart(angle->cc, p * q, gap)), third);
    return vmi_times_sum(angle->s, vmi_two(rf * per, 0), vmi_two_scaled(sum, ratio / (ratio - 1)));
}

/* Returns Pi(n; phi | m) for m > 1 and a finite n. Let s be sin phi and p = 1 - n s^2. For n > 1, p falls to 0 at a
   pole; therefore p is computed there from numbers in two words. For p < 0, which implies n > m, the formula of
   vmi_Pi_part for p < 0 is used: q is 1 - s^2 m/n, and R_C is Cauchy's principal value. */
VM_API vm_real vmi_Pi_above(vm_real phi, vm_real n, vm_real m, vm_two m1)
{
    const vmi_above angle = vmi_above_of(phi, m1);
    const vm_two less = vmi_two_sum(n, -1), root = vmi_root_times_sine(less, &angle);
    const vm_real s = angle.s.hi;
    vm_real p = angle.cc + root.hi * root.hi, q, rf;
    vm_two third;
    if (!(angle.d >= 0)) return VM_NAN;
    if (n < 0) return VM_COPYSIGN(vmi_Pi_above_negative(&angle, n, m, m1.hi, p), phi);
    if (n > 1) p = vmi_difference_of_squares(angle.c, root);
    if (p == 0) return VM_COPYSIGN(VM_INFINITY, phi);
    if (p > 0) {
        rf = vmi_rf_rj_weighted(angle.cc, angle.d, 1, p, 1, n * s * s, &third);
        return VM_COPYSIGN(vmi_times_sum(angle.s, vmi_two(rf, 0), third), phi);
    }
    q = angle.cc + vmi_two_plus(less, m1).hi / n * s * s;
    vmi_rf_rj_weighted(angle.cc, angle.d, 1, q, 1, m / n * s * s, &third);
    rf = vmi_rc(angle.cc * angle.d, p * q);
    return VM_COPYSIGN((vm_real)1, phi) * vmi_times_sum(angle.s, vmi_two(rf, 0), vmi_minus(third));
}

#endif
/* jacobi/incomplete.h - incomplete elliptic integrals F, E, D and Pi, and the complete D and Pi

     F(phi | m)     = integral of dx/sqrt(1 - m sin^2 x), the inverse of the amplitude am(u | m)
     E(phi | m)     = integral of sqrt(1 - m sin^2 x) dx
     D(phi | m)     = integral of sin^2 x dx/sqrt(1 - m sin^2 x), which is (F - E)/m
     Pi(n; phi | m) = integral of dx/((1 - n sin^2 x) sqrt(1 - m sin^2 x)), where n is the characteristic
   All integrals are from 0 to phi; with phi = pi/2 they are the complete integrals. For m = k^2 <= 1 the angle phi is
   any number of radians. For m > 1 it lies between -arcsin(1/k) and arcsin(1/k), where the square roots are real
   (jacobi/above_one.h). F is the time in which a pendulum reaches an angle, E the length of an arc of an ellipse, and
   Pi the precession of a spherical pendulum or a top.

       vm_real u = jacobi_F(VM_C(1.2), VM_C(0.5)); // am(u | 0.5) = 1.2

   Method: a multiple of pi is subtracted from phi, so that a rest theta with |theta| <= pi/2 is left. For this
   subtraction pi has three words, that is, it is a sum of three floating-point numbers. Each pi that was subtracted
   adds twice the complete integral. The integral from 0 to theta is a sum of Carlson's integrals. The terms of the sum
   are all positive, so that no digits are lost; the exception is Pi for n > 1 (see vmi_Pi_part). Source: DLMF 19.2,
   19.7, 19.25. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_INCOMPLETE_H
#define VARMASS_JACOBI_INCOMPLETE_H

/* An angle as the sum of a multiple of pi and a rest theta, |theta| <= pi/2 */
typedef struct VM_TAG(vmi_angle) {
    vm_real turns; /* phi = turns pi/2 + theta, with an even number `turns`. An integral from 0 to phi is the integral
                      from 0 to theta plus `turns` times the complete integral */
    vm_two s, c;   /* sin theta and cos theta, each within 0.4 ulp */
} vmi_angle;

/* Returns turns, sin theta and cos theta for the finite angle phi. If phi is so large that its digits do not determine
   theta, theta is taken as 0, and turns is 2 phi/pi, which then need not be an even number. */
VM_INLINE vmi_angle vmi_angle_of(vm_real phi)
{
    const vmi_three half_pi = vmi_half_pi();
    const vm_real x = VM_FABS(phi), count = x * VM_C(0.6366197723675813431), j = VM_FLOOR(count + VM_C(0.5));
    vm_two rest = vmi_two(x, 0);
    vmi_angle angle;
    vm_two sine, cosine;
    angle.turns = 0;
    if (j > 0) {
        const vm_two p = vmi_two_product(j, half_pi.hi), sum = vmi_two_sum(x - p.hi, -p.lo);
        rest = vmi_two_sum(sum.hi, sum.lo - j * half_pi.mid);
        rest.lo -= j * half_pi.lo;
        angle.turns = j;
    }
    if (!(j < VM_C(0.25) / VM_EPSILON)) {
        angle.turns = count;
        rest = vmi_two(0, 0);
    }
    vmi_sin_cos_words(rest, &sine, &cosine);
    angle.s = sine;
    angle.c = cosine;
    if (j < VM_C(0.25) / VM_EPSILON && j - 2 * VM_FLOOR(j / 2) > 0) { /* theta is rest + pi/2 or rest - pi/2 */
        const vm_real side = VM_COPYSIGN((vm_real)1, rest.hi);
        angle.turns = j + side;
        angle.s = vmi_two_shifted(cosine, -side);
        angle.c = vmi_two_shifted(sine, side);
    }
    if (phi < 0) {
        angle.turns = -angle.turns;
        angle.s = vmi_minus(angle.s);
    }
    return angle;
}

/* Returns 1 if an integral from 0 to phi for m <= 1 has no ordinary value, else 0. It has none if phi or m1 is infinite
   or NaN, or if m1 < 0. For m1 < 0, that is m > 1, jacobi/above_one.h has the integrals. */
VM_INLINE int vmi_incomplete_special(vm_real phi, vm_real m1)
{
    return !(VM_IS_FINITE(phi) && m1 >= 0 && VM_IS_FINITE(m1));
}

/* Returns turns * complete + part, an integral from 0 to phi. `complete` is the integral from 0 to pi/2, `part` the
   integral from 0 to theta. Where the terms are not huge, the result is rounded only once. If `complete` is infinite,
   the result is infinite with the sign of turns * complete, even if `part` is infinite with the other sign. */
VM_INLINE vm_real vmi_with_turns(vm_real turns, vm_real complete, vm_real part)
{
    const vm_real limit = VM_MAX * VM_EPSILON;
    const int safe = VM_FABS(turns) < 1 / VM_EPSILON && VM_FABS(complete) < limit && VM_FABS(part) < limit;
    if (safe) return vmi_two_plus(vmi_two_product(turns, complete), vmi_two(part, 0)).hi;
    if (!VM_IS_FINITE(complete)) return turns * complete;
    return turns * complete + part;
}

/* Returns F(phi | m) for 1 - m = m1 + m1_lo, a number in two words. */
VM_API vm_real vmi_F(vm_real phi, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real cc, ss, part;
    if (m1 < 0) return vmi_F_above(phi, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1)) {
        if (!(m1 >= 0) || phi != phi) return VM_NAN;
        if (VM_IS_FINITE(phi)) return 0 * phi; /* m is -infinity */
        if (VM_IS_FINITE(m1)) return phi;
        return VM_NAN;
    }
    angle = vmi_angle_of(phi);
    cc = angle.c.hi * angle.c.hi;
    ss = angle.s.hi * angle.s.hi;
    part = angle.s.hi * vmi_rf(cc, cc + m1 * ss, 1);
    if (angle.turns == 0) return part;
    return vmi_with_turns(angle.turns, vmi_K(m1, m1_lo), part);
}

/* F(phi | m), the incomplete elliptic integral of the first kind. F is the inverse of the amplitude. F is odd in phi,
   and for m <= 1, F(phi + pi) = F(phi) + 2K. The error is at most 8 ulp for |phi| <= 1e9 (float 1e4). For m <= 1 F is
   phi for infinite phi, 0 for m = -infinity, and NaN if both are infinite. For m = 1 F is infinite for |phi| > pi/2.
   For m > 1 F is NaN where m sin^2 phi > 1, for |phi| > pi/2, and for infinite m. docs/peers.md has the time of a call.
   DLMF 19.2.4, 19.25.5. */
VM_API vm_real jacobi_F(vm_real phi, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_F(phi, m1.hi, m1.lo);
}

/* F(phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_F. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_F_m1(vm_real phi, vm_real m1) { return vmi_F(phi, m1, 0); }

/* Returns x^2 for a number in two words, with two roundings. */
VM_INLINE vm_real vmi_squared(vm_two x) { return x.hi * x.hi + 2 * x.hi * x.lo; }

/* Returns E(theta | m) for |theta| <= pi/2 and m <= 1, from s = sin theta and c = cos theta. Both m and m1 = 1 - m are
   arguments, so that each has all its digits. One formula serves for m < 0, another one for m >= 0. All terms of both
   are positive (DLMF 19.25.9-10). */
VM_API vm_real vmi_E_part(vm_two s, vm_two c, vm_real m, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), dd = cc + m1 * ss;
    vm_real rf, rd;
    vm_two third;
    if (m < 0) {
        rf = vmi_rf_rd_weighted(cc, dd, 1, vmi_larger(dd, 1), vmi_two(-m * ss, 0), &third);
        return vmi_times_sum(s, vmi_two(rf, 0), third);
    }
    rf = vmi_rf_rd(cc, 1, dd, &rd);
    return vmi_times_sum(s, vmi_two_product(m1, rf + m * ss * rd), vmi_two_product(m, c.hi / VM_SQRT(dd)));
}

/* Returns E(phi | m) for 1 - m = m1 + m1_lo, a number in two words. */
VM_API vm_real vmi_E_incomplete(vm_real phi, vm_real m, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real part;
    if (m1 < 0) return vmi_E_above(phi, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1)) {
        if (!(m1 >= 0) || phi != phi) return VM_NAN;
        if (phi == 0 || !VM_IS_FINITE(phi)) return phi;
        return VM_COPYSIGN(VM_INFINITY, phi); /* m is -infinity */
    }
    angle = vmi_angle_of(phi);
    part = vmi_E_part(angle.s, angle.c, m, m1);
    if (angle.turns == 0) return part;
    return vmi_with_turns(angle.turns, vmi_E(m1, m1_lo), part);
}

/* E(phi | m), the incomplete elliptic integral of the second kind. E is odd in phi, and for m <= 1, E(phi + pi) =
   E(phi) + 2E(m). The error is at most 8 ulp for |phi| <= 1e9 (float 1e4). For m <= 1 E is phi for infinite phi. For m
   = -infinity E is infinite with the sign of phi, but 0 for phi = 0. For m > 1 E is NaN where m sin^2 phi > 1, for
   |phi| > pi/2, and for infinite m. docs/peers.md has the time of a call. DLMF 19.2.5. */
VM_API vm_real jacobi_E_incomplete(vm_real phi, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_E_incomplete(phi, m, m1.hi, m1.lo);
}

/* E(phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_E_incomplete. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_E_incomplete_m1(vm_real phi, vm_real m1) { return vmi_E_incomplete(phi, 1 - m1, m1, 0); }

/* Returns `lift`, a power of 2 that keeps Carlson's integrals from losing digits where a product of small arguments
   would underflow or a sum of large ones would overflow. The caller multiplies all arguments, and the weight of R_D or
   R_J, by lift^2, and the integral by lift, which gives the value for the original arguments. lift is 1 for ordinary
   arguments. It is above 1 only if m1 < 1, and below 1 only for a huge m1. `least` is about the smallest of the
   arguments. */
VM_INLINE vm_real vmi_lift_of(vm_real least, vm_real m1)
{
    if (m1 < 1 && least < VM_MIN / VM_EPSILON) return vmi_ldexp(1, VM_MANT_DIG > 24 ? 300 : 40);
    if (m1 > VM_MAX * VM_EPSILON) return VM_EPSILON;
    return 1;
}

/* Returns D(theta | m) for 0 <= theta <= pi/2 and m <= 1, from s = sin theta and c = cos theta, as s^3
   R_D(c^2, 1 - m s^2, 1)/3. */
VM_API vm_real vmi_D_part(vm_two s, vm_two c, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss;
    vm_two third;
    vmi_rf_rd_weighted(cc, d, 1, vmi_larger(d, 1), vmi_two_scaled(s, ss), &third);
    return third.hi;
}

/* Returns D(m) - D(theta | m) for 0 <= theta <= pi/2 and m <= 1, from s = sin theta and c = cos theta. With
   d = 1 - m s^2 the difference is c (s/sqrt(d) + c^2 R_D(m1 s^2, m1, d)/3), a sum of positive terms. */
VM_API vm_real vmi_D_complement(vm_two s, vm_two c, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss;
    const vm_real lift = vmi_lift_of(m1 * ss, m1), more = lift * lift, y = more * m1, z = more * d;
    vm_two third;
    vmi_rf_rd_weighted(y * ss, y, z, lift > 1 ? 1 : vmi_larger(z, y), vmi_two(more * cc, 0), &third);
    return vmi_times_sum(c, vmi_two(s.hi / VM_SQRT(d), 0), vmi_two_shifted(third, lift));
}

/* Returns D(m) for m1 = 1 - m. */
VM_API vm_real vmi_D(vm_real m1)
{
    if (!(m1 >= 0)) return VM_NAN;
    if (m1 == 0) return VM_INFINITY;
    if (!VM_IS_FINITE(m1)) return 0;
    return vmi_D_part(vmi_two(1, 0), vmi_two(0, 0), m1);
}

/* D(m) = (K(m) - E(m))/m, the complete elliptic integral D, for m <= 1. The error is at most 8 ulp for m >= -1e300
   (float -1e30). D is pi/4 for m = 0, infinite for m = 1, 0 for m = -infinity, and NaN for m > 1. DLMF 19.2.8. */
VM_API vm_real jacobi_D(vm_real m) { return vmi_D(1 - m); }

/* D(m) from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_D. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_D_m1(vm_real m1) { return vmi_D(m1); }

/* Returns D(phi | m) for 1 - m = m1 + m1_lo, a number in two words. For phi between pi/2 and pi, D(phi | m) is 2 D(m) -
   D(pi - phi | m), but this difference would triple the errors. Therefore the function adds the result of
   vmi_D_complement to D(m) there. */
VM_API vm_real vmi_D_incomplete(vm_real phi, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real turns, sum;
    vm_two s;
    if (m1 < 0) return vmi_D_above(phi, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1)) {
        if (!(m1 >= 0) || phi != phi) return VM_NAN;
        if (VM_IS_FINITE(phi)) return 0 * phi; /* m is -infinity */
        if (VM_IS_FINITE(m1)) return phi;
        return VM_NAN;
    }
    angle = vmi_angle_of(VM_FABS(phi));
    turns = angle.turns;
    s = angle.s.hi < 0 ? vmi_minus(angle.s) : angle.s;
    if (turns == 0) sum = vmi_D_part(s, angle.c, m1);
    else if (turns == 2 && angle.s.hi < 0 && m1 > 0) sum = vmi_D(m1) + vmi_D_complement(s, angle.c, m1);
    else sum = vmi_with_turns(turns, vmi_D(m1), VM_COPYSIGN(vmi_D_part(s, angle.c, m1), angle.s.hi));
    return VM_COPYSIGN(sum, phi);
}

/* D(phi | m) = (F(phi | m) - E(phi | m))/m, the incomplete integral of sin^2 x/sqrt(1 - m sin^2 x). No digits are lost,
   not even for m = 0. D is odd in phi, and for m <= 1, D(phi + pi) = D(phi) + 2D(m). The error is at most 8 ulp for
   |phi| <= 1e9 (float 1e4) and m >= -1e300 (float -1e30), unless phi^3 underflows. For m <= 1 D is phi for infinite
   phi, 0 for m = -infinity, and NaN if both are infinite. For m = 1 D is infinite for |phi| > pi/2. For m > 1 D is NaN
   where m sin^2 phi > 1, for |phi| > pi/2, and for infinite m. A call takes as long as one of jacobi_E_incomplete. DLMF
   19.2.6, 19.25.13. */
VM_API vm_real jacobi_D_incomplete(vm_real phi, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_D_incomplete(phi, m1.hi, m1.lo);
}

/* D(phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_D_incomplete. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_D_incomplete_m1(vm_real phi, vm_real m1) { return vmi_D_incomplete(phi, m1, 0); }

/* Returns 1 - m/n for n > 1 and m1 = 1 - m >= 0. All terms are divided by 4 first, so that no sum overflows. */
VM_INLINE vm_real vmi_share_below_pole(vm_real n, vm_real m1)
{
    return ((n - 1) * VM_C(0.25) + m1 * VM_C(0.25)) / (n * VM_C(0.25));
}

/* Returns Pi(n; theta | m) for |theta| <= pi/2, from s = sin theta and c = cos theta, with 1 - m = m1. Let
   p = 1 - n s^2 and d = 1 - m s^2. There are three formulas:
     n < 0: the characteristic N = (m - n)/(1 - n), which lies between m and 1, replaces n (DLMF 19.7.9). q is
            1 - N s^2 = c^2 + s^2 m1/(1 - n). R_C depends on `gap`, the difference p q - d, which is -n N s^2 c^2.
     n >= 0 and p > 0: the result is s R_F + n s^3 R_J/3 (DLMF 19.25.14).
     p < 0: the characteristic m/n replaces n (DLMF 19.7.8). q is 1 - s^2 m/n, and R_C is Cauchy's principal value.
   Each formula is a sum of positive terms, except that the third one has a negative term if m > 0. For p = 0 the result
   is infinite, with the sign of s. */
VM_API vm_real vmi_Pi_part(vm_two s, vm_two c, vm_real n, vm_real m, vm_real m1)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss, top = vmi_larger(d, 1);
    const vm_real p = cc + (1 - n) * ss;
    vm_real q, share, rf, gap;
    vm_two third, sum;
    if (n < 0) {
        share = m1 / (1 - n);
        q = cc + share * ss;
        gap = n / (1 - n) * (n - m) * ss * cc;
        rf = vmi_rf_rj_weighted(cc, d, 1, q, top, share * ss, &third);
        sum = vmi_two_plus(vmi_two_product(c.hi, vmi_rc_apart(d, p * q, gap)), third);
        return vmi_times_sum(s, vmi_two(rf / (1 - n), 0), vmi_two_scaled(sum, n / (n - 1)));
    }
    if (p > 0) {
        rf = vmi_rf_rj_weighted(cc, d, 1, p, top, n * ss, &third);
        return vmi_times_sum(s, vmi_two(rf, 0), third);
    }
    if (p == 0) return VM_COPYSIGN(VM_INFINITY, s.hi);
    q = cc + vmi_share_below_pole(n, m1) * ss;
    vmi_rf_rj_weighted(cc, d, 1, q, top, m / n * ss, &third);
    return vmi_times_sum(s, vmi_two(vmi_rc(cc * d, p * q), 0), vmi_minus(third));
}

/* Returns Pi(n | m) for n < 0 and m1 = 1 - m > 0. The factor `lift`, a power of 2 from vmi_lift_of, keeps numbers from
   underflowing. For a very large -n, however, (1 - m)/(1 - n) may underflow even after it is multiplied by lift^2.
   There the result is the sum (pi/2)/sqrt(1 - n) + K(m)/(1 - n), which begins a series; the next term, -E(m)/(1 - n),
   is far below an ulp. */
VM_API vm_real vmi_Pi_negative(vm_real n, vm_real m1)
{
    const vm_real lift = vmi_lift_of(m1 / (1 - n), m1), more = lift * lift, share = more * m1 / (1 - n);
    vm_real rf;
    vm_two third;
    if (lift > 1 && n < -1000 / (VM_EPSILON * VM_EPSILON))
        return VM_PI / 2 / VM_SQRT(1 - n) + vmi_K(m1, 0) / (1 - n);
    rf = vmi_rf_rj_weighted(0, more * m1, more, share, lift > 1 ? 1 : more * vmi_larger(m1, 1), share, &third);
    return lift * vmi_two_plus(vmi_two(rf / (1 - n), 0), vmi_two_scaled(third, n / (n - 1))).hi;
}

/* Returns Pi(n | m), from both m and m1 = 1 - m. The formulas for n < 0, 0 <= n < 1 and n > 1 are those of vmi_Pi_part
   for theta = pi/2. */
VM_API vm_real vmi_Pi(vm_real n, vm_real m, vm_real m1)
{
    const vm_real top = vmi_larger(m1, 1);
    vm_real rf;
    vm_two third;
    if (!(m1 >= 0) || n != n) return VM_NAN;
    if (!VM_IS_FINITE(n) || !VM_IS_FINITE(m1)) {
        if (VM_IS_FINITE(n) && n < 1) return 0; /* m is -infinity */
        if (!VM_IS_FINITE(n) && VM_IS_FINITE(m1) && m1 > 0) return 0;
        return VM_NAN;
    }
    if (n == 1) return VM_INFINITY;
    if (m1 == 0) return VM_COPYSIGN(VM_INFINITY, 1 - n);
    if (n < 0) return vmi_Pi_negative(n, m1);
    if (n < 1) {
        rf = vmi_rf_rj_weighted(0, m1, 1, 1 - n, top, n, &third);
        return vmi_two_plus(vmi_two(rf, 0), third).hi;
    }
    vmi_rf_rj_weighted(0, m1, 1, vmi_share_below_pole(n, m1), top, m / n, &third);
    return 0 - third.hi;
}

/* Pi(n | m), the complete elliptic integral of the third kind, for m <= 1. The characteristic n is any number. The
   error is at most 8 ulp. For n > 1 Pi is Cauchy's principal value. Pi is infinite for n = 1 and a finite m. For m = 1
   Pi is infinite for every finite n, with the sign of 1 - n. Pi is 0 for infinite n and a finite m < 1, and for
   m = -infinity and a finite n < 1. Pi is NaN for m > 1, for infinite n with m = 1 or m = -infinity, and for
   m = -infinity with n >= 1. DLMF 19.2.8, 19.6.5. */
VM_API vm_real jacobi_Pi(vm_real n, vm_real m) { return vmi_Pi(n, m, 1 - m); }

/* Pi(n | m) from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_Pi. Use it for m close to 1, where the difference 1 - m would lose digits. */
VM_API vm_real jacobi_Pi_m1(vm_real n, vm_real m1) { return vmi_Pi(n, 1 - m1, m1); }

/* Returns Pi(n | m) - Pi(n; theta | m) for n < 1 and 0 <= theta <= pi/2, from s = sin theta and c = cos theta. Let psi
   be the angle for which tan theta tan psi = 1/k', and N = (m - n)/(1 - n). Then the result is the integral from 0 to
   psi of (1 - m sin^2 x)/((1 - n)(1 - N sin^2 x)) dx/sqrt(1 - m sin^2 x). The function computes this integral as the
   sum of a term with R_F and a term with R_J. For n > 0 the term with R_J is negative, so that the sum has larger
   errors than its terms. `complete` is Pi(n | m). If the term with R_F is larger than `complete`, *exact becomes 0;
   then the difference 2 Pi(n | m) - Pi(n; theta | m) is a more exact way to Pi(n; pi - theta | m). Otherwise *exact
   becomes 1. */
VM_API vm_real vmi_Pi_complement(vm_two s, vm_two c, vm_real n, vm_real m1, vm_real complete, int *exact)
{
    const vm_real cc = vmi_squared(c), ss = vmi_squared(s), d = cc + m1 * ss;
    const vm_real least = vmi_smaller(ss, 1 / (1 - n)) * m1, lift = vmi_lift_of(least, m1);
    const vm_real more = lift * lift;
    const vm_real y = more * m1, z = more * d, share = y / (1 - n), p = y * ss + share * cc;
    const vm_real top = lift > 1 ? 1 : vmi_larger(z, y);
    vm_two third;
    const vm_real rf = vmi_rf_rj_weighted(y * ss, y, z, p, top, -n * share * cc, &third);
    *exact = lift * (c.hi * rf / (1 - n)) <= complete;
    return lift * (vmi_times_sum(c, vmi_two(rf, 0), third) / (1 - n));
}

/* Returns Pi(n; phi | m) for 1 - m = m1 + m1_lo, a number in two words. For phi between pi/2 and pi, Pi(n; phi | m) is
   2 Pi(n | m) - Pi(n; pi - phi | m), but this difference usually triples the errors. Therefore, for n < 1, the function
   adds the result of vmi_Pi_complement to Pi(n | m) there, if vmi_Pi_complement reports that this sum is more exact. */
VM_API vm_real vmi_Pi_incomplete(vm_real phi, vm_real n, vm_real m, vm_real m1, vm_real m1_lo)
{
    vmi_angle angle;
    vm_real part;
    if (m1 < 0 && VM_IS_FINITE(n)) return vmi_Pi_above(phi, n, m, vmi_two(m1, m1_lo));
    if (vmi_incomplete_special(phi, m1) || !VM_IS_FINITE(n)) {
        const vm_real complete = vmi_Pi(n, m, m1);
        if (!(m1 >= 0) || phi != phi || complete != complete) return VM_NAN;
        if (VM_IS_FINITE(phi)) return 0 * phi; /* n or m is infinite, and Pi(n | m) is 0 */
        if (complete == 0) return VM_NAN;
        return VM_COPYSIGN(phi, phi * complete);
    }
    angle = vmi_angle_of(phi);
    if (VM_FABS(angle.turns) == 2 && angle.s.hi * angle.turns < 0 && n < 1 && m1 > 0) {
        const vm_two s = angle.s.hi < 0 ? vmi_minus(angle.s) : angle.s;
        const vm_real complete = vmi_Pi(n, m, m1);
        int exact;
        part = vmi_Pi_complement(s, angle.c, n, m1, complete, &exact);
        if (exact) return VM_COPYSIGN(complete + part, phi);
    }
    part = vmi_Pi_part(angle.s, angle.c, n, m, m1);
    if (angle.turns == 0) return part;
    return vmi_with_turns(angle.turns, vmi_Pi(n, m, m1), part);
}

/* Pi(n; phi | m), the incomplete elliptic integral of the third kind. The characteristic n is any number. Pi is odd in
   phi, and for m <= 1, Pi(phi + pi) = Pi(phi) + 2 Pi(n | m). The error is at most 8 ulp for n <= 1 and |phi| <= 1e9
   (float 1e4). For n > 1 Pi has poles where n sin^2 phi = 1; if rounding makes n sin^2 phi equal to 1, Pi is infinite.
   Beyond the first pole Pi is Cauchy's principal value. For n > 1 the error is at most 16 eps max(|F|, |Pi|), plus the
   effect of changing n by 4 ulp. For a finite phi, Pi is 0 for infinite n and a finite m < 1, and for m = -infinity and
   a finite n < 1. Pi is NaN for those infinite n or m for which jacobi_Pi(n, m) is NaN. For infinite phi and m <= 1, Pi
   is infinite with the sign of phi Pi(n | m), and NaN if Pi(n | m) is 0 or NaN. For m > 1 Pi is NaN where m sin^2 phi >
   1, for |phi| > pi/2, and for infinite m or n. docs/peers.md has the time of a call. DLMF 19.2.7. */
VM_API vm_real jacobi_Pi_incomplete(vm_real phi, vm_real n, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_Pi_incomplete(phi, n, m, m1.hi, m1.lo);
}

/* Pi(n; phi | m) from the complementary parameter m1 = 1 - m.
   Domain and accuracy are those of jacobi_Pi_incomplete. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_Pi_incomplete_m1(vm_real phi, vm_real n, vm_real m1)
{
    return vmi_Pi_incomplete(phi, n, 1 - m1, m1, 0);
}

#endif
/* base/hypot.h - the length of a vector in the plane

   Tests: tests/test_jumps.c, tests/test_laws.c. */
#ifndef VARMASS_BASE_HYPOT_H
#define VARMASS_BASE_HYPOT_H

/* Returns the length sqrt(x^2 + y^2), also where the squares overflow or underflow, and NaN if x or y is NaN. */
VM_API vm_real vmi_hypot(vm_real x, vm_real y)
{
    const vm_real a = VM_FABS(x), b = VM_FABS(y), most = vmi_larger(a, b), least = vmi_smaller(b, a);
    vm_real q = 0;
    if (x != x || y != y) return VM_NAN;
    if (most > VM_MAX) return most;
    if (most > 0) q = least / most;
    return most * VM_SQRT(1 + q * q);
}

#endif
/* jacobi/inverse.h - the inverses of sn, cn and dn

   Each function returns the solution u of sn(u | m) = x, cn(u | m) = x or dn(u | m) = x that is nearest to 0. The
   solutions for cn and dn are pairs u, -u; for these the positive u is returned. All other solutions follow from the
   period 4 K and the symmetries. The inverse of the amplitude is F(phi | m), which jacobi_F computes.

       vm_real u = jacobi_inverse_cn(VM_C(0.3), VM_C(0.5)); // cn(u | 0.5) = 0.3

   Equations: DLMF 22.15, 19.25.31. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_INVERSE_H
#define VARMASS_JACOBI_INVERSE_H

/* Returns the inverse of sn for 1 - m = m1 + m1_lo, a number in two words. The difference 1 - x^2 is computed as the
   product (1 - x)(1 + x), so that no digits are lost. */
VM_API vm_real vmi_inverse_sn(vm_real x, vm_real m1, vm_real m1_lo)
{
    const vm_real cc = (1 - x) * (1 + x);
    if (!(VM_FABS(x) <= 1) || !(m1 >= 0)) return VM_NAN;
    if (!VM_IS_FINITE(m1)) return 0 * x;
    if (cc == 0) return x * vmi_K(m1, m1_lo);
    return x * vmi_rf(cc, cc + m1 * (x * x), 1);
}

/* The inverse of sn: u with sn(u | m) = x and |u| <= K, for |x| <= 1 and m <= 1. The result is odd in x. The error is
   at most 8 ulp; for x = 1 the result has the same bits as jacobi_K(m). For m = 1 the function is the inverse of tanh,
   infinite for |x| = 1. Returns 0 for m = -infinity, and NaN for |x| > 1 and for m > 1. DLMF 22.15.12. */
VM_API vm_real jacobi_inverse_sn(vm_real x, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_inverse_sn(x, m1.hi, m1.lo);
}

/* The inverse of sn from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_inverse_sn. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_inverse_sn_m1(vm_real x, vm_real m1) { return vmi_inverse_sn(x, m1, 0); }

/* Returns ln(4/(x + root)), the limit of u for tiny numbers x = dn u and root = |cn u|, or the reverse, where m is 1 or
   next to it. */
VM_API vm_real vmi_inverse_next_to_1(vm_real x, vm_real root)
{
    return VM_C(1.386294361119890572454) - vmi_log(x + root).hi;
}

/* Returns the inverse of cn for 1 - m = m1 + m1_lo, a number in two words. For x >= 0 the inverse is at most K. For
   x < 0 it is 2 K minus the inverse at |x|. */
VM_API vm_real vmi_inverse_cn(vm_real x, vm_real m1, vm_real m1_lo)
{
    const vm_real ss = (1 - x) * (1 + x), cc = x * x;
    vm_real u;
    if (!(VM_FABS(x) <= 1) || !(m1 >= 0)) return VM_NAN;
    if (!VM_IS_FINITE(m1)) return 0;
    if (m1 == 0 && x < 0) return VM_NAN;
    if (x == 0) return vmi_K(m1, m1_lo);
    if (cc + m1 < VM_MIN / VM_EPSILON) u = vmi_inverse_next_to_1(VM_FABS(x), vmi_hypot(x, VM_SQRT(m1)));
    else u = VM_SQRT(ss) * vmi_rf(cc, cc + m1 * ss, 1);
    if (x < 0) return 2 * vmi_K(m1, m1_lo) - u;
    return u;
}

/* The inverse of cn: u with cn(u | m) = x and 0 <= u <= 2K, for |x| <= 1 and m <= 1. The error is at most 8 ulp; for
   x = 0 the result has the same bits as jacobi_K(m). For m = 1 the function is the inverse of 1/cosh, infinite for
   x = 0 and NaN for x < 0. Returns 0 for m = -infinity, and NaN for |x| > 1 and for m > 1. DLMF 22.15.13. */
VM_API vm_real jacobi_inverse_cn(vm_real x, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    return vmi_inverse_cn(x, m1.hi, m1.lo);
}

/* The inverse of cn from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_inverse_cn. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_inverse_cn_m1(vm_real x, vm_real m1) { return vmi_inverse_cn(x, m1, 0); }

/* Returns the inverse of dn for a tiny x, whose square may underflow; then m1 <= x^2 is tiny, too. |cn u| is the root
   of x^2 - m1, which is computed with x and m1 multiplied by large powers of 4. */
VM_API vm_real vmi_inverse_dn_next_to_1(vm_real x, vm_real m1, vm_real m1_lo)
{
    const vm_real lift = VMI_RJ_LIFT;
    const vm_two lifted = vmi_two_product(lift * x, lift * x);
    const vm_real rest = (lifted.hi - lift * lift * m1) + lifted.lo;
    if (x == 0) return VM_INFINITY;
    if (m1 == 0) return vmi_inverse_next_to_1(x, x);
    if (!(rest > 0)) return vmi_K(m1, m1_lo);
    return vmi_inverse_next_to_1(x, VM_SQRT(rest) / lift);
}

/* Returns the inverse of dn for 1 - m = m1 + m1_lo, a number in two words. With s = sn u and c = cn u, s^2 is
   (1 - x^2)/m, and c^2 is (x^2 - m1)/m. The difference x^2 - m1 is computed from the exact square of x. If x is the
   rounded value of k', the computed c^2 may be negative, and s^2 above 1; then c is 0, and the inverse is K. */
VM_API vm_real vmi_inverse_dn(vm_real x, vm_real m, vm_real m1, vm_real m1_lo)
{
    const vm_real bound = VM_SQRT(m1);
    const vm_two square = vmi_two_product(x, x);
    vm_real ss, cc;
    if (!(x >= vmi_smaller(bound, 1) && x <= vmi_larger(bound, 1)) || !(m1 >= 0)) return VM_NAN;
    if (x == 1) return 0;
    if (square.hi < VM_MIN / VM_EPSILON) return vmi_inverse_dn_next_to_1(x, m1, m1_lo);
    cc = ((square.hi - m1) + (square.lo - m1_lo)) / m;
    if (!(cc > 0)) return vmi_K(m1, m1_lo);
    ss = vmi_smaller((1 - x) * (1 + x) / m, 1);
    return VM_SQRT(ss) * vmi_rf(cc, square.hi, 1);
}

/* The inverse of dn: u with dn(u | m) = x and 0 <= u <= K, for x between 1 and sqrt(1 - m), m <= 1. The error is at
   most 8 ulp. For m = 1 the function is the inverse of 1/cosh, infinite for x = 0. Returns NaN for m > 1, for infinite
   m, and for an x that is not between 1 and sqrt(1 - m). For m = 0 dn is 1 everywhere; then u is 0 for x = 1. DLMF
   22.15.14. */
VM_API vm_real jacobi_inverse_dn(vm_real x, vm_real m)
{
    const vm_two m1 = vmi_two_sum(1, -m);
    if (!VM_IS_FINITE(m)) return VM_NAN;
    return vmi_inverse_dn(x, m, m1.hi, m1.lo);
}

/* The inverse of dn from the complementary parameter m1 = 1 - m >= 0.
   Domain and accuracy are those of jacobi_inverse_dn. Use it for m close to 1, where the difference 1 - m would lose
   digits. */
VM_API vm_real jacobi_inverse_dn_m1(vm_real x, vm_real m1)
{
    if (!VM_IS_FINITE(m1)) return VM_NAN;
    return vmi_inverse_dn(x, 1 - m1, m1, 0);
}

#endif
/* jacobi/reciprocal.h - sn, cn and dn for any parameter, also for m > 1

   For m > 1 the roles of cn and dn change: dn oscillates between 1 and -1, and cn stays positive. A pendulum whose
   small oscillations have the frequency w0, and which passes its lowest point with the angular velocity W at t = 0,
   has the modulus k = W/(2 w0). It swings for m = k^2 < 1 and rotates for m > 1. In both cases its angle is given by
   sin(angle/2) = k sn(w0 t | m), cos(angle/2) = dn(w0 t | m), and its angular velocity is W cn(w0 t | m).

       vm_real sn, cn, dn;
       jacobi_sncndn_any(VM_C(1.2), VM_C(2.5), &sn, &cn, &dn);

   Equations: DLMF 22.17.2-4. Tests: tests/test_elliptic_integrals.c. */
#ifndef VARMASS_JACOBI_RECIPROCAL_H
#define VARMASS_JACOBI_RECIPROCAL_H

/* sn, cn and dn of the argument u for any finite parameter m. For m <= 1 the results are those of jacobi_sncndn. For
   m > 1 they are
     sn(u | m) = sn(k u | 1/m)/k,  cn(u | m) = dn(k u | 1/m),  dn(u | m) = cn(k u | 1/m),  k = sqrt(m).
   For m > 1 the error is at most 4 eps (4 eps/k for sn) for |k u| <= 1e9 (float 1e4). For |u| <= 100 K(1/m)/k it is at
   most 8 ulp plus the change that the error of k u, a number in two words, makes; this change matters only next to a
   zero of sn or dn. Returns NaN for infinite m. For m > 1 the product k u is computed in two words. Its second word,
   the variable h, changes sn, cn and dn a little; two terms of their Taylor series in h add this change. */
VM_API void jacobi_sncndn_any(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_two k, phase, m1;
    vm_real s, c, d, h, scale = 1;
    if (!(m > 1) || !VM_IS_FINITE(m) || !VM_IS_FINITE(u)) {
        jacobi_sncndn(u, m, sn, cn, dn);
        return;
    }
    k = vmi_root(m, 0);
    if (VM_FABS(u) > 20 / VM_EPSILON / k.hi) { /* k u is above K/eps for every m > 1 */
        *sn = 0 * u;
        *cn = *dn = 1;
        return;
    }
    if (m > VM_MAX * VM_EPSILON) scale = VM_EPSILON; /* keeps the quotient m1 from overflowing */
    m1 = vmi_two_over(vmi_two_sum(m * scale, -scale), vmi_two(m * scale, 0));
    phase = vmi_two_scaled(k, u);
    vmi_sncndn(phase.hi, m1.hi, m1.lo, &s, &c, &d);
    h = phase.lo;
    if (!(VM_FABS(phase.hi) < 1 / VM_EPSILON)) h = 0; /* the series needs a small h */
    *sn = vmi_clamp(s + h * (c * d - h / 2 * s * (d * d + c * c / m)), -1, 1) / k.hi;
    *cn = vmi_clamp(d - h / m * (s * c + h / 2 * d * (c * c - s * s)), 0, 1);
    *dn = vmi_clamp(c - h * (s * d + h / 2 * c * (d * d - s * s / m)), -1, 1);
}

#endif

VMI_QUIET_END

#endif
