/* For Frama-C's EVA (tests/eva.sh): functions of varmass.h with any numbers, NaN and infinities among them. Here are vectors
   and attitudes, jumps in the plane and in space, bodies on an axle, pendulums, streams, supplies, orbits, the drum,
   Lambert's function, oscillators of constant mass, laws of time and scenes. tests/eva_left_out.txt has the other public
   functions of varmass.h, on which EVA does not come to its end or which it has not been tried on. */
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
    vm_real c[9] = {any, any, any, any, any, any, any, any, any}, angles[3];
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
    vm_body2 c;
    if (vm_separate2(&a, b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega;
    if (vm_attach2(&a, b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega;
    if (vm_separate_all2(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[2] = c.omega;
    if (vm_attach_all2(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[3] = c.omega;
}

void eva_jumps(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_impulse j = any_impulse();
    vm_body c;
    if (vm_separate(&a, &b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega.x;
    if (vm_attach(&a, &b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega.x;
}

void eva_jumps_of_several(void)
{
    const vm_body a = any_body(), b[2] = {any_body(), any_body()};
    const vm_impulse j = any_impulse();
    vm_body c;
    if (vm_separate_all(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[0] = c.omega.x;
    if (vm_attach_all(&a, 2, b, any_int ? &j : NULL, &c) >= 0) sink[1] = c.omega.x;
    sink[2] = vm_energy_gain(&a, 2, b, &j, &c) + vm_energy_loss(&a, 2, b, &j, &c);
}

void eva_inertias(void)
{
    const vm_inertia a = any_inertia(), b = any_inertia();
    vm_inertia whole;
    vm_vec3 centre;
    if (vm_combine_inertia(any, &a, any, &b, any_vector(), &whole, &centre) >= 0) sink[0] = whole.xx + centre.x;
    if (vm_split_inertia(any, &a, any, &b, any_vector(), &whole, &centre) >= 0) sink[1] = whole.xx + centre.x;
}

void eva_relative(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_body2 a2 = any_body2(), b2 = any_body2();
    vm_body c;
    vm_body2 c2;
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
    const vm_real number = any;
    vm_body2 c;
    if (vm_separation_for_rest2(&a, &b, &j, any_int ? &number : NULL, any_int ? &number : NULL, &c) >= 0) sink[0] = c.omega;
    if (vm_separation_for_spin2(&a, &b, &j, any, &c) >= 0) sink[1] = c.omega;
}

void eva_inverse(void)
{
    const vm_body a = any_body(), b = any_body();
    const vm_impulse j = any_impulse();
    const vm_vec3 v = any_vector();
    vm_body c;
    if (vm_separation_for_rest(&a, &b, &j, any_int ? &v : NULL, any_int ? &v : NULL, &c) >= 0) sink[0] = c.omega.x;
}

void eva_axle(void)
{
    const vm_body a = any_body(), b[2] = {any_body(), any_body()};
    const vm_impulse j = any_impulse();
    vm_axle axle;
    vm_impulse reaction;
    vm_body c;
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
    vm_vec3 acceleration, spin;
    if (vm_reactive_loads(&b, any_vector(), 2, s, &loads) < 0) return;
    if (vm_accelerations(&b, &loads, any_vector(), any_vector(), &acceleration, &spin) >= 0) sink[0] = acceleration.x + spin.x;
}

void eva_closed_flows(void)
{
    vm_stream1 s;
    vm_jet jet;
    vm_vec3 omega;
    vm_real x, v;
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
    vm_vec3 r, v;
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
    vm_real y[8] = {any, any, any, any, any, any, any, any}, rates[8];
    vm_drum_geometry g;
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
    vm_real a, b, x[2], slope[2];
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

/* ---- Oscillators ---- */

void eva_oscillators(void)
{
    vm_real x, v;
    sink[0] = vm_osc_period(any, any, any) + vm_osc_vmax(any, any, any) + vm_osc_energy(any, any, any, any);
    vm_osc_amplitude_phase(any, any, any, any, &x, &v);
    sink[1] = x + v;
}

void eva_osc_exact(void)
{
    vm_real x, v;
    vm_osc_exact(any, any, any, any, &x, &v);
    vm_osc_exact_from(any, any, any, any, any, &x, &v);
    sink[0] = x + v;
}

vm_law any_law(void)
{
    if (any_int) return vm_law_linear(any, any);
    if (any_int) return vm_law_quadratic(any, any, any);
    if (any_int) return vm_law_power(any, any, any);
    return vm_law_exponential(any, any);
}

void eva_laws(void)
{
    const vm_law law = any_law();
    vm_real f, rate;
    if (vm_law_at(&law, any, &f, &rate) >= 0) sink[0] = f + rate;
}

/* ---- Scenes ---- */

void eva_scene(void)
{
    vm_scene s;
    vm_scene_body bodies[2];
    vm_effect effects[2];
    vm_real y[32], rates[32];
    memset(&s, 0, sizeof s);
    bodies[0] = vm_scene_body_line(any, any, any);
    bodies[1] = vm_scene_body_plane(any, any, any_vector(), any, any_vector(), any);
    effects[0] = vm_effect_gravity(0, 0, any);
    effects[1] = vm_effect_spring(0, 0, 1, 0, any, any, any);
    s.bodies = bodies;
    s.n_bodies = 2;
    s.effects = effects;
    s.n_effects = 2;
    if (vm_scene_start(&s, any, y, NULL) < 0) return;
    if (vm_scene_rhs(any, y, rates, &s) >= 0) sink[0] = rates[0];
}
