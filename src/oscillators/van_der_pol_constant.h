/* oscillators/van_der_pol_constant.h - the mean motion of a Van der Pol oscillator of constant mass and stiffness

   The mean motion of oscillators/van_der_pol_walk.h consists of integrals along the laws of mass and stiffness. If mass
   and stiffness are constant and alpha = 1, as in Van der Pol's own equation, these integrals have closed forms. Let
   kappa = feed/m, beta = -F (c/m) A_0^2 with the constant F = -1/4, z = beta/kappa, and y = 1 + z (e^(kappa t) - 1). m
   is the mass, A_0 the mean amplitude at the start of the mean motion, and t the time since this start. To first order
   the amplitude A is A_0 R^(1/2) with R = e^(kappa t)/y, and
       integral of R dt = ln(y)/beta,   integral of R^2 dt = (kappa ln(y)/beta - R + 1)/beta.
   The terms of second order are similar integrals (vmi_vdp_closed_loss). For other alpha the amplitude of first order
   has the same form, with (4/(alpha+3)) kappa in place of kappa in the exponents. But the phase then needs the integral
   of R^((alpha-1)/4) dt, an incomplete beta function whose second parameter is 0. This function is elementary only if
   (alpha-1)/4 is rational, and the orders two and three need several such functions (docs/van-der-pol.md). For these
   alpha the code of oscillators/van_der_pol_walk.h computes all integrals numerically until the limit cycle (the steady
   vibration) is reached. From that time on the phase grows at a constant rate. Therefore the cost does not depend on t.
       vmi_vdp_mean mean;
       vm_vdp_plan plan;
       int status = vm_vdp_plan_init(&plan, &vdp, VM_C(0.3), 0); // vdp is a vm_vdp; from rest at x = 0.3 m
       if (!status) status = vmi_vdp_mean_motion(&plan, 100, &mean);
   Tests: tests/test_van_der_pol_law.c. */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_CONSTANT_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_CONSTANT_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "expansion.h"
#include "laws.h"
#include "van_der_pol_expansion.h"
#include "van_der_pol_walk.h"

/* Returns 1 if the exponential form of a law (vmi_law_exponential_form) shows that the law is constant, else 0. */
VM_API int vmi_vdp_is_constant(const vm_law *law)
{
    vm_real base, rate;
    return vmi_law_exponential_form(law, &base, &rate) && rate == 0;
}

/* The growth of the first-order amplitude from the start of the mean motion to a later or earlier time */
typedef struct VM_TAG(vmi_vdp_growth_course) {
    vm_real kappa, beta, z; /* the numbers at the top of this file; kappa and beta are in 1/s */
    vm_real ln_R, R;        /* logarithm of R, and R = (A/A_0)^2 */
    vm_real ln_y, q;        /* ln(y) for the y at the top of this file, and q = 1/y */
} vmi_vdp_growth_course;

/* Computes kappa, beta and z at the top of this file, for a mean motion that begins with *start. */
VM_API vmi_vdp_growth_course vmi_vdp_course_from(const vm_vdp_plan *p, const vmi_vdp_mean *start)
{
    vmi_vdp_growth_course g;
    g.kappa = p->vdp.feed / start->now.m;
    g.beta = -p->ripple.F * (p->vdp.c / start->now.m) * vmi_exp(2 * start->ln_A, 0);
    g.z = g.beta / g.kappa;
    return g;
}

/* Computes R, y and their logarithms after `time` seconds, of either sign. The code uses exp(-|kappa time|), so that
   nothing overflows. Returns VM_NOT_FINITE where the amplitude becomes infinite before that time. */
VM_API int vmi_vdp_grow(vmi_vdp_growth_course *g, vm_real time)
{
    const vm_real x = g->kappa * time, e = vmi_exp(-VM_FABS(x), 0);
    vm_real free_part = 1 - g->z, limit_part = g->z, sum;
    if (x >= 0) free_part *= e;
    else limit_part *= e;
    sum = free_part + limit_part; /* y if x < 0, else y e^-x */
    if (!(sum > 0)) return VM_NOT_FINITE;
    g->ln_y = vmi_log(sum).hi;
    g->q = 1 / sum;
    if (x >= 0) {
        g->ln_R = -g->ln_y;
        g->ln_y += x;
        g->q *= e;
    } else {
        g->ln_R = x - g->ln_y;
    }
    g->R = vmi_exp(g->ln_R, 0);
    return VM_OK;
}

/* Returns the terms of second order in y, divided by y, for alpha = 1. These terms contain the integrals over time of
   e^(kappa t), e^(kappa t) A^2 and e^(kappa t) A^4, where A is the amplitude of first order. */
VM_API vm_real vmi_vdp_closed_loss(const vm_vdp_plan *p, const vmi_vdp_growth_course *g, vm_real W)
{
    const vmi_vdp_ripple *v = &p->ripple;
    const vm_real a = 1 - g->z, z = g->z, q = g->q, B = -g->beta / v->F; /* B = (c/m) A_0^2 */
    const vm_real rate_p = -g->kappa / 2, nu = g->kappa, G0 = -g->kappa * g->kappa / 4;
    const vm_real J0 = (g->R - q) / g->kappa;
    const vm_real J2 = (1 - q - a * g->ln_y * q) / (g->kappa * z * z);
    const vm_real J4 = (1 - q - 2 * a * g->ln_y * q + a * a * (q - q * q)) / (g->kappa * z * z * z);
    return -B * (v->K3 * (B / W) * (B / W) * J4 + (nu * v->K1 + rate_p * v->KQ) / W * (B / W) * J2 +
                 v->KE * G0 / W / W * J0);
}

/* Computes the mean motion at t in closed form, for alpha = 1. Before the call *mean must be the start of the mean
   motion; the function replaces it by the mean motion at t. */
VM_API int vmi_vdp_closed(const vm_vdp_plan *p, vmi_vdp_growth_course *g, vm_real t, vmi_vdp_mean *mean)
{
    const vmi_ripple *r = &p->osc.ripple;
    const vm_real time = t - mean->t, W = vmi_vdp_rate(p, mean->now.m, mean->now.k, mean->ln_A);
    const vm_real B = -g->beta / p->ripple.F, G0 = -g->kappa * g->kappa / 4, E0 = G0 / W / W;
    vm_real loss, square, fourth;
    int status = vmi_vdp_grow(g, time);
    if (status) return status;
    loss = 1 + vmi_vdp_closed_loss(p, g, W);
    if (!(loss > 0)) return VM_NOT_FINITE;
    square = g->ln_y / g->beta;
    fourth = (g->kappa * square - (g->R - 1)) / g->beta;
    mean->first_psi += W * time;
    mean->psi += W * time + p->ripple.K2 * B * B * fourth / W + r->mean4 * B * (g->kappa / 2) * square / W +
                 r->mean2 * G0 * time / W;
    mean->first_ln_A += g->ln_R / 2;
    mean->ln_A += (g->ln_R - vmi_log(loss).hi) / 2;
    mean->J_error *= g->q / loss;
    mean->J_third *= g->q / loss;
    mean->psi_third += VM_FABS(W * time * vmi_expansion_second(r)) * E0 * E0;
    mean->t = t;
    mean->fast.shortest = vmi_larger(VM_FABS(t), VM_FABS(time));
    return VM_OK;
}

/* Returns the time, s, after which the motion differs from the limit cycle (the steady vibration) by rounding errors
   only. The time is counted from the start of the mean motion, forward for side = 1, backward for side = -1. The result
   is infinite if the motion does not tend to a limit cycle in this direction. */
VM_API vm_real vmi_vdp_settling_time(const vm_vdp_plan *p, const vmi_vdp_growth_course *g, int side)
{
    const vm_real digits = VM_MANT_DIG > 24 ? 45 : 24; /* exp(-45) and, for float, exp(-24) are below the rounding
                                                          error */
    const vm_real share = 4 / (p->vdp.alpha + 3);
    if (!((vm_real)side * g->kappa > 0) || !(g->z > 0)) return VM_INFINITY;
    return (digits + VM_FABS(vmi_log(g->z).hi)) / (share * VM_FABS(g->kappa));
}

/* Advances the mean motion to t, if it has reached the limit cycle. */
VM_API void vmi_vdp_stay(const vm_vdp_plan *p, vm_real t, vmi_vdp_mean *mean)
{
    const vmi_ripple *r = &p->osc.ripple;
    const vm_real time = t - mean->t, W = vmi_vdp_rate(p, mean->now.m, mean->now.k, mean->ln_A);
    const vmi_vdp_disturbance now = vmi_vdp_disturbance_at(p, &mean->now, mean->ln_A, W);
    mean->psi += time * W * vmi_vdp_mean_rate(&p->ripple, r, &now);
    mean->first_psi += time * vmi_vdp_rate(p, mean->now.m, mean->now.k, mean->first_ln_A);
    mean->psi_third += VM_FABS(time * W * vmi_expansion_second(r)) * now.E0 * now.E0;
    mean->t = t;
}

/* Computes the mean motion at t: in closed form if there is one, else by integration along the laws until t or until
   the limit cycle is reached. Returns the statuses of vmi_vdp_mean_at. */
VM_API int vmi_vdp_mean_motion(const vm_vdp_plan *p, vm_real t, vmi_vdp_mean *mean)
{
    const vm_real extreme = VM_C(1e6); /* for |z| > extreme or |z| < 1/extreme the closed form divides by nearly 0 */
    const int side = vmi_time_side(t);
    vmi_vdp_growth_course g;
    vm_real settled;
    int status = vmi_vdp_start_of(p, side, mean);
    if (status) return status;
    if (!vmi_vdp_is_constant(&p->osc.problem.mass) || !vmi_vdp_is_constant(&p->osc.problem.stiffness))
        return vmi_vdp_walk(p, t, mean);
    g = vmi_vdp_course_from(p, mean);
    if (p->vdp.alpha == 1 && VM_FABS(g.z) < extreme && VM_FABS(g.z) * extreme > 1) {
        status = vmi_vdp_closed(p, &g, t, mean);
        if (status) return status;
        return vmi_vdp_mean_update(p, side, mean);
    }
    settled = mean->t + (vm_real)side * vmi_vdp_settling_time(p, &g, side);
    if (!(VM_FABS(settled) < VM_FABS(t))) return vmi_vdp_walk(p, t, mean);
    status = vmi_vdp_walk(p, settled, mean);
    if (status) return status;
    vmi_vdp_stay(p, t, mean);
    return vmi_vdp_mean_update(p, side, mean);
}

#endif
