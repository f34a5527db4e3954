/* oscillators/problem.h - an oscillator with slowly varying mass, and its plan */
#ifndef VARMASS_OSCILLATORS_PROBLEM_H
#define VARMASS_OSCILLATORS_PROBLEM_H

#include "../ateb/period.h"
#include "../ateb/plans.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "laws.h"
#include "waves.h"

/* The problem. F, where there is one, is a further small force, N, of time, place and velocity. */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);

typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;          /* >= 0 */
    vm_law mass, stiffness; /* kg; N/m^alpha */
    vm_real reactive;       /* r: 1 with reactive force, 0 without (a leak) */
    vm_real damping;        /* b, kg/s (the dissertation's eps b); negative ones drive */
    vm_real x, v;           /* at t = 0, m and m/s */
    vm_osc_force force;     /* F or null */
    void *ctx;
} vm_osc_problem;

typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;
    vm_real amplitude; /* A, of the motion without the ripple of a period for the first four routes */
    vm_real error;     /* estimate of the largest of |error of x|/A and |error of v|/vmax(A), of whatever origin */
    int route;
    long evals; /* of right-hand sides */
} vm_osc_motion;

/* What a problem has to have computed but once. Not for changing: it points to the problem's tables and contexts. */
typedef struct VM_TAG(vm_osc_plan) {
    vm_osc_problem problem;
    vm_real pi, gamma, mean_ca2; /* Pi_alpha, (alpha-1)/(alpha+3), the mean of ca^2 */
    vm_real m0, k0;
    vm_real A, psi, Om;                  /* amplitude, Ateb phase and its rate at t = 0 */
    vm_real q, h, h_rate, ln_rho, shift; /* of the second-order law at t = 0; mean phase minus psi */
    vm_real base, rate_m, rate_k; /* closed forms: m = m0 exp(rate_m u), k likewise, u = ln(1 + base t)/base */
    int closed, has_ateb;
    ateb_plan ateb;
} vm_osc_plan;

/* The state of things at t: m, k, q, h of the second-order law, and the part of h' that tables make large */
typedef struct VM_TAG(vmi_osc_rates) {
    vm_real m, k, q, h, h_rate;
} vmi_osc_rates;

VM_API int vmi_osc_rates_at(const vm_osc_plan *p, vm_real t, int side, int with_h, vmi_osc_rates *r)
{
    const vm_osc_problem *o = &p->problem;
    const vm_real step = with_h && p->Om > 0 ? (vm_real)side / (32 * p->Om) : 0;
    vm_real m[4], k[4], ln_m, ln_k;
    int status = vmi_law_derivatives(&o->mass, t, side, step, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, t, side, step, k);
    if (status) return status;
    r->m = m[0];
    r->k = k[0];
    ln_m = m[1] / m[0];
    ln_k = k[1] / k[0];
    r->q = ln_k + (2 * o->reactive - 1) * ln_m + 2 * o->damping / m[0];
    r->h = (k[2] / k[0] - ln_k * ln_k) + (2 * o->reactive - 1) * (m[2] / m[0] - ln_m * ln_m) -
           2 * o->damping * ln_m / m[0];
    r->h -= r->q * (ln_k - ln_m - p->gamma * r->q) / 2;
    r->h_rate = k[3] / k[0] + (2 * o->reactive - 1) * m[3] / m[0];
    return VM_OK;
}

/* ln of A/A0 and of Om/Om0 by the adiabatic law, where k, m and int b/m dt have come to these */
VM_API void vmi_osc_adiabatic(const vm_osc_plan *p, vm_real ln_m, vm_real ln_k, vm_real damping, vm_real *ln_A,
                              vm_real *ln_Om)
{
    const vm_real alpha = p->problem.alpha, r = 2 * p->problem.reactive - 1;
    *ln_A = -(ln_k + r * ln_m + 2 * damping) / (alpha + 3);
    *ln_Om = ((1 - p->gamma) * ln_k - (1 + p->gamma * r) * ln_m) / 2 - p->gamma * damping;
}

/* The mean phase at the integrals y: Om0 y1 + c2 y2/Om0, Om0 at the mean amplitude */
VM_API vm_real vmi_osc_mean_phase(const vm_osc_plan *p, const vm_real *y)
{
    const vm_real alpha = p->problem.alpha, Om = p->Om * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real c2 = -p->mean_ca2 * (alpha + 1) / (2 * (alpha + 3) * (alpha + 3));
    return p->psi + p->shift + (Om * y[1] + c2 * y[2] / Om);
}

/* psi from the mean phase, psi = mean + slope (ca^2(psi) - <ca^2>): one step of Newton's method, error O(slope^3) */
VM_API void vmi_osc_phase_from_mean(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real mean, vm_real slope,
                                    vm_real *c, vm_real *s)
{
    vm_real step;
    vmi_osc_wave_at(w, mean, c, s);
    step = slope * (*c * *c - p->mean_ca2) / (1 + 4 * slope / (w->alpha + 1) * *s * *c);
    vmi_osc_wave_at(w, mean + step, c, s);
}

/* Are both laws exp(rate u) in one u, and so all integrals closed? With damping int b/m dt must go with u, too:
   where m = m0 (1 + base t), or nothing changes but by damping. */
VM_API void vmi_osc_find_base(vm_osc_plan *p)
{
    const vm_osc_problem *o = &p->problem;
    vm_real base_m, base_k;
    p->closed = vmi_law_base(&o->mass, &base_m, &p->rate_m) && vmi_law_base(&o->stiffness, &base_k, &p->rate_k) &&
                !o->force;
    if (!p->closed) return;
    p->base = p->rate_m == 0 ? base_k : base_m;
    if (p->rate_m == 0 && p->rate_k == 0) p->base = 0;
    if (p->rate_m != 0 && p->rate_k != 0 && base_m != base_k) p->closed = 0;
    if (o->damping != 0 && p->rate_m != p->base) p->closed = 0;
}

/* Constants of the second-order law from the start: ln rho, and the mean phase minus the phase */
VM_API int vmi_osc_start(vm_osc_plan *p)
{
    const vm_real n = p->problem.alpha + 1, M = p->mean_ca2, scale = 1 / p->Om;
    const vmi_osc_wave w = vmi_osc_wave_of(VM_ROUTE_ATEB, n - 1, p->pi, p->has_ateb ? &p->ateb : NULL);
    vmi_osc_rates r;
    vm_real ca, sa, g, c, e, Om_ratio, rho = 1;
    int i, status = vmi_osc_rates_at(p, 0, 1, 1, &r);
    if (status) return status;
    p->q = r.q;
    p->h = r.h;
    p->h_rate = r.h_rate;
    p->ln_rho = p->shift = 0;
    if (p->A == 0 || (r.q == 0 && r.h == 0)) return VM_OK;
    vmi_osc_wave_at(&w, p->psi, &ca, &sa);
    g = sa * ca;
    c = ca * ca - M;
    Om_ratio = 1;
    for (i = 0; i < 3; i++) { /* Om at the mean amplitude, A0 rho^(-2/(alpha+3)) */
        e = scale / Om_ratio;
        rho = 1 + r.q * e / 2 * g +
              (r.q * e * r.q * e * (2 - p->gamma) * (g * g - M * n / (n + 6)) + n * c * r.h * e * e) / 8;
        if (!(rho > 0) || !VM_IS_FINITE(rho)) rho = 1; /* far from slow */
        Om_ratio = vmi_pow_checked(rho, -p->gamma);
    }
    p->ln_rho = vmi_log(rho).hi;
    p->shift = -r.q * scale / Om_ratio * n / (2 * (n + 2)) * c;
    return VM_OK;
}

/* All but the Ateb plan, which only pays where many values are wanted */
VM_API int vmi_osc_prepare(vm_osc_plan *p, const vm_osc_problem *problem)
{
    const vm_osc_problem *o = &p->problem;
    vm_real f[4], omega;
    int status;
    p->problem = *problem;
    p->has_ateb = 0;
    if (!(o->alpha >= 0) || !VM_IS_FINITE(o->alpha)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(o->x) || !VM_IS_FINITE(o->v) || !VM_IS_FINITE(o->reactive) || !VM_IS_FINITE(o->damping))
        return VM_NOT_FINITE;
    status = vmi_law_check(&o->mass, 0);
    if (!status) status = vmi_law_check(&o->stiffness, 0);
    if (status) return status;
    vmi_law_derivatives(&o->mass, 0, 1, 0, f);
    p->m0 = f[0];
    vmi_law_derivatives(&o->stiffness, 0, 1, 0, f);
    p->k0 = f[0];
    omega = VM_SQRT(p->k0 / p->m0);
    p->pi = ateb_pi(o->alpha);
    p->gamma = (o->alpha - 1) / (o->alpha + 3);
    p->mean_ca2 = vmi_osc_mean_ca2(o->alpha, p->pi);
    vm_osc_amplitude_phase(o->x, o->v, omega, o->alpha, &p->A, &p->psi);
    p->Om = p->A == 0 ? 0 : vmi_osc_rate(p->A, omega, o->alpha);
    if (!VM_IS_FINITE(p->A) || !VM_IS_FINITE(p->psi) || !VM_IS_FINITE(p->Om)) return VM_NOT_FINITE;
    vmi_osc_find_base(p);
    return VM_OK;
}

/* x(t), x'(t) at any t of either sign, by the route that is asked for, or by the cheapest whose error is estimated
   to be within the tolerance. Like error that is relative: for x within d metres ask for d/A. The laws cost one or
   two sa, ca and the integrals of the mass law, and disregard the tolerance. The integrators work to it (0 means
   1e-6, float 1e-3): each runs twice, the second time stricter, and error comes from what the two differ by; by the
   default tolerance that takes 400 (variation), 700 (rk87), 2200 (rk45) evaluations a period, alpha = 3. With F the
   averaged equations are integrated instead of closed forms, to the tolerance. Then error estimates the whole
   error: that of their integration, of averaging, and of cos and cn in place of the Ateb functions. Averaging
   leaves out the ripple within a period, its effect on phase and amplitude at the start, its square, and a force
   that changes within a period, as in a resonance. For this estimate F is called over a period at the start and at
   eight later times: a force that acts only for a short time between these is not seen. There is
   no second-order law with F, and vm_osc_within takes the variation of constants. So it
   does where no law is within the tolerance, but where alpha is odd: there rk87 is two to four times as fast.
   The error estimates of the first- and second-order laws include the fastest changes of mass and stiffness between
   0 and t: mass and stiffness are examined panel by panel (for functions see vm_law), tables from point to point. A
   change within a period makes the estimate large. vm_osc_within then integrates, in steps of at most a quarter of the
   shortest panel. Over random problems (alpha in [0, 8], q of 3e-3 to 0.1, to t = 3/q; tests/test_routes.c), of
   which some change only in a part of the run or have tables with a step, the true error is below 3 times error in
   99 % of the cases, and above 10 times (vm_osc_within: at most 10.3) in 1 of 1000; of 282 runs by the variation of
   constants one erred by 37 times error, at alpha = 1.5. In the median, error is 3 to 4 (first order), 7 (second
   order), 5 to 20 (integrators) and, with F, 5 to 10 (averaged) times the true error. With rk87 the true error is above 3 times error in 2 % of the cases, up to 20 times: if alpha is not an odd integer, its errors are
   not proportional to the tolerance. Above alpha = 8 the error of the laws of first order is estimated too large.
   VM_TOLERANCE_MISSED: x and v are computed, but error is larger than the tolerance (integrators only; with F
   only the error of integrating the averaged equations counts). Errors leave *motion
   untouched: VM_BAD_MASS (a mass or stiffness that is not positive between 0 and t), VM_BAD_ARGUMENT (alpha < 0, a
   negative tolerance, null pointers, t outside a table, a table out of order), VM_NOT_FINITE, VM_NO_LAW (second-order
   law with F; F on a body at rest at x = 0), VM_NOT_INTEGRATED (an integrator gave up, or would need 2^13 steps a
   period, four times what its longest step asks for, or 2^23 of the present periods: every call ends). */
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

/* The motion at the times of vmi_osc_check_time(t, .), by integration with one tolerance */
enum { VMI_OSC_CHECKS = 8 };

VM_API vm_real vmi_osc_check_time(vm_real t, int i)
{
    return i == VMI_OSC_CHECKS - 1 ? t : t * (vm_real)(4 + i) / (vm_real)(3 + VMI_OSC_CHECKS);
}

#endif
