/* oscillators/walk.h - integrals along the mean motion */
#ifndef VARMASS_OSCILLATORS_WALK_H
#define VARMASS_OSCILLATORS_WALK_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "laws.h"
#include "problem.h"
#include "waves.h"

/* -- Integrals of the laws along the motion: int dt/m, int Om dt, int q^2/Om dt -- */
enum { VMI_WALK_ORDERS = 5 };

/* What the walk along the laws from 0 to t gathers. epsilon = q/Om is the small parameter, psi the mean phase. */
typedef struct VM_TAG(vmi_osc_walk) {
    const vm_law *mass, *stiffness;
    const vm_osc_plan *plan; /* null: only the first integral */
    int side;                /* the direction of time */
    vm_real y[3];            /* int dt/m, int Om/Om0 dt, int q^2 Om0/Om dt */
    vm_real fourth;          /* int epsilon^4 + (depsilon/dpsi)^2 dpsi */
    vm_real change[VMI_WALK_ORDERS]; /* int |d^k epsilon/dpsi^k| dpsi, but for jumps at points of tables */
    vm_real ln_A;            /* what jumps of q' have done to the mean amplitude */
    vm_real kicks;           /* the sum of their sizes */
    vm_real kick2, kick3;    /* sums of squares of the jumps of h/Om^2, and of (q h + h')/Om^3 */
    vm_real shortest;        /* panel that the laws took, s */
    vm_real error;           /* of the second integral (of the first, where plan is null) */
    int panels;
} vmi_osc_walk;

/* Gauss' rule of 20 points on [-1, 1], 0 <= i < 20 */
enum { VMI_GAUSS = 20 };

VM_API vm_real vmi_gauss_node(int i)
{
    VM_TABLE vm_real node[10] = {VM_C(0.99312859918509492479), VM_C(0.96397192727791379127),
                                 VM_C(0.91223442825132590587), VM_C(0.83911697182221882339),
                                 VM_C(0.74633190646015079261), VM_C(0.63605368072651502545),
                                 VM_C(0.510867001950827098),   VM_C(0.37370608871541956067),
                                 VM_C(0.22778585114164507808), VM_C(0.076526521133497333755)};
    return i % 2 ? VM_READ(node[i / 2]) : -VM_READ(node[i / 2]);
}

VM_API vm_real vmi_gauss_weight(int i)
{
    VM_TABLE vm_real weight[10] = {VM_C(0.017614007139152118312), VM_C(0.040601429800386941331),
                                   VM_C(0.06267204833410906357),  VM_C(0.083276741576704748725),
                                   VM_C(0.10193011981724043504),  VM_C(0.11819453196151841731),
                                   VM_C(0.1316886384491766269),   VM_C(0.14209610931838205133),
                                   VM_C(0.14917298647260374679),  VM_C(0.1527533871307258507)};
    return VM_READ(weight[i / 2]);
}

/* Coefficients a and b of the series of Legendre's polynomials through values at the points of Gauss' rule, of two
   functions at once, since the polynomials are what takes time */
VM_API void vmi_legendre_fit(const vm_real *values_a, const vm_real *values_b, vm_real *a, vm_real *b)
{
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) a[k] = b[k] = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real x = vmi_gauss_node(i), weight = vmi_gauss_weight(i);
        const vm_real share_a = weight * values_a[i], share_b = weight * values_b[i];
        vm_real before = 0, now = 1;
        for (k = 0; k < VMI_GAUSS; k++) {
            const vm_real next = ((vm_real)(2 * k + 1) * x * now - (vm_real)k * before) / (vm_real)(k + 1);
            a[k] += share_a * now;
            b[k] += share_b * now;
            before = now;
            now = next;
        }
    }
    for (k = 0; k < VMI_GAUSS; k++) {
        a[k] *= (vm_real)k + VM_C(0.5);
        b[k] *= (vm_real)k + VM_C(0.5);
    }
}

/* The integral of the series from -1 to x */
VM_API vm_real vmi_legendre_integral(const vm_real *coefficient, vm_real x)
{
    vm_real before = 1, now = x, sum = coefficient[0] * (1 + x);
    int k;
    for (k = 1; k < VMI_GAUSS; k++) {
        const vm_real next = ((vm_real)(2 * k + 1) * x * now - (vm_real)k * before) / (vm_real)(k + 1);
        sum += coefficient[k] * (next - before) / (vm_real)(2 * k + 1);
        before = now;
        now = next;
    }
    return sum;
}

/* The series' derivative, in place: d_k = (2k+1) (c_(k+1) + c_(k+3) + ...) */
VM_API void vmi_legendre_derive(vm_real *coefficient)
{
    vm_real sums[2] = {0, 0};
    int k;
    for (k = VMI_GAUSS - 1; k >= 0; k--) {
        const vm_real own = coefficient[k];
        coefficient[k] = (vm_real)(2 * k + 1) * sums[(k + 1) % 2];
        sums[k % 2] += own;
    }
}

/* The mean square on [-1, 1] */
VM_API vm_real vmi_legendre_square(const vm_real *coefficient)
{
    vm_real sum = 0;
    int k;
    for (k = 0; k < VMI_GAUSS; k++) sum += coefficient[k] * coefficient[k] / (vm_real)(2 * k + 1);
    return sum;
}

/* The largest of the last three coefficients: what the series leaves out is of this size */
VM_API vm_real vmi_legendre_tail(const vm_real *coefficient)
{
    vm_real largest = 0;
    int k;
    for (k = VMI_GAUSS - 3; k < VMI_GAUSS; k++) {
        const vm_real size = VM_FABS(coefficient[k]);
        if (!(size <= largest)) largest = size;
    }
    return largest;
}

/* A panel of the walk: the series of 1/m, Om/Om0 and epsilon on it, and its share of the integrals */
typedef struct VM_TAG(vmi_osc_panel) {
    vm_real edge; /* by how much the series of 1/m and of k miss the laws at the panel's ends, relative */
    vm_real inverse[VMI_GAUSS], ratio[VMI_GAUSS], epsilon[VMI_GAUSS];
    vm_real drift, fourth; /* int q^2 Om0/Om dt, int epsilon^4 dpsi */
} vmi_osc_panel;

/* Om/Om0 where k and m are these and int dt/m is y0 */
VM_API vm_real vmi_osc_walk_ratio(const vmi_osc_walk *w, vm_real m, vm_real k, vm_real y0)
{
    const vm_osc_plan *p = w->plan;
    vm_real ln_A, ln_Om;
    vmi_osc_adiabatic(p, vmi_log(m / p->m0).hi, vmi_log(k / p->k0).hi, p->problem.damping * y0, &ln_A, &ln_Om);
    return vmi_exp(ln_Om + (p->problem.alpha - 1) / 2 * w->ln_A, 0);
}

/* The relative difference between a law and its series (or that of its reciprocal) at the ends of the panel.
   Nothing else shows a kink that lies between an end and the next point of Gauss' rule. */
VM_API int vmi_osc_panel_edge(const vm_law *law, int reciprocal, int side, vm_real start, vm_real length,
                              const vm_real *series, vm_real *edge)
{
    vm_real f[4], sums[2];
    int i, k, status;
    sums[0] = sums[1] = 0;
    for (k = 0; k < VMI_GAUSS; k++) {
        sums[0] += k % 2 ? -series[k] : series[k];
        sums[1] += series[k];
    }
    for (i = 0; i < 2; i++) {
        vm_real miss;
        status = vmi_law_derivatives(law, start + (vm_real)i * length, i ? -side : side, 0, f);
        if (status) return status;
        miss = VM_FABS(sums[i] * (reciprocal ? f[0] : 1 / f[0]) - 1);
        if (!(miss <= *edge)) *edge = miss;
    }
    return VM_OK;
}

VM_API int vmi_osc_panel_of(const vmi_osc_walk *w, vm_real start, vm_real length, vmi_osc_panel *panel)
{
    const int damped = w->plan && w->plan->problem.damping != 0;
    vmi_osc_rates r[VMI_GAUSS];
    vm_real values[VMI_GAUSS], others[VMI_GAUSS], f[4];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        if (w->plan) {
            status = vmi_osc_rates_at(w->plan, t, w->side, 0, r + i);
        } else {
            status = vmi_law_derivatives(w->mass, t, w->side, 0, f);
            r[i].m = r[i].k = f[0];
        }
        if (status) return status;
        values[i] = 1 / r[i].m;
        others[i] = r[i].k;
    }
    vmi_legendre_fit(values, others, panel->inverse, panel->ratio);
    panel->edge = 0;
    status = vmi_osc_panel_edge(w->mass, 1, w->side, start, length, panel->inverse, &panel->edge);
    if (status || !w->plan) return status;
    status = vmi_osc_panel_edge(w->stiffness, 0, w->side, start, length, panel->ratio, &panel->edge);
    if (status) return status;
    panel->drift = panel->fourth = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real way = damped ? length / 2 * vmi_legendre_integral(panel->inverse, vmi_gauss_node(i)) : 0;
        const vm_real ratio = vmi_osc_walk_ratio(w, r[i].m, r[i].k, w->y[0] + way);
        const vm_real share = vmi_gauss_weight(i) / 2 * length, drift = r[i].q * r[i].q / ratio;
        const vm_real epsilon = r[i].q / (w->plan->Om * ratio);
        panel->drift += share * drift;
        panel->fourth += VM_FABS(share * drift) * epsilon * epsilon / w->plan->Om;
        values[i] = ratio;
        others[i] = epsilon;
    }
    vmi_legendre_fit(values, others, panel->ratio, panel->epsilon);
    return VM_OK;
}

/* Whether the panel is short enough for its series. Gauss' rule integrates twice as many terms, so that the error
   of the integrals is about the square of the tail. epsilon may be less accurate. If a law has a kink, no panel is
   short enough for that; what is left out must then not matter. whole is the walk's length. */
VM_API int vmi_osc_panel_resolved(const vmi_osc_walk *w, const vmi_osc_panel *panel, vm_real length, vm_real whole)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(1e-5), epsilon_enough = VM_C(1e-3);
    const vm_real matters = VM_EPSILON / 4 * whole / VM_FABS(length), phase_matters = 16 * VM_EPSILON;
    const vm_real limit = enough > matters ? enough : matters;
    const vm_real *series = w->plan ? panel->ratio : panel->inverse;
    const vm_real edge_enough = 16 * limit; /* where all coefficients left out add up */
    vm_real phase;
    if (!(panel->edge <= edge_enough)) return 0;
    if (!(vmi_legendre_tail(panel->inverse) <= limit * panel->inverse[0])) return 0;
    if (!(vmi_legendre_tail(series) <= limit * series[0])) return 0;
    if (!w->plan) return 1;
    phase = w->plan->Om * panel->ratio[0] * VM_FABS(length);
    return vmi_legendre_tail(panel->epsilon) <=
           epsilon_enough * VM_SQRT(vmi_legendre_square(panel->epsilon)) + phase_matters / phase;
}

/* The panel's share of all that the walk gathers */
VM_API void vmi_osc_walk_add(vmi_osc_walk *w, vmi_osc_panel *panel, vm_real length)
{
    const vm_real size = VM_FABS(length), noise = 1024 * VM_EPSILON;
    vm_real Om, rate, least;
    int k;
    w->panels++;
    w->y[0] += length * panel->inverse[0];
    if (!w->plan) {
        w->error += size * vmi_legendre_tail(panel->inverse) * vmi_legendre_tail(panel->inverse) / panel->inverse[0];
        return;
    }
    w->y[1] += length * panel->ratio[0];
    w->y[2] += panel->drift;
    Om = w->plan->Om * panel->ratio[0];
    rate = 1;
    least = noise * VM_SQRT(vmi_legendre_square(panel->epsilon));
    for (k = 0; k < VMI_GAUSS; k++)
        if (VM_FABS(panel->epsilon[k]) <= least) panel->epsilon[k] = 0;
    for (k = 0; k < VMI_WALK_ORDERS; k++) {
        const vm_real square = vmi_legendre_square(panel->epsilon) * rate * rate;
        w->change[k] += Om * size * VM_SQRT(square);
        if (k == 1) w->fourth += Om * size * square;
        vmi_legendre_derive(panel->epsilon);
        rate *= 2 / (size * Om);
    }
    w->fourth += panel->fourth;
}

/* At t, a point of a table, q' jumps. The motion does not jump, and so goes on with another mean amplitude. This
   holds for small jumps only: a larger one changes only the error estimate. */
VM_API int vmi_osc_knot(vmi_osc_walk *w, vm_real t)
{
    const vm_osc_plan *p = w->plan;
    const vm_real n = p->problem.alpha + 1, largest = VM_C(0.5);
    const vmi_osc_wave wave = vmi_osc_wave_of(VM_ROUTE_ATEB, n - 1, p->pi, p->has_ateb ? &p->ateb : NULL);
    vmi_osc_rates before, after;
    vm_real ca, sa, jump, kick, Om;
    int status = vmi_osc_rates_at(p, t, -w->side, 1, &before);
    if (!status) status = vmi_osc_rates_at(p, t, w->side, 1, &after);
    if (status || before.h == after.h) return status;
    Om = p->Om * vmi_osc_walk_ratio(w, after.m, after.k, w->y[0]);
    jump = (before.h - after.h) / (Om * Om);
    if (VM_FABS(jump) < largest) {
        vmi_osc_phase_from_mean(p, &wave, vmi_osc_mean_phase(p, w->y), after.q * n / (2 * (n + 2) * Om), &ca, &sa);
        kick = n / (4 * (n + 2)) * (ca * ca - p->mean_ca2) * jump;
        w->ln_A += kick;
        w->kicks += VM_FABS(kick);
    }
    w->kick2 += jump * jump;
    jump = jump * jump + (VM_FABS(jump * after.q) + VM_FABS(before.h_rate - after.h_rate) / (Om * Om)) / Om;
    w->kick3 += jump * jump;
    return VM_OK;
}

/* From start to end, between which no table has a point, by panels of at most longest */
VM_API int vmi_osc_walk_piece(vmi_osc_walk *w, vm_real start, vm_real end, vm_real longest, vm_real whole)
{
    const int most_panels = 4096; /* beyond, for laws with noise, panels are no longer halved */
    const vm_real least = whole / VM_C(1099511627776.); /* 2^40 */
    const vm_real side = (vm_real)w->side, most = longest < VM_FABS(end - start) ? longest : VM_FABS(end - start);
    vm_real t = start, size = most;
    int halved = 0;
    while (t != end) {
        vmi_osc_panel panel;
        const vm_real left = VM_FABS(end - t), step = left <= size * VM_C(1.0001) ? left : size;
        int status = vmi_osc_panel_of(w, t, side * step, &panel);
        if (status) return status;
        if (!vmi_osc_panel_resolved(w, &panel, step, whole)) {
            if (step > least && halved < most_panels && t + side * (step / 2) != t) {
                size = step / 2;
                halved++;
                continue;
            }
            if (w->plan) w->error += step * vmi_legendre_tail(panel.ratio);
            else w->error += step * vmi_legendre_tail(panel.inverse);
        }
        vmi_osc_walk_add(w, &panel, side * step);
        if (step < w->shortest && step < left) w->shortest = step;
        t = step == left ? end : t + side * step;
        size = 2 * step < most ? 2 * step : most;
    }
    return VM_OK;
}

/* The walk along the laws from 0 to t, from one point of a table to the next */
VM_API int vmi_osc_walk_to(vmi_osc_walk *w, vm_real t)
{
    const vm_real whole = VM_FABS(t);
    vm_real at = 0, longest = vmi_law_longest_panel(w->mass, whole), knot;
    int k, status = VM_OK;
    if (w->plan && vmi_law_longest_panel(w->stiffness, whole) < longest)
        longest = vmi_law_longest_panel(w->stiffness, whole);
    w->side = t < 0 ? -1 : 1;
    w->y[0] = w->y[1] = w->y[2] = w->fourth = 0;
    for (k = 0; k < VMI_WALK_ORDERS; k++) w->change[k] = 0;
    w->ln_A = w->kicks = w->kick2 = w->kick3 = w->error = 0;
    w->shortest = longest;
    w->panels = 0;
    if (w->plan && w->side < 0) status = vmi_osc_knot(w, 0); /* the plan starts with what is on the other side of 0 */
    while (!status && at != t) {
        knot = vmi_law_next_knot(w->mass, at, t);
        if (w->plan) knot = vmi_law_next_knot(w->stiffness, at, knot);
        status = vmi_osc_walk_piece(w, at, knot, longest, whole);
        at = knot;
        if (!status && w->plan && at != t) status = vmi_osc_knot(w, at);
    }
    return status;
}

/* Documented with vm_law_at. */
VM_API int vm_law_inverse_integral(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real base, rate, y[1];
    int status;
    if (!law || !integral) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_check(law, t);
    if (status) return status;
    if (law->kind == VM_LAW_QUADRATIC) y[0] = vmi_law_quadratic_integral(law, t);
    else if (vmi_law_base(law, &base, &rate)) {
        const vm_real u = t * vmi_log_ratio(base * t);
        y[0] = u / law->f0 * vmi_exp_ratio((base - rate) * u);
    } else {
        vmi_osc_walk w;
        w.mass = w.stiffness = law;
        w.plan = NULL;
        status = vmi_osc_walk_to(&w, t);
        y[0] = w.y[0];
    }
    return status ? status : vmi_copy_if_finite(1, y, integral);
}

/* -- The mean motion, by the laws -- */
typedef struct VM_TAG(vmi_osc_mean) {
    vmi_osc_rates now;
    vm_real y[3];         /* int dt/m, int Om/Om0 dt, int q^2 Om0/Om dt */
    vm_real fourth;       /* int epsilon^4 + (depsilon/dpsi)^2 dpsi */
    vm_real ln_A, ratio;  /* ln A/A0, Om/Om0 by the adiabatic law */
    vm_real kick2, kick3; /* of the points of tables, as above */
    vm_real fast;         /* ln of the action, up to which the laws' fastest part can change it */
    vm_real phase_error;  /* of y[1], times Om */
} vmi_osc_mean;

/* A bound of the change of ln J that the adiabatic law leaves out. The law ignores (ln J)' = epsilon w(psi), per
   radian of phase, with w = (1 - (n+2)/n sa^2)/2, whose mean is 0. The change is at most the integral of
   |epsilon w|. After k integrations by parts it is at most the integral of the kth derivative of epsilon times the
   kth integral of w; the terms at the ends are in the laws. The smallest of these bounds is taken: one with a high
   k for slow laws, the first for a change in less than a period. At points of tables the derivatives jump. The laws
   contain the effect (a kick) of the jumps of the first derivative, and kick3 that of the next. Where the first
   bounds are the smallest, the kicks in the laws are wrong, so these bounds include them. */
VM_API vm_real vmi_osc_fast(const vm_osc_plan *p, const vmi_osc_walk *w)
{
    const vm_real n = p->problem.alpha + 1, turn = p->pi / (2 * VM_PI);
    vm_real size[VMI_WALK_ORDERS], least = VM_INFINITY;
    int k;
    size[0] = n < 2 ? 1 / n : VM_C(0.5);
    size[1] = VM_C(0.25); /* sa ca/2 */
    size[2] = n / 8 * (p->mean_ca2 > VM_C(0.5) ? p->mean_ca2 : 1 - p->mean_ca2);
    for (k = 3; k < VMI_WALK_ORDERS; k++) size[k] = size[k - 1] * turn;
    for (k = 0; k < VMI_WALK_ORDERS; k++) {
        const vm_real bound = size[k] * w->change[k] + (k < 2 ? (n + 2) / 2 * w->kicks : 0);
        if (bound < least) least = bound;
    }
    return least;
}

/* The mean motion where the laws have to be walked along */
VM_API int vmi_osc_mean_by_walk(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean, vm_real *ln_Om)
{
    const vm_osc_problem *o = &p->problem;
    vmi_osc_walk w;
    int i, status;
    w.mass = &o->mass;
    w.stiffness = &o->stiffness;
    w.plan = p;
    status = vmi_osc_walk_to(&w, t);
    if (status) return status;
    vmi_osc_adiabatic(p, vmi_log(mean->now.m / p->m0).hi, vmi_log(mean->now.k / p->k0).hi, o->damping * w.y[0],
                      &mean->ln_A, ln_Om);
    mean->ln_A += w.ln_A;
    *ln_Om += (o->alpha - 1) / 2 * w.ln_A;
    for (i = 0; i < 3; i++) mean->y[i] = w.y[i];
    mean->fourth = w.fourth;
    mean->kick2 = w.kick2;
    mean->kick3 = w.kick3;
    mean->fast = vmi_osc_fast(p, &w);
    mean->phase_error = p->Om * w.error;
    return VM_OK;
}

VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    vm_real ln_Om;
    int status = vmi_osc_rates_at(p, t, t < 0 ? 1 : -1, 1, &mean->now);
    mean->kick2 = mean->kick3 = mean->fast = mean->phase_error = 0;
    if (status) return status;
    if (p->closed) { /* epsilon goes as a power or an exponential: what is fastest is at one of the ends */
        const vm_real u = t * vmi_log_ratio(p->base * t), damping = p->problem.damping * u / p->m0, Q = p->q;
        const vm_real e = Q / p->Om, d = p->h / (p->Om * p->Om);
        vmi_osc_adiabatic(p, p->rate_m * u, p->rate_k * u, damping, &mean->ln_A, &ln_Om);
        mean->y[0] = u / p->m0;
        mean->y[1] = u * vmi_exp_ratio(p->base * u + ln_Om);
        mean->y[2] = Q * Q * u * vmi_exp_ratio(-p->base * u - ln_Om);
        mean->fourth = (e * e * e * e + d * d) * p->Om * VM_FABS(u * vmi_exp_ratio(-3 * (p->base * u + ln_Om)));
    } else {
        status = vmi_osc_mean_by_walk(p, t, mean, &ln_Om);
        if (status) return status;
    }
    mean->ratio = vmi_exp(ln_Om, 0);
    return VM_IS_FINITE(mean->y[1]) && VM_IS_FINITE(mean->ln_A) && VM_IS_FINITE(mean->ratio) ? VM_OK
                                                                                             : VM_NOT_FINITE;
}

#endif
