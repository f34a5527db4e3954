/* scenes/run.h - runs of a scene */
#ifndef VARMASS_SCENES_RUN_H
#define VARMASS_SCENES_RUN_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../integrators/adaptive.h"
#include "../integrators/ode.h"
#include "../integrators/runs.h"
#include "evaluate.h"
#include "scene.h"
#include "start.h"
#include "state.h"

/* The next time at which an event is due, or limit */
VM_API vm_real vmi_scene_due(const vm_scene *s, vm_real limit)
{
    int i;
    for (i = 0; i < s->n_events; i++) {
        const vm_event *e = s->events + i;
        if (!e->when && e->count == 0 && e->time < limit) limit = e->time;
    }
    return limit;
}

/* How events follow one another in a run */
typedef struct VM_TAG(vmi_scene_pace) {
    long happened; /* events at this instant */
    vm_real gap;   /* the shortest time since a crossing at this instant happened before, VM_MAX without one */
    int crowded;   /* so many instants one after another with a gap that the time hardly resolves */
} vmi_scene_pace;

/* What has happened at t happens to y: events at this time, and those that the integrator has counted anew; in the
   order of the events */
VM_API int vmi_scene_fire_events(vm_scene *s, vm_real t, vm_real *y, vmi_scene_pace *pace)
{
    int i, status = VM_OK;
    for (i = 0; i < s->n_events && status >= 0; i++) {
        vm_event *e = s->events + i;
        const ode_event *found = s->located + i;
        const long times = found->count - e->seen; /* negative as a run begins, which counts anew */
        const int now = e->when ? times > 0 : e->count == 0 && e->time <= t;
        int result;
        if (e->when) e->seen = found->count;
        if (!now || (e->most && e->count >= e->most)) continue;
        if (e->when && found->action == ODE_RECORD) {
            e->count += times;
            e->time = found->t;
            continue;
        }
        if (e->when && e->count && t - e->time < pace->gap) pace->gap = t - e->time;
        if (e->when) e->time = t;
        e->count++;
        pace->happened++;
        result = e->then ? e->then(e, t, y) : (int)VM_OK;
        if (result < 0 || status == VM_OK) status = result;
    }
    return status;
}

/* All events of an instant, since events may cause events. Events that follow one another faster and faster, as the
   contacts of a ball that comes to rest, are the end of the run where the time no longer resolves them; until then
   the step after such an event is short enough to see the next. */
VM_API int vmi_scene_run_events(vm_scene *s, rk45 *r, vm_real span, vmi_scene_pace *pace)
{
    const long most = 10000; /* at one instant */
    const vm_real resolved = 256 * VM_EPSILON * span;
    int status = VM_OK;
    for (pace->happened = 0, pace->gap = VM_MAX; status == VM_OK;) {
        const long before = pace->happened;
        status = vmi_scene_fire_events(s, r->t, r->y, pace);
        if (pace->happened == before) break;
        if (rk45_restart(r, r->t, r->y) < 0 && status >= 0) status = VM_NOT_FINITE;
        if (pace->happened > most && status >= 0) status = VM_TOO_MANY_EVENTS;
    }
    if (pace->gap == VM_MAX) return status;
    pace->crowded = pace->gap < resolved ? pace->crowded + 1 : 0;
    if (pace->crowded > 3 && status == VM_OK) status = VM_TOO_MANY_EVENTS;
    if (r->h > pace->gap / 32) r->h = pace->gap > resolved ? pace->gap / 32 : resolved / 32;
    return status;
}

VM_API int vmi_scene_output(vm_scene *s, vm_real t, const vm_real *y, int *next)
{
    if (!s->output) return VM_OK;
    if (s->times) {
        if (*next >= s->n_times || t < s->times[*next]) return VM_OK;
        while (*next < s->n_times && s->times[*next] <= t) ++*next;
    }
    vmi_scene_evaluate(s, t, y);
    return s->output(t, y, s, s->output_ctx) ? VM_STOPPED : VM_OK;
}

/* Whether a mass or an inertia would soon run out if the state went on at its present rates: tries longer and
   longer steps, up to a millionth of the time (float: a thousandth), and returns the first status that is not
   VM_OK. A mass or an inertia on its way to 0 makes the equations so stiff that no step gets beyond 0; and after a
   refused step shorter ones may have succeeded, so that s->status is VM_OK again. The run is over, so its work has
   room for a state and its rates. */
VM_API int vmi_scene_foresee(vm_scene *s, rk45 *r, vm_real t_end)
{
    const vm_real farthest = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    const vm_real size = VM_FABS(r->t) > VM_FABS(t_end) ? VM_FABS(r->t) : VM_FABS(t_end);
    vm_real *z = vmi_part(r, VMI_Z), *rates = vmi_part(r, VMI_K), step;
    int i;
    for (step = 4 * VM_EPSILON * size; step < farthest * size; step *= 4) {
        vm_scene_rhs(r->t, r->y, rates, s);
        if (s->status) return s->status;
        for (i = 0; i < r->n; i++) z[i] = r->y[i] + step * rates[i];
        vm_scene_rhs(r->t + step, z, rates, s);
        if (s->status) return s->status;
    }
    return VM_OK;
}

/* Why a run ends: a body that cannot be accelerated, if there is one, or what the integrator says */
VM_API int vmi_scene_gave_up(vm_scene *s, rk45 *r, vm_real t_end, int ode)
{
    if (ode == ODE_MAX_STEPS) return VM_MAX_STEPS;
    if (!s->status) vmi_scene_foresee(s, r, t_end);
    if (s->status) return s->status;
    if (ode == ODE_NOT_FINITE) return VM_NOT_FINITE;
    return ode == ODE_STEP_TOO_SMALL ? VM_STEP_TOO_SMALL : VM_NOT_INTEGRATED;
}

/* One step, or up to the next time at which something is due */
VM_API int vmi_scene_step(vm_scene *s, rk45 *r, vm_real t_end, int next)
{
    const int output = s->output && s->times && next < s->n_times && s->times[next] < t_end;
    const vm_real stop = vmi_scene_due(s, output ? s->times[next] : t_end);
    const int ode = vmi_run(r, VMI_RK45, vm_scene_rhs, r->n, stop, 1);
    if (ode >= 0) return VM_OK;
    s->ode_status = ode;
    return vmi_scene_gave_up(s, r, t_end, ode);
}

/* rk45 on the scene. Each number of the state has its tolerance, the book none: it follows the bodies' steps. */
VM_API int vmi_scene_integrator(vm_scene *s, rk45 *r, vm_real t, const vm_real *y, vm_real *work,
                                const rk45_options *options_or_NULL)
{
    rk45_options o = rk45_defaults(options_or_NULL);
    const int n = vm_scene_size(s), booked = s->book ? VM_BUDGET : 0;
    vm_real *atol = work + RK45_WORK(n);
    int i;
    for (i = 0; i < n; i++) atol[i] = i >= n - booked ? VM_MAX : o.atol_each ? o.atol_each[i] : o.atol;
    o.atol_each = atol;
    o.events = s->located;
    o.n_events = s->n_events;
    if (!vmi_all_finite(n, y)) return VM_NOT_FINITE;
    s->ode_status = rk45_init(r, vm_scene_rhs, s, n, t, y, &o, work);
    r->attempts = o.max_steps;
    return s->ode_status < 0 ? (int)VM_BAD_OPTIONS : (int)VM_OK;
}

/* On from *t to t_end >= *t by rk45, events included: VM_OK, VM_STOPPED before t_end, or what went wrong; *t and y
   are where the run ended. work: VM_SCENE_WORK(vm_scene_size) numbers. The options' own events are not used. Events
   that do not end are VM_TOO_MANY_EVENTS: more than 10 000 at one instant, or four times in succession again after
   less than 256 eps of the time. VM_BAD_MASS or VM_BAD_INERTIA: a mass or an inertia ran out, even if the steps
   became too short just before that. VM_NOT_FINITE: an effect, a law or an event gave NaN or infinity.
   VM_STEP_TOO_SMALL, VM_MAX_STEPS and VM_BAD_OPTIONS come from the integrator, whose own status is in
   scene.ode_status. */
VM_API int vm_scene_run(vm_scene *scene, vm_real *t, vm_real t_end, vm_real *y, vm_real *work,
                        const rk45_options *options_or_NULL)
{
    vmi_scene_pace pace = {0, 0, 0};
    int next = 0, status;
    vm_real span;
    rk45 r;
    if (!scene || !t || !y || !work) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(*t) || !VM_IS_FINITE(t_end)) return VM_NOT_FINITE;
    if (t_end < *t) return VM_BAD_TIMES;
    if (!vmi_scene_is_started(scene)) return VM_NOT_STARTED;
    status = vm_scene_size(scene);
    if (scene->y_size && scene->y_size < status) return VM_SHORT_ARRAY;
    if (scene->work_size && scene->work_size < VM_SCENE_WORK(status)) return VM_SHORT_ARRAY;
    scene->status = VM_OK;
    status = vmi_scene_integrator(scene, &r, *t, y, work, options_or_NULL);
    if (status) return status;
    span = VM_FABS(*t) > VM_FABS(t_end) ? VM_FABS(*t) : VM_FABS(t_end);
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
    vmi_scene_evaluate(scene, *t, y);
    return status;
}

#endif
