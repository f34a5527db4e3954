/* oscillators/pair.h - two bodies with a nonlinear connection */
#ifndef VARMASS_OSCILLATORS_PAIR_H
#define VARMASS_OSCILLATORS_PAIR_H

#include "../ateb/functions.h"
#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "slow.h"

/* Equal masses m with k (x - y)|x - y|^(alpha-1) between them, and -r m' x', -r m' y' (517), (518). y = (x, y, x',
   y'). */
typedef struct VM_TAG(vm_pair) {
    vm_real alpha, k, reactive; /* alpha >= 0; k > 0 N/m^alpha; r */
    vm_slow_mass mass;          /* not needed by vm_pair_at */
    void *mass_ctx;
} vm_pair;

VM_API int vm_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    const vm_real force = p->k * vmi_osc_elastic(y[0] - y[1], p->alpha);
    vm_real mass, rate;
    const int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (-force - p->reactive * rate * y[2]) / mass;
    dydt[3] = (force - p->reactive * rate * y[3]) / mass;
    return VM_OK;
}

VM_API int vmi_pair_check(const vm_pair *p, vm_real mass, vm_real rate)
{
    if (!VM_IS_FINITE(p->alpha) || !VM_IS_FINITE(p->k) || !VM_IS_FINITE(p->reactive) || !VM_IS_FINITE(mass) ||
        !VM_IS_FINITE(rate))
        return VM_NOT_FINITE;
    if (!(mass > 0)) return VM_BAD_MASS;
    return p->alpha >= 0 && p->k > 0 ? VM_OK : VM_DOMAIN;
}

/* A over its mean at phase psi, (1 + q sa ca/(2 Om))^(2/(alpha+3)), q = (2r-1) m'/m, Om at the mean A */
VM_API vm_real vmi_pair_ripple(const vm_pair *p, vm_real mass, vm_real rate, vm_real A, vm_real psi)
{
    const vm_real q = (2 * p->reactive - 1) * rate / mass, Om = vmi_slow_rate(A, 2 * p->k, mass, p->alpha);
    vm_real sa, ca;
    ateb_saca(psi, p->alpha, &sa, &ca);
    return vmi_pow_checked(1 + q / (2 * Om) * sa * ca, 2 / (p->alpha + 3));
}

VM_API int vmi_pair_split(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *y, vm_real *modes)
{
    vm_real exact, A, found[4];
    int i;
    if (!vmi_all_finite(4, y)) return VM_NOT_FINITE;
    vmi_slow_phase(y[1] - y[0], y[3] - y[2], 2 * p->k, mass, p->alpha, &exact, &found[1]);
    A = exact;
    for (i = 0; i < 3 && exact > 0; i++) A = exact / vmi_pair_ripple(p, mass, rate, A, found[1]);
    if (exact > 0 && !(VM_FABS(A * vmi_pair_ripple(p, mass, rate, A, found[1]) - exact) <= exact / 8))
        return VM_DOMAIN; /* the ripple is as large as the motion: its equation is not solved */
    if (!(A >= 0) || !VM_IS_FINITE(A)) return VM_DOMAIN;
    found[0] = A;
    found[2] = y[0] + y[1];
    found[3] = y[2] + y[3];
    return vmi_copy_if_finite(4, found, modes);
}

VM_API int vmi_pair_join(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *modes, vm_real *y)
{
    const vm_real q = modes[2], dq = modes[3];
    vm_real A = modes[0], x, v, joined[4];
    if (!vmi_all_finite(4, modes)) return VM_NOT_FINITE;
    if (A > 0) A *= vmi_pair_ripple(p, mass, rate, A, modes[1]);
    if (!(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, modes[1], 2 * p->k, mass, p->alpha, &x, &v);
    joined[0] = (q - x) / 2;
    joined[1] = (q + x) / 2;
    joined[2] = (dq - v) / 2;
    joined[3] = (dq + v) / 2;
    return vmi_copy_if_finite(4, joined, y);
}

/* q = x + y drifts, p = y - x vibrates (520)-(522): modes = (A, psi, q, q') with A the mean amplitude of p, free of
   first ripple, so that any initial velocities do. VM_DOMAIN where the ripple is as large as the motion,
   |(2r - 1) m'/m| some 2 Omega, as it is where m -> 0. Averaged equations of the modes for any mass. */
VM_API int vm_pair_to_averaged(const vm_pair *p, vm_real t, const vm_real *y, vm_real *modes)
{
    if (!p || !y || !modes) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (!status) status = vmi_pair_check(p, mass, rate);
    return status ? status : vmi_pair_split(p, mass, rate, y, modes);
}

/* Documented with vm_pair_to_averaged. */
VM_API int vm_pair_from_averaged(const vm_pair *p, vm_real t, const vm_real *modes, vm_real *y)
{
    if (!p || !modes || !y) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (!status) status = vmi_pair_check(p, mass, rate);
    return status ? status : vmi_pair_join(p, mass, rate, modes, y);
}

/* Documented with vm_pair_to_averaged. */
VM_API int vm_pair_averaged_rhs(vm_real t, const vm_real *modes, vm_real *dmodes, void *pair)
{
    if (!modes || !dmodes || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    vm_real mass, rate;
    const int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dmodes[0] = -(2 * p->reactive - 1) * rate / ((p->alpha + 3) * mass) * modes[0];
    dmodes[1] = vmi_slow_rate(modes[0], 2 * p->k, mass, p->alpha);
    dmodes[2] = modes[3];
    dmodes[3] = -p->reactive * rate / mass * modes[3];
    return VM_OK;
}

/* y at t where it was y0 at t = 0, for the mass m.mass + m.rate t, closed: (528), (529) with p0 = y0 - x0. Error of
   order m.rate over times of order 1/m.rate; VM_DOMAIN as above, at either end. y may be y0. */
/* Powers of m/m0 integrate to int (m/m0)^e dt = m0 phi((1 + e) ln(m/m0)) int dt/m */
VM_API int vm_pair_at(const vm_pair *p, vm_real t, const vm_real *y0, vm_linear_mass m, vm_real *y)
{
    if (!p || !y0 || !y) return VM_BAD_ARGUMENT;
    const vm_real drift = (2 * p->reactive - 1) / (p->alpha + 3);
    vm_real modes[4], ln_ratio, integral, rate0, exponent;
    int status = vmi_pair_check(p, m.mass, m.rate);
    if (!status) status = vmi_pair_split(p, m.mass, m.rate, y0, modes);
    if (status) return status;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!vmi_slow_linear(m, t, &ln_ratio, &integral)) return VM_BAD_MASS;
    rate0 = vmi_slow_rate(modes[0], 2 * p->k, m.mass, p->alpha);
    exponent = VM_C(0.5) - (p->alpha - 1) / 2 * drift;
    modes[1] += rate0 * m.mass * integral * vmi_exp_ratio(exponent * ln_ratio);
    modes[0] *= vmi_exp(-drift * ln_ratio, 0);
    modes[2] += modes[3] * m.mass * integral * vmi_exp_ratio((1 - p->reactive) * ln_ratio);
    modes[3] *= vmi_exp(-p->reactive * ln_ratio, 0);
    return vmi_pair_join(p, m.mass + m.rate * t, m.rate, modes, y);
}

#endif
