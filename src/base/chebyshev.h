/* base/chebyshev.h - lowers the degree of a polynomial with the help of Chebyshev's polynomials

       vm_real c[3] = {1, 1, VM_C(0.5)};
       vmi_remove_highest(c, 2, 0); // 1 + t + t^2/2 is about c[0] + c[1] t for 0 <= t <= 1

   Source: Lanczos, Applied Analysis (1956). Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_CHEBYSHEV_H
#define VARMASS_BASE_CHEBYSHEV_H

#include "real.h"

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
