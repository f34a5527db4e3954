/* oscillators/constant_mass.h - the oscillator of constant mass */
#ifndef VARMASS_OSCILLATORS_CONSTANT_MASS_H
#define VARMASS_OSCILLATORS_CONSTANT_MASS_H

#include "../ateb/functions.h"
#include "../ateb/period.h"
#include "../ateb/phase.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../jacobi/modulus.h"
#include "waves.h"

/* How good they are, criterion (268): their largest velocities over the exact one (267), that of cos (296) and that
   of cn, which for m > 1/2 is Omega_1/(2k) next to x = 0, not the k' Omega_1 of (306) at x = 0; and the largest
   errors of x over x0 and of v over vmax in a period. NaN outside alpha >= 0. */
typedef struct VM_TAG(vm_osc_errors) {
    vm_real trig_vmax, jacobi_vmax;
    vm_real trig_x, trig_v, jacobi_x, jacobi_v;
} vm_osc_errors;

/* ds/dt of the Ateb phase, sqrt((alpha+1)/2) omega0 |x0|^((alpha-1)/2); NaN outside the domain */
VM_API vm_real vmi_osc_rate(vm_real x0, vm_real omega0, vm_real alpha)
{
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x0) || !VM_IS_FINITE(omega0)) return VM_NAN;
    if (omega0 == 0) return 0; /* where the power may be infinite */
    return VM_SQRT((alpha + 1) / 2) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha - 1) / 2);
}

/* Started at rest, x(0) = x0, x'(0) = 0 (258), x0 of either sign: exact period (262), s, and largest velocity (267),
   m/s */
VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha)
{
    return 2 * ateb_pi(alpha) / vmi_osc_rate(x0, omega0, alpha);
}

/* Documented with vm_osc_period. */
VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha)
{
    vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (rate != rate) return rate;
    return VM_SQRT(2 / (alpha + 1)) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha + 1) / 2);
}

/* x|x|^(alpha-1) */
VM_API vm_real vmi_osc_elastic(vm_real x, vm_real alpha)
{
    if (alpha == 1 || x == 0) return x;
    if (alpha == 3) return x * x * x;
    return VM_COPYSIGN(vmi_pow_checked(VM_FABS(x), alpha), x);
}

/* x and v at amplitude A, of either sign, and Ateb phase psi */
VM_API void vmi_osc_at_phase(vm_real A, vm_real psi, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vm_real sa, ca;
    ateb_saca(psi, alpha, &sa, &ca);
    *x = A * ca;
    *v = -VM_COPYSIGN(vm_osc_vmax(A, omega0, alpha), A) * sa;
}

/* Exact motion, x(t) = x0 ca(alpha, 1, s) (282) and x'(t) (283), for x0 of either sign */
VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (x0 == 0 && rate == rate) rate = 0; /* at rest, where the rate may be infinite */
    vmi_osc_at_phase(x0, rate * t, omega0, alpha, x, v);
}

/* The approximations with the exact amplitude and period, started at rest: x0 cos(Omega t) (291), (295) with
   Omega_alpha (293), Omega = Omega_alpha omega0 |x0|^((alpha-1)/2); and x0 cn(Omega_1 t | m) (297), (302) with
   Omega_1* (300), m = k^2 (307), -1.8079 < m < 0.8062, which has the exact velocity at x = 0 also */
VM_API vm_real vm_osc_omega_trig(vm_real alpha) { return VM_PI * vmi_osc_rate(1, 1, alpha) / ateb_pi(alpha); }

/* Documented with vm_osc_omega_trig. */
VM_API vm_real vm_osc_jacobi_parameter(vm_real alpha) { return jacobi_solve_kpK(ateb_pi(alpha) / (alpha + 1)); }

/* Documented with vm_osc_omega_trig. */
/* (300) with K = Pi_alpha/((alpha + 1) k') from (307) */
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha)
{
    return VM_SQRT(2 / ((alpha + 1) * jacobi_solve_kpK_m1(ateb_pi(alpha) / (alpha + 1))));
}

/* Energy by mass v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1) (259), m^2/s^2 */
VM_API vm_real vm_osc_energy(vm_real x, vm_real v, vm_real omega0, vm_real alpha)
{
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x) || !VM_IS_FINITE(v) || !VM_IS_FINITE(omega0))
        return VM_NAN;
    return v * v / 2 + omega0 * omega0 * vmi_pow_checked(VM_FABS(x), alpha + 1) / (alpha + 1);
}

/* Amplitude A > 0 (m) and phase psi in (-Pi, Pi] of any state: x = A ca(psi), v = -vmax(A) sa(psi) */
/* The amplitude that the velocity alone would give, A_v^((alpha+1)/2) = v/(sqrt(2/(alpha+1)) omega0), and |x| are put
   together as A^(alpha+1) = |x|^(alpha+1) + A_v^(alpha+1), scaled so that no power overflows that A does not. */
VM_API void vm_osc_amplitude_phase(vm_real x, vm_real v, vm_real omega0, vm_real alpha, vm_real *A, vm_real *psi)
{
    if (!A || !psi) return;
    const vm_real n = alpha + 1, s = v / (VM_SQRT(2 / n) * VM_FABS(omega0));
    vm_real a, b, larger;
    *A = *psi = VM_NAN;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x) || !VM_IS_FINITE(s) || !VM_IS_FINITE(omega0))
        return;
    a = VM_FABS(x);
    b = vmi_pow_checked(VM_FABS(s), 2 / n);
    larger = a > b ? a : b;
    *A = larger == 0 || a == 0 || b == 0 ? larger
                                         : larger * vmi_pow_checked(1 + vmi_pow_checked((a > b ? b : a) / larger, n), 1 / n);
    *psi = ateb_phase(s == 0 ? 0 : -s, x, alpha);
}

/* Exact motion from any x(0) = x0, x'(0) = v0 */
VM_API void vm_osc_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real omega0, vm_real alpha, vm_real *x,
                              vm_real *v)
{
    if (!x || !v) return;
    vm_real A, psi, rate;
    vm_osc_amplitude_phase(x0, v0, omega0, alpha, &A, &psi);
    rate = A == 0 ? 0 : vmi_osc_rate(A, omega0, alpha);
    vmi_osc_at_phase(A, psi + rate * t, omega0, alpha, x, v);
}

VM_API void vmi_osc_constant(int method, vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x,
                             vm_real *v)
{
    const vm_real pi = ateb_pi(alpha);
    const vmi_osc_wave w = vmi_osc_wave_of(method, alpha, pi, NULL);
    vm_real rate = vmi_osc_rate(x0, omega0, alpha), c, s;
    if (x0 == 0 && rate == rate) rate = 0;
    vmi_osc_wave_at(&w, rate * t, &c, &s);
    *x = x0 * c;
    *v = -VM_COPYSIGN(w.speed * vm_osc_vmax(x0, omega0, alpha), x0) * s;
}

/* Documented with vm_osc_omega_trig. */
VM_API void vm_osc_trig(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vmi_osc_constant(VM_ROUTE_TRIG, t, x0, omega0, alpha, x, v);
}

/* Documented with vm_osc_omega_trig. */
VM_API void vm_osc_jacobi(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vmi_osc_constant(VM_ROUTE_JACOBI, t, x0, omega0, alpha, x, v);
}

VM_API vm_osc_errors vm_osc_approximation_errors(vm_real alpha)
{
    const vm_real pi = ateb_pi(alpha);
    vm_osc_errors r = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vmi_osc_wave w;
    if (pi != pi) return r;
    w = vmi_osc_wave_of(VM_ROUTE_TRIG, alpha, pi, NULL);
    r.trig_vmax = w.speed;
    vmi_osc_wave_errors(&w, pi, &r.trig_x, &r.trig_v);
    w = vmi_osc_wave_of(VM_ROUTE_JACOBI, alpha, pi, NULL);
    r.jacobi_vmax = w.m > VM_C(0.5) ? w.speed / (2 * VM_SQRT(w.m)) : 1;
    vmi_osc_wave_errors(&w, pi, &r.jacobi_x, &r.jacobi_v);
    return r;
}

/* <ca^2> = B(3/(alpha+1), 1/2)/Pi_alpha; B(q, 1/2) is Pi of alpha = 1/q - 1, from q <= 1 upward by its recurrence */
VM_API vm_real vmi_osc_mean_ca2(vm_real alpha, vm_real pi)
{
    vm_real q = 3 / (alpha + 1), factor = 1;
    for (; q > 1; q -= 1) factor *= (q - 1) / (q - VM_C(0.5));
    return factor * ateb_pi(1 / q - 1) / pi;
}

#endif
