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
     mechanics/     bodies; jumps (a part separates from a body or is attached to it), in space and in the plane; how a
                    part must leave so that the remaining body moves as wanted; energy of a jump; a rotor that breaks;
                    Lagrange's equations across a jump and with variable mass; a pendulum that is cut; torque-free
                    rotation; streams of mass with their reactive force and torque; rockets; a band that winds up on a
                    drum
     oscillators/   m x'' + k x|x|^(alpha-1) = F with constant mass and with laws of mass, stiffness and damping; Van
                    der Pol's oscillator, Jeffcott's rotor, two bodies with a nonlinear spring, harmonic excitation,
                    resonance, turning points
     scenes/        bodies, the effects that act on them, the events that change them: only what is listed is
                    simulated
   Each chapter begins with a comment that says what it is for and shows a call; the index below names all functions.
   Numbers in round brackets are the equations of [1]. Where [1] is misprinted or wrong, the corrected form stands
   here and the comment says so; docs/errata.md lists all of them.

   CONVENTIONS
     Units        SI units; angles are in radians.
     Axes         r, v and omega are in inertial axes. The inertia tensor is about the body's own mass centre, in body
                  axes; its entries xy, xz, yz are those of the tensor, minus the integral of x y dm and so on. v is
                  momentum/mass.
     Attitude     The quaternion q turns body axes into inertial axes. It need not have length 1. A q of four zeros
                  means that body axes and inertial axes coincide.
     Arguments    Functions of numbers take the variable first, then the parameters, results last. Functions of an
                  object take the object first, then the variable. A parameter that may be NULL is called ..._or_NULL.
     Laws         A mass, stiffness or damping that depends on time is a vm_law.
     Damping      damping > 0 takes energy out.
     Streams      reactive = 1: mass that joins or leaves has an absolute velocity of its own (0 means at rest), and
                  the full reactive force acts. reactive = 0: this mass has the body's velocity, and no reactive
                  force acts.
     Names        X_to_Y and X_from_Y convert. X_rhs is the right-hand side of the differential equations of X,
                  X_averaged_rhs that of the averaged equations. A suffix 2 means the plane, 1 means one dimension.
                  Names that begin with vmi_ or VMI_ are internal.

   ERRORS
     Functions that can fail return a status: 0 (VM_OK), a positive number (done, with a remark) or a negative one
     (the outputs are untouched). vm_strerror() explains a status. The same mistake has the same status in every
     function; base/status lists all statuses. Functions that return a number return NaN outside their domain and for
     infinite arguments. Outputs may be the inputs.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. Default:
                          static const and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables
                          take no RAM
     VM_SQRT, VM_FABS ... the functions of the C library that are used (define all of them or none)
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, although no result is promised to be right then

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for
     zero. vm_self_check() returns 0 in these cases, and 1 where all is well; a program may call it once when it starts.

   ACCURACY, as promised and tested (make test); docs/measurements.md has the measured errors
     Jumps        keep momentum to 3 eps of the sum of all M |v|, and angular momentum about any point to 6 eps of the
                  sum of all tr(I) |omega| + M (|r| + |r - point|) |v|. A part that goes on moving with the
                  body does not change omega.
     Rotation     torque-free: attitude within 8 eps (rad) and omega within 5 eps after 1e6 turns, inputs taken as
                  exact.
     Streams      closed forms within a few eps; a body and everything it has shed keep momentum, angular momentum and
                  energy to the integrator's tolerance.
     Lambert's W  within 1 ulp. The drum on a rigid shaft: within 4 ulp.
     Oscillators  every route returns an estimate of its whole error in the field error, or infinity where no
                  estimate is possible.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation.
     Other sources are named in the chapters that use them.

   INDEX
     base/status: the statuses that functions return, and what each of them means
       vm_strerror                    The meaning of a status as a line of text

     base/lambert: Lambert's function W
       vm_lambert_w0                  Lambert's W_0(x), the upper branch
       vm_lambert_wm1                 Lambert's W_-1(x), the lower branch
       vm_wright_omega                Wright's omega function W_0(e^l), the solution w of w + ln w = l, for any l
       vm_lambert_w0_neg_exp          W_0(-e^l), the upper branch for a negative argument given by its logarithm, l <= -1
       vm_lambert_wm1_neg_exp         W_-1(-e^l), the lower branch for an argument given by its logarithm, l <= -1

     mechanics/inertia: inertia tensors, parallel axes, principal axes
       vm_inertia_is_possible         Test whether a body can have this inertia
       vm_parallel_axes               Inertia about a point at d from the mass centre, along parallel axes, (40)

     mechanics/bodies: bodies in space and in the plane, their momenta and energy, balances across an instant
       vm_momentum                    Momentum of a body, mass times velocity, (1)-(3), N s
       vm_angular_momentum            Angular momentum of a body about the point `about` (7)-(9), N m s
       vm_kinetic_energy              Kinetic energy of a body (93), (97), J
       vm_balance_between             Balance of momentum, angular momentum and energy across an instant

     mechanics/bodies2: momentum and energy of bodies in the plane, and their conversion to bodies in space
       vm_angular_momentum2           Angular momentum of a body of the plane about the point (x, y), N m s
       vm_kinetic_energy2             Kinetic energy of a body of the plane, J
       vm_body_from_body2             A body of the plane as a lamina of space in the plane z = 0

     mechanics/jumps: parts separate from a body or are attached to it, in space
       vm_separate                    Separation of a part from a body
       vm_attach                      Attachment of one body to another (plastic impact)
       vm_separate_all                Separation of n parts from a body at once
       vm_attach_all                  Attachment of n bodies to a body at once
       vm_combine_inertia             Inertia of two bodies together, about their common mass centre
       vm_split_inertia               Inertia of a body without a part, about the mass centre of what is left

     mechanics/jumps2: parts separate from a body or are attached to it, in the plane
       vm_separate2                   Separation of a part from a body in the plane
       vm_attach2                     Attachment of one body to another in the plane (plastic impact)
       vm_separate_all2               Separation of n parts from a body at once, in the plane
       vm_attach_all2                 Attachment of n bodies to a body at once, in the plane

     mechanics/relative: motion relative to a moving body, and jumps given in such motions
       vm_to_relative                 Motion of a body relative to the frame that moves rigidly with the body `to`
       vm_to_absolute                 Computes the absolute motion of a body from its motion relative to the body `to`
       vm_to_relative2                Motion of a body in the plane, relative to the frame that moves rigidly with the body `to`
       vm_to_absolute2                Computes the absolute plane motion of a body from its motion relative to the body `to`
       vm_separate_relative           Separation, with motions given relative to the whole
       vm_attach_relative             Attachment, with motions given relative to the first body
       vm_separate_relative2          Separation in the plane, with motions given relative to the whole
       vm_attach_relative2            Attachment in the plane, with motions given relative to the first body

     mechanics/inverse: how a part must leave, so that the rest moves as wanted
       vm_separation_for_rest         How a part must leave, so that the rest moves as wanted
       vm_separation_for_rest2        How a part must leave in the plane, so that the rest moves as wanted
       vm_separation_for_spin2        Velocity of a part that leaves the rest with a wanted spin, in the plane (Table 3, case 7)

     mechanics/jump_energy: the kinetic energy that a jump adds or takes
       vm_energy_gain                 Energy gained at a separation, J
       vm_energy_loss                 Energy lost at an attachment, J

     mechanics/broken_rotor: a rotor from which a piece breaks off: equations of motion and the break
       vm_broken_rotor_rhs            Right-hand side of the rotor's equations of motion, (65), (66), (68), (46)
       vm_broken_rotor_polar_rhs      Right-hand side of the rotor's equations of motion in polar form (75)
       vm_broken_rotor_to_polar       Convert the state {x, y, psi, x', y', psi'} of a rotor to its polar state
       vm_broken_rotor_from_polar     Convert the polar state {r, phi, psi, r', phi', psi'} of a rotor to {x, y, psi, x', y', psi'}
       vm_broken_rotor_break_off      Remainder and piece of a rotor after the break, with their motions, (52)-(64) corrected

     mechanics/broken_rotor_motion: motion of the broken rotor in closed form
       vm_broken_rotor_linear         State of the remainder t seconds after start, by the complete linearised equations (69)
       vm_broken_rotor_linear_uncoupled State of the remainder t seconds after start by (70)-(72), which lack a term of (69)
       vm_broken_rotor_free_motion    State of the unbroken rotor t seconds after start, exact, (46)-(51)
       vm_broken_rotor_orbit          Constants A0, B0, C0, D0 (51) of the unbroken rotor's elliptic orbit, m

     mechanics/broken_rotor_stability: steady motion of the broken rotor, its stability, growth at resonance
       vm_broken_rotor_steady_radius  Radius of the mass centre's circle in steady motion at psi' = Omega, m
       vm_broken_rotor_characteristic Characteristic polynomial of small motions about the steady motion, (81) corrected
       vm_broken_rotor_routh          First column of Routh's scheme of the characteristic polynomial
       vm_broken_rotor_is_stable      Whether the steady motion at psi' = Omega is asymptotically stable (82)
       vm_broken_rotor_eigenvalues    Roots re + i im of the characteristic polynomial, 1/s
       vm_broken_rotor_resonance_radius Radius of the orbit that grows at or above resonance, t seconds after a start from rest, m

     mechanics/generalized_force: generalized forces of forces and moments
       vm_lagrange_add_force          Add the generalized forces of a force and a moment

     mechanics/lagrange_jump: Lagrange's equations across a jump
       vm_lagrange_mass               Add a body's share to the mass matrix of the kinetic energy T = qdot^T matrix qdot/2
       vm_lagrange_momentum           Add to p the generalized momentum of a body's motion
       vm_lagrange_impulse            Add to p the generalized impulse (95) of an impulse on a body with the mass centre r
       vm_lagrange_separate           Velocities after a part separates
       vm_lagrange_attach             Velocities after a part is attached
       vm_lagrange_impact             Velocities after an impact that changes no mass

     mechanics/pendulum: a pendulum from which a part is cut
       vm_pendulum_separate           Motion of a pendulum and of the part that is cut off from it, (119)-(132)

     mechanics/torque_free: exact rotation of a body on which no torque acts
       vm_torque_free_init            Preparation of the exact torque-free motion of a body
       vm_torque_free_init_principal  Preparation of the exact torque-free motion from principal moments (kg m^2)
       vm_torque_free_attitude        Attitude and angular velocity of a torque-free body at the time t (s)
       vm_torque_free_at              A torque-free body at the time t (s)
       vm_torque_free_rotation        A torque-free body a time t (s) later, in one call

     mechanics/streams: streams of mass: reactive force, moment and torque
       vm_reactive_loads              Reactive force, moment and torque of n streams on a moving body, (156)-(158)
       vm_accelerations               Accelerations v' (159) and omega' (160) of a body under reactive and outer loads

     mechanics/flow: a free body in space with streams of mass
       vm_flow_rhs                    Right-hand side of a free body whose streams change its mass (151), (152)
       vm_flow_given_rhs              Right-hand side of a free body with given laws of mass, mass centre and inertia
       vm_flow_balanced_rhs           Right-hand side vm_flow_rhs with seven integrals that check the balances
       vm_flow_carried_rhs            Right-hand side of a free body that loses or gains mass which moves with the body (166)
       vm_flow_start                  Initial state y of a body with streams
       vm_flow_body                   The body that n states y describe, with a quaternion of length 1
       vm_flow_mass_left              Mass minus flow.least_mass, kg
       vm_flow_inertia_left           Smallest pivot of the inertia minus flow.least_inertia, kg m^2

     mechanics/flow2: a body in a plane with streams of mass
       vm_flow2_rhs                   Right-hand side of a body in the plane with streams of mass, (151), (152)

     mechanics/flow1: translation, and bodies on a line or an axle, with streams of mass
       vm_translation_rhs             Right-hand side of a body in translation with streams of mass
       vm_flow1_rhs                   Right-hand side of a body on a line or an axle with streams of mass, (173a), (175), (176)

     mechanics/rocket: closed forms: velocity by momentum, Tsiolkovsky's rocket, linear flow, jet damping
       vm_velocity_by_momentum        Velocity after a stream with the absolute velocity u changes the mass from m0 to m (151), (171)
       vm_tsiolkovsky                 Velocity of Tsiolkovsky's rocket after its mass changes from m0 to m
       vm_linear_flow                 Position and velocity on a line after t seconds of a stream of constant rate
       vm_jet_damping                 Angular velocity of a spinning rocket whose jet damps it, after t seconds, rad/s, body axes

     mechanics/supply: tanks and grains: mass, mass centre and inertia follow from the mass that is left
       vm_supply_at                   What is left of a tank or grain when its mass is `mass`

     mechanics/orbit: two bodies that attract each other, with constant masses and with masses that change
       vm_orbit                       Position and velocity after t seconds on an orbit about a centre with the attraction mu/r^2 (Kepler's problem)
       vm_orbit_meshchersky           Position and velocity after t seconds, while the attraction changes by Meshchersky's law mu/(1 + rate t)

     mechanics/drum: a band that winds up on a drum
       vm_drum_band                   The band's mass per angle on a drum, mu = R h b rho (181), kg/rad
       vm_drum_at                     Mass, mass centre and inertia of the drum with its band at an angle, (182)-(188)
       vm_drum_rhs                    Right-hand side of the drum on an elastic shaft, exact
       vm_drum_rhs_reduced            Right-hand side of the drum on an elastic shaft for a light band, (192), (193)
       vm_drum_rate                   Angular velocity phi' on a rigid shaft at the angle phi >= 0, rad/s
       vm_drum_rhs_angle              Right-hand side of the elastic shaft's vibration over the angle phi, (210), (211)
       vm_drum_stop                   Angle at which the drum on a rigid shaft comes to rest, rad
       vm_drum_time                   Time at which the drum on a rigid shaft reaches the angle phi >= 0, s (197)
       vm_drum_angle                  Angle of the drum on a rigid shaft after t >= 0 seconds, rad
       vm_drum_angle_lambert          Angle of the drum, rad, on a rigid shaft by Lambert's W, (198)-(206) corrected
       vm_drum_shaft_init             Coefficients of the elastic shaft in the first approximation, (213), (214)
       vm_drum_deflection             Deflection x or y of the elastic shaft, m, at angle phi, (224), (225) corrected
       vm_drum_shaft_valid            Whether the shaft's frequency, k sqrt(1 - A phi), stays real for the whole first layer (226)

     mechanics/lagrange: Lagrange's equations with variable mass
       vm_lagrange_rhs                Right-hand side of Lagrange's equations with variable mass (247)
       vm_lagrange_start              Initial state y of a system at time t, from its n coordinates q and n rates q'
       vm_lagrange_rates              Rates q' of a system at time t, from its state y
       vm_lagrange_partial_q          Derivative dT/dq_i of the kinetic energy with frozen masses, J per unit of q_i

     mechanics/euler_angles: Euler's angles
       vm_euler_313                   Quaternion of length 1 that turns body axes into inertial ones, from Euler's angles
       vm_euler_313_axes              Unit vectors of the axes about which Euler's angles turn the body, along inertial axes
       vm_euler_313_body_axes         Unit vectors of the axes about which Euler's angles turn the body, along body axes
       vm_euler_313_rates             Rates psi', theta', phi' of Euler's angles from an angular velocity in inertial axes, rad/s

     oscillators/constant_mass: the oscillator x'' + omega0^2 x|x|^(alpha-1) = 0 of constant mass
       vm_osc_period                  Exact period (262), s, of the motion from rest at x0 (m, either sign)
       vm_osc_vmax                    Largest velocity (267), m/s, of the motion from rest at x0 (m, either sign)
       vm_osc_energy                  Energy per unit mass (259), v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1), m^2/s^2
       vm_osc_exact                   Exact motion x(t) (282) and x'(t) (283) from rest at x0 (m, either sign)
       vm_osc_amplitude_phase         Amplitude A >= 0 (m) and Ateb phase psi in (-Pi, Pi] of the state x (m), v (m/s)
       vm_osc_exact_from              Exact motion x(t), x'(t) from any state x(0) = x0 (m), x'(0) = v0 (m/s)
       vm_osc_omega_trig              Frequency Omega_alpha (293) of the cosine with the exact period of the oscillator, a pure number
       vm_osc_trig                    Approximation x0 cos(Omega t) (291) and its velocity (295), from rest at x0
       vm_osc_jacobi_parameter        Parameter m (307) of the cn that approximates x(t) with the exact period of the oscillator
       vm_osc_omega_jacobi            Frequency Omega_1* (300) of the cn with the exact period of the oscillator, a pure number
       vm_osc_jacobi                  Approximation x0 cn(Omega_1 t | m) (297) and its velocity (302), from rest at x0
       vm_osc_approximation_errors    Errors of the approximations by cos and cn, as the fields of vm_osc_errors

     oscillators/laws: laws of time for mass, stiffness and other numbers
       vm_law_at                      Value f and rate df/dt of a law at time t (s), which may be negative
       vm_law_linear                  Linear law f = f0 + f1 t (346); a constant where f1 = 0
       vm_law_quadratic               Quadratic law f = f0 + f1 t + f2 t^2
       vm_law_exponential             Exponential law f = f0 exp(f1 t)
       vm_law_power                   Power law f = f0 (1 + f1 t)^f2, for 1 + f1 t > 0
       vm_law_table                   Table of n >= 2 points (time[i], value[i]), joined by monotone cubics
       vm_law_user                    Law by a user's function, which must be smooth

     oscillators/closed: the law of order five as plain data, where all its integrals have closed forms
       vm_osc_closed_init             Prepares the motion of the problem by the law of an order, 2 to 5; a higher order is more accurate
       vm_osc_closed_at               Position x, m, and velocity v, m/s, at time t, s, of either sign, by the law of the order for which *c was prepared
       vm_osc_closed_at_order2        As vm_osc_closed_at, but by order 2 for any order of *c
       vm_osc_closed_at_order3        As vm_osc_closed_at, but by order 3; *c must have order 3 or more, else VM_BAD_ARGUMENT

     oscillators/plan: the plan of an oscillator: what is computed once and then used at many times t
       vm_osc_plan_init               Plan for many values of one problem's motion

     oscillators/panels: panels of time in which a law is smooth, and the integral of 1/f
       vm_law_inverse_integral        Integral of ds/f(s) from 0 to t, s per unit of f, for t of either sign

     oscillators/averaging: averaged equations of an oscillator with a force, and what averaging leaves out
       vm_osc_averaged                Averaged rates A', theta', psi' of amplitude and phase, with the problem's force

     oscillators/routes: the motion x(t) of an oscillator at any time, by a given route or by the cheapest
       vm_osc_route_name              Name of a route VM_ROUTE_..., in English; "unknown route" for any other number
       vm_osc_plan_by_route           Motion x(t), x'(t) at time t (s, either sign) by a given route, from a plan
       vm_osc_plan_within             Motion x(t), x'(t) at time t (s, either sign) within a tolerance, from a plan
       vm_osc_by_route                Motion x(t), x'(t) at time t (s, either sign) by a given route
       vm_osc_within                  Motion x(t), x'(t) at time t (s, either sign) within a tolerance

     oscillators/slow: laws that oscillators with slowly varying mass share
       vm_osc_amplitude_law           Amplitude over its first value, A/A0, of an oscillator whose mass varies slowly
       vm_osc_velocity_law            Largest velocity over its first value, of an oscillator whose mass varies slowly

     oscillators/van_der_pol: the Van der Pol oscillator with variable mass
       vm_vdp_init                    Prepare a Van der Pol oscillator
       vm_vdp_amplitude               Amplitude of a Van der Pol oscillator at time t, in closed form for a linear mass
       vm_vdp_limit_cycle             Amplitude of the limit cycle, m, while the mass changes at mass_rate (kg/s)
       vm_vdp_rhs                     Equation of motion (404) of a Van der Pol oscillator, for rk45 or rk87
       vm_vdp_averaged_rhs            Averaged equations (410) of a Van der Pol oscillator, for rk45 or rk87

     oscillators/jeffcott: the Jeffcott (Laval) rotor with variable mass
       vm_jeffcott_power              Stiffness F_e(rho)/rho = k rho^(alpha-1) of a power law, as a vm_jeffcott_stiffness
       vm_jeffcott_polar              Polar coordinates (448) of the disc's centre
       vm_jeffcott_momentum           Angular momentum of a rotor about its axis, with the gyroscopic share, kg m^2/s
       vm_jeffcott_rhs                Equation of motion (449), (450) of a rotor, for rk45 or rk87
       vm_jeffcott_to_averaged        Motion (x, y, x', y') of a rotor to forward and backward whirl, (456)-(461)
       vm_jeffcott_from_averaged      Motion (x, y, x', y') of a rotor from forward and backward whirl
       vm_jeffcott_exact_rhs          Exact equations (470)-(473) of forward and backward whirl, for rk45 or rk87
       vm_jeffcott_averaged_rhs       Averaged equations of forward and backward whirl, for rk45 or rk87
       vm_jeffcott_frequency          Frequency W of circular whirl of radius A, rad/s
       vm_jeffcott_forward_whirl_rhs  Averaged equations (506), (507) of forward whirl, for rk45 or rk87
       vm_jeffcott_backward_whirl_rhs Averaged equations (506), (507) of backward whirl, for rk45 or rk87
       vm_jeffcott_amplitude          Radius of circular whirl, m, after the mass has changed slowly

     oscillators/pair: two bodies with a nonlinear connection
       vm_pair_rhs                    Equations of motion (517), (518) of two bodies, for rk45 or rk87
       vm_pair_to_averaged            Motion y = (x, y, x', y') of two bodies to modes (A, psi, q, q'), (520)-(522)
       vm_pair_from_averaged          Motion y = (x, y, x', y') of two bodies from modes (A, psi, q, q')
       vm_pair_averaged_rhs           Averaged equations of the two modes of a pair, for rk45 or rk87
       vm_pair_at                     Motion of two bodies at time t, in closed form for a linear mass

     oscillators/forced: harmonic excitation of a strongly nonlinear oscillator
       vm_forced_init                 Prepare an excited oscillator
       vm_forced_rhs                  Equation of motion of an excited oscillator, for rk45 or rk87
       vm_forced_exact_rhs            Exact equations of amplitude and phase of an excited oscillator, for rk45 or rk87
       vm_forced_averaged_rhs         Averaged equations of an excited oscillator near its main resonance, for rk45 or rk87
       vm_forced_to_averaged          Motion (x, x', theta) of an excited oscillator to the mean y = (A, delta, theta)
       vm_forced_from_averaged        Motion (x, x', theta) of an excited oscillator from the mean y = (A, delta, theta)

     oscillators/resonance: steady vibrations, resonance curves, passage through resonance
       vm_forced_steady_states        Steady vibrations of an excited oscillator
       vm_forced_curve                Steady vibrations of a given amplitude A, m, at any frequency nu > 0
       vm_forced_peak                 Largest amplitude of the amplitude-frequency curve, m
       vm_forced_passage              Passage through the resonance

     oscillators/diagnostics: turning points and zero crossings of any trajectory, envelopes, adiabaticity
       vm_find_samples                Turning points or zero crossings of a trajectory in (t0, t1]
       vm_find_samples_of_step        Turning points or zero crossings in the last step of an rk45 or rk87
       vm_envelope_error              Largest relative error of an amplitude law, |law(t)/observed - 1|, over n samples
       vm_adiabaticity                Adiabaticity q/Om of an oscillator at time t and amplitude A, the small parameter of averaging

     scenes/motions: the bodies of a scene, and how each of them moves
       vm_scene_body_line             A body on a line
       vm_scene_body_axle             A body on a fixed axle
       vm_scene_body_plane            A body in the plane
       vm_scene_body_point            A point in space
       vm_scene_body_free             A body that moves and turns freely in space
       vm_scene_body_with_mass_state  A body like `body` whose mass is a state, so that streams can change the mass
       vm_scene_body_absent           A body like `body` that is not present until an event brings it in

     scenes/growing: bodies whose mass centre and inertia change
       vm_scene_body_growing_plane    A growing body in the plane
       vm_scene_body_growing_free     A growing body in space

     scenes/forces: the forces of effects, as functions of numbers
       vm_force_spring                The force of a spring, -k x |x|^(alpha-1) (248)
       vm_force_damper                The force of a linear damper, -damping v
       vm_force_van_der_pol           The force of Van der Pol's damper, (b - c x^2) v (404)
       vm_force_motor                 The torque of a motor, stall_torque - kappa omega
       vm_force_harmonic              The force of harmonic excitation, amplitude cos(frequency t + phase)
       vm_force_stream                The reactive force of a stream, rate (u - reactive v)
       vm_force_gravity               The weight of a mass, mass g
       vm_force_shaft                 The force of an elastic shaft, -k r |r|^(alpha-1), on a point at r = (x, y)
       vm_force_unbalance             The force of a rotating unbalance, m e Omega^2 (cos a, sin a) at the angle a = Omega t + phase
       vm_force_gyroscopic            The gyroscopic force normal to the velocity (vx, vy) in the plane, 2 gyro (-vy, vx)

     scenes/effects: springs, dampers, motors and other forces on a coordinate
       vm_effect_gravity              Gravity along a coordinate, the force M g
       vm_effect_spring               A nonlinear spring, the force -k z |z|^(alpha-1) with z = x - rest (248)
       vm_effect_linear_spring        A linear spring, the force -k (x - rest)
       vm_effect_damper               A linear damper, the force -damping v
       vm_effect_rotational_damper    A damper of the rotation, the torque -damping omega
       vm_effect_van_der_pol          Van der Pol's damper, the force (b - c x^2) v (404)
       vm_effect_motor                A motor, the torque stall_torque - kappa v
       vm_effect_harmonic             Harmonic excitation, the force amplitude cos(frequency t + phase)
       vm_effect_force_between        A force that the caller's function returns, between two coordinates
       vm_effect_force                A force that the caller's function returns
       vm_effect_custom               An effect that the caller's function applies
       vm_effect_shaft                An elastic shaft, the force -k r |r|^(alpha-1) on a body at r = (x, y)
       vm_effect_unbalance            A rotating unbalance, the force m e Omega^2 (cos a, sin a) at the angle a = Omega t + phase
       vm_effect_gyroscopic           A gyroscopic force normal to the velocity (vx, vy), 2 gyro (-vy, vx)

     scenes/gravitation: Newton's gravitation between bodies and towards a fixed centre
       vm_effect_gravitation          Gravitation between two bodies, the force G M1 M2/r^2
       vm_effect_central_gravity      Gravitation towards a centre at rest, the force mu M/r^2

     scenes/mass: mass that follows a law, and its reactive force
       vm_effect_mass_law             A mass law M(t, x, v) that the caller's function returns
       vm_effect_mass                 A mass that is M0 + c t, M0 + c x or M0 + c v^2, with its reactive force

     scenes/mass_of_time: mass that follows a vm_law, and its reactive force
       vm_effect_mass_of_time         A mass that follows a vm_law, with its reactive force

     scenes/streams: streams of mass into and out of the bodies of a scene
       vm_effect_stream               A stream that enters or leaves at the mass centre, with its reactive force
       vm_effect_stream_mass          Mass, mass centre and inertia that a stream brings to a growing body
       vm_effect_stream_force         Reactive force M' (u - v) of a stream at a point of a growing body (156)
       vm_effect_stream_moment        Moment d x M' (u - v) of a stream on a growing body (158)
       vm_effect_stream_torque        Torque M' kappa omega2 - I' omega of a stream on a growing body (157)
       vm_effect_varying              An effect of a stream that varies in time

     scenes/band: a band that winds up on a drum or off it
       vm_band_at                     Radius, mass and inertia of the band that is wound up at the angle phi
       vm_effect_band                 A band that winds up on a drum or off it, with its reactive torque

     scenes/links: rigid links and cords between bodies
       vm_effect_link                 A rigid link of a given length, or a cord, which can only pull

     scenes/state: the state of a scene: its size, and the bodies in it
       vm_scene_size                  Number of elements of the state of a scene
       vm_scene_body_at               The motion of a body in the state y

     scenes/evaluate: the right-hand side of a scene
       vm_scene_rhs                   The right-hand side of a scene, an ode_rhs

     scenes/check: what can be wrong with a scene
       vm_scene_check                 The first thing that is wrong with a scene, or VM_OK

     scenes/start: the start of a scene
       vm_scene_start                 Start of a scene at time t

     scenes/balance: the budget of momentum, angular momentum and energy of a scene
       vm_scene_keep_budget           Makes a scene keep a budget of momentum, angular momentum and energy
       vm_scene_budget_at             The budget of a scene in the state y at time t

     scenes/events: when an event happens, and what it does
       vm_event_at                    An event at a time in s, which happens once
       vm_event_position              An event when a position crosses a value
       vm_event_velocity              An event when a velocity crosses a value
       vm_event_mass                  An event when a mass crosses a value
       vm_event_user                  An event when a function of the caller crosses zero
       vm_then_stop                   The event ends the run
       vm_then_switch                 The event switches an effect off (off = 1) or on (off = 0)
       vm_then_user                   The event calls a function of the caller

     scenes/jumps: separation and attachment as events of a scene
       vm_then_separate_on_line       The event separates a part from a body on a line or on an axle
       vm_then_separate_in_plane      The event separates a part from a body in the plane
       vm_then_separate               The event separates a part from a body, which may have any kind of motion
       vm_then_attach_on_line         The event attaches a body to another body on the same line or axle
       vm_then_attach_in_plane        The event attaches a body to another body in the plane
       vm_then_attach                 The event attaches a body to another body; both may have any kind of motion

     scenes/run: runs of a scene with its events and its output
       vm_scene_run                   Run of a scene from *t to t_end, with its events and its output */
#ifndef VARMASS_H
#define VARMASS_H

#include "ateb.h"
#include "integrators.h"
#include "jacobi.h"

/* base/status.h - the statuses that functions return, and what each of them means

   Every function of varmass.h that can fail returns one of these numbers. 0 (VM_OK) means that all went well. A
   positive number means that the result is there, with a remark. A negative number means that nothing was done: the
   outputs are untouched. The same mistake has the same status in every function, and where a call has several
   mistakes, the status names the first of them in this order:

       a null pointer, a negative count, a choice that does not exist    VM_BAD_ARGUMENT
       an infinite number or NaN                                         VM_NOT_FINITE
       a mass that is not positive                                       VM_BAD_MASS
       a stiffness that is not positive                                  VM_BAD_STIFFNESS
       an inertia that no body can have                                  VM_BAD_INERTIA
       an exponent or another parameter outside its domain               VM_DOMAIN

       vm_body rest;
       int status = vm_separate(&whole, &part, NULL, &rest); // whole and part are vm_bodies
       if (status < 0) printf("%s\n", vm_strerror(status));

   Tests: tests/test_errors.sh, tests/test_refusals_*.c. */
#ifndef VARMASS_BASE_STATUS_H
#define VARMASS_BASE_STATUS_H

#include <string.h>

enum {
    VM_OK = 0,                   /* success */
    VM_NULL_AXIS = 1,            /* done, but a body (a rod, a point) has no inertia about an axis: it keeps its spin
                                    about this axis, and the angular momentum that the spin should take up is lost */
    VM_STOPPED = 2,              /* done: an event or the caller has ended the run */
    VM_TOLERANCE_MISSED = 3,     /* done, but the estimated error is larger than the tolerance */
    VM_BAD_ARGUMENT = -1,        /* a null pointer, a negative count, or a choice that does not exist */
    VM_NOT_FINITE = -2,          /* an argument, or a number computed from the arguments, is infinite or NaN */
    VM_BAD_MASS = -3,            /* a mass is not positive; in a separation this may be the remaining body's mass */
    VM_BAD_INERTIA = -4,         /* no body can have this inertia; in a separation this may be the remaining body's */
    VM_SINGULAR = -5,            /* a system of linear equations has no unique solution */
    VM_DOMAIN = -6,              /* a parameter lies outside its domain */
    VM_NO_LAW = -7,              /* this problem has no such route (method of solution) or closed form */
    VM_NOT_INTEGRATED = -8,      /* oscillators: the integrator did not reach the end */
    VM_BAD_MOTION = -9,          /* scenes: a kind of motion does not exist, or no such effect or event can act on it */
    VM_NO_SUCH_BODY = -10,       /* scenes: no body has this index */
    VM_NO_SUCH_COORDINATE = -11, /* scenes: the body has no such coordinate */
    VM_NO_SUCH_EFFECT = -12,     /* scenes: no effect has this index */
    VM_TWO_MASS_LAWS = -13,      /* scenes: a mass has two laws, or it has a law and is a component of the state too */
    VM_BAD_ORDER = -14,          /* scenes: the law of a body's mass stands after another effect on this body */
    VM_MASS_IS_NO_STATE = -15,   /* scenes: a stream acts on a body whose mass is not a state */
    VM_TOO_MANY_EVENTS = -16,    /* scenes: events follow each other without end */
    VM_BAD_OPTIONS = -17,        /* scenes: the integrator refuses its options */
    VM_STEP_TOO_SMALL = -18,     /* scenes: the tolerance needs steps too short to change the time */
    VM_MAX_STEPS = -19,          /* scenes: max_steps steps were tried before t_end was reached */
    VM_SHORT_ARRAY = -20,        /* scenes and flows: an array is shorter than what is written into it */
    VM_BAD_TIMES = -21,          /* scenes: the times of output do not rise, or t_end lies before the present time */
    VM_SAME_BODY = -22,          /* scenes: a link or a jump connects a body with itself */
    VM_NOT_ON_ANGLE = -23,       /* scenes: this effect cannot act on an angle */
    VM_IS_THERE = -24,           /* scenes: a part would separate into a body that is present already */
    VM_IS_AWAY = -25,            /* scenes: a jump needs a body that is not present */
    VM_TWO_LINKS = -26,          /* scenes: a body has two links */
    VM_LINK_NOT_LAST = -27,      /* scenes: another effect on the body stands after its link */
    VM_STORED_STREAM = -28,      /* scenes and reactive loads: a stream comes from a store, which cannot be used here */
    VM_DOES_NOT_GROW = -29,      /* scenes: a stream enters or leaves at a point of a body that is not a growing body */
    VM_NO_EFFECTIVE_MASS = -30,  /* scenes: a mass law M(v) makes the effective mass M + M'(v) (reactive v - u) <= 0 */
    VM_NOT_STARTED = -31,        /* scenes: the scene was not started, or was changed after its start */
    VM_BAD_STIFFNESS = -32       /* a stiffness is not positive */
};

/* The number of elements of an array, as in scene.y_size = VM_LENGTH(y). The result is wrong for a pointer. */
#define VM_LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))

/* The meaning of a status as a line of text. For an error the text also says, where possible, what to do. The status
   may be any number. */
VM_API const char *vm_strerror(int status)
{
    switch (status) {
    case VM_OK: return "success";
    case VM_NULL_AXIS: return "angular momentum about an axis without inertia was lost";
    case VM_STOPPED: return "an event or the caller ended the run";
    case VM_TOLERANCE_MISSED: return "the estimated error is larger than the tolerance";
    case VM_BAD_ARGUMENT: return "a null pointer, a negative count, or a choice that does not exist";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass is not positive";
    case VM_BAD_INERTIA: return "no body can have this inertia";
    case VM_SINGULAR: return "the linear equations have no unique solution";
    case VM_DOMAIN: return "a parameter is outside its domain";
    case VM_NO_LAW: return "no such route or closed form exists for this problem: choose another route, or integrate";
    case VM_NOT_INTEGRATED: return "the integrator did not reach the end: allow a larger tolerance";
    case VM_BAD_MOTION: return "no body moves in this way, or the effect or event cannot act on a body that does";
    case VM_NO_SUCH_BODY: return "no body has this index: count from 0, the ground is VM_GROUND";
    case VM_NO_SUCH_COORDINATE: return "the body has no such coordinate: count from 0";
    case VM_NO_SUCH_EFFECT: return "no effect has this index: count from 0";
    case VM_TWO_MASS_LAWS: return "a mass has two laws, or has a law and is a state as well: leave one out";
    case VM_BAD_ORDER: return "the law of a mass stands after another effect on its body: list it first";
    case VM_MASS_IS_NO_STATE: return "the stream needs a body whose mass is a state: use vm_scene_body_with_mass_state";
    case VM_TOO_MANY_EVENTS: return "events follow each other without end: let an event stop the run";
    case VM_BAD_OPTIONS: return "the integrator refuses its options: check the tolerances, h0, h_min and h_max";
    case VM_STEP_TOO_SMALL: return "steps became too short to change the time: allow a larger tolerance";
    case VM_MAX_STEPS: return "max_steps steps did not reach t_end: run again to continue, or allow more";
    case VM_SHORT_ARRAY: return "an array is too short: give y or work more room";
    case VM_BAD_TIMES: return "the times of output must rise, and t_end must not lie before the present time";
    case VM_SAME_BODY: return "a link or a jump connects a body with itself: choose two bodies";
    case VM_NOT_ON_ANGLE: return "this effect cannot act on an angle: choose another coordinate";
    case VM_IS_THERE: return "the part that separates is present already: make its body with vm_scene_body_absent";
    case VM_IS_AWAY: return "a jump needs a body that is not present: order the events, or let it be present";
    case VM_TWO_LINKS: return "a body has two links: leave one out";
    case VM_LINK_NOT_LAST: return "another effect stands after the link of its body: list the link last";
    case VM_STORED_STREAM: return "a stream from this store cannot be used here: integrate vm_flow_rhs";
    case VM_DOES_NOT_GROW: return "the stream needs a growing body: vm_scene_body_growing_plane or _growing_free";
    case VM_NO_EFFECTIVE_MASS:
        return "M + M'(v) (reactive v - u) of the mass law M(v) is not positive: no force accelerates it";
    case VM_NOT_STARTED: return "the scene was not started, or was changed after its start: call vm_scene_start";
    case VM_BAD_STIFFNESS: return "a stiffness is not positive";
    default: return "unknown status";
    }
}

/* Returns the rank of an error: of two errors, the one with the smaller rank is reported. The ranks follow the order at
   the top of this file; errors that are not named there follow in the order of their numbers. */
VM_API int vmi_error_rank(int status)
{
    if (status == VM_BAD_STIFFNESS) return 2 * -VM_BAD_MASS + 1;
    return 2 * -status;
}

/* Of two statuses, returns the one that takes precedence: an error before VM_OK, and of two errors the one that stands
   first in the order of vmi_error_rank. */
VM_API int vmi_first_error(int a, int b)
{
    if (a == VM_OK) return b;
    if (b == VM_OK || vmi_error_rank(a) < vmi_error_rank(b)) return a;
    return b;
}

/* Copies n numbers if all of them are finite. Returns VM_OK, or VM_NOT_FINITE and leaves the target as it was. */
VM_API int vmi_copy_if_finite(int n, const vm_real *from, vm_real *to)
{
    if (!vmi_all_finite(n, from)) return VM_NOT_FINITE;
    memcpy(to, from, (size_t)n * sizeof *to);
    return VM_OK;
}

#endif
/* base/linear.h - systems of linear equations

   The functions solve a x = b for a few unknowns x. The matrix a is an array of n n numbers, row after row.

       vm_real a[4] = {2, 1, 1, 3}, b[2] = {3, 5};
       vmi_solve_linear(2, a, b); // b is now x = (0.8, 1.4)

   Tests: tests/test_lagrange.c, tests/test_scenes.c. */
#ifndef VARMASS_BASE_LINEAR_H
#define VARMASS_BASE_LINEAR_H

/* Eliminates the unknown x[k] from the equations k + 1 to n - 1 of the system a x = b. */
VM_API void vmi_eliminate(int n, int k, vm_real *a, vm_real *b)
{
    int i, j;
    for (i = k + 1; i < n; i++) {
        const vm_real factor = a[i * n + k] / a[k * n + k];
        for (j = k + 1; j < n; j++) a[i * n + j] -= factor * a[k * n + j];
        b[i] -= factor * b[k];
    }
}

/* Solves a x = b for a triangular matrix a. Its entries below the diagonal are not read. x replaces b. */
VM_API void vmi_substitute_back(int n, const vm_real *a, vm_real *b)
{
    int j, k;
    for (k = n - 1; k >= 0; k--) {
        for (j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
}

/* Solves a x = b for any matrix by elimination with exchange of rows. x replaces b, and a is overwritten. Returns
   VM_SINGULAR if the pivot of a column is 0 or NaN (b is overwritten then, too), and VM_OK otherwise. */
VM_API int vmi_solve_linear(int n, vm_real *a, vm_real *b)
{
    int i, j, k;
    for (k = 0; k < n; k++) {
        int pivot = k;
        vm_real x;
        for (i = k + 1; i < n; i++)
            if (VM_FABS(a[i * n + k]) > VM_FABS(a[pivot * n + k])) pivot = i;
        if (!(VM_FABS(a[pivot * n + k]) > 0)) return VM_SINGULAR;
        for (j = k; j < n; j++) {
            x = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = x;
        }
        x = b[k];
        b[k] = b[pivot];
        b[pivot] = x;
        vmi_eliminate(n, k, a, b);
    }
    vmi_substitute_back(n, a, b);
    return VM_OK;
}

/* Solves a x = b for a mass matrix, which is symmetric and positive definite. x replaces b, a is overwritten, and
   scale is work space for n numbers. Rows and columns are first scaled so that the diagonal is 1: then the units of
   the coordinates do not matter, and the condition number is nearly the least that scaling can reach (van der Sluis
   1969). Rows need not be exchanged. Returns VM_SINGULAR if an entry of the diagonal is not positive or a pivot is
   not above 4 n eps, as for every matrix that is not positive definite, and VM_OK otherwise. */
VM_API int vmi_solve_mass(int n, vm_real *a, vm_real *b, vm_real *scale)
{
    int i, j;
    for (i = 0; i < n; i++) {
        if (!(a[i * n + i] > 0)) return VM_SINGULAR;
        scale[i] = VM_SQRT(a[i * n + i]);
    }
    for (i = 0; i < n; i++) {
        for (j = 0; j < n; j++) a[i * n + j] = a[i * n + j] / scale[i] / scale[j];
        b[i] /= scale[i];
    }
    for (i = 0; i < n; i++) {
        if (!(a[i * n + i] > (vm_real)(4 * n) * VM_EPSILON)) return VM_SINGULAR;
        vmi_eliminate(n, i, a, b);
    }
    vmi_substitute_back(n, a, b);
    for (i = 0; i < n; i++) b[i] /= scale[i];
    return VM_OK;
}

#endif
/* base/zero.h - a zero of a function between two points where its signs differ

       vm_real x = vmi_find_zero(f, NULL, 0, 2, f(0, NULL), f(2, NULL)); // f(x, ctx) has a zero between 0 and 2

   Tests: tests/test_jeffcott.c, tests/test_diagnostics.c. */
#ifndef VARMASS_BASE_ZERO_H
#define VARMASS_BASE_ZERO_H

/* Returns a zero of f between a and b, as accurate as the type allows, where fa = f(a) and fb = f(b) have opposite
   signs. Method (Illinois): the next x is the zero of the secant through both ends of the interval; when one end has
   stayed for two steps, its value of f is halved. Every fourth step bisects the interval unless the last four steps
   have made it eight times shorter. */
VM_API vm_real vmi_find_zero(vm_real (*f)(vm_real x, void *ctx), void *ctx, vm_real a, vm_real b, vm_real fa,
                             vm_real fb)
{
    vm_real width = VM_FABS(b - a);
    int i, side = 0;
    if (fa == 0) return a;
    if (fb == 0) return b;
    for (i = 1; i < 3 * VM_MANT_DIG + 60; i++) {
        vm_real x = a - fa * ((b - a) / (fb - fa)), fx;
        if (i % 4 == 0) {
            if (VM_FABS(b - a) > width / 8) {
                x = a + (b - a) / 2;
                side = 0;
            }
            width = VM_FABS(b - a);
        }
        if (!((x > a) == (x < b)) || x == a || x == b) x = a + (b - a) / 2;
        if (x == a || x == b) break;
        fx = f(x, ctx);
        if (fx == 0) return x;
        if ((fx > 0) == (fb > 0)) {
            b = x;
            fb = fx;
            if (side == 1) fa /= 2;
            side = 1;
        } else {
            a = x;
            fa = fx;
            if (side == -1) fb /= 2;
            side = -1;
        }
    }
    if (VM_FABS(fa) < VM_FABS(fb)) return a;
    return b;
}

#endif
/* base/hypot.h - the length of a vector in the plane

   Tests: tests/test_jumps.c, tests/test_laws.c. */
#ifndef VARMASS_BASE_HYPOT_H
#define VARMASS_BASE_HYPOT_H

/* Returns the length sqrt(x^2 + y^2), also where the squares overflow or underflow, and NaN if x or y is NaN. */
VM_API vm_real vmi_hypot(vm_real x, vm_real y)
{
    const vm_real a = VM_FABS(x), b = VM_FABS(y), most = vmi_larger(a, b), least = vmi_smaller(b, a);
    vm_real q = 0;
    if (x != x || y != y) return VM_NAN;
    if (most > 0) q = least / most;
    return most * VM_SQRT(1 + q * q);
}

#endif
/* base/complex.h - complex numbers

       vm_complex z = vmi_c_times(vmi_complex(0, 1), vmi_complex(3, 4)); // i (3 + 4i) = -4 + 3i

   Tests: tests/test_jeffcott.c, tests/test_broken_rotor.c. */
#ifndef VARMASS_BASE_COMPLEX_H
#define VARMASS_BASE_COMPLEX_H

/* A complex number re + i im */
typedef struct VM_TAG(vm_complex) {
    vm_real re, im;
} vm_complex;

/* Returns the complex number re + i im. */
VM_API vm_complex vmi_complex(vm_real re, vm_real im)
{
    vm_complex z;
    z.re = re;
    z.im = im;
    return z;
}

/* The sum a + b, the difference a - b, and the products c a and i c a with a real number c */
VM_API vm_complex vmi_c_add(vm_complex a, vm_complex b) { return vmi_complex(a.re + b.re, a.im + b.im); }
VM_API vm_complex vmi_c_sub(vm_complex a, vm_complex b) { return vmi_complex(a.re - b.re, a.im - b.im); }
VM_API vm_complex vmi_c_scale(vm_real c, vm_complex a) { return vmi_complex(c * a.re, c * a.im); }
VM_API vm_complex vmi_c_times_i(vm_real c, vm_complex a) { return vmi_complex(-c * a.im, c * a.re); }

/* The product a b */
VM_API vm_complex vmi_c_times(vm_complex a, vm_complex b)
{
    return vmi_complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

/* The complex conjugate of a, which is a.re - i a.im */
VM_API vm_complex vmi_c_conjugate(vm_complex a) { return vmi_complex(a.re, -a.im); }

/* The complex number e^(i angle), for an angle in radians */
VM_API vm_complex vmi_c_turn(vm_real angle)
{
    vm_complex e;
    vmi_sincos(angle, &e.im, &e.re);
    return e;
}

/* The modulus |z| */
VM_API vm_real vmi_c_modulus(vm_complex z) { return vmi_hypot(z.re, z.im); }

/* The quotient a/b by Smith's method, which is also right where |b|^2 overflows or underflows */
VM_API vm_complex vmi_c_over(vm_complex a, vm_complex b)
{
    vm_real q, d;
    if (VM_FABS(b.re) < VM_FABS(b.im)) {
        q = b.re / b.im;
        d = b.im + b.re * q;
        return vmi_complex((a.re * q + a.im) / d, (a.im * q - a.re) / d);
    }
    q = b.im / b.re;
    d = b.re + b.im * q;
    return vmi_complex((a.re + a.im * q) / d, (a.im - a.re * q) / d);
}

#endif
/* base/polynomial.h - all roots of a polynomial

   The polynomial is c[0] z^n + c[1] z^(n-1) + ... + c[n] with c[0] != 0. Its roots, real and complex, are found
   together, by the method of Ehrlich and Aberth.

       vm_real c[3] = {1, -3, 2}, re[2], im[2];
       vmi_poly_roots(2, c, re, im); // 2 and 1

   Tests: tests/test_broken_rotor.c. */
#ifndef VARMASS_BASE_POLYNOMIAL_H
#define VARMASS_BASE_POLYNOMIAL_H

/* Returns the correction that is subtracted from the approximate root i. It is Newton's step for the polynomial divided
   by z - z_j for each other approximate root z_j; this division keeps two approximations from converging to the same
   root. The correction is 0 where the polynomial is 0 within its rounding errors. */
VM_API vm_complex vmi_poly_step(int n, const vm_real *c, const vm_real *re, const vm_real *im, int i)
{
    const vm_complex z = vmi_complex(re[i], im[i]), one = vmi_complex(1, 0);
    const vm_real modulus = vmi_hypot(z.re, z.im);
    vm_complex p = vmi_complex(c[0], 0), slope = vmi_complex(0, 0), others = slope;
    vm_real size = VM_FABS(c[0]);
    int j;
    for (j = 1; j <= n; j++) {
        const vm_complex q = vmi_c_times(slope, z);
        slope = vmi_complex(q.re + p.re, q.im + p.im);
        p = vmi_c_times(p, z);
        p.re += c[j];
        size = size * modulus + VM_FABS(c[j]);
    }
    if (VM_FABS(p.re) + VM_FABS(p.im) <= VM_EPSILON * size) return vmi_complex(0, 0);
    for (j = 0; j < n; j++) {
        const vm_complex apart = vmi_complex(z.re - re[j], z.im - im[j]);
        vm_complex share;
        if (j == i || (apart.re == 0 && apart.im == 0)) continue;
        share = vmi_c_over(one, apart);
        others.re += share.re;
        others.im += share.im;
    }
    others = vmi_c_times(p, others);
    return vmi_c_over(p, vmi_complex(slope.re - others.re, slope.im - others.im));
}

/* Returns 1 if the polynomial is 0 within its rounding errors at the real number x, else 0. */
VM_API int vmi_poly_root_is_real(int n, const vm_real *c, vm_real x)
{
    vm_real p = c[0], size = VM_FABS(c[0]);
    int j;
    for (j = 1; j <= n; j++) {
        p = p * x + c[j];
        size = size * VM_FABS(x) + VM_FABS(c[j]);
    }
    return VM_FABS(p) <= (vm_real)(4 * n) * VM_EPSILON * size;
}

/* Exchanges the roots i and j. */
VM_API void vmi_poly_swap(vm_real *re, vm_real *im, int i, int j)
{
    const vm_real x = re[i], y = im[i];
    re[i] = re[j];
    im[i] = im[j];
    re[j] = x;
    im[j] = y;
}

/* Sorts the roots: first the real roots from the largest to the smallest, then the conjugate pairs by rising |im|, in
   each pair the root with im > 0 first. Imaginary parts that are only rounding errors become 0, and the two roots of a
   pair become exactly conjugate. */
VM_API void vmi_poly_order(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const vm_real tolerance = 16 * VM_SQRT(VM_EPSILON); /* rounding may split a double root by this fraction of it */
    int i, j, k;
    for (i = 0; i < n; i++) {
        if (VM_FABS(im[i]) <= tolerance * VM_FABS(re[i]) && vmi_poly_root_is_real(n, c, re[i])) im[i] = 0;
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

/* Computes the n roots (re[i], im[i]) of a polynomial of degree n. The error of a simple root is a few n eps times
   its condition number. */
VM_API void vmi_poly_roots(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const int most_sweeps = 100;
    int i, sweep, moving = 1, m = n;
    while (m > 0 && c[m] == 0) {
        m--;
        re[m] = im[m] = 0;
    }
    for (i = 0; i < m; i++) /* start values symmetric about the real axis would stay symmetric; these are not */
        vmi_sincos(VM_C(0.4) + 2 * VM_PI * (vm_real)i / (vm_real)m, &im[i], &re[i]);
    for (sweep = 0; sweep < most_sweeps && moving; sweep++) {
        for (moving = i = 0; i < m; i++) {
            const vm_complex step = vmi_poly_step(m, c, re, im, i);
            re[i] -= step.re;
            im[i] -= step.im;
            moving += VM_FABS(step.re) + VM_FABS(step.im) > VM_EPSILON * (VM_FABS(re[i]) + VM_FABS(im[i]));
        }
    }
    vmi_poly_order(n, c, re, im);
}

#endif
/* base/lambert.h - Lambert's function W

   w = W(x) solves w e^w = x. The equation has one solution for x >= 0 and two for -1/e <= x < 0: the branch W_0 >= -1
   (vm_lambert_w0) and the branch W_-1 <= -1 (vm_lambert_wm1). The functions that take the logarithm of the argument
   work where the argument itself would overflow or underflow.

       vm_real w = vm_lambert_w0(1); // 0.567..., the solution of w e^w = 1

   Method: two steps of fourth order by Fritsch, Shafer and Crowley (Comm. ACM 16, 1973) from a start value with an
   error of at most 2 %. The residual is computed in two words, so that the error is little more than a rounding.
   Tests: tests/test_lambert.c. */
#ifndef VARMASS_BASE_LAMBERT_H
#define VARMASS_BASE_LAMBERT_H

/* Returns the relative correction of w by Fritsch, Shafer and Crowley, where z = ln(x/w) - w is the residual and
   w1 = 1 + w */
VM_API vm_real vmi_lambert_correction(vm_real w1, vm_real z)
{
    const vm_real first = z / w1, half_q = w1 + 2 * z / 3;
    return first * ((half_q - first / 2) / (half_q - first));
}

/* Returns Lambert's W of a number x that is not close to -1/e, from l = ln|x| in two words and a rough value w of W. */
VM_API vm_real vmi_lambert_far(vm_two l, vm_real w)
{
    int i;
    for (i = 0; i < 2; i++) {
        const vm_two ln = vmi_log(VM_FABS(w));
        const vm_two z = vmi_two_plus(vmi_two_plus(l, vmi_minus(ln)), vmi_two(-w, 0));
        w += w * vmi_lambert_correction(1 + w, z.hi);
    }
    return w;
}

/* Returns Lambert's W of x < 0 from s = -1 - ln(-x). If `lower` is 1, this is W_-1; if it is 0, it is W_0, for x close
   to -1/e. Method: W = -1 - v, where v solves v - ln(1 + v) = s, v > 0 for W_-1 and v < 0 for W_0. A value of s between
   -eps/2 and 0 is caused by rounding and means x = -1/e. v starts from a formula by Barry, Culligan-Hensley and Barry
   (ACM TOMS 21, 1995) for W_-1, and from a series in sqrt(2s) for W_0, which is good for s < 0.4. */
VM_API vm_real vmi_lambert_near(vm_two s, int lower)
{
    const vm_real barry = VM_C(0.3361), root = VM_SQRT(2 * s.hi);
    vm_real v, dv = 0;
    vm_two sum;
    int i;
    if (!(s.hi > -VM_EPSILON / 2)) return VM_NAN;
    if (s.hi <= 0) return -1;
    if (lower) v = s.hi + 2 / barry * (1 - 1 / (1 + barry / 2 * root));
    else v = -root * (1 - root * (VM_C(1.) / 3 - root / 36));
    for (i = 0; i < 2; i++) {
        vm_two x, z, ln;
        v += dv;
        x = vmi_two(v, 0);
        ln = vmi_log1p(x);
        if (VM_FABS(v) < VM_C(0.25)) z = vmi_two_times(vmi_log1p_rest(x, ln), vmi_two_product(v, v));
        else z = vmi_two_plus(x, vmi_minus(ln));
        z = vmi_two_plus(z, vmi_minus(s));
        dv = (1 + v) * vmi_lambert_correction(-v, z.hi);
    }
    sum = vmi_two_sum(1, v);
    return -(sum.hi + (sum.lo + dv));
}

/* Returns -1 - ln(-x), the s of vmi_lambert_near, for x < -1/4. It is computed from 1 + e x in two words, so that it
   keeps its digits where x is close to -1/e. */
VM_API vm_two vmi_lambert_depth(vm_real x)
{
#if VM_MANT_DIG > 24
    const vm_two e = vmi_two(VM_C(2.718281828459045091), VM_C(1.445646891729250137e-16));
#else
    const vm_two e = vmi_two(VM_C(2.71828174591064453125), VM_C(8.2548400704e-8));
#endif
    const vm_two q = vmi_two_plus(vmi_two(1, 0), vmi_two_times(vmi_two(x, 0), e));
    const vm_two ln = vmi_log1p(vmi_minus(q));
    return vmi_minus(ln);
}

/* A rough value of W_0(x), right to 2 %, for -1/4 <= x < 1 */
VM_API vm_real vmi_lambert_pade(vm_real x) { return x * (3 + 4 * x) / (3 + x * (7 + x * VM_C(2.5))); }

/* A rough value of W_0(x), right to 2 %, for x >= 1, from L = ln(1 + x) (by Winitzki) */
VM_API vm_real vmi_lambert_winitzki(vm_real L) { return L * (1 - vmi_log(1 + L).hi / (2 + L)); }

/* Lambert's W_0(x), the upper branch: the solution w >= -1 of w e^w = x, for x >= -1/e. x is a pure number and taken
   as exact. The error is at most 1 ulp. Returns infinity for infinite x > 0, and NaN for x < -1/e, except that the
   number next to -1/e counts as -1/e and gives -1. */
VM_API vm_real vm_lambert_w0(vm_real x)
{
    vm_real start;
    if (x == 0 || x != x || x == VM_INFINITY) return x;
    if (x == -VM_INFINITY) return VM_NAN;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 0);
    if (x < 1) start = vmi_lambert_pade(x);
    else start = vmi_lambert_winitzki(vmi_log(1 + x).hi);
    return vmi_lambert_far(vmi_log(VM_FABS(x)), start);
}

/* Lambert's W_-1(x), the lower branch: the solution w <= -1 of w e^w = x, for -1/e <= x < 0. x is a pure number and
   taken as exact. The error is at most 1 ulp. Returns -infinity for x = 0, and NaN for x > 0 and x < -1/e, except
   that the number next to -1/e counts as -1/e and gives -1. */
VM_API vm_real vm_lambert_wm1(vm_real x)
{
    vm_two ln;
    if (!(x <= 0) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 1);
    ln = vmi_log(-x);
    return vmi_lambert_near(vmi_two_plus(vmi_two(-1, 0), vmi_minus(ln)), 1);
}

#define VMI_LAMBERT_TINY (-(VM_MANT_DIG + 2) * VM_C(0.7)) /* if ln|x| is less than this number, W_0(x) rounds to x */

/* Wright's omega function W_0(e^l), the solution w of w + ln w = l, for any l. It also works where e^l itself
   overflows or underflows. l is taken as exact. The error is at most 1 ulp. Returns infinity for l = infinity
   and 0 for l = -infinity. */
VM_API vm_real vm_wright_omega(vm_real l)
{
    const vm_real direct_from = 40; /* for l >= 40, ln(1 + e^l) rounds to l */
    vm_real start;
    if (l != l || l == VM_INFINITY) return l;
    if (l < VMI_LAMBERT_TINY) return vmi_exp(l, 0);
    if (l < 0) start = vmi_lambert_pade(vmi_exp(l, 0));
    else if (l < direct_from) start = vmi_lambert_winitzki(vmi_log(1 + vmi_exp(l, 0)).hi);
    else start = vmi_lambert_winitzki(l);
    return vmi_lambert_far(vmi_two(l, 0), start);
}

/* W_0(-e^l), the upper branch for a negative argument given by its logarithm, l <= -1. It also works where e^l itself
   underflows. l is taken as exact. The error is at most 1 ulp. Returns 0 for l = -infinity and NaN for l > -1. */
VM_API vm_real vm_lambert_w0_neg_exp(vm_real l)
{
    if (!(l <= -1)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return -vmi_exp(l, 0);
    if (l > VM_C(-1.375)) return vmi_lambert_near(vmi_two(-1 - l, 0), 0);
    return vmi_lambert_far(vmi_two(l, 0), vmi_lambert_pade(-vmi_exp(l, 0)));
}

/* W_-1(-e^l), the lower branch for an argument given by its logarithm, l <= -1. It also works where e^l itself
   underflows. l is taken as exact. The error is at most 1 ulp. Returns -infinity for l = -infinity and NaN for
   l > -1. */
VM_API vm_real vm_lambert_wm1_neg_exp(vm_real l)
{
    if (!(l <= -1)) return VM_NAN;
    if (l == -VM_INFINITY) return l;
    if (l < -1 / VM_EPSILON) return vmi_lambert_far(vmi_two(l, 0), l);
    return vmi_lambert_near(vmi_two_sum(-1, -l), 1);
}

#endif
/* mechanics/vectors.h - vectors, quaternions and rotations in space
   The two types, vm_vec3 and vm_quat, are plain data. A quaternion turns body axes into inertial ones. Its length does
   not matter, and a quaternion of four zeros stands for the identity.

       vm_vec3 omega = {0, 0, 3};                 // x, y, z
       vm_quat quarter_turn = {0.7071068, 0, 0, 0.7071068}; // w, x, y, z: 90 degrees about z

   The functions are internal: sums and products of vectors, norms, rotation matrices, and functions that read three
   or four numbers of a state as a vector or a quaternion. They do not check their arguments. Tests: tests/test_jumps.c,
   tests/test_torque_free.c. */
#ifndef VARMASS_MECHANICS_VECTORS_H
#define VARMASS_MECHANICS_VECTORS_H

/* A vector by its components */
typedef struct VM_TAG(vm_vec3) {
    vm_real x, y, z;
} vm_vec3;

/* An attitude: the quaternion w + x i + y j + z k turns body axes into inertial ones. Its length does not matter. */
typedef struct VM_TAG(vm_quat) {
    vm_real w, x, y, z;
} vm_quat;

/* A 3 by 3 matrix by its columns. The columns of a rotation matrix are the images of the axes x, y, z. */
typedef struct VM_TAG(vmi_mat3) {
    vm_vec3 x, y, z;
} vmi_mat3;

VM_API vm_vec3 vmi_vec3(vm_real x, vm_real y, vm_real z)
{
    vm_vec3 a;
    a.x = x;
    a.y = y;
    a.z = z;
    return a;
}

VM_API vm_vec3 vmi_add(vm_vec3 a, vm_vec3 b) { return vmi_vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
VM_API vm_vec3 vmi_sub(vm_vec3 a, vm_vec3 b) { return vmi_vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
VM_API vm_vec3 vmi_scale(vm_real c, vm_vec3 a) { return vmi_vec3(c * a.x, c * a.y, c * a.z); }
VM_API vm_real vmi_dot(vm_vec3 a, vm_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* The vector a/c, with each component rounded once */
VM_API vm_vec3 vmi_over(vm_vec3 a, vm_real c) { return vmi_vec3(a.x / c, a.y / c, a.z / c); }

VM_API vm_vec3 vmi_cross(vm_vec3 a, vm_vec3 b)
{
    return vmi_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

VM_API vm_vec3 vmi_abs(vm_vec3 a) { return vmi_vec3(VM_FABS(a.x), VM_FABS(a.y), VM_FABS(a.z)); }

/* The sum |x| + |y| + |z| of the sizes of a's components */
VM_API vm_real vmi_norm1(vm_vec3 a) { return VM_FABS(a.x) + VM_FABS(a.y) + VM_FABS(a.z); }

/* The length of a. It does not overflow if only its square would overflow. */
VM_API vm_real vmi_norm2(vm_vec3 a) { return vmi_hypot(vmi_hypot(a.x, a.y), a.z); }

/* The largest of the sizes |x|, |y| and |z| of a's components */
VM_API vm_real vmi_norm_max(vm_vec3 a)
{
    const vm_vec3 b = vmi_abs(a);
    const vm_real c = b.x > b.y ? b.x : b.y;
    return c > b.z ? c : b.z;
}

VM_API int vmi_vec3_is_finite(vm_vec3 a) { return VM_IS_FINITE(a.x) && VM_IS_FINITE(a.y) && VM_IS_FINITE(a.z); }

/* The product m a of the matrix m and the vector a */
VM_API vm_vec3 vmi_times(const vmi_mat3 *m, vm_vec3 a)
{
    return vmi_add(vmi_scale(a.x, m->x), vmi_add(vmi_scale(a.y, m->y), vmi_scale(a.z, m->z)));
}

/* The product of the transposed matrix m^T and the vector a. For a rotation matrix m it undoes the rotation. */
VM_API vm_vec3 vmi_times_transposed(const vmi_mat3 *m, vm_vec3 a)
{
    return vmi_vec3(vmi_dot(m->x, a), vmi_dot(m->y, a), vmi_dot(m->z, a));
}

VM_API vm_quat vmi_quat(vm_real w, vm_vec3 xyz)
{
    vm_quat q;
    q.w = w;
    q.x = xyz.x;
    q.y = xyz.y;
    q.z = xyz.z;
    return q;
}

/* The vector of the components x, y, z of q */
VM_API vm_vec3 vmi_quat_vector(vm_quat q) { return vmi_vec3(q.x, q.y, q.z); }

VM_API int vmi_quat_is_finite(vm_quat q) { return VM_IS_FINITE(q.w) && vmi_vec3_is_finite(vmi_quat_vector(q)); }

/* Returns 1 if all four numbers of q are 0. Such a quaternion stands for the identity. */
VM_API int vmi_quat_is_none(vm_quat q) { return q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0; }

/* The square of the length of q */
VM_API vm_real vmi_quat_square(vm_quat q) { return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z; }

/* The product p q, which is the rotation by q followed by the rotation by p */
VM_API vm_quat vmi_quat_times(vm_quat p, vm_quat q)
{
    vm_quat r;
    r.w = p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z;
    r.x = p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y;
    r.y = p.w * q.y + p.y * q.w + p.z * q.x - p.x * q.z;
    r.z = p.w * q.z + p.z * q.w + p.x * q.y - p.y * q.x;
    return r;
}

VM_API vm_quat vmi_quat_over(vm_quat q, vm_real c)
{
    q.w /= c;
    q.x /= c;
    q.y /= c;
    q.z /= c;
    return q;
}

/* Divides q by the size of its largest component, so that the square of its length neither overflows nor
   underflows. Four zeros become the identity. */
VM_API vm_quat vmi_quat_scaled(vm_quat q)
{
    vm_real largest = VM_FABS(q.w);
    if (VM_FABS(q.x) > largest) largest = VM_FABS(q.x);
    if (VM_FABS(q.y) > largest) largest = VM_FABS(q.y);
    if (VM_FABS(q.z) > largest) largest = VM_FABS(q.z);
    if (largest == 0) {
        q.w = 1;
        largest = 1;
    }
    return vmi_quat_over(q, largest);
}

/* The quaternion of length 1 for the same rotation as q. Four zeros give the identity. */
VM_API vm_quat vmi_unit_quat(vm_quat q)
{
    q = vmi_quat_scaled(q);
    return vmi_quat_over(q, VM_SQRT(vmi_quat_square(q)));
}

/* The rotation matrix of q. `square` is the square of q's length: a normal number, not 0, subnormal or infinite. */
VM_INLINE vmi_mat3 vmi_rotation_of_square(vm_quat q, vm_real square)
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

/* The rotation matrix of a quaternion of any length. It is exactly the identity for (w, 0, 0, 0) and for four
   zeros. */
VM_API vmi_mat3 vmi_rotation(vm_quat q)
{
    q = vmi_quat_scaled(q);
    return vmi_rotation_of_square(q, vmi_quat_square(q));
}

/* Reads three numbers of a state as a vector. vmi_set3 writes a vector to a state. */
VM_API vm_vec3 vmi_get3(const vm_real *y) { return vmi_vec3(y[0], y[1], y[2]); }

VM_API void vmi_set3(vm_real *y, vm_vec3 a)
{
    y[0] = a.x;
    y[1] = a.y;
    y[2] = a.z;
}

/* Reads the four numbers w, x, y, z of a quaternion from a state */
VM_API vm_quat vmi_get_quat(const vm_real *y) { return vmi_quat(y[0], vmi_get3(y + 1)); }

#endif
/* mechanics/inertia.h - inertia tensors, parallel axes, principal axes
   A vm_inertia holds the entries of a body's tensor of inertia, about some point and along some axes. This chapter
   tells whether a body can have this tensor, moves it to parallel axes (40), and finds principal moments and axes.

       vm_inertia disc = {1, 1, 2, 0, 0, 0}; // xx, yy, zz, xy, xz, yz, kg m^2
       vm_vec3 d = {0.5, 0, 0};              // m
       if (vm_inertia_is_possible(&disc)) disc = vm_parallel_axes(&disc, 4, d); // 4 kg, now about a point 0.5 m away

   The other functions are internal: they turn, add and invert tensors for the chapters on jumps, streams and scenes.
   Tests: tests/test_momenta.c, tests/test_jumps.c. */
#ifndef VARMASS_MECHANICS_INERTIA_H
#define VARMASS_MECHANICS_INERTIA_H

/* A tensor of inertia, given by its entries, in kg m^2. The products of inertia have the sign of the tensor's entries:
   xy = -integral of x y dm. */
typedef struct VM_TAG(vm_inertia) {
    vm_real xx, yy, zz, xy, xz, yz;
} vm_inertia;

VM_API int vmi_inertia_is_finite(const vm_inertia *i)
{
    return vmi_vec3_is_finite(vmi_vec3(i->xx, i->yy, i->zz)) && vmi_vec3_is_finite(vmi_vec3(i->xy, i->xz, i->yz));
}

/* The product of the tensor i and the vector a */
VM_API vm_vec3 vmi_inertia_times(const vm_inertia *i, vm_vec3 a)
{
    return vmi_vec3(i->xx * a.x + i->xy * a.y + i->xz * a.z, i->xy * a.x + i->yy * a.y + i->yz * a.z,
                    i->xz * a.x + i->yz * a.y + i->zz * a.z);
}

/* The tensor a + c b, where a, b are tensors and c is a number */
VM_API vm_inertia vmi_inertia_plus(vm_inertia a, vm_real c, vm_inertia b)
{
    a.xx += c * b.xx;
    a.yy += c * b.yy;
    a.zz += c * b.zz;
    a.xy += c * b.xy;
    a.xz += c * b.xz;
    a.yz += c * b.yz;
    return a;
}

/* P(d) = |d|^2 E - d d^T, with the unit matrix E. It is the inertia of a unit mass at d about the origin. */
VM_API vm_inertia vmi_inertia_of_point(vm_vec3 d)
{
    vm_inertia p;
    p.xx = d.y * d.y + d.z * d.z;
    p.yy = d.x * d.x + d.z * d.z;
    p.zz = d.x * d.x + d.y * d.y;
    p.xy = -d.x * d.y;
    p.xz = -d.x * d.z;
    p.yz = -d.y * d.z;
    return p;
}

/* The tensor m^T i m: the entries of the tensor i along new axes, which are the columns of the matrix m */
VM_INLINE vm_inertia vmi_inertia_along(const vm_inertia *i, const vmi_mat3 *m)
{
    const vm_vec3 x = vmi_inertia_times(i, m->x), y = vmi_inertia_times(i, m->y), z = vmi_inertia_times(i, m->z);
    vm_inertia t;
    t.xx = vmi_dot(m->x, x);
    t.yy = vmi_dot(m->y, y);
    t.zz = vmi_dot(m->z, z);
    t.xy = vmi_dot(m->x, y);
    t.xz = vmi_dot(m->x, z);
    t.yz = vmi_dot(m->y, z);
    return t;
}

/* For each entry of the tensor m^T i m, the sum of the absolute values of its terms. The rounding error of the entry is
   a few eps times this sum. */
VM_INLINE vm_inertia vmi_inertia_sizes(const vm_inertia *i, const vmi_mat3 *m)
{
    vm_inertia a;
    vmi_mat3 b;
    a.xx = VM_FABS(i->xx);
    a.yy = VM_FABS(i->yy);
    a.zz = VM_FABS(i->zz);
    a.xy = VM_FABS(i->xy);
    a.xz = VM_FABS(i->xz);
    a.yz = VM_FABS(i->yz);
    b.x = vmi_abs(m->x);
    b.y = vmi_abs(m->y);
    b.z = vmi_abs(m->z);
    return vmi_inertia_along(&a, &b);
}

/* The sum |xx| + |yy| + |zz|, which is the trace if i is the inertia of a body */
VM_API vm_real vmi_inertia_trace(const vm_inertia *i) { return VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz); }

/* Reads an inertia tensor from six numbers of a state array. vmi_set_inertia writes it there. */
VM_API vm_inertia vmi_get_inertia(const vm_real *y)
{
    vm_inertia i;
    i.xx = y[0];
    i.yy = y[1];
    i.zz = y[2];
    i.xy = y[3];
    i.xz = y[4];
    i.yz = y[5];
    return i;
}

VM_API void vmi_set_inertia(vm_real *y, const vm_inertia *i)
{
    y[0] = i->xx;
    y[1] = i->yy;
    y[2] = i->zz;
    y[3] = i->xy;
    y[4] = i->xz;
    y[5] = i->yz;
}

/* The tolerance, in kg m^2, for the rounding errors of an inertia tensor. `i` is this tensor itself. If its entries are
   sums, `i` may be the tensor of the sizes of their terms (vmi_inertia_sizes) instead. */
VM_API vm_real vmi_inertia_slack(const vm_inertia *i) { return 32 * VM_EPSILON * vmi_inertia_trace(i); }

/* Returns 1 if a body can have the inertia i, within the tolerance slack (kg m^2). The matrix tr(i)/2 E - i, with the
   unit matrix E, is the integral of r r^T dm and must have no negative eigenvalue. The function adds slack, which
   exceeds the rounding errors, to the trace tr(i). Then Gaussian elimination must give positive pivots only. */
VM_API int vmi_inertia_is_within(const vm_inertia *i, vm_real slack)
{
    const vm_real half = (i->xx + i->yy + i->zz + slack) / 2;
    vm_real x, y, z, yz; /* the pivots x, y, z; yz: minus the entry yz of the matrix after one elimination */
    if (half == 0) return i->xx == 0 && i->yy == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    x = half - i->xx;
    if (!(x > 0)) return 0;
    y = half - i->yy - i->xy / x * i->xy;
    if (!(y > 0)) return 0;
    yz = i->yz + i->xy / x * i->xz;
    z = half - i->zz - i->xz / x * i->xz;
    return z - yz / y * yz > 0;
}

/* Test whether a body can have this inertia. Returns 1 if it can. Returns 0 if it cannot, and also for NaN and for a
   null pointer. The principal moments of a body are not negative, and none is larger than the sum of the other two. A
   violation of these rules by up to 32 eps of the trace counts as a rounding error. Rods and points are bodies, too. */
VM_API int vm_inertia_is_possible(const vm_inertia *inertia)
{
    return inertia && vmi_inertia_is_finite(inertia) && vmi_inertia_is_within(inertia, vmi_inertia_slack(inertia));
}

/* Inertia about a point at d from the mass centre, along parallel axes, (40). It is own + mass P(d), where own (kg m^2)
   is the inertia about the mass centre and P(d) = |d|^2 E - d d^T (d in m, unit matrix E). -mass undoes the shift.
   Returns NaN for a null pointer, and in every entry that depends on a NaN. */
VM_API vm_inertia vm_parallel_axes(const vm_inertia *own, vm_real mass, vm_vec3 d)
{
    const vm_inertia none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    return vmi_inertia_plus(own ? *own : none, mass, vmi_inertia_of_point(d));
}

/* ---- principal axes ---- */

/* Principal moments, in kg m^2, and unit vectors along the principal axes */
typedef struct VM_TAG(vmi_principal) {
    vm_real moment[3];
    vm_vec3 axis[3];
} vmi_principal;

/* Applies one Jacobi rotation, in the plane of the axes p and q, to the symmetric matrix a, so that a[p][q] becomes 0.
   The columns of v are the axes and turn as well. t, c, s are the tangent, cosine and sine of the rotation angle, which
   is the smaller of the two possible ones. */
VM_API void vmi_jacobi_rotation(vm_real a[3][3], vm_real v[3][3], int p, int q)
{
    const vm_real theta = (a[q][q] - a[p][p]) / (2 * a[p][q]), root = VM_SQRT(theta * theta + 1);
    const vm_real t = VM_COPYSIGN(1, theta) / (VM_FABS(theta) + root), c = 1 / VM_SQRT(t * t + 1), s = t * c;
    const int other = 3 - p - q;
    vm_real x = a[other][p], y = a[other][q];
    int k;
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = 0;
    a[other][p] = a[p][other] = c * x - s * y;
    a[other][q] = a[q][other] = s * x + c * y;
    for (k = 0; k < 3; k++) {
        x = v[k][p];
        y = v[k][q];
        v[k][p] = c * x - s * y;
        v[k][q] = s * x + c * y;
    }
}

/* Principal moments and axes of the tensor i, found by Jacobi rotations, which converge quadratically */
VM_API vmi_principal vmi_principal_axes(const vm_inertia *i)
{
    const int most_sweeps = 12; /* quadratic convergence needs fewer sweeps */
    vm_real a[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vmi_principal result;
    int sweep, p, q;
    a[0][0] = i->xx;
    a[1][1] = i->yy;
    a[2][2] = i->zz;
    a[0][1] = a[1][0] = i->xy;
    a[0][2] = a[2][0] = i->xz;
    a[1][2] = a[2][1] = i->yz;
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

/* The tensor that has the principal moments and axes *p */
VM_API vm_inertia vmi_inertia_from(const vmi_principal *p)
{
    vm_inertia i = {0, 0, 0, 0, 0, 0};
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 e = p->axis[k], m = vmi_scale(p->moment[k], e);
        i.xx += m.x * e.x;
        i.yy += m.y * e.y;
        i.zz += m.z * e.z;
        i.xy += m.x * e.y;
        i.xz += m.x * e.z;
        i.yz += m.y * e.z;
    }
    return i;
}

/* Returns 1 if a body can have the principal moments *p: none is larger than the sum of the other two plus slack, in kg
   m^2. It follows that no moment is below -slack. */
VM_API int vmi_moments_are_possible(const vmi_principal *p, vm_real slack)
{
    const vm_real a = p->moment[0], b = p->moment[1], c = p->moment[2];
    return a <= b + c + slack && b <= a + c + slack && c <= a + b + slack;
}

/* A computed sum is only a rounding error if it is smaller than this share of the sum of its terms' sizes. */
#define VMI_LOST_SHARE (8 * VM_EPSILON)

/* Returns 1 if a moment about an axis is smaller than the rounding errors of its tensor, and also if it is negative or
   NaN. The entries of the tensor are sums of terms; the entries of *sizes are the sums of the terms' sizes. */
VM_API int vmi_moment_is_lost(vm_real moment, vm_vec3 axis, const vm_inertia *sizes)
{
    const vm_vec3 e = vmi_abs(axis);
    return !(moment > VMI_LOST_SHARE * vmi_dot(e, vmi_inertia_times(sizes, e)));
}

/* Changes moments that are possible within rounding errors into moments that a body can have exactly. A moment that is
   smaller than its rounding error becomes 0. A moment larger than the sum of the other two becomes that sum. Returns 1
   if a moment changed. */
VM_API int vmi_clamp_moments(vmi_principal *p, const vm_inertia *sizes)
{
    int k, changed = 0;
    for (k = 0; k < 3; k++) {
        if (p->moment[k] == 0 || !vmi_moment_is_lost(p->moment[k], p->axis[k], sizes)) continue;
        p->moment[k] = 0;
        changed = 1;
    }
    for (k = 0; k < 3; k++) {
        const vm_real others = p->moment[(k + 1) % 3] + p->moment[(k + 2) % 3];
        if (p->moment[k] <= others) continue;
        p->moment[k] = others;
        changed = 1;
    }
    return changed;
}

/* The angular velocity for the angular momentum h. Components of h along axes with a zero moment are ignored. */
VM_API vm_vec3 vmi_spin_of(const vmi_principal *p, vm_vec3 h)
{
    vm_vec3 omega = vmi_vec3(0, 0, 0);
    int k;
    for (k = 0; k < 3; k++)
        if (p->moment[k] > 0) omega = vmi_add(omega, vmi_scale(vmi_dot(p->axis[k], h) / p->moment[k], p->axis[k]));
    return omega;
}

/* Solves i omega = h, with inertia i and angular momentum h, for the angular velocity *omega, and refines it once.
   About an axis with zero moment (of a rod or a point) the angular velocity keeps its value in `before`. The body
   cannot have angular momentum about it: returns 1 if h has a component larger than noise there, else 0. */
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

/* ---- factors, for bodies whose inertia is inverted in every step of an integration ---- */

/* The factors of an inertia tensor L D L^T with a unit triangular matrix L and a diagonal matrix D: the entries xy, xz,
   yz of L, and the diagonal entries x, y, z of the inverse of D */
typedef struct VM_TAG(vmi_inertia_ldl) {
    vm_real xy, xz, yz, x, y, z;
} vmi_inertia_ldl;

/* Computes the factors f of the tensor i. Returns 0 if a pivot is not positive or is only a rounding error, else 1. */
VM_INLINE int vmi_inertia_factor(const vm_inertia *i, vmi_inertia_ldl *f)
{
    vm_real y, z, t;
    f->x = 1 / i->xx;
    f->xy = i->xy * f->x;
    f->xz = i->xz * f->x;
    y = i->yy - f->xy * i->xy;
    t = i->yz - f->xz * i->xy;
    f->y = 1 / y;
    f->yz = t * f->y;
    z = i->zz - f->xz * i->xz - f->yz * t;
    f->z = 1 / z;
    return i->xx > 0 && y > VMI_LOST_SHARE * i->yy && z > VMI_LOST_SHARE * i->zz;
}

/* The solution w of i w = h, computed from the factors f of the tensor i */
VM_INLINE vm_vec3 vmi_inertia_solve(const vmi_inertia_ldl *f, vm_vec3 h)
{
    vm_vec3 w;
    w.y = h.y - f->xy * h.x;
    w.z = (h.z - f->xz * h.x - f->yz * w.y) * f->z;
    w.y = w.y * f->y - f->yz * w.z;
    w.x = h.x * f->x - f->xy * w.y - f->xz * w.z;
    return w;
}

/* Returns 1 if a thin body can have the inertia i within rounding errors. For a flat body one moment equals the sum of
   the other two, except for the rounding errors of all integration steps so far. The tolerance, sqrt(eps) of the trace,
   allows for about 1/sqrt(eps) such errors. */
VMI_APART int vmi_thin_inertia_is_possible(const vm_inertia *i)
{
    const vm_real slack = VM_MANT_DIG > 24 ? VM_C(1.5e-8) : VM_C(3.5e-4); /* as a share of the trace */
    return vmi_inertia_is_finite(i) && vmi_inertia_is_within(i, slack * (i->xx + i->yy + i->zz));
}

/* Returns 1 if a body can have the inertia i. The principal moments of i must be positive. This test is for use in
   every step of an integration. A cheap criterion is enough for most bodies: tr(i)/2 E - i, with the unit matrix E, is
   positive definite if each of its diagonal entries is larger than the sum of the absolute products of inertia. */
VM_INLINE int vmi_running_inertia_is_possible(const vm_inertia *i)
{
    const vm_real half = (i->xx + i->yy + i->zz) / 2;
    const vm_real least = half - (VM_FABS(i->xy) + VM_FABS(i->xz) + VM_FABS(i->yz));
    return (least > i->xx && least > i->yy && least > i->zz) || vmi_thin_inertia_is_possible(i);
}

/* Computes the factors of i as vmi_inertia_factor does, but also returns 0 if no body can have the inertia i */
VM_INLINE int vmi_inertia_factor_if_possible(const vm_inertia *i, vmi_inertia_ldl *f)
{
    return vmi_inertia_factor(i, f) && vmi_running_inertia_is_possible(i);
}

#endif
/* mechanics/bodies.h - bodies in space and in the plane, their momenta and energy, balances across an instant
   A vm_body is a body at an instant: mass, inertia, attitude, position and motion. A vm_body2 is a body that moves in
   the plane. This chapter computes momentum (1)-(3), angular momentum (7)-(9) and kinetic energy (93), (97), and
   compares them before and after an instant, (4)-(6), (10)-(12). The functions for the plane are in bodies2.h.

       vm_body wheel = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
       vm_vec3 origin = {0, 0, 0}, L = vm_angular_momentum(&wheel, origin); // L.z = 3 N m s

   Tests: tests/test_momenta.c. */
#ifndef VARMASS_MECHANICS_BODIES_H
#define VARMASS_MECHANICS_BODIES_H

/* A body at an instant */
typedef struct VM_TAG(vm_body) {
    vm_real mass;       /* mass > 0, kg */
    vm_inertia inertia; /* inertia about the body's own mass centre, kg m^2, body axes; all zero for a point */
    vm_quat q;          /* attitude: turns body axes into inertial ones; any length; four zeros mean the identity */
    vm_vec3 r;          /* position of the mass centre, m, inertial axes */
    vm_vec3 v;          /* velocity, defined as momentum/mass, m/s, inertial axes */
    vm_vec3 omega;      /* angular velocity, rad/s, inertial axes */
} vm_body;

/* An impulse that acts on a body at an instant. All vectors are in inertial axes. */
typedef struct VM_TAG(vm_impulse) {
    vm_vec3 linear; /* the impulse of forces, N s */
    vm_vec3 couple; /* an impulsive couple in addition to the moment of `linear`, N m s */
    vm_vec3 at;     /* the point at which `linear` acts, m */
} vm_impulse;

/* A body that moves in the plane, at an instant */
typedef struct VM_TAG(vm_body2) {
    vm_real mass;    /* mass > 0, kg */
    vm_real inertia; /* moment of inertia about the body's own mass centre, kg m^2; 0 for a point */
    vm_real x, y;    /* position of the mass centre, m */
    vm_real angle;   /* attitude, rad, anticlockwise */
    vm_real vx, vy;  /* velocity, which is momentum/mass, m/s */
    vm_real omega;   /* angular velocity, rad/s, anticlockwise */
} vm_body2;

/* An impulse that acts at an instant on a body that moves in the plane */
typedef struct VM_TAG(vm_impulse2) {
    vm_real jx, jy; /* the impulse of forces, N s */
    vm_real couple; /* an impulsive couple in addition to the moment of jx, jy, N m s, anticlockwise */
    vm_real x, y;   /* the point at which jx, jy act, m */
} vm_impulse2;

/* Balance across an instant: the total momentum, angular momentum and energy of the bodies after it minus those before
   it. The external impulse and its moment are subtracted, too, so that the changes of momentum and angular momentum are
   zero, except for rounding errors, if the bodies obey the laws of mechanics. */
typedef struct VM_TAG(vm_balance) {
    vm_vec3 momentum;               /* change of momentum, N s: (6), (20), (21) */
    vm_vec3 angular_momentum;       /* change of angular momentum about a point, N m s: (12), (17), (22) */
    vm_real momentum_scale;         /* the sum of mass times speed over all bodies, plus the size of the impulse, N s */
    /* The sum over all bodies of tr(I) |omega| + (|r| + |r - about|) M |v|, with inertia I, mass M and the point
       `about`, plus a term for the impulse, N m s. It contains |r| M |v|, because the rounding error eps |r| of the
       position r changes the angular momentum about any point by eps |r| M |v|. */
    vm_real angular_momentum_scale;
    vm_real energy;                 /* kinetic energy after minus before, J: (94) - (93) */
} vm_balance;

/* ---- momentum, angular momentum and kinetic energy ---- */

/* The angular momentum of a body about its own mass centre, in inertial axes */
VM_API vm_vec3 vmi_spin_momentum(const vm_body *body)
{
    const vmi_mat3 m = vmi_rotation(body->q);
    return vmi_times(&m, vmi_inertia_times(&body->inertia, vmi_times_transposed(&m, body->omega)));
}

/* Momentum of a body, mass times velocity, (1)-(3), N s. The body is not checked: NaN in the body gives NaN, and so
   does a null pointer. */
VM_API vm_vec3 vm_momentum(const vm_body *body)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_scale(body->mass, body->v);
}

/* Angular momentum of a body about the point `about` (7)-(9), N m s. It is I omega + (r - about) x M v in inertial
   axes, with the inertia I and the mass M. The body is not checked: NaN in the body gives NaN, and so does a null
   pointer. */
VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_add(vmi_spin_momentum(body), vmi_cross(vmi_sub(body->r, about), vm_momentum(body)));
}

/* Kinetic energy of a body (93), (97), J. It is (M v^2 + omega.I omega)/2, with the mass M and the inertia I. The
   body is not checked: NaN in the body gives NaN, and so does a null pointer. */
VM_API vm_real vm_kinetic_energy(const vm_body *body)
{
    if (!body) return VM_NAN;
    return (body->mass * vmi_dot(body->v, body->v) + vmi_dot(body->omega, vmi_spin_momentum(body))) / 2;
}

/* ---- conversion of bodies between the plane and space ---- */

/* Converts a body of the plane to a body of space. Only the entry zz of its inertia is set, because motion in the plane
   needs no other entry. */
VM_API vm_body vmi_body_to_space(const vm_body2 *body)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = body->mass;
    b.inertia.zz = body->inertia;
    b.r = vmi_vec3(body->x, body->y, 0);
    b.v = vmi_vec3(body->vx, body->vy, 0);
    b.omega = vmi_vec3(0, 0, body->omega);
    return b;
}

/* Converts a body of space to one of the plane, with the given angle. Motion out of the plane is left out. */
VM_API vm_body2 vmi_body_to_plane(const vm_body *b, vm_real angle)
{
    vm_body2 flat;
    flat.mass = b->mass;
    flat.inertia = b->inertia.zz;
    flat.angle = angle;
    flat.x = b->r.x;
    flat.y = b->r.y;
    flat.vx = b->v.x;
    flat.vy = b->v.y;
    flat.omega = b->omega.z;
    return flat;
}

/* ---- checks ---- */

VM_API int vmi_body_is_finite(const vm_body *b)
{
    return VM_IS_FINITE(b->mass) && vmi_vec3_is_finite(b->r) && vmi_vec3_is_finite(b->v) &&
           vmi_vec3_is_finite(b->omega) &&
           vmi_inertia_is_finite(&b->inertia) && vmi_quat_is_finite(b->q);
}

VM_API int vmi_body2_is_finite(const vm_body2 *b)
{
    return VM_IS_FINITE(b->mass) && VM_IS_FINITE(b->inertia) && vmi_vec3_is_finite(vmi_vec3(b->x, b->y, b->angle)) &&
           vmi_vec3_is_finite(vmi_vec3(b->vx, b->vy, b->omega));
}

VM_API int vmi_impulse_is_finite(const vm_impulse *j)
{
    return vmi_vec3_is_finite(j->linear) && vmi_vec3_is_finite(j->couple) && vmi_vec3_is_finite(j->at);
}

/* Checks a body of space. Returns VM_OK, VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA. */
VM_API int vmi_check_body(const vm_body *b)
{
    if (!vmi_body_is_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return vm_inertia_is_possible(&b->inertia) ? VM_OK : VM_BAD_INERTIA;
}

/* Checks a body of the plane. Returns VM_OK, VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA. */
VM_API int vmi_check_body2(const vm_body2 *b)
{
    if (!vmi_body2_is_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return b->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* An array of n bodies, either of space or of the plane. One of the two pointers is NULL. */
typedef struct VM_TAG(vmi_bodies) {
    int n;
    const vm_body *in_space;
    const vm_body2 *in_plane;
} vmi_bodies;

VM_API vmi_bodies vmi_bodies_in_space(int n, const vm_body *bodies)
{
    vmi_bodies list;
    list.n = n;
    list.in_space = bodies;
    list.in_plane = NULL;
    return list;
}

VM_API vmi_bodies vmi_bodies_in_plane(int n, const vm_body2 *bodies)
{
    vmi_bodies list;
    list.n = n;
    list.in_space = NULL;
    list.in_plane = bodies;
    return list;
}

/* Body i of the list, as a body of space */
VM_API vm_body vmi_list_body(const vmi_bodies *list, int i)
{
    if (list->in_plane) return vmi_body_to_space(list->in_plane + i);
    return list->in_space[i];
}

/* Returns VM_OK if all bodies are valid. Else returns the error of a body. If there are several errors, vmi_first_error
   selects one. Returns VM_BAD_ARGUMENT for n < 0, and if n > 0 while both pointers are NULL. */
VM_API int vmi_check_bodies(const vmi_bodies *list)
{
    int i, status = VM_OK;
    if (list->n < 0 || (list->n > 0 && !list->in_space && !list->in_plane)) return VM_BAD_ARGUMENT;
    for (i = 0; i < list->n; i++) {
        if (list->in_plane) status = vmi_first_error(status, vmi_check_body2(list->in_plane + i));
        else status = vmi_first_error(status, vmi_check_body(list->in_space + i));
    }
    return status;
}

/* ---- balances ---- */

/* The moment of an impulse about the point `about`, N m s */
VM_API vm_vec3 vmi_impulse_moment(const vm_impulse *j, vm_vec3 about)
{
    return vmi_add(j->couple, vmi_cross(vmi_sub(j->at, about), j->linear));
}

/* Adds a body to a balance (sign 1) or subtracts it (sign -1). Adds the sizes of its momenta to the scales. */
VM_API void vmi_balance_add(vm_balance *sum, vm_real sign, const vm_body *body, vm_vec3 about)
{
    const vm_vec3 momentum = vm_momentum(body);
    const vm_real size = vmi_norm2(momentum);
    sum->momentum = vmi_add(sum->momentum, vmi_scale(sign, momentum));
    sum->angular_momentum = vmi_add(sum->angular_momentum, vmi_scale(sign, vm_angular_momentum(body, about)));
    sum->momentum_scale += size;
    sum->angular_momentum_scale += vmi_inertia_trace(&body->inertia) * vmi_norm2(body->omega) +
                                   (vmi_norm2(body->r) + vmi_norm2(vmi_sub(body->r, about))) * size;
    sum->energy += sign * vm_kinetic_energy(body);
}

/* Subtracts an impulse and its moment from a balance, and adds their sizes to the scales */
VM_API void vmi_balance_take_impulse(vm_balance *sum, const vm_impulse *j, vm_vec3 about)
{
    sum->momentum = vmi_sub(sum->momentum, j->linear);
    sum->angular_momentum = vmi_sub(sum->angular_momentum, vmi_impulse_moment(j, about));
    sum->momentum_scale += vmi_norm2(j->linear);
    sum->angular_momentum_scale +=
        vmi_norm1(j->couple) + (vmi_norm1(j->at) + vmi_norm1(vmi_sub(j->at, about))) * vmi_norm1(j->linear);
}

VM_API int vmi_balance_is_finite(const vm_balance *b)
{
    return VM_IS_FINITE(b->energy) && VM_IS_FINITE(b->momentum_scale) && VM_IS_FINITE(b->angular_momentum_scale) &&
           vmi_vec3_is_finite(b->momentum) && vmi_vec3_is_finite(b->angular_momentum);
}

/* Balance of momentum, angular momentum and energy across an instant. *balance has the sums over the n_after bodies
   minus those over the n_before bodies, minus the impulse, (4)-(6), (10)-(12). If nothing was lost, the changes of
   momentum and of angular momentum about any point are zero except for a few eps times their scales. Either number of
   bodies may be 0. The bodies are not checked. Returns VM_BAD_ARGUMENT for a null pointer or a negative number of
   bodies, VM_NOT_FINITE if a sum is not finite, and VM_OK otherwise. */
VM_API int vm_balance_between(int n_before, const vm_body *before, int n_after, const vm_body *after,
                              const vm_impulse *external_or_NULL, vm_vec3 about, vm_balance *balance)
{
    vm_balance sum = {{0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    int i;
    if (!balance || n_before < 0 || n_after < 0 || (n_before > 0 && !before) || (n_after > 0 && !after))
        return VM_BAD_ARGUMENT;
    for (i = 0; i < n_before; i++) vmi_balance_add(&sum, -1, before + i, about);
    for (i = 0; i < n_after; i++) vmi_balance_add(&sum, 1, after + i, about);
    if (external_or_NULL) vmi_balance_take_impulse(&sum, external_or_NULL, about);
    if (!vmi_balance_is_finite(&sum)) return VM_NOT_FINITE;
    *balance = sum;
    return VM_OK;
}

#endif
/* mechanics/bodies2.h - momentum and energy of bodies in the plane, and their conversion to bodies in space
   In the plane, (35)-(39), a body has one moment of inertia and one angular velocity. Its type vm_body2 is in bodies.h.

       vm_body2 plate = {2, 0.1, 0, 0, 0, 3, 0, 8}; // mass, inertia, x, y, angle, vx, vy, omega
       vm_real T = vm_kinetic_energy2(&plate);      // (2 3^2 + 0.1 8^2)/2 = 12.2 J

   Tests: tests/test_momenta.c, tests/test_jumps2.c. */
#ifndef VARMASS_MECHANICS_BODIES2_H
#define VARMASS_MECHANICS_BODIES2_H

/* Angular momentum of a body of the plane about the point (x, y), N m s. It is positive anticlockwise. The body is
   not checked: NaN in the body gives NaN, and so does a null pointer. */
VM_API vm_real vm_angular_momentum2(const vm_body2 *body, vm_real x, vm_real y)
{
    if (!body) return VM_NAN;
    return body->inertia * body->omega + body->mass * ((body->x - x) * body->vy - (body->y - y) * body->vx);
}

/* Kinetic energy of a body of the plane, J. It is (M v^2 + I omega^2)/2, with mass M, speed v and inertia I. The
   body is not checked: NaN in the body gives NaN, and so does a null pointer. */
VM_API vm_real vm_kinetic_energy2(const vm_body2 *body)
{
    if (!body) return VM_NAN;
    return (body->mass * (body->vx * body->vx + body->vy * body->vy) + body->inertia * body->omega * body->omega) /
           2;
}

/* A body of the plane as a lamina of space in the plane z = 0. Its inertia has xx = yy = zz/2, its quaternion q has
   length 1, and it moves as *body does. *body is not checked. A null pointer gives NaN. */
VM_API vm_body vm_body_from_body2(const vm_body2 *body)
{
    const vm_body2 none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vm_body b;
    if (!body) body = &none;
    b = vmi_body_to_space(body);
    b.inertia.xx = b.inertia.yy = b.inertia.zz / 2;
    vmi_sincos(body->angle / 2, &b.q.z, &b.q.w);
    return b;
}

#endif
/* mechanics/jumps.h - parts separate from a body or are attached to it, in space
   At the instant of a jump a body's mass, mass centre, inertia, velocity and angular velocity change, by (13)-(15),
   (24), (33), (34), (40). The attitude stays the same. An impulse may act at the same instant. Any number of parts may
   separate or be attached at once.

       vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
       vm_body part = {1, {0.1, 0.1, 0.1, 0, 0, 0}, {1, 0, 0, 0}, {0.4, 0, 0}, {10, 2, 0}, {0, 0, 3}}, rest;
       int status = vm_separate(&whole, &part, NULL, &rest); // VM_OK: how the rest moves on

   Jumps in the plane are in jumps2.h, and jumps that are given by relative motions in relative.h. The inverse question
   (how must a part leave?) is in inverse.h, and the energy of a jump in jump_energy.h. Tests: tests/test_jumps.c,
   tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_JUMPS_H
#define VARMASS_MECHANICS_JUMPS_H

/* How a jump is computed. A body has the mass M, velocity v, inertia I, angular velocity omega, and its mass centre S
   is at r. Another body (m, v2, I2, omega2, S2) is attached to it (sign = 1) or separates from it (sign = -1). After
   this the first body has the mass M1 = M + sign m, v1, I1, omega1, and its mass centre S1 is at r1. Every inertia is
   about its body's own mass centre. The vector d leads from S to S2, and P(d) = |d|^2 E - d d^T with the unit matrix E.
   An impulse `linear` with the moment `moment` about S1 may act. Then
     r1 = r + sign m/M1 d (15),  v1 = (M v + sign m v2 + linear)/M1 (24),  I1 = I + sign (I2 + m M/M1 P(d)),
     I1 omega1 = I omega + sign (I2 omega2 + m M/M1 d x (v2 - v)) + moment (33), (34)
   A separation is therefore an attachment of negative mass and inertia.

   The equations keep this form in a frame that moves and that turns with any angular velocity Omega, if all omegas and
   v2 - v are taken relative to this frame: (42) in space. The computation uses a frame in which the terms that cancel
   are small, so that few digits are lost. This frame moves with the heaviest body, and at a separation it turns with
   the whole. */
enum { VMI_SEPARATE = -1, VMI_ATTACH = 1 }; /* the values of all parameters named `sign` */

/* The frame of a jump */
typedef struct VM_TAG(vmi_frame) {
    vm_quat q;           /* attitude of the first body; inertias are added along its axes */
    vmi_mat3 turn;       /* the rotation matrix of q */
    vm_vec3 r, v, omega; /* position, velocity and angular velocity of the frame */
} vmi_frame;

/* A lump: the mass, motion and inertia of a body, or of several bodies joined, relative to the frame of a jump */
typedef struct VM_TAG(vmi_lump) {
    vm_real mass;
    vm_vec3 r, v;       /* position and velocity of the mass centre, less r and v of the frame */
    vm_vec3 h;          /* angular momentum about the mass centre, relative to the frame; inertial axes */
    vm_inertia inertia; /* inertia about the lump's mass centre, along the axes given by the frame's q */
    vm_inertia sizes;   /* for each entry of inertia, the sum of the sizes of its terms */
    vm_real noise;      /* the sum of the sizes of the terms of h; the rounding error of h is a few eps of noise */
} vmi_lump;

VM_API vmi_lump vmi_lump_of(const vmi_frame *frame, const vm_body *body)
{
    const vmi_mat3 own = vmi_rotation(body->q);
    const vm_quat p = body->q, q = frame->q;
    const vm_vec3 spin = vmi_sub(body->omega, frame->omega);
    vmi_mat3 turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; /* its columns are the frame's axes in body axes */
    vmi_lump lump;
    if (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z) { /* for equal attitudes turn is exactly the identity */
        turn.x = vmi_times_transposed(&own, frame->turn.x);
        turn.y = vmi_times_transposed(&own, frame->turn.y);
        turn.z = vmi_times_transposed(&own, frame->turn.z);
    }
    lump.mass = body->mass;
    lump.r = vmi_sub(body->r, frame->r);
    lump.v = vmi_sub(body->v, frame->v);
    lump.h = vmi_times(&own, vmi_inertia_times(&body->inertia, vmi_times_transposed(&own, spin)));
    lump.inertia = vmi_inertia_along(&body->inertia, &turn);
    lump.sizes = vmi_inertia_sizes(&body->inertia, &turn);
    lump.noise = vmi_inertia_trace(&body->inertia) * (vmi_norm1(body->omega) + vmi_norm1(frame->omega));
    return lump;
}

/* Returns P(d) = |d|^2 E - d d^T along the frame's axes. Sets each entry of *sizes so that the rounding error of the
   entry of P(d) is a few eps of it. The vector d is a difference of positions of the size `reach`. */
VM_API vm_inertia vmi_moved_inertia(const vmi_frame *frame, vm_vec3 d, vm_vec3 reach, vm_inertia *sizes)
{
    vmi_mat3 turn;
    vm_vec3 size;
    turn.x = vmi_abs(frame->turn.x);
    turn.y = vmi_abs(frame->turn.y);
    turn.z = vmi_abs(frame->turn.z);
    size = vmi_times_transposed(&turn, vmi_abs(d));
    reach = vmi_times_transposed(&turn, reach);
    *sizes = vmi_inertia_of_point(vmi_add(size, reach)); /* d^2 + 2 d reach + reach^2; the next line removes reach^2 */
    *sizes = vmi_inertia_plus(*sizes, -1, vmi_inertia_of_point(reach));
    sizes->xy = VM_FABS(sizes->xy);
    sizes->xz = VM_FABS(sizes->xz);
    sizes->yz = VM_FABS(sizes->yz);
    return vmi_inertia_of_point(vmi_times_transposed(&frame->turn, d));
}

/* Returns how much a->noise grows when b joins a: by b->noise and by the sizes of the terms of (reduced mass) d x slip.
   d leads from a to b, a difference of positions of the size `reach`; slip is b's velocity relative to a. */
VM_API vm_real vmi_join_noise(const vmi_frame *frame, const vmi_lump *a, vm_real sign, const vmi_lump *b,
                              vm_real reduced, vm_vec3 reach, vm_vec3 slip)
{
    const vm_real distance = vmi_norm1(vmi_sub(b->r, a->r));
    const vm_real speeds = vmi_norm1(a->v) + vmi_norm1(b->v) + 2 * vmi_norm1(frame->v);
    const vm_real moved = sign < 0 ? b->mass : reduced;
    return b->noise + VM_FABS(reduced) * distance * speeds +
           moved * vmi_norm1(reach) * (distance * vmi_norm1(frame->omega) + vmi_norm1(slip));
}

/* Attaches b to a (sign 1) or separates b from a (sign -1). Returns VM_BAD_MASS if no mass is left, else VM_OK. */
VM_API int vmi_join(const vmi_frame *frame, vmi_lump *a, vm_real sign, const vmi_lump *b)
{
    const vm_real mass = a->mass + sign * b->mass;
    const vm_real share = sign * (b->mass / mass), reduced = a->mass * share; /* mass share of b; reduced mass */
    const vm_vec3 d = vmi_sub(b->r, a->r), v = vmi_sub(b->v, a->v);
    const vm_vec3 slip = vmi_sub(v, vmi_cross(frame->omega, d)); /* velocity of b relative to a in the turning frame */
    const vm_vec3 origin = vmi_abs(frame->r);
    const vm_vec3 reach = vmi_add(vmi_add(vmi_abs(a->r), vmi_abs(b->r)), vmi_add(origin, origin));
    vm_inertia sizes, moved = vmi_moved_inertia(frame, d, reach, &sizes);
    if (!(mass > 0)) return VM_BAD_MASS;
    a->noise += vmi_join_noise(frame, a, sign, b, reduced, reach, slip);
    a->inertia = vmi_inertia_plus(vmi_inertia_plus(a->inertia, sign, b->inertia), reduced, moved);
    a->sizes = vmi_inertia_plus(vmi_inertia_plus(a->sizes, 1, b->sizes), VM_FABS(reduced), sizes);
    a->h = vmi_add(a->h, vmi_add(vmi_scale(sign, b->h), vmi_scale(reduced, vmi_cross(d, slip))));
    if (b->mass > a->mass) { /* start from r and v of the heavier body, so that no digits are lost */
        a->r = vmi_sub(b->r, vmi_scale(a->mass / mass, d));
        a->v = vmi_sub(b->v, vmi_scale(a->mass / mass, v));
    } else {
        a->r = vmi_add(a->r, vmi_scale(share, d));
        a->v = vmi_add(a->v, vmi_scale(share, v));
    }
    a->mass = mass;
    return VM_OK;
}

/* Adds an impulse to the velocity and the angular momentum of the lump a */
VM_API void vmi_apply_impulse(const vmi_frame *frame, vmi_lump *a, const vm_impulse *external)
{
    const vm_vec3 at = vmi_sub(vmi_sub(external->at, frame->r), a->r), j = external->linear;
    a->v = vmi_add(a->v, vmi_over(j, a->mass));
    a->h = vmi_add(a->h, vmi_add(external->couple, vmi_cross(at, j)));
    a->noise += vmi_norm1(external->couple) + (vmi_norm1(at) + vmi_norm1(frame->r)) * vmi_norm1(j);
}

/* The frame of a jump. It moves with the heaviest of all bodies. At a separation, or if only an impulse acts, it turns
   with the first body. At an attachment it does not turn. */
VM_API vmi_frame vmi_frame_of(const vm_body *body, const vmi_bodies *others, vm_real sign)
{
    vm_real mass = body->mass;
    vmi_frame frame;
    int i;
    frame.q = body->q;
    frame.turn = vmi_rotation(body->q);
    frame.r = body->r;
    frame.v = body->v;
    frame.omega = vmi_vec3(0, 0, 0);
    if (sign < 0 || others->n == 0) frame.omega = body->omega;
    for (i = 0; i < others->n; i++) {
        const vm_body b = vmi_list_body(others, i);
        if (b.mass > mass) {
            mass = b.mass;
            frame.r = b.r;
            frame.v = b.v;
        }
    }
    return frame;
}

/* Returns VM_OK if the bodies are valid and the impulse is finite, else the error that vmi_first_error selects. */
VM_API int vmi_check_jump(const vm_body *body, const vmi_bodies *others, const vm_impulse *external_or_NULL)
{
    const int status = vmi_first_error(vmi_check_body(body), vmi_check_bodies(others));
    if (!external_or_NULL || vmi_impulse_is_finite(external_or_NULL)) return status;
    return vmi_first_error(status, VM_NOT_FINITE);
}

/* Sets *total to `body` as it is after the jump and the impulse. The bodies `others` are first joined to each other.
   Then they are attached to `body` (sign = 1) or separate from it (sign = -1). Returns VM_BAD_MASS if no mass is left,
   else VM_OK. */
VM_API int vmi_jump_total(const vmi_frame *frame, const vm_body *body, vm_real sign, const vmi_bodies *others,
                          const vm_impulse *external_or_NULL, vmi_lump *total)
{
    vmi_lump sum;
    int i, status = VM_OK;
    *total = vmi_lump_of(frame, body);
    for (i = 0; i < others->n && !status; i++) {
        const vm_body other = vmi_list_body(others, i);
        const vmi_lump lump = vmi_lump_of(frame, &other);
        if (i == 0) sum = lump;
        else status = vmi_join(frame, &sum, 1, &lump);
    }
    if (others->n > 0 && !status) status = vmi_join(frame, total, sign, &sum);
    if (!status && external_or_NULL) vmi_apply_impulse(frame, total, external_or_NULL);
    return status;
}

/* Finds the principal axes of a lump and changes its moments to moments that a body can have exactly. Returns
   VM_NOT_FINITE, VM_BAD_INERTIA if a moment clearly exceeds the sum of the other two, and VM_OK otherwise. */
VM_API int vmi_lump_clamp_moments(vmi_lump *lump, vmi_principal *p)
{
    if (!vmi_inertia_is_finite(&lump->inertia)) return VM_NOT_FINITE;
    *p = vmi_principal_axes(&lump->inertia);
    if (!vmi_moments_are_possible(p, vmi_inertia_slack(&lump->sizes))) return VM_BAD_INERTIA;
    if (vmi_clamp_moments(p, &lump->sizes)) lump->inertia = vmi_inertia_from(p);
    return VM_OK;
}

/* Sets *omega to the angular velocity, relative to the frame and in inertial axes, of a lump with principal axes p.
   `before` is this angular velocity before the jump. Returns 1 if the lump has angular momentum about an axis with zero
   moment of inertia, which is impossible. Returns 0 otherwise. */
VM_API int vmi_lump_spin(const vmi_frame *frame, const vmi_lump *lump, const vmi_principal *p, vm_vec3 before,
                         vm_vec3 *omega)
{
    const vm_real noise = 2 * VM_EPSILON * (lump->noise + vmi_norm1(lump->h));
    vm_vec3 spin;
    const int left = vmi_solve_spin(&lump->inertia, p, vmi_times_transposed(&frame->turn, lump->h), noise,
                                    vmi_times_transposed(&frame->turn, before), &spin);
    *omega = vmi_times(&frame->turn, spin);
    return left;
}

/* Sets *result to a body after n others are attached to it (sign = 1) or separate from it (sign = -1), while an impulse
   acts. The statuses are those of vm_separate. */
VM_API int vmi_jump(const vm_body *body, int n, const vm_body *others, vm_real sign,
                    const vm_impulse *external_or_NULL, vm_body *result)
{
    const vmi_bodies list = vmi_bodies_in_space(n, others);
    vmi_frame frame;
    vmi_lump lump;
    vmi_principal p;
    vm_body b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_jump(body, &list, external_or_NULL);
    if (status) return status;
    frame = vmi_frame_of(body, &list, sign);
    status = vmi_jump_total(&frame, body, sign, &list, external_or_NULL, &lump);
    if (!status) status = vmi_lump_clamp_moments(&lump, &p);
    if (status) return status;
    b.mass = lump.mass;
    b.inertia = lump.inertia;
    b.q = body->q;
    b.r = vmi_add(frame.r, lump.r);
    b.v = vmi_add(frame.v, lump.v);
    if (vmi_lump_spin(&frame, &lump, &p, vmi_sub(body->omega, frame.omega), &b.omega)) status = VM_NULL_AXIS;
    b.omega = vmi_add(frame.omega, b.omega);
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* Separation of a part from a body: *rest is what remains of the whole. *part is the part with its motion after the
   separation. *rest gets its mass, mass centre (15), inertia by parallel axes (40), velocity (24) and angular velocity
   (34), and the whole's attitude. The impulse, if there is one, acts during the separation. The law is exact in space:
   momentum and angular momentum of rest and part together are those of the whole plus the impulse. The pointer rest may
   be equal to whole or to part.

   If the part moves on as before the separation, the rest keeps its motion, even if only little inertia is left. The
   computation adds only motions relative to the whole. Neither high speed nor a position far from the origin therefore
   costs digits of omega. The error of the rest's inertia is at most 8 eps of the trace of the whole's inertia, plus the
   effect of a change of the positions by eps of their size. A principal moment below this error becomes 0.

   Returns VM_OK, VM_NULL_AXIS or an error. VM_NULL_AXIS (> 0) means: *rest is set and is a rod or a point, but the
   balance leaves it angular momentum about an axis without inertia, which it cannot have. Its spin about this axis is
   then that of the whole. The errors are VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS if a mass (or
   that of the rest) is not positive, and VM_BAD_INERTIA for an inertia that no body has. The rest has such an inertia
   if the part cannot have been in the whole. */
VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL, vm_body *rest)
{
    return vmi_jump(whole, 1, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of one body to another (plastic impact): *whole is the two bodies together, (24), (33). `body` and `added`
   have the motions just before the impact. The impulse, if there is one, acts during the impact. The whole has the
   attitude of `body`. The statuses are those of vm_separate. With VM_NULL_AXIS the whole is a rod or a point, and the
   spin about its null axis remains that of `body`. */
VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole)
{
    return vmi_jump(body, 1, added, VMI_ATTACH, external_or_NULL, whole);
}

/* Separation of n parts from a body at once: *rest is what remains. Except for rounding errors, n calls of
   vm_separate give the same result. With n = 0 only the impulse acts on the body. The statuses are those of
   vm_separate, and VM_BAD_ARGUMENT for n < 0. */
VM_API int vm_separate_all(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                           vm_body *rest)
{
    return vmi_jump(whole, n, parts, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of n bodies to a body at once: *whole is all of them together. Except for rounding errors, n calls of
   vm_attach give the same result. With n = 0 only the impulse acts on the body. The statuses are those of vm_attach,
   and VM_BAD_ARGUMENT for n < 0. */
VM_API int vm_attach_all(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                         vm_body *whole)
{
    return vmi_jump(body, n, added, VMI_ATTACH, external_or_NULL, whole);
}

/* ---- the inertia of a whole and of its parts ---- */

/* A body at rest whose axes are the inertial axes */
VM_API vm_body vmi_body_at_rest(vm_real mass, const vm_inertia *inertia, vm_vec3 r)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = mass;
    b.inertia = *inertia;
    b.r = r;
    return b;
}

/* Sets *joined and *centre to inertia and mass centre of body a, at 0, after body b, at d, joins or leaves it */
VM_API int vmi_joined_inertia(vm_real mass_a, const vm_inertia *a, vm_real sign, vm_real mass_b,
                              const vm_inertia *b, vm_vec3 d, vm_inertia *joined, vm_vec3 *centre)
{
    vm_body first, second;
    int status;
    if (!a || !b || !joined || !centre) return VM_BAD_ARGUMENT;
    first = vmi_body_at_rest(mass_a, a, vmi_vec3(0, 0, 0));
    second = vmi_body_at_rest(mass_b, b, d);
    status = vmi_jump(&first, 1, &second, sign, NULL, &first);
    if (!status) {
        *joined = first.inertia;
        *centre = first.r;
    }
    return status;
}

/* Inertia of two bodies together, about their common mass centre: (13)-(15), (40). All inertias (kg m^2) are along one
   set of axes, each about its body's own mass centre. d (m) leads from the mass centre of a to that of b. The result
   *centre (m) leads from the mass centre of a to the common one. Returns VM_BAD_ARGUMENT for a null pointer,
   VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA as vm_attach does, and VM_OK otherwise. */
VM_API int vm_combine_inertia(vm_real mass_a, const vm_inertia *a, vm_real mass_b, const vm_inertia *b, vm_vec3 d,
                              vm_inertia *whole, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass_a, a, VMI_ATTACH, mass_b, b, d, whole, centre);
}

/* Inertia of a body without a part, about the mass centre of what is left: (13)-(15), (40). It undoes
   vm_combine_inertia. d (m) leads from the mass centre of the whole to that of the part. The result *centre (m) leads
   from the mass centre of the whole to that of the rest. The statuses are those of vm_combine_inertia. */
VM_API int vm_split_inertia(vm_real mass, const vm_inertia *whole, vm_real part_mass, const vm_inertia *part,
                            vm_vec3 d, vm_inertia *rest, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass, whole, VMI_SEPARATE, part_mass, part, d, rest, centre);
}

#endif
/* mechanics/jumps2.h - parts separate from a body or are attached to it, in the plane
   This is jumps.h for the plane, (35)-(39): a body of the plane has one moment of inertia and one angular velocity.
   The code of jumps.h joins the masses. Only the last step, from angular momentum to angular velocity, differs.

       vm_body2 plate = {2, 0.1, 0, 0, 0, 3, 0, 8}, chip = {0.1, 0, 0.2, 0, 0, 5, 1, 8}, rest;
       int status = vm_separate2(&plate, &chip, NULL, &rest); // VM_OK: how the rest moves on

   Tests: tests/test_jumps2.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_JUMPS2_H
#define VARMASS_MECHANICS_JUMPS2_H

/* An impulse in the plane, written as one in space */
VM_API vm_impulse vmi_impulse_to_space(const vm_impulse2 *j)
{
    vm_impulse lifted;
    lifted.linear = vmi_vec3(j->jx, j->jy, 0);
    lifted.couple = vmi_vec3(0, 0, j->couple);
    lifted.at = vmi_vec3(j->x, j->y, 0);
    return lifted;
}

/* Sets the moment of inertia of a lump of the plane to 0 if it is smaller than its rounding errors. Returns
   VM_NOT_FINITE, VM_BAD_INERTIA for a clearly negative moment, or VM_OK. */
VM_API int vmi_lump_clamp_moments2(vmi_lump *lump)
{
    if (!VM_IS_FINITE(lump->inertia.zz)) return VM_NOT_FINITE;
    if (lump->inertia.zz < -32 * VM_EPSILON * lump->sizes.zz) return VM_BAD_INERTIA;
    if (lump->inertia.zz <= VMI_LOST_SHARE * lump->sizes.zz) lump->inertia.zz = 0;
    return VM_OK;
}

/* Sets *omega to the angular velocity of a lump relative to the frame, (44). If the lump has no inertia, *omega becomes
   `before`, the value before the jump. Returns 1 if a lump without inertia has angular momentum, which is impossible,
   else 0. */
VM_API int vmi_lump_spin2(const vmi_lump *lump, vm_real before, vm_real *omega)
{
    if (lump->inertia.zz > 0) {
        *omega = lump->h.z / lump->inertia.zz;
        return 0;
    }
    *omega = before;
    return VM_FABS(lump->h.z) > 2 * VM_EPSILON * (lump->noise + VM_FABS(lump->h.z));
}

/* Returns VM_OK if the bodies of a jump in the plane are valid and the impulse is finite, else an error. */
VM_API int vmi_check_jump2(const vm_body2 *body, const vmi_bodies *others, const vm_impulse2 *external_or_NULL)
{
    const int status = vmi_first_error(vmi_check_body2(body), vmi_check_bodies(others));
    vm_impulse impulse;
    if (!external_or_NULL) return status;
    impulse = vmi_impulse_to_space(external_or_NULL);
    return vmi_impulse_is_finite(&impulse) ? status : vmi_first_error(status, VM_NOT_FINITE);
}

/* Sets *total to `body` as it is after a jump in the plane and the impulse, and *frame to the frame of the jump.
   Returns VM_BAD_MASS if no mass is left, VM_NOT_FINITE or VM_BAD_INERTIA for an impossible inertia, else VM_OK. */
VM_API int vmi_jump_total2(const vm_body2 *body, const vmi_bodies *others, vm_real sign,
                           const vm_impulse2 *external_or_NULL, vmi_frame *frame, vmi_lump *total)
{
    const vm_body lifted = vmi_body_to_space(body);
    const vm_impulse *given = NULL;
    vm_impulse impulse;
    int status;
    if (external_or_NULL) {
        impulse = vmi_impulse_to_space(external_or_NULL);
        given = &impulse;
    }
    *frame = vmi_frame_of(&lifted, others, sign);
    status = vmi_jump_total(frame, &lifted, sign, others, given, total);
    return status ? status : vmi_lump_clamp_moments2(total);
}

/* Sets *result to a body of the plane after n others are attached to it (sign = 1) or separate from it (sign = -1),
   while an impulse acts. The statuses are those of vm_separate2. */
VM_API int vmi_jump2(const vm_body2 *body, int n, const vm_body2 *others, vm_real sign,
                     const vm_impulse2 *external_or_NULL, vm_body2 *result)
{
    const vmi_bodies list = vmi_bodies_in_plane(n, others);
    vmi_frame frame;
    vmi_lump lump;
    vm_body2 b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_jump2(body, &list, external_or_NULL);
    if (!status) status = vmi_jump_total2(body, &list, sign, external_or_NULL, &frame, &lump);
    if (status) return status;
    b.mass = lump.mass;
    b.inertia = lump.inertia.zz;
    b.angle = body->angle;
    b.x = frame.r.x + lump.r.x;
    b.y = frame.r.y + lump.r.y;
    b.vx = frame.v.x + lump.v.x;
    b.vy = frame.v.y + lump.v.y;
    if (vmi_lump_spin2(&lump, body->omega - frame.omega.z, &b.omega)) status = VM_NULL_AXIS;
    b.omega += frame.omega.z;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* Separation of a part from a body in the plane: *rest is what remains of the whole, (35)-(39). *part is the part with
   its motion after the separation. The impulse, if there is one, acts during the separation. Momentum and angular
   momentum of rest and part together are those of the whole plus the impulse. The pointer rest may be equal to whole or
   to part. The accuracy is that of vm_separate.

   Returns VM_OK, VM_NULL_AXIS or an error. VM_NULL_AXIS (> 0) means: *rest is set and is a point, but the balance
   leaves it angular momentum about itself, which it cannot have. Its omega is then that of the whole. The errors are
   VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS if a mass (or that of the rest) is not positive, and
   VM_BAD_INERTIA if an inertia (or that of the rest) is negative. */
VM_API int vm_separate2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                        vm_body2 *rest)
{
    return vmi_jump2(whole, 1, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of one body to another in the plane (plastic impact): *whole is the two bodies together. `body` and
   `added` have the motions just before the impact. The impulse, if there is one, acts during the impact. The whole has
   the angle of `body`. The statuses are those of vm_separate2. With VM_NULL_AXIS the two bodies are points at one
   position, and omega remains that of `body`. */
VM_API int vm_attach2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                      vm_body2 *whole)
{
    return vmi_jump2(body, 1, added, VMI_ATTACH, external_or_NULL, whole);
}

/* Separation of n parts from a body at once, in the plane: *rest is what remains. Except for rounding errors, n
   calls of vm_separate2 give the same result. With n = 0 only the impulse acts on the body. The statuses are those
   of vm_separate2, and VM_BAD_ARGUMENT for n < 0. */
VM_API int vm_separate_all2(const vm_body2 *whole, int n, const vm_body2 *parts,
                            const vm_impulse2 *external_or_NULL, vm_body2 *rest)
{
    return vmi_jump2(whole, n, parts, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment of n bodies to a body at once, in the plane: *whole is all of them together. Except for rounding
   errors, n calls of vm_attach2 give the same result. With n = 0 only the impulse acts on the body. The statuses
   are those of vm_attach2, and VM_BAD_ARGUMENT for n < 0. */
VM_API int vm_attach_all2(const vm_body2 *body, int n, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                          vm_body2 *whole)
{
    return vmi_jump2(body, n, added, VMI_ATTACH, external_or_NULL, whole);
}

#endif
/* mechanics/relative.h - motion relative to a moving body, and jumps given in such motions
   This chapter gives the motion of a body relative to the frame that moves and turns rigidly with another body (25),
   (26), (41), and the laws of jumps for such relative motions, (28)-(31), (42)-(44). Use these laws if only the
   velocity of a part relative to the whole is known.

       vm_body part = whole, rest; // whole is a vm_body
       part.mass = 1;
       part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1;
       part.v.x = part.v.y = part.omega.x = part.omega.y = part.omega.z = 0;
       part.v.z = 2;                                     // it leaves at 2 m/s, relative to the whole
       if (vm_separate_relative(&whole, &part, NULL, &rest) == VM_OK) vm_to_absolute(&whole, &rest, &rest);

   Tests: tests/test_relative.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_RELATIVE_H
#define VARMASS_MECHANICS_RELATIVE_H

/* Velocity at the point r of the frame that moves rigidly with a body. In (25) it is the dragging velocity. */
VM_API vm_vec3 vmi_velocity_at(const vm_body *body, vm_vec3 r)
{
    return vmi_add(body->v, vmi_cross(body->omega, vmi_sub(r, body->r)));
}

/* The motion of b relative to the frame that moves rigidly with the body `to`. Nothing is checked. */
VM_API vm_body vmi_relative_motion(const vm_body *to, vm_body b)
{
    b.v = vmi_sub(vmi_sub(b.v, to->v), vmi_cross(to->omega, vmi_sub(b.r, to->r)));
    b.omega = vmi_sub(b.omega, to->omega);
    return b;
}

/* The absolute motion of b, whose motion is given relative to the body `to`. Nothing is checked. */
VM_API vm_body vmi_absolute_motion(const vm_body *to, vm_body b)
{
    b.v = vmi_add(vmi_velocity_at(to, b.r), b.v);
    b.omega = vmi_add(to->omega, b.omega);
    return b;
}

/* Copies b to *result. Returns VM_NOT_FINITE, and copies nothing, if a number is not finite. */
VM_API int vmi_put_body(const vm_body *b, vm_body *result)
{
    if (!vmi_body_is_finite(b)) return VM_NOT_FINITE;
    *result = *b;
    return VM_OK;
}

/* Copies b to *result as a body of the plane with the given angle. Returns VM_NOT_FINITE, and copies nothing, if a
   number is not finite. */
VM_API int vmi_put_body2(const vm_body *b, vm_real angle, vm_body2 *result)
{
    const vm_body2 flat = vmi_body_to_plane(b, angle);
    if (!vmi_body2_is_finite(&flat)) return VM_NOT_FINITE;
    *result = flat;
    return VM_OK;
}

/* Motion of a body relative to the frame that moves rigidly with the body `to`. The body has position r, velocity v and
   angular velocity omega; `to` has r_S, v_S and Omega. v and omega of *relative become
     v_r = v - v_S - Omega x (r - r_S) (25), (26), (98), (101),  Omega_r = omega - Omega (41), (99), (102),
   and all other fields are copied. The vectors remain along the inertial axes, and r remains the position from the
   inertial origin. The pointer relative may be equal to absolute. Returns VM_BAD_ARGUMENT for a null pointer,
   VM_NOT_FINITE if a number of *absolute, the motion of `to` or the result is not finite, and VM_OK otherwise. Masses
   and inertias are not checked further. */
VM_API int vm_to_relative(const vm_body *to, const vm_body *absolute, vm_body *relative)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = vmi_relative_motion(to, *absolute);
    return vmi_put_body(&b, relative);
}

/* Computes the absolute motion of a body from its motion relative to the body `to`. The function is the inverse of
   vm_to_relative and returns the same statuses. The pointer absolute may be equal to relative. */
VM_API int vm_to_absolute(const vm_body *to, const vm_body *relative, vm_body *absolute)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = vmi_absolute_motion(to, *relative);
    return vmi_put_body(&b, absolute);
}

/* Motion of a body in the plane, relative to the frame that moves rigidly with the body `to`. vx, vy and omega change
   as in vm_to_relative, and all other fields are copied. The statuses are those of vm_to_relative. */
VM_API int vm_to_relative2(const vm_body2 *to, const vm_body2 *absolute, vm_body2 *relative)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_relative_motion(&whole, vmi_body_to_space(absolute));
    return vmi_put_body2(&b, absolute->angle, relative);
}

/* Computes the absolute plane motion of a body from its motion relative to the body `to`. The function is the inverse
   of vm_to_relative2 and returns the same statuses. */
VM_API int vm_to_absolute2(const vm_body2 *to, const vm_body2 *relative, vm_body2 *absolute)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_absolute_motion(&whole, vmi_body_to_space(relative));
    return vmi_put_body2(&b, relative->angle, absolute);
}

/* ---- jumps ---- */

/* Computes a jump from motions relative to `body`. In its own frame `body` is at rest, and the equations of a jump have
   the same form as in an inertial frame. */
VM_API int vmi_jump_relative(const vm_body *body, const vm_body *other, vm_real sign,
                             const vm_impulse *external_or_NULL, vm_body *result)
{
    vm_body still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.v = still.omega = vmi_vec3(0, 0, 0);
    return vmi_jump(&still, 1, other, sign, external_or_NULL, result);
}

/* Computes a jump in the plane from motions relative to `body`, which is at rest in its own frame */
VM_API int vmi_jump_relative2(const vm_body2 *body, const vm_body2 *other, vm_real sign,
                              const vm_impulse2 *external_or_NULL, vm_body2 *result)
{
    vm_body2 still;
    if (!body) return VM_BAD_ARGUMENT;
    still = *body;
    still.vx = still.vy = still.omega = 0;
    return vmi_jump2(&still, 1, other, sign, external_or_NULL, result);
}

/* Separation, with motions given relative to the whole: (28)-(31), (42)-(44). v and omega of *part and of *rest are
   relative to the whole. v and omega of *whole are not read. Everything else, the statuses included, is as in
   vm_separate. */
VM_API int vm_separate_relative(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                vm_body *rest)
{
    return vmi_jump_relative(whole, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment, with motions given relative to the first body: (28)-(31), (42)-(44). v and omega of *added and of *whole
   are relative to `body`. v and omega of *body are not read. Everything else, the statuses included, is as in
   vm_attach. */
VM_API int vm_attach_relative(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL,
                              vm_body *whole)
{
    return vmi_jump_relative(body, added, VMI_ATTACH, external_or_NULL, whole);
}

/* Separation in the plane, with motions given relative to the whole. vx, vy and omega of *part and of *rest are
   relative to the whole. vx, vy and omega of *whole are not read. Everything else, the statuses included, is as in
   vm_separate2. */
VM_API int vm_separate_relative2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_body2 *rest)
{
    return vmi_jump_relative2(whole, part, VMI_SEPARATE, external_or_NULL, rest);
}

/* Attachment in the plane, with motions given relative to the first body. vx, vy and omega of *added and of *whole are
   relative to `body`. vx, vy and omega of *body are not read. Everything else, the statuses included, is as in
   vm_attach2. */
VM_API int vm_attach_relative2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                               vm_body2 *whole)
{
    return vmi_jump_relative2(body, added, VMI_ATTACH, external_or_NULL, whole);
}

#endif
/* mechanics/inverse.h - how a part must leave, so that the rest moves as wanted
   This chapter inverts a separation. It answers the questions of Tables 2 to 4 of the dissertation [1]: with which
   motion must a part leave so that the rest does not turn, is at rest, or moves on as the whole did?

       vm_vec3 none = {0, 0, 0};
       vm_body moving; // whole and part are vm_bodies
       int status = vm_separation_for_rest(&whole, &part, NULL, NULL, &none, &moving); // VM_OK: the rest does not
           // turn if the part leaves with the motion that is now in the variable `moving`

   Tests: tests/test_inverse.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_INVERSE_H
#define VARMASS_MECHANICS_INVERSE_H

/* The velocity v2 with which the part must leave so that the rest gets the velocity v1 = rest_v. By (24) it is
   v2 = v + (linear - M1 (v1 - v))/m, with the velocity v of the whole, the impulse `linear`, the mass M1 of the rest
   and the mass m of the part. */
VM_API vm_vec3 vmi_part_velocity(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                 vm_vec3 rest_v)
{
    vm_vec3 momentum = vmi_scale(part->mass - whole->mass, vmi_sub(rest_v, whole->v));
    if (external_or_NULL) momentum = vmi_add(momentum, external_or_NULL->linear);
    return vmi_add(whole->v, vmi_over(momentum, part->mass));
}

/* The angular momentum that the part must have relative to the whole so that the rest turns with rest_omega. It is
   h - I1 (rest_omega - Omega), where Omega is the angular velocity of the whole and I1 the inertia of the rest. h is
   the angular momentum that the rest has if the part turns with Omega. */
VM_API vm_vec3 vmi_part_spin_momentum(const vmi_frame *frame, const vmi_lump *rest, vm_vec3 rest_omega)
{
    const vm_vec3 turning = vmi_times_transposed(&frame->turn, vmi_sub(rest_omega, frame->omega));
    return vmi_sub(rest->h, vmi_times(&frame->turn, vmi_inertia_times(&rest->inertia, turning)));
}

/* Sets *rest to what would remain if the part left with its own velocity but with the angular velocity of the whole.
   The caller has checked the bodies. Only the velocity of the part may be infinite or NaN. */
VM_API int vmi_unturned_rest(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                             vmi_frame *frame, vmi_lump *rest)
{
    vm_body unturned = *part;
    const vmi_bodies list = vmi_bodies_in_space(1, &unturned);
    vmi_principal p;
    int status;
    if (!vmi_vec3_is_finite(part->v)) return VM_NOT_FINITE;
    unturned.omega = whole->omega;
    *frame = vmi_frame_of(whole, &list, VMI_SEPARATE);
    status = vmi_jump_total(frame, whole, VMI_SEPARATE, &list, external_or_NULL, rest);
    return status ? status : vmi_lump_clamp_moments(rest, &p);
}

/* Gives the part the angular velocity that makes the rest turn with rest_omega. Returns VM_NULL_AXIS if the part would
   need angular momentum about an axis with zero moment of inertia. */
VM_API int vmi_turn_part(const vmi_frame *frame, const vmi_lump *rest, vm_vec3 rest_omega, vm_body *part)
{
    vmi_frame own = *frame; /* the frame of the jump, with the axes of the part */
    vmi_lump lump;
    vmi_principal p;
    vm_vec3 spin;
    int status;
    own.q = part->q;
    own.turn = vmi_rotation(part->q);
    lump = vmi_lump_of(&own, part);
    lump.h = vmi_part_spin_momentum(frame, rest, rest_omega);
    lump.noise = rest->noise + vmi_inertia_trace(&rest->inertia) * (vmi_norm1(rest_omega) + vmi_norm1(frame->omega));
    status = vmi_lump_clamp_moments(&lump, &p);
    if (status) return status;
    if (vmi_lump_spin(&own, &lump, &p, vmi_sub(part->omega, own.omega), &spin)) status = VM_NULL_AXIS;
    part->omega = vmi_add(own.omega, spin);
    return status;
}

/* How a part must leave, so that the rest moves as wanted: the inverse of vm_separate. *moving becomes a copy of *part
   with another motion. Its velocity makes the rest move at *rest_v_or_NULL (m/s), and its angular velocity makes the
   rest turn with *rest_omega_or_NULL (rad/s). If one of these two pointers is NULL, *moving keeps the velocity, or the
   angular velocity, of *part.
     - If *rest_omega_or_NULL is 0, the rest does not turn (Table 2, cases 5 and 7; Table 4, case 2).
     - If *rest_v_or_NULL is 0, too, the rest is at rest (Table 3, cases 6 and 8).
     - If both have the values of the whole, the rest moves on as the whole did (Table 3, case 7).

   Returns VM_NULL_AXIS (> 0) if the part would need angular momentum about an axis with zero moment of inertia. *moving
   then brings the rest as close to the wanted motion as possible. The other statuses are those of vm_separate. */
VM_API int vm_separation_for_rest(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                  const vm_vec3 *rest_v_or_NULL, const vm_vec3 *rest_omega_or_NULL, vm_body *moving)
{
    const vmi_bodies parts = vmi_bodies_in_space(1, part);
    vmi_frame frame;
    vmi_lump rest;
    vm_body b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (rest_v_or_NULL && !vmi_vec3_is_finite(*rest_v_or_NULL)) return VM_NOT_FINITE;
    if (rest_omega_or_NULL && !vmi_vec3_is_finite(*rest_omega_or_NULL)) return VM_NOT_FINITE;
    status = vmi_check_jump(whole, &parts, external_or_NULL);
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) b.v = vmi_part_velocity(whole, part, external_or_NULL, *rest_v_or_NULL);
    status = vmi_unturned_rest(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) status = vmi_turn_part(&frame, &rest, *rest_omega_or_NULL, &b);
    if (status < 0) return status;
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* ---- the plane ---- */

/* Sets vx and vy of *part, in the plane, to the velocity that gives the rest the velocity rest_v */
VM_API void vmi_push_part2(const vm_body2 *whole, const vm_impulse2 *external_or_NULL, const vm_real *rest_v,
                           vm_body2 *part)
{
    const vm_body from = vmi_body_to_space(whole), leaving = vmi_body_to_space(part);
    const vm_impulse *given = NULL;
    vm_impulse impulse;
    vm_vec3 v;
    if (external_or_NULL) {
        impulse = vmi_impulse_to_space(external_or_NULL);
        given = &impulse;
    }
    v = vmi_part_velocity(&from, &leaving, given, vmi_vec3(rest_v[0], rest_v[1], 0));
    part->vx = v.x;
    part->vy = v.y;
}

/* Sets *rest, in the plane, to what would remain if the part left with its own velocity but with the angular velocity
   of the whole. Sets *frame to the frame of the jump. */
VM_API int vmi_unturned_rest2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                              vmi_frame *frame, vmi_lump *rest)
{
    vm_body2 unturned = *part;
    const vmi_bodies list = vmi_bodies_in_plane(1, &unturned);
    if (!VM_IS_FINITE(part->vx) || !VM_IS_FINITE(part->vy)) return VM_NOT_FINITE;
    unturned.omega = whole->omega;
    return vmi_jump_total2(whole, &list, VMI_SEPARATE, external_or_NULL, frame, rest);
}

/* Gives the part, in the plane, the angular velocity that makes the rest turn with rest_omega. Returns VM_NULL_AXIS if
   the part is a point but would need angular momentum about itself. */
VM_API int vmi_turn_part2(const vm_body2 *whole, const vmi_frame *frame, const vmi_lump *rest, vm_real rest_omega,
                          vm_body2 *part)
{
    vmi_lump lump = *rest;
    vm_real spin;
    int left;
    lump.inertia.zz = part->inertia;
    lump.h = vmi_part_spin_momentum(frame, rest, vmi_vec3(0, 0, rest_omega));
    lump.noise += rest->inertia.zz * (VM_FABS(rest_omega) + VM_FABS(whole->omega));
    left = vmi_lump_spin2(&lump, part->omega - whole->omega, &spin);
    part->omega = spin + whole->omega;
    return left ? VM_NULL_AXIS : VM_OK;
}

/* How a part must leave in the plane, so that the rest moves as wanted: the inverse of vm_separate2. *moving becomes a
   copy of *part with another motion. Its velocity makes the rest move at (rest_v_or_NULL[0], rest_v_or_NULL[1]), in m/s
   along x and y. Its angular velocity makes the rest turn with *rest_omega_or_NULL, in rad/s. If one of these two
   pointers is NULL, *moving keeps the velocity, or the angular velocity, of *part. The statuses are those of
   vm_separation_for_rest. */
VM_API int vm_separation_for_rest2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                   const vm_real *rest_v_or_NULL, const vm_real *rest_omega_or_NULL,
                                   vm_body2 *moving)
{
    const vmi_bodies parts = vmi_bodies_in_plane(1, part);
    vmi_frame frame;
    vmi_lump rest;
    vm_body2 b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (rest_v_or_NULL && !(VM_IS_FINITE(rest_v_or_NULL[0]) && VM_IS_FINITE(rest_v_or_NULL[1])))
        return VM_NOT_FINITE;
    if (rest_omega_or_NULL && !VM_IS_FINITE(*rest_omega_or_NULL)) return VM_NOT_FINITE;
    status = vmi_check_jump2(whole, &parts, external_or_NULL);
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) vmi_push_part2(whole, external_or_NULL, rest_v_or_NULL, &b);
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) status = vmi_turn_part2(whole, &frame, &rest, *rest_omega_or_NULL, &b);
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* Velocity of a part that leaves the rest with a wanted spin, in the plane (Table 3, case 7). The rest then turns with
   rest_omega (rad/s), while the part keeps its own spin. S and S2 are the mass centres of whole and part. The velocity
   of *moving relative to the whole, v_r, is the smallest that causes this spin. v_r is orthogonal to the line SS2; any
   velocity along SS2 may be added to it. The velocity in *part is not read. Returns VM_SINGULAR if S and S2 are one
   point, so that no velocity turns the rest. The other statuses are those of vm_separate2. */
VM_API int vm_separation_for_spin2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                   vm_real rest_omega, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_lump rest;
    vm_body2 b;
    vmi_bodies parts;
    vm_real dx, dy, h, c;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(rest_omega)) return VM_NOT_FINITE;
    b = *part;
    dx = b.x - whole->x; /* the vector SS2 */
    dy = b.y - whole->y;
    b.vx = whole->vx - whole->omega * dy; /* first v_r = 0: the part moves as the whole does */
    b.vy = whole->vy + whole->omega * dx;
    parts = vmi_bodies_in_plane(1, &b);
    status = vmi_check_jump2(whole, &parts, external_or_NULL);
    if (!status) status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (dx == 0 && dy == 0) return VM_SINGULAR;
    /* The velocity v_r = c k x SS2 must supply the angular momentum h that the spins of part and rest do not account
       for. v_r supplies m M/M1 SS2 x v_r. M, m, M1 are the masses of whole, part and rest; k is the unit vector along
       z. */
    h = rest.h.z - b.inertia * (b.omega - whole->omega) - rest.inertia.zz * (rest_omega - whole->omega);
    c = h * rest.mass / (b.mass * whole->mass * (dx * dx + dy * dy));
    b.vx -= c * dy;
    b.vy += c * dx;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return VM_OK;
}

#endif
/* mechanics/jump_energy.h - the kinetic energy that a jump adds or takes
   Kinetic energy is not conserved when bodies separate or join. Without an impulse, a separation adds, and an
   attachment takes, the kinetic energy of the motions relative to the whole: (113), (118), Carnot's theorem.

       vm_body rest; // whole and part are known vm_bodies
       vm_real gain = VM_NAN;
       if (vm_separate(&whole, &part, NULL, &rest) == VM_OK) gain = vm_energy_gain(&whole, 1, &part, NULL, &rest);

   Tests: tests/test_jumps.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_JUMP_ENERGY_H
#define VARMASS_MECHANICS_JUMP_ENERGY_H

/* The sum of the kinetic energies of the n `bodies` and of one_more in their motions relative to `whole`. Returns NaN
   for a null pointer or n < 0. */
VM_API vm_real vmi_relative_energy(const vm_body *whole, int n, const vm_body *bodies, const vm_body *one_more)
{
    vm_real sum = 0;
    vm_body b;
    int i;
    if (!whole || !one_more || n < 0 || (n > 0 && !bodies)) return VM_NAN;
    for (i = 0; i < n; i++) {
        b = vmi_relative_motion(whole, bodies[i]);
        sum += vm_kinetic_energy(&b);
    }
    b = vmi_relative_motion(whole, *one_more);
    return sum + vm_kinetic_energy(&b);
}

/* Work of an impulse on a body, J: v.linear + omega.moment, with the moment about the mass centre. Returns 0 for a null
   pointer. */
VM_API vm_real vmi_impulse_work(const vm_body *body_or_NULL, const vm_impulse *external_or_NULL)
{
    const vm_body *b = body_or_NULL;
    const vm_impulse *j = external_or_NULL;
    if (!b || !j) return 0;
    return vmi_dot(b->v, j->linear) + vmi_dot(b->omega, vmi_impulse_moment(j, b->r));
}

/* Energy gained at a separation, J: the kinetic energy of the n parts and the rest less that of the whole (113), (118).
   It is computed as the kinetic energy of their motions relative to the whole, plus the work of the impulse on the
   whole. This holds exactly in space. At high speed it keeps digits that the difference of the energies loses. `whole`
   is the body before the separation; `parts` and `rest` are those after it. Returns NaN for a null pointer or n < 0. */
VM_API vm_real vm_energy_gain(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                              const vm_body *rest)
{
    return vmi_relative_energy(whole, n, parts, rest) + vmi_impulse_work(whole, external_or_NULL);
}

/* Energy lost at an attachment, J: the kinetic energy of `body` and of the n bodies `added` less that of the whole
   (Carnot's loss). It is computed as the kinetic energy of their motions relative to the whole, less the work of the
   impulse on the whole. `body` and `added` are the bodies before the attachment; `whole` is the body after it. Returns
   NaN for a null pointer or n < 0. */
VM_API vm_real vm_energy_loss(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                              const vm_body *whole)
{
    return vmi_relative_energy(whole, n, added, body) - vmi_impulse_work(whole, external_or_NULL);
}

#endif
/* mechanics/broken_rotor.h - a rotor from which a piece breaks off: equations of motion and the break

   The rotor is a disc on a massless elastic shaft. It moves in a plane. A torque drives it, and its rotation is damped
   viscously (chapter 3.3.2). The shaft passes through the mass centre before the break (s = 0) and at the distance s
   from it after the break. This chapter has the equations of motion (46), (65)-(68), also in polar form (75), and the
   break (52)-(64), corrected as in docs/errata.md. The motion of the rotor is in mechanics/broken_rotor_motion.h, and
   the stability of the remainder's steady motion is in mechanics/broken_rotor_stability.h.

       vm_broken_rotor whole = {2, 1, 20, 1, 3, 0}; // the fields in their order below
       vm_broken_rotor_piece piece = {VM_C(0.1), VM_C(0.001), VM_C(0.5), 0, VM_C(0.6), 0};
       vm_broken_rotor_break result;
       vm_real y[VM_BROKEN_ROTOR_STATES] = {VM_C(0.01), 0, 0, 0, 0, 3};
       int status = vm_broken_rotor_break_off(&whole, y, &piece, &result); // result.rest moves on from result.state

   Tests: tests/test_broken_rotor.c. */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_H

#include <string.h>

/* The rotor. The formulas use the abbreviations (67): omega^2 = stiffness/mass, p^2 = mass/inertia,
   k* = damping/inertia, M* = torque/inertia. */
typedef struct VM_TAG(vm_broken_rotor) {
    vm_real mass;      /* mass M > 0, kg */
    vm_real inertia;   /* inertia I > 0 about the rotor's own mass centre, kg m^2 */
    vm_real stiffness; /* stiffness c >= 0 of the shaft, N/m */
    vm_real damping;   /* damping k, N m s: at the angular velocity psi' the torque -k psi' acts on the rotor */
    vm_real torque;    /* driving torque, N m */
    vm_real s;         /* distance from the mass centre to the shaft, which lies in the direction psi, m */
} vm_broken_rotor;

/* Indices of the states of a rotor in the array y, and the number of states */
enum {
    VM_BROKEN_ROTOR_X = 0,     /* position x, y of the mass centre, from the rest position of the shaft, m */
    VM_BROKEN_ROTOR_ANGLE = 2, /* angle psi of the rotor, rad */
    VM_BROKEN_ROTOR_V = 3,     /* velocity x', y' of the mass centre, m/s */
    VM_BROKEN_ROTOR_OMEGA = 5, /* angular velocity psi', rad/s */
    VM_BROKEN_ROTOR_STATES = 6
};

/* Indices of the states in polar form. The angle psi and its rate have the indices VM_BROKEN_ROTOR_ANGLE and
   VM_BROKEN_ROTOR_OMEGA. */
enum {
    VM_BROKEN_ROTOR_RADIUS = 0,        /* distance r > 0 of the mass centre from the rest position of the shaft, m */
    VM_BROKEN_ROTOR_DIRECTION = 1,     /* angle phi of the direction to the mass centre, rad */
    VM_BROKEN_ROTOR_RADIUS_RATE = 3,   /* rate r' of the distance, m/s */
    VM_BROKEN_ROTOR_DIRECTION_RATE = 4 /* rate phi' of the direction, rad/s */
};

/* The piece that breaks off. S is the mass centre of the whole, S2 that of the piece, and A the point at which the
   whole touches the stator. */
typedef struct VM_TAG(vm_broken_rotor_piece) {
    vm_real mass;     /* mass m of the piece, kg; 0 < m < M, where M is the mass of the whole */
    vm_real inertia;  /* inertia I_S2 >= 0 of the piece about its mass centre S2, kg m^2 */
    vm_real distance; /* distance SS2 between the mass centres S and S2, m */
    vm_real alpha;    /* angle from SS2 to SA, counterclockwise, rad (Fig. 17) */
    vm_real radius;   /* distance SA of the point of contact A, called R in the formulas, m */
    vm_real contact;  /* direction angle of SA in inertial axes, rad */
} vm_broken_rotor_piece;

/* The break, (52)-(64) as corrected in docs/errata.md. S, S2 and A are the points of vm_broken_rotor_piece, and S1 is
   the mass centre of the remainder. The dissertation [1] assumes in (57): the point A of the piece keeps its velocity,
   and the component of S2's velocity perpendicular to S2A becomes zero. Everything else follows from momentum and
   angular momentum. */
typedef struct VM_TAG(vm_broken_rotor_break) {
    vm_broken_rotor rest; /* the remainder, with its own mass, inertia and s = m SS2/(M - m); its stiffness, damping
                             and torque are those of the whole */
    /* The state of the remainder. Its angle psi is the direction from its mass centre S1 to the shaft, which is the
       direction of SS2. Its angular velocity is that of the whole, Omega_b, plus spin_rest [(59), (64) corrected]. */
    vm_real state[VM_BROKEN_ROTOR_STATES];
    vm_real piece[VM_BROKEN_ROTOR_STATES]; /* state of the piece; its angle psi is that of the remainder */
    vm_real dragging;                      /* speed v_S2d of S2, the piece's mass centre, before the break (52), m/s */
    vm_real gamma;                         /* angle from SA to S2's velocity before the break (52), (60), rad; the
                                              velocity of S is taken into account */
    vm_real beta;                          /* angle from SA to S2A, rad [(56) corrected], from
                                              tan beta = SS2 sin alpha/(R - SS2 cos alpha) */
    vm_real normal;                        /* component N of S2's velocity along S2A before the break (54), m/s */
    vm_real tangential;                    /* component T = v_S2d sin(gamma - beta) of S2's velocity before the break,
                                              perpendicular to S2A, m/s; T > 0 is counterclockwise, unlike (55) */
    vm_real spin_piece;                    /* Omega_r, the angular velocity of the piece relative to the whole, rad/s:
                                              Omega_r = T/AS2 (57), (63) */
    vm_real spin_rest;                     /* Omega_r1, angular velocity of the remainder relative to the whole, rad/s:
                                              I_S1 Omega_r1 = m M/(M - m) SS2 x v_T - I_S2 Omega_r, where v_T
                                              is the vector of size T perpendicular to S2A [(58) corrected] */
    vm_real stop_inertia;                  /* the inertia I_S2 for which the remainder would stop turning, kg m^2. There
                                              is none if the value is < 0 or not finite. For alpha = 0 it is
                                              I_S (R - SS2)/R [after (64), corrected] */
} vm_broken_rotor_break;

VM_API int vmi_check_broken_rotor(const vm_broken_rotor *r)
{
    if (!VM_IS_FINITE(r->mass) || !VM_IS_FINITE(r->inertia) || !VM_IS_FINITE(r->stiffness) ||
        !VM_IS_FINITE(r->damping) || !VM_IS_FINITE(r->torque) || !VM_IS_FINITE(r->s))
        return VM_NOT_FINITE;
    if (!(r->mass > 0)) return VM_BAD_MASS;
    if (!(r->stiffness >= 0)) return VM_BAD_STIFFNESS;
    if (!(r->inertia > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Right-hand side of the rotor's equations of motion, (65), (66), (68), (46).
   An ode_rhs of VM_BROKEN_ROTOR_STATES states; ctx is a vm_broken_rotor. Returns 0; or VM_BAD_ARGUMENT for a null
   pointer, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS for a negative stiffness, or VM_BAD_INERTIA. */
VM_API int vm_broken_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    const vm_real omega = y[VM_BROKEN_ROTOR_OMEGA];
    const int status = vmi_check_broken_rotor(r);
    vm_real sine, cosine, fx, fy; /* fx, fy: the force (66) of the shaft, N */
    (void)t;
    if (status) return status;
    vmi_sincos(y[VM_BROKEN_ROTOR_ANGLE], &sine, &cosine);
    fx = -r->stiffness * (y[VM_BROKEN_ROTOR_X] + r->s * cosine);
    fy = -r->stiffness * (y[VM_BROKEN_ROTOR_X + 1] + r->s * sine);
    dydt[VM_BROKEN_ROTOR_X] = y[VM_BROKEN_ROTOR_V];
    dydt[VM_BROKEN_ROTOR_X + 1] = y[VM_BROKEN_ROTOR_V + 1];
    dydt[VM_BROKEN_ROTOR_ANGLE] = omega;
    dydt[VM_BROKEN_ROTOR_V] = fx / r->mass;
    dydt[VM_BROKEN_ROTOR_V + 1] = fy / r->mass;
    dydt[VM_BROKEN_ROTOR_OMEGA] = (r->torque - r->damping * omega + r->s * (cosine * fy - sine * fx)) / r->inertia;
    return 0;
}

/* Right-hand side of the rotor's equations of motion in polar form (75).
   An ode_rhs of VM_BROKEN_ROTOR_STATES states {r, phi, psi, r', phi', psi'}; ctx is a vm_broken_rotor. Returns a
   status of vm_broken_rotor_rhs, or VM_DOMAIN, which ends the run, if r is not positive. */
VM_API int vm_broken_rotor_polar_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    const vm_real w2 = r->stiffness / r->mass, radius = y[VM_BROKEN_ROTOR_RADIUS], omega = y[VM_BROKEN_ROTOR_OMEGA];
    const vm_real radius_rate = y[VM_BROKEN_ROTOR_RADIUS_RATE], rate = y[VM_BROKEN_ROTOR_DIRECTION_RATE];
    const int status = vmi_check_broken_rotor(r);
    vm_real sine, cosine;
    (void)t;
    if (radius != radius) return VM_NOT_FINITE;
    if (status) return status;
    if (!(radius > 0)) return VM_DOMAIN;
    vmi_sincos(y[VM_BROKEN_ROTOR_DIRECTION] - y[VM_BROKEN_ROTOR_ANGLE], &sine, &cosine);
    dydt[VM_BROKEN_ROTOR_RADIUS] = radius_rate;
    dydt[VM_BROKEN_ROTOR_DIRECTION] = rate;
    dydt[VM_BROKEN_ROTOR_ANGLE] = omega;
    dydt[VM_BROKEN_ROTOR_RADIUS_RATE] = radius * (rate * rate) - w2 * (radius + r->s * cosine);
    dydt[VM_BROKEN_ROTOR_DIRECTION_RATE] = (r->s * w2 * sine - 2 * radius_rate * rate) / radius;
    dydt[VM_BROKEN_ROTOR_OMEGA] =
        (r->torque - r->damping * omega - r->s * r->stiffness * radius * sine) / r->inertia;
    return 0;
}

/* Convert the state {x, y, psi, x', y', psi'} of a rotor to its polar state.
   The polar state is {r, phi, psi, r', phi', psi'}. `y` and `polar` may be the same array. Returns VM_BAD_ARGUMENT for
   a null pointer, VM_NOT_FINITE, VM_DOMAIN if r is 0, and VM_OK otherwise. */
VM_API int vm_broken_rotor_to_polar(const vm_real *y, vm_real *polar)
{
    vm_real p[VM_BROKEN_ROTOR_STATES], x0, y0, vx, vy, radius, c, s;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, y)) return VM_NOT_FINITE;
    x0 = y[VM_BROKEN_ROTOR_X];
    y0 = y[VM_BROKEN_ROTOR_X + 1];
    vx = y[VM_BROKEN_ROTOR_V];
    vy = y[VM_BROKEN_ROTOR_V + 1];
    radius = vmi_hypot(x0, y0);
    if (!(radius > 0)) return VM_DOMAIN;
    c = x0 / radius;
    s = y0 / radius;
    p[VM_BROKEN_ROTOR_RADIUS] = radius;
    p[VM_BROKEN_ROTOR_DIRECTION] = vmi_atan2(y0, x0);
    p[VM_BROKEN_ROTOR_ANGLE] = y[VM_BROKEN_ROTOR_ANGLE];
    p[VM_BROKEN_ROTOR_RADIUS_RATE] = c * vx + s * vy;
    p[VM_BROKEN_ROTOR_DIRECTION_RATE] = (c * vy - s * vx) / radius;
    p[VM_BROKEN_ROTOR_OMEGA] = y[VM_BROKEN_ROTOR_OMEGA];
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_STATES, p, polar);
}

/* Convert the polar state {r, phi, psi, r', phi', psi'} of a rotor to {x, y, psi, x', y', psi'}.
   `y` and `polar` may be the same array. Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_DOMAIN if r is
   not positive, and VM_OK otherwise. */
VM_API int vm_broken_rotor_from_polar(const vm_real *polar, vm_real *y)
{
    vm_real z[VM_BROKEN_ROTOR_STATES], radius, along, across, c, s; /* velocities: along = r', across = r phi' */
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, polar)) return VM_NOT_FINITE;
    radius = polar[VM_BROKEN_ROTOR_RADIUS];
    if (!(radius > 0)) return VM_DOMAIN;
    vmi_sincos(polar[VM_BROKEN_ROTOR_DIRECTION], &s, &c);
    along = polar[VM_BROKEN_ROTOR_RADIUS_RATE];
    across = radius * polar[VM_BROKEN_ROTOR_DIRECTION_RATE];
    z[VM_BROKEN_ROTOR_X] = radius * c;
    z[VM_BROKEN_ROTOR_X + 1] = radius * s;
    z[VM_BROKEN_ROTOR_ANGLE] = polar[VM_BROKEN_ROTOR_ANGLE];
    z[VM_BROKEN_ROTOR_V] = along * c - across * s;
    z[VM_BROKEN_ROTOR_V + 1] = along * s + across * c;
    z[VM_BROKEN_ROTOR_OMEGA] = polar[VM_BROKEN_ROTOR_OMEGA];
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_STATES, z, y);
}

VM_API int vmi_broken_rotor_piece_finite(const vm_broken_rotor_piece *p)
{
    return VM_IS_FINITE(p->mass) && VM_IS_FINITE(p->inertia) && VM_IS_FINITE(p->distance) &&
           VM_IS_FINITE(p->alpha) && VM_IS_FINITE(p->radius) && VM_IS_FINITE(p->contact);
}

/* Checks the arguments of vm_broken_rotor_break_off and returns their status. */
VM_API int vmi_broken_rotor_check_break(const vm_broken_rotor *whole, const vm_real *before,
                                        const vm_broken_rotor_piece *p)
{
    int status = vmi_check_broken_rotor(whole);
    if (status == VM_NOT_FINITE) return status;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, before) || !vmi_broken_rotor_piece_finite(p)) return VM_NOT_FINITE;
    if (!(p->mass > 0 && p->mass < whole->mass)) return VM_BAD_MASS;
    if (status) return status;
    if (!(p->inertia >= 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* A vector of the plane */
typedef struct VM_TAG(vmi_broken_rotor_vector) {
    vm_real x, y;
} vmi_broken_rotor_vector;

/* The vector a turned by the angle whose sine and cosine are given */
VM_API vmi_broken_rotor_vector vmi_broken_rotor_turned(vm_real sine, vm_real cosine, vmi_broken_rotor_vector a)
{
    vmi_broken_rotor_vector b;
    b.x = cosine * a.x - sine * a.y;
    b.y = sine * a.x + cosine * a.y;
    return b;
}

/* Sets `state` to the state of a body (piece or remainder) with the angle psi. Its mass centre is at (dx, dy) from S,
   the mass centre of the whole. Its velocity (ux, uy) and its angular velocity `spin` are relative to the whole, whose
   state is `before`. */
VM_API void vmi_broken_rotor_moved(const vm_real *before, vm_real psi, vm_real dx, vm_real dy, vm_real ux, vm_real uy,
                                   vm_real spin, vm_real *state)
{
    const vm_real omega = before[VM_BROKEN_ROTOR_OMEGA];
    state[VM_BROKEN_ROTOR_X] = before[VM_BROKEN_ROTOR_X] + dx;
    state[VM_BROKEN_ROTOR_X + 1] = before[VM_BROKEN_ROTOR_X + 1] + dy;
    state[VM_BROKEN_ROTOR_ANGLE] = psi;
    state[VM_BROKEN_ROTOR_V] = before[VM_BROKEN_ROTOR_V] - omega * dy + ux;
    state[VM_BROKEN_ROTOR_V + 1] = before[VM_BROKEN_ROTOR_V + 1] + omega * dx + uy;
    state[VM_BROKEN_ROTOR_OMEGA] = omega + spin;
}

/* Sets mass, inertia and eccentricity s of the remainder. Returns VM_BAD_INERTIA if its inertia is negative or not
   larger than rounding errors, else VM_OK. */
VM_API int vmi_broken_rotor_rest(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_broken_rotor *rest)
{
    const vm_real lost = 8 * VM_EPSILON, left = whole->mass - p->mass, share = p->mass / left;
    *rest = *whole;
    rest->mass = left;
    rest->inertia = (whole->inertia - p->inertia) - share * whole->mass * (p->distance * p->distance);
    rest->s = share * p->distance;
    if (!(rest->inertia > lost * whole->inertia)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Sets the fields of *b from `dragging` to `stop_inertia`, (52)-(58), and *e, the unit vector along S2A. Returns the
   distance AS2. S and S2 are the mass centres of the whole and of the piece, A is the point of contact. d is the vector
   SS2, v the velocity of S and `spin` the angular velocity of the whole before the break. The x axis of all vectors is
   along SA, and the y axis is 90 degrees counterclockwise from it. */
VM_API vm_real vmi_broken_rotor_contact(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_real spin,
                                        vmi_broken_rotor_vector d, vmi_broken_rotor_vector v,
                                        vmi_broken_rotor_vector *e, vm_broken_rotor_break *b)
{
    const vm_real ux = v.x - spin * d.y, uy = v.y + spin * d.x; /* velocity of S2 before the break */
    const vm_real reduced = p->mass / b->rest.mass * whole->mass;
    const vm_real reach_x = p->radius - d.x, reach_y = -d.y, reach = vmi_hypot(reach_x, reach_y);
    vm_real moment; /* SS2 x v_T, where v_T is the part of S2's velocity perpendicular to S2A */
    e->x = reach_x / reach;
    e->y = reach_y / reach;
    b->dragging = vmi_hypot(ux, uy);
    b->gamma = vmi_atan2(uy, ux);
    b->beta = vmi_atan2(reach_y, reach_x);
    b->normal = ux * e->x + uy * e->y;
    b->tangential = uy * e->x - ux * e->y;
    moment = b->tangential * (d.x * e->x + d.y * e->y);
    b->spin_piece = b->tangential / reach;
    b->spin_rest = (reduced * moment - p->inertia * b->spin_piece) / b->rest.inertia;
    b->stop_inertia = (whole->inertia * spin + reduced * (moment - p->distance * p->distance * spin)) /
                      (spin + b->spin_piece);
    return reach;
}

/* Remainder and piece of a rotor after the break, with their motions, (52)-(64) corrected.
   `before` is the state of the whole at the break. Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE,
   VM_BAD_MASS if the mass of the piece is not between 0 and that of the whole, VM_BAD_STIFFNESS for a negative
   stiffness, VM_BAD_INERTIA if the inertia of the remainder is negative or not larger than rounding errors, VM_DOMAIN
   if the whole has s != 0 or if the piece's mass centre is at the point of contact A, and VM_OK otherwise. */
VM_API int vm_broken_rotor_break_off(const vm_broken_rotor *whole, const vm_real *before,
                                     const vm_broken_rotor_piece *piece, vm_broken_rotor_break *result)
{
    vm_broken_rotor_break b;
    vmi_broken_rotor_vector d, v, e;
    vm_real sine, cosine, share, T, psi;
    int status;
    if (!whole || !before || !piece || !result) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_check_break(whole, before, piece);
    if (!status) status = vmi_broken_rotor_rest(whole, piece, &b.rest);
    if (!status && whole->s != 0) status = VM_DOMAIN;
    if (status) return status;

    vmi_sincos(piece->alpha, &sine, &cosine);
    d.x = piece->distance * cosine;
    d.y = -piece->distance * sine;
    vmi_sincos(piece->contact, &sine, &cosine);
    v.x = before[VM_BROKEN_ROTOR_V];
    v.y = before[VM_BROKEN_ROTOR_V + 1];
    v = vmi_broken_rotor_turned(-sine, cosine, v);
    if (!(vmi_broken_rotor_contact(whole, piece, before[VM_BROKEN_ROTOR_OMEGA], d, v, &e, &b) > 0)) return VM_DOMAIN;

    d = vmi_broken_rotor_turned(sine, cosine, d);
    e = vmi_broken_rotor_turned(sine, cosine, e);
    share = piece->mass / b.rest.mass;
    T = b.tangential;
    psi = piece->contact - piece->alpha;
    vmi_broken_rotor_moved(before, psi, d.x, d.y, T * e.y, -T * e.x, b.spin_piece, b.piece);
    vmi_broken_rotor_moved(before, psi, -share * d.x, -share * d.y, -share * T * e.y, share * T * e.x, b.spin_rest,
                           b.state);
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, b.state) || !vmi_all_finite(VM_BROKEN_ROTOR_STATES, b.piece))
        return VM_NOT_FINITE;
    *result = b;
    return VM_OK;
}

#endif
/* mechanics/broken_rotor_motion.h - motion of the broken rotor in closed form

   This chapter computes the motion at any time without an integrator. Before the break the shaft passes through the
   mass centre, and the solution (46)-(51) is exact. After the break the linearised equations (69) hold for short times,
   while the angle psi of the remainder is small. vm_broken_rotor_linear solves them completely.
   vm_broken_rotor_linear_uncoupled has the solution (70)-(72) of the dissertation [1], which leaves out the term
   s p^2 omega^2 y. For long times integrate vm_broken_rotor_rhs.

       vm_broken_rotor whole = {2, 1, 20, 1, 3, 0};
       vm_real y[VM_BROKEN_ROTOR_STATES] = {VM_C(0.01), 0, 0, 0, 0, 3};
       int status = vm_broken_rotor_free_motion(&whole, 5, y, y); // y at 5 s

   The linearised equations are, with omega, p, k*, M*, s and psi as explained at vm_broken_rotor:
     x'' + omega^2 (x + s) = 0,  y'' + omega^2 (y + s psi) = 0,  psi'' + k* psi' = M* - s p^2 omega^2 y.
   Tests: tests/test_broken_rotor.c. */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_MOTION_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_MOTION_H

#include <string.h>

/* The coefficients (67) of the linearised equations */
typedef struct VM_TAG(vmi_broken_rotor_linear) {
    vm_real omega, k, torque, s; /* omega, k*, M* and s, as explained at vm_broken_rotor */
    vm_real coupling;            /* the factor s p^2 omega^2 of y in (69); 0 if this term is left out */
} vmi_broken_rotor_linear;

/* Indices in z, the array of the states that the linearised equations (69) couple: y, psi and their rates */
enum {
    VMI_BROKEN_ROTOR_Y = 0,
    VMI_BROKEN_ROTOR_PSI = 1,
    VMI_BROKEN_ROTOR_Y_RATE = 2,
    VMI_BROKEN_ROTOR_PSI_RATE = 3,
    VMI_BROKEN_ROTOR_COUPLED = 4 /* the number of coupled states */
};

VM_API vmi_broken_rotor_linear vmi_broken_rotor_reduced(const vm_broken_rotor *r, int coupled)
{
    vmi_broken_rotor_linear a;
    a.omega = VM_SQRT(r->stiffness / r->mass);
    a.k = r->damping / r->inertia;
    a.torque = r->torque / r->inertia;
    a.s = r->s;
    a.coupling = 0;
    if (coupled) a.coupling = r->s * (r->stiffness / r->inertia);
    return a;
}

/* An upper bound of the rates at which solutions of the linearised equations change, per second */
VM_API vm_real vmi_broken_rotor_rate(const vmi_broken_rotor_linear *a)
{
    return VM_FABS(a->k) + VM_C(1.5) * a->omega + VM_SQRT(VM_FABS(a->s * a->coupling));
}

/* Sets `change` to the change of the states z within the time h, by the Taylor series in h. The time must be short: |h|
   times the rate vmi_broken_rotor_rate is at most 1. Then the n-th terms of y and of s psi are at most 1/n! times the
   first terms, so that the number `terms` of terms is enough. y0, y1, y2 are three successive terms of y; psi0, psi1,
   psi2 are three successive terms of psi. */
VM_API void vmi_broken_rotor_series(const vmi_broken_rotor_linear *a, vm_real h, const vm_real *z, vm_real *change)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    const vm_real omega_h2 = (a->omega * h) * (a->omega * h), k_h = a->k * h, coupling_h2 = a->coupling * h * h;
    vm_real y0 = z[VMI_BROKEN_ROTOR_Y], y1 = z[VMI_BROKEN_ROTOR_Y_RATE] * h;
    vm_real psi0 = z[VMI_BROKEN_ROTOR_PSI], psi1 = z[VMI_BROKEN_ROTOR_PSI_RATE] * h;
    vm_real drive = a->torque * h * h;
    int n;
    change[VMI_BROKEN_ROTOR_Y] = y1;
    change[VMI_BROKEN_ROTOR_PSI] = psi1;
    change[VMI_BROKEN_ROTOR_Y_RATE] = 0;
    change[VMI_BROKEN_ROTOR_PSI_RATE] = 0;
    for (n = 2; n < terms && h != 0; n++) {
        const vm_real share = 1 / (vm_real)(n * (n - 1)), y2 = -omega_h2 * (y0 + a->s * psi0) * share;
        const vm_real psi2 = (drive - k_h * (vm_real)(n - 1) * psi1 - coupling_h2 * y0) * share;
        change[VMI_BROKEN_ROTOR_Y] += y2;
        change[VMI_BROKEN_ROTOR_PSI] += psi2;
        change[VMI_BROKEN_ROTOR_Y_RATE] += (vm_real)n * y2 / h;
        change[VMI_BROKEN_ROTOR_PSI_RATE] += (vm_real)n * psi2 / h;
        y0 = y1;
        psi0 = psi1;
        y1 = y2;
        psi1 = psi2;
        drive = 0;
    }
}

/* With the unit matrix E, the matrix m + E advances the states by some time. This function replaces m by the matrix for
   twice this time, which is (m + E)^2 - E = 2 m + m m. E is left out of m because digits of m would be lost in m + E.
   Row m[j] is the change that the states undergo if they start from the unit state j without torque. The last row is
   the change that the torque causes if the states start from 0. */
VM_API void vmi_broken_rotor_double(vm_real m[VMI_BROKEN_ROTOR_COUPLED + 1][VMI_BROKEN_ROTOR_COUPLED])
{
    vm_real old[VMI_BROKEN_ROTOR_COUPLED + 1][VMI_BROKEN_ROTOR_COUPLED];
    int i, j, k;
    memcpy(old, m, sizeof old);
    for (j = 0; j <= VMI_BROKEN_ROTOR_COUPLED; j++)
        for (i = 0; i < VMI_BROKEN_ROTOR_COUPLED; i++) {
            m[j][i] *= 2;
            for (k = 0; k < VMI_BROKEN_ROTOR_COUPLED; k++) m[j][i] += old[k][i] * old[j][k];
        }
}

/* Advances the states z by the time t, for any coefficients. The time is halved until the Taylor series converges fast.
   The series gives the matrix for this short time h, and every doubling of the time squares the matrix. */
VM_API void vmi_broken_rotor_advance(vm_real t, const vmi_broken_rotor_linear *a, vm_real *z)
{
    enum { n = VMI_BROKEN_ROTOR_COUPLED };
    vm_real m[n + 1][n], start[n], change[n], h = t;
    vmi_broken_rotor_linear driven = *a;
    int doublings = 0, i, j;
    for (; VM_FABS(h) * vmi_broken_rotor_rate(a) > 1; h /= 2) doublings++;
    if (doublings == 0) {
        vmi_broken_rotor_series(a, h, z, change);
        for (i = 0; i < n; i++) z[i] += change[i];
        return;
    }
    for (j = 0; j <= n; j++) {
        for (i = 0; i < n; i++) start[i] = i == j;
        driven.torque = 0;
        if (j == n) driven.torque = a->torque;
        vmi_broken_rotor_series(&driven, h, start, m[j]);
    }
    for (; doublings > 0; doublings--) vmi_broken_rotor_double(m);
    memcpy(start, z, sizeof start);
    for (i = 0; i < n; i++) {
        vm_real sum = m[n][i];
        for (j = 0; j < n; j++) sum += m[j][i] * start[j];
        z[i] += sum;
    }
}

/* The value (e^z - 1 - z)/z^2 from the given ratio = (e^z - 1)/z. For |z| <= 1 it is summed as a series, so that no
   digits cancel. */
VM_API vm_real vmi_broken_rotor_exp_rest(vm_real z, vm_real ratio)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    vm_real sum = 0;
    int n;
    if (VM_FABS(z) > 1) return (ratio - 1) / z;
    for (n = terms; n >= 2; n--) sum = (1 + z * sum) / (vm_real)n;
    return sum;
}

/* The value w - sin w from the given sine = sin w. For |w| <= 1 it is summed as a series, so that no digits cancel. */
VM_API vm_real vmi_broken_rotor_less_sine(vm_real w, vm_real sine)
{
    const int terms = VM_MANT_DIG > 24 ? 19 : 11;
    vm_real sum = 0;
    int n;
    if (VM_FABS(w) > 1) return w - sine;
    for (n = terms; n >= 3; n -= 2) sum = w * w * (1 - sum) / (vm_real)(n * (n - 1));
    return w * sum;
}

/* Functions of the time t that describe a free oscillation with the angular frequency w, which may be 0 */
typedef struct VM_TAG(vmi_broken_rotor_swing) {
    vm_real c;    /* cos(w t) */
    vm_real c1;   /* 1 - cos(w t) */
    vm_real w_s;  /* w sin(w t) */
    vm_real s_w;  /* sin(w t)/w */
    vm_real late; /* t - sin(w t)/w */
} vmi_broken_rotor_swing;

VM_API vmi_broken_rotor_swing vmi_broken_rotor_swing_at(vm_real t, vm_real w)
{
    vmi_broken_rotor_swing g;
    vm_real half, sine;
    vmi_sincos(w * t / 2, &half, &g.c);
    vmi_sincos(w * t, &sine, &g.c);
    g.c1 = 2 * half * half;
    g.w_s = w * sine;
    g.s_w = t;
    g.late = 0;
    if (w > 0) {
        g.s_w = sine / w;
        g.late = vmi_broken_rotor_less_sine(w * t, sine) / w;
    }
    return g;
}

/* Advances the states z by the time t by the solution (71), (72), without the coupling term s p^2 omega^2 y. Where the
   dissertation [1] has k* Omega, this function has M*. It is used if |t| times the rate vmi_broken_rotor_rate exceeds
   1. With w = omega and k = k*, psi = psi0 + psi0' E1 + M* E2, where E1 = (1 - e^(-kt))/k and E2 = (t - E1)/k. The
   motion of y is driven by -s psi. The functions g0, g1, g2 start from rest and solve g'' + w^2 g = F, where F is w^2
   E1' for g0, w^2 E1 for g1 and w^2 E2 for g2. Therefore g2' = g1 and g1' = g0. */
VM_API void vmi_broken_rotor_follow(vm_real t, const vmi_broken_rotor_linear *a, const vmi_broken_rotor_swing *g,
                                    vm_real *z)
{
    const vm_real w2 = a->omega * a->omega, sum = w2 + a->k * a->k;
    const vm_real y0 = z[VMI_BROKEN_ROTOR_Y], v0 = z[VMI_BROKEN_ROTOR_Y_RATE];
    const vm_real psi0 = z[VMI_BROKEN_ROTOR_PSI], rate0 = z[VMI_BROKEN_ROTOR_PSI_RATE];
    const vm_real exponent = -a->k * t, ratio = vmi_exp_ratio(exponent);
    const vm_real E0 = vmi_exp(exponent, 0), E1 = ratio * t, E2 = vmi_broken_rotor_exp_rest(exponent, ratio) * (t * t);
    vm_real g0, g1, g2;
    g0 = w2 * ((E0 - g->c) + a->k * g->s_w) / sum;
    g1 = (w2 * (E1 - g->s_w) + a->k * g->c1) / sum;
    g2 = (w2 * E2 + (a->k * g->late - g->c1)) / sum;
    z[VMI_BROKEN_ROTOR_Y] = y0 * g->c + v0 * g->s_w - a->s * (psi0 * g->c1 + (rate0 * g1 + a->torque * g2));
    z[VMI_BROKEN_ROTOR_PSI] = psi0 + (rate0 * E1 + a->torque * E2);
    z[VMI_BROKEN_ROTOR_Y_RATE] = v0 * g->c - y0 * g->w_s - a->s * (psi0 * g->w_s + (rate0 * g0 + a->torque * g1));
    z[VMI_BROKEN_ROTOR_PSI_RATE] = rate0 * E0 + a->torque * E1;
}

/* Checks the arguments of the three public functions for the motion below. Returns their status. */
VM_API int vmi_broken_rotor_check_motion(const vm_broken_rotor *rotor, vm_real t, const vm_real *start,
                                         const vm_real *end)
{
    if (!rotor || !start || !end) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_all_finite(VM_BROKEN_ROTOR_STATES, start)) return VM_NOT_FINITE;
    return vmi_check_broken_rotor(rotor);
}

/* Computes the results of the three public functions below. If coupled = 1, it solves all of the linearised equations
   (69). If coupled = 0, it leaves out their last term, -s p^2 omega^2 y. */
VM_API int vmi_broken_rotor_linearised(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, int coupled,
                                       vm_real *end)
{
    vm_real y[VM_BROKEN_ROTOR_STATES], z[VMI_BROKEN_ROTOR_COUPLED], x0, vx0;
    vmi_broken_rotor_linear a;
    vmi_broken_rotor_swing g;
    const int status = vmi_broken_rotor_check_motion(rotor, t, start, end);
    if (status) return status;
    a = vmi_broken_rotor_reduced(rotor, coupled);
    g = vmi_broken_rotor_swing_at(t, a.omega);
    z[VMI_BROKEN_ROTOR_Y] = start[VM_BROKEN_ROTOR_X + 1];
    z[VMI_BROKEN_ROTOR_PSI] = start[VM_BROKEN_ROTOR_ANGLE];
    z[VMI_BROKEN_ROTOR_Y_RATE] = start[VM_BROKEN_ROTOR_V + 1];
    z[VMI_BROKEN_ROTOR_PSI_RATE] = start[VM_BROKEN_ROTOR_OMEGA];
    if (coupled || VM_FABS(t) * vmi_broken_rotor_rate(&a) <= 1) vmi_broken_rotor_advance(t, &a, z);
    else vmi_broken_rotor_follow(t, &a, &g, z);
    x0 = start[VM_BROKEN_ROTOR_X];
    vx0 = start[VM_BROKEN_ROTOR_V];
    y[VM_BROKEN_ROTOR_X] = x0 * g.c + (vx0 * g.s_w - a.s * g.c1); /* the solution (70) */
    y[VM_BROKEN_ROTOR_V] = vx0 * g.c - g.w_s * (x0 + a.s);
    y[VM_BROKEN_ROTOR_X + 1] = z[VMI_BROKEN_ROTOR_Y];
    y[VM_BROKEN_ROTOR_ANGLE] = z[VMI_BROKEN_ROTOR_PSI];
    y[VM_BROKEN_ROTOR_V + 1] = z[VMI_BROKEN_ROTOR_Y_RATE];
    y[VM_BROKEN_ROTOR_OMEGA] = z[VMI_BROKEN_ROTOR_PSI_RATE];
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_STATES, y, end);
}

/* State of the remainder t seconds after start, by the complete linearised equations (69).
   The result holds for short times, while |psi| << 1. t may have any sign. The arrays start and end have
   VM_BROKEN_ROTOR_STATES numbers, and end may be start. The fields damping, stiffness and s may be 0. The error is at
   most twice the change that rounding every input, t included, would make. Solutions of (69) grow exponentially with t.
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE also if the result overflows, VM_BAD_MASS, VM_BAD_STIFFNESS
   for a negative stiffness, VM_BAD_INERTIA, and VM_OK otherwise. */
VM_API int vm_broken_rotor_linear(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(rotor, t, start, 1, end);
}

/* State of the remainder t seconds after start by (70)-(72), which lack a term of (69).
   The dissertation leaves out the term -s p^2 omega^2 y, although it is as large as the other terms. This function
   serves to compare the dissertation with vm_broken_rotor_linear. The error is at most the change that rounding every
   input would make. Arguments and statuses are those of vm_broken_rotor_linear. */
VM_API int vm_broken_rotor_linear_uncoupled(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(rotor, t, start, 0, end);
}

/* State of the unbroken rotor t seconds after start, exact, (46)-(51).
   t may have any sign. The arrays start and end have VM_BROKEN_ROTOR_STATES numbers, and end may be start. The fields
   damping and stiffness may be 0. The error is at most the change that rounding every input, t included, would make.
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS for a negative stiffness,
   VM_BAD_INERTIA, VM_DOMAIN if s is not 0, and VM_OK otherwise. */
VM_API int vm_broken_rotor_free_motion(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end)
{
    const int status = vmi_broken_rotor_check_motion(rotor, t, start, end);
    if (status) return status;
    if (rotor->s != 0) return VM_DOMAIN;
    return vmi_broken_rotor_linearised(rotor, t, start, 0, end); /* for s = 0 the linearised equations are exact (46) */
}

/* Constants A0, B0, C0, D0 (51) of the unbroken rotor's elliptic orbit, m: abcd is an array of 4 numbers. The orbit is
   x + i y = (A0 + i B0) exp(i w t) + (C0 + i D0) exp(-i w t) (50) with w^2 = stiffness/mass, which must not be 0. Its
   half axes are the sum and the absolute difference of |A0 + i B0| and |C0 + i D0|. The speed at the time t, which the
   dissertation prints wrongly after (52), is
     w sqrt(A0^2 + B0^2 + C0^2 + D0^2 - 2 (A0 C0 + B0 D0) cos 2 w t + 2 (B0 C0 - A0 D0) sin 2 w t)
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS if the stiffness is not
   positive, VM_BAD_INERTIA, and VM_OK otherwise. */
VM_API int vm_broken_rotor_orbit(const vm_broken_rotor *rotor, const vm_real *start, vm_real *abcd)
{
    vm_real w, x, y, vx, vy, c[4];
    int status;
    if (!rotor || !start || !abcd) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, start)) return VM_NOT_FINITE;
    status = vmi_check_broken_rotor(rotor);
    if (rotor->stiffness == 0 && (!status || status == VM_BAD_INERTIA)) status = VM_BAD_STIFFNESS;
    if (status) return status;
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    x = start[VM_BROKEN_ROTOR_X];
    y = start[VM_BROKEN_ROTOR_X + 1];
    vx = start[VM_BROKEN_ROTOR_V] / w;
    vy = start[VM_BROKEN_ROTOR_V + 1] / w;
    c[0] = (x + vy) / 2;
    c[1] = (y - vx) / 2;
    c[2] = (x - vy) / 2;
    c[3] = (y + vx) / 2;
    return vmi_copy_if_finite(4, c, abcd);
}

#endif
/* mechanics/broken_rotor_stability.h - steady motion of the broken rotor, its stability, growth at resonance

   After the break the remainder can turn steadily at the angular velocity psi' = Omega, with its mass centre on a
   circle (76), (77). This chapter computes
     - the radius of this circle,
     - the characteristic polynomial (81) of small motions about the steady motion, its roots, and Routh's first column,
     - the stability (82): the steady motion is stable only below resonance, where |Omega| < omega,
     - the radius of the orbit of a rotor that starts from rest at or above resonance; this orbit grows.
   The formulas write omega^2 = stiffness/mass, p^2 = mass/inertia, k* = damping/inertia.

       vm_broken_rotor rest = {2, 1, 20, 1, 3, VM_C(0.1)};       // 0.1 m from the shaft to the mass centre
       vm_real radius = vm_broken_rotor_steady_radius(&rest, 2); // m, at 2 rad/s
       int stable = vm_broken_rotor_is_stable(&rest, 2);

   Tests: tests/test_broken_rotor_stability.c. */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_STABILITY_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_STABILITY_H

#include <string.h>

/* The detuning from resonance, (omega^2 - Omega^2) mass, where omega^2 = stiffness/mass. It is computed as the sum of
   two numbers, so that its sign is right even if the rotor turns very close to resonance. */
VM_API vm_real vmi_broken_rotor_detuning(const vm_broken_rotor *r, vm_real Omega)
{
    const vm_two load = vmi_two_times(vmi_two_product(r->mass, Omega), vmi_two(-Omega, 0));
    const vm_two left = vmi_two_plus(vmi_two(r->stiffness, 0), load);
    return left.hi + left.lo;
}

/* Radius of the mass centre's circle in steady motion at psi' = Omega, m: s omega^2/(omega^2 - Omega^2), (76), (77).
   Omega is in rad/s, and the motion needs torque = damping Omega (47). For Omega^2 < omega^2 the radius is positive and
   the direction of the mass centre is phi = psi + pi, as in (77). For Omega^2 > omega^2 the radius is negative and
   phi = psi, as in (76). The relative error is within 3 eps, even very close to resonance. Returns infinity at
   resonance (NaN for s = 0), and NaN for a null pointer or for a rotor with a value that vm_broken_rotor does not
   allow. */
VM_API vm_real vm_broken_rotor_steady_radius(const vm_broken_rotor *rotor, vm_real Omega)
{
    vm_real detuning, share;
    if (!rotor || vmi_check_broken_rotor(rotor) || !VM_IS_FINITE(Omega)) return VM_NAN;
    detuning = vmi_broken_rotor_detuning(rotor, Omega);
    if (VM_IS_FINITE(detuning)) return rotor->s * (rotor->stiffness / detuning);
    share = rotor->stiffness / (rotor->mass * Omega) / Omega; /* omega^2/Omega^2; mass Omega^2 has overflowed */
    return -rotor->s * (share / (1 - share));
}

/* The quantities omega^2, Omega^2, k*, D and G in the polynomial of vm_broken_rotor_characteristic */
typedef struct VM_TAG(vmi_broken_rotor_steady) {
    vm_real w2, O2, k, D, G;
} vmi_broken_rotor_steady;

/* Sets *a for the steady motion at psi' = Omega. Returns VM_BAD_ARGUMENT, VM_NOT_FINITE, a status of
   vmi_check_broken_rotor, VM_DOMAIN at resonance, or VM_OK. */
VM_API int vmi_broken_rotor_about_steady(const vm_broken_rotor *r, vm_real Omega, vmi_broken_rotor_steady *a)
{
    int status;
    vm_real detuning;
    if (!r) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(Omega)) return VM_NOT_FINITE;
    status = vmi_check_broken_rotor(r);
    if (status) return status;
    detuning = vmi_broken_rotor_detuning(r, Omega);
    if (detuning == 0) return VM_DOMAIN;
    a->w2 = r->stiffness / r->mass;
    a->O2 = Omega * Omega;
    a->k = r->damping / r->inertia;
    a->D = detuning / r->mass;
    a->G = r->s * (r->stiffness / detuning) * (r->s * r->stiffness / r->inertia);
    return VM_OK;
}

enum { VM_BROKEN_ROTOR_ROOTS = 5 /* degree of the characteristic polynomial */ };

/* Characteristic polynomial of small motions about the steady motion, (81) corrected.
   Small motions about the steady motion at psi' = Omega (rad/s) are sums of exp(l t), where l is a root of the
   polynomial. c is an array of VM_BROKEN_ROTOR_ROOTS + 1 coefficients, highest power first:
     l^5 + k* l^4 + (2 (w^2 + O^2) + G) l^3 + 2 k* (w^2 + O^2) l^2 + (D^2 + G (w^2 + 3 O^2)) l + k* D^2,
   with w = omega, O = Omega, D = w^2 - O^2, G = s^2 p^2 w^4/D. Equation (81) is l times this polynomial, except that
   its last printed term lacks the factor l^2. The additional root l = 0 of (81) exists because the phase of the steady
   motion is arbitrary. Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS for a
   negative stiffness, VM_BAD_INERTIA, VM_DOMAIN at resonance, and VM_OK otherwise. */
VM_API int vm_broken_rotor_characteristic(const vm_broken_rotor *rotor, vm_real Omega, vm_real *c)
{
    vmi_broken_rotor_steady a;
    vm_real p[VM_BROKEN_ROTOR_ROOTS + 1];
    int status;
    if (!c) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_about_steady(rotor, Omega, &a);
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = 2 * (a.w2 + a.O2) + a.G;
    p[3] = 2 * a.k * (a.w2 + a.O2);
    p[4] = a.D * a.D + a.G * (a.w2 + 3 * a.O2);
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_ROOTS + 1, p, c);
}

/* First column of Routh's scheme of the characteristic polynomial: 1, k*, G, k* D, 4 G Omega^2, k* D^2. column is an
   array of VM_BROKEN_ROTOR_ROOTS + 1 numbers. The steady motion is asymptotically stable if all numbers of
   the column are positive. The letters k*, G, D and the statuses are those of vm_broken_rotor_characteristic. */
VM_API int vm_broken_rotor_routh(const vm_broken_rotor *rotor, vm_real Omega, vm_real *column)
{
    vmi_broken_rotor_steady a;
    vm_real p[VM_BROKEN_ROTOR_ROOTS + 1];
    int status;
    if (!column) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_about_steady(rotor, Omega, &a);
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = a.G;
    p[3] = a.k * a.D;
    p[4] = 4 * a.G * a.O2;
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_ROOTS + 1, p, column);
}

/* Whether the steady motion at psi' = Omega is asymptotically stable (82).
   Returns 1 if Omega^2 < omega^2, damping > 0, s != 0 and Omega != 0, which together are the condition for stability.
   Returns 0 otherwise, and also for a null pointer and an invalid rotor. (If damping, s or Omega is 0, some motions
   neither grow nor decay.) */
VM_API int vm_broken_rotor_is_stable(const vm_broken_rotor *rotor, vm_real Omega)
{
    if (!rotor || vmi_check_broken_rotor(rotor) || !VM_IS_FINITE(Omega)) return 0;
    return rotor->damping > 0 && rotor->s != 0 && Omega != 0 && vmi_broken_rotor_detuning(rotor, Omega) > 0;
}

/* Roots re + i im of the characteristic polynomial, 1/s.
   re and im are arrays of VM_BROKEN_ROTOR_ROOTS numbers. The roots are sorted by increasing |im|; of a conjugate pair,
   the root with im > 0 is first. The error of each root is at most twice the change that relative changes of all
   coefficients by eps would cause. This holds for the smallest root, too, which near resonance is many orders of
   magnitude smaller than the largest. The statuses are those of vm_broken_rotor_characteristic. */
VM_API int vm_broken_rotor_eigenvalues(const vm_broken_rotor *rotor, vm_real Omega, vm_real *re, vm_real *im)
{
    vmi_broken_rotor_steady a;
    vm_real c[VM_BROKEN_ROTOR_ROOTS + 1], x[VM_BROKEN_ROTOR_ROOTS], y[VM_BROKEN_ROTOR_ROOTS], size, power;
    int i, status;
    if (!re || !im) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_about_steady(rotor, Omega, &a);
    if (!status) status = vm_broken_rotor_characteristic(rotor, Omega, c);
    if (status) return status;
    /* The roots are computed in units of `size`, so that no coefficient is larger than 10. */
    size = VM_FABS(Omega) + VM_SQRT(a.w2) + VM_FABS(a.k) + VM_SQRT(VM_FABS(a.G));
    power = 1 / size;
    for (i = 1; i <= VM_BROKEN_ROTOR_ROOTS; i++) {
        c[i] *= power;
        power /= size;
    }
    if (!vmi_all_finite(VM_BROKEN_ROTOR_ROOTS + 1, c)) return VM_NOT_FINITE;
    vmi_poly_roots(VM_BROKEN_ROTOR_ROOTS, c, x, y);
    for (i = 0; i < VM_BROKEN_ROTOR_ROOTS; i++) {
        x[i] *= size;
        y[i] *= size;
    }
    if (!vmi_all_finite(VM_BROKEN_ROTOR_ROOTS, x)) return VM_NOT_FINITE;
    status = vmi_copy_if_finite(VM_BROKEN_ROTOR_ROOTS, y, im);
    if (!status) memcpy(re, x, sizeof x);
    return status;
}

/* The value ln(1 + x) - x + x^2/2 = x^3/3 - x^4/4 + ... for x >= 0. For x <= 1 the left form would lose digits, and
   the value is summed as a series in w = x/(2 + x) <= 1/3 with positive terms only: twice the sum over n >= 3 of
   c_n w^n, where c_n is n - 2 for even n and n - 2 + 1/n for odd n. */
VM_API vm_real vmi_broken_rotor_growth_time(vm_real x)
{
    const int terms = VM_MANT_DIG > 24 ? 45 : 21;
    const vm_real w = x / (2 + x);
    vm_real sum = 0;
    int n;
    if (x > 1) return (vmi_log(1 + x).hi - x) + x * x / 2;
    for (n = terms; n >= 3; n--) {
        vm_real coefficient = (vm_real)(n - 2);
        if (n & 1) coefficient += 1 / (vm_real)n;
        sum = w * sum + coefficient;
    }
    return 2 * w * w * w * sum;
}

/* The root x > 0 of ln(1 + x) - x + x^2/2 = tau. The left side is convex. Newton's method starts from
   x = (3 tau)^(1/3) + (2 tau)^(1/2), which is above the root. Therefore every step decreases x until x is the root. */
VM_API vm_real vmi_broken_rotor_growth_root(vm_real tau)
{
    const int most_steps = 60;
    vm_real x = vmi_pow_checked(3 * tau, VM_C(1.) / 3) + VM_SQRT(2 * tau), fall;
    int i;
    for (i = 0; i < most_steps; i++) {
        fall = (vmi_broken_rotor_growth_time(x) - tau) * (1 + x) / (x * x);
        if (!(fall > 0)) break;
        x -= fall;
    }
    return x;
}

/* Radius of the orbit that grows at or above resonance, t seconds after a start from rest, m.
   Omega = torque/damping (rad/s) must be at or above omega; vm_broken_rotor explains omega, p, k* and s. The angular
   velocity psi' stays at omega, and the surplus of the torque makes the orbit grow. The radius is r = |s|/4 + R, where
   R(0) = 0 and
     R R' = k* (Omega - omega)/(2 p^2 omega) + k* |s|/(4 p^2 R).
   It follows that
     R = (3 k* |s| t/(4 p^2))^(1/3) at resonance,  R -> (k* (Omega - omega) t/(p^2 omega))^(1/2) above it.
   |s|/4 is the second term of the expansion of r for large r/|s|. Terms of order s^2/r and the time until psi' reaches
   omega are neglected. The resulting error is small: for the rotor of Fig. 18 (s = 0.5 m, omega = 1 rad/s) after 400 s,
   this radius differs by less than 0.002 m from that of the integrated motion for Omega = 1, 1.01 and 1.1 rad/s.
   Returns NaN below resonance, for t < 0, damping < 0, omega = 0, a null pointer and an invalid rotor. The solution of
   R R' = A + B/R, with constants A and B, is t A^3/B^2 = ln(1 + x) - x + x^2/2 with x = A R/B. */
VM_API vm_real vm_broken_rotor_resonance_radius(const vm_broken_rotor *rotor, vm_real t, vm_real Omega)
{
    vm_real over, w, A, B, R, z;
    if (!rotor || vmi_check_broken_rotor(rotor) || !(t >= 0) || !VM_IS_FINITE(t) || !VM_IS_FINITE(Omega))
        return VM_NAN;
    over = -vmi_broken_rotor_detuning(rotor, Omega);
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    if (!(over >= 0) || !(w > 0) || !(rotor->damping >= 0)) return VM_NAN;
    A = rotor->damping * (over / rotor->mass / (VM_FABS(Omega) + w)) / (2 * rotor->mass * w);
    B = rotor->damping * VM_FABS(rotor->s) / (4 * rotor->mass);
    R = vmi_pow_checked(3 * B * t, VM_C(1.) / 3);
    if (A == 0 || t == 0) return VM_FABS(rotor->s) / 4 + R;
    z = A * R / B; /* A is negligible for z < eps, and B/R for z > 1/eps or B = 0 */
    if (!(z < 1 / VM_EPSILON)) R = VM_SQRT(2 * A * t);
    else if (z > VM_EPSILON) R = vmi_broken_rotor_growth_root(z * z * z / 3) * B / A;
    return VM_FABS(rotor->s) / 4 + R;
}

#endif
/* mechanics/generalized_force.h - generalized forces of forces and moments

   This chapter turns a force and a moment into generalized forces (235). Lagrange's equations (mechanics/lagrange.h)
   need them, and so do jumps (mechanics/lagrange_jump.h), where the "forces" are momenta and impulses.

       vm_vec3 weight = {0, 0, VM_C(-9.8)}, no_moment = {0, 0, 0};
       vm_vec3 dr[1] = {{0, 0, 1}}; // dr/dq_0 of the point at which the weight acts
       vm_real Q[1] = {0};
       vm_lagrange_add_force(1, weight, dr, no_moment, NULL, Q); // Q[0] is -9.8

   Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_GENERALIZED_FORCE_H
#define VARMASS_MECHANICS_GENERALIZED_FORCE_H

/* Add the generalized forces of a force and a moment: Q_i += force dr/dq_i + moment domega/dq'_i (235). dr_or_NULL[i]
   is dr/dq_i, the derivative of the point r at which the force acts with respect to the coordinate q_i.
   domega_or_NULL[i] is domega/dq'_i, the derivative of the body's angular velocity omega with respect to the rate q'_i.
   These arrays and Q have n entries. A NULL array means that its term is 0. If Q is NULL, nothing is done.

   External loads are given by their resultant and their moment about r. A stream with the mass rate M' is given by the
   force M' u at the point where the mass enters or leaves with the velocity u, and by the moment M' kappa omega2. kappa
   is the inertia of this mass per unit mass, and omega2 is its angular velocity. */
VM_API void vm_lagrange_add_force(int n, vm_vec3 force, const vm_vec3 *dr_or_NULL, vm_vec3 moment,
                                  const vm_vec3 *domega_or_NULL, vm_real *Q)
{
    int k;
    if (!Q) return;
    for (k = 0; k < n; k++) {
        vm_real sum = 0;
        if (dr_or_NULL) sum = vmi_dot(force, dr_or_NULL[k]);
        if (domega_or_NULL) sum += vmi_dot(moment, domega_or_NULL[k]);
        Q[k] += sum;
    }
}

#endif
/* mechanics/lagrange_jump.h - Lagrange's equations across a jump

   This chapter computes generalized velocities qdot after a part separates from a system or is attached to it in an
   instant (96), and after an impact. A mass matrix is an array of n n numbers, row after row. Velocities, momenta and
   impulses are arrays of n numbers. The matrices and momenta of rigid bodies are assembled from dr[i] = dv/dqdot_i and
   turn[i] = domega/dqdot_i, (87)-(90). Here v is the velocity of the mass centre and omega the angular velocity, both
   along inertial axes.

       vm_real before[4] = {3, 0, 0, 5}, after[4] = {2, 0, 0, 5}; // mass matrices, as vm_lagrange_mass makes them
       vm_real part[2] = {4, 0}, qdot[2] = {1, 1};                // the part's momenta, and the velocities
       vm_real work[VM_LAGRANGE_WORK(2)];
       int status = vm_lagrange_separate(2, before, after, qdot, part, NULL, qdot, work); // no impulse

   The velocities qdot_i need not be derivatives of coordinates. They may be spins about body axes (quasi-coordinates).
   Tests: tests/test_lagrange_jump.c. */
#ifndef VARMASS_MECHANICS_LAGRANGE_JUMP_H
#define VARMASS_MECHANICS_LAGRANGE_JUMP_H

#include <string.h>

/* Length of the array `work` for n coordinates */
#define VM_LAGRANGE_WORK(n) ((n) * ((n) + 2))

/* Add a body's share to the mass matrix of the kinetic energy T = qdot^T matrix qdot/2.
   dr and turn have n vectors: dr[i] = dv/dqdot_i, turn[i] = domega/dqdot_i, with the velocity v of the body's mass
   centre and its angular velocity omega. If dr or turn is NULL, its term is 0. If body or matrix is NULL, nothing is
   done. */
VM_API void vm_lagrange_mass(int n, const vm_body *body, const vm_vec3 *dr_or_NULL, const vm_vec3 *turn_or_NULL,
                             vm_real *matrix)
{
    int i, j;
    if (!body || !matrix) return;
    for (j = 0; j < n; j++) {
        vm_vec3 spin = vmi_vec3(0, 0, 0);
        if (turn_or_NULL) {
            vm_body moved = *body;
            moved.omega = turn_or_NULL[j];
            spin = vmi_spin_momentum(&moved);
        }
        for (i = 0; i < n; i++) {
            vm_real sum = 0;
            if (dr_or_NULL) sum = body->mass * vmi_dot(dr_or_NULL[i], dr_or_NULL[j]);
            if (turn_or_NULL) sum += vmi_dot(turn_or_NULL[i], spin);
            matrix[i * n + j] += sum;
        }
    }
}

/* Add to p the generalized momentum of a body's motion.
   p has n numbers. dr and turn are those of vm_lagrange_mass. If dr or turn is NULL, its term is 0. If body or p is
   NULL, nothing is done. */
VM_API void vm_lagrange_momentum(int n, const vm_body *body, const vm_vec3 *dr_or_NULL, const vm_vec3 *turn_or_NULL,
                                 vm_real *p)
{
    if (!body || !p) return;
    vm_lagrange_add_force(n, vm_momentum(body), dr_or_NULL, vmi_spin_momentum(body), turn_or_NULL, p);
}

/* Add to p the generalized impulse (95) of an impulse on a body with the mass centre r.
   r is in m, in inertial axes. The moment of the impulse is taken about r; (23a) does not say about which point. p has
   n numbers. dr and turn are those of vm_lagrange_mass. If dr or turn is NULL, its term is 0. If impulse or p is NULL,
   nothing is done. */
VM_API void vm_lagrange_impulse(int n, const vm_impulse *impulse, vm_vec3 r, const vm_vec3 *dr_or_NULL,
                                const vm_vec3 *turn_or_NULL, vm_real *p)
{
    if (!impulse || !p) return;
    const vm_vec3 moment = vmi_add(impulse->couple, vmi_cross(vmi_sub(impulse->at, r), impulse->linear));
    vm_lagrange_add_force(n, impulse->linear, dr_or_NULL, moment, turn_or_NULL, p);
}

/* Solves matrix*(qdot_after - qdot) = b. `work` has three parts: space for a copy of the matrix, then b, which the
   caller has set, then space for n more numbers. Returns VM_OK, VM_NOT_FINITE or VM_SINGULAR. */
VM_API int vmi_lagrange_jump_solve(int n, const vm_real *matrix, const vm_real *qdot, vm_real *qdot_after,
                                   vm_real *work)
{
    vm_real *a = work, *b = a + n * n, *scale = b + n;
    int i;
    if (!vmi_all_finite(n * n, matrix) || !vmi_all_finite(n, qdot) || !vmi_all_finite(n, b)) return VM_NOT_FINITE;
    memcpy(a, matrix, (size_t)(n * n) * sizeof *a);
    if (vmi_solve_mass(n, a, b, scale)) return VM_SINGULAR;
    for (i = 0; i < n; i++) b[i] += qdot[i];
    return vmi_copy_if_finite(n, b, qdot_after);
}

/* Solves after*(qdot_after - qdot) = (before - after)*qdot + sign*part + impulse, where `before` and `after` are mass
   matrices. The unknown is the change of qdot. A part of little mass changes qdot little, and the error is small
   compared with this change. */
VM_API int vmi_lagrange_jump(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                             const vm_real *part_or_NULL, vm_real sign, const vm_real *impulse_or_NULL,
                             vm_real *qdot_after, vm_real *work)
{
    int i, j;
    if (n <= 0 || !before || !after || !qdot || !qdot_after || !work) return VM_BAD_ARGUMENT;
    for (i = 0; i < n; i++) {
        vm_real sum = 0;
        if (part_or_NULL) sum = sign * part_or_NULL[i];
        for (j = 0; j < n; j++) sum += (before[i * n + j] - after[i * n + j]) * qdot[j];
        if (impulse_or_NULL) sum += impulse_or_NULL[i];
        work[n * n + i] = sum;
    }
    return vmi_lagrange_jump_solve(n, after, qdot, qdot_after, work);
}

/* Velocities after a part separates: after*qdot_after = before*qdot - part + impulse (96).
   (96) is d(T2 - T1)/dqdot = impulse, with the kinetic energies T1 before and T2 after the separation. The velocity of
   the part relative to the body is constant in the derivative. The term of the part is therefore its generalized
   momentum `part`. `before` and `after` are the mass matrices with and without the part. If part or impulse is NULL,
   its term is 0. qdot_after may be qdot. work has VM_LAGRANGE_WORK(n) numbers. A part of little mass changes qdot
   little, and this change keeps its relative accuracy. Returns VM_BAD_ARGUMENT for a null pointer and n <= 0,
   VM_NOT_FINITE, VM_SINGULAR if a coordinate, or several together, move no mass or a negative one, and VM_OK otherwise.
   The matrix counts as singular if an entry on the diagonal of `after` is not positive, or if a pivot is below 4 n eps
   after the diagonal has been scaled to 1. */
VM_API int vm_lagrange_separate(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                                const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                                vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, -1, impulse_or_NULL, qdot_after, work);
}

/* Velocities after a part is attached: after*qdot_after = before*qdot + part + impulse (96).
   `part` is the generalized momentum of the part before it is attached. The other arguments, the accuracy and the
   statuses are those of vm_lagrange_separate. */
VM_API int vm_lagrange_attach(int n, const vm_real *before, const vm_real *after, const vm_real *qdot,
                              const vm_real *part_or_NULL, const vm_real *impulse_or_NULL, vm_real *qdot_after,
                              vm_real *work)
{
    return vmi_lagrange_jump(n, before, after, qdot, part_or_NULL, 1, impulse_or_NULL, qdot_after, work);
}

/* Velocities after an impact that changes no mass: matrix*(qdot_after - qdot) = impulse.
   This function also computes a separation accurately if the part is nearly the whole body. Then `matrix` is the mass
   matrix of the rest, and `impulse` is minus the generalized momentum of the part's motion relative to the body. The
   array sizes, the statuses and `work` are those of vm_lagrange_separate, but impulse must not be NULL. */
VM_API int vm_lagrange_impact(int n, const vm_real *matrix, const vm_real *qdot, const vm_real *impulse,
                              vm_real *qdot_after, vm_real *work)
{
    if (!impulse) return VM_BAD_ARGUMENT;
    return vmi_lagrange_jump(n, matrix, matrix, qdot, NULL, 0, impulse, qdot_after, work);
}

#endif
/* mechanics/pendulum.h - a pendulum from which a part is cut

   This is the example (119)-(132), corrected as in docs/errata.md. A uniform rod of mass M and length L swings about
   its end O. A part at its free end, of length l and mass m = M l/L, is cut off. It leaves with a given velocity and
   angular velocity relative to the rod. The results are the motions, energies and momenta of the part and of the
   remaining rod, and the impulse of the pivot.

       vm_pendulum rod = {3, 1, VM_C(0.5), 2, VM_AXES_COS_SIN}; // 3 kg, 1 m, 0.5 rad, 2 rad/s
       vm_pendulum_cut cut;
       int status = vm_pendulum_separate(&rod, VM_C(0.25), 0, 0, 1, &cut); // 0.25 m leaves at 1 m/s along y

   Tests: tests/test_pendulum.c. */
#ifndef VARMASS_MECHANICS_PENDULUM_H
#define VARMASS_MECHANICS_PENDULUM_H

/* How the angle of a pendulum is measured */
enum {
    VM_AXES_COS_SIN = 0, /* the rod is along (cos, sin) of the angle, which is measured counterclockwise from x; the
                            formulas (122), (125), (132) need this choice */
    VM_AXES_SIN_COS = 1  /* the rod is along (sin, cos) of the angle (123), which is measured clockwise from y */
};

/* A uniform rod that swings about its end O, the origin */
typedef struct VM_TAG(vm_pendulum) {
    vm_real mass;   /* mass M > 0, kg */
    vm_real length; /* length L > 0, m */
    vm_real angle;  /* angle phi, rad */
    vm_real rate;   /* angular velocity phi', rad/s */
    int axes;       /* VM_AXES_COS_SIN or VM_AXES_SIN_COS */
} vm_pendulum;

/* The pendulum and the part after the cut. S1 and S2 are the mass centres of the remaining rod (the rest) and of the
   part. */
typedef struct VM_TAG(vm_pendulum_cut) {
    vm_pendulum rest; /* the remaining rod; rest.rate is its angular velocity phi1' after the cut (125) */
    vm_real mass;     /* mass m of the part, kg */
    vm_real x, y;     /* position of the part's mass centre S2 (123), m */
    vm_real vx, vy;   /* velocity of the part's mass centre S2 (121), m/s */
    vm_real rate;     /* angular velocity of the part: the rod's phi' before the cut plus Omega, rad/s */
    vm_real T1;       /* kinetic energy of the whole rod before the cut (119), J */
    vm_real T_S1;     /* kinetic energy of the remaining rod after the cut (124), J */
    vm_real T_S2;     /* kinetic energy of the part after the cut, J [(122) corrected] */
    vm_real L1;       /* angular momentum of the remaining rod about its end O after the cut (130), kg m^2/s */
    vm_real L2;       /* angular momentum of the part about the same point O, kg m^2/s [(128) corrected] */
    vm_real pivot_x;  /* impulse of the pivot on the remaining rod during the cut, along x, N s */
    vm_real pivot_y;  /* impulse of the pivot on the remaining rod during the cut, along y, N s */
} vm_pendulum_cut;

VM_API int vmi_check_pendulum(const vm_pendulum *p, vm_real part)
{
    if (p->axes != VM_AXES_COS_SIN && p->axes != VM_AXES_SIN_COS) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->length) || !VM_IS_FINITE(p->angle) || !VM_IS_FINITE(p->rate) ||
        !VM_IS_FINITE(part))
        return VM_NOT_FINITE;
    if (!(p->mass > 0)) return VM_BAD_MASS;
    if (!(part > 0 && part < p->length)) return VM_DOMAIN;
    return VM_OK;
}

/* Unit vectors of a pendulum: e points from O along the rod, f across the rod in the direction in which the angle
   grows. */
VM_API void vmi_pendulum_directions(const vm_pendulum *p, vm_real *ex, vm_real *ey, vm_real *fx, vm_real *fy)
{
    if (p->axes == VM_AXES_COS_SIN) {
        vmi_sincos(p->angle, ey, ex);
        *fx = -*ey;
        *fy = *ex;
    } else {
        vmi_sincos(p->angle, ex, ey);
        *fx = *ey;
        *fy = -*ex;
    }
}

VM_API int vmi_pendulum_cut_finite(const vm_pendulum_cut *c)
{
    return VM_IS_FINITE(c->rest.rate) && VM_IS_FINITE(c->vx) && VM_IS_FINITE(c->vy) && VM_IS_FINITE(c->T1) &&
           VM_IS_FINITE(c->L1) && VM_IS_FINITE(c->L2) && VM_IS_FINITE(c->T_S1) && VM_IS_FINITE(c->T_S2) &&
           VM_IS_FINITE(c->pivot_x) && VM_IS_FINITE(c->pivot_y);
}

/* Motion of a pendulum and of the part that is cut off from it, (119)-(132).
   `part` is the length l of the part (m), 0 < l < L. Omega (rad/s) is its angular velocity relative to the rod,
   positive in the direction in which the pendulum's angle phi grows. (ux, uy) (m/s) is the velocity of the part's mass
   centre (x, y) relative to the rod, along the axes x, y of the pendulum. The remaining rod then turns with
     phi1' = phi' - l/(L - l)^3 (l^2 Omega/4 + 3 s (x u_y - y u_x)),  s = 1 for VM_AXES_COS_SIN, else s = -1.
   This is (125), (132) corrected and simplified by hand, so that no digits cancel. Returns VM_BAD_ARGUMENT for a null
   pointer and for axes that do not exist, VM_NOT_FINITE, VM_BAD_MASS, VM_DOMAIN if l is not between 0 and L, and VM_OK
   otherwise. */
VM_API int vm_pendulum_separate(const vm_pendulum *pendulum, vm_real part, vm_real Omega, vm_real ux, vm_real uy,
                                vm_pendulum_cut *cut)
{
    vm_pendulum_cut c;
    vm_real ex, ey, fx, fy, rho, left, rest_mass, across, change;
    int status;
    if (!pendulum || !cut) return VM_BAD_ARGUMENT;
    status = vmi_check_pendulum(pendulum, part);
    if (!VM_IS_FINITE(Omega) || !VM_IS_FINITE(ux) || !VM_IS_FINITE(uy)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    vmi_pendulum_directions(pendulum, &ex, &ey, &fx, &fy);
    rho = pendulum->length - part / 2; /* distance from O to the part's mass centre S2 */
    left = pendulum->length - part;
    rest_mass = pendulum->mass * (left / pendulum->length);
    across = ux * fx + uy * fy; /* relative velocity across the rod; rho across is s (x u_y - y u_x) */
    change = -part * (part * part * Omega / 4 + 3 * rho * across) / (left * left * left);

    c.rest = *pendulum;
    c.rest.mass = rest_mass;
    c.rest.length = left;
    c.rest.rate = pendulum->rate + change;
    c.mass = pendulum->mass * (part / pendulum->length);
    c.x = rho * ex;
    c.y = rho * ey;
    c.vx = pendulum->rate * rho * fx + ux;
    c.vy = pendulum->rate * rho * fy + uy;
    c.rate = pendulum->rate + Omega;
    c.L1 = rest_mass * left * left * c.rest.rate / 3;
    c.L2 = c.mass * (part * part * c.rate / 12 + rho * (rho * pendulum->rate + across));
    c.T1 = pendulum->mass * pendulum->length * pendulum->length * pendulum->rate * pendulum->rate / 6;
    c.T_S1 = c.L1 * c.rest.rate / 2;
    c.T_S2 = c.mass * ((c.vx * c.vx + c.vy * c.vy) / 2 + part * part * c.rate * c.rate / 24);
    c.pivot_x = rest_mass * left / 2 * change * fx + c.mass * ux; /* change of the total momentum by the cut */
    c.pivot_y = rest_mass * left / 2 * change * fy + c.mass * uy;
    if (!vmi_pendulum_cut_finite(&c)) return VM_NOT_FINITE;
    *cut = c;
    return VM_OK;
}

#endif
/* mechanics/torque_free_axes.h - principal axes of a rotating body in two words, in the order of torque_free.h
   This is the first step of exact torque-free rotation. It finds the principal moments J_a >= J_b >= J_c, the
   principal axes a, b, c and the components w_a, w_b, w_c of omega. All are in two words, because the rates that
   follow from them are multiplied by long times.
   Then it names the axes 1, 2, 3. Axis 2 has the middle moment, and omega moves around axis 3. Axis 3 is a or c; this
   depends on the sign of
     2T J_b - L^2 = J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2,
   where T is the kinetic energy and L the size of the angular momentum. If this number is positive, or 0 (on the
   separatrix), axis 3 is c, the axis of the smallest moment; else axis 3 is a. All functions of this chapter are
   internal:

       vmi_torque_free_body b; // whole is a vm_body
       vmi_torque_free_axes axes;
       vmi_torque_free_principal(&whole.inertia, &b); // sets b.moment and b.axis; set b.omega, too
       axes = vmi_torque_free_order(&b);

   Tests: tests/test_torque_free.c. */
#ifndef VARMASS_MECHANICS_TORQUE_FREE_AXES_H
#define VARMASS_MECHANICS_TORQUE_FREE_AXES_H

#include <string.h>

/* ---- vectors in two words ---- */

typedef struct VM_TAG(vmi_vec3_two) {
    vm_two x[3];
} vmi_vec3_two;

/* The largest power of two that is at most x, or VM_MIN if x is 0 or subnormal */
VM_API vm_real vmi_power_of_two(vm_real x)
{
    const vmi_bits mantissa = ((vmi_bits)1 << VMI_STORED_DIG) - 1;
    return x < VM_MIN ? VM_MIN : vmi_from_bits(vmi_to_bits(x) & ~mantissa);
}

/* The vector a/power in two words, which is exact if power is a power of two */
VM_API vmi_vec3_two vmi_vec3_two_over(vm_vec3 a, vm_real power)
{
    vmi_vec3_two v;
    v.x[0] = vmi_two(a.x / power, 0);
    v.x[1] = vmi_two(a.y / power, 0);
    v.x[2] = vmi_two(a.z / power, 0);
    return v;
}

VM_API vm_vec3 vmi_vec3_two_high_words(const vmi_vec3_two *a) { return vmi_vec3(a->x[0].hi, a->x[1].hi, a->x[2].hi); }

VM_API vm_two vmi_vec3_two_dot(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    return vmi_two_plus(vmi_two_times(a->x[0], b->x[0]),
                        vmi_two_plus(vmi_two_times(a->x[1], b->x[1]), vmi_two_times(a->x[2], b->x[2])));
}

VM_API vmi_vec3_two vmi_vec3_two_cross(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    vmi_vec3_two c;
    int k;
    for (k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.x[k] = vmi_two_minus(vmi_two_times(a->x[i], b->x[j]), vmi_two_times(a->x[j], b->x[i]));
    }
    return c;
}

/* The vector that the rotation by q turns into a. It is a + 2 (v x (v x a) - w v x a)/|q|^2 for q = (w, v) of any
   length except 0. */
VM_API vmi_vec3_two vmi_vec3_two_turned_back(vm_quat q, const vmi_vec3_two *a)
{
    const vm_vec3 xyz = vmi_quat_vector(q);
    const vm_real longest = vmi_norm_max(xyz), size = VM_FABS(q.w);
    const vm_real power = vmi_power_of_two(longest > size ? longest : size);
    const vmi_vec3_two v = vmi_vec3_two_over(xyz, power);
    const vmi_vec3_two va = vmi_vec3_two_cross(&v, a), vva = vmi_vec3_two_cross(&v, &va);
    const vm_two w = vmi_two(q.w / power, 0);
    const vm_two square = vmi_two_plus(vmi_two_times(w, w), vmi_vec3_two_dot(&v, &v));
    const vm_two factor = vmi_two_over(vmi_two(2, 0), square);
    vmi_vec3_two result;
    int k;
    for (k = 0; k < 3; k++) {
        const vm_two change = vmi_two_minus(vva.x[k], vmi_two_times(w, va.x[k]));
        result.x[k] = vmi_two_plus(a->x[k], vmi_two_times(factor, change));
    }
    return result;
}

/* ---- principal moments and axes ---- */

/* The rotation of a body in its principal axes: the principal moments divided by a power of two, the principal axes
   in body axes, and the components of omega along them, divided by another power of two */
typedef struct VM_TAG(vmi_torque_free_body) {
    vm_two moment[3];
    vmi_vec3_two axis[3], omega;
} vmi_torque_free_body;

/* Turns the pair *x, *y by the angle with the cosine c and the sine s */
VM_API void vmi_two_turn(vm_two c, vm_two s, vm_two *x, vm_two *y)
{
    const vm_two x0 = *x, y0 = *y;
    *x = vmi_two_minus(vmi_two_times(c, x0), vmi_two_times(s, y0));
    *y = vmi_two_plus(vmi_two_times(s, x0), vmi_two_times(c, y0));
}

/* Makes one rotation of Jacobi's eigenvalue method in two words: turns the axes p and q so that a[p][q] becomes 0.
   The tensor a is scaled to about 1. An entry below eps^3 is set to 0 without a rotation. */
VM_API void vmi_torque_free_jacobi_rotation(vm_two a[3][3], vmi_vec3_two *axis, int p, int q)
{
    const vm_two one = vmi_two(1, 0), entry = a[p][q];
    const int other = 3 - p - q;
    vm_two theta, root, t, c, s, moved;
    int k;
    a[p][q] = a[q][p] = vmi_two(0, 0);
    if (VM_FABS(entry.hi) < VM_EPSILON * VM_EPSILON * VM_EPSILON) return;
    theta = vmi_two_over(vmi_two_minus(a[q][q], a[p][p]), vmi_two_shifted(entry, 2));
    root = vmi_two_root(vmi_two_plus(vmi_two_times(theta, theta), one));
    if (theta.hi < 0) root = vmi_minus(root);
    t = vmi_two_over(one, vmi_two_plus(theta, root));
    c = vmi_two_over(one, vmi_two_root(vmi_two_plus(vmi_two_times(t, t), one)));
    s = vmi_two_times(t, c);
    moved = vmi_two_times(t, entry);
    a[p][p] = vmi_two_minus(a[p][p], moved);
    a[q][q] = vmi_two_plus(a[q][q], moved);
    vmi_two_turn(c, s, &a[other][p], &a[other][q]);
    a[p][other] = a[other][p];
    a[q][other] = a[other][q];
    for (k = 0; k < 3; k++) vmi_two_turn(c, s, &axis[p].x[k], &axis[q].x[k]);
}

/* Computes the principal axes, and the principal moments divided by vmi_power_of_two(trace). Sets omega to 0. For a
   tensor without products of inertia the moments are its entries and the axes are the body axes, exactly. */
VM_API void vmi_torque_free_principal(const vm_inertia *i, vmi_torque_free_body *b)
{
    const int most_sweeps = 12; /* more than enough, since the rotations converge quadratically */
    const vm_real power = vmi_power_of_two(vmi_inertia_trace(i));
    vm_two a[3][3];
    int sweep, p, q, k;
    memset(b, 0, sizeof *b);
    memset(a, 0, sizeof a);
    a[0][0].hi = i->xx / power;
    a[1][1].hi = i->yy / power;
    a[2][2].hi = i->zz / power;
    a[0][1].hi = a[1][0].hi = i->xy / power;
    a[0][2].hi = a[2][0].hi = i->xz / power;
    a[1][2].hi = a[2][1].hi = i->yz / power;
    for (k = 0; k < 3; k++) b->axis[k].x[k].hi = 1;
    for (sweep = 0; sweep < most_sweeps; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q].hi != 0) vmi_torque_free_jacobi_rotation(a, b->axis, p, q);
    for (k = 0; k < 3; k++) b->moment[k] = a[k][k];
}

/* Sets a moment to 0 if it is lost in the rounding errors of the tensor i. The body is then a rod or a point, and the
   other two moments become equal. */
VM_API void vmi_torque_free_clamp_moments(const vm_inertia *i, vmi_torque_free_body *b)
{
    const vmi_mat3 same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const vm_inertia sizes = vmi_inertia_sizes(i, &same);
    const vm_real power = vmi_power_of_two(vmi_inertia_trace(i));
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 axis = vmi_vec3_two_high_words(&b->axis[k]);
        if (!vmi_moment_is_lost(b->moment[k].hi * power, axis, &sizes)) continue;
        b->moment[k] = vmi_two(0, 0);
        b->moment[(k + 1) % 3] = b->moment[(k + 2) % 3];
    }
}

/* ---- the order of the axes ---- */

/* Returns 1 if the difference of two moments is within the errors of their computation from a tensor in two words.
   Moments of a tensor without products of inertia are exactly equal or differ by more. */
VM_API int vmi_torque_free_are_equal(vm_two a, vm_two b)
{
    const vm_real few = 64 * VM_EPSILON * VM_EPSILON;
    return VM_FABS(vmi_two_minus(a, b).hi) <= few * (a.hi + b.hi);
}

/* A body in its axes 1, 2, 3, which are right-handed */
typedef struct VM_TAG(vmi_torque_free_axes) {
    vm_two I1, I2, I3;    /* the principal moments */
    vm_two d12, d23, d13; /* the differences |I1 - I2|, |I2 - I3|, |I1 - I3| of the moments */
    vm_two w1, w2, w3;    /* the components of omega along the axes */
    vm_two S;             /* |2T I2 - L^2| for the kinetic energy T and angular momentum L; 0 on the separatrix */
    vm_real sigma;        /* the sign of I1 - I3 */
    vm_real s;            /* the sign of w3 */
    int symmetric;        /* 1 if I1 = I2 */
    vmi_mat3 matrix;      /* columns: the axes 1, 2, 3 in body axes */
} vmi_torque_free_axes;

/* The product J d w^2 of a moment J, a difference d of moments and the square of a component w of omega. It is in
   three words, so that the difference of two such products is right even if they cancel. */
VM_API vmi_three vmi_torque_free_excess(vm_two J, vm_two d, vm_two w)
{
    const vmi_three J3 = vmi_three_words(J.hi, J.lo, 0), d3 = vmi_three_words(d.hi, d.lo, 0);
    const vmi_three w3 = vmi_three_words(w.hi, w.lo, 0);
    return vmi_three_times(vmi_three_times(J3, d3), vmi_three_times(w3, w3));
}

/* The value J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2 = 2T J_b - L^2, whose sign decides which axis is axis 3.
   The axes a, b, c are order[0], order[1], order[2], by falling moments. */
VM_API vmi_three vmi_torque_free_separation(const vm_two *J, const vm_two *w, const int *order)
{
    const int a = order[0], b = order[1], c = order[2];
    const vmi_three of_smallest = vmi_torque_free_excess(J[c], vmi_two_minus(J[b], J[c]), w[c]);
    return vmi_three_plus(of_smallest, vmi_torque_free_excess(J[a], vmi_two_minus(J[b], J[a]), w[a]));
}

/* Sets order[] to the indices of the axes by falling moments. Returns 1 if order[] is an even permutation of 0, 1, 2,
   else 0. */
VM_API int vmi_torque_free_sort(const vm_two *J, int *order)
{
    int k, even = 1;
    for (k = 0; k < 3; k++) order[k] = k;
    for (k = 0; k < 3; k++) { /* compare the first two, the last two, the first two */
        const int i = k == 1, first = order[i];
        if (!(vmi_two_minus(J[order[i + 1]], J[first]).hi > 0)) continue;
        order[i] = order[i + 1];
        order[i + 1] = first;
        even = !even;
    }
    return even;
}

/* Returns 1 if axis 3 is order[2], the axis of the smallest moment, and 0 if it is order[0], the axis of the largest.
   If two moments are equal, axis 3 is the axis of the third moment. */
VM_API int vmi_torque_free_is_about_smallest(const vm_two *J, const int *order, vmi_three separation)
{
    if (vmi_torque_free_are_equal(J[order[0]], J[order[1]])) return 1;
    if (vmi_torque_free_are_equal(J[order[1]], J[order[2]])) return 0;
    return separation.hi >= 0;
}

/* Expresses the body in its axes 1, 2, 3. Axis 3 is reversed if the axes would be left-handed. */
VM_API vmi_torque_free_axes vmi_torque_free_order(const vmi_torque_free_body *b)
{
    const vm_two *J = b->moment, *w = b->omega.x;
    int order[3], even = vmi_torque_free_sort(J, order), first, middle, last;
    const vmi_three separation = vmi_torque_free_separation(J, w, order);
    vm_real hand;
    vmi_torque_free_axes axes;
    axes.sigma = 1;
    if (!vmi_torque_free_is_about_smallest(J, order, separation)) {
        const int largest = order[0];
        order[0] = order[2];
        order[2] = largest;
        even = !even;
        axes.sigma = -1;
    }
    first = order[0];
    middle = order[1];
    last = order[2];
    hand = even ? 1 : -1;
    axes.S = vmi_two_shifted(vmi_two(separation.hi, separation.mid), separation.hi < 0 ? -1 : 1);
    axes.I1 = J[first];
    axes.I2 = J[middle];
    axes.I3 = J[last];
    axes.symmetric = vmi_torque_free_are_equal(axes.I1, axes.I2);
    if (axes.symmetric) axes.I2 = axes.I1;
    axes.w1 = w[first];
    axes.w2 = w[middle];
    axes.w3 = vmi_two_shifted(w[last], hand);
    axes.s = axes.w3.hi < 0 ? -1 : 1;
    axes.d12 = vmi_two_shifted(vmi_two_minus(axes.I1, axes.I2), axes.sigma);
    axes.d23 = vmi_two_shifted(vmi_two_minus(axes.I2, axes.I3), axes.sigma);
    axes.d13 = vmi_two_shifted(vmi_two_minus(axes.I1, axes.I3), axes.sigma);
    axes.matrix.x = vmi_vec3_two_high_words(&b->axis[first]);
    axes.matrix.y = vmi_vec3_two_high_words(&b->axis[middle]);
    axes.matrix.z = vmi_scale(hand, vmi_vec3_two_high_words(&b->axis[last]));
    return axes;
}

/* Returns 1 if omega stays constant: for a sphere or a point, a rotation about a principal axis, and a rotation about
   an axis in the equatorial plane of a symmetric body. */
VM_API int vmi_torque_free_is_constant(const vmi_torque_free_axes *axes)
{
    const int no1 = axes->w1.hi == 0, no2 = axes->w2.hi == 0, no3 = axes->w3.hi == 0;
    if (vmi_torque_free_are_equal(axes->I1, axes->I3)) return 1;
    return (no1 && no2) || (no1 && no3) || (no3 && (no2 || axes->symmetric));
}

#endif
/* mechanics/torque_free.h - exact rotation of a body on which no torque acts
   The rotation of a free body, for example after a jump, has a closed form: the angular velocity omega follows from
   the Jacobi functions sn, cn, dn of the time, and the attitude follows from one theta function and a rotation at a
   constant rate (Jacobi 1850). Nothing is integrated, so that an evaluation costs the same at any time and errors do
   not grow with time. The mass centre moves on a straight line.

       vm_torque_free motion;
       vm_body later; // body is a vm_body
       if (vm_torque_free_init(&motion, &body, 0) == VM_OK) vm_torque_free_at(&motion, 1e6, &later); // after 1e6 s

   The functions serve all bodies: triaxial, symmetric and spherical ones, and rods and points, whose spin about an
   axis without moment of inertia stays constant. They serve all rotations, also those about the axis of the middle
   moment, and those on the separatrix, which tend to a rotation about this axis. No threshold has to be chosen.
   Tests: tests/test_torque_free.c. */
#ifndef VARMASS_MECHANICS_TORQUE_FREE_H
#define VARMASS_MECHANICS_TORQUE_FREE_H

#include <string.h>

/* A motion prepared by vm_torque_free_init. It is plain data and may be copied. Its fields should only be read.
   Equations (A) and (B) stand in the next comment.

   Accuracy, for inputs taken as exact and up to 1e6 turns: the attitude is within 12 eps (rad) and omega within 8 eps
   |omega|, also close to the separatrix (1 - m from 1e-2 to 1e-27, with m the parameter of sn, cn, dn), for nearly
   equal moments and with products of inertia. An error of eps in an input changes the attitude by eps times the angle
   turned. Close to the separatrix it changes the attitude by more, because it changes the time of every flip of the
   body. For tensors with products of inertia the principal moments are known to two words only, which limits the
   accuracy after many turns close to the separatrix. Components of omega below 2^-505 (float 2^-57) times the largest
   are taken as 0. */
typedef struct VM_TAG(vm_torque_free) {
    vm_body body;                /* the body at the time t0 */
    vm_real t0;                  /* the time at which the body is as given, s */
    vmi_mat3 axes;               /* columns: the principal axes 1, 2, 3, right-handed, in body axes */
    vm_quat start;               /* rotation to inertial axes from axes whose axis 3 is along the angular momentum, or
                                    opposite to it if the component w3 of omega along axis 3 is negative */
    vm_real spin[3];             /* omega along the axes 1, 2, 3 is spin[0] cn, spin[1] sn, spin[2] dn, rad/s */
    vm_real lean[3];             /* the quaternion M of equation (B) below is (w, x, y, 0)/sqrt(2 w), with
                                    w = 1 + lean[2] dn, x = lean[1] sn, y = lean[0] cn */
    vm_two phase;                /* argument u of sn, cn, dn at t0, divided by 4K; u itself on the separatrix */
    vm_two phase_rate;           /* rate of the phase, per second */
    vm_two K;                    /* quarter period of sn as a function of u; 0 on the separatrix */
    vm_two turn_rate;            /* mean rate, turns/s, of s h in equation (B) below; s h is half the angle
                                    turned about the angular momentum */
    vm_real m1;                  /* 1 - m, with the parameter m of sn, cn, dn */
    vmi_theta_form far_form;     /* constants for sn, cn, dn at arguments far from 0 */
    vmi_doubled_theta theta;     /* theta function of (B) below; sigma arg theta is h minus its mean growth kappa t */
} vm_torque_free;

/* The solution. Let 1, 2, 3 be the principal axes, where axis 2 has the middle moment and omega moves around axis 3
   (torque_free_axes.h), I1, I2, I3 the moments, T the kinetic energy and L the size of the angular momentum. Let
   d12 = |I1 - I2|, d23 = |I2 - I3|, d13 = |I1 - I3|, sigma = sign(I1 - I3) and s = sign(w3). Then
   omega = (w1, w2, w3) along these axes is
     w1 = a1 cn u,  w2 = -sigma s a2 sn u,  w3 = s a3 dn u,  u = u0 + wp t,                                     (A)
     a1^2 = w1^2 + I2 d23/(I1 d13) w2^2,  a2^2 = a1^2 I1 d13/(I2 d23),  a3^2 = w3^2 + I2 d12/(I3 d13) w2^2,
     wp^2 = a3^2 d13 d23/(I1 I2),  m = I1 d12 a1^2/(I3 d23 a3^2),  1 - m = |2T I2 - L^2|/(I3 d23 a3^2),
   where w1, w2, w3 on the right-hand sides are the values at t0, and t is the time since t0. With the tensor of
   inertia J, so that L = |J omega|, the unit vector l = J omega/L and the unit vector e3 of axis 3 the attitude is
     q(t) = start (cos h + s e3 sin h) M,  h = kappa t + sigma arg theta(u),                                    (B)
     M = (1 + |l3|, s l2, -s l1, 0)/sqrt(2 (1 + |l3|)).
   M is the shortest rotation that takes l to s e3, kappa is a constant that an integral of the third kind gives, and
   theta is a theta function of u + i y with cd(y | 1 - m) = I3 a3/L. (B) was found by Jacobi; van Zon and Schofield,
   J. Comput. Phys. 225 (2007), give a theta series for 2h.

   The preparation computes in this order: the axes; the squares of the amplitudes, and m; kappa; the phase and the
   rates; the theta function; and `start`, which makes q(t0) the given attitude. It computes in two words, because the
   rates wp/(4K) and kappa are multiplied by long times. An evaluation at a given time has only the products of rates
   and time in two words. Moments and omega are divided by powers of two, so that they are about 1. */

/* ---- amplitudes and parameter ---- */

/* The squares of the amplitudes a1, a2, a3 of equation (A) above, of h1 = I1 a1, h3 = I3 a3 and of L, and the
   parameters m and m1 = 1 - m. The only subtraction in them is that of S = |2T I2 - L^2| (torque_free_axes.h), which is
   computed in three words. */
typedef struct VM_TAG(vmi_torque_free_squares) {
    vm_two a1, a2, a3, h1, h3, L, m1, m;
} vmi_torque_free_squares;

VM_API vmi_torque_free_squares vmi_torque_free_amplitudes(const vmi_torque_free_axes *axes)
{
    const vm_two ratio = vmi_two_over(vmi_two_times(axes->I2, axes->d23), vmi_two_times(axes->I1, axes->d13));
    const vm_two w2_square = vmi_two_times(axes->w2, axes->w2);
    vmi_torque_free_squares square;
    square.a1 = vmi_two_plus(vmi_two_times(axes->w1, axes->w1), vmi_two_times(ratio, w2_square));
    square.a2 = vmi_two_over(square.a1, ratio);
    square.a3 = vmi_two_times(axes->w3, axes->w3);
    square.m1 = vmi_two(1, 0);
    square.m = vmi_two(0, 0);
    if (!axes->symmetric) {
        const vm_two share = vmi_two_over(vmi_two_times(axes->I2, axes->d12), vmi_two_times(axes->I3, axes->d13));
        vm_two below;
        square.a3 = vmi_two_plus(square.a3, vmi_two_times(share, w2_square));
        below = vmi_two_times(vmi_two_times(axes->I3, axes->d23), square.a3);
        square.m1 = vmi_two_over(axes->S, below);
        square.m = vmi_two_over(vmi_two_times(vmi_two_times(axes->I1, axes->d12), square.a1), below);
    }
    square.h1 = vmi_two_times(vmi_two_times(axes->I1, axes->I1), square.a1);
    square.h3 = vmi_two_times(vmi_two_times(axes->I3, axes->I3), square.a3);
    square.L = vmi_two_plus(square.h1, square.h3);
    return square;
}

/* Stores m1 = 1 - m in the motion, with the parameter m of sn, cn, dn, and prepares these functions for it */
VM_API void vmi_torque_free_parameter(vm_torque_free *motion, vm_two m1)
{
    motion->m1 = m1.hi;
    vmi_far_prepare(&motion->far_form, m1.hi, m1.lo);
}

/* Sets the axes, and the amplitudes of omega and of the quaternion M in equation (B) above. `sign` is the sign of cn on
   the separatrix, and 1 elsewhere. */
VM_API void vmi_torque_free_sizes(vm_torque_free *motion, const vmi_torque_free_axes *axes,
                                  const vmi_torque_free_squares *square, vm_real sign)
{
    const vm_real L = VM_SQRT(square->L.hi);
    motion->axes = axes->matrix;
    motion->spin[0] = sign * VM_SQRT(square->a1.hi);
    motion->spin[1] = -axes->sigma * axes->s * sign * VM_SQRT(square->a2.hi);
    motion->spin[2] = axes->s * VM_SQRT(square->a3.hi);
    motion->lean[0] = -axes->s * axes->I1.hi * motion->spin[0] / L;
    motion->lean[1] = axes->s * axes->I2.hi * motion->spin[1] / L;
    motion->lean[2] = axes->s * axes->I3.hi * motion->spin[2] / L;
}

/* ---- rates and phase ---- */

VM_API vm_two vmi_torque_free_two_pi(void)
{
    const vmi_three half_pi = vmi_half_pi();
    return vmi_two(4 * half_pi.hi, 4 * half_pi.mid);
}

/* Returns 2 kappa for m < 1 and I1 != I2, by the complete elliptic integral of the third kind Pi = Pi(-N | m) with
   N = I3 d12/(I1 d23). Sets *mean to the arithmetic-geometric mean agm(1, k'), with k'^2 = 1 - m. The letters are those
   of equation (A) above, and c = I3 a3/L:
     2 kappa = L/I1 + L d13/(I1 I3) (1 - Pi/K + c mean/sqrt(1 + N))  if I1 > I3,
     2 kappa = L/I3 + L d13/(I1 I3) (    Pi/K - c mean/sqrt(1 + N))  if I1 < I3. */
VM_API vm_two vmi_torque_free_triaxial_rate(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square,
                                            vm_two *mean)
{
    const vm_two outer = vmi_two_times(axes->I2, axes->d13);
    const vm_two share = vmi_two_over(vmi_two_times(axes->I3, axes->d12), outer); /* N/(1 + N) */
    const vm_two below = vmi_two_over(vmi_two_times(axes->I1, axes->d23), outer); /* 1/(1 + N) */
    const vmi_third_kind third = vmi_third_kind_ladder(square->m1, share, below);
    const vm_two c_square = vmi_two_over(square->h3, square->L);
    const vm_two drift = vmi_two_times(vmi_two_root(vmi_two_times(c_square, below)), third.mean);
    vm_two bracket, first = axes->I3;
    if (axes->sigma > 0) {
        bracket = vmi_two_plus(third.rest, drift);
        first = axes->I1;
    } else bracket = vmi_two_minus(third.ratio, drift);
    bracket = vmi_two_times(vmi_two_over(axes->d13, vmi_two_times(axes->I1, axes->I3)), bracket);
    bracket = vmi_two_plus(bracket, vmi_two_over(vmi_two(1, 0), first));
    *mean = third.mean;
    return vmi_two_times(vmi_two_root(square->L), bracket);
}

/* Returns kappa, the mean rate of the angle h in equation (B) above. Sets *mean to agm(1, k') with k'^2 = 1 - m; it is
   0 on the separatrix. */
VM_API vm_two vmi_torque_free_kappa(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square,
                                    vm_two *mean)
{
    const vm_two L = vmi_two_root(square->L);
    vm_two twice;
    if (axes->symmetric) { /* I1 = I2: k' = 1 and 2 kappa = (L + |w3| (I1 - I3))/I1 */
        *mean = vmi_two(1, 0);
        twice = vmi_two_times(vmi_two_root(square->a3), vmi_two_minus(axes->I1, axes->I3));
        twice = vmi_two_over(vmi_two_plus(L, twice), axes->I1);
    } else if (square->m1.hi == 0) { /* the motion tends to the rotation about axis 2 */
        *mean = vmi_two(0, 0);
        twice = vmi_two_over(L, axes->I2);
    } else twice = vmi_torque_free_triaxial_rate(axes, square, mean);
    return vmi_two_shifted(twice, VM_C(0.5));
}

/* Computes the argument u of equation (A) above at t0 from sn^2 = (w2/a2)^2 and cn^2 = (w1/a1)^2. Returns u/(4K), or u
   on the separatrix, where mean = 0. On the separatrix u does not determine the sign of cn, and *sign is this sign;
   else *sign is 1. */
VM_API vm_two vmi_torque_free_phase(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square,
                                    vm_two mean, vm_real *sign)
{
    const vm_two sn_square = vmi_two_over(vmi_two_times(axes->w2, axes->w2), square->a2);
    const vm_two cn_square = vmi_two_over(vmi_two_times(axes->w1, axes->w1), square->a1);
    const vm_two dn_square = vmi_two_plus(cn_square, vmi_two_times(square->m1, sn_square));
    const vm_real forward = -axes->sigma * axes->s * axes->w2.hi < 0 ? -1 : 1; /* the sign of sn */
    vm_two F = vmi_two_times(vmi_two_root(sn_square), vmi_carlson_rf(cn_square, dn_square, vmi_two(1, 0)));
    *sign = 1;
    if (mean.hi > 0) {
        F = vmi_two_over(vmi_two_times(F, mean), vmi_torque_free_two_pi());
        if (axes->w1.hi < 0) F = vmi_two_minus(vmi_two(VM_C(0.5), 0), F); /* cn < 0: u/(4K) is 1/2 - F */
    } else if (axes->w1.hi < 0) *sign = -1;
    return vmi_two_shifted(F, forward * *sign);
}

/* Sets K and phase, and the rates phase_rate and turn_rate that belong to omega divided by a power of two. Returns the
   sign of cn on the separatrix, and 1 elsewhere. */
VM_API vm_real vmi_torque_free_rates(vm_torque_free *motion, const vmi_torque_free_axes *axes,
                                     const vmi_torque_free_squares *square)
{
    const vm_two two_pi = vmi_torque_free_two_pi();
    const vm_two above = vmi_two_times(square->a3, vmi_two_times(axes->d13, axes->d23));
    const vm_two wp = vmi_two_root(vmi_two_over(above, vmi_two_times(axes->I1, axes->I2)));
    vm_two mean;
    const vm_two kappa = vmi_torque_free_kappa(axes, square, &mean);
    vm_real sign;
    motion->turn_rate = vmi_two_over(vmi_two_shifted(kappa, axes->s), two_pi);
    motion->phase = vmi_torque_free_phase(axes, square, mean, &sign);
    motion->phase_rate = wp;
    if (mean.hi > 0) { /* 4K = 2 pi/mean */
        motion->phase_rate = vmi_two_over(vmi_two_times(wp, mean), two_pi);
        motion->K = vmi_two_over(vmi_two_shifted(two_pi, VM_C(0.25)), mean);
    }
    return sign;
}

/* ---- the theta function ---- */

/* Returns y, the constant imaginary part of the argument u + i y of the theta function in equation (B) above. y solves
   cd(y | m1) = c with c = I3 a3/L. With N = I3 d12/(I1 d23) it is y = R_F(N, N/c^2, N + 1), where R_F is Carlson's
   elliptic integral of the first kind. */
VM_API vm_real vmi_torque_free_imaginary(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square)
{
    const vm_two N = vmi_two_over(vmi_two_times(axes->I3, axes->d12), vmi_two_times(axes->I1, axes->d23));
    const vm_two c_square = vmi_two_over(square->h3, square->L);
    return vmi_carlson_rf(N, vmi_two_over(N, c_square), vmi_two_plus(N, vmi_two(1, 0))).hi;
}

/* Sets the theta function of equation (B) above, conjugated if sigma s < 0. For m = 0 it stays 1. K and K' (Kc in the
   code) are the quarter periods for the parameters m and 1 - m. The function is summed directly for K <= 2K', and by
   Jacobi's transformation for K > 2K'. */
VM_API void vmi_torque_free_theta(vm_torque_free *motion, const vmi_torque_free_axes *axes,
                                  const vmi_torque_free_squares *square)
{
    const vm_real sign = axes->sigma * axes->s;
    vm_real K = VM_INFINITY, Kc = VM_PI / 2, y;
    int k;
    if (square->m.hi == 0) return;
    if (motion->K.hi > 0) {
        K = motion->K.hi;
        Kc = jacobi_K_m1(square->m.hi);
    }
    y = vmi_torque_free_imaginary(axes, square);
    motion->theta = K > 2 * Kc ? vmi_doubled_dual(K, Kc, y) : vmi_doubled_direct(K, Kc, y);
    motion->theta.shift *= sign;
    for (k = 0; k < 4; k++) motion->theta.im[k] *= sign;
}

/* ---- the motion as a whole ---- */

/* Sets a motion with constant omega: axis 3 is along omega, and sn stays 0 */
VM_API void vmi_torque_free_constant(vm_torque_free *motion, const vmi_torque_free_body *b)
{
    const vm_two size = vmi_two_root(vmi_vec3_two_dot(&b->omega, &b->omega));
    int k;
    if (size.hi == 0) return;
    for (k = 0; k < 3; k++) {
        const vm_real cosine = vmi_two_over(b->omega.x[k], size).hi;
        motion->axes.z = vmi_add(motion->axes.z, vmi_scale(cosine, vmi_vec3_two_high_words(&b->axis[k])));
    }
    motion->spin[2] = size.hi;
    motion->turn_rate = vmi_two_over(vmi_two_shifted(size, VM_C(0.5)), vmi_torque_free_two_pi());
}

/* Sets all fields except body, t0 and `start`. spin and the rates belong to omega divided by a power of two. */
VM_API void vmi_torque_free_prepare(vm_torque_free *motion, const vmi_torque_free_body *b)
{
    const vm_real least_nutation = vmi_fourth_power(VM_EPSILON); /* the square of eps^2, a negligible nutation angle */
    const vmi_torque_free_axes axes = vmi_torque_free_order(b);
    vmi_torque_free_squares square;
    int constant = vmi_torque_free_is_constant(&axes);
    if (!constant) {
        square = vmi_torque_free_amplitudes(&axes);
        constant = square.h1.hi <= least_nutation * square.h3.hi;
    }
    if (constant) {
        vmi_torque_free_constant(motion, b);
        return;
    }
    vmi_torque_free_sizes(motion, &axes, &square, vmi_torque_free_rates(motion, &axes, &square));
    vmi_torque_free_theta(motion, &axes, &square);
    vmi_torque_free_parameter(motion, square.m1);
}

/* ---- at a time ---- */

/* The product rate t, in turns, minus the nearest whole number of turns, |result| <= 1. Beyond 2^(2p - 4) turns the
   result has no meaning; p is the number of binary digits of the type. */
VM_API vm_two vmi_torque_free_fraction(vm_two rate, vm_two t)
{
    const vm_two p = vmi_two_product(rate.hi, t.hi);
    vm_real low = p.lo + (rate.lo * t.hi + rate.hi * t.lo);
    if (VM_FABS(low) > VM_C(0.5)) low -= VM_FLOOR(low + VM_C(0.5));
    return vmi_two_sum(p.hi - VM_FLOOR(p.hi + VM_C(0.5)), low);
}

/* Computes sn, cn, dn at the time t after t0. Returns u/(4K), with their argument u, minus the nearest multiple of 1/2;
   or u on the separatrix. */
VM_API vm_real vmi_torque_free_functions(const vm_torque_free *motion, vm_two t, vm_real *sn, vm_real *cn,
                                         vm_real *dn)
{
    const vm_real longest = VM_MANT_DIG > 24 ? 700 : 80; /* sech(longest) is close to the smallest number of the type */
    vmi_thetas theta;
    vm_real turns;
    int half_turns = 0, quarters = 0;
    vm_two v; /* argument u of sn, cn, dn, minus the nearest multiple of K */
    if (motion->K.hi > 0) {
        v = vmi_two_plus(vmi_torque_free_fraction(motion->phase_rate, t), motion->phase);
        half_turns = vmi_nearest(2 * v.hi);
        v = vmi_two_sum(v.hi - (vm_real)half_turns / 2, v.lo);
        turns = v.hi;
        quarters = vmi_nearest(4 * turns);
        v = vmi_two_times(vmi_two_sum(4 * turns - (vm_real)quarters, 4 * v.lo), motion->K);
    } else {
        v = vmi_two_plus(vmi_two_times(motion->phase_rate, t), motion->phase);
        if (VM_FABS(v.hi) > longest) v = vmi_two(VM_COPYSIGN(longest, v.hi), 0);
        turns = v.hi;
    }
    if (v.hi * v.hi > VMI_NEAR) theta = vmi_theta_far(&motion->far_form, 0, v);
    else theta = vmi_theta_near(v.hi, motion->m1); /* NaN comes here, too */
    theta = vmi_theta_shift(theta, motion->far_form.kp, (vmi_bits)((quarters + 2 * half_turns) & 3));
    vmi_theta_ratios(theta, motion->far_form.kp, sn, cn, dn);
    return turns;
}

/* Evaluates equations (A) and (B) above at the time t after t0: *omega in body axes, and the rotation *turn = (cos h +
   s e3 sin h) M */
VM_API void vmi_torque_free_at(const vm_torque_free *motion, vm_two t, vm_vec3 *omega, vm_quat *turn)
{
    vm_real sn, cn, dn, re, im, sine, cosine, w, x, y, over, c, s;
    const vm_real turns = vmi_torque_free_functions(motion, t, &sn, &cn, &dn);
    vmi_doubled_at(&motion->theta, turns, &re, &im);
    vmi_sincos_turns(vmi_torque_free_fraction(motion->turn_rate, t).hi + motion->theta.shift * turns, &sine, &cosine);
    w = 1 + motion->lean[2] * dn; /* the quaternion M of (B) is (w, x, y, 0)/sqrt(2 w) */
    x = motion->lean[1] * sn;
    y = motion->lean[0] * cn;
    over = 1 / VM_SQRT(2 * w * (re * re + im * im));
    c = over * (cosine * re - sine * im); /* cos h and sin h, divided by sqrt(2 w) */
    s = over * (sine * re + cosine * im);
    *turn = vmi_quat(c * w, vmi_times(&motion->axes, vmi_vec3(c * x - s * y, c * y + s * x, s * w)));
    *omega = vmi_times(&motion->axes, vmi_vec3(motion->spin[0] * cn, motion->spin[1] * sn, motion->spin[2] * dn));
}

/* ---- setting up ---- */

/* Prepares all that vm_torque_free_at needs. *b has the moments, the axes, and omega divided by `power`, a power of
   two. */
VM_API void vmi_torque_free_solve(vm_torque_free *motion, const vmi_torque_free_body *b, vm_real power)
{
    vm_quat q = motion->body.q, turn;
    vm_vec3 omega;
    int k;
    vmi_torque_free_parameter(motion, vmi_two(1, 0)); /* m = 0 and u = 0: sn = 0, cn = dn = 1 */
    motion->theta.re[0] = 1;
    motion->lean[2] = 1;
    vmi_torque_free_prepare(motion, b);
    if (vmi_quat_is_none(q)) q.w = 1;
    vmi_torque_free_at(motion, vmi_two(0, 0), &omega, &turn);
    turn = vmi_quat(turn.w, vmi_scale(-1, vmi_quat_vector(turn)));
    motion->start = vmi_quat_times(q, turn);
    for (k = 0; k < 3; k++) motion->spin[k] *= power;
    motion->phase_rate = vmi_two_shifted(motion->phase_rate, power);
    motion->turn_rate = vmi_two_shifted(motion->turn_rate, power);
}

/* Returns x, a component of the scaled omega, or 0 if its square would underflow, which is for |x| < 2^-505 (float
   2^-57). */
VM_API vm_two vmi_torque_free_squarable(vm_two x)
{
    return VM_FABS(x.hi) < 64 * VM_SQRT(VM_MIN) ? vmi_two(0, 0) : x;
}

/* Prepares the motion of a body whose omega is given in body axes (along_body = 1) or in inertial axes
   (along_body = 0) */
VM_API int vmi_torque_free_start(vm_torque_free *motion, const vm_body *body, int along_body, vm_real t0)
{
    const vm_real power = vmi_power_of_two(vmi_norm_max(body->omega));
    vm_torque_free m;
    vmi_torque_free_body b;
    vmi_vec3_two omega;
    int status, k;
    if (!VM_IS_FINITE(t0)) return VM_NOT_FINITE;
    status = vmi_check_body(body);
    if (status) return status;
    memset(&m, 0, sizeof m);
    m.body = *body;
    m.t0 = t0;
    omega = vmi_vec3_two_over(body->omega, power);
    if (!along_body && vmi_norm_max(vmi_quat_vector(body->q)) > 0) omega = vmi_vec3_two_turned_back(body->q, &omega);
    vmi_torque_free_principal(&body->inertia, &b);
    vmi_torque_free_clamp_moments(&body->inertia, &b);
    for (k = 0; k < 3; k++) b.omega.x[k] = vmi_torque_free_squarable(vmi_vec3_two_dot(&b.axis[k], &omega));
    vmi_torque_free_solve(&m, &b, power);
    *motion = m;
    return VM_OK;
}

/* Preparation of the exact torque-free motion of a body. At the time t0 (s) the body is as given; vm_torque_free_at
   then gives it at any time. The accuracy is described at vm_torque_free. Returns VM_OK, or VM_BAD_ARGUMENT for a
   null pointer, VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA. After an error *motion is unchanged. */
VM_API int vm_torque_free_init(vm_torque_free *motion, const vm_body *body, vm_real t0)
{
    if (!motion || !body) return VM_BAD_ARGUMENT;
    return vmi_torque_free_start(motion, body, 0, t0);
}

/* Preparation of the exact torque-free motion from principal moments (kg m^2). The body's axes are the principal
   axes, and omega (rad/s) is along them, not along the inertial axes. q is the attitude at t0 (s). The body has mass
   1 and rests at the origin. The statuses are those of vm_torque_free_init. */
VM_API int vm_torque_free_init_principal(vm_torque_free *motion, vm_vec3 moments, vm_quat q, vm_vec3 omega,
                                         vm_real t0)
{
    vm_body body;
    if (!motion) return VM_BAD_ARGUMENT;
    memset(&body, 0, sizeof body);
    body.mass = 1;
    body.inertia.xx = moments.x;
    body.inertia.yy = moments.y;
    body.inertia.zz = moments.z;
    body.q = q;
    body.omega = omega;
    return vmi_torque_free_start(motion, &body, 1, t0);
}

/* Attitude and angular velocity of a torque-free body at the time t (s). t may be later or earlier than t0. *omega is
   along body axes, rad/s. q is continuous in t and keeps the length that it had at t0 (1 if it was all zero). Returns
   VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE if t or the result is not finite or if t or the number of turns
   is above 1e290 (float 1e30), and VM_OK otherwise. After an error *q and *omega are unchanged. Beyond 1/eps^2 turns
   the result is finite and has the right angular momentum, but its phase has no meaning. */
VM_API int vm_torque_free_attitude(const vm_torque_free *motion, vm_real t, vm_quat *q, vm_vec3 *omega)
{
    const vm_real largest_factor = VM_MAX / VM_SPLIT; /* products in two words split their factors */
    vm_two elapsed;
    vm_real reach;
    vm_vec3 w;
    vm_quat turn;
    if (!motion || !q || !omega) return VM_BAD_ARGUMENT;
    elapsed = vmi_two_sum(t, -motion->t0);
    reach = VM_FABS(motion->phase_rate.hi) + VM_FABS(motion->turn_rate.hi);
    if (!((1 + reach) * (1 + VM_FABS(elapsed.hi)) < largest_factor)) return VM_NOT_FINITE;
    vmi_torque_free_at(motion, elapsed, &w, &turn);
    turn = vmi_quat_times(motion->start, turn);
    if (!vmi_vec3_is_finite(w) || !vmi_quat_is_finite(turn)) return VM_NOT_FINITE;
    *q = turn;
    *omega = w;
    return VM_OK;
}

/* A torque-free body at the time t (s). t may be later or earlier than t0. Attitude and omega are those of
   vm_torque_free_attitude, but omega is along inertial axes. The mass centre is on its straight line. The statuses
   are those of vm_torque_free_attitude; after an error *body is unchanged. */
VM_API int vm_torque_free_at(const vm_torque_free *motion, vm_real t, vm_body *body)
{
    vm_body b;
    vmi_mat3 turn;
    int status;
    if (!motion || !body) return VM_BAD_ARGUMENT;
    b = motion->body;
    status = vm_torque_free_attitude(motion, t, &b.q, &b.omega);
    if (status) return status;
    turn = vmi_rotation(b.q);
    b.omega = vmi_times(&turn, b.omega);
    b.r = vmi_add(b.r, vmi_scale(t - motion->t0, b.v));
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* A torque-free body a time t (s) later, in one call. It calls vm_torque_free_init, then vm_torque_free_at, and has
   their statuses. The pointers later and body may be equal. */
VM_API int vm_torque_free_rotation(const vm_body *body, vm_real t, vm_body *later)
{
    vm_torque_free motion;
    int status;
    if (!body || !later) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vm_torque_free_init(&motion, body, 0);
    return status ? status : vm_torque_free_at(&motion, t, later);
}

#endif
/* mechanics/streams.h - streams of mass: reactive force, moment and torque

   A stream carries mass into a body, or out of it, at one point. The mass brings or takes momentum and angular
   momentum with it, which causes the reactive force (156), the reactive moment (158) and the reactive torque (157).
   This chapter computes these loads at an instant and the accelerations that follow from them, (159) and (160). To
   integrate a motion, use mechanics/flow.h (space), flow2.h (plane) or flow1.h (line, axle).

       vm_vec3 centre = {0, 0, 0}; // the mass centre is the reference point
       vm_stream nozzle;
       vm_reactive loads;
       memset(&nozzle, 0, sizeof nozzle);
       nozzle.rate = -2;          // 2 kg/s leave
       nozzle.velocity.x = -2500; // m/s, relative to the body: VM_RELATIVE is 0
       if (vm_reactive_loads(&body, centre, 1, &nozzle, &loads) == VM_OK) printf("%g N\n", loads.force.x); // 5000 N

   Tests: tests/test_streams.c. */
#ifndef VARMASS_MECHANICS_STREAMS_H
#define VARMASS_MECHANICS_STREAMS_H

/* How the velocity and the spin of a stream's mass are given. "The point" is the point of the body's surface at which
   the mass enters or leaves. */
enum {
    VM_RELATIVE = 0, /* velocity relative to the point, spin relative to the body, both in body axes */
    VM_ABSOLUTE = 1, /* absolute velocity and spin, in inertial axes */
    VM_CARRIED = 2,  /* the mass has the velocity of the point and the spin of the body; velocity and spin of the stream
                        are not read. There is no torque, but a force M' omega x d remains, which (166) neglects (M' is
                        the rate, d leads from the mass centre to the point, omega is the body's spin) */
    VM_AT_REST = 3   /* the mass is at rest (167)-(169); velocity and spin of the stream are not read */
};

/* A store inside a body, from which a stream takes its mass or into which it puts its mass. It is needed if the mass
   does not lie at the point at which the stream enters or leaves the body. */
typedef struct VM_TAG(vm_store) {
    vm_vec3 at;          /* position from the body's reference point, m, body axes */
    vm_inertia gyration; /* inertia per unit mass of the stored mass, about its own mass centre, m^2, body axes */
} vm_store;

/* A stream of mass in space. Every field may be zero. */
typedef struct VM_TAG(vm_stream) {
    vm_real rate;         /* mass per time, kg/s; > 0: mass joins the body, < 0: mass leaves it */
    int motion;           /* how velocity and spin are given: VM_RELATIVE, VM_ABSOLUTE, VM_CARRIED, VM_AT_REST */
    vm_vec3 at;           /* point at which the mass enters or leaves, from the body's reference point, m, body axes */
    vm_vec3 velocity;     /* velocity of the mass as it enters or leaves the body, m/s */
    vm_vec3 spin;         /* angular velocity of the mass as it enters or leaves the body, rad/s */
    vm_inertia gyration;  /* inertia per unit mass of this mass, about its own mass centre, m^2, body axes */
    const vm_store *from; /* the store that the mass comes from or goes to, or NULL for none. Between the store and the
                             point `at` the mass flows in a straight line, and the body's momentum includes that of this
                             flow */
} vm_stream;

/* The reactive loads at an instant, in inertial axes except inertia_rate. The body has the mass M, the inertia I, the
   velocity v and the angular velocity omega. For each stream M' is the rate, u the velocity of its mass, omega2 the
   angular velocity of its mass and kappa its gyration. The vector d leads from the body's mass centre to the point at
   which the mass enters or leaves, and P(d) = |d|^2 E - d d^T with the unit matrix E:
     force   sum M' (u - v)                             (156)
     moment  sum d x M' (u - v)                         (158)
     torque  sum M' kappa omega2 - I' omega             (157) corrected: [1] prints I' (omega2 - omega), which is right
                                                        only for P(d) omega2 = 0
     drift   sum (M'/M) d:  dr/dt = v + drift           not in [1]
     inertia_rate  I' = sum M' (kappa + P(d)), body axes
   The equations of motion are M v' = F + force (159) and I omega' + omega x I omega = M_S + moment + torque (160),
   with the outer force F and the outer moment M_S about the mass centre. v is momentum/mass, and v' is its rate. */
typedef struct VM_TAG(vm_reactive) {
    vm_vec3 force;           /* reactive force, N */
    vm_vec3 moment;          /* reactive moment about the mass centre, N m */
    vm_vec3 torque;          /* reactive torque, N m */
    vm_vec3 drift;           /* velocity of the mass centre relative to the body's material, m/s */
    vm_real mass_rate;       /* rate of the body's mass, the sum of M' over all streams, kg/s */
    vm_inertia inertia_rate; /* rate of the body's inertia, kg m^2/s, body axes */
} vm_reactive;

VM_INLINE int vmi_stream_motion_is_known(int motion) { return motion >= VM_RELATIVE && motion <= VM_AT_REST; }

/* The velocity u of a stream's mass is, for every known motion, the sum of two terms: the velocity of the body's
   point (or zero) and the velocity that the stream gives (or zero). Its spin is a sum of two such terms, too. The
   next two functions tell which terms are not zero. No other function decodes VM_RELATIVE ... VM_AT_REST. */
VM_INLINE int vmi_stream_moves_with_body(int motion) { return motion == VM_RELATIVE || motion == VM_CARRIED; }
VM_INLINE int vmi_stream_velocity_is_given(int motion) { return motion == VM_RELATIVE || motion == VM_ABSOLUTE; }

/* The velocity u of a stream's mass along a line. `own` is the velocity of the body, and `given` the field `velocity`
   of the stream. */
VM_INLINE vm_real vmi_stream_velocity1(int motion, vm_real own, vm_real given)
{
    vm_real u = 0;
    if (vmi_stream_moves_with_body(motion)) u = own;
    if (vmi_stream_velocity_is_given(motion)) u += given;
    return u;
}

/* The product M' kappa of a stream's rate M' and the gyration kappa (inertia per unit mass) of its mass */
VM_INLINE vm_inertia vmi_stream_own(vm_real rate, const vm_inertia *gyration)
{
    vm_inertia i;
    i.xx = rate * gyration->xx;
    i.yy = rate * gyration->yy;
    i.zz = rate * gyration->zz;
    i.xy = rate * gyration->xy;
    i.xz = rate * gyration->xz;
    i.yz = rate * gyration->yz;
    return i;
}

/* Sets *p to the momentum, and *h to the angular momentum about the mass centre, of the mass that flows between the
   stores and the surface. A stream of rate M' that flows in a straight line between its store at s and the surface at
   d has the momentum M' (s - d), whatever its speed is. */
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

/* The motion of a body, in the form that the sums over its streams need */
typedef struct VM_TAG(vmi_stream_seen) {
    const vmi_mat3 *turn; /* the rotation from body axes to inertial ones */
    vm_vec3 v;            /* velocity, which is momentum/mass, inertial axes */
    vm_vec3 slip;         /* velocity of the body's material at the mass centre minus v, body axes */
    vm_vec3 omega;        /* angular velocity, body axes */
    vm_vec3 centre;       /* mass centre from the reference point, body axes */
    int energy;           /* 1 if the sums `brought` and `lost` of vmi_stream_sum are wanted */
} vmi_stream_seen;

/* The sums over the streams of a moving body, in body axes except `absolute`. The letters M', u, v, d, kappa, omega2
   are explained at vm_reactive. For mass that moves with the body the sums use its velocity relative to the body, so
   that they lose no digits if the body is fast. */
typedef struct VM_TAG(vmi_stream_sum) {
    vm_real rate;       /* total mass rate, the sum of M' over all streams, kg/s */
    vm_real carried;    /* sum of M' of the streams whose velocity is relative to the body */
    vm_vec3 pushed;     /* force of the streams whose velocity is relative to the body: sum of M' (u - v) */
    vm_vec3 absolute;   /* sum of M' u of the streams whose velocity u is absolute, inertial axes */
    vm_vec3 moment;     /* moment of all streams about the mass centre: sum of d x M' (u - v) */
    vm_vec3 own;        /* sum of M' kappa omega2: angular momentum that masses bring per second by their spins */
    vm_vec3 crossing;   /* sum of M' d, where d leads to the point at which the mass enters or leaves */
    vm_vec3 stored;     /* sum of M' d_s, where d_s leads to the stream's store; d_s = d without a store */
    vm_inertia inertia; /* I', the rate of the body's inertia */
    vm_real brought;    /* sum of M' u^2 + omega2 M' kappa omega2: twice the power that the mass brings */
    vm_real lost;       /* `brought` with velocities relative to the body: twice the power lost by mixing */
} vmi_stream_sum;

/* Adds one stream, whose `motion` is known, to sum->carried, sum->pushed and sum->absolute. Sets *push = M' (u - v),
   where M' is the rate, u the velocity of the mass and v that of the body, and *spin to the angular velocity of the
   mass. The argument `carried` is the velocity of the body's point at which the mass enters or leaves, minus v. All
   vectors are in body axes. */
VM_INLINE void vmi_stream_motion(const vm_stream *s, const vmi_stream_seen *b, vm_vec3 carried, vmi_stream_sum *sum,
                                 vm_vec3 *push, vm_vec3 *spin)
{
    const int given = vmi_stream_velocity_is_given(s->motion);
    if (vmi_stream_moves_with_body(s->motion)) {
        *spin = b->omega;
        if (given) {
            carried = vmi_add(carried, s->velocity);
            *spin = vmi_add(b->omega, s->spin);
        }
        *push = vmi_scale(s->rate, carried);
        sum->carried += s->rate;
        sum->pushed = vmi_add(sum->pushed, *push);
    } else if (given) {
        *push = vmi_scale(s->rate, vmi_times_transposed(b->turn, vmi_sub(s->velocity, b->v)));
        *spin = vmi_times_transposed(b->turn, s->spin);
        sum->absolute = vmi_add(sum->absolute, vmi_scale(s->rate, s->velocity));
    } else {
        *push = vmi_times_transposed(b->turn, vmi_scale(-s->rate, b->v));
        *spin = vmi_vec3(0, 0, 0);
    }
}

/* Adds the share of a stream to sum->brought and sum->lost. push and spin are results of vmi_stream_motion, and carried
   is an argument of that function. */
VM_INLINE void vmi_stream_energy(const vm_stream *s, const vmi_stream_seen *b, const vm_inertia *own, vm_vec3 push,
                                 vm_vec3 spin, vm_vec3 carried, vmi_stream_sum *sum)
{
    const vm_vec3 relative = vmi_sub(spin, b->omega);
    vm_vec3 u = push, absolute, w;
    if (s->rate != 0) u = vmi_scale(1 / s->rate, push);
    absolute = vmi_add(u, vmi_times_transposed(b->turn, b->v));
    w = vmi_sub(u, carried);
    sum->brought += s->rate * vmi_dot(absolute, absolute) + vmi_dot(spin, vmi_inertia_times(own, spin));
    sum->lost += s->rate * vmi_dot(w, w) + vmi_dot(relative, vmi_inertia_times(own, relative));
}

/* Computes the sums over n streams. Returns 0 if the `motion` of a stream is unknown, else 1. */
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
        if (!vmi_stream_motion_is_known(s->motion)) return 0;
        vmi_stream_motion(s, b, carried, sum, &push, &spin);
        if (b->energy) vmi_stream_energy(s, b, &own, push, spin, carried, sum);
        sum->rate += s->rate;
        sum->moment = vmi_add(sum->moment, vmi_cross(d, push));
        sum->own = vmi_add(sum->own, vmi_inertia_times(&own, spin));
        sum->crossing = vmi_add(sum->crossing, vmi_scale(s->rate, d));
        if (s->from) {
            stored = vmi_sub(s->from->at, b->centre);
            own = vmi_stream_own(s->rate, &s->from->gyration);
        }
        sum->stored = vmi_add(sum->stored, vmi_scale(s->rate, stored));
        /* add the whole term at once, so that the terms of opposite streams cancel exactly */
        own = vmi_inertia_plus(own, s->rate, vmi_inertia_of_point(stored));
        sum->inertia = vmi_inertia_plus(sum->inertia, 1, own);
    }
    return 1;
}

/* Returns VM_OK if the gyration is finite and has no negative moment. The triangle inequality, such as zz <= xx + yy,
   is required of the body only. Therefore a gyration may have zz alone, which is enough for motion in a plane. */
VM_API int vmi_check_gyration(const vm_inertia *i)
{
    if (!vmi_inertia_is_finite(i)) return VM_NOT_FINITE;
    if (!(i->xx >= 0 && i->yy >= 0 && i->zz >= 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Returns VM_OK if `motion` is known, all numbers are finite and the gyrations are possible, else the first error. */
VM_API int vmi_check_stream(const vm_stream *s)
{
    int status;
    if (!vmi_stream_motion_is_known(s->motion)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(s->rate) || !vmi_vec3_is_finite(s->at) || !vmi_vec3_is_finite(s->velocity) ||
        !vmi_vec3_is_finite(s->spin))
        return VM_NOT_FINITE;
    status = vmi_check_gyration(&s->gyration);
    if (!s->from) return status;
    if (!vmi_vec3_is_finite(s->from->at)) return VM_NOT_FINITE;
    return vmi_first_error(status, vmi_check_gyration(&s->from->gyration));
}

/* Returns VM_OK if n streams are valid, else that one of their errors which comes first in the order of
   vmi_first_error. */
VM_API int vmi_check_streams(int n, const vm_stream *s)
{
    int k, status = VM_OK;
    if (n < 0 || (n > 0 && !s)) return VM_BAD_ARGUMENT;
    for (k = 0; k < n; k++) status = vmi_first_error(status, vmi_check_stream(s + k));
    return status;
}

VM_API int vmi_reactive_finite(const vm_reactive *r)
{
    return vmi_vec3_is_finite(r->force) && vmi_vec3_is_finite(r->moment) && vmi_vec3_is_finite(r->torque) &&
           vmi_vec3_is_finite(r->drift) && VM_IS_FINITE(r->mass_rate) && vmi_inertia_is_finite(&r->inertia_rate);
}

/* Reactive force, moment and torque of n streams on a moving body, (156)-(158). `centre` is the body's mass centre
   from its reference point, in body axes (m). Each load is a sum over all streams; the formulas stand at vm_reactive.
   Returns VM_BAD_ARGUMENT for a null pointer, n < 0 or an unknown `motion` of a stream, VM_NOT_FINITE, VM_BAD_MASS,
   VM_BAD_INERTIA, VM_STORED_STREAM if a stream has a store (integrate vm_flow_rhs instead), and VM_OK otherwise. */
VM_API int vm_reactive_loads(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams,
                             vm_reactive *result)
{
    vmi_mat3 turn;
    vmi_stream_sum sum;
    vmi_stream_seen seen;
    vm_reactive r;
    int status, k;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_first_error(vmi_check_body(body), vmi_check_streams(n, streams));
    if (!vmi_vec3_is_finite(centre)) status = vmi_first_error(status, VM_NOT_FINITE);
    for (k = 0; !status && k < n; k++)
        if (streams[k].from) status = VM_STORED_STREAM;
    if (status) return status;
    turn = vmi_rotation(body->q);
    seen.turn = &turn;
    seen.v = body->v;
    seen.slip = vmi_vec3(0, 0, 0);
    seen.centre = centre;
    seen.energy = 0;
    seen.omega = vmi_times_transposed(&turn, body->omega);
    vmi_stream_sums(n, streams, &seen, &sum);
    r.force = vmi_add(vmi_times(&turn, sum.pushed),
                      vmi_sub(sum.absolute, vmi_scale(sum.rate - sum.carried, body->v)));
    r.moment = vmi_times(&turn, sum.moment);
    r.torque = vmi_times(&turn, vmi_sub(sum.own, vmi_inertia_times(&sum.inertia, seen.omega)));
    r.drift = vmi_scale(1 / body->mass, vmi_times(&turn, sum.crossing));
    r.mass_rate = sum.rate;
    r.inertia_rate = sum.inertia;
    if (!vmi_reactive_finite(&r)) return VM_NOT_FINITE;
    *result = r;
    return VM_OK;
}

/* Solves Euler's equations: the angular acceleration I^-1 (moment - omega x I omega) for the inertia I, in body axes */
VM_INLINE vm_vec3 vmi_stream_euler(const vm_inertia *i, const vmi_inertia_ldl *factors, vm_vec3 omega,
                                   vm_vec3 moment)
{
    return vmi_inertia_solve(factors, vmi_sub(moment, vmi_cross(omega, vmi_inertia_times(i, omega))));
}

/* Accelerations v' (159) and omega' (160) of a body under reactive and outer loads.
   All vectors are in inertial axes. `force` is the resultant of the outer forces (N), `moment` their moment about the
   mass centre (N m). *acceleration is v', the rate of momentum/mass (m/s^2), and *angular_acceleration is omega'
   (rad/s^2). Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA also for the
   singular inertia of a rod or a point, and VM_OK otherwise. */
VM_API int vm_accelerations(const vm_body *body, const vm_reactive *loads, vm_vec3 force, vm_vec3 moment,
                            vm_vec3 *acceleration, vm_vec3 *angular_acceleration)
{
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    vm_vec3 sum, linear, angular;
    int status;
    if (!body || !loads || !acceleration || !angular_acceleration) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!vmi_vec3_is_finite(force) || !vmi_vec3_is_finite(moment) || !vmi_vec3_is_finite(loads->force) ||
        !vmi_vec3_is_finite(loads->moment) || !vmi_vec3_is_finite(loads->torque))
        status = vmi_first_error(status, VM_NOT_FINITE);
    if (!status && !vmi_inertia_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    turn = vmi_rotation(body->q);
    sum = vmi_add(moment, vmi_add(loads->moment, loads->torque));
    linear = vmi_scale(1 / body->mass, vmi_add(force, loads->force));
    angular = vmi_stream_euler(&body->inertia, &factors, vmi_times_transposed(&turn, body->omega),
                               vmi_times_transposed(&turn, sum));
    angular = vmi_times(&turn, angular);
    if (!vmi_vec3_is_finite(linear) || !vmi_vec3_is_finite(angular)) return VM_NOT_FINITE;
    *acceleration = linear;
    *angular_acceleration = angular;
    return VM_OK;
}

#endif
/* mechanics/attitude.h - how the attitude of a rotating body changes

       vm_quat q = {1, 0, 0, 0};  // the attitude: body axes are inertial axes
       vm_vec3 omega = {0, 0, 2}; // 2 rad/s about the third axis
       vm_real rates[4];          // w', x', y', z' of q
       vmi_attitude_rates(q, vmi_quat_square(q), omega, rates);

   Tests: tests/test_flow.c, tests/test_scene_bodies.c. */
#ifndef VARMASS_MECHANICS_ATTITUDE_H
#define VARMASS_MECHANICS_ATTITUDE_H

/* Writes the rates of the unit quaternion q, the attitude of a body that rotates with omega, in body axes:
   q' = q (0, omega)/2 + |omega| (1 - |q|^2) q/8. square is |q|^2. The second term lets the length of q return to 1, but
   more slowly than the body rotates. Therefore it does not make the equations of a slow rotation stiff. */
VM_INLINE void vmi_attitude_rates(vm_quat q, vm_real square, vm_vec3 omega, vm_real *rates)
{
    const vm_real back = VM_SQRT(vmi_dot(omega, omega)) * (1 - square) / 8;
    const vm_real x = omega.x / 2, y = omega.y / 2, z = omega.z / 2;
    rates[0] = back * q.w - q.x * x - q.y * y - q.z * z;
    rates[1] = back * q.x + q.w * x + q.y * z - q.z * y;
    rates[2] = back * q.y + q.w * y + q.z * x - q.x * z;
    rates[3] = back * q.z + q.w * z + q.x * y - q.y * x;
}

#endif
/* mechanics/flow.h - a free body in space with streams of mass

   These right-hand sides for rk45 and rk87 describe a rigid body whose mass, mass centre and inertia change while it
   moves. In vm_flow_rhs streams cause the change (151), (152). In vm_flow_given_rhs all three are given functions of
   time (170). In vm_flow_carried_rhs the mass that is lost or gained moves with the body (166). In the first two
   functions momentum and angular momentum are states, from which velocity and angular velocity follow. Therefore a
   momentum that is conserved stays exactly constant, and the rate of a stream may jump.

       vm_flow flow;
       ode_event empty;
       rk45_options options = rk45_defaults(NULL);
       rk45 s;
       vm_real y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
       memset(&flow, 0, sizeof flow); // a field that is zero has no effect
       flow.n = 1;
       flow.streams = &nozzle;
       flow.least_mass = dry;
       memset(&empty, 0, sizeof empty);
       empty.g = vm_flow_mass_left; // stops the run when the tank is empty
       empty.ctx = &flow;
       empty.direction = -1;
       empty.action = ODE_STOP;
       options.events = &empty;
       options.n_events = 1;
       if (vm_flow_start(&flow, &body, y) == VM_OK &&
           rk45_init(&s, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, &options, work) >= 0 && rk45_solve(&s, 3) >= 0)
           vm_flow_body(&flow, VM_FLOW_STATES, s.y, &body);

   The equations. The letters M', u, d, kappa, omega2, P(d) of a stream are explained at vm_reactive. The body has the
   mass M, the inertia I and the angular velocity omega; F is the outer force on it and M_S the outer moment:
     r' = v + R sum (M'/M) d,  p' = F + sum M' u,  H' = M_S + R sum [d x M' (u - v) + M' kappa omega2],
     q' = q omega/2 + |omega| (1 - |q|^2) q/8,  c' = sum (M'/M) d,  I' = sum M' (kappa + P(d))
   r is the position of the mass centre, p = M v the momentum, H the angular momentum about the mass centre, and q the
   attitude. The vector c leads from the reference point to the mass centre, and d = at - c; both are in body axes. R is
   the rotation of q/|q| from body axes to inertial ones. The last term of q' is 0 for |q| = 1. It brings the length of
   q back to 1 and does not lower the order of an integrator. The dissertation [1] prints I' omega2 in (152) instead of
   M' kappa omega2.
   If a stream has a store (vm_store) at the position s, three terms differ, with d_s = s - c: d_s replaces d in c' and
   P(d); the gyration of the store replaces kappa in I'; and the mass on its way between store and surface has the
   momentum M' (s - at) and the angular momentum M' d x d_s.
   The reference point, from which `at`, s and c are measured, is fixed in the body; its position is r - R c. If
   flow.centre is 0 at the start, the reference point is the initial mass centre.
   Tests: tests/test_flow.c. */
#ifndef VARMASS_MECHANICS_FLOW_H
#define VARMASS_MECHANICS_FLOW_H

/* Indices of the states in y, and numbers of states. Axes are inertial unless body axes are named. */
enum {
    VM_Y_R = 0,        /* position of the mass centre, 3 numbers, m */
    VM_Y_Q = 3,        /* attitude, 4 numbers w, x, y, z */
    VM_Y_P = 7,        /* momentum, 3 numbers, kg m/s; for vm_flow_carried_rhs the velocity v, m/s */
    VM_Y_H = 10,       /* angular momentum about the mass centre, 3 numbers, kg m^2/s; for vm_flow_carried_rhs the
                          angular velocity in body axes, rad/s */
    VM_Y_MASS = 13,    /* mass, kg */
    VM_Y_CENTRE = 14,  /* mass centre from the reference point, 3 numbers, body axes, m */
    VM_Y_INERTIA = 17, /* inertia xx, yy, zz, xy, xz, yz about the mass centre, body axes, kg m^2 */
    VM_Y_BALANCE = 23, /* integrals of vm_flow_balanced_rhs: 3 of momentum, 3 of angular momentum, 1 of energy */
    VM_FLOW_GIVEN_STATES = 13,   /* states if flow.update gives the mass data: vm_flow_given_rhs, vm_flow_carried_rhs */
    VM_FLOW_STATES = 23,         /* states of vm_flow_rhs; mass, mass centre and inertia are among them */
    VM_FLOW_BALANCED_STATES = 30 /* states of vm_flow_balanced_rhs: those of vm_flow_rhs and the 7 integrals */
};

/* The streams and loads of a body: the ctx of the right-hand sides below. Set the whole struct to zero first; a field
   that stays zero has no effect. */
typedef struct VM_TAG(vm_flow) {
    int n;              /* number of streams */
    vm_stream *streams; /* n streams, kept by the caller */
    vm_vec3 force;      /* resultant of the outer forces, N, inertial axes */
    vm_vec3 moment;     /* moment of the outer forces about the mass centre, plus all torques, N m, inertial axes */
    /* NULL, or a function that is called before each evaluation of a right-hand side and sets what depends on time and
       state. It may set every field of the flow and of its streams: a weight (flow->force = y[VM_Y_MASS] g), a rate
       that follows a valve, and the laws of mass M(t), mass centre c(t) and inertia I(t) for vm_flow_given_rhs and
       vm_flow_carried_rhs. (One function gives all ten numbers of these laws, because they belong together.) It
       returns 0; another number ends the run, with the integrator's status ODE_RHS_STOPPED. What it sets has to be a
       smooth function of t and y. To switch something at an instant, use an event with the action ODE_RESTART and its
       function `change`. */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow) * flow);
    void *ctx;             /* pointer for the caller's `update`; not used by the functions below */
    vm_real mass;          /* mass for vm_flow_given_rhs and vm_flow_carried_rhs, kg */
    vm_vec3 centre;        /* mass centre from the reference point, m, body axes (vm_flow_given_rhs, vm_flow_start) */
    vm_inertia inertia;    /* inertia for vm_flow_given_rhs and vm_flow_carried_rhs, kg m^2, body axes */
    vm_vec3 drift;         /* rate c'(t) of the mass centre for vm_flow_carried_rhs, m/s, body axes */
    vm_real least_mass;    /* mass at which vm_flow_mass_left is 0, kg */
    vm_real least_inertia; /* smallest pivot of the inertia at which vm_flow_inertia_left is 0, kg m^2 */
    /* VM_OK, or the reason why the last evaluations gave NaN or ended the run. A trial step may go beyond the end of a
       motion, where the mass is zero or negative or no body can have the inertia. The derivatives are then NaN, so that
       the integrator shortens its step. An event should stop the run before this happens. */
    int status;
    /* Length of the array y, VM_LENGTH(y), which all functions below check; 0 means unknown. vm_flow_start writes
       VM_FLOW_GIVEN_STATES or VM_FLOW_STATES numbers, as many as y_size allows. If y_size allows all
       VM_FLOW_BALANCED_STATES, it also sets the seven integrals of the balance to 0. */
    int y_size;
} vm_flow;

/* Returns 1 if n is 0, or if n is positive and there is an array of streams. */
VM_INLINE int vmi_flow_has_streams(int n, const void *streams) { return n == 0 || (n > 0 && streams); }

/* Sets n derivatives to NaN, which makes the integrator shorten its step. Returns 0, so that the run goes on. */
VM_API int vmi_flow_reject_step(int n, vm_real *dydt)
{
    int k;
    for (k = 0; k < n; k++) dydt[k] = VM_NAN;
    return 0;
}

/* Stores the status of an evaluation of a right-hand side in *kept and returns it. After several failures in a row
   *kept is the status of the first one, because the NaN that it returned causes the later failures. */
VM_INLINE int vmi_flow_note_status(int *kept, int status)
{
    if (!status || !*kept) *kept = status;
    return status;
}

/* Mass, mass centre and inertia of a body at an instant */
typedef struct VM_TAG(vmi_flow_mass) {
    vm_real mass;
    vm_vec3 centre;
    vm_inertia inertia;
} vmi_flow_mass;

/* The present mass, mass centre and inertia of the body: from the fields of the flow if given = 1, else from the state
   y */
VM_INLINE vmi_flow_mass vmi_flow_mass_at(const vm_flow *flow, int given, const vm_real *y)
{
    vmi_flow_mass b;
    if (given) {
        b.mass = flow->mass;
        b.centre = flow->centre;
        b.inertia = flow->inertia;
    } else {
        b.mass = y[VM_Y_MASS];
        b.centre = vmi_get3(y + VM_Y_CENTRE);
        b.inertia = vmi_get_inertia(y + VM_Y_INERTIA);
    }
    return b;
}

VM_API int vmi_flow_mass_is_finite(const vmi_flow_mass *b)
{
    return VM_IS_FINITE(b->mass) && vmi_vec3_is_finite(b->centre) && vmi_inertia_is_finite(&b->inertia);
}

VM_INLINE int vmi_flow_check_mass(vm_real mass)
{
    if (!VM_IS_FINITE(mass)) return VM_NOT_FINITE;
    if (!(mass > 0)) return VM_BAD_MASS;
    return VM_OK;
}

/* Computes from the state y the rotation *turn from body axes to inertial ones, and in *seen the velocity, the
   angular velocity and all else that the streams need. Returns VM_OK, VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA. */
VM_INLINE int vmi_flow_motion(const vm_flow *flow, const vm_real *y, const vmi_flow_mass *b, vmi_mat3 *turn,
                              vmi_stream_seen *seen)
{
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_vec3 p = vmi_get3(y + VM_Y_P);
    const vm_real inverse = 1 / b->mass;
    vm_vec3 h, p_on_the_way, h_on_the_way;
    vmi_inertia_ldl factors;
    const int status = vmi_flow_check_mass(b->mass);
    if (status) return status;
    if (!vmi_inertia_factor_if_possible(&b->inertia, &factors)) return VM_BAD_INERTIA;
    *turn = vmi_rotation_of_square(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    h = vmi_times_transposed(turn, vmi_get3(y + VM_Y_H));
    vmi_stream_on_the_way(flow->n, flow->streams, b->centre, &p_on_the_way, &h_on_the_way);
    seen->turn = turn;
    seen->centre = b->centre;
    seen->v = vmi_scale(inverse, p);
    seen->slip = vmi_scale(-inverse, p_on_the_way);
    seen->omega = vmi_inertia_solve(&factors, vmi_sub(h, h_on_the_way));
    return VM_OK;
}

/* Sets dydt[0] ... dydt[6], the rates of the seven integrals of vm_flow_balanced_rhs: the momentum, angular momentum
   and energy that the streams take out of the body per second, minus those that the outer loads put in */
VM_INLINE void vmi_flow_balance(const vm_flow *flow, const vm_real *y, const vmi_stream_seen *seen,
                                const vmi_stream_sum *sum, vm_vec3 force, vm_vec3 moment, vm_real *dydt)
{
    const vm_vec3 omega = vmi_times(seen->turn, seen->omega), r = vmi_get3(y + VM_Y_R);
    const vm_vec3 drift = vmi_times(seen->turn, sum->crossing);
    vmi_set3(dydt, vmi_scale(-1, force));
    vmi_set3(dydt + 3, vmi_scale(-1, vmi_add(moment, vmi_add(vmi_cross(r, force), vmi_cross(drift, seen->v)))));
    dydt[6] = (sum->lost - sum->brought) / 2 - vmi_dot(flow->force, seen->v) - vmi_dot(flow->moment, omega);
}

/* Evaluates the right-hand side that has n states: vm_flow_given_rhs, vm_flow_rhs or vm_flow_balanced_rhs */
VM_INLINE int vmi_flow_rates(vm_flow *flow, int n, vm_real t, const vm_real *y, vm_real *dydt)
{
    const int given = n == VM_FLOW_GIVEN_STATES;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    vm_vec3 force, moment;
    vmi_flow_mass body;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    vmi_stream_sum sum;
    int status = 0;
    if (flow->update) status = flow->update(t, y, flow);
    if (status) return status;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return flow->status = VM_SHORT_ARRAY;
    body = vmi_flow_mass_at(flow, given, y);
    status = vmi_flow_motion(flow, y, &body, &turn, &seen);
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(n, dydt);
    seen.energy = n == VM_FLOW_BALANCED_STATES;
    if (!vmi_stream_sums(flow->n, flow->streams, &seen, &sum)) return flow->status = VM_BAD_ARGUMENT;
    force = vmi_add(vmi_times(&turn, sum.pushed), vmi_scale(sum.carried, seen.v));
    force = vmi_add(flow->force, vmi_add(sum.absolute, force));
    moment = vmi_add(flow->moment, vmi_times(&turn, vmi_add(sum.moment, sum.own)));
    vmi_set3(dydt + VM_Y_R, vmi_add(seen.v, vmi_times(&turn, vmi_scale(1 / body.mass, sum.crossing))));
    vmi_attitude_rates(q, vmi_quat_square(q), seen.omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P, force);
    vmi_set3(dydt + VM_Y_H, moment);
    if (given) return 0;
    dydt[VM_Y_MASS] = sum.rate;
    vmi_set3(dydt + VM_Y_CENTRE, vmi_scale(1 / body.mass, sum.stored));
    vmi_set_inertia(dydt + VM_Y_INERTIA, &sum.inertia);
    if (seen.energy) vmi_flow_balance(flow, y, &seen, &sum, force, moment, dydt + VM_Y_BALANCE);
    return 0;
}

/* Right-hand side of a free body whose streams change its mass (151), (152).
   An ode_rhs of VM_FLOW_STATES states; ctx is a vm_flow. The equations stand at the top of mechanics/flow.h. Returns
   0; or VM_BAD_ARGUMENT for a null pointer, n < 0 or an unknown `motion` of a stream, VM_SHORT_ARRAY if y_size is too
   small, or the number that flow.update returns, each of which ends the run. */
VM_API int vm_flow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_STATES, t, y, dydt);
}

/* Right-hand side of a free body with given laws of mass, mass centre and inertia.
   An ode_rhs of VM_FLOW_GIVEN_STATES states; ctx is a vm_flow, whose `update` gives the laws as functions of time.
   The streams make forces and moments as in vm_flow_rhs. Without streams the equations are (170): mass joins and
   leaves at rest, at the mass centre. The errors are those of vm_flow_rhs. */
VM_API int vm_flow_given_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_GIVEN_STATES, t, y, dydt);
}

/* Right-hand side vm_flow_rhs with seven integrals that check the balances.
   An ode_rhs of VM_FLOW_BALANCED_STATES states; ctx is a vm_flow. The integrals stand from y[VM_Y_BALANCE] on and are
   zero at the start: momentum (3), angular momentum about the origin (3) and kinetic energy (1) that the streams took
   out, minus those that the outer loads put in. The sum of an integral and the body's own quantity stays constant.
   (There are two exceptions if a stream has a store: the body's angular momentum is then y[VM_Y_H] + r x p, and the
   energy does not balance.) The rate T' of the kinetic energy follows from (113), (118), which hold for sudden
   changes, in the limit of a continuous stream, for M' > 0 and M' < 0. With the letters of the equations at the top of
   mechanics/flow.h:
     T' = F v + M_S omega + sum [M' u^2 + omega2 M' kappa omega2]/2 - sum [M' w^2 + omega_r M' kappa omega_r]/2,
     w = u - v - omega x d, omega_r = omega2 - omega.
   The first sum is the power that the streams bring. The second sum, with its minus sign, is the power of engines
   (M' < 0), or minus the power that plastic impact takes (M' > 0). The errors are those of vm_flow_rhs. */
VM_API int vm_flow_balanced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_BALANCED_STATES, t, y, dydt);
}

/* Right-hand side of a free body that loses or gains mass which moves with the body (166).
   An ode_rhs of VM_FLOW_GIVEN_STATES states; ctx is a vm_flow, whose `update` gives mass, centre, inertia and drift.
   The states are r, q, the velocity v (not the momentum) and omega in body axes (not the angular momentum). Streams
   are not read. The equations are v' = F/M + R (omega x c'), r' = v + R c' and I omega' + omega x I omega = M_S.
   Their letters are explained at the top of mechanics/flow.h; here c' is flow.drift, and M_S is in body axes. The
   errors are those of vm_flow_rhs. */
VM_API int vm_flow_carried_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow *flow = (vm_flow *)ctx;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const vm_vec3 omega = vmi_get3(y + VM_Y_H);
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    int status = 0;
    if (flow->update) status = flow->update(t, y, flow);
    if (status) return status;
    if (flow->y_size && flow->y_size < VM_FLOW_GIVEN_STATES) return flow->status = VM_SHORT_ARRAY;
    status = vmi_flow_check_mass(flow->mass);
    if (!vmi_inertia_factor_if_possible(&flow->inertia, &factors)) status = vmi_first_error(status, VM_BAD_INERTIA);
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(VM_FLOW_GIVEN_STATES, dydt);
    turn = vmi_rotation_of_square(q, square);
    vmi_set3(dydt + VM_Y_R, vmi_add(vmi_get3(y + VM_Y_P), vmi_times(&turn, flow->drift)));
    vmi_attitude_rates(q, square, omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P,
             vmi_add(vmi_scale(1 / flow->mass, flow->force), vmi_times(&turn, vmi_cross(omega, flow->drift))));
    vmi_set3(dydt + VM_Y_H,
             vmi_stream_euler(&flow->inertia, &factors, omega, vmi_times_transposed(&turn, flow->moment)));
    return 0;
}

/* Returns how many numbers vm_flow_start writes: VM_FLOW_STATES, or fewer if y_size leaves less room. It writes zeros
   for the integrals of the balance only if y_size is large enough for them. */
VM_API int vmi_flow_size_at_start(const vm_flow *flow)
{
    if (flow->y_size >= VM_FLOW_BALANCED_STATES) return VM_FLOW_BALANCED_STATES;
    if (flow->y_size && flow->y_size < VM_FLOW_STATES) return VM_FLOW_GIVEN_STATES;
    return VM_FLOW_STATES;
}

/* Checks the arguments of vm_flow_start. The inertia must be possible and not singular. */
VM_API int vmi_flow_check_start(const vm_flow *flow, const vm_body *body)
{
    vmi_inertia_ldl factors;
    int status = vmi_first_error(vmi_check_body(body), vmi_check_streams(flow->n, flow->streams));
    if (!vmi_vec3_is_finite(flow->centre) || !vmi_vec3_is_finite(flow->force) || !vmi_vec3_is_finite(flow->moment))
        status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    if (!vmi_inertia_factor(&body->inertia, &factors)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Initial state y of a body with streams. Writes the first VM_FLOW_STATES states, or as many as flow.y_size allows.
   The mass centre is flow.centre, and the streams are those of flow.streams at the start. Sets flow.mass and
   flow.inertia too. For vm_flow_given_rhs y must have room for VM_FLOW_GIVEN_STATES numbers at least, and flow.y_size
   must be set if it has room for fewer than VM_FLOW_STATES. vm_flow_carried_rhs has different states, which the
   caller sets. Returns VM_BAD_ARGUMENT for a null pointer, n < 0 or an unknown `motion` of a stream, VM_NOT_FINITE,
   VM_BAD_MASS, VM_BAD_INERTIA also for a rod or a point, VM_SHORT_ARRAY, and VM_OK otherwise. */
VM_API int vm_flow_start(vm_flow *flow, const vm_body *body, vm_real *y)
{
    vm_vec3 p, h;
    vm_quat q;
    vmi_mat3 turn;
    vm_real start[VM_FLOW_BALANCED_STATES];
    int status, k;
    if (!flow || !body || !y) return VM_BAD_ARGUMENT;
    status = vmi_flow_check_start(flow, body);
    if (status) return status;
    q = vmi_unit_quat(body->q);
    turn = vmi_rotation(q);
    vmi_stream_on_the_way(flow->n, flow->streams, flow->centre, &p, &h);
    start[VM_Y_Q] = q.w;
    start[VM_Y_Q + 1] = q.x;
    start[VM_Y_Q + 2] = q.y;
    start[VM_Y_Q + 3] = q.z;
    vmi_set3(start + VM_Y_R, body->r);
    vmi_set3(start + VM_Y_P, vm_momentum(body));
    vmi_set3(start + VM_Y_H, vmi_add(vmi_spin_momentum(body), vmi_times(&turn, h)));
    start[VM_Y_MASS] = body->mass;
    vmi_set3(start + VM_Y_CENTRE, flow->centre);
    vmi_set_inertia(start + VM_Y_INERTIA, &body->inertia);
    if (flow->y_size && flow->y_size < VM_FLOW_GIVEN_STATES) return VM_SHORT_ARRAY;
    for (k = VM_Y_BALANCE; k < VM_FLOW_BALANCED_STATES; k++) start[k] = 0;
    status = vmi_copy_if_finite(vmi_flow_size_at_start(flow), start, y);
    if (status) return status;
    flow->mass = body->mass;
    flow->inertia = body->inertia;
    flow->status = VM_OK;
    return VM_OK;
}

/* The body that n states y describe, with a quaternion of length 1. For n = VM_FLOW_GIVEN_STATES mass, mass centre
   and inertia come from the flow, for a larger n from y. The states of vm_flow_carried_rhs are different and must not
   be given. Returns VM_BAD_ARGUMENT for a null pointer and n < VM_FLOW_GIVEN_STATES, VM_SHORT_ARRAY, VM_BAD_MASS,
   VM_BAD_INERTIA, VM_NOT_FINITE, and VM_OK otherwise. */
VM_API int vm_flow_body(const vm_flow *flow, int n, const vm_real *y, vm_body *body)
{
    vm_body b;
    vmi_flow_mass now;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    int status;
    if (!flow || !y || !body || n < VM_FLOW_GIVEN_STATES) return VM_BAD_ARGUMENT;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return VM_SHORT_ARRAY;
    now = vmi_flow_mass_at(flow, n < VM_FLOW_STATES, y);
    if (!vmi_all_finite(VM_FLOW_GIVEN_STATES, y) || !vmi_flow_mass_is_finite(&now)) return VM_NOT_FINITE;
    status = vmi_flow_motion(flow, y, &now, &turn, &seen);
    if (status) return status;
    b.mass = now.mass;
    b.inertia = now.inertia;
    b.q = vmi_unit_quat(vmi_get_quat(y + VM_Y_Q));
    b.r = vmi_get3(y + VM_Y_R);
    b.v = seen.v;
    b.omega = vmi_times(&turn, seen.omega);
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* Mass minus flow.least_mass, kg: an event function that stops a run before the mass is used up.
   It is for vm_flow_rhs and vm_flow_balanced_rhs; the ctx of the event is the vm_flow. Returns NaN for a null
   pointer. */
VM_API vm_real vm_flow_mass_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    (void)t;
    return y[VM_Y_MASS] - ((const vm_flow *)flow)->least_mass;
}

/* Smallest pivot of the inertia minus flow.least_inertia, kg m^2: an event function.
   The pivots are those of the factorization L D L^T. The event stops a run before the inertia becomes singular, which
   means that a pivot is 0. It is for vm_flow_rhs and vm_flow_balanced_rhs; its ctx is the vm_flow. The event does not
   watch the triangle inequality of the moments, because thin bodies are always close to its limit. Returns NaN for a
   null pointer or an inertia that is not finite. */
VM_API vm_real vm_flow_inertia_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    const vm_inertia i = vmi_get_inertia(y + VM_Y_INERTIA);
    vmi_inertia_ldl f;
    vm_real least = 0;
    (void)t;
    if (!vmi_inertia_is_finite(&i)) return VM_NAN;
    if (vmi_inertia_factor(&i, &f)) least = vmi_smaller(1 / f.z, vmi_smaller(1 / f.y, i.xx));
    return least - ((const vm_flow *)flow)->least_inertia;
}

#endif
/* mechanics/flow2.h - a body in a plane with streams of mass

   This is the right-hand side of mechanics/flow.h for motion in a plane, with 10 states instead of 23. Streams in the
   plane have no stores; otherwise the equations are those of motion in space.

       vm_stream2 jet = {-1, VM_RELATIVE, -0.5, 0, -2000, 0, 0, 0}; // 1 kg/s, 0.5 m behind, 2000 m/s backwards
       vm_flow2 flow;
       vm_real y[VM_FLOW2_STATES] = {0, 0, 0, 0, 0, 1, 100, 0, 0, 20}; // spins slowly, 100 kg, 20 kg m^2
       vm_real dydt[VM_FLOW2_STATES];
       memset(&flow, 0, sizeof flow);
       flow.n = 1;
       flow.streams = &jet;
       int status = vm_flow2_rhs(0, y, dydt, &flow); // or integrate it: rk45_init(&s, vm_flow2_rhs, &flow, ...)

   Tests: tests/test_flow2.c. */
#ifndef VARMASS_MECHANICS_FLOW2_H
#define VARMASS_MECHANICS_FLOW2_H

/* Indices of the states of vm_flow2_rhs in y, and their number. Axes are inertial unless body axes are named. */
enum {
    VM_FLOW2_X = 0,       /* position of the mass centre, 2 numbers x, y, m */
    VM_FLOW2_ANGLE = 2,   /* angle of the body axes, rad, anticlockwise */
    VM_FLOW2_P = 3,       /* momentum, 2 numbers, kg m/s */
    VM_FLOW2_H = 5,       /* angular momentum about the mass centre, kg m^2/s */
    VM_FLOW2_MASS = 6,    /* mass, kg */
    VM_FLOW2_CENTRE = 7,  /* mass centre from the reference point, 2 numbers, body axes, m */
    VM_FLOW2_INERTIA = 9, /* moment of inertia about the mass centre, kg m^2 */
    VM_FLOW2_STATES = 10
};

/* A stream of mass in the plane */
typedef struct VM_TAG(vm_stream2) {
    vm_real rate;     /* mass per time, kg/s; > 0: mass joins the body, < 0: mass leaves it */
    int motion;       /* how velocity and spin are given: VM_RELATIVE, VM_ABSOLUTE, VM_CARRIED, VM_AT_REST */
    vm_real x, y;     /* point at which the mass enters or leaves, from the body's reference point, m, body axes */
    vm_real vx, vy;   /* velocity of the mass as it enters or leaves the body, m/s */
    vm_real spin;     /* angular velocity of the mass as it enters or leaves the body, rad/s */
    vm_real gyration; /* inertia per unit mass of the mass that enters or leaves, about its own mass centre, m^2 */
} vm_stream2;

/* The streams and loads of a body in the plane: the ctx of vm_flow2_rhs. Set the whole struct to zero first. */
typedef struct VM_TAG(vm_flow2) {
    int n;               /* number of streams */
    vm_stream2 *streams; /* n streams, kept by the caller */
    vm_real fx, fy;      /* resultant of the outer forces, N, inertial axes */
    vm_real moment;      /* moment of the outer forces about the mass centre, plus all torques, N m */
    /* NULL, or a function that is called before each evaluation and may set every field from t and y, as
       vm_flow.update does. It returns 0; another number ends the run. */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow2) * flow);
    void *ctx;  /* pointer for the caller's `update`; not used by the functions below */
    int status; /* VM_OK, or the reason why the last evaluations gave NaN or ended the run: see vm_flow.status */
} vm_flow2;

/* Sine and cosine of x, with errors below 0.6 eps. For |x| up to 2^20 quarter turns (float 2^10) the j quarter turns
   nearest to x are subtracted from it, in fewer operations than vmi_sincos needs. pi/2 is taken as the sum of two
   numbers: `first` has 33 (float 14) bits, so that j times `first` is exact. The sum of `first` and `second` differs
   from pi/2 by 2^-87 (float 2^-38). The product j times `second` has a rounding error of 2^-67 (float 2^-28). */
VM_INLINE void vmi_sincos_of_angle(vm_real x, vm_real *sine, vm_real *cosine)
{
#if VM_MANT_DIG > 24
    const vm_real most = VM_C(1048576.0);
    const vm_real first = VM_C(1.570796326734125614166), second = VM_C(6.077100506506192601e-11);
#else
    const vm_real most = VM_C(1024.0);
    const vm_real first = VM_C(1.5706787109375), second = VM_C(1.176158573966192321e-4);
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
    rest = x - (vm_real)j * first;
    tail = (vm_real)j * second;
    z.hi = rest - tail;
    z.lo = (rest - z.hi) - tail;
    vmi_sin_cos(z, &s, &c);
    *sine = (j & 1 ? c : s) * (vm_real)(1 - (j & 2));
    *cosine = (j & 1 ? s : c) * (vm_real)(1 - ((j + 1) & 2));
}

/* The motion of a body in the plane, in the form that the sums over its streams need */
typedef struct VM_TAG(vmi_stream_seen2) {
    vm_real sine, cosine;       /* sine and cosine of the body's angle */
    vm_real vx, vy;             /* velocity, which is momentum/mass, body axes */
    vm_real omega;              /* angular velocity, rad/s */
    vm_real centre_x, centre_y; /* mass centre from the reference point, body axes */
} vmi_stream_seen2;

/* The sums over the streams of a body in the plane, in body axes except fx, fy. The letters M', u, v, d, kappa,
   omega2 are explained at vm_reactive. */
typedef struct VM_TAG(vmi_stream_sum2) {
    vm_real rate;    /* total mass rate, the sum of M' over all streams, kg/s */
    vm_real carried; /* sum of M' of the streams whose velocity is relative to the body */
    vm_real px, py;  /* force of the streams whose velocity is relative to the body: sum of M' (u - v) */
    vm_real fx, fy;  /* outer force, plus the sum of M' u of the streams whose velocity is absolute, inertial axes */
    vm_real moment;  /* outer moment, plus the moments d x M' (u - v) + M' kappa omega2 of the streams */
    vm_real sx, sy;  /* sum of M' d, which moves the mass centre in the body */
    vm_real inertia; /* rate of the body's inertia: sum of M' (kappa + d^2) */
} vmi_stream_sum2;

/* Adds a stream, whose `motion` is known, to the sums */
VM_INLINE void vmi_stream_add2(const vm_stream2 *s, const vmi_stream_seen2 *b, vmi_stream_sum2 *sum)
{
    const int given = vmi_stream_velocity_is_given(s->motion);
    const vm_real dx = s->x - b->centre_x, dy = s->y - b->centre_y;
    vm_real ux, uy, spin = 0; /* ux, uy become M' (u - v); spin is the angular velocity omega2 of the mass */
    if (vmi_stream_moves_with_body(s->motion)) {
        ux = -b->omega * dy;
        uy = b->omega * dx;
        spin = b->omega;
        if (given) {
            ux += s->vx;
            uy += s->vy;
            spin += s->spin;
        }
        ux *= s->rate;
        uy *= s->rate;
        sum->carried += s->rate;
        sum->px += ux;
        sum->py += uy;
    } else {
        ux = -s->rate * b->vx;
        uy = -s->rate * b->vy;
        if (given) {
            const vm_real fx = s->rate * s->vx, fy = s->rate * s->vy;
            sum->fx += fx;
            sum->fy += fy;
            spin = s->spin;
            ux += b->cosine * fx + b->sine * fy;
            uy += b->cosine * fy - b->sine * fx;
        }
    }
    sum->rate += s->rate;
    sum->moment += dx * uy - dy * ux + s->rate * s->gyration * spin;
    sum->sx += s->rate * dx;
    sum->sy += s->rate * dy;
    sum->inertia += s->rate * (s->gyration + dx * dx + dy * dy);
}

/* Returns VM_OK if the mass and the inertia of the state y are positive, else VM_BAD_MASS or VM_BAD_INERTIA. */
VM_INLINE int vmi_flow2_check_state(const vm_real *y)
{
    if (!(y[VM_FLOW2_MASS] > 0)) return VM_BAD_MASS;
    if (!(y[VM_FLOW2_INERTIA] > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Right-hand side of a body in the plane with streams of mass, (151), (152).
   An ode_rhs of VM_FLOW2_STATES states; ctx is a vm_flow2. The equations are those at the top of mechanics/flow.h.
   Returns 0; or VM_BAD_ARGUMENT for a null pointer, n < 0 or an unknown `motion` of a stream, or the number that
   flow.update returns, each of which ends the run. */
VM_API int vm_flow2_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow2 *flow = (vm_flow2 *)ctx;
    vmi_stream_sum2 sum = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    vmi_stream_seen2 seen;
    vm_real sine = 0, cosine = 1, inverse, vx, vy, sx, sy;
    int k, status = 0;
    if (flow->update) status = flow->update(t, y, flow);
    if (status) return status;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    status = vmi_flow2_check_state(y);
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(VM_FLOW2_STATES, dydt);
    if (flow->n) vmi_sincos_of_angle(y[VM_FLOW2_ANGLE], &sine, &cosine);
    inverse = 1 / y[VM_FLOW2_MASS];
    vx = y[VM_FLOW2_P] * inverse;
    vy = y[VM_FLOW2_P + 1] * inverse;
    seen.sine = sine;
    seen.cosine = cosine;
    seen.vx = cosine * vx + sine * vy;
    seen.vy = cosine * vy - sine * vx;
    seen.omega = y[VM_FLOW2_H] / y[VM_FLOW2_INERTIA];
    seen.centre_x = y[VM_FLOW2_CENTRE];
    seen.centre_y = y[VM_FLOW2_CENTRE + 1];
    sum.fx = flow->fx;
    sum.fy = flow->fy;
    sum.moment = flow->moment;
    for (k = 0; k < flow->n; k++) {
        if (!vmi_stream_motion_is_known(flow->streams[k].motion)) return flow->status = VM_BAD_ARGUMENT;
        vmi_stream_add2(flow->streams + k, &seen, &sum);
    }
    sx = sum.sx * inverse;
    sy = sum.sy * inverse;
    dydt[VM_FLOW2_X] = vx + cosine * sx - sine * sy;
    dydt[VM_FLOW2_X + 1] = vy + sine * sx + cosine * sy;
    dydt[VM_FLOW2_ANGLE] = seen.omega;
    dydt[VM_FLOW2_P] = sum.fx + sum.carried * vx + cosine * sum.px - sine * sum.py;
    dydt[VM_FLOW2_P + 1] = sum.fy + sum.carried * vy + sine * sum.px + cosine * sum.py;
    dydt[VM_FLOW2_H] = sum.moment;
    dydt[VM_FLOW2_MASS] = sum.rate;
    dydt[VM_FLOW2_CENTRE] = sx;
    dydt[VM_FLOW2_CENTRE + 1] = sy;
    dydt[VM_FLOW2_INERTIA] = sum.inertia;
    return 0;
}

#endif
/* mechanics/flow1.h - translation, and bodies on a line or an axle, with streams of mass

   These right-hand sides describe motions with streams of mass that need fewer states than a free body in space:
   translation in space (172), straight motion (175), (176), and rotation about a fixed axle (173a). The equation of
   rotation is that of straight motion, with the moment of inertia instead of the mass.

       vm_stream1 jet = {-1, -2000, VM_RELATIVE}; // 1 kg/s leaves at 2000 m/s backwards
       vm_flow1 flow;
       vm_real y[VM_FLOW1_STATES] = {0, 0, 100}; // at rest, 100 kg
       vm_real dydt[VM_FLOW1_STATES];
       memset(&flow, 0, sizeof flow);
       flow.n = 1;
       flow.streams = &jet;
       int status = vm_flow1_rhs(0, y, dydt, &flow); // or integrate it: rk45_init(&s, vm_flow1_rhs, &flow, ...)

   Tests: tests/test_flow1.c. */
#ifndef VARMASS_MECHANICS_FLOW1_H
#define VARMASS_MECHANICS_FLOW1_H

/* Indices of the states of vm_translation_rhs in y, and their number */
enum {
    VM_TRANSLATION_R = 0,    /* position of the mass centre, 3 numbers, m */
    VM_TRANSLATION_P = 3,    /* momentum, 3 numbers, kg m/s */
    VM_TRANSLATION_MASS = 6, /* mass, kg */
    VM_TRANSLATION_STATES = 7
};

/* Indices of the states of vm_flow1_rhs in y, and their number. For an axle the states are the angle (rad), the
   angular momentum (kg m^2/s) and the moment of inertia about the axle (kg m^2). */
enum {
    VM_FLOW1_X = 0,    /* position, m */
    VM_FLOW1_P = 1,    /* momentum, kg m/s */
    VM_FLOW1_MASS = 2, /* mass, kg */
    VM_FLOW1_STATES = 3
};

/* A stream of mass that enters or leaves a body on a line or an axle. For an axle let M' be the mass per time, rho the
   distance of the mass from the axle and kappa its gyration (inertia per unit mass). Then `rate` is M' (kappa + rho^2),
   and `velocity` is the angular momentum of the stream per unit mass divided by kappa + rho^2. */
typedef struct VM_TAG(vm_stream1) {
    vm_real rate;     /* mass per time, kg/s (axle: kg m^2/s); > 0: mass joins, < 0: mass leaves */
    vm_real velocity; /* velocity of the stream's mass, m/s (axle: rad/s) */
    int motion;       /* how the velocity is given: VM_RELATIVE, VM_ABSOLUTE, VM_CARRIED, VM_AT_REST */
} vm_stream1;

/* The streams and the load of a body on a line or an axle: the ctx of vm_flow1_rhs. Set the whole struct to 0 first. */
typedef struct VM_TAG(vm_flow1) {
    int n;               /* number of streams */
    vm_stream1 *streams; /* n streams, kept by the caller */
    vm_real force;       /* resultant of the outer forces, N (axle: their moment about the axle, N m) */
    /* NULL, or a function that is called before each evaluation and may set every field from t and y, as
       vm_flow.update does. It returns 0; another number ends the run. */
    int (*update)(vm_real t, const vm_real *y, struct VM_TAG(vm_flow1) * flow);
    void *ctx;  /* pointer for the caller's `update`; not used by the functions below */
    int status; /* VM_OK, or the reason why the last evaluations gave NaN or ended the run: see vm_flow.status */
} vm_flow1;

/* The velocity u of a stream's mass. v is the velocity of the body, and `given` is the field `velocity` of the stream.
   All three vectors have the same axes. */
VM_INLINE vm_vec3 vmi_translation_velocity(int motion, vm_vec3 v, vm_vec3 given)
{
    vm_vec3 u = vmi_vec3(0, 0, 0);
    if (vmi_stream_moves_with_body(motion)) u = v;
    if (vmi_stream_velocity_is_given(motion)) u = vmi_add(u, given);
    return u;
}

/* Evaluates the right-hand side of vm_translation_rhs; flow->update has been called before */
VM_INLINE int vmi_translation_rates(vm_flow *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real mass = y[VM_TRANSLATION_MASS];
    const vm_vec3 v = vmi_scale(1 / mass, vmi_get3(y + VM_TRANSLATION_P));
    vm_real rate = 0;
    vm_vec3 force = flow->force;
    int k, status = VM_OK;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < VM_TRANSLATION_STATES) return flow->status = VM_SHORT_ARRAY;
    if (!(mass > 0)) status = VM_BAD_MASS;
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(VM_TRANSLATION_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream *s = flow->streams + k;
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        rate += s->rate;
        force = vmi_add(force, vmi_scale(s->rate, vmi_translation_velocity(s->motion, v, s->velocity)));
    }
    vmi_set3(dydt + VM_TRANSLATION_R, v);
    vmi_set3(dydt + VM_TRANSLATION_P, force);
    dydt[VM_TRANSLATION_MASS] = rate;
    return 0;
}

/* Calls flow->update, then evaluates the rates. This function is not inlined, so that a flow without `update` need
   not save registers for this call. */
VMI_APART int vmi_translation_updated_rates(vm_real t, const vm_real *y, vm_real *dydt, vm_flow *flow)
{
    const int status = flow->update(t, y, flow);
    if (status) return status;
    return vmi_translation_rates(flow, y, dydt);
}

/* Right-hand side of a body in translation with streams of mass: r' = p/M, p' = F + sum M' u (172).
   An ode_rhs of VM_TRANSLATION_STATES states; ctx is a vm_flow, of which n, streams, force, update, y_size and status
   are used. r is the position, p the momentum, M the mass, F the outer force, M' the rate of a stream and u the
   velocity of its mass. Body axes are parallel to the inertial axes. The fields at, spin, gyration and from of the
   streams are not read. Returns 0; or VM_BAD_ARGUMENT for a null pointer, n < 0 or an unknown `motion` of a stream,
   VM_SHORT_ARRAY if y_size is too small, or the number that flow.update returns, each of which ends the run. */
VM_API int vm_translation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    vm_flow *f = (vm_flow *)flow;
    if (f->update) return vmi_translation_updated_rates(t, y, dydt, f);
    return vmi_translation_rates(f, y, dydt);
}

/* Evaluates the right-hand side of vm_flow1_rhs; flow->update has been called before */
VM_INLINE int vmi_flow1_rates(vm_flow1 *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real v = y[VM_FLOW1_P] / y[VM_FLOW1_MASS];
    vm_real force = flow->force, rate = 0;
    int k, status = VM_OK;
    if (!vmi_flow_has_streams(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (!(y[VM_FLOW1_MASS] > 0)) status = VM_BAD_MASS;
    if (vmi_flow_note_status(&flow->status, status)) return vmi_flow_reject_step(VM_FLOW1_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream1 *s = flow->streams + k;
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        rate += s->rate;
        force += s->rate * vmi_stream_velocity1(s->motion, v, s->velocity);
    }
    dydt[VM_FLOW1_X] = v;
    dydt[VM_FLOW1_P] = force;
    dydt[VM_FLOW1_MASS] = rate;
    return 0;
}

/* Calls flow->update, then evaluates the rates. The comment on vmi_translation_updated_rates says why it is not
   inlined. */
VMI_APART int vmi_flow1_updated_rates(vm_real t, const vm_real *y, vm_real *dydt, vm_flow1 *flow)
{
    const int status = flow->update(t, y, flow);
    if (status) return status;
    return vmi_flow1_rates(flow, y, dydt);
}

/* Right-hand side of a body on a line or an axle with streams of mass, (173a), (175), (176).
   An ode_rhs of VM_FLOW1_STATES states; ctx is a vm_flow1. The position x, the momentum p and the mass M change by
   x' = p/M, p' = F + sum of M_i u_i, M' = sum of M_i, with the outer force F, the streams' rates M_i and the
   velocities u_i of their mass. Returns 0; or VM_BAD_ARGUMENT for a null pointer, n < 0 or an unknown `motion` of a
   stream, or the number that flow.update returns, each of which ends the run. */
VM_API int vm_flow1_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow1)
{
    if (!y || !dydt || !flow1) return VM_BAD_ARGUMENT;
    vm_flow1 *f = (vm_flow1 *)flow1;
    if (f->update) return vmi_flow1_updated_rates(t, y, dydt, f);
    return vmi_flow1_rates(f, y, dydt);
}

#endif
/* mechanics/rocket.h - closed forms: velocity by momentum, Tsiolkovsky's rocket, linear flow, jet damping

   These are motions with streams of mass that need no integrator: the velocity of a body from its mass alone, (151),
   (171) and (175), (176); the motion along a line at a constant rate of mass; and the spin of a rocket whose jet
   damps it, from Euler's equations. The formulas stay accurate as the rate of mass tends to zero.

       vm_real v = vm_tsiolkovsky(0, 100, 40, -2500); // m/s: from 100 kg to 40 kg, jet at 2500 m/s backwards

   Tests: tests/test_flow1.c. */
#ifndef VARMASS_MECHANICS_ROCKET_H
#define VARMASS_MECHANICS_ROCKET_H

/* A spinning axisymmetric body. The mass that it loses comes from around the mass centre and leaves through a nozzle on
   the axis (rate < 0), or mass flows the opposite way (rate > 0). The mass centre does not move in the body. The z axis
   is the axis of symmetry. */
typedef struct VM_TAG(vm_jet) {
    vm_real rate;                /* mass per time, kg/s; < 0: mass leaves */
    vm_real axial;               /* moment of inertia C0 about the axis at t = 0, kg m^2 */
    vm_real transverse;          /* moment of inertia A0 about a transverse axis at t = 0, kg m^2 */
    vm_real gyration_axial;      /* inertia per unit mass about the axis, in the body and in the nozzle, m^2 */
    vm_real gyration_transverse; /* inertia per unit mass about a transverse axis, of the mass in the body, m^2 */
    vm_real gyration_out;        /* inertia per unit mass about a transverse axis, of the mass in the nozzle, m^2 */
    vm_real nozzle;              /* distance of the nozzle from the mass centre, m */
} vm_jet;

VM_API int vmi_masses_are_good(vm_real m0, vm_real m)
{
    return m0 > 0 && m > 0 && VM_IS_FINITE(m0) && VM_IS_FINITE(m);
}

/* Velocity after a stream with the absolute velocity u changes the mass from m0 to m (151), (171).
   v0 (m/s) is the velocity at mass m0 (kg), u is in m/s, and impulse (N s) is that of the outer forces during the
   change. The case u = 0 is that of Levi-Civita. About a fixed axle this formula gives the angular velocity, with
   moments of inertia instead of masses. Returns NaN if a mass is not positive and for infinite arguments. */
VM_API vm_real vm_velocity_by_momentum(vm_real v0, vm_real m0, vm_real m, vm_real u, vm_real impulse)
{
    if (!vmi_masses_are_good(m0, m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(u) || !VM_IS_FINITE(impulse)) return VM_NAN;
    return v0 * (m0 / m) + ((m - m0) * u + impulse) / m;
}

/* Velocity of Tsiolkovsky's rocket after its mass changes from m0 to m: v0 + w ln(m/m0), (175), (176).
   v0 (m/s) is the velocity at mass m0 (kg), and w (m/s) is the velocity, relative to the body, of the mass that joins
   or leaves. There is no outer force. About a fixed axle this formula gives the angular velocity, with moments of
   inertia instead of masses. The error is at most 4 eps of |v0| + |w ln(m/m0)|. Returns NaN if a mass is not positive
   and for infinite arguments. */
VM_API vm_real vm_tsiolkovsky(vm_real v0, vm_real m0, vm_real m, vm_real w)
{
    vm_two l;
    if (!vmi_masses_are_good(m0, m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(w)) return VM_NAN;
    if (m < 2 * m0 && m0 < 2 * m) l = vmi_two_log(vmi_two_sum(1, (m - m0) / m0)); /* m - m0 is exact here */
    else l = vmi_two_plus(vmi_log(m), vmi_minus(vmi_log(m0)));
    return v0 + w * l.hi;
}

/* Sets *first = ln(1 + x)/x and *second = (x - ln(1 + x))/x^2 for -1 < x < 1e299 (float 1e34). For other x they are
   NaN. In a flow at constant rate let s be the fraction of the time that has passed, and m = 1 + x s the mass divided
   by its initial value. Then *first is the mean of 1/m over s, and *second the mean of s/m. */
VM_API void vmi_stream_log_means(vm_real x, vm_real *first, vm_real *second)
{
    const vm_two whole = vmi_two(x, 0), l = vmi_log1p(whole);
    *second = vmi_log1p_rest(whole, l).hi;
    if (VM_FABS(x) < VM_EPSILON) *first = 1 - x / 2;
    else *first = l.hi / x;
}

/* Position and velocity on a line after t seconds of a stream of constant rate.
   x0 (m), v0 (m/s) and m0 (kg) belong to t = 0. The force (N), the rate and the velocity of the stream are constant.
   t may be negative. With tau = rate t/m0, m = m0 + rate t, L = ln(1 + tau)/tau and B = (tau - ln(1 + tau))/tau^2,
   for an absolute velocity u:
     v = v0 + (force + rate (u - v0)) t/m,        x = x0 + v0 t + (force + rate (u - v0)) B t^2/m0;
   for a velocity w relative to the body:
     v = v0 + (force + rate w) L t/m0,            x = x0 + v0 t + (force + rate w) (L - B) t^2/m0.
   For every rate >= 0 the errors of x and v are at most 8 eps times the terms of their sums. If mass leaves, this bound
   grows with m0/m, because the rounding error of rate t is large relative to a small m. Returns VM_BAD_ARGUMENT,
   VM_NOT_FINITE, VM_BAD_MASS if m0 or m is not positive, and VM_OK otherwise. */
VM_API int vm_linear_flow(const vm_stream1 *stream, vm_real t, vm_real x0, vm_real v0, vm_real m0, vm_real force,
                          vm_real *x, vm_real *v)
{
    vm_real tau, first, second, difference, given = 0, acceleration, result[2];
    if (!stream || !x || !v || !vmi_stream_motion_is_known(stream->motion)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(stream->rate) || !VM_IS_FINITE(stream->velocity) || !VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(x0) || !VM_IS_FINITE(v0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(force)) return VM_NOT_FINITE;
    if (!(m0 > 0)) return VM_BAD_MASS;
    tau = stream->rate * t / m0;
    if (!VM_IS_FINITE(tau)) return VM_NOT_FINITE;
    if (!(tau > -1)) return VM_BAD_MASS;
    vmi_stream_log_means(tau, &first, &second);
    if (vmi_stream_velocity_is_given(stream->motion)) given = stream->velocity;
    if (vmi_stream_moves_with_body(stream->motion)) {
        difference = first - second;
        if (tau < VM_C(-0.5)) difference = ((1 + tau) * first - 1) / tau; /* first - second would cancel */
        acceleration = (force + stream->rate * given) / m0;
        result[0] = x0 + t * (v0 + acceleration * t * difference);
        result[1] = v0 + acceleration * t * first;
    } else {
        acceleration = (force + stream->rate * (given - v0)) / m0;
        result[0] = x0 + t * (v0 + acceleration * t * second);
        result[1] = v0 + acceleration * t / (1 + tau);
    }
    if (!vmi_all_finite(2, result)) return VM_NOT_FINITE;
    *x = result[0];
    *v = result[1];
    return VM_OK;
}

VM_API int vmi_jet_finite(const vm_jet *jet)
{
    return VM_IS_FINITE(jet->rate) && VM_IS_FINITE(jet->axial) && VM_IS_FINITE(jet->transverse) &&
           VM_IS_FINITE(jet->gyration_axial) && VM_IS_FINITE(jet->gyration_transverse) &&
           VM_IS_FINITE(jet->gyration_out) && VM_IS_FINITE(jet->nozzle);
}

/* Angular velocity of a spinning rocket whose jet damps it, after t seconds, rad/s, body axes.
   There are no outer loads. With the moments of inertia A = A0 + rate gyration_transverse t and C = C0 + rate
   gyration_axial t the transverse part omega_t of omega has the length
     |omega_t| = |omega_t0| (A/A0)^((nozzle^2 + gyration_out)/gyration_transverse - 1),
   where omega_t0 is omega_t at t = 0. omega_z stays constant, and omega_t turns by omega_z times the integral of C/A -
   1 over time. Let L and B be the functions of tau of vm_linear_flow, here with tau = rate gyration_transverse t/A0.
   Then ln(A/A0) is tau L, and the integral is t (L C0/A0 - 1 + B rate t gyration_axial/A0). The error is at most 8
   times the change that an error of eps in the inputs makes. Returns VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_INERTIA if
   A or C is not positive, and VM_OK otherwise. */
VM_API int vm_jet_damping(const vm_jet *jet, vm_real t, vm_vec3 omega0, vm_vec3 *omega)
{
    vm_real change, tau, first, second, exponent, share, angle, sine, cosine;
    vm_vec3 later;
    if (!jet || !omega) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_vec3_is_finite(omega0) || !vmi_jet_finite(jet)) return VM_NOT_FINITE;
    if (!(jet->axial > 0 && jet->transverse > 0)) return VM_BAD_INERTIA;
    change = jet->rate * t / jet->transverse;
    tau = change * jet->gyration_transverse;
    exponent = change * (jet->nozzle * jet->nozzle + jet->gyration_out - jet->gyration_transverse);
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(exponent)) return VM_NOT_FINITE;
    if (!(tau > -1 && jet->axial + jet->rate * t * jet->gyration_axial > 0)) return VM_BAD_INERTIA;
    vmi_stream_log_means(tau, &first, &second);
    share = vmi_exp(exponent * first, 0);
    angle = omega0.z * t * (jet->axial / jet->transverse * first - 1 + change * jet->gyration_axial * second);
    vmi_sincos(angle, &sine, &cosine);
    later = vmi_vec3(share * (omega0.x * cosine - omega0.y * sine), share * (omega0.y * cosine + omega0.x * sine),
                     omega0.z);
    if (!vmi_vec3_is_finite(later)) return VM_NOT_FINITE;
    *omega = later;
    return VM_OK;
}

#endif
/* mechanics/supply.h - tanks and grains: mass, mass centre and inertia follow from the mass that is left

   A supply is a round cylinder of stored mass inside a body: a tank of liquid, whose level falls; a tank of gas, whose
   density falls; or a hollow cylinder of solid propellant (a grain), which burns radially outwards. The mass that is
   left determines its mass centre, its inertia and their rates, and also the store (vm_store) from which a stream takes
   the next mass. With this store the moments that streams exert, jet damping among them, are right.

       vm_supply tank = {VM_TANK_OF_LIQUID, {0, 0, -2}, {0, 0, 1}, 3, 0.5, 0, 800}; // 3 m long, radius 0.5 m, 800 kg
       vm_supply_left left;
       if (vm_supply_at(&tank, 200, &left) == VM_OK) printf("level %g m\n", left.size); // 0.75 m: a quarter is left

   The equations. Let m be the mass that is left, m1 that of the full supply, L the length, R the radius, e the unit
   vector along the axis from the lower end to the upper one, E the unit matrix, and b the lower end of the axis. The
   inertia about the mass centre c is m [k_a e e^T + k_t (E - e e^T)]. The next mass lies at the point s, and its
   inertia per unit mass is q_a e e^T + q_t (E - e e^T).
     liquid  level h = L m/m1, c = b + e h/2, k_a = R^2/2, k_t = R^2/4 + h^2/12; s = b + e h, q_a = R^2/2, q_t = R^2/4
     gas     c = s = b + e L/2, k_a = q_a = R^2/2, k_t = q_t = R^2/4 + L^2/12
     grain   bore r, r^2 = (m r0^2 + (m1 - m) R^2)/m1 with the bore r0 of the full grain, c = s = b + e L/2,
             k_a = (R^2 + r^2)/2, k_t = (R^2 + r^2)/4 + L^2/12, q_a = r^2, q_t = r^2/2 + L^2/12
   They follow from the volumes. Moments about a fixed point give the identities d(m c)/dm = s and dI/dm = Q + P(s - c),
   where I is the inertia about c, Q the inertia of the next mass per unit mass, and P(d) = |d|^2 E - d d^T.
   Tests: tests/test_supply.c. */
#ifndef VARMASS_MECHANICS_SUPPLY_H
#define VARMASS_MECHANICS_SUPPLY_H

/* The kinds of supplies */
enum {
    VM_TANK_OF_LIQUID = 0, /* constant density; the tank empties from the lower end, and its surface stays normal to the
                              axis. The liquid turns with the tank */
    VM_TANK_OF_GAS = 1,    /* constant volume; the density falls everywhere alike */
    VM_GRAIN = 2           /* constant density; a hollow cylinder that burns from its bore outwards, not at its ends */
};

/* A supply of mass inside a body */
typedef struct VM_TAG(vm_supply) {
    int kind;       /* VM_TANK_OF_LIQUID, VM_TANK_OF_GAS or VM_GRAIN */
    vm_vec3 at;     /* centre of the lower end, from the body's reference point, m, body axes */
    vm_vec3 axis;   /* direction from the lower end to the upper end, of any length but 0, body axes */
    vm_real length; /* distance of the ends, m; that of a tank of liquid when it is full */
    vm_real radius; /* outer radius, m */
    vm_real bore;   /* inner radius of the full grain, m, 0 <= bore < radius; not used by the tanks */
    vm_real full;   /* mass of the full supply, kg */
} vm_supply;

/* What is left of a supply. The rates are derivatives with respect to the mass that is left; multiply them by its rate
   in kg/s (< 0 while the supply empties) to get rates in time. */
typedef struct VM_TAG(vm_supply_left) {
    vm_real mass;               /* mass that is left, kg */
    vm_real size;               /* level of the liquid above the lower end, length of the gas, or bore of the grain, m */
    vm_vec3 centre;             /* mass centre, from the body's reference point, m, body axes */
    vm_inertia inertia;         /* inertia about this mass centre, kg m^2, body axes */
    vm_vec3 centre_by_mass;     /* rate of the mass centre, m/kg */
    vm_inertia inertia_by_mass; /* rate of the inertia, m^2 */
    vm_store store;             /* where the next mass that leaves lies, for the field `from` of a vm_stream */
} vm_supply_left;

/* The tensor axial e e^T + transverse (E - e e^T) for a unit vector e and the unit matrix E. The diagonal entries are
   sums of positive terms. */
VM_API vm_inertia vmi_inertia_of_revolution(vm_vec3 e, vm_real axial, vm_real transverse)
{
    const vm_real difference = axial - transverse;
    vm_inertia i;
    i.xx = axial * (e.x * e.x) + transverse * (e.y * e.y + e.z * e.z);
    i.yy = axial * (e.y * e.y) + transverse * (e.x * e.x + e.z * e.z);
    i.zz = axial * (e.z * e.z) + transverse * (e.x * e.x + e.y * e.y);
    i.xy = difference * (e.x * e.y);
    i.xz = difference * (e.x * e.z);
    i.yz = difference * (e.y * e.z);
    return i;
}

VM_API int vmi_supply_check(const vm_supply *s, vm_real mass)
{
    if (s->kind < VM_TANK_OF_LIQUID || s->kind > VM_GRAIN) return VM_BAD_ARGUMENT;
    if (!vmi_vec3_is_finite(s->at) || !vmi_vec3_is_finite(s->axis) || !VM_IS_FINITE(s->length)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(s->radius) || !VM_IS_FINITE(s->bore) || !VM_IS_FINITE(s->full)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(mass)) return VM_NOT_FINITE;
    if (!(s->full > 0)) return VM_BAD_MASS;
    if (!(s->length > 0 && s->radius > 0) || vmi_norm_max(s->axis) == 0) return VM_DOMAIN;
    if (s->kind == VM_GRAIN && !(s->bore >= 0 && s->bore < s->radius)) return VM_DOMAIN;
    return VM_OK;
}

/* Writes to *left what is left of a tank of liquid; e is the unit vector along the axis */
VM_API void vmi_supply_liquid(const vm_supply *s, vm_vec3 e, vm_supply_left *left)
{
    const vm_real m = left->mass, level = s->length * (m / s->full), disc = s->radius * s->radius / 4;
    const vm_real slope = s->length / s->full / 2;
    left->size = level;
    left->centre = vmi_add(s->at, vmi_scale(level / 2, e));
    left->centre_by_mass = vmi_scale(slope, e);
    left->inertia = vmi_inertia_of_revolution(e, m * (2 * disc), m * (disc + level * level / 12));
    left->inertia_by_mass = vmi_inertia_of_revolution(e, 2 * disc, disc + level * level / 4);
    left->store.at = vmi_add(s->at, vmi_scale(level, e));
    left->store.gyration = vmi_inertia_of_revolution(e, 2 * disc, disc);
}

/* Writes to *left what is left of a tank of gas or of a grain. The square of the bore is that of the text at the top;
   it is 0 for gas, which leaves everywhere alike. */
VM_API void vmi_supply_hollow(const vm_supply *s, vm_vec3 e, vm_supply_left *left)
{
    const vm_real m = left->mass, square = s->radius * s->radius, rod = s->length * s->length / 12;
    vm_real bore = 0, axial = square / 2, transverse = square / 4;
    left->size = s->length;
    if (s->kind == VM_GRAIN) {
        bore = (m * (s->bore * s->bore) + (s->full - m) * square) / s->full;
        left->size = bore > 0 ? VM_SQRT(bore) : 0;
        axial = bore;
        transverse = bore / 2;
    }
    left->centre = left->store.at = vmi_add(s->at, vmi_scale(s->length / 2, e));
    left->centre_by_mass = vmi_vec3(0, 0, 0);
    left->inertia = vmi_inertia_of_revolution(e, m * ((square + bore) / 2), m * ((square + bore) / 4 + rod));
    left->inertia_by_mass = left->store.gyration = vmi_inertia_of_revolution(e, axial, transverse + rod);
}

VM_API int vmi_supply_left_is_finite(const vm_supply_left *left)
{
    return VM_IS_FINITE(left->size) && vmi_vec3_is_finite(left->centre) && vmi_vec3_is_finite(left->centre_by_mass) &&
           vmi_inertia_is_finite(&left->inertia) && vmi_inertia_is_finite(&left->inertia_by_mass) &&
           vmi_vec3_is_finite(left->store.at) && vmi_inertia_is_finite(&left->store.gyration);
}

/* What is left of a tank or grain when its mass is `mass`: mass centre, inertia, their rates, and the next store.
   mass is in kg and lies between 0 and supply.full. Beyond both ends the formulas go on as polynomials of the mass, so
   that trial steps of an integrator see smooth functions, but what they then describe is no body. The errors are at
   most 8 eps of |at| + length, of the largest entry of a tensor and of the rate, next to an empty or full supply too.
   Returns VM_BAD_ARGUMENT for a null pointer or an unknown kind, VM_NOT_FINITE, VM_BAD_MASS if supply.full is not
   positive, VM_DOMAIN for a length, radius, bore or axis outside its domain, and VM_OK otherwise. */
VM_API int vm_supply_at(const vm_supply *supply, vm_real mass, vm_supply_left *left)
{
    vm_supply_left result;
    vm_vec3 e;
    int status;
    if (!supply || !left) return VM_BAD_ARGUMENT;
    status = vmi_supply_check(supply, mass);
    if (status) return status;
    e = vmi_over(supply->axis, vmi_norm_max(supply->axis));
    e = vmi_over(e, VM_SQRT(vmi_dot(e, e)));
    result.mass = mass;
    if (supply->kind == VM_TANK_OF_LIQUID) vmi_supply_liquid(supply, e, &result);
    else vmi_supply_hollow(supply, e, &result);
    if (!vmi_supply_left_is_finite(&result)) return VM_NOT_FINITE;
    *left = result;
    return VM_OK;
}

#endif
/* mechanics/orbit.h - two bodies that attract each other, with constant masses and with masses that change

   The vector r from one body to the other obeys r'' = -mu r/|r|^3 with mu = G (M1 + M2), if mass that leaves or joins has
   the velocity of its body (reactive = 0). vm_orbit solves this equation for constant mu (Kepler's problem), for
   ellipses, parabolas, hyperbolas and straight lines alike. vm_orbit_meshchersky solves it for Meshchersky's law
   mu/(1 + c t), one of Gylden's problems of variable mass that have a closed form. The scene with vm_effect_gravitation
   takes any law of mass.

       vm_vec3 r = {7e6, 0, 0}, v = {0, 7.6e3, 0}; // m, m/s
       vm_orbit(3600, 3.986004418e14, r, v, &r, &v); // an hour later; the results may be the inputs

   The equations. Lengths are in units of |r0|, times in units of sqrt(|r0|^3/mu). With sigma = r0 v0 (their dot product)
   and beta = 2 - v0^2, and the functions of Stumpff in the form
     G1 = s - beta s^3/3! + ..., G2 = s^2/2! - beta s^4/4! + ..., G3 = s^3/3! - beta s^5/5! + ...
   (sines and cosines of sqrt(beta) s for beta > 0, hyperbolic ones for beta < 0), the time is t = s + sigma G2 +
   (1 - beta) G3, and its derivative dt/ds = 1 + sigma G1 + (1 - beta) G2 is the distance R. Then
     r = (1 - G2) r0 + (t - G3) v0,  v = -G1/R r0 + (1 - G2/R) v0.
   Meshchersky's law: with f = 1 + c t, r = f xi and the time tau = t/f, xi obeys the equation for constant mu.
   Tests: tests/test_orbit.c. */
#ifndef VARMASS_MECHANICS_ORBIT_H
#define VARMASS_MECHANICS_ORBIT_H

/* The functions G1, G2, G3 of the text above */
typedef struct VM_TAG(vmi_stumpff) {
    vm_real g1, g2, g3;
} vmi_stumpff;

/* The functions by their series, for |beta| s^2 <= 4, where the first omitted term is below 1e-18 of the sum */
VM_API vmi_stumpff vmi_stumpff_series(vm_real beta, vm_real s)
{
    const vm_real x = beta * s * s;
    vm_real c2 = 1, c3 = 1;
    vmi_stumpff g;
    int k;
    for (k = 11; k > 0; k--) {
        c2 = 1 - x * c2 / (vm_real)((2 * k + 1) * (2 * k + 2));
        c3 = 1 - x * c3 / (vm_real)((2 * k + 2) * (2 * k + 3));
    }
    c2 /= 2;
    c3 /= 6;
    g.g1 = s * (1 - x * c3);
    g.g2 = s * s * c2;
    g.g3 = s * s * s * c3;
    return g;
}

/* The functions for any beta and s >= 0. Where e^(sqrt(-beta) s) overflows they are infinite. */
VM_API vmi_stumpff vmi_stumpff_at(vm_real beta, vm_real s)
{
    const vm_real root = VM_SQRT(VM_FABS(beta)), z = root * s;
    vm_real sine, cosine, half;
    vmi_stumpff g;
    if (z <= 2) return vmi_stumpff_series(beta, s);
    if (beta > 0) {
        vmi_sincos(z / 2, &half, &cosine);
        vmi_sincos(z, &sine, &cosine);
        g.g3 = (z - sine) / (root * root * root);
    } else {
        const vm_real growing = vmi_exp(z / 2, 0);
        half = (growing - 1 / growing) / 2;
        sine = half * (growing + 1 / growing);
        g.g3 = (sine - z) / (root * root * root);
    }
    g.g1 = sine / root;
    g.g2 = 2 * (half / root) * (half / root);
    return g;
}

/* Kepler's problem in the units of the text above */
typedef struct VM_TAG(vmi_orbit) {
    vm_real sigma; /* r0 v0 */
    vm_real beta;  /* 2 - v0^2; the energy is -beta/2 */
} vmi_orbit;

/* What belongs to a value of the variable s */
typedef struct VM_TAG(vmi_orbit_point) {
    vmi_stumpff g;
    vm_real time, distance;
    vm_real noise; /* sum of the absolute values of the terms of `time`, times 4 VM_EPSILON */
} vmi_orbit_point;

VM_API vmi_orbit_point vmi_orbit_at(const vmi_orbit *o, vm_real s)
{
    vmi_orbit_point p;
    vm_real first, second;
    p.g = vmi_stumpff_at(o->beta, s);
    first = o->sigma * p.g.g2;
    second = (1 - o->beta) * p.g.g3;
    p.time = s + (first + second);
    p.noise = 4 * VM_EPSILON * (s + VM_FABS(first) + VM_FABS(second));
    p.distance = 1 + (o->sigma * p.g.g1 + (1 - o->beta) * p.g.g2);
    return p;
}

/* Finds the variable s >= 0 at the time t >= 0 and returns what belongs to it. The time rises with s, so that Newton's
   steps are kept between bounds of s that close in. A step that leaves them, or that is longer than half the step
   before, is replaced by doubling or halving. On a fast hyperbola, where the time rises exponentially, Newton's steps
   alone would be too many. */
VM_API vmi_orbit_point vmi_orbit_solve(const vmi_orbit *o, vm_real t)
{
    const int most = 3 * VM_MANT_DIG; /* halving alone needs VM_MANT_DIG steps, Newton's steps are fewer */
    vm_real low = 0, high = VM_INFINITY, s = vmi_smaller(t, 1), before = VM_INFINITY;
    vmi_orbit_point p = vmi_orbit_at(o, s);
    int i;
    for (i = 0; i < most; i++) {
        const vm_real late = p.time - t, step = late / p.distance;
        vm_real next = s - step;
        if (VM_FABS(late) <= vmi_smaller(p.noise, t) || VM_FABS(step) <= VM_EPSILON * s) break;
        if (late < 0) low = s;
        else high = s; /* also where the time is infinite or NaN */
        if (!(next > low && next < high && 2 * VM_FABS(step) <= before)) {
            next = (low + high) / 2;
            if (high == VM_INFINITY) next = 2 * s;
        }
        if (high == VM_INFINITY) next = vmi_smaller(next, 16 * s); /* before the time overflows */
        if (next == s) break;
        before = VM_FABS(next - s);
        s = next;
        p = vmi_orbit_at(o, s);
    }
    return p;
}

/* Reduces the time t on an ellipse (beta > 0) by whole periods, to at most half a period on either side of 0 */
VM_API vm_real vmi_orbit_reduce(vm_real beta, vm_real t)
{
    vm_real period;
    if (!(beta > 0)) return t;
    period = 2 * VM_PI / (beta * VM_SQRT(beta));
    if (!(VM_FABS(t) > period / 2 && period > 0)) return t;
    return t - period * VM_FLOOR(t / period + VM_C(0.5));
}

/* Position and velocity after t seconds on an orbit about a centre with the attraction mu/r^2 (Kepler's problem).
   r0 (m) is the position relative to the centre and v0 (m/s) the velocity at t = 0; mu (m^3/s^2) is G times the mass in
   the centre, or G (M1 + M2) if r0 and v0 belong to two bodies, one relative to the other. t may be negative. The orbit
   may be an ellipse, a parabola, a hyperbola or a straight line; on a straight line the body turns back at the centre.
   The error is that which an error of a few eps in t, r0, v0 and mu makes; it grows with the number of revolutions.
   The cost is that of some ten sines. Returns VM_BAD_ARGUMENT, VM_NOT_FINITE also where the results are not finite,
   VM_DOMAIN for mu <= 0 or r0 = 0, and VM_OK otherwise. */
VM_API int vm_orbit(vm_real t, vm_real mu, vm_vec3 r0, vm_vec3 v0, vm_vec3 *r, vm_vec3 *v)
{
    vm_real distance0, speed, unit, time, sign = 1;
    vm_vec3 start, rate, position, velocity;
    vmi_orbit o;
    vmi_orbit_point p;
    if (!r || !v) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(mu) || !vmi_vec3_is_finite(r0) || !vmi_vec3_is_finite(v0)) return VM_NOT_FINITE;
    distance0 = vmi_norm2(r0);
    if (!(mu > 0 && distance0 > 0)) return VM_DOMAIN;
    speed = VM_SQRT(mu / distance0);
    unit = distance0 / speed;
    start = vmi_over(r0, distance0);
    rate = vmi_over(v0, speed);
    o.sigma = vmi_dot(start, rate);
    o.beta = 2 - vmi_dot(rate, rate);
    time = vmi_orbit_reduce(o.beta, t / unit);
    if (!VM_IS_FINITE(time) || !VM_IS_FINITE(o.beta)) return VM_NOT_FINITE;
    if (time < 0) {
        sign = -1;
        time = -time;
        o.sigma = -o.sigma;
        rate = vmi_scale(-1, rate);
    }
    p = vmi_orbit_solve(&o, time);
    position = vmi_add(vmi_scale(1 - p.g.g2, start), vmi_scale(time - p.g.g3, rate));
    velocity = vmi_sub(vmi_scale(1 - p.g.g2 / p.distance, rate), vmi_scale(p.g.g1 / p.distance, start));
    position = vmi_scale(distance0, position);
    velocity = vmi_scale(sign * speed, velocity);
    if (!vmi_vec3_is_finite(position) || !vmi_vec3_is_finite(velocity)) return VM_NOT_FINITE;
    *r = position;
    *v = velocity;
    return VM_OK;
}

/* Position and velocity after t seconds, while the attraction changes by Meshchersky's law mu/(1 + rate t).
   The two bodies lose mass (rate > 0, per second) or gain it (rate < 0) in the same proportion, and the mass that leaves
   or joins has the velocity of its body. The equation is that of Gylden and Meshchersky, r'' = -mu/(1 + rate t) r/|r|^3.
   The other arguments and the accuracy are those of vm_orbit. Returns VM_BAD_MASS if 1 + rate t is not positive, and
   the errors of vm_orbit. */
VM_API int vm_orbit_meshchersky(vm_real t, vm_real mu, vm_real rate, vm_vec3 r0, vm_vec3 v0, vm_vec3 *r, vm_vec3 *v)
{
    vm_vec3 position, velocity;
    vm_real f;
    int status;
    if (!r || !v) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(rate)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(mu) || !vmi_vec3_is_finite(r0) || !vmi_vec3_is_finite(v0)) return VM_NOT_FINITE;
    f = 1 + rate * t;
    if (!VM_IS_FINITE(f)) return VM_NOT_FINITE;
    if (!(f > 0)) return VM_BAD_MASS;
    status = vm_orbit(t / f, mu, r0, vmi_sub(v0, vmi_scale(rate, r0)), &position, &velocity);
    if (status) return status;
    velocity = vmi_add(vmi_over(velocity, f), vmi_scale(rate, position));
    position = vmi_scale(f, position);
    if (!vmi_vec3_is_finite(position) || !vmi_vec3_is_finite(velocity)) return VM_NOT_FINITE;
    *r = position;
    *v = velocity;
    return VM_OK;
}

#endif
/* mechanics/drum.h - a band that winds up on a drum

   A band that arrives at a constant velocity winds up on a drum, whose mass and inertia grow (chapter 5.2, Fig. 20).
   This chapter has
     - the geometry (181)-(188),
     - the exact equations of motion, and the reduced equations (192)-(193) of the dissertation,
     - the motion on a rigid shaft in closed form (194)-(206),
     - the vibrations of an elastic shaft (210)-(226).

   The band moves at the velocity v along y and meets the drum at S + (R, 0), where S is the centre of the shaft and R
   the radius. After the drum has turned by the angle phi, the band covers the arc from 0 to phi. The mass centre of
   this arc is in the direction phi/2. R stays constant, because only the first layer, 0 <= phi <= 2 pi, is considered.

   The fields of vm_drum name most letters of the formulas. In addition, mu is the band's mass per angle, j = mu R^2
   (186), and e = mu v R - D with the damping D. If e > 0, the band drives the drum. If e < 0, the drum comes to rest.

       vm_drum drum = {VM_C(0.2), 50, 1, VM_C(0.05), 10, VM_C(0.02), VM_C(1e5), 40}; // in the order of the fields
       vm_real angle = vm_drum_angle(&drum, 1); // rad, after 1 s on a rigid shaft

   Tests: tests/test_drum.c, tests/test_drum_shaft.c. */
#ifndef VARMASS_MECHANICS_DRUM_H
#define VARMASS_MECHANICS_DRUM_H

/* A drum, its shaft and the band */
typedef struct VM_TAG(vm_drum) {
    vm_real radius;    /* radius R of the drum, m */
    vm_real mass;      /* mass M0 > 0 of the empty drum, kg */
    vm_real inertia;   /* moment of inertia J0 > 0 of the empty drum about its axle, kg m^2 */
    vm_real band;      /* mass mu >= 0 of the band per angle, kg/rad; vm_drum_band computes it */
    vm_real speed;     /* velocity v of the band, m/s */
    vm_real damping;   /* damping D of the rotation, N m s */
    vm_real stiffness; /* stiffness c >= 0 of the shaft, N/m */
    vm_real omega;     /* initial angular velocity Omega_b > 0, at phi = 0, rad/s */
} vm_drum;

/* Geometry of the drum and of the band wound on it, when the drum has turned by the angle phi */
typedef struct VM_TAG(vm_drum_geometry) {
    vm_real mass;         /* mass M of drum and band (182), kg */
    vm_real arc_centre;   /* distance of the band's mass centre S' from the shaft S (184), m */
    vm_real offset;       /* distance from the shaft S to S1, the mass centre of drum and band, m;
                             S1 lies in the direction phi/2 from S [(185) corrected] */
    vm_real axle_inertia; /* inertia J_S of drum and band about the axle (187), kg m^2 */
    vm_real inertia;      /* inertia J_S1 of drum and band about S1 (188), kg m^2 */
} vm_drum_geometry;

/* Indices of the states of vm_drum_rhs and vm_drum_rhs_reduced in y, and the number of states */
enum {
    VM_DRUM_X = 0,     /* deflection of the shaft: position x, y of its centre S, m */
    VM_DRUM_ANGLE = 2, /* angle phi of the drum, rad */
    VM_DRUM_V = 3,     /* velocity x', y' of the shaft's centre S, m/s */
    VM_DRUM_OMEGA = 5, /* angular velocity phi' of the drum, rad/s */
    VM_DRUM_STATES = 6
};

/* Indices of the states of vm_drum_rhs_angle in y, and the number of states */
enum {
    VM_DRUM_DEFLECTION = 0, /* deflection of the shaft: position x, y of its centre S, m */
    VM_DRUM_SLOPE = 2,      /* derivatives dx/dphi, dy/dphi of the deflection, m/rad */
    VM_DRUM_ANGLE_STATES = 4
};

/* The elastic shaft in the first approximation, for small mu/M0, j/J0, e/(J0 Omega_b), with the letters of vm_drum,
   j = mu R^2 and e = mu v R - D. With ' = d/dphi, the deflection x satisfies
     x'' + 2 delta x' + k^2 (1 - A phi) x = 0 (213).
   The equation for y has mu v/(M0 Omega_b) on the right instead of 0 (214). */
typedef struct VM_TAG(vm_drum_shaft) {
    vm_real k;     /* frequency divided by angular velocity, sqrt(c/M0)/Omega_b, a pure number */
    vm_real delta; /* damping, 1/rad: (mu/M0 + e/(J0 Omega_b) - j/J0)/2 with mu = band, j = mu R^2, e = mu v R - D.
                      This corrects the coefficient in (213). */
    vm_real A;     /* relative decrease of the squared frequency, 1/rad: mu/M0 - 2 j/J0 + 2 e/(J0 Omega_b), with
                      mu, j, e as for delta. This corrects (213), too. */
    vm_real shift; /* displacement mu v/(M0 Omega_b k^2), m. The deflection y oscillates about shift/(1 - A phi). */
} vm_drum_shaft;

/* The band's mass per angle on a drum, mu = R h b rho (181), kg/rad.
   The radius R of the drum, the thickness h and the width b of the band are in m, the density rho in kg/m^3. NaN in
   an argument gives NaN. */
VM_API vm_real vm_drum_band(vm_real radius, vm_real thickness, vm_real width, vm_real density)
{
    return radius * thickness * width * density;
}

/* Mass and inertia of drum and band at the angle phi, for the equations of motion */
typedef struct VM_TAG(vmi_drum_mass) {
    vm_real M;       /* mass of drum and band, kg */
    vm_real J;       /* inertia of drum and band about the axle, kg m^2 */
    vm_real steiner; /* M times the squared distance of the mass centre from the axle, kg m^2: the
                        inertia about the mass centre is J - steiner */
} vmi_drum_mass;

/* Sets *m for the angle phi of the drum, where s is sin(phi/2). A call with s = 0 neglects the distance from the axle
   to the mass centre. Returns VM_OK, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS or VM_BAD_INERTIA. */
VM_API int vmi_drum_mass_at(const vm_drum *d, vm_real phi, vm_real s, vmi_drum_mass *m)
{
    const vm_real q = 2 * d->band * d->radius * s;
    m->M = d->mass + d->band * phi;
    m->J = d->inertia + d->band * d->radius * d->radius * phi;
    m->steiner = q / m->M * q; /* in this order, because q * q could underflow */
    if (!VM_IS_FINITE(m->M) || !VM_IS_FINITE(m->J)) return VM_NOT_FINITE;
    if (!(d->mass > 0) || !(m->M > 0)) return VM_BAD_MASS;
    if (d->stiffness < 0) return VM_BAD_STIFFNESS;
    if (!(m->J - m->steiner > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

VM_API int vmi_drum_finite(const vm_drum *d)
{
    return VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->mass) && VM_IS_FINITE(d->inertia) && VM_IS_FINITE(d->band) &&
           VM_IS_FINITE(d->speed) && VM_IS_FINITE(d->damping) && VM_IS_FINITE(d->stiffness) &&
           VM_IS_FINITE(d->omega);
}

/* Mass, mass centre and inertia of the drum with its band at an angle, (182)-(188).
   The angle phi >= 0 is in rad. Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS,
   VM_BAD_STIFFNESS for a negative stiffness, VM_BAD_INERTIA, VM_DOMAIN for phi < 0, and VM_OK otherwise. */
VM_API int vm_drum_at(const vm_drum *d, vm_real phi, vm_drum_geometry *g)
{
    vm_real s, c;
    vmi_drum_mass m;
    int status;
    if (!d || !g) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(phi) || !vmi_drum_finite(d)) return VM_NOT_FINITE;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->stiffness < 0) return VM_BAD_STIFFNESS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    if (phi < 0) return VM_DOMAIN;
    vmi_sincos(phi / 2, &s, &c);
    status = vmi_drum_mass_at(d, phi, s, &m);
    if (status) return status;
    g->mass = m.M;
    g->arc_centre = d->radius;
    if (phi > VM_MIN) g->arc_centre = d->radius * s / (phi / 2);
    g->offset = 2 * d->band * d->radius * s / m.M;
    g->axle_inertia = m.J;
    g->inertia = m.J - m.steiner;
    return VM_OK;
}

/* Right-hand side of the drum on an elastic shaft, exact.
   An ode_rhs of VM_DRUM_STATES states; ctx is a vm_drum. It replaces (177) and (191), which leave out that the mass
   centre moves inside the drum, and give the torque of the shaft the wrong sign. With the deflection rS = (xS, yS), the
   unit vector k along z and q = mu R (sin phi, 1 - cos phi), the equations are
     M rS'' + phi'' k x q - phi'^2 q = -c rS + mu phi' ((0, v) - rS' - phi' k x (R, 0))
     J_S phi'' + q x rS'' = -D phi' + mu phi' R (v - yS' - R phi')
   M is the mass of drum and band, J_S their inertia about the axle; vm_drum explains c, D, mu, v, R. Returns VM_OK; or
   VM_BAD_ARGUMENT for a null pointer, VM_BAD_STIFFNESS for a negative stiffness, and VM_NOT_FINITE, VM_BAD_MASS or
   VM_BAD_INERTIA if mass or inertia is impossible at this angle. Each of these errors ends the run. */
VM_API int vm_drum_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real phi = y[VM_DRUM_ANGLE], rate = y[VM_DRUM_OMEGA];
    const vm_real flow = d->band * rate, slip = d->speed - y[VM_DRUM_V + 1] - d->radius * rate;
    vm_real s, c, qx, qy, force_x, force_y, moment, turn; /* turn: the angular acceleration phi'' */
    vmi_drum_mass m;
    int status;
    (void)t;
    vmi_sincos(phi / 2, &s, &c);
    status = vmi_drum_mass_at(d, phi, s, &m);
    if (status) return status;
    qx = 2 * d->band * d->radius * s * c;
    qy = 2 * d->band * d->radius * s * s;
    force_x = -d->stiffness * y[VM_DRUM_X] - flow * y[VM_DRUM_V] + rate * rate * qx;
    force_y = -d->stiffness * y[VM_DRUM_X + 1] + flow * slip + rate * rate * qy;
    moment = -d->damping * rate + flow * d->radius * slip;
    turn = (moment - (qx * force_y - qy * force_x) / m.M) / (m.J - m.steiner);
    dydt[VM_DRUM_X] = y[VM_DRUM_V];
    dydt[VM_DRUM_X + 1] = y[VM_DRUM_V + 1];
    dydt[VM_DRUM_ANGLE] = rate;
    dydt[VM_DRUM_V] = (force_x + turn * qy) / m.M;
    dydt[VM_DRUM_V + 1] = (force_y - turn * qx) / m.M;
    dydt[VM_DRUM_OMEGA] = turn;
    return VM_OK;
}

/* Right-hand side of the drum on an elastic shaft for a light band, (192), (193).
   An ode_rhs of VM_DRUM_STATES states; ctx is a vm_drum. These are the equations of vm_drum_rhs for a small mass mu of
   the band per angle. Unlike (192) they contain the unbalance mu R phi'^2 (sin phi, -cos phi), because it is of the
   same order as the terms that (192) keeps. The errors are those of vm_drum_rhs. */
VM_API int vm_drum_rhs_reduced(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real rate = y[VM_DRUM_OMEGA], vx = y[VM_DRUM_V], vy = y[VM_DRUM_V + 1];
    const vm_real flow = d->band * rate, unbalance = flow * d->radius * rate;
    vm_real s, c;
    vmi_drum_mass m;
    int status;
    (void)t;
    vmi_sincos(y[VM_DRUM_ANGLE], &s, &c);
    status = vmi_drum_mass_at(d, y[VM_DRUM_ANGLE], 0, &m);
    if (status) return status;
    dydt[VM_DRUM_X] = vx;
    dydt[VM_DRUM_X + 1] = vy;
    dydt[VM_DRUM_ANGLE] = rate;
    dydt[VM_DRUM_V] = (-d->stiffness * y[VM_DRUM_X] - flow * vx + unbalance * s) / m.M;
    dydt[VM_DRUM_V + 1] = (-d->stiffness * y[VM_DRUM_X + 1] + flow * (d->speed - vy) - unbalance * c) / m.M;
    dydt[VM_DRUM_OMEGA] = (-d->damping * rate + flow * d->radius * (d->speed - vy - d->radius * rate)) / m.J;
    return VM_OK;
}

/* Returns 1 if the drum can turn on a rigid shaft: the fields that it needs are finite and have the signs given in
   vm_drum. Returns 0 otherwise. */
VM_API int vmi_drum_turns(const vm_drum *d)
{
    return d && d->inertia > 0 && d->band >= 0 && d->omega > 0 && VM_IS_FINITE(d->inertia) &&
           VM_IS_FINITE(d->band) && VM_IS_FINITE(d->omega) && VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->speed) &&
           VM_IS_FINITE(d->damping);
}

/* The product j = mu R^2 in two words, that is, as the sum of two numbers */
VM_API vm_two vmi_drum_j(const vm_drum *d)
{
    return vmi_two_times(vmi_two_product(d->band, d->radius), vmi_two(d->radius, 0));
}

/* The drive e = mu v R - D in two words. It is computed in three words, so that all digits are right even if mu v R and
   D nearly cancel. */
VM_API vm_two vmi_drum_e(const vm_drum *d)
{
    const vm_two band = vmi_two_product(d->band, d->radius);
    const vmi_three drive = vmi_three_times(vmi_three_words(band.hi, band.lo, 0), vmi_three_words(d->speed, 0, 0));
    const vmi_three e = vmi_three_plus(drive, vmi_three_words(-d->damping, 0, 0));
    return vmi_two(e.hi, e.mid);
}

/* The quotient a b/c in two words */
VM_API vm_two vmi_drum_share(vm_two a, vm_real b, vm_two c)
{
    return vmi_two_over(vmi_two_times(a, vmi_two(b, 0)), c);
}

/* Angular velocity phi' on a rigid shaft at the angle phi >= 0, rad/s: (J0 Omega_b + e phi)/(J0 + j phi) (196).
   J0 is the drum's inertia, Omega_b its initial angular velocity, e = mu v R - D and j = mu R^2 as at the top of
   mechanics/drum.h. The results of vm_drum_rate, vm_drum_time and vm_drum_angle are right within 3 ulp if the drum's
   fields are taken as exact and products of the fields do not overflow or underflow. This holds for e = 0 and e = j
   Omega_b, too, and for angles up to the stop. Returns NaN beyond the stop (vm_drum_stop), for phi < 0, for a null
   pointer, and if inertia or omega is not positive or band is negative. */
VM_API vm_real vm_drum_rate(const vm_drum *d, vm_real phi)
{
    vm_two up, down;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    up = vmi_two_plus(vmi_two_product(d->inertia, d->omega), vmi_two_times(vmi_drum_e(d), vmi_two(phi, 0)));
    down = vmi_two_plus(vmi_two(d->inertia, 0), vmi_two_times(vmi_drum_j(d), vmi_two(phi, 0)));
    if (!(up.hi >= 0)) return VM_NAN;
    return vmi_two_over(up, down).hi;
}

/* Right-hand side of the elastic shaft's vibration over the angle phi, (210), (211).
   An ode_rhs of VM_DRUM_ANGLE_STATES states; ctx is a vm_drum. The independent variable is phi. The angular velocity
   phi' is the one that the drum has on a rigid shaft (196). Returns VM_OK; or VM_BAD_ARGUMENT for a null pointer,
   VM_DOMAIN if the drum does not reach phi, and the errors of vm_drum_rhs. */
VM_API int vm_drum_rhs_angle(vm_real phi, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    if (!VM_IS_FINITE(phi) || !vmi_drum_finite(d)) return VM_NOT_FINITE;
    const vm_real rate = vm_drum_rate(d, phi), j = d->band * d->radius * d->radius;
    const vm_real e = d->band * d->speed * d->radius - d->damping;
    const vm_real slope_x = y[VM_DRUM_SLOPE], slope_y = y[VM_DRUM_SLOPE + 1];
    vm_real acceleration, drag, force_y;
    vmi_drum_mass m;
    int status = vmi_drum_mass_at(d, phi, 0, &m);
    if (status) return status;
    if (!(rate > 0)) return VM_DOMAIN;
    acceleration = (e - j * rate) / m.J; /* the derivative dphi'/dphi (195); phi'' is acceleration times phi' */
    drag = d->band / m.M + acceleration / rate;
    dydt[VM_DRUM_DEFLECTION] = slope_x;
    dydt[VM_DRUM_DEFLECTION + 1] = slope_y;
    force_y = d->band * d->speed * rate - d->stiffness * y[VM_DRUM_DEFLECTION + 1];
    dydt[VM_DRUM_SLOPE] = -drag * slope_x - d->stiffness * y[VM_DRUM_DEFLECTION] / (m.M * rate * rate);
    dydt[VM_DRUM_SLOPE + 1] = -drag * slope_y + force_y / (m.M * rate * rate);
    return VM_OK;
}

/* Angle at which the drum on a rigid shaft comes to rest, rad: J0 Omega_b/|e| if e = mu v R - D < 0.
   The drum approaches this angle as t grows, but never reaches it. Returns infinity for e >= 0, and NaN for a drum for
   which vm_drum_rate gives NaN. */
VM_API vm_real vm_drum_stop(const vm_drum *d)
{
    vm_two e;
    if (!vmi_drum_turns(d)) return VM_NAN;
    e = vmi_drum_e(d);
    if (!(e.hi < 0)) return VM_INFINITY;
    return vmi_two_over(vmi_two_product(d->inertia, d->omega), vmi_minus(e)).hi;
}

/* Time at which the drum on a rigid shaft reaches the angle phi >= 0, s (197).
   With the letters of vm_drum_rate and x = e phi/(J0 Omega_b) it is t = phi/Omega_b [ln(1 + x)/x + (j phi/J0) (x -
   ln(1 + x))/x^2] for every sign of e. The accuracy is that of vm_drum_rate. Returns infinity at the stop, and NaN
   where vm_drum_rate gives NaN. */
VM_API vm_real vm_drum_time(const vm_drum *d, vm_real phi)
{
    vm_two x, y, s, sum, part = vmi_two(1, 0); /* y = ln(1 + x), s = j phi/J0, part = y/x */
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    x = vmi_drum_share(vmi_drum_e(d), phi, vmi_two_product(d->inertia, d->omega));
    s = vmi_drum_share(vmi_drum_j(d), phi, vmi_two(d->inertia, 0));
    sum = vmi_two_plus(vmi_two(1, 0), x);
    if (sum.hi == 0) return VM_INFINITY;
    if (!(sum.hi > 0)) return VM_NAN;
    y = vmi_log1p(x);
    if (VM_FABS(x.hi) > VM_EPSILON / 4) part = vmi_two_over(y, x);
    sum = vmi_two_plus(part, vmi_two_times(s, vmi_log1p_rest(x, y)));
    return vmi_drum_share(sum, phi, vmi_two(d->omega, 0)).hi;
}

/* The first approximation p for Newton's method in vm_drum_angle. The comment of vm_drum_angle has the equation for p
   and explains a, b, f, x, y. For a = 0 the term f^2 (x - y)/x^2 is p^2/2, and the equation has the solution p = 2/(1 +
   sqrt(1 + 2 b)). For a > 0 this p is too large, and so is ln(1 + a p + a^2/b)/a; the function takes the smaller value.
   For a < 0 this p is too small, and so is |a|/(|a| + b); the function takes the larger value. */
VM_API vm_real vmi_drum_start(vm_real a, vm_real b)
{
    const vm_real p = 2 / (1 + VM_SQRT(1 + 2 * b));
    if (a < 0) return vmi_larger(p, a / (a - b));
    if (a * p > 1 && b > 0) return vmi_smaller((vmi_log(a).hi + vmi_log(1 / a + a / b + p).hi) / a, p);
    return p;
}

/* Angle of the drum on a rigid shaft after t >= 0 seconds, rad.
   This is the inverse of vm_drum_time, computed by Newton's method in two words. It needs no branch of Lambert's W.
   Accuracy, NaN and the letters J0, Omega_b, e, j are those of vm_drum_rate. With x = e phi/(J0 Omega_b), y = ln(1 +
   x), a = e t/J0, b = j Omega_b t/J0, f = phi/(Omega_b t) and the unknown p = y/a the equation of vm_drum_time is
     p + b f^2 (x - y)/x^2 = 1,   where x = exp(y) - 1 and f = p x/y.
   Its left side increases with p, has the slope 1 + b f and is convex, so that the method converges from any start. */
VM_API vm_real vm_drum_angle(const vm_drum *d, vm_real t)
{
    const vm_real precise = VM_EPSILON / 8; /* the relative error of phi that the last step may leave */
    const int most_steps = 40; /* quadratic convergence needs fewer steps */
    vm_two angle, a, b, p, x, y, f, rest;
    vm_real step, left = 1;
    int i;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    angle = vmi_two_product(d->omega, t);
    a = vmi_drum_share(vmi_drum_e(d), t, vmi_two(d->inertia, 0));
    b = vmi_two_over(vmi_two_times(vmi_drum_j(d), angle), vmi_two(d->inertia, 0));
    p = vmi_two(vmi_drum_start(a.hi, b.hi), 0);
    f = p;
    for (i = 0; i < most_steps && left > precise; i++) {
        y = vmi_two_times(a, p);
        x = vmi_expm1(y);
        f = p;
        if (VM_FABS(y.hi) > VM_EPSILON / 4) f = vmi_two_times(p, vmi_two_over(x, y));
        rest = vmi_two_times(vmi_two_times(vmi_two_times(b, f), f), vmi_log1p_rest(x, y));
        rest = vmi_two_plus(vmi_two_plus(vmi_two(1, 0), vmi_minus(p)), vmi_minus(rest));
        step = rest.hi / (1 + b.hi * f.hi);
        left = step / f.hi * (step / f.hi) * (1 + x.hi) * vmi_larger(1 + x.hi, 1);
        p = vmi_two_plus(p, vmi_two(step, 0));
        f = vmi_two_plus(f, vmi_two(step * (1 + x.hi), 0));
    }
    return vmi_two_times(angle, f).hi;
}

/* Angle of the drum, rad, on a rigid shaft by Lambert's W, (198)-(206) corrected.
   The letters J0, Omega_b, e, j are those of vm_drum_rate. With r = 1 + e phi/(J0 Omega_b), k1 = 1 - e/(j Omega_b) and
   f1 = 1 + e^2 t/(J0 j Omega_b), the angle follows from r - k1 ln r = f1. The solution is r = -k1 W(x) for x
   = -exp(-f1/k1)/k1. It needs the branch W_-1 for 0 < k1 < 1, and the branch W_0 for other k1. This function is for
   comparison; vm_drum_angle is better. Near e = 0 the solution by W loses all digits, because x approaches the branch
   point of W. The code uses ln |x|, because x itself overflows or underflows near k1 = 0 (for k1 = 1e-3 it may be
   1e-868). Returns NaN for e = 0, for k1 = 0, and where vm_drum_rate does. */
VM_API vm_real vm_drum_angle_lambert(const vm_drum *d, vm_real t)
{
    vm_real j, e, k1, f1, l, w; /* l = ln |x|, w = W(x) */
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    j = vmi_drum_j(d).hi;
    e = vmi_drum_e(d).hi;
    k1 = 1 - e / (j * d->omega);
    if (k1 == 0 || e == 0) return VM_NAN;
    f1 = 1 + e * e * t / (d->inertia * j * d->omega);
    l = -vmi_log(VM_FABS(k1)).hi - f1 / k1;
    if (l > -1 && k1 > 0) l = -1; /* only rounding can move l beyond the branch point -1 */
    if (k1 < 0) w = vm_wright_omega(l);
    else if (e > 0) w = vm_lambert_wm1_neg_exp(l); /* e > 0 means k1 < 1, even if k1 has been rounded to 1 */
    else w = vm_lambert_w0_neg_exp(l);
    return (-k1 * w - 1) * d->inertia * d->omega / e;
}

/* Coefficients of the elastic shaft in the first approximation, (213), (214).
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS, VM_BAD_INERTIA, VM_DOMAIN
   if omega is not positive, and VM_OK otherwise. */
VM_API int vm_drum_shaft_init(vm_drum_shaft *s, const vm_drum *d)
{
    vm_drum_shaft r;
    vm_real j, drive, mass; /* the ratios j/J0, e/(J0 Omega_b), mu/M0 */
    if (!d || !s) return VM_BAD_ARGUMENT;
    if (!vmi_drum_finite(d)) return VM_NOT_FINITE;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->stiffness <= 0) return VM_BAD_STIFFNESS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    if (d->omega <= 0) return VM_DOMAIN;
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

/* Deflection x or y of the elastic shaft, m, at angle phi, (224), (225) corrected.
   With the fields k, delta, A of *s it is
     a (1 - A phi)^(-1/4) exp(-delta phi) cos(integral of k sqrt(1 - A phi) + alpha) + particular/(1 - A phi)
   where `particular` is 0 for x and s->shift for y. a (m) is the amplitude and alpha (rad) the phase. They follow from
   the start: at phi = 0 the deflection is a cos alpha + particular. The integral is (2k/3A) (1 - m^3) with
   m^2 = 1 - A phi. It is computed as 2k/3 phi (1 + m + m^2)/(1 + m), which holds for A = 0, too. Returns NaN for a null
   pointer and if 1 - A phi <= 0. */
VM_API vm_real vm_drum_deflection(const vm_drum_shaft *s, vm_real phi, vm_real a, vm_real alpha, vm_real particular)
{
    vm_real square, m, sine, cosine;
    if (!s) return VM_NAN;
    square = 1 - s->A * phi;
    if (!(square > 0) || !VM_IS_FINITE(phi) || !VM_IS_FINITE(a) || !VM_IS_FINITE(particular)) return VM_NAN;
    m = VM_SQRT(square);
    vmi_sincos(2 * s->k / 3 * phi * ((1 + m + square) / (1 + m)) + alpha, &sine, &cosine);
    return a / VM_SQRT(m) * vmi_exp(-s->delta * phi, 0) * cosine + particular / square;
}

/* Whether the shaft's frequency, k sqrt(1 - A phi), stays real for the whole first layer (226).
   Returns 1 if A < 1/(2 pi). Returns 0 otherwise, and for a null pointer. */
VM_API int vm_drum_shaft_valid(const vm_drum_shaft *s) { return s && s->A < 1 / (2 * VM_PI); }

#endif
/* mechanics/lagrange.h - Lagrange's equations with variable mass

   This chapter has the right-hand side for any system of n generalized coordinates whose kinetic energy T you can write
   down. The masses may depend on time and position (247). You give T, the masses and the generalized forces Q. The
   chapter computes the mass matrix A, the vector b and the derivatives from T. The states are the coordinates q and the
   momenta pi = dT/dq', so that neither rates of momenta nor rates of masses are needed:
     pi' = (dT/dq, masses frozen) + Q,   A q' = pi - b,   T = q'Aq'/2 + b q' + T0,  T0 = T(q' = 0).

   This is (247) corrected. T must use the velocities of the material. With streams of mass, Lagrange's equations are
     d/dt dT/dq'_i - (dT/dq_i, masses frozen) = Q_i + sum [M' u dr2/dq_i + M' kappa omega2 domega/dq'_i].
   A stream has the mass rate M' and the velocity u at the point r2. Its mass has the angular velocity omega2 and, per
   unit mass, the inertia kappa. omega is the angular velocity of the body. In dT/dq_i the masses must not vary,
   although (244)-(247) may be read as if they did.

       #include "varmass.h"
       static void masses(vm_real t, const vm_real *q, vm_real *m, void *ctx)
       {
           (void)q;
           (void)ctx;
           m[0] = 3 - t / 10; // kg
       }
       static vm_real energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *m, void *ctx)
       {
           (void)t;
           (void)q;
           (void)ctx;
           return m[0] * rates[0] * rates[0] / 2;
       }
       int main(void)
       {
           vm_real q[1] = {0}, rates[1] = {2}, y[2], work[VM_LAGRANGE_RHS_WORK(1, 1)];
           vm_lagrange_system body = {1, 1, masses, energy, NULL, NULL, NULL, work};
           return vm_lagrange_start(&body, 0, q, rates, y); // y for rk45_init(&s, vm_lagrange_rhs, &body, 2, ...)
       }

   Your Q must contain the terms of the streams, too. Example: a pendulum of length l and angle q has a bob that leaks
   mass, so that its mass m decreases. If the leaking mass has the velocity of the bob and takes its momentum along,
   Q = -m g l sin q + m' l^2 q'. Without the last term the mass would leave at rest.

   Accuracy: A and b are computed as differences of values of T, exactly except for rounding errors of T. dT/dq is a
   central difference of order 6. Its error is below 2e-13 (float 1e-5) of the largest T, if T varies noticeably only
   over changes of q as large as the field `scales`. Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_LAGRANGE_H
#define VARMASS_MECHANICS_LAGRANGE_H

/* A mechanical system: the ctx of vm_lagrange_rhs */
typedef struct VM_TAG(vm_lagrange_system) {
    int n;        /* number of coordinates, > 0 */
    int n_masses; /* number of masses, inertias and other quantities that are held constant in dT/dq, >= 0 */
    /* Sets the n_masses masses at time t and coordinates q. NULL if n_masses is 0. */
    void (*masses)(vm_real t, const vm_real *q, vm_real *masses, void *ctx);
    /* Returns the kinetic energy T (J), a polynomial of degree 2 in the n rates q'. */
    vm_real (*energy)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx);
    /* NULL, or a function that adds the n generalized forces to Q, for example by vm_lagrange_add_force. It returns
       0; another number ends the run. */
    int (*forces)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q, void *ctx);
    void *ctx;             /* the argument ctx of the three functions above */
    const vm_real *scales; /* for each coordinate the change over which T varies noticeably; NULL for 1 everywhere */
    vm_real *work;         /* array of VM_LAGRANGE_RHS_WORK(n, n_masses) numbers, provided by the caller */
} vm_lagrange_system;

/* Length of vm_lagrange_system.work */
#define VM_LAGRANGE_RHS_WORK(n, n_masses) ((n) * (n) + 3 * (n) + (n_masses))

/* The arrays into which the array `work` of a system is divided */
typedef struct VM_TAG(vmi_lagrange_parts) {
    vm_real *A;      /* the mass matrix A in T = q'Aq'/2 + b q' + T0, n rows of n numbers */
    vm_real *b;      /* the vector b in T, the factors of the rates q' in its linear terms, n numbers */
    vm_real *rates;  /* the generalized momenta minus b, later the rates q', n numbers */
    vm_real *trial;  /* rates or coordinates at which T is evaluated, n numbers */
    vm_real *masses; /* the masses, which stay constant while T is differentiated, n_masses numbers */
} vmi_lagrange_parts;

VM_API vmi_lagrange_parts vmi_lagrange_work(const vm_lagrange_system *system)
{
    vmi_lagrange_parts w;
    w.A = system->work;
    w.b = w.A + (ptrdiff_t)system->n * system->n;
    w.rates = w.b + system->n;
    w.trial = w.rates + system->n;
    w.masses = w.trial + system->n;
    return w;
}

/* The kinetic energy T at the rates x e_i + z e_j, where e_i is the unit vector of coordinate i. If i or j is -1, its
   term is left out. */
VM_API vm_real vmi_lagrange_energy(const vm_lagrange_system *system, vm_real t, const vm_real *q, int i, vm_real x,
                                   int j, vm_real z)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    int k;
    for (k = 0; k < system->n; k++) w.trial[k] = 0;
    if (i >= 0) w.trial[i] = x;
    if (j >= 0) w.trial[j] += z;
    return system->energy(t, q, w.trial, w.masses, system->ctx);
}

/* Computes the mass matrix A and the vector b from values of T. For the entry A_ij off the diagonal, T is evaluated at
   the rates +-1/sqrt(A_ii) of coordinate i and +-1/sqrt(A_jj) of coordinate j, so that a coordinate with a large energy
   does not hide the digits of the other one. */
VM_API void vmi_lagrange_quadratic(const vm_lagrange_system *system, vm_real t, const vm_real *q)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    const int n = system->n;
    const vm_real T0 = vmi_lagrange_energy(system, t, q, -1, 0, -1, 0);
    int i, j;
    for (i = 0; i < n; i++) {
        const vm_real plus = vmi_lagrange_energy(system, t, q, i, 1, -1, 0);
        const vm_real minus = vmi_lagrange_energy(system, t, q, i, -1, -1, 0);
        w.A[i * n + i] = (plus - T0) + (minus - T0);
        w.b[i] = (plus - minus) / 2;
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++) {
            const vm_real x = 1 / VM_SQRT(w.A[i * n + i]), z = 1 / VM_SQRT(w.A[j * n + j]);
            const vm_real same = vmi_lagrange_energy(system, t, q, i, x, j, z) +
                                 vmi_lagrange_energy(system, t, q, i, -x, j, -z);
            const vm_real opposite = vmi_lagrange_energy(system, t, q, i, x, j, -z) +
                                     vmi_lagrange_energy(system, t, q, i, -x, j, z);
            w.A[i * n + j] = w.A[j * n + i] = (same - opposite) / (4 * x * z);
        }
}

/* Writes the masses at (t, q) into the work array. They stay constant there while T is differentiated. */
VM_API void vmi_lagrange_freeze(const vm_lagrange_system *system, vm_real t, const vm_real *q)
{
    if (system->masses) system->masses(t, q, vmi_lagrange_work(system).masses, system->ctx);
}

/* Writes the rates q' = A^-1 (pi - b) of the state y into the work array. Returns VM_SINGULAR if A is not positive
   definite, VM_NOT_FINITE if the reason is that t or y is not finite, and VM_OK otherwise. */
VM_API int vmi_lagrange_solve_rates(const vm_lagrange_system *system, vm_real t, const vm_real *y)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    int k, status;
    vmi_lagrange_freeze(system, t, y);
    vmi_lagrange_quadratic(system, t, y);
    for (k = 0; k < system->n; k++) w.rates[k] = y[system->n + k] - w.b[k];
    status = vmi_solve_mass(system->n, w.A, w.rates, w.trial);
    if (status && !(VM_IS_FINITE(t) && vmi_all_finite(2 * system->n, y))) return VM_NOT_FINITE;
    return status;
}

/* The derivative dT/dq_i of the kinetic energy T, with the masses that are stored in the work array. It is a central
   difference of order 6 from T at q_i plus and minus 1, 2 and 3 steps. A step is h times the scale of q_i. In units of
   this scale the error is h^6/140 times the seventh derivative of T, plus a rounding error of T eps/h. Both are small
   for h = 2^-7 in double precision (eps = 2^-52) and for h = 2^-3 in single precision (eps = 2^-23). */
VM_API vm_real vmi_lagrange_derivative(const vm_lagrange_system *system, vm_real t, const vm_real *q,
                                       const vm_real *rates, int i)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    const vm_real weights[3] = {VM_C(0.75), VM_C(-0.15), VM_C(1.0) / 60};
    vm_real h = VM_MANT_DIG > 24 ? VM_C(0.0078125) : VM_C(0.125), sum = 0;
    int k;
    if (system->scales) h *= system->scales[i];
    for (k = 0; k < system->n; k++) w.trial[k] = q[k];
    for (k = 3; k > 0; k--) {
        vm_real difference;
        w.trial[i] = q[i] + (vm_real)k * h;
        difference = system->energy(t, w.trial, rates, w.masses, system->ctx);
        w.trial[i] = q[i] - (vm_real)k * h;
        difference -= system->energy(t, w.trial, rates, w.masses, system->ctx);
        sum += weights[k - 1] * difference;
    }
    return sum / h;
}

/* Returns 1 if the system has all functions and arrays that it needs, else 0. */
VM_API int vmi_lagrange_is_valid(const vm_lagrange_system *system)
{
    return system && system->n > 0 && system->n_masses >= 0 && system->energy && system->work &&
           (system->n_masses == 0 || system->masses);
}

/* Right-hand side of Lagrange's equations with variable mass (247).
   An ode_rhs of 2 n states: n coordinates q, then n generalized momenta pi; ctx is a vm_lagrange_system. Returns 0 or
   an error that ends the run. The errors are VM_BAD_ARGUMENT, VM_SINGULAR if the mass matrix is not positive definite,
   VM_NOT_FINITE if t or y is not finite, or the number that system->forces returns. The mass matrix is not positive
   definite if, for example, a mass has become negative; use an event to stop the run before that. The number of calls
   of system->energy grows with n^2. */
VM_API int vm_lagrange_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *lagrange)
{
    const vm_lagrange_system *system = (const vm_lagrange_system *)lagrange;
    vmi_lagrange_parts w;
    int k, n, status;
    if (!y || !dydt || !vmi_lagrange_is_valid(system)) return VM_BAD_ARGUMENT;
    n = system->n;
    w = vmi_lagrange_work(system);
    status = vmi_lagrange_solve_rates(system, t, y);
    if (status) return status;
    for (k = 0; k < n; k++) {
        dydt[k] = w.rates[k];
        dydt[n + k] = 0;
    }
    if (system->forces) status = system->forces(t, y, w.rates, w.masses, dydt + n, system->ctx);
    for (k = 0; k < n; k++) dydt[n + k] += vmi_lagrange_derivative(system, t, y, w.rates, k);
    return status;
}

/* Initial state y of a system at time t, from its n coordinates q and n rates q'.
   y is an array of 2 n numbers: the n coordinates q followed by the n generalized momenta pi. Returns VM_BAD_ARGUMENT,
   VM_NOT_FINITE, or VM_OK. */
VM_API int vm_lagrange_start(vm_lagrange_system *system, vm_real t, const vm_real *q, const vm_real *rates, vm_real *y)
{
    vmi_lagrange_parts w;
    int i, j, n;
    if (!vmi_lagrange_is_valid(system) || !q || !rates || !y) return VM_BAD_ARGUMENT;
    n = system->n;
    w = vmi_lagrange_work(system);
    vmi_lagrange_freeze(system, t, q);
    vmi_lagrange_quadratic(system, t, q);
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) w.b[i] += w.A[i * n + j] * rates[j];
    if (!vmi_all_finite(n, w.b) || !vmi_all_finite(n, q)) return VM_NOT_FINITE;
    for (i = 0; i < n; i++) {
        y[i] = q[i];
        y[n + i] = w.b[i];
    }
    return VM_OK;
}

/* Rates q' of a system at time t, from its state y.
   y has 2 n numbers: the n coordinates q followed by the n generalized momenta pi. rates has n numbers. Returns
   VM_BAD_ARGUMENT, VM_SINGULAR, VM_NOT_FINITE, or VM_OK. */
VM_API int vm_lagrange_rates(vm_lagrange_system *system, vm_real t, const vm_real *y, vm_real *rates)
{
    int status;
    if (!vmi_lagrange_is_valid(system) || !y || !rates) return VM_BAD_ARGUMENT;
    status = vmi_lagrange_solve_rates(system, t, y);
    if (status) return status;
    return vmi_copy_if_finite(system->n, vmi_lagrange_work(system).rates, rates);
}

/* Derivative dT/dq_i of the kinetic energy with frozen masses, J per unit of q_i.
   The masses are those at (t, q). q and rates have n numbers. Returns NaN for i outside 0 ... n - 1 and for a null
   pointer. */
VM_API vm_real vm_lagrange_partial_q(vm_lagrange_system *system, vm_real t, const vm_real *q, const vm_real *rates,
                                     int i)
{
    if (!vmi_lagrange_is_valid(system) || !q || !rates || i < 0 || i >= system->n) return VM_NAN;
    vmi_lagrange_freeze(system, t, q);
    return vmi_lagrange_derivative(system, t, q, rates, i);
}

#endif
/* mechanics/euler_angles.h - Euler's angles

   The angles psi, theta, phi of the sequence 3-1-3 give the attitude of a body. It turns by psi about z, by theta about
   the line of nodes, and by phi about its own z axis. This chapter computes
     - the quaternion of three angles,
     - the axes about which the angles turn the body (Lagrange's equations need them as domega/dq'_i),
     - the rates psi', theta', phi' of the angles from an angular velocity.

       vm_quat q = vm_euler_313(VM_C(0.1), VM_C(0.2), VM_C(0.3));

   Angles are in rad. Errors are within 8 eps for angles up to 1e9 (float 1e4). Beyond 2^(p-1) quarter turns, where p is
   the number of binary digits of vm_real, a result has no meaning: neighbouring angles differ by 1 rad or more.
   Tests: tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_EULER_ANGLES_H
#define VARMASS_MECHANICS_EULER_ANGLES_H

/* Quaternion of length 1 that turns body axes into inertial ones, from Euler's angles. Infinite angles give NaN. */
VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi)
{
    vm_quat turn = {1, 0, 0, 0}, tilt = {1, 0, 0, 0}, spin = {1, 0, 0, 0};
    vmi_sincos(psi / 2, &turn.z, &turn.w);
    vmi_sincos(theta / 2, &tilt.x, &tilt.w);
    vmi_sincos(phi / 2, &spin.z, &spin.w);
    return vmi_quat_times(vmi_quat_times(turn, tilt), spin);
}

/* Unit vectors of the axes about which Euler's angles turn the body, along inertial axes. The angular velocity is
   omega = psi' axis[0] + theta' axis[1] + phi' axis[2]. Therefore axis[i] is domega/dq'_i, where q'_i is the rate of
   angle i. A call with a null pointer does nothing. */
VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine; /* sine s and cosine c of psi; sine, cosine of theta */
    if (!axis) return;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(0, 0, 1);
    axis[1] = vmi_vec3(c, s, 0);
    axis[2] = vmi_vec3(sine * s, -sine * c, cosine);
}

/* Unit vectors of the axes about which Euler's angles turn the body, along body axes. The angular velocity is
   omega = psi' axis[0] + theta' axis[1] + phi' axis[2]. A call with a null pointer does nothing. */
VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine; /* sine s and cosine c of phi; sine, cosine of theta */
    if (!axis) return;
    vmi_sincos(phi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(sine * s, sine * c, cosine);
    axis[1] = vmi_vec3(c, -s, 0);
    axis[2] = vmi_vec3(0, 0, 1);
}

/* Rates psi', theta', phi' of Euler's angles from an angular velocity in inertial axes, rad/s.
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE, VM_SINGULAR if sin(theta) is 0, and VM_OK otherwise. */
VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3])
{
    vm_real s, c, sine, cosine, result[3]; /* sine s and cosine c of psi; sine, cosine of theta */
    if (!rates) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(psi) || !VM_IS_FINITE(theta) || !vmi_vec3_is_finite(omega)) return VM_NOT_FINITE;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    if (sine == 0) return VM_SINGULAR;
    result[2] = (s * omega.x - c * omega.y) / sine;
    result[1] = c * omega.x + s * omega.y;
    result[0] = omega.z - result[2] * cosine;
    return vmi_copy_if_finite(3, result, rates);
}

#endif
/* oscillators/force_terms.h - terms of forces that both oscillators and scenes use

   Each formula is written here once, so that an oscillator and an effect of a scene mean the same by it:
       vm_real feed = vmi_van_der_pol_feed(VM_C(0.1), VM_C(0.2), 2); // N s/m at x = 2 m: force over velocity
   Tests: tests/test_van_der_pol.c, tests/test_jeffcott.c, tests/test_forces.c. */
#ifndef VARMASS_OSCILLATORS_FORCE_TERMS_H
#define VARMASS_OSCILLATORS_FORCE_TERMS_H

/* x|x|^(alpha-1), alpha >= 0, by the power function: the force of a spring divided by -k. Callers treat x = 0 and
   exponents that need no power function themselves. */
VM_INLINE vm_real vmi_elastic_power(vm_real x, vm_real alpha)
{
    return VM_COPYSIGN(vmi_pow_checked(VM_FABS(x), alpha), x);
}

/* Van der Pol's term (404), feed - c x^2, N s/m: the force over the velocity at position x. feed > 0 (N s/m) feeds
   the vibration, and c > 0 (N s/m^3) limits it. */
VM_INLINE vm_real vmi_van_der_pol_feed(vm_real feed, vm_real c, vm_real x) { return feed - c * (x * x); }

/* The gyroscopic coupling 2 gyro, kg/s: the gyroscopic force is this times the velocity, turned by +90 degrees. gyro
   is g of the remark after (516), kg/s. */
VM_INLINE vm_real vmi_gyroscopic_coupling(vm_real gyro) { return 2 * gyro; }

#endif
/* oscillators/waves.h - wave forms of a strongly nonlinear oscillator: ca, cos and cn

   The motion of x'' + omega0^2 x|x|^(alpha-1) = 0 is x = A ca(psi), x' = -vmax(A) sa(psi) with the Ateb functions of
   the phase psi (282), (283); A is the amplitude, vmax(A) the largest velocity. Two simpler waves with the same
   amplitude and period approximate ca: cos (291), (329) and Jacobi's cn (297), (370). A vmi_osc_wave is one of the
   three waves c of the position, with its wave s of the velocity and what averaged equations need for a force F on the
   mass m:
     A'/A = -q/(alpha+3) - gain_A <F s>/(m V),   theta' = -gain_theta <F c>/(m V),   V = speed vmax(A),
   where <> is the mean over a period, q the rate at which stiffness, mass and damping change the motion, and theta the
   slow part of the wave's own angle. A new wave needs a function that evaluates it and a constructor.
       vmi_osc_wave w = vmi_osc_wave_cn(3, ateb_pi(3));
       vm_real c, s;
       vmi_osc_wave_at(&w, VM_C(0.5), &c, &s); // at psi = 0.5: x = A c, x' = -w.speed vmax(A) s
   Tests: tests/test_constant_mass.c, tests/test_averaging.c. */
#ifndef VARMASS_OSCILLATORS_WAVES_H
#define VARMASS_OSCILLATORS_WAVES_H

typedef struct VM_TAG(vmi_osc_wave) vmi_osc_wave;
struct VM_TAG(vmi_osc_wave) {
    /* writes the waves c of the position and s of the velocity at the Ateb phase psi */
    void (*at)(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s);
    /* estimates the error of the wave, where mean_ca2 is the mean of ca^2; null for ca, which has no error */
    vm_real (*error)(const vmi_osc_wave *w, vm_real mean_ca2);
    vm_real alpha;              /* exponent of the spring */
    vm_real turn;               /* the wave's own angle, the argument of ca, cos or cn, is turn psi */
    vm_real speed;              /* the velocity is x' = -speed vmax(A) s */
    vm_real gain_A, gain_theta; /* factors of the means of the force in the averaged equations */
    vm_real m;                  /* parameter m = k^2 of cn; 0 for the other waves */
    vm_real mean_c2;            /* mean of cn^2; 0 for the other waves */
    const ateb_plan *ateb;      /* plan of ca, or null */
};

/* Writes the waves c of the position and s of the velocity at the Ateb phase psi. */
VM_API void vmi_osc_wave_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s) { w->at(w, psi, c, s); }

/* -- ca: exact -- */
VM_API void vmi_osc_ca_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    ateb_saca(psi, w->alpha, s, c);
}

VM_API void vmi_osc_ca_by_plan(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    ateb_plan_saca(w->ateb, psi, s, c);
}

/* The wave x = A ca(psi), x' = -vmax(A) sa(psi). With a plan for this alpha it is evaluated faster. */
VM_API vmi_osc_wave vmi_osc_wave_ca(vm_real alpha, const ateb_plan *ateb_or_NULL)
{
    vmi_osc_wave w;
    w.at = ateb_or_NULL ? vmi_osc_ca_by_plan : vmi_osc_ca_at;
    w.error = NULL;
    w.alpha = alpha;
    w.turn = 1;
    w.speed = 1;
    w.gain_A = 2 / (alpha + 1);
    w.gain_theta = 1;
    w.m = 0;
    w.mean_c2 = 0;
    w.ateb = ateb_or_NULL;
    return w;
}

/* -- cos: exact for alpha = 1 -- */
VM_API void vmi_osc_cos_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    vmi_sincos(w->turn * psi, s, c);
}

/* Estimates the error of the wave cos. It is the error of its velocity at x = 0, where it is largest, times a factor
   that grows with alpha. */
VM_API vm_real vmi_osc_cos_error(const vmi_osc_wave *w, vm_real mean_ca2)
{
    (void)mean_ca2;
    return VM_FABS(w->speed - 1) * (1 + w->alpha / 100);
}

/* The wave x = A cos(turn psi), whose period is that of ca; the argument pi is Pi_alpha. gain_A and gain_theta are the
   factors 4/(alpha + 3) in the averaged equations (337)-(339). The dissertation has 5 - alpha instead of alpha + 3,
   because of a wrong sign in (335). */
VM_API vmi_osc_wave vmi_osc_wave_cos(vm_real alpha, vm_real pi)
{
    vmi_osc_wave w = vmi_osc_wave_ca(alpha, NULL);
    w.at = vmi_osc_cos_at;
    w.error = vmi_osc_cos_error;
    w.turn = VM_PI / pi;
    w.speed = (alpha + 1) / 2 * w.turn;
    w.gain_A = 4 / (alpha + 3);
    w.gain_theta = w.gain_A;
    return w;
}

/* -- cn: exact for alpha = 1 and 3 -- */

/* Writes c = cn and s = sn dn. */
VM_API void vmi_osc_cn_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    vm_real sn, dn;
    jacobi_sncndn(w->turn * psi, w->m, &sn, c, &dn);
    *s = sn * dn;
}

/* Estimates the error of the wave cn. It is the difference between the means of cn^2 and of ca^2, which is 0 where cn
   is exact, times a factor that is fitted to the largest errors of this wave. */
VM_API vm_real vmi_osc_cn_error(const vmi_osc_wave *w, vm_real mean_ca2)
{
    return VM_FABS(w->mean_c2 - mean_ca2) * (VM_C(2.7) + w->alpha / 2);
}

/* The wave x = A cn(turn psi | m), whose period and whose velocity at x = 0 are those of A ca(psi); pi is Pi_alpha. The
   parameter m follows from (307), the factors gain_A and gain_theta from (380)-(382). */
VM_API vmi_osc_wave vmi_osc_wave_cn(vm_real alpha, vm_real pi)
{
    vmi_osc_wave w = vmi_osc_wave_ca(alpha, NULL);
    vm_real C2, C4, C6, bracket; /* means of cn^2, cn^4, cn^6; twice the mean of sn^2 dn^2 */
    w.at = vmi_osc_cn_at;
    w.error = vmi_osc_cn_error;
    w.m = jacobi_solve_kpK(pi / (alpha + 1));
    w.turn = 2 * jacobi_K(w.m) / pi;
    w.speed = (alpha + 1) / 2 * w.turn;
    jacobi_cn_means(w.m, &C2, &C4, &C6);
    w.mean_c2 = C2;
    bracket = (1 - w.m) + w.m * C4;
    w.gain_A = 4 / ((alpha + 3) * bracket);
    w.gain_theta = 1 / bracket;
    return w;
}

/* -- How good a wave is -- */

/* Estimate of the larger of the wave's errors of x/A and of x'/vmax, at most 1 */
VM_API vm_real vmi_osc_wave_error(const vmi_osc_wave *w, vm_real mean_ca2)
{
    const vm_real error = w->error ? w->error(w, mean_ca2) : 0;
    return vmi_smaller(error, 1);
}

/* Writes to *x_error the largest difference of the wave c from ca, and to *v_error that of speed s from sa. They are
   taken over a quarter of the period, at points that are densest near x = 0. pi is Pi_alpha. */
VM_API void vmi_osc_wave_differences(const vmi_osc_wave *w, vm_real pi, vm_real *x_error, vm_real *v_error)
{
    const int points = 256;
    int i;
    *x_error = 0;
    *v_error = 0;
    for (i = 0; i <= points; i++) {
        const vm_real u = (vm_real)i / (vm_real)points, psi = pi / 2 * (1 - u * u);
        vm_real sa, ca, c, s;
        ateb_saca(psi, w->alpha, &sa, &ca);
        vmi_osc_wave_at(w, psi, &c, &s);
        c = VM_FABS(c - ca);
        s = VM_FABS(w->speed * s - sa);
        if (c > *x_error) *x_error = c;
        if (s > *v_error) *v_error = s;
    }
}

#endif
/* oscillators/constant_mass.h - the oscillator x'' + omega0^2 x|x|^(alpha-1) = 0 of constant mass

   A mass m on a spring of force -k x|x|^(alpha-1), omega0 = sqrt(k/m), with any real alpha >= 0: 1 is the linear
   spring, 3 the cubic one. Here are its period (262), largest velocity (267) and energy (259); the exact motion by the
   Ateb functions (282), (283) from rest or from any state; and the approximations by the cosine (291)-(296) and by
   Jacobi's cn (297)-(307) with their errors (268). The shortest useful calls:
       vm_real T = vm_osc_period(2, 1, VM_C(1.5)), x, v; // x'' = -x|x|^0.5 from x = 2 at rest
       vm_osc_exact(T / 8, 2, 1, VM_C(1.5), &x, &v);
   The functions return or write NaN for alpha < 0 and for infinite arguments, and functions with outputs write nothing
   where an output is null. The unit of omega0 is m^((1-alpha)/2)/s. Symbols: A amplitude, psi Ateb phase, Om its rate.
   Tests: tests/test_constant_mass.c. */
#ifndef VARMASS_OSCILLATORS_CONSTANT_MASS_H
#define VARMASS_OSCILLATORS_CONSTANT_MASS_H

/* -- Period, velocity, energy -- */
VM_API int vmi_osc_alpha_is_valid(vm_real alpha) { return alpha >= 0 && VM_IS_FINITE(alpha); }

/* Om, the rate of the Ateb phase psi at the amplitude |x0|: sqrt((alpha+1)/2) omega0 |x0|^((alpha-1)/2), 1/s. Returns
   NaN outside the domain. */
VM_API vm_real vmi_osc_rate(vm_real x0, vm_real omega0, vm_real alpha)
{
    if (!vmi_osc_alpha_is_valid(alpha) || !VM_IS_FINITE(x0) || !VM_IS_FINITE(omega0)) return VM_NAN;
    if (omega0 == 0) return 0; /* the power may be infinite */
    return VM_SQRT((alpha + 1) / 2) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha - 1) / 2);
}

/* Om, the rate of the Ateb phase, of a motion that starts at rest at x0. Returns 0 at x0 = 0, where the power may be
   infinite. */
VM_API vm_real vmi_osc_rate_from_rest(vm_real x0, vm_real omega0, vm_real alpha)
{
    const vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (x0 == 0 && rate == rate) return 0;
    return rate;
}

/* Exact period (262), s, of the motion from rest at x0 (m, either sign). */
VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha)
{
    return 2 * ateb_pi(alpha) / vmi_osc_rate(x0, omega0, alpha);
}

/* Largest velocity (267), m/s, of the motion from rest at x0 (m, either sign). */
VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha)
{
    const vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (rate != rate) return rate;
    return VM_SQRT(2 / (alpha + 1)) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha + 1) / 2);
}

/* x|x|^(alpha-1): the elastic force is this times -k */
VM_API vm_real vmi_osc_elastic(vm_real x, vm_real alpha)
{
    if (alpha == 1 || x == 0) return x;
    if (alpha == 3) return x * x * x;
    return vmi_elastic_power(x, alpha);
}

/* Energy per unit mass (259), v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1), m^2/s^2. */
VM_API vm_real vm_osc_energy(vm_real x, vm_real v, vm_real omega0, vm_real alpha)
{
    if (!vmi_osc_alpha_is_valid(alpha)) return VM_NAN;
    if (!VM_IS_FINITE(x) || !VM_IS_FINITE(v) || !VM_IS_FINITE(omega0)) return VM_NAN;
    return v * v / 2 + omega0 * omega0 * vmi_pow_checked(VM_FABS(x), alpha + 1) / (alpha + 1);
}

/* -- Exact motion -- */

/* Writes position x and velocity v at the Ateb phase psi of a motion with the amplitude A, of either sign. */
VM_API void vmi_osc_at_phase(vm_real A, vm_real psi, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vm_real sa, ca;
    ateb_saca(psi, alpha, &sa, &ca);
    *x = A * ca;
    *v = -VM_COPYSIGN(vm_osc_vmax(A, omega0, alpha), A) * sa;
}

/* Exact motion x(t) (282) and x'(t) (283) from rest at x0 (m, either sign). */
VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vmi_osc_at_phase(x0, vmi_osc_rate_from_rest(x0, omega0, alpha) * t, omega0, alpha, x, v);
}

/* (a^n + b^n)^(1/n) for a, b >= 0, scaled so that no power overflows unless the result does */
VM_API vm_real vmi_osc_power_norm(vm_real a, vm_real b, vm_real n)
{
    const vm_real larger = vmi_larger(a, b), smaller = vmi_smaller(b, a);
    if (larger == 0 || a == 0 || b == 0) return larger;
    return larger * vmi_pow_checked(1 + vmi_pow_checked(smaller / larger, n), 1 / n);
}

/* Amplitude A >= 0 (m) and Ateb phase psi in (-Pi, Pi] of the state x (m), v (m/s). They satisfy x = A ca(psi), v =
   -vmax(A) sa(psi), where Pi = Pi_alpha and vmax is vm_osc_vmax. Method: from rest, the velocity v belongs to an
   amplitude B with vmax(B) = |v|; by energy A^(alpha+1) = |x|^(alpha+1) + B^(alpha+1). */
VM_API void vm_osc_amplitude_phase(vm_real x, vm_real v, vm_real omega0, vm_real alpha, vm_real *A, vm_real *psi)
{
    if (!A || !psi) return;
    const vm_real n = alpha + 1, s = v / (VM_SQRT(2 / n) * VM_FABS(omega0)); /* B^(n/2), with the sign of v */
    *A = VM_NAN;
    *psi = VM_NAN;
    if (!vmi_osc_alpha_is_valid(alpha)) return;
    if (!VM_IS_FINITE(x) || !VM_IS_FINITE(s) || !VM_IS_FINITE(omega0)) return;
    *A = vmi_osc_power_norm(VM_FABS(x), vmi_pow_checked(VM_FABS(s), 2 / n), n);
    *psi = ateb_phase(0 - s, x, alpha); /* 0 - s is 0 and not -0 where s is 0 */
}

/* Exact motion x(t), x'(t) from any state x(0) = x0 (m), x'(0) = v0 (m/s). */
VM_API void vm_osc_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real omega0, vm_real alpha, vm_real *x,
                              vm_real *v)
{
    if (!x || !v) return;
    vm_real A, psi, rate = 0;
    vm_osc_amplitude_phase(x0, v0, omega0, alpha, &A, &psi);
    if (A != 0) rate = vmi_osc_rate(A, omega0, alpha);
    vmi_osc_at_phase(A, psi + rate * t, omega0, alpha, x, v);
}

/* The mean over a period of |ca|^power, which is B((power+1)/(alpha+1), 1/2)/Pi_alpha, where pi is Pi_alpha and B is
   Euler's beta function. For q <= 1, B(q, 1/2) is Pi of alpha = 1/q - 1; for larger q it follows by the recurrence of
   B. constants is the function that computes Pi. */
VM_API vm_real vmi_osc_mean_ca(vm_real power, vm_real alpha, vm_real pi, vmi_ateb_constants_of constants)
{
    vm_real q = (power + 1) / (alpha + 1), factor = 1;
    vmi_ateb c;
    for (; q > 1; q -= 1) factor *= (q - 1) / (q - VM_C(0.5));
    constants(&c, 1 / q - 1);
    return factor * (2 * c.quarter.hi) / pi;
}

/* -- Approximations by cos and cn, with the exact amplitude and period -- */

/* Writes position x and velocity v at time t, by the wave w, of a motion that starts at rest at x0. */
VM_API void vmi_osc_by_wave(const vmi_osc_wave *w, vm_real t, vm_real x0, vm_real omega0, vm_real *x, vm_real *v)
{
    vm_real c, s;
    vmi_osc_wave_at(w, vmi_osc_rate_from_rest(x0, omega0, w->alpha) * t, &c, &s);
    *x = x0 * c;
    *v = -VM_COPYSIGN(w->speed * vm_osc_vmax(x0, omega0, w->alpha), x0) * s;
}

/* Frequency Omega_alpha (293) of the cosine with the exact period of the oscillator, a pure number. It is valid for
   x0 = omega0 = 1; in general the frequency is Omega_alpha omega0 |x0|^((alpha-1)/2), rad/s. */
VM_API vm_real vm_osc_omega_trig(vm_real alpha) { return VM_PI * vmi_osc_rate(1, 1, alpha) / ateb_pi(alpha); }

/* Approximation x0 cos(Omega t) (291) and its velocity (295), from rest at x0. Amplitude and period are exact. The
   frequency Omega is that of vm_osc_omega_trig. */
VM_API void vm_osc_trig(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    const vmi_osc_wave w = vmi_osc_wave_cos(alpha, ateb_pi(alpha));
    vmi_osc_by_wave(&w, t, x0, omega0, x, v);
}

/* Parameter m (307) of the cn that approximates x(t) with the exact period of the oscillator. m = k^2 may be negative:
   -1.8079 < m < 0.8062. */
VM_API vm_real vm_osc_jacobi_parameter(vm_real alpha) { return jacobi_solve_kpK(ateb_pi(alpha) / (alpha + 1)); }

/* Frequency Omega_1* (300) of the cn with the exact period of the oscillator, a pure number. It is valid for
   x0 = omega0 = 1; in general the frequency is Omega_1* omega0 |x0|^((alpha-1)/2), 1/s. It is computed by (300), where
   the quarter period of cn is K = Pi_alpha/((alpha+1) k') by (307). */
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha)
{
    return VM_SQRT(2 / ((alpha + 1) * jacobi_solve_kpK_m1(ateb_pi(alpha) / (alpha + 1))));
}

/* Approximation x0 cn(Omega_1 t | m) (297) and its velocity (302), from rest at x0. Amplitude, period and the
   velocity at x = 0 are exact. The frequency Omega_1 is that of vm_osc_omega_jacobi, the parameter m that of
   vm_osc_jacobi_parameter. */
VM_API void vm_osc_jacobi(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    const vmi_osc_wave w = vmi_osc_wave_cn(alpha, ateb_pi(alpha));
    vmi_osc_by_wave(&w, t, x0, omega0, x, v);
}

/* The result of vm_osc_approximation_errors, pure numbers: ratios of velocities (268) and largest errors in a period */
typedef struct VM_TAG(vm_osc_errors) {
    vm_real trig_vmax;          /* largest velocity of the cosine (296) over the exact one (267) */
    vm_real jacobi_vmax;        /* largest velocity of cn over the exact one. At x = 0 cn has the velocity k' Omega_1
                                   (306), but for m > 1/2 a larger one, Omega_1/(2k), near x = 0 */
    vm_real trig_x, trig_v;     /* largest errors of the cosine, of x relative to x0 and of v relative to vmax */
    vm_real jacobi_x, jacobi_v; /* largest errors of cn, relative to x0 and vmax */
} vm_osc_errors;

/* Errors of the approximations by cos and cn, as the fields of vm_osc_errors. They depend on alpha alone. Errors in a
   period are compared at 257 points. */
VM_API vm_osc_errors vm_osc_approximation_errors(vm_real alpha)
{
    const vm_real pi = ateb_pi(alpha);
    vm_osc_errors r = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vmi_osc_wave w;
    if (pi != pi) return r;
    w = vmi_osc_wave_cos(alpha, pi);
    r.trig_vmax = w.speed;
    vmi_osc_wave_differences(&w, pi, &r.trig_x, &r.trig_v);
    w = vmi_osc_wave_cn(alpha, pi);
    r.jacobi_vmax = 1;
    if (w.m > VM_C(0.5)) r.jacobi_vmax = w.speed / (2 * VM_SQRT(w.m));
    vmi_osc_wave_differences(&w, pi, &r.jacobi_x, &r.jacobi_v);
    return r;
}

#endif
/* oscillators/legendre.h - Gauss' rule of 20 points and series of Legendre polynomials on [-1, 1]

   A smooth function on [-1, 1] is represented by the series sum coefficient[k] P_k(x), k = 0 ... 19, with Legendre's
   polynomials P_k. Its integral over [-1, 1] is 2 coefficient[0]. vmi_legendre_fit finds the coefficients from the
   values at the points of Gauss' rule. The other functions evaluate, integrate and differentiate the series, and
   measure its size. The files laws.h, averaging.h, panels.h, walk.h and collocation.h use this one.
   Tests: tests/test_laws.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_LEGENDRE_H
#define VARMASS_OSCILLATORS_LEGENDRE_H

/* Number of points of the rule, and of terms of a series */
enum { VMI_GAUSS = 20 };

/* Point i of Gauss' rule on [-1, 1], 0 <= i < 20 */
VM_API vm_real vmi_gauss_node(int i)
{
    VM_TABLE vm_real node[10] = {VM_C(0.99312859918509492479), VM_C(0.96397192727791379127),
                                 VM_C(0.91223442825132590587), VM_C(0.83911697182221882339),
                                 VM_C(0.74633190646015079261), VM_C(0.63605368072651502545),
                                 VM_C(0.510867001950827098),   VM_C(0.37370608871541956067),
                                 VM_C(0.22778585114164507808), VM_C(0.076526521133497333755)};
    return i % 2 ? VM_READ(node[i / 2]) : -VM_READ(node[i / 2]);
}

/* The weight of point i of Gauss' rule; the weights add up to 2 */
VM_API vm_real vmi_gauss_weight(int i)
{
    VM_TABLE vm_real weight[10] = {VM_C(0.017614007139152118312), VM_C(0.040601429800386941331),
                                   VM_C(0.06267204833410906357),  VM_C(0.083276741576704748725),
                                   VM_C(0.10193011981724043504),  VM_C(0.11819453196151841731),
                                   VM_C(0.1316886384491766269),   VM_C(0.14209610931838205133),
                                   VM_C(0.14917298647260374679),  VM_C(0.1527533871307258507)};
    return VM_READ(weight[i / 2]);
}

/* Legendre's polynomial P_(k+1)(x), where now = P_k(x) and before = P_(k-1)(x) */
VM_API vm_real vmi_legendre_next(int k, vm_real x, vm_real now, vm_real before)
{
    return ((vm_real)(2 * k + 1) * x * now - (vm_real)k * before) / (vm_real)(k + 1);
}

/* Writes the coefficients a and b of the series of two functions, from their values at the points of Gauss' rule. It
   takes two functions at once, since most of the time goes into the polynomials. */
VM_API void vmi_legendre_fit(const vm_real *values_a, const vm_real *values_b, vm_real *a, vm_real *b)
{
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) {
        a[k] = 0;
        b[k] = 0;
    }
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real x = vmi_gauss_node(i), weight = vmi_gauss_weight(i);
        const vm_real share_a = weight * values_a[i], share_b = weight * values_b[i];
        vm_real before = 0, now = 1;
        for (k = 0; k < VMI_GAUSS; k++) {
            const vm_real next = vmi_legendre_next(k, x, now, before);
            a[k] += share_a * now;
            b[k] += share_b * now;
            before = now;
            now = next;
        }
    }
    for (k = 0; k < VMI_GAUSS; k++) {
        a[k] *= (vm_real)k + VM_C(0.5);
        b[k] *= (vm_real)k + VM_C(0.5);
    }
}

/* The value of the series at x */
VM_API vm_real vmi_legendre_at(const vm_real *coefficient, vm_real x)
{
    vm_real before = 0, now = 1, sum = 0;
    int k;
    for (k = 0; k < VMI_GAUSS; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        sum += coefficient[k] * now;
        before = now;
        now = next;
    }
    return sum;
}

/* The integral of the series from -1 to x. The integral of P_k is (P_(k+1) - P_(k-1))/(2k+1). */
VM_API vm_real vmi_legendre_integral(const vm_real *coefficient, vm_real x)
{
    vm_real before = 1, now = x, sum = coefficient[0] * (1 + x);
    int k;
    for (k = 1; k < VMI_GAUSS; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        sum += coefficient[k] * (next - before) / (vm_real)(2 * k + 1);
        before = now;
        now = next;
    }
    return sum;
}

/* Replaces the coefficients c_k of the series by those of its derivative, d_k = (2k+1) (c_(k+1) + c_(k+3) + ...). */
VM_API void vmi_legendre_derive(vm_real *coefficient)
{
    vm_real sums[2] = {0, 0}; /* sums of the c_j with j > k, for even j and for odd j */
    int k;
    for (k = VMI_GAUSS - 1; k >= 0; k--) {
        const vm_real own = coefficient[k];
        coefficient[k] = (vm_real)(2 * k + 1) * sums[(k + 1) % 2];
        sums[k % 2] += own;
    }
}

/* The mean square of the series on [-1, 1] */
VM_API vm_real vmi_legendre_square(const vm_real *coefficient)
{
    vm_real sum = 0;
    int k;
    for (k = 0; k < VMI_GAUSS; k++) sum += coefficient[k] * coefficient[k] / (vm_real)(2 * k + 1);
    return sum;
}

/* The largest absolute value of the last three coefficients, or NaN if one of them is NaN. The terms that the series
   leaves out have about this size. */
VM_API vm_real vmi_legendre_tail(const vm_real *coefficient)
{
    vm_real largest = 0;
    int k;
    for (k = VMI_GAUSS - 3; k < VMI_GAUSS; k++) {
        const vm_real size = VM_FABS(coefficient[k]);
        if (!(size <= largest)) largest = size;
    }
    return largest;
}

#endif
/* oscillators/laws.h - laws of time for mass, stiffness and other numbers

   A vm_law is a number f(t): the mass of a body (kg), the stiffness of its spring (N/m^alpha), or the frequency (1/s)
   and the size (N) of a force on it (oscillators/forced.h). A constructor makes it: linear f0 + f1 t (346), quadratic,
   exponential, power, the points of a table, or a function of the user. The shortest useful call:
       vm_law mass = vm_law_linear(10, VM_C(-0.1)); // 10 kg, of which 0.1 kg leaks out per second
       vm_real m, rate;
       int status = vm_law_at(&mass, 20, &m, &rate); // 8 kg, -0.1 kg/s
   Each kind of law has a section below, with its own functions and the constructor that makes a vm_law point to them.
   No code outside the section depends on the kind. vm_law_inverse_integral (oscillators/panels.h) integrates 1/f from
   0 to t.
   Tests: tests/test_laws.c. */
#ifndef VARMASS_OSCILLATORS_LAWS_H
#define VARMASS_OSCILLATORS_LAWS_H

/* A user's law: writes f(t) and its rate df/dt, and returns 0, or another number where it fails. f must be smooth. */
typedef int (*vm_law_function)(vm_real t, vm_real *f, vm_real *rate, void *ctx);

/* The law of a mass, a stiffness or another number f(t). The constructors vm_law_linear, vm_law_table ... fill it;
   only change_time may be set by hand. The law points to the arrays of its table and to the user's function and ctx,
   which must outlive it. It also points to functions of this header, so on a GPU the constructor must be called on
   the GPU. */
typedef struct VM_TAG(vm_law) vm_law;
struct VM_TAG(vm_law) {
    vm_real f0, f1, f2;       /* numbers given to the constructor, in its order; 0 for tables and functions */
    int n;                    /* number of points of a table; 0 for the other laws */
    const vm_real *time;      /* n times of a table, s, rising; else null */
    const vm_real *value;     /* n values of a table, in the unit of f; else null */
    vm_law_function function; /* the user's function for vm_law_user; else null */
    void *ctx;                /* the user's pointer, last argument of function */
    vm_real change_time;      /* for vm_law_user only: the shortest time scale, s, on which f changes noticeably; 0 if
                                 it is unknown */
    /* Functions that depend on the kind of law; its constructor sets them. */
    int (*derivatives)(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f); /* null if this is no law */
    int (*validate)(const vm_law *law, int if_not_positive, vm_real t);       /* null: checking f(0), f(t) is enough */
    int (*exponential_form)(const vm_law *law, vm_real *base, vm_real *rate); /* null if the law has no such form */
    vm_real (*inverse_integral)(const vm_law *law, vm_real t);                /* null if there is no closed form */
};

/* -- What every kind of law shares -- */

/* The direction of an interval of time whose length has a sign: 1 forward, -1 backward */
VM_API int vmi_time_side(vm_real length) { return length < 0 ? -1 : 1; }

/* How many numbers the function `derivatives` of a law writes: f and its first six derivatives in f[0] ... f[6] */
enum { VMI_LAW_ORDERS = 7 };

/* Writes the value of a law at t and its derivatives to f[0], f[1] ... A constructor must have made the law. Where a
   derivative jumps at t, side = 1 asks for its value after t, side = -1 for its value before t. With length = 0 only
   f and f' are written. A positive length, s, asks for all six derivatives; those of a user's function are then found
   from its rates between t and t + side length. if_not_positive is the status for f <= 0, for example VM_BAD_MASS for
   a mass; it is VM_OK for numbers of any sign. */
VM_API int vmi_law_derivatives(const vm_law *law, int if_not_positive, vm_real t, int side, vm_real length, vm_real *f)
{
    int i, status;
    vm_real sum = 0; /* sum of f[i] - f[i], which is 0, or NaN if a number is infinite or NaN */
    if (length > 0)
        for (i = 2; i < VMI_LAW_ORDERS; i++) f[i] = 0;
    status = law->derivatives(law, t, side, length, f);
    if (status == VM_BAD_MASS) return if_not_positive ? if_not_positive : (int)VM_DOMAIN;
    if (status) return status;
    for (i = 0; i < (length > 0 ? VMI_LAW_ORDERS : 2); i++) sum += f[i] - f[i];
    if (!(sum == 0)) return VM_NOT_FINITE;
    if (if_not_positive && !(f[0] > 0)) return if_not_positive;
    return VM_OK;
}

/* Checks that a constructor made the law, and that the law is finite and positive between 0 and t, as far as this can
   be told without a walk from 0 to t. With if_not_positive = VM_OK the law may have any sign. A table is checked as a
   whole. */
VM_API int vmi_law_check(const vm_law *law, int if_not_positive, vm_real t)
{
    vm_real f[VMI_LAW_ORDERS];
    int status;
    if (!law->derivatives) return VM_BAD_ARGUMENT;
    status = vmi_law_derivatives(law, if_not_positive, 0, 1, 0, f);
    status = vmi_first_error(status, vmi_law_derivatives(law, if_not_positive, t, 1, 0, f));
    if (law->validate) status = vmi_first_error(status, law->validate(law, if_not_positive, t));
    return status;
}

/* Returns 1 and writes base and rate if the law is f0 exp(rate u) with u = ln(1 + base t)/base (u = t for base = 0);
   returns 0 otherwise. Integrals of products of such laws with the same base have closed forms. A constant has rate
   0. */
VM_API int vmi_law_exponential_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = *rate = 0;
    return law->exponential_form && law->exponential_form(law, base, rate);
}

/* The integral of dt/f from 0 to t for a law f with an exponential form */
VM_API vm_real vmi_law_exponential_inverse_integral(const vm_law *law, vm_real t)
{
    vm_real base, rate, u;
    vmi_law_exponential_form(law, &base, &rate);
    u = t * vmi_log_ratio(base * t);
    return u / law->f0 * vmi_exp_ratio((base - rate) * u);
}

/* Writes f and df/dt of any law at t, after a check of all arguments. Both are NaN if the status is not VM_OK. */
VM_API int vmi_law_at(const vm_law *law, int if_not_positive, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real values[VMI_LAW_ORDERS];
    int status;
    *f = *rate = VM_NAN;
    if (!law || !law->derivatives) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_derivatives(law, if_not_positive, t, 1, 0, values);
    if (status) return status;
    *f = values[0];
    *rate = values[1];
    return VM_OK;
}

/* Value f and rate df/dt of a law at time t (s), which may be negative. At the points of a table f is within 4 eps.
   f may have any sign, since a law does not know whether it is the law of a mass. Returns VM_BAD_ARGUMENT for null
   pointers and for a law that no constructor made, VM_NOT_FINITE where t or a result is infinite or NaN, and VM_DOMAIN
   where the law has no value: for t outside a table, for a power law where 1 + f1 t <= 0, and where the user's function
   fails. An error leaves *f and *rate untouched. */
VM_API int vm_law_at(const vm_law *law, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real value, slope;
    int status;
    if (!f || !rate) return VM_BAD_ARGUMENT;
    status = vmi_law_at(law, VM_OK, t, &value, &slope);
    if (status) return status;
    *f = value;
    *rate = slope;
    return VM_OK;
}

/* A law with the numbers f0, f1, f2, but without the functions of its kind, which the constructors below add */
VM_API vm_law vmi_law_of(vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law;
    law.f0 = f0;
    law.f1 = f1;
    law.f2 = f2;
    law.n = 0;
    law.time = NULL;
    law.value = NULL;
    law.function = NULL;
    law.ctx = NULL;
    law.change_time = 0;
    law.derivatives = NULL;
    law.validate = NULL;
    law.exponential_form = NULL;
    law.inverse_integral = NULL;
    return law;
}

/* -- Linear laws -- */

/* f and f' of a linear law; its higher derivatives are 0. */
VM_API int vmi_law_linear_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f)
{
    (void)side;
    (void)length;
    f[0] = law->f0 + law->f1 * t;
    f[1] = law->f1;
    return VM_OK;
}

/* The exponential form of a linear law: f0 (1 + base t) = f0 exp(base u) with u = ln(1 + base t)/base */
VM_API int vmi_law_linear_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = law->f1 / law->f0;
    *rate = *base;
    return 1;
}

/* The integral of dt/(f0 + f1 t) from 0 to t */
VM_API vm_real vmi_law_linear_inverse_integral(const vm_law *law, vm_real t)
{
    return t * vmi_log_ratio(law->f1 / law->f0 * t) / law->f0;
}

/* Linear law f = f0 + f1 t (346); a constant where f1 = 0. f0 is the value at t = 0, f1 the rate per second, for
   example in kg and kg/s. */
VM_API vm_law vm_law_linear(vm_real f0, vm_real f1)
{
    vm_law law = vmi_law_of(f0, f1, 0);
    law.derivatives = vmi_law_linear_derivatives;
    law.exponential_form = vmi_law_linear_form;
    law.inverse_integral = vmi_law_linear_inverse_integral;
    return law;
}

/* -- Quadratic laws -- */

/* f, f' and f'' of a quadratic law; its higher derivatives are 0. */
VM_API int vmi_law_quadratic_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f)
{
    (void)side;
    f[0] = law->f0 + t * (law->f1 + t * law->f2);
    f[1] = law->f1 + 2 * law->f2 * t;
    if (length > 0) f[2] = 2 * law->f2;
    return VM_OK;
}

/* Checks that f is positive at its minimum, if the minimum is between 0 and t. */
VM_API int vmi_law_quadratic_validate(const vm_law *law, int if_not_positive, vm_real t)
{
    vm_real f[VMI_LAW_ORDERS], lowest;
    if (!(law->f2 > 0)) return VM_OK;
    lowest = -law->f1 / (2 * law->f2);
    if (!(lowest * t > 0 && VM_FABS(lowest) < VM_FABS(t))) return VM_OK;
    return vmi_law_derivatives(law, if_not_positive, lowest, 1, 0, f);
}

/* The exponential form of a quadratic law that is a square within rounding errors: f0 (1 + base t)^2 = f0 exp(2 base u)
   with u = ln(1 + base t)/base */
VM_API int vmi_law_quadratic_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    const vm_real square = law->f1 * law->f1, rest = square - 4 * law->f0 * law->f2;
    *rate = law->f1 / law->f0;
    *base = *rate / 2;
    return VM_FABS(rest) <= 4 * VM_EPSILON * square;
}

/* The integral of dt/(f0 + f1 t + f2 t^2) from 0 to t. With x = 2 f0 + f1 t, D = f1^2 - 4 f0 f2 and d = sqrt|D| it is
   (2/d) atan(d t/x) for D < 0, and (2/d) atanh(d t/x) otherwise. */
VM_API vm_real vmi_law_quadratic_inverse_integral(const vm_law *law, vm_real t)
{
    const vm_real D = law->f1 * law->f1 - 4 * law->f0 * law->f2, x = 2 * law->f0 + law->f1 * t;
    const vm_real y = VM_SQRT(VM_FABS(D)) * VM_FABS(t), s = y / x;
    if (D < 0 && y > 0) return 2 * t / y * ateb_phase(y, x, 1);
    return 2 * t / x * vmi_log_ratio(2 * s / (1 - s)) / (1 - s);
}

/* Quadratic law f = f0 + f1 t + f2 t^2. f0 has the unit of f, f1 this unit per second, f2 this unit per second
   squared. */
VM_API vm_law vm_law_quadratic(vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law = vmi_law_of(f0, f1, f2);
    law.derivatives = vmi_law_quadratic_derivatives;
    law.validate = vmi_law_quadratic_validate;
    law.exponential_form = vmi_law_quadratic_form;
    law.inverse_integral = vmi_law_quadratic_inverse_integral;
    return law;
}

/* -- Exponential laws -- */

/* f and the derivatives of an exponential law; each derivative is f1 times the one before it */
VM_API int vmi_law_exponential_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f)
{
    const int orders = length > 0 ? VMI_LAW_ORDERS : 2;
    int i;
    (void)side;
    f[0] = law->f0 * vmi_exp(law->f1 * t, 0);
    for (i = 1; i < orders; i++) f[i] = law->f1 * f[i - 1];
    return VM_OK;
}

/* The exponential form of an exponential law, with base = 0, so that u = t */
VM_API int vmi_law_exponential_own_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = 0;
    *rate = law->f1;
    return 1;
}

/* Exponential law f = f0 exp(f1 t). f0 is the value at t = 0, f1 the relative rate, 1/s. */
VM_API vm_law vm_law_exponential(vm_real f0, vm_real f1)
{
    vm_law law = vmi_law_of(f0, f1, 0);
    law.derivatives = vmi_law_exponential_derivatives;
    law.exponential_form = vmi_law_exponential_own_form;
    law.inverse_integral = vmi_law_exponential_inverse_integral;
    return law;
}

/* -- Power laws -- */

/* f and the derivatives of a power law. Returns VM_BAD_MASS where 1 + f1 t is not positive; for laws of other numbers
   than masses vmi_law_derivatives changes this status. */
VM_API int vmi_law_power_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f)
{
    const vm_real base = 1 + law->f1 * t, relative_rate = law->f1 / base;
    const int orders = length > 0 ? VMI_LAW_ORDERS : 2;
    int i;
    (void)side;
    if (base <= 0) return VM_BAD_MASS;
    f[0] = law->f0 * vmi_pow_checked(base, law->f2);
    for (i = 1; i < orders; i++) f[i] = (law->f2 - (vm_real)(i - 1)) * relative_rate * f[i - 1];
    return VM_OK;
}

/* The exponential form of a power law: f0 (1 + f1 t)^f2 = f0 exp(f2 f1 u) with base = f1 and u = ln(1 + f1 t)/f1 */
VM_API int vmi_law_power_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = law->f1;
    *rate = law->f1 * law->f2;
    return 1;
}

/* Power law f = f0 (1 + f1 t)^f2, for 1 + f1 t > 0. f0 is the value at t = 0, f1 a rate, 1/s, and f2 a pure number of
   either sign. */
VM_API vm_law vm_law_power(vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law = vmi_law_of(f0, f1, f2);
    law.derivatives = vmi_law_power_derivatives;
    law.exponential_form = vmi_law_power_form;
    law.inverse_integral = vmi_law_exponential_inverse_integral;
    return law;
}

/* -- Tables -- */

/* Slope at an end of a table: the slope of the parabola through the last three points, limited so that the cubic
   stays monotone. h_end and d_end are the length and the slope of the chord at the end, h_next and d_next those of
   the chord next to it. */
VM_API vm_real vmi_law_end_slope(vm_real h_end, vm_real h_next, vm_real d_end, vm_real d_next)
{
    const vm_real slope = ((2 * h_end + h_next) * d_end - h_end * d_next) / (h_end + h_next);
    if (slope * d_end <= 0) return 0;
    if (d_end * d_next < 0 && VM_FABS(slope) > 3 * VM_FABS(d_end)) return 3 * d_end;
    return slope;
}

/* Slope at point i of a table. At inner points it is the weighted harmonic mean of the slopes of the chords on both
   sides, and 0 at an extremum (Fritsch and Butland). */
VM_API vm_real vmi_law_slope(const vm_law *law, int i)
{
    const vm_real *t = law->time, *f = law->value;
    const int last = law->n - 1;
    int middle = i;
    vm_real h0, h1, d0, d1;
    if (last == 1) return (f[1] - f[0]) / (t[1] - t[0]);
    if (i == 0) middle = 1;
    if (i == last) middle = last - 1;
    h0 = t[middle] - t[middle - 1];
    h1 = t[middle + 1] - t[middle];
    d0 = (f[middle] - f[middle - 1]) / h0;
    d1 = (f[middle + 1] - f[middle]) / h1;
    if (i == 0) return vmi_law_end_slope(h0, h1, d0, d1);
    if (i == last) return vmi_law_end_slope(h1, h0, d1, d0);
    if (d0 * d1 <= 0) return 0;
    return 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
}

/* The index i with time[i] <= t <= time[i+1]. If t is a point of the table, side tells on which side of t the
   interval lies. */
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

/* Writes f and its derivatives, for the cubic on the interval of the table that contains t. The cubic has the values
   and slopes of the interval's two points. */
VM_API int vmi_law_table_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f)
{
    vm_real chord_time, u, chord, slope0, slope1, b, c;
    int i;
    if (!(t >= law->time[0] && t <= law->time[law->n - 1]))
        return vmi_all_finite(law->n, law->time) ? VM_DOMAIN : VM_NOT_FINITE;
    i = vmi_law_interval(law, t, side);
    chord_time = law->time[i + 1] - law->time[i];
    u = t - law->time[i];
    chord = (law->value[i + 1] - law->value[i]) / chord_time;
    slope0 = vmi_law_slope(law, i);
    slope1 = vmi_law_slope(law, i + 1);
    b = (3 * chord - 2 * slope0 - slope1) / chord_time;
    c = (slope0 + slope1 - 2 * chord) / (chord_time * chord_time);
    f[0] = law->value[i] + u * (slope0 + u * (b + u * c));
    f[1] = slope0 + u * (2 * b + 3 * u * c);
    if (length > 0) {
        f[2] = 2 * b + 6 * u * c;
        f[3] = 6 * c;
    }
    return VM_OK;
}

/* Checks the whole table, whatever t is: its values must be finite and positive, its times must rise. */
VM_API int vmi_law_table_validate(const vm_law *law, int if_not_positive, vm_real t)
{
    int i;
    (void)t;
    if (!vmi_all_finite(law->n, law->value) || !vmi_all_finite(law->n, law->time)) return VM_NOT_FINITE;
    for (i = 0; i < law->n; i++)
        if (if_not_positive && !(law->value[i] > 0)) return if_not_positive;
    for (i = 1; i < law->n; i++)
        if (!(law->time[i] > law->time[i - 1])) return VM_DOMAIN;
    return VM_OK;
}

/* Table of n >= 2 points (time[i], value[i]), joined by monotone cubics. A table of fewer points, or with a null
   pointer, is no law: all functions refuse it with VM_BAD_ARGUMENT. Times (s) must rise, and every t of a call
   must lie between the first and the last. Between two points the law is a cubic with the slopes of Fritsch and
   Butland, which neither overshoots nor oscillates; its second derivative jumps at the points. */
VM_API vm_law vm_law_table(int n, const vm_real *time, const vm_real *value)
{
    vm_law law = vmi_law_of(0, 0, 0);
    law.n = n;
    law.time = time;
    law.value = value;
    if (n >= 2 && time && value) law.derivatives = vmi_law_table_derivatives; /* else there is no law */
    law.validate = vmi_law_table_validate;
    return law;
}

/* The next point of the law's table after t on the way to t_end, or t_end if there is none or the law is no table */
VM_API vm_real vmi_law_next_knot(const vm_law *law, vm_real t, vm_real t_end)
{
    const int side = t_end > t ? 1 : -1;
    vm_real knot;
    int i;
    if (!law->time) return t_end;
    i = vmi_law_interval(law, t, side);
    knot = law->time[side > 0 ? i + 1 : i];
    return (t_end - knot) * (vm_real)side > 0 ? knot : t_end;
}

/* Whether t is a point of the law's table, but not its first or last, so that the second derivative may jump there */
VM_API int vmi_law_has_knot(const vm_law *law, vm_real t)
{
    return law->time && vmi_law_interval(law, t, 1) != vmi_law_interval(law, t, -1);
}

/* -- Functions of the user -- */

/* Writes the Legendre series of the rate f' between t and t + length. */
VM_API int vmi_law_user_fit(const vm_law *law, vm_real t, vm_real length, vm_real *series)
{
    vm_real rates[VMI_GAUSS], same[VMI_GAUSS], unused;
    int i;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real at = t + length * ((1 + vmi_gauss_node(i)) / 2);
        if (law->function(at, &unused, &rates[i], law->ctx)) return VM_DOMAIN;
    }
    vmi_legendre_fit(rates, rates, series, same);
    return VM_OK;
}

/* Writes the series of the rate f' between t and t + *length. The length is halved until the last terms of the series
   are rounding errors, that is, until they do not become much smaller any more. Terms of their size are set to 0. The
   length is also halved where the user's function fails, because the function may be defined only close to t. */
VM_API int vmi_law_user_series(const vm_law *law, vm_real t, vm_real *length, vm_real *series)
{
    const int most_halvings = 24;
    vm_real tail, least = 0;
    int i, halvings = 0, status = vmi_law_user_fit(law, t, *length, series);
    while (status && halvings < most_halvings) {
        *length /= 2;
        status = vmi_law_user_fit(law, t, *length, series);
        halvings++;
    }
    for (; !status && halvings < most_halvings; halvings++) {
        vm_real shorter[VMI_GAUSS];
        tail = vmi_legendre_tail(series);
        least = 64 * VM_EPSILON * VM_SQRT(vmi_legendre_square(series));
        if (!(tail > least)) break;
        least = 4 * tail;
        status = vmi_law_user_fit(law, t, *length / 2, shorter);
        if (!(vmi_legendre_tail(shorter) < tail / 8)) break;
        *length /= 2;
        for (i = 0; i < VMI_GAUSS; i++) series[i] = shorter[i];
    }
    for (i = 0; i < VMI_GAUSS; i++)
        if (VM_FABS(series[i]) <= least) series[i] = 0;
    return status;
}

/* Writes f and f' from the user's function. For length > 0 it also writes the higher derivatives, from a Legendre
   series of f'. */
VM_API int vmi_law_user_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real *f)
{
    vm_real series[VMI_GAUSS], whole = (vm_real)side * length, scale = 1;
    int i, k, status;
    if (law->function(t, &f[0], &f[1], law->ctx)) return VM_DOMAIN;
    if (!(length > 0)) return VM_OK;
    status = vmi_law_user_series(law, t, &whole, series);
    if (status) return status;
    for (i = 2; i < VMI_LAW_ORDERS; i++) {
        vmi_legendre_derive(series);
        scale *= 2 / whole;
        for (k = 0; k < VMI_GAUSS; k += 2) f[i] += scale * (series[k] - series[k + 1]); /* P_k(-1) = (-1)^k */
    }
    return VM_OK;
}

/* Checks that change_time is finite and not negative, and 0 or at least |t|/2^20, so that every call ends. */
VM_API int vmi_law_user_validate(const vm_law *law, int if_not_positive, vm_real t)
{
    const vm_real most_changes = VM_C(1048576.);
    (void)if_not_positive;
    if (!VM_IS_FINITE(law->change_time)) return VM_NOT_FINITE;
    if (law->change_time < 0) return VM_DOMAIN;
    if (law->change_time > 0 && VM_FABS(t) > law->change_time * most_changes) return VM_DOMAIN;
    return VM_OK;
}

/* Law by a user's function, which must be smooth. A null function makes no law: all functions refuse it with
   VM_BAD_ARGUMENT. ctx is handed to the function. Integrals along the law evaluate the function at 20 points in each
   panel of time. A panel is at most |t|/32 long, and is halved where the function changes fast. So a bump
   exp(-(time/w)^2) is found if w > |t|/3000 (float |t|/2000). If the law changes in a shorter time, set law.change_time
   to that time, s: then no panel and no step of an integrator is longer than change_time. A change_time that is
   negative or less than |t|/2^20 is refused with VM_DOMAIN. */
VM_API vm_law vm_law_user(vm_law_function function, void *ctx)
{
    vm_law law = vmi_law_of(0, 0, 0);
    law.function = function;
    law.ctx = ctx;
    if (function) law.derivatives = vmi_law_user_derivatives; /* else there is no law */
    law.validate = vmi_law_user_validate;
    return law;
}

/* The longest panel of time, s, for integrals along the law from 0 to t: short enough to notice the changes that
   vm_law_user promises to find. `whole` is |t|. */
VM_API vm_real vmi_law_longest_panel(const vm_law *law, vm_real whole)
{
    const vm_real longest = whole / 32;
    if (!law->function) return whole;
    if (law->change_time > 0 && law->change_time < longest) return law->change_time;
    return longest;
}

#endif
/* oscillators/problem.h - the data of an oscillator whose mass and stiffness vary slowly, and of its motion

   The equation of motion, with mass m(t), stiffness k(t), damping b and a further small force F, is
     m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = F(t, x, x'),   x(0) and x'(0) given.
   Ten methods, called routes, compute x(t) and x'(t); oscillators/routes.h has them and shows the shortest useful call.
   `reactive` is 1 where mass that joins or leaves is at rest, and 0 where it has the body's velocity. With a plan
   (oscillators/plan.h) one motion is evaluated at many values of t.
   Tests: tests/test_averaging.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_PROBLEM_H
#define VARMASS_OSCILLATORS_PROBLEM_H

/* Routes to x(t) and x'(t), the cheapest first. All but the last three use averaging: mass and stiffness must change
   little within a period. */
enum {
    VM_ROUTE_TRIG = 0,        /* cosine (329), (330), averaged to first order; the sign of (335) is corrected */
    VM_ROUTE_JACOBI = 1,      /* Jacobi's cn (370), (371), averaged to first order */
    VM_ROUTE_ATEB = 2,        /* Ateb function ca (310), (311), averaged to first order */
    VM_ROUTE_ORDER2 = 3,      /* law of order five (oscillators/expansion.h), cut off after order two; only without F */
    VM_ROUTE_ORDER3 = 4,      /* law of order five, cut off after order three; only without F */
    VM_ROUTE_ORDER4 = 5,      /* law of order five, cut off after order four; only without F */
    VM_ROUTE_ORDER5 = 6,      /* the whole law of order five; only without F */
    VM_ROUTE_COLLOCATION = 7, /* integration from each zero of x to the next (oscillators/collocation.h) */
    VM_ROUTE_RK45 = 8,        /* integration of the equation of motion by rk45 */
    VM_ROUTE_RK87 = 9         /* integration of the equation of motion by rk87 */
};

/* The order, 2 to 5, of one of the routes VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5 */
VM_API int vmi_osc_order_of(int route) { return route - VM_ROUTE_ORDER2 + 2; }

/* The route VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5 that has this order, 2 to 5 */
VM_API int vmi_osc_route_of_order(int order) { return VM_ROUTE_ORDER2 + order - 2; }

/* A user's function for a further small force: returns F, N, at time t (s), position x (m) and velocity v (m/s) */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);

/* An oscillator and its state at t = 0 */
typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;      /* exponent of the spring's force, >= 0 */
    vm_law mass;        /* mass m(t), kg, positive */
    vm_law stiffness;   /* stiffness k(t), N/m^alpha, positive */
    vm_real reactive;   /* share of the full reactive force: 1 where mass that joins or leaves is at rest, 0 where this
                           mass has the body's own velocity, as in a leak; numbers between are allowed */
    vm_real damping;    /* damping b, kg/s, the dissertation's eps b; a positive b takes energy out */
    vm_real x, v;       /* position, m, and velocity, m/s, at t = 0 */
    vm_osc_force force; /* function for a further small force F, or NULL */
    void *ctx;          /* the user's pointer, last argument of force */
} vm_osc_problem;

/* The motion at one time */
typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;      /* position, m, and velocity, m/s */
    vm_real amplitude; /* amplitude A, m. By rk45 and rk87 it is that of x and v. The other routes leave out the
                          first-order ripple within a period that mass, stiffness and damping cause */
    vm_real error;     /* estimate of the larger of |error of x|/A and |error of v|/vmax, where vmax is the largest
                          velocity at the amplitude A; it includes all causes of errors */
    int route;         /* the route that was taken, VM_ROUTE_... */
    long evals;        /* evaluations of right-hand sides; 0 where nothing was integrated */
} vm_osc_motion;

/* Checks by vmi_law_check that mass and stiffness are finite and positive between 0 and t. */
VM_API int vmi_osc_check_laws(const vm_osc_problem *o, vm_real t)
{
    return vmi_first_error(vmi_law_check(&o->mass, VM_BAD_MASS, t),
                           vmi_law_check(&o->stiffness, VM_BAD_STIFFNESS, t));
}

/* Checks the problem's numbers, and its laws between 0 and t. Writes its mass and stiffness at t = 0. */
VM_API int vmi_osc_check_problem(const vm_osc_problem *o, vm_real t, vm_real *mass, vm_real *stiffness)
{
    const vm_real numbers[5] = {o->alpha, o->reactive, o->damping, o->x, o->v};
    vm_real f[VMI_LAW_ORDERS];
    int status = vmi_osc_check_laws(o, t);
    if (!vmi_all_finite(5, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (o->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    if (status) return status;
    status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, 0, 1, 0, f);
    *mass = f[0];
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, 0, 1, 0, f);
    *stiffness = f[0];
    return status;
}

#endif
/* oscillators/reduction.h - amplitude and phase of an oscillator that slow changes disturb in second order only

   The oscillator m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = 0 can be written d(mu x')/dt + kappa x|x|^(alpha-1)
   = 0, where a = mu'/mu = (reactive m' + b)/m and kappa/mu = k/m. `reactive` is 1 where mass that joins or leaves is at
   rest, and 0 where it has the body's velocity; b is the damping. Let p = (ln(mu kappa))'/(alpha+3) and V = x' + p x.
   Then x = A ca(psi) and V = -(2/(alpha+1)) W A sa(psi) define an amplitude A and a phase psi with the exact equations
     A'/A = -p + (G_0/W) sa ca,   psi' = W + (alpha+1)/2 (G_0/W) ca^2,   G_0 = p^2 - a p - p',
   where W is the rate of the phase for constant mass and stiffness. Only G_0 disturbs the slow motion A'/A = -p,
   psi' = W, and G_0 is of second order in the rates of mass and stiffness. Its derivatives lead to G_1, G_2 ...
   This file computes a, p and G_k from the derivatives of the laws, and A and psi from x and x', and back.
       vmi_osc_slow now;
       vmi_osc_reduced r;
       int status = vmi_osc_slow_at(&problem, 0, 1, 10, 1, &now); // laws at t = 0, from values up to 10 s
       if (!status) r = vmi_osc_reduce(&now, problem.alpha, problem.x, problem.v);
   Source: the transformations of Liouville and Kummer; docs/law.md. Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_REDUCTION_H
#define VARMASS_OSCILLATORS_REDUCTION_H

/* How many G_k are computed: the law of order five needs G_0 ... G_3, the estimate of its error G_4 */
enum { VMI_OSC_G = 5 };

/* Mass, stiffness and the numbers that follow from their rates, at one time */
typedef struct VM_TAG(vmi_osc_slow) {
    vm_real m, k;         /* mass, kg, and stiffness, N/m^alpha */
    vm_real a, p;         /* see above, 1/s */
    vm_real unit;         /* the unit of time of G, s: rates of very fast or slow motions have powers out of range */
    vm_real G[VMI_OSC_G]; /* unit^(i+2) G_i */
} vmi_osc_slow;

/* Mass, stiffness and rates at one time, without the numbers G_k: values f and rates f' of the laws are enough */
typedef struct VM_TAG(vmi_osc_rates) {
    vm_real m, k; /* mass, kg, and stiffness, N/m^alpha */
    vm_real a, p; /* the rates a = mu'/mu and p, 1/s */
} vmi_osc_rates;

/* Writes mass, stiffness and rates at t to *r. Where the rates jump at t, side = 1 asks for those after t, side = -1
   for those before t. Returns the statuses of vmi_law_derivatives. */
VM_API int vmi_osc_rates_at(const vm_osc_problem *o, vm_real t, int side, vmi_osc_rates *r)
{
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS];
    int status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, t, side, 0, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, 0, k);
    if (status) return status;
    r->m = m[0];
    r->k = k[0];
    r->a = (o->reactive * m[1] + o->damping) / m[0];
    r->p = (k[1] / k[0] + 2 * r->a - m[1] / m[0]) / (o->alpha + 3);
    return VM_OK;
}

/* -- Power series in time: element i of an array is the coefficient of the ith power -- */

/* Turns derivatives f, f', f'' ... into the coefficients of the series in time divided by the unit, s */
VM_API void vmi_series_of_derivatives(int n, vm_real unit, vm_real *f)
{
    int i, power;
    for (power = 1; power < n; power++)
        for (i = power; i < n; i++) f[i] *= unit / (vm_real)power;
}

/* Writes the series of f'/f to ratio, from the n coefficients of f; ratio has n - 1 coefficients. */
VM_API void vmi_series_log_rate(int n, const vm_real *f, vm_real *ratio)
{
    int i, j;
    for (i = 0; i < n - 1; i++) {
        vm_real sum = (vm_real)(i + 1) * f[i + 1];
        for (j = 1; j <= i; j++) sum -= f[j] * ratio[i - j];
        ratio[i] = sum / f[0];
    }
}

/* Writes the n coefficients of the series of 1/f to inverse. */
VM_API void vmi_series_inverse(int n, const vm_real *f, vm_real *inverse)
{
    int i, j;
    inverse[0] = 1 / f[0];
    for (i = 1; i < n; i++) {
        vm_real sum = 0;
        for (j = 1; j <= i; j++) sum -= f[j] * inverse[i - j];
        inverse[i] = sum / f[0];
    }
}

/* Coefficient i of the product of two series */
VM_API vm_real vmi_series_product(int i, const vm_real *f, const vm_real *g)
{
    vm_real sum = 0;
    int j;
    for (j = 0; j <= i; j++) sum += f[j] * g[i - j];
    return sum;
}

/* -- The numbers G_k -- */

/* Fills now->G from the series of a and p, which have n coefficients, by G_0 = p^2 - a p - p' and
   G_(k+1) = G_k' - (k+2) (2p - a) G_k. The array a is overwritten. */
VM_API void vmi_osc_find_G(int n, vm_real *a, vm_real *p, vmi_osc_slow *now)
{
    vm_real G[VMI_LAW_ORDERS], next[VMI_LAW_ORDERS];
    int i, k, terms = n - 1;
    for (i = 0; i < n; i++) a[i] = p[i] - a[i]; /* the series of p - a */
    for (i = 0; i < terms; i++) G[i] = vmi_series_product(i, p, a) - (vm_real)(i + 1) * p[i + 1];
    for (i = 0; i < n; i++) a[i] += p[i]; /* the series of 2 p - a */
    for (k = 0; k < VMI_OSC_G; k++) {
        now->G[k] = G[0];
        terms--;
        for (i = 0; i < terms; i++)
            next[i] = (vm_real)(i + 1) * G[i + 1] - (vm_real)(k + 2) * vmi_series_product(i, a, G);
        for (i = 0; i < terms; i++) G[i] = next[i];
    }
}

/* All of *now from m, k and their derivatives up to the sixth, which are destroyed; unit: see vmi_osc_slow */
VM_API void vmi_osc_slow_of(const vm_osc_problem *o, vm_real *m, vm_real *k, vm_real unit, vmi_osc_slow *now)
{
    const int n = VMI_LAW_ORDERS - 1;
    vm_real m_rate[VMI_LAW_ORDERS], k_rate[VMI_LAW_ORDERS], inverse[VMI_LAW_ORDERS];
    int i;
    now->m = m[0];
    now->k = k[0];
    now->unit = unit;
    vmi_series_of_derivatives(VMI_LAW_ORDERS, unit, m);
    vmi_series_of_derivatives(VMI_LAW_ORDERS, unit, k);
    vmi_series_log_rate(VMI_LAW_ORDERS, m, m_rate);
    vmi_series_log_rate(VMI_LAW_ORDERS, k, k_rate);
    vmi_series_inverse(n, m, inverse);
    for (i = 0; i < n; i++) {
        const vm_real a = o->reactive * m_rate[i] + o->damping * unit * inverse[i];
        m[i] = a;
        k[i] = (k_rate[i] + 2 * a - m_rate[i]) / (o->alpha + 3);
    }
    now->a = m[0] / unit;
    now->p = k[0] / unit;
    vmi_osc_find_G(n, m, k, now);
}

/* *now at t; where derivatives jump, after t for side = 1, before it for side = -1. length, s: see
   vmi_law_derivatives; unit, s: see vmi_osc_slow. VM_BAD_MASS, VM_BAD_STIFFNESS, VM_DOMAIN and VM_NOT_FINITE come
   from the laws. */
VM_API int vmi_osc_slow_at(const vm_osc_problem *o, vm_real t, int side, vm_real length, vm_real unit,
                           vmi_osc_slow *now)
{
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS];
    int status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, t, side, length, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, length, k);
    if (!status) vmi_osc_slow_of(o, m, k, unit, now);
    return status;
}

/* -- Amplitude and phase -- */

/* Amplitude and phase of the oscillator by the reduction, that is of x and V = x' + p x */
typedef struct VM_TAG(vmi_osc_reduced) {
    vm_real A;   /* amplitude, m */
    vm_real psi; /* Ateb phase */
    vm_real W;   /* rate of the phase at this amplitude for constant mass and stiffness, 1/s */
} vmi_osc_reduced;

/* The reduced state that belongs to position x and velocity v, at the time of *now */
VM_API vmi_osc_reduced vmi_osc_reduce(const vmi_osc_slow *now, vm_real alpha, vm_real x, vm_real v)
{
    const vm_real omega = VM_SQRT(now->k / now->m);
    vmi_osc_reduced r;
    vm_osc_amplitude_phase(x, v + now->p * x, omega, alpha, &r.A, &r.psi);
    r.W = r.A == 0 ? 0 : vmi_osc_rate(r.A, omega, alpha);
    return r;
}

/* The reduced state of vmi_osc_reduce for alpha >= 0, by shorter and slower code, which vm_osc_closed_init shares with
   vm_osc_plan_init. omega is sqrt(k/m), and V = v + p x. */
VM_API vmi_osc_reduced vmi_osc_reduce_by_series(vm_real omega, vm_real alpha, vm_real x, vm_real V)
{
    const vm_real n = alpha + 1, s = 0 - V / (VM_SQRT(2 / n) * omega); /* B^(n/2), as in vm_osc_amplitude_phase */
    const vm_real B = vmi_pow_checked(VM_FABS(s), 2 / n);
    vmi_osc_reduced r = {0, 0, 0};
    vmi_ateb c;
    r.A = vmi_osc_power_norm(VM_FABS(x), B, n);
    if (r.A == 0) return r;
    r.psi = VM_NAN;
    if (!vmi_ateb_has_phase(alpha)) return r;
    vmi_ateb_fine_constants(&c, alpha);
    r.psi = vmi_ateb_phase_by_series(c.quarter, alpha, VM_COPYSIGN(vmi_pow_checked(B / r.A, n / 2), s), x / r.A);
    r.W = vmi_osc_rate(r.A, omega, alpha);
    return r;
}

/* Writes position x and velocity v of a reduced state: the inverse of vmi_osc_reduce. sa and ca are the Ateb functions
   of its phase. */
VM_API void vmi_osc_unreduce(const vmi_osc_reduced *r, vm_real p, vm_real alpha, vm_real sa, vm_real ca, vm_real *x,
                             vm_real *v)
{
    *x = r->A * ca;
    *v = -2 / (alpha + 1) * r->W * r->A * sa - p * *x;
}

/* The numbers E_k = G_k/W^(k+2) of a reduced state whose phase has the rate W */
VM_API void vmi_osc_disturbance(const vmi_osc_slow *now, vm_real W, vm_real *E)
{
    const vm_real radian = 1 / (W * now->unit);
    vm_real power = radian * radian;
    int k;
    for (k = 0; k < VMI_OSC_G; k++) {
        E[k] = now->G[k] * power;
        power *= radian;
    }
}

#endif
/* oscillators/ripple.h - the ripple of ca^2 within a period, and its integrals over the Ateb phase

   Amplitude and phase of an oscillator whose mass or stiffness varies slowly swing a little about mean values. This
   ripple is computed from five functions of the Ateb phase psi. With C = ca^2(psi) - <ca^2>, where < > is the mean over
   a period, the other four functions are integrals over psi, each with the mean 0 and the period Pi_alpha:
     S = integral of C,   S2 = integral of S,   S3 = integral of S2,   Q = integral of C^2 - <C^2>.
   A vmi_ripple holds what is computed once for an alpha: two sets of four polynomials, and constants of the law of
   order five (oscillators/expansion.h). It is plain data and may lie in flash.
       vmi_ripple r;
       vmi_ripple_values f;
       vm_real sa, ca;
       vmi_ripple_init(&r, VM_C(1.5), vmi_ateb_constants);
       vmi_ripple_complete(&r);
       ateb_saca(VM_C(0.7), VM_C(1.5), &sa, &ca);
       vmi_ripple_at(&r, 5, VM_C(0.7), sa, ca, &f); // f.S, f.S2, f.S3, f.Q at psi = 0.7

   Method: the integrals from a zero of ca are |ca|^3, |ca|^4 or |ca|^5 times a power series in w = |ca|^(alpha+1). The
   integrals from a zero of sa are power series in y = sa^2, times sa or not. The first set is used for w < 1/2, the
   second for y <= 1/2. On [0, 1/2] each power series is replaced by the first terms of its Chebyshev series: 15 terms
   give 1e-12, 8 terms 1e-7, for every alpha.
   Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_RIPPLE_H
#define VARMASS_OSCILLATORS_RIPPLE_H

/* Numbers of terms: of each polynomial, of the Chebyshev series of a power w^i, and of the power series in w */
#if VM_MANT_DIG > 24
enum { VMI_RIPPLE_TERMS = 15, VMI_RIPPLE_KEPT = 24, VMI_RIPPLE_SERIES = 56 };
#else
enum { VMI_RIPPLE_TERMS = 8, VMI_RIPPLE_KEPT = 13, VMI_RIPPLE_SERIES = 28 };
#endif

/* The polynomials of a set: for the integrals of ca^2 and of ca^4, and for the first and the second integral of the
   integral of ca^2. All integrals begin at the nearest zero of ca, or of sa for the other set. */
enum { VMI_RIPPLE_CA2, VMI_RIPPLE_CA4, VMI_RIPPLE_FIRST, VMI_RIPPLE_SECOND, VMI_RIPPLE_FUNCTIONS };

/* Constants and polynomials for one alpha, prepared by vmi_ripple_init and vmi_ripple_complete */
typedef struct VM_TAG(vmi_ripple) {
    vm_real alpha;
    vm_real gamma;              /* (alpha-1)/(alpha+3): the rate of the phase is proportional to (action)^gamma */
    vm_real scale;              /* L = (alpha+1)(alpha+3)/4, a factor in the law of order five */
    vm_real pi;                 /* Pi_alpha, the period of C, S, S2, S3 and Q */
    vm_real mean2, mean4;       /* the means of ca^2 and ca^4 */
    vm_real variance;           /* the mean of C^2, where C = ca^2 - mean2 */
    int has_polynomials;        /* 1 where the fields below are set, else 0 */
    vm_real at_sa_0, at_ca_0;   /* values of S2 (second integral of C) at the phases with sa = 0 and with ca = 0 */
    vm_real near_ca_0[VMI_RIPPLE_FUNCTIONS][VMI_RIPPLE_TERMS]; /* polynomials in 4 w - 1, w = |ca|^(alpha+1) */
    vm_real near_sa_0[VMI_RIPPLE_FUNCTIONS][VMI_RIPPLE_TERMS]; /* polynomials in 4 y - 1, where y = sa^2 */
} vmi_ripple;

/* The functions of the ripple at one phase */
typedef struct VM_TAG(vmi_ripple_values) {
    vm_real sa, ca;
    vm_real C, S, S2, S3, Q; /* see the top of this file; S is valid from order 3 on, S2 from 4 on, S3 and Q for 5 */
} vmi_ripple_values;

/* -- Making the polynomials -- */

/* Coefficients i of all power series. For example the integral of ca^2 from a zero of ca is |ca|^3 times the sum of
   near_ca_0[VMI_RIPPLE_CA2] w^i over all i. */
typedef struct VM_TAG(vmi_ripple_series) {
    vm_real root;                 /* coefficient i of the power series of (1-w)^(-1/2) */
    vm_real power2, power3, power4; /* coefficients i of (1-y)^((j-alpha)/(alpha+1)) for j = 2, 3, 4 */
    vm_real product;              /* coefficient i of (1-y)^(1-nu) T, where nu = 2 alpha/(alpha+1) and
                                     T |sa| is the integral of ca^2 from a zero of sa */
    vm_real near_ca_0[VMI_RIPPLE_FUNCTIONS], near_sa_0[VMI_RIPPLE_FUNCTIONS];
} vmi_ripple_series;

/* Coefficient i of the power series of (1-y)^exponent, where `before` is coefficient i - 1 */
VM_API vm_real vmi_binomial_next(vm_real before, int i, vm_real exponent)
{
    if (i == 0) return 1;
    return before * ((vm_real)(i - 1) - exponent) / (vm_real)i;
}

/* Replaces the coefficients i - 1 of all power series by the coefficients i; for i = 0 all must be 0 before. Let D be
   the first and E the second integral of the integral of ca^2. The differential equations D'' = ca^2 and E'' = integral
   of ca^2, with derivatives by the phase, give each coefficient of D and E from the one before. */
VM_API void vmi_ripple_next_terms(vmi_ripple_series *s, int i, vm_real alpha)
{
    const vm_real n = alpha + 1, nu = 2 * alpha / n, k = (vm_real)(2 * i);
    const vm_real now = (vm_real)i * n, before = now - n;
    vm_real *zero = s->near_ca_0, *turn = s->near_sa_0;
    s->root = vmi_binomial_next(s->root, i, VM_C(-0.5));
    s->power2 = vmi_binomial_next(s->power2, i, (2 - alpha) / n);
    s->power3 = vmi_binomial_next(s->power3, i, (3 - alpha) / n);
    s->power4 = vmi_binomial_next(s->power4, i, (4 - alpha) / n);
    s->product = (s->product * (k - 3 + 2 * nu) + s->power4) / (k + 1);
    zero[VMI_RIPPLE_CA2] = n / 2 * s->root / (3 + now);
    zero[VMI_RIPPLE_CA4] = n / 2 * s->root / (5 + now);
    if (i == 0) zero[VMI_RIPPLE_FIRST] = n * n / 48;
    else zero[VMI_RIPPLE_FIRST] *= (4 + before) * (3 + before + n / 2) / ((4 + now) * (3 + now));
    zero[VMI_RIPPLE_SECOND] =
        (zero[VMI_RIPPLE_SECOND] * (5 + before) * (4 + before + n / 2) + n * n / 4 * zero[VMI_RIPPLE_CA2]) /
        ((5 + now) * (4 + now));
    turn[VMI_RIPPLE_CA2] = s->power2 / (k + 1);
    turn[VMI_RIPPLE_CA4] = s->power4 / (k + 1);
    turn[VMI_RIPPLE_FIRST] = (turn[VMI_RIPPLE_FIRST] * k * (k - 1 + nu) + s->power3) / ((k + 2) * (k + 1));
    turn[VMI_RIPPLE_SECOND] = (turn[VMI_RIPPLE_SECOND] * (k + 1) * (k + nu) + s->product) / ((k + 3) * (k + 2));
}

/* Multiplies the Chebyshev series sum c_k T_k(z) by w = (1 + z)/4, with z T_k = (T_(k+1) + T_(k-1))/2 */
VM_API void vmi_chebyshev_times_w(vm_real *c)
{
    const int last = VMI_RIPPLE_KEPT - 1;
    vm_real below = 0, first = c[0] + c[1] / 2; /* coefficient 0 of (1 + z) times the series */
    int k;
    for (k = 0; k <= last; k++) {
        const vm_real own = c[k], above = k < last ? c[k + 1] : 0;
        vm_real share = (below + above) / 2;
        if (k == 1) share += below / 2; /* z T_0 = T_1 */
        c[k] = (own + share) / 4;
        below = own;
    }
    c[0] = first / 4;
}

/* Turns a Chebyshev series into a polynomial in powers of z, by T_k = 2 z T_(k-1) - T_(k-2) */
VM_API void vmi_chebyshev_to_powers(vm_real *c)
{
    int j, k;
    for (j = 0; j < VMI_RIPPLE_TERMS; j++) {
        for (k = VMI_RIPPLE_TERMS - 1; k >= j + 2; k--) c[k - 2] -= c[k];
        for (k = j + 2; k < VMI_RIPPLE_TERMS; k++) c[k] *= 2;
    }
}

/* Makes all eight polynomials: adds up the power series, with each power w^i replaced by its Chebyshev series. */
VMI_APART void vmi_ripple_make_polynomials(vmi_ripple *r)
{
    vm_real w_power[VMI_RIPPLE_KEPT]; /* coefficients of the Chebyshev series of w^i */
    vmi_ripple_series s;
    int i, j, k;
    s.root = s.power2 = s.power3 = s.power4 = s.product = 0;
    for (j = 0; j < VMI_RIPPLE_FUNCTIONS; j++) {
        s.near_ca_0[j] = 0;
        s.near_sa_0[j] = 0;
        for (k = 0; k < VMI_RIPPLE_TERMS; k++) {
            r->near_ca_0[j][k] = 0;
            r->near_sa_0[j][k] = 0;
        }
    }
    for (k = 0; k < VMI_RIPPLE_KEPT; k++) w_power[k] = 0;
    w_power[0] = 1;
    for (i = 0; i < VMI_RIPPLE_SERIES; i++) {
        vmi_ripple_next_terms(&s, i, r->alpha);
        for (j = 0; j < VMI_RIPPLE_FUNCTIONS; j++)
            for (k = 0; k < VMI_RIPPLE_TERMS; k++) {
                r->near_ca_0[j][k] += s.near_ca_0[j] * w_power[k];
                r->near_sa_0[j][k] += s.near_sa_0[j] * w_power[k];
            }
        vmi_chebyshev_times_w(w_power);
    }
    for (j = 0; j < VMI_RIPPLE_FUNCTIONS; j++) {
        vmi_chebyshev_to_powers(r->near_ca_0[j]);
        vmi_chebyshev_to_powers(r->near_sa_0[j]);
    }
}

/* The value at z of a polynomial with the coefficients c */
VM_API vm_real vmi_ripple_polynomial(const vm_real *c, vm_real z)
{
    vm_real sum = c[VMI_RIPPLE_TERMS - 1];
    int k;
    for (k = VMI_RIPPLE_TERMS - 2; k >= 0; k--) sum = sum * z + c[k];
    return sum;
}

/* -- The integrals from a zero of ca or sa -- */

/* Integrals over the phase from the nearest zero of ca (or of sa) to a given phase */
typedef struct VM_TAG(vmi_ripple_integrals) {
    vm_real ca2, ca4, first, second; /* integrals of ca^2 and ca^4; first and second integral of ca2 */
} vmi_ripple_integrals;

/* A phase between a zero of ca or sa and the joint at sa^2 = 1/2, and what the integrals from this zero need there */
typedef struct VM_TAG(vmi_ripple_place) {
    const vm_real (*polynomial)[VMI_RIPPLE_TERMS]; /* near_ca_0 or near_sa_0 */
    vm_real z;        /* variable of the polynomials */
    vm_real x;        /* |ca| or |sa| */
    vm_real power2;   /* factor of the integral of ca^2 */
    vm_real power4;   /* factor of the integral of ca^4 */
} vmi_ripple_place;

/* The place where |ca| = x and sa^2 = y >= 1/2 */
VM_API vmi_ripple_place vmi_ripple_near_ca_0(const vmi_ripple *r, vm_real x, vm_real y)
{
    vmi_ripple_place at;
    at.polynomial = r->near_ca_0;
    at.z = 4 * (1 - y) - 1;
    at.x = x;
    at.power2 = x * x * x;
    at.power4 = at.power2 * x * x;
    return at;
}

/* The place where |sa| = u and sa^2 = y <= 1/2 */
VM_API vmi_ripple_place vmi_ripple_near_sa_0(const vmi_ripple *r, vm_real u, vm_real y)
{
    vmi_ripple_place at;
    at.polynomial = r->near_sa_0;
    at.z = 4 * y - 1;
    at.x = u;
    at.power2 = u;
    at.power4 = u;
    return at;
}

/* The integrals from the zero to the place. Those that the law of this order, 2 to 5, does not need are 0. */
VM_API vmi_ripple_integrals vmi_ripple_integrals_at(const vmi_ripple_place *at, int order)
{
    const vm_real once = at->power2 * at->x;
    vmi_ripple_integrals d;
    d.ca2 = at->power2 * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_CA2], at->z);
    d.ca4 = d.first = d.second = 0;
    if (order >= 4) d.first = once * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_FIRST], at->z);
    if (order >= 5) {
        d.ca4 = at->power4 * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_CA4], at->z);
        d.second = once * at->x * vmi_ripple_polynomial(at->polynomial[VMI_RIPPLE_SECOND], at->z);
    }
    return d;
}

/* -- Preparing an alpha, and the functions -- */

/* Prepares alpha >= 0 without the polynomials: only C can be computed, not S, S2, S3 and Q. constants is the function
   that computes Pi_alpha. */
VM_API void vmi_ripple_init(vmi_ripple *r, vm_real alpha, vmi_ateb_constants_of constants)
{
    vmi_ateb c;
    constants(&c, alpha);
    r->alpha = alpha;
    r->gamma = (alpha - 1) / (alpha + 3);
    r->scale = (alpha + 1) * (alpha + 3) / 4;
    r->pi = 2 * c.quarter.hi;
    r->mean2 = vmi_osc_mean_ca(2, alpha, r->pi, constants);
    r->mean4 = vmi_osc_mean_ca(4, alpha, r->pi, constants);
    r->variance = r->mean4 - r->mean2 * r->mean2;
    r->has_polynomials = 0;
}

/* Adds the polynomials, and S2 at the zeros of sa and of ca. These two values of S2 follow from the condition that both
   sets of polynomials give the same S2 and S3 at the phase where sa^2 = 1/2. */
VM_API void vmi_ripple_complete(vmi_ripple *r)
{
    const vm_real half = VM_C(0.5), sa = VM_SQRT(half), ca = vmi_pow_checked(half, 1 / (r->alpha + 1));
    const vm_real t = vmi_ateb_from_sa_0(r->alpha, sa, half), s = vmi_ateb_from_ca_0(r->alpha, ca, half);
    vmi_ripple_place place;
    vmi_ripple_integrals zero, turn;
    vm_real jump; /* at_sa_0 - at_ca_0 */
    if (r->has_polynomials) return;
    vmi_ripple_make_polynomials(r);
    place = vmi_ripple_near_ca_0(r, ca, half);
    zero = vmi_ripple_integrals_at(&place, 5);
    place = vmi_ripple_near_sa_0(r, sa, half);
    turn = vmi_ripple_integrals_at(&place, 5);
    jump = (zero.first - r->mean2 * s * s / 2) - (turn.first - r->mean2 * t * t / 2);
    r->at_ca_0 = -((turn.second - r->mean2 * t * t * t / 6) + (zero.second - r->mean2 * s * s * s / 6) + jump * t) /
                 (r->pi / 2);
    r->at_sa_0 = r->at_ca_0 + jump;
    r->has_polynomials = 1;
}

/* Writes the functions of the ripple at the phase psi, where sa and ca are the Ateb functions of psi. order, 2 to 5, is
   that of the law that needs them; above 2 the polynomials must have been made. */
VM_API void vmi_ripple_at(const vmi_ripple *r, int order, vm_real psi, vm_real sa, vm_real ca, vmi_ripple_values *f)
{
    const vm_real m = r->mean2, y = sa * sa, from_sa_0 = psi - r->pi * VM_FLOOR(psi / r->pi + VM_C(0.5));
    vm_real side = VM_COPYSIGN(1, from_sa_0), way = VM_FABS(from_sa_0), S2_at_0 = r->at_sa_0; /* way: from the zero */
    vmi_ripple_place place;
    vmi_ripple_integrals d;
    f->sa = sa;
    f->ca = ca;
    f->C = ca * ca - m;
    f->S = f->S2 = f->S3 = f->Q = 0;
    if (order < 3) return;
    if (y > VM_C(0.5)) {
        place = vmi_ripple_near_ca_0(r, VM_FABS(ca), y);
        side = -side;
        way = r->pi / 2 - way;
        S2_at_0 = r->at_ca_0;
    } else place = vmi_ripple_near_sa_0(r, VM_FABS(sa), y);
    d = vmi_ripple_integrals_at(&place, order);
    f->S = side * (d.ca2 - m * way);
    f->S2 = S2_at_0 + d.first - m * way * way / 2;
    f->S3 = side * (S2_at_0 * way + d.second - m * way * way * way / 6);
    f->Q = side * (d.ca4 - 2 * m * d.ca2 + (2 * m * m - r->mean4) * way);
}

#endif
/* oscillators/expansion.h - the law of order five: from the motion of an oscillator to its mean motion and back

   With slow mass and stiffness, amplitude A and phase psi of oscillators/reduction.h obey the exact equations
     A'/A = -p + (G_0/W) sa ca,   psi' = W + (alpha+1)/2 (G_0/W) ca^2,
   where W is the rate of the phase at the amplitude A. The slow motion A'/A = -p, psi' = W is disturbed by G_0/W^2
   only. This number is of second order in epsilon, the relative change of mass and stiffness within a radian.

   A canonical transformation leads from A and psi to mean values without ripple: a mean action, which is constant, and
   a mean phase, whose rate varies slowly. The action is J = A^((alpha+3)/2) sqrt(mu kappa). The transformation is a
   series in powers of the numbers E_k of order epsilon^(k+2), k = 0, 1 ...
     E_k = G_k/W^(k+2),   G_(k+1) = G_k' - (k+2) (2p - a) G_k.
   This file has the transformation in both directions, and the mean rate of the phase. Cut off after order N, it gives
   the motion with an error of O(epsilon^N) over times of 1/epsilon. The law is new; docs/law.md derives it.

   C, S, S2, S3 and Q are the functions of the phase in oscillators/ripple.h. The weight of a term is the power of
   epsilon in it: E_k has weight k + 2.
       vmi_ripple r;
       vmi_ripple_values f;
       vm_real E[VMI_EXPANSION_E] = {VM_C(1e-4), 0, 0, 0}, ln_J;
       vmi_ripple_init(&r, 1, vmi_ateb_constants); // a linear spring
       vmi_ripple_at(&r, 2, 0, 0, 1, &f);          // phase 0: sa = 0, ca = 1
       ln_J = vmi_expansion_J(&r, 2, &f, E); // ln of the mean action over the action
   Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_EXPANSION_H
#define VARMASS_OSCILLATORS_EXPANSION_H

/* How many E_k order five needs at the start of a motion: E_0 ... E_3 */
enum { VMI_EXPANSION_E = 4 };

/* -- From the motion to the mean motion -- */

/* Returns ln(mean action/action) with all terms up to weight `order`. f holds C, S ... at the phase psi. */
VM_API vm_real vmi_expansion_J(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, m = r->mean2, half = r->scale / 2, square = r->scale * r->scale / 8;
    vm_real sum = half * E[0] * f->C;
    if (order >= 3) sum -= half * E[1] * f->S;
    if (order >= 4) {
        const vm_real ripple = (2 - 3 * g) * r->variance - (1 + g) * f->C * f->C - 2 * (1 - g) * m * f->C;
        sum += half * E[2] * f->S2 + square * E[0] * E[0] * ripple;
    }
    if (order >= 5) {
        const vm_real ripple = 6 * (1 - g) * m * f->S + 2 * (2 - 3 * g) * f->Q + 6 * g * f->C * f->S;
        sum += square * E[0] * E[1] * ripple - half * E[3] * f->S3;
    }
    return sum;
}

/* Returns the mean phase minus the phase psi, with all terms up to weight order - 1. f holds C, S ... at psi. */
VM_API vm_real vmi_expansion_psi(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, m = r->mean2, half = r->scale / 2, square = r->scale * r->scale / 8;
    vm_real sum = 0;
    if (order >= 3) sum -= half * (1 - 2 * g) * E[0] * f->S;
    if (order >= 4) sum += half * (1 - 3 * g) * E[1] * f->S2;
    if (order >= 5) {
        const vm_real ripple = 4 * g * (1 - 2 * g) * f->C * f->S + (1 - 4 * g) * (2 - 3 * g) * f->Q +
                               2 * (1 - 4 * g) * (1 - g) * m * f->S;
        sum += square * E[0] * E[0] * ripple - half * (1 - 4 * g) * E[2] * f->S3;
    }
    return sum;
}

/* -- From the mean motion to the motion -- */

/* Returns the phase psi minus the mean phase, with all terms up to weight order - 1. f holds C, S ... at the mean
   phase. This is minus vmi_expansion_psi at the mean phase, and a product of first-order terms. */
VM_API vm_real vmi_expansion_psi_back(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real product = r->scale * r->scale / 4 * (1 - 2 * r->gamma) * E[0] * E[0] * f->C * f->S;
    const vm_real sum = -vmi_expansion_psi(r, order, f, E);
    return order >= 5 ? sum + product : sum;
}

/* Returns ln(action/mean action) with all terms up to weight order - 1, for an order from 3 to 5. f holds C, S ... at
   the mean phase. This is minus vmi_expansion_J at the mean phase, and a product of first-order terms. */
VM_API vm_real vmi_expansion_J_back(const vmi_ripple *r, int order, const vmi_ripple_values *f, const vm_real *E)
{
    const vm_real g = r->gamma, square = r->scale * r->scale / 2 * E[0] * E[0];
    const vm_real product = square * (2 / (r->alpha + 1) * (1 - 2 * g) * f->sa * f->ca * f->S - g * f->C * f->C);
    const vm_real sum = -vmi_expansion_J(r, order - 1, f, E);
    return order >= 5 ? sum + product : sum;
}

/* -- The mean rate of the phase -- */

/* The factor `first` of the mean rate of the phase, W (1 + first E_0 + second E_0^2), where W belongs to the mean
   action. Laws of all orders from 2 on need it. */
VM_API vm_real vmi_expansion_first(const vmi_ripple *r) { return (r->alpha + 1) / 2 * r->mean2; }

/* The factor `second` of the mean rate of the phase, W (1 + first E_0 + second E_0^2), which orders 4 and 5 need */
VM_API vm_real vmi_expansion_second(const vmi_ripple *r)
{
    return -r->scale * r->scale / 8 * r->variance * (2 - 3 * r->gamma) * (1 - 3 * r->gamma);
}

/* -- From state to mean state and back -- */

/* The state with the same constants whose ln J, where J is the action, is larger by ln_J, and whose phase is larger by
   shift */
VM_API vmi_osc_reduced vmi_expansion_shifted(const vmi_ripple *r, const vmi_osc_reduced *state, vm_real ln_J,
                                             vm_real shift)
{
    vmi_osc_reduced other;
    other.A = state->A * vmi_exp(2 / (r->alpha + 3) * ln_J, 0);
    other.psi = state->psi + shift;
    other.W = state->W * vmi_exp(r->gamma * ln_J, 0);
    return other;
}

/* The mean motion that belongs to a reduced state, by the law of this order, 2 to 5. sa and ca are the Ateb functions
   of its phase, and E holds its numbers E_k. Above order 2 the ripple must have its polynomials. */
VM_API vmi_osc_reduced vmi_expansion_to_mean(const vmi_ripple *r, int order, const vmi_osc_reduced *state, vm_real sa,
                                             vm_real ca, const vm_real *E)
{
    vmi_ripple_values f;
    vmi_ripple_at(r, order, state->psi, sa, ca, &f);
    return vmi_expansion_shifted(r, state, vmi_expansion_J(r, order, &f, E), vmi_expansion_psi(r, order, &f, E));
}

/* The reduced state that belongs to a mean motion, by the law of this order, 3 to 5; for order 2 both are the same. sa
   and ca are the Ateb functions of the mean phase, and E holds the numbers E_k of the mean motion. */
VM_API vmi_osc_reduced vmi_expansion_from_mean(const vmi_ripple *r, int order, const vmi_osc_reduced *mean, vm_real sa,
                                               vm_real ca, const vm_real *E)
{
    vmi_ripple_values f;
    vmi_ripple_at(r, order, mean->psi, sa, ca, &f);
    return vmi_expansion_shifted(r, mean, vmi_expansion_J_back(r, order, &f, E),
                                 vmi_expansion_psi_back(r, order, &f, E));
}

/* -- What the law of order five leaves out -- */

/* How large the terms of weight w are in vmi_expansion_J (J[w]) and in vmi_expansion_psi (psi[w]), for w = 2 to 6; psi[6]
   is only the part with E_4. They are of order epsilon^w, where epsilon is the relative change of mass and stiffness
   within a radian. */
typedef struct VM_TAG(vmi_expansion_sizes) {
    vm_real J[7], psi[7];
} vmi_expansion_sizes;

/* Fills the sizes of all terms, where e[k] is the absolute value of E_k = G_k/W^(k+2). */
VM_API void vmi_expansion_find_sizes(const vmi_ripple *r, const vm_real *e, vmi_expansion_sizes *size)
{
    const vm_real d = r->pi / (2 * VM_PI), L = r->scale, square = L * L / 8;
    vm_real power = L / 4;
    int w;
    for (w = 2; w <= 6; w++) {
        size->J[w] = e[w - 2] * power;
        power *= d;
        size->psi[w] = VM_FABS(1 - (vm_real)w * r->gamma) * e[w - 2] * power;
    }
    size->J[4] += square / 2 * e[0] * e[0];
    size->J[5] += square * e[0] * e[1] * d;
    size->J[6] += square * (e[0] * e[2] + e[1] * e[1]) * d * d + square * L / 2 * e[0] * e[0] * e[0];
    size->psi[4] += VM_C(0.3) * square * e[0] * e[0] * d;
    size->psi[5] += square * e[0] * e[1] * d * d;
}

/* A bound of the first terms that order five leaves out of the mean rate of the phase, divided by W. They have weight
   6; product is |E_0 E_2|, cube is |E_0|^3. If product and cube are integrals of these numbers over the phase, the
   result is a bound of the error of the phase. */
VM_API vm_real vmi_expansion_third_rate(const vmi_ripple *r, vm_real product, vm_real cube)
{
    const vm_real d = r->pi / (2 * VM_PI), L = r->scale, g = r->gamma;
    return L * L / 64 * VM_FABS((1 - 5 * g) * (2 - 5 * g)) * d * d * product + VM_C(0.01) * L * L * L * cube;
}

/* How large the terms are that an order leaves out: relative in J, and of the phase */
typedef struct VM_TAG(vmi_left_out) {
    vm_real J, psi;
} vmi_left_out;

/* How large the first terms are that the transformation of this order leaves out at t, where e[k] = |E_k|. Since the
   terms of the next weight may vanish, those of the weight after it count, too. */
VM_API vmi_left_out vmi_expansion_left_out_at(const vmi_ripple *r, int order, const vm_real *e)
{
    vmi_expansion_sizes size;
    vmi_left_out now;
    vmi_expansion_find_sizes(r, e, &size);
    now.psi = size.psi[order];
    if (order < 5) now.psi += size.psi[order + 1];
    now.J = size.J[order] + size.J[order + 1];
    return now;
}

/* How large the first terms are that the mean motion of this order leaves out at the start, where e[k] = |E_k| */
VM_API vmi_left_out vmi_expansion_left_out_at_start(const vmi_ripple *r, int order, const vm_real *e)
{
    vmi_expansion_sizes size;
    vmi_left_out start;
    vmi_expansion_find_sizes(r, e, &size);
    start.psi = size.psi[order];
    start.J = size.J[order + 1];
    return start;
}

/* The estimate of the larger of |error of x|/A and |error of v|/vmax that follows from what is left out: `now` at t,
   `start` at the start and on the way, `third` of the mean rate of the phase (vmi_expansion_third_rate). turns is the
   phase from 0 to t; errors of ln J at the start grow with it. A factor of 2 fits the errors that
   tests/test_slow_motion.c finds. */
VM_API vm_real vmi_expansion_error(const vmi_ripple *r, vmi_left_out now, vmi_left_out start, vm_real turns,
                                   vm_real third)
{
    const vm_real n = r->alpha + 1;
    const vm_real phase = now.psi + (start.psi + VM_FABS(r->gamma) * turns * start.J + 2 * third);
    return 4 / n * phase + 4 / (n + 2) * (now.J + start.J);
}

#endif
/* oscillators/closed.h - the law of order five as plain data, where all its integrals have closed forms

   A vm_osc_closed predicts the motion of m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = 0 at any time t. It needs no
   integrator, no table of a law and no pointer, so it may be a constant in the flash of a microcontroller
   (examples/print_plan.c prints it). Mass and stiffness must be
     m = m0 exp(rate_m u),   k = k0 exp(rate_k u),   u = ln(1 + base t)/base, or u = t for base = 0,
   with a common base: they may be constant, linear, exponential or powers of the same 1 + base t. With damping the mass
   must be constant or linear. The order, 2 to 5, is a choice: a lower order is less accurate (docs/law.md) and
   shorter. vm_osc_closed_at_order2 and vm_osc_closed_at_order3 leave out the code that only higher orders need.
       vm_osc_problem sieve = {3,            vm_law_linear(120, -20), vm_law_linear(VM_C(4e8), 0), 0, 0,
                               VM_C(0.005), 0,                       NULL,                        NULL};
       vm_osc_closed motion;
       vm_real x, v;
       int status = vm_osc_closed_init(&motion, &sieve, 5, 3); // motion.error holds up to 3 s
       if (!status) status = vm_osc_closed_at(&motion, 1, &x, &v);

   Method: let p and a be the rates of oscillators/reduction.h at t = 0. Then
     G_0 = p (p - a + base),   delta = p + (p - a + base),   el = 1 + base t,   p(t) = p/el,   A = A(0) exp(-p u),
     W = W(0) exp(delta u)/el,   E_k = (k+1)! E_0(0) (-delta/W(0))^k exp(-(k+2) delta u),
   where A and W are the mean amplitude and the mean rate of the phase. Integrals of W, W E_0 and W E_0^2 over t are
   differences of exponentials. Sources: docs/law.md. Tests: tests/test_closed_law.c. */
#ifndef VARMASS_OSCILLATORS_CLOSED_H
#define VARMASS_OSCILLATORS_CLOSED_H

/* -- The laws -- */

/* Mass and stiffness as exponentials of the same u; see the top of this file. All are in 1/s. */
typedef struct VM_TAG(vmi_osc_rates_of_u) {
    vm_real base, rate_m, rate_k;
} vmi_osc_rates_of_u;

/* Finds the exponential form of both laws. Returns 0 if there is none in a common u, or if the integral of b/m is not
   proportional to u. It is so for m = m0 (1 + base t), which includes a constant mass with base = 0. */
VM_API int vmi_osc_find_closed_form(const vm_osc_problem *o, vmi_osc_rates_of_u *u)
{
    vm_real base_m, base_k;
    if (!vmi_law_exponential_form(&o->mass, &base_m, &u->rate_m)) return 0;
    if (!vmi_law_exponential_form(&o->stiffness, &base_k, &u->rate_k)) return 0;
    if (o->force) return 0;
    u->base = base_m;
    if (u->rate_m == 0) u->base = base_k;
    if (u->rate_m == 0 && u->rate_k == 0) u->base = 0;
    if (u->rate_m != 0 && u->rate_k != 0 && base_m != base_k) return 0;
    return o->damping == 0 || u->rate_m == u->base;
}

/* What the disturbances at t = 0 depend on, in 1/s: p, and delta and rest = p - a + base, so that G_0 = p rest */
typedef struct VM_TAG(vmi_osc_closed_rates) {
    vm_real p, rest, delta;
} vmi_osc_closed_rates;

/* The rates at t = 0, where m0 is the mass, kg. Differences that vanish in exact arithmetic, such as base - a for a
   linear mass with the full reactive force, vanish here, too. */
VM_API vmi_osc_closed_rates vmi_osc_closed_rates_of(const vm_osc_problem *o, const vmi_osc_rates_of_u *u, vm_real m0)
{
    const vm_real decay = o->damping / m0;
    vmi_osc_closed_rates r;
    r.p = (u->rate_k + (2 * o->reactive - 1) * u->rate_m + 2 * decay) / (o->alpha + 3);
    r.rest = r.p + ((u->base - o->reactive * u->rate_m) - decay);
    r.delta = r.p + r.rest;
    return r;
}

/* Writes E_0 ... E_(n-1), n <= VMI_OSC_G, for the rate W of the phase. */
VM_API void vmi_osc_closed_disturbance(const vmi_osc_closed_rates *r, vm_real W, int n, vm_real *E)
{
    const vm_real step = r->delta / W;
    int k;
    E[0] = r->p / W * (r->rest / W);
    for (k = 1; k < n; k++) E[k] = -(vm_real)(k + 1) * step * E[k - 1];
}

/* -- The mean motion -- */

/* The mean motion at t = 0, and what is needed to follow it to any t */
typedef struct VM_TAG(vmi_osc_closed_mean) {
    vmi_osc_reduced start;      /* mean amplitude, m, mean phase, and W, the rate that the action gives it, 1/s */
    vm_real base;               /* 1/s; see the top of this file */
    vmi_osc_closed_rates rates; /* rates at t = 0 */
    vm_real first, second;      /* what E_0 and E_0^2 add to the rate of the mean phase at t = 0, 1/s */
} vmi_osc_closed_mean;

/* The mean motion at t; u, el and delta are explained at the top of this file. */
typedef struct VM_TAG(vmi_osc_closed_now) {
    vmi_osc_reduced state; /* mean amplitude, m, mean phase, and the rate W that the action gives it, 1/s */
    vm_real u, el;         /* u is in s */
    vm_real ln_A;          /* ln(A/A(0)) of the mean amplitude A */
    vm_real ratio;         /* W/W(0) */
    vm_real decay;         /* exp(-delta u) */
    vm_real inverse;       /* the integral of `decay` over u, s */
    vm_real phase;         /* the integral of W/W(0) from 0 to t, s */
    vm_real first, second; /* the parts of the mean phase that are proportional to E_0 and to E_0^2 */
} vmi_osc_closed_now;

/* Prepares the mean motion, whose values at t = 0 are *start. */
VM_API void vmi_osc_closed_mean_init(vmi_osc_closed_mean *c, const vmi_osc_reduced *start, vm_real base,
                                     const vmi_osc_closed_rates *rates, const vmi_ripple *r)
{
    vm_real E;
    c->start = *start;
    c->base = base;
    c->rates = *rates;
    c->first = 0;
    c->second = 0;
    if (start->W == 0) return; /* a body at rest at x = 0 */
    vmi_osc_closed_disturbance(rates, start->W, 1, &E);
    c->first = vmi_expansion_first(r) * start->W * E;
    c->second = vmi_expansion_second(r) * start->W * E * E;
}

/* Returns e^x and writes (e^x - 1)/x to *ratio, which is 1 for x = 0, both within 2 ulp. With e^x = 2^k (1 + p), where
   |p| < 0.42, e^x - 1 is 2^k p + (2^k - 1). */
VM_API vm_real vmi_exp_and_ratio(vm_real x, vm_real *ratio)
{
    const vm_real largest = VM_MANT_DIG > 24 ? 1400 : 180; /* beyond it e^x is infinite or 0 */
    const vm_real inside = vmi_smaller(vmi_larger(x, -largest), largest);
    vm_real p_lo, p, scale;
    int k;
    p = vmi_exp_core(inside, 0, &k, &p_lo);
    scale = vmi_ldexp(1, k);
    *ratio = 1;
    if (x != 0) *ratio = (scale * p + (scale - 1)) / x;
    return scale + scale * p;
}

/* The mean motion at t, where 1 + base t must be positive. The integral of exp(-3 delta u) is that of exp(-delta u)
   times (1 + decay + decay^2)/3. */
VM_API void vmi_osc_closed_mean_at(const vmi_osc_closed_mean *c, vm_real t, vmi_osc_closed_now *now)
{
    const vm_real u = t * vmi_log_ratio(c->base * t);
    vm_real decay, inverse, ratio;
    decay = 1 / vmi_exp_and_ratio(c->rates.delta * u, &ratio);
    now->phase = u * ratio;
    inverse = now->phase * decay;
    now->u = u;
    now->el = 1 + c->base * t;
    now->decay = decay;
    now->inverse = inverse;
    now->first = c->first * inverse;
    now->second = c->second * inverse * (1 + decay * (1 + decay)) / 3;
    now->ln_A = -c->rates.p * u;
    now->state.A = c->start.A * vmi_exp(now->ln_A, 0);
    now->state.psi = c->start.psi + (c->start.W * now->phase + (now->first + now->second));
    now->ratio = 1 / (decay * now->el);
    now->state.W = c->start.W * now->ratio;
}

/* Writes the first n numbers E_k at the time of *now. */
VM_API void vmi_osc_closed_disturbance_at(const vmi_osc_closed_mean *c, const vmi_osc_closed_now *now, int n,
                                          vm_real *E)
{
    vmi_osc_closed_disturbance(&c->rates, c->start.W / now->decay, n, E);
}

/* A bound of what order five leaves out of the mean phase between 0 and the time of *now (vmi_expansion_third_rate) */
VM_API vm_real vmi_osc_closed_third(const vmi_osc_closed_mean *c, const vmi_osc_closed_now *now, const vmi_ripple *r)
{
    const vm_real q = now->decay, sum = 1 + q * (1 + q * (1 + q * (1 + q))); /* as in vmi_osc_closed_mean_at */
    vm_real E[3], e;
    vmi_osc_closed_disturbance(&c->rates, c->start.W, 3, E);
    e = VM_FABS(E[0]);
    return c->start.W * VM_FABS(now->inverse) * sum / 5 * vmi_expansion_third_rate(r, e * VM_FABS(E[2]), e * e * e);
}

/* -- The object -- */

/* The motion of one oscillator as plain data. vm_osc_closed_init fills it. Read its fields, but do not change them. */
typedef struct VM_TAG(vm_osc_closed) {
    int order;                /* order of the law, 2 to 5 */
    int beyond;               /* the status for times with 1 + base t <= 0: VM_BAD_MASS or VM_BAD_STIFFNESS */
    vm_real error;            /* estimate, from t = 0 to t_end of vm_osc_closed_init, of the larger of |error of x|/A
                                 and |error of v|/vmax, where vmax is the largest velocity at the amplitude A; it is
                                 infinite where the error is unknown */
    vmi_osc_closed_mean mean; /* the mean motion */
    ateb_plan ateb;           /* Ateb functions for alpha */
    vmi_ripple ripple;        /* functions of the ripple for alpha; order 2 leaves out its polynomials */
} vm_osc_closed;

/* -- Preparing it -- */

/* What vm_osc_closed_init computes before it writes anything */
typedef struct VM_TAG(vmi_osc_closed_start) {
    vmi_osc_rates_of_u laws;
    vmi_osc_closed_rates rates;
    vmi_osc_reduced state; /* the reduced state at t = 0 */
    vm_real E[VMI_OSC_G];  /* its numbers E_k */
} vmi_osc_closed_start;

/* Checks that the terms of the law of order five are small at the start: (alpha+1)(alpha+3)/4 (|E_0| + d^3 |E_3|) < 1/2
   with d = (alpha + 1 + pi)/(2 pi), which is more than Pi_alpha/(2 pi). Then no number overflows. */
VM_API int vmi_osc_closed_is_slow(const vm_real *E, vm_real alpha)
{
    const vm_real d = (alpha + 1 + VM_PI) / (2 * VM_PI), L = (alpha + 1) * (alpha + 3) / 4;
    return L * (VM_FABS(E[0]) + d * d * d * VM_FABS(E[3])) < VM_C(0.5);
}

/* Checks the problem from t = 0 to t_end, and computes *s. */
VMI_APART int vmi_osc_closed_check(const vm_osc_problem *o, vm_real t_end, vmi_osc_closed_start *s)
{
    vm_real m0 = 0, k0 = 0;
    int status = vmi_osc_check_problem(o, t_end, &m0, &k0);
    if (status) return status;
    if (!vmi_osc_find_closed_form(o, &s->laws)) return VM_NO_LAW;
    s->rates = vmi_osc_closed_rates_of(o, &s->laws, m0);
    s->state = vmi_osc_reduce_by_series(VM_SQRT(k0 / m0), o->alpha, o->x, o->v + s->rates.p * o->x);
    if (!VM_IS_FINITE(s->state.A) || !VM_IS_FINITE(s->state.psi) || !VM_IS_FINITE(s->state.W)) return VM_NOT_FINITE;
    if (s->state.A == 0) return VM_OK;
    vmi_osc_closed_disturbance(&s->rates, s->state.W, VMI_OSC_G, s->E);
    return vmi_osc_closed_is_slow(s->E, o->alpha) ? VM_OK : VM_NO_LAW;
}

/* The estimate of the error at all times from 0 to t_end, where E holds the numbers E_k of the state at t = 0. All of
   the estimate's terms rise or fall steadily with t, so that the larger values at both ends are bounds. */
VM_API vm_real vmi_osc_closed_error(const vm_osc_closed *c, int order, const vm_real *E, vm_real t_end)
{
    const vmi_ripple *r = &c->ripple;
    const vm_real largest_known = VM_C(0.25); /* where the estimate is larger the error is unknown */
    vm_real e0[VMI_OSC_G], e[VMI_OSC_G], turns, error;
    vmi_osc_closed_now end;
    int k;
    vmi_osc_closed_mean_at(&c->mean, t_end, &end);
    vmi_osc_closed_disturbance_at(&c->mean, &end, VMI_OSC_G, e);
    for (k = 0; k < VMI_OSC_G; k++) {
        e0[k] = VM_FABS(E[k]);
        e[k] = vmi_larger(e0[k], VM_FABS(e[k]));
    }
    if (!(r->scale * e[0] < VM_C(0.5))) return VM_INFINITY;
    turns = VM_FABS(c->mean.start.W * end.phase);
    error = vmi_expansion_error(r, vmi_expansion_left_out_at(r, order, e),
                                vmi_expansion_left_out_at_start(r, order, e0), turns,
                                vmi_osc_closed_third(&c->mean, &end, r)) +
            4 * VM_EPSILON * (2 + turns);
    return error < largest_known ? error : VM_INFINITY;
}

/* Finds the mean motion at t = 0 and the estimate of the error, when the rest of *c is ready. */
VMI_APART void vmi_osc_closed_begin(vm_osc_closed *c, int order, const vmi_osc_closed_start *s, vm_real t_end)
{
    vmi_osc_reduced mean = s->state;
    vm_real sa, ca;
    c->order = order;
    c->error = 0;
    if (mean.A != 0) {
        ateb_plan_saca(&c->ateb, mean.psi, &sa, &ca);
        mean = vmi_expansion_to_mean(&c->ripple, order, &s->state, sa, ca, s->E);
    }
    vmi_osc_closed_mean_init(&c->mean, &mean, s->laws.base, &s->rates, &c->ripple);
    if (mean.A != 0) c->error = vmi_osc_closed_error(c, order, s->E, t_end);
}

/* Prepares the motion of the problem by the law of an order, 2 to 5; a higher order is more accurate. c->error holds
   for times between 0 and t_end, s, of either sign. The problem is not needed any more afterwards. An error leaves *c
   untouched; it returns
     VM_BAD_ARGUMENT for null pointers, another order, and a law that no constructor made,
     VM_NOT_FINITE for a number that is infinite or NaN,
     VM_BAD_MASS or VM_BAD_STIFFNESS for a law that is not positive at 0 or t_end,
     VM_DOMAIN for alpha < 0,
     VM_NO_LAW for laws without the closed form at the top of this file, for a force F, and where mass, stiffness or
       damping changes the motion so fast that the law of order five does not hold; use vm_osc_plan_init then.
   The time is that of some 100 values; order 2 needs less than half of it. */
VM_API int vm_osc_closed_init(vm_osc_closed *c, const vm_osc_problem *problem, int order, vm_real t_end)
{
    vmi_osc_closed_start s;
    int status;
    if (!c || !problem || order < 2 || order > 5) return VM_BAD_ARGUMENT;
    if (VM_IS_FINITE(t_end)) status = vmi_osc_closed_check(problem, t_end, &s);
    else status = vmi_first_error(VM_NOT_FINITE, vmi_osc_closed_check(problem, 0, &s));
    if (status) return status;
    c->beyond = s.laws.rate_m != 0 ? VM_BAD_MASS : VM_BAD_STIFFNESS;
    ateb_plan_init(&c->ateb, problem->alpha);
    vmi_ripple_init(&c->ripple, problem->alpha, vmi_ateb_fine_constants);
    if (order > 2) vmi_ripple_complete(&c->ripple);
    vmi_osc_closed_begin(c, order, &s, t_end);
    return VM_OK;
}

/* -- Using it -- */

/* Checks the arguments of a value by the law of this order. */
VM_API int vmi_osc_closed_check_call(const vm_osc_closed *c, int order, vm_real t, const vm_real *x, const vm_real *v)
{
    if (!c || !x || !v || order > c->order) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!(1 + c->mean.base * t > 0)) return c->beyond;
    return VM_OK;
}

/* Writes the motion at t by the law of an order that is at most that of *c. */
VM_API int vmi_osc_closed_motion(const vm_osc_closed *c, int order, vm_real t, vm_real *x, vm_real *v)
{
    const vmi_osc_closed_mean *mean = &c->mean;
    vmi_osc_closed_now now;
    vm_real E[VMI_EXPANSION_E] = {0, 0, 0, 0}, sa, ca, result[2] = {0, 0}; /* E_3 is not needed here */
    int status = vmi_osc_closed_check_call(c, order, t, x, v);
    if (status) return status;
    if (mean->start.A != 0) {
        vmi_osc_closed_mean_at(mean, t, &now);
        ateb_plan_saca(&c->ateb, now.state.psi, &sa, &ca);
        if (order > 2) {
            vmi_osc_closed_disturbance_at(mean, &now, 3, E);
            now.state = vmi_expansion_from_mean(&c->ripple, order, &now.state, sa, ca, E);
            ateb_plan_saca(&c->ateb, now.state.psi, &sa, &ca);
        }
        vmi_osc_unreduce(&now.state, mean->rates.p / now.el, c->ripple.alpha, sa, ca, &result[0], &result[1]);
    }
    if (!VM_IS_FINITE(result[0]) || !VM_IS_FINITE(result[1])) return VM_NOT_FINITE;
    *x = result[0];
    *v = result[1];
    return VM_OK;
}

/* Position x, m, and velocity v, m/s, at time t, s, of either sign, by the law of the order for which *c was prepared.
   c->error estimates the error up to t_end of vm_osc_closed_init. An error leaves *x and *v untouched: VM_BAD_ARGUMENT
   for null pointers, VM_NOT_FINITE where t or a result is infinite or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS where a law
   is not positive at t. The results have the bits of vm_osc_plan_by_route if *c has order 5. */
VM_API int vm_osc_closed_at(const vm_osc_closed *c, vm_real t, vm_real *x, vm_real *v)
{
    int order = 0;
    if (c) order = c->order;
    return vmi_osc_closed_motion(c, order, t, x, v);
}

/* As vm_osc_closed_at, but by order 2 for any order of *c. Alone it links the shortest code: no ripple. */
VM_API int vm_osc_closed_at_order2(const vm_osc_closed *c, vm_real t, vm_real *x, vm_real *v)
{
    return vmi_osc_closed_motion(c, 2, t, x, v);
}

/* As vm_osc_closed_at, but by order 3; *c must have order 3 or more, else VM_BAD_ARGUMENT. It links shorter code. */
VM_API int vm_osc_closed_at_order3(const vm_osc_closed *c, vm_real t, vm_real *x, vm_real *v)
{
    return vmi_osc_closed_motion(c, 3, t, x, v);
}

#endif
/* oscillators/plan.h - the plan of an oscillator: what is computed once and then used at many times t

   A plan holds the amplitude and the phase at t = 0, the mean motion at t = 0 by the law of order five
   (oscillators/expansion.h), and the closed forms of the laws of mass and stiffness, if they have such forms:
       vm_osc_plan plan;
       int status = vm_osc_plan_init(&plan, &problem); // problem is a vm_osc_problem
   Tests: tests/test_slow_motion.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_PLAN_H
#define VARMASS_OSCILLATORS_PLAN_H

/* What is computed only once for a problem, by vm_osc_plan_init. Read its fields, but do not change them. The plan
   points to the tables, functions and contexts of the problem, so it is of no use to another program. */
typedef struct VM_TAG(vm_osc_plan) {
    vm_osc_problem problem;  /* a copy of the problem */
    vm_real m0, k0;          /* mass, kg, and stiffness, N/m^alpha, at t = 0 */
    vm_real A, psi, Om;      /* amplitude, m, and Ateb phase of x and v at t = 0, and rate of the phase, 1/s */
    vmi_osc_slow slow;       /* mass, stiffness and G_k just after t = 0 */
    vm_real E[VMI_OSC_G];    /* the numbers E_k at t = 0 (see vmi_osc_disturbance) */
    vmi_osc_reduced mean;    /* amplitude, phase and rate of the mean motion at t = 0 */
    int start_order;         /* order by which `mean` was found: 5, or 2 without the polynomials of the ripple;
                                0 where x and v are 0, so that there is no mean motion */
    int closed;              /* 1 where all integrals along the laws have closed forms, else 0 */
    vmi_osc_rates_of_u laws; /* where closed is 1, the rates of mass and stiffness (oscillators/closed.h) */
    vmi_osc_closed_mean closed_mean; /* where closed is 1, what the mean motion at any t needs */
    int has_ateb;            /* 1 where the field ateb is set, else 0 */
    vmi_ripple ripple;       /* functions of the ripple, prepared for alpha */
    ateb_plan ateb;          /* Ateb functions, prepared for alpha */
} vm_osc_plan;

/* The periodic function, cos, cn or ca, by which a route describes the oscillation. It points into the plan, which must
   outlive it. */
VM_API vmi_osc_wave vmi_osc_wave_of(const vm_osc_plan *p, int route)
{
    if (route == VM_ROUTE_TRIG) return vmi_osc_wave_cos(p->problem.alpha, p->ripple.pi);
    if (route == VM_ROUTE_JACOBI) return vmi_osc_wave_cn(p->problem.alpha, p->ripple.pi);
    return vmi_osc_wave_ca(p->problem.alpha, p->has_ateb ? &p->ateb : NULL);
}

/* The time, s, of 16 radians of the phase. From rates within such a time the derivatives of a user's law are found. */
VM_API vm_real vmi_osc_sampling_time(const vm_osc_plan *p)
{
    if (!(p->Om > 0)) return 0;
    return 16 / p->Om;
}

/* The mean motion that belongs to a reduced state, by the law of this order, 2 to 5. E holds the numbers E_k of the
   state. */
VM_API vmi_osc_reduced vmi_osc_mean_of(const vm_osc_plan *p, int order, const vmi_osc_reduced *state, const vm_real *E)
{
    const vmi_osc_wave w = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vm_real sa, ca;
    vmi_osc_wave_at(&w, state->psi, &ca, &sa);
    return vmi_expansion_to_mean(&p->ripple, order, state, sa, ca, E);
}

/* The function that computes constants of the Ateb functions: accurate for many values, as a vm_osc_closed does, and fast
   for a single value */
VM_API vmi_ateb_constants_of vmi_osc_constants_of(int for_many)
{
    if (for_many) return vmi_ateb_fine_constants;
    return vmi_ateb_constants;
}

/* Computes the mean motion at t = 0, by order 5 if the ripple has its polynomials, else by order 2. */
VM_API int vmi_osc_start(vm_osc_plan *p)
{
    const vm_osc_problem *o = &p->problem;
    vmi_osc_closed_rates rates = {0, 0, 0};
    vmi_osc_reduced state;
    int status;
    p->start_order = 0;
    if (p->A == 0) return VM_OK;
    status = vmi_osc_slow_at(o, 0, 1, vmi_osc_sampling_time(p), 1 / p->Om, &p->slow);
    if (status) return status;
    if (p->closed) {
        rates = vmi_osc_closed_rates_of(o, &p->laws, p->m0);
        p->slow.p = rates.p;
    }
    if (p->has_ateb)
        state = vmi_osc_reduce_by_series(VM_SQRT(p->slow.k / p->slow.m), o->alpha, o->x, o->v + p->slow.p * o->x);
    else state = vmi_osc_reduce(&p->slow, o->alpha, o->x, o->v);
    if (p->closed) vmi_osc_closed_disturbance(&rates, state.W, VMI_OSC_G, p->E);
    else vmi_osc_disturbance(&p->slow, state.W, p->E);
    p->start_order = 2;
    if (p->ripple.has_polynomials) p->start_order = 5;
    p->mean = vmi_osc_mean_of(p, p->start_order, &state, p->E);
    if (p->closed) vmi_osc_closed_mean_init(&p->closed_mean, &p->mean, p->laws.base, &rates, &p->ripple);
    return VM_OK;
}

/* Fills the plan up to the mean motion, which vmi_osc_start adds. It leaves out two parts that are worth their time
   only for many values: the plan of the Ateb functions and the polynomials of the ripple. for_many is 1 if they are
   added. */
VM_API int vmi_osc_prepare(vm_osc_plan *p, const vm_osc_problem *problem, int for_many)
{
    const vm_osc_problem *o = &p->problem;
    vm_real omega;
    int status;
    p->problem = *problem;
    p->has_ateb = 0;
    status = vmi_osc_check_problem(o, 0, &p->m0, &p->k0);
    if (status) return status;
    omega = VM_SQRT(p->k0 / p->m0);
    vmi_ripple_init(&p->ripple, o->alpha, vmi_osc_constants_of(for_many));
    vm_osc_amplitude_phase(o->x, o->v, omega, o->alpha, &p->A, &p->psi);
    p->Om = p->A == 0 ? 0 : vmi_osc_rate(p->A, omega, o->alpha);
    if (!VM_IS_FINITE(p->A) || !VM_IS_FINITE(p->psi) || !VM_IS_FINITE(p->Om)) return VM_NOT_FINITE;
    p->closed = vmi_osc_find_closed_form(o, &p->laws);
    return VM_OK;
}

/* Plan for many values of one problem's motion.
   vm_osc_plan_by_route, vm_osc_plan_within and vm_osc_averaged use the
   plan. The problem is copied; its tables and contexts must outlive the plan. Errors leave the plan untouched. Returns
   VM_BAD_ARGUMENT for null pointers and for a law that no constructor made, VM_NOT_FINITE, VM_BAD_MASS and
   VM_BAD_STIFFNESS for a law that is not positive at t = 0 or in a table, VM_DOMAIN for alpha < 0, a table out of order
   or without t = 0, or a user's function of a law that fails. */
VM_API int vm_osc_plan_init(vm_osc_plan *p, const vm_osc_problem *problem)
{
    vm_osc_plan plan;
    int status;
    if (!p || !problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(&plan, problem, 1);
    if (status) return status;
    plan.has_ateb = ateb_plan_init(&plan.ateb, problem->alpha) == 0;
    vmi_ripple_complete(&plan.ripple);
    status = vmi_osc_start(&plan);
    if (!status) *p = plan;
    return status;
}

#endif
/* oscillators/panels.h - panels of time in which a law is smooth, and the integral of 1/f

   An integral along a law f(t) from 0 to t is a sum over intervals of time, called panels. Each panel is so short that
   a series of 20 Legendre polynomials represents the law on it. A panel that is too long for its series is halved; each
   next panel is tried with twice the length of the one before. Panels end at the points of a table.
       vm_law mass = vm_law_linear(10, VM_C(-0.1));
       vm_real integral;
       int status = vm_law_inverse_integral(&mass, 20, &integral); // 10 ln(10/8) s/kg
   Tests: tests/test_laws.c. */
#ifndef VARMASS_OSCILLATORS_PANELS_H
#define VARMASS_OSCILLATORS_PANELS_H

/* -- The lengths of panels -- */

/* The panels from t to end, one after the other. The loop over them is
     while (vmi_panels_next(&p)) {
         ... from p.t over p.side * p.step ...
         if (too long && vmi_panels_halve(&p)) continue;
         ... use the panel ...
         vmi_panels_advance(&p);
     } */
typedef struct VM_TAG(vmi_panels) {
    vm_real t, end;         /* start of the present panel and end of the last one, s */
    vm_real side;           /* 1 forward, -1 backward in time */
    vm_real longest, least; /* bounds of a panel's length, s */
    vm_real size;           /* intended length of the present panel, s */
    vm_real left, step;     /* time left to the end, and length of the present panel, which is at most `left`, s */
    int halved;             /* how often panels were halved */
} vmi_panels;

/* Panels from start to end, each at most `longest` long; `whole` is the length of the whole integral, s */
VM_API vmi_panels vmi_panels_from(vm_real start, vm_real end, vm_real longest, vm_real whole)
{
    vmi_panels p;
    p.t = start;
    p.end = end;
    p.side = VM_COPYSIGN(1, end - start);
    p.longest = vmi_smaller(longest, VM_FABS(end - start));
    p.least = whole / VM_C(1099511627776.); /* 2^40; what a shorter panel adds does not matter */
    p.size = p.longest;
    p.left = 0;
    p.step = 0;
    p.halved = 0;
    return p;
}

/* Returns whether there is a panel at p->t, and sets its length p->step. If the time left is hardly longer than a
   panel, all of it becomes one panel. */
VM_API int vmi_panels_next(vmi_panels *p)
{
    if (p->t == p->end) return 0;
    p->left = VM_FABS(p->end - p->t);
    p->step = p->size;
    if (p->left <= p->size * VM_C(1.0001)) p->step = p->left;
    return 1;
}

/* Halves the intended length of the present panel, and returns whether that was possible */
VM_API int vmi_panels_halve(vmi_panels *p)
{
    const int most = 4096; /* a bound for laws with noise, for which no length is short enough */
    if (!(p->step > p->least) || p->halved >= most || p->t + p->side * (p->step / 2) == p->t) return 0;
    p->size = p->step / 2;
    p->halved++;
    return 1;
}

/* Goes on to the next panel, which is to be twice as long */
VM_API void vmi_panels_advance(vmi_panels *p)
{
    if (p->step == p->left) p->t = p->end;
    else p->t += p->side * p->step;
    p->size = vmi_smaller(2 * p->step, p->longest);
}

/* -- Whether a series is good enough -- */

/* The relative size below which the last terms of a series do not matter. Gauss' rule integrates twice as many terms
   exactly, so that the error of an integral is about the square of the last terms. A panel that is a small part of
   the whole integral may be less accurate. */
VM_API vm_real vmi_panel_limit(vm_real length, vm_real whole)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(1e-5);
    const vm_real matters = VM_EPSILON / 4 * whole / VM_FABS(length);
    return vmi_larger(enough, matters);
}

/* Whether the last terms of a series are within limit, relative to its mean */
VM_API int vmi_panel_is_resolved(const vm_real *series, vm_real limit)
{
    return vmi_legendre_tail(series) <= limit * series[0];
}

/* Bound of the difference between a law and its series at the ends of a panel, where all terms that are left out add
   up */
VM_API vm_real vmi_panel_edge_limit(vm_real limit) { return 16 * limit; }

/* Raises *edge to the relative difference between f and `by_series`, its value by a series. With `reciprocal` the
   series is that of 1/f. */
VM_API void vmi_panel_raise_edge(int reciprocal, vm_real f, vm_real by_series, vm_real *edge)
{
    const vm_real ratio = by_series * (reciprocal ? f : 1 / f), miss = VM_FABS(ratio - 1);
    if (!(miss <= *edge)) *edge = miss;
}

/* Raises *edge to the relative difference between a law and its series at the ends of the panel. With `reciprocal`
   the series is that of 1/f. Only this test notices a kink between an end and the nearest point of Gauss' rule. */
VM_API int vmi_panel_edge(const vm_law *law, int if_not_positive, int reciprocal, vm_real start, vm_real length,
                          const vm_real *series, vm_real *edge)
{
    const int side = vmi_time_side(length);
    vm_real at_start = 0, at_end = 0, f[VMI_LAW_ORDERS];
    int k, status;
    for (k = 0; k < VMI_GAUSS; k += 2) { /* Legendre's P_k(1) is 1, P_k(-1) is (-1)^k */
        at_start = at_start + series[k] - series[k + 1];
        at_end = at_end + series[k] + series[k + 1];
    }
    status = vmi_law_derivatives(law, if_not_positive, start, side, 0, f);
    if (status) return status;
    vmi_panel_raise_edge(reciprocal, f[0], at_start, edge);
    status = vmi_law_derivatives(law, if_not_positive, start + length, -side, 0, f);
    if (status) return status;
    vmi_panel_raise_edge(reciprocal, f[0], at_end, edge);
    return VM_OK;
}

/* -- The integral of 1/f -- */

/* Computes the series of 1/f on a panel. Sets *edge to its largest relative difference from 1/f at the panel's ends. */
VM_API int vmi_law_inverse_series(const vm_law *law, vm_real start, vm_real length, vm_real *series, vm_real *edge)
{
    const int side = vmi_time_side(length);
    vm_real values[VMI_GAUSS], same[VMI_GAUSS], f[VMI_LAW_ORDERS];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        status = vmi_law_derivatives(law, VM_BAD_MASS, t, side, 0, f);
        if (status) return status;
        values[i] = 1 / f[0];
    }
    vmi_legendre_fit(values, values, series, same);
    *edge = 0;
    return vmi_panel_edge(law, VM_BAD_MASS, 1, start, length, series, edge);
}

/* Adds the integral of dt/f from start to end to *sum; a table must have no point between them. `whole` is the length
   of the whole integral. */
VM_API int vmi_law_add_inverse_integral(const vm_law *law, vm_real start, vm_real end, vm_real whole, vm_real *sum)
{
    vmi_panels p = vmi_panels_from(start, end, vmi_law_longest_panel(law, whole), whole);
    while (vmi_panels_next(&p)) {
        const vm_real length = p.side * p.step, limit = vmi_panel_limit(length, whole);
        vm_real series[VMI_GAUSS], edge;
        int status = vmi_law_inverse_series(law, p.t, length, series, &edge);
        if (status) return status;
        if (!(edge <= vmi_panel_edge_limit(limit)) || !vmi_panel_is_resolved(series, limit))
            if (vmi_panels_halve(&p)) continue;
        *sum += length * series[0];
        vmi_panels_advance(&p);
    }
    return VM_OK;
}

/* The integral of dt/f from 0 to t by panels, from one point of a table to the next */
VM_API int vmi_law_inverse_integral_by_panels(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real at = 0;
    int status = VM_OK;
    *integral = 0;
    while (!status && at != t) {
        const vm_real next = vmi_law_next_knot(law, at, t);
        status = vmi_law_add_inverse_integral(law, at, next, VM_FABS(t), integral);
        at = next;
    }
    return status;
}

/* Integral of ds/f(s) from 0 to t, s per unit of f, for t of either sign. A closed form is used if the law has one; it
   loses no digits where it tends to 0/0. Tables and functions use Gauss' rule; for functions the relative error is at
   most 1e-13 (float 1e-5) if f changes no faster than vm_law_user says. Returns VM_BAD_ARGUMENT for null pointers and
   for a law that no constructor made, VM_NOT_FINITE for numbers that are infinite or NaN, VM_BAD_MASS where f <= 0
   anywhere between 0 and t, and VM_DOMAIN for t outside a table, for a table out of order, where the user's function
   fails, or where the law's change_time is negative or less than |t|/2^20. An error leaves *integral untouched. */
VM_API int vm_law_inverse_integral(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real sum;
    int status;
    if (!law || !law->derivatives || !integral) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_check(law, VM_BAD_MASS, t);
    if (status) return status;
    if (law->inverse_integral) sum = law->inverse_integral(law, t);
    else status = vmi_law_inverse_integral_by_panels(law, t, &sum);
    if (status) return status;
    return vmi_copy_if_finite(1, &sum, integral);
}

#endif
/* oscillators/walk.h - the mean motion of an oscillator along laws that have no closed form

   The mean motion at t follows from integrals along the laws of mass and stiffness from 0 to t. vmi_osc_walk_to adds up
   these integrals over panels of time (oscillators/panels.h), from one point of a table to the next. At such a point
   the second derivatives of the laws jump, so that the mean motion jumps, too. The walk also gathers what the estimates
   of the error need: how large E_0 = G_0/W^2 and its derivatives are. E_0 measures how much changes of mass and
   stiffness, and the damping, disturb the motion (oscillators/expansion.h).
       vmi_osc_mean mean;
       int status = vmi_osc_walk_to(&plan, 10, &mean); // plan is a vm_osc_plan; mean.psi, mean.inverse_mass, ...
   Tests: tests/test_slow_motion.c, tests/test_averaging.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_WALK_H
#define VARMASS_OSCILLATORS_WALK_H

/* The number of derivatives of E_0 by the phase whose sizes are gathered: from the zeroth to the sixth */
enum { VMI_WALK_ORDERS = 7 };

/* The mean motion at one time t, and what its errors depend on. By the adiabatic law, which keeps the action constant,
   A/A0 = exp(ln_A), and the rate of the phase is `ratio` times its value at t = 0. */
typedef struct VM_TAG(vmi_osc_mean) {
    vmi_osc_slow now;      /* mass, stiffness and G_k just before t; for t < 0 just after t */
    vm_real E[VMI_OSC_G];  /* the numbers E_k = G_k/W^(k+2) at t, for the rate W of the mean phase */
    vm_real ln_A, ratio;   /* ln(A/A0), and the phase rate divided by its value at t = 0, both by the adiabatic law */
    vm_real inverse_mass;  /* the integral of dt/m from 0 to t, s/kg */
    vm_real phase;         /* the integral of ratio dt from 0 to t, s */
    vm_real psi;           /* the mean phase */
    vm_real ln_J;          /* ln of the mean action over its value at t = 0; it changes only at points of tables */
    vm_real first;         /* the part of psi that is proportional to E_0, see `largest` */
    vm_real second, third; /* the part of psi proportional to E_0^2; a bound of what order five leaves out of psi */
    vm_real knots_J[4];    /* for orders 2 to 5: sum of the squares of the errors of ln J at points of tables */
    vm_real knots_psi[4];  /* for orders 2 to 5: sum of the squares of the errors of psi at points of tables */
    vm_real largest;       /* largest |E_0| between 0 and t; E_0 = G_0/W^2 measures how much the motion is disturbed */
    /* Element i, from 0 to 6, is the integral of |d^i E_0/dpsi^i| dpsi from time 0 to t, where d^i/dpsi^i is the ith
       derivative by the phase. All elements are 0 where closed forms of the laws are used. */
    vm_real change[VMI_WALK_ORDERS];
    vm_real dropped;       /* integral over psi of the part of |E_0| that is not in `change` */
    vm_real shortest;      /* the shortest panel that the laws of mass and stiffness needed, s */
    vm_real error;         /* estimated error of `phase`, s */
} vmi_osc_mean;

/* Writes ln(A/A0) and ln(Om/Om0) by the adiabatic law, where Om is the rate of the phase. ln_m = ln(m/m0),
   ln_k = ln(k/k0), and decay is the integral of b/m over time, where b is the damping. */
VM_API void vmi_osc_adiabatic(const vm_osc_plan *p, vm_real ln_m, vm_real ln_k, vm_real decay, vm_real *ln_A,
                              vm_real *ln_Om)
{
    const vm_real alpha = p->problem.alpha, r = 2 * p->problem.reactive - 1, g = p->ripple.gamma;
    *ln_A = -(ln_k + r * ln_m + 2 * decay) / (alpha + 3);
    *ln_Om = ((1 - g) * ln_k - (1 + g * r) * ln_m) / 2 - g * decay;
}

/* The mean motion at t = 0 of the oscillator for which the plan was made */
VM_API vmi_osc_mean vmi_osc_mean_at_0(const vm_osc_plan *p)
{
    vmi_osc_mean mean;
    int i;
    mean.now = p->slow;
    vmi_osc_disturbance(&p->slow, p->mean.W, mean.E);
    mean.ln_A = 0;
    mean.ratio = 1;
    mean.inverse_mass = 0;
    mean.phase = 0;
    mean.psi = p->mean.psi;
    mean.ln_J = 0;
    mean.first = 0;
    mean.second = 0;
    mean.third = 0;
    mean.largest = VM_FABS(p->E[0]);
    for (i = 0; i < 4; i++) {
        mean.knots_J[i] = 0;
        mean.knots_psi[i] = 0;
    }
    for (i = 0; i < VMI_WALK_ORDERS; i++) mean.change[i] = 0;
    mean.dropped = 0;
    mean.shortest = VM_INFINITY;
    mean.error = 0;
    return mean;
}

/* The amplitude, phase and rate of the mean motion *mean */
VM_API vmi_osc_reduced vmi_osc_mean_state(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    vmi_osc_reduced state;
    state.A = p->mean.A * vmi_exp(mean->ln_A + 2 / (r->alpha + 3) * mean->ln_J, 0);
    state.W = p->mean.W * mean->ratio * vmi_exp(r->gamma * mean->ln_J, 0);
    state.psi = mean->psi;
    return state;
}

/* -- A panel -- */

/* A panel of the walk: Legendre series of the laws on it, and what it adds to integrals along the laws */
typedef struct VM_TAG(vmi_osc_panel) {
    vm_real edge;               /* largest relative difference between 1/m or k and its series at the panel's ends */
    vm_real inverse[VMI_GAUSS]; /* series of 1/m */
    vm_real ratio[VMI_GAUSS];   /* series of k at first, then of the phase rate divided by its value at t = 0 */
    vm_real E[VMI_GAUSS];       /* series of E_0 = G_0/W^2 */
    vm_real noise;              /* size of the coefficients of E that rounding errors of p' cause */
    vm_real first, second;      /* integrals of E_0 and of E_0^2 over the phase */
    vm_real cube;               /* integral of |E_0|^3 over the phase */
    vm_real largest;            /* largest |E_0| on the panel */
} vmi_osc_panel;

/* Mass, stiffness and rates at the points of Gauss' rule of a panel */
typedef struct VM_TAG(vmi_osc_panel_laws) {
    vmi_osc_rates rates[VMI_GAUSS];
    vm_real p_rate[VMI_GAUSS]; /* time derivatives of the field p of `rates`, 1/s^2 */
} vmi_osc_panel_laws;

/* Reads the laws at the points of Gauss' rule. Writes the series of 1/m and of k, and how far they are from the laws at
   the ends of the panel. */
VM_API int vmi_osc_read_laws(const vm_osc_problem *o, int side, vm_real start, vm_real length, vmi_osc_panel_laws *at,
                             vmi_osc_panel *panel)
{
    vm_real inverse[VMI_GAUSS], stiffness[VMI_GAUSS], rate[VMI_GAUSS], p[VMI_GAUSS], same[VMI_GAUSS];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        status = vmi_osc_rates_at(o, t, side, &at->rates[i]);
        if (status) return status;
        inverse[i] = 1 / at->rates[i].m;
        stiffness[i] = at->rates[i].k;
        rate[i] = at->rates[i].p;
    }
    vmi_legendre_fit(inverse, stiffness, panel->inverse, panel->ratio);
    vmi_legendre_fit(rate, rate, p, same);
    vmi_legendre_derive(p);
    for (i = 0; i < VMI_GAUSS; i++) at->p_rate[i] = 2 / length * vmi_legendre_at(p, vmi_gauss_node(i));
    panel->edge = 0;
    status = vmi_panel_edge(&o->mass, VM_BAD_MASS, 1, start, length, panel->inverse, &panel->edge);
    if (status) return status;
    return vmi_panel_edge(&o->stiffness, VM_BAD_STIFFNESS, 0, start, length, panel->ratio, &panel->edge);
}

/* The factor by which rounding errors of the rates a and p become errors of p', on a panel of 1 s. In float the factor
   is 0: there such errors cannot be told from fast changes, and count as fast changes. */
VM_API vm_real vmi_osc_rate_noise(void) { return VM_MANT_DIG > 24 ? 2048 * VM_EPSILON : 0; }

/* Computes the panel from start to start + length, where length < 0 goes backward. *mean is the mean motion at
   start. */
VM_API int vmi_osc_panel_of(const vm_osc_plan *p, const vmi_osc_mean *mean, vm_real start, vm_real length,
                            vmi_osc_panel *panel)
{
    const int damped = p->problem.damping != 0;
    const vm_real W0 = p->mean.W * vmi_exp(p->ripple.gamma * mean->ln_J, 0);
    const vm_real p_noise = vmi_osc_rate_noise() / VM_FABS(length);
    vmi_osc_panel_laws at;
    vm_real ratios[VMI_GAUSS], E[VMI_GAUSS];
    int i, status = vmi_osc_read_laws(&p->problem, vmi_time_side(length), start, length, &at, panel);
    if (status) return status;
    panel->noise = 0;
    panel->first = 0;
    panel->second = 0;
    panel->cube = 0;
    panel->largest = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real way = damped ? length / 2 * vmi_legendre_integral(panel->inverse, vmi_gauss_node(i)) : 0;
        const vmi_osc_rates *now = &at.rates[i];
        vm_real ln_A, ln_Om, W, share;
        vmi_osc_adiabatic(p, vmi_log(now->m / p->m0).hi, vmi_log(now->k / p->k0).hi,
                          p->problem.damping * (mean->inverse_mass + way), &ln_A, &ln_Om);
        ratios[i] = vmi_exp(ln_Om, 0);
        W = W0 * ratios[i];
        E[i] = now->p / W * ((now->p - now->a) / W) - at.p_rate[i] / W / W;
        panel->noise = vmi_larger(p_noise / W * ((VM_FABS(now->p) + VM_FABS(now->a)) / W), panel->noise);
        share = vmi_gauss_weight(i) / 2 * length * W;
        panel->first += share * E[i];
        panel->second += share * E[i] * E[i];
        panel->cube += VM_FABS(share * E[i]) * E[i] * E[i];
        panel->largest = vmi_larger(VM_FABS(E[i]), panel->largest);
    }
    vmi_legendre_fit(ratios, E, panel->ratio, panel->E);
    return VM_OK;
}

/* Whether the panel is short enough for its series. A panel on which a law has a kink never is; therefore a panel also
   counts as short enough if the terms that its series leaves out do not matter. `whole` is the
   length of the walk, s. */
VM_API int vmi_osc_panel_is_resolved(const vm_osc_plan *p, const vmi_osc_panel *panel, vm_real length, vm_real whole)
{
    const vm_real E_enough = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3), phase_matters = 16 * VM_EPSILON;
    const vm_real limit = vmi_panel_limit(length, whole);
    vm_real phase;
    if (!(panel->edge <= vmi_panel_edge_limit(limit))) return 0;
    if (!vmi_panel_is_resolved(panel->inverse, limit)) return 0;
    if (!vmi_panel_is_resolved(panel->ratio, limit)) return 0;
    phase = p->mean.W * panel->ratio[0] * VM_FABS(length);
    return vmi_legendre_tail(panel->E) <=
           E_enough * VM_SQRT(vmi_legendre_square(panel->E)) + phase_matters * (1 + 1 / phase) / phase;
}

/* Adds to mean->change the integrals of |d^i E_0/dpsi^i| over the panel, with the root mean square in place of the
   absolute value, and to mean->third the panel's part. Coefficients of E_0 that are as small as rounding errors are set
   to 0 first, and their integral is added to mean->dropped. The series of E_0 is overwritten. */
VM_API void vmi_osc_add_changes(const vm_osc_plan *p, vmi_osc_panel *panel, vm_real length, vmi_osc_mean *mean)
{
    const vm_real noise = 1024 * VM_EPSILON, W = p->mean.W * panel->ratio[0], phase_length = W * VM_FABS(length);
    const vm_real least = vmi_larger(noise * VM_SQRT(vmi_legendre_square(panel->E)), panel->noise);
    vm_real rate = 1, size[VMI_WALK_ORDERS]; /* rate is (dx/dpsi)^i, where x goes from -1 to 1 on the panel */
    vm_real dropped[VMI_GAUSS];
    int i;
    for (i = 0; i < VMI_GAUSS; i++) {
        dropped[i] = 0;
        if (VM_FABS(panel->E[i]) > least) continue;
        dropped[i] = panel->E[i];
        panel->E[i] = 0;
    }
    mean->dropped += phase_length * VM_SQRT(vmi_legendre_square(dropped));
    for (i = 0; i < VMI_WALK_ORDERS; i++) {
        size[i] = rate * VM_SQRT(vmi_legendre_square(panel->E));
        mean->change[i] += phase_length * size[i];
        vmi_legendre_derive(panel->E);
        rate *= 2 / phase_length;
    }
    mean->third += vmi_expansion_third_rate(&p->ripple, phase_length * size[0] * size[2], panel->cube);
}

/* Advances the mean motion over a panel. */
VM_API void vmi_osc_add_panel(const vm_osc_plan *p, vmi_osc_panel *panel, vm_real length, vmi_osc_mean *mean)
{
    const vm_real W0 = p->mean.W * vmi_exp(p->ripple.gamma * mean->ln_J, 0);
    const vm_real first = vmi_expansion_first(&p->ripple) * panel->first;
    const vm_real second = vmi_expansion_second(&p->ripple) * panel->second;
    mean->inverse_mass += length * panel->inverse[0];
    mean->phase += length * panel->ratio[0];
    mean->psi += W0 * (length * panel->ratio[0]) + (first + second);
    mean->first += first;
    mean->second += second;
    mean->largest = vmi_larger(panel->largest, mean->largest);
    vmi_osc_add_changes(p, panel, length, mean);
}

/* Advances the mean motion from start to end by panels of at most `longest`. No table may have a point between start
   and end. `whole` is the length of the whole walk, s. */
VM_API int vmi_osc_walk_piece(const vm_osc_plan *p, vm_real start, vm_real end, vm_real longest, vm_real whole,
                              vmi_osc_mean *mean)
{
    vmi_panels panels = vmi_panels_from(start, end, longest, whole);
    while (vmi_panels_next(&panels)) {
        const vm_real length = panels.side * panels.step;
        vmi_osc_panel panel;
        int status = vmi_osc_panel_of(p, mean, panels.t, length, &panel);
        if (status) return status;
        if (!vmi_osc_panel_is_resolved(p, &panel, panels.step, whole)) {
            if (vmi_panels_halve(&panels)) continue;
            mean->error += panels.step * vmi_legendre_tail(panel.ratio);
        }
        vmi_osc_add_panel(p, &panel, length, mean);
        if (panels.step < mean->shortest && panels.step < panels.left) mean->shortest = panels.step;
        vmi_panels_advance(&panels);
    }
    return VM_OK;
}

/* Sets the fields now, ln_A and ratio of *mean for the time t. Where the laws' derivatives jump at t, their values on
   the side from which the walk comes are taken; side is 1 forward, -1 backward in time. */
VM_API int vmi_osc_mean_update(const vm_osc_plan *p, vm_real t, int side, vmi_osc_mean *mean)
{
    const vm_real sampling = vmi_osc_sampling_time(p), length = t == 0 ? sampling : vmi_smaller(sampling, VM_FABS(t));
    vm_real ln_Om;
    int status = vmi_osc_slow_at(&p->problem, t, -side, length, p->slow.unit, &mean->now);
    if (status) return status;
    vmi_osc_adiabatic(p, vmi_log(mean->now.m / p->m0).hi, vmi_log(mean->now.k / p->k0).hi,
                      p->problem.damping * mean->inverse_mass, &mean->ln_A, &ln_Om);
    mean->ratio = vmi_exp(ln_Om, 0);
    return VM_OK;
}

/* -- Points of tables -- */

/* Adds to knots_J and knots_psi what orders 2 to 5 leave out at a point of a table, where the numbers E_k jump from
   `before` to `after` */
VM_API void vmi_osc_add_knot_error(const vm_osc_plan *p, const vm_real *before, const vm_real *after,
                                   vmi_osc_mean *mean)
{
    vmi_expansion_sizes size;
    vm_real e[VMI_OSC_G];
    int i, order;
    for (i = 0; i < VMI_OSC_G; i++) e[i] = VM_FABS(before[i] - after[i]);
    vmi_expansion_find_sizes(&p->ripple, e, &size);
    for (order = 2; order <= 5; order++) {
        mean->knots_J[order - 2] += size.J[order + 1] * size.J[order + 1];
        mean->knots_psi[order - 2] += size.psi[order] * size.psi[order];
    }
}

/* Takes the mean motion past t, a point of a table. The derivatives of m' and k' jump there, but the motion does not,
   so that the mean motion does. From the mean motion before t follows the motion at t, and from this the mean motion
   after t. vmi_expansion_J_back would give the action at t with one order less; iteration with vmi_expansion_J has the
   full order. */
VM_API int vmi_osc_walk_past_knot(const vm_osc_plan *p, vm_real t, int side, vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vmi_osc_wave wave = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    const int order = p->start_order, rounds = 3;
    vm_real before[VMI_OSC_G], after[VMI_OSC_G], sa, ca, ln_J = 0, to_mean;
    vmi_osc_reduced state;
    vmi_osc_slow beyond;
    vmi_ripple_values f;
    int i, status = vmi_osc_mean_update(p, t, side, mean);
    if (!status) status = vmi_osc_slow_at(&p->problem, t, side, vmi_osc_sampling_time(p), p->slow.unit, &beyond);
    if (status) return status;
    state = vmi_osc_mean_state(p, mean);
    vmi_osc_disturbance(&mean->now, state.W, before);
    vmi_osc_wave_at(&wave, state.psi, &ca, &sa);
    vmi_ripple_at(r, order, state.psi, sa, ca, &f);
    state.psi += vmi_expansion_psi_back(r, order, &f, before);
    vmi_osc_wave_at(&wave, state.psi, &ca, &sa);
    vmi_ripple_at(r, order, state.psi, sa, ca, &f);
    for (i = 0; i < rounds; i++) {
        vmi_osc_disturbance(&mean->now, state.W * vmi_exp(r->gamma * ln_J, 0), before);
        ln_J = -vmi_expansion_J(r, order, &f, before);
    }
    vmi_osc_disturbance(&beyond, state.W * vmi_exp(r->gamma * ln_J, 0), after);
    to_mean = vmi_expansion_J(r, order, &f, after);
    mean->ln_J += ln_J + to_mean;
    mean->psi = state.psi + vmi_expansion_psi(r, order, &f, after);
    mean->now = beyond;
    vmi_osc_add_knot_error(p, before, after, mean);
    return VM_OK;
}

/* -- The walk -- */

/* Sets the mean motion at the start of a walk backward in time. The plan has the mean motion that belongs to the
   laws just after t = 0; *mean becomes the mean motion that belongs to the laws just before t = 0. */
VM_API int vmi_osc_start_backward(const vm_osc_plan *p, vmi_osc_mean *mean)
{
    const vm_osc_problem *o = &p->problem;
    vm_real E[VMI_OSC_G];
    vmi_osc_reduced start;
    int status = vmi_osc_slow_at(o, 0, -1, vmi_osc_sampling_time(p), p->slow.unit, &mean->now);
    if (status) return status;
    start = vmi_osc_reduce(&mean->now, o->alpha, o->x, o->v);
    vmi_osc_disturbance(&mean->now, start.W, E);
    start = vmi_osc_mean_of(p, p->start_order, &start, E);
    mean->ln_J = (o->alpha + 3) / 2 * vmi_log(start.A / p->mean.A).hi;
    mean->psi = start.psi;
    mean->largest = VM_FABS(E[0]);
    return VM_OK;
}

/* Computes the mean motion at t by a walk along both laws of the plan, from one point of a table to the next. */
VM_API int vmi_osc_walk_to(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_law *mass = &p->problem.mass, *stiffness = &p->problem.stiffness;
    const int side = vmi_time_side(t);
    const vm_real whole = VM_FABS(t);
    const vm_real longest = vmi_smaller(vmi_law_longest_panel(mass, whole), vmi_law_longest_panel(stiffness, whole));
    vm_real at = 0;
    int status = VM_OK;
    *mean = vmi_osc_mean_at_0(p);
    mean->shortest = longest;
    if (side < 0 && (vmi_law_has_knot(mass, 0) || vmi_law_has_knot(stiffness, 0)))
        status = vmi_osc_start_backward(p, mean);
    while (!status && at != t) {
        const vm_real next = vmi_law_next_knot(stiffness, at, vmi_law_next_knot(mass, at, t));
        status = vmi_osc_walk_piece(p, at, next, longest, whole, mean);
        at = next;
        if (!status && at != t) status = vmi_osc_walk_past_knot(p, at, side, mean);
    }
    if (!status) status = vmi_osc_mean_update(p, t, side, mean);
    return status;
}

#endif
/* oscillators/mean_motion.h - the motion by first-order averaging and by the law of order five, with error estimates

   Without a force F the mean motion of an oscillator with slow mass and stiffness is known from integrals: the
   amplitude follows the adiabatic law (325), (344), (367), (389), and the phase is the integral of its rate (310),
   (329), (370). vmi_osc_first_order takes this mean motion for the motion, with the wave cos, cn or ca. vmi_osc_order_n
   goes from the mean motion to the motion by the transformation of oscillators/expansion.h, cut off after order 2, 3, 4
   or 5. Its error is of that order in the relative change of mass and stiffness within a radian.
       vmi_osc_mean mean;
       vm_osc_motion motion;
       vmi_osc_wave w = vmi_osc_wave_of(&plan, VM_ROUTE_ORDER5);
       int status = vmi_osc_mean_at(&plan, 10, &mean);
       if (!status) status = vmi_osc_order_n(&plan, VM_ROUTE_ORDER5, &w, &mean, &motion);
   Tests: tests/test_slow_motion.c, tests/test_averaging.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_MEAN_MOTION_H
#define VARMASS_OSCILLATORS_MEAN_MOTION_H

/* -- The mean motion at t -- */

/* Computes the mean motion where mass and stiffness have the closed forms of oscillators/closed.h. */
VM_API void vmi_osc_mean_closed(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    vmi_osc_closed_now now;
    vm_real power;
    int i;
    vmi_osc_closed_mean_at(&p->closed_mean, t, &now);
    *mean = vmi_osc_mean_at_0(p);
    mean->ln_A = now.ln_A;
    mean->ratio = now.ratio;
    mean->inverse_mass = now.u / p->m0;
    mean->phase = now.phase;
    mean->first = now.first;
    mean->second = now.second;
    mean->psi = now.state.psi;
    mean->third = vmi_osc_closed_third(&p->closed_mean, &now, &p->ripple);
    mean->now.m = p->m0 * vmi_exp(p->laws.rate_m * now.u, 0);
    mean->now.k = p->k0 * vmi_exp(p->laws.rate_k * now.u, 0);
    mean->now.a = p->slow.a / now.el;
    mean->now.p = p->slow.p / now.el;
    vmi_osc_closed_disturbance_at(&p->closed_mean, &now, VMI_OSC_G, mean->E);
    mean->largest = vmi_larger(mean->largest, VM_FABS(mean->E[0]));
    power = 1 / now.el;
    for (i = 0; i < VMI_OSC_G; i++) {
        power /= now.el;
        mean->now.G[i] = p->slow.G[i] * power;
    }
}

/* Computes the mean motion at a time t so close to 0 that the laws do not change between 0 and t. */
VM_API int vmi_osc_mean_near_0(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    int status = VM_OK;
    *mean = vmi_osc_mean_at_0(p);
    if (t < 0) status = vmi_osc_start_backward(p, mean);
    mean->inverse_mass = t / p->m0;
    mean->phase = t;
    mean->psi += p->mean.W * t;
    return status;
}

/* Computes the mean motion at t, by closed forms if there are any, else by a walk along the laws. */
VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    const vm_real too_short = 256 * VM_EPSILON; /* a phase in which differences of the laws are rounding errors */
    int status = VM_OK;
    if (!p->closed && p->Om * VM_FABS(t) < too_short) status = vmi_osc_mean_near_0(p, t, mean);
    else if (p->closed) vmi_osc_mean_closed(p, t, mean);
    else status = vmi_osc_walk_to(p, t, mean);
    if (status) return status;
    if (!p->closed) vmi_osc_disturbance(&mean->now, vmi_osc_mean_state(p, mean).W, mean->E);
    if (!VM_IS_FINITE(mean->phase) || !VM_IS_FINITE(mean->ln_A) || !VM_IS_FINITE(mean->ratio)) return VM_NOT_FINITE;
    return VM_OK;
}

/* -- Estimates of the larger of |error of x|/A and |error of v|/vmax -- */

/* The part of the error that comes from rounding of the phase and from the error of its integral */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return 4 * VM_EPSILON * (2 + VM_FABS(p->Om * mean->phase)) + p->Om * mean->error;
}

/* A bound of the change of ln J, where J is the action, that fast changes of mass and stiffness cause. The exact change
   of ln J is the integral of E_0 times a periodic function of the phase whose mean is 0. i integrations by parts turn
   it into the integral of the ith derivative of E_0 times the ith integral of the periodic function, and into terms at
   both ends, which the solutions contain. Each i gives a bound, and the function returns the smallest. It comes from a
   large i where the laws change slowly, and from i = 0 where they change within less than a period. */
VM_API vm_real vmi_osc_fast(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real turn = r->pi / (2 * VM_PI);
    const vm_real first = (r->alpha + 3) / 4; /* bound of (alpha+3)/2 |sa ca|; its integrals have others */
    vm_real size = first, least = VM_INFINITY;
    int i;
    for (i = 0; i < VMI_WALK_ORDERS; i++) {
        const vm_real bound = size * mean->change[i];
        if (!(bound >= least)) least = bound;
        if (i == 0) size = r->scale / 4;
        else size *= turn;
    }
    return least + first * mean->dropped;
}

/* The error that fast changes of the laws between 0 and t cause in every averaged solution. An error of ln J makes an
   error of the phase that is larger by the factor gamma Om t. */
VM_API vm_real vmi_osc_way_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return (1 + VM_FABS(p->ripple.gamma * p->Om * mean->phase)) * vmi_osc_fast(p, mean);
}

/* Estimates the error of vmi_osc_first_order, except for the error of its wave. The solution takes the amplitude and
   the phase at the start for their mean values, and leaves out the ripple within a period and the term E_0 of the mean
   phase. An error of ln J makes an error of the phase that is larger by the factor gamma Om t. The phase of x and x' is
   that of x and V plus (alpha+1)/2 p/Om ca^2; the mean of this difference is the same at the start and at t. */
VM_API vm_real vmi_osc_first_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real n = r->alpha + 1, e = VM_FABS((n + 2) * mean->now.p) / (p->Om * mean->ratio), M = r->mean2;
    const vm_real ripple = e * n / (2 * (n + 2)) * vmi_larger(M, 1 - M), turns = p->Om * VM_FABS(mean->phase);
    const vm_real ln_A = VM_FABS(vmi_log(p->mean.A / p->A).hi) + VM_FABS(mean->ln_J) * 2 / (n + 2);
    const vm_real shift = (p->mean.psi - p->psi) + n / 2 * p->slow.p / p->Om * M;
    const vm_real phase = VM_FABS(r->gamma) * (n + 2) / 2 * ln_A * turns + VM_FABS(shift) + ripple +
                          VM_FABS(mean->first);
    const vm_real error = phase + ln_A + e / (2 * (n + 2)) + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
    if (!(error >= 0)) return VM_INFINITY; /* the laws are so far from slow that the mean motion has no numbers */
    return error;
}

/* Estimates the error of vmi_osc_order_n for the order 2, 3, 4 or 5. It adds up how large the first terms are that
   are left out: by the transformation of this order at t; and by the mean motion, which is of the order of the
   start, at the start, at points of tables, and in the mean rate of the phase. */
VM_API vm_real vmi_osc_order_error(const vm_osc_plan *p, int order, const vmi_osc_mean *mean)
{
    const vmi_ripple *r = &p->ripple;
    const vm_real largest_known = VM_C(0.25); /* where the estimate is larger the error is unknown */
    vm_real e0[VMI_OSC_G], e[VMI_OSC_G], error;
    vmi_left_out start;
    int i;
    for (i = 0; i < VMI_OSC_G; i++) {
        e0[i] = VM_FABS(p->E[i]);
        e[i] = VM_FABS(mean->E[i]);
    }
    if (!(r->scale * mean->largest < VM_C(0.5))) return VM_INFINITY; /* the laws are not slow */
    start = vmi_expansion_left_out_at_start(r, p->start_order, e0);
    start.J += VM_SQRT(mean->knots_J[p->start_order - 2]);
    start.psi += VM_SQRT(mean->knots_psi[p->start_order - 2]);
    error = vmi_expansion_error(r, vmi_expansion_left_out_at(r, order, e), start, p->Om * VM_FABS(mean->phase), mean->third) +
            vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
    return error < largest_known ? error : VM_INFINITY;
}

/* -- The solutions -- */

/* Writes the motion of amplitude A. Om is the rate of the Ateb phase, so that the largest velocity is 2 A Om/(alpha+1);
   c and s are the values of the wave w. evals is set to 0. VM_NOT_FINITE leaves *motion untouched. */
VM_API int vmi_osc_motion_of(const vmi_osc_wave *w, vm_real A, vm_real Om, vm_real c, vm_real s, vm_real error,
                             int route, vm_osc_motion *motion)
{
    vm_osc_motion r;
    r.x = A * c;
    r.v = -w->speed * (2 * A * Om / (w->alpha + 1)) * s;
    r.amplitude = A;
    r.error = error;
    r.route = route;
    r.evals = 0;
    if (!VM_IS_FINITE(r.x) || !VM_IS_FINITE(r.v)) return VM_NOT_FINITE;
    *motion = r;
    return VM_OK;
}

/* Computes the motion to first order (310), (329), (370): the amplitude A follows the adiabatic law, and the phase is
   the integral of Om. w is the wave of the route. */
VM_API int vmi_osc_first_order(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                               vm_osc_motion *motion)
{
    const vm_real A = p->A * vmi_exp(mean->ln_A, 0), Om = p->Om * mean->ratio;
    const vm_real error = vmi_osc_first_error(p, mean) + vmi_osc_wave_error(w, p->ripple.mean2);
    vm_real c, s;
    vmi_osc_wave_at(w, p->psi + p->Om * mean->phase, &c, &s);
    return vmi_osc_motion_of(w, A, Om, c, s, error, route, motion);
}

/* Computes the motion at t from the mean motion, by the law of order five, cut off after the order of the route. route
   is one of VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5, w its wave. */
VM_API int vmi_osc_order_n(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                           vm_osc_motion *motion)
{
    const vmi_ripple *r = &p->ripple;
    const int order = vmi_osc_order_of(route);
    vmi_osc_reduced state = vmi_osc_mean_state(p, mean);
    vm_osc_motion result;
    vm_real sa, ca;
    vmi_osc_wave_at(w, state.psi, &ca, &sa);
    if (order > 2) {
        state = vmi_expansion_from_mean(r, order, &state, sa, ca, mean->E);
        vmi_osc_wave_at(w, state.psi, &ca, &sa);
    }
    vmi_osc_unreduce(&state, mean->now.p, r->alpha, sa, ca, &result.x, &result.v);
    result.amplitude = state.A;
    result.error = vmi_osc_order_error(p, order, mean);
    result.route = route;
    result.evals = 0;
    if (!VM_IS_FINITE(result.x) || !VM_IS_FINITE(result.v)) return VM_NOT_FINITE;
    if (!(result.error >= 0)) result.error = VM_INFINITY;
    *motion = result;
    return VM_OK;
}

#endif
/* oscillators/averaging.h - averaged equations of an oscillator with a force, and what averaging leaves out

   With a force F(t, x, x') the amplitude A and the phase obey averaged equations, whose right-hand sides are means
   over a period: vm_osc_averaged computes them for each of the three waves of oscillators/waves.h, (314), (315),
   (337)-(339), (380)-(382).
       vm_osc_plan plan;
       vm_real A_rate, theta_rate, psi_rate;
       int status = vm_osc_plan_init(&plan, &problem); // problem is a vm_osc_problem; t = 10 s, A = 0.1 m
       if (!status) status = vm_osc_averaged(&plan, VM_ROUTE_ATEB, 10, VM_C(0.1), &A_rate, &theta_rate, &psi_rate);
   vmi_osc_averaging_error estimates how far the solution of the averaged equations is from the motion.
   Symbols: psi Ateb phase, Om its rate, theta the slow part of a wave's own angle (oscillators/waves.h).
   Tests: tests/test_averaging.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_AVERAGING_H
#define VARMASS_OSCILLATORS_AVERAGING_H

/* -- Averaged equations with a force -- */

/* Writes the means of F s and F c over a period, with the force F and a motion x = A c, x' = -V s by the wave w. Each
   quarter of the period is divided at psi = cut. From 0 to cut, Gauss' rule takes 20 points in psi; for large alpha the
   velocity varies like tanh psi there. From cut to x = 0 the rule takes 20 points in the square root of the distance of
   psi from its value at x = 0, because F may contain fractional powers of that distance. */
VM_API void vmi_osc_means(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real A, vm_real V, vm_real *Fs,
                          vm_real *Fc)
{
    const vm_real half = p->ripple.pi / 2, cut = half < 6 ? half / 2 : 3;
    int i, quarter;
    *Fs = 0;
    *Fc = 0;
    for (i = 0; i < 2 * VMI_GAUSS; i++) {
        const int point = i % VMI_GAUSS, near_zero = i >= VMI_GAUSS;
        const vm_real u = (1 + vmi_gauss_node(point)) / 2, length = near_zero ? half - cut : cut;
        vm_real psi = cut * u, share = vmi_gauss_weight(point) / 8 * length / half, c, s;
        if (near_zero) {
            psi = half - length * u * u;
            share *= 2 * u;
        }
        vmi_osc_wave_at(w, psi, &c, &s);
        for (quarter = 0; quarter < 4; quarter++) {
            const vm_real qc = quarter & 1 ? -c : c, qs = quarter & 2 ? -s : s;
            const vm_real F = p->problem.force(t, A * qc, -V * qs, p->problem.ctx);
            *Fs += share * F * qs;
            *Fc += share * F * qc;
        }
    }
}

/* The averaged rates (ln A)' and theta' at the amplitude A, where Om is the rate of the Ateb phase. theta is the slow
   part of the wave's own angle. */
VM_API void vmi_osc_averaged_rates(const vm_osc_plan *p, const vmi_osc_wave *w, const vmi_osc_rates *now, vm_real t,
                                   vm_real A, vm_real Om, vm_real *ln_A_rate, vm_real *theta_rate)
{
    const vm_real V = w->speed * (2 * A * Om / (w->alpha + 1));
    vm_real Fs = 0, Fc = 0;
    if (p->problem.force) vmi_osc_means(p, w, t, A, V, &Fs, &Fc);
    *ln_A_rate = -now->p - w->gain_A * Fs / (now->m * V);
    *theta_rate = -w->gain_theta * Fc / (now->m * V);
}

/* Om/Om0, the rate of the Ateb phase over its value at t = 0, where A/A0 = e^a, for the mass and stiffness in `now` */
VM_API vm_real vmi_osc_Om_ratio(const vm_osc_plan *p, const vmi_osc_rates *now, vm_real a)
{
    return VM_SQRT((now->k / p->k0) / (now->m / p->m0)) * vmi_exp((p->problem.alpha - 1) / 2 * a, 0);
}

/* Averaged rates A', theta', psi' of amplitude and phase, with the problem's force.
   They are taken at time t (s) and amplitude A (m), in m/s and 1/s. psi is the angle of the route's wave, theta its
   slow part. For VM_ROUTE_ATEB psi is the Ateb phase: (314), (315) averaged, with the term of omega' that they lack.
   For VM_ROUTE_TRIG it is in radians: (337)-(339) with alpha + 3 for 5 - alpha and 4 for the 2 of (338), (339). For
   VM_ROUTE_JACOBI it is the argument of cn: (380)-(382) with theta' in the second equation of (382). Gauss' rule
   takes the means on each quarter of the period, so F may jump where x or x' is 0. For alpha up to 30, and F linear
   or cubic in x and x' or dry friction, the relative error is at most 1e-10 (float 2e-6). Returns VM_BAD_ARGUMENT for
   a null pointer or another route, VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS or
   VM_BAD_STIFFNESS for a law that is not positive at t, and VM_DOMAIN for A <= 0, t outside a table, or a user's
   function of a law that fails. An error leaves the results untouched. */
VM_API int vm_osc_averaged(const vm_osc_plan *p, int route, vm_real t, vm_real A, vm_real *A_rate,
                           vm_real *theta_rate, vm_real *psi_rate)
{
    vmi_osc_rates now;
    vmi_osc_wave w;
    vm_real Om, rate, theta;
    int status;
    if (!p || !A_rate || !theta_rate || !psi_rate) return VM_BAD_ARGUMENT;
    if (route < VM_ROUTE_TRIG || route > VM_ROUTE_ATEB) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(A)) return VM_NOT_FINITE;
    status = vmi_osc_rates_at(&p->problem, t, 1, &now);
    if (status) return status;
    if (!(A > 0)) return VM_DOMAIN;
    w = vmi_osc_wave_of(p, route);
    Om = vmi_osc_rate(A, VM_SQRT(now.k / now.m), w.alpha);
    vmi_osc_averaged_rates(p, &w, &now, t, A, Om, &rate, &theta);
    if (!VM_IS_FINITE(A * rate) || !VM_IS_FINITE(w.turn * Om + theta)) return VM_NOT_FINITE;
    *A_rate = A * rate;
    *theta_rate = theta;
    *psi_rate = w.turn * Om + theta;
    return VM_OK;
}

/* -- What averaging leaves out -- */

/* Number of phases in a period at which the exact rates of ln A and psi are compared with their means */
enum { VMI_AVERAGING_POINTS = 64 };

/* A moment of a motion from time 0 to t_end: the time t and the motion at t */
typedef struct VM_TAG(vmi_osc_moment) {
    const vm_osc_plan *plan;
    vmi_osc_rates now;  /* mass, stiffness and their rates just before t */
    vm_real t, t_end;   /* the time t of this moment, and the end t_end of the motion, s */
    vm_real A, psi, Om; /* amplitude, m, Ateb phase, and rate of this phase, 1/s */
} vmi_osc_moment;

/* What averaging leaves out at one moment, as errors of ln A and of the Ateb phase psi */
typedef struct VM_TAG(vmi_osc_averaging) {
    vm_real Om;                 /* rate of the Ateb phase at this moment, 1/s */
    vm_real start_A, start_psi; /* ripples of ln A and psi at the phase of this moment */
    vm_real ripple;             /* the largest ripple of ln A plus the largest ripple of psi */
    vm_real rate_A, rate_psi;   /* errors of the mean rates of ln A and psi, 1/s */
    vm_real growth;             /* rate, 1/s, at which a small change of ln A grows */
} vmi_osc_averaging;

/* Writes the exact rates of ln A and psi at VMI_AVERAGING_POINTS phases of the period before t, or of the first
   period if less than a period has passed. If `frozen` is 1 the force is that at the time t, otherwise the force
   varies with time. */
VM_API void vmi_osc_period_rates(const vmi_osc_moment *at, int frozen, vm_real *rate_A, vm_real *rate_psi)
{
    const vm_osc_plan *p = at->plan;
    const vm_real n = p->problem.alpha + 1, V = 2 * at->A * at->Om / n, q = (n + 2) * at->now.p;
    const vm_real side = (vm_real)vmi_time_side(at->t_end);
    const vmi_osc_wave w = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) {
        const vm_real way = 2 * p->ripple.pi * (vm_real)i / (vm_real)VMI_AVERAGING_POINTS;
        vm_real ca, sa, F, time = at->t + side * (way - 2 * p->ripple.pi) / at->Om;
        if ((time < 0) != (at->t_end < 0)) time = side * way / at->Om; /* there is no force before the start */
        if (VM_FABS(time) > VM_FABS(at->t_end)) time = at->t_end;
        if (frozen) time = at->t;
        vmi_osc_wave_at(&w, at->psi + way, &ca, &sa);
        F = p->problem.force(time, at->A * ca, -V * sa, p->problem.ctx) / (at->now.m * V);
        rate_A[i] = -q / n * sa * sa - 2 / n * F * sa;
        rate_psi[i] = -q / 2 * sa * ca - F * ca;
    }
}

/* Subtracts the mean from values over a period, and returns the mean */
VM_API vm_real vmi_osc_take_mean(vm_real *values)
{
    vm_real mean = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) mean += values[i] / (vm_real)VMI_AVERAGING_POINTS;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) values[i] -= mean;
    return mean;
}

/* Integrates values whose mean is 0 over a period, in steps of `width`, and subtracts the mean of the integral */
VM_API void vmi_osc_integrate_ripple(const vm_real *values, vm_real width, vm_real *ripple)
{
    int i;
    ripple[0] = 0;
    for (i = 1; i < VMI_AVERAGING_POINTS; i++)
        ripple[i] = ripple[i - 1] + width * (values[i - 1] + values[i]) / 2;
    vmi_osc_take_mean(ripple);
}

/* The largest absolute value over a period */
VM_API vm_real vmi_osc_largest(const vm_real *values)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) largest = vmi_larger(VM_FABS(values[i]), largest);
    return largest;
}

/* Adds the error of a wave that is not ca to the errors of the rates, and finds the rate at which a small change of
   ln A grows */
VM_API void vmi_osc_add_wave_rates(const vmi_osc_moment *at, const vmi_osc_wave *w, vmi_osc_averaging *a)
{
    const vm_osc_plan *p = at->plan;
    const vm_real change = VM_C(0.02); /* the change of ln A that is tried */
    const vm_real A = at->A * (1 + change), Om = at->Om * (1 + (w->alpha - 1) / 2 * change);
    const vmi_osc_wave exact = vmi_osc_wave_of(p, VM_ROUTE_ATEB);
    vm_real own_A, own_psi, exact_A, exact_psi, more_A, more_psi;
    vmi_osc_averaged_rates(p, w, &at->now, at->t, at->A, at->Om, &own_A, &own_psi);
    vmi_osc_averaged_rates(p, &exact, &at->now, at->t, at->A, at->Om, &exact_A, &exact_psi);
    vmi_osc_averaged_rates(p, w, &at->now, at->t, A, Om, &more_A, &more_psi);
    a->rate_A += VM_FABS(own_A - exact_A);
    a->rate_psi += VM_FABS(own_psi / w->turn - exact_psi);
    a->growth = (more_A - own_A) / change;
}

/* Integrates the rates of ln A and psi, without their means, to the ripples of ln A and psi within a period. The ripple
   of ln A changes Om, which adds to the rate of psi. */
VM_API void vmi_osc_find_ripples(const vmi_osc_moment *at, const vm_real *rate_A, vm_real *rate_psi,
                                 vmi_osc_averaging *a)
{
    const vm_real width = 2 * at->plan->ripple.pi / (vm_real)VMI_AVERAGING_POINTS;
    const vm_real bend = (at->plan->problem.alpha - 1) / 2;
    vm_real ripple_A[VMI_AVERAGING_POINTS], ripple_psi[VMI_AVERAGING_POINTS];
    int i;
    vmi_osc_integrate_ripple(rate_A, width / at->Om, ripple_A);
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) rate_psi[i] += bend * at->Om * ripple_A[i];
    vmi_osc_take_mean(rate_psi);
    vmi_osc_integrate_ripple(rate_psi, width / at->Om, ripple_psi);
    a->start_A = VM_FABS(ripple_A[0]);
    a->start_psi = VM_FABS(ripple_psi[0]);
    a->ripple = vmi_osc_largest(ripple_A) + vmi_osc_largest(ripple_psi);
}

/* Finds what averaging leaves out at the time t between 0 and t_end, where the motion has the amplitude A and the
   Ateb phase psi */
VM_API int vmi_osc_averaging_at(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real t_end, vm_real A,
                                vm_real psi, vmi_osc_averaging *a)
{
    const vm_real second_order = VM_C(0.25); /* error over rate times ripple; for Duffing's equation it is 0.156 */
    vm_real rate_A[VMI_AVERAGING_POINTS], rate_psi[VMI_AVERAGING_POINTS], frozen_A, frozen_psi, rates, second;
    vmi_osc_moment at;
    int status = vmi_osc_rates_at(&p->problem, t, -vmi_time_side(t_end), &at.now);
    if (status) return status;
    at.plan = p;
    at.t = t;
    at.t_end = t_end;
    at.A = A;
    at.psi = psi;
    at.Om = vmi_osc_rate(A, VM_SQRT(at.now.k / at.now.m), w->alpha);
    a->Om = at.Om;
    vmi_osc_period_rates(&at, 1, rate_A, rate_psi);
    frozen_A = vmi_osc_take_mean(rate_A);
    frozen_psi = vmi_osc_take_mean(rate_psi);
    vmi_osc_period_rates(&at, 0, rate_A, rate_psi);
    rates = vmi_osc_largest(rate_A) + vmi_osc_largest(rate_psi);
    a->rate_A = VM_FABS(vmi_osc_take_mean(rate_A) - frozen_A);
    a->rate_psi = VM_FABS(vmi_osc_take_mean(rate_psi) - frozen_psi);
    vmi_osc_add_wave_rates(&at, w, a);
    vmi_osc_find_ripples(&at, rate_A, rate_psi, a);
    second = second_order * rates * a->ripple;
    a->rate_A += second;
    a->rate_psi += second;
    return VM_OK;
}

/* -- The error between 0 and t -- */

/* The interval from 0 to t has 11 equal parts. Errors are estimated at the ends of the last 8 of them, both here and
   where oscillators/integration.h compares two integrations. */
enum { VMI_OSC_CHECKS = 8 };

/* Time number i, 0 to VMI_OSC_CHECKS - 1, at which motions are compared on the way to t; the last one is t. */
VM_API vm_real vmi_osc_check_time(vm_real t, int i)
{
    if (i == VMI_OSC_CHECKS - 1) return t;
    return t * (vm_real)(4 + i) / (vm_real)(3 + VMI_OSC_CHECKS);
}

/* Estimates the error at t of the averaged equations with a force, from the motions at the times of
   vmi_osc_check_time. Errors arise from the ripple at the start, which the equations take for a part of the mean, and
   from errors of the mean rates. These errors grow as small changes of the motion do, and an error of the
   amplitude adds an error of the phase. At the end the estimate adds the ripple at t, the error of a wave that is not
   ca, and the effect of fast changes of mass and stiffness. */
VM_API int vmi_osc_averaging_error(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t,
                                   const vm_osc_motion *motion, vm_real *error)
{
    const vm_real bend = VM_FABS(w->alpha - 1) / 2;
    vmi_osc_averaging before, after;
    vmi_osc_mean mean;
    vm_real time = 0, error_A, error_psi;
    int i, status = vmi_osc_averaging_at(p, w, 0, t, p->A, p->psi, &before);
    if (!status) status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    error_A = before.start_A;
    error_psi = before.start_psi;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        const vm_real next = vmi_osc_check_time(t, i), step = VM_FABS(next - time), first_A = error_A;
        vm_real growth, rate_psi;
        status = vmi_osc_averaging_at(p, w, next, t, motion[i].amplitude, 0, &after);
        if (status) return status;
        growth = (before.growth + after.growth) / 2 * (next - time);
        error_A = (error_A + vmi_larger(before.rate_A, after.rate_A) * step) * vmi_exp(growth, 0);
        rate_psi = vmi_larger(before.rate_psi, after.rate_psi) +
                   bend * vmi_larger(before.Om, after.Om) * vmi_larger(error_A, first_A);
        error_psi += rate_psi * step;
        before = after;
        time = next;
    }
    *error = error_A + error_psi + after.ripple + vmi_osc_wave_error(w, p->ripple.mean2) + vmi_osc_way_error(p, &mean);
    if (!(*error >= 0)) *error = VM_INFINITY; /* the amplitude is 0 or an overflow left NaN */
    return VM_OK;
}

#endif
/* oscillators/integration.h - integration of an oscillator to a tolerance, with an estimate of its error

   Two systems of two equations describe the oscillator: the averaged equations of amplitude and phase, and the equation
   of motion. A vmi_osc_method is one of these systems with a Runge-Kutta pair (rk45 or rk87) and the numbers that suit
   this pair; oscillators/routes.h has the methods that are used. vmi_osc_integrate runs a method twice, the second time
   with a stricter tolerance, and estimates the error from the difference of the two runs. It repeats both runs with
   stricter tolerances until the estimated error is within the tolerance of the motion.
       vmi_osc_method method = vmi_osc_method_rk87(vmi_osc_direct_rhs);
       vm_osc_motion motion;
       int status = vmi_osc_integrate(&plan, VM_ROUTE_RK87, &method, 10, VM_C(1e-9), &motion); // plan is a vm_osc_plan
   Tests: tests/test_routes.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_INTEGRATION_H
#define VARMASS_OSCILLATORS_INTEGRATION_H

/* -- Methods and runs -- */

/* Numbers that suit a Runge-Kutta pair */
typedef struct VM_TAG(vmi_osc_tuning) {
    vm_real least;     /* least useful tolerance of a step, because of rounding errors within the step */
    vm_real ratio;     /* tolerance of the loose run over that of the strict run */
    vm_real factor;    /* estimated error of the strict run over the difference of the two runs */
    vm_real by_chance; /* the estimated error is at least this times the tolerance of the steps */
} vmi_osc_tuning;

/* How a route, which is a method of solution, integrates */
typedef struct VM_TAG(vmi_osc_method) {
    ode_rhs rhs;  /* the right-hand side: vmi_osc_averaged_rhs or vmi_osc_direct_rhs */
    int averaged; /* 1 where rhs has averaged equations, whose error of averaging is added; else 0 */
    int direct;   /* 1 where the state of rhs is position and velocity, 0 where it is amplitude and phase */
    int (*init)(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                const rk45_options *options_or_NULL, vm_real *work); /* rk45_init or rk87_init */
    int (*solve)(rk45 *s, vm_real t_end);                            /* rk45_solve or rk87_solve */
    vmi_osc_tuning tuning;                                           /* numbers for this pair */
} vmi_osc_method;

/* A method of integration with the pair rk45. rk45 does not change the length of its steps while their error stays
   within a factor of 3. `ratio` is larger than this factor, so that the two runs take different steps. `factor` leaves
   room for errors that are not proportional to the tolerance. Errors are mostly far below the tolerance of the steps,
   so two runs may agree well by chance; by_chance allows for this. */
VM_API vmi_osc_method vmi_osc_method_rk45(ode_rhs rhs)
{
    vmi_osc_method method;
    method.rhs = rhs;
    method.averaged = 0;
    method.direct = 0;
    method.init = rk45_init;
    method.solve = rk45_solve;
    method.tuning.least = 16 * VM_EPSILON;
    method.tuning.ratio = 15;
    method.tuning.factor = VM_C(0.5);
    method.tuning.by_chance = VM_C(1e-3);
    return method;
}

/* A method of integration with the pair rk87, which does not change the length of its steps while their error stays
   within a factor of 7.5 */
VM_API vmi_osc_method vmi_osc_method_rk87(ode_rhs rhs)
{
    vmi_osc_method method = vmi_osc_method_rk45(rhs);
    method.init = rk87_init;
    method.solve = rk87_solve;
    method.tuning.least = 256 * VM_EPSILON;
    method.tuning.ratio = 60;
    method.tuning.factor = VM_C(0.25);
    method.tuning.by_chance = VM_C(1e-4);
    return method;
}

/* Slots of the state: position and velocity for the equation of motion, ln A and Ateb phase for the averaged
   equations */
enum { VMI_OSC_X = 0, VMI_OSC_V = 1, VMI_OSC_LN_A = 0, VMI_OSC_PSI = 1, VMI_OSC_STATES = 2 };

/* The longest step of the first loose run, in periods */
#define VMI_OSC_LONGEST VM_C(0.2)

/* A run of an integrator from 0 to t */
typedef struct VM_TAG(vmi_osc_run) {
    const vm_osc_plan *plan;
    const vmi_osc_method *method;
    int route;        /* the method's route, VM_ROUTE_... */
    vmi_osc_wave wave;
    int side;         /* 1 forward, -1 backward in time */
    int status;       /* status of a law of mass or stiffness that stopped the run, else VM_OK */
    vm_real longest;  /* longest step, in periods */
    vm_real share;    /* longest step, as a part of the interval up to the next stop */
    vm_real law_step; /* longest step, s, that skips no change of a user's law; a run shrinks it like `longest` */
    long evals;       /* evaluations of right-hand sides by all runs so far */
    rk45 s;
    vm_real work[RK87_WORK(VMI_OSC_STATES)];
} vmi_osc_run;

/* -- Right-hand sides -- */

/* Right-hand side of the averaged equations. The state y is ln(A/A0), with A0 the amplitude at t = 0, and the Ateb
   phase. */
VM_API int vmi_osc_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *run)
{
    vmi_osc_run *c = (vmi_osc_run *)run;
    const vm_osc_plan *p = c->plan;
    const vm_real A = p->A * vmi_exp(y[VMI_OSC_LN_A], 0);
    vmi_osc_rates now;
    vm_real Om, theta_rate;
    c->status = vmi_osc_rates_at(&p->problem, t, c->side, &now);
    if (c->status) return c->status;
    Om = p->Om * vmi_osc_Om_ratio(p, &now, y[VMI_OSC_LN_A]);
    vmi_osc_averaged_rates(p, &c->wave, &now, t, A, Om, &dydt[VMI_OSC_LN_A], &theta_rate);
    dydt[VMI_OSC_PSI] = Om + theta_rate / c->wave.turn;
    return 0;
}

/* (m/m0)^reactive: a body on which only the reactive force acts has a velocity proportional to the inverse of this. */
VM_API vm_real vmi_osc_reactive_weight(const vm_osc_problem *o, vm_real mass_ratio)
{
    if (o->reactive == 1) return mass_ratio;
    if (o->reactive == 0) return 1;
    return vmi_pow_checked(mass_ratio, o->reactive);
}

/* Right-hand side of the equation of motion. The state y is x/A0 and (m/m0)^reactive x'/vmax, with the amplitude A0
   and the largest velocity vmax at t = 0. The factor of x' compensates for the reactive force, so that y keeps its
   size. */
VM_API int vmi_osc_direct_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *run)
{
    vmi_osc_run *c = (vmi_osc_run *)run;
    const vm_osc_plan *p = c->plan;
    const vm_osc_problem *o = &p->problem;
    const vm_real speed = 2 * p->Om / (o->alpha + 1); /* vmax/A0 at t = 0 */
    vmi_osc_rates now;
    vm_real m, weight;
    c->status = vmi_osc_rates_at(&p->problem, t, c->side, &now);
    if (c->status) return c->status;
    m = now.m / p->m0;
    weight = vmi_osc_reactive_weight(o, m);
    dydt[VMI_OSC_X] = speed * y[VMI_OSC_V] / weight;
    dydt[VMI_OSC_V] = -p->Om * (now.k / p->k0) * weight / m * vmi_osc_elastic(y[VMI_OSC_X], o->alpha) -
                      o->damping / now.m * y[VMI_OSC_V];
    if (o->force)
        dydt[VMI_OSC_V] += o->force(t, p->A * y[VMI_OSC_X], p->A * dydt[VMI_OSC_X], o->ctx) * weight /
                           (now.m * p->A * speed);
    return 0;
}

/* -- One run -- */

/* The period at the run's time, s: from the amplitude in y, or for the equation of motion from the adiabatic law
   without damping. Returns NaN where a law of m or k fails. */
VM_API vm_real vmi_osc_period_now(const vmi_osc_run *c)
{
    const vm_osc_plan *p = c->plan;
    vmi_osc_rates now;
    vm_real ln_A, ln_Om;
    if (vmi_osc_rates_at(&p->problem, c->s.t, c->side, &now)) return VM_NAN;
    if (!c->method->direct) return 2 * p->ripple.pi / (p->Om * vmi_osc_Om_ratio(p, &now, c->s.y[VMI_OSC_LN_A]));
    vmi_osc_adiabatic(p, vmi_log(now.m / p->m0).hi, vmi_log(now.k / p->k0).hi, 0, &ln_A, &ln_Om);
    return 2 * p->ripple.pi / (p->Om * vmi_exp(ln_Om, 0));
}

/* The time at which the run stops next on its way to t: the next point of a table, but at most 64 periods later */
VM_API vm_real vmi_osc_next_stop(const vmi_osc_run *c, vm_real t, vm_real period)
{
    const vm_osc_problem *o = &c->plan->problem;
    const vm_real stretch = 64 * period;
    vm_real stop = vmi_law_next_knot(&o->mass, c->s.t, t);
    stop = vmi_law_next_knot(&o->stiffness, c->s.t, stop);
    if (VM_FABS(stop - c->s.t) > stretch) return c->s.t + (vm_real)c->side * stretch;
    return stop;
}

/* Sets the longest step and the largest number of steps up to the next stop, on the way to t. No step is longer than a
   part of the period. For a large Pi_alpha the velocity reverses within 10/Pi_alpha periods; then no step is longer
   than a part of this short time, because the Runge-Kutta pair does not notice the error of a step across it. */
VM_API void vmi_osc_bound_steps(vmi_osc_run *c, vm_real stop, vm_real t, vm_real period)
{
    const vm_real most_steps = 8192; /* steps per period, a bound that stops runs which would not end */
    const vm_real largest_long = VM_C(1e9), bounces_from = 10; /* Pi_alpha counts as large from 10 on */
    const vm_real way = VM_FABS(stop - c->s.t), most = c->share * way + 64 * VM_EPSILON * VM_FABS(t);
    const vm_real law_step = c->law_step * c->longest / VMI_OSC_LONGEST;
    vm_real longest = period * c->longest, steps;
    if (!(c->plan->ripple.pi < bounces_from)) longest = period * (c->longest * bounces_from / c->plan->ripple.pi);
    longest = vmi_smaller(most, vmi_smaller(law_step, longest));
    c->s.options.h_max = longest;
    steps = way * (most_steps / period + 4 / longest) + most_steps;
    c->s.options.max_steps = steps < largest_long ? (long)steps : 1000000000L;
}

/* Integrates to the time t. At every stop, subtracts whole turns from the phase and sets the bounds of the steps
   anew. */
VM_API int vmi_osc_solve(vmi_osc_run *c, vm_real t)
{
    const vm_real most_periods = VM_C(8388608.); /* 2^23: after more periods a float has no digits for the phase */
    const vm_real turn = 2 * c->plan->ripple.pi;
    int status = VM_OK;
    while (status >= 0 && c->s.t != t) {
        const vm_real period = vmi_osc_period_now(c);
        vm_real stop, y[VMI_OSC_STATES];
        if (!(period > VM_FABS(t) / most_periods)) return c->status ? c->status : VM_NOT_INTEGRATED;
        stop = vmi_osc_next_stop(c, t, period);
        vmi_osc_bound_steps(c, stop, t, period);
        status = c->method->solve(&c->s, stop);
        if (status < 0) break;
        y[0] = c->s.y[0];
        y[1] = c->s.y[1];
        if (!c->method->direct) y[VMI_OSC_PSI] -= turn * VM_FLOOR(y[VMI_OSC_PSI] / turn);
        status = rk45_restart(&c->s, c->s.t, y);
    }
    if (c->status) return c->status;
    if (status < 0) return VM_NOT_INTEGRATED;
    return VM_OK;
}

/* Writes the motion at the run's time, but not its error and evals. */
VM_API int vmi_osc_motion_now(const vmi_osc_run *c, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->plan;
    const vm_real *y = c->s.y;
    vm_real ca, sa, weight, unused;
    vmi_osc_rates now;
    int status = vmi_osc_rates_at(&p->problem, c->s.t, -c->side, &now);
    if (status) return status;
    if (!c->method->direct) {
        const vm_real A = p->A * vmi_exp(y[VMI_OSC_LN_A], 0), Om = p->Om * vmi_osc_Om_ratio(p, &now, y[VMI_OSC_LN_A]);
        vmi_osc_wave_at(&c->wave, y[VMI_OSC_PSI], &ca, &sa);
        return vmi_osc_motion_of(&c->wave, A, Om, ca, sa, 0, c->route, motion);
    }
    weight = vmi_pow_checked(now.m / p->m0, p->problem.reactive);
    motion->x = p->A * y[VMI_OSC_X];
    motion->v = 2 * p->A * p->Om / (p->problem.alpha + 1) * y[VMI_OSC_V] / weight;
    vm_osc_amplitude_phase(motion->x, motion->v, VM_SQRT(now.k / now.m), p->problem.alpha, &motion->amplitude,
                           &unused);
    motion->route = c->route;
    return VM_IS_FINITE(motion->amplitude) ? VM_OK : VM_NOT_FINITE;
}

/* Makes one run from 0 to t, and writes the motions at the VMI_OSC_CHECKS times of vmi_osc_check_time. */
VM_API int vmi_osc_run_once(vmi_osc_run *c, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_osc_plan *p = c->plan;
    rk45_options options = rk45_defaults(NULL);
    vm_real y[VMI_OSC_STATES], ca, sa;
    int i, status;
    c->side = vmi_time_side(t);
    c->status = VM_OK;
    options.atol = tolerance;
    if (c->method->direct) {
        options.rtol = tolerance;
        vmi_osc_wave_at(&c->wave, p->psi, &ca, &sa);
        y[VMI_OSC_X] = ca;
        y[VMI_OSC_V] = -sa;
    } else {
        options.rtol = -1; /* errors of ln A and psi are absolute */
        y[VMI_OSC_LN_A] = 0;
        y[VMI_OSC_PSI] = p->psi;
    }
    status = c->method->init(&c->s, c->method->rhs, c, VMI_OSC_STATES, 0, y, &options, c->work);
    if (status < 0) return VM_NOT_INTEGRATED;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        status = vmi_osc_solve(c, vmi_osc_check_time(t, i));
        if (!status) status = vmi_osc_motion_now(c, &motion[i]);
        if (status) return status;
    }
    c->evals += c->s.evals;
    return VM_OK;
}

/* -- Two runs -- */

/* The largest difference of two runs, of x relative to the amplitude and of v relative to vmax, over all times of
   vmi_osc_check_time, since at a single time two runs may agree by chance. Returns infinity where the difference is
   unknown. */
VM_API vm_real vmi_osc_difference(const vm_osc_plan *p, vm_real t, const vm_osc_motion *a, const vm_osc_motion *b)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        vmi_osc_rates now;
        vm_real vmax;
        if (a[i].amplitude == 0) return VM_INFINITY;
        if (vmi_osc_rates_at(&p->problem, vmi_osc_check_time(t, i), -vmi_time_side(t), &now)) return VM_INFINITY;
        vmax = vm_osc_vmax(a[i].amplitude, VM_SQRT(now.k / now.m), p->problem.alpha);
        largest = vmi_larger(VM_FABS(a[i].x - b[i].x) / a[i].amplitude, largest);
        largest = vmi_larger(VM_FABS(a[i].v - b[i].v) / vmax, largest);
    }
    return largest;
}

/* Computes the longest step, s, that skips no change of a law by a user's function: a quarter of the shortest panel
   in the walk along the laws. Because a jump of a law would make it 0, it is at least |t|/8192, or the law's
   change_time if that is shorter. */
VM_API int vmi_osc_law_step(const vm_osc_plan *p, vm_real t, vm_real *step)
{
    const vm_real panel_steps = 4, run_steps = 8192;
    const vm_law *laws[2];
    vmi_osc_mean mean;
    int i, status;
    laws[0] = &p->problem.mass;
    laws[1] = &p->problem.stiffness;
    *step = VM_FABS(t);
    if (!laws[0]->function && !laws[1]->function) return VM_OK;
    status = vmi_osc_walk_to(p, t, &mean);
    if (status) return status;
    *step = vmi_larger(mean.shortest / panel_steps, VM_FABS(t) / run_steps);
    for (i = 0; i < 2; i++) {
        const vm_real change_time = laws[i]->function ? laws[i]->change_time : 0;
        if (change_time > 0 && change_time < *step) *step = change_time;
    }
    return VM_OK;
}

/* Makes a loose run, and a strict run with half the longest step. If a law of mass or stiffness stopped one of the
   runs, c->status is the law's status. */
VM_API int vmi_osc_try_pair(vmi_osc_run *c, vm_real t, vm_real step_tolerance, vm_real longest, vm_osc_motion *loose,
                            vm_osc_motion *strict)
{
    int status;
    c->longest = longest;
    c->share = 1;
    status = vmi_osc_run_once(c, t, c->method->tuning.ratio * step_tolerance, loose);
    c->longest = longest / 2;
    c->share = VM_C(0.51);
    if (status) return status;
    return vmi_osc_run_once(c, t, step_tolerance, strict);
}

/* Estimate of the strict run's error, including the rounding errors of the phase */
VM_API vm_real vmi_osc_pair_error(const vmi_osc_run *c, vm_real t, vm_real step_tolerance, const vm_osc_motion *loose,
                                  const vm_osc_motion *strict)
{
    const vmi_osc_tuning *tuning = &c->method->tuning;
    const vm_real rounding = 4 * VM_EPSILON * (2 + c->plan->Om * VM_FABS(t));
    const vm_real error = tuning->factor * vmi_osc_difference(c->plan, t, strict, loose) + rounding;
    return vmi_larger(tuning->by_chance * step_tolerance, error);
}

/* The tolerance of the steps in the first pair of runs. It is less than the tolerance of the motion, since errors of
   steps add up, and at most 1e-3, since with larger steps the integrator may diverge from the motion. */
VM_API vm_real vmi_osc_first_tolerance(vm_real tolerance)
{
    const vm_real part = 8, largest = VM_C(1e-3);
    return vmi_smaller(tolerance / part, largest);
}

/* The next tolerance of the steps, after an error that was too large. It shrinks by the ratio of tolerance to error
   and by a further factor of 4, but to no less than 2e-5 of its last value. */
VM_API vm_real vmi_osc_next_tolerance(vm_real step_tolerance, vm_real tolerance, vm_real error)
{
    const vm_real ratio = tolerance / error, reserve = 4;
    if (ratio > VM_C(1e-4)) return step_tolerance * (ratio / reserve);
    return step_tolerance * VM_C(2e-5);
}

/* Makes pairs of runs until the error is within the tolerance. strict[] receives the last strict run, with the error
   in its last element. The loop ends early where stricter runs are not better. Then rounding errors, chance or the
   longest step dominate the error; therefore each pair that is not better halves the longest step. */
VM_API int vmi_osc_refine(vmi_osc_run *c, vm_real t, vm_real tolerance, vm_osc_motion *strict)
{
    const int most_attempts = 6, most_stalled = 3;
    const vmi_osc_tuning *tuning = &c->method->tuning;
    vm_osc_motion loose[VMI_OSC_CHECKS];
    vm_real step_tolerance = vmi_osc_first_tolerance(tolerance), longest = VMI_OSC_LONGEST, before = VM_INFINITY;
    int attempt, stalled = 0, status = VM_NOT_INTEGRATED;
    for (attempt = 0; attempt < most_attempts; attempt++) {
        vm_real error;
        if (step_tolerance < tuning->least) step_tolerance = tuning->least;
        status = vmi_osc_try_pair(c, t, step_tolerance, longest, loose, strict);
        if (status == VM_NOT_INTEGRATED && c->status == VM_OK && step_tolerance > tuning->least) {
            step_tolerance /= 2 * tuning->ratio; /* the loose run may have diverged */
            continue;
        }
        if (status) return status;
        error = vmi_osc_pair_error(c, t, step_tolerance, loose, strict);
        strict[VMI_OSC_CHECKS - 1].error = error;
        if (error > before / 2) {
            stalled++;
            longest /= 2;
        }
        if (error <= tolerance || step_tolerance == tuning->least || stalled == most_stalled) break;
        before = error;
        step_tolerance = vmi_osc_next_tolerance(step_tolerance, tolerance, error);
    }
    return status;
}

/* The motion at t by a method of integration. Returns VM_TOLERANCE_MISSED where the error of integration is larger
   than the tolerance. An error of averaging is added to motion->error, but does not change the status. */
VM_API int vmi_osc_integrate(const vm_osc_plan *plan, int route, const vmi_osc_method *method, vm_real t,
                             vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan with_ateb;
    vmi_osc_run c;
    vm_osc_motion strict[VMI_OSC_CHECKS], *last = strict + VMI_OSC_CHECKS - 1;
    vm_real averaging = 0;
    int status = vmi_osc_law_step(plan, t, &c.law_step);
    if (status) return status;
    c.plan = plan;
    c.method = method;
    c.route = route;
    c.evals = 0;
    if (!plan->has_ateb) {
        with_ateb = *plan;
        with_ateb.has_ateb = ateb_plan_init(&with_ateb.ateb, plan->problem.alpha) == 0;
        c.plan = &with_ateb;
    }
    c.wave = vmi_osc_wave_of(c.plan, route);
    status = vmi_osc_refine(&c, t, tolerance, strict);
    if (!status && method->averaged) status = vmi_osc_averaging_error(c.plan, &c.wave, t, strict, &averaging);
    if (status) return status;
    last->evals = c.evals;
    *motion = *last;
    motion->error += averaging;
    return last->error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

#endif
/* oscillators/gauss_rule.h - Gauss' rule of n points on [0, 1], and polynomials through values at these points

   The rule integrates polynomials of degree 2n - 1 exactly. Two matrices belong to it: they give, from the values of a
   polynomial of degree n - 1 at the n points, its integrals from 0 to each point and its derivatives there. The method
   of collocation (oscillators/collocation.h) solves differential equations with them.
       vmi_gauss_rule rule;
       vmi_gauss_rule_init(&rule, 8);
   Tests: tests/test_collocation.c. */
#ifndef VARMASS_OSCILLATORS_GAUSS_RULE_H
#define VARMASS_OSCILLATORS_GAUSS_RULE_H

/* The largest n */
enum { VMI_NODES = VMI_GAUSS };

/* Gauss' rule, and two matrices for polynomials of degree n - 1: polynomial j is 1 at node j, 0 at all other nodes */
typedef struct VM_TAG(vmi_gauss_rule) {
    int n; /* number of nodes */
    vm_real node[VMI_NODES], weight[VMI_NODES];
    vm_real integral[VMI_NODES][VMI_NODES];   /* [i][j]: integral of polynomial j from 0 to node i */
    vm_real derivative[VMI_NODES][VMI_NODES]; /* [i][j]: derivative of polynomial j at node i */
} vmi_gauss_rule;

/* Returns Legendre's polynomial P_n(x), and writes its derivative to *slope. */
VM_API vm_real vmi_legendre_polynomial(int n, vm_real x, vm_real *slope)
{
    vm_real before = 0, now = 1;
    int k;
    for (k = 0; k < n; k++) {
        const vm_real next = vmi_legendre_next(k, x, now, before);
        before = now;
        now = next;
    }
    *slope = (vm_real)n * (x * now - before) / (x * x - 1);
    return now;
}

/* Computes nodes and weights: zeros of Legendre's polynomial by Newton's method, from an approximation by cosines. */
VM_API void vmi_gauss_rule_nodes(vmi_gauss_rule *rule)
{
    const int rounds = 6;
    int i, j;
    for (i = 0; i < rule->n; i++) {
        vm_real x, sine, slope = 1;
        vmi_sincos(VM_PI * ((vm_real)i + VM_C(0.75)) / ((vm_real)rule->n + VM_C(0.5)), &sine, &x);
        for (j = 0; j < rounds; j++) {
            const vm_real value = vmi_legendre_polynomial(rule->n, x, &slope);
            x -= value / slope;
        }
        vmi_legendre_polynomial(rule->n, x, &slope);
        rule->node[i] = (1 - x) / 2;
        rule->weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* Adds the part of Legendre's polynomial P_k to both matrices. values, integrals and derivatives are those of P_k at
   the nodes, with integrals from 0 and derivatives by the variable of the nodes. */
VM_API void vmi_gauss_rule_add(vmi_gauss_rule *rule, int k, const vm_real *values, const vm_real *integrals,
                               const vm_real *derivatives)
{
    int i, j;
    for (j = 0; j < rule->n; j++) {
        const vm_real share = (vm_real)(2 * k + 1) * rule->weight[j] * values[j];
        for (i = 0; i < rule->n; i++) {
            rule->integral[i][j] += share * integrals[i];
            rule->derivative[i][j] += share * derivatives[i];
        }
    }
}

/* Computes the rule of n points, 2 <= n <= VMI_NODES. */
VM_API void vmi_gauss_rule_init(vmi_gauss_rule *rule, int n)
{
    vm_real before[VMI_NODES], now[VMI_NODES], slope_before[VMI_NODES], slope[VMI_NODES];
    vm_real integrals[VMI_NODES], derivatives[VMI_NODES];
    int i, j, k;
    rule->n = n;
    vmi_gauss_rule_nodes(rule);
    for (i = 0; i < n; i++) {
        before[i] = 0;
        now[i] = 1;
        slope_before[i] = 0;
        slope[i] = 0;
        for (j = 0; j < n; j++) {
            rule->integral[i][j] = 0;
            rule->derivative[i][j] = 0;
        }
    }
    for (k = 0; k < n; k++) { /* with x = 2 node - 1: node integrals are half of those over x, derivatives double */
        for (i = 0; i < n; i++) {
            const vm_real x = 2 * rule->node[i] - 1, next = vmi_legendre_next(k, x, now[i], before[i]);
            integrals[i] = k == 0 ? rule->node[i] : (next - before[i]) / (vm_real)(2 * (2 * k + 1));
            derivatives[i] = 2 * slope[i];
        }
        vmi_gauss_rule_add(rule, k, now, integrals, derivatives);
        for (i = 0; i < n; i++) { /* P'_(k+1) = P'_(k-1) + (2k+1) P_k */
            const vm_real x = 2 * rule->node[i] - 1, next = vmi_legendre_next(k, x, now[i], before[i]);
            const vm_real next_slope = slope_before[i] + (vm_real)(2 * k + 1) * now[i];
            slope_before[i] = slope[i];
            slope[i] = next_slope;
            before[i] = now[i];
            now[i] = next;
        }
    }
}

#endif
/* oscillators/collocation.h - integration of an oscillator from each zero of x to the next, to a tolerance

   The exact equations of oscillators/reduction.h for the amplitude A and the phase psi, with a further force F, are
     (ln A)' = -p + W E sa ca - 2/(alpha+1) f sa,   psi' = W (1 + (alpha+1)/2 E ca^2) - f ca,
     with E = (p^2 - a p - p')/W^2,   f = F/(m V),   V = 2 A W/(alpha+1); p, a and W are explained there.
   They are solved with psi as the independent variable: each step integrates ln A and t from one zero of x to the next.
   At x = 0 the force of the spring is not smooth for most alpha, but since steps end there, no order is lost.

   A step uses Gauss' collocation of n points. Its equations are solved by iteration, which starts from values that are
   extrapolated from the steps before. p' is the derivative of the polynomial through the values of p at the n points,
   so that laws have to give only f and f'. Two runs with different n go side by side; their difference gives the error.
       vm_osc_motion motion;
       int status = vmi_osc_collocate(&plan, VM_ROUTE_COLLOCATION, 300, VM_C(1e-8), &motion); // plan is a vm_osc_plan
   Source: Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1.2 and VIII.6.
   Tests: tests/test_collocation.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_COLLOCATION_H
#define VARMASS_OSCILLATORS_COLLOCATION_H

/* From how many earlier steps a step is extrapolated */
enum { VMI_HISTORY = 6 };

/* -- A run -- */

/* sa and ca at the nodes of a step */
typedef struct VM_TAG(vmi_step_waves) {
    vm_real sa[VMI_NODES], ca[VMI_NODES];
} vmi_step_waves;

/* Rates: derivatives of ln A and t by the phase psi, at the nodes of a step */
typedef struct VM_TAG(vmi_step_rates) {
    vm_real ln_A[VMI_NODES], t[VMI_NODES];
} vmi_step_rates;

/* A run from 0 to t. A half period, from one zero of ca to the next, is one part, or it is two parts that meet where
   sa = 0. Each step covers one part, unless it starts or ends inside a part. */
typedef struct VM_TAG(vmi_osc_course) {
    const vm_osc_plan *plan;
    vmi_osc_wave wave;
    vmi_gauss_rule rule;
    int side;              /* 1 forward, -1 backward in time */
    int parts;             /* number of parts of a half period, 1 or 2 */
    vm_real stop;          /* time, s, at which a step must end: a point of a table or the end. Laws are not
                              evaluated beyond it */
    vm_real longest;       /* the longest step, s */
    vm_real sweep_limit;   /* the iteration of a step ends when a round changes the phase by less than this */
    vm_real psi, ln_A, t;  /* phase, ln(A/A0) with the amplitude A0 of the plan, time, s */
    vm_real t_low;         /* the exact time is t + t_low, s */
    vm_real left;          /* sum over the steps of the change of phase that their iterations leave out */
    vm_real contraction;   /* factor by which a round of the iteration reduces its error */
    vm_real rate;          /* rate of the phase at the end of the last step, 1/s */
    vmi_step_waves waves[2];                        /* sa and ca on each part of the half period from psi = -Pi/2 */
    vmi_step_rates history[2][VMI_HISTORY];         /* rates of earlier whole steps over each part */
    int latest[2];                                  /* index in history of the latest step; earlier ones come after it */
    int known[2];                                   /* number of earlier steps over each part that history holds */
    int status;
    long evals;            /* evaluations of the rates */
} vmi_osc_course;

/* Writes sa and ca at the nodes of a step that starts at the phase `from`. */
VM_API void vmi_osc_course_waves(const vmi_osc_course *c, vm_real from, vm_real length, vmi_step_waves *w)
{
    int i;
    for (i = 0; i < c->rule.n; i++)
        vmi_osc_wave_at(&c->wave, from + length * c->rule.node[i], &w->ca[i], &w->sa[i]);
}

/* A step that is being computed; it starts at the present state of the course */
typedef struct VM_TAG(vmi_osc_step) {
    vm_real length;              /* length in phase */
    vm_real sign;                /* factor of waves: -1 in every second half period, else 1 */
    const vmi_step_waves *waves; /* sa and ca at the nodes, without the factor sign */
    vmi_step_rates rates;        /* rates at the nodes by the last round of the iteration */
} vmi_osc_step;

/* Changes of ln A and of t, s, over a step or a part of it */
typedef struct VM_TAG(vmi_osc_change) {
    vm_real ln_A, t;
} vmi_osc_change;

/* The changes of ln A and t over the whole step */
VM_API vmi_osc_change vmi_osc_whole_change(const vmi_osc_course *c, const vmi_osc_step *s)
{
    vmi_osc_change sum;
    int j;
    sum.ln_A = 0;
    sum.t = 0;
    for (j = 0; j < c->rule.n; j++) {
        sum.ln_A += c->rule.weight[j] * s->rates.ln_A[j];
        sum.t += c->rule.weight[j] * s->rates.t[j];
    }
    sum.ln_A *= s->length;
    sum.t *= s->length;
    return sum;
}

/* Writes the rates of ln A and t by the phase at node i, where ln(A/A0) is ln_A and the time is t. *now holds mass,
   stiffness and their rates at t, and p_rate is the derivative of now->p by time. */
VM_API int vmi_osc_course_rates(const vmi_osc_course *c, const vmi_osc_step *s, int i, const vmi_osc_rates *now,
                                vm_real p_rate, vm_real ln_A, vm_real t, vm_real *ln_A_by_psi, vm_real *t_by_psi)
{
    const vm_osc_plan *plan = c->plan;
    const vm_osc_problem *o = &plan->problem;
    const vm_real least_rate = VM_C(0.03); /* below this ratio of the phase's rate to W there is no vibration */
    const vm_real n = o->alpha + 1, sa = s->sign * s->waves->sa[i], ca = s->sign * s->waves->ca[i];
    const vm_real W = plan->Om * vmi_osc_Om_ratio(plan, now, ln_A);
    const vm_real E = (now->p * (now->p - now->a) - p_rate) / (W * W);
    vm_real rate = 1 + n / 2 * E * ca * ca, ln_A_rate = -now->p + W * E * sa * ca;
    if (o->force) {
        const vm_real A = plan->A * vmi_exp(ln_A, 0), V = 2 * A * W / n, x = A * ca;
        const vm_real f = o->force(t, x, -V * sa - now->p * x, o->ctx) / (now->m * V);
        rate -= f * ca / W;
        ln_A_rate -= 2 / n * f * sa;
    }
    *t_by_psi = 1 / (W * rate);
    *ln_A_by_psi = ln_A_rate * *t_by_psi;
    if (!(rate > least_rate) || !VM_IS_FINITE(*t_by_psi) || !VM_IS_FINITE(*ln_A_by_psi)) return VM_NOT_INTEGRATED;
    return VM_OK;
}

/* The changes of ln A and t from the start of the step to node i, by integration of these rates */
VM_API vmi_osc_change vmi_osc_change_to(const vmi_osc_course *c, const vmi_osc_step *s, const vmi_step_rates *rates,
                                        int i)
{
    const vm_real *weight = c->rule.integral[i];
    vmi_osc_change sum;
    int j;
    sum.ln_A = 0;
    sum.t = 0;
    for (j = 0; j < c->rule.n; j++) {
        sum.ln_A += weight[j] * rates->ln_A[j];
        sum.t += weight[j] * rates->t[j];
    }
    sum.ln_A *= s->length;
    sum.t *= s->length;
    return sum;
}

/* Adds to the rates of a step what a round found to be missing, and an estimate of what this changes in turn: `missing`
   shifts ln A and t at the nodes, and these shift the rates, mostly because W depends on both. *now holds mass,
   stiffness and rates at about the middle of the step. */
VM_API void vmi_osc_correct(const vmi_osc_course *c, const vmi_osc_step *s, const vmi_osc_rates *now,
                            const vmi_step_rates *missing, vmi_step_rates *rates)
{
    const vm_real alpha = c->plan->problem.alpha;
    /* derivatives of ln(dt/dpsi) by t and by ln A */
    const vm_real by_t = -((alpha + 3) * now->p - 2 * now->a) / 2, by_ln_A = -(alpha - 1) / 2;
    int i;
    for (i = 0; i < c->rule.n; i++) {
        const vmi_osc_change moved = vmi_osc_change_to(c, s, missing, i);
        const vm_real change = rates->t[i] * (by_t * moved.t + by_ln_A * moved.ln_A);
        rates->t[i] += missing->t[i] + change;
        rates->ln_A[i] += missing->ln_A[i] - now->p * change;
    }
}

/* Makes one round of the iteration. *change becomes the largest change of the rates, times the length of the step. */
VM_API int vmi_osc_sweep(vmi_osc_course *c, vmi_osc_step *s, vm_real *change)
{
    const vm_real too_short = 256 * VM_EPSILON; /* a phase in which differences of p are rounding errors */
    const int n = c->rule.n;
    vmi_osc_rates now[VMI_NODES];
    vmi_step_rates missing;
    vm_real ln_A[VMI_NODES], t[VMI_NODES];
    int i, j, status;
    for (i = 0; i < n; i++) {
        const vmi_osc_change moved = vmi_osc_change_to(c, s, &s->rates, i);
        ln_A[i] = c->ln_A + moved.ln_A;
        t[i] = c->t + (c->t_low + moved.t);
        if ((vm_real)c->side * (t[i] - c->stop) > 0) t[i] = c->stop;
        status = vmi_osc_rates_at(&c->plan->problem, t[i], t[i] == c->stop ? -c->side : c->side, &now[i]);
        if (status) return status;
    }
    *change = 0;
    for (i = 0; i < n; i++) {
        const vm_real old_ln_A = s->rates.ln_A[i], old_t = s->rates.t[i];
        vm_real p_rate = 0, new_ln_A, new_t;
        for (j = 0; j < n; j++) p_rate += c->rule.derivative[i][j] * now[j].p;
        p_rate /= s->length * old_t;
        if (VM_FABS(s->length) < too_short) p_rate = 0;
        status = vmi_osc_course_rates(c, s, i, &now[i], p_rate, ln_A[i], t[i], &new_ln_A, &new_t);
        if (status) return status;
        missing.ln_A[i] = new_ln_A - old_ln_A;
        missing.t[i] = new_t - old_t;
        *change = vmi_larger((VM_FABS(new_t / old_t - 1) + VM_FABS(new_ln_A - old_ln_A)) * VM_FABS(s->length), *change);
    }
    vmi_osc_correct(c, s, &now[n / 2], &missing, &s->rates);
    c->evals += n;
    return VM_OK;
}

/* Makes rounds of the iteration, from the rates in s->rates, until the change of phase that they leave out is below the
   limit of the course. A round leaves out the part `contraction` of the change that it makes. */
VM_API int vmi_osc_iterate(vmi_osc_course *c, vmi_osc_step *s)
{
    const vm_real least_contraction = VM_C(0.02); /* in case the next steps are harder than this one */
    const vm_real rounding = VM_SQRT(VM_EPSILON) / 16; /* in short steps p' has such errors, which no round mends */
    const int most_rounds = 40;
    vm_real change, before = 0;
    int sweeps, status;
    for (sweeps = 0; sweeps < most_rounds; sweeps++) {
        status = vmi_osc_sweep(c, s, &change);
        if (status) return status;
        if (before > 0) c->contraction = vmi_smaller(vmi_larger(change / before, least_contraction), 1);
        if (change * c->contraction <= c->sweep_limit) break;
        if (sweeps > 2 && !(change < before)) break;
        before = change;
    }
    if (change * c->contraction > c->sweep_limit && !(change <= rounding)) return VM_NOT_INTEGRATED;
    c->left += change * c->contraction;
    return VM_OK;
}

/* Sets the rates from which the iteration of a step starts. They are extrapolated from earlier whole steps of the same
   part of a half period; if there are none, all are the rates at the start of the step. These leave out the
   disturbance E = (p^2 - a p - p')/W^2 and the further force F. */
VM_API int vmi_osc_predict(vmi_osc_course *c, int part, vmi_osc_step *s)
{
    vmi_osc_rates now;
    vm_real rate, factor = -1;
    int i, k, status;
    if (c->known[part] == 0) {
        status = vmi_osc_rates_at(&c->plan->problem, c->t, c->side, &now);
        if (status) return status;
        rate = 1 / (c->plan->Om * vmi_osc_Om_ratio(c->plan, &now, c->ln_A));
        for (i = 0; i < c->rule.n; i++) {
            s->rates.ln_A[i] = -now.p * rate;
            s->rates.t[i] = rate;
        }
        return VM_OK;
    }
    for (i = 0; i < c->rule.n; i++) {
        s->rates.ln_A[i] = 0;
        s->rates.t[i] = 0;
    }
    for (k = 0; k < c->known[part]; k++) { /* extrapolation of n values: factors n, -n (n-1)/2, ... */
        const vmi_step_rates *last = &c->history[part][(c->latest[part] + k) % VMI_HISTORY];
        factor *= (vm_real)(c->known[part] - k) / (vm_real)(k + 1);
        for (i = 0; i < c->rule.n; i++) {
            s->rates.ln_A[i] -= factor * last->ln_A[i];
            s->rates.t[i] -= factor * last->t[i];
        }
        factor = -factor;
    }
    return VM_OK;
}

/* Advances the state of the course by the step. */
VM_API void vmi_osc_take(vmi_osc_course *c, const vmi_osc_step *s)
{
    const vmi_osc_change moved = vmi_osc_whole_change(c, s);
    const vm_real change = c->t_low + moved.t, t = c->t + change;
    c->t_low = change - (t - c->t);
    c->t = t;
    c->ln_A += moved.ln_A;
    c->psi += s->length;
    c->rate = 1 / s->rates.t[c->rule.n - 1];
}

/* Stores the rates of ln A and t over a whole step. vmi_osc_predict extrapolates from them the rates of the next step
   over the same part (first or second) of a half period. */
VM_API void vmi_osc_remember(vmi_osc_course *c, int part, const vmi_step_rates *rates)
{
    c->latest[part] = (c->latest[part] + VMI_HISTORY - 1) % VMI_HISTORY;
    c->history[part][c->latest[part]] = *rates;
    if (c->known[part] < VMI_HISTORY) c->known[part]++;
}

/* -- Landing on a time -- */

/* Returns at which fraction of the step the time t is reached, by Newton's method for the polynomial of the step.
   Writes the Legendre series of dt/dpsi to series. */
VM_API vm_real vmi_osc_find_part(const vmi_osc_course *c, const vmi_osc_step *s, vm_real t, vm_real *series)
{
    const int rounds = 8;
    const vm_real way = (t - c->t) - c->t_low;
    vm_real part, slope;
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) series[k] = 0;
    for (i = 0; i < c->rule.n; i++) {
        vm_real before = 0, now = 1;
        for (k = 0; k < c->rule.n; k++) {
            const vm_real next = vmi_legendre_next(k, 2 * c->rule.node[i] - 1, now, before);
            series[k] += (vm_real)(2 * k + 1) * c->rule.weight[i] * now * s->rates.t[i];
            before = now;
            now = next;
        }
    }
    part = way / (s->length * series[0]);
    for (i = 0; i < rounds; i++) {
        slope = s->length * vmi_legendre_at(series, 2 * part - 1);
        part -= (s->length / 2 * vmi_legendre_integral(series, 2 * part - 1) - way) / slope;
        part = vmi_smaller(vmi_larger(part, 0), 1);
    }
    return part;
}

/* Makes a step that ends at c->stop, in place of `beyond`, the longer step that would go past this time. certain: 0
   where `beyond` is only predicted. If it turns out that it does not reach c->stop, the course stays where it is,
   since no step may cross a zero of x. */
VM_API int vmi_osc_land(vmi_osc_course *c, const vmi_osc_step *beyond, int certain)
{
    const int rounds = 6;
    const vm_real way = (c->stop - c->t) - c->t_low;
    vm_real series[VMI_GAUSS], part = vmi_osc_find_part(c, beyond, c->stop, series);
    vmi_step_waves waves;
    vmi_osc_step s;
    int i, attempt, status;
    s.sign = 1;
    s.waves = &waves;
    s.length = part * beyond->length;
    for (i = 0; i < c->rule.n; i++) {
        s.rates.t[i] = vmi_legendre_at(series, 2 * part * c->rule.node[i] - 1);
        s.rates.ln_A[i] = beyond->rates.ln_A[i];
    }
    for (attempt = 0; attempt < rounds; attempt++) {
        vm_real missing;
        vmi_osc_course_waves(c, c->psi, s.length, &waves);
        status = vmi_osc_iterate(c, &s);
        if (status == VM_NOT_INTEGRATED && !certain) return VM_OK;
        if (status) return status;
        missing = (way - vmi_osc_whole_change(c, &s).t) / s.rates.t[c->rule.n - 1];
        if (VM_FABS(missing) <= c->sweep_limit) break;
        s.length += missing;
    }
    if (!certain && VM_FABS(s.length) > VM_FABS(beyond->length)) return VM_OK;
    c->left += c->sweep_limit;
    vmi_osc_take(c, &s);
    c->t = c->stop;
    c->t_low = 0;
    c->known[0] = 0;
    c->known[1] = 0;
    return VM_OK;
}

/* -- Steps -- */

/* Returns the phase at which the next step ends: a zero of ca, or with two parts a zero of ca or sa. *part becomes the
   number of the part that the step covers, or -1 where the step starts inside a part; *sign becomes the factor of its
   waves. */
VM_API vm_real vmi_osc_next_phase(const vmi_osc_course *c, int *part, vm_real *sign)
{
    const vm_real half = c->plan->ripple.pi, close = 64 * VM_EPSILON * (1 + VM_FABS(c->psi) / half);
    const vm_real per_step = (vm_real)c->parts / half, side = (vm_real)c->side;
    const vm_real at = (c->psi + half / 2) * per_step; /* the phase, counted in steps; `next` is the end of the step */
    const vm_real nearest = VM_FLOOR(at + VM_C(0.5)), next = VM_FLOOR(side * at + close) + 1;
    const vm_real cell = side > 0 ? side * next - 1 : side * next; /* the step lies between cell and cell + 1 */
    const vm_real turn = VM_FLOOR(cell / (vm_real)c->parts);
    *part = VM_FABS(at - nearest) <= close ? (int)(cell - turn * (vm_real)c->parts) : -1;
    *sign = turn - 2 * VM_FLOOR(turn / 2) == 0 ? 1 : -1;
    return side * next / per_step - half / 2;
}

/* Whether the step, by its present rates, ends at or beyond c->stop */
VM_API int vmi_osc_is_beyond(const vmi_osc_course *c, const vmi_osc_step *s)
{
    return (vm_real)c->side * ((c->t - c->stop) + (c->t_low + vmi_osc_whole_change(c, s).t)) >= 0;
}

/* Makes a step of the part `most`, 0 to 1, of its usual length. If it would go beyond c->stop, it is shortened to end
   there. */
VM_API int vmi_osc_course_step_of(vmi_osc_course *c, vm_real most)
{
    vmi_step_waves inside;
    vmi_osc_step s;
    vm_real share;
    int part, status;
    s.length = vmi_osc_next_phase(c, &part, &s.sign) - c->psi;
    status = vmi_osc_predict(c, part < 0 ? 0 : part, &s);
    if (status) return status;
    share = vmi_smaller(c->longest / VM_FABS(vmi_osc_whole_change(c, &s).t), most);
    if (share < 1) {
        s.length *= share;
        part = -1;
    }
    s.waves = &c->waves[part < 0 ? 0 : part];
    if (part < 0) {
        s.sign = 1;
        s.waves = &inside;
        vmi_osc_course_waves(c, c->psi, s.length, &inside);
    }
    if (vmi_osc_is_beyond(c, &s)) {
        status = vmi_osc_land(c, &s, 0);
        if (status || c->t == c->stop) return status;
    }
    status = vmi_osc_iterate(c, &s);
    if (status) return status;
    if (vmi_osc_is_beyond(c, &s)) return vmi_osc_land(c, &s, 1);
    vmi_osc_take(c, &s);
    if (part >= 0) vmi_osc_remember(c, part, &s.rates);
    return VM_OK;
}

/* Makes one step. Where its iteration does not converge, it tries shorter and shorter steps. */
VM_API int vmi_osc_course_step(vmi_osc_course *c)
{
    const vm_real shortest = VM_C(0.01); /* part of the usual length */
    vm_real most = 1;
    int status = vmi_osc_course_step_of(c, most);
    while (status == VM_NOT_INTEGRATED && most > shortest) {
        most /= 2;
        c->contraction = VM_C(0.1);
        status = vmi_osc_course_step_of(c, most);
    }
    return status;
}

/* Starts a course at t = 0 from the amplitude and phase in *start, with n points a step and `parts` parts a half
   period. */
VM_API void vmi_osc_course_start(vmi_osc_course *c, const vm_osc_plan *plan, const vmi_osc_reduced *start, int side,
                                 int n, int parts, vm_real sweep_limit)
{
    const vm_real half = plan->ripple.pi;
    vm_real from, length = (vm_real)side * half / (vm_real)parts;
    int part;
    c->plan = plan;
    c->wave = vmi_osc_wave_of(plan, VM_ROUTE_COLLOCATION);
    vmi_gauss_rule_init(&c->rule, n);
    c->side = side;
    c->parts = parts;
    c->sweep_limit = sweep_limit;
    c->stop = 0;
    c->longest = VM_INFINITY;
    c->psi = start->psi;
    c->ln_A = vmi_log(start->A / plan->A).hi;
    c->t = 0;
    c->t_low = 0;
    c->left = 0;
    c->contraction = VM_C(0.1);
    c->rate = 0;
    for (part = 0; part < parts; part++) {
        from = half * ((vm_real)part / (vm_real)parts - VM_C(0.5));
        if (side < 0) from += half / (vm_real)parts;
        vmi_osc_course_waves(c, from, length, &c->waves[part]);
    }
    for (part = 0; part < 2; part++) {
        c->latest[part] = 0;
        c->known[part] = 0;
    }
    c->evals = 0;
}

/* -- Two runs side by side -- */

/* The next point of a table after `from` on the way to t, or t if there is none */
VM_API vm_real vmi_osc_next_knot(const vm_osc_problem *o, vm_real from, vm_real t)
{
    return vmi_law_next_knot(&o->stiffness, from, vmi_law_next_knot(&o->mass, from, t));
}

/* Advances both courses to t, a point of a table or the end. Raises *difference to the largest difference of ln A and
   phase between the two courses on the way. */
VM_API int vmi_osc_courses_to(vmi_osc_course *loose, vmi_osc_course *strict, vm_real t, vm_real *difference)
{
    const vm_real most_steps = VM_C(16777216.); /* 2^24: with more, float has no digits for the phase */
    vm_real steps = 0;
    int status = VM_OK;
    loose->stop = t;
    strict->stop = t;
    while (!status && (loose->t != t || strict->t != t)) {
        vm_real apart;
        if (loose->t != t) status = vmi_osc_course_step(loose);
        if (!status && strict->t != t) status = vmi_osc_course_step(strict);
        if (status) break;
        apart = VM_FABS(loose->psi - strict->psi) + VM_FABS(loose->ln_A - strict->ln_A);
        if (loose->t != t && strict->t != t && loose->psi == strict->psi)
            apart += VM_FABS((loose->t - strict->t) * strict->rate);
        if (loose->psi == strict->psi || (loose->t == t && strict->t == t))
            *difference = vmi_larger(apart, *difference);
        steps += 1;
        if (steps > most_steps) status = VM_NOT_INTEGRATED;
    }
    return status;
}

/* Numbers of points a step of the loose and of the strict run, and parts of a half period in both runs */
typedef struct VM_TAG(vmi_osc_points) {
    signed char loose, strict, parts;
} vmi_osc_points;

/* The number of pairs of runs that can be tried one after the other */
enum { VMI_OSC_PAIRS = 6 };

/* Whether the rates are smooth inside a half period, so that one step over it is good. With a force they may have kinks
   in the middle, where x' = 0, and where alpha > 3 they change quickly there. Then two steps are better that meet in
   the middle. */
VM_API int vmi_osc_has_smooth_halves(const vm_osc_problem *o) { return o->alpha <= 3 && !o->force; }

/* Pair number i, 0 to VMI_OSC_PAIRS - 1. Each pair is more accurate than the one before. */
VM_API vmi_osc_points vmi_osc_pair(const vm_osc_problem *o, int i)
{
    static const vmi_osc_points smooth[VMI_OSC_PAIRS] = {{4, 6, 1}, {5, 7, 1},  {8, 11, 1},
                                                         {5, 7, 2}, {8, 11, 2}, {14, 20, 2}};
    static const vmi_osc_points other[VMI_OSC_PAIRS] = {{4, 6, 2},  {5, 7, 2},   {6, 8, 2},
                                                        {8, 11, 2}, {10, 14, 2}, {14, 20, 2}};
    return vmi_osc_has_smooth_halves(o) ? smooth[i] : other[i];
}

/* The number of the pair that is tried first. It is about the cheapest that reaches the tolerance where mass and
   stiffness change by 1 % while the phase grows by 1. */
VM_API int vmi_osc_first_pair(const vm_osc_problem *o, vm_real tolerance)
{
    if (o->force) return tolerance >= VM_C(1e-6) ? 2 : 4;
    if (tolerance >= VM_C(1e-6)) return 0;
    if (tolerance >= VM_C(1e-8)) return vmi_osc_has_smooth_halves(o) ? 1 : 0;
    if (tolerance >= VM_C(1e-9)) return 2;
    return tolerance >= VM_C(1e-10) ? 3 : 4;
}

/* The number of the pair that is tried after pair i, whose error is estimated as `error`, larger than the tolerance.
   Pairs are left out whose error would be too large even if it fell as the tenth power of the number of points. */
VM_API int vmi_osc_next_pair(const vm_osc_problem *o, int i, vm_real error, vm_real tolerance)
{
    const vmi_osc_points last = vmi_osc_pair(o, i);
    int next;
    for (next = i + 1; next < VMI_OSC_PAIRS - 1; next++) {
        const vmi_osc_points points = vmi_osc_pair(o, next);
        const vm_real ratio = (vm_real)(last.strict * last.parts) / (vm_real)(points.strict * points.parts);
        const vm_real power_5 = ratio * ratio * ratio * ratio * ratio;
        if (error * power_5 * power_5 <= tolerance) break;
    }
    return next;
}

/* Returns the estimated error of the strict run divided by the difference of the two runs, which is nearly the error of
   the loose run. Where alpha < 1, the rates have terms of the power alpha + 2 in the distance from a zero of x. For them
   the error of Gauss' rule of n points falls as n^-(2 alpha + 6). For larger alpha up to 10 it falls as n^-8 at least.
   Kinks from a force or from a law by a function, and the sharp turns of a large alpha, make it fall more slowly. */
VM_API vm_real vmi_osc_strict_share(const vm_osc_problem *o, vmi_osc_points points)
{
    const vm_real ratio = (vm_real)points.loose / (vm_real)points.strict, squared = ratio * ratio;
    if (o->force || o->mass.function || o->stiffness.function || o->alpha > 10) return squared * squared;
    return squared * squared * squared * (o->alpha >= 1 ? squared : 1);
}

/* Makes one pair of runs from 0 to t. *strict becomes the strict run at t, *error the estimate of its error. */
VM_API int vmi_osc_collocate_pair(const vm_osc_plan *plan, vm_real t, vmi_osc_points points, vm_real longest,
                                  vm_real sweep_limit, vmi_osc_course *strict, vm_real *error)
{
    const int side = vmi_time_side(t);
    const vm_real looser = 16;         /* ratio of their sweep_limits, so that errors of the iteration differ, too */
    vmi_osc_rates now;
    vmi_osc_slow start;
    vmi_osc_reduced state;
    vmi_osc_course loose;
    vm_real difference = 0;
    int status = vmi_osc_rates_at(&plan->problem, 0, side, &now);
    if (status) return status;
    start.m = now.m;
    start.k = now.k;
    start.p = now.p;
    state = vmi_osc_reduce(&start, plan->problem.alpha, plan->problem.x, plan->problem.v);
    vmi_osc_course_start(&loose, plan, &state, side, points.loose, points.parts, looser * sweep_limit);
    vmi_osc_course_start(strict, plan, &state, side, points.strict, points.parts, sweep_limit);
    loose.longest = longest;
    strict->longest = longest;
    while (!status && strict->t != t)
        status = vmi_osc_courses_to(&loose, strict, vmi_osc_next_knot(&plan->problem, strict->t, t), &difference);
    strict->evals += loose.evals;
    *error = vmi_osc_strict_share(&plan->problem, points) * difference + strict->left + 4 * VM_EPSILON * (2 + VM_FABS(strict->psi - state.psi));
    return status;
}

/* Computes the motion at t by collocation. Returns VM_TOLERANCE_MISSED where the motion is computed, but its estimated
   error is larger than the tolerance. Returns VM_NOT_INTEGRATED after 2^24 steps, and where amplitude and phase do not
   describe the motion, because mass, stiffness or force change as fast as the phase. Also returns the statuses of the
   laws. */
VM_API int vmi_osc_collocate(const vm_osc_plan *plan, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_real knots = (vm_real)(plan->problem.mass.n + plan->problem.stiffness.n);
    const vm_real steps = 2 + plan->Om * VM_FABS(t) / plan->ripple.pi + knots;
    const vm_real share = 4 * steps; /* the iterations of all steps may take a quarter of the tolerance */
    const vm_real most_half_periods = VM_C(1073741824.); /* 2^30 */
    vm_osc_motion result;
    vmi_osc_course c;
    vmi_osc_reduced state;
    vmi_osc_rates now;
    vm_real error = VM_INFINITY, sweep_limit = vmi_larger(tolerance / share, VM_EPSILON), sa, ca;
    long evals = 0;
    vm_real longest;
    int i = vmi_osc_first_pair(&plan->problem, tolerance), status = vmi_osc_law_step(plan, t, &longest);
    if (status) return status;
    if (!(plan->Om * VM_FABS(t) <= most_half_periods * plan->ripple.pi)) return VM_NOT_INTEGRATED;
    while (i < VMI_OSC_PAIRS && !(error <= tolerance)) {
        status = vmi_osc_collocate_pair(plan, t, vmi_osc_pair(&plan->problem, i), 2 * longest, sweep_limit, &c, &error);
        if (status) return status;
        evals += c.evals;
        sweep_limit = vmi_larger(sweep_limit / 16, VM_EPSILON); /* perhaps the iterations left too much */
        i = vmi_osc_next_pair(&plan->problem, i, error, tolerance);
    }
    status = vmi_osc_rates_at(&plan->problem, t, -c.side, &now);
    if (status) return status;
    state.psi = c.psi;
    state.A = plan->A * vmi_exp(c.ln_A, 0);
    state.W = plan->Om * vmi_osc_Om_ratio(plan, &now, c.ln_A);
    vmi_osc_wave_at(&c.wave, c.psi, &ca, &sa);
    vmi_osc_unreduce(&state, now.p, plan->problem.alpha, sa, ca, &result.x, &result.v);
    result.amplitude = state.A;
    result.error = error;
    result.route = route;
    result.evals = evals;
    if (!VM_IS_FINITE(result.x) || !VM_IS_FINITE(result.v)) return VM_NOT_FINITE;
    *motion = result;
    return error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
}

#endif
/* oscillators/routes.h - the motion x(t) of an oscillator at any time, by a given route or by the cheapest

   Ten routes lead to x(t) and x'(t), from a cosine to the integration of the equation of motion by rk87 (VM_ROUTE_...
   in oscillators/problem.h). vm_osc_within takes the cheapest route whose error is estimated to be within a tolerance.
   vm_osc_by_route takes the route that its argument names. vm_osc_plan_within and vm_osc_plan_by_route do the same from
   a plan, for one problem at many values of t. The shortest useful call:
       vm_osc_problem bucket = {1, vm_law_linear(10, -0.1), vm_law_linear(250, 0), 0, 0, 0.05, 0, NULL, NULL};
       vm_osc_motion motion;
       if (vm_osc_within(&bucket, 70, 1e-6, &motion) == VM_OK) printf("%g m\n", motion.x);
   Tests: tests/test_routes.c, tests/test_ladder.c. */
#ifndef VARMASS_OSCILLATORS_ROUTES_H
#define VARMASS_OSCILLATORS_ROUTES_H

/* -- What each route costs, which one is chosen, what its estimate covers, and how good the estimate is --

   Cost. Without a force F the first seven routes are averaged solutions in closed form: they need one or two
   evaluations of sa and ca and the integrals of the laws of mass and stiffness, whatever t and the tolerance are. The
   other routes integrate from 0 to t to the tolerance. Each of them runs twice, the second time more strictly, and the
   difference of the two runs gives the error. With F the averaged equations of the first three routes are integrated,
   too, and the laws of orders 2 to 5 do not exist. docs/cost.md has the times.

   Choice. vm_osc_within takes the first of these seven solutions that is within the tolerance. Where none is, or where
   F is given, it integrates by collocation, and where amplitude and phase do not describe the motion by rk87.

   What the estimate of an averaged solution covers:
     - the terms that the solution leaves out, the error of cos and cn in place of ca, and rounding errors of the phase;
     - fast changes of mass and stiffness between 0 and t. The walk along the laws looks for them panel by panel (for
       laws by functions see vm_law_user), and in tables from one point to the next. A change within a period makes the
       estimate large, so that vm_osc_within integrates. For a law by a function its steps are then limited by the
       shortest panel, so that no step skips the change.
   What the estimate of averaged equations with F covers:
     - the error of their integration, and the error of cos and cn in place of ca;
     - what averaging leaves out: the ripple within a period, its effect at the start, and terms of second order in it;
     - a force that changes within a period, as in a resonance. For this the estimate calls F over a period at the start
       and over periods at eight later times, so it misses a force that acts only for a short time between them.

   How good the estimate is. tests/test_routes.c compares it with the true error of random problems with alpha from
   1/8 to 8, a rate q from 2e-3 to 0.1, and t from 1/q to 3/q. In double its bounds are, for
     the share of problems whose true error is above 3 times the estimate: 1 % by vm_osc_within, 4 % by rk87, else 2 %,
     the largest ratio of true error to estimate: 30 by rk87, 40 by rk45, else 10,
     the median ratio of estimate to true error: 45 by collocation, 25 by rk87, 13 by rk45, 15 by orders 4 and 5 and for
       averaged solutions with F, else 10.
   The estimate is worse for rk87, because its errors are not proportional to the tolerance if alpha is not an odd
   integer. */

/* -- The table of routes -- */

/* A function that computes the motion at t from the mean motion *mean at t, for a problem without a force */
typedef int (*vmi_osc_solution)(const vm_osc_plan *p, int route, const vmi_osc_wave *w, const vmi_osc_mean *mean,
                                vm_osc_motion *motion);

/* A function that computes the motion at t by integration from 0 to t, to a tolerance */
typedef int (*vmi_osc_integration)(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance,
                                   vm_osc_motion *motion);

/* Integrates the averaged equations; with a force they have no solution in closed form. */
VM_API int vmi_osc_integrate_averaged(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance,
                                      vm_osc_motion *motion)
{
    vmi_osc_method method = vmi_osc_method_rk45(vmi_osc_averaged_rhs);
    method.averaged = 1;
    return vmi_osc_integrate(p, route, &method, t, tolerance, motion);
}

/* Integrates the equation of motion by rk45. */
VM_API int vmi_osc_integrate_rk45(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_method method = vmi_osc_method_rk45(vmi_osc_direct_rhs);
    method.direct = 1;
    return vmi_osc_integrate(p, route, &method, t, tolerance, motion);
}

/* Integrates the equation of motion by rk87. */
VM_API int vmi_osc_integrate_rk87(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_method method = vmi_osc_method_rk87(vmi_osc_direct_rhs);
    method.direct = 1;
    return vmi_osc_integrate(p, route, &method, t, tolerance, motion);
}

/* A route. Without a force it takes its solution in closed form, if it has one; otherwise it integrates. */
typedef struct VM_TAG(vmi_osc_route) {
    const char *name;
    vmi_osc_solution solution;     /* the solution in closed form, or null if there is none */
    vmi_osc_integration integrate; /* the integration, or null if there is none */
} vmi_osc_route;

/* Makes the table entry of a route from its name, closed form and integration. */
VM_API vmi_osc_route vmi_osc_route_by(const char *name, vmi_osc_solution solution, vmi_osc_integration integrate)
{
    vmi_osc_route route;
    route.name = name;
    route.solution = solution;
    route.integrate = integrate;
    return route;
}

/* Returns the entry of the table of routes for `route`, one of VM_ROUTE_.... */
VM_API vmi_osc_route vmi_osc_route_of(int route)
{
    switch (route) {
    case VM_ROUTE_TRIG: return vmi_osc_route_by("trigonometric", vmi_osc_first_order, vmi_osc_integrate_averaged);
    case VM_ROUTE_JACOBI: return vmi_osc_route_by("Jacobi", vmi_osc_first_order, vmi_osc_integrate_averaged);
    case VM_ROUTE_ATEB: return vmi_osc_route_by("Ateb, first order", vmi_osc_first_order, vmi_osc_integrate_averaged);
    case VM_ROUTE_ORDER2: return vmi_osc_route_by("law of order two", vmi_osc_order_n, NULL);
    case VM_ROUTE_ORDER3: return vmi_osc_route_by("law of order three", vmi_osc_order_n, NULL);
    case VM_ROUTE_ORDER4: return vmi_osc_route_by("law of order four", vmi_osc_order_n, NULL);
    case VM_ROUTE_ORDER5: return vmi_osc_route_by("law of order five", vmi_osc_order_n, NULL);
    case VM_ROUTE_COLLOCATION: return vmi_osc_route_by("collocation", NULL, vmi_osc_collocate);
    case VM_ROUTE_RK45: return vmi_osc_route_by("direct, rk45", NULL, vmi_osc_integrate_rk45);
    case VM_ROUTE_RK87: return vmi_osc_route_by("direct, rk87", NULL, vmi_osc_integrate_rk87);
    default: return vmi_osc_route_by("unknown route", NULL, NULL);
    }
}

/* Name of a route VM_ROUTE_..., in English; "unknown route" for any other number. */
VM_API const char *vm_osc_route_name(int route) { return vmi_osc_route_of(route).name; }

/* -- One route -- */

/* Checks the arguments that all calls share, except for the problem or the plan. */
VM_API int vmi_osc_check_arguments(int route, vm_real t, vm_real tolerance, const vm_osc_motion *motion)
{
    if (!motion || route < VM_ROUTE_TRIG || route > VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(tolerance)) return VM_NOT_FINITE;
    if (tolerance < 0) return VM_DOMAIN;
    return VM_OK;
}

/* Checks the arguments that all calls with a plan share, and replaces a tolerance of 0 by the default. */
VM_API int vmi_osc_check_call(const vm_osc_plan *p, int route, vm_real t, vm_real *tolerance,
                              const vm_osc_motion *motion)
{
    const int status = vmi_osc_check_arguments(route, t, *tolerance, motion);
    if (!p) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return status;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    return vmi_first_error(status, vmi_osc_check_laws(&p->problem, t));
}

/* Writes the motion of a body at rest at x = 0, which stays at rest. With a force it returns VM_NO_LAW, since no route
   can compute the motion that the force starts. */
VM_API int vmi_osc_at_rest(const vm_osc_plan *p, int route, vm_osc_motion *motion)
{
    if (p->problem.force) return VM_NO_LAW;
    motion->x = 0;
    motion->v = 0;
    motion->amplitude = 0;
    motion->error = 0;
    motion->route = route;
    motion->evals = 0;
    return VM_OK;
}

/* Motion x(t), x'(t) at time t (s, either sign) by a given route, from a plan. route is one of VM_ROUTE_....
   motion->error estimates the larger of |error of x|/A and |error of v|/vmax. Routes that integrate keep the part of
   this error that comes from the integration within the tolerance; a tolerance of 0 means 1e-6 (float 1e-3). A comment
   at the start of oscillators/routes.h says what a route costs. Returns VM_OK, or VM_TOLERANCE_MISSED where x and v are
   computed but the error of integration is larger than the tolerance. An error leaves *motion untouched; it returns
     VM_BAD_ARGUMENT for null pointers or a route that does not exist,
     VM_NOT_FINITE for a number that is infinite or NaN,
     VM_BAD_MASS or VM_BAD_STIFFNESS for a law that is not positive between 0 and t,
     VM_DOMAIN for a negative tolerance, t outside a table, a table out of order, a user's function of a law that fails,
       or a change_time that is negative or too short,
     VM_NO_LAW for the laws of orders 2 to 5 with F, and for F on a body at rest at x = 0,
     VM_NOT_INTEGRATED where amplitude and phase do not describe the motion, for collocation only,
     VM_NOT_INTEGRATED where the integrator gives up, or would need too many steps: more than 2^13 a period plus four
       times what its longest step asks for, or more than 2^23 of the present periods. Thus every call ends. */
VM_API int vm_osc_plan_by_route(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_route entry;
    vmi_osc_mean mean;
    vmi_osc_wave w;
    int status = vmi_osc_check_call(p, route, t, &tolerance, motion);
    if (status) return status;
    entry = vmi_osc_route_of(route);
    if (p->problem.force && !entry.integrate) return VM_NO_LAW;
    if (p->A == 0) return vmi_osc_at_rest(p, route, motion);
    if (p->problem.force || !entry.solution) return entry.integrate(p, route, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    w = vmi_osc_wave_of(p, route);
    return entry.solution(p, route, &w, &mean, motion);
}

/* -- The cheapest route -- */

/* Writes the motion at t by the first of cos, cn, ca and the orders 2 to 5 whose error is estimated to be within the
   tolerance. Returns VM_TOLERANCE_MISSED where there is none, and leaves *motion untouched. */
VM_API int vmi_osc_averaged_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    const vm_real reserve = VM_C(1.5); /* in one case of 400 the error exceeds the estimate, up to 1.9 times */
    vmi_osc_mean mean;
    vmi_osc_wave w;
    vm_real first;
    int route, order, status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    first = vmi_osc_first_error(p, &mean);
    for (route = VM_ROUTE_TRIG; first <= tolerance; route++) { /* ends at VM_ROUTE_ATEB: ca has no error */
        w = vmi_osc_wave_of(p, route);
        if (first + vmi_osc_wave_error(&w, p->ripple.mean2) <= tolerance)
            return vmi_osc_first_order(p, route, &w, &mean, motion);
    }
    w = vmi_osc_wave_of(p, VM_ROUTE_ORDER5);
    for (order = 2; order <= p->start_order; order++)
        if (reserve * vmi_osc_order_error(p, order, &mean) <= tolerance)
            return vmi_osc_order_n(p, vmi_osc_route_of_order(order), &w, &mean, motion);
    return VM_TOLERANCE_MISSED;
}

/* Motion at any time t (s) by integration, for vm_osc_plan_within where no averaged solution is good enough: by
   collocation, and by rk87 where amplitude and phase do not describe the motion. If both miss the tolerance, the
   one with the smaller error is taken. */
VM_API int vmi_osc_integrate_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_motion direct;
    int direct_status, status = vmi_osc_collocate(p, VM_ROUTE_COLLOCATION, t, tolerance, motion);
    if (status == VM_NOT_INTEGRATED) return vmi_osc_integrate_rk87(p, VM_ROUTE_RK87, t, tolerance, motion);
    if (status != VM_TOLERANCE_MISSED) return status;
    direct_status = vmi_osc_integrate_rk87(p, VM_ROUTE_RK87, t, tolerance, &direct);
    if (direct_status < 0 || !(direct.error < motion->error)) return status;
    *motion = direct;
    return direct_status;
}

/* Motion x(t), x'(t) at time t (s, either sign) within a tolerance, from a plan. It takes the cheapest route whose
   error is estimated to be within the tolerance; motion->route says which. The tolerance is relative, for the larger
   of |error of x|/A and |error of v|/vmax: for x within d metres ask for d/A; 0 means 1e-6 (float 1e-3). The statuses
   are those of vm_osc_plan_by_route. */
VM_API int vm_osc_plan_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    int status = vmi_osc_check_call(p, VM_ROUTE_TRIG, t, &tolerance, motion);
    if (status) return status;
    if (p->A == 0) return vmi_osc_at_rest(p, VM_ROUTE_TRIG, motion);
    if (p->problem.force) return vmi_osc_integrate_within(p, t, tolerance, motion);
    status = vmi_osc_averaged_within(p, t, tolerance, motion);
    if (status != VM_TOLERANCE_MISSED) return status;
    return vmi_osc_integrate_within(p, t, tolerance, motion);
}

/* -- Without a plan -- */

/* Makes the plan of a problem for one call, without the plan of the Ateb functions, which is worth its time only for
   many calls. complete = 1 also makes the polynomials of the ripple, which orders 3 to 5 need. */
VM_API int vmi_osc_once(const vm_osc_problem *problem, int complete, vm_osc_plan *plan)
{
    int status;
    if (!problem) return VM_BAD_ARGUMENT;
    status = vmi_osc_prepare(plan, problem, 0);
    if (status) return status;
    if (complete) vmi_ripple_complete(&plan->ripple);
    return vmi_osc_start(plan);
}

/* Motion x(t), x'(t) at time t (s, either sign) by a given route. It is for a single value of t. Arguments, result
   and statuses are those of vm_osc_plan_by_route; it also returns the statuses of vm_osc_plan_init. */
VM_API int vm_osc_by_route(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance,
                           vm_osc_motion *motion)
{
    const int complete = route >= VM_ROUTE_ORDER3 && route <= VM_ROUTE_ORDER5;
    vm_osc_plan plan;
    int status = vmi_osc_check_arguments(route, t, tolerance, motion);
    status = vmi_first_error(status, vmi_osc_once(problem, complete, &plan));
    if (status) return status;
    return vm_osc_plan_by_route(&plan, route, t, tolerance, motion);
}

/* Motion x(t), x'(t) at time t (s, either sign) within a tolerance. It is for a single value of t, by the cheapest
   route. Arguments, result and statuses are those of vm_osc_plan_within; it also returns the statuses of
   vm_osc_plan_init. */
VM_API int vm_osc_within(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_check_arguments(VM_ROUTE_TRIG, t, tolerance, motion);
    status = vmi_first_error(status, vmi_osc_once(problem, 0, &plan));
    if (!status) status = vmi_osc_check_call(&plan, VM_ROUTE_TRIG, t, &tolerance, motion);
    if (status) return status;
    if (plan.A == 0) return vmi_osc_at_rest(&plan, VM_ROUTE_TRIG, motion);
    if (!problem->force) {
        status = vmi_osc_averaged_within(&plan, t, tolerance, motion);
        if (status != VM_TOLERANCE_MISSED) return status;
        vmi_ripple_complete(&plan.ripple);
        status = vmi_osc_start(&plan);
        if (status) return status;
    }
    return vm_osc_plan_within(&plan, t, tolerance, motion);
}

#endif
/* oscillators/slow.h - laws that oscillators with slowly varying mass share

   Here are, in closed form, the amplitude and the largest velocity of an oscillator
       m x'' + k x|x|^(alpha-1) = -(r m' + b) x'
   whose mass m(t) varies slowly, that is little within a period: (325), (326), (344), (364), (367), (389), (395).
   The chapters on Van der Pol's oscillator, on the rotor, on two bodies and on harmonic excitation build on this file.

       vm_real A = 3 * vm_osc_amplitude_law(VM_C(0.5), 0, 1, 3); // cubic spring, half of the mass gone, A was 3

   Symbols of these chapters: A amplitude, psi Ateb phase, Om = psi' its rate, m mass, k stiffness, b damping,
   r = reactive, q the rate at which mass, damping and stiffness change the vibration (vmi_slow_q). Averaging needs q
   much smaller than Om.
   Tests: tests/test_averaging.c, tests/test_constant_mass.c. */
#ifndef VARMASS_OSCILLATORS_SLOW_H
#define VARMASS_OSCILLATORS_SLOW_H

/* Whether the arguments of vm_osc_amplitude_law and vm_osc_velocity_law are in their domain */
VM_API int vmi_osc_law_is_in_domain(vm_real mass_ratio, vm_real decay, vm_real reactive, vm_real alpha)
{
    return mass_ratio > 0 && alpha >= 0 && VM_IS_FINITE(mass_ratio) && VM_IS_FINITE(decay) &&
           VM_IS_FINITE(reactive) && VM_IS_FINITE(alpha);
}

/* Amplitude over its first value, A/A0, of an oscillator whose mass varies slowly.
   The law, (325), (344), (367), (389) corrected, is
     A/A0 = (m0/m)^((2r-1)/(alpha+3)) exp(-2 decay/(alpha+3)).
   Averaging with ca, with cos and with cn gives this law, if the sign in (335) is corrected. It holds to first order in
   m' and the damping. The arguments are pure numbers: mass_ratio = m/m0 > 0; decay, the integral of damping/mass;
   reactive, r, which is 1 where mass that joins or leaves is at rest, so that there is the full reactive force, and 0
   where it has the body's own velocity, as in a leak; and alpha >= 0. Returns NaN outside the domain and for infinite
   arguments. */
VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real decay, vm_real reactive, vm_real alpha)
{
    if (!vmi_osc_law_is_in_domain(mass_ratio, decay, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (1 - 2 * reactive) / (alpha + 3)) * vmi_exp(-2 * decay / (alpha + 3), 0);
}

/* Largest velocity over its first value, of an oscillator whose mass varies slowly. It follows from the amplitude A
   by x'_max = sqrt(2 k A^(alpha+1)/((alpha+1) m)): (326), (364), (395) corrected. The arguments and the results
   outside the domain are those of vm_osc_amplitude_law. */
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real decay, vm_real reactive, vm_real alpha)
{
    const vm_real share = (alpha + 1) / (alpha + 3); /* (alpha+1)/2, the power of A, times 2/(alpha+3) */
    if (!vmi_osc_law_is_in_domain(mass_ratio, decay, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (share * (1 - 2 * reactive) - 1) / 2) * vmi_exp(-share * decay, 0);
}

/* A linear mass m0 + rate t, from the time 0 to t */
typedef struct VM_TAG(vmi_linear_mass) {
    vm_real m0, m, rate; /* mass at 0 and mass at t, kg; rate of the mass, kg/s */
    vm_real ln_ratio;    /* ln(m/m0) */
    vm_real integral;    /* integral of dt/m from 0 to t, s/kg; it has no singularity at rate = 0 */
} vmi_linear_mass;

/* Writes the linear mass that a law describes between 0 and t, which closed forms need. Returns VM_NO_LAW where the law
   is neither linear nor constant (vmi_law_exponential_form does not give rate = base), VM_BAD_MASS where the mass is
   not positive at 0 or at t, VM_BAD_ARGUMENT where no constructor made the law, and VM_NOT_FINITE for a number that is
   infinite or NaN. */
VM_API int vmi_linear_mass_of(const vm_law *law, vm_real t, vmi_linear_mass *linear)
{
    vm_real growth, mean, base, rate;
    int status = vmi_law_at(law, VM_BAD_MASS, 0, &linear->m0, &linear->rate);
    if (!status) status = vmi_law_at(law, VM_BAD_MASS, t, &linear->m, &rate);
    if (status) return status;
    if (!vmi_law_exponential_form(law, &base, &rate) || base != rate) return VM_NO_LAW;
    growth = linear->rate * t / linear->m0;
    if (!VM_IS_FINITE(growth)) return VM_NOT_FINITE;
    if (!(growth > -1)) return VM_BAD_MASS;
    mean = vmi_log_ratio(growth); /* the mean of m0/m from 0 to t */
    linear->ln_ratio = growth * mean;
    linear->integral = t / linear->m0 * mean;
    return VM_OK;
}

/* The drag (2r - 1) m' + 2 b, kg/s, which the reactive force and the damping b together exert on the vibration. Where
   mass joins at rest (r = 1) it is m' + 2 b, where mass joins with the body's velocity (r = 0) it is -m' + 2 b. */
VM_API vm_real vmi_slow_drag(vm_real reactive, vm_real mass_rate, vm_real damping)
{
    return (2 * reactive - 1) * mass_rate + 2 * damping;
}

/* q = drag/m + k'/k, 1/s: the rate at which mass, damping and stiffness change the vibration, where drag = (2r - 1)
   m' + 2 b. The mean amplitude follows A' = -q A/(alpha + 3). */
VM_API vm_real vmi_slow_q(vm_real drag, vm_real mass, vm_real k, vm_real k_rate) { return drag / mass + k_rate / k; }

/* Om, the rate of the Ateb phase at the amplitude A, 1/s; 0 at rest, where the formula may give infinity */
VM_API vm_real vmi_slow_rate(vm_real A, vm_real k, vm_real mass, vm_real alpha)
{
    if (A == 0 && alpha < 1) return 0;
    return vmi_osc_rate(A, VM_SQRT(k / mass), alpha);
}

/* Writes the position x = A ca(psi) and the velocity x' = -vmax(A) sa(psi), where vmax is vm_osc_vmax. */
VM_API void vmi_slow_motion(vm_real A, vm_real psi, vm_real k, vm_real mass, vm_real alpha, vm_real *x, vm_real *v)
{
    vmi_osc_at_phase(A, psi, VM_SQRT(k / mass), alpha, x, v);
}

/* Writes the amplitude A and the Ateb phase psi from x and v = x', the inverse of vmi_slow_motion. */
VM_API void vmi_slow_phase(vm_real x, vm_real v, vm_real k, vm_real mass, vm_real alpha, vm_real *A, vm_real *psi)
{
    vm_osc_amplitude_phase(x, v, VM_SQRT(k / mass), alpha, A, psi);
}

#endif
/* oscillators/van_der_pol.h - the Van der Pol oscillator with variable mass

   The equation is (404), with the mass m(t) and a spring of any exponent alpha:
       m x'' + k x|x|^(alpha-1) = (feed - c x^2) x' - r m' x'
   feed > 0 feeds the vibration and c > 0 limits it, so that it tends to a limit cycle. r (`reactive`) is 1 where mass
   that joins or leaves is at rest, 0 where it has the body's velocity. This file has the equation of motion, the
   averaged equations (410), the amplitude in closed form for a linear mass, and the amplitude of the limit cycle: (403)
   to (440), as corrected in docs/errata.md.

       vm_vdp v;
       memset(&v, 0, sizeof v);
       v.alpha = v.k = v.reactive = 1;
       v.feed = v.c = VM_C(0.1);
       v.mass = vm_law_linear(1, VM_C(0.02)); // 1 kg, and 0.02 kg/s joins at rest
       int status = vm_vdp_init(&v);
       vm_real A = vm_vdp_amplitude(&v, 100, VM_C(0.3)); // at t = 100 s, where it was 0.3 m at t = 0

   Tests: tests/test_van_der_pol.c. */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_H

/* Methods of averaging. Each takes the means over one period of the motion x that is named beside it. */
enum {
    VM_VDP_ATEB = 0,         /* A ca(psi), the exact motion without damping: its means are exact to first order */
    VM_VDP_JACOBI = 1,       /* A cn with Jacobi's cn (411)-(413): the amplitude of the limit cycle is wrong by
                                at most 0.51 % for 1/3 <= alpha <= 5 */
    VM_VDP_TRIGONOMETRIC = 2 /* A cos(psi) for every alpha: the amplitude of the limit cycle does not depend on alpha */
};

/* A Van der Pol oscillator. Fill all fields but a1, a2, a3, then call vm_vdp_init. feed and c are eps b and eps c in
   the dissertation; both may have either sign. */
typedef struct VM_TAG(vm_vdp) {
    vm_real alpha;      /* exponent of the spring, >= 0 */
    vm_real k;          /* stiffness, N/m^alpha, > 0 */
    vm_real feed;       /* coefficient of the term that feeds the vibration, N s/m; < 0 takes energy out */
    vm_real c;          /* coefficient of the term that limits the vibration, N s/m^3 */
    vm_real reactive;   /* r: 1 where mass that joins or leaves is at rest, 0 where it has the body's velocity */
    int method;         /* method of averaging, VM_VDP_... */
    vm_law mass;        /* slow mass m, kg, > 0; vm_vdp_init and vm_vdp_limit_cycle do not use it */
    vm_real a1, a2, a3; /* mean values of (410), pure numbers; vm_vdp_init writes them */
} vm_vdp;

/* Writes the mean values a1, a2, a3 for the oscillator's method. For VM_VDP_JACOBI, a1 of (411) is simplified
   by (1 - m) + m C4 = 2 a2, where m is the parameter of cn and C4 the mean of cn^4. */
VM_API void vmi_vdp_means(vm_vdp *v)
{
    v->a1 = 1;
    v->a2 = 2 / (v->alpha + 3);
    if (v->method == VM_VDP_ATEB) {
        v->a3 = 2 / (v->alpha + 1) * ateb_mean(v->alpha, 2, 2);
    } else if (v->method == VM_VDP_TRIGONOMETRIC) {
        v->a3 = v->a2 / 4;
    } else {
        const vm_real m = vm_osc_jacobi_parameter(v->alpha);
        vm_real C2, C4, C6;
        jacobi_cn_means(m, &C2, &C4, &C6);
        v->a2 = (1 - m) - (1 - 2 * m) * C2 - m * C4;
        v->a1 = (v->alpha + 3) / 2 * v->a2;
        v->a3 = (1 - m) * C2 - (1 - 2 * m) * C4 - m * C6;
    }
}

/* Checks that the numbers of a Van der Pol oscillator are in their domains. */
VM_API int vmi_vdp_check(const vm_vdp *v)
{
    const vm_real numbers[5] = {v->alpha, v->k, v->feed, v->c, v->reactive};
    if (!vmi_all_finite(5, numbers)) return VM_NOT_FINITE;
    if (v->k <= 0) return VM_BAD_STIFFNESS;
    if (v->alpha < 0) return VM_DOMAIN;
    return VM_OK;
}

/* Prepare a Van der Pol oscillator: check alpha, k, feed, c, reactive and method, and write a1, a2, a3 (411)-(413).
   The functions below need it; the mass may be set and changed later. The mean values are within 20 eps. Returns
   VM_BAD_ARGUMENT for a null pointer or an unknown method, VM_NOT_FINITE for a number that is infinite or NaN,
   VM_BAD_STIFFNESS for k <= 0, VM_DOMAIN for alpha < 0, and VM_OK otherwise. An error leaves v as it was. */
VM_API int vm_vdp_init(vm_vdp *v)
{
    int status;
    if (!v || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    status = vmi_vdp_check(v);
    if (status) return status;
    vmi_vdp_means(v);
    return VM_OK;
}

/* The drive 2 feed - (2 reactive - 1) m', N s/m, which on average feeds energy to a small vibration */
VM_API vm_real vmi_vdp_drive(const vm_vdp *v, vm_real mass_rate)
{
    return -vmi_slow_drag(v->reactive, mass_rate, -v->feed);
}

/* The growth a1 m A'/A at the amplitude A, N s/m: the averages of Van der Pol's term and of the reactive force (410),
   with the mass m. The growth is 0 on the limit cycle. vm_vdp_amplitude is the solution of A' = A growth(A)/(a1 m). */
VM_API vm_real vmi_vdp_growth(const vm_vdp *v, vm_real mass_rate, vm_real A)
{
    return vmi_vdp_drive(v, mass_rate) * v->a2 / 2 - v->c * A * A * v->a3;
}

/* Whether the closed forms below may be used: whether vm_vdp_init has prepared the oscillator */
VM_API int vmi_vdp_has_closed_forms(const vm_vdp *v) { return v->a1 > 0; }

/* Amplitude of a Van der Pol oscillator at time t, in closed form for a linear mass.
   first_A is the amplitude, m, at t = 0, of either sign. One formula stands for (422), (424), (427), (429),
   (431)-(435), (437), as corrected, and has no singularity where terms cancel. The error is that of averaging (see
   `method`) and that of rounding, which tests bound by 12 eps. Returns NaN for a null pointer, an oscillator that is
   not prepared, infinite arguments, a mass that is not positive at 0 or at t, and a mass that is neither linear nor
   constant (integrate vm_vdp_averaged_rhs instead); with c < 0 also from the time on at which the amplitude becomes
   infinite. Method: the solution of (416) is
     1/A^2 = e^-F (1/first_A^2 + 2 c a3/a1 times the integral of e^F dt/m),  F = drive a2/a1 times the integral of dt/m,
   where drive = 2 feed - (2r - 1) m'. For a linear mass F is proportional to the integral of dt/m, hence the integral
   of e^F dt/m is (e^F - 1)/F times the integral of dt/m. The code uses e^-|F| and divides by the larger of the two
   terms, so that nothing overflows. */
VM_API vm_real vm_vdp_amplitude(const vm_vdp *v, vm_real t, vm_real first_A)
{
    if (!v) return VM_NAN;
    vmi_linear_mass m;
    vm_real F, e, limit, root, size, scale, numerator, free_term, denominator;
    if (!VM_IS_FINITE(first_A) || !VM_IS_FINITE(v->c) || !vmi_vdp_has_closed_forms(v)) return VM_NAN;
    if (vmi_linear_mass_of(&v->mass, t, &m)) return VM_NAN;
    F = vmi_vdp_drive(v, 0) * (v->a2 / v->a1) * m.integral -
        (2 * v->reactive - 1) * (v->a2 / v->a1) * m.ln_ratio;
    e = vmi_exp(-VM_FABS(F), 0);
    limit = 2 * v->c * (v->a3 / v->a1) * m.integral * vmi_exp_ratio(-VM_FABS(F));
    root = VM_SQRT(VM_FABS(limit));
    size = VM_FABS(first_A) * root; /* its square is added to free_term with the sign of limit */
    if (F > 0) {
        numerator = 1;
        free_term = e;
    } else {
        numerator = e;
        free_term = 1;
    }
    if (size > 1) {
        scale = VM_COPYSIGN(1 / root, first_A);
        denominator = free_term / size / size + VM_COPYSIGN(1, limit);
    } else {
        scale = first_A;
        denominator = free_term + VM_COPYSIGN(size * size, limit);
    }
    if (denominator < 0) return VM_NAN;
    return scale * VM_SQRT(numerator / denominator);
}

/* Amplitude of the limit cycle, m, while the mass changes at mass_rate (kg/s): (425), (430), (438). It is 0 where
   there is no limit cycle. *stable_or_NULL becomes 1 if amplitudes near the result tend to it, else 0. The relative
   rounding error is at most 3e-15 (float 6e-6); the error of averaging comes on top. Returns NaN for a null pointer, an
   oscillator that is not prepared, or an infinite mass_rate. */
VM_API vm_real vm_vdp_limit_cycle(const vm_vdp *v, vm_real mass_rate, int *stable_or_NULL)
{
    if (!v) return VM_NAN;
    const vm_real drive = vmi_vdp_drive(v, mass_rate);
    const int exists = (drive > 0 && v->c > 0) || (drive < 0 && v->c < 0);
    const int limited = v->c > 0, rest_is_stable = drive < 0 || (drive == 0 && limited);
    if (!VM_IS_FINITE(drive) || !vmi_vdp_has_closed_forms(v)) return VM_NAN;
    if (stable_or_NULL) *stable_or_NULL = exists ? limited : rest_is_stable;
    if (!exists) return 0;
    return VM_SQRT(drive / v->c * (v->a2 / (2 * v->a3)));
}

/* Equation of motion (404) of a Van der Pol oscillator, for rk45 or rk87.
   y = (x, x') is in m and m/s; vdp points to a vm_vdp. Returns VM_BAD_ARGUMENT for null pointers or where no
   constructor made the mass, VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS for a mass that is not
   positive, VM_BAD_STIFFNESS for k <= 0, and VM_DOMAIN for alpha < 0 and for t outside a table. These statuses stop the
   run. */
VM_API int vm_vdp_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate, feed;
    const int status = vmi_first_error(vmi_law_at(&v->mass, VM_BAD_MASS, t, &mass, &rate), vmi_vdp_check(v));
    if (status) return status;
    feed = vmi_van_der_pol_feed(v->feed, v->c, y[0]) - v->reactive * rate;
    dydt[0] = y[1];
    dydt[1] = (feed * y[1] - v->k * vmi_osc_elastic(y[0], v->alpha)) / mass;
    return VM_OK;
}

/* Averaged equations (410) of a Van der Pol oscillator, for rk45 or rk87.
   The mass M may follow any slow law. y = (A, psi) holds the mean amplitude A in metres and the Ateb phase psi:
   x = A ca(psi), and |x| = A at the turning points. vdp points to a prepared vm_vdp with the fields feed and c. For the
   method VM_VDP_ATEB and a start from rest, let e be the largest of feed, c A^2 and M', divided by M psi'. Then, up to
   the time M/feed, the relative error of A is of the order of e^2, and the error of psi of the order of e. The statuses
   are those of vm_vdp_rhs. */
VM_API int vm_vdp_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_first_error(vmi_law_at(&v->mass, VM_BAD_MASS, t, &mass, &rate), vmi_vdp_check(v));
    if (status) return status;
    dydt[0] = y[0] / (v->a1 * mass) * vmi_vdp_growth(v, rate, y[0]);
    dydt[1] = vmi_slow_rate(y[0], v->k, mass, v->alpha);
    return VM_OK;
}

#endif
/* oscillators/jeffcott.h - the Jeffcott (Laval) rotor with variable mass

   A disc of mass m(t) turns in the middle of a shaft without mass. z = x + i y is the disc's centre (451), F_e(rho) the
   shaft's elastic force at the deflection rho = |z|, and F_e'(rho) is short for F_e(rho)/rho, as in the dissertation
   [1]. g is the gyroscopic constant of the remark after (516). r is the share of the reactive force of mass that joins
   or leaves with the velocity u, and F_z an external force:
       m z'' + z F_e(|z|)/|z| - 2 i g z' = F_z + r m' (u - z')
   Here are the equation of motion, averaged equations for a weak nonlinearity (460)-(473), averaged equations for
   nearly circular motion with any nonlinearity (491)-(507), and the law of the radius (509).

       vm_power_force cubic = {1, 3}; // F_e = rho^3
       vm_jeffcott rotor;
       memset(&rotor, 0, sizeof rotor); // a zero field means that there is none
       rotor.stiffness = vm_jeffcott_power;
       rotor.stiffness_ctx = &cubic;
       rotor.mass = vm_law_linear(1, VM_C(0.01)); // 1 kg, and 0.01 kg/s joins
       rotor.reactive = 1;
       vm_real radius = vm_jeffcott_amplitude(&rotor, 1, 1, 2); // of the whirl, m, when the mass has doubled

   Tests: tests/test_jeffcott.c. */
#ifndef VARMASS_OSCILLATORS_JEFFCOTT_H
#define VARMASS_OSCILLATORS_JEFFCOTT_H

/* Stiffness of the shaft, a user's function: returns F_e' = F_e(rho)/rho, N/m, at the deflection rho >= 0, m, and
   writes its derivative by rho, N/m^2, to *slope. ctx is the user's pointer. vm_jeffcott_power is such a function. */
typedef vm_real (*vm_jeffcott_stiffness)(vm_real rho, vm_real *slope, void *ctx);

/* External force, a user's function: returns F_z = F_x + i F_y, N, at time t, position z and velocity v of the disc.
   ctx is the user's pointer. */
typedef vm_complex (*vm_jeffcott_force)(vm_real t, vm_complex z, vm_complex v, void *ctx);

/* The elastic force k rho^alpha of a power law: k in N/m^alpha, and the pure number alpha */
typedef struct VM_TAG(vm_power_force) {
    vm_real k, alpha;
} vm_power_force;

/* A rotor. The fields mass and stiffness must be set; any other field may be zero. */
typedef struct VM_TAG(vm_jeffcott) {
    vm_law mass;                     /* mass m of the disc, kg, > 0 */
    vm_jeffcott_stiffness stiffness; /* stiffness of the shaft */
    void *stiffness_ctx;     /* the user's pointer, handed to stiffness */
    vm_jeffcott_force force; /* external force F_z, or null; it must be small where equations are averaged */
    void *force_ctx;         /* the user's pointer, handed to force */
    vm_real gyro;            /* g, kg/s: the gyroscopic force is 2 g times the velocity, turned by +90 degrees */
    vm_real reactive;        /* r: 1 where mass joins or leaves with velocity u, 0 where it has the disc's velocity */
    vm_complex u;            /* absolute velocity of mass that joins or leaves, m/s */
    int nodes;               /* number of phases in a mean over a period; 0 means 32 */
} vm_jeffcott;

/* Indices of the state of vm_jeffcott_exact_rhs and vm_jeffcott_averaged_rhs */
enum {
    VMI_JEFFCOTT_P = 0,   /* numbers 0 and 1: forward whirl P, a complex number */
    VMI_JEFFCOTT_N = 2,   /* numbers 2 and 3: backward whirl N, a complex number */
    VMI_JEFFCOTT_PHI = 4, /* number 4: fast phase phi */
    VMI_JEFFCOTT_SIZE = 5
};

/* Stiffness F_e(rho)/rho = k rho^(alpha-1) of a power law, as a vm_jeffcott_stiffness. power_force points to a
   vm_power_force. Returns the stiffness, N/m, and writes its derivative, N/m^2, to *slope. Returns NaN for null
   pointers, for rho < 0, and for an alpha that is negative or infinite. k may have any sign; the functions of the rotor
   check the stiffness. */
VM_API vm_real vm_jeffcott_power(vm_real rho, vm_real *slope, void *power_force)
{
    if (!slope || !power_force) return VM_NAN;
    const vm_power_force *p = (const vm_power_force *)power_force;
    *slope = VM_NAN;
    if (!(p->alpha >= 0) || !VM_IS_FINITE(p->alpha)) return VM_NAN;
    *slope = 0;
    if (p->alpha != 1) *slope = p->k * (p->alpha - 1) * vmi_pow_checked(rho, p->alpha - 2);
    return p->k * vmi_pow_checked(rho, p->alpha - 1);
}

/* Polar coordinates (448) of the disc's centre: deflection rho = |z| and angle phi in (-pi, pi]. rho is within 2 eps,
   phi within 4 eps. If a pointer is null, nothing is done. */
VM_API void vm_jeffcott_polar(vm_complex z, vm_real *rho, vm_real *phi)
{
    if (!rho || !phi) return;
    *rho = vmi_c_modulus(z);
    *phi = ateb_phase(z.im, z.re, 1);
}

/* Angular momentum of a rotor about its axis, with the gyroscopic share, kg m^2/s.
   It is m Im(conj(z) z') - g |z|^2, and stays constant where r = 1, u = 0 and F_z = 0. The argument v is z'. Returns
   NaN for a null pointer. */
VM_API vm_real vm_jeffcott_momentum(const vm_jeffcott *r, vm_real mass, vm_complex z, vm_complex v)
{
    if (!r) return VM_NAN;
    return mass * (z.re * v.im - z.im * v.re) - r->gyro * (z.re * z.re + z.im * z.im);
}

/* F_e(rho)/rho and its derivative; both are NaN where the rotor has no stiffness */
VM_API vm_real vmi_jeffcott_stiffness(const vm_jeffcott *r, vm_real rho, vm_real *slope)
{
    *slope = VM_NAN;
    if (!r->stiffness) return VM_NAN;
    return r->stiffness(rho, slope, r->stiffness_ctx);
}

/* The mass and its rate at time t. Returns VM_BAD_ARGUMENT where the rotor has no stiffness, else the status of the
   law. */
VM_API int vmi_jeffcott_mass_at(const vm_jeffcott *r, vm_real t, vm_real *mass, vm_real *rate)
{
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    return vmi_law_at(&r->mass, VM_BAD_MASS, t, mass, rate);
}

/* F_z + r m' u: the external force and the reactive force r m' (u - z') without its part that depends on z'. `rate` is
   m'. */
VM_API vm_complex vmi_jeffcott_drive(const vm_jeffcott *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    const vm_complex thrust = vmi_c_scale(r->reactive * rate, r->u);
    if (!r->force) return thrust;
    return vmi_c_add(r->force(t, z, v, r->force_ctx), thrust);
}

/* F_z + r m' u + 2 i g z': the load of vmi_jeffcott_drive and the gyroscopic force, where `rate` is m' and v is z' */
VM_API vm_complex vmi_jeffcott_loads(const vm_jeffcott *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    return vmi_c_add(vmi_jeffcott_drive(r, t, rate, z, v), vmi_c_times_i(vmi_gyroscopic_coupling(r->gyro), v));
}

/* Equation of motion (449), (450) of a rotor, for rk45 or rk87.
   y = (x, y, x', y') is in m and m/s; rotor points to a vm_jeffcott. Returns VM_BAD_ARGUMENT for null pointers and
   for a rotor without mass or stiffness, VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS for a mass
   that is not positive, and VM_DOMAIN for t outside a table of the mass. These statuses stop the run. */
VM_API int vm_jeffcott_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    const vm_complex z = vmi_complex(y[0], y[1]), v = vmi_complex(y[2], y[3]);
    vm_real mass, rate, stiffness, slope;
    vm_complex force;
    const int status = vmi_jeffcott_mass_at(r, t, &mass, &rate);
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope);
    force = vmi_jeffcott_loads(r, t, rate, z, v);
    dydt[0] = v.re;
    dydt[1] = v.im;
    dydt[2] = (force.re - r->reactive * rate * v.re - stiffness * z.re) / mass;
    dydt[3] = (force.im - r->reactive * rate * v.im - stiffness * z.im) / mass;
    return VM_OK;
}

/* -- Weak nonlinearity: forward and backward whirl together -- */

/* A rotor at one time: mass m, kg, its rate m', kg/s, and the frequency of small vibrations omega = sqrt(F_e'(0)/m),
   rad/s */
typedef struct VM_TAG(vmi_jeffcott_state) {
    vm_real mass, rate, omega;
} vmi_jeffcott_state;

/* Finds the rotor's mass and frequency at time t. Returns VM_BAD_STIFFNESS where small vibrations have no frequency,
   as for F_e = rho^3, VM_BAD_ARGUMENT for a rotor without mass or stiffness, VM_BAD_MASS for a mass that is not
   positive, and VM_NOT_FINITE for a number that is infinite or NaN. */
VM_API int vmi_jeffcott_now(const vm_jeffcott *r, vm_real t, vmi_jeffcott_state *now)
{
    vm_real stiffness, slope;
    const int status = vmi_jeffcott_mass_at(r, t, &now->mass, &now->rate);
    now->omega = VM_NAN;
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, 0, &slope);
    if (stiffness <= 0) return VM_BAD_STIFFNESS;
    now->omega = VM_SQRT(stiffness / now->mass);
    if (!VM_IS_FINITE(now->omega)) return VM_NOT_FINITE;
    if (!(now->omega > 0)) return VM_DOMAIN; /* the frequency underflows */
    return VM_OK;
}

/* Motion (x, y, x', y') of a rotor to forward and backward whirl, (456)-(461). The complex numbers P and N are
   circular motions, forward and backward, of the frequency omega = sqrt(F_e'(0)/m):
     z = P e^(i phi) + N e^(-i phi),  z' = i omega (P e^(i phi) - N e^(-i phi)),
     P = A1 e^(i theta1),  N = A2 e^(-i theta2) in the symbols of [1].
   phi is the fast phase at the start, for example 0. y receives (Re P, Im P, Re N, Im N, phi), the state of
   vm_jeffcott_exact_rhs and vm_jeffcott_averaged_rhs. Unlike theta1 and theta2, P and N have no singularity where A1
   or A2 is 0. Returns VM_BAD_ARGUMENT for null pointers and for a rotor without mass or stiffness, VM_NOT_FINITE for
   a number that is infinite or NaN, VM_BAD_MASS for a mass that is not positive, and VM_BAD_STIFFNESS where F_e'(0)
   is not positive. y and motion may be the same array. */
VM_API int vm_jeffcott_to_averaged(const vm_jeffcott *r, vm_real t, const vm_real *motion, vm_real phi, vm_real *y)
{
    if (!r || !motion || !y) return VM_BAD_ARGUMENT;
    const vm_complex z = vmi_complex(motion[0], motion[1]), back = vmi_c_turn(-phi);
    vmi_jeffcott_state now;
    vm_complex turned, P, N;
    vm_real found[VMI_JEFFCOTT_SIZE];
    int status = vmi_jeffcott_now(r, t, &now);
    if (!VM_IS_FINITE(phi) || !vmi_all_finite(4, motion)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    turned = vmi_c_times_i(-1 / now.omega, vmi_complex(motion[2], motion[3])); /* z'/(i omega) */
    P = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_add(z, turned)), back);
    N = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_sub(z, turned)), vmi_c_conjugate(back));
    found[VMI_JEFFCOTT_P] = P.re;
    found[VMI_JEFFCOTT_P + 1] = P.im;
    found[VMI_JEFFCOTT_N] = N.re;
    found[VMI_JEFFCOTT_N + 1] = N.im;
    found[VMI_JEFFCOTT_PHI] = phi;
    return vmi_copy_if_finite(VMI_JEFFCOTT_SIZE, found, y);
}

/* Writes the disc's position z and velocity v = z' from the whirls P and N in y, where turn = e^(i phi). */
VM_API void vmi_jeffcott_motion(const vm_real *y, vm_complex turn, vm_real omega, vm_complex *z, vm_complex *v)
{
    const vm_complex P = vmi_c_times(vmi_complex(y[VMI_JEFFCOTT_P], y[VMI_JEFFCOTT_P + 1]), turn);
    const vm_complex N = vmi_c_times(vmi_complex(y[VMI_JEFFCOTT_N], y[VMI_JEFFCOTT_N + 1]), vmi_c_conjugate(turn));
    *z = vmi_c_add(P, N);
    *v = vmi_c_times_i(omega, vmi_c_sub(P, N));
}

/* Motion (x, y, x', y') of a rotor from forward and backward whirl. The inverse of vm_jeffcott_to_averaged, with its
   statuses; y = (Re P, Im P, Re N, Im N, phi). motion and y may be the same array. */
VM_API int vm_jeffcott_from_averaged(const vm_jeffcott *r, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!r || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_jeffcott_state now;
    vm_complex z, v;
    vm_real joined[4];
    int status = vmi_jeffcott_now(r, t, &now);
    if (!vmi_all_finite(VMI_JEFFCOTT_SIZE, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    vmi_jeffcott_motion(y, vmi_c_turn(y[VMI_JEFFCOTT_PHI]), now.omega, &z, &v);
    joined[0] = z.re;
    joined[1] = z.im;
    joined[2] = v.re;
    joined[3] = v.im;
    return vmi_copy_if_finite(4, joined, motion);
}

/* Writes the exact rates P' and N' (470)-(473) of the whirls to *dP and *dN. At the fast phase phi the disc is at z = P
   e^(i phi) + N e^(-i phi), with the forward whirl P and the backward whirl N. The rates are
     P' = -i e^(-i phi) f/(2 omega),  N' = i e^(i phi) f/(2 omega),
     m f = F_z + r m' u + 2 i g z' - (F_e' - F_e'(0)) z - (r - 1/2) m' z'
   The last term has r - 1/2 in place of r, because the change of omega contributes m' z'/2. */
VM_API void vmi_jeffcott_rates(const vm_jeffcott *r, vm_real t, const vmi_jeffcott_state *now, const vm_real *y,
                               vm_real phi, vm_complex *dP, vm_complex *dN)
{
    const vm_complex turn = vmi_c_turn(phi);
    const vm_real push = 1 / (2 * now->omega * now->mass), drag = vmi_slow_drag(r->reactive, now->rate, 0) / 2;
    vm_real slope, extra;
    vm_complex z, v, f;
    vmi_jeffcott_motion(y, turn, now->omega, &z, &v);
    extra = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope) - now->mass * now->omega * now->omega;
    f = vmi_jeffcott_loads(r, t, now->rate, z, v);
    f = vmi_c_sub(f, vmi_c_add(vmi_c_scale(extra, z), vmi_c_scale(drag, v)));
    *dP = vmi_c_times_i(-push, vmi_c_times(f, vmi_c_conjugate(turn)));
    *dN = vmi_c_times_i(push, vmi_c_times(f, turn));
}

/* The number of phases, evenly spaced in a period, at which the loads are computed for a mean over the period */
VM_API int vmi_jeffcott_nodes(const vm_jeffcott *r)
{
    const int usual = 32; /* gives exact means of forces that are polynomials of degree <= 15 in z and z' */
    if (r->nodes > 0) return r->nodes;
    return usual;
}

/* Writes the means of P' and N' over `nodes` evenly spaced phases of a period, beginning with the phase in y. */
VM_API int vmi_jeffcott_mean(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int nodes)
{
    const vm_real share = 1 / (vm_real)nodes;
    vm_complex P = {0, 0}, N = {0, 0}, dP, dN;
    vmi_jeffcott_state now;
    const int status = vmi_jeffcott_now(r, t, &now);
    int j;
    if (status) return status;
    for (j = 0; j < nodes; j++) {
        vmi_jeffcott_rates(r, t, &now, y, y[VMI_JEFFCOTT_PHI] + 2 * VM_PI * share * (vm_real)j, &dP, &dN);
        P = vmi_c_add(P, dP);
        N = vmi_c_add(N, dN);
    }
    dydt[VMI_JEFFCOTT_P] = P.re * share;
    dydt[VMI_JEFFCOTT_P + 1] = P.im * share;
    dydt[VMI_JEFFCOTT_N] = N.re * share;
    dydt[VMI_JEFFCOTT_N + 1] = N.im * share;
    dydt[VMI_JEFFCOTT_PHI] = now.omega;
    return VM_OK;
}

/* Exact equations (470)-(473) of forward and backward whirl, for rk45 or rk87. y = (Re P, Im P, Re N, Im N, phi), see
   vm_jeffcott_to_averaged; rotor points to a vm_jeffcott. The equations hold for any force, but are of use only where
   the external force F_z, the velocity u of joining mass, the gyroscopic constant g and the change F_e'(rho) - F_e'(0)
   of the stiffness are small. Returns VM_BAD_ARGUMENT for null pointers and for a rotor without mass or stiffness,
   VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS for a mass that is not positive, and VM_BAD_STIFFNESS
   where F_e'(0) is not positive. */
VM_API int vm_jeffcott_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_mean(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Averaged equations of forward and backward whirl, for rk45 or rk87. They are those of vm_jeffcott_exact_rhs, averaged
   over the fast phase phi while P and N stay constant. The dissertation [1] averages over the angles psi1 and psi2 of
   the two whirls separately, (474)-(477). That is wrong unless the force turns with z, since forward and backward whirl
   are in 1:1 resonance. The error is of the order of the largest perturbation (F_z, u, g, F_e'(rho) - F_e'(0) or m'),
   up to times of its inverse. State and statuses are those of vm_jeffcott_exact_rhs. Each call evaluates the forces at
   `nodes` phases. */
VM_API int vm_jeffcott_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    if (r->nodes < 0) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_mean(t, y, dydt, r, vmi_jeffcott_nodes(r));
}

/* -- Strong nonlinearity: nearly circular whirl -- */

/* The frequency of circular whirl W = (g +- S)/m with S^2 = g^2 + m F_e', where + is for forward whirl (sense >= 0). g
   is gyro, m the mass, F_e' the stiffness. The code subtracts no nearly equal numbers. */
VM_API vm_real vmi_jeffcott_root(vm_real gyro, vm_real mass, vm_real stiffness, int sense)
{
    const vm_real S = VM_SQRT(gyro * gyro + mass * stiffness);
    vm_real direction = 1, g, speed;
    if (sense < 0) direction = -1;
    g = direction * gyro;
    if (g > 0) speed = (g + S) / mass;
    else speed = stiffness / (S - g);
    return direction * speed;
}

/* Frequency W of circular whirl of radius A, rad/s.
   By the corrected remark after (516), W solves m W^2 - 2 g W = F_e(A)/A. Forward whirl has W > 0; sense >= 0 asks
   for it. Backward whirl has W < 0; sense < 0 asks for it. A >= 0 is in m, mass > 0 in kg. The result is within 8 eps
   and the error of the stiffness. Returns NaN for null pointers, for a rotor without stiffness, and for arguments
   outside the domain. */
VM_API vm_real vm_jeffcott_frequency(const vm_jeffcott *r, vm_real A, vm_real mass, int sense)
{
    if (!r || !r->stiffness) return VM_NAN;
    vm_real slope;
    if (!(A >= 0) || !VM_IS_FINITE(A) || !(mass > 0) || !VM_IS_FINITE(mass)) return VM_NAN;
    return vmi_jeffcott_root(r->gyro, mass, vmi_jeffcott_stiffness(r, A, &slope), sense);
}

/* The mean load, N, on a disc that moves on a circle of radius A at the frequency W. The load D = F_z + r m' u is taken
   as D e^(-i angle), where `angle` is the disc's place on the circle, and averaged over one turn that begins at the
   angle psi. The real part is the mean radial load, the imaginary part the mean tangential load. `rate` is m'. */
VM_API vm_complex vmi_jeffcott_mean_load(const vm_jeffcott *r, vm_real t, vm_real rate, vm_real A, vm_real psi,
                                         vm_real W)
{
    const int nodes = vmi_jeffcott_nodes(r);
    vm_complex sum = {0, 0};
    int j;
    for (j = 0; j < nodes; j++) {
        const vm_complex turn = vmi_c_turn(psi + 2 * VM_PI * (vm_real)j / (vm_real)nodes);
        const vm_complex z = vmi_c_scale(A, turn);
        const vm_complex D = vmi_jeffcott_drive(r, t, rate, z, vmi_c_times_i(W, z));
        sum = vmi_c_add(sum, vmi_c_times(D, vmi_c_conjugate(turn)));
    }
    return vmi_c_scale(1 / (vm_real)nodes, sum);
}

/* Writes the averaged rates (504), (505) of the state y = (A, psi), the radius and the angle of a circular whirl. W is
   the whirl's frequency, L the result of vmi_jeffcott_mean_load, and S = m W - g = +-sqrt(g^2 + m F_e'), where + is for
   forward whirl. The equations are
     along the circle: (A^2 S)' = (1 - r) m' A^2 W + A Im L,
     across the circle: psi' = W - Re L/(2 A S) */
VM_API int vmi_jeffcott_circular(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int sense)
{
    vm_real mass, rate, stiffness, slope, W, S, growth;
    vm_complex load;
    int status = vmi_jeffcott_mass_at(r, t, &mass, &rate);
    if (r->nodes < 0) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(r->gyro) || y[0] != y[0]) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, y[0], &slope);
    W = vmi_jeffcott_root(r->gyro, mass, stiffness, sense);
    S = mass * W - r->gyro;
    if (S != S && !VM_IS_FINITE(stiffness)) return VM_NOT_FINITE;
    if (!(S * S > 0)) return VM_BAD_STIFFNESS;
    load = vmi_jeffcott_mean_load(r, t, rate, y[0], y[1], W);
    growth = ((1 - r->reactive) * rate * W + load.im / y[0]) / S - rate * stiffness / (2 * S * S);
    dydt[0] = y[0] * growth / (2 + mass * slope * y[0] / (2 * S * S));
    dydt[1] = W - load.re / (2 * y[0] * S);
    return VM_OK;
}

/* Averaged equations (506), (507) of forward whirl, for rk45 or rk87.
   The nonlinearity may be strong. The motion is nearly circular: z = A e^(i psi), z' = i W z with the frequency W of
   vm_jeffcott_frequency. y = (A, psi) is in m and rad; rotor points to a vm_jeffcott. The error of A is of the order of
   the largest load (by the force F_z, the velocity u or the mass rate m'), up to times of its inverse. Where F_e' is
   not constant, the phase accumulates this error: up to these times tests bound the error of psi by 0.015 for loads
   that turn with z (their angle to z is fixed), but for other loads it is of order 1. The equations do not hold for a
   linear F_e with loads that do not turn with z, since these drive the motion off the circle. Returns VM_BAD_ARGUMENT
   for null pointers and for a rotor without mass or stiffness, VM_NOT_FINITE for a number that is infinite or NaN,
   VM_BAD_MASS for a mass that is not positive, and VM_BAD_STIFFNESS if g^2 + m F_e' is not positive. Each call
   evaluates the force at `nodes` phases. */
VM_API int vm_jeffcott_forward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Averaged equations (506), (507) of backward whirl, for rk45 or rk87. State, error and statuses are as in
   vm_jeffcott_forward_whirl_rhs, except that the whirl's frequency W is negative. */
VM_API int vm_jeffcott_backward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, -1);
}

/* The search for the radius A of circular whirl after a change of the mass. A^4 (g^2 + m F_e'(A)) is an invariant: it
   keeps its value during the change. */
typedef struct VM_TAG(vmi_jeffcott_orbit) {
    const vm_jeffcott *r;
    vm_real first_A; /* radius A before the change, m */
    vm_real mass;    /* mass after the change, kg */
    vm_real first;   /* the factor g^2 + m F_e'(A) of the invariant before the change */
} vmi_jeffcott_orbit;

/* ln of the invariant over its value before the change, at the radius first_A e^x; NaN where F_e' is not a number or
   so negative that the invariant is not positive */
VM_API vm_real vmi_jeffcott_invariant(vm_real x, void *orbit)
{
    const vmi_jeffcott_orbit *o = (const vmi_jeffcott_orbit *)orbit;
    vm_real slope;
    const vm_real stiffness = vmi_jeffcott_stiffness(o->r, o->first_A * vmi_exp(x, 0), &slope);
    const vm_real ratio = (o->r->gyro * o->r->gyro + o->mass * stiffness) / o->first;
    if (!(ratio > 0) || !VM_IS_FINITE(ratio)) return VM_NAN;
    return 4 * x + vmi_log(ratio).hi;
}

/* An interval [a, b] of x = ln(A/first_A), with the values of vmi_jeffcott_invariant at its ends, which have opposite
   signs */
typedef struct VM_TAG(vmi_jeffcott_bracket) {
    vm_real a, b, at_a, at_b;
} vmi_jeffcott_bracket;

/* Searches from x = 0, where vmi_jeffcott_invariant is b->at_a, until the sign of this function changes, with steps
   that double. A step to an x where the function is NaN is halved, and from then on steps no longer double. Returns 1
   where a change of sign is found, and 0 where halved steps still lead to NaN. */
VM_API int vmi_jeffcott_find_bracket(vmi_jeffcott_orbit *o, vmi_jeffcott_bracket *b)
{
    vm_real step = VM_C(0.0625); /* changes the radius by 6 % */
    int bounded = 0;
    if (b->at_a > 0) step = -step;
    b->a = 0;
    for (;;) {
        b->b = b->a + step;
        b->at_b = vmi_jeffcott_invariant(b->b, o);
        while (b->at_b != b->at_b) {
            step /= 2;
            bounded = 1;
            if (VM_FABS(step) < VM_EPSILON * (1 + VM_FABS(b->a))) return 0;
            b->b = b->a + step;
            b->at_b = vmi_jeffcott_invariant(b->b, o);
        }
        if (b->at_b == 0 || (b->at_b > 0) != (b->at_a > 0)) return 1;
        b->a = b->b;
        b->at_a = b->at_b;
        if (!bounded) step *= 2;
    }
}

/* Radius of circular whirl, m, after the mass has changed slowly.
   The radius was first_A when the mass was mass0; `mass` is the mass after the change. F_z and u must be 0. These
   products stay constant (509):
     A^4 (g^2 + m F_e'(A)) for r = 1, which is the square of A^2 (m W - g);   A^4 F_e'(A) m^(2r-1) for g = 0.
   For F_e = k rho^alpha and g = 0 the radius changes by vm_osc_amplitude_law, with mass/mass0 and decay 0; its relative
   error is then at most 3e-15 (float 3e-6). Returns NaN for g != 0 with r != 1, since the radius then depends on all
   masses in between; where no radius is found on the way from first_A; for null pointers, for a rotor without
   stiffness, and for a radius or masses that are not positive and finite. */
VM_API vm_real vm_jeffcott_amplitude(const vm_jeffcott *r, vm_real first_A, vm_real mass0, vm_real mass)
{
    if (!r || !r->stiffness) return VM_NAN;
    vmi_jeffcott_orbit o;
    vmi_jeffcott_bracket b;
    vm_real slope, first_mass = mass0;
    if (!(first_A > 0) || !(mass0 > 0) || !(mass > 0) || !VM_IS_FINITE(first_A) || !VM_IS_FINITE(mass0) ||
        !VM_IS_FINITE(mass) || (r->gyro != 0 && r->reactive != 1))
        return VM_NAN;
    o.r = r;
    o.first_A = first_A;
    o.mass = mass;
    if (r->gyro == 0) { /* for g = 0 the invariant has m^(2r-1) in place of m (509) */
        o.mass = vmi_pow_checked(mass / mass0, 2 * r->reactive - 1);
        first_mass = 1;
    }
    o.first = r->gyro * r->gyro + first_mass * vmi_jeffcott_stiffness(r, first_A, &slope);
    b.at_a = vmi_jeffcott_invariant(0, &o);
    if (b.at_a == 0) return first_A;
    if (b.at_a != b.at_a || !vmi_jeffcott_find_bracket(&o, &b)) return VM_NAN;
    return first_A * vmi_exp(vmi_find_zero(vmi_jeffcott_invariant, &o, b.a, b.b, b.at_a, b.at_b), 0);
}

#endif
/* oscillators/pair.h - two bodies with a nonlinear connection

   Two bodies of equal mass m(t), with coordinates x and y on a line and a spring between them (517), (518):
       m x'' = -k (x - y)|x - y|^(alpha-1) - r m' x',   m y'' = k (x - y)|x - y|^(alpha-1) - r m' y'
   r is the share of the reactive force (`reactive`). The sum q = x + y drifts, and the difference p = y - x vibrates
   with the amplitude A and the Ateb phase psi, whose rate is Om, (520)-(522). Here are the equations of motion, the
   averaged equations of both modes, and the motion in closed form for a linear mass (528), (529).

       vm_real y[4] = {1, 3, 0, 0}; // x, y, x', y'
       vm_pair p;
       p.alpha = 3;
       p.k = 1; // cubic spring of 1 N/m^3
       p.reactive = 1;
       p.mass = vm_law_linear(1, VM_C(0.01)); // 1 kg, and 0.01 kg/s joins at rest
       int status = vm_pair_at(&p, 50, y, y); // the motion at t = 50 s

   Tests: tests/test_pair.c. */
#ifndef VARMASS_OSCILLATORS_PAIR_H
#define VARMASS_OSCILLATORS_PAIR_H

/* Two bodies of equal mass and the spring between them */
typedef struct VM_TAG(vm_pair) {
    vm_real alpha;    /* exponent of the spring, >= 0 */
    vm_real k;        /* stiffness, N/m^alpha, > 0 */
    vm_real reactive; /* r: 1 where mass that joins or leaves is at rest, 0 where it has the body's velocity */
    vm_law mass;      /* mass m of each body, kg, > 0; it must vary slowly */
} vm_pair;

/* Indices of the modes: mean amplitude A of p = y - x, m; Ateb phase psi of p; sum q = x + y, m; rate q', m/s */
enum {
    VMI_PAIR_A = 0,
    VMI_PAIR_PSI = 1,
    VMI_PAIR_SUM = 2,
    VMI_PAIR_SUM_RATE = 3,
    VMI_PAIR_MODES = 4
};

/* Writes the mass and its rate at time t, and checks them, the pair and the four numbers of a state. Right-hand
   sides pass NULL for the state: where a trial step of an integrator overflows, the integrator repeats the step. */
VM_API int vmi_pair_now(const vm_pair *p, vm_real t, const vm_real *state_or_NULL, vm_real *mass, vm_real *rate)
{
    const vm_real numbers[3] = {p->alpha, p->k, p->reactive};
    int status = vmi_law_at(&p->mass, VM_BAD_MASS, t, mass, rate);
    if (!vmi_all_finite(3, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (state_or_NULL && !vmi_all_finite(4, state_or_NULL)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (p->k <= 0) status = vmi_first_error(status, VM_BAD_STIFFNESS);
    if (p->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    return status;
}

/* Equations of motion (517), (518) of two bodies, for rk45 or rk87.
   y = (x, y, x', y') is in m and m/s; pair points to a vm_pair. Returns VM_BAD_ARGUMENT for null pointers or where no
   constructor made the mass, VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS for
   one that is not positive, and VM_DOMAIN for alpha < 0 or t outside a table. These statuses stop the run. */
VM_API int vm_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    vm_real mass, rate, force;
    const int status = vmi_pair_now(p, t, NULL, &mass, &rate);
    if (status) return status;
    force = p->k * vmi_osc_elastic(y[0] - y[1], p->alpha);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (-force - p->reactive * rate * y[2]) / mass;
    dydt[3] = (force - p->reactive * rate * y[3]) / mass;
    return VM_OK;
}

/* The amplitude of y - x at the Ateb phase psi, divided by its mean A: (1 + s sa ca/(2 Om))^(2/(alpha+3)) with the rate
   Om of psi and s = (2r - 1) m'/m. The spring acts on both bodies, so that y - x vibrates with the stiffness 2 k. */
VM_API vm_real vmi_pair_ripple(const vm_pair *p, vm_real mass, vm_real rate, vm_real A, vm_real psi)
{
    const vm_real q = vmi_slow_q(vmi_slow_drag(p->reactive, rate, 0), mass, p->k, 0);
    const vm_real Om = vmi_slow_rate(A, 2 * p->k, mass, p->alpha);
    vm_real sa, ca;
    ateb_saca(psi, p->alpha, &sa, &ca);
    return vmi_pow_checked(1 + q / (2 * Om) * sa * ca, 2 / (p->alpha + 3));
}

/* Computes the modes from the motion y. The mean amplitude A solves exact = A ripple(A), where `exact` is the amplitude
   at this instant and ripple is vmi_pair_ripple. Three iterations are enough where the ripple is small. Returns
   VM_DOMAIN where they are not, because the ripple is as large as the motion. */
VM_API int vmi_pair_split(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *y, vm_real *modes)
{
    vm_real exact, A, psi, found[VMI_PAIR_MODES];
    int i;
    vmi_slow_phase(y[1] - y[0], y[3] - y[2], 2 * p->k, mass, p->alpha, &exact, &psi);
    A = exact;
    for (i = 0; i < 3 && exact > 0; i++) A = exact / vmi_pair_ripple(p, mass, rate, A, psi);
    if (exact > 0 && !(VM_FABS(A * vmi_pair_ripple(p, mass, rate, A, psi) - exact) <= exact / 8)) return VM_DOMAIN;
    if (!(A >= 0) || !VM_IS_FINITE(A)) return VM_DOMAIN;
    found[VMI_PAIR_A] = A;
    found[VMI_PAIR_PSI] = psi;
    found[VMI_PAIR_SUM] = y[0] + y[1];
    found[VMI_PAIR_SUM_RATE] = y[2] + y[3];
    return vmi_copy_if_finite(VMI_PAIR_MODES, found, modes);
}

/* Computes the motion y from the modes, the inverse of vmi_pair_split. */
VM_API int vmi_pair_join(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *modes, vm_real *y)
{
    const vm_real sum = modes[VMI_PAIR_SUM], sum_rate = modes[VMI_PAIR_SUM_RATE];
    vm_real A = modes[VMI_PAIR_A], x, v, joined[4];
    if (!vmi_all_finite(VMI_PAIR_MODES, modes)) return VM_NOT_FINITE; /* a closed form may overflow */
    if (A > 0) A *= vmi_pair_ripple(p, mass, rate, A, modes[VMI_PAIR_PSI]);
    if (!(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, modes[VMI_PAIR_PSI], 2 * p->k, mass, p->alpha, &x, &v);
    joined[0] = (sum - x) / 2;
    joined[1] = (sum + x) / 2;
    joined[2] = (sum_rate - v) / 2;
    joined[3] = (sum_rate + v) / 2;
    return vmi_copy_if_finite(4, joined, y);
}

/* Motion y = (x, y, x', y') of two bodies to modes (A, psi, q, q'), (520)-(522).
   q = x + y drifts; p = y - x vibrates with the mean amplitude A, m, and the Ateb phase psi. The ripple of the
   amplitude within a period is taken out of A, so that any initial velocities are allowed. Returns VM_BAD_ARGUMENT
   for null pointers or where no constructor made the mass, VM_NOT_FINITE for a number that is infinite or NaN,
   VM_BAD_MASS or VM_BAD_STIFFNESS for one that is not positive, and VM_DOMAIN for alpha < 0 and where the ripple is
   as large as the motion, so that |(2r - 1) m'/m| is about twice the rate of psi, for example where m tends to 0. modes
   and y may be the same array. */
VM_API int vm_pair_to_averaged(const vm_pair *p, vm_real t, const vm_real *y, vm_real *modes)
{
    if (!p || !y || !modes) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    const int status = vmi_pair_now(p, t, y, &mass, &rate);
    if (status) return status;
    return vmi_pair_split(p, mass, rate, y, modes);
}

/* Motion y = (x, y, x', y') of two bodies from modes (A, psi, q, q').
   The inverse of vm_pair_to_averaged, with its statuses. y and modes may be the same array. */
VM_API int vm_pair_from_averaged(const vm_pair *p, vm_real t, const vm_real *modes, vm_real *y)
{
    if (!p || !modes || !y) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    const int status = vmi_pair_now(p, t, modes, &mass, &rate);
    if (status) return status;
    return vmi_pair_join(p, mass, rate, modes, y);
}

/* Averaged equations of the two modes of a pair, for rk45 or rk87.
   The mass may follow any slow law. modes = (A, psi, q, q'), see vm_pair_to_averaged; pair points to a vm_pair. The
   error is of the order of m'/(m Om) up to the time m/m', where Om is the rate of psi. The statuses are those of
   vm_pair_rhs. */
VM_API int vm_pair_averaged_rhs(vm_real t, const vm_real *modes, vm_real *dmodes, void *pair)
{
    if (!modes || !dmodes || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    vm_real mass, rate;
    const int status = vmi_pair_now(p, t, NULL, &mass, &rate);
    if (status) return status;
    dmodes[VMI_PAIR_A] = -vmi_slow_drag(p->reactive, rate, 0) / ((p->alpha + 3) * mass) * modes[VMI_PAIR_A];
    dmodes[VMI_PAIR_PSI] = vmi_slow_rate(modes[VMI_PAIR_A], 2 * p->k, mass, p->alpha);
    dmodes[VMI_PAIR_SUM] = modes[VMI_PAIR_SUM_RATE];
    dmodes[VMI_PAIR_SUM_RATE] = -p->reactive * rate / mass * modes[VMI_PAIR_SUM_RATE];
    return VM_OK;
}

/* Motion of two bodies at time t, in closed form for a linear mass: (528), (529) with p0 = y(0) - x(0). y0 = (x, y, x',
   y') is the motion at t = 0. The error is of the order of m'/(m Om) up to the time m/m', where Om is the rate of the
   Ateb phase of y - x. Returns the statuses of vm_pair_to_averaged, at 0 and at t, and VM_NO_LAW where the mass is
   neither linear nor constant (integrate vm_pair_averaged_rhs instead). y and y0 may be the same array. Method: the
   averaged equations contain powers of m/m0; the integral of (m/m0)^e dt is m0 (exp(u) - 1)/u times the integral of
   dt/m, with u = (1 + e) ln(m/m0). */
VM_API int vm_pair_at(const vm_pair *p, vm_real t, const vm_real *y0, vm_real *y)
{
    if (!p || !y0 || !y) return VM_BAD_ARGUMENT;
    const vm_real fall = (2 * p->reactive - 1) / (p->alpha + 3); /* A is proportional to (m/m0)^-fall */
    vmi_linear_mass m;
    vm_real modes[VMI_PAIR_MODES], rate0, exponent;
    int status = vmi_pair_now(p, 0, y0, &m.m0, &m.rate);
    if (status != VM_BAD_ARGUMENT && !VM_IS_FINITE(t)) status = VM_NOT_FINITE;
    if (!status) status = vmi_linear_mass_of(&p->mass, t, &m);
    if (!status) status = vmi_pair_split(p, m.m0, m.rate, y0, modes);
    if (status) return status;
    rate0 = vmi_slow_rate(modes[VMI_PAIR_A], 2 * p->k, m.m0, p->alpha);
    exponent = VM_C(0.5) - (p->alpha - 1) / 2 * fall;
    modes[VMI_PAIR_PSI] += rate0 * m.m0 * m.integral * vmi_exp_ratio(exponent * m.ln_ratio);
    modes[VMI_PAIR_A] *= vmi_exp(-fall * m.ln_ratio, 0);
    modes[VMI_PAIR_SUM] +=
        modes[VMI_PAIR_SUM_RATE] * m.m0 * m.integral * vmi_exp_ratio((1 - p->reactive) * m.ln_ratio);
    modes[VMI_PAIR_SUM_RATE] *= vmi_exp(-p->reactive * m.ln_ratio, 0);
    return vmi_pair_join(p, m.m, m.rate, modes, y);
}

#endif
/* oscillators/forced.h - harmonic excitation of a strongly nonlinear oscillator

   Chapter 8 of the dissertation leaves this problem to the future. Mass m, stiffness k, and the frequency nu and
   amplitude F of the force may vary slowly; b is the damping, r the share of the reactive force (`reactive`):
       m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + F cos(theta),   theta' = nu
   Here are the equation of motion, the exact equations of amplitude and phase, and the averaged ones near the main
   resonance. Steady vibrations, resonance curves and the passage through the resonance are in resonance.h.

       vm_forced f;
       memset(&f, 0, sizeof f);
       f.alpha = 3;
       f.damping = VM_C(0.02);
       f.mass = f.stiffness = f.frequency = vm_law_linear(1, 0);
       f.force = vm_law_linear(VM_C(0.1), 0);
       int status = vm_forced_init(&f); // then vm_forced_rhs integrates x, x', theta

   Symbols: A amplitude, psi Ateb phase, Om its rate, Pi half its period; w(A) frequency of the free vibration of
   amplitude A, phi = pi psi/Pi phase of the vibration in radians, theta phase of the force, delta = phi - theta.
   Tests: tests/test_forced.c. */
#ifndef VARMASS_OSCILLATORS_FORCED_H
#define VARMASS_OSCILLATORS_FORCED_H

/* Number of harmonics of the Ateb functions ca and sa, of the orders 1, 3, 5, 7 and 9 */
enum { VMI_FORCED_HARMONICS = 5 };

/* An oscillator under harmonic excitation. Fill the fields above pi, then call vm_forced_init; call it again after a
   change of alpha. The other fields may change without a new call. Constructors make the laws; vm_law_linear(value,
   0) is a constant. */
typedef struct VM_TAG(vm_forced) {
    vm_real alpha;     /* exponent of the spring, >= 0 */
    vm_real damping;   /* damping b, kg/s; a positive b takes energy out */
    vm_real reactive;  /* r: 1 where mass that joins or leaves is at rest, 0 where it has the body's velocity */
    vm_law mass;       /* mass m, kg, > 0 */
    vm_law stiffness;  /* stiffness k, N/m^alpha, > 0 */
    vm_law frequency;  /* frequency nu of the force, rad/s, > 0 */
    vm_law force;      /* amplitude F of the force, N, of either sign */
    vm_real pi;        /* Pi_alpha; vm_forced_init writes this field and those below */
    vm_real Om1;       /* the constant of the natural frequency w(A) = Om1 sqrt(k/m) A^((alpha-1)/2) */
    vm_real G;         /* the factor Om1^2 c[0]/2 of F/m in the averaged equations */
    /* Fourier coefficients: ca is the sum of c[j] cos((2j+1) phi), sa the sum of s[j] sin((2j+1) phi). */
    vm_real c[VMI_FORCED_HARMONICS], s[VMI_FORCED_HARMONICS];
} vm_forced;

/* The parameters that may vary, at one time; rates are per second */
typedef struct VM_TAG(vmi_forced_parameters) {
    vm_real mass, mass_rate; /* mass, kg, and its rate */
    vm_real k, k_rate;       /* stiffness, N/m^alpha, and its rate */
    vm_real nu, nu_rate;     /* frequency of the force, rad/s, and its rate */
    vm_real force;           /* amplitude of the force, N */
} vmi_forced_parameters;

/* Writes the parameters at time t, and checks them and the fields that do not vary. Of several errors it returns the
   first in the order of base/status.h. */
VM_API int vmi_forced_at(const vm_forced *f, vm_real t, vmi_forced_parameters *n)
{
    const vm_real numbers[3] = {f->alpha, f->damping, f->reactive};
    vm_real force_rate;
    int status = vmi_law_at(&f->mass, VM_BAD_MASS, t, &n->mass, &n->mass_rate);
    status = vmi_first_error(status, vmi_law_at(&f->stiffness, VM_BAD_STIFFNESS, t, &n->k, &n->k_rate));
    status = vmi_first_error(status, vmi_law_at(&f->frequency, VM_DOMAIN, t, &n->nu, &n->nu_rate));
    status = vmi_first_error(status, vmi_law_at(&f->force, VM_OK, t, &n->force, &force_rate));
    if (!vmi_all_finite(3, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (f->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    return status;
}

/* Computes the Fourier coefficients of ca, within 8 eps, and from them those of sa. The coefficients of ca are
     c_j = 2 int_0^1 ca(Pi u/2) cos((2j+1) pi u/2) du,
   computed by the tanh-sinh rule u = 1/(1 + e^(-pi sinh t)), because ca is not analytic at u = 1 and, for large
   alpha, bends sharply at u = 0. With x = pi u/2 the cosines follow from cos((2j+3) x) = 2 cos(2x) cos((2j+1) x) -
   cos((2j-1) x). */
VM_API void vmi_forced_fourier(vm_forced *f)
{
    const int steps = VM_MANT_DIG > 24 ? 16 : 8; /* number of points of the rule in an interval of t of length 1 */
    const int n = 13 * steps / 4;                /* |t| is at most 3.25; the rest of the integral is below eps */
    vm_real sum[VMI_FORCED_HARMONICS] = {0, 0, 0, 0, 0}, total = 0;
    int i, j;
    for (i = -n; i <= n; i++) {
        const vm_real t = (vm_real)i / (vm_real)steps, e = vmi_exp(t, 0), half_pi = VM_PI / 2;
        const vm_real g = vmi_exp(-half_pi * (e - 1 / e), 0), u = 1 / (1 + g);
        const vm_real weight = half_pi * (e + 1 / e) * u * (g * u);
        vm_real sa, ca, sine, cosine, before, twice;
        ateb_saca(f->pi / 2 * u, f->alpha, &sa, &ca);
        vmi_sincos(half_pi * u, &sine, &cosine);
        before = cosine;
        twice = 2 * (cosine - sine) * (cosine + sine);
        total += weight;
        for (j = 0; j < VMI_FORCED_HARMONICS; j++) {
            const vm_real next = twice * cosine - before;
            sum[j] += weight * ca * cosine;
            before = cosine;
            cosine = next;
        }
    }
    for (j = 0; j < VMI_FORCED_HARMONICS; j++) {
        f->c[j] = 2 * sum[j] / total;
        f->s[j] = (f->alpha + 1) * (vm_real)(2 * j + 1) * VM_PI / (2 * f->pi) * f->c[j];
    }
}

/* Prepare an excited oscillator: check its fields at t = 0, and write pi, Om1, G, c and s. All other functions need
   this call. Returns VM_BAD_ARGUMENT for a null pointer or a law that no constructor made, VM_NOT_FINITE for a number
   that is infinite or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS for one that is not positive, VM_DOMAIN for alpha < 0 or a
   frequency that is not positive, and VM_OK otherwise. An error leaves f as it was. */
VM_API int vm_forced_init(vm_forced *f)
{
    vmi_forced_parameters now;
    int status;
    if (!f) return VM_BAD_ARGUMENT;
    status = vmi_forced_at(f, 0, &now);
    if (status) return status;
    f->pi = ateb_pi(f->alpha);
    f->Om1 = VM_PI / f->pi * VM_SQRT((f->alpha + 1) / 2);
    vmi_forced_fourier(f);
    f->G = f->Om1 * f->Om1 / 2 * f->c[0];
    return VM_OK;
}

/* q = ((2r - 1) m' + 2 b)/m + k'/k, 1/s: the rate at which mass, damping and stiffness change the vibration */
VM_API vm_real vmi_forced_q(const vm_forced *f, const vmi_forced_parameters *n)
{
    return vmi_slow_q(vmi_slow_drag(f->reactive, n->mass_rate, f->damping), n->mass, n->k, n->k_rate);
}

/* The natural frequency w(A), rad/s: the frequency of the free vibration of amplitude A */
VM_API vm_real vmi_forced_natural(const vm_forced *f, const vmi_forced_parameters *n, vm_real A)
{
    return f->Om1 * VM_SQRT(n->k / n->mass) * vmi_pow_checked(VM_FABS(A), (f->alpha - 1) / 2);
}

/* Equation of motion of an excited oscillator, for rk45 or rk87.
   y = (x, x', theta) is in m, m/s and rad; forced points to a prepared vm_forced. Returns VM_BAD_ARGUMENT for a null
   pointer or a law that no constructor made, VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS or
   VM_BAD_STIFFNESS for one that is not positive, and VM_DOMAIN for alpha < 0, a frequency that is not positive or t
   outside a table. These statuses stop the run. */
VM_API int vm_forced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    vmi_forced_parameters n;
    vm_real sine, cosine;
    const int status = vmi_forced_at(f, t, &n);
    if (status) return status;
    vmi_sincos(y[2], &sine, &cosine);
    dydt[0] = y[1];
    dydt[1] = (n.force * cosine - (f->reactive * n.mass_rate + f->damping) * y[1] -
               n.k * vmi_osc_elastic(y[0], f->alpha)) /
              n.mass;
    dydt[2] = n.nu;
    return VM_OK;
}

/* Exact equations of amplitude and phase of an excited oscillator, for rk45 or rk87.
   The state is y = (A, psi, theta): the amplitude A and the Ateb phase psi of x = A ca(psi), and the phase theta of the
   force. The equations neglect nothing, but are singular at A = 0. The argument forced and the statuses are those of
   vm_forced_rhs. */
VM_API int vm_forced_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vm_real q, Om, push, sa, ca, sine, cosine;
    if (status) return status;
    q = vmi_forced_q(f, &n);
    Om = vmi_slow_rate(y[0], n.k, n.mass, f->alpha);
    ateb_saca(y[1], f->alpha, &sa, &ca);
    vmi_sincos(y[2], &sine, &cosine);
    push = n.force / (n.mass * Om) * cosine;
    dydt[0] = -(q * y[0] / (f->alpha + 1) * sa + push) * sa;
    dydt[1] = Om - (q / 2 * sa + (f->alpha + 1) / (2 * y[0]) * push) * ca;
    dydt[2] = n.nu;
    return VM_OK;
}

/* Averaged equations of an excited oscillator near its main resonance, for rk45 or rk87.
   At the main resonance the frequency nu of the force is the natural frequency w(A). The state is y = (A, delta,
   theta): A is the mean amplitude, theta the phase of the force, and delta the phase by which the vibration leads the
   force. Start with vm_forced_to_averaged, and end with vm_forced_from_averaged. The error is of the order of the
   largest of the damping b, the mass rate m' and the force F, up to times of its inverse, and larger away from the
   resonance. The argument forced and the statuses are those of vm_forced_rhs. */
VM_API int vm_forced_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vm_real w, push, sine, cosine;
    if (status) return status;
    w = vmi_forced_natural(f, &n, y[0]);
    push = n.force * f->G / (n.mass * w);
    vmi_sincos(y[1], &sine, &cosine);
    dydt[0] = -vmi_forced_q(f, &n) * y[0] / (f->alpha + 3) - push * sine;
    dydt[1] = w - n.nu - push / y[0] * cosine;
    dydt[2] = n.nu;
    return VM_OK;
}

/* The ripple of the exact amplitude about its mean A, m, to first order: exact amplitude = A + ripple. It is
     q A sa ca/((alpha+3) Om) + F/(m Om nu) sum of s_j/2 (cos(n phi + theta)/(n + 1) + cos(n phi - theta)/(n - 1))
   with the order n = 2j + 1 and q of vmi_forced_q. For n = 1 the last term is left out, since it does not vary at the
   resonance. */
VM_API vm_real vmi_forced_ripple(const vm_forced *f, const vmi_forced_parameters *n, vm_real A, vm_real phi,
                                 vm_real theta)
{
    const vm_real Om = vmi_slow_rate(A, n->k, n->mass, f->alpha);
    vm_real sa, ca, sum = 0, unused, plus, minus;
    int j;
    ateb_saca(phi * (f->pi / VM_PI), f->alpha, &sa, &ca);
    for (j = 0; j < VMI_FORCED_HARMONICS; j++) {
        const vm_real order = (vm_real)(2 * j + 1);
        vm_real second = 0;
        vmi_sincos(order * phi + theta, &unused, &plus);
        vmi_sincos(order * phi - theta, &unused, &minus);
        if (j > 0) second = minus / (order - 1);
        sum += f->s[j] / 2 * (plus / (order + 1) + second);
    }
    return vmi_forced_q(f, n) * A / ((f->alpha + 3) * Om) * sa * ca + n->force / (n->mass * Om * n->nu) * sum;
}

/* Motion (x, x', theta) of an excited oscillator to the mean y = (A, delta, theta).
   A is the amplitude without its ripple within a period. If the ripple stayed in A, averaged motions would have errors
   of order 1 where alpha is not 1. The statuses are those of vm_forced_rhs; VM_DOMAIN also means that the motion is
   smaller than its ripple. y and motion may be the same array. */
VM_API int vm_forced_to_averaged(const vm_forced *f, vm_real t, const vm_real *motion, vm_real *y)
{
    if (!f || !motion || !y) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int status = vmi_forced_at(f, t, &n);
    const vm_real theta = motion[2];
    vm_real exact, A, phi;
    int i;
    if (!vmi_all_finite(3, motion)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    vmi_slow_phase(motion[0], motion[1], n.k, n.mass, f->alpha, &exact, &phi);
    phi *= VM_PI / f->pi;
    A = exact;
    for (i = 0; i < 3; i++) A = exact - vmi_forced_ripple(f, &n, A, phi, theta);
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_DOMAIN; /* then the motion is smaller than its ripple */
    y[0] = A;
    y[1] = phi - theta;
    y[2] = theta;
    return VM_OK;
}

/* Motion (x, x', theta) of an excited oscillator from the mean y = (A, delta, theta).
   The inverse of vm_forced_to_averaged: it puts the ripple back. The statuses are those of vm_forced_rhs; VM_DOMAIN
   also means that A <= 0 or that A is smaller than its ripple. motion and y may be the same array. */
VM_API int vm_forced_from_averaged(const vm_forced *f, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!f || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int status = vmi_forced_at(f, t, &n);
    const vm_real theta = y[2], phi = y[1] + theta;
    vm_real A, r[3];
    if (!vmi_all_finite(3, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    A = y[0] + vmi_forced_ripple(f, &n, y[0], phi, theta);
    if (!(y[0] > 0) || !(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, phi * (f->pi / VM_PI), n.k, n.mass, f->alpha, &r[0], &r[1]);
    r[2] = theta;
    return vmi_copy_if_finite(3, r, motion);
}

#endif
/* oscillators/resonance.h - steady vibrations, resonance curves, passage through resonance

   For an oscillator under harmonic excitation (forced.h, which explains the symbols), this file computes all steady
   vibrations and their stability, the amplitude-frequency curve and its peak, and whether a slow change of frequency,
   mass or stiffness lets the vibration pass through the resonance or captures it. The results follow from the averaged
   equations, so that they hold near the main resonance, where the natural frequency w(A) is the frequency nu of the
   force. Mass, stiffness, frequency, force and their rates are those at one time t.

       vm_steady_state steady[3];
       int n = vm_forced_steady_states(&forced, 0, steady); // forced is a vm_forced after vm_forced_init

   Tests: tests/test_forced.c. */
#ifndef VARMASS_OSCILLATORS_RESONANCE_H
#define VARMASS_OSCILLATORS_RESONANCE_H

/* A steady vibration: a solution of the averaged equations with A' = delta' = 0 */
typedef struct VM_TAG(vm_steady_state) {
    vm_real nu;         /* frequency of the force, rad/s */
    vm_real A;          /* mean amplitude, m; vm_forced_from_averaged gives the motion with its ripple */
    vm_real delta;      /* phase by which the vibration leads the force, rad, in (-pi, pi] */
    vm_real trace, det; /* small deviations vary as e^(lambda t) with lambda^2 - trace lambda + det = 0 */
    int stable;         /* 1 where det > 0 and trace < 0, else 0; det < 0 means a saddle */
} vm_steady_state;

/* Passage through the resonance at one time */
typedef struct VM_TAG(vm_passage) {
    vm_real A;              /* amplitude, m, whose natural frequency w(A) is nu; for alpha = 1 the given amplitude */
    vm_real drift_ratio;    /* rate of w - nu over the largest rate that the force can balance. Below 1 the vibration
                               may be captured, so that it follows A; above 1 it passes through the resonance */
    vm_real delta;          /* phase by which the captured vibration leads the force, rad; NaN for drift_ratio > 1 */
    vm_real amplitude_jump; /* largest relative change of the amplitude in a quick passage (drift_ratio much larger
                               than 1). The change depends on the phase at the start and may have either sign */
} vm_passage;

/* The quantities that determine the resonance at one time */
typedef struct VM_TAG(vmi_resonance) {
    vm_real w1, exponent; /* natural frequency w = w1 A^exponent, rad/s */
    vm_real nu;           /* frequency of the force, rad/s */
    vm_real p;            /* decay rate q/(alpha+3), 1/s: free vibrations follow A' = -p A */
    vm_real push;         /* force per mass F G/m that acts on the mean motion, with the sign of F */
} vmi_resonance;

/* The fields of vmi_resonance for the oscillator f with the parameters n */
VM_API vmi_resonance vmi_resonance_of(const vm_forced *f, const vmi_forced_parameters *n)
{
    vmi_resonance z;
    z.w1 = vmi_forced_natural(f, n, 1);
    z.exponent = (f->alpha - 1) / 2;
    z.nu = n->nu;
    z.p = vmi_forced_q(f, n) / (f->alpha + 3);
    z.push = n->force * f->G / n->mass;
    return z;
}

/* The excess ln(A w sqrt((w - nu)^2 + p^2)/|push|) at the amplitude A = e^x. It is 0 for a steady vibration. w = w1
   A^exponent, nu, p and push are those of vmi_resonance. */
VM_API vm_real vmi_resonance_excess(vm_real x, void *resonance)
{
    const vmi_resonance *z = (const vmi_resonance *)resonance;
    const vm_real w = z->w1 * vmi_exp(z->exponent * x, 0), detuning = vmi_c_modulus(vmi_complex(w - z->nu, z->p));
    if (!(detuning > 0)) return -VM_MAX;
    return (1 + z->exponent) * x + vmi_log(z->w1 / VM_FABS(z->push) * detuning).hi;
}

/* The steady vibration of amplitude A, with trace and determinant of the linearized averaged equations */
VM_API vm_steady_state vmi_resonance_state(const vmi_resonance *z, vm_real alpha, vm_real A)
{
    const vm_real w = z->w1 * vmi_pow_checked(A, z->exponent), gain = (alpha + 1) / 2, off = w - z->nu, p = z->p;
    vm_steady_state s;
    s.nu = z->nu;
    s.A = A;
    s.delta = ateb_phase(-p * A * w / z->push, off * A * w / z->push, 1);
    s.trace = -(alpha + 3) * p / 2;
    s.det = p * p * gain + off * (z->exponent * w + gain * off);
    s.stable = s.det > 0 && s.trace < 0;
    return s;
}

/* The extrema of vmi_resonance_excess for alpha != 1, in ascending order: writes x = ln A of at most two and returns
   how many there are. At an extremum det = 0, so that w solves 2 alpha w^2 - (3 alpha + 1) nu w + (alpha + 1)(nu^2 +
   p^2) = 0. */
VM_API int vmi_resonance_turns(const vmi_resonance *z, vm_real alpha, vm_real x[2])
{
    const vm_real bend = (alpha - 1) * z->nu, square = bend * bend - 8 * alpha * (alpha + 1) * z->p * z->p;
    vm_real half, first;
    if (!(square > 0)) return 0;
    half = (3 * alpha + 1) * z->nu + VM_SQRT(square);
    x[0] = vmi_log(2 * (alpha + 1) * (z->nu * z->nu + z->p * z->p) / (half * z->w1)).hi / z->exponent;
    if (!(alpha > 0)) return 1;
    x[1] = vmi_log(half / (4 * alpha * z->w1)).hi / z->exponent;
    if (x[0] > x[1]) {
        first = x[1];
        x[1] = x[0];
        x[0] = first;
    }
    return 2;
}

/* The steady amplitudes for alpha != 1, in ascending order: writes at most three and returns how many there are. The
   excess is monotonic below, between and above its extrema, so each of these intervals of x = ln A holds at most one
   zero. */
VM_API int vmi_resonance_roots(vmi_resonance *z, vm_real alpha, vm_real A[3])
{
    const vm_real steep = vmi_larger(VM_FABS(z->exponent), 1);
    const vm_real reach = -vmi_log(VM_MIN).hi / steep; /* for |x| <= reach, A and w neither overflow nor underflow */
    vm_real ends[4], turns[2], left, right;
    int i, found = 0;
    const int n = vmi_resonance_turns(z, alpha, turns);
    ends[0] = -reach;
    ends[n + 1] = reach;
    for (i = 0; i < n; i++) ends[i + 1] = vmi_clamp(turns[i], -reach, reach);
    for (i = 0; i <= n; i++) {
        left = vmi_resonance_excess(ends[i], z);
        right = vmi_resonance_excess(ends[i + 1], z);
        if (!((left > 0) != (right > 0))) continue;
        A[found++] = vmi_exp(vmi_find_zero(vmi_resonance_excess, z, ends[i], ends[i + 1], left, right), 0);
    }
    return found;
}

/* Steady vibrations of an excited oscillator: amplitudes, phases, stability.
   All parameters are those at time t. Writes at most three vibrations to steady, the smallest amplitude first, and
   returns how many there are, 0 where the force is 0, or a negative status. In the tests amplitudes are within 3e-14
   (float 3e-5), relative, of solutions of the averaged equations. To get the response at all frequencies, call it for
   each nu. Solutions far from w(A) = nu need not be near a motion, since the averaged equations hold near the
   resonance. The negative statuses are those of vm_forced_rhs. */
VM_API int vm_forced_steady_states(const vm_forced *f, vm_real t, vm_steady_state steady[3])
{
    if (!f || !steady) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    int i, found = 0;
    const int status = vmi_forced_at(f, t, &n);
    vm_real A[3];
    vmi_resonance z;
    if (status) return status;
    z = vmi_resonance_of(f, &n);
    if (z.push == 0) return 0;
    if (f->alpha == 1) {
        A[0] = VM_FABS(z.push) / (z.w1 * vmi_c_modulus(vmi_complex(z.w1 - z.nu, z.p)));
        found = VM_IS_FINITE(A[0]);
    } else {
        found = vmi_resonance_roots(&z, f->alpha, A);
    }
    for (i = 0; i < found; i++) steady[i] = vmi_resonance_state(&z, f->alpha, A[i]);
    return found;
}

/* Steady vibrations of a given amplitude A, m, at any frequency nu > 0: the amplitude-frequency curve, traced by A.
   Writes at most two vibrations to curve, the lower frequency first, one on each side of the backbone w(A). Returns
   how many there are, 0 where the force is too small for A, or a negative status: those of vm_forced_rhs, and
   VM_DOMAIN also where A is not positive. Results that overflow are NaN. */
VM_API int vm_forced_curve(const vm_forced *f, vm_real t, vm_real A, vm_steady_state curve[2])
{
    if (!f || !curve) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vmi_resonance z;
    vm_real w, hold, width, p;
    int found = 0;
    if (status == VM_BAD_ARGUMENT) return status;
    if (!VM_IS_FINITE(A)) return VM_NOT_FINITE;
    if (status) return status;
    if (!(A > 0)) return VM_DOMAIN;
    z = vmi_resonance_of(f, &n);
    w = vmi_forced_natural(f, &n, A);
    hold = VM_FABS(z.push) / (w * A);
    p = VM_FABS(z.p);
    if (!(hold >= p) || z.push == 0) return 0;
    width = VM_SQRT(hold - p) * VM_SQRT(hold + p); /* |w - nu| */
    z.nu = w - width;
    if (z.nu > 0) curve[found++] = vmi_resonance_state(&z, f->alpha, A);
    z.nu = w + width;
    if (width > 0) curve[found++] = vmi_resonance_state(&z, f->alpha, A);
    return found;
}

/* Largest amplitude of the amplitude-frequency curve, m: where the curve meets the backbone w(A) = nu. It is infinite
   without damping. The relative error is at most 1e-14 (float 2e-5). Returns NaN for a null pointer and where the
   parameters at time t are not in their domain. */
VM_API vm_real vm_forced_peak(const vm_forced *f, vm_real t)
{
    if (!f) return VM_NAN;
    vmi_forced_parameters n;
    vmi_resonance z;
    if (vmi_forced_at(f, t, &n)) return VM_NAN;
    z = vmi_resonance_of(f, &n);
    return vmi_pow_checked(VM_FABS(z.push / z.p) / z.w1, 2 / (f->alpha + 1));
}

/* Passage through the resonance: whether a slow drift leads to capture.
   The drift is given by the rates of mass, stiffness and frequency at time t. amplitude, m, is used for alpha = 1
   only, where the backbone has the same frequency for all amplitudes. On the backbone delta'' = -(gamma push/A)
   sin(delta) - nu D, as for a pendulum under a torque, where gamma = (alpha - 1)/2, push = F G/m, and D is the
   relative drift of w - nu; drift_ratio is the torque |nu D| over |gamma push/A|, the largest torque that the pendulum
   can hold. The statuses are those of vm_forced_rhs; VM_DOMAIN also means that the force is 0 or that the amplitude is
   not positive and finite. An error leaves *passage as it was. */
VM_API int vm_forced_passage(const vm_forced *f, vm_real t, vm_real amplitude, vm_passage *passage)
{
    if (!f || !passage) return VM_BAD_ARGUMENT;
    vmi_forced_parameters n;
    const int status = vmi_forced_at(f, t, &n);
    vmi_resonance z;
    vm_passage r;
    vm_real D, sine = VM_INFINITY, cosine;
    if (status) return status;
    z = vmi_resonance_of(f, &n);
    r.A = amplitude;
    if (z.exponent != 0) r.A = vmi_pow_checked(z.nu / z.w1, 1 / z.exponent);
    if (!(r.A > 0) || !VM_IS_FINITE(r.A) || z.push == 0) return VM_DOMAIN;
    D = n.mass_rate / (2 * n.mass) - n.k_rate / (2 * n.k) + n.nu_rate / n.nu + z.exponent * z.p;
    if (z.exponent != 0) sine = -z.nu * D * r.A / (z.exponent * z.push);
    r.drift_ratio = VM_FABS(sine);
    r.delta = VM_NAN;
    if (r.drift_ratio <= 1) {
        cosine = VM_COPYSIGN(VM_SQRT((1 - sine) * (1 + sine)), z.exponent * z.push);
        r.delta = ateb_phase(sine, cosine, 1);
    }
    r.amplitude_jump = VM_FABS(z.push) / (z.nu * r.A) * VM_SQRT(2 * VM_PI / (z.nu * VM_FABS(D)));
    *passage = r;
    return VM_OK;
}

#endif
/* oscillators/diagnostics.h - turning points and zero crossings of any trajectory, envelopes, adiabaticity

   The motion may come from a route, a closed form or an integrator's dense output. At its turning points one compares
   it with laws of the amplitude; its zero crossings give the largest velocities and the periods.

       vm_sample turning[8]; // motion: a function of the user, see vm_motion_function
       long n = vm_find_samples(motion, NULL, VM_TURNING_POINTS, 0, 20, VM_C(0.1), 8, turning);

   Tests: tests/test_diagnostics.c. */
#ifndef VARMASS_OSCILLATORS_DIAGNOSTICS_H
#define VARMASS_OSCILLATORS_DIAGNOSTICS_H

/* A user's trajectory: writes position x and velocity v at time t. ctx is the user's pointer. */
typedef void (*vm_motion_function)(vm_real t, vm_real *x, vm_real *v, void *ctx);

/* A trajectory at one time: time, position and velocity, in the units of the trajectory */
typedef struct VM_TAG(vm_sample) {
    vm_real t, x, v;
} vm_sample;

/* The kinds of points at which samples are taken */
enum {
    VM_TURNING_POINTS = 0, /* where the velocity x' is 0 */
    VM_ZERO_CROSSINGS = 1  /* where the position x is 0 */
};

/* Whether the kind of sample exists and `room` is not negative; for room > 0 samples must not be null. */
VM_API int vmi_samples_are_possible(int kind, long room, const vm_sample *samples)
{
    return (kind == VM_TURNING_POINTS || kind == VM_ZERO_CROSSINGS) && (room == 0 || (room > 0 && samples));
}

/* A search for turning points or zero crossings along a trajectory */
typedef struct VM_TAG(vmi_sample_search) {
    vm_motion_function motion;
    void *ctx;
    int kind;
    vm_real x, v; /* position and velocity at the time of the last evaluation */
} vmi_sample_search;

/* The function of t whose zeros are sought: the position x for zero crossings, the velocity v for turning points */
VM_API vm_real vmi_sample_function(vm_real t, void *search)
{
    vmi_sample_search *s = (vmi_sample_search *)search;
    s->motion(t, &s->x, &s->v, s->ctx);
    if (s->kind == VM_ZERO_CROSSINGS) return s->x;
    return s->v;
}

/* Turning points or zero crossings of a trajectory in (t0, t1]. kind is VM_TURNING_POINTS or VM_ZERO_CROSSINGS. The
   trajectory is evaluated at equal intervals of at most |step|, and each change of sign is located within 4 eps of
   its time. step should be a small part of a period; it is negative where t1 < t0. The first `room` samples are
   written to samples, in the order in which they are met. Returns how many samples there are, which may be more than
   room, or a negative status: VM_BAD_ARGUMENT for a null pointer, an unknown kind or a negative room, VM_NOT_FINITE for
   a step of 0, of the wrong sign or infinite, for more than 2e9 steps, or where the trajectory is not finite. Samples
   found before the error stay in samples. */
VM_API long vm_find_samples(vm_motion_function motion, void *ctx, int kind, vm_real t0, vm_real t1, vm_real step,
                            long room, vm_sample *samples)
{
    const vm_real most_steps = VM_C(2e9);
    vmi_sample_search s;
    vm_real t = t0, here, intervals;
    long found = 0, i, last;
    if (!motion || !vmi_samples_are_possible(kind, room, samples)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(step)) return VM_NOT_FINITE;
    intervals = -VM_FLOOR(-(t1 - t0) / step);
    if (!(intervals >= 0) || !(intervals < most_steps)) return VM_NOT_FINITE;
    last = (long)intervals;
    s.motion = motion;
    s.ctx = ctx;
    s.kind = kind;
    here = vmi_sample_function(t0, &s);
    for (i = 1; i <= last; i++) {
        const vm_real before = t, value_before = here;
        t = i == last ? t1 : t0 + (t1 - t0) * ((vm_real)i / intervals);
        here = vmi_sample_function(t, &s);
        if (!VM_IS_FINITE(here)) return VM_NOT_FINITE;
        if (value_before == 0 || !(here == 0 || (here > 0) != (value_before > 0))) continue;
        if (found < room) {
            samples[found].t = vmi_find_zero(vmi_sample_function, &s, before, t, value_before, here);
            motion(samples[found].t, &samples[found].x, &samples[found].v, ctx);
        }
        found++;
    }
    if (!VM_IS_FINITE(here)) return VM_NOT_FINITE;
    return found;
}

/* A trajectory from the dense output of the integrator s: x and v are the indices of position and velocity in its
   state, buffer has room for a state */
typedef struct VM_TAG(vmi_step_motion) {
    rk45 *s;
    int x, v;
    vm_real *buffer;
} vmi_step_motion;

/* The trajectory within the integrator's last step; writes NaN where the dense output fails */
VM_API void vmi_motion_of_step(vm_real t, vm_real *x, vm_real *v, void *step)
{
    const vmi_step_motion *m = (const vmi_step_motion *)step;
    const int status = vmi_interpolate(m->s, t, m->buffer);
    *x = VM_NAN;
    *v = VM_NAN;
    if (status) return;
    *x = m->buffer[m->x];
    *v = m->buffer[m->v];
}

/* Turning points or zero crossings in the last step of an rk45 or rk87. Call it after every step. x and v are the
   indices of position and velocity in the state; buffer has room for a state. kind, room, samples and the result are
   those of vm_find_samples. Returns VM_BAD_ARGUMENT also for indices outside the state, and 0 before the first step. */
VM_API long vm_find_samples_of_step(rk45 *s, int x, int v, int kind, vm_real *buffer, long room, vm_sample *samples)
{
    const vm_real parts = 4; /* a change of sign is looked for in each of 4 equal parts of the step */
    vmi_step_motion m;
    vm_real length;
    if (!s || !buffer || x < 0 || v < 0 || x >= s->n || v >= s->n) return VM_BAD_ARGUMENT;
    if (!vmi_samples_are_possible(kind, room, samples)) return VM_BAD_ARGUMENT;
    length = s->t - s->t_old;
    if (length == 0) return 0;
    m.s = s;
    m.x = x;
    m.v = v;
    m.buffer = buffer;
    return vm_find_samples(vmi_motion_of_step, &m, kind, s->t_old, s->t, length / parts, room, samples);
}

/* Largest relative error of an amplitude law, |law(t)/observed - 1|, over n samples.
   The observed value is |x| for VM_TURNING_POINTS and |v| for VM_ZERO_CROSSINGS. law returns the amplitude or the
   largest velocity at time t, and gets ctx. Returns 0 for n = 0, and NaN for null pointers, for an unknown kind, for
   n < 0, or where law is NaN or a sample is infinite or NaN. */
VM_API vm_real vm_envelope_error(int kind, long n, const vm_sample *samples, vm_real (*law)(vm_real t, void *ctx),
                                 void *ctx)
{
    if (!samples || !law || !vmi_samples_are_possible(kind, n, samples)) return VM_NAN;
    vm_real worst = 0;
    long i;
    for (i = 0; i < n; i++) {
        vm_real observed = VM_FABS(samples[i].v), error;
        if (kind == VM_TURNING_POINTS) observed = VM_FABS(samples[i].x);
        error = VM_FABS(law(samples[i].t, ctx) / observed - 1);
        if (error != error || !VM_IS_FINITE(observed)) return VM_NAN;
        worst = vmi_larger(worst, error);
    }
    return worst;
}

/* Adiabaticity q/Om of an oscillator at time t and amplitude A, the small parameter of averaging.
   q = ((2r-1) m' + 2 b)/m + k'/k is the rate of the slow change, with r = reactive, b = damping, mass m and stiffness
   k. Om is the rate of the Ateb phase at the amplitude A, in m. The function uses only alpha, mass, stiffness,
   reactive and damping of the problem. For a motion that starts at rest, errors of amplitude laws are of order
   (q/Om)^2, and errors of waveforms of order q/Om up to t = 1/q. The result is within 4 eps. Returns NaN for a null
   pointer, where A, mass or stiffness is not positive, where alpha is negative, and for infinite numbers. */
VM_API vm_real vm_adiabaticity(const vm_osc_problem *o, vm_real t, vm_real A)
{
    if (!o) return VM_NAN;
    vm_real mass, mass_rate, k, k_rate, q;
    if (!(A > 0) || vmi_law_at(&o->mass, VM_BAD_MASS, t, &mass, &mass_rate) ||
        vmi_law_at(&o->stiffness, VM_BAD_STIFFNESS, t, &k, &k_rate))
        return VM_NAN;
    q = vmi_slow_q(vmi_slow_drag(o->reactive, mass_rate, o->damping), mass, k, k_rate);
    if (!VM_IS_FINITE(q)) return VM_NAN;
    return q / vmi_slow_rate(A, k, mass, o->alpha);
}

#endif
/* scenes/scene.h - what a scene is made of: bodies, effects, events

   A scene is a model that is put together from parts: bodies, the effects that act on them, and the events that change
   them. Its right-hand side evaluates the effects that are listed and nothing else. Each constructor refers only to the
   functions that its body, effect or event needs, so that the executable holds no others. The caller provides all
   arrays.

       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0)};             // 2 kg, at x = 0.1 m, at rest
       vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 0),  // loses 10 g/s without a reactive force
                              vm_effect_spring(0, 0, VM_GROUND, 0, 50, 3, 0)};
       vm_scene scene;
       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                          // 2 = vm_scene_size(&scene)
       vm_scene_fault fault;
       int status;
       memset(&scene, 0, sizeof scene);                                      // what is not set is absent
       scene.bodies = bodies;
       scene.n_bodies = 1;
       scene.effects = effects;
       scene.n_effects = 2;
       status = vm_scene_start(&scene, t, y, &fault);                        // checks the scene, and fills y
       if (status < 0) printf("%s %d: %s\n", fault.kind, fault.index, vm_strerror(status));
       else status = vm_scene_run(&scene, &t, 10, y, work, NULL);            // y[0] = x(10), y[1] = v(10)

   Functions refer to a body, an effect or an event by its index in its array. A scene with events also needs
   scene.events, scene.n_events and scene.located, an array of n_events elements, before the start. After the start
   all arrays must stay where they are. A second vm_scene_run continues where the first ended; vm_scene_start begins
   anew, with everything as the constructors have made it. A listed motor, for example, adds at most 35 machine
   instructions to an evaluation of the right-hand side.

   The state y has these numbers for body i, from y[bodies[i].at] on, positions first. r is the position of the mass
   centre, v its velocity, q the attitude and omega the angular velocity:
     line   x, v                                 point  r (3), v (3)
     axle   angle, omega                         free   r (3), q (4), v (3), omega (3, in body axes)
     plane  x, y, angle, vx, vy, omega
   If the mass is a state (vm_scene_body_with_mass_state), it follows as one more number. A growing body has two
   further groups of numbers: the displacement of the mass centre in the body since the start, in body axes (2 numbers
   in the plane, else 3), and the inertia about the mass centre (1 number in the plane, else xx, yy, zz, xy, xz, yz).

   An effect acts on a coordinate: 0 for a line or an axle; 0, 1, 2 for x, y, angle in the plane; 0, 1, 2 for x, y, z
   of a point or a free body. On an axle, a moment of inertia replaces the mass, and a torque replaces the force.

   Tests: tests/test_scenes.c and tests/test_scene_*.c. docs/scene-sizes.md lists the flash memory that each part
   takes. */
#ifndef VARMASS_SCENES_SCENE_H
#define VARMASS_SCENES_SCENE_H

enum {
    VM_LINE = 1, /* motion along a line */
    VM_AXLE,     /* rotation about a fixed axle */
    VM_PLANE,    /* translation and rotation in the plane */
    VM_POINT,    /* translation in space */
    VM_FREE      /* translation and rotation in space */
}; /* the motions of a body */

enum { VM_GROUND = -1 }; /* stands for the ground where an index of a body is expected */

/* Sums of the loads on a body at one evaluation. Every evaluation sets them to 0, and then each effect adds its
   part. */
typedef struct VM_TAG(vm_load) {
    vm_real mass;       /* kg (on an axle kg m^2): the present mass */
    vm_real extra_mass; /* kg: dM/dv (reactive v - u) of a mass law M(v), which acts like further mass */
    vm_real mass_rate;  /* kg/s: rate of the mass, if the mass is a state */
    vm_real force[6];   /* N (N m on an angle) on each coordinate; [3] to [5]: torque on a free body, inertial axes */
    vm_real mass_by_v;  /* kg s/m: the derivative dM/dv of a mass law M(v) */
    vm_real joining_v;  /* m/s: velocity of the mass that joins or leaves by a mass law */
    /* fields for growing bodies only */
    vm_vec3 drift;           /* m/s, inertial axes: velocity of the mass centre relative to the body */
    vm_vec3 centre_rate;     /* m/s, body axes: velocity of the mass centre relative to the body */
    vm_inertia inertia_rate; /* kg m^2/s, body axes: rate of the inertia */
    /* fields used only if the scene keeps a budget */
    vm_real reactive[6];    /* N, N m: the reactive part of `force` */
    vm_real brought[6];     /* N, N m: momentum and angular momentum that streams bring per second */
    vm_real brought_energy; /* W: kinetic energy that streams bring per second */
    vm_real mixing;         /* W: kinetic energy lost per second because mass of streams takes on the body's velocity */
} vm_load;

typedef struct VM_TAG(vm_scene_body) vm_scene_body;

/* A body of a scene. A constructor such as vm_scene_body_line makes it; the caller changes no field. */
struct VM_TAG(vm_scene_body) {
    /* fields set by the constructor */
    int motion;        /* VM_LINE, VM_AXLE, VM_PLANE, VM_POINT or VM_FREE */
    int mass_is_state; /* 1: the mass is a number of the state, so that streams can change it */
    int grows;         /* 1: mass centre and inertia are numbers of the state too */
    int absent;        /* 1: the body is not present until an event brings it in */
    int positions;     /* number of positions in the state of the body */
    int coordinates;   /* number of velocities in the state of the body */
    /* fields set by vm_scene_start and kept up to date by a run */
    int at;      /* index in y of the first number of the body */
    int mass_at; /* index in y of the mass, if the mass is a state */
    int away;    /* 1 while the body is not present */
    /* The functions of the motion. They are pointers, so that a program links only those for the motions of its bodies.
       accelerate computes the derivatives of the state from the load and returns a status. begin is NULL, or prepares a
       growing body in each evaluation, before the effects act. */
    int (*accelerate)(const vm_scene_body *b, const vm_real *state, vm_real *rates);
    void (*begin)(vm_scene_body *b, const vm_real *state);
    vm_real mass; /* kg: the mass, if it is neither a state nor given by a law */
    vm_load load; /* the loads on the body at the last evaluation */
    void (*put)(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state);  /* writes *now to the state */
    void (*get)(const vm_scene_body *b, const vm_real *state, vm_body *now);           /* reads *now from the state */
    int (*check)(const vm_body *start); /* NULL, or a check of the inertia, which returns a status */
    vm_body start;                      /* motion at the start; line: mass, r.x, v.x; axle: mass (kg m^2), omega.z */
    vm_real angle;                      /* rad: the angle of an axle or of a body in the plane at the start */
    vm_real law_offset;     /* kg: added to the mass law, which does not know of jumps and of being switched */
    vm_inertia inertia;     /* kg m^2, body axes: the present inertia */
    vm_inertia invertible;  /* kg m^2: the inertia with a dummy moment about each axis that has none */
    vmi_mat3 axes;          /* the present body axes of a growing body, in inertial axes */
    int listed_orders;      /* bit (1 << order) for each effect on the body that vm_scene_check has met so far */
    int status;             /* VM_OK, or the reason why the constructor could not make the body */
    vm_real noted_mass;     /* kg: the mass that the body must have after an event */
};

/* Function of the caller that writes position (m), velocity (m/s) and acceleration (m/s^2) of a point at time t */
typedef void (*vm_moving_point)(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx);
typedef struct VM_TAG(vm_scene) vm_scene;
typedef struct VM_TAG(vm_effect) vm_effect;
typedef struct VM_TAG(vm_event) vm_event;

/* What a mass law M(t, x, v) returns: the mass and its partial derivatives by time t, position x and velocity v */
typedef struct VM_TAG(vm_mass_law_values) {
    vm_real mass; /* kg (on an axle kg m^2): the mass M */
    vm_real by_t; /* kg/s (on an axle kg m^2/s): dM/dt */
    vm_real by_x; /* kg/m (on an axle kg m^2/rad): dM/dx */
    vm_real by_v; /* kg s/m (on an axle kg m^2 s/rad): dM/dv */
} vm_mass_law_values;

/* Where an effect has to stand in the list of effects, among the effects on its body */
enum {
    VMI_ORDER_MASS_LAW = 0, /* mass laws stand first, since all other effects may need the mass */
    VMI_ORDER_FORCE = 1,
    VMI_ORDER_LINK = 2 /* links stand last, since the force of a link depends on all other forces on its ends */
};

/* What an effect needs of the mass of its body */
enum { VMI_NEEDS_ANY_MASS = 0, VMI_NEEDS_MASS_STATE = 1, VMI_NEEDS_GROWING_BODY = 2 };

/* Reasons why an effect does not act now, as bits of vm_effect.idle */
enum { VMI_IDLE_SWITCHED_OFF = 1, VMI_IDLE_BODY_AWAY = 2 };

/* An effect. A constructor such as vm_effect_spring makes it. The comment above vmi_effect in effects.h explains how to
   write a new one. */
struct VM_TAG(vm_effect) {
    /* fields set by the constructor */
    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene); /* adds to the loads */
    int variant; /* which variant of the effect: for example which mass law, or whether a band lies in layers */
    /* fields set once by vm_scene_start, so that evaluations are fast */
    int idle;             /* bits VMI_IDLE_... that say why the effect does not act; 0 while it acts */
    int x, v;             /* indices in y: position and velocity of the coordinate on which the effect acts */
    int other_x, other_v; /* indices in y: position and velocity of the coordinate on which the opposite force acts */
    vm_load *load;        /* load of the body on which the effect acts */
    vm_load *other_load;  /* load of the body on which the opposite force acts; NULL for the ground */
    /* further fields set by the constructor */
    int body, coordinate;        /* index of the body and its coordinate on which the effect acts */
    int other, other_coordinate; /* body and coordinate on which the opposite force acts, or VM_GROUND */
    vm_real p[6];                /* parameters; the enum VMI_<EFFECT>_... of each effect names their indices */
    vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx);   /* function given to vm_effect_force */
    vm_mass_law_values (*law)(vm_real t, vm_real x, vm_real v, void *ctx); /* function given to vm_effect_mass_law */
    vm_moving_point point;                                          /* NULL, or the function for vm_effect_link */
    const vm_stream *stream;                                        /* stream of vm_effect_stream_mass, _force, ... */
    void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx); /* function given to vm_effect_varying */
    int (*check)(const vm_effect *effect); /* NULL, or a check of the parameters, which returns a status */
    void *ctx;                             /* pointer that the caller's function receives */
    unsigned motions;                      /* bit (1 << motion) for each motion that `body` may have */
    unsigned other_motions;                /* bit (1 << motion) for each motion that `other` may have */
    int needs;                             /* what the effect needs of the mass of its body: VMI_NEEDS_... */
    int order;                             /* where it stands among the effects on its body: VMI_ORDER_... */
    int off;          /* 1: switched off when the scene starts; the caller may set it before the start */
    int not_on_angle; /* 1: the effect cannot act on the angle of a body in the plane */
};

/* What a jump event does */
enum { VMI_JUMP_NONE = 0, VMI_JUMP_SEPARATES, VMI_JUMP_ATTACHES };

/* An event. A constructor such as vm_event_at says when it happens, and a function such as vm_then_stop what it
   does. */
struct VM_TAG(vm_event) {
    vm_real (*when)(const vm_event *event, vm_real t, const vm_real *y); /* NULL, or a function that is 0 at an event */
    /* NULL if the event is only counted, or the function that the event calls. It returns a status; VM_STOPPED ends the
       run. */
    int (*then)(vm_event *event, vm_real t, vm_real *y);
    vm_real time;  /* s: time of the event if `when` is NULL; else when it last happened, or the start of the scene */
    int direction; /* > 0: `when` rises through zero; < 0: `when` falls; 0: both count */
    /* fields for an event that happens when a coordinate, a velocity or the mass of a body crosses `value` */
    int watches; /* 1: the event watches a body */
    int body, coordinate;
    vm_real value;
    /* fields for an event that switches an effect */
    int switches; /* 1: the event switches an effect */
    int effect;   /* index of the effect */
    int off;      /* 1: the effect is switched off; 0: on */
    /* fields for a jump: check returns a status, and jump computes the motion after the jump on a line, in the plane,
       or for any motion */
    int (*check)(const vm_scene *scene, const vm_event *event);
    int (*jump)(const vm_event *event, const vm_body *body, vm_body *other, vm_body *result);
    unsigned motions;    /* bit (1 << motion) for each motion of a body that can jump in this way */
    int jump_kind;       /* VMI_JUMP_NONE, VMI_JUMP_SEPARATES or VMI_JUMP_ATTACHES */
    int jump_body;       /* index of the body that loses or gains mass */
    int other;           /* index of the body that separates from jump_body, or is attached to it */
    vm_body part;        /* the part that separates */
    int relative;        /* 1: the motion of `part` is relative to the body, in body axes */
    vm_impulse external; /* impulse from outside during the jump; the caller may set it */
    /* fields for vm_event_user and vm_then_user */
    vm_real (*user_when)(vm_real t, const vm_real *y, void *ctx);
    int (*user_then)(vm_real t, vm_real *y, void *ctx);
    void *ctx;      /* pointer that user_when receives */
    void *then_ctx; /* pointer that user_then receives */
    /* fields for the caller */
    long most;  /* how often the event happens at most; 0 means no limit. The caller may set it */
    long count; /* how often the event has happened */
    /* fields set by vm_scene_start and kept up to date by a run */
    long seen;       /* number of crossings found by the integrator that the run has already handled */
    vm_scene *scene; /* the scene to which the event belongs */
    int status;      /* VM_OK, or the reason why a constructor could not make the event */
};

typedef struct VM_TAG(vm_budget) vm_budget;

/* The budget of momentum, angular momentum and energy of a scene: the amounts of the bodies, the supply from outside,
   and the difference. vm_scene_keep_budget asks for it, vm_scene_budget_at computes it. */
struct VM_TAG(vm_budget) {
    vm_vec3 impulse;          /* N s: impulse of the effects and of the external impulses of jumps */
    vm_vec3 angular_impulse;  /* N m s: angular impulse about the origin of effects and of external impulses of jumps */
    vm_vec3 brought;          /* N s: momentum that streams and mass laws brought */
    vm_vec3 brought_angular;  /* N m s: angular momentum about the origin that streams and mass laws brought */
    vm_real work;             /* J: work of the effects, without reactive forces */
    vm_real brought_energy;   /* J: kinetic energy that streams and mass laws brought */
    vm_real mixing;           /* J: kinetic energy lost as the mass of streams took on the velocity of the body */
    vm_vec3 momentum;         /* N s: momentum of all bodies that are present */
    vm_vec3 angular_momentum; /* N m s: angular momentum of all bodies that are present, about the origin */
    vm_real energy;           /* J: kinetic energy of all bodies that are present */
    vm_real jump_energy;      /* J: kinetic energy that jumps have added */
    vm_vec3 momentum_defect;  /* N s: momentum - momentum at the start - impulse - brought */
    vm_vec3 angular_defect;   /* N m s: angular_momentum - its value at the start - angular_impulse - brought_angular */
    vm_real energy_defect;    /* J: energy - energy at the start - work - brought_energy + mixing - jump_energy */
    /* internal functions; they are pointers, so that a program without a budget does not link them */
    void (*open)(vm_scene *scene, const vm_real *y, vm_real *sums);
    void (*rates)(vm_scene *scene, const vm_real *y, vm_real *rates);
    void (*totals)(const vm_scene *scene, const vm_real *y, vm_budget *budget);
};

/* A scene. Every field that is 0 or NULL means that the scene has no such part. */
struct VM_TAG(vm_scene) {
    /* fields set by the caller before vm_scene_start */
    vm_scene_body *bodies; /* array of n_bodies bodies */
    int n_bodies;
    vm_effect *effects; /* array of n_effects effects */
    int n_effects;
    vm_event *events;   /* array of n_events events */
    ode_event *located; /* array of n_events elements, with which the integrator locates the events */
    int n_events;
    vm_budget *budget; /* set by vm_scene_keep_budget: the budget at the start; it adds VM_BUDGET_STATES numbers to y */
    /* NULL, or a function of the caller. It is called when a run starts and after each step, or only at `times` if they
       are given. The run stops if it returns a number other than 0. */
    int (*output)(vm_real t, const vm_real *y, vm_scene *scene, void *ctx);
    const vm_real *times; /* s: NULL, or n_times increasing times at which output is called, instead of after steps */
    int n_times;
    void *output_ctx; /* pointer that output receives */
    int y_size;       /* number of elements of y, which vm_scene_start and vm_scene_run check; 0 means no check */
    int work_size;    /* number of elements of work, which vm_scene_run checks; 0 means no check */
    /* fields set by vm_scene_start and by a run, for the caller to read */
    int status;     /* VM_OK, or why the right-hand side cannot accelerate a body or apply an effect */
    int ode_status; /* status of the integrator: ODE_OK or another status of ode.h */
    int size;       /* number of elements of the state; 0 before the start */
};

/* Sets of motions, with the bit (1 << motion) for each motion */
enum {
    VMI_SINGLE = 1 << VM_LINE | 1 << VM_AXLE, /* motions with one coordinate */
    VMI_FLAT = 1 << VM_PLANE | 1 << VM_POINT, /* a body in the plane, and a point in space */
    VMI_ALL_MOTIONS = VMI_SINGLE | VMI_FLAT | 1 << VM_FREE
};

/* The index of the mass among the numbers of a body, if the mass is a state */
VM_INLINE int vmi_scene_mass_at(const vm_scene_body *b) { return b->positions + b->coordinates; }

/* The number of elements of the state that belong to the body */
VM_INLINE int vmi_scene_body_size(const vm_scene_body *b)
{
    int size = vmi_scene_mass_at(b) + (b->mass_is_state != 0);
    if (b->grows) size += b->motion == VM_PLANE ? 2 + 1 : 3 + 6; /* mass centre and inertia */
    return size;
}

/* Position of the coordinate on which an effect acts, relative to the coordinate on which the opposite force acts,
   or to the ground */
VM_INLINE vm_real vmi_effect_x(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->x] - y[e->other_x] : y[e->x];
}

/* Velocity of the coordinate on which an effect acts, relative to the coordinate on which the opposite force acts,
   or to the ground */
VM_INLINE vm_real vmi_effect_v(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->v] - y[e->other_v] : y[e->v];
}

/* Adds the force f to the coordinate on which the effect acts, and the opposite force -f to the other coordinate */
VM_INLINE void vmi_effect_act(const vm_effect *e, vm_real f)
{
    e->load->force[e->coordinate] += f;
    if (e->other_load) e->other_load->force[e->other_coordinate] -= f;
}

#endif
/* scenes/motions.h - the bodies of a scene, and how each of them moves

   A body moves along a line, about an axle, in the plane, as a point in space, or free in space, with rotation. The
   arguments of its constructor are its motion at the start, in SI units. Each kind of body has four functions: put
   writes its motion into the state, get reads its motion from the state, accelerate computes the derivatives of the
   state from the load, and check refuses an inertia that the body cannot have.

       vm_vec3 zero = {0, 0, 0};
       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0),                              // 2 kg at x = 0.1 m
                                 vm_scene_body_axle(0.5, 0, 30),                             // 0.5 kg m^2 at 30 rad/s
                                 vm_scene_body_absent(vm_scene_body_point(1, zero, zero))};  // an event brings it in

   The constructors check only for NULL pointers; vm_scene_check and vm_scene_start refuse a mass that is not positive
   (VM_BAD_MASS), an inertia that the body cannot have (VM_BAD_INERTIA) and numbers that are not finite (VM_NOT_FINITE).

   Tests: tests/test_scene_bodies.c. */
#ifndef VARMASS_SCENES_MOTIONS_H
#define VARMASS_SCENES_MOTIONS_H

#include <string.h>

VM_API vm_scene_body vmi_scene_body(int motion, int positions, int coordinates)
{
    vm_scene_body b;
    memset(&b, 0, sizeof b);
    b.motion = motion;
    b.positions = positions;
    b.coordinates = coordinates;
    return b;
}

/* -- One coordinate: a line and an axle -- */

/* Computes the acceleration x'' = force/(mass + extra_mass) along the only coordinate */
VM_API int vmi_single_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    rates[0] = state[1];
    rates[1] = b->load.force[0] / (b->load.mass + b->load.extra_mass);
    return VM_OK;
}

VM_API void vmi_line_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    (void)angle;
    state[0] = now->r.x;
    state[1] = now->v.x;
}

VM_API void vmi_line_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[0];
    now->v.x = state[1];
}

/* A body on a line. mass is in kg, the position x in m, the velocity v in m/s. */
VM_API vm_scene_body vm_scene_body_line(vm_real mass, vm_real x, vm_real v)
{
    vm_scene_body b = vmi_scene_body(VM_LINE, 1, 1);
    b.start.mass = mass;
    b.start.r.x = x;
    b.start.v.x = v;
    b.put = vmi_line_put;
    b.get = vmi_line_get;
    b.accelerate = vmi_single_accelerate;
    return b;
}

VM_API void vmi_axle_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[0] = angle;
    state[1] = now->omega.z;
}

VM_API void vmi_axle_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->omega.z = state[1];
    now->inertia.zz = now->mass;
}

/* A body on a fixed axle. inertia is the moment of inertia about the axle in kg m^2; angle is in rad, omega in
   rad/s. */
VM_API vm_scene_body vm_scene_body_axle(vm_real inertia, vm_real angle, vm_real omega)
{
    vm_scene_body b = vmi_scene_body(VM_AXLE, 1, 1);
    b.start.mass = inertia;
    b.start.omega.z = omega;
    b.angle = angle;
    b.put = vmi_axle_put;
    b.get = vmi_axle_get;
    b.accelerate = vmi_single_accelerate;
    return b;
}

/* -- The plane -- */

enum { VMI_PLANE_X, VMI_PLANE_Y, VMI_PLANE_ANGLE, VMI_PLANE_VX, VMI_PLANE_VY, VMI_PLANE_OMEGA }; /* indices in state */

VM_API int vmi_plane_check(const vm_body *start) { return start->inertia.zz > 0 ? VM_OK : VM_BAD_INERTIA; }

VM_API int vmi_plane_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[3 + i];
    rates[VMI_PLANE_VX] = b->load.force[0] / b->load.mass;
    rates[VMI_PLANE_VY] = b->load.force[1] / b->load.mass;
    rates[VMI_PLANE_OMEGA] = b->load.force[2] / b->inertia.zz;
    return VM_OK;
}

VM_API void vmi_plane_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[VMI_PLANE_X] = now->r.x;
    state[VMI_PLANE_Y] = now->r.y;
    state[VMI_PLANE_ANGLE] = angle;
    state[VMI_PLANE_VX] = now->v.x;
    state[VMI_PLANE_VY] = now->v.y;
    state[VMI_PLANE_OMEGA] = now->omega.z;
}

/* Reads a body in the plane. Motion in the plane does not depend on the moments of inertia about x and y. Both are
   set to zz/2, as for a thin plate, so that a body with this inertia is possible. */
VM_API void vmi_plane_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[VMI_PLANE_X];
    now->r.y = state[VMI_PLANE_Y];
    now->v.x = state[VMI_PLANE_VX];
    now->v.y = state[VMI_PLANE_VY];
    vmi_sincos(state[VMI_PLANE_ANGLE] / 2, &now->q.z, &now->q.w);
    now->omega.z = state[VMI_PLANE_OMEGA];
    now->inertia.xx = now->inertia.yy = now->inertia.zz / 2;
}

/* A body in the plane. mass is in kg, the moment of inertia about the mass centre in kg m^2 (> 0), the position r in m,
   the angle in rad (anticlockwise), the velocity v in m/s, omega in rad/s. r.z and v.z have no effect. */
VM_API vm_scene_body vm_scene_body_plane(vm_real mass, vm_real inertia, vm_vec3 r, vm_real angle, vm_vec3 v,
                                    vm_real omega)
{
    vm_scene_body b = vmi_scene_body(VM_PLANE, 3, 3);
    b.start.mass = mass;
    b.start.inertia.zz = inertia;
    b.start.r = r;
    b.start.v = v;
    b.start.omega.z = omega;
    b.angle = angle;
    b.start.r.z = b.start.v.z = 0;
    b.put = vmi_plane_put;
    b.get = vmi_plane_get;
    b.accelerate = vmi_plane_accelerate;
    b.check = vmi_plane_check;
    return b;
}

/* -- A point in space -- */

VM_API int vmi_point_body_check(const vm_body *start)
{
    const vm_inertia *i = &start->inertia;
    const int none = i->xx == 0 && i->yy == 0 && i->zz == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    if (none) return VM_OK;
    return VM_BAD_INERTIA;
}

/* Computes r' and v' of a point or of a free body. The state of a point is {r, v}. The state of a free body is
   {r, q, v, ...} with the quaternion q; vmi_free_accelerate computes q'. */
VM_API int vmi_point_body_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[b->positions + i];
    for (i = 0; i < 3; i++) rates[b->positions + i] = b->load.force[i] / b->load.mass;
    return VM_OK;
}

VM_API void vmi_point_body_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)angle;
    vmi_set3(state, now->r);
    vmi_set3(state + b->positions, now->v);
}

VM_API void vmi_point_body_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->r = vmi_get3(state);
    now->v = vmi_get3(state + b->positions);
}

/* A point in space. mass is in kg, the position r in m, the velocity v in m/s. */
VM_API vm_scene_body vm_scene_body_point(vm_real mass, vm_vec3 r, vm_vec3 v)
{
    vm_scene_body b = vmi_scene_body(VM_POINT, 3, 3);
    b.start.mass = mass;
    b.start.r = r;
    b.start.v = v;
    b.put = vmi_point_body_put;
    b.get = vmi_point_body_get;
    b.accelerate = vmi_point_body_accelerate;
    b.check = vmi_point_body_check;
    return b;
}

/* -- A free body in space -- */

enum { VMI_FREE_R = 0, VMI_FREE_Q = 3, VMI_FREE_V = 7, VMI_FREE_OMEGA = 10 }; /* indices in state; omega: body axes */

/* Solves Euler's equations I omega' = torque - omega x I omega in body axes. The matrix of the linear equations
   includes the dummy moments of b->invertible; therefore the equations can be solved for a rod, too. The spin of a
   rod about its own axis stays constant, since no load turns the rod about this axis. */
VM_API int vmi_free_euler(const vm_scene_body *b, const vmi_mat3 *axes, vm_vec3 omega, vm_real *rates)
{
    const vm_inertia *i = &b->invertible;
    const vm_vec3 torque = vmi_times_transposed(axes, vmi_get3(b->load.force + 3));
    vm_real a[9];
    vmi_set3(rates, vmi_sub(torque, vmi_cross(omega, vmi_inertia_times(&b->inertia, omega))));
    a[0] = i->xx;
    a[4] = i->yy;
    a[8] = i->zz;
    a[1] = a[3] = i->xy;
    a[2] = a[6] = i->xz;
    a[5] = a[7] = i->yz;
    if (vmi_solve_linear(3, a, rates)) return VM_BAD_INERTIA;
    return VM_OK;
}

VM_API int vmi_free_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_quat q = vmi_get_quat(state + VMI_FREE_Q);
    const vm_vec3 omega = vmi_get3(state + VMI_FREE_OMEGA);
    const vmi_mat3 axes = vmi_rotation(q);
    vmi_point_body_accelerate(b, state, rates);
    vmi_attitude_rates(q, vmi_quat_square(q), omega, rates + VMI_FREE_Q);
    return vmi_free_euler(b, &axes, omega, rates + VMI_FREE_OMEGA);
}

/* The inertia with a dummy moment about each axis that has none, so that it can be inverted. No torque acts about such
   an axis, so that the dummy moment has no effect on the motion. */
VM_API vm_inertia vmi_invertible_inertia(const vm_inertia *i)
{
    const vm_real trace = i->xx + i->yy + i->zz, dummy = trace > 0 ? trace : 1;
    vmi_principal p = vmi_principal_axes(i);
    int k, null_axes = 0;
    for (k = 0; k < 3; k++)
        if (!(p.moment[k] > vmi_inertia_slack(i))) {
            p.moment[k] = dummy;
            null_axes++;
        }
    if (null_axes > 0) return vmi_inertia_from(&p);
    return *i;
}

VM_API void vmi_free_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    const vmi_mat3 axes = vmi_rotation(now->q);
    b->invertible = vmi_invertible_inertia(&now->inertia);
    vmi_point_body_put(b, now, angle, state);
    state[VMI_FREE_Q] = vmi_quat_is_none(now->q) ? 1 : now->q.w;
    state[VMI_FREE_Q + 1] = now->q.x;
    state[VMI_FREE_Q + 2] = now->q.y;
    state[VMI_FREE_Q + 3] = now->q.z;
    vmi_set3(state + VMI_FREE_OMEGA, vmi_times_transposed(&axes, now->omega));
}

VM_API void vmi_free_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    vmi_mat3 axes;
    vmi_point_body_get(b, state, now);
    now->q = vmi_get_quat(state + VMI_FREE_Q);
    axes = vmi_rotation(now->q);
    now->omega = vmi_times(&axes, vmi_get3(state + VMI_FREE_OMEGA));
}

/* A body that moves and turns freely in space. *start is its motion at the start. The body may be a rod, whose spin
   about its own axis then stays constant. vm_scene_start returns VM_BAD_ARGUMENT if start is NULL. */
VM_API vm_scene_body vm_scene_body_free(const vm_body *start)
{
    vm_scene_body b = vmi_scene_body(VM_FREE, 7, 6);
    b.status = start ? VM_OK : VM_BAD_ARGUMENT;
    if (!start) return b;
    b.start = *start;
    b.put = vmi_free_put;
    b.get = vmi_free_get;
    b.accelerate = vmi_free_accelerate;
    b.check = vmi_check_body;
    return b;
}

/* -- Any body -- */

/* A body like `body` whose mass is a state, so that streams can change the mass. */
VM_API vm_scene_body vm_scene_body_with_mass_state(vm_scene_body body)
{
    body.mass_is_state = 1;
    return body;
}

/* A body like `body` that is not present until an event brings it in. Effects on the body do not act before this
   event. */
VM_API vm_scene_body vm_scene_body_absent(vm_scene_body body)
{
    body.absent = 1;
    return body;
}

/* The number of coordinates on which the mass, or on an axle the moment of inertia, resists acceleration */
VM_INLINE int vmi_scene_directions(int motion)
{
    if (motion <= VM_AXLE) return 1;
    return motion == VM_PLANE ? 2 : 3;
}

/* The array a has a number for each coordinate, for example its velocity or the force on it. Returns the numbers for
   the motion of the mass centre as a vector in inertial axes. */
VM_API vm_vec3 vmi_scene_moving(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, 0);
    if (b->motion == VM_LINE) return vmi_vec3(a[0], 0, 0);
    if (b->motion == VM_PLANE) return vmi_vec3(a[0], a[1], 0);
    return vmi_get3(a);
}

/* The array a has a number for each coordinate, for example its velocity or the torque on it. Returns the numbers for
   the rotation of the body as a vector, in the axes in which the array has them. */
VM_API vm_vec3 vmi_scene_turning(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, a[0]);
    if (b->motion == VM_PLANE) return vmi_vec3(0, 0, a[2]);
    if (b->motion == VM_FREE) return vmi_get3(a + 3);
    return vmi_vec3(0, 0, 0);
}

/* The angular velocity of a body in inertial axes */
VM_API vm_vec3 vmi_scene_spin(const vm_scene_body *b, const vm_real *y)
{
    const vm_vec3 omega = vmi_scene_turning(b, y + b->at + b->positions);
    vmi_mat3 axes;
    if (b->motion != VM_FREE) return omega;
    axes = vmi_rotation(vmi_get_quat(y + b->at + VMI_FREE_Q));
    return vmi_times(&axes, omega);
}

/* The array a has a number for each coordinate. Adds the vector `moving` to the numbers for the motion of the mass
   centre and the vector `turning` to the numbers for the rotation. vmi_scene_moving and vmi_scene_turning read them. */
VM_API void vmi_scene_add(const vm_scene_body *b, vm_real *a, vm_vec3 moving, vm_vec3 turning)
{
    if (b->motion == VM_AXLE) {
        a[0] += turning.z;
        return;
    }
    a[0] += moving.x;
    a[1] += moving.y;
    a[2] += b->motion == VM_PLANE ? turning.z : moving.z;
    if (b->motion == VM_FREE) {
        a[3] += turning.x;
        a[4] += turning.y;
        a[5] += turning.z;
    }
}

#endif
/* scenes/growing.h - bodies whose mass centre and inertia change

   The mass, the mass centre in the body, and the inertia of a growing body are numbers of the state, so that streams
   can enter or leave at its points (streams.h). A growing body moves in the plane or in space. A body without extension
   (a rod, a point) cannot grow.

       vm_vec3 zero = {0, 0, 0};
       vm_scene_body bodies[] = {vm_scene_body_growing_plane(vm_scene_body_plane(2, 1, zero, 0, zero, 0))};
       vm_effect effects[] = {vm_effect_stream_mass(0, &nozzle), vm_effect_stream_force(0, &nozzle)}; // a vm_stream

   Tests: tests/test_scene_streams.c. */
#ifndef VARMASS_SCENES_GROWING_H
#define VARMASS_SCENES_GROWING_H

/* The index of the mass centre in the state of a growing body; the mass centre follows the mass */
VM_INLINE int vmi_growth_centre_at(const vm_scene_body *b) { return vmi_scene_mass_at(b) + 1; }

/* The index of the inertia in the state of a growing body; the inertia follows the mass centre, which has 2 or 3
   numbers */
VM_INLINE int vmi_growth_inertia_at(const vm_scene_body *b)
{
    const int directions = b->motion == VM_PLANE ? 2 : 3;
    return vmi_growth_centre_at(b) + directions;
}

VM_API void vmi_growth_begin(vm_scene_body *b)
{
    const vm_inertia none = {0, 0, 0, 0, 0, 0};
    b->load.drift = b->load.centre_rate = vmi_vec3(0, 0, 0);
    b->load.inertia_rate = none;
}

VM_API vm_vec3 vmi_growth_centre(const vm_scene_body *b, const vm_real *state)
{
    const vm_real *c = state + vmi_growth_centre_at(b);
    return vmi_vec3(c[0], c[1], b->motion == VM_PLANE ? 0 : c[2]);
}

VM_API void vmi_growth_put_centre(const vm_scene_body *b, vm_vec3 centre, vm_real *state)
{
    vm_real *c = state + vmi_growth_centre_at(b);
    c[0] = centre.x;
    c[1] = centre.y;
    if (b->motion != VM_PLANE) c[2] = centre.z;
}

VM_API void vmi_plane_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vm_real s, c;
    vmi_growth_begin(b);
    vmi_sincos(state[VMI_PLANE_ANGLE], &s, &c);
    b->axes.x = vmi_vec3(c, s, 0);
    b->axes.y = vmi_vec3(-s, c, 0);
    b->axes.z = vmi_vec3(0, 0, 1);
    b->inertia.zz = state[vmi_growth_inertia_at(b)];
}

VM_API int vmi_plane_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    if (!(b->inertia.zz > 0)) return VM_BAD_INERTIA;
    vmi_plane_accelerate(b, state, rates);
    rates[VMI_PLANE_X] += load->drift.x;
    rates[VMI_PLANE_Y] += load->drift.y;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    rates[vmi_growth_inertia_at(b)] = load->inertia_rate.zz;
    return VM_OK;
}

VM_API void vmi_plane_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_plane_put(b, now, angle, state);
    state[vmi_growth_inertia_at(b)] = now->inertia.zz;
}

VM_API void vmi_plane_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia.zz = state[vmi_growth_inertia_at(b)];
    vmi_plane_get(b, state, now);
}

/* A growing body in the plane. The argument is a body made by vm_scene_body_plane. A run ends with VM_BAD_INERTIA when
   the inertia is no longer positive. vm_scene_start returns VM_BAD_MOTION for any other body. */
VM_API vm_scene_body vm_scene_body_growing_plane(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.begin = vmi_plane_growing_begin;
    body.accelerate = vmi_plane_growing_accelerate;
    body.put = NULL; /* vm_scene_check then refuses the body */
    if (body.motion == VM_PLANE) body.put = vmi_plane_growing_put;
    body.get = vmi_plane_growing_get;
    return body;
}

VM_API void vmi_free_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vmi_growth_begin(b);
    b->axes = vmi_rotation(vmi_get_quat(state + VMI_FREE_Q));
    b->inertia = b->invertible = vmi_get_inertia(state + vmi_growth_inertia_at(b));
}

VM_API int vmi_free_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    vmi_inertia_ldl factors; /* needed for the test only; vmi_free_accelerate solves Euler's equations with pivoting */
    if (!vmi_inertia_factor_if_possible(&b->inertia, &factors)) return VM_BAD_INERTIA;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    vmi_set_inertia(rates + vmi_growth_inertia_at(b), &load->inertia_rate);
    if (vmi_free_accelerate(b, state, rates)) return VM_BAD_INERTIA;
    rates[VMI_FREE_R] += load->drift.x;
    rates[VMI_FREE_R + 1] += load->drift.y;
    rates[VMI_FREE_R + 2] += load->drift.z;
    return VM_OK;
}

VM_API void vmi_free_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_free_put(b, now, angle, state);
    vmi_set_inertia(state + vmi_growth_inertia_at(b), &now->inertia);
}

VM_API void vmi_free_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia = vmi_get_inertia(state + vmi_growth_inertia_at(b));
    vmi_free_get(b, state, now);
}

/* Checks the inertia of a growing body. A rod or a point is refused, since no stream could turn it about one of its
   axes. */
VM_API int vmi_free_growing_check(const vm_body *start)
{
    vmi_inertia_ldl factors;
    const int status = vmi_check_body(start);
    if (status) return status;
    if (!vmi_inertia_factor_if_possible(&start->inertia, &factors)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* A growing body in space. The argument is a body made by vm_scene_body_free. A run ends with VM_BAD_INERTIA when the
   inertia becomes one that no body can have. vm_scene_start returns VM_BAD_MOTION for any other body, and
   VM_BAD_INERTIA for a rod or a point. */
VM_API vm_scene_body vm_scene_body_growing_free(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.check = vmi_free_growing_check;
    body.begin = vmi_free_growing_begin;
    body.accelerate = vmi_free_growing_accelerate;
    body.put = NULL; /* vm_scene_check then refuses the body */
    if (body.motion == VM_FREE) body.put = vmi_free_growing_put;
    body.get = vmi_free_growing_get;
    return body;
}

#endif
/* scenes/forces.h - the forces of effects, as functions of numbers

   The effects of a scene use these functions, and a right-hand side that is written by hand can call them as well. They
   return a force in N, or a torque in N m where the coordinate is an angle. x is the extension (m or rad) and v the
   rate of the extension (m/s or rad/s). Arguments are not checked; NaN gives NaN. The error is at most 6 VM_EPSILON
   times the sum of the absolute values of the terms of the force, if the angle of a sine or cosine is exact.

       vm_real x = VM_C(0.1), v = 2, mass = 3;
       vm_real acceleration = (vm_force_spring(x, 50, 3) + vm_force_damper(v, 2)) / mass; // (-50 x^3 - 2 v) / mass

   Tests: tests/test_forces.c. */
#ifndef VARMASS_SCENES_FORCES_H
#define VARMASS_SCENES_FORCES_H

/* The force of a spring, -k x |x|^(alpha-1) (248). The stiffness k in N/m^alpha may have either sign. The result is NaN
   for alpha < 0. The exponents alpha = 1, 2 and 3 are computed without a power. */
VM_INLINE vm_real vm_force_spring(vm_real x, vm_real k, vm_real alpha)
{
    if (alpha == 1) return -k * x;
    if (alpha == 3) return -(k * x) * (x * x);
    if (alpha == 2) return -k * (x * VM_FABS(x));
    return -k * vmi_elastic_power(x, alpha) * (x != 0);
}

/* The force of a linear damper, -damping v. damping is in N s/m; if it is positive, the damper takes energy out. */
VM_INLINE vm_real vm_force_damper(vm_real v, vm_real damping) { return -damping * v; }

/* The force of Van der Pol's damper, (b - c x^2) v (404). A positive b in N s/m feeds energy in; a positive c in
   N s/m^3 takes energy out at large amplitudes. */
VM_INLINE vm_real vm_force_van_der_pol(vm_real x, vm_real v, vm_real b, vm_real c)
{
    return vmi_van_der_pol_feed(b, c, x) * v;
}

/* The torque of a motor, stall_torque - kappa omega. omega is the angular velocity in rad/s, stall_torque the torque at
   rest in N m, and kappa the slope of the straight characteristic in N m s. */
VM_INLINE vm_real vm_force_motor(vm_real omega, vm_real stall_torque, vm_real kappa)
{
    return stall_torque - kappa * omega;
}

/* The force of harmonic excitation, amplitude cos(frequency t + phase). amplitude is in N, frequency in rad/s, phase in
   rad. */
VM_INLINE vm_real vm_force_harmonic(vm_real t, vm_real amplitude, vm_real frequency, vm_real phase)
{
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    return amplitude * c;
}

/* The reactive force of a stream, rate (u - reactive v). The stream brings `rate` kg of mass per second; a negative
   rate takes mass away. The mass has the velocity u + (1 - reactive) v, where v is the velocity of the body: u is
   absolute if reactive is 1, and relative to the body if it is 0. */
VM_INLINE vm_real vm_force_stream(vm_real v, vm_real rate, vm_real u, vm_real reactive)
{
    return rate * (u - reactive * v);
}

/* The weight of a mass, mass g. mass is in kg and g in m/s^2. g is negative if the coordinate points up. */
VM_INLINE vm_real vm_force_gravity(vm_real mass, vm_real g) { return mass * g; }

/* The force of an elastic shaft, -k r |r|^(alpha-1), on a point at r = (x, y). It points to the origin of the plane. r
   is in m, the stiffness k in N/m^alpha, and the force is NaN for alpha < 0. The components are written to *fx and *fy;
   if one of these pointers is NULL, nothing is written. */
VM_INLINE void vm_force_shaft(vm_real x, vm_real y, vm_real k, vm_real alpha, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real r = VM_SQRT(x * x + y * y), f = r > 0 ? vm_force_spring(r, k, alpha) / r : 0;
    *fx = f * x;
    *fy = f * y;
}

/* The force of a rotating unbalance, m e Omega^2 (cos a, sin a) at the angle a = Omega t + phase. unbalance is the
   mass m times its eccentricity e in kg m, and frequency is the angular velocity Omega in rad/s. The components are
   written to *fx and *fy; if one of these pointers is NULL, nothing is written. */
VM_INLINE void vm_force_unbalance(vm_real t, vm_real unbalance, vm_real frequency, vm_real phase, vm_real *fx,
                                  vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real size = unbalance * (frequency * frequency);
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    *fx = size * c;
    *fy = size * s;
}

/* The gyroscopic force normal to the velocity (vx, vy) in the plane, 2 gyro (-vy, vx). gyro in kg/s is the coefficient
   in the term 2 i gyro z' of the equation of Laval's rotor, where z is its complex deflection. The force does no work.
   The components are written to *fx and *fy; if one of these pointers is NULL, nothing is written. */
VM_INLINE void vm_force_gyroscopic(vm_real vx, vm_real vy, vm_real gyro, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    *fx = -vmi_gyroscopic_coupling(gyro) * vy;
    *fy = vmi_gyroscopic_coupling(gyro) * vx;
}

#endif
/* scenes/effects.h - springs, dampers, motors and other forces on a coordinate

   An effect exerts a force of forces.h on a coordinate of a body. x and v are the position and the velocity of this
   coordinate. If an effect acts against another body, x and v are relative to a coordinate of that body, which takes
   the reaction; against VM_GROUND they are relative to a point at rest. A mass law stands before all other effects on
   its body, and a link stands after them.

       vm_effect effects[] = {vm_effect_gravity(0, 0, -9.81),                       // weight of body 0
                              vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1000, 0), // 1000 N/m to the ground
                              vm_effect_damper(1, 0, 0, 0, 5)};                     // 5 N s/m between bodies 1 and 0

   In all constructors of this file `body` and `other` are indices of bodies, `coordinate` and `other_coordinate` are
   their coordinates (scene.h has a list). A constructor checks only whether a function of the caller is NULL;
   vm_scene_check and vm_scene_start refuse an effect that its body cannot have, and parameters that are infinite, NaN
   or outside their domain.

   Tests: tests/test_scene_effects.c. */
#ifndef VARMASS_SCENES_EFFECTS_H
#define VARMASS_SCENES_EFFECTS_H

#include <string.h>

/* To add an effect, write one block like that of the spring (vm_effect_spring), and nothing else in the headers:
     an enum          names the indices of the parameters in p[6];
     vmi_apply_NAME   adds the force to the loads, at each evaluation;
     vmi_NAME_check   returns a status, if not all finite parameters are allowed;
     vm_effect_NAME   is the constructor: it calls vmi_effect and sets the parameters and all that differs from the
                      defaults (the motions on which the effect can act, the check).
   The force itself may be a function of forces.h. */

/* An effect on a coordinate of a body against a coordinate of another body. It can act on all motions, is neither a
   mass law nor a link, and its parameters are 0. */
VM_API vm_effect vmi_effect_between(int body, int coordinate, int other, int other_coordinate,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene))
{
    vm_effect e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.other = other;
    e.other_coordinate = other_coordinate;
    e.apply = apply;
    e.motions = VMI_ALL_MOTIONS;
    e.other_motions = VMI_ALL_MOTIONS;
    e.order = VMI_ORDER_FORCE;
    return e;
}

/* An effect on a coordinate of a body against the ground, with the defaults of vmi_effect_between */
VM_API vm_effect vmi_effect(int body, int coordinate,
                            void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene))
{
    return vmi_effect_between(body, coordinate, VM_GROUND, 0, apply);
}

enum { VMI_GRAVITY_G };

VM_API void vmi_apply_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)y;
    (void)s;
    e->load->force[e->coordinate] += vm_force_gravity(e->load->mass, e->p[VMI_GRAVITY_G]);
}

/* Gravity along a coordinate, the force M g. M is the present mass of the body. g in m/s^2 is -9.81 if the coordinate
   points up. Gravity cannot act on an axle (VM_BAD_MOTION) or on the angle of a body in the plane (VM_NOT_ON_ANGLE). */
VM_API vm_effect vm_effect_gravity(int body, int coordinate, vm_real g)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_gravity);
    e.p[VMI_GRAVITY_G] = g;
    e.motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.not_on_angle = 1;
    return e;
}

enum { VMI_SPRING_STIFFNESS, VMI_SPRING_EXPONENT, VMI_SPRING_REST };

VM_API void vmi_apply_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real extension = vmi_effect_x(e, y) - e->p[VMI_SPRING_REST];
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_spring(extension, e->p[VMI_SPRING_STIFFNESS], e->p[VMI_SPRING_EXPONENT]));
}

VM_API int vmi_spring_check(const vm_effect *e) { return e->p[VMI_SPRING_EXPONENT] >= 0 ? VM_OK : VM_DOMAIN; }

/* A nonlinear spring, the force -k z |z|^(alpha-1) with z = x - rest (248). The stiffness k in N/m^alpha may have
   either sign; rest is in m or rad. vm_scene_start returns VM_DOMAIN if alpha < 0. */
VM_API vm_effect vm_effect_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                  vm_real alpha, vm_real rest)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, vmi_apply_spring);
    e.p[VMI_SPRING_STIFFNESS] = k;
    e.p[VMI_SPRING_EXPONENT] = alpha;
    e.p[VMI_SPRING_REST] = rest;
    e.check = vmi_spring_check;
    return e;
}

VM_API void vmi_apply_linear_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real extension = vmi_effect_x(e, y) - e->p[VMI_SPRING_REST];
    (void)t;
    (void)s;
    vmi_effect_act(e, -e->p[VMI_SPRING_STIFFNESS] * extension);
}

/* A linear spring, the force -k (x - rest). The stiffness k in N/m may have either sign; rest is in m or rad. Unlike
   vm_effect_spring, this effect does not make a program link the power function. */
VM_API vm_effect vm_effect_linear_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                         vm_real rest)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, vmi_apply_linear_spring);
    e.p[VMI_SPRING_STIFFNESS] = k;
    e.p[VMI_SPRING_REST] = rest;
    return e;
}

enum { VMI_DAMPER_DAMPING };

VM_API void vmi_apply_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_damper(vmi_effect_v(e, y), e->p[VMI_DAMPER_DAMPING]));
}

/* A linear damper, the force -damping v. v is the velocity of the coordinate relative to other_coordinate of the body
   `other`. damping is in N s/m; if it is positive, the damper takes energy out. */
VM_API vm_effect vm_effect_damper(int body, int coordinate, int other, int other_coordinate, vm_real damping)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, vmi_apply_damper);
    e.p[VMI_DAMPER_DAMPING] = damping;
    return e;
}

VM_API void vmi_apply_rotational_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    const vm_vec3 torque = vmi_scale(-e->p[VMI_DAMPER_DAMPING], vmi_scene_spin(b, y));
    (void)t;
    vmi_scene_add(b, e->load->force, vmi_vec3(0, 0, 0), torque);
}

/* A damper of the rotation, the torque -damping omega. damping is in N m s; if it is positive, the damper takes energy
   out. omega is the angular velocity of a body on an axle, in the plane, or free. */
VM_API vm_effect vm_effect_rotational_damper(int body, vm_real damping)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_rotational_damper);
    e.p[VMI_DAMPER_DAMPING] = damping;
    e.motions = 1 << VM_AXLE | 1 << VM_PLANE | 1 << VM_FREE;
    return e;
}

enum { VMI_VAN_DER_POL_FEEDING, VMI_VAN_DER_POL_LIMITING };

VM_API void vmi_apply_van_der_pol(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real b = e->p[VMI_VAN_DER_POL_FEEDING], c = e->p[VMI_VAN_DER_POL_LIMITING];
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_van_der_pol(vmi_effect_x(e, y), vmi_effect_v(e, y), b, c));
}

/* Van der Pol's damper, the force (b - c x^2) v (404). x and v are the position and velocity of the coordinate. A
   positive b in N s/m feeds energy in; a positive c in N s/m^3 takes energy out at large amplitudes. */
VM_API vm_effect vm_effect_van_der_pol(int body, int coordinate, vm_real b, vm_real c)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_van_der_pol);
    e.p[VMI_VAN_DER_POL_FEEDING] = b;
    e.p[VMI_VAN_DER_POL_LIMITING] = c;
    return e;
}

enum { VMI_MOTOR_STALL_TORQUE, VMI_MOTOR_KAPPA };

VM_API void vmi_apply_motor(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_motor(vmi_effect_v(e, y), e->p[VMI_MOTOR_STALL_TORQUE], e->p[VMI_MOTOR_KAPPA]));
}

/* A motor, the torque stall_torque - kappa v. v is the angular velocity in rad/s, stall_torque the torque at rest in
   N m, and kappa the slope of the straight characteristic in N m s. On a coordinate that is a length the units are N
   and N s/m. */
VM_API vm_effect vm_effect_motor(int body, int coordinate, vm_real stall_torque, vm_real kappa)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_motor);
    e.p[VMI_MOTOR_STALL_TORQUE] = stall_torque;
    e.p[VMI_MOTOR_KAPPA] = kappa;
    return e;
}

enum { VMI_HARMONIC_AMPLITUDE, VMI_HARMONIC_FREQUENCY, VMI_HARMONIC_PHASE };

VM_API void vmi_apply_harmonic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real frequency = e->p[VMI_HARMONIC_FREQUENCY], phase = e->p[VMI_HARMONIC_PHASE];
    (void)y;
    (void)s;
    vmi_effect_act(e, vm_force_harmonic(t, e->p[VMI_HARMONIC_AMPLITUDE], frequency, phase));
}

/* Harmonic excitation, the force amplitude cos(frequency t + phase). amplitude is in N (N m on an angle), frequency in
   rad/s, phase in rad. */
VM_API vm_effect vm_effect_harmonic(int body, int coordinate, vm_real amplitude, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, coordinate, vmi_apply_harmonic);
    e.p[VMI_HARMONIC_AMPLITUDE] = amplitude;
    e.p[VMI_HARMONIC_FREQUENCY] = frequency;
    e.p[VMI_HARMONIC_PHASE] = phase;
    return e;
}

VM_API void vmi_apply_force(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)s;
    vmi_effect_act(e, e->force(t, vmi_effect_x(e, y), vmi_effect_v(e, y), e->ctx));
}

/* A force that the caller's function returns, between two coordinates. force(t, x, v, ctx) returns N (N m on an
   angle). x and v are position and velocity of the coordinate, relative to other_coordinate of the body `other`,
   which takes the reaction. vm_scene_start returns VM_BAD_ARGUMENT if force is NULL. */
VM_API vm_effect vm_effect_force_between(int body, int coordinate, int other, int other_coordinate,
                                        vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    vm_effect e = vmi_effect_between(body, coordinate, other, other_coordinate, force ? vmi_apply_force : NULL);
    e.force = force;
    e.ctx = ctx;
    return e;
}

/* A force that the caller's function returns. force(t, x, v, ctx) returns N (N m on an angle) for the time t and the
   position x and velocity v of the coordinate. vm_scene_start returns VM_BAD_ARGUMENT if force is NULL. */
VM_API vm_effect vm_effect_force(int body, int coordinate,
                                vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    return vm_effect_force_between(body, coordinate, VM_GROUND, 0, force, ctx);
}

/* An effect that the caller's function applies. It may depend on the whole state. The function `apply` adds to
     effect->load->force[coordinate]   the force;
     effect->load->mass_rate           the rate of the mass, only if the mass is a state;
     effect->load->mass                further mass, only if the mass is neither a state nor given by a law.
   It may read
     y[effect->x], y[effect->v]        position and velocity of coordinate 0;
     y[scene->bodies[i].at], ...       the state of body i;
     effect->load->mass                the present mass;
     effect->load->force               the sum of the forces of the effects that stand before it in the list;
     effect->p, effect->ctx            parameters, and a pointer of the caller.
   Therefore a rigid obstacle that is listed last can take away the force that presses the body against it. other is
   another body, or VM_GROUND. The effect acts only while both bodies are present; effect->other_load, effect->other_x
   and effect->other_v belong to the body `other`. vm_scene_start returns VM_BAD_ARGUMENT if apply is NULL. */
VM_API vm_effect vm_effect_custom(int body, int other,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene),
                                    void *ctx)
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, apply);
    e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_shaft(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real k = e->p[VMI_SPRING_STIFFNESS], alpha = e->p[VMI_SPRING_EXPONENT];
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_shaft(y[e->x], y[e->x + 1], k, alpha, &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* An elastic shaft, the force -k r |r|^(alpha-1) on a body at r = (x, y). The stiffness k is in N/m^alpha; a start
   returns VM_DOMAIN if alpha < 0. The effect acts on coordinates 0 and 1 of a body in the plane or of a point. */
VM_API vm_effect vm_effect_shaft(int body, vm_real k, vm_real alpha)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_shaft);
    e.p[VMI_SPRING_STIFFNESS] = k;
    e.p[VMI_SPRING_EXPONENT] = alpha;
    e.motions = VMI_FLAT;
    e.check = vmi_spring_check;
    return e;
}

enum { VMI_UNBALANCE_SIZE, VMI_UNBALANCE_FREQUENCY, VMI_UNBALANCE_PHASE };

VM_API void vmi_apply_unbalance(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real frequency = e->p[VMI_UNBALANCE_FREQUENCY], phase = e->p[VMI_UNBALANCE_PHASE];
    vm_real fx, fy;
    (void)y;
    (void)s;
    vm_force_unbalance(t, e->p[VMI_UNBALANCE_SIZE], frequency, phase, &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* A rotating unbalance, the force m e Omega^2 (cos a, sin a) at the angle a = Omega t + phase. unbalance is the mass
   m times its eccentricity e in kg m, frequency the angular velocity Omega in rad/s, and phase is in rad. The effect
   acts on coordinates 0 and 1 of a body in the plane or of a point. */
VM_API vm_effect vm_effect_unbalance(int body, vm_real unbalance, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_unbalance);
    e.p[VMI_UNBALANCE_SIZE] = unbalance;
    e.p[VMI_UNBALANCE_FREQUENCY] = frequency;
    e.p[VMI_UNBALANCE_PHASE] = phase;
    e.motions = VMI_FLAT;
    return e;
}

enum { VMI_GYROSCOPIC_GYRO };

VM_API void vmi_apply_gyroscopic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_gyroscopic(y[e->v], y[e->v + 1], e->p[VMI_GYROSCOPIC_GYRO], &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* A gyroscopic force normal to the velocity (vx, vy), 2 gyro (-vy, vx). gyro in kg/s is the coefficient in the term 2 i
   gyro z' of the equation of Laval's rotor, where z is its complex deflection. The effect acts on coordinates 0 and 1
   of a body in the plane or of a point. It does no work. */
VM_API vm_effect vm_effect_gyroscopic(int body, vm_real gyro)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_gyroscopic);
    e.p[VMI_GYROSCOPIC_GYRO] = gyro;
    e.motions = VMI_FLAT;
    return e;
}

#endif
/* scenes/gravitation.h - Newton's gravitation between bodies and towards a fixed centre

   The attraction falls with the inverse square of the distance and acts at the mass centres. It takes the present
   masses, whatever changes them. The bodies move in the plane or in space, or are points. For uniform gravity use
   vm_effect_gravity.

       vm_vec3 zero = {0, 0, 0};
       vm_effect effects[] = {vm_effect_gravitation(0, 1, 6.6743e-11),                // between the bodies 0 and 1
                              vm_effect_central_gravity(2, zero, 3.986004418e14)};    // towards the Earth's centre

   Tests: tests/test_orbit.c. */
#ifndef VARMASS_SCENES_GRAVITATION_H
#define VARMASS_SCENES_GRAVITATION_H

enum { VMI_GRAVITATION_G = 0, VMI_CENTRAL_CENTRE = 0, VMI_CENTRAL_MU = 3 };

/* The attraction a b/r^2 along d, the vector to the other mass, with r = |d|. The factors a and b are divided one by
   one, because their product could overflow. If the force is not finite, since the masses are at the same place, the
   scene gets the status VM_NOT_FINITE, and the integrator refuses the step. */
VM_INLINE vm_vec3 vmi_gravitation(vm_real a, vm_real b, vm_vec3 d, vm_scene *s)
{
    const vm_real r = VM_SQRT(vmi_dot(d, d));
    const vm_vec3 force = vmi_scale(a / r * (b / r), vmi_scale(1 / r, d));
    if (!vmi_vec3_is_finite(force)) s->status = VM_NOT_FINITE;
    return force;
}

/* An effect of gravitation: it acts on bodies in the plane, points and free bodies */
VM_API vm_effect vmi_effect_gravitation(int body, int other,
                                        void (*apply)(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s))
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, apply);
    e.motions = VMI_FLAT | 1 << VM_FREE;
    e.other_motions = VMI_FLAT | 1 << VM_FREE;
    return e;
}

VM_API void vmi_apply_gravitation(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body, *other = s->bodies + e->other;
    const vm_vec3 d = vmi_sub(vmi_scene_moving(other, y + other->at), vmi_scene_moving(b, y + b->at));
    const vm_vec3 force = vmi_gravitation(e->p[VMI_GRAVITATION_G] * e->load->mass, e->other_load->mass, d, s);
    const vm_vec3 none = {0, 0, 0};
    (void)t;
    vmi_scene_add(b, e->load->force, force, none);
    vmi_scene_add(other, e->other_load->force, vmi_scale(-1, force), none);
}

VM_API int vmi_gravitation_check(const vm_effect *e)
{
    if (e->other == VM_GROUND) return VM_NO_SUCH_BODY;
    return e->other == e->body ? (int)VM_SAME_BODY : (int)VM_OK;
}

/* Gravitation between two bodies, the force G M1 M2/r^2. G is in m^3/(kg s^2), 6.6743e-11 in nature; M1 and M2 are the
   present masses and r is the distance of the mass centres. The force on a body in the plane stays in the plane.
   vm_scene_start returns VM_NO_SUCH_BODY if `other` is VM_GROUND, VM_SAME_BODY if it is `body`, and VM_BAD_MOTION for a
   body on a line or an axle. A run ends with VM_NOT_FINITE if the bodies meet. */
VM_API vm_effect vm_effect_gravitation(int body, int other, vm_real G)
{
    vm_effect e = vmi_effect_gravitation(body, other, vmi_apply_gravitation);
    e.p[VMI_GRAVITATION_G] = G;
    e.check = vmi_gravitation_check;
    return e;
}

VM_API void vmi_apply_central_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    const vm_vec3 d = vmi_sub(vmi_scene_moving(b, e->p + VMI_CENTRAL_CENTRE), vmi_scene_moving(b, y + b->at));
    const vm_vec3 none = {0, 0, 0};
    (void)t;
    vmi_scene_add(b, e->load->force, vmi_gravitation(e->load->mass, e->p[VMI_CENTRAL_MU], d, s), none);
}

/* Gravitation towards a centre at rest, the force mu M/r^2. mu is G times the mass in the centre, in m^3/s^2
   (3.986004418e14 for the Earth); M is the present mass of the body and r its distance from the centre (m, inertial
   axes). For a body in the plane centre.z is not used. vm_scene_start returns VM_BAD_MOTION for a body on a line or an
   axle. */
VM_API vm_effect vm_effect_central_gravity(int body, vm_vec3 centre, vm_real mu)
{
    vm_effect e = vmi_effect_gravitation(body, VM_GROUND, vmi_apply_central_gravity);
    e.p[VMI_CENTRAL_CENTRE] = centre.x;
    e.p[VMI_CENTRAL_CENTRE + 1] = centre.y;
    e.p[VMI_CENTRAL_CENTRE + 2] = centre.z;
    e.p[VMI_CENTRAL_MU] = mu;
    return e;
}

#endif
/* scenes/mass.h - mass that follows a law, and its reactive force

   A mass law M(t, x, v) gives the mass of a body at any time; the mass is then not a number of the state. The mass
   that joins or leaves has the velocity u + (1 - reactive) v, where v is the velocity of the body. Therefore the
   equation of motion under the force F is M v' = F + M' (u - reactive v). The mass that joins or leaves has, for
     reactive = 1  the absolute velocity u: the reactive force is M' (u - v) (156), for u = 0 Levi-Civita's (167)-(169);
     reactive = 0  the velocity u relative to the body: the reactive force is M' u, which is 0 if u = 0 (166).
   Only on a line or an axle may a law depend on position x and velocity v; on an axle it gives the moment of inertia
   J from the angle or the angular velocity. u is in m/s. On a line and on an axle only u.x is used, on an axle in
   rad/s.

       vm_effect leak = vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 0); // body 0 loses 10 g/s, which keeps its velocity

   A law stands before all other effects on its body, and a body has at most one law. Mass that a jump adds to the
   body is added to the mass of the law. If an event switches a law off, the mass remains constant; if it switches a
   law on, the law continues from the present mass (of a law M0 + c t only c then has an effect). Therefore switching
   never changes a mass suddenly.

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_MASS_H
#define VARMASS_SCENES_MASS_H

/* Indices of the parameters of mass laws and of streams: the velocity u (three numbers), `reactive`, and the
   coefficient of a law or the rate of a stream */
enum { VMI_MASS_U = 0, VMI_MASS_REACTIVE = 3, VMI_MASS_COEFFICIENT = 4, VMI_MASS_RATE = 4 };

/* Adds the reactive force rate (u - reactive v) on each coordinate along which the mass moves, and adds to the budget
   the momentum and the energy that the mass brings */
VM_INLINE void vmi_scene_reactive(const vm_effect *e, const vm_real *y, vm_scene *s, vm_real rate, const vm_real *u,
                                  vm_real reactive)
{
    vm_load *load = e->load;
    const vm_real *v = y + e->v;
    const int n = vmi_scene_directions(s->bodies[e->body].motion);
    int i;
    for (i = 0; i < n; i++) {
        const vm_real joining = u[i] + (1 - reactive) * v[i], push = rate * (joining - v[i]);
        load->force[i] += push;
        if (!s->budget) continue;
        load->reactive[i] += push;
        load->brought[i] += rate * joining;
        load->brought_energy += rate * joining * joining / 2;
        load->mixing += push * (joining - v[i]) / 2;
    }
}

/* Gives the body the mass of a law. The rate is M' = by_t + by_x v + by_v v'. The acceleration v' is not known yet;
   therefore the reactive force of the last term, by_v v' (u - reactive v), is moved to the left side of the equation
   of motion, where it acts as the mass extra_mass = by_v (reactive v - u). */
VM_INLINE void vmi_scene_apply_law(const vm_effect *e, const vm_real *y, vm_scene *s, const vm_mass_law_values *now,
                                const vm_real *u, vm_real reactive)
{
    vm_load *load = e->load;
    const vm_real v = y[e->v];
    load->mass = now->mass + s->bodies[e->body].law_offset;
    load->extra_mass = now->by_v * (reactive * v - u[0]);
    load->mass_by_v = now->by_v;
    load->joining_v = u[0] + (1 - reactive) * v;
    vmi_scene_reactive(e, y, s, now->by_t + now->by_x * v, u, reactive);
}

VM_API void vmi_apply_mass_law(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_mass_law_values now = e->law(t, y[e->x], y[e->v], e->ctx);
    vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A mass law M(t, x, v) that the caller's function returns. The effect includes the reactive force. The velocity of
   the mass that joins or leaves is u + (1 - reactive) v, where v is the velocity of the body: u is absolute if
   reactive is 1, and relative to the body if it is 0. vm_scene_start returns VM_BAD_ARGUMENT if law is NULL. A run
   ends with VM_BAD_MASS if the mass is not positive, and with VM_NO_EFFECTIVE_MASS if M + dM/dv (reactive v - u) is
   not positive. */
VM_API vm_effect vm_effect_mass_law(int body, vm_mass_law_values (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
                                    void *ctx, vm_vec3 u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, law ? vmi_apply_mass_law : NULL);
    e.p[VMI_MASS_U] = u.x;
    e.p[VMI_MASS_U + 1] = u.y;
    e.p[VMI_MASS_U + 2] = u.z;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.order = VMI_ORDER_MASS_LAW;
    e.law = law;
    e.ctx = ctx;
    return e;
}

/* The kinds of vm_effect_mass. M0 is the mass with which the body was made. */
enum {
    VM_MASS_OF_T, /* M0 + c t at the time t, c in kg/s */
    VM_MASS_OF_X, /* M0 + c x at the position x, c in kg/m */
    VM_MASS_OF_V2 /* M0 + c v^2 at the velocity v, c in kg s^2/m^2 */
};

VM_API void vmi_apply_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = y[e->x], v = y[e->v], c = e->p[VMI_MASS_COEFFICIENT];
    vm_mass_law_values now = {0, 0, 0, 0};
    now.mass = s->bodies[e->body].start.mass;
    if (e->variant == VM_MASS_OF_T) {
        now.mass += c * t;
        now.by_t = c;
    } else if (e->variant == VM_MASS_OF_X) {
        now.mass += c * x;
        now.by_x = c;
    } else {
        now.mass += c * v * v;
        now.by_v = 2 * c * v;
    }
    vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A mass that is M0 + c t, M0 + c x or M0 + c v^2, with its reactive force. M0 is the mass with which the body was
   made. kind is VM_MASS_OF_T, VM_MASS_OF_X or VM_MASS_OF_V2; the last two are for a line or an axle. The velocity of
   the mass that joins or leaves is u + (1 - reactive) v along coordinate 0, where v is the velocity of the body: u is
   absolute if reactive is 1, and relative to the body if it is 0. vm_scene_start returns VM_BAD_ARGUMENT for an
   unknown kind; a run ends with the errors of vm_effect_mass_law. */
VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_mass);
    if (kind < VM_MASS_OF_T || kind > VM_MASS_OF_V2) e.apply = NULL; /* vm_scene_check then refuses the effect */
    e.variant = kind;
    e.p[VMI_MASS_U] = u;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.p[VMI_MASS_COEFFICIENT] = c;
    if (kind != VM_MASS_OF_T) e.motions = VMI_SINGLE;
    e.order = VMI_ORDER_MASS_LAW;
    return e;
}

#endif
/* scenes/mass_of_time.h - mass that follows a vm_law, and its reactive force

   A vm_law (oscillators/laws.h) is a number that depends on time: linear, quadratic, exponential, a power, a table,
   or a function. vm_effect_mass_of_time makes this number the mass of a body, which may have any motion. mass.h
   explains u, reactive and the switching of a law. For a law that depends on position or velocity use
   vm_effect_mass_law.

       vm_vec3 zero = {0, 0, 0};
       vm_law mass = vm_law_exponential(2, -0.01);                     // 2 kg at t = 0, 1 % less in each second
       vm_effect leak = vm_effect_mass_of_time(0, &mass, zero, 0);     // lost mass keeps the velocity of body 0

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_MASS_OF_TIME_H
#define VARMASS_SCENES_MASS_OF_TIME_H

/* Gives the body the mass of its law. If the law fails at t, the scene receives the status of the law, and the
   integrator refuses the step. */
VM_API void vmi_apply_mass_of_time(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_mass_law_values now = {0, 0, 0, 0};
    const int status = vmi_law_at((const vm_law *)e->ctx, VM_BAD_MASS, t, &now.mass, &now.by_t);
    if (status) s->status = status;
    else vmi_scene_apply_law(e, y, s, &now, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* Returns VM_OK if a constructor made the law, else VM_BAD_ARGUMENT. */
VM_API int vmi_check_mass_of_time(const vm_effect *e)
{
    if (!((const vm_law *)e->ctx)->derivatives) return VM_BAD_ARGUMENT;
    return VM_OK;
}

/* A mass that follows a vm_law, with its reactive force. The mass is *law at the time t of the scene; the mass that
   was given to the constructor of the body has no effect. The velocity of the mass that joins or leaves is
   u + (1 - reactive) v, where v is the velocity of the body: u is absolute if reactive is 1, and relative to the body
   if it is 0. *law is not copied and must stay where it is. vm_scene_start returns VM_BAD_ARGUMENT if law is NULL or
   no constructor made it. A run ends with VM_BAD_MASS if the mass is not positive, and with the status of vm_law_at
   if this function fails. */
VM_API vm_effect vm_effect_mass_of_time(int body, const vm_law *law, vm_vec3 u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_mass_of_time);
    if (!law) e.apply = NULL; /* vm_scene_check then refuses the effect */
    e.p[VMI_MASS_U] = u.x;
    e.p[VMI_MASS_U + 1] = u.y;
    e.p[VMI_MASS_U + 2] = u.z;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.order = VMI_ORDER_MASS_LAW;
    e.check = vmi_check_mass_of_time;
    e.ctx = (void *)law;
    return e;
}

#endif
/* scenes/streams.h - streams of mass into and out of the bodies of a scene

   A stream carries mass into a body or out of it. It changes a mass that is a state (vm_scene_body_with_mass_state).
   vm_effect_stream is a stream that enters or leaves at the mass centre: it changes the mass and has a reactive force.
   Four further effects are for a vm_stream of mechanics/streams.h that enters or leaves at a point of a growing body.
   Each of them is one action of the stream, and each may be left out:
     vm_effect_stream_mass    mass, mass centre and inertia; the mass centre then moves with r' = v + (M'/M) d
     vm_effect_stream_force   reactive force M' (u - v) (156)
     vm_effect_stream_moment  moment d x M' (u - v) about the mass centre (158)
     vm_effect_stream_torque  torque M' kappa omega2 - I' omega (157)
   mechanics/streams.h explains the symbols.

       vm_scene_body bodies[] = {vm_scene_body_with_mass_state(vm_scene_body_line(20, 0, 3))}; // a wagon in the rain
       vm_vec3 falls = {0, -8, 0};                               // 8 m/s downwards, no velocity along the line
       vm_effect effects[] = {vm_effect_stream(0, 5, falls, 1)}; // 5 kg/s

   Tests: tests/test_scene_streams.c. */
#ifndef VARMASS_SCENES_STREAMS_H
#define VARMASS_SCENES_STREAMS_H

VM_API void vmi_apply_stream(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real rate = e->p[VMI_MASS_RATE];
    (void)t;
    e->load->mass_rate += rate;
    vmi_scene_reactive(e, y, s, rate, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A stream that enters or leaves at the mass centre, with its reactive force. rate in kg/s (on an axle kg m^2/s) is
   negative for mass that leaves. If reactive is 1, u is the absolute velocity of the mass; if reactive is 0, u is
   relative to the body. For any number reactive the velocity of the mass is u + (1 - reactive) v, where v is the
   velocity of the body. The inertia of the body does not change. vm_scene_start returns VM_MASS_IS_NO_STATE if the mass
   of the body is not a state. */
VM_API vm_effect vm_effect_stream(int body, vm_real rate, vm_vec3 u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_stream);
    e.p[VMI_MASS_U] = u.x;
    e.p[VMI_MASS_U + 1] = u.y;
    e.p[VMI_MASS_U + 2] = u.z;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.p[VMI_MASS_RATE] = rate;
    e.needs = VMI_NEEDS_MASS_STATE;
    return e;
}

/* A stream at a point of a growing body: the motion of the body, as vmi_stream_sums needs it, and the sums that this
   function computes */
typedef struct VM_TAG(vmi_crossing) {
    vmi_stream_seen seen;
    vmi_stream_sum sum;
} vmi_crossing;

/* Fills *c with the sums of the stream of an effect. If vary has written an unknown motion to the stream, the scene
   gets the status VM_BAD_ARGUMENT, which ends the run. */
VM_API void vmi_crossing_now(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s, vmi_crossing *c)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_stream stream = *e->stream;
    if (e->vary) e->vary(t, y, &stream, e->ctx);
    c->seen.turn = &b->axes;
    c->seen.slip = vmi_vec3(0, 0, 0);
    if (stream.from) c->seen.slip = vmi_scale(stream.rate / e->load->mass, vmi_sub(stream.at, stream.from->at));
    c->seen.energy = s->budget != NULL;
    c->seen.v = vmi_scene_moving(b, y + e->v);
    c->seen.omega = vmi_scene_turning(b, y + e->v);
    c->seen.centre = vmi_growth_centre(b, y + b->at);
    if (!vmi_stream_sums(1, &stream, &c->seen, &c->sum)) s->status = VM_BAD_ARGUMENT;
}

/* Adds a reactive force and a moment or torque, in inertial axes, to the load and to the budget.
   vmi_apply_stream_mass enters in the budget the energy of the mass of the stream, and the momentum that this mass
   would have at the velocity of the body. This function adds force and torque to the momentum that the stream brings,
   and subtracts their power from `mixing`. */
VM_API void vmi_crossing_push(const vm_effect *e, vm_scene *s, const vmi_crossing *c, vm_vec3 force, vm_vec3 torque)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_scene_add(b, load->force, force, torque);
    if (!s->budget) return;
    vmi_scene_add(b, load->reactive, force, torque);
    vmi_scene_add(b, load->brought, force, torque);
    load->mixing -= vmi_dot(force, c->seen.v) + vmi_dot(torque, vmi_times(c->seen.turn, c->seen.omega));
}

VM_API void vmi_apply_stream_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_crossing c;
    vm_vec3 shift, spin, turning;
    vmi_crossing_now(e, t, y, s, &c);
    shift = vmi_scale(1 / load->mass, c.sum.crossing);
    load->mass_rate += c.sum.rate;
    load->drift = vmi_add(load->drift, vmi_times(c.seen.turn, shift));
    load->centre_rate = vmi_add(load->centre_rate, vmi_scale(1 / load->mass, c.sum.stored));
    load->inertia_rate = vmi_inertia_plus(load->inertia_rate, 1, c.sum.inertia);
    if (!s->budget) return;
    spin = vmi_inertia_times(&c.sum.inertia, c.seen.omega);
    turning = vmi_add(vmi_times(c.seen.turn, spin), vmi_cross(vmi_times(c.seen.turn, c.sum.crossing), c.seen.v));
    vmi_scene_add(b, load->brought, vmi_scale(c.sum.rate, c.seen.v), turning);
    load->brought_energy += c.sum.brought / 2;
    load->mixing += (c.sum.brought - c.sum.rate * vmi_dot(c.seen.v, c.seen.v) - vmi_dot(spin, c.seen.omega)) / 2;
}

VM_API void vmi_apply_stream_force(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vm_vec3 force;
    vmi_crossing_now(e, t, y, s, &c);
    force = vmi_sub(c.sum.absolute, vmi_scale(c.sum.rate - c.sum.carried, c.seen.v));
    vmi_crossing_push(e, s, &c, vmi_add(vmi_times(c.seen.turn, c.sum.pushed), force), vmi_vec3(0, 0, 0));
}

VM_API void vmi_apply_stream_moment(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vmi_crossing_now(e, t, y, s, &c);
    vmi_crossing_push(e, s, &c, vmi_vec3(0, 0, 0), vmi_times(c.seen.turn, c.sum.moment));
}

VM_API void vmi_apply_stream_torque(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vm_vec3 torque;
    vmi_crossing_now(e, t, y, s, &c);
    torque = vmi_sub(c.sum.own, vmi_inertia_times(&c.sum.inertia, c.seen.omega));
    vmi_crossing_push(e, s, &c, vmi_vec3(0, 0, 0), vmi_times(c.seen.turn, torque));
}

/* Checks a stream by vmi_check_stream. A store (stream->from) must lie on the line through the point of the stream and
   the mass centre at the start, which is the origin of body axes: a scene neglects the angular momentum of the mass
   that flows between the store and the point, which is 0 only on such a line. */
VM_API int vmi_crossing_check(const vm_effect *e)
{
    const vm_stream *stream = e->stream;
    vm_real moment;
    int status;
    if (!stream) return VM_BAD_ARGUMENT;
    status = vmi_check_stream(stream);
    if (status || !stream->from) return status;
    moment = vmi_norm_max(vmi_cross(stream->at, stream->from->at));
    if (moment <= 32 * VM_EPSILON * vmi_norm1(stream->at) * vmi_norm1(stream->from->at)) return VM_OK;
    return VM_STORED_STREAM;
}

VM_API vm_effect vmi_effect_crossing(int body, const vm_stream *stream,
                                     void (*apply)(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s))
{
    vm_effect e = vmi_effect(body, 0, apply);
    e.motions = 1 << VM_PLANE | 1 << VM_FREE;
    e.needs = VMI_NEEDS_GROWING_BODY;
    e.stream = stream;
    e.check = vmi_crossing_check;
    return e;
}

/* Mass, mass centre and inertia that a stream brings to a growing body. *stream is not copied: if an event changes
   it, the run continues with the change. stream->at is in body axes, from the position of the mass centre at the
   start. The field `mixing` of the budget is right only if the effects for mass, force, moment and torque of the
   stream are all listed, and if the stream has no store. A stream may have a store on the line through its point and
   the mass centre, as a rocket has whose tank and nozzle lie on its axis. The motion is then that of vm_flow_rhs if no
   other stream of the body has a store. vm_scene_start returns VM_BAD_ARGUMENT if stream is NULL or its motion is
   unknown, VM_STORED_STREAM if its store does not lie on this line, and VM_DOES_NOT_GROW if the body is not a growing
   body. */
VM_API vm_effect vm_effect_stream_mass(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_mass);
}

/* Reactive force M' (u - v) of a stream at a point of a growing body (156). M' is the rate of the mass, u its velocity
   and v that of the body. Conditions and errors are those of vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_force(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_force);
}

/* Moment d x M' (u - v) of a stream on a growing body (158). It is the moment about the mass centre of the reactive
   force M' (u - v) of vm_effect_stream_force. The vector d leads from the mass centre to the point of the stream.
   Conditions and errors are those of vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_moment(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_moment);
}

/* Torque M' kappa omega2 - I' omega of a stream on a growing body (157). M' is the rate of the mass, kappa the inertia
   of this mass per kg, omega2 its angular velocity; I' is the rate of the inertia of the body, omega its angular
   velocity. Conditions and errors are those of vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_torque(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_torque);
}

/* An effect of a stream that varies in time. effect comes from vm_effect_stream_mass, _force, _moment or _torque. At
   each evaluation vary receives a copy of the stream and writes the values of its fields for the time t and the state
   y: the point, which may move in the body, the rate, the velocity or the store (vm_supply_at gives that of a tank).
   vm_scene_start returns VM_BAD_ARGUMENT if vary is
   NULL or the effect has no stream. */
VM_API vm_effect vm_effect_varying(vm_effect effect,
                                   void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx),
                                   void *ctx)
{
    effect.vary = vary;
    effect.ctx = ctx;
    if (!effect.stream || !vary) effect.apply = NULL;
    return effect;
}

#endif
/* scenes/band.h - a band that winds up on a drum or off it

   The drum is a body on an axle (chapter 5.2 of the dissertation). It is bare at the angle phi = 0, and the body is
   made with the inertia of the bare drum. The band comes or goes at the radius
     R + h phi/(2 pi)   along a spiral, or
     R + h n            in layers, after n complete turns (by_layer),
   and the inertia grows by rho b h radius^3 per radian. R is the radius of the drum, h the thickness of the band, b its
   width and rho its density. If the band lies in layers, its rate jumps at each complete turn, and with it the reactive
   torque. vm_band_at computes the part that is wound up at any angle; vm_effect_band is the mass law of the drum in a
   scene.

       vm_band band = {0.2, 0.01, 0.5, 800, 0, 0, 0}; // R, h, b, rho; the band moves with the drum; along a spiral
       vm_effect wind = vm_effect_band(0, &band);

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_BAND_H
#define VARMASS_SCENES_BAND_H

/* A band. Its velocity is speed + (1 - reactive) (radius omega), where omega is the angular velocity of the drum. The
   band comes at the absolute velocity `speed` if reactive is 1, and moves with the drum if speed and reactive are 0. */
typedef struct VM_TAG(vm_band) {
    vm_real radius;    /* m: radius R of the bare drum, > 0 */
    vm_real thickness; /* m: thickness h, >= 0 */
    vm_real width;     /* m: width b, >= 0 */
    vm_real density;   /* kg/m^3: density rho, >= 0 */
    vm_real speed;     /* m/s: velocity of the band, absolute or relative to the drum */
    vm_real reactive;     /* 1: speed is absolute; 0: speed is relative to the drum */
    int by_layer;      /* 1: the band lies in layers; 0: along a spiral */
} vm_band;

/* The part of a band that is wound up at an angle */
typedef struct VM_TAG(vm_band_now) {
    vm_real radius;  /* m: radius at which the band comes or goes */
    vm_real rate;    /* kg/rad: mass mu per radian that is wound up at this radius (181) */
    vm_real mass;    /* kg: mass of the part that is wound up */
    vm_real inertia; /* kg m^2: moment of inertia of the part that is wound up */
} vm_band_now;

/* The part of a band in layers that is wound up at the angle phi. `line` is density times width times thickness. Mass
   and inertia are line times the integrals of the radius and of its cube over phi. n is the number of complete layers;
   over them these integrals are 2 pi times the sums of R + i h and of (R + i h)^3 for i = 0 ... n - 1. The sums of i,
   i^2 and i^3 are sum1, sum2 and sum1^2. */
VM_API vm_band_now vmi_band_by_layer(vm_real phi, const vm_band *b, vm_real line)
{
    const vm_real n = VM_FLOOR(phi / (2 * VM_PI)), rest = phi - n * (2 * VM_PI), R = b->radius, h = b->thickness;
    const vm_real sum1 = n * (n - 1) / 2, sum2 = sum1 * (2 * n - 1) / 3, r = R + n * h;
    vm_band_now now;
    now.radius = r;
    now.rate = line * r;
    now.mass = line * (2 * VM_PI * (n * R + h * sum1) + r * rest);
    now.inertia = line * (2 * VM_PI * (n * R * R * R + 3 * R * h * (R * sum1 + h * sum2) + h * h * h * sum1 * sum1) +
                          r * r * r * rest);
    return now;
}

VM_API int vmi_band_is_valid(const vm_band *b)
{
    return b->radius > 0 && b->thickness >= 0 && b->width >= 0 && b->density >= 0;
}

/* A vm_band_now whose radius is `radius` and whose other numbers are all `others`. For a bare drum `others` is 0; for a
   band or an angle that is not valid both arguments are NaN. */
VM_API vm_band_now vmi_band_none(vm_real radius, vm_real others)
{
    vm_band_now none;
    none.radius = radius;
    none.rate = others;
    none.mass = others;
    none.inertia = others;
    return none;
}

/* Radius, mass and inertia of the band that is wound up at the angle phi. If phi < 0, the drum is bare. All numbers are
   NaN if phi is not finite, the radius is not positive, another size is negative, or band is NULL. In double the
   relative errors are at most 1e-13, tested up to 30 turns. */
VM_API vm_band_now vm_band_at(vm_real phi, const vm_band *band)
{
    if (!band || !VM_IS_FINITE(phi) || !vmi_band_is_valid(band)) return vmi_band_none(VM_NAN, VM_NAN);
    const vm_real line = band->density * band->width * band->thickness, R = band->radius;
    const vm_real r = R + band->thickness * (phi / (2 * VM_PI));
    vm_band_now now;
    if (!(phi >= 0)) return vmi_band_none(R, 0);
    if (band->by_layer) return vmi_band_by_layer(phi, band, line);
    now.radius = r;
    now.rate = line * r;
    now.mass = line * phi * (r + R) / 2;
    now.inertia = line * phi * ((r + R) * (r * r + R * R)) / 4;
    return now;
}

/* Indices of the parameters of the effect; its variant is by_layer */
enum {
    VMI_BAND_RADIUS,
    VMI_BAND_THICKNESS,
    VMI_BAND_WIDTH,
    VMI_BAND_DENSITY,
    VMI_BAND_SPEED,
    VMI_BAND_REACTIVE
};

VM_API vm_band vmi_band_of(const vm_effect *e)
{
    vm_band b;
    b.radius = e->p[VMI_BAND_RADIUS];
    b.thickness = e->p[VMI_BAND_THICKNESS];
    b.width = e->p[VMI_BAND_WIDTH];
    b.density = e->p[VMI_BAND_DENSITY];
    b.speed = e->p[VMI_BAND_SPEED];
    b.reactive = e->p[VMI_BAND_REACTIVE];
    b.by_layer = e->variant;
    return b;
}

/* Gives the drum its moment of inertia J(phi), which takes the place of the mass on an axle, as a mass law does. u is
   the speed of the band divided by the radius at which it comes, an angular velocity about the axle. */
VM_API void vmi_apply_band(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_band band = vmi_band_of(e);
    const vm_band_now wound = vm_band_at(y[e->x], &band);
    const vm_real u = band.speed / wound.radius;
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    now.mass = s->bodies[e->body].start.mass + wound.inertia;
    now.by_x = wound.rate * wound.radius * wound.radius;
    vmi_scene_apply_law(e, y, s, &now, &u, band.reactive);
}

VM_API int vmi_band_check(const vm_effect *e)
{
    const vm_band band = vmi_band_of(e);
    return vmi_band_is_valid(&band) ? VM_OK : VM_DOMAIN;
}

/* A band that winds up on a drum or off it, with its reactive torque. The drum is a body on an axle, and the band is
   its mass law. vm_scene_start returns VM_BAD_ARGUMENT if band is NULL, and VM_DOMAIN if its radius is not positive or
   a size is negative. */
VM_API vm_effect vm_effect_band(int body, const vm_band *band)
{
    vm_effect e = vmi_effect(body, 0, band ? vmi_apply_band : NULL);
    e.motions = 1 << VM_AXLE;
    e.order = VMI_ORDER_MASS_LAW;
    e.check = vmi_band_check;
    if (!band) return e;
    e.p[VMI_BAND_RADIUS] = band->radius;
    e.p[VMI_BAND_THICKNESS] = band->thickness;
    e.p[VMI_BAND_WIDTH] = band->width;
    e.p[VMI_BAND_DENSITY] = band->density;
    e.p[VMI_BAND_SPEED] = band->speed;
    e.p[VMI_BAND_REACTIVE] = band->reactive;
    e.variant = band->by_layer != 0;
    return e;
}

#endif
/* scenes/links.h - rigid links and cords between bodies

   A link keeps the distance between two mass centres, or between a mass centre and a point with a given motion. A cord
   is a link that can pull but not push. The force of a link is the reaction to all other forces on its ends. Therefore
   a link stands last among the effects on a body, and a body has at most one link.

       vm_effect pendulum = vm_effect_link(0, VM_GROUND, pivot, NULL, 1, 0, 10); // 1 m long, hung up at pivot(t)

   Tests: tests/test_scene_links.c. */
#ifndef VARMASS_SCENES_LINKS_H
#define VARMASS_SCENES_LINKS_H

/* An end of a link: a body, which can accelerate, or a point whose motion is given */
typedef struct VM_TAG(vmi_link_end) {
    vm_real r[3], v[3];
    vm_real a[3];        /* acceleration without the link, m/s^2 */
    vm_real mobility[3]; /* acceleration per force along each coordinate: 1/mass, or 0 where the end cannot move */
} vmi_link_end;

VM_API void vmi_link_to_body(const vm_scene *s, int body, const vm_real *y, vmi_link_end *end)
{
    const vm_scene_body *b = s->bodies + body;
    const vm_real *r = y + b->at, *v = r + b->positions;
    const int n = vmi_scene_directions(b->motion);
    int i;
    for (i = 0; i < n; i++) {
        end->r[i] = r[i];
        end->v[i] = v[i];
        end->mobility[i] = 1 / (b->load.mass + b->load.extra_mass);
        end->a[i] = end->mobility[i] * b->load.force[i];
    }
    for (; i < 3; i++) {
        end->r[i] = 0;
        end->v[i] = 0;
        end->mobility[i] = 0;
        end->a[i] = 0;
    }
}

VM_API void vmi_link_to_point(const vm_effect *e, vm_real t, vmi_link_end *end)
{
    vm_vec3 r = {0, 0, 0}, v = {0, 0, 0}, a = {0, 0, 0};
    int i;
    e->point(t, &r, &v, &a, e->ctx);
    vmi_set3(end->r, r);
    vmi_set3(end->v, v);
    vmi_set3(end->a, a);
    for (i = 0; i < 3; i++) end->mobility[i] = 0;
}

enum { VMI_LINK_LENGTH, VMI_LINK_RATE }; /* indices of the parameters in p; the variant is 1 for a cord */

/* Computes the factor lambda of the force lambda d on the end `here`, where d leads from `there` to `here`. With the
   length l of the link, the deviation C = (d^2 - l^2)/2 obeys C'' + 2 rate C' + rate^2 C = 0. In this equation
   C' = d v and C'' = d a + v^2, where v and a are the velocity and acceleration of `here` relative to `there`. The
   link adds lambda times the sum of mobility d^2, over both ends and all coordinates, to d a. lambda is 0 for a slack
   cord. Returns VM_SINGULAR if the ends are in one place or cannot move along the link, and VM_NOT_FINITE if a number
   is not finite. */
VM_API int vmi_link_lambda(const vm_effect *e, const vmi_link_end *here, const vmi_link_end *there, vm_real *lambda)
{
    /* A cord does not pull while the distance of its ends is shorter than its length by more than this fraction. The
       fraction is larger than the uncertainty of the length, so that the cord does not alternate between taut and
       slack. */
    const vm_real loose = VM_C(1e-6) + 512 * VM_EPSILON;
    const vm_real length = e->p[VMI_LINK_LENGTH], rate = e->p[VMI_LINK_RATE];
    vm_real dd = 0, dv = 0, vv = 0, da = 0, mobility = 0, C; /* scalar products of d, v, a; sum of mobility d^2 */
    int i;
    for (i = 0; i < 3; i++) {
        const vm_real v = here->v[i] - there->v[i], d = here->r[i] - there->r[i];
        dd += d * d;
        dv += d * v;
        vv += v * v;
        da += d * (here->a[i] - there->a[i]);
        mobility += d * d * (here->mobility[i] + there->mobility[i]);
    }
    if (mobility == 0) return VM_SINGULAR;
    if (!(mobility > 0)) return VM_NOT_FINITE;
    C = (dd - length * length) / 2;
    *lambda = -(da + vv + 2 * rate * dv + rate * rate * C) / mobility;
    if (e->variant && (*lambda > 0 || C < -loose * dd)) *lambda = 0;
    return VM_OK;
}

VM_API void vmi_apply_link(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real *force = s->bodies[e->body].load.force;
    vm_real *far_force = e->other >= 0 ? s->bodies[e->other].load.force : NULL;
    vmi_link_end here, there;
    vm_real lambda = 0;
    int i, status;
    vmi_link_to_body(s, e->body, y, &here);
    if (far_force) vmi_link_to_body(s, e->other, y, &there);
    else vmi_link_to_point(e, t, &there);
    status = vmi_link_lambda(e, &here, &there, &lambda);
    if (status) s->status = status;
    if (lambda == 0) return;
    for (i = 0; i < 3; i++) {
        const vm_real d = here.r[i] - there.r[i];
        if (here.mobility[i] > 0) force[i] += lambda * d;
        if (far_force && there.mobility[i] > 0) far_force[i] -= lambda * d;
    }
}

VM_API int vmi_link_check(const vm_effect *e)
{
    if (e->p[VMI_LINK_LENGTH] > 0 && e->p[VMI_LINK_RATE] > 0) return VM_OK;
    return VM_DOMAIN;
}

/* A rigid link of a given length, or a cord, which can only pull. The link holds the mass centre of `body`, a point
   or a body in the plane, at the distance `length` (m) from another mass centre or from a moving point. The other
   mass centre is that of the body `other`, which is not on an axle; point is then NULL. With other = VM_GROUND the
   function `point` gives the motion of the point, which may lie above the plane. cord = 1 makes the link a cord.
   Deviations from the length decrease as exp(-rate t), with rate > 0 in 1/s. A cord that becomes taut at the speed v
   is stretched by about v/(e rate), where e = 2.718. A high rate makes the equations stiff: in float 100/s is tested
   for a cord of 1 m at 6 m/s.
   vm_scene_start returns VM_DOMAIN if length or rate is not positive, VM_BAD_MOTION for a growing body, whose mass
   centre moves in the body, VM_TWO_LINKS for a second link on a body, VM_LINK_NOT_LAST if another effect on the body
   follows the link, and VM_SAME_BODY for a link of a body with itself. A run ends with VM_SINGULAR if the ends are in
   one place or cannot move along the link. */
VM_API vm_effect vm_effect_link(int body, int other, vm_moving_point point, void *ctx, vm_real length, int cord,
                                vm_real rate)
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, point || other >= 0 ? vmi_apply_link : NULL);
    e.p[VMI_LINK_LENGTH] = length;
    e.p[VMI_LINK_RATE] = rate;
    e.variant = cord != 0;
    e.motions = VMI_FLAT;
    e.other_motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.order = VMI_ORDER_LINK;
    e.check = vmi_link_check;
    e.point = point;
    e.ctx = ctx;
    return e;
}

#endif
/* scenes/state.h - the state of a scene: its size, and the bodies in it

   The state y of a scene holds the numbers of the bodies, one body after the other. If the scene keeps a budget, its
   VM_BUDGET_STATES numbers follow. scene.h has a table of the numbers of each body.

       vm_body now;
       vm_scene_body_at(&scene, 0, y, &now); // now.r.x, now.v.x, now.mass: body 0 in the state y

   Tests: tests/test_scene_bodies.c. */
#ifndef VARMASS_SCENES_STATE_H
#define VARMASS_SCENES_STATE_H

enum { VM_BUDGET_STATES = 15 }; /* number of elements that a budget adds to the state */

/* The number of elements of work that vm_scene_run needs for a state of `size` numbers */
#define VM_SCENE_WORK(size) (RK45_WORK(size) + (size))

/* Whether a list can have n elements: n is not negative, and list is not NULL unless n is 0 */
VM_INLINE int vmi_scene_is_list(int n, const void *list)
{
    if (n > 0) return list != NULL;
    return n == 0;
}

/* Whether the lists of bodies and effects, which an evaluation reads, have possible lengths and are not NULL */
VM_INLINE int vmi_scene_has_lists(const vm_scene *s)
{
    return vmi_scene_is_list(s->n_bodies, s->bodies) && vmi_scene_is_list(s->n_effects, s->effects);
}

/* Number of elements of the state of a scene. It depends on the bodies and on whether the scene keeps a budget. Returns
   VM_BAD_ARGUMENT if scene is NULL, its bodies are missing or their number is negative. */
VM_API int vm_scene_size(const vm_scene *scene)
{
    int i, size = 0;
    if (!scene || !vmi_scene_is_list(scene->n_bodies, scene->bodies)) return VM_BAD_ARGUMENT;
    for (i = 0; i < scene->n_bodies; i++) size += vmi_scene_body_size(scene->bodies + i);
    if (scene->budget) size += VM_BUDGET_STATES;
    return size;
}

VM_API void vmi_scene_body_now(const vm_scene *s, int body, const vm_real *y, vm_body *now)
{
    const vm_scene_body *b = s->bodies + body;
    *now = b->start;
    now->mass = b->mass_is_state ? y[b->mass_at] : b->load.mass;
    now->inertia = b->inertia;
    b->get(b, y + b->at, now);
}

/* The motion of a body in the state y. The scene must have been started, and 0 <= body < n_bodies. If a law gives the
   mass, its value is that of the last evaluation of the right-hand side. All numbers of *now are NaN if no body has
   this index, if a pointer is NULL, and before a start. */
VM_API void vm_scene_body_at(const vm_scene *scene, int body, const vm_real *y, vm_body *now)
{
    const vm_vec3 none = {VM_NAN, VM_NAN, VM_NAN};
    if (!now) return;
    if (scene && scene->bodies && scene->size && y && body >= 0 && body < scene->n_bodies) {
        vmi_scene_body_now(scene, body, y, now);
        return;
    }
    now->mass = now->q.w = now->q.x = now->q.y = now->q.z = VM_NAN;
    now->inertia.xx = now->inertia.yy = now->inertia.zz = VM_NAN;
    now->inertia.xy = now->inertia.xz = now->inertia.yz = VM_NAN;
    now->r = now->v = now->omega = none;
}

/* Writes the motion `now` of a body into the state. The angle is a separate argument, since `now` does not include
   complete turns. */
VM_API void vmi_scene_put(vm_scene *s, int body, const vm_body *now, vm_real angle, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    b->mass = now->mass;
    b->inertia = now->inertia;
    if (b->mass_is_state) y[b->mass_at] = now->mass;
    b->put(b, now, angle, y + b->at);
}

/* Updates the field `idle` of all effects. An effect is idle if its body, or the body that takes the reaction, is not
   present, or if the effect is switched off. */
VM_API void vmi_scene_presence(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_effects; i++) {
        vm_effect *e = s->effects + i;
        const int away = s->bodies[e->body].away || (e->other >= 0 && s->bodies[e->other].away);
        e->idle &= VMI_IDLE_SWITCHED_OFF;
        if (away) e->idle |= VMI_IDLE_BODY_AWAY;
    }
}

#endif
/* scenes/evaluate.h - the right-hand side of a scene

   An evaluation clears the loads of all bodies, lets each effect add to them, and accelerates each body by its load.
   vm_scene_rhs is an ode_rhs, so that any integrator can run a scene without events:

       vm_real work[RK87_WORK(2)]; // 2 = vm_scene_size(&scene)
       rk87 run;
       rk87_init(&run, vm_scene_rhs, &scene, 2, 0, y, NULL, work); // scene and y after vm_scene_start

   Tests: tests/test_scene_effects.c. */
#ifndef VARMASS_SCENES_EVALUATE_H
#define VARMASS_SCENES_EVALUATE_H

#include <string.h>

/* Prepares the load of a body before the effects add to it: the mass becomes the present mass, and all sums become 0.
   Only forces on coordinates that the body has are set. */
VM_INLINE void vmi_scene_clear(vm_scene_body *b, const vm_real *y, int with_budget)
{
    vm_load *load = &b->load;
    load->force[0] = 0;
    if (b->coordinates > 1) load->force[1] = load->force[2] = 0;
    if (b->coordinates > 3) load->force[3] = load->force[4] = load->force[5] = 0;
    load->mass = b->mass_is_state ? y[b->mass_at] : b->mass;
    load->extra_mass = load->mass_by_v = load->mass_rate = 0;
    if (b->begin) b->begin(b, y + b->at);
    if (with_budget) {
        memset(load->reactive, 0, sizeof load->reactive);
        memset(load->brought, 0, sizeof load->brought);
        load->brought_energy = load->mixing = 0;
    }
}

/* Computes the loads of all bodies in the state y */
VM_INLINE void vmi_scene_evaluate(vm_scene *s, vm_real t, const vm_real *y)
{
    const int with_budget = s->budget != NULL;
    int i;
    for (i = 0; i < s->n_bodies; i++) vmi_scene_clear(s->bodies + i, y, with_budget);
    for (i = 0; i < s->n_effects; i++) {
        const vm_effect *e = s->effects + i;
        if (!e->idle) e->apply(e, t, y, s);
    }
}

/* The status that says which mass of the load is not positive or not finite, so that the body cannot be accelerated */
VMI_APART int vmi_scene_mass_status(const vm_load *load)
{
    if (!VM_IS_FINITE(load->mass) || !VM_IS_FINITE(load->extra_mass)) return VM_NOT_FINITE;
    if (load->mass > 0) return VM_NO_EFFECTIVE_MASS;
    return VM_BAD_MASS;
}

/* Writes the derivatives of the state of a body and returns a status. If the mass is a state, it must be positive in
   y as well, because an effect may have added to load->mass. */
VM_INLINE int vmi_scene_accelerate(const vm_scene_body *b, const vm_real *y, vm_real *dydt)
{
    const vm_load *load = &b->load;
    const vm_real effective = load->mass + load->extra_mass;
    if (!(load->mass > 0 && effective > 0 && effective <= VM_MAX)) return vmi_scene_mass_status(load);
    if (b->mass_is_state) {
        if (!(y[b->mass_at] > 0)) return VM_BAD_MASS;
        dydt[b->mass_at] = load->mass_rate;
    }
    return b->accelerate(b, y + b->at, dydt + b->at);
}

/* Handles an evaluation that failed: all derivatives become NaN, so that an integrator tries a shorter step. `before`
   is the status of the preceding evaluation. If the preceding evaluation failed too, its status is kept, because its
   NaN has caused this failure. */
VMI_APART void vmi_scene_refuse(vm_scene *s, int before, vm_real *dydt)
{
    int k;
    for (k = vm_scene_size(s) - 1; k >= 0; k--) dydt[k] = VM_NAN;
    if (before) s->status = before;
}

/* Sets the derivatives of a body that is not present to 0 */
VMI_APART void vmi_scene_clear_derivatives(const vm_scene_body *b, vm_real *dydt)
{
    int k;
    for (k = 0; k < vmi_scene_body_size(b); k++) dydt[b->at + k] = 0;
}

/* The right-hand side of a scene, an ode_rhs. ctx is the scene, which must have been started. Returns 0, or
   VM_BAD_ARGUMENT if a pointer is NULL or the number of bodies or effects is negative. If a body cannot be accelerated,
   for example because its mass is not positive, or if an effect cannot act, scene.status is the reason and all
   derivatives are NaN, so that an integrator tries a shorter step. */
VM_API int vm_scene_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_scene *s = (vm_scene *)ctx;
    int i, before;
    if (!s || !y || !dydt || !vmi_scene_has_lists(s)) return VM_BAD_ARGUMENT;
    before = s->status;
    s->status = VM_OK;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        int status = 0;
        if (b->away) vmi_scene_clear_derivatives(b, dydt);
        else status = vmi_scene_accelerate(b, y, dydt);
        if (status && !s->status) s->status = status;
    }
    if (s->budget) s->budget->rates(s, y, dydt + vm_scene_size(s) - VM_BUDGET_STATES);
    if (s->status) vmi_scene_refuse(s, before, dydt);
    return 0;
}

#endif
/* scenes/check.h - what can be wrong with a scene

   vm_scene_check examines bodies, effects and events once, before a run, and reports what is wrong and where.
   vm_scene_start calls vm_scene_check.

       vm_scene_fault fault;
       int status = vm_scene_check(&scene, &fault);
       if (status < 0) printf("%s %d: %s\n", fault.kind, fault.index, vm_strerror(status)); // effect 1: no body has ...

   Tests: tests/test_scene_runs.c, tests/test_scene_bodies.c, tests/test_refusals_scenes.c. */
#ifndef VARMASS_SCENES_CHECK_H
#define VARMASS_SCENES_CHECK_H

/* The part of a scene in which a fault is */
typedef struct VM_TAG(vm_scene_fault) {
    const char *kind; /* "body", "effect" or "event"; "scene" for an array of the scene, and if nothing is wrong */
    int index;        /* index of the body, effect or event; -1 for the scene itself */
} vm_scene_fault;

VM_API int vmi_scene_check_body(const vm_scene_body *b)
{
    if (b->status) return b->status;
    if (b->motion < VM_LINE || b->motion > VM_FREE || !b->put) return VM_BAD_MOTION;
    if (!vmi_body_is_finite(&b->start) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->start.mass > 0) && b->motion == VM_AXLE) return VM_BAD_INERTIA; /* on an axle `mass` is the inertia */
    if (!(b->start.mass > 0)) return VM_BAD_MASS;
    if (b->check) return (b->check)(&b->start);
    return VM_OK;
}

/* Checks that a body and its coordinate exist. A free body has six velocities, but only three coordinates, since its
   rotation has none. */
VM_API int vmi_scene_check_coordinate(const vm_scene *s, int body, int coordinate)
{
    if (body < 0 || body >= s->n_bodies) return VM_NO_SUCH_BODY;
    if (coordinate < 0 || coordinate >= s->bodies[body].coordinates) return VM_NO_SUCH_COORDINATE;
    if (s->bodies[body].motion == VM_FREE && coordinate > 2) return VM_NO_SUCH_COORDINATE;
    return VM_OK;
}

/* Checks where an effect stands in the list, among the effects on a body: a mass law stands first and a link last, and
   there is at most one of each. b->listed_orders has a bit for the order of each effect on the body that stands earlier
   in the list. */
VM_API int vmi_scene_check_order(vm_scene_body *b, int order)
{
    const int law = 1 << VMI_ORDER_MASS_LAW, force = 1 << VMI_ORDER_FORCE, link = 1 << VMI_ORDER_LINK;
    const int before = b->listed_orders;
    b->listed_orders |= 1 << order;
    if (order == VMI_ORDER_MASS_LAW && ((before & law) || b->mass_is_state)) return VM_TWO_MASS_LAWS;
    if (order == VMI_ORDER_LINK && (before & link)) return VM_TWO_LINKS;
    if (order == VMI_ORDER_MASS_LAW && (before & (force | link))) return VM_BAD_ORDER;
    if (order == VMI_ORDER_FORCE && (before & link)) return VM_LINK_NOT_LAST;
    return VM_OK;
}

/* Checks that the bodies of an effect have motions on which it can act. A link holds mass centres, so that it cannot
   act on a growing body, whose mass centre moves in the body. */
VM_API int vmi_scene_check_motions(const vm_scene *s, const vm_effect *e)
{
    const vm_scene_body *b = s->bodies + e->body, *other = e->other == VM_GROUND ? NULL : s->bodies + e->other;
    if (!(e->motions >> b->motion & 1)) return VM_BAD_MOTION;
    if (e->not_on_angle && b->motion == VM_PLANE && e->coordinate == 2) return VM_NOT_ON_ANGLE;
    if (other && !(e->other_motions >> other->motion & 1)) return VM_BAD_MOTION;
    if (e->order != VMI_ORDER_LINK) return VM_OK;
    if (other == b) return VM_SAME_BODY;
    if (b->grows || (other && other->grows)) return VM_BAD_MOTION;
    return VM_OK;
}

VM_API int vmi_scene_check_parameters(const vm_scene_body *b, const vm_effect *e)
{
    const int own = e->check ? (e->check)(e) : VM_OK;
    int k;
    for (k = 0; k < VM_LENGTH(e->p); k++)
        if (!VM_IS_FINITE(e->p[k])) return vmi_first_error(VM_NOT_FINITE, own);
    if (e->needs >= VMI_NEEDS_MASS_STATE && !b->mass_is_state) return VM_MASS_IS_NO_STATE;
    if (e->needs >= VMI_NEEDS_GROWING_BODY && !b->grows) return VM_DOES_NOT_GROW;
    return own;
}

VM_API int vmi_scene_check_effect(const vm_scene *s, const vm_effect *e)
{
    int status = vmi_scene_check_coordinate(s, e->body, e->coordinate);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_coordinate(s, e->other, e->other_coordinate);
    if (!status && !e->apply) status = VM_BAD_ARGUMENT;
    if (!status) status = vmi_scene_check_motions(s, e);
    if (!status) status = vmi_scene_check_parameters(s->bodies + e->body, e);
    if (!status) status = vmi_scene_check_order(s->bodies + e->body, e->order);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_order(s->bodies + e->other, e->order);
    return status;
}

/* Whether a body of one motion can take up or give off a body of another motion. Both must have the same motion,
   except that a body in the plane or in space can also take up or give off a point, which has no rotation. */
VM_API int vmi_scene_can_jump(int motion, int other)
{
    return motion == other || (other == VM_POINT && motion > VM_AXLE);
}

/* Checks a jump. A part that separates becomes a body of the scene that was absent. The function also checks that this
   body can have the mass, inertia and motion of the part. */
VM_API int vmi_scene_check_jump(const vm_scene *s, const vm_event *e)
{
    int status = vmi_scene_check_coordinate(s, e->jump_body, 0);
    vm_scene_body part;
    if (!status) status = vmi_scene_check_coordinate(s, e->other, 0);
    if (!status && e->jump_body == e->other) status = VM_SAME_BODY;
    if (status) return status;
    if (!vmi_scene_can_jump(s->bodies[e->jump_body].motion, s->bodies[e->other].motion)) return VM_BAD_MOTION;
    if (!(e->motions >> s->bodies[e->jump_body].motion & 1)) return VM_BAD_MOTION;
    if (!vmi_impulse_is_finite(&e->external)) return VM_NOT_FINITE;
    if (e->jump_kind == VMI_JUMP_ATTACHES) return VM_OK;
    part = s->bodies[e->other];
    part.start = e->part;
    return vmi_scene_check_body(&part);
}

VM_API int vmi_scene_check_event(const vm_scene *s, const vm_event *e)
{
    int status = VM_OK;
    if (e->watches) status = vmi_scene_check_coordinate(s, e->body, e->coordinate);
    if (status) return status;
    if (e->status) return e->status;
    if (e->most < 0) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(e->time) || !VM_IS_FINITE(e->value)) return VM_NOT_FINITE;
    if (e->switches && (e->effect < 0 || e->effect >= s->n_effects)) return VM_NO_SUCH_EFFECT;
    if (e->check) return (e->check)(s, e);
    return VM_OK;
}

VM_API int vmi_scene_check_arrays(const vm_scene *s)
{
    int i;
    if (!s || s->n_bodies < 1 || !s->bodies) return VM_BAD_ARGUMENT;
    if (s->n_effects < 0 || (s->n_effects && !s->effects)) return VM_BAD_ARGUMENT;
    if (s->n_events < 0 || (s->n_events && (!s->events || !s->located))) return VM_BAD_ARGUMENT;
    if (!s->times) return VM_OK;
    if (s->n_times < 0) return VM_BAD_ARGUMENT;
    for (i = 0; i < s->n_times; i++) {
        if (!VM_IS_FINITE(s->times[i])) return VM_NOT_FINITE;
        if (i > 0 && !(s->times[i] > s->times[i - 1])) return VM_BAD_TIMES;
    }
    return VM_OK;
}

VM_API void vmi_scene_set_fault(vm_scene_fault *fault_or_NULL, const char *kind, int index)
{
    if (!fault_or_NULL) return;
    fault_or_NULL->kind = kind;
    fault_or_NULL->index = index;
}

/* The first thing that is wrong with a scene, or VM_OK. Returns the status of this fault, and writes to
   *fault_or_NULL in which body, effect or event it is. The time of this check is proportional to the number of
   bodies, effects and events. The statuses are those in the comments of the constructors, and
     VM_BAD_ARGUMENT        if a pointer is NULL, a count is negative, or a body or a function is missing;
     VM_NOT_FINITE          if a parameter, a time or a number of a body is infinite or NaN;
     VM_BAD_MASS, VM_BAD_INERTIA, VM_BAD_MOTION       for a body, or for the part that separates;
     VM_NO_SUCH_BODY, VM_NO_SUCH_COORDINATE, VM_NO_SUCH_EFFECT      for an index that does not exist;
     VM_TWO_MASS_LAWS, VM_BAD_ORDER, VM_TWO_LINKS, VM_LINK_NOT_LAST   for the list of effects;
     VM_BAD_TIMES           if the times of output do not increase. */
VM_API int vm_scene_check(const vm_scene *scene, vm_scene_fault *fault_or_NULL)
{
    int i, status = vmi_scene_check_arrays(scene);
    vmi_scene_set_fault(fault_or_NULL, "scene", -1);
    if (status) return status;
    for (i = 0; i < scene->n_bodies; i++) {
        scene->bodies[i].listed_orders = 0;
        status = vmi_scene_check_body(scene->bodies + i);
        if (!status) continue;
        vmi_scene_set_fault(fault_or_NULL, "body", i);
        return status;
    }
    for (i = 0; i < scene->n_effects; i++) {
        status = vmi_scene_check_effect(scene, scene->effects + i);
        if (!status) continue;
        vmi_scene_set_fault(fault_or_NULL, "effect", i);
        return status;
    }
    for (i = 0; i < scene->n_events; i++) {
        status = vmi_scene_check_event(scene, scene->events + i);
        if (!status) continue;
        vmi_scene_set_fault(fault_or_NULL, "event", i);
        return status;
    }
    return VM_OK;
}

#endif
/* scenes/start.h - the start of a scene

   vm_scene_start checks a scene, fills its state, and connects effects and events with the bodies on which they act.

       vm_real y[2]; // 2 = vm_scene_size(&scene)
       vm_scene_fault fault;
       int status = vm_scene_start(&scene, 0, y, &fault); // at t = 0

   Tests: tests/test_scene_runs.c. */
#ifndef VARMASS_SCENES_START_H
#define VARMASS_SCENES_START_H

#include <string.h>

/* Returns 1 if vm_scene_start has started the scene and its lists have not visibly changed since then, else 0. The
   state may be shorter than at the start, since a scene may end its budget. */
VM_API int vmi_scene_is_started(const vm_scene *s)
{
    int i;
    if (!s->size || vm_scene_size(s) > s->size) return 0;
    for (i = 0; i < s->n_effects; i++)
        if (!s->effects[i].load || !s->effects[i].apply) return 0;
    for (i = 0; i < s->n_events; i++)
        if (s->events[i].scene != s) return 0;
    return 1;
}

/* The function whose zeros the integrator locates to find an event. ctx points to a vm_event of the scene. For an event
   at a set time the function is 1, so that it has no zeros. */
VM_API vm_real vmi_scene_when(vm_real t, const vm_real *y, void *ctx)
{
    const vm_event *e = (const vm_event *)ctx;
    if (e->when) return e->when(e, t, y);
    return 1;
}

/* Prepares s->located[i], the integrator's event for the event s->events[i] of the scene. If s->events[i] is only
   counted and may happen without limit, the action is ODE_RECORD, which does not end a step; else it is ODE_STOP. */
VM_API void vmi_scene_locate(vm_scene *s, int i)
{
    ode_event *located = s->located + i;
    memset(located, 0, sizeof *located);
    located->g = vmi_scene_when;
    located->ctx = s->events + i;
    located->direction = s->events[i].direction;
    located->action = ODE_STOP;
    if (!s->events[i].then && !s->events[i].most) located->action = ODE_RECORD;
}

/* Stores in an effect the indices of its coordinates in the state and the pointers to the loads of its bodies. If the
   effect acts against the ground, other_coordinate is not used. */
VM_API void vmi_scene_bind(vm_scene *s, vm_effect *e)
{
    vm_scene_body *b = s->bodies + e->body, *other = e->other >= 0 ? s->bodies + e->other : NULL;
    e->idle = 0;
    if (e->off) e->idle = VMI_IDLE_SWITCHED_OFF;
    e->load = &b->load;
    e->other_load = NULL;
    e->x = b->at + e->coordinate;
    e->v = e->x + b->positions;
    e->other_x = e->x;
    e->other_v = e->v;
    if (!other) return;
    e->other_load = &other->load;
    e->other_x = other->at + e->other_coordinate;
    e->other_v = e->other_x + other->positions;
}

/* Writes the motions of all bodies at the start into the state. Returns the index of the first number of the budget. */
VM_API int vmi_scene_place_bodies(vm_scene *s, vm_real *y)
{
    int i, k, at = 0;
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        b->at = at;
        b->mass_at = at + vmi_scene_mass_at(b);
        b->away = b->absent;
        b->law_offset = 0;
        for (k = 0; k < vmi_scene_body_size(b); k++) y[at++] = 0;
        vmi_scene_put(s, i, &b->start, b->angle, y);
    }
    return at;
}

VM_API void vmi_scene_reset_events(vm_scene *s, vm_real t)
{
    int i;
    for (i = 0; i < s->n_events; i++) {
        vm_event *e = s->events + i;
        e->scene = s;
        e->count = e->seen = 0;
        if (e->when) e->time = t;
        vmi_scene_locate(s, i);
    }
}

/* Start of a scene at time t: checks it and fills its state y. y receives vm_scene_size(scene) numbers. Returns
   VM_OK, or a status of vm_scene_check, which writes to *fault_or_NULL where the fault is; VM_BAD_ARGUMENT if y is
   NULL; VM_NOT_FINITE if t is not finite; VM_SHORT_ARRAY if scene.y_size is set and too small. y is unchanged if the
   start fails. After the start the arrays of the scene must stay where they are. */
VM_API int vm_scene_start(vm_scene *scene, vm_real t, vm_real *y, vm_scene_fault *fault_or_NULL)
{
    int i, end, status = vm_scene_check(scene, fault_or_NULL);
    if (status) return status;
    if (!y) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (scene->y_size && scene->y_size < vm_scene_size(scene)) return VM_SHORT_ARRAY;
    scene->size = vm_scene_size(scene);
    end = vmi_scene_place_bodies(scene, y);
    for (i = 0; i < scene->n_effects; i++) vmi_scene_bind(scene, scene->effects + i);
    vmi_scene_reset_events(scene, t);
    vmi_scene_presence(scene);
    vmi_scene_evaluate(scene, t, y);
    scene->status = VM_OK;
    if (scene->budget) scene->budget->open(scene, y, y + end);
    return VM_OK;
}

#endif
/* scenes/balance.h - the budget of momentum, angular momentum and energy of a scene

   A scene that keeps a budget integrates its supply from outside together with the motion of its bodies: the impulse
   and the work of the effects, and the momentum and energy of streams. At any time the momentum and energy of the
   bodies must equal those at the start plus this supply. The difference is called the defect. It shows the error of a
   run and the reactions of constraints.

       vm_real t = 0, y[2 + VM_BUDGET_STATES], work[VM_SCENE_WORK(2 + VM_BUDGET_STATES)];
       vm_budget budget, now;
       int status;
       vm_scene_keep_budget(&scene, &budget); // scene is a vm_scene, not yet started
       status = vm_scene_start(&scene, t, y, NULL);
       if (status == VM_OK) status = vm_scene_run(&scene, &t, 10, y, work, NULL);
       if (status >= 0) vm_scene_budget_at(&scene, t, y, &now); // now.momentum_defect, now.energy_defect

   Tests: tests/test_scene_runs.c, tests/test_scene_streams.c. */
#ifndef VARMASS_SCENES_BALANCE_H
#define VARMASS_SCENES_BALANCE_H

#include <string.h>

/* Indices of the sums of the budget among the VM_BUDGET_STATES numbers that it adds to the state */
enum {
    VMI_BUDGET_IMPULSE = 0,
    VMI_BUDGET_ANGULAR_IMPULSE = 3,
    VMI_BUDGET_BROUGHT = 6,
    VMI_BUDGET_BROUGHT_ANGULAR = 9,
    VMI_BUDGET_WORK = 12,
    VMI_BUDGET_BROUGHT_ENERGY = 13,
    VMI_BUDGET_MIXING = 14
};

VM_INLINE void vmi_add3(vm_vec3 a, vm_real *sum)
{
    sum[0] += a.x;
    sum[1] += a.y;
    sum[2] += a.z;
}

/* Adds the load of a body to the rates of the budget's sums */
VM_API void vmi_scene_enter_loads(const vm_scene_body *b, const vm_real *y, vm_real *rates)
{
    const vm_load *load = &b->load;
    const vm_real *state = y + b->at;
    const vm_vec3 r = vmi_scene_moving(b, state), v = vmi_scene_moving(b, state + b->positions);
    const vm_vec3 force = vmi_sub(vmi_scene_moving(b, load->force), vmi_scene_moving(b, load->reactive));
    const vm_vec3 torque = vmi_sub(vmi_scene_turning(b, load->force), vmi_scene_turning(b, load->reactive));
    const vm_vec3 brought = vmi_scene_moving(b, load->brought), turning = vmi_scene_turning(b, load->brought);
    vmi_add3(force, rates + VMI_BUDGET_IMPULSE);
    vmi_add3(vmi_add(torque, vmi_cross(r, force)), rates + VMI_BUDGET_ANGULAR_IMPULSE);
    vmi_add3(brought, rates + VMI_BUDGET_BROUGHT);
    vmi_add3(vmi_add(turning, vmi_cross(r, brought)), rates + VMI_BUDGET_BROUGHT_ANGULAR);
    rates[VMI_BUDGET_WORK] += vmi_dot(force, v) + vmi_dot(torque, vmi_scene_spin(b, y));
    rates[VMI_BUDGET_BROUGHT_ENERGY] += load->brought_energy;
    rates[VMI_BUDGET_MIXING] += load->mixing;
}

/* Adds the contribution of a body to the rates of the budget's sums. For a mass law M(v) the term dM/dv v' of the mass
   rate is added only here, because v' is known only after all effects have added their forces. */
VM_API void vmi_scene_enter(vm_scene_body *b, const vm_real *y, vm_real *rates)
{
    vm_load *load = &b->load;
    if (load->mass_by_v != 0) {
        const vm_real mass_rate = load->mass_by_v * (load->force[0] / (load->mass + load->extra_mass));
        const vm_real faster = load->joining_v - y[b->at + 1];
        load->brought[0] += mass_rate * load->joining_v;
        load->brought_energy += mass_rate * load->joining_v * load->joining_v / 2;
        load->mixing += mass_rate * faster * faster / 2;
    }
    vmi_scene_enter_loads(b, y, rates);
}

/* Computes the rates of the budget's sums. The loads in the state y must have been evaluated before. */
VM_API void vmi_scene_rates(vm_scene *s, const vm_real *y, vm_real *rates)
{
    int i;
    for (i = 0; i < VM_BUDGET_STATES; i++) rates[i] = 0;
    for (i = 0; i < s->n_bodies; i++)
        if (!s->bodies[i].away) vmi_scene_enter(s->bodies + i, y, rates);
}

/* Momentum, angular momentum about the origin and kinetic energy of all bodies that are present. A body on an axle has
   its inertia in place of the mass, and no momentum. */
VM_API void vmi_scene_totals(const vm_scene *s, const vm_real *y, vm_budget *budget)
{
    const vm_vec3 zero = {0, 0, 0};
    int i;
    budget->momentum = budget->angular_momentum = zero;
    budget->energy = 0;
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        vm_body now;
        vm_vec3 p, spin;
        if (b->away) continue;
        vmi_scene_body_now(s, i, y, &now);
        if (b->motion == VM_AXLE) now.mass = 0;
        p = vmi_scale(now.mass, now.v);
        spin = vmi_spin_momentum(&now);
        budget->momentum = vmi_add(budget->momentum, p);
        budget->angular_momentum = vmi_add(budget->angular_momentum, vmi_add(spin, vmi_cross(now.r, p)));
        budget->energy += (vmi_dot(p, now.v) + vmi_dot(spin, now.omega)) / 2;
    }
}

/* Begins the budget at the start of the scene: stores the momentum and energy of the bodies, and sets the sums to 0 */
VM_API void vmi_scene_open_budget(vm_scene *s, const vm_real *y, vm_real *sums)
{
    const vm_budget functions = *s->budget;
    int i;
    memset(s->budget, 0, sizeof *s->budget);
    s->budget->open = functions.open;
    s->budget->rates = functions.rates;
    s->budget->totals = functions.totals;
    vmi_scene_totals(s, y, s->budget);
    for (i = 0; i < VM_BUDGET_STATES; i++) sums[i] = 0;
}

/* Makes a scene keep a budget of momentum, angular momentum and energy. If budget_or_NULL is NULL, the scene keeps
   none. Call this function before vm_scene_start. The state then has VM_BUDGET_STATES further numbers.
   *budget_or_NULL must stay where it is; the scene stores in it its momentum and energy at the start. Between two
   runs a scene may end its budget, but not begin one. */
VM_API void vm_scene_keep_budget(vm_scene *scene, vm_budget *budget_or_NULL)
{
    if (!scene) return;
    scene->budget = budget_or_NULL;
    if (!budget_or_NULL) return;
    memset(budget_or_NULL, 0, sizeof *budget_or_NULL);
    budget_or_NULL->open = vmi_scene_open_budget;
    budget_or_NULL->rates = vmi_scene_rates;
    budget_or_NULL->totals = vmi_scene_totals;
}

/* The budget of a scene in the state y at time t. It has the momentum and energy of the bodies, the supply from outside
   since the start, and the defects. Defects come from rounding, from the errors of the integrator, and from
   constraints: a line, an axle and the plane hold a body by reactions, which the supply does not include. Returns
   VM_BAD_ARGUMENT if the scene keeps no budget, a pointer is NULL or a count is negative, VM_NOT_STARTED before a
   start, VM_NOT_FINITE if the state is not finite, and else VM_OK. */
VM_API int vm_scene_budget_at(vm_scene *scene, vm_real t, const vm_real *y, vm_budget *budget)
{
    const vm_budget *start = scene ? scene->budget : NULL;
    const vm_real *sums;
    vm_budget b;
    if (!start || !y || !budget || !vmi_scene_has_lists(scene) || scene->n_events < 0) return VM_BAD_ARGUMENT;
    if (!vmi_scene_is_started(scene)) return VM_NOT_STARTED;
    if (!vmi_all_finite(vm_scene_size(scene), y)) return VM_NOT_FINITE;
    b = *start;
    sums = y + vm_scene_size(scene) - VM_BUDGET_STATES;
    vmi_scene_evaluate(scene, t, y);
    vmi_scene_totals(scene, y, &b);
    b.impulse = vmi_add(start->impulse, vmi_get3(sums + VMI_BUDGET_IMPULSE));
    b.angular_impulse = vmi_add(start->angular_impulse, vmi_get3(sums + VMI_BUDGET_ANGULAR_IMPULSE));
    b.brought = vmi_get3(sums + VMI_BUDGET_BROUGHT);
    b.brought_angular = vmi_get3(sums + VMI_BUDGET_BROUGHT_ANGULAR);
    b.work = sums[VMI_BUDGET_WORK];
    b.brought_energy = sums[VMI_BUDGET_BROUGHT_ENERGY];
    b.mixing = sums[VMI_BUDGET_MIXING];
    b.momentum_defect = vmi_sub(vmi_sub(b.momentum, start->momentum), vmi_add(b.impulse, b.brought));
    b.angular_defect = vmi_sub(vmi_sub(b.angular_momentum, start->angular_momentum),
                               vmi_add(b.angular_impulse, b.brought_angular));
    b.energy_defect = b.energy - start->energy - (b.work + b.brought_energy - b.mixing + b.jump_energy);
    *budget = b;
    return VM_OK;
}

#endif
/* scenes/events.h - when an event happens, and what it does

   An event is made in two steps: vm_event_... says when it happens, and vm_then_... says what happens then. An event
   takes only one vm_then_... function. An event without such a function is only counted: event.count says how often
   it has happened and event.time when it last happened, and the motion is the same as without the event.

       vm_event events[] = {vm_then_switch(vm_event_at(60), 3, 1),              // at 60 s effect 3 goes off
                            vm_then_stop(vm_event_position(0, 0, 0.5, 1))};     // the run ends where x rises to 0.5 m
       ode_event located[2];                                                    // one for each event
       vm_scene scene;
       memset(&scene, 0, sizeof scene);                                         // its bodies and effects: see scene.h
       scene.events = events;
       scene.located = located;
       scene.n_events = 2;

   An event at a time happens once. A crossing of a value happens at most event.most times, or without limit if
   event.most is 0; direction > 0 counts rising values, direction < 0 falling values, and direction = 0 both. Only
   motion causes a crossing: there is none if an event moves a coordinate beyond the value, or while the body is not
   present. Events at one instant happen in the order of the list; if the times of a jump and of a crossing differ
   only by rounding errors, either of the two may happen first. To get the times (or states) of all events of one run,
   set scene.located[i].times (or .states) and .room after the start.

   Tests: tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_EVENTS_H
#define VARMASS_SCENES_EVENTS_H

#include <string.h>

/* An event that watches a coordinate of a body */
VM_API vm_event vmi_event(int body, int coordinate, vm_real value, int direction)
{
    vm_event e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.value = value;
    e.direction = direction;
    e.watches = 1;
    return e;
}

/* An event at a time in s, which happens once. If the time is before the start of the run, the event happens as the run
   begins. */
VM_API vm_event vm_event_at(vm_real time)
{
    vm_event e = vmi_event(0, 0, 0, 0);
    e.time = time;
    e.watches = 0;
    e.most = 1;
    return e;
}

VM_API vm_real vmi_when_position(const vm_event *e, vm_real t, const vm_real *y)
{
    (void)t;
    return y[e->scene->bodies[e->body].at + e->coordinate] - e->value;
}

/* An event when a position crosses a value. The position is a coordinate of a body, and value is in m or rad. */
VM_API vm_event vm_event_position(int body, int coordinate, vm_real value, int direction)
{
    vm_event e = vmi_event(body, coordinate, value, direction);
    e.when = vmi_when_position;
    return e;
}

VM_API vm_real vmi_when_velocity(const vm_event *e, vm_real t, const vm_real *y)
{
    const vm_scene_body *b = e->scene->bodies + e->body;
    (void)t;
    return y[b->at + b->positions + e->coordinate] - e->value;
}

/* An event when a velocity crosses a value. The velocity is that of a coordinate of a body, and value is in m/s or
   rad/s. */
VM_API vm_event vm_event_velocity(int body, int coordinate, vm_real value, int direction)
{
    vm_event e = vmi_event(body, coordinate, value, direction);
    e.when = vmi_when_velocity;
    return e;
}

VM_API vm_real vmi_when_mass(const vm_event *e, vm_real t, const vm_real *y)
{
    const vm_scene_body *b = e->scene->bodies + e->body;
    if (b->mass_is_state) return y[b->mass_at] - e->value;
    vmi_scene_evaluate(e->scene, t, y);
    return b->load.mass - e->value;
}

/* An event when a mass crosses a value. value in kg (on an axle kg m^2) should be positive, since a run ends before a
   mass reaches 0. */
VM_API vm_event vm_event_mass(int body, vm_real value, int direction)
{
    vm_event e = vmi_event(body, 0, value, direction);
    e.when = vmi_when_mass;
    return e;
}

VM_API vm_real vmi_when_user(const vm_event *e, vm_real t, const vm_real *y) { return e->user_when(t, y, e->ctx); }

/* An event when a function of the caller crosses zero. when(t, y, ctx) receives the state of the whole scene.
   vm_scene_start returns VM_BAD_ARGUMENT if when is NULL. */
VM_API vm_event vm_event_user(vm_real (*when)(vm_real t, const vm_real *y, void *ctx), void *ctx, int direction)
{
    vm_event e = vmi_event(0, 0, 0, direction);
    e.watches = 0;
    e.when = when ? vmi_when_user : NULL;
    e.user_when = when;
    e.ctx = ctx;
    if (!when) e.status = VM_BAD_ARGUMENT;
    return e;
}

VM_API int vmi_then_stop(vm_event *e, vm_real t, vm_real *y)
{
    (void)e;
    (void)t;
    (void)y;
    return VM_STOPPED;
}

/* The event ends the run. vm_scene_run then returns VM_STOPPED. */
VM_API vm_event vm_then_stop(vm_event event)
{
    event.then = vmi_then_stop;
    return event;
}

/* Stores the masses of all bodies, which vmi_scene_hold_masses restores after a change */
VM_API void vmi_scene_note_masses(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) s->bodies[i].noted_mass = s->bodies[i].load.mass;
}

/* Gives all bodies the masses that vmi_scene_note_masses has stored. Otherwise a jump, or the switching of a mass
   law, would change a mass although no stream carries mass and momentum. The loads are evaluated twice: first to find
   by how much the masses of the laws differ from the stored ones, then again with the corrected masses. A body with a
   mass law uses the field `law_offset`, any other body the field `mass`. Both fields are corrected, because the
   unused one has no effect. */
VM_API void vmi_scene_hold_masses(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        const vm_real lacking = b->noted_mass - b->load.mass;
        if (b->away || b->mass_is_state) continue;
        b->mass += lacking;
        b->law_offset += lacking;
    }
    vmi_scene_evaluate(s, t, y);
}

VM_API int vmi_then_switch(vm_event *e, vm_real t, vm_real *y)
{
    vm_scene *s = e->scene;
    vm_effect *effect = s->effects + e->effect;
    vmi_scene_evaluate(s, t, y);
    vmi_scene_note_masses(s);
    effect->idle &= VMI_IDLE_BODY_AWAY;
    if (e->off) effect->idle |= VMI_IDLE_SWITCHED_OFF;
    vmi_scene_hold_masses(s, t, y);
    return VM_OK;
}

/* The event switches an effect off (off = 1) or on (off = 0). effect is the index of the effect. Switching a mass law
   does not change the mass at this instant: the law continues from the present mass. vm_scene_start returns
   VM_NO_SUCH_EFFECT if no effect has this index. */
VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    event.then = vmi_then_switch;
    event.effect = effect;
    event.off = off != 0;
    event.switches = 1;
    return event;
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

/* The event calls a function of the caller. then(t, y, ctx) may change y and returns a status: VM_OK to continue, or
   VM_STOPPED or a negative number, with which the run ends. vm_scene_start returns VM_BAD_ARGUMENT if then is NULL. */
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = vmi_then_user;
    if (!then) event.status = VM_BAD_ARGUMENT;
    event.user_then = then;
    event.then_ctx = ctx;
    return event;
}

#endif
/* scenes/jumps.h - separation and attachment as events of a scene

   An event can separate a part from a body, or attach one body to another, by the laws of mechanics/jumps.h. A part
   that separates becomes another body of the scene, which must be absent before; an attached body is absent
   afterwards.

       vm_scene_body bodies[] = {vm_scene_body_line(5, 0, 10), vm_scene_body_absent(vm_scene_body_line(1, 0, 0))};
       vm_body part;
       memset(&part, 0, sizeof part);
       part.mass = 1;   // kg
       part.v.x = 2;    // m/s faster than the body
       vm_event drop = vm_then_separate_on_line(vm_event_at(3), 0, 1, &part, 1);

   The caller gives the motion of a part just after the jump. If relative is 0, it is given in inertial axes. If
   relative is 1, it is given in the axes of the body: r leads from the mass centre of the body to the part, and q, v
   and omega are relative to the motion of the body at this point. In the plane and on an axle the new body has the
   angle of the body from which it separates, plus the angle with which it was made. event.external is an impulse that
   acts from outside during the jump.

   Two bodies can jump together if they have the same motion. A body in the plane or a free body can also take up or
   give off a point. The functions whose names end in _on_line (line or axle) and _in_plane do the same as
   vm_then_separate and vm_then_attach for these motions only, and link less code (docs/scene-sizes.md). If a point
   takes up a body at another place, the angular momentum of both about their common mass centre is lost, since a point
   does not rotate; angular_defect of the budget shows this loss.

   A run ends with VM_IS_THERE if a part would become a body that is present already, with VM_IS_AWAY if a body that
   jumps is not present, and with the errors of vm_separate and vm_attach. vm_scene_start returns VM_BAD_MOTION for
   bodies that cannot jump together, VM_SAME_BODY for a body with itself, and the status of vm_scene_check for a part
   that cannot be a body.

   Tests: tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_JUMPS_H
#define VARMASS_SCENES_JUMPS_H

/* Computes the jump on a line and on an axle. With sign = -1 for a part that separates and 1 for a body that is
   attached, the velocity becomes v1 = (M v + sign m v2 + impulse)/(M + sign m) (24), and the mass centre moves by the
   fraction sign m/(M + sign m) of the way to the mass centre of the part (15). M and v belong to the body, m and v2
   to the part; on an axle M and m are moments of inertia. Line and axle use the same formulas: the numbers that a
   motion does not need are 0. */
VM_API int vmi_event_jump_on_line(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const vm_real m = e->jump_kind == VMI_JUMP_SEPARATES ? -other->mass : other->mass, mass = body->mass + m;
    if (e->relative) {
        other->r.x += body->r.x;
        other->v.x += body->v.x;
        other->omega.z += body->omega.z;
    }
    *b = *body;
    if (!(mass > 0)) return VM_BAD_MASS;
    b->mass = mass;
    b->v.x = (body->mass * body->v.x + m * other->v.x + e->external.linear.x) / mass;
    b->omega.z = (body->mass * body->omega.z + m * other->omega.z + e->external.couple.z) / mass;
    b->r.x = body->r.x + m / mass * (other->r.x - body->r.x);
    return VM_OK;
}

/* Converts *part from motion relative to *body, in the axes of *body, to motion in inertial axes */
VM_API void vmi_event_jump_place(const vm_body *body, vm_body *part)
{
    const vmi_mat3 turn = vmi_rotation(body->q);
    const vm_vec3 d = vmi_times(&turn, part->r);
    part->r = vmi_add(body->r, d);
    part->v = vmi_add(vmi_times(&turn, part->v), vmi_add(body->v, vmi_cross(body->omega, d)));
    part->omega = vmi_add(vmi_times(&turn, part->omega), body->omega);
    part->q = vmi_quat_is_none(part->q) ? body->q : vmi_quat_times(body->q, part->q);
}

VM_API vm_impulse2 vmi_event_impulse2(const vm_impulse *external)
{
    vm_impulse2 j;
    j.jx = external->linear.x;
    j.jy = external->linear.y;
    j.couple = external->couple.z;
    j.x = external->at.x;
    j.y = external->at.y;
    return j;
}

/* Computes the jump in the plane. Returns VM_BAD_INERTIA if the remaining body has no inertia, because it is then a
   point and cannot be a body in the plane. */
VM_API int vmi_event_jump_in_plane(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const vm_impulse2 external = vmi_event_impulse2(&e->external);
    vm_body2 one, two, result;
    int status;
    if (e->relative) vmi_event_jump_place(body, other);
    one = vmi_body_to_plane(body, 0);
    two = vmi_body_to_plane(other, 0);
    if (e->jump_kind == VMI_JUMP_SEPARATES) status = vm_separate2(&one, &two, &external, &result);
    else status = vm_attach2(&one, &two, &external, &result);
    if (status < 0) return status;
    *b = *body;
    b->mass = result.mass;
    b->inertia.zz = result.inertia;
    b->r.x = result.x;
    b->r.y = result.y;
    b->v.x = result.vx;
    b->v.y = result.vy;
    b->omega.z = result.omega;
    return result.inertia > 0 ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_event_jump_any(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const int motion = e->scene->bodies[e->jump_body].motion;
    if (motion == VM_LINE || motion == VM_AXLE) return vmi_event_jump_on_line(e, body, other, b);
    if (motion == VM_PLANE) return vmi_event_jump_in_plane(e, body, other, b);
    if (e->relative) vmi_event_jump_place(body, other);
    if (e->jump_kind == VMI_JUMP_SEPARATES) return vm_separate(body, other, &e->external, b);
    return vm_attach(body, other, &e->external, b);
}

/* The angle of a body in the plane or on an axle, complete turns included. For all other bodies the result is a
   number that the function `put` of the body ignores. */
VM_API vm_real vmi_scene_angle(const vm_scene *s, int body, const vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    return b->motion == VM_PLANE ? y[b->at + VMI_PLANE_ANGLE] : y[b->at];
}

/* After a jump has moved the mass centre of a growing body to r, updates its position in body axes, which is in the
   state */
VM_API void vmi_scene_shift_centre(const vm_scene *s, int body, vm_vec3 r, vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    vm_real *state = y + b->at;
    vm_vec3 step;
    if (!b->grows) return;
    step = vmi_times_transposed(&b->axes, vmi_sub(r, vmi_scene_moving(b, state)));
    vmi_growth_put_centre(b, vmi_add(vmi_growth_centre(b, state), step), state);
}

/* Writes the bodies after a jump into the state: the body that lost or gained mass, and the part that separated, or
   NULL if the body `other` was attached. Then adjusts the masses of bodies with a mass law, because the laws do not
   know of the jump. */
VM_API void vmi_scene_put_jump(vm_event *e, vm_real t, vm_real *y, const vm_body *result, const vm_body *part_or_NULL)
{
    vm_scene *s = e->scene;
    vm_scene_body *body = s->bodies + e->jump_body, *other = s->bodies + e->other;
    const vm_real angle = vmi_scene_angle(s, e->jump_body, y);
    vmi_scene_note_masses(s);
    body->noted_mass = result->mass;
    other->away = part_or_NULL == NULL;
    vmi_scene_shift_centre(s, e->jump_body, result->r, y);
    if (part_or_NULL) {
        other->noted_mass = part_or_NULL->mass;
        if (other->grows) vmi_growth_put_centre(other, vmi_vec3(0, 0, 0), y + other->at);
        vmi_scene_put(s, e->other, part_or_NULL, angle + other->angle, y);
    }
    vmi_scene_put(s, e->jump_body, result, angle, y);
    vmi_scene_presence(s);
    vmi_scene_hold_masses(s, t, y);
}

/* Writes the bodies after a jump into the state, and adds to the budget the energy that the jump adds and the impulse
   from outside */
VM_API void vmi_scene_jump(vm_event *e, vm_real t, vm_real *y, const vm_body *result, const vm_body *part_or_NULL)
{
    vm_scene *s = e->scene;
    vm_budget *budget = s->budget;
    vm_budget before, after;
    if (budget) budget->totals(s, y, &before);
    vmi_scene_put_jump(e, t, y, result, part_or_NULL);
    if (!budget) return;
    budget->totals(s, y, &after);
    budget->jump_energy += after.energy - before.energy;
    budget->impulse = vmi_add(budget->impulse, e->external.linear);
    budget->angular_impulse = vmi_add(budget->angular_impulse, vmi_impulse_moment(&e->external, vmi_vec3(0, 0, 0)));
}

VM_API int vmi_then_separate(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, part = e->part, rest;
    int status;
    if (e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    if (!e->scene->bodies[e->other].away) return VM_IS_THERE;
    vmi_scene_evaluate(e->scene, t, y);
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    status = e->jump(e, &body, &part, &rest);
    if (status < 0) return status;
    vmi_scene_jump(e, t, y, &rest, &part);
    return VM_OK;
}

/* The event separates a part from a body on a line or on an axle. The part has the motion *part and becomes the body
   with the index `into`, which was absent. If relative is 1, this motion is given relative to the body. vm_scene_start
   returns VM_BAD_ARGUMENT if part is NULL. */
VM_API vm_event vm_then_separate_on_line(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event.then = vmi_then_separate;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_kind = VMI_JUMP_SEPARATES;
    event.jump_body = body;
    event.other = into;
    event.relative = relative;
    if (part) event.part = *part;
    else event.status = VM_BAD_ARGUMENT;
    return event;
}

/* The event separates a part from a body in the plane. The part has the motion *part and becomes the body with the
   index `into`, which was absent. If relative is 1, this motion is given relative to the body. vm_scene_start returns
   VM_BAD_ARGUMENT if part is NULL. */
VM_API vm_event vm_then_separate_in_plane(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event = vm_then_separate_on_line(event, body, into, part, relative);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* The event separates a part from a body, which may have any kind of motion. The part has the motion *part and becomes
   the body with the index `into`, which was absent. If relative is 1, this motion is given relative to the body.
   vm_scene_start returns VM_BAD_ARGUMENT if part is NULL. */
VM_API vm_event vm_then_separate(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event = vm_then_separate_on_line(event, body, into, part, relative);
    event.jump = vmi_event_jump_any;
    event.motions = VMI_ALL_MOTIONS;
    return event;
}

VM_API int vmi_then_attach(vm_event *e, vm_real t, vm_real *y)
{
    vm_body body, added, whole;
    int status;
    if (e->scene->bodies[e->other].away || e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    vmi_scene_evaluate(e->scene, t, y);
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    vmi_scene_body_now(e->scene, e->other, y, &added);
    status = e->jump(e, &body, &added, &whole);
    if (status < 0) return status;
    vmi_scene_jump(e, t, y, &whole, NULL);
    return VM_OK;
}

/* The event attaches a body to another body on the same line or axle. The body `added` becomes a part of `body` and is
   no longer present. */
VM_API vm_event vm_then_attach_on_line(vm_event event, int body, int added)
{
    event.then = vmi_then_attach;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_kind = VMI_JUMP_ATTACHES;
    event.jump_body = body;
    event.other = added;
    event.relative = 0;
    return event;
}

/* The event attaches a body to another body in the plane. The body `added` becomes a part of `body` and is no longer
   present. */
VM_API vm_event vm_then_attach_in_plane(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* The event attaches a body to another body; both may have any kind of motion. The body `added` becomes a part of
   `body` and is no longer present. vm_scene_start returns VM_BAD_MOTION for kinds that cannot jump together. */
VM_API vm_event vm_then_attach(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_any;
    event.motions = VMI_ALL_MOTIONS;
    return event;
}

#endif
/* scenes/run.h - runs of a scene with its events and its output

   vm_scene_run integrates a scene by rk45 from one event to the next, and applies the events.

       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                               // 2 = vm_scene_size(&scene)
       int status = vm_scene_start(&scene, t, y, NULL);                           // scene is a vm_scene
       if (status == VM_OK) status = vm_scene_run(&scene, &t, 10, y, work, NULL); // to 10 s

   Tests: tests/test_scene_runs.c, tests/test_scene_events.c. */
#ifndef VARMASS_SCENES_RUN_H
#define VARMASS_SCENES_RUN_H

/* How quickly events follow each other in a run */
typedef struct VM_TAG(vmi_scene_pace) {
    long happened; /* number of events at this instant */
    vm_real gap;   /* s: of all crossings at this instant, the shortest time since the last crossing by the same event;
                      VM_MAX if none */
    int crowded;   /* number of successive instants whose gap the time t cannot resolve with its digits */
} vmi_scene_pace;

enum {
    VMI_SCENE_MOST_EVENTS = 10000, /* limit of events at one instant; more are taken for an endless chain */
    VMI_SCENE_MOST_CROWDED = 3,    /* limit of successive instants whose gap the time cannot resolve */
    VMI_SCENE_STEPS_IN_GAP = 32    /* steps in a short gap between two events, so that no later event is missed */
};

VM_API vm_real vmi_scene_larger(vm_real a, vm_real b) { return a > b ? a : b; }

/* Whether event i is due at the time t: its time has come, or the integrator has counted *times new crossings. The
   integrator counts from 0 in each run, so that *times may be negative at the beginning of a run. */
VM_API int vmi_scene_event_is_due(vm_scene *s, int i, vm_real t, long *times)
{
    vm_event *e = s->events + i;
    if (!e->when) return e->count == 0 && e->time <= t;
    *times = s->located[i].count - e->seen;
    e->seen = s->located[i].count;
    return *times > 0;
}

/* Applies to y, in the order of the list, each event that is due at the time t. Returns the first status other than
   VM_OK, or VM_OK if there is none. An error (a negative status) of an event ends the loop, and is returned even if
   an earlier event has stopped the run. */
VM_API int vmi_scene_fire_events(vm_scene *s, vm_real t, vm_real *y, vmi_scene_pace *pace)
{
    int i, status = VM_OK;
    for (i = 0; i < s->n_events && status >= 0; i++) {
        vm_event *e = s->events + i;
        long times = 1;
        int result = VM_OK;
        if (!vmi_scene_event_is_due(s, i, t, &times) || (e->most && e->count >= e->most)) continue;
        if (e->when && s->located[i].action == ODE_RECORD) {
            e->count += times;
            e->time = s->located[i].t;
            continue;
        }
        if (e->when && e->count && t - e->time < pace->gap) pace->gap = t - e->time;
        if (e->when) e->time = t;
        e->count++;
        pace->happened++;
        if (e->then) result = e->then(e, t, y);
        if (result < 0 || status == VM_OK) status = result;
    }
    return status;
}

/* Applies all events of an instant, including those that an event causes at the same instant. Events may follow each
   other faster and faster, like the contacts of a ball that comes to rest. The run ends when the time has too few
   digits to tell these events apart. Until then the step after such an event is made so short that the next event is
   not missed. */
VM_API int vmi_scene_run_events(vm_scene *s, rk45 *r, vm_real span, vmi_scene_pace *pace)
{
    const vm_real resolved = 256 * VM_EPSILON * span; /* a shorter gap between events has fewer than two digits */
    const vm_real steps = (vm_real)VMI_SCENE_STEPS_IN_GAP;
    int status = VM_OK;
    pace->happened = 0;
    pace->gap = VM_MAX;
    while (status == VM_OK) {
        const long before = pace->happened;
        status = vmi_scene_fire_events(s, r->t, r->y, pace);
        if (pace->happened == before) break;
        if (rk45_restart(r, r->t, r->y) < 0 && status >= 0) status = VM_NOT_FINITE;
        if (pace->happened > VMI_SCENE_MOST_EVENTS && status >= 0) status = VM_TOO_MANY_EVENTS;
    }
    if (pace->gap == VM_MAX) return status;
    if (pace->gap < resolved) pace->crowded++;
    else pace->crowded = 0;
    if (pace->crowded > VMI_SCENE_MOST_CROWDED && status == VM_OK) status = VM_TOO_MANY_EVENTS;
    if (r->h > pace->gap / steps) r->h = vmi_scene_larger(pace->gap, resolved) / steps;
    return status;
}

/* Calls the caller's function scene.output if it is due at the time t. *next is the index of the next time of output.
   Returns VM_STOPPED if output ends the run, else VM_OK. */
VM_API int vmi_scene_output(vm_scene *s, vm_real t, const vm_real *y, int *next)
{
    if (!s->output) return VM_OK;
    if (s->times) {
        if (*next >= s->n_times || t < s->times[*next]) return VM_OK;
        while (*next < s->n_times && s->times[*next] <= t) ++*next;
    }
    vmi_scene_evaluate(s, t, y);
    if (s->output(t, y, s, s->output_ctx)) return VM_STOPPED;
    return VM_OK;
}

/* The next time for which an event or an output is set, or t_end if that is earlier */
VM_API vm_real vmi_scene_due(const vm_scene *s, vm_real t_end, int next)
{
    vm_real due = t_end;
    int i;
    if (s->output && s->times && next < s->n_times && s->times[next] < due) due = s->times[next];
    for (i = 0; i < s->n_events; i++) {
        const vm_event *e = s->events + i;
        if (!e->when && e->count == 0 && e->time < due) due = e->time;
    }
    return due;
}

/* Finds the reason why a run ends: whether a mass or an inertia would soon reach 0 if the state continued at its
   present rates. It tries longer and longer steps, up to 1e-6 of the time t or t_end (float: 1e-3). The first failure
   becomes s->status. This search is needed because a mass or an inertia close to 0 makes the equations so stiff that
   the steps end before 0 is reached, and because shorter steps after a refused step may have set s->status to VM_OK
   again. The run is over, so that parts of the integrator's work space are free for a state and its rates. */
VM_API void vmi_scene_foresee(vm_scene *s, rk45 *r, vm_real t_end)
{
    const vm_real farthest = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    const vm_real size = vmi_scene_larger(VM_FABS(r->t), VM_FABS(t_end));
    vm_real *z = vmi_part(r, VMI_Z), *rates = vmi_part(r, VMI_K), step;
    int i;
    for (step = 4 * VM_EPSILON * size; step < farthest * size; step *= 4) {
        vm_scene_rhs(r->t, r->y, rates, s);
        if (s->status) return;
        for (i = 0; i < r->n; i++) z[i] = r->y[i] + step * rates[i];
        vm_scene_rhs(r->t + step, z, rates, s);
        if (s->status) return;
    }
}

/* The status VM_... of a scene for the status ODE_... of its integrator, which has reported an error */
VM_API int vmi_scene_status_of_ode(int ode_status)
{
    switch (ode_status) {
    case ODE_BAD_ARGUMENT:
    case ODE_WORK_TOO_SMALL: return VM_BAD_OPTIONS;
    case ODE_NOT_FINITE: return VM_NOT_FINITE;
    case ODE_STEP_TOO_SMALL: return VM_STEP_TOO_SMALL;
    case ODE_MAX_STEPS: return VM_MAX_STEPS;
    default: return VM_NOT_INTEGRATED;
    }
}

/* Makes one step, at most to the next time for which an event or an output is set. If the integrator fails, returns
   the reason why a body cannot be accelerated rather than the status of the integrator. */
VM_API int vmi_scene_step(vm_scene *s, rk45 *r, vm_real t_end, int next)
{
    const int ode_status = vmi_rk45_run(r, vm_scene_rhs, r->n, vmi_scene_due(s, t_end, next), 1);
    if (ode_status >= 0) return VM_OK;
    s->ode_status = ode_status;
    if (ode_status == ODE_MAX_STEPS) return VM_MAX_STEPS;
    if (!s->status) vmi_scene_foresee(s, r, t_end);
    if (s->status) return s->status;
    return vmi_scene_status_of_ode(ode_status);
}

/* Prepares rk45 for the scene. Each number of a body has its tolerance. The numbers of the budget have none (VM_MAX),
   so that the bodies alone determine the steps. The tolerances are stored in work after the numbers of the
   integrator. */
VM_API int vmi_scene_integrator(vm_scene *s, rk45 *r, vm_real t, const vm_real *y, vm_real *work,
                                const rk45_options *options_or_NULL)
{
    rk45_options o = rk45_defaults(options_or_NULL);
    const int n = vm_scene_size(s), n_bodies = s->budget ? n - VM_BUDGET_STATES : n;
    vm_real *atol = work + RK45_WORK(n);
    int i;
    for (i = 0; i < n_bodies; i++) atol[i] = o.atol_each ? o.atol_each[i] : o.atol;
    for (; i < n; i++) atol[i] = VM_MAX;
    o.atol_each = atol;
    o.events = s->located;
    o.n_events = s->n_events;
    if (!vmi_all_finite(n, y)) return VM_NOT_FINITE;
    s->ode_status = rk45_init(r, vm_scene_rhs, s, n, t, y, &o, work);
    r->attempts = o.max_steps;
    if (s->ode_status < 0) return vmi_scene_status_of_ode(s->ode_status);
    return VM_OK;
}

VM_API int vmi_scene_check_run(const vm_scene *s, const vm_real *t, vm_real t_end)
{
    int size;
    if (!vmi_scene_has_lists(s) || !vmi_scene_is_list(s->n_events, s->events)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(*t) || !VM_IS_FINITE(t_end)) return VM_NOT_FINITE;
    if (t_end < *t) return VM_BAD_TIMES;
    if (!vmi_scene_is_started(s)) return VM_NOT_STARTED;
    size = vm_scene_size(s);
    if (s->y_size && s->y_size < size) return VM_SHORT_ARRAY;
    if (s->work_size && s->work_size < VM_SCENE_WORK(size)) return VM_SHORT_ARRAY;
    return VM_OK;
}

/* Run of a scene from *t to t_end, with its events and its output. The integrator is rk45. The scene must have been
   started, and t_end must not be before *t. work has room for VM_SCENE_WORK(vm_scene_size(scene)) numbers. The
   options are those of rk45, without events. *t and y become the time and the state at the end of the run. Returns
   VM_OK at t_end, VM_STOPPED if an event or the output ended the run, or
     VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_TIMES, VM_NOT_STARTED, VM_SHORT_ARRAY, VM_BAD_OPTIONS   if nothing was done;
     VM_BAD_MASS, VM_BAD_INERTIA, VM_NO_EFFECTIVE_MASS
                           if a mass or an inertia reached 0, even if the steps became too short just before that;
     VM_NOT_FINITE         if an effect, a law or an event gave an infinite number or NaN;
     VM_SINGULAR           if a link cannot act;
     VM_TOO_MANY_EVENTS    if events do not end: more than 10 000 happen at one instant, or four times in succession an
                           event follows the one before within 256 VM_EPSILON of the time;
     VM_IS_THERE, VM_IS_AWAY and the errors of vm_separate and vm_attach
                           if a jump is impossible;
     VM_STEP_TOO_SMALL, VM_MAX_STEPS   if the integrator failed; its own status is in scene.ode_status. */
VM_API int vm_scene_run(vm_scene *scene, vm_real *t, vm_real t_end, vm_real *y, vm_real *work,
                        const rk45_options *options_or_NULL)
{
    vmi_scene_pace pace = {0, 0, 0};
    int next = 0, status;
    vm_real span;
    rk45 r;
    if (!scene || !t || !y || !work) return VM_BAD_ARGUMENT;
    status = vmi_scene_check_run(scene, t, t_end);
    if (status) return status;
    scene->status = VM_OK;
    status = vmi_scene_integrator(scene, &r, *t, y, work, options_or_NULL);
    if (status) return status;
    span = vmi_scene_larger(VM_FABS(*t), VM_FABS(t_end));
    while (scene->times && next < scene->n_times && scene->times[next] < *t) next++;
    for (;;) {
        status = vmi_scene_run_events(scene, &r, span, &pace);
        if (status == VM_OK) status = vmi_scene_output(scene, r.t, r.y, &next);
        if (status != VM_OK || r.t == t_end) break;
        status = vmi_scene_step(scene, &r, t_end, next);
        if (status != VM_OK) break;
    }
    *t = r.t;
    vmi_copy(r.n, r.y, y);
    vmi_scene_evaluate(scene, *t, y);
    return status;
}

#endif

#endif
