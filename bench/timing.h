/* Timing shared by the bench programs; include it before any header of the C library. Medians of repeats, a function
   always beside a yardstick, so that what slows the machine slows both. */
#ifndef VARMASS_TIMING_H
#define VARMASS_TIMING_H

#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 199309L
#endif
#include <stdlib.h>
#include <time.h>

enum { REPEATS = 15 };

typedef struct timing {
    double ns, ratio; /* of a call, and to a call of the yardstick */
} timing;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x)
{
    qsort(x, REPEATS, sizeof *x, ascending);
    return x[REPEATS / 2];
}

/* A call of body, which makes so many, from as many runs of it as take a millisecond and more */
static double call_ns(void (*body)(void), double calls)
{
    double start, elapsed;
    int run, runs = 1;
    body(); /* warm up */
    do {
        for (start = seconds(), run = 0; run < runs; run++) body();
        elapsed = seconds() - start;
        runs *= 2;
    } while (elapsed < 1e-3);
    return elapsed / (runs / 2) / calls * 1e9;
}

/* Medians of the time of a call of body, and of its ratio to a call of the yardstick measured just before */
static timing time_beside(void (*body)(void), double calls, void (*yardstick)(void), double yardstick_calls)
{
    double ns[REPEATS], ratio[REPEATS];
    timing result;
    int i;
    for (i = 0; i < REPEATS; i++) {
        double base = call_ns(yardstick, yardstick_calls);
        ns[i] = call_ns(body, calls);
        ratio[i] = ns[i] / base;
    }
    result.ns = median(ns);
    result.ratio = median(ratio);
    return result;
}

#endif
