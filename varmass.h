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

/* How a mass or a stiffness depends on time: positive between 0 and the times that are asked for. The value at t = 0
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
    vm_real A, psi, Om;                  /* amplitude, Ateb phase and its rate at t = 0 */
    vm_real q, h, h_rate, ln_rho, shift; /* of the second-order law at t = 0; mean phase minus psi */
    vm_real base, rate_m, rate_k; /* closed forms: m = m0 exp(rate_m u), k likewise, u = ln(1 + base t)/base */
    int closed, has_ateb;
    ateb_plan ateb;
} vm_osc_plan;

/* x(t), x'(t) at any t of either sign, by the route that is asked for, or by the cheapest whose error is estimated
   to be within the tolerance. The laws cost one or two sa, ca and the integrals of the mass law, and disregard the
   tolerance. The integrators work to it (0 means 1e-6, float 1e-3): each runs twice, the second time stricter, and
   error comes from what the two differ by. With F the averaged equations are integrated instead of closed forms;
   there is no second-order law, and vm_osc_at takes the variation of constants.
   Over random problems (alpha in [0.2, 8], q of 1e-4 to 0.1, to t = 3/q; tests/test_routes.c) true errors are below
   3 times error in 99 %, never above 10, and error is 2.5 (first order), 4.5 (second order) and 5 to 10 times
   (integrators) the true one in the median. By rk87 2 % are beyond, up to 20: where alpha is no odd integer its errors
   do not go as the tolerance. Above alpha = 8 the error of the laws of first order is estimated too large.
   VM_TOLERANCE_MISSED: done, but error is larger than the tolerance (integrators only). Errors leave *motion
   untouched: VM_BAD_MASS (a mass or stiffness that is not positive between 0 and t), VM_BAD_ARGUMENT (alpha < 0, a
   negative tolerance, null pointers, t outside a table, a table out of order), VM_NOT_FINITE, VM_NO_LAW (second-order
   law with F; F on a body at rest at x = 0), VM_FAILED (an integrator gave up). */
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

/* Averaged equations at (t, A) with the force F of the problem: A', theta', psi' in the method's own angle (Ateb
   phase, radians, Jacobi argument), for VM_ROUTE_ATEB: (314), (315) averaged, with the term of omega' that they
   lack; VM_ROUTE_TRIG: (337)-(339) with alpha + 3 for 5 - alpha and 4 for the 2 of (338), (339); VM_ROUTE_JACOBI:
   (380)-(382) with theta' in the second of (382). Means by Gauss' rule on each quarter of the period, so that F may
   jump where x or x' = 0: to 1e-10 for cubic F and alpha <= 30 (float: roundings). 160 calls of F. */
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

VM_API vm_real vm_osc_energy(vm_real x, vm_real v, vm_real omega0, vm_real alpha)
{
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha)) return VM_NAN;
    return v * v / 2 + omega0 * omega0 * vmi_raised(VM_FABS(x), alpha + 1) / (alpha + 1);
}

/* The amplitude that the velocity alone would give, A_v^((alpha+1)/2) = v/(sqrt(2/(alpha+1)) omega0), and |x| are put
   together as A^(alpha+1) = |x|^(alpha+1) + A_v^(alpha+1), scaled so that no power overflows that A does not. */
VM_API void vm_osc_amplitude_phase(vm_real x, vm_real v, vm_real omega0, vm_real alpha, vm_real *A, vm_real *psi)
{
    const vm_real n = alpha + 1, s = v / (VM_SQRT(2 / n) * VM_FABS(omega0));
    vm_real a, b, larger;
    *A = *psi = VM_NAN;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x) || !VM_IS_FINITE(s)) return;
    a = VM_FABS(x), b = vmi_raised(VM_FABS(s), 2 / n);
    larger = a > b ? a : b;
    *A = larger == 0 || a == 0 || b == 0 ? larger
                                         : larger * vmi_raised(1 + vmi_raised((a > b ? b : a) / larger, n), 1 / n);
    *psi = ateb_phase(s == 0 ? 0 : -s, x, alpha);
}

VM_API void vm_osc_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real omega0, vm_real alpha, vm_real *x,
                              vm_real *v)
{
    vm_real A, psi, rate, sa, ca;
    vm_osc_amplitude_phase(x0, v0, omega0, alpha, &A, &psi);
    rate = A == 0 ? 0 : vmi_osc_rate(A, omega0, alpha);
    ateb_saca(psi + rate * t, alpha, &sa, &ca);
    *x = A * ca;
    *v = -vm_osc_vmax(A, omega0, alpha) * sa;
}

/* A periodic function that stands for the motion, x = A c, x' = -speed vmax(A) s, as a function of the Ateb phase
   psi, of which its own angle is turn psi. In the averaged equations with a force F by mass, V = speed vmax(A),
     A'/A = -q/(alpha+3) - gain_A <F s>/V,   theta' = -gain_theta <F c>/V   (in its own angle) */
typedef struct VM_TAG(vmi_osc_wave) {
    int method;
    vm_real alpha, turn, speed, gain_A, gain_theta;
    vm_real m; /* k^2 of cn */
    const ateb_plan *ateb;
} vmi_osc_wave;

VM_API vmi_osc_wave vmi_osc_wave_of(int method, vm_real alpha, vm_real pi, const ateb_plan *ateb_or_NULL)
{
    vmi_osc_wave w;
    w.method = method, w.alpha = alpha, w.ateb = ateb_or_NULL;
    w.turn = w.speed = w.gain_theta = 1, w.gain_A = 2 / (alpha + 1), w.m = 0;
    if (method == VM_ROUTE_TRIG) {
        w.turn = VM_PI / pi;
        w.gain_A = w.gain_theta = 4 / (alpha + 3); /* 5 - alpha in (337)-(339): the sign in (335) */
    }
    if (method == VM_ROUTE_JACOBI) {
        vm_real C2, C4, C6, bracket;
        w.m = jacobi_solve_kpK(pi / (alpha + 1));
        w.turn = 2 * jacobi_K(w.m) / pi;
        jacobi_cn_means(w.m, &C2, &C4, &C6);
        bracket = (1 - w.m) + w.m * C4; /* = 2 <sn^2 dn^2> */
        w.gain_A = 4 / ((alpha + 3) * bracket), w.gain_theta = 1 / bracket;
    }
    if (method != VM_ROUTE_ATEB) w.speed = (alpha + 1) / 2 * w.turn;
    return w;
}

VM_API void vmi_osc_wave_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    if (w->method == VM_ROUTE_TRIG) vmi_sincos(w->turn * psi, s, c);
    else if (w->method == VM_ROUTE_JACOBI) {
        vm_real dn;
        jacobi_sncndn(w->turn * psi, w->m, s, c, &dn);
        *s *= dn;
    } else if (w->ateb) ateb_plan_saca(w->ateb, psi, s, c);
    else ateb_saca(psi, w->alpha, s, c);
}

VM_API void vmi_osc_constant(int method, vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x,
                             vm_real *v)
{
    const vm_real pi = ateb_pi(alpha);
    const vmi_osc_wave w = vmi_osc_wave_of(method, alpha, pi, NULL);
    vm_real rate = vmi_osc_rate(x0, omega0, alpha), c, s;
    if (x0 == 0 && rate == rate) rate = 0;
    vmi_osc_wave_at(&w, rate * t, &c, &s);
    *x = x0 * c;
    *v = -VM_COPYSIGN(w.speed * vm_osc_vmax(x0, omega0, alpha), x0) * s;
}

VM_API void vm_osc_trig(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vmi_osc_constant(VM_ROUTE_TRIG, t, x0, omega0, alpha, x, v);
}

VM_API void vm_osc_jacobi(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vmi_osc_constant(VM_ROUTE_JACOBI, t, x0, omega0, alpha, x, v);
}

/* Largest differences from ca and sa, over a quarter of the period, at points that crowd where x = 0 */
VM_API void vmi_osc_wave_errors(const vmi_osc_wave *w, vm_real pi, vm_real *x_error, vm_real *v_error)
{
    const int points = 256;
    int i;
    *x_error = *v_error = 0;
    for (i = 0; i <= points; i++) {
        const vm_real u = (vm_real)i / (vm_real)points, psi = pi / 2 * (1 - u * u);
        vm_real sa, ca, c, s;
        ateb_saca(psi, w->alpha, &sa, &ca);
        vmi_osc_wave_at(w, psi, &c, &s);
        c = VM_FABS(c - ca), s = VM_FABS(w->speed * s - sa);
        if (c > *x_error) *x_error = c;
        if (s > *v_error) *v_error = s;
    }
}

VM_API vm_osc_comparison vm_osc_compare(vm_real alpha)
{
    const vm_real pi = ateb_pi(alpha);
    vm_osc_comparison r = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vmi_osc_wave w;
    if (pi != pi) return r;
    w = vmi_osc_wave_of(VM_ROUTE_TRIG, alpha, pi, NULL);
    r.trig_vmax = w.speed;
    vmi_osc_wave_errors(&w, pi, &r.trig_x, &r.trig_v);
    w = vmi_osc_wave_of(VM_ROUTE_JACOBI, alpha, pi, NULL);
    r.jacobi_vmax = w.m > VM_C(0.5) ? w.speed / (2 * VM_SQRT(w.m)) : 1;
    vmi_osc_wave_errors(&w, pi, &r.jacobi_x, &r.jacobi_v);
    return r;
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

/* -- Laws of mass and stiffness -- */

/* ln(1 + x)/x and (e^x - 1)/x, 1 at x = 0: quotients of differences from 1 with the same rounding (Kahan) */
VM_API vm_real vmi_log_ratio(vm_real x)
{
    const vm_real y = vmi_rounded(1 + x);
    return y == 1 ? 1 : vmi_log(y).hi / (y - 1);
}
VM_API vm_real vmi_exp_ratio(vm_real x)
{
    const vm_real y = vmi_rounded(vmi_exp(x, 0));
    if (y == 1) return 1;
    return x > 1 || x < -1 ? (y - 1) / x : (y - 1) / vmi_log(y).hi;
}

VM_API vm_law vmi_law_of(int kind, vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law;
    law.kind = kind, law.f0 = f0, law.f1 = f1, law.f2 = f2;
    law.n = 0, law.time = law.value = NULL, law.function = NULL, law.ctx = NULL;
    return law;
}
VM_API vm_law vm_law_linear(vm_real f0, vm_real f1) { return vmi_law_of(VM_LAW_LINEAR, f0, f1, 0); }
VM_API vm_law vm_law_quadratic(vm_real f0, vm_real f1, vm_real f2)
{
    return vmi_law_of(VM_LAW_QUADRATIC, f0, f1, f2);
}
VM_API vm_law vm_law_exponential(vm_real f0, vm_real f1) { return vmi_law_of(VM_LAW_EXPONENTIAL, f0, f1, 0); }
VM_API vm_law vm_law_power(vm_real f0, vm_real f1, vm_real f2) { return vmi_law_of(VM_LAW_POWER, f0, f1, f2); }
VM_API vm_law vm_law_table(int n, const vm_real *time, const vm_real *value)
{
    vm_law law = vmi_law_of(VM_LAW_TABLE, 0, 0, 0);
    law.n = n, law.time = time, law.value = value;
    return law;
}
VM_API vm_law vm_law_user(vm_law_function function, void *ctx)
{
    vm_law law = vmi_law_of(VM_LAW_FUNCTION, 0, 0, 0);
    law.function = function, law.ctx = ctx;
    return law;
}

/* Slope at point i of a table: the harmonic mean of the chords beside it, weighted (Fritsch and Butland); at the ends
   that of the parabola through three points, held back so that the cubic stays monotone */
VM_API vm_real vmi_law_slope(const vm_law *law, int i)
{
    const vm_real *t = law->time, *f = law->value;
    const int last = law->n - 1, end = i == 0 || i == last, j = i == 0 ? 1 : i == last ? last - 1 : i;
    vm_real h0, h1, d0, d1, slope;
    if (last == 1) return (f[1] - f[0]) / (t[1] - t[0]);
    h0 = t[j] - t[j - 1], h1 = t[j + 1] - t[j];
    d0 = (f[j] - f[j - 1]) / h0, d1 = (f[j + 1] - f[j]) / h1;
    if (!end) return d0 * d1 <= 0 ? 0 : 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    if (i == last) slope = h0, h0 = h1, h1 = slope, slope = d0, d0 = d1, d1 = slope;
    slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0) return 0;
    return d0 * d1 < 0 && VM_FABS(slope) > 3 * VM_FABS(d0) ? 3 * d0 : slope;
}

/* i of the interval time[i] .. time[i+1] with t in it; where t is a point, the interval on that side of it */
VM_API int vmi_law_interval(const vm_law *law, vm_real t, int side)
{
    int low = 0, high = law->n - 1;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (t > law->time[middle] || (t == law->time[middle] && side > 0)) low = middle;
        else high = middle;
    }
    return low;
}

VM_API int vmi_law_from_table(const vm_law *law, vm_real t, int side, vm_real *f)
{
    vm_real h, u, d, s0, s1, b, c;
    int i;
    if (law->n < 2 || !law->time || !law->value || !(t >= law->time[0] && t <= law->time[law->n - 1]))
        return VM_BAD_ARGUMENT;
    i = vmi_law_interval(law, t, side);
    h = law->time[i + 1] - law->time[i], u = t - law->time[i];
    d = (law->value[i + 1] - law->value[i]) / h;
    s0 = vmi_law_slope(law, i), s1 = vmi_law_slope(law, i + 1);
    b = (3 * d - 2 * s0 - s1) / h, c = (s0 + s1 - 2 * d) / (h * h);
    f[0] = law->value[i] + u * (s0 + u * (b + u * c));
    f[1] = s0 + u * (2 * b + 3 * u * c);
    f[2] = 2 * b + 6 * u * c;
    f[3] = 6 * c;
    return VM_OK;
}

/* The second derivative of a user's function, of second order from values at t, t + step, t + 2 step */
VM_API int vmi_law_from_function(const vm_law *law, vm_real t, vm_real step, vm_real *f)
{
    vm_real unused, rate[2];
    int i;
    f[2] = 0;
    if (!law->function || law->function(t, f, f + 1, law->ctx)) return VM_BAD_ARGUMENT;
    if (step == 0) return VM_OK;
    for (i = 0; i < 2; i++)
        if (law->function(t + (vm_real)(i + 1) * step, &unused, rate + i, law->ctx)) return VM_BAD_ARGUMENT;
    f[2] = (4 * (rate[0] - f[1]) - (rate[1] - f[1])) / (2 * step);
    return VM_OK;
}

/* f, f', f'' at t, the last on that side of t where it jumps; step as above, 0 where f'' of functions is not wanted.
   f''' where it is more than changes of f'' in the time of changes of f: in tables, else 0 */
VM_API int vmi_law_derivatives(const vm_law *law, vm_real t, int side, vm_real step, vm_real *f)
{
    int status = VM_OK;
    f[3] = 0;
    switch (law->kind) {
    case VM_LAW_LINEAR: f[0] = law->f0 + law->f1 * t, f[1] = law->f1, f[2] = 0; break;
    case VM_LAW_QUADRATIC:
        f[0] = law->f0 + t * (law->f1 + t * law->f2), f[1] = law->f1 + 2 * law->f2 * t, f[2] = 2 * law->f2;
        break;
    case VM_LAW_EXPONENTIAL:
        f[0] = law->f0 * vmi_exp(law->f1 * t, 0), f[1] = law->f1 * f[0], f[2] = law->f1 * f[1];
        break;
    case VM_LAW_POWER: {
        const vm_real base = 1 + law->f1 * t, c = law->f1 / base;
        f[0] = law->f0 * vmi_raised(base, law->f2), f[1] = law->f2 * c * f[0], f[2] = (law->f2 - 1) * c * f[1];
        if (!(base > 0)) return VM_BAD_MASS;
        break;
    }
    case VM_LAW_TABLE: status = vmi_law_from_table(law, t, side, f); break;
    case VM_LAW_FUNCTION: status = vmi_law_from_function(law, t, step, f); break;
    default: return VM_BAD_ARGUMENT;
    }
    if (status) return status;
    if (!VM_IS_FINITE(f[0]) || !VM_IS_FINITE(f[1]) || !VM_IS_FINITE(f[2])) return VM_NOT_FINITE;
    return f[0] > 0 ? VM_OK : VM_BAD_MASS;
}

VM_API int vm_law_at(const vm_law *law, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real values[4];
    int status;
    if (!law || !f || !rate) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_derivatives(law, t, 1, 0, values);
    if (status) return status;
    *f = values[0], *rate = values[1];
    return VM_OK;
}

/* Is the law positive between 0 and t, as far as can be told without going there? Tables: all of it, and in order */
VM_API int vmi_law_check(const vm_law *law, vm_real t)
{
    vm_real f[4];
    int i, status = vmi_law_derivatives(law, 0, 1, 0, f);
    if (!status) status = vmi_law_derivatives(law, t, 1, 0, f);
    if (status) return status;
    if (law->kind == VM_LAW_QUADRATIC && law->f2 > 0) {
        const vm_real lowest = -law->f1 / (2 * law->f2);
        if (lowest * t > 0 && VM_FABS(lowest) < VM_FABS(t)) return vmi_law_derivatives(law, lowest, 1, 0, f);
    }
    if (law->kind == VM_LAW_TABLE)
        for (i = 0; i < law->n; i++) {
            if (!VM_IS_FINITE(law->value[i]) || !VM_IS_FINITE(law->time[i])) return VM_NOT_FINITE;
            if (!(law->value[i] > 0)) return VM_BAD_MASS;
            if (i > 0 && !(law->time[i] > law->time[i - 1])) return VM_BAD_ARGUMENT;
        }
    return VM_OK;
}

/* Laws that are f0 exp(rate u), u = ln(1 + base t)/base (t where base = 0): 1 and base, rate; constants have rate 0.
   A quadratic one is, where it is a square within rounding. */
VM_API int vmi_law_base(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = *rate = 0;
    switch (law->kind) {
    case VM_LAW_LINEAR: *base = *rate = law->f1 / law->f0; return 1;
    case VM_LAW_EXPONENTIAL: *rate = law->f1; return 1;
    case VM_LAW_POWER: *base = law->f1, *rate = law->f1 * law->f2; return 1;
    case VM_LAW_QUADRATIC: {
        const vm_real square = law->f1 * law->f1, rest = square - 4 * law->f0 * law->f2;
        *rate = law->f1 / law->f0, *base = *rate / 2;
        return VM_FABS(rest) <= 4 * VM_EPSILON * square;
    }
    default: return 0;
    }
}

/* int_0^t dt/(f0 + f1 t + f2 t^2) = (2/y) atanh(y t/x) or (2/y) atan(y t/x), x = 2 f0 + f1 t, y^2 = +-(f1^2 - 4 f0
   f2) */
VM_API vm_real vmi_law_quadratic_integral(const vm_law *law, vm_real t)
{
    const vm_real D = law->f1 * law->f1 - 4 * law->f0 * law->f2, x = 2 * law->f0 + law->f1 * t;
    const vm_real y = VM_SQRT(VM_FABS(D)) * VM_FABS(t), s = y / x;
    if (D < 0 && y > 0) return 2 * t / y * ateb_phase(y, x, 1);
    return 2 * t / x * vmi_log_ratio(2 * s / (1 - s)) / (1 - s);
}

/* -- Integrals of the laws along the motion: int dt/m, int Om dt, int q^2/Om dt -- */

typedef struct VM_TAG(vmi_osc_slow) {
    const vm_law *mass, *stiffness;
    const vm_osc_plan *plan; /* null: only the first integral */
    int side;                /* the direction of time */
    vm_real ln_A;            /* what jumps of q' have done to the mean amplitude */
    vm_real kick2, kick3;    /* sums of squares of the jumps of h/Om^2, and of (q h + h')/Om^3 */
    int status;
} vmi_osc_slow;

/* The state of things at t: m, k, q, h of the second-order law, and the part of h' that tables make large */
typedef struct VM_TAG(vmi_osc_rates) {
    vm_real m, k, q, h, h_rate;
} vmi_osc_rates;

VM_API int vmi_osc_rates_at(const vm_osc_plan *p, vm_real t, int side, int with_h, vmi_osc_rates *r)
{
    const vm_osc_problem *o = &p->problem;
    const vm_real step = with_h && p->Om > 0 ? (vm_real)side / (32 * p->Om) : 0;
    vm_real m[4], k[4], ln_m, ln_k;
    int status = vmi_law_derivatives(&o->mass, t, side, step, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, t, side, step, k);
    if (status) return status;
    r->m = m[0], r->k = k[0];
    ln_m = m[1] / m[0], ln_k = k[1] / k[0];
    r->q = ln_k + (2 * o->reactive - 1) * ln_m + 2 * o->damping / m[0];
    r->h = (k[2] / k[0] - ln_k * ln_k) + (2 * o->reactive - 1) * (m[2] / m[0] - ln_m * ln_m) -
           2 * o->damping * ln_m / m[0];
    r->h -= r->q * (ln_k - ln_m - p->gamma * r->q) / 2;
    r->h_rate = k[3] / k[0] + (2 * o->reactive - 1) * m[3] / m[0];
    return VM_OK;
}

/* ln of A/A0 and of Om/Om0 by the adiabatic law, where k, m and int b/m dt have come to these */
VM_API void vmi_osc_adiabatic(const vm_osc_plan *p, vm_real ln_m, vm_real ln_k, vm_real damping, vm_real *ln_A,
                              vm_real *ln_Om)
{
    const vm_real alpha = p->problem.alpha, r = 2 * p->problem.reactive - 1;
    *ln_A = -(ln_k + r * ln_m + 2 * damping) / (alpha + 3);
    *ln_Om = ((1 - p->gamma) * ln_k - (1 + p->gamma * r) * ln_m) / 2 - p->gamma * damping;
}

/* dy/dt of y = int dt/m, int Om/Om0 dt, int q^2 Om0/Om dt */
VM_API int vmi_osc_slow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_slow *c = (vmi_osc_slow *)ctx;
    vmi_osc_rates r;
    vm_real f[4], ln_A, ln_Om, ratio;
    if (!c->plan) {
        c->status = vmi_law_derivatives(c->mass, t, c->side, 0, f);
        dydt[0] = 1 / f[0];
        return c->status;
    }
    c->status = vmi_osc_rates_at(c->plan, t, c->side, 0, &r);
    if (c->status) return c->status;
    vmi_osc_adiabatic(c->plan, vmi_log(r.m / c->plan->m0).hi, vmi_log(r.k / c->plan->k0).hi,
                      c->plan->problem.damping * y[0], &ln_A, &ln_Om);
    ratio = vmi_exp(ln_Om + (c->plan->problem.alpha - 1) / 2 * c->ln_A, 0);
    dydt[0] = 1 / r.m, dydt[1] = ratio, dydt[2] = r.q * r.q / ratio;
    return 0;
}

/* The next point of a table after t on the way to t_end, or t_end */
VM_API vm_real vmi_law_next_knot(const vm_law *law, vm_real t, vm_real t_end)
{
    const int side = t_end > t ? 1 : -1;
    vm_real knot;
    int i;
    if (law->kind != VM_LAW_TABLE) return t_end;
    i = vmi_law_interval(law, t, side);
    knot = law->time[side > 0 ? i + 1 : i];
    return (t_end - knot) * (vm_real)side > 0 ? knot : t_end;
}

/* The mean phase at the integrals y: Om0 y1 + c2 y2/Om0, Om0 at the mean amplitude */
VM_API vm_real vmi_osc_mean_phase(const vm_osc_plan *p, const vm_real *y)
{
    const vm_real alpha = p->problem.alpha, Om = p->Om * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real c2 = -p->mean_ca2 * (alpha + 1) / (2 * (alpha + 3) * (alpha + 3));
    return p->psi + p->shift + (Om * y[1] + c2 * y[2] / Om);
}

/* psi from the mean phase, psi = mean + slope (ca^2(psi) - <ca^2>): one step of Newton's method, error O(slope^3) */
VM_API void vmi_osc_phase_from_mean(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real mean, vm_real slope,
                                    vm_real *c, vm_real *s)
{
    vm_real step;
    vmi_osc_wave_at(w, mean, c, s);
    step = slope * (*c * *c - p->mean_ca2) / (1 + 4 * slope / (w->alpha + 1) * *s * *c);
    vmi_osc_wave_at(w, mean + step, c, s);
}

/* At t, a point of a table, q' jumps: the motion, which does not, goes on with another mean amplitude */
VM_API int vmi_osc_knot(vmi_osc_slow *c, vm_real t, const vm_real *y, vm_real ratio)
{
    const vm_osc_plan *p = c->plan;
    const vm_real n = p->problem.alpha + 1, Om = p->Om * ratio;
    const vmi_osc_wave w = vmi_osc_wave_of(VM_ROUTE_ATEB, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    vmi_osc_rates before, after;
    vm_real ca, sa, jump;
    c->status = vmi_osc_rates_at(p, t, -c->side, 1, &before);
    if (!c->status) c->status = vmi_osc_rates_at(p, t, c->side, 1, &after);
    if (c->status || before.h == after.h) return c->status;
    vmi_osc_phase_from_mean(p, &w, vmi_osc_mean_phase(p, y), after.q * n / (2 * (n + 2) * Om), &ca, &sa);
    jump = (before.h - after.h) / (Om * Om);
    c->ln_A += n / (4 * (n + 2)) * (ca * ca - p->mean_ca2) * jump;
    c->kick2 += jump * jump;
    jump = (VM_FABS(jump * after.q) + VM_FABS(before.h_rate - after.h_rate) / (Om * Om)) / Om;
    c->kick3 += jump * jump;
    return VM_OK;
}

/* y of vmi_osc_slow_rhs from 0 to t, from one point of a table to the next; n = 1 or 3 */
VM_API int vmi_osc_slow_integrals(vmi_osc_slow *c, int n, vm_real t, vm_real *y)
{
    vm_real work[RK87_WORK(3)], atol[3] = {0, 0, 0}, knot, dydt[3];
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    int status, tight = VM_MANT_DIG > 24;
    options.rtol = tight ? VM_C(1e-13) : 32 * VM_EPSILON, options.atol_each = atol, options.h0 = t / 64;
    c->side = t < 0 ? -1 : 1, c->ln_A = c->kick2 = c->kick3 = 0, c->status = VM_OK;
    y[0] = 0;
    if (n == 3) y[1] = y[2] = 0, atol[2] = options.rtol * c->plan->Om * c->plan->Om * VM_FABS(t);
    if (t == 0) return VM_OK;
    status = tight ? rk87_init(&s, vmi_osc_slow_rhs, c, n, 0, y, &options, work)
                   : rk45_init(&s, vmi_osc_slow_rhs, c, n, 0, y, &options, work);
    while (status >= 0 && s.t != t) {
        knot = vmi_law_next_knot(c->mass, s.t, t);
        if (n == 3) knot = vmi_law_next_knot(c->stiffness, s.t, knot);
        status = tight ? rk87_solve(&s, knot) : rk45_solve(&s, knot);
        if (status < 0 || knot == t) continue;
        if (n == 3 && vmi_osc_slow_rhs(s.t, s.y, dydt, c) == 0) vmi_osc_knot(c, s.t, s.y, dydt[1]);
        if (c->status) return c->status;
        status = tight ? rk87_restart(&s, s.t, s.y) : rk45_restart(&s, s.t, s.y);
    }
    if (c->status) return c->status;
    if (status < 0) return VM_FAILED;
    y[0] = s.y[0];
    if (n == 3) y[1] = s.y[1], y[2] = s.y[2];
    return VM_OK;
}

VM_API int vm_law_inverse_integral(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real base, rate, y[1];
    vmi_osc_slow c = {NULL, NULL, NULL, 1, 0, 0, 0, 0};
    int status;
    if (!law || !integral) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_check(law, t);
    if (status) return status;
    if (law->kind == VM_LAW_QUADRATIC) y[0] = vmi_law_quadratic_integral(law, t);
    else if (vmi_law_base(law, &base, &rate)) {
        const vm_real u = t * vmi_log_ratio(base * t);
        y[0] = u / law->f0 * vmi_exp_ratio((base - rate) * u);
    } else {
        c.mass = law;
        status = vmi_osc_slow_integrals(&c, 1, t, y);
    }
    if (status) return status;
    *integral = y[0];
    return VM_IS_FINITE(y[0]) ? VM_OK : VM_NOT_FINITE;
}

/* -- The plan -- */

VM_API const char *vm_osc_route_name(int route)
{
    switch (route) {
    case VM_ROUTE_TRIG: return "trigonometric";
    case VM_ROUTE_JACOBI: return "Jacobi";
    case VM_ROUTE_ATEB: return "Ateb, first order";
    case VM_ROUTE_SECOND: return "second-order law";
    case VM_ROUTE_VARIATION: return "variation of constants, rk45";
    case VM_ROUTE_RK45: return "direct, rk45";
    case VM_ROUTE_RK87: return "direct, rk87";
    default: return "unknown route";
    }
}

/* Are both laws exp(rate u) in one u, and so all integrals closed? With damping int b/m dt must go with u, too:
   where m = m0 (1 + base t), or nothing changes but by damping. */
VM_API void vmi_osc_find_base(vm_osc_plan *p)
{
    const vm_osc_problem *o = &p->problem;
    vm_real base_m, base_k;
    p->closed = vmi_law_base(&o->mass, &base_m, &p->rate_m) && vmi_law_base(&o->stiffness, &base_k, &p->rate_k) &&
                !o->force;
    if (!p->closed) return;
    p->base = p->rate_m == 0 ? base_k : base_m;
    if (p->rate_m == 0 && p->rate_k == 0) p->base = 0;
    if (p->rate_m != 0 && p->rate_k != 0 && base_m != base_k) p->closed = 0;
    if (o->damping != 0 && p->rate_m != p->base) p->closed = 0;
}

/* Constants of the second-order law from the start: ln rho, and the mean phase minus the phase */
VM_API int vmi_osc_start(vm_osc_plan *p)
{
    const vm_real n = p->problem.alpha + 1, M = p->mean_ca2, scale = 1 / p->Om;
    const vmi_osc_wave w = vmi_osc_wave_of(VM_ROUTE_ATEB, n - 1, p->pi, p->has_ateb ? &p->ateb : NULL);
    vmi_osc_rates r;
    vm_real ca, sa, g, c, e, Om_ratio, rho = 1;
    int i, status = vmi_osc_rates_at(p, 0, 1, 1, &r);
    if (status) return status;
    p->q = r.q, p->h = r.h, p->h_rate = r.h_rate, p->ln_rho = p->shift = 0;
    if (p->A == 0 || (r.q == 0 && r.h == 0)) return VM_OK;
    vmi_osc_wave_at(&w, p->psi, &ca, &sa);
    g = sa * ca, c = ca * ca - M, Om_ratio = 1;
    for (i = 0; i < 3; i++) { /* Om at the mean amplitude, A0 rho^(-2/(alpha+3)) */
        e = scale / Om_ratio;
        rho = 1 + r.q * e / 2 * g +
              (r.q * e * r.q * e * (2 - p->gamma) * (g * g - M * n / (n + 6)) + n * c * r.h * e * e) / 8;
        if (!(rho > 0) || !VM_IS_FINITE(rho)) rho = 1; /* far from slow */
        Om_ratio = vmi_raised(rho, -p->gamma);
    }
    p->ln_rho = vmi_log(rho).hi;
    p->shift = -r.q * scale / Om_ratio * n / (2 * (n + 2)) * c;
    return VM_OK;
}

/* <ca^2> = B(3/(alpha+1), 1/2)/Pi_alpha; B(q, 1/2) is Pi of alpha = 1/q - 1, from q <= 1 upward by its recurrence */
VM_API vm_real vmi_osc_mean_ca2(vm_real alpha, vm_real pi)
{
    vm_real q = 3 / (alpha + 1), factor = 1;
    for (; q > 1; q -= 1) factor *= (q - 1) / (q - VM_C(0.5));
    return factor * ateb_pi(1 / q - 1) / pi;
}

/* All but the Ateb plan, which only pays where many values are wanted */
VM_API int vmi_osc_prepare(vm_osc_plan *p, const vm_osc_problem *problem)
{
    const vm_osc_problem *o = &p->problem;
    vm_real f[4], omega;
    int status;
    p->problem = *problem, p->has_ateb = 0;
    if (!(o->alpha >= 0) || !VM_IS_FINITE(o->alpha)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(o->x) || !VM_IS_FINITE(o->v) || !VM_IS_FINITE(o->reactive) || !VM_IS_FINITE(o->damping))
        return VM_NOT_FINITE;
    status = vmi_law_check(&o->mass, 0);
    if (!status) status = vmi_law_check(&o->stiffness, 0);
    if (status) return status;
    vmi_law_derivatives(&o->mass, 0, 1, 0, f), p->m0 = f[0];
    vmi_law_derivatives(&o->stiffness, 0, 1, 0, f), p->k0 = f[0];
    omega = VM_SQRT(p->k0 / p->m0);
    p->pi = ateb_pi(o->alpha), p->gamma = (o->alpha - 1) / (o->alpha + 3);
    p->mean_ca2 = vmi_osc_mean_ca2(o->alpha, p->pi);
    vm_osc_amplitude_phase(o->x, o->v, omega, o->alpha, &p->A, &p->psi);
    p->Om = p->A == 0 ? 0 : vmi_osc_rate(p->A, omega, o->alpha);
    if (!VM_IS_FINITE(p->A) || !VM_IS_FINITE(p->psi) || !VM_IS_FINITE(p->Om)) return VM_NOT_FINITE;
    vmi_osc_find_base(p);
    return VM_OK;
}

VM_API int vm_osc_plan_init(vm_osc_plan *p, const vm_osc_problem *problem)
{
    vm_osc_plan plan;
    int status;
    if (!p || !problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(&plan, problem);
    if (status) return status;
    plan.has_ateb = ateb_plan_init(&plan.ateb, problem->alpha) == 0;
    status = vmi_osc_start(&plan);
    if (!status) *p = plan;
    return status;
}

/* -- The mean motion, by the laws -- */

typedef struct VM_TAG(vmi_osc_mean) {
    vmi_osc_rates now;
    vm_real y[3];         /* int dt/m, int Om/Om0 dt, int q^2 Om0/Om dt */
    vm_real ln_A, ratio;  /* ln A/A0, Om/Om0 by the adiabatic law */
    vm_real kick2, kick3; /* of the points of tables, as above */
} vmi_osc_mean;

VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_osc_problem *o = &p->problem;
    vmi_osc_slow c = {NULL, NULL, NULL, 1, 0, 0, 0, 0};
    vm_real ln_Om, ln_m, ln_k;
    int status = vmi_law_check(&o->mass, t);
    mean->kick2 = mean->kick3 = 0;
    if (!status) status = vmi_law_check(&o->stiffness, t);
    if (!status) status = vmi_osc_rates_at(p, t, t < 0 ? 1 : -1, 1, &mean->now);
    if (status) return status;
    if (p->closed) {
        const vm_real u = t * vmi_log_ratio(p->base * t), damping = o->damping * u / p->m0, Q = p->q;
        ln_m = p->rate_m * u, ln_k = p->rate_k * u;
        vmi_osc_adiabatic(p, ln_m, ln_k, damping, &mean->ln_A, &ln_Om);
        mean->y[0] = u / p->m0;
        mean->y[1] = u * vmi_exp_ratio(p->base * u + ln_Om);
        mean->y[2] = Q * Q * u * vmi_exp_ratio(-p->base * u - ln_Om);
    } else {
        c.mass = &o->mass, c.stiffness = &o->stiffness, c.plan = p;
        status = vmi_osc_slow_integrals(&c, 3, t, mean->y);
        if (status) return status;
        ln_m = vmi_log(mean->now.m / p->m0).hi, ln_k = vmi_log(mean->now.k / p->k0).hi;
        vmi_osc_adiabatic(p, ln_m, ln_k, o->damping * mean->y[0], &mean->ln_A, &ln_Om);
        mean->kick2 = c.kick2, mean->kick3 = c.kick3;
        mean->ln_A += c.ln_A, ln_Om += (o->alpha - 1) / 2 * c.ln_A;
    }
    mean->ratio = vmi_exp(ln_Om, 0);
    return VM_IS_FINITE(mean->y[1]) && VM_IS_FINITE(mean->ln_A) && VM_IS_FINITE(mean->ratio) ? VM_OK
                                                                                             : VM_NOT_FINITE;
}

/* -- Estimates, of the larger of |error of x|/A and |error of v|/vmax -- */

/* What roundings of the phase come to */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return 4 * VM_EPSILON * (2 + VM_FABS(p->Om * mean->y[1]));
}

/* First order leaves out ln rho and the shift of the start, the ripple of a period, and the second order of the mean
   phase: the error is these, to first order in q/Om. Of ln rho the phase makes gamma Om t. */
VM_API vm_real vmi_osc_first_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real n = p->problem.alpha + 1, e = VM_FABS(mean->now.q) / (p->Om * mean->ratio), M = p->mean_ca2;
    const vm_real c2 = M * n / (2 * (n + 2) * (n + 2)),
                  ripple = e * n / (2 * (n + 2)) * (M > VM_C(0.5) ? M : 1 - M);
    const vm_real phase = VM_FABS(p->gamma * p->ln_rho * p->Om * mean->y[1]) + VM_FABS(p->shift) + ripple +
                          VM_FABS(c2 * mean->y[2] / p->Om);
    const vm_real amplitude = (2 * VM_FABS(p->ln_rho) + e / 2) / (n + 2);
    return phase + amplitude + vmi_osc_rounding(p, mean);
}

/* The second-order law leaves out ripples of second order at the start and at t, the third order of ln rho, which the
   phase multiplies, and the fourth order of the mean phase. */
VM_API vm_real vmi_osc_second_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real Om = p->Om * mean->ratio, e = VM_FABS(mean->now.q) / Om, e0 = VM_FABS(p->q) / p->Om;
    const vm_real d = VM_FABS(mean->now.h) / (Om * Om), d0 = VM_FABS(p->h) / (p->Om * p->Om);
    const vm_real third = VM_FABS(p->h_rate) / (p->Om * p->Om) / p->Om;
    const vm_real ripple = (e * e + d) + (e0 * e0 + d0), start = e0 * e0 * e0 + e0 * d0 + d0 * VM_SQRT(d0) + third;
    const vm_real phase = VM_FABS(p->Om * mean->y[1]), drift = mean->y[2] / p->Om, g = VM_FABS(p->gamma) * phase;
    const vm_real knots = VM_SQRT(mean->kick2) + g * VM_SQRT(mean->kick3);
    return (VM_C(0.02) + VM_C(0.015) * p->problem.alpha) * ripple + VM_C(0.15) * g * start + VM_C(0.2) * knots +
           (phase > 0 ? VM_C(0.1) * drift * drift / phase : 0) + vmi_osc_rounding(p, mean);
}

/* How far a wave is from ca and sa: cos at x = 0, where its velocity is wrong; cn in the mean of its square, which is
   right where cn is exact, times a factor that fits its largest error within 5 % for alpha <= 10 */
VM_API vm_real vmi_osc_wave_error(const vm_osc_plan *p, const vmi_osc_wave *w)
{
    const vm_real alpha = p->problem.alpha;
    vm_real C2, C4, C6, error;
    if (w->method == VM_ROUTE_ATEB) return 0;
    if (w->method == VM_ROUTE_TRIG) error = VM_FABS(w->speed - 1) * (1 + alpha / 100);
    else {
        jacobi_cn_means(w->m, &C2, &C4, &C6);
        error = VM_FABS(C2 - p->mean_ca2) * (VM_C(2.7) + alpha / 2);
    }
    return error < 1 ? error : 1;
}

/* -- The laws -- */

/* x and v of amplitude A where Om is the rate of the Ateb phase, so that vmax = 2 A Om/(alpha+1) */
VM_API int vmi_osc_motion_of(const vmi_osc_wave *w, vm_real A, vm_real Om, vm_real c, vm_real s, vm_real error,
                             int route, vm_osc_motion *motion)
{
    vm_osc_motion r;
    r.x = A * c, r.v = -w->speed * (2 * A * Om / (w->alpha + 1)) * s;
    r.amplitude = A, r.error = error, r.route = route, r.evals = 0;
    if (!VM_IS_FINITE(r.x) || !VM_IS_FINITE(r.v)) return VM_NOT_FINITE;
    *motion = r;
    return VM_OK;
}

/* (310), (329), (370): A by the adiabatic law, the phase the integral of Om */
VM_API int vmi_osc_first_order(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                               vm_osc_motion *motion)
{
    vm_real c, s;
    vmi_osc_wave_at(w, p->psi + p->Om * mean->y[1], &c, &s);
    return vmi_osc_motion_of(w, p->A * vmi_exp(mean->ln_A, 0), p->Om * mean->ratio, c, s,
                             vmi_osc_first_error(p, mean) + vmi_osc_wave_error(p, w), w->method, motion);
}

/* Om at the exact amplitude is that at the mean one times rho^gamma, rho = A^((alpha+3)/2) by the mean's */
VM_API int vmi_osc_second_order(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                                vm_osc_motion *motion)
{
    const vm_real n = p->problem.alpha + 1, Om = p->Om * mean->ratio * vmi_exp(-p->gamma * p->ln_rho, 0);
    const vm_real e = mean->now.q / (2 * Om);
    vm_real c, s, ln_rho;
    vmi_osc_phase_from_mean(p, w, vmi_osc_mean_phase(p, mean->y), e * n / (n + 2), &c, &s);
    ln_rho = e * s * c;
    ln_rho = ln_rho > -1 ? ln_rho * vmi_log_ratio(ln_rho) : VM_NAN;
    return vmi_osc_motion_of(w, p->A * vmi_exp(mean->ln_A + 2 / (n + 2) * (ln_rho - p->ln_rho), 0),
                             Om * vmi_exp(p->gamma * ln_rho, 0), c, s, vmi_osc_second_error(p, mean),
                             VM_ROUTE_SECOND, motion);
}

/* -- Averaged equations with a force -- */

/* Means over a period of F s and F c at amplitude A and V = speed vmax: on each quarter 20 points of Gauss' rule as
   far as the velocity changes its sign like tanh psi, and 20 in the root of the distance from x = 0, where powers
   of it that are not whole may occur */
VM_API void vmi_osc_means(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real A, vm_real V, vm_real *Fs,
                          vm_real *Fc)
{
    VM_TABLE vm_real node[10] = {VM_C(0.99312859918509492479), VM_C(0.96397192727791379127),
                                 VM_C(0.91223442825132590587), VM_C(0.83911697182221882339),
                                 VM_C(0.74633190646015079261), VM_C(0.63605368072651502545),
                                 VM_C(0.510867001950827098),   VM_C(0.37370608871541956067),
                                 VM_C(0.22778585114164507808), VM_C(0.076526521133497333755)};
    VM_TABLE vm_real weight[10] = {VM_C(0.017614007139152118312), VM_C(0.040601429800386941331),
                                   VM_C(0.06267204833410906357),  VM_C(0.083276741576704748725),
                                   VM_C(0.10193011981724043504),  VM_C(0.11819453196151841731),
                                   VM_C(0.1316886384491766269),   VM_C(0.14209610931838205133),
                                   VM_C(0.14917298647260374679),  VM_C(0.1527533871307258507)};
    const vm_real half = p->pi / 2, cut = half < 6 ? half / 2 : 3;
    int i, quarter;
    *Fs = *Fc = 0;
    for (i = 0; i < 40; i++) {
        const int k = i % 20 / 2, far = i >= 20;
        const vm_real u = (1 + (i % 2 ? node[k] : -node[k])) / 2, length = far ? half - cut : cut;
        const vm_real share = weight[k] / 8 * length / half * (far ? 2 * u : 1);
        vm_real c, s;
        vmi_osc_wave_at(w, far ? half - length * u * u : cut * u, &c, &s);
        for (quarter = 0; quarter < 4; quarter++) {
            const vm_real qc = quarter & 1 ? -c : c, qs = quarter & 2 ? -s : s;
            const vm_real F = p->problem.force(t, A * qc, -V * qs, p->problem.ctx);
            *Fs += share * F * qs, *Fc += share * F * qc;
        }
    }
}

/* (ln A)', and theta' in the wave's own angle, at amplitude A where Om is the rate of the Ateb phase */
VM_API void vmi_osc_averaged_rates(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_rates *now, vm_real t,
                                   vm_real A, vm_real Om, vm_real *ln_A_rate, vm_real *theta_rate)
{
    const vm_real V = w->speed * (2 * A * Om / (w->alpha + 1));
    vm_real Fs = 0, Fc = 0;
    if (p->problem.force) vmi_osc_means(p, w, t, A, V, &Fs, &Fc);
    *ln_A_rate = -now->q / (w->alpha + 3) - w->gain_A * Fs / (now->m * V);
    *theta_rate = -w->gain_theta * Fc / (now->m * V);
}

/* Om/Om0 at A/A0 = e^a and these m and k */
VM_API vm_real vmi_osc_Om_ratio(const vm_osc_plan *p, const vmi_osc_rates *now, vm_real a)
{
    return VM_SQRT((now->k / p->k0) / (now->m / p->m0)) * vmi_exp((p->problem.alpha - 1) / 2 * a, 0);
}

VM_API int vm_osc_averaged(const vm_osc_plan *p, int method, vm_real t, vm_real A, vm_real *A_rate,
                           vm_real *theta_rate, vm_real *psi_rate)
{
    vmi_osc_rates now;
    vmi_osc_wave w;
    vm_real Om, rate, theta;
    int status;
    if (!p || !A_rate || !theta_rate || !psi_rate || method < 0 || method > VM_ROUTE_ATEB) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(A)) return VM_NOT_FINITE;
    if (!(A > 0)) return VM_BAD_ARGUMENT;
    status = vmi_osc_rates_at(p, t, 1, 0, &now);
    if (status) return status;
    w = vmi_osc_wave_of(method, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    Om = vmi_osc_rate(A, VM_SQRT(now.k / now.m), w.alpha);
    vmi_osc_averaged_rates(p, &w, &now, t, A, Om, &rate, &theta);
    *A_rate = A * rate, *theta_rate = theta, *psi_rate = w.turn * Om + theta;
    return VM_OK;
}

/* -- Integration -- */

typedef struct VM_TAG(vmi_osc_run) {
    const vm_osc_plan *p;
    vmi_osc_wave wave;
    int route, direct, high, side, status;
    vm_real longest, share; /* step at most, in periods and by the way to the next stop */
    long evals;
    rk45 s;
    vm_real work[RK87_WORK(2)];
} vmi_osc_run;

/* y = ln(A/A0), Ateb phase: averaged */
VM_API int vmi_osc_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_run *c = (vmi_osc_run *)ctx;
    vmi_osc_rates now;
    vm_real Om, theta;
    c->status = vmi_osc_rates_at(c->p, t, c->side, 0, &now);
    if (c->status) return c->status;
    Om = c->p->Om * vmi_osc_Om_ratio(c->p, &now, y[0]);
    vmi_osc_averaged_rates(c->p, &c->wave, &now, t, c->p->A * vmi_exp(y[0], 0), Om, dydt, &theta);
    dydt[1] = Om + theta / c->wave.turn;
    return 0;
}

/* The same, exact: (314), (315) with the term of omega' that they lack, for q that holds it and what is linear in
   x' */
VM_API int vmi_osc_variation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_run *c = (vmi_osc_run *)ctx;
    const vm_osc_problem *o = &c->p->problem;
    const vm_real n = o->alpha + 1;
    vmi_osc_rates now;
    vm_real Om, sa, ca;
    c->status = vmi_osc_rates_at(c->p, t, c->side, 0, &now);
    if (c->status) return c->status;
    Om = c->p->Om * vmi_osc_Om_ratio(c->p, &now, y[0]);
    vmi_osc_wave_at(&c->wave, y[1], &ca, &sa);
    dydt[0] = -now.q / n * sa * sa;
    dydt[1] = Om - now.q / 2 * sa * ca;
    if (o->force) {
        const vm_real A = c->p->A * vmi_exp(y[0], 0), V = 2 * A * Om / n;
        const vm_real F = o->force(t, A * ca, -V * sa, o->ctx) / (now.m * V);
        dydt[0] -= 2 / n * F * sa, dydt[1] -= F * ca;
    }
    return 0;
}

/* x|x|^(alpha-1) */
VM_API vm_real vmi_osc_elastic(vm_real x, vm_real alpha)
{
    if (alpha == 3) return x * x * x;
    if (alpha == 1) return x;
    return VM_COPYSIGN(vmi_raised(VM_FABS(x), alpha), x);
}

/* y = x/A0, (m/m0)^r x'/vmax: what reactive force makes of the velocity is taken out, so that y keeps its size */
VM_API int vmi_osc_direct_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vmi_osc_run *c = (vmi_osc_run *)ctx;
    const vm_osc_plan *p = c->p;
    const vm_osc_problem *o = &p->problem;
    const vm_real speed = 2 * p->Om / (o->alpha + 1);
    vmi_osc_rates now;
    vm_real m, weight;
    c->status = vmi_osc_rates_at(p, t, c->side, 0, &now);
    if (c->status) return c->status;
    m = now.m / p->m0, weight = o->reactive == 1 ? m : o->reactive == 0 ? 1 : vmi_raised(m, o->reactive);
    dydt[0] = speed * y[1] / weight;
    dydt[1] = -p->Om * (now.k / p->k0) * weight / m * vmi_osc_elastic(y[0], o->alpha) - o->damping / now.m * y[1];
    if (o->force) dydt[1] += o->force(t, p->A * y[0], p->A * dydt[0], o->ctx) * weight / (now.m * p->A * speed);
    return 0;
}

/* Period now, as long as the amplitude is that of y, or for the direct routes by the adiabatic law without damping */
VM_API vm_real vmi_osc_period_now(const vmi_osc_run *c)
{
    const vm_osc_plan *p = c->p;
    vmi_osc_rates now;
    vm_real ln_A, ln_Om;
    if (vmi_osc_rates_at(p, c->s.t, c->side, 0, &now)) return VM_NAN;
    if (!c->direct) return 2 * p->pi / (p->Om * vmi_osc_Om_ratio(p, &now, c->s.y[0]));
    vmi_osc_adiabatic(p, vmi_log(now.m / p->m0).hi, vmi_log(now.k / p->k0).hi, 0, &ln_A, &ln_Om);
    return 2 * p->pi / (p->Om * vmi_exp(ln_Om, 0));
}

/* On to t, stopping at the points of tables, and every 64 periods to take whole ones off the phase and to see that no
   step is longer than a part of the period (of a bounce, for large alpha): a pair that steps over them does not know
   its error */
VM_API int vmi_osc_solve(vmi_osc_run *c, vm_real t)
{
    vm_real stop, y[2], period, most, longest;
    int status = VM_OK;
    while (status >= 0 && c->s.t != t) {
        period = vmi_osc_period_now(c);
        if (!(period > 0)) return c->status ? c->status : VM_FAILED;
        stop = vmi_law_next_knot(&c->p->problem.mass, c->s.t, t);
        stop = vmi_law_next_knot(&c->p->problem.stiffness, c->s.t, stop);
        if (VM_FABS(stop - c->s.t) > 64 * period) stop = c->s.t + (vm_real)c->side * 64 * period;
        most = c->share * VM_FABS(stop - c->s.t) + 64 * VM_EPSILON * VM_FABS(t);
        longest = period * (c->p->pi < 10 ? c->longest : c->longest * 10 / c->p->pi);
        c->s.options.h_max = most < longest ? most : longest;
        status = c->high ? rk87_solve(&c->s, stop) : rk45_solve(&c->s, stop);
        if (status < 0) break;
        y[0] = c->s.y[0], y[1] = c->s.y[1];
        if (!c->direct) y[1] -= 2 * c->p->pi * VM_FLOOR(y[1] / (2 * c->p->pi));
        status = c->high ? rk87_restart(&c->s, c->s.t, y) : rk45_restart(&c->s, c->s.t, y);
    }
    return c->status ? c->status : status < 0 ? VM_FAILED : VM_OK;
}

/* x and v where the run has come to */
VM_API int vmi_osc_motion_now(vmi_osc_run *c, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->p;
    const vm_real *y = c->s.y;
    vm_real A, Om, ca, sa, weight;
    vmi_osc_rates now;
    int status = vmi_osc_rates_at(p, c->s.t, -c->side, 0, &now);
    if (status) return status;
    if (!c->direct) {
        A = p->A * vmi_exp(y[0], 0), Om = p->Om * vmi_osc_Om_ratio(p, &now, y[0]);
        vmi_osc_wave_at(&c->wave, y[1], &ca, &sa);
        return vmi_osc_motion_of(&c->wave, A, Om, ca, sa, 0, c->route, motion);
    }
    weight = vmi_raised(now.m / p->m0, p->problem.reactive);
    motion->x = p->A * y[0], motion->v = 2 * p->A * p->Om / (p->problem.alpha + 1) * y[1] / weight;
    vm_osc_amplitude_phase(motion->x, motion->v, VM_SQRT(now.k / now.m), p->problem.alpha, &motion->amplitude, &Om);
    motion->route = c->route;
    return VM_IS_FINITE(motion->amplitude) ? VM_OK : VM_NOT_FINITE;
}

/* The motion at the times of vmi_osc_check(t, .), by integration with one tolerance */
enum { VMI_OSC_CHECKS = 8 };
VM_API vm_real vmi_osc_check(vm_real t, int i)
{
    return i == VMI_OSC_CHECKS - 1 ? t : t * (vm_real)(4 + i) / (vm_real)(3 + VMI_OSC_CHECKS);
}
VM_API int vmi_osc_integrated(vmi_osc_run *c, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->p;
    rk45_options options = rk45_defaults(NULL);
    vm_real y[2], ca, sa;
    ode_rhs f = c->direct                        ? vmi_osc_direct_rhs
                : c->route == VM_ROUTE_VARIATION ? vmi_osc_variation_rhs
                                                 : vmi_osc_averaged_rhs;
    int i, status;
    c->side = t < 0 ? -1 : 1, c->status = VM_OK;
    options.rtol = c->direct ? tolerance : -1;
    options.atol = tolerance, options.max_steps = -1;
    vmi_osc_wave_at(&c->wave, p->psi, &ca, &sa);
    y[0] = c->direct ? ca : 0, y[1] = c->direct ? -sa : p->psi;
    status = c->high ? rk87_init(&c->s, f, c, 2, 0, y, &options, c->work)
                     : rk45_init(&c->s, f, c, 2, 0, y, &options, c->work);
    if (status < 0) return c->status ? c->status : VM_FAILED;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        status = vmi_osc_solve(c, vmi_osc_check(t, i));
        if (!status) status = vmi_osc_motion_now(c, motion + i);
        if (status) return status;
    }
    c->evals += c->s.evals;
    return VM_OK;
}

/* The larger of the differences of x by A and of v by vmax, the largest at the times of vmi_osc_check: at one time
   two runs may agree by chance */
VM_API vm_real vmi_osc_difference(const vm_osc_plan *p, vm_real t, const vm_osc_motion *a, const vm_osc_motion *b)
{
    vmi_osc_rates now;
    vm_real d, largest = 0;
    int i;
    for (i = 0; i < VMI_OSC_CHECKS; i++, a++, b++) {
        if (a->amplitude == 0 || vmi_osc_rates_at(p, vmi_osc_check(t, i), t < 0 ? 1 : -1, 0, &now))
            return VM_INFINITY;
        d = VM_FABS(a->x - b->x) / a->amplitude;
        if (d > largest) largest = d;
        d = VM_FABS(a->v - b->v) / vm_osc_vmax(a->amplitude, VM_SQRT(now.k / now.m), p->problem.alpha);
        if (d > largest) largest = d;
    }
    return largest;
}

/* Two runs, the second so much stricter that the control, which keeps a step while its error is within a factor of 3
   (rk87: 7.5), makes other steps, with half the longest step; and again stricter until what they differ by is within
   the tolerance. The factor of the difference leaves room for errors that do not go as the tolerance. */
VM_API int vmi_osc_integrate(const vm_osc_plan *plan, int route, vm_real t, vm_real tolerance,
                             vm_osc_motion *motion)
{
    const vm_real least = VM_EPSILON * (route == VM_ROUTE_RK87 ? 256 : 16),
                  ratio = route == VM_ROUTE_RK87 ? 60 : 15;
    const vm_real factor = route == VM_ROUTE_RK87 ? VM_C(0.25) : VM_C(0.5);
    vm_osc_plan with_ateb;
    vmi_osc_run c;
    vm_osc_motion loose[VMI_OSC_CHECKS], strict[VMI_OSC_CHECKS], *last = strict + VMI_OSC_CHECKS - 1;
    vm_real step_tolerance = tolerance < VM_C(0.008) ? tolerance / 8 : VM_C(1e-3), before = VM_INFINITY;
    int attempt, status, stalled = 0;
    c.p = plan, c.route = route, c.evals = 0;
    c.direct = route >= VM_ROUTE_RK45, c.high = route == VM_ROUTE_RK87;
    if (!plan->has_ateb) {
        with_ateb = *plan, c.p = &with_ateb;
        with_ateb.has_ateb = ateb_plan_init(&with_ateb.ateb, plan->problem.alpha) == 0;
    }
    c.wave = vmi_osc_wave_of(route <= VM_ROUTE_ATEB ? route : VM_ROUTE_ATEB, plan->problem.alpha, plan->pi,
                             c.p->has_ateb ? &c.p->ateb : NULL);
    for (attempt = 0; attempt < 6; attempt++) {
        if (step_tolerance < least) step_tolerance = least;
        c.longest = VM_C(0.2), c.share = 1;
        status = vmi_osc_integrated(&c, t, ratio * step_tolerance, loose);
        c.longest = VM_C(0.1), c.share = VM_C(0.51);
        if (!status) status = vmi_osc_integrated(&c, t, step_tolerance, strict);
        if (status) return status;
        last->error = factor * vmi_osc_difference(plan, t, strict, loose) +
                      4 * VM_EPSILON * (2 + plan->Om * VM_FABS(t));
        if (last->error > before / 2) stalled++; /* roundings, or chance */
        if (last->error <= tolerance || step_tolerance == least || stalled == 2) break;
        before = last->error;
        step_tolerance *= tolerance / last->error > VM_C(1e-4) ? tolerance / last->error / 4 : VM_C(2e-5);
    }
    last->evals = c.evals;
    *motion = *last;
    return last->error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

/* -- By a given route, and by the cheapest -- */

VM_API int vmi_osc_arguments(const vm_osc_plan *p, vm_real t, vm_real *tolerance, const vm_osc_motion *motion)
{
    if (!p || !motion) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(*tolerance)) return VM_NOT_FINITE;
    if (*tolerance < 0) return VM_BAD_ARGUMENT;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    return VM_OK;
}

/* No motion, and nothing to start one */
VM_API int vmi_osc_at_rest(const vm_osc_plan *p, int route, vm_osc_motion *motion)
{
    if (p->problem.force) return VM_NO_LAW;
    motion->x = motion->v = motion->amplitude = motion->error = 0;
    motion->route = route, motion->evals = 0;
    return VM_OK;
}

VM_API int vm_osc_plan_by(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_mean mean;
    vmi_osc_wave w;
    int status = vmi_osc_arguments(p, t, &tolerance, motion);
    if (status) return status;
    if (route < 0 || route > VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    if (p->problem.force && route == VM_ROUTE_SECOND) return VM_NO_LAW;
    status = vmi_law_check(&p->problem.mass, t);
    if (!status) status = vmi_law_check(&p->problem.stiffness, t);
    if (status) return status;
    if (p->A == 0) return vmi_osc_at_rest(p, route, motion);
    if (route > VM_ROUTE_SECOND || p->problem.force) return vmi_osc_integrate(p, route, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    w = vmi_osc_wave_of(route == VM_ROUTE_SECOND ? VM_ROUTE_ATEB : route, p->problem.alpha, p->pi,
                        p->has_ateb ? &p->ateb : NULL);
    return route == VM_ROUTE_SECOND ? vmi_osc_second_order(p, &w, &mean, motion)
                                    : vmi_osc_first_order(p, &w, &mean, motion);
}

VM_API int vm_osc_plan_at(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_mean mean;
    vmi_osc_wave w;
    vm_real first;
    int method, status = vmi_osc_arguments(p, t, &tolerance, motion);
    if (status) return status;
    if (p->A == 0) return vmi_osc_at_rest(p, VM_ROUTE_TRIG, motion);
    if (p->problem.force) return vmi_osc_integrate(p, VM_ROUTE_VARIATION, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    first = vmi_osc_first_error(p, &mean);
    for (method = VM_ROUTE_TRIG; method <= VM_ROUTE_ATEB && first <= tolerance; method++) {
        w = vmi_osc_wave_of(method, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
        if (first + vmi_osc_wave_error(p, &w) <= tolerance) return vmi_osc_first_order(p, &w, &mean, motion);
    }
    if (!(vmi_osc_second_error(p, &mean) <= tolerance))
        return vmi_osc_integrate(p, VM_ROUTE_VARIATION, t, tolerance, motion);
    w = vmi_osc_wave_of(VM_ROUTE_ATEB, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    return vmi_osc_second_order(p, &w, &mean, motion);
}

/* The plan of a problem that is asked once, without what only many values repay */
VM_API int vmi_osc_once(const vm_osc_problem *problem, vm_osc_plan *plan)
{
    int status = problem ? vmi_osc_prepare(plan, problem) : VM_BAD_ARGUMENT;
    return status ? status : vmi_osc_start(plan);
}

VM_API int vm_osc_by(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_once(problem, &plan);
    return status ? status : vm_osc_plan_by(&plan, route, t, tolerance, motion);
}

VM_API int vm_osc_at(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_once(problem, &plan);
    return status ? status : vm_osc_plan_at(&plan, t, tolerance, motion);
}

VM_API int vm_osc_by_trig(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_TRIG, t, 0, motion);
}
VM_API int vm_osc_by_jacobi(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_JACOBI, t, 0, motion);
}
VM_API int vm_osc_by_ateb(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_ATEB, t, 0, motion);
}
VM_API int vm_osc_by_second(const vm_osc_problem *problem, vm_real t, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_SECOND, t, 0, motion);
}
VM_API int vm_osc_by_variation(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_VARIATION, t, tolerance, motion);
}
VM_API int vm_osc_by_rk45(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_RK45, t, tolerance, motion);
}
VM_API int vm_osc_by_rk87(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    return vm_osc_by(problem, VM_ROUTE_RK87, t, tolerance, motion);
}

/* ---- Chapter 7.6: Van der Pol ------------------------------------------------------------------------------- */

/* ---- Chapter 7.7: Laval's rotor ----------------------------------------------------------------------------- */

/* ---- Chapter 7.8: two bodies with a nonlinear connection ---------------------------------------------------- */

/* ---- Chapter 8: harmonic excitation ------------------------------------------------------------------------- */

/* ---- Scenes ------------------------------------------------------------------------------------------------- */

#endif
