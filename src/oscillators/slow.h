/* oscillators/slow.h - what oscillators with slowly varying mass share */
#ifndef VARMASS_OSCILLATORS_SLOW_H
#define VARMASS_OSCILLATORS_SLOW_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"

/* A mass, and in this chapter's last sections all that depends on it, at time t: kg, and its rate in kg/s. Slow: it
   changes little in a period. vm_slow_mass_linear is one, whose ctx is a vm_linear_mass. */
typedef vm_real (*vm_slow_mass)(vm_real t, vm_real *rate, void *ctx);

typedef struct VM_TAG(vm_linear_mass) {
    vm_real mass, rate; /* mass + rate t */
} vm_linear_mass;

VM_API int vmi_osc_law_is_in_domain(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    return mass_ratio > 0 && alpha >= 0 && VM_IS_FINITE(mass_ratio) && VM_IS_FINITE(damping) &&
           VM_IS_FINITE(reactive) && VM_IS_FINITE(alpha);
}

/* Amplitude A/A0 and largest velocity over its first value when the mass has come to mass_ratio = m/m0 and
   damping = integral of b/m dt. reactive: r = 1 where what joins or leaves has no velocity, so that there is a
   reactive force; r = 0 where it has the body's, as what leaks out. To first order in m' and b:
     A/A0 = (m0/m)^((2r-1)/(alpha+3)) exp(-2 damping/(alpha+3))      [(325), (344), (367), (389) corrected]
   All three averaging methods give it, once (335)'s sign is mended. */
VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    if (!vmi_osc_law_is_in_domain(mass_ratio, damping, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (1 - 2 * reactive) / (alpha + 3)) * vmi_exp(-2 * damping / (alpha + 3), 0);
}

/* Documented with vm_osc_amplitude_law. */
/* xdot_max = sqrt(2 k A^(alpha+1)/((alpha+1) m)): (326), (364), (395) corrected */
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    vm_real share = (alpha + 1) / (alpha + 3);
    if (!vmi_osc_law_is_in_domain(mass_ratio, damping, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (share * (1 - 2 * reactive) - 1) / 2) * vmi_exp(-share * damping, 0);
}

VM_API vm_real vm_slow_mass_linear(vm_real t, vm_real *rate, void *linear_mass)
{
    if (!rate || !linear_mass) return VM_NAN;
    const vm_linear_mass *m = (const vm_linear_mass *)linear_mass;
    *rate = m->rate;
    return m->mass + m->rate * t;
}

/* The mass at t; VM_BAD_ARGUMENT where there is no law, VM_BAD_MASS, VM_NOT_FINITE */
VM_API int vmi_slow_mass(vm_slow_mass law, void *ctx, vm_real t, vm_real *mass, vm_real *rate)
{
    if (!law) return VM_BAD_ARGUMENT;
    *mass = law(t, rate, ctx);
    if (!VM_IS_FINITE(*mass) || !VM_IS_FINITE(*rate)) return VM_NOT_FINITE;
    return *mass > 0 ? VM_OK : VM_BAD_MASS;
}

/* ln(m/m0) and the integral of dt/m for the linear mass, smooth through m' = 0; 0 where a mass is not positive */
VM_API int vmi_slow_linear(vm_linear_mass m, vm_real t, vm_real *ln_ratio, vm_real *integral)
{
    const vm_real growth = m.rate * t / m.mass;
    vm_real mean;
    if (!(m.mass > 0) || !(growth > -1) || !VM_IS_FINITE(m.mass) || !VM_IS_FINITE(growth)) return 0;
    mean = vmi_log_ratio(growth); /* of m0/m */
    *ln_ratio = growth * mean;
    *integral = t / m.mass * mean;
    return 1;
}

/* Om, the rate of the Ateb phase; 0 at rest, where it may be infinite */
VM_API vm_real vmi_slow_rate(vm_real A, vm_real k, vm_real mass, vm_real alpha)
{
    return A == 0 && alpha < 1 ? 0 : vmi_osc_rate(A, VM_SQRT(k / mass), alpha);
}

/* x = A ca(psi), x' = -vmax(A) sa(psi), and back */
VM_API void vmi_slow_motion(vm_real A, vm_real psi, vm_real k, vm_real mass, vm_real alpha, vm_real *x, vm_real *v)
{
    vmi_osc_at_phase(A, psi, VM_SQRT(k / mass), alpha, x, v);
}

VM_API void vmi_slow_phase(vm_real x, vm_real v, vm_real k, vm_real mass, vm_real alpha, vm_real *A, vm_real *psi)
{
    vm_osc_amplitude_phase(x, v, VM_SQRT(k / mass), alpha, A, psi);
}

#endif
