/* For Frama-C's EVA (tests/eva.sh): functions of varmass.h with any numbers, NaN and infinities among them. What a function
   writes has any value before, too, because EVA does not relate a status to what was written. tests/eva_left_out.txt has
   those public functions of varmass.h that are not called here. */
#define EVA_HEADER "../varmass.h"
#include "eva_words.h"

vm_vec3 any_vector(void)
{
    vm_vec3 a;
    a.x = any;
    a.y = any;
    a.z = any;
    return a;
}

vm_quat any_quat(void)
{
    vm_quat q;
    q.w = any;
    q.x = any;
    q.y = any;
    q.z = any;
    return q;
}

vm_inertia any_inertia(void)
{
    vm_inertia i;
    i.xx = any;
    i.yy = any;
    i.zz = any;
    i.xy = any;
    i.xz = any;
    i.yz = any;
    return i;
}

vm_body any_body(void)
{
    vm_body b;
    b.mass = any;
    b.inertia = any_inertia();
    b.q = any_quat();
    b.r = any_vector();
    b.v = any_vector();
    b.omega = any_vector();
    return b;
}

vm_body2 any_body2(void)
{
    vm_body2 b;
    b.mass = any;
    b.inertia = any;
    b.x = any;
    b.y = any;
    b.angle = any;
    b.vx = any;
    b.vy = any;
    b.omega = any;
    return b;
}

vm_impulse any_impulse(void)
{
    vm_impulse j;
    j.linear = any_vector();
    j.at = any_vector();
    j.couple = any_vector();
    return j;
}

vm_impulse2 any_impulse2(void)
{
    vm_impulse2 j;
    j.jx = any;
    j.jy = any;
    j.x = any;
    j.y = any;
    j.couple = any;
    return j;
}

/* ---- Vectors and attitudes ---- */

void eva_vectors(void)
{
    sink[0] = vm_norm(vm_cross(vm_add(any_vector(), any_vector()), vm_scale(any, vm_sub(any_vector(), any_vector()))));
    sink[1] = vm_unit(any_vector()).x + vm_dot(any_vector(), any_vector());
    sink[2] = vm_rotate(vm_quat_times(any_quat(), any_quat()), any_vector()).x;
    sink[3] = vm_rotate_back(vm_unit_quat(any_quat()), any_vector()).x;
}

void eva_attitudes(void)
{
    vm_real c[9] = {any, any, any, any, any, any, any, any, any}, angles[3] = {any, any, any};
    vm_vec3 axis[3];
    vm_quat q = vm_euler_313(any, any, any);
    if (vm_quat_to_matrix(any_quat(), c) == VM_OK) sink[0] = c[0] + c[8];
    if (vm_quat_from_matrix(c, &q) == VM_OK) sink[1] = q.w;
    q = vm_quat_from_mrp(vm_quat_to_mrp(any_quat()));
    sink[2] = q.w + vm_euler_321(any, any, any).w;
    if (vm_euler_313_angles(any_quat(), angles) == VM_OK) sink[3] = angles[0];
    if (vm_euler_321_angles(any_quat(), angles) == VM_OK) sink[4] = angles[0];
    vm_euler_313_axes(any, any, axis);
    vm_euler_313_body_axes(any, any, axis);
    if (vm_euler_313_rates(any, any, any_vector(), angles) == VM_OK) sink[5] = angles[2] + axis[2].z;
}

/* ---- Jumps ---- */

void eva_bodies(void)
{
    const vm_body b = any_body();
    const vm_body2 b2 = any_body2();
    const vm_inertia own = any_inertia(), sum = vm_parallel_axes(&own, any, any_vector());
    sink[0] = vm_momentum(&b).x + vm_angular_momentum(&b, any_vector()).x + vm_kinetic_energy(&b);
    sink[1] = vm_angular_momentum2(&b2, any, any) + vm_kinetic_energy2(&b2) + vm_body_from_body2(&b2).mass;
    sink[2] = sum.xx + (vm_real)vm_inertia_is_possible(&sum);
}

void eva_jumps2(void)
{
    const vm_body2 a = any_body2(), b[2] = {any_body2(), any_body2()};
    const vm_impulse2 j = any_impulse2();
    vm_body2 c = any_body2();
    if (vm_separate2(&a, b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega;
    if (vm_attach2(&a, b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega;
    if (vm_separate_all2(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[2] = c.omega;
    if (vm_attach_all2(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[3] = c.omega;
}

void eva_jumps(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_impulse j = any_impulse();
    vm_body c = any_body();
    if (vm_separate(&a, &b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega.x;
    if (vm_attach(&a, &b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega.x;
}

void eva_jumps_of_several(void)
{
    const vm_body a = any_body(), b[2] = {any_body(), any_body()};
    const vm_impulse j = any_impulse();
    vm_body c = any_body();
    if (vm_separate_all(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega.x;
    if (vm_attach_all(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega.x;
    sink[2] = vm_energy_gain(&a, 2, b, &j, &c) + vm_energy_loss(&a, 2, b, &j, &c);
}

void eva_inertias(void)
{
    const vm_inertia a = any_inertia(), b = any_inertia();
    vm_inertia whole = any_inertia();
    vm_vec3 centre = any_vector();
    if (vm_combine_inertia(any, &a, any, &b, any_vector(), &whole, &centre) >= 0) sink[0] = whole.xx + centre.x;
    if (vm_split_inertia(any, &a, any, &b, any_vector(), &whole, &centre) >= 0) sink[1] = whole.xx + centre.x;
}

void eva_relative(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_body2 a2 = any_body2(), b2 = any_body2();
    vm_body c = any_body();
    vm_body2 c2 = any_body2();
    if (vm_to_relative(&a, &b, &c) >= 0) sink[0] = c.omega.x;
    if (vm_to_absolute(&a, &b, &c) >= 0) sink[1] = c.omega.x;
    if (vm_to_relative2(&a2, &b2, &c2) >= 0) sink[2] = c2.omega;
    if (vm_to_absolute2(&a2, &b2, &c2) >= 0) sink[3] = c2.omega;
    if (vm_separate_relative2(&a2, &b2, NULL, &c2) >= 0) sink[4] = c2.omega;
    if (vm_attach_relative2(&a2, &b2, NULL, &c2) >= 0) sink[5] = c2.omega;
}

void eva_inverse2(void)
{
    const vm_body2 a = any_body2(), b = any_body2();
    const vm_impulse2 j = any_impulse2();
    const vm_real number = any, velocity[2] = {any, any};
    vm_body2 c = any_body2();
    if (vm_separation_for_rest2(&a, &b, &j, any_int ? velocity : NULL, any_int ? &number : NULL, &c) >= 0) sink[0] = c.omega;
    if (vm_separation_for_spin2(&a, &b, &j, any, &c) >= 0) sink[1] = c.omega;
}

void eva_inverse(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_impulse j = any_impulse();
    const vm_vec3 v = any_vector();
    vm_body c = any_body();
    if (vm_separation_for_rest(&a, &b, &j, any_int ? &v : NULL, any_int ? &v : NULL, &c) >= 0) sink[0] = c.omega.x;
}

void eva_axle(void)
{
    const vm_body a = any_body(), b[2] = {any_body(), any_body()};
    const vm_impulse j = any_impulse();
    vm_axle axle;
    vm_impulse reaction = any_impulse();
    vm_body c = any_body();
    axle.at = any_vector();
    axle.axis = any_vector();
    if (vm_separate_on_axle(&axle, &a, 2, b, &j, &c, &reaction) >= 0) sink[0] = c.omega.x + reaction.linear.x;
    if (vm_attach_on_axle(&axle, &a, 2, b, &j, &c, NULL) >= 0) sink[1] = c.omega.x;
}

void eva_pendulums(void)
{
    vm_pendulum p;
    vm_pendulum_cut cut;
    vm_compound_pendulum whole;
    vm_compound_part part;
    vm_compound_cut c;
    memset(&cut, 0, sizeof cut);
    memset(&c, 0, sizeof c);
    p.axes = any_int;
    p.mass = any;
    p.length = any;
    p.angle = any;
    p.rate = any;
    if (vm_pendulum_separate(&p, any, any, any, any, &cut) >= 0) sink[0] = cut.rate;
    whole.mass = any;
    whole.inertia = any;
    whole.x = any;
    whole.y = any;
    whole.rate = any;
    part.mass = any;
    part.inertia = any;
    part.x = any;
    part.y = any;
    part.ux = any;
    part.uy = any;
    part.Omega = any;
    if (vm_compound_pendulum_separate(&whole, &part, &c) >= 0) sink[1] = c.rest.rate;
}

void eva_broken_rotor(void)
{
    vm_broken_rotor r;
    vm_real y[6] = {any, any, any, any, any, any}, found[8] = {any, any, any, any, any, any, any, any};
    r.mass = any;
    r.inertia = any;
    r.stiffness = any;
    r.damping = any;
    r.torque = any;
    r.s = any;
    if (vm_broken_rotor_rhs(any, y, found, &r) >= 0) sink[0] = found[0];
    if (vm_broken_rotor_polar_rhs(any, y, found, &r) >= 0) sink[1] = found[0];
    if (vm_broken_rotor_to_polar(y, found) >= 0) sink[2] = found[0];
    if (vm_broken_rotor_from_polar(y, found) >= 0) sink[3] = found[0];
    if (vm_broken_rotor_characteristic(&r, any, found) >= 0) sink[4] = found[0];
    if (vm_broken_rotor_routh(&r, any, found) >= 0) sink[5] = found[0];
    sink[6] = vm_broken_rotor_steady_radius(&r, any) + vm_broken_rotor_resonance_radius(&r, any, any);
    sink[7] = (vm_real)vm_broken_rotor_is_stable(&r, any);
}

void eva_broken_rotor_motions(void)
{
    vm_broken_rotor r;
    vm_real y[6] = {any, any, any, any, any, any}, found[8] = {any, any, any, any, any, any, any, any};
    r.mass = any;
    r.inertia = any;
    r.stiffness = any;
    r.damping = any;
    r.torque = any;
    r.s = any;
    if (vm_broken_rotor_linear(&r, any, y, found) >= 0) sink[0] = found[0];
    if (vm_broken_rotor_linear_uncoupled(&r, any, y, found) >= 0) sink[1] = found[0];
    if (vm_broken_rotor_free_motion(&r, any, y, found) >= 0) sink[2] = found[0];
    if (vm_broken_rotor_orbit(&r, y, found) >= 0) sink[3] = found[0];
}

void eva_torque_free(void)
{
    const vm_body b = any_body();
    vm_torque_free motion;
    vm_body later = any_body();
    vm_quat q = any_quat();
    vm_vec3 omega = any_vector();
    memset(&motion, 0, sizeof motion);
    if (vm_torque_free_init(&motion, &b, any) < 0) return;
    if (vm_torque_free_attitude(&motion, any, &q, &omega) >= 0) sink[0] = q.w + omega.x;
    if (vm_torque_free_at(&motion, any, &later) >= 0) sink[1] = later.q.w;
}

void eva_breaks(void)
{
    vm_broken_rotor r;
    vm_broken_rotor_piece piece;
    vm_broken_rotor_break b;
    vm_real y[6] = {any, any, any, any, any, any};
    memset(&b, 0, sizeof b);
    r.mass = any;
    r.inertia = any;
    r.stiffness = any;
    r.damping = any;
    r.torque = any;
    r.s = any;
    piece.mass = any;
    piece.inertia = any;
    piece.distance = any;
    piece.alpha = any;
    piece.radius = any;
    piece.contact = any;
    if (vm_broken_rotor_break_off(&r, y, &piece, &b) >= 0) sink[0] = b.spin_piece;
}

void eva_balance(void)
{
    const vm_body before = any_body(), after[2] = {any_body(), any_body()};
    const vm_impulse j = any_impulse();
    vm_balance b;
    memset(&b, 0, sizeof b);
    if (vm_balance_between(1, &before, 2, after, any_int ? &j : NULL, any_vector(), &b) >= 0) sink[0] = b.energy;
}

void eva_jumps_relative(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_impulse j = any_impulse();
    vm_body c = any_body();
    if (vm_separate_relative(&a, &b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega.x;
    if (vm_attach_relative(&a, &b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega.x;
}

/* ---- Streams, supplies, orbits, the drum ---- */

vm_stream any_stream(void)
{
    vm_stream s;
    s.rate = any;
    s.at = any_vector();
    s.velocity = any_vector();
    s.spin = any_vector();
    s.gyration = any_inertia();
    s.motion = any_int;
    s.from = NULL;
    return s;
}

void eva_streams(void)
{
    const vm_body b = any_body();
    const vm_stream s[2] = {any_stream(), any_stream()};
    vm_reactive loads;
    vm_vec3 acceleration = any_vector(), spin = any_vector();
    memset(&loads, 0, sizeof loads);
    if (vm_reactive_loads(&b, any_vector(), 2, s, &loads) < 0) return;
    if (vm_accelerations(&b, &loads, any_vector(), any_vector(), &acceleration, &spin) >= 0) sink[0] = acceleration.x + spin.x;
}

void eva_flows(void)
{
    vm_stream s[2] = {any_stream(), any_stream()};
    const vm_body b = any_body();
    vm_real y[VM_FLOW_BALANCED_STATES], rates[VM_FLOW_BALANCED_STATES];
    vm_flow flow;
    vm_body now = any_body();
    int i;
    for (i = 0; i < VM_FLOW_BALANCED_STATES; i++) y[i] = rates[i] = any;
    memset(&flow, 0, sizeof flow);
    flow.n = 2;
    flow.streams = s;
    flow.force = any_vector();
    flow.moment = any_vector();
    flow.mass = any;
    flow.centre = any_vector();
    flow.inertia = any_inertia();
    flow.drift = any_vector();
    flow.y_size = any_int;
    if (vm_flow_start(&flow, &b, y) >= 0) sink[0] = y[0];
    for (i = 0; i < VM_FLOW_BALANCED_STATES; i++) y[i] = any;
    if (vm_flow_rhs(any, y, rates, &flow) >= 0) sink[1] = rates[0];
    if (vm_flow_given_rhs(any, y, rates, &flow) >= 0) sink[2] = rates[0];
    if (vm_flow_balanced_rhs(any, y, rates, &flow) >= 0) sink[3] = rates[0];
    if (vm_flow_carried_rhs(any, y, rates, &flow) >= 0) sink[4] = rates[0];
    if (vm_translation_rhs(any, y, rates, &flow) >= 0) sink[5] = rates[0];
    if (vm_flow_body(&flow, any_int ? VM_FLOW_STATES : VM_FLOW_GIVEN_STATES, y, &now) >= 0) sink[6] = now.mass;
    sink[7] = vm_flow_mass_left(any, y, &flow) + vm_flow_inertia_left(any, y, &flow);
}

void eva_plane_flows(void)
{
    vm_stream2 s2[2];
    vm_stream1 s1[2];
    vm_flow2 flow2;
    vm_flow1 flow1;
    vm_real y[VM_FLOW2_STATES], rates[VM_FLOW2_STATES];
    int i;
    for (i = 0; i < VM_FLOW2_STATES; i++) y[i] = rates[i] = any;
    for (i = 0; i < 2; i++) {
        s1[i].rate = s2[i].rate = any;
        s1[i].velocity = any;
        s1[i].motion = s2[i].motion = any_int;
        s2[i].x = any;
        s2[i].y = any;
        s2[i].vx = any;
        s2[i].vy = any;
        s2[i].spin = any;
        s2[i].gyration = any;
    }
    memset(&flow1, 0, sizeof flow1);
    memset(&flow2, 0, sizeof flow2);
    flow1.n = flow2.n = 2;
    flow1.streams = s1;
    flow2.streams = s2;
    flow1.force = any;
    flow2.fx = any;
    flow2.fy = any;
    flow2.moment = any;
    if (vm_flow1_rhs(any, y, rates, &flow1) >= 0) sink[0] = rates[0];
    if (vm_flow2_rhs(any, y, rates, &flow2) >= 0) sink[1] = rates[0];
}

void eva_closed_flows(void)
{
    vm_stream1 s;
    vm_jet jet;
    vm_vec3 omega = any_vector();
    vm_real x = any, v = any;
    s.rate = any;
    s.velocity = any;
    s.motion = any_int;
    sink[0] = vm_velocity_by_momentum(any, any, any, any, any) + vm_tsiolkovsky(any, any, any, any);
    if (vm_linear_flow(&s, any, any, any, any, any, &x, &v) >= 0) sink[1] = x + v;
    jet.rate = any;
    jet.axial = any;
    jet.transverse = any;
    jet.gyration_axial = any;
    jet.gyration_transverse = any;
    jet.gyration_out = any;
    jet.nozzle = any;
    if (vm_jet_damping(&jet, any, any_vector(), &omega) >= 0) sink[2] = omega.x;
}

void eva_supply(void)
{
    vm_supply s;
    vm_supply_left left;
    memset(&left, 0, sizeof left);
    s.kind = any_int;
    s.at = any_vector();
    s.axis = any_vector();
    s.length = any;
    s.radius = any;
    s.bore = any;
    s.full = any;
    if (vm_supply_at(&s, any, &left) >= 0) sink[0] = left.size;
}

void eva_orbit(void)
{
    vm_vec3 r = any_vector(), v = any_vector();
    if (vm_orbit(any, any, any_vector(), any_vector(), &r, &v) >= 0) sink[0] = r.x + v.x;
    if (vm_orbit_meshchersky(any, any, any, any_vector(), any_vector(), &r, &v) >= 0) sink[1] = r.x + v.x;
}

vm_drum any_drum(void)
{
    vm_drum d;
    d.radius = any;
    d.mass = any;
    d.inertia = any;
    d.band = any;
    d.speed = any;
    d.damping = any;
    d.stiffness = any;
    d.omega = any;
    return d;
}

void eva_drum(void)
{
    vm_drum d = any_drum();
    vm_real y[8] = {any, any, any, any, any, any, any, any}, rates[8] = {0};
    vm_drum_geometry g;
    memset(&g, 0, sizeof g);
    sink[0] = vm_drum_band(any, any, any, any);
    if (vm_drum_at(&d, any, &g) >= 0) sink[1] = g.mass;
    if (vm_drum_rhs(any, y, rates, &d) >= 0) sink[2] = rates[0];
    if (vm_drum_rhs_reduced(any, y, rates, &d) >= 0) sink[3] = rates[0];
    if (vm_drum_rhs_angle(any, y, rates, &d) >= 0) sink[4] = rates[0];
    if (vm_drum_rhs_coupled(any, y, rates, &d) >= 0) sink[5] = rates[0];
    sink[6] = vm_drum_rate(&d, any) + vm_drum_stop(&d) + vm_drum_rate_elastic(&d, any, any);
}

void eva_drum_angle(void)
{
    vm_drum d = any_drum();
    sink[0] = vm_drum_time(&d, any);
    sink[1] = vm_drum_angle(&d, any);
    sink[2] = vm_drum_angle_lambert(&d, any);
}

void eva_drum_shaft(void)
{
    vm_drum d = any_drum();
    vm_drum_shaft s;
    vm_real a = any, b = any, x[2] = {any, any}, slope[2] = {any, any};
    memset(&s, 0, sizeof s);
    if (vm_drum_shaft_init(&s, &d) < 0) return;
    sink[0] = vm_drum_deflection(&s, any, any, any, any) + vm_drum_deflection_slope(&s, any, any, any, any);
    if (vm_drum_deflection_start(&s, any, any, any, &a, &b) >= 0) sink[1] = a + b;
    if (vm_drum_unbalance(&d, any, x, slope) >= 0) sink[2] = x[0] + slope[1];
    sink[3] = (vm_real)vm_drum_shaft_valid(&s);
}

void eva_lambert(void)
{
    sink[0] = vm_lambert_w0(any) + vm_lambert_wm1(any);
    sink[1] = vm_wright_omega(any) + vm_lambert_w0_neg_exp(any) + vm_lambert_wm1_neg_exp(any);
}

vm_band any_band(void)
{
    vm_band b;
    b.radius = any;
    b.thickness = any;
    b.width = any;
    b.density = any;
    b.speed = any;
    b.reactive = any;
    b.by_layer = any_int;
    return b;
}

void eva_band(void)
{
    const vm_band b = any_band();
    sink[0] = vm_band_at(any, &b).mass;
    sink[1] = vm_force_damper(any, any) + vm_force_gravity(any, any);
}

void eva_eigenvalues(void)
{
    vm_broken_rotor r;
    vm_real re[5] = {any, any, any, any, any}, im[5] = {any, any, any, any, any};
    r.mass = any;
    r.inertia = any;
    r.stiffness = any;
    r.damping = any;
    r.torque = any;
    r.s = any;
    if (vm_broken_rotor_eigenvalues(&r, any, re, im) >= 0) sink[0] = re[0] + im[0];
}

void eva_torque_free_principal(void)
{
    vm_torque_free motion;
    vm_quat q = any_quat();
    vm_vec3 omega = any_vector();
    memset(&motion, 0, sizeof motion);
    if (vm_torque_free_init_principal(&motion, any_vector(), any_quat(), any_vector(), any) < 0) return;
    if (vm_torque_free_attitude(&motion, any, &q, &omega) >= 0) sink[0] = q.w + omega.x;
}

/* ---- Status names ---- */

void eva_names(void)
{
    const char *name = vm_strerror(any_int);
    sink[0] = (vm_real)name[0];
    name = vm_osc_route_name(any_int);
    sink[1] = (vm_real)name[0];
    sink[2] = vm_osc_approximation_errors(any).trig_x;
}

/* ---- Lagrange's equations ---- */

static void lagrange_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    sink[1] = q[0] + q[1];
    masses[0] = any;
}

static vm_real lagrange_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    sink[1] = q[0] + q[1] + rates[0] + rates[1] + masses[0];
    return any;
}

static int lagrange_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    sink[1] = q[0] + q[1] + rates[0] + rates[1] + masses[0];
    Q[0] = any;
    Q[1] = any;
    return any_int;
}

void eva_lagrange_jumps(void)
{
    const vm_real a[4] = {any, any, any, any}, b[4] = {any, any, any, any}, q[2] = {any, any}, p[2] = {any, any};
    vm_real after[2] = {any, any}, work[VM_LAGRANGE_WORK(2)];
    if (vm_lagrange_separate(2, a, b, q, any_int ? p : NULL, any_int ? p : NULL, after, work) >= 0) sink[0] = after[0];
    if (vm_lagrange_attach(2, a, b, q, any_int ? p : NULL, any_int ? p : NULL, after, work) >= 0) sink[1] = after[0];
    if (vm_lagrange_impact(2, a, q, p, after, work) >= 0) sink[2] = after[0];
}

void eva_lagrange_shares(void)
{
    const vm_body b = any_body();
    const vm_impulse j = any_impulse();
    const vm_vec3 dr[2] = {any_vector(), any_vector()}, turn[2] = {any_vector(), any_vector()};
    vm_real matrix[4] = {any, any, any, any}, p[2] = {any, any};
    vm_lagrange_mass(2, &b, any_int ? dr : NULL, any_int ? turn : NULL, matrix);
    vm_lagrange_momentum(2, &b, any_int ? dr : NULL, any_int ? turn : NULL, p);
    vm_lagrange_impulse(2, &j, any_vector(), any_int ? dr : NULL, any_int ? turn : NULL, p);
    vm_lagrange_add_force(2, any_vector(), any_int ? dr : NULL, any_vector(), any_int ? turn : NULL, p);
    sink[0] = p[0] + matrix[0];
}

void eva_lagrange(void)
{
    const vm_real scales[2] = {any, any}, q[2] = {any, any}, rates[2] = {any, any}, a[2] = {any, any};
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 1)], y[4] = {any, any, any, any}, found[4] = {any, any, any, any};
    vm_lagrange_system s;
    s.n = 2;
    s.n_masses = 1;
    s.masses = lagrange_masses;
    s.energy = lagrange_energy;
    s.forces = any_int ? lagrange_forces : NULL;
    s.ctx = NULL;
    s.scales = any_int ? scales : NULL;
    s.work = work;
    if (vm_lagrange_start(&s, any, q, rates, y) >= 0) sink[0] = y[0];
    if (vm_lagrange_rates(&s, any, y, found) >= 0) sink[1] = found[0];
    if (vm_lagrange_rhs(any, y, found, &s) >= 0) sink[2] = found[0];
    if (vm_lagrange_drive_forces(&s, any, any, q, rates, a, found) >= 0) sink[3] = found[0];
    if (vm_lagrange_needed_forces(&s, any, any, q, rates, a, found) >= 0) sink[4] = found[0];
    sink[5] = vm_lagrange_partial_q(&s, any, q, rates, any_int ? 1 : 0);
}

#include "eva_oscillators.h"
#include "eva_scenes.h"
