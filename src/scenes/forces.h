/* scenes/forces.h - the forces of effects, as functions that can also be called without a scene

   The effects of a scene use these functions, and a right-hand side that is written by hand can call them as well.
   They return a force in N, or a torque in N m where the coordinate is an angle. x is the extension (m or rad) and v
   the rate of the extension (m/s or rad/s). Arguments are not checked; NaN gives NaN. The error is at most 6
   VM_EPSILON times the sum of the absolute values of the terms of the force, if the angle in a sine or cosine has no
   error.

       vm_real x = VM_C(0.1), v = 2, mass = 3;
       vm_real acceleration = (vm_force_spring(x, 50, 3) + vm_force_damper(v, 2)) / mass; // (-50 x^3 - 2 v) / mass

   Tests: tests/test_forces.c. */
#ifndef VARMASS_SCENES_FORCES_H
#define VARMASS_SCENES_FORCES_H

#include "../base/elementary.h"
#include "../base/hypot.h"
#include "../base/real.h"
#include "../oscillators/force_terms.h"

/* The force of a spring, -k x |x|^(alpha-1) (248). The stiffness k in N/m^alpha may have either sign; alpha must not be
   negative. For alpha = 1, 2 and 3 the power function is not called. */
VM_INLINE vm_real vm_force_spring(vm_real x, vm_real k, vm_real alpha)
{
    if (alpha == 1) return -k * x;
    if (alpha == 3) return -(k * x) * (x * x);
    if (alpha == 2) return -k * (x * VM_FABS(x));
    return -k * vmi_elastic_power(x, alpha) * (x != 0);
}

/* The force of a linear damper, -damping v. damping is in N s/m; if it is positive, the damper takes energy out. */
VM_INLINE vm_real vm_force_damper(vm_real v, vm_real damping) { return -damping * v; }

/* The force of Van der Pol's damper, (b - c x^2) v (404). A positive b in N s/m feeds energy in; a positive c in
   N s/m^3 takes energy out at large amplitudes. */
VM_INLINE vm_real vm_force_van_der_pol(vm_real x, vm_real v, vm_real b, vm_real c)
{
    return vmi_van_der_pol_feed(b, c, x) * v;
}

/* The torque of a motor, stall_torque - kappa omega. omega is the angular velocity in rad/s, stall_torque the torque at
   rest in N m, and kappa in N m s the decrease of the torque per rad/s. */
VM_INLINE vm_real vm_force_motor(vm_real omega, vm_real stall_torque, vm_real kappa)
{
    return stall_torque - kappa * omega;
}

/* The force of harmonic excitation, amplitude cos(frequency t + phase). amplitude is in N, frequency in rad/s, phase in
   rad. */
VM_INLINE vm_real vm_force_harmonic(vm_real t, vm_real amplitude, vm_real frequency, vm_real phase)
{
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    return amplitude * c;
}

/* The reactive force of a stream is rate * (u - reactive * v), where the number `reactive` is 1 or 0. The stream
   brings `rate` kg of mass per second; a negative rate takes mass away. This mass has the velocity u + (1 - reactive)
   v, where v is the velocity of the body. Thus u is the absolute velocity of the mass if reactive is 1, and its
   velocity relative to the body if reactive is 0. */
VM_INLINE vm_real vm_force_stream(vm_real v, vm_real rate, vm_real u, vm_real reactive)
{
    return rate * (u - reactive * v);
}

/* The weight of a mass, mass g. mass is in kg and g in m/s^2. g is negative if the coordinate points up. */
VM_INLINE vm_real vm_force_gravity(vm_real mass, vm_real g) { return mass * g; }

/* Divides *x and *y by the larger of |x| and |y|. Returns the number whose product with the new *x and *y is the force
   that vm_force_shaft describes. The function is needed where r, or the force divided by r, overflows or underflows. */
VM_INLINE vm_real vmi_force_shaft_scaled(vm_real *x, vm_real *y, vm_real k, vm_real alpha)
{
    const vm_real most = vmi_larger(VM_FABS(*x), VM_FABS(*y));
    *x /= most;
    *y /= most;
    const vm_real ratio = vmi_hypot(*x, *y);
    return vm_force_spring(most, k, alpha) * (vm_force_spring(ratio, -1, alpha) / ratio);
}

/* The force of an elastic shaft, -k r |r|^(alpha-1), on a point at r = (x, y). It points to the origin of the plane. r
   is in m and the stiffness k in N/m^alpha; alpha must not be negative. The components are written to *fx and *fy; if
   one of these pointers is NULL, nothing is written. */
VM_INLINE void vm_force_shaft(vm_real x, vm_real y, vm_real k, vm_real alpha, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real r = vmi_hypot(x, y);
    vm_real f = r != 0 ? vm_force_spring(r, k, alpha) / r : 0;
    const int in_range = r >= VM_MIN && VM_FABS(f) >= VM_MIN && VM_FABS(f) <= VM_MAX;
    if (!in_range && r != 0) f = vmi_force_shaft_scaled(&x, &y, k, alpha);
    *fx = f * x;
    *fy = f * y;
}

/* The force of a rotating unbalance, m e Omega^2 (cos a, sin a) at the angle a = Omega t + phase. unbalance is the
   mass m times its eccentricity e in kg m, and frequency is the angular velocity Omega in rad/s. The components are
   written to *fx and *fy; if one of these pointers is NULL, nothing is written. */
VM_INLINE void vm_force_unbalance(vm_real t, vm_real unbalance, vm_real frequency, vm_real phase, vm_real *fx,
                                  vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real size = unbalance * (frequency * frequency);
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    *fx = size * c;
    *fy = size * s;
}

/* The gyroscopic force normal to the velocity (vx, vy) in the plane, 2 gyro (-vy, vx). gyro in kg/s is the coefficient
   in the term 2 i gyro z' of the equation of Laval's rotor, where i is the imaginary unit and z = x + i y the
   deflection. The force does no work. The components are written to *fx and *fy; if one of these pointers is NULL,
   nothing is written. */
VM_INLINE void vm_force_gyroscopic(vm_real vx, vm_real vy, vm_real gyro, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    *fx = -vmi_gyroscopic_coupling(gyro) * vy;
    *fy = vmi_gyroscopic_coupling(gyro) * vx;
}

#endif
