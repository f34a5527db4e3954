/* integrators.h - ordinary differential equations y' = f(t, y) by explicit Runge-Kutta methods

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include "integrators.h"
       static int spring(double t, const double *y, double *dydt, void *ctx)
       {
           (void)t, (void)ctx;
           dydt[0] = y[1], dydt[1] = -y[0] * y[0] * y[0];
           return 0;
       }
       int main(void)
       {
           double y0[2] = {1, 0}, work[RK45_WORK(2)];
           rk45 s;
           rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work);
           return rk45_solve(&s, 10.0) < 0; // the result is in s.y, at s.t
       }

   METHODS
     rk4   the classical method of order 4, fixed step.
     rk45  Tsitouras' pair of orders 5 and 4 [1]: 7 stages of which the last is the next step's first, PI step size
           control [2], continuous extension of order 4. To errors of 1e-6 and less it takes 0.4 to 0.95 times the
           evaluations of Dormand and Prince's pair (make bench; docs/measurements.md).

   CONVENTIONS
     f gets t, the n values y, room for the n derivatives and the caller's ctx; it returns 0, or anything else to stop
     the run. t may run backward. Lengths of time are in whatever unit t has.
     Memory is the caller's: work has RK4_WORK(n) or RK45_WORK(n) numbers and must live as long as the rk45 does. An
     rk45 and its work are all the state there is.

   STEP SIZE CONTROL of rk45
     A step is accepted when |error_i| <= atol + rtol max(|y_i|, |y_i after the step|) for every component, error
     being the difference of the two orders (the higher one is kept). Options: an rk45_options whose zero fields
     mean the defaults, a negative tolerance none; rk45_defaults() shows what they come to.

   STATUS
     0 (ODE_OK) success, positive numbers information, negative ones errors; ode_strerror() names them. After an error
     s.t and s.y are the last accepted step's, for f's own refusal too (its value is in s.rhs_status). Where f or the
     state is not finite the step is shortened until it is too small; so a run ends next to where f ceases to exist.
     A call that refuses its arguments changes nothing.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_EXP, VM_LOG ...   the functions of the C library that are used (all of them, if any)
     VM_ALLOW_FAST_MATH   compile under -ffast-math, where the checks for NaN do not work
   Names that begin with vmi_ or VMI_ are internal.

   COST, measured (make bench; docs/measurements.md)
     rk4_solve takes 1.01 times a hand-written loop where f is static and n a constant that the compiler sees; an
     evaluation by rk45_solve takes 5 times one of that loop.

   REFERENCES
     [1] Ch. Tsitouras, Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption,
         Computers & Mathematics with Applications 62 (2011) 770-775.
     [2] E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993:
         II.4 (first step, step size control), II.6 (continuous extensions). */
#ifndef VARMASS_INTEGRATORS_H
#define VARMASS_INTEGRATORS_H

/* ---- Shared block: the same, word for word, in the four headers; tests/test_headers.sh keeps it so ---------- */
#ifndef VM_SHARED
#define VM_SHARED

#include <float.h>
#include <math.h>
#include <stddef.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#define VM_NO_NAN
#endif
#if (defined(__FAST_MATH__) || defined(VM_NO_NAN)) && !defined(VM_ALLOW_FAST_MATH)
#error "-ffast-math breaks two-word arithmetic and the checks for NaN; VM_ALLOW_FAST_MATH compiles anyway"
#endif

#ifndef VM_API
#define VM_API static inline /* linkage of every function, e.g. static inline __host__ __device__ */
#endif
#ifndef VM_INLINE /* linkage of what must be inlined for speed; VM_API is enough for the results */
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define VM_INLINE VM_API __attribute__((always_inline))
#else
#define VM_INLINE VM_API
#endif
#endif
#ifndef VM_TABLE
#define VM_TABLE static const /* storage of every table */
#endif

#ifdef VM_USE_FLOAT
typedef float vm_real;
#define VM_C(x) x##f            /* a constant */
#define VM_LIBM(name) name##f   /* a function of the C library */
#define VM_TAG(tag) tag##_float /* a struct tag: a C++ program that mixes precisions has no tag twice */
#define VM_EPSILON FLT_EPSILON
#define VM_MAX FLT_MAX
#define VM_MANT_DIG FLT_MANT_DIG
#ifdef FP_FAST_FMAF
#define VM_FAST_FMA
#endif
#else
typedef double vm_real;
#define VM_C(x) x
#define VM_LIBM(name) name
#define VM_TAG(tag) tag
#define VM_EPSILON DBL_EPSILON
#define VM_MAX DBL_MAX
#define VM_MANT_DIG DBL_MANT_DIG /* 24 where double is a float, as on AVR: table lengths follow it */
#ifdef FP_FAST_FMA
#define VM_FAST_FMA
#endif
#endif

#ifndef VM_SQRT /* define all of these to use another library */
#define VM_SQRT(x) VM_LIBM(sqrt)(x)
#define VM_FABS(x) VM_LIBM(fabs)(x)
#define VM_FLOOR(x) VM_LIBM(floor)(x)
#define VM_COPYSIGN(x, y) VM_LIBM(copysign)(x, y)
#define VM_SIN(x) VM_LIBM(sin)(x)
#define VM_COS(x) VM_LIBM(cos)(x)
#define VM_EXP(x) VM_LIBM(exp)(x)
#define VM_LOG(x) VM_LIBM(log)(x)
#define VM_POW(x, y) VM_LIBM(pow)(x, y)
#endif

#define VM_NAN ((vm_real)NAN)
#define VM_INFINITY ((vm_real)INFINITY)
#define VM_IS_FINITE(x) ((x) - (x) == 0)
#define VM_PI VM_C(3.141592653589793238463)

typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two; /* hi + lo, |lo| <= ulp(hi)/2 */

/* x without the excess precision in which x87 units compute, and gcc in gnu modes keeps it */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
VM_API vm_real vmi_rounded(vm_real x)
{
    volatile vm_real stored = x;
    return stored;
}
#else
#define vmi_rounded(x) (x)
#endif

/* a + b exactly (Knuth) */
VM_API vm_two vmi_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    vm_real b_part;
    s.hi = vmi_rounded(a + b);
    b_part = vmi_rounded(s.hi - a);
    s.lo = vmi_rounded((a - (s.hi - b_part)) + (b - b_part));
    return s;
}

/* a b exactly, for |a|, |b| < VM_MAX/VM_SPLIT whose product neither over- nor underflows: by a fused multiply-add
   where that is an instruction, else by Dekker's and Veltkamp's splitting, with the same result. "+ 0" makes a
   product a sum, so that a compiler that contracts cannot put the unrounded product into a later sum. */
#if VM_MANT_DIG > 24
#define VM_SPLIT VM_C(134217729.0)
#else
#define VM_SPLIT VM_C(4097.0)
#endif
VM_API vm_two vmi_two_product(vm_real a, vm_real b)
{
    vm_two p;
#ifdef VM_FAST_FMA
    p.hi = a * b + 0;
    p.lo = VM_LIBM(fma)(a, b, -p.hi);
#else
    vm_real ta = vmi_rounded(VM_SPLIT * a + 0), a_rest = vmi_rounded(ta - a), ah = ta - a_rest, al = a - ah;
    vm_real tb = vmi_rounded(VM_SPLIT * b + 0), b_rest = vmi_rounded(tb - b), bh = tb - b_rest, bl = b - bh;
    p.hi = vmi_rounded(a * b + 0);
    p.lo = vmi_rounded(((ah * bh - p.hi) + ah * bl + al * bh) + al * bl);
#endif
    return p;
}

/* x = 4k quarters + *quarter quarters + rest, where the quarter period is q.hi + q.lo > 0 and x >= 0: returns the
   rest, |rest| <= q/2 but for a rounding, accurate to an ulp of itself plus 2^-(2p) x. From 2^(p-1) quarters on
   the argument holds no phase: rest 0, quarter 0. */
VM_API vm_real vmi_reduce(vm_real x, vm_two q, int *quarter)
{
    vm_real scale, j = VM_FLOOR(x / q.hi + VM_C(0.5));
    vm_two p;
    *quarter = 0;
    if (j == 0) return x;
    if (!(j < 1 / VM_EPSILON)) return 0;
    *quarter = (int)(j - 4 * VM_FLOOR(j / 4));
    scale = q.hi > VM_MAX * VM_EPSILON ? VM_EPSILON : 1; /* room for the splitting */
    p = vmi_two_product(j, q.hi * scale);
    return ((x * scale - p.hi) - (p.lo + j * (q.lo * scale))) / scale;
}

#endif
/* ---- End of the shared block -------------------------------------------------------------------------------- */

/* ---- Table of contents -------------------------------------------------------------------------------------- */

enum {
    ODE_OK = 0,
    ODE_RTOL_RAISED = 1, /* rk45_init: rtol was less than the type can hold, 16 eps is used */
    ODE_BAD_ARGUMENT =
        -1, /* n or steps <= 0, a null pointer, a component without tolerance, h_min < 0 or above h_max,
                                a time, state or option that is not finite, a time outside the last step */
    ODE_RHS_STOPPED = -2,    /* f returned something else than 0 */
    ODE_NOT_FINITE = -3,     /* f or the state became infinite or NaN, however short the step */
    ODE_STEP_TOO_SMALL = -4, /* the tolerance asks for a step below h_min, or below what t can resolve */
    ODE_MAX_STEPS = -5       /* max_steps attempts did not reach t_end; call again to go on */
};
VM_API const char *ode_strerror(int status);

/* dydt = f(t, y) */
typedef int (*ode_rhs)(vm_real t, const vm_real *y, vm_real *dydt, void *ctx);

/* One step of size h (of either sign) from t: y becomes y(t + h). steps equal steps from *t to t_end, after which
   *t == t_end. Error O(h^4). On failure y (and *t) are those of the last complete step. */
#define RK4_WORK(n) (3 * (n))
VM_API int rk4_step(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, vm_real *y, vm_real *work);
VM_API int rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y, vm_real *work);

typedef struct VM_TAG(rk45_options) {
    vm_real rtol;             /* default 1e-6 (float 1e-4) */
    vm_real atol;             /* default 1e-3 rtol */
    vm_real h0;               /* first step; default chosen from f. Its sign is rk45_step's direction */
    vm_real h_min, h_max;     /* defaults: what t can resolve; no limit */
    long max_steps;           /* attempts in one rk45_solve; default 1000000, negative: no limit */
    const vm_real *atol_each; /* n absolute tolerances, one for each component, instead of atol; 0 is none */
} rk45_options;

typedef struct VM_TAG(rk45) {
    vm_real t;      /* current time */
    vm_real *y;     /* current state, n values (in work) */
    vm_real t_old;  /* rk45_interpolate covers t_old .. t, the last accepted step; only t after an error */
    vm_real h;      /* the next step to be tried, signed; 0 before the first */
    long steps;     /* accepted */
    long rejected;  /* and rejected steps */
    long evals;     /* of f */
    int rhs_status; /* what f returned last */
    ode_rhs f;
    void *ctx;
    int n;
    rk45_options options; /* as resolved */
    vm_real *work;        /* from here on internal */
    vm_real ln_error_before;
    int k1; /* where k_1 is */
} rk45;

#define RK45_WORK(n) (10 * (n))
VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL);
VM_API int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                     const rk45_options *options_or_NULL, vm_real *work);
/* One accepted step. */
VM_API int rk45_step(rk45 *s);
/* To t_end exactly, forward or backward; at once if s->t is there. */
VM_API int rk45_solve(rk45 *s, vm_real t_end);
/* y(t) for t within the last step, to about the step's own accuracy; refuses other t. */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y);
/* Go on from another time or state (after a jump), same n; step size and counters are kept. y may be s->y. */
VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y);

VM_API const char *ode_strerror(int status)
{
    switch (status) {
    case ODE_OK: return "success";
    case ODE_RTOL_RAISED: return "rtol was raised to 16 eps";
    case ODE_BAD_ARGUMENT: return "bad argument";
    case ODE_RHS_STOPPED: return "the right-hand side stopped the run";
    case ODE_NOT_FINITE: return "the right-hand side or the state is not finite";
    case ODE_STEP_TOO_SMALL: return "the step size became too small";
    case ODE_MAX_STEPS: return "max_steps was reached";
    default: return "unknown status";
    }
}

VM_API int vmi_all_finite(int n, const vm_real *y)
{
    int i;
    for (i = 0; i < n; i++)
        if (!VM_IS_FINITE(y[i])) return 0;
    return 1;
}

VM_API void vmi_copy(int n, const vm_real *from, vm_real *to)
{
    int i;
    for (i = 0; i < n; i++) to[i] = from[i];
}

/* ---- rk4 ---------------------------------------------------------------------------------------------------- */

VM_API int rk4_step(ode_rhs f, void *ctx, int n, vm_real t, vm_real h, vm_real *y, vm_real *work)
{
    vm_real *k = work, *sum, *z;
    int i;
    if (!f || n <= 0 || !y || !work || !VM_IS_FINITE(t) || !VM_IS_FINITE(h)) return ODE_BAD_ARGUMENT;
    sum = work + n, z = sum + n;
    if (f(t, y, k, ctx)) return ODE_RHS_STOPPED;
    for (i = 0; i < n; i++) sum[i] = k[i], z[i] = y[i] + h / 2 * k[i];
    if (f(t + h / 2, z, k, ctx)) return ODE_RHS_STOPPED;
    for (i = 0; i < n; i++) sum[i] += 2 * k[i], z[i] = y[i] + h / 2 * k[i];
    if (f(t + h / 2, z, k, ctx)) return ODE_RHS_STOPPED;
    for (i = 0; i < n; i++) sum[i] += 2 * k[i], z[i] = y[i] + h * k[i];
    if (f(t + h, z, k, ctx)) return ODE_RHS_STOPPED;
    for (i = 0; i < n; i++) z[i] = y[i] + h / 6 * (sum[i] + k[i]);
    if (!vmi_all_finite(n, z)) return ODE_NOT_FINITE;
    vmi_copy(n, z, y);
    return ODE_OK;
}

VM_API int rk4_solve(ode_rhs f, void *ctx, int n, vm_real *t, vm_real t_end, long steps, vm_real *y, vm_real *work)
{
    vm_real t0, h;
    long i;
    if (!t || steps <= 0 || !VM_IS_FINITE(t_end)) return ODE_BAD_ARGUMENT;
    t0 = *t;
    h = (t_end - t0) / (vm_real)steps;
    for (i = 0; i < steps; i++) {
        int status = rk4_step(f, ctx, n, *t, h, y, work);
        if (status) return status;
        *t = i + 1 < steps ? t0 + (vm_real)(i + 1) * h : t_end;
    }
    return ODE_OK;
}

/* ---- rk45: setting up --------------------------------------------------------------------------------------- */

VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL)
{
    const vm_real least = 16 * VM_EPSILON;
    rk45_options o = {0, 0, 0, 0, 0, 0, NULL};
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

/* Every component has a tolerance, none is negative or NaN */
VM_API int vmi_rk45_tolerances_good(const rk45_options *o, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        vm_real atol = o->atol_each ? o->atol_each[i] : o->atol;
        if (!(atol >= 0) || !(atol + o->rtol > 0)) return 0;
    }
    return 1;
}

enum { VMI_K1_MISSING, VMI_K1_READY, VMI_K1_IN_K7 };

VM_API int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                     const rk45_options *options_or_NULL, vm_real *work)
{
    rk45_options o = rk45_defaults(options_or_NULL);
    vm_real rtol = options_or_NULL ? options_or_NULL->rtol : 0;
    if (!s || !f || n <= 0 || !y0 || !work || !VM_IS_FINITE(t0) || !vmi_all_finite(n, y0)) return ODE_BAD_ARGUMENT;
    if (!VM_IS_FINITE(o.rtol) || !VM_IS_FINITE(o.atol) || !vmi_rk45_tolerances_good(&o, n)) return ODE_BAD_ARGUMENT;
    if (!VM_IS_FINITE(o.h0) || !(o.h_min >= 0) || !(o.h_max >= o.h_min) || !(o.h_max > 0)) return ODE_BAD_ARGUMENT;
    s->f = f, s->ctx = ctx, s->n = n, s->options = o, s->work = work;
    s->t = s->t_old = t0;
    s->y = work;
    vmi_copy(n, y0, s->y);
    s->h = o.h0;
    s->steps = s->rejected = s->evals = 0;
    s->rhs_status = 0;
    s->ln_error_before = VM_C(-9.21); /* 1e-4 */
    s->k1 = VMI_K1_MISSING;
    return rtol > 0 && rtol < o.rtol ? ODE_RTOL_RAISED : ODE_OK;
}

VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y)
{
    if (!s || !y || !VM_IS_FINITE(t) || !vmi_all_finite(s->n, y)) return ODE_BAD_ARGUMENT;
    s->t = s->t_old = t;
    if (y != s->y) vmi_copy(s->n, y, s->y);
    s->k1 = VMI_K1_MISSING;
    return ODE_OK;
}

/* work holds y, y at t_old, the state under construction, and k_1 ... k_7 */
VM_API vm_real *vmi_rk45_work(const rk45 *s, int part) { return s->work + (ptrdiff_t)part * s->n; }
enum { VMI_Y_OLD = 1, VMI_Z = 2, VMI_K1 = 3, VMI_K7 = 9 };

VM_API int vmi_rk45_eval(rk45 *s, vm_real t, const vm_real *y, vm_real *k)
{
    s->evals++;
    s->rhs_status = s->f(t, y, k, s->ctx);
    return s->rhs_status ? ODE_RHS_STOPPED : ODE_OK;
}

/* x over the tolerance of component i when its size is |y|, 0 to 1e10; NaN and infinity stay what they are */
VM_API vm_real vmi_rk45_scaled(const rk45 *s, int i, vm_real x, vm_real y)
{
    const vm_real largest = VM_C(1e10);
    vm_real scale = (s->options.atol_each ? s->options.atol_each[i] : s->options.atol) +
                    s->options.rtol * VM_FABS(y);
    x = VM_FABS(x);
    if (x == 0 || !VM_IS_FINITE(x)) return x;
    return x < largest * scale ? x / scale : largest;
}

/* The first step, from the sizes of y, y' and y'' [2, II.4]: 100 h0 at the most, where h0 moves y by 1 % of itself,
   and such that the error of a method of order 5 should be 1 % of the tolerance. Uses k_7 and z. */
VM_API int vmi_rk45_first_step(rk45 *s, vm_real direction, vm_real longest)
{
    vm_real *k1 = vmi_rk45_work(s, VMI_K1), *k2 = vmi_rk45_work(s, VMI_K7), *z = vmi_rk45_work(s, VMI_Z);
    vm_real d0 = 0, d1 = 0, d2 = 0, h0, h1;
    int i, status;
    for (i = 0; i < s->n; i++) {
        vm_real a = vmi_rk45_scaled(s, i, s->y[i], s->y[i]), b = vmi_rk45_scaled(s, i, k1[i], s->y[i]);
        if (a > d0) d0 = a;
        if (b > d1) d1 = b;
    }
    h0 = d0 < VM_C(1e-5) || d1 < VM_C(1e-5) ? VM_C(1e-6) : VM_C(0.01) * d0 / d1;
    if (h0 > longest) h0 = longest;
    for (i = 0; i < s->n; i++) z[i] = s->y[i] + direction * h0 * k1[i];
    status = vmi_rk45_eval(s, s->t + direction * h0, z, k2);
    if (status) return status;
    for (i = 0; i < s->n; i++) {
        vm_real c = vmi_rk45_scaled(s, i, (k2[i] - k1[i]) / h0, s->y[i]);
        if (!VM_IS_FINITE(c)) c = VM_MAX; /* f does not reach so far */
        if (c > d2) d2 = c;
    }
    if (d1 > d2) d2 = d1;
    h1 = d2 <= VM_C(1e-15) ? (h0 > VM_C(1e-3) ? h0 * VM_C(1e-3) : VM_C(1e-6))
                           : VM_EXP(VM_C(0.2) * VM_LOG(VM_C(0.01) / d2));
    if (h1 > 100 * h0) h1 = 100 * h0;
    if (h1 < VM_C(1e-3) * h0) h1 = VM_C(1e-3) * h0;
    s->h = direction * (h1 < longest ? h1 : longest);
    return ODE_OK;
}

/* The shortest step that is tried */
VM_API vm_real vmi_rk45_least(const rk45 *s)
{
    vm_real least = 4 * VM_EPSILON * VM_FABS(s->t);
    return least > s->options.h_min ? least : s->options.h_min;
}

/* k_1, and a step that is not too short to be tried */
VM_API int vmi_rk45_prepare(rk45 *s, vm_real t_end)
{
    vm_real longest = VM_FABS(t_end - s->t), direction = t_end < s->t ? -1 : 1, *k1 = vmi_rk45_work(s, VMI_K1);
    int status = ODE_OK;
    if (s->k1 == VMI_K1_IN_K7) vmi_copy(s->n, vmi_rk45_work(s, VMI_K7), k1);
    if (s->k1 == VMI_K1_MISSING) {
        status = vmi_rk45_eval(s, s->t, s->y, k1);
        if (status) return status;
        if (!vmi_all_finite(s->n, k1)) return ODE_NOT_FINITE;
    }
    s->k1 = VMI_K1_READY;
    s->t_old = s->t;
    if (longest > s->options.h_max) longest = s->options.h_max;
    if (s->h == 0) status = vmi_rk45_first_step(s, direction, longest);
    if (status) return status;
    s->h = VM_FABS(s->h) > vmi_rk45_least(s) ? VM_FABS(s->h) : vmi_rk45_least(s);
    s->h *= direction;
    return ODE_OK;
}

/* ---- rk45: one step ----------------------------------------------------------------------------------------- */

/* Stages 2 to 7 from t with step h: z becomes the new state, k_7 its derivative. Coefficients of [1], which satisfy
   the order conditions to 6e-16. */
VM_API int vmi_rk45_stages(rk45 *s, vm_real t_new, vm_real h)
{
    const vm_real *y = s->y;
    vm_real *z = vmi_rk45_work(s, VMI_Z), *k1 = vmi_rk45_work(s, VMI_K1), *k2 = k1 + s->n, *k3 = k2 + s->n;
    vm_real *k4 = k3 + s->n, *k5 = k4 + s->n, *k6 = k5 + s->n, *k7 = k6 + s->n, t = s->t;
    int i, n = s->n, status;
    for (i = 0; i < n; i++) z[i] = y[i] + h * (VM_C(0.161) * k1[i]);
    status = vmi_rk45_eval(s, t + VM_C(0.161) * h, z, k2);
    if (status) return status;
    for (i = 0; i < n; i++)
        z[i] = y[i] + h * (VM_C(-0.008480655492356989) * k1[i] + VM_C(0.335480655492357) * k2[i]);
    status = vmi_rk45_eval(s, t + VM_C(0.327) * h, z, k3);
    if (status) return status;
    for (i = 0; i < n; i++)
        z[i] = y[i] + h * (VM_C(2.8971530571054935) * k1[i] - VM_C(6.359448489975075) * k2[i] +
                           VM_C(4.3622954328695815) * k3[i]);
    status = vmi_rk45_eval(s, t + VM_C(0.9) * h, z, k4);
    if (status) return status;
    for (i = 0; i < n; i++)
        z[i] = y[i] + h * (VM_C(5.325864828439257) * k1[i] - VM_C(11.748883564062828) * k2[i] +
                           VM_C(7.4955393428898365) * k3[i] - VM_C(0.09249506636175525) * k4[i]);
    status = vmi_rk45_eval(s, t + VM_C(0.9800255409045097) * h, z, k5);
    if (status) return status;
    for (i = 0; i < n; i++)
        z[i] = y[i] + h * (VM_C(5.86145544294642) * k1[i] - VM_C(12.92096931784711) * k2[i] +
                           VM_C(8.159367898576159) * k3[i] - VM_C(0.071584973281401) * k4[i] -
                           VM_C(0.028269050394068383) * k5[i]);
    status = vmi_rk45_eval(s, t_new, z, k6);
    if (status) return status;
    for (i = 0; i < n; i++)
        z[i] = y[i] + h * (VM_C(0.09646076681806523) * k1[i] + VM_C(0.01) * k2[i] +
                           VM_C(0.4798896504144996) * k3[i] + VM_C(1.379008574103742) * k4[i] -
                           VM_C(3.290069515436081) * k5[i] + VM_C(2.324710524099774) * k6[i]);
    return vmi_rk45_eval(s, t_new, z, k7);
}

/* The largest error of a component over its tolerance; NaN where anything is not finite */
VM_API vm_real vmi_rk45_error(const rk45 *s, vm_real h)
{
    const vm_real *z = vmi_rk45_work(s, VMI_Z), *k1 = vmi_rk45_work(s, VMI_K1), *k2 = k1 + s->n, *k3 = k2 + s->n;
    const vm_real *k4 = k3 + s->n, *k5 = k4 + s->n, *k6 = k5 + s->n, *k7 = k6 + s->n;
    vm_real largest = 0;
    int i;
    for (i = 0; i < s->n; i++) {
        vm_real e = VM_C(-0.00178001105222577714) * k1[i] - VM_C(0.0008164344596567469) * k2[i] +
                    VM_C(0.007880878010261995) * k3[i] - VM_C(0.1447110071732629) * k4[i] +
                    VM_C(0.5823571654525552) * k5[i] - VM_C(0.45808210592918697) * k6[i] + k7[i] / 66;
        vm_real size = VM_FABS(s->y[i]) > VM_FABS(z[i]) ? s->y[i] : z[i];
        e = vmi_rk45_scaled(s, i, h * e, size);
        if (!VM_IS_FINITE(e) || !VM_IS_FINITE(z[i])) return VM_NAN;
        if (e > largest) largest = e;
    }
    return largest;
}

/* PI control [2, II.4 and IV.2]: an accepted step is followed by one 0.9 error^-0.17 error_before^0.04 times as long,
   within 1/5 and 10, and not longer where an attempt had to be rejected; a rejected one shrinks by 0.9 error^-0.2 */
VM_API vm_real vmi_rk45_factor(rk45 *s, vm_real error, int rejected)
{
    const vm_real safety = VM_C(0.9), least = VM_C(0.2), most = 10, ln_small = VM_C(-9.21),
                  ln_tiny = VM_C(-18.4); /* 1e-4, 1e-8 */
    vm_real ln_error = error > 0 ? VM_LOG(error) : 2 * ln_tiny, factor;
    if (error > 1) factor = safety * VM_EXP(VM_C(-0.2) * ln_error);
    else {
        factor = ln_error > ln_tiny ? safety * VM_EXP(VM_C(0.04) * s->ln_error_before - VM_C(0.17) * ln_error)
                                    : most;
        s->ln_error_before = ln_error > ln_small ? ln_error : ln_small;
        if (rejected && factor > 1) factor = 1;
    }
    return factor < least ? least : factor > most ? most : factor;
}

/* Attempts, each one counted down in *attempts, until a step towards t_end, not past it, is accepted */
VM_API int vmi_rk45_advance(rk45 *s, vm_real t_end, long *attempts)
{
    const vm_real direction = t_end < s->t ? -1 : 1, shrink_not_finite = VM_C(0.1);
    int rejected = 0, not_finite = 0, status = vmi_rk45_prepare(s, t_end);
    if (status) return status;
    for (;;) {
        const vm_real left = VM_FABS(t_end - s->t), nearly = VM_C(0.999999);
        vm_real h = s->h, error, factor, t_new;
        int last;
        if (VM_FABS(h) > s->options.h_max) h = s->h = direction * s->options.h_max;
        last = VM_FABS(h) >= nearly * left;
        if (last) h = t_end - s->t;
        else if (h == 0 || VM_FABS(h) < vmi_rk45_least(s)) return not_finite ? ODE_NOT_FINITE : ODE_STEP_TOO_SMALL;
        if (*attempts == 0) return ODE_MAX_STEPS;
        if (*attempts > 0) --*attempts;
        t_new = last ? t_end : s->t + h;
        status = vmi_rk45_stages(s, t_new, h);
        if (status) return status;
        error = vmi_rk45_error(s, h);
        not_finite = error != error;
        factor = not_finite ? shrink_not_finite : vmi_rk45_factor(s, error, rejected);
        if (error <= 1) {
            vmi_copy(s->n, s->y, vmi_rk45_work(s, VMI_Y_OLD));
            vmi_copy(s->n, vmi_rk45_work(s, VMI_Z), s->y);
            s->t = t_new;
            s->steps++;
            s->k1 = VMI_K1_IN_K7;
            if (!last || VM_FABS(factor * h) > VM_FABS(s->h))
                s->h = factor * h; /* a cut step does not shorten the next */
            return ODE_OK;
        }
        s->rejected++;
        rejected = 1;
        s->h = factor * h;
    }
}

VM_API int rk45_step(rk45 *s)
{
    long attempts = -1;
    if (!s) return ODE_BAD_ARGUMENT;
    return vmi_rk45_advance(s, s->h < 0 ? -VM_MAX : VM_MAX, &attempts);
}

VM_API int rk45_solve(rk45 *s, vm_real t_end)
{
    long attempts;
    if (!s || !VM_IS_FINITE(t_end)) return ODE_BAD_ARGUMENT;
    attempts = s->options.max_steps;
    while (s->t != t_end) {
        int status = vmi_rk45_advance(s, t_end, &attempts);
        if (status) return status;
    }
    return ODE_OK;
}

/* Tsitouras' continuous extension of order 4 [1]: y(t_old + x h) = y_old + h sum b_i(x) k_i */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y)
{
    vm_real h, x, b1, b2, b3, b4, b5, b6, b7;
    const vm_real *y_old, *k1, *k2, *k3, *k4, *k5, *k6, *k7;
    int i;
    if (!s || !y || !((s->t_old <= t && t <= s->t) || (s->t <= t && t <= s->t_old))) return ODE_BAD_ARGUMENT;
    if (t == s->t) {
        vmi_copy(s->n, s->y, y);
        return ODE_OK;
    }
    h = s->t - s->t_old;
    x = (t - s->t_old) / h;
    b1 = VM_C(-1.0530884977290216) * x * (x - VM_C(1.3299890189751412)) *
         ((x - VM_C(1.4364028541716351)) * x + VM_C(0.7139816917074209));
    b2 = VM_C(0.1017) * x * x * ((x - VM_C(2.1966568338249754)) * x + VM_C(1.2949852507374631));
    b3 = VM_C(2.490627285651252793) * x * x * ((x - VM_C(2.38535645472061657)) * x + VM_C(1.57803468208092486));
    b4 = VM_C(-16.54810288924490272) * x * x * (x - VM_C(1.21712927295533244)) * (x - VM_C(0.61620406037800089));
    b5 = VM_C(47.37952196281928122) * x * x * (x - VM_C(1.203071208372362603)) * (x - VM_C(0.658047292653547382));
    b6 = VM_C(-34.87065786149660974) * x * x * (x - VM_C(1.2)) * (x - VM_C(0.666666666666666667));
    b7 = VM_C(2.5) * x * x * (x - 1) * (x - VM_C(0.6));
    y_old = vmi_rk45_work(s, VMI_Y_OLD);
    k1 = vmi_rk45_work(s, VMI_K1), k2 = k1 + s->n, k3 = k2 + s->n, k4 = k3 + s->n, k5 = k4 + s->n, k6 = k5 + s->n;
    k7 = k6 + s->n;
    for (i = 0; i < s->n; i++)
        y[i] = y_old[i] +
               h * (b1 * k1[i] + b2 * k2[i] + b3 * k3[i] + b4 * k4[i] + b5 * k5[i] + b6 * k6[i] + b7 * k7[i]);
    return ODE_OK;
}

#endif
