/* oscillators/force_terms.h - terms of forces that both oscillators and scenes use

   Each formula is written only here, so that an oscillator and an effect of a scene compute the same force. Numbers in
   brackets are equations of the dissertation.
       vm_real feed = vmi_van_der_pol_feed(VM_C(0.1), VM_C(0.2), 2); // N s/m at x = 2 m: force over velocity
   Tests: tests/test_van_der_pol.c, tests/test_jeffcott.c, tests/test_forces.c. */
#ifndef VARMASS_OSCILLATORS_FORCE_TERMS_H
#define VARMASS_OSCILLATORS_FORCE_TERMS_H

#include "../base/real.h"
#include "../base/scalars.h"

/* x|x|^(alpha-1), alpha >= 0, by the power function. It is the force of a spring with the stiffness k, divided by -k.
   The calling function treats x = 0 and the exponents for which no power function is needed. */
VM_INLINE vm_real vmi_elastic_power(vm_real x, vm_real alpha)
{
    return VM_COPYSIGN(vmi_pow_checked(VM_FABS(x), alpha), x);
}

/* Van der Pol's term (404), feed - c x^2, N s/m. It is the force divided by the velocity, at the position x. feed > 0
   (N s/m) feeds energy into the vibration, and c > 0 (N s/m^3) limits it. */
VM_INLINE vm_real vmi_van_der_pol_feed(vm_real feed, vm_real c, vm_real x) { return feed - c * (x * x); }

/* The gyroscopic coupling 2 gyro, kg/s. The gyroscopic force is this coupling times the velocity, turned by +90
   degrees. The argument gyro, kg/s, is the letter g in the remark after (516). */
VM_INLINE vm_real vmi_gyroscopic_coupling(vm_real gyro) { return 2 * gyro; }

#endif
