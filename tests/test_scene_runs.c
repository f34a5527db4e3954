/* varmass.h, scenes: what is checked before a run, and how runs end. A scene that cannot run is refused with a
   status, the kind of the culprit and its index. A run with bad arguments is refused; it ends early where its steps
   are used up. */
#include <limits.h>
#include "stage_check.h"

static const vm_vec3 zero = {0, 0, 0};

static vm_real any_time(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t + 1;
}

/* ---- The order of effects ---- */

static void two_effects(stage *s, vm_effect first, vm_effect second)
{
    s->scene.n_effects = 2;
    s->effects[0] = first;
    s->effects[1] = second;
}

static void accepted_order(stage *s, vm_effect first, vm_effect second)
{
    two_effects(s, first, second);
    begin(s);
}

static void refused_order(stage *s, vm_effect first, vm_effect second, int status)
{
    two_effects(s, first, second);
    refused(s, status, "effect", 1);
}

/* Of the effects on a body, a mass law comes first and a link last; a body has at most one of each, whichever end of
   the link it is. */
static void check_orders(void)
{
    vm_effect law[3], link[3], spring[3]; /* of body i; the link and the spring are to body 2, those of 2 to body 0 */
    stage s;
    int i;
    stage_clear(&s, 1);
    for (i = 0; i < 3; i++) {
        const int other = i < 2 ? 2 : 0;
        stage_body(&s, vm_scene_body_point(1, stage_vec(i, 0, 0), zero));
        law[i] = vm_effect_mass(i, VM_MASS_OF_T, 1, 0, 1);
        spring[i] = vm_effect_linear_spring(i, 0, other, 0, 1, 0);
        link[i] = vm_effect_link(i, other, NULL, NULL, 1, 0, 1);
    }
    accepted_order(&s, law[0], spring[0]);
    accepted_order(&s, law[0], law[1]);
    accepted_order(&s, spring[0], link[0]);
    accepted_order(&s, law[0], link[0]);
    accepted_order(&s, spring[0], spring[0]);
    accepted_order(&s, spring[0], law[1]);
    refused_order(&s, law[0], law[0], VM_TWO_MASS_LAWS);
    refused_order(&s, link[0], link[0], VM_TWO_LINKS);
    refused_order(&s, link[0], link[1], VM_TWO_LINKS); /* both pull at body 2 */
    refused_order(&s, link[0], link[2], VM_TWO_LINKS);
    refused_order(&s, link[0], spring[0], VM_LINK_NOT_LAST);
    refused_order(&s, link[0], spring[1], VM_LINK_NOT_LAST); /* the spring loads body 2 */
    refused_order(&s, spring[0], law[0], VM_BAD_ORDER);
    refused_order(&s, spring[0], law[2], VM_BAD_ORDER);
    refused_order(&s, link[1], law[2], VM_BAD_ORDER);
}

/* ---- A scene of a line and an axle, with one thing wrong in it ---- */

/* A line with a mass law, an axle with a drive, and an event that stops the run: a scene that is accepted */
static void good_scene(stage *s)
{
    stage_clear(s, 1);
    stage_body(s, vm_scene_body_line(1, 0, 0));
    stage_body(s, vm_scene_body_axle(1, 0, 0));
    stage_effect(s, vm_effect_mass(0, VM_MASS_OF_T, 1, 0, 1));
    stage_effect(s, vm_effect_motor(1, 0, 1, 0));
    stage_event(s, vm_then_stop(vm_event_position(0, 0, 1, 1)));
}

static void check_missing_arrays(void)
{
    stage s;
    CHECK(vm_scene_check(NULL, NULL) == VM_BAD_ARGUMENT);
    good_scene(&s);
    CHECK(vm_scene_check(&s.scene, NULL) == VM_OK);
    s.scene.bodies = NULL;
    refused(&s, VM_BAD_ARGUMENT, "scene", -1);
    good_scene(&s);
    s.scene.located = NULL;
    refused(&s, VM_BAD_ARGUMENT, "scene", -1);
}

static void check_refused_bodies(void)
{
    stage s;
    good_scene(&s);
    s.bodies[1].motion = 9;
    refused(&s, VM_BAD_MOTION, "body", 1);
    good_scene(&s);
    s.bodies[0].start.mass = 0;
    refused(&s, VM_BAD_MASS, "body", 0);
    good_scene(&s);
    s.bodies[0].start.v.x = VM_INFINITY;
    refused(&s, VM_NOT_FINITE, "body", 0);
    good_scene(&s);
    s.bodies[1].angle = VM_NAN;
    refused(&s, VM_NOT_FINITE, "body", 1);
    good_scene(&s);
    s.bodies[1] = vm_scene_body_plane(1, 0, zero, 0, zero, 0);
    refused(&s, VM_BAD_INERTIA, "body", 1);
    good_scene(&s);
    s.bodies[0].mass_is_state = 1;
    refused(&s, VM_TWO_MASS_LAWS, "effect", 0);
    good_scene(&s);
    s.bodies[1] = vm_scene_body_free(NULL);
    refused(&s, VM_BAD_ARGUMENT, "body", 1);
}

static void check_refused_effects(void)
{
    stage s;
    good_scene(&s);
    s.effects[1].body = 2;
    refused(&s, VM_NO_SUCH_BODY, "effect", 1);
    good_scene(&s);
    s.effects[1].body = -1;
    refused(&s, VM_NO_SUCH_BODY, "effect", 1);
    good_scene(&s);
    s.effects[1].other = 7;
    refused(&s, VM_NO_SUCH_BODY, "effect", 1);
    good_scene(&s);
    s.effects[1].coordinate = 1;
    refused(&s, VM_NO_SUCH_COORDINATE, "effect", 1);
    good_scene(&s);
    s.effects[1] = vm_effect_gravity(1, 0, 1); /* has no torque about an axle */
    refused(&s, VM_BAD_MOTION, "effect", 1);
    good_scene(&s);
    s.effects[1] = vm_effect_shaft(0, 1, 1);
    refused(&s, VM_BAD_MOTION, "effect", 1);
    good_scene(&s);
    s.effects[1].p[0] = VM_NAN;
    refused(&s, VM_NOT_FINITE, "effect", 1);
    good_scene(&s);
    s.effects[1] = s.effects[0];
    refused(&s, VM_TWO_MASS_LAWS, "effect", 1);
    good_scene(&s);
    s.effects[1] = s.effects[0];
    s.effects[0] = vm_effect_motor(0, 0, 1, 0);
    refused(&s, VM_BAD_ORDER, "effect", 1);
    good_scene(&s);
    s.effects[1] = vm_effect_stream(1, 1, zero, 1);
    refused(&s, VM_MASS_IS_NO_STATE, "effect", 1);
    good_scene(&s);
    s.effects[1] = vm_effect_force(1, 0, NULL, NULL);
    refused(&s, VM_BAD_ARGUMENT, "effect", 1);
}

static void check_refused_events(void)
{
    stage s;
    good_scene(&s);
    s.events[0].body = 5;
    refused(&s, VM_NO_SUCH_BODY, "event", 0);
    good_scene(&s);
    s.events[0].value = VM_NAN;
    refused(&s, VM_NOT_FINITE, "event", 0);
    good_scene(&s);
    s.events[0].then = NULL; /* an event without an action is accepted: it counts */
    CHECK(vm_scene_check(&s.scene, NULL) == VM_OK);
    good_scene(&s);
    s.events[0] = vm_then_user(s.events[0], NULL, NULL);
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    good_scene(&s);
    s.events[0] = vm_then_switch(vm_event_at(1), 4, 1);
    refused(&s, VM_NO_SUCH_EFFECT, "event", 0);
    good_scene(&s);
    s.events[0] = vm_then_attach(vm_event_at(1), 0, 1);
    refused(&s, VM_BAD_MOTION, "event", 0);
    good_scene(&s);
    s.events[0] = vm_then_attach(vm_event_at(1), 0, 0);
    refused(&s, VM_SAME_BODY, "event", 0);
    good_scene(&s);
    s.events[0] = vm_then_stop(vm_event_at(VM_NAN));
    refused(&s, VM_NOT_FINITE, "event", 0);
}

/* ---- A body in the plane, an axle and a point that is not there yet ---- */

static void three_bodies(stage *s)
{
    stage_clear(s, 1);
    stage_body(s, vm_scene_body_plane(2, 1, zero, 0, zero, 0));
    stage_body(s, vm_scene_body_axle(1, 0, 0));
    stage_body(s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
}

static void refused_effect(stage *s, vm_effect effect, int status)
{
    s->scene.n_effects = 1;
    s->effects[0] = effect;
    refused(s, status, "effect", 0);
}

static void accepted_effect(stage *s, vm_effect effect)
{
    s->scene.n_effects = 1;
    s->effects[0] = effect;
    begin(s);
}

static void check_links(void)
{
    stage s;
    three_bodies(&s);
    refused_effect(&s, vm_effect_link(0, 1, NULL, NULL, 1, 0, 1), VM_BAD_MOTION);
    refused_effect(&s, vm_effect_link(0, VM_GROUND, NULL, NULL, 1, 0, 1), VM_BAD_ARGUMENT);
    refused_effect(&s, vm_effect_link(0, 2, NULL, NULL, 0, 0, 1), VM_DOMAIN);
    refused_effect(&s, vm_effect_link(0, 2, NULL, NULL, 1, 1, -1), VM_DOMAIN);
    refused_effect(&s, vm_effect_link(0, 0, NULL, NULL, 1, 0, 1), VM_SAME_BODY);
    accepted_effect(&s, vm_effect_link(0, 2, NULL, NULL, 1, 1, 1));
    s.bodies[0] = vm_scene_body_growing_plane(s.bodies[0]);
    refused(&s, VM_BAD_MOTION, "effect", 0);
}

static void check_arguments_of_effects(void)
{
    stage s;
    three_bodies(&s);
    refused_effect(&s, vm_effect_spring(0, 0, VM_GROUND, 0, 1, -1, 0), VM_DOMAIN);
    refused_effect(&s, vm_effect_shaft(0, 1, -1), VM_DOMAIN);
    accepted_effect(&s, vm_effect_shaft(0, 1, 0));
    refused_effect(&s, vm_effect_gravity(0, 2, 1), VM_NOT_ON_ANGLE);
    accepted_effect(&s, vm_effect_gravity(0, 1, 1));
    accepted_effect(&s, vm_effect_gravity(2, 2, 1)); /* coordinate 2 of a point is z */
    refused_effect(&s, vm_effect_mass(1, 7, 1, 0, 1), VM_BAD_ARGUMENT);
    refused_effect(&s, vm_effect_custom(1, VM_GROUND, NULL, NULL), VM_BAD_ARGUMENT);
}

/* INT_MAX and INT_MIN as numbers of bodies and coordinates do not overflow. */
static void check_extreme_indices(void)
{
    stage s;
    three_bodies(&s);
    accepted_effect(&s, vm_effect_damper(0, 0, VM_GROUND, INT_MAX, 1)); /* the ground has no coordinates */
    CHECK(s.effects[0].other_x == s.effects[0].x && s.effects[0].other_v == s.effects[0].v);
    refused_effect(&s, vm_effect_damper(0, 0, 1, INT_MAX, 1), VM_NO_SUCH_COORDINATE);
    refused_effect(&s, vm_effect_damper(0, INT_MAX, 1, 0, 1), VM_NO_SUCH_COORDINATE);
    refused_effect(&s, vm_effect_damper(INT_MAX, 0, 1, 0, 1), VM_NO_SUCH_BODY);
    refused_effect(&s, vm_effect_damper(0, 0, INT_MIN, 0, 1), VM_NO_SUCH_BODY);
}

static void check_parts(void)
{
    const vm_body part = part_of(1, 0);
    const vm_event break_up = vm_then_separate(vm_event_at(1), 0, 2, &part, 1);
    stage s;
    three_bodies(&s);
    stage_effect(&s, vm_effect_motor(0, 2, 1, 0));
    stage_event(&s, break_up);
    begin(&s);
    s.events[0].part.mass = VM_NAN;
    refused(&s, VM_NOT_FINITE, "event", 0);
    s.events[0].part.mass = 0;
    refused(&s, VM_BAD_MASS, "event", 0);
    s.events[0].part = part_of(1, 1); /* a point carries no spin */
    refused(&s, VM_BAD_INERTIA, "event", 0);
    s.events[0] = break_up;
    s.events[0].external.at.y = VM_INFINITY;
    refused(&s, VM_NOT_FINITE, "event", 0);
    s.events[0] = vm_then_separate(vm_event_at(1), 0, 2, NULL, 1);
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
}

/* A jump is made for a line or an axle, for the plane, or for any two motions. */
static void check_motions_of_jumps(void)
{
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_plane(1, 1, zero, 0, zero, 0));
    stage_body(&s, vm_scene_body_absent(s.bodies[0]));
    stage_event(&s, vm_then_attach_on_line(vm_event_at(1), 0, 1));
    refused(&s, VM_BAD_MOTION, "event", 0);
    s.events[0] = vm_then_attach_in_plane(vm_event_at(1), 0, 1);
    begin(&s);
    s.bodies[0] = s.bodies[1] = vm_scene_body_line(1, 0, 0);
    refused(&s, VM_BAD_MOTION, "event", 0);
}

static void check_functions_of_events(void)
{
    stage s;
    three_bodies(&s);
    stage_event(&s, vm_then_stop(vm_event_user(NULL, NULL, 0)));
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_stop(vm_event_at(1));
    s.events[0].most = -1;
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_user(vm_event_at(1), NULL, NULL);
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_stop(vm_event_user(any_time, NULL, 0));
    begin(&s);
    s.bodies[2] = vm_scene_body_free(NULL);
    refused(&s, VM_BAD_ARGUMENT, "body", 2);
}

/* ---- Runs ---- */

/* A body in the plane and an axle, with a drive on the body's angle, and times of output */
static void two_bodies(stage *s)
{
    static const vm_real times[] = {1, 2, 2};
    three_bodies(s);
    s->scene.n_bodies = 2;
    stage_effect(s, vm_effect_motor(0, 2, 1, 0));
    stage_event(s, vm_then_stop(vm_event_user(any_time, NULL, 0)));
    s->scene.times = times;
    s->scene.n_times = 2;
}

static void check_arguments_of_runs(void)
{
    stage s;
    two_bodies(&s);
    s.scene.n_times = 3; /* the last two times are equal */
    refused(&s, VM_BAD_TIMES, "scene", -1);
    s.scene.n_times = 2;
    begin(&s);
    CHECK(vm_scene_start(&s.scene, VM_NAN, s.y, NULL) == VM_NOT_FINITE);
    CHECK(vm_scene_start(&s.scene, 0, NULL, NULL) == VM_BAD_ARGUMENT);
    run(&s, -1, VM_BAD_TIMES);
    run(&s, (double)VM_INFINITY, VM_NOT_FINITE);
    run(&s, (double)VM_NAN, VM_NOT_FINITE);
    CHECK(vm_scene_run(NULL, &s.t, 1, s.y, s.work, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_run(&s.scene, NULL, 1, s.y, s.work, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_run(&s.scene, &s.t, 1, NULL, s.work, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_run(&s.scene, &s.t, 1, s.y, NULL, NULL) == VM_BAD_ARGUMENT);
}

/* A state or a work array that is too short for the scene is refused, where their lengths are given. */
static void check_short_arrays(void)
{
    stage s;
    two_bodies(&s);
    s.scene.y_size = vm_scene_size(&s.scene);
    CHECK(stage_start(&s) == VM_OK);
    s.scene.y_size--;
    CHECK(stage_start(&s) == VM_SHORT_ARRAY);
    s.scene.y_size = 0;
    begin(&s);
    s.scene.work_size = VM_SCENE_WORK(vm_scene_size(&s.scene)) - 1;
    run(&s, 1, VM_SHORT_ARRAY);
    s.scene.work_size++;
    run(&s, 1, VM_OK);
}

/* A work space is refused that has room for the integrator, but not for the scene; nothing is written beyond it. */
static void check_work_size(void)
{
    rk45_options o = stage_options();
    int i;
    for (i = 0; i < 4; i++) {
        int n, k, written = 0;
        stage s;
        two_bodies(&s);
        begin(&s);
        n = vm_scene_size(&s.scene);
        o.work_size = VM_SCENE_WORK(n);
        if (i == 0) o.work_size = 1;
        if (i == 1) o.work_size = RK45_WORK(n);
        if (i == 2) o.work_size--;
        CHECK(vm_scene_run(&s.scene, &s.t, 1, s.y, s.work, &o) == (i < 3 ? VM_BAD_OPTIONS : VM_OK));
        for (k = (int)o.work_size; k < (int)VM_LENGTH(s.work); k++) written += s.work[k] != 0;
        CHECK(written == 0);
    }
}

/* A negative rtol means that there is no relative tolerance: x = sin t keeps the error that atol allows. */
static void check_no_relative_tolerance(void)
{
    rk45_options o = rk45_defaults(NULL);
    stage s;
    stage_clear(&s, 100);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1, 0));
    begin(&s);
    o.rtol = -1;
    o.atol = REAL(is_float ? 1e-6 : 1e-12);
    CHECK(vm_scene_run(&s.scene, &s.t, 100, s.y, s.work, &o) == VM_OK);
    check_error("no rtol", "x", "rel", fabs((double)s.y[0] - sin(100.)), is_float ? 1e-5 : 1e-10, 100, 0);
}

/* A run needs scene.located where the scene has events. */
static void check_lost_located(void)
{
    stage s;
    two_bodies(&s);
    begin(&s);
    s.scene.located = NULL;
    run(&s, 1, VM_BAD_ARGUMENT);
    CHECK(s.t == 0);
    s.scene.located = s.located;
    run(&s, 1, VM_OK);
}

/* The budget of a time is not written to the struct with the values at the start, which later budgets need. */
static void check_kept_budget(void)
{
    stage s;
    two_bodies(&s);
    begin(&s);
    run(&s, 0.5, VM_OK);
    CHECK(vm_scene_budget_at(&s.scene, s.t, s.y, &s.book) == VM_BAD_ARGUMENT);
    balanced(&s, "kept budget", 1, 1);
    run(&s, 1, VM_OK);
    balanced(&s, "kept budget", 1, 1);
}

static void check_ends_of_runs(void)
{
    rk45_options o = stage_options();
    vm_budget b;
    stage s;
    two_bodies(&s);
    begin(&s);
    o.max_steps = 2;
    CHECK(vm_scene_run(&s.scene, &s.t, 1000, s.y, s.work, &o) == VM_MAX_STEPS);
    CHECK(s.scene.ode_status == ODE_MAX_STEPS && s.t > 0 && s.t < 1000);
    vm_scene_keep_budget(&s.scene, NULL);
    CHECK(vm_scene_size(&s.scene) == 8 && vm_scene_budget_at(&s.scene, 0, s.y, &b) == VM_BAD_ARGUMENT);
    stage_clear(&s, 1); /* the acceleration is infinite, and the end is a subnormal number */
    stage_body(&s, vm_scene_body_axle(VM_MIN, 0, -100000));
    stage_effect(&s, vm_effect_motor(0, 0, 2, 10));
    begin(&s);
    CHECK(vm_scene_run(&s.scene, &s.t, VM_MIN / 64, s.y, s.work, NULL) == VM_NOT_FINITE && s.t == 0);
}

int main(void)
{
    check_orders();
    check_missing_arrays();
    check_refused_bodies();
    check_refused_effects();
    check_refused_events();
    check_links();
    check_arguments_of_effects();
    check_extreme_indices();
    check_parts();
    check_motions_of_jumps();
    check_functions_of_events();
    check_arguments_of_runs();
    check_short_arrays();
    check_work_size();
    check_no_relative_tolerance();
    check_lost_located();
    check_kept_budget();
    check_ends_of_runs();
    return check_finish("scene runs");
}
