/* oscillators/closed.h - the laws of orders two to five as plain numbers, if all integrals have closed forms

   A vm_osc_closed predicts the motion of m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = 0 at any time t. Here m is
   the mass, k the stiffness, b the damping, and `reactive` the share of the reactive force. The prediction needs no
   integrator, no table of a law and no pointer, so a vm_osc_closed may be a constant in the flash of a microcontroller
   (examples/print_plan.c prints it). Mass and stiffness must be
     m = m0 exp(rate_m u),   k = k0 exp(rate_k u),   u = ln(1 + base t)/base, or u = t for base = 0,
   with a common base. So each of them may be constant, linear, exponential, or a power of 1 + base t. With damping,
   either the mass must be linear, or the mass must be constant and the stiffness constant or exponential. The user
   chooses the order, from 2 to 5: a lower order is less accurate (docs/law.md), but needs less code. A program that
   calls vm_osc_closed_at_order2 or vm_osc_closed_at_order3 does not contain the code that only higher orders need.
       vm_osc_problem sieve = {3,            vm_law_linear(120, -20), vm_law_linear(VM_C(4e8), 0), 0, 0,
                               VM_C(0.005), 0,                       NULL,                        NULL};
       vm_osc_closed motion;
       vm_real x, v;
       int status = vm_osc_closed_init(&motion, &sieve, 5, 3); // motion.error is valid up to 3 s
       if (!status) status = vm_osc_closed_at(&motion, 1, &x, &v);

   Method: let p and a be the rates of oscillators/reduction.h at t = 0. Then
     G_0 = p (p - a + base),   delta = p + (p - a + base),   el = 1 + base t,   p(t) = p/el,   A = A(0) exp(-p u),
     W = W(0) exp(delta u)/el,   E_k = (k+1)! E_0(0) (-delta/W(0))^k exp(-(k+2) delta u),
   where A is the mean amplitude, and W is the rate of the mean phase without the terms that E_0 adds to it. The numbers
   G_0 and E_k are those of oscillators/expansion.h. Integrals of W, W E_0 and W E_0^2 over t are differences of
   exponentials. Sources: docs/law.md. Tests: tests/test_closed_law.c. */
#ifndef VARMASS_OSCILLATORS_CLOSED_H
#define VARMASS_OSCILLATORS_CLOSED_H

#include "../ateb/period.h"
#include "../ateb/plans.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "expansion.h"
#include "laws.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"

/* -- The laws -- */

/* The rates base, rate_m and rate_k in the closed forms of mass and stiffness at the top of this file, 1/s */
typedef struct VM_TAG(vmi_osc_rates_of_u) {
    vm_real base, rate_m, rate_k;
} vmi_osc_rates_of_u;

/* Writes the rates of the closed forms of mass and stiffness to *u and returns 1. Returns 0 if mass and stiffness have
   no closed forms with the same u, if a force acts, or if the integral of b/m over time, with the damping b, is not
   proportional to u. For b not 0 this integral is proportional to u only if m = m0 (1 + base t), which includes a
   constant mass with base = 0. */
VM_API int vmi_osc_find_closed_form(const vm_osc_problem *o, vmi_osc_rates_of_u *u)
{
    vm_real base_m, base_k;
    if (!vmi_law_exponential_form(&o->mass, &base_m, &u->rate_m)) return 0;
    if (!vmi_law_exponential_form(&o->stiffness, &base_k, &u->rate_k)) return 0;
    if (o->force) return 0;
    u->base = base_m;
    if (u->rate_m == 0) u->base = base_k;
    if (u->rate_m == 0 && u->rate_k == 0) u->base = 0;
    if (u->rate_m != 0 && u->rate_k != 0 && base_m != base_k) return 0;
    return o->damping == 0 || u->rate_m == u->base;
}

/* The rates on which the disturbances E_k at t = 0 depend, in 1/s: p and delta of the top of this file, and rest = p -
   a + base, so that G_0 = p rest and delta = p + rest */
typedef struct VM_TAG(vmi_osc_closed_rates) {
    vm_real p, rest, delta;
} vmi_osc_closed_rates;

/* Returns the rates p, rest and delta at t = 0, where m0 is the mass, kg. If a difference of rates is 0 in exact
   arithmetic, it is also computed as exactly 0, without rounding errors. An example is the difference base - a for a
   linear mass with the full reactive force. */
VM_API vmi_osc_closed_rates vmi_osc_closed_rates_of(const vm_osc_problem *o, const vmi_osc_rates_of_u *u, vm_real m0)
{
    const vm_real decay = o->damping / m0;
    vmi_osc_closed_rates r;
    r.p = (u->rate_k + (2 * o->reactive - 1) * u->rate_m + 2 * decay) / (o->alpha + 3);
    r.rest = r.p + ((u->base - o->reactive * u->rate_m) - decay);
    r.delta = r.p + r.rest;
    return r;
}

/* Writes the numbers E_0 ... E_(n-1) of oscillators/expansion.h, n <= VMI_OSC_G. For t = 0 the argument W is the rate
   of the mean phase. For another t the argument W is the rate at t = 0 times exp(delta u). */
VM_API void vmi_osc_closed_disturbance(const vmi_osc_closed_rates *r, vm_real W, int n, vm_real *E)
{
    const vm_real step = r->delta / W;
    int k;
    E[0] = r->p / W * (r->rest / W);
    for (k = 1; k < n; k++) E[k] = -(vm_real)(k + 1) * step * E[k - 1];
}

/* -- The mean motion -- */

/* The mean motion at t = 0, and what is needed to compute it at any t */
typedef struct VM_TAG(vmi_osc_closed_mean) {
    vmi_osc_reduced start;      /* mean amplitude, m, mean phase, and its rate W without the terms of E_0, 1/s */
    vm_real base;               /* base of the laws, 1/s; see the top of this file */
    vmi_osc_closed_rates rates; /* the rates p, rest and delta at t = 0 */
    vm_real first, second;      /* what E_0 and E_0^2 add to the rate of the mean phase at t = 0, 1/s */
} vmi_osc_closed_mean;

/* The mean motion at t; u, el and delta are explained at the top of this file. */
typedef struct VM_TAG(vmi_osc_closed_now) {
    vmi_osc_reduced state; /* mean amplitude, m, mean phase, and its rate W without the terms of E_0, 1/s */
    vm_real u, el;         /* u, s, and the pure number el */
    vm_real ln_A;          /* ln(A/A(0)) of the mean amplitude A */
    vm_real ratio;         /* W/W(0) */
    vm_real decay;         /* exp(-delta u) */
    vm_real inverse;       /* the integral of `decay` over u, s */
    vm_real phase;         /* the integral of W/W(0) from 0 to t, s */
    vm_real first;         /* the part of the mean phase that is proportional to E_0 */
} vmi_osc_closed_now;

/* Prepares the mean motion, whose values at t = 0 are *start. */
VM_API void vmi_osc_closed_mean_init(vmi_osc_closed_mean *c, const vmi_osc_reduced *start, vm_real base,
                                     const vmi_osc_closed_rates *rates, const vmi_ripple *r)
{
    vm_real E;
    c->start = *start;
    c->base = base;
    c->rates = *rates;
    c->first = 0;
    c->second = 0;
    if (start->W == 0) return; /* a body at rest at x = 0 */
    vmi_osc_closed_disturbance(rates, start->W, 1, &E);
    c->first = vmi_expansion_first(r) * start->W * E;
    c->second = vmi_expansion_second(r) * start->W * E * E;
}

/* Returns e^x, and writes (e^x - 1)/x to *ratio; for x = 0 this quotient is 1. For x < 709 (float 88) both results are
   within 2 ulp; for a larger x each of them may be infinite or NaN. Method: e^x is 2^k (1 + p) with an integer k and
   |p| < 0.42, so that e^x - 1 is 2^k p + (2^k - 1). */
VM_API vm_real vmi_exp_and_ratio(vm_real x, vm_real *ratio)
{
    const vm_real largest = VM_MANT_DIG > 24 ? 1400 : 180; /* for a larger |x|, e^x is infinite or 0 */
    const vm_real inside = vmi_smaller(vmi_larger(x, -largest), largest);
    vm_real p_lo, p, scale;
    int k;
    p = vmi_exp_core(inside, 0, &k, &p_lo);
    scale = vmi_ldexp(1, k);
    *ratio = 1;
    if (x != 0) *ratio = (scale * p + (scale - 1)) / x;
    return scale + scale * p;
}

/* The mean motion at t, where 1 + base t must be positive. Method: the integral of exp(-3 delta u) over u is the
   integral of exp(-delta u) times (1 + decay + decay^2)/3, with decay = exp(-delta u). */
VM_API void vmi_osc_closed_mean_at(const vmi_osc_closed_mean *c, vm_real t, vmi_osc_closed_now *now)
{
    const vm_real u = t * vmi_log_ratio(c->base * t);
    vm_real decay, inverse, ratio, second;
    decay = 1 / vmi_exp_and_ratio(c->rates.delta * u, &ratio);
    now->phase = u * ratio;
    inverse = now->phase * decay;
    now->u = u;
    now->el = 1 + c->base * t;
    now->decay = decay;
    now->inverse = inverse;
    now->first = c->first * inverse;
    second = c->second * inverse * (1 + decay * (1 + decay)) / 3; /* the part that is proportional to E_0^2 */
    now->ln_A = -c->rates.p * u;
    now->state.A = c->start.A * vmi_exp(now->ln_A, 0);
    now->state.psi = c->start.psi + (c->start.W * now->phase + (now->first + second));
    now->ratio = 1 / (decay * now->el);
    now->state.W = c->start.W * now->ratio;
}

/* Writes the first n numbers E_k at the time of *now. */
VM_API void vmi_osc_closed_disturbance_at(const vmi_osc_closed_mean *c, const vmi_osc_closed_now *now, int n,
                                          vm_real *E)
{
    vmi_osc_closed_disturbance(&c->rates, c->start.W / now->decay, n, E);
}

/* An upper bound of the terms of the mean phase that the law of order five leaves out, from 0 to the time of *now
   (vmi_expansion_third_rate) */
VM_API vm_real vmi_osc_closed_third(const vmi_osc_closed_mean *c, const vmi_osc_closed_now *now, const vmi_ripple *r)
{
    const vm_real q = now->decay, sum = 1 + q * (1 + q * (1 + q * (1 + q))); /* the integral of q^5 over u is sum/5
                                                                                times the integral of q */
    vm_real E[3], e;
    vmi_osc_closed_disturbance(&c->rates, c->start.W, 3, E);
    e = VM_FABS(E[0]);
    return c->start.W * VM_FABS(now->inverse) * sum / 5 * vmi_expansion_third_rate(r, e * VM_FABS(E[2]), e * e * e);
}

/* -- The object -- */

/* The motion of one oscillator as plain data. vm_osc_closed_init fills it. Read its fields, but do not change them. */
typedef struct VM_TAG(vm_osc_closed) {
    int order;                /* order of the law, 2 to 5 */
    int beyond;               /* the status for times with 1 + base t <= 0: VM_BAD_MASS or VM_BAD_STIFFNESS */
    vm_real error;            /* estimate, from t = 0 to t_end of vm_osc_closed_init, of the larger of |error of x|/A
                                 and |error of v|/vmax, where vmax is the largest velocity at the amplitude A; it is
                                 infinite where the error is unknown */
    vmi_osc_closed_mean mean; /* the mean motion */
    ateb_plan ateb;           /* Ateb functions for alpha */
    vmi_ripple ripple;        /* functions of the ripple for alpha; their polynomials are not set for order 2 */
} vm_osc_closed;

/* -- Preparing it -- */

/* What vm_osc_closed_init computes before it writes to its result */
typedef struct VM_TAG(vmi_osc_closed_start) {
    vmi_osc_rates_of_u laws;
    vmi_osc_closed_rates rates;
    vmi_osc_reduced state; /* amplitude, phase and its rate at t = 0 */
    vm_real E[VMI_OSC_G];  /* the numbers E_k of this state */
} vmi_osc_closed_start;

/* Returns 1 if the terms of the law of order five are small at the start, else 0. The terms count as small if
   (alpha+1)(alpha+3)/4 (|E_0| + d^3 |E_3|) < 1/2, where d = (alpha + 1 + pi)/(2 pi) is an upper bound of Pi_alpha/(2
   pi). If they are small, no number overflows. */
VM_API int vmi_osc_closed_is_slow(const vm_real *E, vm_real alpha)
{
    const vm_real d = (alpha + 1 + VM_PI) / (2 * VM_PI), L = (alpha + 1) * (alpha + 3) / 4;
    return L * (VM_FABS(E[0]) + d * d * d * VM_FABS(E[3])) < VM_C(0.5);
}

/* Checks the problem from t = 0 to t_end, and computes the fields of *s. */
VMI_APART int vmi_osc_closed_check(const vm_osc_problem *o, vm_real t_end, vmi_osc_closed_start *s)
{
    vm_real m0 = 0, k0 = 0;
    int status = vmi_osc_check_problem(o, t_end, &m0, &k0);
    if (status) return status;
    if (!vmi_osc_find_closed_form(o, &s->laws)) return VM_NO_LAW;
    s->rates = vmi_osc_closed_rates_of(o, &s->laws, m0);
    s->state = vmi_osc_reduce_by_series(VM_SQRT(k0 / m0), o->alpha, o->x, o->v + s->rates.p * o->x);
    if (!VM_IS_FINITE(s->state.A) || !VM_IS_FINITE(s->state.psi) || !VM_IS_FINITE(s->state.W)) return VM_NOT_FINITE;
    if (s->state.A == 0) return VM_OK;
    vmi_osc_closed_disturbance(&s->rates, s->state.W, VMI_OSC_G, s->E);
    return vmi_osc_closed_is_slow(s->E, o->alpha) ? VM_OK : VM_NO_LAW;
}

/* An estimate of the error of the motion that is valid at all times from 0 to t_end. E contains the numbers E_k of the
   state at t = 0. Each term of the estimate only rises or only falls with t. Therefore the larger of its values at 0
   and at t_end is a bound of this term. */
VM_API vm_real vmi_osc_closed_error(const vm_osc_closed *c, int order, const vm_real *E, vm_real t_end)
{
    const vmi_ripple *r = &c->ripple;
    const vm_real largest_known = VM_C(0.25); /* a larger estimate says nothing about the error */
    const vmi_osc_closed_rates *rates = &c->mean.rates;
    vm_real e0[VMI_OSC_G], e[VMI_OSC_G], turns, error, by_time;
    vmi_osc_closed_now end;
    int k;
    vmi_osc_closed_mean_at(&c->mean, t_end, &end);
    vmi_osc_closed_disturbance_at(&c->mean, &end, VMI_OSC_G, e);
    for (k = 0; k < VMI_OSC_G; k++) {
        e0[k] = VM_FABS(E[k]);
        e[k] = vmi_larger(e0[k], VM_FABS(e[k]));
    }
    if (!(r->scale * e[0] < VM_C(0.5))) return VM_INFINITY;
    turns = VM_FABS(c->mean.start.W * end.phase);
    by_time = VM_FABS(rates->p) + VM_FABS(rates->delta) + VM_FABS(c->mean.base);
    by_time = vmi_osc_time_rounding(t_end, end.state.W, by_time / end.el);
    error = vmi_expansion_error(r, vmi_expansion_left_out_at(r, order, e),
                                vmi_expansion_left_out_at_start(r, order, e0), turns,
                                vmi_osc_closed_third(&c->mean, &end, r)) +
            vmi_larger(by_time, 4 * VM_EPSILON * (2 + turns));
    return error < largest_known ? error : VM_INFINITY;
}

/* Finds the mean motion at t = 0 and the estimate of the error, after all other fields of *c have been set. */
VMI_APART void vmi_osc_closed_begin(vm_osc_closed *c, int order, const vmi_osc_closed_start *s, vm_real t_end)
{
    vmi_osc_reduced mean = s->state;
    vm_real sa, ca;
    c->order = order;
    c->error = 0;
    if (mean.A != 0) {
        ateb_plan_saca(&c->ateb, mean.psi, &sa, &ca);
        mean = vmi_expansion_to_mean(&c->ripple, order, &s->state, sa, ca, s->E);
    }
    vmi_osc_closed_mean_init(&c->mean, &mean, s->laws.base, &s->rates, &c->ripple);
    if (mean.A != 0) c->error = vmi_osc_closed_error(c, order, s->E, t_end);
}

/* Prepares the computation of the problem's motion by the law of the given order, 2 to 5; a higher order is more
   accurate. c->error is valid for times between 0 and t_end. The time t_end, s, may have either sign. Afterwards *c
   does not need the problem any more. After an error *c is unchanged. The errors are
     VM_BAD_ARGUMENT for null pointers, an order outside 2 to 5, and a law that no constructor made,
     VM_NOT_FINITE for a number that is infinite or NaN, and for alpha > 1e30 unless x and v are 0,
     VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive at 0 or t_end,
     VM_DOMAIN for alpha < 0, for a law that has no value at 0 or t_end, and for a table or a change_time that is not
       valid,
     VM_NO_LAW for a mass or stiffness without the closed form at the top of this file, for a problem with a force, and
       where mass, stiffness or damping changes the motion so fast that the law of order five is not valid; in these
       cases use vm_osc_plan_init.
   The call takes as long as some 100 calls of vm_osc_closed_at; with order 2 it takes two thirds to three quarters of
   this time. */
VM_API int vm_osc_closed_init(vm_osc_closed *c, const vm_osc_problem *problem, int order, vm_real t_end)
{
    vmi_osc_closed_start s;
    int status;
    if (!c || !problem || order < 2 || order > 5) return VM_BAD_ARGUMENT;
    if (VM_IS_FINITE(t_end)) status = vmi_osc_closed_check(problem, t_end, &s);
    else status = vmi_first_error(VM_NOT_FINITE, vmi_osc_closed_check(problem, 0, &s));
    if (status) return status;
    c->beyond = s.laws.rate_m != 0 ? VM_BAD_MASS : VM_BAD_STIFFNESS;
    ateb_plan_init(&c->ateb, problem->alpha);
    vmi_ripple_init(&c->ripple, problem->alpha, vmi_ateb_fine_constants);
    if (order > 2) vmi_ripple_complete(&c->ripple, order);
    vmi_osc_closed_begin(c, order, &s, t_end);
    return VM_OK;
}

/* -- Using it -- */

/* Checks the arguments of a call that computes the motion at t by the law of this order. */
VM_API int vmi_osc_closed_check_call(const vm_osc_closed *c, int order, vm_real t, const vm_real *x, const vm_real *v)
{
    if (!c || !x || !v || order > c->order) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!(1 + c->mean.base * t > 0)) return c->beyond;
    return VM_OK;
}

/* Writes the motion at t by the law of the given order, which must not be higher than the order of *c. */
VM_API int vmi_osc_closed_motion(const vm_osc_closed *c, int order, vm_real t, vm_real *x, vm_real *v)
{
    const vmi_osc_closed_mean *mean;
    vmi_osc_closed_now now;
    vm_real E[VMI_EXPANSION_E] = {0, 0, 0, 0}, sa, ca, result[2] = {0, 0}; /* E_3 is not needed here */
    int status = vmi_osc_closed_check_call(c, order, t, x, v);
    if (status) return status;
    mean = &c->mean;
    if (mean->start.A != 0) {
        vmi_osc_closed_mean_at(mean, t, &now);
        ateb_plan_saca(&c->ateb, now.state.psi, &sa, &ca);
        if (order > 2) {
            vmi_osc_closed_disturbance_at(mean, &now, 3, E);
            now.state = vmi_expansion_from_mean(&c->ripple, order, &now.state, sa, ca, E);
            ateb_plan_saca(&c->ateb, now.state.psi, &sa, &ca);
        }
        vmi_osc_unreduce(&now.state, mean->rates.p / now.el, c->ripple.alpha, sa, ca, &result[0], &result[1]);
    }
    if (!VM_IS_FINITE(result[0]) || !VM_IS_FINITE(result[1])) return VM_NOT_FINITE;
    *x = result[0];
    *v = result[1];
    return VM_OK;
}

/* Position x (m) and velocity v (m/s) at time t (s, either sign), by the law of the order c->order. c->error estimates
   the error up to the time t_end that vm_osc_closed_init received. Returns VM_BAD_ARGUMENT for null pointers;
   VM_NOT_FINITE where t or a result is infinite or NaN; VM_BAD_MASS or VM_BAD_STIFFNESS where mass or stiffness is not
   positive at t; VM_OK otherwise. An error leaves *x and *v untouched. If *c has order 5, x and v are bit for bit those
   of vm_osc_plan_by_route with VM_ROUTE_ORDER5. */
VM_API int vm_osc_closed_at(const vm_osc_closed *c, vm_real t, vm_real *x, vm_real *v)
{
    int order = 0;
    if (c) order = c->order;
    return vmi_osc_closed_motion(c, order, t, x, v);
}

/* Position and velocity as by vm_osc_closed_at, but always by order 2, whatever order *c has. This function adds less
   code to a program than vm_osc_closed_at and vm_osc_closed_at_order3, since order 2 needs no ripple. */
VM_API int vm_osc_closed_at_order2(const vm_osc_closed *c, vm_real t, vm_real *x, vm_real *v)
{
    return vmi_osc_closed_motion(c, 2, t, x, v);
}

/* Position and velocity as by vm_osc_closed_at, but always by order 3; returns VM_BAD_ARGUMENT if *c has order 2.
   It adds less code to a program than vm_osc_closed_at. */
VM_API int vm_osc_closed_at_order3(const vm_osc_closed *c, vm_real t, vm_real *x, vm_real *v)
{
    return vmi_osc_closed_motion(c, 3, t, x, v);
}

#endif
