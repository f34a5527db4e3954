/* judgement.h - what estimates of errors are worth: many true errors beside what the kit estimates. Include it after
   check.h. */
#ifndef JUDGEMENT_H
#define JUDGEMENT_H
#include <stdlib.h>

static inline int rising(const void *a, const void *b)
{
    const double d = *(const double *)a - *(const double *)b;
    return d < 0 ? -1 : d > 0;
}

static inline double median(double *values, int n)
{
    qsort(values, (size_t)n, sizeof *values, rising);
    return values[n / 2];
}

/* True errors and their estimates, one by one */
typedef struct judgement {
    double *sharp;  /* estimate divided by true error, `count` numbers */
    int count;
    int beyond;     /* how many true errors are larger than three estimates */
    int unknown;    /* how many errors the kit calls unknown; the caller counts them */
    double worst;   /* the largest quotient of a true error and its estimate */
} judgement;

/* Adds a true error and its estimate. */
static inline void judge(judgement *j, double error, double estimate)
{
    j->sharp[j->count++] = estimate / fmax(error, 1e-300);
    j->worst = fmax(j->worst, error / estimate);
    j->beyond += error > 3 * estimate;
}

/* Checks what the estimates are worth. sharp: the largest allowed median of estimate by true error; unknown: the
   largest allowed share of unknown errors, in %. */
static inline void report(const char *name, judgement *j, double sharp, double unknown)
{
    check_error(name, "true > 3 est", "%", 100. * j->beyond / j->count, 1, j->count, 0);
    check_error(name, "true/est, worst", "", j->worst, 10, 0, 0);
    check_error(name, "unknown", "%", 100. * j->unknown / (j->count + j->unknown), unknown, j->unknown, 0);
    check_error(name, "est/true, median", "", median(j->sharp, j->count), sharp, 0, 0);
}

#endif
