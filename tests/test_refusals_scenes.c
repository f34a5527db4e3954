/* What scenes refuse: bodies, effects and events that cannot be, arrays that are missing or too short, scenes that
   were not started, runs that cannot go on. Where a run ends early, it says why, and the state stays as it was at
   that time. */
#include "../varmass.h"
#include "check.h"
#include <limits.h>

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static const vm_vec3 zero = {0, 0, 0}, along_x = {1, 0, 0};

enum { BODIES = 3, EFFECTS = 2, EVENTS = 2, NUMBERS = 64 };

/* A scene and all arrays that it needs */
typedef struct stage {
    vm_scene s;
    vm_scene_body bodies[BODIES];
    vm_effect effects[EFFECTS];
    vm_event events[EVENTS];
    ode_event located[EVENTS];
    vm_real t, y[NUMBERS], work[VM_SCENE_WORK(NUMBERS)];
} stage;

/* An empty stage for so many bodies, effects and events, which the caller fills in */
static void set_stage(stage *g, int bodies, int effects, int events)
{
    memset(g, 0, sizeof *g);
    g->s.bodies = g->bodies;
    g->s.n_bodies = bodies;
    g->s.effects = g->effects;
    g->s.n_effects = effects;
    g->s.events = g->events;
    g->s.located = g->located;
    g->s.n_events = events;
}

static int run_on(stage *g, vm_real t_end) { return vm_scene_run(&g->s, &g->t, t_end, g->y, g->work, NULL); }

/* Start at g->t, which must succeed, and run */
static int run(stage *g, vm_real t_end)
{
    CHECK(vm_scene_start(&g->s, g->t, g->y, NULL) == VM_OK);
    return run_on(g, t_end);
}

/* ---- The check before the start ---- */

static const vm_real rising[2] = {1, 2}, falling[2] = {2, 1}, unknown[2] = {1, VM_NAN};

/* A point, another that is away, and a free body; gravity; a separation into the second */
static void set_good_stage(stage *g)
{
    vm_body part;
    memset(&part, 0, sizeof part);
    part.mass = 1;
    part.q.w = 1;
    set_stage(g, 3, 1, 1);
    g->bodies[0] = vm_scene_body_point(2, zero, along_x);
    g->bodies[1] = vm_scene_body_absent(vm_scene_body_point(1, zero, zero));
    g->bodies[2] = vm_scene_body_free(&part);
    g->effects[0] = vm_effect_gravity(0, 1, R(-9.81));
    g->events[0] = vm_then_separate(vm_event_at(1), 0, 1, &part, 0);
    g->s.times = rising;
    g->s.n_times = 2;
}

/* Spoil one thing of the scene; 0 if there is no such spoiling */
static int spoil_scene(vm_scene *s, int which)
{
    switch (which) {
    case 0: s->n_bodies = 0; return 1;
    case 1: s->bodies = NULL; return 1;
    case 2: s->n_effects = -1; return 1;
    case 3: s->effects = NULL; return 1;
    case 4: s->n_events = -1; return 1;
    case 5: s->events = NULL; return 1;
    case 6: s->located = NULL; return 1;
    case 7: s->n_times = -1; return 1;
    case 8: s->times = falling; return 1;
    case 9: s->times = unknown; return 1;
    default: return 0;
    }
}

/* Spoil one thing of a body */
static int spoil_body(vm_scene_body *b, int which)
{
    switch (which) {
    case 0: b->motion = VM_LINE - 1; return 1;
    case 1: b->motion = VM_FREE + 1; return 1;
    case 2: b->put = NULL; return 1;
    case 3: b->start.inertia.xx = 1; return 1;
    case 4: b->start.inertia.yy = 1; return 1;
    case 5: b->start.inertia.zz = 1; return 1;
    case 6: b->start.inertia.xy = 1; return 1;
    case 7: b->start.inertia.xz = 1; return 1;
    case 8: b->start.inertia.yz = 1; return 1;
    default: return 0;
    }
}

/* Spoil one thing of the effect, or of the event */
static int spoil_effect_or_event(vm_effect *effect, vm_event *event, int which)
{
    switch (which) {
    case 0: effect->coordinate = -1; return 1;
    case 1: effect->coordinate = 3; return 1;
    case 2:
        effect->body = 2;
        effect->coordinate = 3;
        return 1;
    case 3: event->external.linear.x = VM_NAN; return 1;
    case 4: event->external.couple.x = VM_NAN; return 1;
    case 5: event->jump_body = 3; return 1;
    case 6: event->other = 5; return 1;
    default: return 0;
    }
}

/* The good stage passes the check, and does not with any one thing spoiled. */
static void test_spoiled_scenes(void)
{
    static stage g;
    int k, spoiled = 0;
    set_good_stage(&g);
    CHECK(vm_scene_check(&g.s, NULL) == VM_OK);
    for (k = 0; k < 10; k++) {
        set_good_stage(&g);
        spoiled += spoil_scene(&g.s, k);
        CHECK(vm_scene_check(&g.s, NULL) != VM_OK);
        set_good_stage(&g);
        if (spoil_body(&g.bodies[0], k)) {
            spoiled++;
            CHECK(vm_scene_check(&g.s, NULL) != VM_OK);
        }
        set_good_stage(&g);
        if (spoil_effect_or_event(&g.effects[0], &g.events[0], k)) {
            spoiled++;
            CHECK(vm_scene_check(&g.s, NULL) != VM_OK);
        }
    }
    CHECK(spoiled == 26);
    CHECK(vm_scene_check(NULL, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_budget_at(NULL, 0, NULL, NULL) == VM_BAD_ARGUMENT);
}

/* Only an effect that is there can be switched. */
static void test_switched_effect(void)
{
    static stage g;
    int k;
    for (k = -1; k < 2; k++) {
        set_stage(&g, 1, 1, 1);
        g.bodies[0] = vm_scene_body_line(1, 0, 0);
        g.effects[0] = vm_effect_gravity(0, 0, 1);
        g.events[0] = vm_then_switch(vm_event_at(1), k, 1);
        CHECK(vm_scene_check(&g.s, NULL) == (k == 0 ? VM_OK : VM_NO_SUCH_EFFECT));
    }
}

/* Of a range of effects each must be there, and its length cannot be negative. An empty range switches nothing. */
static void test_switched_range(void)
{
    static const struct {
        int first, n, status;
    } cases[] = {{0, 2, VM_OK}, {1, 1, VM_OK}, {2, 0, VM_OK}, {1, 2, VM_NO_SUCH_EFFECT}, {-1, 2, VM_NO_SUCH_EFFECT},
                 {3, 0, VM_NO_SUCH_EFFECT}, {1, INT_MAX, VM_NO_SUCH_EFFECT}, {0, -1, VM_BAD_ARGUMENT}};
    static stage g;
    int k;
    for (k = 0; k < VM_LENGTH(cases); k++) {
        set_stage(&g, 1, 2, 1);
        g.bodies[0] = vm_scene_body_line(1, 0, 0);
        g.effects[0] = vm_effect_gravity(0, 0, 1);
        g.effects[1] = vm_effect_gravity(0, 0, 1);
        g.events[0] = vm_then_switch_range(vm_event_at(1), cases[k].first, cases[k].n, 1);
        CHECK(vm_scene_check(&g.s, NULL) == cases[k].status);
    }
}

/* A list of actions is refused with the status of the first action that is wrong, and if it contains a list. */
static void test_list_of_actions(void)
{
    const vm_event now = vm_event_at(1);
    vm_event actions[2];
    static stage g;
    set_stage(&g, 1, 1, 1);
    g.bodies[0] = vm_scene_body_line(1, 0, 0);
    g.effects[0] = vm_effect_gravity(0, 0, 1);
    actions[0] = vm_then_stop(now);
    actions[1] = vm_then_switch(now, 0, 1);
    g.events[0] = vm_then_all(now, actions, 2);
    CHECK(vm_scene_check(&g.s, NULL) == VM_OK);
    actions[1] = vm_then_switch(now, 1, 1);
    CHECK(vm_scene_check(&g.s, NULL) == VM_NO_SUCH_EFFECT);
    actions[0] = vm_then_attach_on_line(now, 0, 0);
    CHECK(vm_scene_check(&g.s, NULL) == VM_SAME_BODY);
    actions[0] = vm_then_user(now, NULL, NULL);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_ARGUMENT);
    actions[0] = vm_then_all(now, actions, 2);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_ARGUMENT);
    actions[0] = now; /* an action that does nothing */
    actions[1] = vm_then_stop(now);
    CHECK(vm_scene_check(&g.s, NULL) == VM_OK && run(&g, 2) == VM_STOPPED && g.t == 1);
    g.events[0] = vm_then_all(now, actions, -1);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_ARGUMENT);
    g.events[0] = vm_then_all(now, NULL, 0);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_ARGUMENT);
}

/* An event at a contact checks its point, whatever it does. */
static void test_contact_of_an_event(void)
{
    static const vm_contact beside = {{1, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 1, 0};
    static stage g;
    set_stage(&g, 2, 0, 1);
    g.bodies[0] = vm_scene_body_point(1, zero, zero);
    g.bodies[1] = vm_scene_body_point(1, zero, zero);
    g.events[0] = vm_then_stop(vm_event_contact(0, &beside));
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_POINT);
    g.events[0] = vm_then_attach(vm_event_contact(0, &beside), 0, 1);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_POINT);
}

static void fixed_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)t;
    (void)ctx;
    *r = *v = *a = vmi_vec3(0, 0, 0);
}

static vm_band a_band(void)
{
    vm_band band;
    memset(&band, 0, sizeof band);
    band.radius = R(0.5);
    band.thickness = R(0.01);
    band.width = R(0.1);
    band.density = 7;
    band.reactive = 1;
    return band;
}

/* A body in the plane that is linked to the ground, a point that is away, an axle with a band; a separation */
static void set_linked_stage(stage *g, const vm_band *band)
{
    vm_body part;
    memset(&part, 0, sizeof part);
    part.mass = 1;
    set_stage(g, 3, 2, 1);
    g->bodies[0] = vm_scene_body_plane(2, 1, zero, 0, zero, 0);
    g->bodies[1] = vm_scene_body_absent(vm_scene_body_point(1, zero, zero));
    g->bodies[2] = vm_scene_body_axle(1, 0, 0);
    g->effects[0] = vm_effect_link(0, VM_GROUND, fixed_point, NULL, 1, 0, 10);
    g->effects[1] = vm_effect_band(2, band);
    g->events[0] = vm_then_separate(vm_event_at(1), 0, 1, &part, 0);
}

/* Links of a body with itself and with one that grows, bands of no width or density, a growing body in space that is
   not free, a point that leaves a body on a line, an effect that is switched and not there */
static void test_links_and_bands(void)
{
    static stage g;
    vm_band band = a_band();
    set_linked_stage(&g, &band);
    CHECK(vm_scene_check(&g.s, NULL) == VM_OK);

    g.effects[0] = vm_effect_link(0, 0, NULL, NULL, 1, 0, 10);
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);

    set_linked_stage(&g, &band);
    g.bodies[1] = vm_scene_body_growing_plane(g.bodies[0]);
    g.s.n_events = 0;
    g.effects[0] = vm_effect_link(0, 1, NULL, NULL, 1, 0, 10);
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);

    band.width = -1;
    set_linked_stage(&g, &band);
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);

    band = a_band();
    band.density = -1;
    set_linked_stage(&g, &band);
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);

    band = a_band();
    set_linked_stage(&g, &band);
    g.bodies[0] = vm_scene_body_growing_free(g.bodies[0]);
    g.s.n_effects = 0;
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);

    set_linked_stage(&g, &band);
    g.bodies[0] = vm_scene_body_line(2, 0, 0);
    g.s.n_effects = 0;
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);

    set_linked_stage(&g, &band);
    g.events[0] = vm_then_switch(vm_event_at(1), 2, 1);
    CHECK(vm_scene_check(&g.s, NULL) != VM_OK);
}

/* Laws of mass that are none */
static void test_bad_mass_laws(void)
{
    static stage g;
    set_stage(&g, 1, 1, 0);
    g.bodies[0] = vm_scene_body_line(2, 0, 1);
    g.effects[0] = vm_effect_mass_law(0, NULL, NULL, zero, 1);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_ARGUMENT);
    g.effects[0] = vm_effect_mass(0, -1, 1, 0, 1);
    CHECK(vm_scene_check(&g.s, NULL) < 0);
    CHECK(vm_force_stream(4, 2, 3, R(0.5)) == 2 && vm_force_stream(7, -1, 2, 0) == -2);
}

/* ---- Output at given times ---- */

static int outputs;
static vm_real seen[4]; /* the times of the first outputs */

static int remember(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    (void)y;
    (void)scene;
    (void)ctx;
    if (outputs < 4) seen[outputs] = t;
    outputs++;
    return outputs == 3; /* the third is enough */
}

/* A mass of 2 kg that loses 1 kg per second, with outputs at n times */
static void set_losing_stage(stage *g, int n, const vm_real *times)
{
    set_stage(g, 1, 1, 0);
    g->bodies[0] = vm_scene_body_with_mass_state(vm_scene_body_line(2, 0, 1));
    g->effects[0] = vm_effect_stream(0, -1, zero, 0);
    g->s.output = remember;
    g->s.times = times;
    g->s.n_times = n;
    outputs = 0;
}

/* Times before the start are left out. The third output stops the run, which then goes on, but not backward, not to
   infinity, and not with options that are none. */
static void test_output(void)
{
    static const vm_real times[5] = {R(-1), R(0.5), R(0.75), R(1.5), 9};
    static stage g;
    vm_real atol[NUMBERS];
    rk45_options options = rk45_defaults(NULL);
    int i;
    for (i = 0; i < NUMBERS; i++) atol[i] = R(1e-3);
    for (i = 0; i < 2; i++) {
        set_losing_stage(&g, 5 - i, times + i);
        CHECK(run(&g, 4) == VM_STOPPED);
        CHECK(outputs == 3 && seen[0] == R(0.5) && seen[1] == R(0.75) && seen[2] == R(1.5) && g.t == R(1.5));
    }
    check_error("mass of a stream", "", "eps", fabs((double)g.y[2] - 0.5) / eps, 16, 0, 0);
    CHECK(run_on(&g, 1) == VM_BAD_TIMES && run_on(&g, VM_INFINITY) < 0);
    options.atol_each = atol;
    CHECK(vm_scene_run(&g.s, &g.t, R(1.75), g.y, g.work, &options) == VM_OK && g.t == R(1.75));
    options.h0 = VM_NAN;
    CHECK(vm_scene_run(&g.s, &g.t, 2, g.y, g.work, &options) == VM_BAD_OPTIONS);
}

/* A run from before 0; one that begins after all times of output; and a t that is no number */
static void test_run_times(void)
{
    static const vm_real times[2] = {R(-1.5), R(-0.5)};
    static stage g;
    set_stage(&g, 1, 0, 0);
    g.bodies[0] = vm_scene_body_line(2, 0, 1);
    g.s.output = remember;
    g.s.times = times;
    g.s.n_times = 2;
    outputs = 0;
    g.t = -2;
    CHECK(run(&g, 1) == VM_OK);
    CHECK(outputs == 2 && seen[0] == R(-1.5) && seen[1] == R(-0.5) && g.t == 1);
    check_error("run from before 0", "", "eps", fabs((double)g.y[0] - 3) / eps, 8, 0, 0);
    CHECK(run_on(&g, 2) == VM_OK && outputs == 2 && g.t == 2);
    g.t = -VM_INFINITY;
    CHECK(run_on(&g, 2) == VM_NOT_FINITE && g.t == -VM_INFINITY);
}

/* ---- Masses that run out ---- */

/* The mass passes 1.25 kg at 0.75 s, as a state and by a law. */
static void test_events_of_mass(void)
{
    static stage g;
    int by_law;
    for (by_law = 0; by_law < 2; by_law++) {
        set_stage(&g, 1, 1, 1);
        g.bodies[0] = vm_scene_body_line(2, 0, 1);
        g.effects[0] = vm_effect_mass(0, VM_MASS_OF_T, -1, 0, 0);
        if (!by_law) {
            g.bodies[0] = vm_scene_body_with_mass_state(g.bodies[0]);
            g.effects[0] = vm_effect_stream(0, -1, zero, 0);
        }
        g.events[0] = vm_then_stop(vm_event_mass(0, R(1.25), -1));
        CHECK(run(&g, 4) == VM_STOPPED);
        check_error("event of a mass", by_law ? "law" : "state", "eps", fabs((double)g.t - 0.75) / eps, 32, 0, 0);
    }
}

/* Two bodies whose masses run out at the same time */
static void test_masses_used_up(void)
{
    static stage g;
    int k;
    set_stage(&g, 2, 2, 0);
    for (k = 0; k < 2; k++) {
        g.bodies[k] = vm_scene_body_line(2, 0, 1);
        g.effects[k] = vm_effect_mass(k, VM_MASS_OF_T, -1, 0, 0);
    }
    CHECK(run(&g, 3) == VM_BAD_MASS && g.t <= 2 && g.t > R(1.9));
}

/* A stream from outside of a growing body, in the plane and in space, takes the inertia before the mass. */
static void test_inertia_used_up(void)
{
    static stage g;
    vm_stream stream;
    vm_body body;
    int k;
    memset(&stream, 0, sizeof stream);
    memset(&body, 0, sizeof body);
    body.mass = 2;
    body.v.x = 1;
    body.omega.z = 1;
    body.inertia.xx = body.inertia.yy = body.inertia.zz = 1;
    stream.rate = -1;
    stream.at.x = 2;
    stream.motion = VM_RELATIVE;
    for (k = 0; k < 2; k++) {
        set_stage(&g, 1, 1, 0);
        if (k == 0) g.bodies[0] = vm_scene_body_growing_plane(vm_scene_body_plane(2, 1, zero, 0, along_x, 1));
        else g.bodies[0] = vm_scene_body_growing_free(vm_scene_body_free(&body));
        g.effects[0] = vm_effect_stream_mass(0, &stream);
        CHECK(run(&g, 3) < 0 && g.t < 2 && g.t > 0);
    }
}

/* A point may be a free body, but not a growing one. */
static void test_free_point(void)
{
    static stage g;
    vm_body body;
    memset(&body, 0, sizeof body);
    body.mass = 2;
    body.v.x = 1;
    set_stage(&g, 1, 1, 0);
    g.bodies[0] = vm_scene_body_free(&body);
    g.effects[0] = vm_effect_gravity(0, 2, -2);
    CHECK(run(&g, 3) == VM_OK);
    vm_scene_body_at(&g.s, 0, g.y, &body);
    check_error("point as free body", "r", "eps", hypot((double)body.r.x - 3, (double)body.r.z + 9) / eps, 2000, 0,
                0); /* of 9, the roundings of all steps */
    g.bodies[0] = vm_scene_body_growing_free(g.bodies[0]);
    g.t = 0;
    CHECK(vm_scene_start(&g.s, g.t, g.y, NULL) != VM_OK || run_on(&g, 3) == VM_BAD_INERTIA);
}

/* ---- Jumps ---- */

/* 0.5 kg separate at 1 s from a body of 2 kg, into one that is away: on a line or on an axle */
static void set_separation(stage *g, int on_axle)
{
    vm_scene_body (*make)(vm_real, vm_real, vm_real) = on_axle ? vm_scene_body_axle : vm_scene_body_line;
    vm_body part;
    memset(&part, 0, sizeof part);
    part.mass = R(0.5);
    part.v.x = 1;
    part.omega.z = 1;
    part.inertia.zz = R(0.01);
    set_stage(g, 2, 0, 1);
    g->bodies[0] = make(2, R(0.1), 3);
    g->bodies[1] = vm_scene_body_absent(make(R(0.5), 0, 0));
    g->events[0] = vm_then_separate(vm_event_at(1), 0, 1, &part, 0);
}

/* The run ends at the jump, or goes on to its end. */
static void check_jump(stage *g, int is_refused)
{
    const int status = run(g, 2);
    CHECK((status < 0) == is_refused && g->t == (is_refused ? 1 : 2));
}

/* Separations and attachments on a line, on an axle and in the plane, with and without a balance */
static void test_jumps(void)
{
    static stage g;
    vm_budget book;
    set_separation(&g, 0);
    vm_scene_keep_budget(&g.s, &book);
    check_jump(&g, 0);
    check_error("jump on a line", "", "eps", fabs((double)g.y[1] - (2 * 3 - 0.5 * 1) / 1.5) / eps, 8, 0, 0);
    CHECK(vm_scene_budget_at(&g.s, g.t, NULL, &book) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_budget_at(&g.s, g.t, g.y, NULL) == VM_BAD_ARGUMENT);

    set_separation(&g, 1);
    check_jump(&g, 0);

    set_separation(&g, 0);
    g.bodies[0] = vm_scene_body_plane(2, 1, zero, 0, along_x, 2);
    g.bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, zero, 0, along_x, 2));
    check_jump(&g, 0);

    set_separation(&g, 1);
    g.bodies[1].absent = 0;
    g.events[0] = vm_then_attach(vm_event_at(1), 0, 1);
    check_jump(&g, 0);
}

/* A part that leaves nothing, a part into what is there already, an attachment of what is not there, and a rest in
   the plane that is a point */
static void test_refused_jumps(void)
{
    static stage g;
    int on_axle;
    for (on_axle = 0; on_axle < 2; on_axle++) {
        set_separation(&g, on_axle);
        g.events[0].part.mass = 2;
        check_jump(&g, 1);
    }
    set_separation(&g, 0);
    g.bodies[1].absent = 0;
    check_jump(&g, 1);

    set_separation(&g, 1);
    g.events[0] = vm_then_attach(vm_event_at(1), 0, 1);
    check_jump(&g, 1);

    set_separation(&g, 0);
    g.bodies[0] = vm_scene_body_plane(2, R(0.01), zero, 0, along_x, 2);
    g.bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, zero, 0, along_x, 2));
    g.events[0].part.omega.z = 2;
    g.events[0].part.r.x = 1; /* where the whole is by then */
    check_jump(&g, 1);
}

/* 0.5 kg, 0.25 m beside the mass centre, separate at 1 s from a body in the plane that turns at 1 rad/s */
static void set_separation_in_plane(stage *g)
{
    vm_body part;
    memset(&part, 0, sizeof part);
    part.mass = R(0.5);
    part.inertia.zz = R(0.02);
    part.r.x = R(0.25);
    set_stage(g, 2, 0, 1);
    g->bodies[0] = vm_scene_body_plane(2, 1, zero, 0, zero, 1);
    g->bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, zero, 0, zero, 0));
    g->events[0] = vm_then_separate_in_plane(vm_event_at(1), 0, 1, &part, 1);
}

/* The jump is refused with this status, and the state stays the one before it. */
static void check_refused_in_plane(stage *g, int wanted)
{
    vm_body now;
    CHECK(run(g, 2) == wanted && g->t == 1);
    vm_scene_body_at(&g->s, 0, g->y, &now);
    CHECK(now.mass == 2);
}

/* A part heavier than the whole, an attachment to what is not there, and one whose inertia overflows */
static void test_refused_jumps_in_plane(void)
{
    static stage g;
    set_separation_in_plane(&g);
    g.events[0].part.mass = 3;
    check_refused_in_plane(&g, VM_BAD_MASS);

    set_separation_in_plane(&g);
    g.events[0] = vm_then_attach(vm_event_at(1), 1, 0);
    check_refused_in_plane(&g, VM_IS_AWAY);

    set_separation_in_plane(&g);
    g.bodies[1].absent = 0;
    g.bodies[1].start.r.x = VM_MAX / 4;
    g.events[0] = vm_then_attach(vm_event_at(1), 0, 1);
    check_refused_in_plane(&g, VM_NOT_FINITE);
}

/* The part rests in the body at 0.25 m, and then flies uniformly, at the spin 1; a jump into a body that grows puts
   its mass centre to where it is. */
static void test_jump_into_growing_body(void)
{
    const double x = 0.25 * (cos(1) - sin(1)), y = 0.25 * (sin(1) + cos(1));
    static stage g;
    vm_budget book;
    vm_body whole, part;
    int grows;
    for (grows = 0; grows < 2; grows++) {
        set_separation_in_plane(&g);
        if (grows) g.bodies[1] = vm_scene_body_growing_plane(g.bodies[1]);
        vm_scene_keep_budget(&g.s, grows ? &book : NULL);
        CHECK(run(&g, 2) == VM_OK && g.t == 2);
        vm_scene_body_at(&g.s, 0, g.y, &whole);
        vm_scene_body_at(&g.s, 1, g.y, &part);
        CHECK(whole.mass == R(1.5));
        check_error("part after a jump", "r", "eps", hypot((double)part.r.x - x, (double)part.r.y - y) / eps, 64,
                    grows, 0);
        CHECK(fabs((double)(part.mass * part.r.x + whole.mass * whole.r.x)) < 64 * eps);
    }
}

/* ---- Events ---- */

static long happenings; /* of the events below */

/* Makes a state that is no number; ctx is the status */
static int break_state(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    y[1] = VM_NAN;
    return *(const int *)ctx;
}

/* Changes nothing */
static int nothing_more(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    happenings++;
    return VM_OK;
}

/* An event that has always just not happened yet, until 10000 are enough */
static int wake(vm_real t, vm_real *y, void *ctx)
{
    vm_event *e = (vm_event *)ctx;
    (void)y;
    e->time = t;
    e->count = 0;
    e->most = 0;
    happenings++;
    return happenings > 10000 ? -77 : VM_OK;
}

/* A ball that comes to rest; contact number *ctx stops the run */
static int bounce(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    y[0] = 0;
    y[1] = -y[1] / 2;
    happenings++;
    return happenings == *(const long *)ctx ? VM_STOPPED : VM_OK;
}

static void test_endless_event(void)
{
    static stage g;
    set_stage(&g, 1, 0, 1);
    g.bodies[0] = vm_scene_body_line(1, 1, 0);
    g.events[0] = vm_then_user(vm_event_at(1), wake, &g.events[0]);
    happenings = 0;
    CHECK(run(&g, 2) == -77 && g.t == 1);
}

/* A ball makes more contacts than there may be. If the last of them ends the run, that is what the run says. */
static void test_too_many_contacts(void)
{
    static stage g;
    long last = 0;
    set_stage(&g, 1, 1, 1);
    g.bodies[0] = vm_scene_body_line(1, 1, 0);
    g.effects[0] = vm_effect_gravity(0, 0, R(-9.81));
    g.events[0] = vm_then_user(vm_event_position(0, 0, 0, -1), bounce, &last);
    happenings = 0;
    CHECK(run(&g, 10) == VM_TOO_MANY_EVENTS);
    last = happenings;
    happenings = 0;
    g.t = 0;
    CHECK(run(&g, 10) == VM_STOPPED && happenings == last);
}

/* A body of 1 kg on a spring, at 1 m */
static void set_spring(stage *g, int events)
{
    set_stage(g, 1, 1, events);
    g->bodies[0] = vm_scene_body_line(1, 1, 0);
    g->effects[0] = vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1, 0);
}

/* An event makes a state that is no number, with a status of its own or without. */
static void test_events_that_break(void)
{
    static const int statuses[2] = {VM_OK, -77}, wanted[2] = {VM_NOT_FINITE, -77};
    static stage g;
    int k;
    for (k = 0; k < 2; k++) {
        int status = statuses[k];
        set_spring(&g, 1);
        g.events[0] = vm_then_user(vm_event_at(1), break_state, &status);
        CHECK(run(&g, 2) == wanted[k] && g.t == 1);
    }
}

/* Two events at the same instants, twice */
static void test_simultaneous_events(void)
{
    static stage g;
    int k;
    set_spring(&g, 2);
    for (k = 0; k < 2; k++) g.events[k] = vm_then_user(vm_event_position(0, 0, 0, 0), nothing_more, NULL);
    happenings = 0;
    CHECK(run(&g, 6) == VM_OK && g.t == 6 && happenings == 4);
}

/* ---- Why a run ends early ---- */

/* A force that grows without bound, v = 1/(1 - t); a force that ceases to be a number */
static vm_real blows_up(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    (void)x;
    (void)ctx;
    return v * v;
}

static vm_real no_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)x;
    (void)v;
    (void)ctx;
    return t < 1 ? 0 : VM_NAN;
}

/* A mass that is *ctx from 1 s on */
static vm_mass_law_values no_law(vm_real t, vm_real x, vm_real v, void *ctx)
{
    vm_mass_law_values now = {2, 0, 0, 0};
    (void)x;
    (void)v;
    if (t >= 1) now.mass = *(const vm_real *)ctx;
    return now;
}

/* What an event watches ceases to be a number. */
static vm_real no_event(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t < 1 ? 1 : VM_NAN;
}

/* A body on a line with one effect */
static void set_driven(stage *g, vm_effect effect)
{
    set_stage(g, 1, 1, 0);
    g->bodies[0] = vm_scene_body_line(1, 0, 1);
    g->effects[0] = effect;
}

static void check_end(stage *g, const rk45_options *o, int wanted)
{
    const int status = vm_scene_run(&g->s, &g->t, 3, g->y, g->work, o);
    if (status != wanted) printf("the run ends: %s, not %s\n", vm_strerror(status), vm_strerror(wanted));
    CHECK(status == wanted);
}

/* The effect ends the run at 1 s. */
static void check_end_by_effect(vm_effect effect, int wanted)
{
    static stage g;
    set_driven(&g, effect);
    CHECK(vm_scene_start(&g.s, g.t, g.y, NULL) == VM_OK);
    check_end(&g, NULL, wanted);
    CHECK(g.t > R(0.99) && g.t < R(1.001));
}

/* Each reason has a status: the scene itself is good. */
static void test_ends_of_runs(void)
{
    static stage g;
    vm_real none = VM_NAN, endless = VM_INFINITY, nothing_left = 0;
    const vm_effect drive = vm_effect_motor(0, 0, 1, 0);
    rk45_options o = rk45_defaults(NULL);
    check_end_by_effect(vm_effect_force(0, 0, blows_up, NULL), VM_STEP_TOO_SMALL);
    check_end_by_effect(vm_effect_force(0, 0, no_force, NULL), VM_NOT_FINITE);
    check_end_by_effect(vm_effect_mass_law(0, no_law, &none, zero, 0), VM_NOT_FINITE);
    check_end_by_effect(vm_effect_mass_law(0, no_law, &endless, zero, 0), VM_NOT_FINITE);
    check_end_by_effect(vm_effect_mass_law(0, no_law, &nothing_left, zero, 0), VM_BAD_MASS);

    set_driven(&g, drive);
    g.events[0] = vm_event_user(no_event, NULL, 0);
    g.s.n_events = 1;
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    check_end(&g, NULL, VM_NOT_FINITE);

    set_driven(&g, drive);
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    o.max_steps = 2;
    o.h_max = R(0.01);
    check_end(&g, &o, VM_MAX_STEPS);
    CHECK(run_on(&g, 3) == VM_OK && g.t == 3); /* goes on */

    set_driven(&g, drive);
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    o = rk45_defaults(NULL);
    o.h_min = 2;
    o.h_max = 1;
    check_end(&g, &o, VM_BAD_OPTIONS);
    g.y[1] = VM_NAN;
    check_end(&g, NULL, VM_NOT_FINITE);
    g.y[1] = 1;
    g.t = 4;
    check_end(&g, NULL, VM_BAD_TIMES);
}

/* ---- Arrays that are too short, scenes that are not started ---- */

/* Arrays whose size is known are checked before anything is written. */
static void test_sizes_of_scenes(void)
{
    vm_scene_body bodies[2];
    vm_real y[5], work[VM_SCENE_WORK(5)], t = 0;
    vm_budget book;
    vm_scene s;
    int i;
    memset(&s, 0, sizeof s);
    bodies[0] = vm_scene_body_line(1, 0, 1);
    bodies[1] = vm_scene_body_with_mass_state(bodies[0]);
    s.bodies = bodies;
    s.n_bodies = 2;
    for (i = -1; i < 5; i++) { /* less than 5 numbers */
        s.y_size = i ? i : 4;
        y[0] = 7;
        CHECK(vm_scene_start(&s, 0, y, NULL) == VM_SHORT_ARRAY && y[0] == 7);
        CHECK(vm_scene_run(&s, &t, 1, y, work, NULL) == VM_NOT_STARTED && y[0] == 7);
    }
    s.y_size = VM_LENGTH(y);
    s.work_size = VM_LENGTH(work);
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_OK && vm_scene_run(&s, &t, 1, y, work, NULL) == VM_OK && t == 1);
    s.work_size--;
    work[0] = 7;
    CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == VM_SHORT_ARRAY && t == 1 && work[0] == 7);
    s.work_size++;
    s.y_size--;
    CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == VM_SHORT_ARRAY && t == 1 && work[0] == 7);
    s.y_size++;
    vm_scene_keep_budget(&s, &book); /* needs VM_BUDGET_STATES numbers more */
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_SHORT_ARRAY);
    s.y_size = s.work_size = 0;
    vm_scene_keep_budget(&s, NULL); /* not checked */
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_OK && vm_scene_run(&s, &t, 3, y, work, NULL) == VM_OK && t == 3);
}

/* A scene that was never started, whose start was refused, or that has got other bodies, effects or events since, or
   was copied so that its events belong to another: none of them runs. */
enum { NEVER_STARTED, REFUSED_START, MORE_BODIES, OTHER_EFFECT, OTHER_EVENT, COPIED, WAYS };

static void test_not_started(void)
{
    static stage g;
    vm_scene copy, *s;
    vm_budget book, now_budget;
    vm_body now;
    int way, k;
    for (way = NEVER_STARTED; way < WAYS; way++) {
        set_stage(&g, 1, 1, 1);
        for (k = 0; k < 2; k++) {
            g.bodies[k] = vm_scene_body_line(1, 0, 1);
            g.effects[k] = vm_effect_motor(0, 0, 1, 0);
            g.events[k] = vm_then_stop(vm_event_at(1));
        }
        vm_scene_keep_budget(&g.s, &book);
        if (way == REFUSED_START) {
            g.effects[0].p[0] = VM_NAN;
            CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_NOT_FINITE);
        } else if (way != NEVER_STARTED) CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
        if (way == MORE_BODIES) g.s.n_bodies++;
        if (way == OTHER_EFFECT) g.effects[0] = vm_effect_damper(0, 0, VM_GROUND, 0, 1);
        if (way == OTHER_EVENT) g.events[0] = vm_then_stop(vm_event_at(2));
        copy = g.s;
        s = way == COPIED ? &copy : &g.s;
        CHECK(vm_scene_run(s, &g.t, 2, g.y, g.work, NULL) == VM_NOT_STARTED && g.t == 0);
        CHECK(vm_scene_budget_at(s, 0, g.y, &now_budget) == VM_NOT_STARTED);
        CHECK(vm_scene_budget_at(s, 0, g.y, &book) == VM_BAD_ARGUMENT); /* it holds the values at the start */
        vm_scene_body_at(&g.s, way == NEVER_STARTED || way == REFUSED_START ? 0 : 7, g.y, &now);
        CHECK(now.mass != now.mass && now.omega.z != now.omega.z);
    }
}

/* ---- Lists that are none, after the start ---- */

enum { NO_BODIES, NEGATIVE_EFFECTS, NEGATIVE_EVENTS, LISTS };

static void spoil_list(vm_scene *s, int which)
{
    if (which == NO_BODIES) s->bodies = NULL;
    if (which == NEGATIVE_EFFECTS) s->n_effects = -1;
    if (which == NEGATIVE_EVENTS) s->n_events = -1;
}

static void test_lists_after_start(void)
{
    static stage g;
    static vm_real rates[NUMBERS];
    vm_budget book, other;
    vm_body now;
    vm_vec3 r, v;
    int which;
    for (which = 0; which < LISTS; which++) {
        set_stage(&g, 1, 1, 1);
        g.bodies[0] = vm_scene_body_line(1, 0, 1);
        g.effects[0] = vm_effect_motor(0, 0, 1, 0);
        g.events[0] = vm_then_stop(vm_event_at(1));
        vm_scene_keep_budget(&g.s, &book);
        CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
        vm_scene_body_at(&g.s, VM_GROUND, g.y, &now);
        CHECK(now.mass != now.mass);
        spoil_list(&g.s, which);
        CHECK(vm_scene_run(&g.s, &g.t, 2, g.y, g.work, NULL) == VM_BAD_ARGUMENT && g.t == 0);
        CHECK(vm_scene_budget_at(&g.s, 0, g.y, &other) == VM_BAD_ARGUMENT);
        if (which != NEGATIVE_EVENTS) CHECK(vm_scene_rhs(0, g.y, rates, &g.s) == VM_BAD_ARGUMENT && rates[0] == 0);
        if (which != NO_BODIES) continue;
        vm_scene_body_at(&g.s, 0, g.y, &now);
        vm_scene_point_at(&g.s, 0, zero, g.y, &r, &v);
        CHECK(now.mass != now.mass && r.x != r.x);
        vm_scene_push_at(&g.s, 0, zero, g.y, along_x);
        CHECK(g.s.status == VM_BAD_ARGUMENT);
    }
}

/* A force on a body that does not exist, or on a scene that was not started; a budget of a state that is none */
static void test_pushes(void)
{
    static stage g;
    vm_budget book, now_budget;
    set_stage(&g, 1, 1, 0);
    g.bodies[0] = vm_scene_body_line(1, 0, 1);
    g.effects[0] = vm_effect_motor(0, 0, 1, 0);
    vm_scene_push_at(&g.s, 0, zero, g.y, along_x);
    CHECK(g.s.status == VM_BAD_ARGUMENT);
    vm_scene_keep_budget(&g.s, &book);
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    vm_scene_push_at(&g.s, -2, zero, g.y, along_x);
    CHECK(g.s.status == VM_NO_SUCH_BODY);
    g.s.status = VM_OK;
    vm_scene_push_at(&g.s, 1, zero, g.y, along_x);
    CHECK(g.s.status == VM_NO_SUCH_BODY);
    g.s.status = VM_OK;
    vm_scene_push_at(&g.s, VM_GROUND, zero, g.y, along_x);
    CHECK(g.s.status == VM_OK);
    g.y[0] = VM_NAN;
    CHECK(vm_scene_budget_at(&g.s, 0, g.y, &now_budget) == VM_NOT_FINITE);
}

/* Growing bodies without mass; an effect that is taken out after the start */
static void test_impossible_bodies(void)
{
    static stage g;
    vm_body b;
    memset(&b, 0, sizeof b);
    b.q.w = b.inertia.xx = b.inertia.yy = b.inertia.zz = 1;
    set_stage(&g, 1, 1, 0);
    g.bodies[0] = vm_scene_body_growing_free(vm_scene_body_free(&b));
    g.effects[0] = vm_effect_gravity(0, 0, 1);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_MASS);
    b.mass = 1;
    b.inertia.zz = 5; /* more than the sum of the other two */
    g.bodies[0] = vm_scene_body_growing_free(vm_scene_body_free(&b));
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_INERTIA);
    b.inertia.zz = 1;
    g.bodies[0] = vm_scene_body_growing_free(vm_scene_body_free(&b));
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    g.effects[0].apply = NULL;
    CHECK(run_on(&g, 1) == VM_NOT_STARTED);
}

/* ---- Numbers of effects that are none ---- */

static void refuses_effect(vm_effect effect, int status)
{
    static stage g;
    set_stage(&g, 2, 1, 0);
    g.bodies[0] = vm_scene_body_plane(1, 1, zero, 0, zero, 0);
    g.bodies[1] = vm_scene_body_point(1, along_x, zero);
    g.effects[0] = effect;
    CHECK(vm_scene_check(&g.s, NULL) == status);
}

static void test_spoiled_springs(void)
{
    const vm_point_spring good = {{0, 0, 0}, {0, 0, 0}, 1, 1, 1};
    vm_point_spring spring = good;
    refuses_effect(vm_effect_point_spring(0, 1, &spring), VM_OK);
    spring.stiffness = VM_NAN;
    refuses_effect(vm_effect_point_spring(0, 1, &spring), VM_NOT_FINITE);
    spring = good;
    spring.damping = VM_INFINITY;
    refuses_effect(vm_effect_point_spring(0, 1, &spring), VM_NOT_FINITE);
    spring = good;
    spring.rest = VM_NAN;
    refuses_effect(vm_effect_point_spring(0, 1, &spring), VM_NOT_FINITE);
}

static void test_spoiled_contacts(void)
{
    const vm_contact good = {{0, 0, 0}, 0, {0, -1, 0}, {0, 1, 0}, 1, 1};
    vm_contact contact = good;
    refuses_effect(vm_effect_contact(0, &contact), VM_OK);
    contact.radius = VM_NAN;
    refuses_effect(vm_effect_contact(0, &contact), VM_NOT_FINITE);
    contact.radius = -1;
    refuses_effect(vm_effect_contact(0, &contact), VM_DOMAIN);
    contact = good;
    contact.stiffness = VM_INFINITY;
    refuses_effect(vm_effect_contact(0, &contact), VM_NOT_FINITE);
    contact = good;
    contact.on.x = VM_NAN;
    refuses_effect(vm_effect_contact(0, &contact), VM_NOT_FINITE);
    contact = good;
    contact.normal.z = VM_INFINITY;
    refuses_effect(vm_effect_contact(0, &contact), VM_NOT_FINITE);
}

/* A law of the mass that no constructor made */
static void test_unmade_law(void)
{
    static const vm_law unmade;
    const vm_law constant = vm_law_linear(1, 0);
    refuses_effect(vm_effect_mass_of_time(1, &constant, zero, 1), VM_OK);
    refuses_effect(vm_effect_mass_of_time(1, &unmade, zero, 1), VM_BAD_ARGUMENT);
}

/* Two masses at the same place attract each other with a force that is not finite. */
static void test_masses_at_one_place(void)
{
    static stage g;
    static vm_real rates[NUMBERS];
    set_stage(&g, 2, 1, 0);
    g.bodies[0] = vm_scene_body_point(1, zero, zero);
    g.bodies[1] = vm_scene_body_point(1, zero, zero);
    g.effects[0] = vm_effect_gravitation(0, 1, 1);
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    CHECK(vm_scene_rhs(0, g.y, rates, &g.s) == VM_OK && g.s.status == VM_NOT_FINITE && rates[0] != rates[0]);
}

/* An effect of the user that gives its body 1 kg more */
static void heavier(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)t;
    (void)y;
    scene->bodies[e->body].load.mass += 1;
}

/* A body on an axle without inertia, and a mass of the state that is used up, whatever an effect adds to it */
static void test_nothing_to_accelerate(void)
{
    static stage g;
    static vm_real rates[NUMBERS];
    set_stage(&g, 1, 1, 0);
    g.bodies[0] = vm_scene_body_axle(0, 0, 1);
    g.effects[0] = vm_effect_motor(0, 0, 1, 0);
    CHECK(vm_scene_check(&g.s, NULL) == VM_BAD_INERTIA);
    g.bodies[0] = vm_scene_body_with_mass_state(vm_scene_body_line(2, 0, 1));
    g.effects[0] = vm_effect_stream(0, -1, zero, 1);
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK);
    g.y[g.bodies[0].mass_at] = 0;
    CHECK(vm_scene_rhs(0, g.y, rates, &g.s) == VM_OK && g.s.status == VM_BAD_MASS && rates[0] != rates[0]);
    set_stage(&g, 1, 2, 0);
    g.bodies[0] = vm_scene_body_with_mass_state(vm_scene_body_line(2, 0, 1));
    g.effects[0] = vm_effect_stream(0, -1, zero, 1);
    g.effects[1] = vm_effect_custom(0, VM_GROUND, heavier, NULL);
    CHECK(vm_scene_start(&g.s, 0, g.y, NULL) == VM_OK && vm_scene_rhs(0, g.y, rates, &g.s) == VM_OK && g.s.status == VM_OK);
    g.y[g.bodies[0].mass_at] = 0;
    CHECK(vm_scene_rhs(0, g.y, rates, &g.s) == VM_OK && g.s.status == VM_BAD_MASS && rates[0] != rates[0]);
}

int main(void)
{
    test_spoiled_scenes();
    test_switched_effect();
    test_switched_range();
    test_list_of_actions();
    test_contact_of_an_event();
    test_links_and_bands();
    test_bad_mass_laws();
    test_output();
    test_run_times();
    test_events_of_mass();
    test_masses_used_up();
    test_inertia_used_up();
    test_free_point();
    test_jumps();
    test_refused_jumps();
    test_refused_jumps_in_plane();
    test_jump_into_growing_body();
    test_endless_event();
    test_too_many_contacts();
    test_events_that_break();
    test_simultaneous_events();
    test_ends_of_runs();
    test_sizes_of_scenes();
    test_not_started();
    test_lists_after_start();
    test_pushes();
    test_impossible_bodies();
    test_spoiled_springs();
    test_spoiled_contacts();
    test_unmade_law();
    test_masses_at_one_place();
    test_nothing_to_accelerate();
    return check_finish("refusals scenes");
}
