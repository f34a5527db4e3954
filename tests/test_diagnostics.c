/* Diagnostics of vibrations: turning points and zero crossings of a motion, the error of an envelope, the
   adiabaticity. The points are compared with those of cos t, the envelopes with those of Example 1 (398), the
   cubic oscillator of growing mass, whose motion has reference numbers of 19 digits. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

static void cosine_motion(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    vm_real s, c;
    (void)ctx;
    vmi_sincos(t, &s, &c);
    *x = c;
    *v = -s;
}

/* e^(-rate t), where ctx points to the rate */
static vm_real decay(vm_real t, void *ctx)
{
    const vm_real rate = *(const vm_real *)ctx;
    return vmi_exp(-rate * t, 0);
}

/* A vibration whose velocity is below the smallest normal number */
static void tiny_motion(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    cosine_motion(t, x, v, ctx);
    *x *= VM_MIN / 8;
    *v *= VM_MIN / 8;
}

static void test_turning_points(void)
{
    vm_sample found[40];
    vm_real none = 0, slow = VM_C(0.01);
    long n, i;
    n = vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, 0, R(31.5), R(0.5), 40, found);
    CHECK(n == 10); /* the one at the start does not count */
    for (i = 0; i < n; i++) {
        near_eps("turning points", "cos t", (double)found[i].t, (double)(i + 1) * pi, 4);
        near_eps("turning points", "|x|", fabs((double)found[i].x), 1, 1);
    }
    near_eps("envelope error", "law 1", 1 + (double)vm_envelope_error(VM_TURNING_POINTS, n, found, decay, &none),
             1, 4);
    near("envelope error", "law e^-0.01t", (double)vm_envelope_error(VM_TURNING_POINTS, n, found, decay, &slow),
         1 - exp(-0.1 * pi), 1e-14, 1e-5);
    n = vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, R(31.5), 1, R(-0.5), 40, found);
    CHECK(n == 10);
    for (i = 0; i < n; i++) near_eps("turning points", "backward", (double)found[i].t, (double)(10 - i) * pi, 4);
}

static void test_zero_crossings(void)
{
    vm_sample found[40];
    vm_real none = 0;
    long n, i;
    n = vm_find_samples(cosine_motion, NULL, VM_ZERO_CROSSINGS, 0, R(31.5), R(0.5), 40, found);
    CHECK(n == 10);
    for (i = 0; i < n; i++) near_eps("zero crossings", "cos t", (double)found[i].t, ((double)i + 0.5) * pi, 4);
    /* with room for three it finds three and counts all */
    CHECK(vm_find_samples(cosine_motion, NULL, VM_ZERO_CROSSINGS, 0, R(31.5), R(0.5), 3, found) == 10);
    near_eps("envelope error", "velocity",
             1 + (double)vm_envelope_error(VM_ZERO_CROSSINGS, 3, found, decay, &none), 1, 4);
    CHECK(vm_find_samples(tiny_motion, NULL, VM_ZERO_CROSSINGS, 0, R(31.5), R(0.5), 40, found) == 10);
}

static void test_points_of_a_run(void)
{
    const vm_law m = linear(1, 0);
    vm_vdp harmonic = vdp(1, 0, 0, 1, VM_VDP_ATEB);
    vm_real y[2] = {1, 0};
    long n, i;
    harmonic.mass = m;
    n = track(vm_vdp_rhs, &harmonic, 2, 100, 1e-10, y, 0, 1, VM_TURNING_POINTS);
    CHECK(n == 31);
    for (i = 0; i < n; i++)
        near("turning points", "of a run", (double)points[i].t, (double)(i + 1) * pi, 1e-10, 1e-3);
}

static void test_bad_input(void)
{
    vm_real y[2] = {1, 0};
    CHECK(vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, 1, 1, R(0.5), 0, NULL) == 0); /* no time passes */
    CHECK(vm_find_samples(NULL, NULL, 0, 0, 1, 1, 0, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples(cosine_motion, NULL, 2, 0, 1, 1, 0, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples(cosine_motion, NULL, 0, 0, 1, 1, 1, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples(cosine_motion, NULL, 0, 0, 1, 0, 0, NULL) == VM_NOT_FINITE);
    CHECK(vm_find_samples(cosine_motion, NULL, 0, 0, 1, -1, 0, NULL) == VM_NOT_FINITE);
    CHECK(vm_find_samples(cosine_motion, NULL, 0, 0, VM_INFINITY, 1, 0, NULL) == VM_NOT_FINITE);
    CHECK(vm_find_samples(cosine_motion, NULL, 0, 0, 1, VM_NAN, 0, NULL) == VM_NOT_FINITE);
        CHECK(vm_find_samples_of_step(NULL, 0, 1, 0, y, 0, NULL) == VM_BAD_ARGUMENT);

}

/* (1 + 0.1 t)^-exponent, where ctx points to the exponent */
static vm_real power_law(vm_real t, void *ctx)
{
    const vm_real exponent = *(const vm_real *)ctx;
    return vmi_pow_checked(1 + VM_C(0.1) * t, -exponent);
}

/* A sample that is no number is not lost where others follow it. */
static void test_envelope_of_no_number(void)
{
    vm_sample samples[2] = {{0, VM_NAN, 0}, {1, 1, 0}};
    vm_real exponent = 1;
    CHECK(is_nan(vm_envelope_error(VM_TURNING_POINTS, 2, samples, power_law, &exponent)));
    samples[0].x = 1;
    CHECK(vm_envelope_error(VM_TURNING_POINTS, 2, samples, power_law, &exponent) > 0);
    CHECK(is_nan(vm_envelope_error(VM_TURNING_POINTS, -1, samples, power_law, &exponent)));
}

/* Example 1 (398): the reference motion E1, and the errors of the envelopes (399) and (400) */
static void test_envelopes(void)
{
    const vm_law m = linear(1, 0.1);
    vm_vdp v = vdp(3, 0, 0, 1, VM_VDP_ATEB);
    vm_real y[2] = {1, 0}, sixth = 1 / VM_C(6.0), half = VM_C(0.5);
    long n;
    v.mass = m;
    solve(vm_vdp_rhs, &v, 2, 0, 10, 1e-12, y);
    near("(398)", "E1, x(10)", (double)y[0], 0.8329476745754213932, 1e-12, 1e-4);
    near("(398)", "E1, x'(10)", (double)y[1], -0.1999729378502724774, 2e-12, 1e-3);
    solve(vm_vdp_rhs, &v, 2, 10, 20, 1e-12, y);
    near("(398)", "E1, x(20)", (double)y[0], 0.1626996653923250896, 1e-11, 1e-3);
    y[0] = 1;
    y[1] = 0;
    n = track(vm_vdp_rhs, &v, 2, 50, 1e-10, y, 0, 1, VM_TURNING_POINTS);
    near("(399)", "envelope error", (double)vm_envelope_error(VM_TURNING_POINTS, n, points, power_law, &sixth),
         1.4e-4, 0.05, 15);
    near("(400)", "as printed", (double)vm_envelope_error(VM_TURNING_POINTS, n, points, power_law, &half), 0.426,
         2e-3, 5e-3);
}

/* An oscillator without a state of motion, for the adiabaticity */
static vm_osc_problem problem(double alpha, vm_law mass, vm_law stiffness, double reactive, double damping)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = R(alpha);
    o.mass = mass;
    o.stiffness = stiffness;
    o.reactive = R(reactive);
    o.damping = R(damping);
    return o;
}

/* q/Om: in Example 1, where it is m'/m over sqrt(2) A, and with a drifting stiffness and damping; at t = 2 the linear
   laws have other values */
static void test_adiabaticity(void)
{
    const vm_osc_problem example = problem(3, linear(1, 0.1), linear(1, 0), 1, 0);
    const vm_osc_problem all = problem(1, linear(2, 0.5), linear(4, 1), 0, 0.25);
    vm_osc_problem bad = example;
    near_eps("q/Om", "Example 1", (double)vm_adiabaticity(&example, 0, 1), (double)VM_C(0.1) / sqrt(2), 2);
    near_eps("q/Om", "all", (double)vm_adiabaticity(&all, 0, 2), (-0.5 + 0.5) / 2 + 0.25 / sqrt(2), 4);
    near_eps("q/Om", "all, t = 2", (double)vm_adiabaticity(&all, 2, 2), 1 / 6. / sqrt(2), 4);
    CHECK(is_nan(vm_adiabaticity(NULL, 0, 1)) && is_nan(vm_adiabaticity(&example, VM_NAN, 1)));
    CHECK(is_nan(vm_adiabaticity(&example, 0, 0)) && is_nan(vm_adiabaticity(&example, 0, VM_INFINITY)));
    bad.mass = linear(-1, 0);
    CHECK(is_nan(vm_adiabaticity(&bad, 0, 1)));
    bad.mass = vm_law_linear(VM_INFINITY, 1);
    CHECK(is_nan(vm_adiabaticity(&bad, 0, 1)));
    bad.mass = vm_law_linear(1, VM_INFINITY);
    CHECK(is_nan(vm_adiabaticity(&bad, 0, 1)));
    bad = example;
    bad.stiffness = linear(0, 0);
    CHECK(is_nan(vm_adiabaticity(&bad, 0, 1)));
    bad = example;
    bad.alpha = -1;
    CHECK(is_nan(vm_adiabaticity(&bad, 0, 1)));
}

/* A step of the wrong sign is refused, even if it is longer than the interval. */
static void test_wrong_steps(void)
{
    vm_sample found[4];
    CHECK(vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, 1, 4, -5, 4, found) == VM_NOT_FINITE);
    CHECK(vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, 4, 1, 5, 4, found) == VM_NOT_FINITE);
    CHECK(vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, 1, 4, 5, 4, found) == 1);
    CHECK(vm_find_samples(cosine_motion, NULL, VM_TURNING_POINTS, 4, 1, -5, 4, found) == 1);
}

int main(void)
{
    test_turning_points();
    test_zero_crossings();
    test_points_of_a_run();
    test_bad_input();
    test_wrong_steps();
    test_envelope_of_no_number();
    test_envelopes();
    test_adiabaticity();
    return check_finish("diagnostics");
}
