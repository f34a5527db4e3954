/* Chapter 5 of varmass.h: streams, stores and their reactive loads, and the accelerations of the body.
   Oracles: the reference case E1 in 22 digits, equations (161)-(170) written out by hand, and the limits of small
   jumps, which are computed by vm_separate and vm_attach. The equations that the dissertation prints wrongly are
   evaluated as printed and must miss. */
#include "streams.h"

/* ---- Case E1: one stream at one instant ---- */

/* The reactive force, moment and torque, the drift and the accelerations (154)-(160) */
static void test_e1_loads(void)
{
    const vm_body b = case_e1();
    const vm_stream s = case_e1_stream();
    const vm_vec3 force = vector(0, 0, -58.86), torque = vector(.1, 0, .2);
    const vm_vec3 true_domega =
        vector(-0.03119529795158286778399, -0.05223463687150837988827, 0.259429702048417132216);
    const double bound = 20 * eps;
    vm_reactive loads;
    vm_vec3 dv, domega, printed;
    CHECK(vm_reactive_loads(&b, vector(0, 0, 0), 1, &s, &loads) == VM_OK);
    CHECK(vm_accelerations(&b, &loads, force, torque, &dv, &domega) == VM_OK);
    check_error("force (156)", "E1", "abs", apart(loads.force, vector(-.45, .3, -.2)), bound, 0, 0);
    check_error("moment (158)", "E1", "abs", apart(loads.moment, vector(-.06, -.08, .015)), bound, 0, 0);
    check_error("torque (157)", "E1", "abs", apart(loads.torque, vector(-.0675, .1015, .088)), bound, 0, 0);
    check_error("v' (154),(159)", "E1", "abs", apart(dv, vector(-.075, .05, -9.843333333333333333333)), 4 * bound,
                0, 0);
    check_error("omega' (155),(160)", "E1", "abs", apart(domega, true_domega), bound, 0, 0);
    check_error("r' = v + drift", "E1", "abs",
                apart(vm_add(b.v, loads.drift), vector(.05833333333333333333333, .225, -.1333333333333333333333)),
                bound, 0, 0);
    /* (157) as printed multiplies the whole rate of inertia, that of the place of the stream too, by the spin */
    printed = vmi_inertia_times(&loads.inertia_rate, vm_sub(s.spin, b.omega));
    check_error("(157) printed", "E1", "abs", apart(printed, vector(-.03, .244, .148)), bound, 0, 0);
    ERRATUM("(138) I_S2=dI, (150),(152),(155),(157),(160)", apart(printed, loads.torque) > .15,
            check_holds("torque (157)") && check_holds("omega' (155),(160)"));
}

/* A stream at the mass centre has neither moment nor drift, and (157) is right as printed. */
static void test_e1_at_the_centre(void)
{
    const vm_body b = case_e1();
    vm_stream s = case_e1_stream();
    vm_reactive loads;
    vm_vec3 printed;
    s.at = vector(0, 0, 0);
    CHECK(vm_reactive_loads(&b, s.at, 1, &s, &loads) == VM_OK);
    printed = vmi_inertia_times(&loads.inertia_rate, vm_sub(s.spin, b.omega));
    check_error("(157) printed", "at the centre", "abs", apart(printed, loads.torque), 20 * eps, 0, 0);
    CHECK(size_of(loads.moment) == 0 && size_of(loads.drift) == 0);
}

/* The rates of momentum and angular momentum (151)-(153), (227)-(232), by vm_flow_rhs */
static void test_e1_rates_of_momenta(void)
{
    const vm_body b = case_e1();
    vm_stream s = case_e1_stream();
    const vm_vec3 force = vector(0, 0, -58.86), torque = vector(.1, 0, .2);
    const double bound = 20 * eps;
    vm_flow flow = {0};
    vm_real y[VM_FLOW_STATES], dy[VM_FLOW_STATES];
    vm_vec3 p_rate, h_rate, outer, dv, domega, expected, printed;
    vm_reactive loads;
    CHECK(vm_reactive_loads(&b, vector(0, 0, 0), 1, &s, &loads) == VM_OK);
    CHECK(vm_accelerations(&b, &loads, force, torque, &dv, &domega) == VM_OK);
    flow.n = 1;
    flow.streams = &s;
    flow.force = force;
    flow.moment = torque;
    CHECK(vm_flow_start(&flow, &b, y) == VM_OK && vm_flow_rhs(0, y, dy, &flow) == 0);
    p_rate = vmi_get3(dy + VM_Y_P);
    h_rate = vmi_get3(dy + VM_Y_H);
    check_error("(Mv)' (151),(227)", "E1", "abs", apart(p_rate, vm_add(force, vm_scale(s.rate, s.velocity))),
                64 * bound, 0, 0);
    outer = vm_add(torque, loads.moment);
    expected = vm_add(outer, vm_scale(s.rate, vmi_inertia_times(&s.gyration, s.spin)));
    check_error("(IW)' (152),(228)", "E1", "abs", apart(h_rate, expected), bound, 0, 0);
    /* (228), (229) print I' Omega_2 */
    printed = vm_add(outer, vmi_inertia_times(&loads.inertia_rate, s.spin));
    ERRATUM("(227)-(229)", apart(h_rate, printed) > .15,
            check_holds("(Mv)' (151),(227)") && check_holds("(IW)' (152),(228)"));
    /* (153) is I' omega + I omega' + omega x I omega; (230)-(232) leave the last term out */
    printed = vm_add(vmi_inertia_times(&loads.inertia_rate, b.omega), vmi_inertia_times(&b.inertia, domega));
    expected = vm_add(printed, vm_cross(b.omega, vmi_inertia_times(&b.inertia, b.omega)));
    check_error("(IW)' (153),(230)", "E1", "abs", apart(h_rate, expected), bound, 0, 0);
    ERRATUM("(230)-(232)", apart(h_rate, printed) > .1, check_holds("(IW)' (153),(230)"));
}

/* ---- Equations by components ---- */

/* (161)-(165): the components in principal axes. (163), (164) hold where these axes stay principal axes, that is
   where the inertia that leaves has no products of inertia. */
static void test_components(void)
{
    const double A = 2, B = 1.5, C = 1.25, p = .25, q = -.5, r = .75, p2 = 1, q2 = -.75, r2 = .5, rate = -.5;
    const vm_vec3 F = vector(2, -3, .5), M = vector(.25, .75, -.5);
    vm_body b = case_e1();
    vm_stream s = case_e1_stream();
    vm_reactive loads;
    vm_vec3 dv = vector(0, 0, 0), domega = dv;
    b.inertia = tensor(A, B, C, 0, 0, 0);
    b.omega = vector(p, q, r);
    s.spin = vector(p2, q2, r2);
    s.at = vector(0, 0, 0);
    s.gyration = tensor(.25, .5, .125, 0, 0, 0);
    CHECK(!vm_reactive_loads(&b, s.at, 1, &s, &loads) && !vm_accelerations(&b, &loads, F, M, &dv, &domega));
    check_error("(161),(162)", "principal", "abs",
                apart(vm_scale(6, dv), vector(2 + rate * (1 - .1), -3 + rate * (-.4 - .2), .5 + rate * (.3 + .1))),
                30 * eps, 0, 0);
    check_error("(163),(164)", "principal", "abs",
                apart(domega, vector((.25 + rate * .25 * (p2 - p) - (C - B) * q * r) / A,
                                     (.75 + rate * .5 * (q2 - q) - (A - C) * p * r) / B,
                                     (-.5 + rate * .125 * (r2 - r) - (B - A) * p * q) / C)),
                8 * eps, 0, 0);
    /* a product of inertia that leaves adds I'_xy (q2 - q) to the first component */
    s.gyration.xy = R(.0625);
    CHECK(!vm_reactive_loads(&b, s.at, 1, &s, &loads));
    check_error("(164) + I'_xy", "principal", "abs",
                fabs((double)loads.torque.x - rate * (.25 * (p2 - p) + .0625 * (q2 - q))), 8 * eps, 0, 0);
    ERRATUM("(163),(164)", fabs((double)loads.torque.x - rate * .25 * (p2 - p)) > .005,
            check_holds("(163),(164)") && check_holds("(164) + I'_xy"));
    /* (165): the mass is constant where there is no stream */
    CHECK(!vm_reactive_loads(&b, s.at, 0, NULL, &loads) && !vm_accelerations(&b, &loads, F, M, &dv, &domega));
    CHECK(size_of(loads.force) + size_of(loads.moment) + size_of(loads.torque) == 0);
    check_error("(165)", "principal", "abs", apart(dv, vm_scale(1 / R(6), F)), 2 * eps, 0, 0);
}

/* (167)-(169): mass leaves with velocity 0. (170): it leaves at the mass centre too, as if there were no stream. */
static void test_at_rest(void)
{
    tank k;
    vm_reactive loads;
    vm_real y[VM_FLOW_STATES], z[VM_FLOW_STATES], dy[VM_FLOW_STATES], dz[VM_FLOW_STATES];
    vm_vec3 moment, from_centre;
    tank_init(&k);
    k.stream.motion = VM_AT_REST;
    k.flow.force = vector(1, 2, 3);
    k.flow.moment = vector(.1, .2, .3);
    CHECK(!vm_flow_start(&k.flow, &k.body, y) && !vm_flow_rhs(0, y, dy, &k.flow));
    CHECK(!vm_reactive_loads(&k.body, k.flow.centre, 1, &k.stream, &loads));
    from_centre = vm_sub(k.stream.at, k.flow.centre);
    moment = vm_cross(from_centre, vm_scale(k.stream.rate, k.body.v));
    check_error("(167)", "at rest", "eps", apart(vmi_get3(dy + VM_Y_P), k.flow.force) / eps, 4, 0, 0);
    /* the moment is -SS2 x v M'; printed with the other sign */
    check_error("(168),(169)", "at rest", "eps",
                apart(vmi_get3(dy + VM_Y_H), vm_sub(k.flow.moment, moment)) / eps, 2, 0, 0);
    ERRATUM("(168),(169)", apart(vmi_get3(dy + VM_Y_H), vm_add(k.flow.moment, moment)) > size_of(moment),
            check_holds("(168),(169)"));
    k.stream.at = k.flow.centre;
    CHECK(!vm_flow_rhs(0, y, dy, &k.flow));
    k.flow.n = 0;
    CHECK(!vm_flow_start(&k.flow, &k.body, z) && !vm_flow_given_rhs(0, z, dz, &k.flow));
    check_error("(170)", "without streams", "eps", apart(vmi_get3(dy + VM_Y_H), vmi_get3(dz + VM_Y_H)) / eps, 1,
                0, 0);
    check_error("(170)", "without streams", "eps", apart(vmi_get3(dy + VM_Y_P), vmi_get3(dz + VM_Y_P)) / eps, 2,
                0, 0);
}

/* ---- Sums of streams ---- */

/* Two streams that differ in the sign of their rates must leave no residue. */
static void test_opposite_streams(void)
{
    scene k;
    vm_reactive loads;
    vm_stream pair[2];
    int i;
    scene_init(&k);
    for (i = 0; i < SCENE_STREAMS; i++) {
        pair[0] = k.streams[i];
        pair[1] = k.streams[i];
        pair[1].rate = -pair[0].rate;
        CHECK(!vm_reactive_loads(&k.body, k.flow.centre, 2, pair, &loads));
        /* the sums are exactly 0 unless the compiler fuses a product with the sum */
        check_error("opposite streams", "loads", "eps",
                    (size_of(loads.force) + size_of(loads.moment) + size_of(loads.torque) + size_of(loads.drift)) /
                        eps,
                    8, i, 0);
        CHECK(loads.mass_rate == 0 &&
              fabs((double)loads.inertia_rate.xx) + fabs((double)loads.inertia_rate.xy) <= eps);
    }
}

/* Two jets against each other on a body at rest make a couple and no force. */
static void test_couple_of_jets(void)
{
    vm_body b = case_e1();
    vm_stream jets[2];
    vm_reactive loads;
    memset(jets, 0, sizeof jets);
    b.omega = vector(0, 0, 0);
    jets[0].rate = R(-.5);
    jets[0].at = vector(0, 1, 0);
    jets[0].velocity = vector(10, 0, 0);
    jets[1].rate = R(-.5);
    jets[1].at = vector(0, -1, 0);
    jets[1].velocity = vector(-10, 0, 0);
    CHECK(!vm_reactive_loads(&b, vector(0, 0, 0), 2, jets, &loads));
    CHECK(size_of(loads.force) == 0 && size_of(loads.drift) == 0);
    CHECK((double)loads.moment.z == 10 && loads.mass_rate == -1);
}

/* ---- Limits of small jumps ---- */

/* What the stream carries in the time dt, as a part that joins or leaves the body */
static vm_body part_of_stream(const vm_body *b, const vm_stream *s, double mass)
{
    const vmi_mat3 turn = vmi_rotation(b->q);
    const vm_vec3 from_centre = vmi_times(&turn, s->at);
    vm_body part = *b;
    part.mass = R(mass);
    part.r = vm_add(b->r, from_centre);
    part.inertia = vmi_stream_own(part.mass, &s->gyration);
    part.v = vmi_vec3(0, 0, 0);
    part.omega = vmi_vec3(0, 0, 0);
    if (s->motion == VM_RELATIVE || s->motion == VM_CARRIED) {
        part.v = vm_add(b->v, vm_cross(b->omega, from_centre));
        part.omega = b->omega;
    }
    if (s->motion == VM_RELATIVE) {
        part.v = vm_add(part.v, vmi_times(&turn, s->velocity));
        part.omega = vm_add(part.omega, vmi_times(&turn, s->spin));
    }
    if (s->motion == VM_ABSOLUTE) {
        part.v = s->velocity;
        part.omega = s->spin;
    }
    return part;
}

/* One jump under the force F and the moment M: the changes of momentum, angular momentum and energy over dt are the
   rates (133)-(149), and T' is the limit of (113), (118). */
static void check_small_jump(const vm_body *body, vm_flow *flow, int motion, int sign)
{
    const double dt = PICK(1e-6, 1e-2);
    const vm_vec3 F = vector(1, -2, 3), M = vector(.5, .25, -1);
    vm_real y[VM_FLOW_BALANCED_STATES] = {0}, dy[VM_FLOW_BALANCED_STATES] = {0};
    vm_body part, after;
    vm_impulse outer;
    vm_vec3 p_rate, h_rate;
    double energy_rate;
    flow->streams->rate = R(.5 * sign);
    flow->force = F;
    flow->moment = M;
    CHECK(!vm_flow_start(flow, body, y) && !vm_flow_balanced_rhs(0, y, dy, flow));
    part = part_of_stream(body, flow->streams, .5 * dt);
    outer.linear = vm_scale(R(dt), F);
    outer.couple = vm_scale(R(dt), M);
    outer.at = body->r;
    CHECK((sign > 0 ? vm_attach : vm_separate)(body, &part, &outer, &after) == VM_OK);
    p_rate = vm_scale(R(1 / dt), vm_sub(vm_momentum(&after), vm_momentum(body)));
    h_rate = vm_scale(R(1 / dt), vm_sub(vmi_spin_momentum(&after), vmi_spin_momentum(body)));
    energy_rate = (double)(vm_kinetic_energy(&after) - vm_kinetic_energy(body)) / dt;
    check_error("p' (140),(145),(149)", "one jump", "abs", apart(p_rate, vmi_get3(dy + VM_Y_P)), PICK(2e-8, 2e-3),
                motion, sign);
    check_error("H' (144),(146),(148)", "one jump", "abs", apart(h_rate, vmi_get3(dy + VM_Y_H)), PICK(1e-5, 8e-2),
                motion, sign);
    check_error("T' (113),(118)", "one jump", "abs", fabs(energy_rate + (double)dy[VM_Y_BALANCE + 6]),
                PICK(2e-4, 2), motion, sign);
    if (motion == VM_CARRIED && sign < 0) { /* (143) is r_S x dK = r_S x F dt; it is printed without dt */
        const vm_vec3 moment = vm_cross(body->r, F), change = vm_cross(body->r, outer.linear);
        check_error("(143)", "one jump", "abs", apart(change, vm_scale(R(dt), moment)), 1e-6, 0, 0);
        ERRATUM("(143)", apart(change, moment) > 1, check_holds("(143)"));
    }
}

static void test_small_jumps(void)
{
    scene k;
    int i;
    scene_init(&k);
    k.flow.update = NULL;
    k.flow.centre = vector(0, 0, 0);
    k.flow.n = 1;
    for (i = 0; i < SCENE_STREAMS; i++) {
        k.flow.streams = k.streams + i;
        check_small_jump(&k.body, &k.flow, i, -1);
        check_small_jump(&k.body, &k.flow, i, 1);
    }
}

/* One jump of the tank: a part of this mass leaves as the stream does. */
static void tank_loses_part(const tank *k, vm_real mass, vm_body *b, vm_vec3 *centre)
{
    const vm_vec3 from_centre = vm_sub(k->stream.at, *centre);
    const vmi_mat3 turn = vmi_rotation(b->q);
    const vm_vec3 dragging = vm_cross(vmi_times_transposed(&turn, b->omega), from_centre);
    vm_body part = *b;
    part.mass = mass;
    part.r = vm_add(b->r, vmi_times(&turn, from_centre));
    part.v = vm_add(b->v, vmi_times(&turn, vm_add(k->stream.velocity, dragging)));
    part.omega = vm_add(b->omega, vmi_times(&turn, k->stream.spin));
    part.inertia = vmi_stream_own(part.mass, &k->stream.gyration);
    CHECK(vm_separate(b, &part, NULL, b) == VM_OK);
    *centre = vm_sub(*centre, vm_scale(part.mass / b->mass, from_centre));
}

enum { OMEGA, VELOCITY, PLACE, QUANTITIES };

/* omega and v in body axes, and r */
static void quantities_of(const vm_body *b, vm_vec3 *quantity)
{
    const vmi_mat3 turn = vmi_rotation(b->q);
    quantity[OMEGA] = vmi_times_transposed(&turn, b->omega);
    quantity[VELOCITY] = vmi_times_transposed(&turn, b->v);
    quantity[PLACE] = b->r;
}

/* Case E3 by jumps at the middles of equal intervals of time, between which the rest moves freely */
static void tank_by_jumps(long jumps, vm_vec3 *quantity)
{
    const double step = 3. / (double)jumps;
    tank k;
    vm_real y[VM_FLOW_STATES];
    vm_vec3 centre;
    vm_body b;
    long i;
    tank_init(&k);
    b = k.body;
    centre = k.flow.centre;
    k.flow.n = 0;
    for (i = 0; i < 2 * jumps; i++) {
        vm_real work[RK4_WORK(VM_FLOW_STATES)], t = 0;
        CHECK(vm_flow_start(&k.flow, &b, y) == VM_OK);
        CHECK(rk4_solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, &t, R(step / 2), 1, y, work) == 0);
        CHECK(vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b) == VM_OK);
        if (i % 2 == 0) tank_loses_part(&k, R(.5 * step), &b, &centre);
    }
    quantities_of(&b, quantity);
}

/* The error of N jumps is of the order 1/N, and what two extrapolations leave is the motion by vm_flow_rhs. */
static void test_jump_limit(void)
{
    static const char *names[QUANTITIES] = {"omega", "v", "r"};
    const long jumps = PICK(400, 25);
    vm_vec3 jumped[3][QUANTITIES], exact[QUANTITIES];
    tank k;
    vm_real y[VM_FLOW_STATES];
    vm_body b;
    int i;
    tank_init(&k);
    vm_flow_start(&k.flow, &k.body, y);
    solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 3);
    vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b);
    quantities_of(&b, exact);
    for (i = 0; i < 3; i++) tank_by_jumps(jumps << i, jumped[i]);
    for (i = 0; i < QUANTITIES; i++) {
        const vm_vec3 once = vm_sub(vm_scale(2, jumped[1][i]), jumped[0][i]);
        const vm_vec3 again = vm_sub(vm_scale(2, jumped[2][i]), jumped[1][i]);
        const vm_vec3 limit = vm_scale(R(1 / 3.), vm_sub(vm_scale(4, again), once));
        const double ratio = apart(jumped[0][i], exact[i]) / apart(jumped[1][i], exact[i]);
        check_error("order of jumps", names[i], "1", fabs(ratio - 2), PICK(.02, .2), ratio, 0);
        check_error("limit of jumps", names[i], "abs", apart(limit, exact[i]), PICK(2e-9, 2e-4), 0, 0);
    }
}

/* ---- Refusals ---- */

/* vm_flow_start and vm_reactive_loads refuse the scene's body and streams with this status and write nothing. */
static void check_refused(scene *k, int expected)
{
    vm_real y[VM_FLOW_STATES], kept[VM_FLOW_STATES];
    vm_reactive loads, loads_kept;
    memset(y, 1, sizeof y);
    memset(kept, 1, sizeof kept);
    memset(&loads, 1, sizeof loads);
    memset(&loads_kept, 1, sizeof loads_kept);
    k->flow.streams = k->streams;
    CHECK(vm_flow_start(&k->flow, &k->body, y) == expected && !memcmp(y, kept, sizeof y));
    CHECK(vm_reactive_loads(&k->body, vector(0, 0, 0), SCENE_STREAMS, k->streams, &loads) == expected &&
          !memcmp(&loads, &loads_kept, sizeof loads));
}

static void test_not_finite(void)
{
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    scene k, good;
    int i;
    scene_init(&good);
    for (i = 0; i < 3; i++) {
        k = good;
        k.streams[2].rate = R(bad[i]);
        check_refused(&k, VM_NOT_FINITE);
        k = good;
        k.streams[1].velocity.y = R(bad[i]);
        check_refused(&k, VM_NOT_FINITE);
        k = good;
        k.streams[3].gyration.xy = R(bad[i]);
        check_refused(&k, VM_NOT_FINITE);
        k = good;
        k.body.mass = R(bad[i]);
        check_refused(&k, VM_NOT_FINITE);
        k = good;
        k.body.inertia.yz = R(bad[i]);
        check_refused(&k, VM_NOT_FINITE);
    }
}

static void test_bad_bodies(void)
{
    scene k, good;
    vm_reactive loads;
    vm_vec3 dv, domega;
    vm_real y[VM_FLOW_STATES];
    scene_init(&good);
    k = good;
    k.body.mass = -1;
    check_refused(&k, VM_BAD_MASS);
    k = good;
    k.body.mass = 0;
    check_refused(&k, VM_BAD_MASS);
    k = good;
    k.body.inertia.xx = -1;
    check_refused(&k, VM_BAD_INERTIA);
    k = good;
    k.streams[0].motion = VM_AT_REST + 1;
    check_refused(&k, VM_BAD_ARGUMENT);
    k = good;
    k.body.inertia = tensor(1, 1, 0, 0, 0, 0); /* a rod */
    k.flow.streams = k.streams;
    CHECK(!vm_reactive_loads(&good.body, vector(0, 0, 0), SCENE_STREAMS, good.streams, &loads));
    CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_BAD_INERTIA);
    CHECK(vm_accelerations(&k.body, &loads, vector(0, 0, 0), vector(0, 0, 0), &dv, &domega) == VM_BAD_INERTIA);
}

/* Results that overflow are refused, and nothing is written. */
static void test_overflow(void)
{
    vm_body b = case_e1();
    vm_stream s = case_e1_stream();
    vm_reactive loads;
    vm_flow flow;
    vm_vec3 dv = vector(1, 2, 3), domega = dv;
    vm_real y[VM_FLOW_STATES] = {7};
    memset(&flow, 0, sizeof flow);
    memset(&loads, 0, sizeof loads);
    loads.mass_rate = 7;
    s.rate = VM_MAX;
    s.velocity.x = 2;
    CHECK(vm_reactive_loads(&b, dv, 1, &s, &loads) == VM_NOT_FINITE && loads.mass_rate == 7);
    b.v.y = VM_MAX;
    CHECK(vm_flow_start(&flow, &b, y) == VM_NOT_FINITE && y[0] == 7 && flow.mass == 0);
    b = case_e1();
    loads.torque.z = VM_MAX;
    b.inertia = tensor(.4, .4, .5, 0, 0, 0);
    CHECK(vm_accelerations(&b, &loads, dv, dv, &dv, &domega) == VM_NOT_FINITE && dv.x == 1 && domega.x == 1);
}

int main(void)
{
    test_e1_loads();
    test_e1_at_the_centre();
    test_e1_rates_of_momenta();
    test_components();
    test_at_rest();
    test_opposite_streams();
    test_couple_of_jets();
    test_small_jumps();
    test_jump_limit();
    test_not_finite();
    test_bad_bodies();
    test_overflow();
    return check_finish("streams");
}
