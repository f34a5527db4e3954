/* What the functions of chapters 5 and 6 refuse: streams and flows, the drum, Lagrange's equations with variable
   masses. Numbers and pointers that are none, masses and inertias that are used up, arrays that are too short, loads
   that overflow. The outputs must stay as they were. */
#include "refusals.h"
#include "valid_objects.h"

static const double eps = (double)VM_EPSILON;
static const vm_vec3 origin = {0, 0, 0};

/* ---- Streams and flows: each number and each pointer spoiled ---- */

/* In the order of the struct's members: rate, at, velocity, spin, gyration */
static void take_stream(trial *a, vm_stream *s)
{
    memset(s, 0, sizeof *s);
    s->rate = next(a);
    take(a, &s->at, sizeof s->at);
    take(a, &s->velocity, sizeof s->velocity);
    take(a, &s->spin, sizeof s->spin);
    take(a, &s->gyration, sizeof s->gyration);
}
#define STREAM R(-0.1), R(0.3), R(0.2), R(0.1), 1, 2, 3, R(0.1), R(0.2), R(0.3), R(0.01), R(0.01), R(0.01), 0, 0, 0

static int reactive_loads(trial *a)
{
    vm_body b;
    vm_stream s;
    vm_vec3 centre;
    take(a, &b, sizeof b);
    take_stream(a, &s);
    take(a, &centre, sizeof centre);
    return vm_reactive_loads(POINTER(0, &b), centre, 1, POINTER(1, &s), OUT(2, vm_reactive, 0));
}

static int accelerations(trial *a)
{
    vm_body b;
    vm_reactive loads;
    vm_vec3 force, moment;
    memset(&loads, 0, sizeof loads);
    take(a, &b, offsetof(vm_body, r));
    take(a, &loads, offsetof(vm_reactive, drift));
    b.r = b.v = b.omega = vmi_vec3(1, 2, 3);
    take(a, &force, sizeof force);
    take(a, &moment, sizeof moment);
    return vm_accelerations(POINTER(0, &b), POINTER(1, &loads), force, moment, OUT(2, vm_vec3, 0),
                            OUT(3, vm_vec3, 4));
}

static int flow_start(trial *a)
{
    vm_flow flow;
    vm_body b;
    vm_stream s;
    vm_store store;
    memset(&flow, 0, sizeof flow);
    take(a, &b, sizeof b);
    take_stream(a, &s);
    take(a, &store, sizeof store);
    take(a, &flow.centre, sizeof flow.centre);
    take(a, &flow.force, sizeof flow.force);
    take(a, &flow.moment, sizeof flow.moment);
    s.from = &store;
    flow.n = 1;
    flow.streams = POINTER(0, &s);
    return vm_flow_start(POINTER(1, &flow), POINTER(2, &b), OUT(3, vm_real, 0));
}

static int flow_body(trial *a)
{
    vm_flow flow;
    vm_real y[VM_FLOW_STATES];
    memset(&flow, 0, sizeof flow);
    take(a, y, VM_Y_CENTRE * sizeof *y);
    take(a, y + VM_Y_INERTIA, 6 * sizeof *y);
    y[VM_Y_CENTRE] = y[VM_Y_CENTRE + 1] = y[VM_Y_CENTRE + 2] = 0; /* not looked at */
    return vm_flow_body(POINTER(0, &flow), VM_FLOW_STATES, POINTER(1, y), OUT(2, vm_body, 0));
}

static int levi_civita(trial *a)
{
    const vm_real v0 = next(a), m0 = next(a), m = next(a), u = next(a);
    return value(a, vm_velocity_by_momentum(v0, m0, m, u, next(a)));
}

static int tsiolkovsky(trial *a)
{
    const vm_real v0 = next(a), m0 = next(a), m = next(a);
    return value(a, vm_tsiolkovsky(v0, m0, m, next(a)));
}

static int linear_flow(trial *a)
{
    vm_stream1 s = {0, 0, VM_RELATIVE};
    const vm_real t = next(a), x0 = next(a), v0 = next(a), m0 = next(a), force = next(a);
    s.rate = next(a);
    s.velocity = next(a);
    return vm_linear_flow(POINTER(0, &s), t, x0, v0, m0, force, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}

static int jet_damping(trial *a)
{
    vm_jet jet;
    vm_vec3 omega;
    const vm_real t = next(a);
    take(a, &jet, sizeof jet);
    take(a, &omega, sizeof omega);
    return vm_jet_damping(POINTER(0, &jet), t, omega, OUT(1, vm_vec3, 0));
}

static void test_streams(void)
{
    REFUSES(reactive_loads, 3, BODY, STREAM, R(0.1), R(0.2), R(0.3));
    REFUSES(accelerations, 4, 3, R(0.4), R(0.5), R(0.6), 0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1,
            2, 3);
    REFUSES(flow_start, 4, BODY, STREAM, R(0.1), R(0.1), R(0.1), R(0.01), R(0.01), R(0.01), 0, 0, 0, 1, 2, 3, 1, 2, 3,
            1, 2, 3);
    REFUSES(flow_body, 3, 1, 2, 3, 1, 0, 0, 0, 1, 2, 3, R(0.1), R(0.2), R(0.3), 3, 2, 2, 2, 0, 0, 0);
    REFUSES(levi_civita, 0, 1, 3, 2, 1, R(0.5));
    REFUSES(tsiolkovsky, 0, 1, 3, 2, 1);
    REFUSES(linear_flow, 3, 1, 2, 3, 4, 1, R(-0.1), 2);
    REFUSES(jet_damping, 2, 1, R(-0.1), 1, 2, R(0.1), R(0.2), R(0.1), 1, 1, 2, 3);
    CHECK(isnan(vm_velocity_by_momentum(1, -3, 2, 1, 0)) && isnan(vm_tsiolkovsky(1, -3, 2, 1)));
}

/* ---- Masses and inertias that are used up, and loads that overflow ---- */

static void test_linear_flow(void)
{
    vm_stream1 s = {-1, 2, VM_ABSOLUTE};
    vm_real x, v;
    CHECK(vm_linear_flow(&s, 1, 0, 0, -1, 0, &x, &v) == VM_BAD_MASS);
    CHECK(vm_linear_flow(&s, 2, 0, 0, 1, 0, &x, &v) == VM_BAD_MASS);
    s.motion = 77;
    CHECK(vm_linear_flow(&s, R(0.1), 0, 0, 1, 0, &x, &v) == VM_BAD_ARGUMENT);
}

/* Moments that are used up by then, or none from the start */
static void test_jet(void)
{
    const vm_vec3 spin = {1, 2, 3};
    vm_jet jet = {-1, 1, 2, 1, R(0.1), 1, 1};
    vm_vec3 omega;
    CHECK(vm_jet_damping(&jet, 2, spin, &omega) == VM_BAD_INERTIA);
    jet.axial = -1;
    CHECK(vm_jet_damping(&jet, 0, spin, &omega) == VM_BAD_INERTIA);
    jet.axial = 1;
    jet.transverse = 0;
    CHECK(vm_jet_damping(&jet, 0, spin, &omega) == VM_BAD_INERTIA);
}

/* A stream out of a store, and loads that overflow though each number of the stream is finite */
static void test_reactive_loads(void)
{
    const vm_body b = {3, {R(0.4), R(0.5), R(0.6), 0, 0, 0}, {1, 0, 0, 0}, {1, 2, 3}, {1, 0, 0}, {1, 2, 1}};
    const vm_body lightest = {VM_MIN, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const vm_store store = {{0, 0, 0}, {0, 0, 0, 0, 0, 0}};
    vm_stream s;
    vm_reactive loads;
    memset(&s, 0, sizeof s);
    s.rate = -1;
    s.from = &store;
    CHECK(vm_reactive_loads(&b, origin, 1, &s, &loads) == VM_STORED_STREAM);
    s.from = NULL;
    s.velocity.x = s.rate = VM_MAX / 2;
    CHECK(vm_reactive_loads(&b, origin, 1, &s, &loads) == VM_NOT_FINITE);
    s.velocity.x = 0;
    s.rate = VM_MAX / 8;
    s.at.y = 64;
    CHECK(vm_reactive_loads(&b, origin, 1, &s, &loads) == VM_NOT_FINITE);
    memset(&s, 0, sizeof s);
    s.rate = -64;
    s.at.x = 64;
    loads.mass_rate = 7;
    CHECK(vm_reactive_loads(&lightest, origin, 1, &s, &loads) == VM_NOT_FINITE);
    CHECK(loads.mass_rate == 7);
}

/* ---- Flows that are updated at each evaluation ---- */

static int stop_1(vm_real t, const vm_real *y, vm_flow1 *flow)
{
    (void)t;
    (void)y;
    (void)flow;
    return 7;
}

static int stop_2(vm_real t, const vm_real *y, vm_flow2 *flow)
{
    (void)t;
    (void)y;
    (void)flow;
    return 7;
}

static int stop_3(vm_real t, const vm_real *y, vm_flow *flow)
{
    (void)t;
    (void)y;
    (void)flow;
    return 7;
}

/* An update that fails stops the right-hand side with its status. */
static void test_updates_that_fail(void)
{
    vm_stream1 s1 = {R(-0.1), 2, VM_RELATIVE};
    vm_flow1 flow1 = {1, &s1, 0, stop_1, NULL, 0};
    vm_stream2 s2 = {R(-0.1), VM_RELATIVE, 0, 0, 0, 0, 0, 0};
    vm_flow2 flow2 = {1, &s2, 0, 0, 0, stop_2, NULL, 0};
    vm_real y[VM_FLOW_BALANCED_STATES] = {0, 1, 2}, rates[VM_FLOW_BALANCED_STATES];
    vm_flow flow;
    memset(&flow, 0, sizeof flow);
    flow.update = stop_3;
    CHECK(vm_flow1_rhs(0, y, rates, &flow1) == 7 && vm_flow2_rhs(0, y, rates, &flow2) == 7);
    CHECK(vm_translation_rhs(0, y, rates, &flow) == 7 && vm_flow_carried_rhs(0, y, rates, &flow) == 7);
}

static int force_1(vm_real t, const vm_real *y, vm_flow1 *flow)
{
    (void)y;
    flow->force = t;
    return 0;
}

static int force_3(vm_real t, const vm_real *y, vm_flow *flow)
{
    (void)y;
    flow->force.x = t;
    return 0;
}

/* Flows without streams, whose forces are updated or constant */
static void test_flows_without_streams(void)
{
    const vm_real y1[3] = {0, 6, 2}, y2[10] = {0, 6, 1, 2, 4, 6, 2, 0, 0, 3}, y3[7] = {0, 6, 2, 8, 0, 0, 2};
    vm_flow1 flow1 = {0, NULL, 0, force_1, NULL, 0};
    vm_flow2 flow2 = {0, NULL, 3, 4, 5, NULL, NULL, 0};
    vm_real rates[VM_FLOW_STATES];
    vm_flow flow;
    memset(&flow, 0, sizeof flow);
    flow.update = force_3;
    CHECK(vm_flow1_rhs(5, y1, rates, &flow1) == 0 && rates[0] == 3 && rates[1] == 5 && rates[2] == 0);
    CHECK(vm_translation_rhs(5, y3, rates, &flow) == 0 && rates[0] == 4 && rates[3] == 5 && rates[6] == 0);
    CHECK(vm_flow2_rhs(0, y2, rates, &flow2) == 0 && rates[0] == 1 && rates[1] == 2 && rates[2] == 2);
    CHECK(rates[3] == 3 && rates[4] == 4 && rates[5] == 5 && rates[6] == 0 && rates[9] == 0);
}

/* A state that is shorter than a right-hand side needs is refused before anything is written. Started, it holds as
   many of the numbers as it has room for. */
static void test_sizes_of_flows(void)
{
    const vm_body body = a_body(3);
    vm_real y[VM_FLOW_BALANCED_STATES + 1], d[VM_FLOW_BALANCED_STATES];
    vm_flow flow;
    vm_body now;
    int i, k, known, wanted;
    for (i = 1; i <= VM_FLOW_BALANCED_STATES; i++) {
        memset(&flow, 0, sizeof flow);
        flow.y_size = i;
        for (k = 0; k <= VM_FLOW_BALANCED_STATES; k++) y[k] = 7;
        CHECK(vm_flow_start(&flow, &body, y) == (i < VM_FLOW_GIVEN_STATES ? VM_SHORT_ARRAY : VM_OK));
        known = 0;
        while (y[known] != 7) known++; /* none of the numbers that are written is 7 */
        wanted = 0;
        if (i >= VM_FLOW_GIVEN_STATES) wanted = VM_FLOW_GIVEN_STATES;
        if (i >= VM_FLOW_STATES) wanted = VM_FLOW_STATES;
        if (i >= VM_FLOW_BALANCED_STATES) wanted = VM_FLOW_BALANCED_STATES;
        CHECK(known == wanted);
        if (i < VM_FLOW_GIVEN_STATES) continue;
        CHECK(vm_flow_given_rhs(0, y, d, &flow) == 0 && vm_flow_carried_rhs(0, y, d, &flow) == 0);
        CHECK(vm_flow_rhs(0, y, d, &flow) == (i < VM_FLOW_STATES ? VM_SHORT_ARRAY : VM_OK));
        CHECK(vm_flow_balanced_rhs(0, y, d, &flow) == (i < VM_FLOW_BALANCED_STATES ? VM_SHORT_ARRAY : VM_OK));
        CHECK(vm_flow_body(&flow, VM_FLOW_GIVEN_STATES, y, &now) == VM_OK);
        CHECK(vm_flow_body(&flow, VM_FLOW_STATES, y, &now) == (i < VM_FLOW_STATES ? VM_SHORT_ARRAY : VM_OK));
    }
    flow.y_size = VM_TRANSLATION_STATES;
    CHECK(vm_translation_rhs(0, y, d, &flow) == VM_OK);
    flow.n = -1;
    CHECK(vm_flow_body(&flow, VM_FLOW_GIVEN_STATES, y, &now) == VM_BAD_ARGUMENT);
    CHECK(vm_translation_rhs(0, y, d, &flow) == VM_BAD_ARGUMENT);
    flow.n = 0;
    flow.y_size = VM_TRANSLATION_STATES - 1;
    CHECK(vm_translation_rhs(0, y, d, &flow) == VM_SHORT_ARRAY && flow.status == VM_SHORT_ARRAY);
    CHECK(vm_flow_carried_rhs(0, y, d, &flow) == VM_SHORT_ARRAY);
}

/* ---- Supplies and orbits ---- */

/* What is left of a supply of the given kind, of the next numbers */
static int left_of(trial *a, int kind)
{
    vm_supply s;
    s.kind = kind;
    take(a, &s.at, sizeof s.at);
    take(a, &s.axis, sizeof s.axis);
    s.length = next(a);
    s.radius = next(a);
    s.bore = next(a);
    s.full = next(a);
    return vm_supply_at(POINTER(0, &s), next(a), OUT(1, vm_supply_left, 0));
}

static int liquid(trial *a) { return left_of(a, VM_TANK_OF_LIQUID); }
static int gas(trial *a) { return left_of(a, VM_TANK_OF_GAS); }
static int grain(trial *a) { return left_of(a, VM_GRAIN); }

static int orbit(trial *a)
{
    vm_vec3 r, v;
    const vm_real t = next(a), mu = next(a);
    take(a, &r, sizeof r);
    take(a, &v, sizeof v);
    return vm_orbit(t, mu, r, v, OUT(0, vm_vec3, 0), OUT(1, vm_vec3, 1));
}

static int orbit_meshchersky(trial *a)
{
    vm_vec3 r, v;
    const vm_real t = next(a), mu = next(a), rate = next(a);
    take(a, &r, sizeof r);
    take(a, &v, sizeof v);
    return vm_orbit_meshchersky(t, mu, rate, r, v, OUT(0, vm_vec3, 0), OUT(1, vm_vec3, 1));
}

#define SUPPLY R(0.1), R(0.2), R(0.3), 1, 2, 3, 2, R(0.5), R(0.1), 4, 3

static void test_supplies_and_orbits(void)
{
    vm_supply unknown;
    vm_supply_left left;
    REFUSES(liquid, 2, SUPPLY);
    REFUSES(gas, 2, SUPPLY);
    REFUSES(grain, 2, SUPPLY);
    REFUSES(orbit, 2, 1, 2, 1, R(0.2), R(0.3), R(0.1), 1, R(0.5));
    REFUSES(orbit, 2, -1, 2, 1, R(0.2), R(0.3), R(0.1), 2, R(0.5)); /* a hyperbola, backward in time */
    REFUSES(orbit_meshchersky, 2, 1, 2, R(-0.1), 1, R(0.2), R(0.3), R(0.1), 1, R(0.5));
    memset(&unknown, 0, sizeof unknown);
    unknown.kind = VM_GRAIN + 1;
    CHECK(vm_supply_at(&unknown, 1, &left) == VM_BAD_ARGUMENT);
    unknown.kind = -1;
    CHECK(vm_supply_at(&unknown, 1, &left) == VM_BAD_ARGUMENT);
}

/* ---- The drum ---- */

static int drum_at(trial *a)
{
    vm_drum d;
    const vm_real phi = next(a);
    take(a, &d, offsetof(vm_drum, speed));
    d.speed = 3;
    d.damping = 0;
    d.stiffness = 4000;
    d.omega = 20;
    return vm_drum_at(POINTER(0, &d), phi, OUT(1, vm_drum_geometry, 0));
}

/* What the motion of a rigid shaft needs: neither mass nor stiffness */
static vm_drum turning_drum(trial *a)
{
    vm_drum d = {0, 10, 0, 0, 0, 0, 4000, 0};
    d.radius = next(a);
    d.inertia = next(a);
    d.band = next(a);
    d.speed = next(a);
    d.damping = next(a);
    d.omega = next(a);
    return d;
}

static int drum_rate(trial *a)
{
    const vm_real phi = next(a);
    const vm_drum d = turning_drum(a);
    return value(a, vm_drum_rate(POINTER(0, &d), phi));
}

static int drum_angle(trial *a)
{
    const vm_real t = next(a);
    const vm_drum d = turning_drum(a);
    return value(a, vm_drum_angle(POINTER(0, &d), t));
}

static int shaft_init(trial *a)
{
    vm_drum d;
    take(a, &d, sizeof d);
    return vm_drum_shaft_init(OUT(1, vm_drum_shaft, 0), POINTER(0, &d));
}

static int deflection(trial *a)
{
    vm_drum_shaft s;
    const vm_real phi = next(a), amplitude = next(a), alpha = next(a), particular = next(a);
    s.k = next(a);
    s.A = next(a);
    s.delta = R(0.02);
    s.shift = 0;
    return value(a, vm_drum_deflection(POINTER(0, &s), phi, amplitude, alpha, particular));
}

static int deflection_start(trial *a)
{
    vm_drum_shaft s;
    const vm_real x = next(a), slope = next(a), particular = next(a);
    memset(&s, 0, sizeof s);
    s.k = next(a);
    s.A = next(a);
    s.delta = next(a);
    return vm_drum_deflection_start(POINTER(0, &s), x, slope, particular, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}

static int unbalance(trial *a)
{
    vm_drum d;
    take(a, &d, sizeof d);
    return vm_drum_unbalance(POINTER(0, &d), next(a), OUT(1, vm_real, 0), OUT(2, vm_real, 2));
}

/* The equations over the angle; the deflections may have any size. */
static int drum_rhs_angle(trial *a)
{
    vm_real y[VM_DRUM_ANGLE_STATES] = {R(0.1), R(0.1), R(0.1), R(0.1)};
    vm_drum d;
    take(a, &d, sizeof d);
    return vm_drum_rhs_angle(next(a), POINTER(0, y), OUT(1, vm_real, 0), POINTER(2, &d));
}

static int drum_rhs_coupled(trial *a)
{
    vm_real y[VM_DRUM_COUPLED_STATES];
    vm_drum d;
    int i;
    for (i = 0; i < VM_DRUM_COUPLED_STATES; i++) y[i] = R(0.1);
    take(a, &d, sizeof d);
    y[VM_DRUM_RATE] = next(a);
    return vm_drum_rhs_coupled(next(a), POINTER(0, y), OUT(1, vm_real, 0), POINTER(2, &d));
}

#define DRUM R(0.5), 10, 2, R(0.1), 3, R(0.05), 4000, 20

/* Masses that are none, and stiffness below 0; in the order of the struct's members */
static void test_impossible_drums(void)
{
    const vm_drum good = {DRUM};
    vm_drum_geometry g;
    vm_real d[VM_DRUM_ANGLE_STATES] = {0}, y[VM_DRUM_ANGLE_STATES] = {0};
    vm_drum drum = good;
    drum.stiffness = -1;
    CHECK(vm_drum_at(&drum, 1, &g) == VM_BAD_STIFFNESS && vm_drum_rhs_angle(1, y, d, &drum) == VM_BAD_STIFFNESS);
    drum = good;
    drum.mass = -1;
    CHECK(vm_drum_at(&drum, 1, &g) == VM_BAD_MASS && vm_drum_rhs_angle(1, y, d, &drum) == VM_BAD_MASS);
    drum.mass = 0;
    drum.band = 1; /* the band alone has a mass, but the empty drum none */
    CHECK(vm_drum_rhs_angle(1, y, d, &drum) == VM_BAD_MASS);
}

static void test_drum(void)
{
    REFUSES(deflection_start, 3, R(0.1), R(0.2), R(0.3), 2, R(0.01), R(0.02));
    REFUSES(unbalance, 3, DRUM, 1);
    REFUSES_SPOILED(drum_rhs_angle, 3, DRUM, 1);
    REFUSES_SPOILED(drum_rhs_coupled, 3, DRUM, 20, 1);
    REFUSES(drum_at, 2, 1, R(0.5), 10, 2, R(0.1));
    REFUSES(drum_rate, 1, 1, R(0.5), 2, R(0.1), 3, R(0.05), 20);
    REFUSES(drum_angle, 1, 1, R(0.5), 2, R(0.1), 3, R(0.05), 20);
    REFUSES(shaft_init, 2, R(0.5), 10, 2, R(0.1), 3, R(0.05), 4000, 20);
    REFUSES(deflection, 1, 1, R(0.1), R(0.2), R(0.3), 2, R(0.01));
}

/* Without a band, driven by a motor: phi' = Omega + |D| phi/J0 */
static void test_drum_without_band(void)
{
    const vm_drum d = {R(0.5), 10, 2, 0, 3, -2, 4000, 20};
    const double exact = 20 * expm1(50);
    check_error("drum", "no band", "eps", ERROR_EPS(vm_drum_angle(&d, 50), exact, 0, exact), 64, 50, 0);
}

/* The angle by Lambert's function at t = 0, where rounding may take its argument beyond -1/e, is 0. With a damping
   that just balances the band, e = 0, the formula has no value; next to that it has one. */
static void test_drum_by_lambert(void)
{
    vm_drum d = {R(0.5), 10, 2, R(0.25), 3, 0, 4000, 20};
    vm_real largest = 0;
    int i;
    for (i = 0; i < 2000; i++) {
        vm_real phi;
        d.damping = (vm_real)uniform(-2, 0.25);
        phi = VM_FABS(vm_drum_angle_lambert(&d, 0));
        if (phi > largest) largest = phi;
        d.damping = R(0.375) + VM_SQRT(VM_EPSILON) * (vm_real)uniform(-4, 4);
        phi = vm_drum_angle_lambert(&d, 0);
        CHECK(phi == phi || vmi_drum_e(&d).hi == 0);
    }
    check_error("drum, Lambert", "t = 0", "eps", (double)largest / eps, 1e4, 0, 0);
}

static void test_overflowing_shaft(void)
{
    const vm_drum d = {1, 1, 1, 0, 3, -VM_MAX / 4 * 3, 4000, 1};
    vm_drum_shaft shaft;
    shaft.k = 7;
    CHECK(vm_drum_shaft_init(&shaft, &d) == VM_NOT_FINITE && shaft.k == 7);
}

/* ---- Lagrange's equations with variable masses ---- */

static int lagrange_start(trial *a)
{
    vm_lagrange_system l = system_of_two();
    vm_real q[2], rates[2];
    const vm_real t = next(a);
    take(a, q, sizeof q);
    take(a, rates, sizeof rates);
    return vm_lagrange_start(POINTER(0, &l), t, POINTER(1, q), POINTER(2, rates), OUT(3, vm_real, 0));
}

static int lagrange_rates(trial *a)
{
    vm_lagrange_system l = system_of_two();
    vm_real y[4];
    const vm_real t = next(a);
    take(a, y, sizeof y);
    return vm_lagrange_rates(POINTER(0, &l), t, POINTER(1, y), OUT(2, vm_real, 0));
}

static int frozen_derivative(trial *a)
{
    vm_lagrange_system l = system_of_two();
    vm_real q[2], rates[2];
    q[0] = rates[0] = rates[1] = q[1] = 1;
    return value(a, vm_lagrange_partial_q(POINTER(0, &l), 0, POINTER(1, q), POINTER(2, rates), 1));
}

static int needed_forces(trial *a)
{
    vm_lagrange_system l = system_of_two();
    vm_real q[2], rates[2], accelerations[2];
    const vm_real t = next(a), time_scale = next(a);
    take(a, q, sizeof q);
    take(a, rates, sizeof rates);
    take(a, accelerations, sizeof accelerations);
    return vm_lagrange_needed_forces(POINTER(0, &l), t, time_scale, POINTER(1, q), POINTER(2, rates),
                                     POINTER(3, accelerations), OUT(4, vm_real, 0));
}

/* A system at rest, whose masses do not depend on time: nothing tells by which step the momenta are to be compared. */
static void test_forces_at_rest(void)
{
    const vm_real q[2] = {R(0.3), R(0.2)}, rest[2] = {0, 0}, accelerations[2] = {1, 2}, scales[2] = {2, R(0.5)};
    vm_lagrange_system l = system_of_two();
    vm_real Q[2] = {0, 0};
    CHECK(vm_lagrange_needed_forces(&l, 0, 0, q, rest, accelerations, Q) == VM_OK);
    check_error("needed forces", "at rest", "eps", fabs((double)Q[0] - 2 * 1.09) / eps, 100, 0, 0);
    l.scales = scales;
    CHECK(vm_lagrange_needed_forces(&l, 0, 0, q, accelerations, accelerations, Q) == VM_OK);
    check_error("needed forces", "scales", "eps", fabs((double)Q[0] - 2 * (1.09 + 0.3)) / eps, 1000, 0, 0);
}

/* Systems that lack something */
static void test_bad_systems(void)
{
    const vm_real q[2] = {R(0.3), R(0.2)}, rates[2] = {1, 2};
    vm_real y[4];
    int i;
    for (i = 0; i < 6; i++) {
        vm_lagrange_system l = system_of_two();
        if (i == 0) l.n = 0;
        if (i == 1) l.n_masses = -1;
        if (i == 2) l.energy = NULL;
        if (i == 3) l.work = NULL;
        if (i == 4) l.masses = NULL;
        CHECK(vm_lagrange_start(i == 5 ? NULL : &l, 0, q, rates, y) == VM_BAD_ARGUMENT);
    }
}

static void test_lagrange(void)
{
    const vm_real scales[2] = {2, R(0.5)}, q[2] = {R(0.3), R(0.2)}, rates[2] = {1, 2};
    vm_lagrange_system l = system_of_two();
    vm_real derivative, other;
    REFUSES(lagrange_start, 4, 1, R(0.3), R(0.2), 1, 2);
    REFUSES(needed_forces, 5, 1, 2, R(0.3), R(0.2), 1, 2, 3, 4);
    REFUSES(lagrange_rates, 3, 1, 1, 2, 3, 4);
    REFUSES_NULL(frozen_derivative, 3);
    CHECK(isnan(vm_lagrange_partial_q(&l, 0, q, rates, -1)) && isnan(vm_lagrange_partial_q(&l, 0, q, rates, 2)));
    derivative = vm_lagrange_partial_q(&l, 0, q, rates, 0);
    l.scales = scales; /* the steps of the difference are others, the derivative m q q'^2 is not */
    other = vm_lagrange_partial_q(&l, 0, q, rates, 0);
    check_error("dT/dq", "scales", "eps", fabs((double)(other - derivative)) / eps, 250, 0, 0);
}

int main(int argc, char **argv)
{
    read_refusal_rounds(argc, argv);
    test_streams();
    test_linear_flow();
    test_jet();
    test_reactive_loads();
    test_updates_that_fail();
    test_flows_without_streams();
    test_sizes_of_flows();
    test_supplies_and_orbits();
    test_drum();
    test_impossible_drums();
    test_drum_without_band();
    test_drum_by_lambert();
    test_overflowing_shaft();
    test_lagrange();
    test_forces_at_rest();
    test_bad_systems();
    return check_finish("refusals streams");
}
