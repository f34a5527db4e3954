/* varmass.h, chapter 5: reactive loads, right-hand sides of every kind of flow, closed forms */

static vm_inertia some_gyration(void)
{
    vm_inertia i;
    memset(&i, 0, sizeof i);
    i.xx = uniform(3, 4) / 16;
    i.yy = uniform(3, 4) / 16;
    i.zz = uniform(3, 4) / 16;
    i.xy = uniform(-1, 1) / 16;
    return i;
}

static void draw_streams(int n, vm_stream *streams)
{
    int i;
    memset(streams, 0, (size_t)n * sizeof *streams);
    for (i = 0; i < n; i++) {
        vm_stream *s = streams + i;
        s->rate = uniform(-1, 1) / 8;
        s->motion = i % 4;
        s->at = vector(1);
        s->velocity = vector(2);
        s->spin = vector(1);
        s->gyration = some_gyration();
    }
}

static void try_loads(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_body body = some_body();
        const vm_vec3 centre = vector(VM_C(0.25)), force = vector(5), moment = vector(5);
        vm_stream streams[4];
        vm_reactive loads;
        vm_vec3 acceleration, turning;
        draw_streams(4, streams);
        CLEAR(loads);
        CLEAR(acceleration);
        CLEAR(turning);
        fold_int(vm_reactive_loads(&body, centre, 4, streams, &loads));
        fold3(loads.force);
        fold3(loads.moment);
        fold3(loads.torque);
        fold3(loads.drift);
        fold(loads.mass_rate);
        fold_inertia(loads.inertia_rate);
        fold_int(vm_accelerations(&body, &loads, force, moment, &acceleration, &turning));
        fold3(acceleration);
        fold3(turning);
        streams[0].motion = 9;
        fold_int(vm_reactive_loads(&body, centre, 4, streams, &loads));
        fold3(loads.force); /* refused */
    }
}

/* The weight acts. Mass, mass centre and inertia are set for the right-hand sides that take them from here. */
static int weight(vm_real t, const vm_real *y, vm_flow *flow)
{
    (void)y;
    flow->mass = 3 - t / 8;
    flow->inertia.xx = 4 - t / 4;
    flow->inertia.yy = 4 - t / 8;
    flow->inertia.zz = 3 - t / 8;
    flow->centre.x = t / 16;
    flow->drift.x = VM_C(0.0625);
    flow->force.z = VM_C(-9.81) * flow->mass;
    return 0;
}

/* A run of a body with up to four streams, the last of them from a store, by one of the right-hand sides */
static void flow_of(ode_rhs rhs, int n, int streams_used, vm_real t)
{
    const vm_body body = some_body();
    vm_stream streams[4];
    vm_store store;
    vm_flow flow;
    vm_body now = body;
    vm_real y[VM_FLOW_BALANCED_STATES];
    memset(&flow, 0, sizeof flow);
    memset(y, 0, sizeof y);
    draw_streams(4, streams);
    store.at = vector(VM_C(0.5));
    store.gyration = some_gyration();
    streams[3].from = &store;
    flow.n = streams_used;
    flow.streams = streams;
    flow.update = weight;
    flow.least_mass = VM_C(0.5);
    fold_int(vm_flow_start(&flow, &body, y));
    fold_all(n, y);
    integrate(rhs, &flow, n, t, y);
    fold_int(flow.status);
    fold(vm_flow_mass_left(t, y, &flow));
    fold(vm_flow_inertia_left(t, y, &flow));
    if (rhs == vm_flow_carried_rhs) return; /* vm_flow_body does not take its states */
    fold_int(vm_flow_body(&flow, n < VM_FLOW_STATES ? VM_FLOW_GIVEN_STATES : VM_FLOW_STATES, y, &now));
    fold_body(&now);
}

static void try_flows(void)
{
    flow_of(vm_flow_rhs, VM_FLOW_STATES, 4, 1);
    flow_of(vm_flow_balanced_rhs, VM_FLOW_BALANCED_STATES, 3, 1);
}

static void try_given_flows(void)
{
    flow_of(vm_flow_given_rhs, VM_FLOW_GIVEN_STATES, 3, 1);
    flow_of(vm_flow_carried_rhs, VM_FLOW_GIVEN_STATES, 0, 1);
}

static void try_flow_of_translation(void)
{
    vm_stream streams[3];
    vm_flow flow;
    vm_real y[VM_TRANSLATION_STATES] = {0, 1, 2, 3, -2, 1, 4};
    memset(&flow, 0, sizeof flow);
    draw_streams(3, streams);
    flow.n = 3;
    flow.streams = streams;
    flow.force.x = 1;
    integrate(vm_translation_rhs, &flow, VM_TRANSLATION_STATES, 2, y);
}

static void try_flow_in_the_plane(void)
{
    vm_stream2 streams[3];
    vm_flow2 flow;
    vm_real y[VM_FLOW2_STATES] = {0, 1, VM_C(0.5), 2, -1, VM_C(0.25), 3, 0, 0, 2};
    int i;
    memset(&flow, 0, sizeof flow);
    for (i = 0; i < 3; i++) {
        streams[i].rate = uniform(-1, 1) / 4;
        streams[i].motion = i;
        streams[i].x = uniform(-1, 1) / 2;
        streams[i].y = uniform(-1, 1) / 2;
        streams[i].vx = uniform(-2, 2);
        streams[i].vy = uniform(-2, 2);
        streams[i].spin = uniform(-1, 1);
        streams[i].gyration = uniform(0, 1) / 16;
    }
    flow.n = 3;
    flow.streams = streams;
    flow.fy = -5;
    flow.moment = VM_C(0.5);
    integrate(vm_flow2_rhs, &flow, VM_FLOW2_STATES, 2, y);
}

static void try_flow_on_a_line(void)
{
    vm_stream1 streams[2] = {{VM_C(-0.25), 3, VM_RELATIVE}, {VM_C(0.125), -1, VM_ABSOLUTE}};
    vm_flow1 flow;
    vm_real y[VM_FLOW1_STATES] = {0, 1, 2};
    memset(&flow, 0, sizeof flow);
    flow.n = 2;
    flow.streams = streams;
    flow.force = VM_C(0.5);
    integrate(vm_flow1_rhs, &flow, VM_FLOW1_STATES, 2, y);
}

static void try_closed_flows(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real v0 = uniform(-3, 3), m0 = uniform(1, 3), m = uniform(1, 3), u = uniform(-3, 3);
        const vm_real t = uniform(0, 4);
        const vm_vec3 omega0 = vector(3);
        vm_stream1 stream;
        vm_jet jet;
        vm_vec3 omega = omega0;
        vm_real x = 1, v = 2;
        fold(vm_velocity_by_momentum(v0, m0, m, u, t));
        fold(vm_tsiolkovsky(v0, m0, m, u));
        stream.rate = i % 5 ? uniform(-1, 1) / 8 : 0;
        stream.velocity = u;
        stream.motion = i % 4;
        fold_int(vm_linear_flow(&stream, t, 1, v0, m0, m, &x, &v));
        fold(x);
        fold(v);
        jet.rate = uniform(-1, 1) / 8;
        jet.axial = uniform(1, 2);
        jet.transverse = uniform(2, 3);
        jet.gyration_axial = uniform(0, 1);
        jet.gyration_transverse = i % 7 ? uniform(0, 1) : 0;
        jet.gyration_out = uniform(0, 1);
        jet.nozzle = uniform(0, 2);
        fold_int(vm_jet_damping(&jet, t, omega0, &omega));
        fold3(omega);
    }
}

static void golden_streams(void)
{
    try_loads();
    try_flows();
    try_given_flows();
    try_flow_of_translation();
    try_flow_in_the_plane();
    try_flow_on_a_line();
    try_closed_flows();
}
