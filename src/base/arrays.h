/* base/arrays.h - loops over arrays of numbers */
#ifndef VARMASS_BASE_ARRAYS_H
#define VARMASS_BASE_ARRAYS_H

#include "real.h"

VM_API int vmi_all_finite(int n, const vm_real *y)
{
    int i;
    for (i = 0; i < n; i++)
        if (!VM_IS_FINITE(y[i])) return 0;
    return 1;
}

/* The loops over components are unrolled where n is known, so that the components live in registers. Systems of up to
   VMI_SMALL known components are stepped in local arrays, others in the caller's work. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) && __GNUC__ >= 8 && defined(__OPTIMIZE__) && \
    !defined(__OPTIMIZE_SIZE__)
#define VMI_UNROLL _Pragma("GCC unroll 16")
#else
#define VMI_UNROLL
#endif

#define VMI_EACH(i, n) VMI_UNROLL for (i = 0; i < (n); i++)
#define VMI_SMALL 8

#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define VMI_IS_SMALL(n) (__builtin_constant_p(n) && (n) <= VMI_SMALL)
#else
#define VMI_IS_SMALL(n) 0
#endif

VM_INLINE void vmi_copy(int n, const vm_real *from, vm_real *to)
{
    int i;
    VMI_EACH(i, n) to[i] = from[i];
}

#endif
