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
    VM_BAD_ARGUMENT = -1, /* a null pointer, a negative count */
    VM_NOT_FINITE = -2,   /* a number that is infinite or NaN, given or arising */
    VM_BAD_MASS = -3,     /* a mass that is not positive, the rest's included */
    VM_BAD_INERTIA = -4,  /* an inertia that no body has, the rest's included */
    VM_SINGULAR = -5      /* linear equations without a unique solution */
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

/* A body that moves in a plane */
typedef struct VM_TAG(vm_body2) {
    vm_real mass;    /* kg */
    vm_real inertia; /* kg m^2, about the axis through the own mass centre; 0 for a point */
    vm_real x, y;    /* mass centre, m */
    vm_real angle;   /* rad, anticlockwise */
    vm_real vx, vy;  /* momentum/mass, m/s */
    vm_real omega;   /* rad/s, anticlockwise */
} vm_body2;

typedef struct VM_TAG(vm_impulse2) {
    vm_real jx, jy; /* N s */
    vm_real couple; /* N m s, anticlockwise */
    vm_real x, y;   /* the point at which jx, jy act */
} vm_impulse2;

typedef struct VM_TAG(vm_balance) {
    vm_vec3 momentum;               /* after - before - impulse, N s: (6) with (20), (21) */
    vm_vec3 angular_momentum;       /* the same about the point, N m s: (12), (17) with (22) */
    vm_real momentum_scale;         /* sum of all M |v| and the impulse */
    vm_real angular_momentum_scale; /* sum of all tr(I) |omega| + |r - about| M |v| and the impulse's moment */
    vm_real energy;                 /* kinetic energy after - before, J: (94) - (93) */
} vm_balance;

/* -- Chapter 2: momentum, angular momentum, kinetic energy, inertia -- */

/* Momentum M v (1)-(3), N s; angular momentum I omega + (r - about) x M v (7)-(9), N m s, about any point; kinetic
   energy (93), (97), J. Not checked: NaN in, NaN out; NaN for a null pointer. */
VM_API vm_vec3 vm_momentum(const vm_body *body);
VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about);
VM_API vm_real vm_kinetic_energy(const vm_body *body);
VM_API vm_real vm_angular_momentum2(const vm_body2 *body, vm_real x, vm_real y);
VM_API vm_real vm_kinetic_energy2(const vm_body2 *body);

/* The plane's body as a lamina in the plane z = 0 of space */
VM_API vm_body vm_in_space(const vm_body2 *body);

/* What is left of the balances of momentum and, about any point, of angular momentum between some bodies before and
   after an instant in which external, where not NULL, acted (4)-(6), (10)-(12): zero but for rounding errors, a few
   eps of the scales, where nothing was lost. Any number of bodies, none included, on either side.
   VM_BAD_ARGUMENT, VM_NOT_FINITE. */
VM_API int vm_balance_between(int n_before, const vm_body *before, int n_after, const vm_body *after,
                              const vm_impulse *external_or_NULL, vm_vec3 about, vm_balance *balance);

/* 1 where a body can have this inertia: no principal moment negative or larger than the two others together, by more
   than 32 eps of the trace; rods and points are bodies. 0 otherwise, and for NaN and a null pointer. */
VM_API int vm_inertia_possible(const vm_inertia *inertia);

/* Inertia about a point d away from the mass centre, same axes, of a body whose own is given (40); with -mass the
   way back. */
VM_API vm_inertia vm_parallel_axes(const vm_inertia *own, vm_real mass, vm_vec3 d);

/* Inertia, about its own mass centre, of a and b together, and of what is left of the whole without the part
   (13)-(15), (40). d leads from the mass centre of the first to that of the second, *centre from that of the first to
   the result's: SS2 and SS1 of (15). One set of axes. Accuracy and errors are those of vm_attach and vm_separate. */
VM_API int vm_combine_inertia(vm_real mass_a, const vm_inertia *a, vm_real mass_b, const vm_inertia *b, vm_vec3 d,
                              vm_inertia *whole, vm_vec3 *centre);
VM_API int vm_split_inertia(vm_real mass, const vm_inertia *whole, vm_real part_mass, const vm_inertia *part,
                            vm_vec3 d, vm_inertia *rest, vm_vec3 *centre);

/* -- Chapter 3: jumps -- */

/* A part, which moved as given the instant after, has left the whole: rest gets mass, mass centre (15), inertia by
   the parallel axes, velocity (24) and angular velocity (34) of what remains; its attitude is the whole's.
   external, where not NULL, acted during the instant. Exact in space: momentum and angular momentum of rest and
   part are those of the whole plus the impulse. Where the rest is a rod or a point the spin about its null axis
   stays the whole's; VM_NULL_AXIS says that there was angular momentum left which that axis cannot carry.

   A part that moves on as before leaves the rest's motion as it was, however little of the inertia is left: only
   motions relative to the whole are added up, so that neither its speed nor a place far from the origin costs digits
   of omega. The rest's inertia is right to 8 eps of the whole's; a moment below that counts as none.
   VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS (a part as heavy as the whole, for one), VM_BAD_INERTIA (a part that
   cannot have been in the whole, for one). */
VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                       vm_body *rest);

/* Two bodies, moving as given the instant before, have become one (which is plastic impact) (24), (33): its attitude
   is body's, and so is the spin about a null axis. */
VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole);

/* n parts at once, n >= 0: but for rounding errors what comes of one after another. n = 0 is a blow on the body. */
VM_API int vm_separate_all(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                           vm_body *rest);
VM_API int vm_attach_all(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                         vm_body *whole);

/* The same in the plane (35)-(39); *_all2 as above */
VM_API int vm_separate2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                        vm_body2 *rest);
VM_API int vm_attach2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                      vm_body2 *whole);
VM_API int vm_separate_all2(const vm_body2 *whole, int n, const vm_body2 *parts,
                            const vm_impulse2 *external_or_NULL, vm_body2 *rest);
VM_API int vm_attach_all2(const vm_body2 *body, int n, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                          vm_body2 *whole);

/* Motion relative to what moves on rigidly with a body: v_r = v - v_S - Omega x (r - r_S) (25), (26), (98), (101) and
   Omega_r = omega - Omega (41), (99), (102) in v and omega; and back. All else is copied. VM_BAD_ARGUMENT. */
VM_API int vm_to_relative(const vm_body *to, const vm_body *absolute, vm_body *relative);
VM_API int vm_to_absolute(const vm_body *to, const vm_body *relative, vm_body *absolute);
VM_API int vm_to_relative2(const vm_body2 *to, const vm_body2 *absolute, vm_body2 *relative);
VM_API int vm_to_absolute2(const vm_body2 *to, const vm_body2 *relative, vm_body2 *absolute);

/* The jump in relative motions, (28)-(31), (42)-(44): those of the part given and of the rest returned are relative
   to the whole, those of the body added and of the whole relative to the body; what the first body itself does does
   not matter. */
VM_API int vm_separate_relative(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                vm_body *rest);
VM_API int vm_attach_relative(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL,
                              vm_body *whole);
VM_API int vm_separate_relative2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_body2 *rest);
VM_API int vm_attach_relative2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                               vm_body2 *whole);

/* The inverse question: how must the part leave for the rest to move as wanted? *moving is the part with the velocity
   that gives the rest the velocity *rest_v, and then the angular velocity that gives it *rest_omega; what is not
   asked for (NULL) stays the part's. *rest_omega = 0: no rotation (Table 2, 5 and 7; Table 4, 2); *rest_v = 0 too: at
   rest (Table 3, 6 and 8); the whole's own motion: unchanged (Table 3, 7).
   VM_NULL_AXIS where the part would have to spin about an axis without inertia; errors as vm_separate. */
VM_API int vm_separate_for(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                           const vm_vec3 *rest_v_or_NULL, const vm_vec3 *rest_omega_or_NULL, vm_body *moving);

/* The same in the plane; *rest_v is vx, vy */
VM_API int vm_separate_for2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                            const vm_real *rest_v_or_NULL, const vm_real *rest_omega_or_NULL, vm_body2 *moving);

/* The part keeps its spin: which velocity gives the rest the angular velocity rest_omega? Of those that do, the one
   with the least v_r, which is orthogonal to SS2; any v_r along SS2 may be added (Table 3, 7, asked for v_r).
   VM_SINGULAR where SS2 = 0; errors as vm_separate2. */
VM_API int vm_separate_for_spin2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_real rest_omega, vm_body2 *moving);

/* -- Chapter 4.1: energy of a jump -- */

/* Kinetic energy that the n parts and the rest have more than the whole had, J, as the theorem (113), (118) has it:
   the sum of the kinetic energies of their motions relative to the whole, exact in space, and the impulse's work
   v_S.linear + Omega.moment about S. At high speed it has digits that the difference of the energies has lost. NaN
   for a null pointer and n < 0. */
VM_API vm_real vm_energy_gain(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                              const vm_body *rest);
/* What body and the n added have more than the whole has, J: Carnot's loss, the kinetic energies of their motions
   relative to the whole, less the work of the impulse on it. */
VM_API vm_real vm_energy_loss(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                              const vm_body *whole);

/* -- Chapter 3.3.2: the broken rotor -- */

/* -- Chapter 4: Lagrange's equations across a jump -- */

/* -- Free rotation, exact -- */

/* -- Chapter 5: continuous variation of mass -- */

/* -- Chapter 5.2: the drum -- */

/* -- Chapter 6: Lagrange's equations with variable mass -- */

/* -- Chapter 7.2-7.3: the oscillator x'' + omega0^2 x|x|^(alpha-1) = 0, x(0) = x0, x'(0) = 0 -- */

/* Exact period (262), s, and largest velocity (267), m/s */
VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha);
VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha);
/* Exact motion, x(t) = x0 ca(alpha, 1, s) (282) and x'(t) (283), for x0 of either sign */
VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v);
/* Omega_alpha (293) of the approximation x0 cos(Omega_alpha |x0|^((alpha-1)/2) omega0 t), which has the exact
   period */
VM_API vm_real vm_osc_omega_trig(vm_real alpha);
/* m = k^2 (307) and Omega_1* (300) of x0 cn(Omega_1* |x0|^((alpha-1)/2) omega0 t | m), which also has the exact
   velocity at x = 0; -1.8079 < m < 0.8062 */
VM_API vm_real vm_osc_m_jacobi(vm_real alpha);
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha);

/* -- Chapter 7.4: m x'' + k x|x|^(alpha-1) = -(r m' + b) x' with slowly varying mass -- */

/* Amplitude A/A0 and largest velocity over its first value when the mass has come to mass_ratio = m/m0 and
   damping = integral of b/m dt. reactive: r = 1 where what joins or leaves has no velocity, so that there is a
   reactive force; r = 0 where it has the body's. To first order in m' and b:
     A/A0 = (m0/m)^((2r-1)/(alpha+3)) exp(-2 damping/(alpha+3))      [(325), (344), (367), (389) corrected]
   All three averaging methods give it, once (335)'s sign is mended. */
VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha);
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha);

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
    case VM_BAD_ARGUMENT: return "null pointer or negative count";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass is not positive";
    case VM_BAD_INERTIA: return "no body has this inertia";
    case VM_SINGULAR: return "linear equations without a unique solution";
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

VM_API vm_vec3 vm_momentum(const vm_body *body)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_scale(body->mass, body->v);
}

VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_add(vmi_spin_momentum(body), vmi_cross(vmi_sub(body->r, about), vm_momentum(body)));
}

VM_API vm_real vm_kinetic_energy(const vm_body *body)
{
    if (!body) return VM_NAN;
    return (body->mass * vmi_dot(body->v, body->v) + vmi_dot(body->omega, vmi_spin_momentum(body))) / 2;
}

VM_API vm_real vm_angular_momentum2(const vm_body2 *body, vm_real x, vm_real y)
{
    if (!body) return VM_NAN;
    return body->inertia * body->omega + body->mass * ((body->x - x) * body->vy - (body->y - y) * body->vx);
}

VM_API vm_real vm_kinetic_energy2(const vm_body2 *body)
{
    if (!body) return VM_NAN;
    return (body->mass * (body->vx * body->vx + body->vy * body->vy) + body->inertia * body->omega * body->omega) /
           2;
}

/* The plane's body with inertia.zz alone, which is all that motion in the plane asks for */
VM_API vm_body vmi_lifted(const vm_body2 *body)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = body->mass, b.inertia.zz = body->inertia;
    b.r = vmi_vec3(body->x, body->y, 0), b.v = vmi_vec3(body->vx, body->vy, 0);
    b.omega = vmi_vec3(0, 0, body->omega);
    return b;
}

VM_API vm_body vm_in_space(const vm_body2 *body)
{
    const vm_body2 none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vm_body b = vmi_lifted(body ? body : &none);
    b.inertia.xx = b.inertia.yy = b.inertia.zz / 2;
    vmi_sincos((body ? body : &none)->angle / 2, &b.q.z, &b.q.w);
    return b;
}

VM_API vm_vec3 vmi_impulse_moment(const vm_impulse *j, vm_vec3 about)
{
    return vmi_add(j->couple, vmi_cross(vmi_sub(j->at, about), j->linear));
}

VM_API int vmi_impulse_finite(const vm_impulse *j)
{
    return vmi_vec3_finite(j->linear) && vmi_vec3_finite(j->couple) && vmi_vec3_finite(j->at);
}

VM_API vm_real vmi_trace(const vm_inertia *i) { return VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz); }

/* Add sign times the body's momenta and energy */
VM_API void vmi_balance_add(vm_balance *sum, vm_real sign, const vm_body *body, vm_vec3 about)
{
    vm_vec3 momentum = vm_momentum(body);
    vm_real size = VM_SQRT(vmi_dot(momentum, momentum)), spin = VM_SQRT(vmi_dot(body->omega, body->omega));
    vm_vec3 arm = vmi_sub(body->r, about);
    sum->momentum = vmi_add(sum->momentum, vmi_scale(sign, momentum));
    sum->angular_momentum = vmi_add(sum->angular_momentum, vmi_scale(sign, vm_angular_momentum(body, about)));
    sum->momentum_scale += size;
    sum->angular_momentum_scale += vmi_trace(&body->inertia) * spin + VM_SQRT(vmi_dot(arm, arm)) * size;
    sum->energy += sign * vm_kinetic_energy(body);
}

VM_API int vm_balance_between(int n_before, const vm_body *before, int n_after, const vm_body *after,
                              const vm_impulse *external_or_NULL, vm_vec3 about, vm_balance *balance)
{
    vm_balance sum = {{0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    const vm_impulse *j = external_or_NULL;
    int i;
    if (!balance || n_before < 0 || n_after < 0 || (n_before > 0 && !before) || (n_after > 0 && !after))
        return VM_BAD_ARGUMENT;
    for (i = 0; i < n_before; i++) vmi_balance_add(&sum, -1, before + i, about);
    for (i = 0; i < n_after; i++) vmi_balance_add(&sum, 1, after + i, about);
    if (j) {
        vm_vec3 moment = vmi_impulse_moment(j, about);
        sum.momentum = vmi_sub(sum.momentum, j->linear);
        sum.angular_momentum = vmi_sub(sum.angular_momentum, moment);
        sum.momentum_scale += VM_SQRT(vmi_dot(j->linear, j->linear));
        sum.angular_momentum_scale += vmi_size(j->couple) + vmi_size(vmi_sub(j->at, about)) * vmi_size(j->linear);
    }
    if (!VM_IS_FINITE(sum.energy) || !VM_IS_FINITE(sum.momentum_scale) ||
        !VM_IS_FINITE(sum.angular_momentum_scale) || !vmi_vec3_finite(sum.momentum) ||
        !vmi_vec3_finite(sum.angular_momentum))
        return VM_NOT_FINITE;
    *balance = sum;
    return VM_OK;
}

VM_API int vmi_inertia_finite(const vm_inertia *i)
{
    return vmi_vec3_finite(vmi_vec3(i->xx, i->yy, i->zz)) && vmi_vec3_finite(vmi_vec3(i->xy, i->xz, i->yz));
}

/* A body can have the inertia i where tr(i)/2 E - i, the second moments integral of r r^T dm, has no eigenvalue below
   zero. By elimination, with a slack added against which the rounding errors, some eps of the trace, are small */
VM_API int vm_inertia_possible(const vm_inertia *inertia)
{
    const vm_inertia *i = inertia;
    vm_real half, x, y, z, yz;
    if (!i || !vmi_inertia_finite(i)) return 0;
    half = (i->xx + i->yy + i->zz + vmi_slack(i)) / 2;
    if (half == 0) return i->xx == 0 && i->yy == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    x = half - i->xx;
    if (!(x > 0)) return 0;
    y = half - i->yy - i->xy / x * i->xy;
    if (!(y > 0)) return 0;
    yz = i->yz + i->xy / x * i->xz;
    z = half - i->zz - i->xz / x * i->xz;
    return z - yz / y * yz > 0;
}

VM_API vm_inertia vm_parallel_axes(const vm_inertia *own, vm_real mass, vm_vec3 d)
{
    const vm_inertia none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    return vmi_inertia_plus(own ? *own : none, mass, vmi_inertia_of_point(d));
}

/* ---- Chapter 3: jumps --------------------------------------------------------------------------------------- */

VM_API int vmi_body_finite(const vm_body *b)
{
    return VM_IS_FINITE(b->mass) && vmi_vec3_finite(b->r) && vmi_vec3_finite(b->v) && vmi_vec3_finite(b->omega) &&
           vmi_inertia_finite(&b->inertia) && VM_IS_FINITE(b->q.w) &&
           vmi_vec3_finite(vmi_vec3(b->q.x, b->q.y, b->q.z));
}

VM_API int vmi_check_body(const vm_body *b)
{
    if (!vmi_body_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return vm_inertia_possible(&b->inertia) ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_check_body2(const vm_body2 *b)
{
    const vm_body lifted = vmi_lifted(b);
    if (!vmi_body_finite(&lifted) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return b->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
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
    vm_vec3 w = vmi_vec3(0, 0, 0);
    int k, left = 0;
    for (k = 0; k < 3; k++) {
        if (p->moment[k] > 0) continue;
        w = vmi_add(w, vmi_scale(vmi_dot(p->axis[k], before), p->axis[k]));
        left = left || VM_FABS(vmi_dot(p->axis[k], h)) > noise;
    }
    for (k = 0; k < 2; k++) w = vmi_add(w, vmi_spin_of(p, vmi_sub(h, vmi_inertia_times(i, w))));
    *omega = w;
    return left;
}

/* Separation (sign = -1) and attachment (+1) of another body, with d = SS2, M1 = M + sign m, every inertia about its
   own mass centre, and the impulse's moment about S1:
     r1 = r + sign m/M1 d (15),  v1 = (M v + sign m v2 + linear)/M1 (24),  I1 = I + sign (I2 + m M/M1 P(d)),
     I1 omega1 = I omega + sign (I2 omega2 + m M/M1 d x (v2 - v)) + moment (33), (34)
   which is the same law for both with a negative mass and inertia for what leaves, and the same in a frame that turns
   with any Omega, when omegas and v2 - v are those relative to it, (42) in space. The frame is chosen so that what
   cancels is small: it moves with the heaviest body, and for a separation it turns with the whole. */

typedef struct VM_TAG(vmi_frame) {
    vm_quat q; /* of the first body, along whose axes inertias are added up */
    vmi_mat3 turn;
    vm_vec3 r, v, omega;
} vmi_frame;

/* What a body brings into the jump, or a sum of such */
typedef struct VM_TAG(vmi_load) {
    vm_real mass;
    vm_vec3 r, v;              /* from the frame's */
    vm_vec3 h;                 /* I (omega - Omega) */
    vm_inertia inertia, sizes; /* and the sizes of the terms that its entries are sums of */
    vm_real noise;             /* h is right to some eps of this */
} vmi_load;

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

VM_API vmi_load vmi_load_of(const vmi_frame *frame, const vm_body *body)
{
    vmi_mat3 turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, own = vmi_rotation(body->q);
    const vm_quat p = body->q, q = frame->q;
    vm_vec3 spin = vmi_sub(body->omega, frame->omega);
    vmi_load load;
    if (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z) { /* equal attitudes cost no digits */
        turn.x = vmi_times_transposed(&own, frame->turn.x);
        turn.y = vmi_times_transposed(&own, frame->turn.y);
        turn.z = vmi_times_transposed(&own, frame->turn.z);
    }
    load.mass = body->mass;
    load.r = vmi_sub(body->r, frame->r), load.v = vmi_sub(body->v, frame->v);
    load.h = vmi_times(&own, vmi_inertia_times(&body->inertia, vmi_times_transposed(&own, spin)));
    load.inertia = vmi_inertia_along(&body->inertia, &turn);
    load.sizes = vmi_inertia_sizes(&body->inertia, &turn);
    load.noise = vmi_trace(&body->inertia) * (vmi_size(body->omega) + vmi_size(frame->omega));
    return load;
}

/* P(d) in the frame's axes, and the sizes of its terms when d has the rounding errors of positions of size reach */
VM_API vm_inertia vmi_moved_inertia(const vmi_frame *frame, vm_vec3 d, vm_vec3 reach, vm_inertia *sizes)
{
    vmi_mat3 turn;
    vm_vec3 size;
    turn.x = vmi_abs(frame->turn.x), turn.y = vmi_abs(frame->turn.y), turn.z = vmi_abs(frame->turn.z);
    size = vmi_times_transposed(&turn, vmi_abs(d)), reach = vmi_times_transposed(&turn, reach);
    *sizes = vmi_inertia_of_point(vmi_add(size, reach)); /* d^2 and 2 d reach */
    *sizes = vmi_inertia_plus(*sizes, -1, vmi_inertia_of_point(reach));
    sizes->xy = VM_FABS(sizes->xy), sizes->xz = VM_FABS(sizes->xz), sizes->yz = VM_FABS(sizes->yz);
    return vmi_inertia_of_point(vmi_times_transposed(&frame->turn, d));
}

/* a + sign b */
VM_API int vmi_join(const vmi_frame *frame, vmi_load *a, vm_real sign, const vmi_load *b)
{
    const vm_real mass = a->mass + sign * b->mass, share = sign * (b->mass / mass), reduced = a->mass * share;
    vm_vec3 origin = vmi_abs(frame->r), d = vmi_sub(b->r, a->r), v = vmi_sub(b->v, a->v);
    vm_vec3 reach = vmi_add(vmi_add(vmi_abs(a->r), vmi_abs(b->r)), vmi_add(origin, origin));
    vm_vec3 u = vmi_sub(v, vmi_cross(frame->omega, d));
    vm_real speeds = vmi_size(a->v) + vmi_size(b->v) + 2 * vmi_size(frame->v), turning = vmi_size(frame->omega);
    vm_inertia sizes, moved = vmi_moved_inertia(frame, d, reach, &sizes);
    if (!(mass > 0)) return VM_BAD_MASS;
    a->inertia = vmi_inertia_plus(vmi_inertia_plus(a->inertia, sign, b->inertia), reduced, moved);
    a->sizes = vmi_inertia_plus(vmi_inertia_plus(a->sizes, 1, b->sizes), VM_FABS(reduced), sizes);
    a->h = vmi_add(a->h, vmi_add(vmi_scale(sign, b->h), vmi_scale(reduced, vmi_cross(d, u))));
    a->noise += b->noise + VM_FABS(reduced) * vmi_size(d) * speeds +
                (sign < 0 ? b->mass : reduced) * vmi_size(reach) * (vmi_size(d) * turning + vmi_size(u));
    if (b->mass > a->mass) { /* from the heavier, so that a light body's motion costs no digits of it */
        a->r = vmi_sub(b->r, vmi_scale(a->mass / mass, d));
        a->v = vmi_sub(b->v, vmi_scale(a->mass / mass, v));
    } else {
        a->r = vmi_add(a->r, vmi_scale(share, d));
        a->v = vmi_add(a->v, vmi_scale(share, v));
    }
    a->mass = mass;
    return VM_OK;
}

VM_API void vmi_strike(const vmi_frame *frame, vmi_load *a, const vm_impulse *external)
{
    vm_vec3 at = vmi_sub(vmi_sub(external->at, frame->r), a->r), j = external->linear;
    a->v = vmi_add(a->v, vmi_vec3(j.x / a->mass, j.y / a->mass, j.z / a->mass));
    a->h = vmi_add(a->h, vmi_add(external->couple, vmi_cross(at, j)));
    a->noise += vmi_size(external->couple) + (vmi_size(at) + vmi_size(frame->r)) * vmi_size(j);
}

/* Bodies of space or of the plane, whichever pointer is not NULL */
typedef struct VM_TAG(vmi_bodies) {
    int n;
    const vm_body *in_space;
    const vm_body2 *in_plane;
} vmi_bodies;

VM_API vm_body vmi_pick(const vmi_bodies *list, int i)
{
    return list->in_plane ? vmi_lifted(list->in_plane + i) : list->in_space[i];
}

VM_API int vmi_check_bodies(const vmi_bodies *list)
{
    int i, status = VM_OK;
    if (list->n < 0 || (list->n > 0 && !list->in_space && !list->in_plane)) return VM_BAD_ARGUMENT;
    for (i = 0; i < list->n && !status; i++)
        status = list->in_plane ? vmi_check_body2(list->in_plane + i) : vmi_check_body(list->in_space + i);
    return status;
}

VM_API vmi_frame vmi_frame_of(const vm_body *body, const vmi_bodies *others, vm_real sign)
{
    vm_real mass = body->mass;
    vmi_frame frame;
    int i;
    frame.q = body->q, frame.turn = vmi_rotation(body->q);
    frame.r = body->r, frame.v = body->v;
    frame.omega = sign < 0 || others->n == 0 ? body->omega : vmi_vec3(0, 0, 0);
    for (i = 0; i < others->n; i++) {
        const vm_body b = vmi_pick(others, i);
        if (b.mass > mass) mass = b.mass, frame.r = b.r, frame.v = b.v;
    }
    return frame;
}

/* The body with the others joined (sign = 1) or without them (-1), struck by the impulse */
VM_API int vmi_jump_total(const vmi_frame *frame, const vm_body *body, vm_real sign, const vmi_bodies *others,
                          const vm_impulse *external, vmi_load *total)
{
    vmi_load sum = vmi_load_of(frame, body);
    int i, status = VM_OK;
    *total = sum;
    for (i = 0; i < others->n && !status; i++) {
        const vm_body other = vmi_pick(others, i);
        const vmi_load load = vmi_load_of(frame, &other);
        if (i == 0) sum = load;
        else status = vmi_join(frame, &sum, 1, &load);
    }
    if (others->n > 0 && !status) status = vmi_join(frame, total, sign, &sum);
    if (status || !external) return status;
    if (!vmi_impulse_finite(external)) return VM_NOT_FINITE;
    vmi_strike(frame, total, external);
    return VM_OK;
}

/* The angular velocity, relative to the frame, of a load whose inertia has been settled */
VM_API int vmi_load_spin(const vmi_frame *frame, const vmi_load *load, const vmi_principal *p, vm_vec3 before,
                         vm_vec3 *omega)
{
    const vm_real noise = 2 * VM_EPSILON * (load->noise + vmi_size(load->h));
    int left = vmi_solve_spin(&load->inertia, p, vmi_times_transposed(&frame->turn, load->h), noise,
                              vmi_times_transposed(&frame->turn, before), omega);
    *omega = vmi_times(&frame->turn, *omega);
    return left;
}

VM_API int vmi_settle_load(vmi_load *load, vmi_principal *p)
{
    if (!vmi_inertia_finite(&load->inertia)) return VM_NOT_FINITE;
    *p = vmi_principal_axes(&load->inertia);
    if (!vmi_possible(p, vmi_slack(&load->sizes))) return VM_BAD_INERTIA;
    if (vmi_settle(p, &load->sizes)) load->inertia = vmi_inertia_from(p);
    return VM_OK;
}

VM_API int vmi_jump(const vm_body *body, int n, const vm_body *others, vm_real sign, const vm_impulse *external,
                    vm_body *result)
{
    vmi_bodies list;
    vmi_frame frame;
    vmi_load load;
    vmi_principal p;
    vm_body b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    list.n = n, list.in_space = others, list.in_plane = NULL;
    status = vmi_check_body(body);
    if (!status) status = vmi_check_bodies(&list);
    if (status) return status;
    frame = vmi_frame_of(body, &list, sign);
    status = vmi_jump_total(&frame, body, sign, &list, external, &load);
    if (!status) status = vmi_settle_load(&load, &p);
    if (status) return status;
    b.mass = load.mass, b.inertia = load.inertia, b.q = body->q;
    b.r = vmi_add(frame.r, load.r), b.v = vmi_add(frame.v, load.v);
    if (vmi_load_spin(&frame, &load, &p, vmi_sub(body->omega, frame.omega), &b.omega)) status = VM_NULL_AXIS;
    b.omega = vmi_add(frame.omega, b.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL, vm_body *rest)
{
    return vmi_jump(whole, 1, part, -1, external_or_NULL, rest);
}

VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole)
{
    return vmi_jump(body, 1, added, 1, external_or_NULL, whole);
}

VM_API int vm_separate_all(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                           vm_body *rest)
{
    return vmi_jump(whole, n, parts, -1, external_or_NULL, rest);
}

VM_API int vm_attach_all(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                         vm_body *whole)
{
    return vmi_jump(body, n, added, 1, external_or_NULL, whole);
}

VM_API vm_body vmi_bare(vm_real mass, const vm_inertia *inertia, vm_vec3 r)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = mass, b.inertia = *inertia, b.r = r;
    return b;
}

VM_API int vmi_joined_inertia(vm_real mass_a, const vm_inertia *a, vm_real sign, vm_real mass_b,
                              const vm_inertia *b, vm_vec3 d, vm_inertia *joined, vm_vec3 *centre)
{
    vm_body first, second;
    int status;
    if (!a || !b || !joined || !centre) return VM_BAD_ARGUMENT;
    first = vmi_bare(mass_a, a, vmi_vec3(0, 0, 0)), second = vmi_bare(mass_b, b, d);
    status = vmi_jump(&first, 1, &second, sign, NULL, &first);
    if (!status) *joined = first.inertia, *centre = first.r;
    return status;
}

VM_API int vm_combine_inertia(vm_real mass_a, const vm_inertia *a, vm_real mass_b, const vm_inertia *b, vm_vec3 d,
                              vm_inertia *whole, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass_a, a, 1, mass_b, b, d, whole, centre);
}

VM_API int vm_split_inertia(vm_real mass, const vm_inertia *whole, vm_real part_mass, const vm_inertia *part,
                            vm_vec3 d, vm_inertia *rest, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass, whole, -1, part_mass, part, d, rest, centre);
}

/* ---- Chapter 3.3: in the plane ---- */

VM_API vm_impulse vmi_lifted_impulse(const vm_impulse2 *j)
{
    vm_impulse lifted;
    lifted.linear = vmi_vec3(j->jx, j->jy, 0), lifted.couple = vmi_vec3(0, 0, j->couple);
    lifted.at = vmi_vec3(j->x, j->y, 0);
    return lifted;
}

VM_API vm_body2 vmi_flat(const vm_body *b, vm_real angle)
{
    vm_body2 flat;
    flat.mass = b->mass, flat.inertia = b->inertia.zz, flat.angle = angle;
    flat.x = b->r.x, flat.y = b->r.y, flat.vx = b->v.x, flat.vy = b->v.y, flat.omega = b->omega.z;
    return flat;
}

/* (44) and its like: a load's spin relative to the frame, which without inertia is the one before */
VM_API int vmi_load_spin2(const vmi_load *load, vm_real before, vm_real *omega)
{
    *omega = load->inertia.zz > 0 ? load->h.z / load->inertia.zz : before;
    return !(load->inertia.zz > 0) && VM_FABS(load->h.z) > 2 * VM_EPSILON * (load->noise + VM_FABS(load->h.z));
}

VM_API int vmi_settle_load2(vmi_load *load)
{
    if (!VM_IS_FINITE(load->inertia.zz)) return VM_NOT_FINITE;
    if (load->inertia.zz < -32 * VM_EPSILON * load->sizes.zz) return VM_BAD_INERTIA;
    if (load->inertia.zz <= 8 * VM_EPSILON * load->sizes.zz) load->inertia.zz = 0;
    return VM_OK;
}

/* Checks, and the total of vmi_jump_total for bodies of the plane */
VM_API int vmi_jump_total2(const vm_body2 *body, const vmi_bodies *others, vm_real sign,
                           const vm_impulse2 *external, vmi_frame *frame, vmi_load *load)
{
    vm_impulse blow;
    vm_body lifted;
    int status = vmi_check_body2(body);
    if (!status) status = vmi_check_bodies(others);
    if (status) return status;
    lifted = vmi_lifted(body);
    if (external) blow = vmi_lifted_impulse(external);
    *frame = vmi_frame_of(&lifted, others, sign);
    status = vmi_jump_total(frame, &lifted, sign, others, external ? &blow : NULL, load);
    return status ? status : vmi_settle_load2(load);
}

VM_API int vmi_jump2(const vm_body2 *body, int n, const vm_body2 *others, vm_real sign, const vm_impulse2 *external,
                     vm_body2 *result)
{
    vmi_bodies list;
    vmi_frame frame;
    vmi_load load;
    vm_body2 b;
    int status;
    if (!body || !result || (n > 0 && !others)) return VM_BAD_ARGUMENT;
    list.n = n, list.in_space = NULL, list.in_plane = others;
    status = vmi_jump_total2(body, &list, sign, external, &frame, &load);
    if (status) return status;
    b.mass = load.mass, b.inertia = load.inertia.zz, b.angle = body->angle;
    b.x = frame.r.x + load.r.x, b.y = frame.r.y + load.r.y;
    b.vx = frame.v.x + load.v.x, b.vy = frame.v.y + load.v.y;
    if (vmi_load_spin2(&load, body->omega - frame.omega.z, &b.omega)) status = VM_NULL_AXIS;
    b.omega += frame.omega.z;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

VM_API int vm_separate2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                        vm_body2 *rest)
{
    return vmi_jump2(whole, 1, part, -1, external_or_NULL, rest);
}

VM_API int vm_attach2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                      vm_body2 *whole)
{
    return vmi_jump2(body, 1, added, 1, external_or_NULL, whole);
}

VM_API int vm_separate_all2(const vm_body2 *whole, int n, const vm_body2 *parts,
                            const vm_impulse2 *external_or_NULL, vm_body2 *rest)
{
    return vmi_jump2(whole, n, parts, -1, external_or_NULL, rest);
}

VM_API int vm_attach_all2(const vm_body2 *body, int n, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                          vm_body2 *whole)
{
    return vmi_jump2(body, n, added, 1, external_or_NULL, whole);
}

/* ---- Relative motion ---- */

/* Velocity of the point r of what moves on rigidly with a body: the dragging velocity of (25) */
VM_API vm_vec3 vmi_carried(const vm_body *by, vm_vec3 r)
{
    return vmi_add(by->v, vmi_cross(by->omega, vmi_sub(r, by->r)));
}

VM_API int vm_to_relative(const vm_body *to, const vm_body *absolute, vm_body *relative)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = *absolute;
    b.v = vmi_sub(vmi_sub(b.v, to->v), vmi_cross(to->omega, vmi_sub(b.r, to->r)));
    b.omega = vmi_sub(b.omega, to->omega);
    *relative = b;
    return VM_OK;
}

VM_API int vm_to_absolute(const vm_body *to, const vm_body *relative, vm_body *absolute)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = *relative;
    b.v = vmi_add(vmi_carried(to, b.r), b.v);
    b.omega = vmi_add(to->omega, b.omega);
    *absolute = b;
    return VM_OK;
}

VM_API int vm_to_relative2(const vm_body2 *to, const vm_body2 *absolute, vm_body2 *relative)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_lifted(to), b = vmi_lifted(absolute);
    vm_to_relative(&whole, &b, &b);
    *relative = vmi_flat(&b, absolute->angle);
    return VM_OK;
}

VM_API int vm_to_absolute2(const vm_body2 *to, const vm_body2 *relative, vm_body2 *absolute)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_lifted(to), b = vmi_lifted(relative);
    vm_to_absolute(&whole, &b, &b);
    *absolute = vmi_flat(&b, relative->angle);
    return VM_OK;
}

/* The law has the same form in the frame that moves and turns with the first body */
VM_API int vmi_jump_relative(const vm_body *body, const vm_body *other, vm_real sign, const vm_impulse *external,
                             vm_body *result)
{
    vm_body still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.v = still.omega = vmi_vec3(0, 0, 0);
    return vmi_jump(&still, 1, other, sign, external, result);
}

VM_API int vmi_jump_relative2(const vm_body2 *body, const vm_body2 *other, vm_real sign,
                              const vm_impulse2 *external, vm_body2 *result)
{
    vm_body2 still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.vx = still.vy = still.omega = 0;
    return vmi_jump2(&still, 1, other, sign, external, result);
}

VM_API int vm_separate_relative(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                vm_body *rest)
{
    return vmi_jump_relative(whole, part, -1, external_or_NULL, rest);
}

VM_API int vm_attach_relative(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL,
                              vm_body *whole)
{
    return vmi_jump_relative(body, added, 1, external_or_NULL, whole);
}

VM_API int vm_separate_relative2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_body2 *rest)
{
    return vmi_jump_relative2(whole, part, -1, external_or_NULL, rest);
}

VM_API int vm_attach_relative2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                               vm_body2 *whole)
{
    return vmi_jump_relative2(body, added, 1, external_or_NULL, whole);
}

/* ---- Inverse questions ---- */

/* (24) for v2: v + (linear - M1 (v1 - v))/m */
VM_API vm_vec3 vmi_part_velocity(const vm_body *whole, const vm_body *part, const vm_impulse *external,
                                 vm_vec3 rest_v)
{
    vm_vec3 momentum = vmi_scale(part->mass - whole->mass, vmi_sub(rest_v, whole->v));
    if (external) momentum = vmi_add(momentum, external->linear);
    return vmi_add(whole->v, vmi_vec3(momentum.x / part->mass, momentum.y / part->mass, momentum.z / part->mass));
}

/* The I2 Omega_r of the part with which the rest turns with rest_omega: h - I1 (rest_omega - Omega), where h is what
   the rest has when the part does not turn relative to the whole */
VM_API vm_vec3 vmi_part_spin_momentum(const vmi_frame *frame, const vmi_load *rest, vm_vec3 rest_omega)
{
    vm_vec3 turning = vmi_times_transposed(&frame->turn, vmi_sub(rest_omega, frame->omega));
    return vmi_sub(rest->h, vmi_times(&frame->turn, vmi_inertia_times(&rest->inertia, turning)));
}

/* The load that the rest would be, with the part leaving at b's velocity but turning with the whole */
VM_API int vmi_unturned_rest(const vm_body *whole, const vm_body *b, const vm_impulse *external, vmi_frame *frame,
                             vmi_load *rest)
{
    vm_body unturned = *b;
    vmi_bodies list;
    vmi_principal p;
    int status = vmi_check_body(whole);
    list.n = 1, list.in_space = &unturned, list.in_plane = NULL;
    if (!status) status = vmi_check_bodies(&list);
    if (status) return status;
    unturned.omega = whole->omega;
    *frame = vmi_frame_of(whole, &list, -1);
    status = vmi_jump_total(frame, whole, -1, &list, external, rest);
    return status ? status : vmi_settle_load(rest, &p);
}

VM_API int vm_separate_for(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                           const vm_vec3 *rest_v_or_NULL, const vm_vec3 *rest_omega_or_NULL, vm_body *moving)
{
    vmi_frame frame, own;
    vmi_load rest, load;
    vmi_principal p;
    vm_body b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    b = *part;
    if (rest_v_or_NULL) b.v = vmi_part_velocity(whole, part, external_or_NULL, *rest_v_or_NULL);
    status = vmi_unturned_rest(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) {
        own = frame, own.q = b.q, own.turn = vmi_rotation(b.q); /* along the part's axes */
        load = vmi_load_of(&own, &b);
        load.h = vmi_part_spin_momentum(&frame, &rest, *rest_omega_or_NULL);
        load.noise = rest.noise +
                     vmi_trace(&rest.inertia) * (vmi_size(*rest_omega_or_NULL) + vmi_size(frame.omega));
        status = vmi_settle_load(&load, &p);
        if (status) return status;
        if (vmi_load_spin(&own, &load, &p, vmi_sub(b.omega, own.omega), &b.omega)) status = VM_NULL_AXIS;
        b.omega = vmi_add(own.omega, b.omega);
    }
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* The same as vmi_unturned_rest */
VM_API int vmi_unturned_rest2(const vm_body2 *whole, const vm_body2 *b, const vm_impulse2 *external,
                              vmi_frame *frame, vmi_load *rest)
{
    vm_body2 unturned = *b;
    vmi_bodies list;
    int status = vmi_check_body2(b);
    if (status) return status;
    unturned.omega = whole->omega;
    list.n = 1, list.in_space = NULL, list.in_plane = &unturned;
    return vmi_jump_total2(whole, &list, -1, external, frame, rest);
}

VM_API int vm_separate_for2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                            const vm_real *rest_v_or_NULL, const vm_real *rest_omega_or_NULL, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_load rest, load;
    vm_body2 b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    b = *part;
    if (rest_v_or_NULL) {
        const vm_body from = vmi_lifted(whole), leaving = vmi_lifted(part);
        vm_impulse blow;
        vm_vec3 v;
        if (external_or_NULL) blow = vmi_lifted_impulse(external_or_NULL);
        v = vmi_part_velocity(&from, &leaving, external_or_NULL ? &blow : NULL,
                              vmi_vec3(rest_v_or_NULL[0], rest_v_or_NULL[1], 0));
        b.vx = v.x, b.vy = v.y;
    }
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) {
        load = rest, load.inertia.zz = b.inertia;
        load.h = vmi_part_spin_momentum(&frame, &rest, vmi_vec3(0, 0, *rest_omega_or_NULL));
        load.noise += rest.inertia.zz * (VM_FABS(*rest_omega_or_NULL) + VM_FABS(whole->omega));
        if (vmi_load_spin2(&load, b.omega - whole->omega, &b.omega)) status = VM_NULL_AXIS;
        b.omega += whole->omega;
    }
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* What is left of h - I1 (rest_omega - Omega) must be m M/M1 SS2 x v_r, with v_r = c k x SS2 */
VM_API int vm_separate_for_spin2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_real rest_omega, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_load rest;
    vm_body2 b;
    vm_real dx, dy, h, c;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(rest_omega)) return VM_NOT_FINITE;
    b = *part, dx = b.x - whole->x, dy = b.y - whole->y;
    b.vx = whole->vx - whole->omega * dy, b.vy = whole->vy + whole->omega * dx;
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (dx == 0 && dy == 0) return VM_SINGULAR;
    h = rest.h.z - b.inertia * (b.omega - whole->omega) - rest.inertia.zz * (rest_omega - whole->omega);
    c = h * rest.mass / (b.mass * whole->mass * (dx * dx + dy * dy));
    b.vx -= c * dy, b.vy += c * dx;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return VM_OK;
}

/* ---- Chapter 4.1: energy of a jump ---- */

/* Kinetic energy of the motions relative to the whole of n bodies and one more; the impulse's work on the whole */
VM_API vm_real vmi_relative_energy(const vm_body *whole, int n, const vm_body *bodies, const vm_body *one_more,
                                   const vm_impulse *external, vm_real *work)
{
    vm_real sum = 0;
    vm_body b;
    int i;
    if (!whole || !one_more || n < 0 || (n > 0 && !bodies)) return VM_NAN;
    for (i = 0; i <= n; i++) {
        vm_to_relative(whole, i < n ? bodies + i : one_more, &b);
        sum += vm_kinetic_energy(&b);
    }
    *work = 0;
    if (external)
        *work = vmi_dot(whole->v, external->linear) + vmi_dot(whole->omega, vmi_impulse_moment(external, whole->r));
    return sum;
}

VM_API vm_real vm_energy_gain(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                              const vm_body *rest)
{
    vm_real work = 0, sum = vmi_relative_energy(whole, n, parts, rest, external_or_NULL, &work);
    return sum + work;
}

VM_API vm_real vm_energy_loss(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                              const vm_body *whole)
{
    vm_real work = 0, sum = vmi_relative_energy(whole, n, added, body, external_or_NULL, &work);
    return sum - work;
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
