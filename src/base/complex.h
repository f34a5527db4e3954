/* base/complex.h - complex numbers

       vm_complex z = vmi_c_times(vmi_complex(0, 1), vmi_complex(3, 4)); // i (3 + 4i) = -4 + 3i

   Tests: tests/test_jeffcott.c, tests/test_broken_rotor.c. */
#ifndef VARMASS_BASE_COMPLEX_H
#define VARMASS_BASE_COMPLEX_H

#include "elementary.h"
#include "hypot.h"
#include "real.h"

/* A complex number re + i im */
typedef struct VM_TAG(vm_complex) {
    vm_real re, im;
} vm_complex;

/* Returns the complex number re + i im. */
VM_API vm_complex vmi_complex(vm_real re, vm_real im)
{
    vm_complex z;
    z.re = re;
    z.im = im;
    return z;
}

/* These functions return the sum a + b, the difference a - b, and the products c a and i c a of a complex number a with
   a real number c. */
VM_API vm_complex vmi_c_add(vm_complex a, vm_complex b) { return vmi_complex(a.re + b.re, a.im + b.im); }
VM_API vm_complex vmi_c_sub(vm_complex a, vm_complex b) { return vmi_complex(a.re - b.re, a.im - b.im); }
VM_API vm_complex vmi_c_scale(vm_real c, vm_complex a) { return vmi_complex(c * a.re, c * a.im); }
VM_API vm_complex vmi_c_times_i(vm_real c, vm_complex a) { return vmi_complex(-c * a.im, c * a.re); }

/* Returns the product a b. */
VM_API vm_complex vmi_c_times(vm_complex a, vm_complex b)
{
    return vmi_complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

/* Returns the complex conjugate of a, which is a.re - i a.im. */
VM_API vm_complex vmi_c_conjugate(vm_complex a) { return vmi_complex(a.re, -a.im); }

/* Returns the complex number e^(i angle), for an angle in radians. */
VM_API vm_complex vmi_c_turn(vm_real angle)
{
    vm_complex e;
    vmi_sincos(angle, &e.im, &e.re);
    return e;
}

/* Writes the complex numbers e^(i k angle) for k = 0 to n, for an angle in radians. The error of e^(i k angle) is about
   k rounding errors. */
VM_API void vmi_c_turns(int n, vm_real angle, vm_complex *turns)
{
    const vm_complex once = vmi_c_turn(angle);
    int k;
    turns[0] = vmi_complex(1, 0);
    for (k = 1; k <= n; k++) turns[k] = vmi_c_times(turns[k - 1], once);
}

/* Returns the modulus |z|. */
VM_API vm_real vmi_c_modulus(vm_complex z) { return vmi_hypot(z.re, z.im); }

/* Returns the quotient a/b by Smith's method, which is accurate even where |b|^2 overflows or underflows. */
VM_API vm_complex vmi_c_over(vm_complex a, vm_complex b)
{
    vm_real q, d;
    if (VM_FABS(b.re) < VM_FABS(b.im)) {
        q = b.re / b.im;
        d = b.im + b.re * q;
        return vmi_complex((a.re * q + a.im) / d, (a.im * q - a.re) / d);
    }
    q = b.im / b.re;
    d = b.re + b.im * q;
    return vmi_complex((a.re + a.im * q) / d, (a.im - a.re * q) / d);
}

#endif
