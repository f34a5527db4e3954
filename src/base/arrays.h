/* base/arrays.h - loops over arrays of numbers
   Whether all numbers of an array are finite, copies, and the loops over the components of a small state, which the
   compiler unrolls where it knows the number n of components, so that they live in registers.

       vm_real y[3] = {1, 2, 3}, z[3];
       if (vmi_all_finite(3, y)) vmi_copy(3, y, z);

   Tests: tests/test_rk4.c and all others of the integrators. */
#ifndef VARMASS_BASE_ARRAYS_H
#define VARMASS_BASE_ARRAYS_H

#include "real.h"

/* Whether none of the n numbers is infinite or NaN */
VM_API int vmi_all_finite(int n, const vm_real *y)
{
    int i;
    for (i = 0; i < n; i++)
        if (!VM_IS_FINITE(y[i])) return 0;
    return 1;
}

/* A loop `VMI_EACH(i, n) statement` over components, unrolled where the compiler knows n. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) && __GNUC__ >= 8 && defined(__OPTIMIZE__) && \
    !defined(__OPTIMIZE_SIZE__)
#define VMI_UNROLL _Pragma("GCC unroll 16")
#else
#define VMI_UNROLL
#endif
#define VMI_EACH(i, n) VMI_UNROLL for (i = 0; i < (n); i++)

/* Systems of up to VMI_SMALL components, where the compiler knows n, are stepped in local arrays, others in the
   caller's work. */
#define VMI_SMALL 8
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define VMI_IS_SMALL(n) (__builtin_constant_p(n) && (n) <= VMI_SMALL)
#else
#define VMI_IS_SMALL(n) 0
#endif

/* Copies n numbers; the arrays do not overlap, unless they are the same. */
VM_INLINE void vmi_copy(int n, const vm_real *from, vm_real *to)
{
    int i;
    VMI_EACH(i, n) to[i] = from[i];
}

#endif
