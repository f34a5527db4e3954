/* base/zero.h - a zero of a function between two points where its signs differ

       vm_real x = vmi_find_zero(f, NULL, 0, 2, f(0, NULL), f(2, NULL)); // f(x, ctx) has a zero between 0 and 2

   Tests: tests/test_jeffcott.c, tests/test_diagnostics.c. */
#ifndef VARMASS_BASE_ZERO_H
#define VARMASS_BASE_ZERO_H

#include "real.h"

/* Returns a zero of f between a and b, as accurate as the type allows, or NaN where a value of f is NaN. fa = f(a) and
   fb = f(b) must differ in sign.
   Method (Illinois): the next x is the zero of the secant through both ends of the interval. If one end of the interval
   has not moved for two steps, the method halves the value of f that is stored for this end. Every fourth step bisects
   the interval unless the last four steps have made the interval eight times shorter. */
VM_API vm_real vmi_find_zero(vm_real (*f)(vm_real x, void *ctx), void *ctx, vm_real a, vm_real b, vm_real fa,
                             vm_real fb)
{
    const int is_positive_at_b = fb > 0;
    vm_real width = VM_FABS(b - a);
    int i, side = 0;
    if (fa == 0) return a;
    if (fb == 0) return b;
    for (i = 1; i < 3 * VM_MANT_DIG + 60; i++) {
        vm_real x = a - fa * ((b - a) / (fb - fa)), fx;
        if (i % 4 == 0) {
            if (VM_FABS(b - a) > width / 8) {
                x = a + (b - a) / 2;
                side = 0;
            }
            width = VM_FABS(b - a);
        }
        if (!(x > a && x < b) && !(x > b && x < a)) x = a + (b - a) / 2; /* also where x is NaN */
        if (x == a || x == b) break;
        fx = f(x, ctx);
        if (fx == 0) return x;
        if (fx != fx) return VM_NAN;
        if ((fx > 0) == is_positive_at_b) {
            b = x;
            fb = fx;
            if (side == 1) fa /= 2;
            side = 1;
        } else {
            a = x;
            fa = fx;
            if (side == -1) fb /= 2;
            side = -1;
        }
    }
    if (VM_FABS(fa) < VM_FABS(fb)) return a;
    return b;
}

#endif
