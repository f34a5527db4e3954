/* timing.h - what the bench programs share: the clock, a line of the table, a line of the CSV file. Include it before
   any header of the C library.

   A function is always timed beside a yardstick (the C library's sin, a hand-written loop). After a warm-up, slices
   of 0.1 ms and more of the one and the other take turns. The least of SLICES slices of each makes a repeat: what
   disturbs only adds, and few disturbances last as long. The median of REPEATS repeats is the result, of the times
   and of the quotients; `spread` is the distance between the quartiles of the quotients, by their median.

   A program is called as `program [out.csv [quick]]`: bench_start, a `measure` for each line, bench_end. The
   columns of the CSV: topic, job, route, knob, error, ns, ratio, spread, yardstick; job: what is computed of which
   arguments, route: by what, knob: the setting by which the route trades accuracy for time, if it has one (; for ,
   in all of them). error: the largest, empty where none is measured. */
#ifndef VARMASS_TIMING_H
#define VARMASS_TIMING_H

#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200112L
#endif
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#ifndef TOPIC
#define TOPIC "bench" /* the name of the program, by its build */
#endif

enum { REPEATS = 15, SLICES = 7, QUICK_REPEATS = 3, QUICK_SLICES = 3 };
static const double SLICE = 1e-4, LONGEST = 0.5; /* seconds: of a slice at least, of a measurement about at most */

typedef struct timing {
    double ns, ratio; /* of a call, and to a call of the yardstick */
    double spread;    /* distance of the quartiles of ratio, by ratio */
} timing;

static const double NO_ERROR = -1; /* none was measured; NAN: what the function gave was no number */
static FILE *bench_csv;
static int bench_quick;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); /* what other processes take does not count */
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the next run finds its arguments (arguments.h): runs go through all of them, but one that fills a slice alone
   has the same ones each time, lest the least slice be that of the easiest arguments. */
static int bench_position;

static double slice(void (*body)(void), long runs)
{
    const double start = seconds();
    long run;
    if (runs == 1) bench_position = 0;
    for (run = 0; run < runs; run++) body();
    return (seconds() - start) / (double)runs;
}

/* As many runs of body as take a slice; the better of two tries, lest a disturbance makes them few. Warms up too. */
static long runs_of(void (*body)(void))
{
    long runs = 1;
    while (fmin(slice(body, runs), slice(body, runs)) * (double)runs < SLICE) runs *= 2;
    return runs;
}

/* Quartile 1, 2 or 3 of n numbers in order */
static double quartile(const double *x, int n, int which) { return x[(n - 1) * which / 4]; }

/* Nanoseconds of a call of body, which makes so many, and their quotient by those of a call of the yardstick */
static timing time_beside(void (*body)(void), double calls, void (*yardstick)(void), double yardstick_calls)
{
    const int repeats = bench_quick ? QUICK_REPEATS : REPEATS, slices = bench_quick ? QUICK_SLICES : SLICES;
    const long runs = runs_of(body), yardstick_runs = runs_of(yardstick);
    const double start = seconds();
    double ns[REPEATS], ratio[REPEATS];
    timing result;
    int n, k;
    for (n = 0; n < repeats && (n < 3 || seconds() - start < LONGEST); n++) {
        double least = HUGE_VAL, base = HUGE_VAL;
        for (k = 0; k < slices && (k < 2 || seconds() - start < LONGEST); k++) {
            base = fmin(base, slice(yardstick, yardstick_runs));
            least = fmin(least, slice(body, runs));
        }
        ns[n] = least / calls * 1e9;
        ratio[n] = ns[n] / (base / yardstick_calls * 1e9);
    }
    qsort(ns, (size_t)n, sizeof *ns, ascending);
    qsort(ratio, (size_t)n, sizeof *ratio, ascending);
    result.ns = quartile(ns, n, 2);
    result.ratio = quartile(ratio, n, 2);
    result.spread = (quartile(ratio, n, 3) - quartile(ratio, n, 1)) / result.ratio;
    return result;
}

/* Nanoseconds of a call of body, which makes so many: for what needs no yardstick */
static inline double call_ns(void (*body)(void), double calls) { return time_beside(body, calls, body, calls).ns; }

/* ---- Programs ------------------------------------------------------------------------------------------------- */

/* What runs, to the screen and not into the output */
static inline void progress(const char *what)
{
    if (isatty(2)) fprintf(stderr, "\r%-78s\r", what);
}

/* Opens the CSV file where one is named and prints the heading. */
static inline void bench_start(int argc, char **argv, const char *title)
{
    bench_quick = argc > 2 && strcmp(argv[2], "quick") == 0;
    bench_csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    if (argc > 1 && !bench_csv) {
        perror(argv[1]);
        exit(1);
    }
    if (bench_csv) fputs("topic,job,route,knob,error,ns,ratio,spread,yardstick\n", bench_csv);
    fprintf(stderr, "%s ...\n", TOPIC);
    printf("%s: %s\n\n%-34s %-26s %-9s %9s %12s %9s %6s\n", TOPIC, title, "job", "route", "knob", "error", "ns",
           "ratio", "spread");
}

/* A field of the CSV file, where a comma ends it */
static inline void bench_write(const char *field)
{
    for (; *field; field++) putc(*field == ',' ? ';' : *field, bench_csv);
    putc(',', bench_csv);
}

/* A line of the CSV file; knob: "" or a setting; error: NO_ERROR where none was measured */
static inline void bench_write_row(const char *job, const char *route, const char *knob, double error, timing t,
                                   const char *yardstick)
{
    if (!bench_csv) return;
    bench_write(TOPIC);
    bench_write(job);
    bench_write(route);
    bench_write(knob);
    if (!(error < 0)) fprintf(bench_csv, "%.2g", error);
    fprintf(bench_csv, ",%.4g,%.4g,%.3g,%s\n", t.ns, t.ratio, t.spread, yardstick);
}

/* The same, and a line of the table */
static inline void bench_row(const char *job, const char *route, const char *knob, double error, timing t,
                             const char *yardstick)
{
    char number[16] = "";
    if (!(error < 0)) snprintf(number, sizeof number, "%.2g", error);
    progress("");
    printf("%-34s %-26s %-9s %9s %12.2f %9.3f %5.1f%% x %s\n", job, route, knob, number, t.ns, t.ratio,
           100 * t.spread, yardstick);
    fflush(stdout);
    bench_write_row(job, route, knob, error, t, yardstick);
}

/* In one process of twenty sin has been seen to take 26 ns instead of 8 beside some bodies, slice after slice.
   Where it takes more than 1.25 times its best in this process, the best is what the ratio is to. */
static inline void mend_yardstick(timing *t, double *best)
{
    const double yardstick_ns = t->ns / t->ratio;
    *best = *best > 0 ? fmin(*best, yardstick_ns) : yardstick_ns;
    if (yardstick_ns > 1.25 * *best) t->ratio = t->ns / *best;
}

/* Times body beside a yardstick, with its line */
static inline timing measure(const char *job, const char *route, const char *knob, double error, void (*body)(void),
                             double calls, const char *yardstick_name, void (*yardstick)(void),
                             double yardstick_calls)
{
    static double best_sin, best_sin_in_chain;
    timing t;
    progress(route);
    t = time_beside(body, calls, yardstick, yardstick_calls);
    if (strcmp(yardstick_name, "sin") == 0) mend_yardstick(&t, &best_sin);
    if (strcmp(yardstick_name, "sin (chain)") == 0) mend_yardstick(&t, &best_sin_in_chain);
    bench_row(job, route, knob, error, t, yardstick_name);
    return t;
}

/* The exit status: 0, or 1 where the CSV file could not be written */
static inline int bench_end(void)
{
    progress("");
    putchar('\n');
    if (!bench_csv || fclose(bench_csv) == 0) return 0;
    perror("CSV");
    return 1;
}

#endif
