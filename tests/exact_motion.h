/* exact_motion.h - the exact motion of a routes_case at many times, by gen/motion_reference.h, which shares no code with
   the headers under test. It stops at each zero of x, where the force k x|x|^(alpha-1) has no derivatives for most alpha.
   alpha must be a fraction whose denominator is at most 8. The numbers are double, or long double where EXACT_LONG is
   defined. Include it after routes_problems.h. */
#ifndef EXACT_MOTION_H
#define EXACT_MOTION_H
#ifdef EXACT_LONG
typedef long double REAL;
#define REAL_POW powl
#define REAL_EXP expl
#define REAL_SIN sinl
#define REAL_COS cosl
#define REAL_TANH tanhl
#define REAL_SQRT sqrtl
#define REAL_FABS fabsl
#else
typedef double REAL;
#define REAL_POW pow
#define REAL_EXP exp
#define REAL_SIN sin
#define REAL_COS cos
#define REAL_TANH tanh
#define REAL_SQRT sqrt
#define REAL_FABS fabs
#endif
#include "gen/motion_reference.h"

typedef struct exact_motion {
    routes_case c;        /* its x, v and T are the motion at the time that exact_follow has reached */
    double times[POINTS]; /* of tables, which end at the T with which the motion was started */
    ref_motion ref;
} exact_motion;

static inline ref_law exact_law(const exact_motion *e, const routes_law *l)
{
    ref_law law;
    memset(&law, 0, sizeof law);
    law.kind = l->kind; /* LAW_... and REF_... are in the same order */
    law.a = l->a;
    law.b = l->b;
    law.c = l->c;
    if (l->kind == LAW_TABLE) {
        law.n = POINTS;
        law.time = e->times;
        law.value = l->values;
    }
    return law;
}

/* Starts the motion of e->c, whose fields are set but for x and v. The tolerance is that of each step. */
static inline void exact_start(exact_motion *e, REAL tolerance)
{
    ref_motion *r = &e->ref;
    int i;
    memset(r, 0, sizeof *r);
    for (i = 0; i < POINTS; i++) e->times[i] = e->c.T * i / (POINTS - 1);
    for (r->bottom = 1; r->bottom < 8; r->bottom++)
        if (fabs(e->c.alpha * r->bottom - floor(e->c.alpha * r->bottom + 0.5)) < 1e-12) break;
    r->top = (int)floor(e->c.alpha * r->bottom + 0.5);
    r->alpha = (REAL)r->top / (REAL)r->bottom;
    r->r = e->c.reactive;
    r->damping = e->c.damping;
    r->mass = exact_law(e, &e->c.mass);
    r->stiffness = exact_law(e, &e->c.stiffness);
    r->force = e->c.force;
    r->size = e->c.size;
    r->frequency = e->c.frequency;
    r->tolerance = tolerance;
    r->x = e->c.x0;
    ref_choose_piece(&r->mass, 0);
    ref_choose_piece(&r->stiffness, 0);
    r->P = e->c.v0 * REAL_POW(ref_law_at(&r->mass, 0), r->r);
}

/* Follows the motion to t, later than before. Returns 0 where it was lost. */
static inline int exact_follow(exact_motion *e, double t)
{
    ref_follow(&e->ref, t);
    e->c.T = t;
    e->c.x = (double)e->ref.x;
    e->c.v = (double)(e->ref.P / REAL_POW(ref_law_at(&e->ref.mass, t), e->ref.r));
    return !e->ref.failed;
}

#endif
