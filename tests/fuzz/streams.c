/* Fuzz target: varmass.h, chapter 5, streams. Loads are finite and add up, right-hand sides agree with each other,
   closed forms with each other and with their limits, refusals change nothing. */
#include "bodies.h"

enum { STREAMS = 3 };

static void draw_streams(int n, vm_stream *streams, const vm_store *store)
{
    int i;
    memset(streams, 0, STREAMS * sizeof *streams);
    for (i = 0; i < n; i++) {
        vm_stream *s = streams + i;
        s->rate = MOSTLY(draw_in(-1, 1));
        s->motion = draw_byte() % 32 ? draw_below(4) : 9;
        s->at = draw_vector(1);
        s->velocity = draw_vector(3);
        if (draw_byte() & 1) {
            s->spin = draw_vector(2);
            s->gyration = draw_inertia(1, 0.3);
        }
        if (draw_byte() % 4 == 0) s->from = store;
    }
}

static int tame_stream(const vm_stream *s)
{
    return tame(s->rate) && tame3(s->at) && tame3(s->velocity) && tame3(s->spin) && tame(s->gyration.xx);
}

/* I' = sum M' (kappa + P(d)), d from the mass centre to the store or the crossing */
static void check_inertia_rate(int n, const vm_stream *streams, vm_vec3 centre, const vm_inertia *rate)
{
    double sum[6] = {0, 0, 0, 0, 0, 0}, scale = 0;
    int i;
    for (i = 0; i < n; i++) {
        const vm_stream *s = streams + i;
        const vm_vec3 at = s->from ? s->from->at : s->at;
        const vm_inertia *gyration = s->from ? &s->from->gyration : &s->gyration;
        const double x = (double)at.x - (double)centre.x, y = (double)at.y - (double)centre.y,
                     z = (double)at.z - (double)centre.z, r = size3(at) + size3(centre);
        add_inertia(sum, (double)s->rate, gyration);
        add_point_inertia(sum, (double)s->rate, x, y, z);
        scale += fabs((double)s->rate) * (trace_of(gyration) + r * r);
    }
    add_inertia(sum, -1, rate);
    for (i = 0; i < 6; i++) HOLDS(fabs(sum[i]) <= 16 * EPS * scale);
}

/* Mass that leaves or comes with the motion of the body does not turn it: moment and torque cancel, whatever inertia
   the mass has. The force is M omega x drift, because the mass centre moves in the body. */
static void check_quiet_streams(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams)
{
    const vm_vec3 none = {0, 0, 0};
    vm_stream quiet[STREAMS];
    vm_reactive sum;
    double scale = 0, turning = size3(body->omega);
    int i;
    for (i = 0; i < n; i++) {
        const double r = size3(streams[i].at) + size3(centre);
        quiet[i] = streams[i];
        quiet[i].motion = VM_RELATIVE;
        quiet[i].velocity = quiet[i].spin = none;
        scale += fabs((double)quiet[i].rate) * (trace_of(&quiet[i].gyration) + r * r) * turning;
    }
    if (vm_reactive_loads(body, centre, n, quiet, &sum)) return;
    HOLDS(size3(vm_add(sum.moment, sum.torque)) <= 32 * EPS * scale);
    HOLDS(within3(sum.force, vm_scale(body->mass, vm_cross(body->omega, sum.drift)),
                  32 * EPS * (size3(sum.force) + (double)body->mass * turning * size3(sum.drift)) +
                      32 * EPS * scale));
}

static void check_loads(void)
{
    const vm_body body = draw_body(1);
    const vm_vec3 centre = draw_vector(0.5), force = draw_vector(5), moment = draw_vector(5);
    const int n = draw_below(STREAMS + 1);
    vm_stream streams[STREAMS];
    vm_reactive sum, one;
    vm_vec3 a, b, total = {0, 0, 0};
    int i, status, all_tame = tame_body(&body) && tame3(centre);
    double scale = 0;
    draw_streams(n, streams, NULL);
    STAIN(sum);
    status = vm_reactive_loads(&body, centre, n, streams, &sum);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(sum));
        return;
    }
    for (i = 0; i < n; i++) {
        all_tame &= tame_stream(streams + i);
        status = vm_reactive_loads(&body, centre, 1, streams + i, &one);
        HOLDS(status == VM_OK || fuzz.wild); /* an overflow in one may be absent in the sum */
        if (status) return;
        total = vm_add(total, one.force);
        scale += size3(one.force) + fabs((double)streams[i].rate) *
                                        (size3(body.v) + size3(streams[i].velocity) + 4 * size3(body.omega));
    }
    if (all_tame) HOLDS(finite3(sum.force) && within3(sum.force, total, 8 * EPS * scale));
    if (all_tame) check_inertia_rate(n, streams, centre, &sum.inertia_rate);
    if (all_tame) check_quiet_streams(&body, centre, n, streams);
    STAIN(a);
    STAIN(b);
    status = vm_accelerations(&body, &sum, force, moment, &a, &b);
    if (status) {
        HOLDS(UNTOUCHED(a) && UNTOUCHED(b));
    } else if (all_tame && tame3(force)) {
        HOLDS(finite3(a) && within(a.x, (force.x + sum.force.x) / body.mass,
                                   8 * EPS * (double)((VM_FABS(force.x) + VM_FABS(sum.force.x)) / body.mass)));
    }
}

/* A random flow of a body with a store. Returns whether all its numbers are tame. */
static int draw_flow(vm_flow *flow, vm_stream *streams, vm_store *store)
{
    int i, all_tame;
    memset(flow, 0, sizeof *flow);
    store->at = draw_vector(1);
    store->gyration = draw_inertia(1, 0.3);
    flow->n = draw_below(STREAMS + 1);
    flow->streams = streams;
    draw_streams(flow->n, streams, store);
    flow->force = draw_vector(5);
    flow->moment = draw_vector(5);
    flow->centre = draw_vector(0.3);
    all_tame = tame3(flow->force) && tame3(flow->moment) && tame3(flow->centre) && tame3(store->at);
    for (i = 0; i < flow->n; i++) all_tame &= tame_stream(streams + i);
    return all_tame;
}

/* vm_flow_rhs of a tame state: the rates of mass and inertia are sums over the streams; vm_flow_balanced_rhs gives the same
   rates, and momentum and what was carried off stay. */
static void check_rates(const vm_body *body, vm_flow *flow, const vm_real *y, const vm_real *dydt)
{
    const vm_inertia inertia_rate = vmi_get_inertia(dydt + VM_Y_INERTIA);
    const double motion = 200 + 100 * size3(body->omega) + 100 * size3(body->v);
    vm_real balanced[VM_FLOW_BALANCED_STATES];
    double rate = 0, rates = 0;
    int i;
    HOLDS(vmi_all_finite(VM_FLOW_STATES, dydt));
    for (i = 0; i < flow->n; i++) {
        rate += (double)flow->streams[i].rate;
        rates += fabs((double)flow->streams[i].rate);
    }
    HOLDS(fabs((double)dydt[VM_Y_MASS] - rate) <= 4 * EPS * rates);
    check_inertia_rate(flow->n, flow->streams, vmi_get3(y + VM_Y_CENTRE), &inertia_rate);
    HOLDS(vm_flow_balanced_rhs(0, y, balanced, flow) == 0);
    for (i = 0; i < VM_FLOW_STATES; i++) HOLDS(within(balanced[i], dydt[i], 16 * EPS * (1 + fabs((double)dydt[i]))));
    for (i = 0; i < 3; i++) {
        const vm_real force = dydt[VM_Y_P + i];
        HOLDS(within(balanced[VM_Y_BALANCE + i], -force, 64 * EPS * (motion + fabs((double)force))));
    }
}

/* The shorter right-hand sides are finite where the numbers are tame; a negative mass gives NaN and a reason. */
static void check_shorter_flows(const vm_body *body, vm_flow *flow, vm_real *y, int all_tame)
{
    vm_real dydt[VM_FLOW_BALANCED_STATES];
    int i;
    flow->mass = body->mass;
    flow->inertia = body->inertia;
    flow->drift = draw_vector(0.1);
    flow->status = 0;
    if (vm_flow_given_rhs(0, y, dydt, flow) == 0 && all_tame && flow->status == 0)
        HOLDS(vmi_all_finite(VM_FLOW_GIVEN_STATES, dydt));
    flow->status = 0;
    if (vm_flow_carried_rhs(0, y, dydt, flow) == 0 && all_tame && tame3(flow->drift) && flow->status == 0)
        HOLDS(vmi_all_finite(VM_FLOW_GIVEN_STATES, dydt));
    flow->status = 0;
    for (i = 0; i < 6; i++) y[i] = draw_in(-2, 2);
    y[6] = MOSTLY(draw_in(-1, 5));
    if (vm_translation_rhs(0, y, dydt, flow) == 0 && all_tame && y[6] > R(1e-3) && flow->status == 0)
        HOLDS(vmi_all_finite(VM_TRANSLATION_STATES, dydt));
    y[VM_Y_MASS] = -1;
    flow->status = 0;
    if (vm_flow_rhs(0, y, dydt, flow) == 0) HOLDS(flow->status < 0 && !vmi_all_finite(VM_FLOW_STATES, dydt));
}

static void check_flow(void)
{
    const vm_body body = draw_body(1);
    vm_store store;
    vm_stream streams[STREAMS];
    vm_flow flow;
    vm_real y[VM_FLOW_BALANCED_STATES], dydt[VM_FLOW_BALANCED_STATES];
    vm_body back;
    const int all_tame = draw_flow(&flow, streams, &store) && tame_body(&body);
    int status;
    memset(y, 0, sizeof y);
    fuzz_stain(y, VM_FLOW_STATES * sizeof *y);
    status = vm_flow_start(&flow, &body, y);
    if (status) {
        HOLDS(status < 0 && fuzz_stained(y, VM_FLOW_STATES * sizeof *y));
        return;
    }
    HOLDS(vmi_all_finite(VM_FLOW_STATES, y) && y[VM_Y_MASS] == body.mass);
    STAIN(back);
    status = vm_flow_body(&flow, VM_FLOW_STATES, y, &back);
    if (all_tame) HOLDS(status == VM_OK);
    if (all_tame) HOLDS(within3(back.v, body.v, 8 * EPS * size3(body.v)) && within3(back.r, body.r, 0));
    HOLDS(vm_flow_mass_left(0, y, &flow) == y[VM_Y_MASS] - flow.least_mass);
    HOLDS(!is_nan(vm_flow_inertia_left(0, y, &flow)) || !all_tame);
    if (vm_flow_rhs(0, y, dydt, &flow) == 0 && all_tame && flow.status == 0) check_rates(&body, &flow, y, dydt);
    check_shorter_flows(&body, &flow, y, all_tame);
}

/* In the plane, I' = sum M' (kappa + d^2); and with streams that move on with the body, H' = I' omega + M_S. */
static void check_inertia_rate2(vm_flow2 *flow, const vm_real *y, const vm_real *dydt)
{
    vm_real quiet[VM_FLOW2_STATES];
    double sum = 0, scale = 0, omega = (double)y[5] / (double)y[9];
    int i;
    for (i = 0; i < flow->n; i++) {
        vm_stream2 *s = flow->streams + i;
        const double dx = (double)s->x - (double)y[7], dy = (double)s->y - (double)y[8];
        sum += (double)s->rate * ((double)s->gyration + dx * dx + dy * dy);
        scale += fabs((double)s->rate) * ((double)s->gyration + 32); /* |d| < 2 + 4 */
        s->motion = VM_RELATIVE;
        s->vx = s->vy = s->spin = 0;
    }
    HOLDS(fabs(sum - (double)dydt[9]) <= 16 * EPS * scale);
    HOLDS(vm_flow2_rhs(0, y, quiet, flow) == 0);
    HOLDS(fabs((double)quiet[5] - (double)flow->moment - sum * omega) <=
          16 * EPS * (scale * fabs(omega) + fabs((double)flow->moment)));
}

static void check_plane_and_line(void)
{
    vm_stream2 streams[STREAMS];
    vm_stream1 line[STREAMS];
    vm_flow2 flow;
    vm_flow1 flow1;
    vm_real y[VM_FLOW2_STATES], dydt[VM_FLOW2_STATES];
    int i, all_tame = 1;
    memset(&flow, 0, sizeof flow);
    memset(&flow1, 0, sizeof flow1);
    memset(streams, 0, sizeof streams);
    flow.n = flow1.n = draw_below(STREAMS + 1);
    flow.streams = streams;
    flow1.streams = line;
    for (i = 0; i < flow.n; i++) {
        streams[i].rate = MOSTLY(draw_in(-1, 1));
        streams[i].motion = draw_below(4);
        streams[i].x = draw_in(-1, 1);
        streams[i].y = draw_in(-1, 1);
        streams[i].vx = draw_in(-3, 3);
        streams[i].vy = draw_in(-3, 3);
        streams[i].gyration = draw_in(0, 0.1);
        line[i].rate = streams[i].rate;
        line[i].velocity = streams[i].vx;
        line[i].motion = streams[i].motion;
        all_tame &= tame(streams[i].rate);
    }
    flow.fx = MOSTLY(draw_in(-5, 5));
    flow1.force = flow.fx;
    flow.moment = draw_in(-5, 5);
    for (i = 0; i < VM_FLOW2_STATES; i++) y[i] = draw_in(-2, 2);
    y[6] = MOSTLY(draw_in(0.1, 10));
    y[9] = MOSTLY(draw_in(0.1, 10));
    all_tame = all_tame && tame(flow.fx) && tame(y[6]) && tame(y[9]) && y[6] > R(1e-3) && y[9] > R(1e-3);
    if (vm_flow2_rhs(0, y, dydt, &flow) == 0 && all_tame) {
        HOLDS(vmi_all_finite(VM_FLOW2_STATES, dydt) && flow.status == 0);
        check_inertia_rate2(&flow, y, dydt);
    }
    y[2] = y[6];
    if (vm_flow1_rhs(0, y, dydt, &flow1) == 0 && all_tame) HOLDS(vmi_all_finite(VM_FLOW1_STATES, dydt) && flow1.status == 0);
    y[2] = -y[2];
    if (vm_flow1_rhs(0, y, dydt, &flow1) == 0 && y[2] <= 0) HOLDS(!vmi_all_finite(VM_FLOW1_STATES, dydt));
}

/* A rocket: what it throws backwards drives it forward, and momentum stays: m v - m0 v0 is the integral of the
   absolute velocity v + w of what joins over its mass, in s = ln m by Gauss' rule of five points, which is exact to
   3e-13 (v0 + w (2 + s)) e^s of the integrand for |s| <= 1. */
static void check_rocket(vm_real v0, vm_real m0, vm_real m, vm_real w)
{
    static const double at[5] = {0, 0.538469310105683091, -0.538469310105683091, 0.906179845938663993,
                                 -0.906179845938663993};
    static const double weight[5] = {0.568888888888888889, 0.478628670499366468, 0.478628670499366468,
                                     0.236926885056189088, 0.236926885056189088};
    const double v = (double)vm_tsiolkovsky(v0, m0, m, w), span = log((double)m / (double)m0), m_0 = (double)m0;
    const double speeds = fabs((double)v0) + 3 * fabs((double)w), momenta = ((double)m + m_0) * speeds;
    double brought = 0;
    int i;
    HOLDS((v - (double)v0) * (double)w * ((double)m - m_0) >= 0);
    if (!(fabs(span) <= 1)) return;
    for (i = 0; i < 5; i++) {
        const double mass = (double)R(m_0 * exp(span * (1 + at[i]) / 2));
        brought += weight[i] / 2 * span * mass * ((double)vm_tsiolkovsky(v0, m0, R(mass), w) + (double)w);
    }
    HOLDS(fabs((double)m * v - m_0 * (double)v0 - brought) <= (1e-11 + 32 * EPS) * momenta);
}

static void check_closed_forms(void)
{
    const vm_real v0 = MOSTLY(draw_in(-5, 5)), m0 = MOSTLY(draw_log(1e-2, 1e2)), m = MOSTLY(draw_log(1e-2, 1e2));
    const vm_real u = MOSTLY(draw_in(-5, 5)), impulse = MOSTLY(draw_in(-5, 5)), t = MOSTLY(draw_in(0, 10));
    const vm_real force = MOSTLY(draw_in(-5, 5));
    const vm_real levi = vm_velocity_by_momentum(v0, m0, m, u, impulse), tsiolkovsky = vm_tsiolkovsky(v0, m0, m, u);
    vm_stream1 stream;
    vm_real x, v;
    int status;
    if (!(m > 0) || !(m0 > 0) || !is_finite(m) || !is_finite(m0) || !is_finite(v0) || !is_finite(u))
        HOLDS(is_nan(levi) && is_nan(tsiolkovsky));
    else if (tame(v0) && tame(u) && tame(m) && tame(m0) && tame(impulse)) {
        HOLDS(is_finite(levi) && is_finite(tsiolkovsky));
        if (impulse == 0) HOLDS(levi >= (v0 < u ? v0 : u) - VM_EPSILON * 16 * (VM_FABS(u) + VM_FABS(v0)) || m < m0);
        HOLDS(within(vm_tsiolkovsky(tsiolkovsky, m, m0, u), v0,
                     16 * EPS * (fabs((double)v0) + fabs((double)tsiolkovsky) + 10 * fabs((double)u))));
        HOLDS(within(vm_tsiolkovsky(v0, m, m, u), v0, 0));
        check_rocket(v0, m0, m, u);
    }
    stream.rate = MOSTLY(draw_in(-1, 1));
    stream.velocity = u;
    stream.motion = draw_below(5);
    STAIN(x);
    STAIN(v);
    status = vm_linear_flow(&stream, t, 0, v0, m0, force, &x, &v);
    if (status) HOLDS(status < 0 && UNTOUCHED(x) && UNTOUCHED(v));
    else {
        HOLDS(is_finite(x) && is_finite(v) && m0 > 0 && stream.motion <= VM_AT_REST);
        if (tame(v0) && tame(m0) && tame(t) && tame(u) && force == 0 && stream.motion == VM_RELATIVE &&
            tame(stream.rate))
            HOLDS(within(v, vm_tsiolkovsky(v0, m0, m0 + stream.rate * t, u),
                         64 * EPS *
                             (fabs((double)v0) + fabs((double)u) * (10 + (double)(m0 / (m0 + stream.rate * t))))));
    }
}

static void check_jet(void)
{
    const vm_vec3 omega0 = draw_vector(3);
    const vm_real t = MOSTLY(draw_in(0, 5));
    vm_jet jet;
    vm_vec3 omega;
    int status;
    jet.rate = MOSTLY(draw_in(-1, 1));
    jet.axial = MOSTLY(draw_log(0.1, 10));
    jet.transverse = MOSTLY(draw_log(0.1, 10));
    jet.gyration_axial = MOSTLY(draw_in(0, 1));
    jet.gyration_transverse = MOSTLY(draw_byte() % 4 ? draw_in(0, 1) : 0);
    jet.gyration_out = MOSTLY(draw_in(0, 1));
    jet.nozzle = MOSTLY(draw_in(0, 2));
    STAIN(omega);
    status = vm_jet_damping(&jet, t, omega0, &omega);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(omega));
        return;
    }
    HOLDS(finite3(omega) && same_bits(omega.z, omega0.z) && jet.axial > 0 && jet.transverse > 0);
    HOLDS(vm_jet_damping(&jet, 0, omega0, &omega) == VM_OK);
    if (tame3(omega0)) HOLDS(within3(omega, omega0, 8 * EPS * size3(omega0)));
}

/* d(m c)/dm = s and dI/dm = Q + P(s - c) for whatever is left of a supply */
static void check_supply(void)
{
    vm_supply s;
    vm_supply_left left;
    vm_inertia growth;
    vm_vec3 store;
    const vm_real mass = MOSTLY(draw_in(0, 10));
    double size;
    int status;
    s.kind = draw_below(4);
    s.at = draw_vector(2);
    s.axis = draw_vector(1);
    s.length = MOSTLY(draw_log(0.1, 10));
    s.radius = MOSTLY(draw_log(0.1, 10));
    s.bore = MOSTLY(draw_in(0, 1)) * s.radius;
    s.full = MOSTLY(draw_log(1, 100));
    STAIN(left);
    status = vm_supply_at(&s, mass, &left);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(left));
        return;
    }
    HOLDS(s.kind <= VM_GRAIN && s.full > 0 && s.length > 0 && s.radius > 0 && left.mass == mass);
    if (!tame(mass) || !tame3(s.at) || !tame(s.length) || !tame(s.radius) || !tame(s.full)) return;
    if (!(mass >= 0 && mass <= s.full)) return;
    store = vm_add(left.centre, vm_scale(mass, left.centre_by_mass));
    HOLDS(within3(store, left.store.at, 16 * EPS * (size3(s.at) + (double)s.length)));
    growth = vmi_inertia_plus(left.store.gyration, 1, vmi_inertia_of_point(vm_sub(left.store.at, left.centre)));
    size = (double)(s.length * s.length + s.radius * s.radius) + size3(s.at) * (double)s.length;
    HOLDS(within(growth.xx, left.inertia_by_mass.xx, 16 * EPS * size));
    HOLDS(within(growth.yz, left.inertia_by_mass.yz, 16 * EPS * size));
    if (mass > 0) HOLDS(vm_inertia_is_possible(&left.inertia));
}

/* Energy and angular momentum of an orbit; Meshchersky's law with the rate 0 is the orbit */
static void check_orbit(void)
{
    const vm_vec3 r0 = draw_vector(2), v0 = draw_vector(2);
    const vm_real t = MOSTLY(draw_in(-5, 5)), mu = MOSTLY(draw_log(0.1, 10)), rate = MOSTLY(draw_in(-1, 1));
    vm_vec3 r, v, s, w;
    double size, speed, slope;
    int status;
    STAIN(r);
    STAIN(v);
    status = vm_orbit_meshchersky(t, mu, rate, r0, v0, &r, &v);
    if (status) HOLDS(status < 0 && UNTOUCHED(r) && UNTOUCHED(v));
    else HOLDS(finite3(r) && finite3(v) && mu > 0);
    STAIN(r);
    STAIN(v);
    status = vm_orbit(t, mu, r0, v0, &r, &v);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(r) && UNTOUCHED(v));
        return;
    }
    HOLDS(finite3(r) && finite3(v) && mu > 0);
    HOLDS(vm_orbit_meshchersky(t, mu, 0, r0, v0, &s, &w) == VM_OK && within3(s, r, 0) && within3(w, v, 0));
    if (!tame3(r0) || !tame3(v0) || !tame(mu) || !(VM_FABS(t) <= 5)) return;
    if (size3(r0) < 0.1 || size3(r) < 0.1 || size3(vm_cross(r0, v0)) < 0.1) return;
    size = size3(r0) + size3(r);
    speed = size3(v0) + size3(v);
    slope = size3(r0) * size3(v0) / size3(vm_cross(r0, v0)); /* large on a nearly straight way to the centre */
    HOLDS(within3(vm_cross(r, v), vm_cross(r0, v0), 4096 * EPS * size * speed * larger(1, slope * slope / 256)));
}

static void fuzz_streams(void)
{
    switch (draw_below(7)) {
    case 0: check_loads(); break;
    case 1: check_plane_and_line(); break;
    case 2: check_closed_forms(); break;
    case 3: check_jet(); break;
    case 5: check_supply(); break;
    case 6: check_orbit(); break;
    default: check_flow();
    }
}
FUZZ_TARGET(streams)
