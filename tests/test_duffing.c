/* Duffing's oscillator with constant mass: motions, periods and actions against numbers of 20 digits by Taylor series
   and quadrature (tests/gen/duffing.py), conservation of energy, the limits of a linear and of a purely cubic spring,
   the separatrix, motions next to it, and what is refused. test_odd_force.c tests its motion with slow mass, stiffness
   and damping. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

/* By how much rounding errors of c1 + c3 A^2 and c1 + c3 A^2/2 grow because these terms cancel */
static double cancellation(double c1, double c3, double x0, double v0)
{
    const vm_odd_force force = vm_duffing_force(R(c1), R(c3));
    vmi_orbit orbit = {0};
    double rest = 1, square;
    CHECK(vmi_orbit_of_state(&force, R(x0), R(v0), &orbit) == VM_OK);
    square = (double)(orbit.size * orbit.size);
    if (orbit.place != VMI_ORBIT_AROUND_0) return 1 + 2 / (double)orbit.m1;
    if (c1 * c3 < 0) rest = fmin(fabs(1 + c3 * square / c1), fabs(1 + c3 * square / c1 / 2));
    return 1 + 1 / rest;
}

static void test_table(void)
{
    static const double table[][9] = {
#include "data/duffing_table.h"
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const double c1 = table[i][0], c3 = table[i][1], x0 = table[i][2], v0 = table[i][3], t = table[i][4];
        const double period = table[i][7], turns = 1 + fabs(t) / period, cancels = cancellation(c1, c3, x0, v0);
        const vm_odd_force force = vm_duffing_force(R(c1), R(c3));
        const char *kind = cancels > 4 ? "cancelling" : "plain";
        vmi_orbit orbit;
        double amplitude, vmax;
        vm_real x, v;
        memset(&orbit, 0, sizeof orbit);
        vm_duffing_exact_from(R(t), R(x0), R(v0), R(c1), R(c3), &x, &v);
        CHECK(vmi_orbit_of_state(&force, R(x0), R(v0), &orbit) == VM_OK);
        amplitude = (double)vmi_orbit_amplitude(&orbit);
        vmax = (double)orbit.vmax;
        check_error("exact x", kind, "eps", ERROR_EPS(x, table[i][5], 0, amplitude) / (turns * cancels), 32, c1, x0);
        check_error("exact v", kind, "eps", ERROR_EPS(v, table[i][6], 0, vmax) / (turns * cancels), 32, c1, x0);
        check_error("w", kind, "eps", relative_error(2 * (double)VM_PI / (double)orbit.w, period) / (eps * cancels), 8, c1, x0);
        check_error("action", kind, "eps", relative_error((double)orbit.j, table[i][8]) / (eps * cancels), 24, c1, x0);
        if (v0 != 0) continue;
        near_eps("vm_duffing_period", kind, (double)vm_duffing_period(R(x0), R(c1), R(c3)), period, 8 * cancels);
        near_eps("vm_duffing_action", kind, (double)vm_duffing_action(R(x0), R(c1), R(c3)), table[i][8], 8 * cancels);
    }
}

/* At random states, coefficients of any sign and times of up to some hundred periods the motion keeps its energy, and
   goes back to where it came from. */
static void test_energy_and_return(void)
{
    int i, bound_motions = 0;
    for (i = 0; i < 4000; i++) {
        const double c1 = uniform(-2, 2), c3 = uniform(-1, 2), x0 = uniform(-2, 2), v0 = uniform(-2, 2);
        const double t = uniform(-100, 100);
        const vm_odd_force force = vm_duffing_force(R(c1), R(c3));
        vmi_orbit orbit;
        vm_real x, v, back_x, back_v;
        double scale, turns, cancels;
        vm_duffing_exact_from(R(t), R(x0), R(v0), R(c1), R(c3), &x, &v);
        if (vmi_orbit_of_state(&force, R(x0), R(v0), &orbit)) {
            CHECK(is_nan(x) && is_nan(v));
            continue;
        }
        bound_motions++;
        cancels = cancellation(c1, c3, x0, v0);
        turns = 1 + fabs(t) * (double)orbit.w / (2 * (double)VM_PI);
        scale = (double)(orbit.vmax * orbit.vmax);
        check_error("energy", "random", "eps", fabs((double)vm_duffing_energy(x, v, R(c1), R(c3)) -
                    (double)vm_duffing_energy(R(x0), R(v0), R(c1), R(c3))) / (eps * scale * cancels), 32, c1, c3);
        vm_duffing_exact_from(R(-t), x, v, R(c1), R(c3), &back_x, &back_v);
        check_error("return", "random", "eps", fabs((double)back_x - x0) / (eps * (double)orbit.swing * turns *
                    cancels * cancels), 128, c1, c3);
    }
    CHECK(bound_motions > 2000);
}

/* For c3 -> 0 the motion is a cosine, for c1 -> 0 the Ateb function ca of alpha = 3; both limits are continuous. */
static void test_limits(void)
{
    int i;
    for (i = 0; i < 200; i++) {
        const double A = uniform(0.5, 2), t = uniform(0, 20), tiny = eps / 16;
        vm_real x, v, want_x, want_v;
        vm_duffing_exact_from(R(t), R(A), 0, 1, R(i % 2 ? tiny : -tiny), &x, &v);
        check_error("c3 -> 0", "x", "eps", fabs((double)x - A * cos(t)) / (eps * A * (1 + t)), 4, A, t);
        check_error("c3 -> 0", "v", "eps", fabs((double)v + A * sin(t)) / (eps * A * (1 + t)), 4, A, t);
        vm_osc_exact_from(R(t), R(A), 0, 1, 3, &want_x, &want_v);
        vm_duffing_exact_from(R(t), R(A), 0, R(i % 3 == 0 ? 0 : i % 3 == 1 ? tiny : -tiny), 1, &x, &v);
        check_error("c1 -> 0", "x", "eps", fabs((double)(x - want_x)) / (eps * A * (1 + t * A)), 8, A, t);
        check_error("c1 -> 0", "v", "eps", fabs((double)(v - want_v)) / (eps * A * A * (1 + t * A)), 8, A, t);
        near_eps("period", "linear", (double)vm_duffing_period(R(A), 4, 0), (double)VM_PI, 4);
        near_eps("period", "cubic", (double)vm_duffing_period(R(A), 0, 1), (double)vm_osc_period(R(A), 1, 3), 8);
        near_eps("action", "linear", (double)vm_duffing_action(R(A), 4, 0), A * A, 8);
    }
}

/* On the separatrix of two wells x = A/cosh(t); close to it, inside and outside, the motion follows it for some time,
   and the period grows as a logarithm. */
static void test_separatrix(void)
{
    const double A = sqrt(2.);
    double t, period = 0;
    int i;
    vm_real x, v;
    for (t = -8; t <= 8; t += 0.25) {
        vm_duffing_exact_from(R(t), 2, 0, -1, R(0.5), &x, &v);
        check_error("separatrix", "x", "eps", fabs((double)x - 2 / cosh(t)) / (2 * eps / cosh(t)), 32, t, 0);
        check_error("separatrix", "v", "eps", fabs((double)v + 2 * tanh(t) / cosh(t)) / (2 * eps / cosh(t)), 48, t, 0);
        vm_duffing_exact_from(R(t), -2, 0, -1, R(0.5), &x, &v);
        CHECK((double)x < 0);
    }
    CHECK(vm_duffing_period(2, -1, R(0.5)) == VM_INFINITY && vm_duffing_period(-2, -1, R(0.5)) == VM_INFINITY);
    CHECK(is_nan(vm_duffing_action(2, -1, R(0.5))));
    for (i = 1; i < 18; i++) {
        const double off = ldexp(1, -i);
        const double outside = (double)vm_duffing_period(R(A + off), -1, 1);
        CHECK(outside > period && outside < 4 * log(16 / off));
        period = outside;
        CHECK((double)vm_duffing_period(R(A - off / 4), -1, 1) < outside + 4);
    }
    /* A softening spring: the amplitude 1 rests in unstable equilibrium, larger ones run away. */
    CHECK(is_nan(vm_duffing_period(1, 1, -1)) && is_nan(vm_duffing_period(R(1.5), 1, -1)));
    CHECK((double)vm_duffing_period(R(1 - 64 * eps), 1, -1) > 12 && (double)vm_duffing_period(R(0.5), 1, -1) < 8);
    vm_duffing_exact_from(1, 0, 2, 1, -1, &x, &v);
    CHECK(is_nan(x) && is_nan(v));
}

/* Starts next to x = 0, between two wells, whose energy is smaller than the rounding errors of the orbit's size:
   c1, c3, x0, v0, t, x, v and the period, by Taylor series of 60 digits. The errors are those that the comment of
   vm_duffing_exact_from allows. */
static void test_between_the_wells(void)
{
    static const double table[][8] = {
        {-2, 1, 0, 0x1p-33, 1, 1.59290953540311972e-10, 2.53573939740724264e-10, 71.558844473203945},
        {-1, 1, 0, 0x1p-30, 40, 7.29831993734444254e-8, -7.29891413329538559e-8, 90.1091334727928902},
        {-1, 1, 0x1p-30, 0, -50, 6.54434975123769517e-8, -6.54368703783615456e-8, 45.0545667363964451},
        {-2, 1, 0x1p-40, 0x1p-37, 0.25, 2.82405528208420002e-12, 8.19974234051430771e-12, 79.4458090606964938},
        {-2, 1, -0x1p-40, 0x1p-37, 30, 2.83597741664928295e-6, -4.01067772521159114e-6, 79.4458090606964938},
        {-1, 2, 0x3p-20, 0x2p-20, 45, 0.16777569105709722, -0.165397503542550261, 28.8890380323053875},
        {-1, 2, -0x3p-20, -0x2p-20, 45, -0.16777569105709722, 0.165397503542550261, 28.8890380323053875},
        {-1, 0.5, 0x3p-20, -0x4p-20, 30, -2.63299665637980012e-6, 3.64679781519656499e-6, 59.8777203133355611},
        {-3, 1, 0x1p-60, 0x2p-60, -40, -2.91571336779627406e-10, -5.05016369333090743e-10, 102.584314223468896},
        {-1, 1, 0x1p-24, -0x3p-25, 12, -0.00242523359846563111, -0.00242523003321928597, 73.0273140367256699},
        {-0x1.c1d546p+1, 0x1.c208ecp+1, 0, 0x1.5e4dfap-2, 0x1.6afd6cp-3, 0.0617537644286065439, 0.36111622226015449,
         7.28102838854935365},
        {-0x1.2d0deap+1, 0x1.2c30b2p-2, 0, 0x1.bf875p-1, 0x1.ddd406p-1, 1.11250366521037329, 1.85754038191518345,
         8.63797101003776152},
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const double c1 = table[i][0], x0 = table[i][2], v0 = table[i][3], t = table[i][4], lambda = sqrt(-c1);
        const double r = (v0 * v0 - c1 * x0 * x0) / fabs(v0 * v0 + c1 * x0 * x0);
        const double size = fmax(fabs(table[i][5]), fabs(table[i][6]) / lambda);
        const double allowed = r * (1 + lambda * (fabs(t) + table[i][7] / 4));
        const vm_odd_force force = vm_duffing_force(R(c1), R(table[i][1]));
        vm_real x, v;
        vm_duffing_exact_from(R(t), R(x0), R(v0), R(c1), R(table[i][1]), &x, &v);
        check_error("tiny energy", "x", "eps", ERROR_EPS(x, table[i][5], 0, size) / allowed, 16, x0, v0);
        check_error("tiny energy", "v", "eps", ERROR_EPS(v, table[i][6], 0, lambda * size) / allowed, 16, x0, v0);
        if (is_float && fabs(x0) == ldexp(1, -60)) continue; /* vm_odd_exact_from takes it for the separatrix */
        CHECK(vm_odd_exact_from(&force, R(t), R(x0), R(v0), &x, &v) == VM_OK);
        check_error("tiny energy", "odd x", "eps", ERROR_EPS(x, table[i][5], 0, size) / allowed, 16, x0, v0);
        check_error("tiny energy", "odd v", "eps", ERROR_EPS(v, table[i][6], 0, lambda * size) / allowed, 16, x0, v0);
        if (v0 == 0) near_eps("tiny energy", "period", (double)vm_duffing_period(R(x0), R(c1), R(table[i][1])), table[i][7], 8);
    }
}

/* The period of a motion in a well from rest close to x = 0, where 1 - m is small but no digits of c1 + c3 x0^2 and c1
   + c3 x0^2/2 are lost; by mpmath */
static void test_periods_from_next_to_0(void)
{
    near_eps("from rest", "period", (double)vm_duffing_period(R(0x1p-6), -1, R(0.125)), 13.8630793741472493, 8);
    near_eps("from rest", "period", (double)vm_duffing_period(R(0x1p-9), -1, 1), 15.9424050976638717, 8);
    near_eps("from rest", "period", (double)vm_duffing_period(R(0x1p-20), -2, 1), 22.545937299780189, 8);
    near_eps("from rest", "action", (double)vm_duffing_action(R(0x1p-20), -2, 1), 0.600210877434704821, 8);
}

/* With c1 and c3 times 4^-n the motion is 2^n times slower, also where c1^2 underflows. */
static void test_slow_springs(void)
{
    const int n = is_float ? 42 : 270;
    const vm_real slow = R(ldexp(1, -2 * n));
    vm_real x, v, slow_x, slow_v;
    int i;
    for (i = 1; i < 20; i++) {
        const vm_real x0 = R(ldexp(1.375, -i)), t = R(0.75);
        const double period = (double)vm_duffing_period(x0, -1, 1);
        near_eps("slow springs", "period", (double)vm_duffing_period(x0, -slow, slow), ldexp(period, n), 8);
        vm_duffing_exact_from(t, x0, 0, -1, 1, &x, &v);
        vm_duffing_exact_from(R(ldexp(0.75, n)), x0, 0, -slow, slow, &slow_x, &slow_v);
        check_error("slow springs", "x", "eps", ERROR_EPS(slow_x, (double)x, 0, (double)x), 1, i, 0);
        check_error("slow springs", "v", "eps", ERROR_EPS(ldexp((double)slow_v, n), (double)v, 0, (double)v), 1, i, 0);
    }
}

/* Next to x = 0 the motion is linear, also where the squares of x0 and v0 underflow. */
static void test_linear_between_the_wells(void)
{
    int i;
    for (i = 0; i < 400; i++) {
        const double c1 = uniform(-4, -0.25), lambda = sqrt(-c1), t = uniform(-2, 2);
        const double c3 = ldexp(uniform(0.25, 4), i % 4 ? 0 : is_float ? 20 : 80);
        const double tiny = ldexp(1, i % 2 ? -20 - i % 40 : is_float ? -80 : -600);
        const double x0 = tiny * uniform(-1, 1) * (i % 3 != 0), v0 = tiny * uniform(-1, 1) * (i % 3 != 1);
        const double want_x = x0 * cosh(lambda * t) + v0 / lambda * sinh(lambda * t);
        const double want_v = v0 * cosh(lambda * t) + x0 * lambda * sinh(lambda * t);
        const double size = fabs(x0) + fabs(v0) / lambda, grown = size * cosh(lambda * t);
        const double nonlinear = c3 * 64 * (tiny * tiny) * cosh(4 * t) * cosh(4 * t) / (c1 * c1 * eps);
        const double allowed = 4 - 4 * log(tiny);
        vm_real x, v;
        vm_duffing_exact_from(R(t), R(x0), R(v0), R(c1), R(c3), &x, &v);
        check_error("linear", "x", "eps", ERROR_EPS(x, want_x, 0, grown) / (allowed + nonlinear), 16, x0, v0);
        check_error("linear", "v", "eps", ERROR_EPS(v, want_v, 0, lambda * grown) / (allowed + nonlinear), 16, x0, v0);
    }
}

/* Starts on the separatrix but for rounding errors, on either side of it, and on it: the motion follows A/cosh, and is
   a number at any time. From next to x = 0 it grows, turns at A and comes back. */
static void test_along_the_separatrix(void)
{
    const vm_odd_force force = vm_duffing_force(-1, R(0.5));
    vm_real x = 7, v = 7;
    int i;
    for (i = 0; i < 4000; i++) {
        const double c1 = uniform(-4, -0.25), c3 = uniform(0.25, 4), A = sqrt(-2 * c1 / c3), lambda = sqrt(-c1);
        const double y0 = uniform(-8, 8), t = uniform(-1, 1), y = y0 + lambda * t;
        const double x0 = A / cosh(y0), v0 = -lambda * x0 * tanh(y0);
        const double off = exp(fabs(y0)) * fabs(sinh(lambda * t)) + 1; /* how the rounding of x0 and v0 grows */
        vm_duffing_exact_from(R(t), R(x0), R(v0), R(c1), R(c3), &x, &v);
        check_error("along", "x", "eps", ERROR_EPS(x, A / cosh(y), 0, A) / off, 16, c1, c3);
        check_error("along", "v", "eps", ERROR_EPS(v, -lambda * A / cosh(y) * tanh(y), 0, lambda * A) / off, 16, c1, c3);
        vm_duffing_exact_from(R(100 * t), R(x0), R(v0), R(c1), R(c3), &x, &v);
        CHECK(fabs((double)x) <= 1.001 * A && fabs((double)v) <= lambda * A);
    }
    /* The growing part is 0: the body falls to x = 0. */
    vm_duffing_exact_from(3, R(ldexp(1, -70)), R(-ldexp(1, -70)), -1, 1, &x, &v);
    check_error("along", "to 0", "eps", ERROR_EPS(ldexp((double)x, 70), exp(-3.), 0, exp(-3.)), 4, 0, 0);
    check_error("along", "to 0", "eps", ERROR_EPS(ldexp((double)v, 70), -exp(-3.), 0, exp(-3.)), 4, 0, 0);
    for (i = 0; i <= 60; i++) { /* 2^-26: v0^2 - x0^2 is 0 but for rounding errors */
        const double late = log(4 / ldexp(1, -26)), y = i - late;
        vm_duffing_exact_from(R(i), R(ldexp(1, -26)), R(ldexp(1, -26)), -1, R(0.5), &x, &v);
        if (y > 16) continue;
        check_error("along", "from 0", "eps", ERROR_EPS(x, 2 / cosh(y), 0, 2 / cosh(y)) / (1 + i + late), 16, i, 0);
    }
    x = v = 7;
    CHECK(vm_odd_exact_from(&force, 1, 2, 0, &x, &v) == VM_NO_LAW && x == 7 && v == 7);
}

/* Rest stays rest: at x = 0, between the wells, and in a well. */
static void test_rest(void)
{
    vm_real x = 7, v = 7;
    vm_duffing_exact_from(3, 0, 0, 1, 1, &x, &v);
    CHECK(x == 0 && v == 0);
    vm_duffing_exact_from(3, 0, 0, -1, 1, &x, &v);
    CHECK(x == 0 && v == 0);
    vm_duffing_exact_from(3, -1, 0, -1, 1, &x, &v);
    CHECK(x == -1 && v == 0);
}

static void test_refusals(void)
{
    const vm_real bad[2] = {VM_NAN, VM_INFINITY};
    vm_real x, v;
    int i, k;
    for (i = 0; i < 2; i++)
        for (k = 0; k < 5; k++) {
            vm_real a[5] = {1, 1, 1, 1, 1};
            a[k] = bad[i];
            vm_duffing_exact_from(a[0], a[1], a[2], a[3], a[4], &x, &v);
            CHECK(is_nan(x) && is_nan(v));
            if (k > 2) CHECK(is_nan(vm_duffing_period(1, a[3], a[4])) && is_nan(vm_duffing_action(1, a[3], a[4])));
            if (k > 0) CHECK(is_nan(vm_duffing_energy(a[1], a[2], a[3], a[4])));
        }
    CHECK(is_nan(vm_duffing_period(VM_NAN, 1, 1)) && is_nan(vm_duffing_period(0, 1, 1)));
    CHECK(is_nan(vm_duffing_period(1, -1, -1)) && is_nan(vm_duffing_period(1, 0, 0)));
    CHECK(vm_duffing_action(0, 1, 1) == 0);
    x = v = 7;
    vm_duffing_exact_from(1, 1, 1, 1, 1, NULL, &v);
    vm_duffing_exact_from(1, 1, 1, 1, 1, &x, NULL);
    CHECK(x == 7 && v == 7);
}

int main(void)
{
    test_table();
    test_energy_and_return();
    test_limits();
    test_separatrix();
    test_between_the_wells();
    test_periods_from_next_to_0();
    test_slow_springs();
    test_linear_between_the_wells();
    test_along_the_separatrix();
    test_rest();
    test_refusals();
    return check_finish("duffing");
}
