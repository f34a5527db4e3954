/* oscillators/mean_laws.h - the mean motion by laws of first and second order, and their errors */
#ifndef VARMASS_OSCILLATORS_MEAN_LAWS_H
#define VARMASS_OSCILLATORS_MEAN_LAWS_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../jacobi/means.h"
#include "problem.h"
#include "walk.h"
#include "waves.h"

/* -- Estimates, of the larger of |error of x|/A and |error of v|/vmax -- */
/* What roundings of the phase come to */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return 4 * VM_EPSILON * (2 + VM_FABS(p->Om * mean->y[1])) + mean->phase_error;
}

/* What the laws miss on the way: changes that are not slow, which in the phase grow by the factor gamma Om t, and
   the roughness of tables */
VM_API vm_real vmi_osc_way_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real g = VM_FABS(p->gamma * p->Om * mean->y[1]);
    return (1 + g) * mean->fast + VM_C(0.2) * (VM_SQRT(mean->kick2) + g * VM_SQRT(mean->kick3));
}

/* First order leaves out ln rho and the shift of the start, the ripple of a period, and the second order of the mean
   phase: the error is these, to first order in q/Om. Of ln rho the phase makes gamma Om t. */
VM_API vm_real vmi_osc_first_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real n = p->problem.alpha + 1, e = VM_FABS(mean->now.q) / (p->Om * mean->ratio), M = p->mean_ca2;
    const vm_real c2 = M * n / (2 * (n + 2) * (n + 2)),
                  ripple = e * n / (2 * (n + 2)) * (M > VM_C(0.5) ? M : 1 - M);
    const vm_real phase = VM_FABS(p->gamma * p->ln_rho * p->Om * mean->y[1]) + VM_FABS(p->shift) + ripple +
                          VM_FABS(c2 * mean->y[2] / p->Om);
    const vm_real amplitude = (2 * VM_FABS(p->ln_rho) + e / 2) / (n + 2);
    return phase + amplitude + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
}

/* The second-order law leaves out ripples of second order at the start and at t, the third order of ln rho, which the
   phase multiplies, and the fourth order of the mean phase. */
VM_API vm_real vmi_osc_second_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real Om = p->Om * mean->ratio, e = VM_FABS(mean->now.q) / Om, e0 = VM_FABS(p->q) / p->Om;
    const vm_real d = VM_FABS(mean->now.h) / (Om * Om), d0 = VM_FABS(p->h) / (p->Om * p->Om);
    const vm_real third = VM_FABS(p->h_rate) / (p->Om * p->Om) / p->Om;
    const vm_real ripple = (e * e + d) + (e0 * e0 + d0), start = e0 * e0 * e0 + e0 * d0 + d0 * VM_SQRT(d0) + third;
    const vm_real g = VM_FABS(p->gamma * p->Om * mean->y[1]);
    return (VM_C(0.02) + VM_C(0.015) * p->problem.alpha) * ripple + VM_C(0.15) * g * start +
           VM_C(0.1) * mean->fourth + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
}

/* How far a wave is from ca and sa: cos at x = 0, where its velocity is wrong; cn in the mean of its square, which is
   right where cn is exact, times a factor that fits its largest error within 5 % for alpha <= 10 */
VM_API vm_real vmi_osc_wave_error(const vm_osc_plan *p, const vmi_osc_wave *w)
{
    const vm_real alpha = p->problem.alpha;
    vm_real C2, C4, C6, error;
    if (w->method == VM_ROUTE_ATEB) return 0;
    if (w->method == VM_ROUTE_TRIG) error = VM_FABS(w->speed - 1) * (1 + alpha / 100);
    else {
        jacobi_cn_means(w->m, &C2, &C4, &C6);
        error = VM_FABS(C2 - p->mean_ca2) * (VM_C(2.7) + alpha / 2);
    }
    return error < 1 ? error : 1;
}

/* -- The laws -- */
/* x and v of amplitude A where Om is the rate of the Ateb phase, so that vmax = 2 A Om/(alpha+1) */
VM_API int vmi_osc_motion_of(const vmi_osc_wave *w, vm_real A, vm_real Om, vm_real c, vm_real s, vm_real error,
                             int route, vm_osc_motion *motion)
{
    vm_osc_motion r;
    r.x = A * c;
    r.v = -w->speed * (2 * A * Om / (w->alpha + 1)) * s;
    r.amplitude = A;
    r.error = error;
    r.route = route;
    r.evals = 0;
    if (!VM_IS_FINITE(r.x) || !VM_IS_FINITE(r.v)) return VM_NOT_FINITE;
    *motion = r;
    return VM_OK;
}

/* (310), (329), (370): A by the adiabatic law, the phase the integral of Om */
VM_API int vmi_osc_first_order(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                               vm_osc_motion *motion)
{
    vm_real c, s;
    vmi_osc_wave_at(w, p->psi + p->Om * mean->y[1], &c, &s);
    return vmi_osc_motion_of(w, p->A * vmi_exp(mean->ln_A, 0), p->Om * mean->ratio, c, s,
                             vmi_osc_first_error(p, mean) + vmi_osc_wave_error(p, w), w->method, motion);
}

/* Om at the exact amplitude is that at the mean one times rho^gamma, rho = A^((alpha+3)/2) by the mean's */
VM_API int vmi_osc_second_order(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                                vm_osc_motion *motion)
{
    const vm_real n = p->problem.alpha + 1, Om = p->Om * mean->ratio * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real e = mean->now.q / (2 * Om);
    vm_real c, s, ln_rho;
    vmi_osc_phase_from_mean(p, w, vmi_osc_mean_phase(p, mean->y), e * n / (n + 2), &c, &s);
    ln_rho = e * s * c;
    ln_rho = ln_rho > -1 ? ln_rho * vmi_log_ratio(ln_rho) : VM_NAN;
    return vmi_osc_motion_of(w, p->A * vmi_exp(mean->ln_A + 2 / (n + 2) * (ln_rho - p->ln_rho), 0),
                             Om * vmi_exp(p->gamma * ln_rho, 0), c, s, vmi_osc_second_error(p, mean),
                             VM_ROUTE_SECOND, motion);
}

#endif
