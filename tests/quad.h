/* quad.h - the functions of jacobi.h and ateb.h in quadruple precision (gcc with libquadmath, -std=gnu99), by other
   methods than the headers': what make scan and the bench programs measure errors against. */
#ifndef QUAD_H
#define QUAD_H

#include <quadmath.h>

typedef __float128 quad;

/* ---- Jacobi: the AGM and Gauss' transformation ---- */

static inline quad quarter_period(quad m1, quad *E)
{
    quad a = 1, b = sqrtq(m1), sum = (1 - m1) / 2, power = 0.5Q, K;
    while (fabsq(a - b) > 1e-33Q * a) {
        quad c = (a - b) / 2;
        power *= 2;
        sum += power * c * c;
        c = sqrtq(a * b);
        a = (a + b) / 2;
        b = c;
    }
    K = M_PI_2q / a;
    *E = K * (1 - sum);
    return K;
}

static inline void sncndn(quad u, quad m1, quad *sn, quad *cn, quad *dn)
{
    quad a[40], b[40], turns, s, c, d = 1, q = 1, K;
    int n = 0;
    a[0] = 1;
    b[0] = sqrtq(m1);
    for (; fabsq(a[n] - b[n]) > 1e-33Q * a[n] && n < 38; n++) {
        a[n + 1] = (a[n] + b[n]) / 2;
        b[n + 1] = sqrtq(a[n] * b[n]);
    }
    K = M_PI_2q / a[n];
    turns = rintq(u / (2 * K));
    u -= 2 * K * turns;
    s = sinq(a[n] * u);
    c = cosq(a[n] * u);
    for (n--; n >= 0; n--) {
        quad ra = a[n] / a[n + 1], rb = b[n] / a[n + 1], ss = s * s, cc = c * c;
        s *= ra * q;
        c *= d;
        d = cc + rb * ss;
        q = cc + ra * ss;
    }
    if (fmodq(turns, 2) != 0) {
        s = -s;
        c = -c;
    }
    *sn = s / q;
    *cn = c / q;
    *dn = d / q;
}

/* ---- Ateb: the two series of ateb.h, Newton's method; unknown v = sa, or z = -ln |ca|^(alpha+1) ---- */

static inline quad series_w(quad w, quad k)
{
    quad power = 1, sum = 1;
    int n;
    for (n = 0; n < 400 && fabsq(power) > 1e-36Q; n++) {
        power *= w * (k + n) / (n + 1);
        sum += power / (2 * n + 3);
    }
    return sum;
}

static inline quad series_p(quad p, quad q)
{
    quad term = 1, sum = 1;
    int n;
    for (n = 0; n < 400 && term > 1e-36Q; n++) {
        term *= p * (2 * q + n) / (1 + q + n);
        sum += term;
    }
    return sum;
}

static inline void saca(quad s, quad alpha, quad *sa, quad *ca, quad *pi)
{
    quad q = 1 / (1 + alpha), f = sqrtq(M_PIq) * tgammaq(1 + q) / tgammaq(q + 0.5Q), half = f / q / 2, j, rest, r,
         d, v, u;
    int i, quarter, odd;
    *pi = 2 * half;
    j = rintq(fabsq(s) / half);
    rest = fabsq(s) - j * half;
    quarter = (int)fmodq(j, 4);
    odd = quarter & 1;
    r = odd ? half - fabsq(rest) : fabsq(rest);
    d = odd ? fabsq(rest) : half - fabsq(rest);
    if (r < 0.6Q) {
        for (v = r * (1 - (1 - q) * r * r / 3), i = 0; i < 12; i++)
            v += (r - v * series_w(v * v, 1 - q)) * powq(1 - v * v, 1 - q);
        u = powq(1 - v * v, q);
    } else {
        quad y = 2 * q * d, z = d > 0 ? fmaxq(-logq(y) / q, 0.5Q) : 1000;
        for (i = 0; i < 12 && z < 200; i++) {
            quad S;
            v = sqrtq(-expm1q(-z));
            S = series_p(expq(-z) / (2 * (1 + v)), q);
            z += v * S * (-q * z + logq(S) - logq(y)) / q;
        }
        v = sqrtq(-expm1q(-z));
        u = z < 200 ? expq(-q * z) : y;
    }
    if (odd) u = rest > 0 ? -u : u;
    else v = rest < 0 ? -v : v;
    if (quarter & 2) {
        v = -v;
        u = -u;
    }
    *sa = s < 0 ? -v : v;
    *ca = u;
}

/* ---- The incomplete beta function, 0 < x < 1: DLMF 8.17.8, of the smaller of x and 1 - x ---- */

static inline quad beta(quad a, quad b) { return expq(lgammaq(a) + lgammaq(b) - lgammaq(a + b)); }

static inline quad beta_inc(quad x, quad a, quad b)
{
    quad term = powq(x, a) * powq(1 - x, b) / (a * beta(a, b)), sum = term;
    int n;
    if (x > 0.5Q) return 1 - beta_inc(1 - x, b, a);
    for (n = 1; n < 4000 && term > 1e-34Q * sum; n++) {
        term *= x * (a + b + n - 1) / (a + n);
        sum += term;
    }
    return sum;
}
#endif
