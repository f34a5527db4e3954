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
#define VARMASS_VERSION "0.1.0"

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
#if !defined(VM_INLINE) && defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define VM_INLINE static inline __attribute__((always_inline)) /* of what must be inlined for speed */
#endif
#endif
#ifndef VM_INLINE
#define VM_INLINE VM_API /* which is enough for the results */
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

#ifndef VM_SQRT /* define all of these to use another library; the casts keep C++ from its templates */
#define VM_SQRT(x) VM_LIBM(sqrt)((vm_real)(x))
#define VM_FABS(x) VM_LIBM(fabs)((vm_real)(x))
#define VM_FLOOR(x) VM_LIBM(floor)((vm_real)(x))
#if defined(__GNUC__) && !defined(__clang__) && defined(__thumb2__) && defined(__SOFTFP__)
#define VM_COPYSIGN(x, y) vmi_copysign(x, y) /* gcc's inline code for "x = copysign(x, y)" gives y here */
#else
#define VM_COPYSIGN(x, y) VM_LIBM(copysign)((vm_real)(x), (vm_real)(y))
#endif
#endif

#define VM_NAN ((vm_real)NAN)
#define VM_INFINITY ((vm_real)INFINITY)
#define VM_IS_FINITE(x) ((x) - (x) == 0)
#define VM_PI VM_C(3.141592653589793238463)

typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two; /* hi + lo, |lo| <= ulp(hi)/2 */

VM_API vm_real vmi_copysign(vm_real x, vm_real y)
{
    x = VM_FABS(x);
    return y < 0 || (y == 0 && 1 / y < 0) ? -x : x;
}

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
    VM_NULL_AXIS = 1,      /* done, but about an axis without inertia (of a rod, a point) the spin stayed as it was,
                             though angular momentum was left for it: that is lost */
    VM_STOPPED = 2,        /* an event or the caller ended the run */
    VM_BAD_ARGUMENT = -1,  /* a null pointer, a negative count */
    VM_NOT_FINITE = -2,    /* a number that is infinite or NaN, given or arising */
    VM_BAD_MASS = -3,      /* a mass that is not positive, the rest's included */
    VM_BAD_INERTIA = -4,   /* an inertia that no body has, the rest's included */
    VM_SINGULAR = -5,      /* linear equations without a unique solution, an effective mass that is not positive */
    VM_BAD_MOTION = -30,   /* a motion that does not exist, or that this effect or event cannot act on */
    VM_NO_SUCH_BODY = -31, /* no such body, or an event for one that is not there */
    VM_NO_SUCH_COORDINATE = -32, /* the body has no such coordinate */
    VM_NO_SUCH_EFFECT = -33,     /* no such effect */
    VM_TWO_MASS_LAWS = -34,      /* two laws for one mass, or two links of one body */
    VM_BAD_ORDER = -35,          /* a mass law stands after, or a link before, another effect on its body */
    VM_MASS_IS_NO_STATE = -36,   /* a stream needs a body whose mass is a state */
    VM_TOO_MANY_EVENTS = -37,    /* events do not end */
    VM_NOT_INTEGRATED = -38      /* the integrator failed: scene.ode_status */
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

/* A band of constant velocity v along y winds up on a drum (Fig. 20). It meets the drum in S + (R, 0), S the centre
   of the shaft; after the angle phi it covers the arc from 0 to phi, whose mass centre is at phi/2. R stays constant:
   the first layer, 0 <= phi <= 2 pi, is what is meant. mu = R h b rho (181), j = mu R^2 (186), and
   e = mu v R - D, which decides whether the drum is driven (e > 0) or comes to rest. */
typedef struct VM_TAG(vm_drum) {
    vm_real radius;    /* R, m */
    vm_real mass;      /* M0 > 0 of the empty drum, kg */
    vm_real inertia;   /* J0 > 0 of the empty drum about its axle, kg m^2 */
    vm_real band;      /* mu >= 0, the band's mass per angle, kg/rad */
    vm_real speed;     /* v of the band, m/s */
    vm_real damping;   /* D of the rotation, N m s */
    vm_real stiffness; /* c >= 0 of the shaft, N/m */
    vm_real omega;     /* Omega_b > 0, the angular velocity at phi = 0, rad/s */
} vm_drum;
VM_API vm_real vm_drum_band(vm_real radius, vm_real thickness, vm_real width, vm_real density); /* mu (181) */

typedef struct VM_TAG(vm_drum_geometry) {
    vm_real mass;         /* M (182), kg */
    vm_real arc_centre;   /* S S' (184), m */
    vm_real offset;       /* S S1 (185) corrected, m: S1 = S + offset (cos phi/2, sin phi/2) */
    vm_real axle_inertia; /* J_S (187), about the axle, kg m^2 */
    vm_real inertia;      /* J_S1 (188), about the mass centre, kg m^2 */
} vm_drum_geometry;
/* The drum with its band at the angle phi >= 0; VM_BAD_MASS, VM_BAD_INERTIA where no drum is like that */
VM_API int vm_drum_at(vm_real phi, const vm_drum *d, vm_drum_geometry *g);

/* Right-hand sides for rk45, ctx a vm_drum, of y = {xS, yS, phi, xS', yS', phi'} (VM_DRUM_STATES values). The first
   is exact; it takes the place of (177) and (191), which lack the drift of the mass centre and turn the shaft's
   torque round. With q = mu R (sin phi, 1 - cos phi):
     M rS'' + phi'' k x q - phi'^2 q = -c rS + mu phi' ((0, v) - rS' - phi' k x (R, 0))
     J_S phi'' + q x rS'' = -D phi' + mu phi' R (v - yS' - R phi')
   The second is (192), (193), what is left of it for small mu, with the unbalance mu R phi'^2 (sin phi, -cos phi),
   of the same order as what (192) keeps. Both stop a run, by VM_BAD_MASS or VM_BAD_INERTIA, where a mass or inertia
   is not positive. */
#define VM_DRUM_STATES 6
VM_API int vm_drum_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *drum);
VM_API int vm_drum_rhs_reduced(vm_real t, const vm_real *y, vm_real *dydt, void *drum);
/* (210), (211) of y = {x, y, dx/dphi, dy/dphi}, phi the independent variable, with phi'(phi) of the rigid shaft
   (196); VM_BAD_ARGUMENT where the drum does not get to phi */
VM_API int vm_drum_rhs_angle(vm_real phi, const vm_real *y, vm_real *dydt, void *drum);

/* The rigid shaft (194): angular velocity phi' (196), time t (197) at which the angle phi is reached, phi(t), and the
   angle J0 Omega_b/|e| that is never reached where e < 0 (else infinity). phi, t >= 0; NaN beyond the stop. Within 4
   ulp with the drum's fields taken as exact, through e = 0 and k1 = 1 - e/(j Omega_b) = 0, up to the stop, for data
   whose products in these formulas stay within the range of numbers. With x = e phi/(J0 Omega_b)
     t = phi/Omega_b [ln(1 + x)/x + (j phi/J0) (x - ln(1 + x))/x^2],
   and phi(t) is solved for by Newton's method: no Lambert W, no branches. */
VM_API vm_real vm_drum_rate(vm_real phi, const vm_drum *d);
VM_API vm_real vm_drum_time(vm_real phi, const vm_drum *d);
VM_API vm_real vm_drum_angle(vm_real t, const vm_drum *d);
VM_API vm_real vm_drum_stop(const vm_drum *d);
/* phi(t) as published, (198)-(206) corrected: r - k1 ln r = f1, r = -k1 W(x), x = -exp(-f1/k1)/k1, by W_-1 for 0 < k1
   < 1 and W_0 for other k1. For comparison: it loses all digits next to e = 0, where r comes to the branch point; at
   e = 0 and k1 = 0 it is NaN. Next to k1 = 0 x is no number any more (1e-869 for k1 = 1e-3): ln |x| is used. */
VM_API vm_real vm_drum_angle_lambert(vm_real t, const vm_drum *d);

/* The elastic shaft in the first approximation, for small mu/M0, j/J0, e/(J0 Omega_b):
     x'' + 2 delta x' + k^2 (1 - A phi) x = 0 (213), y with mu v/(M0 Omega_b) on the right (214), ' = d/dphi */
typedef struct VM_TAG(vm_drum_shaft) {
    vm_real k;     /* sqrt(c/M0)/Omega_b */
    vm_real delta; /* (mu/M0 + e/(J0 Omega_b) - j/J0)/2, corrected */
    vm_real A;     /* mu/M0 - 2 j/J0 + 2 e/(J0 Omega_b), corrected, 1/rad */
    vm_real shift; /* mu v/(M0 Omega_b k^2), m: y oscillates about shift/(1 - A phi) */
} vm_drum_shaft;
/* VM_SINGULAR where c = 0 */
VM_API int vm_drum_shaft_init(const vm_drum *d, vm_drum_shaft *s);
/* (224), (225) corrected: a (1 - A phi)^(-1/4) exp(-delta phi) cos(integral of k sqrt(1 - A phi) + alpha), plus
   particular: 0 for x, s->shift for y. NaN where 1 - A phi <= 0. */
VM_API vm_real vm_drum_deflection(vm_real phi, const vm_drum_shaft *s, vm_real a, vm_real alpha,
                                  vm_real particular);
/* (226): is A < 1/(2 pi), so that the frequency stays real for the first layer? */
VM_API int vm_drum_shaft_valid(const vm_drum_shaft *s);

/* Lambert's W, w e^w = x: the branches W_0 >= -1 for x >= -1/e, and W_-1 <= -1 for -1/e <= x < 0. The number next to
   -1/e, a little below it, counts as -1/e and gives -1; W_-1(0) = -infinity. Within 1 ulp, x taken as exact. */
VM_API vm_real vm_lambert_w0(vm_real x);
VM_API vm_real vm_lambert_wm1(vm_real x);
/* The same from the logarithm of the argument, which itself may be too large or too small to be a number:
   W_0(e^l) for all l (Wright's omega), W_0(-e^l) and W_-1(-e^l) for l <= -1 */
VM_API vm_real vm_lambert_w0_exp(vm_real l);
VM_API vm_real vm_lambert_w0_mexp(vm_real l);
VM_API vm_real vm_lambert_wm1_mexp(vm_real l);

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

/* -- Scenes --

   A scene is what a sketch shows: bodies, the effects that act on them, the events that change it. Its right-hand
   side goes through the effects that are listed, and nothing else; what is not listed is not linked either, since
   each constructor below binds the one function that it needs. All arrays are the caller's.

       vm_scene_body bodies[] = {vm_scene_line(2, 0.1, 0)};                 // 2 kg, at x = 0.1 m, at rest
       vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 1),  // loses 10 g/s, which keeps its velocity
                              vm_effect_spring(0, 0, VM_GROUND, 0, 50, 3, 0)};
       vm_scene scene = {bodies, 1, effects, 2};                             // what is not set is zero: not there
       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                          // 2 = vm_scene_size(&scene)
       vm_culprit culprit;
       int status = vm_scene_start(&scene, t, y, &culprit);                  // checks, and fills y
       if (status < 0) printf("%s %d: %s\n", culprit.kind, culprit.index, vm_strerror(status));
       else status = vm_scene_run(&scene, &t, 10, y, work, NULL);            // y[0] = x(10), y[1] = v(10)

   With events, scene.events and scene.located (as many) and scene.n_events are set as well, before the start. Bodies,
   effects and events are known by their index. A start begins everything anew, as the bodies, effects and events were
   made; a second vm_scene_run goes on where the first ended.

   The state has so many numbers a body: a line, an axle 2 (angle and angular velocity), the plane 6, a point 6, free
   in space 13; one more where the mass is itself a state. Positions come first, from bodies[i].at on:
     line   x, v                                     point  r (3), v (3)
     axle   angle, omega                             free   r (3), q (4), v (3), omega (3, in body axes)
     plane  x, y, angle, vx, vy, omega               then the mass (the inertia in the plane stays)
   An effect acts on coordinates: 0 of a line or an axle; x, y, angle = 0, 1, 2 in the plane; x, y, z = 0, 1, 2 of a
   point or a free body. What is called mass is the moment of inertia on an axle, and then a force is a torque. */

enum { VM_LINE = 1, VM_AXLE, VM_PLANE, VM_POINT, VM_FREE }; /* how a body can move */
enum { VM_GROUND = -1 };                                    /* instead of a body */

typedef struct VM_TAG(vm_load) {
    vm_real mass;      /* now */
    vm_real extra;     /* to be added to the mass that accelerates, (M'(v) (v - u)) of mass laws M(v) */
    vm_real mass_rate; /* of a mass that is a state */
    vm_real force[6];  /* of each coordinate; 3 to 5 the torque on a free body, inertial axes */
    vm_real by_v, own; /* M'(v), and the velocity of what joins or leaves then */
    /* only where there is a book: */
    vm_real reactive[6], brought[6]; /* of force, what is reactive; momentum that streams bring, by the second */
    vm_real brought_energy, mixing;  /* their energy, and what is lost as they take on the body's velocity, W */
} vm_load;                           /* what acts on a body at the moment */

typedef struct VM_TAG(vm_scene_body) vm_scene_body;
struct VM_TAG(vm_scene_body) {
    int motion;        /* VM_LINE, ... */
    int mass_is_state; /* so that vm_effect_stream can change it */
    int absent;        /* not there until an event brings it in */
    vm_body start;  /* as it starts: of a line mass, r.x, v.x; of an axle mass (kg m^2), omega.z and angle ... */
    vm_real angle;  /* rad, of an axle or in the plane */
    int at;         /* where its state begins; set by vm_scene_start, as all that follows */
    vm_load load;   /* what acts on it now */
    int away;       /* not there now */
    vm_real mass;   /* now, where neither a state nor a law says it */
    vm_real jumped; /* what jumps have added to the mass of a law */
    vm_inertia inertia, filled; /* now; the same with something about the null axes of a rod or a point */
    int positions, coordinates; /* numbers of the state that are positions, velocities */
    /* what the motion needs, so that others are not linked */
    void (*put)(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state);
    void (*get)(const vm_scene_body *b, const vm_real *state, vm_body *now);
    int (*accelerate)(const vm_scene_body *b, const vm_real *state, vm_real *rates);
};

/* Position (m), velocity and acceleration of a point that moves as given */
typedef void (*vm_moving_point)(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx);

typedef struct VM_TAG(vm_scene) vm_scene;
typedef struct VM_TAG(vm_effect) vm_effect;
typedef struct VM_TAG(vm_event) vm_event;

/* What a mass law returns: the mass now, kg (on an axle kg m^2), and its derivatives, M(t, x, v) */
typedef struct VM_TAG(vm_mass_now) {
    vm_real mass, by_t, by_x, by_v;
} vm_mass_now;

struct VM_TAG(vm_effect) {
    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene);
    int body, coordinate;        /* on what it acts */
    int other, other_coordinate; /* against what: another body or VM_GROUND */
    vm_real p[6];                /* parameters, in the order of the constructor's arguments */
    vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx);   /* of vm_effect_user, N or N m */
    vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx); /* of vm_effect_mass_law */
    vm_moving_point point;                                          /* of vm_effect_link */
    void *ctx;
    unsigned motions, other_motions; /* bit (1 << motion) for each motion that it can act on, against */
    int needs_mass_state;            /* streams do */
    int order;                       /* 0 mass laws, 1 the others, 2 links, which are reactions to the others */
    int off;                         /* at the start it is switched off */
    int idle; /* now, set by vm_scene_start: 1 switched off, 2 since a body is not there, 3 both */
};

struct VM_TAG(vm_event) {
    vm_real (*when)(const vm_event *event, vm_real t, const vm_real *y); /* crosses zero; null: at time */
    int (*then)(vm_event *event, vm_real t, vm_real *y);                 /* a status; VM_STOPPED ends the run */
    vm_real time;                  /* s, where when is null; of a crossing when it was last, or the start */
    int direction;                 /* > 0 rising, < 0 falling, 0 both */
    int watches, body, coordinate; /* set where it watches a body: what passes */
    vm_real value;                 /* this value */
    int switches, effect, off;     /* set where it switches an effect on or off */
    int jumps, jump_body, other;   /* 1 where other separates from jump_body, -1 where it is attached to it */
    vm_body part; /* what separates; its motion relative to the body, in its axes, where relative is set */
    int relative;
    vm_impulse external; /* acts during the jump */
    vm_real (*user_when)(vm_real t, const vm_real *y, void *ctx);
    int (*user_then)(vm_real t, vm_real *y, void *ctx);
    void *ctx, *then_ctx; /* of the one, of the other */
    long most;            /* it happens so often; 0: as often as it may */
    long count;           /* it has happened so often */
    long seen;            /* the scene's own from here on */
    vm_scene *scene;
};

/* What came in from outside, and whether it balances: vm_scene_keep_book asks for it */
typedef struct VM_TAG(vm_book) vm_book;
struct VM_TAG(vm_book) {
    vm_vec3 impulse, angular_impulse;        /* of the effects, about the origin */
    vm_vec3 brought, brought_angular;        /* momentum and angular momentum that streams and mass laws brought */
    vm_real work, brought_energy, mixing;    /* of the effects; of the streams; lost as they mix */
    vm_vec3 momentum, angular_momentum;      /* of all bodies */
    vm_real energy;                          /* kinetic */
    vm_real jump_energy;                     /* that jumps have added */
    vm_vec3 momentum_defect, angular_defect; /* what is there less what was there and what came */
    vm_real energy_defect;
    /* by pointers, so that without a book they are not linked */
    void (*open)(vm_scene *scene, const vm_real *y, vm_real *sums);
    void (*rates)(vm_scene *scene, const vm_real *y, vm_real *rates);
    void (*totals)(const vm_scene *scene, const vm_real *y, vm_book *book);
};

struct VM_TAG(vm_scene) {
    vm_scene_body *bodies;
    int n_bodies;
    vm_effect *effects;
    int n_effects;
    vm_event *events;
    ode_event *located; /* n_events of them too, for the integrator */
    int n_events;
    vm_book *book; /* of vm_scene_keep_book: what was there at the start; VM_BOOK numbers join the state */
    int (*output)(vm_real t, const vm_real *y, vm_scene *scene,
                  void *ctx); /* null, or called after each step; nonzero stops */
    const vm_real *times; /* null, or n_times increasing times: then output is called at them, not after steps */
    int n_times;
    void *output_ctx;
    int status, ode_status; /* of the right-hand side, of the integrator */
};

/* Bodies. m, m/s, rad, rad/s; of an axle the inertia is about it, in the plane about the mass centre, kg m^2. A free
   body may be a rod, whose spin about itself then stays. */
VM_API vm_scene_body vm_scene_line(vm_real mass, vm_real x, vm_real v);
VM_API vm_scene_body vm_scene_axle(vm_real inertia, vm_real angle, vm_real omega);
VM_API vm_scene_body vm_scene_plane(vm_real mass, vm_real inertia, vm_vec3 r, vm_real angle, vm_vec3 v,
                                    vm_real omega);
VM_API vm_scene_body vm_scene_point(vm_real mass, vm_vec3 r, vm_vec3 v);
VM_API vm_scene_body vm_scene_free(const vm_body *start);
VM_API vm_scene_body vm_scene_with_mass_state(vm_scene_body body); /* the same, its mass a state */
VM_API vm_scene_body vm_scene_absent(vm_scene_body body);          /* the same, not yet there */

/* Forces, N (torques, N m), for right-hand sides that are written by hand; the effects use them. x, v: extension, its
   rate. A spring's force (248), alpha >= 0; that of Van der Pol's damper (404); force cos(frequency t + phase),
   frequency in rad/s; the reactive force of a stream of rate kg/s whose own velocity is u + share v. */
VM_INLINE vm_real vm_force_spring(vm_real k, vm_real alpha, vm_real x);             /* -k x |x|^(alpha-1) */
VM_INLINE vm_real vm_force_damper(vm_real b, vm_real v);                            /* -b v */
VM_INLINE vm_real vm_force_van_der_pol(vm_real b, vm_real c, vm_real x, vm_real v); /* (b - c x^2) v */
VM_INLINE vm_real vm_force_drive(vm_real torque, vm_real kappa, vm_real omega);     /* torque - kappa omega */
VM_INLINE vm_real vm_force_harmonic(vm_real force, vm_real frequency, vm_real phase, vm_real t);
VM_INLINE vm_real vm_force_stream(vm_real rate, vm_real u, vm_real share, vm_real v); /* rate (u + share v - v) */

/* Effects, the forces above on a coordinate of a body, x and v its position and velocity; where there is an other
   body, or VM_GROUND, x and v are relative to its coordinate, and it takes the reaction. A mass law of a body stands
   before what else acts on it. */
/* M g, along the coordinate: g = -9.81 where it points upwards; not on an axle */
VM_API vm_effect vm_effect_gravity(int body, int coordinate, vm_real g);
/* vm_force_spring of x - rest */
VM_API vm_effect vm_effect_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                  vm_real alpha, vm_real rest);
VM_API vm_effect vm_effect_damper(int body, int coordinate, int other, int other_coordinate, vm_real b);
VM_API vm_effect vm_effect_van_der_pol(int body, int coordinate, vm_real b, vm_real c);
VM_API vm_effect vm_effect_drive(int body, int coordinate, vm_real torque, vm_real kappa);
VM_API vm_effect vm_effect_harmonic(int body, int coordinate, vm_real force, vm_real frequency, vm_real phase);
/* a force of one's own, which depends on t and the coordinate, and on what ctx points to */
VM_API vm_effect vm_effect_user(int body, int coordinate,
                                vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx);
/* an effect of one's own, which may depend on everything: apply adds to scene->bodies[effect->body].load.force, or
   to load.mass_rate where the mass is a state, and may read load.mass, other bodies, the state y from
   bodies[...].at on, effect->p and effect->ctx. other, or VM_GROUND: a body without which it does not act either */
VM_API vm_effect vm_effect_callback(int body, int other,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene),
                                    void *ctx);
/* an elastic shaft: -k r |r|^(alpha-1) towards the origin, in coordinates 0 and 1 of a body in the plane, a point */
VM_API vm_effect vm_effect_shaft(int body, vm_real k, vm_real alpha);
/* an unbalance m e (kg m) that turns with Omega = frequency: m e Omega^2 (cos, sin)(Omega t + phase) */
VM_API vm_effect vm_effect_unbalance(int body, vm_real unbalance, vm_real frequency, vm_real phase);
VM_API vm_effect vm_effect_gyroscopic(int body, vm_real coupling); /* force coupling (-vy, vx) */
/* a rigid link, or where cord is set one that only pulls, of a length between a body (a point, or in the plane) and
   another (on a line, too) or, other = VM_GROUND, a point that moves as given. Links are the last of the effects on a
   body, one of them for a body. Deviations of the length die out as exp(-rate t), rate > 0 in 1/s; a cord that
   becomes taut at a speed v is drawn out by v/(e rate) at most. In float a cord of 1 m at 5 m/s asks for a rate
   of not more than 200/s. The link acts at the mass centres. */
VM_API vm_effect vm_effect_link(int body, int other, vm_moving_point point, void *ctx, vm_real length, int cord,
                                vm_real rate);

/* A mass law: M(t, x, v), with the reactive force M' (u + share v - v). share = 1, u = 0: what joins or leaves has
   the body's velocity, no reactive force; 0: its own velocity is u. x and v are those of a line or an axle (J(phi),
   J(omega)); for a body in the plane or a point the law is M(t). What jumps add comes on top of the law. */
VM_API vm_effect vm_effect_mass_law(int body, vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
                                    void *ctx, vm_vec3 u, vm_real share);
enum { VM_MASS_OF_T, VM_MASS_OF_X, VM_MASS_OF_V2 }; /* M0 + c t, M0 + c x, M0 + c v^2, M0 as the body was made */
VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real share);
/* A stream, for a body whose mass is a state: rate kg/s */
VM_API vm_effect vm_effect_stream(int body, vm_real rate, vm_vec3 u, vm_real share);

/* Events: one at a time happens once, a crossing (direction > 0 rising, < 0 falling, 0 both) as often as it may, or
   event.most times. A crossing is what motion does: what jumps over the value does not cross it. At one instant
   events happen in their order. Nothing of a body that is not there crosses anything. */
VM_API vm_event vm_event_at(vm_real time);
VM_API vm_event vm_event_position(int body, int coordinate, vm_real value, int direction); /* passes value */
VM_API vm_event vm_event_velocity(int body, int coordinate, vm_real value, int direction);
VM_API vm_event vm_event_mass(int body, vm_real value, int direction);
VM_API vm_event vm_event_user(vm_real (*when)(vm_real t, const vm_real *y, void *ctx), void *ctx, int direction);
/* ... and what happens then, one thing an event: vm_then_switch(vm_event_at(60), tap, 1). The run ends with
   VM_STOPPED; an effect goes off (1) or on (0); a part leaves body and becomes into, which was absent; added becomes
   a part of body and is no longer there; then is called, may change y, and returns a status (VM_STOPPED, < 0 end the
   run).
   A part is described as the instant after, in inertial axes; where relative is set, in the body's axes, r from its
   mass centre, q, v and omega relative to the body as it moves there. In the plane and on an axle into takes the
   body's angle, plus the angle with which it was made. event.external is an impulse from outside during the jump.
   A jump is between bodies of one motion, or between a body in the plane or free and a point. The run ends with
   VM_NO_SUCH_BODY where into is there already, or body or added is not; else errors as vm_separate. */
VM_API vm_event vm_then_stop(vm_event event);
VM_API vm_event vm_then_switch(vm_event event, int effect, int off);
VM_API vm_event vm_then_separate(vm_event event, int body, int into, const vm_body *part, int relative);
VM_API vm_event vm_then_attach(vm_event event, int body, int added);
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx);

typedef struct VM_TAG(vm_culprit) {
    const char *kind; /* "body", "effect", "event", "scene" */
    int index;        /* which one, -1 for the scene itself */
} vm_culprit;

/* Everything that can be wrong with a scene: VM_OK, or what it is, and in *culprit (may be null) where. Takes a time
   that grows as the square of the number of effects, some ms for a thousand. */
VM_API int vm_scene_check(const vm_scene *scene, vm_culprit *culprit);
VM_API int vm_scene_size(const vm_scene *scene); /* numbers in the state */
enum { VM_BOOK = 15 };
#define VM_SCENE_WORK(size) (RK45_WORK(size) + (size))
/* Checks the scene, and makes the state at the start: vm_scene_size numbers */
VM_API int vm_scene_start(vm_scene *scene, vm_real t, vm_real *y, vm_culprit *culprit);
/* An ode_rhs; ctx is the scene, which has been started. Returns 0; where a mass is not positive or a body cannot be
   accelerated a derivative is NaN and scene.status says why, so that an integrator tries a shorter step. */
VM_API int vm_scene_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx);
/* On from *t to t_end >= *t by rk45, events included: VM_OK, VM_STOPPED before t_end, or what went wrong; *t and y
   are where the run ended. work: VM_SCENE_WORK(vm_scene_size) numbers. The options' own events are not used. Events
   that do not end are VM_TOO_MANY_EVENTS: more than 10 000 at one instant, or four times in succession again after
   less than 256 eps of the time. */
VM_API int vm_scene_run(vm_scene *scene, vm_real *t, vm_real t_end, vm_real *y, vm_real *work,
                        const rk45_options *options_or_NULL);
/* A body as it moves in state y; where its mass is of a law, that when the right-hand side was last evaluated */
VM_API void vm_scene_body_at(const vm_scene *scene, int body, const vm_real *y, vm_body *now);
/* Before vm_scene_start: the scene keeps book of momentum, angular momentum and energy, in VM_BOOK more numbers of
   the state; NULL: no longer */
VM_API void vm_scene_keep_book(vm_scene *scene, vm_book *book);
/* Momentum, angular momentum and energy in state y, what came in since the start, and the defects: what rounding and
   the integrator's errors leave, and what a constraint takes (a line, an axle, the plane hold their bodies).
   VM_BAD_ARGUMENT where there is no book. */
VM_API int vm_scene_balance(vm_scene *scene, vm_real t, const vm_real *y, vm_book *book);

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
    case VM_STOPPED: return "an event or the caller ended the run";
    case VM_BAD_MOTION: return "a motion that does not exist, or that this effect or event cannot act on";
    case VM_NO_SUCH_BODY: return "no such body, or an event for one that is not there";
    case VM_NO_SUCH_COORDINATE: return "the body has no such coordinate";
    case VM_NO_SUCH_EFFECT: return "no such effect";
    case VM_TWO_MASS_LAWS: return "two laws for one mass, or two links of one body";
    case VM_BAD_ORDER: return "a mass law stands after, or a link before, another effect on its body";
    case VM_MASS_IS_NO_STATE: return "a stream needs a body whose mass is a state";
    case VM_TOO_MANY_EVENTS: return "events do not end";
    case VM_NOT_INTEGRATED: return "the integrator failed: scene.ode_status";
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

/* e^y - 1 in two words: within 2^-(p+4) (1 + e^y), p the type's digits; relative to the result below 2^-p for small
   y. Infinity where it overflows */
VM_API vm_two vmi_expm1(vm_two y)
{
    const vm_real largest = VM_C(0.6931471805599453094) * (VMI_BIAS + 1);
    const vm_real least = VM_C(-0.6931471805599453094) * (2 * VM_MANT_DIG);
    vm_real p_lo, p;
    vm_two sum, power;
    int k;
    if (y.hi > largest) return vmi_two(VM_INFINITY, 0);
    if (!(y.hi > least)) return vmi_two(y.hi == y.hi ? -1 : y.hi, 0);
    p = vmi_exp_core(y.hi, y.lo, &k, &p_lo);
    if (k == 0) return vmi_two(p, p_lo);
    sum = vmi_fast_two_sum(1, p);
    power = vmi_fast_two_sum(sum.hi, sum.lo + p_lo);
    power = vmi_two(vmi_ldexp(power.hi, k), vmi_ldexp(power.lo, k));
    sum = vmi_two_sum(power.hi, -1);
    return VM_IS_FINITE(power.hi) ? vmi_fast_two_sum(sum.hi, sum.lo + power.lo) : vmi_two(power.hi, 0);
}

/* ln(1 + x) in two words, for finite x > -1: relative error below 2^-(p+7), p the type's digits.
   1 + x = y (1 + t) with y one word: ln y has it, and t is below an ulp of 1 */
VM_API vm_two vmi_log1p(vm_two x)
{
    const vm_two sum = vmi_two_sum(1, x.hi), low = vmi_two_sum(sum.lo, x.lo);
    const vm_two y = vmi_two_sum(sum.hi, low.hi);
    const vm_two t = vmi_two_over(vmi_two_sum(y.lo, low.lo), vmi_two(y.hi, 0));
    return vmi_two_plus(vmi_log(y.hi), vmi_two(t.hi, t.lo - t.hi * t.hi / 2));
}

/* (x - y)/x^2 with y = ln(1 + x), both given: in two words for |x| >= 1/4, but for what the words of x and y lose in
   the difference; below that within 2 ulp, by x = 2u/(1 - u), ln(1 + x) = 2 u + 2 u^3 P(u^2), |u| <= 1/7 */
VM_API vm_two vmi_log1p_rest(vm_two x, vm_two y)
{
#if VM_MANT_DIG > 24
    enum { degree = 9 };
#else
    enum { degree = 4 };
#endif
    const vm_real u = x.hi / (2 + x.hi);
    vm_real P = 0;
    int n;
    if (!(VM_FABS(x.hi) < VM_C(0.25)))
        return vmi_two_over(vmi_two_over(vmi_two_plus(x, vmi_two(-y.hi, -y.lo)), x), x);
    for (n = degree; n >= 0; n--) P = P * (u * u) + 1 / (vm_real)(2 * n + 3);
    return vmi_two((1 - u) / 2 * (1 - u * (1 - u) * P), 0);
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

VM_API vm_real vm_drum_band(vm_real radius, vm_real thickness, vm_real width, vm_real density)
{
    return radius * thickness * width * density;
}

/* M, J_S, and |q|^2/M = M (S S1)^2 at phi; s = sin(phi/2) */
VM_API int vmi_drum_inertia(vm_real phi, vm_real s, const vm_drum *d, vm_real *M, vm_real *J, vm_real *steiner)
{
    const vm_real chord = 2 * d->band * d->radius * s;
    *M = d->mass + d->band * phi;
    *J = d->inertia + d->band * d->radius * d->radius * phi;
    *steiner = chord * chord / *M;
    if (!VM_IS_FINITE(*M) || !VM_IS_FINITE(*J)) return VM_NOT_FINITE;
    if (!(*M > 0)) return VM_BAD_MASS;
    return *J - *steiner > 0 ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vm_drum_at(vm_real phi, const vm_drum *d, vm_drum_geometry *g)
{
    vm_real s, c, M, J, steiner;
    int status;
    if (!d || !g || phi < 0) return VM_BAD_ARGUMENT;
    if (!(VM_IS_FINITE(phi) && VM_IS_FINITE(d->radius))) return VM_NOT_FINITE;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    vmi_sincos(phi / 2, &s, &c);
    status = vmi_drum_inertia(phi, s, d, &M, &J, &steiner);
    if (status) return status;
    g->mass = M;
    g->arc_centre = phi > 0 ? d->radius * s / (phi / 2) : d->radius;
    g->offset = 2 * d->band * d->radius * s / M;
    g->axle_inertia = J;
    g->inertia = J - steiner;
    return VM_OK;
}

VM_API int vm_drum_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real flow = d->band * y[5], slip = d->speed - y[4] - d->radius * y[5];
    vm_real s, c, M, J, steiner, qx, qy, X, Y, N, turn;
    int status;
    (void)t;
    vmi_sincos(y[2] / 2, &s, &c);
    status = vmi_drum_inertia(y[2], s, d, &M, &J, &steiner);
    if (status) return status;
    qx = 2 * d->band * d->radius * s * c;
    qy = 2 * d->band * d->radius * s * s;
    X = -d->stiffness * y[0] - flow * y[3] + y[5] * y[5] * qx;
    Y = -d->stiffness * y[1] + flow * slip + y[5] * y[5] * qy;
    N = -d->damping * y[5] + flow * d->radius * slip;
    turn = (N - (qx * Y - qy * X) / M) / (J - steiner);
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    dydt[3] = (X + turn * qy) / M;
    dydt[4] = (Y - turn * qx) / M;
    dydt[5] = turn;
    return VM_OK;
}

VM_API int vm_drum_rhs_reduced(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real flow = d->band * y[5], unbalance = flow * d->radius * y[5];
    vm_real s, c, M, J, steiner;
    int status;
    (void)t;
    vmi_sincos(y[2], &s, &c);
    status = vmi_drum_inertia(y[2], 0, d, &M, &J, &steiner);
    if (status) return status;
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    dydt[3] = (-d->stiffness * y[0] - flow * y[3] + unbalance * s) / M;
    dydt[4] = (-d->stiffness * y[1] + flow * (d->speed - y[4]) - unbalance * c) / M;
    dydt[5] = (-d->damping * y[5] + flow * d->radius * (d->speed - y[4] - d->radius * y[5])) / J;
    return VM_OK;
}

VM_API int vm_drum_rhs_angle(vm_real phi, const vm_real *y, vm_real *dydt, void *drum)
{
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real rate = vm_drum_rate(phi, d), j = d->band * d->radius * d->radius;
    const vm_real e = d->band * d->speed * d->radius - d->damping;
    vm_real M, J, steiner, slope, drag;
    int status = vmi_drum_inertia(phi, 0, d, &M, &J, &steiner);
    if (status) return status;
    if (!(rate > 0)) return VM_BAD_ARGUMENT;
    slope = (e - j * rate) / J; /* d phi'/d phi (195), phi'' = slope rate */
    drag = d->band / M + slope / rate;
    dydt[0] = y[2], dydt[1] = y[3];
    dydt[2] = -drag * y[2] - d->stiffness * y[0] / (M * rate * rate);
    dydt[3] = -drag * y[3] + (d->band * d->speed * rate - d->stiffness * y[1]) / (M * rate * rate);
    return VM_OK;
}

/* -- The rigid shaft, in two words, the drum's fields taken as exact -- */

VM_API int vmi_drum_turns(const vm_drum *d)
{
    return d->inertia > 0 && d->band >= 0 && d->omega > 0 && VM_IS_FINITE(d->inertia) && VM_IS_FINITE(d->band) &&
           VM_IS_FINITE(d->omega) && VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->speed) && VM_IS_FINITE(d->damping);
}

VM_API vm_two vmi_drum_j(const vm_drum *d) /* mu R^2 */
{
    return vmi_two_times(vmi_two_product(d->band, d->radius), vmi_two(d->radius, 0));
}

/* mu v R - D, of which rounding leaves all digits also where it nearly cancels */
VM_API vm_two vmi_drum_e(const vm_drum *d)
{
    const vm_two band = vmi_two_product(d->band, d->radius);
    const vmi_three drive = vmi_three_times(vmi_three_words(band.hi, band.lo, 0), vmi_three_words(d->speed, 0, 0));
    const vmi_three e = vmi_three_plus(drive, vmi_three_words(-d->damping, 0, 0));
    return vmi_two(e.hi, e.mid);
}

/* a b/c */
VM_API vm_two vmi_drum_share(vm_two a, vm_real b, vm_two c)
{
    return vmi_two_over(vmi_two_times(a, vmi_two(b, 0)), c);
}

VM_API vm_real vm_drum_rate(vm_real phi, const vm_drum *d)
{
    vm_two up, down;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    up = vmi_two_plus(vmi_two_product(d->inertia, d->omega), vmi_two_times(vmi_drum_e(d), vmi_two(phi, 0)));
    down = vmi_two_plus(vmi_two(d->inertia, 0), vmi_two_times(vmi_drum_j(d), vmi_two(phi, 0)));
    return up.hi >= 0 ? vmi_two_over(up, down).hi : VM_NAN;
}

VM_API vm_real vm_drum_stop(const vm_drum *d)
{
    vm_two e;
    if (!vmi_drum_turns(d)) return VM_NAN;
    e = vmi_drum_e(d);
    if (!(e.hi < 0)) return VM_INFINITY;
    return vmi_two_over(vmi_two_product(d->inertia, d->omega), vmi_two(-e.hi, -e.lo)).hi;
}

VM_API vm_real vm_drum_time(vm_real phi, const vm_drum *d)
{
    vm_two x, y, s, part, sum;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    x = vmi_drum_share(vmi_drum_e(d), phi, vmi_two_product(d->inertia, d->omega));
    s = vmi_drum_share(vmi_drum_j(d), phi, vmi_two(d->inertia, 0));
    sum = vmi_two_plus(vmi_two(1, 0), x);
    if (!(sum.hi > 0)) return sum.hi == 0 ? VM_INFINITY : VM_NAN;
    y = vmi_log1p(x);
    part = VM_FABS(x.hi) > VM_EPSILON / 4 ? vmi_two_over(y, x) : vmi_two(1, 0);
    sum = vmi_two_plus(part, vmi_two_times(s, vmi_log1p_rest(x, y)));
    return vmi_drum_share(sum, phi, vmi_two(d->omega, 0)).hi;
}

/* With a = e t/J0, b = j Omega_b t/J0, f = phi/(Omega_b t) and y = a p = ln(1 + x) the equation of vm_drum_time reads
     p + b f^2 (x - y)/x^2 = 1,   x = e^y - 1,   f = p x/y.
   Its left side increases with p, with the slope 1 + b f, and is convex, so that Newton's method converges from
   anywhere. It starts where (x - y)/x^2 f^2 is p^2/2, which is the solution for e = 0; for a > 0 that is too
   much, and so is x = y + a^2/b; for a < 0 it is too little, and so is |a|/(|a| + b). */
VM_API vm_real vmi_drum_start(vm_real a, vm_real b)
{
    const vm_real p = 2 / (1 + VM_SQRT(1 + 2 * b));
    if (a < 0) return p > a / (a - b) ? p : a / (a - b);
    if (a * p > 1 && b > 0) {
        const vm_real bound = (vmi_log(a).hi + vmi_log(1 / a + a / b + p).hi) / a;
        return bound < p ? bound : p;
    }
    return p;
}

VM_API vm_real vm_drum_angle(vm_real t, const vm_drum *d)
{
    const vm_real precise = VM_EPSILON / 8; /* relative error of phi that the last step leaves */
    const int most_steps = 40; /* 8 were the most of 400 000 drums, |a| from 1e-20 to 1e20, b alike */
    vm_two angle, a, b, p, x, y, f, rest;
    vm_real step, left;
    int i;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    angle = vmi_two_product(d->omega, t);
    a = vmi_drum_share(vmi_drum_e(d), t, vmi_two(d->inertia, 0));
    b = vmi_two_over(vmi_two_times(vmi_drum_j(d), angle), vmi_two(d->inertia, 0));
    f = p = vmi_two(vmi_drum_start(a.hi, b.hi), 0);
    for (i = 0, left = 1; i < most_steps && left > precise; i++) {
        y = vmi_two_times(a, p);
        x = vmi_expm1(y);
        f = VM_FABS(y.hi) > VM_EPSILON / 4 ? vmi_two_times(p, vmi_two_over(x, y)) : p;
        rest = vmi_two_times(vmi_two_times(vmi_two_times(b, f), f), vmi_log1p_rest(x, y));
        rest = vmi_two_plus(vmi_two_plus(vmi_two(1, 0), vmi_two(-p.hi, -p.lo)), vmi_two(-rest.hi, -rest.lo));
        step = rest.hi / (1 + b.hi * f.hi);
        left = step / f.hi * (step / f.hi) * (1 + x.hi) * (x.hi > 0 ? 1 + x.hi : 1);
        p = vmi_two_plus(p, vmi_two(step, 0));
        f = vmi_two_plus(f, vmi_two(step * (1 + x.hi), 0));
    }
    return vmi_two_times(angle, f).hi;
}

VM_API vm_real vm_drum_angle_lambert(vm_real t, const vm_drum *d)
{
    const vm_real j = vmi_drum_j(d).hi, e = vmi_drum_e(d).hi, k1 = 1 - e / (j * d->omega);
    vm_real f1, l, w;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d) || k1 == 0 || e == 0) return VM_NAN;
    f1 = 1 + e * e * t / (d->inertia * j * d->omega);
    l = -vmi_log(VM_FABS(k1)).hi - f1 / k1; /* of the argument's size */
    if (l > -1 && k1 > 0) l = -1;           /* by rounding */
    w = k1 < 0 ? vm_lambert_w0_exp(l) : k1 < 1 ? vm_lambert_wm1_mexp(l) : vm_lambert_w0_mexp(l);
    return (-k1 * w - 1) * d->inertia * d->omega / e;
}

/* -- The elastic shaft -- */

VM_API int vm_drum_shaft_init(const vm_drum *d, vm_drum_shaft *s)
{
    vm_drum_shaft r;
    vm_real j, drive, mass;
    if (!d || !s) return VM_BAD_ARGUMENT;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    if (d->stiffness <= 0 || d->omega <= 0) return VM_SINGULAR;
    mass = d->band / d->mass;
    j = d->band * d->radius * d->radius / d->inertia;
    drive = vmi_drum_e(d).hi / (d->inertia * d->omega);
    r.k = VM_SQRT(d->stiffness / d->mass) / d->omega;
    r.delta = (mass + drive - j) / 2;
    r.A = mass + 2 * (drive - j);
    r.shift = mass * d->speed / (d->omega * r.k * r.k);
    if (!VM_IS_FINITE(r.k) || !VM_IS_FINITE(r.delta) || !VM_IS_FINITE(r.A) || !VM_IS_FINITE(r.shift))
        return VM_NOT_FINITE;
    *s = r;
    return VM_OK;
}

/* The phase (2k/3A)(1 - m^3), m^2 = 1 - A phi, is 2k/3 phi (1 + m + m^2)/(1 + m), which A = 0 does not trouble */
VM_API vm_real vm_drum_deflection(vm_real phi, const vm_drum_shaft *s, vm_real a, vm_real alpha, vm_real particular)
{
    const vm_real square = 1 - s->A * phi;
    vm_real m, sine, cosine;
    if (!(square > 0) || !VM_IS_FINITE(phi)) return VM_NAN;
    m = VM_SQRT(square);
    vmi_sincos(2 * s->k / 3 * phi * ((1 + m + square) / (1 + m)) + alpha, &sine, &cosine);
    return a / VM_SQRT(m) * vmi_exp(-s->delta * phi, 0) * cosine + particular / square;
}

VM_API int vm_drum_shaft_valid(const vm_drum_shaft *s) { return s->A < 1 / (2 * VM_PI); }

/* -- Lambert's W: two steps of Fritsch, Shafer and Crowley (Comm. ACM 16, 1973), of fourth order, from 2 % and less.
   The residual is taken in two words, so that the last step leaves little but its own rounding -- */

/* The relative correction of w, whose residual is z = ln(x/w) - w; w1 = 1 + w */
VM_API vm_real vmi_lambert_correction(vm_real w1, vm_real z)
{
    const vm_real first = z / w1, half_q = w1 + 2 * z / 3;
    return first * ((half_q - first / 2) / (half_q - first));
}

/* w from l = ln|x|, away from the branch point */
VM_API vm_real vmi_lambert_far(vm_two l, vm_real w)
{
    int i;
    for (i = 0; i < 2; i++) {
        const vm_two ln = vmi_log(VM_FABS(w));
        const vm_two z = vmi_two_plus(vmi_two_plus(l, vmi_two(-ln.hi, -ln.lo)), vmi_two(-w, 0));
        w += w * vmi_lambert_correction(1 + w, z.hi);
    }
    return w;
}

/* w = -1 - v from s = -1 - ln(-x): v - ln(1 + v) = s, with v > 0 for W_-1 and < 0 for W_0; s down to -eps/2, less
   than an ulp of x beyond the branch point, counts as 0. Starts: of W_-1 by Barry, Culligan-Hensley and Barry (ACM
   TOMS 21, 1995); of W_0, for s < 0.4, the series in sqrt(2s) */
VM_API vm_real vmi_lambert_near(vm_two s, int lower)
{
    const vm_real barry = VM_C(0.3361), root = VM_SQRT(2 * s.hi);
    vm_real v, dv = 0;
    vm_two sum;
    int i;
    if (!(s.hi > 0)) return s.hi > -VM_EPSILON / 2 ? -1 : VM_NAN;
    if (lower) v = s.hi + 2 / barry * (1 - 1 / (1 + barry / 2 * root));
    else v = -root * (1 - root * (VM_C(1.) / 3 - root / 36));
    for (i = 0; i < 2; i++) {
        vm_two x, z, ln;
        v += dv;
        x = vmi_two(v, 0);
        ln = vmi_log1p(x);
        z = VM_FABS(v) < VM_C(0.25) ? vmi_two_times(vmi_log1p_rest(x, ln), vmi_two_product(v, v))
                                    : vmi_two_plus(x, vmi_two(-ln.hi, -ln.lo));
        z = vmi_two_plus(z, vmi_two(-s.hi, -s.lo));
        dv = (1 + v) * vmi_lambert_correction(-v, z.hi);
    }
    sum = vmi_two_sum(1, v);
    return -(sum.hi + (sum.lo + dv));
}

/* -1 - ln(-x) for x < -1/4: from 1 + e x in two words, which keeps every digit of the distance to -1/e */
VM_API vm_two vmi_lambert_depth(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_two e = vmi_two(VM_C(2.718281828459045091), VM_C(1.445646891729250137e-16));
#else
    const vm_two e = vmi_two(VM_C(2.71828174591064453125), VM_C(8.2548400704e-8));
#endif
    const vm_two q = vmi_two_plus(vmi_two(1, 0), vmi_two_times(vmi_two(x, 0), e));
    const vm_two ln = vmi_log1p(vmi_two(-q.hi, -q.lo));
    return vmi_two(-ln.hi, -ln.lo);
}

/* Start of W_0 for -1/4 <= x < 1: within 0.02 */
VM_API vm_real vmi_lambert_pade(vm_real x) { return x * (3 + 4 * x) / (3 + x * (7 + x * VM_C(2.5))); }

/* and above, from L = ln(1 + x) (Winitzki) */
VM_API vm_real vmi_lambert_winitzki(vm_real L) { return L * (1 - vmi_log(1 + L).hi / (2 + L)); }

VM_API vm_real vm_lambert_w0(vm_real x)
{
    if (x == 0 || x != x) return x;
    if (!VM_IS_FINITE(x)) return VM_NAN;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 0);
    return vmi_lambert_far(vmi_log(VM_FABS(x)),
                           x < 1 ? vmi_lambert_pade(x) : vmi_lambert_winitzki(vmi_log(1 + x).hi));
}

VM_API vm_real vm_lambert_wm1(vm_real x)
{
    vm_two ln;
    if (!(x <= 0) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 1);
    ln = vmi_log(-x);
    return vmi_lambert_near(vmi_two_plus(vmi_two(-1, 0), vmi_two(-ln.hi, -ln.lo)), 1);
}

#define VMI_LAMBERT_TINY (-(VM_MANT_DIG + 2) * VM_C(0.7)) /* W_0(x) = x for ln|x| below */

VM_API vm_real vm_lambert_w0_exp(vm_real l)
{
    if (!VM_IS_FINITE(l)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return vmi_exp(l, 0);
    return vmi_lambert_far(vmi_two(l, 0), l < 0    ? vmi_lambert_pade(vmi_exp(l, 0))
                                          : l < 40 ? vmi_lambert_winitzki(vmi_log(1 + vmi_exp(l, 0)).hi)
                                                   : vmi_lambert_winitzki(l));
}

VM_API vm_real vm_lambert_w0_mexp(vm_real l)
{
    if (!(l <= -1) || !VM_IS_FINITE(l)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return -vmi_exp(l, 0);
    if (l > VM_C(-1.375)) return vmi_lambert_near(vmi_two(-1 - l, 0), 0);
    return vmi_lambert_far(vmi_two(l, 0), vmi_lambert_pade(-vmi_exp(l, 0)));
}

VM_API vm_real vm_lambert_wm1_mexp(vm_real l)
{
    if (!(l <= -1) || !VM_IS_FINITE(l)) return VM_NAN;
    if (l < -1 / VM_EPSILON) return vmi_lambert_far(vmi_two(l, 0), l);
    return vmi_lambert_near(vmi_two_sum(-1, -l), 1);
}

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

enum { VMI_ALL_MOTIONS = 1 << VM_LINE | 1 << VM_AXLE | 1 << VM_PLANE | 1 << VM_POINT | 1 << VM_FREE };
enum { VMI_FLAT = 1 << VM_PLANE | 1 << VM_POINT, VMI_NOT_FREE = VMI_ALL_MOTIONS & ~(1 << VM_FREE) };

VM_INLINE int vmi_scene_mass_at(const vm_scene_body *b) { return b->positions + b->coordinates; }

VM_INLINE int vmi_scene_body_size(const vm_scene_body *b) { return vmi_scene_mass_at(b) + (b->mass_is_state != 0); }

/* Position and velocity along a coordinate; the ground's are 0 */
VM_INLINE vm_real vmi_scene_x(const vm_scene *s, const vm_real *y, int body, int coordinate)
{
    return body < 0 ? 0 : y[s->bodies[body].at + coordinate];
}
VM_INLINE vm_real vmi_scene_v(const vm_scene *s, const vm_real *y, int body, int coordinate)
{
    const vm_scene_body *b = s->bodies + body;
    return body < 0 ? 0 : y[b->at + b->positions + coordinate];
}

/* f on the body of e, -f on what it acts against */
VM_INLINE void vmi_scene_act(vm_scene *s, const vm_effect *e, vm_real f)
{
    s->bodies[e->body].load.force[e->coordinate] += f;
    if (e->other >= 0) s->bodies[e->other].load.force[e->other_coordinate] -= f;
}

/* ---- Scenes: bodies ----------------------------------------------------------------------------------------- */

VM_API vm_scene_body vmi_scene_body(int motion, int positions, int coordinates)
{
    vm_scene_body b;
    memset(&b, 0, sizeof b);
    b.motion = motion, b.positions = positions, b.coordinates = coordinates;
    return b;
}

/* A line and an axle: one coordinate */
VM_API int vmi_single_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    rates[0] = state[1];
    rates[1] = b->load.force[0] / (b->load.mass + b->load.extra);
    return VM_OK;
}

VM_API void vmi_line_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b, (void)angle;
    state[0] = now->r.x, state[1] = now->v.x;
}

VM_API void vmi_line_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[0], now->v.x = state[1];
}

VM_API vm_scene_body vm_scene_line(vm_real mass, vm_real x, vm_real v)
{
    vm_scene_body b = vmi_scene_body(VM_LINE, 1, 1);
    b.start.mass = mass, b.start.r.x = x, b.start.v.x = v;
    b.put = vmi_line_put, b.get = vmi_line_get, b.accelerate = vmi_single_accelerate;
    return b;
}

VM_API void vmi_axle_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[0] = angle, state[1] = now->omega.z;
}

VM_API void vmi_axle_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->omega.z = state[1], now->inertia.zz = now->mass;
}

VM_API vm_scene_body vm_scene_axle(vm_real inertia, vm_real angle, vm_real omega)
{
    vm_scene_body b = vmi_scene_body(VM_AXLE, 1, 1);
    b.start.mass = inertia, b.start.omega.z = omega, b.angle = angle;
    b.put = vmi_axle_put, b.get = vmi_axle_get, b.accelerate = vmi_single_accelerate;
    return b;
}

VM_API int vmi_plane_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[3 + i];
    for (i = 0; i < 2; i++) rates[3 + i] = b->load.force[i] / b->load.mass;
    rates[5] = b->load.force[2] / b->inertia.zz;
    return VM_OK;
}

VM_API void vmi_plane_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[0] = now->r.x, state[1] = now->r.y, state[2] = angle;
    state[3] = now->v.x, state[4] = now->v.y, state[5] = now->omega.z;
}

VM_API void vmi_plane_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[0], now->r.y = state[1], now->v.x = state[3], now->v.y = state[4];
    vmi_sincos(state[2] / 2, &now->q.z, &now->q.w);
    now->omega.z = state[5];
    now->inertia.xx = now->inertia.yy = now->inertia.zz / 2; /* of a lamina: any that is possible will do */
}

VM_API vm_scene_body vm_scene_plane(vm_real mass, vm_real inertia, vm_vec3 r, vm_real angle, vm_vec3 v,
                                    vm_real omega)
{
    vm_scene_body b = vmi_scene_body(VM_PLANE, 3, 3);
    b.start.mass = mass, b.start.inertia.zz = inertia;
    b.start.r = r, b.start.v = v, b.start.omega.z = omega, b.angle = angle;
    b.put = vmi_plane_put, b.get = vmi_plane_get, b.accelerate = vmi_plane_accelerate;
    return b;
}

VM_API int vmi_point_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[b->positions + i];
    for (i = 0; i < 3; i++) rates[b->positions + i] = b->load.force[i] / b->load.mass;
    return VM_OK;
}

VM_API void vmi_point_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vm_real *v = state + b->positions;
    (void)angle;
    state[0] = now->r.x, state[1] = now->r.y, state[2] = now->r.z;
    v[0] = now->v.x, v[1] = now->v.y, v[2] = now->v.z;
}

VM_API void vmi_point_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    const vm_real *v = state + b->positions;
    now->r = vmi_vec3(state[0], state[1], state[2]);
    now->v = vmi_vec3(v[0], v[1], v[2]);
}

VM_API vm_scene_body vm_scene_point(vm_real mass, vm_vec3 r, vm_vec3 v)
{
    vm_scene_body b = vmi_scene_body(VM_POINT, 3, 3);
    b.start.mass = mass, b.start.r = r, b.start.v = v;
    b.put = vmi_point_put, b.get = vmi_point_get, b.accelerate = vmi_point_accelerate;
    return b;
}

VM_API vm_quat vmi_free_quat(const vm_real *state)
{
    vm_quat q;
    q.w = state[3], q.x = state[4], q.y = state[5], q.z = state[6];
    return q;
}

/* Euler's equations in body axes, and the quaternion's, whose length is drawn to 1 (as exp(-t)). About the null axis
   of a rod, which no load turns, the spin stays. */
VM_API int vmi_free_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_inertia *i = &b->filled;
    const vm_vec3 w = vmi_vec3(state[10], state[11], state[12]);
    const vm_quat q = vmi_free_quat(state);
    const vm_real *f = b->load.force, pull = (1 - (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)) / 2;
    const vmi_mat3 axes = vmi_rotation(q);
    const vm_vec3 torque = vmi_times_transposed(&axes, vmi_vec3(f[3], f[4], f[5]));
    const vm_vec3 h = vmi_sub(torque, vmi_cross(w, vmi_inertia_times(&b->inertia, w)));
    vm_quat spin, turn;
    vm_real a[9];
    spin.w = 0, spin.x = w.x / 2, spin.y = w.y / 2, spin.z = w.z / 2;
    turn = vmi_quat_times(q, spin);
    vmi_point_accelerate(b, state, rates);
    rates[3] = turn.w + pull * q.w, rates[4] = turn.x + pull * q.x;
    rates[5] = turn.y + pull * q.y, rates[6] = turn.z + pull * q.z;
    a[0] = i->xx, a[4] = i->yy, a[8] = i->zz, a[1] = a[3] = i->xy, a[2] = a[6] = i->xz, a[5] = a[7] = i->yz;
    rates[10] = h.x, rates[11] = h.y, rates[12] = h.z;
    return vmi_solve_linear(3, a, rates + 10) ? VM_BAD_INERTIA : VM_OK;
}

/* Euler's equations are solved with something about a null axis, too: it finds nothing to accelerate there */
VM_API vm_inertia vmi_free_filled(const vm_inertia *i)
{
    const vm_real trace = i->xx + i->yy + i->zz;
    vmi_principal p = vmi_principal_axes(i);
    int k, null_axes = 0;
    for (k = 0; k < 3; k++)
        if (!(p.moment[k] > vmi_slack(i))) p.moment[k] = trace > 0 ? trace : 1, null_axes++;
    return null_axes ? vmi_inertia_from(&p) : *i;
}

VM_API void vmi_free_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    const vmi_mat3 turn = vmi_rotation(now->q);
    const vm_vec3 omega = vmi_times_transposed(&turn, now->omega);
    const int none = now->q.w == 0 && now->q.x == 0 && now->q.y == 0 && now->q.z == 0;
    b->filled = vmi_free_filled(&now->inertia);
    vmi_point_put(b, now, angle, state);
    state[3] = none ? 1 : now->q.w, state[4] = now->q.x, state[5] = now->q.y, state[6] = now->q.z;
    state[10] = omega.x, state[11] = omega.y, state[12] = omega.z;
}

VM_API void vmi_free_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    vmi_mat3 turn;
    vmi_point_get(b, state, now);
    now->q = vmi_free_quat(state);
    turn = vmi_rotation(now->q);
    now->omega = vmi_times(&turn, vmi_vec3(state[10], state[11], state[12]));
}

VM_API vm_scene_body vm_scene_free(const vm_body *start)
{
    vm_scene_body b = vmi_scene_body(VM_FREE, 7, 6);
    if (!start) return b; /* which vm_scene_check refuses */
    b.start = *start;
    b.put = vmi_free_put, b.get = vmi_free_get, b.accelerate = vmi_free_accelerate;
    return b;
}

VM_API vm_scene_body vm_scene_with_mass_state(vm_scene_body body)
{
    body.mass_is_state = 1;
    return body;
}

VM_API vm_scene_body vm_scene_absent(vm_scene_body body)
{
    body.absent = 1;
    return body;
}

/* ---- Scenes: effects ---------------------------------------------------------------------------------------- */

VM_INLINE vm_real vm_force_spring(vm_real k, vm_real alpha, vm_real x)
{
    if (alpha == 1) return -k * x;
    if (alpha == 3) return -k * (x * x * x);
    if (alpha == 2) return -k * (x * VM_FABS(x));
    return -VM_COPYSIGN(k, x) * vmi_raised(VM_FABS(x), alpha) * (x != 0);
}
VM_INLINE vm_real vm_force_damper(vm_real b, vm_real v) { return -b * v; }
VM_INLINE vm_real vm_force_van_der_pol(vm_real b, vm_real c, vm_real x, vm_real v) { return (b - c * (x * x)) * v; }
VM_INLINE vm_real vm_force_drive(vm_real torque, vm_real kappa, vm_real omega) { return torque - kappa * omega; }
VM_INLINE vm_real vm_force_harmonic(vm_real force, vm_real frequency, vm_real phase, vm_real t)
{
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    return force * c;
}
VM_INLINE vm_real vm_force_stream(vm_real rate, vm_real u, vm_real share, vm_real v)
{
    return rate * (u + (share - 1) * v);
}

/* An effect on one coordinate, against another */
VM_API vm_effect vmi_effect(int body, int coordinate, int other, int other_coordinate, unsigned motions, vm_real p0,
                            vm_real p1, vm_real p2)
{
    vm_effect e;
    memset(&e, 0, sizeof e);
    e.body = body, e.coordinate = coordinate, e.other = other, e.other_coordinate = other_coordinate;
    e.motions = motions, e.other_motions = VMI_ALL_MOTIONS;
    e.order = 1;
    e.p[0] = p0, e.p[1] = p1, e.p[2] = p2;
    return e;
}

VM_API void vmi_apply_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_load *load = &s->bodies[e->body].load;
    (void)t, (void)y;
    load->force[e->coordinate] += load->mass * e->p[0];
}

VM_API vm_effect vm_effect_gravity(int body, int coordinate, vm_real g)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS & ~(1 << VM_AXLE), g, 0, 0);
    e.apply = vmi_apply_gravity;
    return e;
}

VM_API void vmi_apply_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = vmi_scene_x(s, y, e->body, e->coordinate) - vmi_scene_x(s, y, e->other, e->other_coordinate);
    (void)t;
    vmi_scene_act(s, e, vm_force_spring(e->p[0], e->p[1], x - e->p[2]));
}

VM_API vm_effect vm_effect_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                  vm_real alpha, vm_real rest)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, k, alpha, rest);
    e.apply = vmi_apply_spring;
    return e;
}

VM_API void vmi_apply_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real v = vmi_scene_v(s, y, e->body, e->coordinate) - vmi_scene_v(s, y, e->other, e->other_coordinate);
    (void)t;
    vmi_scene_act(s, e, vm_force_damper(e->p[0], v));
}

VM_API vm_effect vm_effect_damper(int body, int coordinate, int other, int other_coordinate, vm_real b)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, b, 0, 0);
    e.apply = vmi_apply_damper;
    return e;
}

VM_API void vmi_apply_van_der_pol(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    vmi_scene_act(s, e,
                  vm_force_van_der_pol(e->p[0], e->p[1], vmi_scene_x(s, y, e->body, e->coordinate),
                                       vmi_scene_v(s, y, e->body, e->coordinate)));
}

VM_API vm_effect vm_effect_van_der_pol(int body, int coordinate, vm_real b, vm_real c)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, b, c, 0);
    e.apply = vmi_apply_van_der_pol;
    return e;
}

VM_API void vmi_apply_drive(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    vmi_scene_act(s, e, vm_force_drive(e->p[0], e->p[1], vmi_scene_v(s, y, e->body, e->coordinate)));
}

VM_API vm_effect vm_effect_drive(int body, int coordinate, vm_real torque, vm_real kappa)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, torque, kappa, 0);
    e.apply = vmi_apply_drive;
    return e;
}

VM_API void vmi_apply_harmonic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)y;
    vmi_scene_act(s, e, vm_force_harmonic(e->p[0], e->p[1], e->p[2], t));
}

VM_API vm_effect vm_effect_harmonic(int body, int coordinate, vm_real force, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, force, frequency, phase);
    e.apply = vmi_apply_harmonic;
    return e;
}

VM_API void vmi_apply_user(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_scene_act(
        s, e,
        e->force(t, vmi_scene_x(s, y, e->body, e->coordinate), vmi_scene_v(s, y, e->body, e->coordinate), e->ctx));
}

VM_API vm_effect vm_effect_user(int body, int coordinate,
                                vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, 0, 0, 0);
    e.apply = force ? vmi_apply_user : NULL;
    e.force = force, e.ctx = ctx;
    return e;
}

VM_API vm_effect vm_effect_callback(int body, int other,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene),
                                    void *ctx)
{
    vm_effect e = vmi_effect(body, 0, other, 0, VMI_ALL_MOTIONS, 0, 0, 0);
    e.apply = apply, e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_shaft(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_scene_body *b = s->bodies + e->body;
    const vm_real *r = y + b->at, size = VM_SQRT(r[0] * r[0] + r[1] * r[1]);
    const vm_real k = size > 0 ? vm_force_spring(e->p[0], e->p[1], size) / size : 0;
    (void)t;
    b->load.force[0] += k * r[0];
    b->load.force[1] += k * r[1];
}

VM_API vm_effect vm_effect_shaft(int body, vm_real k, vm_real alpha)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, k, alpha, 0);
    e.apply = vmi_apply_shaft;
    return e;
}

VM_API void vmi_apply_unbalance(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real *force = s->bodies[e->body].load.force, sine, cosine;
    (void)y;
    vmi_sincos(e->p[1] * t + e->p[2], &sine, &cosine);
    force[0] += e->p[0] * (e->p[1] * e->p[1]) * cosine;
    force[1] += e->p[0] * (e->p[1] * e->p[1]) * sine;
}

VM_API vm_effect vm_effect_unbalance(int body, vm_real unbalance, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, unbalance, frequency, phase);
    e.apply = vmi_apply_unbalance;
    return e;
}

VM_API void vmi_apply_gyroscopic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_scene_body *b = s->bodies + e->body;
    const vm_real *v = y + b->at + b->positions;
    (void)t;
    b->load.force[0] -= e->p[0] * v[1];
    b->load.force[1] += e->p[0] * v[0];
}

VM_API vm_effect vm_effect_gyroscopic(int body, vm_real coupling)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, coupling, 0, 0);
    e.apply = vmi_apply_gyroscopic;
    return e;
}

/* ---- Scenes: mass that varies ------------------------------------------------------------------------------- */

/* rate (u + (share - 1) v) on each coordinate that moves the mass; p = u, share */
VM_INLINE void vmi_scene_reactive(const vm_effect *e, const vm_real *y, vm_scene *s, vm_real rate)
{
    vm_scene_body *b = s->bodies + e->body;
    const vm_real *v = y + b->at + b->positions, share = e->p[3];
    const int n = b->motion <= VM_AXLE ? 1 : b->motion == VM_PLANE ? 2 : 3;
    int i;
    for (i = 0; i < n; i++) {
        const vm_real own = e->p[i] + share * v[i];
        b->load.force[i] += rate * (own - v[i]);
        if (!s->book) continue;
        b->load.reactive[i] += rate * (own - v[i]);
        b->load.brought[i] += rate * own;
        b->load.brought_energy += rate * own * own / 2;
        b->load.mixing += rate * (own - v[i]) * (own - v[i]) / 2;
    }
}

/* The mass is now that of the law; M' = by_t + by_x v + by_v v' */
VM_INLINE void vmi_scene_follow(const vm_effect *e, const vm_real *y, vm_scene *s, const vm_mass_now *now)
{
    vm_scene_body *b = s->bodies + e->body;
    const vm_real v = y[b->at + b->positions];
    b->load.mass = now->mass + b->jumped;
    b->load.extra = now->by_v * ((1 - e->p[3]) * v - e->p[0]);
    b->load.by_v = now->by_v, b->load.own = e->p[0] + e->p[3] * v;
    vmi_scene_reactive(e, y, s, now->by_t + now->by_x * v);
}

VM_API void vmi_apply_mass_law(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_mass_now now = e->law(t, vmi_scene_x(s, y, e->body, 0), vmi_scene_v(s, y, e->body, 0), e->ctx);
    vmi_scene_follow(e, y, s, &now);
}

VM_API vm_effect vm_effect_mass_law(int body, vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
                                    void *ctx, vm_vec3 u, vm_real share)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_NOT_FREE, u.x, u.y, u.z);
    e.p[3] = share;
    e.order = 0;
    e.apply = law ? vmi_apply_mass_law : NULL;
    e.law = law, e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = vmi_scene_x(s, y, e->body, 0), v = vmi_scene_v(s, y, e->body, 0), c = e->p[4];
    vm_mass_now now = {0, 0, 0, 0};
    now.mass = s->bodies[e->body].start.mass;
    if (e->other_coordinate == VM_MASS_OF_T) now.mass += c * t, now.by_t = c;
    else if (e->other_coordinate == VM_MASS_OF_X) now.mass += c * x, now.by_x = c;
    else now.mass += c * v * v, now.by_v = 2 * c * v;
    vmi_scene_follow(e, y, s, &now);
}

VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real share)
{
    const unsigned motions = kind == VM_MASS_OF_T ? VMI_NOT_FREE : 1 << VM_LINE | 1 << VM_AXLE;
    vm_effect e = vmi_effect(body, 0, VM_GROUND, kind, motions, u, 0, 0);
    e.p[3] = share, e.p[4] = c;
    e.order = 0;
    e.apply = kind >= VM_MASS_OF_T && kind <= VM_MASS_OF_V2 ? vmi_apply_mass : NULL;
    return e;
}

VM_API void vmi_apply_stream(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    s->bodies[e->body].load.mass_rate += e->p[4];
    vmi_scene_reactive(e, y, s, e->p[4]);
}

VM_API vm_effect vm_effect_stream(int body, vm_real rate, vm_vec3 u, vm_real share)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_NOT_FREE, u.x, u.y, u.z);
    e.p[3] = share, e.p[4] = rate;
    e.needs_mass_state = 1;
    e.apply = vmi_apply_stream;
    return e;
}

/* The far end of a link: a point that moves as given, or another body, which can accelerate */
typedef struct VM_TAG(vmi_link_end) {
    vm_real r[3], v[3], a[3]; /* a: without the link */
    vm_real mobility[3];      /* acceleration by force, of each coordinate */
} vmi_link_end;

VM_API void vmi_link_body(const vm_scene *s, int body, const vm_real *y, vmi_link_end *end)
{
    const vm_scene_body *b = s->bodies + body;
    const vm_real *r = y + b->at, *v = r + b->positions;
    const int n = b->motion == VM_LINE ? 1 : b->motion == VM_PLANE ? 2 : 3;
    int i;
    for (i = 0; i < 3; i++) {
        end->r[i] = i < n ? r[i] : 0, end->v[i] = i < n ? v[i] : 0;
        end->mobility[i] = i < n ? 1 / (b->load.mass + b->load.extra) : 0;
        end->a[i] = end->mobility[i] * b->load.force[i];
    }
}

VM_API void vmi_link_point(const vm_effect *e, vm_real t, vmi_link_end *end)
{
    vm_vec3 r, v, a;
    int i;
    e->point(t, &r, &v, &a, e->ctx);
    end->r[0] = r.x, end->r[1] = r.y, end->r[2] = r.z;
    end->v[0] = v.x, end->v[1] = v.y, end->v[2] = v.z;
    end->a[0] = a.x, end->a[1] = a.y, end->a[2] = a.z;
    for (i = 0; i < 3; i++) end->mobility[i] = 0;
}

/* The link pulls with lambda d, d = r - far end: C = (d^2 - l^2)/2 obeys C'' + 2 rate C' + rate^2 C = 0, which gives
   lambda from what else acts on its ends. p = length, rate, cord */
VM_API void vmi_apply_link(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_scene_body *b = s->bodies + e->body;
    vm_real *force = b->load.force, *far_force = e->other >= 0 ? s->bodies[e->other].load.force : NULL;
    const int n = b->motion == VM_PLANE ? 2 : 3;
    /* shorter by this, a cord does not pull: more than its length is uncertain by, or it would be taut by turns */
    const vm_real rate = e->p[1], loose = VM_C(1e-6) + 512 * VM_EPSILON;
    vmi_link_end near, far;
    vm_real d[3], dd = 0, dv = 0, vv = 0, da = 0, mobility = 0, C, lambda;
    int i;
    vmi_link_body(s, e->body, y, &near);
    if (far_force) vmi_link_body(s, e->other, y, &far);
    else vmi_link_point(e, t, &far);
    for (i = 0; i < n; i++) {
        const vm_real v = near.v[i] - far.v[i];
        d[i] = near.r[i] - far.r[i];
        dd += d[i] * d[i], dv += d[i] * v, vv += v * v, da += d[i] * (near.a[i] - far.a[i]);
        mobility += d[i] * d[i] * (near.mobility[i] + far.mobility[i]);
    }
    C = (dd - e->p[0] * e->p[0]) / 2;
    lambda = -(da + vv + 2 * rate * dv + rate * rate * C) / mobility;
    if (e->p[2] != 0 && (lambda > 0 || C < -loose * dd)) return; /* slack */
    for (i = 0; i < n; i++) {
        force[i] += lambda * d[i];
        if (far_force && far.mobility[i] > 0) far_force[i] -= lambda * d[i];
    }
}

VM_API vm_effect vm_effect_link(int body, int other, vm_moving_point point, void *ctx, vm_real length, int cord,
                                vm_real rate)
{
    vm_effect e = vmi_effect(body, 0, other, 0, VMI_FLAT, length, rate, (vm_real)(cord != 0));
    e.order = 2, e.other_motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.apply = point || other >= 0 ? vmi_apply_link : NULL;
    e.point = point, e.ctx = ctx;
    return e;
}

/* ---- Scenes: bodies and state ------------------------------------------------------------------------------- */

VM_API int vm_scene_size(const vm_scene *scene)
{
    int i, size = scene->book ? VM_BOOK : 0;
    for (i = 0; i < scene->n_bodies; i++) size += vmi_scene_body_size(scene->bodies + i);
    return size;
}

VM_API void vm_scene_body_at(const vm_scene *scene, int body, const vm_real *y, vm_body *now)
{
    const vm_scene_body *b = scene->bodies + body;
    *now = b->start;
    now->mass = b->mass_is_state ? y[b->at + vmi_scene_mass_at(b)] : b->load.mass;
    now->inertia = b->inertia;
    b->get(b, y + b->at, now);
}

/* The state of a body that moves as now; its angle is given apart, since a turn more or less does not show in now */
VM_API void vmi_scene_put(vm_scene *s, int body, const vm_body *now, vm_real angle, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    b->mass = now->mass, b->inertia = now->inertia;
    if (b->mass_is_state) y[b->at + vmi_scene_mass_at(b)] = now->mass;
    b->put(b, now, angle, y + b->at);
}

/* Effects on bodies that are not there do not act */
VM_API void vmi_scene_presence(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_effects; i++) {
        vm_effect *e = s->effects + i;
        const int gone = s->bodies[e->body].away || (e->other >= 0 && s->bodies[e->other].away);
        e->idle = (e->idle & 1) | (gone ? 2 : 0);
    }
}

/* ---- Scenes: the right-hand side ---------------------------------------------------------------------------- */

VM_INLINE void vmi_scene_clear(vm_scene_body *b, const vm_real *y, int book)
{
    const int n = b->coordinates;
    int i;
    b->load.mass = b->mass_is_state ? y[b->at + vmi_scene_mass_at(b)] : b->mass;
    b->load.extra = b->load.by_v = b->load.mass_rate = 0;
    for (i = 0; i < n; i++) b->load.force[i] = 0;
    if (!book) return;
    for (i = 0; i < 6; i++) b->load.brought[i] = b->load.reactive[i] = 0;
    b->load.brought_energy = b->load.mixing = 0;
}

/* What acts on each body now */
VM_INLINE void vmi_scene_load(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) vmi_scene_clear(s->bodies + i, y, s->book != NULL);
    for (i = 0; i < s->n_effects; i++)
        if (!s->effects[i].idle) s->effects[i].apply(s->effects + i, t, y, s);
}

VM_INLINE int vmi_scene_accelerate(const vm_scene_body *b, const vm_real *y, vm_real *dydt)
{
    const vm_load *load = &b->load;
    if (!(load->mass > 0)) return VM_BAD_MASS;
    if (!(load->mass + load->extra > 0)) return VM_SINGULAR;
    if (b->mass_is_state) dydt[b->at + vmi_scene_mass_at(b)] = load->mass_rate;
    return b->accelerate(b, y + b->at, dydt + b->at);
}

VM_API int vm_scene_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_scene *s = (vm_scene *)ctx;
    int i, status = VM_OK;
    vmi_scene_load(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        int k;
        if (b->away) {
            for (k = 0; k < vmi_scene_body_size(b); k++) dydt[b->at + k] = 0;
            continue;
        }
        k = vmi_scene_accelerate(b, y, dydt);
        if (k && !status) status = k, dydt[b->at] = VM_NAN; /* the integrator tries a shorter step */
    }
    if (s->book) s->book->rates(s, y, dydt + vm_scene_size(s) - VM_BOOK);
    s->status = status;
    return 0;
}

/* ---- Scenes: balance ---------------------------------------------------------------------------------------- */

/* Numbers by coordinate as vectors: the part that moves the mass centre, the part that turns, inertial axes */
VM_API vm_vec3 vmi_scene_moving(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, 0);
    if (b->motion == VM_LINE) return vmi_vec3(a[0], 0, 0);
    return vmi_vec3(a[0], a[1], b->motion == VM_PLANE ? 0 : a[2]);
}
VM_API vm_vec3 vmi_scene_turning(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, a[0]);
    if (b->motion == VM_PLANE) return vmi_vec3(0, 0, a[2]);
    return b->motion == VM_FREE ? vmi_vec3(a[3], a[4], a[5]) : vmi_vec3(0, 0, 0);
}
VM_API vm_vec3 vmi_scene_spin(const vm_scene_body *b, const vm_real *y)
{
    const vm_vec3 w = vmi_scene_turning(b, y + b->at + b->positions);
    vmi_mat3 axes;
    if (b->motion != VM_FREE) return w;
    axes = vmi_rotation(vmi_free_quat(y + b->at));
    return vmi_times(&axes, w);
}

VM_INLINE void vmi_scene_store(vm_vec3 a, vm_real *d) { d[0] += a.x, d[1] += a.y, d[2] += a.z; }

/* What a body's load adds to the book by the second: impulse, angular impulse, momentum and angular momentum brought,
   work, energy brought, mixing */
VM_API void vmi_scene_enter_loads(const vm_scene_body *b, const vm_real *y, vm_real *d)
{
    const vm_load *load = &b->load;
    const vm_vec3 at = vmi_scene_moving(b, y + b->at);
    const vm_vec3 force = vmi_sub(vmi_scene_moving(b, load->force), vmi_scene_moving(b, load->reactive));
    const vm_vec3 torque = vmi_sub(vmi_scene_turning(b, load->force), vmi_scene_turning(b, load->reactive));
    const vm_vec3 brought = vmi_scene_moving(b, load->brought);
    vmi_scene_store(force, d);
    vmi_scene_store(vmi_add(torque, vmi_cross(at, force)), d + 3);
    vmi_scene_store(brought, d + 6);
    vmi_scene_store(vmi_add(vmi_scene_turning(b, load->brought), vmi_cross(at, brought)), d + 9);
    d[12] += vmi_dot(force, vmi_scene_moving(b, y + b->at + b->positions)) + vmi_dot(torque, vmi_scene_spin(b, y));
    d[13] += load->brought_energy, d[14] += load->mixing;
}

VM_API void vmi_scene_enter(vm_scene_body *b, const vm_real *y, vm_real *d)
{
    vm_load *load = &b->load;
    if (load->by_v != 0) { /* M'(v) v' is known only now */
        const vm_real rate = load->by_v * (load->force[0] / (load->mass + load->extra));
        const vm_real faster = load->own - y[b->at + 1];
        load->brought[0] += rate * load->own;
        load->brought_energy += rate * load->own * load->own / 2;
        load->mixing += rate * faster * faster / 2;
    }
    vmi_scene_enter_loads(b, y, d);
}

VM_API void vmi_scene_rates(vm_scene *s, const vm_real *y, vm_real *rates)
{
    int i;
    for (i = 0; i < VM_BOOK; i++) rates[i] = 0;
    for (i = 0; i < s->n_bodies; i++)
        if (!s->bodies[i].away) vmi_scene_enter(s->bodies + i, y, rates);
}

/* Momentum, angular momentum about the origin and kinetic energy of all bodies that are there */
VM_API void vmi_scene_totals(const vm_scene *s, const vm_real *y, vm_book *book)
{
    const vm_vec3 zero = {0, 0, 0};
    int i;
    book->momentum = book->angular_momentum = zero;
    book->energy = 0;
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        vm_body now;
        vm_vec3 p, spin;
        if (b->away) continue;
        vm_scene_body_at(s, i, y, &now);
        if (b->motion == VM_AXLE) now.mass = 0;
        p = vmi_scale(now.mass, now.v), spin = vmi_spin_momentum(&now);
        book->momentum = vmi_add(book->momentum, p);
        book->angular_momentum = vmi_add(book->angular_momentum, vmi_add(spin, vmi_cross(now.r, p)));
        book->energy += (vmi_dot(p, now.v) + vmi_dot(spin, now.omega)) / 2;
    }
}

VM_API void vmi_scene_open_book(vm_scene *s, const vm_real *y, vm_real *sums)
{
    int i;
    vm_scene_keep_book(s, s->book);
    vmi_scene_totals(s, y, s->book);
    for (i = 0; i < VM_BOOK; i++) sums[i] = 0;
}

VM_API void vm_scene_keep_book(vm_scene *scene, vm_book *book)
{
    scene->book = book;
    if (!book) return;
    memset(book, 0, sizeof *book);
    book->open = vmi_scene_open_book;
    book->rates = vmi_scene_rates;
    book->totals = vmi_scene_totals;
}

VM_API int vm_scene_balance(vm_scene *scene, vm_real t, const vm_real *y, vm_book *book)
{
    const vm_book *start = scene ? scene->book : NULL;
    const vm_real *d;
    vm_book b;
    if (!start || !y || !book) return VM_BAD_ARGUMENT;
    b = *start, d = y + vm_scene_size(scene) - VM_BOOK;
    vmi_scene_load(scene, t, y);
    vmi_scene_totals(scene, y, &b);
    b.impulse = vmi_add(start->impulse, vmi_vec3(d[0], d[1], d[2]));
    b.angular_impulse = vmi_add(start->angular_impulse, vmi_vec3(d[3], d[4], d[5]));
    b.brought = vmi_vec3(d[6], d[7], d[8]);
    b.brought_angular = vmi_vec3(d[9], d[10], d[11]);
    b.work = d[12], b.brought_energy = d[13], b.mixing = d[14];
    b.momentum_defect = vmi_sub(vmi_sub(b.momentum, start->momentum), vmi_add(b.impulse, b.brought));
    b.angular_defect = vmi_sub(vmi_sub(b.angular_momentum, start->angular_momentum),
                               vmi_add(b.angular_impulse, b.brought_angular));
    b.energy_defect = b.energy - start->energy - (b.work + b.brought_energy - b.mixing + b.jump_energy);
    *book = b;
    return VM_OK;
}

/* ---- Scenes: the check -------------------------------------------------------------------------------------- */

VM_API int vmi_no_inertia(const vm_inertia *i)
{
    return i->xx == 0 && i->yy == 0 && i->zz == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
}

VM_API int vmi_scene_check_body(const vm_scene_body *b)
{
    if (b->motion < VM_LINE || b->motion > VM_FREE || !b->put) return VM_BAD_MOTION;
    if (!vmi_body_finite(&b->start) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->start.mass > 0)) return VM_BAD_MASS;
    if (b->motion == VM_PLANE && !(b->start.inertia.zz > 0)) return VM_BAD_INERTIA;
    if (b->motion == VM_POINT && !vmi_no_inertia(&b->start.inertia)) return VM_BAD_INERTIA;
    return b->motion == VM_FREE ? vmi_check_body(&b->start) : (int)VM_OK;
}

VM_API int vmi_scene_check_coordinate(const vm_scene *s, int body, int coordinate)
{
    if (body < 0 || body >= s->n_bodies) return VM_NO_SUCH_BODY;
    if (coordinate < 0 || coordinate >= s->bodies[body].coordinates) return VM_NO_SUCH_COORDINATE;
    /* of a free body's rotation there is no coordinate */
    return s->bodies[body].motion == VM_FREE && coordinate > 2 ? VM_NO_SUCH_COORDINATE : VM_OK;
}

/* Mass laws (order 0) first, links (order 2) last, at most one of either kind for a body */
VM_API int vmi_scene_check_order(const vm_scene *s, const vm_effect *e)
{
    const vm_effect *before;
    if (e->order == 0 && s->bodies[e->body].mass_is_state) return VM_TWO_MASS_LAWS;
    for (before = s->effects; before < e; before++) {
        if (before->body != e->body && before->other != e->body && (e->other < 0 || before->body != e->other))
            continue;
        if (before->order == e->order && e->order != 1) return VM_TWO_MASS_LAWS;
        if (before->order > e->order) return VM_BAD_ORDER;
    }
    return VM_OK;
}

VM_API int vmi_scene_check_effect(const vm_scene *s, const vm_effect *e)
{
    int k, status = vmi_scene_check_coordinate(s, e->body, e->coordinate);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_coordinate(s, e->other, e->other_coordinate);
    if (status) return status;
    if (!e->apply) return VM_BAD_ARGUMENT;
    if (!(e->motions >> s->bodies[e->body].motion & 1)) return VM_BAD_MOTION;
    if (e->other != VM_GROUND && !(e->other_motions >> s->bodies[e->other].motion & 1)) return VM_BAD_MOTION;
    for (k = 0; k < (int)(sizeof e->p / sizeof *e->p); k++)
        if (!VM_IS_FINITE(e->p[k])) return VM_NOT_FINITE;
    if (e->needs_mass_state && !s->bodies[e->body].mass_is_state) return VM_MASS_IS_NO_STATE;
    return vmi_scene_check_order(s, e);
}

/* A body takes up only what it can move as: on a line or an axle its own kind, a point no spin */
VM_API int vmi_scene_can_jump(int motion, int other)
{
    return motion == other || (other == VM_POINT && motion > VM_AXLE);
}

/* Of what separates: that the body into which it goes can be it */
VM_API int vmi_scene_check_jump(const vm_scene *s, const vm_event *e)
{
    const vm_impulse *j = &e->external;
    int status = vmi_scene_check_coordinate(s, e->jump_body, 0);
    vm_scene_body part;
    if (!status) status = vmi_scene_check_coordinate(s, e->other, 0);
    if (!status && e->jump_body == e->other) status = VM_NO_SUCH_BODY;
    if (status) return status;
    if (!vmi_scene_can_jump(s->bodies[e->jump_body].motion, s->bodies[e->other].motion)) return VM_BAD_MOTION;
    if (!vmi_vec3_finite(j->linear) || !vmi_vec3_finite(j->couple) || !vmi_vec3_finite(j->at)) return VM_NOT_FINITE;
    if (e->jumps < 0) return VM_OK;
    part = s->bodies[e->other], part.start = e->part;
    return vmi_scene_check_body(&part);
}

VM_API int vmi_scene_check_event(const vm_scene *s, const vm_event *e)
{
    int status = VM_OK;
    if (e->watches && (status = vmi_scene_check_coordinate(s, e->body, e->coordinate)) != 0) return status;
    if (!VM_IS_FINITE(e->time) || !VM_IS_FINITE(e->value)) return VM_NOT_FINITE;
    if (!e->then) return VM_BAD_ARGUMENT;
    if (e->switches && (e->effect < 0 || e->effect >= s->n_effects)) return VM_NO_SUCH_EFFECT;
    return e->jumps ? vmi_scene_check_jump(s, e) : status;
}

VM_API int vmi_scene_check_arrays(const vm_scene *s)
{
    int i;
    if (!s || s->n_bodies < 1 || !s->bodies || s->n_effects < 0 || (s->n_effects && !s->effects))
        return VM_BAD_ARGUMENT;
    if (s->n_events < 0 || (s->n_events && (!s->events || !s->located))) return VM_BAD_ARGUMENT;
    if (s->times && s->n_times < 0) return VM_BAD_ARGUMENT;
    for (i = 0; s->times && i < s->n_times; i++) {
        if (!VM_IS_FINITE(s->times[i])) return VM_NOT_FINITE;
        if (i > 0 && !(s->times[i] > s->times[i - 1])) return VM_BAD_ARGUMENT;
    }
    return VM_OK;
}

VM_API int vm_scene_check(const vm_scene *scene, vm_culprit *culprit)
{
    vm_culprit c = {"scene", -1};
    int i, status = vmi_scene_check_arrays(scene);
    if (culprit) *culprit = c;
    if (status) return status;
    for (i = 0; !status && i < scene->n_bodies; i++)
        if ((status = vmi_scene_check_body(scene->bodies + i)) != 0) c.kind = "body", c.index = i;
    for (i = 0; !status && i < scene->n_effects; i++)
        if ((status = vmi_scene_check_effect(scene, scene->effects + i)) != 0) c.kind = "effect", c.index = i;
    for (i = 0; !status && i < scene->n_events; i++)
        if ((status = vmi_scene_check_event(scene, scene->events + i)) != 0) c.kind = "event", c.index = i;
    if (culprit) *culprit = c;
    return status;
}

VM_API vm_real vmi_scene_when(vm_real t, const vm_real *y, void *ctx)
{
    const vm_event *e = (const vm_event *)ctx;
    return e->when ? e->when(e, t, y) : 1;
}

VM_API void vmi_scene_locate(vm_scene *s, int i)
{
    ode_event *located = s->located + i;
    memset(located, 0, sizeof *located);
    located->g = vmi_scene_when;
    located->ctx = s->events + i;
    located->direction = s->events[i].direction;
    located->action = ODE_STOP;
}

VM_API int vm_scene_start(vm_scene *scene, vm_real t, vm_real *y, vm_culprit *culprit)
{
    int i, at = 0, status = vm_scene_check(scene, culprit);
    if (status) return status;
    if (!y) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    for (i = 0; i < scene->n_bodies; i++) {
        vm_scene_body *b = scene->bodies + i;
        b->at = at, b->away = b->absent, b->jumped = 0;
        at += vmi_scene_body_size(b);
        vmi_scene_put(scene, i, &b->start, b->angle, y);
    }
    for (i = 0; i < scene->n_effects; i++) scene->effects[i].idle = scene->effects[i].off != 0;
    for (i = 0; i < scene->n_events; i++) {
        vm_event *e = scene->events + i;
        e->scene = scene, e->count = e->seen = 0;
        if (e->when) e->time = t;
        vmi_scene_locate(scene, i);
    }
    vmi_scene_presence(scene);
    vmi_scene_load(scene, t, y);
    scene->status = VM_OK;
    if (scene->book) scene->book->open(scene, y, y + at);
    return VM_OK;
}

/* ---- Scenes: events ----------------------------------------------------------------------------------------- */

VM_API vm_event vmi_event(int body, int coordinate, vm_real value, int direction)
{
    vm_event e;
    memset(&e, 0, sizeof e);
    e.body = body, e.coordinate = coordinate, e.value = value, e.direction = direction;
    e.watches = 1;
    return e;
}

VM_API vm_event vm_event_at(vm_real time)
{
    vm_event e = vmi_event(0, 0, 0, 0);
    e.time = time, e.watches = 0, e.most = 1;
    return e;
}

VM_API vm_real vmi_when_position(const vm_event *e, vm_real t, const vm_real *y)
{
    (void)t;
    return vmi_scene_x(e->scene, y, e->body, e->coordinate) - e->value;
}

VM_API vm_event vm_event_position(int body, int coordinate, vm_real value, int direction)
{
    vm_event e = vmi_event(body, coordinate, value, direction);
    e.when = vmi_when_position;
    return e;
}

VM_API vm_real vmi_when_velocity(const vm_event *e, vm_real t, const vm_real *y)
{
    (void)t;
    return vmi_scene_v(e->scene, y, e->body, e->coordinate) - e->value;
}

VM_API vm_event vm_event_velocity(int body, int coordinate, vm_real value, int direction)
{
    vm_event e = vmi_event(body, coordinate, value, direction);
    e.when = vmi_when_velocity;
    return e;
}

VM_API vm_real vmi_when_mass(const vm_event *e, vm_real t, const vm_real *y)
{
    const vm_scene_body *b = e->scene->bodies + e->body;
    if (b->mass_is_state) return y[b->at + vmi_scene_mass_at(b)] - e->value;
    vmi_scene_load(e->scene, t, y);
    return b->load.mass - e->value;
}

VM_API vm_event vm_event_mass(int body, vm_real value, int direction)
{
    vm_event e = vmi_event(body, 0, value, direction);
    e.when = vmi_when_mass;
    return e;
}

VM_API vm_real vmi_when_user(const vm_event *e, vm_real t, const vm_real *y) { return e->user_when(t, y, e->ctx); }

VM_API vm_event vm_event_user(vm_real (*when)(vm_real t, const vm_real *y, void *ctx), void *ctx, int direction)
{
    vm_event e = vmi_event(0, 0, 0, direction);
    e.watches = 0;
    e.when = when ? vmi_when_user : NULL;
    e.user_when = when, e.ctx = ctx;
    if (!when) e.time = VM_NAN; /* which vm_scene_check refuses */
    return e;
}

VM_API int vmi_then_stop(vm_event *e, vm_real t, vm_real *y)
{
    (void)e, (void)t, (void)y;
    return VM_STOPPED;
}

VM_API vm_event vm_then_stop(vm_event event)
{
    event.then = vmi_then_stop;
    return event;
}

VM_API int vmi_then_switch(vm_event *e, vm_real t, vm_real *y)
{
    vm_effect *effect = e->scene->effects + e->effect;
    (void)t, (void)y;
    effect->idle = (effect->idle & 2) | e->off;
    return VM_OK;
}

VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    event.then = vmi_then_switch;
    event.effect = effect, event.off = off != 0, event.switches = 1;
    return event;
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = then ? vmi_then_user : NULL;
    event.user_then = then, event.then_ctx = ctx;
    return event;
}

/* On a line or an axle a jump is one of a single number: (M v + sign m v2 + impulse)/(M + sign m) */
VM_API int vmi_scene_jump_line(const vm_body *body, const vm_body *other, vm_real sign, vm_real impulse, vm_body *b)
{
    *b = *body;
    b->mass = body->mass + sign * other->mass;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    b->v.x = (body->mass * body->v.x + sign * other->mass * other->v.x + impulse) / b->mass;
    b->r.x = body->r.x + sign * other->mass / b->mass * (other->r.x - body->r.x);
    return VM_OK;
}

/* The angle of a body in the plane or on an axle, which may be more than a turn */
VM_API vm_real vmi_scene_angle(const vm_scene *s, int body, const vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    return b->motion == VM_PLANE ? y[b->at + 2] : y[b->at];
}

VM_API vm_body2 vmi_scene_flat(const vm_body *b)
{
    vm_body2 flat;
    flat.mass = b->mass, flat.inertia = b->inertia.zz;
    flat.x = b->r.x, flat.y = b->r.y, flat.angle = 0;
    flat.vx = b->v.x, flat.vy = b->v.y, flat.omega = b->omega.z;
    return flat;
}

VM_API int vmi_scene_jump_plane(const vm_body *body, const vm_body *other, vm_real sign, const vm_impulse *external,
                                vm_body *b)
{
    const vm_body2 one = vmi_scene_flat(body), two = vmi_scene_flat(other);
    vm_impulse2 blow;
    vm_body2 flat;
    int status;
    blow.jx = external->linear.x, blow.jy = external->linear.y, blow.couple = external->couple.z;
    blow.x = external->at.x, blow.y = external->at.y;
    status = sign < 0 ? vm_separate2(&one, &two, &blow, &flat) : vm_attach2(&one, &two, &blow, &flat);
    if (status < 0) return status;
    *b = *body;
    b->mass = flat.mass, b->inertia.zz = flat.inertia;
    b->r.x = flat.x, b->r.y = flat.y, b->v.x = flat.vx, b->v.y = flat.vy, b->omega.z = flat.omega;
    return flat.inertia > 0 ? VM_OK : VM_BAD_INERTIA; /* a rest that is a point cannot move on as a body */
}

VM_API int vmi_scene_jump_axle(const vm_body *body, const vm_body *other, vm_real sign, vm_real impulse, vm_body *b)
{
    vm_body p = *body, q = *other; /* angular velocities by way of v */
    int status;
    p.v.x = p.omega.z, q.v.x = q.omega.z, p.r.x = q.r.x = 0;
    status = vmi_scene_jump_line(&p, &q, sign, impulse, b);
    b->omega.z = b->v.x;
    b->r = body->r, b->v = body->v;
    return status;
}

VM_API int vmi_scene_jump(const vm_event *e, const vm_body *body, const vm_body *other, vm_real sign, vm_body *b)
{
    const vm_impulse *j = &e->external;
    switch (e->scene->bodies[e->jump_body].motion) {
    case VM_LINE: return vmi_scene_jump_line(body, other, sign, j->linear.x, b);
    case VM_AXLE: return vmi_scene_jump_axle(body, other, sign, j->couple.z, b);
    case VM_PLANE: return vmi_scene_jump_plane(body, other, sign, j, b);
    default: return sign < 0 ? vm_separate(body, other, j, b) : vm_attach(body, other, j, b);
    }
}

/* The body moves on as now; its mass by a law has jumped, too */
VM_API void vmi_scene_settle_mass(vm_scene *s, int body, const vm_body *now)
{
    vm_scene_body *b = s->bodies + body;
    b->jumped += now->mass - b->load.mass;
}

VM_API void vmi_scene_jumped(vm_event *e, vm_real t, vm_real *y, int into_is_new, const vm_body *b,
                             const vm_body *other)
{
    vm_scene *s = e->scene;
    vm_book before, after;
    const vm_real angle = vmi_scene_angle(s, e->jump_body, y);
    if (s->book) s->book->totals(s, y, &before);
    s->bodies[e->other].away = !into_is_new;
    if (into_is_new) vmi_scene_put(s, e->other, other, angle + s->bodies[e->other].angle, y);
    vmi_scene_put(s, e->jump_body, b, angle, y);
    vmi_scene_presence(s);
    vmi_scene_load(s, t, y);
    vmi_scene_settle_mass(s, e->jump_body, b);
    if (into_is_new) vmi_scene_settle_mass(s, e->other, other);
    vmi_scene_load(s, t, y);
    if (!s->book) return;
    s->book->totals(s, y, &after);
    s->book->jump_energy += after.energy - before.energy;
    s->book->impulse = vmi_add(s->book->impulse, e->external.linear);
    s->book->angular_impulse = vmi_add(s->book->angular_impulse,
                                       vmi_add(e->external.couple, vmi_cross(e->external.at, e->external.linear)));
}

VM_API int vmi_then_separate(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, part = e->part, rest;
    int status;
    if (!e->scene->bodies[e->other].away || e->scene->bodies[e->jump_body].away) return VM_NO_SUCH_BODY;
    vmi_scene_load(e->scene, t, y);
    vm_scene_body_at(e->scene, e->jump_body, y, &body);
    if (e->relative) {
        const vmi_mat3 turn = vmi_rotation(body.q);
        const int as_body = part.q.w == 0 && part.q.x == 0 && part.q.y == 0 && part.q.z == 0;
        const vm_vec3 d = vmi_times(&turn, part.r);
        part.r = vmi_add(body.r, d);
        part.v = vmi_add(vmi_times(&turn, part.v), vmi_add(body.v, vmi_cross(body.omega, d)));
        part.omega = vmi_add(vmi_times(&turn, part.omega), body.omega);
        part.q = as_body ? body.q : vmi_quat_times(body.q, part.q);
    }
    status = vmi_scene_jump(e, &body, &part, -1, &rest);
    if (status < 0) return status;
    vmi_scene_jumped(e, t, y, 1, &rest, &part);
    return VM_OK;
}

VM_API vm_event vm_then_separate(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event.then = part ? vmi_then_separate : NULL;
    event.jump_body = body, event.other = into, event.jumps = 1, event.relative = relative;
    if (part) event.part = *part;
    return event;
}

VM_API int vmi_then_attach(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, added, whole;
    int status;
    if (e->scene->bodies[e->other].away || e->scene->bodies[e->jump_body].away) return VM_NO_SUCH_BODY;
    vmi_scene_load(e->scene, t, y);
    vm_scene_body_at(e->scene, e->jump_body, y, &body);
    vm_scene_body_at(e->scene, e->other, y, &added);
    status = vmi_scene_jump(e, &body, &added, 1, &whole);
    if (status < 0) return status;
    vmi_scene_jumped(e, t, y, 0, &whole, NULL);
    return VM_OK;
}

VM_API vm_event vm_then_attach(vm_event event, int body, int added)
{
    event.then = vmi_then_attach;
    event.jump_body = body, event.other = added, event.jumps = -1;
    return event;
}

/* ---- Scenes: runs ------------------------------------------------------------------------------------------- */

/* The next time at which an event is due, or limit */
VM_API vm_real vmi_scene_due(const vm_scene *s, vm_real limit)
{
    int i;
    for (i = 0; i < s->n_events; i++) {
        const vm_event *e = s->events + i;
        if (!e->when && e->count == 0 && e->time < limit) limit = e->time;
    }
    return limit;
}

/* How events follow one another in a run */
typedef struct VM_TAG(vmi_scene_pace) {
    long happened; /* events at this instant */
    vm_real gap;   /* the shortest time since a crossing at this instant happened before, VM_MAX without one */
    int crowded;   /* so many instants one after another with a gap that the time hardly resolves */
} vmi_scene_pace;

/* What has happened at t happens to y: events at this time, and those that the integrator has counted anew; in the
   order of the events */
VM_API int vmi_scene_happen(vm_scene *s, vm_real t, vm_real *y, vmi_scene_pace *pace)
{
    int i, status = VM_OK;
    for (i = 0; i < s->n_events && status >= 0; i++) {
        vm_event *e = s->events + i;
        const int now = e->when ? s->located[i].count > e->seen : e->count == 0 && e->time <= t;
        int result;
        if (e->when) e->seen = s->located[i].count;
        if (!now || (e->most && e->count >= e->most)) continue;
        if (e->when && e->count && t - e->time < pace->gap) pace->gap = t - e->time;
        if (e->when) e->time = t;
        e->count++, pace->happened++;
        result = e->then(e, t, y);
        if (result < 0 || status == VM_OK) status = result;
    }
    return status;
}

/* All events of an instant, since events may cause events. Events that follow one another faster and faster, as the
   contacts of a ball that comes to rest, are the end of the run where the time no longer resolves them; until then
   the step after such an event is short enough to see the next. */
VM_API int vmi_scene_settle(vm_scene *s, rk45 *r, vm_real span, vmi_scene_pace *pace)
{
    const long most = 10000; /* at one instant */
    const vm_real resolved = 256 * VM_EPSILON * span;
    long before = -1;
    int status = VM_OK;
    for (pace->happened = 0, pace->gap = VM_MAX; pace->happened != before && status == VM_OK;) {
        before = pace->happened;
        status = vmi_scene_happen(s, r->t, r->y, pace);
        if (pace->happened == before) break;
        if (rk45_restart(r, r->t, r->y) < 0 && status >= 0) status = VM_NOT_FINITE;
        if (pace->happened > most && status >= 0) status = VM_TOO_MANY_EVENTS;
    }
    if (pace->gap == VM_MAX) return status;
    pace->crowded = pace->gap < resolved ? pace->crowded + 1 : 0;
    if (pace->crowded > 3 && status == VM_OK) status = VM_TOO_MANY_EVENTS;
    if (r->h > pace->gap / 32) r->h = pace->gap > resolved ? pace->gap / 32 : resolved / 32;
    return status;
}

VM_API int vmi_scene_output(vm_scene *s, vm_real t, const vm_real *y, int *next)
{
    if (!s->output) return VM_OK;
    if (s->times) {
        if (*next >= s->n_times || t < s->times[*next]) return VM_OK;
        while (*next < s->n_times && s->times[*next] <= t) ++*next;
    }
    vmi_scene_load(s, t, y);
    return s->output(t, y, s, s->output_ctx) ? VM_STOPPED : VM_OK;
}

/* One step, or up to the next time at which something is due */
VM_API int vmi_scene_step(vm_scene *s, rk45 *r, vm_real t_end, int next)
{
    const int output = s->output && s->times && next < s->n_times && s->times[next] < t_end;
    const vm_real stop = vmi_scene_due(s, output ? s->times[next] : t_end);
    const int ode = vmi_run(r, VMI_RK45, vm_scene_rhs, r->n, stop, 1);
    if (ode >= 0) return VM_OK;
    s->ode_status = ode;
    return s->status ? s->status : (int)VM_NOT_INTEGRATED;
}

/* rk45 on the scene. Each number of the state has its tolerance, the book none: it follows the bodies' steps. */
VM_API int vmi_scene_integrator(vm_scene *s, rk45 *r, vm_real t, const vm_real *y, vm_real *work,
                                const rk45_options *options_or_NULL)
{
    rk45_options o = rk45_defaults(options_or_NULL);
    const int n = vm_scene_size(s), booked = s->book ? VM_BOOK : 0;
    vm_real *atol = work + RK45_WORK(n);
    int i;
    for (i = 0; i < n; i++) atol[i] = i >= n - booked ? VM_MAX : o.atol_each ? o.atol_each[i] : o.atol;
    o.atol_each = atol;
    o.events = s->located, o.n_events = s->n_events;
    s->ode_status = rk45_init(r, vm_scene_rhs, s, n, t, y, &o, work);
    r->attempts = o.max_steps;
    return s->ode_status < 0 ? (int)VM_NOT_INTEGRATED : (int)VM_OK;
}

VM_API int vm_scene_run(vm_scene *scene, vm_real *t, vm_real t_end, vm_real *y, vm_real *work,
                        const rk45_options *options_or_NULL)
{
    vmi_scene_pace pace = {0, 0, 0};
    int next = 0, status;
    vm_real span;
    rk45 r;
    if (!scene || !t || !y || !work || !(t_end >= *t)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(*t) || !VM_IS_FINITE(t_end)) return VM_NOT_FINITE;
    status = vmi_scene_integrator(scene, &r, *t, y, work, options_or_NULL);
    if (status) return status;
    span = VM_FABS(*t) > VM_FABS(t_end) ? VM_FABS(*t) : VM_FABS(t_end);
    while (scene->times && next < scene->n_times && scene->times[next] < *t) next++;
    for (;;) {
        status = vmi_scene_settle(scene, &r, span, &pace);
        if (status == VM_OK) status = vmi_scene_output(scene, r.t, r.y, &next);
        if (status != VM_OK || r.t == t_end) break;
        status = vmi_scene_step(scene, &r, t_end, next);
        if (status != VM_OK) break;
    }
    *t = r.t;
    vmi_copy(r.n, r.y, y);
    vmi_scene_load(scene, *t, y);
    return status;
}

#endif
