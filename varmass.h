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
    VM_DOMAIN = -6        /* a parameter outside its domain */
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

/* A disc on an elastic shaft without mass, turned by a torque against viscous damping, in the plane. The shaft goes
   through the mass centre of the whole (s = 0) and passes the remainder's at distance s: at r + s (cos psi, sin psi).
   Its state is y[6] = {x, y, psi, x', y', psi'} as rk45 takes it: mass centre from where the shaft is at rest (m),
   angle (rad), rates. In the notation of (67): omega^2 = stiffness/mass, p^2 = mass/inertia,
   k* = damping/inertia, M* = torque/inertia. */
typedef struct VM_TAG(vm_rotor) {
    vm_real mass;      /* kg, > 0 */
    vm_real inertia;   /* about the own mass centre, kg m^2, > 0 */
    vm_real stiffness; /* c of the shaft, N/m, >= 0 */
    vm_real damping;   /* k, N m s */
    vm_real torque;    /* N m */
    vm_real s;         /* m */
} vm_rotor;

/* (65), (66), (68), and (46) for s = 0, as an ode_rhs for n = 6; rotor points at a vm_rotor */
VM_API int vm_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);

/* State at t after start by (46)-(51), exact; VM_DOMAIN unless s = 0. damping and stiffness may be 0; end may be
   start, here and below. Error: no more than the rounding of every input, t included, would do. */
VM_API int vm_rotor_free(vm_real t, const vm_rotor *rotor, const vm_real *start, vm_real *end);
/* A0, B0, C0, D0 (51), m, of x + i y = (A0 + i B0) exp(i w t) + (C0 + i D0) exp(-i w t) (50), w^2 = stiffness/mass,
   not 0. The orbit's half axes are | |A0 + i B0| +- |C0 + i D0| |. The speed at t, wrong after (52), is
     w sqrt(A0^2 + B0^2 + C0^2 + D0^2 - 2 (A0 C0 + B0 D0) cos 2 w t + 2 (B0 C0 - A0 D0) sin 2 w t) */
VM_API int vm_rotor_orbit(const vm_rotor *rotor, const vm_real *start, vm_real *abcd);

/* The break, (52)-(64) corrected: the whole touches the stator at A and loses a piece, of which A keeps its velocity
   while S2 loses that across S2A (57). This is an assumption of [1]; everything else follows by momenta. */
typedef struct VM_TAG(vm_rotor_piece) {
    vm_real mass, inertia; /* m; I_S2 about the own mass centre S2, >= 0 */
    vm_real distance;      /* SS2, m */
    vm_real alpha;         /* angle from SS2 to SA, counterclockwise (Fig. 17: S2 at -alpha from SA) */
    vm_real radius;        /* SA, m */
    vm_real contact;       /* direction angle of SA in inertial axes */
} vm_rotor_piece;
typedef struct VM_TAG(vm_rotor_break) {
    vm_rotor rest;      /* the remainder: I_S1 by the parallel axes, s = m SS2/(M - m); the rest is the whole's */
    vm_real state[6];   /* its state, psi being the direction from S1 to the shaft, which is that of SS2 */
    vm_real piece[6];   /* the piece's state, psi likewise */
    vm_real dragging;   /* v_S2d (52), (61): speed of S2 before, and */
    vm_real gamma;      /* its angle from SA (52), (60); both for v_S in any direction */
    vm_real beta;       /* angle of S2A from SA, tan beta = SS2 sin alpha/(R - SS2 cos alpha)  [(56) corrected] */
    vm_real normal;     /* N (54), m/s, along S2A, */
    vm_real tangential; /* T = v_S2d sin(gamma - beta) across it, counterclockwise  [(55) with the other sign] */
    vm_real spin_piece; /* Omega_r = T/AS2 (57), (63) */
    vm_real spin_rest;  /* Omega_r1, from I_S1 Omega_r1 = -I_S2 Omega_r + m M/(M - m) SS2 x v_T  [(58) corrected] */
    vm_real stop_inertia; /* the I_S2 that would stop the rest, where there is one: I_S (R - SS2)/R for alpha = 0
                             [after (64), corrected] */
} vm_rotor_break;
/* The remainder's spin, state[5], is Omega_b + Omega_r1  [(59), (64) corrected]. Refuses m not in (0, M), an I_S1
   that is negative or lost in rounding errors (VM_BAD_INERTIA), a whole with s != 0 and S2 at A (VM_DOMAIN). */
VM_API int vm_rotor_break_off(const vm_rotor *whole, const vm_real *before, const vm_rotor_piece *piece,
                              vm_rotor_break *result);

/* The remainder for short times, |psi| << 1, linearised: (69) complete; and without its term -s y omega^2 p^2,
   which (70)-(72) leave out, though it is of the order of the others. Both for any k*, omega, s, zero included, and
   accurate as vm_rotor_free is (the first to twice that). All of (69) grows exponentially: VM_NOT_FINITE where it
   overflows. */
VM_API int vm_rotor_linear(vm_real t, const vm_rotor *rotor, const vm_real *start, vm_real *end);
VM_API int vm_rotor_linear_uncoupled(vm_real t, const vm_rotor *rotor, const vm_real *start, vm_real *end);

/* Polar form (75), y[6] = {r, phi, psi, r', phi', psi'}; stops the run with VM_DOMAIN at r = 0. The conversions
   refuse r = 0 and r < 0. */
VM_API int vm_rotor_polar_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);
VM_API int vm_rotor_to_polar(const vm_real *y, vm_real *polar);
VM_API int vm_rotor_from_polar(const vm_real *polar, vm_real *y);

/* Steady motion at psi' = Omega, which needs torque = damping Omega (47). r_SS = s omega^2/(omega^2 - Omega^2), m:
   positive as in (77), phi = psi + pi, where Omega^2 < omega^2; negative as in (76), phi = psi. Infinite at resonance
   (NaN for s = 0). Within 2 eps however near resonance is. */
VM_API vm_real vm_rotor_steady(const vm_rotor *rotor, vm_real Omega);
/* Small motions about it, exp(lambda t). (81) corrected (its last term lacks lambda^2) is lambda times the polynomial
     l^5 + k* l^4 + (2 (w^2 + O^2) + G) l^3 + 2 k* (w^2 + O^2) l^2 + (D^2 + G (w^2 + 3 O^2)) l + k* D^2,
   D = w^2 - O^2, G = s^2 p^2 w^4/D: c[6], highest power first. lambda = 0 is the freedom of the phase. */
VM_API int vm_rotor_char_poly(const vm_rotor *rotor, vm_real Omega, vm_real *c);
/* Its five roots, by rising |imaginary part|, pairs as (+, -): each within twice what an eps of every coefficient
   would do, the smallest too, which near resonance is many orders below the largest. VM_DOMAIN at resonance. */
VM_API int vm_rotor_eigenvalues(const vm_rotor *rotor, vm_real Omega, vm_real *re, vm_real *im);
/* Routh's first column 1, k*, G, k* D, 4 G Omega^2, k* D^2 */
VM_API int vm_rotor_routh(const vm_rotor *rotor, vm_real Omega, vm_real *column);
/* 1 where the steady motion is asymptotically stable, exactly Omega^2 < omega^2 (82) with k* > 0, s != 0, Omega != 0;
   else 0 (for k*, s or Omega = 0 some motions neither grow nor fade) */
VM_API int vm_rotor_stable(const vm_rotor *rotor, vm_real Omega);

/* r(t) after a start from rest where Omega = torque/damping is not below omega: psi' is caught at omega, and what the
   torque has left goes into the orbit. r = |s|/4 + R with R R' = k* (Omega - omega)/(2 p^2 omega) + k* |s|/(4 p^2 R),
   R(0) = 0, which changes over from one law to the other,
     R = (3 k* |s| t/(4 p^2))^(1/3) at resonance,  R -> (k* (Omega - omega) t/(p^2 omega))^(1/2) above it.
   s/4 is the next order. Not in it: terms of s^2/r and the time of the capture (Fig. 18 at t = 400: 0.001 of 3.473
   and 0.093 of 12.437 too little and too much). NaN below resonance, for t < 0, k* < 0 and omega = 0. */
VM_API vm_real vm_rotor_growth(vm_real t, const vm_rotor *rotor, vm_real Omega);

/* -- Chapter 4: Lagrange's equations across a jump -- */

/* Generalized coordinates q_i, i < n (or velocities qdot_i that are no derivatives, as those about the axes). A body
   enters by dr[i] = dv/dqdot_i of its mass centre and turn[i] = d omega/dqdot_i, in inertial axes (87)-(90). With
   these each function adds to its last argument: a body's share of the mass matrix (n by n, T = qdot^T matrix
   qdot/2), the generalized momentum of a body (as it moves), the generalized impulse (95) of what acts on a body
   whose mass centre is at r; its moment is that about r, as (23a) should have said. */
VM_API void vm_lagrange_mass(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *matrix);
VM_API void vm_lagrange_momentum(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *p);
VM_API void vm_lagrange_impulse(int n, const vm_impulse *impulse, vm_vec3 r, const vm_vec3 *dr, const vm_vec3 *turn,
                                vm_real *p);

/* (96): d(T2 - T1)/dqdot = impulse, where the part's velocity relative to the body is held while differentiating, so
   that d(T of the part)/dqdot is its generalized momentum part:
     after qdot_after = before qdot - part + impulse    separation
     after qdot_after = before qdot + part + impulse    attachment
   Mass matrices n by n; part and impulse may be null (zero); qdot_after may be qdot. A part of little mass changes
   qdot by little, and that to a few eps of the change. VM_SINGULAR where a coordinate, or several together, move no
   mass: an entry on after's diagonal is not positive, or a pivot below 4 n eps once that is scaled to 1. */
#define VM_LAGRANGE_WORK(n) ((n) * ((n) + 1))
VM_API int vm_lagrange_separate(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                                const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                                vm_real *work);
VM_API int vm_lagrange_attach(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                              const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                              vm_real *work);
/* matrix (qdot_after - qdot) = impulse: no mass changes. Also a separation, free of cancellation for m -> M, where
   matrix is that of the rest and -impulse the momentum of the part's motion relative to the body. */
VM_API int vm_lagrange_hit(int n, const vm_real *matrix, const vm_real *qdot, const vm_real *impulse,
                           vm_real *qdot_after, vm_real *work);

/* Example (119)-(132), corrected: a uniform rod of mass M swings about its end O; the outer length l, and with it
   m = M l/L, leaves at the relative velocity u and angular velocity Omega. */
enum {
    VM_AXES_COS_SIN = 0, /* S2 at (cos, sin) angle: angle from x, counterclockwise; what (122), (125), (132) need */
    VM_AXES_SIN_COS = 1  /* S2 at (sin, cos) angle (123): x across, y along, so that the angle turns clockwise */
};
typedef struct VM_TAG(vm_pendulum) {
    vm_real mass, length; /* M, L > 0 */
    vm_real angle, rate;  /* phi, phi' */
    int axes;
} vm_pendulum;
typedef struct VM_TAG(vm_pendulum_cut) {
    vm_pendulum rest;         /* rest.rate is phi1' */
    vm_real mass;             /* of the part, m */
    vm_real x, y, vx, vy;     /* of S2 (123), (121) */
    vm_real rate;             /* of the part, phi' + Omega; turns as phi does */
    vm_real T1, T_S1, T_S2;   /* kinetic energies (119), (124), (122) corrected, J */
    vm_real L1, L2;           /* angular momenta about O of the rest (130) and the part (128) corrected */
    vm_real pivot_x, pivot_y; /* impulse of the pivot on the rest during the cut, N s */
} vm_pendulum_cut;
/* part is l, 0 < l < L; u in the axes of the pendulum. phi1' = phi' - l/(L - l)^3 (l^2 Omega/4 + 3 s (x u_y - y
   u_x)), s = 1 for (cos, sin), -1 for (sin, cos): (125), (132) corrected, with what cancels cancelled */
VM_API int vm_pendulum_separate(const vm_pendulum *pendulum, vm_real part, vm_real Omega, vm_real ux, vm_real uy,
                                vm_pendulum_cut *cut);

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
    case VM_BAD_ARGUMENT: return "null pointer";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass is not positive";
    case VM_BAD_INERTIA: return "no body has this inertia";
    case VM_SINGULAR: return "linear equations without a unique solution";
    case VM_DOMAIN: return "a parameter outside its domain";
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

/* a x = b, a dense and n by n, row after row, by elimination with row pivoting: x replaces b, a is destroyed but
   for its pivots, which stay on the diagonal. VM_SINGULAR, b destroyed, where a column has no pivot. */
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

/* atan2(y, x), within 2 ulp; 0 for x = y = 0 */
VM_API vm_real vmi_atan2(vm_real y, vm_real x)
{
    vm_real angle = x == 0 && y == 0 ? 0 : vmi_arctan(VM_FABS(y), VM_FABS(x));
    if (x < 0) angle = VM_PI - angle;
    return VM_COPYSIGN(angle, y);
}

/* sqrt(x^2 + y^2), within 2 ulp, where the squares overflow too */
VM_API vm_real vmi_hypot(vm_real x, vm_real y)
{
    const vm_real a = VM_FABS(x), b = VM_FABS(y), most = a > b ? a : b, least = a > b ? b : a;
    const vm_real q = most > 0 ? least / most : 0;
    return most * VM_SQRT(1 + q * q);
}

/* A result of n numbers, where all are finite */
VM_API int vmi_deliver(int n, const vm_real *from, vm_real *to)
{
    if (!vmi_all_finite(n, from)) return VM_NOT_FINITE;
    memcpy(to, from, (size_t)n * sizeof *to);
    return VM_OK;
}

typedef struct VM_TAG(vmi_complex) {
    vm_real re, im;
} vmi_complex;

VM_API vmi_complex vmi_complex_of(vm_real re, vm_real im)
{
    vmi_complex z;
    z.re = re, z.im = im;
    return z;
}

VM_API vmi_complex vmi_complex_times(vmi_complex a, vmi_complex b)
{
    return vmi_complex_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

/* a/b by Smith's method, where b.re^2 + b.im^2 may underflow */
VM_API vmi_complex vmi_complex_over(vmi_complex a, vmi_complex b)
{
    vm_real q, d;
    if (VM_FABS(b.re) < VM_FABS(b.im)) {
        q = b.re / b.im, d = b.im + b.re * q;
        return vmi_complex_of((a.re * q + a.im) / d, (a.im * q - a.re) / d);
    }
    q = b.im / b.re, d = b.re + b.im * q;
    return vmi_complex_of((a.re + a.im * q) / d, (a.im - a.re * q) / d);
}

/* The step of z = (re[i], im[i]) towards a root of c[0] z^n + ... + c[n], which the other approximations repel:
   p/p' of p over the product of the z - z_j (Ehrlich, Aberth). 0 where p is within its rounding errors of 0. */
VM_API vmi_complex vmi_poly_step(int n, const vm_real *c, const vm_real *re, const vm_real *im, int i)
{
    const vmi_complex z = vmi_complex_of(re[i], im[i]), one = vmi_complex_of(1, 0);
    const vm_real modulus = vmi_hypot(z.re, z.im);
    vmi_complex p = vmi_complex_of(c[0], 0), slope = vmi_complex_of(0, 0), others = slope;
    vm_real size = VM_FABS(c[0]);
    int j;
    for (j = 1; j <= n; j++) {
        const vmi_complex q = vmi_complex_times(slope, z);
        slope = vmi_complex_of(q.re + p.re, q.im + p.im);
        p = vmi_complex_times(p, z);
        p.re += c[j];
        size = size * modulus + VM_FABS(c[j]);
    }
    if (VM_FABS(p.re) + VM_FABS(p.im) <= VM_EPSILON * size) return vmi_complex_of(0, 0);
    for (j = 0; j < n; j++) {
        const vmi_complex apart = vmi_complex_of(z.re - re[j], z.im - im[j]);
        vmi_complex share;
        if (j == i || (apart.re == 0 && apart.im == 0)) continue;
        share = vmi_complex_over(one, apart);
        others.re += share.re, others.im += share.im;
    }
    others = vmi_complex_times(p, others);
    return vmi_complex_over(p, vmi_complex_of(slope.re - others.re, slope.im - others.im));
}

VM_API int vmi_poly_root_is_real(int n, const vm_real *c, vm_real x)
{
    vm_real p = c[0], size = VM_FABS(c[0]);
    int j;
    for (j = 1; j <= n; j++) p = p * x + c[j], size = size * VM_FABS(x) + VM_FABS(c[j]);
    return VM_FABS(p) <= (vm_real)(4 * n) * VM_EPSILON * size;
}

VM_API void vmi_poly_swap(vm_real *re, vm_real *im, int i, int j)
{
    const vm_real x = re[i], y = im[i];
    re[i] = re[j], im[i] = im[j];
    re[j] = x, im[j] = y;
}

/* Makes what rounding left of an imaginary part 0, and conjugate the others by twos: im > 0, then im < 0; by rising
   |im|, real ones by falling re */
VM_API void vmi_poly_order(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const vm_real near = 16 * VM_SQRT(VM_EPSILON); /* a double real root comes out as two this far apart */
    int i, j, k;
    for (i = 0; i < n; i++) {
        if (VM_FABS(im[i]) <= near * VM_FABS(re[i]) && vmi_poly_root_is_real(n, c, re[i])) im[i] = 0;
        for (j = i; j > 0; j--) {
            const vm_real rise = VM_FABS(im[j]) - VM_FABS(im[j - 1]);
            if (rise > 0 || (rise == 0 && re[j] <= re[j - 1])) break;
            vmi_poly_swap(re, im, j, j - 1);
        }
    }
    for (i = 0; i < n && im[i] == 0;) i++;
    if ((n - i) % 2) im[i++] = 0;
    for (; i < n; i += 2) {
        for (j = k = i + 1; k < n; k++)
            if (VM_FABS(re[k] - re[i]) + VM_FABS(im[k] + im[i]) < VM_FABS(re[j] - re[i]) + VM_FABS(im[j] + im[i]))
                j = k;
        vmi_poly_swap(re, im, i + 1, j);
        re[i] = re[i + 1] = (re[i] + re[i + 1]) / 2;
        im[i] = (VM_FABS(im[i]) + VM_FABS(im[i + 1])) / 2;
        im[i + 1] = -im[i];
    }
}

/* The roots of c[0] z^n + ... + c[n], c[0] != 0, simple ones each to a few n eps times its condition number */
VM_API void vmi_poly_roots(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const int most_sweeps = 100;
    int i, sweep, moving = 1, m = n;
    while (m > 0 && c[m] == 0) m--, re[m] = im[m] = 0;
    for (i = 0; i < m; i++) /* not symmetric about the real axis, which no step would then leave */
        vmi_sincos(VM_C(0.4) + 2 * VM_PI * (vm_real)i / (vm_real)m, &im[i], &re[i]);
    for (sweep = 0; sweep < most_sweeps && moving; sweep++) {
        for (moving = i = 0; i < m; i++) {
            const vmi_complex step = vmi_poly_step(m, c, re, im, i);
            re[i] -= step.re, im[i] -= step.im;
            moving += VM_FABS(step.re) + VM_FABS(step.im) > VM_EPSILON * (VM_FABS(re[i]) + VM_FABS(im[i]));
        }
    }
    vmi_poly_order(n, c, re, im);
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

VM_API int vmi_check_rotor(const vm_rotor *r)
{
    if (!VM_IS_FINITE(r->mass) || !VM_IS_FINITE(r->inertia) || !VM_IS_FINITE(r->stiffness) ||
        !VM_IS_FINITE(r->damping) || !VM_IS_FINITE(r->torque) || !VM_IS_FINITE(r->s))
        return VM_NOT_FINITE;
    if (!(r->mass > 0)) return VM_BAD_MASS;
    if (!(r->inertia > 0)) return VM_BAD_INERTIA;
    return r->stiffness >= 0 ? VM_OK : VM_DOMAIN;
}

VM_API int vm_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    const vm_rotor *r = (const vm_rotor *)rotor;
    vm_real sine, cosine, fx, fy;
    (void)t;
    vmi_sincos(y[2], &sine, &cosine);
    fx = -r->stiffness * (y[0] + r->s * cosine), fy = -r->stiffness * (y[1] + r->s * sine); /* (66) */
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    dydt[3] = fx / r->mass, dydt[4] = fy / r->mass;
    dydt[5] = (r->torque - r->damping * y[5] + r->s * (cosine * fy - sine * fx)) / r->inertia;
    return 0;
}

/* (67), and the coupling s p^2 omega^2 of (69) */
typedef struct VM_TAG(vmi_rotor_linear) {
    vm_real omega, k, torque, s, coupling;
} vmi_rotor_linear;

VM_API vmi_rotor_linear vmi_rotor_reduced(const vm_rotor *r, int coupled)
{
    vmi_rotor_linear a;
    a.omega = VM_SQRT(r->stiffness / r->mass);
    a.k = r->damping / r->inertia, a.torque = r->torque / r->inertia, a.s = r->s;
    a.coupling = coupled ? r->s * (r->stiffness / r->inertia) : 0;
    return a;
}

/* What z = y, psi, y', psi' of (69) changes by within h, by the series in t, for |h| times vmi_rotor_rate at most
   1: the n-th terms of y and of s psi are then below 1/n! of the first ones */
VM_API void vmi_rotor_series(const vmi_rotor_linear *a, vm_real h, const vm_real *z, vm_real *change)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    const vm_real omega_h2 = (a->omega * h) * (a->omega * h), k_h = a->k * h, coupling_h2 = a->coupling * h * h;
    vm_real y0 = z[0], psi0 = z[1], y1 = z[2] * h, psi1 = z[3] * h, drive = a->torque * h * h;
    int n;
    change[0] = y1, change[1] = psi1, change[2] = change[3] = 0;
    for (n = 2; n < terms && h != 0; n++) {
        const vm_real share = 1 / (vm_real)(n * (n - 1)), y2 = -omega_h2 * (y0 + a->s * psi0) * share;
        const vm_real psi2 = (drive - k_h * (vm_real)(n - 1) * psi1 - coupling_h2 * y0) * share;
        change[0] += y2, change[1] += psi2;
        change[2] += (vm_real)n * y2 / h, change[3] += (vm_real)n * psi2 / h;
        y0 = y1, psi0 = psi1, y1 = y2, psi1 = psi2, drive = 0;
    }
}

VM_API vm_real vmi_rotor_rate(const vmi_rotor_linear *a)
{
    return VM_FABS(a->k) + VM_C(1.5) * a->omega + VM_SQRT(VM_FABS(a->s * a->coupling));
}

/* (e^z - 1)/z and (e^z - 1 - z)/z^2, to a few eps */
VM_API void vmi_rotor_exp_quotients(vm_real z, vm_real *phi1, vm_real *phi2)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    int n;
    if (VM_FABS(z) > 1) {
        *phi1 = (vmi_exp(z, 0) - 1) / z;
        *phi2 = (*phi1 - 1) / z;
        return;
    }
    *phi2 = 0;
    for (n = terms; n >= 2; n--) *phi2 = (1 + z * *phi2) / (vm_real)n;
    *phi1 = 1 + z * *phi2;
}

/* w - sin w, given sin w */
VM_API vm_real vmi_rotor_less_sine(vm_real w, vm_real sine)
{
    const int terms = VM_MANT_DIG > 24 ? 19 : 11;
    vm_real sum = 0;
    int n;
    if (VM_FABS(w) > 1) return w - sine;
    for (n = terms; n >= 3; n -= 2) sum = w * w * (1 - sum) / (vm_real)(n * (n - 1));
    return w * sum;
}

/* cos wt, 1 - cos wt, w sin wt, sin wt/w, t - sin wt/w */
typedef struct VM_TAG(vmi_rotor_swing) {
    vm_real c, c1, w_s, s_w, late;
} vmi_rotor_swing;

VM_API vmi_rotor_swing vmi_rotor_swing_at(vm_real t, vm_real w)
{
    vmi_rotor_swing g;
    vm_real half, sine;
    vmi_sincos(w * t / 2, &half, &g.c);
    vmi_sincos(w * t, &sine, &g.c);
    g.c1 = 2 * half * half;
    g.w_s = w * sine;
    g.s_w = w > 0 ? sine / w : t;
    g.late = w > 0 ? vmi_rotor_less_sine(w * t, sine) / w : 0;
    return g;
}

/* (71), (72) with M* in the place of k* Omega, for z = y, psi, y', psi' and |t| times the rate of 1 and more. y
   answers to -s psi, and psi = psi0 + psi0' E1 + M* E2, E1 = (1 - e^(-kt))/k, E2 = (t - E1)/k. g0, g1, g2 solve g''
   + w^2 g = w^2 E1', w^2 E1, w^2 E2 from rest, so that g2' = g1 and g1' = g0. */
VM_API void vmi_rotor_follow(vm_real t, const vmi_rotor_linear *a, const vmi_rotor_swing *g, vm_real *z)
{
    const vm_real w2 = a->omega * a->omega, sum = w2 + a->k * a->k;
    const vm_real y0 = z[0], psi0 = z[1], v0 = z[2], rate0 = z[3];
    vm_real E0, E1, E2, g0, g1, g2;
    vmi_rotor_exp_quotients(-a->k * t, &E1, &E2);
    E0 = vmi_exp(-a->k * t, 0), E1 *= t, E2 *= t * t;
    g0 = w2 * ((E0 - g->c) + a->k * g->s_w) / sum;
    g1 = (w2 * (E1 - g->s_w) + a->k * g->c1) / sum;
    g2 = (w2 * E2 + (a->k * g->late - g->c1)) / sum;
    z[0] = y0 * g->c + v0 * g->s_w - a->s * (psi0 * g->c1 + (rate0 * g1 + a->torque * g2));
    z[1] = psi0 + (rate0 * E1 + a->torque * E2);
    z[2] = v0 * g->c - y0 * g->w_s - a->s * (psi0 * g->w_s + (rate0 * g0 + a->torque * g1));
    z[3] = rate0 * E0 + a->torque * E1;
}

/* z changes by M (z, 1), M = [exp(A t) - E | answer to the torque]: doubled from where the series holds, by
   2 M + M M, which keeps the digits that E would swallow */
VM_API void vmi_rotor_double(vm_real t, const vmi_rotor_linear *a, vm_real *z)
{
    vm_real m[5][4], old[5][4], unit[4], h = t; /* m[j]: of the unit state j, of the torque for j = 4 */
    vmi_rotor_linear driven = *a;
    int doublings = 0, i, j, k;
    for (; VM_FABS(h) * vmi_rotor_rate(a) > 1; h /= 2) doublings++;
    if (doublings == 0) {
        vmi_rotor_series(a, h, z, unit);
        for (i = 0; i < 4; i++) z[i] += unit[i];
        return;
    }
    for (j = 0; j < 5; j++) {
        for (i = 0; i < 4; i++) unit[i] = i == j;
        driven.torque = j < 4 ? 0 : a->torque;
        vmi_rotor_series(&driven, h, unit, m[j]);
    }
    for (; doublings > 0; doublings--) {
        memcpy(old, m, sizeof m);
        for (j = 0; j < 5; j++)
            for (i = 0; i < 4; i++)
                for (m[j][i] *= 2, k = 0; k < 4; k++) m[j][i] += old[k][i] * old[j][k];
    }
    memcpy(unit, z, sizeof unit);
    for (i = 0; i < 4; i++) {
        vm_real change = m[4][i];
        for (j = 0; j < 4; j++) change += m[j][i] * unit[j];
        z[i] += change;
    }
}

VM_API int vmi_rotor_linearised(vm_real t, const vm_rotor *rotor, const vm_real *start, int coupled, vm_real *end)
{
    vm_real y[6], z[4];
    vmi_rotor_linear a;
    vmi_rotor_swing g;
    int status;
    if (!rotor || !start || !end) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_all_finite(6, start)) return VM_NOT_FINITE;
    status = vmi_check_rotor(rotor);
    if (status) return status;
    a = vmi_rotor_reduced(rotor, coupled);
    g = vmi_rotor_swing_at(t, a.omega);
    z[0] = start[1], z[1] = start[2], z[2] = start[4], z[3] = start[5];
    if (coupled || VM_FABS(t) * vmi_rotor_rate(&a) <= 1) vmi_rotor_double(t, &a, z);
    else vmi_rotor_follow(t, &a, &g, z);
    y[0] = start[0] * g.c + (start[3] * g.s_w - a.s * g.c1); /* (70) */
    y[3] = start[3] * g.c - g.w_s * (start[0] + a.s);
    y[1] = z[0], y[2] = z[1], y[4] = z[2], y[5] = z[3];
    return vmi_deliver(6, y, end);
}

VM_API int vm_rotor_linear(vm_real t, const vm_rotor *rotor, const vm_real *start, vm_real *end)
{
    return vmi_rotor_linearised(t, rotor, start, 1, end);
}

VM_API int vm_rotor_linear_uncoupled(vm_real t, const vm_rotor *rotor, const vm_real *start, vm_real *end)
{
    return vmi_rotor_linearised(t, rotor, start, 0, end);
}

/* With s = 0 the uncoupled equations are (46) itself. */
VM_API int vm_rotor_free(vm_real t, const vm_rotor *rotor, const vm_real *start, vm_real *end)
{
    if (rotor && rotor->s != 0) return rotor->s - rotor->s == 0 ? VM_DOMAIN : VM_NOT_FINITE;
    return vmi_rotor_linearised(t, rotor, start, 0, end);
}

VM_API int vm_rotor_orbit(const vm_rotor *rotor, const vm_real *start, vm_real *abcd)
{
    vm_real w, vx, vy, c[4];
    int status;
    if (!rotor || !start || !abcd) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, start)) return VM_NOT_FINITE;
    status = vmi_check_rotor(rotor);
    if (!status && rotor->stiffness == 0) status = VM_DOMAIN;
    if (status) return status;
    w = VM_SQRT(rotor->stiffness / rotor->mass), vx = start[3] / w, vy = start[4] / w;
    c[0] = (start[0] + vy) / 2, c[1] = (start[1] - vx) / 2;
    c[2] = (start[0] - vy) / 2, c[3] = (start[1] + vx) / 2;
    return vmi_deliver(4, c, abcd);
}

/* -- The break, in axes along SA and counterclockwise across it -- */

VM_API int vmi_check_piece(const vm_rotor *whole, const vm_rotor_piece *p)
{
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->inertia) || !VM_IS_FINITE(p->distance) ||
        !VM_IS_FINITE(p->alpha) || !VM_IS_FINITE(p->radius) || !VM_IS_FINITE(p->contact))
        return VM_NOT_FINITE;
    if (!(p->mass > 0 && p->mass < whole->mass)) return VM_BAD_MASS;
    return p->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* (x, y) turned by the angle whose sine and cosine are given */
VM_API void vmi_rotor_turn(vm_real sine, vm_real cosine, vm_real *x, vm_real *y)
{
    const vm_real x0 = *x;
    *x = cosine * x0 - sine * *y;
    *y = sine * x0 + cosine * *y;
}

/* State of a body whose mass centre is at d from S, at angle psi, moving relative to the whole by (ux, uy), spin */
VM_API void vmi_rotor_moved(const vm_real *before, vm_real psi, vm_real dx, vm_real dy, vm_real ux, vm_real uy,
                            vm_real spin, vm_real *state)
{
    state[0] = before[0] + dx, state[1] = before[1] + dy, state[2] = psi;
    state[3] = before[3] - before[5] * dy + ux, state[4] = before[4] + before[5] * dx + uy;
    state[5] = before[5] + spin;
}

/* Mass, inertia and eccentricity of the rest */
VM_API int vmi_rotor_rest(const vm_rotor *whole, const vm_rotor_piece *p, vm_rotor *rest)
{
    const vm_real left = whole->mass - p->mass, share = p->mass / left;
    *rest = *whole;
    rest->mass = left;
    rest->inertia = (whole->inertia - p->inertia) - share * whole->mass * (p->distance * p->distance);
    rest->s = share * p->distance;
    return rest->inertia > 8 * VM_EPSILON * whole->inertia ? VM_OK : VM_BAD_INERTIA;
}

/* (52)-(58), all but rest, state and piece, from SS2 and v_S in axes along SA and counterclockwise across it; e is
   the direction of S2A. Returns AS2. */
VM_API vm_real vmi_rotor_contact(const vm_rotor *whole, const vm_rotor_piece *p, vm_real spin, const vm_real *d,
                                 const vm_real *v, vm_real *e, vm_rotor_break *b)
{
    const vm_real ux = v[0] - spin * d[1], uy = v[1] + spin * d[0], reduced = p->mass / b->rest.mass * whole->mass;
    const vm_real reach_x = p->radius - d[0], reach_y = -d[1], reach = vmi_hypot(reach_x, reach_y);
    vm_real moment; /* SS2 x v_T */
    e[0] = reach_x / reach, e[1] = reach_y / reach;
    b->dragging = vmi_hypot(ux, uy);
    b->gamma = vmi_atan2(uy, ux), b->beta = vmi_atan2(reach_y, reach_x);
    b->normal = ux * e[0] + uy * e[1];
    b->tangential = uy * e[0] - ux * e[1];
    moment = b->tangential * (d[0] * e[0] + d[1] * e[1]);
    b->spin_piece = b->tangential / reach;
    b->spin_rest = (reduced * moment - p->inertia * b->spin_piece) / b->rest.inertia;
    b->stop_inertia = (whole->inertia * spin + reduced * (moment - p->distance * p->distance * spin)) /
                      (spin + b->spin_piece);
    return reach;
}

VM_API int vm_rotor_break_off(const vm_rotor *whole, const vm_real *before, const vm_rotor_piece *piece,
                              vm_rotor_break *result)
{
    vm_rotor_break b;
    vm_real sine, cosine, d[2], v[2], e[2], share, T;
    int status;
    if (!whole || !before || !piece || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_rotor(whole);
    if (!status) status = vmi_all_finite(6, before) ? vmi_check_piece(whole, piece) : VM_NOT_FINITE;
    if (!status && whole->s != 0) status = VM_DOMAIN;
    if (!status) status = vmi_rotor_rest(whole, piece, &b.rest);
    if (status) return status;

    vmi_sincos(piece->alpha, &sine, &cosine);
    d[0] = piece->distance * cosine, d[1] = -piece->distance * sine;
    vmi_sincos(piece->contact, &sine, &cosine);
    v[0] = before[3], v[1] = before[4];
    vmi_rotor_turn(-sine, cosine, &v[0], &v[1]);
    if (!(vmi_rotor_contact(whole, piece, before[5], d, v, e, &b) > 0)) return VM_DOMAIN;

    vmi_rotor_turn(sine, cosine, &d[0], &d[1]);
    vmi_rotor_turn(sine, cosine, &e[0], &e[1]);
    share = piece->mass / b.rest.mass, T = b.tangential;
    vmi_rotor_moved(before, piece->contact - piece->alpha, d[0], d[1], T * e[1], -T * e[0], b.spin_piece, b.piece);
    vmi_rotor_moved(before, piece->contact - piece->alpha, -share * d[0], -share * d[1], -share * T * e[1],
                    share * T * e[0], b.spin_rest, b.state);
    if (!vmi_all_finite(6, b.state) || !vmi_all_finite(6, b.piece)) return VM_NOT_FINITE;
    *result = b;
    return VM_OK;
}

/* -- Polar form -- */

VM_API int vm_rotor_polar_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    const vm_rotor *r = (const vm_rotor *)rotor;
    const vm_real w2 = r->stiffness / r->mass;
    vm_real sine, cosine;
    (void)t;
    if (!(y[0] > 0)) return VM_DOMAIN;
    vmi_sincos(y[1] - y[2], &sine, &cosine);
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5];
    dydt[3] = y[0] * (y[4] * y[4]) - w2 * (y[0] + r->s * cosine);
    dydt[4] = (r->s * w2 * sine - 2 * y[3] * y[4]) / y[0];
    dydt[5] = (r->torque - r->damping * y[5] - r->s * r->stiffness * y[0] * sine) / r->inertia;
    return 0;
}

VM_API int vm_rotor_to_polar(const vm_real *y, vm_real *polar)
{
    vm_real p[6], c, s;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, y)) return VM_NOT_FINITE;
    p[0] = vmi_hypot(y[0], y[1]);
    if (!(p[0] > 0)) return VM_DOMAIN;
    c = y[0] / p[0], s = y[1] / p[0];
    p[1] = vmi_atan2(y[1], y[0]), p[2] = y[2];
    p[3] = c * y[3] + s * y[4], p[4] = (c * y[4] - s * y[3]) / p[0], p[5] = y[5];
    return vmi_deliver(6, p, polar);
}

VM_API int vm_rotor_from_polar(const vm_real *polar, vm_real *y)
{
    vm_real z[6], c, s, across;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, polar)) return VM_NOT_FINITE;
    if (!(polar[0] > 0)) return VM_DOMAIN;
    vmi_sincos(polar[1], &s, &c);
    across = polar[0] * polar[4];
    z[0] = polar[0] * c, z[1] = polar[0] * s, z[2] = polar[2];
    z[3] = polar[3] * c - across * s, z[4] = polar[3] * s + across * c, z[5] = polar[5];
    return vmi_deliver(6, z, y);
}

/* -- The steady motion and its stability -- */

/* (omega^2 - Omega^2) mass, whose sign is right and whose relative error is an eps however near resonance is */
VM_API vm_real vmi_rotor_detuning(const vm_rotor *r, vm_real Omega)
{
    const vm_two load = vmi_two_times(vmi_two_product(Omega, Omega), vmi_two(-r->mass, 0));
    const vm_two left = vmi_two_plus(vmi_two(r->stiffness, 0), load);
    return left.hi + left.lo;
}

VM_API vm_real vm_rotor_steady(const vm_rotor *rotor, vm_real Omega)
{
    if (!rotor || vmi_check_rotor(rotor) || !VM_IS_FINITE(Omega)) return VM_NAN;
    return rotor->s * (rotor->stiffness / vmi_rotor_detuning(rotor, Omega));
}

/* w^2, O^2, k*, D and G of (81) */
typedef struct VM_TAG(vmi_rotor_steady) {
    vm_real w2, O2, k, D, G;
} vmi_rotor_steady;

VM_API int vmi_rotor_about_steady(const vm_rotor *r, vm_real Omega, vmi_rotor_steady *a)
{
    int status;
    vm_real detuning;
    if (!r) return VM_BAD_ARGUMENT;
    status = VM_IS_FINITE(Omega) ? vmi_check_rotor(r) : VM_NOT_FINITE;
    if (status) return status;
    detuning = vmi_rotor_detuning(r, Omega);
    if (detuning == 0) return VM_DOMAIN;
    a->w2 = r->stiffness / r->mass, a->O2 = Omega * Omega, a->k = r->damping / r->inertia;
    a->D = detuning / r->mass;
    a->G = r->s * (r->stiffness / detuning) * (r->s * r->stiffness / r->inertia);
    return VM_OK;
}

VM_API int vm_rotor_char_poly(const vm_rotor *rotor, vm_real Omega, vm_real *c)
{
    vmi_rotor_steady a;
    vm_real p[6];
    int status = c ? vmi_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (status) return status;
    p[0] = 1, p[1] = a.k;
    p[2] = 2 * (a.w2 + a.O2) + a.G, p[3] = 2 * a.k * (a.w2 + a.O2);
    p[4] = a.D * a.D + a.G * (a.w2 + 3 * a.O2), p[5] = a.k * (a.D * a.D);
    return vmi_deliver(6, p, c);
}

VM_API int vm_rotor_routh(const vm_rotor *rotor, vm_real Omega, vm_real *column)
{
    vmi_rotor_steady a;
    vm_real p[6];
    int status = column ? vmi_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (status) return status;
    p[0] = 1, p[1] = a.k, p[2] = a.G;
    p[3] = a.k * a.D, p[4] = 4 * a.G * a.O2, p[5] = a.k * (a.D * a.D);
    return vmi_deliver(6, p, column);
}

VM_API int vm_rotor_stable(const vm_rotor *rotor, vm_real Omega)
{
    if (!rotor || vmi_check_rotor(rotor) || !VM_IS_FINITE(Omega)) return 0;
    return rotor->damping > 0 && rotor->s != 0 && Omega != 0 && vmi_rotor_detuning(rotor, Omega) > 0;
}

/* lambda is measured in size = |Omega| + omega + k* + sqrt|G|, so that no coefficient is above 10. */
VM_API int vm_rotor_eigenvalues(const vm_rotor *rotor, vm_real Omega, vm_real *re, vm_real *im)
{
    vmi_rotor_steady a;
    vm_real c[6], x[5], y[5], size, power;
    int i, status = re && im ? vmi_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (!status) status = vm_rotor_char_poly(rotor, Omega, c);
    if (status) return status;
    size = VM_FABS(Omega) + VM_SQRT(a.w2) + VM_FABS(a.k) + VM_SQRT(VM_FABS(a.G));
    for (i = 1, power = 1 / size; i < 6; i++, power /= size) c[i] *= power;
    if (!vmi_all_finite(6, c)) return VM_NOT_FINITE;
    vmi_poly_roots(5, c, x, y);
    for (i = 0; i < 5; i++) x[i] *= size, y[i] *= size;
    if (!vmi_all_finite(5, x)) return VM_NOT_FINITE;
    status = vmi_deliver(5, y, im);
    if (!status) memcpy(re, x, sizeof x);
    return status;
}

/* ln(1 + x) - x + x^2/2, x >= 0, to a few eps: x^3/3 - x^4/4 ..., by powers of w = x/(2 + x), all terms positive */
VM_API vm_real vmi_rotor_growth_time(vm_real x)
{
    const int terms = VM_MANT_DIG > 24 ? 45 : 21; /* w <= 1/3 */
    const vm_real w = x / (2 + x);
    vm_real sum = 0;
    vm_two l;
    int n;
    if (x > 1) {
        l = vmi_log(1 + x);
        return (l.hi - x) + x * x / 2;
    }
    for (n = terms; n >= 3; n--) sum = w * sum + ((vm_real)(n - 2) + (n & 1 ? 1 / (vm_real)n : 0));
    return 2 * w * w * w * sum;
}

/* r r' = A + B/r gives tau = t A^3/B^2 = ln(1 + x) - x + x^2/2 with x = A r/B: convex, so that Newton's method
   falls to the root from (3 tau)^(1/3) + (2 tau)^(1/2), which is above it. */
VM_API vm_real vmi_rotor_growth_root(vm_real tau)
{
    const int most_steps = 60;
    vm_real x = vmi_raised(3 * tau, VM_C(1.) / 3) + VM_SQRT(2 * tau), fall;
    int i;
    for (i = 0; i < most_steps; i++) {
        fall = (vmi_rotor_growth_time(x) - tau) * (1 + x) / (x * x);
        if (!(fall > 0)) break;
        x -= fall;
    }
    return x;
}

VM_API vm_real vm_rotor_growth(vm_real t, const vm_rotor *rotor, vm_real Omega)
{
    vm_real over, w, A, B, R, z;
    if (!rotor || vmi_check_rotor(rotor) || !(t >= 0) || !VM_IS_FINITE(t) || !VM_IS_FINITE(Omega)) return VM_NAN;
    over = -vmi_rotor_detuning(rotor, Omega), w = VM_SQRT(rotor->stiffness / rotor->mass);
    if (!(over >= 0) || !(w > 0) || !(rotor->damping >= 0)) return VM_NAN;
    A = rotor->damping * (over / rotor->mass / (VM_FABS(Omega) + w)) / (2 * rotor->mass * w);
    B = rotor->damping * VM_FABS(rotor->s) / (4 * rotor->mass);
    R = vmi_raised(3 * B * t, VM_C(1.) / 3);
    if (A == 0 || t == 0) return VM_FABS(rotor->s) / 4 + R;
    z = A * R / B;
    if (!(z < 1 / VM_EPSILON)) R = VM_SQRT(2 * A * t); /* B = 0 among it */
    else if (z > VM_EPSILON) R = vmi_rotor_growth_root(z * z * z / 3) * B / A;
    return VM_FABS(rotor->s) / 4 + R;
}

/* ---- Chapter 4: Lagrange's equations across a jump ---------------------------------------------------------- */

VM_API void vm_lagrange_mass(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *matrix)
{
    int i, j;
    for (j = 0; j < n; j++) {
        vm_body moved = *body;
        vm_vec3 spin;
        moved.omega = turn[j];
        spin = vmi_spin_momentum(&moved);
        for (i = 0; i < n; i++) matrix[i * n + j] += body->mass * vmi_dot(dr[i], dr[j]) + vmi_dot(turn[i], spin);
    }
}

VM_API void vm_lagrange_momentum(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *p)
{
    const vm_vec3 linear = vm_momentum(body), spin = vmi_spin_momentum(body);
    int i;
    for (i = 0; i < n; i++) p[i] += vmi_dot(linear, dr[i]) + vmi_dot(spin, turn[i]);
}

VM_API void vm_lagrange_impulse(int n, const vm_impulse *impulse, vm_vec3 r, const vm_vec3 *dr, const vm_vec3 *turn,
                                vm_real *p)
{
    const vm_vec3 moment = vmi_add(impulse->couple, vmi_cross(vmi_sub(impulse->at, r), impulse->linear));
    int i;
    for (i = 0; i < n; i++) p[i] += vmi_dot(impulse->linear, dr[i]) + vmi_dot(moment, turn[i]);
}

/* matrix (qdot_after - qdot) = b, b at the end of work. Scaled to unit diagonal, which makes units and sizes of the
   coordinates nothing and the condition number nearly the least that scaling can (van der Sluis 1969). */
VM_API int vmi_lagrange_solve(int n, const vm_real *matrix, const vm_real *qdot, vm_real *qdot_after, vm_real *work)
{
    vm_real *a = work, *b = work + n * n;
    int i, j;
    if (!vmi_all_finite(n * n, matrix) || !vmi_all_finite(n, qdot) || !vmi_all_finite(n, b)) return VM_NOT_FINITE;
    for (i = 0; i < n; i++)
        if (!(matrix[i * n + i] > 0)) return VM_SINGULAR;
    for (i = 0; i < n; i++) {
        const vm_real scale = VM_SQRT(matrix[i * n + i]);
        for (j = 0; j < n; j++) a[i * n + j] = matrix[i * n + j] / scale / VM_SQRT(matrix[j * n + j]);
        b[i] /= scale;
    }
    if (vmi_solve_linear(n, a, b)) return VM_SINGULAR;
    for (i = 0; i < n; i++) /* the pivots, left on the diagonal */
        if (!(VM_FABS(a[i * n + i]) > (vm_real)(4 * n) * VM_EPSILON)) return VM_SINGULAR;
    for (i = 0; i < n; i++) b[i] = qdot[i] + b[i] / VM_SQRT(matrix[i * n + i]);
    return vmi_deliver(n, b, qdot_after);
}

/* after (qdot_after - qdot) = (before - after) qdot + sign part + impulse: so a small part changes qdot by little,
   with a small error */
VM_API int vmi_lagrange_jump(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                             const vm_real *part, vm_real sign, const vm_real *impulse, vm_real *qdot_after,
                             vm_real *work)
{
    int i, j;
    if (n <= 0 || !before || !after || !qdot || !qdot_after || !work) return VM_BAD_ARGUMENT;
    for (i = 0; i < n; i++) {
        vm_real sum = part ? sign * part[i] : 0;
        for (j = 0; j < n; j++) sum += (before[i * n + j] - after[i * n + j]) * qdot[j];
        work[n * n + i] = impulse ? sum + impulse[i] : sum;
    }
    return vmi_lagrange_solve(n, after, qdot, qdot_after, work);
}

VM_API int vm_lagrange_separate(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                                const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                                vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, -1, impulse_or_NULL, qdot_after, work);
}

VM_API int vm_lagrange_attach(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                              const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                              vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, 1, impulse_or_NULL, qdot_after, work);
}

VM_API int vm_lagrange_hit(int n, const vm_real *matrix, const vm_real *qdot, const vm_real *impulse,
                           vm_real *qdot_after, vm_real *work)
{
    if (!impulse) return VM_BAD_ARGUMENT;
    return vmi_lagrange_jump(n, matrix, matrix, qdot, NULL, 0, impulse, qdot_after, work);
}

VM_API int vmi_check_pendulum(const vm_pendulum *p, vm_real part)
{
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->length) || !VM_IS_FINITE(p->angle) || !VM_IS_FINITE(p->rate) ||
        !VM_IS_FINITE(part))
        return VM_NOT_FINITE;
    if (!(p->mass > 0)) return VM_BAD_MASS;
    if (p->axes != VM_AXES_COS_SIN && p->axes != VM_AXES_SIN_COS) return VM_DOMAIN;
    return part > 0 && part < p->length ? VM_OK : VM_DOMAIN;
}

/* With e from O to S2, f across it the way the angle grows: x u_y - y u_x = s rho u.f */
VM_API int vm_pendulum_separate(const vm_pendulum *pendulum, vm_real part, vm_real Omega, vm_real ux, vm_real uy,
                                vm_pendulum_cut *cut)
{
    vm_pendulum_cut c;
    vm_real ex, ey, fx, fy, rho, left, rest_mass, across, change;
    int status;
    if (!pendulum || !cut) return VM_BAD_ARGUMENT;
    status = vmi_check_pendulum(pendulum, part);
    if (status) return status;
    if (pendulum->axes == VM_AXES_COS_SIN) vmi_sincos(pendulum->angle, &ey, &ex), fx = -ey, fy = ex;
    else vmi_sincos(pendulum->angle, &ex, &ey), fx = ey, fy = -ex;
    rho = pendulum->length - part / 2, left = pendulum->length - part;
    across = ux * fx + uy * fy;
    change = -part * (part * part * Omega / 4 + 3 * rho * across) / (left * left * left);

    c.rest = *pendulum;
    c.rest.mass = rest_mass = pendulum->mass * (left / pendulum->length), c.rest.length = left;
    c.rest.rate = pendulum->rate + change;
    c.mass = pendulum->mass * (part / pendulum->length);
    c.x = rho * ex, c.y = rho * ey;
    c.vx = pendulum->rate * rho * fx + ux, c.vy = pendulum->rate * rho * fy + uy;
    c.rate = pendulum->rate + Omega;
    c.L1 = rest_mass * left * left * c.rest.rate / 3;
    c.L2 = c.mass * (part * part * c.rate / 12 + rho * (rho * pendulum->rate + across));
    c.T1 = pendulum->mass * pendulum->length * pendulum->length * pendulum->rate * pendulum->rate / 6;
    c.T_S1 = c.L1 * c.rest.rate / 2;
    c.T_S2 = c.mass * ((c.vx * c.vx + c.vy * c.vy) / 2 + part * part * c.rate * c.rate / 24);
    c.pivot_x = rest_mass * left / 2 * change * fx + c.mass * ux; /* momentum after less before */
    c.pivot_y = rest_mass * left / 2 * change * fy + c.mass * uy;
    if (!VM_IS_FINITE(c.rest.rate) || !VM_IS_FINITE(c.vx) || !VM_IS_FINITE(c.vy) || !VM_IS_FINITE(c.T1) ||
        !VM_IS_FINITE(c.T_S1) || !VM_IS_FINITE(c.T_S2) || !VM_IS_FINITE(c.pivot_x) || !VM_IS_FINITE(c.pivot_y))
        return VM_NOT_FINITE;
    *cut = c;
    return VM_OK;
}

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
