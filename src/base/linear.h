/* base/linear.h - systems of linear equations */
#ifndef VARMASS_BASE_LINEAR_H
#define VARMASS_BASE_LINEAR_H

#include "real.h"
#include "status.h"

/* Elimination of column k of a x = b, a n by n, row after row, below the diagonal */
VM_API void vmi_eliminate(int n, int k, vm_real *a, vm_real *b)
{
    int i, j;
    for (i = k + 1; i < n; i++) {
        const vm_real factor = a[i * n + k] / a[k * n + k];
        for (j = k + 1; j < n; j++) a[i * n + j] -= factor * a[k * n + j];
        b[i] -= factor * b[k];
    }
}

/* a x = b for a without entries below the diagonal: x replaces b */
VM_API void vmi_substitute_back(int n, const vm_real *a, vm_real *b)
{
    int j, k;
    for (k = n - 1; k >= 0; k--) {
        for (j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
}

/* a x = b, a dense and n by n, row after row, by elimination with row pivoting: x replaces b, a is destroyed.
   VM_SINGULAR, b destroyed, where a column has no pivot. */
VM_API int vmi_solve_linear(int n, vm_real *a, vm_real *b)
{
    int i, j, k;
    for (k = 0; k < n; k++) {
        int pivot = k;
        vm_real x;
        for (i = k + 1; i < n; i++)
            if (VM_FABS(a[i * n + k]) > VM_FABS(a[pivot * n + k])) pivot = i;
        if (!(VM_FABS(a[pivot * n + k]) > 0)) return VM_SINGULAR;
        for (j = k; j < n; j++) {
            x = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = x;
        }
        x = b[k];
        b[k] = b[pivot];
        b[pivot] = x;
        vmi_eliminate(n, k, a, b);
    }
    vmi_substitute_back(n, a, b);
    return VM_OK;
}

/* a x = b for a mass matrix a, scaled to unit diagonal, which makes units and sizes of the coordinates nothing and
   the condition number nearly the least that scaling can (van der Sluis 1969): x replaces b, a is destroyed, scale
   is n numbers of work. Rows are not exchanged: a positive definite matrix does not need it, and of any other a pivot
   is not positive. VM_SINGULAR where an entry on the diagonal is not positive or a pivot is below 4 n eps. */
VM_API int vmi_solve_mass(int n, vm_real *a, vm_real *b, vm_real *scale)
{
    int i, j;
    for (i = 0; i < n; i++) {
        if (!(a[i * n + i] > 0)) return VM_SINGULAR;
        scale[i] = VM_SQRT(a[i * n + i]);
    }
    for (i = 0; i < n; i++) {
        for (j = 0; j < n; j++) a[i * n + j] = a[i * n + j] / scale[i] / scale[j];
        b[i] /= scale[i];
    }
    for (i = 0; i < n; i++) {
        if (!(a[i * n + i] > (vm_real)(4 * n) * VM_EPSILON)) return VM_SINGULAR;
        vmi_eliminate(n, i, a, b);
    }
    vmi_substitute_back(n, a, b);
    for (i = 0; i < n; i++) b[i] /= scale[i];
    return VM_OK;
}

#endif
