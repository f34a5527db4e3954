/* Fuzz target: varmass.h, scenes of drawn bodies, effects and events: the check names a culprit or the run goes; what
   came in balances with what is there; a run ends, where it is told to or with a status. */
#include "bodies.h"

enum { BODIES = 4, EFFECTS = 6, EVENTS = 3, STATE = (13 + 10) * BODIES + VM_BUDGET_STATES };

static vm_real push(vm_real t, vm_real x, vm_real v, void *ctx) { return *(const vm_real *)ctx * (1 + t) - x - v; }

static void callback(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)t;
    (void)y;
    scene->bodies[effect->body].load.force[0] += *(const vm_real *)effect->ctx;
}

static vm_mass_law_values mass_law(vm_real t, vm_real x, vm_real v, void *ctx)
{
    vm_mass_law_values now;
    (void)x;
    (void)v;
    now.mass = 2 + *(const vm_real *)ctx * t;
    now.by_t = *(const vm_real *)ctx;
    now.by_x = now.by_v = 0;
    return now;
}

static void moving_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const vm_real w = *(const vm_real *)ctx;
    memset(r, 0, sizeof *r);
    memset(v, 0, sizeof *v);
    memset(a, 0, sizeof *a);
    r->y = 5 + VM_C(0.1) * t * w;
    v->y = VM_C(0.1) * w;
}

static vm_real user_when(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    return t - *(const vm_real *)ctx;
}

static int user_then(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    (void)y;
    return VM_OK;
}

static vm_real push_between(vm_real t, vm_real x, vm_real v, void *ctx)
{
    return *(const vm_real *)ctx * VM_LIBM(cos)(t) - x * x * x - v;
}

/* The point of contact moves; the stream swells and fades. */
static void vary(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)y;
    stream->at.x += R(0.1) * VM_LIBM(sin)(3 * t);
    stream->rate *= 1 + *(const vm_real *)ctx * VM_LIBM(cos)(5 * t);
    stream->velocity.y += *(const vm_real *)ctx * t;
}

/* An index below n, or sometimes any */
static int draw_index(int n)
{
    if (draw_byte() % 32 == 0) return (int)draw_byte() - 128;
    return draw_below(n + 1) % (n ? n : 1);
}

/* Mostly the first coordinate, sometimes another one, or any number */
static int draw_coordinate(void)
{
    if (draw_byte() % 16 == 0) return (int)draw_byte() - 128;
    return draw_byte() % 4 ? 0 : draw_below(3);
}

static vm_scene_body draw_scene_body(void)
{
    const vm_real mass = MOSTLY(draw_log(0.1, 10)), a = draw_in(-2, 2), b = MOSTLY(draw_in(-2, 2)),
                  inertia = MOSTLY(draw_log(0.1, 2));
    const vm_vec3 r = draw_vector(3), v = draw_vector(2);
    vm_scene_body made;
    vm_body free_body;
    switch (draw_below(6)) {
    case 0: made = vm_scene_body_axle(mass, a, b); break;
    case 1: made = vm_scene_body_plane(mass, inertia, r, a, v, b); break;
    case 2: made = vm_scene_body_point(mass, r, v); break;
    case 3:
        free_body = draw_body(1);
        made = vm_scene_body_free(&free_body);
        break;
    default: made = vm_scene_body_line(mass, a, b);
    }
    switch (draw_byte() % 8) { /* of what does not fit a body the check says so */
    case 0:
    case 1: made = vm_scene_body_with_mass_state(made); break;
    case 2:
    case 3:
    case 4:
        if (made.motion == VM_PLANE) made = vm_scene_body_growing_plane(made);
        if (made.motion == VM_FREE) made = vm_scene_body_growing_free(made);
        break;
    case 5: made = draw_byte() & 1 ? vm_scene_body_growing_plane(made) : vm_scene_body_growing_free(made); break;
    default: break;
    }
    if (draw_byte() % 8 == 0) made = vm_scene_body_absent(made);
    return made;
}

static vm_stream draw_stream(void)
{
    vm_stream stream;
    memset(&stream, 0, sizeof stream);
    stream.rate = MOSTLY(draw_in(-0.1, 0.3));
    stream.motion = draw_byte() % 32 ? draw_below(4) : draw_below(8) - 2;
    stream.at = draw_vector(1);
    stream.velocity = draw_vector(2);
    stream.spin = draw_vector(1);
    if (draw_byte() & 1) stream.gyration = draw_inertia(1, 0.2);
    return stream;
}

static vm_band draw_band(void)
{
    vm_band band;
    band.radius = MOSTLY(draw_log(0.05, 1));
    band.thickness = MOSTLY(draw_log(1e-4, 1e-2));
    band.width = MOSTLY(draw_in(0, 1));
    band.density = MOSTLY(draw_log(10, 1e4));
    band.speed = MOSTLY(draw_in(-2, 2));
    band.reactive = 1 - draw_in(0, 1);
    band.by_layer = draw_byte() & 1;
    return band;
}

/* Bare below 0; radius, mass and inertia grow with the angle; what is wound up lies between the drum and the
   radius */
static void check_band(void)
{
    const vm_band band = draw_band();
    const vm_real phi = MOSTLY(draw_in(-10, 500)), more = phi + draw_in(0, 10);
    const vm_band_now a = vm_band_at(phi, &band), b = vm_band_at(more, &band);
    if (!(band.radius > 0 && band.thickness >= 0 && band.width >= 0 && band.density >= 0) || !is_finite(phi)) {
        HOLDS(is_nan(a.radius) && is_nan(a.mass) && is_nan(a.inertia) && is_nan(a.rate));
        return;
    }
    if (phi < 0)
        HOLDS((a.radius == band.radius || is_nan(a.radius)) && a.rate == 0 && a.mass == 0 && a.inertia == 0);
    if (fuzz.wild) return;
    HOLDS(a.radius >= band.radius && a.mass >= 0 && a.inertia >= 0 && a.rate >= 0);
    HOLDS(b.radius >= a.radius && b.mass >= a.mass * (1 - 8 * VM_EPSILON) &&
          b.inertia >= a.inertia * (1 - 16 * VM_EPSILON));
    { /* what comes lies between the two radii */
        const double mass = (double)b.mass - (double)a.mass, inertia = (double)b.inertia - (double)a.inertia;
        const double inner = (double)a.radius * (double)a.radius, outer = (double)b.radius * (double)b.radius;
        HOLDS(inertia >= mass * inner - 32 * EPS * (double)b.inertia &&
              inertia <= mass * outer + 32 * EPS * (double)b.inertia);
    }
    HOLDS((double)a.inertia >= (double)a.mass * (double)band.radius * (double)band.radius * (1 - 16 * EPS));
    HOLDS((double)a.inertia <= (double)a.mass * (double)a.radius * (double)a.radius * (1 + 16 * EPS));
}

/* The effects point at what they are given: each has a place of its own for as long as the scene */
typedef struct effect_data {
    vm_real ctx;
    vm_stream stream;
    vm_band band;
    vm_law law;
    vm_point_spring spring;
    vm_contact contact;
    vm_joint list[2];
    vm_joints joints;
    vm_real room[VM_JOINTS_WORK(2)];
} effect_data;

static vm_point_spring draw_point_spring(void)
{
    vm_point_spring spring;
    spring.at = draw_vector(1);
    spring.other_at = draw_vector(2);
    spring.stiffness = MOSTLY(draw_log(0.1, 100));
    spring.damping = MOSTLY(draw_log(0.1, 10));
    spring.rest = MOSTLY(draw_in(0, 2));
    return spring;
}

static vm_contact draw_contact(void)
{
    vm_contact contact;
    contact.at = draw_vector(1);
    contact.radius = MOSTLY(draw_in(0, 1));
    contact.on = draw_vector(5);
    contact.normal = draw_vector(1);
    contact.stiffness = MOSTLY(draw_log(1, 1000));
    contact.damping = MOSTLY(draw_log(0.1, 10));
    return contact;
}

/* Joints rarely fit bodies that are drawn, except those between mass centres of bodies and rods of any length */
static vm_effect draw_joints(int n, int body, int other, effect_data *data)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_joints *joints = &data->joints;
    const vm_vec3 on_body = draw_vector(1), on_other = draw_vector(1);
    int first, second;
    data->list[0] = vm_joint_pin(body, on_body, other, on_other);
    if (draw_byte() & 1) data->list[0] = vm_joint_rod(body, zero, other, zero, MOSTLY(draw_log(0.1, 10)));
    first = draw_index(n);
    second = draw_index(n);
    data->list[1] = vm_joint_rod(first, zero, second, zero, MOSTLY(draw_log(0.1, 10)));
    joints->joints = draw_byte() % 32 ? data->list : NULL;
    joints->n_joints = draw_below(3);
    joints->rate = MOSTLY(draw_log(1, 20));
    joints->work = draw_byte() % 32 ? data->room : NULL;
    joints->work_size = draw_byte() % 16 ? VM_LENGTH(data->room) : (int)draw_byte() - 128;
    return vm_effect_joints(draw_byte() % 32 ? joints : NULL);
}

static vm_effect draw_crossing(int body, effect_data *data)
{
    const vm_stream *stream = draw_byte() % 64 ? &data->stream : NULL;
    vm_effect effect;
    data->stream = draw_stream();
    switch (draw_below(4)) {
    case 0: effect = vm_effect_stream_mass(body, stream); break;
    case 1: effect = vm_effect_stream_force(body, stream); break;
    case 2: effect = vm_effect_stream_moment(body, stream); break;
    default: effect = vm_effect_stream_torque(body, stream);
    }
    return draw_byte() & 1 ? effect : vm_effect_varying(effect, draw_byte() % 32 ? vary : NULL, &data->ctx);
}

static vm_effect draw_effect(int n, effect_data *data)
{
    const int body = draw_index(n), coordinate = draw_coordinate();
    const int other = draw_byte() & 1 ? VM_GROUND : draw_index(n), other_coordinate = draw_coordinate();
    const vm_real p = MOSTLY(draw_in(-2, 2)), positive = MOSTLY(draw_log(0.1, 10)),
                  alpha = draw_byte() & 1 ? R(1) : MOSTLY(draw_in(0, 5));
    const vm_vec3 u = draw_vector(1);
    vm_real *ctx = &data->ctx;
    int kind;
    *ctx = draw_in(-0.5, 0.5);
    switch (draw_below(28)) {
    case 24: data->spring = draw_point_spring(); return vm_effect_point_spring(body, other, &data->spring);
    case 25: data->contact = draw_contact(); return vm_effect_contact(body, &data->contact);
    case 26:
    case 27: return draw_joints(n, body, other, data);
    case 14: return vm_effect_linear_spring(body, coordinate, other, other_coordinate, positive, p);
    case 15: return vm_effect_rotational_damper(body, positive);
    case 16:
    case 17:
    case 18: return draw_crossing(body, data);
    case 19: data->band = draw_band(); return vm_effect_band(body, draw_byte() % 64 ? &data->band : NULL);
    case 20: return vm_effect_force_between(body, coordinate, other, other_coordinate, push_between, ctx);
    case 21: return vm_effect_varying(vm_effect_gravity(body, coordinate, p), vary, ctx); /* no stream: refused */
    case 22:
        data->law = vm_law_linear(positive, *ctx);
        return vm_effect_mass_of_time(body, &data->law, u, alpha);
    case 0: return vm_effect_gravity(body, coordinate, p);
    case 1: return vm_effect_damper(body, coordinate, other, other_coordinate, positive);
    case 2: return vm_effect_van_der_pol(body, coordinate, p, positive);
    case 3: return vm_effect_motor(body, coordinate, p, positive);
    case 4: return vm_effect_harmonic(body, coordinate, p, positive, alpha);
    case 5: return vm_effect_force(body, coordinate, push, ctx);
    case 6: return vm_effect_custom(body, other, callback, ctx);
    case 7: return vm_effect_shaft(body, positive, alpha);
    case 8: return vm_effect_unbalance(body, p, positive, alpha);
    case 9: return vm_effect_gyroscopic(body, p / 2);
    case 10: return vm_effect_link(body, other, moving_point, ctx, positive, draw_below(2), 10);
    case 11: return vm_effect_mass_law(body, mass_law, ctx, u, R(1 - draw_below(2)));
    case 12: kind = draw_below(3); return vm_effect_mass(body, kind, *ctx / 10, p, R(1 - draw_below(2)));
    case 13: return vm_effect_stream(body, *ctx / 5, u, R(1 - draw_below(2)));
    case 23: /* a share of the springs, so that stored inputs of other effects keep their meaning */
        if (coordinate == 1) return vm_effect_gravitation(body, other, p);
        if (coordinate == 2) return vm_effect_central_gravity(body, u, p);
        return vm_effect_spring(body, coordinate, other, other_coordinate, positive, alpha, p);
    default: return vm_effect_spring(body, coordinate, other, other_coordinate, positive, alpha, p);
    }
}

static vm_event draw_separation(vm_event event, int body, int into)
{
    const int relative = draw_byte() & 1;
    vm_body part = draw_body(0.1);
    part.mass = MOSTLY(draw_in(0.01, 0.3));
    part.inertia = draw_inertia(is_finite(part.mass) ? part.mass : 1, 0.1);
    if (draw_byte() & 1) event.external = draw_impulse();
    switch (draw_below(4)) {
    case 0: return vm_then_separate_on_line(event, body, into, &part, relative);
    case 1: return vm_then_separate_in_plane(event, body, into, &part, relative);
    default: return vm_then_separate(event, body, into, &part, relative);
    }
}

static vm_event draw_attachment(vm_event event, int body, int added)
{
    switch (draw_below(4)) {
    case 0: return vm_then_attach_on_line(event, body, added);
    case 1: return vm_then_attach_in_plane(event, body, added);
    default: return vm_then_attach(event, body, added);
    }
}

/* The same event with a list of two actions instead of one */
static vm_event draw_list(vm_event event, int n, int effects, vm_event *actions)
{
    const int body = draw_index(n);
    const int first = draw_index(effects), count = draw_below(4) - 1;
    actions[0] = vm_then_switch_range(event, first, count, draw_byte() & 1);
    actions[1] = draw_byte() & 1 ? draw_separation(event, body, draw_index(n)) : vm_then_stop(event);
    return vm_then_all(event, actions, 2);
}

static vm_event draw_event(int n, int effects, vm_real *ctx, vm_contact *contact, vm_event *actions)
{
    const int body = draw_index(n), coordinate = draw_coordinate(), direction = draw_below(3) - 1;
    const vm_real value = MOSTLY(draw_in(-2, 2)), time = MOSTLY(draw_in(0, 2));
    vm_event event;
    int effect;
    *ctx = draw_in(0, 2);
    *contact = draw_contact();
    switch (draw_below(7)) {
    case 5:
        event = vm_event_contact(body, contact);
        if (draw_byte() & 1) return vm_then_land(event);
        break;
    case 0: event = vm_event_position(body, coordinate, value, direction); break;
    case 1: event = vm_event_velocity(body, coordinate, value, direction); break;
    case 2: event = vm_event_mass(body, value, direction); break;
    case 3: event = vm_event_user(user_when, ctx, direction); break;
    default: event = vm_event_at(time);
    }
    switch (draw_below(6)) {
    case 0: effect = draw_index(effects); return vm_then_switch(event, effect, draw_byte() & 1);
    case 1: return draw_separation(event, body, draw_index(n));
    case 2: return draw_attachment(event, body, draw_index(n));
    case 3: return vm_then_user(event, user_then, NULL);
    case 4: return vm_then_stop(event);
    default:
        event.most = 3;
        if (draw_below(3) == 0) return draw_list(event, n, effects, actions);
        return vm_then_stop(event);
    }
}

static void check_forces(void)
{
    const vm_real k = MOSTLY(draw_in(0, 3)), alpha = MOSTLY(draw_in(0, 5)), x = MOSTLY(draw_in(-3, 3)),
                  v = MOSTLY(draw_in(-3, 3));
    vm_real fx, fy;
    if (!tame(k) || !tame(x) || !tame(v) || !tame(alpha) || alpha < 0 || alpha > 8 || k < 0) return;
    HOLDS(vm_force_spring(-x, k, alpha) == -vm_force_spring(x, k, alpha) &&
          (double)x * (double)vm_force_spring(x, k, alpha) <= 0);
    HOLDS(vm_force_damper(v, k) == -k * v && vm_force_van_der_pol(x, v, k, 0) == k * v &&
          vm_force_motor(v, k, 0) == k);
    if (VM_FABS(x) < 1000) HOLDS(VM_FABS(vm_force_harmonic(v, k, 2, x)) <= k);
    HOLDS(vm_force_stream(v, k, 0, 0) == 0 &&
          within(vm_force_stream(v, k, x, 1), k * (x - v), 4 * EPS * (double)(k * (VM_FABS(x) + VM_FABS(v)))));
    HOLDS(vm_force_gravity(k, -x) == -vm_force_gravity(k, x) && vm_force_gravity(k, 0) == 0);
    vm_force_shaft(x, v, k, alpha, &fx, &fy); /* towards the axis, k r^alpha in all */
    HOLDS((double)fx * (double)x + (double)fy * (double)v <= 0 &&
          fabs((double)fx * (double)v - (double)fy * (double)x) <=
              64 * EPS * fabs((double)fx * (double)v) + (double)VM_MIN);
    vm_force_shaft(x, v, k, 1, &fx, &fy);
    HOLDS(close_to(fx, -k * x, 8) && close_to(fy, -k * v, 8));
    vm_force_gyroscopic(x, v, k / 2, &fx, &fy); /* does no work */
    HOLDS(fabs((double)fx * (double)x + (double)fy * (double)v) <=
          8 * EPS * (double)k * fabs((double)x * (double)v));
    vm_force_unbalance(v, k, x, alpha, &fx, &fy);
    HOLDS(within(R(hypot((double)fx, (double)fy)), k * x * x, 8 * EPS * (double)(k * x * x)));
}

typedef struct drawn_scene {
    vm_scene scene;
    vm_scene_body bodies[BODIES];
    effect_data data[EFFECTS];
    vm_effect effects[EFFECTS];
    vm_event events[EVENTS];
    vm_contact contacts[EVENTS];
    vm_event actions[EVENTS][2];
    ode_event located[EVENTS];
    vm_budget book;
    vm_real ctx[EVENTS], y[STATE], dydt[STATE], work[VM_SCENE_WORK(STATE)];
} drawn_scene;

static void draw_scene(drawn_scene *d)
{
    vm_scene *scene = &d->scene;
    int i;
    memset(scene, 0, sizeof *scene);
    scene->n_bodies = 1 + draw_below(BODIES);
    scene->n_effects = draw_below(EFFECTS + 1);
    scene->n_events = draw_byte() & 1 ? draw_below(EVENTS + 1) : 0;
    for (i = 0; i < scene->n_bodies; i++) d->bodies[i] = draw_scene_body();
    for (i = 0; i < scene->n_effects; i++) d->effects[i] = draw_effect(scene->n_bodies, d->data + i);
    for (i = 0; i < scene->n_events; i++)
        d->events[i] = draw_event(scene->n_bodies, scene->n_effects, d->ctx + i, d->contacts + i, d->actions[i]);
    scene->bodies = d->bodies;
    scene->effects = d->effects;
    scene->events = d->events;
    scene->located = d->located;
    if (draw_byte() & 1) vm_scene_keep_budget(scene, &d->book);
}

/* The check and the start agree; has the scene been started? */
static int check_start(drawn_scene *d)
{
    const int size = vm_scene_size(&d->scene);
    vm_scene_fault culprit;
    int status, checked;
    STAIN(culprit);
    STAIN(d->y);
    checked = vm_scene_check(&d->scene, &culprit);
    HOLDS(checked <= 0 && strcmp(vm_strerror(checked), "unknown status") != 0);
    status = vm_scene_start(&d->scene, 0, d->y, &culprit);
    if (checked)
        HOLDS(status == checked && culprit.kind && culprit.index >= -1 && culprit.index < 16 && UNTOUCHED(d->y));
    if (status < 0) { /* y may be filled where the check passed and a mass law fails, as vm_scene_start says */
        HOLDS(checked || status == VM_NOT_FINITE || status == VM_BAD_MASS || status == VM_DOMAIN);
        HOLDS(checked || d->scene.size == 0); /* not started */
        return 0;
    }
    HOLDS(size > 0 && size <= STATE && vmi_all_finite(size, d->y));
    HOLDS(vm_scene_rhs(0, d->y, d->dydt, &d->scene) == 0);
    /* x^alpha of what is extreme overflows */
    HOLDS(vmi_all_finite(size, d->dydt) || d->scene.status < 0 || fuzz.wild);
    return 1;
}

/* At the end of a run the bodies are finite, and so is the book of a scene in which nothing is extreme. */
static void check_end(drawn_scene *d, vm_real t)
{
    const vm_vec3 at = {1, 0, 0};
    vm_budget now;
    vm_body body;
    vm_vec3 r, v;
    int i, status, wild = 0;
    for (i = 0; i < d->scene.n_bodies; i++) {
        vm_scene_body_at(&d->scene, i, d->y, &body);
        vm_scene_point_at(&d->scene, i, at, d->y, &r, &v);
        if (tame_body(&body)) HOLDS(finite3(r) && finite3(v));
        vm_scene_push_at(&d->scene, i, at, d->y, v);
        HOLDS(finite_body(&body) || fuzz.wild); /* the state is finite, omega = L/J of it may overflow */
        wild |= !tame_body(&body);
    }
    STAIN(now);
    status = vm_scene_budget_at(&d->scene, t, d->y, &now);
    if (!d->scene.budget) {
        HOLDS(status == VM_BAD_ARGUMENT && UNTOUCHED(now));
        return;
    }
    HOLDS(status == VM_OK);
    if (!wild && status == VM_OK) HOLDS(is_finite(now.energy) && finite3(now.momentum));
}

static void check_scene(void)
{
    const vm_real t_end = MOSTLY(draw_in(0, 2));
    rk45_options options;
    drawn_scene d;
    vm_real t = 0;
    int status;
    memset(&options, 0, sizeof options);
    options.max_steps = 3000;
    draw_scene(&d);
    if (!check_start(&d)) return;
    status = vm_scene_run(&d.scene, &t, t_end, d.y, d.work, &options);
    HOLDS(strcmp(vm_strerror(status), "unknown status") != 0 && t >= 0 && is_finite(t));
    HOLDS(vmi_all_finite(vm_scene_size(&d.scene), d.y));
    if (!(t_end >= 0) || !is_finite(t_end)) HOLDS(status < 0 && t == 0);
    if (status == VM_OK) HOLDS(t == t_end);
    if (status == VM_STOPPED) HOLDS(t <= t_end);
    if (status >= 0) check_end(&d, t);
}

static void fuzz_scenes(void)
{
    switch (draw_below(16)) {
    case 0: check_forces(); break;
    case 1: check_band(); break;
    default: check_scene();
    }
}
FUZZ_TARGET(scenes)
