/* ateb/phase.h - the phase from the pair sa, ca */
#ifndef VARMASS_ATEB_PHASE_H
#define VARMASS_ATEB_PHASE_H

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "inversion.h"
#include "period.h"

/* r in the first quarter, where h = ln(w/x) */
VM_API vm_real vmi_ateb_phase_r(vm_two h, const vmi_ateb *c)
{
    const vm_real q = c->q.hi;
    const vm_real e = h.hi < 0 ? vmi_exp(h.hi, h.lo) : vmi_exp(-h.hi, -h.lo), sum = 1 + e;
    if (h.hi < VM_C(-0.84)) { /* w < 0.302 */
        const vm_real v = vmi_exp(h.hi / 2, h.lo / 2) / VM_SQRT(sum), w = v * v, b = q + VM_C(0.5);
        const vm_real one_minus_u = q * vmi_ateb_power_rest(-w / (2 - w), q);
        return v + v * (w * b * vmi_ateb_w_fraction(q, w) * (1 - one_minus_u) - one_minus_u);
    } else {
        const vm_real x = h.hi > 0 ? e / sum : 1 / sum, v = VM_SQRT(h.hi > 0 ? 1 / sum : e / sum),
                      p = x / (2 + 2 * v);
        const vm_real T = vmi_ateb_T(q, p);
        vm_two ln_x = vmi_log(sum); /* ln x = -(h + ln(1 + e^-h)) or -ln(1 + e^h) */
        vm_real one_minus_u, p_lo;
        int i;
        if (h.hi > 0) ln_x = vmi_two_plus(ln_x, h);
        ln_x.lo += (1 - sum + e) / sum;
        ln_x = vmi_two_times(ln_x, c->q);
        if (!(ln_x.hi <= VM_C(0.69) * VMI_BIAS)) return c->quarter.hi; /* where alpha ln x overflows too */
        one_minus_u = -vmi_exp_core(-ln_x.hi, -ln_x.lo, &i, &p_lo);
        if (i != 0) return c->quarter.hi - vmi_ldexp(1 - one_minus_u, i) * (c->n.hi + T) / 2;
        return (c->n.hi * one_minus_u + (c->g.hi - (1 - one_minus_u) * T)) / 2;
    }
}

/* s in (-Pi, Pi] of which sa and ca are given, as atan2 gives an angle; 0 for sa = 0 <= ca. The pair need not be on
   the curve: sa lambda^((alpha+1)/2) and ca lambda have the same phase for any lambda > 0, such as the amplitude: x
   and x'/(-sqrt(2/(alpha+1)) omega) of an oscillator will do. NaN, infinite arguments and alpha > 1e30 give NaN. */
VM_API vm_real ateb_phase(vm_real sa, vm_real ca, vm_real alpha)
{
    vm_real r;
    vmi_ateb c;
    if (!(alpha >= 0) || !(alpha <= VM_C(1e30)) || !VM_IS_FINITE(sa) || !VM_IS_FINITE(ca)) return VM_NAN;
    vmi_ateb_constants(&c, alpha);
    if (sa == 0) r = 0;
    else if (ca == 0) r = c.quarter.hi;
    else {
        const vm_two w = vmi_two_scaled(vmi_log(VM_FABS(sa)), 2), x = vmi_two_times(vmi_log(VM_FABS(ca)), c.n);
        r = vmi_ateb_phase_r(vmi_two_plus(w, vmi_minus(x)), &c);
    }
    if (ca < 0) r = (2 * c.quarter.hi - r) + 2 * c.quarter.lo;
    return VM_COPYSIGN(r, sa);
}

#endif
