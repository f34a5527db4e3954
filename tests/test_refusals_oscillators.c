/* What the functions of oscillators refuse: those of constant and of varying parameters, their laws and routes (7.2
   to 7.4). Numbers and pointers that are none, laws that fail, tables that are none, motions at the ends of the
   numbers. The outputs must stay as they were. */
#include "refusals.h"
#include "valid_objects.h"

static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

/* ---- Constant and slowly varying parameters: each number and each pointer spoiled ---- */

static int osc_energy(trial *a)
{
    const vm_real x = next(a), v = next(a), omega0 = next(a);
    return value(a, vm_osc_energy(x, v, omega0, next(a)));
}

static int osc_amplitude(trial *a)
{
    const vm_real x = next(a), v = next(a), omega0 = next(a);
    vm_real A, psi;
    vm_osc_amplitude_phase(x, v, omega0, next(a), &A, &psi);
    return psi == psi ? value(a, A) : -1;
}

static int osc_period(trial *a)
{
    const vm_real x0 = next(a), omega0 = next(a);
    return value(a, vm_osc_period(x0, omega0, next(a)));
}

static int law_quadratic(trial *a)
{
    const vm_real t = next(a), f0 = next(a), f1 = next(a);
    const vm_law law = vm_law_quadratic(f0, f1, next(a));
    return vm_law_at(POINTER(0, &law), t, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}

static int law_power(trial *a)
{
    const vm_real t = next(a), f0 = next(a), f1 = next(a);
    const vm_law law = vm_law_power(f0, f1, next(a));
    return vm_law_at(POINTER(0, &law), t, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}

static int law_exponential(trial *a)
{
    const vm_real t = next(a), f0 = next(a);
    const vm_law law = vm_law_exponential(f0, next(a));
    return vm_law_at(POINTER(0, &law), t, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}

static int law_integral(trial *a)
{
    const vm_real t = next(a), f0 = next(a), f1 = next(a);
    const vm_law law = vm_law_quadratic(f0, f1, next(a));
    return vm_law_inverse_integral(POINTER(0, &law), t, OUT(1, vm_real, 0));
}

/* From the trial: x, v, reactive, damping, alpha and both laws */
static vm_osc_problem osc_problem(trial *a)
{
    vm_osc_problem o;
    vm_real f0;
    memset(&o, 0, sizeof o);
    o.x = next(a);
    o.v = next(a);
    o.reactive = next(a);
    o.damping = next(a);
    o.alpha = next(a);
    f0 = next(a);
    o.mass = vm_law_linear(f0, next(a));
    f0 = next(a);
    o.stiffness = vm_law_linear(f0, next(a));
    return o;
}
#define PROBLEM R(0.1), R(0.2), 1, R(0.01), 3, 2, R(0.01), 3, R(0.02)

static int osc_plan(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    a->is_value = 1; /* a plan may hold infinite numbers */
    return vm_osc_plan_init(OUT(0, vm_osc_plan, 0), POINTER(1, &o));
}

static int osc_by(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    const vm_real t = next(a);
    return vm_osc_by_route(POINTER(0, &o), VM_ROUTE_ORDER5, t, next(a), OUT(1, vm_osc_motion, 0));
}

static int osc_at(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    const vm_real t = next(a);
    return vm_osc_within(POINTER(0, &o), t, next(a), OUT(1, vm_osc_motion, 0));
}

static vm_osc_problem a_problem(void)
{
    const vm_real numbers[9] = {PROBLEM};
    trial a;
    start_trial(&a, numbers, 9);
    return osc_problem(&a);
}

static int osc_averaged(trial *a)
{
    const vm_osc_problem o = a_problem();
    const vm_real t = next(a), A = next(a);
    vm_osc_plan p;
    if (vm_osc_plan_init(&p, &o)) return -1;
    return vm_osc_averaged(POINTER(0, &p), VM_ROUTE_TRIG, t, A, OUT(1, vm_real, 0), OUT(2, vm_real, 1),
                           OUT(3, vm_real, 2));
}

static void test_oscillators(void)
{
    REFUSES(osc_energy, 0, R(0.1), R(0.2), 2, 3);
    REFUSES(osc_amplitude, 0, R(0.1), R(0.2), 2, 3);
    REFUSES(osc_period, 0, R(0.1), 2, 3);
    REFUSES(law_quadratic, 3, R(0.5), 3, R(0.1), R(0.01));
    REFUSES(law_power, 3, R(0.5), 3, R(0.1), 2);
    REFUSES(law_exponential, 3, R(0.5), 3, R(0.1));
    REFUSES(law_integral, 2, R(0.5), 3, R(0.1), R(0.01));
    REFUSES(osc_plan, 2, PROBLEM);
    REFUSES_SPOILED(osc_by, 2, PROBLEM, R(0.3), R(0.01));
    REFUSES_SPOILED(osc_at, 2, PROBLEM, R(0.3), R(0.1));
    REFUSES(osc_averaged, 4, R(0.3), R(0.1));
}

/* ---- Odd elastic forces and closed laws: each number and each pointer spoiled ---- */

static int closed(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    const vm_real t_end = next(a), t = next(a);
    static vm_osc_closed c;
    int status = vm_osc_closed_init(POINTER(0, &c), POINTER(1, &o), 5, t_end);
    if (!status) status = vm_osc_closed_at(&c, t, OUT(2, vm_real, 0), OUT(3, vm_real, 1));
    return status;
}

/* The motion by a route, or the cheapest one for route 0, from a plan of the problem */
static int planned(trial *a, int route)
{
    const vm_osc_problem o = osc_problem(a);
    const vm_real t = next(a), tolerance = next(a);
    static vm_osc_plan plan;
    const int status = vm_osc_plan_init(&plan, &o);
    if (status) return status;
    if (route == 0) return vm_osc_plan_within(POINTER(0, &plan), t, tolerance, OUT(1, vm_osc_motion, 0));
    return vm_osc_plan_by_route(POINTER(0, &plan), route, t, tolerance, OUT(1, vm_osc_motion, 0));
}

static int planned_within(trial *a) { return planned(a, 0); }
static int planned_mean(trial *a) { return planned(a, VM_ROUTE_ATEB); }
static int planned_collocation(trial *a) { return planned(a, VM_ROUTE_COLLOCATION); }

static int duffing_period(trial *a)
{
    const vm_real x0 = next(a), c1 = next(a);
    return value(a, vm_duffing_period(x0, c1, next(a)));
}

static int duffing_action(trial *a)
{
    const vm_real x0 = next(a), c1 = next(a);
    return value(a, vm_duffing_action(x0, c1, next(a)));
}

static int duffing_exact(trial *a)
{
    const vm_real t = next(a), x0 = next(a), v0 = next(a), c1 = next(a);
    vm_real x = 0, v = 0;
    vm_duffing_exact_from(t, x0, v0, c1, next(a), POINTER(0, &x), POINTER(1, &v));
    if (x == 0 && v == 0) return -1; /* nothing written */
    CHECK((x == x) == (v == v));
    return value(a, x);
}

/* The force of a Duffing oscillator, without its closed forms */
static int rising(vm_real x, vm_real *F, void *ctx)
{
    const vm_real *k = (const vm_real *)ctx;
    *F = k[0] * x + k[1] * x * x * x;
    return 0;
}

static int odd_exact(trial *a)
{
    vm_real k[2], t, x0;
    vm_odd_force force;
    take(a, k, sizeof k);
    force = vm_odd_force_user(rising, k);
    t = next(a);
    x0 = next(a);
    return vm_odd_exact_from(POINTER(0, &force), t, x0, next(a), OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}

static int odd_action(trial *a)
{
    vm_real k[2];
    vm_odd_force force;
    take(a, k, sizeof k);
    force = vm_odd_force_user(rising, k);
    return value(a, vm_odd_action(POINTER(0, &force), next(a)));
}

/* From the trial: k1, k3, reactive, x, v and the laws */
static vm_odd_problem odd_problem(trial *a)
{
    vm_odd_problem o;
    vm_real f0 = next(a);
    o.force = vm_duffing_force(f0, next(a));
    o.reactive = next(a);
    o.x = next(a);
    o.v = next(a);
    f0 = next(a);
    o.mass = vm_law_linear(f0, next(a));
    f0 = next(a);
    o.stiffness = vm_law_linear(f0, next(a));
    f0 = next(a);
    o.damping = vm_law_linear(f0, next(a));
    return o;
}
#define ODD 2, 3, 1, R(0.1), R(0.2), 2, R(0.01), 1, R(0.01), R(0.01), R(0.001)

static int odd_rhs(trial *a)
{
    vm_odd_problem o = odd_problem(a);
    vm_real y[2]; /* instead of the problem's x and v, which do not matter here */
    y[0] = o.x;
    y[1] = o.v;
    return vm_odd_rhs(next(a), POINTER(0, y), OUT(1, vm_real, 0), POINTER(2, &o));
}

static int odd_within(trial *a)
{
    const vm_odd_problem o = odd_problem(a);
    const vm_real t = next(a);
    vm_odd_motion *motion = OUT(1, vm_odd_motion, 0);
    const int status = vm_odd_within(POINTER(0, &o), t, next(a), motion);
    if (status >= 0) motion->amplitude = 0; /* it is NaN if there is none */
    return status;
}

static void test_odd_forces(void)
{
    REFUSES(closed, 4, R(0.1), R(0.2), 1, 0, 3, 2, R(0.01), 3, 0, 1, R(0.5));
    REFUSES_SPOILED(planned_within, 2, PROBLEM, 1, R(0.01));
    REFUSES_SPOILED(planned_mean, 2, PROBLEM, 1, R(0.01));
    REFUSES_SPOILED(planned_collocation, 2, PROBLEM, 1, R(0.01));
    REFUSES(duffing_period, 0, R(0.1), 2, 3);
    REFUSES(duffing_action, 0, R(0.1), 2, 3);
    REFUSES(duffing_exact, 2, R(0.3), R(0.1), R(0.2), 2, 3);
    REFUSES(odd_exact, 3, 2, 3, R(0.3), R(0.1), R(0.2));
    REFUSES(odd_action, 1, 2, 3, R(0.1));
    REFUSES(odd_rhs, 3, ODD, R(0.3));
    REFUSES_SPOILED(odd_within, 2, ODD, R(0.3), R(0.01));
}

static void test_averaged(void)
{
    const vm_osc_problem o = a_problem();
    vm_real A_rate, theta_rate, psi_rate;
    vm_osc_plan p;
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
    CHECK(vm_osc_averaged(&p, -1, 0, 1, &A_rate, &theta_rate, &psi_rate) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_ORDER2, 0, 1, &A_rate, &theta_rate, &psi_rate) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_TRIG, 0, -1, &A_rate, &theta_rate, &psi_rate) == VM_DOMAIN);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_TRIG, -1000, 1, &A_rate, &theta_rate, &psi_rate) == VM_BAD_MASS);
    p.has_ateb = 0; /* the wave is then computed without a plan */
    CHECK(vm_osc_averaged(&p, VM_ROUTE_ATEB, 0, 1, &A_rate, &theta_rate, &psi_rate) == VM_OK);
}

/* ---- Laws of mass and stiffness ---- */

/* A law that no constructor made; masses that are used up by then, or for a while on the way */
static void test_laws(void)
{
    vm_law law = vm_law_linear(1, 0);
    vm_real f, rate;
    law.derivatives = NULL;
    CHECK(vm_law_at(&law, 0, &f, &rate) == VM_BAD_ARGUMENT);
    CHECK(vm_law_inverse_integral(&law, 1, &f) == VM_BAD_ARGUMENT);
    law = vm_law_linear(1, -1);
    CHECK(vm_law_at(&law, 2, &f, &rate) == VM_OK && f == -1 && rate == -1); /* it may be the law of a force */
    CHECK(vm_law_inverse_integral(&law, 2, &f) == VM_BAD_MASS);
    law = vm_law_quadratic(1, -3, 2);
    CHECK(vm_law_inverse_integral(&law, 2, &f) == VM_BAD_MASS);
    CHECK(vm_law_inverse_integral(&law, R(0.25), &f) == VM_OK);
    law = vm_law_power(1, -1, R(0.5));
    CHECK(vm_law_at(&law, 2, &f, &rate) == VM_DOMAIN && vm_law_inverse_integral(&law, 2, &f) == VM_BAD_MASS);
    law = vm_law_user(NULL, NULL);
    CHECK(vm_law_at(&law, VM_NAN, &f, &rate) == VM_BAD_ARGUMENT);
    law = vm_law_quadratic(1, 0, VM_MAX);
    f = rate = 7;
    CHECK(vm_law_at(&law, 0, &f, &rate) == VM_NOT_FINITE && f == 7 && rate == 7);
}

/* Tables that are none: too short, null, out of order, with bad values; and times beyond their ends */
static void test_bad_tables(void)
{
    static const vm_real times[4] = {0, 1, 2, 3}, values[4] = {1, 2, 3, 4};
    static const vm_real falling[4] = {0, 2, 1, 3}, unknown[4] = {0, 2, VM_NAN, 3};
    static const vm_real negative[4] = {1, 2, -1, 4}, no_number[4] = {1, 2, VM_NAN, 4};
    static const struct {
        int n;
        const vm_real *times, *values;
        vm_real t_integral, t; /* to which the integral goes; at which the law is asked for */
        int status_at;         /* of the law there; VM_OK: only the integral is refused */
        int status_integral;
    } tables[] = {{1, times, values, 1, 1, VM_BAD_ARGUMENT, VM_BAD_ARGUMENT},
                  {4, NULL, values, 1, 1, VM_BAD_ARGUMENT, VM_BAD_ARGUMENT},
                  {4, times, NULL, 1, 1, VM_BAD_ARGUMENT, VM_BAD_ARGUMENT},
                  {4, falling, values, 1, 1, VM_OK, VM_DOMAIN},
                  {4, times, negative, 1, 1, VM_OK, VM_BAD_MASS},
                  {4, times, no_number, 1, 1, VM_OK, VM_NOT_FINITE},
                  {4, times, values, 4, -1, VM_DOMAIN, VM_DOMAIN},
                  {4, unknown, values, 1, 1, VM_OK, VM_NOT_FINITE}};
    size_t i;
    for (i = 0; i < sizeof tables / sizeof *tables; i++) {
        const vm_law law = vm_law_table(tables[i].n, tables[i].times, tables[i].values);
        vm_real f, rate;
        CHECK(vm_law_inverse_integral(&law, tables[i].t_integral, &f) == tables[i].status_integral);
        if (tables[i].status_at != VM_OK) CHECK(vm_law_at(&law, tables[i].t, &f, &rate) == tables[i].status_at);
    }
}

/* A law that is even in t */
static int even_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = 2 + t * t / 8;
    *rate = t / 4;
    return 0;
}

/* even_law() at -4, -3 ... 4 */
typedef struct even_table {
    vm_real times[9], values[9];
} even_table;

static vm_law even_points(even_table *e)
{
    vm_real rate;
    int i;
    for (i = 0; i < 9; i++) {
        e->times[i] = (vm_real)(i - 4);
        even_law(e->times[i], e->values + i, &rate, NULL);
    }
    return vm_law_table(9, e->times, e->values);
}

/* Two points are a straight line. Times and values that are no numbers are found at the end that nothing asks for,
 * too. */
static void test_tables(void)
{
    const vm_real steps[2] = {1, 3}, two[2] = {2, 6};
    vm_real f = 7, rate = 7;
    vm_law law = vm_law_table(2, steps, two);
    even_table e;
    CHECK(vm_law_at(&law, R(1.5), &f, &rate) == VM_OK && f == 3 && rate == 2);
    law = even_points(&e);
    e.times[8] = VM_INFINITY;
    f = 7;
    CHECK(vm_law_inverse_integral(&law, R(0.5), &f) == VM_NOT_FINITE && f == 7);
    law = even_points(&e);
    e.values[8] = VM_NAN;
    CHECK(vm_law_inverse_integral(&law, R(0.5), &f) == VM_NOT_FINITE && f == 7);
}

/* With an even law, time backward with v is time forward with -v. */
static void test_backward(void)
{
    vm_osc_motion forward, back;
    vm_osc_problem o;
    even_table e;
    int i;
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.reactive = 1;
    o.x = R(0.5);
    o.mass = even_points(&e);
    o.stiffness = vm_law_linear(30, 0);
    for (i = VM_ROUTE_TRIG; i <= VM_ROUTE_RK87; i++) {
        o.v = R(0.25);
        CHECK(vm_osc_by_route(&o, i, R(-3.5), 0, &back) >= 0);
        o.v = R(-0.25);
        CHECK(vm_osc_by_route(&o, i, R(3.5), 0, &forward) >= 0);
        check_error("backward", vm_osc_route_name(i), "eps", ERROR_EPS(back.x, (double)forward.x, 0, 1), 200, i, 0);
    }
}

/* A table of a straight line is that line: nothing jumps at its points. */
static void test_straight_table(void)
{
    vm_osc_motion by_line, by_table;
    vm_osc_problem o;
    even_table e;
    int i;
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.reactive = 1;
    o.x = R(0.5);
    o.v = R(-0.25);
    o.stiffness = vm_law_linear(30, 0);
    for (i = VM_ROUTE_ORDER2; i <= VM_ROUTE_ORDER5; i++) {
        int k;
        o.mass = vm_law_linear(3, R(0.25));
        CHECK(vm_osc_by_route(&o, i, 3, 0, &by_line) == VM_OK);
        o.mass = even_points(&e);
        for (k = 0; k < 9; k++) e.values[k] = 3 + e.times[k] / 4;
        CHECK(vm_osc_by_route(&o, i, 3, 0, &by_table) == VM_OK);
        check_error("table", "straight line", "", fabs((double)(by_table.x - by_line.x)), is_float ? 1e-4 : 1e-9, i, 0);
    }
}

/* ---- Laws that fail at one of their calls ---- */

static int calls, good_calls; /* of failing_law(): so far, and until it fails */

static int failing_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = 2 + t / 10;
    *rate = R(0.1);
    calls++;
    return calls > good_calls;
}

/* Each function says that the law failed, or did without that call. */
static void test_failing_law(void)
{
    vm_osc_problem o = a_problem();
    vm_osc_motion m;
    vm_law law;
    vm_real integral;
    int i, status;
    for (good_calls = 0; good_calls < 40; good_calls++) {
        law = vm_law_user(failing_law, NULL);
        calls = 0;
        CHECK(vm_law_inverse_integral(&law, 1, &integral) < 0 || good_calls >= calls);
        o.mass = law;
        for (i = VM_ROUTE_TRIG; i <= VM_ROUTE_RK87; i++) {
            calls = 0;
            status = vm_osc_by_route(&o, i, 1, 0, &m);
            if (calls > good_calls) CHECK(status < 0);
        }
        calls = 0;
        CHECK(vm_osc_within(&o, 1, 0, &m) < 0 || good_calls >= calls);
    }
}

static void test_failing_plan(void)
{
    vm_osc_problem o = a_problem();
    vm_osc_plan p;
    int status;
    o.mass = vm_law_user(failing_law, NULL);
    for (good_calls = 0; good_calls < 20; good_calls++) {
        p.A = 7;
        calls = 0;
        status = vm_osc_plan_init(&p, &o);
        if (status == VM_OK) CHECK(calls <= good_calls);
        else CHECK(calls > good_calls && p.A == 7);
    }
}

/* A linear drag; ctx is its coefficient */
static vm_real drag(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    (void)x;
    return -*(const vm_real *)ctx * v;
}

/* Mass and stiffness, one of which or both fail: by itself, beside a table, beside a straight line, with a force */
enum { BY_ITSELF, BESIDE_TABLE, BESIDE_LINE, WITH_FORCE, COMPANIES };

static vm_osc_problem failing_problem(int company, vm_real *coefficient)
{
    static const vm_real times[5] = {-1, 0, 1, 2, 3}, values[5] = {2, R(2.2), R(2.1), R(2.4), R(2.5)};
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.reactive = R(0.5);
    o.x = R(0.5);
    o.v = R(0.25);
    o.ctx = coefficient;
    o.mass = vm_law_user(failing_law, NULL);
    o.stiffness = vm_law_linear(3, R(0.1));
    if (company == BESIDE_TABLE) o.mass = vm_law_table(5, times, values);
    if (company == BESIDE_LINE) o.mass = vm_law_linear(2, R(0.1));
    if (company == BESIDE_TABLE || company == BESIDE_LINE) o.stiffness = vm_law_user(failing_law, NULL);
    if (company == WITH_FORCE) o.force = drag;
    return o;
}

/* One route: it fails if the law did, and has a motion if the law did not. */
static void check_failing_route(const vm_osc_problem *o, int route)
{
    vm_osc_motion m, untouched;
    int status;
    memset(&untouched, STAIN, sizeof untouched);
    m = untouched;
    calls = 0;
    status = vm_osc_by_route(o, route, R(2.5), R(1e-3), &m);
    CHECK(calls > good_calls ? status < 0 : status >= 0);
    if (status >= 0) CHECK(VM_IS_FINITE(m.x) && VM_IS_FINITE(m.v));
    else CHECK(memcmp(&m, &untouched, sizeof m) == 0);
}

static int is_law_of_order(int route) { return route >= VM_ROUTE_ORDER2 && route <= VM_ROUTE_ORDER5; }

/* Laws that fail at one evaluation, late ones too */
static void test_failing_routes(void)
{
    vm_real coefficient = R(0.01);
    int company, route;
    for (company = BY_ITSELF; company < COMPANIES; company++) {
        const vm_osc_problem o = failing_problem(company, &coefficient);
        good_calls = 0;
        while (good_calls < 10000) {
            for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_RK87; route++)
                if (company != WITH_FORCE || !is_law_of_order(route)) check_failing_route(&o, route);
            good_calls += ONE_IN * (1 + (good_calls > 40 ? good_calls / 8 : 0));
        }
    }
}

/* ---- Oscillators at their limits ---- */

/* Generating solutions at a time that is no number; and from rest with alpha < 1, where the rate would be infinite */
static void test_generating_solutions(void)
{
    vm_real x, v;
    CHECK(vmi_exp_ratio(0) == 1 && vmi_exp_ratio(VM_INFINITY) == VM_INFINITY && vmi_exp_ratio(-VM_MAX) == 1 / VM_MAX);
    vm_osc_exact(1, 0, VM_NAN, 3, &x, &v);
    CHECK(isnan((double)x) && isnan((double)v));
    vm_osc_trig(1, 0, VM_NAN, 3, &x, &v);
    CHECK(isnan((double)x) && isnan((double)v));
    vm_osc_exact(1, 0, 2, R(0.5), &x, &v);
    CHECK(x == 0 && v == 0);
    vm_osc_trig(1, 0, 2, R(0.5), &x, &v);
    CHECK(x == 0 && v == 0);
    vm_osc_jacobi(1, 0, 2, R(0.5), &x, &v);
    CHECK(x == 0 && v == 0);
}

/* x0 = 0.5, mass 2 and stiffness 3, both constant */
static vm_osc_problem steady_problem(vm_real alpha)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = alpha;
    o.reactive = 1;
    o.x = R(0.5);
    o.mass = vm_law_linear(2, 0);
    o.stiffness = vm_law_linear(3, 0);
    return o;
}

/* No plan, and a force on an oscillator at rest, for which no law has an amplitude */
static void test_nothing_to_start_from(void)
{
    vm_osc_problem o = steady_problem(3);
    vm_real coefficient = R(0.01);
    vm_osc_motion m;
    CHECK(vm_osc_plan_within(NULL, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_plan_by_route(NULL, VM_ROUTE_RK45, 1, 0, &m) == VM_BAD_ARGUMENT);
    o.x = 0;
    o.force = drag;
    o.ctx = &coefficient;
    CHECK(vm_osc_within(&o, 1, 0, &m) == VM_NO_LAW && vm_osc_by_route(&o, VM_ROUTE_RK87, 1, 0, &m) == VM_NO_LAW);
}

/* A force that is a damping gives the averages of a damping; the quarter of the period is long for large alpha. */
static void test_drag_as_damping(void)
{
    static const vm_real alphas[2] = {3, 30};
    vm_real coefficient = R(0.01), by_force[3] = {0}, by_damping[3] = {0};
    int i, route;
    for (i = 0; i < 2; i++) {
        for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_ATEB; route++) {
            vm_osc_problem o = steady_problem(alphas[i]);
            vm_osc_plan p;
            o.force = drag;
            o.ctx = &coefficient;
            CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
            CHECK(vm_osc_averaged(&p, route, 0, R(0.5), by_force, by_force + 1, by_force + 2) == VM_OK);
            o.force = NULL;
            o.damping = coefficient;
            CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
            CHECK(vm_osc_averaged(&p, route, 0, R(0.5), by_damping, by_damping + 1, by_damping + 2) == VM_OK);
            check_error("drag", vm_osc_route_name(route), "relative", fabs((double)(by_force[0] / by_damping[0] - 1)),
                        is_float ? 1e-4 : 1e-9, (double)o.alpha, 0);
        }
    }
}

/* The estimate of a wave's error is not above 1, so that a tolerance of 2 is content with any route. */
static void test_largest_tolerance(void)
{
    vm_osc_problem o = steady_problem(300);
    vm_osc_motion m;
    o.x = 1;
    CHECK(vm_osc_within(&o, 1, 2, &m) == VM_OK && m.route == VM_ROUTE_TRIG && m.error >= 1);
}

/* Half of the reactive force: two integrators agree within their estimates. */
static void test_half_reactive(void)
{
    vm_osc_problem o = steady_problem(3);
    vm_osc_motion m, other;
    o.reactive = R(0.5);
    o.mass = vm_law_linear(2, R(0.5));
    o.v = R(0.25);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_RK45, 2, 0, &m) == VM_OK && vm_osc_by_route(&o, VM_ROUTE_RK87, 2, 0, &other) == VM_OK);
    check_error("reactive 1/2", "rk45, rk87", "", fabs((double)(m.x - other.x)), (double)(m.error + other.error), 0,
                0);
}

/* A motion that is finite, or a refusal that leaves the output */
static void check_finite_or_refused(const vm_osc_problem *o, int route, vm_real t)
{
    vm_osc_motion m, untouched;
    memset(&untouched, STAIN, sizeof untouched);
    m = untouched;
    if (vm_osc_by_route(o, route, t, 0, &m) < 0) CHECK(memcmp(&m, &untouched, sizeof m) == 0);
    else CHECK(VM_IS_FINITE(m.x) && VM_IS_FINITE(m.v));
}

/* A mass that changes faster than any averaged law holds for */
static void test_fast_change(void)
{
    vm_osc_problem o = steady_problem(3);
    int i, route;
    o.mass = vm_law_linear(2, 500);
    o.stiffness = vm_law_linear(R(0.001), 0);
    for (i = 0; i < 64; i++) {
        o.v = R(0.01) * (vm_real)(i - 32);
        for (route = VM_ROUTE_ORDER2; route <= VM_ROUTE_ORDER5; route++)
            check_finite_or_refused(&o, route, R(0.01) * (vm_real)i);
    }
}

/* An amplitude that overflows, and one that vanishes */
static void test_extreme_amplitudes(void)
{
    const vm_real t = is_float ? 40 : 300;
    vm_osc_problem o = steady_problem(3);
    o.v = R(0.25);
    o.mass = vm_law_exponential(2, -1);
    o.reactive = 40;
    check_finite_or_refused(&o, VM_ROUTE_TRIG, t);
    o.reactive = -40;
    check_finite_or_refused(&o, VM_ROUTE_TRIG, t);
}

/* Rates of the largest amplitude, and a frequency that overflows */
static void test_overflowing_plans(void)
{
    vm_osc_problem o = steady_problem(5);
    vm_real A_rate = 7, theta_rate, psi_rate;
    vm_osc_plan p;
    int status;
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_ATEB, 0, VM_MAX, &A_rate, &theta_rate, &psi_rate) == VM_NOT_FINITE);
    CHECK(A_rate == 7);
    o.mass = vm_law_linear(VM_MIN, 0);
    o.stiffness = vm_law_linear(VM_MAX / 4, 0);
    CHECK(vm_osc_plan_init(&p, &o) == VM_NOT_FINITE);
    o.mass = vm_law_exponential(2, VM_MAX / 8);
    o.stiffness = vm_law_linear(3, 0);
    status = vm_osc_plan_init(&p, &o);
    CHECK(status == VM_OK || status == VM_NOT_FINITE);
}

/* A force 2 x + 3 x^3 that fails after so many calls */
static int failing_force(vm_real x, vm_real *F, void *ctx)
{
    (void)ctx;
    calls++;
    *F = 2 * x + 3 * x * x * x;
    return calls > good_calls ? 7 : 0;
}

static const vm_real knots[6] = {-40, -10, 10, 20, 30, 40}, at_knots[6] = {2, R(2.01), R(2.02), R(2.03), R(2.02), 2};
static const vm_real close_knots[6] = {-40, -10, 10, R(10.125), 30, 40};

/* Odd forces of the user and laws of the user, beside a table, that fail at each of their calls in turn */
static void test_failing_odd_forces(void)
{
    const vm_real numbers[11] = {ODD};
    static vm_odd_plan plan;
    vm_odd_motion motion = {7, 7, 7, 7, 7, 7};
    vm_odd_problem o, with_law;
    vm_odd_force force = vm_odd_force_user(failing_force, NULL);
    vm_real x = 7, v = 7;
    trial a;
    int route, status;
    start_trial(&a, numbers, 11);
    with_law = o = odd_problem(&a);
    o.force = force;
    o.stiffness = vm_law_table(6, knots, at_knots);
    with_law.mass = vm_law_user(failing_law, NULL);
    with_law.stiffness = o.stiffness;
    for (good_calls = 0; good_calls < 1500; good_calls += ONE_IN * (1 + good_calls / 20)) {
        calls = 0;
        status = vm_odd_exact_from(&force, 1, R(0.1), R(0.2), &x, &v);
        CHECK(calls > good_calls ? status < 0 && x == 7 : status == VM_OK);
        x = v = 7;
        calls = 0;
        status = vm_odd_within(&o, 25, R(1e-3), &motion);
        CHECK(calls > good_calls ? status < 0 && motion.x == 7 : status == VM_OK);
        motion.x = 7;
        for (route = VM_ODD_MEAN; route <= VM_ODD_RK87; route++) {
            calls = 0;
            status = vm_odd_plan_init(&plan, &with_law, 25);
            if (status == VM_OK) status = vm_odd_plan_by_route(&plan, route, 25, 0, &motion);
            CHECK(calls > good_calls ? status < 0 && motion.x == 7 : status >= 0 || status == VM_NO_LAW);
            motion.x = 7;
        }
    }
}

/* Van der Pol oscillators with a law of the user, which fails at each of its calls in turn, and a table */
static void test_failing_van_der_pol(void)
{
    static const int routes[5] = {VM_ROUTE_ATEB, VM_ROUTE_ORDER2, VM_ROUTE_ORDER3, VM_ROUTE_COLLOCATION, VM_ROUTE_RK87};
    static vm_vdp_plan plan;
    vm_osc_motion motion = {7, 7, 7, 7, 7, 7};
    vm_vdp v[2];
    int i, k, status;
    for (i = 0; i < 2; i++) v[i] = a_vdp();
    v[0].mass = v[1].stiffness = vm_law_user(failing_law, NULL);
    v[1].mass = v[0].stiffness = vm_law_table(6, close_knots, at_knots);
    good_calls = 1 << 20;
    for (i = 0; i < 2; i++) { /* points of a table that are closer than a quarter of a vibration */
        CHECK(vm_vdp_plan_init(&plan, &v[i], 1, R(0.2)) == VM_OK);
        CHECK(vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER2, 25, 0, &motion) == VM_NOT_INTEGRATED && motion.x == 7);
    }
    v[1].mass = v[0].stiffness = vm_law_table(6, knots, at_knots);
    for (i = 0; i < 2; i++)
        for (good_calls = 0; good_calls < 1500; good_calls += ONE_IN * (1 + good_calls / 20))
            for (k = 0; k < 6; k++) {
                const vm_real t = (good_calls + k) % 2 == 0 ? 25 : -15;
                calls = 0;
                status = vm_vdp_plan_init(&plan, &v[i], 1, R(0.2));
                if (status == VM_OK && k < 5) status = vm_vdp_plan_by_route(&plan, routes[k], t, R(1e-3), &motion);
                if (status == VM_OK && k == 5) status = vm_vdp_plan_within(&plan, t, R(1e-3), &motion);
                CHECK(calls > good_calls ? status < 0 && motion.x == 7 : status >= 0 || status == VM_NOT_INTEGRATED);
                motion.x = 7;
            }
}

/* A weak force of the user */
static vm_real weak_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return R(0.01) * VM_LIBM(sin)(t) - R(0.01) * x * x * v;
}

/* Oscillators with a law of the user, which fails at each of its calls in turn, a table, and a weak force */
static void test_failing_forced_routes(void)
{
    vm_osc_problem o = a_problem();
    vm_osc_motion motion = {7, 7, 7, 7, 7, 7};
    int route, status;
    o.x = 1;
    o.force = weak_force;
    o.mass = vm_law_table(6, knots, at_knots);
    o.stiffness = vm_law_user(failing_law, NULL);
    for (good_calls = 0; good_calls < 6000; good_calls += ONE_IN * (1 + good_calls / 20))
        for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_RK87 + 1; route++) {
            const vm_real t = (good_calls + route) % 2 == 0 ? 25 : -15;
            calls = 0;
            if (route > VM_ROUTE_RK87) status = vm_osc_within(&o, t, R(1e-3), &motion);
            else status = vm_osc_by_route(&o, route, t, R(1e-3), &motion);
            if (calls > good_calls) CHECK(status < 0 && motion.x == 7);
            else CHECK(status >= 0 || status == VM_NO_LAW || status == VM_NOT_INTEGRATED);
            motion.x = 7;
        }
}

/* Odd forces, plans and laws that lack something, and motions at rest or on the border between two kinds of motion */
static void test_odd_limits(void)
{
    const vm_odd_force unmade = {0}, well = vm_duffing_force(-2, 1);
    const vm_real numbers[11] = {ODD}, tolerances[2] = {VM_NAN, -1};
    static vm_odd_plan plan;
    vm_odd_motion motion = {7, 7, 7, 7, 7, 7};
    vm_odd_problem o;
    vm_real x, v;
    trial a;
    int k;
    start_trial(&a, numbers, 11);
    o = odd_problem(&a);
    CHECK(isnan(vm_odd_action(&unmade, 1)) && isnan(vm_odd_period(&unmade, 1)));
    CHECK(vm_odd_exact_from(&unmade, 1, 1, 1, &x, &v) == VM_BAD_ARGUMENT);
    CHECK(isnan(vm_duffing_period(0, -2, 1)) && isnan(vm_duffing_period(1, -2, -1)));
    CHECK(vm_duffing_period(2, -2, 1) == VM_INFINITY); /* x = 2/cosh(sqrt(2) t) */
    vm_duffing_exact_from(1, 0, 0, -2, 1, &x, &v);
    CHECK(x == 0 && v == 0);
    vm_duffing_exact_from(1, 2, 0, -2, 1, &x, &v);
    CHECK(fabs((double)x - 2 / cosh(sqrt(2))) < 64 * eps);
    CHECK(vm_odd_exact_from(&well, 1, 2, 0, &x, &v) == VM_NO_LAW);
    CHECK(vm_odd_plan_init(&plan, &o, 1) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_MEAN, R(0.001), 0, &motion) == VM_OK);
    x = motion.amplitude;
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_MEAN, 0, 0, &motion) == VM_OK && VM_FABS(motion.amplitude / x - 1) < R(0.01));
    motion.x = 7;
    for (k = 0; k < 2; k++) {
        CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, R(0.5), tolerances[k], &motion) == (k ? VM_DOMAIN : VM_NOT_FINITE));
        CHECK(vm_odd_plan_within(&plan, R(0.5), tolerances[k], &motion) == (k ? VM_DOMAIN : VM_NOT_FINITE));
        CHECK(vm_odd_within(&o, R(0.5), tolerances[k], &motion) == (k ? VM_DOMAIN : VM_NOT_FINITE));
    }
    CHECK(vm_odd_plan_within(&plan, 2, 0, &motion) == VM_DOMAIN && motion.x == 7);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87 + 1, R(0.5), 0, &motion) == VM_BAD_ARGUMENT);
    o.x = o.v = 0;
    o.force = vm_odd_force_user(rising, (void *)numbers);
    CHECK(vm_odd_within(&o, 1, 0, &motion) == VM_OK && motion.x == 0 && motion.v == 0);
}

/* Motions under odd forces that begin at rest, in a well or on the top between two wells, and a force that begins at 0 */
static void test_odd_starts(void)
{
    const vm_real numbers[11] = {ODD}, hardening[2] = {2, 3};
    const vm_law wells[2] = {vm_law_linear(-1, 0), vm_law_linear(1, 0)};
    const vm_law rising_from_0[2] = {vm_law_quadratic(0, 0, R(0.1)), vm_law_linear(1, 0)};
    vm_odd_motion motion = {7, 7, 7, 7, 7, 7};
    vm_odd_problem o;
    static vm_odd_plan plan;
    vm_real y[2] = {0, 1}, d[2];
    trial a;
    start_trial(&a, numbers, 11);
    o = odd_problem(&a);
    o.x = 1;
    o.v = 0;
    o.force = vm_duffing_force(-1, 1);
    CHECK(vm_odd_within(&o, 1, 0, &motion) == VM_OK && motion.x == 1 && motion.v == 0);
    o.force = vm_duffing_force_of_laws(wells);
    CHECK(vm_odd_within(&o, 1, 0, &motion) == VM_OK && fabs((double)motion.x - 1) < 1e-3 && fabs((double)motion.v) < 1e-3);
    o.force = vm_duffing_force_of_laws(rising_from_0);
    o.v = R(0.5);
    CHECK(vm_odd_within(&o, 1, 0, &motion) == VM_OK && motion.route == VM_ODD_RK87);
    o.force = vm_duffing_force(-1, -1); /* the body leaves */
    o.x = 0;
    CHECK(vm_odd_plan_init(&plan, &o, R(0.5)) == VM_OK);
    CHECK(vm_odd_plan_by_route(&plan, VM_ODD_RK87, R(0.5), 0, &motion) == VM_OK && motion.x > R(0.2));
    o.force = vm_odd_force_user(rising, (void *)hardening);
    CHECK(vm_odd_rhs(0, y, d, &o) == VM_OK && d[0] == 1);
}

/* Laws that look constant, or whose table has a time that is none */
static void test_kinds_of_stiffness(void)
{
    const vm_real times[2] = {-1, VM_NAN}, values[2] = {2, 3};
    const vm_law broken = vm_law_table(2, times, values);
    vm_osc_problem o = a_problem();
    vm_osc_motion motion = {7, 7, 7, 7, 7, 7}, other;
    vm_real f, rate;
    CHECK(vm_law_at(&broken, 5, &f, &rate) < 0 && vm_law_at(&broken, -5, &f, &rate) < 0);
    o.stiffness = vm_law_quadratic(3, 0, R(0.001));
    CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, 2, R(1e-3), &motion) == VM_OK);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_RK87, 2, R(1e-3), &other) == VM_OK);
    CHECK(VM_FABS(motion.x - other.x) < R(1e-3));
    good_calls = 1 << 20;
    o.stiffness = vm_law_user(failing_law, NULL);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, 2, R(1e-3), &motion) == VM_OK);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_RK87, 2, R(1e-3), &other) == VM_OK);
    CHECK(VM_FABS(motion.x - other.x) < R(1e-3));
}

/* Integrals of a quotient of laws, of which one was not made or is constant */
static void test_ratio_integrals(void)
{
    static const vm_law unmade;
    const vm_law linear = vm_law_linear(2, R(0.1)), constant = vm_law_linear(3, 0), power = vm_law_power(2, R(0.2), 2);
    vm_real integral = 7;
    CHECK(vm_law_ratio_integral(&linear, &unmade, 1, &integral) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&unmade, &linear, 1, &integral) == VM_BAD_ARGUMENT && integral == 7);
    CHECK(vm_law_ratio_integral(&linear, &constant, 2, &integral) == VM_OK);
    check_error("f/g", "g constant", "eps", fabs((double)integral - (2 * 2 + 0.1 * 2) / 3) / eps, 8, 2, 0);
    CHECK(vm_law_ratio_integral(&linear, &power, 2, &integral) == VM_OK);
    check_error("f/g", "other powers", "eps", fabs((double)integral - 1.49201886720508758) / eps, 64, 2, 0);
}

/* An oscillator at rest, by a plan: every route and tolerance */
static void test_plan_at_rest(void)
{
    static vm_osc_plan plan;
    vm_osc_problem o = a_problem();
    vm_osc_motion motion = {7, 7, 7, 7, 7, 7};
    o.x = o.v = 0;
    CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
    CHECK(vm_osc_plan_within(&plan, 1, 0, &motion) == VM_OK && motion.x == 0 && motion.v == 0 && motion.error == 0);
    CHECK(vm_osc_plan_by_route(&plan, VM_ROUTE_COLLOCATION, 1, 0, &motion) == VM_OK && motion.x == 0);
    CHECK(vm_osc_plan_within(&plan, 1, -1, &motion) == VM_DOMAIN);
    CHECK(vm_osc_within(&o, 1, -1, &motion) == VM_DOMAIN && vm_osc_within(&o, 1, VM_NAN, &motion) == VM_NOT_FINITE);
}

int main(int argc, char **argv)
{
    read_refusal_rounds(argc, argv);
    test_oscillators();
    test_odd_forces();
    test_averaged();
    test_laws();
    test_bad_tables();
    test_tables();
    test_backward();
    test_straight_table();
    test_failing_law();
    test_failing_plan();
    test_failing_routes();
    test_generating_solutions();
    test_nothing_to_start_from();
    test_drag_as_damping();
    test_largest_tolerance();
    test_half_reactive();
    test_fast_change();
    test_extreme_amplitudes();
    test_overflowing_plans();
    test_failing_odd_forces();
    test_failing_van_der_pol();
    test_failing_forced_routes();
    test_odd_limits();
    test_odd_starts();
    test_kinds_of_stiffness();
    test_ratio_integrals();
    test_plan_at_rest();
    return check_finish("refusals oscillators");
}
