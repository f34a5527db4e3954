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

typedef struct VM_TAG(vmi_mat3) {
    vm_vec3 x, y, z;
} vmi_mat3; /* columns: the images of the axes */

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

/* A body on which no force acts, as after a jump: omega is made of sn, cn, dn of the time, the attitude of one
   theta function and a steady turn (Jacobi 1850), so that any time costs the same and errors do not grow with it.
   Nothing is integrated; the mass centre moves on a straight line. Triaxial, symmetric, spherical bodies, rods and
   points (spin about a null axis stays what it is), any axis, the middle one and the separatrix included, without
   a threshold to choose.

   Accuracy, measured, inputs taken as exact, to 1e6 turns: attitude within 8 eps (rad), omega within 5 eps
   |omega|, next to the separatrix (1 - m from 1e-2 to 1e-27) and for nearly equal moments too. An error of eps in
   an input means one of eps times the angle turned; next to the separatrix more, since every turn-over moves.
   Where products of inertia make the principal moments known to two words only, 5e-12 rad after 1e6 turns at 1 - m
   = 1e-16 (float: 4e-4 rad for needles, 8e-3 at 1e-6). Angular momentum stays within 10 eps tr(I) |omega|.
   Components of omega below 2^-505 (float 2^-57) of the largest count as 0.
   Cost: a time 3.5 to 4.5 times the C library's sin, preparing a motion 20 times that, 40 with products of
   inertia. */
typedef struct VM_TAG(vm_free_motion) {
    vm_body body; /* at t0 */
    vm_real t0;
    vmi_mat3 axes;               /* 1, 2, 3: principal, right-handed; in body axes */
    vm_quat start;               /* turns the axes in which angular momentum is along 3, or -3, into inertial ones */
    vm_real spin[3];             /* omega = spin[0] cn, spin[1] sn, spin[2] dn along 1, 2, 3, rad/s */
    vm_real lean[3];             /* the same of angular momentum over its size, as parts of a quaternion */
    vm_two phase, phase_rate, K; /* of u/(4K), K the quarter period; on the separatrix K is 0, and they are of u */
    vm_two turn_rate;            /* mean rate of half the angle about the angular momentum, turns/s */
    vmi_theta_form functions;    /* sn, cn, dn */
    vmi_doubled_theta theta;     /* what half that angle is beyond its mean */
} vm_free_motion;                /* plain data: it may be copied */

/* Prepares the motion of a body that is as given at t0. VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS,
   VM_BAD_INERTIA: the motion stays as it was. */
VM_API int vm_free_init(vm_free_motion *motion, const vm_body *body, vm_real t0);

/* The same from principal moments (kg m^2), the body's axes being the principal ones, and omega (rad/s) along
   them; the body has mass 1 and rests at the origin. */
VM_API int vm_free_init_principal(vm_free_motion *motion, vm_vec3 moments, vm_quat q, vm_vec3 omega, vm_real t0);

/* The body at time t (s), later than t0 or earlier. q is continuous and keeps the length that it had (1, if all
   zero). VM_NOT_FINITE: t is not, or what comes out is not, or the turns are beyond 1e290 (float 1e30); the body
   stays as it was. Beyond 1/eps^2 turns the result is finite and has the right momentum, nothing more. */
VM_API int vm_free_at(const vm_free_motion *motion, vm_real t, vm_body *body);

/* Attitude and omega alone, the latter along body axes. */
VM_API int vm_free_attitude(const vm_free_motion *motion, vm_real t, vm_quat *q, vm_vec3 *omega);

/* The body a time t (s) later, in one call. */
VM_API int vm_free_rotation(const vm_body *body, vm_real t, vm_body *later);

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
    case VM_BAD_ARGUMENT: return "null pointer";
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

/* Along principal axes 1, 2, 3, where 2 has the middle moment and omega circles 3, with u of the constant rate wp,
     w1 = a1 cn u,  w2 = -sigma s a2 sn u,  w3 = s a3 dn u,  s = sign(w3), sigma = sign(I1 - I3);
   with M the shortest rotation that takes l = J omega/L to s e3 and L = |J omega|, the attitude is
     q(t) = start R(t),  R = (cos h + s e3 sin h) M,  h = kappa t + sigma arg theta(u)
   (Jacobi 1850; van Zon and Schofield, J. Comput. Phys. 225 (2007), have a theta series for 2h). The set-up is in
   two words, since the rates wp/(4K) and kappa are multiplied by long times; then all but their products is in
   one. */

/* A power of two within a factor of 2 of x > 0 */
VM_API vm_real vmi_turn_power(vm_real x)
{
    return x < VM_MIN ? VM_MIN : vmi_from_bits(vmi_to_bits(x) & ~(((vmi_bits)1 << VMI_STORED_DIG) - 1));
}

typedef struct VM_TAG(vmi_vec3_two) {
    vm_two x[3];
} vmi_vec3_two;

VM_API vmi_vec3_two vmi_turn_cross(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    vmi_vec3_two c;
    int k;
    for (k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.x[k] = vmi_two_minus(vmi_two_times(a->x[i], b->x[j]), vmi_two_times(a->x[j], b->x[i]));
    }
    return c;
}

VM_API vm_vec3 vmi_turn_heads(const vmi_vec3_two *a) { return vmi_vec3(a->x[0].hi, a->x[1].hi, a->x[2].hi); }

VM_API vm_two vmi_turn_two_pi(void)
{
    const vmi_three half_pi = vmi_half_pi();
    return vmi_two(4 * half_pi.hi, 4 * half_pi.mid);
}

VM_API vm_two vmi_turn_dot(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    return vmi_two_plus(vmi_two_times(a->x[0], b->x[0]),
                        vmi_two_plus(vmi_two_times(a->x[1], b->x[1]), vmi_two_times(a->x[2], b->x[2])));
}

VM_API vmi_vec3_two vmi_turn_vector(vm_vec3 a, vm_real power) /* a/power */
{
    vmi_vec3_two v;
    v.x[0] = vmi_two(a.x / power, 0), v.x[1] = vmi_two(a.y / power, 0), v.x[2] = vmi_two(a.z / power, 0);
    return v;
}

/* x, or 0 where its square would be lost by underflow: for 2^-505 (float 2^-57) of the largest and less */
VM_API vm_two vmi_turn_squarable(vm_two x) { return VM_FABS(x.hi) < 64 * VM_SQRT(VM_MIN) ? vmi_two(0, 0) : x; }

VM_API vm_real vmi_turn_largest(vm_vec3 a)
{
    const vm_vec3 b = vmi_abs(a);
    const vm_real c = b.x > b.y ? b.x : b.y;
    return c > b.z ? c : b.z;
}

/* What the rotation of q turns into a: a + 2 (v x (v x a) - w v x a)/|q|^2, for q = (w, v) of any length but 0 */
VM_API vmi_vec3_two vmi_turn_back(vm_quat q, const vmi_vec3_two *a)
{
    const vm_vec3 part = vmi_vec3(q.x, q.y, q.z);
    const vm_real longest = vmi_turn_largest(part), w = VM_FABS(q.w);
    const vm_real power = vmi_turn_power(longest > w ? longest : w);
    const vmi_vec3_two v = vmi_turn_vector(part, power), b = vmi_turn_cross(&v, a), c = vmi_turn_cross(&v, &b);
    const vm_two real = vmi_two(q.w / power, 0);
    const vm_two size = vmi_two_plus(vmi_two_times(real, real), vmi_turn_dot(&v, &v));
    const vm_two factor = vmi_two_over(vmi_two(2, 0), size);
    vmi_vec3_two result;
    int k;
    for (k = 0; k < 3; k++)
        result.x[k] = vmi_two_plus(a->x[k],
                                   vmi_two_times(factor, vmi_two_minus(c.x[k], vmi_two_times(real, b.x[k]))));
    return result;
}

/* Moments, axes (columns in body axes) and omega along them */
typedef struct VM_TAG(vmi_turn_body) {
    vm_two moment[3];
    vmi_vec3_two axis[3], omega;
} vmi_turn_body;

/* vmi_jacobi_rotation in two words; a is scaled to 1, and what is below eps^3 is nothing */
VM_API void vmi_turn_annihilate(vm_two a[3][3], vmi_vec3_two *axis, int p, int q)
{
    const vm_two one = vmi_two(1, 0);
    vm_two theta, t, c, s, x, y;
    int k = 3 - p - q;
    if (VM_FABS(a[p][q].hi) < VM_EPSILON * VM_EPSILON * VM_EPSILON) {
        a[p][q] = a[q][p] = vmi_two(0, 0);
        return;
    }
    theta = vmi_two_over(vmi_two_minus(a[q][q], a[p][p]), vmi_two_shifted(a[p][q], 2));
    t = vmi_two_root(vmi_two_plus(vmi_two_times(theta, theta), one));
    t = vmi_two_over(one, theta.hi < 0 ? vmi_two_minus(theta, t) : vmi_two_plus(theta, t));
    c = vmi_two_over(one, vmi_two_root(vmi_two_plus(vmi_two_times(t, t), one)));
    s = vmi_two_times(t, c);
    x = vmi_two_times(t, a[p][q]);
    a[p][p] = vmi_two_minus(a[p][p], x);
    a[q][q] = vmi_two_plus(a[q][q], x);
    a[p][q] = a[q][p] = vmi_two(0, 0);
    x = a[k][p], y = a[k][q];
    a[k][p] = a[p][k] = vmi_two_minus(vmi_two_times(c, x), vmi_two_times(s, y));
    a[k][q] = a[q][k] = vmi_two_plus(vmi_two_times(s, x), vmi_two_times(c, y));
    for (k = 0; k < 3; k++) {
        x = axis[p].x[k], y = axis[q].x[k];
        axis[p].x[k] = vmi_two_minus(vmi_two_times(c, x), vmi_two_times(s, y));
        axis[q].x[k] = vmi_two_plus(vmi_two_times(s, x), vmi_two_times(c, y));
    }
}

/* Principal moments over a power of two, and axes, in two words; of a rod or a point exactly */
VM_API void vmi_turn_principal(const vm_inertia *i, vmi_turn_body *b)
{
    const vm_real power = vmi_turn_power(VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz));
    vm_two a[3][3];
    int sweep, p, q, k;
    memset(b, 0, sizeof *b);
    memset(a, 0, sizeof a);
    a[0][0].hi = i->xx / power, a[1][1].hi = i->yy / power, a[2][2].hi = i->zz / power;
    a[0][1].hi = a[1][0].hi = i->xy / power;
    a[0][2].hi = a[2][0].hi = i->xz / power;
    a[1][2].hi = a[2][1].hi = i->yz / power;
    for (k = 0; k < 3; k++) b->axis[k].x[k].hi = 1;
    for (sweep = 0; sweep < 12; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q].hi != 0) vmi_turn_annihilate(a, b->axis, p, q);
    for (k = 0; k < 3; k++) b->moment[k] = a[k][k];
}

/* A moment lost in the rounding errors of the tensor is that of a rod: 0, and the others are equal */
VM_API void vmi_turn_settle(const vm_inertia *i, vmi_turn_body *b)
{
    const vmi_mat3 same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const vm_inertia sizes = vmi_inertia_sizes(i, &same);
    const vm_real power = vmi_turn_power(VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz));
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 size = vmi_abs(vmi_turn_heads(&b->axis[k]));
        if (b->moment[k].hi * power > 8 * VM_EPSILON * vmi_dot(size, vmi_inertia_times(&sizes, size))) continue;
        b->moment[k] = vmi_two(0, 0);
        b->moment[(k + 1) % 3] = b->moment[(k + 2) % 3];
    }
}

/* All but equal: what two words cannot tell apart where they come from a tensor; stored moments differ by more */
VM_API int vmi_turn_equal(vm_two a, vm_two b)
{
    return VM_FABS(vmi_two_minus(a, b).hi) <= 64 * VM_EPSILON * VM_EPSILON * (a.hi + b.hi);
}

/* The body in axes 1, 2, 3 */
typedef struct VM_TAG(vmi_turn_axes) {
    vm_two I1, I2, I3, w1, w2, w3, d12, d23, d13;
    vm_two S; /* |2T I2 - L^2|, which is 0 on the separatrix */
    vm_real sigma, s;
    int symmetric; /* I1 = I2 */
    vmi_mat3 axes;
} vmi_turn_axes;

VM_API vmi_three vmi_turn_three(vm_two x) { return vmi_three_words(x.hi, x.lo, 0); }

/* J d w^2 in three words, in which stored numbers lose nothing that a difference could bring up */
VM_API vmi_three vmi_turn_excess(vm_two J, vm_two d, vm_two w)
{
    const vmi_three square = vmi_three_times(vmi_turn_three(w), vmi_turn_three(w));
    return vmi_three_times(vmi_three_times(vmi_turn_three(J), vmi_turn_three(d)), square);
}

/* J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2 = 2T J_b - L^2 */
VM_API vmi_three vmi_turn_separation(const vm_two *J, const vm_two *w, int a, int b, int c)
{
    const vmi_three smallest = vmi_turn_excess(J[c], vmi_two_minus(J[b], J[c]), w[c]);
    return vmi_three_plus(smallest, vmi_turn_excess(J[a], vmi_two_minus(J[b], J[a]), w[a]));
}

/* order[] by falling moments; 1 where it is an even permutation */
VM_API int vmi_turn_sort(const vm_two *J, int *order)
{
    int k, even = 1;
    for (k = 0; k < 3; k++) order[k] = k;
    for (k = 0; k < 3; k++) { /* the first two, the last two, the first two */
        const int i = k == 1, first = order[i];
        if (!(vmi_two_minus(J[order[i + 1]], J[first]).hi > 0)) continue;
        order[i] = order[i + 1], order[i + 1] = first, even = !even;
    }
    return even;
}

/* omega circles the smallest moment where the separation is positive, else the largest; of two equal moments, the
   third */
VM_API vmi_turn_axes vmi_turn_order(const vmi_turn_body *b)
{
    const vm_two *J = b->moment, *w = b->omega.x;
    int order[3], even = vmi_turn_sort(J, order), falling;
    const int first = order[0], middle = order[1], last = order[2];
    const vmi_three S = vmi_turn_separation(J, w, first, middle, last);
    vmi_turn_axes t;
    falling = vmi_turn_equal(J[first], J[middle]) || (!vmi_turn_equal(J[middle], J[last]) && S.hi >= 0);
    if (!falling) order[0] = last, order[2] = first, even = !even;
    t.sigma = falling ? 1 : -1;
    t.S = vmi_two_shifted(vmi_two(S.hi, S.mid), S.hi < 0 ? -1 : 1);
    t.I1 = J[order[0]], t.I2 = J[middle], t.I3 = J[order[2]];
    t.symmetric = vmi_turn_equal(t.I1, t.I2);
    if (t.symmetric) t.I2 = t.I1;
    t.w1 = w[order[0]], t.w2 = w[middle], t.w3 = vmi_two_shifted(w[order[2]], even ? 1 : -1);
    t.s = t.w3.hi < 0 ? -1 : 1;
    t.d12 = vmi_two_shifted(vmi_two_minus(t.I1, t.I2), t.sigma);
    t.d23 = vmi_two_shifted(vmi_two_minus(t.I2, t.I3), t.sigma);
    t.d13 = vmi_two_shifted(vmi_two_minus(t.I1, t.I3), t.sigma);
    t.axes.x = vmi_turn_heads(&b->axis[order[0]]);
    t.axes.y = vmi_turn_heads(&b->axis[middle]);
    t.axes.z = vmi_scale(even ? 1 : -1, vmi_turn_heads(&b->axis[order[2]]));
    return t;
}

/* A sphere or a point, a principal axis, an equator: omega stays */
VM_API int vmi_turn_is_constant(const vmi_turn_axes *t)
{
    const int no1 = t->w1.hi == 0, no2 = t->w2.hi == 0, no3 = t->w3.hi == 0;
    return vmi_turn_equal(t->I1, t->I3) || (no1 && no2) || (no1 && no3) || (no3 && (no2 || t->symmetric));
}

/* Then axis 3 is that of omega, and sn = 0 */
VM_API void vmi_turn_constant(vm_free_motion *m, const vmi_turn_body *b)
{
    const vm_two size = vmi_two_root(vmi_turn_dot(&b->omega, &b->omega));
    int k;
    if (size.hi == 0) return;
    for (k = 0; k < 3; k++)
        m->axes.z = vmi_add(m->axes.z,
                            vmi_scale(vmi_two_over(b->omega.x[k], size).hi, vmi_turn_heads(&b->axis[k])));
    m->spin[2] = size.hi;
    m->turn_rate = vmi_two_over(vmi_two_shifted(size, VM_C(0.5)), vmi_turn_two_pi());
}

/* The squares of a1, a2, a3, h1 = I1 a1, h3 = I3 a3 and L, and the parameters; no difference but S in them */
typedef struct VM_TAG(vmi_turn_squares) {
    vm_two a1, a2, a3, h1, h3, L, m1, m;
} vmi_turn_squares;

VM_API vmi_turn_squares vmi_turn_amplitudes(const vmi_turn_axes *t)
{
    const vm_two ratio = vmi_two_over(vmi_two_times(t->I2, t->d23), vmi_two_times(t->I1, t->d13));
    const vm_two ww2 = vmi_two_times(t->w2, t->w2);
    vmi_turn_squares q;
    vm_two x;
    q.a1 = vmi_two_plus(vmi_two_times(t->w1, t->w1), vmi_two_times(ratio, ww2));
    q.a2 = vmi_two_over(q.a1, ratio);
    q.a3 = vmi_two_times(t->w3, t->w3);
    q.m1 = vmi_two(1, 0), q.m = vmi_two(0, 0);
    if (!t->symmetric) {
        x = vmi_two_over(vmi_two_times(t->I2, t->d12), vmi_two_times(t->I3, t->d13));
        q.a3 = vmi_two_plus(q.a3, vmi_two_times(x, ww2));
        x = vmi_two_times(vmi_two_times(t->I3, t->d23), q.a3);
        q.m1 = vmi_two_over(t->S, x);
        q.m = vmi_two_over(vmi_two_times(vmi_two_times(t->I1, t->d12), q.a1), x);
    }
    q.h1 = vmi_two_times(vmi_two_times(t->I1, t->I1), q.a1);
    q.h3 = vmi_two_times(vmi_two_times(t->I3, t->I3), q.a3);
    q.L = vmi_two_plus(q.h1, q.h3);
    return q;
}

/* kappa, the mean rate of h, and agm(1, k') (0 on the separatrix), by Pi(-N | m) with N = I3 d12/(I1 d23):
     2 kappa = L/I1 + L d13/(I1 I3) (1 - Pi/K + c mean/sqrt(1 + N))   if I1 > I3,
     2 kappa = L/I3 + L d13/(I1 I3) (    Pi/K - c mean/sqrt(1 + N))   if not;  c = I3 a3/L */
VM_API vm_two vmi_turn_rate(const vmi_turn_axes *t, const vmi_turn_squares *q, vm_two *mean)
{
    const vm_two L = vmi_two_root(q->L), outer = vmi_two_times(t->I2, t->d13);
    const vm_two share = vmi_two_over(vmi_two_times(t->I3, t->d12), outer);
    const vm_two below = vmi_two_over(vmi_two_times(t->I1, t->d23), outer);
    vm_two rest, kappa;
    vmi_third_kind third;
    *mean = vmi_two(t->symmetric ? 1 : 0, 0);
    if (t->symmetric) {
        rest = vmi_two_times(vmi_two_root(q->a3), vmi_two_minus(t->I1, t->I3));
        kappa = vmi_two_over(vmi_two_plus(L, rest), t->I1);
    } else if (q->m1.hi == 0) kappa = vmi_two_over(L, t->I2);
    else {
        third = vmi_third_kind_ladder(q->m1, share, below);
        *mean = third.mean;
        rest = vmi_two_times(vmi_two_root(vmi_two_times(vmi_two_over(q->h3, q->L), below)), third.mean);
        rest = t->sigma > 0 ? vmi_two_plus(third.rest, rest) : vmi_two_minus(third.ratio, rest);
        rest = vmi_two_times(vmi_two_over(t->d13, vmi_two_times(t->I1, t->I3)), rest);
        rest = vmi_two_plus(rest, vmi_two_over(vmi_two(1, 0), t->sigma > 0 ? t->I1 : t->I3));
        kappa = vmi_two_times(L, rest);
    }
    return vmi_two_shifted(kappa, VM_C(0.5));
}

/* y of the theta function, cd(y | m1) = I3 a3/L */
VM_API vm_real vmi_turn_imaginary(const vmi_turn_axes *t, const vmi_turn_squares *q)
{
    const vm_two N = vmi_two_over(vmi_two_times(t->I3, t->d12), vmi_two_times(t->I1, t->d23));
    const vm_two cc = vmi_two_over(q->h3, q->L);
    return vmi_carlson_rf(N, vmi_two_over(N, cc), vmi_two_plus(N, vmi_two(1, 0))).hi;
}

/* u at t0, in turns where mean > 0; *sign is that of cn on the separatrix, else 1 */
VM_API vm_two vmi_turn_phase(const vmi_turn_axes *t, const vmi_turn_squares *q, vm_two mean, vm_real *sign)
{
    const vm_two ss = vmi_two_over(vmi_two_times(t->w2, t->w2), q->a2);
    const vm_two cc = vmi_two_over(vmi_two_times(t->w1, t->w1), q->a1);
    const vm_two middle = vmi_two_plus(cc, vmi_two_times(q->m1, ss));
    const vm_real forward = -t->sigma * t->s * t->w2.hi < 0 ? -1 : 1;
    vm_two F = vmi_two_times(vmi_two_root(ss), vmi_carlson_rf(cc, middle, vmi_two(1, 0)));
    *sign = 1;
    if (mean.hi > 0) {
        F = vmi_two_over(vmi_two_times(F, mean), vmi_turn_two_pi());
        if (t->w1.hi < 0) F = vmi_two_minus(vmi_two(VM_C(0.5), 0), F);
    } else if (t->w1.hi < 0) *sign = -1;
    return vmi_two_shifted(F, forward * *sign);
}

/* Rates and phase, per second of the scaled omega; returns the sign of cn on the separatrix */
VM_API vm_real vmi_turn_rates(vm_free_motion *m, const vmi_turn_axes *t, const vmi_turn_squares *q)
{
    const vm_two two_pi = vmi_turn_two_pi();
    vm_two mean, kappa = vmi_turn_rate(t, q, &mean), wp;
    vm_real sign;
    wp = vmi_two_over(vmi_two_times(q->a3, vmi_two_times(t->d13, t->d23)), vmi_two_times(t->I1, t->I2));
    wp = vmi_two_root(wp);
    m->turn_rate = vmi_two_over(vmi_two_shifted(kappa, t->s), two_pi);
    m->phase = vmi_turn_phase(t, q, mean, &sign);
    m->phase_rate = mean.hi > 0 ? vmi_two_over(vmi_two_times(wp, mean), two_pi) : wp;
    if (mean.hi > 0) m->K = vmi_two_over(vmi_two_shifted(two_pi, VM_C(0.25)), mean);
    return sign;
}

/* Parameter and y of the theta function; it stays 1 for m = 0 */
VM_API void vmi_turn_theta(vm_free_motion *m, const vmi_turn_axes *t, const vmi_turn_squares *q)
{
    const int periodic = m->K.hi > 0;
    vm_real K, Kc, y;
    int k;
    if (q->m.hi == 0) return;
    K = periodic ? m->K.hi : VM_INFINITY;
    Kc = periodic ? jacobi_K_m1(q->m.hi) : VM_PI / 2;
    y = vmi_turn_imaginary(t, q);
    m->theta = K > 2 * Kc ? vmi_doubled_dual(K, Kc, y) : vmi_doubled_direct(K, Kc, y);
    m->theta.shift *= t->sigma * t->s;
    for (k = 0; k < 4; k++) m->theta.im[k] *= t->sigma * t->s;
}

VM_API void vmi_turn_sizes(vm_free_motion *m, const vmi_turn_axes *t, const vmi_turn_squares *q, vm_real sign)
{
    const vm_real L = VM_SQRT(q->L.hi);
    m->axes = t->axes;
    m->spin[0] = sign * VM_SQRT(q->a1.hi);
    m->spin[1] = -t->sigma * t->s * sign * VM_SQRT(q->a2.hi);
    m->spin[2] = t->s * VM_SQRT(q->a3.hi);
    m->lean[0] = -t->s * t->I1.hi * m->spin[0] / L;
    m->lean[1] = t->s * t->I2.hi * m->spin[1] / L;
    m->lean[2] = t->s * t->I3.hi * m->spin[2] / L;
}

/* All but the unit of time and the start */
VM_API void vmi_turn_prepare(vm_free_motion *m, const vmi_turn_body *b)
{
    const vmi_turn_axes t = vmi_turn_order(b);
    vmi_turn_squares q;
    vmi_roots roots;
    int constant = vmi_turn_is_constant(&t);
    if (!constant) {
        q = vmi_turn_amplitudes(&t);
        constant = q.h1.hi <= vmi_fourth_power(VM_EPSILON) * q.h3.hi; /* nutation below eps^2 about a stable axis */
    }
    if (constant) {
        vmi_turn_constant(m, b);
        return;
    }
    vmi_turn_sizes(m, &t, &q, vmi_turn_rates(m, &t, &q));
    vmi_turn_theta(m, &t, &q);
    roots = vmi_theta_choose(&m->functions, q.m1.hi, q.m1.lo);
    vmi_theta_refine(&m->functions, &roots, q.m1.hi, q.m1.lo);
    vmi_theta_prepare(&m->functions, roots.fourth);
}

/* rate t without whole turns, |..| <= 1; meaningless beyond 2^(2p - 4) turns */
VM_API vm_two vmi_turn_fraction(vm_two rate, vm_two t)
{
    const vm_two p = vmi_two_product(rate.hi, t.hi);
    vm_real low = p.lo + (rate.lo * t.hi + rate.hi * t.lo);
    if (VM_FABS(low) > VM_C(0.5)) low -= VM_FLOOR(low + VM_C(0.5));
    return vmi_two_sum(p.hi - VM_FLOOR(p.hi + VM_C(0.5)), low);
}

/* sn, cn, dn at t after t0, and u/(4K) without half turns (u on the separatrix) */
VM_API vm_real vmi_turn_functions(const vm_free_motion *m, vm_two t, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real longest = VM_MANT_DIG > 24 ? 700 : 80; /* where sech is next to the smallest number */
    vm_real theta[4], x;
    int half = 0, j = 0;
    vm_two v;
    if (m->K.hi > 0) {
        v = vmi_two_plus(vmi_turn_fraction(m->phase_rate, t), m->phase);
        half = vmi_nearest(2 * v.hi);
        v = vmi_two_sum(v.hi - (vm_real)half / 2, v.lo);
        x = v.hi;
        j = vmi_nearest(4 * x);
        v = vmi_two_times(vmi_two_sum(4 * x - (vm_real)j, 4 * v.lo), m->K);
    } else {
        v = vmi_two_plus(vmi_two_times(m->phase_rate, t), m->phase);
        if (VM_FABS(v.hi) > longest) v = vmi_two(VM_COPYSIGN(longest, v.hi), 0);
        x = v.hi;
    }
    vmi_theta_at(&m->functions, m->functions.form, vmi_theta_phase(&m->functions, v), (j + 2 * half) & 3, theta);
    vmi_theta_ratios(theta, m->functions.kp, sn, cn, dn);
    return x;
}

/* omega in body axes, and the rotation R */
VM_API void vmi_turn_at(const vm_free_motion *m, vm_two t, vm_vec3 *omega, vm_quat *turn)
{
    vm_real sn, cn, dn, re, im, sine, cosine, x, y, w, norm, c, s;
    const vm_real u = vmi_turn_functions(m, t, &sn, &cn, &dn);
    vm_vec3 part;
    vmi_doubled_at(&m->theta, u, &re, &im);
    vmi_sincos_turns(vmi_turn_fraction(m->turn_rate, t).hi + m->theta.shift * u, &sine, &cosine);
    w = 1 + m->lean[2] * dn;
    x = m->lean[1] * sn, y = m->lean[0] * cn;
    norm = 1 / VM_SQRT(2 * w * (re * re + im * im));
    c = norm * (cosine * re - sine * im);
    s = norm * (sine * re + cosine * im);
    part = vmi_times(&m->axes, vmi_vec3(c * x - s * y, c * y + s * x, s * w));
    turn->w = c * w, turn->x = part.x, turn->y = part.y, turn->z = part.z;
    *omega = vmi_times(&m->axes, vmi_vec3(m->spin[0] * cn, m->spin[1] * sn, m->spin[2] * dn));
}

/* From moments, axes, and omega over a power of two */
VM_API void vmi_turn_init(vm_free_motion *m, const vmi_turn_body *b, vm_real power)
{
    vm_quat q = m->body.q, turn;
    vm_vec3 omega;
    int k;
    vmi_theta_prepare(&m->functions, vmi_theta_choose(&m->functions, 1, 0).fourth); /* m = 0: sn = 0, cn = dn = 1 */
    m->theta.re[0] = 1;
    m->lean[2] = 1;
    vmi_turn_prepare(m, b);
    if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) q.w = 1;
    vmi_turn_at(m, vmi_two(0, 0), &omega, &turn);
    turn.x = -turn.x, turn.y = -turn.y, turn.z = -turn.z;
    m->start = vmi_quat_times(q, turn);
    for (k = 0; k < 3; k++) m->spin[k] *= power;
    m->phase_rate = vmi_two_shifted(m->phase_rate, power);
    m->turn_rate = vmi_two_shifted(m->turn_rate, power);
}

/* omega along the inertial axes, or along the body's */
VM_API int vmi_turn_start(vm_free_motion *motion, const vm_body *body, int along_body, vm_real t0)
{
    vm_free_motion m;
    vmi_turn_body b;
    vmi_vec3_two omega;
    vm_real power;
    int status = vmi_check_body(body), k;
    if (!status && !VM_IS_FINITE(t0)) status = VM_NOT_FINITE;
    if (status) return status;
    memset(&m, 0, sizeof m);
    m.body = *body;
    m.t0 = t0;
    power = vmi_turn_power(vmi_turn_largest(body->omega));
    omega = vmi_turn_vector(body->omega, power);
    if (!along_body && vmi_turn_largest(vmi_vec3(body->q.x, body->q.y, body->q.z)) > 0)
        omega = vmi_turn_back(body->q, &omega);
    vmi_turn_principal(&body->inertia, &b);
    vmi_turn_settle(&body->inertia, &b);
    for (k = 0; k < 3; k++) b.omega.x[k] = vmi_turn_squarable(vmi_turn_dot(&b.axis[k], &omega));
    vmi_turn_init(&m, &b, power);
    *motion = m;
    return VM_OK;
}

VM_API int vm_free_init(vm_free_motion *motion, const vm_body *body, vm_real t0)
{
    return motion && body ? vmi_turn_start(motion, body, 0, t0) : VM_BAD_ARGUMENT;
}

VM_API int vm_free_init_principal(vm_free_motion *motion, vm_vec3 moments, vm_quat q, vm_vec3 omega, vm_real t0)
{
    vm_body body;
    if (!motion) return VM_BAD_ARGUMENT;
    memset(&body, 0, sizeof body);
    body.mass = 1;
    body.inertia.xx = moments.x, body.inertia.yy = moments.y, body.inertia.zz = moments.z;
    body.q = q;
    body.omega = omega;
    return vmi_turn_start(motion, &body, 1, t0);
}

VM_API int vm_free_attitude(const vm_free_motion *motion, vm_real t, vm_quat *q, vm_vec3 *omega)
{
    vm_two elapsed;
    vm_real reach;
    vm_vec3 w;
    vm_quat turn;
    if (!motion || !q || !omega) return VM_BAD_ARGUMENT;
    elapsed = vmi_two_sum(t, -motion->t0);
    reach = VM_FABS(motion->phase_rate.hi) + VM_FABS(motion->turn_rate.hi);
    if (!((1 + reach) * (1 + VM_FABS(elapsed.hi)) < VM_MAX / VM_SPLIT))
        return VM_NOT_FINITE; /* products are split */
    vmi_turn_at(motion, elapsed, &w, &turn);
    turn = vmi_quat_times(motion->start, turn);
    if (!vmi_vec3_finite(w) || !VM_IS_FINITE(turn.w) || !vmi_vec3_finite(vmi_vec3(turn.x, turn.y, turn.z)))
        return VM_NOT_FINITE;
    *q = turn;
    *omega = w;
    return VM_OK;
}

VM_API int vm_free_at(const vm_free_motion *motion, vm_real t, vm_body *body)
{
    vm_body b;
    vmi_mat3 turn;
    int status;
    if (!motion || !body) return VM_BAD_ARGUMENT;
    b = motion->body;
    status = vm_free_attitude(motion, t, &b.q, &b.omega);
    if (status) return status;
    turn = vmi_rotation(b.q);
    b.omega = vmi_times(&turn, b.omega);
    b.r = vmi_add(b.r, vmi_scale(t - motion->t0, b.v));
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

VM_API int vm_free_rotation(const vm_body *body, vm_real t, vm_body *later)
{
    vm_free_motion motion;
    int status = vm_free_init(&motion, body, 0);
    return status ? status : vm_free_at(&motion, t, later);
}

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
