/* oscillators/integration.h - integration of the oscillator to a tolerance */
#ifndef VARMASS_OSCILLATORS_INTEGRATION_H
#define VARMASS_OSCILLATORS_INTEGRATION_H

#include "../ateb/plans.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../integrators/adaptive.h"
#include "../integrators/ode.h"
#include "../integrators/runs.h"
#include "averaging.h"
#include "constant_mass.h"
#include "laws.h"
#include "mean_laws.h"
#include "problem.h"
#include "walk.h"
#include "waves.h"

/* -- Integration -- */
#define VMI_OSC_LONGEST VM_C(0.2) /* step of the loose run, in periods */

typedef struct VM_TAG(vmi_osc_run) {
    const vm_osc_plan *p;
    vmi_osc_wave wave;
    int route, direct, high, side, status;
    vm_real longest, share; /* step at most, in periods and by the way to the next stop */
    vm_real law_step;       /* step, s, in which no law of a function changes unseen, for VMI_OSC_LONGEST */
    long evals;
    rk45 s;
    vm_real work[RK87_WORK(2)];
} vmi_osc_run;

/* y = ln(A/A0), Ateb phase: averaged */
VM_API int vmi_osc_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_run *c = (vmi_osc_run *)ctx;
    vmi_osc_rates now;
    vm_real Om, theta;
    c->status = vmi_osc_rates_at(c->p, t, c->side, 0, &now);
    if (c->status) return c->status;
    Om = c->p->Om * vmi_osc_Om_ratio(c->p, &now, y[0]);
    vmi_osc_averaged_rates(c->p, &c->wave, &now, t, c->p->A * vmi_exp(y[0], 0), Om, dydt, &theta);
    dydt[1] = Om + theta / c->wave.turn;
    return 0;
}

/* The same, exact: (314), (315) with the term of omega' that they lack, for q that holds it and what is linear in
   x' */
VM_API int vmi_osc_variation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_run *c = (vmi_osc_run *)ctx;
    const vm_osc_problem *o = &c->p->problem;
    const vm_real n = o->alpha + 1;
    vmi_osc_rates now;
    vm_real Om, sa, ca;
    c->status = vmi_osc_rates_at(c->p, t, c->side, 0, &now);
    if (c->status) return c->status;
    Om = c->p->Om * vmi_osc_Om_ratio(c->p, &now, y[0]);
    vmi_osc_wave_at(&c->wave, y[1], &ca, &sa);
    dydt[0] = -now.q / n * sa * sa;
    dydt[1] = Om - now.q / 2 * sa * ca;
    if (o->force) {
        const vm_real A = c->p->A * vmi_exp(y[0], 0), V = 2 * A * Om / n;
        const vm_real F = o->force(t, A * ca, -V * sa, o->ctx) / (now.m * V);
        dydt[0] -= 2 / n * F * sa;
        dydt[1] -= F * ca;
    }
    return 0;
}

/* y = x/A0, (m/m0)^r x'/vmax: what reactive force makes of the velocity is taken out, so that y keeps its size */
VM_API int vmi_osc_direct_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_run *c = (vmi_osc_run *)ctx;
    const vm_osc_plan *p = c->p;
    const vm_osc_problem *o = &p->problem;
    const vm_real speed = 2 * p->Om / (o->alpha + 1);
    vmi_osc_rates now;
    vm_real m, weight;
    c->status = vmi_osc_rates_at(p, t, c->side, 0, &now);
    if (c->status) return c->status;
    m = now.m / p->m0;
    weight = o->reactive == 1 ? m : o->reactive == 0 ? 1 : vmi_pow_checked(m, o->reactive);
    dydt[0] = speed * y[1] / weight;
    dydt[1] = -p->Om * (now.k / p->k0) * weight / m * vmi_osc_elastic(y[0], o->alpha) - o->damping / now.m * y[1];
    if (o->force) dydt[1] += o->force(t, p->A * y[0], p->A * dydt[0], o->ctx) * weight / (now.m * p->A * speed);
    return 0;
}

/* Period now, as long as the amplitude is that of y, or for the direct routes by the adiabatic law without damping */
VM_API vm_real vmi_osc_period_now(const vmi_osc_run *c)
{
    const vm_osc_plan *p = c->p;
    vmi_osc_rates now;
    vm_real ln_A, ln_Om;
    if (vmi_osc_rates_at(p, c->s.t, c->side, 0, &now)) return VM_NAN;
    if (!c->direct) return 2 * p->pi / (p->Om * vmi_osc_Om_ratio(p, &now, c->s.y[0]));
    vmi_osc_adiabatic(p, vmi_log(now.m / p->m0).hi, vmi_log(now.k / p->k0).hi, 0, &ln_A, &ln_Om);
    return 2 * p->pi / (p->Om * vmi_exp(ln_Om, 0));
}

/* On to t, stopping at the points of tables, and every 64 periods to take whole ones off the phase and to see that no
   step is longer than a part of the period (of a bounce, for large alpha): a pair that steps over them does not know
   its error */
VM_API int vmi_osc_solve(vmi_osc_run *c, vm_real t)
{
    const vm_real most_periods = VM_C(8388608.); /* 2^23: in float more hold no phase, in double they take minutes */
    const vm_real most_steps = 8192; /* a period; 2600 were the most, by rk45 to 16 eps, alpha from 0 to 20 */
    const vm_real law_step = c->law_step * c->longest / VMI_OSC_LONGEST;
    vm_real stop, y[2], period, most, longest, steps;
    int status = VM_OK;
    while (status >= 0 && c->s.t != t) {
        period = vmi_osc_period_now(c);
        if (!(period > VM_FABS(t) / most_periods)) return c->status ? c->status : VM_NOT_INTEGRATED;
        stop = vmi_law_next_knot(&c->p->problem.mass, c->s.t, t);
        stop = vmi_law_next_knot(&c->p->problem.stiffness, c->s.t, stop);
        if (VM_FABS(stop - c->s.t) > 64 * period) stop = c->s.t + (vm_real)c->side * 64 * period;
        most = c->share * VM_FABS(stop - c->s.t) + 64 * VM_EPSILON * VM_FABS(t);
        longest = period * (c->p->pi < 10 ? c->longest : c->longest * 10 / c->p->pi);
        if (law_step < longest) longest = law_step;
        c->s.options.h_max = most < longest ? most : longest;
        steps = VM_FABS(stop - c->s.t) * (most_steps / period + 4 / c->s.options.h_max) + most_steps;
        c->s.options.max_steps = steps < VM_C(1e9) ? (long)steps : 1000000000L;
        status = c->high ? rk87_solve(&c->s, stop) : rk45_solve(&c->s, stop);
        if (status < 0) break;
        y[0] = c->s.y[0];
        y[1] = c->s.y[1];
        if (!c->direct) y[1] -= 2 * c->p->pi * VM_FLOOR(y[1] / (2 * c->p->pi));
        status = c->high ? rk87_restart(&c->s, c->s.t, y) : rk45_restart(&c->s, c->s.t, y);
    }
    return c->status ? c->status : status < 0 ? VM_NOT_INTEGRATED : VM_OK;
}

/* x and v where the run has come to */
VM_API int vmi_osc_motion_now(vmi_osc_run *c, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->p;
    const vm_real *y = c->s.y;
    vm_real A, Om, ca, sa, weight;
    vmi_osc_rates now;
    int status = vmi_osc_rates_at(p, c->s.t, -c->side, 0, &now);
    if (status) return status;
    if (!c->direct) {
        A = p->A * vmi_exp(y[0], 0);
        Om = p->Om * vmi_osc_Om_ratio(p, &now, y[0]);
        vmi_osc_wave_at(&c->wave, y[1], &ca, &sa);
        return vmi_osc_motion_of(&c->wave, A, Om, ca, sa, 0, c->route, motion);
    }
    weight = vmi_pow_checked(now.m / p->m0, p->problem.reactive);
    motion->x = p->A * y[0];
    motion->v = 2 * p->A * p->Om / (p->problem.alpha + 1) * y[1] / weight;
    vm_osc_amplitude_phase(motion->x, motion->v, VM_SQRT(now.k / now.m), p->problem.alpha, &motion->amplitude, &Om);
    motion->route = c->route;
    return VM_IS_FINITE(motion->amplitude) ? VM_OK : VM_NOT_FINITE;
}

VM_API int vmi_osc_integrated(vmi_osc_run *c, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->p;
    rk45_options options = rk45_defaults(NULL);
    vm_real y[2], ca, sa;
    ode_rhs f = c->direct                        ? vmi_osc_direct_rhs
                : c->route == VM_ROUTE_VARIATION ? vmi_osc_variation_rhs
                                                 : vmi_osc_averaged_rhs;
    int i, status;
    c->side = t < 0 ? -1 : 1;
    c->status = VM_OK;
    options.rtol = c->direct ? tolerance : -1;
    options.atol = tolerance;
    vmi_osc_wave_at(&c->wave, p->psi, &ca, &sa);
    y[0] = c->direct ? ca : 0;
    y[1] = c->direct ? -sa : p->psi;
    status = c->high ? rk87_init(&c->s, f, c, 2, 0, y, &options, c->work)
                     : rk45_init(&c->s, f, c, 2, 0, y, &options, c->work);
    if (status < 0) return VM_NOT_INTEGRATED;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        status = vmi_osc_solve(c, vmi_osc_check_time(t, i));
        if (!status) status = vmi_osc_motion_now(c, motion + i);
        if (status) return status;
    }
    c->evals += c->s.evals;
    return VM_OK;
}

/* The larger of the differences of x by A and of v by vmax, the largest at the times of vmi_osc_check_time: at one time
   two runs may agree by chance */
VM_API vm_real vmi_osc_difference(const vm_osc_plan *p, vm_real t, const vm_osc_motion *a, const vm_osc_motion *b)
{
    vmi_osc_rates now;
    vm_real d, largest = 0;
    int i;
    for (i = 0; i < VMI_OSC_CHECKS; i++, a++, b++) {
        if (a->amplitude == 0 || vmi_osc_rates_at(p, vmi_osc_check_time(t, i), t < 0 ? 1 : -1, 0, &now))
            return VM_INFINITY;
        d = VM_FABS(a->x - b->x) / a->amplitude;
        if (d > largest) largest = d;
        d = VM_FABS(a->v - b->v) / vm_osc_vmax(a->amplitude, VM_SQRT(now.k / now.m), p->problem.alpha);
        if (d > largest) largest = d;
    }
    return largest;
}

/* The longest step in which no law that is a function changes unseen: a part of the shortest panel in the walk
   along the laws. A jump of a law would make it 0, so it is at least a fixed part of the run. */
VM_API int vmi_osc_law_step(const vm_osc_plan *p, vm_real t, vm_real *step)
{
    const vm_law *laws[2];
    const vm_real panel_steps = 4, run_steps = 8192;
    vmi_osc_walk w;
    int i, status;
    laws[0] = w.mass = &p->problem.mass;
    laws[1] = w.stiffness = &p->problem.stiffness;
    w.plan = p;
    *step = VM_FABS(t);
    if (laws[0]->kind != VM_LAW_FUNCTION && laws[1]->kind != VM_LAW_FUNCTION) return VM_OK;
    status = vmi_osc_walk_to(&w, t);
    if (status) return status;
    *step = VM_FABS(t) / run_steps;
    if (w.shortest / panel_steps > *step) *step = w.shortest / panel_steps;
    for (i = 0; i < 2; i++)
        if (laws[i]->kind == VM_LAW_FUNCTION && laws[i]->change_time > 0 && laws[i]->change_time < *step)
            *step = laws[i]->change_time;
    return VM_OK;
}

/* Two runs, the second so much stricter that the control, which keeps a step while its error is within a factor of 3
   (rk87: 7.5), makes other steps, with half the longest step; and again stricter until what they differ by is within
   the tolerance. The factor of the difference leaves room for errors that do not go as the tolerance. */
VM_API int vmi_osc_integrate(const vm_osc_plan *plan, int route, vm_real t, vm_real tolerance,
                             vm_osc_motion *motion)
{
    const vm_real least = VM_EPSILON * (route == VM_ROUTE_RK87 ? 256 : 16),
                  ratio = route == VM_ROUTE_RK87 ? 60 : 15;
    const vm_real factor = route == VM_ROUTE_RK87 ? VM_C(0.25) : VM_C(0.5);
    /* times the tolerance of the steps: two runs may agree this well by chance, since mostly their errors are far
       below that tolerance */
    const vm_real by_chance = route == VM_ROUTE_RK87 ? VM_C(1e-4) : VM_C(1e-3);
    vm_osc_plan with_ateb;
    vmi_osc_run c;
    vm_osc_motion loose[VMI_OSC_CHECKS], strict[VMI_OSC_CHECKS], *last = strict + VMI_OSC_CHECKS - 1;
    vm_real step_tolerance = tolerance < VM_C(0.008) ? tolerance / 8 : VM_C(1e-3), before = VM_INFINITY;
    vm_real longest = VMI_OSC_LONGEST, averaging = 0;
    int attempt, status = vmi_osc_law_step(plan, t, &c.law_step), stalled = 0;
    if (status) return status;
    c.p = plan;
    c.route = route;
    c.evals = 0;
    c.direct = route >= VM_ROUTE_RK45;
    c.high = route == VM_ROUTE_RK87;
    if (!plan->has_ateb) {
        with_ateb = *plan;
        c.p = &with_ateb;
        with_ateb.has_ateb = ateb_plan_init(&with_ateb.ateb, plan->problem.alpha) == 0;
    }
    c.wave = vmi_osc_wave_of(route <= VM_ROUTE_ATEB ? route : VM_ROUTE_ATEB, plan->problem.alpha, plan->pi,
                             c.p->has_ateb ? &c.p->ateb : NULL);
    for (attempt = 0; attempt < 6; attempt++) {
        if (step_tolerance < least) step_tolerance = least;
        c.longest = longest;
        c.share = 1;
        status = vmi_osc_integrated(&c, t, ratio * step_tolerance, loose);
        c.longest = longest / 2;
        c.share = VM_C(0.51);
        if (!status) status = vmi_osc_integrated(&c, t, step_tolerance, strict);
        if (status == VM_NOT_INTEGRATED && c.status == VM_OK && step_tolerance > least) {
            step_tolerance /= 2 * ratio; /* a loose run may leave the motion for good */
            continue;
        }
        if (status) return status;
        last->error = factor * vmi_osc_difference(plan, t, strict, loose) +
                      4 * VM_EPSILON * (2 + plan->Om * VM_FABS(t));
        if (last->error < by_chance * step_tolerance) last->error = by_chance * step_tolerance;
        if (last->error > before / 2) {
            /* roundings, chance, or longest is what counts */
            stalled++;
            longest /= 2;
        }
        if (last->error <= tolerance || step_tolerance == least || stalled == 3) break;
        before = last->error;
        step_tolerance *= tolerance / last->error > VM_C(1e-4) ? tolerance / last->error / 4 : VM_C(2e-5);
    }
    if (!status && route <= VM_ROUTE_ATEB) status = vmi_osc_averaging_error(c.p, &c.wave, t, strict, &averaging);
    if (status) return status;
    last->evals = c.evals;
    *motion = *last;
    status = last->error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
    if (route <= VM_ROUTE_ATEB) motion->error += averaging;
    return status;
}

#endif
