/* Writes tests/data/routes_table.h: motions of oscillators with variable mass, to 17 digits, for tests/test_routes.c.

       cc -O2 tests/gen/routes_reference.c -o routes_reference -lm && ./routes_reference >tests/data/routes_table.h

   By motion_reference.h in long double of 64 bits or more (x87, or 113 bits), which shares no code with the headers. Each
   motion is computed twice, with tolerances 1e-16 (printed) and 1e-14; the two must agree to 1e-10. All inputs are numbers of
   single precision, so that float and double get the same problem. Takes a minute. */
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

enum { SMOOTH, LOCAL, FORCED, GROUPS };

/* A law of this kind that changes by epsilon a second, or in places */
static ref_law draw_law(int kind, double epsilon, double T, double *times, double *values, int rough)
{
    const double side = uniform(0, 1) < 0.5 ? -0.3 : 1, phase = uniform(0, 6), a = uniform(0.1, 0.5);
    const double kink = uniform(0, T), step = spread(1e-3, 0.3);
    ref_law l;
    int i;
    memset(&l, 0, sizeof l);
    l.kind = kind;
    l.a = 1;
    if (kind == REF_LINEAR || kind == REF_EXPONENTIAL || kind == REF_POWER) l.b = (float)(side * epsilon);
    if (kind == REF_QUADRATIC) {
        l.b = (float)(side * epsilon);
        l.c = (float)(epsilon * epsilon * uniform(0, 0.3));
    }
    if (kind == REF_QUADRATIC && l.b < 0) l.c = (float)(epsilon * epsilon * 0.1); /* no zero */
    if (kind == REF_POWER) l.c = uniform(-2, 2);
    if (kind == REF_SINE) {
        l.a = a;
        l.b = epsilon;
        l.c = phase;
    }
    if (kind == REF_FILL) {
        l.a = spread(0.02, 0.5);
        l.b = uniform(0, T);
        l.c = spread(T / 800, T / 5);
    }
    if (kind == REF_BUMP) {
        l.a = spread(0.02, 0.7);
        l.b = uniform(0, T);
        l.c = spread(T / 800, T / 5);
    }
    if (kind == REF_TABLE) {
        l.n = POINTS;
        l.time = times;
        l.value = values;
        for (i = 0; i < POINTS; i++) {
            times[i] = T * i / (POINTS - 1);
            values[i] = (float)(rough ? (times[i] > kink ? 1 + step : 1) : 1 + a * sin(epsilon * times[i] + phase));
        }
    }
    return l;
}

static ref_motion draw(int group, int number, double *T, double times[2][POINTS], double values[2][POINTS])
{
    static const int smooth[6] = {REF_LINEAR, REF_QUADRATIC, REF_EXPONENTIAL, REF_POWER, REF_TABLE, REF_SINE};
    static const int local[3] = {REF_FILL, REF_BUMP, REF_TABLE};
    const double epsilon = number % 8 == 0 ? spread(2e-3, 5e-3) : spread(5e-3, 0.1);
    const int kind = group == LOCAL ? local[number % 3] : smooth[number % 6];
    ref_motion o;
    ref_law constant;
    memset(&o, 0, sizeof o);
    memset(&constant, 0, sizeof constant);
    o.bottom = 1 << (int)uniform(0, 4);
    o.top = (int)uniform(1, 8 * o.bottom + 1);
    if (uniform(0, 1) < 0.3) {
        o.bottom = 1;
        o.top = (int)uniform(1, 6);
    }
    o.alpha = (REAL)o.top / o.bottom;
    *T = floor(uniform(1, 3) / epsilon / 20 * 64 + 1) / 64 * 20; /* twenty steps of few bits */
    constant.kind = REF_LINEAR;
    constant.a = 1;
    o.mass = draw_law(kind, epsilon, *T, times[0], values[0], group == LOCAL);
    o.stiffness = constant;
    if (group == LOCAL) o.stiffness.a = number % 4 ? spread(0.1, 3) : spread(1e-4, 1e-2);
    if (group == SMOOTH && uniform(0, 1) < 0.25) {
        o.stiffness.kind = REF_EXPONENTIAL;
        o.stiffness.b = (float)(epsilon * uniform(-0.5, 0.5));
    }
    if (group == LOCAL && number % 5 == 0) {
        o.stiffness = o.mass;
        o.mass = constant;
    }
    o.r = uniform(0, 1) < 0.5;
    o.damping = uniform(0, 1) < 0.5 ? 0 : (float)(epsilon * uniform(-0.1, 0.5));
    if (group == FORCED) {
        o.force = 1 + number % (REF_FORCES - 1);
        o.size = spread(1e-3, 0.1);
        o.frequency = spread(0.01, 5);
    }
    o.x = uniform(-1, 1);
    o.P = number % 5 ? uniform(-1, 1) : 0;
    return o;
}

int main(void)
{
    static const char *const names[GROUPS] = {"smooth", "local", "forced"};
    static const int counts[GROUPS] = {96, 60, 40};
    int group, number;
    printf("/* Written by tests/gen/routes_reference.c: alpha, r, damping, mass and stiffness (kind, a, b, c, values), force,\n"
           "   its size and frequency, x and x' at 0, T, x and x' at T */\n");
    for (group = 0; group < GROUPS; group++) {
        printf("static const routes_case routes_%s[] = {\n", names[group]);
        for (number = 0; number < counts[group]; number++) {
            double T, times[2][POINTS], values[2][POINTS];
            ref_motion start = draw(group, number, &T, times, values);
            REAL x, v, difference = follow_twice(&start, 1e-16L, 1, &T, &x, &v);
            if (!(difference < 1e-10L)) {
                fprintf(stderr, "%s %d: left out, %.1Le\n", names[group], number, difference);
                continue;
            }
            printf("    ");
            print_case(&start, T, x, v);
            printf(",\n");
            fflush(stdout);
        }
        printf("};\n");
    }
    return 0;
}
