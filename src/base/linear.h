/* base/linear.h - systems of linear equations

   The functions solve a x = b for n unknowns x. The matrix a is an array of n^2 numbers, row after row.

       vm_real a[4] = {2, 1, 1, 3}, b[2] = {3, 5};
       vmi_solve_linear(2, a, b); // b is now x = (0.8, 1.4)

   Tests: tests/test_lagrange.c, tests/test_scenes.c. */
#ifndef VARMASS_BASE_LINEAR_H
#define VARMASS_BASE_LINEAR_H

#include "real.h"
#include "status.h"

/* Eliminates the unknown x[k] from the left sides of the equations k + 1 to n - 1 of the system a x = b. Column k of a
   keeps the numbers that vmi_eliminate_right needs. */
VM_API void vmi_eliminate(int n, int k, vm_real *a)
{
    int i, j;
    for (i = k + 1; i < n; i++) {
        const vm_real factor = a[i * n + k] / a[k * n + k];
        for (j = k + 1; j < n; j++) a[i * n + j] -= factor * a[k * n + j];
    }
}

/* Changes the right sides b as vmi_eliminate has changed the left sides. Call vmi_eliminate before this function. */
VM_API void vmi_eliminate_right(int n, int k, const vm_real *a, vm_real *b)
{
    int i;
    for (i = k + 1; i < n; i++) b[i] -= a[i * n + k] / a[k * n + k] * b[k];
}

/* Solves a x = b for a triangular matrix a. Its entries below the diagonal are not read. x replaces b. */
VM_API void vmi_substitute_back(int n, const vm_real *a, vm_real *b)
{
    int j, k;
    for (k = n - 1; k >= 0; k--) {
        for (j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
}

/* Solves a x = b for any matrix a by elimination with exchange of rows. x replaces b, and a is overwritten. Returns
   VM_SINGULAR if the pivot of a column is 0 or NaN (a and b are then overwritten, too), and VM_OK otherwise. */
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
        vmi_eliminate(n, k, a);
        vmi_eliminate_right(n, k, a, b);
    }
    vmi_substitute_back(n, a, b);
    return VM_OK;
}

/* Decomposes a mass matrix a, which is symmetric and positive definite, for vmi_solve_decomposed. Both triangles of a
   become the decomposition. The function first divides row i and column i by scale[i], so that the diagonal is 1;
   `scale` becomes the array of these n numbers. The units of the coordinates then do not matter, and the condition
   number is nearly the least that scaling can give (van der Sluis 1969). Rows need not be exchanged. Returns
   VM_SINGULAR if an entry of the diagonal is not positive or a pivot is not above 4 n eps, and VM_OK otherwise. Every
   matrix that is not positive definite gives VM_SINGULAR. */
VM_API int vmi_decompose_mass(int n, vm_real *a, vm_real *scale)
{
    int i, j, k;
    for (i = 0; i < n; i++) {
        if (!(a[i * n + i] > 0)) return VM_SINGULAR;
        scale[i] = VM_SQRT(a[i * n + i]);
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) a[i * n + j] = a[i * n + j] / scale[i] / scale[j];
    for (k = 0; k < n; k++) {
        if (!(a[k * n + k] > (vm_real)(4 * n) * VM_EPSILON)) return VM_SINGULAR;
        vmi_eliminate(n, k, a);
    }
    return VM_OK;
}

/* Solves a x = b after vmi_decompose_mass. x replaces b. */
VM_API void vmi_solve_decomposed(int n, const vm_real *a, const vm_real *scale, vm_real *b)
{
    int i, k;
    for (i = 0; i < n; i++) b[i] /= scale[i];
    for (k = 0; k < n; k++) vmi_eliminate_right(n, k, a, b);
    vmi_substitute_back(n, a, b);
    for (i = 0; i < n; i++) b[i] /= scale[i];
}

/* Solves a x = b for a mass matrix a. x replaces b, a is overwritten, and `scale` is work space for n numbers. Returns
   VM_OK or VM_SINGULAR, as vmi_decompose_mass does. */
VM_API int vmi_solve_mass(int n, vm_real *a, vm_real *b, vm_real *scale)
{
    const int status = vmi_decompose_mass(n, a, scale);
    if (!status) vmi_solve_decomposed(n, a, scale, b);
    return status;
}

#endif
