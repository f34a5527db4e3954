/* vm_osc_closed, the law of order five as plain data: its errors and their estimates on the motions of
   tests/gen/slow_motion_reference.c, the bits that it shares with vm_osc_plan, laws in which something cancels, and what
   it refuses. Motions without disturbance come from tests/gen/slow_motion.py. */
#include "../varmass.h"
#include "check.h"
#include "oscillator_checks.h"
#include "routes_problems.h"
#include "judgement.h"
#include "slow_motions.h"
#include "data/slow_solved.h"

/* ---- Shorter code for the start ---- */

/* The phase by power series is that of ateb_phase, and the reduced states agree. */
static void test_start(void)
{
    static const double alphas[] = {0, 0.001, 0.5, 1, 4. / 3, 3, 10, 100};
    int k, i;
    for (k = 0; k < COUNT(alphas); k++)
        for (i = -32; i <= 32; i++) {
            const vm_real alpha = R(alphas[k]), phase = ateb_pi(alpha) * (vm_real)i / 32;
            vm_real sa, ca, psi, by_series, A;
            vmi_osc_reduced r;
            vmi_ateb c;
            ateb_saca(phase, alpha, &sa, &ca);
            vmi_ateb_fine_constants(&c, alpha);
            psi = ateb_phase(sa, ca, alpha);
            by_series = vmi_ateb_phase_by_series(c.quarter, alpha, sa, ca);
            check_error("start", "phase", "eps Pi", fabs((double)((by_series - psi) / ateb_pi(alpha))) / eps, 4, alphas[k], i);
            vm_osc_amplitude_phase(2 * ca, -3 * sa, R(1.25), alpha, &A, &psi);
            r = vmi_osc_reduce_by_series(R(1.25), alpha, 2 * ca, -3 * sa);
            check_error("start", "A", "eps", fabs((double)(r.A / A - 1)) / eps, 2, alphas[k], i);
            check_error("start", "psi", "eps Pi", fabs((double)((r.psi - psi) / ateb_pi(alpha))) / eps, 4, alphas[k], i);
        }
}

/* Pi_alpha and g by vmi_ateb_fine_constants are those of the table, also for very large alpha. */
static void test_constants(void)
{
    static const double alphas[] = {0, 1e-9, 0.5, 1, 3, 100, 2e4, 1e5, 4e8, 1e9, 1e20};
    int k;
    for (k = 0; k < COUNT(alphas); k++) {
        vmi_ateb table, fine;
        vmi_ateb_constants(&table, R(alphas[k]));
        vmi_ateb_fine_constants(&fine, R(alphas[k]));
        check_error("constants", "quarter", "eps", fabs((double)(fine.quarter.hi / table.quarter.hi - 1)) / eps, 1, alphas[k], 0);
        check_error("constants", "g", "eps", fabs((double)(fine.g.hi / table.g.hi - 1)) / eps, 1, alphas[k], 0);
    }
}

static void test_exponentials(void)
{
    double x;
    for (x = -40; x < 40; x += 0.37) {
        const double y = x * x * x / 1600;
        vm_real ratio;
        const double e = exp((double)R(y)), got = (double)vmi_exp_and_ratio(R(y), &ratio);
        check_error("exponential", "e^y", "eps", fabs(got / e - 1) / eps, 2, y, 0);
        check_error("exponential", "(e^y-1)/y", "eps", fabs((double)ratio * (double)R(y) / expm1((double)R(y)) - 1) / eps, 4, y, 0);
    }
}

/* ---- Errors and estimates ---- */

/* All motions of a table whose laws have closed forms, each with its own end: the estimate holds from 0 to there */
static void judge_table(const slow_case *cases, int count, int order, judgement *j)
{
    int k, i;
    for (k = 0; k < count; k++) {
        const vm_osc_problem o = problem_of(&cases[k].c);
        for (i = 0; i < TIMES; i++) {
            const double t = slow_time(cases + k, i);
            vm_osc_motion m = {0, 0, 0, 0, 0, 0};
            vmi_osc_rates_of_u u;
            vm_osc_closed c;
            const int status = vm_osc_closed_init(&c, &o, order, R(t));
            if (!vmi_osc_find_closed_form(&o, &u)) {
                CHECK(status == VM_NO_LAW);
                continue;
            }
            CHECK(status == VM_OK || status == VM_NO_LAW);
            if (status != VM_OK || vm_osc_closed_at(&c, R(t), &m.x, &m.v) != VM_OK || !(c.error < VM_INFINITY)) {
                j->unknown++;
                continue;
            }
            CHECK(c.error <= R(0.25)); /* a larger estimate says nothing, and is given as infinite */
            judge(j, slow_error(cases + k, &o, i, &m), (double)c.error);
        }
    }
}

static void test_estimates(void)
{
    enum { MOST = TIMES * (COUNT(slow_orders) + COUNT(slow_wide) + COUNT(slow_random)) };
    static double sharp[MOST];
    static const char *const names[] = {"order 2", "order 3", "order 4", "order 5"};
    int order;
    for (order = 2; order <= 5; order++) {
        judgement j = {NULL, 0, 0, 0, 0};
        j.sharp = sharp;
        judge_table(slow_orders, COUNT(slow_orders), order, &j);
        judge_table(slow_wide, COUNT(slow_wide), order, &j);
        judge_table(slow_random, COUNT(slow_random), order, &j);
        judge_table(slow_tables, COUNT(slow_tables), order, &j); /* none of them has a closed form */
        CHECK(j.count > 500);
        report(names[order - 2], &j, by_precision(12, 30), 2);
    }
}

/* Order N errs with the Nth power of the rates: the slow_orders stand in pairs with rates of ratio 4. */
static void test_orders(void)
{
    double slope[COUNT(slow_orders) / 2];
    int order, k, n;
    if (is_float) return; /* float holds no such orders */
    for (order = 2; order <= 5; order++) {
        for (k = n = 0; k + 1 < COUNT(slow_orders); k += 2) {
            double error[2] = {0, 0};
            int i, part, closed = 1;
            for (part = 0; part < 2; part++) {
                const slow_case *s = slow_orders + k + part;
                const vm_osc_problem o = problem_of(&s->c);
                vm_osc_closed c;
                if (vm_osc_closed_init(&c, &o, order, R(s->c.T)) != VM_OK) {
                    closed = 0;
                    break;
                }
                for (i = 0; i < TIMES; i++) {
                    vm_osc_motion m = {0, 0, 0, 0, 0, 0};
                    CHECK(vm_osc_closed_at(&c, R(slow_time(s, i)), &m.x, &m.v) == VM_OK);
                    error[part] = fmax(error[part], slow_error(s, &o, i, &m));
                }
            }
            if (closed) slope[n++] = log(error[0] / error[1]) / log(4);
        }
        CHECK(n > 20);
        check_error("orders", "median slope", "", fabs(median(slope, n) - order), 0.3, order, median(slope, n));
    }
}

/* Laws for which G_0 = 0: every order is exact. */
static void test_solved(void)
{
    int i, order, closed = 0, duffing = 0;
    for (i = 0; i < COUNT(solved_rows); i++) {
        const vm_osc_problem o = problem_of(solved_rows + i);
        for (order = 2; order <= 5; order++) {
            vm_osc_closed c;
            vm_real x = 0, v = 0;
            const int status = vm_osc_closed_init(&c, &o, order, R(solved_rows[i].T));
            if (status == VM_NO_LAW) continue;
            closed++;
            CHECK(status == VM_OK && vm_osc_closed_at(&c, R(solved_rows[i].T), &x, &v) == VM_OK);
            check_error("solved", "G_0 = 0", "eps", case_error(solved_rows + i, &o, x, v) / eps, 250, i, order);
            check_error("solved", "estimate", "eps", (double)c.error / eps, 1500, i, order);
        }
    }
    CHECK(closed >= 16);
    for (i = 0; i < COUNT(duffing_rows); i++) { /* G_0 W^-2 is constant, and the motion is one of cn */
        const vm_osc_problem o = problem_of(duffing_rows + i);
        for (order = 2; order <= 5; order++) {
            vm_osc_closed c;
            vm_real x = 0, v = 0;
            const int status = vm_osc_closed_init(&c, &o, order, R(duffing_rows[i].T));
            if (status == VM_NO_LAW) continue;
            duffing++;
            CHECK(status == VM_OK && vm_osc_closed_at(&c, R(duffing_rows[i].T), &x, &v) == VM_OK);
            check_error("Duffing", "true/est", "", case_error(duffing_rows + i, &o, x, v) / (double)c.error, 1.5, i, order);
        }
    }
    CHECK(duffing >= 4);
}

/* ---- The bits of vm_osc_plan ---- */

/* Compilers that contract products and sums do not do so in the same way at both places. */
static int same(vm_real a, vm_real b)
{
#ifdef __FP_FAST_FMA
    return fabs((double)(a - b)) <= 100 * eps * fmax(1, fabs((double)a));
#else
    return memcmp(&a, &b, sizeof a) == 0;
#endif
}

static void test_bits(void)
{
    int k, order, compared = 0;
    for (k = 0; k < COUNT(slow_random); k++) {
        const vm_osc_problem o = problem_of(&slow_random[k].c);
        const vm_real t = R(slow_random[k].c.T);
        vm_osc_closed c;
        vm_osc_plan plan;
        if (vm_osc_closed_init(&c, &o, 5, t) != VM_OK) continue;
        CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
        for (order = 2; order <= 5; order++) {
            vm_osc_motion m = {0, 0, 0, 0, 0, 0};
            vm_real x = 0, v = 0;
            if (order == 4) continue;
            CHECK(vm_osc_plan_by_route(&plan, vmi_osc_route_of_order(order), t, 0, &m) == VM_OK);
            if (order == 2) CHECK(vm_osc_closed_at_order2(&c, t, &x, &v) == VM_OK);
            if (order == 3) CHECK(vm_osc_closed_at_order3(&c, t, &x, &v) == VM_OK);
            if (order == 5) CHECK(vm_osc_closed_at(&c, t, &x, &v) == VM_OK);
            CHECK(same(x, m.x) && same(v, m.v));
            compared++;
        }
    }
    CHECK(compared > 150);
}

/* ---- What cancels ---- */

/* Problems whose base, delta, G_0, gamma or alpha is next to 0 have motions next to those at 0. */
static void test_limits(void)
{
    static const double alphas[] = {0, 0.5, 1, 3, 6};
    static const double tiny[] = {0, 1e-300, 1e-30, 1e-12, -1e-12};
    int k, i, what;
    for (what = 0; what < 4; what++)
        for (k = 0; k < COUNT(alphas); k++) {
            vm_real x0 = 0, v0 = 0;
            for (i = 0; i < COUNT(tiny); i++) {
                vm_osc_problem o = problem(alphas[k], vm_law_linear(2, R(0.01)), 0.75, 0.0078125);
                vm_osc_closed c;
                vm_real x = 0, v = 0;
                double size;
                o.v = R(-0.375);
                if (what == 0) o.mass = vm_law_linear(2, R(tiny[i]));  /* base */
                if (what == 1) o.damping = R(0.01 * (0.5 - 0.75 + tiny[i])); /* p, and with it G_0 */
                if (what == 2) o.alpha += R(fabs(tiny[i]));            /* alpha, and for alpha = 1 gamma */
                if (what == 3) {                                       /* damping */
                    o.mass = vm_law_linear(2, 0);
                    o.damping = R(tiny[i]);
                }
                CHECK(vm_osc_closed_init(&c, &o, 5, 40) == VM_OK);
                CHECK(vm_osc_closed_at(&c, 40, &x, &v) == VM_OK);
                if (i == 0) {
                    x0 = x;
                    v0 = v;
                }
                size = fmax(fabs((double)(x - x0)), fabs((double)(v - v0)));
                check_error("limits", "x, v", "eps", fmax(size - 2e-10 * (fabs(tiny[i]) > 1e-20), 0) / eps, 400, alphas[k], i);
            }
        }
}

/* ---- Zeros of x, where the force has no derivatives for alpha < 1 ---- */

static const double rough_alphas[] = {0, 0.0078125, 0.125, 0.25, 0.5, 0.75};

/* A leak whose motion is solved, x = A el ca(psi0 + W t/el), el = 1 + t/128. It is compared at each zero of x from 0 to
   128 s and as near to it on both sides as times can be. The error is relative to A el, per radian of the phase. */
static void test_solved_zeros(void)
{
    const double a = 0.0078125, end = 128;
    int k, i, j;
    for (k = 0; k < COUNT(rough_alphas); k++) {
        const double alpha = rough_alphas[k], n = alpha + 1;
        vm_osc_problem o = problem(alpha, vm_law_power(1, R(a), R(alpha + 3)), 0, 0);
        const double between = (double)ateb_pi(R(alpha)); /* phase from zero to zero */
        vm_osc_closed c;
        double W;
        o.v = R(a); /* V = v - a x is 0, so that the phase begins at 0 and the amplitude is 1 */
        W = sqrt(n / 2);
        CHECK(vm_osc_closed_init(&c, &o, 5, R(end)) == VM_OK);
        for (i = 0; (i + 0.5) * between < W * end / 2; i++) {
            const double way = (i + 0.5) * between / W, zero = way / (1 - a * way);
            for (j = -40; j <= 40; j += 5) {
                const double side = (j > 0) - (j < 0);
                const vm_real t = R(zero * (1 + side * ldexp(1, -abs(j))));
                const double el = 1 + a * (double)t, psi = W * (double)t / el;
                vm_real x = 7, v = 7, sa, ca;
                double exact_x, exact_v;
                ateb_saca(R(psi), R(alpha), &sa, &ca);
                exact_x = el * (double)ca;
                exact_v = -2 / n * W / el * (double)sa + a * (double)ca;
                CHECK(vm_osc_closed_at(&c, t, &x, &v) == VM_OK);
                check_error("zeros", "x", "eps radian", fabs((double)x - exact_x) / (eps * el * (1 + psi)), 6, alpha, zero);
                check_error("zeros", "v", "eps radian", fabs((double)v - exact_v) / (eps * W * (1 + psi)), 6, alpha, zero);
            }
        }
    }
}

/* A leak that is not solved, by orders 3 and 5 beside collocation, through two vibrations. The largest error where x is
   less than a thirtieth of the amplitude is no larger than the largest one elsewhere, but for the rounding of the
   phase. */
static void test_disturbed_zeros(void)
{
    static const int routes[2] = {VM_ROUTE_ORDER3, VM_ROUTE_ORDER5};
    const double rate = 0.02, from = 90, rounding = 3e-13;
    int k, i, which;
    if (is_float) return; /* float holds no such errors */
    for (k = 0; k < COUNT(rough_alphas); k++) {
        vm_osc_problem o = problem(rough_alphas[k], vm_law_linear(1, R(rate)), 0, 0);
        double error[2][2] = {{0, 0}, {0, 0}};
        vm_osc_plan plan;
        int at_zeros = 0;
        o.v = R(-0.375);
        CHECK(vm_osc_plan_init(&plan, &o) == VM_OK);
        for (i = 0; i < 600; i++) {
            const vm_real t = R(from + i * 0.03125);
            vm_osc_motion exact = {0, 0, 0, 0, 0, 0}, m = exact;
            int zero;
            CHECK(vm_osc_plan_by_route(&plan, VM_ROUTE_ORDER5, t, 0, &m) == VM_OK);
            zero = fabs((double)m.x) < (double)m.amplitude / 30;
            if (!zero && i % 20 != 0) continue; /* elsewhere a few times are enough */
            CHECK(vm_osc_plan_by_route(&plan, VM_ROUTE_COLLOCATION, t, R(1e-14), &exact) >= 0);
            at_zeros += zero;
            for (which = 0; which < 2; which++) {
                CHECK(vm_osc_plan_by_route(&plan, routes[which], t, 0, &m) == VM_OK);
                error[which][zero] = fmax(error[which][zero], fabs((double)((m.x - exact.x) / exact.amplitude)));
            }
        }
        CHECK(at_zeros > 8);
        for (which = 0; which < 2; which++)
            check_error("disturbed", "zeros/else", "", error[which][1] / (error[which][0] + rounding), 1.25,
                        rough_alphas[k], error[which][1]);
    }
}

/* ---- Refusals ---- */

static void refused(const vm_osc_problem *o, int order, double t_end, int status)
{
    static vm_osc_closed c, before;
    memset(&c, 7, sizeof c);
    before = c;
    CHECK(vm_osc_closed_init(&c, o, order, R(t_end)) == status);
    CHECK(memcmp(&c, &before, sizeof c) == 0);
}

static vm_real no_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return 0 * (t + x + v);
}

static void test_refusals(void)
{
    const vm_osc_problem good = problem(1.5, vm_law_linear(2, R(0.01)), 1, 0.01);
    vm_osc_problem o;
    refused(&good, 1, 1, VM_BAD_ARGUMENT);
    refused(&good, 6, 1, VM_BAD_ARGUMENT);
    refused(NULL, 5, 1, VM_BAD_ARGUMENT);
    CHECK(vm_osc_closed_init(NULL, &good, 5, 1) == VM_BAD_ARGUMENT);
    refused(&good, 5, (double)VM_INFINITY, VM_NOT_FINITE);
    refused(&good, 5, (double)VM_NAN, VM_NOT_FINITE);
    refused(&good, 5, -200, VM_BAD_MASS);
    o = good;
    o.stiffness = vm_law_linear(1, R(-0.25));
    refused(&o, 5, 4, VM_BAD_STIFFNESS);
    o = good;
    o.alpha = -1;
    refused(&o, 5, 1, VM_DOMAIN);
    o = good;
    o.x = VM_NAN;
    refused(&o, 5, 1, VM_NOT_FINITE);
    o = good;
    o.force = no_force;
    refused(&o, 5, 1, VM_NO_LAW);
    o = good;
    o.mass = vm_law_quadratic(2, R(0.01), R(0.01));
    refused(&o, 5, 1, VM_NO_LAW);
    o.mass = vm_law_exponential(2, R(0.01)); /* with damping */
    refused(&o, 5, 1, VM_NO_LAW);
    o = good;
    o.stiffness = vm_law_linear(1, R(0.25)); /* another base */
    refused(&o, 5, 1, VM_NO_LAW);
    o = good;
    o.mass = vm_law_linear(2, 5); /* too fast */
    o.reactive = 0;
    refused(&o, 5, 1, VM_NO_LAW);
    o = good;
    o.mass = vm_law_user(NULL, NULL);
    refused(&o, 5, 1, VM_BAD_ARGUMENT);
}

static void test_values(void)
{
    vm_osc_problem o = problem(1.5, vm_law_linear(2, R(0.01)), 1, 0.01);
    vm_osc_closed c;
    vm_real x = 7, v = 7;
    CHECK(vm_osc_closed_init(&c, &o, 2, 10) == VM_OK);
    CHECK(vm_osc_closed_at(&c, VM_INFINITY, &x, &v) == VM_NOT_FINITE && x == 7 && v == 7);
    CHECK(vm_osc_closed_at(&c, -200, &x, &v) == VM_BAD_MASS && x == 7 && v == 7);
    CHECK(vm_osc_closed_at_order3(&c, 1, &x, &v) == VM_BAD_ARGUMENT && x == 7 && v == 7); /* prepared for order 2 */
    CHECK(vm_osc_closed_at_order2(&c, 1, &x, &v) == VM_OK && x != 7 && v != 7);
    CHECK(vm_osc_closed_at(NULL, 1, &x, &v) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_closed_at(&c, 1, NULL, &v) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_closed_at(&c, 1, &x, NULL) == VM_BAD_ARGUMENT);
    o.x = 0; /* at rest where there is no force */
    CHECK(vm_osc_closed_init(&c, &o, 5, 10) == VM_OK && c.error == 0);
    CHECK(vm_osc_closed_at(&c, 3, &x, &v) == VM_OK && x == 0 && v == 0);
    CHECK(vm_osc_closed_at(&c, -200, &x, &v) == VM_BAD_MASS);
    o = problem(1.5, vm_law_linear(2, 0), 1, 0);
    o.stiffness = vm_law_linear(1, R(-0.01));
    CHECK(vm_osc_closed_init(&c, &o, 5, 10) == VM_OK);
    CHECK(vm_osc_closed_at(&c, 100, &x, &v) == VM_BAD_STIFFNESS);
}

int main(void)
{
    test_start();
    test_constants();
    test_exponentials();
    test_estimates();
    test_orders();
    test_solved();
    test_bits();
    test_limits();
    test_solved_zeros();
    test_disturbed_zeros();
    test_refusals();
    test_values();
    return check_finish("closed_law");
}
