/* jacobi.h against arbitrary-precision tables, identities, closed forms and the edges of its domain. */
#include "../jacobi.h"
#include "check.h"

static const int is_float = PRECISION[0] == 'f';

typedef struct jacobi_row {
    const char *region;
    int complement; /* the parameter is m1 = 1 - m */
    double u, m, sn, sn_low, cn, cn_low, dn, dn_low, K, K_low, E, E_low;
} jacobi_row;

static const jacobi_row jacobi_table[] = {
#include "data/jacobi_table.h"
};

/* The zeros of sn and cn lie where K in two words puts them, whose relative error is below 8 eps^2: what that makes
   of the value, |u| times the slope there, is allowed for. */
static void check_relative(const char *function, const jacobi_row *row, double got, double high, double low,
                           double period)
{
    double ulp = ULP(high), eps = (double)VM_EPSILON, m1 = row->complement ? row->m : 1 - row->m;
    double error = ERROR_ULP(got, high, low) - 8 * eps * eps * fabs(row->u) * sqrt(fmax(1, m1)) / ulp;
    error = fmax(error, 0);
    if (period < 4) check_error(function, row->region, "ulp", error, 16, row->u, row->m);
    else check_error(function, row->region, "ulp/K", error / period, 5, row->u, row->m);
}

/* Absolute errors to |u| = 1e9 (float 1e4); relative ones to 100 K. Towards m = 1 (and m = -infinity, which is m1 = 1
   by K(m) k' = K(m/(m-1))) an error of eps in the phase at the foot of the ladder is one of K eps in u. */
static void check_sncndn(const jacobi_row *row)
{
    double m1 = row->complement ? row->m : 1 - row->m, largest_dn = m1 > 1 ? sqrt(m1) : 1;
    double period = isfinite(row->K) ? row->K * largest_dn : 0;
    vm_real sn, cn, dn, u = (vm_real)row->u, m = (vm_real)row->m;
    if (fabs(row->u) > row->K / (double)VM_EPSILON) return; /* no phase left */
    if (row->complement) jacobi_sncndn_m1(u, m, &sn, &cn, &dn);
    else jacobi_sncndn(u, m, &sn, &cn, &dn);
    check_error("sn", row->region, "eps", ERROR_EPS(sn, row->sn, row->sn_low, 1), 5, row->u, row->m);
    check_error("cn", row->region, "eps", ERROR_EPS(cn, row->cn, row->cn_low, 1), 5, row->u, row->m);
    check_error("dn", row->region, "eps", ERROR_EPS(dn, row->dn, row->dn_low, largest_dn), 5, row->u, row->m);
    if (fabs(row->u) <= 100 * row->K) {
        check_relative("sn", row, (double)sn, row->sn, row->sn_low, period);
        check_relative("cn", row, (double)cn, row->cn, row->cn_low, period);
        check_relative("dn", row, (double)dn, row->dn, row->dn_low, period);
    }
}

static void check_complete(const jacobi_row *row)
{
    vm_real m = (vm_real)row->m;
    vm_real K = row->complement ? jacobi_K_m1(m) : jacobi_K(m);
    vm_real E = row->complement ? jacobi_E_m1(m) : jacobi_E(m);
    if (isfinite(row->K)) check_error("K", row->region, "ulp", ERROR_ULP(K, row->K, row->K_low), 5, row->m, 0);
    else CHECK(K == VM_INFINITY);
    if (!row->complement && fabs(row->m) < 1e30 &&
        isfinite(row->K)) /* 1 - m is rounded: twice half an ulp and more */
        check_error("k'K", row->region, "ulp", ERROR_ULP(jacobi_kpK(m), sqrt(1 - row->m) * row->K, 0), 5, row->m,
                    0);
    check_error("E", row->region, "ulp", ERROR_ULP(E, row->E, row->E_low), 6, row->m, 0);
}

static void test_table(void)
{
    size_t i;
    for (i = 0; i < sizeof jacobi_table / sizeof *jacobi_table; i++) {
        const jacobi_row *row = jacobi_table + i;
        if (!representable(row->u) || !representable(row->m)) continue;
        check_sncndn(row);
        check_complete(row);
    }
}

static void test_identities(void)
{
    int i, symmetric = 1;
    for (i = 0; i < 20000; i++) {
        vm_real u = (vm_real)uniform(-20, 20), m = (vm_real)(i % 2 ? uniform(0, 1) : uniform(-30, 1));
        vm_real sn, cn, dn, s2, c2, d2, largest = m < 0 ? 1 - m : 1;
        double K = (double)jacobi_K(m), E = (double)jacobi_E(m);
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        check_error("sn^2+cn^2-1", "random", "eps", ERROR_EPS(sn * sn + cn * cn, 1, 0, 1), 6, (double)u, (double)m);
        check_error("dn^2+m sn^2-1", "random", "eps", ERROR_EPS(dn * dn + m * sn * sn, 1, 0, (double)largest), 9,
                    (double)u, (double)m);
        jacobi_sncndn(-u, m, &s2, &c2, &d2);
        symmetric = symmetric && s2 == -sn && c2 == cn && d2 == dn;
        if (m > 0) { /* Legendre's relation */
            vm_real K1 = jacobi_K_m1(m), E1 = jacobi_E_m1(m);
            check_error("Legendre", "random", "eps",
                        ERROR_EPS(E * (double)K1 + (double)E1 * K - K * (double)K1, 1.5707963267948966, 6.1e-17,
                                  K * (double)K1),
                        8, (double)m, 0);
        }
    }
    CHECK(symmetric);
}

static void test_closed_forms(void)
{
    int i;
    for (i = 0; i < 200; i++) {
        vm_real sn, cn, dn, u = (vm_real)uniform(-6, 6);
        jacobi_sncndn(u, 0, &sn, &cn, &dn);
        check_error("sn = sin", "m = 0", "eps", ERROR_EPS(sn, sin((double)u), 0, 1), 2, (double)u, 0);
        check_error("cn = cos", "m = 0", "eps", ERROR_EPS(cn, cos((double)u), 0, 1), 2, (double)u, 0);
        CHECK(dn == 1);
        jacobi_sncndn(u, 1, &sn, &cn, &dn);
        check_error("sn = tanh", "m = 1", "eps", ERROR_EPS(sn, tanh((double)u), 0, 1), 4, (double)u, 1);
        check_error("cn = sech", "m = 1", "eps", ERROR_EPS(cn, 1 / cosh((double)u), 0, 1), 4, (double)u, 1);
    }
    check_error("K(0) = pi/2", "m = 0", "ulp", ERROR_ULP(jacobi_K(0), (double)(VM_PI / 2), 0), 1, 0, 0);
    check_error("E(0) = pi/2", "m = 0", "ulp", ERROR_ULP(jacobi_E(0), (double)(VM_PI / 2), 0), 1, 0, 0);
}

static void test_solver_table(void)
{
    static const struct {
        double c, m1, m1_low, m, m_low;
    } table[] = {
#include "data/solver_table.h"
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        vm_real m = jacobi_solve_kpK((vm_real)table[i].c), m1 = jacobi_solve_kpK_m1((vm_real)table[i].c);
        check_error("solve_kpK_m1", "table", "ulp", ERROR_ULP(m1, table[i].m1, table[i].m1_low), 4, table[i].c, 0);
        check_error("solve_kpK", "table", "eps",
                    ERROR_EPS(m, table[i].m, table[i].m_low, fmax(1, fabs(table[i].m))), 6, table[i].c, 0);
    }
}

static void test_solver(void)
{
    double c;
    for (c = 1e-3; c < 40; c *= 1.07) {
        vm_real target = (vm_real)c, m = jacobi_solve_kpK(target), m1 = jacobi_solve_kpK_m1(target);
        check_error("k'K(solve_m1)", m < 0 ? "m < 0" : "m > 0", "ulp",
                    ERROR_ULP(VM_SQRT(m1) * jacobi_K_m1(m1), (double)target, 0), 8, c, (double)m);
        check_error("solve - solve_m1", m < 0 ? "m < 0" : "m > 0", "eps",
                    ERROR_EPS(m, 1 - (double)m1, 0, 1 + (double)m1), 2, c, (double)m);
        CHECK(m <= 1 && (m < 0) == (target > VM_PI / 2));
    }
    /* limits of (307), alpha -> infinity and alpha -> 0, and the cubic oscillator */
    check_error("solve_kpK", "R1", "eps", ERROR_EPS(jacobi_solve_kpK(1), 0.8061926420529121671171836, 0, 1), 4, 1,
                0);
    check_error("solve_kpK", "R1", "eps", ERROR_EPS(jacobi_solve_kpK(2), -1.807854731049967665276571, 0, 2), 4, 2,
                0);
    check_error("solve_kpK", "R1", "eps",
                ERROR_EPS(jacobi_solve_kpK((vm_real)1.3110287771460599052324198), 0.5, 0, 1), 4, 1.311, 0);
    CHECK(jacobi_kpK(1) == 0 && jacobi_solve_kpK(0) == 1 && jacobi_solve_kpK_m1(0) == 0);
    CHECK(jacobi_solve_kpK((vm_real)1e4) == -VM_INFINITY);
    for (c = 1; c > 0; c /= 3) { /* down to where k' is subnormal and cannot be moved by its step */
        vm_real m1 = jacobi_solve_kpK_m1((vm_real)c);
        if ((double)m1 > 1e6 * (is_float ? (double)FLT_MIN : DBL_MIN))
            check_error("k'K(solve_m1)", "c -> 0", "ulp",
                        ERROR_ULP(VM_SQRT(m1) * jacobi_K_m1(m1), (double)(vm_real)c, 0), 8, c, 0);
        CHECK(m1 >= 0 && m1 < 1);
    }
}

static void test_domain(void)
{
    const vm_real bad_m[] = {(vm_real)1.0001, VM_NAN, VM_INFINITY, -VM_INFINITY}, ok = (vm_real)0.5;
    const vm_real bad_u[] = {VM_NAN, VM_INFINITY, -VM_INFINITY};
    vm_real sn, cn, dn, largest = VM_MAX;
    int i, in_range = 1;
    for (i = 0; i < 4; i++) {
        CHECK(jacobi_K(bad_m[i]) != jacobi_K(bad_m[i]));
        CHECK(jacobi_E(bad_m[i]) != jacobi_E(bad_m[i]));
        CHECK(jacobi_kpK(bad_m[i]) != jacobi_kpK(bad_m[i]));
        jacobi_sncndn(ok, bad_m[i], &sn, &cn, &dn);
        CHECK(sn != sn && cn != cn && dn != dn);
    }
    for (i = 0; i < 3; i++) {
        jacobi_sncndn(bad_u[i], ok, &sn, &cn, &dn);
        CHECK(sn != sn && cn != cn && dn != dn);
    }
    CHECK(jacobi_solve_kpK(-ok) != jacobi_solve_kpK(-ok) &&
          jacobi_solve_kpK(VM_INFINITY) != jacobi_solve_kpK(VM_INFINITY));
    CHECK(isnan(jacobi_solve_kpK_m1(VM_INFINITY)) && isnan(jacobi_solve_kpK_m1(-ok)) &&
          isnan(jacobi_solve_kpK(VM_NAN)));
    CHECK(isnan(jacobi_K_m1(-ok)) && isnan(jacobi_K_m1(VM_INFINITY)) && isnan(jacobi_E_m1(-ok)) &&
          isnan(jacobi_E_m1(VM_NAN)));
    jacobi_sncndn_m1(ok, -ok, &sn, &cn, &dn);
    CHECK(sn != sn && cn != cn && dn != dn);
    jacobi_sncndn_m1(ok, VM_INFINITY, &sn, &cn, &dn);
    CHECK(sn != sn && cn != cn && dn != dn);
    CHECK(jacobi_K(1) == VM_INFINITY && jacobi_E(1) == 1);
    jacobi_sncndn(jacobi_K(ok) * 2 / VM_EPSILON, ok, &sn, &cn,
                  &dn); /* from K/eps on there is no phase, before there is */
    CHECK(sn == 0 && cn == 1 && dn == 1);
    jacobi_sncndn(jacobi_K(ok) / 7 / VM_EPSILON, ok, &sn, &cn, &dn);
    CHECK(sn != 0);
    for (i = 0; i < 20; i++) { /* the largest |m| and periods about it */
        vm_real m = -largest * (1 - (vm_real)i * VM_EPSILON), root = VM_SQRT(largest);
        jacobi_sncndn(jacobi_K(m) * (vm_real)(0.3 + 0.35 * i), m, &sn, &cn, &dn);
        check_error("dn^2/m1-sn^2", "m = -VM_MAX", "eps",
                    ERROR_EPS(dn / root * (dn / root), (double)(sn * sn), 0, 1), 16, i, 0);
        check_error("sn^2+cn^2-1", "m = -VM_MAX", "eps", ERROR_EPS(sn * sn + cn * cn, 1, 0, 1), 12, i, 0);
    }
    jacobi_sncndn(0, ok, &sn, &cn, &dn);
    CHECK(sn == 0 && cn == 1 && dn == 1);
    jacobi_sncndn(-(vm_real)0, ok, &sn, &cn, &dn);
    CHECK(sn == 0 && copysign(1, (double)sn) < 0);
    for (i = 0; i < 2000; i++) { /* no phase left, still in range */
        vm_real u = largest * (vm_real)uniform(-1, 1), m = (vm_real)uniform(-5, 1), kp = VM_SQRT(1 - m);
        jacobi_sncndn(i % 2 ? u : (vm_real)uniform(-50, 50), m, &sn, &cn, &dn);
        in_range = in_range && VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn <= (kp > 1 ? kp : 1) &&
                   dn >= (kp > 1 ? 1 : kp);
    }
    for (i = 0; i < 20000; i++) { /* next to quarter and half periods, where rounding could lead outside */
        vm_real m = (vm_real)(i % 2 ? uniform(0, 1) : uniform(-30, 0)), kp = VM_SQRT(1 - m);
        vm_real u = jacobi_K(m) * (vm_real)(i % 5) * (1 + (vm_real)uniform(-4, 4) * VM_EPSILON);
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        in_range = in_range && VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn <= (kp > 1 ? kp : 1) &&
                   dn >= (kp > 1 ? 1 : kp);
    }
    CHECK(in_range);
    jacobi_sncndn(VM_EPSILON * VM_EPSILON, 1, &sn, &cn, &dn); /* tanh of small numbers */
    CHECK(sn == VM_EPSILON * VM_EPSILON && cn == 1 && dn == 1);
    jacobi_sncndn((vm_real)1e-3, -largest / 2, &sn, &cn, &dn);
    CHECK(VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn >= 1);
}

int main(void)
{
    test_table();
    test_identities();
    test_closed_forms();
    test_solver();
    test_solver_table();
    test_domain();
    return check_finish("jacobi.h");
}
