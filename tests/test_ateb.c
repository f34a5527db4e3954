/* ateb.h against arbitrary-precision tables, identities, closed forms and the edges of its domain. */
#include "../ateb.h"
#include "check.h"

typedef struct ateb_row {
    const char *region;
    double s, alpha, sa, sa_low, ca, ca_low, pi, pi_low;
} ateb_row;

static const ateb_row ateb_table[] = {
#include "data/ateb_table.h"
};

/* Pi_alpha is known to a relative error of 2^-87 (float 2^-45), which moves the zeros */
#ifdef VM_USE_FLOAT
static const double pi_error = 3e-14;
#else
static const double pi_error = 6.5e-27;
#endif

static void test_table(void)
{
    size_t i;
    for (i = 0; i < sizeof ateb_table / sizeof *ateb_table; i++) {
        const ateb_row *row = ateb_table + i;
        vm_real sa, ca;
        double sa_moved, ca_moved;
        if (!representable(row->s) || !representable(row->alpha)) continue;
        ateb_saca((vm_real)row->s, (vm_real)row->alpha, &sa, &ca);
        check_error("sa", row->region, "eps", ERROR_EPS(sa, row->sa, row->sa_low, 1), 4, row->s, row->alpha);
        check_error("ca", row->region, "eps", ERROR_EPS(ca, row->ca, row->ca_low, 1), 4, row->s, row->alpha);
        check_error("Pi", "", "ulp", ERROR_ULP(ateb_pi((vm_real)row->alpha), row->pi, row->pi_low), 1, row->alpha,
                    0);
        if (fabs(row->s) > 100 * row->pi) continue;
        sa_moved = pi_error * fabs(row->s) / ULP(row->sa);
        ca_moved = 2 / (row->alpha + 1) * pi_error * fabs(row->s) / ULP(row->ca);
        check_error("sa", row->region, "ulp", ERROR_ULP(sa, row->sa, row->sa_low) - sa_moved, 8, row->s,
                    row->alpha);
        check_error("ca", row->region, "ulp", ERROR_ULP(ca, row->ca, row->ca_low) - ca_moved, 8, row->s,
                    row->alpha);
    }
}

static double signed_power(double x, double p) { return copysign(pow(fabs(x), p), x); }

/* sa^2 + |ca|^(alpha+1) = 1 (279), the derivatives (275) and the shifts by a quarter and a half period, (278) and
   (280) as corrected: sa(1,alpha,s + Pi/2) = ... holds between the functions of swapped index, so that here only
   half and whole periods shift a function into itself. */
static void test_identities(void)
{
    int i, symmetric = 1;
    for (i = 0; i < 20000; i++) {
        double alpha = i % 8 == 0 ? 0 : uniform(0, i % 2 ? 5 : 40), s = uniform(-30, 30);
        double eps = (double)VM_EPSILON, power, h = 1e-3, rounded;
        vm_real sa, ca, sa2, ca2, ca_minus, ca_plus, pi = ateb_pi((vm_real)alpha);
        ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
        power = pow(fabs((double)ca), alpha + 1);
        rounded = 2 * (double)sa * (double)sa + (alpha + 1) * power; /* what an eps in sa and in ca makes */
        check_error("sa^2+|ca|^(a+1)-1", "random", "eps*",
                    fabs((double)sa * (double)sa + power - 1) / eps / rounded, 2, s, alpha);
        ateb_saca((vm_real)-s, (vm_real)alpha, &sa2, &ca2);
        symmetric = symmetric && sa2 == -sa && ca2 == ca;
        ateb_saca((vm_real)s + pi, (vm_real)alpha, &sa2, &ca2);
        rounded = 4 + (fabs(s) + (double)pi) *
                          (1 + (double)pi / 2); /* s + pi and pi are rounded; slopes are at most 2 */
        check_error("sa(s+Pi)+sa", "random", "eps", fabs((double)sa2 + (double)sa) / eps / rounded, 1, s, alpha);
        check_error("ca(s+Pi)+ca", "random", "eps", fabs((double)ca2 + (double)ca) / eps / rounded, 1, s, alpha);
        if (PRECISION[0] == 'f' || i % 10) continue;
        ateb_saca((vm_real)(s + h), (vm_real)alpha, &sa2, &ca_plus);
        ateb_saca((vm_real)(s - h), (vm_real)alpha, &sa, &ca_minus);
        if (fabs((double)ca) < 0.1) continue; /* ca^alpha has no third derivative at ca = 0 */
        check_error("dsa/ds", "random", "1e-6",
                    1e6 * fabs((double)(sa2 - sa) / (2 * h) - signed_power((double)ca, alpha)), 50, s, alpha);
    }
    CHECK(symmetric);
}

static void test_derivative_of_ca(void)
{
    double s, h = 1e-4;
    for (s = 0.05; s < 12; s += 0.1) {
        double alpha;
        for (alpha = 0.25; alpha < 9; alpha *= 2) {
            vm_real sa, ca, minus = ateb_ca((vm_real)(s - h), (vm_real)alpha),
                            plus = ateb_ca((vm_real)(s + h), (vm_real)alpha);
            ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
            if (PRECISION[0] == 'd')
                check_error("dca/ds", "grid", "1e-6",
                            1e6 * fabs((double)(plus - minus) / (2 * h) + 2 / (alpha + 1) * (double)sa), 1, s,
                            alpha);
        }
    }
}

/* The quarter-period shifts, (278) row 2 and (280) row 2 as corrected: sa(1,alpha,s) = ca(1,alpha,Pi/2 - s) where
   ca(1,alpha,.) is the function with swapped index, ca(1,alpha,z) = sa(1,alpha,Pi/2 - z). In terms of sa(1,alpha,.)
   and ca(alpha,1,.) they say that the phases of the same point counted from the two ends of the quarter add up to
   Pi/2: sa^-1(v) + ca^-1(u) = Pi/2, each by its own series. Checked at the change-over, where the two methods of
   ateb.h meet; and the printed form sa(1,alpha,s) = ca(alpha,1,Pi/2 - s) fails by what the equations' check says.
   */
static void test_quarter_period(void)
{
    const vm_real change_over = (vm_real)0.55, alpha = (vm_real)1.5, s = (vm_real)0.7;
    double a;
    for (a = 0; a < 1000; a = 1.3 * a + 0.01) {
        vm_real below_sa, below_ca, above_sa, above_ca, sum;
        ateb_saca(change_over * (1 - 2 * VM_EPSILON), (vm_real)a, &below_sa, &below_ca);
        ateb_saca(change_over * (1 + 2 * VM_EPSILON), (vm_real)a, &above_sa, &above_ca);
        sum = above_sa - below_sa;
        check_error("sa step", "s = 0.55", "eps", fabs((double)sum) / (double)VM_EPSILON, 5, a, 0);
        sum = above_ca - below_ca;
        check_error("ca step", "s = 0.55", "eps", fabs((double)sum) / (double)VM_EPSILON, 5, a, 0);
    }
    CHECK(fabs((double)ateb_sa(s, alpha) - 0.635289) < 1e-6);
    CHECK(fabs((double)ateb_ca(ateb_pi(alpha) / 2 - s, alpha) - 0.541498) < 1e-6); /* printed (278) row 2 */
    CHECK(fabs((double)ateb_ca(s, alpha) - 0.813238) < 1e-6);
    CHECK(fabs((double)ateb_sa(ateb_pi(alpha) / 2 + s, alpha) - 0.885567) < 1e-6); /* printed (280) row 2 */
    CHECK(fabs((double)ateb_sa(ateb_pi(alpha) + s, alpha) + 0.635289) < 1e-6);     /* (278) row 3 as corrected */
}

static void test_closed_forms(void)
{
    int i;
    for (i = 0; i < 2000; i++) {
        double s = uniform(-30, 30), wave = s - 4 * floor(s / 4 + 0.5); /* alpha = 0: triangles and parabolas */
        vm_real sa, ca;
        ateb_saca((vm_real)s, 1, &sa, &ca);
        check_error("sa = sin", "alpha = 1", "eps", ERROR_EPS(sa, sin(s), 0, 1), 2, s, 1);
        check_error("ca = cos", "alpha = 1", "eps", ERROR_EPS(ca, cos(s), 0, 1), 2, s, 1);
        ateb_saca((vm_real)s, 0, &sa, &ca);
        if (fabs(wave) > 1) {
            wave = copysign(2, wave) - wave;
            check_error("ca = (2-s)^2-1", "alpha = 0", "eps", ERROR_EPS(ca, wave * wave - 1, 0, 1), 3, s, 0);
        } else check_error("ca = 1-s^2", "alpha = 0", "eps", ERROR_EPS(ca, 1 - wave * wave, 0, 1), 3, s, 0);
        check_error("sa = s", "alpha = 0", "eps", ERROR_EPS(sa, wave, 0, 1), 3, s, 0);
    }
    check_error("Pi_0 = 2", "", "ulp", ERROR_ULP(ateb_pi(0), 2, 0), 1, 0, 0);
    check_error("Pi_1 = pi", "", "ulp", ERROR_ULP(ateb_pi(1), (double)VM_PI, 0), 1, 1, 0);
    check_error("Pi", "", "ulp", ERROR_ULP(ateb_pi(3), 5.244115108584239620929679, 0), 1, 3, 0);
}

static void test_domain(void)
{
    const vm_real bad_alpha[] = {(vm_real)-1e-3, VM_NAN, VM_INFINITY, -VM_INFINITY}, ok = (vm_real)0.5;
    const vm_real bad_s[] = {VM_NAN, VM_INFINITY, -VM_INFINITY};
    vm_real sa, ca;
    int i, in_range = 1;
    for (i = 0; i < 4; i++) {
        CHECK(ateb_pi(bad_alpha[i]) != ateb_pi(bad_alpha[i]));
        ateb_saca(ok, bad_alpha[i], &sa, &ca);
        CHECK(sa != sa && ca != ca);
    }
    for (i = 0; i < 3; i++) {
        ateb_saca(bad_s[i], ok, &sa, &ca);
        CHECK(sa != sa && ca != ca);
    }
    ateb_saca(-(vm_real)0, ok, &sa, &ca);
    CHECK(sa == 0 && copysign(1, (double)sa) < 0 && ca == 1);
    for (i = 0; i < 20000; i++) { /* in range whatever the size of s and alpha */
        double s = uniform(-1, 1) * pow(10, uniform(-37, 37)), alpha = uniform(0, 1) * pow(10, uniform(-37, 37));
        ateb_saca((vm_real)s, (vm_real)alpha, &sa, &ca);
        in_range = in_range && VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1;
    }
    CHECK(in_range);
    ateb_saca(VM_MAX, VM_MAX, &sa, &ca);
    CHECK(VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
    ateb_saca(VM_MAX, ok, &sa, &ca);
    CHECK(VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
}

int main(void)
{
    test_table();
    test_identities();
    test_derivative_of_ca();
    test_quarter_period();
    test_closed_forms();
    test_domain();
    return check_finish("ateb.h");
}
