/* varmass.h - dynamics of bodies whose mass varies

   Part of varmass (MIT licence): copy varmass.h, ateb.h, jacobi.h and integrators.h side by side, include varmass.h,
   link with -lm. varmass.h allocates no memory, keeps no state and needs no other library.

       #include <stdio.h>
       #include "varmass.h"
       int main(void)
       {
           vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
           vm_body part = whole, rest;
           part.mass = 1;
           part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1;
           part.r.x = 0.4; // the part is 0.4 m away from the mass centre
           part.v.y = 2;   // and leaves sideways at 2 m/s
           if (vm_separate(&whole, &part, NULL, &rest) == VM_OK) printf("spin %g rad/s\n", rest.omega.z);
           return 0;
       }

   CHAPTERS
     base/          numbers with more digits, elementary functions, Lambert's W, linear equations, roots; statuses
     mechanics/     vectors, attitudes, Euler's angles; bodies; jumps (a part separates from a body or is attached to
                    it), in space and in the plane; how a part must leave so that the remaining body moves as wanted;
                    energy of a jump; jumps on a fixed axle; a rotor that breaks; Lagrange's equations across a jump
                    and with variable mass, inverse dynamics; a pendulum that is cut; torque-free rotation; streams of
                    mass with their reactive force and torque; rockets; tanks and grains; orbits of two bodies; a band
                    that winds up on a drum
     oscillators/   m x'' + k x|x|^(alpha-1) = F with constant mass and with laws of mass, stiffness and damping;
                    Duffing's oscillator k1 x + k3 x^3 and any other odd elastic force; Van der Pol's oscillator,
                    Jeffcott's rotor, two bodies with nonlinear connections, harmonic excitation, resonance,
                    turning points
     scenes/        lists of bodies, of effects that act on them, and of events that change them; a scene simulates
                    only what is listed
   Each chapter begins with a comment that says what it is for and shows a call; the index below names all functions.
   Numbers in round brackets are those of equations of [1]. Where an equation of [1] is misprinted or wrong, the
   corrected form stands here and the comment says so; docs/errata.md lists all these equations.

   CONVENTIONS
     Units        SI units; angles are in radians.
     Axes         r, v and omega are in inertial axes. The inertia tensor is about the body's own mass centre, in body
                  axes; its entries xy, xz, yz are those of the tensor, so that xy is minus the integral of x y dm. v
                  is momentum/mass.
     Attitude     The quaternion q converts vectors from body axes to inertial axes. It need not have length 1. A q of
                  four zeros means that body axes and inertial axes coincide.
     Arguments    Functions of numbers take the variable first, then the parameters, results last. Functions of an
                  object take the object first, then the variable. A parameter that may be NULL is called ..._or_NULL.
     Laws         A mass, stiffness or damping that depends on time is a vm_law.
     Damping      damping > 0 takes energy out.
     Streams      reactive = 1: mass that joins or leaves has an absolute velocity of its own (0 means at rest), and
                  the full reactive force acts. reactive = 0: this mass has the body's velocity, and no reactive
                  force acts. Where a function also takes a velocity u of the mass, reactive = 0 means that u is
                  relative to the body, and the reactive force is the rate of the mass times u.
     Names        X_to_Y and X_from_Y convert. X_rhs is the right-hand side of the differential equations of X,
                  X_averaged_rhs that of the averaged equations. A suffix 2 means the plane, 1 means one dimension.
                  Names that begin with vmi_ or VMI_ are internal.

   ERRORS
     Functions that can fail return a status: 0 (VM_OK), a positive number (the work is done, but there is a remark) or
     a negative one (an error; the outputs are unchanged). vm_strerror() explains a status. The same mistake has the
     same status in every function; base/status lists all statuses. Functions that return a number return NaN outside
     their domain and, unless their comment says otherwise, for infinite arguments. An output may be the same variable
     as an input.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double (tests run both)
     VM_API               linkage of the functions; the default is static inline
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. The defaults
                          are static const and (x); on AVR they are static const PROGMEM and pgm_read_float(&(x)), so
                          that tables take no RAM
     VM_SQRT, VM_FABS ... the functions of the C library that are used (define all of them or none)
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but no result is promised to be
                          right then
     VM_MIXED_PRECISIONS  allows a program in which some files define VM_USE_FLOAT and others do not. Without it gcc and
                          MSVC, and clang for Windows, refuse to link such a program: a struct in float that is passed
                          to a function in double would be misread. In C++ every compiler refuses such a call.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. But clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor treats subnormal numbers, the
     smallest of all, as zero. vm_self_check() returns 0 in these cases, and 1 where all is well; a program may call it
     once when it starts.

   ACCURACY: bounds that the tests check (make test); docs/measurements.md has the measured errors
     eps, ulp     eps is 2.2e-16 (float 1.2e-7). An ulp is the distance between two neighbouring numbers of the type,
                  next to the true value.
     Jumps        conserve momentum with an error of at most 3 eps times the sum of all M |v|. They conserve angular
                  momentum about any point with an error of at most 6 eps times the sum of all tr(I) |omega| + M (|r| +
                  |r - point|) |v|. M, v, r, omega and I are mass, velocity, position, angular velocity and inertia
                  tensor of a body, and tr(I) is the sum of the diagonal of I. (The bound is larger if a moment of
                  inertia had to be corrected; see vm_separate.) If a part goes on moving as it did on the body, omega
                  of the rest does not change.
     Rotation     of a torque-free body: after 1e6 turns the attitude is right within 8 eps (rad) and omega within
                  5 eps, if the inputs are taken as exact.
     Streams      the solutions in closed form are right within a few eps. A body together with all mass that has left
                  it keeps momentum, angular momentum and energy to the integrator's tolerance.
     Lambert's W  has an error of at most 1 ulp, the drum on a rigid shaft one of at most 4 ulp.
     Oscillators  every route (method of solution) returns an estimate of its whole error in the field `error`, or
                  infinity where no estimate is possible.

   COST
     docs/cost.md has the times of oscillators, free rotation, streams and scenes, docs/counts.md the number of
     instructions of a call. docs/firmware.md has the flash memory, the stack and the number of instructions of a call
     on microcontrollers, docs/parts.md the flash memory that a chapter takes.
     The time of a call is bounded, with three exceptions. A function that takes n objects or a list needs a time in
     proportion to their number. Lagrange's equations with n coordinates, and joints with n equations, need a time that
     grows like n^3. A function that integrates (routes of oscillators, scenes) needs a time in proportion to the length
     of the run; its comment says so.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation.
     Other sources are named in the chapters that use them.

   INDEX
@INDEX@ */
#ifndef VARMASS_H
#define VARMASS_H

#include "ateb.h"
#include "integrators.h"
#include "jacobi.h"

VMI_QUIET_BEGIN

#include "base/status.h"
#include "base/linear.h"
#include "base/power_of_two.h"
#include "base/zero.h"
#include "base/polynomial.h"
#include "base/lambert.h"
#include "mechanics/vectors.h"
#include "mechanics/attitude.h"
#include "mechanics/euler_angles.h"
#include "mechanics/inertia.h"
#include "mechanics/bodies.h"
#include "mechanics/bodies2.h"
#include "mechanics/jumps.h"
#include "mechanics/jumps2.h"
#include "mechanics/relative.h"
#include "mechanics/inverse.h"
#include "mechanics/jump_energy.h"
#include "mechanics/axle.h"
#include "mechanics/broken_rotor.h"
#include "mechanics/broken_rotor_motion.h"
#include "mechanics/broken_rotor_stability.h"
#include "mechanics/lagrange_jump.h"
#include "mechanics/pendulum.h"
#include "mechanics/torque_free.h"
#include "mechanics/streams.h"
#include "mechanics/flow.h"
#include "mechanics/flow2.h"
#include "mechanics/flow1.h"
#include "mechanics/rocket.h"
#include "mechanics/supply.h"
#include "mechanics/orbit.h"
#include "mechanics/drum.h"
#include "mechanics/lagrange.h"
#include "oscillators/constant_mass.h"
#include "oscillators/laws.h"
#include "oscillators/problem.h"
#include "oscillators/loads.h"
#include "oscillators/reduction.h"
#include "oscillators/ripple.h"
#include "oscillators/expansion.h"
#include "oscillators/closed.h"
#include "oscillators/plan.h"
#include "oscillators/walk.h"
#include "oscillators/mean_motion.h"
#include "oscillators/averaging.h"
#include "oscillators/integration.h"
#include "oscillators/collocation.h"
#include "oscillators/routes.h"
#include "oscillators/odd_force.h"
#include "oscillators/duffing.h"
#include "oscillators/orbit_ripple.h"
#include "oscillators/odd_motion.h"
#include "oscillators/odd_routes.h"
#include "oscillators/slow.h"
#include "oscillators/van_der_pol.h"
#include "oscillators/van_der_pol_expansion.h"
#include "oscillators/van_der_pol_walk.h"
#include "oscillators/van_der_pol_routes.h"
#include "oscillators/jeffcott.h"
#include "oscillators/jeffcott_motion.h"
#include "oscillators/pair.h"
#include "oscillators/coupled_pair.h"
#include "oscillators/forced.h"
#include "oscillators/resonance.h"
#include "oscillators/periodic.h"
#include "oscillators/grounded_pair.h"
#include "oscillators/diagnostics.h"
#include "scenes/scene.h"
#include "scenes/motions.h"
#include "scenes/growing.h"
#include "scenes/forces.h"
#include "scenes/effects.h"
#include "scenes/gravitation.h"
#include "scenes/mass.h"
#include "scenes/mass_of_time.h"
#include "scenes/streams.h"
#include "scenes/band.h"
#include "scenes/links.h"
#include "scenes/state.h"
#include "scenes/evaluate.h"
#include "scenes/check.h"
#include "scenes/points.h"
#include "scenes/springs.h"
#include "scenes/joints.h"
#include "scenes/start.h"
#include "scenes/balance.h"
#include "scenes/events.h"
#include "scenes/jumps.h"
#include "scenes/contact.h"
#include "scenes/run.h"

VMI_QUIET_END

#endif
