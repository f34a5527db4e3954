/* The dissertation's tables and numbers: reference cases R1 to R5 and Table 5 in 25 digits, examples 1 and 2, and the
   amplitude laws against direct integration. The printed numbers and forms that are wrong must fail, by the amounts by
   which they are known to be off. */
#include "../examples/envelope.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

/* ---- R1, R2, R3: the inputs are decimals, so half an eps of s, u and alpha is allowed ---- */

static void test_constants(void)
{
    static const struct {
        const char *name;
        double alpha, pi, omega, m, omega1;
    } cases[] = {
#include "data/r1_constants.h"
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        vm_real alpha = R(cases[i].alpha);
        check_error("Pi_alpha (277)", "R1", "eps", fabs((double)ateb_pi(alpha) / cases[i].pi - 1) / eps, 2,
                    cases[i].alpha, 0);
        check_error("Omega_a (293)", "R1", "eps", fabs((double)vm_osc_omega_trig(alpha) / cases[i].omega - 1) / eps,
                    3, cases[i].alpha, 0);
        check_error("k^2 (307)", "R1", "eps", ERROR_EPS(vm_osc_jacobi_parameter(alpha), cases[i].m, 0, 1), 8,
                    cases[i].alpha, 0);
        check_error("Omega_1* (300)", "R1", "eps",
                    fabs((double)vm_osc_omega_jacobi(alpha) / cases[i].omega1 - 1) / eps, 6, cases[i].alpha, 0);
    }
}

static void test_ateb_cases(void)
{
    static const struct {
        const char *name;
        double alpha, s, sa, ca;
    } cases[] = {
#include "data/r2_ateb.h"
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        double s = cases[i].s, alpha = cases[i].alpha, slope = 2 / (alpha + 1);
        vm_real sa, ca;
        ateb_saca(R(s), R(alpha), &sa, &ca);
        check_error("sa", "R2", "eps*", ERROR_EPS(sa, cases[i].sa, 0, 4 + fabs(s)), 1, s, alpha);
        check_error("ca", "R2", "eps*", ERROR_EPS(ca, cases[i].ca, 0, 4 + slope * fabs(s)), 1, s, alpha);
    }
}

static void test_jacobi_cases(void)
{
    static const struct {
        const char *name;
        double u, m1, sn, cn, dn;
    } cases[] = {
#include "data/r3_jacobi.h"
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        double u = cases[i].u, m1 = cases[i].m1, kp = m1 > 1 ? sqrt(m1) : 1, moved = 4 + fabs(u) * kp;
        vm_real sn, cn, dn;
        jacobi_sncndn_m1(R(u), R(m1), &sn, &cn, &dn);
        check_error("sn", "R3", "eps*", ERROR_EPS(sn, cases[i].sn, 0, moved), 1, u, m1);
        check_error("cn", "R3", "eps*", ERROR_EPS(cn, cases[i].cn, 0, moved), 1, u, m1);
        check_error("dn", "R3", "eps*", ERROR_EPS(dn, cases[i].dn, 0, moved * kp), 1, u, m1);
    }
}

/* ---- Table 5 ---- */

static void test_table5(void)
{
    static const struct {
        double alpha, printed[3], exact[3];
    } table[] = {
#include "../examples/table5_data.h"
    };
    static const double listed[17] = {0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8, 1.1, 1.2, 1.4, 1.8, 1.9, 20, 40, 50, 70, 80};
    const char *names[] = {"Omega_alpha", "k^2", "Omega_1*"};
    int i, k, rows_off = 0, numbers_off = 0, gross = 0;
    for (i = 0; i < 38; i++) {
        vm_real kit[3], alpha = R(table[i].alpha);
        int off = 0;
        kit[0] = vm_osc_omega_trig(alpha);
        kit[1] = vm_osc_jacobi_parameter(alpha);
        kit[2] = vm_osc_omega_jacobi(alpha);
        for (k = 0; k < 3; k++) {
            double defect = 1e6 * (table[i].printed[k] - table[i].exact[k]);
            check_error(names[k], "Table 5", "eps", ERROR_EPS(kit[k], table[i].exact[k], 0, 1), 8, table[i].alpha,
                        0);
            off += fabs(defect) > 0.5;
            gross += fabs(defect) > 1;
            if (fabs(defect) > 1) CHECK(fabs(table[i].alpha - 1.4) < 1e-9 && k == 2 && fabs(defect + 2.85) < 0.01);
        }
        if (off > 0) CHECK(rows_off < 17 && listed[rows_off] == table[i].alpha);
        rows_off += off > 0;
        numbers_off += off;
    }
    CHECK(sizeof table / sizeof *table == 38);
    ERRATUM("Table 5", rows_off == 17 && numbers_off == 24 && gross == 1,
            check_holds("Omega_alpha") && check_holds("k^2") && check_holds("Omega_1*"));
}

/* ---- R5: period (262), largest velocity (267), that of the trigonometric approximation (296) ---- */

static void test_generating_solutions(void)
{
    static const struct {
        double alpha, x0, omega0, period, vmax, trig_vmax;
    } cases[] = {
        {0.1, 1.7, 0.8, 9.080033753599587592875157, 1.444293806887822731554391, 1.176362920233735435001136},
        {1.5, 1, 1, 6.58136338863826306517647, 0.8944271909999158785636695, 0.9546935697285100028891008},
        {4. / 3, 0.1, 1, 9.515931169560334520388257, 0.0630753891349489737782353, 0.06602806593723910982961226},
        {3, 1, 1, 7.416298709205487673735401, 0.7071067811865475244008444, 0.8472130847939790866064991},
        {10, 1.7, 0.8, 1.206831227946716984557309, 6.315063324649768056210201, 8.850794357035724653272729},
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        double alpha = cases[i].alpha, trig;
        vm_real x0 = R(cases[i].x0), omega0 = R(cases[i].omega0);
        trig = (double)(vm_osc_omega_trig(R(alpha)) * omega0 * VM_LIBM(pow)(x0, (R(alpha) + 1) / 2));
        check_error("period (262)", "R5", "eps",
                    fabs((double)vm_osc_period(x0, omega0, R(alpha)) / cases[i].period - 1) / eps, 6, alpha, 0);
        check_error("vmax (267)", "R5", "eps",
                    fabs((double)vm_osc_vmax(x0, omega0, R(alpha)) / cases[i].vmax - 1) / eps, 8, alpha, 0);
        check_error("trig vmax (296)", "R5", "eps", fabs(trig / cases[i].trig_vmax - 1) / eps, 8, alpha, 0);
    }
    /* (356): 66.028 is right; and the comparison (268) of item 36 */
    check_error("(356)", "", "1e-6",
                1e6 * fabs(100 * pow(0.1, 1. / 6) * (double)vm_osc_omega_trig(R(4. / 3)) - 66.02806593723911),
                is_float ? 30 : 1e-6, 4. / 3, 0);
    check_error("(296)/(267)", "", "1e-6",
                1e6 * fabs((double)(vm_osc_omega_trig(3) / vm_osc_vmax(1, 1, 3)) - 1.198140), 1, 3, 0);
}

/* ---- examples 1 and 2, and the amplitude laws ---- */

/* to the two digits that are stated; in float the integration's own error is 1e-3 */
static void check_stated(double measured, double stated)
{
    if (!is_float || stated > 1e-2) CHECK(fabs(measured / stated - 1) < (is_float ? 0.1 : 0.05));
}

static void test_examples(void)
{
    const oscillator cubic = {3, 1}, root = {R(1.5), 2};
    envelope one[] = {{"corrected", 1. / 6, 0.70710678, 5. / 6, 0, 0},
                      {"(400)", 0.5, 0.84721, 1.5, 0, 0},
                      {"(401)", 0.15625, 0.70711, 0.8125, 0, 0},
                      {"(335) mended", 1. / 6, 0.84721308, 5. / 6, 0, 0}};
    envelope two[] = {{"corrected", 2. / 9, 0.89442719, 7. / 9, 0, 0},
                      {"(403)", 1. / 9, 0.89442719, 3.5 / 9, 0, 0}};
    int points, right;
    one[0].a = -log((double)vm_osc_amplitude_law(2, 0, 1, 3)) / log(2);
    one[0].v = -log((double)vm_osc_velocity_law(2, 0, 1, 3)) / log(2);
    two[0].a = -log((double)vm_osc_amplitude_law(2, 0, 1, R(1.5))) / log(2);
    two[0].v = -log((double)vm_osc_velocity_law(2, 0, 1, R(1.5))) / log(2);
    CHECK(envelope_errors(&cubic, 50, one, 4, NULL, &points) == ODE_OK && points == 13);
    check_stated(one[0].amplitude_error, 1.4e-4);
    check_stated(one[0].velocity_error, 5.4e-4);
    check_stated(one[1].amplitude_error, 0.426);
    check_stated(one[1].velocity_error, 0.632);
    check_stated(one[2].amplitude_error, 1.7e-2);
    check_stated(one[2].velocity_error, 3.7e-2);
    check_stated(one[3].amplitude_error, 1.4e-4);
    check_stated(one[3].velocity_error, 0.198);
    right = one[0].amplitude_error < (is_float ? 5e-3 : 2e-4) && one[0].velocity_error < (is_float ? 5e-3 : 6e-4);
    ERRATUM("(400)", one[1].amplitude_error > 0.4 && one[1].velocity_error > 0.6, right);
    ERRATUM("(401)", one[2].amplitude_error > 0.01 && one[2].velocity_error > 0.03, right);
    /* of the three solutions the trigonometric one, though corrected, is not appropriate: its velocity */
    ERRATUM("text end of 7.4.3, 7.8 intro", one[3].velocity_error > 0.19, right);
    CHECK(envelope_errors(&root, 50, two, 2, NULL, &points) == ODE_OK && points == 9);
    check_stated(two[0].amplitude_error, 1.3e-4);
    check_stated(two[0].velocity_error, 6.4e-4);
    check_stated(two[1].amplitude_error, 0.372);
    check_stated(two[1].velocity_error, 2.54);
    right = two[0].amplitude_error < (is_float ? 5e-3 : 2e-4) && two[0].velocity_error < (is_float ? 5e-3 : 7e-4);
    ERRATUM("(403)", two[1].amplitude_error > 0.3 && two[1].velocity_error > 2, right);
}

/* m x'' + x|x|^(alpha-1) = -(r m' + b) x', m = 1 + m' t; ctx is {alpha, m', r, b} */
static int slow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real *p = (const vm_real *)ctx;
    dydt[0] = y[1];
    dydt[1] = -(VM_COPYSIGN(VM_LIBM(pow)(VM_FABS(y[0]), p[0]), y[0]) + (p[2] * p[1] + p[3]) * y[1]) / (1 + p[1] * t);
    return 0;
}

/* |x| at the last turning point before t_end, and its time */
static double last_amplitude(const vm_real *p, double t_end, double *t)
{
    vm_real ctx[4], y0[2] = {1, 0}, y[2], last = -1, work[RK45_WORK(2)];
    rk45_options o = {0};
    rk45 s;
    double amplitude = 1;
    memcpy(ctx, p, sizeof ctx);
    o.rtol = o.atol = is_float ? R(3e-6) : R(1e-11);
    rk45_init(&s, slow_rhs, ctx, 2, 0, y0, &o, work);
    for (*t = 0; (double)s.t < t_end;) {
        if (rk45_step(&s) != ODE_OK) return -1;
        if ((s.y[1] > 0) != (last > 0)) {
            *t = (double)zero_in_step(&s, 1);
            rk45_interpolate(&s, R(*t), y);
            amplitude = fabs((double)y[0]);
        }
        last = s.y[1];
    }
    return amplitude;
}

/* The law with full reactive force, with none, and with damping, against direct integration. The printed exponents with
   5 - alpha, (342)-(344), (360), (367), have a wrong sign from (335); they differ unless alpha = 1. */
enum { REACTIVE, NOT_REACTIVE, DAMPED, KINDS };

static void check_amplitude_law(double alpha, int kind)
{
    static const char *const names[KINDS] = {"reactive", "not reactive", "damping"};
    const double b = kind == DAMPED ? 0.01 : 0, rate = kind == DAMPED ? 0 : 0.01;
    const vm_real reactive = R(kind == REACTIVE);
    double t, A, law, printed, m, D;
    vm_real p[4];
    p[0] = R(alpha);
    p[1] = R(rate);
    p[2] = reactive;
    p[3] = R(b);
    A = last_amplitude(p, 100, &t);
    m = 1 + rate * t;
    D = b * t; /* the mass is 1 where there is damping */
    law = (double)vm_osc_amplitude_law(R(m), R(D), reactive, R(alpha));
    check_error("amplitude law", names[kind], "1e-6", 1e6 * fabs(law / A - 1), is_float ? 3e4 : 10, alpha, t);
    if (alpha == 1 || is_float) return;
    printed = pow(m, (kind == REACTIVE ? -1 : 1) / (5 - alpha)) * exp(-2 * D / (5 - alpha));
    CHECK(fabs(printed / A - 1) > 0.02);
}

static void test_amplitude_law(void)
{
    static const double alphas[] = {0.5, 1, 4. / 3, 2, 3, 4};
    double corrected_403;
    int i, kind;
    for (i = 0; i < 6; i++)
        for (kind = REACTIVE; kind < KINDS; kind++) check_amplitude_law(alphas[i], kind);
    CHECK(fabs((double)vm_osc_amplitude_law(6, 0, 1, 3) - 0.7418363755904023) < 4 * eps);
    CHECK(fabs((double)vm_osc_velocity_law(6, 0, 1, 3) - 0.2246676924328796) < 4 * eps);
    corrected_403 = (double)vm_osc_amplitude_law(36, 0, 1, R(1.5)); /* at t = 50 */
    CHECK(fabs(corrected_403 - 0.4509776298725563) < 4 * eps);
}

int main(void)
{
    test_constants();
    test_ateb_cases();
    test_jacobi_cases();
    test_table5();
    test_generating_solutions();
    test_examples();
    test_amplitude_law();
    return check_finish("dissertation");
}
