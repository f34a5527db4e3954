/* scenes/run.h - runs of a scene with its events and its output

   vm_scene_run integrates a scene from one event to the next by the integrator rk45, and lets the events act on the
   scene.

       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                               // 2 = vm_scene_size(&scene)
       int status = vm_scene_start(&scene, t, y, NULL);                           // scene is a vm_scene
       if (status == VM_OK) status = vm_scene_run(&scene, &t, 10, y, work, NULL); // to 10 s

   Tests: tests/test_scene_runs.c, tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_RUN_H
#define VARMASS_SCENES_RUN_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/ode.h"
#include "../integrators/rk45.h"
#include "../integrators/runs.h"
#include "evaluate.h"
#include "scene.h"
#include "start.h"
#include "state.h"

/* How quickly events follow each other in a run */
typedef struct VM_TAG(vmi_scene_pace) {
    long happened; /* number of events at this instant */
    vm_real gap;   /* s: shortest time between a crossing at this instant and the previous crossing of the same event;
                      VM_MAX if there is no previous crossing */
    int crowded;   /* number of successive instants at which `gap` was too short for the digits of the time t */
} vmi_scene_pace;

enum {
    VMI_SCENE_MOST_EVENTS = 10000, /* largest number of events at one instant; more events count as an endless chain */
    VMI_SCENE_MOST_CROWDED = 3,    /* largest value of `crowded` with which a run continues */
    VMI_SCENE_STEPS_IN_GAP = 32    /* number of steps in a short time between events, so that no event is missed */
};

/* Returns 1 if event i is due at the time t, else 0. An event at a set time is due if this time has come. Any other
   event is due if the integrator has counted new crossings; the number of new crossings is written to *times. At the
   beginning of a run, the crossings that vmi_scene_keep_crossings has kept count as new. */
VM_API int vmi_scene_event_is_due(vm_scene *s, int i, vm_real t, long *times)
{
    vm_event *e = s->events + i;
    if (!e->when) return e->count == 0 && e->time <= t;
    *times = s->located[i].count - e->seen;
    e->seen = s->located[i].count;
    return *times > 0;
}

/* Applies to y, in the order of the list, each event that is due at the time t. Returns the first status other than
   VM_OK that an event gives, or VM_OK if all give VM_OK. After an error (a negative status) no further action is
   carried out; crossings that are only counted are counted nevertheless. The error is returned even if an earlier event
   has stopped the run. */
VM_API int vmi_scene_fire_events(vm_scene *s, vm_real t, vm_real *y, vmi_scene_pace *pace)
{
    int i, status = VM_OK;
    for (i = 0; i < s->n_events; i++) {
        vm_event *e = s->events + i;
        const vm_real last_time = e->time;
        const int is_only_counted = e->when && s->located[i].action == ODE_RECORD;
        long times = 1;
        int result = VM_OK;
        if (status < 0 && !is_only_counted) continue;
        if (!vmi_scene_event_is_due(s, i, t, &times) || (e->most && e->count >= e->most)) continue;
        if (is_only_counted) {
            e->count = vmi_count(e->count, times);
            e->time = s->located[i].t;
            continue;
        }
        if (e->when && e->count && t - e->time < pace->gap) pace->gap = t - e->time;
        if (e->when) e->time = t;
        e->count = vmi_count(e->count, 1);
        pace->happened++;
        if (e->then) result = e->then(e, t, y);
        if (e->left) { /* the next run does the rest */
            e->count--;
            e->time = last_time;
            if (e->when) e->seen -= times;
        }
        if (result < 0 || status == VM_OK) status = result;
    }
    return status;
}

/* Applies all events of an instant, including events that other events cause at the same instant. Events may follow
   each other faster and faster, like the contacts of a ball that bounces and comes to rest. The run ends when the
   number t has too few digits to distinguish the times of these events. Until then, the step after an event is made so
   short that the next event of this kind is found. */
VM_API int vmi_scene_run_events(vm_scene *s, rk45 *r, vm_real span, vmi_scene_pace *pace)
{
    const vm_real resolved = 256 * VM_EPSILON * span; /* s: fewer than two digits of a shorter gap are right */
    const vm_real steps = (vm_real)VMI_SCENE_STEPS_IN_GAP;
    int status = VM_OK;
    pace->happened = 0;
    pace->gap = VM_MAX;
    while (status == VM_OK) {
        const long before = pace->happened;
        status = vmi_scene_fire_events(s, r->t, r->y, pace);
        if (pace->happened == before) break;
        if (rk45_restart(r, r->t, r->y) < 0 && status >= 0) status = VM_NOT_FINITE;
        if (pace->happened > VMI_SCENE_MOST_EVENTS && status >= 0) status = VM_TOO_MANY_EVENTS;
    }
    if (pace->gap == VM_MAX) return status;
    if (pace->gap < resolved) pace->crowded++;
    else pace->crowded = 0;
    if (pace->crowded > VMI_SCENE_MOST_CROWDED && status == VM_OK) status = VM_TOO_MANY_EVENTS;
    if (r->h > pace->gap / steps) r->h = vmi_larger(pace->gap, resolved) / steps;
    return status;
}

/* Calls the caller's function scene.output if an output is due at the time t. *next is the index of the next time in
   scene.times. Returns VM_STOPPED if the function ends the run, an error if a mass is not finite, else VM_OK. */
VM_API int vmi_scene_output(vm_scene *s, vm_real t, const vm_real *y, int *next)
{
    int status;
    if (!s->output) return VM_OK;
    if (s->times) {
        if (*next >= s->n_times || t < s->times[*next]) return VM_OK;
        while (*next < s->n_times && s->times[*next] <= t) ++*next;
    }
    status = vmi_scene_weigh(s, t, y);
    if (status) return status;
    if (s->output(t, y, s, s->output_ctx)) return VM_STOPPED;
    return VM_OK;
}

/* The next set time of an event or of an output, or t_end if t_end is earlier */
VM_API vm_real vmi_scene_due(const vm_scene *s, vm_real t_end, int next)
{
    vm_real due = t_end;
    int i;
    if (s->output && s->times && next < s->n_times && s->times[next] < due) due = s->times[next];
    for (i = 0; i < s->n_events; i++) {
        const vm_event *e = s->events + i;
        if (!e->when && e->count == 0 && e->time < due) due = e->time;
    }
    return due;
}

/* Looks for the reason why a run ends. The function tests whether a mass or an inertia would soon reach 0 if the state
   continued to change at its present rates. It tries longer and longer steps, up to 1e-6 of the larger of |t| and
   |t_end| (in float 1e-3). The first failure of the right-hand side becomes s->status. There are two reasons for this
   search. First, a mass or an inertia close to 0 makes the equations so stiff that the steps become too short before
   the mass or the inertia is 0. Second, after a refused step the integrator tries shorter steps, which may have set
   s->status to VM_OK again. The run is over; therefore the function may overwrite parts of the work space of the
   integrator with a state and its rates. */
VM_API void vmi_scene_foresee(vm_scene *s, rk45 *r, vm_real t_end)
{
    const vm_real farthest = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    const vm_real size = vmi_larger(VM_FABS(r->t), VM_FABS(t_end));
    vm_real *z = vmi_part(r, VMI_Z), *rates = vmi_part(r, VMI_K), step;
    int i;
    for (step = 4 * VM_EPSILON * size + VM_MIN; step < farthest * size; step *= 4) { /* `size` may be subnormal */
        vm_scene_rhs(r->t, r->y, rates, s);
        if (s->status) return;
        for (i = 0; i < r->n; i++) z[i] = r->y[i] + step * rates[i];
        vm_scene_rhs(r->t + step, z, rates, s);
        if (s->status) return;
    }
}

/* Converts an error of the integrator, a status ODE_..., to the status VM_... of the scene */
VM_API int vmi_scene_status_of_ode(int ode_status)
{
    switch (ode_status) {
    case ODE_BAD_ARGUMENT:
    case ODE_WORK_TOO_SMALL: return VM_BAD_OPTIONS;
    case ODE_NOT_FINITE: return VM_NOT_FINITE;
    case ODE_STEP_TOO_SMALL: return VM_STEP_TOO_SMALL;
    default: return VM_NOT_INTEGRATED;
    }
}

/* Makes one step, which ends at the latest at the next set time of an event or of an output. If the integrator fails
   because a body cannot be accelerated, returns the reason for this and not the status of the integrator. */
VM_API int vmi_scene_step(vm_scene *s, rk45 *r, vm_real t_end, int next)
{
    const int ode_status = vmi_rk45_run(r, vm_scene_rhs, r->n, vmi_scene_due(s, t_end, next), 1);
    if (ode_status >= 0) return VM_OK;
    s->ode_status = ode_status;
    if (ode_status == ODE_MAX_STEPS) return VM_MAX_STEPS;
    if (!s->status) vmi_scene_foresee(s, r, t_end);
    if (s->status) return s->status;
    return vmi_scene_status_of_ode(ode_status);
}

/* Keeps the crossings that the last run has found but not handled. This happens if another event at the same instant
   returned an error first. The new run handles these crossings at its start. The integrator counts crossings from 0 in
   each run; therefore the field `seen` of an event becomes minus the number of its kept crossings. */
VM_API void vmi_scene_keep_crossings(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_events; i++) {
        s->events[i].seen -= s->located[i].count;
        s->located[i].count = 0;
    }
}

/* Calls rk45_init, but keeps the fields `quiet` and `slack` of some events, which rk45_init would set to 0. With them
   the integrator ignores the sign of an event function right after its event. They are kept for the events that
   happened at the time t: if one of several simultaneous events ended the last run there, the new run could otherwise
   find the rest of them a second time. They are also kept where `quiet` is VM_MAX, that is after a landing (contact.h):
   a body that rests on the ground could otherwise seem to land again. For all other events `quiet` becomes 0. */
VM_API int vmi_scene_init_integrator(vm_scene *s, rk45 *r, int n, vm_real t, const vm_real *y, vm_real *work,
                                     const rk45_options *o)
{
    int i, status;
    for (i = 0; i < s->n_events; i++) {
        ode_event *e = s->located + i;
        e->past.slack = e->slack;
        e->past.quiet = e->quiet;
        if (e->t != t && e->quiet < VM_MAX) e->past.quiet = 0;
    }
    status = rk45_init(r, vm_scene_rhs, s, n, t, y, o, work);
    for (i = 0; i < s->n_events && status >= 0; i++) {
        ode_event *e = s->located + i;
        e->slack = e->past.slack;
        e->quiet = e->past.quiet;
    }
    return status;
}

/* Prepares the integrator rk45 for the scene. Each number of a body has the absolute tolerance of the options. Each
   number of the budget has the tolerance VM_MAX, so that only the motion of the bodies determines the size of the
   steps. The tolerances are stored in work, after the numbers of the integrator. */
VM_API int vmi_scene_integrator(vm_scene *s, rk45 *r, vm_real t, const vm_real *y, vm_real *work,
                                const rk45_options *options_or_NULL)
{
    rk45_options o = rk45_defaults(options_or_NULL);
    const int n = vm_scene_size(s), n_bodies = s->budget ? n - VM_BUDGET_STATES : n;
    vm_real *atol = work + RK45_WORK(n);
    int i;
    if (o.work_size && o.work_size < VM_SCENE_WORK(n)) return VM_BAD_OPTIONS;
    if (o.rtol == 0) o.rtol = -1; /* no relative tolerance; rk45_init would replace 0 by the default */
    for (i = 0; i < n_bodies; i++) atol[i] = o.atol_each ? o.atol_each[i] : o.atol;
    for (; i < n; i++) atol[i] = VM_MAX;
    o.atol_each = atol;
    o.events = s->located;
    o.n_events = s->n_events;
    if (!vmi_all_finite(n, y)) return VM_NOT_FINITE;
    vmi_scene_keep_crossings(s);
    s->ode_status = vmi_scene_init_integrator(s, r, n, t, y, work, &o);
    if (s->ode_status < 0) return vmi_scene_status_of_ode(s->ode_status);
    return VM_OK;
}

VM_API int vmi_scene_check_run(const vm_scene *s, const vm_real *t, vm_real t_end)
{
    int size;
    if (!vmi_scene_has_lists(s) || !vmi_scene_is_list(s->n_events, s->events)) return VM_BAD_ARGUMENT;
    if (!vmi_scene_is_list(s->n_events, s->located)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(*t) || !VM_IS_FINITE(t_end)) return VM_NOT_FINITE;
    if (t_end < *t) return VM_BAD_TIMES;
    if (!vmi_scene_is_started(s)) return VM_NOT_STARTED;
    size = vm_scene_size(s);
    if (s->y_size && s->y_size < size) return VM_SHORT_ARRAY;
    if (s->work_size && s->work_size < VM_SCENE_WORK(size)) return VM_SHORT_ARRAY;
    return VM_OK;
}

/* Runs a scene from *t to t_end, with its events and its output, by the integrator rk45. The scene must have been
   started, and t_end must not be before *t. work has room for VM_SCENE_WORK(vm_scene_size(scene)) numbers.
   *options_or_NULL are options of rk45, in which events are not used; NULL stands for a relative error of 1e-6 per
   step (in float 1e-4). *t and y become the time and the state at the end of the run. Returns VM_OK if the run reached
   t_end; VM_STOPPED if an event or the output ended the run; an error in the arguments, with which nothing is done:
     VM_BAD_ARGUMENT       if a pointer is NULL or a count is negative;
     VM_NOT_FINITE         if *t, t_end or a number of y is not finite;
     VM_BAD_TIMES          if t_end < *t;
     VM_NOT_STARTED        if the scene was not started;
     VM_SHORT_ARRAY        if scene.y_size or scene.work_size is set and too small;
     VM_BAD_OPTIONS        if rk45 does not accept the options, or options.work_size is set and too small;
   or an error that ends the run:
     VM_BAD_MASS, VM_BAD_INERTIA, VM_NO_EFFECTIVE_MASS
                           if a mass or an inertia reached 0, even if the steps became too short just before;
     VM_NOT_FINITE         if an effect, a law or an event gave an infinite number or NaN;
     the status of a vm_law                   if this law failed;
     VM_SINGULAR           if a link, a joint or a spring between points cannot act;
     VM_BAD_ARGUMENT, VM_NO_SUCH_BODY
                           if a function of vm_effect_varying, or a call of vm_scene_push_at, has a wrong argument;
     another status        that a function of vm_effect_custom wrote to scene.status;
     VM_TOO_MANY_EVENTS    if events do not end: more than 10 000 events happen at one instant, or four times in
                           succession the time between two crossings of the same event is less than
                           256 VM_EPSILON max(|*t|, |t_end|);
     VM_IS_THERE, VM_IS_AWAY and the errors of vm_separate and vm_attach
                           if a jump is impossible;
     VM_STEP_TOO_SMALL, VM_MAX_STEPS   if the integrator failed; scene.ode_status is the status of the integrator;
     any other negative number         that an event's function (vm_then_user) returned. This event counts as handled.
   Another call continues from *t, beginning with the events of this instant that were not handled. If a mass law fails
   while the action of an event needs the masses, the action is not carried out, or only a part of it; the next call
   then carries out what is left of the action. */
VM_API int vm_scene_run(vm_scene *scene, vm_real *t, vm_real t_end, vm_real *y, vm_real *work,
                        const rk45_options *options_or_NULL)
{
    vmi_scene_pace pace = {0, 0, 0};
    int next = 0, status;
    vm_real span;
    rk45 r;
    if (!scene || !t || !y || !work) return VM_BAD_ARGUMENT;
    status = vmi_scene_check_run(scene, t, t_end);
    if (status) return status;
    scene->status = VM_OK;
    status = vmi_scene_integrator(scene, &r, *t, y, work, options_or_NULL);
    if (status) return status;
    span = vmi_larger(VM_FABS(*t), VM_FABS(t_end));
    while (scene->times && next < scene->n_times && scene->times[next] < *t) next++;
    for (;;) {
        status = vmi_scene_run_events(scene, &r, span, &pace);
        if (status == VM_OK) status = vmi_scene_output(scene, r.t, r.y, &next);
        if (status != VM_OK || r.t == t_end) break;
        status = vmi_scene_step(scene, &r, t_end, next);
        if (status != VM_OK) break;
    }
    *t = r.t;
    vmi_copy(r.n, r.y, y);
    vmi_scene_weigh(scene, *t, y);
    return status;
}

#endif
