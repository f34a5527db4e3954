/* Room for the bodies, effects and events of a scene, its state and its work, and the few lines that run it */
#ifndef STAGE_H
#define STAGE_H
#include "../../varmass.h"

enum { STAGE_BODIES = 4, STAGE_EFFECTS = 8, STAGE_EVENTS = 6, STAGE_STATE = 60 };

typedef struct stage {
    vm_scene scene;
    vm_scene_body bodies[STAGE_BODIES];
    vm_effect effects[STAGE_EFFECTS];
    vm_event events[STAGE_EVENTS];
    ode_event located[STAGE_EVENTS];
    vm_budget book;
    vm_real t, y[STAGE_STATE], work[VM_SCENE_WORK(STAGE_STATE)];
    vm_real end; /* when the run is over at the latest */
} stage;

static inline void stage_clear(stage *s, double end)
{
    memset(s, 0, sizeof *s);
    s->scene.bodies = s->bodies;
    s->scene.effects = s->effects;
    s->scene.events = s->events;
    s->scene.located = s->located;
    vm_scene_keep_budget(&s->scene, &s->book);
    s->end = (vm_real)end;
}

/* Each returns the index */
static inline int stage_body(stage *s, vm_scene_body body)
{
    return s->bodies[s->scene.n_bodies] = body, s->scene.n_bodies++;
}
static inline int stage_effect(stage *s, vm_effect effect)
{
    s->effects[s->scene.n_effects] = effect;
    return s->scene.n_effects++;
}
static inline int stage_event(stage *s, vm_event event)
{
    s->events[s->scene.n_events] = event;
    return s->scene.n_events++;
}

static inline int stage_start(stage *s)
{
    s->t = 0;
    return vm_scene_start(&s->scene, 0, s->y, NULL);
}

static inline rk45_options stage_options(void) /* closely */
{
    rk45_options o = rk45_defaults(NULL);
    o.rtol = 1000 * VM_EPSILON < (vm_real)1e-10 ? (vm_real)1e-11 : 10 * VM_EPSILON;
    o.atol = o.rtol / 100;
    return o;
}

static inline int stage_run(stage *s, double t_end) /* on to t_end */
{
    const rk45_options o = stage_options();
    return vm_scene_run(&s->scene, &s->t, (vm_real)t_end, s->y, s->work, &o);
}

/* What an event does whose law has a kink there: nothing, but that the integrator begins anew */
static inline int stage_kink(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    return VM_OK;
}

static inline vm_vec3 stage_vec(double x, double y, double z)
{
    return vmi_vec3((vm_real)x, (vm_real)y, (vm_real)z);
}
#define REAL(x) ((vm_real)(x))

static const double gravity = 9.81;

#endif
