/* The special functions against GSL, each to the accuracy that GSL has there. GSL's sn, cn, dn need |m| <= 1 and lose
   digits with u; its inversion of the incomplete beta function is kept away from the ends and from large alpha. */
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf.h>
#include "../ateb.h"
#include "../jacobi.h"
#include "check.h"

static void test_complete(void)
{
    int i;
    for (i = 0; i < 5000; i++) {
        double m = uniform(0, 1), k = sqrt(m), K = gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE), slope;
        slope = 2 + 1 / (1 - m); /* k is rounded */
        check_error("K", "gsl_sf_ellint_Kcomp", "eps*", ERROR_EPS(jacobi_K(m), K, 0, K * slope), 4, m, 0);
        check_error("E", "gsl_sf_ellint_Ecomp", "eps*",
                    ERROR_EPS(jacobi_E(m), gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE), 0, slope), 8, m, 0);
    }
}

static void test_sncndn(void)
{
    int i;
    for (i = 0; i < 20000; i++) {
        double u = uniform(-10, 10), m = uniform(-1, 1), s, c, d;
        vm_real sn, cn, dn;
        gsl_sf_elljac_e(u, m, &s, &c, &d);
        jacobi_sncndn(u, m, &sn, &cn, &dn);
        check_error("sn", "gsl_sf_elljac_e", "eps", ERROR_EPS(sn, s, 0, 1), 60, u, m);
        check_error("cn", "gsl_sf_elljac_e", "eps", ERROR_EPS(cn, c, 0, 1), 60, u, m);
        check_error("dn", "gsl_sf_elljac_e", "eps", ERROR_EPS(dn, d, 0, 1), 60, u, m);
    }
}

/* s = (Pi_alpha/2) I_(sa^2)(1/2, 1/(alpha+1)) and, from the other end, Pi_alpha/2 - s = (Pi_alpha/2)
   I_x(1/(alpha+1), 1/2) with x = |ca|^(alpha+1); and backwards sa^2 = I^-1(1/2, 1/(alpha+1); 2 s/Pi_alpha) */
static void test_beta(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        double alpha = uniform(0.1, 8), q = 1 / (alpha + 1), half = ateb_pi(alpha) / 2,
               s = half * uniform(0.05, 0.8), w, x;
        vm_real sa, ca;
        ateb_saca(s, alpha, &sa, &ca);
        w = sa * sa;
        x = pow(ca, alpha + 1);
        check_error("Pi_alpha", "gsl_sf_beta", "ulp", ERROR_ULP(2 * half, gsl_sf_beta(q, 0.5), 0), 30, alpha, 0);
        if (w < 0.5)
            check_error("sa^2 -> s", "gsl_sf_beta_inc", "eps",
                        ERROR_EPS(s, half * gsl_sf_beta_inc(0.5, q, w), 0, half), 30, s, alpha);
        else
            check_error("ca^(a+1) -> s", "gsl_sf_beta_inc", "eps",
                        ERROR_EPS(half - s, half * gsl_sf_beta_inc(q, 0.5, x), 0, half), 30, s, alpha);
        check_error("sa^2", "gsl_cdf_beta_Pinv", "eps", ERROR_EPS(w, gsl_cdf_beta_Pinv(s / half, 0.5, q), 0, 1), 60,
                    s, alpha);
    }
}

int main(void)
{
    gsl_set_error_handler_off();
    test_complete();
    test_sncndn();
    test_beta();
    return check_finish("GSL");
}
