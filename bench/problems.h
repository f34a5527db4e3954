/* problems.h - the problems on which integrators are compared, y' = f(t, y) from t = 0 to T; y at T to 20 digits by
   Taylor series of tests/gen/problems.py. */
#ifndef VARMASS_PROBLEMS_H
#define VARMASS_PROBLEMS_H

#include <math.h>

/* x'' = -x^3 */
static inline void cubic_f(double t, const double *y, double *d)
{
    (void)t;
    d[0] = y[1];
    d[1] = -y[0] * y[0] * y[0];
}

/* (m x')' = -x^3, m = 1 + 0.1 t, by velocity and by momentum */
static inline void mass_f(double t, const double *y, double *d)
{
    d[0] = y[1];
    d[1] = -(y[0] * y[0] * y[0] + 0.1 * y[1]) / (1 + 0.1 * t);
}

static inline void momentum_f(double t, const double *y, double *d)
{
    d[0] = y[1] / (1 + 0.1 * t);
    d[1] = -y[0] * y[0] * y[0];
}

/* Euler's equations, moments 1, 2, 3 */
static inline void body_f(double t, const double *y, double *d)
{
    (void)t;
    d[0] = -y[1] * y[2];
    d[1] = y[2] * y[0];
    d[2] = -y[0] * y[1] * (1. / 3);
}

/* Arenstorf's orbit in the restricted three-body problem */
static inline void orbit_f(double t, const double *y, double *d)
{
    const double mu = 0.012277471, mu1 = 1 - mu;
    double r1 = (y[0] + mu) * (y[0] + mu) + y[1] * y[1], r2 = (y[0] - mu1) * (y[0] - mu1) + y[1] * y[1];
    (void)t;
    r1 = mu1 / (r1 * sqrt(r1));
    r2 = mu / (r2 * sqrt(r2));
    d[0] = y[2];
    d[1] = y[3];
    d[2] = y[0] + 2 * y[3] - r1 * (y[0] + mu) - r2 * (y[0] - mu1);
    d[3] = y[1] - 2 * y[2] - r1 * y[1] - r2 * y[1];
}

enum { PROBLEMS = 5 };

typedef struct problem {
    const char *name, *what;
    void (*f)(double t, const double *y, double *d);
    int n;
    double T, y0[4], y_end[4];
} problem;

static const problem problems[PROBLEMS] = {
    {"cubic", "x'' = -x^3", cubic_f, 2, 100, {1, 0}, {-0.99282192702465530435, -0.11917344555285698982}},
    {"mass",
     "(m x')' = -x^3, y = (x, x')",
     mass_f,
     2,
     50,
     {1, 0},
     {-0.21022546532589420703, -0.15784032868484443872}},
    {"momentum",
     "(m x')' = -x^3, y = (x, m x')",
     momentum_f,
     2,
     50,
     {1, 0},
     {-0.21022546532589420703, -0.94704197210906667614}},
    {"body",
     "Euler's rigid body",
     body_f,
     3,
     60,
     {1, 0.1, 0.9},
     {-0.84160440624400955797, -0.54927408767451257482, 0.84425469628727009534}},
    {"orbit",
     "Arenstorf's orbit",
     orbit_f,
     4,
     17.0652165601579625588917206249,
     {0.994, 0, 0, -2.00158510637908252240537862224},
     {0.99399999999990884034, -3.0309430229824181664e-13, -4.9285365810550524652e-11, -2.0015851063932702385}}};

/* The largest difference of y from the value at T */
static inline double error_at_end(const problem *p, const double *y)
{
    double error = 0;
    int i;
    for (i = 0; i < p->n; i++) error = fmax(error, fabs(y[i] - p->y_end[i]));
    return error;
}

#endif
