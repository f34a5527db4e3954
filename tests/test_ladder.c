/* The ladder of routes to x(t), at single problems; test_routes.c has random ones and takes longer. Tables whose curvature
   jumps are tested against integration, integrals of laws and averages against closed forms, calls by name against calls
   by number. Laws must be asked no further than t, and the choice of a route must be the cheapest that is good enough. */
#include "../varmass.h"
#include "check.h"
#include "oscillator_problem.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';

/* ---- Tables ---- */

/* Points 160 apart, 20 periods, values up and down by 20 %: at each the mean motion changes by the jump of m'' or k''.
   The laws of orders 2 to 5 against integration; their estimates are honest. */
static void test_tables(void)
{
    enum { N = 11 };
    static const double alphas[] = {0.6, 2.3, 3, 6};
    vm_real times[N], values[N];
    int a, i, k;
    for (i = 0; i < N; i++) {
        times[i] = R(160 * (i - 5));
        values[i] = R(1.2 + 0.2 * (i % 2) + 0.02 * (i - 5));
    }
    for (a = 0; a < 4 && !is_float; a++)
        for (i = -4; i < 4; i += i == -4 || i == 1 ? 2 : 1) /* the ends, and both sides of 0 */
            for (k = 0; k < 4; k++) {
                const vm_law table = vm_law_table(N, times, values);
                const vm_real t = R(160 * (i + 0.5));
                vm_osc_problem o = problem(alphas[a], table, k % 2, 0);
                vm_osc_motion truth, m;
                int route;
                if (k > 1) {
                    o.mass = vm_law_linear(1, 0);
                    o.stiffness = table;
                }
                o.v = R(0.2 * k);
                CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, t, R(1e-12), &truth) >= 0);
                for (route = VM_ROUTE_ORDER2; route <= VM_ROUTE_ORDER5; route++) {
                    static const double bounds[] = {1.5e-5, 5e-8, 2e-10, 1e-10};
                    double error;
                    CHECK(vm_osc_by_route(&o, route, t, 0, &m) == VM_OK);
                    error = fabs((double)((m.x - truth.x) / truth.amplitude));
                    check_error(vm_osc_route_name(route), k > 1 ? "table of k" : "table of m", "A", error,
                                bounds[route - VM_ROUTE_ORDER2], alphas[a], (double)t);
                    check_error(vm_osc_route_name(route), "true/est", "", error / (double)(m.error + truth.error), 1,
                                alphas[a], (double)t);
                }
            }
}

/* Within some periods of any start the first-order law is as good as its estimate, which is at least twice the error. */
static void test_first_order(void)
{
    static const double alphas[] = {0.3, 1, 2, 4, 6, 8};
    int a, i, k;
    for (a = 0; a < 6 && !is_float; a++) {
        const vm_real alpha = R(alphas[a]), pi = ateb_pi(alpha);
        const double vmax = sqrt(2 / (alphas[a] + 1));
        double least = 10;
        for (k = 0; k < 24; k++)
            for (i = 2; i < 40; i += 3) {
                vm_osc_problem o = problem(alphas[a], vm_law_linear(1, R(0.01)), 1, 0);
                vm_osc_motion truth, m;
                double error;
                vm_real sa, ca;
                ateb_saca(pi * R(k - 12) / 12, alpha, &sa, &ca);
                o.x = ca;
                o.v = R(-vmax) * sa;
                CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, R(0.3 * i), R(1e-6), &truth) >= 0);
                CHECK(vm_osc_by_route(&o, VM_ROUTE_ATEB, R(0.3 * i), 0, &m) == VM_OK);
                error = fmax(fabs((double)(m.x - truth.x)), fabs((double)(m.v - truth.v)) / vmax);
                check_error("first order", "true/est", "", error / (double)m.error, 1, alphas[a], 0.3 * i);
                least = fmin(least, (double)m.error / error);
            }
        check_error("first order", "est/true, least", "", least, 2, alphas[a], 0);
    }
}

/* ---- Laws that the user writes ---- */

/* A mass that cannot be told beyond a time, on either side */
static int known_until(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const double end = *(const double *)ctx;
    if ((double)t * end > end * end) return 1;
    *f = R(exp(0.002 * (double)t));
    *rate = R(0.002) * *f;
    return 0;
}

static void test_asked_no_further(void)
{
    static const double ends[] = {40, -40};
    int i, route;
    for (i = 0; i < 2; i++)
        for (route = 0; route <= VM_ROUTE_RK87; route++) {
            vm_osc_problem o = problem(1.7, vm_law_user(known_until, (void *)&ends[i]), 1, 0), same = o;
            vm_osc_motion m, n;
            vm_osc_plan p;
            double allowed;
            if (i) o.stiffness = same.stiffness = vm_law_exponential(1, R(0.001));
            same.mass = vm_law_exponential(1, R(0.002));
            CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
            CHECK(vm_osc_plan_by_route(&p, route, R(ends[i]), 0, &m) >= 0 && m.route == route);
            CHECK(vm_osc_by_route(&same, route, R(ends[i]), 0, &n) >= 0);
            allowed = (is_float ? 2e-3 : 2e-6) + (double)(m.error + n.error);
            check_error("user's law", "its closed form", "", fabs((double)(m.x - n.x)) / allowed, 1, ends[i], route);
        }
}

/* An error of the integral of the phase is an error of the phase, Om times as large, and is added to the estimate. */
static void test_error_of_phase(void)
{
    const vm_osc_problem o = problem(1.7, vm_law_exponential(1, R(0.002)), 1, 0);
    vm_osc_plan p;
    vmi_osc_mean mean;
    double before, added;
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK && vmi_osc_mean_at(&p, 10, &mean) == VM_OK);
    mean.error = 0;
    before = (double)vmi_osc_rounding(&p, &mean);
    mean.error = R(0.25);
    added = (double)vmi_osc_rounding(&p, &mean) - before;
    check_error("error of the phase", "added", "rel", fabs(added / (0.25 * (double)p.Om) - 1), is_float ? 1e-6 : 1e-14, 0, 0);
}

/* The bound of the terms of order epsilon^6 that order five leaves out, for alpha = 1, where a period of the phase is 2 pi */
static void test_third_rate(void)
{
    const vm_osc_problem o = problem(1, vm_law_exponential(1, R(0.002)), 1, 0);
    vm_osc_plan p;
    double L, g;
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
    L = (double)p.ripple.scale;
    g = (double)p.ripple.gamma;
    check_error("left out", "E0 E2", "rel",
                fabs((double)vmi_expansion_third_rate(&p.ripple, 1, 0) / (L * L / 256 * fabs((1 - 5 * g) * (2 - 5 * g))) - 1),
                is_float ? 1e-6 : 1e-14, 0, 0);
    check_error("left out", "E0^3", "rel", fabs((double)vmi_expansion_third_rate(&p.ripple, 0, 1) / (0.01 * L * L * L) - 1),
                is_float ? 1e-6 : 1e-14, 0, 0);
}

/* Laws whose reciprocal is 1 + height g((t - at)/width), so that int dt/m is known: a bump g = exp(-z^2) on its way up
   and down, or a kink g = max(0, z) */
typedef struct localised {
    double height, at, width;
    int kink;
} localised;

static int localised_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const localised *l = (const localised *)ctx;
    const double z = ((double)t - l->at) / l->width, g = l->kink ? fmax(0, z) : exp(-z * z);
    const double g_rate = l->kink ? (z > 0) / l->width : -2 * z / l->width * g, value = 1 / (1 + l->height * g);
    *f = R(value);
    *rate = R(-l->height * g_rate * value * value);
    return 0;
}

enum { BUMP, NARROW_BUMP, KINK };

/* Of a bump that is found without change_time, of a narrower one, of a kink */
static double random_width(int kind, double T)
{
    const double least = is_float ? 2000 : 3000;
    if (kind == NARROW_BUMP) return exp(uniform(log(0.01), log(0.3)));
    if (kind == KINK) return 100;
    return exp(uniform(log(T / least), log(T / 20)));
}

/* Bumps down to |t|/3000 (float |t|/2000) are found without being told of, narrower ones with change_time; kinks at any
   place */
static void test_localised_integrals(void)
{
    static const int kinds[4] = {BUMP, BUMP, KINK, NARROW_BUMP};
    static const char *const names[] = {"bump", "narrow bump", "kink"};
    const double T = 1000, root_pi = 1.7724538509055160273, unit = is_float ? 1e-5 : 1e-13;
    int i;
    for (i = 0; i < 400 / ONE_IN; i++) {
        localised l;
        vm_law law = vm_law_user(localised_law, &l);
        vm_real integral = 0;
        double exact;
        const int kind = kinds[i % 4];
        l.kink = kind == KINK;
        l.height = uniform(0.1, 2);
        l.width = random_width(kind, T);
        l.at = uniform(7 * fmin(l.width, 50), T - 7 * fmin(l.width, 50));
        if (kind == NARROW_BUMP) law.change_time = R(l.width);
        if (l.kink) exact = T + l.height / 2 * (T - l.at) * (T - l.at) / l.width;
        else exact = T + l.height * l.width * root_pi;
        if (i % 2) l.at = -l.at; /* backward in time: the bump is at -at */
        if (i % 2 && l.kink) continue;
        CHECK(vm_law_inverse_integral(&law, i % 2 ? R(-T) : R(T), &integral) == VM_OK);
        check_error("int dt/m", names[kind], is_float ? "1e-5" : "1e-13",
                    fabs(fabs((double)integral) / exact - 1) / unit, 1, l.width, l.at);
    }
}

/* A vibration slower than the bump in its law, a mass of 20 instead of 1 for 15 to 0.15 s while the period is 200 s: the
   steps of rk45 and rk87 do not pass over it, and collocation refuses: no amplitude and phase describe this motion. */
static void test_slow_vibration(void)
{
    static const double widths[] = {5, 0.5, 0.05};
    int i, route;
    for (i = 0; i < 3 && !is_float; i += ONE_IN) {
        localised l;
        vm_osc_motion strict, m;
        vm_osc_problem o;
        l.height = -0.95;
        l.at = 333;
        l.width = widths[i];
        l.kink = 0;
        o = problem(1, vm_law_user(localised_law, &l), 1, 0);
        o.stiffness = vm_law_linear(R(1e-3), 0);
        if (i == 2) o.mass.change_time = R(0.05);
        CHECK(vm_osc_by_route(&o, VM_ROUTE_RK87, 1000, R(1e-9), &strict) >= 0);
        /* what the bump makes of it, 0.03 by each second of its width, in first order: int dt/m is less by so much */
        check_error("slow vibration", "the bump's effect", "%",
                    100 * fabs(((double)strict.x - cos(sqrt(1e-3) * 1000)) / (0.02963 * widths[i]) - 1), 1, widths[i], 0);
        for (route = VM_ROUTE_RK45; route <= VM_ROUTE_RK87; route++) {
            CHECK(vm_osc_by_route(&o, route, 1000, R(1e-4), &m) == VM_OK);
            check_error("slow vibration", "by integration", "1e-4", fabs((double)(m.x - strict.x)) / 1e-4, 1, widths[i],
                        route);
        }
        CHECK(vm_osc_by_route(&o, VM_ROUTE_COLLOCATION, 1000, R(1e-4), &m) == VM_NOT_INTEGRATED);
        CHECK(vm_osc_within(&o, 1000, R(1e-4), &m) == VM_OK && m.route == VM_ROUTE_RK87);
        check_error("slow vibration", "vm_osc_within", "1e-4", fabs((double)(m.x - strict.x)) / 1e-4, 1, widths[i], 0);
    }
}

/* A change_time that is no time is refused, and so is one that would take more than 2^20 panels. */
static void test_change_time(void)
{
    static const double bad[] = {-1, 1e-4, HUGE_VAL};
    localised l = {0.5, 40, 5, 0};
    int i;
    for (i = 0; i < 3; i++) {
        vm_osc_problem o = problem(1.7, vm_law_user(localised_law, &l), 1, 0);
        const int expected = i == 2 ? VM_NOT_FINITE : VM_DOMAIN;
        vm_real integral = 7;
        vm_osc_motion m;
        o.mass.change_time = R(bad[i]);
        CHECK(vm_law_inverse_integral(&o.mass, 1000, &integral) == expected && integral == 7);
        CHECK(vm_osc_within(&o, 1000, 0, &m) == expected);
        CHECK(vm_osc_by_route(&o, VM_ROUTE_RK45, 1000, 0, &m) == expected);
    }
}

/* ---- The choice, and the calls by name ---- */

/* alpha, tolerance -> the cheapest route that is good enough: cos is exact for alpha = 1, cn for 3; a law of low order
   needs less than one of high order; where no law is, collocation */
static void test_choice(void)
{
    static const struct {
        double alpha, rate, tolerance;
        int route;
    } rows[] = {{1, 1e-3, 1e-2, VM_ROUTE_TRIG},           {3, 1e-3, 1e-2, VM_ROUTE_JACOBI},
                {0.1, 1e-3, 1e-2, VM_ROUTE_ATEB},         {1, 1e-3, 1e-4, VM_ROUTE_ORDER2},
                {3, 1e-3, 1e-4, VM_ROUTE_ORDER2},         {2.3, 1e-3, 1e-4, VM_ROUTE_ORDER2},
                {1, 1e-2, 1e-7, VM_ROUTE_ORDER3},         {3, 1e-2, 1e-7, VM_ROUTE_ORDER3},
                {0.5, 1e-2, 1e-9, VM_ROUTE_ORDER4},       {2.3, 1e-2, 1e-9, VM_ROUTE_ORDER4},
                {1, 1e-2, 1e-11, VM_ROUTE_ORDER5},        {3, 1e-2, 1e-11, VM_ROUTE_ORDER5},
                {0.5, 5e-2, 1e-9, VM_ROUTE_COLLOCATION},  {1, 5e-2, 1e-10, VM_ROUTE_COLLOCATION},
                {2.3, 5e-2, 1e-10, VM_ROUTE_COLLOCATION}, {5, 5e-2, 1e-10, VM_ROUTE_COLLOCATION}};
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        vm_osc_problem o = problem(rows[i].alpha, vm_law_linear(1, R(rows[i].rate)), 1, 0);
        vm_osc_motion m;
        if (is_float && rows[i].tolerance < 1e-3) continue;
        CHECK(vm_osc_within(&o, 20, R(rows[i].tolerance), &m) == VM_OK && m.route == rows[i].route);
    }
}

/* Pulsing faster than the vibration, so that the tolerance sets the steps */
static vm_real drag(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)x;
    return -*(const vm_real *)ctx * R(1 + sin(3 * (double)t)) * v * v * v;
}

/* A run of the equation of motion, whose mass falls to a ten-thousandth, knows the period at its present time and the
   rounding error of a time that belongs to so fast a vibration. */
static void test_run_of_direct_method(void)
{
    vmi_osc_method method = vmi_osc_method_rk87(vmi_osc_direct_rhs);
    const vm_osc_problem o = problem(1, vm_law_exponential(1, R(log(1e-4) / 10)), 1, 0);
    const vm_real end = 10, omega = 100; /* of the mass 1e-4 */
    static vmi_osc_run run;
    vm_osc_motion last;
    vm_osc_plan plan;
    CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
    method.direct = 1;
    run.plan = &plan;
    run.method = &method;
    run.side = 1;
    run.s.t = end;
    CHECK(VM_FABS(vmi_osc_period_now(&run) * omega / (2 * VM_PI) - 1) < R(is_float ? 1e-2 : 1e-11));
    memset(&last, 0, sizeof last);
    last.amplitude = R(0.1);
    CHECK(vmi_osc_run_rounding(&run, end, &last) >= VM_EPSILON * omega * end / 2);
}

/* With a force the laws' equations are integrated to the default tolerance, and
   the error is that of averaging, which the drag's strength makes some percent */
static void test_routes_with_force(void)
{
    vm_real strength = R(0.1);
    vm_osc_problem o = problem(2.3, vm_law_linear(1, R(1e-3)), 1, 0);
    int route;
    o.force = drag;
    o.ctx = &strength;
    for (route = 0; route <= VM_ROUTE_ATEB; route++) {
        vm_osc_motion strict, m, exact;
        CHECK(vm_osc_by_route(&o, VM_ROUTE_RK45, 30, is_float ? R(1e-4) : R(1e-9), &exact) >= 0);
        CHECK(vm_osc_by_route(&o, route, 30, is_float ? R(1e-4) : R(1e-9), &strict) >= 0);
        CHECK(vm_osc_by_route(&o, route, 30, 0, &m) == VM_OK && m.route == route);
        check_error("with a force", "whole error", "est", fabs((double)((m.x - exact.x) / exact.amplitude)) / (double)m.error,
                    1, route, 0);
        check_error("with a force", "to tolerance", "tol", fabs((double)(m.x - strict.x)) / (is_float ? 1e-3 : 1e-6), 1,
                    route, 0);
    }
}

/* ---- Averages ---- */

enum { LINEAR, CUBIC, DRY, PUMPED, SPRING };
typedef struct loading {
    int kind;
    vm_real size;
} loading;

static vm_real load_at(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const loading *l = (const loading *)ctx;
    (void)t;
    switch (l->kind) {
    case LINEAR: return -l->size * v;
    case CUBIC: return -l->size * v * v * v;
    case DRY: return v > 0 ? -l->size : l->size;
    case PUMPED: return -l->size * x * x * v;
    default: return -l->size * x * x * x;
    }
}

/* The power of F over k A^alpha is A'; a further spring's energy U over a period makes psi' = Om (1 + U'/(k A^alpha)).
   With V = vmax the means are those of |sa|^p |ca|^q, by beta functions. */
static void test_averages(void)
{
    static const double alphas[] = {0.3, 1, 2, 3, 5.5, 11, 12, 16, 30};
    int i, kind;
    for (i = 0; i < 9; i++)
        for (kind = LINEAR; kind <= SPRING; kind++) {
            const vm_real alpha = R(alphas[i]), A = R(0.8), size = R(0.01), k = R(1.3), m = R(0.7);
            const double V = sqrt(2 * (double)k / ((alphas[i] + 1) * (double)m)) *
                             pow((double)A, (alphas[i] + 1) / 2);
            const double slope = (double)k * pow((double)A, alphas[i]), Om = V * (alphas[i] + 1) / (2 * (double)A);
            const double power[] = {V * V * (double)ateb_mean(alpha, 2, 0),
                                    pow(V, 4) * (double)ateb_mean(alpha, 4, 0), V * (double)ateb_mean(alpha, 1, 0),
                                    (double)(A * A) * V * V * (double)ateb_mean(alpha, 2, 2), 0};
            const double push = pow((double)A, 3) * (double)ateb_mean(alpha, 0, 4) / slope;
            vm_osc_problem o = problem(alphas[i], vm_law_linear(m, 0), 1, 0);
            vm_osc_plan p;
            loading l;
            vm_real A_rate = 0, theta_rate = 0, psi_rate = 0;
            l.kind = kind;
            l.size = size;
            o.stiffness = vm_law_linear(k, 0);
            o.force = load_at;
            o.ctx = &l;
            CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
            CHECK(vm_osc_averaged(&p, VM_ROUTE_ATEB, 0, A, &A_rate, &theta_rate, &psi_rate) == VM_OK);
            if (kind == SPRING) {
                check_error("averaged", "psi' of a spring", "",
                            fabs((double)theta_rate / ((double)size * push * Om) - 1), is_float ? 2e-6 : 1e-10,
                            alphas[i], kind);
                check_error("averaged", "psi'", "", fabs((double)psi_rate / (Om * (1 + (double)size * push)) - 1),
                            is_float ? 2e-6 : 1e-10, alphas[i], kind);
            } else
                check_error("averaged", "A' of a drag", "",
                            fabs((double)A_rate * slope / ((double)-size * power[kind]) - 1),
                            is_float ? 2e-6 : 1e-10, alphas[i], kind);
        }
}

int main(void)
{
    test_tables();
    test_first_order();
    test_asked_no_further();
    test_error_of_phase();
    test_third_rate();
    test_localised_integrals();
    test_slow_vibration();
    test_change_time();
    test_choice();
    test_run_of_direct_method();
    test_routes_with_force();
    test_averages();
    return check_finish("ladder");
}
