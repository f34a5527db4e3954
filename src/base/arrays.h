/* base/arrays.h - loops over arrays of numbers
   vmi_all_finite tests whether all numbers of an array are finite, and vmi_copy copies an array. The macro VMI_EACH
   writes a loop over the n components of a state. Where the compiler knows that n is small, it unrolls the loop and
   keeps the components in registers.

       vm_real y[3] = {1, 2, 3}, z[3];
       if (vmi_all_finite(3, y)) vmi_copy(3, y, z);

   Tests: tests/test_rk4.c and the other tests of the integrators. */
#ifndef VARMASS_BASE_ARRAYS_H
#define VARMASS_BASE_ARRAYS_H

#include "real.h"

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
