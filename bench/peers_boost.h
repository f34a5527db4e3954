// peers_boost.h - Boost.Math's functions under the name `policy` of the namespace that includes this file; peers.cpp
// includes it once for each policy.
static inline void boost_jacobi(double x, double, double b, double *r)
{
    r[0] = boost::math::jacobi_elliptic(b, x, r + 1, r + 2, policy());
}
static inline void boost_K(double, double, double b, double *r) { *r = boost::math::ellint_1(b, policy()); }
static inline void boost_E(double, double, double b, double *r) { *r = boost::math::ellint_2(b, policy()); }
static inline void boost_F(double x, double, double b, double *r) { *r = boost::math::ellint_1(b, x, policy()); }
static inline void boost_Einc(double x, double, double b, double *r) { *r = boost::math::ellint_2(b, x, policy()); }
static inline void boost_Pi(double x, double, double b, double *r) { *r = boost::math::ellint_3(b, 0.25, x, policy()); }
static inline void boost_RF(double, double a, double b, double *r) { *r = boost::math::ellint_rf(1., a, b, policy()); }
static inline void boost_RJ(double, double a, double b, double *r) { *r = boost::math::ellint_rj(1., a, b, 0.75, policy()); }
static inline void boost_inc(double x, double a, double b, double *r) { *r = boost::math::ibeta(a, b, x, policy()); }
static inline void boost_inv(double x, double a, double b, double *r) { *r = boost::math::ibeta_inv(a, b, x, policy()); }
static inline void boost_B(double, double a, double b, double *r) { *r = boost::math::beta(a, b, policy()); }
static inline void boost_w0(double x, double, double, double *r) { *r = boost::math::lambert_w0(x, policy()); }
