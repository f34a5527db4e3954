/* rk_loops.h - the yardsticks of bench_integrators.c: RK4 and Dormand-Prince 5(4) written into one loop for one
   right-hand side, as a user would by hand who needs neither events nor dense output nor a status.

   With F(t, y, dydt) inlinable,
     RK4_LOOP_OF(name, n, F)    defines static void name_rk4_loop(double T, long steps, double *y);
     DP54_LOOP_OF(name, n, F)   defines static void name_dp54_loop(double T, double tol, double *y);  first step 1e-3
   dp54: first same as last, h folded into the coefficients, the newest stage last in every sum, error over
   tol + tol (|y| + |h k1|) in the maximum norm, h kept while 0.5 < error <= 1, else 0.9 error^(-1/5) times as long. */
#ifndef RK_LOOPS_H
#define RK_LOOPS_H

#include <math.h>
#include <string.h>

/* x^(-1/5) to 0.4 % */
static inline double rk_loops_root5(double x)
{
    long long i;
    double r;
    memcpy(&i, &x, 8);
    i = 0x4CB8800000000000ll - i / 5;
    memcpy(&r, &i, 8);
    return r * (1.2 - 0.2 * x * r * r * r * r * r);
}

#define RK_EACH(n, ...)                            \
    do {                                           \
        int i;                                     \
        for (i = 0; i < (n); i++) { __VA_ARGS__; } \
    } while (0)

#define RK4_LOOP_OF(name, n, F)                                                                         \
    static void name##_rk4_loop(double T, long steps, double *y)                                        \
    {                                                                                                   \
        double h = T / (double)steps, h2 = h / 2, h6 = h / 6, h3 = h / 3, a[n], b[n], c[n], d[n], z[n]; \
        long s;                                                                                         \
        for (s = 0; s < steps; s++) {                                                                   \
            double t = h * (double)s;                                                                   \
            F(t, y, a);                                                                                 \
            RK_EACH(n, z[i] = y[i] + h2 * a[i]);                                                        \
            F(t + h2, z, b);                                                                            \
            RK_EACH(n, z[i] = y[i] + h2 * b[i]);                                                        \
            F(t + h2, z, c);                                                                            \
            RK_EACH(n, z[i] = y[i] + h * c[i]);                                                         \
            F(t + h, z, d);                                                                             \
            RK_EACH(n, y[i] = (((y[i] + h6 * a[i]) + h3 * b[i]) + h3 * c[i]) + h6 * d[i]);              \
        }                                                                                               \
    }

#define DP54_LOOP_OF(name, n, F)                                                                                   \
    static void name##_dp54_loop(double T, double tol, double *y)                                                  \
    {                                                                                                              \
        double t = 0, h = 1e-3, k1[n], k2[n], k3[n], k4[n], k5[n], k6[n], k7[n], z[n], ee[n], sc[n];               \
        F(0.0, y, k1);                                                                                             \
        for (;;) {                                                                                                 \
            int last = t + h >= T, big = 0, small = 1;                                                             \
            double s = last ? T - t : h, e = 0;                                                                    \
            double h21 = s / 5, h31 = s * (3. / 40), h32 = s * (9. / 40), h41 = s * (44. / 45),                    \
                   h42 = s * (-56. / 15), h43 = s * (32. / 9), h51 = s * (19372. / 6561),                          \
                   h52 = s * (-25360. / 2187), h53 = s * (64448. / 6561), h54 = s * (-212. / 729),                 \
                   h61 = s * (9017. / 3168), h62 = s * (-355. / 33), h63 = s * (46732. / 5247),                    \
                   h64 = s * (49. / 176), h65 = s * (-5103. / 18656), b1 = s * (35. / 384),                        \
                   b3 = s * (500. / 1113), b4 = s * (125. / 192), b5 = s * (-2187. / 6784), b6 = s * (11. / 84),   \
                   e1 = s * (71. / 57600), e3 = s * (-71. / 16695), e4 = s * (71. / 1920),                         \
                   e5 = s * (-17253. / 339200), e6 = s * (22. / 525), e7 = s * (-1. / 40);                         \
            RK_EACH(n, z[i] = y[i] + h21 * k1[i]);                                                                 \
            F(t + s * .2, z, k2);                                                                                  \
            RK_EACH(n, z[i] = (y[i] + h31 * k1[i]) + h32 * k2[i]);                                                 \
            F(t + s * .3, z, k3);                                                                                  \
            RK_EACH(n, z[i] = ((y[i] + h41 * k1[i]) + h42 * k2[i]) + h43 * k3[i]);                                 \
            F(t + s * .8, z, k4);                                                                                  \
            RK_EACH(n, z[i] = (((y[i] + h51 * k1[i]) + h52 * k2[i]) + h53 * k3[i]) + h54 * k4[i]);                 \
            F(t + s * (8. / 9), z, k5);                                                                            \
            RK_EACH(n, z[i] = ((((y[i] + h61 * k1[i]) + h62 * k2[i]) + h63 * k3[i]) + h64 * k4[i]) + h65 * k5[i]); \
            F(t + s, z, k6);                                                                                       \
            RK_EACH(n, z[i] = ((((y[i] + b1 * k1[i]) + b3 * k3[i]) + b4 * k4[i]) + b5 * k5[i]) + b6 * k6[i]);      \
            F(t + s, z, k7);                                                                                       \
            RK_EACH(n, ee[i] = fabs(((((e1 * k1[i] + e3 * k3[i]) + e4 * k4[i]) + e5 * k5[i]) + e6 * k6[i]) +       \
                                    e7 * k7[i]);                                                                   \
                    sc[i] = tol + tol * (fabs(y[i]) + fabs(s * k1[i])); big |= !(ee[i] <= sc[i]);                  \
                    small &= ee[i] < .5 * sc[i]);                                                                  \
            if (big || (small && !last)) RK_EACH(n, e = fmax(e, ee[i] / sc[i]));                                   \
            if (big) {                                                                                             \
                h = s * fmax(.2, .9 * pow(e, -1. / 3));                                                            \
                continue;                                                                                          \
            }                                                                                                      \
            t += s;                                                                                                \
            RK_EACH(n, y[i] = z[i]; k1[i] = k7[i]);                                                                \
            if (last) return;                                                                                      \
            if (small) h = s * .9 * rk_loops_root5(fmax(e, 3.2e-4));                                               \
        }                                                                                                          \
    }
#endif
