/* Reference values in quadruple precision for bench programs, which are compiled as C99: the functions of tests/quad.h.
   Without quadruple precision all of them are NaN. */
#include "exact.h"

#ifdef WITH_QUAD
#include "../tests/quad.h"

static exact_value words(quad x)
{
    exact_value value;
    value.high = (double)x;
    value.low = (double)(x - (quad)value.high);
    return value;
}

void exact_complete(double m, exact_value K_E[2])
{
    quad E, K = quarter_period(1 - (quad)m, &E);
    K_E[0] = words(K);
    K_E[1] = words(E);
}

void exact_sncndn(double u, double m, exact_value sn_cn_dn_am[4])
{
    quad sn, cn, dn, E, half_turns = rintq(u / (2 * quarter_period(1 - (quad)m, &E)));
    const int odd = fmodq(half_turns, 2) != 0;
    sncndn(u, 1 - (quad)m, &sn, &cn, &dn);
    sn_cn_dn_am[0] = words(sn);
    sn_cn_dn_am[1] = words(cn);
    sn_cn_dn_am[2] = words(dn);
    sn_cn_dn_am[3] = words(half_turns * M_PIq + atan2q(odd ? -sn : sn, odd ? -cn : cn));
}

void exact_saca(double s, double alpha, exact_value sa_ca_pi[3])
{
    quad sa, ca, pi;
    saca(s, alpha, &sa, &ca, &pi);
    sa_ca_pi[0] = words(sa);
    sa_ca_pi[1] = words(ca);
    sa_ca_pi[2] = words(pi);
}

exact_value exact_beta(double a, double b) { return words(beta(a, b)); }

exact_value exact_beta_inc(double x, double a, double b) { return words(beta_inc(x, a, b)); }

double exact_beta_inc_inv(double p, double a, double b, double x)
{
    const quad density = powq(x, (quad)a - 1) * powq(1 - (quad)x, (quad)b - 1) / beta(a, b);
    return (double)(x - (beta_inc(x, a, b) - p) / density);
}

exact_value exact_ln_beta(double a, double b)
{
    return words(lgammaq((quad)a) + lgammaq((quad)b) - lgammaq((quad)a + (quad)b));
}

exact_value exact_incomplete(double phi, double m, double n, char which)
{
    return words(elliptic_integral(which, phi, n, 1 - (quad)m));
}

exact_value exact_carlson_rf(double x, double y, double z) { return words(carlson_rf(x, y, z)); }

exact_value exact_carlson_rj(double x, double y, double z, double p) { return words(carlson_rj(x, y, z, p)); }

exact_value exact_lambert_w0(double x, double near_to_it)
{
    quad w = near_to_it;
    int i;
    for (i = 0; i < 2; i++) {
        const quad e = expq(w), f = w * e - x;
        w -= f / (e * (w + 1) - (w + 2) * f / (2 * w + 2));
    }
    return words(w);
}

#else
static const exact_value none = {(double)NAN, 0};

void exact_complete(double m, exact_value K_E[2])
{
    (void)m;
    K_E[0] = K_E[1] = none;
}

void exact_sncndn(double u, double m, exact_value sn_cn_dn_am[4])
{
    (void)u;
    (void)m;
    sn_cn_dn_am[0] = sn_cn_dn_am[1] = sn_cn_dn_am[2] = sn_cn_dn_am[3] = none;
}

void exact_saca(double s, double alpha, exact_value sa_ca_pi[3])
{
    (void)s;
    (void)alpha;
    sa_ca_pi[0] = sa_ca_pi[1] = sa_ca_pi[2] = none;
}

exact_value exact_beta(double a, double b)
{
    (void)a;
    (void)b;
    return none;
}

exact_value exact_beta_inc(double x, double a, double b)
{
    (void)x;
    (void)a;
    (void)b;
    return none;
}

double exact_beta_inc_inv(double p, double a, double b, double x) { return p + a + b + x + none.high; }

exact_value exact_ln_beta(double a, double b) { return exact_beta(a, b); }

exact_value exact_incomplete(double phi, double m, double n, char which)
{
    (void)which;
    return exact_beta_inc(phi, m, n);
}

exact_value exact_carlson_rf(double x, double y, double z) { return exact_beta_inc(x, y, z); }

exact_value exact_carlson_rj(double x, double y, double z, double p) { return exact_beta_inc(x + p, y, z); }

exact_value exact_lambert_w0(double x, double near_to_it) { return exact_beta(x, near_to_it); }
#endif
