/* For Frama-C's EVA (tests/eva_varmass.c): scenes of two bodies with one effect or one event. A scene is started, and its
   right-hand side computed, but it is not run. */

void eva_forces(void)
{
    vm_real x = any, y = any;
    sink[0] = vm_force_spring(any, any, any) + vm_force_van_der_pol(any, any, any, any) + vm_force_motor(any, any, any);
    sink[1] = vm_force_harmonic(any, any, any, any) + vm_force_stream(any, any, any, any);
    vm_force_shaft(any, any, any, any, &x, &y);
    sink[2] = x + y;
    vm_force_unbalance(any, any, any, any, &x, &y);
    sink[3] = x + y;
    vm_force_gyroscopic(any, any, any, &x, &y);
    sink[4] = x + y;
}

/* a scene of two bodies, not yet started */
static vm_scene two_bodies(vm_scene_body *bodies, vm_effect *effects, int n_effects)
{
    vm_scene s;
    memset(&s, 0, sizeof s);
    s.bodies = bodies;
    s.n_bodies = 2;
    s.effects = effects;
    s.n_effects = n_effects;
    return s;
}

void eva_scene(void)
{
    vm_scene s;
    vm_scene_body bodies[2];
    vm_effect effects[2];
    vm_real y[32], rates[32];
    bodies[0] = vm_scene_body_line(any, any, any);
    bodies[1] = vm_scene_body_plane(any, any, any_vector(), any, any_vector(), any);
    effects[0] = vm_effect_gravity(0, 0, any);
    effects[1] = vm_effect_spring(0, 0, 1, 0, any, any, any);
    s = two_bodies(bodies, effects, 2);
    if (vm_scene_start(&s, any, y, NULL) < 0) return;
    if (vm_scene_rhs(any, y, rates, &s) >= 0) sink[0] = rates[0];
}

vm_contact any_contact(void)
{
    vm_contact c;
    c.at = any_vector();
    c.radius = any;
    c.on = any_vector();
    c.normal = any_vector();
    c.stiffness = any;
    c.damping = any;
    return c;
}

static vm_real user_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    sink[0] = t + x + v;
    return any;
}

static vm_mass_law_values user_mass(vm_real t, vm_real x, vm_real v, void *ctx)
{
    vm_mass_law_values m;
    (void)ctx;
    sink[0] = t + x + v;
    m.mass = any;
    m.by_t = any;
    m.by_x = any;
    m.by_v = any;
    return m;
}

static void user_apply(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene)
{
    sink[0] = t + y[0] + (vm_real)effect->body;
    vm_scene_push_at(scene, 0, any_vector(), y, any_vector());
}

static void user_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    *r = any_vector();
    *v = any_vector();
    *a = any_vector();
}

static void user_vary(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)ctx;
    sink[0] = t + y[0];
    *stream = any_stream();
}

/* a scene of two bodies with one effect */
void scene_of(vm_scene_body first, vm_scene_body second, vm_effect effect)
{
    vm_scene s;
    vm_scene_body bodies[2];
    vm_real y[64], rates[64];
    vm_body now = any_body();
    int i;
    for (i = 0; i < 64; i++) y[i] = rates[i] = any;
    bodies[0] = first;
    bodies[1] = second;
    s = two_bodies(bodies, &effect, 1);
    if (vm_scene_start(&s, any, y, NULL) < 0) return;
    if (vm_scene_rhs(any, y, rates, &s) >= 0) sink[0] = rates[0];
    vm_scene_body_at(&s, 0, y, &now);
    sink[1] = now.mass;
}

#define LINE vm_scene_body_line(any, any, any)
#define AXLE vm_scene_body_axle(any, any, any)
#define PLANE vm_scene_body_plane(any, any, any_vector(), any, any_vector(), any)
#define POINT vm_scene_body_point(any, any_vector(), any_vector())
#define STATE(body) vm_scene_body_with_mass_state(body)
#define GROWING vm_scene_body_growing_plane(vm_scene_body_with_mass_state(PLANE))
vm_scene_body free_body(void)
{
    const vm_body b = any_body();
    return vm_scene_body_free(&b);
}
#define FREE free_body()
#define GROWING_FREE vm_scene_body_growing_free(vm_scene_body_with_mass_state(free_body()))

#define SCENE(name, first, second, effect) \
    void eva_scene_##name(void) { scene_of(first, second, effect); }

SCENE(damper, LINE, PLANE, vm_effect_damper(0, 0, 1, 0, any))
SCENE(force, LINE, LINE, vm_effect_force(0, 0, user_force, NULL))
SCENE(force_between, LINE, LINE, vm_effect_force_between(0, 0, 1, 0, user_force, NULL))
SCENE(gravitation, POINT, POINT, vm_effect_gravitation(0, 1, any))
SCENE(central_gravity, POINT, FREE, vm_effect_central_gravity(0, any_vector(), any))
SCENE(gyroscopic, PLANE, LINE, vm_effect_gyroscopic(0, any))
SCENE(harmonic, LINE, LINE, vm_effect_harmonic(0, 0, any, any, any))
SCENE(linear_spring, LINE, LINE, vm_effect_linear_spring(0, 0, 1, 0, any, any))
SCENE(mass_of_t, LINE, LINE, vm_effect_mass(0, VM_MASS_OF_T, any, any, any))
SCENE(mass_of_x, LINE, LINE, vm_effect_mass(0, VM_MASS_OF_X, any, any, any))
SCENE(mass_of_v2, LINE, LINE, vm_effect_mass(0, VM_MASS_OF_V2, any, any, any))
SCENE(mass_law, LINE, LINE, vm_effect_mass_law(0, user_mass, NULL, any_vector(), any))
SCENE(motor, AXLE, LINE, vm_effect_motor(0, 0, any, any))
SCENE(rotational_damper, AXLE, LINE, vm_effect_rotational_damper(0, any))
SCENE(shaft, PLANE, LINE, vm_effect_shaft(0, any, any))
SCENE(stream, STATE(POINT), LINE, vm_effect_stream(0, any, any_vector(), any))
SCENE(unbalance, PLANE, LINE, vm_effect_unbalance(0, any, any, any))
SCENE(van_der_pol, LINE, LINE, vm_effect_van_der_pol(0, 0, any, any))
SCENE(custom, LINE, LINE, vm_effect_custom(0, 1, user_apply, NULL))
SCENE(link, POINT, POINT, vm_effect_link(0, VM_GROUND, user_point, NULL, any, any_int, any))
SCENE(link_of_bodies, POINT, FREE, vm_effect_link(0, 1, NULL, NULL, any, any_int, any))

void eva_scene_band(void)
{
    const vm_band b = any_band();
    scene_of(AXLE, LINE, vm_effect_band(0, &b));
}

void eva_scene_contact(void)
{
    const vm_contact c = any_contact();
    scene_of(any_int ? PLANE : FREE, LINE, vm_effect_contact(0, &c));
}

void eva_scene_mass_of_time(void)
{
    const vm_law law = any_law();
    scene_of(LINE, LINE, vm_effect_mass_of_time(0, &law, any_vector(), any));
}

void eva_scene_point_spring(void)
{
    vm_point_spring s;
    s.at = any_vector();
    s.other_at = any_vector();
    s.stiffness = any;
    s.damping = any;
    s.rest = any;
    scene_of(PLANE, FREE, vm_effect_point_spring(0, 1, &s));
}

#define STREAM(name, body, effect)       \
    void eva_scene_##name(void)          \
    {                                    \
        const vm_stream s = any_stream(); \
        scene_of(body, LINE, effect);    \
    }
STREAM(stream_force, GROWING_FREE, vm_effect_stream_force(0, &s))
STREAM(stream_mass, GROWING_FREE, vm_effect_stream_mass(0, &s))
STREAM(stream_moment, GROWING_FREE, vm_effect_stream_moment(0, &s))
STREAM(stream_torque, GROWING_FREE, vm_effect_stream_torque(0, &s))
STREAM(growing_plane, GROWING, vm_effect_stream_force(0, &s))
STREAM(varying, GROWING_FREE, vm_effect_varying(vm_effect_stream_force(0, &s), user_vary, NULL))

void eva_scene_joints(void)
{
    vm_joint joint[1];
    vm_real work[VM_JOINTS_WORK(1)];
    vm_joints joints;
    memset(&joints, 0, sizeof joints);
    joint[0] = any_int ? vm_joint_pin(0, any_vector(), 1, any_vector()) :
                         vm_joint_rod(0, any_vector(), VM_GROUND, any_vector(), any);
    joints.joints = joint;
    joints.n_joints = 1;
    joints.rate = any;
    joints.work = work;
    scene_of(PLANE, FREE, vm_effect_joints(&joints));
}

void eva_scene_budget(void)
{
    vm_scene s;
    vm_scene_body bodies[2];
    vm_effect effect = vm_effect_spring(0, 0, 1, 0, any, any, any);
    vm_budget budget;
    vm_real y[128], rates[128];
    vm_vec3 r = any_vector(), v = any_vector();
    int i;
    for (i = 0; i < 128; i++) y[i] = rates[i] = any;
    memset(&s, 0, sizeof s);
    memset(&budget, 0, sizeof budget);
    bodies[0] = LINE;
    bodies[1] = FREE;
    s.bodies = bodies;
    s.n_bodies = 2;
    s.effects = &effect;
    s.n_effects = 1;
    vm_scene_keep_budget(&s, &budget);
    if (vm_scene_check(&s, NULL) < 0) return;
    sink[0] = (vm_real)vm_scene_size(&s);
    if (vm_scene_start(&s, any, y, NULL) < 0) return;
    if (vm_scene_rhs(any, y, rates, &s) >= 0) sink[1] = rates[0];
    if (vm_scene_budget_at(&s, any, y, &budget) >= 0) sink[2] = budget.energy;
    vm_scene_point_at(&s, 1, any_vector(), y, &r, &v);
    sink[3] = r.x + v.x;
}

static vm_real user_when(vm_real t, const vm_real *y, void *ctx)
{
    (void)ctx;
    sink[0] = t + y[0];
    return any;
}

static int user_then(vm_real t, vm_real *y, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    y[0] = any;
    return any_int;
}

/* the start of a scene of two bodies with a spring and one event */
void event_of(vm_scene_body first, vm_scene_body second, vm_event event)
{
    vm_scene s;
    vm_scene_body bodies[2];
    vm_effect effect = vm_effect_spring(0, 0, VM_GROUND, 0, any, any, any);
    ode_event located[1];
    vm_real y[64];
    int i;
    for (i = 0; i < 64; i++) y[i] = any;
    memset(located, 0, sizeof located);
    bodies[0] = first;
    bodies[1] = second;
    s = two_bodies(bodies, &effect, 1);
    s.events = &event;
    s.located = located;
    s.n_events = 1;
    if (vm_scene_start(&s, any, y, NULL) >= 0) sink[0] = y[0];
}

#define EVENT(name, first, second, event) \
    void eva_event_##name(void) { event_of(first, second, event); }
EVENT(stop, LINE, LINE, vm_then_stop(vm_event_at(any)))
EVENT(position, LINE, LINE, vm_then_stop(vm_event_position(0, 0, any, any_int)))
EVENT(velocity, LINE, LINE, vm_then_switch(vm_event_velocity(0, 0, any, any_int), 0, any_int))
EVENT(mass, LINE, LINE, vm_then_switch_range(vm_event_mass(0, any, any_int), 0, 1, any_int))
EVENT(user, LINE, LINE, vm_then_user(vm_event_user(user_when, NULL, any_int), user_then, NULL))
EVENT(attach, FREE, FREE, vm_then_attach(vm_event_at(any), 0, 1))
EVENT(attach_in_plane, PLANE, PLANE, vm_then_attach_in_plane(vm_event_at(any), 0, 1))
EVENT(attach_on_line, LINE, LINE, vm_then_attach_on_line(vm_event_at(any), 0, 1))
#define PART(name, first, second, event) \
    void eva_event_##name(void)            \
    {                                    \
        const vm_body part = any_body(); \
        event_of(first, vm_scene_body_absent(second), event); \
    }
PART(separate, FREE, FREE, vm_then_separate(vm_event_at(any), 0, 1, &part, any_int))
PART(separate_in_plane, PLANE, PLANE, vm_then_separate_in_plane(vm_event_at(any), 0, 1, &part, any_int))
PART(separate_on_line, LINE, LINE, vm_then_separate_on_line(vm_event_at(any), 0, 1, &part, any_int))
void eva_event_land(void)
{
    const vm_contact c = any_contact();
    event_of(PLANE, LINE, vm_then_land(vm_event_contact(0, &c)));
}