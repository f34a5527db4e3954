/* motion_cases.h - what the programs share that write tables of motions of motion_reference.h: random numbers of single
   precision, and one row of a table. REAL is long double. Include it after motion_reference.h. */
#ifndef MOTION_CASES_H
#define MOTION_CASES_H

enum { POINTS = 21 };

static unsigned long long state = 2026;
static double uniform(double low, double high)
{
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return (float)(low + (high - low) * ((double)(state >> 11) / 9007199254740992.0));
}
static double spread(double low, double high) { return (float)exp(uniform(log(low), log(high))); }

static void print_law(const ref_law *l)
{
    int i;
    printf("{%d, %.17g, %.17g, %.17g, {", l->kind, l->a, l->b, l->c);
    for (i = 0; i < l->n; i++) printf("%s%.17g", i ? ", " : "", l->value[i]);
    printf(l->n ? "}}" : "0}}");
}

/* The motion from *start, whose P is x' at first, with the tolerances `strict` and 100 times that: x and x' at the times
   t[0] < t[1] ..., n of them. Returns the largest difference of both, infinity where one failed. */
static REAL follow_twice(ref_motion *start, REAL strict, int n, const double *t, REAL *x, REAL *v)
{
    ref_motion o, again;
    REAL worst = 0;
    int i;
    if (start->mass.kind == REF_TABLE) start->mass.piece = 0;
    if (start->stiffness.kind == REF_TABLE) start->stiffness.piece = 0;
    ref_choose_piece(&start->mass, 0);
    ref_choose_piece(&start->stiffness, 0);
    o = *start;
    o.P *= REAL_POW(ref_law_at(&o.mass, 0), o.r);
    again = o;
    o.tolerance = strict;
    again.tolerance = 100 * strict;
    for (i = 0; i < n; i++) {
        REAL difference;
        ref_follow(&o, t[i]);
        ref_follow(&again, t[i]);
        difference = REAL_FABS(o.x - again.x) + REAL_FABS(o.P - again.P);
        if (o.failed || again.failed) return HUGE_VAL;
        if (!(difference <= worst)) worst = difference;
        x[i] = o.x;
        v[i] = o.P / REAL_POW(ref_law_at(&o.mass, t[i]), o.r);
    }
    return worst;
}

/* A row of the type routes_case of tests/routes_problems.h */
static void print_case(const ref_motion *start, double T, REAL x, REAL v)
{
    printf("{%.17g, %.17g, %.17g, ", (double)start->alpha, (double)start->r, (double)start->damping);
    print_law(&start->mass);
    printf(", ");
    print_law(&start->stiffness);
    printf(", %d, %.17g, %.17g, %.17g, %.17g, %.17g, %.19Lg, %.19Lg}", start->force, start->size, start->frequency,
           (double)start->x, (double)start->P, T, x, v);
}

#endif
