/* Writes tests/data/van_der_pol_motions.h: motions of Van der Pol oscillators with slow mass, to 19 digits, for
   tests/test_van_der_pol_law.c.

       cc -O2 tests/gen/van_der_pol_reference.c -o reference -lm && ./reference >tests/data/van_der_pol_motions.h

   By motion_reference.h in long double of 64 bits or more (x87, or 113 bits), which shares no code with the headers. Each
   motion is computed twice, with tolerances 3e-18 (printed) and 3e-16; the two must agree to 1e-9. The term of the feed
   and the term that limits the vibration are its force size (1 - x^2) x' and its damping: feed = size - damping,
   c = size. All inputs are numbers of single precision but for an alpha of thirds. Takes some minutes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
typedef long double REAL;
#define REAL_POW powl
#define REAL_EXP expl
#define REAL_SIN sinl
#define REAL_COS cosl
#define REAL_TANH tanhl
#define REAL_SQRT sqrtl
#define REAL_FABS fabsl
#include "motion_reference.h"
#include "motion_cases.h"

enum { TIMES = 4 }; /* of one motion: 33, 34, 37 and 40 parts of 40 of T; the second and the last are points of tables */

static double single(double x) { return (float)x; }

static ref_law law_of(int kind, double a, double b, double c)
{
    ref_law l;
    memset(&l, 0, sizeof l);
    l.kind = kind;
    l.a = single(a);
    l.b = single(b);
    l.c = single(c);
    return l;
}

/* A table of 1 + a sin(rate t + phase) from 0 to T */
static ref_law table_of(double T, double a, double rate, double phase, double *times, double *values)
{
    ref_law l = law_of(REF_TABLE, 1, 0, 0);
    int i;
    l.n = POINTS;
    l.time = times;
    l.value = values;
    for (i = 0; i < POINTS; i++) {
        times[i] = T * i / (POINTS - 1);
        values[i] = single(1 + a * sin(rate * times[i] + phase));
    }
    return l;
}

/* A time of few bits, whose fortieth parts are, too */
static double length_of(double T) { return floor(T / 40 * 64 + 1) / 64 * 40; }

/* Pi_alpha/2 = B(1/2, 1/n)/2, and the mean of ca^2 is B(1/2, 3/n)/B(1/2, 1/n) */
static double mean_ca2(double alpha)
{
    const double n = alpha + 1;
    return exp(lgamma(3 / n) - lgamma(3 / n + 0.5) - lgamma(1 / n) + lgamma(1 / n + 0.5));
}

/* The amplitude of the limit cycle for feed = c */
static double cycle_of(double alpha) { return sqrt((alpha + 7) / ((alpha + 3) * mean_ca2(alpha))); }

/* Mass 1, feed and c, from x = A cos(angle)^(2/n), x' = -vmax sin(angle), which has the amplitude A. A c of 0 stands for
   no limit: then the force is left out. */
static ref_motion motion_of(int top, int bottom, double feed, double c, double A, double angle)
{
    ref_motion o;
    memset(&o, 0, sizeof o);
    o.top = top;
    o.bottom = bottom;
    o.alpha = (REAL)top / bottom;
    o.r = 1;
    o.mass = o.stiffness = law_of(REF_LINEAR, 1, 0, 0);
    o.force = c == 0 ? REF_NO_FORCE : REF_VAN_DER_POL;
    o.size = single(c);
    o.damping = single(o.size - feed);
    o.x = single(A * copysign(pow(fabs(cos(angle)), 2 / ((double)o.alpha + 1)), cos(angle)));
    o.P = single(-sqrt(2 / ((double)o.alpha + 1)) * pow(A, ((double)o.alpha + 1) / 2) * sin(angle));
    return o;
}

static void print_motion(ref_motion *o, double T, const char *name)
{
    static const int parts[TIMES] = {33, 34, 37, 40};
    double t[TIMES];
    REAL x[TIMES], v[TIMES], difference;
    int i;
    for (i = 0; i < TIMES; i++) t[i] = T * parts[i] / 40;
    difference = follow_twice(o, 3e-18L, TIMES, t, x, v);
    if (!(difference < 1e-9L)) {
        fprintf(stderr, "%s: left out, %.1Le\n", name, difference);
        return;
    }
    printf("    {");
    print_case(o, T, x[TIMES - 1], v[TIMES - 1]);
    printf(",\n     {");
    for (i = 0; i < TIMES; i++) printf("%s%.19Lg", i ? ", " : "", x[i]);
    printf("}, {");
    for (i = 0; i < TIMES; i++) printf("%s%.19Lg", i ? ", " : "", v[i]);
    printf("}},\n");
    fflush(stdout);
}

/* ---- Eight laws at two rates ---- */

enum { LAWS = 8 };

static ref_motion law_number(int law, int top, int bottom, double e, double T, double *times, double *values)
{
    const double As = cycle_of((double)top / bottom);
    ref_motion o;
    switch (law) {
    case 0: return motion_of(top, bottom, e, e, 0.5 * As, 0.6);
    case 1: return motion_of(top, bottom, e, e, 1.6 * As, 2);
    case 2:
        o = motion_of(top, bottom, e, e, 0.5 * As, 2);
        o.mass = law_of(REF_LINEAR, 1, e, 0);
        return o;
    case 3:
        o = motion_of(top, bottom, e, e, 1.6 * As, 0.6);
        o.mass = law_of(REF_LINEAR, 1, e, 0);
        o.r = 0;
        return o;
    case 4:
        o = motion_of(top, bottom, 0, e, 1, 2);
        o.mass = law_of(REF_LINEAR, 1, -0.2 * e, 0);
        o.r = 0;
        return o;
    case 5:
        o = motion_of(top, bottom, e, e, 1, 0.6);
        o.mass = law_of(REF_EXPONENTIAL, 1, e / 2, 0);
        return o;
    case 6: return motion_of(top, bottom, -e / 2, e, 1, 0.4);
    default:
        o = motion_of(top, bottom, e, e, 0.5 * As, 0.6);
        o.mass = table_of(T, 0.5, 6 / T, 0.25, times, values); /* points at the same parts of T */
        o.r = 0.25;
        return o;
    }
}

static void print_orders(void)
{
    static const int alphas[6][2] = {{1, 2}, {1, 1}, {4, 3}, {2, 1}, {3, 1}, {5, 1}};
    static const double rates[2] = {1. / 32, 1. / 128};
    double times[POINTS], values[POINTS];
    int law, i, k;
    printf("static const vdp_case vdp_orders[] = { /* law by law: alpha by alpha, each at two rates */\n");
    for (law = 0; law < LAWS; law++)
        for (i = 0; i < 6; i++)
            for (k = 0; k < 2; k++) {
                const double e = rates[k], T = length_of((law == LAWS - 1 ? 6 : 3) / e);
                ref_motion o = law_number(law, alphas[i][0], alphas[i][1], e, T, times, values);
                print_motion(&o, T, "orders");
            }
    printf("};\n");
}

/* ---- Random problems ---- */

static ref_law draw_law(int kind, double e)
{
    const double side = uniform(0, 1) < 0.4 ? -0.3 : 1;
    ref_law l = law_of(kind, 1, side * e, 0);
    if (uniform(0, 1) < 0.15) return law_of(REF_LINEAR, 1, 0, 0);
    if (kind == REF_QUADRATIC) l.c = single(e * e * (side < 0 ? 0.1 : uniform(0, 0.3)));
    if (kind == REF_POWER) l.c = uniform(-2, 2);
    return l;
}

static ref_motion draw(int kind, double e, double T, double times[POINTS], double values[POINTS])
{
    const int bottom = 1 << (int)uniform(0, 3), top = (int)uniform(1, 7 * bottom + 1);
    const double As = cycle_of((double)top / bottom), A = As * uniform(0.3, 2), angle = uniform(-3.14, 3.14);
    const double feed = e * uniform(-0.5, 1.5), kind_of_c = uniform(0, 1);
    double c = e;
    ref_motion o;
    if (kind_of_c < 0.1) c = 0;
    else if (kind_of_c < 0.2) c = -e / 16;
    o = motion_of(top, bottom, feed, c, A, angle);
    if (c <= 0) o.damping = single(c + e * uniform(0, 0.5)); /* no feed, else the amplitude may become infinite */
    o.mass = kind == REF_TABLE ? table_of(T, uniform(0.1, 0.5), 6 / T * uniform(0.5, 1.5), uniform(0, 6), times, values)
                               : draw_law(kind, e);
    o.r = uniform(0, 1) < 0.3 ? uniform(0, 1) : uniform(0, 1) < 0.5;
    return o;
}

/* Random problems that change by slowest to fastest in a second, to T = turns by that */
static void print_random(const char *name, int count, const int *kinds, int n_kinds, double slowest, double fastest,
                         double turns)
{
    double times[POINTS], values[POINTS];
    int i;
    printf("static const vdp_case %s[] = {\n", name);
    for (i = 0; i < count; i++) {
        const double e = spread(slowest, fastest), T = length_of(turns / e);
        ref_motion o = draw(kinds[i % n_kinds], e, T, times, values);
        print_motion(&o, T, name);
    }
    printf("};\n");
}

int main(void)
{
    static const int smooth[4] = {REF_LINEAR, REF_EXPONENTIAL, REF_POWER, REF_QUADRATIC}, table[1] = {REF_TABLE};
    printf("/* Written by tests/gen/van_der_pol_reference.c: a routes_case, then x and x' at 33, 34, 37 and 40 fortieths of T */\n");
    print_orders();
    print_random("vdp_random", 280, smooth, 4, 0.004, 0.15, 2);
    print_random("vdp_tables", 14, table, 1, 0.004, 0.05, 5);
    return 0;
}
