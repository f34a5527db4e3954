/* detest.h - DETEST, the Toronto test set for methods that solve y' = f(t, y): thirty problems A1 to F5 from t = 0 to 20.

   T. E. Hull, W. H. Enright, B. M. Fellen, A. E. Sedgwick, Comparing numerical methods for ordinary differential
   equations, SIAM Journal on Numerical Analysis 9 (1972) 603-637; class F: W. H. Enright, J. D. Pryce, Two FORTRAN
   packages for assessing initial value methods, ACM Transactions on Mathematical Software 13 (1987) 1-27.

   A: one equation. B: small systems. C: larger systems. D: Kepler's orbits. E: equations of second order. F: right-hand
   sides that are not smooth. Include ../integrators.h first. The ends of all solutions stand in data/detest_table.h.

   tests/gen/detest_reference.c includes this file with its own DETEST_REAL, a type of quadruple precision: constants are
   numbers of type double in all precisions, so that the problem is the same one. */
#ifndef DETEST_H
#define DETEST_H

#include <math.h>

#ifndef DETEST_REAL
#define DETEST_REAL vm_real
/* In float, too, functions of the C library are computed in double: rounded to float, they are the same in all libraries. The
   last bit of sin matters: on E3 it changes the steps of rk87, and with them the error at the end by a large factor. */
#define DETEST_MATH(name) detest_##name
#define DETEST_ROUNDED(name) \
    static vm_real detest_##name(vm_real x) { return (vm_real)name((double)x); }
DETEST_ROUNDED(sin)
DETEST_ROUNDED(cos)
DETEST_ROUNDED(sqrt)
DETEST_ROUNDED(cbrt)
#define DETEST_PIECE(t) VM_FLOOR(t) /* the right-hand sides of class F are smooth between two whole numbers */
#endif
#define DETEST_C(x) ((DETEST_REAL)(x))
#define DETEST_RHS(name) static int name(DETEST_REAL t, const DETEST_REAL *y, DETEST_REAL *dydt, void *ctx)
#define DETEST_UNUSED(x) (void)(x)

enum { DETEST_PROBLEMS = 30, DETEST_LARGEST = 51 };

/* ---- class A: one equation ---- */

DETEST_RHS(detest_a1) /* decay */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[0];
    return 0;
}

DETEST_RHS(detest_a2) /* y = 1/sqrt(1 + t) */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[0] * y[0] * y[0] / 2;
    return 0;
}

DETEST_RHS(detest_a3) /* y = exp(sin t) */
{
    DETEST_UNUSED(ctx);
    dydt[0] = y[0] * DETEST_MATH(cos)(t);
    return 0;
}

DETEST_RHS(detest_a4) /* a logistic curve */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = y[0] / 4 * (1 - y[0] / 20);
    return 0;
}

DETEST_RHS(detest_a5) /* a spiral */
{
    DETEST_UNUSED(ctx);
    dydt[0] = (y[0] - t) / (y[0] + t);
    return 0;
}

/* ---- class B: small systems ---- */

DETEST_RHS(detest_b1) /* two populations that fight */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = 2 * (y[0] - y[0] * y[1]);
    dydt[1] = -(y[1] - y[0] * y[1]);
    return 0;
}

DETEST_RHS(detest_b2) /* a linear chemical reaction */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[0] + y[1];
    dydt[1] = y[0] - 2 * y[1] + y[2];
    dydt[2] = y[1] - y[2];
    return 0;
}

DETEST_RHS(detest_b3) /* a nonlinear chemical reaction */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[0];
    dydt[1] = y[0] - y[1] * y[1];
    dydt[2] = y[1] * y[1];
    return 0;
}

DETEST_RHS(detest_b4) /* a curve on a torus */
{
    const DETEST_REAL r = DETEST_MATH(sqrt)(y[0] * y[0] + y[1] * y[1]);
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[1] - y[0] * y[2] / r;
    dydt[1] = y[0] - y[1] * y[2] / r;
    dydt[2] = y[0] / r;
    return 0;
}

DETEST_RHS(detest_b5) /* Euler's equations of a rigid body */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = y[1] * y[2];
    dydt[1] = -y[0] * y[2];
    dydt[2] = DETEST_C(-0.51) * y[0] * y[1];
    return 0;
}

/* ---- class C: larger systems ---- */

DETEST_RHS(detest_c1) /* a chain of ten decays at equal rates */
{
    int i;
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[0];
    for (i = 1; i < 9; i++) dydt[i] = y[i - 1] - y[i];
    dydt[9] = y[8];
    return 0;
}

DETEST_RHS(detest_c2) /* a chain of ten decays, each faster than the one before */
{
    int i;
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = -y[0];
    for (i = 1; i < 9; i++) dydt[i] = DETEST_C(i) * y[i - 1] - DETEST_C(i + 1) * y[i];
    dydt[9] = 9 * y[8];
    return 0;
}

/* Heat in a rod of n points */
static void detest_rod(int n, const DETEST_REAL *y, DETEST_REAL *dydt)
{
    int i;
    dydt[0] = -2 * y[0] + y[1];
    for (i = 1; i < n - 1; i++) dydt[i] = y[i - 1] - 2 * y[i] + y[i + 1];
    dydt[n - 1] = y[n - 2] - 2 * y[n - 1];
}

DETEST_RHS(detest_c3)
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    detest_rod(10, y, dydt);
    return 0;
}

DETEST_RHS(detest_c4)
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    detest_rod(51, y, dydt);
    return 0;
}

/* 1/|a|^3 */
static DETEST_REAL detest_inverse_cube(DETEST_REAL a0, DETEST_REAL a1, DETEST_REAL a2)
{
    const DETEST_REAL square = a0 * a0 + a1 * a1 + a2 * a2;
    return 1 / (square * DETEST_MATH(sqrt)(square));
}

DETEST_RHS(detest_c5) /* the five outer planets: positions about the sun, then velocities; unit of time 100 days */
{
    static const double sun = 1.00000597682, gravity = 2.95912208286,
                        mass[5] = {.954786104043e-3, .285583733151e-3, .437273164546e-4, .517759138449e-4,
                                   .277777777778e-5};
    DETEST_REAL pull[5]; /* of each planet on the sun, over its mass and distance */
    int i, j, k;
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    for (j = 0; j < 5; j++) pull[j] = detest_inverse_cube(y[3 * j], y[3 * j + 1], y[3 * j + 2]);
    for (j = 0; j < 5; j++) {
        const DETEST_REAL *at = y + 3 * j;
        DETEST_REAL *acceleration = dydt + 15 + 3 * j;
        for (k = 0; k < 3; k++) {
            dydt[3 * j + k] = y[15 + 3 * j + k];
            acceleration[k] = -(DETEST_C(sun) + DETEST_C(mass[j])) * at[k] * pull[j];
        }
        for (i = 0; i < 5; i++) {
            const DETEST_REAL *other = y + 3 * i;
            DETEST_REAL nearness;
            if (i == j) continue;
            nearness = detest_inverse_cube(other[0] - at[0], other[1] - at[1], other[2] - at[2]);
            for (k = 0; k < 3; k++)
                acceleration[k] += DETEST_C(mass[i]) * ((other[k] - at[k]) * nearness - other[k] * pull[i]);
        }
        for (k = 0; k < 3; k++) acceleration[k] *= DETEST_C(gravity);
    }
    return 0;
}

/* ---- class D: an orbit about a fixed point, eccentricities 0.1 to 0.9 ---- */

DETEST_RHS(detest_d)
{
    const DETEST_REAL square = y[0] * y[0] + y[1] * y[1], cube = square * DETEST_MATH(sqrt)(square);
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = -y[0] / cube;
    dydt[3] = -y[1] / cube;
    return 0;
}

/* ---- class E: equations of second order ---- */

DETEST_RHS(detest_e1) /* Bessel's equation of order 1/2 */
{
    const DETEST_REAL x = t + 1;
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = -(y[1] / x + (1 - 1 / (4 * x * x)) * y[0]);
    return 0;
}

DETEST_RHS(detest_e2) /* Van der Pol's oscillator */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = (1 - y[0] * y[0]) * y[1] - y[0];
    return 0;
}

DETEST_RHS(detest_e3) /* Duffing's oscillator, driven */
{
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = y[0] * y[0] * y[0] / 6 - y[0] + 2 * DETEST_MATH(sin)(DETEST_C(2.78535) * t);
    return 0;
}

DETEST_RHS(detest_e4) /* fall in air */
{
    DETEST_UNUSED(t);
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = DETEST_C(0.032) - DETEST_C(0.4) * y[1] * y[1];
    return 0;
}

DETEST_RHS(detest_e5) /* a pursuit */
{
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = DETEST_MATH(sqrt)(1 + y[1] * y[1]) / (25 - t);
    return 0;
}

/* ---- class F: right-hand sides that are not smooth ---- */

static int detest_is_odd(DETEST_REAL whole) { return (int)whole % 2 != 0; }

DETEST_RHS(detest_f1) /* an oscillator whose force jumps at each whole time, and which grows */
{
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = DETEST_C(0.2) * y[1] - DETEST_C(9.879604401089358) * y[0];
    dydt[1] += detest_is_odd(DETEST_PIECE(t)) ? -1 : 1;
    return 0;
}

DETEST_RHS(detest_f2) /* a rate that jumps at each whole time */
{
    DETEST_UNUSED(ctx);
    dydt[0] = 55 - (detest_is_odd(DETEST_PIECE(t)) ? DETEST_C(0.5) : DETEST_C(1.5)) * y[0];
    return 0;
}

DETEST_RHS(detest_f3) /* a force |sin(pi t)|, whose slope jumps at each whole time */
{
    const DETEST_REAL pi = DETEST_C(3.141592653589793), within = t - DETEST_PIECE(t);
    DETEST_UNUSED(ctx);
    dydt[0] = y[1];
    dydt[1] = DETEST_C(0.01) * y[1] * (1 - y[0] * y[0]) - y[0] - DETEST_MATH(sin)(pi * within);
    return 0;
}

DETEST_RHS(detest_f4) /* a short pulse at t = 5, another equation from t = 10 on */
{
    const DETEST_REAL x = t - 5;
    DETEST_REAL power = 1 + 4 * x * x;
    int i;
    DETEST_UNUSED(ctx);
    dydt[0] = -2 * y[0];
    if (DETEST_PIECE(t) >= 10) return 0;
    for (i = 0; i < 4; i++) power *= power;
    dydt[0] = DETEST_C(-2.0 / 21) - 120 * x / power;
    return 0;
}

DETEST_RHS(detest_f5) /* a sum of 19 cube roots, whose slopes are infinite at each whole time */
{
    DETEST_REAL sum = 0;
    int i;
    DETEST_UNUSED(ctx);
    for (i = 1; i < 20; i++) sum += DETEST_MATH(cbrt)(t - DETEST_C(i));
    dydt[0] = y[0] * DETEST_C(4 / (3 * 438.4461015267790)) * sum;
    return 0;
}

/* ---- the set ---- */

typedef struct detest_problem {
    const char *name, *what;
    int n;
    int (*f)(DETEST_REAL t, const DETEST_REAL *y, DETEST_REAL *dydt, void *ctx);
    double y0[4]; /* the first values; C5 and class D have their own, the others are zero */
} detest_problem;

static const double detest_t_end = 20;

static const detest_problem detest_problems[DETEST_PROBLEMS] = {
    {"A1", "decay", 1, detest_a1, {1}},
    {"A2", "y' = -y^3/2", 1, detest_a2, {1}},
    {"A3", "y' = y cos t", 1, detest_a3, {1}},
    {"A4", "logistic curve", 1, detest_a4, {1}},
    {"A5", "spiral", 1, detest_a5, {4}},
    {"B1", "two populations", 2, detest_b1, {1, 3}},
    {"B2", "linear reaction", 3, detest_b2, {2, 0, 1}},
    {"B3", "nonlinear reaction", 3, detest_b3, {1, 0, 0}},
    {"B4", "curve on a torus", 3, detest_b4, {3, 0, 0}},
    {"B5", "rigid body", 3, detest_b5, {0, 1, 1}},
    {"C1", "ten decays", 10, detest_c1, {1}},
    {"C2", "ten decays, faster", 10, detest_c2, {1}},
    {"C3", "heat, 10 points", 10, detest_c3, {1}},
    {"C4", "heat, 51 points", 51, detest_c4, {1}},
    {"C5", "five planets", 30, detest_c5, {0}},
    {"D1", "orbit, e = 0.1", 4, detest_d, {0.1}},
    {"D2", "orbit, e = 0.3", 4, detest_d, {0.3}},
    {"D3", "orbit, e = 0.5", 4, detest_d, {0.5}},
    {"D4", "orbit, e = 0.7", 4, detest_d, {0.7}},
    {"D5", "orbit, e = 0.9", 4, detest_d, {0.9}},
    {"E1", "Bessel's equation", 2, detest_e1, {0.6713967071418030, 0.09540051444747446}},
    {"E2", "Van der Pol", 2, detest_e2, {2, 0}},
    {"E3", "Duffing, driven", 2, detest_e3, {0, 0}},
    {"E4", "fall in air", 2, detest_e4, {30, 0}},
    {"E5", "pursuit", 2, detest_e5, {0, 0}},
    {"F1", "force that jumps", 2, detest_f1, {0, 0}},
    {"F2", "rate that jumps", 1, detest_f2, {110}},
    {"F3", "force |sin(pi t)|", 2, detest_f3, {0, 0}},
    {"F4", "pulse, two equations", 1, detest_f4, {1}},
    {"F5", "cube roots", 1, detest_f5, {1}},
};

/* y[0 .. n-1] at t = 0 */
static void detest_start(const detest_problem *p, double *y)
{
    static const double planets[30] = {
        3.42947415189,   3.35386959711,   1.35494901715,  6.64145542550,   5.97156957878,   2.18231499728,
        11.2630437207,   14.6952576794,   6.27960525067,  -30.1552268759,  1.65699966404,   1.43785752721,
        -21.1238353380,  28.4465098142,   15.3882659679,  -.557160570446,  .505696783289,   .230578543901,
        -.415570776342,  .365682722812,   .169143213293,  -.325325669158,  .189706021964,   .0877265322780,
        -.0240476254170, -.287659532608,  -.117219543175, -.176860753121,  -.216393453025,  -.0148647893090};
    const double eccentricity = p->y0[0];
    int i;
    for (i = 0; i < p->n; i++) y[i] = i < 4 ? p->y0[i] : 0;
    if (p->f == detest_c5)
        for (i = 0; i < p->n; i++) y[i] = planets[i];
    if (p->f == detest_d) {
        y[0] = 1 - eccentricity;
        y[3] = sqrt((1 + eccentricity) / (1 - eccentricity));
    }
}

#endif
