/* Chapter 3.3.2 of varmass.h: the remainder of the broken rotor in polar coordinates, its steady rotation, stability
   and growth, (75)-(82) and Fig. 18.
   Oracles: arbitrary precision (case C6 and tests/data/rotor_eigenvalues.h), the equations in Cartesian coordinates,
   derivatives by differences, the determinant of the linearised equations in complex numbers, and integration. The
   equations that the dissertation prints wrongly must miss. The break itself is in tests/test_broken_rotor.c. */
#include "broken_rotor.h"

static const double C6_radius = 0.8205128205128205128205; /* steady, of the rotor of Fig. 18 at 0.625 */

/* The rotor of Fig. 18, and its state at t = 0 */
static vm_broken_rotor fig18_rotor(double torque) { return rotor_of(1, 0.5, 4, 1, torque); }
static void fig18_start(vm_real *y) { set_state(y, 0, 0, 0.5, 0, 0, 0); }

static double radius_of(const vm_real *y) { return hypot((double)y[0], (double)y[1]); }

/* ---- Polar coordinates (75) ---- */

static void check_polar(const vm_broken_rotor *r, const vm_real *y)
{
    vm_broken_rotor copy = *r;
    vm_real polar[6] = {0}, back[6] = {0}, a[6] = {0}, b[6] = {0};
    double radius, rate, turn, c, s, radial, across;
    int k;
    CHECK(vm_broken_rotor_to_polar(y, polar) == VM_OK && vm_broken_rotor_from_polar(polar, back) == VM_OK);
    for (k = 0; k < 6; k++) check_case("to and from", "polar", back[k], (double)y[k], 3, 4);
    check_case("phi", "polar", polar[1], atan2((double)y[1], (double)y[0]), 1, 6);
    vm_broken_rotor_rhs(0, y, a, &copy);
    CHECK(vm_broken_rotor_polar_rhs(0, polar, b, &copy) == 0);
    c = cos((double)polar[1]);
    s = sin((double)polar[1]);
    radius = (double)polar[0];
    rate = (double)polar[3];
    turn = (double)polar[4];
    radial = (double)b[3] - radius * turn * turn;
    across = radius * (double)b[4] + 2 * rate * turn;
    check_case("r'', phi'' (75)", "polar", R(radial * c - across * s), (double)a[3], 20, 2);
    check_case("r'', phi'' (75)", "polar", R(radial * s + across * c), (double)a[4], 20, 2);
    check_case("psi'' (75)", "polar", b[5], (double)a[5], 20, 6);
    memcpy(back, y, sizeof back); /* the result may be the argument */
    CHECK(vm_broken_rotor_to_polar(back, back) == VM_OK && memcmp(back, polar, sizeof polar) == 0);
    CHECK(vm_broken_rotor_from_polar(polar, polar) == VM_OK);
}

static void test_polar(void)
{
    vm_broken_rotor r;
    vm_real y[6], polar[6];
    int i;
    for (i = 0; i < 100; i++) {
        double p[5];
        r = random_rotor(p);
        random_state(y, 2, 9);
        if (radius_of(y) < 0.3) continue;
        check_polar(&r, y);
    }
    r = fig18_rotor(0.625);
    set_state(y, 0.4, 0.3, 0.5, 0, 0.2, 0.3);
    CHECK(vm_broken_rotor_to_polar(y, polar) == VM_OK && integrate(vm_broken_rotor_polar_rhs, &r, polar, 5) >= 0);
    CHECK(vm_broken_rotor_from_polar(polar, polar) == VM_OK && integrate(vm_broken_rotor_rhs, &r, y, 5) >= 0);
    check_error("(75)", "integrated", "tol", state_error(y, polar), 4, 0, 0);
    polar[0] = 0;
    CHECK(vm_broken_rotor_polar_rhs(0, polar, y, &r) == VM_DOMAIN && vm_broken_rotor_from_polar(polar, y) == VM_DOMAIN);
    y[0] = 0;
    y[1] = 0;
    CHECK(vm_broken_rotor_to_polar(y, polar) == VM_DOMAIN);
}

/* ---- Steady rotation (76), (77) ---- */

/* The state that turns steadily at Omega satisfies (68): its accelerations are -Omega^2 (x, y) and 0. By (77), psi is
   phi - pi, and where the radius is negative, psi is phi (76). */
static void test_steady(void)
{
    vm_broken_rotor r = fig18_rotor(0.625);
    int i;
    check_case("r_SS (77)", "C6", vm_broken_rotor_steady_radius(&r, R(0.625)), C6_radius, 1, 0.5);
    for (i = 0; i < 200; i++) {
        const double Omega = uniform(-3, 3), psi = uniform(-3, 3);
        double p[5], radius, size, x, y;
        vm_real state[6], a[6] = {0};
        r = random_rotor(p);
        r.torque = r.damping * R(Omega);
        radius = (double)vm_broken_rotor_steady_radius(&r, R(Omega));
        if (fabs(radius) > 50) continue;
        CHECK((radius * (double)r.s > 0) == (Omega * Omega < p[0]));
        x = -radius * cos(psi);
        y = -radius * sin(psi);
        set_state(state, x, y, psi, -Omega * y, Omega * x, Omega);
        vm_broken_rotor_rhs(0, state, a, &r);
        size = 10 * (1 + fabs(radius));
        check_case("(76), (77)", "steady", a[3], -Omega * Omega * x, size, 2);
        check_case("(76), (77)", "steady", a[4], -Omega * Omega * y, size, 2);
        check_case("(76), (77)", "steady", a[5], 0, size, 2);
    }
}

/* Towards resonance from below and from above: stable below it only */
static void test_steady_near_resonance(void)
{
    vm_broken_rotor r = fig18_rotor(1);
    double step;
    for (step = 0.25; step > eps; step /= 2) {
        const double below = 0.5 / (step * (2 - step)), above = -0.5 / (step * (2 + step));
        check_error("r_SS", "near resonance", "eps",
                    fabs((double)vm_broken_rotor_steady_radius(&r, R(1 - step)) / below - 1) / eps, 3, step, 0);
        check_error("r_SS", "near resonance", "eps",
                    fabs((double)vm_broken_rotor_steady_radius(&r, R(1 + step)) / above - 1) / eps, 3, step, 0);
        CHECK(vm_broken_rotor_is_stable(&r, R(1 - step)) && !vm_broken_rotor_is_stable(&r, R(1 + step)));
    }
    CHECK((double)vm_broken_rotor_steady_radius(&r, 1) > (double)VM_MAX);
    r.s = 0;
    CHECK(vm_broken_rotor_steady_radius(&r, R(0.5)) == 0 && isnan(vm_broken_rotor_steady_radius(&r, 1)));
    CHECK(isnan(vm_broken_rotor_steady_radius(NULL, 1)));
}

/* stiffness - mass Omega^2 next to resonance: the products in words and the sums of large words are exact. */
static double exact_detuning(const vm_broken_rotor *r, vm_real Omega)
{
    const vm_two momentum = vmi_two_product(r->mass, Omega);
    const vm_two high = vmi_two_product(momentum.hi, Omega), low = vmi_two_product(momentum.lo, Omega);
    const vm_two small = vmi_two_sum(-high.lo, -low.hi), sum = vmi_two_sum(r->stiffness - high.hi, small.hi);
    return (double)(sum.hi + (sum.lo + (small.lo - low.lo)));
}

/* Omega is the rounded resonance, sqrt(stiffness/mass). The first radius is known by exact fractions, in double. */
static void test_steady_at_rounded_resonance(void)
{
    vm_broken_rotor r = fig18_rotor(1);
    int i;
    r.s = 1;
    for (i = 0; i < 5000; i++) {
        vm_real Omega;
        double radius;
        r.mass = R(i == 0 ? .94477898328394794 : uniform(.5, 2));
        r.stiffness = R(i == 0 ? 1.465007496088635 : uniform(.5, 2));
        Omega = VM_SQRT(r.stiffness / r.mass);
        radius = (double)r.stiffness / exact_detuning(&r, Omega);
        if (i == 0 && !is_float) CHECK(fabs(radius / 9.3654238615485683e17 - 1) < 2 * eps);
        if (isinf(radius)) continue;
        check_error("r_SS", "rounded resonance", "eps",
                    fabs((double)vm_broken_rotor_steady_radius(&r, Omega) / radius - 1) / eps, 3, (double)r.mass,
                    (double)r.stiffness);
        if (i > 100) continue;
        r.mass *= vmi_ldexp(1, is_float ? 126 : 1021); /* the words of so large numbers overflow */
        r.stiffness *= vmi_ldexp(1, is_float ? 126 : 1021);
        check_error("r_SS", "rounded resonance, large", "eps",
                    fabs((double)vm_broken_rotor_steady_radius(&r, Omega) / radius - 1) / eps, 3, (double)r.mass,
                    (double)r.stiffness);
    }
}

/* With whole numbers, mass Omega^2 is exact, so that one ulp of the stiffness decides over stability. */
static void test_exact_criterion(void)
{
    const double most = ldexp(1, VM_MANT_DIG / 3);
    int i;
    for (i = 0; i < 2000; i++) {
        const double Omega = floor(uniform(1, most)), mass = floor(uniform(1, most));
        const vm_real at = R(mass * Omega * Omega), below = at * (1 - VM_EPSILON), above = at * (1 + VM_EPSILON);
        vm_broken_rotor r = fig18_rotor(1);
        double radius;
        r.mass = R(mass);
        r.stiffness = at;
        CHECK((double)at == mass * Omega * Omega && !vm_broken_rotor_is_stable(&r, R(Omega)));
        r.stiffness = below;
        CHECK(!vm_broken_rotor_is_stable(&r, R(Omega)) && vm_broken_rotor_steady_radius(&r, R(Omega)) < 0);
        radius = 0.5 * (double)below / (double)(below - at);
        check_error("r_SS", "an ulp away", "eps", fabs((double)vm_broken_rotor_steady_radius(&r, R(Omega)) / radius - 1) / eps, 3,
                    Omega, mass);
        r.stiffness = above;
        CHECK(vm_broken_rotor_is_stable(&r, R(Omega)) && vm_broken_rotor_is_stable(&r, R(-Omega)) && vm_broken_rotor_steady_radius(&r, R(Omega)) > 0);
        CHECK(isnan(vm_broken_rotor_resonance_radius(&r, 1, R(Omega))));
    }
}

/* ---- The linearised equations (79) and their polynomial (80), (81) ---- */

/* The coefficients of (79): rows rho'', xi'', eta''; columns rho, xi, eta and their rates */
static void matrix_79(double w2, double s, double p2, double k, double Omega, double r0, double matrix[3][6])
{
    memset(matrix, 0, 18 * sizeof(double));
    matrix[0][0] = -(w2 - Omega * Omega);
    matrix[0][4] = 2 * Omega * r0;
    matrix[1][1] = s * w2 / r0;
    matrix[1][2] = -s * w2 / r0;
    matrix[1][3] = -2 * Omega / r0;
    matrix[2][1] = -s * w2 * p2 * r0;
    matrix[2][2] = s * w2 * p2 * r0;
    matrix[2][5] = -k;
}

/* (79) is (75) linearised about (76), by central differences. */
static void test_linearisation(void)
{
    const double h = is_float ? 0.02 : 1e-4;
    int i, row, column;
    for (i = 0; i < 50; i++) {
        double p[5], matrix[3][6], r0;
        vm_broken_rotor r = random_rotor(p);
        const double Omega = uniform(0.3, 3), D = p[0] - Omega * Omega;
        vm_real y[6] = {0}, low[6] = {0}, high[6] = {0};
        r.torque = r.damping * R(Omega);
        if (((double)r.s > 0) == (D > 0)) r.s = -r.s; /* so that r0 > 0 */
        r0 = -(double)r.s * p[0] / D;
        if (r0 < 0.2 || r0 > 3) continue;
        matrix_79(p[0], (double)r.s, p[2], p[3], Omega, r0, matrix);
        y[0] = R(r0);
        y[4] = R(Omega);
        y[5] = R(Omega);
        for (column = 0; column < 6; column++) {
            vm_real from[6], to[6];
            memcpy(from, y, sizeof y);
            memcpy(to, y, sizeof y);
            from[column] -= R(h);
            to[column] += R(h);
            CHECK(vm_broken_rotor_polar_rhs(0, from, low, &r) == 0 && vm_broken_rotor_polar_rhs(0, to, high, &r) == 0);
            for (row = 0; row < 3; row++) {
                const double slope = (double)(high[row + 3] - low[row + 3]) / (2 * h);
                check_error("(79) from (75)", "differences", "h^2", fabs(slope - matrix[row][column]) / (h * h), 10,
                            i, row);
            }
        }
    }
}

typedef struct complex_number {
    double re, im;
} complex_number;

static const complex_number one = {1, 0};

static complex_number times(complex_number a, complex_number b)
{
    complex_number c = {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    return c;
}

/* a + factor b */
static complex_number plus(complex_number a, double factor, complex_number b)
{
    complex_number c = {a.re + factor * b.re, a.im + factor * b.im};
    return c;
}

static double distance(complex_number a, complex_number b) { return hypot(a.re - b.re, a.im - b.im); }

/* The determinant of (79) with (80) about (76), divided by r0 = -s w^2/D. Its rows are A rho - 2 Omega r0 l xi = 0,
   2 Omega l rho + B xi + b eta = 0, and e xi + C eta = 0 with B = r0 l^2 - b, C = l^2 + k l - e. */
static complex_number determinant_79(complex_number l, const double *p, double Omega)
{
    const double w2 = p[0], s = p[1], D = w2 - Omega * Omega, r0 = -s * w2 / D, b = s * w2, e = s * w2 * p[2] * r0;
    const complex_number l2 = times(l, l), A = plus(l2, D, one);
    const complex_number r0_l2 = {r0 * l2.re, r0 * l2.im}, B = plus(r0_l2, -b, one);
    const complex_number C = plus(plus(l2, p[3], l), -e, one), minor = plus(times(B, C), -b * e, one);
    complex_number determinant = plus(times(A, minor), 4 * Omega * Omega * r0, times(l2, C));
    determinant.re /= r0;
    determinant.im /= r0;
    return determinant;
}

/* (81), which is printed without a factor lambda^2 */
static complex_number equation_81(complex_number l, const double *p, double Omega, int printed)
{
    const double w2 = p[0], D = w2 - Omega * Omega, GD = p[1] * p[1] * p[2] * w2 * w2;
    const complex_number l2 = times(l, l), A = plus(l2, D, one), C = plus(plus(l2, p[3], l), GD / D, one);
    complex_number f = times(times(A, A), C);
    f = plus(f, 4 * Omega * Omega, printed ? C : times(l2, C));
    return plus(f, -GD, A);
}

/* lambda times the polynomial of vm_broken_rotor_characteristic */
static complex_number polynomial_at(const vm_real *c, complex_number l)
{
    complex_number q = {0, 0};
    int k;
    for (k = 0; k < 6; k++) {
        q = times(q, l);
        q.re += (double)c[k];
    }
    return times(q, l);
}

/* Returns the relative error of (81) as printed at a random lambda. */
static double check_polynomial(int i, const double *p, double Omega, complex_number l)
{
    const double D = p[0] - Omega * Omega, GD = p[1] * p[1] * p[2] * p[0] * p[0];
    const complex_number zero = {0, 0}, determinant = determinant_79(l, p, Omega), f = equation_81(l, p, Omega, 0);
    const vm_broken_rotor r = rotor_of(p[0], p[1], p[2], p[3], p[3] * Omega);
    vm_real c[6] = {0}, column[6] = {0};
    complex_number at_zero;
    double size;
    CHECK(vm_broken_rotor_characteristic(&r, R(Omega), c) == VM_OK && vm_broken_rotor_routh(&r, R(Omega), column) == VM_OK);
    size = distance(determinant, zero) + 100 * (1 + fabs((double)column[2]));
    check_error("det (79) = (81)", "random", "eps", distance(determinant, f) / size / DBL_EPSILON, 10, i, 0);
    check_error("lambda c = (81)", "random", "eps", distance(polynomial_at(c, l), f) / size / eps, 10, i, 0);
    at_zero = equation_81(zero, p, Omega, 1); /* as printed, 0 is no root */
    CHECK(fabs(at_zero.re / (4 * Omega * Omega * GD / D) - 1) < 1e-9);
    at_zero = equation_81(zero, p, Omega, 0);
    CHECK(distance(at_zero, zero) <= 1e-12 * GD * fabs(D));
    return distance(determinant, equation_81(l, p, Omega, 1)) / distance(determinant, zero);
}

static void test_polynomial(void)
{
    double worst_printed = 0;
    int i, k;
    for (i = 0; i < 200; i++) {
        double p[4], Omega = uniform(0.1, 3);
        complex_number l;
        l.re = uniform(-2, 2);
        l.im = uniform(-2, 2);
        for (k = 0; k < 4; k++) p[k] = uniform(0.2, 3);
        if (fabs(p[0] - Omega * Omega) < 0.2) continue;
        worst_printed = fmax(worst_printed, check_polynomial(i, p, Omega, l));
    }
    CHECK(worst_printed > 1);
}

/* ---- Eigenvalues ---- */

static const struct {
    double rotor[6], Omega, re[5], im[5], condition[5];
} eigenvalue_cases[] = {
#include "data/rotor_eigenvalues.h"
};

/* Each true root has a computed one next to it; the computed ones are real or in pairs, by rising imaginary parts. */
static void check_roots(const char *region, const vm_real *re, const vm_real *im, const double *true_re,
                        const double *true_im, const double *condition, double parameter)
{
    int j, k;
    for (j = 0; j < 5; j++) {
        double nearest = HUGE_VAL;
        for (k = 0; k < 5; k++)
            nearest = fmin(nearest, hypot((double)re[k] - true_re[j], (double)im[k] - true_im[j]));
        if (nearest > 0) nearest /= eps * condition[j];
        check_error("eigenvalues (81)", region, "cond", nearest, 2, parameter, j);
    }
    for (j = 0; j < 5; j++) {
        if (im[j] > 0) CHECK(j < 4 && im[j + 1] == -im[j] && re[j + 1] == re[j]);
        else CHECK(im[j] == 0 || (j > 0 && im[j - 1] == -im[j]));
        CHECK(j == 0 || VM_FABS(im[j]) >= VM_FABS(im[j - 1]));
    }
}

static void test_case_C6(void)
{
    static const double re[5] = {-0.1003632090951246817716, -0.3597678693123637544868, -0.3597678693123637544868,
                                 -0.09005052614007390462734, -0.09005052614007390462734};
    static const double im[5] = {0, 1.061194386164185775948, -1.061194386164185775948, 1.714269675318576012624,
                                 -1.714269675318576012624};
    static const double condition[5] = {0.2278, 3.905, 3.905, 5.292, 5.292};
    const vm_broken_rotor r = fig18_rotor(0.625);
    vm_real x[5], y[5], c[6];
    CHECK(vm_broken_rotor_eigenvalues(&r, R(0.625), x, y) == VM_OK && vm_broken_rotor_is_stable(&r, R(0.625)));
    check_roots("C6", x, y, re, im, condition, 0);
    CHECK(vm_broken_rotor_routh(&r, R(0.625), c) == VM_OK && c[0] == 1 && c[1] == 1);
    check_case("b1 = G", "C6", c[2], 1.641025641025641025641, 1, 1);
    check_case("c1 = k D", "C6", c[3], 0.609375, 1, 1);
    check_case("d1 = 4 G Omega^2", "C6", c[4], 2.564102564102564102564, 1, 6);
}

/* (81) as printed, by powers, has a root with the real part 0.60, where the motion of case C6 is stable. */
static void test_printed_polynomial(void)
{
    const double D = 1 - 0.625 * 0.625, GD = 0.25 * 4, G = GD / D, coriolis = 4 * 0.625 * 0.625;
    const double printed[7] = {1,
                               1,
                               G + 2 * D,
                               2 * D,
                               D * D + 2 * D * G - GD + coriolis,
                               D * D + coriolis,
                               D * D * G - GD * D + coriolis * G};
    const vm_broken_rotor r = fig18_rotor(0.625);
    vm_real q[7], re[6], im[6];
    double most = -9;
    int k;
    for (k = 0; k < 7; k++) q[k] = R(printed[k]);
    vmi_poly_roots(6, q, re, im);
    for (k = 0; k < 6; k++) most = fmax(most, (double)re[k]);
    ERRATUM("(81)", fabs(most - 0.60) < 0.005, check_holds("det (79) = (81)") && vm_broken_rotor_is_stable(&r, R(0.625)));
}

static void test_eigenvalues_table(void)
{
    size_t i;
    for (i = 0; i < sizeof eigenvalue_cases / sizeof *eigenvalue_cases; i++) {
        const vm_broken_rotor r = rotor_from(eigenvalue_cases[i].rotor);
        vm_real re[5], im[5];
        CHECK(vm_broken_rotor_eigenvalues(&r, R(eigenvalue_cases[i].Omega), re, im) == VM_OK);
        check_roots("table", re, im, eigenvalue_cases[i].re, eigenvalue_cases[i].im, eigenvalue_cases[i].condition,
                    (double)i);
    }
}

/* Towards resonance from below, D -> 0: the smallest root is -k D^2/(4 G w^2), of the order D^3, and the largest ones
   are +-i sqrt(G). All roots stay on the left; the real parts of pairs are as accurate as their sizes allow. */
static void test_eigenvalues_near_resonance(void)
{
    double step;
    for (step = 1. / 32; step > (is_float ? 1e-6 : 1e-14); step /= 2) {
        const vm_broken_rotor r = fig18_rotor(1 - step);
        const double D = step * (2 - step), G = 1 / D, Omega = 1 - step;
        vm_real re[5] = {0}, im[5] = {0};
        double smallest;
        int k;
        CHECK(vm_broken_rotor_eigenvalues(&r, R(Omega), re, im) == VM_OK && vm_broken_rotor_is_stable(&r, R(Omega)));
        CHECK(re[0] < 0);
        for (k = 1; k < 5; k++) CHECK((double)re[k] < 4 * eps * fabs((double)im[k]));
        smallest = (double)re[0] * (D * D + G * (1 + 3 * Omega * Omega)) / (D * D);
        check_error("smallest root", "D -> 0", "D^2", fabs(smallest + 1) / (D * D + 4 * eps), 1, step, 0);
        check_error("largest root", "D -> 0", "D", fabs((double)im[3] / sqrt(G) - 1) / (D + 4 * eps), 2, step, 0);
    }
}

/* For a very large damping the roots tend to -k* and to +-i (w + O) and +-i (w - O); the deviations are of the order
   1/k*. */
static void test_eigenvalues_of_large_damping(void)
{
    const double most = is_float ? 1e30 : 1e100;
    double k;
    for (k = 1 / eps; k < most; k *= 7) {
        const double w = uniform(0.5, 2), Omega = w * uniform(1.2, 3), k_star = (double)R(k) / 0.5;
        const vm_broken_rotor r = {2, R(0.5), R(2 * w * w), R(k), 0, R(0.25)};
        vm_real re[5] = {0}, im[5] = {0};
        CHECK(vm_broken_rotor_eigenvalues(&r, R(Omega), re, im) == VM_OK && im[0] == 0);
        check_error("large damping", "-k", "eps", fabs((double)re[0] / -k_star - 1) / eps, 4, k, 0);
        check_error("large damping", "w - O", "eps", fabs((double)im[1] / (Omega - w) - 1) / eps, 32, k, Omega);
        check_error("large damping", "w + O", "eps", fabs((double)im[3] / (Omega + w) - 1) / eps, 32, k, Omega);
        check_error("large damping", "real part", "eps", (double)VM_FABS(re[1]) / (Omega - w) / eps, 32, k, Omega);
        check_error("large damping", "real part", "eps", (double)VM_FABS(re[3]) / (Omega + w) / eps, 32, k, Omega);
    }
}

/* The rotor {1, 1, 1, damping, 0, 0.5} at Omega = 0.5; the roots and their condition numbers by mpmath, with 60 digits */
static void test_eigenvalues_by_damping(void)
{
    static const struct {
        double damping, re[5], im[5], condition[5];
    } rows[] = {
        {1e-12,
         {-4.909090909090909e-13, -2.3177035754285085e-13, -2.3177035754285085e-13, -2.2775097002603694e-14,
          -2.2775097002603694e-14},
         {0.0, 0.69907506001024645, -0.69907506001024645, 1.5312176180429102, -1.5312176180429102},
         {9.8182e-13, 1.0672, 1.0672, 2.3376, 2.3376}},
        {0.001,
         {-0.00049090932417326606, -0.00023177025209953731, -0.00023177025209953731, -2.2775085813829671e-5,
          -2.2775085813829671e-5},
         {0.0, 0.69907486281113778, -0.69907486281113778, 1.531217601861688, -1.531217601861688},
         {0.00098182, 1.0684, 1.0684, 2.339, 2.339}},
        {1e+06,
         {-999999.99999966667, -1.2499999999999881e-7, -1.2499999999999881e-7, -4.1666666666598416e-8,
          -4.1666666666598416e-8},
         {0.0, 0.50000000000004948, -0.50000000000004948, 1.5000000000000541, -1.5000000000000541},
         {2.0e+6, 0.625, 0.625, 1.875, 1.875}},
        {1e+09,
         {-1000000000.0, -1.25e-10, -1.25e-10, -4.1666666666666667e-11, -4.1666666666666667e-11},
         {0.0, 0.5, -0.5, 1.5, -1.5},
         {2.0e+9, 0.625, 0.625, 1.875, 1.875}},
        {1e+12,
         {-1000000000000.0, -1.25e-13, -1.25e-13, -4.1666666666666667e-14, -4.1666666666666667e-14},
         {0.0, 0.5, -0.5, 1.5, -1.5},
         {2.0e+12, 0.625, 0.625, 1.875, 1.875}},
        {1e+24,
         {-9.9999999999999998e+23, -1.25e-25, -1.25e-25, -4.1666666666666667e-26, -4.1666666666666667e-26},
         {0.0, 0.5, -0.5, 1.5, -1.5},
         {2.0e+24, 0.625, 0.625, 1.875, 1.875}},
        {1e+29,
         {-9.9999999999999991e+28, -1.2500000000000001e-30, -1.2500000000000001e-30, -4.166666666666667e-31,
          -4.166666666666667e-31},
         {0.0, 0.5, -0.5, 1.5, -1.5},
         {2.0e+29, 0.625, 0.625, 1.875, 1.875}},
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const vm_broken_rotor r = {1, 1, 1, R(rows[i].damping), 0, R(0.5)};
        vm_real re[5], im[5];
        if (is_float && rows[i].damping > 1e12) continue;
        CHECK(vm_broken_rotor_eigenvalues(&r, R(0.5), re, im) == VM_OK);
        check_roots("damping", re, im, rows[i].re, rows[i].im, rows[i].condition, rows[i].damping);
    }
}

/* Roots of very different sizes: 1 and -3, and three roots near 1e-30 (float 1e-9), then large ones; a polynomial that
   is not finite has no roots. */
static void test_polynomial_sizes(void)
{
    const vm_real small = is_float ? R(9.313225746154785e-10) : R(7.888609052210118e-31), s = small; /* 2^-30, 2^-100 */
    const vm_real falling[6] = {1, 2 - 6 * s, -3 - 12 * s, 18 * s + 22 * s * s, -33 * s * s, 18 * s * s * s};
    const vm_real expected[5] = {1, 3 * s, 2 * s, s, -3}, infinite[3] = {1, VM_INFINITY, 1};
    vm_real rising[6], re[5], im[5];
    int k;
    vmi_poly_roots(5, falling, re, im);
    for (k = 0; k < 5; k++) {
        CHECK(im[k] == 0);
        check_error("roots", "of all sizes", "eps", fabs((double)(re[k] / expected[k]) - 1) / eps, 100, k, 0);
    }
    for (k = 0; k < 6; k++) rising[k] = falling[5 - k] / falling[5];
    vmi_poly_roots(5, rising, re, im);
    for (k = 0; k < 5; k++) {
        const vm_real inverse = 1 / expected[k < 4 ? 3 - k : 4];
        CHECK(im[k] == 0);
        check_error("roots", "of all sizes", "eps", fabs((double)(re[k] / inverse) - 1) / eps, 100, k, 1);
    }
    vmi_poly_roots(2, infinite, re, im);
    CHECK(re[0] != re[0] && im[1] != im[1]);
}

/* The polynomial solver where the rotor does not lead: z^3, two complex roots that are almost one real root, and a real
   root between two complex ones: (z - 1)((z - 1)^2 + gap^2) */
static void test_polynomial_solver(void)
{
    const vm_real cube[4] = {2, 0, 0, 0}, offset = VM_SQRT(VM_EPSILON) * 12;
    const vm_real gap = is_float ? R(0.125) : R(0.0009765625);
    const vm_real between[4] = {1, -3, 3 + gap * gap, -1 - gap * gap};
    vm_real pair[3] = {1, -2, 1}, re[3] = {7, 7, 7}, im[3] = {7, 7, 7};
    int k;
    vmi_poly_roots(3, cube, re, im);
    for (k = 0; k < 3; k++) CHECK(re[k] == 0 && im[k] == 0);
    pair[2] += offset * offset;
    vmi_poly_roots(2, pair, re, im);
    CHECK(im[0] == -im[1] && re[0] == re[1]);
    CHECK(fabs((double)(im[0] / offset) - 1) < 0.125 && fabs((double)re[0] - 1) < (double)offset);
    vmi_poly_roots(3, between, re, im);
    CHECK(im[0] == 0 && im[1] == -im[2] && fabs((double)(im[1] / gap) - 1) < 0.001);
    for (k = 0; k < 3; k++) CHECK(fabs((double)re[k] - 1) < 0.001 * (double)gap);
}

/* A triple root, which rounding splits: if one of its three parts stays real, it is sorted among the real roots, which
   come first, from the largest to the smallest. (z - 1)^3 (z + 5), and the same with other roots */
static void test_order_of_roots(void)
{
    static const double rows[][2] = {{1, -5}, {1, -2}, {2, 0.5}, {3, -1}, {1.5, -3}, {0.75, -0.25}, {5, 1}};
    vm_real re[4], im[4];
    int i, k;
    for (i = 0; i < (int)(sizeof rows / sizeof *rows); i++) {
        const double a = rows[i][0], b = rows[i][1];
        const double aa = a * a;
        const vm_real c[5] = {1, R(-3 * a - b), R(3 * aa + 3 * a * b), R(-aa * a - 3 * aa * b), R(aa * a * b)};
        vmi_poly_roots(4, c, re, im);
        CHECK(im[0] == 0 && im[1] == 0 && re[0] > re[1]); /* a part of the triple root, and b */
        check_error("roots", "triple and single", "", fabs((double)re[0] - a), is_float ? 0.1 : 0.01, a, b);
        for (k = 1; k < 4; k++) CHECK(im[k] != 0 || re[k] <= re[k - 1]);
        CHECK(im[2] == -im[3]);
    }
}

/* The modulus of infinite numbers, and angles of numbers whose sum overflows */
static void test_modulus_and_angle_of_large(void)
{
    const vm_real x = VM_MAX / 2 * R(1.125), inf = VM_INFINITY;
    CHECK(vmi_hypot(inf, inf) == inf && vmi_hypot(-inf, inf) == inf);
    CHECK(vmi_hypot(inf, -1) == inf && vmi_hypot(0, -inf) == inf);
    check_error("angle", "of large", "eps", ERROR_EPS(vmi_atan2(R(1.5) * x, x), 0.98279372324732905, 0, 1), 2, 1.5, 1);
    check_error("angle", "of large", "eps", ERROR_EPS(vmi_atan2(x, R(1.5) * x), 0.58800260354756755, 0, 1), 2, 1, 1.5);
    check_error("angle", "of large", "eps", ERROR_EPS(vmi_atan2(VM_MAX, VM_MAX), 0.78539816339744831, 0, 1), 2, 1, 1);
    CHECK(vmi_atan2(0, 0) == 0 && vmi_atan2(0, 1) == 0 && vmi_atan2(0, -1) == VM_PI);
}

/* The angles of 20000 points above the line y = x, against the C library's arctangent with the digits of a long double. Where
   these are no more than those of the type tested, the C library's angle may be wrong by an ulp, too. */
static void test_angles(void)
{
    const double reference_error = LDBL_MANT_DIG > VM_MANT_DIG ? 0 : 1;
    int i;
    for (i = 0; i < 20000; i++) {
        const vm_real x = R(uniform(0, 1)), y = R(uniform((double)x, 1));
        const long double angle = atan2l((long double)y, (long double)x);
        const double high = (double)angle, low = (double)(angle - (long double)high);
        check_error("angle", "above pi/4", "ulp", ERROR_ULP(vmi_arctan(y, x), high, low), 1.9 + reference_error, (double)x,
                    (double)y);
    }
}

/* ---- Stability (82) ---- */

static vm_broken_rotor rotor_with_frequency(double w2)
{
    const double stiffness = uniform(0.1, 20);
    vm_broken_rotor r;
    r.mass = R(stiffness / w2);
    r.stiffness = R(stiffness);
    r.s = R(uniform(0.05, 1));
    r.inertia = R(uniform(0.05, 2)) * r.mass;
    r.damping = R(uniform(0.05, 2)) * r.inertia;
    r.torque = 0;
    return r;
}

/* Routh's column, the criterion (82) and the eigenvalues agree. The form that (82) gives after "i.e.",
   Omega < c/(M - m), does not. */
static void test_stability(void)
{
    int i, k, mismatches = 0, doubtful = 0, printed_off = 0;
    for (i = 0; i < 4000; i++) {
        const double w2 = uniform(0.1, 4), Omega = uniform(0.05, 3);
        const vm_broken_rotor r = rotor_with_frequency(w2);
        const int stable = vm_broken_rotor_is_stable(&r, R(Omega));
        vm_real column[6] = {0}, re[5] = {0}, im[5] = {0};
        double most = -HUGE_VAL, largest = 0;
        int positive = 1;
        CHECK(vm_broken_rotor_routh(&r, R(Omega), column) == VM_OK && vm_broken_rotor_eigenvalues(&r, R(Omega), re, im) == VM_OK);
        for (k = 0; k < 6; k++) positive = positive && column[k] > 0;
        for (k = 0; k < 5; k++) {
            most = fmax(most, (double)re[k]);
            largest = fmax(largest, hypot((double)re[k], (double)im[k]));
        }
        mismatches += positive != stable;
        if (fabs(most) < 20 * eps * largest) doubtful++; /* the sign is lost in rounding errors */
        else mismatches += (most < 0) != stable;
        printed_off += (Omega < (double)(r.stiffness / r.mass)) != stable;
    }
    CHECK(doubtful < (is_float ? 100 : 4));
    ERRATUM("(82) i.e.", printed_off > 400, mismatches == 0);
}

static void test_stability_domain(void)
{
    vm_broken_rotor r = fig18_rotor(1);
    vm_real at[6] = {9, 9, 9, 9, 9, 9}, im[6];
    CHECK(vm_broken_rotor_characteristic(&r, 1, at) == VM_DOMAIN && vm_broken_rotor_routh(&r, -1, at) == VM_DOMAIN && at[0] == 9);
    CHECK(vm_broken_rotor_eigenvalues(&r, 1, at, im) == VM_DOMAIN && at[1] == 9 && !vm_broken_rotor_is_stable(&r, 1));
    CHECK(vm_broken_rotor_is_stable(&r, R(-0.5)) && !vm_broken_rotor_is_stable(&r, 0));
    r.damping = 0;
    CHECK(!vm_broken_rotor_is_stable(&r, R(0.5)));
}

/* An orbit near the steady one comes to it at the rate of the slowest pair of eigenvalues, here over four turns. */
static void test_decay(void)
{
    const double slow = -0.09005052614007390462734, turn = 2 * 3.141592653589793 / 1.714269675318576012624;
    vm_broken_rotor r = fig18_rotor(0.625);
    vm_real y[6];
    double early, late;
    fig18_start(y);
    CHECK(integrate(vm_broken_rotor_rhs, &r, y, 60) >= 0);
    early = radius_of(y) - C6_radius;
    CHECK(integrate(vm_broken_rotor_rhs, &r, y, 4 * turn) >= 0);
    late = radius_of(y) - C6_radius;
    if (!is_float) CHECK(fabs(log(late / early) / (4 * turn) / slow - 1) < 0.1);
    CHECK(fabs(late) < 1e-3);
}

/* ---- Growth at and above resonance, Fig. 18 ---- */

static double radius_at(double Omega, double k, double t)
{
    vm_broken_rotor r = rotor_of(1, 0.5, 4, k, k * Omega);
    vm_real y[6];
    fig18_start(y);
    CHECK(integrate(vm_broken_rotor_rhs, &r, y, t) >= 0);
    return radius_of(y);
}

/* The laws at resonance and far above it */
static double cube_law(double k, double t) { return pow(3 * k * 0.5 * t / 16, 1 / 3.); }
static double root_law(double t) { return sqrt(1.5 * t / 4); }

/* vm_broken_rotor_resonance_radius follows the radius to s^2/r^2. The law at resonance alone is off by s/4 and more. */
static void test_fig18(void)
{
    const double at[] = {1, 1.01, 1.1}, slack = is_float ? 2e-4 : 1e-6; /* the error of integrate() at t = 400 */
    int i;
    CHECK(fabs(radius_at(0.625, 1, 400) - 0.82051282) < (is_float ? slack : 1e-8));
    CHECK(fabs(radius_at(0.625, 0.3, 400) - 0.8205128) < 1e-4 + slack);
    CHECK(fabs(radius_at(1, 1, 400) - 3.473205) < slack && fabs(cube_law(1, 400) - 3.347165) < 1e-6);
    CHECK(fabs(radius_at(2.5, 1, 400) - 12.437359) < slack && fabs(root_law(400) - 12.247449) < 1e-6);
    for (i = 0; i < 3; i++) {
        const vm_broken_rotor r = fig18_rotor(at[i]);
        const double growth = (double)vm_broken_rotor_resonance_radius(&r, 400, R(at[i])), radius = radius_at(at[i], 1, 400);
        CHECK(fabs(growth - radius) < 2e-3);
        CHECK(fabs(cube_law(1, 400) - radius) > 0.1);
    }
}

/* The law R R' = A + B/R of R = r - s/4, by differences */
static void check_growth_law(const vm_broken_rotor *r, double Omega, double t)
{
    const double A = (double)(R(Omega) - 1) / 8, B = 0.5 / 16, h = is_float ? 0.02 : 1e-4;
    const double low = (double)vm_broken_rotor_resonance_radius(r, R(t * (1 - h)), R(Omega)) - 0.125;
    const double high = (double)vm_broken_rotor_resonance_radius(r, R(t * (1 + h)), R(Omega)) - 0.125;
    const double at = (double)vm_broken_rotor_resonance_radius(r, R(t), R(Omega)) - 0.125, slope = (high - low) / (2 * h * t);
    check_error("R R' = A + B/R", "growth", "h^2", fabs(at * slope / (A + B / at) - 1) / (h * h), 1, Omega, t);
}

static void test_growth(void)
{
    vm_broken_rotor r = fig18_rotor(1);
    double Omega, t;
    for (Omega = 1; Omega < 1e3; Omega = 1 + (Omega - 1 + eps) * 3)
        for (t = 0.01; t < 1e9; t *= 10) check_growth_law(&r, Omega, t);
    CHECK(fabs((double)vm_broken_rotor_resonance_radius(&r, 400, 1) - 0.125 - cube_law(1, 400)) < 8 * eps * 4);
    CHECK(fabs(((double)vm_broken_rotor_resonance_radius(&r, R(1e8), R(2.5)) - 0.125) / root_law(1e8) - 1) < 1e-4);
    CHECK((double)vm_broken_rotor_resonance_radius(&r, 0, R(2.5)) == 0.125);
    r.s = 0;
    CHECK(fabs((double)vm_broken_rotor_resonance_radius(&r, 400, R(2.5)) / root_law(400) - 1) < 4 * eps);
    CHECK(isnan(vm_broken_rotor_resonance_radius(&r, 400, R(0.5))) && isnan(vm_broken_rotor_resonance_radius(&r, -1, 2)));
    r.damping = 0;
    CHECK(vm_broken_rotor_resonance_radius(&r, 400, R(2.5)) == 0);
}

int main(void)
{
    test_polar();
    test_steady();
    test_steady_near_resonance();
    test_steady_at_rounded_resonance();
    test_exact_criterion();
    test_linearisation();
    test_polynomial();
    test_case_C6();
    test_printed_polynomial();
    test_eigenvalues_table();
    test_eigenvalues_near_resonance();
    test_eigenvalues_of_large_damping();
    test_eigenvalues_by_damping();
    test_polynomial_sizes();
    test_polynomial_solver();
    test_order_of_roots();
    test_modulus_and_angle_of_large();
    test_angles();
    test_stability();
    test_stability_domain();
    test_decay();
    test_fig18();
    test_growth();
    return check_finish("broken_rotor_stability");
}
