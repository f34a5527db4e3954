/* integrators.h: the accuracy of rk45 and rk87. Their measured orders, and their errors in tolerances on known
   solutions, on DETEST's problems, over long runs and where the right-hand side jumps; against closed forms, 22 to 40
   digits by other methods, and the ends of data/detest_table.h. */
#include "integrator_check.h"
#include "data/detest_table.h"
#include "detest.h"

/* ---- Orders ---- */

/* The error at t_end with steps of size h, none of which the tolerance rejects */
static double error_at(const method *m, double h, double t_end)
{
    vm_real y0[3] = {1, 0, 1}, work[RK87_WORK(3)];
    rk45_options o = {0};
    rk45 s;
    o.atol = 1000;
    o.h0 = o.h_max = R(h);
    CHECK(m->init(&s, linear_rhs, NULL, 3, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, R(t_end)) == ODE_OK && s.t == R(t_end) && s.rejected == 0);
    CHECK(s.evals == m->stages * s.steps + 1);
    return linear_error(s.y, t_end);
}

/* The same of y' = 2 t y at t = 1 */
static double error_of_time(const method *m, double h)
{
    vm_real y0[1] = {1}, work[RK87_WORK(1)];
    rk45_options o = {0};
    rk45 s;
    o.atol = 1000;
    o.h0 = o.h_max = R(h);
    CHECK(m->init(&s, time_rhs, NULL, 1, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, 1) == ODE_OK);
    return fabs((double)s.y[0] - exp(1.));
}

static void test_orders(void)
{
    const method *pair5 = methods, *pair8 = methods + 1;
    if (is_float) return; /* in float rounding hides them */
    check_order("rk45", log2(error_at(pair5, 0.125, 2) / error_at(pair5, 0.0625, 2)), 5, 0.3);
    check_order("rk45, f of t", log2(error_of_time(pair5, 0.0625) / error_of_time(pair5, 0.03125)), 5, 0.5);
    check_order("rk87", log2(error_at(pair8, 1, 4) / error_at(pair8, 0.5, 4)), 8, 0.5);
    check_order("rk87, f of t", log2(error_of_time(pair8, 0.25) / error_of_time(pair8, 0.125)), 8.5, 0.8);
}

/* ---- Known solutions ---- */

/* (m x')' + x |x|^(alpha-1) = 0 with y = (x, m x') and the mass law m = (1 + rate t)^power */
typedef struct oscillator {
    vm_real alpha, rate, power;
} oscillator;

static int oscillator_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const oscillator *o = (const oscillator *)ctx;
    dydt[0] = y[1] / VM_LIBM(pow)(1 + o->rate * t, o->power);
    dydt[1] = -VM_COPYSIGN(VM_LIBM(pow)(VM_FABS(y[0]), o->alpha), y[0]);
    return 0;
}

typedef struct known {
    const char *name;
    oscillator equation;
    double t, x;
} known;

/* Bessel functions, an elementary function, and 40-digit extrapolation; x(0) = 1, x'(0) = 0 */
static const known solutions[] = {
    {"m = 1 + 0.1 t", {1, R(0.1), 1}, 10, -0.3331145282992179077380452},
    {"m = 1 + 0.1 t", {1, R(0.1), 1}, 50, -0.4912946398391219988499127},
    {"m = (1 + 0.1 t)^2", {1, R(0.1), 2}, 10, 0.5884587582788442775617413},
    {"cubic (398)", {3, R(0.1), 1}, 10, 0.8329476745754213932},
    {"cubic (398)", {3, R(0.1), 1}, 20, 0.1626996653923250896},
};

/* Forward to t and back to 0, at tolerances from 1e-12 to 1e-4 */
static void test_known_solutions(void)
{
    size_t i;
    for (i = 0; i < sizeof solutions / sizeof *solutions; i++) {
        const known *k = solutions + i;
        double tol;
        for (tol = is_float ? 1e-5 : 1e-12; tol < 1e-3; tol *= 100) {
            vm_real y0[2] = {1, 0}, work[RK45_WORK(2)];
            oscillator equation = k->equation;
            rk45_options o = {0};
            rk45 s;
            o.rtol = o.atol = R(tol);
            CHECK(rk45_init(&s, oscillator_rhs, &equation, 2, 0, y0, &o, work) == ODE_OK);
            CHECK(rk45_solve(&s, R(k->t)) == ODE_OK && s.t == R(k->t));
            check_error("x(t)", k->name, "tol", fabs((double)s.y[0] - k->x) / tol, 30, k->t, tol);
            CHECK(rk45_solve(&s, 0) == ODE_OK && s.t == 0);
            check_error("x(0), back", k->name, "tol", fabs((double)s.y[0] - 1) / tol, 12, k->t, tol);
        }
    }
}

/* ---- DETEST ---- */

/* The ends in the table that have closed forms: A1 to A4, and D1 to D5 by Kepler's equation, to the roundings of
   their first values and of 20 radians */
static void test_detest_ends(void)
{
    const double closed[4] = {exp(-20.), 1 / sqrt(21.), exp(sin(20.)), 20 / (1 + 19 * exp(-5.))};
    const double *orbit = detest_ends;
    int k, i;
    for (k = 0; k < 4; k++)
        check_error("DETEST, the ends", "A", "eps", fabs(detest_ends[k] / closed[k] - 1) / DBL_EPSILON, 4, k + 1, 0);
    for (k = 0; k < 15; k++) orbit += detest_problems[k].n;
    for (k = 1; k <= 5; k++) {
        const double e = 0.2 * k - 0.1, side = sqrt(1 - e * e);
        double E = 20, wanted[4]; /* the eccentric anomaly */
        for (i = 0; i < 50; i++) E -= (E - e * sin(E) - 20) / (1 - e * cos(E));
        wanted[0] = cos(E) - e;
        wanted[1] = side * sin(E);
        wanted[2] = -sin(E) / (1 - e * cos(E));
        wanted[3] = side * cos(E) / (1 - e * cos(E));
        for (i = 0; i < 4; i++)
            check_error("DETEST, the ends", "D", "eps", fabs(orbit[i] - wanted[i]) / DBL_EPSILON, 250, e, i);
        orbit += 4;
    }
}

/* The error of a problem of DETEST at t = 20, in tolerances of a step */
static double detest_error(const method *m, const detest_problem *p, const double *y_end, double tol, long *evals)
{
    double start[DETEST_LARGEST], error = 0;
    vm_real y0[DETEST_LARGEST], work[RK87_WORK(DETEST_LARGEST)];
    rk45_options o = {0};
    rk45 s;
    int i;
    detest_start(p, start);
    for (i = 0; i < p->n; i++) y0[i] = R(start[i]);
    o.rtol = o.atol = R(tol);
    CHECK(m->init(&s, p->f, NULL, p->n, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, R(detest_t_end)) == ODE_OK);
    for (i = 0; i < p->n; i++) error = fmax(error, fabs((double)s.y[i] - y_end[i]) / (tol * (1 + fabs(y_end[i]))));
    *evals += s.evals;
    return error;
}

/* Bounds of the errors of DETEST's classes A to E in units of the tolerance, by rk45 and rk87: in double, in float. They are
   twice the largest error that was measured when the errors were last looked at, with and without fused multiply-adds. */
static const double detest_bounds[2][METHODS][5] = {{{6, 18, 3, 150, 26}, {4, 11, 0.3, 20, 9}},
                                                    {{5, 135, 4, 550, 120}, {2.2, 25, 0.4, 70, 80}}};

/* DETEST's smooth problems: the errors at the end, at tolerances from 1e-6 to 1e-12 */
static void test_detest(void)
{
    static const char *const names[METHODS][5] = {{"A, rk45", "B, rk45", "C, rk45", "D, rk45", "E, rk45"},
                                                  {"A, rk87", "B, rk87", "C, rk87", "D, rk87", "E, rk87"}};
    int i, k, digits;
    for (i = 0; i < METHODS; i++) {
        const int fewest = is_float ? 4 : 6, most = is_float ? 4 : 12;
        const double *y_end = detest_ends;
        long evals = 0;
        for (k = 0; k < 25; k++) {
            const detest_problem *p = detest_problems + k;
            for (digits = fewest; digits <= most; digits += 3) {
                const double tol = pow(10, -digits), error = detest_error(methods + i, p, y_end, tol, &evals);
                check_error("DETEST", names[i][k / 5], "tol", error, detest_bounds[is_float][i][k / 5], tol, k % 5 + 1);
            }
            y_end += p->n;
        }
        printf("DETEST A to E, order %d: %ld evaluations\n", methods[i].order, evals);
    }
}

/* DETEST's class F, whose right-hand sides jump, or their slopes do: the geometric mean of the errors over the
   tolerances. rk87 had 2e4 at F1 and 2e3 at F5, before its error estimate saw jumps between its stages at c = 0 and
   0.9. */
static void test_detest_jumps(void)
{
    static const char *const names[METHODS][5] = {{"F1, rk45", "F2, rk45", "F3, rk45", "F4, rk45", "F5, rk45"},
                                                  {"F1, rk87", "F2, rk87", "F3, rk87", "F4, rk87", "F5, rk87"}};
    static const double bounds[METHODS][5] = {{1000, 15, 200, 1, 600}, {300, 5, 250, 1, 300}};
    int i, k, digits;
    if (is_float) return;
    for (i = 0; i < METHODS; i++) {
        const double *y_end = detest_ends + (sizeof detest_ends / sizeof *detest_ends) - 7;
        for (k = 25; k < DETEST_PROBLEMS; k++) {
            double sum = 0;
            long evals = 0;
            for (digits = 3; digits <= 13; digits++)
                sum += log(detest_error(methods + i, detest_problems + k, y_end, pow(10, -digits), &evals));
            check_error("DETEST", names[i][k - 25], "tol", exp(sum / 11), bounds[i][k - 25], 20, 0);
            y_end += detest_problems[k].n;
        }
    }
}

/* ---- Long runs ---- */

enum { LARGEST = 3 }; /* number of equations */

/* The largest difference of y at t_end to what is wanted, in tolerances */
static double run_error(const method *m, ode_rhs f, int n, const vm_real *y0, double t_end, double tol,
                        const double *wanted, long *evals)
{
    vm_real work[RK87_WORK(LARGEST)];
    rk45_options o = {0};
    double error = 0;
    rk45 s;
    int i;
    o.rtol = o.atol = R(tol);
    o.max_steps = -1;
    CHECK(m->init(&s, f, NULL, n, 0, y0, &o, work) == ODE_OK);
    CHECK(m->solve(&s, R(t_end)) == ODE_OK && s.t == R(t_end));
    for (i = 0; i < n; i++) error = fmax(error, fabs((double)s.y[i] - wanted[i]));
    *evals = s.evals;
    return error / tol;
}

static int sign_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = R(y[0] > 0 ? -1 : y[0] < 0);
    return 0;
}

/* x'' = -sign x over ten periods, at tolerances from 1e-4 to 1e-12: the geometric mean of the errors, in tolerances.
   rk87 had 2e5. */
static void test_sign(void)
{
    static const vm_real y0[2] = {1, 0};
    static const double wanted[2] = {1, 0}, bounds[METHODS] = {10000, 2500};
    const double ten_periods = 40 * sqrt(2.);
    int i, digits;
    if (is_float) return;
    for (i = 0; i < METHODS; i++) {
        double sum = 0;
        long evals;
        for (digits = 4; digits <= 12; digits++)
            sum += log(run_error(methods + i, sign_rhs, 2, y0, ten_periods, pow(10, -digits), wanted, &evals));
        check_error("x'' = -sign x", methods[i].name, "tol", exp(sum / 9), bounds[i], 0, 0);
    }
}

/* x'' = -x^3, whose solution is cn, over 20 and 2000 periods */
static void test_many_periods(void)
{
    static const vm_real y0[2] = {1, 0};
    static const double wanted[2] = {1, 0}, tolerances[METHODS] = {1e-10, 1e-12};
    static const double bounds[METHODS] = {600, 120}, bounds_of_2000[METHODS] = {6e6, 1e6};
    const double period = 7.416298709205487673735401388781;
    int i;
    if (is_float) return;
    for (i = 0; i < METHODS; i++) {
        const method *m = methods + i;
        const double tol = tolerances[i];
        long evals;
        check_error("cn, 20 periods", m->name, "tol",
                    run_error(m, cubic_rhs, 2, y0, 20 * period, tol, wanted, &evals), bounds[i], 20, tol);
        check_error("cn, 2000", m->name, "tol",
                    run_error(m, cubic_rhs, 2, y0, 2000 * period, tol, wanted, &evals), bounds_of_2000[i], 2000, tol);
    }
}

/* Euler's equations of a body with the moments 1, 2, 3 */
static int rigid_body_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = -y[1] * y[2];
    dydt[1] = y[2] * y[0];
    dydt[2] = -y[0] * y[1] / 3;
    return 0;
}

static int varying_mass_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -(y[0] * y[0] * y[0] + R(0.1) * y[1]) / (1 + R(0.1) * t);
    return 0;
}

typedef struct long_run {
    const char *name;
    ode_rhs f;
    int n;
    vm_real y0[LARGEST];
    double t_end, wanted[LARGEST]; /* 22 digits by the pair of order 8 in quadruple precision */
    double bounds[2][METHODS];     /* in tolerances; in double and in float */
} long_run;

/* rk87 has 18 tolerances at 1e-5 for the rigid body, by 697 evaluations, and 2 to 4 at neighbouring tolerances. */
enum { LONG_RUNS = 3 };
static const long_run long_runs[LONG_RUNS] = {
    {"x'' = -x^3", cubic_rhs, 2, {1, 0, 0}, 100, {-0.9928219270246553026, -0.1191734455528570027, 0},
     {{2000, 100}, {2000, 2000}}},
    {"varying mass", varying_mass_rhs, 2, {1, 0, 0}, 50, {-0.2102254653258942060, -0.1578403286848444388, 0},
     {{80, 20}, {80, 150}}},
    {"rigid body", rigid_body_rhs, 3, {1, R(0.1), R(0.9)}, 60,
     {-0.8416044062440098099, -0.5492740876745121888, 0.8442546962872701759}, {{600, 30}, {600, 200}}}};

/* The errors of the long runs, in tolerances; *evals is the number of evaluations of the rigid body. */
static void run_long(int method_index, double tol, double *error, long *evals)
{
    const method *m = methods + method_index;
    int i;
    for (i = 0; i < LONG_RUNS; i++) {
        const long_run *l = long_runs + i;
        error[i] = run_error(m, l->f, l->n, l->y0, l->t_end, tol, l->wanted, evals);
        check_error(l->name, m->name, "tol", error[i], l->bounds[is_float][method_index], l->t_end, tol);
    }
}

/* A tolerance 100 times smaller: 100^(1/order) times the steps, and about a hundredth of the error; at least it falls
   to a twentieth by rk45, to a tenth by rk87. In float rounding hides the fall of the error. */
static void test_proportionality(void)
{
    static const double least_fall[METHODS] = {20, 10}, least_tol[2][METHODS] = {{1e-9, 1e-9}, {1e-5, 1e-3}};
    int i, k;
    for (i = 0; i < METHODS; i++) {
        double tol = is_float ? 1e-3 : 1e-5, last[LONG_RUNS], error[LONG_RUNS];
        long evals, last_evals;
        run_long(i, tol, last, &last_evals);
        for (tol /= 100; tol > least_tol[is_float][i] / 2; tol /= 100) {
            run_long(i, tol, error, &evals);
            CHECK(fabs(log((double)evals / (double)last_evals) / log(100.) * methods[i].order - 1) < 0.35);
            for (k = 0; k < LONG_RUNS; k++) {
                if (!is_float) CHECK(last[k] * 100 > least_fall[i] * error[k]);
                last[k] = error[k];
            }
            last_evals = evals;
        }
    }
}

int main(void)
{
    test_orders();
    test_known_solutions();
    test_detest_ends();
    test_detest();
    test_detest_jumps();
    test_sign();
    test_many_periods();
    test_proportionality();
    return check_finish("pairs");
}
