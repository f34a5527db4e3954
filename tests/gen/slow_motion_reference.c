/* Writes tests/data/slow_motions.h: motions of oscillators with slow mass and stiffness, to 19 digits, for
   tests/test_slow_motion.c and tests/test_collocation.c.

       cc -O2 tests/gen/slow_motion_reference.c -o reference -lm && ./reference >tests/data/slow_motions.h

   By motion_reference.h in long double of 64 bits or more (x87, or 113 bits), which shares no code with the headers. Each
   motion is computed twice, with tolerances 3e-18 (printed) and 3e-16; the two must agree to 2e-12 (the campaign's to
   1e-11), and mostly do to 1e-14.
   All inputs are numbers of single precision but for an alpha of tenths or thirds. Takes some minutes. */
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

static ref_motion motion_of(int top, int bottom)
{
    ref_motion o;
    memset(&o, 0, sizeof o);
    o.top = top;
    o.bottom = bottom;
    o.alpha = (REAL)top / bottom;
    o.r = 1;
    o.mass = o.stiffness = law_of(REF_LINEAR, 1, 0, 0);
    o.x = 1;
    return o;
}

/* Prints the motion, unless its two computations differ by more than `agreement`. */
static void print_agreed(ref_motion *o, double T, double agreement, const char *name)
{
    static const int parts[TIMES] = {33, 34, 37, 40};
    double t[TIMES];
    REAL x[TIMES], v[TIMES], difference;
    int i;
    for (i = 0; i < TIMES; i++) t[i] = T * parts[i] / 40;
    difference = follow_twice(o, 3e-18L, TIMES, t, x, v);
    if (!(difference < agreement)) {
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

static void print_motion(ref_motion *o, double T, const char *name) { print_agreed(o, T, 2e-12, name); }

/* ---- Eight laws and a table at two rates ---- */

enum { LAWS = 9 };

static ref_motion eight_laws(int law, int top, int bottom, double e, double T, double *times, double *values)
{
    static const double starts[3][2] = {{1, 0}, {0.8125, -0.375}, {-0.40625, -0.625}};
    static const int start_of[LAWS] = {0, 1, 2, 1, 2, 1, 2, 1, 1};
    ref_motion o = motion_of(top, bottom);
    o.x = starts[start_of[law]][0];
    o.P = starts[start_of[law]][1];
    if (law < 3) o.mass = law_of(REF_LINEAR, 1, e, 0);
    switch (law) {
    case 1: o.r = 0; break;
    case 2: o.damping = single(e / 2); break;
    case 3: o.mass = law_of(REF_EXPONENTIAL, 1, e / 2, 0); break;
    case 4:
        o.mass = law_of(REF_QUADRATIC, 1, e, e * e / 2);
        o.damping = single(0.3 * e);
        break;
    case 5:
        o.mass = law_of(REF_POWER, 1, e, 1.5);
        o.r = 0.25;
        o.stiffness = law_of(REF_LINEAR, 1, e / 2, 0);
        break;
    case 6:
        o.stiffness = law_of(REF_EXPONENTIAL, 1, -e, 0);
        o.damping = single(e / 4);
        break;
    case 7: o.mass = law_of(REF_SINE, 0.5, e, 0); break;
    case 8: o.mass = table_of(T, 0.5, 6 / T, 0.25, times, values); break; /* points at the same parts of T */
    default: break;
    }
    return o;
}

static void print_orders(void)
{
    static const int alphas[6][2] = {{1, 2}, {1, 1}, {4, 3}, {2, 1}, {3, 1}, {5, 1}};
    static const double rates[2] = {0.0625, 0.015625};
    double times[POINTS], values[POINTS];
    int law, i, k;
    printf("static const slow_case slow_orders[] = { /* law by law: alpha by alpha, each at two rates */\n");
    for (law = 0; law < LAWS; law++)
        for (i = 0; i < 6; i++)
            for (k = 0; k < 2; k++) {
                const double e = rates[k], T = length_of((law == 7 ? 10 : law == 8 ? 6 : 3) / e);
                ref_motion o = eight_laws(law, alphas[i][0], alphas[i][1], e, T, times, values);
                print_motion(&o, T, "orders");
            }
    printf("};\n");
}

/* ---- Random problems ---- */

static ref_law draw_law(int kind, double e)
{
    const double side = uniform(0, 1) < 0.5 ? -0.3 : 1;
    ref_law l = law_of(kind, 1, side * e, 0);
    if (kind == REF_QUADRATIC) l.c = single(e * e * (side < 0 ? 0.1 : uniform(0, 0.3)));
    if (kind == REF_POWER) l.c = uniform(-2, 2);
    return l;
}

static ref_motion draw(int kind, double e, double T, double least, double times[2][POINTS], double values[2][POINTS])
{
    const int bottom = 1 << (int)uniform(0, 3);
    ref_motion o = motion_of((int)uniform(1, 6 * bottom + 1), bottom);
    o.mass = draw_law(kind, e);
    if (uniform(0, 1) < 0.4) o.stiffness = law_of(REF_EXPONENTIAL, 1, e * uniform(-0.5, 0.5), 0);
    if (kind == REF_TABLE) {
        o.mass = table_of(T, uniform(0.1, 0.5), 6 / T * uniform(0.5, 1.5), uniform(0, 6), times[0], values[0]);
        if (uniform(0, 1) < 0.3)
            o.stiffness = table_of(T, uniform(0.1, 0.5), 6 / T * uniform(0.5, 1.5), uniform(0, 6), times[1], values[1]);
    }
    o.r = uniform(0, 1) < 0.3 ? uniform(0, 1) : uniform(0, 1) < 0.5;
    o.damping = uniform(0, 1) < 0.5 ? 0 : single(e * uniform(-0.25, 0.5));
    do {
        o.x = uniform(-1, 1);
        o.P = uniform(-1, 1);
    } while (o.x * o.x + o.P * o.P < least); /* small vibrations are slow where alpha > 1 */
    return o;
}

/* Random problems that change by slowest to fastest in a second, to T = turns by that; x^2 + v^2 is at least `least` */
static void print_random(const char *name, int count, const int *kinds, int n_kinds, double slowest, double fastest,
                         double turns, double least)
{
    double times[2][POINTS], values[2][POINTS];
    int i;
    printf("static const slow_case %s[] = {\n", name);
    for (i = 0; i < count; i++) {
        const double e = spread(slowest, fastest), T = length_of(turns / e);
        ref_motion o = draw(kinds[i % n_kinds], e, T, least, times, values);
        print_motion(&o, T, name);
    }
    printf("};\n");
}

/* ---- Random problems of a given rate, for how often the law of order five errs by less than 1e-9 A ---- */

/* The laws of mass: linear, exponential, power and quadratic. `change` is the relative change of the mass in a second,
   divided by e, at t = 0: from 0.1 to 1.4, or for the linear and the exponential law also from -0.3 to -0.05. */
static ref_law draw_mass(double e)
{
    static const int kinds[4] = {REF_LINEAR, REF_EXPONENTIAL, REF_POWER, REF_QUADRATIC};
    const int kind = kinds[(int)uniform(0, 4)];
    double change = uniform(-0.6, 1.4);
    if (change < 0 && change > -0.1) change = 0.1;
    if (change < 0) change /= 2;
    if (kind == REF_POWER) return law_of(kind, 1, e * fabs(change), uniform(0, 3));
    if (kind == REF_QUADRATIC) return law_of(kind, 1, e * fabs(change), e * e * uniform(0, 0.4));
    return law_of(kind, 1, e * change, 0);
}

/* Lets the oscillator start with the amplitude A at a phase that is uniform in a period: it is followed with constant
   mass from rest for a part of its period. The mass and the stiffness must be 1 at t = 0. */
static void draw_start(ref_motion *o, double A)
{
    const double n = (double)o->alpha + 1, rate = sqrt(n / 2) * pow(A, ((double)o->alpha - 1) / 2);
    const double quarter = sqrt(3.14159265358979323846) / 2 * tgamma(1 / n) / tgamma(1 / n + 0.5);
    ref_motion still = motion_of(o->top, o->bottom);
    still.x = A;
    still.tolerance = 1e-12L;
    ref_follow(&still, 4 * quarter / rate * uniform(0, 1));
    o->x = single((double)still.x);
    o->P = single((double)still.P);
}

/* alpha is a whole number of quarters from 1/4 to 8, the reactive force is full in two of five problems, none in three
   of ten and partial in the others, half of the problems are damped, by either sign, and two of five have an
   exponential stiffness. The amplitude at the start is between 0.6 and 1.65. T = 2/e. */
static void print_campaign(int count, double e)
{
    int i;
    printf("static const slow_case slow_campaign[] = { /* all at the rate 0.01, with T = 2/0.01 */\n");
    for (i = 0; i < count; i++) {
        int top = (int)uniform(1, 33), bottom = 4;
        ref_motion o;
        while (top % 2 == 0 && bottom > 1) {
            top /= 2;
            bottom /= 2;
        }
        o = motion_of(top, bottom);
        o.mass = draw_mass(e);
        o.r = uniform(0, 1);
        if (uniform(0, 1) < 0.7) o.r = uniform(0, 7) < 4; /* 1 or 0 */
        if (uniform(0, 1) < 0.5) o.damping = single(e * uniform(-1, 1));
        if (uniform(0, 1) < 0.4) o.stiffness = law_of(REF_EXPONENTIAL, 1, e * uniform(-0.5, 0.5), 0);
        draw_start(&o, exp(uniform(-0.5, 0.5)));
        print_agreed(&o, 2 / e, 1e-11, "campaign");
    }
    printf("};\n");
}

/* ---- Motions for the collocation ---- */

static void print_collocation(void)
{
    static const int alphas[6][2] = {{0, 1}, {1, 10}, {1, 2}, {4, 3}, {23, 10}, {10, 1}};
    static const double sizes[REF_FORCES] = {0, 0.0625, 0.03125, 0.03125, 0.03125, 0.0078125};
    double times[POINTS], values[POINTS];
    int i, k;
    printf("static const slow_case slow_exact[] = { /* alpha by alpha: no force, a sine, a table, then each force */\n");
    for (i = 0; i < 6; i++)
        for (k = 0; k < 2 + REF_FORCES; k++) {
            const double e = 0.03125, T = length_of(2 / e);
            ref_motion o = motion_of(alphas[i][0], alphas[i][1]);
            o.x = 0.8125;
            o.P = -0.375;
            o.mass = law_of(REF_LINEAR, 1, e, 0);
            o.damping = single(e / 8);
            if (k == 1) o.mass = law_of(REF_SINE, 0.5, 4 * e, 0.5);
            if (k == 2) o.mass = table_of(T, 0.5, 6 / T, 0.25, times, values);
            if (k >= 2) {
                o.force = k - 2;
                o.size = sizes[o.force];
                o.frequency = 0.25;
            }
            print_motion(&o, T, "collocation");
        }
    printf("};\n");
}

int main(void)
{
    static const int smooth[4] = {REF_LINEAR, REF_EXPONENTIAL, REF_POWER, REF_QUADRATIC}, table[1] = {REF_TABLE};
    printf("/* Written by tests/gen/slow_motion_reference.c: a routes_case, then x and x' at 33, 34, 37 and 40 fortieths of T */\n");
    print_orders();
    print_collocation();
    print_random("slow_tables", 60, table, 1, 0.01, 0.1, 5, 0);
    print_random("slow_wide", 160, smooth, 4, 0.01, 0.15, 2, 0);
    print_random("slow_random", 200, smooth, 4, 0.01, 0.01, 3, 0.5);
    print_campaign(200, 0.01);
    return 0;
}
