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
