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
            const double k = uniform(0.5, 3), x = uniform(-4, 4), wanted = spring_by_hand(k, powers[i], x);
            const vm_real got = vm_force_spring(REAL(k), REAL(powers[i]), REAL(x));
            agrees("vm_force_spring", "|x| < 4", got, wanted, fabs(wanted), 4, x);
            CHECK(vm_force_spring(REAL(k), REAL(powers[i]), REAL(-x)) == -got); /* odd in x */
        }
    }
}

static void check_spring_edges(void)
{
    static const double powers[] = {0, 0.5, 1, 1.5, 2, 3, 4};
    size_t i;
    for (i = 0; i < sizeof powers / sizeof *powers; i++) {
        const vm_real alpha = REAL(powers[i]);
        CHECK(vm_force_spring(2, alpha, 0) == 0); /* with alpha = 0, too, where the force jumps */
        CHECK(vm_force_spring(2, alpha, REAL(-0.0)) == 0);
        CHECK(vm_force_spring(0, alpha, 3) == 0);
        CHECK(vm_force_spring(2, alpha, 1) == -2 && vm_force_spring(2, alpha, -1) == 2);
        CHECK(is_nan(vm_force_spring(2, alpha, VM_NAN)));
        CHECK(is_nan(vm_force_spring(VM_NAN, alpha, 1)));
    }
    CHECK(vm_force_spring(3, 0, REAL(0.125)) == -3 && vm_force_spring(3, 0, -100) == 3); /* dry friction */
    CHECK(vm_force_spring(3, 1, REAL(0.125)) == REAL(-0.375));
    CHECK(vm_force_spring(3, 2, -2) == 12 && vm_force_spring(3, 3, -2) == 24);
    CHECK(vm_force_spring(-3, 1, 2) == 6 && vm_force_spring(-3, 2, 2) == 12 && vm_force_spring(-3, 3, 2) == 24);
    CHECK(is_nan(vm_force_spring(1, VM_NAN, 2)));
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
            const double wanted = (double)vm_force_spring(1, REAL(alpha), x) - slope * ((double)beside - alpha);
            agrees("vm_force_spring", "beside 1, 2, 3", vm_force_spring(1, beside, x), wanted, fabs(wanted), 4,
                   (double)x);
        }
    }
}

static void check_damper(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double b = uniform(-3, 3), v = uniform(-4, 4);
        agrees("vm_force_damper", "random", vm_force_damper(REAL(b), REAL(v)), -b * v, fabs(b * v), 0.5, v);
    }
    CHECK(vm_force_damper(2, 3) == -6 && vm_force_damper(2, -3) == 6); /* b > 0 takes energy out */
    CHECK(vm_force_damper(2, 0) == 0 && vm_force_damper(0, 2) == 0);
    CHECK(is_nan(vm_force_damper(2, VM_NAN)));
}

static void check_van_der_pol(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double b = uniform(-2, 2), c = uniform(0, 2), x = uniform(-3, 3), v = uniform(-3, 3);
        agrees("vm_force_van_der_pol", "random", vm_force_van_der_pol(REAL(b), REAL(c), REAL(x), REAL(v)),
               (b - c * x * x) * v, (fabs(b) + c * x * x) * fabs(v), 2, x);
    }
    CHECK(vm_force_van_der_pol(2, 1, 0, 3) == 6);   /* fed at x = 0 */
    CHECK(vm_force_van_der_pol(4, 1, 2, 3) == 0);   /* neither at x^2 = b/c */
    CHECK(vm_force_van_der_pol(4, 1, -3, 2) == -10); /* damped beyond */
    CHECK(vm_force_van_der_pol(-2, 0, 5, 3) == vm_force_damper(2, 3));
    CHECK(vm_force_van_der_pol(2, 1, 5, 0) == 0);
    CHECK(is_nan(vm_force_van_der_pol(1, 1, VM_NAN, 1)) && is_nan(vm_force_van_der_pol(1, 1, 1, VM_NAN)));
}

static void check_drive(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double torque = uniform(-3, 3), kappa = uniform(-2, 2), omega = uniform(-4, 4);
        agrees("vm_force_motor", "random", vm_force_motor(REAL(torque), REAL(kappa), REAL(omega)),
               torque - kappa * omega, fabs(torque) + fabs(kappa * omega), 1, omega);
    }
    CHECK(vm_force_motor(6, 2, 0) == 6 && vm_force_motor(6, 2, 3) == 0 && vm_force_motor(6, 2, -3) == 12);
    CHECK(vm_force_motor(6, 0, 100) == 6);
    CHECK(is_nan(vm_force_motor(6, 2, VM_NAN)));
}

/* The error is that of the cosine and of its rounded argument. */
static void check_harmonic(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double force = uniform(-3, 3), frequency = uniform(0, 4), phase = uniform(-3, 3), t = uniform(0, 10);
        const double size = fabs(force) * (1 + frequency * t + fabs(frequency * t + phase));
        agrees("vm_force_harmonic", "random",
               vm_force_harmonic(REAL(force), REAL(frequency), REAL(phase), REAL(t)),
               force * cos(frequency * t + phase), size, 1, t);
    }
    CHECK(vm_force_harmonic(3, 2, 0, 0) == 3 && vm_force_harmonic(-3, 0, 0, 5) == -3);
    CHECK(vm_force_harmonic(0, 2, 1, 5) == 0);
    CHECK(vm_force_harmonic(3, 2, 1, 5) == vm_force_harmonic(3, 2, -1, -5)); /* even in the angle */
    CHECK(is_nan(vm_force_harmonic(3, 2, 1, VM_INFINITY)) && is_nan(vm_force_harmonic(3, VM_NAN, 1, 1)));
}

/* rate (u + share v - v) */
static void check_stream(void)
{
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double rate = uniform(-2, 2), u = uniform(-3, 3), share = uniform(0, 1), v = uniform(-3, 3);
        agrees("vm_force_stream", "random", vm_force_stream(REAL(rate), REAL(u), REAL(share), REAL(v)),
               rate * (u - (1 - share) * v), fabs(rate) * (fabs(u) + (1 - share) * fabs(v)), 2, v);
    }
    CHECK(vm_force_stream(-2, 0, 1, 7) == 0);   /* what leaves has the body's velocity: no reactive force */
    CHECK(vm_force_stream(2, 0, 0, 7) == -14);  /* what joins is at rest: full reactive force */
    CHECK(vm_force_stream(-2, 4, 0, 7) == 6);   /* its own velocity is 4 m/s */
    CHECK(vm_force_stream(-2, -3, 1, 7) == 6);  /* a rocket: thrown backwards at 3 m/s relative to the body */
    CHECK(vm_force_stream(2, 0, REAL(0.5), 8) == -8);
    CHECK(vm_force_stream(0, 4, 0, 7) == 0);
    CHECK(is_nan(vm_force_stream(1, 0, 0, VM_NAN)));
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
            vm_force_shaft(REAL(k), alpha, REAL(x), REAL(y), &fx, &fy);
            agrees("vm_force_shaft", "x", fx, force * x / r, fabs(force), 6, x);
            agrees("vm_force_shaft", "y", fy, force * y / r, fabs(force), 6, y);
        }
        vm_force_shaft(2, alpha, 0, 0, &fx, &fy); /* no direction, no force */
        CHECK(fx == 0 && fy == 0);
        vm_force_shaft(2, alpha, -1, 0, &fx, &fy);
        CHECK(fx == 2 && fy == 0);
        vm_force_shaft(2, alpha, 0, 1, &fx, &fy);
        CHECK(fx == 0 && fy == -2);
    }
    vm_force_shaft(2, 1, 3, -4, &fx, &fy);
    CHECK(fx == -6 && fy == 8);
    vm_force_shaft(2, 2, 3, -4, &fx, &fy); /* r = 5 */
    CHECK(fx == -30 && fy == 40);
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
        vm_force_unbalance(REAL(unbalance), REAL(frequency), REAL(phase), REAL(t), &fx, &fy);
        agrees("vm_force_unbalance", "x", fx, force * cos(angle), size, 2, t);
        agrees("vm_force_unbalance", "y", fy, force * sin(angle), size, 2, t);
    }
    vm_force_unbalance(3, 2, 0, 0, &fx, &fy);
    CHECK(fx == 12 && fy == 0);
    vm_force_unbalance(3, 0, 1, 5, &fx, &fy); /* it does not turn */
    CHECK(fx == 0 && fy == 0);
    vm_force_unbalance(3, 2, 0, REAL(0.125), &fx, &fy); /* it turns from x to y */
    CHECK(fx > 0 && fy > 0);
    vm_force_unbalance(3, -2, 0, REAL(0.125), &fx, &fy);
    CHECK(fx > 0 && fy < 0);
}

/* coupling (-vy, vx) */
static void check_gyroscopic(void)
{
    vm_real fx, fy;
    int n;
    for (n = 0; n < DRAWS; n++) {
        const double coupling = uniform(-2, 2), vx = uniform(-3, 3), vy = uniform(-3, 3);
        vm_force_gyroscopic(REAL(coupling), REAL(vx), REAL(vy), &fx, &fy);
        agrees("vm_force_gyroscopic", "x", fx, -coupling * vy, fabs(coupling * vy), 0.5, vy);
        agrees("vm_force_gyroscopic", "y", fy, coupling * vx, fabs(coupling * vx), 0.5, vx);
    }
    vm_force_gyroscopic(2, 3, 5, &fx, &fy);
    CHECK(fx == -10 && fy == 6);
    CHECK(fx * 3 + fy * 5 == 0); /* no power */
    vm_force_gyroscopic(2, 0, 0, &fx, &fy);
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
    vm_force_shaft(VM_NAN, 2, 1, 1, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_shaft(1, VM_NAN, 1, 1, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_unbalance(1, 1, VM_NAN, 1, &fx, &fy);
    CHECK(is_nan(fx) && is_nan(fy));
    vm_force_gyroscopic(VM_NAN, 1, 1, &fx, &fy);
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
    check_unbalance();
    check_gyroscopic();
    check_results_in_the_plane();
    return check_finish("forces");
}
