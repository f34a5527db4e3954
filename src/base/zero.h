/* base/zero.h - a zero of a function between two bounds */
#ifndef VARMASS_BASE_ZERO_H
#define VARMASS_BASE_ZERO_H

#include "real.h"

/* The zero of f in [a, b], where it has the values fa, fb of opposite signs: regula falsi whose standing end is
   halved (Illinois), a bisection wherever that does not halve the interval in three steps; to the resolution of x
   */
VM_API vm_real vmi_find_zero(vm_real (*f)(vm_real x, void *ctx), void *ctx, vm_real a, vm_real b, vm_real fa,
                             vm_real fb)
{
    vm_real width = VM_FABS(b - a);
    int i, side = 0;
    if (fa == 0 || fb == 0) return fa == 0 ? a : b;
    for (i = 1; i < 3 * VM_MANT_DIG + 60; i++) {
        vm_real x = a - fa * ((b - a) / (fb - fa)), fx;
        if (i % 4 == 0) {
            if (VM_FABS(b - a) > width / 8) {
                x = a + (b - a) / 2;
                side = 0;
            }
            width = VM_FABS(b - a);
        }
        if (!((x > a) == (x < b)) || x == a || x == b) x = a + (b - a) / 2;
        if (x == a || x == b) break;
        fx = f(x, ctx);
        if (fx == 0) return x;
        if ((fx > 0) == (fb > 0)) {
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
    return VM_FABS(fa) < VM_FABS(fb) ? a : b;
}

#endif
