/* Which embedded pair of orders 5 and 4? Evaluations of the right-hand side that Dormand and Prince's and Tsitouras'
   pair take to an error at the end, with the same control (rk45's) and read off by interpolation over tolerances from
   1e-3 to 1e-12.5. No time is measured: the ratios are those of evaluations.
   usage: pairs [out.csv] */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "problems.h"

typedef struct pair {
    const char *name;
    double a[7][6], c[7], error[7];
} pair;

static const pair pairs[2] = {
    {"Dormand-Prince",
     {{0},
      {1. / 5},
      {3. / 40, 9. / 40},
      {44. / 45, -56. / 15, 32. / 9},
      {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
      {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
      {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}},
     {0, 0.2, 0.3, 0.8, 8. / 9, 1, 1},
     {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40}},
    {"Tsitouras",
     {{0},
      {0.161},
      {-0.008480655492356989, 0.335480655492357},
      {2.8971530571054935, -6.359448489975075, 4.3622954328695815},
      {5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525},
      {5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401, -0.028269050394068383},
      {0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081, 2.324710524099774}},
     {0, 0.161, 0.327, 0.9, 0.9800255409045097, 1, 1},
     {-0.00178001105222577714, -0.0008164344596567469, 0.007880878010261995, -0.1447110071732629,
      0.5823571654525552, -0.45808210592918697, 1. / 66}},
};

/* The stages k of a step of size s, and the new state z; returns the evaluations */
static int stages(const pair *p, const problem *q, double t, double s, const double *y, double *z, double k[7][4])
{
    int i, j, l;
    for (i = 1; i < 7; i++) {
        for (j = 0; j < q->n; j++) {
            z[j] = y[j];
            for (l = 0; l < i; l++) z[j] += s * p->a[i][l] * k[l][j];
        }
        q->f(t + p->c[i] * s, z, k[i]);
    }
    return 6;
}

static double error_over_tolerance(const pair *p, int n, double s, double tol, const double *y, const double *z,
                                   double k[7][4])
{
    double e = 0;
    int j, l;
    for (j = 0; j < n; j++) {
        double sum = 0;
        for (l = 0; l < 7; l++) sum += p->error[l] * k[l][j];
        e = fmax(e, fabs(s * sum) / (tol + tol * fmax(fabs(y[j]), fabs(z[j]))));
    }
    return e;
}

/* y at T; returns the evaluations */
static long integrate(const pair *p, const problem *q, double tol, double *y)
{
    double k[7][4], z[4], t = 0, h = 1e-3, before = 1e-4, e, factor;
    long evals = 1;
    int rejected = 0;
    memcpy(y, q->y0, sizeof z);
    q->f(0, y, k[0]);
    for (;;) {
        int last = t + 1.000001 * h >= q->T;
        double s = last ? q->T - t : h;
        evals += stages(p, q, t, s, y, z, k);
        e = error_over_tolerance(p, q->n, s, tol, y, z, k);
        if (e > 1) {
            h = s * fmax(0.2, 0.9 * pow(e, -0.2));
            rejected = 1;
            continue;
        }
        factor = fmin(10, fmax(0.2, 0.9 * pow(fmax(e, 1e-8), -0.17) * pow(before, 0.04)));
        h = s * (rejected ? fmin(factor, 1) : factor);
        before = fmax(e, 1e-4);
        rejected = 0;
        t += s;
        memcpy(y, z, sizeof z);
        memcpy(k[0], k[6], sizeof k[0]);
        if (last) return evals;
    }
}

enum { TOLERANCES = 20 };

/* Evaluations to the error 10^goal; 0 where the tolerances do not reach it */
static double evaluations_to(double goal, const double *log_error, const double *log_evals)
{
    int i;
    for (i = 0; i + 1 < TOLERANCES; i++)
        if (log_error[i] > goal && log_error[i + 1] <= goal)
            return pow(10, log_evals[i] + (goal - log_error[i]) / (log_error[i + 1] - log_error[i]) *
                                              (log_evals[i + 1] - log_evals[i]));
    return 0;
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    int i, j, k, goal;
    if (csv) fputs("topic,job,route,knob,error,evaluations,ratio\n", csv);
    printf("pairs: evaluations to an error at the end, %s/%s = ratio\n\n", pairs[1].name, pairs[0].name);
    for (i = 0; i < PROBLEMS; i++) {
        double y[4], log_error[2][TOLERANCES], log_evals[2][TOLERANCES];
        for (k = 0; k < 2; k++)
            for (j = 0; j < TOLERANCES; j++) {
                log_evals[k][j] = log10((double)integrate(pairs + k, problems + i, pow(10, -3 - 0.5 * j), y));
                log_error[k][j] = log10(error_at_end(problems + i, y));
            }
        printf("%-9s", problems[i].name);
        for (goal = -4; goal >= -9; goal--) {
            const double dp = evaluations_to(goal, log_error[0], log_evals[0]);
            const double ts = evaluations_to(goal, log_error[1], log_evals[1]);
            if (!(dp > 0 && ts > 0)) continue;
            printf("  1e%d: %.0f/%.0f = %.2f", goal, ts, dp, ts / dp);
            if (csv)
                fprintf(csv, "pairs,%s to 1e%d,Tsitouras,,1e%d,%.0f,%.3f\n", problems[i].name, goal, goal, ts,
                        ts / dp);
        }
        puts("");
    }
    return csv && fclose(csv) != 0;
}
