/* oscillators/problem.h - an oscillator whose mass and stiffness vary slowly, and the plan that is made of it

   The equation of motion, with mass m(t), stiffness k(t), damping b and a further small force F, is
     m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = F(t, x, x'),   x(0) and x'(0) given.
   Without F three numbers decide on x(t), all by the Ateb phase psi, whose rate is Om:
     q = k'/k + (2 reactive - 1) m'/m + 2 b/m, the rate at which m, k and b change the motion, 1/s,
     h, which stands for q' in averaging to second order, 1/s^2,
     q/Om, which must be small for all routes that average.
   The plan holds what has to be computed only once for a problem. The motion from a problem or a plan is in
   oscillators/routes.h, which shows the shortest useful call.
   Tests: tests/test_averaging.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_PROBLEM_H
#define VARMASS_OSCILLATORS_PROBLEM_H

#include "../ateb/period.h"
#include "../ateb/plans.h"
#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "laws.h"
#include "waves.h"

/* Routes to x(t), x'(t), the cheapest first. The first four average, and need a small q/Om. */
enum {
    VM_ROUTE_TRIG = 0,      /* cosine (329), (330), averaged to first order, with the sign of (335) corrected */
    VM_ROUTE_JACOBI = 1,    /* cn (370), (371), averaged to first order */
    VM_ROUTE_ATEB = 2,      /* ca (310), (311), averaged to first order: error q/Om */
    VM_ROUTE_SECOND = 3,    /* ca, averaged to second order: error (q/Om)^2; only without F */
    VM_ROUTE_VARIATION = 4, /* exact equations of amplitude and phase, (314), (315) completed, by rk45 */
    VM_ROUTE_RK45 = 5,      /* the equation of motion by rk45 */
    VM_ROUTE_RK87 = 6       /* the equation of motion by rk87 */
};

/* A further small force F, N, at time t (s), position x (m) and velocity v (m/s) */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);

/* An oscillator and its state at t = 0 */
typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;      /* exponent of the spring's force, >= 0 */
    vm_law mass;        /* kg, positive */
    vm_law stiffness;   /* N/m^alpha, positive */
    vm_real reactive;   /* 1: mass that joins or leaves is at rest, full reactive force; 0: it has the body's own
                           velocity, as in a leak; numbers between mean a part of the force */
    vm_real damping;    /* b, kg/s, the dissertation's eps b; > 0 takes energy out */
    vm_real x, v;       /* position, m, and velocity, m/s, at t = 0 */
    vm_osc_force force; /* a further small force F, or NULL */
    void *ctx;          /* last argument of force */
} vm_osc_problem;

/* The motion at one time */
typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;      /* position, m, and velocity, m/s */
    vm_real amplitude; /* A, m; of the first four routes without its ripple within a period */
    vm_real error;     /* estimate of the larger of |error of x|/A and |error of v|/vmax(A), from all causes */
    int route;         /* VM_ROUTE_... that was taken */
    long evals;        /* evaluations of right-hand sides; 0 where none were integrated */
} vm_osc_motion;

/* What is computed only once for a problem, by vm_osc_plan_init. To be read, not changed. It points to the problem's
   tables and contexts, and is not to be copied bit by bit into another program. */
typedef struct VM_TAG(vm_osc_plan) {
    vm_osc_problem problem;
    vm_real pi;             /* Pi_alpha */
    vm_real gamma;          /* (alpha-1)/(alpha+3) */
    vm_real mean_ca2;       /* the mean of ca^2 */
    vm_real m0, k0;         /* mass, kg, and stiffness, N/m^alpha, at t = 0 */
    vm_real A, psi, Om;     /* at t = 0: amplitude, m, Ateb phase, and its rate, 1/s */
    vm_real q, h, h_rate;   /* at t = 0: see vmi_osc_rates */
    vm_real ln_rho;         /* second order: (alpha+3)/2 times ln of the amplitude over its mean at t = 0 */
    vm_real shift;          /* second order: mean phase minus psi at t = 0 */
    vm_real base;           /* closed forms, 1/s: m = m0 exp(rate_m u), k = k0 exp(rate_k u), u = ln(1 + base t)/base */
    vm_real rate_m, rate_k; /* 1/s */
    int closed;             /* whether m and k have these closed forms */
    int has_ateb;           /* whether ateb is there */
    ateb_plan ateb;
} vm_osc_plan;

/* -- What drives the averaged motion -- */

/* The wave that a route uses; the plan must outlive it. */
VM_API vmi_osc_wave vmi_osc_wave_of(const vm_osc_plan *p, int route)
{
    if (route == VM_ROUTE_TRIG) return vmi_osc_wave_cos(p->problem.alpha, p->pi);
    if (route == VM_ROUTE_JACOBI) return vmi_osc_wave_cn(p->problem.alpha, p->pi);
    return vmi_osc_wave_ca(p->problem.alpha, p->has_ateb ? &p->ateb : NULL);
}

/* Mass and stiffness at a time, and how fast they and the damping change the motion there */
typedef struct VM_TAG(vmi_osc_rates) {
    vm_real m, k;   /* kg, N/m^alpha */
    vm_real q;      /* 1/s */
    vm_real h;      /* q' - q (k'/k - m'/m - gamma q)/2, 1/s^2 */
    vm_real h_rate; /* the part of h' that tables make large, 1/s^3 */
} vmi_osc_rates;

/* The rates at t; where they jump, those after t for side = 1, those before it for side = -1. with_h: h and h_rate are
   wanted, for which laws by functions are evaluated at two more times; else they are not set. */
VM_API int vmi_osc_rates_at(const vm_osc_plan *p, vm_real t, int side, int with_h, vmi_osc_rates *r)
{
    const vm_osc_problem *o = &p->problem;
    const vm_real step = with_h && p->Om > 0 ? (vm_real)side / (32 * p->Om) : 0;
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS], ln_m, ln_k; /* derivatives of m, k; of ln m, ln k by time */
    int status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, t, side, step, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, step, k);
    if (status) return status;
    ln_m = m[1] / m[0];
    ln_k = k[1] / k[0];
    r->m = m[0];
    r->k = k[0];
    r->q = ln_k + (2 * o->reactive - 1) * ln_m + 2 * o->damping / m[0];
    if (!with_h) return VM_OK;
    r->h = (k[2] / k[0] - ln_k * ln_k) + (2 * o->reactive - 1) * (m[2] / m[0] - ln_m * ln_m) -
           2 * o->damping * ln_m / m[0];
    r->h -= r->q * (ln_k - ln_m - p->gamma * r->q) / 2;
    r->h_rate = k[3] / k[0] + (2 * o->reactive - 1) * m[3] / m[0];
    return VM_OK;
}

/* ln(A/A0) and ln(Om/Om0) by the adiabatic law, where ln(m/m0), ln(k/k0) and the decay, the integral of b/m, have
   these values */
VM_API void vmi_osc_adiabatic(const vm_osc_plan *p, vm_real ln_m, vm_real ln_k, vm_real decay, vm_real *ln_A,
                              vm_real *ln_Om)
{
    const vm_real alpha = p->problem.alpha, r = 2 * p->problem.reactive - 1;
    *ln_A = -(ln_k + r * ln_m + 2 * decay) / (alpha + 3);
    *ln_Om = ((1 - p->gamma) * ln_k - (1 + p->gamma * r) * ln_m) / 2 - p->gamma * decay;
}

/* Integrals along the mean motion from 0 to t */
typedef struct VM_TAG(vmi_osc_integrals) {
    vm_real inverse_mass; /* of dt/m, s/kg */
    vm_real phase;        /* of Om/Om0 dt, s */
    vm_real drift;        /* of q^2 Om0/Om dt, 1/s */
} vmi_osc_integrals;

/* The mean phase to second order, from the integrals: Om0 phase + c2 drift/Om0, with Om0 at the mean amplitude */
VM_API vm_real vmi_osc_mean_phase(const vm_osc_plan *p, const vmi_osc_integrals *integral)
{
    const vm_real alpha = p->problem.alpha, Om = p->Om * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real c2 = -p->mean_ca2 * (alpha + 1) / (2 * (alpha + 3) * (alpha + 3));
    return p->psi + p->shift + (Om * integral->phase + c2 * integral->drift / Om);
}

/* c = ca and s = sa at the phase psi = mean + slope (ca^2(psi) - <ca^2>), by one step of Newton's method: the error is
   O(slope^3) */
VM_API void vmi_osc_phase_from_mean(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real mean, vm_real slope,
                                    vm_real *c, vm_real *s)
{
    vm_real step;
    vmi_osc_wave_at(w, mean, c, s);
    step = slope * (*c * *c - p->mean_ca2) / (1 + 4 * slope / (w->alpha + 1) * *s * *c);
    vmi_osc_wave_at(w, mean + step, c, s);
}

/* -- Making the plan -- */

/* Finds whether both laws are exponentials in one u, so that all integrals are closed forms. With damping the integral
   of b/m must be one in u, too: it is where m = m0 (1 + base t), or where only the damping changes the motion. */
VM_API void vmi_osc_find_closed_form(vm_osc_plan *p)
{
    const vm_osc_problem *o = &p->problem;
    vm_real base_m, base_k;
    p->closed = vmi_law_exponential_form(&o->mass, &base_m, &p->rate_m) &&
                vmi_law_exponential_form(&o->stiffness, &base_k, &p->rate_k) && !o->force;
    if (!p->closed) return;
    p->base = p->rate_m == 0 ? base_k : base_m;
    if (p->rate_m == 0 && p->rate_k == 0) p->base = 0;
    if (p->rate_m != 0 && p->rate_k != 0 && base_m != base_k) p->closed = 0;
    if (o->damping != 0 && p->rate_m != p->base) p->closed = 0;
}

/* The constants of the second-order solution that follow from the start: rho = (A/mean A)^((alpha+3)/2), whose ripple
   depends on Om at the mean amplitude, which depends on rho; and the mean phase minus the phase */
VM_API int vmi_osc_start(vm_osc_plan *p)
{
    const vm_real n = p->problem.alpha + 1, mean = p->mean_ca2, scale = 1 / p->Om;
    const vmi_osc_wave w = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vmi_osc_rates r;
    vm_real ca, sa, product, excess, rho = 1, Om_ratio = 1; /* sa ca; ca^2 less its mean; Om at the mean over Om */
    int i, status = vmi_osc_rates_at(p, 0, 1, 1, &r);
    if (status) return status;
    p->q = r.q;
    p->h = r.h;
    p->h_rate = r.h_rate;
    p->ln_rho = 0;
    p->shift = 0;
    if (p->A == 0 || (r.q == 0 && r.h == 0)) return VM_OK;
    vmi_osc_wave_at(&w, p->psi, &ca, &sa);
    product = sa * ca;
    excess = ca * ca - mean;
    for (i = 0; i < 3; i++) {
        const vm_real e = scale / Om_ratio; /* 1/Om at the mean amplitude */
        rho = 1 + r.q * e / 2 * product +
              (r.q * e * r.q * e * (2 - p->gamma) * (product * product - mean * n / (n + 6)) +
               n * excess * r.h * e * e) / 8;
        if (!(rho > 0) || !VM_IS_FINITE(rho)) rho = 1; /* the motion is not slow at all */
        Om_ratio = vmi_pow_checked(rho, -p->gamma);
    }
    p->ln_rho = vmi_log(rho).hi;
    p->shift = -r.q * scale / Om_ratio * n / (2 * (n + 2)) * excess;
    return VM_OK;
}

/* Whether mass and stiffness are positive between 0 and t: see vmi_law_check */
VM_API int vmi_osc_check_laws(const vm_osc_problem *o, vm_real t)
{
    return vmi_first_error(vmi_law_check(&o->mass, VM_BAD_MASS, t),
                           vmi_law_check(&o->stiffness, VM_BAD_STIFFNESS, t));
}

/* The problem's numbers, checked, and its laws at t = 0 */
VM_API int vmi_osc_check_problem(const vm_osc_problem *o, vm_real *mass, vm_real *stiffness)
{
    const vm_real numbers[5] = {o->alpha, o->reactive, o->damping, o->x, o->v};
    vm_real unused;
    int status = vmi_osc_check_laws(o, 0);
    if (!vmi_all_finite(5, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (o->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    if (!status) status = vmi_law_at(&o->mass, VM_BAD_MASS, 0, mass, &unused);
    if (!status) status = vmi_law_at(&o->stiffness, VM_BAD_STIFFNESS, 0, stiffness, &unused);
    return status;
}

/* The plan but for the plan of the Ateb functions, which pays only where many values are wanted, and vmi_osc_start */
VM_API int vmi_osc_prepare(vm_osc_plan *p, const vm_osc_problem *problem)
{
    const vm_osc_problem *o = &p->problem;
    vm_real omega;
    int status;
    p->problem = *problem;
    p->has_ateb = 0;
    status = vmi_osc_check_problem(o, &p->m0, &p->k0);
    if (status) return status;
    omega = VM_SQRT(p->k0 / p->m0);
    p->pi = ateb_pi(o->alpha);
    p->gamma = (o->alpha - 1) / (o->alpha + 3);
    p->mean_ca2 = vmi_osc_mean_ca2(o->alpha, p->pi);
    vm_osc_amplitude_phase(o->x, o->v, omega, o->alpha, &p->A, &p->psi);
    p->Om = p->A == 0 ? 0 : vmi_osc_rate(p->A, omega, o->alpha);
    if (!VM_IS_FINITE(p->A) || !VM_IS_FINITE(p->psi) || !VM_IS_FINITE(p->Om)) return VM_NOT_FINITE;
    vmi_osc_find_closed_form(p);
    return VM_OK;
}

/* Plan for many values of one problem's motion.
   For vm_osc_plan_by_route, vm_osc_plan_within and vm_osc_averaged. Copies the problem; its tables and contexts
   must outlive the plan. Errors leave the plan untouched: VM_BAD_ARGUMENT for null pointers and for a law that no
   constructor made, VM_NOT_FINITE, VM_BAD_MASS and VM_BAD_STIFFNESS for a law that is not positive at t = 0 or in a
   table, VM_DOMAIN for alpha < 0, a table out of order or without t = 0, or a function that fails. */
VM_API int vm_osc_plan_init(vm_osc_plan *p, const vm_osc_problem *problem)
{
    vm_osc_plan plan;
    int status;
    if (!p || !problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(&plan, problem);
    if (status) return status;
    plan.has_ateb = ateb_plan_init(&plan.ateb, problem->alpha) == 0;
    status = vmi_osc_start(&plan);
    if (!status) *p = plan;
    return status;
}

#endif
