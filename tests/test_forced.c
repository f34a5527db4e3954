/* The oscillator of slow mass under a harmonic force: its exact and averaged equations, its steady vibrations,
   and the passage through resonance. Fourier coefficients and motions are compared with numbers of 20 digits
   (tests/gen/slow.py, tests/data/slow_fourier.h) and with the reference cases R1 to R9, the averaged equations
   with direct integration, the steady states with periodic motions that Newton's method finds, and their
   stability with the multipliers of those motions. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

/* The oscillator of stiffness 1 and mass 1 whose damping is e b and whose force is e cos(nu t) */
static vm_forced make_forced(double alpha, double b, double reactive, double e, double nu)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = R(alpha);
    f.damping = R(e * b);
    f.reactive = R(reactive);
    f.mass = linear(1, 0);
    f.stiffness = linear(1, 0);
    f.frequency = linear(nu, 0);
    f.force = linear(e, 0);
    CHECK(vm_forced_init(&f) == VM_OK);
    return f;
}

/* The coefficients c of cos and s of sin in the Fourier series of ca and sa, and the constants of the averages */
static void test_fourier(void)
{
    static const double table[][4] = {
#include "data/slow_fourier.h"
    };
    static const double spec[][6] = {
        /* alpha, Pi, c1, s1, Om1, G */
        {0.5, 2.5871095592297905, 1.0151077530561797, 0.92450328830084927, 1.0516365789940907,
         0.56132387752651431},
        {1, 3.1415926535897932, 1, 1, 1, 0.5},
        {4. / 3, 3.5012895254248812, 0.99090244694727885, 1.0372884416840536, 0.96915946825181282,
         0.46536250778244051},
        {1.5, 3.6790939804058808, 0.98662652513403048, 1.0531052820699988, 0.95469356972851000,
         0.44962534733112831},
        {2, 4.2065463159763628, 0.97480084826811571, 1.0920219178383412, 0.91468135650196245, 0.40777965781694808},
        {2.7, 4.93461323214786, 0.96046633127598221, 1.131229253955262, 0.86592966496104781, 0.36009524420263889},
        {3, 5.2441151085842396, 0.95500598696061996, 1.1442310973908931, 0.84721308479397909, 0.34273732890492224},
        {5, 7.2859519436627448, 0.92642995409828171, 1.1983878951022403, 0.74683420022218681, 0.25836339825702279},
    };
    size_t i;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const vm_forced f = make_forced(table[i][0], 1, 1, 1, 1);
        check_error("c1, c3, c9", "20 digits", "eps", ERROR_EPS(f.c[0], table[i][1], 0, 1), 8, table[i][0], 1);
        check_error("c1, c3, c9", "20 digits", "eps", ERROR_EPS(f.c[1], table[i][2], 0, 1), 8, table[i][0], 3);
        check_error("c1, c3, c9", "20 digits", "eps", ERROR_EPS(f.c[4], table[i][3], 0, 1), 8, table[i][0], 9);
    }
    for (i = 0; i < sizeof spec / sizeof *spec; i++) {
        const vm_forced f = make_forced(spec[i][0], 1, 1, 1, 1);
        near_eps("Pi", "stated", (double)f.pi, spec[i][1], 4);
        near_eps("c1", "stated", (double)f.c[0], spec[i][2], 6);
        near_eps("s1", "stated", (double)f.s[0], spec[i][3], 8);
        near_eps("Om1", "stated", (double)f.Om1, spec[i][4], 6);
        near_eps("G", "stated", (double)f.G, spec[i][5], 12);
    }
    near_eps("c1", "alpha = 0", (double)make_forced(0, 1, 1, 1, 1).c[0], 32 / (pi * pi * pi), 6);
    near("c1", "alpha = 1e6", (double)make_forced(1e6, 1, 1, 1, 1).c[0], 8 / (pi * pi), 2e-6, 3e-6);
}

static vm_forced random_oscillator(void)
{
    vm_forced f = make_forced(uniform(0.1, 9.7), uniform(-1, 1), uniform(0, 1), 1, uniform(0.5, 2));
    const double mass_rate = uniform(-1, 1), k_rate = uniform(-1, 1), k = uniform(0.5, 2);
    f.stiffness = linear(k, k_rate);
    f.mass = linear(uniform(0.5, 2), mass_rate);
    f.force = linear(uniform(-1, 1), 0);
    return f;
}

/* The exact equations of A and psi give, by the chain rule, x' and x'' of the equation of motion. */
static void test_exact_equations(void)
{
    int i;
    for (i = 0; i < 300; i++) {
        vm_forced f = random_oscillator();
        const double a = (double)f.alpha;
        double sa, ca, A, A_rate, psi_rate, v, x_rate, v_rate, ln_v_rate, scale;
        vm_real s, c, y[3], d[3] = {0}, motion[3], d_motion[3] = {0};
        y[0] = R(uniform(0.5, 1.5));
        y[1] = R(uniform(-4, 4));
        y[2] = R(uniform(0, 6));
        CHECK(vm_forced_exact_rhs(0, y, d, &f) == VM_OK);
        ateb_saca(y[1], f.alpha, &s, &c);
        sa = (double)s;
        ca = (double)c;
        if (fabs(sa) < 0.05) continue; /* next to a turning point the rate of v would be 0/0 */
        A = (double)y[0];
        A_rate = (double)d[0];
        psi_rate = (double)d[1];
        vmi_slow_motion(y[0], y[1], f.stiffness.f0, f.mass.f0, f.alpha, &motion[0], &motion[1]);
        motion[2] = y[2];
        v = (double)motion[1];
        CHECK(vm_forced_rhs(0, motion, d_motion, &f) == VM_OK);
        x_rate = A_rate * ca - 2 / (a + 1) * A * sa * psi_rate;
        ln_v_rate = (double)f.stiffness.f1 / (2 * (double)f.stiffness.f0) -
                    (double)f.mass.f1 / (2 * (double)f.mass.f0) + (a + 1) / 2 * A_rate / A +
                    copysign(pow(fabs(ca), a), ca) * psi_rate / sa;
        v_rate = v * ln_v_rate;
        scale = 1 + fabs((double)d_motion[1]) + fabs(v);
        check_error("exact A, psi", "x'", "eps", fabs(x_rate - (double)d_motion[0]) / scale / eps, 8, a, A);
        check_error("exact A, psi", "x''", "eps", fabs(v_rate - (double)d_motion[1]) / scale / eps, 20, a, A);
        CHECK(d[2] == d_motion[2]);
    }
}

/* The reference cases R1 to R9: direct integration, and in those that state A and delta the averaged equations
   from A = 1, delta = 0 */
static void test_reference(void)
{
    static const struct {
        double alpha, b, r, e, nu, rate;
        int exponential;
        double T, x, v, A, delta;
    } rows[] = {
        {0.5, 0.5, 1, 0.1, 1, 0, 0, 40, -0.0117468375611963, -0.3951514571390201, 0.249006101385, 11.739143788051},
        {1, 0.5, 1, 0.1, 1, 0.1, 0, 60, 0.1424896911440935, -0.1777787655745902, 0.493769649138, -27.295458785625},
        {4. / 3, 0.5, 1, 0.1, 1, 0.1, 0, 60, 0.0782235981575509, 0.1511949628504957, 0.502483574904,
         -29.855716695845},
        {1.5, 1, 0, 0.05, 0.9, 0.025, 0, 80, -0.4543167861600462, -0.1735703290476035, 0.574536411304,
         -19.168588540359},
        {2, 0.5, 1, 0.1, 1.25, 0.05, 1, 60, 0.4722201575925875, 0.0008179661330533, 0, 0},
        {3, 0.2, 1, 0.1, 1.2, 0, 0, 100, 0.1708175219222538, -0.1345585144049087, 0.663946171730,
         -47.714886164126},
        {3, 0.2, 0, 0.05, 1.2, 0.05, 0, 100, 1.2230490446710621, -0.1254721424058605, 1.254759170773,
         -62.501681384946},
        {5, 0.5, 1, 0.1, 1, -0.025, 0, 30, -0.4449127016621805, 0.7816722760032472, 0.923912879275,
         -0.608004633219},
        {2.7, 0.5, 1, 0.1, 1.5, 0.1, 0, 40, -0.2797961648429151, 0.0518506215187426, 0, 0},
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        vm_forced f = make_forced(rows[i].alpha, rows[i].b, rows[i].r, rows[i].e, rows[i].nu);
        vm_real y[3] = {1, 0, 0}, slow[3] = {1, 0, 0};
        f.mass = linear(1, rows[i].rate);
        if (rows[i].exponential) f.mass = vm_law_exponential(1, R(rows[i].rate));
        if (i == 4) y[1] = R(0.5); /* R5 starts with a velocity */
        if (i == 8) {              /* R9 has another spring, force and start */
            f.stiffness = linear(2, 0);
            f.force = linear(0.15, 0);
            y[0] = R(0.5);
            y[1] = R(-0.25);
        }
        rough = rows[i].alpha < 3 && rows[i].alpha != 1;
        solve(vm_forced_rhs, &f, 3, 0, rows[i].T, 1e-13, y);
        check_error("x(T), x'(T)", "direct", "",
                    fmax(fabs((double)y[0] - rows[i].x), fabs((double)y[1] - rows[i].v)), by_precision(1e-9, 1e-2),
                    rows[i].alpha, rows[i].T);
        rough = 0;
        if (rows[i].A == 0) continue;
        solve(vm_forced_averaged_rhs, &f, 3, 0, rows[i].T, 1e-13, slow);
        near("averaged", "A(T)", (double)slow[0], rows[i].A, 2e-12, 1e-3);
        check_error("averaged", "delta(T)", "", fabs((double)slow[1] - rows[i].delta), by_precision(1e-11, 1e-2),
                    rows[i].alpha, 0);
    }
}

/* The largest errors of the averaged solution on [0, 3/e], from x = 1, x' = 0, at nu = 1.05 Om1. The corrected
   start takes the mean amplitude and phase from vm_forced_to_averaged, the plain one A = 1 and delta = 0. */
enum { CORRECTED_START, PLAIN_START };
typedef struct forced_errors {
    double x;
    double amplitude; /* A + R, of the waveform with its ripple */
} forced_errors;

static forced_errors errors_of_averaging(double alpha, double r, double m1, double e, int from)
{
    forced_errors worst = {0, 0};
    vm_forced f = make_forced(alpha, 0.5, r, e, 1.05 * (double)vm_osc_omega_trig(R(alpha)));
    vm_real y[3] = {1, 0, 0}, slow[3] = {1, 0, 0}, got[3] = {0}, A, psi, B;
    const int n = (int)(3 / e / 0.5);
    int i;
    f.mass = linear(1, e * m1);
    if (from == CORRECTED_START) CHECK(vm_forced_to_averaged(&f, 0, y, slow) == VM_OK);
    for (i = 1; i <= n; i++) {
        const double before = 3 / e * (i - 1) / n, t = 3 / e * i / n;
        vm_real mass = 0, rate = 0;
        solve(vm_forced_rhs, &f, 3, before, t, 1e-10, y);
        solve(vm_forced_averaged_rhs, &f, 3, before, t, 1e-10, slow);
        CHECK(vm_forced_from_averaged(&f, R(t), slow, got) == VM_OK);
        CHECK(vm_law_at(&f.mass, R(t), &mass, &rate) == VM_OK);
        vmi_slow_phase(y[0], y[1], 1, mass, f.alpha, &A, &psi);
        vmi_slow_phase(got[0], got[1], 1, mass, f.alpha, &B, &psi);
        worst.x = fmax(worst.x, fabs((double)(got[0] - y[0])));
        worst.amplitude = fmax(worst.amplitude, fabs((double)(A - B)));
    }
    return worst;
}

/* The stated errors of x and of A + R with the corrected start, which fall as eps; and of x with the plain start,
   which do not */
static void test_waveform(void)
{
    static const struct {
        double alpha, r, m1, amplitude, x, plain_x, order;
    } rows[] = {/* the errors at e = 0.02, the order of that of x */
                {0.5, 1, 0, 2.2e-3, 1.4e-2, 0.05, 0.91},   {1, 1, 0, 1.3e-3, 8.9e-3, 0.010, 0.87},
                {1.5, 1, 0, 1.1e-3, 1.7e-2, 0.29, 0.67},   {3, 1, 0, 3.8e-4, 5.9e-3, 0.05, 0.90},
                {5, 1, 0, 5.4e-4, 6.2e-3, 0.07, 1.00},     {3, 1, 0.2, 2.2e-3, 2.1e-2, 0.74, 0.48},
                {1.5, 0, 0.2, 8.6e-4, 5.8e-3, 0.12, 0.70}, {0.5, 1, 0.2, 1.2e-3, 1.6e-2, 0.08, 1.05}};
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double alpha = rows[i].alpha, r = rows[i].r, m1 = rows[i].m1;
        forced_errors coarse, middle, fine, plain;
        double order;
        rough = alpha < 3 && alpha != 1;
        middle = errors_of_averaging(alpha, r, m1, 0.02, CORRECTED_START);
        plain = errors_of_averaging(alpha, r, m1, 0.02, PLAIN_START);
        if (is_float && alpha < 1) continue; /* direct integration itself errs by 0.1 */
        check_error("waveform", "A + R", "stated", middle.amplitude / rows[i].amplitude, by_precision(1.2, 5),
                    alpha, m1);
        check_error("waveform", "x", "stated", middle.x / rows[i].x, by_precision(1.2, 4), alpha, m1);
        if (is_float) continue;
        check_error("waveform", "x, plain start", "stated", fabs(plain.x / rows[i].plain_x - 1), 0.2, alpha, m1);
        coarse = errors_of_averaging(alpha, r, m1, 0.08, CORRECTED_START);
        fine = errors_of_averaging(alpha, r, m1, 0.005, CORRECTED_START);
        order = log(coarse.x / fine.x) / log(16);
        check_error("waveform", "order of x", "stated", rows[i].order - order, 0.2, alpha, m1);
    }
    rough = 0;
}

/* A steady state is one of the averaged equations, and of the curve of steady states of its amplitude. */
static void check_steady_state(const vm_forced *f, const vm_steady_state *s, int is_lowest)
{
    const double alpha = (double)f->alpha, A = (double)s->A;
    vm_real y[3], d[3] = {0};
    vm_steady_state c[2];
    int found, nearest = 0;
    y[0] = s->A;
    y[1] = s->delta;
    y[2] = 0;
    CHECK(vm_forced_averaged_rhs(0, y, d, (void *)f) == VM_OK);
    check_error("steady", "A' = delta' = 0", "eps", fmax(fabs((double)d[0]), fabs((double)(d[1] * s->A))) / eps, 8,
                alpha, A);
    /* two frequencies have this amplitude; at the lowest amplitude one of them may be negative, and does not
       count */
    found = vm_forced_curve(f, 0, s->A, c);
    CHECK(found == 2 || (is_lowest && found == 1));
    CHECK(found < 2 || c[0].nu < c[1].nu);
    if (found == 2 && !(fabs((double)(c[0].nu - f->frequency.f0)) < fabs((double)(c[1].nu - f->frequency.f0)))) nearest = 1;
    near("curve", "nu(A)", (double)c[nearest].nu, (double)f->frequency.f0, 1e-14, 1e-5);
    check_error("curve", "delta", "", fabs((double)(c[nearest].delta - s->delta)), by_precision(1e-13, 3e-3),
                alpha, A);
    CHECK(c[nearest].stable == s->stable);
    if (found == 2)
        near("backbone", "w(A)", (double)(c[0].nu + c[1].nu) / 2, (double)f->Om1 * pow(A, (alpha - 1) / 2), 2e-15,
             1e-5);
}

/* All steady states for k = m = F = 1, b = 1/2, eps = 0.02, nu = Om1 (1 + eps/2) are as stated: the middle one is
   a saddle, the others are stable. */
static void test_steady_states(void)
{
    static const double rows[][6] = {
        /* alpha; amplitudes from the lowest, 0 if it is not stated; delta of the highest; A_peak */
        {0.5, 0, 0.926476743628365, 0.994514767644679, -2.5793556290958, 2.300847508740417},
        {4. / 3, 0.0398376690351222, 1.00856485160336, 1.10891718532914, -0.573059920923588, 1.873952145987986},
        {1.5, 0.0392387344274827, 1.00552324854335, 1.07288787315595, -0.541265573765833, 1.823725380441355},
        {2, 0.05395862638325, 1.00266464296312, 1.03659980528001, -0.493224304705853, 1.706411710448381},
        {3, 0.102588546722216, 1.00132581283796, 1.01832665676028, -0.441418694939537, 1.557973268265177},
        {5, 0.212546501643162, 1.00069085106793, 1.0091433029818, -0.380442604185298, 1.403995101369306},
    };
    size_t i;
    int k;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double alpha = rows[i][0], *amplitudes = rows[i] + 1, delta = rows[i][4], peak = rows[i][5];
        const double Om1 = (double)vm_osc_omega_trig(R(alpha));
        const vm_forced f = make_forced(alpha, 0.5, 1, 0.02, Om1 * 1.01);
        vm_steady_state s[3], c[2];
        CHECK(vm_forced_steady_states(&f, 0, s) == 3);
        near("steady", "A_peak", (double)vm_forced_peak(&f, 0), peak, 1e-14, 2e-5);
        check_error("steady", "delta", "", fabs((double)s[2].delta - delta), by_precision(1e-13, 3e-3), alpha, 0);
        for (k = 0; k < 3; k++) {
            if (amplitudes[k] != 0) near("steady", "A", (double)s[k].A, amplitudes[k], 3e-14, 3e-5);
            CHECK(s[k].stable == (k != 1) && (s[k].det < 0) == (k == 1) && s[k].trace < 0);
            check_steady_state(&f, s + k, k == 0);
        }
        CHECK(vm_forced_curve(&f, 0, R(1.001 * peak), c) == 0);
        CHECK(vm_forced_curve(&f, 0, R(0.999 * peak), c) == 2);
        CHECK(vm_forced_curve(&f, 0, R(1e-3), c) == (alpha < 1 ? 2 : 1)); /* no negative frequency */
    }
}

/* ln(A w hypot(w - nu, p)/(F G)), which is zero at steady states, at the amplitude A on the backbone frequency w
   */
static double excess(const vm_forced *f, double A, double w)
{
    const double p = (double)(2 * f->damping) / ((double)f->alpha + 3);
    return log(A * w * hypot(w - (double)f->frequency.f0, p) / (double)(f->force.f0 * f->G));
}

/* How often it changes its sign along x = ln A: on a grid that becomes fine towards the tip, where w(A) = nu, and
   at the tip itself. Without damping the two changes next to the tip may be nearer to it than numbers tell apart.
   */
static int sign_changes(const vm_forced *f)
{
    const double bend = ((double)f->alpha - 1) / 2, nu = (double)f->frequency.f0,
                 least_step = 2e-6 / fmax(1, fabs(bend));
    double tip = HUGE_VAL, before, x = -60;
    int changes = 0, tip_is_ahead;
    if (bend != 0) tip = log(nu / (double)f->Om1) / bend;
    tip_is_ahead = tip > x && tip < 60;
    before = excess(f, exp(x), (double)f->Om1 * exp(bend * x));
    while (x < 60) {
        const double distance = bend != 0 ? fabs(x - tip) : fabs(x);
        double value;
        x += fmax(least_step, fmin(0.02, distance / 200));
        if (tip_is_ahead && x >= tip) {
            value = excess(f, exp(tip), nu);
            changes += (value > 0) != (before > 0);
            before = value;
            tip_is_ahead = 0;
        }
        value = excess(f, exp(x), (double)f->Om1 * exp(bend * x));
        changes += (value > 0) != (before > 0);
        before = value;
    }
    return changes;
}

/* Are there numbers between the two steady states next to the tip of an undamped backbone? Where there are none,
   roundings decide whether vm_forced_steady_states finds these two. */
static int tip_is_resolved(const vm_forced *f)
{
    const double bend = ((double)f->alpha - 1) / 2, nu = (double)f->frequency.f0;
    const double A = exp(log(nu / (double)f->Om1) / bend);
    const double distance_of_ln_A = (double)(f->force.f0 * f->G) / (A * nu * nu * fabs(bend));
    return f->damping > 0 || bend == 0 || distance_of_ln_A > eps;
}

/* The derivatives of A' and delta' of the averaged equations by A (component 0) or delta (1), by differences */
static void averaged_derivative(const vm_forced *f, const vm_steady_state *s, int component, double *of_A,
                                double *of_delta)
{
    const double h = component == 0 ? 1e-5 * (double)s->A : 1e-5;
    vm_real y[3], up[3] = {0}, down[3] = {0};
    y[0] = s->A;
    y[1] = s->delta;
    y[2] = 0;
    y[component] += R(h);
    vm_forced_averaged_rhs(0, y, up, (void *)f);
    y[component] -= R(2 * h);
    vm_forced_averaged_rhs(0, y, down, (void *)f);
    *of_A = (double)(up[0] - down[0]) / (2 * h);
    *of_delta = (double)(up[1] - down[1]) / (2 * h);
}

static void check_stability(const vm_forced *f, const vm_steady_state *s)
{
    double a, b, c, d, size;
    averaged_derivative(f, s, 0, &a, &c);
    averaged_derivative(f, s, 1, &b, &d);
    size = a * a + d * d + fabs(b * c) + 1e-4;
    check_error("stability", "trace", "rel", fabs(a + d - (double)s->trace) / sqrt(size), 1e-7, (double)f->alpha,
                (double)s->A);
    check_error("stability", "det", "rel", fabs(a * d - b * c - (double)s->det) / size, 3e-7, (double)f->alpha,
                (double)s->A);
}

/* Random oscillators, with alpha = 0, 1 and 100 among them: there are as many steady states as changes of sign,
   and their traces and determinants are those of the averaged equations. */
static void test_random_steady_states(void)
{
    int i, k, threes = 0;
    for (i = 0; i < 200; i++) {
        double alpha = 1, b = 0, e, nu;
        vm_forced f;
        vm_steady_state s[3];
        int n, changes;
        if (i % 7 == 0) alpha = 1;
        else if (i % 11 == 0) alpha = 0;
        else if (i % 13 == 0) alpha = 100;
        else alpha = uniform(0.1, 6);
        if (i % 5) b = uniform(0, 2);
        e = pow(10, uniform(-2, -0.5));
        nu = uniform(0.3, 2);
        f = make_forced(alpha, b, 1, e, nu);
        n = vm_forced_steady_states(&f, 0, s);
        changes = sign_changes(&f);
        CHECK(n == changes || (!tip_is_resolved(&f) && n == changes - 2));
        threes += n == 3;
        for (k = 0; k < n && !is_float; k++) check_stability(&f, s + k);
    }
    CHECK(threes > 10);
}

/* Next to alpha = 1 the backbone leaves the range of numbers; the response is the linear one. */
static void test_nearly_linear(void)
{
    static const double alphas[] = {1 - 1e-3, 1 - 1e-5, 1 + 1e-5, 1 + 1e-3};
    vm_steady_state s[3], linear_response[3];
    vm_forced f = make_forced(1, 0.5, 1, 0.02, 1.5);
    int i;
    CHECK(vm_forced_steady_states(&f, 0, linear_response) == 1);
    /* F/2 over hypot(nu - w, b/2) */
    near("steady", "alpha = 1", (double)linear_response[0].A, 0.01 / hypot(0.5, 0.005), 3e-15, 1e-6);
    for (i = 0; i < 4; i++) {
        f = make_forced(alphas[i], 0.5, 1, 0.02, 1.5);
        CHECK(vm_forced_steady_states(&f, 0, s) == 1);
        near("steady", "alpha -> 1", (double)s[0].A, (double)linear_response[0].A, 0.02, 0.02);
    }
}

static void test_undamped_resonance(void)
{
    vm_steady_state s[3];
    const vm_forced f = make_forced(1, 0, 1, 0.02, 1);
    CHECK(vm_forced_steady_states(&f, 0, s) == 0 && vm_forced_peak(&f, 0) > VM_MAX); /* grows without bound */
    CHECK(vm_forced_curve(&f, 0, 1, s) == 2 && !s[0].stable); /* without damping it is a centre at most */
}

/* One period of the force: the first harmonic of x, and the derivatives of the last state by the first one */
typedef struct period_run {
    double harmonic, phase, d[2][2];
} period_run;

/* y becomes the state after a period. */
static period_run run_period(vm_forced *f, vm_real *y)
{
    const double T = 2 * pi / (double)f->frequency.f0, h = 1e-5;
    vm_real z[3] = {y[0], y[1], 0};
    period_run run;
    double re = 0, im = 0;
    int i, k;
    for (i = 0; i < 48; i++) {
        re += (double)z[0] * cos(2 * pi * i / 48) / 24;
        im -= (double)z[0] * sin(2 * pi * i / 48) / 24;
        solve(vm_forced_rhs, f, 3, T * i / 48, T * (i + 1) / 48, 1e-11, z);
    }
    for (k = 0; k < 2; k++) {
        vm_real up[3] = {y[0], y[1], 0}, down[3] = {y[0], y[1], 0};
        up[k] += R(h);
        down[k] -= R(h);
        solve(vm_forced_rhs, f, 3, 0, T, 1e-11, up);
        solve(vm_forced_rhs, f, 3, 0, T, 1e-11, down);
        run.d[0][k] = (double)(up[0] - down[0]) / (2 * h);
        run.d[1][k] = (double)(up[1] - down[1]) / (2 * h);
    }
    y[0] = z[0];
    y[1] = z[1];
    run.harmonic = hypot(re, im);
    run.phase = atan2(im, re);
    return run;
}

/* The periodic motion next to a steady state, by Newton's method: its first harmonic, and the trace and
   determinant whose roots are its multipliers */
typedef struct periodic_motion {
    double harmonic, phase, trace, det;
} periodic_motion;

static periodic_motion shoot(vm_forced *f, const vm_steady_state *s)
{
    vm_real slow[3] = {s->A, s->delta, 0}, y[3] = {0};
    periodic_motion motion;
    period_run run = {0, 0, {{0}}};
    int i;
    CHECK(vm_forced_from_averaged(f, 0, slow, y) == VM_OK);
    for (i = 0; i < 6; i++) {
        vm_real z[2] = {y[0], y[1]};
        double a, b, det;
        run = run_period(f, z);
        a = (double)(z[0] - y[0]);
        b = (double)(z[1] - y[1]);
        det = (run.d[0][0] - 1) * (run.d[1][1] - 1) - run.d[0][1] * run.d[1][0];
        y[0] -= R((a * (run.d[1][1] - 1) - b * run.d[0][1]) / det);
        y[1] -= R((b * (run.d[0][0] - 1) - a * run.d[1][0]) / det);
    }
    motion.harmonic = run.harmonic;
    motion.phase = run.phase;
    motion.trace = run.d[0][0] + run.d[1][1];
    motion.det = run.d[0][0] * run.d[1][1] - run.d[0][1] * run.d[1][0];
    return motion;
}

/* k = m = F = 1, b = 1/2, nu = Om1 (1 + detuning e) */
static vm_forced detuned(double alpha, double detuning, double e)
{
    return make_forced(alpha, 0.5, 1, e, (double)vm_osc_omega_trig(R(alpha)) * (1 + detuning * e));
}

/* The highest steady state misses the first harmonic and the phase of the periodic motion by what is stated. */
static void test_periodic_motions(void)
{
    static const double es[2] = {0.04, 0.01};
    static const double rows[][4] = {/* alpha, detuning, the stated errors of the harmonic at both e */
                                     {0.5, 0.5, 8.8e-3, 2.2e-3},
                                     {4. / 3, -0.5, 8.9e-3, 2.2e-3},
                                     {1.5, -0.5, 8.7e-3, 2.1e-3},
                                     {3, -0.5, 7.1e-3, 1.8e-3},
                                     {5, 0.5, 3.9e-3, 1.1e-3}};
    size_t i;
    int k;
    if (is_float) return; /* Newton's derivatives need more digits */
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double alpha = rows[i][0];
        rough = alpha < 3;
        for (k = 0; k < 2; k++) {
            vm_forced f = detuned(alpha, rows[i][1], es[k]);
            vm_steady_state s[3];
            const int n = vm_forced_steady_states(&f, 0, s);
            const periodic_motion motion = shoot(&f, s + n - 1);
            const double error = fabs(motion.harmonic - (double)(f.c[0] * s[n - 1].A));
            const double phase_error = fabs(remainder(motion.phase - (double)s[n - 1].delta, 2 * pi));
            check_error("periodic motion", "c1 A", "stated", fabs(error / rows[i][2 + k] - 1), 0.1, alpha, es[k]);
            check_error("periodic motion", "phase", "c1 A's", phase_error / error, 1.2, alpha, es[k]);
        }
    }
    rough = 0;
}

/* The middle state is a saddle with the stated multipliers. */
static void test_saddles(void)
{
    static const double rows[2][4] = {/* alpha, detuning, multipliers */
                                      {3, 0.5, 1.71229, 0.54267},
                                      {1.5, -0.5, 1.31094, 0.71375}};
    int i;
    if (is_float) return; /* Newton's derivatives need more digits */
    for (i = 0; i < 2; i++) {
        const double alpha = rows[i][0], larger = rows[i][2], smaller = rows[i][3];
        vm_forced f = detuned(alpha, rows[i][1], 0.02);
        vm_steady_state s[3];
        periodic_motion motion;
        double exponent;
        CHECK(vm_forced_steady_states(&f, 0, s) == 3);
        CHECK(!s[1].stable);
        exponent = (double)s[1].trace / 2 + sqrt((double)(s[1].trace * s[1].trace) / 4 - (double)s[1].det);
        near("saddle", "multiplier, averaged", exp(2 * pi / (double)f.frequency.f0 * exponent), larger, 5e-4, 1);
        rough = alpha < 3;
        motion = shoot(&f, s + 1);
        near("saddle", "multiplier, direct", motion.trace / 2 + sqrt(motion.trace * motion.trace / 4 - motion.det),
             larger, 5e-5, 1);
        near("saddle", "product", motion.det, larger * smaller, 3e-5, 1);
    }
    rough = 0;
}

/* The passage through resonance of a growing mass, alpha = 3, eps = 0.02: for kc < 1 the motion can be captured
   by the backbone A = sqrt(m), which kc = 1 ends. */
typedef struct capture {
    double m1, kc, A, release[2]; /* A where kc is 1; the amplitude of release, averaged and direct */
} capture;
static const capture captures[] = {{0.3, 0.4944, 2.0227, {2.236, 2.229}}, {0.2, 0.3296, 3.0341, {3.250, 3.245}}};

static void test_passage(void)
{
    int i;
    for (i = 0; i < 2; i++) {
        const capture *row = captures + i;
        const double rate = 0.02 * row->m1;
        vm_forced f = make_forced(3, 0, 1, 0.02, (double)vm_osc_omega_trig(3));
        vm_passage p;
        f.mass = linear(1, rate);
        CHECK(vm_forced_passage(&f, 0, 0, &p) == VM_OK);
        near("kc", "stated", (double)p.drift_ratio, row->kc, 2e-4, 2e-4);
        near("backbone", "A at m = 1", (double)p.A, 1, 1e-14, 1e-6);
        near("delta", "-asin kc", (double)p.delta, -asin(row->kc), 3e-4, 3e-4);
        CHECK(vm_forced_passage(&f, R((row->A * row->A - 1) / rate), 0, &p) == VM_OK);
        near("kc", "1 at the stated A", (double)p.drift_ratio, 1, 1e-4, 1e-4);
        near("backbone", "A", (double)p.A, row->A, 1e-4, 1e-4);
    }
}

/* Capture and release, by the averaged equations and by direct integration: the motion stays on the backbone to
   0.6 of the way, and after its release keeps A m^(1/6), whose mean tells the amplitude of release. */
static void test_capture(void)
{
    static const char *const stays[] = {"on the backbone, averaged", "on the backbone, direct"};
    static const char *const names[] = {"averaged", "direct"};
    const capture *row = captures;
    const double m_release = row->A * row->A;
    const double rate = 0.02 * row->m1, T = 16 / rate;
    vm_forced f = make_forced(3, 0, 1, 0.02, (double)vm_osc_omega_trig(3));
    vm_passage p;
    int k, direct;
    f.mass = linear(1, rate);
    CHECK(vm_forced_passage(&f, 0, 0, &p) == VM_OK);
    for (direct = 0; direct < 2; direct++) {
        const ode_rhs rhs = direct ? vm_forced_rhs : vm_forced_averaged_rhs;
        vm_real y[3] = {p.A, p.delta, 0}, A, psi;
        double mean = 0, off = 0;
        if (direct) vmi_slow_motion(p.A, p.delta * f.pi / VM_PI, 1, 1, 3, &y[0], &y[1]);
        for (k = 0; k < 2000; k++) {
            const double t = T * (k + 1) / 2000, m = 1 + rate * t;
            solve(rhs, &f, 3, T * k / 2000, t, 1e-9, y);
            A = y[0];
            if (direct) vmi_slow_phase(y[0], y[1], 1, R(m), 3, &A, &psi);
            if (m - 1 < 0.6 * (m_release - 1)) off = fmax(off, fabs((double)A / sqrt(m) - 1));
            if (k >= 1500) mean += (double)A * pow(m, 1. / 6) / 500;
        }
        near("release", names[direct], pow(mean, 0.75), row->release[direct], 1.5e-3, 5e-3);
        check_error("capture", stays[direct], "", off, direct ? 1.6e-2 : 1e-2, 0, 0);
    }
}

/* The mean of A m^(1/6) long after the passage, by direct integration from A = 1 and a phase */
static double amplitude_after(vm_forced *f, double rate, double phase)
{
    vm_real y[3] = {0}, A, psi;
    double mean = 0, t = 0;
    int k;
    vmi_slow_motion(1, R(phase), 1, 1, 3, &y[0], &y[1]);
    for (k = 0; k < 400; k++) {
        const double next = 300 + 0.5 * (k + 1), m = 1 + rate * next;
        solve(vm_forced_rhs, f, 3, t, next, 1e-8, y);
        t = next;
        vmi_slow_phase(y[0], y[1], 1, R(m), 3, &A, &psi);
        mean += (double)A * pow(m, 1. / 6) / 400;
    }
    return mean;
}

/* A quick passage, kc > 1: the amplitude jumps by what the formula says, up or down depending on the phase. */
static void test_jump(void)
{
    static const double rows[][4] = {/* F, kc, formula stated, direct stated, eps = 0.01 */
                                     {0.05, 23, 0.009, 0.00806},
                                     {0.1, 11.5, 0.01799, 0.01626},
                                     {0.4, 2.88, 0.07196, 0.06936}};
    const double e = 0.01, Om1 = (double)vm_osc_omega_trig(3), m_resonance = pow(4. / 3, 1.5);
    int i, j;
    for (i = 0; i < 3; i++) {
        vm_forced f = make_forced(3, 0, 1, e * rows[i][0], 0.75 * Om1);
        double low = HUGE_VAL, high = 0, jump;
        vm_passage p;
        f.mass = linear(1, e);
        CHECK(vm_forced_passage(&f, R((m_resonance - 1) / e), 0, &p) == VM_OK);
        near("jump", "kc stated", (double)p.drift_ratio, rows[i][1], 2e-3, 2e-3);
        near("jump", "formula stated", (double)p.amplitude_jump, rows[i][2], 6e-4, 6e-4);
        CHECK(is_nan(p.delta));
        near("jump", "A on the backbone", (double)p.A, pow(m_resonance, -1. / 6), 1e-13, 1e-5);
        for (j = 0; j < 24; j++) {
            const double after = amplitude_after(&f, e, 2 * j / 24. * (double)f.pi);
            low = fmin(low, after);
            high = fmax(high, after);
        }
        jump = (high - low) / 2;
        check_error("jump", "direct", "formula", fabs(jump / (double)p.amplitude_jump - 1), by_precision(0.2, 0.25),
                    rows[i][0], 0);
        near("jump", "direct stated", jump, rows[i][3], 0.1, 0.2);
    }
}

/* ---- Bad input ---- */

static void test_bad_oscillators(void)
{
    const double bad[] = {0, -1, (double)VM_NAN, (double)VM_INFINITY};
    const vm_real y[5] = {1, 2, 3, 4, 5};
    const vm_forced f = make_forced(3, 1, 1, 1, 1);
    vm_forced other;
    vm_real d[5] = {7, 7, 7, 7, 7};
    vm_steady_state s[3];
    vm_passage passage;
    int i;
    CHECK(vm_forced_init(NULL) == VM_BAD_ARGUMENT);
    for (i = 0; i < 4; i++) {
        other = f;
        other.stiffness = linear(bad[i], 0);
        CHECK(vm_forced_init(&other) == (i < 2 ? VM_BAD_STIFFNESS : VM_NOT_FINITE));
        other = f;
        other.frequency = linear(bad[i], 0);
        CHECK(vm_forced_init(&other) == (i < 2 ? VM_DOMAIN : VM_NOT_FINITE));
        other = f;
        other.mass = linear(bad[i], 0);
        CHECK(vm_forced_init(&other) == (i < 2 ? VM_BAD_MASS : VM_NOT_FINITE));
        CHECK(vm_forced_steady_states(&other, 0, s) == (i < 2 ? VM_BAD_MASS : VM_NOT_FINITE));
        CHECK(vm_forced_rhs(0, y, d, &other) < 0 && vm_forced_exact_rhs(0, y, d, &other) < 0);
        CHECK(vm_forced_averaged_rhs(0, y, d, &other) < 0);
        CHECK(vm_forced_to_averaged(&other, 0, y, d) < 0 && vm_forced_from_averaged(&other, 0, y, d) < 0);
        CHECK(vm_forced_passage(&other, 0, 1, &passage) < 0 && vm_forced_curve(&other, 0, 1, s) < 0);
        CHECK(is_nan(vm_forced_peak(&other, 0)));
        other.frequency = linear((double)VM_NAN, 0); /* of two mistakes the first in the order of statuses */
        CHECK(vm_forced_init(&other) == VM_NOT_FINITE);
        memset(&other.force, 0, sizeof other.force);
        CHECK(vm_forced_init(&other) == VM_BAD_ARGUMENT);
    }
    for (i = 0; i < 5; i++) CHECK(d[i] == 7); /* all of them left it alone */
}

static void test_bad_states(void)
{
    vm_forced f = make_forced(3, 1, 1, 1, 1);
    vm_real y[3] = {1, VM_NAN, 3}, d[3] = {7, 7, 7};
    vm_steady_state s[3];
    int i;
    CHECK(vm_forced_to_averaged(&f, 0, y, d) == VM_NOT_FINITE);
    for (i = 0; i < 3; i++) {
        y[0] = 1;
        y[1] = y[2] = 0;
        y[i] = VM_NAN;
        CHECK(vm_forced_to_averaged(&f, 0, y, d) == VM_NOT_FINITE && vm_forced_from_averaged(&f, 0, y, d) == VM_NOT_FINITE);
    }
    y[0] = y[1] = VM_MAX; /* the amplitude overflows */
    y[2] = 0;
    CHECK(vm_forced_to_averaged(&f, 0, y, d) == VM_NOT_FINITE);
    CHECK(vm_forced_curve(&f, 0, 0, s) == VM_DOMAIN);
    f.force = linear(0, 0); /* without a force there is no forced vibration */
    CHECK(vm_forced_steady_states(&f, 0, s) == 0);
    for (i = 0; i < 3; i++) CHECK(d[i] == 7); /* all of them left it alone */
}

int main(void)
{
    test_fourier();
    test_exact_equations();
    test_reference();
    test_waveform();
    test_steady_states();
    test_random_steady_states();
    test_nearly_linear();
    test_undamped_resonance();
    test_periodic_motions();
    test_saddles();
    test_passage();
    test_capture();
    test_jump();
    test_bad_oscillators();
    test_bad_states();
    return check_finish("forced");
}
