/* Chapter 5 of varmass.h in one dimension: translation, straight motion, rotation about a fixed axle, and the closed
   forms for constant rates (Levi-Civita, Tsiolkovsky, linear flow, jet damping).
   Oracles: the reference cases E4-E6 and random cases in arbitrary precision (tests/data/streams_line.h and
   streams_jet.h), the body in space by vm_flow_rhs, and the equations (172)-(176) written out by hand. */
#include "streams.h"

/* ---- Special cases against the body in space ---- */

/* A body that does not turn, all streams at its mass centre */
static void test_translation(void)
{
    scene k;
    vm_real y[VM_FLOW_STATES], z[VM_TRANSLATION_STATES], dy[VM_FLOW_STATES], dz[VM_TRANSLATION_STATES];
    int i;
    scene_init(&k);
    k.body.q = quaternion(1, 0, 0, 0);
    k.body.omega = vector(0, 0, 0);
    k.flow.update = NULL;
    k.flow.force = vector(1, 2, 3);
    k.flow.centre = vector(0, 0, 0);
    for (i = 0; i < SCENE_STREAMS; i++) k.streams[i].at = vector(0, 0, 0);
    CHECK(!vm_flow_start(&k.flow, &k.body, y));
    for (i = 0; i < 3; i++) {
        z[i] = y[VM_Y_R + i];
        z[3 + i] = y[VM_Y_P + i];
    }
    z[6] = y[VM_Y_MASS];
    CHECK(!vm_flow_rhs(0, y, dy, &k.flow) && !vm_translation_rhs(0, z, dz, &k.flow));
    for (i = 0; i < 3; i++) {
        check_error("(172)", "r'", "eps", fabs((double)(dz[i] - dy[VM_Y_R + i])) / eps, 4, i, 0);
        check_error("(172)", "p'", "eps", fabs((double)(dz[3 + i] - dy[VM_Y_P + i])) / eps, 4, i, 0);
    }
    check_error("(172)", "mass", "eps", fabs((double)(dz[6] - dy[VM_Y_MASS])) / eps, 2, 0, 0);
}

/* Jet damping: mass from around the mass centre leaves at a nozzle behind it, or comes in there. The body is so
   heavy that its mass centre stays. */
static void check_jet_damping(int sign)
{
    const vm_vec3 omega0 = vector(.3, -.2, 4);
    vm_jet jet;
    vm_store store;
    vm_stream s;
    vm_flow flow = {0};
    vm_body b = case_e1();
    vmi_mat3 turn;
    vm_real y[VM_FLOW_STATES];
    vm_vec3 omega = vector(0, 0, 0);
    jet.rate = R(.5 * sign);
    jet.axial = 1;
    jet.transverse = 6;
    jet.nozzle = R(1.5);
    jet.gyration_axial = R(.2);
    jet.gyration_transverse = R(.75);
    jet.gyration_out = R(.125);
    store.at = vector(0, 0, 0);
    store.gyration = tensor(.75, .75, .2, 0, 0, 0);
    memset(&s, 0, sizeof s);
    s.rate = jet.rate;
    s.at = vector(0, 0, -1.5);
    s.velocity = vector(0, 0, -2000);
    s.from = &store;
    s.gyration = tensor(.125, .125, .2, 0, 0, 0);
    flow.n = 1;
    flow.streams = &s;
    b.mass = 1000;
    b.inertia = tensor(6, 6, 1, 0, 0, 0);
    b.omega = omega0;
    CHECK(!vm_flow_start(&flow, &b, y) && solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 3) >= 0);
    CHECK(!vm_flow_body(&flow, VM_FLOW_STATES, y, &b) && !vm_jet_damping(&jet, 3, omega0, &omega));
    turn = vmi_rotation(b.q);
    check_error("jet damping", "vm_flow_rhs", "abs", apart(vmi_times_transposed(&turn, b.omega), omega),
                PICK(1e-11, 2e-4), sign, 0);
    CHECK((size_of(omega) < size_of(omega0)) == (sign < 0));
}

/* ---- The line and the axle ---- */

/* Streams of all four kinds of motion at once: p' = F + sum of M' u */
static void test_line(void)
{
    const double v = 1.5, p_rate = .25 - 1 * (v + 2) - .5 * 3 + 0 * v + .5 * 0;
    vm_stream1 s[SCENE_STREAMS];
    vm_flow1 flow = {0};
    vm_real y[VM_FLOW1_STATES] = {1, 3, 2}, dy[VM_FLOW1_STATES]; /* momentum 3, mass 2 */
    int i;
    for (i = 0; i < SCENE_STREAMS; i++) {
        s[i].rate = R(.5 * i - 1);
        s[i].velocity = R(2 + i);
        s[i].motion = i;
    }
    flow.n = SCENE_STREAMS;
    flow.streams = s;
    flow.force = R(.25);
    CHECK(!vm_flow1_rhs(0, y, dy, &flow));
    check_error("(175),(176)", "4 streams", "eps",
                (fabs((double)dy[1] - p_rate) + fabs((double)dy[2] + 1) + fabs((double)dy[0] - v)) / eps, 4, 0, 0);
}

/* Cases E4-E6: v at time t by vm_flow1_rhs and by vm_linear_flow */
static void test_reference_cases(void)
{
    static const struct {
        const char *name;
        double v0, m0, rate, velocity, t, v;
        int motion;
    } cases[] = {
        {"(173a) E4", 1, 2, -.4, 3, 3, -2, VM_ABSOLUTE},
        {"(171) E4", 1, 2, -.4, 0, 3, 2.5, VM_AT_REST},
        {"(174) E4", 1, 2, -.4, 0, 3, 1, VM_CARRIED},
        {"(45),(167) E5", 2, 3, -.65, 0, 2, 3.529411764705882352941, VM_AT_REST},
        {"(175),(176) E6", 2, 3, -.65, -2.5, 2, 3.419960094014848237909, VM_RELATIVE},
    };
    const double bound = PICK(1e-12, 1e-5);
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        vm_stream1 s;
        vm_flow1 flow = {0};
        vm_real y[VM_FLOW1_STATES], x = 0, v = 0;
        s.rate = R(cases[i].rate);
        s.velocity = R(cases[i].velocity);
        s.motion = cases[i].motion;
        flow.n = 1;
        flow.streams = &s;
        y[0] = 0;
        y[1] = R(cases[i].m0 * cases[i].v0);
        y[2] = R(cases[i].m0);
        CHECK(solve(vm_flow1_rhs, &flow, VM_FLOW1_STATES, y, 0, cases[i].t) >= 0);
        CHECK(!vm_linear_flow(&s, R(cases[i].t), 0, R(cases[i].v0), R(cases[i].m0), 0, &x, &v));
        check_error(cases[i].name, "v, vm_flow1_rhs", "abs", fabs((double)(y[1] / y[2]) - cases[i].v), bound, 0, 0);
        check_error(cases[i].name, "v, closed form", "eps", fabs((double)v - cases[i].v) / eps, 20, 0, 0);
        check_error(cases[i].name, "x by both", "abs", fabs((double)(x - y[0])), bound, 0, 0);
    }
}

/* ---- Closed forms ---- */

static void check_closed(const char *equation, vm_real got, double expected, double bound)
{
    check_error(equation, "closed form", "eps", fabs((double)got - expected) / eps, bound, 0, 0);
}

static void test_velocities(void)
{
    check_closed("E4 (171)", vm_velocity_by_momentum(1, 2, R(.8), 0, 0), 2.5, 4);
    check_closed("E4 (173a)", vm_velocity_by_momentum(1, 2, R(.8), 3, 0), -2, 8);
    check_closed("E4 (174)", vm_tsiolkovsky(1, 2, R(.8), 0), 1, 1);
    check_closed("E5 (45),(167)", vm_velocity_by_momentum(2, 3, R(1.7), 0, 0), 3.529411764705882352941, 8);
    check_closed("E6 (175),(176)", vm_tsiolkovsky(2, 3, R(1.7), R(-2.5)), 3.419960094014848237909, 8);
    /* about an axle with an outer moment M: I r = I0 r0 + M t */
    check_closed("(171) with a moment", vm_velocity_by_momentum(1, 2, 4, 0, 3), 1.25, 1);
    CHECK(isnan(vm_velocity_by_momentum(1, -2, 4, 0, 3)) && isnan(vm_tsiolkovsky(1, 2, 0, 1)));
    CHECK(isnan(vm_velocity_by_momentum(0, 1, 2, R(INFINITY), 0)) && isnan(vm_tsiolkovsky(R(INFINITY), 2, 1, 1)));
}

/* The mass decreases by much, but what leaves has the body's velocity; products with masses overflow. */
static void test_velocities_of_wide_range(void)
{
    const vm_real large = is_float ? R(1e30) : R(1e300);
    check_closed("(151), u = v0", vm_velocity_by_momentum(7, R(1 / 3.), R(1e-6), 7, 0), 7, 2 * 7);
    CHECK(vm_velocity_by_momentum(0, large, 1 / large, 0, 0) == 0);
    CHECK(vm_velocity_by_momentum(3, 1, large, R(1e10), 0) == R(1e10));
}

static void test_linear_flow_table(void)
{
    static const struct {
        double t, x0, v0, m0, rate, force, w;
        int relative;
        double v, x, m, v_tsiolkovsky;
    } rows[] = {
#include "data/streams_line.h"
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double v0 = rows[i].v0, m0 = rows[i].m0, t = rows[i].t, w = rows[i].w, rate = rows[i].rate;
        const double gain = rate * t / m0, least_mass = gain < 0 ? 1 + gain : 1; /* relative to m0 */
        const double push = fabs(rows[i].force) + fabs(rate) * (fabs(w) + fabs(v0));
        const double speed = fabs(v0) + push / m0 / least_mass * t; /* the sum of the terms of v */
        const char *region = rows[i].relative ? "relative" : "absolute";
        vm_stream1 s;
        vm_real x = 0, v = 0;
        s.rate = R(rate);
        s.velocity = R(w);
        s.motion = rows[i].relative ? VM_RELATIVE : VM_ABSOLUTE;
        CHECK(!vm_linear_flow(&s, R(t), R(rows[i].x0), R(v0), R(m0), R(rows[i].force), &x, &v));
        check_error("vm_linear_flow v", region, "eps", ERROR_EPS(v, rows[i].v, 0, speed / least_mass), 8, gain,
                    (double)i);
        check_error("vm_linear_flow x", region, "eps", ERROR_EPS(x, rows[i].x, 0, fabs(rows[i].x0) + t * speed), 8,
                    gain, (double)i);
        v = vm_tsiolkovsky(R(v0), R(m0), R(rows[i].m), R(w));
        check_error("vm_tsiolkovsky", "table", "eps",
                    ERROR_EPS(v, rows[i].v_tsiolkovsky, 0, fabs(v0) + fabs(w * log(rows[i].m / m0))), 4, gain,
                    (double)i);
    }
}

static void test_jet_table(void)
{
    static const struct {
        double t, rate, C, A, axial, transverse, out, nozzle, p, q, r, x, y, phase;
    } rows[] = {
#include "data/streams_jet.h"
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double t = rows[i].t, rate = rows[i].rate, gain = rate * rows[i].transverse * t / rows[i].A;
        const double growth = 1 / (gain < 0 ? 1 + gain : 1), lever = rows[i].nozzle * rows[i].nozzle + 1;
        /* what an eps in each of the inputs changes in omega */
        const double condition = 1 + fabs(rows[i].phase) + growth * fabs(rate * t / rows[i].A) * lever +
                                 growth * fabs(rows[i].r) * t;
        vm_jet jet;
        vm_vec3 omega = vector(0, 0, 0);
        double error;
        jet.rate = R(rate);
        jet.axial = R(rows[i].C);
        jet.transverse = R(rows[i].A);
        jet.gyration_axial = R(rows[i].axial);
        jet.gyration_transverse = R(rows[i].transverse);
        jet.gyration_out = R(rows[i].out);
        jet.nozzle = R(rows[i].nozzle);
        CHECK(!vm_jet_damping(&jet, R(t), vector(rows[i].p, rows[i].q, rows[i].r), &omega));
        error = hypot((double)omega.x - rows[i].x, (double)omega.y - rows[i].y);
        check_error("vm_jet_damping", "table", "eps*", error / eps / (hypot(rows[i].x, rows[i].y) * condition), 8,
                    gain, (double)i);
        CHECK((double)omega.z == rows[i].r);
    }
}

/* ---- Mass that runs out ---- */

static void test_running_out(void)
{
    const double least = PICK(1e-12, 1e-5);
    vm_stream1 s = {-1, 0, VM_CARRIED};
    vm_flow1 flow = {0};
    vm_real y[VM_FLOW1_STATES] = {0, 1, 1}, z[VM_FLOW1_STATES] = {0, 1, 1};
    flow.n = 1;
    flow.streams = &s;
    CHECK(solve(vm_flow1_rhs, &flow, VM_FLOW1_STATES, y, 0, 2) < 0 && flow.status == VM_BAD_MASS && y[2] > 0 && y[2] < R(1e-3));
    s.motion = VM_AT_REST;
    CHECK(solve(vm_flow1_rhs, &flow, VM_FLOW1_STATES, z, 0, 1 - least) >= 0);
    check_error("mass left", "least/m0", "rel", fabs((double)z[2] / least - 1), PICK(1e-3, .1), 0, 0);
}

/* ---- Refusals ---- */

static void test_linear_flow_refusals(void)
{
    vm_stream1 s = {-1, 0, VM_AT_REST};
    vm_real x = 3, v = 4;
    vm_real t;
    for (t = 1; t <= 2; t += R(.5)) CHECK(vm_linear_flow(&s, t, 0, 0, 1, 0, &x, &v) == VM_BAD_MASS && x == 3 && v == 4);
    CHECK(vm_linear_flow(&s, R(INFINITY), 0, 0, 1, 0, &x, &v) == VM_NOT_FINITE && x == 3 && v == 4);
    CHECK(vm_linear_flow(NULL, 1, 0, 0, 1, 0, &x, &v) == VM_BAD_ARGUMENT && x == 3 && v == 4);
    CHECK(vm_linear_flow(&s, 1, 0, 0, R(INFINITY), 0, &x, &v) == VM_NOT_FINITE && x == 3 && v == 4);
    CHECK(vm_linear_flow(&s, 4, 0, 0, 8, VM_MAX, &x, &v) == VM_NOT_FINITE && x == 3 && v == 4);
    CHECK(!vm_linear_flow(&s, R(.5), VM_MAX, -VM_MAX, 1, VM_MAX, &x, &v) && x < VM_MAX);
}

/* omega stays in the type's range, although its growth by 4^n and its decay by 4^-n are beyond it. A/A0 is 4. */
static void check_jet_range(int n, int from, int to)
{
    const double x = ldexp(3, from), y = ldexp(4, from), unit = eps * fabs(3.0 * n);
    vm_jet jet = {1, 1, 1, 0, 1, 0, 0};
    vm_vec3 omega = vector(0, 0, 0);
    jet.gyration_out = R(n + 1);
    CHECK(vm_jet_damping(&jet, 3, vector(x, y, 0), &omega) == VM_OK);
    check_error("vm_jet_damping", "range", "eps*", fabs((double)omega.x / ldexp(3, to) - 1) / unit, 8, n, 0);
    check_error("vm_jet_damping", "range", "eps*", fabs((double)omega.y / ldexp(4, to) - 1) / unit, 8, n, 0);
}

static void test_jet_range(void)
{
    const int n = is_float ? 70 : 520, size = is_float ? 100 : 1000;
    check_jet_range(n, -size, 2 * n - size);
    check_jet_range(-n, size, size - 2 * n);
}

static void test_jet_refusals(void)
{
    const vm_vec3 omega0 = vector(1, 2, 3);
    vm_jet jet = {-1, 1, 1, R(.5), R(.5), R(.5), 1};
    vm_vec3 omega = omega0;
    CHECK(vm_jet_damping(&jet, 3, omega0, &omega) == VM_BAD_INERTIA && (double)omega.x == 1);
    CHECK(vm_jet_damping(&jet, R(NAN), omega0, &omega) == VM_NOT_FINITE && (double)omega.x == 1);
    jet.nozzle = 30; /* omega grows beyond the type's range */
    CHECK(vm_jet_damping(&jet, R(-1.9), omega0, &omega) == VM_NOT_FINITE && (double)omega.x == 1);
    CHECK(vm_jet_damping(&jet, R(-1.9), vector(0, 0, 3), &omega) == VM_OK); /* the spin alone does not grow */
    CHECK(omega.x == 0 && omega.y == 0 && omega.z == 3);
    omega = omega0;
    jet.nozzle = 1;
    jet.transverse = R(INFINITY);
    CHECK(vm_jet_damping(&jet, 1, omega0, &omega) == VM_NOT_FINITE && (double)omega.x == 1);
}

/* A bad mass or an infinite rate takes no step; a motion that does not exist stops the run. */
static void test_bad_states(void)
{
    static const double bad_masses[] = {-1, 0, (double)NAN};
    vm_stream s = case_e1_stream();
    vm_stream1 s1 = {1, 1, VM_RELATIVE};
    vm_flow flow = {0};
    vm_flow1 flow1 = {0};
    vm_real y[VM_TRANSLATION_STATES] = {0, 1, 1, 1, 1, 1, 1};
    int i;
    s.motion = VM_RELATIVE;
    s.rate = 1;
    flow.n = 1;
    flow.streams = &s;
    flow1.n = 1;
    flow1.streams = &s1;
    for (i = 0; i < 3; i++) {
        flow.status = VM_OK;
        flow1.status = VM_OK;
        check_no_step(vm_translation_rhs, &flow, VM_TRANSLATION_STATES, 6, bad_masses[i]);
        check_no_step(vm_flow1_rhs, &flow1, VM_FLOW1_STATES, 2, bad_masses[i]);
        CHECK(flow.status == VM_BAD_MASS || !(bad_masses[i] <= 0));
        CHECK(flow1.status == VM_BAD_MASS || !(bad_masses[i] <= 0));
    }
    s.rate = VM_INFINITY;
    s1.rate = VM_INFINITY;
    check_no_step(vm_translation_rhs, &flow, VM_TRANSLATION_STATES, -1, 0);
    check_no_step(vm_flow1_rhs, &flow1, VM_FLOW1_STATES, -1, 0);
    s.rate = 1;
    s1.rate = 1;
    s.motion = VM_AT_REST + 1;
    s1.motion = VM_AT_REST + 1;
    CHECK(solve(vm_translation_rhs, &flow, VM_TRANSLATION_STATES, y, 0, 1) == ODE_RHS_STOPPED);
    CHECK(solve(vm_flow1_rhs, &flow1, VM_FLOW1_STATES, y, 0, 1) == ODE_RHS_STOPPED);
    CHECK(flow.status == VM_BAD_ARGUMENT && flow1.status == VM_BAD_ARGUMENT);
}

/* A trial step to a mass that is infinite or NaN is rejected, and the status says why. */
static void check_mass_not_finite(vm_real mass)
{
    vm_flow flow = {0};
    vm_flow1 flow1 = {0};
    vm_real y[VM_TRANSLATION_STATES] = {0, 1, 1, 1, 1, 1, 1}, dy[VM_TRANSLATION_STATES] = {0};
    y[6] = mass;
    CHECK(vm_translation_rhs(0, y, dy, &flow) == 0 && dy[0] != dy[0] && flow.status == VM_NOT_FINITE);
    y[2] = mass;
    dy[0] = 0;
    CHECK(vm_flow1_rhs(0, y, dy, &flow1) == 0 && dy[0] != dy[0] && flow1.status == VM_NOT_FINITE);
}

int main(void)
{
    test_translation();
    check_jet_damping(-1);
    check_jet_damping(1);
    test_line();
    test_reference_cases();
    test_velocities();
    test_velocities_of_wide_range();
    test_linear_flow_table();
    test_jet_table();
    test_running_out();
    test_linear_flow_refusals();
    test_jet_range();
    test_jet_refusals();
    test_bad_states();
    check_mass_not_finite(VM_NAN);
    check_mass_not_finite(VM_INFINITY);
    return check_finish("flow1");
}
