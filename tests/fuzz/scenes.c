/* Fuzz target: varmass.h, scenes of drawn bodies, effects and events: the check names a culprit or the run goes; what
   came in balances with what is there; a run ends, where it is told to or with a status. */
#include "bodies.h"

enum { BODIES = 4, EFFECTS = 6, EVENTS = 3, STATE = 13 * BODIES + BODIES + VM_BOOK };

static vm_real push(vm_real t, vm_real x, vm_real v, void *ctx)
{
    return *(const vm_real *)ctx * (1 + t) - x - v;
}

static void callback(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)t, (void)y;
    scene->bodies[effect->body].load.force[0] += *(const vm_real *)effect->ctx;
}

static vm_mass_now mass_law(vm_real t, vm_real x, vm_real v, void *ctx)
{
    vm_mass_now now;
    (void)x, (void)v;
    now.mass = 2 + *(const vm_real *)ctx * t, now.by_t = *(const vm_real *)ctx, now.by_x = now.by_v = 0;
    return now;
}

static void moving_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const vm_real w = *(const vm_real *)ctx;
    memset(r, 0, sizeof *r), memset(v, 0, sizeof *v), memset(a, 0, sizeof *a);
    r->y = 5 + VM_C(0.1) * t * w, v->y = VM_C(0.1) * w;
}

static vm_real user_when(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    return t - *(const vm_real *)ctx;
}

static int user_then(vm_real t, vm_real *y, void *ctx)
{
    (void)t, (void)ctx, (void)y;
    return VM_OK;
}

static int draw_index(int n) { return draw_byte() % 32 ? draw_below(n + 1) % (n ? n : 1) : (int)draw_byte() - 128; }
static int draw_coordinate(void) { return draw_byte() % 16 ? draw_byte() % 4 ? 0 : draw_below(3) : (int)draw_byte() - 128; }

static vm_scene_body draw_scene_body(void)
{
    const vm_real mass = MOSTLY(draw_log(0.1, 10)), a = draw_in(-2, 2), b = MOSTLY(draw_in(-2, 2)), inertia = MOSTLY(draw_log(0.1, 2));
    const vm_vec3 r = draw_vector(3), v = draw_vector(2);
    vm_scene_body made;
    vm_body free_body;
    switch (draw_below(6)) {
    case 0: made = vm_scene_axle(mass, a, b); break;
    case 1: made = vm_scene_plane(mass, inertia, r, a, v, b); break;
    case 2: made = vm_scene_point(mass, r, v); break;
    case 3:
        free_body = draw_body(1);
        made = vm_scene_free(&free_body);
        break;
    default: made = vm_scene_line(mass, a, b);
    }
    if (draw_byte() % 4 == 0) made = vm_scene_with_mass_state(made);
    if (draw_byte() % 8 == 0) made = vm_scene_absent(made);
    return made;
}

static vm_effect draw_effect(int n, vm_real *ctx)
{
    const int body = draw_index(n), coordinate = draw_coordinate();
    const int other = draw_byte() & 1 ? VM_GROUND : draw_index(n), other_coordinate = draw_coordinate();
    const vm_real p = MOSTLY(draw_in(-2, 2)), positive = MOSTLY(draw_log(0.1, 10)), alpha = draw_byte() & 1 ? R(1) : MOSTLY(draw_in(0, 5));
    const vm_vec3 u = draw_vector(1);
    static vm_stream stream; /* the effect points at them */
    static vm_band band;
    *ctx = draw_in(-0.5, 0.5);
    memset(&stream, 0, sizeof stream), memset(&band, 0, sizeof band);
    stream.rate = *ctx / 5, stream.velocity = u;
    switch (draw_below(22)) {
    case 14: return vm_effect_linear_spring(body, coordinate, other, other_coordinate, positive, p);
    case 15: return vm_effect_rotational_damper(body, positive);
    case 16: return vm_effect_stream_force(body, &stream);
    case 17: return vm_effect_stream_moment(body, &stream);
    case 18: return vm_effect_stream_torque(body, &stream);
    case 19:
        HOLDS(vm_band_at(-1, &band).mass == vm_band_at(0, &band).mass || fuzz.wild);
        return vm_effect_band(body, &band);
    case 0: return vm_effect_gravity(body, coordinate, p);
    case 1: return vm_effect_damper(body, coordinate, other, other_coordinate, positive);
    case 2: return vm_effect_van_der_pol(body, coordinate, p, positive);
    case 3: return vm_effect_drive(body, coordinate, p, positive);
    case 4: return vm_effect_harmonic(body, coordinate, p, positive, alpha);
    case 5: return vm_effect_user(body, coordinate, push, ctx);
    case 6: return vm_effect_callback(body, other, callback, ctx);
    case 7: return vm_effect_shaft(body, positive, alpha);
    case 8: return vm_effect_unbalance(body, p, positive, alpha);
    case 9: return vm_effect_gyroscopic(body, p);
    case 10: return vm_effect_link(body, other, moving_point, ctx, positive, draw_byte() & 1, 10);
    case 11: return vm_effect_mass_law(body, mass_law, ctx, u, draw_byte() & 1);
    case 12: return vm_effect_mass(body, draw_below(3), *ctx / 10, p, draw_byte() & 1);
    case 13: return vm_effect_stream(body, *ctx / 5, u, draw_byte() & 1);
    default: return vm_effect_spring(body, coordinate, other, other_coordinate, positive, alpha, p);
    }
}

static vm_event draw_event(int n, int effects, vm_real *ctx)
{
    const int body = draw_index(n), coordinate = draw_coordinate(), direction = draw_below(3) - 1;
    const vm_real value = MOSTLY(draw_in(-2, 2)), time = MOSTLY(draw_in(0, 2));
    vm_body part;
    vm_event event;
    *ctx = draw_in(0, 2);
    switch (draw_below(6)) {
    case 0: event = vm_event_position(body, coordinate, value, direction); break;
    case 1: event = vm_event_velocity(body, coordinate, value, direction); break;
    case 2: event = vm_event_mass(body, value, direction); break;
    case 3: event = vm_event_user(user_when, ctx, direction); break;
    default: event = vm_event_at(time);
    }
    switch (draw_below(6)) {
    case 0: return vm_then_switch(event, draw_index(effects), draw_byte() & 1);
    case 1:
        part = draw_body(0.1), part.mass = MOSTLY(draw_in(0.01, 0.3));
        part.inertia = draw_inertia(is_finite(part.mass) ? part.mass : 1, 0.1);
        return vm_then_separate(event, body, draw_index(n), &part, draw_byte() & 1);
    case 2: return vm_then_attach(event, body, draw_index(n));
    case 3: return vm_then_user(event, user_then, NULL);
    case 4: return vm_then_stop(event);
    default:
        event.most = 3;
        return vm_then_stop(event);
    }
}

static void check_forces(void)
{
    const vm_real k = MOSTLY(draw_in(0, 3)), alpha = MOSTLY(draw_in(0, 5)), x = MOSTLY(draw_in(-3, 3)), v = MOSTLY(draw_in(-3, 3));
    if (!tame(k) || !tame(x) || !tame(v) || !tame(alpha) || alpha < 0 || alpha > 8 || k < 0) return;
    HOLDS(vm_force_spring(k, alpha, -x) == -vm_force_spring(k, alpha, x) && (double)x * (double)vm_force_spring(k, alpha, x) <= 0);
    HOLDS(vm_force_damper(k, v) == -k * v && vm_force_van_der_pol(k, 0, x, v) == k * v && vm_force_drive(k, 0, v) == k);
    if (VM_FABS(x) < 1000) HOLDS(VM_FABS(vm_force_harmonic(k, 2, x, v)) <= k);
    HOLDS(vm_force_stream(k, 0, 1, v) == 0 && within(vm_force_stream(k, x, 0, v), k * (x - v), 4 * EPS * (double)(k * (VM_FABS(x) + VM_FABS(v)))));
}

static void check_scene(void)
{
    vm_scene_body bodies[BODIES];
    vm_effect effects[EFFECTS];
    vm_event events[EVENTS];
    ode_event located[EVENTS];
    vm_real ctx[EFFECTS + EVENTS], y[STATE], dydt[STATE], work[VM_SCENE_WORK(STATE)], t = 0;
    const vm_real t_end = MOSTLY(draw_in(0, 2));
    rk45_options options;
    vm_scene scene;
    vm_book book, now;
    vm_culprit culprit;
    vm_body body;
    int i, status, checked, size, wild = 0;
    memset(&scene, 0, sizeof scene), memset(&options, 0, sizeof options);
    scene.n_bodies = 1 + draw_below(BODIES), scene.n_effects = draw_below(EFFECTS + 1), scene.n_events = draw_byte() & 1 ? draw_below(EVENTS + 1) : 0;
    for (i = 0; i < scene.n_bodies; i++) bodies[i] = draw_scene_body();
    for (i = 0; i < scene.n_effects; i++) effects[i] = draw_effect(scene.n_bodies, ctx + i);
    for (i = 0; i < scene.n_events; i++) events[i] = draw_event(scene.n_bodies, scene.n_effects, ctx + EFFECTS + i);
    scene.bodies = bodies, scene.effects = effects, scene.events = events, scene.located = located;
    if (draw_byte() & 1) vm_scene_keep_book(&scene, &book);
    STAIN(culprit), STAIN(y);
    checked = vm_scene_check(&scene, &culprit);
    HOLDS(checked <= 0 && strcmp(vm_strerror(checked), "unknown status") != 0);
    size = vm_scene_size(&scene);
    status = vm_scene_start(&scene, t, y, &culprit);
    if (checked) HOLDS(status == checked && culprit.kind && culprit.index >= -1 && culprit.index < 16 && UNTOUCHED(y));
    if (status < 0) {
        HOLDS(UNTOUCHED(y));
        return;
    }
    HOLDS(size > 0 && size <= STATE && vmi_all_finite(size, y));
    HOLDS(vm_scene_rhs(t, y, dydt, &scene) == 0);
    HOLDS(vmi_all_finite(size, dydt) || scene.status < 0 || fuzz.wild);
    options.max_steps = 3000;
    status = vm_scene_run(&scene, &t, t_end, y, work, &options);
    HOLDS(strcmp(vm_strerror(status), "unknown status") != 0 && t >= 0 && is_finite(t) && vmi_all_finite(size, y));
    if (!(t_end >= 0) || !is_finite(t_end)) HOLDS(status < 0 && t == 0);
    if (status == VM_OK) HOLDS(t == t_end);
    if (status == VM_STOPPED) HOLDS(t <= t_end);
    if (status < 0) return;
    for (i = 0; i < scene.n_bodies; i++) {
        vm_scene_body_at(&scene, i, y, &body);
        HOLDS(finite_body(&body));
        wild |= !tame_body(&body);
    }
    STAIN(now);
    if (!scene.book) HOLDS(vm_scene_balance(&scene, t, y, &now) == VM_BAD_ARGUMENT && UNTOUCHED(now));
    else {
        status = vm_scene_balance(&scene, t, y, &now);
        HOLDS(status == VM_OK);
        if (!wild && status == VM_OK) HOLDS(is_finite(now.energy) && finite3(now.momentum));
    }
}

static void fuzz_scenes(void)
{
    if (draw_below(8) == 0) check_forces();
    else check_scene();
}
FUZZ_TARGET(scenes)
