/* routes_problems.h - the problems of data/routes_table.h, whose motions tests/gen/routes_reference.c computes
   without the headers. Include it after oscillator_checks.h. */
#ifndef ROUTES_PROBLEMS_H
#define ROUTES_PROBLEMS_H

/* A problem and its motion at T, in 17 digits. A law has its kind, its numbers a, b, c and, if it is a table, its
   values at T i/20. */
enum { POINTS = 21 };
enum { LAW_LINEAR, LAW_QUADRATIC, LAW_EXPONENTIAL, LAW_POWER, LAW_TABLE, LAW_SINE, LAW_FILL, LAW_BUMP };
enum { NO_FORCE, SPRING, CUBE, VAN_DER_POL, DRAG, COSINE };
typedef struct routes_law {
    int kind;
    double a, b, c, values[POINTS];
} routes_law;
typedef struct routes_case {
    double alpha, reactive, damping;
    routes_law mass, stiffness;
    int force;
    double size, frequency, x0, v0, T, x, v;
} routes_case;
#include "data/routes_table.h"

static inline void law(const vm_law *f, vm_real t, vm_real *value, vm_real *rate)
{
    CHECK(vm_law_at(f, t, value, rate) == VM_OK);
}

/* ---- The problems of the table ---- */

/* The laws that are given as functions */
static inline int function_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const routes_law *l = (const routes_law *)ctx;
    const double z = ((double)t - l->b) / l->c, tail = exp(-z * z), slope = 1 / cosh(z);
    switch (l->kind) {
    case LAW_SINE:
        *f = R(1 + l->a * sin(l->b * (double)t + l->c));
        *rate = R(l->a * l->b * cos(l->b * (double)t + l->c));
        break;
    case LAW_FILL:
        *f = R(1 + l->a * (1 + tanh(z)));
        *rate = R(l->a * slope * slope / l->c);
        break;
    default:
        *f = R(1 + l->a * tail);
        *rate = R(-2 * l->a * z * tail / l->c);
        break;
    }
    return 0;
}

static inline vm_law law_of(const routes_law *l, double T, vm_real *times, vm_real *values)
{
    int i;
    switch (l->kind) {
    case LAW_LINEAR: return vm_law_linear(R(l->a), R(l->b));
    case LAW_QUADRATIC: return vm_law_quadratic(R(l->a), R(l->b), R(l->c));
    case LAW_EXPONENTIAL: return vm_law_exponential(R(l->a), R(l->b));
    case LAW_POWER: return vm_law_power(R(l->a), R(l->b), R(l->c));
    case LAW_TABLE:
        for (i = 0; i < POINTS; i++) {
            times[i] = R(T * i / (POINTS - 1));
            values[i] = R(l->values[i]);
        }
        return vm_law_table(POINTS, times, values);
    default: return vm_law_user(function_law, (void *)l);
    }
}

static inline vm_real force_of(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const routes_case *c = (const routes_case *)ctx;
    switch (c->force) {
    case SPRING: return -R(c->size) * x;
    case CUBE: return -R(c->size) * x * x * x;
    case VAN_DER_POL: return R(c->size) * (1 - x * x) * v;
    case DRAG: return -R(c->size) * v * v * v;
    default: return R(c->size * cos(c->frequency * (double)t));
    }
}

/* The problem of a case. Its tables of mass and stiffness are valid until the next call. */
static inline vm_osc_problem problem_of(const routes_case *c)
{
    static vm_real times[2][POINTS], values[2][POINTS];
    vm_osc_problem o = problem(c->alpha, law_of(&c->mass, c->T, times[0], values[0]), c->reactive, c->damping);
    o.stiffness = law_of(&c->stiffness, c->T, times[1], values[1]);
    o.x = R(c->x0);
    o.v = R(c->v0);
    if (c->force) {
        o.force = force_of;
        o.ctx = (void *)c;
    }
    return o;
}

/* The larger of the error of x relative to A and the error of v relative to vmax, where A and vmax at T are those
   of the motion of the table */
static inline double case_error(const routes_case *c, const vm_osc_problem *o, vm_real x, vm_real v)
{
    const double n = c->alpha + 1;
    vm_real m = 1, k = 1, rate = 0;
    double energy, A, V;
    law(&o->mass, R(c->T), &m, &rate);
    law(&o->stiffness, R(c->T), &k, &rate);
    energy = n / 2 * (double)(m / k) * c->v * c->v + pow(fabs(c->x), n);
    A = pow(energy, 1 / n);
    V = sqrt(2 / n * (double)(k / m) * energy);
    return fmax(fabs((double)x - c->x) / A, fabs((double)v - c->v) / V);
}

#endif
