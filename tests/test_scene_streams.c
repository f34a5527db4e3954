/* varmass.h, scenes: streams that cross at points of growing bodies, whole and each of their loads alone, against the
   equations of chapter 5; a contact that moves, the drum of chapter 5.2; bands in layers by closed forms; jumps. */
#include "../examples/scenes/reel.h"
#include "stage_check.h"

static vm_inertia inertia(double xx, double yy, double zz, double xy, double xz, double yz)
{
    vm_inertia i;
    i.xx = REAL(xx);
    i.yy = REAL(yy);
    i.zz = REAL(zz);
    i.xy = REAL(xy);
    i.xz = REAL(xz);
    i.yz = REAL(yz);
    return i;
}

static vm_body probe(void)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = 6;
    b.inertia = inertia(4, 3.5, 3.1, 0.1, -0.2, 0.05); /* a body's, whatever the streams below take */
    b.q.w = REAL(0.8);
    b.q.x = REAL(0.36);
    b.q.y = REAL(-0.48);
    b.r = stage_vec(1, -2, 0.5);
    b.v = stage_vec(0.1, 0.2, -0.1);
    b.omega = stage_vec(0.3, -0.4, 0.6);
    return b;
}

static vm_stream jet(double rate, int motion)
{
    vm_stream s;
    memset(&s, 0, sizeof s);
    s.rate = REAL(rate);
    s.motion = motion;
    s.at = stage_vec(0.5, -0.3, 0.4);
    s.velocity = stage_vec(0.7, 0.2, -0.5);
    s.spin = stage_vec(0.8, -0.5, 0.3);
    s.gyration = inertia(0.35, 0.55, 0.25, 0.05, 0.05, 0.05);
    return s;
}

/* A stream with all that it does */
static void stage_stream(stage *s, int body, const vm_stream *stream)
{
    stage_effect(s, vm_effect_stream_mass(body, stream));
    stage_effect(s, vm_effect_stream_force(body, stream));
    stage_effect(s, vm_effect_stream_moment(body, stream));
    stage_effect(s, vm_effect_stream_torque(body, stream));
}

static void same_vec(const char *what, vm_vec3 got, vm_vec3 wanted, double scale, double bound)
{
    agrees("stream", what, size_of(vmi_sub(got, wanted)), 0, scale, bound);
}

/* ---- In space: as vm_flow_rhs, whose states are the momenta ---- */

static void check_space(int first, int second)
{
    const rk45_options o = stage_options();
    const vm_body body = probe();
    vm_stream streams[2];
    vm_flow flow;
    vm_body wanted = body, got;
    vm_real y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
    rk45 r;
    stage s;
    streams[0] = jet(-0.5, first);
    streams[1] = jet(0.7, second);
    streams[1].at = stage_vec(-0.2, 0.6, 0.1);
    streams[1].spin = stage_vec(-0.1, 0.2, 0.4);
    memset(&flow, 0, sizeof flow);
    flow.n = 2;
    flow.streams = streams;
    CHECK(vm_flow_start(&flow, &body, y) == VM_OK);
    CHECK(rk45_init(&r, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, &o, work) >= 0 && rk45_solve(&r, 3) >= 0);
    CHECK(vm_flow_body(&flow, VM_FLOW_STATES, r.y, &wanted) == VM_OK);
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
    stage_stream(&s, 0, streams);
    stage_stream(&s, 0, streams + 1);
    begin(&s);
    CHECK(vm_scene_size(&s.scene) == 13 + 10 + VM_BUDGET);
    run(&s, 3, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &got);
    agrees("stream", "mass", got.mass, (double)wanted.mass, 6, 1e-12);
    same_vec("r", got.r, wanted.r, 1, 1e-9);
    same_vec("v", got.v, wanted.v, 1, 1e-9);
    same_vec("omega", got.omega, wanted.omega, 1, 1e-9);
    same_vec("centre", vmi_get3(s.y + 14), vmi_get3(r.y + VM_Y_CENTRE), 1, 1e-9);
    agrees("stream", "inertia", got.inertia.yz, (double)wanted.inertia.yz, 1, 1e-9);
    agrees("stream", "inertia", got.inertia.xx, (double)wanted.inertia.xx, 1, 1e-9);
    balanced(&s, "stream", 10, 10);
}

/* Each load alone at an instant, beside vm_reactive_loads: the force moves, the moment and the torque turn */
static void check_alone(int motion)
{
    const vm_body body = probe();
    const vm_stream stream = jet(-0.5, motion);
    const vm_vec3 zero = {0, 0, 0};
    vm_reactive all = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, {0, 0, 0, 0, 0, 0}}, one;
    vm_real dydt[STAGE_STATE];
    int part, k;
    CHECK(vm_reactive_loads(&body, zero, 1, &stream, &all) == VM_OK);
    for (part = 0; part < 4; part++) {
        vm_vec3 a = zero, alpha = zero, got;
        vm_body now;
        stage s;
        memset(&one, 0, sizeof one);
        stage_clear(&s, 1);
        stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
        if (part == 0) {
            stage_effect(&s, vm_effect_stream_force(0, &stream));
            one.force = all.force;
        }
        if (part == 1) {
            stage_effect(&s, vm_effect_stream_moment(0, &stream));
            one.moment = all.moment;
        }
        if (part == 2) {
            stage_effect(&s, vm_effect_stream_torque(0, &stream));
            one.torque = all.torque;
        }
        if (part == 3) stage_effect(&s, vm_effect_stream_mass(0, &stream));
        for (k = 0; k < STAGE_STATE; k++) s.y[k] = 7; /* what was there before is nothing to the start */
        begin(&s);
        vm_scene_body_at(&s.scene, 0, s.y, &now);
        CHECK(vm_accelerations(&body, &one, zero, zero, &a, &alpha) == VM_OK);
        vm_scene_rhs(0, s.y, dydt, &s.scene);
        same_vec("v' of one load", vmi_get3(dydt + 7), a, 1, 1e-13);
        got = vmi_get3(dydt + 10);
        got = vmi_times(&s.bodies[0].axes, got);
        same_vec("omega' of one load", got, alpha, 1, 1e-13);
        CHECK(dydt[13] == (part == 3 ? all.mass_rate : 0));
        got = vmi_sub(vmi_get3(dydt), body.v);
        same_vec("drift", got, part == 3 ? all.drift : zero, 1, 1e-14);
        CHECK(dydt[17] == (part == 3 ? all.inertia_rate.xx : 0));
    }
}

/* ---- In the plane: as vm_flow2_rhs ---- */

static void check_plane(int motion)
{
    const rk45_options o = stage_options();
    vm_real y[VM_FLOW2_STATES] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, work[RK45_WORK(VM_FLOW2_STATES)];
    vm_stream stream = jet(-0.4, motion);
    vm_stream2 flat;
    vm_flow2 flow;
    rk45 r;
    stage s;
    stream.at.z = stream.velocity.z = stream.spin.x = stream.spin.y = 0;
    memset(&flow, 0, sizeof flow);
    memset(&flat, 0, sizeof flat);
    flow.n = 1;
    flow.streams = &flat;
    flat.rate = stream.rate;
    flat.motion = motion;
    flat.x = stream.at.x;
    flat.y = stream.at.y;
    flat.vx = stream.velocity.x;
    flat.vy = stream.velocity.y;
    flat.spin = stream.spin.z;
    flat.gyration = stream.gyration.zz;
    y[2] = REAL(0.3);
    y[3] = 4;
    y[4] = -2;
    y[5] = REAL(1.5);
    y[6] = 4;
    y[9] = 3;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_growing_plane(
                       vm_scene_body_plane(4, 3, stage_vec(0, 0, 0), REAL(0.3), stage_vec(1, -0.5, 0), REAL(0.5))));
    stage_stream(&s, 0, &stream);
    begin(&s);
    CHECK(vm_scene_size(&s.scene) == 6 + 4 + VM_BUDGET);
    run(&s, 3, VM_OK);
    CHECK(rk45_init(&r, vm_flow2_rhs, &flow, VM_FLOW2_STATES, 0, y, &o, work) >= 0 && rk45_solve(&r, 3) >= 0);
    agrees("plane", "x", s.y[0], (double)r.y[0], 1, 1e-9);
    agrees("plane", "y", s.y[1], (double)r.y[1], 1, 1e-9);
    agrees("plane", "angle", s.y[2], (double)r.y[2], 1, 1e-9);
    agrees("plane", "vx", s.y[3], (double)(r.y[3] / r.y[6]), 1, 1e-9);
    agrees("plane", "omega", s.y[5], (double)(r.y[5] / r.y[9]), 1, 1e-9);
    agrees("plane", "mass", s.y[6], (double)r.y[6], 1, 1e-12);
    agrees("plane", "centre", s.y[8], (double)r.y[8], 1, 1e-9);
    agrees("plane", "inertia", s.y[9], (double)r.y[9], 1, 1e-9);
    balanced(&s, "plane", 10, 10);
}

/* ---- A contact that moves in the body: a band winds up on a drum on an elastic shaft, as vm_drum_rhs ---- */

static vm_vec3 shaft_of(const stage *s, const vm_real *y) /* from the mass centre to S, inertial axes */
{
    vm_real sine, cosine;
    (void)s;
    vmi_sincos(y[2], &sine, &cosine);
    return vmi_vec3(-(cosine * y[7] - sine * y[8]), -(sine * y[7] + cosine * y[8]), 0);
}

static void band_now(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    static const vm_store far_away = {{9, 9, 9}, {9, 9, 9, 0, 0, 0}};
    const vm_drum *d = (const vm_drum *)ctx;
    vm_real s, c;
    (void)t;
    vmi_sincos(y[2], &s, &c);
    stream->from = &far_away;                                /* which is not looked at */
    stream->at = vmi_vec3(d->radius * c, -d->radius * s, 0); /* stays at (R, 0) from S in space */
    stream->rate = d->band * y[5];
}

static void shaft_pulls(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_drum *d = (const vm_drum *)e->ctx;
    const vm_vec3 arm = shaft_of(NULL, y), S = vmi_add(vmi_get3(y), arm);
    const vm_real fx = -d->stiffness * S.x, fy = -d->stiffness * S.y;
    (void)t;
    (void)scene;
    e->load->force[0] += fx;
    e->load->force[1] += fy;
    e->load->force[2] += arm.x * fy - arm.y * fx - d->damping * y[5];
}

static void check_drum(void)
{
    const rk45_options o = stage_options();
    vm_drum d;
    vm_stream band;
    vm_real y[VM_DRUM_STATES], work[RK45_WORK(VM_DRUM_STATES)];
    vm_vec3 S;
    rk45 r;
    stage s;
    memset(&d, 0, sizeof d);
    memset(&band, 0, sizeof band);
    memset(y, 0, sizeof y);
    d.radius = REAL(0.3);
    d.mass = 20;
    d.inertia = REAL(0.9);
    d.band = REAL(0.45);
    d.speed = REAL(0.9);
    d.damping = REAL(0.05);
    d.stiffness = 2000;
    d.omega = 3;
    band.motion = VM_ABSOLUTE;
    band.velocity.y = d.speed;
    y[0] = REAL(0.01);
    y[4] = REAL(0.02);
    y[5] = d.omega;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_growing_plane(vm_scene_body_plane(d.mass, d.inertia, stage_vec(0.01, 0, 0), 0,
                                                         stage_vec(0, 0.02, 0), d.omega)));
    stage_effect(&s, vm_effect_varying(vm_effect_stream_mass(0, &band), band_now, &d));
    stage_effect(&s, vm_effect_varying(vm_effect_stream_force(0, &band), band_now, &d));
    stage_effect(&s, vm_effect_varying(vm_effect_stream_moment(0, &band), band_now, &d));
    stage_effect(&s, vm_effect_varying(vm_effect_stream_torque(0, &band), band_now, &d));
    stage_effect(&s, vm_effect_custom(0, VM_GROUND, shaft_pulls, &d));
    begin(&s);
    run(&s, 2, VM_OK);
    CHECK(rk45_init(&r, vm_drum_rhs, &d, VM_DRUM_STATES, 0, y, &o, work) >= 0 && rk45_solve(&r, 2) >= 0);
    S = vmi_add(vmi_get3(s.y), shaft_of(&s, s.y));
    agrees("drum", "phi", s.y[2], (double)r.y[2], 1, 1e-9);
    agrees("drum", "phi'", s.y[5], (double)r.y[5], 1, 1e-9);
    agrees("drum", "xS", S.x, (double)r.y[0], 0.01, 1e-7);
    agrees("drum", "yS", S.y, (double)r.y[1], 0.01, 1e-7);
    agrees("drum", "J about S", s.y[9] + s.y[6] * (s.y[7] * s.y[7] + s.y[8] * s.y[8]),
           (double)(d.inertia + d.band * d.radius * d.radius * r.y[2]), 1, 1e-9); /* (187) */
    balanced(&s, "drum", 10, 10);
}

/* ---- Streams through the mass centre, in space ---- */

static void check_rocket(void)
{
    const vm_body body = probe();
    vm_body later, got;
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_with_mass_state(vm_scene_body_free(&body)));
    stage_effect(&s, vm_effect_stream(0, REAL(-1.5), stage_vec(-2, 1, 0.5), 1));
    begin(&s);
    run(&s, 2, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &got);
    agrees("rocket", "v", got.v.x, (double)vm_tsiolkovsky(body.v.x, 6, 3, -2), 1, 1e-10);
    agrees("rocket", "v", got.v.z, (double)vm_tsiolkovsky(body.v.z, 6, 3, REAL(0.5)), 1, 1e-10);
    CHECK(vm_torque_free_rotation(&body, 2, &later) == VM_OK);
    same_vec("free spin", got.omega, later.omega, 1, 1e-9);
    agrees("rocket", "mass", got.mass, 3, 3, 1e-13);
    balanced(&s, "rocket", 10, 10);
}

/* ---- Bands in layers ---- */

/* integral of radius^k over phi, by the sum of its layers or by the spiral's antiderivative */
static double radius_integral(double phi, int k, int by_layer)
{
    const double pi = acos(-1.0), h = 0.01, R = 0.2;
    double sum = 0, n;
    if (!by_layer) return 2 * pi / h * (pow(R + h * phi / (2 * pi), k + 1) - pow(R, k + 1)) / (k + 1);
    for (n = 0; 2 * pi * (n + 1) <= phi; n++) sum += 2 * pi * pow(R + n * h, k);
    return sum + (phi - 2 * pi * n) * pow(R + n * h, k);
}

static int no_band(vm_real phi, const vm_band *b)
{
    const vm_band_now now = vm_band_at(phi, b);
    return now.radius != now.radius && now.rate != now.rate && now.mass != now.mass && now.inertia != now.inertia;
}

static void check_band_domain(int by_layer)
{
    const vm_band good = reel_band(by_layer, 0, 0);
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
            const vm_band b = reel_band(by_layer, 0, 0);
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

/* J omega = J0 omega0 + speed rho b h integral of radius^2; the time only for the first layer, section 5.2 */
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

static void check_first_layer(void)
{
    const vm_band b = reel_band(1, 1.5, 0);
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
    agrees("first layer", "phi", s.y[0], (double)vm_drum_angle(REAL(0.5), &d), 1, 1e-10);
    agrees("first layer", "phi'", s.y[1], (double)vm_drum_rate(s.y[0], &d), 1, 1e-10);
    CHECK(s.y[0] > 4 && s.y[0] < REAL(6.28));
}

/* Unwound, what leaves has the drum's velocity: the speed stays; or it is drawn off at a speed */
static void check_unwinding(void)
{
    const double line = 0.01 * 0.5 * 800, start = 100, end = 20;
    vm_band b = reel_band(0, 0, 1);
    stage s;
    stage_clear(&s, 100);
    stage_body(&s, vm_scene_body_axle(REAL(0.8), REAL(start), -5));
    stage_effect(&s, vm_effect_band(0, &b));
    stage_event(&s, vm_then_stop(vm_event_position(0, 0, REAL(end), -1)));
    begin(&s);
    run(&s, 100, VM_STOPPED);
    agrees("unwinding", "t", s.t, 16, 16, 1e-10);
    agrees("unwinding", "omega", s.y[1], -5, 5, 1e-12);
    b = reel_band(0, -1, 0);
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

/* ---- Bodies that shrink until they are none ---- */

/* 10 kg and 1 kg m^2 about each axis lose 1 kg/s 1 m away from the mass centre at first, which is then at
   d = 10/(10 - t) from there: the moments across fall by d^2 a second, to 11 - 100/(10 - t). At t = 10/21 they are
   half of the third, and no body in space is like that from then on; in the plane the moment ends at t = 10/11. The
   run ends there with the reason, whether the body spins or not: what leaves at a velocity of its own lets a spin
   grow without end, and the steps become short before the end. */
static void check_shrinking(int motion, double spin)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_real slack = is_float ? REAL(5e-4) : REAL(2e-8); /* of the triangle inequality in a run, sqrt(eps) */
    vm_body body, end;
    vm_stream stream;
    vm_flow flow;
    vm_real y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
    rk45 r;
    stage s;
    memset(&body, 0, sizeof body);
    memset(&stream, 0, sizeof stream);
    memset(&flow, 0, sizeof flow);
    body.mass = 10;
    body.inertia = inertia(1, 1, 1, 0, 0, 0);
    body.omega = stage_vec(spin, spin / 2, spin);
    stream.rate = -1;
    stream.motion = motion;
    stream.at.z = 1;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
    stage_stream(&s, 0, &stream);
    begin(&s);
    run(&s, 3, VM_BAD_INERTIA);
    check_error("shrinking", "space", "abs", fabs((double)s.t - 10 / 21.) / (double)slack, 1, motion, spin);
    vm_scene_body_at(&s.scene, 0, s.y, &end);
    CHECK(end.inertia.xx > REAL(0.4999) - slack && end.inertia.yy > REAL(0.4999) - slack);
    flow.n = 1;
    flow.streams = &stream;
    CHECK(vm_flow_start(&flow, &body, y) == VM_OK);
    CHECK(rk45_init(&r, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, NULL, work) >= 0 && rk45_solve(&r, 3) < 0);
    CHECK(flow.status == VM_BAD_INERTIA);
    check_error("shrinking", "flow", "abs", fabs((double)r.t - 10 / 21.) / (double)slack, 1, motion, spin);
    stream.at = stage_vec(1, 0, 0);
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_growing_plane(vm_scene_body_plane(10, 1, zero, 0, zero, REAL(spin))));
    stage_stream(&s, 0, &stream);
    begin(&s);
    run(&s, 3, VM_BAD_INERTIA);
    check_error("shrinking", "plane", "abs", fabs((double)s.t - 10 / 11.), is_float ? 1e-5 : 1e-9, motion, spin);
    CHECK(s.y[9] > 0);
}

/* A flat body keeps to the bound of the triangle inequality, xx + yy = zz, for as long as it grows in its plane */
static void check_flat(void)
{
    const vm_quat turned = {REAL(0.8), REAL(0.3), REAL(-0.4), REAL(0.2)};
    vm_body body;
    vm_stream streams[2];
    stage s;
    memset(&body, 0, sizeof body);
    memset(streams, 0, sizeof streams);
    body.mass = 2;
    body.inertia = inertia(0.25, 0.5, 0.75, 0.1, 0, 0);
    body.q = turned;
    body.omega = stage_vec(1, 2, -1);
    streams[0].rate = REAL(0.3);
    streams[0].at = stage_vec(0.7, -0.3, 0);
    streams[0].motion = VM_AT_REST;
    streams[1].rate = REAL(0.1);
    streams[1].at = stage_vec(-0.2, 0.9, 0);
    streams[1].motion = VM_CARRIED;
    stage_clear(&s, 20);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
    stage_stream(&s, 0, streams);
    stage_stream(&s, 0, streams + 1);
    begin(&s);
    run(&s, 20, VM_OK);
    balanced(&s, "flat", 10, 10);
}

/* Masses that run out, as a state and by a law, on each motion: the run ends there, VM_BAD_MASS */
static void check_mass_runs_out(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_body body = probe();
    vm_scene_body bodies[5];
    int i, law;
    bodies[0] = vm_scene_body_line(6, 0, 1);
    bodies[1] = vm_scene_body_axle(6, 0, 1);
    bodies[2] = vm_scene_body_plane(6, 1, zero, 0, stage_vec(1, 0, 0), 1);
    bodies[3] = vm_scene_body_point(6, zero, zero);
    bodies[4] = vm_scene_body_free(&body);
    for (law = 0; law < 4; law++)
        for (i = 0; i < 5; i++) {
            const double share = law & 1; /* without it the velocity grows without end */
            stage s;
            stage_clear(&s, 3);
            stage_body(&s, law < 2 ? bodies[i] : vm_scene_body_with_mass_state(bodies[i]));
            if (law < 2) stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, -3, 0, REAL(share)));
            else stage_effect(&s, vm_effect_stream(0, -3, zero, REAL(share)));
            begin(&s);
            run(&s, 3, VM_BAD_MASS);
            /* a law's velocity grows as 1/(2 - t), which the tolerance follows as far as it can */
            check_error("mass runs out", law < 2 ? "law" : "state", "abs", fabs((double)s.t - 2),
                        is_float ? 1e-3 : 1e-9, i, share);
        }
}

/* ---- Jumps of growing bodies ---- */

static void check_jump(int free)
{
    const vm_body whole = probe();
    const vm_stream stream = jet(-0.5, VM_ABSOLUTE);
    vm_body part = probe(), before, after;
    vm_vec3 from, to;
    stage s;
    part.mass = 1;
    part.inertia = inertia(0, 0, 0, 0, 0, 0);
    part.r = stage_vec(0.1, 0.3, free ? 0.2 : 0);
    part.v = stage_vec(0.5, 0, 0);
    part.omega = stage_vec(0, 0, 0);
    part.q.w = part.q.x = part.q.y = part.q.z = 0;
    stage_clear(&s, 2);
    stage_body(&s, free ? vm_scene_body_growing_free(vm_scene_body_free(&whole))
                        : vm_scene_body_growing_plane(vm_scene_body_plane(6, 3, whole.r, 1, whole.v, 1)));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, stage_vec(0, 0, 0), stage_vec(0, 0, 0))));
    stage_stream(&s, 0, &stream);
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
    s.events[0].time = 2;
    begin(&s);
    run(&s, 1, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &before);
    from = vmi_sub(before.r, vmi_times(&s.bodies[0].axes, vmi_growth_centre(s.bodies, s.y)));
    s.events[0].time = 1;
    run(&s, 1, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &after);
    to = vmi_sub(after.r, vmi_times(&s.bodies[0].axes, vmi_growth_centre(s.bodies, s.y)));
    agrees("jump", "mass", after.mass, (double)before.mass - 1, 6, 1e-14);
    same_vec("the streams' points stay", to, from, 1, 1e-14);
    CHECK(size_of(vmi_sub(after.r, before.r)) > REAL(0.05));
    CHECK(s.events[0].count == 1 && !s.bodies[1].away);
    run(&s, 2, VM_OK);
    balanced(&s, "jump", 10, 10);
}

/* ---- Small ones, and what is refused ---- */

static vm_real soft(vm_real t, vm_real x, vm_real v, void *ctx) { return (void)ctx, -2 * x + v - t; }

static void check_small(void)
{
    const vm_body body = probe();
    vm_real dydt[STAGE_STATE];
    vm_vec3 omega;
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_line(2, 3, 1));
    stage_body(&s, vm_scene_body_line(4, 1, 2));
    stage_body(&s, vm_scene_body_free(&body));
    stage_effect(&s, vm_effect_linear_spring(0, 0, 1, 0, 5, REAL(0.5)));
    begin(&s);
    s.scene.book = NULL;
    vm_scene_rhs(3, s.y, dydt, &s.scene);
    agrees("small", "linear spring", dydt[1], -5 * (2 - 0.5) / 2, 1, 1e-15);
    agrees("small", "linear spring", dydt[3], 5 * (2 - 0.5) / 4, 1, 1e-15);
    s.effects[0] = vm_effect_force_between(0, 0, 1, 0, soft, NULL);
    begin(&s);
    vm_scene_rhs(3, s.y, dydt, &s.scene);
    agrees("small", "user between", dydt[1], (-2. * 2 - 1 - 3) / 2, 1, 1e-15);
    agrees("small", "user between", dydt[3], (2. * 2 + 1 + 3) / 4, 1, 1e-15);
    s.effects[0] = vm_effect_rotational_damper(2, REAL(0.25));
    begin(&s);
    vm_scene_rhs(0, s.y, dydt, &s.scene);
    omega = vmi_get3(s.y + 14); /* I omega' + omega x I omega = -b omega */
    same_vec("rotational damper",
             vmi_add(vmi_inertia_times(&body.inertia, vmi_get3(dydt + 14)),
                     vmi_cross(omega, vmi_inertia_times(&body.inertia, omega))),
             vmi_scale(REAL(-0.25), omega), 1, 1e-14);
}

static void to_nowhere(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)y;
    (void)ctx;
    if (t > 1) stream->motion = 9;
}

/* A stream that becomes one of no kind ends the run at the last good instant */
static void check_gone_wrong(void)
{
    const vm_body body = probe();
    const vm_stream stream = jet(-0.5, VM_RELATIVE);
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
    stage_effect(&s, vm_effect_varying(vm_effect_stream_mass(0, &stream), to_nowhere, NULL));
    begin(&s);
    run(&s, 2, VM_BAD_ARGUMENT);
    agrees("gone wrong", "t", s.t, 1, 1, 1e-9);
}

static void refused(stage *s, int status)
{
    vm_scene_fault found = {NULL, -2};
    CHECK(vm_scene_check(&s->scene, &found) == status && found.index == 0 && !strcmp(found.kind, "effect"));
}

static void check_refusals(void)
{
    const vm_body body = probe();
    const vm_store tank = {{0, 0, 0}, {0, 0, 0, 0, 0, 0}};
    vm_stream stream = jet(1, VM_RELATIVE);
    vm_band band = reel_band(0, 0, 0);
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
    stage_body(&s, vm_scene_body_axle(1, 0, 0));
    stage_body(&s, vm_scene_body_with_mass_state(vm_scene_body_free(&body)));
    stage_effect(&s, vm_effect_stream_mass(0, &stream));
    begin(&s);
    s.effects[0] = vm_effect_stream_mass(0, NULL);
    refused(&s, VM_BAD_ARGUMENT);
    s.effects[0] = vm_effect_stream_mass(1, &stream);
    refused(&s, VM_BAD_MOTION);
    s.effects[0] = vm_effect_stream_mass(2, &stream);
    refused(&s, VM_DOES_NOT_GROW);
    s.effects[0] = vm_effect_varying(vm_effect_motor(1, 0, 1, 1), band_now, NULL);
    refused(&s, VM_BAD_ARGUMENT);
    s.effects[0] = vm_effect_stream_force(0, &stream);
    stream.motion = 9;
    refused(&s, VM_BAD_ARGUMENT);
    stream.motion = VM_RELATIVE;
    stream.from = &tank;
    refused(&s, VM_STORED_STREAM);
    stream.from = NULL;
    stream.at.y = VM_NAN;
    refused(&s, VM_NOT_FINITE);
    s.effects[0] = vm_effect_band(1, &band);
    begin(&s);
    s.effects[0].p[0] = 0;
    refused(&s, VM_DOMAIN);
    s.effects[0] = vm_effect_band(1, &band);
    s.effects[0].p[1] = -1;
    refused(&s, VM_DOMAIN);
    s.effects[0] = vm_effect_band(1, NULL);
    refused(&s, VM_BAD_ARGUMENT);
    s.effects[0] = vm_effect_band(0, &band);
    refused(&s, VM_BAD_MOTION);
    s.bodies[0] = vm_scene_body_growing_plane(vm_scene_body_free(&body));
    CHECK(vm_scene_check(&s.scene, NULL) == VM_BAD_MOTION);
}

/* Without a book, and with a stream of no rate beside, the same motion */
static void check_without_book(void)
{
    const vm_body body = probe();
    const vm_stream stream = jet(-0.5, VM_RELATIVE), still = jet(0, VM_ABSOLUTE);
    vm_body now[3];
    int k;
    for (k = 0; k < 3; k++) {
        stage s;
        stage_clear(&s, 2);
        if (k == 1) vm_scene_keep_budget(&s.scene, NULL);
        stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
        stage_stream(&s, 0, &stream);
        if (k == 2) stage_stream(&s, 0, &still);
        begin(&s);
        run(&s, 2, VM_OK);
        vm_scene_body_at(&s.scene, 0, s.y, now + k);
        if (k != 1) balanced(&s, "stream of no rate", 10, 10);
    }
    for (k = 1; k < 3; k++) {
        same_vec("without a book, r", now[k].r, now[0].r, 1, 1e-9);
        same_vec("without a book, v", now[k].v, now[0].v, 1, 1e-9);
        same_vec("without a book, omega", now[k].omega, now[0].omega, 1, 1e-9);
    }
}

int main(void)
{
    int first, second;
    for (first = VM_RELATIVE; first <= VM_AT_REST; first++) {
        for (second = VM_RELATIVE; second <= VM_AT_REST; second++) check_space(first, second);
        check_alone(first);
        check_plane(first);
    }
    check_drum();
    check_rocket();
    check_layers();
    check_winding(0);
    check_winding(1);
    check_first_layer();
    check_unwinding();
    for (first = VM_RELATIVE; first <= VM_AT_REST; first++) {
        check_shrinking(first, 0);
        check_shrinking(first, 1);
        check_shrinking(first, 100);
    }
    check_flat();
    check_mass_runs_out();
    check_jump(0);
    check_jump(1);
    check_small();
    check_gone_wrong();
    check_refusals();
    check_without_book();
    return check_finish("scene streams");
}
