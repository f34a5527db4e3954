/* oscillators/legendre.h - Gauss' rule of 20 points and series of Legendre polynomials on [-1, 1]

   A smooth function on [-1, 1] is represented by a series, the sum of coefficient[k] P_k(x) over k = 0 ... 19, where
   P_k are Legendre's polynomials. The integral of the function over [-1, 1] is 2 coefficient[0]. vmi_legendre_fit finds
   the coefficients from the values at the points of Gauss' rule. The other functions evaluate, integrate and
   differentiate the series, and measure its size. Tests: tests/test_laws.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_LEGENDRE_H
#define VARMASS_OSCILLATORS_LEGENDRE_H

#include "../base/real.h"

/* Number of points of the rule, and of terms of a series */
enum { VMI_GAUSS = 20 };

/* Point i of Gauss' rule on [-1, 1], 0 <= i < 20 */
VM_API vm_real vmi_gauss_node(int i)
{
    VM_TABLE vm_real node[10] = {VM_C(0.99312859918509492479), VM_C(0.96397192727791379127),
                                 VM_C(0.91223442825132590587), VM_C(0.83911697182221882339),
                                 VM_C(0.74633190646015079261), VM_C(0.63605368072651502545),
                                 VM_C(0.510867001950827098),   VM_C(0.37370608871541956067),
                                 VM_C(0.22778585114164507808), VM_C(0.076526521133497333755)};
    return i % 2 ? VM_READ(node[i / 2]) : -VM_READ(node[i / 2]);
}

/* The weight of point i of Gauss' rule; the weights add up to 2 */
VM_API vm_real vmi_gauss_weight(int i)
{
    VM_TABLE vm_real weight[10] = {VM_C(0.017614007139152118312), VM_C(0.040601429800386941331),
                                   VM_C(0.06267204833410906357),  VM_C(0.083276741576704748725),
                                   VM_C(0.10193011981724043504),  VM_C(0.11819453196151841731),
                                   VM_C(0.1316886384491766269),   VM_C(0.14209610931838205133),
                                   VM_C(0.14917298647260374679),  VM_C(0.1527533871307258507)};
    return VM_READ(weight[i / 2]);
}

/* Legendre's polynomial P_(k+1)(x), where now = P_k(x) and before = P_(k-1)(x) */
VM_API vm_real vmi_legendre_next(int k, vm_real x, vm_real now, vm_real before)
{
    return ((vm_real)(2 * k + 1) * x * now - (vm_real)k * before) / (vm_real)(k + 1);
}

/* Writes the coefficients a and b of the series of two functions, from their values at the points of Gauss' rule. One
   call treats two functions, since most of the computing time is spent on the polynomials, which both functions
   share. */
VM_API void vmi_legendre_fit(const vm_real *values_a, const vm_real *values_b, vm_real *a, vm_real *b)
{
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) {
        a[k] = 0;
        b[k] = 0;
    }
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real x = vmi_gauss_node(i), weight = vmi_gauss_weight(i);
        const vm_real share_a = weight * values_a[i], share_b = weight * values_b[i];
        vm_real before = 0, now = 1;
        for (k = 0; k < VMI_GAUSS; k++) {
            const vm_real next = vmi_legendre_next(k, x, now, before);
            a[k] += share_a * now;
            b[k] += share_b * now;
            before = now;
            now = next;
        }
    }
    for (k = 0; k < VMI_GAUSS; k++) {
        a[k] *= (vm_real)k + VM_C(0.5);
        b[k] *= (vm_real)k + VM_C(0.5);
    }
}

/* The value of the series with these 20 coefficients at x */
VM_API vm_real vmi_legendre_at(const vm_real *coefficient, vm_real x)
{
    vm_real before = 0, now = 1, sum = 0;
    int k;
    for (k = 0; k < VMI_GAUSS; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        sum += coefficient[k] * now;
        before = now;
        now = next;
    }
    return sum;
}

/* The integral of the series from -1 to x. The integral of P_k is (P_(k+1) - P_(k-1))/(2k+1). */
VM_API vm_real vmi_legendre_integral(const vm_real *coefficient, vm_real x)
{
    vm_real before = 1, now = x, sum = coefficient[0] * (1 + x);
    int k;
    for (k = 1; k < VMI_GAUSS; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        sum += coefficient[k] * (next - before) / (vm_real)(2 * k + 1);
        before = now;
        now = next;
    }
    return sum;
}

/* Replaces the coefficients c_k of the series by those of its derivative, d_k = (2k+1) (c_(k+1) + c_(k+3) + ...). */
VM_API void vmi_legendre_derive(vm_real *coefficient)
{
    vm_real sums[2] = {0, 0}; /* sums of the c_j with j > k, for even j and for odd j */
    int k;
    for (k = VMI_GAUSS - 1; k >= 0; k--) {
        const vm_real own = coefficient[k];
        coefficient[k] = (vm_real)(2 * k + 1) * sums[(k + 1) % 2];
        sums[k % 2] += own;
    }
}

/* The mean square of the series on [-1, 1] */
VM_API vm_real vmi_legendre_square(const vm_real *coefficient)
{
    vm_real sum = 0;
    int k;
    for (k = 0; k < VMI_GAUSS; k++) sum += coefficient[k] * coefficient[k] / (vm_real)(2 * k + 1);
    return sum;
}

/* The largest absolute value of the last three coefficients, or NaN if one of them is NaN. The terms that the series
   leaves out have about this size. */
VM_API vm_real vmi_legendre_tail(const vm_real *coefficient)
{
    vm_real largest = 0;
    int k;
    for (k = VMI_GAUSS - 3; k < VMI_GAUSS; k++) {
        const vm_real size = VM_FABS(coefficient[k]);
        if (!(size <= largest)) largest = size;
    }
    return largest;
}

#endif
