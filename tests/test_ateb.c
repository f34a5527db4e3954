/* ateb.h against arbitrary-precision tables, identities, closed forms and the edges of its domain. */
#include "../ateb.h"
#include "../jacobi.h"
#include "check.h"

typedef struct ateb_row {
    const char *region;
    double s, alpha, sa, sa_low, ca, ca_low, pi, pi_low;
} ateb_row;

static const ateb_row ateb_table[] = {
#include "data/ateb_table.h"
};

/* Pi_alpha in two words is known to a relative error of 2^-102 (float 2^-44), which moves the zeros */
#ifdef VM_USE_FLOAT
static const double pi_error = 5.7e-14;
#else
static const double pi_error = 2e-31;
#endif

static void check_pi_two_words(const ateb_row *row)
{
    vmi_ateb c;
    vm_two quarter;
    vmi_ateb_constants(&c, (vm_real)row->alpha);
    quarter = vmi_ateb_fine_quarter(&c);
    check_error("Pi, two words", "", "bound",
                fabs((2 * (double)quarter.hi - row->pi) + (2 * (double)quarter.lo - row->pi_low)) / row->pi /
                    pi_error,
                1, row->alpha, 0);
}

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
        check_pi_two_words(row);
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

/* sa^2 + |ca|^(alpha+1) = 1 (279), oddness and evenness, half and whole periods and reflections, (278) and (280) with
   their signs corrected, and v' = u|u|^(alpha-1) (275). */
static void test_identities(void)
{
    int i, k, symmetric = 1;
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
        for (k = 0; k < 4; k++) { /* Pi + s, Pi - s, 2 Pi + s, 2 Pi - s */
            vm_real shifted = (vm_real)(1 + k / 2) * pi + (vm_real)(k % 2 ? -s : s);
            double sign_sa = k == 0 || k == 3 ? -1 : 1, sign_ca = k < 2 ? -1 : 1;
            ateb_saca(shifted, (vm_real)alpha, &sa2, &ca2);
            rounded = 4 + 2 * (fabs(s) + 2 * (double)pi); /* the sum and pi are rounded; slopes are at most 2 */
            check_error("sa shifted", "random", "eps*", fabs((double)sa2 - sign_sa * (double)sa) / eps / rounded, 1,
                        s, alpha);
            check_error("ca shifted", "random", "eps*", fabs((double)ca2 - sign_ca * (double)ca) / eps / rounded, 1,
                        s, alpha);
        }
        if (PRECISION[0] == 'f' || i % 10) continue;
        ateb_saca((vm_real)(s + h), (vm_real)alpha, &sa2, &ca_plus);
        ateb_saca((vm_real)(s - h), (vm_real)alpha, &sa, &ca_minus);
        if (fabs((double)ca) < 0.1) continue; /* ca^alpha has no third derivative at ca = 0 */
        check_error("dsa/ds", "random", "1e-6",
                    1e6 * fabs((double)(sa2 - sa) / (2 * h) - signed_power((double)ca, alpha)), 2, s, alpha);
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

/* The quarter-period shifts, (278) row 2 and (280) row 2 as corrected, lead to the functions of swapped index:
     sa(1,alpha,s) = ca(1,alpha,Pi/2 - s),  ca(alpha,1,s) = sa(alpha,1,Pi/2 - s).
   So f(z) = sa(1,alpha,Pi/2 - z), g(z) = ca(alpha,1,Pi/2 - z) must be the solution of the swapped system
     f' = -g|g|^(alpha-1), g' = 2 f/(alpha + 1), f(0) = 1, g(0) = 0,
   integrated here by Taylor steps of its own. The printed forms, without the swap, fail by what is known. */
static void test_quarter_period(void)
{
    const vm_real alpha = (vm_real)1.5, s = (vm_real)0.7;
    double a;
    for (a = 0.5; a < 9; a *= 1.7) {
        const int steps = 4000;
        double half = (double)ateb_pi((vm_real)a) / 2, h = 0.9 * half / steps, f = 1, g = 0, z = 0;
        int i;
        for (i = 0; i < steps; i++, z += h) { /* midpoint rule; its error is below 1e-6 */
            double fm = f - h / 2 * signed_power(g, a), gm = g + h / 2 * 2 / (a + 1) * f;
            f -= h * signed_power(gm, a), g += h * 2 / (a + 1) * fm;
            if (i % 500) continue;
            check_error("f(z)", "swapped index", "1e-6",
                        1e6 * fabs(f - (double)ateb_sa((vm_real)(half - z - h), (vm_real)a)), 3, z, a);
            check_error("g(z)", "swapped index", "1e-6",
                        1e6 * fabs(g - (double)ateb_ca((vm_real)(half - z - h), (vm_real)a)), 3, z, a);
        }
    }
    CHECK(fabs((double)ateb_sa(s, alpha) - 0.635289) < 1e-6);
    CHECK(fabs((double)ateb_ca(ateb_pi(alpha) / 2 - s, alpha) - 0.541498) < 1e-6); /* printed (278) row 2 */
    CHECK(fabs((double)ateb_ca(s, alpha) - 0.813238) < 1e-6);
    CHECK(fabs((double)ateb_sa(ateb_pi(alpha) / 2 + s, alpha) - 0.885567) < 1e-6); /* printed (280) row 2 */
    CHECK(fabs((double)ateb_sa(ateb_pi(alpha) + s, alpha) + 0.635289) < 1e-6);     /* (278) row 3 as corrected */
}

/* The two methods of ateb.h meet at the change-over. */
static void test_change_over(void)
{
    double a;
    for (a = 0; a < 1000; a = 1.3 * a + 0.01) {
        vm_real s = (vm_real)0.55, below_sa, below_ca, above_sa, above_ca;
        ateb_saca(s * (1 - 2 * VM_EPSILON), (vm_real)a, &below_sa, &below_ca);
        ateb_saca(s * (1 + 2 * VM_EPSILON), (vm_real)a, &above_sa, &above_ca);
        check_error("sa step", "s = 0.55", "eps", fabs((double)(above_sa - below_sa)) / (double)VM_EPSILON, 4, a,
                    0);
        check_error("ca step", "s = 0.55", "eps", fabs((double)(above_ca - below_ca)) / (double)VM_EPSILON, 4, a,
                    0);
    }
}

static void test_closed_forms(void)
{
    int i;
    for (i = 0; i < 2000; i++) {
        double s = uniform(-30, 30), wave = s - 4 * floor(s / 4 + 0.5); /* alpha = 0: triangles and parabolas */
        vm_real sa, ca, sn, cn, dn;
        ateb_saca((vm_real)s, 1, &sa, &ca);
        check_error("sa = sin", "alpha = 1", "eps", ERROR_EPS(sa, sin(s), 0, 1), 2, s, 1);
        check_error("ca = cos", "alpha = 1", "eps", ERROR_EPS(ca, cos(s), 0, 1), 2, s, 1);
        ateb_saca((vm_real)s, 3, &sa, &ca); /* the cubic oscillator; s sqrt(1/2) is rounded, slopes are at most 1 */
        jacobi_sncndn((vm_real)s * VM_SQRT((vm_real)0.5), (vm_real)0.5, &sn, &cn, &dn);
        check_error("ca = cn", "alpha = 3", "eps*", ERROR_EPS(ca, (double)cn, 0, 4 + fabs(s)), 1, s, 3);
        check_error("sa = sqrt 2 sn dn", "alpha = 3", "eps*",
                    ERROR_EPS(sa, (double)(VM_SQRT(2) * sn * dn), 0, 4 + fabs(s)), 1, s, 3);
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
    test_change_over();
    test_closed_forms();
    test_domain();
    return check_finish("ateb.h");
}
