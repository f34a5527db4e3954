/* oscillators/averaging.h - averaged equations with a force, and their errors */
#ifndef VARMASS_OSCILLATORS_AVERAGING_H
#define VARMASS_OSCILLATORS_AVERAGING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "mean_laws.h"
#include "problem.h"
#include "walk.h"
#include "waves.h"

/* -- Averaged equations with a force -- */
/* Means over a period of F s and F c at amplitude A and V = speed vmax: on each quarter 20 points of Gauss' rule as
   far as the velocity changes its sign like tanh psi, and 20 in the root of the distance from x = 0, where powers
   of it that are not whole may occur */
VM_API void vmi_osc_means(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real A, vm_real V, vm_real *Fs,
                          vm_real *Fc)
{
    const vm_real half = p->pi / 2, cut = half < 6 ? half / 2 : 3;
    int i, quarter;
    *Fs = *Fc = 0;
    for (i = 0; i < 40; i++) {
        const int k = i % 20, outer = i >= 20;
        const vm_real u = (1 + vmi_gauss_node(k)) / 2, length = outer ? half - cut : cut;
        const vm_real share = vmi_gauss_weight(k) / 8 * length / half * (outer ? 2 * u : 1);
        vm_real c, s;
        vmi_osc_wave_at(w, outer ? half - length * u * u : cut * u, &c, &s);
        for (quarter = 0; quarter < 4; quarter++) {
            const vm_real qc = quarter & 1 ? -c : c, qs = quarter & 2 ? -s : s;
            const vm_real F = p->problem.force(t, A * qc, -V * qs, p->problem.ctx);
            *Fs += share * F * qs;
            *Fc += share * F * qc;
        }
    }
}

/* (ln A)', and theta' in the wave's own angle, at amplitude A where Om is the rate of the Ateb phase */
VM_API void vmi_osc_averaged_rates(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_rates *now, vm_real t,
                                   vm_real A, vm_real Om, vm_real *ln_A_rate, vm_real *theta_rate)
{
    const vm_real V = w->speed * (2 * A * Om / (w->alpha + 1));
    vm_real Fs = 0, Fc = 0;
    if (p->problem.force) vmi_osc_means(p, w, t, A, V, &Fs, &Fc);
    *ln_A_rate = -now->q / (w->alpha + 3) - w->gain_A * Fs / (now->m * V);
    *theta_rate = -w->gain_theta * Fc / (now->m * V);
}

/* Om/Om0 at A/A0 = e^a and these m and k */
VM_API vm_real vmi_osc_Om_ratio(const vm_osc_plan *p, const vmi_osc_rates *now, vm_real a)
{
    return VM_SQRT((now->k / p->k0) / (now->m / p->m0)) * vmi_exp((p->problem.alpha - 1) / 2 * a, 0);
}

/* Averaged equations at (t, A) with the force F of the problem: A', theta', psi' in the method's own angle (Ateb
   phase, radians, Jacobi argument), for VM_ROUTE_ATEB: (314), (315) averaged, with the term of omega' that they
   lack; VM_ROUTE_TRIG: (337)-(339) with alpha + 3 for 5 - alpha and 4 for the 2 of (338), (339); VM_ROUTE_JACOBI:
   (380)-(382) with theta' in the second of (382). Means by Gauss' rule on each quarter of the period, so that F may
   jump where x or x' = 0: to 1e-10 for cubic F and alpha <= 30 (float: roundings). 160 calls of F. */
VM_API int vm_osc_averaged(const vm_osc_plan *p, int method, vm_real t, vm_real A, vm_real *A_rate,
                           vm_real *theta_rate, vm_real *psi_rate)
{
    vmi_osc_rates now;
    vmi_osc_wave w;
    vm_real Om, rate, theta;
    int status;
    if (!p || !A_rate || !theta_rate || !psi_rate || method < 0 || method > VM_ROUTE_ATEB) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(A)) return VM_NOT_FINITE;
    if (!(A > 0)) return VM_BAD_ARGUMENT;
    status = vmi_osc_rates_at(p, t, 1, 0, &now);
    if (status) return status;
    w = vmi_osc_wave_of(method, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    Om = vmi_osc_rate(A, VM_SQRT(now.k / now.m), w.alpha);
    vmi_osc_averaged_rates(p, &w, &now, t, A, Om, &rate, &theta);
    if (!VM_IS_FINITE(A * rate) || !VM_IS_FINITE(w.turn * Om + theta)) return VM_NOT_FINITE;
    *A_rate = A * rate;
    *theta_rate = theta;
    *psi_rate = w.turn * Om + theta;
    return VM_OK;
}

/* -- How good averaged equations with a force are -- */
/* What averaging leaves out at time t and amplitude A, all by ln A or by radians of the Ateb phase */
typedef struct VM_TAG(vmi_osc_averaging) {
    vm_real Om;
    vm_real start_A, start_psi; /* the ripple at the phase that is given */
    vm_real ripple;             /* the largest ripple of ln A plus the largest of psi */
    vm_real rate_A, rate_psi;   /* errors of the mean rates, per second */
    vm_real growth;             /* of a small change of ln A, per second */
} vmi_osc_averaging;

enum { VMI_AVERAGING_POINTS = 64 };

/* The rates of ln A and psi over the period before t on the way from 0 to t_end (over the first period, if t is not
   yet so far): with the force as it is at t if `frozen`, otherwise with the force as time goes on */
VM_API void vmi_osc_period_rates(const vm_osc_plan *p, const vmi_osc_rates *now, vm_real A, vm_real Om, vm_real psi,
                                 vm_real t, vm_real t_end, int frozen, vm_real *rate_A, vm_real *rate_psi)
{
    const vm_real n = p->problem.alpha + 1, V = 2 * A * Om / n, side = t_end < 0 ? (vm_real)-1 : (vm_real)1;
    const vmi_osc_wave w = vmi_osc_wave_of(VM_ROUTE_ATEB, n - 1, p->pi, p->has_ateb ? &p->ateb : NULL);
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) {
        const vm_real way = 2 * p->pi * (vm_real)i / (vm_real)VMI_AVERAGING_POINTS;
        vm_real ca, sa, F, time = t + side * (way - 2 * p->pi) / Om;
        if ((time < 0) != (t_end < 0)) time = side * way / Om; /* before the start: the first period instead */
        if (VM_FABS(time) > VM_FABS(t_end)) time = t_end;
        if (frozen) time = t;
        vmi_osc_wave_at(&w, psi + way, &ca, &sa);
        F = p->problem.force(time, A * ca, -V * sa, p->problem.ctx) / (now->m * V);
        rate_A[i] = -now->q / n * sa * sa - 2 / n * F * sa;
        rate_psi[i] = -now->q / 2 * sa * ca - F * ca;
    }
}

/* Takes the mean off values over a period, and returns it */
VM_API vm_real vmi_osc_take_mean(vm_real *values)
{
    vm_real mean = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) mean += values[i] / (vm_real)VMI_AVERAGING_POINTS;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) values[i] -= mean;
    return mean;
}

/* The integral over the phase, in steps of width, of values without mean, without mean */
VM_API void vmi_osc_integrate_ripple(const vm_real *values, vm_real width, vm_real *ripple)
{
    int i;
    ripple[0] = 0;
    for (i = 1; i < VMI_AVERAGING_POINTS; i++)
        ripple[i] = ripple[i - 1] + width * (values[i - 1] + values[i]) / 2;
    vmi_osc_take_mean(ripple);
}

VM_API vm_real vmi_osc_largest(const vm_real *values)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++)
        if (VM_FABS(values[i]) > largest) largest = VM_FABS(values[i]);
    return largest;
}

VM_API int vmi_osc_averaging_at(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real t_end, vm_real A,
                                vm_real psi, vmi_osc_averaging *a)
{
    const vm_real second_order = VM_C(0.25); /* of rate times ripple: 1.6 times what Duffing's equation has */
    const vm_real change = VM_C(0.02);       /* of ln A, for the growth of a small change */
    const vm_real width = 2 * p->pi / (vm_real)VMI_AVERAGING_POINTS, bend = (w->alpha - 1) / 2;
    const vmi_osc_wave exact = vmi_osc_wave_of(VM_ROUTE_ATEB, w->alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    vm_real rate_A[VMI_AVERAGING_POINTS], rate_psi[VMI_AVERAGING_POINTS];
    vm_real ripple_A[VMI_AVERAGING_POINTS], ripple_psi[VMI_AVERAGING_POINTS];
    vm_real mean_A, mean_psi, own_A, own_psi, exact_A, exact_psi, more_A, more_psi, rates, second;
    vmi_osc_rates now;
    int i, status = vmi_osc_rates_at(p, t, t_end < 0 ? 1 : -1, 0, &now);
    if (status) return status;
    a->Om = vmi_osc_rate(A, VM_SQRT(now.k / now.m), w->alpha);
    vmi_osc_period_rates(p, &now, A, a->Om, psi, t, t_end, 1, rate_A, rate_psi);
    own_A = vmi_osc_take_mean(rate_A);
    own_psi = vmi_osc_take_mean(rate_psi);
    vmi_osc_period_rates(p, &now, A, a->Om, psi, t, t_end, 0, rate_A, rate_psi);
    rates = vmi_osc_largest(rate_A) + vmi_osc_largest(rate_psi);
    mean_A = vmi_osc_take_mean(rate_A);
    mean_psi = vmi_osc_take_mean(rate_psi);
    a->rate_A = VM_FABS(mean_A - own_A);
    a->rate_psi = VM_FABS(mean_psi - own_psi);
    vmi_osc_averaged_rates(p, w, &now, t, A, a->Om, &own_A, &own_psi);
    vmi_osc_averaged_rates(p, &exact, &now, t, A, a->Om, &exact_A, &exact_psi);
    a->rate_A += VM_FABS(own_A - exact_A);
    a->rate_psi += VM_FABS(own_psi / w->turn - exact_psi);
    vmi_osc_averaged_rates(p, w, &now, t, A * (1 + change), a->Om * (1 + bend * change), &more_A, &more_psi);
    a->growth = (more_A - own_A) / change;
    vmi_osc_integrate_ripple(rate_A, width / a->Om, ripple_A);
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) rate_psi[i] += bend * a->Om * ripple_A[i];
    vmi_osc_take_mean(rate_psi);
    vmi_osc_integrate_ripple(rate_psi, width / a->Om, ripple_psi);
    a->start_A = VM_FABS(ripple_A[0]);
    a->start_psi = VM_FABS(ripple_psi[0]);
    a->ripple = vmi_osc_largest(ripple_A) + vmi_osc_largest(ripple_psi);
    second = second_order * rates * a->ripple;
    a->rate_A += second;
    a->rate_psi += second;
    return VM_OK;
}

/* Estimates the error of the averaged equations with a force at t, from the amplitudes at the times of
   vmi_osc_check_time. Errors arise from the ripple at the start, which is taken for a part of the mean, and from the
   errors of the rates. They grow as small changes of the motion do, and an error of the amplitude adds one of the
   phase. The ripple at t, the wave that is not ca and sa, and what is too fast in the laws of mass and stiffness
   are added at the end. */
VM_API int vmi_osc_averaging_error(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t,
                                   const vm_osc_motion *motion, vm_real *error)
{
    const vm_real bend = VM_FABS(w->alpha - 1) / 2;
    vmi_osc_averaging before, after;
    vmi_osc_mean mean;
    vm_real time = 0, in_A, in_psi;
    int i, status = vmi_osc_averaging_at(p, w, 0, t, p->A, p->psi, &before);
    if (!status) status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    in_A = before.start_A;
    in_psi = before.start_psi;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        const vm_real next = vmi_osc_check_time(t, i), step = VM_FABS(next - time);
        vm_real largest_A = in_A, growth;
        status = vmi_osc_averaging_at(p, w, next, t, motion[i].amplitude, 0, &after);
        if (status) return status;
        growth = (before.growth + after.growth) / 2 * (next - time);
        in_A = (in_A + (before.rate_A > after.rate_A ? before.rate_A : after.rate_A) * step) * vmi_exp(growth, 0);
        if (in_A > largest_A) largest_A = in_A;
        in_psi += ((before.rate_psi > after.rate_psi ? before.rate_psi : after.rate_psi) +
                   bend * (before.Om > after.Om ? before.Om : after.Om) * largest_A) *
                  step;
        before = after;
        time = next;
    }
    *error = in_A + in_psi + after.ripple + vmi_osc_wave_error(p, w) + vmi_osc_way_error(p, &mean);
    if (!(*error >= 0)) *error = VM_INFINITY; /* amplitude 0, or out of range: nothing is known */
    return VM_OK;
}

#endif
