/* varmass.h, scenes: springs, joints and contacts at points of bodies. A double pendulum, a slider-crank and a top
   against Lagrange's equations and integrals of motion; pendulums that lose mass against lagrange.h; long runs; what is
   refused. */
#include "stage_check.h"

static const vm_vec3 origin = {0, 0, 0};
static vm_real room[VM_JOINTS_WORK(6)];

static vm_joints joints_of(vm_joint *list, int n, double rate)
{
    vm_joints joints;
    joints.joints = list;
    joints.n_joints = n;
    joints.rate = REAL(rate);
    joints.work = room;
    joints.work_size = VM_LENGTH(room);
    return joints;
}

/* Integrates a reference to t_end with a tolerance close to the rounding errors. */
static void reference(ode_rhs rhs, void *ctx, int n, vm_real *y, vm_real t_end)
{
    static vm_real work[RK87_WORK(4)];
    rk45_options o = rk45_defaults(NULL);
    rk87 run_of;
    o.rtol = 20 * VM_EPSILON;
    o.atol = o.rtol;
    CHECK(rk87_init(&run_of, rhs, ctx, n, 0, y, &o, work) >= 0);
    CHECK(rk87_solve(&run_of, t_end) >= 0);
    memcpy(y, run_of.y, (size_t)n * sizeof *y);
}

/* ---- Springs between points ---- */

/* Two bodies, one of them free and turning, on a spring with a damper: momentum and angular momentum stay, and the
   kinetic energy changes by what the spring gives and the damper takes. */
static void check_spring_in_space(double damping)
{
    vm_point_spring spring = {{REAL(0.3), REAL(-0.2), REAL(0.5)}, {0, 0, 0}, 40, REAL(damping), REAL(0.5)};
    const vm_body free_body = probe();
    vm_vec3 r, v, q, w;
    vm_budget now;
    double before, after;
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_free(&free_body));
    stage_body(&s, vm_scene_body_point(2, stage_vec(2, 0, 1), stage_vec(0, 0.5, 0)));
    stage_effect(&s, vm_effect_point_spring(0, 1, &spring));
    begin(&s);
    vm_scene_point_at(&s.scene, 0, spring.at, s.y, &r, &v);
    vm_scene_point_at(&s.scene, 1, origin, s.y, &q, &w);
    before = (double)size_of(vm_sub(r, q)) - 0.5;
    run(&s, 3, VM_OK);
    vm_scene_point_at(&s.scene, 0, spring.at, s.y, &r, &v);
    vm_scene_point_at(&s.scene, 1, origin, s.y, &q, &w);
    after = (double)size_of(vm_sub(r, q)) - 0.5;
    balanced(&s, "spring in space", 10, 100);
    CHECK(vm_scene_budget_at(&s.scene, s.t, s.y, &now) == VM_OK);
    agrees("spring in space", "impulse", size_of(now.impulse), 0, 10, 1e-12);
    agrees("spring in space", "angular impulse", size_of(now.angular_impulse), 0, 10, 1e-9);
    if (damping == 0) agrees("spring in space", "work", now.work, 20 * (before * before - after * after), 20, 1e-8);
    else CHECK((double)now.work < 20 * (before * before - after * after) - 0.1);
}

/* A bar that turns about its mass centre, held by a spring between its end and a point of the ground: the equation of
   motion of the angle has a closed form for the length. */
static int turning_bar(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const double a = (double)y[0], x = 0.5 * cos(a) - 2, h = 0.5 * sin(a) - 1, l = sqrt(x * x + h * h);
    const double by_a = (-x * 0.5 * sin(a) + h * 0.5 * cos(a)) / l; /* dl/da */
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = REAL(-(30 * (l - 0.3) + 2 * by_a * (double)y[1]) * by_a / 0.4);
    return 0;
}

static void check_spring_in_plane(void)
{
    const vm_point_spring spring = {{REAL(0.5), 0, 0}, {2, 1, 0}, 30, 2, REAL(0.3)};
    vm_real y[2] = {REAL(0.2), 0};
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_axle(REAL(0.4), REAL(0.2), 0));
    stage_effect(&s, vm_effect_point_spring(0, VM_GROUND, &spring));
    begin(&s);
    run(&s, 2, VM_OK);
    reference(turning_bar, NULL, 2, y, 2);
    agrees("spring in the plane", "angle", s.y[0], (double)y[0], 1, 1e-9);
    agrees("spring in the plane", "omega", s.y[1], (double)y[1], 1, 1e-9);
}

/* ---- A double pendulum ---- */

/* Two bars, pinned at a distance of 0.5 m and 0.4 m above their mass centres; the first is 1.1 m long to the second
   pin. */
static int two_bars(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const double m1 = 2, i1 = 0.3, a1 = 0.5, l = 1.1, m2 = 1.5, i2 = 0.1, a2 = 0.4;
    const double p = (double)y[0], q = (double)y[1], u = (double)y[2], w = (double)y[3];
    const double c = m2 * l * a2 * cos(p - q), s = m2 * l * a2 * sin(p - q);
    const double A = i1 + m1 * a1 * a1 + m2 * l * l, B = i2 + m2 * a2 * a2;
    const double f = -s * w * w - (m1 * a1 + m2 * l) * gravity * sin(p), h = s * u * u - m2 * a2 * gravity * sin(q);
    (void)t;
    (void)ctx;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = REAL((f * B - h * c) / (A * B - c * c));
    dydt[3] = REAL((h * A - f * c) / (A * B - c * c));
    return 0;
}

/* Places the two bars at rest, the angles measured from the downward vertical. */
static void two_bars_at(stage *s, double p, double q, vm_joint *list)
{
    const vm_vec3 r = stage_vec(0.5 * sin(p), -0.5 * cos(p), 0);
    const vm_vec3 far_end = stage_vec(1.1 * sin(p) + 0.4 * sin(q), -1.1 * cos(p) - 0.4 * cos(q), 0);
    stage_body(s, vm_scene_body_plane(2, REAL(0.3), r, REAL(p), origin, 0));
    stage_body(s, vm_scene_body_plane(REAL(1.5), REAL(0.1), far_end, REAL(q), origin, 0));
    list[0] = vm_joint_pin(0, stage_vec(0, 0.5, 0), VM_GROUND, origin);
    list[1] = vm_joint_pin(1, stage_vec(0, 0.4, 0), 0, stage_vec(0, -0.6, 0));
    stage_effect(s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(s, vm_effect_gravity(1, 1, REAL(-gravity)));
}

static void check_double_pendulum(void)
{
    const double end = is_float ? 1.5 : 3; /* errors grow quickly */
    vm_real y[4] = {REAL(1.2), REAL(-0.7), 0, 0};
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    stage s;
    stage_clear(&s, 3);
    two_bars_at(&s, 1.2, -0.7, list);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, end, VM_OK);
    reference(two_bars, NULL, 4, y, REAL(end));
    agrees("double pendulum", "angle", s.y[2], (double)y[0], 1, 1e-8);
    agrees("double pendulum", "angle", s.y[8], (double)y[1], 1, 1e-8);
    agrees("double pendulum", "omega", s.y[5], (double)y[2], 1, 1e-8);
    agrees("double pendulum", "omega", s.y[11], (double)y[3], 1, 1e-8);
    balanced(&s, "double pendulum", 10, 10);
}

/* Energy and distances of a pendulum over a long time: what stabilisation leaves. */
static void check_drift(void)
{
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    const double start = -2 * gravity * 0.5 * cos(1.2) - 1.5 * gravity * (1.1 * cos(1.2) + 0.4 * cos(0.7));
    double energy, most = 0;
    int i;
    stage s;
    stage_clear(&s, 200);
    two_bars_at(&s, 1.2, -0.7, list);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    for (i = 1; i <= 20; i++) {
        vm_vec3 a, b, v;
        run(&s, i * (is_float ? 1 : 10), VM_OK);
        vm_scene_point_at(&s.scene, 0, list[0].at, s.y, &a, &v);
        if ((double)size_of(a) > most) most = (double)size_of(a);
        vm_scene_point_at(&s.scene, 0, list[1].other_at, s.y, &a, &v);
        vm_scene_point_at(&s.scene, 1, list[1].at, s.y, &b, &v);
        if ((double)size_of(vm_sub(a, b)) > most) most = (double)size_of(vm_sub(a, b));
    }
    energy = (2 * (double)(s.y[3] * s.y[3] + s.y[4] * s.y[4]) + 0.3 * (double)(s.y[5] * s.y[5]) +
              1.5 * (double)(s.y[9] * s.y[9] + s.y[10] * s.y[10]) + 0.1 * (double)(s.y[11] * s.y[11])) / 2 +
             gravity * (2 * (double)s.y[1] + 1.5 * (double)s.y[7]);
    check_error("drift", "distance", "abs", most, is_float ? 2e-5 : 2e-10, 200, most);
    check_error("drift", "energy", "rel", fabs(energy - start) / 30, is_float ? 1e-3 : 1e-8, start, energy);
}

/* ---- Pendulums that lose mass ---- */

/* A bar that turns about the origin, J = 1.2 kg m^2 and M c = 2 kg m about it. At 0.9 m mass of 2 kg is lost at 0.5
   kg/s, with the velocity of the bar there and u = 4 m/s along the bar's motion, so that Q = m' s^2 q' + m' s u. */
static void leaking_masses(vm_real t, const vm_real *q, vm_real *m, void *ctx)
{
    (void)q;
    (void)ctx;
    m[0] = 2 - t / 2;
}

static vm_real leaking_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *m, void *ctx)
{
    (void)t;
    (void)q;
    (void)ctx;
    return (REAL(1.2) + m[0] * REAL(0.81)) * rates[0] * rates[0] / 2;
}

static int leaking_force(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *m, vm_real *Q, void *ctx)
{
    (void)t;
    (void)ctx;
    Q[0] = REAL(-gravity * sin((double)q[0]) * (2 + 0.9 * (double)m[0]) - 0.5 * (0.81 * (double)rates[0] + 0.9 * 4));
    return 0;
}

static void leaking_reference(vm_real angle, vm_real t_end, vm_real *q, vm_real *rate)
{
    static vm_real work[VM_LAGRANGE_RHS_WORK(1, 1)];
    const vm_real rates[1] = {0};
    vm_real y[2];
    vm_lagrange_system bar = {1, 1, leaking_masses, leaking_energy, leaking_force, NULL, NULL, NULL};
    bar.work = work;
    CHECK(vm_lagrange_start(&bar, 0, &angle, rates, y) == VM_OK);
    reference(vm_lagrange_rhs, &bar, 2, y, t_end);
    CHECK(vm_lagrange_rates(&bar, t_end, y, rate) == VM_OK);
    *q = y[0];
}

/* The bar with the 2 kg as one growing body; its mass centre is then (2 + 1.8)/(6 + 2) m from the pin, if the bar has
   6 kg. */
enum { BAR_MASS = 8 };
static const double bar_centre = 3.8 / BAR_MASS, bar_inertia = 1.2 + 2 * 0.81 - 3.8 * 3.8 / BAR_MASS;

static void leak_effects(stage *s, vm_stream *leak, const vm_joints *joints)
{
    memset(leak, 0, sizeof *leak);
    leak->rate = REAL(-0.5);
    leak->motion = VM_RELATIVE;
    leak->at = stage_vec(0, bar_centre - 0.9, 0);
    leak->velocity = stage_vec(4, 0, 0);
    stage_effect(s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(s, vm_effect_stream_mass(0, leak));
    stage_effect(s, vm_effect_stream_force(0, leak));
    stage_effect(s, vm_effect_stream_moment(0, leak));
    stage_effect(s, vm_effect_stream_torque(0, leak));
    stage_effect(s, vm_effect_joints(joints));
}

static void check_leaking_bar_in_plane(void)
{
    vm_stream leak;
    vm_joint list[1];
    const vm_joints joints = joints_of(list, 1, 10);
    const vm_vec3 r = stage_vec(bar_centre * sin(1.0), -bar_centre * cos(1.0), 0);
    vm_real q, rate;
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_growing_plane(
                       vm_scene_body_plane(BAR_MASS, REAL(bar_inertia), r, 1, origin, 0)));
    list[0] = vm_joint_pin(0, stage_vec(0, bar_centre, 0), VM_GROUND, origin);
    leak_effects(&s, &leak, &joints);
    begin(&s);
    run(&s, 2, VM_OK);
    leaking_reference(1, 2, &q, &rate);
    agrees("leaking bar", "angle", s.y[2], (double)q, 1, 1e-9);
    agrees("leaking bar", "omega", s.y[5], (double)rate, 1, 1e-9);
    balanced(&s, "leaking bar", 100, 100);
}

/* The same bar as a free body on a ball joint swings in the plane of x and y. */
static void check_leaking_bar_in_space(void)
{
    vm_stream leak;
    vm_joint list[1];
    const vm_joints joints = joints_of(list, 1, 10);
    vm_body bar = part_of(BAR_MASS, bar_inertia), now;
    vm_real q, rate;
    stage s;
    bar.inertia.yy = REAL(0.3);
    bar.r = stage_vec(bar_centre * sin(1.0), -bar_centre * cos(1.0), 0);
    bar.q.w = REAL(cos(0.5));
    bar.q.z = REAL(sin(0.5));
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_growing_free(vm_scene_body_free(&bar)));
    list[0] = vm_joint_pin(0, stage_vec(0, bar_centre, 0), VM_GROUND, origin);
    leak_effects(&s, &leak, &joints);
    begin(&s);
    run(&s, 2, VM_OK);
    leaking_reference(1, 2, &q, &rate);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("leaking bar in space", "omega", now.omega.z, (double)rate, 1, 1e-9);
    agrees("leaking bar in space", "attitude", now.q.z / now.q.w, tan((double)q / 2), 1, 1e-9);
    balanced(&s, "leaking bar in space", 100, 100);
}

/* ---- Closed chains ---- */

/* A crank of 0.3 m on an axle, a connecting rod of 1 m and a slider, without any force: the energy gives the angular
   velocity at each angle, J(a) omega^2 = const. */
static double crank_inertia(double a, double *x)
{
    const double r = 0.3, s = r * sin(a), c = sqrt(1 - s * s), ratio = r * cos(a) / c; /* b' = -ratio a', sin b = -s */
    const double vx = -r * sin(a) - s * ratio, px = -r * sin(a) - s * ratio / 2, py = r * cos(a) / 2;
    *x = r * cos(a) + c;
    return 0.2 + 1.5 * (px * px + py * py) + 0.125 * ratio * ratio + 2 * vx * vx;
}

static void check_slider_crank(void)
{
    const double a = 0.7, omega = 6, s0 = 0.3 * sin(a), c0 = sqrt(1 - s0 * s0), ratio = 0.3 * cos(a) / c0;
    const vm_vec3 r = stage_vec(0.3 * cos(a) + c0 / 2, s0 / 2, 0);
    const vm_vec3 v = stage_vec((-s0 - s0 * ratio / 2) * omega, 0.15 * cos(a) * omega, 0);
    double x0, x, wanted;
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 20);
    stage s;
    stage_clear(&s, 4);
    wanted = crank_inertia(a, &x0) * omega * omega;
    stage_body(&s, vm_scene_body_axle(REAL(0.2), REAL(a), REAL(omega)));
    stage_body(&s, vm_scene_body_plane(REAL(1.5), REAL(0.125), r, -REAL(asin(s0)), v, REAL(-ratio * omega)));
    stage_body(&s, vm_scene_body_line(2, REAL(x0), REAL((-s0 - s0 * ratio) * omega)));
    list[0] = vm_joint_pin(0, stage_vec(0.3, 0, 0), 1, stage_vec(-0.5, 0, 0));
    list[1] = vm_joint_pin(1, stage_vec(0.5, 0, 0), 2, origin);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 4, VM_OK);
    CHECK(s.y[0] > 12); /* several turns */
    wanted = sqrt(wanted / crank_inertia((double)s.y[0], &x));
    agrees("slider-crank", "omega", s.y[1], wanted, 6, 1e-9);
    agrees("slider-crank", "slider", s.y[8], x, 1, 1e-10);
}

/* A parallelogram of three bars of 1 m, pinned to the ground at (0, 0) and (1, 0): the bar between the cranks does not
   turn, so that the mechanism is a pendulum with J = 2 (1/3) + 1 and the moment of weight 2 (1/2) + 1. */
static int parallelogram(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = REAL(-gravity * 2 / (5. / 3) * sin((double)y[0]));
    return 0;
}

static void check_four_bar(void)
{
    const double q = 0.8, x = sin(q), h = -cos(q);
    vm_real y[2] = {REAL(0.8), 0};
    vm_joint list[4];
    const vm_joints joints = joints_of(list, 4, 10);
    int i;
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_plane(1, 1 / REAL(12), stage_vec(x / 2, h / 2, 0), REAL(q), origin, 0));
    stage_body(&s, vm_scene_body_plane(1, 1 / REAL(12), stage_vec(1 + x / 2, h / 2, 0), REAL(q), origin, 0));
    stage_body(&s, vm_scene_body_plane(1, 1 / REAL(12), stage_vec(0.5 + x, h, 0), 0, origin, 0));
    list[0] = vm_joint_pin(0, stage_vec(0, 0.5, 0), VM_GROUND, origin);
    list[1] = vm_joint_pin(1, stage_vec(0, 0.5, 0), VM_GROUND, stage_vec(1, 0, 0));
    list[2] = vm_joint_pin(0, stage_vec(0, -0.5, 0), 2, stage_vec(-0.5, 0, 0));
    for (i = 0; i < 3; i++) stage_effect(&s, vm_effect_gravity(i, 1, REAL(-gravity)));
    list[3] = vm_joint_pin(1, stage_vec(0, -0.5, 0), 2, stage_vec(0.5, 0, 0));
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 3, VM_OK);
    reference(parallelogram, NULL, 2, y, 3);
    agrees("parallelogram", "angle", s.y[2], (double)y[0], 1, 1e-8);
    agrees("parallelogram", "angle", s.y[8], (double)y[0], 1, 1e-8);
    agrees("parallelogram", "turn", s.y[14], 0, 1, 1e-10);
    balanced(&s, "parallelogram", 10, 10);
}

/* ---- Space ---- */

/* A symmetric top on a ball joint precesses steadily: with the spin w about its axis and the tilt 90 degrees, the
   precession is W = M g c/(C w), exactly. */
static void check_top(void)
{
    const double c = 0.4, w = 60, precession = 3 * gravity * c / (0.05 * w);
    vm_body top = part_of(3, 0.02), now;
    vm_joint list[1];
    const vm_joints joints = joints_of(list, 1, 10);
    stage s;
    top.inertia.xx = REAL(0.05);
    top.inertia.yy = top.inertia.zz = REAL(0.03);
    top.r = stage_vec(c, 0, 0);
    top.v = stage_vec(0, c * precession, 0);
    top.omega = stage_vec(w, 0, precession);
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_free(&top));
    list[0] = vm_joint_pin(0, stage_vec(-c, 0, 0), VM_GROUND, origin);
    stage_effect(&s, vm_effect_gravity(0, 2, REAL(-gravity)));
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    agrees("top", "reaction", list[0].force.z, 3 * gravity, 30, 1e-12);
    agrees("top", "reaction", list[0].force.x, -3 * c * precession * precession, 30, 1e-11);
    run(&s, is_float ? 0.5 : 2, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("top", "x", now.r.x, c * cos(precession * (double)s.t), c, 1e-8);
    agrees("top", "y", now.r.y, c * sin(precession * (double)s.t), c, 1e-8);
    agrees("top", "z", now.r.z, 0, c, 1e-8);
    balanced(&s, "top", 10, 100);
}

/* A thin rod hung up by its end, as a free body, is a pendulum of J = 4/3 m a^2; two points on rods in space keep their
   lengths, their energy and their angular momentum about the vertical. */
static void check_rods(void)
{
    vm_joint list[3];
    const vm_joints joints = joints_of(list, 3, 10);
    vm_body rod = part_of(2, 0), now[3];
    double energy = 0, spin = 0;
    int i;
    stage s;
    rod.inertia.xx = rod.inertia.zz = REAL(2 * 0.25 / 3);
    rod.r = stage_vec(3, 0.5, 0);
    rod.v = stage_vec(0.5, 0, 0);
    rod.omega = stage_vec(0, 0, -1);
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_point(1, stage_vec(0.6, -0.8, 0), stage_vec(0, 0, 2)));
    stage_body(&s, vm_scene_body_point(2, stage_vec(0.6, -0.8, 0.5), stage_vec(0.4, 0.3, 2)));
    stage_body(&s, vm_scene_body_free(&rod));
    list[0] = vm_joint_rod(0, origin, VM_GROUND, origin, 1);
    list[1] = vm_joint_rod(1, origin, 0, origin, REAL(0.5));
    list[2] = vm_joint_pin(2, stage_vec(0, -0.5, 0), VM_GROUND, stage_vec(3, 0, 0));
    for (i = 0; i < 3; i++) stage_effect(&s, vm_effect_gravity(i, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, is_float ? 1 : 3, VM_OK);
    for (i = 0; i < 3; i++) vm_scene_body_at(&s.scene, i, s.y, now + i);
    agrees("rods", "length", size_of(now[0].r), 1, 1, 1e-9);
    agrees("rods", "length", size_of(vm_sub(now[1].r, now[0].r)), 0.5, 1, 1e-9);
    for (i = 0; i < 2; i++) {
        energy += (double)now[i].mass * ((double)vm_dot(now[i].v, now[i].v) / 2 + gravity * (double)now[i].r.y);
        spin += (double)(now[i].mass * (now[i].r.z * now[i].v.x - now[i].r.x * now[i].v.z));
    }
    agrees("rods", "energy", REAL(energy), 2 + 4.25 - 3 * 0.8 * gravity, 20, 1e-9);
    agrees("rods", "angular momentum", REAL(spin), -0.6 * 2 + 2 * (0.5 * 0.4 - 0.6 * 2), 4, 1e-9);
    agrees("rods", "hung up rod", vm_dot(now[2].omega, now[2].omega),
           1 + 2 * 3 * gravity * (0.5 - (double)now[2].r.y), 10, 1e-9);
}

/* A rod of 3 m starts 2 micrometres too long, at rest and without forces. Its deviation C obeys C'' + 2 k C' + k^2 C = 0,
   where k is the field `rate`: it falls as (1 + k t) e^(-k t). */
static void check_rod_too_long(void)
{
    const double excess = 2e-6, rate = 1.5, t = 2;
    vm_joint list[1];
    const vm_joints joints = joints_of(list, 1, rate);
    stage s;
    vm_body now;
    if (is_float) return; /* the deviation would be a few roundings */
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_point(2, stage_vec(3 + excess, 0, 0), origin));
    list[0] = vm_joint_rod(0, origin, VM_GROUND, origin, 3);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, t, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("rod too long", "deviation", REAL(((double)size_of(now.r) - 3) / excess), (1 + rate * t) * exp(-rate * t), 1, 1e-4);
}

/* Two sliders, each with a point on a rod. One rod ends at the mass centre of its slider, the other beside the mass centre
   of its slider, and the second point starts as far beside the first one. A slider does not turn: both move alike. */
static void check_rod_beside_centre(void)
{
    const vm_vec3 arm = stage_vec(0.1, 0.2, -0.3), v = stage_vec(0.9, 0.3, 2), r = stage_vec(0.6, -0.8, 0);
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    int i;
    stage s;
    stage_clear(&s, 2);
    for (i = 0; i < 2; i++) {
        stage_body(&s, vm_scene_body_line(2, 0, REAL(0.5)));
        stage_body(&s, vm_scene_body_point(1, i == 0 ? r : vm_add(r, arm), v));
        stage_effect(&s, vm_effect_gravity(2 * i + 1, 1, REAL(-gravity)));
        list[i] = vm_joint_rod(2 * i, i == 0 ? origin : arm, 2 * i + 1, origin, 1);
    }
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 2, VM_OK);
    agrees("rod beside centre", "slider", s.y[8], (double)s.y[0], 1, 1e-9);
    agrees("rod beside centre", "point", s.y[10], (double)(s.y[2] + arm.x), 1, 1e-9);
    agrees("rod beside centre", "point", s.y[11], (double)(s.y[3] + arm.y), 1, 1e-9);
    agrees("rod beside centre", "point", s.y[12], (double)(s.y[4] + arm.z), 1, 1e-9);
    CHECK(VM_FABS(s.y[4]) > REAL(0.1)); /* out of the plane */
}

/* ---- Jumps ---- */

/* A pendulum of two equal halves lets its lower half go with 3 m/s along its motion: the angular momentum about the
   pin stays, the pin too, and the upper half swings on as a shorter pendulum. The budget changes nothing. */
static void check_separation(int keeps_budget)
{
    const double whole = 4. / 3, half = 2 * (0.25 / 12 + 0.0625), part_inertia = 2 * 0.25 / 12;
    const double before = 2, thrown = 0.75 * 2 * (0.75 * before + 3) + part_inertia * before;
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    vm_body part = part_of(2, part_inertia), now;
    vm_budget budget;
    vm_real omega;
    stage s;
    part.r = stage_vec(0, -0.25, 0);
    part.v = stage_vec(3, 0, 0);
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_plane(4, REAL(4. / 12), stage_vec(0, -0.5, 0), 0, stage_vec(1, 0, 0), 2));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_plane(1, 1, origin, 0, origin, 0)));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_plane(1, 1, origin, 0, origin, 0)));
    list[0] = vm_joint_pin(0, stage_vec(0, 0.5, 0), VM_GROUND, origin);
    list[1] = vm_joint_pin(0, origin, 2, origin); /* to a body that never comes */
    if (!keeps_budget) vm_scene_keep_budget(&s.scene, NULL);
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_joints(&joints));
    stage_event(&s, vm_then_separate_in_plane(vm_event_at(0), 0, 1, &part, 1));
    begin(&s);
    run(&s, 0, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    omega = now.omega.z;
    agrees("separation", "omega", omega, (whole * before - thrown) / half, 5, 1e-12);
    agrees("separation", "v", now.v.x, 0.25 * (double)omega, 5, 1e-12);
    agrees("separation", "v", now.v.y, 0, 5, 1e-12);
    run(&s, 1, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("separation", "length", size_of(now.r), 0.25, 1, 1e-10);
    agrees("separation", "energy", now.omega.z * now.omega.z,
           (double)(omega * omega) - 2 * 2 * gravity * (0.25 + (double)now.r.y) / half, 600, 1e-10);
    if (!keeps_budget) return;
    balanced(&s, "separation", 10, 10);
    CHECK(vm_scene_budget_at(&s.scene, s.t, s.y, &budget) == VM_OK && budget.jump_energy != 0);
}

/* ---- Contact ---- */

/* A ball falls from 1 m and bounces on a damped ground: one half-wave under the weight, then flight. */
static void check_bounce(void)
{
    const double k = 4000, d = 20, m = 2, v0 = sqrt(2 * gravity), delta = d / (2 * m);
    vm_contact ground = {{0, 0, 0}, REAL(0.1), {0, 0, 0}, {0, 2, 0}, REAL(k), REAL(d)};
    const double w = sqrt(k / m - delta * delta), rest = -m * gravity / k;
    double t = 2.2 / w, h = 1, v = 0, last;
    int i;
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_point(REAL(m), stage_vec(0, 1.1, 0), origin));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_contact(0, &ground));
    stage_event(&s, vm_event_contact(0, &ground));
    for (i = 0; i < 60; i++) { /* until the ground would pull: Newton's method on height(t) k + d velocity(t) = 0 */
        const double A = -rest, B = (-v0 + delta * A) / w, e = exp(-delta * t);
        h = rest + e * (A * cos(w * t) + B * sin(w * t));
        v = e * ((B * w - delta * A) * cos(w * t) - (A * w + delta * B) * sin(w * t));
        last = (k * h + d * v) / (k * v + d * (-(k * h + d * v) / m - gravity));
        t -= last;
    }
    begin(&s);
    run(&s, v0 / gravity + t / 2, VM_OK);
    run(&s, v0 / gravity + t + 0.05, VM_OK);
    CHECK(s.events[0].count == 1);
    agrees("bounce", "v", s.y[4], v - gravity * 0.05, 4, 1e-8);
    agrees("bounce", "height", s.y[1], 0.1 + h + v * 0.05 - gravity * 0.00125, 1, 1e-8);
    balanced(&s, "bounce", 10, 100);
}

/* A point falls from 1 m over a slope of 45 degrees, whose normal may have any length, and slides down from there. */
static void check_length_of_normal(void)
{
    const vm_real length[4] = {1, VM_MAX, VM_MIN * VM_EPSILON, VM_MIN * VM_EPSILON * 2};
    const double v = sqrt(2 * gravity);
    int i;
    for (i = 0; i < 4; i++) {
        vm_contact slope = {{0, 0, 0}, 0, {0, 0, 0}, {0, 0, 0}, 0, 0};
        stage s;
        slope.normal.x = slope.normal.y = length[i];
        stage_clear(&s, 3);
        stage_body(&s, vm_scene_body_point(2, stage_vec(0, 1, 0), origin));
        stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
        stage_event(&s, vm_then_land(vm_event_contact(0, &slope)));
        stage_event(&s, vm_then_stop(vm_event_contact(0, &slope)));
        begin(&s);
        run(&s, 1, VM_STOPPED);
        agrees("slope", "height", s.y[1], 0, 1, 1e-9);
        agrees("slope", "v", s.y[3], v / 2, 4, 1e-9);
        agrees("slope", "v", s.y[4], -v / 2, 4, 1e-9);
    }
}

/* A free body that lands on a point beside its mass centre moves like the body in the plane of check_landing. */
static void check_landing_in_space(void)
{
    const vm_contact end = {{-1, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 0, 0};
    const double v = sqrt(2 * gravity);
    vm_body body = part_of(3, 1), now;
    stage s;
    body.q.w = 1;
    body.r = stage_vec(0, 1, 0);
    body.v = stage_vec(1, 0, 0);
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_free(&body));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_event(&s, vm_then_land(vm_event_contact(0, &end)));
    stage_event(&s, vm_then_stop(vm_event_contact(0, &end)));
    begin(&s);
    run(&s, 3, VM_STOPPED);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("landing in space", "omega", now.omega.z, -v * 3 / 4, 3, 1e-9);
    agrees("landing in space", "v", now.v.y, -v * 3 / 4, 3, 1e-9);
    agrees("landing in space", "v", now.v.x, 1, 1, 1e-12);
    balanced(&s, "landing in space", 10, 30);
}

/* A bar falls flat on one end, which stops: omega = v a m/(I + m a^2). A ball that lands rests on the ground. */
static void check_landing(void)
{
    const vm_contact end = {{-1, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 0, 0};
    const vm_contact ground = {{0, 0, 0}, REAL(0.1), {0, 0, 0}, {0, 1, 0}, 20000, 200};
    const double v = sqrt(2 * gravity);
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_plane(3, 1, stage_vec(0, 1, 0), 0, stage_vec(1, 0, 0), 0));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_event(&s, vm_then_land(vm_event_contact(0, &end)));
    stage_event(&s, vm_then_stop(vm_event_contact(0, &end)));
    begin(&s);
    run(&s, 3, VM_STOPPED);
    agrees("landing", "omega", s.y[5], -v * 3 / 4, 3, 1e-9);
    agrees("landing", "v", s.y[4], -v * 3 / 4, 3, 1e-9);
    agrees("landing", "v", s.y[3], 1, 1, 1e-12);
    balanced(&s, "landing", 10, 30);
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_point(2, stage_vec(0, 1.1, 0), origin));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_contact(0, &ground));
    stage_event(&s, vm_then_land(vm_event_contact(0, &ground)));
    begin(&s);
    run(&s, 3, VM_OK);
    CHECK(s.events[0].count == 1);
    agrees("landing", "rest", s.y[1], 0.1 - 2 * gravity / 20000, 1, 1e-9);
    balanced(&s, "landing", 10, 30);
}

/* The impulse of a landing overflows: of a body so light that an impulse of 1 N s gives it an infinite velocity, and of one
   so heavy that the impulse is infinite. The run ends with an error, and the velocity is that before the landing. */
static void check_landing_overflows(void)
{
    const vm_contact ground = {{1, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 0, 0};
    const vm_real mass[2] = {4 * VM_MIN * VM_EPSILON, VM_MAX / 8};
    int i, in_space;
    for (i = 0; i < 2; i++) {
        for (in_space = 0; in_space < 2; in_space++) {
            vm_body body = part_of((double)mass[i], (double)mass[i]);
            stage s;
            body.inertia.xx = body.inertia.yy = mass[i];
            body.q.w = 1;
            body.r = stage_vec(0, 1, 0);
            body.v = stage_vec(0, -32, 0);
            stage_clear(&s, 0);
            if (in_space) stage_body(&s, vm_scene_body_free(&body));
            else stage_body(&s, vm_scene_body_plane(mass[i], mass[i], body.r, 0, body.v, 0));
            stage_event(&s, vm_then_land(vm_event_contact(0, &ground)));
            begin(&s);
            run(&s, 1, VM_NOT_FINITE);
            CHECK(s.events[0].count == 1 && vmi_all_finite(vm_scene_size(&s.scene), s.y));
            CHECK(s.y[in_space ? 8 : 4] == -32);
        }
    }
}

/* ---- What is refused ---- */

/* A bar on a pin whose joints, spring and contact the checks change */
static void refusal_stage(stage *s, vm_joint *list)
{
    vm_body rod = part_of(1, 0);
    rod.inertia.yy = rod.inertia.zz = 1;
    stage_clear(s, 1);
    stage_body(s, vm_scene_body_plane(1, 1, origin, 0, origin, 0));
    stage_body(s, vm_scene_body_plane(1, 1, stage_vec(2, 0, 0), 0, origin, 0));
    stage_body(s, vm_scene_body_point(1, origin, origin));
    stage_body(s, vm_scene_body_free(&rod));
    list[0] = vm_joint_pin(0, stage_vec(1, 0, 0), 1, stage_vec(-1, 0, 0));
    list[1] = vm_joint_rod(0, origin, VM_GROUND, stage_vec(0, 1, 0), 1);
}

static void accepted(stage *s)
{
    CHECK(vm_scene_check(&s->scene, NULL) == VM_OK && stage_start(s) == VM_OK);
}

static void refuses_joint(vm_joint joint, int status)
{
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    stage s;
    refusal_stage(&s, list);
    stage_effect(&s, vm_effect_joints(&joints));
    accepted(&s);
    list[1] = joint;
    refused(&s, status, "effect", 0);
}

static void check_refused_joints(void)
{
    const vm_vec3 nowhere = {VM_NAN, 0, 0}, one = {1, 0, 0}, up = {0, 1, 0};
    vm_joint odd = vm_joint_pin(0, one, 1, one);
    refuses_joint(vm_joint_pin(0, one, 4, one), VM_NO_SUCH_BODY);
    refuses_joint(vm_joint_pin(0, one, -2, one), VM_NO_SUCH_BODY);
    refuses_joint(vm_joint_pin(VM_GROUND, one, 0, one), VM_NO_SUCH_BODY);
    refuses_joint(vm_joint_pin(0, one, 0, one), VM_SAME_BODY);
    refuses_joint(vm_joint_pin(0, nowhere, 1, one), VM_NOT_FINITE);
    refuses_joint(vm_joint_rod(0, one, 1, one, VM_NAN), VM_NOT_FINITE);
    refuses_joint(vm_joint_rod(0, one, 1, one, 0), VM_DOMAIN);
    refuses_joint(vm_joint_rod(0, one, 1, one, 3), VM_NOT_JOINED);
    refuses_joint(vm_joint_pin(0, one, VM_GROUND, up), VM_NOT_JOINED);
    refuses_joint(vm_joint_pin(2, one, VM_GROUND, one), VM_BAD_POINT);
    refuses_joint(vm_joint_pin(3, up, VM_GROUND, up), VM_BAD_POINT);
    odd.equations = NULL;
    refuses_joint(odd, VM_BAD_ARGUMENT);
}

/* The points fit at the start, but move apart. */
static void check_refused_velocity(void)
{
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    stage s;
    refusal_stage(&s, list);
    stage_effect(&s, vm_effect_joints(&joints));
    s.bodies[1].start.v.y = 1;
    refused(&s, VM_NOT_JOINED, "effect", 0);
    s.bodies[1].start.omega.z = 1; /* turns so that the pin rests */
    accepted(&s);
}

static void check_refused_lists(void)
{
    const vm_point_spring spring = {{0, 0, 0}, {0, 0, 0}, 1, 1, 1};
    vm_joint list[2], more[1];
    vm_joints joints = joints_of(list, 2, 10);
    const vm_joints others = joints_of(more, 1, 10);
    stage s;
    refusal_stage(&s, list);
    more[0] = vm_joint_rod(2, origin, 1, origin, 2);
    stage_effect(&s, vm_effect_joints(&joints));
    joints.rate = 0;
    refused(&s, VM_DOMAIN, "effect", 0);
    joints.rate = VM_INFINITY;
    refused(&s, VM_NOT_FINITE, "effect", 0);
    joints.rate = 1;
    joints.work_size = VM_JOINTS_WORK(2) - 1;
    refused(&s, VM_SHORT_ARRAY, "effect", 0);
    joints.work_size = 0;
    joints.work = NULL;
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    joints.work = room;
    s.effects[0] = vm_effect_joints(NULL);
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    joints.n_joints = 0;
    s.effects[0] = vm_effect_joints(&joints);
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    joints.n_joints = 2;
    s.effects[0] = vm_effect_joints(&joints);
    stage_effect(&s, vm_effect_joints(&others)); /* body 1 is in both lists */
    refused(&s, VM_TWO_LINKS, "effect", 1);
    s.effects[1] = vm_effect_link(1, 2, NULL, NULL, 2, 0, 1);
    refused(&s, VM_TWO_LINKS, "effect", 1);
    s.effects[1] = vm_effect_point_spring(2, 1, &spring);
    refused(&s, VM_LINK_NOT_LAST, "effect", 1);
    s.effects[1] = vm_effect_mass(1, VM_MASS_OF_T, 1, 0, 0);
    refused(&s, VM_BAD_ORDER, "effect", 1);
}

static void refuses_spring(int body, int other, vm_point_spring spring, int status)
{
    vm_joint list[2];
    stage s;
    refusal_stage(&s, list);
    stage_effect(&s, vm_effect_point_spring(body, other, &spring));
    refused(&s, status, "effect", 0);
}

static void check_refused_springs(void)
{
    const vm_point_spring spring = {{0, 0, 0}, {0, 0, 0}, 1, 1, 1};
    vm_point_spring bad = spring;
    refuses_spring(0, 0, spring, VM_SAME_BODY);
    refuses_spring(0, 7, spring, VM_NO_SUCH_BODY);
    bad.rest = -1;
    refuses_spring(0, 1, bad, VM_DOMAIN);
    bad.rest = VM_NAN;
    refuses_spring(0, 1, bad, VM_NOT_FINITE);
    bad = spring;
    bad.other_at.y = 1;
    refuses_spring(0, 2, bad, VM_BAD_POINT);
    bad = spring;
    bad.other_at.z = 1;
    refuses_spring(0, 2, bad, VM_BAD_POINT);
}

/* A spring between points that coincide has no direction, unless its rest is 0. */
static void check_coinciding_points(void)
{
    vm_point_spring spring = {{0, 0, 0}, {0, 0, 0}, 1, 1, 1};
    vm_joint list[2];
    vm_real dydt[STAGE_STATE];
    stage s;
    refusal_stage(&s, list);
    stage_effect(&s, vm_effect_point_spring(0, 2, &spring));
    begin(&s);
    CHECK(vm_scene_rhs(0, s.y, dydt, &s.scene) == 0 && s.scene.status == VM_SINGULAR);
    spring.rest = 0;
    s.bodies[0].start.v.x = 2;
    begin(&s);
    CHECK(vm_scene_rhs(0, s.y, dydt, &s.scene) == 0 && s.scene.status == VM_OK && dydt[3] == -2);
    spring.rest = 1; /* a damper without a spring */
    spring.stiffness = 0;
    CHECK(vm_scene_rhs(0, s.y, dydt, &s.scene) == 0 && s.scene.status == VM_OK && dydt[3] == -2);
}

/* Joints that are redundant or contradict each other end a run at once. */
static void ends_at_once(const vm_joint *list, int n)
{
    vm_joint own[4];
    const vm_joints joints = joints_of(own, n, 10);
    stage s;
    refusal_stage(&s, own);
    memcpy(own, list, (size_t)n * sizeof *own);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 1, VM_SINGULAR);
    CHECK(s.t == 0);
}

static void check_redundant(void)
{
    vm_joint list[4];
    /* two pins hold a body: four equations for three velocities */
    list[0] = vm_joint_pin(0, origin, VM_GROUND, origin);
    list[1] = vm_joint_pin(0, stage_vec(1, 0, 0), VM_GROUND, stage_vec(1, 0, 0));
    ends_at_once(list, 2);
    list[1] = list[0]; /* twice the same */
    ends_at_once(list, 2);
    list[1] = vm_joint_rod(0, stage_vec(0, 1, 0), VM_GROUND, stage_vec(0, 3, 0), 2); /* dead point: no lever */
    ends_at_once(list, 2);
}

static void check_refused_contact(void)
{
    vm_contact ground = {{0, 0, 0}, 0, {0, -1, 0}, {0, 1, 0}, 1, 1};
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    stage s;
    refusal_stage(&s, list);
    stage_effect(&s, vm_effect_contact(0, &ground));
    accepted(&s);
    ground.stiffness = -1;
    refused(&s, VM_BAD_STIFFNESS, "effect", 0);
    ground.stiffness = 1;
    ground.damping = -1;
    refused(&s, VM_DOMAIN, "effect", 0);
    ground.damping = VM_NAN;
    refused(&s, VM_NOT_FINITE, "effect", 0);
    ground.damping = 0;
    ground.normal = origin;
    refused(&s, VM_DOMAIN, "effect", 0);
    ground.normal.y = 1;
    stage_event(&s, vm_then_land(vm_event_at(1)));
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_event_contact(5, &ground);
    refused(&s, VM_NO_SUCH_BODY, "event", 0);
    s.events[0] = vm_event_contact(VM_GROUND, &ground); /* the ground does not come down to the ground */
    refused(&s, VM_NO_SUCH_BODY, "event", 0);
    s.events[0] = vm_then_land(s.events[0]);
    refused(&s, VM_NO_SUCH_BODY, "event", 0);
    s.events[0] = vm_then_land(vm_event_contact(0, &ground));
    accepted(&s);
    stage_effect(&s, vm_effect_joints(&joints));
    refused(&s, VM_TWO_LINKS, "event", 0);
}

static void check_point_at(void)
{
    const vm_vec3 at = {1, 0, 0};
    vm_joint list[2];
    vm_vec3 r, v;
    stage s;
    refusal_stage(&s, list);
    vm_scene_point_at(&s.scene, 0, at, s.y, &r, &v);
    CHECK(r.x != r.x); /* before a start */
    s.bodies[0].start.omega.z = 2;
    s.bodies[0].angle = REAL(0.5);
    begin(&s);
    vm_scene_point_at(&s.scene, 0, at, s.y, &r, &v);
    agrees("point", "r", r.y, sin(0.5), 1, 1e-15);
    agrees("point", "v", v.x, -2 * sin(0.5), 1, 1e-15);
    vm_scene_point_at(&s.scene, 4, at, s.y, &r, &v);
    CHECK(r.x != r.x && v.z != v.z);
    vm_scene_point_at(&s.scene, VM_GROUND, at, s.y, &r, &v);
    CHECK(r.x != r.x);
}

/* Two points that a pin holds together in space, and a third one that a body in the plane carries: the mass centre of the
   pair falls, and the body takes the point along. */
static void check_pins_of_points(void)
{
    const vm_vec3 apart = stage_vec(0.5, 0, 0);
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    int i;
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_point(1, origin, stage_vec(1, 2, 3)));
    stage_body(&s, vm_scene_body_point(3, origin, stage_vec(1, 2, 3)));
    stage_body(&s, vm_scene_body_plane(2, 1, origin, 0, stage_vec(1, 0, 0), 1));
    stage_body(&s, vm_scene_body_point(1, apart, stage_vec(1, 0.5, 0)));
    stage_effect(&s, vm_effect_gravity(0, 2, REAL(-gravity)));
    list[0] = vm_joint_pin(0, origin, 1, origin);
    list[1] = vm_joint_pin(2, apart, 3, origin);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 1, VM_OK);
    for (i = 0; i < 6; i++) agrees("pin of points", "together", s.y[6 + i], (double)s.y[i], 5, 1e-9);
    agrees("pin of points", "fall", s.y[2], 3 - gravity / 4 / 2, 5, 1e-9);
    agrees("pin of points", "carried", s.y[18], (double)s.y[12] + 0.5 * cos((double)s.y[14]), 5, 1e-9);
    agrees("pin of points", "momentum", 2 * s.y[15] + s.y[21], 3, 5, 1e-9);
    CHECK(VM_FABS(s.y[20]) < REAL(1e-6)); /* in the plane */
}

/* A joint does not act while one of its bodies is absent; the body of the first joint must be there. */
static void check_absent_bodies(void)
{
    vm_joint list[2];
    const vm_joints joints = joints_of(list, 2, 10);
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_plane(1, 1, stage_vec(0, -1, 0), 0, origin, 0));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_plane(1, 1, origin, 0, origin, 0)));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    list[0] = vm_joint_pin(0, stage_vec(1, 0, 0), 1, origin);
    list[1] = vm_joint_pin(1, stage_vec(5, 0, 0), 0, origin);
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 1, VM_OK);
    agrees("absent body", "free fall", s.y[1], -1 - gravity / 2, 1, 1e-12);
    CHECK(list[0].force.x == 0 && list[0].force.y == 0);
    list[0] = vm_joint_pin(1, origin, 0, origin);
    s.effects[1] = vm_effect_joints(&joints);
    refused(&s, VM_IS_AWAY, "effect", 1);
}

/* A list of joints without an array, on no body or on the ground alone */
static void check_missing_lists(void)
{
    vm_joint list[2];
    vm_joints joints = joints_of(NULL, 1, 10);
    stage s;
    refusal_stage(&s, list);
    stage_effect(&s, vm_effect_joints(&joints));
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    list[0] = vm_joint_pin(VM_GROUND, origin, 0, origin);
    joints = joints_of(list, 1, 10);
    s.effects[0] = vm_effect_joints(&joints);
    refused(&s, VM_NO_SUCH_BODY, "effect", 0);
}

/* A spring from the point ctx of body 0 to the origin, written by a user */
static void own_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_vec3 *at = (const vm_vec3 *)e->ctx;
    vm_vec3 r, v;
    (void)t;
    vm_scene_point_at(scene, e->body, *at, y, &r, &v);
    vm_scene_push_at(scene, e->body, *at, y, vm_scale(-40, r));
}

/* Bodies of all motions move under a spring that a user writes as under vm_effect_point_spring. */
static void check_push_at(void)
{
    vm_point_spring spring = {{REAL(0.3), REAL(-0.2), 0}, {0, 0, 0}, 40, 0, 0};
    const vm_body free_body = probe();
    vm_real wanted[STAGE_STATE];
    stage s;
    int own, motion, k;
    for (motion = 0; motion < 8; motion++) {
        own = motion & 1;
        stage_clear(&s, 3);
        if (motion / 2 == 0) stage_body(&s, vm_scene_body_line(2, 1, 1));
        if (motion / 2 == 1) stage_body(&s, vm_scene_body_axle(2, REAL(0.5), 1));
        if (motion / 2 == 2) stage_body(&s, vm_scene_body_plane(2, 1, stage_vec(1, 2, 0), 1, stage_vec(1, 0, 0), 2));
        if (motion / 2 == 3) stage_body(&s, vm_scene_body_free(&free_body));
        if (own) stage_effect(&s, vm_effect_custom(0, VM_GROUND, own_spring, &spring.at));
        else stage_effect(&s, vm_effect_point_spring(0, VM_GROUND, &spring));
        begin(&s);
        run(&s, 3, VM_OK);
        for (k = 0; k < vm_scene_size(&s.scene) - VM_BUDGET_STATES; k++) {
            if (own) agrees("pushed", "state", s.y[k], (double)wanted[k], 1 + fabs((double)wanted[k]), 1e-9);
            else wanted[k] = s.y[k];
        }
        balanced(&s, "pushed", 10, 100);
    }
    s.scene.status = VM_OK;
    vm_scene_push_at(&s.scene, VM_GROUND, origin, s.y, origin);
    CHECK(s.scene.status == VM_OK);
    vm_scene_push_at(&s.scene, 1, origin, s.y, origin);
    CHECK(s.scene.status == VM_NO_SUCH_BODY);
    vm_scene_push_at(&s.scene, 0, origin, NULL, origin);
    CHECK(s.scene.status == VM_BAD_ARGUMENT);
    vm_scene_push_at(NULL, 0, origin, s.y, origin);
}

/* ---- Points after jumps ---- */

/* The place in the state of the stage of the point `at` of body 0 */
static vm_vec3 place(const stage *s, vm_vec3 at)
{
    vm_vec3 r, v;
    vm_scene_point_at(&s->scene, 0, at, s->y, &r, &v);
    return r;
}

/* Pushes body 0 with 1 N along x where its mass centre was at the start. */
static void push_first_centre(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    (void)t;
    vm_scene_push_at(scene, e->body, origin, y, stage_vec(1, 0, 0));
}

/* A body takes up another one 1 m away, or loses a point on its other side: its first mass centre stays in its place,
   and a force there has a moment of 0.5 N m about the new one. No spring, joint or contact acts on the body. */
static void check_points_after_jumps(void)
{
    const vm_vec3 beside = stage_vec(0, 1, 0);
    vm_body sphere = part_of(1, 1), part = part_of(1, 0);
    vm_real rates[STAGE_STATE];
    int kind, loses;
    sphere.q.w = REAL(0.6);
    sphere.q.x = REAL(0.8);
    part.r.y = REAL(-0.5);
    for (kind = 0; kind < 6; kind++) {
        stage s;
        loses = kind > 3;
        if (loses) sphere.mass = sphere.inertia.xx = sphere.inertia.yy = sphere.inertia.zz = 2;
        stage_clear(&s, 1);
        if (kind == 0) stage_body(&s, vm_scene_body_line(1, 0, 0));
        if (kind == 1) stage_body(&s, vm_scene_body_point(1, origin, origin));
        if (kind == 2 || kind == 4)
            stage_body(&s, vm_scene_body_plane(sphere.mass, sphere.inertia.zz, origin, REAL(0.5), origin, 0));
        if (kind == 3 || kind == 5) stage_body(&s, vm_scene_body_free(&sphere));
        if (kind == 0) stage_body(&s, vm_scene_body_line(1, 1, 0));
        else stage_body(&s, vm_scene_body_point(1, beside, origin));
        s.bodies[1].absent = loses;
        stage_effect(&s, vm_effect_custom(0, VM_GROUND, push_first_centre, NULL));
        if (loses) stage_event(&s, vm_then_separate(vm_event_at(0), 0, 1, &part, 0));
        else stage_event(&s, vm_then_attach(vm_event_at(0), 0, 1));
        begin(&s);
        run(&s, 0, VM_OK);
        agrees("point after jump", "first centre", size_of(place(&s, origin)), 0, 1, 1e-15);
        CHECK(vm_scene_rhs(0, s.y, rates, &s.scene) == 0);
        if (kind < 2) continue;
        rates[0] = kind % 2 ? size_of(vmi_get3(rates + 10)) : rates[5]; /* inertia 1 + 2/4 or 2 - 2/4 kg m^2 */
        agrees("point after jump", "turn", rates[0], 0.5 / 1.5, 1, 1e-15);
    }
}

/* Half of an axle separates, given at 0.3 m along x, which has no meaning there: the points of the axle stay. */
static void check_points_of_axle(void)
{
    const vm_vec3 at = stage_vec(1, 0, 0);
    const vm_point_spring slack = {{1, 0, 0}, {0, 0, 0}, 0, 0, 0};
    vm_body part = part_of(1, 0);
    vm_vec3 before;
    stage s;
    part.r.x = REAL(0.3);
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_axle(2, REAL(0.5), 1));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_axle(1, 0, 0)));
    stage_effect(&s, vm_effect_point_spring(0, VM_GROUND, &slack));
    stage_event(&s, vm_then_separate(vm_event_at(0), 0, 1, &part, 1));
    begin(&s);
    before = place(&s, at);
    run(&s, 0, VM_OK);
    CHECK(!s.bodies[1].away && size_of(vm_sub(place(&s, at), before)) == 0);
}

/* ---- Joints that nearly contradict each other ---- */

/* Starts a scene of points that hang on two rods, and computes the pulls of the rods. */
static void hang(stage *s, vm_joint *list)
{
    static vm_real dydt[STAGE_STATE];
    const vm_joints joints = joints_of(list, 2, 1);
    int i;
    for (i = 0; i < s->scene.n_bodies; i++) stage_effect(s, vm_effect_gravity(i, 1, -10));
    stage_effect(s, vm_effect_joints(&joints));
    begin(s);
    vm_scene_rhs(0, s->y, dydt, &s->scene);
    CHECK(s->scene.status == VM_OK);
}

static void check_pull(const char *what, vm_real pull, double wanted, double bound, double x)
{
    check_error("pull of a rod", what, "eps", ERROR_EPS(pull, wanted, 0, wanted), bound, x, wanted);
}

/* Two rods of about 1 m hold a point of 1 kg `h` below the line between their upper ends. */
static void check_flat_rods(const char *what, double h, double bound)
{
    const vm_vec3 ends[2] = {{1, 0, 0}, {-1, 0, 0}}, place = stage_vec(0, -h, 0);
    vm_joint list[2];
    stage s;
    int i;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_point(1, place, origin));
    for (i = 0; i < 2; i++)
        list[i] = vm_joint_rod(0, origin, VM_GROUND, ends[i], vm_norm(vm_sub(place, ends[i])));
    hang(&s, list);
    for (i = 0; i < 2; i++) check_pull(what, list[i].force.y, 5, bound, h);
}

/* A rod holds a point of 1 kg, and a second rod a heavy one below it. */
static void check_light_between(const char *what, double heavy, double bound)
{
    const vm_real mass = REAL(heavy);
    vm_joint list[2];
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_point(1, stage_vec(0, -1, 0), origin));
    stage_body(&s, vm_scene_body_point(mass, stage_vec(0, -2, 0), origin));
    list[0] = vm_joint_rod(0, origin, VM_GROUND, origin, 1);
    list[1] = vm_joint_rod(1, origin, 0, origin, 1);
    hang(&s, list);
    check_pull(what, list[0].force.y, 10 * ((double)mass + 1), bound, heavy);
    check_pull(what, list[1].force.y, 10 * (double)mass, bound, heavy);
}

/* The matrix of the equations has lost all digits at h = sqrt(eps) and where the heavy body has a mass of 1/eps kg. The
   pulls keep theirs, but for the last two decades. */
static void check_nearly_dependent(void)
{
    const double eps = (double)VM_EPSILON;
    double least;
    int k;
    for (least = 0.1; least > 32 * eps; least /= 100)
        for (k = 0; k < 50; k++) {
            const double square = least * (1 + k / 10.0);
            const int is_close = square < 1e5 * eps;
            check_flat_rods(is_close ? "in line" : "nearly in line", sqrt(square), is_close ? 1e5 : 4);
            check_light_between(is_close ? "heaviest below" : "heavy below", 1 / square, is_close ? 1e5 : 4);
        }
    for (k = 0; k < 200 && !is_float; k++) check_flat_rods("1e-7 m beside", 1e-7 * (1 + k / 200.0), 2e5); /* 4e-11 */
}

int main(void)
{
    check_push_at();
    check_points_after_jumps();
    check_points_of_axle();
    check_pins_of_points();
    check_absent_bodies();
    check_missing_lists();
    check_refused_joints();
    check_refused_velocity();
    check_refused_lists();
    check_refused_springs();
    check_coinciding_points();
    check_redundant();
    check_nearly_dependent();
    check_refused_contact();
    check_point_at();
    check_leaking_bar_in_plane();
    check_leaking_bar_in_space();
    check_slider_crank();
    check_four_bar();
    check_top();
    check_rods();
    check_rod_too_long();
    check_rod_beside_centre();
    check_separation(0);
    check_separation(1);
    check_bounce();
    check_length_of_normal();
    check_landing();
    check_landing_in_space();
    check_landing_overflows();
    check_spring_in_space(0);
    check_spring_in_space(3);
    check_spring_in_plane();
    check_double_pendulum();
    check_drift();
    return check_finish("scene joints");
}
