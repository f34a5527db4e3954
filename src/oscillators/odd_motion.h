/* oscillators/odd_motion.h - vibration under an odd elastic force with slow mass, stiffness and damping

   The equation of motion, with the laws of time m(t) (kg), k(t) (a pure number) and b(t) (kg/s), is
       m x'' + k F(x) + (reactive m' + b) x' = 0,   x(0) and x'(0) given
   F is odd, that is F(-x) = -F(x). It is Duffing's force k1 x + k3 x^3 (oscillators/duffing.h) or a function of the
   user (oscillators/odd_force.h). `reactive` is 1 where mass that joins or leaves is at rest, 0 where this mass has the
   body's velocity. k1 and k3 may depend on time, too (vm_duffing_force_of_laws). The shortest useful call:
       vm_odd_problem problem;
       vm_odd_motion motion;
       problem.force = vm_duffing_force(100, 2000);           // 100 N/m x + 2000 N/m^3 x^3
       problem.mass = vm_law_linear(2, VM_C(0.01));           // 0.01 kg/s settle on the body
       problem.stiffness = vm_law_linear(1, 0);               // constant
       problem.damping = vm_law_linear(VM_C(0.02), 0);        // 0.02 N s/m
       problem.reactive = 1;
       problem.x = VM_C(0.2);
       problem.v = 0;
       if (vm_odd_within(&problem, 60, VM_C(1e-3), &motion) == VM_OK) printf("%g m\n", (double)motion.x);
   Method: averaging of the action and the phase (oscillators/orbit_ripple.h). Where the laws are not slow, or where the
   motion crosses a separatrix, the border between two kinds of vibration, rk87 integrates the equation of motion. A
   plan contains the mean motion from t = 0 to a given time. Guide: docs/duffing.md. Tests: tests/test_odd_force.c. */
#ifndef VARMASS_OSCILLATORS_ODD_MOTION_H
#define VARMASS_OSCILLATORS_ODD_MOTION_H

#include <string.h>

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "laws.h"
#include "legendre.h"
#include "odd_force.h"
#include "odd_laws.h"
#include "orbit_ripple.h"
#include "panels.h"

/* Routes, which are methods to compute x(t) and x'(t), the cheapest first */
enum {
    VM_ODD_MEAN = 0,   /* the mean motion, by averaging; its error is of first order in the rates of the laws */
    VM_ODD_ORDER2 = 1, /* the mean motion and its ripple within a period; the error is of second order in these rates */
    VM_ODD_RK87 = 2    /* integration of the equation of motion by rk87 */
};

/* The motion at one time */
typedef struct VM_TAG(vm_odd_motion) {
    vm_real x, v;      /* position, m, and velocity, m/s */
    vm_real amplitude; /* the largest |x| of the present vibration, m; NaN where the state (x, v) does not lie on a
                          vibration */
    vm_real error;     /* estimate of the larger of |error of x|/swing and |error of v|/vmax, where swing is half the
                          distance between the turning points of the present vibration, and vmax is its largest
                          velocity */
    int route;         /* the route by which x and v were computed, VM_ODD_... */
    long evals;        /* evaluations of the equation of motion; 0 where nothing was integrated */
} vm_odd_motion;

/* -- The plan -- */

/* VMI_ODD_PANELS is the largest number of panels of time in a plan; a law by a user's function needs at least 32.
   VMI_ODD_ORDERS is the number of integrals in the field `change` of a panel, which measure how fast the laws
   change. */
enum { VMI_ODD_PANELS = 48, VMI_ODD_ORDERS = 7 };

/* A panel of time, on which the laws and the mean motion are Legendre series */
typedef struct VM_TAG(vmi_odd_panel) {
    vm_real t, length;          /* start and length of the panel, s; backward in time the length is negative */
    vm_real phase;              /* mean phase at the start of the panel */
    vm_real decay;              /* integral of b/m over time, from t = 0 to the start of the panel; b is the damping */
    vm_real ln_J;               /* ln of the mean action J divided by its value at t = 0; it changes only at points of
                                   tables */
    vm_real rate[VMI_GAUSS];    /* Legendre series of the rate of the mean phase, 1/s */
    vm_real size[VMI_GAUSS];    /* Legendre series of the field `size` of the mean orbit (see vmi_orbit) */
    /* Element i is the integral of |d^i (h/w)/dphi^i| over the phase phi, from t = 0 to the end of the panel. h is the
       damping of oscillators/orbit_ripple.h, and w the rate of the phase. */
    vm_real change[VMI_ODD_ORDERS];
    vm_real knots;              /* terms of ln J that the route VM_ODD_ORDER2 leaves out at points of tables, from t = 0
                                   to the end of the panel */
    vm_real largest_a, largest_B; /* largest values, on the panel, of the fields largest_a and largest_B of
                                     vmi_orbit_ripple */
    vm_real gamma;              /* largest value, on the panel, of (relative change of the phase rate w)/(relative
                                   change of the action j) */
} vmi_odd_panel;

/* The mean motion of a problem from t = 0 to a given time. Fill the plan by vm_odd_plan_init. Read its fields, but do
   not change them. The plan contains pointers to the tables of the problem, to the user's functions and to their
   ctx. */
typedef struct VM_TAG(vm_odd_plan) {
    vm_odd_problem problem; /* a copy of the problem */
    vm_real t_end;          /* the time up to which the plan was asked for, s */
    vm_real reach;          /* the time up to which the averaged solutions exist, s: t_end, or a time between 0 and
                               t_end */
    vm_real m0, k0, speed0; /* mass m, stiffness factor k and sqrt(k/m) at t = 0 */
    vm_real v0;             /* rate of x/s at t = 0, divided by speed0; s is the factor of odd_laws.h */
    int at_rest;            /* 1 where the body rests in equilibrium, else 0 */
    vmi_orbit start;        /* the orbit through the state at t = 0; its field `size` is 0 where there is no
                               vibration */
    vm_real phi;            /* phase of the state at t = 0 on the orbit `start` */
    vm_real ln_j, phase;    /* ln of the mean action, and mean phase, at t = 0 */
    vmi_odd_slow slow;      /* the damping h and the weak spring of odd_laws.h at t = 0, and their derivatives */
    vm_real gamma;          /* (relative change of the phase rate w)/(relative change of the action j) at t = 0 */
    vm_real first_a;        /* field largest_a of vmi_orbit_ripple at t = 0 */
    vm_real first_B;        /* field largest_B of vmi_orbit_ripple at t = 0 */
    int n;                  /* number of panels */
    vmi_odd_panel panel[VMI_ODD_PANELS];
} vm_odd_plan;

/* Finds the orbit whose action is exp(ln_j), by Newton's method. The field `size` of *orbit is the first guess. If a
   step leads to a size at which there is no orbit, the step is halved. Returns VM_NO_LAW where there is no orbit with
   this action. */
VM_API int vmi_orbit_find(vmi_orbit *orbit, vm_real ln_j)
{
    const vm_real enough = 4 * VM_EPSILON, longest = 2;
    const int most = 80;
    vm_real size = orbit->size, step = 0;
    int i, status = VM_NO_LAW;
    for (i = 0; i < most; i++) {
        orbit->size = size * vmi_exp(step, 0);
        status = orbit->force->complete(orbit);
        if (status && status != VM_NO_LAW) return status;
        if (status || !(orbit->j > 0)) {
            step /= 2;
            if (VM_FABS(step) < enough) return VM_NO_LAW;
            continue;
        }
        size = orbit->size;
        step = (ln_j - vmi_log(orbit->j).hi) * (orbit->w * orbit->j) / (orbit->energy_slope * size);
        step = vmi_clamp(step, -longest, longest);
        if (VM_FABS(step) <= enough) return VM_OK;
    }
    return VM_NO_LAW;
}

/* The change of ln j since t = 0 by the adiabatic law, where j is the action. *now contains the values of the laws at
   the present time, and `decay` is the integral of b/m from 0 to this time, where b is the damping. */
VM_API vm_real vmi_odd_adiabatic(const vm_odd_plan *p, const vmi_odd_rates *now, vm_real decay)
{
    const vm_real ln_m = vmi_log(now->m / p->m0).hi, ln_k = vmi_log(now->k / p->k0).hi;
    vm_real shape = 0; /* 2 ln s, where s is the factor in y = x/s of odd_laws.h */
    if (now->ratio1 != now->ratio3) shape = vmi_log(now->ratio1 / now->ratio3).hi;
    return -(ln_k / 2 + (p->problem.reactive - VM_C(0.5)) * ln_m + decay + shape);
}

/* Returns the longest panel, s, that the laws allow for a walk (the integration along the laws) over `whole`
   seconds. */
VM_API vm_real vmi_odd_longest_panel(const vm_odd_problem *o, vm_real whole)
{
    const vm_law *laws[VMI_ODD_LAWS];
    int statuses[VMI_ODD_LAWS], i;
    const int n = vmi_odd_all_laws(o, laws, statuses);
    vm_real longest = whole;
    for (i = 0; i < n; i++) longest = vmi_smaller(vmi_law_longest_panel(laws[i], whole), longest);
    return longest;
}

/* Returns the time, s, in which the phase of the orbit grows by 16. The second and higher derivatives of laws by users'
   functions are computed from the first derivatives at times that differ from the present time by at most this time. */
VM_API vm_real vmi_odd_sampling_time(vm_real w, vm_real speed) { return 16 / (w * speed); }

/* -- A panel -- */

/* The laws at the nodes of Gauss' rule on a panel, and numbers that follow from the laws */
typedef struct VM_TAG(vmi_odd_nodes) {
    vmi_odd_rates rates[VMI_GAUSS];
    vm_real decay[VMI_GAUSS];  /* integral of b/m from t = 0 */
    vm_real h_rate[VMI_GAUSS]; /* time derivative of the field h of vmi_odd_rates, 1/s^2 */
    vm_real spring[VMI_GAUSS]; /* the number G of odd_laws.h, 1/s^2, at the nodes: m G is the stiffness of the weak
                                  spring */
    vm_real edge;              /* largest relative difference between a law and its Legendre series at the ends of the
                                  panel */
    vm_real decay_end;         /* integral of b/m from t = 0 to the end of the panel */
    vm_real inverse[VMI_GAUSS], stiffness[VMI_GAUSS]; /* Legendre series of 1/m and of k */
    vm_real ratio1[VMI_GAUSS], ratio3[VMI_GAUSS];     /* Legendre series of the fields ratio1 and ratio3 of
                                                         vmi_odd_rates */
} vmi_odd_nodes;

/* Reads the shape of the force, which changes where k1 and k3 follow laws. The function writes the series ratio1 and
   ratio3. If the errors of these series at the ends of the panel are larger than the field `edge`, it raises `edge`. It
   also writes the weak spring at the nodes. The field `rates` of *at must be set before. */
VM_API int vmi_odd_read_shape(const vm_odd_problem *o, const vmi_odd_panel *panel, vmi_odd_nodes *at)
{
    const vm_odd_force *force = &o->force;
    vm_real ratio1[VMI_GAUSS], ratio3[VMI_GAUSS], scale[VMI_GAUSS], k1[VMI_GAUSS], k3[VMI_GAUSS], rate[VMI_GAUSS];
    int i, status = VM_OK;
    for (i = 0; i < VMI_GAUSS; i++) {
        at->spring[i] = 0;
        ratio1[i] = at->rates[i].ratio1;
        ratio3[i] = at->rates[i].ratio3;
        scale[i] = at->rates[i].scale_rate;
    }
    if (!force->laws) return VM_OK;
    vmi_legendre_fit(ratio1, ratio3, at->ratio1, at->ratio3);
    vmi_legendre_fit(scale, scale, rate, k1);
    vmi_legendre_derive(rate);
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real scale_change = 2 / panel->length * vmi_legendre_at(rate, vmi_gauss_node(i));
        at->spring[i] = scale_change + scale[i] * (scale[i] + at->rates[i].loss);
        k1[i] = force->k1 * at->ratio1[i];
        k3[i] = force->k3 * at->ratio3[i];
    }
    if (force->k1 != 0) status = vmi_panel_edge(&force->laws[0], VM_OK, 0, panel->t, panel->length, k1, &at->edge);
    if (status || force->k3 == 0) return status;
    return vmi_panel_edge(&force->laws[1], VM_OK, 0, panel->t, panel->length, k3, &at->edge);
}

/* Fills *at with the laws at the nodes of Gauss' rule on a panel. */
VM_API int vmi_odd_read(const vm_odd_problem *o, const vmi_odd_panel *panel, vmi_odd_nodes *at)
{
    const int side = vmi_time_side(panel->length);
    vm_real inverse[VMI_GAUSS], k[VMI_GAUSS], losses[VMI_GAUSS], h[VMI_GAUSS], loss[VMI_GAUSS], h_series[VMI_GAUSS];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = panel->t + panel->length * ((1 + vmi_gauss_node(i)) / 2);
        status = vmi_odd_rates_at(o, t, side, &at->rates[i]);
        if (status) return status;
        inverse[i] = 1 / at->rates[i].m;
        k[i] = at->rates[i].k / at->rates[i].ratio1;
        losses[i] = at->rates[i].b / at->rates[i].m;
        h[i] = at->rates[i].h;
    }
    vmi_legendre_fit(inverse, k, at->inverse, at->stiffness);
    vmi_legendre_fit(losses, h, loss, h_series);
    vmi_legendre_derive(h_series);
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real x = vmi_gauss_node(i);
        at->decay[i] = panel->decay + panel->length / 2 * vmi_legendre_integral(loss, x);
        at->h_rate[i] = 2 / panel->length * vmi_legendre_at(h_series, x);
    }
    at->decay_end = panel->decay + panel->length * loss[0];
    at->edge = 0;
    status = vmi_panel_edge(&o->mass, VM_BAD_MASS, 1, panel->t, panel->length, at->inverse, &at->edge);
    if (status) return status;
    status = vmi_panel_edge(&o->stiffness, VM_BAD_STIFFNESS, 0, panel->t, panel->length, at->stiffness, &at->edge);
    if (status) return status;
    return vmi_odd_read_shape(o, panel, at);
}

/* Adds to the field `change` the integrals of |d^i (h/w)/dphi^i| over this panel. The integrals are computed from
   `ratio`, the Legendre series of h/w, with root mean squares in place of absolute values. First all coefficients of
   this series that are as small as rounding errors become 0. The series is overwritten. */
VM_API void vmi_odd_add_changes(vmi_odd_panel *panel, vm_real *ratio)
{
    const vm_real noise = (VM_MANT_DIG > 24 ? 4096 : 16) * VM_EPSILON;
    const vm_real turns = VM_FABS(panel->length * panel->rate[0]);
    const vm_real least = noise * VM_SQRT(vmi_legendre_square(ratio));
    vm_real scale = turns;
    int i;
    for (i = 0; i < VMI_GAUSS; i++)
        if (VM_FABS(ratio[i]) <= least) ratio[i] = 0;
    for (i = 0; i < VMI_ODD_ORDERS; i++) {
        panel->change[i] += scale * VM_SQRT(vmi_legendre_square(ratio));
        vmi_legendre_derive(ratio);
        scale *= 2 / turns;
    }
}

/* The index of the k-th node in the order of time, 0 <= k < 20. In this order the indices are 0, 2 ... 18, 19, 17 ...
   1. */
VM_API int vmi_odd_node_number(int k) { return k < VMI_GAUSS / 2 ? 2 * k : 2 * VMI_GAUSS - 1 - 2 * k; }

/* Computes the Legendre series of a panel, whose fields for its start and length must be set. Before the call *orbit
   must be a guess of the mean orbit at the start of the panel. After the call it is the mean orbit at the last node. */
VM_API int vmi_odd_panel_of(const vm_odd_plan *p, vmi_odd_panel *panel, vmi_orbit *orbit, vmi_odd_nodes *at)
{
    vm_real rates[VMI_GAUSS], sizes[VMI_GAUSS], bends[VMI_GAUSS], ratios[VMI_GAUSS];
    vm_real bend[VMI_GAUSS], ratio[VMI_GAUSS];
    int i, k, status = vmi_odd_read(&p->problem, panel, at);
    if (status) return status;
    panel->largest_a = 0;
    panel->largest_B = 0;
    panel->gamma = 0;
    for (k = 0; k < VMI_GAUSS; k++) {
        vmi_orbit_ripple ripple;
        vm_real h, h1, M_j;
        const vmi_odd_rates *now;
        i = vmi_odd_node_number(k);
        now = at->rates + i;
        status = vmi_orbit_find(orbit, p->ln_j + panel->ln_J + vmi_odd_adiabatic(p, now, at->decay[i]));
        if (status) return status;
        vmi_orbit_ripple_init(&ripple, orbit);
        h = now->h / now->speed;
        h1 = (at->h_rate[i] - now->h * now->turn) / (now->speed * now->speed);
        M_j = vmi_orbit_M_j(&ripple, orbit) / orbit->j;
        panel->largest_a = vmi_larger(ripple.largest_a, panel->largest_a);
        panel->largest_B = vmi_larger(ripple.largest_B, panel->largest_B);
        panel->gamma = vmi_larger(VM_FABS(vmi_orbit_gamma(&ripple, orbit)), panel->gamma);
        sizes[i] = orbit->size;
        bends[i] = h * M_j;
        ratios[i] = h / orbit->w;
        rates[i] = (orbit->w - M_j * (h1 + 2 * h * h)) * now->speed;
        rates[i] += at->spring[i] / now->speed * (ripple.X_size / (2 * ripple.j_size));
    }
    vmi_legendre_fit(bends, ratios, bend, ratio);
    vmi_legendre_derive(bend);
    for (i = 0; i < VMI_GAUSS; i++) rates[i] += 2 / panel->length * vmi_legendre_at(bend, vmi_gauss_node(i));
    vmi_legendre_fit(rates, sizes, panel->rate, panel->size);
    vmi_odd_add_changes(panel, ratio);
    return VM_OK;
}

/* Returns 1 if a panel is so short that its Legendre series are accurate enough, else 0. The limit is stricter for the
   series of phase rate and size, because these series are also used inside the panel. Inside the panel the error of a
   series is as large as the terms that the series leaves out; the error of an integral over the whole panel is only
   about the square of these terms. `varying` is 1 where k1 and k3 follow laws. `whole` is the length of the whole
   integration in time, s. */
VM_API int vmi_odd_panel_is_resolved(const vmi_odd_panel *panel, const vmi_odd_nodes *at, int varying, vm_real whole)
{
    const vm_real limit = vmi_panel_limit(panel->length, whole), fine = VM_MANT_DIG > 24 ? VM_C(1e-12) : VM_C(1e-5);
    if (!(at->edge <= vmi_panel_edge_limit(limit))) return 0;
    if (!vmi_panel_is_resolved(at->inverse, limit) || !vmi_panel_is_resolved(at->stiffness, limit)) return 0;
    if (varying && !vmi_panel_is_resolved(at->ratio1, limit)) return 0;
    if (varying && !vmi_panel_is_resolved(at->ratio3, limit)) return 0;
    return vmi_panel_is_resolved(panel->rate, fine) && vmi_panel_is_resolved(panel->size, fine);
}

/* -- The walk from t = 0 to the plan's end -- */

/* Adds to the plan a panel that is short enough, and writes the start values of the next panel to *next. */
VM_API void vmi_odd_keep(vm_odd_plan *p, const vmi_odd_panel *panel, const vmi_odd_nodes *at, vmi_odd_panel *next)
{
    p->panel[p->n] = *panel;
    p->n++;
    *next = *panel;
    next->t += panel->length;
    next->phase += panel->length * panel->rate[0];
    next->decay = at->decay_end;
    p->reach = next->t;
}

/* Adds to the plan the panels up to the time `end`. No table may have a point between the start of *next and this time.
   Returns VM_NO_LAW where the averaged motion ends, that is at a separatrix (the border between two kinds of
   vibration), and where the plan has no room for more panels. */
VM_API int vmi_odd_walk_piece(vm_odd_plan *p, vm_real end, vm_real longest, vmi_orbit *orbit, vmi_odd_panel *next)
{
    const vm_real whole = VM_FABS(p->t_end), shortest_at_end = whole / 64;
    vmi_panels panels = vmi_panels_from(next->t, end, longest, whole);
    while (vmi_panels_next(&panels)) {
        vmi_odd_panel panel = *next;
        vmi_odd_nodes at;
        vmi_orbit trial = *orbit;
        int status;
        if (p->n == VMI_ODD_PANELS) return VM_NO_LAW;
        panel.t = panels.t;
        panel.length = panels.side * panels.step;
        status = vmi_odd_panel_of(p, &panel, &trial, &at);
        if (status && (status != VM_NO_LAW || panels.step < shortest_at_end)) return status;
        if (status || !vmi_odd_panel_is_resolved(&panel, &at, p->problem.force.laws != NULL, whole)) {
            if (vmi_panels_halve(&panels)) continue;
            return VM_NO_LAW;
        }
        *orbit = trial;
        vmi_odd_keep(p, &panel, &at, next);
        vmi_panels_advance(&panels);
        next->t = panels.t;
        p->reach = panels.t;
    }
    return VM_OK;
}

/* The relative change of the action within a period that a weak linear spring of stiffness 1 causes. On an orbit in a
   well, which lies at one side of x = 0, this change is larger for a smaller orbit, because the spring moves the place
   of rest. */
VM_API vm_real vmi_odd_spring_ripple(const vmi_orbit *orbit)
{
    vm_real squares = orbit->size; /* the largest change of x^2 along the orbit */
    if (orbit->place == VMI_ORBIT_AROUND_0) squares *= orbit->size;
    return squares / (2 * orbit->w * orbit->j);
}

/* Continues the mean motion beyond the time next->t, a point of a table. At this time the derivative of the damping h
   jumps, but the motion does not jump. The formula that leads from the motion to the mean action contains the
   derivative of h (oscillators/orbit_ripple.h). Therefore the mean action jumps. */
VM_API int vmi_odd_walk_past_knot(const vm_odd_plan *p, vmi_orbit *orbit, vmi_odd_panel *next)
{
    const int side = vmi_time_side(p->t_end);
    const vm_real length = vmi_odd_sampling_time(orbit->w, p->speed0);
    vmi_odd_rates rates;
    vmi_odd_slow before, after;
    vmi_orbit_ripple ripple;
    vmi_orbit_ripple_values now;
    vm_real w, left, x, v;
    int status = vmi_odd_rates_at(&p->problem, next->t, -side, &rates);
    if (!status) status = vmi_orbit_find(orbit, p->ln_j + next->ln_J + vmi_odd_adiabatic(p, &rates, next->decay));
    if (!status) status = vmi_odd_slow_at(&p->problem, next->t, -side, length, &before);
    if (!status) status = vmi_odd_slow_at(&p->problem, next->t, side, length, &after);
    if (!status) status = orbit->force->at_phase(orbit, next->phase, &x, &v);
    if (status) return status;
    vmi_orbit_ripple_init(&ripple, orbit);
    vmi_orbit_ripple_at(&ripple, orbit, next->phase, &now);
    w = orbit->w;
    next->ln_J -= 2 * (after.h1 - before.h1) * now.B / (w * w * orbit->j);
    next->ln_J += (after.spring - before.spring) * vmi_orbit_spring_action(&ripple, orbit, x) / orbit->j;
    left = VM_FABS(after.h2 - before.h2) + 4 * VM_FABS((after.h1 - before.h1) * after.h);
    next->knots += left / (w * w * w);
    left = VM_FABS(after.spring1 - before.spring1) + 4 * VM_FABS((after.spring - before.spring) * after.h);
    next->knots += left / w * vmi_odd_spring_ripple(orbit);
    return VM_OK;
}

/* Computes the panels of the mean motion one after the other, from t = 0 to the time t_end of the plan. Returns a
   status. */
VM_API int vmi_odd_walk(vm_odd_plan *p, vmi_orbit *orbit)
{
    const vm_odd_problem *o = &p->problem;
    const vm_real longest = vmi_odd_longest_panel(o, VM_FABS(p->t_end));
    vmi_odd_panel next;
    int i, status = VM_OK;
    next.t = 0;
    next.length = 0;
    next.phase = p->phase;
    next.decay = 0;
    next.ln_J = 0;
    next.knots = 0;
    next.largest_a = 0;
    next.largest_B = 0;
    next.gamma = 0;
    for (i = 0; i < VMI_ODD_ORDERS; i++) next.change[i] = 0;
    while (!status && next.t != p->t_end) {
        const vm_real end = vmi_odd_next_knot(o, next.t, p->t_end);
        status = vmi_odd_walk_piece(p, end, longest, orbit, &next);
        if (!status && end != p->t_end) status = vmi_odd_walk_past_knot(p, orbit, &next);
    }
    return status;
}

/* Computes the mean motion at t = 0 from the state at t = 0, and the numbers at t = 0 that the estimates of the error
   need. */
VM_API int vmi_odd_start(vm_odd_plan *p, const vmi_orbit *orbit)
{
    const int side = vmi_time_side(p->t_end);
    vmi_orbit_ripple ripple;
    vmi_orbit_ripple_values now;
    vm_real mean;
    int status = vmi_odd_slow_at(&p->problem, 0, side, vmi_odd_sampling_time(orbit->w, p->speed0), &p->slow);
    if (!status) status = orbit->force->phase(orbit, p->problem.x, p->v0, &p->phi);
    if (status) return status;
    vmi_orbit_ripple_init(&ripple, orbit);
    vmi_orbit_ripple_at(&ripple, orbit, p->phi, &now);
    mean = vmi_orbit_mean_action(&ripple, orbit, &now, p->slow.h, p->slow.h1) +
           p->slow.spring * vmi_orbit_spring_action(&ripple, orbit, p->problem.x);
    p->phase = p->phi - 2 * p->slow.h * now.B_j;
    p->gamma = vmi_orbit_gamma(&ripple, orbit);
    p->first_a = ripple.largest_a;
    p->first_B = ripple.largest_B;
    if (!(mean > 0)) return VM_NO_LAW; /* the laws are not slow */
    p->ln_j = vmi_log(mean).hi;
    return VM_OK;
}

/* Checks the problem and its laws between 0 and t. */
VM_API int vmi_odd_check(const vm_odd_problem *o, vm_real t)
{
    const vm_real numbers[5] = {o->reactive, o->x, o->v, o->force.k1, o->force.k3};
    int status = vmi_all_finite(5, numbers) ? VM_OK : VM_NOT_FINITE;
    if (!o->force.at) return VM_BAD_ARGUMENT;
    return vmi_first_error(status, vmi_odd_check_laws(o, t));
}

/* Writes the field v0 of the plan: the rate of x/s at t = 0, divided by speed0, where s is the factor of odd_laws.h.
   Where the shape of the force cannot be made constant, s is taken as 1. */
VM_API int vmi_odd_first_velocity(vm_odd_plan *p)
{
    const vm_odd_problem *o = &p->problem;
    vmi_odd_rates rates;
    const int status = vmi_odd_rates_at(o, 0, vmi_time_side(p->t_end), &rates);
    p->v0 = o->v / p->speed0;
    if (status) return status == VM_NO_LAW ? VM_OK : status;
    if (o->force.laws) p->v0 = (o->v - rates.scale_rate * o->x) / p->speed0;
    return VM_OK;
}

/* Sets all other fields of a plan whose fields problem, t_end, m0, k0 and speed0 are set. */
VM_API int vmi_odd_fill(vm_odd_plan *p)
{
    const vm_odd_problem *o = &p->problem;
    vmi_orbit orbit;
    int status;
    vm_real f;
    orbit.size = 0;
    status = o->force.at(&o->force, o->x, &f);
    if (!status) status = vmi_odd_first_velocity(p);
    if (status) return status;
    if (o->v == 0 && f == 0 && (o->x == 0 || !o->force.laws)) p->at_rest = 1;
    else status = vmi_orbit_of_state(&o->force, o->x, p->v0, &orbit);
    if (!status && orbit.size > 0 && orbit.m1 < VM_EPSILON) status = VM_NO_LAW; /* the size of a mean orbit cannot
                                                                                   tell it from the separatrix */
    if (status == VM_NO_LAW) return VM_OK;
    if (status || p->at_rest || orbit.size == 0) return status;
    p->start = orbit;
    p->start.force = NULL; /* the force is p->problem.force; a pointer to it would be wrong in a copy of the plan */
    status = vmi_odd_start(p, &orbit);
    if (!status && p->t_end != 0) status = vmi_odd_walk(p, &orbit);
    return status == VM_NO_LAW ? VM_OK : status;
}

/* Makes a plan, by which one vibration under an odd elastic force is computed at many times between t = 0 and t_end (s,
   any sign). vm_odd_plan_within and vm_odd_plan_by_route use the plan. The problem is copied; its tables and what ctx
   points to must exist as long as the plan is used. The averaged motion may end before t_end, at a separatrix (the
   border between two kinds of vibration) or because laws change too fast. The field `reach` is the time at which the
   averaged motion ends; at later times only the route VM_ODD_RK87 works. Errors leave the plan untouched. Returns
   VM_BAD_ARGUMENT for null pointers and for a law or force that no constructor made, VM_NOT_FINITE for a number that is
   infinite or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive, and VM_DOMAIN for a
   table whose times do not rise or do not contain 0 and t_end, and where a user's function fails. */
VM_API int vm_odd_plan_init(vm_odd_plan *p, const vm_odd_problem *problem, vm_real t_end)
{
    vm_odd_plan plan;
    vmi_odd_now now;
    int status;
    if (!p || !problem) return VM_BAD_ARGUMENT;
    memset(&plan, 0, sizeof plan);
    plan.problem = *problem;
    plan.t_end = t_end;
    if (VM_IS_FINITE(t_end)) status = vmi_odd_check(problem, t_end);
    else status = vmi_first_error(VM_NOT_FINITE, vmi_odd_check(problem, 0));
    if (!status) status = vmi_odd_read_laws(problem, 0, vmi_time_side(t_end), &now);
    if (status) return status;
    if (problem->force.laws) {
        plan.problem.force.k1 = now.k1;
        plan.problem.force.k3 = now.k3;
    }
    plan.m0 = now.m;
    plan.k0 = now.k;
    plan.speed0 = VM_SQRT(now.k / now.m);
    status = vmi_odd_fill(&plan);
    if (!status) *p = plan;
    return status;
}

/* -- Averaged solutions -- */

/* The mean motion at one time */
typedef struct VM_TAG(vmi_odd_mean) {
    vmi_orbit orbit;     /* the mean orbit */
    vm_real phase;       /* the mean phase */
    vmi_odd_rates rates; /* the laws at this time, and their rates */
    const vmi_odd_panel *panel;
} vmi_odd_mean;

/* Computes the mean motion at t from the series of the plan. Returns VM_NO_LAW where t lies beyond the field `reach` of
   the plan. */
VM_API int vmi_odd_mean_at(const vm_odd_plan *p, vm_real t, vmi_odd_mean *mean)
{
    const vmi_odd_panel *panel = p->panel;
    vm_real place;
    int i, status;
    if (p->n == 0 || VM_FABS(t) > VM_FABS(p->reach)) return VM_NO_LAW;
    for (i = 1; i < p->n && VM_FABS(t) > VM_FABS(p->panel[i].t); i++) panel++;
    place = vmi_clamp(2 * ((t - panel->t) / panel->length) - 1, -1, 1);
    status = vmi_odd_rates_at(&p->problem, t, -vmi_time_side(p->t_end), &mean->rates);
    if (status) return status;
    mean->panel = panel;
    mean->orbit = p->start;
    mean->orbit.force = &p->problem.force;
    mean->orbit.size = vmi_legendre_at(panel->size, place);
    mean->phase = panel->phase + panel->length / 2 * vmi_legendre_integral(panel->rate, place);
    return mean->orbit.force->complete(&mean->orbit);
}

/* Adds the ripple to the mean motion: after that, phase and orbit are those of the actual motion x and v. */
VM_API int vmi_odd_add_ripple(vmi_odd_mean *mean)
{
    vmi_orbit *orbit = &mean->orbit;
    const vm_real h = mean->rates.h / mean->rates.speed;
    vmi_orbit_ripple ripple;
    vmi_orbit_ripple_values now;
    vmi_orbit_ripple_init(&ripple, orbit);
    vmi_orbit_ripple_at(&ripple, orbit, mean->phase, &now);
    mean->phase += 2 * h * now.B_j;
    orbit->size *= vmi_exp(-2 * h * now.a / (orbit->w * ripple.j_size * orbit->size), 0);
    return orbit->force->complete(orbit);
}

/* A bound of the change of ln J, where J is the action, that fast changes of the laws cause. Integrating by parts i
   times gives a bound for each i, and the function returns the smallest bound; vmi_osc_fast (oscillators/mean_motion.h)
   explains this. */
VM_API vm_real vmi_odd_fast(const vmi_odd_mean *mean, vm_real largest_a)
{
    const vm_real turn = mean->orbit.span / VM_PI;
    vm_real size = 2, least = VM_INFINITY;
    int i;
    for (i = 0; i < VMI_ODD_ORDERS; i++) {
        const vm_real bound = size * mean->panel->change[i];
        if (!(bound >= least)) least = bound;
        if (i == 0) size = 2 * largest_a;
        else size *= turn;
    }
    return least;
}

/* Writes the sizes of the terms of second and of third order in the rates of the laws, for one orbit and for the
   damping and the weak spring in *slow. */
VM_API void vmi_odd_sizes(const vmi_odd_slow *slow, const vmi_orbit *orbit, vm_real *second, vm_real *third)
{
    const vm_real w = orbit->w, by_spring = vmi_odd_spring_ripple(orbit);
    const vm_real h = VM_FABS(slow->h / w), h1 = VM_FABS(slow->h1 / w / w), h2 = VM_FABS(slow->h2 / w / w / w);
    const vm_real spring = VM_FABS(slow->spring) * by_spring, spring1 = VM_FABS(slow->spring1 / w) * by_spring;
    *second = h1 + 2 * h * h + spring;
    *third = h2 + 4 * h * h1 + 4 * h * h * h + spring1 + 4 * h * spring;
}

/* Returns the factor by which a small error of the phase must be multiplied to give the error of x/swing or of v/vmax.
   swing and vmax are fields of the orbit. */
VM_API vm_real vmi_odd_steepness(const vmi_orbit *orbit)
{
    const vm_real of_x = orbit->vmax / (orbit->w * orbit->swing);
    if (orbit->place != VMI_ORBIT_AROUND_0) return of_x + 1 / of_x;
    return vmi_larger(of_x, orbit->energy_slope / (orbit->w * orbit->vmax));
}

/* Estimates the error of an averaged solution at t. The estimate is the sum of the sizes of the terms that are left
   out: in the transformation between motion and mean motion at t = 0 and at t, and in the action at t = 0 and at points
   of tables. A relative error e of the action changes the phase by gamma e times the phase, where gamma is the field of
   the plan or panel. The numerical factors are chosen to fit the errors of random problems in
   tests/test_odd_force.c. */
VM_API int vmi_odd_error(const vm_odd_plan *p, int route, vm_real t, const vmi_odd_mean *mean, vm_real *error)
{
    const vmi_orbit *orbit = &mean->orbit;
    const vm_real largest_known = VM_C(0.25), w = orbit->w, turns = VM_FABS(mean->phase - p->phase);
    const vm_real gamma = vmi_larger(VM_FABS(p->gamma), mean->panel->gamma);
    const vm_real a = mean->panel->largest_a, B = mean->panel->largest_B;
    const vm_real h = VM_FABS(mean->rates.h / mean->rates.speed);
    const vm_real fastest = VM_FABS(mean->rates.loss) + VM_FABS(mean->rates.turn) + VM_FABS(mean->rates.h);
    const vm_real by_time = vmi_osc_time_rounding(t, w * mean->rates.speed, fastest);
    vm_real second0, third0, second, third, phase, action;
    vmi_odd_slow slow;
    int status = vmi_odd_slow_at(&p->problem, t, -vmi_time_side(p->t_end),
                                 vmi_odd_sampling_time(w, mean->rates.speed), &slow);
    if (status) return status;
    vmi_odd_sizes(&p->slow, &p->start, &second0, &third0);
    vmi_odd_sizes(&slow, orbit, &second, &third);
    action = p->first_a * (third0 + mean->panel->knots) + vmi_odd_fast(mean, a);
    phase = (1 + gamma) * (p->first_B * second0 + B * (second + third)) + (1 + gamma * turns) * action;
    *error = (vmi_odd_steepness(orbit) * phase + a * (second + third) + action) / 2 +
             vmi_larger(by_time, 4 * VM_EPSILON * (2 + turns));
    if (route == VM_ODD_MEAN) *error += 2 * h / w * (vmi_odd_steepness(orbit) * B + a);
    if (!(*error <= largest_known)) *error = VM_INFINITY;
    return VM_OK;
}

/* Writes the motion at t by averaging. Its error is of first order for the route VM_ODD_MEAN, and of second order for
   VM_ODD_ORDER2. */
VM_API int vmi_odd_averaged(const vm_odd_plan *p, int route, vm_real t, vm_odd_motion *motion)
{
    vmi_odd_mean mean;
    vm_odd_motion r;
    int status = vmi_odd_mean_at(p, t, &mean);
    if (status) return status;
    status = vmi_odd_error(p, route, t, &mean, &r.error);
    if (!status && route == VM_ODD_ORDER2) status = vmi_odd_add_ripple(&mean);
    if (!status) status = mean.orbit.force->at_phase(&mean.orbit, mean.phase, &r.x, &r.v);
    if (status) return status;
    r.v = mean.rates.scale * (mean.rates.speed * r.v + mean.rates.scale_rate * r.x); /* from x/s to x */
    r.x *= mean.rates.scale;
    r.amplitude = mean.rates.scale * vmi_orbit_amplitude(&mean.orbit);
    r.route = route;
    r.evals = 0;
    if (!VM_IS_FINITE(r.x) || !VM_IS_FINITE(r.v)) return VM_NOT_FINITE;
    *motion = r;
    return VM_OK;
}

#endif
