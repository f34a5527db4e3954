/* oscillators/constant_mass.h - the oscillator x'' + omega0^2 x|x|^(alpha-1) = 0 of constant mass

   A mass m is fixed to a spring with the force -k x|x|^(alpha-1), and omega0 = sqrt(k/m). alpha is any real
   number >= 0: 1 is the linear spring, 3 the cubic one. Numbers in brackets are equations of the dissertation. This
   file has the period of the motion (262), its largest velocity (267) and its energy (259). It has the exact motion by
   the Ateb functions (282), (283), from rest or from any state. It also has the approximations by the cosine
   (291)-(296) and by Jacobi's cn (297)-(307), with their errors (268). The shortest useful calls:
       vm_real T = vm_osc_period(2, 1, VM_C(1.5)), x, v; // x'' = -x|x|^0.5 from x = 2 at rest
       vm_osc_exact(T / 8, 2, 1, VM_C(1.5), &x, &v);
   The functions return or write NaN for alpha < 0 and for infinite arguments. The two functions that find the phase of
   a state, vm_osc_amplitude_phase and vm_osc_exact_from, also write NaN for omega0 = 0 and for alpha > 1e30. If a
   pointer to an output is null, nothing is written. With x in metres the unit of omega0 is metre^((1-alpha)/2)/s.
   Symbols: A is the amplitude, psi the Ateb phase, Om the rate of psi.
   Tests: tests/test_constant_mass.c. */
#ifndef VARMASS_OSCILLATORS_CONSTANT_MASS_H
#define VARMASS_OSCILLATORS_CONSTANT_MASS_H

#include "../ateb/functions.h"
#include "../ateb/period.h"
#include "../ateb/phase.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../jacobi/modulus.h"
#include "force_terms.h"
#include "waves.h"

/* -- Period, velocity, energy -- */
VM_API int vmi_osc_alpha_is_valid(vm_real alpha) { return alpha >= 0 && VM_IS_FINITE(alpha); }

/* Om, the rate of the Ateb phase psi at the amplitude |x0|: sqrt((alpha+1)/2) omega0 |x0|^((alpha-1)/2), 1/s. Returns
   NaN for alpha < 0 and for arguments that are infinite or NaN. */
VM_API vm_real vmi_osc_rate(vm_real x0, vm_real omega0, vm_real alpha)
{
    if (!vmi_osc_alpha_is_valid(alpha) || !VM_IS_FINITE(x0) || !VM_IS_FINITE(omega0)) return VM_NAN;
    if (omega0 == 0) return 0; /* the power of |x0| may be infinite */
    return VM_SQRT((alpha + 1) / 2) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha - 1) / 2);
}

/* Om, the rate of the Ateb phase, of a motion that starts at rest at x0. Returns 0 at x0 = 0, where the power may be
   infinite. */
VM_API vm_real vmi_osc_rate_from_rest(vm_real x0, vm_real omega0, vm_real alpha)
{
    const vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (x0 == 0 && rate == rate) return 0;
    return rate;
}

/* Exact period (262), s, of the motion from rest at x0 (m, either sign). */
VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha)
{
    return 2 * ateb_pi(alpha) / vmi_osc_rate(x0, omega0, alpha);
}

/* Largest velocity (267), m/s, of the motion from rest at x0 (m, either sign). */
VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha)
{
    const vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (rate != rate) return rate;
    if (omega0 == 0) return 0; /* the power of |x0| may be infinite */
    return VM_SQRT(2 / (alpha + 1)) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha + 1) / 2);
}

/* x|x|^(alpha-1). The elastic force is -k times this number. */
VM_API vm_real vmi_osc_elastic(vm_real x, vm_real alpha)
{
    if (alpha == 1 || x == 0) return x;
    if (alpha == 3) return x * x * x;
    return vmi_elastic_power(x, alpha);
}

/* Energy per unit mass (259), v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1), m^2/s^2. */
VM_API vm_real vm_osc_energy(vm_real x, vm_real v, vm_real omega0, vm_real alpha)
{
    if (!vmi_osc_alpha_is_valid(alpha)) return VM_NAN;
    if (!VM_IS_FINITE(x) || !VM_IS_FINITE(v) || !VM_IS_FINITE(omega0)) return VM_NAN;
    if (omega0 == 0) return v * v / 2; /* the power of |x| may be infinite */
    return v * v / 2 + omega0 * omega0 * vmi_pow_checked(VM_FABS(x), alpha + 1) / (alpha + 1);
}

/* -- Exact motion -- */

/* Writes position x and velocity v at the Ateb phase psi of a motion with the amplitude A, of either sign. */
VM_API void vmi_osc_at_phase(vm_real A, vm_real psi, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vm_real sa, ca;
    ateb_saca(psi, alpha, &sa, &ca);
    *x = A * ca;
    *v = -VM_COPYSIGN(vm_osc_vmax(A, omega0, alpha), A) * sa;
}

/* Exact motion x(t) (282) and x'(t) (283) from rest at x0 (m, either sign). */
VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vmi_osc_at_phase(x0, vmi_osc_rate_from_rest(x0, omega0, alpha) * t, omega0, alpha, x, v);
}

/* (a^n + b^n)^(1/n) for a, b >= 0, computed so that no power overflows unless the result itself overflows */
VM_API vm_real vmi_osc_power_norm(vm_real a, vm_real b, vm_real n)
{
    const vm_real larger = vmi_larger(a, b), smaller = vmi_smaller(b, a);
    if (larger == 0 || a == 0 || b == 0) return larger;
    return larger * vmi_pow_checked(1 + vmi_pow_checked(smaller / larger, n), 1 / n);
}

/* Amplitude A >= 0 (m) and Ateb phase psi in (-Pi, Pi] of the state x (m), v (m/s). They satisfy x = A ca(psi), v =
   -vmax(A) sa(psi), where Pi = Pi_alpha and vmax is vm_osc_vmax. Method: let B be the amplitude whose largest velocity
   vmax(B) is |v|. Then conservation of energy gives A^(alpha+1) = |x|^(alpha+1) + B^(alpha+1). */
VM_API void vm_osc_amplitude_phase(vm_real x, vm_real v, vm_real omega0, vm_real alpha, vm_real *A, vm_real *psi)
{
    if (!A || !psi) return;
    const vm_real n = alpha + 1, s = v / (VM_SQRT(2 / n) * VM_FABS(omega0)); /* B^(n/2), with the sign of v */
    *A = VM_NAN;
    *psi = VM_NAN;
    if (!vmi_osc_alpha_is_valid(alpha)) return;
    if (!VM_IS_FINITE(x) || !VM_IS_FINITE(s) || !VM_IS_FINITE(omega0)) return;
    *A = vmi_osc_power_norm(VM_FABS(x), vmi_pow_checked(VM_FABS(s), 2 / n), n);
    *psi = ateb_phase(0 - s, x, alpha); /* 0 - s is 0 and not -0 where s is 0 */
}

/* Exact motion x(t), x'(t) from any state x(0) = x0 (m), x'(0) = v0 (m/s). */
VM_API void vm_osc_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real omega0, vm_real alpha, vm_real *x,
                              vm_real *v)
{
    if (!x || !v) return;
    vm_real A, psi, rate = 0;
    vm_osc_amplitude_phase(x0, v0, omega0, alpha, &A, &psi);
    if (A != 0) rate = vmi_osc_rate(A, omega0, alpha);
    vmi_osc_at_phase(A, psi + rate * t, omega0, alpha, x, v);
}

/* The mean of |ca|^power over a period. It is B(q, 1/2)/Pi_alpha with q = (power+1)/(alpha+1) and Euler's beta function
   B; the argument pi is Pi_alpha. For q <= 1, B(q, 1/2) is the Pi_alpha of the exponent 1/q - 1. For q > 1, B(q, 1/2)
   follows from the recurrence formula of B. `constants` is the function that computes Pi_alpha of a given exponent. */
VM_API vm_real vmi_osc_mean_ca(vm_real power, vm_real alpha, vm_real pi, vmi_ateb_constants_of constants)
{
    vm_real q = (power + 1) / (alpha + 1), factor = 1;
    vmi_ateb c;
    for (; q > 1; q -= 1) factor *= (q - 1) / (q - VM_C(0.5));
    constants(&c, 1 / q - 1);
    return factor * (2 * c.quarter.hi) / pi;
}

/* -- Approximations by cos and cn, with the exact amplitude and period -- */

/* Writes position x and velocity v at time t, by the wave w, of a motion that starts at rest at x0. */
VM_API void vmi_osc_by_wave(const vmi_osc_wave *w, vm_real t, vm_real x0, vm_real omega0, vm_real *x, vm_real *v)
{
    vm_real c, s;
    vmi_osc_wave_at(w, vmi_osc_rate_from_rest(x0, omega0, w->alpha) * t, &c, &s);
    *x = x0 * c;
    *v = -VM_COPYSIGN(w->speed * vm_osc_vmax(x0, omega0, w->alpha), x0) * s;
}

/* Frequency Omega_alpha (293) of the cosine with the exact period of the oscillator, a pure number. Omega_alpha is the
   frequency for x0 = omega0 = 1. In general the frequency is Omega_alpha omega0 |x0|^((alpha-1)/2), rad/s. */
VM_API vm_real vm_osc_omega_trig(vm_real alpha) { return VM_PI * vmi_osc_rate(1, 1, alpha) / ateb_pi(alpha); }

/* Approximation x0 cos(Omega t) (291) and its velocity (295), from rest at x0. Amplitude and period are exact. The
   frequency Omega is that of vm_osc_omega_trig. */
VM_API void vm_osc_trig(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    const vmi_osc_wave w = vmi_osc_wave_cos(alpha, ateb_pi(alpha));
    vmi_osc_by_wave(&w, t, x0, omega0, x, v);
}

/* Parameter m (307) of the cn that approximates x(t) with the exact period of the oscillator. m = k^2 may be negative:
   -1.8079 < m < 0.8062. */
VM_API vm_real vm_osc_jacobi_parameter(vm_real alpha) { return jacobi_solve_kpK(ateb_pi(alpha) / (alpha + 1)); }

/* Frequency Omega_1* (300) of the cn with the exact period of the oscillator, a pure number. Omega_1* is the frequency
   for x0 = omega0 = 1. In general the frequency is Omega_1* omega0 |x0|^((alpha-1)/2), 1/s. The function uses (300),
   with the quarter period of cn from (307): K = Pi_alpha/((alpha+1) k'). */
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha)
{
    return VM_SQRT(2 / ((alpha + 1) * jacobi_solve_kpK_m1(ateb_pi(alpha) / (alpha + 1))));
}

/* Approximation x0 cn(Omega_1 t | m) (297) and its velocity (302), from rest at x0. Amplitude, period and the
   velocity at x = 0 are exact. The frequency Omega_1 is that of vm_osc_omega_jacobi, the parameter m that of
   vm_osc_jacobi_parameter. */
VM_API void vm_osc_jacobi(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    const vmi_osc_wave w = vmi_osc_wave_cn(alpha, ateb_pi(alpha));
    vmi_osc_by_wave(&w, t, x0, omega0, x, v);
}

/* The result of vm_osc_approximation_errors: for each approximation its largest velocity divided by the exact largest
   velocity (268), and the largest errors of x and v in a period. All are pure numbers. */
typedef struct VM_TAG(vm_osc_errors) {
    vm_real trig_vmax;          /* largest velocity of the cosine (296) divided by the exact one (267) */
    vm_real jacobi_vmax;        /* largest velocity of cn divided by the exact one (267). For m <= 1/2 the largest
                                   velocity of cn is k' Omega_1 (306), at x = 0. For m > 1/2 it is Omega_1/(2k), where
                                   cn^2 = 1 - 1/(2m). Here k = sqrt(m), k' = sqrt(1 - m) */
    vm_real trig_x, trig_v;     /* largest errors of the cosine, of x relative to x0 and of v relative to vmax */
    vm_real jacobi_x, jacobi_v; /* largest errors of cn, of x relative to x0 and of v relative to vmax */
} vm_osc_errors;

/* Errors of the approximations by cos and cn, as the fields of vm_osc_errors. The errors depend on alpha alone. The
   largest errors in a period are found from 257 points of a quarter of the period. */
VM_API vm_osc_errors vm_osc_approximation_errors(vm_real alpha)
{
    const vm_real pi = ateb_pi(alpha);
    vm_osc_errors r = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vmi_osc_wave w;
    if (pi != pi) return r;
    w = vmi_osc_wave_cos(alpha, pi);
    r.trig_vmax = w.speed;
    vmi_osc_wave_differences(&w, pi, &r.trig_x, &r.trig_v);
    w = vmi_osc_wave_cn(alpha, pi);
    r.jacobi_vmax = 1;
    if (w.m > VM_C(0.5)) r.jacobi_vmax = w.speed / (2 * VM_SQRT(w.m));
    vmi_osc_wave_differences(&w, pi, &r.jacobi_x, &r.jacobi_v);
    return r;
}

#endif
