/* vm_osc_load: an oscillator from which mass leaves with a velocity u, and whose damping is a law of time, (248); and
   vm_law_ratio_integral. Oracles: motions and integrals in arbitrary precision (tests/gen/loads_reference.py), problems
   without a load that have the same motion, and amplitude laws. */
#include "../varmass.h"
#include "check.h"
#include "oscillator_checks.h"

static vm_osc_problem problem_of(double alpha, vm_law mass, vm_law stiffness, double reactive)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = R(alpha);
    o.mass = mass;
    o.stiffness = stiffness;
    o.reactive = R(reactive);
    return o;
}

/* Position and velocity by this route against the truth, relative to `size`: in units of the tolerance and of the
   estimate, which is larger where the tolerance is missed. */
static void check_motion(const char *what, const vm_osc_problem *o, int route, double t, double x, double v, double size)
{
    const double tolerance = by_precision(1e-9, 1e-4);
    vm_osc_motion motion;
    double unit;
    memset(&motion, 0, sizeof motion);
    CHECK(vm_osc_by_route(o, route, R(t), R(tolerance), &motion) >= 0);
    CHECK(motion.error < R(by_precision(1e-7, 0.1)));
    unit = (tolerance + (double)motion.error) * size;
    check_error(vm_osc_route_name(route), what, "tol", fabs((double)motion.x - x) / unit, 4, t, (double)o->alpha);
    check_error(vm_osc_route_name(route), what, "tol", fabs((double)motion.v - v) / unit, 4, t, (double)o->alpha);
}

static const int integrations[] = {VM_ROUTE_COLLOCATION, VM_ROUTE_RK45, VM_ROUTE_RK87};

/* alpha = 1, m = m0 + m1 t and a constant u: Bessel functions about x = m1 u/k */
static void test_bessel(void)
{
    static const double rows[][9] = {
#define LOADS_BESSEL
#include "data/loads_table.h"
#undef LOADS_BESSEL
    };
    size_t i, k;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double *a = rows[i];
        const vm_law u = vm_law_linear(R(a[3]), 0);
        vm_osc_problem o = problem_of(1, vm_law_linear(R(a[1]), R(a[2])), vm_law_linear(R(a[0]), 0), 1);
        vm_osc_load load;
        o.x = R(a[4]);
        o.v = R(a[5]);
        CHECK(vm_osc_load_init(&load, &o, &u, NULL) == VM_OK);
        for (k = 0; k < 3; k++) check_motion("Bessel", &o, integrations[k], a[6], a[7], a[8], 1);
    }
}

/* alpha = 3, a reactive share, a linear u and an exponential damping */
static void test_cubic(void)
{
    static const double rows[][13] = {
#define LOADS_CUBIC
#include "data/loads_table.h"
#undef LOADS_CUBIC
    };
    size_t i, k;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double *a = rows[i];
        const vm_law u = vm_law_linear(R(a[4]), R(a[5])), damping = vm_law_exponential(R(a[6]), R(a[7]));
        vm_osc_problem o = problem_of(3, vm_law_linear(R(a[1]), R(a[2])), vm_law_linear(R(a[0]), 0), a[3]);
        vm_osc_load load;
        o.x = R(a[8]);
        o.v = R(a[9]);
        CHECK(vm_osc_load_init(&load, &o, &u, &damping) == VM_OK);
        for (k = 0; k < 3; k++) check_motion("Taylor", &o, integrations[k], a[10], a[11], a[12], 1);
    }
}

/* With r = 1, alpha = 1 and a constant u the load moves the middle by m1 u/k and does nothing else: the same problem
   without a load, from a start that is shifted, has the same motion over a hundred periods. */
static void test_shifted_middle(void)
{
    const vm_law u = vm_law_linear(R(1.5), 0);
    const double shift = 0.01 * 1.5 / 9;
    vm_osc_problem o = problem_of(1, vm_law_linear(1, R(0.01)), vm_law_linear(9, 0), 1), bare = o;
    vm_osc_load load;
    double t;
    o.x = R(0.5);
    bare.x = R(0.5 - shift);
    CHECK(vm_osc_load_init(&load, &o, &u, NULL) == VM_OK);
    for (t = 10; t < 210; t += 50) {
        vm_osc_motion m;
        CHECK(vm_osc_by_route(&bare, VM_ROUTE_RK87, R(t), R(by_precision(1e-11, 1e-4)), &m) >= 0);
        check_motion("shifted middle", &o, VM_ROUTE_RK87, t, (double)m.x + shift, (double)m.v, 1);
    }
}

/* Damping c m' is the reactive force of a share that is larger by c: the same motion for every alpha, and the same
   averaged equations. The mass is quadratic, so that m' is a linear law. */
static void test_damping_like_reaction(void)
{
    const double alphas[] = {0.5, 1, 2, 3, 5};
    const vm_law mass = vm_law_quadratic(2, R(0.02), R(0.002));
    const vm_law damping = vm_law_linear(R(0.5 * 0.02), R(0.5 * 0.004));
    size_t i, k;
    int route;
    for (i = 0; i < sizeof alphas / sizeof *alphas; i++) {
        vm_osc_problem o = problem_of(alphas[i], mass, vm_law_linear(3, R(0.02)), 0.25), same = o;
        vm_osc_load load;
        vm_osc_plan plan, same_plan;
        vm_osc_motion m;
        o.x = same.x = 1;
        o.v = same.v = R(0.3);
        same.reactive = R(0.75);
        CHECK(vm_osc_load_init(&load, &o, NULL, &damping) == VM_OK);
        CHECK(vm_osc_by_route(&same, VM_ROUTE_COLLOCATION, 20, R(by_precision(1e-11, 1e-5)), &m) >= 0);
        for (k = 0; k < 3; k++)
            check_motion("damping c m'", &o, integrations[k], 20, (double)m.x, (double)m.v, (double)m.amplitude + 1);
        CHECK(vm_osc_plan_init(&plan, &o) == VM_OK && vm_osc_plan_init(&same_plan, &same) == VM_OK);
        for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_ATEB; route++) {
            vm_real A = 0, theta = 0, psi = 0, same_A = 1, same_theta = 0, same_psi = 0;
            CHECK(vm_osc_averaged(&plan, route, 7, R(0.8), &A, &theta, &psi) == VM_OK);
            CHECK(vm_osc_averaged(&same_plan, route, 7, R(0.8), &same_A, &same_theta, &same_psi) == VM_OK);
            if (route != VM_ROUTE_ATEB && alphas[i] != 1) continue; /* cos and cn have their own energy */
            check_error("averaged A'", "damping c m'", "rel", fabs((double)(A / same_A) - 1),
                        by_precision(1e-10, 2e-5), alphas[i], route);
            check_error("averaged psi'", "damping c m'", "rel", fabs((double)(psi / same_psi) - 1),
                        by_precision(1e-10, 2e-5), alphas[i], route);
        }
    }
}

/* The averaged routes with both loads stay within their estimates; the amplitude follows (325) with the decay by
   vm_law_ratio_integral. */
static void test_averaged(void)
{
    const double alphas[] = {1, 1.5, 3};
    const vm_law u = vm_law_linear(R(0.4), 0), damping = vm_law_linear(R(0.01), R(0.0004));
    size_t i;
    for (i = 0; i < 3; i++) {
        const double t = 30, mass_ratio = (1 + 0.004 * t);
        vm_osc_problem o = problem_of(alphas[i], vm_law_linear(1, R(0.004)), vm_law_linear(4, 0), 1);
        vm_osc_load load;
        vm_osc_motion averaged, exact;
        vm_real decay = 0;
        double law;
        o.x = 1;
        CHECK(vm_osc_load_init(&load, &o, &u, &damping) == VM_OK);
        CHECK(vm_osc_by_route(&o, VM_ROUTE_ATEB, R(t), 0, &averaged) >= 0);
        CHECK(vm_osc_by_route(&o, VM_ROUTE_RK87, R(t), R(by_precision(1e-10, 1e-4)), &exact) >= 0);
        check_error("averaged x", "estimate", "est",
                    fabs((double)(averaged.x - exact.x)) / (double)(averaged.error * averaged.amplitude), 1, alphas[i], t);
        CHECK(averaged.error < 1);
        CHECK(vm_law_ratio_integral(&damping, &o.mass, R(t), &decay) == VM_OK);
        law = (double)vm_osc_amplitude_law(R(mass_ratio), decay, 1, R(alphas[i]));
        check_error("A (325)", "averaged", "rel", fabs((double)averaged.amplitude / law - 1), by_precision(2e-6, 2e-3),
                    alphas[i], t);
        check_error("A (325)", "exact", "rel", fabs((double)exact.amplitude / law - 1), 0.01, alphas[i], t);
    }
}

/* A velocity relative to the oscillator: share 1 of m' u, and no m' x' in the problem. Without a spring's work to speak
   of, the thrust m' u acts as on a rocket: m v' = m' u, so that v = u ln(m/m0) (the spring is weak: k = 1e-6). */
static void test_relative_velocity(void)
{
    const vm_law u = vm_law_linear(-3, 0);
    vm_osc_problem o = problem_of(1, vm_law_linear(2, R(-0.1)), vm_law_linear(R(1e-6), 0), 0);
    vm_osc_load load;
    vm_osc_motion m;
    o.x = R(1e-3);
    CHECK(vm_osc_load_init(&load, &o, &u, NULL) == VM_OK && load.reactive == 0);
    load.reactive = 1;
    CHECK(vm_osc_by_route(&o, VM_ROUTE_RK87, 5, R(by_precision(1e-8, 1e-3)), &m) >= 0);
    check_error("v by Tsiolkovsky", "weak spring", "rel", fabs((double)m.v / (-3 * log(0.75)) - 1), 1e-4, 5, 0);
}

static vm_real drive(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)x;
    (void)v;
    return *(const vm_real *)ctx * t;
}

/* The force is the sum of its terms, and a force that the problem had stays. */
static void test_force(void)
{
    const vm_law u = vm_law_linear(2, 1), damping = vm_law_linear(R(0.25), R(0.5)), short_law = vm_law_power(1, -1, 1);
    vm_osc_problem o = problem_of(1, vm_law_linear(4, R(0.5)), vm_law_linear(1, 0), 0.5);
    vm_real slope = 8;
    vm_osc_load load;
    o.force = drive;
    o.ctx = &slope;
    CHECK(vm_osc_load_init(&load, &o, &u, &damping) == VM_OK && o.force == vm_osc_load_force && o.ctx == &load);
    CHECK(vm_osc_load_force(2, 3, 4, &load) == R(0.5) * R(0.5) * 4 - R(1.25) * 4 + 16);
    load.damping = short_law;
    CHECK(isnan(vm_osc_load_force(2, 3, 4, &load)));
    CHECK(isnan(vm_osc_load_force(VM_NAN, 3, 4, &load)) && isnan(vm_osc_load_force(2, 3, 4, NULL)));
}

/* An error leaves load and problem as they are. */
static void test_refusals(void)
{
    const vm_law good = vm_law_linear(1, 0), none = vm_law_user(NULL, NULL), infinite = vm_law_linear(VM_INFINITY, 0);
    vm_osc_problem o = problem_of(1, vm_law_linear(4, R(0.5)), good, 0.5);
    vm_osc_load load, load_before;
    memset(&load, 7, sizeof load);
    load_before = load;
    CHECK(vm_osc_load_init(NULL, &o, &good, &good) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_load_init(&load, NULL, &good, &good) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_load_init(&load, &o, &none, &good) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_load_init(&load, &o, &good, &none) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_load_init(&load, &o, &infinite, &good) == VM_NOT_FINITE);
    o.reactive = VM_NAN;
    CHECK(vm_osc_load_init(&load, &o, &good, NULL) == VM_NOT_FINITE);
    o.reactive = 1;
    o.mass = vm_law_linear(-1, 0);
    CHECK(vm_osc_load_init(&load, &o, &good, NULL) == VM_BAD_MASS);
    CHECK(o.force == NULL && o.ctx == NULL && memcmp(&load, &load_before, sizeof load) == 0);
    o = problem_of(1, good, good, 1);
    CHECK(vm_osc_load_init(&load, &o, NULL, NULL) == VM_OK && vm_osc_load_force(1, 2, 3, &load) == 0);
    CHECK(vm_osc_load_init(&load, &o, NULL, NULL) == VM_BAD_ARGUMENT); /* it would call itself for ever */
}

/* ---- The integral of f/g ---- */

static vm_law law_of(double kind, const double *a)
{
    if (kind == 0) return vm_law_linear(R(a[0]), R(a[1]));
    if (kind == 1) return vm_law_quadratic(R(a[0]), R(a[1]), R(a[2]));
    if (kind == 2) return vm_law_exponential(R(a[0]), R(a[1]));
    return vm_law_power(R(a[0]), R(a[1]), R(a[2]));
}

static void test_ratio_integral(void)
{
    static const double rows[][11] = {
#define LOADS_INTEGRAL
#include "data/loads_table.h"
#undef LOADS_INTEGRAL
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double *a = rows[i];
        const vm_law f = law_of(a[0], a + 2), g = law_of(a[1], a + 5);
        vm_real integral = 7;
        CHECK(vm_law_ratio_integral(&f, &g, R(a[8]), &integral) == VM_OK);
        check_error("int f/g", "table", "rel", fabs((double)integral - a[9]) / a[10], by_precision(1e-14, 2e-6), a[0],
                    a[1]);
    }
}

static int sine(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = R(sin((double)t));
    *rate = R(cos((double)t));
    return 0;
}

/* f = 0 and f = g; a table against the same line; a function whose integral is 0; refusals */
static void test_ratio_integral_cases(void)
{
    static const vm_real times[] = {0, 2, 3, 7}, values[] = {1, 2, R(2.5), R(4.5)};
    const vm_law line = vm_law_linear(1, R(0.5)), table = vm_law_table(4, times, values), one = vm_law_linear(1, 0);
    const vm_law zero = vm_law_linear(0, 0), wave = vm_law_user(sine, NULL), none = vm_law_user(NULL, NULL);
    vm_real integral = 7;
    CHECK(vm_law_ratio_integral(&zero, &line, 3, &integral) == VM_OK && integral == 0);
    CHECK(vm_law_ratio_integral(&line, &line, -1, &integral) == VM_OK && VM_FABS(integral + 1) < 4 * VM_EPSILON);
    CHECK(vm_law_ratio_integral(&table, &line, 7, &integral) == VM_OK);
    check_error("int f/g", "f = g, table", "rel", fabs((double)integral / 7 - 1), by_precision(1e-14, 2e-6), 7, 0);
    CHECK(vm_law_ratio_integral(&line, &table, 7, &integral) == VM_OK);
    check_error("int f/g", "f = g, table", "rel", fabs((double)integral / 7 - 1), by_precision(1e-14, 2e-6), 7, 1);
    CHECK(vm_law_ratio_integral(&wave, &one, R(2 * 3.141592653589793), &integral) == VM_OK);
    check_error("int f/g", "sine", "abs", fabs((double)integral), by_precision(1e-14, 1e-6), 0, 0);
    integral = 7;
    CHECK(vm_law_ratio_integral(NULL, &one, 1, &integral) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&one, NULL, 1, &integral) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&one, &one, 1, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&none, &one, 1, &integral) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&none, &one, VM_NAN, &integral) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&one, &none, VM_NAN, &integral) == VM_BAD_ARGUMENT);
    CHECK(vm_law_ratio_integral(&one, &zero, 1, &integral) == VM_BAD_MASS);
    CHECK(vm_law_ratio_integral(&one, &one, VM_INFINITY, &integral) == VM_NOT_FINITE);
    CHECK(vm_law_ratio_integral(&table, &one, 8, &integral) == VM_DOMAIN && integral == 7);
}

/* f changes its sign between 0 and t, or is almost 0 at time 0: the closed form, which divides by f, is not finite there,
   and Gauss' rule takes over. */
static void test_ratio_integral_of_any_sign(void)
{
    const vm_law falling = vm_law_linear(1, -1), square = vm_law_quadratic(1, -2, 1), two = vm_law_linear(2, 0);
    const vm_law rising = vm_law_linear(R(by_precision(1e-200, 1e-30)), 1), one = vm_law_linear(1, 0);
    vm_real integral = 7;
    CHECK(vm_law_ratio_integral(&falling, &two, 2, &integral) == VM_OK && VM_FABS(integral) <= 4 * VM_EPSILON);
    CHECK(vm_law_ratio_integral(&falling, &two, 3, &integral) == VM_OK);
    check_error("int f/g", "f changes its sign", "rel", fabs((double)integral / -0.75 - 1), by_precision(1e-14, 2e-6), 3, 0);
    CHECK(vm_law_ratio_integral(&square, &two, 2, &integral) == VM_OK);
    check_error("int f/g", "f changes its sign", "rel", fabs((double)integral * 3 - 1), by_precision(1e-14, 2e-6), 2, 0);
    CHECK(vm_law_ratio_integral(&rising, &one, 1, &integral) == VM_OK);
    check_error("int f/g", "f almost 0", "rel", fabs((double)integral * 2 - 1), by_precision(1e-14, 2e-6), 1, 0);
}

int main(void)
{
    test_bessel();
    test_cubic();
    test_shifted_middle();
    test_damping_like_reaction();
    test_averaged();
    test_relative_velocity();
    test_force();
    test_refusals();
    test_ratio_integral();
    test_ratio_integral_cases();
    test_ratio_integral_of_any_sign();
    return check_finish("loads");
}
