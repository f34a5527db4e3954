/* Chapters 5 and 6: loads, right-hand sides and closed forms of bodies whose mass varies continuously, by balances,
   by the limit of many small jumps and by reference values; the printed forms that are wrong must fail. */
#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';
#define PICK(in_double, in_float) (is_float ? (in_float) : (in_double))

static vm_vec3 vector(double x, double y, double z) { return vmi_vec3(R(x), R(y), R(z)); }
static vm_vec3 random_vector(double size)
{
    double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return vector(x, y, z);
}
static vm_inertia tensor(double xx, double yy, double zz, double xy, double xz, double yz)
{
    vm_inertia i;
    i.xx = R(xx);
    i.yy = R(yy);
    i.zz = R(zz);
    i.xy = R(xy);
    i.xz = R(xz);
    i.yz = R(yz);
    return i;
}
static vm_quat quaternion(double w, double x, double y, double z)
{
    vm_quat q;
    q.w = R(w);
    q.x = R(x);
    q.y = R(y);
    q.z = R(z);
    return q;
}
static double size_of(vm_vec3 a) { return sqrt((double)vmi_dot(a, a)); }
static double apart(vm_vec3 a, vm_vec3 b) { return size_of(vmi_sub(a, b)); }

/* From t to end as accurately as the type allows; the state in y */
static int solve_events(ode_rhs f, void *ctx, int n, vm_real *y, double t, double end, ode_event *events,
                        int n_events, double *stopped)
{
    static vm_real work[RK87_WORK(40)];
    rk45_options o = rk45_defaults(NULL);
    rk45 s;
    int status, k;
    o.rtol = PICK(256, 16) * VM_EPSILON;
    o.atol = o.rtol / 100;
    o.events = events;
    o.n_events = n_events;
    status = is_float ? rk45_init(&s, f, ctx, n, R(t), y, &o, work) : rk87_init(&s, f, ctx, n, R(t), y, &o, work);
    if (status >= 0) status = is_float ? rk45_solve(&s, R(end)) : rk87_solve(&s, R(end));
    if (status == ODE_BAD_ARGUMENT) return status;
    for (k = 0; k < n; k++) y[k] = s.y[k];
    if (stopped) *stopped = (double)s.t;
    return status;
}
static int solve(ode_rhs f, void *ctx, int n, vm_real *y, double t, double end)
{
    return solve_events(f, ctx, n, y, t, end, NULL, 0, NULL);
}

/* ---- Reference cases E ---- */

/* E1: everything at one instant */
static vm_body case_e1(void)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = 6;
    b.inertia = tensor(2, 1.5, 1.1, .1, -.2, .05);
    b.q.w = 1;
    b.v = vector(.1, .2, -.1);
    b.omega = vector(.3, -.4, .6);
    return b;
}
static vm_stream case_e1_stream(void)
{
    vm_stream s;
    memset(&s, 0, sizeof s);
    s.rate = R(-.5);
    s.motion = VM_ABSOLUTE;
    s.at = vector(.5, -.3, .4);
    s.velocity = vector(1, -.4, .3);
    s.spin = vector(.4, -.9, .2);
    s.gyration = tensor(.3, .5, .2, 0, 0, 0);
    return s;
}

static void test_e1(void)
{
    const vm_body b = case_e1();
    const vm_stream s = case_e1_stream();
    vm_reactive loads;
    vm_vec3 dv, domega, printed,
        expected = vector(-0.03119529795158286778399, -0.05223463687150837988827, 0.259429702048417132216);
    vm_vec3 force = vector(0, 0, -58.86), torque = vector(.1, 0, .2), spin_rate, rates[2];
    vm_flow flow = {0};
    vm_real y[VM_FLOW_STATES], dy[VM_FLOW_STATES];
    const double bound = 20 * eps;
    CHECK(vm_reactive_loads(&b, vector(0, 0, 0), 1, &s, &loads) == VM_OK);
    CHECK(vm_accelerations(&b, &loads, force, torque, &dv, &domega) == VM_OK);
    check_error("(156) Phi", "E1", "abs", apart(loads.force, vector(-.45, .3, -.2)), bound, 0, 0);
    check_error("(158) M^Phi", "E1", "abs", apart(loads.moment, vector(-.06, -.08, .015)), bound, 0, 0);
    check_error("(157) R", "E1", "abs", apart(loads.torque, vector(-.0675, .1015, .088)), bound, 0, 0);
    check_error("(154),(159) v'", "E1", "abs", apart(dv, vector(-.075, .05, -9.843333333333333333333)), 4 * bound,
                0, 0);
    check_error("(155),(160) W'", "E1", "abs", apart(domega, expected), bound, 0, 0);
    check_error("r' = v + drift", "E1", "abs",
                apart(vmi_add(b.v, loads.drift), vector(.05833333333333333333333, .225, -.1333333333333333333333)),
                bound, 0, 0);
    /* (157) as printed */
    printed = vmi_inertia_times(&loads.inertia_rate, vmi_sub(s.spin, b.omega));
    check_error("(157) printed", "E1", "abs", apart(printed, vector(-.03, .244, .148)), bound, 0, 0);
    ERRATUM("(138) I_S2=dI, (150),(152),(155),(157),(160)", apart(printed, loads.torque) > .15,
            check_holds("(157) R") && check_holds("(155),(160) W'"));
    /* ... which is right only where P(SS2) omega2 = 0, as here, with the stream at the mass centre */
    {
        vm_stream ring = s;
        vm_reactive at_centre;
        ring.at = vector(0, 0, 0);
        CHECK(vm_reactive_loads(&b, ring.at, 1, &ring, &at_centre) == VM_OK);
        printed = vmi_inertia_times(&at_centre.inertia_rate, vmi_sub(s.spin, b.omega));
        check_error("(157) printed", "SS2 = 0", "abs", apart(printed, at_centre.torque), bound, 0, 0);
        CHECK(size_of(at_centre.moment) == 0 && size_of(at_centre.drift) == 0); /* a stream at the mass centre */
    }
    /* (151), (152), (227)-(229): the rates of the momenta, of which (228) and (229) print I' Omega_2 */
    flow.n = 1;
    flow.streams = (vm_stream *)&s;
    flow.force = force;
    flow.moment = torque;
    CHECK(vm_flow_start(&flow, &b, y) == VM_OK && vm_flow_rhs(0, y, dy, &flow) == 0);
    rates[0] = vmi_get3(dy + VM_Y_P);
    rates[1] = vmi_get3(dy + VM_Y_H);
    check_error("(151),(227) (Mv)'", "E1", "abs", apart(rates[0], vmi_add(force, vmi_scale(s.rate, s.velocity))),
                64 * bound, 0, 0);
    spin_rate = vmi_add(vmi_add(torque, loads.moment), vmi_scale(s.rate, vmi_inertia_times(&s.gyration, s.spin)));
    check_error("(152),(228) (IW)'", "E1", "abs", apart(rates[1], spin_rate), bound, 0, 0);
    spin_rate = vmi_add(vmi_add(torque, loads.moment), vmi_inertia_times(&loads.inertia_rate, s.spin));
    ERRATUM("(227)-(229)", apart(rates[1], spin_rate) > .15,
            check_holds("(151),(227) (Mv)'") && check_holds("(152),(228) (IW)'"));
    /* (153), and the term omega x I omega that (230)-(232) must have */
    spin_rate = vmi_add(vmi_inertia_times(&loads.inertia_rate, b.omega), vmi_inertia_times(&b.inertia, domega));
    printed = spin_rate;
    spin_rate = vmi_add(spin_rate, vmi_cross(b.omega, vmi_inertia_times(&b.inertia, b.omega)));
    check_error("(153),(230) (IW)'", "E1", "abs", apart(rates[1], spin_rate), bound, 0, 0);
    ERRATUM("(230)-(232)", apart(rates[1], printed) > .1, check_holds("(153),(230) (IW)'"));
}

/* (161)-(164): the components, principal axes that stay principal, own inertia rates */
static void test_components(void)
{
    vm_body b = case_e1();
    vm_stream s = case_e1_stream();
    vm_reactive loads;
    vm_vec3 dv = vector(0, 0, 0), dw = dv, F = vector(2, -3, .5), M = vector(.25, .75, -.5);
    double A = 2, B = 1.5, C = 1.25, p = .25, q = -.5, r = .75, p2 = 1, q2 = -.75, r2 = .5, k = -.5;
    b.inertia = tensor(A, B, C, 0, 0, 0);
    b.omega = vector(p, q, r);
    s.spin = vector(p2, q2, r2);
    s.at = vector(0, 0, 0);
    s.gyration = tensor(.25, .5, .125, 0, 0, 0);
    CHECK(!vm_reactive_loads(&b, s.at, 1, &s, &loads) && !vm_accelerations(&b, &loads, F, M, &dv, &dw));
    check_error("(161),(162)", "principal", "abs",
                apart(vmi_scale(6, dv), vector(2 + k * (1 - .1), -3 + k * (-.4 - .2), .5 + k * (.3 + .1))),
                30 * eps, 0, 0);
    check_error("(163),(164)", "principal", "abs",
                apart(dw, vector((.25 + k * .25 * (p2 - p) - (C - B) * q * r) / A,
                                 (.75 + k * .5 * (q2 - q) - (A - C) * p * r) / B,
                                 (-.5 + k * .125 * (r2 - r) - (B - A) * p * q) / C)),
                8 * eps, 0, 0);
    /* axes that stay principal are a condition of (164): an off-diagonal own rate adds I'_xy (q2 - q) to the first */
    s.gyration.xy = R(.0625);
    CHECK(!vm_reactive_loads(&b, s.at, 1, &s, &loads));
    check_error("(164) + I'_xy", "principal", "abs",
                fabs((double)loads.torque.x - k * (.25 * (p2 - p) + .0625 * (q2 - q))), 8 * eps, 0, 0);
    ERRATUM("(163),(164)", fabs((double)loads.torque.x - k * .25 * (p2 - p)) > .005,
            check_holds("(163),(164)") && check_holds("(164) + I'_xy"));
    /* (165): no stream, constant mass */
    CHECK(!vm_reactive_loads(&b, s.at, 0, NULL, &loads) && !vm_accelerations(&b, &loads, F, M, &dv, &dw));
    CHECK(size_of(loads.force) + size_of(loads.moment) + size_of(loads.torque) == 0);
    check_error("(165)", "principal", "abs", apart(dv, vmi_scale(1 / R(6), F)), 2 * eps, 0, 0);
}

/* E3: a tank off centre drains; the mass centre and the inertia are states */
typedef struct tank {
    vm_flow flow;
    vm_stream stream;
    vm_body body;
    double empty, contents;
} tank;

/* own: E3, pieces with an inertia and a spin of their own; else E2, points */
static void tank_init_as(tank *k, int own)
{
    const vm_vec3 at = vector(.5, -.3, .4);
    const vm_inertia contents = own ? tensor(.35, .55, .25, .05, .05, .05) : tensor(0, 0, 0, 0, 0, 0);
    memset(k, 0, sizeof *k);
    k->empty = 4;
    k->contents = 2;
    k->body = case_e1();
    k->body.mass = R(k->empty + k->contents);
    k->body.inertia = vmi_inertia_plus(vmi_inertia_plus(k->body.inertia, R(k->contents), contents),
                                       R(k->empty * k->contents / (k->empty + k->contents)),
                                       vmi_inertia_of_point(at));
    k->stream.rate = R(-.5);
    k->stream.at = at;
    k->stream.velocity = vector(.7, .2, -.5);
    if (own) k->stream.spin = vector(.8, -.5, .3);
    k->stream.gyration = contents;
    k->flow.n = 1;
    k->flow.streams = &k->stream;
    k->flow.centre = vmi_scale(R(k->contents / (k->empty + k->contents)), at);
}

static void tank_init(tank *k) { tank_init_as(k, 1); }

/* The state of printed forms, body axes: omega, v, then attitude is not needed without outer loads */
typedef struct printed_tank {
    tank *k;
    int full; /* (157) with I', else the own inertia rate */
} printed_tank;

static int printed_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const printed_tank *p = (const printed_tank *)ctx;
    const tank *k = p->k;
    const double contents = k->contents - .5 * (double)t, mass = k->empty + contents;
    const vm_vec3 omega = vmi_get3(y), v = vmi_get3(y + 3), d = vmi_scale(R(k->empty / mass), k->stream.at);
    const vm_vec3 phi = vmi_scale(k->stream.rate, vmi_add(k->stream.velocity, vmi_cross(omega, d)));
    vm_inertia own = vmi_stream_own(k->stream.rate, &k->stream.gyration), rate, inertia;
    vm_vec3 moment;
    vmi_inertia_ldl factors;
    rate = vmi_inertia_plus(own, k->stream.rate, vmi_inertia_of_point(d));
    inertia = vmi_inertia_plus(case_e1().inertia, R(contents), k->stream.gyration);
    inertia = vmi_inertia_plus(inertia, R(k->empty * contents / mass), vmi_inertia_of_point(k->stream.at));
    moment = vmi_cross(d, phi);
    if (p->full) moment = vmi_add(moment, vmi_inertia_times(&rate, k->stream.spin));
    else /* d x M' v_r + I_own' (O2 - O), "Exact forms" 3 */
        moment = vmi_add(vmi_cross(d, vmi_scale(k->stream.rate, k->stream.velocity)),
                         vmi_inertia_times(&own, k->stream.spin));
    vmi_inertia_factor(&inertia, &factors);
    vmi_set3(dydt, vmi_stream_euler(&inertia, &factors, omega, moment));
    vmi_set3(dydt + 3, vmi_sub(vmi_scale(R(1 / mass), phi), vmi_cross(omega, v)));
    return 0;
}

static void test_e3(void)
{
    const vm_vec3 omega = vector(-0.06364302908508482781131, -0.3754920719754950330038, 0.3874588253853131828139);
    const vm_vec3 v = vector(-0.1206282217937351091361, 0.01323136371860204701243, -0.05589016653265240747681);
    const double bound = PICK(1e-12, 1e-5);
    tank k;
    vm_real y[VM_FLOW_STATES];
    vm_body b;
    vmi_mat3 turn;
    tank_init(&k);
    CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_OK);
    CHECK(solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 3) >= 0);
    CHECK(vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b) == VM_OK);
    turn = vmi_rotation(b.q);
    check_error("E3 omega(3)", "vm_flow_rhs", "abs", apart(vmi_times_transposed(&turn, b.omega), omega), bound, 0, 0);
    check_error("E3 v(3)", "vm_flow_rhs", "abs", apart(vmi_times_transposed(&turn, b.v), v), bound, 0, 0);
    check_error("E3 mass, centre", "vm_flow_rhs", "abs",
                apart(vmi_get3(y + VM_Y_CENTRE), vmi_scale(R(.5 / 4.5), k.stream.at)) + fabs((double)b.mass - 4.5),
                bound, 0, 0);
}

static double largest(vm_vec3 a) { return fmax(fabs((double)a.x), fmax(fabs((double)a.y), fabs((double)a.z))); }

static int drift_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    tank *k = (tank *)ctx;
    const int status = vm_flow_rhs(t, y, dydt, &k->flow);
    vmi_set3(dydt + VM_FLOW_STATES, vmi_sub(vmi_get3(dydt), vmi_scale(1 / y[VM_Y_MASS], vmi_get3(y + VM_Y_P))));
    return status;
}

/* (150), (152), (155), (157), (160) as printed miss E2 and E3 by 6.7e-2 and 3.5e-2 in the largest component;
   without the drift, r' = v, the place is wrong by 0.131 (E2) */
static void test_printed_tanks(void)
{
    static const double printed_error[2] = {6.7e-2, 3.5e-2}, undrifted[2] = {.131, .134};
    int own;
    for (own = 0; own < 2; own++) {
        tank k;
        printed_tank p;
        vm_real y[VM_FLOW_STATES + 3] = {0}, z[6];
        vm_body b;
        vmi_mat3 turn;
        vm_vec3 omega;
        tank_init_as(&k, own);
        CHECK(!vm_flow_start(&k.flow, &k.body, y) && solve(drift_rhs, &k, VM_FLOW_STATES + 3, y, 0, 3) >= 0);
        CHECK(!vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b));
        turn = vmi_rotation(b.q);
        omega = vmi_times_transposed(&turn, b.omega);
        for (p.k = &k, p.full = 0; p.full < 2; p.full++) {
            double error;
            vmi_set3(z, k.body.omega);
            vmi_set3(z + 3, k.body.v);
            CHECK(solve(printed_rhs, &p, 6, z, 0, 3) >= 0);
            error = largest(vmi_sub(vmi_get3(z), omega));
            if (p.full)
                check_error("(155) printed", own ? "E3" : "E2", "rel", fabs(error / printed_error[own] - 1), .01,
                            error, 0);
            else check_error("forms 3", own ? "E3" : "E2", "abs", error, PICK(1e-12, 1e-5), 0, 0);
        }
        check_error("r' = v", own ? "E3" : "E2", "rel", fabs(largest(vmi_get3(y + VM_FLOW_STATES)) / undrifted[own] - 1),
                    .01, 0, 0);
        ERRATUM("kinematics (not given)", largest(vmi_get3(y + VM_FLOW_STATES)) > .1, check_holds("r' = v + drift"));
    }
}

/* E4-E6, (45), (167), (170)-(176), line and axle */
static void test_one_dimension(void)
{
    const double bound = PICK(1e-12, 1e-5);
    struct {
        const char *name;
        double x0, m0, rate, u, force, t, v;
        int motion;
    } cases[] = {
        {"(173a) E4", 1, 2, -.4, 3, 0, 3, -2, VM_ABSOLUTE},
        {"(171) E4", 1, 2, -.4, 0, 0, 3, 2.5, VM_AT_REST},
        {"(174) E4", 1, 2, -.4, 0, 0, 3, 1, VM_CARRIED},
        {"(45),(167) E5", 2, 3, -.65, 0, 0, 2, 3.529411764705882352941, VM_AT_REST},
        {"(175),(176) E6", 2, 3, -.65, -2.5, 0, 2, 3.419960094014848237909, VM_RELATIVE},
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        vm_stream1 s;
        vm_flow1 flow = {0};
        vm_real y[VM_FLOW1_STATES], x = 0, v = 0;
        s.rate = R(cases[i].rate);
        s.velocity = R(cases[i].u);
        s.motion = cases[i].motion;
        flow.n = 1;
        flow.streams = &s;
        y[0] = 0;
        y[1] = R(cases[i].m0 * cases[i].x0);
        y[2] = R(cases[i].m0);
        CHECK(solve(vm_flow1_rhs, &flow, VM_FLOW1_STATES, y, 0, cases[i].t) >= 0);
        CHECK(!vm_linear_flow(R(cases[i].t), 0, R(cases[i].x0), R(cases[i].m0), 0, &s, &x, &v));
        check_error(cases[i].name, "vm_flow1_rhs", "abs", fabs((double)(y[1] / y[2]) - cases[i].v), bound, 0, 0);
        check_error(cases[i].name, "closed", "eps", fabs((double)v - cases[i].v) / eps, 20, 0, 0);
        check_error(cases[i].name, "x", "abs", fabs((double)(x - y[0])), bound, 0, 0);
    }
    check_error("E4 (171)", "closed", "eps", fabs((double)vm_velocity_by_momentum(1, 2, R(.8), 0, 0) - 2.5) / eps, 4, 0, 0);
    check_error("E4 (173a)", "closed", "eps", fabs((double)vm_velocity_by_momentum(1, 2, R(.8), 3, 0) + 2) / eps, 8, 0, 0);
    check_error("E4 (174)", "closed", "eps", fabs((double)vm_tsiolkovsky(1, 2, R(.8), 0) - 1) / eps, 1, 0, 0);
    check_error("E5 (45),(167)", "closed", "eps",
                fabs((double)vm_velocity_by_momentum(2, 3, R(1.7), 0, 0) - 3.529411764705882352941) / eps, 8, 0, 0);
    check_error("E6 (175),(176)", "closed", "eps",
                fabs((double)vm_tsiolkovsky(2, 3, R(1.7), R(-2.5)) - 3.419960094014848237909) / eps, 8, 0, 0);
    /* (171) with a moment: I r = I0 r0 + M t */
    check_error("(171) with M", "closed", "eps", fabs((double)vm_velocity_by_momentum(1, 2, 4, 0, 3) - 1.25) / eps, 1, 0, 0);
    CHECK(vm_velocity_by_momentum(1, -2, 4, 0, 3) != vm_velocity_by_momentum(1, -2, 4, 0, 3));
    CHECK(vm_tsiolkovsky(1, 2, 0, 1) != vm_tsiolkovsky(1, 2, 0, 1));
}

static void test_closed_forms(void)
{
    static const struct {
        double t, x0, v0, m0, rate, force, w;
        int relative;
        double v, x, m, v_tsiolkovsky;
    } line[] = {
#include "data/streams_line.h"
    };
    static const struct {
        double t, rate, C, A, axial, transverse, out, nozzle, p, q, r, x, y, phase;
    } jets[] = {
#include "data/streams_jet.h"
    };
    size_t i;
    for (i = 0; i < sizeof line / sizeof *line; i++) {
        const double tau = line[i].rate * line[i].t / line[i].m0, least = tau < 0 ? 1 + tau : 1;
        double pull = (fabs(line[i].force) + fabs(line[i].rate) * (fabs(line[i].w) + fabs(line[i].v0))) /
                      line[i].m0 / least * line[i].t;
        vm_stream1 s;
        vm_real x = 0, v = 0;
        s.rate = R(line[i].rate);
        s.velocity = R(line[i].w);
        s.motion = line[i].relative ? VM_RELATIVE : VM_ABSOLUTE;
        CHECK(!vm_linear_flow(R(line[i].t), R(line[i].x0), R(line[i].v0), R(line[i].m0), R(line[i].force), &s, &x,
                              &v));
        check_error("vm_linear_flow v", s.motion ? "absolute" : "relative", "eps",
                    ERROR_EPS(v, line[i].v, 0, (fabs(line[i].v0) + pull) / least), 8, tau, (double)i);
        check_error("vm_linear_flow x", s.motion ? "absolute" : "relative", "eps",
                    ERROR_EPS(x, line[i].x, 0, fabs(line[i].x0) + line[i].t * (fabs(line[i].v0) + pull)), 8, tau,
                    (double)i);
        v = vm_tsiolkovsky(R(line[i].v0), R(line[i].m0), R(line[i].m), R(line[i].w));
        check_error("vm_tsiolkovsky", "random", "eps",
                    ERROR_EPS(v, line[i].v_tsiolkovsky, 0,
                              fabs(line[i].v0) + fabs(line[i].w * log(line[i].m / line[i].m0))),
                    4, tau, (double)i);
    }
    for (i = 0; i < sizeof jets / sizeof *jets; i++) {
        const double tau = jets[i].rate * jets[i].transverse * jets[i].t / jets[i].A;
        const double grow = 1 / (tau < 0 ? 1 + tau : 1), lever = jets[i].nozzle * jets[i].nozzle + 1;
        const double scale = hypot(jets[i].x, jets[i].y) *
                             (1 + fabs(jets[i].phase) + grow * fabs(jets[i].rate * jets[i].t / jets[i].A) * lever +
                              grow * fabs(jets[i].r) * jets[i].t);
        vm_jet j;
        vm_vec3 omega = vector(0, 0, 0);
        j.rate = R(jets[i].rate);
        j.axial = R(jets[i].C);
        j.transverse = R(jets[i].A);
        j.gyration_axial = R(jets[i].axial);
        j.gyration_transverse = R(jets[i].transverse);
        j.gyration_out = R(jets[i].out);
        j.nozzle = R(jets[i].nozzle);
        CHECK(!vm_jet_damping(R(jets[i].t), &j, vector(jets[i].p, jets[i].q, jets[i].r), &omega));
        check_error("vm_jet_damping", "random", "eps*",
                    hypot((double)omega.x - jets[i].x, (double)omega.y - jets[i].y) / eps / scale, 8, tau,
                    (double)i);
        CHECK((double)omega.z == jets[i].r);
    }
}

/* ---- Balances ---- */

/* A body with streams of every kind, in and out, and outer loads */
typedef struct scene {
    vm_flow flow;
    vm_stream streams[4];
    vm_body body;
} scene;

static int scene_loads(vm_real t, const vm_real *y, vm_flow *flow)
{
    double s = sin((double)t), c = cos((double)t);
    flow->force = vmi_add(vector(2 * s, c, -1), vmi_scale(R(-.5), vmi_get3(y + VM_Y_P)));
    flow->moment = vector(.1 * c, .2, -.1 * s);
    return 0;
}

static void scene_init(scene *k)
{
    int i;
    memset(k, 0, sizeof *k);
    k->body = case_e1();
    k->body.q = quaternion(.5, -.4, .7, .2);
    k->body.r = vector(1, -2, .5);
    for (i = 0; i < 4; i++) {
        vm_stream *s = k->streams + i;
        s->motion = i;
        s->rate = R(i % 2 ? .3 + .1 * i : -.4 + .05 * i);
        s->at = vector(.5 - .2 * i, .1 * i - .3, .4 - .3 * i);
        s->velocity = vector(.7 * i - 1, .2 + i, .5 - .4 * i);
        s->spin = vector(.8 - i, .5, .3 * i);
        s->gyration = tensor(.1, .12 + .01 * i, .09, .005 * i, -.02, .015);
    }
    k->flow.n = 4;
    k->flow.streams = k->streams;
    k->flow.update = scene_loads;
    k->flow.centre = vector(.1, .05, -.1);
}

static void balances(const vm_flow *flow, const vm_real *y, vm_vec3 *p, vm_vec3 *h, double *energy)
{
    vm_body b;
    CHECK(vm_flow_body(flow, VM_FLOW_STATES, y, &b) == VM_OK);
    *p = vmi_add(vm_momentum(&b), vmi_get3(y + VM_Y_BALANCE));
    *h = vmi_add(vmi_get3(y + VM_Y_H), vmi_cross(b.r, vm_momentum(&b))); /* with what flows to and from stores */
    *h = vmi_add(*h, vmi_get3(y + VM_Y_BALANCE + 3));
    *energy = (double)(vm_kinetic_energy(&b) + y[VM_Y_BALANCE + 6]);
}

/* Momentum, angular momentum, kinetic energy of body and streams, less what outer loads did: (118) in its limit */
static void test_balances(void)
{
    scene k;
    vm_real y[VM_FLOW_BALANCED_STATES] = {0};
    vm_vec3 p0, h0, p, h;
    double e0, e, bound = PICK(2e-12, 2e-5);
    scene_init(&k);
    CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_OK);
    balances(&k.flow, y, &p0, &h0, &e0);
    CHECK(solve(vm_flow_balanced_rhs, &k.flow, VM_FLOW_BALANCED_STATES, y, 0, 5) >= 0);
    balances(&k.flow, y, &p, &h, &e);
    check_error("balance of p", "4 streams", "abs", apart(p, p0), bound, 0, 0);
    check_error("balance of L_O", "4 streams", "abs", apart(h, h0), 4 * bound, 0, 0);
    check_error("balance of T", "4 streams", "abs", fabs(e - e0), bound, 0, 0);
    CHECK(size_of(vmi_get3(y + VM_Y_BALANCE)) > .5 && size_of(vmi_get3(y + VM_Y_BALANCE + 3)) > .5 &&
          fabs((double)y[VM_Y_BALANCE + 6]) > .05); /* something was balanced */
}

/* What was shed, stream by stream from its own velocity and place, not from the header's sums: momentum, angular
   momentum about the origin, kinetic energy, and the work of engines and impacts; outer loads with it */
enum { SHED_P = VM_FLOW_STATES, SHED_L = SHED_P + 3, SHED_T = SHED_L + 3, WORK = SHED_T + 1, SHED = WORK + 1 };

static int shed_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    scene *k = (scene *)ctx;
    const int status = vm_flow_rhs(t, y, dydt, &k->flow);
    vm_vec3 p, l, F = k->flow.force, M = k->flow.moment;
    double energy = 0, work = 0;
    vm_body b;
    vmi_mat3 turn;
    int i;
    if (status || vm_flow_body(&k->flow, VM_FLOW_STATES, y, &b)) return status ? status : -1;
    turn = vmi_rotation(b.q);
    p = vmi_scale(-1, F);
    l = vmi_scale(-1, vmi_add(M, vmi_cross(b.r, F)));
    work = (double)(vmi_dot(F, b.v) + vmi_dot(M, b.omega));
    for (i = 0; i < 4; i++) {
        const vm_stream *s = k->streams + i;
        const vm_vec3 d = vmi_times(&turn, vmi_sub(s->at, vmi_get3(y + VM_Y_CENTRE)));
        const vm_vec3 point = vmi_add(b.v, vmi_cross(b.omega, d));
        vm_vec3 u = s->velocity, spin = s->spin, own, relative;
        if (i == VM_RELATIVE) {
            u = vmi_add(point, vmi_times(&turn, u));
            spin = vmi_add(b.omega, vmi_times(&turn, spin));
        }
        if (i == VM_CARRIED) {
            u = point;
            spin = b.omega;
        }
        if (i == VM_AT_REST) u = spin = vector(0, 0, 0);
        own = vmi_times(&turn, vmi_inertia_times(&s->gyration, vmi_times_transposed(&turn, spin)));
        p = vmi_sub(p, vmi_scale(s->rate, u));
        l = vmi_sub(l, vmi_scale(s->rate, vmi_add(vmi_cross(vmi_add(b.r, d), u), own)));
        energy -= (double)(s->rate * (vmi_dot(u, u) + vmi_dot(spin, own))) / 2;
        u = vmi_sub(u, point);
        relative = vmi_sub(spin, b.omega);
        own = vmi_times(&turn, vmi_inertia_times(&s->gyration, vmi_times_transposed(&turn, relative)));
        work -= (double)(s->rate * (vmi_dot(u, u) + vmi_dot(relative, own))) / 2;
    }
    vmi_set3(dydt + SHED_P, p);
    vmi_set3(dydt + SHED_L, l);
    dydt[SHED_T] = R(energy);
    dydt[WORK] = R(work);
    return 0;
}

static void test_shed(void)
{
    scene k;
    vm_real y[SHED] = {0};
    vm_body a, b;
    double bound = PICK(2e-12, 4e-5);
    scene_init(&k);
    CHECK(!vm_flow_start(&k.flow, &k.body, y) && !vm_flow_body(&k.flow, VM_FLOW_STATES, y, &a));
    CHECK(solve(shed_rhs, &k, SHED, y, 0, 5) >= 0 && !vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b));
    check_error("body and all shed: p", "4 streams", "abs",
                apart(vmi_add(vm_momentum(&b), vmi_get3(y + SHED_P)), vm_momentum(&a)), bound, 0, 0);
    check_error("body and all shed: L", "4 streams", "abs",
                apart(vmi_add(vm_angular_momentum(&b, vector(0, 0, 0)), vmi_get3(y + SHED_L)),
                      vm_angular_momentum(&a, vector(0, 0, 0))),
                4 * bound, 0, 0);
    check_error("body and all shed: T", "4 streams", "abs",
                fabs((double)(vm_kinetic_energy(&b) + y[SHED_T] - y[WORK] - vm_kinetic_energy(&a))), bound, 0, 0);
    CHECK(fabs((double)y[SHED_T]) > .1 && fabs((double)y[WORK]) > .1);
}

/* The same at the integrator's tolerances, rk45: what is not kept goes by them */
static void test_balance_of_tolerance(void)
{
    double tolerance;
    for (tolerance = 1e-3; tolerance > PICK(1e-11, 1e-5); tolerance /= 100) {
        scene k;
        vm_real y[VM_FLOW_BALANCED_STATES] = {0}, work[RK45_WORK(VM_FLOW_BALANCED_STATES)];
        vm_vec3 p0, h0, p, h;
        double e0, e;
        rk45_options o = rk45_defaults(NULL);
        rk45 s;
        scene_init(&k);
        o.rtol = R(tolerance);
        o.atol = R(1e-3 * tolerance);
        CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_OK);
        balances(&k.flow, y, &p0, &h0, &e0);
        CHECK(rk45_init(&s, vm_flow_balanced_rhs, &k.flow, VM_FLOW_BALANCED_STATES, 0, y, &o, work) >= 0 &&
              rk45_solve(&s, 5) >= 0);
        balances(&k.flow, s.y, &p, &h, &e);
        check_error("balance of p", "rk45", "tol", apart(p, p0) / tolerance, 1, tolerance, 0);
        check_error("balance of L_O", "rk45", "tol", apart(h, h0) / tolerance, 4, tolerance, 0);
        check_error("balance of T", "rk45", "tol", fabs(e - e0) / tolerance, 4, tolerance, 0);
    }
}

/* One part of the stream leaves or comes in an instant, F and M_S act: (133)-(149), and T' as the limit of (113),
   (118) */
static void test_small_jumps(void)
{
    scene k;
    int i, sign;
    vm_real y[VM_FLOW_BALANCED_STATES] = {0}, dy[VM_FLOW_BALANCED_STATES];
    scene_init(&k);
    k.flow.update = NULL;
    k.flow.centre = vector(0, 0, 0);
    for (i = 0; i < 4; i++)
        for (sign = -1; sign < 2; sign += 2) {
            const double dt = PICK(1e-6, 1e-2);
            vm_stream *s = k.streams + i;
            vm_body part = k.body, after;
            vm_vec3 d, dK, dL, F = vector(1, -2, 3), M = vector(.5, .25, -1);
            vm_impulse outer;
            double dT;
            vmi_mat3 turn = vmi_rotation(k.body.q);
            s->rate = R(.5 * sign);
            k.flow.n = 1;
            k.flow.streams = s;
            k.flow.force = F;
            k.flow.moment = M;
            CHECK(!vm_flow_start(&k.flow, &k.body, y) && !vm_flow_balanced_rhs(0, y, dy, &k.flow));
            d = vmi_times(&turn, s->at);
            part.mass = R(.5 * dt);
            part.r = vmi_add(k.body.r, d);
            part.inertia = vmi_stream_own(part.mass, &s->gyration);
            part.v = vmi_vec3(0, 0, 0);
            part.omega = vmi_vec3(0, 0, 0);
            if (i == VM_RELATIVE || i == VM_CARRIED) {
                part.v = vmi_add(k.body.v, vmi_cross(k.body.omega, d));
                part.omega = k.body.omega;
            }
            if (i == VM_RELATIVE) {
                part.v = vmi_add(part.v, vmi_times(&turn, s->velocity));
                part.omega = vmi_add(part.omega, vmi_times(&turn, s->spin));
            }
            if (i == VM_ABSOLUTE) {
                part.v = s->velocity;
                part.omega = s->spin;
            }
            outer.linear = vmi_scale(R(dt), F);
            outer.couple = vmi_scale(R(dt), M);
            outer.at = k.body.r;
            CHECK((sign > 0 ? vm_attach : vm_separate)(&k.body, &part, &outer, &after) == VM_OK);
            dK = vmi_scale(R(1 / dt), vmi_sub(vm_momentum(&after), vm_momentum(&k.body)));
            dL = vmi_scale(R(1 / dt), vmi_sub(vmi_spin_momentum(&after), vmi_spin_momentum(&k.body)));
            dT = (double)(vm_kinetic_energy(&after) - vm_kinetic_energy(&k.body)) / dt;
            check_error("(140),(145),(149)", "one jump", "abs", apart(dK, vmi_get3(dy + VM_Y_P)), PICK(2e-8, 2e-3),
                        i, sign);
            check_error("(144),(146),(148)", "one jump", "abs", apart(dL, vmi_get3(dy + VM_Y_H)), PICK(1e-5, 8e-2),
                        i, sign);
            check_error("T' (113),(118)", "one jump", "abs", fabs(dT + (double)dy[VM_Y_BALANCE + 6]), PICK(2e-4, 2),
                        i, sign);
            /* (143) is r_S x dK = r_S x F dt; the printed one has no dt */
            if (i == VM_CARRIED && sign < 0) {
                vm_vec3 pull = vmi_cross(k.body.r, F);
                check_error("(143)", "one jump", "abs",
                            apart(vmi_cross(k.body.r, outer.linear), vmi_scale(R(dt), pull)), 1e-6, 0, 0);
                ERRATUM("(143)", apart(vmi_cross(k.body.r, outer.linear), pull) > 1, check_holds("(143)"));
            }
        }
}

/* E3 by N jumps with the exact free motion of the rest between: order 1, and what is extrapolated agrees */
static void tank_by_jumps(long jumps, vm_vec3 *omega, vm_vec3 *v, vm_vec3 *r)
{
    tank k;
    vm_real y[VM_FLOW_STATES];
    vm_vec3 centre;
    vm_body b;
    const double h = 3. / (double)jumps;
    long i;
    vmi_mat3 turn;
    tank_init(&k);
    b = k.body;
    centre = k.flow.centre;
    k.flow.n = 0; /* free motion between the jumps */
    for (i = 0; i < 2 * jumps; i++) {
        vm_real work[RK4_WORK(VM_FLOW_STATES)], t = 0;
        CHECK(vm_flow_start(&k.flow, &b, y) == VM_OK);
        CHECK(rk4_solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, &t, R(h / 2), 1, y, work) == 0);
        CHECK(vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b) == VM_OK);
        if (i % 2 == 0) { /* in the middle */
            vm_body part = b;
            const vm_vec3 d = vmi_sub(k.stream.at, centre);
            turn = vmi_rotation(b.q);
            part.mass = R(.5 * h);
            part.r = vmi_add(b.r, vmi_times(&turn, d));
            part.v = vmi_add(b.v, vmi_times(&turn, vmi_add(k.stream.velocity,
                                                           vmi_cross(vmi_times_transposed(&turn, b.omega), d))));
            part.omega = vmi_add(b.omega, vmi_times(&turn, k.stream.spin));
            part.inertia = vmi_stream_own(part.mass, &k.stream.gyration);
            CHECK(vm_separate(&b, &part, NULL, &b) == VM_OK);
            centre = vmi_sub(centre, vmi_scale(part.mass / b.mass, d));
        }
    }
    turn = vmi_rotation(b.q);
    *omega = vmi_times_transposed(&turn, b.omega);
    *v = vmi_times_transposed(&turn, b.v);
    *r = b.r;
}

static void test_jump_limit(void)
{
    vm_vec3 omega[3], v[3], r[3], exact[3];
    tank k;
    vm_real y[VM_FLOW_STATES];
    vm_body b;
    vmi_mat3 turn;
    int i, j;
    const long jumps = PICK(400, 25);
    double ratio;
    tank_init(&k);
    vm_flow_start(&k.flow, &k.body, y);
    solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 3);
    vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b);
    turn = vmi_rotation(b.q);
    exact[0] = vmi_times_transposed(&turn, b.omega);
    exact[1] = vmi_times_transposed(&turn, b.v);
    exact[2] = b.r;
    for (i = 0; i < 3; i++) tank_by_jumps(jumps << i, omega + i, v + i, r + i);
    for (j = 0; j < 3; j++) {
        const vm_vec3 *x = j == 0 ? omega : j == 1 ? v : r;
        vm_vec3 first = vmi_sub(vmi_scale(2, x[1]), x[0]), second = vmi_sub(vmi_scale(2, x[2]), x[1]);
        vm_vec3 limit = vmi_scale(R(1 / 3.), vmi_sub(vmi_scale(4, second), first));
        ratio = apart(x[0], exact[j]) / apart(x[1], exact[j]);
        check_error("order of jumps",
                    j == 0   ? "omega"
                    : j == 1 ? "v"
                             : "r",
                    "1", fabs(ratio - 2), PICK(.02, .2), ratio, 0);
        check_error("limit of jumps",
                    j == 0   ? "omega"
                    : j == 1 ? "v"
                             : "r",
                    "abs", apart(limit, exact[j]), PICK(2e-9, 2e-4), 0, 0);
    }
}

/* The mass centre of everything moves uniformly; the reference point is a point of the body, which its velocity
   shows, with stores too */
typedef struct moments {
    scene *k;
} moments;

static int first_moment_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    scene *k = ((moments *)ctx)->k;
    const vmi_mat3 turn = vmi_rotation(vmi_get_quat(y + VM_Y_Q));
    int i, status = vm_flow_balanced_rhs(t, y, dydt, &k->flow);
    vm_vec3 flow = vmi_get3(y + VM_Y_BALANCE);
    for (i = 0; i < k->flow.n; i++)
        flow = vmi_sub(flow,
                       vmi_scale(k->streams[i].rate,
                                 vmi_add(vmi_get3(y),
                                         vmi_times(&turn, vmi_sub(k->streams[i].at, vmi_get3(y + VM_Y_CENTRE))))));
    vmi_set3(dydt + VM_FLOW_BALANCED_STATES, flow);
    return status;
}

static vm_vec3 reference_point(const vm_real *y)
{
    const vmi_mat3 turn = vmi_rotation(vmi_get_quat(y + VM_Y_Q));
    return vmi_sub(vmi_get3(y), vmi_times(&turn, vmi_get3(y + VM_Y_CENTRE)));
}

static void test_mass_centre(int with_store)
{
    scene k;
    moments m;
    vm_store store;
    vm_real y[VM_FLOW_BALANCED_STATES + 3] = {0}, z[2][VM_FLOW_STATES], dy[VM_FLOW_STATES];
    vm_vec3 X0, P0, X, p, h, velocity;
    const char *region = with_store ? "with store" : "no store";
    double e, h_t = PICK(1e-3, 2e-2), bound = PICK(2e-12, 2e-5);
    int i;
    scene_init(&k);
    k.flow.update = NULL;
    store.at = vector(-.2, .3, .1);
    store.gyration = tensor(.1, .2, .15, 0, .01, 0);
    if (with_store) {
        k.streams[0].from = &store;
        k.streams[3].from = &store;
    }
    CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_OK);
    for (i = 0; i < VM_FLOW_STATES; i++) z[0][i] = z[1][i] = y[i];
    m.k = &k;
    X0 = vmi_scale(y[VM_Y_MASS], vmi_get3(y));
    P0 = vmi_get3(y + VM_Y_P);
    balances(&k.flow, y, &p, &h, &e);
    CHECK(solve(first_moment_rhs, &m, VM_FLOW_BALANCED_STATES + 3, y, 0, 3) >= 0);
    X = vmi_add(vmi_scale(y[VM_Y_MASS], vmi_get3(y)), vmi_get3(y + VM_FLOW_BALANCED_STATES));
    check_error("mass centre of all", region, "abs", apart(X, vmi_add(X0, vmi_scale(3, P0))), 4 * bound, 0, 0);
    X0 = h;
    balances(&k.flow, y, &p, &h, &e);
    check_error("balance of L_O", region, "abs", apart(h, X0), 4 * bound, 0, 0);
    /* v + slip + omega x (-c) by the reference point's path over 2 h */
    vm_flow_rhs(0, z[0], dy, &k.flow);
    for (i = 0; i < VM_FLOW_STATES; i++) CHECK(VM_IS_FINITE(dy[i]));
    {
        const vmi_mat3 turn = vmi_rotation(k.body.q);
        vm_vec3 slip, spin;
        vmi_stream_on_the_way(k.flow.n, k.streams, k.flow.centre, &slip, &spin);
        velocity = vmi_sub(k.body.v, vmi_times(&turn, vmi_scale(1 / k.body.mass, slip)));
        velocity = vmi_sub(velocity, vmi_cross(k.body.omega, vmi_times(&turn, k.flow.centre)));
    }
    CHECK(solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, z[0], 0, h_t) >= 0 && solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, z[1], 0, -h_t) >= 0);
    X = vmi_scale(R(.5 / h_t), vmi_sub(reference_point(z[0]), reference_point(z[1])));
    check_error("a point of the body", region, "abs", apart(X, velocity), PICK(1e-5, 4e-3), 0, 0);
}

/* ---- Special cases against the general one ---- */

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
    for (i = 0; i < 4; i++) k.streams[i].at = vector(0, 0, 0);
    CHECK(!vm_flow_start(&k.flow, &k.body, y));
    for (i = 0; i < 3; i++) {
        z[i] = y[i];
        z[3 + i] = y[VM_Y_P + i];
    }
    z[6] = y[VM_Y_MASS];
    CHECK(!vm_flow_rhs(0, y, dy, &k.flow) && !vm_translation_rhs(0, z, dz, &k.flow));
    for (i = 0; i < 3; i++) {
        check_error("(172)", "translation", "eps", fabs((double)(dz[i] - dy[i])) / eps, 4, i, 0);
        check_error("(172)", "translation", "eps", fabs((double)(dz[3 + i] - dy[VM_Y_P + i])) / eps, 8, i, 0);
    }
    check_error("(172)", "mass", "eps", fabs((double)(dz[6] - dy[VM_Y_MASS])) / eps, 2, 0, 0);
}

/* All kinds at once: p' = F + sum M' u */
static void test_line(void)
{
    vm_stream1 s[4];
    vm_flow1 flow = {0};
    vm_real y[VM_FLOW1_STATES] = {1, 3, 2}, dy[VM_FLOW1_STATES]; /* v = 1.5 */
    int i;
    for (i = 0; i < 4; i++) {
        s[i].rate = R(.5 * i - 1);
        s[i].velocity = R(2 + i);
        s[i].motion = i;
    }
    flow.n = 4;
    flow.streams = s;
    flow.force = R(.25);
    CHECK(!vm_flow1_rhs(0, y, dy, &flow));
    check_error("(175),(176)", "4 streams", "eps",
                (fabs((double)dy[1] - (.25 - 1 * (1.5 + 2) - .5 * 3 + 0 * 1.5 + .5 * 0)) + fabs((double)dy[2] + 1) +
                 fabs((double)dy[0] - 1.5)) /
                    eps,
                4, 0, 0);
}

static void test_plane(void)
{
    vm_stream s3[4];
    vm_stream2 s2[4];
    vm_flow flow = {0};
    vm_flow2 flow2 = {0};
    vm_body b;
    vm_real y[VM_FLOW_STATES], dy[VM_FLOW_STATES], z[VM_FLOW2_STATES], dz[VM_FLOW2_STATES];
    const double angle = 2.3;
    int i;
    memset(s3, 0, sizeof s3);
    memset(s2, 0, sizeof s2);
    b = case_e1();
    b.v.z = 0;
    b.omega = vector(0, 0, .6);
    b.inertia = tensor(2, 1.5, 1.1, .1, 0, 0);
    b.q = quaternion(cos(angle / 2), 0, 0, sin(angle / 2));
    for (i = 0; i < 4; i++) {
        s2[i].rate = R(i % 2 ? .3 : -.2 - .1 * i);
        s2[i].motion = i;
        s2[i].x = R(.3 - .2 * i);
        s2[i].y = R(.1 + .15 * i);
        s2[i].vx = R(1 - i);
        s2[i].vy = R(.5 * i);
        s2[i].spin = R(.4 + i);
        s2[i].gyration = R(.1 + .02 * i);
        s3[i].rate = s2[i].rate;
        s3[i].motion = i;
        s3[i].at = vmi_vec3(s2[i].x, s2[i].y, 0);
        s3[i].velocity = vmi_vec3(s2[i].vx, s2[i].vy, 0);
        s3[i].spin.z = s2[i].spin;
        s3[i].gyration.zz = s2[i].gyration;
    }
    flow.n = flow2.n = 4;
    flow.streams = s3;
    flow2.streams = s2;
    flow.centre = vector(.05, -.1, 0);
    flow.force = vector(.5, -.25, 0);
    flow.moment.z = R(.125);
    flow2.fx = R(.5);
    flow2.fy = R(-.25);
    flow2.moment = R(.125);
    CHECK(!vm_flow_start(&flow, &b, y));
    z[0] = y[0];
    z[1] = y[1];
    z[2] = R(angle);
    z[3] = y[VM_Y_P];
    z[4] = y[VM_Y_P + 1];
    z[5] = y[VM_Y_H + 2];
    z[6] = y[VM_Y_MASS];
    z[7] = y[VM_Y_CENTRE];
    z[8] = y[VM_Y_CENTRE + 1];
    z[9] = y[VM_Y_INERTIA + 2];
    CHECK(!vm_flow_rhs(0, y, dy, &flow) && !vm_flow2_rhs(0, z, dz, &flow2));
    {
        const vm_real space[VM_FLOW2_STATES] = {
            dy[0],          dy[1],         R(.6),           dy[VM_Y_P],          dy[VM_Y_P + 1],
            dy[VM_Y_H + 2], dy[VM_Y_MASS], dy[VM_Y_CENTRE], dy[VM_Y_CENTRE + 1], dy[VM_Y_INERTIA + 2]};
        for (i = 0; i < VM_FLOW2_STATES; i++)
            check_error("plane = space", "vm_flow2_rhs", "eps", fabs((double)(dz[i] - space[i])) / eps, 12, i, 0);
    }
    CHECK(solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 2) >= 0 && solve(vm_flow2_rhs, &flow2, VM_FLOW2_STATES, z, 0, 2) >= 0);
    check_error("plane = space", "after 2 s", "abs", hypot((double)(z[0] - y[0]), (double)(z[1] - y[1])),
                PICK(1e-12, 1e-5), 0, 0);
    check_error("plane = space", "after 2 s", "abs", fabs((double)(z[5] - y[VM_Y_H + 2])), PICK(1e-12, 1e-5), 0, 0);
}

/* The angle of the plane, to a million turns and beyond */
static void test_plane_angles(void)
{
    static const double sizes[] = {1, 100, 1600, 1e6, 1.6e6, 1e9};
    int i;
    for (i = 0; i < 6000; i++) {
        const double x = i < 60 ? (double)R((i - 30) * (double)VM_PI / 4)
                                : uniform(-1, 1) * sizes[i % (is_float ? 3 : 6)];
        vm_real s, c;
        vmi_sincos_of_angle(R(x), &s, &c);
        check_error("sin, cos", "plane", "eps", fabs((double)s - sin((double)R(x))) / eps, .6, x, 0);
        check_error("sin, cos", "plane", "eps", fabs((double)c - cos((double)R(x))) / eps, .6, x, 0);
    }
    for (i = 0; i < 3; i++) {
        const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
        vm_real s, c;
        vmi_sincos_of_angle(R(bad[i]), &s, &c);
        CHECK(s != s && c != c);
    }
}

/* Zero relative velocity off the mass centre: the spin of a plane body stays, by (155), (157) as printed it does not,
   and the reactive force is M' omega x SS2, not 0 as (166) has it */
static void test_carried(void)
{
    vm_stream2 s = {R(-.5), VM_CARRIED, R(.5), 0, 0, 0, 0, R(.1)};
    vm_flow2 flow = {0};
    vm_real y[VM_FLOW2_STATES] = {0, 0, 0, 0, 0, 0, 6, 0, 0, 1};
    const double omega = 1;
    double x = omega, t, h = 1e-3;
    y[5] = 1;
    flow.n = 1;
    flow.streams = &s;
    CHECK(solve(vm_flow2_rhs, &flow, VM_FLOW2_STATES, y, 0, 2) >= 0);
    check_error("(166) omega stays", "plane", "abs", fabs((double)(y[5] / y[9]) - 1), PICK(1e-12, 1e-5), 0, 0);
    ERRATUM("(166)", hypot((double)y[3], (double)y[4]) > .1, /* momentum was given off, though carried */
            check_holds("(166) omega stays"));
    /* printed: I omega' = SS2 x M'(omega x SS2) + I'(omega2 - omega), omega2 = omega */
    for (t = 0; t < 2; t += h) {
        double mass = 6 - .5 * t, d = .5 * 6 / mass, I = 1 - .5 * t * .1 - (6 * .5 * t / mass) * .25;
        x += h * (-.5 * d * d * x) / I;
    }
    CHECK(x < .9);
    printf("(155), (166) as printed: a spin of 1 becomes %.3f, corrected %.15g\n", x, (double)(y[5] / y[9]));
}

/* The tank's mass, mass centre, inertia and drift as laws of time */
static int tank_law(vm_real t, const vm_real *y, vm_flow *flow)
{
    const tank *k = (const tank *)flow->ctx;
    const double contents = k->contents - .5 * (double)t, mass = k->empty + contents;
    (void)y;
    flow->mass = R(mass);
    flow->centre = vmi_scale(R(contents / mass), k->stream.at);
    flow->inertia = vmi_inertia_plus(case_e1().inertia, R(contents), k->stream.gyration);
    flow->inertia = vmi_inertia_plus(flow->inertia, R(k->empty * contents / mass),
                                     vmi_inertia_of_point(k->stream.at));
    flow->drift = vmi_scale(R(-.5 * k->empty / mass / mass), k->stream.at);
    return 0;
}

static void test_given(void)
{
    const double bound = PICK(2e-12, 1e-5);
    int motion, i;
    for (motion = 0; motion < 4; motion++) {
        tank k;
        vm_real full[VM_FLOW_STATES], given[VM_FLOW_STATES];
        vm_body a, b;
        tank_init(&k);
        k.stream.motion = motion;
        k.flow.force = vector(.3, -1, .5);
        k.flow.moment = vector(.1, .2, -.3);
        CHECK(!vm_flow_start(&k.flow, &k.body, full) && !vm_flow_start(&k.flow, &k.body, given));
        CHECK(solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, full, 0, 3) >= 0 && !vm_flow_body(&k.flow, VM_FLOW_STATES, full, &a));
        k.flow.update = tank_law;
        k.flow.ctx = &k;
        CHECK(solve(vm_flow_given_rhs, &k.flow, VM_FLOW_GIVEN_STATES, given, 0, 3) >= 0);
        tank_law(3, given, &k.flow);
        for (i = VM_FLOW_GIVEN_STATES; i < VM_FLOW_STATES; i++) given[i] = VM_NAN; /* not looked at */
        CHECK(!vm_flow_body(&k.flow, VM_FLOW_GIVEN_STATES, given, &b));
        check_error("laws = states", "vm_flow_given_rhs", "abs",
                    apart(a.r, b.r) + apart(a.v, b.v) + apart(a.omega, b.omega), bound, motion, 0);
        if (motion == VM_CARRIED) {
            vmi_mat3 turn;
            vmi_set3(given, k.body.r);
            given[3] = 1;
            given[4] = given[5] = given[6] = 0;
            vmi_set3(given + VM_Y_P, k.body.v);
            vmi_set3(given + VM_Y_H, k.body.omega);
            CHECK(solve(vm_flow_carried_rhs, &k.flow, VM_FLOW_GIVEN_STATES, given, 0, 3) >= 0);
            turn = vmi_rotation(vmi_get_quat(given + VM_Y_Q));
            check_error("(166)", "vm_flow_carried_rhs", "abs",
                        apart(a.r, vmi_get3(given)) + apart(a.v, vmi_get3(given + VM_Y_P)) +
                            apart(a.omega, vmi_times(&turn, vmi_get3(given + VM_Y_H))),
                        bound, 0, 0);
        }
    }
}

/* Streams without velocity: (168) and (169) need -SS2 x v M'; at the mass centre (170), where no stream is left */
static void test_at_rest(void)
{
    tank k;
    vm_reactive loads;
    vm_real y[VM_FLOW_STATES], z[VM_FLOW_STATES], dy[VM_FLOW_STATES], dz[VM_FLOW_STATES];
    vm_vec3 moment, d;
    tank_init(&k);
    k.stream.motion = VM_AT_REST;
    k.flow.force = vector(1, 2, 3);
    k.flow.moment = vector(.1, .2, .3);
    CHECK(!vm_flow_start(&k.flow, &k.body, y) && !vm_flow_rhs(0, y, dy, &k.flow));
    CHECK(!vm_reactive_loads(&k.body, k.flow.centre, 1, &k.stream, &loads));
    d = vmi_sub(k.stream.at, k.flow.centre);
    moment = vmi_cross(d, vmi_scale(k.stream.rate, k.body.v));
    check_error("(167)", "at rest", "eps", apart(vmi_get3(dy + VM_Y_P), k.flow.force) / eps, 4, 0, 0);
    check_error("(168),(169)", "at rest", "eps",
                apart(vmi_get3(dy + VM_Y_H), vmi_sub(k.flow.moment, moment)) / eps, 2, 0, 0);
    ERRATUM("(168),(169)", apart(vmi_get3(dy + VM_Y_H), vmi_add(k.flow.moment, moment)) > size_of(moment),
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

/* Jet damping: mass from around the mass centre leaves at a nozzle behind it, and comes in at a nozzle */
static void test_jet_damping(void)
{
    int sign;
    for (sign = -1; sign < 2; sign += 2) {
        vm_jet jet;
        vm_store store;
        vm_stream s;
        vm_flow flow = {0};
        vm_body b;
        vmi_mat3 turn;
        vm_real y[VM_FLOW_STATES];
        vm_vec3 omega = vector(0, 0, 0);
        memset(&s, 0, sizeof s);
        b = case_e1();
        b.inertia = tensor(6, 6, 1, 0, 0, 0);
        b.omega = vector(.3, -.2, 4);
        jet.rate = R(.5 * sign);
        jet.axial = 1;
        jet.transverse = 6;
        jet.nozzle = R(1.5);
        jet.gyration_axial = R(.2);
        jet.gyration_transverse = R(.75);
        jet.gyration_out = R(.125);
        store.at = vector(0, 0, 0);
        store.gyration = tensor(.75, .75, .2, 0, 0, 0);
        s.rate = jet.rate;
        s.at = vector(0, 0, -1.5);
        s.velocity = vector(0, 0, -2000);
        s.from = &store;
        s.gyration = tensor(.125, .125, .2, 0, 0, 0);
        flow.n = 1;
        flow.streams = &s;
        b.mass = 1000; /* no propellant: the mass centre stays where it is */
        CHECK(!vm_flow_start(&flow, &b, y) && solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 3) >= 0);
        CHECK(!vm_flow_body(&flow, VM_FLOW_STATES, y, &b) && !vm_jet_damping(3, &jet, vector(.3, -.2, 4), &omega));
        turn = vmi_rotation(b.q);
        check_error("jet damping", "vm_flow_rhs", "abs", apart(vmi_times_transposed(&turn, b.omega), omega),
                    PICK(1e-11, 2e-4), sign, 0);
        CHECK((size_of(omega) < size_of(vector(.3, -.2, 4))) == (sign < 0));
    }
}

/* ---- Hard cases ---- */

/* What would go wrong: the mass runs out within a trial step, and momentum is divided by nothing or less */
static void test_running_out(void)
{
    tank k;
    vm_real y[VM_FLOW_STATES];
    vm_body b;
    ode_event dry;
    double t;
    memset(&dry, 0, sizeof dry);
    tank_init(&k);
    k.stream.at = k.flow.centre = vector(0, 0, 0);
    k.stream.gyration = tensor(.05, .05, .05, 0, 0, 0);
    dry.g = vm_flow_mass_left;
    dry.ctx = &k.flow;
    dry.direction = -1;
    dry.action = ODE_STOP;
    k.flow.least_mass = R(.25);
    CHECK(!vm_flow_start(&k.flow, &k.body, y));
    CHECK(solve_events(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 100, &dry, 1, &t) == ODE_EVENT);
    check_error("mass running out", "time", "abs", fabs(t - 11.5), PICK(1e-12, 1e-4), 0, 0);
    CHECK(!vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b));
    /* without the event the run ends next to the end, with the reason: v stays, nothing else shortens the steps */
    k.stream.motion = VM_CARRIED;
    CHECK(!vm_flow_start(&k.flow, &k.body, y));
    CHECK(solve_events(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 100, NULL, 0, &t) == ODE_NOT_FINITE);
    CHECK(k.flow.status == VM_BAD_MASS && t > 11.9 && t < 12 + 1e-5 && y[VM_Y_MASS] > 0);
    /* the inertia first */
    k.body.inertia = tensor(2, 1.5, 1.2, 0, 0, 0); /* what leaves is like the body: all moments end at t = 6 */
    k.stream.gyration = tensor(2 / 3., .5, .4, 0, 0, 0);
    dry.g = vm_flow_inertia_left;
    k.flow.least_inertia = R(.01);
    CHECK(!vm_flow_start(&k.flow, &k.body, y));
    memset(&dry.count, 0, sizeof dry.count);
    CHECK(solve_events(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 100, &dry, 1, &t) == ODE_EVENT);
    check_error("inertia running out", "time", "abs", fabs(t - 5.95), PICK(1e-12, 1e-4), 0, 0);
    CHECK(!vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b));
    CHECK(!vm_flow_start(&k.flow, &k.body, y));
    CHECK(solve_events(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 100, NULL, 0, &t) < 0);
    CHECK(k.flow.status != VM_BAD_MASS && t > 5.95 && t < 6 + 1e-5 && y[VM_Y_INERTIA + 2] > 0);
    {
        vm_flow1 line = {0};
        vm_stream1 s = {-1, 0, VM_CARRIED};
        vm_real z[VM_FLOW1_STATES] = {0, 1, 1};
        line.n = 1;
        line.streams = &s;
        CHECK(solve(vm_flow1_rhs, &line, VM_FLOW1_STATES, z, 0, 2) < 0 && line.status == VM_BAD_MASS && z[2] > 0 &&
              z[2] < R(1e-3));
    }
}

/* The least pivot, wherever it is */
static void test_least_inertia(void)
{
    static const double tensors[][7] = {
        {1, 2, 3, 0, 0, 0, 1},   {2, 1, 3, 0, 0, 0, 1},   {3, 2, 1, 0, 0, 0, 1},
        {2, 2, 3, 1, 0, 0, 1.5}, {2, 3, 2, 0, 1, 0, 1.5}, {2, 2, 2, 1, 1, 1, 4 / 3.},
        {2, 2, 3, 2, 0, 0, 0},   {2, 3, 2, 0, 2, 0, 0},   {-1, 2, 2, 0, 0, 0, 0}};
    vm_flow flow = {0};
    size_t i;
    flow.least_inertia = R(.25);
    for (i = 0; i < sizeof tensors / sizeof *tensors; i++) {
        vm_real y[VM_FLOW_STATES] = {0};
        int k;
        for (k = 0; k < 6; k++) y[VM_Y_INERTIA + k] = R(tensors[i][k]);
        check_error("vm_flow_inertia_left", "pivots", "eps",
                    fabs((double)vm_flow_inertia_left(0, y, &flow) + .25 - tensors[i][6]) / eps, 4, (double)i, 0);
    }
}

/* What would go wrong: opposite streams leave a residue */
static void test_cancelling(void)
{
    scene k;
    vm_reactive loads;
    vm_stream pair[2];
    int i;
    scene_init(&k);
    for (i = 0; i < 4; i++) {
        pair[0] = pair[1] = k.streams[i];
        pair[1].rate = -pair[0].rate;
        CHECK(!vm_reactive_loads(&k.body, k.flow.centre, 2, pair, &loads));
        /* exactly, but where the compiler fuses a product with the sum */
        check_error("opposite streams", "loads", "eps",
                    (size_of(loads.force) + size_of(loads.moment) + size_of(loads.torque) + size_of(loads.drift)) /
                        eps,
                    8, i, 0);
        CHECK(loads.mass_rate == 0 &&
              fabs((double)loads.inertia_rate.xx) + fabs((double)loads.inertia_rate.xy) <= eps);
    }
    /* jets against each other: no force, a couple */
    memset(pair, 0, sizeof pair);
    pair[0].rate = pair[1].rate = R(-.5);
    pair[0].at = vector(0, 1, 0);
    pair[1].at = vector(0, -1, 0);
    pair[0].velocity = vector(10, 0, 0);
    pair[1].velocity = vector(-10, 0, 0);
    k.body.omega = vector(0, 0, 0);
    k.body.q = quaternion(1, 0, 0, 0);
    CHECK(!vm_reactive_loads(&k.body, vector(0, 0, 0), 2, pair, &loads));
    CHECK(size_of(loads.force) == 0 && size_of(loads.drift) == 0);
    CHECK((double)loads.moment.z == 10 && loads.mass_rate == -1);
}

/* What would go wrong: a grain of sand on a ship, or a ship that becomes a grain, lose it in roundings */
static void test_mass_ratios(void)
{
    static const double changes[] = {1e-12, 1e-6, 1e6, 1e12};
    int i;
    for (i = 0; i < 4; i++) {
        const double change = is_float && changes[i] < 1 ? sqrt(changes[i]) : changes[i];
        vm_flow flow = {0};
        vm_stream s;
        vm_body b = case_e1();
        vm_real y[VM_FLOW_STATES];
        memset(&s, 0, sizeof s);
        s.rate = R(6 * change);
        s.motion = VM_AT_REST;
        s.gyration = tensor(.4, .4, .4, 0, 0, 0);
        flow.n = 1;
        flow.streams = &s;
        b.inertia = tensor(2.4, 2.4, 2.4, 0, 0, 0);
        CHECK(!vm_flow_start(&flow, &b, y) && solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 1) >= 0);
        CHECK(!vm_flow_body(&flow, VM_FLOW_STATES, y, &b));
        check_error("mass ratios", "v", "eps", fabs((double)b.v.y * (1 + change) / .2 - 1) / eps, 8, change, 0);
        check_error("mass ratios", "omega", "eps", fabs((double)b.omega.z * (1 + change) / .6 - 1) / eps, 8, change,
                    0);
    }
    {
        vm_flow1 line = {0};
        vm_stream1 s = {-1, 0, VM_AT_REST};
        vm_real z[VM_FLOW1_STATES] = {0, 1, 1};
        const double least = PICK(1e-12, 1e-5);
        line.n = 1;
        line.streams = &s;
        CHECK(solve(vm_flow1_rhs, &line, VM_FLOW1_STATES, z, 0, 1 - least) >= 0);
        check_error("mass ratios", "to 1e-12", "rel", fabs((double)(z[2]) / least - 1), PICK(1e-3, .1), 0, 0);
    }
}

/* What would go wrong: the quaternion's length and the momentum creep over a million revolutions. Loose steps, so
   that a drift would show, with free precession. */
static void test_revolutions(void)
{
    const double revolutions = PICK(1e6, 1e6), speed = 2 * (double)VM_PI;
    vm_flow flow = {0};
    vm_body b = case_e1();
    static vm_real work[RK4_WORK(VM_FLOW_GIVEN_STATES)];
    vm_real y[VM_FLOW_STATES], t = 0;
    vm_vec3 h;
    double norm, worst = 0;
    int i;
    b.inertia = tensor(2, 2, 1, 0, 0, 0);
    b.omega = vector(.01 * speed, 0, speed);
    CHECK(!vm_flow_start(&flow, &b, y));
    h = vmi_get3(y + VM_Y_H);
    for (i = 0; i < 10; i++) {
        t = 0; /* float has no room for the time of a million revolutions */
        CHECK(rk4_solve(vm_flow_given_rhs, &flow, VM_FLOW_GIVEN_STATES, &t, R(revolutions / 10), (long)(revolutions * .6), y,
                        work) == 0);
        norm = sqrt((double)(y[3] * y[3] + y[4] * y[4] + y[5] * y[5] + y[6] * y[6]));
        if (fabs(norm - 1) > worst) worst = fabs(norm - 1);
    }
    check_error("1e6 revolutions", "|q| - 1", "abs", worst, 1e-4, 0, 0);
    check_error("1e6 revolutions", "H", "eps", apart(vmi_get3(y + VM_Y_H), h) / size_of(h) / eps, 1, 0, 0);
    check_error("1e6 revolutions", "v", "abs", apart(vmi_get3(y + VM_Y_P), vmi_scale(b.mass, b.v)),
                PICK(1e-9, 1e-3), 0, 0);
}

/* 1e4 revolutions at a tolerance: energy and the angle between axis and angular momentum stay */
static void test_precession(void)
{
    vm_flow flow = {0};
    vm_body b = case_e1();
    static vm_real work[RK87_WORK(VM_FLOW_GIVEN_STATES)];
    vm_real y[VM_FLOW_STATES];
    rk45_options o = rk45_defaults(NULL);
    rk45 s;
    double energy, cosine, tolerance = PICK(1e-10, 1e-5), revolutions = PICK(1e4, 1e2);
    vmi_mat3 turn;
    b.inertia = tensor(2, 2, 1, 0, 0, 0);
    b.omega = vector(.6, 0, 2 * (double)VM_PI);
    o.rtol = R(tolerance);
    CHECK(!vm_flow_start(&flow, &b, y));
    energy = (double)vm_kinetic_energy(&b);
    cosine = (double)(y[VM_Y_H + 2]);
    CHECK((is_float ? rk45_init : rk87_init)(&s, vm_flow_given_rhs, &flow, VM_FLOW_GIVEN_STATES, 0, y, &o, work) >= 0);
    CHECK((is_float ? rk45_solve : rk87_solve)(&s, R(revolutions)) >= 0 &&
          !vm_flow_body(&flow, VM_FLOW_GIVEN_STATES, s.y, &b));
    turn = vmi_rotation(b.q);
    check_error("precession", "T", "tol",
                fabs((double)vm_kinetic_energy(&b) / energy - 1) / tolerance / revolutions, 1, 0, 0);
    check_error("precession", "H along the axis", "tol",
                fabs((double)vmi_dot(turn.z, vmi_get3(s.y + VM_Y_H)) / cosine - 1) / tolerance / revolutions, 1, 0,
                0);
}

/* The order of rk4 on an attitude: the length's control leaves it four */
static void test_order(void)
{
    vm_flow flow = {0};
    vm_body b = case_e1();
    vm_real y[3][VM_FLOW_STATES], work[RK4_WORK(VM_FLOW_STATES)];
    double error[3];
    int i;
    for (i = 0; i < 3; i++) {
        vm_real t = 0;
        CHECK(!vm_flow_start(&flow, &b, y[i]));
        if (i == 2) CHECK(solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y[2], 0, 4) >= 0);
        else CHECK(!rk4_solve(vm_flow_rhs, &flow, VM_FLOW_STATES, &t, 4, PICK(40L, 8L) << i, y[i], work));
    }
    for (i = 0; i < 2; i++) {
        vmi_mat3 m = vmi_rotation(vmi_get_quat(y[i] + VM_Y_Q)),
                 exact = vmi_rotation(vmi_get_quat(y[2] + VM_Y_Q));
        error[i] = apart(m.x, exact.x) + apart(m.y, exact.y) + apart(m.z, exact.z);
    }
    check_error("order of attitude", "rk4", "1", fabs(log2(error[0] / error[1]) - 4), PICK(.15, .6), 0, 0);
}

/* Rates that switch: an event each, no smearing. The thrust ends at a speed and starts again at a height. */
static vm_real below_speed(vm_real t, const vm_real *y, void *flow)
{
    (void)t;
    (void)flow;
    return y[VM_Y_P] - 2 * y[VM_Y_MASS];
}
static vm_real below_place(vm_real t, const vm_real *y, void *flow)
{
    (void)t;
    (void)flow;
    return y[VM_Y_R] - 10;
}
static void thrust_off(vm_real t, vm_real *y, void *flow)
{
    (void)t;
    (void)y;
    ((vm_flow *)flow)->streams[0].rate = 0;
}
static void thrust_on(vm_real t, vm_real *y, void *flow)
{
    (void)t;
    (void)y;
    ((vm_flow *)flow)->streams[0].rate = R(-.25);
}

static void test_switching(void)
{
    vm_flow flow = {0};
    vm_stream s;
    vm_body b = case_e1();
    vm_real y[VM_FLOW_STATES];
    ode_event events[2];
    double t1, x1, t2, mass, v;
    memset(&s, 0, sizeof s);
    memset(events, 0, sizeof events);
    b.v = vector(0, 0, 0);
    b.omega = vector(0, 0, 0);
    s.rate = R(-.5);
    s.velocity = vector(-8, 0, 0);
    flow.n = 1;
    flow.streams = &s;
    events[0].g = below_speed;
    events[0].change = thrust_off;
    events[1].g = below_place;
    events[1].change = thrust_on;
    events[0].ctx = events[1].ctx = &flow;
    events[0].action = events[1].action = ODE_RESTART;
    events[0].direction = events[1].direction = 1;
    CHECK(!vm_flow_start(&flow, &b, y));
    CHECK(solve_events(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 9, events, 2, NULL) >= 0);
    /* M = 6 exp(-v/8); x by Tsiolkovsky; on at x = 10 with v = 2 */
    mass = 6 * exp(-.25);
    t1 = (6 - mass) / .5;
    x1 = 8 * (t1 - mass / .5 * .25); /* integral of 8 ln(M0/M) */
    t2 = t1 + (10 - x1) / 2;
    v = 2 + 8 * log(mass / (mass - .25 * (9 - t2)));
    check_error("switched by events", "times", "abs",
                fabs((double)events[0].t - t1) + fabs((double)events[1].t - t2), PICK(1e-11, 1e-4), 0, 0);
    check_error("switched by events", "v", "abs", fabs((double)(y[VM_Y_P] / y[VM_Y_MASS]) - v), PICK(1e-11, 1e-4),
                0, 0);
    CHECK(events[0].count == 1 && events[1].count == 1);
}

static int stopping(vm_real t, const vm_real *y, vm_flow *flow)
{
    (void)t;
    (void)y;
    (void)flow;
    return 7;
}

static void test_bad_input(void)
{
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    scene k, good;
    vm_real y[VM_FLOW_STATES], dy[VM_FLOW_STATES], kept[VM_FLOW_STATES];
    vm_reactive loads, loads_kept;
    vm_vec3 a, c;
    vm_body b;
    size_t i;
    scene_init(&good);
    memset(&loads_kept, 0, sizeof loads_kept);
    CHECK(!vm_flow_start(&good.flow, &good.body, kept) &&
          !vm_reactive_loads(&good.body, vector(0, 0, 0), 4, good.streams, &loads_kept));
    memcpy(y, kept, sizeof y);
    loads = loads_kept;
#define REFUSED(expected)                                                                   \
    (k.flow.streams = k.streams,                                                            \
     vm_flow_start(&k.flow, &k.body, y) == (expected) && !memcmp(y, kept, sizeof y) &&      \
         vm_reactive_loads(&k.body, vector(0, 0, 0), 4, k.streams, &loads) == (expected) && \
         !memcmp(&loads, &loads_kept, sizeof loads))
    for (i = 0; i < 3; i++) {
        k = good;
        k.streams[2].rate = R(bad[i]);
        CHECK(REFUSED(VM_NOT_FINITE));
        k = good;
        k.streams[1].velocity.y = R(bad[i]);
        CHECK(REFUSED(VM_NOT_FINITE));
        k = good;
        k.streams[3].gyration.xy = R(bad[i]);
        CHECK(REFUSED(VM_NOT_FINITE));
        k = good;
        k.body.mass = R(bad[i]);
        CHECK(REFUSED(VM_NOT_FINITE));
        k = good;
        k.body.inertia.yz = R(bad[i]);
        CHECK(REFUSED(VM_NOT_FINITE));
    }
    k = good;
    k.body.mass = -1;
    CHECK(REFUSED(VM_BAD_MASS));
    k = good;
    k.body.mass = 0;
    CHECK(REFUSED(VM_BAD_MASS));
    k = good;
    k.body.inertia.xx = -1;
    CHECK(REFUSED(VM_BAD_INERTIA));
    k = good;
    k.streams[0].motion = 4;
    CHECK(REFUSED(VM_BAD_ARGUMENT));
    k = good;
    k.body.inertia = tensor(1, 1, 0, 0, 0, 0); /* a rod */
    k.flow.streams = k.streams;
    CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_BAD_INERTIA);
    CHECK(vm_accelerations(&k.body, &loads, vector(0, 0, 0), vector(0, 0, 0), &a, &c) == VM_BAD_INERTIA);
    CHECK(vm_flow_start(NULL, &k.body, y) == VM_BAD_ARGUMENT && vm_flow_start(&k.flow, NULL, y) == VM_BAD_ARGUMENT);
    CHECK(vm_flow_start(&k.flow, &k.body, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_flow_body(NULL, VM_FLOW_STATES, y, &b) == VM_BAD_ARGUMENT &&
          vm_flow_body(&k.flow, 12, y, &b) == VM_BAD_ARGUMENT);
    k = good;
    k.flow.streams = k.streams;
    k.flow.n = -1;
    CHECK(vm_flow_start(&k.flow, &k.body, y) == VM_BAD_ARGUMENT);
    y[VM_Y_MASS] = -1;
    k.flow.n = 0;
    b = k.body;
    CHECK(vm_flow_body(&k.flow, VM_FLOW_STATES, y, &b) == VM_BAD_MASS && !memcmp(&b, &k.body, sizeof b));
    CHECK(vm_flow_rhs(0, y, dy, &k.flow) == 0 && dy[0] != dy[0] && k.flow.status == VM_BAD_MASS);
    y[VM_Y_MASS] = 1;
    y[VM_Y_INERTIA + 1] = 0;
    k.flow.status = VM_OK;
    CHECK(vm_flow_rhs(0, y, dy, &k.flow) == 0 && dy[0] != dy[0] && k.flow.status == VM_BAD_INERTIA);
    /* an unknown motion and the caller's own refusal stop a run, at the state it had */
    memcpy(y, kept, sizeof y);
    k = good;
    k.flow.streams = k.streams;
    k.streams[1].motion = -1;
    CHECK(solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 1) == ODE_RHS_STOPPED && !memcmp(y, kept, sizeof y));
    k = good;
    k.flow.streams = k.streams;
    k.flow.update = stopping;
    CHECK(solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 1) == ODE_RHS_STOPPED && !memcmp(y, kept, sizeof y));
    /* a rate that becomes infinite */
    k = good;
    k.flow.streams = k.streams;
    k.streams[1].rate = R(INFINITY);
    k.flow.update = NULL;
    CHECK(solve(vm_flow_rhs, &k.flow, VM_FLOW_STATES, y, 0, 1) == ODE_NOT_FINITE && !memcmp(y, kept, sizeof y));
    {
        vm_jet jet = {-1, 1, 1, R(.5), R(.5), R(.5), 1};
        vm_stream1 s = {-1, 0, VM_AT_REST};
        vm_real x = 3, v = 4;
        a = vector(1, 2, 3);
        c = a;
        CHECK(vm_jet_damping(3, &jet, a, &c) == VM_BAD_INERTIA && (double)c.x == 1);
        CHECK(vm_jet_damping(R(NAN), &jet, a, &c) == VM_NOT_FINITE && (double)c.x == 1);
        CHECK(vm_linear_flow(2, 0, 0, 1, 0, &s, &x, &v) == VM_BAD_MASS && x == 3 && v == 4);
        CHECK(vm_linear_flow(R(INFINITY), 0, 0, 1, 0, &s, &x, &v) == VM_NOT_FINITE && x == 3 && v == 4);
        CHECK(vm_linear_flow(1, 0, 0, 1, 0, NULL, &x, &v) == VM_BAD_ARGUMENT && x == 3 && v == 4);
        CHECK(vm_linear_flow(1, 0, 0, R(INFINITY), 0, &s, &x, &v) == VM_NOT_FINITE && x == 3 && v == 4);
        CHECK(vm_linear_flow(4, 0, 0, 8, VM_MAX, &s, &x, &v) == VM_NOT_FINITE && x == 3 && v == 4);
        CHECK(!vm_linear_flow(R(.5), VM_MAX, -VM_MAX, 1, VM_MAX, &s, &x, &v) && x < VM_MAX);
        jet.nozzle = 30;
        CHECK(vm_jet_damping(R(-1.9), &jet, a, &c) == VM_NOT_FINITE && (double)c.x == 1); /* grows too large */
        jet.nozzle = 1;
        jet.transverse = R(INFINITY);
        CHECK(vm_jet_damping(1, &jet, a, &c) == VM_NOT_FINITE && (double)c.x == 1);
        CHECK(isnan(vm_velocity_by_momentum(0, 1, 2, R(INFINITY), 0)) && isnan(vm_tsiolkovsky(R(INFINITY), 2, 1, 1)));
    }
}

/* What overflows is not delivered */
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
    b.inertia.zz = R(.5);
    b.inertia.xx = b.inertia.yy = R(.4);
    b.inertia.xy = b.inertia.xz = b.inertia.yz = 0;
    CHECK(vm_accelerations(&b, &loads, dv, dv, &dv, &domega) == VM_NOT_FINITE && dv.x == 1 && domega.x == 1);
}

/* A stream without a known motion stops every run */
static void test_unknown_motion(void)
{
    vm_stream s = case_e1_stream();
    vm_stream1 s1 = {1, 1, 4};
    vm_stream2 s2 = {1, -1, 0, 0, 0, 0, 0, 0};
    vm_flow flow;
    vm_flow1 flow1 = {1, NULL, 0, NULL, NULL, 0};
    vm_flow2 flow2 = {1, NULL, 0, 0, 0, NULL, NULL, 0};
    vm_real y[VM_FLOW2_STATES] = {0, 1, 1, 1, 1, 1, 1, 0, 0, 1};
    memset(&flow, 0, sizeof flow);
    s.motion = 4;
    flow.n = 1;
    flow.streams = &s;
    flow1.streams = &s1;
    flow2.streams = &s2;
    CHECK(solve(vm_translation_rhs, &flow, VM_TRANSLATION_STATES, y, 0, 1) == ODE_RHS_STOPPED);
    CHECK(solve(vm_flow1_rhs, &flow1, VM_FLOW1_STATES, y, 0, 1) == ODE_RHS_STOPPED);
    CHECK(solve(vm_flow2_rhs, &flow2, VM_FLOW2_STATES, y, 0, 1) == ODE_RHS_STOPPED);
    CHECK(flow.status == VM_BAD_ARGUMENT && flow1.status == VM_BAD_ARGUMENT && flow2.status == VM_BAD_ARGUMENT);
}

/* The shorter right-hand sides refuse by NaN: no step is taken, the state stays, and of a mass flow.status tells */
static void test_bad_states(void)
{
    vm_flow flow = {0};
    vm_flow1 flow1 = {0};
    vm_flow2 flow2 = {0};
    vm_stream s;
    vm_stream1 s1 = {1, 1, VM_RELATIVE};
    vm_stream2 s2 = {1, VM_RELATIVE, 0, 0, 0, 0, 0, 0};
    const ode_rhs rhs[] = {vm_flow1_rhs, vm_translation_rhs, vm_flow2_rhs, vm_flow_given_rhs, vm_flow_carried_rhs};
    const int n[] = {VM_FLOW1_STATES, VM_TRANSLATION_STATES, VM_FLOW2_STATES, VM_FLOW_GIVEN_STATES, VM_FLOW_GIVEN_STATES}, mass[] = {2, 6, 6, -1, -1};
    void *ctx[5];
    int i, k;
    memset(&s, 0, sizeof s);
    ctx[0] = &flow1;
    ctx[1] = ctx[3] = ctx[4] = &flow;
    ctx[2] = &flow2;
    flow.n = flow1.n = flow2.n = 1;
    flow.streams = &s;
    flow1.streams = &s1;
    flow2.streams = &s2;
    flow.inertia = tensor(1, 1, 1, 0, 0, 0);
    for (i = 0; i < 5; i++) {
        static const double bad[] = {-1, 0, (double)NAN, (double)INFINITY};
        for (k = 0; k < 4; k++) {
            vm_real y[VM_FLOW_STATES], kept[VM_FLOW_STATES];
            int j, status, *told = i == 0 ? &flow1.status : i == 2 ? &flow2.status : &flow.status;
            for (j = 0; j < VM_FLOW_STATES; j++) y[j] = kept[j] = 1;
            *told = VM_OK;
            flow.mass = 1;
            s.rate = s1.rate = s2.rate = 1;
            if (k == 3) s.rate = s1.rate = s2.rate = R(bad[k]);
            else if (mass[i] >= 0) y[mass[i]] = kept[mass[i]] = R(bad[k]);
            else flow.mass = R(bad[k]);
            if (k == 3 && i == 4) continue; /* does not look at streams */
            status = solve(rhs[i], ctx[i], n[i], y, 0, 1);
            CHECK(status < 0 && !memcmp(y, kept, sizeof(vm_real) * (size_t)n[i]));
            CHECK(k >= 2 || *told == VM_BAD_MASS);
        }
    }
    {
        vm_real y[VM_FLOW2_STATES] = {0, 0, 0, 0, 0, 1, 1, 0, 0, -1}, dy[VM_FLOW2_STATES], z[VM_FLOW_GIVEN_STATES] = {1}, dz[VM_FLOW_GIVEN_STATES];
        CHECK(vm_flow2_rhs(0, y, dy, &flow2) == 0 && dy[0] != dy[0] && flow2.status == VM_BAD_INERTIA);
        flow.mass = 1;
        flow.inertia = tensor(1, 1, 0, 0, 0, 0);
        flow.status = VM_OK;
        CHECK(vm_flow_carried_rhs(0, z, dz, &flow) == 0 && dz[0] != dz[0] && flow.status == VM_BAD_INERTIA);
    }
}

/* ---- Chapter 6 ---- */

/* The rod that loses its tip: mass a law of time; (247) with the stream at the tip */
enum { ROD_DENSITY = 3 };
static const double gravity = 9.8125;
static double rod_length(double t) { return 2 - t / 4; }
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
static int rod_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                      void *ctx)
{
    const double l = rod_length((double)t), s = sin((double)q[0]), c = cos((double)q[0]);
    const double rate = -ROD_DENSITY / 4.;
    const vm_vec3 tip = vector(l * c, l * s, 0), middle = vmi_scale(R(.5), tip); /* dr/dphi */
    const vm_vec3 u = vmi_scale(rates[0], tip);
    (void)ctx;
    vm_lagrange_add_force(1, vector(0, -gravity * (double)masses[0], 0), &middle, vector(0, 0, 0), NULL, Q);
    vm_lagrange_add_force(1, vmi_scale(R(rate), u), &tip, vector(0, 0, 0), NULL, Q);
    return 0;
}

static void test_pendulum(void)
{
    static const double table[][3] = {
#include "data/streams_pendulum.h"
    };
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 2)], y[2], q = 1, rate = R(.5);
    vm_lagrange_system l = {1, 2, rod_masses, rod_energy, rod_forces, NULL, NULL, NULL};
    size_t i;
    l.work = work;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        q = 1;
        rate = R(.5);
        CHECK(vm_lagrange_start(&l, 0, &q, &rate, y) == VM_OK);
        CHECK(solve(vm_lagrange_rhs, &l, 2, y, 0, table[i][0]) >= 0);
        CHECK(vm_lagrange_rates(&l, R(table[i][0]), y, &rate) == VM_OK);
        check_error("(247) phi", "rod pendulum", "abs", fabs((double)y[0] - table[i][1]), PICK(1e-11, 1e-4),
                    table[i][0], 0);
        check_error("(247) phi'", "rod pendulum", "abs", fabs((double)rate - table[i][2]), PICK(1e-11, 4e-4),
                    table[i][0], 0);
    }
}

/* The drum on a rigid shaft, J = J0 + j phi: its mass depends on q. phi'(phi) is known (196) */
static const double J0 = 1, j_drum = .2, e_drum = .3, omega_b = 3;
static void drum_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)t;
    (void)ctx;
    masses[0] = R(J0) + R(j_drum) * q[0];
}
static vm_real drum_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)q;
    (void)ctx;
    return masses[0] * rates[0] * rates[0] / 2;
}
static vm_real naive_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)masses;
    (void)ctx;
    return (R(J0) + R(j_drum) * q[0]) * rates[0] * rates[0] / 2;
}
static int drum_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                       void *ctx)
{
    (void)t;
    (void)q;
    (void)masses;
    (void)ctx;
    Q[0] += R(e_drum) * rates[0]; /* (mu v R - D) phi': the band's mu phi' u dr2/dphi with damping */
    return 0;
}

static void test_drum(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 1)], y[2], q = 0, rate = R(omega_b), rates[2];
    vm_lagrange_system l = {1, 1, drum_masses, drum_energy, drum_forces, NULL, NULL, NULL};
    l.work = work;
    CHECK(!vm_lagrange_start(&l, 0, &q, &rate, y) && solve(vm_lagrange_rhs, &l, 2, y, 0, .5) >= 0);
    CHECK(!vm_lagrange_rates(&l, R(.5), y, &rate));
    check_error("(247) phi", "drum F3", "abs", fabs((double)y[0] - 1.409155091619267196387), PICK(1e-12, 1e-5), 0,
                0);
    check_error("(247) phi'", "drum F3", "abs", fabs((double)rate - 2.670201047218710981616), PICK(1e-12, 1e-5), 0,
                0);
    rates[0] = R(2.5);
    q = R(.75);
    check_error("frozen dT/dq", "drum", "abs", fabs((double)vm_lagrange_partial_q(&l, 0, &q, rates, 0)), 0, 0, 0);
    l.energy = naive_energy; /* (247) as it may be read: off by j phi'^2/2 */
    check_error("naive dT/dq", "drum", "abs",
                fabs((double)vm_lagrange_partial_q(&l, 0, &q, rates, 0) - .2 * 6.25 / 2), PICK(1e-12, 1e-5), 0, 0);
    q = 0;
    rate = R(omega_b);
    CHECK(!vm_lagrange_start(&l, 0, &q, &rate, y) && solve(vm_lagrange_rhs, &l, 2, y, 0, .5) >= 0);
    ERRATUM("(244)-(247)", fabs((double)y[0] - 1.409155091619267196387) > .05,
            check_holds("(247) phi") && check_holds("(247) phi'"));
}

/* Six coordinates, the place of the mass centre and Euler's angles, of the draining tank: the same as by vm_flow_rhs. Here
   r' is v + drift; T wants v, the drift being a law of time and q */
typedef struct lagrange_tank {
    tank k;
    vm_inertia inertia;
    vm_vec3 d, v, omega;
    double mass;
} lagrange_tank;

static void tank_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    lagrange_tank *l = (lagrange_tank *)ctx;
    vm_flow *flow = &l->k.flow;
    (void)q;
    flow->ctx = &l->k;
    tank_law(t, NULL, flow);
    masses[0] = flow->mass;
    vmi_set_inertia(masses + 1, &flow->inertia);
}

/* v and omega in body axes of q, q' */
static void tank_motion(vm_real t, const vm_real *q, const vm_real *rates, lagrange_tank *l, vm_vec3 *v,
                        vm_vec3 *omega)
{
    const vmi_mat3 turn = vmi_rotation(vm_euler_313(q[3], q[4], q[5]));
    const double contents = l->k.contents - .5 * (double)t, mass = l->k.empty + contents;
    const vm_vec3 drift = vmi_scale(R(-.5 * l->k.empty / mass / mass), l->k.stream.at);
    vm_vec3 axis[3];
    vm_euler_313_body_axes(q[4], q[5], axis);
    *omega = vmi_add(vmi_scale(rates[3], axis[0]),
                     vmi_add(vmi_scale(rates[4], axis[1]), vmi_scale(rates[5], axis[2])));
    *v = vmi_sub(vmi_get3(rates), vmi_times(&turn, drift));
}

static vm_real tank_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_inertia inertia = vmi_get_inertia(masses + 1);
    vm_vec3 v, omega;
    tank_motion(t, q, rates, (lagrange_tank *)ctx, &v, &omega);
    return (masses[0] * vmi_dot(v, v) + vmi_dot(omega, vmi_inertia_times(&inertia, omega))) / 2;
}

static int tank_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                       void *ctx)
{
    lagrange_tank *l = (lagrange_tank *)ctx;
    const vm_stream *s = &l->k.stream;
    const vmi_mat3 turn = vmi_rotation(vm_euler_313(q[3], q[4], q[5]));
    const vm_inertia own = vmi_stream_own(s->rate, &s->gyration);
    const double contents = l->k.contents - .5 * (double)t, mass = l->k.empty + contents;
    const vm_vec3 d = vmi_scale(R(l->k.empty / mass), s->at);
    vm_vec3 v, omega, u, dr[6], domega[6], axis[3];
    int i;
    (void)masses;
    tank_motion(t, q, rates, l, &v, &omega);
    u = vmi_add(v, vmi_times(&turn, vmi_add(s->velocity, vmi_cross(omega, d))));
    vm_euler_313_axes(q[3], q[4], axis);
    for (i = 0; i < 6; i++) {
        dr[i] = i < 3 ? vector(i == 0, i == 1, i == 2) : vmi_cross(axis[i - 3], vmi_times(&turn, d));
        domega[i] = i < 3 ? vector(0, 0, 0) : axis[i - 3];
    }
    vm_lagrange_add_force(6, vmi_scale(s->rate, u), dr, vmi_times(&turn, vmi_inertia_times(&own, vmi_add(omega, s->spin))),
                 domega, Q);
    return 0;
}

static void test_euler_tank(void)
{
    lagrange_tank l;
    vm_real work[VM_LAGRANGE_RHS_WORK(6, 7)], y[12], q[6] = {0, 0, 0, R(.4), R(1.1), R(-.3)}, rates[6], z[VM_FLOW_STATES];
    vm_lagrange_system equations = {6, 7, tank_masses, tank_energy, tank_forces, NULL, NULL, NULL};
    vm_body b;
    vmi_mat3 turn, other;
    vm_vec3 drift;
    int i;
    memset(&l, 0, sizeof l);
    tank_init(&l.k);
    equations.ctx = &l;
    equations.work = work;
    l.k.body.q = vm_euler_313(q[3], q[4], q[5]);
    CHECK(!vm_flow_start(&l.k.flow, &l.k.body, z) && solve(vm_flow_rhs, &l.k.flow, VM_FLOW_STATES, z, 0, 1) >= 0);
    CHECK(!vm_flow_body(&l.k.flow, VM_FLOW_STATES, z, &b));
    turn = vmi_rotation(l.k.body.q);
    drift = vmi_times(&turn, vmi_scale(R(-.5 * 4 / 36), l.k.stream.at));
    vmi_set3(rates, vmi_add(l.k.body.v, drift));
    CHECK(!vm_euler_313_rates(q[3], q[4], l.k.body.omega, rates + 3));
    CHECK(!vm_lagrange_start(&equations, 0, q, rates, y));
    CHECK(solve(vm_lagrange_rhs, &equations, 12, y, 0, 1) >= 0);
    turn = vmi_rotation(vm_euler_313(y[3], y[4], y[5]));
    other = vmi_rotation(b.q);
    check_error("(247) = vm_flow_rhs", "place", "abs", apart(vmi_get3(y), b.r), PICK(1e-11, 1e-3), 0, 0);
    check_error("(247) = vm_flow_rhs", "attitude", "abs", apart(turn.x, other.x) + apart(turn.y, other.y),
                PICK(1e-11, 1e-3), 0, 0);
    CHECK(!vm_lagrange_rates(&equations, 1, y, rates));
    {
        vm_vec3 axis[3], omega = vector(0, 0, 0);
        vm_euler_313_axes(y[3], y[4], axis);
        for (i = 0; i < 3; i++) omega = vmi_add(omega, vmi_scale(rates[3 + i], axis[i]));
        check_error("(247) = vm_flow_rhs", "omega", "abs", apart(omega, b.omega), PICK(1e-11, 1e-3), 0, 0);
    }
}

/* Euler's angles: axes are the derivatives of the attitude; (237)-(242) fail in space by omega x w_i */
static void test_euler(void)
{
    int i, k;
    double largest = 0;
    for (i = 0; i < 300; i++) {
        const double q[3] = {uniform(-7, 7), uniform(.1, 3), uniform(-7, 7)};
        const vm_vec3 omega = random_vector(3);
        const vm_quat attitude = vm_euler_313(R(q[0]), R(q[1]), R(q[2]));
        vmi_mat3 turn = vmi_rotation(attitude);
        vm_vec3 axis[3], body_axis[3], back = vector(0, 0, 0), line = vector(cos(q[0]), sin(q[0]), 0);
        vm_real rates[3] = {0, 0, 0};
        vm_euler_313_axes(R(q[0]), R(q[1]), axis);
        vm_euler_313_body_axes(R(q[1]), R(q[2]), body_axis);
        CHECK(!vm_euler_313_rates(R(q[0]), R(q[1]), omega, rates));
        for (k = 0; k < 3; k++) {
            back = vmi_add(back, vmi_scale(rates[k], axis[k]));
            check_error("Euler 3-1-3", "body axes", "eps", apart(vmi_times(&turn, body_axis[k]), axis[k]) / eps, 8,
                        i, k);
        }
        check_error("Euler 3-1-3", "rates", "eps*", apart(back, omega) * sin(q[1]) / eps / size_of(omega), 8, i, 0);
        check_error("Euler 3-1-3", "z of the body", "eps", apart(turn.z, axis[2]) / eps, 8, i, 0);
        check_error("Euler 3-1-3", "x of the body", "eps",
                    apart(turn.x, vmi_add(vmi_scale(R(cos(q[2])), line),
                                          vmi_scale(R(sin(q[2])), vmi_cross(axis[2], line)))) /
                        eps,
                    8, i, 0);
        /* d/dt w_i - domega/dq_i = omega x w_i; (242) has 0. By hand: w = z, (c, s, 0), (S s, -S c, C) */
        {
            const double p = (double)rates[0], th = (double)rates[1], ph = (double)rates[2], s = sin(q[0]),
                         c = cos(q[0]);
            const double S = sin(q[1]), C = cos(q[1]);
            const vm_vec3 wdot[3] = {vector(0, 0, 0), vector(-s * p, c * p, 0),
                                     vector(C * s * th + S * c * p, -C * c * th + S * s * p, -S * th)};
            const vm_vec3 domega[3] = {vector(-s * th + S * c * ph, c * th + S * s * ph, 0),
                                       vector(C * s * ph, -C * c * ph, -S * ph), vector(0, 0, 0)};
            for (k = 0; k < 3; k++) {
                const vm_vec3 difference = vmi_sub(wdot[k], domega[k]);
                const double scale = (fabs(p) + fabs(th) + fabs(ph)) * eps;
                check_error("(242) + omega x w", "3-1-3", "eps*",
                            apart(difference, vmi_cross(omega, axis[k])) / scale, 8, i, k);
                if (size_of(difference) > largest) largest = size_of(difference);
            }
        }
    }
    ERRATUM("(237)-(242)", largest > 1.7, check_holds("(242) + omega x w"));
    {
        vm_real rates[3] = {1, 2, 3};
        CHECK(vm_euler_313_rates(1, 0, vector(1, 0, 0), rates) == VM_SINGULAR && rates[0] == 1);
        CHECK(vm_euler_313_rates(1, R(NAN), vector(1, 0, 0), rates) == VM_NOT_FINITE && rates[0] == 1);
        CHECK(vm_euler_313_rates(1, R(.1), vector((double)VM_MAX, 0, 0), rates) == VM_NOT_FINITE && rates[0] == 1);
        CHECK(vm_euler_313_rates(1, 1, vector(1, 0, 0), NULL) == VM_BAD_ARGUMENT);
    }
}

/* dT/dq to what the header says: a mass on an arm, T = m (1 + sin q)^2 q'^2/2 with m of q, which is frozen */
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
static void test_frozen_derivative(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(1, 1)], q, rate = R(1.5);
    vm_lagrange_system l = {1, 1, arm_masses, arm_energy, NULL, NULL, NULL, NULL};
    int i;
    l.work = work;
    for (i = -40; i <= 40; i++) {
        double x = (double)(q = R(i / 10.)), m = 2 + x * x;
        check_error("frozen dT/dq", "arm", "T",
                    fabs((double)vm_lagrange_partial_q(&l, 0, &q, &rate, 0) - m * (1 + sin(x)) * cos(x) * 2.25) /
                        (m * 4 * 1.125),
                    PICK(2e-13, 1e-5), x, 0);
    }
}

/* A bead on a line that moves at speed c, T = m (q' + c)^2/2 + m' q'^2 ... with unlike coordinates: A, b from T */
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
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 0)], y[4], q[2] = {1, 2}, rates[2] = {R(1.5), 300}, back[2];
    vm_lagrange_system l = {2, 0, NULL, moving_energy, NULL, NULL, NULL, NULL};
    const double v = 1.5 + .5 + 1e-3 * 300;
    l.work = work;
    CHECK(!vm_lagrange_start(&l, 0, q, rates, y) && !vm_lagrange_rates(&l, 0, y, back));
    check_error("pi = dT/dq'", "moving frame", "eps", fabs((double)y[2] / (2 * v) - 1) / eps, 8, 0, 0);
    /* differences over unit rates have the roundings of T at rest, 0.25, which the rate of 300 multiplies */
    check_error("pi = dT/dq'", "moving frame", "eps*",
                fabs((double)y[3] - (2e-3 * v + 2e-6 * 300)) / eps / (.25 * 300), 4, 0, 0);
    check_error("q' of pi", "moving frame", "eps*",
                (fabs((double)back[0] - 1.5) + 1e-3 * fabs((double)back[1] - 300)) / eps, 8, 0, 0);
}

static vm_real flat_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)q;
    (void)masses;
    (void)ctx;
    return rates[0] * rates[0] / 2; /* nothing for the second coordinate */
}

static void test_lagrange_refusals(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 0)], y[4] = {1, 2, 3, 4}, q[2] = {0, 0}, rates[2] = {1, 1};
    vm_lagrange_system l = {2, 0, NULL, flat_energy, NULL, NULL, NULL, NULL};
    CHECK(vm_lagrange_start(&l, 0, q, rates, y) == VM_BAD_ARGUMENT && y[0] == 1);
    l.work = work;
    CHECK(vm_lagrange_start(&l, 0, q, rates, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_rates(&l, 0, y, rates) < 0 && rates[0] == 1);
    CHECK(solve(vm_lagrange_rhs, &l, 4, y, 0, 1) == ODE_RHS_STOPPED && y[0] == 1);
    q[0] = R(NAN);
    CHECK(vm_lagrange_start(&l, 0, q, rates, y) == VM_NOT_FINITE && y[0] == 1);
    CHECK(vm_lagrange_partial_q(&l, 0, q, rates, 2) != vm_lagrange_partial_q(&l, 0, q, rates, 2));
}

/* A leaking point on an arm: its mass reaches 0 at t = 2, and no run goes on from there; and two coordinates that are
   one. Both were integrated on when a pivot had only to differ from 0. */
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
static vm_real one_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real v = rates[0] / 3 + rates[1] / 7;
    (void)t;
    (void)q;
    (void)masses;
    (void)ctx;
    return v * v / 2;
}
static void test_mass_matrices(void)
{
    vm_real work[VM_LAGRANGE_RHS_WORK(2, 1)], y[4] = {1, 2, 3, 4}, q = 1, rates[2] = {1, 1};
    vm_lagrange_system l = {1, 1, leaking_mass, leaking_energy, NULL, NULL, NULL, NULL};
    double stopped;
    l.work = work;
    CHECK(!vm_lagrange_start(&l, 0, &q, rates, y));
    y[1] = 0; /* at rest: q' = 0 on either side of t = 2 */
    CHECK(solve_events(vm_lagrange_rhs, &l, 2, y, 0, 3, NULL, 0, &stopped) == ODE_RHS_STOPPED && stopped <= 2);
    CHECK(vm_lagrange_rates(&l, 3, y, rates) == VM_SINGULAR && rates[0] == 1);
    l.n = 2;
    l.n_masses = 0;
    l.masses = NULL;
    l.energy = one_energy;
    CHECK(vm_lagrange_rates(&l, 0, y, rates) == VM_SINGULAR && rates[0] == 1);
}

int main(void)
{
    test_e1();
    test_components();
    test_e3();
    test_printed_tanks();
    test_one_dimension();
    test_closed_forms();
    test_balances();
    test_shed();
    test_balance_of_tolerance();
    test_small_jumps();
    test_jump_limit();
    test_mass_centre(0);
    test_mass_centre(1);
    test_translation();
    test_line();
    test_plane();
    test_plane_angles();
    test_carried();
    test_given();
    test_at_rest();
    test_jet_damping();
    test_running_out();
    test_least_inertia();
    test_cancelling();
    test_mass_ratios();
    test_order();
    test_revolutions();
    test_precession();
    test_switching();
    test_bad_input();
    test_overflow();
    test_unknown_motion();
    test_bad_states();
    test_pendulum();
    test_drum();
    test_euler_tank();
    test_euler();
    test_frozen_derivative();
    test_moving_frame();
    test_lagrange_refusals();
    test_mass_matrices();
    return check_finish("streams");
}
