/* integrators/runs.h - what an adaptive run is: options, state, work space */
#ifndef VARMASS_INTEGRATORS_RUNS_H
#define VARMASS_INTEGRATORS_RUNS_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"

/* An event is a change of sign of g(t, y) along a run; a zero is reached, not left, when it counts. The caller owns
   the array of events that the options point at; the fields up to states are his, the rest is the integrator's. */
typedef vm_real (*ode_event_function)(vm_real t, const vm_real *y, void *ctx);

typedef struct VM_TAG(ode_event) {
    ode_event_function g;
    void *ctx;
    int direction; /* as the run goes: > 0 when g rises through zero, < 0 when it falls, 0 both */
    int action;    /* ODE_RECORD, ODE_STOP or ODE_RESTART */
    int checks;    /* g is looked at in so many points inside each step; default 3, at most 9999, negative none */
    /* null, or what an ODE_RESTART calls; it may change y, and in ctx what f depends on */
    void (*change)(vm_real t, vm_real *y, void *ctx);
    long room;      /* of times and states, either of which may be null: the first room events are written there, */
    vm_real *times; /* one time each */
    vm_real *states; /* and n values each */
    long count;      /* events so far */
    vm_real t;       /* of the last one */
    int side;        /* internal from here on: the sign of g behind us, 0 while it is not known */
    int side_ahead;  /* the side at the end of the step, if the step is not cut */
    int happens;     /* nonzero while the step is cut at an instant at which this event happens */
    vm_real from;    /* g has been looked at up to here, as a fraction of the step */
    vm_real slack;   /* after an event the side stays unknown while |g| <= slack, */
    vm_real quiet;   /* but no longer than for this time */
} ode_event;

enum {
    ODE_RECORD = 0, /* go on */
    ODE_STOP = 1,   /* a terminal event: the run ends there with ODE_EVENT */
    ODE_RESTART = 2 /* the step ends there, change is called, and a new step begins */
};

typedef struct VM_TAG(rk45_options) {
    vm_real rtol;             /* default 1e-6 (float 1e-4) */
    vm_real atol;             /* default 1e-3 rtol */
    vm_real h0;               /* first step; default chosen from f. Its sign is rk45_step's direction */
    vm_real h_min, h_max;     /* defaults: what t can resolve; no limit */
    long max_steps;           /* attempts in one rk45_solve; default 1000000, negative: no limit */
    const vm_real *atol_each; /* n absolute tolerances, one for each component, instead of atol; 0 is none */
    ode_event *events;        /* n_events of them, or null */
    int n_events;
    long work_size; /* how many numbers work has room for, e.g. sizeof work / sizeof *work; 0: it is not checked */
} rk45_options;

typedef struct VM_TAG(rk45) {
    vm_real t;      /* current time */
    vm_real *y;     /* current state, n values (in work) */
    vm_real t_old;  /* rk45_interpolate covers t_old .. t, the last accepted step; only t after an error */
    vm_real h;      /* the next step to be tried, signed; 0 before the first */
    long steps;     /* accepted */
    long rejected;  /* and rejected steps */
    long evals;     /* of f */
    long missed;    /* steps of the smallest size that were accepted though their error was above the tolerance */
    int rhs_status; /* what f returned last */
    int event;      /* index of the terminal event that ended the last call, else -1 */
    int stiff;      /* nonzero once the run has looked stiff */
    ode_rhs f;
    void *ctx;
    int n;
    int method;            /* VMI_RK45 or VMI_RK87 */
    rk45_options options;  /* as resolved */
    vm_real *work;         /* from here on internal */
    vm_real t_low;         /* y belongs to t + t_low, |t_low| <= ulp(t)/2, */
    vm_real t_old_low;     /* and the last step began at t_old + t_old_low */
    vm_real h_done;        /* the last accepted step */
    vm_real inverse_error; /* 1 over its error, in tolerances */
    long attempts;         /* left; negative: no limit */
    int k1, extended;      /* state of the derivatives in work */
    int failure;           /* of the attempt before: VMI_REJECTED, VMI_NOT_FINITE */
    long next_miss;        /* a step of the smallest size may miss the tolerance again when `steps` is this large */
    int stiff_wait, stiff_hits, stiff_misses;
} rk45;

#define RK45_WORK(n) (10 * (n))

/* The same by the pair of order 8: same options, same meaning of all fields and statuses. rk87_interpolate is of
   order 8 and evaluates f seven times in a step in which it is used; ODE_NOT_FINITE where f is not finite there. */
typedef rk45_options rk87_options;
typedef rk45 rk87;
#define RK87_WORK(n) (24 * (n))
enum { VMI_RK45, VMI_RK87 }; /* the methods */

/* What the roundings within a step allow: rk87 has coefficients up to 123 */
VM_API vm_real vmi_least_rtol(int method) { return (vm_real)(method == VMI_RK45 ? 16 : 256) * VM_EPSILON; }

VM_API rk45_options vmi_defaults(int method, const rk45_options *options_or_NULL)
{
    const vm_real least = vmi_least_rtol(method);
    rk45_options o = {0, 0, 0, 0, 0, 0, NULL, NULL, 0, 0};
    if (options_or_NULL) o = *options_or_NULL;
    if (o.rtol == 0) o.rtol = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-4);
    if (o.rtol > 0 && o.rtol < least) o.rtol = least;
    if (o.atol == 0) o.atol = o.rtol > 0 ? o.rtol * VM_C(1e-3) : 0;
    if (o.rtol < 0) o.rtol = 0;
    if (o.atol < 0) o.atol = 0;
    if (o.h_max == 0) o.h_max = VM_MAX;
    if (o.max_steps == 0) o.max_steps = 1000000L;
    return o;
}

VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL)
{
    return vmi_defaults(VMI_RK45, options_or_NULL);
}

/* Every component has a tolerance, none is negative or NaN */
VM_API int vmi_tolerances_are_valid(const rk45_options *o, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        vm_real atol = o->atol_each ? o->atol_each[i] : o->atol;
        if (!(atol >= 0) || !(atol + o->rtol > 0)) return 0;
    }
    return 1;
}

VM_API int vmi_options_are_valid(const rk45_options *o, int n)
{
    int i;
    if (!VM_IS_FINITE(o->rtol) || !VM_IS_FINITE(o->atol) || !vmi_tolerances_are_valid(o, n)) return 0;
    if (!VM_IS_FINITE(o->h0) || !(o->h_min >= 0) || !(o->h_max >= o->h_min)) return 0;
    if (o->n_events < 0 || (o->n_events > 0 && !o->events)) return 0;
    for (i = 0; i < o->n_events; i++)
        if (!o->events[i].g || o->events[i].room < 0) return 0;
    return 1;
}

enum { VMI_Y, VMI_Y_OLD, VMI_Z, VMI_K }; /* parts of work: y, y at t_old, an argument of f, k_1, k_2 ... */
enum { VMI_K1_MISSING, VMI_K1_READY, VMI_K1_IS_LAST };  /* the last k of a step is the next one's first */
enum { VMI_NONE_FAILED, VMI_REJECTED, VMI_NOT_FINITE }; /* what became of the attempt before */
enum { VMI_STIFF_WAIT = 100 };                          /* accepted steps from one look for stiffness to the next */

/* So many steps must keep the tolerance between two steps that may miss it. Behind a jump these steps are 1, 10 and
   100 times as long as the smallest step; next to a singularity there are none. */
enum { VMI_BETWEEN_MISSES = 3 };
VM_API vm_real *vmi_part(const rk45 *s, int part) { return s->work + (ptrdiff_t)part * s->n; }
VM_INLINE int vmi_last_k(int method) { return method == VMI_RK45 ? VMI_K + 6 : VMI_K + 13; }

VM_API long vmi_work_size(int method, int n)
{
    return method == VMI_RK45 ? RK45_WORK((long)n) : RK87_WORK((long)n);
}

VMI_APART int vmi_init(rk45 *s, int method, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                       const rk45_options *options_or_NULL, vm_real *work)
{
    rk45_options o = vmi_defaults(method, options_or_NULL);
    vm_real rtol = options_or_NULL ? options_or_NULL->rtol : 0;
    int i;
    if (!s || !f || n <= 0 || !y0 || !work || !VM_IS_FINITE(t0) || !vmi_all_finite(n, y0) ||
        !vmi_options_are_valid(&o, n))
        return ODE_BAD_ARGUMENT;
    if (o.work_size && o.work_size < vmi_work_size(method, n)) return ODE_WORK_TOO_SMALL;
    for (i = 0; i < o.n_events; i++) {
        o.events[i].count = 0;
        o.events[i].quiet = 0;
        o.events[i].slack = 0;
    }
    s->method = method;
    s->f = f;
    s->ctx = ctx;
    s->n = n;
    s->options = o;
    s->work = work;
    s->t = t0;
    s->t_old = t0;
    s->t_low = 0;
    s->t_old_low = 0;
    s->y = work;
    vmi_copy(n, y0, s->y);
    s->h = o.h0;
    s->steps = s->rejected = s->evals = s->missed = 0;
    s->next_miss = 0;
    s->rhs_status = s->stiff = s->stiff_hits = s->stiff_misses = s->extended = 0;
    s->stiff_wait = VMI_STIFF_WAIT;
    s->event = -1;
    s->h_done = 0;
    s->inverse_error = 1;
    s->k1 = VMI_K1_MISSING;
    s->failure = VMI_NONE_FAILED;
    return rtol > 0 && rtol < o.rtol ? ODE_RTOL_RAISED : ODE_OK;
}

VM_INLINE int vmi_ode_init(rk45 *s, int method, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                           const rk45_options *options_or_NULL, vm_real *work)
{
    int status = vmi_init(s, method, f, ctx, n, t0, y0, options_or_NULL, work);
    if (status >= 0) {
        /* again, where the caller's compiler sees it */
        s->f = f;
        s->n = n;
    }
    return status;
}

VM_INLINE int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk45_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, VMI_RK45, f, ctx, n, t0, y0, options_or_NULL, work);
}

VM_INLINE int rk87_init(rk87 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk87_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, VMI_RK87, f, ctx, n, t0, y0, options_or_NULL, work);
}

VM_API int vmi_eval(rk45 *s, vm_real t, const vm_real *y, vm_real *k)
{
    s->evals++;
    s->rhs_status = s->f(t, y, k, s->ctx);
    return s->rhs_status ? ODE_RHS_STOPPED : ODE_OK;
}

/* What component i may be wrong by when its size is |y|; > 0 */
VM_INLINE vm_real vmi_tolerance(const rk45_options *o, int i, vm_real y)
{
    return (o->atol_each ? o->atol_each[i] : o->atol) + o->rtol * VM_FABS(y) + VM_MIN;
}

#endif
