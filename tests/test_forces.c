/* varmass.h, the forces of scenes: vm_force_spring to vm_force_gyroscopic. Each function at random arguments against
   its formula in double precision of the C library, and exactly at the edges: 0, both signs, special exponents, NaN.
   */
#include "../varmass.h"
#include "check.h"

#define REAL(x) ((vm_real)(x))
enum { DRAWS = 1000 };

/* The error of got, in eps of the sum of the absolute values of the terms */
static void agrees(const char *function, const char *where, vm_real got, double wanted, double terms, double bound,
                   double x)
{
    const double scale = terms > 0 ? terms : 1;
    check_error(function, where, "eps", fabs((double)got - wanted) / (scale * (double)VM_EPSILON), bound, x, wanted);
}

static int is_nan(vm_real x) { return x != x; }

/* ---- Forces on one coordinate ---- */

/* -k x |x|^(alpha-1) */
static double spring_by_hand(double k, double alpha, double x) { return -k * copysign(pow(fabs(x), alpha), x); }

static void check_spring_values(void)
{
    static const double powers[] = {0, 0.25, 0.5, 1, 1.5, 2, 2.75, 3, 4, 5};
    size_t i;
    int n;
    for (i = 0; i < sizeof powers / sizeof *powers; i++) {
        for (n = 0; n < DRAWS; n++) {
            const double k = copysign(uniform(0.5, 3), uniform(-1, 1)), x = uniform(-4, 4), wanted = spring_by_hand(k, powers[i], x);
            const vm_real got = vm_force_spring(REAL(x), REAL(k), REAL(powers[i]));
            agrees("vm_force_spring", "|x| < 4", got, wanted, fabs(wanted), 4, x);
            CHECK(vm_force_spring(REAL(-x), REAL(k), REAL(powers[i])) == -got); /* odd in x */
        }
    }
}

static void check_spring_edges(void)
{
    static const double powers[] = {0, 0.5, 1, 1.5, 2, 3, 4};
    size_t i;
    for (i = 0; i < sizeof powers / sizeof *powers; i++) {
        const vm_real alpha = REAL(powers[i]);
        CHECK(vm_force_spring(0, 2, alpha) == 0); /* with alpha = 0, too, where the force jumps */
        CHECK(vm_force_spring(REAL(-0.0), 2, alpha) == 0);
        CHECK(vm_force_spring(3, 0, alpha) == 0);
        CHECK(vm_force_spring(1, 2, alpha) == -2 && vm_force_spring(-1, 2, alpha) == 2);
        CHECK(is_nan(vm_force_spring(VM_NAN, 2, alpha)));
        CHECK(is_nan(vm_force_spring(1, VM_NAN, alpha)));
    }
    CHECK(vm_force_spring(REAL(0.125), 3, 0) == -3 && vm_force_spring(-100, 3, 0) == 3); /* dry friction */
    CHECK(vm_force_spring(REAL(0.125), 3, 1) == REAL(-0.375));
    CHECK(vm_force_spring(-2, 3, 2) == 12 && vm_force_spring(-2, 3, 3) == 24);
    CHECK(vm_force_spring(2, -3, 1) == 6 && vm_force_spring(2, -3, 2) == 12 && vm_force_spring(2, -3, 3) == 24);
    CHECK(vm_force_spring(2, -3, 0) == 3 && vm_force_spring(2, -3, 4) == 48); /* a negative stiffness pushes away */
    CHECK(is_nan(vm_force_spring(2, 1, VM_NAN)));
}

/* Next to an exponent that has a branch of its own the force is nearly the same: d/d alpha = -k |x|^alpha log|x|. */
static void check_spring_branches(void)
{
    int alpha;
    for (alpha = 1; alpha <= 3; alpha++) {
        const vm_real beside = REAL(alpha) * (1 + 4 * VM_EPSILON);
        vm_real x;
        for (x = REAL(0.25); x < 3; x += REAL(0.5)) {
            const double slope = pow((double)x, alpha) * log((double)x);
            const double wanted = (double)vm_force_spring(x, 1, REAL(alpha)) - slope * ((double)beside - alpha);
            agrees("vm_force_spring", "beside 1, 2, 3", vm_force_spring(x, 1, beside), wanted, fabs(wanted), 4,
                   (double)x);
        }
    }
}

static void check_damper(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double b = uniform(-3, 3), v = uniform(-4, 4);
        agrees("vm_force_damper", "random", vm_force_damper(REAL(v), REAL(b)), -b * v, fabs(b * v), 0.5, v);
    }
    CHECK(vm_force_damper(3, 2) == -6 && vm_force_damper(-3, 2) == 6); /* b > 0 takes energy out */
    CHECK(vm_force_damper(0, 2) == 0 && vm_force_damper(2, 0) == 0);
    CHECK(is_nan(vm_force_damper(VM_NAN, 2)));
}

static void check_van_der_pol(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double b = uniform(-2, 2), c = uniform(0, 2), x = uniform(-3, 3), v = uniform(-3, 3);
        agrees("vm_force_van_der_pol", "random", vm_force_van_der_pol(REAL(x), REAL(v), REAL(b), REAL(c)),
               (b - c * x * x) * v, (fabs(b) + c * x * x) * fabs(v), 2, x);
    }
    CHECK(vm_force_van_der_pol(0, 3, 2, 1) == 6);   /* fed at x = 0 */
    CHECK(vm_force_van_der_pol(2, 3, 4, 1) == 0);   /* neither at x^2 = b/c */
    CHECK(vm_force_van_der_pol(-3, 2, 4, 1) == -10); /* damped beyond */
    CHECK(vm_force_van_der_pol(5, 3, -2, 0) == vm_force_damper(3, 2));
    CHECK(vm_force_van_der_pol(5, 0, 2, 1) == 0);
    CHECK(is_nan(vm_force_van_der_pol(VM_NAN, 1, 1, 1)) && is_nan(vm_force_van_der_pol(1, VM_NAN, 1, 1)));
}

static void check_drive(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double torque = uniform(-3, 3), kappa = uniform(-2, 2), omega = uniform(-4, 4);
        agrees("vm_force_motor", "random", vm_force_motor(REAL(omega), REAL(torque), REAL(kappa)),
               torque - kappa * omega, fabs(torque) + fabs(kappa * omega), 1, omega);
    }
    CHECK(vm_force_motor(0, 6, 2) == 6 && vm_force_motor(3, 6, 2) == 0 && vm_force_motor(-3, 6, 2) == 12);
    CHECK(vm_force_motor(100, 6, 0) == 6);
    CHECK(is_nan(vm_force_motor(VM_NAN, 6, 2)));
}

/* The error is that of the cosine and of its rounded argument. */
static void check_harmonic(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double force = uniform(-3, 3), frequency = uniform(0, 4), phase = uniform(-3, 3), t = uniform(0, 10);
        const double size = fabs(force) * (1 + frequency * t + fabs(frequency * t + phase));
        agrees("vm_force_harmonic", "random",
               vm_force_harmonic(REAL(t), REAL(force), REAL(frequency), REAL(phase)),
               force * cos(frequency * t + phase), size, 1, t);
    }
    CHECK(vm_force_harmonic(0, 3, 2, 0) == 3 && vm_force_harmonic(5, -3, 0, 0) == -3);
    CHECK(vm_force_harmonic(5, 0, 2, 1) == 0);
    CHECK(vm_force_harmonic(5, 3, 2, 1) == vm_force_harmonic(-5, 3, 2, -1)); /* even in the angle */
    CHECK(is_nan(vm_force_harmonic(VM_INFINITY, 3, 2, 1)) && is_nan(vm_force_harmonic(1, 3, VM_NAN, 1)));
}

/* rate (u - reactive v) */
static void check_stream(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double rate = uniform(-2, 2), u = uniform(-3, 3), reactive = uniform(0, 1), v = uniform(-3, 3);
        agrees("vm_force_stream", "random", vm_force_stream(REAL(v), REAL(rate), REAL(u), REAL(reactive)),
               rate * (u - reactive * v), fabs(rate) * (fabs(u) + reactive * fabs(v)), 2, v);
    }
    CHECK(vm_force_stream(7, -2, 0, 0) == 0);   /* what leaves has the body's velocity: no reactive force */
    CHECK(vm_force_stream(7, 2, 0, 1) == -14);  /* what joins is at rest: full reactive force */
    CHECK(vm_force_stream(7, -2, 4, 1) == 6);   /* its own velocity is 4 m/s */
    CHECK(vm_force_stream(7, -2, -3, 0) == 6);  /* a rocket: thrown backwards at 3 m/s relative to the body */
    CHECK(vm_force_stream(8, 2, 0, REAL(0.5)) == -8);
    CHECK(vm_force_stream(7, 0, 4, 1) == 0);
    CHECK(is_nan(vm_force_stream(VM_NAN, 1, 0, 1)));
}

static void check_gravity(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double mass = uniform(0, 10), g = uniform(-10, 10);
        agrees("vm_force_gravity", "random", vm_force_gravity(REAL(mass), REAL(g)), mass * g, fabs(mass * g), 0.5, g);
    }
    CHECK(vm_force_gravity(2, -10) == -20 && vm_force_gravity(2, 10) == 20); /* downwards where g < 0 */
    CHECK(vm_force_gravity(0, -10) == 0 && vm_force_gravity(2, 0) == 0);
    CHECK(is_nan(vm_force_gravity(2, VM_NAN)));
}

/* ---- Forces in the plane ---- */

/* -k r |r|^(alpha-1), towards the origin */
static void check_shaft(void)
{
    static const double powers[] = {0, 0.5, 1, 1.5, 2, 3};
    vm_real fx, fy;
    size_t i;
    int n;
    for (i = 0; i < sizeof powers / sizeof *powers; i++) {
        const vm_real alpha = REAL(powers[i]);
        for (n = 0; n < DRAWS; n++) {
            const double k = uniform(0.5, 3), x = uniform(-3, 3), y = uniform(-3, 3), r = hypot(x, y);
            const double force = -k * pow(r, powers[i]);
            vm_force_shaft(REAL(x), REAL(y), REAL(k), alpha, &fx, &fy);
            agrees("vm_force_shaft", "x", fx, force * x / r, fabs(force), 6, x);
            agrees("vm_force_shaft", "y", fy, force * y / r, fabs(force), 6, y);
        }
        vm_force_shaft(0, 0, 2, alpha, &fx, &fy); /* no direction, no force */
        CHECK(fx == 0 && fy == 0);
        vm_force_shaft(-1, 0, 2, alpha, &fx, &fy);
        CHECK(fx == 2 && fy == 0);
        vm_force_shaft(0, 1, 2, alpha, &fx, &fy);
        CHECK(fx == 0 && fy == -2);
    }
    vm_force_shaft(3, -4, 2, 1, &fx, &fy);
    CHECK(fx == -6 && fy == 8);
    vm_force_shaft(3, -4, 2, 2, &fx, &fy); /* r = 5 */
    CHECK(fx == -30 && fy == 40);
}

/* The length of r neither overflows nor underflows: with alpha = 0 the force is k at every distance, with alpha = 1 it
   is -k r. One coordinate that is NaN makes both components NaN. */
static void check_shaft_range(void)
{
    vm_real r, fx, fy;
    for (r = VM_MIN; r < VM_MAX / 2048; r *= 1024) {
        vm_force_shaft(r, 0, 2, 0, &fx, &fy);
        CHECK(fx == -2 && fy == 0);
        vm_force_shaft(0, r, 2, 1, &fx, &fy);
        CHECK(fx == 0 && fy == -2 * r);
        vm_force_shaft(-3 * r, 4 * r, 2, 0, &fx, &fy);
        agrees("vm_force_shaft", "VM_MIN to VM_MAX", fx, 1.2, 2, 6, (double)r);
        agrees("vm_force_shaft", "VM_MIN to VM_MAX", fy, -1.6, 2, 6, (double)r);
    }
    for (r = 1; r < 1 / VM_EPSILON; r *= 2) { /* 1/r, r or the force divided by r is beyond the range of the type */
        const vm_real least = VM_MIN * VM_EPSILON * r, most = VM_MAX * (1 - VM_EPSILON) / r;
        const vm_real weak = 16 * VM_MIN / VM_EPSILON;
        vm_force_shaft(least, 0, REAL(1e10), 0, &fx, &fy);
        CHECK(fx == REAL(-1e10) && fy == 0);
        vm_force_shaft(least, -least, 2, 0, &fx, &fy);
        agrees("vm_force_shaft", "subnormal", fx, -sqrt(2), 2, 6, (double)r);
        agrees("vm_force_shaft", "subnormal", fy, sqrt(2), 2, 6, (double)r);
        vm_force_shaft(least, least, 1, REAL(0.5), &fx, &fy);
        agrees("vm_force_shaft", "subnormal", fx, -sqrt(sqrt(0.5)) * sqrt((double)least), sqrt((double)least), 6,
               (double)r);
        vm_force_shaft(most, most, 2, 0, &fx, &fy);
        agrees("vm_force_shaft", "VM_MAX", fx, -sqrt(2), 2, 6, (double)r);
        agrees("vm_force_shaft", "VM_MAX", fy, -sqrt(2), 2, 6, (double)r);
        vm_force_shaft(0, most, weak, 0, &fx, &fy);
        CHECK(fx == 0 && fy == -weak);
    }
    vm_force_shaft(0, VM_EPSILON, VM_MAX / 2, 0, &fx, &fy);
    CHECK(fx == 0 && fy == -VM_MAX / 2);
    vm_force_shaft(VM_NAN, 1, 2, 0, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_shaft(1, VM_NAN, 2, 1, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
}

/* unbalance frequency^2 (cos, sin)(frequency t + phase) */
static void check_unbalance(void)
{
    vm_real fx, fy;
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double unbalance = uniform(-1, 1), frequency = uniform(0, 4), phase = uniform(-3, 3), t = uniform(0, 10);
        const double angle = frequency * t + phase, force = unbalance * frequency * frequency;
        const double size = fabs(force) * (1 + frequency * t + fabs(angle));
        vm_force_unbalance(REAL(t), REAL(unbalance), REAL(frequency), REAL(phase), &fx, &fy);
        agrees("vm_force_unbalance", "x", fx, force * cos(angle), size, 2, t);
        agrees("vm_force_unbalance", "y", fy, force * sin(angle), size, 2, t);
    }
    vm_force_unbalance(0, 3, 2, 0, &fx, &fy);
    CHECK(fx == 12 && fy == 0);
    vm_force_unbalance(5, 3, 0, 1, &fx, &fy); /* it does not turn */
    CHECK(fx == 0 && fy == 0);
    vm_force_unbalance(REAL(0.125), 3, 2, 0, &fx, &fy); /* it turns from x to y */
    CHECK(fx > 0 && fy > 0);
    vm_force_unbalance(REAL(0.125), 3, -2, 0, &fx, &fy);
    CHECK(fx > 0 && fy < 0);
}

/* 2 gyro (-vy, vx) */
static void check_gyroscopic(void)
{
    vm_real fx, fy;
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double gyro = uniform(-2, 2), vx = uniform(-3, 3), vy = uniform(-3, 3);
        vm_force_gyroscopic(REAL(vx), REAL(vy), REAL(gyro), &fx, &fy);
        agrees("vm_force_gyroscopic", "x", fx, -2 * gyro * vy, fabs(2 * gyro * vy), 0.5, vy);
        agrees("vm_force_gyroscopic", "y", fy, 2 * gyro * vx, fabs(2 * gyro * vx), 0.5, vx);
    }
    vm_force_gyroscopic(3, 5, 1, &fx, &fy);
    CHECK(fx == -10 && fy == 6);
    CHECK(fx * 3 + fy * 5 == 0); /* no power */
    vm_force_gyroscopic(0, 0, 1, &fx, &fy);
    CHECK(fx == 0 && fy == 0);
}

/* Without room for a result nothing is written, and a NaN comes back as one. */
static void check_results_in_the_plane(void)
{
    vm_real fx = 7, fy = 7;
    vm_force_shaft(1, 1, 1, 1, &fx, NULL);
    vm_force_shaft(1, 1, 1, 1, NULL, &fy);
    vm_force_unbalance(1, 1, 1, 1, &fx, NULL);
    vm_force_unbalance(1, 1, 1, 1, NULL, &fy);
    vm_force_gyroscopic(1, 1, 1, &fx, NULL);
    vm_force_gyroscopic(1, 1, 1, NULL, &fy);
    CHECK(fx == 7 && fy == 7);
    vm_force_shaft(1, 1, VM_NAN, 2, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_shaft(1, 1, 1, VM_NAN, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_unbalance(1, 1, 1, VM_NAN, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_gyroscopic(1, 1, VM_NAN, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
}

int main(void)
{
    check_spring_values();
    check_spring_edges();
    check_spring_branches();
    check_damper();
    check_van_der_pol();
    check_drive();
    check_harmonic();
    check_stream();
    check_gravity();
    check_shaft();
    check_shaft_range();
    check_unbalance();
    check_gyroscopic();
    check_results_in_the_plane();
    return check_finish("forces");
}
