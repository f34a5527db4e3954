/* ateb/integrals.h - integrals of Ateb functions */
#ifndef VARMASS_ATEB_INTEGRALS_H
#define VARMASS_ATEB_INTEGRALS_H

#include "../base/real.h"
#include "functions.h"
#include "inversion.h"

/* Integral from 0 to s of sa^2, (s - sa ca) (alpha+1)/(alpha+3), and of |ca|^(alpha+1), the rest of s. That of sa is
   (1 - ca) (alpha+1)/2, that of ca |ca|^(alpha-1) is sa. */
VM_API vm_real ateb_integral_sa2(vm_real s, vm_real alpha)
{
    const vm_real q = 1 / (alpha + 1), b = q + VM_C(0.5);
    vm_real sa, ca, w, rest;
    ateb_saca(s, alpha, &sa, &ca);
    w = sa * sa;
    if (VM_FABS(s) < VM_C(0.55)) rest = sa * ca * (w * b * vmi_ateb_w_fraction(q, w));
    else rest = s - sa * ca;
    return rest / (1 + 2 * q);
}

/* Documented with ateb_integral_sa2. */
VM_API vm_real ateb_integral_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return (2 * s / (alpha + 1) + sa * ca) / (1 + 2 / (alpha + 1));
}

#endif
