/* objects.h - valid objects for the program that generate.awk writes, and the judges: functions judge_TYPE give an
   object that a constructor has made the status with which it is refused where it is used */
#ifndef ERRORS_OBJECTS_H
#define ERRORS_OBJECTS_H

#include "../valid_objects.h"

/* ---- Laws ---- */

static vm_real a_time[2] = {0, 1}, a_value[2] = {2, 3};

static inline int law_of_nan(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)t;
    (void)ctx;
    *f = VM_NAN;
    *rate = 0;
    return 0;
}

static inline int law_of_zero(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)t;
    (void)ctx;
    *f = 0;
    *rate = 0;
    return 0;
}

static inline int hardening(vm_real x, vm_real *f, void *ctx)
{
    (void)ctx;
    *f = x + x * x * x;
    return 0;
}

static inline int law_of_two(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)t;
    (void)ctx;
    *f = 2;
    *rate = 0;
    return 0;
}

static inline int judge_vm_law(const vm_law *law)
{
    vm_real f, rate;
    return vm_law_at(law, R(0.5), &f, &rate);
}

/* ---- Prepared objects ---- */

static inline jacobi_plan a_jacobi_plan(void)
{
    jacobi_plan plan;
    memset(&plan, 0, sizeof plan);
    jacobi_plan_init(&plan, R(0.5));
    return plan;
}

static inline ateb_plan an_ateb_plan(void)
{
    ateb_plan plan;
    memset(&plan, 0, sizeof plan);
    ateb_plan_init(&plan, 3);
    return plan;
}

static inline vm_torque_free a_torque_free(void)
{
    const vm_body body = a_body(3);
    vm_torque_free motion;
    memset(&motion, 0, sizeof motion);
    vm_torque_free_init(&motion, &body, 0);
    return motion;
}

static inline vm_drum_shaft a_drum_shaft(void)
{
    const vm_drum_shaft shaft = {1, R(0.1), R(0.1), R(0.1)};
    return shaft;
}

static inline vm_osc_plan a_plan(void)
{
    vm_osc_problem problem;
    vm_osc_plan plan;
    memset(&problem, 0, sizeof problem);
    memset(&plan, 0, sizeof plan);
    problem.alpha = 3;
    problem.mass = vm_law_linear(2, R(0.01));
    problem.stiffness = vm_law_linear(3, R(0.01));
    problem.x = 1;
    vm_osc_plan_init(&plan, &problem);
    return plan;
}

static inline vm_odd_plan an_odd_plan(void)
{
    vm_odd_problem problem;
    vm_odd_plan plan;
    memset(&plan, 0, sizeof plan);
    problem.force = vm_duffing_force(2, 3);
    problem.mass = vm_law_linear(2, R(0.01));
    problem.stiffness = vm_law_linear(1, R(0.01));
    problem.damping = vm_law_linear(R(0.01), 0);
    problem.reactive = 1;
    problem.x = 1;
    problem.v = 0;
    vm_odd_plan_init(&plan, &problem, 1);
    return plan;
}

/* Zeros in place of a law */
static inline vm_law no_law(void)
{
    vm_law law;
    memset(&law, 0, sizeof law);
    return law;
}

static inline vm_vdp_plan a_vdp_plan(void)
{
    const vm_vdp v = a_vdp();
    vm_vdp_plan plan;
    memset(&plan, 0, sizeof plan);
    vm_vdp_plan_init(&plan, &v, 1, 0);
    return plan;
}

static inline vm_osc_closed a_closed_law(void)
{
    vm_osc_problem problem;
    vm_osc_closed law;
    memset(&problem, 0, sizeof problem);
    memset(&law, 0, sizeof law);
    problem.alpha = 3;
    problem.mass = vm_law_linear(2, R(0.01));
    problem.stiffness = vm_law_linear(3, 0);
    problem.x = 1;
    vm_osc_closed_init(&law, &problem, 5, 1);
    return law;
}

static vm_power_force soft_force = {3, 1};

/* ---- Callbacks ---- */

static inline void a_motion(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    (void)ctx;
    *x = t - R(0.5);
    *v = 1;
}

static inline vm_real a_law(vm_real t, void *ctx)
{
    (void)ctx;
    return 1 + t;
}

static inline vm_real a_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return t - x - v;
}

static inline vm_mass_law_values a_mass_now(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_mass_law_values now = {2, 0, 0, 0};
    (void)t;
    (void)x;
    (void)v;
    (void)ctx;
    return now;
}

static inline void an_apply(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)e;
    (void)t;
    (void)y;
    (void)s;
}

static inline void a_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)t;
    (void)ctx;
    r->x = 2;
    v->x = 0;
    a->x = 0;
}

static inline void a_vary(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    stream->rate = 1;
}

static inline vm_real a_when(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t - 1;
}

static inline int a_then(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    return VM_OK;
}

/* ---- Integrators ---- */

/* An integrator that has made a step */
static inline rk45 a_run(void)
{
    static vm_real work[RK45_WORK(2)];
    const vm_real y[2] = {R(-0.1), 1};
    rk45 s;
    memset(&s, 0, sizeof s);
    rk45_init(&s, oscillate, NULL, 2, 0, y, NULL, work);
    rk45_solve(&s, 1);
    return s;
}

/* ---- Scenes ---- */

static vm_budget a_budget;

/* A scene of two bodies on a line, started */
static vm_real scene_y[4 + VM_BUDGET_STATES];
static inline vm_scene a_scene(void)
{
    static vm_scene_body bodies[2];
    vm_scene scene;
    memset(&scene, 0, sizeof scene);
    bodies[0] = vm_scene_body_line(2, 0, 1);
    bodies[1] = vm_scene_body_line(2, 0, 1);
    scene.bodies = bodies;
    scene.n_bodies = 2;
    vm_scene_start(&scene, 0, scene_y, NULL);
    return scene;
}

static inline void start_with_budget(vm_scene *scene)
{
    vm_scene_keep_budget(scene, &a_budget);
    vm_scene_start(scene, 0, scene_y, NULL);
}

static inline vm_scene_body a_scene_body_in_space(void)
{
    const vm_body body = a_body(2);
    return vm_scene_body_free(&body);
}

/* The bodies of the scene below: what they are is their name */
enum {
    LINE,
    LINE_2,
    LINE_WITH_MASS_STATE,
    LINE_ABSENT,
    AXLE,
    PLANE,
    PLANE_2,
    PLANE_ABSENT,
    SPACE,
    SPACE_2,
    SPACE_ABSENT,
    GROWING,
    GIVEN,
    SCENE_BODIES
};

static inline vm_effect a_stream_effect(void)
{
    static vm_stream stream;
    memset(&stream, 0, sizeof stream);
    stream.rate = 1;
    return vm_effect_stream_mass(GROWING, &stream);
}

/* The status with which a scene is refused by vm_scene_check, by vm_scene_start, or in the first evaluation */
static inline int judge_scene(vm_scene *scene)
{
    static vm_real y[512], rates[512];
    int status = vm_scene_check(scene, NULL);
    if (status >= 0) status = vm_scene_start(scene, 0, y, NULL);
    if (status >= 0) status = vm_scene_rhs(0, y, rates, scene);
    if (status >= 0) status = scene->status;
    return status;
}

/* The status of a scene of all kinds of bodies, with a body, an effect or an event that was made */
static inline int judge_in_scene(const vm_scene_body *body, const vm_effect *effect, const vm_event *event)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_body free_body = a_body(2), free_part = a_body(1);
    vm_scene_body bodies[SCENE_BODIES];
    vm_effect effects[1];
    vm_event events[1];
    ode_event located[1];
    vm_scene scene;
    memset(&scene, 0, sizeof scene);
    bodies[LINE] = vm_scene_body_line(2, 0, 1);
    bodies[LINE_2] = vm_scene_body_line(2, 0, 1);
    bodies[LINE_WITH_MASS_STATE] = vm_scene_body_with_mass_state(vm_scene_body_line(2, 0, 1));
    bodies[LINE_ABSENT] = vm_scene_body_absent(vm_scene_body_line(1, 0, 0));
    bodies[AXLE] = vm_scene_body_axle(2, 0, 1);
    bodies[PLANE] = vm_scene_body_plane(2, 1, zero, 0, zero, 0);
    bodies[PLANE_2] = vm_scene_body_plane(2, 1, vmi_vec3(1, 0, 0), 0, zero, 0);
    bodies[PLANE_ABSENT] = vm_scene_body_absent(vm_scene_body_plane(1, 1, zero, 0, zero, 0));
    bodies[SPACE] = vm_scene_body_free(&free_body);
    bodies[SPACE_2] = vm_scene_body_free(&free_body);
    bodies[SPACE_ABSENT] = vm_scene_body_absent(vm_scene_body_free(&free_part));
    bodies[GROWING] = vm_scene_body_growing_free(vm_scene_body_free(&free_body));
    bodies[GIVEN] = body ? *body : bodies[LINE];
    effects[0] = effect ? *effect : vm_effect_gravity(LINE, 0, 1);
    events[0] = event ? *event : vm_then_stop(vm_event_at(1));
    scene.bodies = bodies;
    scene.n_bodies = SCENE_BODIES;
    scene.effects = effects;
    scene.n_effects = 1;
    scene.events = events;
    scene.n_events = 1;
    scene.located = located;
    return judge_scene(&scene);
}


static inline const vm_contact *a_contact(void)
{
    static vm_contact contact;
    memset(&contact, 0, sizeof contact);
    contact.normal.y = 1;
    return &contact;
}

static inline vm_joint *a_joint_list(void)
{
    const vm_vec3 zero = {0, 0, 0};
    static vm_joint list[1];
    list[0] = vm_joint_pin(PLANE, zero, VM_GROUND, zero);
    return list;
}

static inline vm_real *a_joint_room(void)
{
    static vm_real room[VM_JOINTS_WORK(1)];
    return room;
}

/* The status of a scene that has only this joint */
static inline int judge_vm_joint(const vm_joint *joint)
{
    vm_joint list[1];
    vm_joints joints;
    vm_effect effect;
    list[0] = *joint;
    joints.joints = list;
    joints.n_joints = 1;
    joints.rate = 1;
    joints.work = a_joint_room();
    joints.work_size = VM_JOINTS_WORK(1);
    effect = vm_effect_joints(&joints);
    return judge_in_scene(NULL, &effect, NULL);
}

static inline int judge_vm_scene_body(const vm_scene_body *body) { return judge_in_scene(body, NULL, NULL); }
static inline int judge_vm_effect(const vm_effect *effect) { return judge_in_scene(NULL, effect, NULL); }
static inline int judge_vm_event(const vm_event *event) { return judge_in_scene(NULL, NULL, event); }

#endif
