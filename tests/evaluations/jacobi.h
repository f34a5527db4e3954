/* jacobi.h - random evaluations of sn, cn, dn, of their quotients and of their inverses */
#ifndef EVALUATIONS_JACOBI_H
#define EVALUATIONS_JACOBI_H

#include "draws.h"

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
    const vm_real m1 = random_m1(g), K = jacobi_K_m1(m1);
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

/* sn, cn and dn one by one, and what divides by them */
static trial try_reciprocals(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m);
    vm_real sn, cn, dn, u = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = uniform(g, -8, 8) * K;
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        good = !VM_IS_FINITE(u) || u == 0 ||
               (same_size(jacobi_sn(u, m), sn, 16) && same_size(jacobi_cn(u, m), cn, 16) &&
                same_size(jacobi_dn(u, m), dn, 16) && same_size(jacobi_ns(u, m) * sn, 1, 24) &&
                same_size(jacobi_nc(u, m) * cn, 1, 24) && same_size(jacobi_nd(u, m) * dn, 1, 24) &&
                same_size(jacobi_cs(u, m) * sn, cn, 24) && same_size(jacobi_ds(u, m) * sn, dn, 24) &&
                same_size(jacobi_dc(u, m) * cn, dn, 24));
    }
    return result(u, m, 0, good);
}

/* m > 1, where sn has an error of 4 eps/k */
static trial try_large_m(random_bits *g)
{
    const vm_real m = 1 + of_size(g, IS_FLOAT ? -23 : -52, 60), k = VM_SQRT(m), quarter = jacobi_K(1 / m);
    vm_real sn, cn, dn, u = 0;
    int i, good = 1;
    for (i = 0; i < PHASES && good; i++) {
        u = random_phase(g, quarter) / k;
        jacobi_sncndn_any(u, m, &sn, &cn, &dn);
        good = VM_FABS(k * sn) <= 1 + 8 * EPS && VM_FABS(cn) <= 1 && VM_FABS(dn) <= 1 &&
               VM_FABS(cn * cn + sn * sn - 1) <= 16 * EPS && VM_FABS(dn * dn + m * (sn * sn) - 1) <= 24 * EPS;
    }
    return result(u, m, 0, good);
}

/* The arithmetic-geometric mean with all its steps: 6 ulp of K, and 3 eps M (1 + M |u|), M = max(1, k'), of sn, cn, dn */
static trial try_agm(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m), M = m < 0 ? VM_SQRT(1 - m) : 1;
    vm_real sn, cn, dn, s, c, d, u = 0, error;
    int i, good = m == 1 || same_size(jacobi_agm_K(m), K, 12);
    for (i = 0; i < PHASES && good && m < 1; i++) {
        u = uniform(g, -5, 5) * K;
        error = 3 * EPS * M * (1 + M * VM_FABS(u)) + 4 * EPS * M;
        jacobi_agm_sncndn(u, m, 15, &sn, &cn, &dn);
        jacobi_sncndn(u, m, &s, &c, &d);
        good = VM_FABS(sn - s) <= error && VM_FABS(cn - c) <= error && VM_FABS(dn - d) <= error;
    }
    return result(u, m, 0, good);
}

/* Arrays have the same bits as single calls. */
static trial try_jacobi_arrays(random_bits *g)
{
    enum { LENGTH = 64 };
    const vm_real m1 = random_m1(g), K = jacobi_K_m1(m1);
    vm_real u[LENGTH], sn[LENGTH], cn[LENGTH], dn[LENGTH], s, c, d;
    jacobi_plan p;
    int i, good = jacobi_plan_init_m1(&p, m1) == 0;
    for (i = 0; i < LENGTH; i++) u[i] = random_phase(g, K);
    jacobi_plan_sncndn_array(&p, LENGTH, u, sn, cn, dn);
    for (i = 0; i < LENGTH && good; i++) {
        jacobi_plan_sncndn(&p, u[i], &s, &c, &d);
        good = sn[i] == s && cn[i] == c && dn[i] == d && on_curve(s, c, d, m1);
    }
    return result(u[0], m1, 0, good);
}

static trial try_inverse_sn(random_bits *g)
{
    const vm_real m = random_m(g), x = uniform(g, -1, 1), u = jacobi_inverse_sn(x, m), K = jacobi_K(m);
    const vm_real other = jacobi_inverse_cn(VM_FABS(x), m) + jacobi_inverse_sn(0, m);
    return result(x, m, 0, VM_FABS(u) <= K && jacobi_inverse_sn(-x, m) == -u && other >= 0 && other <= K * (1 + 8 * EPS));
}

/* A number between 1 and dn(K) = k' */
static vm_real random_dn(random_bits *g, vm_real m1) { return 1 + (VM_SQRT(m1) - 1) * uniform(g, 0, 0.999); }

/* dn of the inverse is x again, up to the errors of both: dn has the slope -m sn cn. */
static trial try_inverse_dn(random_bits *g)
{
    const vm_real m = random_m(g), top = m < 0 ? VM_SQRT(1 - m) : 1, x = random_dn(g, 1 - m);
    const vm_real u = jacobi_inverse_dn(x, m);
    return result(x, m, 0,
                  u >= 0 && u <= jacobi_K(m) * (1 + 8 * EPS) &&
                      VM_FABS(jacobi_dn(u, m) - x) <= EPS * (8 * top + 8 * u * VM_FABS(m)));
}

/* sn, cn and dn of their inverses. No slope is above 2 where m1 <= 2. */
static trial try_inverses_m1(random_bits *g)
{
    const vm_real m1 = random_m1(g), x = uniform(g, -1, 1), y = random_dn(g, m1), K = jacobi_K_m1(m1);
    const vm_real u = jacobi_inverse_sn_m1(x, m1), v = jacobi_inverse_cn_m1(x, m1), w = jacobi_inverse_dn_m1(y, m1);
    vm_real sn, cn, dn, rest;
    int good = VM_FABS(u) <= K * (1 + 8 * EPS) && v >= 0 && v <= 2 * K * (1 + 8 * EPS) && w >= 0 &&
               w <= K * (1 + 8 * EPS);
    jacobi_sncndn_m1(u, m1, &sn, &rest, &rest);
    good = good && VM_FABS(sn - x) <= EPS * (8 + 16 * VM_FABS(u));
    jacobi_sncndn_m1(v, m1, &rest, &cn, &rest);
    good = good && VM_FABS(cn - x) <= EPS * (8 + 16 * v);
    jacobi_sncndn_m1(w, m1, &rest, &rest, &dn);
    good = good && VM_FABS(dn - y) <= EPS * (8 + 16 * w);
    return result(x, m1, y, good);
}

#endif
