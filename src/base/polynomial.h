/* base/polynomial.h - all roots of a polynomial

   The polynomial is c[0] z^n + c[1] z^(n-1) + ... + c[n] with c[0] != 0. Its roots, real and complex, are found
   together, by the method of Ehrlich and Aberth. If they have very different sizes, the start values are those of D. A.
   Bini, Numer. Algorithms 13 (1996), 179.

       vm_real c[3] = {1, -3, 2}, re[2], im[2];
       vmi_poly_roots(2, c, re, im); // 2 and 1

   Tests: tests/test_broken_rotor.c. */
#ifndef VARMASS_BASE_POLYNOMIAL_H
#define VARMASS_BASE_POLYNOMIAL_H

#include "complex.h"
#include "elementary.h"
#include "hypot.h"
#include "power_of_two.h"
#include "real.h"

/* The power of two by which a number of this modulus is divided before its powers are computed; 1 for small numbers */
VM_API vm_real vmi_poly_unit(vm_real modulus) { return vmi_power_below(vmi_larger(modulus, 1)); }

/* A polynomial at one point. The point is computed as a multiple z of a power of two, the unit, and the polynomial of
   degree n is divided by unit^n. So the powers of a large root do not overflow. */
typedef struct VM_TAG(vmi_poly_value) {
    vm_real unit;
    vm_complex value, slope; /* of the divided polynomial; the slope is its derivative by z */
    vm_real size; /* the sum of the moduli of the terms whose sum is the value */
} vmi_poly_value;

/* Returns the polynomial of degree n with the coefficients c at the point re + i im. */
VM_API vmi_poly_value vmi_poly_at(int n, const vm_real *c, vm_real re, vm_real im)
{
    const vm_real unit = vmi_poly_unit(vmi_hypot(re, im)), modulus = vmi_hypot(re, im) / unit;
    const vm_complex z = vmi_complex(re / unit, im / unit);
    vm_complex p = vmi_complex(c[0], 0), slope = vmi_complex(0, 0);
    vm_real size = VM_FABS(c[0]), share = 1;
    vmi_poly_value at;
    int j;
    for (j = 1; j <= n; j++) {
        const vm_complex q = vmi_c_times(slope, z);
        share /= unit;
        slope = vmi_complex(q.re + p.re, q.im + p.im);
        p = vmi_c_times(p, z);
        p.re += c[j] * share;
        size = size * modulus + VM_FABS(c[j] * share);
    }
    at.unit = unit;
    at.value = p;
    at.slope = slope;
    at.size = size;
    return at;
}

/* Returns 1 if the value is at most `errors` times eps size, which rounding errors of its terms may cause, else 0. */
VM_API int vmi_poly_is_rounding(const vmi_poly_value *at, vm_real errors)
{
    return VM_FABS(at->value.re) + VM_FABS(at->value.im) <= errors * VM_EPSILON * at->size && at->size <= VM_MAX;
}

/* Returns the correction that must be subtracted from the approximate root number i. It is a step of Newton's method
   for the polynomial divided by all z - z_j, where z_j are the other approximate roots. This division keeps two
   approximations from converging to one root. The correction is 0 if the value of the polynomial is so small that
   rounding errors alone may have caused it. */
VM_API vm_complex vmi_poly_step(int n, const vm_real *c, const vm_real *re, const vm_real *im, int i)
{
    const vmi_poly_value at = vmi_poly_at(n, c, re[i], im[i]);
    const vm_complex one = vmi_complex(1, 0);
    vm_complex others = vmi_complex(0, 0);
    int j;
    if (vmi_poly_is_rounding(&at, 1)) return vmi_complex(0, 0);
    for (j = 0; j < n; j++) {
        const vm_complex apart = vmi_complex((re[i] - re[j]) / at.unit, (im[i] - im[j]) / at.unit);
        vm_complex inverse;
        if (j == i || (apart.re == 0 && apart.im == 0)) continue;
        inverse = vmi_c_over(one, apart);
        others.re += inverse.re;
        others.im += inverse.im;
    }
    others = vmi_c_times(at.value, others);
    return vmi_c_scale(at.unit, vmi_c_over(at.value, vmi_complex(at.slope.re - others.re, at.slope.im - others.im)));
}

/* Returns 1 if the value of the polynomial at the number re + i im is 0 or so small that rounding errors alone may have
   caused it, else 0. */
VM_API int vmi_poly_is_root(int n, const vm_real *c, vm_real re, vm_real im)
{
    const vmi_poly_value at = vmi_poly_at(n, c, re, im);
    return vmi_poly_is_rounding(&at, (vm_real)(4 * n));
}

/* Exchanges the roots i and j. */
VM_API void vmi_poly_swap(vm_real *re, vm_real *im, int i, int j)
{
    const vm_real x = re[i], y = im[i];
    re[i] = re[j];
    im[i] = im[j];
    re[j] = x;
    im[j] = y;
}

/* Sorts the roots: the real roots come first, from the largest to the smallest; then come the conjugate pairs by rising
   |im|, and in each pair the root with im > 0 is first. Imaginary parts that are only rounding errors become 0, and the
   two roots of a pair become exactly conjugate. (Rounding splits a root of multiplicity 3 or more; its pairs may then
   stand in another order.) */
VM_API void vmi_poly_order(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const vm_real tolerance = 16 * VM_SQRT(VM_EPSILON); /* rounding may split a double root by this relative distance */
    int i, j, k;
    for (i = 0; i < n; i++) {
        if (VM_FABS(im[i]) <= tolerance * VM_FABS(re[i]) && vmi_poly_is_root(n, c, re[i], 0)) im[i] = 0;
        for (j = i; j > 0; j--) {
            const vm_real rise = VM_FABS(im[j]) - VM_FABS(im[j - 1]);
            if (rise > 0 || (rise == 0 && re[j] <= re[j - 1])) break;
            vmi_poly_swap(re, im, j, j - 1);
        }
    }
    for (i = 0; i < n && im[i] == 0;) i++;
    if ((n - i) % 2) { /* a real root that rounding has moved off the axis */
        im[i] = 0;
        for (j = i++; j > 0 && re[j] > re[j - 1]; j--) vmi_poly_swap(re, im, j, j - 1);
    }
    for (; i < n; i += 2) {
        for (j = k = i + 1; k < n; k++)
            if (VM_FABS(re[k] - re[i]) + VM_FABS(im[k] + im[i]) < VM_FABS(re[j] - re[i]) + VM_FABS(im[j] + im[i]))
                j = k;
        vmi_poly_swap(re, im, i + 1, j);
        re[i] = re[i + 1] = (re[i] + re[i + 1]) / 2;
        im[i] = (VM_FABS(im[i]) + VM_FABS(im[i + 1])) / 2;
        im[i + 1] = -im[i];
    }
}

/* Writes m start values on the unit circle. Values symmetric about the real axis would remain symmetric. */
VM_API void vmi_poly_start_on_circle(int m, vm_real *re, vm_real *im)
{
    int i;
    for (i = 0; i < m; i++) vmi_sincos(VM_C(0.4) + 2 * VM_PI * (vm_real)i / (vm_real)m, &im[i], &re[i]);
}

/* Writes m start values on circles as large as the roots, for a polynomial whose last coefficient c[m] is not 0. The
   upper convex hull of the points (i, ln|c[i]|) consists of straight edges. An edge from i to j belongs to j - i roots,
   whose moduli are about e^s, where s is the slope of the edge. */
VM_API void vmi_poly_start_on_circles(int m, const vm_real *c, vm_real *re, vm_real *im)
{
    int i, j, k, end;
    for (i = 0; i < m; i = end) {
        vm_real steepest = -VM_INFINITY, radius;
        for (j = end = i + 1; j <= m; j++) {
            vm_real slope;
            if (c[j] == 0) continue;
            slope = (vmi_log(VM_FABS(c[j])).hi - vmi_log(VM_FABS(c[i])).hi) / (vm_real)(j - i);
            if (slope < steepest) continue;
            steepest = slope;
            end = j;
        }
        radius = vmi_exp(steepest, 0);
        vmi_poly_start_on_circle(end - i, re + i, im + i);
        for (k = i; k < end; k++) {
            re[k] *= radius;
            im[k] *= radius;
        }
    }
}

/* Improves m approximate roots until they are at rest. Returns 1 if all of them are roots within rounding errors, else
   0. */
VM_API int vmi_poly_iterate(int m, const vm_real *c, vm_real *re, vm_real *im)
{
    const int most_sweeps = 100;
    int i, sweep, moving = 1, are_roots = 1;
    for (sweep = 0; sweep < most_sweeps && moving; sweep++) {
        for (moving = i = 0; i < m; i++) {
            const vm_complex step = vmi_poly_step(m, c, re, im, i);
            re[i] -= step.re;
            im[i] -= step.im;
            moving += VM_FABS(step.re) + VM_FABS(step.im) > VM_EPSILON * (VM_FABS(re[i]) + VM_FABS(im[i]));
        }
    }
    for (i = 0; i < m; i++) are_roots = are_roots && vmi_poly_is_root(m, c, re[i], im[i]);
    return are_roots;
}

/* Computes the n roots (re[i], im[i]) of a polynomial of degree n. The error of a simple root is a few n eps times
   its condition number. The first start values lie on the unit circle. From there, the sweeps do not reach several
   roots below about 1e-20; then other start values follow. If these do not lead to the roots either, the roots become
   NaN. */
VM_API void vmi_poly_roots(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    int m = n, found;
    while (m > 0 && c[m] == 0) {
        m--;
        re[m] = im[m] = 0;
    }
    vmi_poly_start_on_circle(m, re, im);
    found = vmi_poly_iterate(m, c, re, im);
    if (!found) {
        vmi_poly_start_on_circles(m, c, re, im);
        found = vmi_poly_iterate(m, c, re, im);
    }
    if (found) vmi_poly_order(n, c, re, im);
    for (; !found && m > 0; m--) re[m - 1] = im[m - 1] = VM_NAN;
}

#endif
