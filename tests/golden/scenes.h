/* varmass.h, scenes: every kind of body, effect and event, with and without a book. A scene of the plane or of space
   may have three bodies: a Cortex-M0 has 16 KB for all of it. */

static void try_forces(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real k = uniform(0, 3), alpha = uniform(0, 5), x = uniform(-2, 2), v = uniform(-2, 2);
        vm_real fx, fy;
        fold(vm_force_spring(x, k, alpha));
        fold(vm_force_damper(v, k));
        fold(vm_force_van_der_pol(x, v, k, alpha));
        fold(vm_force_motor(v, k, alpha));
        fold(vm_force_harmonic(v, k, alpha, x));
        fold(vm_force_gravity(k, alpha));
        fold(vm_force_stream(v, k, alpha, 1 - x));
        vm_force_shaft(x, v, k, alpha, &fx, &fy);
        fold(fx);
        fold(fy);
        vm_force_unbalance(v, k, alpha, x, &fx, &fy);
        fold(fx);
        fold(fy);
        vm_force_gyroscopic(x, v, k / 2, &fx, &fy);
        fold(fx);
        fold(fy);
    }
}

/* ---- what they share ---- */

enum { SCENE_BODIES = 3, SCENE_EFFECTS = 8, SCENE_EVENTS = 4, SCENE_STATE = 38 };
typedef struct golden_scene {
    vm_scene scene;
    vm_scene_body bodies[SCENE_BODIES];
    vm_effect effects[SCENE_EFFECTS];
    vm_event events[SCENE_EVENTS];
    ode_event located[SCENE_EVENTS];
    vm_real y[SCENE_STATE], work[VM_SCENE_WORK(SCENE_STATE)];
} golden_scene;
static golden_scene g; /* one for all, since a Cortex-M0 has 16 KB */

static void clear_scene(void)
{
    CLEAR(g);
    g.scene.bodies = g.bodies;
    g.scene.effects = g.effects;
    g.scene.events = g.events;
    g.scene.located = g.located;
}

static void add_body(vm_scene_body body) { g.bodies[g.scene.n_bodies++] = body; }
static void add_effect(vm_effect effect) { g.effects[g.scene.n_effects++] = effect; }
static void add_event(vm_event event) { g.events[g.scene.n_events++] = event; }

static void fold_book(const vm_budget *b)
{
    fold3(b->impulse);
    fold3(b->angular_impulse);
    fold3(b->brought);
    fold3(b->brought_angular);
    fold(b->work);
    fold(b->brought_energy);
    fold(b->mixing);
    fold3(b->momentum);
    fold3(b->angular_momentum);
    fold(b->energy);
    fold(b->jump_energy);
    fold3(b->momentum_defect);
    fold3(b->angular_defect);
    fold(b->energy_defect);
}

static void run_scene(vm_real t_end)
{
    vm_scene *scene = &g.scene;
    vm_scene_fault culprit;
    vm_budget book;
    vm_body now;
    vm_real t = 0;
    int i, size = vm_scene_size(scene);
    culprit.index = 99;
    CLEAR(book);
    fold_int(size);
    fold_int(vm_scene_check(scene, &culprit));
    fold_int(culprit.index);
    fold_int(vm_scene_start(scene, 0, g.y, &culprit));
    fold_all(size, g.y);
    fold_int(vm_scene_rhs(0, g.y, g.work, scene));
    fold_all(size, g.work);
    fold_int(vm_scene_run(scene, &t, t_end / 2, g.y, g.work, NULL));
    fold(t);
    fold_all(size, g.y);
    fold_int(vm_scene_run(scene, &t, t_end, g.y, g.work, NULL));
    fold(t);
    fold_all(size, g.y);
    for (i = 0; i < scene->n_bodies; i++) {
        vm_scene_body_at(scene, i, g.y, &now);
        fold_body(&now);
    }
    for (i = 0; i < scene->n_events; i++) {
        fold_int(g.events[i].count);
        fold(g.events[i].time);
    }
    if (!scene->budget) return;
    fold_int(vm_scene_budget_at(scene, t, g.y, &book));
    fold_book(&book);
}

/* ---- on a line ---- */

static vm_real bristles(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    return -*(const vm_real *)ctx * v / (1 + x * x);
}

static vm_real late(vm_real t, const vm_real *y, void *ctx)
{
    (void)ctx;
    return t + y[0] / 8 - 1;
}

static int kicked(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[1] += VM_C(0.5);
    return VM_OK;
}

static int recorded(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    (void)scene;
    (void)ctx;
    fold(t);
    fold(y[0]);
    return 0;
}

/* A body sheds mass on a spring and kicks itself off, another is driven, a third one falls and is stopped. */
static void try_scene_on_a_line(void)
{
    static const vm_real times[3] = {VM_C(0.5), 1, VM_C(1.75)};
    const vm_law leak = vm_law_linear(2, VM_C(-0.125));
    vm_real friction = VM_C(0.25);
    vm_budget book;
    clear_scene();
    add_body(vm_scene_body_line(2, 1, 0));
    add_body(vm_scene_body_with_mass_state(vm_scene_body_line(1, 0, 1)));
    add_body(vm_scene_body_line(3, -1, 0));
    add_effect(vm_effect_mass_of_time(0, &leak, vmi_vec3(0, 0, 0), 0));
    add_effect(vm_effect_spring(0, 0, VM_GROUND, 0, 3, VM_C(1.5), 0));
    add_effect(vm_effect_force(0, 0, bristles, &friction));
    add_effect(vm_effect_stream(1, VM_C(0.25), vmi_vec3(VM_C(0.5), 0, 0), 1));
    add_effect(vm_effect_harmonic(1, 0, 1, 2, VM_C(0.5)));
    add_effect(vm_effect_force_between(1, 0, 2, 0, bristles, &friction));
    add_effect(vm_effect_gravity(2, 0, -1));
    add_effect(vm_effect_linear_spring(2, 0, 0, 0, 4, VM_C(0.5)));
    add_event(vm_then_user(vm_event_user(late, NULL, 1), kicked, NULL));
    add_event(vm_then_switch(vm_event_mass(1, VM_C(1.25), 1), 4, 1));
    add_event(vm_then_switch(vm_event_position(0, 0, 0, -1), 6, 1));
    add_event(vm_then_stop(vm_event_at(VM_C(2.75))));
    vm_scene_keep_budget(&g.scene, &book);
    g.scene.output = recorded;
    g.scene.times = times;
    g.scene.n_times = 3;
    run_scene(3);
}

/* A part separates on a line at a speed, and is caught again. */
static void try_scene_of_parts_on_a_line(void)
{
    vm_body part;
    clear_scene();
    memset(&part, 0, sizeof part);
    part.mass = VM_C(0.5);
    part.v.x = 1;
    add_body(vm_scene_body_line(2, 1, 0));
    add_body(vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    add_effect(vm_effect_mass(0, VM_MASS_OF_X, VM_C(0.125), 1, 1));
    add_effect(vm_effect_van_der_pol(0, 0, 1, 1));
    add_effect(vm_effect_spring(0, 0, VM_GROUND, 0, 2, 3, 0));
    add_effect(vm_effect_damper(1, 0, 0, 0, 1));
    add_event(vm_then_separate_on_line(vm_event_velocity(0, 0, VM_C(-0.5), -1), 0, 1, &part, 1));
    g.events[0].most = 1;
    add_event(vm_then_attach_on_line(vm_event_at(2), 0, 1));
    run_scene(4);
}

/* When a body has come so far, it throws off a part and loses two springs, by one event. */
static void try_list_of_actions(void)
{
    const vm_event now = vm_event_position(0, 0, VM_C(0.5), 1);
    vm_event actions[2];
    vm_body part;
    clear_scene();
    memset(&part, 0, sizeof part);
    part.mass = VM_C(0.5);
    part.v.x = -1;
    add_body(vm_scene_body_line(2, 0, 1));
    add_body(vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    add_effect(vm_effect_damper(0, 0, VM_GROUND, 0, VM_C(0.125)));
    add_effect(vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1, VM_C(0.25)));
    add_effect(vm_effect_linear_spring(0, 0, VM_GROUND, 0, 2, VM_C(-0.25)));
    actions[0] = vm_then_switch_range(now, 1, 2, 1);
    actions[1] = vm_then_separate_on_line(now, 0, 1, &part, 1);
    add_event(vm_then_all(now, actions, 2));
    run_scene(3);
}

/* ---- on axles ---- */

static vm_mass_law_values swelling(vm_real t, vm_real x, vm_real v, void *ctx)
{
    vm_mass_law_values now;
    (void)ctx;
    now.mass = 2 + t / 8 + x / 64 + v * v / 128;
    now.by_t = VM_C(0.125);
    now.by_x = VM_C(0.015625);
    now.by_v = v / 64;
    return now;
}

/* A band is wound up, an inertia follows a law of the user's, another one the speed. */
static void try_scene_of_axles(void)
{
    static const vm_band band = {VM_C(0.25), VM_C(0.015625), VM_C(0.5), 64, 1, VM_C(0.75), 0};
    static const vm_band layers = {VM_C(0.25), VM_C(0.015625), VM_C(0.5), 64, 1, 0, 1};
    const vm_vec3 u = {VM_C(0.5), 0, 0};
    vm_budget book;
    int i;
    for (i = 0; i < 16; i++) {
        const vm_band_now now = vm_band_at(uniform(0, 50), i % 2 ? &band : &layers);
        fold(now.radius);
        fold(now.rate);
        fold(now.mass);
        fold(now.inertia);
    }
    clear_scene();
    add_body(vm_scene_body_axle(1, 0, 2));
    add_body(vm_scene_body_axle(2, 0, 1));
    add_body(vm_scene_body_axle(1, VM_C(0.5), 3));
    add_effect(vm_effect_band(0, &band));
    add_effect(vm_effect_motor(0, 0, 2, VM_C(0.25)));
    add_effect(vm_effect_mass_law(1, swelling, NULL, u, VM_C(0.5)));
    add_effect(vm_effect_rotational_damper(1, VM_C(0.125)));
    add_effect(vm_effect_mass(2, VM_MASS_OF_V2, VM_C(0.0625), 1, VM_C(0.75)));
    add_effect(vm_effect_linear_spring(2, 0, 1, 0, 2, 0));
    vm_scene_keep_budget(&g.scene, &book);
    run_scene(2);
}

/* ---- in the plane ---- */

/* The crossing point moves and the stream swells. */
static void varying(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)ctx;
    stream->at.x += t / 8;
    stream->rate += t / 32;
    stream->velocity.y = y[3];
}

/* A plate grows by a stream whose crossing point moves; another one turns on a shaft with an unbalance. */
static void try_scene_in_the_plane(void)
{
    const vm_vec3 at = {1, VM_C(0.25), 0}, still = {0, 0, 0};
    vm_budget book;
    vm_stream stream;
    clear_scene();
    draw_streams(1, &stream);
    stream.at.z = 0;
    stream.velocity.z = 0;
    stream.motion = VM_ABSOLUTE;
    add_body(vm_scene_body_growing_plane(vm_scene_body_plane(2, 1, still, VM_C(0.5), at, 1)));
    add_body(vm_scene_body_plane(1, VM_C(0.5), at, 0, still, 2));
    add_effect(vm_effect_varying(vm_effect_stream_mass(0, &stream), varying, NULL));
    add_effect(vm_effect_varying(vm_effect_stream_force(0, &stream), varying, NULL));
    add_effect(vm_effect_varying(vm_effect_stream_moment(0, &stream), varying, NULL));
    add_effect(vm_effect_varying(vm_effect_stream_torque(0, &stream), varying, NULL));
    add_effect(vm_effect_shaft(1, 3, VM_C(2.5)));
    add_effect(vm_effect_unbalance(1, VM_C(0.25), 3, VM_C(0.5)));
    add_effect(vm_effect_gyroscopic(1, VM_C(0.125)));
    vm_scene_keep_budget(&g.scene, &book);
    run_scene(2);
}

/* A plate loses a part, takes it up again and swings on a point that moves. */
static void moving_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)ctx;
    memset(r, 0, sizeof *r);
    memset(v, 0, sizeof *v);
    memset(a, 0, sizeof *a);
    r->y = 1 + t * t / 16;
    v->y = t / 8;
    a->y = VM_C(0.125);
}

static void try_scene_of_parts_in_the_plane(void)
{
    const vm_vec3 still = {0, 0, 0}, v = {1, 0, 0};
    vm_body part;
    clear_scene();
    memset(&part, 0, sizeof part);
    part.mass = VM_C(0.25);
    part.inertia.xx = part.inertia.yy = VM_C(0.0625);
    part.inertia.zz = VM_C(0.125);
    part.r.x = VM_C(0.125);
    part.v.y = 2;
    part.omega.z = 1;
    add_body(vm_scene_body_plane(2, 1, still, VM_C(0.5), v, 1));
    add_body(vm_scene_body_absent(vm_scene_body_plane(1, 1, still, 0, still, 0)));
    add_effect(vm_effect_gravity(0, 1, -2));
    add_effect(vm_effect_link(0, VM_GROUND, moving_point, NULL, 1, 0, 4));
    add_event(vm_then_separate_in_plane(vm_event_at(VM_C(0.5)), 0, 1, &part, 1));
    add_event(vm_then_attach_in_plane(vm_event_at(VM_C(1.25)), 0, 1));
    run_scene(2);
}

/* ---- in space ---- */

static vm_body some_free_body(void)
{
    vm_body b = some_body();
    b.q.w = 0;
    b.q.x = b.q.y = b.q.z = 0; /* the identity */
    return b;
}

/* A free body loses or gains mass by a stream at a point, and its rotation is damped. */
static void try_scene_in_space(void)
{
    const vm_body body = some_free_body();
    vm_stream stream;
    vm_budget book;
    clear_scene();
    draw_streams(1, &stream);
    add_body(vm_scene_body_growing_free(vm_scene_body_free(&body)));
    add_effect(vm_effect_stream_mass(0, &stream));
    add_effect(vm_effect_stream_force(0, &stream));
    add_effect(vm_effect_stream_moment(0, &stream));
    add_effect(vm_effect_stream_torque(0, &stream));
    add_effect(vm_effect_rotational_damper(0, VM_C(0.25)));
    vm_scene_keep_budget(&g.scene, &book);
    run_scene(1);
}

static void pulled(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)scene;
    effect->load->force[1] += *(const vm_real *)effect->ctx * t - y[effect->x] / 4;
}

/* A free body throws off a part; points hang on a cord. */
static void try_scene_of_parts_in_space(void)
{
    const vm_body body = some_free_body();
    const vm_vec3 at = {1, 0, 0}, v = {0, 1, VM_C(0.5)};
    vm_real pull = VM_C(0.5);
    vm_body part = some_part(&body);
    clear_scene();
    part.r = vmi_vec3(VM_C(0.25), 0, 0);
    add_body(vm_scene_body_free(&body));
    add_body(vm_scene_body_absent(vm_scene_body_free(&body)));
    add_body(vm_scene_body_point(1, at, v));
    add_effect(vm_effect_gravity(0, 2, -2));
    add_effect(vm_effect_custom(0, VM_GROUND, pulled, &pull));
    add_effect(vm_effect_gravity(2, 2, -2));
    add_effect(vm_effect_link(2, 0, NULL, NULL, VM_C(1.5), 1, 4));
    add_event(vm_then_separate(vm_event_at(VM_C(0.25)), 0, 1, &part, 1));
    g.events[0].external.linear.x = VM_C(0.5);
    add_event(vm_then_attach(vm_event_at(VM_C(0.75)), 0, 1));
    run_scene(1);
}

/* ---- points of bodies ---- */

/* A pin, a rod and a spring hold a body in the plane, a point and a free body; a body falls on the ground. */
static void try_scene_of_joints(void)
{
    static const vm_point_spring spring = {{VM_C(0.25), 0, 0}, {0, 0, 1}, 8, 1, VM_C(0.5)};
    static const vm_contact ground = {{0, 0, 0}, 0, {0, VM_C(-1.5), 0}, {0, 2, 0}, 1000, 4};
    const vm_vec3 zero = {0, 0, 0}, v = {0, 1, VM_C(0.5)}, at = {1, 0, 0}, end = {-1, 0, 0};
    vm_body body = some_free_body();
    vm_real room[VM_JOINTS_WORK(2)];
    vm_joint list[2];
    vm_joints joints;
    vm_vec3 r, u;
    clear_scene();
    list[0] = vm_joint_pin(0, end, VM_GROUND, zero);
    list[1] = vm_joint_rod(1, zero, 0, zero, 1);
    joints.joints = list;
    joints.n_joints = 2;
    joints.rate = 8;
    joints.work = room;
    joints.work_size = VM_LENGTH(room);
    add_body(vm_scene_body_plane(2, 1, at, 0, zero, 0));
    add_body(vm_scene_body_point(1, vmi_vec3(2, 0, 0), v));
    add_body(vm_scene_body_free(&body));
    add_effect(vm_effect_gravity(0, 1, -2));
    add_effect(vm_effect_point_spring(2, VM_GROUND, &spring));
    add_effect(vm_effect_contact(0, &ground));
    add_effect(vm_effect_joints(&joints));
    run_scene(1);
    vm_scene_point_at(&g.scene, 2, at, g.y, &r, &u);
    fold3(r);
    fold3(u);
    vm_scene_push_at(&g.scene, 2, at, g.y, u);
    fold3(vmi_get3(g.bodies[2].load.force + 3));
    fold3(list[0].force);
    clear_scene();
    add_body(vm_scene_body_plane(2, 1, at, 0, zero, VM_C(0.25)));
    add_effect(vm_effect_gravity(0, 1, -8));
    add_effect(vm_effect_contact(0, &ground));
    add_event(vm_then_land(vm_event_contact(0, &ground)));
    run_scene(2);
}

/* ---- refused ---- */

static void try_refused_scenes(void)
{
    clear_scene();
    add_body(vm_scene_body_line(1, 0, 0));
    add_effect(vm_effect_linear_spring(0, 1, VM_GROUND, 0, 1, 0));
    {
        vm_scene_fault culprit;
        fold_int(vm_scene_start(&g.scene, 0, g.y, &culprit));
        fold_text(culprit.kind);
        fold_int(culprit.index);
        fold(g.y[0]);
    }
    g.effects[0] = vm_effect_stream(0, 1, vmi_vec3(0, 0, 0), 1);
    fold_int(vm_scene_check(&g.scene, NULL));
    g.effects[0] = vm_effect_motor(0, 0, 1, 1);
    add_event(vm_then_switch(vm_event_at(1), 7, 1));
    fold_int(vm_scene_check(&g.scene, NULL));
}

static void golden_scenes_on_a_line(void)
{
    try_forces();
    try_scene_on_a_line();
    try_scene_of_parts_on_a_line();
    try_scene_of_axles();
    try_refused_scenes();
    try_list_of_actions();
}
static void golden_scenes_in_the_plane(void)
{
    try_scene_in_the_plane();
    try_scene_of_parts_in_the_plane();
}

static void golden_scenes_in_space(void)
{
    try_scene_in_space();
    try_scene_of_parts_in_space();
    try_scene_of_joints();
}
