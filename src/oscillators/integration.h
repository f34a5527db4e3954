/* oscillators/integration.h - integration of an oscillator to a tolerance, with an estimate of its error

   The oscillator is described by either of two systems of two equations: the averaged equations of amplitude and phase,
   or the equation of motion. A vmi_osc_method contains one of these systems, a Runge-Kutta pair (rk45 or rk87), and
   numbers that are chosen for this pair. oscillators/routes.h chooses the methods. vmi_osc_integrate makes two runs of
   a method, a loose run and a strict run with a stricter tolerance, and estimates the error from their difference. It
   repeats both runs with stricter tolerances until the estimated error is at most the tolerance of the motion.
       vmi_osc_method method = vmi_osc_method_rk87(vmi_osc_direct_rhs);
       vm_osc_motion motion;
       method.direct = 1; // vmi_osc_direct_rhs is the equation of motion
       int status = vmi_osc_integrate(&plan, VM_ROUTE_RK87, &method, 10, VM_C(1e-9), &motion); // plan is a vm_osc_plan
   Tests: tests/test_routes.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_INTEGRATION_H
#define VARMASS_OSCILLATORS_INTEGRATION_H

#include "../ateb/plans.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../integrators/ode.h"
#include "../integrators/rk45.h"
#include "../integrators/rk87.h"
#include "../integrators/runs.h"
#include "averaging.h"
#include "constant_mass.h"
#include "laws.h"
#include "mean_motion.h"
#include "problem.h"
#include "walk.h"
#include "waves.h"

/* -- Methods and runs -- */

/* Numbers that suit a Runge-Kutta pair */
typedef struct VM_TAG(vmi_osc_tuning) {
    vm_real least;     /* smallest useful tolerance of a step; rounding errors within a step may be as large as this */
    vm_real ratio;     /* tolerance of the loose run divided by that of the strict run */
    vm_real factor;    /* estimated error of the strict run, divided by the difference of the two runs */
    vm_real by_chance; /* the estimated error is at least this number times the tolerance of the steps */
} vmi_osc_tuning;

/* A method of integration: a system of equations, a Runge-Kutta pair, and numbers that suit the pair */
typedef struct VM_TAG(vmi_osc_method) {
    ode_rhs rhs;  /* the right-hand side: vmi_osc_averaged_rhs or vmi_osc_direct_rhs */
    int averaged; /* 1 where rhs belongs to the averaged equations, so that the error of averaging must be added; else
                     0 */
    int direct;   /* 1 where the state of rhs is position and velocity, 0 where it is amplitude and phase */
    int (*init)(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                const rk45_options *options_or_NULL, vm_real *work); /* rk45_init or rk87_init */
    int (*solve)(rk45 *s, vm_real t_end);                            /* rk45_solve or rk87_solve */
    vmi_osc_tuning tuning;                                           /* numbers that suit this Runge-Kutta pair */
} vmi_osc_method;

/* A method of integration with the Runge-Kutta pair rk45. rk45 does not change the length of its steps while their
   error is between 1/4 and 3/4 of the tolerance; these limits differ by a factor of 3. The field `ratio` is larger than
   this factor, so that the steps of the two runs have different lengths. The field `factor` allows for errors that are
   not proportional to the tolerance. Errors are mostly far below the tolerance of the steps, so two runs may agree well
   by chance. Because of this the estimated error is at least by_chance times the tolerance of the steps. */
VM_API vmi_osc_method vmi_osc_method_rk45(ode_rhs rhs)
{
    vmi_osc_method method;
    method.rhs = rhs;
    method.averaged = 0;
    method.direct = 0;
    method.init = rk45_init;
    method.solve = rk45_solve;
    method.tuning.least = 16 * VM_EPSILON;
    method.tuning.ratio = 15;
    method.tuning.factor = VM_C(0.5);
    method.tuning.by_chance = VM_C(1e-3);
    return method;
}

/* A method of integration with the Runge-Kutta pair rk87, which does not change the length of its steps while their
   error is between 1/10 and 3/4 of the tolerance. These limits differ by a factor of 7.5. */
VM_API vmi_osc_method vmi_osc_method_rk87(ode_rhs rhs)
{
    vmi_osc_method method = vmi_osc_method_rk45(rhs);
    method.init = rk87_init;
    method.solve = rk87_solve;
    method.tuning.least = 256 * VM_EPSILON;
    method.tuning.ratio = 60;
    method.tuning.factor = VM_C(0.25);
    method.tuning.by_chance = VM_C(1e-4);
    return method;
}

/* Indices of the state: position and velocity for the equation of motion, ln A and Ateb phase for the averaged
   equations */
enum { VMI_OSC_X = 0, VMI_OSC_V = 1, VMI_OSC_LN_A = 0, VMI_OSC_PSI = 1, VMI_OSC_STATES = 2 };

/* The longest step of the first loose run, in periods */
#define VMI_OSC_LONGEST VM_C(0.2)

/* A run of an integrator from 0 to t */
typedef struct VM_TAG(vmi_osc_run) {
    const vm_osc_plan *plan;
    const vmi_osc_method *method;
    int route;        /* the route that uses this method, VM_ROUTE_... */
    vmi_osc_wave wave;
    int side;         /* 1 forward, -1 backward in time */
    int status;       /* status of a law of mass or stiffness that stopped the run, else VM_OK */
    vm_real longest;  /* longest step, in periods */
    vm_real share;    /* longest step divided by the interval up to the next stop */
    vm_real law_step; /* longest step, s, of the first loose run: so short that no change of a mass or stiffness that a
                         user's function gives is missed */
    long evals;       /* number of evaluations of right-hand sides by all runs so far */
    rk45 s;
    vm_real work[RK87_WORK(VMI_OSC_STATES)];
} vmi_osc_run;

/* -- Right-hand sides -- */

/* Right-hand side of the averaged equations. The state y is ln(A/A0), with A0 the amplitude at t = 0, and the Ateb
   phase. */
VM_API int vmi_osc_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *run)
{
    vmi_osc_run *c = (vmi_osc_run *)run;
    const vm_osc_plan *p = c->plan;
    const vm_real A = p->A * vmi_exp(y[VMI_OSC_LN_A], 0);
    vmi_osc_rates now;
    vm_real Om, theta_rate;
    c->status = vmi_osc_rates_at(&p->problem, t, c->side, &now);
    if (c->status) return c->status;
    Om = p->Om * vmi_osc_Om_ratio(p, &now, y[VMI_OSC_LN_A]);
    vmi_osc_averaged_rates(p, &c->wave, &now, t, A, Om, &dydt[VMI_OSC_LN_A], &theta_rate);
    dydt[VMI_OSC_PSI] = Om + theta_rate / c->wave.turn;
    return 0;
}

/* (m/m0)^reactive. A body on which only the reactive force acts has a velocity proportional to the inverse of this
   power. */
VM_API vm_real vmi_osc_reactive_weight(const vm_osc_problem *o, vm_real mass_ratio)
{
    if (o->reactive == 1) return mass_ratio;
    if (o->reactive == 0) return 1;
    return vmi_pow_checked(mass_ratio, o->reactive);
}

/* Right-hand side of the equation of motion. The state y is x/A0 and (m/m0)^reactive x'/vmax, with the amplitude A0
   and the largest velocity vmax at t = 0. The factor of x' compensates for the reactive force, so that y keeps its
   size. */
VM_API int vmi_osc_direct_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *run)
{
    vmi_osc_run *c = (vmi_osc_run *)run;
    const vm_osc_plan *p = c->plan;
    const vm_osc_problem *o = &p->problem;
    const vm_real speed = 2 * p->Om / (o->alpha + 1); /* vmax/A0 at t = 0 */
    vmi_osc_rates now;
    vm_real m, weight;
    c->status = vmi_osc_rates_at(&p->problem, t, c->side, &now);
    if (c->status) return c->status;
    m = now.m / p->m0;
    weight = vmi_osc_reactive_weight(o, m);
    dydt[VMI_OSC_X] = speed * y[VMI_OSC_V] / weight;
    dydt[VMI_OSC_V] = -p->Om * (now.k / p->k0) * weight / m * vmi_osc_elastic(y[VMI_OSC_X], o->alpha) -
                      o->damping / now.m * y[VMI_OSC_V];
    if (o->force)
        dydt[VMI_OSC_V] += o->force(t, p->A * y[VMI_OSC_X], p->A * dydt[VMI_OSC_X], o->ctx) * weight /
                           (now.m * p->A * speed);
    return 0;
}

/* -- One run -- */

/* The period at the present time of the run, s. For the averaged equations the period follows from the amplitude in y,
   for the equation of motion from the adiabatic law of the amplitude without damping (vmi_osc_adiabatic). Returns NaN
   where the law of the mass or of the stiffness fails. */
VM_API vm_real vmi_osc_period_now(const vmi_osc_run *c)
{
    const vm_osc_plan *p = c->plan;
    vmi_osc_rates now;
    vm_real ln_A, ln_Om;
    if (vmi_osc_rates_at(&p->problem, c->s.t, c->side, &now)) return VM_NAN;
    if (!c->method->direct) return 2 * p->ripple.pi / (p->Om * vmi_osc_Om_ratio(p, &now, c->s.y[VMI_OSC_LN_A]));
    vmi_osc_adiabatic(p, vmi_log(now.m / p->m0).hi, vmi_log(now.k / p->k0).hi, 0, &ln_A, &ln_Om);
    return 2 * p->ripple.pi / (p->Om * vmi_exp(ln_Om, 0));
}

/* The time at which the run stops next on its way to t: the next point of a table, but at most 64 periods from now */
VM_API vm_real vmi_osc_next_stop(const vmi_osc_run *c, vm_real t, vm_real period)
{
    const vm_real stretch = 64 * period, stop = vmi_osc_next_knot(&c->plan->problem, c->s.t, t);
    if (VM_FABS(stop - c->s.t) > stretch) return c->s.t + (vm_real)c->side * stretch;
    return stop;
}

/* Sets the longest step and the largest number of steps up to the next stop, on the way to t. No step is longer than a
   fixed part of the period. If Pi_alpha is more than 10, the velocity reverses within the short time of 10/Pi_alpha
   periods. Then no step is longer than a fixed part of this time, because the Runge-Kutta pair would not notice the
   error of a step that contains the whole reversal. */
VM_API void vmi_osc_bound_steps(vmi_osc_run *c, vm_real stop, vm_real t, vm_real period)
{
    const vm_real most_steps = 8192; /* per period; with it the largest number of steps of a run is computed */
    const vm_real largest_long = VM_C(1e9), bounces_from = 10; /* from here on Pi_alpha counts as large */
    const vm_real way = VM_FABS(stop - c->s.t), most = c->share * way + 64 * VM_EPSILON * VM_FABS(t);
    const vm_real law_step = c->law_step * c->longest / VMI_OSC_LONGEST;
    vm_real longest = period * c->longest, steps;
    if (!(c->plan->ripple.pi < bounces_from)) longest = period * (c->longest * bounces_from / c->plan->ripple.pi);
    longest = vmi_smaller(most, vmi_smaller(law_step, longest));
    c->s.options.h_max = longest;
    steps = way * (most_steps / period + 4 / longest) + most_steps;
    c->s.options.max_steps = steps < largest_long ? (long)steps : 1000000000L;
}

/* Integrates to the time t. At every stop (vmi_osc_next_stop) the function subtracts whole turns from the phase, and
   sets new bounds of the steps. */
VM_API int vmi_osc_solve(vmi_osc_run *c, vm_real t)
{
    const vm_real most_periods = VM_C(8388608.); /* 2^23: after more periods a phase in float has no correct digits */
    const vm_real turn = 2 * c->plan->ripple.pi;
    int status = VM_OK;
    while (status >= 0 && c->s.t != t) {
        const vm_real period = vmi_osc_period_now(c);
        vm_real stop, y[VMI_OSC_STATES];
        if (!(period > VM_FABS(t) / most_periods)) return c->status ? c->status : VM_NOT_INTEGRATED;
        stop = vmi_osc_next_stop(c, t, period);
        vmi_osc_bound_steps(c, stop, t, period);
        status = c->method->solve(&c->s, stop);
        if (status < 0) break;
        y[0] = c->s.y[0];
        y[1] = c->s.y[1];
        if (!c->method->direct) y[VMI_OSC_PSI] -= turn * VM_FLOOR(y[VMI_OSC_PSI] / turn);
        status = rk45_restart(&c->s, c->s.t, y);
    }
    if (c->status) return c->status;
    if (status < 0) return VM_NOT_INTEGRATED;
    return VM_OK;
}

/* Writes the motion at the run's present time, but not the fields error and evals. */
VM_API int vmi_osc_motion_now(const vmi_osc_run *c, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->plan;
    const vm_real *y = c->s.y;
    vm_real ca, sa, weight, unused;
    vmi_osc_rates now;
    int status = vmi_osc_rates_at(&p->problem, c->s.t, -c->side, &now);
    if (status) return status;
    if (!c->method->direct) {
        const vm_real A = p->A * vmi_exp(y[VMI_OSC_LN_A], 0), Om = p->Om * vmi_osc_Om_ratio(p, &now, y[VMI_OSC_LN_A]);
        vmi_osc_wave_at(&c->wave, y[VMI_OSC_PSI], &ca, &sa);
        return vmi_osc_motion_of(&c->wave, A, Om, ca, sa, 0, c->route, motion);
    }
    weight = vmi_osc_reactive_weight(&p->problem, now.m / p->m0);
    motion->x = p->A * y[VMI_OSC_X];
    motion->v = 2 * p->A * p->Om / (p->problem.alpha + 1) * y[VMI_OSC_V] / weight;
    vm_osc_amplitude_phase(motion->x, motion->v, VM_SQRT(now.k / now.m), p->problem.alpha, &motion->amplitude,
                           &unused);
    motion->route = c->route;
    return VM_IS_FINITE(motion->amplitude) ? VM_OK : VM_NOT_FINITE;
}

/* Makes one run from 0 to t, and writes the motions at the VMI_OSC_CHECKS times of vmi_osc_check_time. */
VM_API int vmi_osc_run_once(vmi_osc_run *c, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->plan;
    rk45_options options = rk45_defaults(NULL);
    vm_real y[VMI_OSC_STATES], ca, sa;
    int i, status;
    c->side = vmi_time_side(t);
    c->status = VM_OK;
    options.atol = tolerance;
    if (c->method->direct) {
        options.rtol = tolerance;
        vmi_osc_wave_at(&c->wave, p->psi, &ca, &sa);
        y[VMI_OSC_X] = ca;
        y[VMI_OSC_V] = -sa;
    } else {
        options.rtol = -1; /* no relative tolerance: atol limits the absolute errors of ln A and psi */
        y[VMI_OSC_LN_A] = 0;
        y[VMI_OSC_PSI] = p->psi;
    }
    status = c->method->init(&c->s, c->method->rhs, c, VMI_OSC_STATES, 0, y, &options, c->work);
    if (status < 0) return VM_NOT_INTEGRATED;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        status = vmi_osc_solve(c, vmi_osc_check_time(t, i));
        if (!status) status = vmi_osc_motion_now(c, &motion[i]);
        if (status) return status;
    }
    c->evals += c->s.evals;
    return VM_OK;
}

/* -- Two runs -- */

/* The largest difference of two runs: of x relative to the amplitude, and of v relative to the largest velocity. The
   function compares the runs at all times of vmi_osc_check_time, since at a single time two runs may agree by chance.
   Returns infinity where the difference is unknown. */
VM_API vm_real vmi_osc_difference(const vm_osc_plan *p, vm_real t, const vm_osc_motion *a, const vm_osc_motion *b)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        vmi_osc_rates now;
        vm_real vmax;
        if (a[i].amplitude == 0) return VM_INFINITY;
        if (vmi_osc_rates_at(&p->problem, vmi_osc_check_time(t, i), -vmi_time_side(t), &now)) return VM_INFINITY;
        vmax = vm_osc_vmax(a[i].amplitude, VM_SQRT(now.k / now.m), p->problem.alpha);
        largest = vmi_larger(VM_FABS(a[i].x - b[i].x) / a[i].amplitude, largest);
        largest = vmi_larger(VM_FABS(a[i].v - b[i].v) / vmax, largest);
    }
    return largest;
}

/* Computes the longest step, s, with which an integrator misses no change of mass or stiffness that a user's function
   gives. vmi_osc_walk_along divides the time into panels, which are short where mass or stiffness changes fast; the
   step is a quarter of the shortest panel. If the mass or the stiffness jumped, this step would be 0; therefore it is
   at least |t|/8192. If the field change_time of a law is set and shorter than this step, the step is change_time. */
VM_API int vmi_osc_law_step(const vm_osc_plan *p, vm_real t, vm_real *step)
{
    const vm_real panel_steps = 4, run_steps = 8192;
    const vm_law *laws[2];
    vmi_osc_mean mean;
    int i, status;
    laws[0] = &p->problem.mass;
    laws[1] = &p->problem.stiffness;
    *step = VM_FABS(t);
    if (!laws[0]->function && !laws[1]->function) return VM_OK;
    status = vmi_osc_walk_along(p, t, &mean);
    if (status) return status;
    *step = vmi_larger(mean.shortest / panel_steps, VM_FABS(t) / run_steps);
    *step = vmi_larger(*step, VM_MIN); /* t may be subnormal */
    for (i = 0; i < 2; i++) {
        const vm_real change_time = laws[i]->function ? laws[i]->change_time : 0;
        if (change_time > 0 && change_time < *step) *step = change_time;
    }
    return VM_OK;
}

/* Makes a loose run, and then a strict run with a smaller tolerance and half the longest step. If the law of the mass
   or of the stiffness stopped one of the runs, c->status is the status of this law. */
VM_API int vmi_osc_try_pair(vmi_osc_run *c, vm_real t, vm_real step_tolerance, vm_real longest, vm_osc_motion *loose,
                            vm_osc_motion *strict)
{
    int status;
    c->longest = longest;
    c->share = 1;
    status = vmi_osc_run_once(c, t, c->method->tuning.ratio * step_tolerance, loose);
    c->longest = longest / 2;
    c->share = VM_C(0.51);
    if (status) return status;
    return vmi_osc_run_once(c, t, step_tolerance, strict);
}

/* The part of the error that comes from rounding of phase and time. *last is the motion at t. Returns infinity if a law
   fails at t. */
VM_API vm_real vmi_osc_run_rounding(const vmi_osc_run *c, vm_real t, const vm_osc_motion *last)
{
    const vm_osc_problem *o = &c->plan->problem;
    vmi_osc_rates now;
    vm_real W, relative_rate;
    if (vmi_osc_rates_at(o, t, -c->side, &now)) return VM_INFINITY;
    W = vmi_osc_rate(last->amplitude, VM_SQRT(now.k / now.m), o->alpha);
    relative_rate = vmi_osc_relative_rate(o->alpha, now.p, now.a, now.k_rate);
    return vmi_larger(vmi_osc_time_rounding(t, W, relative_rate), 4 * VM_EPSILON * (2 + c->plan->Om * VM_FABS(t)));
}

/* Estimate of the error of the strict run, including rounding errors */
VM_API vm_real vmi_osc_pair_error(const vmi_osc_run *c, vm_real t, vm_real step_tolerance, const vm_osc_motion *loose,
                                  const vm_osc_motion *strict)
{
    const vmi_osc_tuning *tuning = &c->method->tuning;
    const vm_real rounding = vmi_osc_run_rounding(c, t, strict + VMI_OSC_CHECKS - 1);
    const vm_real error = tuning->factor * vmi_osc_difference(c->plan, t, strict, loose) + rounding;
    return vmi_larger(tuning->by_chance * step_tolerance, error);
}

/* The tolerance of the steps in the first pair of runs. It is less than the tolerance of the motion, since errors of
   steps add up, and at most 1e-3, since with larger steps the integrator may diverge from the motion. */
VM_API vm_real vmi_osc_first_tolerance(vm_real tolerance)
{
    const vm_real part = 8, largest = VM_C(1e-3);
    return vmi_smaller(tolerance / part, largest);
}

/* The tolerance of the steps in the next pair of runs, where the error of the last pair was too large. step_tolerance
   is the tolerance of the steps in the last pair. The result is step_tolerance times tolerance/error, divided by 4;
   where tolerance/error is not above 1e-4, it is 2e-5 times step_tolerance. */
VM_API vm_real vmi_osc_next_tolerance(vm_real step_tolerance, vm_real tolerance, vm_real error)
{
    const vm_real ratio = tolerance / error, reserve = 4;
    if (ratio > VM_C(1e-4)) return step_tolerance * (ratio / reserve);
    return step_tolerance * VM_C(2e-5);
}

/* Makes pairs of runs until the error is at most the tolerance. The motions of the last strict run are written to
   strict[]; the last of these motions contains the error. If the error of a pair is more than half of the error of the
   pair before it, the error may come from steps that are too long, and the longest step is halved. The error may also
   come from rounding errors or chance; therefore the function ends after three such pairs. */
VM_API int vmi_osc_refine(vmi_osc_run *c, vm_real t, vm_real tolerance, vm_osc_motion *strict)
{
    const int most_attempts = 6, most_stalled = 3;
    const vmi_osc_tuning *tuning = &c->method->tuning;
    vm_osc_motion loose[VMI_OSC_CHECKS];
    vm_real step_tolerance = vmi_osc_first_tolerance(tolerance), longest = VMI_OSC_LONGEST, before = VM_INFINITY;
    int attempt, stalled = 0, status = VM_NOT_INTEGRATED;
    for (attempt = 0; attempt < most_attempts; attempt++) {
        vm_real error;
        if (step_tolerance < tuning->least) step_tolerance = tuning->least;
        status = vmi_osc_try_pair(c, t, step_tolerance, longest, loose, strict);
        if (status == VM_NOT_INTEGRATED && c->status == VM_OK && step_tolerance > tuning->least) {
            step_tolerance /= 2 * tuning->ratio; /* the loose run may have diverged */
            continue;
        }
        if (status) return status;
        error = vmi_osc_pair_error(c, t, step_tolerance, loose, strict);
        strict[VMI_OSC_CHECKS - 1].error = error;
        if (error > before / 2) {
            stalled++;
            longest /= 2;
        }
        if (error <= tolerance || step_tolerance == tuning->least || stalled == most_stalled) break;
        before = error;
        step_tolerance = vmi_osc_next_tolerance(step_tolerance, tolerance, error);
    }
    return status;
}

/* Computes the motion at t by a method of integration. Returns VM_TOLERANCE_MISSED where the error of the integration
   is larger than the tolerance. For averaged equations the function also adds the error of averaging to motion->error;
   this error does not change the status. */
VM_API int vmi_osc_integrate(const vm_osc_plan *plan, int route, const vmi_osc_method *method, vm_real t,
                             vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan with_ateb;
    vmi_osc_run c;
    vm_osc_motion strict[VMI_OSC_CHECKS], *last = strict + VMI_OSC_CHECKS - 1;
    vm_real averaging = 0;
    int status = vmi_osc_law_step(plan, t, &c.law_step);
    if (status) return status;
    c.plan = plan;
    c.method = method;
    c.route = route;
    c.evals = 0;
    if (!plan->has_ateb) {
        with_ateb = *plan;
        with_ateb.has_ateb = ateb_plan_init(&with_ateb.ateb, plan->problem.alpha) == 0;
        c.plan = &with_ateb;
    }
    c.wave = vmi_osc_wave_of(c.plan, route);
    status = vmi_osc_refine(&c, t, tolerance, strict);
    if (!status && method->averaged) status = vmi_osc_averaging_error(c.plan, &c.wave, t, strict, &averaging);
    if (status) return status;
    last->evals = c.evals;
    *motion = *last;
    motion->error += averaging;
    return last->error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

#endif
