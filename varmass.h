/* varmass.h - dynamics of bodies whose mass varies

   Part of varmass (MIT licence): copy varmass.h, ateb.h, jacobi.h and integrators.h side by side, include varmass.h,
   link with -lm. No allocation, no state, no other library.

       #include <stdio.h>
       #include "varmass.h"
       int main(void)
       {
           vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}}, part = whole, rest;
           part.mass = 1;
           part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1;
           part.r.x = 0.4; // it sat 0.4 m from the mass centre and leaves at 2 m/s aside
           part.v.y = 2;
           if (vm_separate(&whole, &part, NULL, &rest) == VM_OK) printf("spin %g rad/s\n", rest.omega.z);
           return 0;
       }

   CONTENTS, in the order of the dissertation [1]
     Chapter 2      momentum, angular momentum, kinetic energy of a body
     Chapter 3      jumps: a part separates from a body or is attached to it in an instant
     Chapter 7.1-4  the oscillator (m x')' + k x|x|^(alpha-1) = 0 with slowly varying mass: exact period and velocity,
                    the constants of its trigonometric and Jacobi approximations, amplitude laws
   Numbers in round brackets are the equations of [1]; where [1] is misprinted or wrong the corrected form stands here
   and the comment says so.

   CONVENTIONS
     SI units, radians. r, v, omega in inertial axes; the inertia tensor about the body's own mass centre, in body
     axes; xy, xz, yz are its entries, -integral of x y dm. The quaternion q turns body axes into inertial ones; it
     need not have length 1, and all zero reads as the identity. v is momentum/mass. Functions of the oscillator
     take the variable first, then x0 (initial amplitude, either sign), omega0 = sqrt(k/m) and alpha >= 0 (real).

   ERRORS
     Functions that return a status return 0 (VM_OK), a positive number (done, with a remark) or a negative one
     (their outputs are untouched); vm_strerror() names it. Outputs may be the inputs. Functions that return a
     number return NaN outside their domain, for infinite arguments too.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_TABLE             storage of the tables, default static const
     VM_SQRT, VM_FABS ... the functions of the C library that are used (all of them, if any)
     VM_ALLOW_FAST_MATH   compile under -ffast-math, where nothing is promised
   Names that begin with vmi_ or VMI_ are internal.

   ACCURACY, measured (make test; docs/measurements.md)
     Jumps keep momentum to 3 eps of the sum of all M |v|, and angular momentum about any point to 12 eps of the sum
     of all tr(I) |omega| + (|r| + |point|) M |v|, for masses up to 1e4 apart and thin bodies too, but for what
     VM_NULL_AXIS reports. The constants of the oscillator are right to 8 eps; its amplitude laws neglect the second
     order of m' and b.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation. */
#ifndef VARMASS_H
#define VARMASS_H

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
#define VM_MIN FLT_MIN /* normal */
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
#define VM_MIN DBL_MIN
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
#endif

#define VM_NAN ((vm_real)NAN)
#define VM_INFINITY ((vm_real)INFINITY)
#define VM_IS_FINITE(x) ((x) - (x) == 0)
#define VM_PI VM_C(3.141592653589793238463)

typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two; /* hi + lo, |lo| <= ulp(hi)/2 */

/* x without the excess precision in which x87 units compute, and gcc in gnu modes keeps it */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2)
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

#endif
/* ---- End of the shared block -------------------------------------------------------------------------------- */

#include "ateb.h"
#include "integrators.h"
#include "jacobi.h"

/* ---- Table of contents -------------------------------------------------------------------------------------- */

enum {
    VM_OK = 0,
    VM_NULL_AXIS = 1,     /* done, but about an axis without inertia (of a rod, a point) the spin stayed as it was,
                             though angular momentum was left for it: that is lost */
    VM_BAD_ARGUMENT = -1, /* a null pointer */
    VM_NOT_FINITE = -2,   /* a number that is infinite or NaN, given or arising */
    VM_BAD_MASS = -3,     /* a mass that is not positive, the rest's included */
    VM_BAD_INERTIA = -4,  /* an inertia that no body has, the rest's included */
    VM_SINGULAR = -5,     /* linear equations without a unique solution */
    VM_TOLERANCE_MISSED = 20, /* done, but the estimated error is larger than the tolerance */
    VM_NO_LAW = -20,      /* the route does not exist for this problem */
    VM_FAILED = -21       /* an integrator gave up */
};
VM_API const char *vm_strerror(int status);

typedef struct VM_TAG(vm_vec3) {
    vm_real x, y, z;
} vm_vec3;
typedef struct VM_TAG(vm_quat) {
    vm_real w, x, y, z;
} vm_quat;
typedef struct VM_TAG(vm_inertia) {
    vm_real xx, yy, zz, xy, xz, yz;
} vm_inertia; /* kg m^2, entries of the tensor */

typedef struct VM_TAG(vm_body) {
    vm_real mass;       /* kg */
    vm_inertia inertia; /* about the own mass centre, in body axes */
    vm_quat q;          /* turns body axes into inertial ones */
    vm_vec3 r, v;       /* mass centre (m) and momentum/mass (m/s), inertial axes */
    vm_vec3 omega;      /* rad/s, inertial axes */
} vm_body;

typedef struct VM_TAG(vm_impulse) {
    vm_vec3 linear; /* N s */
    vm_vec3 couple; /* N m s */
    vm_vec3 at;     /* the point at which linear acts, inertial axes */
} vm_impulse;

/* -- Chapter 2: momentum M v (1), angular momentum I omega + (r - about) x M v (7), kinetic energy (93), (94) -- */
VM_API vm_vec3 vm_momentum(const vm_body *body);
VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about);
VM_API vm_real vm_kinetic_energy(const vm_body *body);

/* -- Chapter 3: jumps -- */

/* A part, which moved as given the instant after, has left the whole: rest gets mass, mass centre (15), inertia by
   the parallel axes, velocity (24) and angular velocity (34) of what remains; its attitude is the whole's.
   external, where not NULL, acted during the instant. Exact in space: momentum and angular momentum of rest and
   part are those of the whole plus the impulse. Where the rest is a rod or a point the spin about its null axis
   stays the whole's; VM_NULL_AXIS says that there was angular momentum left which that axis cannot carry. */
VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                       vm_body *rest);

/* Two bodies, moving as given the instant before, have become one (which is plastic impact): its attitude is
   body's. */
VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole);

/* -- Chapter 3.3.2: the broken rotor -- */

/* -- Chapter 4: Lagrange's equations across a jump -- */

/* -- Free rotation, exact -- */

/* -- Chapter 5: continuous variation of mass -- */

/* -- Chapter 5.2: the drum -- */

/* -- Chapter 6: Lagrange's equations with variable mass -- */

/* -- Chapter 7.2-7.3: the oscillator x'' + omega0^2 x|x|^(alpha-1) = 0 -- */

/* Started at rest, x(0) = x0, x'(0) = 0 (258), x0 of either sign: exact period (262), s, and largest velocity (267),
   m/s */
VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha);
VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha);
/* Exact motion, x(t) = x0 ca(alpha, 1, s) (282) and x'(t) (283), for x0 of either sign */
VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v);
/* Energy by mass v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1) (259), m^2/s^2 */
VM_API vm_real vm_osc_energy(vm_real x, vm_real v, vm_real omega0, vm_real alpha);
/* Amplitude A > 0 (m) and phase psi in (-Pi, Pi] of any state: x = A ca(psi), v = -vmax(A) sa(psi) */
VM_API void vm_osc_amplitude_phase(vm_real x, vm_real v, vm_real omega0, vm_real alpha, vm_real *A, vm_real *psi);
/* Exact motion from any x(0) = x0, x'(0) = v0 */
VM_API void vm_osc_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real omega0, vm_real alpha, vm_real *x,
                              vm_real *v);

/* The approximations with the exact amplitude and period, started at rest: x0 cos(Omega t) (291), (295) with
   Omega_alpha (293), Omega = Omega_alpha omega0 |x0|^((alpha-1)/2); and x0 cn(Omega_1 t | m) (297), (302) with
   Omega_1* (300), m = k^2 (307), -1.8079 < m < 0.8062, which has the exact velocity at x = 0 also */
VM_API vm_real vm_osc_omega_trig(vm_real alpha);
VM_API vm_real vm_osc_m_jacobi(vm_real alpha);
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha);
VM_API void vm_osc_trig(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v);
VM_API void vm_osc_jacobi(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v);

/* How good they are, criterion (268): their largest velocities over the exact one (267), that of cos (296) and that
   of cn, which for m > 1/2 is Omega_1/(2k) next to x = 0, not the k' Omega_1 of (306) at x = 0; and the largest
   errors of x over x0 and of v over vmax in a period. NaN outside alpha >= 0. */
typedef struct VM_TAG(vm_osc_comparison) {
    vm_real trig_vmax, jacobi_vmax;
    vm_real trig_x, trig_v, jacobi_x, jacobi_v;
} vm_osc_comparison;
VM_API vm_osc_comparison vm_osc_compare(vm_real alpha);

/* -- Chapter 7.4: m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + F, with slowly varying m and k -- */

/* Amplitude A/A0 and largest velocity over its first value when the mass has come to mass_ratio = m/m0 and
   damping = integral of b/m dt. reactive: r = 1 where what joins or leaves has no velocity, so that there is a
   reactive force; r = 0 where it has the body's. To first order in m' and b:
     A/A0 = (m0/m)^((2r-1)/(alpha+3)) exp(-2 damping/(alpha+3))      [(325), (344), (367), (389) corrected]
   All three averaging methods give it, once (335)'s sign is mended. */
VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha);
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha);

/* How a mass or a stiffness depends on time: positive at all times from 0 on that are asked for. The value at t = 0
   is f0, but for tables and functions. A table is interpolated monotonically, by cubics with Fritsch and Butland's
   slopes; times rise, and t must lie between the first and the last. */
typedef int (*vm_law_function)(vm_real t, vm_real *f, vm_real *rate, void *ctx); /* f(t), df/dt; 0 or failure */
enum {
    VM_LAW_LINEAR = 0,      /* f0 + f1 t (346); constant where f1 = 0 */
    VM_LAW_QUADRATIC = 1,   /* f0 + f1 t + f2 t^2 */
    VM_LAW_EXPONENTIAL = 2, /* f0 exp(f1 t) */
    VM_LAW_POWER = 3,       /* f0 (1 + f1 t)^f2 */
    VM_LAW_TABLE = 4,       /* the points (time[i], value[i]), 0 <= i < n, n >= 2 */
    VM_LAW_FUNCTION = 5     /* function(t, ., ., ctx), smooth */
};
typedef struct VM_TAG(vm_law) {
    int kind;
    vm_real f0, f1, f2;
    int n;
    const vm_real *time, *value;
    vm_law_function function;
    void *ctx;
} vm_law;
VM_API vm_law vm_law_linear(vm_real f0, vm_real f1);
VM_API vm_law vm_law_quadratic(vm_real f0, vm_real f1, vm_real f2);
VM_API vm_law vm_law_exponential(vm_real f0, vm_real f1);
VM_API vm_law vm_law_power(vm_real f0, vm_real f1, vm_real f2);
VM_API vm_law vm_law_table(int n, const vm_real *time, const vm_real *value);
VM_API vm_law vm_law_user(vm_law_function function, void *ctx);
/* f(t), its rate, and the integral from 0 to t of ds/f: closed forms within some 8 ulp, also where they tend to 0/0;
   of tables and functions by integration, to 1e-13 (float 1e-5). VM_BAD_MASS where f <= 0 at t (the integral:
   anywhere between), VM_BAD_ARGUMENT outside a table or where the function fails. */
VM_API int vm_law_at(const vm_law *law, vm_real t, vm_real *f, vm_real *rate);
VM_API int vm_law_inverse_integral(const vm_law *law, vm_real t, vm_real *integral);

/* The problem. F, where there is one, is a further small force, N, of time, place and velocity. */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);
typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;          /* >= 0 */
    vm_law mass, stiffness; /* kg; N/m^alpha */
    vm_real reactive;       /* r: 1 with reactive force, 0 without */
    vm_real damping;        /* b, kg/s (the dissertation's eps b); negative ones drive */
    vm_real x, v;           /* at t = 0, m and m/s */
    vm_osc_force force;     /* F or null */
    void *ctx;
} vm_osc_problem;

/* Routes to x(t), x'(t), the cheapest first. q = (ln k)' + (2r-1)(ln m)' + 2b/m is the rate at which things change,
   Om the rate of the Ateb phase; q/Om must be small for the first four. */
enum {
    VM_ROUTE_TRIG = 0,      /* (329), (330), averaged to first order, with the sign of (335) mended */
    VM_ROUTE_JACOBI = 1,    /* (370), (371), averaged to first order */
    VM_ROUTE_ATEB = 2,      /* (310), (311), averaged to first order: error q/Om */
    VM_ROUTE_SECOND = 3,    /* the second-order law: error (q/Om)^2; without F only */
    VM_ROUTE_VARIATION = 4, /* exact equations of amplitude and phase, (314), (315) completed, by rk45 */
    VM_ROUTE_RK45 = 5,      /* the equation of motion itself */
    VM_ROUTE_RK87 = 6
};
VM_API const char *vm_osc_route_name(int route);

typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;
    vm_real amplitude; /* A, of the motion without the ripple of a period for the first four routes */
    vm_real error;     /* estimate of the largest of |error of x|/A and |error of v|/vmax(A) */
    int route;
    long evals; /* of right-hand sides */
} vm_osc_motion;

/* What a problem has to have computed but once. Not for changing: it points to the problem's tables and contexts. */
typedef struct VM_TAG(vm_osc_plan) {
    vm_osc_problem problem;
    vm_real pi, gamma, mean_ca2; /* Pi_alpha, (alpha-1)/(alpha+3), the mean of ca^2 */
    vm_real m0, k0;
    vm_real A, psi, Om;          /* amplitude, Ateb phase and its rate at t = 0 */
    vm_real q, h, ln_rho, shift; /* of the second-order law at t = 0; mean phase minus psi */
    vm_real base, rate_m, rate_k; /* closed forms: m = m0 exp(rate_m u), k likewise, u = ln(1 + base t)/base */
    int closed, has_ateb;
    ateb_plan ateb;
} vm_osc_plan;

/* x(t), x'(t) at any t, by the route that is asked for. The integrators work to the tolerance (of error, above; 0 means
   1e-6, float 1e-3), which the laws disregard; each runs twice, a first time ten times less strict, and error is what the
   two differ by. Routes other than the second-order law with F: averaged equations are integrated instead of closed
   forms. vm_osc_at takes the cheapest route whose error is estimated to be within the tolerance.
   VM_TOLERANCE_MISSED: done, but error is larger than the tolerance. Errors leave *motion untouched: VM_BAD_MASS (a
   mass or stiffness that is not positive between 0 and t), VM_BAD_ARGUMENT (alpha < 0, null pointers, t outside a
   table), VM_NOT_FINITE, VM_NO_LAW (second-order law with F), VM_FAILED (an integrator gave up). */
VM_API int vm_osc_plan_init(vm_osc_plan *p, const vm_osc_problem *problem);
VM_API int vm_osc_plan_by(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion);
VM_API int vm_osc_plan_at(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion);
/* The same for a problem that is asked once */
VM_API int vm_osc_by(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion);
VM_API int vm_osc_at(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion);
VM_API int vm_osc_by_trig(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion);
VM_API int vm_osc_by_jacobi(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion);
VM_API int vm_osc_by_ateb(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion);
VM_API int vm_osc_by_second(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion);
VM_API int vm_osc_by_variation(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion);
VM_API int vm_osc_by_rk45(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion);
VM_API int vm_osc_by_rk87(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion);

/* Averaged equations at (t, A) with the force F of the problem: A', theta', psi' in the method's own angle (Ateb phase,
   radians, Jacobi argument), for VM_ROUTE_ATEB: (314), (315) averaged, with the term of omega' that they lack;
   VM_ROUTE_TRIG: (337)-(339) with alpha + 3 for 5 - alpha and 4 for the 2 of (338), (339); VM_ROUTE_JACOBI: (380)-(382)
   with theta' in the second of (382). Means by Gauss' rule on each quarter of the period, so that F may jump where x or
   x' = 0; to 1e-10 for F smooth in x and x' otherwise (float 1e-5) */
VM_API int vm_osc_averaged(const vm_osc_plan *p, int method, vm_real t, vm_real A, vm_real *A_rate,
                           vm_real *theta_rate, vm_real *psi_rate);

/* -- Chapter 7.6: Van der Pol -- */

/* -- Chapter 7.7: Laval's rotor -- */

/* -- Chapter 7.8: two bodies with a nonlinear connection -- */

/* -- Chapter 8: harmonic excitation -- */

/* -- Scenes -- */

VM_API const char *vm_strerror(int status)
{
    switch (status) {
    case VM_OK: return "success";
    case VM_NULL_AXIS: return "angular momentum about an axis without inertia was lost";
    case VM_BAD_ARGUMENT: return "null pointer";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass is not positive";
    case VM_BAD_INERTIA: return "no body has this inertia";
    case VM_SINGULAR: return "linear equations without a unique solution";
    case VM_TOLERANCE_MISSED: return "the estimated error is larger than the tolerance";
    case VM_NO_LAW: return "the route does not exist for this problem";
    case VM_FAILED: return "an integrator gave up";
    default: return "unknown status";
    }
}

/* ---- Scalars, linear equations ------------------------------------------------------------------------------ */

/* x^y for x >= 0, within 0.6 ulp, with the limits of pow at 0 and infinity; NaN for x < 0 */
VM_API vm_real vmi_raised(vm_real x, vm_real y)
{
    if (x != x || y != y || x < 0) return VM_NAN;
    if (y == 0 || x == 1) return 1;
    if (x == 0 || x > VM_MAX) return (y > 0) == (x > 0) ? VM_INFINITY : 0;
    if (!VM_IS_FINITE(y)) return (y > 0) == (x > 1) ? VM_INFINITY : 0;
    return vmi_pow(vmi_two(x, 0), vmi_two(y, 0));
}

/* sin and cos of any x, reduced by pi/2 in two words; NaN for infinite x */
VM_API void vmi_sincos(vm_real x, vm_real *sine, vm_real *cosine)
{
    const vmi_three half_pi = vmi_half_pi();
    int quarter;
    vm_real s, c;
    vmi_sin_cos(vmi_reduce(VM_FABS(x), vmi_two(half_pi.hi, half_pi.mid), &quarter), &s, &c);
    if (!VM_IS_FINITE(x)) s = c = VM_NAN;
    *sine = quarter & 1 ? c : s, *cosine = quarter & 1 ? s : c;
    if (quarter & 2) *sine = -*sine;
    if (quarter == 1 || quarter == 2) *cosine = -*cosine;
    if (x < 0) *sine = -*sine;
}

/* a x = b, a dense and n by n, row after row, by elimination with row pivoting: x replaces b, a is destroyed.
   VM_SINGULAR, b destroyed, where a column has no pivot. */
VM_API int vmi_solve_linear(int n, vm_real *a, vm_real *b)
{
    int i, j, k;
    for (k = 0; k < n; k++) {
        int pivot = k;
        vm_real x;
        for (i = k + 1; i < n; i++)
            if (VM_FABS(a[i * n + k]) > VM_FABS(a[pivot * n + k])) pivot = i;
        if (!(VM_FABS(a[pivot * n + k]) > 0)) return VM_SINGULAR;
        for (j = k; j < n; j++) x = a[k * n + j], a[k * n + j] = a[pivot * n + j], a[pivot * n + j] = x;
        x = b[k], b[k] = b[pivot], b[pivot] = x;
        for (i = k + 1; i < n; i++) {
            const vm_real factor = a[i * n + k] / a[k * n + k];
            for (j = k + 1; j < n; j++) a[i * n + j] -= factor * a[k * n + j];
            b[i] -= factor * b[k];
        }
    }
    for (k = n - 1; k >= 0; k--) {
        for (j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
    return VM_OK;
}

/* ---- Vectors, rotations, inertia ---------------------------------------------------------------------------- */

VM_API vm_vec3 vmi_vec3(vm_real x, vm_real y, vm_real z)
{
    vm_vec3 a;
    a.x = x, a.y = y, a.z = z;
    return a;
}

VM_API vm_vec3 vmi_add(vm_vec3 a, vm_vec3 b) { return vmi_vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
VM_API vm_vec3 vmi_sub(vm_vec3 a, vm_vec3 b) { return vmi_vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
VM_API vm_vec3 vmi_scale(vm_real c, vm_vec3 a) { return vmi_vec3(c * a.x, c * a.y, c * a.z); }
VM_API vm_real vmi_dot(vm_vec3 a, vm_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
VM_API vm_vec3 vmi_cross(vm_vec3 a, vm_vec3 b)
{
    return vmi_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
VM_API vm_vec3 vmi_abs(vm_vec3 a) { return vmi_vec3(VM_FABS(a.x), VM_FABS(a.y), VM_FABS(a.z)); }
VM_API vm_real vmi_size(vm_vec3 a) { return VM_FABS(a.x) + VM_FABS(a.y) + VM_FABS(a.z); }
VM_API int vmi_vec3_finite(vm_vec3 a) { return VM_IS_FINITE(a.x) && VM_IS_FINITE(a.y) && VM_IS_FINITE(a.z); }

typedef struct VM_TAG(vmi_mat3) {
    vm_vec3 x, y, z;
} vmi_mat3; /* columns: the images of the axes */

VM_API vm_vec3 vmi_times(const vmi_mat3 *m, vm_vec3 a) /* m a */
{
    return vmi_add(vmi_scale(a.x, m->x), vmi_add(vmi_scale(a.y, m->y), vmi_scale(a.z, m->z)));
}

VM_API vm_vec3 vmi_times_transposed(const vmi_mat3 *m, vm_vec3 a) /* m^T a */
{
    return vmi_vec3(vmi_dot(m->x, a), vmi_dot(m->y, a), vmi_dot(m->z, a));
}

/* The rotation of a quaternion of any length; exactly the identity for (w, 0, 0, 0) and for all zero */
VM_API vmi_mat3 vmi_rotation(vm_quat q)
{
    vm_real largest = VM_FABS(q.w), s = 0;
    vmi_mat3 m;
    if (VM_FABS(q.x) > largest) largest = VM_FABS(q.x);
    if (VM_FABS(q.y) > largest) largest = VM_FABS(q.y);
    if (VM_FABS(q.z) > largest) largest = VM_FABS(q.z);
    if (largest > 0) {
        q.w /= largest, q.x /= largest, q.y /= largest, q.z /= largest;
        s = 2 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    }
    m.x = vmi_vec3(1 - s * (q.y * q.y + q.z * q.z), s * (q.x * q.y + q.w * q.z), s * (q.x * q.z - q.w * q.y));
    m.y = vmi_vec3(s * (q.x * q.y - q.w * q.z), 1 - s * (q.x * q.x + q.z * q.z), s * (q.y * q.z + q.w * q.x));
    m.z = vmi_vec3(s * (q.x * q.z + q.w * q.y), s * (q.y * q.z - q.w * q.x), 1 - s * (q.x * q.x + q.y * q.y));
    return m;
}

/* p q: the rotation of q followed by that of p */
VM_API vm_quat vmi_quat_times(vm_quat p, vm_quat q)
{
    vm_quat r;
    r.w = p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z;
    r.x = p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y;
    r.y = p.w * q.y + p.y * q.w + p.z * q.x - p.x * q.z;
    r.z = p.w * q.z + p.z * q.w + p.x * q.y - p.y * q.x;
    return r;
}

VM_API vm_vec3 vmi_inertia_times(const vm_inertia *i, vm_vec3 a)
{
    return vmi_vec3(i->xx * a.x + i->xy * a.y + i->xz * a.z, i->xy * a.x + i->yy * a.y + i->yz * a.z,
                    i->xz * a.x + i->yz * a.y + i->zz * a.z);
}

/* m^T i m: the entries along the columns of m */
VM_API vm_inertia vmi_inertia_along(const vm_inertia *i, const vmi_mat3 *m)
{
    vm_vec3 x = vmi_inertia_times(i, m->x), y = vmi_inertia_times(i, m->y), z = vmi_inertia_times(i, m->z);
    vm_inertia t;
    t.xx = vmi_dot(m->x, x), t.yy = vmi_dot(m->y, y), t.zz = vmi_dot(m->z, z);
    t.xy = vmi_dot(m->x, y), t.xz = vmi_dot(m->x, z), t.yz = vmi_dot(m->y, z);
    return t;
}

/* a + c b */
VM_API vm_inertia vmi_inertia_plus(vm_inertia a, vm_real c, vm_inertia b)
{
    a.xx += c * b.xx, a.yy += c * b.yy, a.zz += c * b.zz;
    a.xy += c * b.xy, a.xz += c * b.xz, a.yz += c * b.yz;
    return a;
}

/* P(d) = |d|^2 E - d d^T: the inertia of a unit mass at d */
VM_API vm_inertia vmi_inertia_of_point(vm_vec3 d)
{
    vm_inertia p;
    p.xx = d.y * d.y + d.z * d.z, p.yy = d.x * d.x + d.z * d.z, p.zz = d.x * d.x + d.y * d.y;
    p.xy = -d.x * d.y, p.xz = -d.x * d.z, p.yz = -d.y * d.z;
    return p;
}

typedef struct VM_TAG(vmi_principal) {
    vm_real moment[3];
    vm_vec3 axis[3];
} vmi_principal;

/* One of Jacobi's rotations, in the plane of axes p and q: annihilates a[p][q], turns the columns of v along */
VM_API void vmi_jacobi_rotation(vm_real a[3][3], vm_real v[3][3], int p, int q)
{
    vm_real theta = (a[q][q] - a[p][p]) / (2 * a[p][q]), root = VM_SQRT(theta * theta + 1);
    vm_real t = VM_COPYSIGN(1, theta) / (VM_FABS(theta) + root), c = 1 / VM_SQRT(t * t + 1), s = t * c, x, y;
    int k = 3 - p - q;
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = 0;
    x = a[k][p], y = a[k][q];
    a[k][p] = a[p][k] = c * x - s * y;
    a[k][q] = a[q][k] = s * x + c * y;
    for (k = 0; k < 3; k++) {
        x = v[k][p], y = v[k][q];
        v[k][p] = c * x - s * y;
        v[k][q] = s * x + c * y;
    }
}

/* Principal moments and axes; the rotations converge quadratically, in four or five sweeps */
VM_API vmi_principal vmi_principal_axes(const vm_inertia *i)
{
    const int most_sweeps = 12;
    vm_real a[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vmi_principal result;
    int sweep, p, q;
    a[0][0] = i->xx, a[1][1] = i->yy, a[2][2] = i->zz;
    a[0][1] = a[1][0] = i->xy, a[0][2] = a[2][0] = i->xz, a[1][2] = a[2][1] = i->yz;
    for (sweep = 0; sweep < most_sweeps; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q] != 0) vmi_jacobi_rotation(a, v, p, q);
    for (p = 0; p < 3; p++) {
        result.moment[p] = a[p][p];
        result.axis[p] = vmi_vec3(v[0][p], v[1][p], v[2][p]);
    }
    return result;
}

/* Moments of a body: none larger than the two others together, to within slack (kg m^2) */
VM_API int vmi_possible(const vmi_principal *p, vm_real slack)
{
    vm_real a = p->moment[0], b = p->moment[1], c = p->moment[2];
    return a <= b + c + slack && b <= a + c + slack && c <= a + b + slack; /* so none is below -slack */
}

/* Moments that a body can have exactly, of a tensor that is possible within slack. A moment lost in the rounding
   errors of terms of these sizes becomes 0, one above the sum of the others that sum. 1 where anything changed */
VM_API int vmi_settle(vmi_principal *p, const vm_inertia *sizes)
{
    int k, changed = 0;
    for (k = 0; k < 3; k++) {
        vm_vec3 e = vmi_abs(p->axis[k]);
        if (p->moment[k] > 8 * VM_EPSILON * vmi_dot(e, vmi_inertia_times(sizes, e)) || p->moment[k] == 0) continue;
        p->moment[k] = 0, changed = 1;
    }
    for (k = 0; k < 3; k++) {
        vm_real others = p->moment[(k + 1) % 3] + p->moment[(k + 2) % 3];
        if (p->moment[k] <= others) continue;
        p->moment[k] = others, changed = 1;
    }
    return changed;
}

/* The tensor with these principal moments and axes */
VM_API vm_inertia vmi_inertia_from(const vmi_principal *p)
{
    vm_inertia i = {0, 0, 0, 0, 0, 0};
    int k;
    for (k = 0; k < 3; k++) {
        vm_vec3 e = p->axis[k], m = vmi_scale(p->moment[k], e);
        i.xx += m.x * e.x, i.yy += m.y * e.y, i.zz += m.z * e.z;
        i.xy += m.x * e.y, i.xz += m.x * e.z, i.yz += m.y * e.z;
    }
    return i;
}

/* What rounding may do to an inertia whose entries come from sums of the size of i */
VM_API vm_real vmi_slack(const vm_inertia *i)
{
    return 32 * VM_EPSILON * (VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz));
}

/* ---- Chapter 2: momenta and energy -------------------------------------------------------------------------- */

VM_API vm_vec3 vmi_spin_momentum(const vm_body *body) /* I omega, inertial axes */
{
    vmi_mat3 m = vmi_rotation(body->q);
    return vmi_times(&m, vmi_inertia_times(&body->inertia, vmi_times_transposed(&m, body->omega)));
}

VM_API vm_vec3 vm_momentum(const vm_body *body) { return vmi_scale(body->mass, body->v); }

VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about)
{
    return vmi_add(vmi_spin_momentum(body), vmi_cross(vmi_sub(body->r, about), vm_momentum(body)));
}

VM_API vm_real vm_kinetic_energy(const vm_body *body)
{
    return (body->mass * vmi_dot(body->v, body->v) + vmi_dot(body->omega, vmi_spin_momentum(body))) / 2;
}

/* ---- Chapter 3: jumps --------------------------------------------------------------------------------------- */

VM_API int vmi_body_finite(const vm_body *b)
{
    const vm_inertia *i = &b->inertia;
    return VM_IS_FINITE(b->mass) && vmi_vec3_finite(b->r) && vmi_vec3_finite(b->v) && vmi_vec3_finite(b->omega) &&
           vmi_vec3_finite(vmi_vec3(i->xx, i->yy, i->zz)) && vmi_vec3_finite(vmi_vec3(i->xy, i->xz, i->yz)) &&
           VM_IS_FINITE(b->q.w) && vmi_vec3_finite(vmi_vec3(b->q.x, b->q.y, b->q.z));
}

VM_API int vmi_check_body(const vm_body *b)
{
    vmi_principal p;
    if (!vmi_body_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    p = vmi_principal_axes(&b->inertia);
    return vmi_possible(&p, vmi_slack(&b->inertia)) ? VM_OK : VM_BAD_INERTIA;
}

/* omega with i omega = h but for what points along axes without moment */
VM_API vm_vec3 vmi_spin_of(const vmi_principal *p, vm_vec3 h)
{
    vm_vec3 omega = vmi_vec3(0, 0, 0);
    int k;
    for (k = 0; k < 3; k++)
        if (p->moment[k] > 0) omega = vmi_add(omega, vmi_scale(vmi_dot(p->axis[k], h) / p->moment[k], p->axis[k]));
    return omega;
}

/* omega with i omega = h, refined once. About an axis without moment (of a rod, a point) it stays the one before: 1
   where more than noise of h would have been left for that axis to carry */
VM_API int vmi_solve_spin(const vm_inertia *i, const vmi_principal *p, vm_vec3 h, vm_real noise, vm_vec3 before,
                          vm_vec3 *omega)
{
    vm_vec3 w = vmi_spin_of(p, h);
    int k, left = 0;
    w = vmi_add(w, vmi_spin_of(p, vmi_sub(h, vmi_inertia_times(i, w))));
    for (k = 0; k < 3; k++) {
        if (p->moment[k] > 0) continue;
        w = vmi_add(w, vmi_scale(vmi_dot(p->axis[k], before), p->axis[k]));
        left = left || VM_FABS(vmi_dot(p->axis[k], h)) > noise;
    }
    *omega = w;
    return left;
}

/* Separation (sign = -1) and attachment (+1) of other, with d = other->r - body->r, M1 = M + sign m, and every
   inertia about its own mass centre:
     r1 = r + sign m/M1 d (15),  v1 = (M v + sign m v2 + linear)/M1 (24),  I1 = I + sign (I2 + m M/M1 P(d)),
     I1 omega1 = I omega + sign (I2 omega2 - m d x (v1 - v2)) + couple + (at - r) x linear
   The last is (33), (34) with the impulse's moment about the body's mass centre, as (23a), (32) should have said. */

/* Entries of the size of the terms that those of m^T i m are sums of */
VM_API vm_inertia vmi_inertia_sizes(const vm_inertia *i, const vmi_mat3 *m)
{
    vm_inertia a;
    vmi_mat3 b;
    a.xx = VM_FABS(i->xx), a.yy = VM_FABS(i->yy), a.zz = VM_FABS(i->zz);
    a.xy = VM_FABS(i->xy), a.xz = VM_FABS(i->xz), a.yz = VM_FABS(i->yz);
    b.x = vmi_abs(m->x), b.y = vmi_abs(m->y), b.z = vmi_abs(m->z);
    return vmi_inertia_along(&a, &b);
}

/* I1 in the body's axes, and the sizes of the terms of its entries; share = sign m/M1 */
VM_API vm_inertia vmi_jump_inertia(const vm_body *body, const vm_body *other, vm_real sign, vm_real share,
                                   vm_inertia *sizes)
{
    const vmi_mat3 same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vmi_mat3 turn = vmi_rotation(body->q), other_turn = vmi_rotation(other->q), axes, abs_turn;
    vm_vec3 d = vmi_sub(other->r, body->r), reach = vmi_add(vmi_abs(body->r), vmi_abs(other->r));
    vm_inertia i, moved = vmi_inertia_of_point(vmi_times_transposed(&turn, d)), moved_size;
    axes.x = vmi_times_transposed(&other_turn, turn.x); /* the body's axes in the other's */
    axes.y = vmi_times_transposed(&other_turn, turn.y);
    axes.z = vmi_times_transposed(&other_turn, turn.z);
    i = vmi_inertia_plus(body->inertia, sign, vmi_inertia_along(&other->inertia, &axes));
    abs_turn.x = vmi_abs(turn.x), abs_turn.y = vmi_abs(turn.y), abs_turn.z = vmi_abs(turn.z);
    d = vmi_times_transposed(&abs_turn, vmi_abs(d)), reach = vmi_times_transposed(&abs_turn, reach);
    moved_size = vmi_inertia_of_point(vmi_add(d, reach)); /* d has the rounding errors of r: d^2 and 2 d reach */
    moved_size = vmi_inertia_plus(moved_size, -1, vmi_inertia_of_point(reach));
    *sizes = vmi_inertia_plus(vmi_inertia_sizes(&body->inertia, &same), 1,
                              vmi_inertia_sizes(&other->inertia, &axes));
    *sizes = vmi_inertia_plus(*sizes, VM_FABS(share) * body->mass, vmi_inertia_sizes(&moved_size, &same));
    return vmi_inertia_plus(i, share * body->mass, moved);
}

/* |I omega| + |r| |M v|, what rounding errors of the angular momentum about the origin go by */
VM_API vm_real vmi_angular_size(const vm_body *b)
{
    return vmi_size(vmi_spin_momentum(b)) + vmi_size(b->r) * vmi_size(vm_momentum(b));
}

/* I1 omega1, inertial axes, of the result b, whose translation is known */
VM_API vm_vec3 vmi_jump_spin_momentum(const vm_body *body, const vm_body *other, vm_real sign,
                                      const vm_impulse *external, const vm_body *b)
{
    vm_vec3 d = vmi_sub(other->r, body->r), relative = vmi_scale(other->mass, vmi_sub(b->v, other->v)), h;
    h = vmi_add(vmi_spin_momentum(body),
                vmi_scale(sign, vmi_sub(vmi_spin_momentum(other), vmi_cross(d, relative))));
    if (!external) return h;
    d = vmi_sub(external->at, body->r);
    return vmi_add(h, vmi_add(external->couple, vmi_cross(d, external->linear)));
}

/* Mass, mass centre and momentum */
VM_API int vmi_jump_translation(const vm_body *body, const vm_body *other, vm_real sign, const vm_impulse *external,
                                vm_body *b)
{
    vm_vec3 momentum = vmi_add(vm_momentum(body), vmi_scale(sign, vm_momentum(other)));
    b->mass = body->mass + sign * other->mass;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    if (external) momentum = vmi_add(momentum, external->linear);
    b->v = vmi_vec3(momentum.x / b->mass, momentum.y / b->mass, momentum.z / b->mass);
    b->r = vmi_add(body->r, vmi_scale(sign * other->mass / b->mass, vmi_sub(other->r, body->r)));
    return VM_OK;
}

VM_API int vmi_jump(const vm_body *body, const vm_body *other, vm_real sign, const vm_impulse *external,
                    vm_body *result)
{
    vm_real noise;
    vm_vec3 h;
    vm_inertia sizes;
    vmi_mat3 turn;
    vmi_principal p;
    vm_body b;
    int status;
    if (!body || !other || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_check_body(other);
    b = *body;
    if (!status) status = vmi_jump_translation(body, other, sign, external, &b);
    if (status) return status;
    b.inertia = vmi_jump_inertia(body, other, sign, sign * other->mass / b.mass, &sizes);
    p = vmi_principal_axes(&b.inertia);
    if (!vmi_possible(&p, vmi_slack(&sizes))) return VM_BAD_INERTIA;
    if (vmi_settle(&p, &sizes)) b.inertia = vmi_inertia_from(&p);
    turn = vmi_rotation(body->q);
    noise = 8 * VM_EPSILON *
            (vmi_angular_size(body) + vmi_angular_size(other) + vmi_size(b.r) * vmi_size(vm_momentum(&b)));
    h = vmi_times_transposed(&turn, vmi_jump_spin_momentum(body, other, sign, external, &b));
    status = vmi_solve_spin(&b.inertia, &p, h, noise, vmi_times_transposed(&turn, body->omega), &b.omega)
                 ? VM_NULL_AXIS
                 : VM_OK;
    b.omega = vmi_times(&turn, b.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL, vm_body *rest)
{
    return vmi_jump(whole, part, -1, external_or_NULL, rest);
}

VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole)
{
    return vmi_jump(body, added, 1, external_or_NULL, whole);
}

/* ---- Chapter 3.3.2: the broken rotor ------------------------------------------------------------------------ */

/* ---- Chapter 4: Lagrange's equations across a jump ---------------------------------------------------------- */

/* ---- Free rotation ------------------------------------------------------------------------------------------ */

/* ---- Chapter 5: continuous variation of mass ---------------------------------------------------------------- */

/* ---- Chapter 5.2: the drum ---------------------------------------------------------------------------------- */

/* ---- Chapter 6: Lagrange's equations with variable mass ----------------------------------------------------- */

/* ---- Chapter 7.2-7.3: the oscillator of constant mass ------------------------------------------------------- */

/* ds/dt of the Ateb phase, sqrt((alpha+1)/2) omega0 |x0|^((alpha-1)/2); NaN outside the domain */
VM_API vm_real vmi_osc_rate(vm_real x0, vm_real omega0, vm_real alpha)
{
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x0) || !VM_IS_FINITE(omega0)) return VM_NAN;
    if (omega0 == 0) return 0; /* where the power may be infinite */
    return VM_SQRT((alpha + 1) / 2) * VM_FABS(omega0) * vmi_raised(VM_FABS(x0), (alpha - 1) / 2);
}

VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha)
{
    return 2 * ateb_pi(alpha) / vmi_osc_rate(x0, omega0, alpha);
}

VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha)
{
    vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (rate != rate) return rate;
    return VM_SQRT(2 / (alpha + 1)) * VM_FABS(omega0) * vmi_raised(VM_FABS(x0), (alpha + 1) / 2);
}

VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vm_real rate = vmi_osc_rate(x0, omega0, alpha), sa, ca;
    if (x0 == 0 && rate == rate) rate = 0; /* at rest, where the rate may be infinite */
    ateb_saca(rate * t, alpha, &sa, &ca);
    *x = x0 * ca;
    *v = -VM_COPYSIGN(vm_osc_vmax(x0, omega0, alpha), x0) * sa;
}

VM_API vm_real vm_osc_omega_trig(vm_real alpha) { return VM_PI * vmi_osc_rate(1, 1, alpha) / ateb_pi(alpha); }

VM_API vm_real vm_osc_m_jacobi(vm_real alpha) { return jacobi_solve_kpK(ateb_pi(alpha) / (alpha + 1)); }

/* (300) with K = Pi_alpha/((alpha + 1) k') from (307) */
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha)
{
    return VM_SQRT(2 / ((alpha + 1) * jacobi_solve_kpK_m1(ateb_pi(alpha) / (alpha + 1))));
}

/* ---- Chapter 7.4: slowly varying mass ----------------------------------------------------------------------- */

VM_API int vmi_osc_law_domain(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    return mass_ratio > 0 && alpha >= 0 && VM_IS_FINITE(mass_ratio) && VM_IS_FINITE(damping) &&
           VM_IS_FINITE(reactive) && VM_IS_FINITE(alpha);
}

VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    if (!vmi_osc_law_domain(mass_ratio, damping, reactive, alpha)) return VM_NAN;
    return vmi_raised(mass_ratio, (1 - 2 * reactive) / (alpha + 3)) * vmi_exp(-2 * damping / (alpha + 3), 0);
}

/* xdot_max = sqrt(2 k A^(alpha+1)/((alpha+1) m)): (326), (364), (395) corrected */
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    vm_real share = (alpha + 1) / (alpha + 3);
    if (!vmi_osc_law_domain(mass_ratio, damping, reactive, alpha)) return VM_NAN;
    return vmi_raised(mass_ratio, (share * (1 - 2 * reactive) - 1) / 2) * vmi_exp(-share * damping, 0);
}

/* ---- Chapter 7.6: Van der Pol ------------------------------------------------------------------------------- */

/* ---- Chapter 7.7: Laval's rotor ----------------------------------------------------------------------------- */

/* ---- Chapter 7.8: two bodies with a nonlinear connection ---------------------------------------------------- */

/* ---- Chapter 8: harmonic excitation ------------------------------------------------------------------------- */

/* ---- Scenes ------------------------------------------------------------------------------------------------- */

#endif
