/* Two weakly coupled oscillators with slow masses (src/oscillators/grounded_pair.h): averaged equations against direct
   integration with equal frequencies, in an internal resonance and without one, the invariant of a resonance, and the two
   frequencies of equal linear oscillators, which have a closed form. */
#include "../varmass.h"
#include "check.h"
#include "slow_vibrations.h"

typedef struct pair_row {
    double alpha[2], k[2];
    int P[2];
    double spring, damper; /* of the coupling, over e */
    double rate[2];        /* of the masses, over e */
    double phase;          /* of body 1 at the start, rad */
    double bound, order;   /* on the error of x at e = 0.005, and its least order */
    double amplitude_order; /* least order of the error of the amplitudes */
} pair_row;

static vm_grounded_pair make_pair(const pair_row *row, double e)
{
    vm_grounded_pair p;
    int i;
    memset(&p, 0, sizeof p);
    for (i = 0; i < 2; i++) {
        p.oscillator[i].alpha = R(row->alpha[i]);
        p.oscillator[i].damping = R(0.1 * e);
        p.oscillator[i].reactive = R(i == 0 ? 1 : 0.5);
        p.oscillator[i].mass = linear(1 + i, e * row->rate[i]);
        p.oscillator[i].stiffness = linear(row->k[i], 0);
        p.vibrations[i] = row->P[i];
    }
    p.spring = R(e * row->spring);
    p.damper = R(e * row->damper);
    CHECK(vm_grounded_pair_init(&p) == VM_OK);
    return p;
}

/* The largest errors of both positions and of both amplitudes, with their ripple, on [0, 2/e] */
typedef struct pair_errors {
    double x, amplitude;
} pair_errors;

static double amplitude_of(const vm_grounded_pair *p, const pair_row *row, int i, double t, const vm_real *y)
{
    vm_real mass = 1, rate, A, psi;
    CHECK(vm_law_at(&p->oscillator[i].mass, R(t), &mass, &rate) == VM_OK);
    vmi_slow_phase(y[i], y[2 + i], R(row->k[i]), mass, R(row->alpha[i]), &A, &psi);
    return (double)A;
}

static pair_errors errors_of_averaging(const pair_row *row, double e)
{
    vm_grounded_pair p = make_pair(row, e);
    vm_real y[4] = {1, R(0.8), 0, 0}, slow[4] = {1, 0, 1, 0}, got[4] = {0};
    const int n = (int)(2 / e / 0.5);
    pair_errors worst = {0, 0};
    int i, k;
    vmi_slow_motion(R(0.8), R(row->phase) * p.oscillator[1].pi / VM_PI, R(row->k[1]), 2, R(row->alpha[1]), &y[1], &y[3]);
    CHECK(vm_grounded_pair_to_averaged(&p, 0, y, slow) == VM_OK);
    for (i = 1; i <= n; i++) {
        const double before = 2 / e * (i - 1) / n, t = 2 / e * i / n;
        solve(vm_grounded_pair_rhs, &p, 4, before, t, 1e-10, y);
        solve(vm_grounded_pair_averaged_rhs, &p, 4, before, t, 1e-10, slow);
        CHECK(vm_grounded_pair_from_averaged(&p, R(t), slow, got) == VM_OK);
        for (k = 0; k < 2; k++) {
            const double off = amplitude_of(&p, row, k, t, got) - amplitude_of(&p, row, k, t, y);
            worst.x = fmax(worst.x, fabs((double)(got[k] - y[k])));
            worst.amplitude = fmax(worst.amplitude, fabs(off));
        }
    }
    return worst;
}

/* The stiffness of body 1 (mass 2, amplitude 0.8) for which its frequency is `ratio` times that of body 0 (mass 1,
   amplitude 1, stiffness 1) */
static double stiffness_for(double alpha0, double alpha1, double ratio)
{
    const double w0 = (double)vm_osc_omega_trig(R(alpha0)), w1 = (double)vm_osc_omega_trig(R(alpha1));
    return 2 * pow(ratio * w0 / w1, 2) / pow(0.8, alpha1 - 1);
}

/* The errors of amplitudes and positions by the averaged equations fall with e up to t = 2/e. For alpha != 1 the error of
   the amplitudes makes one of the phases, so that the positions have a lower order. */
static void test_averaging(void)
{
    pair_row rows[] = {
        {{1, 1}, {1, 0}, {1, 1}, 0.5, 0.1, {0, 0}, 0.5, 0.01, 0.9, 0.8},     /* equal frequencies, linear */
        {{1, 1}, {1, 0}, {1, 1}, 0.5, 0.1, {0.2, 0.4}, 0.5, 0.02, 0.9, 0.8}, /* with masses that grow alike */
        {{3, 3}, {1, 0}, {1, 1}, -0.5, 0.1, {0, 0}, 0.3, 0.05, 0.5, 0.8},
        {{3, 3}, {1, 0}, {1, 1}, 0.5, 0, {0, 0}, 0.3, 0.05, 0.5, 0.8},
        {{3, 1}, {1, 0}, {1, 1}, 0.5, 0.1, {0, 0}, 0.3, 0.05, 0.5, 0.8},
        {{1, 1}, {1, 0}, {0, 0}, 0.5, 0.1, {0.2, -0.1}, 0.5, 0.01, 0.9, 0.8}, /* no resonance */
        {{3, 2.5}, {1, 0}, {0, 0}, 0.5, 0.1, {0, 0}, 0.5, 0.05, 0.3, 0.8},
        {{3, 1}, {1, 0}, {1, 3}, 1, 0, {0, 0}, 2.84, 0.05, 0.3, 0.8}, /* internal resonance 1:3, by c_3 = 0.04 of ca */
    };
    static const double ratios[] = {1, 1, 1, 1, 1, 1.5, 1.5, 3};
    size_t i;
    if (is_float) return; /* the order needs more digits */
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        pair_row *row = &rows[i];
        pair_errors coarse, fine;
        double order, amplitude_order;
        row->k[1] = stiffness_for(row->alpha[0], row->alpha[1], ratios[i]);
        rough = (row->alpha[1] != 1 && row->alpha[1] < 3);
        coarse = errors_of_averaging(row, 0.04);
        fine = errors_of_averaging(row, 0.005);
        order = log(coarse.x / fine.x) / log(8);
        amplitude_order = log(coarse.amplitude / fine.amplitude) / log(8);
        printf("alpha = %g, %g, %d:%d, error of x %.2g at e = 0.04, %.2g at e = 0.005, order %.2f; of A %.2g, %.2g, order %.2f\n",
               row->alpha[0], row->alpha[1], row->P[0], row->P[1], coarse.x, fine.x, order, coarse.amplitude, fine.amplitude,
               amplitude_order);
        check_error("averaged", "x", "stated", fine.x / row->bound, 1, row->alpha[0], row->alpha[1]);
        check_error("averaged", "missing order of x", "", row->order - order, 0, row->alpha[0], row->alpha[1]);
        check_error("averaged", "A", "", fine.amplitude, 1e-3, row->alpha[0], row->alpha[1]);
        check_error("averaged", "missing order of A", "", row->amplitude_order - amplitude_order, 0, row->alpha[0],
                    row->alpha[1]);
        rough = 0;
    }
}

/* Without damping P_0 J_0 + P_1 J_1 stays, where dJ = dE/w and E is the energy of a body. */
static void test_invariant(void)
{
    int i, k;
    for (i = 0; i < 300; i++) {
        const int odd[3] = {1, 3, 5};
        pair_row row = {{uniform(0.5, 5), uniform(0.5, 5)}, {uniform(0.5, 2), uniform(0.5, 2)}, {1, 1}, 1, 0, {0, 0}, 0, 0, 0, 0};
        vm_grounded_pair p;
        vm_real y[4], d[4] = {0};
        double sum = 0, scale = 0;
        row.P[0] = odd[i % 3];
        row.P[1] = odd[i / 3 % 3];
        p = make_pair(&row, 0.1);
        for (k = 0; k < 2; k++) {
            p.oscillator[k].damping = 0;
            y[2 * k] = R(uniform(0.5, 1.5));
            y[2 * k + 1] = R(uniform(-3, 3));
        }
        CHECK(vm_grounded_pair_averaged_rhs(0, y, d, &p) == VM_OK);
        for (k = 0; k < 2; k++) {
            const double A = (double)y[2 * k], alpha = row.alpha[k];
            const double w = (double)vm_osc_omega_trig(R(alpha)) * sqrt(row.k[k] / (1 + k)) * pow(A, (alpha - 1) / 2);
            const double J_rate = row.P[k] * row.k[k] * pow(A, alpha) * (double)d[2 * k] / w;
            sum += J_rate;
            scale = fmax(scale, fabs(J_rate) + 0.1 * fabs((double)p.oscillator[k].c[0]));
        }
        check_error("resonance", "P0 J0 + P1 J1", "eps", fabs(sum) / scale / eps, 16, row.alpha[0], row.alpha[1]);
    }
}

/* Two equal linear oscillators: the averaged frequencies of both modes, w and w + kappa/(m w), and the decay of the mode
   in which the damper works, which are those of the exact solution to the first order */
static void test_linear_modes(void)
{
    const double e = 0.01;
    vm_grounded_pair p;
    vm_real y[4] = {1, R(0.25), 1, R(0.25)}, d[4] = {0};
    int k;
    memset(&p, 0, sizeof p);
    for (k = 0; k < 2; k++) {
        p.oscillator[k].alpha = 1;
        p.oscillator[k].mass = linear(2, 0);
        p.oscillator[k].stiffness = linear(8, 0); /* w = 2 */
        p.vibrations[k] = 1;
    }
    p.spring = R(e);
    p.damper = R(e);
    CHECK(vm_grounded_pair_init(&p) == VM_OK);
    CHECK(vm_grounded_pair_averaged_rhs(0, y, d, &p) == VM_OK);
    for (k = 0; k < 2; k++) {
        check_error("mode in phase", "A'", "eps", fabs((double)d[2 * k]) / e / eps, 8, k, 0);
        near_eps("mode in phase", "phi'", (double)d[2 * k + 1], 2, 8);
    }
    y[3] += VM_PI;
    CHECK(vm_grounded_pair_averaged_rhs(0, y, d, &p) == VM_OK);
    for (k = 0; k < 2; k++) {
        near_eps("mode in opposition", "A'", (double)d[2 * k], -e / 2, 16);
        near_eps("mode in opposition", "phi'", (double)d[2 * k + 1], 2 + e / 4, 8);
    }
}

/* The maps lead back to where they came from, but for what three iterations leave, at nearly equal frequencies. */
static void test_maps(void)
{
    int i, k;
    for (i = 0; i < 300; i++) {
        pair_row row = {{uniform(0.8, 4), uniform(0.8, 4)}, {1, 0}, {1, 1}, 1, 0.5, {0.1, -0.1}, 0, 0, 0, 0};
        vm_grounded_pair p;
        vm_real y[4], back[4] = {0}, motion[4] = {0};
        row.k[1] = stiffness_for(row.alpha[0], row.alpha[1], 1);
        p = make_pair(&row, is_float ? 1e-2 : 1e-3);
        for (k = 0; k < 4; k++) y[k] = R(k % 2 ? uniform(-3, 3) : uniform(0.98, 1.02) * (k == 0 ? 1 : 0.8));
        CHECK(vm_grounded_pair_from_averaged(&p, 0, y, motion) == VM_OK);
        CHECK(vm_grounded_pair_to_averaged(&p, 0, motion, back) == VM_OK);
        for (k = 0; k < 4; k++)
            check_error("maps", "there and back", "", fabs((double)(back[k] - y[k])), by_precision(1e-9, 1e-3), row.alpha[0],
                        row.alpha[1]);
    }
}

/* ---- Bad input ---- */

/* At a resonance of any P_0 and P_1, the amplitudes that vm_grounded_pair_to_averaged finds in a motion are those that
   vm_grounded_pair_from_averaged put into it, if the ripple is small. Where a divisor of the ripple was nearly 0 at
   some amplitude, they were up to a hundred times as large or as small. */
static void test_mean_at_resonances(void)
{
    int P, Q, i, k;
    for (P = 1; P <= 9; P++)
        for (Q = 1; Q <= 9; Q++) {
            const double ratio = (double)Q / P;
            vm_grounded_pair p;
            memset(&p, 0, sizeof p);
            for (i = 0; i < 2; i++) {
                p.oscillator[i].alpha = 3;
                p.oscillator[i].mass = p.oscillator[i].stiffness = linear(1, 0);
            }
            p.spring = R(0.05);
            p.vibrations[0] = P;
            p.vibrations[1] = Q;
            CHECK(vm_grounded_pair_init(&p) == VM_OK);
            for (i = 0; i < 24; i++)
                for (k = 0; k < 24; k++) {
                    const vm_real y[4] = {1, R(-3 + 0.25 * i), R(ratio), R(-3 + 0.25 * k)};
                    vm_real motion[4], back[4] = {0, 0, 0, 0}, x, psi;
                    double ripple = 0;
                    int body;
                    if (vm_grounded_pair_from_averaged(&p, 0, y, motion) != VM_OK) continue;
                    for (body = 0; body < 2; body++) {
                        vmi_slow_phase(motion[body], motion[2 + body], 1, 1, 3, &x, &psi);
                        ripple = fmax(ripple, fabs((double)(x / y[2 * body]) - 1));
                    }
                    if (ripple > 0.08) continue;
                    CHECK(vm_grounded_pair_to_averaged(&p, 0, motion, back) == VM_OK);
                    check_error("mean", "A_0 at P_0 : P_1", "", fabs((double)back[0] - 1), 0.03, P, Q);
                    check_error("mean", "A_1 at P_0 : P_1", "", fabs((double)back[2] / ratio - 1), 0.03, P, Q);
                }
        }
}

static void test_refusals(void)
{
    const pair_row row = {{3, 3}, {1, 1}, {1, 1}, 1, 0, {0, 0}, 0, 0, 0, 0};
    vm_grounded_pair p = make_pair(&row, 0.01), q = p, before;
    const vm_real y[4] = {1, 0, 1, 0}, rest[4] = {1, 0, 0, 0}, bad[4] = {1, VM_NAN, 1, 0}, negative[4] = {-1, 0, 1, 0};
    vm_real d[4] = {7, 7, 7, 7};
    int k;
    q.vibrations[0] = 0;
    before = q;
    CHECK(vm_grounded_pair_init(&q) == VM_BAD_ARGUMENT && same_bytes(&q, &before, sizeof q));
    q.vibrations[0] = 10;
    CHECK(vm_grounded_pair_rhs(0, y, d, &q) == VM_BAD_ARGUMENT && vm_grounded_pair_init(NULL) == VM_BAD_ARGUMENT);
    q = p;
    q.spring = VM_INFINITY;
    CHECK(vm_grounded_pair_init(&q) == VM_NOT_FINITE && vm_grounded_pair_averaged_rhs(0, y, d, &q) == VM_NOT_FINITE);
    q = p;
    q.oscillator[1].mass = linear(0, 0);
    CHECK(vm_grounded_pair_init(&q) == VM_BAD_MASS && vm_grounded_pair_to_averaged(&q, 0, y, d) == VM_BAD_MASS);
    q = p;
    q.oscillator[0].stiffness = linear(-1, 0);
    CHECK(vm_grounded_pair_init(&q) == VM_BAD_STIFFNESS);
    q = p;
    q.oscillator[0].alpha = -1;
    CHECK(vm_grounded_pair_init(&q) == VM_DOMAIN);
    CHECK(vm_grounded_pair_to_averaged(&p, 0, rest, d) == VM_DOMAIN);
    CHECK(vm_grounded_pair_to_averaged(&p, 0, bad, d) == VM_NOT_FINITE);
    CHECK(vm_grounded_pair_from_averaged(&p, 0, bad, d) == VM_NOT_FINITE);
    CHECK(vm_grounded_pair_from_averaged(&p, 0, negative, d) == VM_DOMAIN);
    for (k = 0; k < 4; k++) CHECK(d[k] == 7);
}

int main(void)
{
    test_averaging();
    test_invariant();
    test_linear_modes();
    test_maps();
    test_mean_at_resonances();
    test_refusals();
    return check_finish("grounded_pair");
}
