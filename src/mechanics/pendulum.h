/* mechanics/pendulum.h - a pendulum from which a part is cut */
#ifndef VARMASS_MECHANICS_PENDULUM_H
#define VARMASS_MECHANICS_PENDULUM_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"

/* Example (119)-(132), corrected: a uniform rod of mass M swings about its end O; the outer length l, and with it
   m = M l/L, leaves at the relative velocity u and angular velocity Omega. */
enum {
    VM_AXES_COS_SIN = 0, /* S2 at (cos, sin) angle: angle from x, counterclockwise; what (122), (125), (132) need */
    VM_AXES_SIN_COS = 1  /* S2 at (sin, cos) angle (123): x across, y along, so that the angle turns clockwise */
};

typedef struct VM_TAG(vm_pendulum) {
    vm_real mass, length; /* M, L > 0 */
    vm_real angle, rate;  /* phi, phi' */
    int axes;
} vm_pendulum;

typedef struct VM_TAG(vm_pendulum_cut) {
    vm_pendulum rest;         /* rest.rate is phi1' */
    vm_real mass;             /* of the part, m */
    vm_real x, y, vx, vy;     /* of S2 (123), (121) */
    vm_real rate;             /* of the part, phi' + Omega; turns as phi does */
    vm_real T1, T_S1, T_S2;   /* kinetic energies (119), (124), (122) corrected, J */
    vm_real L1, L2;           /* angular momenta about O of the rest (130) and the part (128) corrected */
    vm_real pivot_x, pivot_y; /* impulse of the pivot on the rest during the cut, N s */
} vm_pendulum_cut;

VM_API int vmi_check_pendulum(const vm_pendulum *p, vm_real part)
{
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->length) || !VM_IS_FINITE(p->angle) || !VM_IS_FINITE(p->rate) ||
        !VM_IS_FINITE(part))
        return VM_NOT_FINITE;
    if (!(p->mass > 0)) return VM_BAD_MASS;
    if (p->axes != VM_AXES_COS_SIN && p->axes != VM_AXES_SIN_COS) return VM_DOMAIN;
    return part > 0 && part < p->length ? VM_OK : VM_DOMAIN;
}

/* part is l, 0 < l < L; u in the axes of the pendulum. phi1' = phi' - l/(L - l)^3 (l^2 Omega/4 + 3 s (x u_y - y
   u_x)), s = 1 for (cos, sin), -1 for (sin, cos): (125), (132) corrected, with what cancels cancelled */
/* With e from O to S2, f across it the way the angle grows: x u_y - y u_x = s rho u.f */
VM_API int vm_pendulum_separate(const vm_pendulum *pendulum, vm_real part, vm_real Omega, vm_real ux, vm_real uy,
                                vm_pendulum_cut *cut)
{
    vm_pendulum_cut c;
    vm_real ex, ey, fx, fy, rho, left, rest_mass, across, change;
    int status;
    if (!pendulum || !cut) return VM_BAD_ARGUMENT;
    status = vmi_check_pendulum(pendulum, part);
    if (status) return status;
    if (pendulum->axes == VM_AXES_COS_SIN) {
        vmi_sincos(pendulum->angle, &ey, &ex);
        fx = -ey;
        fy = ex;
    } else {
        vmi_sincos(pendulum->angle, &ex, &ey);
        fx = ey;
        fy = -ex;
    }
    rho = pendulum->length - part / 2;
    left = pendulum->length - part;
    across = ux * fx + uy * fy;
    change = -part * (part * part * Omega / 4 + 3 * rho * across) / (left * left * left);

    c.rest = *pendulum;
    c.rest.mass = rest_mass = pendulum->mass * (left / pendulum->length);
    c.rest.length = left;
    c.rest.rate = pendulum->rate + change;
    c.mass = pendulum->mass * (part / pendulum->length);
    c.x = rho * ex;
    c.y = rho * ey;
    c.vx = pendulum->rate * rho * fx + ux;
    c.vy = pendulum->rate * rho * fy + uy;
    c.rate = pendulum->rate + Omega;
    c.L1 = rest_mass * left * left * c.rest.rate / 3;
    c.L2 = c.mass * (part * part * c.rate / 12 + rho * (rho * pendulum->rate + across));
    c.T1 = pendulum->mass * pendulum->length * pendulum->length * pendulum->rate * pendulum->rate / 6;
    c.T_S1 = c.L1 * c.rest.rate / 2;
    c.T_S2 = c.mass * ((c.vx * c.vx + c.vy * c.vy) / 2 + part * part * c.rate * c.rate / 24);
    c.pivot_x = rest_mass * left / 2 * change * fx + c.mass * ux; /* momentum after less before */
    c.pivot_y = rest_mass * left / 2 * change * fy + c.mass * uy;
    if (!VM_IS_FINITE(c.rest.rate) || !VM_IS_FINITE(c.vx) || !VM_IS_FINITE(c.vy) || !VM_IS_FINITE(c.T1) ||
        !VM_IS_FINITE(c.L1) || !VM_IS_FINITE(c.L2) || !VM_IS_FINITE(c.T_S1) || !VM_IS_FINITE(c.T_S2) ||
        !VM_IS_FINITE(c.pivot_x) || !VM_IS_FINITE(c.pivot_y))
        return VM_NOT_FINITE;
    *cut = c;
    return VM_OK;
}

#endif
