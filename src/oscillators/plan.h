/* oscillators/plan.h - the plan of an oscillator: what is computed once and then used at many times t

   A plan contains the amplitude and the phase at t = 0, the mean motion at t = 0 by the law of order five
   (oscillators/expansion.h), and closed forms of the integrals along the laws of mass and stiffness, if there are such
   forms:
       vm_osc_plan plan;
       int status = vm_osc_plan_init(&plan, &problem); // problem is a vm_osc_problem
   Tests: tests/test_slow_motion.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_PLAN_H
#define VARMASS_OSCILLATORS_PLAN_H

#include "../ateb/period.h"
#include "../ateb/plans.h"
#include "../base/real.h"
#include "../base/status.h"
#include "closed.h"
#include "constant_mass.h"
#include "expansion.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"
#include "waves.h"

/* A plan: numbers that vm_osc_plan_init computes once for a problem. Read the fields of the plan, but do not change
   them. The plan contains pointers to the tables of the problem, to the user's functions and to their ctx; therefore a
   copy of the plan is of no use in another program. */
typedef struct VM_TAG(vm_osc_plan) {
    vm_osc_problem problem;  /* a copy of the problem */
    vm_real m0, k0;          /* mass, kg, and stiffness, N/m^alpha, at t = 0 */
    vm_real A, psi, Om;      /* at t = 0: amplitude A, m, and Ateb phase psi of the state (x, v), and rate Om of the
                                phase, 1/s */
    vmi_osc_slow slow;       /* mass, stiffness and the numbers G_k (see vmi_osc_slow) just after t = 0 */
    vm_real E[VMI_OSC_G];    /* the numbers E_k at t = 0 (see vmi_osc_disturbance) */
    vmi_osc_reduced mean;    /* amplitude, phase and rate of the mean motion at t = 0 */
    int start_order;         /* order after which the law of order five was cut off to find `mean`: 5, or 2 if `ripple`
                                has no polynomials; 0 where there is no mean motion, because x and v are 0 or because
                                Om is too small (vmi_osc_has_phase) */
    int closed;              /* 1 where all integrals along the laws have closed forms, else 0 */
    vmi_osc_rates_of_u laws; /* where `closed` is 1, the rates in the exponents of the laws (oscillators/closed.h) */
    vmi_osc_closed_mean closed_mean; /* where `closed` is 1, the mean motion at t = 0 and its rates */
    int has_ateb;            /* 1 where the field ateb is set, else 0 */
    vmi_ripple ripple;       /* the ripple (oscillators/ripple.h), prepared for alpha */
    ateb_plan ateb;          /* Ateb functions, prepared for alpha */
} vm_osc_plan;

/* Returns the wave, that is the periodic function cos, cn or ca, by which a route describes the vibration. The wave
   contains a pointer into the plan; therefore the plan must exist as long as the wave is used. */
VM_API vmi_osc_wave vmi_osc_wave_of(const vm_osc_plan *p, int route)
{
    if (route == VM_ROUTE_TRIG) return vmi_osc_wave_cos(p->problem.alpha, p->ripple.pi);
    if (route == VM_ROUTE_JACOBI) return vmi_osc_wave_cn(p->problem.alpha, p->ripple.pi);
    return vmi_osc_wave_ca(p->problem.alpha, p->has_ateb ? &p->ateb : NULL);
}

/* Returns 0 if the elastic force is so weak that the rate Om of the phase underflows, or that the time in which the
   phase grows by 16 overflows; else 1. For alpha = 5 this is so at an amplitude of 1e-200 m. Such a body moves as if no
   spring were there: in any time that matters its phase stays as it is, and all changes of mass and stiffness are fast
   in comparison. */
VM_API int vmi_osc_has_phase(const vm_osc_plan *p) { return p->Om >= 8 * VM_MIN; }

/* Returns the time, s, in which the phase grows by 16. The second and higher derivatives of a law by a user's function
   are found from its first derivatives within this time. The plan must have a phase (vmi_osc_has_phase). */
VM_API vm_real vmi_osc_sampling_time(const vm_osc_plan *p) { return 16 / p->Om; }

/* Returns the mean motion that belongs to a reduced state (see vmi_osc_reduced), by the law of the given order, 2 to 5.
   E contains the numbers E_k of the state (see vmi_osc_disturbance). */
VM_API vmi_osc_reduced vmi_osc_mean_of(const vm_osc_plan *p, int order, const vmi_osc_reduced *state, const vm_real *E)
{
    const vmi_osc_wave w = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vm_real sa, ca;
    vmi_osc_wave_at(&w, state->psi, &ca, &sa);
    return vmi_expansion_to_mean(&p->ripple, order, state, sa, ca, E);
}

/* Returns the function that computes the constants of the Ateb functions. If for_many is 1, this is the accurate
   function, for structs that are used for many values, such as a vm_osc_closed. If for_many is 0, it is the fast
   function, for a single value. */
VM_API vmi_ateb_constants_of vmi_osc_constants_of(int for_many)
{
    if (for_many) return vmi_ateb_fine_constants;
    return vmi_ateb_constants;
}

/* Sets the fields `slow`, `E` and `mean` where the plan has no phase: to mass, stiffness and their rates, and to the
   amplitude and the phase at t = 0. */
VM_API int vmi_osc_start_without_phase(vm_osc_plan *p)
{
    vmi_osc_rates rates;
    int i, status = vmi_osc_rates_at(&p->problem, 0, 1, &rates);
    if (status) return status;
    p->slow.m = rates.m;
    p->slow.k = rates.k;
    p->slow.a = rates.a;
    p->slow.p = rates.p;
    p->slow.k_rate = rates.k_rate;
    p->slow.bend = 0;
    p->slow.unit = 1;
    for (i = 0; i < VMI_OSC_G; i++) {
        p->slow.G[i] = 0;
        p->E[i] = 0;
    }
    p->mean.A = p->A;
    p->mean.psi = p->psi;
    p->mean.W = p->Om;
    p->closed = 0;
    return VM_OK;
}

/* Computes the mean motion at t = 0, by the law of order 5 if p->ripple has its polynomials, else by the law of order
   2. */
VM_API int vmi_osc_start(vm_osc_plan *p)
{
    const vm_osc_problem *o = &p->problem;
    vmi_osc_closed_rates rates = {0, 0, 0};
    vmi_osc_reduced state;
    int status;
    p->start_order = 0;
    if (p->A == 0) return VM_OK;
    if (!vmi_osc_has_phase(p)) return vmi_osc_start_without_phase(p);
    status = vmi_osc_slow_at(o, 0, 1, vmi_osc_sampling_time(p), 1 / p->Om, &p->slow);
    if (status) return status;
    if (p->closed) {
        rates = vmi_osc_closed_rates_of(o, &p->laws, p->m0);
        p->slow.p = rates.p;
    }
    if (p->has_ateb)
        state = vmi_osc_reduce_by_series(VM_SQRT(p->slow.k / p->slow.m), o->alpha, o->x, o->v + p->slow.p * o->x);
    else state = vmi_osc_reduce(&p->slow, o->alpha, o->x, o->v);
    if (p->closed) vmi_osc_closed_disturbance(&rates, state.W, VMI_OSC_G, p->E);
    else vmi_osc_disturbance(&p->slow, state.W, p->E);
    p->start_order = 2;
    if (p->ripple.has_polynomials) p->start_order = 5;
    p->mean = vmi_osc_mean_of(p, p->start_order, &state, p->E);
    if (p->closed) vmi_osc_closed_mean_init(&p->closed_mean, &p->mean, p->laws.base, &rates, &p->ripple);
    return VM_OK;
}

/* Fills the plan except for three parts. The first part, the mean motion, is added by vmi_osc_start. The second and the
   third part are the plan of the Ateb functions and the polynomials of the ripple, which save time only for many
   values. for_many is 1 if the caller adds the second and the third part. */
VM_API int vmi_osc_prepare(vm_osc_plan *p, const vm_osc_problem *problem, int for_many)
{
    const vm_osc_problem *o = &p->problem;
    vm_real omega;
    int status;
    p->problem = *problem;
    p->has_ateb = 0;
    status = vmi_osc_check_problem(o, 0, &p->m0, &p->k0);
    if (status) return status;
    omega = VM_SQRT(p->k0 / p->m0);
    vmi_ripple_init(&p->ripple, o->alpha, vmi_osc_constants_of(for_many));
    vm_osc_amplitude_phase(o->x, o->v, omega, o->alpha, &p->A, &p->psi);
    p->Om = p->A == 0 ? 0 : vmi_osc_rate(p->A, omega, o->alpha);
    if (!VM_IS_FINITE(p->A) || !VM_IS_FINITE(p->psi) || !VM_IS_FINITE(p->Om)) return VM_NOT_FINITE;
    p->closed = vmi_osc_find_closed_form(o, &p->laws);
    return VM_OK;
}

/* Makes a plan, by which the motion of one problem is computed for many values of t. The functions
   vm_osc_plan_by_route, vm_osc_plan_within and vm_osc_averaged use the plan. The problem is copied; its tables and what
   ctx points to must exist as long as the plan is used. Errors leave the plan untouched. Returns VM_BAD_ARGUMENT for
   null pointers and for a law that no constructor made, VM_NOT_FINITE for a number that is infinite or NaN and for
   alpha > 1e30, VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive at t = 0 or in a table,
   and VM_DOMAIN for alpha < 0, for a table whose times do not rise or do not contain t = 0, and where the user's
   function of a law fails. */
VM_API int vm_osc_plan_init(vm_osc_plan *p, const vm_osc_problem *problem)
{
    vm_osc_plan plan;
    int status;
    if (!p || !problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(&plan, problem, 1);
    if (status) return status;
    plan.has_ateb = ateb_plan_init(&plan.ateb, problem->alpha) == 0;
    vmi_ripple_complete(&plan.ripple, 5);
    status = vmi_osc_start(&plan);
    if (!status) *p = plan;
    return status;
}

#endif
