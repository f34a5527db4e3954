/* varmass.h, scenes: masses that vary. Mass laws, masses that run out, laws that are switched, and bands that are
   wound up, against closed forms, 36-digit integration and the balances of momentum and energy. */
#include "../examples/scenes/reel.h"
#include "stage_check.h"

/* ---- Mass laws ---- */

/* M = 2 + x/2 under a force of 3 N, up to x = 4; what joins is at rest (u = 0), or has the body's velocity (u = v).
   */
static void check_mass_of_x(void)
{
    stage s;
    stage_clear(&s, 10);
    stage_body(&s, vm_scene_body_line(2, 0, 1));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_X, REAL(0.5), 0, 1));
    stage_effect(&s, vm_effect_motor(0, 0, 3, 0));
    stage_event(&s, vm_then_stop(vm_event_position(0, 0, 4, 1)));
    begin(&s);
    run(&s, 10, VM_STOPPED);
    agrees("M(x), u = 0", "v", s.y[1], 2.17944947177033678, 2, 1e-10);
    agrees("M(x), u = 0", "t", s.t, 2.23926596236044903, 2, 1e-10);
    balanced(&s, "M(x), u = 0", 10, 10);
    s.effects[0] = vm_effect_mass(0, VM_MASS_OF_X, REAL(0.5), 0, 0);
    begin(&s);
    run(&s, 10, VM_STOPPED);
    agrees("M(x), u = v", "v", s.y[1], 3.05250162435982067, 3, 1e-10);
    agrees("M(x), u = v", "t", s.t, 1.86340930588489411, 2, 1e-10);
    balanced(&s, "M(x), u = v", 10, 10);
}

/* M = 1 + v^2/2 on a spring; M = 1 - v^2/2 under a force, where M + M'(v) v = 0 stops the run at the largest momentum
   */
static void check_mass_of_v(void)
{
    stage s;
    stage_clear(&s, 10);
    stage_body(&s, vm_scene_body_line(1, 1, 0));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_V2, REAL(0.5), 0, 1));
    stage_effect(&s, vm_effect_spring(0, 0, VM_GROUND, 0, 4, 1, 0));
    stage_event(&s, vm_then_stop(vm_event_position(0, 0, 0, -1)));
    begin(&s);
    run(&s, 10, VM_STOPPED);
    agrees("M(v)", "t", s.t, 1.02853058341060403, 1, 1e-10);
    agrees("M(v)", "v", s.y[1], -1.31796592658636647, 1, 1e-10);
    balanced(&s, "M(v)", 10, 10);
    s.bodies[0] = vm_scene_body_line(1, 0, 0);
    s.effects[0] = vm_effect_mass(0, VM_MASS_OF_V2, REAL(-0.5), 0, 1);
    s.effects[1] = vm_effect_motor(0, 0, 3, 0);
    begin(&s);
    run(&s, 10, VM_NO_EFFECTIVE_MASS);
    agrees("M(v) singular", "t", s.t, 0.181443684650605785, 1, 1e-9);
}

/* M = 2 exp(-t/4): what leaves is at rest, so that M v stays; or it has the body's velocity, which a force of 3 N then
   raises to v0 + 6 (exp(t/4) - 1). */
static void check_mass_of_time(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_law law = vm_law_exponential(2, REAL(-0.25));
    vm_body now;
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_plane(1, 1, zero, 0, stage_vec(1, -2, 0), 3));
    stage_effect(&s, vm_effect_mass_of_time(0, &law, zero, 1));
    begin(&s);
    run(&s, 8, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("M(t), u = 0", "mass", now.mass, 2 * exp(-2.), 1, 1e-14);
    agrees("M(t), u = 0", "vx", now.v.x, exp(2.), 7, 1e-10);
    agrees("M(t), u = 0", "vy", now.v.y, -2 * exp(2.), 15, 1e-10);
    CHECK(now.omega.z == 3);
    balanced(&s, "M(t), u = 0", 10, 100);
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_mass_of_time(0, &law, zero, 0));
    stage_effect(&s, vm_effect_motor(0, 0, 3, 0));
    begin(&s);
    run(&s, 8, VM_OK);
    agrees("M(t), u = v", "v", s.y[1], 1 + 6 * (exp(2.) - 1), 40, 1e-10);
    balanced(&s, "M(t), u = v", 100, 1000);
}

/* A linear law is VM_MASS_OF_T to the bit. A run ends where a mass runs out, and where the table of its law ends. */
static void check_laws_of_time(void)
{
    const vm_real time[] = {0, 1, 2, 3}, value[] = {4, 3, 3, 1};
    const vm_vec3 u = {REAL(0.5), 0, 0};
    const vm_law linear = vm_law_linear(4, -1), table = vm_law_table(4, time, value);
    vm_body now;
    vm_real v;
    stage s;
    stage_clear(&s, 5);
    stage_body(&s, vm_scene_body_line(4, 0, 1));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, -1, u.x, REAL(0.25)));
    stage_effect(&s, vm_effect_motor(0, 0, 3, REAL(0.5)));
    begin(&s);
    run(&s, 3, VM_OK);
    v = s.y[1];
    s.effects[0] = vm_effect_mass_of_time(0, &linear, u, REAL(0.25));
    begin(&s);
    run(&s, 3, VM_OK);
    CHECK(s.y[1] == v);
    run(&s, 5, VM_BAD_MASS);
    agrees("M(t)", "end", s.t, 4, 1, 1e-5);
    s.effects[0] = vm_effect_mass_of_time(0, &table, u, REAL(0.25));
    begin(&s);
    run(&s, 2, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    CHECK(now.mass == 3);
    CHECK(stage_run(&s, 4) < 0 && s.scene.status < 0);
    agrees("M(t)", "end of the table", s.t, 3, 1, 1e-9);
    s.effects[0] = vm_effect_mass_of_time(0, NULL, u, 0);
    CHECK(stage_start(&s) == VM_BAD_ARGUMENT);
}

/* A part leaves a body whose mass follows a law. The law goes on from the mass that is left. */
static void check_law_and_jump(void)
{
    vm_body part = part_of(1, 0), now;
    stage s;
    part.v.x = 1;
    stage_clear(&s, 5);
    stage_body(&s, vm_scene_body_line(4, 0, 2));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, (vm_real)-0.25, 0, 0));
    stage_event(&s, vm_then_separate(vm_event_at(4), 0, 1, &part, 1));
    begin(&s);
    run(&s, 5, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("law and jump", "mass", now.mass, 4 - 5 * 0.25 - 1, 1, 1e-14);
    agrees("law and jump", "v", now.v.x, 2 - 1. / 2, 1, 1e-14); /* (3 2 - 1 3)/2 */
    balanced(&s, "law and jump", 10, 10);
}

/* 6 kg that lose 3 kg/s are used up at t = 2. */
static void runs_out(stage *s, const char *kind)
{
    begin(s);
    run(s, 3, VM_BAD_MASS);
    check_error("mass runs out", kind, "abs", fabs((double)s->t - 2), is_float ? 1e-3 : 1e-9, s->bodies[0].motion, 0);
}

/* A mass that runs out, by a law or as a state, ends the run there with VM_BAD_MASS: for bodies of each motion. */
static void check_mass_runs_out(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_body body = probe();
    vm_scene_body bodies[5];
    int i;
    bodies[0] = vm_scene_body_line(6, 0, 1);
    bodies[1] = vm_scene_body_axle(6, 0, 1);
    bodies[2] = vm_scene_body_plane(6, 1, zero, 0, stage_vec(1, 0, 0), 1);
    bodies[3] = vm_scene_body_point(6, zero, zero);
    bodies[4] = vm_scene_body_free(&body);
    for (i = 0; i < 5; i++) {
        int reactive; /* 0: what leaves has the velocity of the body; 1: this velocity grows without end, as 1/(2 - t) */
        for (reactive = 0; reactive < 2; reactive++) {
            stage s;
            stage_clear(&s, 3);
            stage_body(&s, bodies[i]);
            stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, -3, 0, REAL(reactive)));
            runs_out(&s, "law");
            stage_clear(&s, 3);
            stage_body(&s, vm_scene_body_with_mass_state(bodies[i]));
            stage_effect(&s, vm_effect_stream(0, -3, zero, REAL(reactive)));
            runs_out(&s, "state");
        }
    }
}

/* ---- Mass laws that are switched ---- */

/* The mass 1 + t/2, by a function */
static vm_mass_now growing(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_mass_now now = {1 + t / 2, REAL(0.5), 0, 0};
    (void)x;
    (void)v;
    (void)ctx;
    return now;
}

/* The body has 2 kg more while this effect acts. */
static void loaded(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)y;
    (void)s;
    e->load->mass += 2;
}

/* Runs to t, and returns the mass of body 0 there. */
static vm_real mass_at(stage *s, double t)
{
    vm_body now;
    run(s, t, VM_OK);
    vm_scene_body_at(&s->scene, 0, s->y, &now);
    return now.mass;
}

/* A law that is switched off at t = 4 and on again at t = 6: the mass stays as it is meanwhile, and then the law goes
   on from there. */
static void check_switched_law(int kind, double reactive)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body held, then, now;
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_mass(0, kind, REAL(0.5), 0, REAL(reactive)));
    if (kind > VM_MASS_OF_V2) s.effects[0] = vm_effect_mass_law(0, growing, NULL, zero, REAL(reactive));
    stage_effect(&s, vm_effect_motor(0, 0, kind == VM_MASS_OF_V2 ? REAL(0.25) : 0, 0));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(6), 0, 0));
    begin(&s);
    run(&s, 4, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &held);
    CHECK(s.effects[0].idle && held.mass > REAL(1.5));
    run(&s, 6, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &then);
    agrees("switched law", "held", then.mass, (double)held.mass, 1, 1e-14);
    run(&s, 8, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    if (kind == VM_MASS_OF_X)
        agrees("switched law", "of x", now.mass - then.mass, (double)(now.r.x - then.r.x) / 2, 1, 1e-13);
    else if (kind == VM_MASS_OF_V2)
        agrees("switched law", "of v", now.mass - then.mass, (double)(now.v.x * now.v.x - then.v.x * then.v.x) / 2, 1,
               1e-13);
    else agrees("switched law", "of t", now.mass, 4, 1, 1e-13);
    if (kind != VM_MASS_OF_V2) agrees("switched law", "v", now.v.x, reactive < 1 ? 1 : 1 / (double)now.mass, 1, 1e-9);
    balanced(&s, "switched law", 10, 10);
}

/* A law that is switched on late goes on from the mass with which the body was made. */
static void check_switched_on_late(void)
{
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, REAL(0.5), 0, 1));
    s.effects[0].off = 1;
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 0));
    begin(&s);
    agrees("switched on late", "mass", mass_at(&s, 3), 1, 1, 0);
    agrees("switched on late", "mass", mass_at(&s, 8), 1 + 0.5 * 4, 1, 1e-14);
    agrees("switched on late", "v", s.y[1], 1 / 3., 1, 1e-10);
    balanced(&s, "switched on late", 10, 10);
}

/* An effect of the user's that adds to a mass leaves there what it has added when it is switched off. */
static void check_switched_callback(void)
{
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_custom(0, VM_GROUND, loaded, NULL));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    begin(&s);
    agrees("switched callback", "mass", mass_at(&s, 3), 3, 1, 0);
    agrees("switched callback", "mass", mass_at(&s, 5), 3, 1, 0);
    balanced(&s, "switched callback", 10, 10);
}

/* A part that leaves while the law is off is missing when the law goes on. */
static void check_jump_while_off(void)
{
    vm_body part = part_of(0.5, 0);
    stage s;
    part.v.x = 1;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, REAL(0.5), 0, 0));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(6), 0, 0));
    stage_event(&s, vm_then_separate(vm_event_at(5), 0, 1, &part, 1));
    begin(&s);
    agrees("jump while off", "mass", mass_at(&s, 6), 3 - 0.5, 1, 1e-14);
    agrees("jump while off", "mass", mass_at(&s, 8), 3 - 0.5 + 1, 1, 1e-14);
    balanced(&s, "jump while off", 10, 10);
}

/* A band that is not wound up from t = 4 to t = 6: its inertia stays, and then grows as that of the band at the
   angle. */
static void check_switched_band(void)
{
    const vm_band band = {REAL(0.2), REAL(0.01), REAL(0.5), 800, 0, 0, 0};
    vm_band_now from, to;
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_axle(REAL(0.8), 0, 9));
    stage_effect(&s, vm_effect_band(0, &band));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(6), 0, 0));
    begin(&s);
    mass_at(&s, 6);
    from = vm_band_at(9 * 4, &band);
    agrees("switched band", "inertia", s.bodies[0].load.mass, 0.8 + (double)from.inertia, 1, 1e-12);
    from = vm_band_at(9 * 6, &band);
    to = vm_band_at(9 * 8, &band);
    agrees("switched band", "inertia", mass_at(&s, 8) - s.bodies[0].noted_mass, (double)(to.inertia - from.inertia), 1,
           1e-12);
    balanced(&s, "switched band", 1000, 1000);
}

/* ---- Bands that are wound up ---- */

/* The integral of radius^k over the angle from 0 to phi: the sum over the layers, or the antiderivative of the spiral
   */
static double radius_integral(double phi, int k, int by_layer)
{
    const double pi = acos(-1.0), h = 0.01, R = 0.2;
    double sum = 0, n;
    if (!by_layer) return 2 * pi / h * (pow(R + h * phi / (2 * pi), k + 1) - pow(R, k + 1)) / (k + 1);
    for (n = 0; 2 * pi * (n + 1) <= phi; n++) sum += 2 * pi * pow(R + n * h, k);
    return sum + (phi - 2 * pi * n) * pow(R + n * h, k);
}

/* Are all numbers of the band NaN at phi? */
static int no_band(vm_real phi, const vm_band *b)
{
    const vm_band_now now = vm_band_at(phi, b);
    return now.radius != now.radius && now.rate != now.rate && now.mass != now.mass && now.inertia != now.inertia;
}

static void check_band_domain(int by_layer)
{
    const vm_band good = reel_band(by_layer, 0, 1);
    const vm_band_now bare = vm_band_at(-1, &good);
    vm_band bad = good;
    CHECK(bare.radius == good.radius && bare.rate == 0 && bare.mass == 0 && bare.inertia == 0);
    CHECK(no_band(VM_NAN, &good) && no_band(VM_INFINITY, &good) && no_band(-VM_INFINITY, &good));
    bad.thickness = -good.thickness;
    CHECK(no_band(1, &bad) && no_band(-1, &bad));
    bad = good;
    bad.radius = 0;
    CHECK(no_band(1, &bad));
}

static void check_layers(void)
{
    static const double turns[] = {0.25, 1, 2.75, 10, 30.5};
    int i, by_layer;
    for (by_layer = 0; by_layer < 2; by_layer++)
        for (i = 0; i < 5; i++) {
            const vm_band b = reel_band(by_layer, 0, 1);
            const double x = turns[i] + 1e-4; /* not at a kink */
            const vm_real phi = REAL(x * 2 * acos(-1.0));
            const vm_band_now now = vm_band_at(phi, &b);
            const double line = 0.01 * 0.5 * 800, exact_m = line * radius_integral((double)phi, 1, by_layer);
            const double exact_J = line * radius_integral((double)phi, 3, by_layer);
            agrees("band", "mass", now.mass, exact_m, exact_m, 1e-13);
            agrees("band", "inertia", now.inertia, exact_J, exact_J, 1e-13);
            agrees("band", "radius", now.radius, 0.2 + 0.01 * (by_layer ? floor(x) : x), 1, 1e-14);
            agrees("band", "mu", now.rate, (double)vm_drum_band(now.radius, b.thickness, b.width, b.density), 1,
                   1e-14);
        }
    check_band_domain(0);
    check_band_domain(1);
}

/* J omega = J0 omega0 + speed rho b h times the integral of radius^2 over the angle */
static void check_winding(int by_layer)
{
    const double line = 0.01 * 0.5 * 800, phi = 40;
    stage s;
    reel(&s, by_layer, phi);
    begin(&s);
    CHECK(vm_scene_size(&s.scene) == 2 + VM_BUDGET);
    run(&s, 100, VM_STOPPED);
    agrees(by_layer ? "layers" : "winding", "omega", s.y[1],
           (0.8 * 9 + 1.5 * line * radius_integral(phi, 2, by_layer)) /
               (0.8 + line * radius_integral(phi, 3, by_layer)),
           9, by_layer ? 1e-8 : 1e-9); /* at each layer the torque jumps */
    balanced(&s, "winding", by_layer ? 100 : 10, 1000);
}

/* The first layer has the closed forms of section 5.2: vm_drum_angle and vm_drum_rate. */
static void check_first_layer(void)
{
    const vm_band b = reel_band(1, 1.5, 1);
    vm_drum d;
    stage s;
    memset(&d, 0, sizeof d);
    d.radius = b.radius;
    d.mass = 1;
    d.inertia = REAL(0.8);
    d.speed = b.speed;
    d.damping = REAL(0.1);
    d.omega = 9;
    d.band = vm_drum_band(b.radius, b.thickness, b.width, b.density);
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_axle(d.inertia, 0, d.omega));
    stage_effect(&s, vm_effect_band(0, &b));
    stage_effect(&s, vm_effect_rotational_damper(0, d.damping));
    begin(&s);
    run(&s, 0.5, VM_OK);
    agrees("first layer", "phi", s.y[0], (double)vm_drum_angle(&d, REAL(0.5)), 1, 1e-10);
    agrees("first layer", "phi'", s.y[1], (double)vm_drum_rate(&d, s.y[0]), 1, 1e-10);
    CHECK(s.y[0] > 4 && s.y[0] < REAL(6.28));
}

/* A band that is unwound leaves with the velocity of the drum, whose speed then stays; or it is drawn off at a speed.
   */
static void check_unwinding(void)
{
    const double line = 0.01 * 0.5 * 800, start = 100, end = 20;
    vm_band b = reel_band(0, 0, 0);
    stage s;
    stage_clear(&s, 100);
    stage_body(&s, vm_scene_body_axle(REAL(0.8), REAL(start), -5));
    stage_effect(&s, vm_effect_band(0, &b));
    stage_event(&s, vm_then_stop(vm_event_position(0, 0, REAL(end), -1)));
    begin(&s);
    run(&s, 100, VM_STOPPED);
    agrees("unwinding", "t", s.t, 16, 16, 1e-10);
    agrees("unwinding", "omega", s.y[1], -5, 5, 1e-12);
    b = reel_band(0, -1, 1);
    s.effects[0] = vm_effect_band(0, &b);
    begin(&s);
    run(&s, 100, VM_STOPPED);
    agrees("unwinding", "drawn", s.y[1],
           (-5 * (0.8 + line * radius_integral(start, 3, 0)) +
            line * (radius_integral(start, 2, 0) - radius_integral(end, 2, 0))) /
               (0.8 + line * radius_integral(end, 3, 0)),
           5, 1e-9);
    balanced(&s, "unwinding", 10, 100);
}

static void refused_band(stage *s, int body, const vm_band *band, int status)
{
    s->effects[0] = vm_effect_band(body, band);
    refused(s, status, "effect", 0);
}

static void check_refused_bands(void)
{
    const vm_body body = probe();
    const vm_band band = reel_band(0, 0, 1);
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_free(&body));
    stage_body(&s, vm_scene_body_axle(1, 0, 0));
    stage_effect(&s, vm_effect_band(1, &band));
    begin(&s);
    s.effects[0].p[0] = 0;
    refused(&s, VM_DOMAIN, "effect", 0);
    s.effects[0] = vm_effect_band(1, &band);
    s.effects[0].p[1] = -1;
    refused(&s, VM_DOMAIN, "effect", 0);
    refused_band(&s, 1, NULL, VM_BAD_ARGUMENT);
    refused_band(&s, 0, &band, VM_BAD_MOTION);
}

int main(void)
{
    int k;
    check_mass_of_x();
    check_mass_of_v();
    check_mass_of_time();
    check_laws_of_time();
    check_law_and_jump();
    check_mass_runs_out();
    for (k = 0; k < 2; k++) {
        check_switched_law(VM_MASS_OF_T, k);
        check_switched_law(VM_MASS_OF_X, k);
        check_switched_law(VM_MASS_OF_V2, k);
        check_switched_law(VM_MASS_OF_V2 + 1, k);
    }
    check_switched_on_late();
    check_switched_callback();
    check_jump_while_off();
    check_switched_band();
    check_layers();
    check_winding(0);
    check_winding(1);
    check_first_layer();
    check_unwinding();
    check_refused_bands();
    return check_finish("scene mass");
}
