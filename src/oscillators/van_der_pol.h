/* oscillators/van_der_pol.h - the Van der Pol oscillator with variable mass */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_H

#include "../ateb/beta.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../jacobi/means.h"
#include "constant_mass.h"
#include "slow.h"

/* m x'' + k x|x|^(alpha-1) = (b - c x^2) x' - r m' x' (404). Here b > 0 feeds the vibration; b and c are the eps b
   and eps c of [1], of either sign. vm_vdp_init checks alpha, k, b, c, reactive and method and fills a1, a2, a3,
   which the other functions need; the mass is for the equations of motion only. */
typedef struct VM_TAG(vm_vdp) {
    vm_real alpha, k, b, c; /* alpha >= 0; k > 0 N/m^alpha; kg/s; kg/(s m^2) */
    vm_real reactive;       /* r: 1 where what joins or leaves is at rest, 0 where it has the body's velocity */
    int method;             /* of averaging */
    vm_slow_mass mass;
    void *mass_ctx;
    vm_real a1, a2, a3;
} vm_vdp;

enum {
    VM_VDP_ATEB = 0,         /* about the exact generating solution: a1 = 1, exact to first order */
    VM_VDP_JACOBI = 1,       /* (411)-(413), exact means; the steady amplitude is right to 0.5 % for alpha <= 5 */
    VM_VDP_TRIGONOMETRIC = 2 /* a3/a1 = 1/(2 (alpha + 3)): the steady amplitude does not depend on alpha */
};

VM_API int vm_vdp_init(vm_vdp *v)
{
    vm_real C2, C4, C6, m;
    if (!v || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(v->alpha) || !VM_IS_FINITE(v->k) || !VM_IS_FINITE(v->b) || !VM_IS_FINITE(v->c) ||
        !VM_IS_FINITE(v->reactive))
        return VM_NOT_FINITE;
    if (!(v->alpha >= 0) || !(v->k > 0)) return VM_DOMAIN;
    v->a1 = 1;
    v->a2 = 2 / (v->alpha + 3);
    if (v->method == VM_VDP_ATEB) v->a3 = 2 / (v->alpha + 1) * ateb_mean(v->alpha, 2, 2);
    if (v->method == VM_VDP_TRIGONOMETRIC) v->a3 = v->a2 / 4;
    if (v->method != VM_VDP_JACOBI) return VM_OK;
    m = vm_osc_jacobi_parameter(v->alpha);
    jacobi_cn_means(m, &C2, &C4, &C6);
    v->a2 = (1 - m) - (1 - 2 * m) * C2 - m * C4;
    v->a1 = (v->alpha + 3) / 2 * v->a2; /* (411), since (1 - m) + m C4 = 2 a2 */
    v->a3 = (1 - m) * C2 - (1 - 2 * m) * C4 - m * C6;
    return VM_OK;
}

/* 2b - (2r-1) m', what feeds the vibration */
VM_API vm_real vmi_vdp_drive(const vm_vdp *v, vm_real mass_rate)
{
    return 2 * v->b - (2 * v->reactive - 1) * mass_rate;
}

/* Amplitude at t where it was first_A at t = 0 and the mass is m.mass + m.rate t > 0; m.rate may be 0: (422), (424),
   (427), (429), (431)-(435), (437) in one, as corrected, smooth through q = 0. Right to 1e-14 but for what is
   averaged. c < 0 may carry it to infinity in a finite time: NaN from there on. */
/* 1/A^2 = e^-F (1/first_A^2 + 2 c a3/a1 int e^F dt/m) (416). F = drive a2/a1 int dt/m is linear in int dt/m where m' is
   constant, so that the integral is phi(F) int dt/m. Written with e^-|F| and the larger of the two terms taken out.
   */
VM_API vm_real vm_vdp_amplitude(const vm_vdp *v, vm_real t, vm_real first_A, vm_linear_mass m)
{
    if (!v) return VM_NAN;
    vm_real ln_ratio, integral, F, damping, root, e, s, denominator;
    if (!VM_IS_FINITE(first_A) || !(v->a1 > 0) || !vmi_slow_linear(m, t, &ln_ratio, &integral)) return VM_NAN;
    F = vmi_vdp_drive(v, 0) * (v->a2 / v->a1) * integral - (2 * v->reactive - 1) * (v->a2 / v->a1) * ln_ratio;
    e = vmi_exp(-VM_FABS(F), 0);
    damping = 2 * v->c * (v->a3 / v->a1) * integral * vmi_exp_ratio(-VM_FABS(F));
    root = VM_SQRT(VM_FABS(damping));
    s = VM_FABS(first_A) * root; /* squared, and with damping's sign, beside 1 or e^-|F| */
    if (s > 1) {
        denominator = (F > 0 ? e / s : 1 / s) / s + VM_COPYSIGN(1, damping);
        first_A = VM_COPYSIGN(1 / root, first_A);
    } else {
        denominator = (F > 0 ? e : 1) + VM_COPYSIGN(s * s, damping);
    }
    return denominator < 0 ? VM_NAN : first_A * VM_SQRT((F > 0 ? 1 : e) / denominator);
}

/* The amplitude other than 0 that stays while the mass changes at mass_rate, (425), (430), (438); 0 where there is
   none. stable, where not null: whether the amplitudes around tend to the one returned. */
VM_API vm_real vm_vdp_limit_cycle(const vm_vdp *v, vm_real mass_rate, int *stable_or_NULL)
{
    if (!v) return VM_NAN;
    const vm_real drive = vmi_vdp_drive(v, mass_rate);
    const int exists = (drive > 0 && v->c > 0) || (drive < 0 && v->c < 0);
    if (!VM_IS_FINITE(drive) || !(v->a1 > 0)) return VM_NAN;
    if (stable_or_NULL) *stable_or_NULL = exists ? v->c > 0 : drive < 0 || (drive == 0 && v->c > 0);
    return exists ? VM_SQRT(drive / v->c * (v->a2 / (2 * v->a3))) : 0;
}

/* Equations for rk45 or rk87, ctx a vm_vdp: of motion, y = (x, x') (404); averaged, y = (A, psi), any mass (410),
   where x = A ca(psi). They return a status of this header, which stops the run, where the mass is not positive. */
VM_API int vm_vdp_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_slow_mass(v->mass, v->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[1];
    dydt[1] = ((v->b - v->c * y[0] * y[0] - v->reactive * rate) * y[1] - v->k * vmi_osc_elastic(y[0], v->alpha)) /
              mass;
    return VM_OK;
}

/* Documented with vm_vdp_rhs. */
VM_API int vm_vdp_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_slow_mass(v->mass, v->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[0] / (v->a1 * mass) * (vmi_vdp_drive(v, rate) * v->a2 / 2 - v->c * y[0] * y[0] * v->a3);
    dydt[1] = vmi_slow_rate(y[0], v->k, mass, v->alpha);
    return VM_OK;
}

#endif
