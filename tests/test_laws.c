/* vm_law: laws of mass and stiffness. Their derivatives are compared with differences, their integrals with
   Simpson's rule and, next to the values where closed forms become 0/0, with series; tables must meet their
   points and stay monotone between them; what is not a law, or not positive, must be refused by everything that
   takes one. */
#include "../varmass.h"
#include "check.h"
#include "oscillator_checks.h"

static double simpson_inverse(const vm_law *law, double t)
{
    const int n = 2000;
    double sum = 0;
    int i;
    for (i = 0; i <= n; i++) {
        vm_real f = 1, rate = 0;
        double weight = i % 2 ? 4 : 2;
        if (i == 0 || i == n) weight = 1;
        CHECK(vm_law_at(law, R(t * i / n), &f, &rate) == VM_OK);
        sum += weight / (double)f;
    }
    return sum * t / (3 * n);
}

static int sine_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const double w = (double)*(const vm_real *)ctx;
    *f = R(1 + 0.5 * sin(w * (double)t));
    *rate = R(0.5 * w * cos(w * (double)t));
    return 0;
}

/* The integral of 1/m and the derivative m' of one law, at t from 0.3 to 3.9 */
static void check_law(const vm_law *law, const char *what, double integral_tolerance, double rate_tolerance)
{
    const double h = by_precision(1e-5, 1e-2);
    double t;
    for (t = 0.3; t < 3.9; t += 0.4) {
        vm_real integral = 0, f = 1, rate = 0, up = 0, down = 0, unused = 0;
        CHECK(vm_law_inverse_integral(law, R(t), &integral) == VM_OK);
        near("int dt/m", what, (double)integral, simpson_inverse(law, t), integral_tolerance);
        CHECK(vm_law_at(law, R(t), &f, &rate) == VM_OK);
        CHECK(vm_law_at(law, R(t + h), &up, &unused) == VM_OK &&
              vm_law_at(law, R(t - h), &down, &unused) == VM_OK);
        near("m'", what, (double)rate, (double)(up - down) / (2 * h), is_float ? 3e-3 : rate_tolerance);
    }
}

static void test_closed_laws(void)
{
    vm_real w = R(0.4);
    vm_law laws[11];
    int n = 0, k;
    laws[n++] = vm_law_linear(2, R(0.3));
    laws[n++] = vm_law_linear(2, R(-0.4));
    laws[n++] = vm_law_linear(2, 0);
    laws[n++] = vm_law_quadratic(1, R(0.3), R(0.2));
    laws[n++] = vm_law_quadratic(1, R(-0.8), R(0.2)); /* without real roots */
    laws[n++] = vm_law_quadratic(1, R(0.6), R(0.01));
    laws[n++] = vm_law_quadratic(1, R(0.2), R(0.01));
    laws[n++] = vm_law_exponential(R(1.5), R(-0.3));
    laws[n++] = vm_law_power(1, R(0.3), R(-1.7));
    laws[n++] = vm_law_power(1, R(0.3), 1);
    laws[n++] = vm_law_user(sine_law, &w);
    for (k = 0; k < n; k++) check_law(laws + k, "", 1e-10, 1e-8);
}

enum { POINTS = 9 };

/* A rising table with a steep place between its fourth and fifth points */
static vm_law rising_table(vm_real *times, vm_real *values)
{
    int i;
    for (i = 0; i < POINTS; i++) {
        times[i] = R(0.5 * i);
        values[i] = R(1 + 0.5 * i * 0.2 + (i > 4 ? 0.3 : 0));
    }
    return vm_law_table(POINTS, times, values);
}

static void test_tables(void)
{
    vm_real times[POINTS], values[POINTS], f = 1, rate = 0, before = 0;
    vm_law law = rising_table(times, values);
    int i;
    check_law(&law, "table", 1e-6, 1e-4);
    vm_law_at(&law, 0, &before, &rate);
    for (i = 1; i < 800; i++) {
        vm_law_at(&law, R(0.005 * i), &f, &rate);
        CHECK(f >= before && rate >= 0);
        before = f;
    }
    for (i = 0; i < POINTS; i++)
        CHECK(vm_law_at(&law, times[i], &f, &rate) == VM_OK && fabs((double)(f - values[i])) < 4 * eps);
    values[4] =
        values[3] + R(0.5); /* now the largest value lies inside: the law is flat there and does not overshoot */
    CHECK(vm_law_at(&law, times[4], &f, &rate) == VM_OK && (values[5] > values[4] || rate == 0));
}

/* At the last point of a table, rounding errors of the last two values, which may have any sign, are left. */
static void test_last_points(void)
{
    vm_real times[4] = {0, 0, 0, 0}, values[4], f = 0, rate;
    const vm_law law = vm_law_table(4, times, values);
    int i, k;
    for (i = 0; i < 2000; i++) {
        for (k = 1; k < 4; k++) times[k] = times[k - 1] + R(uniform(0.1, 2));
        for (k = 0; k < 4; k++) values[k] = R(uniform(-1, 1) * pow(10, uniform(-3, 3)));
        CHECK(vm_law_at(&law, times[3], &f, &rate) == VM_OK);
        CHECK(fabs((double)(f - values[3])) <= 8 * eps * fmax(fabs((double)values[2]), fabs((double)values[3])));
    }
}

static double inverse_integral(vm_law law, double t)
{
    vm_real integral = 0;
    CHECK(vm_law_inverse_integral(&law, R(t), &integral) == VM_OK);
    return (double)integral;
}

/* Negative times, and the limits where the closed forms are 0/0 */
static void test_limits(void)
{
    double c;
    near("int dt/m", "t < 0", inverse_integral(vm_law_linear(2, R(0.3)), -1.5), log1p(-0.225) / 0.3, 1e-13);
    for (c = 1e-3; c > 1e-18; c /= 10) {
        const double near_one = (double)R(1 + c) - 1;
        c = (double)R(c);
        near("int dt/m", "m1 -> 0", inverse_integral(vm_law_linear(1, R(c)), 3), log1p(3 * c) / c, 1e-14);
        near("int dt/m", "rate -> 0", inverse_integral(vm_law_exponential(1, R(c)), 3), -expm1(-3 * c) / c, 1e-14);
        near("int dt/m", "exponent -> 1", inverse_integral(vm_law_power(1, R(0.3), R(1 + c)), 3),
             log1p(0.9) / 0.3 * (1 - near_one * log1p(0.9) / 2), 2e-14 + c * c);
        near("int dt/m", "D -> 0", inverse_integral(vm_law_quadratic(1, R(0.2), R(0.01 * (1 + c))), 3), 3 / 1.3,
             2e-14 + 0.2 * c);
    }
}

/* At a time so small that its 32nd part is 0 a panel has a length nevertheless, so that the integral ends. */
static void test_subnormal_times(void)
{
    const vm_real least = VM_MIN * VM_EPSILON;
    vm_real rate = 1, integral = 0;
    const vm_law one = vm_law_linear(1, 0);
    vm_law law = vm_law_user(sine_law, &rate);
    CHECK(vm_law_inverse_integral(&law, least, &integral) == VM_OK && integral == least);
    law.change_time = 1000; /* longer than the panels that are needed anyway */
    CHECK(vm_law_inverse_integral(&law, least, &integral) == VM_OK && integral == least);
    CHECK(vm_law_ratio_integral(&one, &law, -least, &integral) == VM_OK && integral == -least);
}

/* ---- Bad input ---- */

/* All routes to x(t) end with this status for a mass of this law. */
static void refuses_mass(vm_law law, double t, int status) { refuses(problem(3, law, 1, 0), t, status); }

static void test_not_positive(void)
{
    vm_osc_problem o = problem(3, vm_law_linear(1, R(0.01)), 1, 0);
    o.stiffness = vm_law_linear(0, 0);
    refuses(o, 1, VM_BAD_STIFFNESS);
    o.stiffness = vm_law_linear(-1, 0);
    refuses(o, 1, VM_BAD_STIFFNESS);
    o.stiffness = vm_law_power(1, R(-0.5), 2);
    refuses(o, 3, VM_BAD_STIFFNESS);
    refuses_mass(vm_law_linear(1, R(-0.5)), 2, VM_BAD_MASS);
    refuses_mass(vm_law_linear(1, R(-0.5)), 3, VM_BAD_MASS);
    refuses_mass(vm_law_linear(0, 1), 3, VM_BAD_MASS);
    refuses_mass(vm_law_quadratic(1, -2, R(0.9)), 3, VM_BAD_MASS); /* positive at 0 and at 3, but not between */
    refuses_mass(vm_law_power(1, R(-0.5), 2), 3, VM_BAD_MASS);
    refuses_mass(vm_law_exponential(-1, 0), 3, VM_BAD_MASS);
    refuses_mass(vm_law_linear(VM_INFINITY, 0), 1, VM_NOT_FINITE);
}

/* Where two neighbouring values of a table are equal, the law is constant between them, at the ends of the table, too. */
static void test_flat_ends(void)
{
    vm_real times[4] = {0, 1, 2, 3}, values[4] = {2, 2, 1, 1}, f[VMI_LAW_ORDERS];
    int sign, i;
    for (sign = -1; sign <= 1; sign += 2) {
        vm_law law;
        for (i = 0; i < 4; i++) values[i] = R(3 - sign * (i / 2));
        law = vm_law_table(4, times, values);
        for (i = 0; i <= 10; i++) {
            CHECK(vmi_law_derivatives(&law, VM_BAD_MASS, R(i) / 10, i < 10 ? 1 : -1, 0, f) == VM_OK && f[0] == 3 && f[1] == 0);
            CHECK(vmi_law_derivatives(&law, VM_BAD_MASS, 2 + R(i) / 10, i < 10 ? 1 : -1, 0, f) == VM_OK && f[0] == R(3 - sign) && f[1] == 0);
        }
    }
}

static void test_bad_tables(void)
{
    vm_real times[3] = {0, 1, 2}, values[3] = {1, 2, 3};
    const vm_law law = vm_law_table(3, times, values);
    refuses_mass(law, 2.5, VM_DOMAIN); /* after its end */
    values[1] = -1;
    refuses_mass(law, 1.5, VM_BAD_MASS);
    values[1] = VM_NAN;
    refuses_mass(law, 1.5, VM_NOT_FINITE);
    values[1] = 2;
    times[1] = 2;
    refuses_mass(law, 1.5, VM_DOMAIN); /* a time twice */
    refuses_mass(vm_law_table(1, times, values), 0, VM_BAD_ARGUMENT);
}

/* m = 1 - t/4, which after t = 6 says that it has failed */
static int failing(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = 1 - t / 4;
    *rate = R(-0.25);
    return t > 6;
}

static void test_bad_functions(void)
{
    vm_law law = vm_law_user(NULL, NULL);
    refuses_mass(law, 1, VM_BAD_ARGUMENT);
    law = vm_law_user(failing, NULL);
    refuses_mass(law, 5, VM_BAD_MASS);
    refuses_mass(law, 7, VM_DOMAIN);
    law.derivatives = NULL; /* as no constructor makes it */
    refuses_mass(law, 1, VM_BAD_ARGUMENT);
}

static void test_null_pointers(void)
{
    const vm_law law = vm_law_linear(1, R(0.01));
    vm_real f, rate;
    CHECK(vm_law_at(NULL, 0, &f, &rate) == VM_BAD_ARGUMENT);
    CHECK(vm_law_inverse_integral(&law, 1, NULL) == VM_BAD_ARGUMENT);
}

/* Quadratic laws whose products f1 f1 and f0 f2 underflow or overflow have the integrals of the same laws in another
   unit. */
static void test_quadratic_units(void)
{
    const double units[] = {by_precision(1e-170, 1e-23), by_precision(1e170, 1e23), 1};
    int i;
    for (i = 0; i < 3; i++) {
        const double f0 = (double)R(units[i]);
        const vm_law law = vm_law_quadratic(R(f0), R(f0), R(f0)), valley = vm_law_quadratic(R(f0), R(-3 * f0), R(f0));
        vm_real base, rate, integral = 7;
        near("int dt/m", "small, quadratic", inverse_integral(law, 1) * f0, pi / (3 * sqrt(3)), 1e-14);
        near("int dt/m", "small, quadratic", inverse_integral(vm_law_quadratic(R(f0), 3 * R(f0), R(f0)), 1) * f0,
             log((5 + sqrt(5)) / (5 - sqrt(5))) / sqrt(5), 1e-14);
        CHECK(vmi_law_exponential_form(&law, &base, &rate) == 0);
        CHECK(vm_law_inverse_integral(&valley, 3, &integral) == VM_BAD_MASS && integral == 7); /* f(1.5) < 0 */
        CHECK(vm_law_inverse_integral(&valley, -1, &integral) == VM_OK);
    }
    for (i = 0; i < 2; i++) { /* units of time */
        const double s = (double)R(i ? by_precision(1e150, 1e18) : by_precision(1e-150, 1e-18));
        const vm_law law = vm_law_quadratic(1, R(1 / s), R(1 / s / s));
        vm_real integral = 7;
        CHECK(vm_law_inverse_integral(&law, R(s), &integral) == VM_OK);
        near("int dt/m", "small, quadratic", (double)integral / s, pi / (3 * sqrt(3)), 1e-14);
    }
}

/* The lowest value of f lies at so short a time that its square underflows. */
static void test_short_valley(void)
{
    const vm_real unit = R(by_precision(1e-170, 1e-25)), size = R(by_precision(1e-50, 1e-15));
    const vm_law valley = vm_law_quadratic(size, -3 * size / unit, size / unit / unit);
    vm_real integral = 7;
    CHECK(vm_law_inverse_integral(&valley, 3 * unit, &integral) == VM_BAD_MASS && integral == 7);
}

/* A linear law that is almost 0 at t, where (f1/f0) t may round to -1 */
static void test_almost_empty(void)
{
    int i;
    for (i = 0; i < 300; i++) {
        const vm_law law = vm_law_linear(R(uniform(0.2, 2)), R(uniform(-2, -0.2)));
        vm_real t = -law.f0 / law.f1 * (1 + 2 * VM_EPSILON), f = 0, rate = 0, integral = 0;
        while (f <= 0) {
            t *= 1 - VM_EPSILON;
            CHECK(vm_law_at(&law, t, &f, &rate) == VM_OK);
        }
        CHECK(vm_law_inverse_integral(&law, t, &integral) == VM_OK);
        near("int dt/m", "almost empty", (double)integral, log((double)(f / law.f0)) / (double)law.f1, 1e-13);
    }
}

/* Two equal times in a table are refused with VM_DOMAIN, even where the value at t is NaN. */
static void test_equal_times(void)
{
    vm_real times[4] = {0, 1, 1, 2}, values[4] = {1, 2, 2, 3}, integral = 7;
    const vm_law law = vm_law_table(4, times, values);
    CHECK(vm_law_inverse_integral(&law, R(1.5), &integral) == VM_DOMAIN && integral == 7);
    refuses_mass(law, 1.5, VM_DOMAIN);
}

int main(void)
{
    test_closed_laws();
    test_tables();
    test_last_points();
    test_limits();
    test_subnormal_times();
    test_quadratic_units();
    test_short_valley();
    test_almost_empty();
    test_equal_times();
    test_not_positive();
    test_flat_ends();
    test_bad_tables();
    test_bad_functions();
    test_null_pointers();
    return check_finish("laws");
}
