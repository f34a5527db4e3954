/* The ends of DETEST's problems (tests/detest.h) at t = 20, written to standard output as tests/data/detest_table.h: the
   extrapolation method of Gragg, Bulirsch and Stoer in quadruple precision, from one whole time to the next, between
   which all right-hand sides are smooth. Each problem is solved twice, at two tolerances; the program fails where the
   two differ by more than 1e-20 of 1 + |y|. The end of F5, whose slopes are infinite at whole times, is 1 exactly.
   usage: gcc -std=gnu99 -O2 tests/gen/detest_reference.c -o reference -lquadmath -lm && ./reference */
#include <quadmath.h>
#include <stdio.h>
#include <string.h>

static int piece; /* the whole time at which the present piece begins */
#define DETEST_REAL __float128
#define DETEST_MATH(name) name##q
#define DETEST_PIECE(t) ((void)(t), (__float128)piece)
#include "../detest.h"

enum { COLUMNS = 12 };
typedef __float128 quad;
typedef quad state[DETEST_LARGEST];

/* The modified midpoint rule: `count` steps from t over h */
static void midpoint(const detest_problem *p, quad t, quad h, int count, const quad *y, quad *result)
{
    const quad step = h / count;
    state before, now, slope;
    int i, k;
    memcpy(before, y, sizeof before);
    p->f(t, y, slope, NULL);
    for (i = 0; i < p->n; i++) now[i] = y[i] + step * slope[i];
    for (k = 1; k < count; k++) {
        p->f(t + k * step, now, slope, NULL);
        for (i = 0; i < p->n; i++) {
            const quad next = before[i] + 2 * step * slope[i];
            before[i] = now[i];
            now[i] = next;
        }
    }
    p->f(t + h, now, slope, NULL);
    for (i = 0; i < p->n; i++) result[i] = (before[i] + now[i] + step * slope[i]) / 2;
}

/* One extrapolated step; returns its error over 1 + |y| */
static quad extrapolate(const detest_problem *p, quad t, quad h, const quad *y, quad *result)
{
    static state table[COLUMNS];
    quad worst = 0;
    int i, j, k;
    for (j = 0; j < COLUMNS; j++) {
        midpoint(p, t, h, 2 * (j + 1), y, table[j]);
        for (k = j - 1; k >= 0; k--) {
            const quad ratio = (quad)(j + 1) / (k + 1);
            for (i = 0; i < p->n; i++) {
                const quad difference = table[k + 1][i] - table[k][i];
                if (j == COLUMNS - 1 && k == 0) worst = fmaxq(worst, fabsq(difference) / (1 + fabsq(table[1][i])));
                table[k][i] = table[k + 1][i] + difference / (ratio * ratio - 1);
            }
        }
    }
    memcpy(result, table[0], sizeof(state));
    return worst;
}

static void solve(const detest_problem *p, double tolerance, quad *y)
{
    double start[DETEST_LARGEST];
    quad h = 0.01Q;
    state next;
    int i;
    memset(y, 0, sizeof(state));
    detest_start(p, start);
    for (i = 0; i < p->n; i++) y[i] = start[i];
    for (piece = 0; piece < (int)detest_t_end; piece++) {
        quad t = piece, end = piece + 1;
        while (t < end) {
            const int last = t + h >= end;
            const quad step = last ? end - t : h, error = extrapolate(p, t, step, y, next);
            const double factor = 0.9 * pow(tolerance / ((double)error + 1e-40), 1. / (2 * COLUMNS - 1));
            if (error <= tolerance) {
                memcpy(y, next, sizeof(state));
                t = last ? end : t + step;
            }
            if (!last || error > tolerance || factor < 1) h = step * fmin(factor, 3);
        }
    }
}

static void print_number(quad x)
{
    char text[60];
    quadmath_snprintf(text, sizeof text, "%.20Qe", x);
    printf("    %s,\n", text);
}

int main(void)
{
    int i, k, failed = 0;
    puts("/* Written by tests/gen/detest_reference.c: y at t = 20 of the problems of tests/detest.h, one after the other */");
    puts("static const double detest_ends[] = {");
    for (k = 0; k < DETEST_PROBLEMS; k++) {
        const detest_problem *p = detest_problems + k;
        state y, check;
        printf("    /* %s */\n", p->name);
        if (p->f == detest_f5) {
            puts("    1,");
            continue;
        }
        solve(p, 1e-27, y);
        solve(p, 1e-25, check);
        for (i = 0; i < p->n; i++) {
            print_number(y[i]);
            if (!(fabsq(y[i] - check[i]) <= 1e-20Q * (1 + fabsq(y[i])))) {
                fprintf(stderr, "%s: component %d is known to %.1e only\n", p->name, i, (double)fabsq(y[i] - check[i]));
                failed = 1;
            }
        }
    }
    puts("};");
    return failed;
}
