/* scenes/forces.h - forces as functions of numbers */
#ifndef VARMASS_SCENES_FORCES_H
#define VARMASS_SCENES_FORCES_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"

/* Forces, N (torques, N m), for right-hand sides that are written by hand; the effects use them. x, v: extension, its
   rate. A spring's force (248), k in N/m^alpha, alpha >= 0; a damper's, b in N s/m; that of Van der Pol's (404), c in
   N s/m^3; a drive's, torque in N m, kappa in N m s; force cos(frequency t + phase), frequency in rad/s; the reactive
   force of a stream of rate kg/s whose own velocity is u + share v. Within some eps of the terms that are added. */
/* -k x |x|^(alpha-1) */
VM_INLINE vm_real vm_force_spring(vm_real k, vm_real alpha, vm_real x)
{
    if (alpha == 1) return -k * x;
    if (alpha == 3) return -(k * x) * (x * x);
    if (alpha == 2) return -k * (x * VM_FABS(x));
    return -VM_COPYSIGN(k, x) * vmi_pow_checked(VM_FABS(x), alpha) * (x != 0);
}

/* -b v */
VM_INLINE vm_real vm_force_damper(vm_real b, vm_real v) { return -b * v; }

/* (b - c x^2) v */
VM_INLINE vm_real vm_force_van_der_pol(vm_real b, vm_real c, vm_real x, vm_real v) { return (b - c * (x * x)) * v; }

/* torque - kappa omega */
VM_INLINE vm_real vm_force_motor(vm_real torque, vm_real kappa, vm_real omega) { return torque - kappa * omega; }

/* Documented with vm_force_spring. */
VM_INLINE vm_real vm_force_harmonic(vm_real force, vm_real frequency, vm_real phase, vm_real t)
{
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    return force * c;
}

/* rate (u + share v - v) */
VM_INLINE vm_real vm_force_stream(vm_real rate, vm_real u, vm_real share, vm_real v)
{
    return rate * (u + (share - 1) * v);
}

/* mass g */
VM_INLINE vm_real vm_force_gravity(vm_real mass, vm_real g) { return mass * g; }

/* Documented with vm_force_spring. */
VM_INLINE void vm_force_shaft(vm_real k, vm_real alpha, vm_real x, vm_real y, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real r = VM_SQRT(x * x + y * y), f = r > 0 ? vm_force_spring(k, alpha, r) / r : 0;
    *fx = f * x;
    *fy = f * y;
}

/* Documented with vm_force_spring. */
VM_INLINE void vm_force_unbalance(vm_real unbalance, vm_real frequency, vm_real phase, vm_real t, vm_real *fx,
                                  vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real size = unbalance * (frequency * frequency);
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    *fx = size * c;
    *fy = size * s;
}

/* Documented with vm_force_spring. */
VM_INLINE void vm_force_gyroscopic(vm_real coupling, vm_real vx, vm_real vy, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    *fx = -coupling * vy;
    *fy = coupling * vx;
}

#endif
