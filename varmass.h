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
    VM_BAD_OSCILLATOR = -6 /* alpha < 0, stiffness or frequency not positive, an amplitude below its own ripple */
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

/* A mass, and in this chapter's last sections all that depends on it, at time t: kg, and its rate in kg/s. Slow: it
   changes little in a period. vm_slow_mass_linear is one, whose ctx is a vm_linear_mass. */
typedef vm_real (*vm_slow_mass)(vm_real t, vm_real *rate, void *ctx);
typedef struct VM_TAG(vm_linear_mass) {
    vm_real mass, rate; /* mass + rate t */
} vm_linear_mass;
VM_API vm_real vm_slow_mass_linear(vm_real t, vm_real *rate, void *linear_mass);

/* m x'' + k x|x|^(alpha-1) = (b - c x^2) x' - r m' x' (404). Here b > 0 feeds the vibration; b and c are the eps b
   and eps c of [1], of either sign. vm_vdp_init checks alpha, k, b, c, reactive and method and fills a1, a2, a3,
   which the other functions need; the mass is for the equations of motion only. */
typedef struct VM_TAG(vm_vdp) {
    vm_real alpha, k, b, c; /* alpha >= 0; k > 0 N/m^alpha; kg/s; kg/(s m^2) */
    vm_real reactive;       /* r: 1 where what joins or leaves is at rest, 0 where it has the body's velocity */
    int method;             /* of averaging */
    vm_slow_mass mass;
    void *mass_ctx;
    vm_real a1, a2, a3;
} vm_vdp;
enum {
    VM_VDP_ATEB = 0,         /* about the exact generating solution: a1 = 1, exact to first order */
    VM_VDP_JACOBI = 1,       /* (411)-(413), exact means; the steady amplitude is right to 0.5 % for alpha <= 5 */
    VM_VDP_TRIGONOMETRIC = 2 /* a3/a1 = 1/(2 (alpha + 3)): the steady amplitude does not depend on alpha */
};
VM_API int vm_vdp_init(vm_vdp *v);

/* Amplitude at t where it was A0 at t = 0 and the mass is m.mass + m.rate t > 0; m.rate may be 0: (422), (424),
   (427), (429), (431)-(435), (437) in one, as corrected, smooth through q = 0. Right to 1e-14 but for what is
   averaged. c < 0 may carry it to infinity in a finite time: NaN from there on. */
VM_API vm_real vm_vdp_amplitude(const vm_vdp *v, vm_real t, vm_real A0, vm_linear_mass m);
/* The amplitude other than 0 that stays while the mass changes at mass_rate, (425), (430), (438); 0 where there is
   none. stable, where not null: whether the amplitudes around tend to the one returned. */
VM_API vm_real vm_vdp_steady(const vm_vdp *v, vm_real mass_rate, int *stable_or_NULL);
/* Equations for rk45 or rk87, ctx a vm_vdp: of motion, y = (x, x') (404); averaged, y = (A, psi), any mass (410),
   where x = A ca(psi). They return a status of this header, which stops the run, where the mass is not positive. */
VM_API int vm_vdp_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp);
VM_API int vm_vdp_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp);

/* -- Chapter 7.7: Laval's rotor -- */

/* The disc's centre z = x + i y (451), with the shaft's stiffness F_e(rho)/rho, which [1] calls F_e', and the
   gyroscopic constant g = Omega_p g of the remark after (516):
     m z'' + z F_e(|z|)/|z| - 2 i g z' = F_z + r m' (u - z')
   A zero field means none; mass and stiffness must be there. */
typedef struct VM_TAG(vm_complex) {
    vm_real re, im;
} vm_complex;
/* F_e(rho)/rho, N/m, and its derivative, for rho >= 0. vm_rotor_power is k rho^(alpha-1), ctx a vm_power_force. */
typedef vm_real (*vm_rotor_stiffness)(vm_real rho, vm_real *slope, void *ctx);
typedef vm_complex (*vm_rotor_force)(vm_real t, vm_complex z, vm_complex v, void *ctx);
typedef struct VM_TAG(vm_power_force) {
    vm_real k, alpha;
} vm_power_force;
VM_API vm_real vm_rotor_power(vm_real rho, vm_real *slope, void *power_force);
typedef struct VM_TAG(vm_rotor) {
    vm_slow_mass mass;
    void *mass_ctx;
    vm_rotor_stiffness stiffness;
    void *stiffness_ctx;
    vm_rotor_force force; /* F_z, N; small where averaged */
    void *force_ctx;
    vm_real gyro;     /* kg/s */
    vm_real reactive; /* r */
    vm_complex u;     /* absolute velocity of what joins or leaves, m/s */
    int samples;      /* of a period in an average; default 32, enough for polynomials of degree 15 */
} vm_rotor;

/* rho and phi in (-pi, pi] (448) */
VM_API void vm_rotor_polar(vm_complex z, vm_real *rho, vm_real *phi);
/* Angular momentum Im(conj z m z') - g |z|^2, kg m^2/s: constant where r = 1, u = 0, F_z = 0 */
VM_API vm_real vm_rotor_momentum(const vm_rotor *r, vm_real mass, vm_complex z, vm_complex v);
/* Equations of motion (449), (450) for rk45 or rk87, ctx a vm_rotor, y = (x, y, x', y') */
VM_API int vm_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);

/* Small nonlinearity: two circular motions (460), (461) of the frequency omega = sqrt(F_e'(0)/m),
     z = P e^(i phi) + N e^(-i phi),  z' = i omega (P e^(i phi) - N e^(-i phi)),
     P = A1 e^(i theta1),  N = A2 e^(-i theta2),
   y = (Re P, Im P, Re N, Im N, phi), phi' = omega, from and to y = (x, y, x', y') at time t. The equations
   (470)-(473) exactly, and averaged over phi while P and N stay: forward and backward motion are in 1:1 resonance,
   so that the average over psi1 and psi2 apart, (474)-(477), is wrong unless f turns with z. In P and N nothing is
   singular where A1 or A2 is 0. All that differs from m z'' + F_e'(0) z = 0 is perturbation: F_z, u, g, F_e'(rho) -
   F_e'(0). */
VM_API int vm_rotor_split(const vm_rotor *r, vm_real t, const vm_real *motion, vm_real phi, vm_real *y);
VM_API int vm_rotor_join(const vm_rotor *r, vm_real t, const vm_real *y, vm_real *motion);
VM_API int vm_rotor_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);
VM_API int vm_rotor_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);

/* Strong nonlinearity: nearly circular motion z = A e^(i psi), z' = i W z, of the frequency W of m W^2 - 2 g W =
   F_e'(A), forward (sense >= 0) or backward. Averaged equations (506), (507) with g, y = (A, psi). A errs by the
   order of the loads over times of their inverse; the phase adds that up where F_e' is not constant: 0.005 were
   measured for loads that turn with z, order 1 for others. Not for a linear F_e with loads that do not turn with z:
   they send the motion off the circle. */
VM_API vm_real vm_rotor_frequency(const vm_rotor *r, vm_real A, vm_real mass, int sense);
VM_API int vm_rotor_forward_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);
VM_API int vm_rotor_backward_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor);
/* The same without F_z: the radius when the mass has gone from mass0, where it was A0, to mass, of
     A^4 (g^2 + m F_e'(A)) = const, r = 1, which is A^2 (m W - g) = const;  A^4 F_e'(A) m^(2r-1) = const, g = 0 (509)
   NaN for g != 0 and r != 1, where the course of the mass matters, and where no radius is found going from A0. For
   powers it is A0 vm_osc_amplitude_law(mass/mass0, 0, r, alpha). */
VM_API vm_real vm_rotor_amplitude(const vm_rotor *r, vm_real A0, vm_real mass0, vm_real mass);

/* -- Chapter 7.8: two bodies with a nonlinear connection -- */

/* Equal masses m with k (x - y)|x - y|^(alpha-1) between them, and -r m' x', -r m' y' (517), (518). y = (x, y, x',
   y'). */
typedef struct VM_TAG(vm_pair) {
    vm_real alpha, k, reactive; /* alpha >= 0; k > 0 N/m^alpha; r */
    vm_slow_mass mass;          /* not needed by vm_pair_at */
    void *mass_ctx;
} vm_pair;
VM_API int vm_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair);
/* q = x + y drifts, p = y - x vibrates (520)-(522): modes = (A, psi, q, q') with A the mean amplitude of p, free of
   its first ripple, so that any initial velocities do. Averaged equations of the modes for any mass. */
VM_API int vm_pair_split(const vm_pair *p, vm_real t, const vm_real *y, vm_real *modes);
VM_API int vm_pair_join(const vm_pair *p, vm_real t, const vm_real *modes, vm_real *y);
VM_API int vm_pair_averaged_rhs(vm_real t, const vm_real *modes, vm_real *dmodes, void *pair);
/* y at t where it was y0 at t = 0, for the mass m.mass + m.rate t, closed: (528), (529) with p0 = y0 - x0. Error of
   order m.rate over times of order 1/m.rate. y may be y0. */
VM_API int vm_pair_at(const vm_pair *p, vm_real t, const vm_real *y0, vm_linear_mass m, vm_real *y);

/* -- Chapter 8: harmonic excitation -- */

/* m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + force cos theta, theta' = nu, where m, k, nu, force may drift slowly:
   now holds them at all times, or drift, where not null, gets it so and changes what drifts. vm_forced_init checks
   alpha, b, reactive and now at t = 0, and prepares what the averaged functions need: call it first. */
typedef struct VM_TAG(vm_forced_now) {
    vm_real mass, mass_rate; /* kg, kg/s */
    vm_real k, k_rate;       /* N/m^alpha, per s */
    vm_real nu, nu_rate;     /* rad/s, rad/s^2 */
    vm_real force;           /* N */
} vm_forced_now;
typedef struct VM_TAG(vm_forced) {
    vm_real alpha, b, reactive; /* alpha >= 0; kg/s; r */
    vm_forced_now now;
    void (*drift)(vm_real t, vm_forced_now *now, void *ctx);
    void *drift_ctx;
    vm_real pi, Om1, G; /* Pi_alpha, w = Om1 sqrt(k/m) A^((alpha-1)/2), the force's share; by vm_forced_init */
    vm_real c[5], s[5]; /* ca = sum c[j] cos((2j+1) pi psi/Pi), sa = sum s[j] sin(...), j = 0 .. */
} vm_forced;
VM_API int vm_forced_init(vm_forced *f);

/* Equations for rk45 or rk87, ctx a vm_forced: of motion, y = (x, x', theta); the same in amplitude and Ateb phase,
   exactly, y = (A, psi, theta), singular at A = 0; averaged near the main resonance nu = w(A), y = (A, delta,
   theta), where delta is the phase before the force. The averaged ones err by the order of b, m' and force over
   times of their inverses, off the resonance by more. */
VM_API int vm_forced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced);
VM_API int vm_forced_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced);
VM_API int vm_forced_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced);
/* (x, x', theta) to the mean (A, delta, theta), and back, at time t. The ripple of the amplitude is taken out and put
   back: without that the error is of order 1 where alpha != 1. */
VM_API int vm_forced_split(const vm_forced *f, vm_real t, const vm_real *motion, vm_real *y);
VM_API int vm_forced_join(const vm_forced *f, vm_real t, const vm_real *y, vm_real *motion);

/* Steady vibrations, all quantities as they are at time t: at most three, their amplitudes growing. The number of
   them, or a negative status. Those far from w(A) = nu are labels only: the averaged equations hold near the
   resonance. */
typedef struct VM_TAG(vm_steady) {
    vm_real nu, A, delta;
    vm_real trace, det; /* of the averaged equations there: rates lambda^2 - trace lambda + det = 0 */
    int stable;         /* det > 0 and trace < 0; det < 0 is a saddle */
} vm_steady;
VM_API int vm_forced_steady(const vm_forced *f, vm_real t, vm_steady steady[3]);
/* The amplitude-frequency curve, traced by its amplitude: the steady vibrations of amplitude A at any nu > 0, the
   backbone w(A) in the middle between two. Their number, 0 where the force is too small for A, or a negative
   status. */
VM_API int vm_forced_curve(const vm_forced *f, vm_real t, vm_real A, vm_steady curve[2]);
/* The amplitude where the curve meets the backbone, its largest; infinite without damping */
VM_API vm_real vm_forced_peak(const vm_forced *f, vm_real t);

/* Passage through the resonance, all rates as they are at time t. The backbone's amplitude A at nu; torque: the
   drift of w - nu over the force's hold on it, below 1 the vibration may be captured and follow A, with the phase
   delta, above 1 it passes; jump: half the range of the relative change of A in a quick passage, torque >> 1, over
   all phases. For alpha = 1 A cannot be told from nu: it is the amplitude given. */
typedef struct VM_TAG(vm_passage) {
    vm_real A, torque, delta, jump; /* delta NaN where torque > 1 */
} vm_passage;
VM_API int vm_forced_passage(const vm_forced *f, vm_real t, vm_real amplitude, vm_passage *passage);

/* -- Diagnostics of slow vibrations -- */

/* Any trajectory, x(t) and x'(t): a route's, a law's, an integrator's dense output. */
typedef void (*vm_motion)(vm_real t, vm_real *x, vm_real *v, void *ctx);
typedef struct VM_TAG(vm_point) {
    vm_real t, x, v;
} vm_point;
enum {
    VM_TURNING_POINTS = 0, /* x' = 0 */
    VM_ZERO_CROSSINGS = 1  /* x = 0 */
};
/* The number of changes of sign in (t0, t1], looked for every step (or a little less; a small part of a period,
   negative where t1 < t0) and located to an eps of t; the first room of them are written. A negative status for a
   step of the wrong sign, or a trajectory that is not finite. */
VM_API long vm_find_points(vm_motion motion, void *ctx, int kind, vm_real t0, vm_real t1, vm_real step, long room,
                           vm_point *points);
/* The same in the last step of an rk45 or rk87, for components x and v of its state; to be called after every step.
   buffer: room for a state. */
VM_API long vm_find_points_of_step(rk45 *s, int x, int v, int kind, vm_real *buffer, long room, vm_point *points);
/* Largest |law(t)/observed - 1|, observed |x| at turning points, |v| at zero crossings */
VM_API vm_real vm_envelope_error(int kind, long n, const vm_point *points, vm_real (*law)(vm_real t, void *ctx),
                                 void *ctx);
/* q/Om, what averaging takes for small: q = ((2r-1) m' + 2b)/m + k'/k and the rate Om of the Ateb phase at
   amplitude A. The amplitude laws err by about (q/Om)^2, waveforms by q/Om over times of order 1/q. */
VM_API vm_real vm_adiabaticity(vm_real A, vm_real mass, vm_real mass_rate, vm_real k, vm_real k_rate, vm_real b,
                               vm_real reactive, vm_real alpha);

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
    case VM_BAD_OSCILLATOR: return "alpha, stiffness, frequency or amplitude out of range";
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

VM_API vm_real vm_slow_mass_linear(vm_real t, vm_real *rate, void *linear_mass)
{
    const vm_linear_mass *m = (const vm_linear_mass *)linear_mass;
    *rate = m->rate;
    return m->mass + m->rate * t;
}

/* The mass at t; VM_BAD_MASS, VM_NOT_FINITE */
VM_API int vmi_slow_mass(vm_slow_mass law, void *ctx, vm_real t, vm_real *mass, vm_real *rate)
{
    *mass = law(t, rate, ctx);
    if (!VM_IS_FINITE(*mass) || !VM_IS_FINITE(*rate)) return VM_NOT_FINITE;
    return *mass > 0 ? VM_OK : VM_BAD_MASS;
}

/* (e^x - 1)/x, entire: 1 at 0, within 2 eps */
VM_API vm_real vmi_slow_phi(vm_real x)
{
    vm_real p, p_lo;
    int k;
    if (x == 0) return 1;
    if (!(VM_FABS(x) < VM_C(0.34))) return x > VM_MAX ? x : (vmi_exp(x, 0) - 1) / x;
    p = vmi_exp_core(x, 0, &k, &p_lo);
    return p / x;
}

/* ln(m/m0) and the integral of dt/m for the linear mass, smooth through m' = 0; 0 where a mass is not positive */
VM_API int vmi_slow_linear(vm_linear_mass m, vm_real t, vm_real *ln_ratio, vm_real *integral)
{
    const vm_real growth = m.rate * t / m.mass;
    if (!(m.mass > 0) || !(growth > -1) || !VM_IS_FINITE(m.mass) || !VM_IS_FINITE(growth) || !VM_IS_FINITE(t))
        return 0;
    *ln_ratio = vmi_two_log(vmi_two_sum(1, growth)).hi;
    *integral = t / m.mass * (growth == 0 ? 1 : *ln_ratio / growth);
    return 1;
}

/* k x|x|^(alpha-1) */
VM_API vm_real vmi_slow_elastic(vm_real x, vm_real k, vm_real alpha)
{
    if (alpha == 1 || x == 0) return k * x;
    if (alpha == 3) return k * x * x * x;
    return VM_COPYSIGN(k * vmi_raised(VM_FABS(x), alpha), x);
}

/* Om = sqrt((alpha+1)/2) sqrt(k/m) A^((alpha-1)/2), the rate of the Ateb phase; 0 at rest, where it may be infinite
   */
VM_API vm_real vmi_slow_rate(vm_real A, vm_real k, vm_real mass, vm_real alpha)
{
    if (A == 0 && alpha < 1) return 0;
    return VM_SQRT((alpha + 1) / 2 * (k / mass)) * vmi_raised(VM_FABS(A), (alpha - 1) / 2);
}

/* x = A ca(psi), x' = -sqrt(2k/((alpha+1) m)) A^((alpha+1)/2) sa(psi), and back */
VM_API void vmi_slow_motion(vm_real A, vm_real psi, vm_real k, vm_real mass, vm_real alpha, vm_real *x, vm_real *v)
{
    vm_real sa, ca;
    ateb_saca(psi, alpha, &sa, &ca);
    *x = A * ca;
    *v = -VM_SQRT(2 / (alpha + 1) * (k / mass)) * vmi_raised(A, (alpha + 1) / 2) * sa;
}

VM_API void vmi_slow_phase(vm_real x, vm_real v, vm_real k, vm_real mass, vm_real alpha, vm_real *A, vm_real *psi)
{
    const vm_real scaled = -v * VM_SQRT((alpha + 1) / 2 * (mass / k)); /* A^((alpha+1)/2) sa */
    const vm_real from_v = vmi_raised(VM_FABS(scaled), 2 / (alpha + 1)), from_x = VM_FABS(x);
    const vm_real large = from_x > from_v ? from_x : from_v, small = from_x > from_v ? from_v : from_x;
    *A = large > 0 ? large * vmi_raised(1 + vmi_raised(small / large, alpha + 1), 1 / (alpha + 1)) : large;
    *psi = ateb_phase(scaled, x, alpha);
}

VM_API int vm_vdp_init(vm_vdp *v)
{
    vm_real C2, C4, C6, m;
    if (!v || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(v->alpha) || !VM_IS_FINITE(v->k) || !VM_IS_FINITE(v->b) || !VM_IS_FINITE(v->c) ||
        !VM_IS_FINITE(v->reactive))
        return VM_NOT_FINITE;
    if (!(v->alpha >= 0) || !(v->k > 0)) return VM_BAD_OSCILLATOR;
    v->a1 = 1;
    v->a2 = 2 / (v->alpha + 3);
    if (v->method == VM_VDP_ATEB) v->a3 = 2 / (v->alpha + 1) * ateb_mean(v->alpha, 2, 2);
    if (v->method == VM_VDP_TRIGONOMETRIC) v->a3 = v->a2 / 4;
    if (v->method != VM_VDP_JACOBI) return VM_OK;
    m = vm_osc_m_jacobi(v->alpha);
    jacobi_cn_means(m, &C2, &C4, &C6);
    v->a2 = (1 - m) - (1 - 2 * m) * C2 - m * C4;
    v->a1 = (v->alpha + 3) / 2 * v->a2; /* (411), since (1 - m) + m C4 = 2 a2 */
    v->a3 = (1 - m) * C2 - (1 - 2 * m) * C4 - m * C6;
    return VM_OK;
}

/* 2b - (2r-1) m', what feeds the vibration */
VM_API vm_real vmi_vdp_drive(const vm_vdp *v, vm_real mass_rate)
{
    return 2 * v->b - (2 * v->reactive - 1) * mass_rate;
}

/* 1/A^2 = e^-F (1/A0^2 + 2 c a3/a1 int e^F dt/m) (416). F = drive a2/a1 int dt/m is linear in int dt/m where m' is
   constant, so that the integral is phi(F) int dt/m. Written with e^-|F| and the larger of the two terms taken out.
   */
VM_API vm_real vm_vdp_amplitude(const vm_vdp *v, vm_real t, vm_real A0, vm_linear_mass m)
{
    vm_real ln_ratio, integral, F, damping, root, e, s, denominator;
    if (!VM_IS_FINITE(A0) || !(v->a1 > 0) || !vmi_slow_linear(m, t, &ln_ratio, &integral)) return VM_NAN;
    F = vmi_vdp_drive(v, 0) * (v->a2 / v->a1) * integral - (2 * v->reactive - 1) * (v->a2 / v->a1) * ln_ratio;
    e = vmi_exp(-VM_FABS(F), 0);
    damping = 2 * v->c * (v->a3 / v->a1) * integral * vmi_slow_phi(-VM_FABS(F));
    root = VM_SQRT(VM_FABS(damping));
    s = VM_FABS(A0) * root; /* squared, and with damping's sign, beside 1 or e^-|F| */
    if (s > 1) denominator = (F > 0 ? e / s : 1 / s) / s + VM_COPYSIGN(1, damping), A0 = VM_COPYSIGN(1 / root, A0);
    else denominator = (F > 0 ? e : 1) + VM_COPYSIGN(s * s, damping);
    return denominator < 0 ? VM_NAN : A0 * VM_SQRT((F > 0 ? 1 : e) / denominator);
}

VM_API vm_real vm_vdp_steady(const vm_vdp *v, vm_real mass_rate, int *stable_or_NULL)
{
    const vm_real drive = vmi_vdp_drive(v, mass_rate);
    const int exists = (drive > 0 && v->c > 0) || (drive < 0 && v->c < 0);
    if (!VM_IS_FINITE(drive) || !(v->a1 > 0)) return VM_NAN;
    if (stable_or_NULL) *stable_or_NULL = exists ? v->c > 0 : drive < 0 || (drive == 0 && v->c > 0);
    return exists ? VM_SQRT(drive / v->c * (v->a2 / (2 * v->a3))) : 0;
}

VM_API int vm_vdp_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_slow_mass(v->mass, v->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[1];
    dydt[1] = ((v->b - v->c * y[0] * y[0] - v->reactive * rate) * y[1] - vmi_slow_elastic(y[0], v->k, v->alpha)) /
              mass;
    return VM_OK;
}

VM_API int vm_vdp_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_slow_mass(v->mass, v->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[0] / (v->a1 * mass) * (vmi_vdp_drive(v, rate) * v->a2 / 2 - v->c * y[0] * y[0] * v->a3);
    dydt[1] = vmi_slow_rate(y[0], v->k, mass, v->alpha);
    return VM_OK;
}

/* ---- Chapter 7.7: Laval's rotor ----------------------------------------------------------------------------- */

VM_API vm_complex vmi_complex(vm_real re, vm_real im)
{
    vm_complex z;
    z.re = re, z.im = im;
    return z;
}
VM_API vm_complex vmi_c_add(vm_complex a, vm_complex b) { return vmi_complex(a.re + b.re, a.im + b.im); }
VM_API vm_complex vmi_c_sub(vm_complex a, vm_complex b) { return vmi_complex(a.re - b.re, a.im - b.im); }
VM_API vm_complex vmi_c_scale(vm_real c, vm_complex a) { return vmi_complex(c * a.re, c * a.im); }
VM_API vm_complex vmi_c_times_i(vm_real c, vm_complex a) { return vmi_complex(-c * a.im, c * a.re); } /* i c a */
VM_API vm_complex vmi_c_times(vm_complex a, vm_complex b)
{
    return vmi_complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}
VM_API vm_complex vmi_c_conjugate(vm_complex a) { return vmi_complex(a.re, -a.im); }
VM_API vm_complex vmi_c_turn(vm_real angle) /* e^(i angle) */
{
    vm_complex e;
    vmi_sincos(angle, &e.im, &e.re);
    return e;
}

VM_API vm_real vmi_c_modulus(vm_complex z)
{
    const vm_real x = VM_FABS(z.re), y = VM_FABS(z.im), large = x > y ? x : y, ratio = (x > y ? y : x) / large;
    return large > 0 && VM_IS_FINITE(large) ? large * VM_SQRT(1 + ratio * ratio) : x + y;
}

VM_API vm_real vm_rotor_power(vm_real rho, vm_real *slope, void *power_force)
{
    const vm_power_force *p = (const vm_power_force *)power_force;
    *slope = p->alpha == 1 ? 0 : p->k * (p->alpha - 1) * vmi_raised(rho, p->alpha - 2);
    return p->k * vmi_raised(rho, p->alpha - 1);
}

VM_API void vm_rotor_polar(vm_complex z, vm_real *rho, vm_real *phi)
{
    *rho = vmi_c_modulus(z);
    *phi = ateb_phase(z.im, z.re, 1);
}

VM_API vm_real vm_rotor_momentum(const vm_rotor *r, vm_real mass, vm_complex z, vm_complex v)
{
    return mass * (z.re * v.im - z.im * v.re) - r->gyro * (z.re * z.re + z.im * z.im);
}

/* F_z + r m' u */
VM_API vm_complex vmi_rotor_drive(const vm_rotor *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    const vm_complex thrust = vmi_c_scale(r->reactive * rate, r->u);
    return r->force ? vmi_c_add(r->force(t, z, v, r->force_ctx), thrust) : thrust;
}

VM_API int vm_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    const vm_rotor *r = (const vm_rotor *)rotor;
    const vm_complex z = vmi_complex(y[0], y[1]), v = vmi_complex(y[2], y[3]);
    vm_real mass, rate, stiffness, slope;
    vm_complex force;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &mass, &rate);
    if (status) return status;
    stiffness = r->stiffness(vmi_c_modulus(z), &slope, r->stiffness_ctx);
    force = vmi_c_add(vmi_rotor_drive(r, t, rate, z, v), vmi_c_times_i(2 * r->gyro, v));
    dydt[0] = v.re, dydt[1] = v.im;
    dydt[2] = (force.re - r->reactive * rate * v.re - stiffness * z.re) / mass;
    dydt[3] = (force.im - r->reactive * rate * v.im - stiffness * z.im) / mass;
    return VM_OK;
}

typedef struct VM_TAG(vmi_rotor_state) {
    vm_real mass, rate, omega; /* omega of the small vibration */
} vmi_rotor_state;

VM_API int vmi_rotor_now(const vm_rotor *r, vm_real t, vmi_rotor_state *now)
{
    vm_real slope;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &now->mass, &now->rate);
    if (status) return status;
    now->omega = VM_SQRT(r->stiffness(0, &slope, r->stiffness_ctx) / now->mass);
    return now->omega > 0 && VM_IS_FINITE(now->omega) ? VM_OK : VM_BAD_OSCILLATOR;
}

VM_API int vm_rotor_split(const vm_rotor *r, vm_real t, const vm_real *motion, vm_real phi, vm_real *y)
{
    const vm_complex z = vmi_complex(motion[0], motion[1]), back = vmi_c_turn(-phi);
    vmi_rotor_state now;
    vm_complex turned, P, N;
    const int status = vmi_rotor_now(r, t, &now);
    if (status) return status;
    turned = vmi_c_times_i(-1 / now.omega, vmi_complex(motion[2], motion[3])); /* z'/(i omega) */
    P = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_add(z, turned)), back);
    N = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_sub(z, turned)), vmi_c_conjugate(back));
    y[0] = P.re, y[1] = P.im, y[2] = N.re, y[3] = N.im, y[4] = phi;
    return VM_OK;
}

/* z and z' where phi is the angle of turn */
VM_API void vmi_rotor_motion(const vm_real *y, vm_complex turn, vm_real omega, vm_complex *z, vm_complex *v)
{
    const vm_complex P = vmi_c_times(vmi_complex(y[0], y[1]), turn);
    const vm_complex N = vmi_c_times(vmi_complex(y[2], y[3]), vmi_c_conjugate(turn));
    *z = vmi_c_add(P, N);
    *v = vmi_c_times_i(omega, vmi_c_sub(P, N));
}

VM_API int vm_rotor_join(const vm_rotor *r, vm_real t, const vm_real *y, vm_real *motion)
{
    vmi_rotor_state now;
    vm_complex z, v;
    const int status = vmi_rotor_now(r, t, &now);
    if (status) return status;
    vmi_rotor_motion(y, vmi_c_turn(y[4]), now.omega, &z, &v);
    motion[0] = z.re, motion[1] = z.im, motion[2] = v.re, motion[3] = v.im;
    return VM_OK;
}

/* P' and N' (470)-(473) at the fast phase phi:
     P' = -i e^(-i phi) f/(2 omega),  N' = i e^(i phi) f/(2 omega),
     m f = F + 2 i g z' - (F_e' - F_e'(0)) z - (r - 1/2) m' z'
   F with r m' u; the half that is missing from r comes from omega'. */
VM_API void vmi_rotor_rates(const vm_rotor *r, vm_real t, const vmi_rotor_state *now, const vm_real *y, vm_real phi,
                            vm_complex *dP, vm_complex *dN)
{
    const vm_complex turn = vmi_c_turn(phi);
    const vm_real push = 1 / (2 * now->omega * now->mass);
    vm_real slope, extra;
    vm_complex z, v, f;
    vmi_rotor_motion(y, turn, now->omega, &z, &v);
    extra = r->stiffness(vmi_c_modulus(z), &slope, r->stiffness_ctx) - now->mass * now->omega * now->omega;
    f = vmi_c_add(vmi_rotor_drive(r, t, now->rate, z, v), vmi_c_times_i(2 * r->gyro, v));
    f = vmi_c_sub(f, vmi_c_add(vmi_c_scale(extra, z), vmi_c_scale((r->reactive - VM_C(0.5)) * now->rate, v)));
    *dP = vmi_c_times_i(-push, vmi_c_times(f, vmi_c_conjugate(turn)));
    *dN = vmi_c_times_i(push, vmi_c_times(f, turn));
}

VM_API int vmi_rotor_samples(const vm_rotor *r) { return r->samples > 0 ? r->samples : 32; }

/* The mean of so many samples in a period from y[4] on */
VM_API int vmi_rotor_mean(vm_real t, const vm_real *y, vm_real *dydt, const vm_rotor *r, int samples)
{
    const vm_real share = 1 / (vm_real)samples;
    vm_complex P = {0, 0}, N = {0, 0}, dP, dN;
    vmi_rotor_state now;
    const int status = vmi_rotor_now(r, t, &now);
    int j;
    if (status) return status;
    for (j = 0; j < samples; j++) {
        vmi_rotor_rates(r, t, &now, y, y[4] + 2 * VM_PI * share * (vm_real)j, &dP, &dN);
        P = vmi_c_add(P, dP), N = vmi_c_add(N, dN);
    }
    dydt[0] = P.re * share, dydt[1] = P.im * share, dydt[2] = N.re * share, dydt[3] = N.im * share;
    dydt[4] = now.omega;
    return VM_OK;
}

VM_API int vm_rotor_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    return vmi_rotor_mean(t, y, dydt, (const vm_rotor *)rotor, 1);
}

VM_API int vm_rotor_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    const vm_rotor *r = (const vm_rotor *)rotor;
    return vmi_rotor_mean(t, y, dydt, r, vmi_rotor_samples(r));
}

/* W = (g +- S)/m, S^2 = g^2 + m F_e', without the difference of near numbers */
VM_API vm_real vmi_rotor_root(vm_real gyro, vm_real mass, vm_real stiffness, int sense)
{
    const vm_real forward = sense < 0 ? -1 : 1, g = forward * gyro, S = VM_SQRT(gyro * gyro + mass * stiffness);
    return forward * (g > 0 ? (g + S) / mass : stiffness / (S - g));
}

VM_API vm_real vm_rotor_frequency(const vm_rotor *r, vm_real A, vm_real mass, int sense)
{
    vm_real slope;
    if (!(A >= 0) || !VM_IS_FINITE(A) || !(mass > 0) || !VM_IS_FINITE(mass)) return VM_NAN;
    return vmi_rotor_root(r->gyro, mass, r->stiffness(A, &slope, r->stiffness_ctx), sense);
}

/* (504), (505) averaged. The torque gives (A^2 (m W - g))' = (1 - r) m' A^2 W + A <Im D>, the radial balance
   psi' - W = -<Re D>/(2 A (m W - g)), D = (F_z + r m' u) e^(-i psi); m W - g = +-S, S^2 = g^2 + m F_e'. */
VM_API int vmi_rotor_circular(vm_real t, const vm_real *y, vm_real *dydt, const vm_rotor *r, int sense)
{
    const int samples = vmi_rotor_samples(r);
    vm_real mass, rate, stiffness, slope, W, S, growth;
    vm_complex sum = {0, 0};
    int j;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &mass, &rate);
    if (status) return status;
    stiffness = r->stiffness(y[0], &slope, r->stiffness_ctx);
    W = vmi_rotor_root(r->gyro, mass, stiffness, sense), S = mass * W - r->gyro;
    if (!(S * S > 0)) return VM_BAD_OSCILLATOR;
    for (j = 0; j < samples; j++) {
        const vm_complex turn = vmi_c_turn(y[1] + 2 * VM_PI * (vm_real)j / (vm_real)samples),
                         z = vmi_c_scale(y[0], turn);
        const vm_complex D = vmi_rotor_drive(r, t, rate, z, vmi_c_times_i(W, z));
        sum = vmi_c_add(sum, vmi_c_times(D, vmi_c_conjugate(turn)));
    }
    sum = vmi_c_scale(1 / (vm_real)samples, sum);
    growth = ((1 - r->reactive) * rate * W + sum.im / y[0]) / S - rate * stiffness / (2 * S * S);
    dydt[0] = y[0] * growth / (2 + mass * slope * y[0] / (2 * S * S));
    dydt[1] = W - sum.re / (2 * y[0] * S);
    return VM_OK;
}

VM_API int vm_rotor_forward_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    return vmi_rotor_circular(t, y, dydt, (const vm_rotor *)rotor, 1);
}

VM_API int vm_rotor_backward_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    return vmi_rotor_circular(t, y, dydt, (const vm_rotor *)rotor, -1);
}

/* The zero of f in [a, b], where it has the values fa, fb of opposite signs: regula falsi whose standing end is
   halved (Illinois), a bisection wherever that does not halve the interval in three steps; to the resolution of x
   */
VM_API vm_real vmi_slow_zero(vm_real (*f)(vm_real x, void *ctx), void *ctx, vm_real a, vm_real b, vm_real fa,
                             vm_real fb)
{
    vm_real width = VM_FABS(b - a);
    int i, side = 0;
    if (fa == 0 || fb == 0) return fa == 0 ? a : b;
    for (i = 1; i < 3 * VM_MANT_DIG + 60; i++) {
        vm_real x = a - fa * ((b - a) / (fb - fa)), fx;
        if (i % 4 == 0) {
            if (VM_FABS(b - a) > width / 8) x = a + (b - a) / 2, side = 0;
            width = VM_FABS(b - a);
        }
        if (!((x > a) == (x < b)) || x == a || x == b) x = a + (b - a) / 2;
        if (x == a || x == b) break;
        fx = f(x, ctx);
        if (fx == 0) return x;
        if ((fx > 0) == (fb > 0)) {
            b = x, fb = fx;
            if (side == 1) fa /= 2;
            side = 1;
        } else {
            a = x, fa = fx;
            if (side == -1) fb /= 2;
            side = -1;
        }
    }
    return VM_FABS(fa) < VM_FABS(fb) ? a : b;
}

/* ln of the invariant over its first value at the radius A0 e^x */
typedef struct VM_TAG(vmi_rotor_orbit) {
    const vm_rotor *r;
    vm_real A0, mass, first; /* first: that of g^2 + m F_e' */
} vmi_rotor_orbit;

VM_API vm_real vmi_rotor_invariant(vm_real x, void *orbit)
{
    const vmi_rotor_orbit *o = (const vmi_rotor_orbit *)orbit;
    vm_real slope;
    const vm_real stiffness = o->r->stiffness(o->A0 * vmi_exp(x, 0), &slope, o->r->stiffness_ctx);
    const vm_real ratio = (o->r->gyro * o->r->gyro + o->mass * stiffness) / o->first;
    return ratio > 0 && VM_IS_FINITE(ratio) ? 4 * x + vmi_log(ratio).hi : VM_NAN;
}

VM_API vm_real vm_rotor_amplitude(const vm_rotor *r, vm_real A0, vm_real mass0, vm_real mass)
{
    vmi_rotor_orbit o;
    vm_real slope, here, there, step = VM_C(0.0625), x = 0;
    int bounded = 0;
    if (!(A0 > 0) || !(mass0 > 0) || !(mass > 0) || !VM_IS_FINITE(A0) || !VM_IS_FINITE(mass0) ||
        !VM_IS_FINITE(mass) || (r->gyro != 0 && r->reactive != 1))
        return VM_NAN;
    if (r->gyro == 0) mass = vmi_raised(mass / mass0, 2 * r->reactive - 1), mass0 = 1;
    o.r = r, o.A0 = A0, o.mass = mass;
    o.first = r->gyro * r->gyro + mass0 * r->stiffness(A0, &slope, r->stiffness_ctx);
    here = vmi_rotor_invariant(0, &o);
    if (here == 0 || here != here) return here == 0 ? A0 : VM_NAN;
    for (step = here > 0 ? -step : step;; step = bounded ? step : 2 * step) { /* outward to a change of sign */
        there = vmi_rotor_invariant(x + step, &o);
        while (there != there) { /* F_e' is no number there */
            step /= 2, bounded = 1;
            if (VM_FABS(step) < VM_EPSILON) return VM_NAN;
            there = vmi_rotor_invariant(x + step, &o);
        }
        if (there == 0 || (there > 0) != (here > 0)) break;
        x += step, here = there;
    }
    return A0 * vmi_exp(vmi_slow_zero(vmi_rotor_invariant, &o, x, x + step, here, there), 0);
}

/* ---- Chapter 7.8: two bodies with a nonlinear connection ---------------------------------------------------- */

VM_API int vm_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    const vm_pair *p = (const vm_pair *)pair;
    const vm_real force = vmi_slow_elastic(y[0] - y[1], p->k, p->alpha);
    vm_real mass, rate;
    const int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[2], dydt[1] = y[3];
    dydt[2] = (-force - p->reactive * rate * y[2]) / mass;
    dydt[3] = (force - p->reactive * rate * y[3]) / mass;
    return VM_OK;
}

VM_API int vmi_pair_check(const vm_pair *p, vm_real mass, vm_real rate)
{
    if (!VM_IS_FINITE(p->alpha) || !VM_IS_FINITE(p->k) || !VM_IS_FINITE(p->reactive) || !VM_IS_FINITE(mass) ||
        !VM_IS_FINITE(rate))
        return VM_NOT_FINITE;
    if (!(mass > 0)) return VM_BAD_MASS;
    return p->alpha >= 0 && p->k > 0 ? VM_OK : VM_BAD_OSCILLATOR;
}

/* A over its mean at phase psi, (1 + q sa ca/(2 Om))^(2/(alpha+3)), q = (2r-1) m'/m, Om at the mean A */
VM_API vm_real vmi_pair_ripple(const vm_pair *p, vm_real mass, vm_real rate, vm_real A, vm_real psi)
{
    const vm_real q = (2 * p->reactive - 1) * rate / mass, Om = vmi_slow_rate(A, 2 * p->k, mass, p->alpha);
    vm_real sa, ca;
    ateb_saca(psi, p->alpha, &sa, &ca);
    return vmi_raised(1 + q / (2 * Om) * sa * ca, 2 / (p->alpha + 3));
}

VM_API int vmi_pair_split(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *y, vm_real *modes)
{
    vm_real exact, A;
    int i;
    for (i = 0; i < 4; i++)
        if (!VM_IS_FINITE(y[i])) return VM_NOT_FINITE;
    modes[3] = y[2] + y[3], modes[2] = y[0] + y[1];
    vmi_slow_phase(y[1] - y[0], y[3] - y[2], 2 * p->k, mass, p->alpha, &exact, &modes[1]);
    A = exact;
    for (i = 0; i < 3 && exact > 0; i++) A = exact / vmi_pair_ripple(p, mass, rate, A, modes[1]);
    modes[0] = A;
    return VM_OK;
}

VM_API void vmi_pair_join(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *modes, vm_real *y)
{
    const vm_real A = modes[0] > 0 ? modes[0] * vmi_pair_ripple(p, mass, rate, modes[0], modes[1]) : modes[0];
    const vm_real q = modes[2], dq = modes[3];
    vm_real x, v;
    vmi_slow_motion(A, modes[1], 2 * p->k, mass, p->alpha, &x, &v);
    y[0] = (q - x) / 2, y[1] = (q + x) / 2;
    y[2] = (dq - v) / 2, y[3] = (dq + v) / 2;
}

VM_API int vm_pair_split(const vm_pair *p, vm_real t, const vm_real *y, vm_real *modes)
{
    vm_real rate, mass = p->mass(t, &rate, p->mass_ctx);
    const int status = vmi_pair_check(p, mass, rate);
    return status ? status : vmi_pair_split(p, mass, rate, y, modes);
}

VM_API int vm_pair_join(const vm_pair *p, vm_real t, const vm_real *modes, vm_real *y)
{
    vm_real rate, mass = p->mass(t, &rate, p->mass_ctx);
    const int status = vmi_pair_check(p, mass, rate);
    if (!status) vmi_pair_join(p, mass, rate, modes, y);
    return status;
}

VM_API int vm_pair_averaged_rhs(vm_real t, const vm_real *modes, vm_real *dmodes, void *pair)
{
    const vm_pair *p = (const vm_pair *)pair;
    vm_real mass, rate;
    const int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dmodes[0] = -(2 * p->reactive - 1) * rate / ((p->alpha + 3) * mass) * modes[0];
    dmodes[1] = vmi_slow_rate(modes[0], 2 * p->k, mass, p->alpha);
    dmodes[2] = modes[3];
    dmodes[3] = -p->reactive * rate / mass * modes[3];
    return VM_OK;
}

/* Powers of m/m0 integrate to int (m/m0)^e dt = m0 phi((1 + e) ln(m/m0)) int dt/m */
VM_API int vm_pair_at(const vm_pair *p, vm_real t, const vm_real *y0, vm_linear_mass m, vm_real *y)
{
    const vm_real drift = (2 * p->reactive - 1) / (p->alpha + 3);
    vm_real modes[4], ln_ratio, integral, rate0, exponent;
    int status = vmi_pair_check(p, m.mass, m.rate);
    if (!status) status = vmi_pair_split(p, m.mass, m.rate, y0, modes);
    if (status) return status;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!vmi_slow_linear(m, t, &ln_ratio, &integral)) return VM_BAD_MASS;
    rate0 = vmi_slow_rate(modes[0], 2 * p->k, m.mass, p->alpha);
    exponent = VM_C(0.5) - (p->alpha - 1) / 2 * drift;
    modes[1] += rate0 * m.mass * integral * vmi_slow_phi(exponent * ln_ratio);
    modes[0] *= vmi_exp(-drift * ln_ratio, 0);
    modes[2] += modes[3] * m.mass * integral * vmi_slow_phi((1 - p->reactive) * ln_ratio);
    modes[3] *= vmi_exp(-p->reactive * ln_ratio, 0);
    vmi_pair_join(p, m.mass + m.rate * t, m.rate, modes, y);
    return VM_OK;
}

/* ---- Chapter 8: harmonic excitation ------------------------------------------------------------------------- */

VM_API vm_forced_now vmi_forced_at(const vm_forced *f, vm_real t)
{
    vm_forced_now now = f->now;
    if (f->drift) f->drift(t, &now, f->drift_ctx);
    return now;
}

VM_API int vmi_forced_check(const vm_forced_now *n)
{
    if (!VM_IS_FINITE(n->mass) || !VM_IS_FINITE(n->mass_rate) || !VM_IS_FINITE(n->k) || !VM_IS_FINITE(n->k_rate) ||
        !VM_IS_FINITE(n->nu) || !VM_IS_FINITE(n->nu_rate) || !VM_IS_FINITE(n->force))
        return VM_NOT_FINITE;
    if (!(n->mass > 0)) return VM_BAD_MASS;
    return n->k > 0 && n->nu > 0 ? VM_OK : VM_BAD_OSCILLATOR;
}

/* c_j = 2 int_0^1 ca(Pi u/2) cos((2j+1) pi u/2) du by the tanh-sinh rule, u = 1/(1 + e^(-pi sinh t)): ca is not
   analytic at u = 1, and for large alpha bends sharply at u = 0 */
VM_API void vmi_forced_fourier(vm_forced *f)
{
    const int steps = VM_MANT_DIG > 24 ? 16 : 8, n = 13 * steps / 4; /* |t| <= 3.25: the rest is below eps */
    vm_real sum[5] = {0, 0, 0, 0, 0}, total = 0;
    int i, j;
    for (i = -n; i <= n; i++) {
        const vm_real t = (vm_real)i / (vm_real)steps, e = vmi_exp(t, 0), half_pi = VM_PI / 2;
        const vm_real g = vmi_exp(-half_pi * (e - 1 / e), 0), u = 1 / (1 + g);
        const vm_real weight = half_pi * (e + 1 / e) * u * (g * u);
        vm_real sa, ca, sine, c, before, twice;
        ateb_saca(f->pi / 2 * u, f->alpha, &sa, &ca);
        vmi_sincos(half_pi * u, &sine, &c);
        before = c, twice = 2 * (c - sine) * (c + sine), total += weight;
        for (j = 0; j < 5; j++) {
            const vm_real next = twice * c - before;
            sum[j] += weight * ca * c;
            before = c, c = next;
        }
    }
    for (j = 0; j < 5; j++) {
        f->c[j] = 2 * sum[j] / total;
        f->s[j] = (f->alpha + 1) * (vm_real)(2 * j + 1) * VM_PI / (2 * f->pi) * f->c[j];
    }
}

VM_API int vm_forced_init(vm_forced *f)
{
    vm_forced_now now;
    int status;
    if (!f) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(f->alpha) || !VM_IS_FINITE(f->b) || !VM_IS_FINITE(f->reactive)) return VM_NOT_FINITE;
    if (!(f->alpha >= 0)) return VM_BAD_OSCILLATOR;
    now = vmi_forced_at(f, 0);
    status = vmi_forced_check(&now);
    if (status) return status;
    f->pi = ateb_pi(f->alpha);
    f->Om1 = VM_PI / f->pi * VM_SQRT((f->alpha + 1) / 2);
    vmi_forced_fourier(f);
    f->G = f->Om1 * f->Om1 / 2 * f->c[0];
    return VM_OK;
}

/* (ln mu kappa)', the rate at which the action would change */
VM_API vm_real vmi_forced_q(const vm_forced *f, const vm_forced_now *n)
{
    return ((2 * f->reactive - 1) * n->mass_rate + 2 * f->b) / n->mass + n->k_rate / n->k;
}

VM_API vm_real vmi_forced_natural(const vm_forced *f, const vm_forced_now *n, vm_real A) /* w(A) */
{
    return f->Om1 * VM_SQRT(n->k / n->mass) * vmi_raised(VM_FABS(A), (f->alpha - 1) / 2);
}

VM_API int vm_forced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_now n = vmi_forced_at(f, t);
    vm_real sine, cosine;
    const int status = vmi_forced_check(&n);
    if (status) return status;
    vmi_sincos(y[2], &sine, &cosine);
    dydt[0] = y[1];
    dydt[1] = (n.force * cosine - (f->reactive * n.mass_rate + f->b) * y[1] -
               vmi_slow_elastic(y[0], n.k, f->alpha)) /
              n.mass;
    dydt[2] = n.nu;
    return VM_OK;
}

VM_API int vm_forced_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_now n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vm_real q, Om, push, sa, ca, sine, cosine;
    if (status) return status;
    q = vmi_forced_q(f, &n), Om = vmi_slow_rate(y[0], n.k, n.mass, f->alpha);
    ateb_saca(y[1], f->alpha, &sa, &ca);
    vmi_sincos(y[2], &sine, &cosine);
    push = n.force / (n.mass * Om) * cosine;
    dydt[0] = -(q * y[0] / (f->alpha + 1) * sa + push) * sa;
    dydt[1] = Om - (q / 2 * sa + (f->alpha + 1) / (2 * y[0]) * push) * ca;
    dydt[2] = n.nu;
    return VM_OK;
}

VM_API int vm_forced_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_now n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vm_real w, push, sine, cosine;
    if (status) return status;
    w = vmi_forced_natural(f, &n, y[0]), push = n.force * f->G / (n.mass * w);
    vmi_sincos(y[1], &sine, &cosine);
    dydt[0] = -vmi_forced_q(f, &n) * y[0] / (f->alpha + 3) - push * sine;
    dydt[1] = w - n.nu - push / y[0] * cosine;
    dydt[2] = n.nu;
    return VM_OK;
}

/* R, the first ripple of the exact amplitude about its mean A: psi the Ateb phase, phi = pi psi/Pi that in radians */
VM_API vm_real vmi_forced_ripple(const vm_forced *f, const vm_forced_now *n, vm_real A, vm_real phi, vm_real theta)
{
    const vm_real Om = vmi_slow_rate(A, n->k, n->mass, f->alpha);
    vm_real sa, ca, sum = 0, unused, plus, minus;
    int j;
    ateb_saca(phi * (f->pi / VM_PI), f->alpha, &sa, &ca);
    for (j = 0; j < 5; j++) {
        const vm_real order = (vm_real)(2 * j + 1);
        vmi_sincos(order * phi + theta, &unused, &plus);
        vmi_sincos(order * phi - theta, &unused, &minus);
        sum += f->s[j] / 2 * (plus / (order + 1) + (j ? minus / (order - 1) : 0));
    }
    return vmi_forced_q(f, n) * A / ((f->alpha + 3) * Om) * sa * ca + n->force / (n->mass * Om * n->nu) * sum;
}

VM_API int vmi_forced_finite(const vm_real *y)
{
    return VM_IS_FINITE(y[0]) && VM_IS_FINITE(y[1]) && VM_IS_FINITE(y[2]);
}

VM_API int vm_forced_split(const vm_forced *f, vm_real t, const vm_real *motion, vm_real *y)
{
    const vm_forced_now n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    const vm_real theta = motion[2];
    vm_real exact, A, phi;
    int i;
    if (status) return status;
    if (!vmi_forced_finite(motion)) return VM_NOT_FINITE;
    vmi_slow_phase(motion[0], motion[1], n.k, n.mass, f->alpha, &exact, &phi);
    phi *= VM_PI / f->pi, A = exact;
    for (i = 0; i < 3; i++) A = exact - vmi_forced_ripple(f, &n, A, phi, theta);
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_BAD_OSCILLATOR; /* the motion is smaller than its ripple */
    y[0] = A, y[1] = phi - theta, y[2] = theta;
    return VM_OK;
}

VM_API int vm_forced_join(const vm_forced *f, vm_real t, const vm_real *y, vm_real *motion)
{
    const vm_forced_now n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    const vm_real theta = y[2], phi = y[1] + theta;
    vm_real A;
    if (status) return status;
    if (!vmi_forced_finite(y)) return VM_NOT_FINITE;
    A = y[0] + vmi_forced_ripple(f, &n, y[0], phi, theta);
    if (!(y[0] > 0) || !(A >= 0)) return VM_BAD_OSCILLATOR;
    vmi_slow_motion(A, phi * (f->pi / VM_PI), n.k, n.mass, f->alpha, &motion[0], &motion[1]);
    motion[2] = theta;
    return VM_OK;
}

/* The resonance with all quantities frozen, p = q/(alpha+3) */
typedef struct VM_TAG(vmi_frozen) {
    vm_real w1, exponent, nu, p, push; /* w = w1 A^exponent; push = force G/m, signed */
} vmi_frozen;

VM_API vmi_frozen vmi_forced_frozen(const vm_forced *f, const vm_forced_now *n)
{
    vmi_frozen z;
    z.w1 = vmi_forced_natural(f, n, 1), z.exponent = (f->alpha - 1) / 2;
    z.nu = n->nu, z.p = vmi_forced_q(f, n) / (f->alpha + 3), z.push = n->force * f->G / n->mass;
    return z;
}

/* ln of A w sqrt((w - nu)^2 + p^2)/|push|, 0 at a steady amplitude A = e^x */
VM_API vm_real vmi_forced_excess(vm_real x, void *frozen)
{
    const vmi_frozen *z = (const vmi_frozen *)frozen;
    const vm_real w = z->w1 * vmi_exp(z->exponent * x, 0), detuning = vmi_c_modulus(vmi_complex(w - z->nu, z->p));
    if (!(detuning > 0)) return -VM_MAX;
    return (1 + z->exponent) * x + vmi_log(z->w1 / VM_FABS(z->push) * detuning).hi;
}

VM_API vm_steady vmi_forced_state(const vmi_frozen *z, vm_real alpha, vm_real A)
{
    const vm_real w = z->w1 * vmi_raised(A, z->exponent), gain = (alpha + 1) / 2, off = w - z->nu, p = z->p;
    vm_steady s;
    s.nu = z->nu, s.A = A;
    s.delta = ateb_phase(-p * A * w / z->push, off * A * w / z->push, 1);
    s.trace = -(alpha + 3) * p / 2;
    s.det = p * p * gain + off * (z->exponent * w + gain * off);
    s.stable = s.det > 0 && s.trace < 0;
    return s;
}

/* The values of x = ln A between which the excess is monotonic: w of det = 0, which is 2 alpha w^2 - (3 alpha + 1)
   nu w + (alpha + 1)(nu^2 + p^2) = 0; their number */
VM_API int vmi_forced_turns(const vmi_frozen *z, vm_real alpha, vm_real *x)
{
    const vm_real bend = (alpha - 1) * z->nu, square = bend * bend - 8 * alpha * (alpha + 1) * z->p * z->p;
    const vm_real half = (3 * alpha + 1) * z->nu + (square > 0 ? VM_SQRT(square) : 0);
    int n = 0;
    if (!(square > 0) || alpha == 1) return 0;
    x[n++] = vmi_log(2 * (alpha + 1) * (z->nu * z->nu + z->p * z->p) / (half * z->w1)).hi / z->exponent;
    if (alpha > 0) x[n++] = vmi_log(half / (4 * alpha * z->w1)).hi / z->exponent;
    if (n == 2 && x[0] > x[1]) x[2] = x[0], x[0] = x[1], x[1] = x[2];
    return n;
}

/* The steady amplitudes of alpha != 1: one at most below, between and above the turns */
VM_API int vmi_forced_roots(vmi_frozen *z, vm_real alpha, vm_real *A)
{
    const vm_real steep = VM_FABS(z->exponent) > 1 ? VM_FABS(z->exponent) : 1;
    const vm_real far = -vmi_log(VM_MIN).hi / steep; /* A and w are numbers to there */
    vm_real ends[5], turns[3], left, right;
    int i, n = vmi_forced_turns(z, alpha, turns), found = 0;
    ends[0] = -far, ends[n + 1] = far;
    for (i = 0; i < n; i++) ends[i + 1] = turns[i] < -far ? -far : turns[i] > far ? far : turns[i];
    for (i = 0; i <= n; i++) {
        left = vmi_forced_excess(ends[i], z), right = vmi_forced_excess(ends[i + 1], z);
        if (!((left > 0) != (right > 0))) continue;
        A[found++] = vmi_exp(vmi_slow_zero(vmi_forced_excess, z, ends[i], ends[i + 1], left, right), 0);
    }
    return found;
}

VM_API int vm_forced_steady(const vm_forced *f, vm_real t, vm_steady steady[3])
{
    const vm_forced_now n = vmi_forced_at(f, t);
    int i, found = 0;
    const int status = vmi_forced_check(&n);
    vm_real A[3];
    vmi_frozen z;
    if (status) return status;
    z = vmi_forced_frozen(f, &n);
    if (z.push == 0) return 0;
    if (f->alpha == 1) {
        A[0] = VM_FABS(z.push) / (z.w1 * vmi_c_modulus(vmi_complex(z.w1 - z.nu, z.p)));
        found = VM_IS_FINITE(A[0]);
    } else found = vmi_forced_roots(&z, f->alpha, A);
    for (i = 0; i < found; i++) steady[i] = vmi_forced_state(&z, f->alpha, A[i]);
    return found;
}

VM_API int vm_forced_curve(const vm_forced *f, vm_real t, vm_real A, vm_steady curve[2])
{
    const vm_forced_now n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vmi_frozen z;
    vm_real w, hold, width, p;
    int found = 0;
    if (status) return status;
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_BAD_OSCILLATOR;
    z = vmi_forced_frozen(f, &n);
    w = vmi_forced_natural(f, &n, A), hold = VM_FABS(z.push) / (w * A), p = VM_FABS(z.p);
    if (!(hold >= p) || z.push == 0) return 0;
    width = VM_SQRT(hold - p) * VM_SQRT(hold + p);
    z.nu = w - width;
    if (z.nu > 0) curve[found++] = vmi_forced_state(&z, f->alpha, A);
    z.nu = w + width;
    if (width > 0 || !found) curve[found++] = vmi_forced_state(&z, f->alpha, A);
    return found;
}

VM_API vm_real vm_forced_peak(const vm_forced *f, vm_real t)
{
    const vm_forced_now n = vmi_forced_at(f, t);
    vmi_frozen z;
    if (vmi_forced_check(&n)) return VM_NAN;
    z = vmi_forced_frozen(f, &n);
    return vmi_raised(VM_FABS(z.push / z.p) / z.w1, 2 / (f->alpha + 1));
}

/* delta'' = -(gamma push/A) sin delta - nu D, a pendulum under a torque, gamma = (alpha - 1)/2, D the relative
   drift of w - nu; and for gamma = 0 the same jump */
VM_API int vm_forced_passage(const vm_forced *f, vm_real t, vm_real amplitude, vm_passage *passage)
{
    const vm_forced_now n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vmi_frozen z;
    vm_passage r;
    vm_real D, sine;
    if (status) return status;
    z = vmi_forced_frozen(f, &n);
    r.A = z.exponent == 0 ? amplitude : vmi_raised(z.nu / z.w1, 1 / z.exponent);
    if (!(r.A > 0) || !VM_IS_FINITE(r.A) || z.push == 0) return VM_BAD_OSCILLATOR;
    D = n.mass_rate / (2 * n.mass) - n.k_rate / (2 * n.k) + n.nu_rate / n.nu + z.exponent * z.p;
    sine = z.exponent == 0 ? VM_INFINITY : -z.nu * D * r.A / (z.exponent * z.push);
    r.torque = VM_FABS(sine);
    r.delta = r.torque <= 1
                  ? ateb_phase(sine, VM_COPYSIGN(VM_SQRT((1 - sine) * (1 + sine)), z.exponent * z.push), 1)
                  : VM_NAN;
    r.jump = VM_FABS(z.push) / (z.nu * r.A) * VM_SQRT(2 * VM_PI / (z.nu * VM_FABS(D)));
    *passage = r;
    return VM_OK;
}

/* ---- Diagnostics of slow vibrations ------------------------------------------------------------------------- */

typedef struct VM_TAG(vmi_point_search) {
    vm_motion motion;
    void *ctx;
    int kind;
    vm_real x, v; /* where it was looked last */
} vmi_point_search;

/* What vanishes at a point of the kind looked for */
VM_API vm_real vmi_point_function(vm_real t, void *search)
{
    vmi_point_search *s = (vmi_point_search *)search;
    s->motion(t, &s->x, &s->v, s->ctx);
    return s->kind == VM_ZERO_CROSSINGS ? s->x : s->v;
}

VM_API long vm_find_points(vm_motion motion, void *ctx, int kind, vm_real t0, vm_real t1, vm_real step, long room,
                           vm_point *points)
{
    vmi_point_search s;
    vm_real t = t0, here, there, intervals;
    long found = 0, i = 0, last;
    if (!motion || (room > 0 && !points) || (kind != VM_TURNING_POINTS && kind != VM_ZERO_CROSSINGS))
        return VM_BAD_ARGUMENT;
    intervals = -VM_FLOOR(-(t1 - t0) / step);
    if (!(intervals >= 0) || !(intervals < VM_C(2e9))) return VM_NOT_FINITE;
    last = (long)intervals;
    s.motion = motion, s.ctx = ctx, s.kind = kind;
    for (here = vmi_point_function(t0, &s); i < last; here = there) {
        const vm_real before = t;
        i++, t = i == last ? t1 : t0 + (t1 - t0) * ((vm_real)i / intervals);
        there = vmi_point_function(t, &s);
        if (!VM_IS_FINITE(there)) return VM_NOT_FINITE;
        if (here == 0 || !(there == 0 || (there > 0) != (here > 0))) continue;
        if (found < room) {
            points[found].t = vmi_slow_zero(vmi_point_function, &s, before, t, here, there);
            motion(points[found].t, &points[found].x, &points[found].v, ctx);
        }
        found++;
    }
    if (!VM_IS_FINITE(here)) return VM_NOT_FINITE;
    return found;
}

typedef struct VM_TAG(vmi_step_motion) {
    rk45 *s;
    int x, v;
    vm_real *buffer;
} vmi_step_motion;

VM_API void vmi_motion_of_step(vm_real t, vm_real *x, vm_real *v, void *step)
{
    const vmi_step_motion *m = (const vmi_step_motion *)step;
    const int status = m->s->method == VMI_RK45 ? rk45_interpolate(m->s, t, m->buffer)
                                                : rk87_interpolate(m->s, t, m->buffer);
    *x = status ? VM_NAN : m->buffer[m->x];
    *v = status ? VM_NAN : m->buffer[m->v];
}

VM_API long vm_find_points_of_step(rk45 *s, int x, int v, int kind, vm_real *buffer, long room, vm_point *points)
{
    vmi_step_motion m;
    vm_real length;
    if (!s || !buffer || x < 0 || v < 0 || x >= s->n || v >= s->n) return VM_BAD_ARGUMENT;
    length = s->t - s->t_old;
    if (length == 0) return 0;
    m.s = s, m.x = x, m.v = v, m.buffer = buffer;
    return vm_find_points(vmi_motion_of_step, &m, kind, s->t_old, s->t, length / 4, room, points);
}

VM_API vm_real vm_envelope_error(int kind, long n, const vm_point *points, vm_real (*law)(vm_real t, void *ctx),
                                 void *ctx)
{
    vm_real worst = 0;
    long i;
    for (i = 0; i < n; i++) {
        const vm_real observed = kind == VM_TURNING_POINTS ? points[i].x : points[i].v;
        const vm_real error = VM_FABS(law(points[i].t, ctx) / VM_FABS(observed) - 1);
        if (!(error <= worst)) worst = error;
    }
    return worst;
}

VM_API vm_real vm_adiabaticity(vm_real A, vm_real mass, vm_real mass_rate, vm_real k, vm_real k_rate, vm_real b,
                               vm_real reactive, vm_real alpha)
{
    if (!(A > 0) || !(mass > 0) || !(k > 0) || !(alpha >= 0) || !VM_IS_FINITE(alpha)) return VM_NAN;
    return (((2 * reactive - 1) * mass_rate + 2 * b) / mass + k_rate / k) / vmi_slow_rate(A, k, mass, alpha);
}

/* ---- Scenes ------------------------------------------------------------------------------------------------- */

#endif
