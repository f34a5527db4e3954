/* ateb.h - random evaluations of the Ateb functions, of beta functions and of Lambert's W */
#ifndef EVALUATIONS_ATEB_H
#define EVALUATIONS_ATEB_H

#include "draws.h"

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

/* A shorter plan has at most the error that was asked for. */
static trial try_short_plan(random_bits *g)
{
    const vm_real alpha = random_alpha(g), quarter = ateb_pi(alpha) / 2;
    const vm_real accuracy = of_size(g, IS_FLOAT ? -20 : -45, -6), error = accuracy + 6 * EPS;
    vm_real sa, ca, a, c, s = 0;
    ateb_plan p;
    int i, good = ateb_plan_init_to(&p, alpha, accuracy) == 0;
    for (i = 0; i < 256 && good; i++) {
        s = random_phase(g, quarter);
        ateb_plan_saca(&p, s, &sa, &ca);
        ateb_saca(s, alpha, &a, &c);
        good = VM_FABS(sa - a) <= error && VM_FABS(ca - c) <= error;
    }
    return result(s, alpha, accuracy, good);
}

/* Arrays have the same bits as single calls. */
static trial try_ateb_arrays(random_bits *g)
{
    enum { LENGTH = 256 };
    const vm_real alpha = random_alpha(g), quarter = ateb_pi(alpha) / 2;
    vm_real s[LENGTH], sa[LENGTH], ca[LENGTH], a, c;
    ateb_plan p;
    int i, good = ateb_plan_init(&p, alpha) == 0;
    for (i = 0; i < LENGTH; i++) s[i] = random_phase(g, quarter);
    ateb_plan_saca_array(&p, LENGTH, s, sa, ca);
    for (i = 0; i < LENGTH && good; i++) {
        ateb_plan_saca(&p, s[i], &a, &c);
        good = sa[i] == a && ca[i] == c && VM_FABS(a) <= 1 && VM_FABS(c) <= 1;
    }
    return result(s[0], alpha, 0, good);
}

/* Is l the logarithm of x, up to the errors of x and of l? Where x is subnormal, too small or too large this is not asked. */
static int is_ln(vm_real l, vm_real x, double epsilons)
{
    if (!(x > VM_MIN) || !VM_IS_FINITE(x)) return 1;
    return VM_FABS(R(log((double)x)) - l) <= R(epsilons) * EPS * (1 + VM_FABS(l));
}

static trial try_ln_beta(random_bits *g)
{
    const vm_real a = of_size(g, -99, 99), b = of_size(g, -99, 99), l = ateb_ln_beta(a, b);
    return result(a, b, 0,
                  VM_FABS(l - ateb_ln_beta(b, a)) <= EPS * (2 * VM_FABS(l) + R(0.0625)) && is_ln(l, ateb_beta(a, b), 8));
}

static trial try_ln_beta_inc(random_bits *g)
{
    const vm_real a = of_size(g, -9, 13), b = of_size(g, -9, 13), x = uniform(g, 0, 1), p = ateb_beta_inc(x, a, b);
    const vm_real l = ateb_ln_beta_inc(x, a, b);
    return result(a, b, x, p >= 0 && p <= 1 && l <= 0 && is_ln(l, p, 64));
}

static trial try_both_inverses(random_bits *g)
{
    const vm_real a = of_size(g, -9, 13), b = of_size(g, -9, 13), p = of_size(g, -40, 0) / 2;
    vm_real x, y, ln_x;
    ateb_beta_inc_inv_both(p, 1 - p, a, b, &x, &y, &ln_x);
    return result(a, b, p, x >= 0 && y >= 0 && ln_x <= 0 && VM_FABS(x + y - 1) <= 4 * EPS && is_ln(ln_x, x, 32));
}

/* The mean of powers of sa and ca is that of powers of ca and sa with the indices exchanged; it falls with the powers. */
static trial try_mean_nm(random_bits *g)
{
    const vm_real n = of_size(g, -20, 20), m = of_size(g, -20, 20), p = uniform(g, 0, 12), q = uniform(g, 0, 12);
    const vm_real mean = ateb_mean_nm(n, m, p, q, 0);
    return result(n, m, p,
                  mean >= 0 && mean <= 1 + 4 * EPS && same_size(mean, ateb_mean_nm(m, n, q, p, 0), 8) &&
                      ateb_mean_nm(n, m, p + 1, q, 0) <= mean * (1 + 8 * EPS));
}

/* Both branches for -1/e < x < 0: w e^w = x */
static trial try_lambert_branches(random_bits *g)
{
    const vm_real x = R(-0.7) * of_size(g, IS_FLOAT ? -90 : -900, -1), w0 = vm_lambert_w0(x), w = vm_lambert_wm1(x);
    return result(x, 0, 0,
                  w0 < 0 && w0 >= -1 && w <= -1 && same_size(w0 * R(exp((double)w0)), x, 8) &&
                      VM_FABS(w + R(log(-(double)w)) - R(log(-(double)x))) <= 8 * EPS * VM_FABS(w));
}

#endif
