/* oscillators/averaging.h - averaged equations of an oscillator with a force, and the error of averaging

   With a force F(t, x, x') the amplitude A and the phase obey averaged equations, whose right-hand sides are means
   over a period. vm_osc_averaged computes these right-hand sides for each of the three waves of oscillators/waves.h.
   The equations are (314), (315) of the dissertation for ca, (337)-(339) for cos, and (380)-(382) for cn.
       vm_osc_plan plan;
       vm_real A_rate, theta_rate, psi_rate;
       int status = vm_osc_plan_init(&plan, &problem); // problem is a vm_osc_problem; t = 10 s, A = 0.1 m
       if (!status) status = vm_osc_averaged(&plan, VM_ROUTE_ATEB, 10, VM_C(0.1), &A_rate, &theta_rate, &psi_rate);
   vmi_osc_averaging_error estimates the error of the solution of the averaged equations.
   Symbols: psi is the Ateb phase and Om its rate. The argument of ca, cos or cn is the angle of the wave; theta is the
   part of this angle that changes slowly (oscillators/waves.h).
   Tests: tests/test_averaging.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_AVERAGING_H
#define VARMASS_OSCILLATORS_AVERAGING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "legendre.h"
#include "mean_motion.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "waves.h"

/* -- Averaged equations with a force -- */

/* Writes the means of F s and F c over a period to *Fs and *Fc. The wave w gives the function c for the position and
   the function s for the velocity. F is the force during the motion x = A c, x' = -V s, where A is the amplitude and V
   is w->speed times the largest velocity. Gauss' rule integrates over each quarter of the period in two parts, with 20
   points in each. The first part is from psi = 0 to psi = cut; for large alpha the velocity varies like tanh psi there.
   The second part is from cut to the zero of x. There the rule uses the square root of the distance of psi from this
   zero as its variable, since F may contain fractional powers of this distance. */
VM_API void vmi_osc_means(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real A, vm_real V, vm_real *Fs,
                          vm_real *Fc)
{
    const vm_real half = p->ripple.pi / 2, cut = half < 6 ? half / 2 : 3;
    int i, quarter;
    *Fs = 0;
    *Fc = 0;
    for (i = 0; i < 2 * VMI_GAUSS; i++) {
        const int point = i % VMI_GAUSS, near_zero = i >= VMI_GAUSS;
        const vm_real u = (1 + vmi_gauss_node(point)) / 2, length = near_zero ? half - cut : cut;
        vm_real psi = cut * u, share = vmi_gauss_weight(point) / 8 * length / half, c, s;
        if (near_zero) {
            psi = half - length * u * u;
            share *= 2 * u;
        }
        vmi_osc_wave_at(w, psi, &c, &s);
        for (quarter = 0; quarter < 4; quarter++) {
            const vm_real qc = quarter & 1 ? -c : c, qs = quarter & 2 ? -s : s;
            const vm_real F = p->problem.force(t, A * qc, -V * qs, p->problem.ctx);
            *Fs += share * F * qs;
            *Fc += share * F * qc;
        }
    }
}

/* The averaged rates (ln A)' and theta' at the amplitude A, where Om is the rate of the Ateb phase. theta is the part
   of the wave's angle that changes slowly. */
VM_API void vmi_osc_averaged_rates(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_rates *now, vm_real t,
                                   vm_real A, vm_real Om, vm_real *ln_A_rate, vm_real *theta_rate)
{
    const vm_real V = w->speed * (2 * A * Om / (w->alpha + 1));
    vm_real Fs = 0, Fc = 0;
    if (p->problem.force) vmi_osc_means(p, w, t, A, V, &Fs, &Fc);
    *ln_A_rate = -now->p - w->gain_A * Fs / (now->m * V);
    *theta_rate = -w->gain_theta * Fc / (now->m * V);
}

/* The rate of the Ateb phase divided by its value at t = 0. The argument a is ln(A/A0), where A is the present
   amplitude and A0 the amplitude at t = 0. `now` contains the present mass and stiffness. */
VM_API vm_real vmi_osc_Om_ratio(const vm_osc_plan *p, const vmi_osc_rates *now, vm_real a)
{
    return VM_SQRT((now->k / p->k0) / (now->m / p->m0)) * vmi_exp((p->problem.alpha - 1) / 2 * a, 0);
}

/* Averaged rates A', theta', psi' of amplitude and phase, with the problem's force. A' is in m/s, theta' and psi' are
   in 1/s, the time t is in s, and the amplitude A in m. psi is the angle of the route's wave, and theta the part of
   this angle that changes slowly. For VM_ROUTE_ATEB psi is the Ateb phase. The equations are the averages of (314),
   (315) of the dissertation, which leaves out a term with the rate omega' of omega = sqrt(k/m); this function adds the
   term. For VM_ROUTE_TRIG psi is in radians. The equations are (337)-(339) with two corrections: alpha + 3 replaces 5 -
   alpha, and in (338) and (339) 4 replaces 2. For VM_ROUTE_JACOBI psi is the argument of cn. The equations are
   (380)-(382) with one correction: theta' replaces A' in the second equation of (382). Gauss' rule computes the mean
   over each quarter of the period separately; therefore F may jump where x or x' is 0. For alpha up to 30, and F linear
   or cubic in x and x' or dry friction, the relative error of the rates is at most 1e-10 (float 2e-6). Returns
   VM_BAD_ARGUMENT for a null pointer or a route other than these three; VM_NOT_FINITE for a number that is infinite or
   NaN; VM_BAD_MASS for a mass at t that is not positive; VM_BAD_STIFFNESS for a stiffness at t that is not positive;
   VM_DOMAIN for A <= 0, for t outside a table, or where a user's function of mass or stiffness fails. An error leaves
   the results untouched. */
VM_API int vm_osc_averaged(const vm_osc_plan *p, int route, vm_real t, vm_real A, vm_real *A_rate,
                           vm_real *theta_rate, vm_real *psi_rate)
{
    vmi_osc_rates now;
    vmi_osc_wave w;
    vm_real Om, rate, theta;
    int status;
    if (!p || !A_rate || !theta_rate || !psi_rate) return VM_BAD_ARGUMENT;
    if (route < VM_ROUTE_TRIG || route > VM_ROUTE_ATEB) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(A)) return VM_NOT_FINITE;
    status = vmi_osc_rates_at(&p->problem, t, 1, &now);
    if (status) return status;
    if (!(A > 0)) return VM_DOMAIN;
    w = vmi_osc_wave_of(p, route);
    Om = vmi_osc_rate(A, VM_SQRT(now.k / now.m), w.alpha);
    vmi_osc_averaged_rates(p, &w, &now, t, A, Om, &rate, &theta);
    if (!VM_IS_FINITE(A * rate) || !VM_IS_FINITE(w.turn * Om + theta)) return VM_NOT_FINITE;
    *A_rate = A * rate;
    *theta_rate = theta;
    *psi_rate = w.turn * Om + theta;
    return VM_OK;
}

/* -- The errors of averaging at one moment -- */

/* Number of phases in a period at which the exact rates of ln A and psi are compared with their means */
enum { VMI_AVERAGING_POINTS = 64 };

/* A moment of a motion from time 0 to t_end: the time t and the motion at t */
typedef struct VM_TAG(vmi_osc_moment) {
    const vm_osc_plan *plan;
    vmi_osc_rates now;  /* mass, stiffness and their rates just before t */
    vm_real t, t_end;   /* the time t of this moment, and the end t_end of the motion, s */
    vm_real A, psi, Om; /* amplitude, m, Ateb phase, and rate of this phase, 1/s */
} vmi_osc_moment;

/* The errors of ln A and of the Ateb phase psi that averaging causes at one moment. The ripple of a number is its small
   swing about its mean value within a period. */
typedef struct VM_TAG(vmi_osc_averaging) {
    vm_real Om;                 /* rate of the Ateb phase at this moment, 1/s */
    vm_real start_A, start_psi; /* sizes of the ripples of ln A and psi at the phase of this moment */
    vm_real ripple;             /* the largest ripple of ln A plus the largest ripple of psi */
    vm_real rate_A, rate_psi;   /* errors of the mean rates of ln A and psi, 1/s */
    vm_real growth;             /* rate, 1/s, at which a small change of ln A grows */
} vmi_osc_averaging;

/* Writes the exact rates of ln A and psi at VMI_AVERAGING_POINTS phases of a period. This period ends at t; if less
   than a period has passed since time 0, the period begins at time 0. If `frozen` is 1, the force is computed at the
   time t for all phases; otherwise it is computed at the time that belongs to each phase. */
VM_API void vmi_osc_period_rates(const vmi_osc_moment *at, int frozen, vm_real *rate_A, vm_real *rate_psi)
{
    const vm_osc_plan *p = at->plan;
    const vm_real n = p->problem.alpha + 1, V = 2 * at->A * at->Om / n, q = (n + 2) * at->now.p;
    const vm_real side = (vm_real)vmi_time_side(at->t_end);
    const vmi_osc_wave w = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vm_real start = at->t - side * (2 * p->ripple.pi / at->Om); /* start of the period */
    int i;
    if ((start < 0) != (at->t_end < 0)) start = 0; /* there is no force before time 0 */
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) {
        const vm_real way = 2 * p->ripple.pi * (vm_real)i / (vm_real)VMI_AVERAGING_POINTS;
        vm_real ca, sa, F, time = start + side * way / at->Om;
        if (VM_FABS(time) > VM_FABS(at->t_end)) time = at->t_end;
        if (frozen) time = at->t;
        vmi_osc_wave_at(&w, at->psi + side * way, &ca, &sa);
        F = p->problem.force(time, at->A * ca, -V * sa, p->problem.ctx) / (at->now.m * V);
        rate_A[i] = -q / n * sa * sa - 2 / n * F * sa;
        rate_psi[i] = -q / 2 * sa * ca - F * ca;
    }
}

/* Subtracts the mean of VMI_AVERAGING_POINTS values over a period from each of them, and returns the mean. */
VM_API vm_real vmi_osc_take_mean(vm_real *values)
{
    vm_real mean = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) mean += values[i] / (vm_real)VMI_AVERAGING_POINTS;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) values[i] -= mean;
    return mean;
}

/* Integrates VMI_AVERAGING_POINTS values over a period, and subtracts the mean of the integral from the integral. The
   mean of the values must be 0. `width` is the time between two values, s. */
VM_API void vmi_osc_integrate_ripple(const vm_real *values, vm_real width, vm_real *ripple)
{
    int i;
    ripple[0] = 0;
    for (i = 1; i < VMI_AVERAGING_POINTS; i++)
        ripple[i] = ripple[i - 1] + width * (values[i - 1] + values[i]) / 2;
    vmi_osc_take_mean(ripple);
}

/* The largest absolute value of VMI_AVERAGING_POINTS values over a period */
VM_API vm_real vmi_osc_largest(const vm_real *values)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) largest = vmi_larger(VM_FABS(values[i]), largest);
    return largest;
}

/* Compares the mean rates with the wave w and the mean rates with the exact wave ca, and adds the differences to the
   errors a->rate_A and a->rate_psi. Also finds a->growth, the rate at which a small change of ln A grows. */
VM_API void vmi_osc_add_wave_rates(const vmi_osc_moment *at, const vmi_osc_wave *w, vmi_osc_averaging *a)
{
    const vm_osc_plan *p = at->plan;
    const vm_real change = VM_C(0.02); /* by this change of ln A the function finds how the mean rate depends on ln A */
    const vm_real A = at->A * (1 + change), Om = at->Om * (1 + (w->alpha - 1) / 2 * change);
    const vmi_osc_wave exact = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vm_real own_A, own_psi, exact_A, exact_psi, more_A, more_psi;
    vmi_osc_averaged_rates(p, w, &at->now, at->t, at->A, at->Om, &own_A, &own_psi);
    vmi_osc_averaged_rates(p, &exact, &at->now, at->t, at->A, at->Om, &exact_A, &exact_psi);
    vmi_osc_averaged_rates(p, w, &at->now, at->t, A, Om, &more_A, &more_psi);
    a->rate_A += VM_FABS(own_A - exact_A);
    a->rate_psi += VM_FABS(own_psi / w->turn - exact_psi);
    a->growth = (more_A - own_A) / change;
}

/* Finds the ripples of ln A and psi: the integrals over time of the rates rate_A and rate_psi of ln A and psi within a
   period, after the mean of each rate has been subtracted. The ripple of ln A changes Om, and so adds to the rate of
   psi. */
VM_API void vmi_osc_find_ripples(const vmi_osc_moment *at, const vm_real *rate_A, vm_real *rate_psi,
                                 vmi_osc_averaging *a)
{
    const vm_real width = 2 * at->plan->ripple.pi / (vm_real)VMI_AVERAGING_POINTS;
    const vm_real bend = (at->plan->problem.alpha - 1) / 2;
    vm_real ripple_A[VMI_AVERAGING_POINTS], ripple_psi[VMI_AVERAGING_POINTS];
    int i;
    vmi_osc_integrate_ripple(rate_A, width / at->Om, ripple_A);
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) rate_psi[i] += bend * at->Om * ripple_A[i];
    vmi_osc_take_mean(rate_psi);
    vmi_osc_integrate_ripple(rate_psi, width / at->Om, ripple_psi);
    a->start_A = VM_FABS(ripple_A[0]);
    a->start_psi = VM_FABS(ripple_psi[0]);
    a->ripple = vmi_osc_largest(ripple_A) + vmi_osc_largest(ripple_psi);
}

/* Finds the errors that averaging causes at the time t between 0 and t_end, where the motion has the amplitude A and
   the Ateb phase psi. */
VM_API int vmi_osc_averaging_at(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real t_end, vm_real A,
                                vm_real psi, vmi_osc_averaging *a)
{
    const vm_real second_order = VM_C(0.25); /* the assumed error of a mean rate, divided by (rate times ripple). The
                                                true quotient is 0.156 for Duffing's equation */
    vm_real rate_A[VMI_AVERAGING_POINTS], rate_psi[VMI_AVERAGING_POINTS], frozen_A, frozen_psi, rates, second;
    vmi_osc_moment at;
    int status = vmi_osc_rates_at(&p->problem, t, -vmi_time_side(t_end), &at.now);
    if (status) return status;
    at.plan = p;
    at.t = t;
    at.t_end = t_end;
    at.A = A;
    at.psi = psi;
    at.Om = vmi_osc_rate(A, VM_SQRT(at.now.k / at.now.m), w->alpha);
    a->Om = at.Om;
    vmi_osc_period_rates(&at, 1, rate_A, rate_psi);
    frozen_A = vmi_osc_take_mean(rate_A);
    frozen_psi = vmi_osc_take_mean(rate_psi);
    vmi_osc_period_rates(&at, 0, rate_A, rate_psi);
    rates = vmi_osc_largest(rate_A) + vmi_osc_largest(rate_psi);
    a->rate_A = VM_FABS(vmi_osc_take_mean(rate_A) - frozen_A);
    a->rate_psi = VM_FABS(vmi_osc_take_mean(rate_psi) - frozen_psi);
    vmi_osc_add_wave_rates(&at, w, a);
    vmi_osc_find_ripples(&at, rate_A, rate_psi, a);
    second = second_order * rates * a->ripple;
    a->rate_A += second;
    a->rate_psi += second;
    return VM_OK;
}

/* -- The error between 0 and t -- */

/* The number of times at which errors are estimated. The interval from 0 to t is divided into 11 equal parts; the times
   are the ends of the last 8 parts. oscillators/integration.h compares two integrations at these times. */
enum { VMI_OSC_CHECKS = 8 };

/* Returns time number i, 0 to VMI_OSC_CHECKS - 1, of the times at which motions are compared. The last time is t. */
VM_API vm_real vmi_osc_check_time(vm_real t, int i)
{
    if (i == VMI_OSC_CHECKS - 1) return t;
    return t * (vm_real)(4 + i) / (vm_real)(3 + VMI_OSC_CHECKS);
}

/* Estimates the error at t of the averaged equations with a force, from the motions at the times of vmi_osc_check_time.
   There are two causes of errors: the averaged equations treat the ripple at the start as a part of the mean motion,
   and the mean rates have errors. The errors grow as fast as small changes of the motion grow, and an error of the
   amplitude causes an error of the phase. At the end the function adds the ripple at t, the error of the wave if it is
   not ca, and the effect of fast changes of mass and stiffness. */
VM_API int vmi_osc_averaging_error(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t,
                                   const vm_osc_motion *motion, vm_real *error)
{
    const vm_real bend = VM_FABS(w->alpha - 1) / 2;
    vmi_osc_averaging before, after;
    vmi_osc_mean mean;
    vm_real time = 0, error_A, error_psi;
    int i, status = vmi_osc_averaging_at(p, w, 0, t, p->A, p->psi, &before);
    if (!status) status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    error_A = before.start_A;
    error_psi = before.start_psi;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        const vm_real next = vmi_osc_check_time(t, i), step = VM_FABS(next - time), first_A = error_A;
        vm_real growth, rate_psi;
        status = vmi_osc_averaging_at(p, w, next, t, motion[i].amplitude, 0, &after);
        if (status) return status;
        growth = (before.growth + after.growth) / 2 * (next - time);
        error_A = (error_A + vmi_larger(before.rate_A, after.rate_A) * step) * vmi_exp(growth, 0);
        rate_psi = vmi_larger(before.rate_psi, after.rate_psi) +
                   bend * vmi_larger(before.Om, after.Om) * vmi_larger(error_A, first_A);
        error_psi += rate_psi * step;
        before = after;
        time = next;
    }
    *error = error_A + error_psi + after.ripple + vmi_osc_wave_error(w, p->ripple.mean2) + vmi_osc_way_error(p, &mean);
    if (!(*error >= 0)) *error = VM_INFINITY; /* the amplitude is 0, or a number has overflowed */
    return VM_OK;
}

#endif
