/* oscillators/collocation.h - integration of an oscillator from each zero of x to the next, to a tolerance

   The exact equations of oscillators/reduction.h for the amplitude A and the phase psi, with a further force F, are
     (ln A)' = -p + W E sa ca - 2/(alpha+1) f sa,   psi' = W (1 + (alpha+1)/2 E ca^2) - f ca,
     with E = (p^2 - a p - p')/W^2,   f = F/(m V),   V = 2 A W/(alpha+1); p, a and W are explained there.
   They are solved with psi as the independent variable: each step integrates ln A and t from one zero of x to the next.
   At x = 0 the force of the spring is not smooth for most alpha, but since steps end there, no order is lost.

   A step uses Gauss' collocation of n points. Its equations are solved by iteration, which starts from values that are
   extrapolated from the steps before. p' is the derivative of the polynomial through the values of p at the n points;
   therefore the laws have to give only their values and rates. Two runs with different n go side by side; their
   difference gives the error.
       vm_osc_motion motion;
       int status = vmi_osc_collocate(&plan, VM_ROUTE_COLLOCATION, 300, VM_C(1e-8), &motion); // plan is a vm_osc_plan
   Source: Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1.2 and VIII.6.
   Tests: tests/test_collocation.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_COLLOCATION_H
#define VARMASS_OSCILLATORS_COLLOCATION_H

#include "../ateb/plans.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "averaging.h"
#include "gauss_rule.h"
#include "integration.h"
#include "laws.h"
#include "legendre.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "waves.h"

/* The largest number of earlier steps from which a step is extrapolated */
enum { VMI_HISTORY = 6 };

/* -- A run -- */

/* sa and ca at the nodes of a step */
typedef struct VM_TAG(vmi_step_waves) {
    vm_real sa[VMI_NODES], ca[VMI_NODES];
} vmi_step_waves;

/* Rates: derivatives of ln A and t with respect to the phase psi, at the nodes of a step */
typedef struct VM_TAG(vmi_step_rates) {
    vm_real ln_A[VMI_NODES], t[VMI_NODES];
} vmi_step_rates;

/* A run from 0 to t. A half period, from one zero of ca to the next, is one part, or it is two parts that meet where
   sa = 0. Each step covers one part, unless it starts or ends inside a part. */
typedef struct VM_TAG(vmi_osc_course) {
    const vm_osc_plan *plan;
    vmi_osc_wave wave;
    vmi_gauss_rule rule;
    int side;              /* 1 forward, -1 backward in time */
    int parts;             /* number of parts of a half period, 1 or 2 */
    vm_real stop;          /* time, s, at which a step must end: a point of a table or the end. Laws are not
                              evaluated beyond it */
    vm_real longest;       /* the longest step, s */
    vm_real sweep_limit;   /* the iteration of a step ends when a round changes the phase by less than this */
    vm_real psi, ln_A, t;  /* phase, ln(A/A0) with the amplitude A0 of the plan, time, s */
    vm_real t_low;         /* the exact time is t + t_low, s */
    vm_real left;          /* sum over the steps of the change of phase that their iterations leave out */
    vm_real contraction;   /* factor by which a round of the iteration reduces its error */
    vm_real rate;          /* rate of the phase at the end of the last step, 1/s */
    vmi_step_waves waves[2];                        /* sa and ca on each part of the half period from psi = -Pi/2 */
    vmi_step_rates history[2][VMI_HISTORY];         /* rates from earlier steps that covered all of a part */
    int latest[2];                                  /* index of the latest step in history; earlier ones follow it */
    int known[2];                                   /* number of earlier steps over each part that history holds */
    int status;
    long evals;            /* evaluations of the rates */
} vmi_osc_course;

/* Writes sa and ca at the nodes of a step that starts at the phase `from`. */
VM_API void vmi_osc_course_waves(const vmi_osc_course *c, vm_real from, vm_real length, vmi_step_waves *w)
{
    int i;
    for (i = 0; i < c->rule.n; i++)
        vmi_osc_wave_at(&c->wave, from + length * c->rule.node[i], &w->ca[i], &w->sa[i]);
}

/* A step that is being computed; it starts at the present state of the course */
typedef struct VM_TAG(vmi_osc_step) {
    vm_real length;              /* length in phase */
    vm_real sign;                /* factor of waves: -1 in every second half period, else 1 */
    const vmi_step_waves *waves; /* sa and ca at the nodes, without the factor sign */
    vmi_step_rates rates;        /* rates at the nodes by the last round of the iteration */
} vmi_osc_step;

/* Changes of ln A and of the time t (in seconds) over a step or a part of it */
typedef struct VM_TAG(vmi_osc_change) {
    vm_real ln_A, t;
} vmi_osc_change;

/* The changes of ln A and t over the whole step */
VM_API vmi_osc_change vmi_osc_whole_change(const vmi_osc_course *c, const vmi_osc_step *s)
{
    vmi_osc_change sum;
    int j;
    sum.ln_A = 0;
    sum.t = 0;
    for (j = 0; j < c->rule.n; j++) {
        sum.ln_A += c->rule.weight[j] * s->rates.ln_A[j];
        sum.t += c->rule.weight[j] * s->rates.t[j];
    }
    sum.ln_A *= s->length;
    sum.t *= s->length;
    return sum;
}

/* Writes the derivatives of ln A and t with respect to the phase at node i, where ln(A/A0) is ln_A and the time is t.
   *now holds mass, stiffness and their rates at t, and p_rate is the time derivative of now->p. */
VM_API int vmi_osc_course_rates(const vmi_osc_course *c, const vmi_osc_step *s, int i, const vmi_osc_rates *now,
                                vm_real p_rate, vm_real ln_A, vm_real t, vm_real *ln_A_by_psi, vm_real *t_by_psi)
{
    const vm_osc_plan *plan = c->plan;
    const vm_osc_problem *o = &plan->problem;
    const vm_real least_rate = VM_C(0.03); /* below this ratio of the phase's rate to W there is no vibration */
    const vm_real n = o->alpha + 1, sa = s->sign * s->waves->sa[i], ca = s->sign * s->waves->ca[i];
    const vm_real W = plan->Om * vmi_osc_Om_ratio(plan, now, ln_A);
    const vm_real E = (now->p * (now->p - now->a) - p_rate) / (W * W);
    vm_real rate = 1 + n / 2 * E * ca * ca, ln_A_rate = -now->p + W * E * sa * ca;
    if (o->force) {
        const vm_real A = plan->A * vmi_exp(ln_A, 0), V = 2 * A * W / n, x = A * ca;
        const vm_real f = o->force(t, x, -V * sa - now->p * x, o->ctx) / (now->m * V);
        rate -= f * ca / W;
        ln_A_rate -= 2 / n * f * sa;
    }
    *t_by_psi = 1 / (W * rate);
    *ln_A_by_psi = ln_A_rate * *t_by_psi;
    if (!(rate > least_rate) || !VM_IS_FINITE(*t_by_psi) || !VM_IS_FINITE(*ln_A_by_psi)) return VM_NOT_INTEGRATED;
    return VM_OK;
}

/* The changes of ln A and t from the start of the step to node i, by integration of *rates */
VM_API vmi_osc_change vmi_osc_change_to(const vmi_osc_course *c, const vmi_osc_step *s, const vmi_step_rates *rates,
                                        int i)
{
    const vm_real *weight = c->rule.integral[i];
    vmi_osc_change sum;
    int j;
    sum.ln_A = 0;
    sum.t = 0;
    for (j = 0; j < c->rule.n; j++) {
        sum.ln_A += weight[j] * rates->ln_A[j];
        sum.t += weight[j] * rates->t[j];
    }
    sum.ln_A *= s->length;
    sum.t *= s->length;
    return sum;
}

/* Adds to the rates of a step the corrections `missing` that a round found, and estimates of the further corrections
   that follow: `missing` shifts ln A and t at the nodes, and these shifts change the rates, mostly because W depends on
   both. *now holds mass, stiffness and rates at about the middle of the step. */
VM_API void vmi_osc_correct(const vmi_osc_course *c, const vmi_osc_step *s, const vmi_osc_rates *now,
                            const vmi_step_rates *missing, vmi_step_rates *rates)
{
    const vm_real alpha = c->plan->problem.alpha;
    /* derivatives of ln(dt/dpsi) with respect to t and to ln A */
    const vm_real by_t = -((alpha + 3) * now->p - 2 * now->a) / 2, by_ln_A = -(alpha - 1) / 2;
    int i;
    for (i = 0; i < c->rule.n; i++) {
        const vmi_osc_change moved = vmi_osc_change_to(c, s, missing, i);
        const vm_real change = rates->t[i] * (by_t * moved.t + by_ln_A * moved.ln_A);
        rates->t[i] += missing->t[i] + change;
        rates->ln_A[i] += missing->ln_A[i] - now->p * change;
    }
}

/* Makes one round of the iteration. *change becomes the largest change of the rates, times the length of the step. */
VM_API int vmi_osc_sweep(vmi_osc_course *c, vmi_osc_step *s, vm_real *change)
{
    const vm_real too_short = 256 * VM_EPSILON; /* a phase in which differences of p are rounding errors */
    const int n = c->rule.n;
    vmi_osc_rates now[VMI_NODES];
    vmi_step_rates missing;
    vm_real ln_A[VMI_NODES], t[VMI_NODES];
    int i, j, status;
    for (i = 0; i < n; i++) {
        const vmi_osc_change moved = vmi_osc_change_to(c, s, &s->rates, i);
        ln_A[i] = c->ln_A + moved.ln_A;
        t[i] = c->t + (c->t_low + moved.t);
        if ((vm_real)c->side * (t[i] - c->stop) > 0) t[i] = c->stop;
        status = vmi_osc_rates_at(&c->plan->problem, t[i], t[i] == c->stop ? -c->side : c->side, &now[i]);
        if (status) return status;
    }
    *change = 0;
    for (i = 0; i < n; i++) {
        const vm_real old_ln_A = s->rates.ln_A[i], old_t = s->rates.t[i];
        vm_real p_rate = 0, new_ln_A, new_t;
        for (j = 0; j < n; j++) p_rate += c->rule.derivative[i][j] * now[j].p;
        p_rate /= s->length * old_t;
        if (VM_FABS(s->length) < too_short) p_rate = 0;
        status = vmi_osc_course_rates(c, s, i, &now[i], p_rate, ln_A[i], t[i], &new_ln_A, &new_t);
        if (status) return status;
        missing.ln_A[i] = new_ln_A - old_ln_A;
        missing.t[i] = new_t - old_t;
        *change = vmi_larger((VM_FABS(new_t / old_t - 1) + VM_FABS(new_ln_A - old_ln_A)) * VM_FABS(s->length), *change);
    }
    vmi_osc_correct(c, s, &now[n / 2], &missing, &s->rates);
    c->evals += n;
    return VM_OK;
}

/* Makes rounds of the iteration, which starts from the rates in s->rates, until the phase is in error by less than the
   limit of the course. The error after a round is estimated as the change of phase that the round made, times
   `contraction`. */
VM_API int vmi_osc_iterate(vmi_osc_course *c, vmi_osc_step *s)
{
    const vm_real least_contraction = VM_C(0.02); /* a lower bound, since the next steps may converge more slowly */
    const vm_real rounding = VM_SQRT(VM_EPSILON) / 16; /* in short steps p' has errors of this size, which no round
                                                          removes */
    const int most_rounds = 40;
    vm_real change, before = 0;
    int sweeps, status;
    for (sweeps = 0; sweeps < most_rounds; sweeps++) {
        status = vmi_osc_sweep(c, s, &change);
        if (status) return status;
        if (before > 0) c->contraction = vmi_smaller(vmi_larger(change / before, least_contraction), 1);
        if (change * c->contraction <= c->sweep_limit) break;
        if (sweeps > 2 && !(change < before)) break;
        before = change;
    }
    if (change * c->contraction > c->sweep_limit && !(change <= rounding)) return VM_NOT_INTEGRATED;
    c->left += change * c->contraction;
    return VM_OK;
}

/* Sets the rates from which the iteration of a step starts. They are extrapolated from earlier whole steps over the
   same part of a half period. If there are none, the rates at all nodes are those at the start of the step, without the
   disturbance E = (p^2 - a p - p')/W^2 and the further force F. */
VM_API int vmi_osc_predict(vmi_osc_course *c, int part, vmi_osc_step *s)
{
    vmi_osc_rates now;
    vm_real rate, factor = -1;
    int i, k, status;
    if (c->known[part] == 0) {
        status = vmi_osc_rates_at(&c->plan->problem, c->t, c->side, &now);
        if (status) return status;
        rate = 1 / (c->plan->Om * vmi_osc_Om_ratio(c->plan, &now, c->ln_A));
        for (i = 0; i < c->rule.n; i++) {
            s->rates.ln_A[i] = -now.p * rate;
            s->rates.t[i] = rate;
        }
        return VM_OK;
    }
    for (i = 0; i < c->rule.n; i++) {
        s->rates.ln_A[i] = 0;
        s->rates.t[i] = 0;
    }
    for (k = 0; k < c->known[part]; k++) { /* extrapolation from n earlier steps: the latest times n, the one before
                                              times -n (n-1)/2 ... */
        const vmi_step_rates *last = &c->history[part][(c->latest[part] + k) % VMI_HISTORY];
        factor *= (vm_real)(c->known[part] - k) / (vm_real)(k + 1);
        for (i = 0; i < c->rule.n; i++) {
            s->rates.ln_A[i] -= factor * last->ln_A[i];
            s->rates.t[i] -= factor * last->t[i];
        }
        factor = -factor;
    }
    return VM_OK;
}

/* Advances the state of the course by the step. */
VM_API void vmi_osc_take(vmi_osc_course *c, const vmi_osc_step *s)
{
    const vmi_osc_change moved = vmi_osc_whole_change(c, s);
    const vm_real change = c->t_low + moved.t, t = c->t + change;
    c->t_low = change - (t - c->t);
    c->t = t;
    c->ln_A += moved.ln_A;
    c->psi += s->length;
    c->rate = 1 / s->rates.t[c->rule.n - 1];
}

/* Stores the rates of ln A and t over a whole step. vmi_osc_predict extrapolates from them the rates of the next step
   over the same part (first or second) of a half period. */
VM_API void vmi_osc_remember(vmi_osc_course *c, int part, const vmi_step_rates *rates)
{
    c->latest[part] = (c->latest[part] + VMI_HISTORY - 1) % VMI_HISTORY;
    c->history[part][c->latest[part]] = *rates;
    if (c->known[part] < VMI_HISTORY) c->known[part]++;
}

/* -- Landing on a time -- */

/* Returns the fraction of the step at which the time t is reached, by Newton's method. Writes the Legendre series of
   dt/dpsi on the step to series. */
VM_API vm_real vmi_osc_find_part(const vmi_osc_course *c, const vmi_osc_step *s, vm_real t, vm_real *series)
{
    const int rounds = 8;
    const vm_real way = (t - c->t) - c->t_low;
    vm_real part, slope;
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) series[k] = 0;
    for (i = 0; i < c->rule.n; i++) {
        vm_real before = 0, now = 1;
        for (k = 0; k < c->rule.n; k++) {
            const vm_real next = vmi_legendre_next(k, 2 * c->rule.node[i] - 1, now, before);
            series[k] += (vm_real)(2 * k + 1) * c->rule.weight[i] * now * s->rates.t[i];
            before = now;
            now = next;
        }
    }
    part = way / (s->length * series[0]);
    for (i = 0; i < rounds; i++) {
        slope = s->length * vmi_legendre_at(series, 2 * part - 1);
        part -= (s->length / 2 * vmi_legendre_integral(series, 2 * part - 1) - way) / slope;
        part = vmi_smaller(vmi_larger(part, 0), 1);
    }
    return part;
}

/* Makes a step that ends at c->stop, in place of the longer step `beyond`, which would go past this time. certain is 0
   if `beyond` is only predicted. If `beyond` then turns out not to reach c->stop, the course stays where it is, since
   no step may cross a zero of x. */
VM_API int vmi_osc_land(vmi_osc_course *c, const vmi_osc_step *beyond, int certain)
{
    const int rounds = 6;
    const vm_real way = (c->stop - c->t) - c->t_low;
    vm_real series[VMI_GAUSS], part = vmi_osc_find_part(c, beyond, c->stop, series);
    vmi_step_waves waves;
    vmi_osc_step s;
    int i, attempt, status;
    s.sign = 1;
    s.waves = &waves;
    s.length = part * beyond->length;
    for (i = 0; i < c->rule.n; i++) {
        s.rates.t[i] = vmi_legendre_at(series, 2 * part * c->rule.node[i] - 1);
        s.rates.ln_A[i] = beyond->rates.ln_A[i];
    }
    for (attempt = 0; attempt < rounds; attempt++) {
        vm_real missing;
        vmi_osc_course_waves(c, c->psi, s.length, &waves);
        status = vmi_osc_iterate(c, &s);
        if (status == VM_NOT_INTEGRATED && !certain) return VM_OK;
        if (status) return status;
        missing = (way - vmi_osc_whole_change(c, &s).t) / s.rates.t[c->rule.n - 1];
        if (VM_FABS(missing) <= c->sweep_limit) break;
        s.length += missing;
    }
    if (!certain && VM_FABS(s.length) > VM_FABS(beyond->length)) return VM_OK;
    c->left += c->sweep_limit;
    vmi_osc_take(c, &s);
    c->t = c->stop;
    c->t_low = 0;
    c->known[0] = 0;
    c->known[1] = 0;
    return VM_OK;
}

/* -- Steps -- */

/* Returns the phase at which the next step ends: a zero of ca, or with two parts a zero of ca or sa. *part becomes the
   number of the part that the step covers, or -1 where the step starts inside a part; *sign becomes the factor of its
   waves. */
VM_API vm_real vmi_osc_next_phase(const vmi_osc_course *c, int *part, vm_real *sign)
{
    const vm_real half = c->plan->ripple.pi, close = 64 * VM_EPSILON * (1 + VM_FABS(c->psi) / half);
    const vm_real per_step = (vm_real)c->parts / half, side = (vm_real)c->side;
    const vm_real at = (c->psi + half / 2) * per_step; /* the phase, counted in steps; the step ends at `next` */
    const vm_real nearest = VM_FLOOR(at + VM_C(0.5)), next = VM_FLOOR(side * at + close) + 1;
    const vm_real cell = side > 0 ? side * next - 1 : side * next; /* the step lies between cell and cell + 1 */
    const vm_real turn = VM_FLOOR(cell / (vm_real)c->parts);
    *part = VM_FABS(at - nearest) <= close ? (int)(cell - turn * (vm_real)c->parts) : -1;
    *sign = turn - 2 * VM_FLOOR(turn / 2) == 0 ? 1 : -1;
    return side * next / per_step - half / 2;
}

/* Whether the step, by its present rates, ends at or beyond c->stop */
VM_API int vmi_osc_is_beyond(const vmi_osc_course *c, const vmi_osc_step *s)
{
    return (vm_real)c->side * ((c->t - c->stop) + (c->t_low + vmi_osc_whole_change(c, s).t)) >= 0;
}

/* Makes a step whose length is `most`, between 0 and 1, times the usual length. If it would go beyond c->stop, it is
   shortened to end there. */
VM_API int vmi_osc_course_step_of(vmi_osc_course *c, vm_real most)
{
    vmi_step_waves inside;
    vmi_osc_step s;
    vm_real share;
    int part, status;
    s.length = vmi_osc_next_phase(c, &part, &s.sign) - c->psi;
    status = vmi_osc_predict(c, part < 0 ? 0 : part, &s);
    if (status) return status;
    share = vmi_smaller(c->longest / VM_FABS(vmi_osc_whole_change(c, &s).t), most);
    if (share < 1) {
        s.length *= share;
        part = -1;
    }
    s.waves = &c->waves[part < 0 ? 0 : part];
    if (part < 0) {
        s.sign = 1;
        s.waves = &inside;
        vmi_osc_course_waves(c, c->psi, s.length, &inside);
    }
    if (vmi_osc_is_beyond(c, &s)) {
        status = vmi_osc_land(c, &s, 0);
        if (status || c->t == c->stop) return status;
    }
    status = vmi_osc_iterate(c, &s);
    if (status) return status;
    if (vmi_osc_is_beyond(c, &s)) return vmi_osc_land(c, &s, 1);
    vmi_osc_take(c, &s);
    if (part >= 0) vmi_osc_remember(c, part, &s.rates);
    return VM_OK;
}

/* Makes one step. Where its iteration does not converge, it tries shorter and shorter steps. */
VM_API int vmi_osc_course_step(vmi_osc_course *c)
{
    const vm_real shortest = VM_C(0.01); /* the shortest step, as a part of the usual length */
    vm_real most = 1;
    int status = vmi_osc_course_step_of(c, most);
    while (status == VM_NOT_INTEGRATED && most > shortest) {
        most /= 2;
        c->contraction = VM_C(0.1);
        status = vmi_osc_course_step_of(c, most);
    }
    return status;
}

/* Starts a course at t = 0 from the amplitude and phase in *start, with n points per step and `parts` parts per half
   period. */
VM_API void vmi_osc_course_start(vmi_osc_course *c, const vm_osc_plan *plan, const vmi_osc_reduced *start, int side,
                                 int n, int parts, vm_real sweep_limit)
{
    const vm_real half = plan->ripple.pi;
    vm_real from, length = (vm_real)side * half / (vm_real)parts;
    int part;
    c->plan = plan;
    c->wave = vmi_osc_wave_of(plan, VM_ROUTE_COLLOCATION);
    vmi_gauss_rule_init(&c->rule, n);
    c->side = side;
    c->parts = parts;
    c->sweep_limit = sweep_limit;
    c->stop = 0;
    c->longest = VM_INFINITY;
    c->psi = start->psi;
    c->ln_A = vmi_log(start->A / plan->A).hi;
    c->t = 0;
    c->t_low = 0;
    c->left = 0;
    c->contraction = VM_C(0.1);
    c->rate = 0;
    for (part = 0; part < parts; part++) {
        from = half * ((vm_real)part / (vm_real)parts - VM_C(0.5));
        if (side < 0) from += half / (vm_real)parts;
        vmi_osc_course_waves(c, from, length, &c->waves[part]);
    }
    for (part = 0; part < 2; part++) {
        c->latest[part] = 0;
        c->known[part] = 0;
    }
    c->evals = 0;
}

/* -- Two runs side by side -- */

/* The next point of a table after `from` on the way to t, or t if there is none */
VM_API vm_real vmi_osc_next_knot(const vm_osc_problem *o, vm_real from, vm_real t)
{
    return vmi_law_next_knot(&o->stiffness, from, vmi_law_next_knot(&o->mass, from, t));
}

/* Advances both courses to t, a point of a table or the end. Raises *difference to the largest difference of ln A and
   phase between the two courses on the way. */
VM_API int vmi_osc_courses_to(vmi_osc_course *loose, vmi_osc_course *strict, vm_real t, vm_real *difference)
{
    const vm_real most_steps = VM_C(16777216.); /* 2^24: with more, float has no digits for the phase */
    vm_real steps = 0;
    int status = VM_OK;
    loose->stop = t;
    strict->stop = t;
    while (!status && (loose->t != t || strict->t != t)) {
        vm_real apart;
        if (loose->t != t) status = vmi_osc_course_step(loose);
        if (!status && strict->t != t) status = vmi_osc_course_step(strict);
        if (status) break;
        apart = VM_FABS(loose->psi - strict->psi) + VM_FABS(loose->ln_A - strict->ln_A);
        if (loose->t != t && strict->t != t && loose->psi == strict->psi)
            apart += VM_FABS((loose->t - strict->t) * strict->rate);
        if (loose->psi == strict->psi || (loose->t == t && strict->t == t))
            *difference = vmi_larger(apart, *difference);
        steps += 1;
        if (steps > most_steps) status = VM_NOT_INTEGRATED;
    }
    return status;
}

/* Numbers of points per step in the loose and in the strict run, and of parts per half period in both runs */
typedef struct VM_TAG(vmi_osc_points) {
    signed char loose, strict, parts;
} vmi_osc_points;

/* The number of pairs of runs that can be tried one after the other */
enum { VMI_OSC_PAIRS = 6 };

/* Whether the rates are smooth inside a half period, so that one step over it is good. With a force they may have kinks
   in the middle, where x' = 0; for alpha > 3 they change quickly there. In these cases two steps that meet in the
   middle are better. */
VM_API int vmi_osc_has_smooth_halves(const vm_osc_problem *o) { return o->alpha <= 3 && !o->force; }

/* Pair number i, 0 to VMI_OSC_PAIRS - 1. Each pair is more accurate than the one before. */
VM_API vmi_osc_points vmi_osc_pair(const vm_osc_problem *o, int i)
{
    static const vmi_osc_points smooth[VMI_OSC_PAIRS] = {{4, 6, 1}, {5, 7, 1},  {8, 11, 1},
                                                         {5, 7, 2}, {8, 11, 2}, {14, 20, 2}};
    static const vmi_osc_points other[VMI_OSC_PAIRS] = {{4, 6, 2},  {5, 7, 2},   {6, 8, 2},
                                                        {8, 11, 2}, {10, 14, 2}, {14, 20, 2}};
    return vmi_osc_has_smooth_halves(o) ? smooth[i] : other[i];
}

/* The number of the pair that is tried first. It is about the cheapest that reaches the tolerance where mass and
   stiffness change by 1 % while the phase grows by 1. */
VM_API int vmi_osc_first_pair(const vm_osc_problem *o, vm_real tolerance)
{
    if (o->force) return tolerance >= VM_C(1e-6) ? 2 : 4;
    if (tolerance >= VM_C(1e-6)) return 0;
    if (tolerance >= VM_C(1e-8)) return vmi_osc_has_smooth_halves(o) ? 1 : 0;
    if (tolerance >= VM_C(1e-9)) return 2;
    return tolerance >= VM_C(1e-10) ? 3 : 4;
}

/* The number of the pair that is tried after pair i, whose estimated error is `error`, larger than the tolerance. A
   pair is skipped if its error would be too large even if errors fell as 1/(number of points)^10. */
VM_API int vmi_osc_next_pair(const vm_osc_problem *o, int i, vm_real error, vm_real tolerance)
{
    const vmi_osc_points last = vmi_osc_pair(o, i);
    int next;
    for (next = i + 1; next < VMI_OSC_PAIRS - 1; next++) {
        const vmi_osc_points points = vmi_osc_pair(o, next);
        const vm_real ratio = (vm_real)(last.strict * last.parts) / (vm_real)(points.strict * points.parts);
        const vm_real power_5 = ratio * ratio * ratio * ratio * ratio;
        if (error * power_5 * power_5 <= tolerance) break;
    }
    return next;
}

/* Returns the estimated error of the strict run divided by the difference of the two runs, which is nearly the error of
   the loose run. Where alpha < 1, the rates have terms proportional to d^(alpha+2), where d is the distance from a zero
   of x. For these terms the error of Gauss' rule of n points falls as n^-(2 alpha + 6). For larger alpha up to 10 it
   falls as n^-8 at least. Kinks from a force or from a law by a function, and the sharp turns of a large alpha, make it
   fall more slowly. */
VM_API vm_real vmi_osc_strict_share(const vm_osc_problem *o, vmi_osc_points points)
{
    const vm_real ratio = (vm_real)points.loose / (vm_real)points.strict, squared = ratio * ratio;
    if (o->force || o->mass.function || o->stiffness.function || o->alpha > 10) return squared * squared;
    return squared * squared * squared * (o->alpha >= 1 ? squared : 1);
}

/* Makes one pair of runs from 0 to t. *strict becomes the strict run at t, *error the estimate of its error. */
VM_API int vmi_osc_collocate_pair(const vm_osc_plan *plan, vm_real t, vmi_osc_points points, vm_real longest,
                                  vm_real sweep_limit, vmi_osc_course *strict, vm_real *error)
{
    const int side = vmi_time_side(t);
    const vm_real looser = 16;         /* ratio of the sweep_limits of both runs: errors of the iteration differ, too */
    vmi_osc_rates now;
    vmi_osc_slow start;
    vmi_osc_reduced state;
    vmi_osc_course loose;
    vm_real difference = 0;
    int status = vmi_osc_rates_at(&plan->problem, 0, side, &now);
    if (status) return status;
    start.m = now.m;
    start.k = now.k;
    start.p = now.p;
    state = vmi_osc_reduce(&start, plan->problem.alpha, plan->problem.x, plan->problem.v);
    vmi_osc_course_start(&loose, plan, &state, side, points.loose, points.parts, looser * sweep_limit);
    vmi_osc_course_start(strict, plan, &state, side, points.strict, points.parts, sweep_limit);
    loose.longest = longest;
    strict->longest = longest;
    while (!status && strict->t != t)
        status = vmi_osc_courses_to(&loose, strict, vmi_osc_next_knot(&plan->problem, strict->t, t), &difference);
    strict->evals += loose.evals;
    *error = vmi_osc_strict_share(&plan->problem, points) * difference + strict->left +
             4 * VM_EPSILON * (2 + VM_FABS(strict->psi - state.psi));
    return status;
}

/* Computes the motion at t by collocation. Returns VM_TOLERANCE_MISSED where the motion is computed, but its estimated
   error is larger than the tolerance. Returns VM_NOT_INTEGRATED after 2^24 steps, and where amplitude and phase do not
   describe the motion, because mass, stiffness or force change as fast as the phase. Also returns the statuses of the
   laws. */
VM_API int vmi_osc_collocate(const vm_osc_plan *plan, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_real knots = (vm_real)(plan->problem.mass.n + plan->problem.stiffness.n);
    const vm_real steps = 2 + plan->Om * VM_FABS(t) / plan->ripple.pi + knots;
    const vm_real share = 4 * steps; /* the iterations of all steps may take a quarter of the tolerance */
    const vm_real most_half_periods = VM_C(1073741824.); /* 2^30 */
    vm_osc_motion result;
    vmi_osc_course c;
    vmi_osc_reduced state;
    vmi_osc_rates now;
    vm_real error = VM_INFINITY, sweep_limit = vmi_larger(tolerance / share, VM_EPSILON), sa, ca;
    long evals = 0;
    vm_real longest;
    int i = vmi_osc_first_pair(&plan->problem, tolerance), status = vmi_osc_law_step(plan, t, &longest);
    if (status) return status;
    if (!(plan->Om * VM_FABS(t) <= most_half_periods * plan->ripple.pi)) return VM_NOT_INTEGRATED;
    while (i < VMI_OSC_PAIRS && !(error <= tolerance)) {
        status = vmi_osc_collocate_pair(plan, t, vmi_osc_pair(&plan->problem, i), 2 * longest, sweep_limit, &c, &error);
        if (status) return status;
        evals += c.evals;
        sweep_limit = vmi_larger(sweep_limit / 16, VM_EPSILON); /* the iterations may have caused most of the error */
        i = vmi_osc_next_pair(&plan->problem, i, error, tolerance);
    }
    status = vmi_osc_rates_at(&plan->problem, t, -c.side, &now);
    if (status) return status;
    state.psi = c.psi;
    state.A = plan->A * vmi_exp(c.ln_A, 0);
    state.W = plan->Om * vmi_osc_Om_ratio(plan, &now, c.ln_A);
    vmi_osc_wave_at(&c.wave, c.psi, &ca, &sa);
    vmi_osc_unreduce(&state, now.p, plan->problem.alpha, sa, ca, &result.x, &result.v);
    result.amplitude = state.A;
    result.error = error;
    result.route = route;
    result.evals = evals;
    if (!VM_IS_FINITE(result.x) || !VM_IS_FINITE(result.v)) return VM_NOT_FINITE;
    *motion = result;
    return error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

#endif
