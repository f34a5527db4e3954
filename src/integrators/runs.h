/* integrators/runs.h - what an adaptive run is: its state, its work and its beginning
   A variable of the type rk45 contains the state of a run, which may be a run by the method rk45 or by the method
   rk87. Its array `work`, which the caller provides, contains arrays of n numbers each, such as y. The functions that
   make and use an rk45 are in rk45.h and rk87.h.

   Tests: tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_RUNS_H
#define VARMASS_INTEGRATORS_RUNS_H

#include <limits.h>

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"

/* An adaptive run. The caller may read the fields from t to options. */
typedef struct VM_TAG(rk45) {
    vm_real t;            /* current time */
    vm_real *y;           /* current state, n numbers (in work) */
    vm_real t_old;        /* the last accepted step is from t_old to t (rk45_interpolate); t_old is t after an error */
    vm_real h;            /* size of the next step to be tried, with its sign; at first the option h0, which may be 0 */
    long steps;           /* number of accepted steps; these counts stop at LONG_MAX */
    long rejected;        /* number of rejected steps */
    long evals;           /* number of evaluations of f */
    long missed;          /* number of steps of the smallest size that were accepted above the tolerance */
    int rhs_status;       /* number that f returned last */
    int event;            /* index of the event that ended the last call, else -1 */
    int stiff;            /* nonzero after the equations have looked stiff (ODE_STIFF) */
    ode_rhs f;            /* the right-hand side */
    void *ctx;            /* pointer that f receives */
    int n;                /* number of components */
    rk45_options options; /* the options, with the defaults in place of zeros */
    /* The fields from here on are internal. */
    vmi_rk_pair pair;
    vm_real *work;
    vm_real t_low;         /* y belongs to the time t + t_low; |t_low| <= ulp(t)/2 */
    vm_real t_old_low;     /* the last step began at the time t_old + t_old_low */
    vm_real h_done;        /* size of the last accepted step */
    vm_real inverse_error; /* tolerance of the last accepted step divided by its error */
    long attempts;         /* number of steps that may still be tried; negative means no limit */
    int k1;                /* where k_1 of the next step is: VMI_K1_MISSING, VMI_K1_READY or VMI_K1_IS_LAST */
    int extended;          /* nonzero if the continuous extension of the last step is ready */
    int failed;            /* 1 if the last attempt to make a step failed, else 0 */
    long next_miss;        /* value of `steps` from which on a step of the smallest size may miss the tolerance again */
    int stiff_wait;        /* number of steps until the next test of stiffness */
    int stiff_hits;        /* number of tests that found stiffness since VMI_STIFF_MISSES tests in a row found none */
    int stiff_misses;      /* number of tests since the last test that found stiffness */
} rk45;

enum { VMI_K1_MISSING, VMI_K1_READY, VMI_K1_IS_LAST };  /* k_1 is unknown, ready, or the last k of the step before */
enum { VMI_STIFF_WAIT = 100 };                          /* accepted steps from one test of stiffness to the next */

/* Returns the part of work with the index `part`, such as VMI_Y: an array of n numbers. */
VM_API vm_real *vmi_part(const rk45 *s, int part) { return s->work + (ptrdiff_t)part * s->n; }

/* Sets the fields of a new run that do not depend on the options or the pair */
VM_API void vmi_init_fields(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, vm_real *work)
{
    s->f = f;
    s->ctx = ctx;
    s->n = n;
    s->work = work;
    s->y = work;
    s->t = t0;
    s->t_old = t0;
    s->t_low = 0;
    s->t_old_low = 0;
    s->h_done = 0;
    s->inverse_error = 1;
    s->steps = 0;
    s->rejected = 0;
    s->evals = 0;
    s->missed = 0;
    s->next_miss = 0;
    s->rhs_status = 0;
    s->event = -1;
    s->k1 = VMI_K1_MISSING;
    s->extended = 0;
    s->failed = 0;
    s->stiff = 0;
    s->stiff_wait = VMI_STIFF_WAIT;
    s->stiff_hits = 0;
    s->stiff_misses = 0;
}

/* Sets the fields of an event that belong to the integrator to their first values. An earlier run may have used the
   event. */
VM_API void vmi_init_event(ode_event *e, vm_real t0)
{
    e->count = 0;
    e->t = t0;
    e->side = 0;
    e->side_ahead = 0;
    e->slack_ahead = 0;
    e->quiet_ahead = 0;
    e->happens = 0;
    e->from = 0;
    e->slack = 0;
    e->quiet = 0;
}

/* Does the work of rk45_init for any pair */
VMI_APART int vmi_init(rk45 *s, const vmi_rk_pair *pair, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                       const rk45_options *options_or_NULL, vm_real *work)
{
    const rk45_options o = vmi_defaults(vmi_least_rtol(pair), options_or_NULL);
    const int is_raised = options_or_NULL && options_or_NULL->rtol > 0 && options_or_NULL->rtol < o.rtol;
    int i;
    if (!s || !f || n <= 0 || !y0 || !work || !VM_IS_FINITE(t0) || !vmi_all_finite(n, y0) ||
        !vmi_options_are_valid(&o, n))
        return ODE_BAD_ARGUMENT;
    if (o.work_size && o.work_size < (long)(VMI_K + pair->derivatives) * n) return ODE_WORK_TOO_SMALL;
    for (i = 0; i < o.n_events; i++) vmi_init_event(o.events + i, t0);
    vmi_init_fields(s, f, ctx, n, t0, work);
    s->pair = *pair;
    s->options = o;
    s->h = o.h0;
    s->attempts = o.max_steps;
    vmi_copy(n, y0, s->y);
    for (i = n; i < (VMI_K + pair->derivatives) * n; i++) work[i] = 0; /* then all bytes of a saved run are defined */
    return is_raised ? (int)ODE_RTOL_RAISED : (int)ODE_OK;
}

/* Computes the state y = y_old + h (b[0] k_1 + b[1] k_2 + ...) at the fraction x of the last step; the sum in brackets
   has `count` terms. The weights b add up to x. Therefore the sum is equal to x k_1 plus the terms b[j] (k_{j+1} -
   k_1). It is computed in this form, because the differences make the rounding errors smaller. */
VM_INLINE void vmi_weigh_inside(const rk45 *s, int count, const vm_real *b, vm_real x, vm_real *y)
{
    const vm_real *y_old = vmi_part(s, VMI_Y_OLD), *k1 = vmi_part(s, VMI_K);
    int i, j;
    for (i = 0; i < s->n; i++) {
        vm_real sum = 0;
        for (j = 1; j < count; j++) sum += b[j] * (vmi_part(s, VMI_K + j)[i] - k1[i]);
        y[i] = y_old[i] + s->h_done * (x * k1[i] + sum);
    }
}

/* Returns count + more for count >= 0, or LONG_MAX if this sum is larger. On many machines the type long has 32 bits,
   and a long run may take more steps than such a number can count. */
VM_API long vmi_count(long count, long more)
{
    if (more > 0 && count > LONG_MAX - more) return LONG_MAX;
    return count + more;
}

/* Evaluates k = f(t, y) and counts this evaluation. Returns a status. */
VM_API int vmi_eval(rk45 *s, vm_real t, const vm_real *y, vm_real *k)
{
    s->evals = vmi_count(s->evals, 1);
    s->rhs_status = s->f(t, y, k, s->ctx);
    return s->rhs_status ? ODE_RHS_STOPPED : ODE_OK;
}

#endif
