/* Random evaluations of every special function, by the thousand million. They check ranges, symmetries, identities within
   the promised bounds, that neighbours are in order, and inverses. bench/evaluations.sh runs this program for each row of
   docs/evaluations.md. The first violations go to stderr with their inputs.

   usage: evaluations COUNT SEED ROW   COUNT evaluations of the functions of this row, counted from 1, or COUNT/10 if they
                                       are slow; prints NAME|EVALUATIONS|VIOLATIONS. With -fopenmp on all cores.
          evaluations rows             how many rows there are */
#include "../varmass.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EPS VM_EPSILON
#define R(x) ((vm_real)(x))
enum { IS_FLOAT = VM_MANT_DIG == 24, BLOCK = 1 << 11, PHASES = 8 }; /* PHASES arguments for each parameter that is drawn */

typedef struct random_bits {
    uint64_t state;
} random_bits;

static uint64_t next_bits(random_bits *g) /* Steele's splitmix64 */
{
    uint64_t z = g->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static vm_real uniform(random_bits *g, double low, double high)
{
    return R(low + (high - low) * ((double)(next_bits(g) >> 11) / 9007199254740992.0));
}

/* 2^from to 2^to, of any mantissa */
static vm_real of_size(random_bits *g, int from, int to)
{
    const uint64_t bits = next_bits(g);
    const int k = from + (int)(bits % (uint64_t)(to - from));
    return vmi_ldexp(1 + R((double)(bits >> 12) / 4503599627370496.0), k);
}

/* m: half within 0 .. 1, some next to 1, some below 0, to -2^100 */
static vm_real random_m(random_bits *g)
{
    switch (next_bits(g) & 7) {
    case 0: return 1 - of_size(g, IS_FLOAT ? -23 : -52, 0);
    case 1: return -of_size(g, -30, IS_FLOAT ? 60 : 300);
    case 2:
    case 3: return uniform(g, -20, 1);
    default: return uniform(g, 0, 1);
    }
}

static vm_real random_alpha(random_bits *g)
{
    switch (next_bits(g) & 3) {
    case 0: return R(next_bits(g) % 17) / 2;
    case 1: return of_size(g, -20, 20);
    default: return uniform(g, 0, 8);
    }
}

/* Mostly within some periods; now and then up to 1e9 and 1e9 quarters (float 1e4, 2^17), as far as bounds are promised */
static vm_real random_phase(random_bits *g, vm_real quarter)
{
    const vm_real far1 = IS_FLOAT ? R(1e4) : R(1e9), far2 = (IS_FLOAT ? R(131072.) : R(1e9)) * quarter;
    const vm_real far = far2 < far1 ? far2 : far1;
    if ((next_bits(g) & 7) == 0) return uniform(g, -1, 1) * far;
    if (!VM_IS_FINITE(quarter) || quarter > far / 8) quarter = far / 8;
    return uniform(g, -8, 8) * quarter;
}

static vm_real next_up(vm_real x) /* x > 0 finite */ { return vmi_from_bits(vmi_to_bits(x) + 1); }

typedef struct trial {
    vm_real x, y, z; /* what was drawn */
    int good;
} trial;

static trial result(vm_real x, vm_real y, vm_real z, int good)
{
    trial t;
    t.x = x;
    t.y = y;
    t.z = z;
    t.good = good;
    return t;
}

/* The number to which an error of x is compared: subnormal numbers have the spacing of the smallest normal one. */
static vm_real size_of(vm_real x) { return VM_FABS(x) > VM_MIN ? VM_FABS(x) : VM_MIN; }

/* Are a and b the same, up to so many eps of the larger? */
static int same_size(vm_real a, vm_real b, double epsilons)
{
    const vm_real size = size_of(VM_FABS(a) > VM_FABS(b) ? a : b);
    return VM_FABS(a - b) <= R(epsilons) * EPS * size;
}

/* sn and cn have an absolute error of 4 eps and dn one of 4 eps max(1, k'), which makes 12 eps in sums of squares. */
static int on_curve(vm_real sn, vm_real cn, vm_real dn, vm_real m1)
{
    const vm_real top = m1 > 1 ? m1 : 1, kp = VM_SQRT(m1), low = kp < 1 ? kp : 1, high = kp < 1 ? 1 : kp;
    return VM_FABS(sn) <= 1 && VM_FABS(cn) <= 1 && dn >= low * (1 - 2 * EPS) && dn <= high * (1 + 2 * EPS) &&
           VM_FABS(sn * sn + cn * cn - 1) <= 14 * EPS &&
           VM_FABS(dn * dn - cn * cn - m1 * (sn * sn)) <= 28 * EPS * top;
}

static trial try_sncndn(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m);
    vm_real sn, cn, dn, s, c, d, u = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = random_phase(g, K);
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        jacobi_sncndn(-u, m, &s, &c, &d);
        good = on_curve(sn, cn, dn, 1 - m) && s == -sn && c == cn && d == dn;
    }
    return result(u, m, 0, good);
}

static trial try_sncndn_m1(random_bits *g)
{
    const vm_real m1 = of_size(g, IS_FLOAT ? -100 : -1000, 1), K = jacobi_K_m1(m1);
    vm_real sn, cn, dn, u = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = uniform(g, -3, 3) * K;
        jacobi_sncndn_m1(u, m1, &sn, &cn, &dn);
        good = on_curve(sn, cn, dn, m1);
    }
    return result(u, m1, 0, good);
}

/* sn rises between neighbours up to K, but for 8 ulp on either side */
static trial try_sn_rises(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m), top = VM_IS_FINITE(K) ? K : 10;
    vm_real a, b, u = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = uniform(g, 0, 0.999) * top;
        a = jacobi_sn(u, m);
        b = jacobi_sn(next_up(u), m);
        good = u == 0 || (b >= a * (1 - 16 * EPS) && a >= 0 && b <= 1);
    }
    return result(u, m, 0, good);
}

static trial try_quotients(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m);
    vm_real sn, cn, dn, u = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = uniform(g, -8, 8) * K;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        good = !VM_IS_FINITE(u) ||
               (same_size(jacobi_cd(u, m) * dn, cn, 24) && same_size(jacobi_sd(u, m) * dn, sn, 24) &&
                same_size(jacobi_sc(u, m) * cn, sn, 24));
    }
    return result(u, m, 0, good);
}

static trial try_jacobi_plan(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m), top = m < 0 ? VM_SQRT(1 - m) : 1;
    vm_real sn, cn, dn, s, c, d, u = 0;
    jacobi_plan p;
    int i, good = jacobi_plan_init(&p, m) == 0;
    for (i = 0; i < 64 && good; i++) {
        u = random_phase(g, K);
        jacobi_plan_sncndn(&p, u, &sn, &cn, &dn);
        jacobi_sncndn(u, m, &s, &c, &d);
        good = on_curve(sn, cn, dn, 1 - m) && VM_FABS(sn - s) <= 8 * EPS && VM_FABS(cn - c) <= 8 * EPS &&
               VM_FABS(dn - d) <= 8 * EPS * top;
    }
    return result(u, m, 0, good);
}

static trial try_am(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m), top = 8 * (VM_IS_FINITE(K) ? K : 10);
    vm_real u = 0, am;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = uniform(g, 0, 1) * top;
        am = jacobi_am(u, m);
        good = u == 0 || (jacobi_am(next_up(u), m) >= am * (1 - 4 * EPS) && jacobi_am(-u, m) == -am);
    }
    return result(u, m, 0, good);
}

static trial try_K(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m),
                  below = jacobi_K(m > 0 ? vmi_from_bits(vmi_to_bits(m) - 1) : m * (1 + EPS));
    return result(m, 0, 0,
                  m == 1 ? K > VM_MAX
                         : K > 0 && below <= K * (1 + 4 * EPS) && same_size(jacobi_kpK(m), VM_SQRT(1 - m) * K, 8));
}

static trial try_E(random_bits *g)
{
    const vm_real m = random_m(g), E = jacobi_E(m),
                  below = jacobi_E(m > 0 ? vmi_from_bits(vmi_to_bits(m) - 1) : m * (1 + EPS));
    return result(m, 0, 0, E >= 1 && below >= E * (1 - 4 * EPS));
}

static trial try_legendre(random_bits *g) /* E K' + E' K - K K' = pi/2 */
{
    const vm_real m = uniform(g, 1e-9, 1 - 1e-7), K = jacobi_K(m), E = jacobi_E(m), K1 = jacobi_K_m1(m),
                  E1 = jacobi_E_m1(m);
    return result(m, 0, 0, VM_FABS(E * K1 + E1 * K - K * K1 - VM_PI / 2) <= 6 * EPS * (E * K1 + E1 * K + K * K1));
}

/* F and E between their neighbours, and F E >= phi^2 (Schwarz) */
static trial try_incomplete(random_bits *g)
{
    const vm_real m = random_m(g), phi = random_phase(g, R(1.5707963267948966));
    const vm_real x = VM_FABS(phi), F = jacobi_F(x, m), E = jacobi_E_incomplete(x, m);
    return result(phi, m, 0,
                  jacobi_F(-x, m) == -F && jacobi_E_incomplete(-x, m) == -E &&
                      (m > 0 ? E <= F * (1 + 16 * EPS) : F <= E * (1 + 16 * EPS)) &&
                      (x == 0 || (jacobi_F(next_up(x), m) >= F * (1 - 16 * EPS) && F * (E / x) >= x * (1 - 32 * EPS))));
}

/* Pi lies between F and F/(1 - n) */
static trial try_Pi(random_bits *g)
{
    const vm_real m = random_m(g), n = 1 - of_size(g, -10, 20), x = VM_FABS(random_phase(g, R(1.5707963267948966)));
    const vm_real F = jacobi_F(x, m), P = jacobi_Pi_incomplete(x, n, m), bound = F / (1 - n);
    return result(x, n, m,
                  n < 0 ? P <= F * (1 + 20 * EPS) && P >= bound * (1 - 20 * EPS)
                        : P >= F * (1 - 20 * EPS) && P <= bound * (1 + 20 * EPS));
}

static trial try_inverse_sn(random_bits *g)
{
    const vm_real m = random_m(g), x = uniform(g, -1, 1), u = jacobi_inverse_sn(x, m), K = jacobi_K(m);
    const vm_real other = jacobi_inverse_cn(VM_FABS(x), m) + jacobi_inverse_sn(0, m);
    return result(x, m, 0, VM_FABS(u) <= K * (1 + 8 * EPS) && jacobi_inverse_sn(-x, m) == -u && other >= 0 &&
                      other <= K * (1 + 8 * EPS));
}

static trial try_carlson(random_bits *g)
{
    const vm_real x = of_size(g, -20, 20), y = of_size(g, -20, 20), z = of_size(g, -20, 20);
    const vm_real D = jacobi_RD(x, y, z), F = jacobi_RF(x, y, z);
    return result(x, y, z,
                  same_size(jacobi_RJ(x, y, z, z), D, 24) && same_size(jacobi_RF(z, x, y), F, 16) &&
                      F * jacobi_RG(x, y, z) >= 1 - 32 * EPS && same_size(jacobi_RF(x, y, y), jacobi_RC(x, y), 16));
}

static trial try_solve_kpK(random_bits *g)
{
    const vm_real c = of_size(g, -5, 5), m1 = jacobi_solve_kpK_m1(c);
    return result(c, 0, 0, m1 < VM_MIN || m1 > VM_MAX / 4 || same_size(VM_SQRT(m1) * jacobi_K_m1(m1), c, 12));
}

static trial try_solve_K(random_bits *g)
{
    const vm_real c = of_size(g, -5, 5), m1 = jacobi_solve_K_m1(c);
    return result(c, 0, 0, m1 < VM_MIN || m1 > VM_MAX / 4 || same_size(jacobi_K_m1(m1), c, 12));
}

static trial try_cn_means(random_bits *g)
{
    const vm_real m = random_m(g);
    vm_real C2, C4, C6;
    jacobi_cn_means(m, &C2, &C4, &C6);
    return result(m, 0, 0,
                  m == 1 || (C2 <= 1 && C4 <= C2 * (1 + 16 * EPS) && C6 <= C4 * (1 + 16 * EPS) && C6 > 0 &&
                             C4 >= C2 * C2 * (1 - 24 * EPS)));
}

static trial try_saca(random_bits *g)
{
    const vm_real alpha = random_alpha(g), quarter = ateb_pi(alpha) / 2, n = alpha + 1;
    vm_real sa, ca, sa2, ca2, x, s = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        s = random_phase(g, quarter);
        ateb_saca(s, alpha, &sa, &ca);
        ateb_saca(-s, alpha, &sa2, &ca2);
        x = vmi_pow_checked(VM_FABS(ca), n);
        good = VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1 && sa2 == -sa && ca2 == ca &&
               (n * EPS > R(1e-3) ||
                VM_FABS(sa * sa + x - 1) <= EPS * (4 + 4 * (2 * sa * sa + n * x) + (alpha + 1 - n != 0)));
    }
    return result(s, alpha, 0, good);
}

static trial try_saca_rises(random_bits *g)
{
    const vm_real alpha = random_alpha(g), pi = ateb_pi(alpha);
    vm_real s = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        s = uniform(g, 0, 0.499) * pi;
        good = s == 0 || (ateb_sa(next_up(s), alpha) >= ateb_sa(s, alpha) * (1 - 4 * EPS) &&
                          ateb_ca(next_up(s), alpha) <= ateb_ca(s, alpha) * (1 + 4 * EPS));
    }
    return result(s, alpha, 0, good);
}

static trial try_ateb_plan(random_bits *g)
{
    const vm_real alpha = random_alpha(g), quarter = ateb_pi(alpha) / 2;
    vm_real sa, ca, a, c, s = 0;
    ateb_plan p;
    int i, good = ateb_plan_init(&p, alpha) == 0;
    for (i = 0; i < 256 && good; i++) {
        s = random_phase(g, quarter);
        ateb_plan_saca(&p, s, &sa, &ca);
        ateb_saca(s, alpha, &a, &c);
        good = VM_FABS(sa - a) <= 6 * EPS && VM_FABS(ca - c) <= 6 * EPS && VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1;
    }
    return result(s, alpha, 0, good);
}

static trial try_pi(random_bits *g)
{
    const vm_real alpha = random_alpha(g), pi = ateb_pi(alpha);
    return result(alpha, 0, 0,
                  pi >= (alpha + 1) * (1 - EPS) && pi <= (alpha + 1 + R(1.3862943611198906)) * (1 + EPS) &&
                      (alpha == 0 || ateb_pi(next_up(alpha)) >= pi * (1 - EPS)));
}

static trial try_phase(random_bits *g)
{
    const vm_real alpha = random_alpha(g), pi = ateb_pi(alpha);
    vm_real sa, ca, s = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        s = uniform(g, -0.999, 0.999) * pi;
        ateb_saca(s, alpha, &sa, &ca); /* 4 ulp, and what 4 ulp of sa and ca move */
        good = VM_FABS(ateb_phase(sa, ca, alpha) - s) <=
                   EPS * (8 * VM_FABS(s) + 4 * VM_FABS(sa * ca) * (1 + (alpha + 1) / 2)) ||
               VM_FABS(ca) < R(1e-3);
    }
    return result(s, alpha, 0, good);
}

static trial try_integrals(random_bits *g)
{
    const vm_real alpha = random_alpha(g), pi = ateb_pi(alpha);
    vm_real a, b, s = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        s = uniform(g, 0, 2) * pi;
        a = ateb_integral_sa2(s, alpha);
        b = ateb_integral_ca(s, alpha);
        good = a >= 0 && b >= 0 && VM_FABS(a + b - s) <= 32 * EPS * s;
    }
    return result(s, alpha, 0, good);
}

static trial try_beta(random_bits *g)
{
    const vm_real a = of_size(g, -9, 13), b = of_size(g, -9, 13), B = ateb_beta(a, b);
    return result(a, b, 0, B >= 0 && same_size(B, ateb_beta(b, a), 4));
}

static trial try_beta_inc(random_bits *g)
{
    const vm_real a = of_size(g, -9, 13), b = of_size(g, -9, 13), x = uniform(g, 0, 1);
    vm_real p, q, p2, q2;
    ateb_beta_inc_both(x, 1 - x, a, b, &p, &q);
    ateb_beta_inc_both(1 - x, x, b, a, &p2, &q2);
    return result(a, b, x,
                  p >= 0 && p <= 1 && q >= 0 && q <= 1 && VM_FABS(p + q - 1) <= 64 * EPS && same_size(p, q2, 64) &&
                      same_size(q, p2, 64));
}

static trial try_beta_inverse(random_bits *g)
{
    const vm_real a = of_size(g, -9, 13), b = of_size(g, -9, 13), p = uniform(g, 0, 1);
    const vm_real x = ateb_beta_inc_inv(p, a, b), next = p > 0 ? ateb_beta_inc_inv(next_up(p), a, b) : x;
    return result(a, b, p, x >= 0 && x <= 1 && (p >= 1 || next >= x - 64 * EPS * size_of(x)));
}

static trial try_saca_nm(random_bits *g)
{
    const vm_real n = of_size(g, -9, 9), m = of_size(g, -9, 9), s = uniform(g, -4, 4) * ateb_pi_nm(n, m);
    vm_real sa, ca, x, y;
    ateb_saca_nm(s, n, m, &sa, &ca);
    x = vmi_pow_checked(VM_FABS(sa), n + 1);
    y = vmi_pow_checked(VM_FABS(ca), m + 1);
    return result(n, m, s,
                  VM_FABS(sa) <= 1 && VM_FABS(ca) <= 1 &&
                      VM_FABS(x + y - 1) <= EPS * (8 + 10 * ((n + 1) * x + (m + 1) * y)));
}

static trial try_mean(random_bits *g)
{
    const vm_real alpha = random_alpha(g), p = uniform(g, 0, 12), q = uniform(g, 0, 12),
                  mean = ateb_mean(alpha, p, q);
    return result(alpha, p, q,
                  mean >= 0 && mean <= 1 + 4 * EPS && ateb_mean(alpha, p + 1, q) <= mean * (1 + 8 * EPS));
}

static trial try_lambert(random_bits *g)
{
    const vm_real l = uniform(g, -60, 60), w = vm_wright_omega(l), x = of_size(g, -20, 30), w0 = vm_lambert_w0(x);
    const vm_real m = -1 - of_size(g, -20, 9), a = vm_lambert_w0_neg_exp(m), b = vm_lambert_wm1_neg_exp(m);
    return result(
        l, x, m,
        w > 0 && vm_wright_omega(l + R(0.001)) >= w && w0 > 0 &&
            vm_lambert_w0(next_up(x)) >= w0 * (1 - 2 * EPS) &&
            same_size(vmi_log(w0).hi + w0, vmi_log(x).hi, 8 + 8 / (double)(VM_FABS(vmi_log(x).hi) + EPS)) &&
            a <= 0 && a >= -1 && b <= -1);
}

typedef struct job {
    const char *name;
    trial (*run)(random_bits *g);
    int evaluations; /* of the function in one trial */
    int slower;      /* how many times fewer trials a slow function gets */
} job;

static const job jobs[] = {{"sn, cn, dn", try_sncndn, 2 * PHASES, 1},
                           {"sn, cn, dn, m1", try_sncndn_m1, PHASES, 1},
                           {"sn rises", try_sn_rises, 2 * PHASES, 1},
                           {"cd, sd, sc", try_quotients, 3 * PHASES, 1},
                           {"jacobi_plan", try_jacobi_plan, 64, 1},
                           {"am", try_am, 3 * PHASES, 1},
                           {"K, k'K", try_K, 2, 1},
                           {"E", try_E, 2, 1},
                           {"K, E, Legendre", try_legendre, 4, 1},
                           {"F, E, incomplete", try_incomplete, 5, 1},
                           {"Pi, incomplete", try_Pi, 2, 1},
                           {"inverse sn, cn", try_inverse_sn, 4, 1},
                           {"R_F, R_C, R_D, R_J, R_G", try_carlson, 6, 1},
                           {"solve k'K", try_solve_kpK, 1, 1},
                           {"solve K", try_solve_K, 1, 1},
                           {"cn means", try_cn_means, 1, 1},
                           {"sa, ca", try_saca, 2 * PHASES, 1},
                           {"sa, ca monotone", try_saca_rises, 4 * PHASES, 1},
                           {"ateb_plan", try_ateb_plan, 256, 1},
                           {"Pi_alpha", try_pi, 2, 1},
                           {"ateb_phase", try_phase, PHASES, 1},
                           {"ateb integrals", try_integrals, 2 * PHASES, 1},
                           {"beta", try_beta, 2, 1},
                           {"beta_inc", try_beta_inc, 2, 1},
                           {"beta_inc_inv", try_beta_inverse, 2, 10},
                           {"sa, ca (n, m)", try_saca_nm, 1, 10},
                           {"ateb_mean", try_mean, 2, 1},
                           {"Lambert W", try_lambert, 6, 1}};

static long run(const job *j, int number, double count, uint64_t seed)
{
    const long blocks = (long)(count / j->slower / j->evaluations / BLOCK) + 1;
    long violations = 0, done = 0, b;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic) reduction(+ : violations)
#endif
    for (b = 0; b < blocks; b++) {
        random_bits g;
        long i;
        g.state = (seed << 40) ^ ((uint64_t)number << 32) ^ (uint64_t)b * UINT64_C(0xd1342543de82ef95);
        for (i = 0; i < BLOCK; i++) {
            const trial t = j->run(&g);
            if (t.good) continue;
            violations++;
            if (violations <= 3)
                fprintf(stderr, "VIOLATED %s: %.17g %.17g %.17g\n", j->name, (double)t.x, (double)t.y, (double)t.z);
        }
#ifdef _OPENMP
#pragma omp atomic
#endif
        done++;
        if (b % 64 == 0) fprintf(stderr, "%-16s %3.0f %%\r", j->name, 100. * (double)done / (double)blocks);
    }
    printf("%s|%.0f|%ld\n", j->name, (double)blocks * BLOCK * j->evaluations, violations);
    return violations;
}

int main(int argc, char **argv)
{
    const int rows = (int)(sizeof jobs / sizeof *jobs), row = argc == 4 ? atoi(argv[3]) : 0;
    if (argc == 2 && strcmp(argv[1], "rows") == 0) {
        printf("%d\n", rows);
        return 0;
    }
    if (row < 1 || row > rows) {
        fprintf(stderr, "usage: evaluations COUNT SEED ROW, with ROW from 1 to %d\n", rows);
        return 2;
    }
    return run(jobs + row - 1, row - 1, strtod(argv[1], NULL), (uint64_t)strtol(argv[2], NULL, 10)) != 0;
}
