/* oscillators/problem.h - an oscillator whose mass and stiffness vary slowly, and the plan that is made of it

   The equation of motion, with mass m(t), stiffness k(t), damping b and a further small force F, is
     m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = F(t, x, x'),   x(0) and x'(0) given.
   The solution x = A ca(psi) has the amplitude A and the Ateb phase psi, whose rate is Om. Two numbers measure how fast
   the motion changes where there is no F:
     q = k'/k + (2 reactive - 1) m'/m + 2 b/m, 1/s, the rate at which m, k and b change the motion,
     h = Om (q/Om)', 1/s^2, the rate of the small parameter q/Om times Om; only averaging to second order needs h.
   All routes that average need a small q/Om.
   A plan holds what has to be computed only once for a problem. oscillators/routes.h computes the motion from a problem
   or a plan, and shows the shortest useful call.
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

/* Routes to the motion x(t), x'(t), the cheapest first. The first four average, and need a small q/Om. */
enum {
    VM_ROUTE_TRIG = 0,      /* the cosine (329), (330), averaged to first order, with the sign of (335) corrected */
    VM_ROUTE_JACOBI = 1,    /* Jacobi's cn (370), (371), averaged to first order */
    VM_ROUTE_ATEB = 2,      /* the Ateb function ca (310), (311), averaged to first order */
    VM_ROUTE_SECOND = 3,    /* ca averaged to second order, error of order (q/Om)^2 up to t = 1/q; only without F */
    VM_ROUTE_VARIATION = 4, /* exact equations of amplitude and phase, (314), (315) corrected, integrated by rk45 */
    VM_ROUTE_RK45 = 5,      /* the equation of motion, integrated by rk45 */
    VM_ROUTE_RK87 = 6       /* the equation of motion, integrated by rk87 */
};

/* A user's function for a further small force: returns F, N, at time t (s), position x (m) and velocity v (m/s) */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);

/* An oscillator and its state at t = 0 */
typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;      /* exponent of the spring's force, >= 0 */
    vm_law mass;        /* mass m(t), kg, positive */
    vm_law stiffness;   /* stiffness k(t), N/m^alpha, positive */
    vm_real reactive;   /* share of the full reactive force: 1 where mass that joins or leaves is at rest, 0 where this
                           mass has the body's own velocity, as in a leak; numbers between are allowed */
    vm_real damping;    /* damping b, kg/s, the dissertation's eps b; a positive b takes energy out */
    vm_real x, v;       /* position, m, and velocity, m/s, at t = 0 */
    vm_osc_force force; /* function for a further small force F, or NULL */
    void *ctx;          /* the user's pointer, last argument of force */
} vm_osc_problem;

/* The motion at one time */
typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;      /* position, m, and velocity, m/s */
    vm_real amplitude; /* amplitude A, m; routes of first order leave out its ripple within a period */
    vm_real error;     /* estimate of the larger of |error of x|/A and |error of v|/vmax, where vmax is the largest
                          velocity at the amplitude A; all causes of errors count */
    int route;         /* the route that was taken, VM_ROUTE_... */
    long evals;        /* evaluations of right-hand sides; 0 where nothing was integrated */
} vm_osc_motion;

/* The numbers of a problem that vm_osc_plan_init computes once. Read them, but do not change them. The plan points to
   the problem's tables, functions and contexts, so its bytes mean nothing to another program. */
typedef struct VM_TAG(vm_osc_plan) {
    vm_osc_problem problem;
    vm_real pi;             /* Pi_alpha, half the period of the Ateb functions ca and sa */
    vm_real gamma;          /* (alpha-1)/(alpha+3) */
    vm_real mean_ca2;       /* the mean of ca^2 over a period */
    vm_real m0, k0;         /* mass, kg, and stiffness, N/m^alpha, at t = 0 */
    vm_real A, psi, Om;     /* amplitude, m, Ateb phase, and rate of this phase, 1/s, at t = 0 */
    vm_real q, h, h_rate;   /* the numbers of vmi_osc_rates at t = 0 */
    vm_real ln_rho;         /* for the second order: (alpha+3)/2 times ln(amplitude/mean amplitude) at t = 0 */
    vm_real shift;          /* for the second order: mean phase minus phase at t = 0 */
    vm_real base;           /* 1/s; for closed forms m0 exp(rate_m u), k0 exp(rate_k u), u = ln(1 + base t)/base */
    vm_real rate_m, rate_k; /* exponents of m and k in these closed forms, 1/s */
    int closed;             /* 1 where m and k have these closed forms, else 0 */
    int has_ateb;           /* 1 where the plan of the Ateb functions, ateb, is ready, else 0 */
    ateb_plan ateb;
} vm_osc_plan;

/* -- What drives the averaged motion -- */

/* The wave that a route uses. The plan must outlive the wave. */
VM_API vmi_osc_wave vmi_osc_wave_of(const vm_osc_plan *p, int route)
{
    if (route == VM_ROUTE_TRIG) return vmi_osc_wave_cos(p->problem.alpha, p->pi);
    if (route == VM_ROUTE_JACOBI) return vmi_osc_wave_cn(p->problem.alpha, p->pi);
    return vmi_osc_wave_ca(p->problem.alpha, p->has_ateb ? &p->ateb : NULL);
}

/* Mass and stiffness at one time, and how fast they and the damping change the motion at that time */
typedef struct VM_TAG(vmi_osc_rates) {
    vm_real m, k;   /* mass, kg, and stiffness, N/m^alpha */
    vm_real q;      /* rate at which m, k and the damping change the motion, 1/s */
    vm_real h;      /* Om (q/Om)', 1/s^2, which is q' - q (k'/k - m'/m - gamma q)/2 */
    vm_real h_rate; /* the terms of h' with m''' and k''', 1/s^3; only tables have these derivatives */
} vmi_osc_rates;

/* Computes the rates at time t. Where they jump at t, side = 1 asks for the rates after t, side = -1 for those before
   t. h and h_rate are set only if with_h is 1; then a law by a user's function is evaluated at two more times. */
VM_API int vmi_osc_rates_at(const vm_osc_plan *p, vm_real t, int side, int with_h, vmi_osc_rates *r)
{
    const vm_osc_problem *o = &p->problem;
    const vm_real step = with_h && p->Om > 0 ? (vm_real)side / (32 * p->Om) : 0;
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS], ln_m, ln_k; /* m, k and their rates; rates of ln m, ln k */
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

/* Computes ln(A/A0) and ln(Om/Om0), the changes of the amplitude and of the phase's rate since t = 0, by the
   adiabatic law from ln(m/m0), ln(k/k0) and the decay, which is the integral of b/m. */
VM_API void vmi_osc_adiabatic(const vm_osc_plan *p, vm_real ln_m, vm_real ln_k, vm_real decay, vm_real *ln_A,
                              vm_real *ln_Om)
{
    const vm_real alpha = p->problem.alpha, r = 2 * p->problem.reactive - 1;
    *ln_A = -(ln_k + r * ln_m + 2 * decay) / (alpha + 3);
    *ln_Om = ((1 - p->gamma) * ln_k - (1 + p->gamma * r) * ln_m) / 2 - p->gamma * decay;
}

/* Integrals along the mean motion, from 0 to the time t */
typedef struct VM_TAG(vmi_osc_integrals) {
    vm_real inverse_mass; /* integral of dt/m, s/kg */
    vm_real phase;        /* integral of Om/Om0 dt, s, where Om0 is Om at t = 0 */
    vm_real drift;        /* integral of q^2 Om0/Om dt, 1/s */
} vmi_osc_integrals;

/* The mean phase to second order: its value at t = 0 plus Om phase + c2 drift/Om, where phase and drift are the
   integrals and Om is the rate at the mean amplitude at t = 0 */
VM_API vm_real vmi_osc_mean_phase(const vm_osc_plan *p, const vmi_osc_integrals *integral)
{
    const vm_real alpha = p->problem.alpha, Om = p->Om * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real c2 = -p->mean_ca2 * (alpha + 1) / (2 * (alpha + 3) * (alpha + 3));
    return p->psi + p->shift + (Om * integral->phase + c2 * integral->drift / Om);
}

/* Computes c = ca(psi) and s = sa(psi), where the phase psi solves psi = mean + slope (ca^2(psi) - mean of ca^2). One
   step of Newton's method from psi = mean leaves an error of the order of slope^3. */
VM_API void vmi_osc_phase_from_mean(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real mean, vm_real slope,
                                    vm_real *c, vm_real *s)
{
    vm_real step;
    vmi_osc_wave_at(w, mean, c, s);
    step = slope * (*c * *c - p->mean_ca2) / (1 + 4 * slope / (w->alpha + 1) * *s * *c);
    vmi_osc_wave_at(w, mean + step, c, s);
}

/* -- Making the plan -- */

/* Finds whether both laws are exponentials in the same variable u (see `base` in vm_osc_plan), so that all integrals
   have closed forms. With damping the integral of b/m must be proportional to u as well, which is so where
   m = m0 (1 + base t). */
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

/* Computes the constants of the second-order solution from the state at t = 0: ln rho, where rho is
   (A/mean A)^((alpha+3)/2), and the mean phase minus the phase. rho depends on Om at the mean amplitude, which in
   turn depends on rho; three iterations find both. */
VM_API int vmi_osc_start(vm_osc_plan *p)
{
    const vm_real n = p->problem.alpha + 1, mean = p->mean_ca2, scale = 1 / p->Om;
    const vmi_osc_wave w = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vmi_osc_rates r;
    /* product is sa ca, excess is ca^2 minus its mean, Om_ratio is Om at the mean amplitude over Om. */
    vm_real ca, sa, product, excess, rho = 1, Om_ratio = 1;
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
        if (!(rho > 0) || !VM_IS_FINITE(rho)) rho = 1; /* the motion is not slow */
        Om_ratio = vmi_pow_checked(rho, -p->gamma);
    }
    p->ln_rho = vmi_log(rho).hi;
    p->shift = -r.q * scale / Om_ratio * n / (2 * (n + 2)) * excess;
    return VM_OK;
}

/* Checks that mass and stiffness are positive between 0 and t, as vmi_law_check does for one law. */
VM_API int vmi_osc_check_laws(const vm_osc_problem *o, vm_real t)
{
    return vmi_first_error(vmi_law_check(&o->mass, VM_BAD_MASS, t),
                           vmi_law_check(&o->stiffness, VM_BAD_STIFFNESS, t));
}

/* Checks the problem's numbers and laws, and writes its mass and stiffness at t = 0. */
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

/* Fills the plan, except for the constants of vmi_osc_start and for the plan of the Ateb functions, which is worth
   its time only where many values are wanted. */
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

/* Plan for many values of one problem's motion. vm_osc_plan_by_route, vm_osc_plan_within and vm_osc_averaged use it.
   The plan copies the problem, whose tables and contexts must outlive it. An error leaves the plan untouched. Returns
   VM_BAD_ARGUMENT for a null pointer or a law that no constructor made, VM_NOT_FINITE for a number that is infinite
   or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS for a law that is not positive at t = 0 or in a table, and VM_DOMAIN for
   alpha < 0, a table out of order or without t = 0, or a user's function that fails. */
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
