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

/* A stream carries mass into a body (rate > 0) or out of it (rate < 0) at one point. Zero fields are fair defaults,
   and what does not act costs nothing; the loads of several streams add. Its velocity is given as its motion says: */
enum {
    VM_RELATIVE = 0, /* velocity against the point of the body where it crosses, spin against the body: body axes */
    VM_ABSOLUTE = 1, /* velocity and spin as they are: inertial axes */
    VM_CARRIED = 2,  /* moves with the body: no torque, but M' omega x d is left of the force that (166) has as 0 */
    VM_AT_REST = 3   /* has neither velocity nor spin (167)-(169) */
};
typedef struct VM_TAG(vm_store) {
    vm_vec3 at;          /* m, body axes, from the body's reference point */
    vm_inertia gyration; /* m^2, body axes: inertia per unit mass of what is stored there, about its mass centre */
} vm_store;
typedef struct VM_TAG(vm_stream) {
    vm_real rate;        /* kg/s */
    int motion;          /* VM_RELATIVE ... */
    vm_vec3 at;          /* m, where it crosses, body axes, from the body's reference point */
    vm_vec3 velocity;    /* m/s */
    vm_vec3 spin;        /* rad/s */
    vm_inertia gyration; /* m^2, body axes: inertia per unit mass of what crosses, about its own mass centre */
    const vm_store
        *from; /* where the mass is taken from or put; null: where it crosses. Between the two it flows in
                             a straight line, with what it has of momentum on the way */
} vm_stream;

/* Reactive loads at an instant, inertial axes but for inertia_rate. With d = SS2 from the mass centre to the crossing
   point, M' the rate, u the velocity, kappa the gyration, omega2 the angular velocity of each stream:
     force   sum M' (u - v)                             (156)
     moment  sum d x M' (u - v)                         (158)
     torque  sum M' kappa omega2 - I' omega             (157) corrected: printed I' (omega2 - omega), which is right
                                                        only for P(d) omega2 = 0
     drift   sum (M'/M) d:  dr/dt = v + drift           not in [1]
     inertia_rate  I' = sum M' (kappa + P(d)), body axes
   Then M v' = F + force (159) and I omega' + omega x I omega = M_S + moment + torque (160). */
typedef struct VM_TAG(vm_reactive) {
    vm_vec3 force, moment, torque, drift; /* N, N m, N m, m/s */
    vm_real mass_rate;                    /* kg/s */
    vm_inertia inertia_rate;              /* kg m^2/s */
} vm_reactive;
/* centre: mass centre from the reference point, body axes. VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA,
   VM_BAD_ARGUMENT (a null pointer, an unknown motion, n < 0, or a stream with a store: run that) */
VM_API int vm_reactive_loads(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams,
                             vm_reactive *result);
/* v' (159) and omega' (160), inertial axes, under the resultant F of the outer loads and their moment M_S about the
   mass centre; VM_BAD_INERTIA where the inertia is singular */
VM_API int vm_accelerations(const vm_body *body, const vm_reactive *loads, vm_vec3 force, vm_vec3 moment,
                            vm_vec3 *acceleration, vm_vec3 *angular_acceleration);

/* The free body in space. A vm_flow is the ctx of the right-hand sides below:
     vm_flow flow = {0};  flow.n = 1, flow.streams = &nozzle;
     vm_flow_start(&flow, &body, y);
     if (rk45_init(&s, vm_rhs, &flow, VM_RHS, 0, y, NULL, work) >= 0 && rk45_solve(&s, 3) >= 0)
         vm_flow_body(&flow, VM_RHS, s.y, &body);
   The momenta are the states, v = momentum/mass and omega follow from them: what keeps a momentum keeps it exactly
   here, and rates may jump. States, in inertial axes but for the last two:
     y[VM_Y_R] r 3, y[VM_Y_Q] attitude 4, y[VM_Y_P] momentum 3, y[VM_Y_H] angular momentum about the mass centre 3,
     y[VM_Y_MASS], and in body axes y[VM_Y_CENTRE] mass centre c from the reference point 3, y[VM_Y_INERTIA] xx, yy,
     zz, xy, xz, yz about the mass centre
     r' = v + R sum (M'/M) d,  p' = F + sum M' u,  H' = M_S + R sum [d x M' (u - v) + M' kappa omega2],
     q' = q omega/2 + |omega| (1 - |q|^2) q/8,  c' = sum (M'/M) d,  I' = sum M' (kappa + P(d))
   R turns body axes into inertial ones, d = at - c; these are (151), (152), which [1] prints with I' omega2, in the
   body. With a store at s, d_s = s - c replaces d in c' and P(d), its gyration kappa in I', and the flow on the way
   holds the momentum M' (s - at) and the angular momentum M' d x d_s. The last term of q' is 0 where |q| = 1; R is of
   q/|q|: the length is held, and the order of no integrator suffers.
   A mass or an inertia that is not positive (in a trial step beyond the end) gives NaN, so that the step is
   shortened, and its status is left in flow.status. Stop before, by the events below. */
enum {
    VM_Y_R = 0,
    VM_Y_Q = 3,
    VM_Y_P = 7,
    VM_Y_H = 10,
    VM_Y_MASS = 13,
    VM_Y_CENTRE = 14,
    VM_Y_INERTIA = 17,
    VM_Y_BALANCE = 23,
    VM_RHS_GIVEN = 13,   /* numbers of states: mass, centre and inertia given by flow.update */
    VM_RHS = 23,         /* or states */
    VM_RHS_BALANCED = 30 /* and the account of momenta and energy */
};
typedef struct VM_TAG(vm_flow) {
    int n;              /* streams */
    vm_stream *streams; /* the caller's */
    vm_vec3 force;      /* N, resultant of the outer forces, inertial axes */
    vm_vec3 moment;     /* N m, their moment about the mass centre and the torques, inertial axes */
    /* null, or called before each evaluation; it may change all that is here; nonzero stops the run. What switches in
       time belongs into an ODE_RESTART event's change, not here */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow) * flow);
    void *ctx;                         /* the caller's */
    vm_real mass;                      /* vm_rhs_given, vm_rhs_carried: the laws M(t), */
    vm_vec3 centre;                    /* c(t) (vm_flow_start: where the mass centre is at first), */
    vm_inertia inertia;                /* I(t) */
    vm_vec3 drift;                     /* and c'(t), vm_rhs_carried */
    vm_real least_mass, least_inertia; /* of the events */
    int status;                        /* 0, or why the last evaluations gave NaN */
} vm_flow;

/* y: the VM_RHS first states for body, streams being as they are at first; VM_BAD_ARGUMENT (a null pointer, an
   unknown motion), VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA (that of a rod or a point too) */
VM_API int vm_flow_start(vm_flow *flow, const vm_body *body, vm_real *y);
/* The body of n states, with q of length 1: n = VM_RHS_GIVEN takes mass, centre and inertia from flow, more from y */
VM_API int vm_flow_body(const vm_flow *flow, int n, const vm_real *y, vm_body *body);
VM_API int vm_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow);
/* 13 states; flow.update sets mass, centre and inertia. With no streams this is (170): what joins or leaves does so
   at rest where the mass centre is */
VM_API int vm_rhs_given(vm_real t, const vm_real *y, vm_real *dydt, void *flow);
/* The same for what moves with the body (166). The states are r, q, v (not the momentum), omega in body axes (not the
   angular momentum); streams are not looked at: v' = F/M + R (omega x c'), r' = v + R c', I omega' + omega x I
   omega = M_S */
VM_API int vm_rhs_carried(vm_real t, const vm_real *y, vm_real *dydt, void *flow);
/* vm_rhs, and from y[VM_Y_BALANCE] on, zero at first, what streams have carried off less what outer loads have
   brought: of momentum 3, angular momentum about the origin 3, kinetic energy 1. With the body's own all seven stay
   constant (the energy but for streams with a store, where angular momentum is y[VM_Y_H] + r x p). The energy goes
   by the limit of (113), (118), for either sign of M':
     T' = F v + M_S omega + sum [M' u^2 + omega2 M' kappa omega2]/2 - sum [M' w^2 + omega_r M' kappa omega_r]/2,
     w = u - v - omega x d, omega_r = omega2 - omega:
   the first sum is what the streams bring, the second what engines give (M' < 0) or plastic impact takes (M' > 0). */
VM_API int vm_rhs_balanced(vm_real t, const vm_real *y, vm_real *dydt, void *flow);
/* Event functions of vm_rhs, ctx the flow: mass - least_mass; least pivot of I - least_inertia, 0 where I is
   singular */
VM_API vm_real vm_flow_mass_left(vm_real t, const vm_real *y, void *flow);
VM_API vm_real vm_flow_inertia_left(vm_real t, const vm_real *y, void *flow);

/* Translation (172): 7 states r, momentum, mass; the flow's streams without at, spin and gyration, body axes along
   the inertial ones */
enum { VM_RHS_TRANSLATION = 7 };
VM_API int vm_rhs_translation(vm_real t, const vm_real *y, vm_real *dydt, void *flow);

/* One degree of freedom: straight motion (175), (176), and rotation about a fixed axle (173a), which is the same
   equation. States: x, momentum, mass; or angle, angular momentum, inertia about the axle, with rate M' (kappa +
   rho^2), rho the distance from the axle, and velocity the stream's angular momentum per unit mass over that. */
typedef struct VM_TAG(vm_stream1) {
    vm_real rate, velocity;
    int motion;
} vm_stream1;
typedef struct VM_TAG(vm_flow1) {
    int n;
    vm_stream1 *streams;
    vm_real force; /* or moment */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow1) * flow);
    void *ctx;
    int status;
} vm_flow1;
enum { VM_RHS1 = 3 };
VM_API int vm_rhs1(vm_real t, const vm_real *y, vm_real *dydt, void *flow1);

/* The plane: as in space. States: x, y, angle, momentum 2, angular momentum about the mass centre, mass, mass centre
   from the reference point in body axes 2, inertia about it. No stores. */
typedef struct VM_TAG(vm_stream2) {
    vm_real rate;
    int motion;
    vm_real x, y;   /* where it crosses */
    vm_real vx, vy; /* velocity */
    vm_real spin;
    vm_real gyration; /* m^2 */
} vm_stream2;
typedef struct VM_TAG(vm_flow2) {
    int n;
    vm_stream2 *streams;
    vm_real fx, fy, moment;
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow2) * flow);
    void *ctx;
    int status;
} vm_flow2;
enum { VM_RHS2 = 10 };
VM_API int vm_rhs2(vm_real t, const vm_real *y, vm_real *dydt, void *flow2);

/* Closed forms, for mass and velocity or, about a fixed axle, for inertia and angular velocity. v when the mass has
   come from m0 to m: where what crosses has the absolute velocity u, impulse being that of the outer forces (151),
   (171), Levi-Civita's case for u = 0; where it has the relative velocity w and there is no outer force (175), (176),
   Tsiolkovsky's. Within 4 eps of the terms; NaN where a mass is not positive. */
VM_API vm_real vm_levi_civita(vm_real v0, vm_real m0, vm_real m, vm_real u, vm_real impulse);
VM_API vm_real vm_tsiolkovsky(vm_real v0, vm_real m0, vm_real m, vm_real w);
/* Position and velocity after t under constant rate, force and velocity of the stream (VM_RELATIVE, VM_ABSOLUTE),
   through rate = 0 without loss: 8 eps of the terms; VM_BAD_MASS where m0 + rate t or m0 is not positive */
VM_API int vm_linear_flow(vm_real t, vm_real x0, vm_real v0, vm_real m0, vm_real force, const vm_stream1 *stream,
                          vm_real *x, vm_real *v);
/* Jet damping of an axisymmetric body without outer loads: omega after t, body axes, z the axis of symmetry. Mass
   is taken from around the mass centre, which stays, and leaves through a nozzle on the axis (or the other way
   round); A, C are the transverse and the axial moment of inertia, A' = rate gyration_transverse, C' = rate
   gyration_axial:
     |omega_t| = |omega_t0| (A/A0)^((nozzle^2 + gyration_out)/gyration_transverse - 1),
     omega_z constant, phase of omega_t: omega_z integral (C/A - 1) dt
   Within 8 eps of what an eps in the inputs makes; VM_BAD_INERTIA where A or C is not positive, VM_NOT_FINITE */
typedef struct VM_TAG(vm_jet) {
    vm_real rate;                /* kg/s, < 0: leaves */
    vm_real axial, transverse;   /* C0, A0, kg m^2 */
    vm_real gyration_axial;      /* m^2, of what is stored and, alike, of what crosses */
    vm_real gyration_transverse; /* m^2, of what is stored, */
    vm_real gyration_out;        /* and of what crosses */
    vm_real nozzle;              /* m, from the mass centre */
} vm_jet;
VM_API int vm_jet_damping(vm_real t, const vm_jet *jet, vm_vec3 omega0, vm_vec3 *omega);

/* -- Chapter 5.2: the drum -- */

/* -- Chapter 6: Lagrange's equations with variable mass -- */

/* (247) corrected: with T(t, q, q', masses) of the material velocities, r2 where a stream crosses,
     d/dt dT/dq'_i - (dT/dq_i, masses frozen) = Q_i + sum [M' u dr2/dq_i + M' kappa omega2 domega/dq'_i]
   A derivative that lets masses vary with q, as (244)-(247) may be read, is wrong. As first-order equations: states
   are q and the momenta pi = dT/dq', from which q' follows; neither rates of momenta nor of masses are needed.
     pi' = (dT/dq, masses frozen) + Q,   A q' = pi - b,   T = q'Aq'/2 + b q' + T0
   A and b come from T itself by differences over unit rates, exact but for roundings of T there and at rest; dT/dq by
   central differences of order 6, within 2e-13 of the largest T (float 1e-5) over a scale on which T varies in q. */
typedef struct VM_TAG(vm_lagrange) {
    int n;        /* coordinates */
    int n_masses; /* masses, inertias, whatever is frozen */
    void (*masses)(vm_real t, const vm_real *q, vm_real *masses, void *ctx); /* null where n_masses is 0 */
    vm_real (*energy)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx);
    /* null, or adds the generalized forces to Q, vm_add_force does; nonzero stops the run */
    int (*forces)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q, void *ctx);
    void *ctx;
    const vm_real *scales; /* of each q; null: 1 */
    vm_real *work;         /* VM_LAGRANGE_RHS_WORK(n, n_masses) numbers */
} vm_lagrange;
#define VM_LAGRANGE_RHS_WORK(n, n_masses) ((n) * (n) + 3 * (n) + (n_masses))
/* An ode_rhs of 2 n states q, pi, ctx a vm_lagrange; VM_SINGULAR stops it */
VM_API int vm_lagrange_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *lagrange);
/* y = q, pi from q and rates q', and rates from y; VM_BAD_ARGUMENT, VM_SINGULAR, VM_NOT_FINITE */
VM_API int vm_lagrange_start(vm_lagrange *l, vm_real t, const vm_real *q, const vm_real *rates, vm_real *y);
VM_API int vm_lagrange_rates(vm_lagrange *l, vm_real t, const vm_real *y, vm_real *rates);
/* dT/dq_i with the masses frozen at (t, q); NaN for i outside 0 .. n - 1 */
VM_API vm_real vm_frozen_derivative(vm_lagrange *l, vm_real t, const vm_real *q, const vm_real *rates, int i);
/* Q_i += force dr/dq_i + moment domega/dq'_i, i < n (235): of outer loads F, M; of streams M' u at the point where
   they cross, and M' kappa omega2. dr or domega may be null: no part of it. */
VM_API void vm_add_force(int n, vm_vec3 force, const vm_vec3 *dr, vm_vec3 moment, const vm_vec3 *domega,
                         vm_real *Q);

/* Euler's angles psi, theta, phi (3-1-3: about z, the line of nodes, the body's z): the attitude, and domega/dq'_i in
   inertial and in body axes, omega = psi' axis[0] + theta' axis[1] + phi' axis[2]; rates of an omega in inertial
   axes, VM_SINGULAR where sin(theta) = 0. Within 4 eps; angles of any size. */
VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi);
VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3]);
VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3]);
VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3]);

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

VM_API vm_vec3 vmi_load3(const vm_real *y) { return vmi_vec3(y[0], y[1], y[2]); }
VM_API void vmi_store3(vm_real *y, vm_vec3 a) { y[0] = a.x, y[1] = a.y, y[2] = a.z; }
VM_API vm_inertia vmi_stream_load_inertia(const vm_real *y)
{
    vm_inertia i;
    i.xx = y[0], i.yy = y[1], i.zz = y[2], i.xy = y[3], i.xz = y[4], i.yz = y[5];
    return i;
}
VM_API void vmi_stream_store_inertia(vm_real *y, const vm_inertia *i)
{
    y[0] = i->xx, y[1] = i->yy, y[2] = i->zz, y[3] = i->xy, y[4] = i->xz, y[5] = i->yz;
}
VM_API vm_quat vmi_stream_load_quat(const vm_real *y)
{
    vm_quat q;
    q.w = y[0], q.x = y[1], q.y = y[2], q.z = y[3];
    return q;
}

/* The rotation of a quaternion whose length is nowhere near the ends of the type's range */
VM_INLINE vmi_mat3 vmi_stream_rotation(vm_quat q, vm_real square)
{
    const vm_real s = 2 / square, x = s * q.x, y = s * q.y, z = s * q.z;
    const vm_real xx = x * q.x, yy = y * q.y, zz = z * q.z, xy = x * q.y, xz = x * q.z, yz = y * q.z;
    const vm_real wx = x * q.w, wy = y * q.w, wz = z * q.w;
    vmi_mat3 m;
    m.x = vmi_vec3(1 - (yy + zz), xy + wz, xz - wy);
    m.y = vmi_vec3(xy - wz, 1 - (xx + zz), yz + wx);
    m.z = vmi_vec3(xz + wy, yz - wx, 1 - (xx + yy));
    return m;
}

/* L D L^T of an inertia; 0 where a pivot is lost in its own rounding errors, or is not positive */
typedef struct VM_TAG(vmi_stream_ldl) {
    vm_real xy, xz, yz, x, y, z; /* of L; of 1/D */
} vmi_stream_ldl;
VM_INLINE int vmi_stream_factor(const vm_inertia *i, vmi_stream_ldl *f)
{
    const vm_real lost = 8 * VM_EPSILON;
    vm_real y, z, t;
    f->x = 1 / i->xx, f->xy = i->xy * f->x, f->xz = i->xz * f->x;
    y = i->yy - f->xy * i->xy, t = i->yz - f->xz * i->xy;
    f->y = 1 / y, f->yz = t * f->y;
    z = i->zz - f->xz * i->xz - f->yz * t;
    f->z = 1 / z;
    return i->xx > 0 && y > lost * i->yy && z > lost * i->zz;
}

VM_INLINE vm_vec3 vmi_stream_solve(const vmi_stream_ldl *f, vm_vec3 h)
{
    vm_vec3 w;
    w.y = h.y - f->xy * h.x;
    w.z = (h.z - f->xz * h.x - f->yz * w.y) * f->z;
    w.y = w.y * f->y - f->yz * w.z;
    w.x = h.x * f->x - f->xy * w.y - f->xz * w.z;
    return w;
}

/* What the streams of a moving body add up to, body axes */
typedef struct VM_TAG(vmi_stream_sum) {
    vm_real rate, carried;    /* sum M'; that of the streams whose velocity is given relative to the body, */
    vm_vec3 pushed;           /* their sum M' (u - v), */
    vm_vec3 absolute;         /* and sum M' u of the others, inertial axes: exact where u = 0 */
    vm_vec3 moment;           /* sum d x M' (u - v) */
    vm_vec3 own;              /* sum M' kappa omega2 */
    vm_vec3 crossing, stored; /* sum M' d, sum M' d_s */
    vm_inertia inertia;       /* I' */
    vm_real brought, lost;    /* twice the sums of T' */
} vmi_stream_sum;

/* Momentum, and angular momentum about the mass centre, of what is between the stores and the points of crossing */
VM_INLINE void vmi_stream_on_the_way(int n, const vm_stream *s, vm_vec3 centre, vm_vec3 *p, vm_vec3 *h)
{
    int k;
    *p = *h = vmi_vec3(0, 0, 0);
    for (k = 0; k < n; k++) {
        if (!s[k].from) continue;
        *p = vmi_add(*p, vmi_scale(s[k].rate, vmi_sub(s[k].from->at, s[k].at)));
        *h = vmi_add(*h, vmi_scale(s[k].rate, vmi_cross(vmi_sub(s[k].at, centre), vmi_sub(s[k].from->at, centre))));
    }
}

/* M' kappa */
VM_INLINE vm_inertia vmi_stream_own(vm_real rate, const vm_inertia *gyration)
{
    vm_inertia i;
    i.xx = rate * gyration->xx, i.yy = rate * gyration->yy, i.zz = rate * gyration->zz;
    i.xy = rate * gyration->xy, i.xz = rate * gyration->xz, i.yz = rate * gyration->yz;
    return i;
}

/* The motion of a body as the streams see it: v = momentum/mass in inertial axes; in body axes slip, the velocity
   of its material at the mass centre less v, omega and the mass centre. energy: brought and lost are wanted */
typedef struct VM_TAG(vmi_stream_seen) {
    const vmi_mat3 *turn;
    vm_vec3 v, slip, omega, centre;
    int energy;
} vmi_stream_seen;

/* M' (u - v) and omega2 of a stream, body axes, and its part of the momentum's rate; 0 for an unknown motion */
VM_INLINE int vmi_stream_motion(const vm_stream *s, const vmi_stream_seen *b, vm_vec3 carried, vmi_stream_sum *sum,
                                vm_vec3 *push, vm_vec3 *spin)
{
    switch (s->motion) {
    case VM_RELATIVE: carried = vmi_add(carried, s->velocity), *spin = vmi_add(b->omega, s->spin); break;
    case VM_ABSOLUTE:
        *push = vmi_scale(s->rate, vmi_times_transposed(b->turn, vmi_sub(s->velocity, b->v)));
        *spin = vmi_times_transposed(b->turn, s->spin);
        sum->absolute = vmi_add(sum->absolute, vmi_scale(s->rate, s->velocity));
        return 1;
    case VM_CARRIED: *spin = b->omega; break;
    case VM_AT_REST:
        *push = vmi_times_transposed(b->turn, vmi_scale(-s->rate, b->v)), *spin = vmi_vec3(0, 0, 0);
        return 1;
    default: return 0;
    }
    *push = vmi_scale(s->rate, carried);
    sum->carried += s->rate;
    sum->pushed = vmi_add(sum->pushed, *push);
    return 1;
}

VM_INLINE void vmi_stream_energy(const vm_stream *s, const vmi_stream_seen *b, const vm_inertia *own, vm_vec3 push,
                                 vm_vec3 spin, vm_vec3 carried, vmi_stream_sum *sum)
{
    const vm_vec3 u = s->rate != 0 ? vmi_scale(1 / s->rate, push) : push, relative = vmi_sub(spin, b->omega);
    const vm_vec3 absolute = vmi_add(u, vmi_times_transposed(b->turn, b->v)), w = vmi_sub(u, carried);
    sum->brought += s->rate * vmi_dot(absolute, absolute) + vmi_dot(spin, vmi_inertia_times(own, spin));
    sum->lost += s->rate * vmi_dot(w, w) + vmi_dot(relative, vmi_inertia_times(own, relative));
}

VM_INLINE int vmi_stream_sums(int n, const vm_stream *s, const vmi_stream_seen *b, vmi_stream_sum *sum)
{
    const vmi_stream_sum none = {0,         0,         {0, 0, 0},          {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
                                 {0, 0, 0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0}, 0,         0};
    int k;
    *sum = none;
    for (k = 0; k < n; k++, s++) {
        const vm_vec3 d = vmi_sub(s->at, b->centre), carried = vmi_add(b->slip, vmi_cross(b->omega, d));
        vm_inertia own = vmi_stream_own(s->rate, &s->gyration);
        vm_vec3 push, spin, stored = d;
        if (!vmi_stream_motion(s, b, carried, sum, &push, &spin)) return 0;
        if (b->energy) vmi_stream_energy(s, b, &own, push, spin, carried, sum);
        sum->rate += s->rate;
        sum->moment = vmi_add(sum->moment, vmi_cross(d, push));
        sum->own = vmi_add(sum->own, vmi_inertia_times(&own, spin));
        sum->crossing = vmi_add(sum->crossing, vmi_scale(s->rate, d));
        if (s->from) stored = vmi_sub(s->from->at, b->centre), own = vmi_stream_own(s->rate, &s->from->gyration);
        sum->stored = vmi_add(sum->stored, vmi_scale(s->rate, stored));
        /* as a whole, so that opposite streams cancel */
        own = vmi_inertia_plus(own, s->rate, vmi_inertia_of_point(stored));
        sum->inertia = vmi_inertia_plus(sum->inertia, 1, own);
    }
    return 1;
}

/* The loads of an instant */

/* Finite, no negative moment. The triangle inequality is not asked for: a tensor with zz alone does for plane
   motion */
VM_API int vmi_stream_gyration_good(const vm_inertia *i)
{
    if (!vmi_vec3_finite(vmi_vec3(i->xx, i->yy, i->zz)) || !vmi_vec3_finite(vmi_vec3(i->xy, i->xz, i->yz)))
        return VM_NOT_FINITE;
    return i->xx >= 0 && i->yy >= 0 && i->zz >= 0 ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_stream_good(const vm_stream *s)
{
    int status;
    if (s->motion < VM_RELATIVE || s->motion > VM_AT_REST) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(s->rate) || !vmi_vec3_finite(s->at) || !vmi_vec3_finite(s->velocity) ||
        !vmi_vec3_finite(s->spin))
        return VM_NOT_FINITE;
    status = vmi_stream_gyration_good(&s->gyration);
    if (status || !s->from) return status;
    return vmi_vec3_finite(s->from->at) ? vmi_stream_gyration_good(&s->from->gyration) : VM_NOT_FINITE;
}

VM_API int vmi_stream_all_good(int n, const vm_stream *s)
{
    int k, status = n < 0 || (n > 0 && !s) ? VM_BAD_ARGUMENT : VM_OK;
    for (k = 0; !status && k < n; k++) status = vmi_stream_good(s + k);
    return status;
}

VM_API int vm_reactive_loads(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams,
                             vm_reactive *result)
{
    vmi_mat3 turn;
    vmi_stream_sum sum;
    vmi_stream_seen seen;
    int status, k;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_stream_all_good(n, streams);
    if (!status && !vmi_vec3_finite(centre)) status = VM_NOT_FINITE;
    for (k = 0; !status && k < n; k++)
        if (streams[k].from) status = VM_BAD_ARGUMENT;
    if (status) return status;
    turn = vmi_rotation(body->q);
    seen.turn = &turn, seen.v = body->v, seen.slip = vmi_vec3(0, 0, 0), seen.centre = centre, seen.energy = 0;
    seen.omega = vmi_times_transposed(&turn, body->omega);
    vmi_stream_sums(n, streams, &seen, &sum);
    result->force = vmi_add(vmi_times(&turn, sum.pushed),
                            vmi_sub(sum.absolute, vmi_scale(sum.rate - sum.carried, body->v)));
    result->moment = vmi_times(&turn, sum.moment);
    result->torque = vmi_times(&turn, vmi_sub(sum.own, vmi_inertia_times(&sum.inertia, seen.omega)));
    result->drift = vmi_scale(1 / body->mass, vmi_times(&turn, sum.crossing));
    result->mass_rate = sum.rate;
    result->inertia_rate = sum.inertia;
    return VM_OK;
}

/* I^-1 (moment - omega x I omega), body axes */
VM_INLINE vm_vec3 vmi_stream_euler(const vm_inertia *i, const vmi_stream_ldl *factors, vm_vec3 omega,
                                   vm_vec3 moment)
{
    return vmi_stream_solve(factors, vmi_sub(moment, vmi_cross(omega, vmi_inertia_times(i, omega))));
}

VM_API int vm_accelerations(const vm_body *body, const vm_reactive *loads, vm_vec3 force, vm_vec3 moment,
                            vm_vec3 *acceleration, vm_vec3 *angular_acceleration)
{
    vmi_mat3 turn;
    vmi_stream_ldl factors;
    int status;
    if (!body || !loads || !acceleration || !angular_acceleration) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status && !(vmi_vec3_finite(force) && vmi_vec3_finite(moment))) status = VM_NOT_FINITE;
    if (!status && !vmi_stream_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    turn = vmi_rotation(body->q);
    moment = vmi_add(moment, vmi_add(loads->moment, loads->torque));
    *acceleration = vmi_scale(1 / body->mass, vmi_add(force, loads->force));
    *angular_acceleration = vmi_times(&turn, vmi_stream_euler(&body->inertia, &factors,
                                                              vmi_times_transposed(&turn, body->omega),
                                                              vmi_times_transposed(&turn, moment)));
    return VM_OK;
}

/* The free body */

/* Derivatives that make the integrator shorten its step */
VM_API int vmi_flow_refuse(int n, vm_real *dydt)
{
    int k;
    for (k = 0; k < n; k++) dydt[k] = VM_NAN;
    return 0;
}

/* Keeps the first reason of evaluations in a row that are refused: the others follow from its NaN */
VM_INLINE int vmi_flow_refused(int *kept, int status)
{
    if (!status || !*kept) *kept = status;
    return status;
}

/* q omega/2 + |omega| (1 - |q|^2) q/8, omega in body axes: the length comes back within some steps of any explicit
   method, at a rate that is below that of the rotation itself */
VM_INLINE void vmi_stream_turning(vm_quat q, vm_real square, vm_vec3 omega, vm_real *dydt)
{
    const vm_real back = VM_SQRT(vmi_dot(omega, omega)) * (1 - square) / 8, x = omega.x / 2, y = omega.y / 2,
                  z = omega.z / 2;
    dydt[0] = back * q.w - q.x * x - q.y * y - q.z * z;
    dydt[1] = back * q.x + q.w * x + q.y * z - q.z * y;
    dydt[2] = back * q.y + q.w * y + q.z * x - q.x * z;
    dydt[3] = back * q.z + q.w * z + q.x * y - q.y * x;
}

/* A state taken apart: rotation, velocity and angular velocity; VM_BAD_MASS, VM_BAD_INERTIA */
VM_INLINE int vmi_flow_motion(const vm_flow *flow, const vm_real *y, vm_real mass, const vm_inertia *inertia,
                              vm_vec3 centre, vmi_mat3 *turn, vmi_stream_seen *seen)
{
    const vm_quat q = vmi_stream_load_quat(y + VM_Y_Q);
    const vm_vec3 p = vmi_load3(y + VM_Y_P);
    const vm_real inverse = 1 / mass;
    vm_vec3 h;
    vmi_stream_ldl factors;
    if (!(mass > 0)) return VM_BAD_MASS;
    if (!vmi_stream_factor(inertia, &factors)) return VM_BAD_INERTIA;
    *turn = vmi_stream_rotation(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    h = vmi_times_transposed(turn, vmi_load3(y + VM_Y_H));
    vmi_stream_on_the_way(flow->n, flow->streams, centre, &seen->slip, &seen->omega);
    seen->turn = turn, seen->centre = centre;
    seen->v = vmi_scale(inverse, p);
    seen->slip = vmi_scale(-inverse, seen->slip);
    seen->omega = vmi_stream_solve(&factors, vmi_sub(h, seen->omega));
    return VM_OK;
}

/* VM_Y_BALANCE on: momentum, angular momentum and energy carried off by streams less those brought by loads */
VM_INLINE void vmi_flow_balance(const vm_flow *flow, const vm_real *y, const vmi_stream_seen *seen,
                                const vmi_stream_sum *sum, vm_vec3 force, vm_vec3 moment, vm_real *dydt)
{
    const vm_vec3 omega = vmi_times(seen->turn, seen->omega), r = vmi_load3(y + VM_Y_R);
    const vm_vec3 drift = vmi_times(seen->turn, sum->crossing);
    vmi_store3(dydt, vmi_scale(-1, force));
    vmi_store3(dydt + 3, vmi_scale(-1, vmi_add(moment, vmi_add(vmi_cross(r, force), vmi_cross(drift, seen->v)))));
    dydt[6] = (sum->lost - sum->brought) / 2 - vmi_dot(flow->force, seen->v) - vmi_dot(flow->moment, omega);
}

VM_INLINE int vmi_flow_rates(vm_flow *flow, int n, vm_real t, const vm_real *y, vm_real *dydt)
{
    const int given = n == VM_RHS_GIVEN;
    const vm_quat q = vmi_stream_load_quat(y + VM_Y_Q);
    vm_real mass;
    vm_vec3 centre, force, moment;
    vm_inertia inertia;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    vmi_stream_sum sum;
    int status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    mass = given ? flow->mass : y[VM_Y_MASS];
    centre = given ? flow->centre : vmi_load3(y + VM_Y_CENTRE);
    inertia = given ? flow->inertia : vmi_stream_load_inertia(y + VM_Y_INERTIA);
    status = vmi_flow_motion(flow, y, mass, &inertia, centre, &turn, &seen);
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(n, dydt);
    seen.energy = n == VM_RHS_BALANCED;
    if (!vmi_stream_sums(flow->n, flow->streams, &seen, &sum)) return flow->status = VM_BAD_ARGUMENT;
    force = vmi_add(vmi_times(&turn, sum.pushed), vmi_scale(sum.carried, seen.v));
    force = vmi_add(flow->force, vmi_add(sum.absolute, force));
    moment = vmi_add(flow->moment, vmi_times(&turn, vmi_add(sum.moment, sum.own)));
    vmi_store3(dydt + VM_Y_R, vmi_add(seen.v, vmi_times(&turn, vmi_scale(1 / mass, sum.crossing))));
    vmi_stream_turning(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, seen.omega, dydt + VM_Y_Q);
    vmi_store3(dydt + VM_Y_P, force);
    vmi_store3(dydt + VM_Y_H, moment);
    if (given) return 0;
    dydt[VM_Y_MASS] = sum.rate;
    vmi_store3(dydt + VM_Y_CENTRE, vmi_scale(1 / mass, sum.stored));
    vmi_stream_store_inertia(dydt + VM_Y_INERTIA, &sum.inertia);
    if (seen.energy) vmi_flow_balance(flow, y, &seen, &sum, force, moment, dydt + VM_Y_BALANCE);
    return 0;
}

VM_API int vm_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    return vmi_flow_rates((vm_flow *)flow, VM_RHS, t, y, dydt);
}

VM_API int vm_rhs_given(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    return vmi_flow_rates((vm_flow *)flow, VM_RHS_GIVEN, t, y, dydt);
}

VM_API int vm_rhs_balanced(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    return vmi_flow_rates((vm_flow *)flow, VM_RHS_BALANCED, t, y, dydt);
}

VM_API int vm_rhs_carried(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_flow *flow = (vm_flow *)ctx;
    const vm_quat q = vmi_stream_load_quat(y + VM_Y_Q);
    const vm_real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const vm_vec3 omega = vmi_load3(y + VM_Y_H);
    vmi_mat3 turn;
    vmi_stream_ldl factors;
    int status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    status = !(flow->mass > 0) ? VM_BAD_MASS : vmi_stream_factor(&flow->inertia, &factors) ? VM_OK : VM_BAD_INERTIA;
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(VM_RHS_GIVEN, dydt);
    turn = vmi_stream_rotation(q, square);
    vmi_store3(dydt + VM_Y_R, vmi_add(vmi_load3(y + VM_Y_P), vmi_times(&turn, flow->drift)));
    vmi_stream_turning(q, square, omega, dydt + VM_Y_Q);
    vmi_store3(dydt + VM_Y_P,
               vmi_add(vmi_scale(1 / flow->mass, flow->force), vmi_times(&turn, vmi_cross(omega, flow->drift))));
    vmi_store3(dydt + VM_Y_H,
               vmi_stream_euler(&flow->inertia, &factors, omega, vmi_times_transposed(&turn, flow->moment)));
    return 0;
}

/* Of length 1; the identity for all zero */
VM_API vm_quat vmi_stream_unit(vm_quat q)
{
    vm_real largest = VM_FABS(q.w), length;
    if (VM_FABS(q.x) > largest) largest = VM_FABS(q.x);
    if (VM_FABS(q.y) > largest) largest = VM_FABS(q.y);
    if (VM_FABS(q.z) > largest) largest = VM_FABS(q.z);
    if (largest == 0) q.w = largest = 1;
    q.w /= largest, q.x /= largest, q.y /= largest, q.z /= largest;
    length = VM_SQRT(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    q.w /= length, q.x /= length, q.y /= length, q.z /= length;
    return q;
}

VM_API int vm_flow_start(vm_flow *flow, const vm_body *body, vm_real *y)
{
    vm_vec3 p, h;
    vm_quat q;
    vmi_stream_ldl factors;
    vmi_mat3 turn;
    int status;
    if (!flow || !body || !y) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_stream_all_good(flow->n, flow->streams);
    if (!status &&
        !(vmi_vec3_finite(flow->centre) && vmi_vec3_finite(flow->force) && vmi_vec3_finite(flow->moment)))
        status = VM_NOT_FINITE;
    if (!status && !vmi_stream_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    q = vmi_stream_unit(body->q);
    turn = vmi_rotation(q);
    vmi_stream_on_the_way(flow->n, flow->streams, flow->centre, &p, &h);
    y[VM_Y_Q] = q.w, y[VM_Y_Q + 1] = q.x, y[VM_Y_Q + 2] = q.y, y[VM_Y_Q + 3] = q.z;
    vmi_store3(y + VM_Y_R, body->r);
    vmi_store3(y + VM_Y_P, vm_momentum(body));
    vmi_store3(y + VM_Y_H, vmi_add(vmi_spin_momentum(body), vmi_times(&turn, h)));
    y[VM_Y_MASS] = body->mass;
    vmi_store3(y + VM_Y_CENTRE, flow->centre);
    vmi_stream_store_inertia(y + VM_Y_INERTIA, &body->inertia);
    flow->mass = body->mass, flow->inertia = body->inertia, flow->status = VM_OK;
    return VM_OK;
}

VM_API int vm_flow_body(const vm_flow *flow, int n, const vm_real *y, vm_body *body)
{
    const int given = n < VM_RHS;
    vm_vec3 centre;
    vm_body b;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    int status;
    if (!flow || !y || !body || n < VM_RHS_GIVEN) return VM_BAD_ARGUMENT;
    b.mass = given ? flow->mass : y[VM_Y_MASS];
    b.inertia = given ? flow->inertia : vmi_stream_load_inertia(y + VM_Y_INERTIA);
    centre = given ? flow->centre : vmi_load3(y + VM_Y_CENTRE);
    status = vmi_flow_motion(flow, y, b.mass, &b.inertia, centre, &turn, &seen);
    if (status) return status;
    b.q = vmi_stream_unit(vmi_stream_load_quat(y + VM_Y_Q));
    b.r = vmi_load3(y + VM_Y_R), b.v = seen.v, b.omega = vmi_times(&turn, seen.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

VM_API vm_real vm_flow_mass_left(vm_real t, const vm_real *y, void *flow)
{
    (void)t;
    return y[VM_Y_MASS] - ((const vm_flow *)flow)->least_mass;
}

VM_API vm_real vm_flow_inertia_left(vm_real t, const vm_real *y, void *flow)
{
    const vm_inertia i = vmi_stream_load_inertia(y + VM_Y_INERTIA);
    vmi_stream_ldl f;
    vm_real least = i.xx;
    (void)t;
    if (vmi_stream_factor(&i, &f)) {
        if (1 / f.y < least) least = 1 / f.y;
        if (1 / f.z < least) least = 1 / f.z;
    } else least = 0;
    return least - ((const vm_flow *)flow)->least_inertia;
}

VM_INLINE int vmi_translation_rates(vm_flow *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real inverse = 1 / y[6];
    const vm_vec3 v = vmi_scale(inverse, vmi_load3(y + 3));
    vm_real rate = 0;
    vm_vec3 force = flow->force;
    int k;
    if (vmi_flow_refused(&flow->status, y[6] > 0 ? VM_OK : VM_BAD_MASS))
        return vmi_flow_refuse(VM_RHS_TRANSLATION, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream *s = flow->streams + k;
        vm_vec3 u = vmi_add(v, s->velocity);
        if (s->motion != VM_RELATIVE)
            u = s->motion == VM_ABSOLUTE ? s->velocity : s->motion == VM_CARRIED ? v : vmi_vec3(0, 0, 0);
        rate += s->rate, force = vmi_add(force, vmi_scale(s->rate, u));
    }
    vmi_store3(dydt, v), vmi_store3(dydt + 3, force);
    dydt[6] = rate;
    return 0;
}

VM_INLINE int vmi_rates1(vm_flow1 *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real v = y[1] / y[2];
    vm_real force = flow->force, rate = 0;
    int k;
    if (vmi_flow_refused(&flow->status, y[2] > 0 ? VM_OK : VM_BAD_MASS)) return vmi_flow_refuse(VM_RHS1, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream1 *s = flow->streams + k;
        vm_real u = v + s->velocity;
        if (s->motion != VM_RELATIVE) u = s->motion == VM_ABSOLUTE ? s->velocity : s->motion == VM_CARRIED ? v : 0;
        rate += s->rate, force += s->rate * u;
    }
    dydt[0] = v, dydt[1] = force, dydt[2] = rate;
    return 0;
}

/* Apart, so that nothing is saved for a call that is not made */
VMI_APART int vmi_translation_updated(vm_real t, const vm_real *y, vm_real *dydt, vm_flow *flow)
{
    const int status = flow->update(t, y, flow);
    return status ? status : vmi_translation_rates(flow, y, dydt);
}

VMI_APART int vmi_updated1(vm_real t, const vm_real *y, vm_real *dydt, vm_flow1 *flow)
{
    const int status = flow->update(t, y, flow);
    return status ? status : vmi_rates1(flow, y, dydt);
}

VM_API int vm_rhs_translation(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    vm_flow *f = (vm_flow *)flow;
    return f->update ? vmi_translation_updated(t, y, dydt, f) : vmi_translation_rates(f, y, dydt);
}

VM_API int vm_rhs1(vm_real t, const vm_real *y, vm_real *dydt, void *flow1)
{
    vm_flow1 *f = (vm_flow1 *)flow1;
    return f->update ? vmi_updated1(t, y, dydt, f) : vmi_rates1(f, y, dydt);
}

/* sin and cos of x within 0.6 eps of 1: vmi_sincos, with a shorter reduction below 2^20 quarters (float 2^10). pi/2
   less its first piece, of 33 (14) bits, whose products are exact, is known to 2^-87 (2^-38); rounding j times it
   costs 2^-67 (2^-28) */
VM_INLINE void vmi_stream_sincos(vm_real x, vm_real *sine, vm_real *cosine)
{
#if VM_MANT_DIG > 24
    const vm_real most = VM_C(1048576.0), first = VM_C(1.570796326734125614166),
                  second = VM_C(6.077100506506192601e-11);
#else
    const vm_real most = VM_C(1024.0), first = VM_C(1.5706787109375), second = VM_C(1.176158573966192321e-4);
#endif
    const vm_real quarters = x * VM_C(0.63661977236758134308);
    vm_real s, c, rest, tail;
    vm_two z;
    long j;
    if (!(VM_FABS(quarters) < most)) {
        vmi_sincos(x, sine, cosine);
        return;
    }
    j = (long)(quarters + VM_COPYSIGN(VM_C(0.5), quarters));
    rest = x - (vm_real)j * first, tail = (vm_real)j * second;
    z.hi = rest - tail, z.lo = (rest - z.hi) - tail;
    vmi_sin_cos(z, &s, &c);
    *sine = (j & 1 ? c : s) * (vm_real)(1 - (j & 2));
    *cosine = (j & 1 ? s : c) * (vm_real)(1 - ((j + 1) & 2));
}

/* Sums of the streams in the plane, body axes but for fx, fy */
typedef struct VM_TAG(vmi_stream_sum2) {
    vm_real rate, carried, px, py, fx, fy, moment, sx, sy, inertia;
} vmi_stream_sum2;

/* bx, by: v in body axes, of which sine and cosine are the direction */
VM_INLINE void vmi_stream_add2(const vm_stream2 *s, vm_real dx, vm_real dy, vm_real omega, vm_real bx, vm_real by,
                               vm_real sine, vm_real cosine, vmi_stream_sum2 *sum)
{
    vm_real ux, uy, spin = 0; /* M' (u - v) */
    if (s->motion == VM_RELATIVE || s->motion == VM_CARRIED) {
        ux = -omega * dy, uy = omega * dx, spin = omega;
        if (s->motion == VM_RELATIVE) ux += s->vx, uy += s->vy, spin += s->spin;
        ux *= s->rate, uy *= s->rate;
        sum->carried += s->rate, sum->px += ux, sum->py += uy;
    } else {
        ux = -s->rate * bx, uy = -s->rate * by;
        if (s->motion == VM_ABSOLUTE) {
            const vm_real ax = s->rate * s->vx, ay = s->rate * s->vy;
            sum->fx += ax, sum->fy += ay, spin = s->spin;
            ux += cosine * ax + sine * ay, uy += cosine * ay - sine * ax;
        }
    }
    sum->rate += s->rate;
    sum->moment += dx * uy - dy * ux + s->rate * s->gyration * spin;
    sum->sx += s->rate * dx, sum->sy += s->rate * dy;
    sum->inertia += s->rate * (s->gyration + dx * dx + dy * dy);
}

VM_API int vm_rhs2(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_flow2 *flow = (vm_flow2 *)ctx;
    vmi_stream_sum2 sum = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    vm_real sine, cosine, inverse, vx, vy, omega, sx, sy;
    int k, status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    status = !(y[6] > 0) ? VM_BAD_MASS : y[9] > 0 ? VM_OK : VM_BAD_INERTIA;
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(VM_RHS2, dydt);
    sine = 0, cosine = 1;
    if (flow->n) vmi_stream_sincos(y[2], &sine, &cosine);
    inverse = 1 / y[6], vx = y[3] * inverse, vy = y[4] * inverse, omega = y[5] / y[9];
    sum.fx = flow->fx, sum.fy = flow->fy, sum.moment = flow->moment;
    for (k = 0; k < flow->n; k++)
        vmi_stream_add2(flow->streams + k, flow->streams[k].x - y[7], flow->streams[k].y - y[8], omega,
                        cosine * vx + sine * vy, cosine * vy - sine * vx, sine, cosine, &sum);
    sx = sum.sx * inverse, sy = sum.sy * inverse;
    dydt[0] = vx + cosine * sx - sine * sy, dydt[1] = vy + sine * sx + cosine * sy, dydt[2] = omega;
    dydt[3] = sum.fx + sum.carried * vx + cosine * sum.px - sine * sum.py;
    dydt[4] = sum.fy + sum.carried * vy + sine * sum.px + cosine * sum.py;
    dydt[5] = sum.moment, dydt[6] = sum.rate, dydt[7] = sx, dydt[8] = sy, dydt[9] = sum.inertia;
    return 0;
}

/* Closed forms */

/* ln(1 + x)/x and (x - ln(1 + x))/x^2 for x > -1, within 2 ulp: the logarithm has 2^-64 (float 2^-31) of itself, so
   that the difference loses nothing down to 2^-8, where seven terms of its series are enough */
VM_API void vmi_stream_log_means(vm_real x, vm_real *first, vm_real *second)
{
    if (VM_FABS(x) < VM_C(0.00390625)) {
        *second =
            VM_C(0.5) -
            x * (VM_C(1.0) / 3 -
                 x * (VM_C(0.25) - x * (VM_C(0.2) - x * (VM_C(1.0) / 6 - x * (VM_C(1.0) / 7 - x * VM_C(0.125))))));
        *first = 1 - x * *second;
    } else {
        const vm_two l = vmi_two_log(vmi_two_sum(1, x));
        *first = l.hi / x;
        *second = ((x - l.hi) - l.lo) / x / x;
    }
}

VM_API vm_real vm_levi_civita(vm_real v0, vm_real m0, vm_real m, vm_real u, vm_real impulse)
{
    if (!(m0 > 0 && m > 0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(m)) return VM_NAN;
    return v0 * (m0 / m) + ((m - m0) * u + impulse) / m;
}

VM_API vm_real vm_tsiolkovsky(vm_real v0, vm_real m0, vm_real m, vm_real w)
{
    vm_two l;
    if (!(m0 > 0 && m > 0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(m)) return VM_NAN;
    if (m < 2 * m0 && m0 < 2 * m) l = vmi_two_log(vmi_two_sum(1, (m - m0) / m0)); /* m - m0 is exact */
    else l = vmi_two_plus(vmi_log(m), vmi_minus(vmi_log(m0)));
    return v0 + w * l.hi;
}

/* With tau = rate t/m0, L = ln(1 + tau)/tau, B = (tau - ln(1 + tau))/tau^2, constant force and u:
     v - v0 = (force + rate (u - v0)) t/m,        x = x0 + v0 t + (force + rate (u - v0)) t^2/m0 B
   as M (v - u) + const; and with constant w:
     v - v0 = (force + rate w) t/m0 L,            x = x0 + v0 t + (force + rate w) t^2/m0 (L - B) */
VM_API int vm_linear_flow(vm_real t, vm_real x0, vm_real v0, vm_real m0, vm_real force, const vm_stream1 *stream,
                          vm_real *x, vm_real *v)
{
    vm_real tau, first, second, pull;
    if (!stream || !x || !v) return VM_BAD_ARGUMENT;
    if (stream->motion < VM_RELATIVE || stream->motion > VM_AT_REST) return VM_BAD_ARGUMENT;
    if (!(m0 > 0)) return VM_BAD_MASS;
    tau = stream->rate * t / m0;
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(x0 + v0 + force + stream->velocity)) return VM_NOT_FINITE;
    if (!(tau > -1)) return VM_BAD_MASS;
    vmi_stream_log_means(tau, &first, &second);
    pull = stream->motion == VM_RELATIVE || stream->motion == VM_ABSOLUTE ? stream->velocity : 0;
    if (stream->motion == VM_RELATIVE || stream->motion == VM_CARRIED) {
        pull = (force + stream->rate * pull) / m0;
        *v = v0 + pull * t * first;
        *x = x0 + t * (v0 + pull * t * (first - second));
    } else {
        pull = (force + stream->rate * (pull - v0)) / m0;
        *v = v0 + pull * t / (1 + tau);
        *x = x0 + t * (v0 + pull * t * second);
    }
    return VM_OK;
}

/* With tau = rate gyration t/A0 and c likewise: ln(A/A0) = tau L, integral (C/A - 1) dt = t (C0/A0 L - 1 + rate t
   gyration_axial/A0 B) */
VM_API int vm_jet_damping(vm_real t, const vm_jet *jet, vm_vec3 omega0, vm_vec3 *omega)
{
    vm_real change, tau, first, second, decay, sine, cosine;
    if (!jet || !omega) return VM_BAD_ARGUMENT;
    if (!(jet->axial > 0 && jet->transverse > 0)) return VM_BAD_INERTIA;
    change = jet->rate * t / jet->transverse, tau = change * jet->gyration_transverse;
    decay = change * (jet->nozzle * jet->nozzle + jet->gyration_out - jet->gyration_transverse);
    if (!VM_IS_FINITE(tau + decay + jet->axial) || !vmi_vec3_finite(omega0)) return VM_NOT_FINITE;
    if (!(tau > -1 && jet->axial + jet->rate * t * jet->gyration_axial > 0)) return VM_BAD_INERTIA;
    vmi_stream_log_means(tau, &first, &second);
    decay = vmi_exp(decay * first, 0);
    vmi_sincos(omega0.z * t * (jet->axial / jet->transverse * first - 1 + change * jet->gyration_axial * second),
               &sine, &cosine);
    *omega = vmi_vec3(decay * (omega0.x * cosine - omega0.y * sine), decay * (omega0.y * cosine + omega0.x * sine),
                      omega0.z);
    return VM_OK;
}

/* ---- Chapter 5.2: the drum ---------------------------------------------------------------------------------- */

/* ---- Chapter 6: Lagrange's equations with variable mass ----------------------------------------------------- */

/* Parts of work: A, b and then a right-hand side, rates, a trial point, masses */
typedef struct VM_TAG(vmi_frozen_parts) {
    vm_real *A, *b, *rates, *trial, *masses;
} vmi_frozen_parts;
VM_API vmi_frozen_parts vmi_frozen_work(const vm_lagrange *l)
{
    vmi_frozen_parts w;
    w.A = l->work, w.b = w.A + (ptrdiff_t)l->n * l->n;
    w.rates = w.b + l->n, w.trial = w.rates + l->n, w.masses = w.trial + l->n;
    return w;
}

/* T at rates x e_i + z e_j */
VM_API vm_real vmi_frozen_energy(const vm_lagrange *l, vm_real t, const vm_real *q, int i, vm_real x, int j,
                                 vm_real z)
{
    const vmi_frozen_parts w = vmi_frozen_work(l);
    int k;
    for (k = 0; k < l->n; k++) w.trial[k] = (k == i ? x : 0) + (k == j ? z : 0);
    return l->energy(t, q, w.trial, w.masses, l->ctx);
}

/* A and b from T; steps of the size of 1/sqrt(A_ii) keep the roundings of unlike coordinates apart */
VM_API void vmi_frozen_quadratic(const vm_lagrange *l, vm_real t, const vm_real *q)
{
    const vmi_frozen_parts w = vmi_frozen_work(l);
    const int n = l->n;
    const vm_real T0 = vmi_frozen_energy(l, t, q, -1, 0, -1, 0);
    int i, j;
    for (i = 0; i < n; i++) {
        const vm_real plus = vmi_frozen_energy(l, t, q, i, 1, -1, 0);
        const vm_real minus = vmi_frozen_energy(l, t, q, i, -1, -1, 0);
        w.A[i * n + i] = (plus - T0) + (minus - T0);
        w.b[i] = (plus - minus) / 2;
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++) {
            const vm_real x = 1 / VM_SQRT(w.A[i * n + i]), z = 1 / VM_SQRT(w.A[j * n + j]);
            const vm_real same = vmi_frozen_energy(l, t, q, i, x, j, z) + vmi_frozen_energy(l, t, q, i, -x, j, -z);
            const vm_real apart = vmi_frozen_energy(l, t, q, i, x, j, -z) + vmi_frozen_energy(l, t, q, i, -x, j, z);
            w.A[i * n + j] = w.A[j * n + i] = (same - apart) / (4 * x * z);
        }
}

VM_API void vmi_frozen_freeze(const vm_lagrange *l, vm_real t, const vm_real *q)
{
    if (l->masses) l->masses(t, q, vmi_frozen_work(l).masses, l->ctx);
}

/* q' into the work */
VM_API int vmi_frozen_solve(const vm_lagrange *l, vm_real t, const vm_real *y)
{
    const vmi_frozen_parts w = vmi_frozen_work(l);
    int k;
    vmi_frozen_freeze(l, t, y);
    vmi_frozen_quadratic(l, t, y);
    for (k = 0; k < l->n; k++) w.rates[k] = y[l->n + k] - w.b[k];
    return vmi_solve_linear(l->n, w.A, w.rates);
}

/* h^6/140 of the seventh derivative against eps/h: h = 2^-7 for eps = 2^-52, 2^-3 for 2^-23 */
VM_API vm_real vmi_frozen_derivative(const vm_lagrange *l, vm_real t, const vm_real *q, const vm_real *rates, int i)
{
    const vmi_frozen_parts w = vmi_frozen_work(l);
    const vm_real h = (VM_MANT_DIG > 24 ? VM_C(0.0078125) : VM_C(0.125)) * (l->scales ? l->scales[i] : 1);
    const vm_real weights[3] = {VM_C(0.75), VM_C(-0.15), VM_C(1.0) / 60};
    vm_real sum = 0;
    int k;
    for (k = 0; k < l->n; k++) w.trial[k] = q[k];
    for (k = 3; k > 0; k--) {
        vm_real difference;
        w.trial[i] = q[i] + (vm_real)k * h;
        difference = l->energy(t, w.trial, rates, w.masses, l->ctx);
        w.trial[i] = q[i] - (vm_real)k * h;
        difference -= l->energy(t, w.trial, rates, w.masses, l->ctx);
        sum += weights[k - 1] * difference;
    }
    return sum / h;
}

VM_API int vm_lagrange_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *lagrange)
{
    const vm_lagrange *l = (const vm_lagrange *)lagrange;
    const vmi_frozen_parts w = vmi_frozen_work(l);
    int k, status = vmi_frozen_solve(l, t, y);
    if (status) return status;
    for (k = 0; k < l->n; k++) dydt[k] = w.rates[k], dydt[l->n + k] = 0;
    if (l->forces) status = l->forces(t, y, w.rates, w.masses, dydt + l->n, l->ctx);
    for (k = 0; k < l->n; k++) dydt[l->n + k] += vmi_frozen_derivative(l, t, y, w.rates, k);
    return status;
}

VM_API int vmi_frozen_good(const vm_lagrange *l)
{
    return l && l->n > 0 && l->n_masses >= 0 && l->energy && l->work && (l->n_masses == 0 || l->masses);
}

VM_API int vm_lagrange_start(vm_lagrange *l, vm_real t, const vm_real *q, const vm_real *rates, vm_real *y)
{
    vmi_frozen_parts w;
    int i, j;
    if (!vmi_frozen_good(l) || !q || !rates || !y) return VM_BAD_ARGUMENT;
    w = vmi_frozen_work(l);
    vmi_frozen_freeze(l, t, q);
    vmi_frozen_quadratic(l, t, q);
    for (i = 0; i < l->n; i++)
        for (j = 0; j < l->n; j++) w.b[i] += w.A[i * l->n + j] * rates[j];
    for (i = 0; i < l->n; i++)
        if (!VM_IS_FINITE(w.b[i]) || !VM_IS_FINITE(q[i])) return VM_NOT_FINITE;
    for (i = 0; i < l->n; i++) y[i] = q[i], y[l->n + i] = w.b[i];
    return VM_OK;
}

VM_API int vm_lagrange_rates(vm_lagrange *l, vm_real t, const vm_real *y, vm_real *rates)
{
    int k, status;
    vmi_frozen_parts w;
    if (!vmi_frozen_good(l) || !y || !rates) return VM_BAD_ARGUMENT;
    w = vmi_frozen_work(l);
    status = vmi_frozen_solve(l, t, y);
    for (k = 0; !status && k < l->n; k++)
        if (!VM_IS_FINITE(w.rates[k])) status = VM_NOT_FINITE;
    for (k = 0; !status && k < l->n; k++) rates[k] = w.rates[k];
    return status;
}

VM_API vm_real vm_frozen_derivative(vm_lagrange *l, vm_real t, const vm_real *q, const vm_real *rates, int i)
{
    if (!vmi_frozen_good(l) || !q || !rates || i < 0 || i >= l->n) return VM_NAN;
    vmi_frozen_freeze(l, t, q);
    return vmi_frozen_derivative(l, t, q, rates, i);
}

VM_API void vm_add_force(int n, vm_vec3 force, const vm_vec3 *dr, vm_vec3 moment, const vm_vec3 *domega, vm_real *Q)
{
    int k;
    for (k = 0; k < n; k++) {
        if (dr) Q[k] += vmi_dot(force, dr[k]);
        if (domega) Q[k] += vmi_dot(moment, domega[k]);
    }
}

VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi)
{
    vm_quat turn, tilt, spin;
    turn.x = turn.y = tilt.y = tilt.z = spin.x = spin.y = 0;
    vmi_sincos(psi / 2, &turn.z, &turn.w);
    vmi_sincos(theta / 2, &tilt.x, &tilt.w);
    vmi_sincos(phi / 2, &spin.z, &spin.w);
    return vmi_quat_times(vmi_quat_times(turn, tilt), spin);
}

VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine;
    vmi_sincos(psi, &s, &c), vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(0, 0, 1), axis[1] = vmi_vec3(c, s, 0), axis[2] = vmi_vec3(sine * s, -sine * c, cosine);
}

VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine;
    vmi_sincos(phi, &s, &c), vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(sine * s, sine * c, cosine), axis[1] = vmi_vec3(c, -s, 0), axis[2] = vmi_vec3(0, 0, 1);
}

VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3])
{
    vm_real s, c, sine, cosine;
    vmi_sincos(psi, &s, &c), vmi_sincos(theta, &sine, &cosine);
    if (sine == 0) return VM_SINGULAR;
    if (!VM_IS_FINITE(sine + s) || !vmi_vec3_finite(omega)) return VM_NOT_FINITE;
    rates[2] = (s * omega.x - c * omega.y) / sine;
    rates[1] = c * omega.x + s * omega.y;
    rates[0] = omega.z - rates[2] * cosine;
    return VM_OK;
}

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
