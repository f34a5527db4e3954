/* integrators/options.h - options and events of an adaptive run
   A zeroed rk45_options means the defaults. An event is a change of sign of a function g(t, y) along a run, such as a
   bounce, g = height.

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
    ODE_RECORD = 0, /* it counts the event and goes on */
    ODE_STOP = 1,   /* it ends there with ODE_EVENT: a terminal event */
    ODE_RESTART = 2 /* it ends the step there, calls `change`, and begins a new step */
};

/* An event happens where g(t, y) reaches zero or changes its sign. The caller owns the array of events that the
   options point at. He sets the fields from g to states; the integrator sets the others. */
typedef struct VM_TAG(ode_event) {
    ode_event_function g; /* the function whose zeros are looked for */
    void *ctx;            /* given to g and to change */
    int direction; /* in the run's own direction: > 0 when g rises through zero, < 0 when it falls, 0 for both */
    int action;    /* ODE_RECORD, ODE_STOP or ODE_RESTART */
    int checks;    /* g is looked at in so many points inside each step; 0 means 3, negative none, at most 9999 */
    /* NULL, or what an ODE_RESTART calls. It may change y, and in ctx what f depends on. */
    void (*change)(vm_real t, vm_real *y, void *ctx);
    long room;       /* how many events times and states have room for; later events are counted only */
    vm_real *times;  /* NULL, or room for `room` times */
    vm_real *states; /* NULL, or room for `room` states of n numbers each */
    long count;      /* events so far */
    vm_real t;       /* time of the last event */
    /* The fields from here on are internal. */
    int side;       /* the sign of g where the run is, 0 while it is not known */
    int side_ahead; /* the side at the end of the step, if the step is not cut */
    int happens;    /* nonzero while the step is cut at an instant at which this event happens */
    vm_real from;   /* g has been looked at up to this fraction of the step */
    vm_real slack;  /* after an event the side stays unknown while |g| <= slack ... */
    vm_real quiet;  /* ... and for this time at most */
} ode_event;

/* The options of a run, zero meaning the default in every field. rk45_defaults shows what the defaults come to. */
typedef struct VM_TAG(rk45_options) {
    vm_real rtol;             /* relative tolerance of a step; default 1e-6 (float 1e-4), negative: none */
    vm_real atol;             /* absolute tolerance of every component; default rtol/1000, negative: none */
    vm_real h0;               /* first step, chosen from f by default. Its sign is the direction of rk45_step. */
    vm_real h_min;            /* shortest step; default: what t can resolve */
    vm_real h_max;            /* longest step; default: no limit */
    long max_steps;           /* attempts in one call of rk45_solve; default 1000000, negative: no limit */
    const vm_real *atol_each; /* NULL, or n absolute tolerances, one for each component, instead of atol; 0 is none */
    ode_event *events;        /* n_events events, or NULL */
    int n_events;             /* number of events */
    long work_size; /* how many numbers work has room for, e.g. sizeof work / sizeof *work; 0: it is not checked */
} rk45_options;

#if VM_MANT_DIG > 24
#define VMI_DEFAULT_RTOL VM_C(1e-6)
#else
#define VMI_DEFAULT_RTOL VM_C(1e-4)
#endif

/* The options with the defaults in place of zeros, and rtol raised to least_rtol */
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

/* The absolute tolerance of component i */
VM_INLINE vm_real vmi_atol(const rk45_options *o, int i) { return o->atol_each ? o->atol_each[i] : o->atol; }

/* Whether every component has a tolerance, and none is negative or NaN */
VM_API int vmi_tolerances_are_valid(const rk45_options *o, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        const vm_real atol = vmi_atol(o, i);
        if (!(atol >= 0) || !(atol + o->rtol > 0)) return 0;
    }
    return 1;
}

/* Whether a run of n components can begin with these options, after vmi_defaults has replaced the zeros */
VM_API int vmi_options_are_valid(const rk45_options *o, int n)
{
    int i;
    if (!VM_IS_FINITE(o->rtol) || !VM_IS_FINITE(o->atol) || !vmi_tolerances_are_valid(o, n)) return 0;
    if (!VM_IS_FINITE(o->h0) || !(o->h_min >= 0) || !(o->h_max >= o->h_min)) return 0;
    if (o->n_events < 0 || (o->n_events > 0 && !o->events)) return 0;
    for (i = 0; i < o->n_events; i++)
        if (!o->events[i].g || o->events[i].room < 0) return 0;
    return 1;
}

/* The error that component i may have in a step in which its size is |y|; always > 0 */
VM_INLINE vm_real vmi_tolerance(const rk45_options *o, int i, vm_real y)
{
    return vmi_atol(o, i) + o->rtol * VM_FABS(y) + VM_MIN;
}

#endif
