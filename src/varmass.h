/* varmass.h - dynamics of bodies whose mass varies

   Part of varmass (MIT licence): copy varmass.h, ateb.h, jacobi.h and integrators.h side by side, include varmass.h,
   link with -lm. No allocation, no state, no other library.

       #include <stdio.h>
       #include "varmass.h"
       int main(void)
       {
           vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
           vm_body part = whole, rest;
           part.mass = 1;
           part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1;
           part.r.x = 0.4; // it sat 0.4 m from the mass centre and leaves at 2 m/s aside
           part.v.y = 2;
           if (vm_separate(&whole, &part, NULL, &rest) == VM_OK) printf("spin %g rad/s\n", rest.omega.z);
           return 0;
       }

   CONTENTS, in the order of the dissertation [1]
     Chapter 2      momentum, angular momentum, energy; balances across an instant; inertia of a whole and its parts
     Chapter 3      jumps, in space and in the plane: parts separate or are attached, one or several at once, with
                    impulses; in relative motions; how a part must leave for the rest to move as wanted; energy gained
                    and lost (4.1)
     Chapter 3.3.2  the broken rotor: before, the break, transient and steady motion, stability, growth at resonance
     Chapter 4      Lagrange's equations across a jump; the pendulum that is cut
     Free rotation  exact motion of a body without forces, at any time in constant time
     Chapter 5      streams of mass in and out: reactive force, moment, torque; the free body in space, in the plane,
                    in translation, on a line or an axle; closed forms; an account of all that is shed
     Chapter 5.2    a band winds up on a drum: exact and reduced equations, rigid shaft in closed form, elastic shaft;
                    Lambert's W
     Chapter 6      Lagrange's equations with variable mass, masses frozen; Euler's angles
     Chapter 7.2-3  the oscillator m x'' + k x|x|^(alpha-1) = 0: exact, trigonometric and Jacobi motion
     Chapter 7.4    the same with laws of mass and stiffness: routes to x(t) from a cosine to rk87, and vm_osc_within,
                    which picks the cheapest within a tolerance and says which it took
     Chapter 7.6    Van der Pol with variable mass: amplitude law in closed form, steady amplitudes
     Chapter 7.7    Laval's rotor: two-frequency and one-frequency averaging, radius law, gyroscopic
     Chapter 7.8    two bodies with a nonlinear connection
     Chapter 8      harmonic excitation: exact and averaged equations, resonance curve, passage
     Diagnostics    turning points and zero crossings of any trajectory, envelope error, adiabaticity
     Scenes         bodies, the effects that act on them, the events that change them: only what is listed is
                    simulated, and linked
   Numbers in round brackets are the equations of [1]; where [1] is misprinted or wrong the corrected form stands here
   and the comment says so; docs/errata.md lists them all.

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
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; both or none. Default: static const
                          and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables take no RAM
     VM_SQRT, VM_FABS ... the functions of the C library that are used (all of them, if any)
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, where nothing is promised
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for zero.
     vm_self_check() returns 0 there, and 1 where all is well; a program may call it once when it starts.

   ACCURACY, measured (make test; docs/measurements.md)
     Jumps keep momentum to 3 eps of the sum of all M |v|, and angular momentum about any point to 6 eps of the sum
     of all tr(I) |omega| + M (|r| + |r - point|) |v|, where |r| counts from the origin, since positions are right
     to eps |r|. This holds for masses in a ratio of up to 1e4, for thin and for fast bodies, for bodies up to 1e6
     times their size (float: 100) away from the origin, and for points in a body or next to it, except for what
     VM_NULL_AXIS reports. A part
     that moves on as before leaves omega as it was, far from the origin and at high speed too; energies by (113),
     (118) agree with the bodies' to 1 eps of theirs.
     Free rotation: attitude within 8 eps (rad) and omega within 5 eps after 1e6 turns, inputs exact, next to the
     separatrix too. Rotor: linear motion within 2 roundings of its inputs. Streams: closed forms 1 eps of their
     terms; body and everything shed keep momentum, angular momentum and energy to 7e-15 (rk87), to 0.3 of the
     tolerance (rk45). Lambert's W within 1 ulp; the drum on a rigid shaft within 4 ulp, through e = 0 and k1 = 0.
     The constants of the oscillator are right to 8 eps; the second-order law errs by (q/Om)^2 to t = 3/q (1e-6 for
     eps = 0.01); every route estimates its error: below 3 estimates in 99 % of random problems by vm_osc_within, above
     10 (and there by little) in 1 of 1000. Closed forms of Van der Pol, rotor and steady vibrations 3e-15,
     coefficients 5 eps for alpha to 1e6.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation.
     Others stand where they are used.

   INDEX
@INDEX@ */
#ifndef VARMASS_H
#define VARMASS_H

#include "ateb.h"
#include "integrators.h"
#include "jacobi.h"

#include "base/status.h"
#include "base/linear.h"
#include "base/zero.h"
#include "base/polynomial.h"
#include "base/lambert.h"
#include "mechanics/vectors.h"
#include "mechanics/inertia.h"
#include "mechanics/bodies.h"
#include "mechanics/bodies2.h"
#include "mechanics/jumps.h"
#include "mechanics/jumps2.h"
#include "mechanics/relative.h"
#include "mechanics/inverse.h"
#include "mechanics/jump_energy.h"
#include "mechanics/broken_rotor.h"
#include "mechanics/lagrange_jump.h"
#include "mechanics/pendulum.h"
#include "mechanics/torque_free.h"
#include "mechanics/streams.h"
#include "mechanics/flow.h"
#include "mechanics/flow2.h"
#include "mechanics/flow1.h"
#include "mechanics/rocket.h"
#include "mechanics/drum.h"
#include "mechanics/lagrange.h"
#include "mechanics/euler_angles.h"
#include "oscillators/constant_mass.h"
#include "oscillators/laws.h"
#include "oscillators/legendre.h"
#include "oscillators/problem.h"
#include "oscillators/panels.h"
#include "oscillators/walk.h"
#include "oscillators/mean_laws.h"
#include "oscillators/averaging.h"
#include "oscillators/integration.h"
#include "oscillators/routes.h"
#include "oscillators/slow.h"
#include "oscillators/van_der_pol.h"
#include "oscillators/jeffcott.h"
#include "oscillators/pair.h"
#include "oscillators/forced.h"
#include "oscillators/resonance.h"
#include "oscillators/diagnostics.h"
#include "scenes/scene.h"
#include "scenes/motions.h"
#include "scenes/growing.h"
#include "scenes/forces.h"
#include "scenes/effects.h"
#include "scenes/mass.h"
#include "scenes/streams.h"
#include "scenes/band.h"
#include "scenes/links.h"
#include "scenes/state.h"
#include "scenes/evaluate.h"
#include "scenes/check.h"
#include "scenes/start.h"
#include "scenes/balance.h"
#include "scenes/events.h"
#include "scenes/jumps.h"
#include "scenes/run.h"

#endif
