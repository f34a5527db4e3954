/* exact.h - reference values in quadruple precision (exact.c, tests/quad.h) as high and low words, NaN where the
   compiler has no libquadmath; errors against them. */
#ifndef VARMASS_EXACT_H
#define VARMASS_EXACT_H

#include <math.h>

typedef struct exact_value {
    double high, low;
} exact_value;

#ifdef __cplusplus
extern "C" {
#endif
void exact_complete(double m, exact_value K_E[2]);
void exact_sncndn(double u, double m, exact_value sn_cn_dn_am[4]);
void exact_saca(double s, double alpha, exact_value sa_ca_pi[3]);
exact_value exact_beta(double a, double b);
exact_value exact_beta_inc(double x, double a, double b);
double exact_beta_inc_inv(double p, double a, double b, double near_to_it); /* one step of Newton's method */
exact_value exact_ln_beta(double a, double b);
exact_value exact_incomplete(double phi, double m, double n, char which); /* F, E or P for Pi(n; phi | m), m < 1 */
exact_value exact_carlson_rf(double x, double y, double z);
exact_value exact_carlson_rj(double x, double y, double z, double p);
exact_value exact_lambert_w0(double x, double near_to_it); /* two steps of Halley's method */
#ifdef __cplusplus
}
#endif

static inline double error_of(double got, exact_value exact) { return fabs((got - exact.high) - exact.low); }

/* The larger one, NaN being the largest */
static inline double larger(double a, double b) { return !(a >= b) ? b : a; }

#endif
