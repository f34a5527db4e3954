/* The Jeffcott rotor's motion z(t), (480)-(482), (497)-(499): radius and phase of circular whirl, and any motion on a
   linear shaft. Oracles: rows in arbitrary precision (tests/gen/jeffcott_reference.py), the averaged equations and the
   equation of motion integrated, and invariants. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

static vm_jeffcott rotor_of(vm_law mass, vm_power_force *p, double gyro, double reactive)
{
    vm_jeffcott r;
    memset(&r, 0, sizeof r);
    r.mass = mass;
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = p;
    r.gyro = R(gyro);
    r.reactive = R(reactive);
    return r;
}

static vm_law mass_of(double kind, double m0, double m1)
{
    if (kind == 0) return vm_law_linear(R(m0), R(m1));
    if (kind == 1) return vm_law_exponential(R(m0), R(m1));
    return vm_law_power(R(m0), R(m1), 2);
}

/* The same law without the closed forms of its kind: phases are then found by quadrature. */
static int copied_law(vm_real t, vm_real *f, vm_real *rate, void *law)
{
    return vm_law_at((const vm_law *)law, t, f, rate);
}

/* Radius and angle against arbitrary precision, with closed forms and with quadrature */
static void test_table(void)
{
    static const double rows[][12] = {
#include "data/jeffcott_table.h"
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double *a = rows[i];
        const vm_law law = mass_of(a[0], a[1], a[2]);
        vm_power_force p;
        vm_jeffcott r = rotor_of(law, &p, a[5], a[6]);
        vm_jeffcott_whirl w;
        p.k = R(a[3]);
        p.alpha = R(a[4]);
        memset(&w, 0, sizeof w);
        CHECK(vm_jeffcott_whirl_at(&r, R(a[7]), 0, (int)a[8], R(a[9]), &w) == VM_OK);
        near("A (506), (509)", a[5] == 0 ? "g = 0" : "g", (double)w.radius, a[10], 2e-14, 3e-6);
        near("psi (499)", a[5] == 0 ? "g = 0" : "g", (double)w.angle, a[11], a[5] == 0 ? 4e-15 : 1e-12, 1e-4);
        if (a[5] == 0) check_error("psi (499)", "closed form", "eps", fabs((double)w.angle / a[11] - 1) / eps, 8, a[9], a[4]);
        near("W", "sense", copysign(1, (double)w.frequency), a[8], 0, 0);
        r.mass = vm_law_user(copied_law, (void *)&law);
        CHECK(vm_jeffcott_whirl_at(&r, R(a[7]), R(0.5), (int)a[8], R(a[9]), &w) == VM_OK);
        near("psi (499)", "quadrature", (double)w.angle - 0.5, a[11], 1e-12, 1e-4);
        near("z (497)", "radius", hypot((double)w.z.re, (double)w.z.im), a[10], 2e-14, 3e-6);
        near("z' (498)", "W A", hypot((double)w.v.re, (double)w.v.im), fabs((double)w.frequency) * a[10], 2e-14, 3e-6);
    }
}

/* A stiffness that is no power law: the averaged equations of vm_jeffcott_forward_whirl_rhs, integrated, have the same
   radius and phase, with and without g, for several shares r. */
static vm_real duffing(vm_real rho, vm_real *slope, void *ctx)
{
    (void)ctx;
    *slope = rho;
    return 1 + rho * rho / 2;
}

static void test_averaged_equations(void)
{
    const double gyros[] = {0, 0.4, -0.3}, shares[] = {1, 0, 0.5};
    int i, j, sense;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            for (sense = -1; sense < 2; sense += 2) {
                vm_jeffcott r = rotor_of(vm_law_quadratic(1, R(0.02), R(0.001)), NULL, gyros[i], shares[j]);
                vm_jeffcott_whirl w;
                vm_real y[2] = {R(0.8), R(0.25)};
                r.stiffness = duffing;
                r.nodes = 1; /* there is no load to take the mean of */
                memset(&w, 0, sizeof w);
                CHECK(vm_jeffcott_whirl_at(&r, y[0], y[1], sense, 12, &w) == VM_OK);
                solve(sense > 0 ? vm_jeffcott_forward_whirl_rhs : vm_jeffcott_backward_whirl_rhs, &r, 2, 0, 12, 1e-12,
                      y);
                near("A (506)", "integrated", (double)w.radius, (double)y[0], 2e-11, 2e-5);
                near("psi (507)", "integrated", (double)w.angle, (double)y[1], 2e-11, 2e-5);
            }
}

/* The error of the motion on a linear shaft against the equation of motion, up to t = 1/rate, over the largest |z| */
static double error_of_linear(double rate, double gyro, double reactive)
{
    vm_power_force p = {2, 1};
    vm_jeffcott r = rotor_of(vm_law_power(1, R(rate), 2), &p, gyro, reactive);
    const vm_real start[4] = {1, R(0.2), R(0.3), R(-0.7)};
    vm_real y[4], motion[4] = {0, 0, 0, 0};
    double worst = 0;
    int i;
    memcpy(y, start, sizeof y);
    for (i = 1; i <= 10; i++) {
        const double t = i * 0.1 / rate;
        solve(vm_jeffcott_rhs, &r, 4, (i - 1) * 0.1 / rate, t, 1e-11, y);
        CHECK(vm_jeffcott_linear_at(&r, start, R(t), motion) == VM_OK);
        worst = fmax(worst, hypot((double)(y[0] - motion[0]), (double)(y[1] - motion[1])));
    }
    return worst;
}

/* (480)-(482): the error on a linear shaft is of first order in the rate of the mass, with g and any share r. */
static void test_linear_shaft(void)
{
    const double gyros[] = {0, 0.5, 0.5}, shares[] = {1, 1, 0.25};
    int i;
    for (i = 0; i < 3; i++) {
        const double coarse = error_of_linear(0.02, gyros[i], shares[i]);
        const double fine = error_of_linear(0.005, gyros[i], shares[i]);
        printf("linear shaft, g = %g, r = %g: error %.3g at a rate of 0.02, %.3g at 0.005\n", gyros[i], shares[i], coarse,
               fine);
        CHECK(coarse < 0.04);
        if (!is_float) CHECK(fine < coarse / 3.5 && fine > coarse / 4.6);
    }
}

/* At t = 0 the motion is the start; along a line it stays on the line (481), and the half period grows with the mass,
   by the logarithm of (482): the k-th turning of z comes at (1 + c t) = exp(k pi c/w0). */
static void test_line(void)
{
    vm_power_force p = {4, 1};
    vm_jeffcott r = rotor_of(vm_law_power(1, R(0.02), 2), &p, 0, 1);
    const vm_real start[4] = {1, R(0.5), 0, 0};
    vm_real motion[4] = {0, 0, 0, 0};
    int i;
    CHECK(vm_jeffcott_linear_at(&r, start, 0, motion) == VM_OK);
    for (i = 0; i < 4; i++) near_eps("(481)", "t = 0", (double)motion[i], (double)start[i], 4);
    for (i = 1; i <= 20; i++) {
        const double t = expm1(i * pi * 0.02 / 2) / 0.02, root = sqrt(1 + 0.02 * t);
        CHECK(vm_jeffcott_linear_at(&r, start, R(t), motion) == VM_OK);
        near("(482)", "turning point", (double)motion[0], (i % 2 ? -1 : 1) / root, 1e-13, 2e-5);
        check_error("(481)", "line", "", fabs((double)(motion[1] - motion[0] / 2)), by_precision(1e-14, 1e-5), i, 0);
    }
}

/* For r = 1 the angular momentum (514), (515) of a whirl keeps its value, with g too. */
static void test_momentum(void)
{
    vm_power_force p = {1, 3};
    vm_jeffcott r = rotor_of(vm_law_linear(1, R(0.01)), &p, 0.3, 1);
    double first = 0;
    int i;
    for (i = 0; i <= 10; i++) {
        vm_jeffcott_whirl w;
        memset(&w, 0, sizeof w);
        CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, R(10 * i), &w) == VM_OK);
        if (i == 0) first = (double)vm_jeffcott_momentum(&r, 1, w.z, w.v);
        near("(514), (515)", "momentum", (double)vm_jeffcott_momentum(&r, R(1 + 0.1 * i), w.z, w.v), first, 2e-14, 1e-5);
    }
}

static vm_complex some_force(vm_real t, vm_complex z, vm_complex v, void *ctx)
{
    (void)t;
    (void)v;
    (void)ctx;
    return z;
}

/* A motion on a linear shaft does not change if mass and stiffness are very large or very small together. */
static void test_large_and_small_masses(void)
{
    const vm_real start[4] = {1, R(0.5), R(-0.25), 2}, most = VM_MAX / 16;
    vm_real scale;
    for (scale = VM_MIN * 16; scale < most; scale *= 256) {
        vm_power_force p = {1, 1}, q;
        vm_jeffcott usual = rotor_of(vm_law_linear(1, R(0.0625)), &p, 0.125, 1), r = usual;
        vm_real motion[4] = {7, 7, 7, 7}, expected[4] = {8, 8, 8, 8};
        q.k = scale;
        q.alpha = 1;
        r.stiffness_ctx = &q;
        r.mass = vm_law_linear(scale, R(0.0625) * scale);
        r.gyro = usual.gyro * scale;
        CHECK(vm_jeffcott_linear_at(&usual, start, 3, expected) == VM_OK);
        CHECK(vm_jeffcott_linear_at(&r, start, 3, motion) == VM_OK && memcmp(motion, expected, sizeof motion) == 0);
    }
}

static vm_real infinite_shaft(vm_real rho, vm_real *slope, void *ctx)
{
    (void)rho;
    (void)ctx;
    *slope = 0;
    return VM_INFINITY;
}

static void test_refusals(void)
{
    vm_power_force p = {1, 1}, hard = {1, 3};
    const vm_jeffcott good = rotor_of(vm_law_linear(1, R(-0.1)), &p, 0.3, 0.5);
    vm_jeffcott r = good;
    vm_jeffcott_whirl w, before;
    vm_real start[4] = {1, 0, 0, 1}, motion[4] = {7, 7, 7, 7};
    memset(&w, 7, sizeof w);
    before = w;
    CHECK(vm_jeffcott_whirl_at(NULL, 1, 0, 1, 1, &w) == VM_BAD_ARGUMENT);
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 1, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_jeffcott_whirl_at(&r, 0, 0, 1, 1, &w) == VM_DOMAIN);
    CHECK(vm_jeffcott_whirl_at(&r, 1, VM_NAN, 1, 1, &w) == VM_NOT_FINITE);
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 11, &w) == VM_BAD_MASS);
    CHECK(vm_jeffcott_linear_at(&r, start, 11, motion) == VM_BAD_MASS);
    r.u.re = 1;
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 1, &w) == VM_NO_LAW);
    r = good;
    r.force = some_force;
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 1, &w) == VM_NO_LAW);
    CHECK(vm_jeffcott_linear_at(&r, start, 1, motion) == VM_NO_LAW);
    r = good;
    r.stiffness_ctx = &hard;
    CHECK(vm_jeffcott_linear_at(&r, start, 1, motion) == VM_NO_LAW);
    r.stiffness = infinite_shaft;
    CHECK(vm_jeffcott_linear_at(&r, start, 1, motion) == VM_NOT_FINITE);
    r.stiffness = good.stiffness;
    r = good;
    p.k = -1;
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 1, &w) == VM_BAD_STIFFNESS);
    CHECK(vm_jeffcott_linear_at(&r, start, 1, motion) == VM_BAD_STIFFNESS);
    start[2] = VM_NAN;
    CHECK(vm_jeffcott_linear_at(&r, start, 1, motion) == VM_NOT_FINITE);
    CHECK(memcmp(&w, &before, sizeof w) == 0 && motion[0] == 7 && motion[3] == 7);
    CHECK(isnan(vm_jeffcott_whirl_amplitude(&r, 1, 1, 2, 1)) && isnan(vm_jeffcott_whirl_amplitude(&r, 1, -1, 2, 1)));
    CHECK(isnan(vm_jeffcott_whirl_amplitude(NULL, 1, 1, 2, 1)));
}

int main(void)
{
    test_table();
    test_averaged_equations();
    test_linear_shaft();
    test_line();
    test_momentum();
    test_large_and_small_masses();
    test_refusals();
    return check_finish("jeffcott_motion");
}
