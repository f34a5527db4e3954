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

/* ---- Elliptic integrals: Carlson's R_F and R_J with his series of degree 5, after more duplications than the headers
   make, in the sums that DLMF 19.25 gives ---- */

static inline quad largest_of(quad a, quad b, quad c, quad d)
{
    return fmaxq(fmaxq(fabsq(a), fabsq(b)), fmaxq(fabsq(c), fabsq(d)));
}

static inline quad carlson_rf(quad x, quad y, quad z)
{
    for (;;) {
        quad mean = (x + y + z) / 3, X = 1 - x / mean, Y = 1 - y / mean, Z = -(X + Y);
        quad a = sqrtq(x), b = sqrtq(y), c = sqrtq(z), lambda = a * b + b * c + c * a;
        if (!(largest_of(X, Y, Z, 0) >= 1e-6Q)) {
            quad E2 = X * Y - Z * Z, E3 = X * Y * Z;
            return (1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44) / sqrtq(mean);
        }
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
    }
}

/* R_C(1, 1 + e) */
static inline quad carlson_rc(quad e)
{
    quad r = sqrtq(fabsq(e));
    if (r < 1e-4Q) return 1 - e / 3 + e * e / 5 - e * e * e / 7 + e * e * e * e / 9;
    return e > 0 ? atanq(r) / r : (log1pq(r) - log1pq(-r)) / (2 * r);
}

static inline quad carlson_rj(quad x, quad y, quad z, quad p)
{
    quad sum = 0, power = 1;
    for (;;) {
        quad mean = (x + y + z + 2 * p) / 5, X = 1 - x / mean, Y = 1 - y / mean, Z = 1 - z / mean, P = -(X + Y + Z) / 2;
        quad a = sqrtq(x), b = sqrtq(y), c = sqrtq(z), r = sqrtq(p), lambda = a * b + b * c + c * a;
        quad d = (r + a) * (r + b) * (r + c);
        if (!(largest_of(X, Y, Z, P) >= 1e-6Q)) {
            quad E2 = X * Y + X * Z + Y * Z - 3 * P * P, E3 = X * Y * Z + 2 * E2 * P + 4 * P * P * P;
            quad E4 = (2 * X * Y * Z + E2 * P + 3 * P * P * P) * P, E5 = X * Y * Z * P * P;
            quad series = 1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 + 3 * E5 / 26;
            return 6 * sum + power * series / (mean * sqrtq(mean));
        }
        sum += power / d * carlson_rc((r - a) * (r - b) * (r - c) / d);
        power /= 4;
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
        p = (p + lambda) / 4;
    }
}

/* F, E, D or Pi(n; .. | m) of the angle whose sine is s and whose cosine is c >= 0, for 1 - m = m1 and n < 1 */
static inline quad elliptic_part(char kind, quad s, quad c, quad n, quad m1)
{
    quad ss = s * s, cc = c * c, d = cc + m1 * ss;
    if (kind == 'F') return s * carlson_rf(cc, d, 1);
    if (kind == 'E') return s * (carlson_rf(cc, d, 1) - (1 - m1) * ss * carlson_rj(cc, d, 1, 1) / 3);
    if (kind == 'D') return s * ss * carlson_rj(cc, d, 1, 1) / 3;
    return s * (carlson_rf(cc, d, 1) + n * ss * carlson_rj(cc, d, 1, cc + (1 - n) * ss) / 3);
}

static inline quad elliptic_integral(char kind, quad phi, quad n, quad m1)
{
    quad turns = rintq(phi / M_PIq), rest = phi - turns * M_PIq;
    quad part = elliptic_part(kind, sinq(rest), cosq(rest), n, m1);
    return turns == 0 ? part : part + 2 * turns * elliptic_part(kind, 1, 0, n, m1);
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
