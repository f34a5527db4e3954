/* faults_masses.h - scenes whose mass laws fail at every call, also at those of events, jumps, budgets and the start;
   and functions of a user in further effects */
#ifndef FAULTS_MASSES_H
#define FAULTS_MASSES_H

#include "faults_laws.h"
#include "faults_scenes.h"

enum { FAULT_MASS_STATES = 48, FAULT_MASS_EVENTS = 4 };

/* Three bodies on a line, of which the third is absent, with all that the scene needs. Effect 0 is the mass law of
   body 0. */
typedef struct fault_masses {
    vm_scene scene;
    vm_scene_body bodies[3];
    vm_effect effects[6];
    vm_event events[FAULT_MASS_EVENTS], actions[3];
    ode_event located[FAULT_MASS_EVENTS];
    vm_real y[FAULT_MASS_STATES], work[VM_SCENE_WORK(FAULT_MASS_STATES)];
    vm_real t;
    vm_law law;
    vm_budget budget;
    vm_body part;
    long outputs;
} fault_masses;

static inline void fault_masses_clear(fault_masses *f, int by_law)
{
    const vm_vec3 zero = {0, 0, 0};
    memset(f, 0, sizeof *f);
    f->scene.bodies = f->bodies;
    f->scene.effects = f->effects;
    f->scene.events = f->events;
    f->scene.located = f->located;
    f->bodies[0] = vm_scene_body_line(2, 1, 0);
    f->bodies[1] = vm_scene_body_line(1, 2, 1);
    f->bodies[2] = vm_scene_body_absent(vm_scene_body_line(1, 0, 0));
    f->scene.n_bodies = 3;
    f->law = vm_law_user(faulty_mass_of_time, NULL);
    if (by_law) f->effects[0] = vm_effect_mass_of_time(0, &f->law, zero, 1);
    else f->effects[0] = vm_effect_mass_law(0, faulty_mass_law, NULL, zero, 1);
    f->effects[1] = vm_effect_linear_spring(0, 0, VM_GROUND, 0, 3, 0);
    f->effects[2] = vm_effect_linear_spring(1, 0, 0, 0, 2, 1);
    f->scene.n_effects = 3;
    f->part.mass = R(0.5);
    f->part.v.x = -1;
}

/* A number that depends on the motion, on the masses and on the events of a scene */
static inline double fault_masses_sum(const fault_masses *f)
{
    double sum = (double)fault_sum(6, f->y) + (double)f->outputs;
    int i;
    for (i = 0; i < 3; i++)
        if (!f->bodies[i].away) sum += (i + 1) * (double)f->bodies[i].load.mass;
    for (i = 0; i < f->scene.n_events; i++) sum += (i + 1) * (double)f->events[i].count;
    return sum;
}

/* Starts the scene and runs it to t = 2. After an error the run goes on with another call. A last call without faults
   evaluates the masses at t = 2 that the result needs. */
static inline void fault_masses_play(fault_masses *f, outcome *o)
{
    const vm_real t_end = 2;
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
    o->result = fault_masses_sum(f);
}

/* ---- Events of a scene with a mass law ---- */

/* The mass law is switched off and on again; then it goes on from the mass that it had. */
static inline void fault_switched(outcome *o, int by_law)
{
    fault_masses f;
    fault_masses_clear(&f, by_law);
    f.events[0] = vm_then_switch(vm_event_at(R(0.5)), 0, 1);
    f.events[1] = vm_then_switch(vm_event_at(1), 0, 0);
    f.events[2] = vm_then_switch(vm_event_position(1, 0, R(2.5), 0), 2, 1);
    f.scene.n_events = 3;
    fault_masses_play(&f, o);
}
static inline void fault_switched_law(outcome *o) { fault_switched(o, 0); }
static inline void fault_switched_of_time(outcome *o) { fault_switched(o, 1); }

/* A part separates from the body with the law, and is attached again. */
static inline void fault_jumps(outcome *o, int by_law, int with_budget)
{
    vm_budget now;
    fault_masses f;
    int status = VM_OK;
    fault_masses_clear(&f, by_law);
    f.events[0] = vm_then_separate_on_line(vm_event_at(R(0.5)), 0, 2, &f.part, 1);
    f.events[1] = vm_then_attach_on_line(vm_event_at(1), 0, 2);
    f.scene.n_events = 2;
    if (with_budget) vm_scene_keep_budget(&f.scene, &f.budget);
    fault_masses_play(&f, o);
    if (!with_budget) return;
    memset(&now, 0, sizeof now);
    status = vm_scene_budget_at(&f.scene, f.t, f.y, &now);
    o->result += (double)(now.jump_energy + now.energy + now.momentum_defect.x + now.energy_defect);
    if (status) o->again = status;
}
static inline void fault_jumps_law(outcome *o) { fault_jumps(o, 0, 0); }
static inline void fault_jumps_of_time(outcome *o) { fault_jumps(o, 1, 0); }
static inline void fault_jumps_law_budget(outcome *o) { fault_jumps(o, 0, 1); }
static inline void fault_jumps_of_time_budget(outcome *o) { fault_jumps(o, 1, 1); }

/* A list of actions, of which the second and the third need the masses */
static inline void fault_list(outcome *o, int by_law)
{
    const vm_event any = vm_event_position(1, 0, R(2.25), 0);
    fault_masses f;
    fault_masses_clear(&f, by_law);
    f.actions[0] = vm_then_switch(any, 2, 1);
    f.actions[1] = vm_then_separate_on_line(any, 0, 2, &f.part, 1);
    f.actions[2] = vm_then_switch(any, 0, 1);
    f.events[0] = vm_then_all(any, f.actions, 3);
    f.events[0].most = 1;
    f.scene.n_events = 1;
    fault_masses_play(&f, o);
}
static inline void fault_list_law(outcome *o) { fault_list(o, 0); }
static inline void fault_list_of_time(outcome *o) { fault_list(o, 1); }

/* An event at a mass of the law, which is only counted, and one that switches a spring off */
static inline void fault_at_mass(outcome *o, int by_law)
{
    fault_masses f;
    fault_masses_clear(&f, by_law);
    f.events[0] = vm_event_mass(0, R(2.03125), 1);
    f.events[1] = vm_then_switch(vm_event_mass(0, R(2.0625), 0), 2, 1);
    f.scene.n_events = 2;
    fault_masses_play(&f, o);
    o->result += (double)f.events[0].time;
}
static inline void fault_at_mass_law(outcome *o) { fault_at_mass(o, 0); }
static inline void fault_at_mass_of_time(outcome *o) { fault_at_mass(o, 1); }

/* A counter of outputs, at three times or after each step. Each of the three times must come once. */
static inline int count_outputs(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    fault_masses *f = (fault_masses *)ctx;
    (void)t;
    (void)y;
    if (VM_IS_FINITE(scene->bodies[0].load.mass)) f->outputs++;
    return 0;
}
static inline void fault_outputs_of(outcome *o, int by_law)
{
    static const vm_real times[3] = {R(0.5), 1, R(1.5)};
    fault_masses f;
    fault_masses_clear(&f, by_law);
    f.scene.output = count_outputs;
    f.scene.output_ctx = &f;
    f.scene.times = times;
    f.scene.n_times = 3;
    fault_masses_play(&f, o);
}
static inline void fault_outputs_law(outcome *o) { fault_outputs_of(o, 0); }
static inline void fault_outputs_of_time(outcome *o) { fault_outputs_of(o, 1); }

/* An output after each step that fails. The scene has no faulty mass law. */
static inline int faulty_each_output(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    const int strikes = fault_strikes();
    (void)t;
    (void)y;
    (void)scene;
    (void)ctx;
    return fault_status(strikes);
}
static inline void fault_each_output(outcome *o)
{
    fault_masses f;
    fault_masses_clear(&f, 0);
    f.scene.effects = f.effects + 1;
    f.scene.n_effects = 2;
    f.scene.output = faulty_each_output;
    fault_masses_play(&f, o);
}

/* ---- Single calls ---- */

/* The budget at one time. An error leaves it as it was. */
static inline void fault_budget(outcome *o, int by_law)
{
    const long at = fault.at;
    vm_budget now;
    fault_masses f;
    fault.at = -1;
    fault_masses_clear(&f, by_law);
    vm_scene_keep_budget(&f.scene, &f.budget);
    vm_scene_start(&f.scene, 0, f.y, NULL);
    memset(&now, 0, sizeof now);
    now.energy = FAULT_UNTOUCHED;
    fault.at = at;
    fault.calls = 0;
    o->status = o->again = vm_scene_budget_at(&f.scene, 0, f.y, &now);
    if (o->status < 0) {
        o->sound = now.energy == FAULT_UNTOUCHED;
        o->again = vm_scene_budget_at(&f.scene, 0, f.y, &now);
    }
    o->result = (double)(now.energy + now.energy_defect + now.momentum.x);
}
static inline void fault_budget_law(outcome *o) { fault_budget(o, 0); }
static inline void fault_budget_of_time(outcome *o) { fault_budget(o, 1); }

/* The right-hand side of a scene: all derivatives are NaN and the scene has the status of the fault, which the next
   evaluation takes away. */
static inline void fault_scene_rhs(outcome *o, int by_law)
{
    const long at = fault.at;
    vm_real dydt[4];
    fault_masses f;
    int i;
    fault.at = -1;
    fault_masses_clear(&f, by_law);
    f.scene.n_bodies = 2;
    vm_scene_start(&f.scene, 0, f.y, NULL);
    fault.at = at;
    fault.calls = 0;
    o->sound = vm_scene_rhs(0, f.y, dydt, &f.scene) == 0;
    o->status = f.scene.status;
    if (o->status) {
        for (i = 0; i < 4; i++) o->sound = o->sound && dydt[i] != dydt[i];
        vm_scene_rhs(0, f.y, dydt, &f.scene);
    }
    o->again = f.scene.status;
    o->result = (double)fault_sum(4, dydt);
}
static inline void fault_scene_rhs_law(outcome *o) { fault_scene_rhs(o, 0); }
static inline void fault_scene_rhs_of_time(outcome *o) { fault_scene_rhs(o, 1); }

/* ---- Further effects ---- */

/* A ball whose mass is a law falls on the ground and lands there. */
static inline void fault_land(outcome *o, int by_law)
{
    static vm_contact ground;
    fault_masses f;
    fault_masses_clear(&f, by_law);
    memset(&ground, 0, sizeof ground);
    ground.stiffness = 100;
    ground.damping = 5;
    ground.normal = vmi_vec3(1, 0, 0);
    f.effects[1] = vm_effect_gravity(0, 0, R(-9.81));
    f.effects[2] = vm_effect_contact(0, &ground);
    f.events[0] = vm_then_land(vm_event_contact(0, &ground));
    f.scene.n_events = 1;
    fault_masses_play(&f, o);
}
static inline void fault_land_law(outcome *o) { fault_land(o, 0); }
static inline void fault_land_of_time(outcome *o) { fault_land(o, 1); }

/* A force of a user on one body, without a reaction */
static inline void fault_single_force(outcome *o)
{
    fault_masses f;
    fault_masses_clear(&f, 0);
    f.effects[0] = vm_effect_force(1, 0, faulty_scene_force, NULL);
    fault_masses_play(&f, o);
}

/* A list of two actions of a user, and a third action of its own. Each error must be seen. */
static inline void fault_user_list(outcome *o)
{
    const long at = fault.at;
    const vm_event any = vm_event_position(1, 0, R(2.25), 0);
    fault_masses f;
    fault_masses_clear(&f, 0);
    f.scene.effects = f.effects + 1;
    f.scene.n_effects = 2;
    f.actions[0] = vm_then_user(any, faulty_then, NULL);
    f.actions[1] = vm_then_user(any, faulty_then, NULL);
    f.events[0] = vm_then_all(any, f.actions, 2);
    f.events[1] = vm_then_user(any, faulty_then, NULL);
    f.scene.n_events = 2;
    fault_masses_play(&f, o);
    if (at >= 0 && o->status == 0) o->sound = 0;
}

/* A growing body in space with all effects of one stream that varies */
static inline void fault_growing(outcome *o)
{
    vm_body body = a_body(5);
    vm_stream stream;
    fault_masses f;
    fault_masses_clear(&f, 0);
    memset(&stream, 0, sizeof stream);
    stream.at = vmi_vec3(R(0.25), 0, R(0.5));
    stream.velocity = vmi_vec3(0, 1, 2);
    body.inertia = fault_sizes;
    f.bodies[0] = vm_scene_body_growing_free(vm_scene_body_free(&body));
    f.scene.n_bodies = 1;
    f.effects[0] = vm_effect_varying(vm_effect_stream_mass(0, &stream), faulty_vary, NULL);
    f.effects[1] = vm_effect_varying(vm_effect_stream_force(0, &stream), faulty_vary, NULL);
    f.effects[2] = vm_effect_varying(vm_effect_stream_moment(0, &stream), faulty_vary, NULL);
    f.effects[3] = vm_effect_varying(vm_effect_stream_torque(0, &stream), faulty_vary, NULL);
    f.scene.n_effects = 4;
    fault_masses_play(&f, o);
}

/* A body in the plane that a pin holds at the ground, with a force of a user and a budget */
static inline void fault_pinned(outcome *o)
{
    const vm_vec3 zero = {0, 0, 0}, arm = {-1, 0, 0};
    vm_joint pin = vm_joint_pin(0, arm, VM_GROUND, zero);
    vm_real room[VM_JOINTS_WORK(1)];
    vm_joints joints;
    fault_masses f;
    fault_masses_clear(&f, 0);
    memset(&joints, 0, sizeof joints);
    joints.joints = &pin;
    joints.n_joints = 1;
    joints.work = room;
    joints.rate = 10;
    f.bodies[0] = vm_scene_body_plane(2, 1, vmi_vec3(1, 0, 0), 0, zero, 0);
    f.scene.n_bodies = 1;
    f.effects[0] = vm_effect_force(0, 1, faulty_scene_force, NULL);
    f.effects[1] = vm_effect_joints(&joints);
    f.scene.n_effects = 2;
    vm_scene_keep_budget(&f.scene, &f.budget);
    fault_masses_play(&f, o);
}

/* A cord to a point whose motion is a function of a user */
static inline void fault_cord(outcome *o)
{
    fault_masses f;
    fault_masses_clear(&f, 0);
    f.bodies[0] = vm_scene_body_point(1, vmi_vec3(R(0.125), -2, 0), vmi_vec3(0, 0, 0));
    f.scene.n_bodies = 1;
    f.effects[0] = vm_effect_gravity(0, 1, R(-9.81));
    f.effects[1] = vm_effect_link(0, VM_GROUND, faulty_support, NULL, 2, 1, 10);
    f.scene.n_effects = 2;
    fault_masses_play(&f, o);
}

/* Where a shorter step may step over a NaN, the results differ within the tolerance. */
#define FAULT_NAN_ROW(name, run) {name, run, {FAULT_NAN, 0, VM_NOT_FINITE, FAULT_SCENE, 0, 0}, NULL, NULL}
#define FAULT_LAW_ROW(name, run) {name, run, {FAULT_ALL, VM_DOMAIN, VM_NOT_FINITE, FAULT_SCENE, 0, 0}, NULL, NULL}

static const scenario fault_mass_laws[] = {
    FAULT_NAN_ROW("mass_law, vm_then_switch", fault_switched_law),
    FAULT_LAW_ROW("mass_of_time, then_switch", fault_switched_of_time),
    FAULT_NAN_ROW("mass_law, jumps", fault_jumps_law),
    FAULT_LAW_ROW("mass_of_time, jumps", fault_jumps_of_time),
    FAULT_NAN_ROW("mass_law, jumps, budget", fault_jumps_law_budget),
    FAULT_LAW_ROW("mass_of_time, with budget", fault_jumps_of_time_budget),
    FAULT_NAN_ROW("mass_law, vm_then_all", fault_list_law),
    FAULT_LAW_ROW("mass_of_time, vm_then_all", fault_list_of_time),
    FAULT_NAN_ROW("mass_law, vm_event_mass", fault_at_mass_law),
    FAULT_LAW_ROW("mass_of_time, event_mass", fault_at_mass_of_time),
    FAULT_NAN_ROW("mass_law, scene.output", fault_outputs_law),
    FAULT_LAW_ROW("mass_of_time, output", fault_outputs_of_time),
    FAULT_NAN_ROW("mass_law, vm_then_land", fault_land_law),
    FAULT_LAW_ROW("mass_of_time, then_land", fault_land_of_time),
    FAULT_NAN_ROW("mass_law, budget_at", fault_budget_law),
    FAULT_LAW_ROW("mass_of_time, budget_at", fault_budget_of_time),
    FAULT_NAN_ROW("mass_law, vm_scene_rhs", fault_scene_rhs_law),
    FAULT_LAW_ROW("mass_of_time, scene_rhs", fault_scene_rhs_of_time),
    {"scene.output, each step", fault_each_output, {FAULT_STATUS, VM_STOPPED, 0, FAULT_SCENE, 0, 0}, NULL, NULL},
    {"vm_then_all, users", fault_user_list, {FAULT_STATUS, FAULT_NUMBER, 0, FAULT_SCENE, 0, 0}, NULL, NULL},
    FAULT_NAN_ROW("vm_effect_force", fault_single_force),
    FAULT_NAN_ROW("four varying effects", fault_growing),
    FAULT_NAN_ROW("force, vm_effect_joints", fault_pinned),
    FAULT_NAN_ROW("vm_effect_link, cord", fault_cord),
};

#endif
