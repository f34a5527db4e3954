/* The oscillator of slow mass under a periodic force that is not harmonic (src/oscillators/periodic.h): Fourier
   coefficients from samples, the exact equations, the averaged ones against direct integration at main, higher and
   subharmonic resonance, and the steady vibrations against the averaged equations and against direct integration. With a
   harmonic force all results are those of vm_forced. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

/* Stiffness 1, mass 1, damping e b, force e g(theta) with g = cos theta; the other tests change what they need. The
   frequency is that of the free vibration of the amplitude 1 times `detuned`, over P/Q. */
static vm_periodic make_periodic(double alpha, double b, double e, int P, int Q, double detuned)
{
    vm_periodic p;
    memset(&p, 0, sizeof p);
    p.oscillator.alpha = R(alpha);
    p.oscillator.damping = R(e * b);
    p.oscillator.reactive = 1;
    p.oscillator.mass = linear(1, 0);
    p.oscillator.stiffness = linear(1, 0);
    p.oscillator.frequency = linear(detuned * (double)vm_osc_omega_trig(R(alpha)) * Q / P, 0);
    p.oscillator.force = linear(e, 0);
    p.cosine[1] = 1;
    p.vibrations = P;
    p.periods = Q;
    CHECK(vm_periodic_init(&p) == VM_OK);
    return p;
}

/* ---- The shape of the force ---- */

/* A sum of harmonics up to the ninth comes back from 19 samples or more, and vm_periodic_shape gives the samples. */
static void test_samples(void)
{
    vm_real g[64];
    int trial, i, n;
    for (trial = 0; trial < 200; trial++) {
        vm_periodic p = make_periodic(3, 1, 0.1, 1, 1, 1), q = p;
        n = 19 + trial % 45;
        for (i = 0; i <= VM_PERIODIC_HARMONICS; i++) {
            p.cosine[i] = R(uniform(-1, 1));
            p.sine[i] = R(uniform(-1, 1));
        }
        p.sine[0] = 0;
        for (i = 0; i < n; i++) g[i] = vm_periodic_shape(&p, 2 * VM_PI * (vm_real)i / (vm_real)n);
        CHECK(vm_periodic_from_samples(&q, n, g) == VM_OK);
        for (i = 0; i <= VM_PERIODIC_HARMONICS; i++) {
            check_error("samples", "a_n", "eps", fabs((double)(q.cosine[i] - p.cosine[i])) / eps, 32, n, i);
            check_error("samples", "b_n", "eps", fabs((double)(q.sine[i] - p.sine[i])) / eps, 32, n, i);
        }
    }
}

/* Samples of ca give the Fourier coefficients of vm_forced; three samples give the first harmonic and no other. */
static void test_samples_of_ca(void)
{
    const vm_real three[3] = {R(2.5), R(0.25), R(0.25)};
    vm_periodic p = make_periodic(3, 1, 0.1, 1, 1, 1);
    vm_real g[128];
    int i;
    for (i = 0; i < 128; i++) g[i] = ateb_ca(p.oscillator.pi * (vm_real)i / 64, 3);
    CHECK(vm_periodic_from_samples(&p, 128, g) == VM_OK);
    for (i = 0; i <= VM_PERIODIC_HARMONICS; i++) {
        const double c = i % 2 ? (double)p.oscillator.c[i / 2] : 0;
        check_error("samples of ca", "a_n", "eps", fabs((double)p.cosine[i] - c) / eps, 32, i, c);
        check_error("samples of ca", "b_n", "eps", fabs((double)p.sine[i]) / eps, 32, i, 0);
    }
    CHECK(vm_periodic_from_samples(&p, 3, three) == VM_OK);
    check_error("three samples", "a_0", "eps", fabs((double)p.cosine[0] - 1) / eps, 4, 0, 0);
    check_error("three samples", "a_1", "eps", fabs((double)p.cosine[1] - 1.5) / eps, 4, 0, 0);
    for (i = 2; i <= VM_PERIODIC_HARMONICS; i++) CHECK(p.cosine[i] == 0 && p.sine[i] == 0);
}

/* Samples whose sum overflows have a finite mean. */
static void test_large_samples(void)
{
    const vm_real large = VM_MAX / R(1.5), two[2] = {large, large}, four[4] = {large, -large, large, -large};
    vm_periodic p = make_periodic(3, 1, 0.1, 1, 1, 1);
    CHECK(vm_periodic_from_samples(&p, 2, two) == VM_OK && p.cosine[0] == large && p.cosine[1] == 0);
    CHECK(vm_periodic_from_samples(&p, 4, four) == VM_OK && p.cosine[0] == 0);
    CHECK(VM_FABS(p.cosine[1]) < VM_EPSILON * large);
}

/* ---- A harmonic force ---- */

/* With g = cos theta all results are those of vm_forced, but for rounding. The ripple is so at the resonance, w(A) = nu,
   since vm_forced puts nu for w there. */
static void test_harmonic(void)
{
    int i, k;
    for (i = 0; i < 200; i++) {
        vm_periodic p = make_periodic(uniform(0.3, 6), uniform(0.1, 1), 0.05, 1, 1, uniform(0.97, 1.03));
        vm_forced *f = &p.oscillator;
        const vm_law nu = f->frequency;
        vm_real y[3], motion[3] = {1, 0, 0}, other[3] = {2, 0, 0}, d[3] = {1, 0, 0}, e[3] = {2, 0, 0};
        vm_steady_state one[3], two[8];
        int n, found;
        y[0] = R(uniform(0.5, 1.5));
        y[1] = R(uniform(-3, 3));
        y[2] = R(uniform(-3, 3));
        f->mass = linear(1, uniform(-0.01, 0.01));
        CHECK(vm_forced_averaged_rhs(0, y, d, f) == VM_OK && vm_periodic_averaged_rhs(0, y, e, &p) == VM_OK);
        for (k = 0; k < 3; k++)
            check_error("harmonic", "averaged", "eps", fabs((double)(d[k] - e[k])) / eps, 16, (double)f->alpha, k);
        y[0] = 1;
        f->frequency = linear((double)f->Om1, 0);
        CHECK(vm_forced_from_averaged(f, 0, y, motion) == VM_OK && vm_periodic_from_averaged(&p, 0, y, other) == VM_OK);
        f->frequency = nu;
        for (k = 0; k < 3; k++)
            check_error("harmonic", "motion", "eps", fabs((double)(motion[k] - other[k])) / eps, 128, (double)f->alpha, k);
        CHECK(vm_forced_rhs(0, y, d, f) == VM_OK && vm_periodic_rhs(0, y, e, &p) == VM_OK);
        check_error("harmonic", "x''", "eps", fabs((double)(d[1] - e[1])) / eps, 4, (double)f->alpha, 0);
        n = vm_forced_steady_states(f, 0, one);
        found = vm_periodic_steady_states(&p, 0, 8, two);
        if (found != n) { /* next to a fold, or next to A = 0, two vibrations have almost the same phase */
            CHECK(found < n);
            continue;
        }
        for (k = 0; k < n; k++) {
            near("harmonic", "steady A", (double)two[k].A, (double)one[k].A, 1e-9, 1e-2);
            CHECK(two[k].stable == one[k].stable);
        }
    }
}

/* ---- Exact and averaged equations ---- */

/* A force with cosines and sines, whose mean is not 0 */
static void set_shape(vm_periodic *p)
{
    p->cosine[0] = R(0.2);
    p->cosine[1] = R(0.7);
    p->sine[1] = R(0.4);
    p->sine[2] = R(0.5);
    p->cosine[3] = R(-0.6);
    p->sine[5] = R(0.3);
    p->cosine[9] = R(0.25);
}

/* The motion by the exact equations of amplitude and phase is the motion by the equation of motion. */
static void test_exact_equations(void)
{
    static const double alphas[3] = {1, 2, 3};
    int i;
    for (i = 0; i < 3; i++) {
        vm_periodic p = make_periodic(alphas[i], 0.5, 0.1, 1, 1, 1.1);
        vm_real y[3] = {1, 0, R(0.3)}, exact[3] = {1, 0, R(0.3)}, x, v;
        set_shape(&p);
        p.oscillator.mass = linear(1, 0.02);
        rough = alphas[i] != 1 && alphas[i] < 3;
        solve(vm_periodic_rhs, &p, 3, 0, 10, 1e-11, y);
        solve(vm_periodic_exact_rhs, &p, 3, 0, 10, 1e-11, exact);
        vmi_slow_motion(exact[0], exact[1], 1, R(1.2), R(alphas[i]), &x, &v);
        check_error("exact A, psi", "x", "", fabs((double)(x - y[0])), by_precision(1e-8, 1e-3), alphas[i], 0);
        check_error("exact A, psi", "x'", "", fabs((double)(v - y[1])), by_precision(1e-8, 1e-3), alphas[i], 0);
        rough = 0;
    }
}

/* The phase of the force for which a vibration that begins with phi = 0 is 0.3 rad from the phase that it is drawn to
   most strongly. Elsewhere the motion may pass a saddle of the averaged equations, which amplifies errors. */
static vm_real phase_of_start(const vm_periodic *p)
{
    double delta, best = 0, most = -HUGE_VAL;
    for (delta = -pi; delta < pi; delta += 0.01) {
        const double slope = (double)vmi_periodic_sums_at(p, R(delta)).slope;
        if (slope > most) best = delta;
        most = fmax(most, slope);
    }
    return R(-(best + 0.3) * p->periods / p->vibrations);
}

/* The largest error of x on [0, 2/e] from x = 1, x' = 0 */
static double error_of_averaging(vm_periodic *p, double e)
{
    vm_real y[3] = {1, 0, 0}, slow[3] = {1, 0, 0}, got[3] = {0};
    const int n = (int)(2 / e / 0.5);
    double worst = 0;
    int i;
    y[2] = phase_of_start(p);
    CHECK(vm_periodic_to_averaged(p, 0, y, slow) == VM_OK);
    for (i = 1; i <= n; i++) {
        const double before = 2 / e * (i - 1) / n, t = 2 / e * i / n;
        solve(vm_periodic_rhs, p, 3, before, t, 1e-10, y);
        solve(vm_periodic_averaged_rhs, p, 3, before, t, 1e-10, slow);
        CHECK(vm_periodic_from_averaged(p, R(t), slow, got) == VM_OK);
        worst = fmax(worst, fabs((double)(got[0] - y[0])));
    }
    return worst;
}

typedef struct averaging_row {
    double alpha;
    int P, Q;
    double rate; /* of the mass, over e */
    double bound; /* on the error at e = 0.005 */
    double order; /* the least order */
} averaging_row;

static double error_of_row(const averaging_row *row, double e)
{
    vm_periodic p = make_periodic(row->alpha, 0.1, e, row->P, row->Q, 1 + e / 2);
    set_shape(&p);
    p.oscillator.mass = linear(1, e * row->rate);
    return error_of_averaging(&p, e);
}

/* The error of x by the averaged equations falls with e up to t = 2/e, at all kinds of resonance. For alpha != 1 the
   vibration of delta about its rest has a frequency of the order of sqrt(e); so the order lies between 1/2 and 1. */
static void test_averaging(void)
{
    static const averaging_row rows[] = {
        {1, 1, 1, 0, 0.006, 0.95},   {1, 1, 1, 0.2, 0.006, 0.95}, {1.5, 1, 1, 0, 0.006, 0.9}, {1.5, 3, 1, 0.1, 0.01, 0.8},
        {3, 1, 1, 0, 0.01, 0.7},     {3, 1, 1, 0.2, 0.01, 0.7},   {5, 1, 1, 0, 0.02, 0.8},    {3, 3, 1, 0, 0.02, 0.9},
        {3, 2, 1, 0, 0.05, 0.75},    {3, 5, 3, 0, 0.1, 1},
        {3, 1, 3, 0, 0.02, 0.25}}; /* c_3 = 0.04 in ca makes this one weak: e must be smaller for a higher order */
    size_t i;
    if (is_float) return; /* the order needs more digits */
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        double coarse, fine;
        rough = rows[i].alpha != 1 && rows[i].alpha < 3;
        coarse = error_of_row(&rows[i], 0.04);
        fine = error_of_row(&rows[i], 0.005);
        printf("alpha = %g, %d:%d, error %.2g at e = 0.04, %.2g at e = 0.005, order %.2f\n", rows[i].alpha, rows[i].P,
               rows[i].Q, coarse, fine, log(coarse / fine) / log(8));
        check_error("averaged", "x", "stated", fine / rows[i].bound, 1, rows[i].alpha, rows[i].P);
        check_error("averaged", "missing order of x", "", rows[i].order - log(coarse / fine) / log(8), 0, rows[i].alpha,
                    rows[i].P);
    }
    rough = 0;
}

/* The force matters: with another resonance's sums the averaged motion misses by far more. */
static void test_resonance_matters(void)
{
    const double e = 0.005;
    vm_periodic p;
    vm_real y[3] = {1, 0, 0}, slow[3] = {1, 0, 0}, right[3] = {0}, wrong[3] = {0};
    if (is_float) return;
    p = make_periodic(3, 0.5, e, 3, 1, 1.03);
    set_shape(&p);
    CHECK(vm_periodic_to_averaged(&p, 0, y, slow) == VM_OK);
    memcpy(right, slow, sizeof right);
    memcpy(wrong, slow, sizeof wrong);
    solve(vm_periodic_averaged_rhs, &p, 3, 0, 2 / e, 1e-10, right);
    p.cosine[3] = 0;
    solve(vm_periodic_averaged_rhs, &p, 3, 0, 2 / e, 1e-10, wrong);
    CHECK(fabs((double)(right[1] - wrong[1])) > 0.5);
}

/* ---- Steady vibrations ---- */

/* The relative change of the amplitude along the resonance curve for a change of the phase by 1 rad. The rounding of the
   phase next to pi changes the amplitude of the curve by this factor. */
static double curve_slope(const vm_periodic *p, const vm_steady_state *s)
{
    const vm_real h = R(1e-4);
    vm_steady_state after = *s;
    if (vm_periodic_curve(p, 0, s->delta + h, &after)) vm_periodic_curve(p, 0, s->delta - h, &after);
    return fabs((double)((after.A - s->A) / (h * s->A)));
}

/* Each steady vibration is one of the averaged equations and a point of the curve of its phase; its trace and its
   determinant are those of differences. */
static void check_steady(vm_periodic *p, const vm_steady_state *s)
{
    const double h = 1e-4;
    vm_real y[3], d[3] = {0}, up[3] = {0}, down[3] = {0};
    double J[2][2];
    vm_steady_state point;
    int i;
    y[0] = s->A;
    y[1] = s->delta;
    y[2] = 0;
    CHECK(vm_periodic_averaged_rhs(0, y, d, p) == VM_OK);
    check_error("steady", "A'", "", fabs((double)d[0]), by_precision(1e-14, 1e-5), (double)s->A, (double)s->delta);
    check_error("steady", "A delta'", "", fabs((double)(d[1] * s->A)), by_precision(1e-13, 1e-4), (double)s->A,
                (double)s->delta);
    CHECK(vm_periodic_curve(p, 0, s->delta, &point) == VM_OK);
    check_error("curve", "A", "of rounded phase", fabs((double)(point.A / s->A) - 1) / (1 + curve_slope(p, s)),
                by_precision(1e-14, 1e-5), (double)point.A, (double)s->A);
    near("curve", "nu", (double)point.nu, (double)s->nu, 1e-11, 1e-3);
    if (is_float) return;
    for (i = 0; i < 2; i++) {
        y[i] += R(h);
        CHECK(vm_periodic_averaged_rhs(0, y, up, p) == VM_OK);
        y[i] -= R(2 * h);
        CHECK(vm_periodic_averaged_rhs(0, y, down, p) == VM_OK);
        y[i] += R(h);
        J[0][i] = (double)(up[0] - down[0]) / (2 * h);
        J[1][i] = (double)(up[1] - down[1]) / (2 * h);
    }
    check_error("steady", "trace", "", fabs(J[0][0] + J[1][1] - (double)s->trace), 1e-8, (double)s->A, 0);
    check_error("steady", "det", "", fabs(J[0][0] * J[1][1] - J[0][1] * J[1][0] - (double)s->det), 1e-6, (double)s->A, 0);
    CHECK(s->stable == (s->det > 0 && s->trace < 0));
}

static void test_steady_states(void)
{
    static const int ratios[4][2] = {{1, 1}, {3, 1}, {1, 3}, {3, 3}};
    int i, k, most = 0;
    for (i = 0; i < 200; i++) {
        vm_periodic p = make_periodic(uniform(0.8, 5), uniform(0.05, 0.5), 0.1, ratios[i % 4][0], ratios[i % 4][1],
                                      uniform(0.95, 1.1));
        vm_steady_state s[12], first[2];
        int n;
        set_shape(&p);
        if (i % 8 > 3) p.oscillator.force = linear(-0.1, 0);
        n = vm_periodic_steady_states(&p, 0, 12, s);
        CHECK(n >= 0 && n <= 12);
        if (n > most) most = n;
        for (k = 0; k < n; k++) {
            CHECK(k == 0 || s[k].A >= s[k - 1].A);
            if (s[k].A > R(0.3) && s[k].A < 3) check_steady(&p, &s[k]);
        }
        memset(first, 0, sizeof first);
        CHECK(vm_periodic_steady_states(&p, 0, 1, first) == n && first[1].A == 0);
        if (n > 0) CHECK(first[0].A == s[0].A);
    }
    printf("up to %d steady vibrations\n", most);
    CHECK(most >= 3);
}

/* For alpha = 0 the frequency is infinite at the amplitude 0, and no vibration has an amplitude of almost 0. */
static void test_steady_states_of_alpha_0(void)
{
    int i, k;
    for (i = 0; i < 100; i++) {
        vm_periodic p = make_periodic(0, uniform(0.05, 0.5), 0.1, 1, 1, uniform(0.5, 1.5));
        vm_steady_state s[12];
        int n;
        p.oscillator.force = linear(uniform(0.02, 0.3), 0);
        if (i % 2) p.sine[2] = R(uniform(-1, 1));
        n = vm_periodic_steady_states(&p, 0, 12, s);
        CHECK(n >= 0 && n <= 12);
        for (k = 0; k < n; k++) CHECK((double)s[k].A > by_precision(1e-300, 1e-30));
    }
}

/* The vibration that starts on a stable steady state stays on it: the largest change of the amplitude in 60 periods. */
static double change_on_steady(double e)
{
    vm_periodic p = make_periodic(3, 0.5, e, 1, 1, 1 + e / 2);
    vm_steady_state s[12];
    vm_real y[3], motion[3] = {0}, mean[3] = {0};
    double worst = 0, last = 0;
    int n, k;
    set_shape(&p);
    n = vm_periodic_steady_states(&p, 0, 12, s);
    CHECK(n > 0 && n < 12 && s[n - 1].stable);
    y[0] = s[n - 1].A;
    y[1] = s[n - 1].delta;
    y[2] = 0;
    CHECK(vm_periodic_from_averaged(&p, 0, y, motion) == VM_OK);
    for (k = 1; k <= 60; k++) {
        const double t = 2 * pi * k / (double)p.oscillator.frequency.f0;
        solve(vm_periodic_rhs, &p, 3, last, t, 1e-11, motion);
        last = t;
        CHECK(vm_periodic_to_averaged(&p, R(t), motion, mean) == VM_OK);
        worst = fmax(worst, fabs((double)(mean[0] / y[0]) - 1));
    }
    return worst;
}

static void test_motion_on_steady(void)
{
    double coarse, fine;
    if (is_float) return; /* the order needs more digits */
    coarse = change_on_steady(0.02);
    fine = change_on_steady(0.0025);
    check_error("steady", "exact motion leaves it", "", fine, 0.005, 0, 0);
    check_error("steady", "1 - order", "", 1 - log(coarse / fine) / log(8), 0.2, coarse, fine);
}

/* ---- Bad input ---- */

/* At a resonance of any P and Q, the amplitude that vm_periodic_to_averaged finds in a motion is the one that
   vm_periodic_from_averaged put into it. Where a divisor of the ripple was nearly 0 at some amplitude, it was up to a
   hundred times as large. Where the ripple is about as large as the amplitude, the motion has no mean. */
static void test_mean_at_resonances(void)
{
    int P, Q, i, k;
    for (P = 1; P <= 9; P++)
        for (Q = 1; Q <= 9; Q += 2) {
            vm_periodic p = make_periodic(3, 0.1, 0.2, P, Q, 1);
            p.cosine[2] = R(0.5);
            p.cosine[3] = R(-1) / 3;
            p.cosine[5] = R(0.2);
            for (i = 0; i < 24; i++)
                for (k = 0; k < 24; k++) {
                    const vm_real y[3] = {1, R(-3 + 0.25 * i), R(-3 + 0.25 * k)};
                    vm_real motion[3], back[3] = {0, 0, 0}, again[3] = {0, 0, 0};
                    vmi_forced_parameters now;
                    double ripple;
                    CHECK(vmi_periodic_at(&p, 0, &now) == VM_OK);
                    ripple = (double)vmi_periodic_ripple(&p, &now, 1, vmi_periodic_frequency(&p, now.nu),
                                                         y[1] + vmi_periodic_frequency(&p, y[2]), y[2]);
                    if (fabs(ripple) > 0.1 || vm_periodic_from_averaged(&p, 0, y, motion) != VM_OK) continue;
                    CHECK(vm_periodic_to_averaged(&p, 0, motion, back) == VM_OK);
                    check_error("mean", "A at P : Q", "", fabs((double)back[0] - 1), 0.03, P, Q);
                    CHECK(vm_periodic_from_averaged(&p, 0, back, again) == VM_OK);
                    check_error("mean", "x at P : Q", "", fabs((double)(again[0] - motion[0])), 0.03, P, Q);
                }
        }
    {
        const vm_real near_rest[3] = {R(0.02), 0, 2};
        vm_periodic p = make_periodic(3, 0.4, 0.05, 1, 1, 1);
        vm_real y[3];
        CHECK(vm_periodic_to_averaged(&p, 0, near_rest, y) == VM_DOMAIN);
        CHECK(vm_forced_to_averaged(&p.oscillator, 0, near_rest, y) == VM_DOMAIN);
    }
}

/* The coefficient b_0 multiplies sin(0) and changes nothing, however large it is. */
static void test_b_0(void)
{
    const vm_real motion[3] = {1, R(0.25), R(0.5)};
    vm_periodic p = make_periodic(3, 1, 0.1, 1, 1, 1), q = p;
    vm_real y[3], z[3];
    q.sine[0] = VM_MAX;
    CHECK(vm_periodic_to_averaged(&p, 0, motion, y) == VM_OK && vm_periodic_to_averaged(&q, 0, motion, z) == VM_OK);
    CHECK(same_bytes(y, z, sizeof y));
}

/* A harmonic force, and one that is shifted by one radian, has the steady vibrations that vm_forced_steady_states finds,
   with the phases shifted. This holds for dampings so small that S is below the rounding error of the phase, where amplitudes
   were wrong or missed, and for exponents so small that the amplitudes are. */
static void test_shifted_force(void)
{
    static const double alphas[] = {0.25, 0.5, 1, 2, 3, 7}, dampings[] = {3, 0.3, 1e-3, 1e-8, 1e-12, 1e-16, 1e-25, 1e-30, 1e-290};
    int i, j, k, shift;
    for (i = 0; i < 6; i++)
        for (j = 0; j < (is_float ? 8 : 9); j++) {
            vm_periodic p = make_periodic(alphas[i], dampings[j], 0.1, 1, 1, 0.9);
            vm_steady_state one[3], two[8];
            int n;
            if (j % 2) p.oscillator.force = linear(-0.1, 0);
            n = vm_forced_steady_states(&p.oscillator, 0, one);
            for (shift = 0; shift <= 1; shift++) {
                p.cosine[1] = R(cos(shift));
                p.sine[1] = R(sin(shift));
                CHECK(n > 0 && vm_periodic_steady_states(&p, 0, 8, two) == n);
                for (k = 0; k < n; k++) {
                    const double turn = (double)(one[k].delta - two[k].delta);
                    CHECK(two[k].delta >= -VM_PI && two[k].delta <= VM_PI);
                    near("shifted", "A", (double)two[k].A, (double)one[k].A, 1e-11, 1e-3);
                    near("shifted", "delta", cos(turn), cos(shift), 1e-11, 1e-4);
                    CHECK(one[k].stable == two[k].stable);
                }
            }
        }
}

/* For exponents near 0 and strong damping the amplitude is below the smallest number; the vibration may be left out. */
static void test_vanishing_amplitudes(void)
{
    double alpha;
    for (alpha = 0.03; alpha > 0.001; alpha *= 0.9) {
        vm_periodic p = make_periodic(alpha, 15, 0.02, 1, 1, 0.9);
        vm_steady_state s;
        const int n = vm_periodic_steady_states(&p, 0, 1, &s);
        CHECK(n == 0 || (n == 1 && s.A > 0 && s.A < R(1e-9)));
    }
}

/* Dampings that are too small for the quotient of force and damping are refused. With smaller and smaller dampings the search
   ends; the amplitude no longer tends to 0 with the phase where the exponent is nearly 0. */
static void test_vanishing_damping(void)
{
    double alpha;
    for (alpha = 3; alpha > 1e-20; alpha *= 0.01) {
        vm_real damping;
        int refused = 0;
        for (damping = 1; damping > 0; damping *= R(1e-4)) {
            vm_periodic p = make_periodic(alpha, (double)damping, 0.1, 1, 1, 0.9);
            vm_steady_state s;
            const int n = vm_periodic_steady_states(&p, 0, 1, &s);
            CHECK(n >= 0 ? !refused : n == VM_DOMAIN);
            refused = n < 0;
        }
        CHECK(refused);
    }
}

/* A linear oscillator has no subharmonic resonance: its vibration has one harmonic only. */
static void test_linear_subharmonic(void)
{
    vm_periodic p = make_periodic(1, 1, 0.1, 1, 3, 1);
    vm_steady_state s;
    CHECK(vm_periodic_steady_states(&p, 0, 1, &s) == 0);
    p.cosine[1] = 0;
    p.cosine[3] = 1;
    p.periods = 1;
    CHECK(vm_periodic_init(&p) == VM_OK && vm_periodic_steady_states(&p, 0, 1, &s) == 0);
}

static void test_refusals(void)
{
    const vm_real g[3] = {1, VM_NAN, 0}, y[3] = {1, 0, 0}, bad[3] = {1, VM_INFINITY, 0};
    vm_periodic p = make_periodic(3, 0.5, 0.1, 1, 1, 1), q = p, before;
    vm_real d[3] = {7, 7, 7};
    vm_steady_state s;
    memset(&s, 7, sizeof s);
    CHECK(vm_periodic_from_samples(&p, 0, y) == VM_BAD_ARGUMENT && vm_periodic_from_samples(&p, 3, NULL) < 0);
    CHECK(vm_periodic_from_samples(&p, 3, g) == VM_NOT_FINITE && p.cosine[1] == 1);
    CHECK(is_nan(vm_periodic_shape(NULL, 1)) && is_nan(vm_periodic_shape(&p, VM_INFINITY)));
    q.vibrations = 0;
    CHECK(vm_periodic_init(&q) == VM_BAD_ARGUMENT && vm_periodic_rhs(0, y, d, &q) == VM_BAD_ARGUMENT);
    q.vibrations = 10;
    CHECK(vm_periodic_init(&q) == VM_BAD_ARGUMENT && vm_periodic_curve(&q, 0, 1, &s) == VM_BAD_ARGUMENT);
    q = p;
    q.periods = 10;
    before = q;
    CHECK(vm_periodic_init(&q) == VM_BAD_ARGUMENT && same_bytes(&q, &before, sizeof q));
    q = p;
    q.sine[9] = VM_NAN;
    CHECK(vm_periodic_init(&q) == VM_NOT_FINITE && vm_periodic_averaged_rhs(0, y, d, &q) == VM_NOT_FINITE);
    CHECK(vm_periodic_exact_rhs(0, y, d, &q) == VM_NOT_FINITE && vm_periodic_steady_states(&q, 0, 1, &s) == VM_NOT_FINITE);
    CHECK(vm_periodic_to_averaged(&p, 0, bad, d) == VM_NOT_FINITE);
    CHECK(vm_periodic_from_averaged(&p, 0, bad, d) == VM_NOT_FINITE);
    CHECK(vm_periodic_steady_states(&p, 0, -1, &s) == VM_BAD_ARGUMENT);
    CHECK(vm_periodic_curve(&p, 0, VM_NAN, &s) == VM_NOT_FINITE);
    CHECK(vm_periodic_curve(&p, 0, R(0.5), &s) == VM_DOMAIN); /* damping asks for delta < 0 */
    q = p;
    q.oscillator.damping = 0;
    CHECK(vm_periodic_curve(&q, 0, R(-0.5), &s) == VM_DOMAIN && vm_periodic_steady_states(&q, 0, 1, &s) == VM_DOMAIN);
    q = p;
    q.oscillator.force = linear(0, 0);
    CHECK(vm_periodic_steady_states(&q, 0, 1, &s) == 0);
    CHECK(d[0] == 7 && d[1] == 7 && d[2] == 7);
}

int main(void)
{
    test_samples();
    test_samples_of_ca();
    test_large_samples();
    test_harmonic();
    test_exact_equations();
    test_averaging();
    test_resonance_matters();
    test_steady_states();
    test_steady_states_of_alpha_0();
    test_motion_on_steady();
    test_mean_at_resonances();
    test_b_0();
    test_shifted_force();
    test_vanishing_amplitudes();
    test_vanishing_damping();
    test_linear_subharmonic();
    test_refusals();
    return check_finish("periodic");
}
