/* What jacobi.h, ateb.h and integrators.h refuse: numbers and pointers that are none, options that contradict
   themselves, right-hand sides that stop or cease to be numbers. The outputs must stay as they were. */
#include "refusals.h"
#include "valid_objects.h"

/* ---- Special functions ---- */

static int agm_sncndn(trial *a)
{
    const vm_real u = next(a), m = next(a);
    vm_real sn, cn, dn;
    jacobi_agm_sncndn(u, m, 8, &sn, &cn, &dn);
    return cn == cn && dn == dn ? value(a, sn) : -1;
}

static int mean(trial *a)
{
    const vm_real alpha = next(a), p = next(a), q = next(a);
    return value(a, ateb_mean(alpha, p, q));
}

static int phase(trial *a)
{
    const vm_real sa = next(a), ca = next(a), alpha = next(a);
    return value(a, ateb_phase(sa, ca, alpha));
}

static int saca_nm(trial *a)
{
    const vm_real s = next(a), n = next(a), m = next(a);
    vm_real sa, ca;
    ateb_saca_nm(s, n, m, &sa, &ca);
    return ca == ca ? value(a, sa) : -1;
}

/* The parameters of the beta functions may be infinite (tests/test_ateb.c): only x, y and p, q are spoiled here. */
static int beta_inc(trial *a) { return value(a, ateb_beta_inc(next(a), 2, 3)); }

static int ln_beta_inc(trial *a) { return value(a, ateb_ln_beta_inc(next(a), 2, 3)); }

static int beta_inc_both(trial *a)
{
    const vm_real x = next(a), y = next(a);
    vm_real lower, upper;
    ateb_beta_inc_both(x, y, 2, 3, &lower, &upper);
    return upper == upper ? value(a, lower) : -1;
}

static int beta_inc_inv_both(trial *a)
{
    const vm_real p = next(a), q = next(a);
    vm_real lower, upper, ln;
    ateb_beta_inc_inv_both(p, q, 2, 3, &lower, &upper, &ln);
    return upper == upper && ln == ln ? value(a, lower) : -1;
}

static int mean_nm(trial *a)
{
    const vm_real n = next(a), m = next(a), p = next(a), q = next(a);
    return value(a, ateb_mean_nm(n, m, p, q, 0));
}

static void test_special_functions(void)
{
    REFUSES(agm_sncndn, 0, 1, R(0.5));
    REFUSES(mean, 0, 3, 2, 2);
    REFUSES(phase, 0, R(0.5), R(0.7), 3);
    REFUSES(saca_nm, 0, R(0.5), 2, 3);
    REFUSES(beta_inc, 0, R(0.5));
    REFUSES(ln_beta_inc, 0, R(0.5));
    REFUSES(beta_inc_both, 0, R(0.5), R(0.5));
    REFUSES(beta_inc_inv_both, 0, R(0.5), R(0.5));
    REFUSES(mean_nm, 0, 2, 3, 2, 2);
    CHECK(isnan(ateb_beta_inc(R(0.5), VM_NAN, 3)) && isnan(ateb_beta_inc(R(0.5), 2, VM_NAN)));
    CHECK(isnan(ateb_beta_inc_inv(R(0.5), VM_NAN, 3)) && isnan(ateb_beta_inc_inv(R(0.5), 2, VM_NAN)));
    CHECK(isnan(ateb_ln_beta_inc(R(0.5), VM_NAN, 3)) && isnan(ateb_ln_beta_inc(R(0.5), 2, VM_NAN)));
    CHECK(isnan(ateb_ln_beta(VM_NAN, 3)) && isnan(ateb_ln_beta(2, VM_NAN)) && isnan(ateb_ln_beta(-1, 3)));
    CHECK(isnan(ateb_mean_nm(2, 3, 2, 2, -1)) && isnan(ateb_mean_nm(2, 3, 2, 2, 4)));
    CHECK(isnan(ateb_mean(3, 2, -1)) && isnan(ateb_mean(3, -1, 2)) && isnan(ateb_pi_nm(2, -1)));
    CHECK(isnan(ateb_mean_nm(1, 2, R(0.5), R(-1.5), 0)) && isnan(ateb_mean_nm(1, 2, R(-1.5), R(0.5), 0)));
}

static void test_jacobi_domain(void)
{
    vm_real sn, cn, dn;
    CHECK(isnan(jacobi_solve_K(VM_NAN)) && isnan(jacobi_solve_K(-1)) && isnan(jacobi_solve_K_m1(VM_NAN)));
    CHECK(isnan(jacobi_solve_K(VM_INFINITY)) && isnan(jacobi_solve_K_m1(VM_INFINITY)));
    CHECK(isnan(jacobi_agm_K(VM_NAN)) && isnan(jacobi_agm_K(2)) && isnan(jacobi_agm_K(-VM_INFINITY)));
    CHECK(jacobi_agm_K(1) == VM_INFINITY);
    jacobi_agm_sncndn(1, 1, 8, &sn, &cn, &dn);
    CHECK(isnan(sn) || fabs((double)sn - tanh(1)) < 4 * (double)VM_EPSILON);
}

/* Does this compiler and this machine compute as the headers need? Only then the other tests mean something. */
static void test_self_check(void) { CHECK(vm_self_check() == 1); }

/* Carlson's integrals of numbers that are negative, 0, infinite, or so far apart that a scale loses one of them */
static void test_carlson_domain(void)
{
    const vm_real tiny = VM_MIN, huge = VM_MAX / 8, inf = VM_INFINITY;
    CHECK(isnan(jacobi_RF(1, -1, 2)) && isnan(jacobi_RD(1, -1, 2)) && isnan(jacobi_RJ(1, -1, 2, 3)));
    CHECK(isnan(jacobi_RJ(1, 2, -1, 3)) && isnan(jacobi_RJ(1, 2, 3, VM_NAN)));
    CHECK(jacobi_RJ(0, 0, 1, 2) == inf && jacobi_RJ(1, 0, 0, 2) == inf && jacobi_RJ(0, 1, 0, 2) == inf);
    CHECK(jacobi_RJ(1, 2, 3, 0) == inf && jacobi_RJ(1, inf, 3, 2) == 0 && isnan(jacobi_RJ(inf, 2, 3, 0)));
    CHECK(isnan(jacobi_RD(1, tiny, huge)) && isnan(jacobi_RD(tiny, 1, huge)) && isnan(jacobi_RD(1, huge, tiny)));
    CHECK(isnan(jacobi_RJ(1, tiny, huge, 2)) && isnan(jacobi_RJ(tiny, 1, huge, 2)) && isnan(jacobi_RJ(huge, 1, tiny, 2)));
    CHECK(isnan(jacobi_RJ(1, 2, huge, tiny)));
}

/* Pi where its characteristic n, m or the angle is infinite: 0, infinity or NaN, as the comments say */
static void test_Pi_domain(void)
{
    const vm_real inf = VM_INFINITY, half = R(0.5);
    CHECK(jacobi_Pi(inf, half) == 0 && jacobi_Pi(-inf, half) == 0 && isnan(jacobi_Pi(inf, 1)));
    CHECK(jacobi_Pi(half, -inf) == 0 && isnan(jacobi_Pi(2, -inf)) && isnan(jacobi_Pi(inf, -inf)));
    CHECK(isnan(jacobi_Pi(half, 2)) && isnan(jacobi_Pi(VM_NAN, half)));
    CHECK(jacobi_Pi_incomplete(1, inf, half) == 0 && jacobi_Pi_incomplete(1, half, -inf) == 0);
    CHECK(jacobi_Pi_incomplete(inf, half, half) == inf && jacobi_Pi_incomplete(-inf, half, half) == -inf);
    CHECK(isnan(jacobi_Pi_incomplete(inf, inf, half)) && isnan(jacobi_Pi_incomplete(VM_NAN, inf, half)));
    CHECK(isnan(jacobi_Pi_incomplete(1, inf, 1)));
    CHECK(isnan(jacobi_Pi_incomplete(1, 2, -inf)));
}

/* The inverse functions where x or m is out of their domain, and at the limits of m */
static void test_inverse_domain(void)
{
    const vm_real inf = VM_INFINITY, half = R(0.5);
    CHECK(isnan(jacobi_inverse_sn(2, half)) && isnan(jacobi_inverse_cn(2, half)) && isnan(jacobi_inverse_dn(2, half)));
    CHECK(isnan(jacobi_inverse_sn(half, 2)) && isnan(jacobi_inverse_cn(half, 2)) && isnan(jacobi_inverse_dn(half, 2)));
    CHECK(jacobi_inverse_sn(half, -inf) == 0 && jacobi_inverse_cn(half, -inf) == 0);
    CHECK(jacobi_inverse_sn(1, 1) == inf && jacobi_inverse_sn(-1, 1) == -inf);
    CHECK(fabs((double)jacobi_inverse_sn(half, 1) - atanh(0.5)) < 8 * (double)VM_EPSILON);
    CHECK(jacobi_inverse_cn(0, 1) == inf && isnan(jacobi_inverse_cn(-half, 1)));
    CHECK(fabs((double)jacobi_inverse_cn(half, 1) - acosh(2)) < 8 * (double)VM_EPSILON);
    CHECK(jacobi_inverse_dn(0, 1) == inf && jacobi_inverse_dn(1, half) == 0);
    CHECK(fabs((double)jacobi_inverse_dn(half, 1) - acosh(2)) < 8 * (double)VM_EPSILON);
}

/* Angles of so many turns that their last digit is more than a turn: the integrals grow as their mean does. */
static void test_many_turns(void)
{
    const vm_real turns = 4 / (VM_EPSILON * VM_EPSILON), m = R(0.5);
    const double K = (double)jacobi_K(m), E = (double)jacobi_E(m), quarters = (double)turns / (acos(-1) / 2);
    CHECK(fabs((double)jacobi_F(turns, m) / (quarters * K) - 1) < 8 * (double)VM_EPSILON);
    CHECK(fabs((double)jacobi_F(-turns, m) / (quarters * K) + 1) < 8 * (double)VM_EPSILON);
    CHECK(fabs((double)jacobi_E_incomplete(turns, m) / (quarters * E) - 1) < 8 * (double)VM_EPSILON);
}

/* Incomplete beta functions of x and y that do not add up to 1, or are not between 0 and 1 */
static void test_beta_domain(void)
{
    vm_real p, q, ln;
    ateb_beta_inc_both(R(0.5), R(0.25), 2, 3, &p, &q);
    CHECK(isnan(p) && isnan(q));
    ateb_beta_inc_inv_both(R(0.5), R(0.25), 2, 3, &p, &q, &ln);
    CHECK(isnan(p) && isnan(q) && isnan(ln));
    ateb_beta_inc_both(R(-0.5), R(1.5), 2, 3, &p, &q);
    CHECK(isnan(p) && isnan(q));
    CHECK(isnan(ateb_ln_beta(R(1e31), 2)) && isnan(ateb_ln_beta(2, R(1e31))));
}

/* ---- Integrators ---- */

/* No two statuses have the same text. */
static void test_texts(void)
{
    int status, other;
    for (status = ODE_STEP_TOO_SMALL; status <= ODE_STIFF + 2; status++)
        for (other = status + 1; other <= ODE_STIFF; other++)
            CHECK(strcmp(ode_strerror(status), ode_strerror(other)) != 0);
}

static void test_rk4(void)
{
    vm_real y[2] = {1, 0}, low[2] = {0}, t = 0, work[RK4_WORK(2)];
    CHECK(rk4_step(oscillate, NULL, 2, VM_NAN, 1, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(oscillate, NULL, 2, 0, VM_INFINITY, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(oscillate, NULL, 2, 0, 1, NULL, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(oscillate, NULL, 2, 0, 1, y, NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(NULL, NULL, 2, 0, 1, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(oscillate, NULL, 2, NULL, 1, 10, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(oscillate, NULL, 2, &t, VM_NAN, 10, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve_compensated(oscillate, NULL, 2, NULL, 1, 10, y, low, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve_compensated(oscillate, NULL, 2, &t, VM_INFINITY, 10, y, low, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve_compensated(oscillate, NULL, 0, &t, 1, 10, y, low, work) == ODE_BAD_ARGUMENT);
    CHECK(y[0] == 1 && y[1] == 0 && t == 0);
}

/* Options that make no sense, one after another */
static void test_options(void)
{
    const struct {
        vm_real h0, h_min, h_max, rtol, atol;
        int n_events; /* of a list that is null */
    } bad[] = {{VM_NAN, 0, 0, 0, 0, 0},      {0, -1, 0, 0, 0, 0},     {0, 0, -1, 0, 0, 0}, {0, 2, 1, 0, 0, 0},
               {0, 0, 0, VM_INFINITY, 0, 0}, {0, 0, 0, 0, VM_NAN, 0}, {0, 0, 0, 0, 0, -1}, {0, 0, 0, 0, 0, 1}};
    const vm_real y[2] = {1, 0};
    vm_real work[RK45_WORK(2)];
    size_t i;
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        rk45_options o;
        rk45 s;
        memset(&o, 0, sizeof o);
        o.h0 = bad[i].h0;
        o.h_min = bad[i].h_min;
        o.h_max = bad[i].h_max;
        o.rtol = bad[i].rtol;
        o.atol = bad[i].atol;
        o.n_events = bad[i].n_events;
        CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, &o, work) == ODE_BAD_ARGUMENT);
    }
}

/* Null pointers, and states of the other integrator */
static void test_adaptive(void)
{
    const vm_real y[2] = {1, 0};
    vm_real work[RK87_WORK(2)], out[2] = {0};
    rk45 s;
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, NULL, work) == ODE_OK && rk45_step(&s) == ODE_OK);
    CHECK(rk45_interpolate(NULL, 0, out) == ODE_BAD_ARGUMENT && rk45_interpolate(&s, 0, NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk87_interpolate(&s, 0, out) == ODE_BAD_ARGUMENT);
    CHECK(rk45_solve_with(NULL, oscillate, 2, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk87_init(&s, oscillate, NULL, 2, 0, y, NULL, work) == ODE_OK && rk87_step(&s) == ODE_OK);
    CHECK(rk87_interpolate(NULL, 0, out) == ODE_BAD_ARGUMENT && rk87_interpolate(&s, 0, NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk45_interpolate(&s, 0, out) == ODE_BAD_ARGUMENT);
    CHECK(rk87_solve_with(NULL, oscillate, 2, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk87_solve_with(&s, oscillate, 2, 1) == ODE_OK && s.t == 1);
    CHECK(out[0] == 0 && out[1] == 0);
}

/* ---- Right-hand sides and events that break ---- */

static long good_evaluations; /* how many are left until the right-hand side breaks */

/* x'' = -x, until it stops with a status, or, where ctx is not null, ceases to be a number */
static int breaks(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    oscillate(t, y, dydt, NULL);
    good_evaluations--;
    if (good_evaluations >= 0) return 0;
    if (!ctx) return 9;
    dydt[0] = VM_NAN;
    return 0;
}

/* At each of the first evaluations: the status says what happened, and the state stays a number. */
static void check_broken_runs(int ceases)
{
    int evaluation;
    void *ctx = ceases ? &evaluation : NULL;
    for (evaluation = 0; evaluation < 60; evaluation++) {
        vm_real y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
        const int wanted = evaluation < 12 ? ODE_RHS_STOPPED : ODE_OK;
        good_evaluations = evaluation;
        CHECK(ceases || rk4_solve(breaks, ctx, 2, &t, 1, 3, y, work) == wanted);
    }
    for (evaluation = 0; evaluation < 60; evaluation++) {
        const vm_real y[2] = {1, 0};
        vm_real work[RK87_WORK(2)], out[2];
        int status;
        rk45 s;
        good_evaluations = evaluation;
        if (rk45_init(&s, breaks, ctx, 2, 0, y, NULL, work) == 0) {
            status = rk45_solve(&s, 1);
            CHECK(status == (ceases ? ODE_NOT_FINITE : ODE_RHS_STOPPED) || status == ODE_OK);
            CHECK(isfinite((double)s.y[0]) && isfinite((double)s.t));
        }
        good_evaluations = evaluation;
        if (rk87_init(&s, breaks, ctx, 2, 0, y, NULL, work) == 0 && rk87_step(&s) == 0) {
            out[0] = 7;
            status = rk87_interpolate(&s, s.t / 2, out);
            CHECK(status == ODE_OK || out[0] == 7);
        }
    }
}

static void test_broken_right_hand_sides(void)
{
    check_broken_runs(0);
    check_broken_runs(1);
}

static vm_real no_number(vm_real t, const vm_real *y, void *ctx)
{
    (void)ctx;
    return t < R(0.1) ? y[0] : VM_NAN;
}

static void test_broken_event(void)
{
    const vm_real y[2] = {1, 0};
    vm_real work[RK45_WORK(2)];
    rk45_options o;
    ode_event e;
    rk45 s;
    memset(&e, 0, sizeof e);
    memset(&o, 0, sizeof o);
    e.g = no_number;
    o.events = &e;
    o.n_events = 1;
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, &o, work) == ODE_OK && rk45_solve(&s, 1) == ODE_NOT_FINITE);
}

/* A first step that is longer than the longest is cut to it. */
static void test_first_step(void)
{
    const vm_real y[2] = {1, 0};
    vm_real work[RK45_WORK(2)];
    rk45_options o;
    rk45 s;
    memset(&o, 0, sizeof o);
    o.h0 = R(1e-3);
    o.h_max = R(1e-4);
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK);
    CHECK(s.t <= R(1e-4));
}

int main(int argc, char **argv)
{
    read_refusal_rounds(argc, argv);
    test_special_functions();
    test_self_check();
    test_jacobi_domain();
    test_carlson_domain();
    test_Pi_domain();
    test_inverse_domain();
    test_many_turns();
    test_beta_domain();
    test_texts();
    test_rk4();
    test_options();
    test_adaptive();
    test_broken_right_hand_sides();
    test_broken_event();
    test_first_step();
    return check_finish("refusals numerics");
}
