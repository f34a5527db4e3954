/* slow_motions.h - the motions of data/slow_motions.h, which tests/gen/slow_motion_reference.c computes without the
   headers, at four times each, forward and backward. Include it after routes_problems.h. */
#ifndef SLOW_MOTIONS_H
#define SLOW_MOTIONS_H
#include <stdlib.h>

#define COUNT(cases) ((int)(sizeof(cases) / sizeof *(cases)))

/* A problem with its motion at T, and the motion at slow_parts of T. The second of these times and the last are points
   of tables. */
enum { TIMES = 4 };
static const double slow_parts[TIMES] = {33. / 40, 34. / 40, 37. / 40, 1};
typedef struct slow_case {
    routes_case c;
    double x[TIMES], v[TIMES];
} slow_case;
#include "data/slow_motions.h"

static inline double slow_time(const slow_case *s, int i) { return s->c.T * slow_parts[i]; }

/* The larger of the error of x relative to A and the error of v relative to vmax at time number i */
static inline double slow_error(const slow_case *s, const vm_osc_problem *o, int i, const vm_osc_motion *motion)
{
    routes_case c = s->c;
    c.T = slow_time(s, i);
    c.x = s->x[i];
    c.v = s->v[i];
    return case_error(&c, o, motion->x, motion->v);
}

/* ---- The same motion with another start ---- */

static inline routes_law moved_law(const routes_law *l, double t)
{
    routes_law moved = *l;
    switch (l->kind) {
    case LAW_LINEAR: moved.a = l->a + l->b * t; break;
    case LAW_QUADRATIC:
        moved.a = l->a + t * (l->b + l->c * t);
        moved.b = l->b + 2 * l->c * t;
        break;
    case LAW_EXPONENTIAL: moved.a = l->a * exp(l->b * t); break;
    case LAW_POWER:
        moved.a = l->a * pow(1 + l->b * t, l->c);
        moved.b = l->b / (1 + l->b * t);
        break;
    case LAW_SINE: moved.c = l->c + l->b * t; break;
    default: break;
    }
    return moved;
}

/* The case whose time 0 is time number i of *s, and the problem of it. Its motion at -slow_time(s, i) is the start of
   *s. Valid until the next call; a cosine force is not moved. */
static inline vm_osc_problem slow_from(const slow_case *s, int i, routes_case *c)
{
    static vm_real times[2][POINTS];
    const double start = slow_time(s, i);
    vm_osc_problem o;
    vm_law *laws[2];
    int j, k;
    *c = s->c;
    c->mass = moved_law(&s->c.mass, start);
    c->stiffness = moved_law(&s->c.stiffness, start);
    c->x0 = s->x[i];
    c->v0 = s->v[i];
    c->T = -start;
    c->x = s->c.x0;
    c->v = s->c.v0;
    o = problem_of(c);
    laws[0] = &o.mass;
    laws[1] = &o.stiffness;
    for (k = 0; k < 2; k++)
        if (laws[k]->time) {
            for (j = 0; j < POINTS; j++) times[k][j] = R(s->c.T * j / (POINTS - 1) - start);
            laws[k]->time = times[k];
        }
    return o;
}

#endif
