/* The pair of bodies of slow mass that a spring of order alpha couples, chapter 7.8: (517)-(536). The equations
   are compared with identities at random points, the closed form and the averaged equations with direct
   integration and with reference numbers. Where the dissertation prints a wrong form, that form is evaluated too,
   and must have the error that it is known to have. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

/* Two bodies of mass m each, with a coupling spring of stiffness k and order alpha */
static vm_pair make_pair(double alpha, double k, double reactive, vm_law mass)
{
    vm_pair p;
    p.alpha = R(alpha);
    p.k = R(k);
    p.reactive = R(reactive);
    p.mass = mass;
    return p;
}

/* The largest error of a motion that is split into modes and joined again, |y| being 2 at most. The split finds
   the mean amplitude by three rounds of an iteration: each of them multiplies the error, at first e/(alpha+3)
   where e = |(2r-1) m'/(2 m Om)|, by e |alpha-1|/(2 (alpha+3)) at most. */
static void check_there_and_back(vm_pair *p, double t, double mass, double drag, const vm_real *y)
{
    const double alpha = (double)p->alpha;
    vm_real modes[4], back[4], rates[4] = {0};
    double e, round, left, size, worst = 0;
    int k;
    CHECK(vm_pair_to_averaged(p, R(t), y, modes) == VM_OK && vm_pair_from_averaged(p, R(t), modes, back) == VM_OK);
    CHECK(vm_pair_averaged_rhs(R(t), modes, rates, p) == VM_OK);
    for (k = 0; k < 4; k++) worst = fmax(worst, fabs((double)(back[k] - y[k])));
    e = fabs((2 * (double)p->reactive - 1) * drag / (2 * mass * (double)rates[1]));
    round = e * fabs(alpha - 1) / (2 * (alpha + 3));
    left = e / (alpha + 3) * round * round * round;
    size = 4 + (double)modes[0] * fmax(1, (double)rates[1]);
    check_error("(520), (524)", "back", "rounds", worst / (size * (4 * eps + left)), 1.5, t, alpha);
}

/* (517)-(522): q'' and p'' of the equations of motion at random points; and the modes, there and back */
static void test_modes(void)
{
    int i, k;
    for (i = 0; i < 200; i++) {
        const vm_law m = linear(uniform(0.5, 2), uniform(-0.1, 0.1));
        vm_pair p = make_pair(uniform(0.3, 5), uniform(0.5, 2), uniform(0, 1), m);
        const double t = uniform(0, 2), mass = (double)(m.f0 + m.f1 * R(t));
        const double drag = (double)(p.reactive * m.f1) / mass;
        double force, size;
        vm_real y[4], d[4] = {0};
        for (k = 0; k < 4; k++) y[k] = R(uniform(-2, 2));
        CHECK(vm_pair_rhs(R(t), y, d, &p) == VM_OK);
        force = 2 * (double)p.k / mass * pow(fabs((double)(y[1] - y[0])), (double)p.alpha);
        size = 1 + force;
        if (y[1] < y[0]) force = -force;
        check_error("(521)", "pointwise", "eps",
                    fabs((double)(d[2] + d[3]) + drag * (double)(y[2] + y[3])) / size / eps, 4, t, 0);
        check_error("(522)", "pointwise", "eps",
                    fabs((double)(d[3] - d[2]) + force + drag * (double)(y[3] - y[2])) / size / eps, 6, t, 0);
        check_there_and_back(&p, t, mass, (double)m.f1, y);
    }
}

/* A motion that is smaller than its ripple, (2r - 1) m'/(2 m Om) > 2, is refused at its start and at its end, and
   the result is left alone. */
static void test_below_ripple(void)
{
    const vm_law m = linear(1, -0.5), heavy = linear(1000, -500), steady = linear(1000, -1e-4);
    vm_pair p = make_pair(1, 1, 0, m);
    const vm_real fast[4] = {0, R(0.75), 0, 100}, slow[4] = {0, R(0.75), 0, R(3e-5)}, weak[4] = {1, 2, 0, 0};
    vm_real modes[4] = {7, 7, 7, 7}, back[4] = {7, 7, 7, 7};
    CHECK(vm_pair_to_averaged(&p, R(1.9999), fast, modes) == VM_DOMAIN && modes[0] == 7 && modes[3] == 7);
    CHECK(vm_pair_from_averaged(&p, R(1.9999), weak, back) == VM_DOMAIN && back[0] == 7 && back[3] == 7);
    CHECK(vm_pair_to_averaged(&p, 0, fast, modes) == VM_OK && vm_pair_from_averaged(&p, 0, weak, back) == VM_OK);
    p.k = R(1e-6);
    back[0] = 7;
    p.mass = heavy;
    CHECK(vm_pair_at(&p, 1, slow, back) == VM_DOMAIN && back[0] == 7);
    p.mass = steady;
    CHECK(vm_pair_at(&p, 1, slow, back) == VM_OK && back[0] - back[0] == 0);
}

/* (523), (525), (527): the modes of the example E2, whose bodies start at 1 and 3 */
static void test_start_of_the_example(void)
{
    const vm_law m = linear(1, 0.01);
    vm_pair p = make_pair(3, 1, 1, m);
    vm_real y[4] = {1, 3, 0, 0}, modes[4];
    CHECK(vm_pair_to_averaged(&p, 0, y, modes) == VM_OK);
    near("(523)", "p0 = y0 - x0", (double)modes[0], 2, 1e-15, 1e-6);
    near("(527)", "q0", (double)modes[2], 4, 1e-15, 1e-6);
    check_error("(523)", "phase of p0 > 0", "", fabs((double)modes[1]), 0, 0, 0);
    /* the printed p0 = x0 - y0 is half a period off, and x = (q - p)/2 with it is not the x that the motion
       starts with */
    ERRATUM("(523)", fabs((1 - 3) - (double)modes[0]) > 3, check_holds("(523)"));
    ERRATUM("(524),(528),(529)", fabs((4 - (1 - 3)) / 2. - (double)y[0]) > 1, check_holds("(520), (524)"));
    solve(vm_pair_rhs, &p, 4, 0, 5, 1e-12, y);
    near("(530), (531)", "E2, x", (double)y[0], 1.357393389013328054, 2e-12, 1e-4);
    near("(530), (531)", "E2, y", (double)y[1], 2.642606610986671946, 2e-12, 1e-4);
}

/* (533)-(536): period and amplitude of the example E2 at every turning point of the second body */
static void test_course_of_the_example(void)
{
    const vm_law m = linear(1, 0.01);
    vm_pair p = make_pair(3, 1, 1, m);
    vm_real y[4] = {1, 3, 0, 0};
    double worst = 0, printed = 0, off = HUGE_VAL;
    long i, n;
    n = track(vm_pair_rhs, &p, 4, 500, 1e-11, y, 1, 3, VM_TURNING_POINTS);
    near("(533)", "first period", (double)points[1].t, 2.645, 1e-4, 3e-3);
    near("(533)", "at t = 0", (double)vm_osc_period(2, VM_SQRT(VM_C(2.0)), 3), 2.622, 1e-4, 1e-4);
    ERRATUM("(533)",
            printed_fails("(533)", (double)vm_osc_period(2, 1, 3), (double)points[1].t, 3.708 / 2.645 - 1),
            check_holds("(533)"));
    for (i = 0; i < n; i++) {
        const double law = pow(1 + 0.01 * (double)points[i].t, -1. / 6), amplitude = fabs((double)points[i].x - 2);
        worst = fmax(worst, fabs(law / amplitude - 1));
        printed = fmax(printed, fabs(-law / amplitude - 1));
        off = fmin(off, fabs((double)points[i].x + law));
        CHECK((i % 2 == 0) == (points[i].x < 2)); /* y starts at its largest value, 3; by (535) at its smallest */
    }
    check_error("(534)-(536)", "direct", "", worst, by_precision(1e-6, 6e-3), (double)n, 0);
    ERRATUM("(535)", printed > 1.9, check_holds("(534)-(536)"));
    ERRATUM("(536)", off > 1, check_holds("(534)-(536)")); /* no turning point is near -m^(-1/6) */
    near("(525)-(527)", "q stays", (double)(y[0] + y[1]), 4, 1e-14, 1e-5);
}

/* The largest error, relative to 3, of the closed form or of the averaged equations, on [0, 2/e] from three
   starts */
enum { AVERAGED, CLOSED_FORM };

static double pair_error(double alpha, double reactive, double e, int solution)
{
    static const double start[3][4] = {{1, 3, 0, 0}, {0.2, -0.5, 0.3, -0.6}, {-0.4, -0.1, 0.5, 1.1}};
    double worst = 0;
    int s, i, k;
    for (s = 0; s < 3; s++) {
        const vm_law m = linear(1.5, e);
        vm_pair p = make_pair(alpha, 0.8, reactive, m);
        vm_real y0[4], y[4], modes[4], got[4] = {0};
        for (k = 0; k < 4; k++) y0[k] = y[k] = R(start[s][k]);
        CHECK(vm_pair_to_averaged(&p, 0, y0, modes) == VM_OK);
        for (i = 1; i <= 10; i++) {
            const double t = 0.2 * i / e;
            solve(vm_pair_rhs, &p, 4, t - 0.2 / e, t, 1e-11, y);
            if (solution == CLOSED_FORM) {
                CHECK(vm_pair_at(&p, R(t), y0, got) == VM_OK);
            } else {
                solve(vm_pair_averaged_rhs, &p, 4, t - 0.2 / e, t, 1e-11, modes);
                CHECK(vm_pair_from_averaged(&p, R(t), modes, got) == VM_OK);
            }
            for (k = 0; k < 2; k++) worst = fmax(worst, fabs((double)(got[k] - y[k])) / 3);
        }
    }
    return worst;
}

/* (528), (529): both errors are of order eps. */
static void test_waveform(void)
{
    static const double alphas[] = {0.5, 1, 4. / 3, 3, 5};
    static const char *const names[] = {"averaged", "closed"};
    int i, r, solution;
    for (i = 0; i < 5; i++)
        for (r = 0; r < 2; r++)
            for (solution = AVERAGED; solution <= CLOSED_FORM; solution++) {
                double coarse, fine;
                rough = alphas[i] < 1.4 && alphas[i] != 1;
                coarse = pair_error(alphas[i], r, 0.02, solution);
                check_error("(528), (529)", names[solution], "eps", coarse / 0.02, by_precision(0.2, 5), alphas[i],
                            r);
                if (is_float) continue;
                fine = pair_error(alphas[i], r, 0.005, solution);
                check_error("(528), (529)", "order", "", 1 - log(coarse / fine) / log(4), 0.25, alphas[i], r);
            }
    rough = 0;
}

/* Two bodies that move as one: the relative motion, whose phase would have an infinite rate, stays at rest, and
   the mean velocity follows q' = q'(0) m0/m. */
static void test_without_relative_motion(void)
{
    const vm_law m = linear(1, 0.1);
    vm_pair still = make_pair(0.5, 1, 1, m);
    const vm_real y0[4] = {2, 2, 1, 1};
    vm_real modes[4] = {1, 1, 1, 1}, dmodes[4] = {1, 1, 1, 1}, y[4] = {0};
    CHECK(vm_pair_to_averaged(&still, 0, y0, modes) == VM_OK && modes[0] == 0);
    CHECK(vm_pair_averaged_rhs(0, modes, dmodes, &still) == VM_OK && dmodes[0] == 0 && dmodes[1] == 0);
    CHECK(vm_pair_at(&still, 10, y0, y) == VM_OK && y[0] == y[1] && y[2] == y[3]);
    near("(525)", "drift", (double)y[0], 2 + log(2.) / (double)m.f1, 1e-14, 1e-5);
    near("(525)", "drift's rate", (double)y[2], 0.5, 1e-14, 1e-5);
}

static void test_bad_input(void)
{
    const double bad[] = {0, -1, (double)VM_NAN, (double)VM_INFINITY};
    const vm_law vanishing = linear(1, -1); /* it is zero at t = 1 */
    vm_pair p = make_pair(3, 1, 1, vanishing);
    vm_real y[4] = {1, 2, 3, 4}, d[4] = {7, 7, 7, 7};
    int i;
    for (i = 0; i < 4; i++) {
        p.mass = linear(1, 0);
        p.k = R(bad[i]);
        CHECK(vm_pair_at(&p, 1, y, d) == (i < 2 ? VM_BAD_STIFFNESS : VM_NOT_FINITE));
        CHECK(vm_pair_rhs(1, y, d, &p) == (i < 2 ? VM_BAD_STIFFNESS : VM_NOT_FINITE));
        p.k = 1;
        p.mass = linear(bad[i], 0);
        CHECK(vm_pair_at(&p, 1, y, d) == (i < 2 ? VM_BAD_MASS : VM_NOT_FINITE));
    }
    p.mass = linear(1, 0);
    p.alpha = -1;
    CHECK(vm_pair_at(&p, 1, y, d) == VM_DOMAIN && vm_pair_rhs(1, y, d, &p) == VM_DOMAIN);
    p.alpha = 3;
    CHECK(vm_pair_at(&p, VM_NAN, y, d) == VM_NOT_FINITE);
    p.mass = vm_law_quadratic(1, 1, 1);
    CHECK(vm_pair_at(&p, 1, y, d) == VM_NO_LAW);
    p.mass = vanishing;
    CHECK(vm_pair_rhs(1, y, d, &p) == VM_BAD_MASS && vm_pair_to_averaged(&p, 1, y, d) == VM_BAD_MASS);
    CHECK(vm_pair_at(&p, 1, y, d) == VM_BAD_MASS);
    y[1] = VM_NAN;
    CHECK(vm_pair_at(&p, 0, y, d) == VM_NOT_FINITE);
    memset(&p.mass, 0, sizeof p.mass); /* no law */
    CHECK(vm_pair_rhs(0, y, d, &p) == VM_BAD_ARGUMENT);
    CHECK(vm_pair_to_averaged(&p, 0, y, d) == VM_BAD_ARGUMENT && vm_pair_from_averaged(&p, 0, y, d) == VM_BAD_ARGUMENT);
    for (i = 0; i < 4; i++) CHECK(d[i] == 7); /* all of them left it alone */
}

int main(void)
{
    test_modes();
    test_below_ripple();
    test_start_of_the_example();
    test_course_of_the_example();
    test_waveform();
    test_without_relative_motion();
    test_bad_input();
    return check_finish("pair");
}
