/* Fuzz target: ateb.h. Ranges, symmetries, identities, inverses, what is outside the domain. */
#include "fuzz.h"

/* alpha of all kinds, in the promised range or refused: from 1e30 on sa, ca of plans may be NaN */
static vm_real draw_alpha(void)
{
    vm_real alpha;
    switch (draw_below(5)) {
    case 0: return drawn((double)draw_below(33) / 4);
    case 1: return draw_in(0, 8);
    case 2: return draw_log(1e-12, 1e6);
    case 3: return draw_log(IS_FLOAT ? 1e-37 : 1e-300, 1e30);
    default: alpha = draw_any();
    }
    if (alpha > R(1e30) && is_finite(alpha)) return drawn(1e30);
    return alpha > 0 && alpha < (IS_FLOAT ? VM_MIN : R(1e-300)) ? drawn(0) : alpha;
}

static vm_real draw_s(vm_real pi)
{
    const int kind = draw_below(4);
    const vm_real scale = is_finite(pi) ? pi : 1;
    if (kind == 0) return draw_beside(scale / 4 * R((int)draw_byte() - 128));
    if (kind == 1) return drawn((double)(scale * draw_in(-2, 2)));
    if (kind == 2) return draw_signed(IS_FLOAT ? 1e4 : 1e9);
    return draw_any();
}

static int alpha_valid(vm_real alpha) { return alpha >= 0 && is_finite(alpha); }
static int alpha_promised(vm_real alpha)
{
    return alpha == 0 || (alpha >= (IS_FLOAT ? VM_MIN : R(1e-300)) && alpha <= R(1e30));
}

/* sa^2 + |ca|^(alpha+1) - 1 in the pair's own condition: so many eps of each of the two */
static void check_curve(vm_real sa, vm_real ca, vm_real alpha, double epsilons)
{
    const double s = (double)sa, n = (double)alpha + 1, x = pow(fabs((double)ca), n);
    HOLDS(VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
    if (n * EPS > 0.01) return; /* an ulp of ca says nothing about x */
    HOLDS(fabs(s * s + x - 1) <= (epsilons * (2 * s * s + n * x) + 2) * EPS);
}

/* where in the period s is, in quarters, to leave alone what is next to a turning point */
static double quarters(vm_real s, vm_real pi)
{
    const double x = (double)s / (double)pi * 2;
    return x - 4 * floor(x / 4);
}

static void check_monotone(vm_real s, vm_real alpha, vm_real pi, vm_real sa, vm_real ca)
{
    const double at = quarters(s, pi);
    vm_real sa2, ca2;
    if (!(VM_FABS(s) <= 100 * pi)) return;
    ateb_saca(neighbour(s, 1), alpha, &sa2, &ca2);
    if (at < 0.99 || at > 3.01) HOLDS(sa2 >= sa - 4 * VM_EPSILON * VM_FABS(sa));
    if (at > 1.01 && at < 2.99) HOLDS(sa2 <= sa + 4 * VM_EPSILON * VM_FABS(sa));
    if (at > 0.01 && at < 1.99) HOLDS(ca2 <= ca + 4 * VM_EPSILON * VM_FABS(ca));
    if (at > 2.01 && at < 3.99) HOLDS(ca2 >= ca - 4 * VM_EPSILON * VM_FABS(ca));
}

static void check_phase_back(vm_real s, vm_real alpha, vm_real pi, vm_real sa, vm_real ca)
{
    const vm_real phase = ateb_phase(sa, ca, alpha);
    const double n = (double)alpha + 1, x = pow(fabs((double)ca), n);
    HOLDS(is_finite(phase) && VM_FABS(phase) <= pi * (1 + VM_EPSILON));
    HOLDS(same_bits(ateb_phase(-sa, ca, alpha), -phase) || VM_FABS(phase) == pi || phase == 0);
    if (!(VM_FABS(s) < pi * R(0.999)) || alpha > R(1e6) || x < 1e-30) return;
    /* rho = sa^2/|ca|^n, ds = |sa ca|/2 d rho/rho: what the 4 ulp of sa and of ca move, and the phase's own 4 ulp */
    HOLDS(within(phase, s, (8 * fabs((double)s) + 4 * fabs((double)sa * (double)ca) * (1 + n / 2)) * EPS));
}

static void check_ateb_plan(vm_real s, vm_real alpha, vm_real sa, vm_real ca)
{
    const vm_real pi = ateb_pi(alpha);
    vm_real ss[7], sas[7], cas[7], a, c;
    ateb_plan p;
    int i;
    STAIN(p);
    if (ateb_plan_init(&p, alpha)) {
        HOLDS(UNTOUCHED(p) && !alpha_valid(alpha));
        HOLDS(ateb_plan_init_to(&p, alpha, R(1e-4)) && UNTOUCHED(p));
        return;
    }
    HOLDS(alpha_valid(alpha));
    if (alpha > R(1e6) || (alpha > 0 && alpha < R(1e-30)) || !(VM_FABS(s) <= (IS_FLOAT ? R(1e4) : R(1e9)))) return;
    for (i = 0; i < 7; i++) ss[i] = s + R(i) * pi / 4;
    ateb_plan_saca_array(&p, 7, ss, sas, cas);
    for (i = 0; i < 7; i++) {
        ateb_plan_saca(&p, ss[i], &a, &c);
        HOLDS(within(a, sas[i], 4 * EPS) && within(c, cas[i], 4 * EPS));
    }
    ateb_plan_saca(&p, s, &a, &c);
    HOLDS(within(a, sa, 8 * EPS) && within(c, ca, 8 * EPS));
    check_curve(a, c, alpha, 4);
    if (ateb_plan_init_to(&p, alpha, R(1e-4)) == 0) {
        ateb_plan_saca(&p, s, &a, &c);
        HOLDS(within(a, sa, 2e-4) && within(c, ca, 2e-4));
    }
}

static void check_saca(void)
{
    const vm_real alpha = draw_alpha(), pi = ateb_pi(alpha), s = draw_s(pi);
    vm_real sa, ca, sa2, ca2;
    ateb_saca(s, alpha, &sa, &ca);
    HOLDS(same_bits(sa, ateb_sa(s, alpha)) && same_bits(ca, ateb_ca(s, alpha)));
    if (!alpha_valid(alpha) || !is_finite(s)) {
        HOLDS(is_nan(sa) && is_nan(ca));
        HOLDS(alpha_valid(alpha) ? pi >= 2 : is_nan(pi));
        HOLDS(is_nan(ateb_integral_sa2(s, alpha)) && is_nan(ateb_integral_ca(s, alpha)));
        if (is_finite(s)) check_ateb_plan(s, alpha, sa, ca);
        return;
    }
    ateb_saca(-s, alpha, &sa2, &ca2);
    HOLDS(same_bits(sa2, -sa) && same_bits(ca2, ca));
    if (!alpha_promised(alpha)) return;
    HOLDS(VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
    HOLDS(pi >= (alpha + 1) * (1 - VM_EPSILON) && pi <= (alpha + 1 + R(1.3862943611198906)) * (1 + VM_EPSILON));
    HOLDS(ateb_pi(neighbour(alpha, 1)) >= pi * (1 - VM_EPSILON));
    if (VM_FABS(s) <= (IS_FLOAT ? R(1e4) : R(1e9))) check_curve(sa, ca, alpha, 4);
    check_monotone(s, alpha, pi, sa, ca);
    check_phase_back(s, alpha, pi, sa, ca);
    check_ateb_plan(s, alpha, sa, ca);
    if (alpha <= R(1e6) && VM_FABS(s) < 100 * pi) { /* the integral of sa^2 + |ca|^(alpha+1) = 1 is s */
        const vm_real of_sa2 = ateb_integral_sa2(s, alpha), of_ca = ateb_integral_ca(s, alpha);
        HOLDS(within(of_sa2 + of_ca, s, 32 * EPS * fabs((double)s) + (double)VM_MIN));
        HOLDS(s >= 0 ? of_sa2 >= 0 && of_ca >= 0 : of_sa2 <= 0 && of_ca <= 0);
    }
}

static void check_phase(void)
{
    const vm_real alpha = MOSTLY(draw_alpha()), v = draw_any(), u = draw_any(), phase = ateb_phase(v, u, alpha);
    if (!(alpha >= 0 && alpha <= R(1e30)) || !is_finite(v) || !is_finite(u)) HOLDS(is_nan(phase));
    else if (alpha_promised(alpha)) {
        HOLDS(!is_nan(phase) && VM_FABS(phase) <= ateb_pi(alpha) * (1 + VM_EPSILON));
        HOLDS(v == 0 || phase == 0 || (v > 0) == (phase > 0));
    }
}

static int is_a_limit(vm_real a) { return a == 0 || (a > 0 && !is_finite(a)); }

/* Logarithms of the beta functions beside the functions themselves */
static void check_ln_beta(vm_real x, vm_real a, vm_real b, vm_real B, vm_real p)
{
    const vm_real ln_B = ateb_ln_beta(a, b), ln_p = ateb_ln_beta_inc(x, a, b);
    if (B > VM_MIN / VM_EPSILON && is_finite(B))
        HOLDS(within(ln_B, R(log((double)B)), 4 * EPS * (1 + fabs((double)ln_B))));
    if (a >= R(1e-30) && a <= R(1e30) && b >= R(1e-30) && b <= R(1e30)) HOLDS(is_finite(ln_B));
    HOLDS(ln_p <= 0);
    if (p > VM_MIN / VM_EPSILON && a >= R(1e-3) && a <= R(1e4) && b >= R(1e-3) && b <= R(1e4))
        HOLDS(within(ln_p, R(log((double)p)), 64 * EPS * (1 + fabs((double)ln_p))));
}

static void check_beta(void)
{
    const vm_real a = MOSTLY(draw_log(1e-4, 1e5)), b = MOSTLY(draw_log(1e-4, 1e5)), x = MOSTLY(draw_in(0, 1));
    vm_real p, q, p2, q2, B;
    B = ateb_beta(a, b);
    if (is_a_limit(a) || is_a_limit(b)) {
        p = ateb_beta_inc(x, a, b);
        HOLDS((is_nan(B) || B == 0 || !is_finite(B)) && (is_nan(p) || p == 0 || p == 1));
        return;
    }
    if (!(a >= R(1e-4) && a <= R(1e5) && b >= R(1e-4) && b <= R(1e5))) {
        HOLDS(is_nan(B) && is_nan(ateb_beta_inc(x, a, b)) && is_nan(ateb_beta_inc_inv(x, a, b)));
        return;
    }
    if (!(x >= 0 && x <= 1)) {
        HOLDS(is_nan(ateb_beta_inc(x, a, b)) && is_nan(ateb_beta_inc_inv(x, a, b)));
        return;
    }
    HOLDS(B >= 0 && close_to(B, ateb_beta(b, a), 4));
    check_ln_beta(x, a, b, B, ateb_beta_inc(x, a, b));
    if (B > VM_MIN / VM_EPSILON && B < VM_MAX / 4) /* B(a + 1, b) = B(a, b) a/(a + b) */
        HOLDS(close_to(ateb_beta(a + 1, b), B * (a / (a + b)), 8 + ((double)(a + b))) || a + 1 > R(1e5));
    if (!(a >= R(1e-3) && a <= R(1e4) && b >= R(1e-3) && b <= R(1e4))) { /* less accurate */
        p = ateb_beta_inc(x, a, b);
        q = ateb_beta_inc_inv(x, a, b);
        HOLDS(p >= 0 && p <= 1 && q >= 0 && q <= 1);
        return;
    }
    ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
    HOLDS(p >= 0 && p <= 1 && q >= 0 && q <= 1);
    HOLDS(within(p + q, 1, 64 * EPS));
    HOLDS(same_bits(ateb_beta_inc(x, a, b), p) || x < R(0.5)); /* 1 - x is exact above */
    ateb_beta_inc_both(1 - x, x, b, a, &p2, &q2);
    HOLDS(close_to(p, q2, 64) && close_to(q, p2, 64));
    if (x < 1) HOLDS(ateb_beta_inc(neighbour(x, 1), a, b) >= ateb_beta_inc(x, a, b) * (1 - 64 * VM_EPSILON));
}

static void check_beta_inverse(void)
{
    const vm_real a = draw_log(1e-3, 1e4), b = draw_log(1e-3, 1e4), p = draw_in(0, 1);
    vm_real x, y, ln_x, p2, q2;
    ateb_beta_inc_inv_both(p, 1 - p, a, b, &x, &y, &ln_x);
    HOLDS(x >= 0 && x <= 1 && y >= 0 && y <= 1 && ln_x <= 0);
    HOLDS(within(x + y, 1, 64 * EPS));
    ateb_beta_inc_both(x, y, a, b, &p2, &q2);
    if (x > VM_MIN / VM_EPSILON && y > VM_MIN / VM_EPSILON) {
        /* d ln p = x^a y^b/(B p) (dx/x)/y, d ln q alike: what 16 ulp of x and of y move, and the 30 of p itself */
        const double A = (double)a, B = (double)b, ln_beta = lgamma(A) + lgamma(B) - lgamma(A + B);
        const double moves = exp(A * log((double)x) + B * log((double)y) - ln_beta) / (double)(x < y ? y : x);
        HOLDS(within(p2, p, (40 * (double)(p < R(0.5) ? p : 1 - p) + 40 * moves + 2) * EPS));
    }
    if (p < 1)
        HOLDS(ateb_beta_inc_inv(neighbour(p, 1), a, b) >=
              ateb_beta_inc_inv(p, a, b) * (1 - 64 * VM_EPSILON) - 2 * SMALLEST);
}

static void check_means(void)
{
    const vm_real alpha = draw_alpha(), p = MOSTLY(draw_in(-0.9, 12)), q = MOSTLY(draw_in(-0.9, 12));
    vm_real mean;
    mean = ateb_mean(alpha, p, q);
    HOLDS(same_bits(mean, ateb_mean_nm(1, alpha, p, q, 0)) || is_nan(mean));
    if (!alpha_valid(alpha) || !(p > -1 && p <= R(1e6)) || !(q > -1 && q <= R(1e6))) HOLDS(is_nan(mean));
    else if (alpha_promised(alpha)) HOLDS(mean >= 0 && (p < 0 || q < 0 || mean <= 1 + 4 * VM_EPSILON));
    if (alpha_promised(alpha) && p > -1 && p + 2 <= R(1e6) && q > -1 && q <= R(1e6) && mean > VM_MIN / VM_EPSILON) {
        /* B(a + 1, b) = B(a, b) a/(a + b); an eps of p + 2 moves ln B by a eps (1/a + ln(1 + b/a)) <= (1 + b) eps */
        const double a = ((double)p + 1) / 2, b = ((double)q + 1) / ((double)alpha + 1);
        HOLDS(
            within(ateb_mean(alpha, p + 2, q), R((double)mean * (a / (a + b))), (8 + 2 * b) * EPS * (double)mean));
    }
    if (!(alpha_promised(alpha) && alpha < R(1e6))) return;
    HOLDS(within(ateb_mean(alpha, 2, 0) + ateb_mean(alpha, 0, alpha + 1), 1, 8 * EPS));
}

static void check_pair_of_two(void)
{
    const vm_real n = MOSTLY(draw_byte() % 8 ? draw_log(1e-3, 1e3) : 0), m = MOSTLY(draw_log(1e-3, 1e3));
    const int refused = !(n == 0 || (n >= R(1e-4) && n <= R(1e5))) || !(m == 0 || (m >= R(1e-4) && m <= R(1e5)));
    const int promised = (n == 0 || (n >= R(1e-3) && n <= R(1e3))) && (m == 0 || (m >= R(1e-3) && m <= R(1e3)));
    const vm_real pi = ateb_pi_nm(n, m), s = draw_s(pi);
    vm_real sa, ca;
    ateb_saca_nm(s, n, m, &sa, &ca);
    if (refused || !is_finite(s)) {
        HOLDS(is_nan(sa) && is_nan(ca) && (is_finite(s) ? is_nan(pi) : 1));
        return;
    }
    HOLDS(pi > 0 && VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1);
    if (promised && VM_FABS(s) < 100 * pi) {
        const double x = pow(fabs((double)sa), (double)n + 1), y = pow(fabs((double)ca), (double)m + 1);
        HOLDS(fabs(x + y - 1) <= (8 * (((double)n + 1) * x + ((double)m + 1) * y) + 4) * EPS);
    }
}

static void fuzz_ateb(void)
{
    switch (draw_below(8)) {
    case 0: check_phase(); break;
    case 1: check_beta(); break;
    case 2: check_beta_inverse(); break;
    case 3: check_means(); break;
    case 4: check_pair_of_two(); break;
    default: check_saca();
    }
}
FUZZ_TARGET(ateb)
