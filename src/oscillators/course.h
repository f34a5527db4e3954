/* oscillators/course.h - a run of an oscillator that goes in steps from each zero of x to the next

   The exact equations of oscillators/reduction.h for the amplitude A and the phase psi, with a further force F, are
     (ln A)' = -p + W E sa ca - 2/(alpha+1) f sa,   psi' = W (1 + (alpha+1)/2 E ca^2) - f ca,
   with
     E = (p^2 - a p - p')/W^2,   f = F/(m V),   V = 2 A W/(alpha+1).
   There x and x' + p x define A and psi. If x and x' define A and psi, the exact equations are
     (ln A)' = -(q sa + 2 f) sa/(alpha+1),   psi' = W - (q/2 sa + f) ca,   q = (alpha+3) p.
   With a force a run uses these equations (by_velocity), so that a force that jumps where x' = 0, such as dry friction,
   jumps where sa = 0, where two steps meet. Without a force it uses the equations with E, which is small.
   sa and ca are the Ateb sine and cosine of psi, m is the mass, alpha the exponent of the spring, and V the largest
   velocity. p is the slow rate at which ln A decreases, a is (reactive m' + b)/m with the damping b, and W is the rate
   of psi for constant mass and stiffness. The equations are solved with psi as the independent variable: each step
   integrates ln A and t from one zero of x to the next. For most alpha the force of the spring is not smooth at x = 0.
   But the steps end at x = 0, so this point never lies inside a step, where it would cause the largest errors.

   A step uses Gauss' collocation: polynomials approximate the rates, and satisfy the equations exactly at n points of
   the step, the nodes. These conditions are solved by iteration in several rounds. The first round starts from values
   that are extrapolated from the earlier steps.

   Without a force the rates of ln A and t consist of slow functions and of a swing. The swing is proportional to E and
   varies like ca^2 and sa ca. A polynomial through few nodes approximates the slow functions well, but not ca^2 and sa
   ca. The integrals of ca^2 and sa ca have closed forms (oscillators/ripple.h). So the errors of Gauss' rule in these
   integrals are known, and each step corrects them. Then 2 or 3 nodes per step are enough for errors of 1e-8. With a
   force there are no closed forms; a half period then has two steps, which meet where sa = 0. If a force acts and alpha
   is less than 3 and not 1, the nodes lie closer together at the ends of the steps (vmi_gauss_rule_grade).
       vmi_osc_course c;
       int status;
       vmi_osc_course_start(&c, &plan, &reduced, 1, 4, 1, VM_C(1e-12)); // the vm_osc_plan plan, reduced at t = 0
       c.stop = 10;
       status = vmi_osc_course_step(&c); // to the first zero of x, or to 10 s
   Source: Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1.2 and VIII.6.
   Tests: tests/test_collocation.c. */
#ifndef VARMASS_OSCILLATORS_COURSE_H
#define VARMASS_OSCILLATORS_COURSE_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "gauss_rule.h"
#include "legendre.h"
#include "plan.h"
#include "problem.h"
#include "reduction.h"
#include "ripple.h"
#include "waves.h"

/* The largest number of earlier steps from which a step is extrapolated */
enum { VMI_HISTORY = 7 };

/* -- A run -- */

/* sa and ca at the nodes of a step, and the errors `misses` of Gauss' rule: the exact integral minus the result of the
   rule, for the four functions ca^2, (x - 1/2) ca^2, sa ca and (x - 1/2) sa ca. x goes from 0 at the start of the step
   to 1 at its end. Row i < n of `misses` is for the integrals over x from 0 to node i, row n for the integrals from 0
   to 1. */
enum { VMI_MISSES_CA2, VMI_MISSES_CA2_X, VMI_MISSES_SACA, VMI_MISSES_SACA_X, VMI_MISSES };
typedef struct VM_TAG(vmi_step_waves) {
    vm_real sa[VMI_NODES], ca[VMI_NODES];
    vm_real misses[VMI_NODES + 1][VMI_MISSES];
} vmi_step_waves;

/* The rates of a step: derivatives of ln A and t with respect to the phase psi, at the nodes of the step */
typedef struct VM_TAG(vmi_step_rates) {
    vm_real ln_A[VMI_NODES], t[VMI_NODES];
    vm_real E[2]; /* E = (p^2 - a p - p')/W^2 at the first and at the last node */
} vmi_step_rates;

/* A run, that is one computation of the motion from 0 to t. A half period goes from one zero of ca to the next. A half
   period has one part, or two parts that meet where sa = 0. Each step covers one part, unless the step starts or ends
   inside a part. */
typedef struct VM_TAG(vmi_osc_course) {
    const vm_osc_plan *plan;
    vmi_osc_wave wave;
    vmi_gauss_rule rule;
    int side;              /* 1 forward, -1 backward in time */
    int parts;             /* number of parts of a half period, 1 or 2 */
    int by_velocity;       /* 1 if x and x' define amplitude and phase, 0 if x and V = x' + p x define them */
    vm_real stop;          /* time, s, at which a step must end: a point of a table or the end of the run. Mass and
                              stiffness are not evaluated beyond it */
    vm_real longest;       /* the longest step, s */
    vm_real sweep_limit;   /* the iteration of a step ends when the estimated error of the phase is at most this
                              number */
    vm_real psi, ln_A, t;  /* phase, ln(A/A0) with the amplitude A0 of the plan, time, s */
    vm_real A;             /* amplitude, m; only set for problems with a force */
    vm_real Om;            /* rate of the phase, 1/s, at this amplitude with the mass and stiffness at time 0 */
    vm_real t_low;         /* the exact time is t + t_low, s */
    vm_real left;          /* an upper bound of the sum of the errors of the phase that the iterations of all steps
                              leave */
    vm_real contraction;   /* factor by which a round of the iteration reduces its error */
    vm_real rate;          /* rate of the phase at the end of the last step, 1/s */
    vmi_step_waves waves[2];                 /* sa, ca and `misses` for each part of a half period */
    vmi_step_rates difference[2][VMI_HISTORY]; /* for each part: the rates of the last step that covered the whole part,
                                                  and the backward differences of these rates from one such step to the
                                                  next */
    int known[2];          /* number of earlier steps over each part from which `difference` was computed */
    int halved;            /* how often a step was halved because its iteration did not converge */
    long evals;            /* number of evaluations of the rates */
} vmi_osc_course;

/* Sets the amplitude of the run, and the rate Om of the phase, from ln(A/A0). */
VM_API void vmi_osc_course_amplitude(vmi_osc_course *c, vm_real ln_A)
{
    const vm_osc_plan *plan = c->plan;
    c->ln_A = ln_A;
    c->A = plan->problem.force ? plan->A * vmi_exp(ln_A, 0) : 0;
    c->Om = plan->Om * vmi_exp((plan->problem.alpha - 1) / 2 * ln_A, 0);
}

/* -- What Gauss' rule misses -- */

/* Writes the functions C, S and S2 of oscillators/ripple.h at the phase psi to *f. */
VM_API void vmi_osc_course_ripple(const vmi_osc_course *c, vm_real psi, vmi_ripple_values *f)
{
    vm_real sa, ca;
    vmi_osc_wave_at(&c->wave, psi, &ca, &sa);
    vmi_ripple_at(&c->plan->ripple, 4, psi, sa, ca, f);
}

/* Writes the integrals over x of the four functions of vmi_step_waves, from the start of the step, where x = 0, to the
   given x. `length` is the length of the step in phase. *first contains the functions C, S and S2 of
   oscillators/ripple.h at the start of the step, *now these functions at x. The integral of ca^2 over psi is <ca^2> psi
   + S, where <> is the mean over a period; the integral of sa ca is -(alpha+1)/4 ca^2. Integration by parts gives the
   integrals with the factor x - 1/2. */
VM_API void vmi_osc_wave_integrals(const vmi_ripple *r, const vmi_ripple_values *first, const vmi_ripple_values *now,
                                   vm_real x, vm_real length, vm_real *sum)
{
    const vm_real psi = x * length, from_middle = x - VM_C(0.5), quarter = (r->alpha + 1) / 4;
    const vm_real ca2 = r->mean2 * psi + (now->S - first->S), saca = quarter * (first->C - now->C);
    /* the integrals over psi of the integrals of ca^2 and of sa ca */
    const vm_real ca2_twice = r->mean2 * psi * psi / 2 + (now->S2 - first->S2) - first->S * psi;
    const vm_real saca_twice = quarter * (first->ca * first->ca * psi - ca2);
    sum[VMI_MISSES_CA2] = ca2 / length;
    sum[VMI_MISSES_CA2_X] = (from_middle * ca2 - ca2_twice / length) / length;
    sum[VMI_MISSES_SACA] = saca / length;
    sum[VMI_MISSES_SACA_X] = (from_middle * saca - saca_twice / length) / length;
}

/* Subtracts the results of Gauss' rule from the four integrals in row i of w->misses, so that the errors of the rule
   are left. */
VM_API void vmi_osc_subtract_rule(const vmi_gauss_rule *rule, int i, vmi_step_waves *w)
{
    vm_real *misses = w->misses[i];
    int j;
    for (j = 0; j < rule->n; j++) {
        const vm_real from_middle = rule->node[j] - VM_C(0.5);
        const vm_real ca2 = rule->integral[i][j] * w->ca[j] * w->ca[j];
        const vm_real saca = rule->integral[i][j] * w->sa[j] * w->ca[j];
        misses[VMI_MISSES_CA2] -= ca2;
        misses[VMI_MISSES_CA2_X] -= from_middle * ca2;
        misses[VMI_MISSES_SACA] -= saca;
        misses[VMI_MISSES_SACA_X] -= from_middle * saca;
    }
}

/* Writes sa and ca at the nodes of a step that starts at the phase `from`, and the errors w->misses of Gauss' rule in
   the integrals of ca^2 and sa ca over this step. In a very short step the computed values of these errors would only
   be rounding errors, so the function writes 0. */
VM_API void vmi_osc_course_waves(const vmi_osc_course *c, vm_real from, vm_real length, vmi_step_waves *w)
{
    const vm_real very_short = VM_SQRT(VM_SQRT(VM_EPSILON));
    const vmi_gauss_rule *rule = &c->rule;
    vmi_ripple_values first, now;
    int i, k;
    vmi_osc_course_ripple(c, from, &first);
    for (i = 0; i <= rule->n; i++) {
        const vm_real x = i < rule->n ? rule->node[i] : 1;
        vmi_osc_course_ripple(c, from + length * x, &now);
        vmi_osc_wave_integrals(&c->plan->ripple, &first, &now, x, length, w->misses[i]);
        if (i == rule->n) break;
        w->sa[i] = now.sa;
        w->ca[i] = now.ca;
    }
    for (i = 0; i <= rule->n; i++) vmi_osc_subtract_rule(rule, i, w);
    if (VM_FABS(length) > very_short) return;
    for (i = 0; i <= rule->n; i++)
        for (k = 0; k < VMI_MISSES; k++) w->misses[i][k] = 0;
}

/* Returns 1 if the nodes must lie closer together at the ends of a step (vmi_gauss_rule_grade), else 0. With a force
   the rates contain sa^2, and often other functions of the velocity. Therefore they contain d^(alpha+1), where d is the
   distance from a zero of x. For most alpha this is no integer power, so the rates are not smooth at d = 0. From alpha
   = 3 on the power is so high that the errors of the rule are small enough. */
VM_API int vmi_osc_needs_grading(const vm_osc_problem *o) { return o->force && o->alpha < 3 && o->alpha != 1; }

/* -- Rates and changes -- */

/* Changes of ln A and of the time t (in seconds) over a step or a part of it */
typedef struct VM_TAG(vmi_osc_change) {
    vm_real ln_A, t;
} vmi_osc_change;

/* A step that is being computed; it starts at the present state of the run */
typedef struct VM_TAG(vmi_osc_step) {
    vm_real length;              /* length in phase */
    vm_real sign;                /* factor of sa and ca: -1 in every second half period, else 1 */
    const vmi_step_waves *waves; /* sa and ca at the nodes, without the factor `sign` */
    vmi_step_rates rates;        /* rates at the nodes by the last round of the iteration */
    vm_real swing_t[2];          /* the swing of the rate of t is (swing_t[0] + (x - 1/2) swing_t[1]) ca^2 */
    vm_real swing_ln_A[2];       /* the swing of the rate of ln A is (swing_ln_A[0] + (x - 1/2) swing_ln_A[1]) sa ca,
                                    minus p times the swing of t */
    vm_real p;                   /* the rate p in the middle of the step, 1/s */
    vmi_osc_change whole;        /* the changes over the whole step */
} vmi_osc_step;

/* The state at a node: mass, stiffness and their rates, and the changes since the start of the step */
typedef struct VM_TAG(vmi_step_node) {
    vmi_osc_rates now;
    vm_real p_rate; /* time derivative of now.p */
    vm_real t;      /* time, s */
    vmi_osc_change moved;
} vmi_step_node;

/* Returns e^x. Changes within a step are mostly small; for |x| <= 1/16 the function uses the power series of e^x,
   otherwise vmi_exp. */
VM_API vm_real vmi_osc_exp_of_change(vm_real x)
{
    const vm_real most = VM_C(0.0625), xx = x * x;
    const vm_real low = 1 + x + xx * (VM_C(0.5) + x * VM_C(0.16666666666666666667));
    const vm_real middle = VM_C(0.041666666666666666667) + x * VM_C(0.0083333333333333333333) +
                           xx * (VM_C(0.0013888888888888888889) + x * VM_C(1.984126984126984127e-4));
    const vm_real high = VM_C(2.4801587301587301587e-5) + x * VM_C(2.7557319223985890653e-6);
    if (!(VM_FABS(x) <= most)) return vmi_exp(x, 0);
    return low + xx * xx * (middle + xx * xx * high);
}

/* Writes the derivatives of ln A and t with respect to the phase at node i, and E = (p^2 - a p - p')/W^2 at this node.
   E is 0 if c->by_velocity is 1, since the equations then do not contain it. */
VM_API int vmi_osc_course_rates(const vmi_osc_course *c, const vmi_osc_step *s, int i, const vmi_step_node *at,
                                vm_real *ln_A_by_psi, vm_real *t_by_psi, vm_real *E)
{
    const vm_osc_plan *plan = c->plan;
    const vm_osc_problem *o = &plan->problem;
    const vm_real least_rate = VM_C(0.03); /* if psi'/W is below this number, the motion is no vibration */
    const vm_real most_fast = 8; /* if |p| + |a| is more than W times this number, mass or stiffness change so fast that
                                    the motion is no vibration, unless t is so near 0 that the change has no effect */
    const vm_real n = o->alpha + 1, sa = s->sign * s->waves->sa[i], ca = s->sign * s->waves->ca[i];
    const vmi_osc_rates *now = &at->now;
    const vm_real omega_ratio = VM_SQRT((now->k / plan->k0) / (now->m / plan->m0));
    const vm_real W = c->Om * omega_ratio * vmi_osc_exp_of_change((o->alpha - 1) / 2 * at->moved.ln_A);
    const vm_real fast = VM_FABS(now->p) + VM_FABS(now->a);
    vm_real rate, ln_A_rate;
    *E = (now->p * (now->p - now->a) - at->p_rate) / (W * W);
    rate = 1 + n / 2 * *E * ca * ca;
    ln_A_rate = -now->p + W * *E * sa * ca;
    if (c->by_velocity) {
        const vm_real q = (n + 2) * now->p;
        *E = 0;
        rate = 1 - q / 2 * sa * ca / W;
        ln_A_rate = -q / n * sa * sa;
    }
    if (o->force) {
        const vm_real A = c->A * vmi_osc_exp_of_change(at->moved.ln_A), V = 2 * A * W / n, x = A * ca;
        const vm_real v = c->by_velocity ? -V * sa : -V * sa - now->p * x;
        const vm_real f = o->force(at->t, x, v, o->ctx) / (now->m * V);
        rate -= f * ca / W;
        ln_A_rate -= 2 / n * f * sa;
    }
    if (!(fast <= most_fast * W) && !(fast / W * (fast * VM_FABS(at->t)) <= VM_EPSILON)) return VM_NOT_INTEGRATED;
    *t_by_psi = 1 / (W * rate);
    *ln_A_by_psi = ln_A_rate * *t_by_psi;
    if (!(rate > least_rate) || !VM_IS_FINITE(*t_by_psi) || !VM_IS_FINITE(*ln_A_by_psi)) return VM_NOT_INTEGRATED;
    return VM_OK;
}

/* The changes of ln A and t from the start of the step to node i, or over the whole step for i = n */
VM_API vmi_osc_change vmi_osc_change_to(const vmi_osc_course *c, const vmi_osc_step *s, int i)
{
    const vm_real *weight = c->rule.integral[i], *misses = s->waves->misses[i];
    vm_real t = s->swing_t[0] * misses[VMI_MISSES_CA2] + s->swing_t[1] * misses[VMI_MISSES_CA2_X];
    vm_real ln_A = s->swing_ln_A[0] * misses[VMI_MISSES_SACA] + s->swing_ln_A[1] * misses[VMI_MISSES_SACA_X] - s->p * t;
    vmi_osc_change sum;
    int j;
    for (j = 0; j < c->rule.n; j++) {
        ln_A += weight[j] * s->rates.ln_A[j];
        t += weight[j] * s->rates.t[j];
    }
    sum.ln_A = ln_A * s->length;
    sum.t = t * s->length;
    return sum;
}

/* Sets what follows from the rates of a step: the swing, and the changes over the whole step. To first order in E,
   dt/dpsi = (1 - (alpha+1)/2 E ca^2)/W and d ln A/dpsi = -p dt/dpsi + E sa ca. The integral of E sa ca is -(alpha+1)/4
   E ca^2; this is the swing of ln A. W is proportional to A^((alpha-1)/2), so the swing of ln A adds
   (alpha-1)(alpha+1)/8 E ca^2/W to dt/dpsi. */
VM_API void vmi_osc_complete_step(const vmi_osc_course *c, vmi_osc_step *s)
{
    const vm_real alpha = c->plan->problem.alpha, factor = (alpha + 1) * (alpha - 5) / 8;
    const int last = c->rule.n - 1, middle = c->rule.n / 2;
    const vmi_step_rates *rates = &s->rates;
    const vm_real first_t = factor * rates->E[0] * rates->t[0], last_t = factor * rates->E[1] * rates->t[last];
    const vm_real per_x = 1 / (c->rule.node[last] - c->rule.node[0]);
    s->swing_t[0] = (first_t + last_t) / 2;
    s->swing_t[1] = (last_t - first_t) * per_x;
    s->swing_ln_A[0] = (rates->E[0] + rates->E[1]) / 2;
    s->swing_ln_A[1] = (rates->E[1] - rates->E[0]) * per_x;
    s->p = -rates->ln_A[middle] / rates->t[middle];
    s->whole = vmi_osc_change_to(c, s, c->rule.n);
}

/* -- The iteration of a step -- */

/* Adds the corrections `missing` that a round of the iteration found to the rates of a step. Also adds estimates of
   further corrections: `missing` shifts ln A and t at the nodes, and these shifts change the rates, mostly because W
   depends on ln A and t. *now contains mass, stiffness and their rates at about the middle of the step. */
VM_API void vmi_osc_correct(const vmi_osc_course *c, const vmi_osc_rates *now, const vmi_step_rates *missing,
                            vmi_osc_step *s)
{
    const vm_real alpha = c->plan->problem.alpha;
    /* derivatives of ln(dt/dpsi) with respect to t and to ln A */
    const vm_real by_t = -((alpha + 3) * now->p - 2 * now->a) / 2, by_ln_A = -(alpha - 1) / 2;
    vm_real slope[VMI_NODES]; /* how fast the change of ln(dt/dpsi) grows along the step */
    int i, j;
    for (j = 0; j < c->rule.n; j++) slope[j] = s->length * (by_t * missing->t[j] + by_ln_A * missing->ln_A[j]);
    for (i = 0; i < c->rule.n; i++) {
        vm_real sum = 0, change;
        for (j = 0; j < c->rule.n; j++) sum += c->rule.integral[i][j] * slope[j];
        change = s->rates.t[i] * sum;
        s->rates.t[i] += missing->t[i] + change;
        s->rates.ln_A[i] += missing->ln_A[i] - now->p * change;
    }
}

/* Finds the time derivatives of p at the nodes from the polynomial through the values of p. It is called where a user's
   function gives mass or stiffness, since such a function gives no second derivatives. */
VM_API void vmi_osc_find_p_rates(const vmi_osc_course *c, const vmi_osc_step *s, vmi_step_node *at)
{
    const vm_real too_short = 256 * VM_EPSILON; /* in so short a step, differences of p are rounding errors */
    int i, j;
    if (VM_FABS(s->length) < too_short) return;
    for (i = 0; i < c->rule.n; i++) {
        vm_real sum = 0;
        for (j = 0; j < c->rule.n; j++) sum += c->rule.derivative[i][j] * at[j].now.p;
        at[i].p_rate = sum / (s->length * s->rates.t[i]);
    }
}

/* Finds the state at each node from the present rates of the step. While the iteration has not converged, the rates may
   put a node before the start of the step or beyond c->stop. There the laws need not have values. Therefore the state
   at the start of the step or at c->stop is taken instead. */
VM_API int vmi_osc_find_nodes(const vmi_osc_course *c, const vmi_osc_step *s, vmi_step_node *at)
{
    const vm_osc_problem *o = &c->plan->problem;
    int i;
    for (i = 0; i < c->rule.n; i++) {
        int side = c->side, status;
        at[i].moved = vmi_osc_change_to(c, s, i);
        at[i].t = c->t + (c->t_low + at[i].moved.t);
        if ((vm_real)side * (at[i].t - c->t) < 0) at[i].t = c->t;
        if ((vm_real)side * (at[i].t - c->stop) >= 0) {
            at[i].t = c->stop;
            side = -side;
        }
        status = vmi_osc_rates_and_slope(o, at[i].t, side, &at[i].now, &at[i].p_rate);
        if (status) return status;
    }
    if (vmi_osc_has_user_law(o)) vmi_osc_find_p_rates(c, s, at);
    return VM_OK;
}

/* Makes one round of the iteration. *change becomes the largest change of the rates at a node in this round, times the
   length of the step. */
VM_API int vmi_osc_sweep(vmi_osc_course *c, vmi_osc_step *s, vm_real *change)
{
    const int n = c->rule.n;
    const vm_real length = VM_FABS(s->length);
    vmi_step_node at[VMI_NODES];
    vmi_step_rates missing;
    vm_real E[VMI_NODES];
    int i, status = vmi_osc_find_nodes(c, s, at);
    if (status) return status;
    *change = 0;
    for (i = 0; i < n; i++) {
        const vm_real old_ln_A = s->rates.ln_A[i], old_t = s->rates.t[i];
        vm_real new_ln_A, new_t;
        status = vmi_osc_course_rates(c, s, i, &at[i], &new_ln_A, &new_t, &E[i]);
        if (status) return status;
        missing.ln_A[i] = new_ln_A - old_ln_A;
        missing.t[i] = new_t - old_t;
        *change = vmi_larger((VM_FABS(missing.t[i] / old_t) + VM_FABS(missing.ln_A[i])) * length, *change);
    }
    vmi_osc_correct(c, &at[n / 2].now, &missing, s);
    s->rates.E[0] = E[0];
    s->rates.E[1] = E[n - 1];
    vmi_osc_complete_step(c, s);
    c->evals += n;
    return VM_OK;
}

/* Makes rounds of the iteration until the estimated error of the phase is at most c->sweep_limit, or until only
   rounding errors are left. The iteration starts from the rates in s->rates. The error of the phase after a round is
   estimated as the change of the phase in this round, times c->contraction. Returns VM_NOT_INTEGRATED if the rounds do
   not converge, or if they lead to rates with which the time would not grow everywhere in the step; then amplitude and
   phase do not describe the motion. */
VM_API int vmi_osc_iterate(vmi_osc_course *c, vmi_osc_step *s)
{
    const vm_real least_contraction = VM_C(0.005); /* least value of c->contraction, since the next steps may converge
                                                      more slowly */
    const vm_real rounding = VM_SQRT(VM_EPSILON) / 16; /* in short steps the derivative p' has rounding errors of this
                                                          size, which further rounds do not reduce */
    const int most_rounds = 40;
    vm_real change, before = 0;
    int i, sweeps, status;
    for (sweeps = 0; sweeps < most_rounds; sweeps++) {
        status = vmi_osc_sweep(c, s, &change);
        if (status) return status;
        if (before > 0) c->contraction = vmi_smaller(vmi_larger(change / before, least_contraction), 1);
        if (change * c->contraction <= c->sweep_limit) break;
        if (sweeps > 2 && !(change < before)) break;
        before = change;
    }
    if (change * c->contraction > c->sweep_limit && !(change <= rounding)) return VM_NOT_INTEGRATED;
    for (i = 0; i < c->rule.n; i++)
        if (!(s->rates.t[i] > 0)) return VM_NOT_INTEGRATED;
    c->left += change * c->contraction;
    return VM_OK;
}

/* Sets the rates from which the iteration of a step starts. They are extrapolated from earlier whole steps over the
   same part of a half period. If there are no such steps, the rates at all nodes are those at the start of the step,
   without the disturbance E = (p^2 - a p - p')/W^2 and without the force F. */
VM_API int vmi_osc_predict(const vmi_osc_course *c, int part, vmi_osc_step *s)
{
    const vmi_step_rates *difference = c->difference[part];
    vmi_step_rates *rates = &s->rates;
    vmi_osc_rates now;
    vm_real rate;
    int i, k, status;
    rates->E[0] = rates->E[1] = 0;
    if (c->known[part] == 0) {
        status = vmi_osc_rates_at(&c->plan->problem, c->t, c->side, &now);
        if (status) return status;
        rate = 1 / (c->Om * VM_SQRT((now.k / c->plan->k0) / (now.m / c->plan->m0)));
        for (i = 0; i < c->rule.n; i++) {
            rates->ln_A[i] = -now.p * rate;
            rates->t[i] = rate;
        }
        return VM_OK;
    }
    for (i = 0; i < c->rule.n; i++) { /* the next value of a polynomial is the sum of its backward differences */
        vm_real ln_A = 0, t = 0;
        for (k = 0; k < c->known[part]; k++) {
            ln_A += difference[k].ln_A[i];
            t += difference[k].t[i];
        }
        rates->ln_A[i] = ln_A;
        rates->t[i] = t;
    }
    for (k = 0; k < c->known[part]; k++) {
        rates->E[0] += difference[k].E[0];
        rates->E[1] += difference[k].E[1];
    }
    return VM_OK;
}

/* Advances the state of the run by the step *s. */
VM_API void vmi_osc_take(vmi_osc_course *c, const vmi_osc_step *s)
{
    const vm_real change = c->t_low + s->whole.t, t = c->t + change;
    c->t_low = change - (t - c->t);
    c->t = t;
    vmi_osc_course_amplitude(c, c->ln_A + s->whole.ln_A);
    c->psi += s->length;
    c->rate = 1 / s->rates.t[c->rule.n - 1];
}

/* Writes *value minus *kept to *value, and the old *value to *kept. */
VM_API void vmi_keep_and_subtract(vm_real *kept, vm_real *value)
{
    const vm_real difference = *value - *kept;
    *kept = *value;
    *value = difference;
}

/* Updates the backward differences of the rates of ln A and t with the rates of a whole step. From these differences
   vmi_osc_predict extrapolates the rates of the next step over the same part (first or second) of a half period. */
VM_API void vmi_osc_remember(vmi_osc_course *c, int part, const vmi_step_rates *rates)
{
    const int known = c->known[part];
    int i, k;
    vmi_step_rates *difference = c->difference[part];
    for (i = 0; i < c->rule.n; i++) {
        vm_real ln_A = rates->ln_A[i], t = rates->t[i];
        for (k = 0; k < known; k++) {
            vmi_keep_and_subtract(&difference[k].ln_A[i], &ln_A);
            vmi_keep_and_subtract(&difference[k].t[i], &t);
        }
        if (known < VMI_HISTORY) {
            difference[known].ln_A[i] = ln_A;
            difference[known].t[i] = t;
        }
    }
    for (i = 0; i < 2; i++) {
        vm_real E = rates->E[i];
        for (k = 0; k < known; k++) vmi_keep_and_subtract(&difference[k].E[i], &E);
        if (known < VMI_HISTORY) difference[known].E[i] = E;
    }
    if (known < VMI_HISTORY) c->known[part] = known + 1;
}

/* -- A step that ends at a given time -- */

/* Returns the fraction of the step at which the time t is reached. Newton's method finds it from the Legendre series of
   dt/dpsi, or of dt/dx in a graded rule (vmi_gauss_rule_grade). */
VM_API vm_real vmi_osc_find_part(const vmi_osc_course *c, const vmi_osc_step *s, vm_real t)
{
    const int rounds = 8;
    const vm_real way = (t - c->t) - c->t_low;
    vm_real series[VMI_GAUSS], part, slope;
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) series[k] = 0;
    for (i = 0; i < c->rule.n; i++) {
        vm_real before = 0, now = 1;
        for (k = 0; k < c->rule.n; k++) {
            const vm_real next = vmi_legendre_next(k, 2 * c->rule.place[i] - 1, now, before);
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
    return c->rule.graded ? vmi_graded(part) : part;
}

/* Makes a step that ends at c->stop. This step replaces the longer step `beyond`, which would go past c->stop.
   `certain` is 0 if the end of `beyond` is only a prediction. If in this case the step to c->stop is longer than
   `beyond`, phase, amplitude and time of the run stay unchanged, since no step may cross a zero of x. */
VM_API int vmi_osc_land(vmi_osc_course *c, const vmi_osc_step *beyond, int certain)
{
    const int rounds = 6;
    const vm_real way = (c->stop - c->t) - c->t_low;
    const vm_real part = vmi_osc_find_part(c, beyond, c->stop);
    vmi_step_waves waves;
    vmi_osc_step s;
    int i, attempt, status;
    s.sign = 1;
    s.waves = &waves;
    s.length = part * beyond->length;
    for (i = 0; i < c->rule.n; i++) {
        s.rates.t[i] = beyond->rates.t[i];
        s.rates.ln_A[i] = beyond->rates.ln_A[i];
    }
    s.rates.E[0] = beyond->rates.E[0];
    s.rates.E[1] = beyond->rates.E[1];
    for (attempt = 0; attempt < rounds; attempt++) {
        vm_real missing, largest = 1; /* the largest |d ln A/dpsi|, but at least 1 */
        vmi_osc_course_waves(c, c->psi, s.length, &waves);
        vmi_osc_complete_step(c, &s);
        status = vmi_osc_iterate(c, &s);
        if (status == VM_NOT_INTEGRATED && !certain) return VM_OK;
        if (status) return status;
        missing = (way - s.whole.t) / s.rates.t[c->rule.n - 1];
        for (i = 0; i < c->rule.n; i++) largest = vmi_larger(VM_FABS(s.rates.ln_A[i]), largest);
        if (VM_FABS(missing) * largest <= c->sweep_limit) break;
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
   index, 0 or 1, of the part of the half period that the step covers, or -1 where the step starts inside a part. *sign
   becomes the factor of sa and ca in this step. */
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

/* Returns 1 if the step, by its present rates, ends at or beyond c->stop, else 0. */
VM_API int vmi_osc_is_beyond(const vmi_osc_course *c, const vmi_osc_step *s)
{
    return (vm_real)c->side * ((c->t - c->stop) + (c->t_low + s->whole.t)) >= 0;
}

/* Rounds the length of a step from the phase psi, so that the phase at the end of the step is a number of the type
   vm_real. Thus the phase has no rounding errors that would add up over many short steps. A length below VM_EPSILON
   |psi| is replaced by about this number. Returns 0 only if psi and `length` are 0 or so small that they underflow. */
VM_API vm_real vmi_osc_short_length(vm_real psi, vm_real length)
{
    const vm_real least = VM_EPSILON * VM_FABS(psi); /* between one and two ulps of psi */
    const vm_real size = vmi_larger(VM_FABS(length), least);
    return (psi + VM_COPYSIGN(size, length)) - psi;
}

/* Makes one step. The argument `most` is between 0 and 1: the step is at most this fraction of the phase up to the end
   of the present part of the half period. By the predicted rates, a step takes at most the time c->longest. Both limits
   are exceeded where the phase is so large, or grows so slowly, that it would stay the same number. If the step would
   go beyond c->stop, it is shortened to end at c->stop. */
VM_API int vmi_osc_course_step_of(vmi_osc_course *c, vm_real most)
{
    vmi_step_waves inside;
    vmi_osc_step s;
    vm_real share, shortened;
    int part, status;
    s.length = vmi_osc_next_phase(c, &part, &s.sign) - c->psi;
    status = vmi_osc_predict(c, part < 0 ? 0 : part, &s);
    if (status) return status;
    share = vmi_smaller(c->longest / VM_FABS(s.length * s.rates.t[c->rule.n / 2]), most);
    shortened = vmi_osc_short_length(c->psi, share * s.length);
    if (share < 1 && shortened != 0) {
        s.length = shortened;
        part = -1;
    }
    if (part < 0) {
        s.sign = 1;
        s.waves = &inside;
        vmi_osc_course_waves(c, c->psi, s.length, &inside);
    } else s.waves = &c->waves[part];
    vmi_osc_complete_step(c, &s);
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

/* Makes one step. If the iteration of the step does not converge, the function tries shorter and shorter steps. */
VM_API int vmi_osc_course_step(vmi_osc_course *c)
{
    const vm_real shortest = VM_C(0.01); /* steps below this fraction of their full length are not halved */
    vm_real most = 1;
    int status = vmi_osc_course_step_of(c, most);
    while (status == VM_NOT_INTEGRATED && most > shortest) {
        most /= 2;
        c->halved++;
        c->contraction = VM_C(0.1);
        status = vmi_osc_course_step_of(c, most);
    }
    return status;
}

/* Starts a run at t = 0 from the amplitude and phase in *start, with n points per step and `parts` parts per half
   period. `side` is 1 for a run forward in time, -1 for a run backward. With a force x and x' must define amplitude and
   phase, unless the caller sets c->by_velocity to 0 after this call. */
VM_API void vmi_osc_course_start(vmi_osc_course *c, const vm_osc_plan *plan, const vmi_osc_reduced *start, int side,
                                 int n, int parts, vm_real sweep_limit)
{
    const vm_real half = plan->ripple.pi;
    vm_real from, length = (vm_real)side * half / (vm_real)parts;
    int part;
    c->plan = plan;
    c->wave = vmi_osc_wave_of(plan, VM_ROUTE_COLLOCATION);
    vmi_gauss_rule_init(&c->rule, n);
    if (vmi_osc_needs_grading(&plan->problem)) vmi_gauss_rule_grade(&c->rule);
    c->side = side;
    c->parts = parts;
    c->by_velocity = plan->problem.force != NULL;
    c->sweep_limit = sweep_limit;
    c->stop = 0;
    c->longest = VM_INFINITY;
    c->psi = start->psi;
    vmi_osc_course_amplitude(c, vmi_log(start->A / plan->A).hi);
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
    c->known[0] = 0;
    c->known[1] = 0;
    c->halved = 0;
    c->evals = 0;
}

#endif
