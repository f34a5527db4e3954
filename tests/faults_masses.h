/* faults_masses.h - scenes whose mass laws fail at every call, also at those of events, jumps, budgets and the start;
   and functions of a user in further effects */
#ifndef FAULTS_MASSES_H
#define FAULTS_MASSES_H

#include "faults_flow.h"
#include "faults_scenes.h"

/* The scene of fault_scene_clear with a third body, which is absent, and with a mass law of body 0 as effect 0. The law
   is one of time, if by_law is 1, or else a function of time and motion, which has no status. */
static inline void fault_masses_clear(fault_scene *f, int by_law)
{
    const vm_vec3 zero = {0, 0, 0};
    fault_scene_clear(f);
    f->bodies[2] = vm_scene_body_absent(vm_scene_body_line(1, 0, 0));
    f->scene.n_bodies = 3;
    f->law = vm_law_user(faulty_mass_of_time, NULL);
    if (by_law) fault_first_effect(f, vm_effect_mass_of_time(0, &f->law, zero, 1));
    else fault_first_effect(f, vm_effect_mass_law(0, faulty_mass_law, NULL, zero, 1));
    f->part.mass = R(0.5);
    f->part.v.x = -1;
}

/* ---- Events of a scene with a mass law ---- */

/* The mass law is switched off and on again; then it goes on from the mass that it had. */
static inline void fault_switched(outcome *o, int by_law)
{
    fault_scene f;
    fault_masses_clear(&f, by_law);
    f.events[0] = vm_then_switch(vm_event_at(R(0.5)), 0, 1);
    f.events[1] = vm_then_switch(vm_event_at(1), 0, 0);
    f.events[2] = vm_then_switch(vm_event_position(1, 0, R(2.5), 0), 2, 1);
    f.scene.n_events = 3;
    fault_scene_play(&f, 2, o);
}

/* A part separates from the body with the law, and is attached again. */
static inline void fault_jumps(fault_scene *f, outcome *o)
{
    f->events[0] = vm_then_separate_on_line(vm_event_at(R(0.5)), 0, 2, &f->part, 1);
    f->events[1] = vm_then_attach_on_line(vm_event_at(1), 0, 2);
    f->scene.n_events = 2;
    fault_scene_play(f, 2, o);
}
static inline void fault_jumps_alone(outcome *o, int by_law)
{
    fault_scene f;
    fault_masses_clear(&f, by_law);
    fault_jumps(&f, o);
}
static inline void fault_jumps_with_budget(outcome *o, int by_law)
{
    vm_budget now;
    fault_scene f;
    int status;
    fault_masses_clear(&f, by_law);
    vm_scene_keep_budget(&f.scene, &f.budget);
    fault_jumps(&f, o);
    memset(&now, 0, sizeof now);
    status = vm_scene_budget_at(&f.scene, f.t, f.y, &now);
    o->result += (double)(now.jump_energy + now.energy + now.momentum_defect.x + now.energy_defect);
    if (status) o->again = status;
}

/* A list of actions, of which the second and the third need the masses */
static inline void fault_list(outcome *o, int by_law)
{
    const vm_event any = vm_event_position(1, 0, R(2.25), 0);
    fault_scene f;
    fault_masses_clear(&f, by_law);
    f.actions[0] = vm_then_switch(any, 2, 1);
    f.actions[1] = vm_then_separate_on_line(any, 0, 2, &f.part, 1);
    f.actions[2] = vm_then_switch(any, 0, 1);
    f.events[0] = vm_then_all(any, f.actions, 3);
    f.events[0].most = 1;
    f.scene.n_events = 1;
    fault_scene_play(&f, 2, o);
}

/* An event at a mass of the law, which is only counted, and one that switches a spring off */
static inline void fault_at_mass(outcome *o, int by_law)
{
    fault_scene f;
    fault_masses_clear(&f, by_law);
    f.events[0] = vm_event_mass(0, R(2.03125), 1);
    f.events[1] = vm_then_switch(vm_event_mass(0, R(2.0625), 0), 2, 1);
    f.scene.n_events = 2;
    fault_scene_play(&f, 2, o);
    o->result += (double)f.events[0].time;
}

/* A counter of outputs, at three times or after each step. Each of the three times must come once. */
static inline int count_outputs(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    fault_scene *f = (fault_scene *)ctx;
    (void)t;
    (void)y;
    if (VM_IS_FINITE(scene->bodies[0].load.mass)) f->outputs++;
    return 0;
}
static inline void fault_outputs_of(outcome *o, int by_law)
{
    static const vm_real times[3] = {R(0.5), 1, R(1.5)};
    fault_scene f;
    fault_masses_clear(&f, by_law);
    f.scene.output = count_outputs;
    f.scene.output_ctx = &f;
    f.scene.times = times;
    f.scene.n_times = 3;
    fault_scene_play(&f, 2, o);
}

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
    fault_scene f;
    fault_masses_clear(&f, 0);
    f.scene.effects = f.effects + 1;
    f.scene.n_effects = 2;
    f.scene.output = faulty_each_output;
    fault_scene_play(&f, 2, o);
}

/* ---- Single calls ---- */

/* The budget at one time. An error leaves it as it was. */
static inline void fault_budget_of(fault_scene *f, outcome *o)
{
    const struct fault_now before = fault_hold();
    vm_budget now;
    vm_scene_keep_budget(&f->scene, &f->budget);
    vm_scene_start(&f->scene, 0, f->y, NULL);
    memset(&now, 0, sizeof now);
    now.energy = FAULT_UNTOUCHED;
    fault = before;
    o->status = o->again = vm_scene_budget_at(&f->scene, 0, f->y, &now);
    if (o->status < 0) {
        o->sound = now.energy == FAULT_UNTOUCHED;
        o->again = vm_scene_budget_at(&f->scene, 0, f->y, &now);
    }
    o->result = (double)(now.energy + now.energy_defect + now.momentum.x);
}
static inline void fault_budget(outcome *o, int by_law)
{
    fault_scene f;
    fault_masses_clear(&f, by_law);
    fault_budget_of(&f, o);
}

/* The right-hand side of a scene. Where the scene has the status of the fault, all derivatives are NaN; a NaN in a load
   may also make only some of them NaN, without a status. The next evaluation takes the status and the NaN away. */
static inline void fault_rhs_of(fault_scene *f, outcome *o)
{
    const struct fault_now before = fault_hold();
    vm_real dydt[FAULT_SCENE_STATES];
    int i, n;
    vm_scene_start(&f->scene, 0, f->y, NULL);
    n = vm_scene_size(&f->scene);
    fault = before;
    o->sound = vm_scene_rhs(0, f->y, dydt, &f->scene) == 0;
    o->status = f->scene.status;
    for (i = 0; i < n; i++)
        if (o->status && dydt[i] == dydt[i]) o->sound = 0;
    if (!vmi_all_finite(n, dydt)) vm_scene_rhs(0, f->y, dydt, &f->scene);
    o->again = f->scene.status;
    o->result = (double)fault_sum(n, dydt);
}
static inline void fault_scene_rhs(outcome *o, int by_law)
{
    fault_scene f;
    fault_masses_clear(&f, by_law);
    f.scene.n_bodies = 2;
    fault_rhs_of(&f, o);
}

/* A scene with all further effects that call a function of a user: a force on body 0, a force between the first two
   bodies, a custom effect, a stream that varies, and a link to a point that moves */
static inline void fault_all_effects(fault_scene *f)
{
    fault_scene_clear(f);
    f->bodies[1] = vm_scene_body_plane(1, 1, vmi_vec3(2, 0, 0), 0, vmi_vec3(1, 0, 0), R(0.5));
    f->bodies[1] = vm_scene_body_growing_plane(f->bodies[1]);
    f->bodies[2] = vm_scene_body_point(1, vmi_vec3(R(0.125), -2, 0), vmi_vec3(0, 0, 0));
    f->scene.n_bodies = 3;
    f->effects[0] = vm_effect_force(0, 0, faulty_scene_force, NULL);
    f->effects[1] = vm_effect_force_between(1, 0, 0, 0, faulty_scene_force, NULL);
    f->effects[2] = vm_effect_custom(0, VM_GROUND, faulty_custom, NULL);
    f->effects[3] = vm_effect_varying(vm_effect_stream_mass(1, &f->stream), faulty_vary, NULL);
    f->effects[4] = vm_effect_link(2, VM_GROUND, faulty_support, NULL, 2, 0, 10);
    f->scene.n_effects = 5;
}

/* None of these effects changes a mass, so that the budget has the right numbers even where they give NaN. */
static inline void fault_budget_of_effects(outcome *o)
{
    fault_scene f;
    fault_all_effects(&f);
    fault_budget_of(&f, o);
}
static inline void fault_rhs_of_effects(outcome *o)
{
    fault_scene f;
    fault_all_effects(&f);
    fault_rhs_of(&f, o);
}

/* A custom effect that sets the status of the scene */
static inline void fault_rhs_of_status(outcome *o)
{
    fault_scene f;
    fault_all_effects(&f);
    f.effects[0] = vm_effect_custom(0, VM_GROUND, faulty_custom_status, NULL);
    f.scene.n_effects = 1;
    fault_rhs_of(&f, o);
}

/* ---- Further effects ---- */

/* A ball whose mass is a law falls on the ground and lands there. */
static inline void fault_land(outcome *o, int by_law)
{
    static vm_contact ground;
    fault_scene f;
    fault_masses_clear(&f, by_law);
    memset(&ground, 0, sizeof ground);
    ground.stiffness = 100;
    ground.damping = 5;
    ground.normal = vmi_vec3(1, 0, 0);
    f.effects[1] = vm_effect_gravity(0, 0, R(-9.81));
    f.effects[2] = vm_effect_contact(0, &ground);
    f.events[0] = vm_then_land(vm_event_contact(0, &ground));
    f.scene.n_events = 1;
    fault_scene_play(&f, 2, o);
}

/* A force of a user on one body, without a reaction */
static inline void fault_single_force(outcome *o)
{
    fault_scene f;
    fault_masses_clear(&f, 0);
    f.effects[0] = vm_effect_force(1, 0, faulty_scene_force, NULL);
    fault_scene_play(&f, 2, o);
}

/* A list of two actions of a user, and a third action of its own. Each error must be seen. */
static inline void fault_user_list(outcome *o)
{
    const long at = fault.at;
    const vm_event any = vm_event_position(1, 0, R(2.25), 0);
    fault_scene f;
    fault_masses_clear(&f, 0);
    f.scene.effects = f.effects + 1;
    f.scene.n_effects = 2;
    f.actions[0] = vm_then_user(any, faulty_then, NULL);
    f.actions[1] = vm_then_user(any, faulty_then, NULL);
    f.events[0] = vm_then_all(any, f.actions, 2);
    f.events[1] = vm_then_user(any, faulty_then, NULL);
    f.scene.n_events = 2;
    fault_scene_play(&f, 2, o);
    if (at >= 0 && o->status == 0) o->sound = 0;
}

/* A growing body in space with all effects of one stream that varies */
static inline void fault_growing(outcome *o)
{
    vm_body body = a_body(5);
    vm_stream stream;
    fault_scene f;
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
    fault_scene_play(&f, 2, o);
}

/* A body in the plane that a pin holds at the ground, with a force of a user and a budget */
static inline void fault_pinned(outcome *o)
{
    const vm_vec3 zero = {0, 0, 0}, arm = {-1, 0, 0};
    vm_joint pin = vm_joint_pin(0, arm, VM_GROUND, zero);
    vm_real room[VM_JOINTS_WORK(1)];
    vm_joints joints;
    fault_scene f;
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
    fault_scene_play(&f, 2, o);
}

/* A cord to a point whose motion is a function of a user */
static inline void fault_cord(outcome *o)
{
    fault_scene f;
    fault_masses_clear(&f, 0);
    f.bodies[0] = vm_scene_body_point(1, vmi_vec3(R(0.125), -2, 0), vmi_vec3(0, 0, 0));
    f.scene.n_bodies = 1;
    f.effects[0] = vm_effect_gravity(0, 1, R(-9.81));
    f.effects[1] = vm_effect_link(0, VM_GROUND, faulty_support, NULL, 2, 1, 10);
    f.scene.n_effects = 2;
    fault_scene_play(&f, 2, o);
}

/* ---- The tables ---- */

/* What is tried with both kinds of mass laws */
typedef struct fault_mass_row {
    const char *name;
    void (*run)(outcome *o, int by_law);
} fault_mass_row;

static const fault_mass_row fault_mass_laws[] = {
    {"vm_then_switch", fault_switched},
    {"jumps", fault_jumps_alone},
    {"jumps, budget", fault_jumps_with_budget},
    {"vm_then_all", fault_list},
    {"vm_event_mass", fault_at_mass},
    {"scene.output", fault_outputs_of},
    {"vm_then_land", fault_land},
    {"vm_scene_budget_at", fault_budget},
    {"vm_scene_rhs", fault_scene_rhs},
};

static inline void fault_mass_law(outcome *o, const void *row) { ((const fault_mass_row *)row)->run(o, 0); }
static inline void fault_mass_of_time(outcome *o, const void *row) { ((const fault_mass_row *)row)->run(o, 1); }

/* Where a shorter step may step over a NaN, the results differ within the tolerance. */
static inline void check_mass_law(const fault_mass_row *row)
{
    static const fault_promise of_law = {FAULT_NAN, 0, VM_NOT_FINITE, FAULT_SCENE, 0, 0};
    static const fault_promise of_time = {FAULT_ALL, VM_DOMAIN, VM_NOT_FINITE, FAULT_SCENE, 0, 0};
    char name[60];
    sprintf(name, "mass_law, %s", row->name);
    check_faults_of_row(name, &of_law, fault_mass_law, row);
    sprintf(name, "mass_of_time, %s", row->name);
    check_faults_of_row(name, &of_time, fault_mass_of_time, row);
}

static const scenario fault_effects[] = {
    FAULT_OF_SCENE("scene.output, each step", fault_each_output, FAULT_STATUS, VM_STOPPED),
    FAULT_OF_SCENE("vm_then_all, users", fault_user_list, FAULT_STATUS, FAULT_NUMBER),
    FAULT_OF_SCENE("vm_effect_force", fault_single_force, FAULT_NAN, 0),
    FAULT_OF_SCENE("four varying effects", fault_growing, FAULT_NAN, 0),
    FAULT_OF_SCENE("force, vm_effect_joints", fault_pinned, FAULT_NAN, 0),
    FAULT_OF_SCENE("vm_effect_link, cord", fault_cord, FAULT_NAN, 0),
    {"vm_scene_rhs, all effects", fault_rhs_of_effects, {FAULT_NAN, 0, VM_NOT_FINITE, 0, 0, 0}, NULL, NULL},
    {"vm_scene_rhs, scene.status", fault_rhs_of_status, {FAULT_ALL, VM_SINGULAR, VM_NOT_FINITE, 0, 0, 0}, NULL, NULL},
    {"vm_scene_budget_at, all effects", fault_budget_of_effects, {FAULT_NAN, 0, 0, 0, 0, 0}, NULL, NULL},
};

#endif
