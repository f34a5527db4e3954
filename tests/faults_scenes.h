/* faults_scenes.h - scenes with effects, events and an output of a user that fail */
#ifndef FAULTS_SCENES_H
#define FAULTS_SCENES_H

#include "faults.h"

enum { FAULT_SCENE_BODIES = 3, FAULT_SCENE_STATES = 48, FAULT_SCENE_EVENTS = 4 };

/* A scene with all that it needs */
typedef struct fault_scene {
    vm_scene scene;
    vm_scene_body bodies[FAULT_SCENE_BODIES];
    vm_effect effects[6];
    vm_event events[FAULT_SCENE_EVENTS], actions[3];
    ode_event located[FAULT_SCENE_EVENTS];
    vm_real y[FAULT_SCENE_STATES], work[VM_SCENE_WORK(FAULT_SCENE_STATES)];
    vm_real t;
    vm_law law;
    vm_budget budget;
    vm_body part;
    vm_stream stream;
    long outputs; /* number of times of output that were reached */
} fault_scene;

/* Two bodies on a line: body 0 on a spring at the ground, and body 1 on a spring at body 0 */
static inline void fault_scene_clear(fault_scene *f)
{
    memset(f, 0, sizeof *f);
    f->scene.bodies = f->bodies;
    f->scene.effects = f->effects;
    f->scene.events = f->events;
    f->scene.located = f->located;
    f->bodies[0] = vm_scene_body_line(2, 1, 0);
    f->bodies[1] = vm_scene_body_line(1, 2, 1);
    f->scene.n_bodies = 2;
    f->effects[0] = vm_effect_linear_spring(0, 0, VM_GROUND, 0, 3, 0);
    f->effects[1] = vm_effect_linear_spring(1, 0, 0, 0, 2, 1);
    f->scene.n_effects = 2;
}

/* Adds an effect before the others. */
static inline void fault_first_effect(fault_scene *f, vm_effect first)
{
    int i;
    for (i = f->scene.n_effects++; i > 0; i--) f->effects[i] = f->effects[i - 1];
    f->effects[0] = first;
}

/* A number that depends on the motion, on the masses and on the events of a scene */
static inline double fault_scene_sum(const fault_scene *f)
{
    double sum = (double)fault_sum(vm_scene_size(&f->scene), f->y) + (double)f->outputs;
    int i;
    for (i = 0; i < f->scene.n_bodies; i++)
        if (!f->bodies[i].away) sum += (i + 1) * (double)f->bodies[i].load.mass;
    for (i = 0; i < f->scene.n_events; i++) sum += (i + 1) * (double)f->events[i].count;
    return sum;
}

/* Starts the scene and runs it to t_end. After an error the run goes on with another call. A last call without faults
   evaluates the masses at t_end that the result needs. */
static inline void fault_scene_play(fault_scene *f, vm_real t_end, outcome *o)
{
    int i, n;
    o->again = vm_scene_start(&f->scene, 0, f->y, NULL);
    if (o->again < 0) o->status = o->again;
    if (o->again < 0) o->again = vm_scene_start(&f->scene, 0, f->y, NULL);
    n = vm_scene_size(&f->scene);
    for (i = 0; i < 6 && o->again >= 0 && f->t < t_end; i++) {
        const int status = vm_scene_run(&f->scene, &f->t, t_end, f->y, f->work, NULL);
        if (status != VM_OK && o->status == 0) o->status = status;
        o->sound = o->sound && f->t >= 0 && f->t <= t_end && vmi_all_finite(n, f->y);
    }
    if (f->t != t_end) o->again = -1;
    fault.at = -1;
    if (o->again >= 0) o->again = vm_scene_run(&f->scene, &f->t, t_end, f->y, f->work, NULL);
    o->result = fault_scene_sum(f);
}

/* ---- Effects ---- */

static inline vm_real faulty_scene_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)v;
    (void)ctx;
    return fault_value(fault_strikes(), -x + t / 8);
}
static inline void fault_scene_force(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.effects[2] = vm_effect_force_between(1, 0, 0, 0, faulty_scene_force, NULL);
    f.scene.n_effects = 3;
    fault_scene_play(&f, 3, o);
}

static inline void faulty_custom(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)t;
    (void)scene;
    e->load->force[0] += fault_value(fault_strikes(), -y[e->v]);
}
static inline void fault_scene_custom(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.effects[2] = vm_effect_custom(0, VM_GROUND, faulty_custom, NULL);
    f.scene.n_effects = 3;
    fault_scene_play(&f, 3, o);
}

/* A custom effect that fails by the scene's status, as the library's own effects do */
static inline void faulty_custom_status(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const int strikes = fault_strikes();
    (void)t;
    e->load->force[0] += fault_value(strikes, -y[e->v]);
    if (fault_status(strikes)) scene->status = VM_SINGULAR;
}
static inline void fault_scene_custom_status(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.effects[2] = vm_effect_custom(0, VM_GROUND, faulty_custom_status, NULL);
    f.scene.n_effects = 3;
    fault_scene_play(&f, 3, o);
}

static inline vm_mass_law_values faulty_mass_law(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const int strikes = fault_strikes();
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)x;
    (void)v;
    (void)ctx;
    now.mass = fault_value(strikes, 2 + t / 16);
    now.by_t = R(0.0625);
    return now;
}
static inline void fault_scene_mass_law(outcome *o)
{
    const vm_vec3 zero = {0, 0, 0};
    fault_scene f;
    fault_scene_clear(&f);
    fault_first_effect(&f, vm_effect_mass_law(0, faulty_mass_law, NULL, zero, 1));
    fault_scene_play(&f, 3, o);
}

static inline int faulty_mass_of_time(vm_real t, vm_real *m, vm_real *rate, void *ctx)
{
    const int strikes = fault_strikes();
    (void)ctx;
    *m = fault_value(strikes, 2 + t / 16);
    *rate = R(0.0625);
    return fault_status(strikes);
}
static inline void fault_scene_mass_of_time(outcome *o)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_law law = vm_law_user(faulty_mass_of_time, NULL);
    fault_scene f;
    fault_scene_clear(&f);
    fault_first_effect(&f, vm_effect_mass_of_time(0, &law, zero, 1));
    fault_scene_play(&f, 3, o);
}

static inline void faulty_vary(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)y;
    (void)ctx;
    stream->rate = fault_value(fault_strikes(), R(0.125) + t / 16);
}
static inline void fault_scene_varying(outcome *o)
{
    vm_stream stream;
    fault_scene f;
    fault_scene_clear(&f);
    memset(&stream, 0, sizeof stream);
    f.bodies[1] = vm_scene_body_plane(1, 1, vmi_vec3(2, 0, 0), 0, vmi_vec3(1, 0, 0), R(0.5));
    f.bodies[1] = vm_scene_body_growing_plane(f.bodies[1]);
    f.effects[2] = vm_effect_varying(vm_effect_stream_mass(1, &stream), faulty_vary, NULL);
    f.scene.n_effects = 3;
    fault_scene_play(&f, 3, o);
}

/* A support that moves by cos(t), with a pendulum of 2 m on a link */
static inline void faulty_support(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const int strikes = fault_strikes();
    (void)ctx;
    *r = vmi_vec3(fault_value(strikes, (vm_real)cos((double)t) / 8), 0, 0);
    *v = vmi_vec3(fault_value(strikes, -(vm_real)sin((double)t) / 8), 0, 0);
    *a = vmi_vec3(fault_value(strikes, -(vm_real)cos((double)t) / 8), 0, 0);
}
static inline void fault_scene_link(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.bodies[0] = vm_scene_body_point(1, vmi_vec3(R(0.125), -2, 0), vmi_vec3(0, 0, 0));
    f.scene.n_bodies = 1;
    f.effects[0] = vm_effect_gravity(0, 1, R(-9.81));
    f.effects[1] = vm_effect_link(0, VM_GROUND, faulty_support, NULL, 2, 0, 10);
    fault_scene_play(&f, 3, o);
}

/* ---- Events and output ---- */

static inline vm_real faulty_when(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return fault_value(fault_strikes(), y[0] - y[2]);
}

/* An event of a user's function, and two more events whose counts show whether they were lost */
static inline void fault_scene_when(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.events[0] = vm_event_user(faulty_when, NULL, 0);
    f.events[1] = vm_event_velocity(0, 0, 0, 0);
    f.events[2] = vm_then_switch(vm_event_at(1), 0, 1);
    f.scene.n_events = 3;
    fault_scene_play(&f, 3, o);
}

/* An action that changes nothing */
static inline int faulty_then(vm_real t, vm_real *y, void *ctx)
{
    const int strikes = fault_strikes();
    (void)t;
    (void)ctx;
    (void)y;
    return fault_status(strikes);
}

/* Two events at one instant, of which the first or the second fails, and an event of time */
static inline void fault_scene_then(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.events[0] = vm_then_user(vm_event_position(0, 0, R(0.75), 0), faulty_then, NULL);
    f.events[1] = vm_then_user(vm_event_position(0, 0, R(0.75), 0), faulty_then, NULL);
    f.events[2] = vm_then_user(vm_event_at(1), faulty_then, NULL);
    f.scene.n_events = 3;
    fault_scene_play(&f, 3, o);
}

/* An action that sets the velocity of body 0. A NaN ends the run at the time of the event with this NaN in the state;
   another call goes on with the right velocity. */
#define FAULT_SET_VELOCITY R(0.25)
static inline int faulty_set(vm_real t, vm_real *y, void *ctx)
{
    const int strikes = fault_strikes();
    (void)t;
    (void)ctx;
    y[1] = fault_value(strikes, FAULT_SET_VELOCITY);
    return fault_status(strikes);
}
static inline void fault_play_set(fault_scene *f, outcome *o)
{
    int i;
    o->again = vm_scene_start(&f->scene, 0, f->y, NULL);
    for (i = 0; i < 6 && f->t < 3; i++) {
        o->again = vm_scene_run(&f->scene, &f->t, 3, f->y, f->work, NULL);
        if (o->again < 0 && o->status == 0) o->status = o->again;
        o->sound = o->sound && f->t > 0 && f->t <= 3;
        if (o->again < 0) f->y[1] = FAULT_SET_VELOCITY;
        o->sound = o->sound && vmi_all_finite(vm_scene_size(&f->scene), f->y);
    }
    if (f->t != 3) o->again = -1;
    o->result = fault_scene_sum(f);
}
static inline void fault_scene_set(outcome *o)
{
    fault_scene f;
    fault_scene_clear(&f);
    f.events[0] = vm_then_user(vm_event_position(1, 0, R(2.25), 0), faulty_set, NULL);
    f.events[1] = vm_then_user(vm_event_at(1), faulty_set, NULL);
    f.scene.n_events = 2;
    fault_play_set(&f, o);
}

/* A list of two such actions */
static inline void fault_scene_set_twice(outcome *o)
{
    const vm_event any = vm_event_position(1, 0, R(2.25), 0);
    fault_scene f;
    fault_scene_clear(&f);
    f.actions[0] = vm_then_user(any, faulty_set, NULL);
    f.actions[1] = vm_then_user(any, faulty_set, NULL);
    f.events[0] = vm_then_all(any, f.actions, 2);
    f.scene.n_events = 1;
    fault_play_set(&f, o);
}

static inline int faulty_output(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    fault_scene *f = (fault_scene *)ctx;
    const int strikes = fault_strikes();
    (void)t;
    (void)y;
    (void)scene;
    if (!strikes) f->outputs++;
    return fault_status(strikes);
}

/* Output at three times. A time at which it failed is offered again in the next call. */
static inline void fault_scene_output(outcome *o)
{
    static const vm_real times[3] = {R(0.5), 1, R(2.5)};
    fault_scene f;
    fault_scene_clear(&f);
    f.scene.output = faulty_output;
    f.scene.output_ctx = &f;
    f.scene.times = times;
    f.scene.n_times = 3;
    fault_scene_play(&f, 3, o);
}

/* Where a shorter step may step over a NaN, the results differ within the tolerance 1e-6 (float 1e-4). */
#ifdef VM_USE_FLOAT
#define FAULT_SCENE (1e-2 / (double)VM_EPSILON)
#else
#define FAULT_SCENE (1e-4 / (double)VM_EPSILON)
#endif

/* The run of a scene, with the kinds of faults that its functions have, and the status where one returns a number */
#define FAULT_OF_SCENE(name, run, kinds, stopped) \
    {name, run, {kinds, stopped, VM_NOT_FINITE, FAULT_SCENE, 0, 0}, NULL, NULL}

static const scenario fault_scenes[] = {
    FAULT_OF_SCENE("vm_effect_force_between", fault_scene_force, FAULT_NAN, 0),
    FAULT_OF_SCENE("vm_effect_custom", fault_scene_custom, FAULT_NAN, 0),
    FAULT_OF_SCENE("custom, scene.status", fault_scene_custom_status, FAULT_ALL, VM_SINGULAR),
    FAULT_OF_SCENE("vm_effect_mass_law", fault_scene_mass_law, FAULT_NAN, 0),
    FAULT_OF_SCENE("vm_effect_mass_of_time", fault_scene_mass_of_time, FAULT_ALL, VM_DOMAIN),
    FAULT_OF_SCENE("vm_effect_varying", fault_scene_varying, FAULT_NAN, 0),
    FAULT_OF_SCENE("vm_effect_link", fault_scene_link, FAULT_NAN, 0),
    FAULT_OF_SCENE("vm_event_user", fault_scene_when, FAULT_NAN, 0),
    FAULT_OF_SCENE("vm_then_user", fault_scene_then, FAULT_STATUS, FAULT_NUMBER),
    FAULT_OF_SCENE("vm_then_user, NaN in y", fault_scene_set, FAULT_ALL, FAULT_NUMBER),
    FAULT_OF_SCENE("vm_then_all, NaN in y", fault_scene_set_twice, FAULT_ALL, FAULT_NUMBER),
    FAULT_OF_SCENE("scene.output", fault_scene_output, FAULT_STATUS, VM_STOPPED),
};

#endif
