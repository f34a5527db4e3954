/* integrators/events.h - events: where a function g(t, y) of the solution changes its sign
   After each step, g is evaluated at several points inside the step, with the states of the continuous extension. If
   the sign of g changes between two of these points, the time of the change is found as exactly as rounding allows.
   The first event that stops or restarts the run ends the step at its time. Events whose times differ by no more than
   rounding errors happen together. Users describe events in the options of a run (options.h). The side of an event is
   the sign of its g, -1 or 1, or 0 while rounding leaves this sign uncertain. The place x of an event in a step is a
   fraction of the step, from 0 to 1.

       double y0[2] = {20, 0}, work[RK45_WORK(2)]; // 20 m high, at rest
       rk45 s;
       ode_event touch;
       rk45_options options;
       memset(&touch, 0, sizeof touch);
       memset(&options, 0, sizeof options);
       touch.g = height; // height and fall are functions of the user: an ode_event_function and an ode_rhs
       touch.action = ODE_STOP;
       options.events = &touch;
       options.n_events = 1;
       rk45_init(&s, fall, NULL, 2, 0.0, y0, &options, work);
       if (rk45_solve(&s, 10.0) == ODE_EVENT) printf("on the ground at %g\n", s.t);

   Tests: tests/test_events.c, tests/test_coincidences.c. */
#ifndef VARMASS_INTEGRATORS_EVENTS_H
#define VARMASS_INTEGRATORS_EVENTS_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "dense.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "runs.h"
#include "steps.h"

/* Returns the sign of x: 1, 0 or -1. */
VM_API int vmi_sign(vm_real x) { return (x > 0) - (x < 0); }

/* Stands for the place of an event that does not happen in the step. A place is a fraction of the step, from 0 to 1. */
#define VMI_NONE VM_C(2.0)

/* After an event, g is also evaluated at points just after the event, so that two further changes of its sign in a
   short time are found. The distance of the first point from the event is the fraction VMI_FIRST_LOOK of the step;
   each further distance is VMI_WIDER times as long as the distance before. The sign of g may count as uncertain (side
   0) until the fraction VMI_QUIET of the step has passed after the event. */
#if VM_MANT_DIG > 24
#define VMI_FIRST_LOOK VM_C(1.4901161193847656e-8) /* 2^-26 of a step, the square root of VM_EPSILON */
#define VMI_QUIET VM_C(6.103515625e-5)             /* 2^-14 of a step, the longest time for which a sign is uncertain */
#define VMI_WIDER 64
#else
#define VMI_FIRST_LOOK VM_C(2.44140625e-4) /* 2^-12 of a step, about the square root of VM_EPSILON */
#define VMI_QUIET VM_C(0.0009765625)       /* 2^-10 of a step, the longest time for which a sign is uncertain */
#define VMI_WIDER 8
#endif

/* Sets the side of each event, the sign of its g, at the start or the restart of a run. The side is 0 if g is 0, or if
   the event has just happened and g is so small that rounding could decide its sign. Returns a status. */
VM_API int vmi_watch_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        const vm_real g = e->g(s->t, s->y, e->ctx);
        if (g != g) return ODE_NOT_FINITE;
        if (!(VM_FABS(g) <= e->slack)) e->quiet = 0;
        e->side = 0;
        if (!(e->quiet > 0)) e->side = vmi_sign(g);
    }
    return ODE_OK;
}

/* Returns the time at the fraction x of the last step. */
VM_API vm_real vmi_time_inside(const rk45 *s, vm_real x)
{
    if (x == 1) return s->t;
    return s->t_old + (s->t_old_low + x * s->h_done);
}

/* Computes the state y at the fraction x of the last step. At x = 1 this is exactly s->y. */
VM_API void vmi_state_inside(const rk45 *s, vm_real x, vm_real *y)
{
    if (x == 1) vmi_copy(s->n, s->y, y);
    else vmi_inside(s, x, y);
}

/* Returns the value of g at the fraction x of the last step. The function overwrites the part VMI_Z of work. */
VM_API vm_real vmi_event_value(const rk45 *s, const ode_event *e, vm_real x)
{
    vm_real *z = vmi_part(s, VMI_Z);
    if (x == 1) return e->g(s->t, s->y, e->ctx);
    vmi_inside(s, x, z);
    return e->g(vmi_time_inside(s, x), z, e->ctx);
}

/* A bound of the relative change of a state that the rounding errors of all steps of a run so far may have caused. It
   serves only to decide whether events happen at the same time. */
#define VMI_EARLIER_ROUNDING (256 * VM_EPSILON)

/* Returns the value of g at the fraction x of the last step, in a state to which a rounding error is added on purpose.
   The error is the largest rounding error that this step may have made; if `earlier` is not 0, it is the largest that
   the whole run so far may have made. `direction`, -1 or 1, is the sign of the error. The size of the error is
   different for each component, so that the differences of components change, too. */
VM_API vm_real vmi_event_value_moved(const rk45 *s, const ode_event *e, vm_real x, int earlier,
                                     int direction)
{
    const vm_real relative = earlier ? VMI_EARLIER_ROUNDING : vmi_least_rtol(&s->pair);
    const vm_real end = earlier ? 1 : x; /* weight of s->y in `size`; the rounding error is proportional to `size` */
    const vm_real rounding = (vm_real)direction * relative, golden = VM_C(0.6180339887498949);
    const vm_real *y_old = vmi_part(s, VMI_Y_OLD);
    vm_real *z = vmi_part(s, VMI_Z), phase = 0;
    int i;
    vmi_state_inside(s, x, z);
    for (i = 0; i < s->n; i++) {
        const vm_real size = VM_FABS(y_old[i]) + VM_FABS(z[i]) + end * VM_FABS(s->y[i]);
        const vm_real share = phase - VM_C(0.5);
        z[i] += rounding * size * (share + VM_COPYSIGN(VM_C(0.5), share));
        phase += golden;
        if (phase >= 1) phase -= 1;
    }
    return e->g(vmi_time_inside(s, x) * (1 + (vm_real)direction * VM_EPSILON), z, e->ctx);
}

/* Sets e->slack to the largest |g| that rounding can cause at the fraction x of the last step; if `earlier` is not 0,
   the errors of all earlier steps of the run are included. Returns 1 if g certainly has the sign `side` there, in spite
   of rounding, else 0. */
VM_API int vmi_weigh_rounding(const rk45 *s, ode_event *e, vm_real x, int earlier, int side)
{
    int direction, certain = 1;
    e->slack = 0;
    for (direction = -1; direction <= 1; direction++) {
        vm_real g;
        if (direction == 0) g = vmi_event_value(s, e, x);
        else g = vmi_event_value_moved(s, e, x, earlier, direction);
        if (VM_FABS(g) > e->slack) e->slack = VM_FABS(g);
        if (vmi_sign(g) != side) certain = 0;
    }
    return certain;
}

/* Returns 1 if the field `direction` of the event lets it happen when g changes from the sign `side` to another sign,
   else 0. */
VM_API int vmi_counts_from(const ode_event *e, int side)
{
    return side && (e->direction == 0 || (e->direction > 0) == (side < 0));
}

/* Sets *at to a fraction of the last step between a and b at which g loses the sign that it has at a. ga and gb are
   the values of g at the fractions a and b. The interval from a to b is made smaller until its length is the
   resolution of such fractions, and *at becomes its right end. The method is false position in the Illinois form, with
   bisection in every third step and while g stays 0 at the right end. If g is 0 at the initial b, and the time there
   equals the time at *at, then *at becomes the initial b. Returns a status. */
VM_API int vmi_locate(const rk45 *s, const ode_event *e, vm_real a, vm_real ga, vm_real b, vm_real gb,
                      vm_real *at)
{
    const vm_real resolution = 2 * VM_EPSILON, look = b, g_look = gb;
    const int side = vmi_sign(ga);
    int count, kept = 0; /* 1 if the last x has become a, -1 if it has become b, 0 before the first x */
    for (count = 1; b - a > resolution; count++) {
        const int bisect = count % 3 == 0 || (gb == 0 && kept < 0);
        vm_real x = b - gb * ((b - a) / (gb - ga)), g;
        if (bisect) x = a + (b - a) / 2;
        x = VMI_SMALLER(VMI_LARGER(x, a + resolution / 2), b - resolution / 2);
        g = vmi_event_value(s, e, x);
        if (g != g) return ODE_NOT_FINITE;
        if (vmi_sign(g) == side) {
            a = x;
            ga = g;
            if (kept > 0) gb /= 2;
            kept = 1;
        } else {
            b = x;
            gb = g;
            if (kept < 0) ga /= 2;
            kept = -1;
        }
    }
    *at = b;
    if (g_look == 0 && vmi_time_inside(s, b) == vmi_time_inside(s, look)) *at = look;
    return ODE_OK;
}

enum { VMI_CHECKS = 3, VMI_MOST_CHECKS = 9999 }; /* default and limit of an event's `checks` */

/* Returns the fraction of the step at which g is evaluated next after e->from. It is the nearest of three fractions:
   the sum start + *gap, the next of the points that divide the step evenly, and `to`. *gap is short at first and grows
   with each call, so that two changes of sign of g in a time much shorter than the step are seen. */
VM_API vm_real vmi_next_look(const ode_event *e, vm_real start, vm_real *gap, vm_real to)
{
    const int wanted = e->checks == 0 ? (int)VMI_CHECKS : e->checks;
    const int checks = VMI_SMALLER(VMI_LARGER(wanted, 0), (int)VMI_MOST_CHECKS);
    const vm_real parts = (vm_real)(checks + 1);
    const int before = (int)(e->from * parts);
    const vm_real even = (vm_real)(before + 1) / parts;
    vm_real next = even;
    if (!(even > e->from)) next = (vm_real)(before + 2) / parts; /* rounding has made `even` equal to e->from */
    next = VMI_SMALLER(next, to);
    if (start + *gap < next) next = start + *gap;
    *gap *= VMI_WIDER;
    return next;
}

/* Sets the side of the event to 0 (uncertain), because g has just reached or passed 0 at the fraction x of the step.
   The side stays 0 while rounding could decide the sign of g, that is while |g| <= e->slack. But it stays 0 at most
   for the time e->quiet: if g has jumped, e->slack is much too large, so that |g| <= e->slack could be true for a long
   time. */
VM_API void vmi_quieten_event(const rk45 *s, ode_event *e, vm_real x)
{
    vmi_weigh_rounding(s, e, x, 0, 0);
    e->side = 0;
    e->quiet = VMI_QUIET * VM_FABS(s->h_done);
}

/* Handles a g that has passed 0 before the fraction x of the step in a direction that does not count. `side` is the
   sign of g at x. If rounding alone could have caused this sign, the side of the event becomes 0 and the result is 1,
   because no event may happen if rounding takes g back across 0. Otherwise nothing changes and the result is 0. */
VM_API int vmi_quieten_passing(const rk45 *s, ode_event *e, vm_real x, int side)
{
    ode_event look = *e;
    if (vmi_weigh_rounding(s, &look, x, 0, side)) return 0;
    vmi_quieten_event(s, e, x);
    return 1;
}

/* Evaluates g along the step from the fraction e->from to the fraction `to`, or until the event happens. *at becomes
   the fraction at which it happens, or VMI_NONE if it does not happen. e->from, e->side and e->quiet become those at
   the last evaluation. Returns a status. */
VM_API int vmi_follow_event(const rk45 *s, ode_event *e, vm_real to, vm_real *at)
{
    const vm_real h = VM_FABS(s->h_done);
    vm_real start = e->from, gap = e->side ? VM_C(1.0) : VMI_FIRST_LOOK;
    *at = VMI_NONE;
    while (e->from < to) {
        const vm_real before = e->from, x = vmi_next_look(e, start, &gap, to);
        const vm_real g = vmi_event_value(s, e, x);
        const int side = vmi_sign(g);
        if (g != g) return ODE_NOT_FINITE;
        if (side != e->side && vmi_counts_from(e, e->side)) {
            const vm_real g_before = vmi_event_value(s, e, before);
            int status = ODE_OK;
            if (g_before != g_before) return ODE_NOT_FINITE;
            *at = x;
            if (vmi_sign(g_before) == e->side) status = vmi_locate(s, e, before, g_before, x, g, at);
            e->from = *at;
            return status;
        }
        e->from = x;
        e->quiet = VMI_LARGER(e->quiet - (x - before) * h, VM_C(0.0));
        if (e->side && side != e->side && vmi_quieten_passing(s, e, x, side)) {
            start = x;
            gap = VMI_FIRST_LOOK;
            continue;
        }
        if (e->side || e->quiet == 0 || VM_FABS(g) > e->slack) e->side = side;
        /* Inside the step (start > 0), gap = 1 ends the evaluations of g at short distances as soon as its sign is
           certain; the evaluations at evenly spaced points go on. At the start of the step the evaluations at short
           distances go on, too: an event there may have changed y or f, so that g may change its sign twice in a short
           time. */
        if (e->side && start > 0) gap = 1;
    }
    return ODE_OK;
}

/* Counts an event that happens at the fraction x of the step. Stores its time and state if the caller's arrays have
   room. */
VM_API void vmi_record(const rk45 *s, ode_event *e, vm_real x)
{
    e->t = vmi_time_inside(s, x);
    if (e->count < e->room) {
        if (e->times) e->times[e->count] = e->t;
        if (e->states) vmi_state_inside(s, x, e->states + e->count * s->n);
    }
    e->count = vmi_count(e->count, 1);
    vmi_quieten_event(s, e, x);
}

/* Finds the first event that ends the step: *cut becomes the fraction of the step at which this event happens, and
   *owner the index of the event. Both stay as they are if no event ends the step. When an event is found, the functions
   g of all other events that can end a step are followed again up to *cut, because their values at *cut may show that
   one of them has an earlier zero. The search ends when there is no earlier zero. Returns a status. */
VM_API int vmi_find_cut(const rk45 *s, vm_real *cut, int *owner)
{
    int i, pass, found = 1;
    for (pass = 0; found; pass++) {
        found = 0;
        for (i = 0; i < s->options.n_events; i++) {
            ode_event *e = s->options.events + i, look;
            vm_real at;
            int status;
            if (!vmi_ends_step(e) || i == *owner) continue;
            look = *e;
            status = vmi_follow_event(s, &look, VMI_SMALLER(*cut, VM_C(1.0)), &at);
            if (status) return status;
            e->side_ahead = look.side;
            e->slack_ahead = look.slack;
            e->quiet_ahead = look.quiet;
            if (pass == 0 && !(at < *cut)) continue;
            if (pass > 0 && !(at < *cut - VMI_FIRST_LOOK)) continue;
            *cut = at;
            *owner = i;
            found = 1;
        }
        if (*cut == VMI_NONE) return ODE_OK;
    }
    return ODE_OK;
}

/* Counts how often the event e, which ends no step, happens up to the fraction `to` of the step, and stores its times
   and states (vmi_record). Returns a status. */
VM_API int vmi_record_until(const rk45 *s, ode_event *e, vm_real to)
{
    for (;;) {
        vm_real at;
        const int status = vmi_follow_event(s, e, to, &at);
        if (status || at == VMI_NONE) return status;
        vmi_record(s, e, at);
    }
}

/* Sets e->happens to 1 if the event e happens at the fraction x of the step, where the step ends, else to 0. The event
   happens if its g has changed sign before x or at x, in a direction that counts. It also happens if g at x is so
   small that rounding could have caused its sign, and g changes sign in such a direction just after x. Events at one
   instant must happen together, because the change that one event makes may keep the others from happening. Returns a
   status. */
VM_API int vmi_happens_at_cut(const rk45 *s, ode_event *e, vm_real x)
{
    ode_event look;
    vm_real at;
    int status = vmi_follow_event(s, e, x, &at);
    e->happens = at != VMI_NONE;
    if (status || e->happens || e->side == 0) return status;
    look = *e;
    if (vmi_weigh_rounding(s, &look, x, 1, e->side)) return ODE_OK;
    if (!vmi_counts_from(e, e->side)) {
        vmi_quieten_event(s, e, x);
        return ODE_OK;
    }
    /* g is followed up to x + VMI_QUIET, which may be after the end of the step (x = 1). The continuous extension
       gives a state there, too, but g may be NaN; the event then does not happen. */
    e->happens = vmi_follow_event(s, &look, x + VMI_QUIET, &at) == ODE_OK && at != VMI_NONE;
    return ODE_OK;
}

/* Ends the step at its fraction x: counts all events that happen there, then calls their `change` functions. Returns
   ODE_EVENT if one of these events stops the run, else ODE_OK. */
VM_API int vmi_cut_step(rk45 *s, vm_real x)
{
    const int n_events = s->options.n_events;
    int i;
    for (i = 0; i < n_events; i++) {
        ode_event *e = s->options.events + i;
        if (!e->happens) continue;
        vmi_record(s, e, x);
        if (vmi_stops_now(e) && s->event < 0) s->event = i;
    }
    if (x < 1) {
        const vm_two t = vmi_two_sum(s->t_old, s->t_old_low + x * s->h_done);
        vmi_inside(s, x, s->y);
        s->t = t.hi;
        s->t_low = t.lo;
    }
    s->k1 = VMI_K1_MISSING;
    for (i = 0; i < n_events; i++) {
        ode_event *e = s->options.events + i;
        if (e->happens && e->action == ODE_RESTART && e->change) e->change(s->t, s->y, e->ctx);
    }
    return s->event < 0 ? (int)ODE_OK : (int)ODE_EVENT;
}

/* Makes the next step a quarter as long as the last one. The last step was undone, because f or the state is not finite
   inside it. Returns ODE_NOT_FINITE if the next step would be shorter than the shortest step allowed, else ODE_OK. */
VM_API int vmi_shorten_step(rk45 *s)
{
    s->h = s->h_done / 4;
    s->rejected = vmi_count(s->rejected, 1);
    s->failed = 1;
    return VM_FABS(s->h) >= vmi_least_step(&s->options, s->t) ? (int)ODE_OK : (int)ODE_NOT_FINITE;
}

/* Decides for each event whether it happens at the fraction `cut` of the step, where the event with the index `owner`
   happens. Returns a status. */
VM_API int vmi_meet_at_cut(rk45 *s, vm_real cut, int owner)
{
    int i, status = ODE_OK;
    for (i = 0; i < s->options.n_events && status == ODE_OK; i++) {
        ode_event *e = s->options.events + i;
        e->happens = 1;
        if (i != owner) status = vmi_happens_at_cut(s, e, cut);
    }
    return status;
}

/* Sets side, slack and quiet of each event to those at the end of the step, if no event has ended the step earlier */
VM_API void vmi_pass_on_sides(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->happens = 0;
        if (!vmi_ends_step(e)) continue;
        e->side = e->side_ahead;
        e->slack = e->slack_ahead;
        e->quiet = e->quiet_ahead;
    }
}

/* Stores in the field `past` of each event the values that its fields have at the beginning of a step */
VM_API void vmi_keep_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->past.count = e->count;
        e->past.t = e->t;
        e->past.slack = e->slack;
        e->past.quiet = e->quiet;
        e->past.side = e->side;
    }
}

/* Undoes the last step, and takes back the counts of its events, because a function of the user failed during the
   search for events or the state at an event is not finite. The next call then makes the same step again, and no event
   is lost. */
VM_API void vmi_take_back_events(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->count = e->past.count;
        e->t = e->past.t;
        e->slack = e->past.slack;
        e->quiet = e->past.quiet;
        e->side = e->past.side;
    }
    vmi_take_back_step(s);
}

/* Finds the events of the last step, up to the first instant at which an event ends the step. *cut becomes the
   fraction of the step at this instant, or VMI_NONE. The derivatives that the continuous extension needs must be known
   (vmi_extend). Returns a status. */
VM_API int vmi_find_events(rk45 *s, vm_real *cut)
{
    const int n_events = s->options.n_events;
    ode_event *events = s->options.events;
    int i, owner = -1, status;
    *cut = VMI_NONE;
    for (i = 0; i < n_events; i++) events[i].from = 0;
    status = vmi_find_cut(s, cut, &owner);
    for (i = 0; i < n_events && status == ODE_OK; i++)
        if (!vmi_ends_step(events + i)) status = vmi_record_until(s, events + i, VMI_SMALLER(*cut, VM_C(1.0)));
    if (status == ODE_OK && *cut != VMI_NONE) status = vmi_meet_at_cut(s, *cut, owner);
    return status;
}

/* Returns 1 if the state at the fraction x of the last step is finite, else 0. Between two finite states the continuous
   extension may overflow if these states are close to the largest number of the type. The function overwrites the part
   VMI_Z of work. */
VM_API int vmi_is_finite_inside(const rk45 *s, vm_real x)
{
    vm_real *z = vmi_part(s, VMI_Z);
    if (x == 1) return 1;
    vmi_inside(s, x, z);
    return vmi_all_finite(s->n, z);
}

/* Handles the events of the last step, up to the first instant at which an event ends the step. Returns a status.
   After an error the step is undone. If the state at the instant of the event is not finite, the step is undone, too,
   and the next step is shorter. */
VM_API int vmi_events(rk45 *s)
{
    vm_real cut = VMI_NONE;
    int status = vmi_extend(s);
    if (status == ODE_NOT_FINITE) {
        vmi_take_back_step(s);
        return vmi_shorten_step(s);
    }
    vmi_keep_events(s);
    if (status == ODE_OK) status = vmi_find_events(s, &cut);
    if (status) {
        vmi_take_back_events(s);
        return status;
    }
    if (cut != VMI_NONE && !vmi_is_finite_inside(s, cut)) {
        vmi_take_back_events(s);
        return vmi_shorten_step(s);
    }
    if (cut != VMI_NONE) return vmi_cut_step(s, cut);
    vmi_pass_on_sides(s);
    return ODE_OK;
}

#endif
