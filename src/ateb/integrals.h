/* ateb/integrals.h - integrals of Ateb functions

   This file has functions for two integrals from 0 to s,
     integral of sa^2 = (s - sa ca) (alpha+1)/(alpha+3),
     integral of |ca|^(alpha+1) = s - integral of sa^2.
   Two other integrals are so simple that no function is needed: the integral of sa is (1 - ca) (alpha+1)/2, and that of
   ca |ca|^(alpha-1) is sa.

       vm_real work = ateb_integral_sa2(VM_C(0.7), VM_C(1.5));

   Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_INTEGRALS_H
#define VARMASS_ATEB_INTEGRALS_H

#include "../base/real.h"
#include "functions.h"
#include "inversion.h"

/* The integral of sa(1, alpha, s)^2 from 0 to s.
   No digits cancel for a small s. The domain is that of ateb_saca; the result is NaN outside it. */
VM_API vm_real ateb_integral_sa2(vm_real s, vm_real alpha)
{
    const vm_real q = 1 / (alpha + 1), b = q + VM_C(0.5);
    vm_real sa, ca, w, rest; /* rest = s - sa ca, which for small s is sa ca w b vmi_ateb_w_fraction(q, w) */
    ateb_saca(s, alpha, &sa, &ca);
    w = sa * sa;
    if (VM_FABS(s) < VMI_ATEB_CHANGE_OVER) rest = sa * ca * (w * b * vmi_ateb_w_fraction(q, w));
    else rest = s - sa * ca;
    return rest / (1 + 2 * q);
}

/* The integral of |ca(alpha, 1, s)|^(alpha+1) from 0 to s.
   The domain is that of ateb_saca; the result is NaN outside it. */
VM_API vm_real ateb_integral_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return (2 * s / (alpha + 1) + sa * ca) / (1 + 2 / (alpha + 1));
}

#endif
