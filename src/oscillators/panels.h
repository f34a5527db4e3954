/* oscillators/panels.h - intervals of time on which laws f(t) and g(t) are smooth, and the integrals of 1/f and f/g

   An integral along a law f(t) from 0 to t is a sum over intervals of time, called panels. Each panel is so short that
   a series of 20 Legendre polynomials represents the law on it. A panel that is too long for such a series is halved.
   After each panel, the code first tries a next panel of twice the length. Panels end at the points of a table.
       vm_law mass = vm_law_linear(10, VM_C(-0.1));
       vm_real integral;
       int status = vm_law_inverse_integral(&mass, 20, &integral); // 10 ln(10/8) s/kg
   Tests: tests/test_laws.c. */
#ifndef VARMASS_OSCILLATORS_PANELS_H
#define VARMASS_OSCILLATORS_PANELS_H

#include "../base/real.h"
#include "../base/status.h"
#include "laws.h"
#include "legendre.h"

/* -- The lengths of panels -- */

/* The panels from the time t to the time `end`, one after the other. The loop over them is
     while (vmi_panels_next(&p)) {
         ... compute the series on the panel from p.t to p.t + p.side * p.step ...
         if (too long && vmi_panels_halve(&p)) continue;
         ... use the panel ...
         vmi_panels_advance(&p);
     } */
typedef struct VM_TAG(vmi_panels) {
    vm_real t, end;         /* start of the present panel, and end of the final panel, s */
    vm_real side;           /* 1 forward, -1 backward in time */
    vm_real longest, least; /* largest and smallest length that a panel may have, s */
    vm_real size;           /* intended length of the present panel, s */
    vm_real left, step;     /* time left to the end, and length of the present panel, which is at most `left`, s */
    int halved;             /* how many times a panel has been halved so far */
} vmi_panels;

/* Returns the panels from start to end, each at most `longest` long. `whole` is the length of the whole interval of
   integration, s; the interval from start to end may be a part of it. */
VM_API vmi_panels vmi_panels_from(vm_real start, vm_real end, vm_real longest, vm_real whole)
{
    vmi_panels p;
    p.t = start;
    p.end = end;
    p.side = VM_COPYSIGN(1, end - start);
    p.longest = vmi_smaller(longest, VM_FABS(end - start));
    p.least = whole / VM_C(1099511627776.); /* 2^40; the error of a panel shorter than whole/2^40 does not matter */
    p.size = p.longest;
    p.left = 0;
    p.step = 0;
    p.halved = 0;
    return p;
}

/* Returns 0 if the end is reached. Otherwise it returns 1 and sets p->step, the length of the panel that starts at
   p->t. If the time that is left is at most 1.0001 times the intended length of a panel, all of this time becomes one
   panel. */
VM_API int vmi_panels_next(vmi_panels *p)
{
    if (p->t == p->end) return 0;
    p->left = VM_FABS(p->end - p->t);
    p->step = p->size;
    if (p->left <= p->size * VM_C(1.0001)) p->step = p->left;
    return 1;
}

/* Halves the intended length of the present panel. Returns 1 if that was possible, else 0. */
VM_API int vmi_panels_halve(vmi_panels *p)
{
    const int most = 4096; /* a bound on the number of halvings; it ends the search for laws with noise, for which no
                              panel is short enough */
    if (!(p->step > p->least) || p->halved >= most || p->t + p->side * (p->step / 2) == p->t) return 0;
    p->size = p->step / 2;
    p->halved++;
    return 1;
}

/* Goes on to the next panel. Its intended length becomes twice the length of the present panel, but at most
   p->longest. */
VM_API void vmi_panels_advance(vmi_panels *p)
{
    if (p->step == p->left) p->t = p->end;
    else p->t += p->side * p->step;
    p->size = vmi_smaller(2 * p->step, p->longest);
}

/* -- Whether a series is good enough -- */

/* Returns the limit below which the last terms of a Legendre series, divided by the mean of the function, do not
   matter. Gauss' rule is exact for polynomials with twice as many terms as the series, so that the error of the
   integral is about the square of the last terms. The limit is larger for a panel that is only a small part of the
   whole integral. */
VM_API vm_real vmi_panel_limit(vm_real length, vm_real whole)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(1e-5);
    const vm_real matters = VM_EPSILON / 4 * whole / VM_FABS(length);
    return vmi_larger(enough, matters);
}

/* Returns 1 if the last terms of a Legendre series are at most `limit` times the mean of the function, else 0. */
VM_API int vmi_panel_is_resolved(const vm_real *series, vm_real limit)
{
    return vmi_legendre_tail(series) <= limit * series[0];
}

/* Returns a limit for terms of the number E_0 = G_0/W^2 on a panel over which the phase grows by `phase`, of either
   sign: terms below this limit do not matter. E_0 measures how strongly slow changes disturb the motion; W is the rate
   of the phase (oscillators/expansion.h). The limit has two parts. Terms as large as the first part change the phase by
   16 eps. The second part is the size of the rounding errors of E_0. These errors come from the derivative p' in E_0,
   which the code finds from differences of the rate p on the panel. */
VM_API vm_real vmi_panel_E_noise(vm_real phase)
{
    const vm_real advance = VM_FABS(phase);
    return 16 * VM_EPSILON * (1 + 1 / advance) / advance;
}

/* The largest relative difference that is allowed between a law and its series at the ends of a panel. It is larger
   than `limit`, because at the ends all terms that the series leaves out add up. */
VM_API vm_real vmi_panel_edge_limit(vm_real limit) { return 16 * limit; }

/* Raises *edge to the relative difference between f and the value that a series gives for f, if this difference is
   larger than *edge. by_series is the value of the series, which is a series of 1/f if `reciprocal` is 1, and of f if
   `reciprocal` is 0. */
VM_API void vmi_panel_raise_edge(int reciprocal, vm_real f, vm_real by_series, vm_real *edge)
{
    const vm_real ratio = by_series * (reciprocal ? f : 1 / f), miss = VM_FABS(ratio - 1);
    if (!(miss <= *edge)) *edge = miss;
}

/* Raises *edge to the relative difference between a law f and its series at the start or the end of the panel,
   whichever is larger, if this difference is larger than *edge. If `reciprocal` is 1, the series is one of 1/f. Only
   this test notices a kink of the law between an end of the panel and the nearest point of Gauss' rule. */
VM_API int vmi_panel_edge(const vm_law *law, int if_not_positive, int reciprocal, vm_real start, vm_real length,
                          const vm_real *series, vm_real *edge)
{
    const int side = vmi_time_side(length);
    vm_real at_start = 0, at_end = 0, f[VMI_LAW_ORDERS];
    int k, status;
    for (k = 0; k < VMI_GAUSS; k += 2) { /* Legendre's P_k(1) is 1, P_k(-1) is (-1)^k */
        at_start = at_start + series[k] - series[k + 1];
        at_end = at_end + series[k] + series[k + 1];
    }
    status = vmi_law_derivatives(law, if_not_positive, start, side, 0, f);
    if (status) return status;
    vmi_panel_raise_edge(reciprocal, f[0], at_start, edge);
    status = vmi_law_derivatives(law, if_not_positive, start + length, -side, 0, f);
    if (status) return status;
    vmi_panel_raise_edge(reciprocal, f[0], at_end, edge);
    return VM_OK;
}

/* -- The integral of 1/f -- */

/* Computes the series of 1/f on a panel. Sets *edge to the largest relative difference between this series and 1/f at
   the ends of the panel. */
VM_API int vmi_law_inverse_series(const vm_law *law, vm_real start, vm_real length, vm_real *series, vm_real *edge)
{
    const int side = vmi_time_side(length);
    vm_real values[VMI_GAUSS], same[VMI_GAUSS], f[VMI_LAW_ORDERS];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        status = vmi_law_derivatives(law, VM_BAD_MASS, t, side, 0, f);
        if (status) return status;
        values[i] = 1 / f[0];
    }
    vmi_legendre_fit(values, values, series, same);
    *edge = 0;
    return vmi_panel_edge(law, VM_BAD_MASS, 1, start, length, series, edge);
}

/* Adds the integral of dt/f from start to end to *sum; a table must have no point between these times. `whole` is the
   length of the whole interval of integration, s. */
VM_API int vmi_law_add_inverse_integral(const vm_law *law, vm_real start, vm_real end, vm_real whole, vm_real *sum)
{
    vmi_panels p = vmi_panels_from(start, end, vmi_law_longest_panel(law, whole), whole);
    while (vmi_panels_next(&p)) {
        const vm_real length = p.side * p.step, limit = vmi_panel_limit(length, whole);
        vm_real series[VMI_GAUSS], edge;
        int status = vmi_law_inverse_series(law, p.t, length, series, &edge);
        if (status) return status;
        if (!(edge <= vmi_panel_edge_limit(limit)) || !vmi_panel_is_resolved(series, limit))
            if (vmi_panels_halve(&p)) continue;
        *sum += length * series[0];
        vmi_panels_advance(&p);
    }
    return VM_OK;
}

/* Writes the integral of dt/f from 0 to t. The integral is a sum over panels, from one point of a table to the next. */
VM_API int vmi_law_inverse_integral_by_panels(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real at = 0;
    int status = VM_OK;
    *integral = 0;
    while (!status && at != t) {
        const vm_real next = vmi_law_next_knot(law, at, t);
        status = vmi_law_add_inverse_integral(law, at, next, VM_FABS(t), integral);
        at = next;
    }
    return status;
}

/* Integral of ds/f(s) from 0 to t, s per unit of f, for t of either sign. If the integral of a law has a closed form,
   the function uses it; the closed form loses no digits where it tends to 0/0. For tables and users' functions it uses
   Gauss' rule; for users' functions the relative error is at most 1e-13 (float 1e-5) if f changes no faster than
   vm_law_user says. Returns VM_BAD_ARGUMENT for null pointers and for a law that no constructor made, VM_NOT_FINITE for
   numbers that are infinite or NaN, VM_BAD_MASS where f <= 0 anywhere between 0 and t, and VM_DOMAIN for t outside a
   table, for a table whose times do not rise, where the user's function fails, and where the law's field change_time is
   negative, or positive but less than |t|/2^20. An error leaves *integral untouched. */
VM_API int vm_law_inverse_integral(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real sum;
    int status;
    if (!law || !law->derivatives || !integral) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_check(law, VM_BAD_MASS, t);
    if (status) return status;
    if (law->inverse_integral) sum = law->inverse_integral(law, t);
    else status = vmi_law_inverse_integral_by_panels(law, t, &sum);
    if (status) return status;
    return vmi_copy_if_finite(1, &sum, integral);
}

/* -- The integral of any function of time -- */

/* A function of time that is integrated, the integrand. It writes its value at t to *value, and returns VM_OK or the
   status with which it fails. Where the value jumps at t, side = 1 means the value after t, and side = -1 the value
   before t. */
typedef int (*vmi_integrand)(vm_real t, int side, vm_real *value, void *ctx);

/* Computes the series of a function on a panel. Writes to *size the largest absolute value of the function at the
   points of Gauss' rule and at the ends of the panel, and to *edge the largest difference between series and function
   at the ends. */
VM_API int vmi_integrand_series(vmi_integrand f, void *ctx, vm_real start, vm_real length, vm_real *series,
                                vm_real *size, vm_real *edge)
{
    const int side = vmi_time_side(length);
    vm_real values[VMI_GAUSS + 2], same[VMI_GAUSS];
    int i, status;
    *size = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        status = f(start + length * ((1 + vmi_gauss_node(i)) / 2), side, &values[i], ctx);
        if (status) return status;
    }
    status = f(start, side, &values[VMI_GAUSS], ctx);
    if (!status) status = f(start + length, -side, &values[VMI_GAUSS + 1], ctx);
    if (status) return status;
    for (i = 0; i < VMI_GAUSS + 2; i++) *size = vmi_larger(VM_FABS(values[i]), *size);
    vmi_legendre_fit(values, values, series, same);
    *edge = vmi_larger(VM_FABS(vmi_legendre_at(series, -1) - values[VMI_GAUSS]),
                       VM_FABS(vmi_legendre_at(series, 1) - values[VMI_GAUSS + 1]));
    return VM_OK;
}

/* Adds the integral of a function from start to end to *sum. The function must be smooth between these times. No panel
   is longer than `longest`. `whole` is the length of the whole interval of integration, s. */
VM_API int vmi_add_integral(vmi_integrand f, void *ctx, vm_real start, vm_real end, vm_real longest, vm_real whole,
                            vm_real *sum)
{
    vmi_panels p = vmi_panels_from(start, end, longest, whole);
    while (vmi_panels_next(&p)) {
        const vm_real length = p.side * p.step, limit = vmi_panel_limit(length, whole);
        vm_real series[VMI_GAUSS], size, edge;
        const int status = vmi_integrand_series(f, ctx, p.t, length, series, &size, &edge);
        if (status) return status;
        if (!(edge <= vmi_panel_edge_limit(limit) * size) || !(vmi_legendre_tail(series) <= limit * size))
            if (vmi_panels_halve(&p)) continue;
        *sum += length * series[0];
        vmi_panels_advance(&p);
    }
    return VM_OK;
}

/* -- The integral of f/g -- */

/* Two laws f and g, whose quotient f/g is integrated */
typedef struct VM_TAG(vmi_law_ratio) {
    const vm_law *f, *g;
} vmi_law_ratio;

/* Writes the value of f/g at t, where f may have any sign and g must be positive. The function is a vmi_integrand;
   `ratio` points to a vmi_law_ratio. */
VM_API int vmi_law_ratio_at(vm_real t, int side, vm_real *value, void *ratio)
{
    const vmi_law_ratio *r = (const vmi_law_ratio *)ratio;
    vm_real up[VMI_LAW_ORDERS], down[VMI_LAW_ORDERS];
    int status = vmi_law_derivatives(r->f, VM_OK, t, side, 0, up);
    if (!status) status = vmi_law_derivatives(r->g, VM_BAD_MASS, t, side, 0, down);
    if (!status) *value = up[0] / down[0];
    return status;
}

/* Writes the integral of f/g dt from 0 to t. The integral is a sum over panels, from one point of a table to the
   next. */
VM_API int vmi_law_ratio_integral_by_panels(const vm_law *f, const vm_law *g, vm_real t, vm_real *integral)
{
    const vm_real whole = VM_FABS(t);
    const vm_real longest = vmi_smaller(vmi_law_longest_panel(f, whole), vmi_law_longest_panel(g, whole));
    vmi_law_ratio ratio;
    vm_real at = 0;
    int status = VM_OK;
    ratio.f = f;
    ratio.g = g;
    *integral = 0;
    while (!status && at != t) {
        const vm_real next = vmi_law_next_knot(g, at, vmi_law_next_knot(f, at, t));
        status = vmi_add_integral(vmi_law_ratio_at, &ratio, at, next, longest, whole, integral);
        at = next;
    }
    return status;
}

/* Computes the integral of f/g dt from 0 to t in closed form. Returns 1 if there is a closed form whose value is
   finite, else 0. There is a closed form if f is constant and the integral of 1/g has one, or if f and g have
   exponential forms with the same base (see vmi_law_exponential_form). Its value may be NaN where f changes its
   sign. */
VM_API int vmi_law_ratio_integral_closed(const vm_law *f, const vm_law *g, vm_real t, vm_real *integral)
{
    vm_real base, rate, base_g, rate_g, u;
    if (!(f->f0 != 0) || !vmi_law_exponential_form(f, &base, &rate)) return 0;
    if (rate == 0 && g->inverse_integral) {
        *integral = f->f0 * g->inverse_integral(g, t);
        return VM_IS_FINITE(*integral);
    }
    if (!vmi_law_exponential_form(g, &base_g, &rate_g)) return 0;
    if (base != base_g && rate_g != 0) return 0;
    u = t * vmi_log_ratio(base * t);
    *integral = f->f0 / g->f0 * u * vmi_exp_ratio((base + rate - rate_g) * u);
    return VM_IS_FINITE(*integral);
}

/* Integral of f(s)/g(s) ds from 0 to t, for t of either sign, f of any sign and g > 0.
   With the damping b(t) for f and the mass m(t) for g, the integral is the argument `decay` of vm_osc_amplitude_law.
   The function uses a closed form where f is constant and the integral of 1/g has a closed form, where f and g are
   powers of the same 1 + c t, and where both are exponential. For all other laws f and g it uses Gauss' rule on panels:
   the error is at most 1e-13 (float 1e-5) of the integral of |f/g|, if users' functions change no faster than
   vm_law_user says. Returns VM_BAD_ARGUMENT for null pointers and for a law that no constructor made, VM_NOT_FINITE for
   numbers that are infinite or NaN, VM_BAD_MASS where g <= 0 between 0 and t, and VM_DOMAIN for t outside a table, for
   a table whose times do not rise, where a user's function fails, and where a law's field change_time is negative, or
   positive but less than |t|/2^20. An error leaves *integral untouched. */
VM_API int vm_law_ratio_integral(const vm_law *f, const vm_law *g, vm_real t, vm_real *integral)
{
    vm_real sum = 0;
    int status;
    if (!f || !g || !f->derivatives || !g->derivatives || !integral) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_first_error(vmi_law_check(f, VM_OK, t), vmi_law_check(g, VM_BAD_MASS, t));
    if (status) return status;
    if (!vmi_law_ratio_integral_closed(f, g, t, &sum)) status = vmi_law_ratio_integral_by_panels(f, g, t, &sum);
    if (status) return status;
    return vmi_copy_if_finite(1, &sum, integral);
}

#endif
