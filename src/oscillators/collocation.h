/* oscillators/collocation.h - integration of an oscillator from zero to zero of x, to a tolerance

   The exact equations of oscillators/reduction.h for the amplitude A and the phase psi, with a further force F,
     (ln A)' = -p + W E sa ca - 2/(alpha+1) f sa,   psi' = W (1 + (alpha+1)/2 E ca^2) - f ca,
   E = (p^2 - a p - p')/W^2, f = F/(m V), V = 2 A W/(alpha+1), are solved with psi as the independent variable: ln A and
   t are integrated from one zero of x to the next. There |x|^(alpha-1) x has no derivatives for most alpha; since the
   steps end there, no order is lost. In a step the method is Gauss' collocation of n points, with the values of the
   last steps extrapolated as a start of its iteration. p' is the derivative of the polynomial through p at these
   points, so that laws have to give f and f' only. Two runs with different n go side by side; by how much they differ
   gives the error.
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
#include "integration.h"
#include "laws.h"
#include "legendre.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "waves.h"

/* -- Gauss' rule of n points on [0, 1] -- */

/* Most points, numbers that are integrated (ln A, t), steps whose values are extrapolated */
enum { VMI_NODES = VMI_GAUSS, VMI_COLLOCATED = 2, VMI_HISTORY = 6 };
enum { VMI_COLLOCATED_LN_A = 0, VMI_COLLOCATED_T = 1 };

typedef struct VM_TAG(vmi_gauss_rule) {
    int n;
    vm_real node[VMI_NODES], weight[VMI_NODES];
    vm_real integral[VMI_NODES][VMI_NODES];   /* [i][j]: integral from 0 to node i of the polynomial that is 1 at node j */
    vm_real derivative[VMI_NODES][VMI_NODES]; /* [i][j]: derivative of this polynomial at node i */
} vmi_gauss_rule;

/* Legendre's P_n(x), and its derivative in *slope */
VM_API vm_real vmi_legendre_polynomial(int n, vm_real x, vm_real *slope)
{
    vm_real before = 0, now = 1;
    int k;
    for (k = 0; k < n; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        before = now;
        now = next;
    }
    *slope = (vm_real)n * (x * now - before) / (x * x - 1);
    return now;
}

/* Nodes and weights by Newton's method, from the nodes of Chebyshev's polynomial */
VM_API void vmi_gauss_rule_nodes(vmi_gauss_rule *rule)
{
    const int rounds = 6;
    int i, j;
    for (i = 0; i < rule->n; i++) {
        vm_real x, sine, slope = 1;
        vmi_sincos(VM_PI * ((vm_real)i + VM_C(0.75)) / ((vm_real)rule->n + VM_C(0.5)), &sine, &x);
        for (j = 0; j < rounds; j++) {
            const vm_real value = vmi_legendre_polynomial(rule->n, x, &slope);
            x -= value / slope;
        }
        vmi_legendre_polynomial(rule->n, x, &slope);
        rule->node[i] = (1 - x) / 2;
        rule->weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* Adds to the matrices what Legendre's polynomial of degree k, with values at the nodes, its integrals from 0 and its
   derivatives by the node, contributes to the polynomial that is 1 at one node */
VM_API void vmi_gauss_rule_add(vmi_gauss_rule *rule, int k, const vm_real *values, const vm_real *integrals,
                               const vm_real *derivatives)
{
    int i, j;
    for (j = 0; j < rule->n; j++) {
        const vm_real share = (vm_real)(2 * k + 1) * rule->weight[j] * values[j];
        for (i = 0; i < rule->n; i++) {
            rule->integral[i][j] += share * integrals[i];
            rule->derivative[i][j] += share * derivatives[i];
        }
    }
}

/* The rule of n points, 2 <= n <= VMI_NODES */
VM_API void vmi_gauss_rule_init(vmi_gauss_rule *rule, int n)
{
    vm_real before[VMI_NODES], now[VMI_NODES], slope_before[VMI_NODES], slope[VMI_NODES];
    vm_real integrals[VMI_NODES], derivatives[VMI_NODES];
    int i, j, k;
    rule->n = n;
    vmi_gauss_rule_nodes(rule);
    for (i = 0; i < n; i++) {
        before[i] = 0;
        now[i] = 1;
        slope_before[i] = 0;
        slope[i] = 0;
        for (j = 0; j < n; j++) {
            rule->integral[i][j] = 0;
            rule->derivative[i][j] = 0;
        }
    }
    for (k = 0; k < n; k++) { /* x = 2 node - 1: integrals by the node are half of those by x, derivatives double */
        for (i = 0; i < n; i++) {
            const vm_real x = 2 * rule->node[i] - 1, next = vmi_legendre_next(k, x, now[i], before[i]);
            integrals[i] = k == 0 ? rule->node[i] : (next - before[i]) / (vm_real)(2 * (2 * k + 1));
            derivatives[i] = 2 * slope[i];
        }
        vmi_gauss_rule_add(rule, k, now, integrals, derivatives);
        for (i = 0; i < n; i++) { /* P'_(k+1) = P'_(k-1) + (2k+1) P_k */
            const vm_real x = 2 * rule->node[i] - 1, next = vmi_legendre_next(k, x, now[i], before[i]);
            const vm_real next_slope = slope_before[i] + (vm_real)(2 * k + 1) * now[i];
            slope_before[i] = slope[i];
            slope[i] = next_slope;
            before[i] = now[i];
            now[i] = next;
        }
    }
}

/* -- A run -- */

/* sa and ca at the nodes of a step */
typedef struct VM_TAG(vmi_step_waves) {
    vm_real sa[VMI_NODES], ca[VMI_NODES];
} vmi_step_waves;

/* Derivatives of ln A and t by the phase at the nodes of a step */
typedef struct VM_TAG(vmi_step_rates) {
    vm_real by_psi[VMI_COLLOCATED][VMI_NODES];
} vmi_step_rates;

/* A run from 0 to t. A half period is one step, or two steps with a stop where x' = 0. */
typedef struct VM_TAG(vmi_osc_course) {
    const vm_osc_plan *plan;
    vmi_osc_wave wave;
    vmi_gauss_rule rule;
    int side;              /* 1 forward, -1 backward in time */
    int parts;             /* steps of a half period, 1 or 2 */
    vm_real stop;          /* laws are not asked beyond this time, s: a point of a table or the end */
    vm_real longest;       /* the longest step, s */
    vm_real sweep_limit;   /* the iteration of a step ends where the phase changes by less than this */
    vm_real psi, ln_A, t;  /* phase, ln(A/A0) with the amplitude A0 of the plan, time, s */
    vm_real t_low;         /* what t as one number loses, s */
    vm_real contraction;   /* by this factor each round of the iteration reduces its error */
    vm_real left;          /* sum over the steps of the square of what the iteration leaves of the phase */
    vm_real rate;          /* of the phase at the end of the last step, 1/s */
    vmi_step_waves waves[2];                        /* of the parts of a half period that starts at psi = -Pi/2 */
    vmi_step_rates history[2][VMI_HISTORY];         /* of the last whole steps, by parts, the last one first */
    int known[2];                                   /* how many of them there are */
    int status;
    long evals;
} vmi_osc_course;

/* sa and ca at the nodes between two phases */
VM_API void vmi_osc_course_waves(const vmi_osc_course *c, vm_real from, vm_real length, vmi_step_waves *w)
{
    int i;
    for (i = 0; i < c->rule.n; i++)
        vmi_osc_wave_at(&c->wave, from + length * c->rule.node[i], &w->ca[i], &w->sa[i]);
}

/* A step that is being made: from the state of the course over a length of phase */
typedef struct VM_TAG(vmi_osc_step) {
    vm_real length;
    vm_real sign;          /* factor of the waves: -1 in every second half period, where both have the other sign */
    const vmi_step_waves *waves;
    vmi_step_rates rates;
} vmi_osc_step;

/* The change of ln A or t over the whole step */
VM_API vm_real vmi_osc_step_whole(const vmi_osc_course *c, const vmi_osc_step *s, int which)
{
    vm_real sum = 0;
    int j;
    for (j = 0; j < c->rule.n; j++) sum += c->rule.weight[j] * s->rates.by_psi[which][j];
    return s->length * sum;
}

/* The rates by the phase at node i, where the laws say *now and p' = p_rate, at ln(A/A0) = ln_A and time t */
VM_API int vmi_osc_course_rates(const vmi_osc_course *c, const vmi_osc_step *s, int i, const vmi_osc_rates *now,
                                vm_real p_rate, vm_real ln_A, vm_real t, vm_real *ln_A_by_psi, vm_real *t_by_psi)
{
    const vm_osc_plan *plan = c->plan;
    const vm_osc_problem *o = &plan->problem;
    const vm_real least_rate = VM_C(0.1); /* of the phase by W: below it this is no vibration */
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

/* The integral of rates by psi from the start of the step to node i */
VM_API vm_real vmi_osc_integral_to(const vmi_osc_course *c, const vmi_osc_step *s, const vm_real *rates, int i)
{
    vm_real sum = 0;
    int j;
    for (j = 0; j < c->rule.n; j++) sum += c->rule.integral[i][j] * rates[j];
    return s->length * sum;
}

/* The rates of a step go on by what a round found to be missing, and by what that changes in turn: `missing` moves ln A
   and t, which moves the rates, mostly by the change of W with both. now: the laws at about the middle of the step */
VM_API void vmi_osc_correct(const vmi_osc_course *c, const vmi_osc_step *s, const vmi_osc_rates *now,
                            const vmi_step_rates *missing, vmi_step_rates *rates)
{
    const vm_real alpha = c->plan->problem.alpha;
    const vm_real by_t = -((alpha + 3) * now->p - 2 * now->a) / 2, by_ln_A = -(alpha - 1) / 2; /* of ln(dt/dpsi) */
    int i;
    for (i = 0; i < c->rule.n; i++) {
        const vm_real ln_A = vmi_osc_integral_to(c, s, missing->by_psi[VMI_COLLOCATED_LN_A], i);
        const vm_real t = vmi_osc_integral_to(c, s, missing->by_psi[VMI_COLLOCATED_T], i);
        const vm_real change = rates->by_psi[VMI_COLLOCATED_T][i] * (by_t * t + by_ln_A * ln_A);
        rates->by_psi[VMI_COLLOCATED_T][i] += missing->by_psi[VMI_COLLOCATED_T][i] + change;
        rates->by_psi[VMI_COLLOCATED_LN_A][i] += missing->by_psi[VMI_COLLOCATED_LN_A][i] - now->p * change;
    }
}

/* One round of the iteration. *change: largest change of the phase over the step that it finds */
VM_API int vmi_osc_sweep(vmi_osc_course *c, vmi_osc_step *s, vm_real *change)
{
    const int n = c->rule.n;
    vmi_osc_rates now[VMI_NODES];
    vmi_step_rates missing;
    vm_real ln_A[VMI_NODES], t[VMI_NODES];
    int i, j, status;
    for (i = 0; i < n; i++) {
        ln_A[i] = c->ln_A + vmi_osc_integral_to(c, s, s->rates.by_psi[VMI_COLLOCATED_LN_A], i);
        t[i] = c->t + (c->t_low + vmi_osc_integral_to(c, s, s->rates.by_psi[VMI_COLLOCATED_T], i));
        if ((vm_real)c->side * (t[i] - c->stop) > 0) t[i] = c->stop;
        status = vmi_osc_rates_at(&c->plan->problem, t[i], t[i] == c->stop ? -c->side : c->side, &now[i]);
        if (status) return status;
    }
    *change = 0;
    for (i = 0; i < n; i++) {
        const vm_real old_ln_A = s->rates.by_psi[VMI_COLLOCATED_LN_A][i], old_t = s->rates.by_psi[VMI_COLLOCATED_T][i];
        vm_real p_rate = 0, new_ln_A, new_t;
        for (j = 0; j < n; j++) p_rate += c->rule.derivative[i][j] * now[j].p;
        p_rate /= s->length * old_t;
        status = vmi_osc_course_rates(c, s, i, &now[i], p_rate, ln_A[i], t[i], &new_ln_A, &new_t);
        if (status) return status;
        missing.by_psi[VMI_COLLOCATED_LN_A][i] = new_ln_A - old_ln_A;
        missing.by_psi[VMI_COLLOCATED_T][i] = new_t - old_t;
        *change = vmi_larger((VM_FABS(new_t / old_t - 1) + VM_FABS(new_ln_A - old_ln_A)) * VM_FABS(s->length), *change);
    }
    vmi_osc_correct(c, s, &now[n / 2], &missing, &s->rates);
    c->evals += n;
    return VM_OK;
}

/* Rounds until the rates do not change any more, from the rates in s->rates */
VM_API int vmi_osc_iterate(vmi_osc_course *c, vmi_osc_step *s)
{
    const vm_real least_contraction = VM_C(0.02);
    const int most_rounds = 40;
    vm_real change, before = 0;
    int round, status;
    for (round = 0; round < most_rounds; round++) {
        status = vmi_osc_sweep(c, s, &change);
        if (status) return status;
        if (round > 0 && before > 0) c->contraction = vmi_larger(change / before, least_contraction);
        if (change * c->contraction <= c->sweep_limit) {
            const vm_real left = change * c->contraction;
            c->left += left * left;
            return VM_OK;
        }
        if (round > 2 && !(change < before)) break;
        before = change;
    }
    return change <= 64 * VM_EPSILON ? VM_OK : VM_NOT_INTEGRATED;
}

/* The next value after n at equal distances, the last one first, by the polynomial through them; destroys the values */
VM_API vm_real vmi_extrapolate(int n, vm_real *values)
{
    vm_real sum = 0;
    int i, k;
    for (k = n; k > 0; k--) { /* adds the last differences of order 0, 1, 2 ... */
        sum += values[0];
        for (i = 0; i < k - 1; i++) values[i] -= values[i + 1];
    }
    return sum;
}

/* Start values of a step: extrapolated from whole steps of the same part, or else the rates at the start */
VM_API int vmi_osc_predict(vmi_osc_course *c, int part, vmi_osc_step *s)
{
    const vmi_step_rates *h = c->history[part];
    vmi_osc_rates now;
    vm_real rate;
    int i, j, k, status;
    if (c->known[part] == 0) {
        status = vmi_osc_rates_at(&c->plan->problem, c->t, c->side, &now);
        if (status) return status;
        rate = 1 / (c->plan->Om * vmi_osc_Om_ratio(c->plan, &now, c->ln_A));
        for (i = 0; i < c->rule.n; i++) {
            s->rates.by_psi[VMI_COLLOCATED_LN_A][i] = -now.p * rate;
            s->rates.by_psi[VMI_COLLOCATED_T][i] = rate;
        }
        return VM_OK;
    }
    for (j = 0; j < VMI_COLLOCATED; j++)
        for (i = 0; i < c->rule.n; i++) {
            vm_real values[VMI_HISTORY];
            for (k = 0; k < c->known[part]; k++) values[k] = h[k].by_psi[j][i];
            s->rates.by_psi[j][i] = vmi_extrapolate(c->known[part], values);
        }
    return VM_OK;
}

/* The state of the course goes on by the step */
VM_API void vmi_osc_take(vmi_osc_course *c, const vmi_osc_step *s)
{
    const vm_real change = c->t_low + vmi_osc_step_whole(c, s, VMI_COLLOCATED_T), t = c->t + change;
    c->t_low = change - (t - c->t);
    c->t = t;
    c->ln_A += vmi_osc_step_whole(c, s, VMI_COLLOCATED_LN_A);
    c->psi += s->length;
    c->rate = 1 / s->rates.by_psi[VMI_COLLOCATED_T][c->rule.n - 1];
}

/* Keeps the rates of a whole step for the next ones of the same part */
VM_API void vmi_osc_remember(vmi_osc_course *c, int part, const vmi_step_rates *rates)
{
    int i;
    for (i = VMI_HISTORY - 1; i > 0; i--) c->history[part][i] = c->history[part][i - 1];
    c->history[part][0] = *rates;
    if (c->known[part] < VMI_HISTORY) c->known[part]++;
}

/* -- Landing on a time -- */

/* The part of the step at which t is reached, by the polynomial of the step */
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
            series[k] += (vm_real)(2 * k + 1) * c->rule.weight[i] * now * s->rates.by_psi[VMI_COLLOCATED_T][i];
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

/* Makes a shorter step than the one that would go beyond c->stop, so that it ends there. certain: 0 where the longer step
   is a prediction only; if it turns out that it does not reach c->stop, the course stays where it is. No step may cross a
   zero of x. */
VM_API int vmi_osc_land(vmi_osc_course *c, const vmi_osc_step *beyond, int certain)
{
    const int rounds = 6;
    const vm_real way = (c->stop - c->t) - c->t_low;
    vm_real series[VMI_GAUSS], part = vmi_osc_find_part(c, beyond, c->stop, series);
    vmi_step_waves waves;
    vmi_osc_step s;
    int i, round, status;
    s.sign = 1;
    s.waves = &waves;
    s.length = part * beyond->length;
    for (i = 0; i < c->rule.n; i++) {
        s.rates.by_psi[VMI_COLLOCATED_T][i] = vmi_legendre_at(series, 2 * part * c->rule.node[i] - 1);
        s.rates.by_psi[VMI_COLLOCATED_LN_A][i] = beyond->rates.by_psi[VMI_COLLOCATED_LN_A][i];
    }
    for (round = 0; round < rounds; round++) {
        vm_real missing;
        vmi_osc_course_waves(c, c->psi, s.length, &waves);
        status = vmi_osc_iterate(c, &s);
        if (status) return status;
        missing = (way - vmi_osc_step_whole(c, &s, VMI_COLLOCATED_T)) /
                  s.rates.by_psi[VMI_COLLOCATED_T][c->rule.n - 1];
        if (VM_FABS(missing) <= c->sweep_limit / 4) break;
        s.length += missing;
    }
    if (!certain && VM_FABS(s.length) > VM_FABS(beyond->length)) return VM_OK;
    vmi_osc_take(c, &s);
    c->t = c->stop;
    c->t_low = 0;
    c->known[0] = 0;
    c->known[1] = 0;
    return VM_OK;
}

/* -- Steps -- */

/* The phase at which the next step ends: a multiple of Pi/2, that for one part is a zero of ca; *part: which part of a
   half period the step is, -1 where it starts inside */
VM_API vm_real vmi_osc_next_phase(const vmi_osc_course *c, int *part, vm_real *sign)
{
    const vm_real half = c->plan->ripple.pi, close = 64 * VM_EPSILON * (1 + VM_FABS(c->psi) / half);
    const vm_real per_step = (vm_real)c->parts / half, side = (vm_real)c->side;
    const vm_real at = (c->psi + half / 2) * per_step; /* whole numbers are ends of steps */
    const vm_real nearest = VM_FLOOR(at + VM_C(0.5)), next = VM_FLOOR(side * at + close) + 1; /* along the way */
    const vm_real cell = side > 0 ? side * next - 1 : side * next; /* the step lies between cell and cell + 1 */
    const vm_real turn = VM_FLOOR(cell / (vm_real)c->parts);
    *part = VM_FABS(at - nearest) <= close ? (int)(cell - turn * (vm_real)c->parts) : -1;
    *sign = turn - 2 * VM_FLOOR(turn / 2) == 0 ? 1 : -1;
    return side * next / per_step - half / 2;
}

/* Whether the step, as its rates are now, ends at or beyond c->stop */
VM_API int vmi_osc_is_beyond(const vmi_osc_course *c, const vmi_osc_step *s)
{
    return (vm_real)c->side * ((c->t - c->stop) + (c->t_low + vmi_osc_step_whole(c, s, VMI_COLLOCATED_T))) >= 0;
}

/* One step towards c->stop, which ends there at the latest */
VM_API int vmi_osc_course_step(vmi_osc_course *c)
{
    vmi_step_waves inside;
    vmi_osc_step s;
    vm_real share;
    int part, status;
    s.length = vmi_osc_next_phase(c, &part, &s.sign) - c->psi;
    status = vmi_osc_predict(c, part < 0 ? 0 : part, &s);
    if (status) return status;
    share = c->longest / VM_FABS(vmi_osc_step_whole(c, &s, VMI_COLLOCATED_T));
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

/* A course of n points at t = 0 */
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
    c->contraction = VM_C(0.1);
    c->left = 0;
    c->rate = 0;
    for (part = 0; part < parts; part++) {
        from = half * ((vm_real)part / (vm_real)parts - VM_C(0.5));
        if (side < 0) from += half / (vm_real)parts;
        vmi_osc_course_waves(c, from, length, &c->waves[part]);
        c->known[part] = 0;
    }
    c->known[1] = 0;
    c->evals = 0;
}

/* -- Two runs side by side -- */

/* The next point of a table on the way to t, or t */
VM_API vm_real vmi_osc_next_knot(const vm_osc_problem *o, vm_real from, vm_real t)
{
    return vmi_law_next_knot(&o->stiffness, from, vmi_law_next_knot(&o->mass, from, t));
}

/* Both courses go on to t, a point of a table or the end. *difference becomes the largest difference of ln A and of the
   phase on the way, if that is larger. */
VM_API int vmi_osc_courses_to(vmi_osc_course *loose, vmi_osc_course *strict, vm_real t, vm_real *difference)
{
    const vm_real most_steps = VM_C(16777216.); /* 2^24: in float more hold no phase, in double they take minutes */
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
        if (loose->psi == strict->psi || (loose->t == t && strict->t == t)) *difference = vmi_larger(apart, *difference);
        steps += 1;
        if (steps > most_steps) status = VM_NOT_INTEGRATED;
    }
    return status;
}

/* Runs of two numbers of points */
typedef struct VM_TAG(vmi_osc_points) {
    int loose, strict, parts;
} vmi_osc_points;

VM_API vmi_osc_points vmi_osc_points_of(int loose, int strict, int parts)
{
    vmi_osc_points points;
    points.loose = loose;
    points.strict = strict;
    points.parts = parts;
    return points;
}

/* The pairs that are tried, one after the other; the last one is number VMI_OSC_PAIRS - 1 */
enum { VMI_OSC_PAIRS = 5 };

VM_API vmi_osc_points vmi_osc_pair(int i)
{
    switch (i) {
    case 0: return vmi_osc_points_of(6, 8, 1);
    case 1: return vmi_osc_points_of(8, 11, 1);
    case 2: return vmi_osc_points_of(10, 14, 1);
    case 3: return vmi_osc_points_of(10, 14, 2);
    default: return vmi_osc_points_of(14, 20, 2);
    }
}

/* One pair of runs from 0 to t: the state at t in *strict, the estimate of its error in *error */
VM_API int vmi_osc_collocate_pair(const vm_osc_plan *plan, vm_real t, vmi_osc_points points, vm_real longest,
                                  vm_real sweep_limit, vmi_osc_course *strict, vm_real *error)
{
    const int side = vmi_time_side(t);
    const vm_real factor = VM_C(0.25); /* the error of the strict run is taken for this part of the difference */
    const vm_real looser = 16;         /* so that errors of the iteration, too, make a difference */
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
    *error = factor * difference + 2 * VM_SQRT(strict->left) + 4 * VM_EPSILON * (2 + VM_FABS(strict->psi - state.psi));
    return status;
}

/* The motion at t by collocation. VM_TOLERANCE_MISSED: the motion is there, but the estimate of the error is larger than
   the tolerance. VM_NOT_INTEGRATED where amplitude and phase do not describe the motion, since mass, stiffness or force
   change as fast as the phase, or after 2^23 periods; the statuses of the laws. */
VM_API int vmi_osc_collocate(const vm_osc_plan *plan, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_real sweep_limit = vmi_larger(tolerance / 16, 4 * VM_EPSILON);
    const int first = plan->problem.force ? 3 : 0;
    vm_osc_motion result;
    vmi_osc_course c;
    vmi_osc_reduced state;
    vmi_osc_rates now;
    vm_real error = VM_INFINITY, sa, ca;
    long evals = 0;
    vm_real longest;
    int i, status = vmi_osc_law_step(plan, t, &longest);
    if (status) return status;
    for (i = first; i < VMI_OSC_PAIRS && !(error <= tolerance); i++) {
        status = vmi_osc_collocate_pair(plan, t, vmi_osc_pair(i), 2 * longest, sweep_limit, &c, &error);
        if (status) return status;
        evals += c.evals;
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
