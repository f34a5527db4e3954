/* integrators/events.h - events: where a function g(t, y) of the solution changes its sign
   After each step, g is followed along the continuous extension: it is looked at in a few points, and where it leaves
   its side, the place is located to rounding. The first event that stops or restarts the run cuts the step there.
   Events whose times rounding cannot tell apart happen together. Users set the events of the options: options.h.

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

VM_API int vmi_sign(vm_real x) { return (x > 0) - (x < 0); }

/* Places in a step are fractions of it, 0 to 1. This one means that there is no such place. */
#define VMI_NONE VM_C(2.0)

/* After an event, g is first looked at after the fraction VMI_FIRST_LOOK of a step, then at distances that grow by
   the factor VMI_WIDER. Its side is decided after the fraction VMI_QUIET at the latest. */
#if VM_MANT_DIG > 24
#define VMI_FIRST_LOOK VM_C(1.4901161193847656e-8) /* 2^-26 */
#define VMI_QUIET VM_C(6.103515625e-5)             /* 2^-14 */
#define VMI_WIDER 64
#else
#define VMI_FIRST_LOOK VM_C(2.44140625e-4) /* 2^-12 */
#define VMI_QUIET VM_C(0.0009765625)       /* 2^-10 */
#define VMI_WIDER 8
#endif

/* Sets the side of each event in a state that no step led to, at a start or a restart. The side is 0 where g is 0, and
   where the event has just happened and rounding could decide the sign of g. Returns a status. */
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

/* The time at the fraction x of the step */
VM_API vm_real vmi_time_inside(const rk45 *s, vm_real x)
{
    if (x == 1) return s->t;
    return s->t_old + (s->t_old_low + x * s->h_done);
}

/* y at the fraction x of the step; at its end to the bit */
VM_API void vmi_state_inside(const rk45 *s, vm_real x, vm_real *y)
{
    if (x == 1) vmi_copy(s->n, s->y, y);
    else vmi_inside(s, x, y);
}

/* g at the fraction x of the step. Uses z. */
VM_API vm_real vmi_event_value(const rk45 *s, const ode_event *e, vm_real x)
{
    vm_real *z = vmi_part(s, VMI_Z);
    if (x == 1) return e->g(s->t, s->y, e->ctx);
    vmi_inside(s, x, z);
    return e->g(vmi_time_inside(s, x), z, e->ctx);
}

/* What rounding may have done to a state, relative to it, in the steps of a run so far, as far as events that should
   coincide are concerned */
#define VMI_EARLIER_ROUNDING (256 * VM_EPSILON)

/* g at x in a state moved by what rounding may have done to it: in this step up to x, or, if `earlier`, in the steps
   before it as well. The sign of the move is `direction`. Each component is moved by another amount, so that a
   difference of components moves too. */
VM_API vm_real vmi_event_value_moved(const rk45 *s, const ode_event *e, vm_real x, int earlier,
                                     int direction)
{
    const vm_real relative = earlier ? VMI_EARLIER_ROUNDING : vmi_least_rtol(&s->pair);
    const vm_real end = earlier ? 1 : x; /* the share of the state at the end of the step */
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

/* Sets e->slack: the largest |g| that rounding can make at x. Returns whether rounding leaves g the sign `side`. */
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

/* Whether the event counts when g leaves `side` */
VM_API int vmi_counts_from(const ode_event *e, int side)
{
    return side && (e->direction == 0 || (e->direction > 0) == (side < 0));
}

/* Sets *at to the place in [a, b] at which g leaves the side that it has at a: the right end of [a, b] after it is
   shrunk to what x resolves. ga and gb are g at a and b. The method is false position in the Illinois form, with
   bisection every third time and where g is 0 over a distance. If g is 0 at b, and t cannot resolve how long before b
   it became 0, the place is b. Returns a status. */
VM_API int vmi_locate(const rk45 *s, const ode_event *e, vm_real a, vm_real ga, vm_real b, vm_real gb,
                      vm_real *at)
{
    const vm_real resolution = 2 * VM_EPSILON, look = b, g_look = gb;
    const int side = vmi_sign(ga);
    int count, kept = 0; /* kept: > 0 if the last point replaced a, < 0 if it replaced b */
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

/* The place of the next look at g after e->from. First come points at growing distances *gap from `start`, so that
   an excursion of g much shorter than the step is seen; then the points that divide the step evenly, and `to`. */
VM_API vm_real vmi_next_look(const ode_event *e, vm_real start, vm_real *gap, vm_real to)
{
    const int wanted = e->checks == 0 ? (int)VMI_CHECKS : e->checks;
    const int checks = VMI_SMALLER(VMI_LARGER(wanted, 0), (int)VMI_MOST_CHECKS);
    const vm_real parts = (vm_real)(checks + 1);
    const int before = (int)(e->from * parts);
    const vm_real even = (vm_real)(before + 1) / parts;
    vm_real next = even;
    if (!(even > e->from)) next = (vm_real)(before + 2) / parts; /* a quotient is rounded */
    next = VMI_SMALLER(next, to);
    if (start + *gap < next) next = start + *gap;
    *gap *= VMI_WIDER;
    return next;
}

/* To be called when g has just reached 0 at x or passed it. The side of g is then unknown while rounding could
   decide it, but only for the time e->quiet, since g may also have jumped. */
VM_API void vmi_quieten_event(const rk45 *s, ode_event *e, vm_real x)
{
    vmi_weigh_rounding(s, e, x, 0, 0);
    e->side = 0;
    e->quiet = VMI_QUIET * VM_FABS(s->h_done);
}

/* To be called when g has passed 0 before x in the direction that does not count; `side` is where g is now. If rounding
   alone could have brought g there, the side stays unknown for a while, so that rounding does not make an event when it
   takes g back, and the result is 1; else 0. */
VM_API int vmi_quieten_passing(const rk45 *s, ode_event *e, vm_real x, int side)
{
    ode_event look = *e;
    if (vmi_weigh_rounding(s, &look, x, 0, side)) return 0;
    vmi_quieten_event(s, e, x);
    return 1;
}

/* Follows g from e->from to `to`, or to the first place at which the event happens. *at becomes that place, or
   VMI_NONE if there is none; e->from and e->side are updated on the way. Returns a status. */
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
        if (e->side && start > 0) gap = 1; /* nothing was changed in the middle of a step: no short excursion begins */
    }
    return ODE_OK;
}

/* Counts the event at x, and writes its time and state where there is room */
VM_API void vmi_record(const rk45 *s, ode_event *e, vm_real x)
{
    e->t = vmi_time_inside(s, x);
    if (e->count < e->room) {
        if (e->times) e->times[e->count] = e->t;
        if (e->states) vmi_state_inside(s, x, e->states + e->count * s->n);
    }
    e->count++;
    vmi_quieten_event(s, e, x);
}

/* Finds the first event before *cut that ends the step: *cut becomes its place and *owner its index. The others
   are then looked at there, too, which may show an earlier one, so the search goes on until there is none. Returns a
   status. */
VM_API int vmi_find_cut(const rk45 *s, vm_real *cut, int *owner)
{
    int i, pass, found = 1;
    for (pass = 0; found; pass++) {
        found = 0;
        for (i = 0; i < s->options.n_events; i++) {
            ode_event *e = s->options.events + i, look;
            vm_real at;
            int status;
            if (e->action == ODE_RECORD || i == *owner) continue;
            look = *e;
            status = vmi_follow_event(s, &look, VMI_SMALLER(*cut, VM_C(1.0)), &at);
            if (status) return status;
            e->side_ahead = look.side;
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

/* Records all that an ODE_RECORD event asks for up to `to`. Returns a status. */
VM_API int vmi_record_until(const rk45 *s, ode_event *e, vm_real to)
{
    for (;;) {
        vm_real at;
        const int status = vmi_follow_event(s, e, to, &at);
        if (status || at == VMI_NONE) return status;
        vmi_record(s, e, at);
    }
}

/* Sets e->happens: whether e happens at x, where the step is cut. It does if its g has changed sign before x, or if
   g will change sign at once and is so small that rounding decides on which side of x. Events at one instant have
   to happen together, since what one of them changes may keep the others from happening. Returns a status. */
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
    /* also beyond the end of the step, where the continuous extension goes on; g need not exist there */
    e->happens = vmi_follow_event(s, &look, x + VMI_QUIET, &at) == ODE_OK && at != VMI_NONE;
    return ODE_OK;
}

/* Ends the step at x, where events happen: counts all of them, then calls their `change` functions. Returns ODE_EVENT
   if one of them stops the run. */
VM_API int vmi_cut_step(rk45 *s, vm_real x)
{
    const int n_events = s->options.n_events;
    int i;
    for (i = 0; i < n_events; i++) {
        ode_event *e = s->options.events + i;
        if (!e->happens) continue;
        vmi_record(s, e, x);
        if (e->action == ODE_STOP && s->event < 0) s->event = i;
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

/* Goes back to the beginning of the step just made, inside which f is not finite, to try a quarter of it. Returns
   ODE_NOT_FINITE if that is too short to be tried. */
VM_API int vmi_take_back(rk45 *s)
{
    vmi_copy(s->n, vmi_part(s, VMI_Y_OLD), s->y);
    s->t = s->t_old;
    s->t_low = s->t_old_low;
    s->h = s->h_done / 4;
    if (s->missed > 0 && s->next_miss == s->steps + VMI_BETWEEN_MISSES) {
        s->missed--;
        s->next_miss = 0;
    }
    s->steps--;
    s->rejected++;
    s->k1 = VMI_K1_READY; /* the step was kept apart from the next */
    s->failure = VMI_NOT_FINITE;
    return VM_FABS(s->h) >= vmi_least_step(&s->options, s->t) ? (int)ODE_OK : (int)ODE_NOT_FINITE;
}

/* Decides for each event whether it happens at `cut`, where event `owner` does. Returns a status. */
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

/* Takes the sides at the end of a step that no event cuts over into the next */
VM_API void vmi_pass_on_sides(rk45 *s)
{
    int i;
    for (i = 0; i < s->options.n_events; i++) {
        ode_event *e = s->options.events + i;
        e->happens = 0;
        if (e->action == ODE_RECORD) continue;
        e->side = e->side_ahead;
        e->quiet = VMI_LARGER(e->quiet - VM_FABS(s->h_done), VM_C(0.0));
    }
}

/* Handles the events of the step just made, up to the first instant with one that ends it. Returns a status. */
VM_API int vmi_events(rk45 *s)
{
    const int n_events = s->options.n_events;
    ode_event *events = s->options.events;
    vm_real cut = VMI_NONE;
    int i, owner = -1, status = vmi_extend(s);
    if (status == ODE_NOT_FINITE) return vmi_take_back(s);
    for (i = 0; i < n_events; i++) events[i].from = 0;
    if (status == ODE_OK) status = vmi_find_cut(s, &cut, &owner);
    for (i = 0; i < n_events && status == ODE_OK; i++)
        if (events[i].action == ODE_RECORD) status = vmi_record_until(s, events + i, VMI_SMALLER(cut, VM_C(1.0)));
    if (status) return status;
    if (cut == VMI_NONE) {
        vmi_pass_on_sides(s);
        return ODE_OK;
    }
    status = vmi_meet_at_cut(s, cut, owner);
    return status ? status : vmi_cut_step(s, cut);
}

#endif
