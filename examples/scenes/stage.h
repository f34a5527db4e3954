/* A stage has arrays for the bodies, the effects and the events of a scene, for its state and for the work space of
   the integrator. The functions of this file fill the arrays, and start and run the scene. */
#ifndef STAGE_H
#define STAGE_H
#include "../../varmass.h"
#include <stdio.h>
#include <stdlib.h>

enum { STAGE_BODIES = 5, STAGE_EFFECTS = 16, STAGE_EVENTS = 6, STAGE_STATE = 60 };

typedef struct stage {
    vm_scene scene;
    vm_scene_body bodies[STAGE_BODIES];
    vm_effect effects[STAGE_EFFECTS];
    vm_event events[STAGE_EVENTS];
    ode_event located[STAGE_EVENTS];
    vm_budget book;
    vm_real t, y[STAGE_STATE], work[VM_SCENE_WORK(STAGE_STATE)];
    vm_real end; /* s: the latest end of the run */
} stage;

static inline void stage_clear(stage *s, double end)
{
    memset(s, 0, sizeof *s);
    s->scene.bodies = s->bodies;
    s->scene.effects = s->effects;
    s->scene.events = s->events;
    s->scene.located = s->located;
    s->scene.y_size = VM_LENGTH(s->y);
    s->scene.work_size = VM_LENGTH(s->work);
    vm_scene_keep_budget(&s->scene, &s->book);
    s->end = (vm_real)end;
}

/* Returns the next free index of an array with `room` elements. If the array is full, the program ends with a
   message. */
static inline int stage_next(int *count, int room, const char *name)
{
    if (*count >= room) {
        fprintf(stderr, "stage.h: the stage has room for %d only: enlarge %s\n", room, name);
        exit(EXIT_FAILURE);
    }
    return (*count)++;
}

/* Each of these returns the index of what it has added. */
static inline int stage_body(stage *s, vm_scene_body body)
{
    const int i = stage_next(&s->scene.n_bodies, STAGE_BODIES, "STAGE_BODIES");
    s->bodies[i] = body;
    return i;
}
static inline int stage_effect(stage *s, vm_effect effect)
{
    const int i = stage_next(&s->scene.n_effects, STAGE_EFFECTS, "STAGE_EFFECTS");
    s->effects[i] = effect;
    return i;
}
static inline int stage_event(stage *s, vm_event event)
{
    const int i = stage_next(&s->scene.n_events, STAGE_EVENTS, "STAGE_EVENTS");
    s->events[i] = event;
    return i;
}

/* Adds all four effects of a stream that varies in time: mass, force, moment and torque. */
static inline void stage_varying_stream(stage *s, int body, const vm_stream *stream,
                                        void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx),
                                        void *ctx)
{
    stage_effect(s, vm_effect_varying(vm_effect_stream_mass(body, stream), vary, ctx));
    stage_effect(s, vm_effect_varying(vm_effect_stream_force(body, stream), vary, ctx));
    stage_effect(s, vm_effect_varying(vm_effect_stream_moment(body, stream), vary, ctx));
    stage_effect(s, vm_effect_varying(vm_effect_stream_torque(body, stream), vary, ctx));
}

/* Starts at t = 0. If the state is too long for the stage, vm_scene_start returns VM_SHORT_ARRAY. */
static inline int stage_start(stage *s)
{
    s->t = 0;
    return vm_scene_start(&s->scene, 0, s->y, NULL);
}

/* Tolerances near the smallest that the number type allows. In float, rounding of the forces in machines with stiff
   springs causes errors of a step that are larger than 1e-6: with an absolute tolerance below 1e-6 there would be very
   many short steps. */
static inline rk45_options stage_options(void)
{
    rk45_options o = rk45_defaults(NULL);
    o.rtol = 1000 * VM_EPSILON < (vm_real)1e-10 ? (vm_real)1e-11 : 10 * VM_EPSILON;
    o.atol = VM_MANT_DIG > 24 ? o.rtol / 100 : o.rtol;
    return o;
}

/* Continues the run from s->t to t_end. */
static inline int stage_run(stage *s, double t_end)
{
    const rk45_options o = stage_options();
    return vm_scene_run(&s->scene, &s->t, (vm_real)t_end, s->y, s->work, &o);
}

/* The action of an event at which a law has a kink: it changes nothing, but the integrator starts anew there. */
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

static const double gravity = 9.81; /* m/s^2 */

/* -- Mechanisms of bodies whose angles are 0 at the start -- */

/* Adds a body in the plane at rest, with the mass b[0] and the moment of inertia b[1], at the point b[2], b[3] */
static inline int stage_plane(stage *s, const double *b)
{
    const vm_vec3 r = stage_vec(b[2], b[3], 0), zero = stage_vec(0, 0, 0);
    return stage_body(s, vm_scene_body_plane(REAL(b[0]), REAL(b[1]), r, 0, zero, 0));
}

/* A point of the ground or of a body, given by its position at the start, when all angles are 0 */
static inline vm_vec3 stage_point(const stage *s, int body, double x, double y)
{
    const vm_vec3 p = stage_vec(x, y, 0);
    return body < 0 ? p : vm_sub(p, s->bodies[body].start.r);
}

/* A spring without tension at the start, from the point e[0], e[1] of a body to e[2], e[3] of another or the ground */
static inline vm_point_spring stage_spring(const stage *s, int body, int other, const double *e)
{
    vm_point_spring spring = {{0, 0, 0}, {0, 0, 0}, REAL(e[4]), REAL(e[5]), 0};
    spring.at = stage_point(s, body, e[0], e[1]);
    spring.other_at = stage_point(s, other, e[2], e[3]);
    spring.rest = vm_norm(stage_vec(e[0] - e[2], e[1] - e[3], 0));
    return spring;
}

static inline vm_joint stage_pin(const stage *s, int body, int other, double x, double y)
{
    return vm_joint_pin(body, stage_point(s, body, x, y), other, stage_point(s, other, x, y));
}

/* A rod between two points, which are given in the same way as for stage_spring */
static inline vm_joint stage_rod(const stage *s, int body, int other, const double *e)
{
    const vm_real length = vm_norm(stage_vec(e[0] - e[2], e[1] - e[3], 0));
    return vm_joint_rod(body, stage_point(s, body, e[0], e[1]), other, stage_point(s, other, e[2], e[3]), length);
}

/* The vector to the point e[0], e[1] of a body from the point e[2], e[3] of another, in the state y */
static inline vm_vec3 stage_between(const stage *s, int body, int other, const double *e, const vm_real *y)
{
    vm_vec3 here, there, v;
    vm_scene_point_at(&s->scene, body, stage_point(s, body, e[0], e[1]), y, &here, &v);
    vm_scene_point_at(&s->scene, other, stage_point(s, other, e[2], e[3]), y, &there, &v);
    return vm_sub(here, there);
}

#endif
