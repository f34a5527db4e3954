/* oscillators/mean_motion.h - averaged motion of first and second order without a force, and estimates of its error

   Without a force F the averaged equations of an oscillator with slow laws of mass and stiffness are solved by
   integrals: the amplitude A follows the adiabatic law (325), (344), (367), (389), and the Ateb phase is the integral
   of its rate Om, (310), (329), (370). vmi_osc_first_order is this solution for one of the three waves;
   vmi_osc_second_order adds the ripple within a period and the second order of the mean phase, so that up to t = 1/q
   its error is of the order of (q/Om)^2. oscillators/problem.h explains q, h, gamma and rho.
       vmi_osc_mean mean;
       vm_osc_motion motion;
       vmi_osc_wave w = vmi_osc_wave_of(&plan, VM_ROUTE_SECOND); // plan is a vm_osc_plan
       int status = vmi_osc_mean_at(&plan, 10, &mean);
       if (!status) status = vmi_osc_second_order(&plan, VM_ROUTE_SECOND, &w, &mean, &motion);
   Tests: tests/test_averaging.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_MEAN_MOTION_H
#define VARMASS_OSCILLATORS_MEAN_MOTION_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "problem.h"
#include "walk.h"
#include "waves.h"

/* -- The mean motion at t -- */
typedef struct VM_TAG(vmi_osc_mean) {
    vmi_osc_rates now;          /* the rates just before t (just after t for t < 0) */
    vmi_osc_integrals integral; /* integrals from 0 to t */
    vm_real fourth;             /* integral of epsilon^4 + (depsilon/dpsi)^2 dpsi with epsilon = q/Om */
    vm_real ln_A, ratio;        /* ln(A/A0) and Om/Om0 by the adiabatic law */
    vm_real kick2, kick3;       /* squares of jumps at points of tables, as in vmi_osc_walk */
    vm_real fast;               /* bound of the change of ln J by fast changes of m and k, where J is the action */
    vm_real phase_error;        /* error of the mean phase that comes from the error of integral.phase */
} vmi_osc_mean;

/* A bound of the change of ln J that the adiabatic law leaves out, where J is the action. With n = alpha + 1 and
   epsilon = q/Om, the law ignores (ln J)' = epsilon w(psi), per radian of phase, where w = (1 - (n+2)/n sa^2)/2 has
   the mean 0. The change is at most the integral of |epsilon w|. After i integrations by parts it is at most the
   integral of the absolute value of the ith derivative of epsilon times the ith integral of w; the terms at the ends
   are part of the solution. The smallest of these bounds is taken: it has a high i where m and k change slowly, and i
   = 0 where they change in less than a period. At points of tables the derivatives jump. The solution includes the
   effect (a kick) of jumps of the first derivative, and kick3 measures that of jumps of the second. Where the bound
   with i = 0 or 1 is the smallest, the kicks of the solution are wrong, so these two bounds include them. */
VM_API vm_real vmi_osc_fast(const vm_osc_plan *p, const vmi_osc_walk *w)
{
    const vm_real n = p->problem.alpha + 1, turn = p->pi / (2 * VM_PI);
    const vm_real larger_part = vmi_larger(p->mean_ca2, 1 - p->mean_ca2);
    vm_real size[VMI_WALK_ORDERS], least = VM_INFINITY; /* size[i]: largest value of the ith integral of w */
    int i;
    size[0] = n < 2 ? 1 / n : VM_C(0.5);
    size[1] = VM_C(0.25); /* the first integral of w is sa ca/2 */
    size[2] = n / 8 * larger_part;
    for (i = 3; i < VMI_WALK_ORDERS; i++) size[i] = size[i - 1] * turn;
    for (i = 0; i < VMI_WALK_ORDERS; i++) {
        vm_real bound = size[i] * w->change[i];
        if (i < 2) bound += (n + 2) / 2 * w->kicks;
        if (bound < least) least = bound;
    }
    return least;
}

/* Computes the mean motion by a walk along the laws of m and k; mean->now is set before the call. */
VM_API int vmi_osc_mean_by_walk(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean, vm_real *ln_Om)
{
    const vm_osc_problem *o = &p->problem;
    vmi_osc_walk w;
    int status = vmi_osc_walk_to(&w, p, t);
    if (status) return status;
    vmi_osc_adiabatic(p, vmi_log(mean->now.m / p->m0).hi, vmi_log(mean->now.k / p->k0).hi,
                      o->damping * w.integral.inverse_mass, &mean->ln_A, ln_Om);
    mean->ln_A += w.ln_A;
    *ln_Om += (o->alpha - 1) / 2 * w.ln_A;
    mean->integral = w.integral;
    mean->fourth = w.fourth;
    mean->kick2 = w.kick2;
    mean->kick3 = w.kick3;
    mean->fast = vmi_osc_fast(p, &w);
    mean->phase_error = p->Om * w.error;
    return VM_OK;
}

/* Computes the mean motion where m and k are exponentials in one variable u. Then epsilon = q/Om is a power or an
   exponential, too, so that it changes fastest at 0 or at t, and the estimates below include both. */
VM_API void vmi_osc_mean_closed(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean, vm_real *ln_Om)
{
    const vm_real u = t * vmi_log_ratio(p->base * t), q = p->q;
    const vm_real e = q / p->Om, d = p->h / (p->Om * p->Om);
    vmi_osc_adiabatic(p, p->rate_m * u, p->rate_k * u, p->problem.damping * u / p->m0, &mean->ln_A, ln_Om);
    mean->integral.inverse_mass = u / p->m0;
    mean->integral.phase = u * vmi_exp_ratio(p->base * u + *ln_Om);
    mean->integral.drift = q * q * u * vmi_exp_ratio(-p->base * u - *ln_Om);
    mean->fourth = (e * e * e * e + d * d) * p->Om * VM_FABS(u * vmi_exp_ratio(-3 * (p->base * u + *ln_Om)));
    mean->kick2 = 0;
    mean->kick3 = 0;
    mean->fast = 0;
    mean->phase_error = 0;
}

/* Computes the mean motion at the time t. */
VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    vm_real ln_Om;
    int status = vmi_osc_rates_at(p, t, -vmi_time_side(t), 1, &mean->now);
    if (status) return status;
    if (p->closed) vmi_osc_mean_closed(p, t, mean, &ln_Om);
    else status = vmi_osc_mean_by_walk(p, t, mean, &ln_Om);
    if (status) return status;
    mean->ratio = vmi_exp(ln_Om, 0);
    if (!VM_IS_FINITE(mean->integral.phase) || !VM_IS_FINITE(mean->ln_A) || !VM_IS_FINITE(mean->ratio))
        return VM_NOT_FINITE;
    return VM_OK;
}

/* -- Estimates, of the larger of |error of x|/A and |error of v|/vmax -- */

/* Error of the motion by rounding errors of the phase */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return 4 * VM_EPSILON * (2 + VM_FABS(p->Om * mean->integral.phase)) + mean->phase_error;
}

/* Error of both solutions by what they leave out between 0 and t: fast changes of m and k, and jumps in derivatives
   of tables. Such an error of ln A causes an error of the phase that is gamma Om t times as large. */
VM_API vm_real vmi_osc_way_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real g = VM_FABS(p->gamma * p->Om * mean->integral.phase);
    return (1 + g) * mean->fast + VM_C(0.2) * (VM_SQRT(mean->kick2) + g * VM_SQRT(mean->kick3));
}

/* Error of the first-order solution, to first order in q/Om. The solution leaves out ln rho and the shift at the
   start, the ripple within a period, and the second order of the mean phase. An error of ln rho causes an error of
   the phase that is gamma Om t times as large. */
VM_API vm_real vmi_osc_first_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real n = p->problem.alpha + 1, e = VM_FABS(mean->now.q) / (p->Om * mean->ratio), M = p->mean_ca2;
    const vm_real c2 = M * n / (2 * (n + 2) * (n + 2)), larger_part = vmi_larger(M, 1 - M);
    const vm_real ripple = e * n / (2 * (n + 2)) * larger_part;
    const vm_real phase = VM_FABS(p->gamma * p->ln_rho * p->Om * mean->integral.phase) + VM_FABS(p->shift) + ripple +
                          VM_FABS(c2 * mean->integral.drift / p->Om);
    const vm_real amplitude = (2 * VM_FABS(p->ln_rho) + e / 2) / (n + 2);
    return phase + amplitude + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
}

/* Error of the second-order solution. The solution leaves out ripples of second order at the start and at t, the
   third order of ln rho, which causes an error of the phase, and the fourth order of the mean phase. The factors are
   fitted to the errors in tests/test_routes.c. */
VM_API vm_real vmi_osc_second_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real Om = p->Om * mean->ratio, e = VM_FABS(mean->now.q) / Om, e0 = VM_FABS(p->q) / p->Om;
    const vm_real d = VM_FABS(mean->now.h) / (Om * Om), d0 = VM_FABS(p->h) / (p->Om * p->Om);
    const vm_real third = VM_FABS(p->h_rate) / (p->Om * p->Om) / p->Om;
    const vm_real ripple = (e * e + d) + (e0 * e0 + d0), start = e0 * e0 * e0 + e0 * d0 + d0 * VM_SQRT(d0) + third;
    const vm_real g = VM_FABS(p->gamma * p->Om * mean->integral.phase);
    return (VM_C(0.02) + VM_C(0.015) * p->problem.alpha) * ripple + VM_C(0.15) * g * start +
           VM_C(0.1) * mean->fourth + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
}

/* -- The solutions -- */

/* Writes the motion of amplitude A where Om is the rate of the Ateb phase, so that the largest velocity is 2 A
   Om/(alpha+1); c and s are those of the wave. Sets evals to 0. Returns VM_NOT_FINITE, and leaves *motion untouched,
   where x or v is not finite; returns VM_OK otherwise. */
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

/* The first-order solution (310), (329), (370): A follows the adiabatic law, and the phase is the integral of Om.
   `route` is the route with the wave w. */
VM_API int vmi_osc_first_order(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                               vm_osc_motion *motion)
{
    const vm_real A = p->A * vmi_exp(mean->ln_A, 0), Om = p->Om * mean->ratio;
    const vm_real error = vmi_osc_first_error(p, mean) + vmi_osc_wave_error(w, p->mean_ca2);
    vm_real c, s;
    vmi_osc_wave_at(w, p->psi + p->Om * mean->integral.phase, &c, &s);
    return vmi_osc_motion_of(w, A, Om, c, s, error, route, motion);
}

/* The second-order solution; `route` is VM_ROUTE_SECOND. Om at the exact amplitude is Om at the mean amplitude times
   rho^gamma, where rho = (A/mean A)^((alpha+3)/2). */
VM_API int vmi_osc_second_order(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                                vm_osc_motion *motion)
{
    const vm_real n = p->problem.alpha + 1, Om = p->Om * mean->ratio * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real e = mean->now.q / (2 * Om), phase = vmi_osc_mean_phase(p, &mean->integral);
    vm_real c, s, ln_rho, A;
    vmi_osc_phase_from_mean(p, w, phase, e * n / (n + 2), &c, &s);
    ln_rho = e * s * c;
    ln_rho = ln_rho > -1 ? ln_rho * vmi_log_ratio(ln_rho) : VM_NAN;
    A = p->A * vmi_exp(mean->ln_A + 2 / (n + 2) * (ln_rho - p->ln_rho), 0);
    return vmi_osc_motion_of(w, A, Om * vmi_exp(p->gamma * ln_rho, 0), c, s, vmi_osc_second_error(p, mean),
                             route, motion);
}

#endif
