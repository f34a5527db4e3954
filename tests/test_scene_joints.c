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
    before = (double)size_of(vmi_sub(r, q)) - 0.5;
    run(&s, 3, VM_OK);
    vm_scene_point_at(&s.scene, 0, spring.at, s.y, &r, &v);
    vm_scene_point_at(&s.scene, 1, origin, s.y, &q, &w);
    after = (double)size_of(vmi_sub(r, q)) - 0.5;
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
        if ((double)size_of(vmi_sub(a, b)) > most) most = (double)size_of(vmi_sub(a, b));
    }
    energy = (2 * (double)(s.y[3] * s.y[3] + s.y[4] * s.y[4]) + 0.3 * (double)(s.y[5] * s.y[5]) +
              1.5 * (double)(s.y[9] * s.y[9] + s.y[10] * s.y[10]) + 0.1 * (double)(s.y[11] * s.y[11])) / 2 +
             gravity * (2 * (double)s.y[1] + 1.5 * (double)s.y[7]);
    check_error("drift", "distance", "abs", most, is_float ? 2e-5 : 2e-10, 200, most);
    check_error("drift", "energy", "rel", fabs(energy - start) / 30, is_float ? 1e-3 : 1e-8, start, energy);
}

/* ---- Pendulums that lose mass ---- */

/* A bar that turns about the origin, J = 1.2 kg m^2 and M c = 2 kg m about it. At 0.9 m mass of 2 kg is lost at 0.5 kg/s,
   with the velocity of the bar there and u = 4 m/s along the bar's motion, so that Q = m' s^2 q' + m' s u. */
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

static void check_leaking_bar_in_plane(void)
{
    vm_stream leak;
    vm_joint list[1];
    const vm_joints joints = joints_of(list, 1, 10);
    const vm_vec3 r = stage_vec(bar_centre * sin(1.0), -bar_centre * cos(1.0), 0);
    vm_real q, rate;
    stage s;
    memset(&leak, 0, sizeof leak);
    leak.rate = REAL(-0.5);
    leak.motion = VM_RELATIVE;
    leak.at = stage_vec(0, bar_centre - 0.9, 0);
    leak.velocity = stage_vec(4, 0, 0);
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_growing_plane(
                       vm_scene_body_plane(BAR_MASS, REAL(bar_inertia), r, 1, origin, 0)));
    list[0] = vm_joint_pin(0, stage_vec(0, bar_centre, 0), VM_GROUND, origin);
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_stream_mass(0, &leak));
    stage_effect(&s, vm_effect_stream_force(0, &leak));
    stage_effect(&s, vm_effect_stream_moment(0, &leak));
    stage_effect(&s, vm_effect_stream_torque(0, &leak));
    stage_effect(&s, vm_effect_joints(&joints));
    begin(&s);
    run(&s, 2, VM_OK);
    leaking_reference(1, 2, &q, &rate);
    agrees("leaking bar", "angle", s.y[2], (double)q, 1, 1e-9);
    agrees("leaking bar", "omega", s.y[5], (double)rate, 1, 1e-9);
    balanced(&s, "leaking bar", 100, 100);
}

int main(void)
{
    check_leaking_bar_in_plane();
    check_spring_in_space(0);
    check_spring_in_space(3);
    check_spring_in_plane();
    check_double_pendulum();
    check_drift();
    return check_finish("scene joints");
}
