/* random_routes.h - random oscillators with variable mass, their motions by vm_osc_plan_within and by single routes, and
   how these compare with the exact motion: tests/test_routes.c tries some, tests/random_routes.c thousands. Include it after
   exact_motion.h. */
#ifndef RANDOM_ROUTES_H
#define RANDOM_ROUTES_H
#include <stdlib.h>

/* ---- Problems ---- */

typedef struct random_numbers {
    unsigned long long state;
} random_numbers;

static inline double draw_uniform(random_numbers *g, double low, double high)
{
    g->state = g->state * 6364136223846793005ull + 1442695040888963407ull;
    return low + (high - low) * ((double)(g->state >> 11) / 9007199254740992.0);
}

/* Uniform in the logarithm */
static inline double draw_spread(random_numbers *g, double low, double high)
{
    return exp(draw_uniform(g, log(low), log(high)));
}

static inline int draw_chance(random_numbers *g, double share) { return draw_uniform(g, 0, 1) < share; }

/* A law of any kind, positive from 0 to T, whose rate is of the size `rate`. FILL and BUMP change in a part of the run that
   may be shorter than a vibration. */
static inline routes_law draw_law(random_numbers *g, double rate, double T)
{
    const double growth = rate * (draw_chance(g, 0.5) ? draw_uniform(g, -0.3, 0) : draw_uniform(g, 0, 1));
    const double phase = draw_uniform(g, 0, 6);
    routes_law l;
    int i;
    memset(&l, 0, sizeof l);
    l.kind = (int)draw_uniform(g, LAW_LINEAR, LAW_BUMP + 1);
    l.a = 1;
    l.b = growth;
    switch (l.kind) {
    case LAW_QUADRATIC: l.c = rate * rate * draw_uniform(g, 0.05, 0.3); break;
    case LAW_POWER: l.c = draw_uniform(g, -2, 2); break;
    case LAW_TABLE:
        for (i = 0; i < POINTS; i++) l.values[i] = 1 + 0.4 * sin(rate * T * i / (POINTS - 1) + phase);
        break;
    case LAW_SINE:
        l.a = draw_uniform(g, -0.5, 0.5);
        l.b = rate;
        l.c = phase;
        break;
    case LAW_FILL:
    case LAW_BUMP:
        l.a = draw_spread(g, 0.02, 0.6);
        l.b = draw_uniform(g, 0, T);
        l.c = draw_spread(g, T / 800, T / 3);
        break;
    default: break;
    }
    return l;
}

/* A time of about T whose multiples by 1/20, the times of tables, are numbers of double precision */
static inline double draw_end(double T) { return floor(T / 20 * 4096 + 1) / 4096 * 20; }

/* A problem without a force: alpha is a fraction from 0 to 10, the laws change at the rate `rate`, per second. */
static inline routes_case draw_case(random_numbers *g, double rate, double T)
{
    const int bottom = 1 << (int)draw_uniform(g, 0, 4);
    const double amplitude = draw_spread(g, 0.6, 1.6), angle = draw_uniform(g, 0, 2 * pi);
    routes_case c;
    memset(&c, 0, sizeof c);
    c.alpha = floor(draw_uniform(g, 0, 10 * bottom + 1)) / bottom;
    c.T = T;
    c.mass = draw_law(g, rate, T);
    c.stiffness.a = 1;
    if (draw_chance(g, 0.4)) c.stiffness = draw_law(g, rate, T);
    c.reactive = draw_chance(g, 0.5) ? draw_chance(g, 0.5) : draw_uniform(g, 0, 1);
    if (draw_chance(g, 0.6)) c.damping = rate * draw_uniform(g, -0.5, 0.5);
    c.x0 = amplitude * cos(angle);
    c.v0 = amplitude * sin(angle);
    if (draw_chance(g, 0.1)) c.x0 = 0;
    else if (draw_chance(g, 0.1)) c.v0 = 0;
    return c;
}

/* ---- The same motion in reversed time ---- */

static inline routes_law reversed_law(const routes_law *l)
{
    routes_law r = *l;
    int i;
    if (l->kind != LAW_TABLE) r.b = -l->b;
    if (l->kind == LAW_FILL) r.c = -l->c;
    for (i = 0; i < POINTS; i++) r.values[i] = l->values[POINTS - 1 - i];
    return r;
}

/* The problem whose motion at -t is that of c at t, with the velocity reversed; its case goes to *back. Valid until the next
   call. */
static inline vm_osc_problem reversed_problem(const routes_case *c, routes_case *back)
{
    static vm_real times[POINTS];
    vm_osc_problem o;
    vm_law *laws[2];
    int i;
    *back = *c;
    back->mass = reversed_law(&c->mass);
    back->stiffness = reversed_law(&c->stiffness);
    back->damping = -c->damping;
    back->v0 = -c->v0;
    back->v = -c->v;
    o = problem_of(back);
    laws[0] = &o.mass;
    laws[1] = &o.stiffness;
    for (i = 0; i < POINTS; i++) times[i] = R(c->T * i / (POINTS - 1) - c->T);
    for (i = 0; i < 2; i++)
        if (laws[i]->time) laws[i]->time = times;
    back->T = -c->T;
    return o;
}

/* ---- How good the results are ---- */

/* What is counted of the results of one route. `ratio` holds the true errors divided by the estimates. */
enum { RANDOM_MOST = 20000 };
typedef struct random_tally {
    const char *name;
    int runs, ok;       /* results, and those with VM_OK */
    int failed, unseen; /* calls without a result, and results whose errors are too small to be seen */
    int unknown;        /* results whose estimate is infinite */
    int above;          /* results with VM_OK whose true error is above the tolerance */
    int n;
    double *ratio;
} random_tally;

static inline void random_count(random_tally *tally, int status, double tolerance, double error, double estimate,
                                double own_error)
{
    if (status < 0) {
        tally->failed++;
        return;
    }
    tally->runs++;
    if (status == VM_OK) {
        tally->ok++;
        tally->above += tolerance > 0 && !(error <= tolerance + own_error);
    }
    if (estimate > 0.25) tally->unknown++; /* of the integrations, too, since more is lost */
    else if (error < 10 * own_error && estimate < 10 * own_error) tally->unseen++;
    else tally->ratio[tally->n++] = error / estimate;
}

static inline int random_rising(const void *a, const void *b)
{
    const double d = *(const double *)a - *(const double *)b;
    if (d < 0) return -1;
    return d > 0;
}

/* How many of the ratios are above a bound */
static inline int random_above(const random_tally *tally, double bound)
{
    int i, above = 0;
    for (i = 0; i < tally->n; i++) above += !(tally->ratio[i] <= bound);
    return above;
}

static inline double random_worst(const random_tally *tally)
{
    double worst = 0;
    int i;
    for (i = 0; i < tally->n; i++)
        if (!(tally->ratio[i] <= worst)) worst = tally->ratio[i];
    return worst;
}

#endif
