/* oscillators/slow.h - laws of amplitude for all oscillators with a slowly varying mass

   This file has, in closed form, the amplitude and the largest velocity of an oscillator
       m x'' + k x|x|^(alpha-1) = -(r m' + b) x'
   whose mass m(t) varies slowly, that is, by little within a period. These are the equations (325), (326), (344),
   (364), (367), (389) and (395) of the dissertation. The files for Van der Pol's oscillator, for the rotor, for two
   bodies and for an oscillator under a harmonic force use this file.

       vm_real A = 3 * vm_osc_amplitude_law(VM_C(0.5), 0, 1, 3); // A at a later time

   Here A was 3 at t = 0. The arguments say: half of the mass is left (0.5), there is no damping (0), the mass that
   leaves is at rest (1), and the spring is cubic (alpha = 3).

   The symbols in these files: A is the amplitude, psi the Ateb phase, Om = psi' its rate, m the mass, k the stiffness,
   b the damping, r the argument `reactive`, and q the rate at which mass, damping and stiffness change the vibration
   (vmi_slow_q). Averaging needs q much smaller than Om.
   Tests: tests/test_averaging.c, tests/test_constant_mass.c. */
#ifndef VARMASS_OSCILLATORS_SLOW_H
#define VARMASS_OSCILLATORS_SLOW_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "laws.h"

/* Returns 1 if the arguments of vm_osc_amplitude_law and vm_osc_velocity_law are in their domain, else 0. */
VM_API int vmi_osc_law_is_in_domain(vm_real mass_ratio, vm_real decay, vm_real reactive, vm_real alpha)
{
    return mass_ratio > 0 && alpha >= 0 && VM_IS_FINITE(mass_ratio) && VM_IS_FINITE(decay) &&
           VM_IS_FINITE(reactive) && VM_IS_FINITE(alpha);
}

/* Ratio A/A0 of the amplitude A to its value A0 at t = 0, for an oscillator whose mass varies slowly. The law, (325),
   (344), (367) and (389) as corrected in docs/errata.md, is
     A/A0 = (m0/m)^((2r-1)/(alpha+3)) exp(-2 decay/(alpha+3)).
   Averaging with ca, with cos and with cn gives this law, if the sign in (335) is corrected. The law holds to first
   order in the mass rate m' and in the damping. The arguments are pure numbers. mass_ratio > 0 is m/m0, where m0 is the
   mass at t = 0. decay is the integral of damping/mass over time. reactive, or r, is 1 where mass that joins or leaves
   is at rest, so that the full reactive force acts, and 0 where this mass has the body's own velocity, as in a leak.
   alpha >= 0 is the exponent of the spring. Returns NaN outside the domain and for infinite arguments. */
VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real decay, vm_real reactive, vm_real alpha)
{
    if (!vmi_osc_law_is_in_domain(mass_ratio, decay, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (1 - 2 * reactive) / (alpha + 3)) * vmi_exp(-2 * decay / (alpha + 3), 0);
}

/* Ratio of the largest velocity x'_max within a period to its value at t = 0, for an oscillator whose mass varies
   slowly. The largest velocity follows from the amplitude A by x'_max = sqrt(2 k A^(alpha+1)/((alpha+1) m)): (326),
   (364) and (395) as corrected in docs/errata.md. The arguments and their domain are those of vm_osc_amplitude_law.
   Outside the domain and for infinite arguments the result is NaN. */
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real decay, vm_real reactive, vm_real alpha)
{
    const vm_real share = (alpha + 1) / (alpha + 3); /* (alpha+1)/2, the exponent of A in x'_max, times 2/(alpha+3) */
    if (!vmi_osc_law_is_in_domain(mass_ratio, decay, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (share * (1 - 2 * reactive) - 1) / 2) * vmi_exp(-share * decay, 0);
}

/* The mass m0 + rate time, which is linear in time, between the times 0 and t */
typedef struct VM_TAG(vmi_linear_mass) {
    vm_real m0, m, rate; /* mass at time 0, and mass at time t, kg; rate of the mass, kg/s */
    vm_real ln_ratio;    /* ln(m/m0) */
    vm_real integral;    /* integral of dt/m from 0 to t, s/kg; its formula is also valid at rate = 0 */
} vmi_linear_mass;

/* Writes to *linear the mass that a law describes between 0 and t, if this mass is linear in time. Some closed forms
   hold only for a linear mass. Returns VM_NO_LAW unless vmi_law_exponential_form finds base = rate; so it refuses every
   table, and every quadratic law that is not constant, even if the mass is in fact linear. Returns VM_BAD_MASS where
   the mass is not positive at 0 or at t, VM_BAD_ARGUMENT where no constructor made the law, and VM_NOT_FINITE for a
   number that is infinite or NaN. */
VM_API int vmi_linear_mass_of(const vm_law *law, vm_real t, vmi_linear_mass *linear)
{
    vm_real growth, mean, base, rate;
    int status = vmi_law_at(law, VM_BAD_MASS, 0, &linear->m0, &linear->rate);
    if (!status) status = vmi_law_at(law, VM_BAD_MASS, t, &linear->m, &rate);
    if (status) return status;
    if (!vmi_law_exponential_form(law, &base, &rate) || base != rate) return VM_NO_LAW;
    growth = linear->rate * t / linear->m0;
    if (!VM_IS_FINITE(growth)) return VM_NOT_FINITE;
    if (!(growth > -1)) return VM_BAD_MASS;
    mean = vmi_log_ratio(growth); /* the mean of m0/m from 0 to t */
    linear->ln_ratio = growth * mean;
    linear->integral = t / linear->m0 * mean;
    return VM_OK;
}

/* The drag (2r - 1) m' + 2 b, kg/s, which the reactive force and the damping b together exert on the vibration. m' is
   the mass rate and r the argument `reactive`. Where mass joins at rest (r = 1), the drag is m' + 2 b; where mass joins
   with the body's velocity (r = 0), it is -m' + 2 b. */
VM_API vm_real vmi_slow_drag(vm_real reactive, vm_real mass_rate, vm_real damping)
{
    return (2 * reactive - 1) * mass_rate + 2 * damping;
}

/* q = drag/m + k'/k, 1/s, the rate at which slow changes of the mass m and of the stiffness k, and damping, change the
   vibration. drag is the result of vmi_slow_drag. The mean amplitude follows A' = -q A/(alpha + 3). */
VM_API vm_real vmi_slow_q(vm_real drag, vm_real mass, vm_real k, vm_real k_rate) { return drag / mass + k_rate / k; }

/* Om, the rate of the Ateb phase at the amplitude A, 1/s. At rest (A = 0) the result is 0 for alpha < 1, where the
   formula gives infinity. */
VM_API vm_real vmi_slow_rate(vm_real A, vm_real k, vm_real mass, vm_real alpha)
{
    if (A == 0 && alpha < 1) return 0;
    return vmi_osc_rate(A, VM_SQRT(k / mass), alpha);
}

/* Writes the position x = A ca(psi) and the velocity x' = -vmax(A) sa(psi), where vmax is vm_osc_vmax. */
VM_API void vmi_slow_motion(vm_real A, vm_real psi, vm_real k, vm_real mass, vm_real alpha, vm_real *x, vm_real *v)
{
    vmi_osc_at_phase(A, psi, VM_SQRT(k / mass), alpha, x, v);
}

/* Computes the amplitude A and the Ateb phase psi from the position x and the velocity v. This is the inverse of
   vmi_slow_motion. */
VM_API void vmi_slow_phase(vm_real x, vm_real v, vm_real k, vm_real mass, vm_real alpha, vm_real *A, vm_real *psi)
{
    vm_osc_amplitude_phase(x, v, VM_SQRT(k / mass), alpha, A, psi);
}

/* Returns 1 if `amplitude`, a mean amplitude plus its ripple, differs from the exact amplitude `exact` by at most
   exact/8, else 0. A few iterations find the mean amplitude. They come this near, unless the ripple is about as large
   as the amplitude. */
VM_API int vmi_slow_is_solved(vm_real amplitude, vm_real exact) { return VM_FABS(amplitude - exact) <= exact / 8; }

#endif
