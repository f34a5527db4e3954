/* Chapter 6 of varmass.h: Lagrange's equations (247) with mass that varies, vm_lagrange_system, and Euler's angles.
   Oracles: a rod that loses its tip in arbitrary precision (tests/data/streams_pendulum.h), the draining tank by
   vm_flow_rhs, kinetic energies whose derivatives are written out by hand, and vector identities of the axes of Euler's
   angles, which (242) of the dissertation misses. The drum by (247) is in tests/test_drum.c. */
#include "streams.h"

/* ---- A rod that hangs from one end and loses its tip ---- */

enum { ROD_DENSITY = 3 };
static const double gravity = 9.8125;

static double rod_length(double t) { return 2 - t / 4; }

/* The mass and the moment of inertia about the middle */
static void rod_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    const double l = rod_length((double)t);
    (void)q;
    (void)ctx;
    masses[0] = R(ROD_DENSITY * l);
    masses[1] = R(ROD_DENSITY * l * l * l / 12);
}

static vm_real rod_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real half = R(rod_length((double)t) / 2);
    (void)q;
    (void)ctx;
    return (masses[0] * half * half + masses[1]) * rates[0] * rates[0] / 2;
}

/* The weight acts in the middle, and the stream carries momentum away at the tip. */
static int rod_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                      void *ctx)
{
    const double l = rod_length((double)t), s = sin((double)q[0]), c = cos((double)q[0]);
    const double mass_rate = -ROD_DENSITY / 4.;
    const vm_vec3 tip_slope = vector(l * c, l * s, 0), middle_slope = vm_scale(R(.5), tip_slope); /* dr/dphi */
    const vm_vec3 u = vm_scale(rates[0], tip_slope), no_moment = vector(0, 0, 0);
    (void)ctx;
    vm_lagrange_add_force(1, vector(0, -gravity * (double)masses[0], 0), &middle_slope, no_moment, NULL, Q);
    vm_lagrange_add_force(1, vm_scale(R(mass_rate), u), &tip_slope, no_moment, NULL, Q);
    return 0;
}

static void test_rod(void)
{
    static const double table[][3] = { /* t, phi, phi' */
#include "data/streams_pendulum.h"
    };
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 2)], y[2], q, rate;
    vm_lagrange_system l = {1, 2, rod_masses, rod_energy, rod_forces, NULL, NULL, NULL};
    size_t i;
    l.work = work;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const double t = table[i][0];
        q = 1;
        rate = R(.5);
        CHECK(vm_lagrange_start(&l, 0, &q, &rate, y) == VM_OK);
        CHECK(solve(vm_lagrange_rhs, &l, 2, y, 0, t) >= 0);
        CHECK(vm_lagrange_rates(&l, R(t), y, &rate) == VM_OK);
        check_error("(247) phi", "rod pendulum", "abs", fabs((double)y[0] - table[i][1]), PICK(1e-11, 1e-4), t, 0);
        check_error("(247) phi'", "rod pendulum", "abs", fabs((double)rate - table[i][2]), PICK(1e-11, 4e-4), t, 0);
    }
}

/* ---- The draining tank in six coordinates: the place of the mass centre and Euler's angles ---- */

/* r' is v + drift, and T depends on v, so that the drift enters as a function of time and q. */
static void tank_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    tank *k = (tank *)ctx;
    (void)q;
    k->flow.ctx = k;
    tank_law(t, NULL, &k->flow);
    masses[0] = k->flow.mass;
    vmi_set_inertia(masses + 1, &k->flow.inertia);
}

/* v in inertial axes and omega in body axes */
static void tank_motion(vm_real t, const vm_real *q, const vm_real *rates, const tank *k, vm_vec3 *v,
                        vm_vec3 *omega)
{
    const vmi_mat3 turn = vmi_rotation(vm_euler_313(q[3], q[4], q[5]));
    vm_vec3 axis[3];
    vm_euler_313_body_axes(q[4], q[5], axis);
    *omega = vm_add(vm_scale(rates[3], axis[0]),
                     vm_add(vm_scale(rates[4], axis[1]), vm_scale(rates[5], axis[2])));
    *v = vm_sub(vmi_get3(rates), vmi_times(&turn, tank_drift(k, (double)t)));
}

static vm_real tank_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_inertia about_centre = vmi_get_inertia(masses + 1);
    vm_vec3 v, omega;
    tank_motion(t, q, rates, (const tank *)ctx, &v, &omega);
    return (masses[0] * vm_dot(v, v) + vm_dot(omega, vmi_inertia_times(&about_centre, omega))) / 2;
}

/* The stream carries the momentum rate * u and the spin of its own away at the crossing point. */
static int tank_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                       void *ctx)
{
    const tank *k = (const tank *)ctx;
    const vm_stream *s = &k->stream;
    const vmi_mat3 turn = vmi_rotation(vm_euler_313(q[3], q[4], q[5]));
    const vm_inertia own_rate = vmi_stream_own(s->rate, &s->gyration);
    const vm_vec3 d = vm_scale(R(k->empty / tank_mass(k, (double)t)), s->at); /* from the mass centre */
    vm_vec3 v, omega, u, moment, dr[6], domega[6], axis[3];
    int i;
    (void)masses;
    tank_motion(t, q, rates, k, &v, &omega);
    u = vm_add(v, vmi_times(&turn, vm_add(s->velocity, vm_cross(omega, d))));
    moment = vmi_times(&turn, vmi_inertia_times(&own_rate, vm_add(omega, s->spin)));
    vm_euler_313_axes(q[3], q[4], axis);
    for (i = 0; i < 3; i++) {
        dr[i] = vector(i == 0, i == 1, i == 2);
        domega[i] = vector(0, 0, 0);
        dr[3 + i] = vm_cross(axis[i], vmi_times(&turn, d));
        domega[3 + i] = axis[i];
    }
    vm_lagrange_add_force(6, vm_scale(s->rate, u), dr, moment, domega, Q);
    return 0;
}

static void test_tank(void)
{
    tank k;
    vm_real work[VM_LAGRANGE_RHS_WORK(6, 7)], y[12], q[6] = {0, 0, 0, R(.4), R(1.1), R(-.3)}, rates[6], z[VM_FLOW_STATES];
    vm_lagrange_system equations = {6, 7, tank_masses, tank_energy, tank_forces, NULL, NULL, NULL};
    vm_body b;
    vmi_mat3 turn, expected;
    vm_vec3 axis[3], omega = vector(0, 0, 0);
    int i;
    tank_init(&k);
    equations.ctx = &k;
    equations.work = work;
    k.body.q = vm_euler_313(q[3], q[4], q[5]);
    CHECK(!vm_flow_start(&k.flow, &k.body, z) && solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, z, 0, 1) >= 0);
    CHECK(!vm_flow_body(&k.flow, VM_FLOW_STATES, z, &b));
    turn = vmi_rotation(k.body.q);
    vmi_set3(rates, vm_add(k.body.v, vmi_times(&turn, tank_drift(&k, 0))));
    CHECK(!vm_euler_313_rates(q[3], q[4], k.body.omega, rates + 3));
    CHECK(!vm_lagrange_start(&equations, 0, q, rates, y));
    CHECK(solve(vm_lagrange_rhs, &equations, 12, y, 0, 1) >= 0);
    turn = vmi_rotation(vm_euler_313(y[3], y[4], y[5]));
    expected = vmi_rotation(b.q);
    check_error("(247) = vm_flow_rhs", "place", "abs", apart(vmi_get3(y), b.r), PICK(1e-11, 1e-3), 0, 0);
    check_error("(247) = vm_flow_rhs", "attitude", "abs", apart(turn.x, expected.x) + apart(turn.y, expected.y),
                PICK(1e-11, 1e-3), 0, 0);
    CHECK(!vm_lagrange_rates(&equations, 1, y, rates));
    vm_euler_313_axes(y[3], y[4], axis);
    for (i = 0; i < 3; i++) omega = vm_add(omega, vm_scale(rates[3 + i], axis[i]));
    check_error("(247) = vm_flow_rhs", "omega", "abs", apart(omega, b.omega), PICK(1e-11, 1e-3), 0, 0);
}

/* ---- Euler's angles ---- */

/* The axes of the three angles, and rates that make omega */
static void check_euler_axes(int i, const double *q, vm_vec3 omega, const vm_vec3 *axis, const vm_real *rates)
{
    const vm_vec3 node = vector(cos(q[0]), sin(q[0]), 0);
    const vmi_mat3 turn = vmi_rotation(vm_euler_313(R(q[0]), R(q[1]), R(q[2])));
    vm_vec3 body_axis[3], sum = vector(0, 0, 0), x;
    int k;
    vm_euler_313_body_axes(R(q[1]), R(q[2]), body_axis);
    for (k = 0; k < 3; k++) {
        sum = vm_add(sum, vm_scale(rates[k], axis[k]));
        check_error("Euler 3-1-3", "body axes", "eps", apart(vmi_times(&turn, body_axis[k]), axis[k]) / eps, 8, i,
                    k);
    }
    check_error("Euler 3-1-3", "rates", "eps*", apart(sum, omega) * sin(q[1]) / eps / size_of(omega), 8, i, 0);
    check_error("Euler 3-1-3", "z of the body", "eps", apart(turn.z, axis[2]) / eps, 8, i, 0);
    x = vm_add(vm_scale(R(cos(q[2])), node), vm_scale(R(sin(q[2])), vm_cross(axis[2], node)));
    check_error("Euler 3-1-3", "x of the body", "eps", apart(turn.x, x) / eps, 8, i, 0);
}

/* d/dt w_k - domega/dq_k is omega x w_k, where (242) has 0. The axes are w = z, (c, s, 0), (S s, -S c, C) with
   s, c of psi and S, C of theta; their derivatives are written out here. Returns the largest difference. */
static double check_axis_rates(int i, const double *q, vm_vec3 omega, const vm_vec3 *axis, const vm_real *rates)
{
    const double psi = (double)rates[0], theta = (double)rates[1], phi = (double)rates[2];
    const double s = sin(q[0]), c = cos(q[0]), S = sin(q[1]), C = cos(q[1]);
    const vm_vec3 axis_rate[3] = {
        vector(0, 0, 0), vector(-s * psi, c * psi, 0),
        vector(C * s * theta + S * c * psi, -C * c * theta + S * s * psi, -S * theta)};
    const vm_vec3 omega_slope[3] = {vector(-s * theta + S * c * phi, c * theta + S * s * phi, 0),
                                    vector(C * s * phi, -C * c * phi, -S * phi), vector(0, 0, 0)};
    const double scale = (fabs(psi) + fabs(theta) + fabs(phi)) * eps;
    double largest = 0;
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 difference = vm_sub(axis_rate[k], omega_slope[k]);
        check_error("(242) + omega x w", "3-1-3", "eps*", apart(difference, vm_cross(omega, axis[k])) / scale, 8,
                    i, k);
        largest = fmax(largest, size_of(difference));
    }
    return largest;
}

static void test_euler_angles(void)
{
    int i;
    double largest = 0;
    for (i = 0; i < 300; i++) {
        const double psi = uniform(-7, 7), theta = uniform(.1, 3), phi = uniform(-7, 7);
        const double q[3] = {psi, theta, phi};
        const vm_vec3 omega = random_vector(3);
        vm_vec3 axis[3];
        vm_real rates[3] = {0, 0, 0};
        vm_euler_313_axes(R(psi), R(theta), axis);
        CHECK(!vm_euler_313_rates(R(psi), R(theta), omega, rates));
        check_euler_axes(i, q, omega, axis, rates);
        largest = fmax(largest, check_axis_rates(i, q, omega, axis, rates));
    }
    ERRATUM("(237)-(242)", largest > 1.7, check_holds("(242) + omega x w"));
}

static void test_euler_refusals(void)
{
    vm_real rates[3] = {1, 2, 3};
    CHECK(vm_euler_313_rates(1, 0, vector(1, 0, 0), rates) == VM_SINGULAR && rates[0] == 1);
    CHECK(vm_euler_313_rates(1, R(NAN), vector(1, 0, 0), rates) == VM_NOT_FINITE && rates[0] == 1);
    CHECK(vm_euler_313_rates(1, R(.1), vector((double)VM_MAX, 0, 0), rates) == VM_NOT_FINITE && rates[0] == 1);
    CHECK(vm_euler_313_rates(1, 1, vector(1, 0, 0), NULL) == VM_BAD_ARGUMENT);
}

/* ---- Derivatives of the kinetic energy ---- */

/* A mass m(q) on an arm of the length 1 + sin q: T = m (1 + sin q)^2 q'^2/2 */
static void arm_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)t;
    (void)ctx;
    masses[0] = 2 + q[0] * q[0];
}

static vm_real arm_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real arm = 1 + R(sin((double)q[0]));
    (void)t;
    (void)ctx;
    return masses[0] * arm * arm * rates[0] * rates[0] / 2;
}

/* vm_lagrange_partial_q is dT/dq with the mass held, to the accuracy that the header promises. */
static void test_frozen_derivative(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 1)], q, rate = R(1.5);
    vm_lagrange_system l = {1, 1, arm_masses, arm_energy, NULL, NULL, NULL, NULL};
    int i;
    l.work = work;
    for (i = -40; i <= 40; i++) {
        double x, mass, expected;
        q = R(i / 10.);
        x = (double)q;
        mass = 2 + x * x;
        expected = mass * (1 + sin(x)) * cos(x) * 2.25;
        check_error("frozen dT/dq", "arm", "T",
                    fabs((double)vm_lagrange_partial_q(&l, 0, &q, &rate, 0) - expected) / (mass * 4 * 1.125),
                    PICK(2e-13, 1e-5), x, 0);
    }
}

/* A frame that moves at 0.5 and two coordinates of very different size: T = (q1' + 0.5 + 1e-3 q2')^2 + 1e-6 q2'^2 */
static vm_real moving_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real v = rates[0] + R(.5) + R(1e-3) * rates[1];
    (void)t;
    (void)q;
    (void)masses;
    (void)ctx;
    return v * v + R(1e-6) * rates[1] * rates[1];
}

static void test_moving_frame(void)
{
    const double v = 1.5 + .5 + 1e-3 * 300;
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 0)], y[4], q[2] = {1, 2}, rates[2] = {R(1.5), 300}, back[2];
    vm_lagrange_system l = {2, 0, NULL, moving_energy, NULL, NULL, NULL, NULL};
    l.work = work;
    CHECK(!vm_lagrange_start(&l, 0, q, rates, y) && !vm_lagrange_rates(&l, 0, y, back));
    check_error("pi = dT/dq'", "moving frame", "eps", fabs((double)y[2] / (2 * v) - 1) / eps, 8, 0, 0);
    /* The momenta are differences over unit rates. Their rounding errors are those of T at rest, 0.25, times the rate
       of 300. */
    check_error("pi = dT/dq'", "moving frame", "eps*",
                fabs((double)y[3] - (2e-3 * v + 2e-6 * 300)) / eps / (.25 * 300), 4, 0, 0);
    check_error("q' of pi", "moving frame", "eps*",
                (fabs((double)back[0] - 1.5) + 1e-3 * fabs((double)back[1] - 300)) / eps, 8, 0, 0);
}

/* ---- Inverse dynamics ---- */

/* A double pendulum whose masses depend on time and place, and whose second rod changes its length with the angle, as
   in tests/gen/lagrange_inverse.py */
static void double_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)ctx;
    masses[0] = 2 - t / 8;
    masses[1] = 1 + t / 16 + q[0] * q[0] / 8;
}

static vm_real double_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real s0 = VM_LIBM(sin)(q[0]), c0 = VM_LIBM(cos)(q[0]), s1 = VM_LIBM(sin)(q[1]), c1 = VM_LIBM(cos)(q[1]);
    const vm_real length = 1 + s1 / 8, stretch = c1 / 8 * rates[1];
    const vm_real x = c0 * rates[0] + length * c1 * rates[1] + stretch * s1;
    const vm_real y = stretch * c1 - s0 * rates[0] - length * s1 * rates[1];
    (void)t;
    (void)ctx;
    return masses[0] * rates[0] * rates[0] / 2 + masses[1] * (x * x + y * y) / 2;
}

/* Q from q, q', q'' against arbitrary precision. The bound is that of the documentation; the scale of the angles is 1,
   the masses change noticeably in about 8 s. */
static void test_needed_forces(void)
{
    static const double table[][9] = {
#include "data/lagrange_inverse.h"
    };
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 2)], masses[2], Q[2] = {0, 0}, drive[2] = {0, 0};
    vm_lagrange_system l = {2, 2, double_masses, double_energy, NULL, NULL, NULL, NULL};
    size_t i;
    int k;
    l.work = work;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const double *row = table[i];
        const vm_real t = R(row[0]), q[2] = {R(row[1]), R(row[2])}, rates[2] = {R(row[3]), R(row[4])};
        const vm_real accelerations[2] = {R(row[5]), R(row[6])};
        double largest;
        CHECK(!vm_lagrange_needed_forces(&l, t, 8, q, rates, accelerations, Q));
        CHECK(!vm_lagrange_drive_forces(&l, t, 8, q, rates, accelerations, drive));
        double_masses(t, q, masses, NULL);
        largest = (double)double_energy(t, q, rates, masses, NULL) * (1 + fabs(row[3]) + fabs(row[4])) +
                  4 * (fabs(row[5]) + fabs(row[6]));
        for (k = 0; k < 2; k++) {
            check_error("needed forces", "double pendulum", "largest", fabs((double)Q[k] - row[7 + k]) / largest,
                        PICK(2e-13, 1e-5), (double)i, k);
            CHECK(drive[k] == Q[k]); /* there are no other forces */
        }
    }
}

/* The rod that loses its tip swings freely with phi'' = -3 g/(2 l) sin phi: no drive is needed, and all forces together
   are those of rod_forces. At another phi'' the drive gives what is missing, the moment of inertia l^3 times that. */
static void test_drive_forces(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 2)], masses[2], Q, forces;
    vm_lagrange_system l = {1, 2, rod_masses, rod_energy, rod_forces, NULL, NULL, NULL};
    int i;
    l.work = work;
    for (i = 0; i < 40; i++) {
        const vm_real t = R(i) / 16, q = R(i) / 8 - 2, rate = R(3) - R(i) / 8;
        const double length = rod_length((double)t), inertia = length * length * length;
        const double free = -1.5 * gravity / length * sin((double)q);
        const double scale = inertia * (fabs(free) + (double)(rate * rate) + 1);
        const vm_real accelerations[2] = {R(free), R(free + 1)};
        CHECK(!vm_lagrange_drive_forces(&l, t, 1, &q, &rate, accelerations, &Q));
        check_error("drive", "free motion", "", fabs((double)Q) / scale, PICK(2e-13, 1e-5), i, 0);
        CHECK(!vm_lagrange_drive_forces(&l, t, 1, &q, &rate, accelerations + 1, &Q));
        check_error("drive", "1 rad/s^2 more", "", fabs((double)Q - inertia) / scale, PICK(2e-13, 1e-5), i, 0);
        CHECK(!vm_lagrange_needed_forces(&l, t, 1, &q, &rate, accelerations, &Q));
        rod_masses(t, &q, masses, NULL);
        forces = 0;
        rod_forces(t, &q, &rate, masses, &forces, NULL);
        check_error("needed forces", "rod", "", fabs((double)(Q - forces)) / scale, PICK(2e-13, 1e-5), i, 0);
    }
}

/* ---- Refusals ---- */

/* The kinetic energy does not depend on the second coordinate. */
static vm_real flat_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)q;
    (void)masses;
    (void)ctx;
    return rates[0] * rates[0] / 2;
}

static void test_refusals(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 0)], y[4] = {1, 2, 3, 4}, q[2] = {0, 0}, rates[2] = {1, 1}, slope;
    const volatile int beyond = 2; /* the coordinates are 0 and 1 */
    vm_lagrange_system l = {2, 0, NULL, flat_energy, NULL, NULL, NULL, NULL};
    CHECK(vm_lagrange_start(&l, 0, q, rates, y) == VM_BAD_ARGUMENT && y[0] == 1);
    l.work = work;
    CHECK(vm_lagrange_start(&l, 0, q, rates, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_rates(&l, 0, y, rates) < 0 && rates[0] == 1);
    CHECK(solve(vm_lagrange_rhs, &l, 4, y, 0, 1) == ODE_RHS_STOPPED && y[0] == 1);
    q[0] = R(NAN);
    CHECK(vm_lagrange_start(&l, 0, q, rates, y) == VM_NOT_FINITE && y[0] == 1);
    slope = vm_lagrange_partial_q(&l, 0, q, rates, beyond);
    CHECK(slope != slope);
    q[0] = 0;
    CHECK(vm_lagrange_needed_forces(&l, 0, 0, q, rates, rates, y) == VM_SINGULAR && y[0] == 1);
    CHECK(vm_lagrange_drive_forces(&l, 0, -1, q, rates, rates, y) == VM_DOMAIN && y[0] == 1);
    CHECK(vm_lagrange_needed_forces(&l, 0, 0, q, rates, rates, NULL) == VM_BAD_ARGUMENT);
}

static int refusing_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                           void *ctx)
{
    (void)t;
    (void)q;
    (void)rates;
    (void)masses;
    (void)ctx;
    Q[0] = 5;
    return 42;
}

/* The number that the function `forces` returns comes back, and Q is left alone. */
static void test_forces_that_refuse(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 1)], q = 1, rate = 2, Q = 7;
    vm_lagrange_system l = {1, 1, arm_masses, arm_energy, refusing_forces, NULL, NULL, NULL};
    l.work = work;
    CHECK(vm_lagrange_drive_forces(&l, 0, 0, &q, &rate, &rate, &Q) == 42 && Q == 7);
    CHECK(vm_lagrange_needed_forces(&l, 0, 0, &q, &rate, &rate, &Q) == VM_OK && Q != 7);
}

/* A point on an arm leaks: its mass is 0 at t = 2. */
static void leaking_mass(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)q;
    (void)ctx;
    masses[0] = 2 - t;
}

static vm_real leaking_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)q;
    (void)ctx;
    return masses[0] * rates[0] * rates[0] / 2;
}

/* Two coordinates of one motion: the mass matrix is singular but for rounding errors. */
static vm_real one_motion_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses,
                                 void *ctx)
{
    const vm_real v = rates[0] / 3 + rates[1] / 7;
    (void)t;
    (void)q;
    (void)masses;
    (void)ctx;
    return v * v / 2;
}

/* The mass of coordinate 0 is `ctx`, that of coordinate 1 is 1. */
static vm_real two_masses_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)q;
    (void)masses;
    return (*(const vm_real *)ctx * rates[0] * rates[0] + rates[1] * rates[1] + rates[0] * rates[1] / 2) / 2;
}

/* No run goes on where the mass matrix is singular. */
static void test_singular_mass_matrices(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 1)], y[4] = {1, 2, 3, 4}, q = 1, rates[2] = {1, 1}, mass = -1;
    vm_real dydt[4] = {7, 7, 7, 7};
    vm_lagrange_system l = {1, 1, leaking_mass, leaking_energy, NULL, NULL, NULL, NULL};
    double stopped;
    l.work = work;
    CHECK(!vm_lagrange_start(&l, 0, &q, rates, y));
    y[1] = 0; /* at rest, so that q' is 0 before and after t = 2 */
    CHECK(solve_events(vm_lagrange_rhs, &l, 2, y, 0, 3, NULL, 0, &stopped) == ODE_RHS_STOPPED && stopped <= 2);
    CHECK(vm_lagrange_rates(&l, 3, y, rates) == VM_SINGULAR && rates[0] == 1);
    l.n = 2;
    l.n_masses = 0;
    l.masses = NULL;
    l.energy = one_motion_energy;
    CHECK(vm_lagrange_rates(&l, 0, y, rates) == VM_SINGULAR && rates[0] == 1);
    l.energy = two_masses_energy;
    l.ctx = &mass;
    CHECK(vm_lagrange_rates(&l, 0, y, rates) == VM_SINGULAR && rates[0] == 1); /* a negative mass */
    CHECK(vm_lagrange_rhs(0, y, dydt, &l) == VM_SINGULAR && dydt[0] == 7);
    CHECK(vm_lagrange_start(&l, 0, y, rates, dydt) == VM_SINGULAR && dydt[0] == 7);
    mass = 0;
    CHECK(vm_lagrange_rates(&l, 0, y, rates) == VM_SINGULAR && rates[0] == 1);
    mass = -VM_INFINITY;
    CHECK(vm_lagrange_rates(&l, 0, y, rates) == VM_NOT_FINITE && rates[0] == 1);
}

int main(void)
{
    test_rod();
    test_tank();
    test_euler_angles();
    test_euler_refusals();
    test_frozen_derivative();
    test_moving_frame();
    test_needed_forces();
    test_drive_forces();
    test_refusals();
    test_forces_that_refuse();
    test_singular_mass_matrices();
    return check_finish("lagrange");
}
