/* varmass.h, scenes: streams. Streams that cross at points of growing bodies, whole and each of their loads alone,
   against the equations of chapter 5 (vm_flow_rhs, vm_flow2_rhs, vm_drum_rhs); bodies that shrink until they are none, and
   their jumps. */
#include "stage_check.h"

static vm_stream jet(double rate, int motion)
{
    vm_stream s;
    memset(&s, 0, sizeof s);
    s.rate = REAL(rate);
    s.motion = motion;
    s.at = stage_vec(0.5, -0.3, 0.4);
    s.velocity = stage_vec(0.7, 0.2, -0.5);
    s.spin = stage_vec(0.8, -0.5, 0.3);
    s.gyration = inertia_of(0.35, 0.55, 0.25, 0.05, 0.05, 0.05);
    return s;
}

/* Adds all four effects of a stream. */
static void stage_stream(stage *s, int body, const vm_stream *stream)
{
    stage_effect(s, vm_effect_stream_mass(body, stream));
    stage_effect(s, vm_effect_stream_force(body, stream));
    stage_effect(s, vm_effect_stream_moment(body, stream));
    stage_effect(s, vm_effect_stream_torque(body, stream));
}

static void same_vec(const char *what, vm_vec3 got, vm_vec3 wanted, double scale, double bound)
{
    agrees("stream", what, size_of(vm_sub(got, wanted)), 0, scale, bound);
}

/* ---- In space, against vm_flow_rhs ---- */

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
    CHECK(vm_scene_size(&s.scene) == 13 + 10 + VM_BUDGET_STATES);
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

/* Each load alone at an instant, against vm_reactive_loads: the force accelerates, the moment and the torque turn. */
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
        for (k = 0; k < STAGE_STATE; k++) s.y[k] = 7; /* a start does not read what y held before */
        begin(&s);
        vm_scene_body_at(&s.scene, 0, s.y, &now);
        CHECK(vm_accelerations(&body, &one, zero, zero, &a, &alpha) == VM_OK);
        vm_scene_rhs(0, s.y, dydt, &s.scene);
        same_vec("v' of one load", vmi_get3(dydt + 7), a, 1, 1e-13);
        got = vmi_get3(dydt + 10);
        got = vmi_times(&s.bodies[0].axes, got);
        same_vec("omega' of one load", got, alpha, 1, 1e-13);
        CHECK(dydt[13] == (part == 3 ? all.mass_rate : 0));
        got = vm_sub(vmi_get3(dydt), body.v);
        same_vec("drift", got, part == 3 ? all.drift : zero, 1, 1e-14);
        CHECK(dydt[17] == (part == 3 ? all.inertia_rate.xx : 0));
    }
}

/* ---- In the plane, against vm_flow2_rhs ---- */

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
    CHECK(vm_scene_size(&s.scene) == 6 + 4 + VM_BUDGET_STATES);
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

/* ---- A contact that moves in the body, against vm_drum_rhs ---- */

/* A band winds up on a drum on an elastic shaft. S is the centre of the drum. */

/* From the mass centre to S, in inertial axes */
static vm_vec3 shaft_of(const vm_real *y)
{
    vm_real sine, cosine;
    vmi_sincos(y[2], &sine, &cosine);
    return vmi_vec3(-(cosine * y[7] - sine * y[8]), -(sine * y[7] + cosine * y[8]), 0);
}

static void band_now(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    const vm_drum *d = (const vm_drum *)ctx;
    vm_real s, c;
    (void)t;
    vmi_sincos(y[2], &s, &c);
    stream->at = vmi_vec3(d->radius * c, -d->radius * s, 0); /* (R, 0) from S in space */
    stream->rate = d->band * y[5];
}

static void shaft_pulls(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_drum *d = (const vm_drum *)e->ctx;
    const vm_vec3 arm = shaft_of(y), S = vm_add(vmi_get3(y), arm);
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
    S = vm_add(vmi_get3(s.y), shaft_of(s.y));
    agrees("drum", "phi", s.y[2], (double)r.y[2], 1, 1e-9);
    agrees("drum", "phi'", s.y[5], (double)r.y[5], 1, 1e-9);
    agrees("drum", "xS", S.x, (double)r.y[0], 0.01, 1e-7);
    agrees("drum", "yS", S.y, (double)r.y[1], 0.01, 1e-7);
    agrees("drum", "J about S", s.y[9] + s.y[6] * (s.y[7] * s.y[7] + s.y[8] * s.y[8]),
           (double)(d.inertia + d.band * d.radius * d.radius * r.y[2]), 1, 1e-9); /* (187) */
    balanced(&s, "drum", 10, 10);
}

/* ---- A stream through the mass centre, in space ---- */

static void check_rocket(void)
{
    const vm_body body = probe();
    vm_body later, got;
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_with_mass_state(vm_scene_body_free(&body)));
    stage_effect(&s, vm_effect_stream(0, REAL(-1.5), stage_vec(-2, 1, 0.5), 0));
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
    body.inertia = inertia_of(1, 1, 1, 0, 0, 0);
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

/* A flat body stays at the bound of the triangle inequality, xx + yy = zz, while it grows in its plane. */
static void check_flat(void)
{
    const vm_quat turned = {REAL(0.8), REAL(0.3), REAL(-0.4), REAL(0.2)};
    vm_body body;
    vm_stream streams[2];
    stage s;
    memset(&body, 0, sizeof body);
    memset(streams, 0, sizeof streams);
    body.mass = 2;
    body.inertia = inertia_of(0.25, 0.5, 0.75, 0.1, 0, 0);
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

/* ---- Jumps of growing bodies ---- */

static void check_jump(int free)
{
    const vm_body whole = probe();
    const vm_stream stream = jet(-0.5, VM_ABSOLUTE);
    vm_body part = probe(), before, after;
    vm_vec3 from, to;
    stage s;
    part.mass = 1;
    part.inertia = inertia_of(0, 0, 0, 0, 0, 0);
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
    from = vm_sub(before.r, vmi_times(&s.bodies[0].axes, vmi_growth_centre(s.bodies, s.y)));
    s.events[0].time = 1;
    run(&s, 1, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &after);
    to = vm_sub(after.r, vmi_times(&s.bodies[0].axes, vmi_growth_centre(s.bodies, s.y)));
    agrees("jump", "mass", after.mass, (double)before.mass - 1, 6, 1e-14);
    same_vec("the streams' points stay", to, from, 1, 1e-14);
    CHECK(size_of(vm_sub(after.r, before.r)) > REAL(0.05));
    CHECK(s.events[0].count == 1 && !s.bodies[1].away);
    run(&s, 2, VM_OK);
    balanced(&s, "jump", 10, 10);
}

/* ---- Streams that go wrong, or are refused ---- */

static void to_nowhere(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)y;
    (void)ctx;
    if (t > 1) stream->motion = 9;
}

/* A stream whose motion becomes one that does not exist ends the run at the last good instant. */
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

static void refused_effect(stage *s, vm_effect effect, int status)
{
    s->effects[0] = effect;
    refused(s, status, "effect", 0);
}

/* A growing body, an axle, and a free body whose mass alone is a state, to which no stream at a point can come */
static void check_refusals(void)
{
    const vm_body body = probe();
    vm_store tank = {{0, 0, 0}, {0, 0, 0, 0, 0, 0}};
    vm_stream stream = jet(1, VM_RELATIVE);
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&body)));
    stage_body(&s, vm_scene_body_axle(1, 0, 0));
    stage_body(&s, vm_scene_body_with_mass_state(vm_scene_body_free(&body)));
    stage_body(&s, vm_scene_body_plane(1, 1, body.r, 0, body.v, 0));
    stage_effect(&s, vm_effect_stream_mass(0, &stream));
    begin(&s);
    refused_effect(&s, vm_effect_stream_mass(0, NULL), VM_BAD_ARGUMENT);
    refused_effect(&s, vm_effect_stream_mass(1, &stream), VM_BAD_MOTION);
    refused_effect(&s, vm_effect_stream_mass(2, &stream), VM_DOES_NOT_GROW);
    refused_effect(&s, vm_effect_stream_mass(3, &stream), VM_DOES_NOT_GROW);
    refused_effect(&s, vm_effect_varying(vm_effect_motor(1, 0, 1, 1), band_now, NULL), VM_BAD_ARGUMENT);
    stream.motion = 9;
    refused_effect(&s, vm_effect_stream_force(0, &stream), VM_BAD_ARGUMENT);
    stream.motion = VM_RELATIVE;
    stream.from = &tank; /* in the mass centre, which is on every line through it */
    CHECK(vmi_crossing_check(&s.effects[0]) == VM_OK);
    tank.at = vmi_vec3(1, 2, 3);
    refused_effect(&s, vm_effect_stream_force(0, &stream), VM_STORED_STREAM);
    stream.from = NULL;
    stream.at.y = VM_NAN;
    refused_effect(&s, vm_effect_stream_force(0, &stream), VM_NOT_FINITE);
    s.bodies[0] = vm_scene_body_growing_plane(vm_scene_body_free(&body));
    CHECK(vm_scene_check(&s.scene, NULL) == VM_BAD_MOTION);
}

/* ---- Streams without a book ---- */

/* A scene has the same motion without a book, and with one more stream whose rate is 0. */
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
    for (first = VM_RELATIVE; first <= VM_AT_REST; first++) {
        check_shrinking(first, 0);
        check_shrinking(first, 1);
        check_shrinking(first, 100);
    }
    check_flat();
    check_jump(0);
    check_jump(1);
    check_gone_wrong();
    check_refusals();
    check_without_book();
    return check_finish("scene streams");
}
