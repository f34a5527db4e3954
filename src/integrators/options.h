/* integrators/options.h - options and events of an adaptive run
   An rk45_options has the options of a run. If a field is 0, the run uses the default of this option. An event is a
   change of sign of a function g(t, y) along a run, such as a bounce, where g is a height.

       ode_event touch;
       rk45_options options;
       memset(&touch, 0, sizeof touch);
       memset(&options, 0, sizeof options);
       touch.g = height; // double height(double t, const double *y, void *ctx) returns y[0]
       touch.action = ODE_STOP;
       options.rtol = 1e-9;
       options.events = &touch;
       options.n_events = 1;

   Tests: tests/test_adaptive.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_OPTIONS_H
#define VARMASS_INTEGRATORS_OPTIONS_H

#include "../base/real.h"

/* A function of time and state whose zeros are events. */
typedef vm_real (*ode_event_function)(vm_real t, const vm_real *y, void *ctx);

/* What a run does at an event. */
enum {
    ODE_RECORD = 0, /* the run counts the event and goes on */
    ODE_STOP = 1,   /* the run ends at the event with the status ODE_EVENT */
    ODE_RESTART = 2 /* the run ends the step at the event, calls `change`, and begins a new step */
};

/* The values that some fields of an ode_event have at the beginning of a step. Each field here has the same name as
   the field of ode_event. A run stores these values so that it can undo the step */
typedef struct VM_TAG(vmi_event_past) {
    long count;
    vm_real t, slack, quiet;
    int side;
} vmi_event_past;

/* An event of a run: it happens when g(t, y) reaches zero or changes its sign. The caller makes an array of events, to
   which the field `events` of rk45_options points. The caller first sets all fields to 0, and then sets the fields
   that it needs among the fields from g to stop_after. The integrator sets the fields from count on. */
typedef struct VM_TAG(ode_event) {
    ode_event_function g; /* the function whose zeros are the event */
    void *ctx;            /* pointer that g and change receive */
    int direction; /* > 0: an event is a change of the sign of g from - to +, < 0: from + to -, 0: both */
    int action;    /* ODE_RECORD, ODE_STOP or ODE_RESTART */
    int checks;    /* number of points inside each step at which g is evaluated, at most 9999; 0: 3 points; < 0: none */
    /* NULL, or the function that an event with ODE_RESTART calls. It may change y, and in ctx the data on which f
       depends. */
    void (*change)(vm_real t, vm_real *y, void *ctx);
    long room;       /* number of events for which `times` and `states` have room; later events are only counted */
    vm_real *times;  /* NULL, or an array that receives the times of the first `room` events */
    vm_real *states; /* NULL, or an array that receives the states of the first `room` events, n numbers each */
    /* 0, or a number k > 0: the run ends with ODE_EVENT when this event happens for the kth time, the 2kth time and so
       on, whatever its action is. For k > 0 an event with ODE_STOP stops the run at these times only. Each time that
       such an event happens, it ends a step. */
    long stop_after;
    long count;      /* number of events so far */
    vm_real t;       /* time of the last event; the start of the run before the first one */
    /* The fields from here on are internal. */
    int side;       /* sign of g at the present time of the run, 0 while it is uncertain */
    int side_ahead; /* sign of g at the end of the step, if no event ends the step earlier */
    vm_real slack_ahead, quiet_ahead; /* slack and quiet at the end of the step, if no event ends the step earlier */
    int happens;    /* nonzero if this event happens at the end of the step */
    vm_real from;   /* g has been evaluated up to this fraction of the step */
    vm_real slack;  /* after the event, the sign of g is uncertain while |g| <= slack */
    vm_real quiet;  /* time after the event for which the sign of g may still be uncertain */
    vmi_event_past past; /* the fields at the beginning of the step, for a step that is undone */
} ode_event;

/* Options of a run. A zero in any field means its default; rk45_defaults shows all defaults. */
typedef struct VM_TAG(rk45_options) {
    vm_real rtol;             /* relative tolerance of a step; the default is 1e-6 (float 1e-4), negative means none */
    vm_real atol;             /* absolute tolerance of every component; the default is rtol/1000, negative means none */
    vm_real h0;               /* size of the first step, 0: computed from f. Its sign is the direction of rk45_step. */
    /* Where t has few digits left, rounding may make a step longer than h_max or shorter than h_min by 1/64 (TIME). */
    vm_real h_min;            /* size of the shortest step, except at t_end and events; default: the resolution of t */
    vm_real h_max;            /* size of the longest step; the default is no limit */
    long max_steps;           /* steps that a call of rk45_solve may try; default 1000000, negative means no limit */
    const vm_real *atol_each; /* NULL, or n absolute tolerances of the components, in place of atol; 0 means none */
    ode_event *events;        /* array of n_events events, or NULL */
    int n_events;             /* number of events */
    long work_size; /* number of elements of work, e.g. sizeof work / sizeof *work; 0 means that it is not checked */
} rk45_options;

#if VM_MANT_DIG > 24
#define VMI_DEFAULT_RTOL VM_C(1e-6)
#else
#define VMI_DEFAULT_RTOL VM_C(1e-4)
#endif

/* Returns the options with each zero replaced by its default, a positive rtol raised to at least least_rtol, and a
   negative rtol or atol replaced by 0. */
VM_API rk45_options vmi_defaults(vm_real least_rtol, const rk45_options *options_or_NULL)
{
    rk45_options o = {0, 0, 0, 0, 0, 0, NULL, NULL, 0, 0};
    if (options_or_NULL) o = *options_or_NULL;
    if (o.rtol == 0) o.rtol = VMI_DEFAULT_RTOL;
    if (o.rtol > 0 && o.rtol < least_rtol) o.rtol = least_rtol;
    if (o.atol == 0 && o.rtol > 0) o.atol = o.rtol * VM_C(1e-3);
    if (o.rtol < 0) o.rtol = 0;
    if (o.atol < 0) o.atol = 0;
    if (o.h_max == 0) o.h_max = VM_MAX;
    if (o.max_steps == 0) o.max_steps = 1000000L;
    return o;
}

/* Returns the absolute tolerance of component i. */
VM_INLINE vm_real vmi_atol(const rk45_options *o, int i) { return o->atol_each ? o->atol_each[i] : o->atol; }

/* Returns 1 if every component has a tolerance and no tolerance is negative or NaN, else 0. */
VM_API int vmi_tolerances_are_valid(const rk45_options *o, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        const vm_real atol = vmi_atol(o, i);
        if (!(atol >= 0) || !(atol + o->rtol > 0)) return 0;
    }
    return 1;
}

/* Returns 1 if a run of n components can begin with these options, else 0. vmi_defaults must have replaced the
   zeros. */
VM_API int vmi_options_are_valid(const rk45_options *o, int n)
{
    int i;
    if (!VM_IS_FINITE(o->rtol) || !VM_IS_FINITE(o->atol) || !vmi_tolerances_are_valid(o, n)) return 0;
    if (!VM_IS_FINITE(o->h0) || !(o->h_min >= 0) || !(o->h_max >= o->h_min)) return 0;
    if (o->n_events < 0 || (o->n_events > 0 && !o->events)) return 0;
    for (i = 0; i < o->n_events; i++)
        if (!o->events[i].g || o->events[i].room < 0 || o->events[i].stop_after < 0) return 0;
    return 1;
}

/* Returns 1 if the event ends the step in which it happens, else 0. */
VM_INLINE int vmi_ends_step(const ode_event *e) { return e->action != ODE_RECORD || e->stop_after > 0; }

/* Returns 1 if n >= 0 is a multiple of k > 0, else 0. The function does not divide: it subtracts k 2^j for smaller and
   smaller j. So a program for a processor without a division instruction needs no division routine for this
   function. */
VM_API int vmi_is_multiple(long n, long k)
{
    long part = k;
    while (part <= n - part) part *= 2;
    while (part > k) {
        if (n >= part) n -= part;
        part /= 2;
    }
    return n == 0 || n == k;
}

/* Returns 1 if the event, which has just been counted, ends the run, else 0. */
VM_API int vmi_stops_now(const ode_event *e)
{
    if (e->stop_after > 0) return vmi_is_multiple(e->count, e->stop_after);
    return e->action == ODE_STOP;
}

/* Returns 1 if any event can end the run, else 0. */
VM_API int vmi_an_event_stops(const rk45_options *o)
{
    int i;
    for (i = 0; i < o->n_events; i++)
        if (o->events[i].action == ODE_STOP || o->events[i].stop_after > 0) return 1;
    return 0;
}

/* Returns the tolerance of component i in a step, atol + rtol |y|, where y is the value of the component. VM_MIN is
   added so that the result is positive. */
VM_INLINE vm_real vmi_tolerance(const rk45_options *o, int i, vm_real y)
{
    return vmi_atol(o, i) + o->rtol * VM_FABS(y) + VM_MIN;
}

#endif
