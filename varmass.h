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
     base/status: the statuses that functions return, and their texts
       vm_strerror                    

     base/lambert: Lambert's function W
       vm_lambert_w0                  Lambert's W, w e^w = x
       vm_lambert_wm1                 Documented with vm_lambert_w0
       vm_wright_omega                The same from the logarithm of the argument, which itself may be too large or too small to be a number
       vm_lambert_w0_neg_exp          Documented with vm_wright_omega
       vm_lambert_wm1_neg_exp         Documented with vm_wright_omega

     mechanics/inertia: tensors of inertia
       vm_inertia_possible            1 where a body can have this inertia
       vm_parallel_axes               Inertia about a point d away from the mass centre, same axes, of a body whose own is given (40); with -mass the way back

     mechanics/bodies: bodies, their momentum, angular momentum and kinetic energy
       vm_momentum                    Momentum M v (1)-(3), N s; angular momentum I omega + (r - about) x M v (7)-(9), N m s, about any point; kinetic energy (93), (97), J
       vm_angular_momentum            Documented with vm_momentum
       vm_kinetic_energy              Documented with vm_momentum
       vm_balance_between             What is left of the balances of momentum and, about any point, of angular momentum between some bodies before and after an instant in which external, where not NULL, acted (4)-(6), (10)-(12)

     mechanics/bodies2: bodies that move in a plane
       vm_angular_momentum2           Documented with vm_momentum
       vm_kinetic_energy2             Documented with vm_momentum
       vm_body_from_body2             The plane's body as a lamina in the plane z = 0 of space, which moves as it does

     mechanics/jumps: parts separate from a body or are attached to it
       vm_separate                    A part, which moved as given the instant after, has left the whole
       vm_attach                      Two bodies, moving as given the instant before, have become one (which is plastic impact) (24), (33)
       vm_separate_all                n parts at once, n >= 0
       vm_attach_all                  Documented with vm_separate_all
       vm_combine_inertia             Inertia, about its own mass centre, of a and b together, and of what is left of the whole without the part (13)-(15), (40)
       vm_split_inertia               Documented with vm_combine_inertia

     mechanics/jumps2: parts separate or are attached in a plane
       vm_separate2                   The same in the plane (35)-(39); *_all2 as above
       vm_attach2                     Documented with vm_separate2
       vm_separate_all2               Documented with vm_separate2
       vm_attach_all2                 Documented with vm_separate2

     mechanics/relative: motion relative to a moving body
       vm_to_relative                 Motion relative to what moves on rigidly with a body
       vm_to_absolute                 Documented with vm_to_relative
       vm_to_relative2                Documented with vm_to_relative
       vm_to_absolute2                Documented with vm_to_relative
       vm_separate_relative           The jump in relative motions, (28)-(31), (42)-(44)
       vm_attach_relative             Documented with vm_separate_relative
       vm_separate_relative2          Documented with vm_separate_relative
       vm_attach_relative2            Documented with vm_separate_relative

     mechanics/inverse: how a part must leave for the rest to move as wanted
       vm_separation_for_rest         The inverse question
       vm_separation_for_rest2        The same in the plane; *rest_v is vx, vy
       vm_separation_for_spin2        The part keeps its spin

     mechanics/jump_energy: the energy that a jump sets free or takes
       vm_energy_gain                 Kinetic energy that the n parts and the rest have more than the whole had, J, as the theorem (113), (118) has it
       vm_energy_loss                 What body and the n added have more than the whole has, J

     mechanics/broken_rotor: a rotor from which a piece breaks off
       vm_broken_rotor_rhs            (65), (66), (68), and (46) for s = 0, as an ode_rhs for n = 6; rotor points at a vm_broken_rotor
       vm_broken_rotor_linear         The remainder for short times, |psi| << 1, linearised
       vm_broken_rotor_linear_uncoupled Documented with vm_broken_rotor_linear
       vm_broken_rotor_free_motion    State at t after start by (46)-(51), exact; VM_DOMAIN unless s = 0
       vm_broken_rotor_orbit          A0, B0, C0, D0 (51), m, of x + i y = (A0 + i B0) exp(i w t) + (C0 + i D0) exp(-i w t) (50), w^2 = stiffness/mass, not 0
       vm_broken_rotor_break_off      The remainder's spin, state[5], is Omega_b + Omega_r1 [(59), (64) corrected]
       vm_broken_rotor_polar_rhs      Polar form (75), y[6] = {r, phi, psi, r', phi', psi'}; stops the run with VM_DOMAIN at r = 0
       vm_broken_rotor_to_polar       Documented with vm_broken_rotor_polar_rhs
       vm_broken_rotor_from_polar     Documented with vm_broken_rotor_polar_rhs
       vm_broken_rotor_steady_radius  Steady motion at psi' = Omega, which needs torque = damping Omega (47)
       vm_broken_rotor_characteristic Small motions about it, exp(lambda t)
       vm_broken_rotor_routh          Routh's first column 1, k*, G, k* D, 4 G Omega^2, k* D^2
       vm_broken_rotor_is_stable      1 where the steady motion is asymptotically stable, exactly Omega^2 < omega^2 (82) with k* > 0, s != 0, Omega != 0; else 0 (for k*, s or Omega = 0 some motions neither grow nor fade)
       vm_broken_rotor_eigenvalues    Its five roots, by rising |imaginary part|, pairs as (+, -)
       vm_broken_rotor_resonance_radius r(t) after a start from rest where Omega = torque/damping is not below omega

     mechanics/generalized_force: generalised forces
       vm_lagrange_add_force          Q_i += force dr/dq_i + moment domega/dq'_i, i < n (235)

     mechanics/lagrange_jump: Lagrange's equations across a jump
       vm_lagrange_mass               Generalized coordinates q_i, i < n (or velocities qdot_i that are no derivatives, as those about the axes)
       vm_lagrange_momentum           Documented with vm_lagrange_mass
       vm_lagrange_impulse            Documented with vm_lagrange_mass
       vm_lagrange_separate           
       vm_lagrange_attach             
       vm_lagrange_impact             matrix (qdot_after - qdot) = impulse

     mechanics/pendulum: a pendulum from which a part is cut
       vm_pendulum_separate           part is l, 0 < l < L; u in the axes of the pendulum

     mechanics/torque_free: exact rotation of a body without torque
       vm_torque_free_init            Prepares the motion of a body that is as given at t0
       vm_torque_free_init_principal  The same from principal moments (kg m^2), the body's axes being the principal ones, and omega (rad/s) along them; the body has mass 1 and rests at the origin
       vm_torque_free_attitude        Attitude and omega alone, the latter along body axes
       vm_torque_free_at              The body at time t (s), later than t0 or earlier
       vm_torque_free_rotation        The body a time t (s) later, in one call

     mechanics/streams: streams of mass: reactive force and torque
       vm_reactive_loads              centre
       vm_accelerations               v' (159) and omega' (160), inertial axes, under the resultant F of the outer loads and their moment M_S about the mass centre; VM_BAD_INERTIA where the inertia is singular
       vm_velocity_by_momentum        Closed forms, for mass and velocity or, about a fixed axle, for inertia and angular velocity

     mechanics/flow: a free body with streams of mass
       vm_flow_rhs                    Documented with vm_flow_body
       vm_flow_given_rhs              13 states; flow.update sets mass, centre and inertia
       vm_flow_balanced_rhs           vm_flow_rhs, and from y[VM_Y_BALANCE] on, zero at first, what streams have carried off less what outer loads have brought
       vm_flow_carried_rhs            The same for what moves with the body (166)
       vm_flow_start                  y
       vm_flow_body                   The body of n states, with q of length 1
       vm_flow_mass_left              Event functions of vm_flow_rhs and vm_flow_balanced_rhs, ctx the flow
       vm_flow_inertia_left           Documented with vm_flow_mass_left

     mechanics/flow2: a body in a plane with streams of mass
       vm_flow2_rhs                   

     mechanics/flow1: translation, bodies on a line or an axle with streams of mass
       vm_translation_rhs             
       vm_flow1_rhs                   

     mechanics/rocket: closed forms: Tsiolkovsky's rocket, linear flow, jet damping
       vm_tsiolkovsky                 Documented with vm_velocity_by_momentum
       vm_linear_flow                 Position and velocity after t under constant rate, force and velocity of the stream (VM_RELATIVE, VM_ABSOLUTE), through rate = 0 without loss
       vm_jet_damping                 With tau = rate gyration t/A0 and c likewise

     mechanics/drum: a band that winds up on a drum
       vm_drum_band                   mu (181)
       vm_drum_at                     The drum with its band at the angle phi >= 0
       vm_drum_rhs                    
       vm_drum_rhs_reduced            
       vm_drum_rate                   The rigid shaft (194)
       vm_drum_rhs_angle              (210), (211) of y = {x, y, dx/dphi, dy/dphi}, phi the independent variable, with phi'(phi) of the rigid shaft (196); VM_BAD_ARGUMENT where the drum does not get to phi
       vm_drum_stop                   Documented with vm_drum_rate
       vm_drum_time                   Documented with vm_drum_rate
       vm_drum_angle                  Documented with vm_drum_rate
       vm_drum_angle_lambert          phi(t) as published, (198)-(206) corrected
       vm_drum_shaft_init             VM_SINGULAR where c or Omega_b is not positive; VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA
       vm_drum_deflection             (224), (225) corrected
       vm_drum_shaft_valid            (226)

     mechanics/lagrange: Lagrange's equations with variable mass
       vm_lagrange_rhs                An ode_rhs of 2 n states q, pi, ctx a vm_lagrange_system
       vm_lagrange_start              y = q, pi from q and rates q', and rates from y; VM_BAD_ARGUMENT, VM_SINGULAR, VM_NOT_FINITE
       vm_lagrange_rates              Documented with vm_lagrange_start
       vm_lagrange_partial_q          dT/dq_i with the masses frozen at (t, q); NaN for i outside 0 .

     mechanics/euler_angles: Euler's angles
       vm_euler_313                   Euler's angles psi, theta, phi (3-1-3
       vm_euler_313_axes              Documented with vm_euler_313
       vm_euler_313_body_axes         Documented with vm_euler_313
       vm_euler_313_rates             Documented with vm_euler_313

     oscillators/waves: the wave forms of a strongly nonlinear oscillator: cosine, cn, ca
       vm_osc_route_name              -- The plan --

     oscillators/constant_mass: the oscillator of constant mass
       vm_osc_period                  Started at rest, x(0) = x0, x'(0) = 0 (258), x0 of either sign
       vm_osc_vmax                    Documented with vm_osc_period
       vm_osc_exact                   Exact motion, x(t) = x0 ca(alpha, 1, s) (282) and x'(t) (283), for x0 of either sign
       vm_osc_omega_trig              The approximations with the exact amplitude and period, started at rest
       vm_osc_jacobi_parameter        Documented with vm_osc_omega_trig
       vm_osc_omega_jacobi            Documented with vm_osc_omega_trig
       vm_osc_energy                  Energy by mass v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1) (259), m^2/s^2
       vm_osc_amplitude_phase         Amplitude A > 0 (m) and phase psi in (-Pi, Pi] of any state
       vm_osc_exact_from              Exact motion from any x(0) = x0, x'(0) = v0
       vm_osc_trig                    Documented with vm_osc_omega_trig
       vm_osc_jacobi                  Documented with vm_osc_omega_trig
       vm_osc_approximation_errors    

     oscillators/laws: laws of mass, stiffness and damping: numbers that depend on time
       vm_law_linear                  
       vm_law_quadratic               
       vm_law_exponential             
       vm_law_power                   
       vm_law_table                   
       vm_law_user                    
       vm_law_at                      f(t), its rate, and the integral from 0 to t of ds/f

     oscillators/problem: an oscillator with slowly varying mass, and its plan
       vm_osc_plan_init               x(t), x'(t) at any t of either sign, by the route that is asked for, or by the cheapest whose error is estimated to be within the tolerance

     oscillators/walk: integrals along the mean motion
       vm_law_inverse_integral        Documented with vm_law_at

     oscillators/averaging: averaged equations with a force, and their errors
       vm_osc_averaged                Averaged equations at (t, A) with the force F of the problem

     oscillators/routes: routes to x(t), and the cheapest within a tolerance
       vm_osc_plan_by_route           Documented with vm_osc_plan_init
       vm_osc_plan_within             Documented with vm_osc_plan_init
       vm_osc_by_route                The same for a problem that is asked once
       vm_osc_within                  Documented with vm_osc_by_route

     oscillators/slow: what oscillators with slowly varying mass share
       vm_osc_amplitude_law           Amplitude A/A0 and largest velocity over its first value when the mass has come to mass_ratio = m/m0 and damping = integral of b/m dt
       vm_osc_velocity_law            Documented with vm_osc_amplitude_law
       vm_slow_mass_linear            

     oscillators/van_der_pol: the Van der Pol oscillator with variable mass
       vm_vdp_init                    
       vm_vdp_amplitude               Amplitude at t where it was first_A at t = 0 and the mass is m.mass + m.rate t > 0; m.rate may be 0
       vm_vdp_limit_cycle             The amplitude other than 0 that stays while the mass changes at mass_rate, (425), (430), (438); 0 where there is none
       vm_vdp_rhs                     Equations for rk45 or rk87, ctx a vm_vdp
       vm_vdp_averaged_rhs            Documented with vm_vdp_rhs

     oscillators/jeffcott: the Jeffcott (Laval) rotor with variable mass
       vm_jeffcott_power              
       vm_jeffcott_polar              rho and phi in (-pi, pi] (448)
       vm_jeffcott_momentum           Angular momentum Im(conj z m z') - g |z|^2, kg m^2/s
       vm_jeffcott_rhs                Equations of motion (449), (450) for rk45 or rk87, ctx a vm_jeffcott, y = (x, y, x', y')
       vm_jeffcott_to_averaged        Small nonlinearity
       vm_jeffcott_from_averaged      Documented with vm_jeffcott_to_averaged
       vm_jeffcott_exact_rhs          Documented with vm_jeffcott_to_averaged
       vm_jeffcott_averaged_rhs       Documented with vm_jeffcott_to_averaged
       vm_jeffcott_frequency          Strong nonlinearity
       vm_jeffcott_forward_whirl_rhs  Documented with vm_jeffcott_frequency
       vm_jeffcott_backward_whirl_rhs Documented with vm_jeffcott_frequency
       vm_jeffcott_amplitude          The same without F_z

     oscillators/pair: two bodies with a nonlinear connection
       vm_pair_rhs                    
       vm_pair_to_averaged            q = x + y drifts, p = y - x vibrates (520)-(522)
       vm_pair_from_averaged          Documented with vm_pair_to_averaged
       vm_pair_averaged_rhs           Documented with vm_pair_to_averaged
       vm_pair_at                     y at t where it was y0 at t = 0, for the mass m.mass + m.rate t, closed

     oscillators/forced: harmonic excitation
       vm_forced_init                 
       vm_forced_rhs                  Equations for rk45 or rk87, ctx a vm_forced
       vm_forced_exact_rhs            Documented with vm_forced_rhs
       vm_forced_averaged_rhs         Documented with vm_forced_rhs
       vm_forced_to_averaged          (x, x', theta) to the mean (A, delta, theta), and back, at time t
       vm_forced_from_averaged        Documented with vm_forced_to_averaged

     oscillators/resonance: steady vibrations, resonance curves, passage through resonance
       vm_forced_steady_states        
       vm_forced_curve                The amplitude-frequency curve, traced by its amplitude
       vm_forced_peak                 The amplitude where the curve meets the backbone, its largest; infinite without damping
       vm_forced_passage              delta'' = -(gamma push/A) sin delta - nu D, a pendulum under a torque, gamma = (alpha - 1)/2, D the relative drift of w - nu; and for gamma = 0 the same jump

     oscillators/diagnostics: turning points, zero crossings, envelopes
       vm_find_samples                The number of changes of sign in (t0, t1], looked for every step (or a little less; a small part of a period, negative where t1 < t0) and located to an eps of t; the first room of them are written
       vm_find_samples_of_step        The same in the last step of an rk45 or rk87, for components x and v of its state; to be called after every step
       vm_envelope_error              Largest |law(t)/observed - 1|, observed |x| at turning points, |v| at zero crossings
       vm_adiabaticity                q/Om, what averaging takes for small

     scenes/motions: how each kind of body moves
       vm_scene_body_line             Bodies
       vm_scene_body_axle             Documented with vm_scene_body_line
       vm_scene_body_plane            Documented with vm_scene_body_line
       vm_scene_body_point            Documented with vm_scene_body_line
       vm_scene_body_free             Documented with vm_scene_body_line
       vm_scene_body_with_mass_state  the same, its mass a state
       vm_scene_body_absent           the same, not yet there

     scenes/growing: bodies whose mass centre and inertia change
       vm_scene_body_growing_plane    The same, its mass, the mass centre in the body and its inertia states
       vm_scene_body_growing_free     Documented with vm_scene_body_growing_plane

     scenes/forces: forces as functions of numbers
       vm_force_spring                Forces, N (torques, N m), for right-hand sides that are written by hand; the effects use them
       vm_force_damper                -b v
       vm_force_van_der_pol           (b - c x^2) v
       vm_force_motor                 torque - kappa omega
       vm_force_harmonic              Documented with vm_force_spring
       vm_force_stream                rate (u + share v - v)
       vm_force_gravity               mass g
       vm_force_shaft                 Documented with vm_force_spring
       vm_force_unbalance             Documented with vm_force_spring
       vm_force_gyroscopic            Documented with vm_force_spring

     scenes/effects: effects that act on coordinates
       vm_effect_gravity              Effects, the forces above on a coordinate of a body, x and v its position and velocity; where there is an other body, or VM_GROUND, x and v are relative to its coordinate, and it takes the reaction
       vm_effect_spring               vm_force_spring of x - rest
       vm_effect_linear_spring        the same with alpha = 1
       vm_effect_damper               Documented with vm_effect_spring
       vm_effect_rotational_damper    -b omega
       vm_effect_van_der_pol          Documented with vm_effect_spring
       vm_effect_motor                Documented with vm_effect_spring
       vm_effect_harmonic             Documented with vm_effect_spring
       vm_effect_force_between        Documented with vm_effect_force
       vm_effect_force                a force of one's own, which depends on t and the coordinate, and on what ctx points to
       vm_effect_custom               an effect of one's own, which may depend on everything
       vm_effect_shaft                an elastic shaft
       vm_effect_unbalance            an unbalance m e (kg m) that turns with Omega = frequency
       vm_effect_gyroscopic           force coupling (-vy, vx)

     scenes/mass: laws of mass
       vm_effect_mass_law             A mass law
       vm_effect_mass                 
       vm_effect_varying              The same, of a stream that varies

     scenes/streams: streams of mass onto and out of bodies of a scene
       vm_effect_stream               A stream, for a body whose mass is a state
       vm_effect_stream_mass          A stream of chapter 5 that crosses at a point of a growing body and is put there (in body axes from where the mass centre was at first; a stream with a store is refused)
       vm_effect_stream_force         Documented with vm_effect_stream_mass
       vm_effect_stream_moment        Documented with vm_effect_stream_mass
       vm_effect_stream_torque        Documented with vm_effect_stream_mass

     scenes/band: a band that winds up
       vm_band_at                     phi < 0
       vm_effect_band                 Documented with vm_band_at

     scenes/links: rigid links between bodies
       vm_effect_link                 a rigid link, or where cord is set one that only pulls, of a length between a body (a point, or in the plane) and another (on a line, too) or, other = VM_GROUND, a point that moves as given, which may be above the plane

     scenes/state: the state of a scene
       vm_scene_size                  numbers in the state; VM_BAD_ARGUMENT for null pointers
       vm_scene_body_at               Body 0 <= body < n_bodies of a scene that has been started as it moves in state y; where its mass is of a law, that when the right-hand side was last evaluated

     scenes/evaluate: the right-hand side of a scene
       vm_scene_rhs                   An ode_rhs; ctx is the scene, which has been started

     scenes/check: what can be wrong in a scene
       vm_scene_check                 Everything that can be wrong with a scene

     scenes/start: how a scene starts
       vm_scene_start                 Checks the scene, and makes the state at the start

     scenes/balance: the book of momentum, angular momentum and energy
       vm_scene_keep_budget           Before vm_scene_start
       vm_scene_budget_at             Momentum, angular momentum and energy in state y, what came in since the start, and the defects

     scenes/events: events of a scene and what they do
       vm_event_at                    Events
       vm_event_position              passes value
       vm_event_velocity              Documented with vm_event_at
       vm_event_mass                  > 0
       vm_event_user                  Documented with vm_event_at
       vm_then_stop                   ..
       vm_then_switch                 Documented with vm_then_stop
       vm_then_user                   Documented with vm_then_separate_on_line

     scenes/jumps: separation and attachment as events
       vm_then_separate_on_line       The same, of bodies on a line or on an axle, or in the plane, which link no more than that (docs/scene-sizes.md)
       vm_then_separate_in_plane      Documented with vm_then_separate_on_line
       vm_then_separate               Documented with vm_then_stop
       vm_then_attach_on_line         Documented with vm_then_separate_on_line
       vm_then_attach_in_plane        Documented with vm_then_separate_on_line
       vm_then_attach                 Documented with vm_then_stop

     scenes/run: runs of a scene
       vm_scene_run                   On from *t to t_end >= *t by rk45, events included */
#ifndef VARMASS_H
#define VARMASS_H

#include "ateb.h"
#include "integrators.h"
#include "jacobi.h"

/* base/status.h - the statuses that functions return, and their texts */
#ifndef VARMASS_BASE_STATUS_H
#define VARMASS_BASE_STATUS_H

#include <string.h>

enum {
    VM_OK = 0,
    VM_NULL_AXIS = 1,            /* done, but about an axis without inertia (of a rod, a point) the spin stayed as
                                    it was, though angular momentum was left for it: that is lost */
    VM_STOPPED = 2,              /* an event or the caller ended the run */
    VM_TOLERANCE_MISSED = 3,     /* done, but the estimated error is larger than the tolerance */
    VM_BAD_ARGUMENT = -1,        /* a null pointer, a negative count, a choice that does not exist */
    VM_NOT_FINITE = -2,          /* a number that is infinite or NaN, given or arising */
    VM_BAD_MASS = -3,            /* a mass (a stiffness) that is not positive, the rest's included */
    VM_BAD_INERTIA = -4,         /* an inertia that no body has, the rest's included */
    VM_SINGULAR = -5,            /* linear equations without a unique solution */
    VM_DOMAIN = -6,              /* a parameter outside its domain */
    VM_NO_LAW = -7,              /* the route does not exist for this problem */
    VM_NOT_INTEGRATED = -8,      /* oscillators: the integrator gave up */
    VM_BAD_MOTION = -9,          /* scenes: no such motion, or one on which this effect or event cannot act */
    VM_NO_SUCH_BODY = -10,       /* no body has this index */
    VM_NO_SUCH_COORDINATE = -11, /* the body has no such coordinate */
    VM_NO_SUCH_EFFECT = -12,     /* no such effect */
    VM_TWO_MASS_LAWS = -13,      /* two laws for one mass, or a law for a mass that is a state */
    VM_BAD_ORDER = -14,          /* a mass law stands after another effect on its body */
    VM_MASS_IS_NO_STATE = -15,   /* a stream needs a body whose mass is a state */
    VM_TOO_MANY_EVENTS = -16,    /* events do not end */
    VM_BAD_OPTIONS = -17,        /* the integrator refuses its options; this and all that follow are of scenes, */
    VM_STEP_TOO_SMALL = -18,     /* the tolerance asks for steps that the time cannot resolve */
    VM_MAX_STEPS = -19,          /* max_steps attempts did not reach t_end */
    VM_SHORT_ARRAY = -20,        /* of scenes and flows: an array is shorter than what is written into it */
    VM_BAD_TIMES = -21,          /* times of output that do not rise, or a run to a time that is past */
    VM_SAME_BODY = -22,          /* a link or a jump between a body and itself */
    VM_NOT_ON_ANGLE = -23,       /* an effect that cannot act on an angle */
    VM_IS_THERE = -24,           /* a part separates into a body that is there already */
    VM_IS_AWAY = -25,            /* a jump of a body that is not there */
    VM_TWO_LINKS = -26,          /* two links of one body */
    VM_LINK_NOT_LAST = -27,      /* an effect stands after a link of its body */
    VM_STORED_STREAM = -28,      /* of reactive loads, too: a stream with a store */
    VM_DOES_NOT_GROW = -29,      /* a stream that crosses at a point needs a growing body */
    VM_NO_EFFECTIVE_MASS = -30,  /* a mass law M(v): M + M'(v) (v - u) is not positive */
    VM_NOT_STARTED = -31         /* a scene that was not started, or has been changed since */
};

/* How many elements an array has, as in scene.y_size = VM_LENGTH(y). Not of a pointer to them. */
#define VM_LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))

VM_API const char *vm_strerror(int status)
{
    switch (status) {
    case VM_OK: return "success";
    case VM_NULL_AXIS: return "angular momentum about an axis without inertia was lost";
    case VM_STOPPED: return "an event or the caller ended the run";
    case VM_TOLERANCE_MISSED: return "the estimated error is larger than the tolerance";
    case VM_BAD_ARGUMENT: return "null pointer, negative count or unknown choice";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass or a stiffness is not positive";
    case VM_BAD_INERTIA: return "no body has this inertia";
    case VM_SINGULAR: return "linear equations without a unique solution";
    case VM_DOMAIN: return "a parameter outside its domain";
    case VM_NO_LAW: return "the route does not exist for this problem";
    case VM_NOT_INTEGRATED: return "the integrator gave up";
    case VM_BAD_MOTION: return "a motion that does not exist, or that this effect or event cannot act on";
    case VM_NO_SUCH_BODY: return "no body has this index: count from 0, the ground is VM_GROUND";
    case VM_NO_SUCH_COORDINATE: return "the body has no such coordinate";
    case VM_NO_SUCH_EFFECT: return "no such effect";
    case VM_TWO_MASS_LAWS: return "two laws for one mass, or a law for a mass that is a state: leave one out";
    case VM_BAD_ORDER: return "a mass law stands after another effect on its body: list it first";
    case VM_MASS_IS_NO_STATE: return "a stream needs a body whose mass is a state: vm_scene_body_with_mass_state";
    case VM_TOO_MANY_EVENTS: return "events do not end: let an event stop the run where they crowd";
    case VM_BAD_OPTIONS: return "the integrator refuses its options: a tolerance, h0, h_min, h_max or h_max < h_min";
    case VM_STEP_TOO_SMALL: return "the tolerance asks for steps that the time cannot resolve: a force too stiff?";
    case VM_MAX_STEPS: return "max_steps attempts did not reach t_end: run again to go on, or allow more";
    case VM_SHORT_ARRAY: return "an array is shorter than what is written into it: y or work needs more room";
    case VM_BAD_TIMES: return "times of output that do not rise, or a run to a time that is past";
    case VM_SAME_BODY: return "a link or a jump is between two bodies, not between a body and itself";
    case VM_NOT_ON_ANGLE: return "this effect cannot act on an angle: choose another coordinate";
    case VM_IS_THERE: return "a part separates into a body that is there already: make it with vm_scene_body_absent";
    case VM_IS_AWAY: return "a jump of a body that is not there: order the events, or make it present";
    case VM_TWO_LINKS: return "two links of one body: leave one out";
    case VM_LINK_NOT_LAST: return "an effect stands after a link of its body: list the link last";
    case VM_STORED_STREAM: return "a stream with a store is not for this: integrate vm_flow_rhs";
    case VM_DOES_NOT_GROW: return "this stream needs a growing body: vm_scene_body_growing_plane, vm_scene_body_growing_free";
    case VM_NO_EFFECTIVE_MASS: return "M + M'(v) (v - u) of a mass law M(v) is not positive: no force accelerates it";
    case VM_NOT_STARTED: return "the scene was not started, or has been changed since: vm_scene_start";
    default: return "unknown status";
    }
}

/* A result of n numbers, where all are finite */
VM_API int vmi_copy_if_finite(int n, const vm_real *from, vm_real *to)
{
    if (!vmi_all_finite(n, from)) return VM_NOT_FINITE;
    memcpy(to, from, (size_t)n * sizeof *to);
    return VM_OK;
}

#endif
/* base/linear.h - systems of linear equations */
#ifndef VARMASS_BASE_LINEAR_H
#define VARMASS_BASE_LINEAR_H

/* Elimination of column k of a x = b, a n by n, row after row, below the diagonal */
VM_API void vmi_eliminate(int n, int k, vm_real *a, vm_real *b)
{
    int i, j;
    for (i = k + 1; i < n; i++) {
        const vm_real factor = a[i * n + k] / a[k * n + k];
        for (j = k + 1; j < n; j++) a[i * n + j] -= factor * a[k * n + j];
        b[i] -= factor * b[k];
    }
}

/* a x = b for a without entries below the diagonal: x replaces b */
VM_API void vmi_substitute_back(int n, const vm_real *a, vm_real *b)
{
    int j, k;
    for (k = n - 1; k >= 0; k--) {
        for (j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
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

/* a x = b for a mass matrix a, scaled to unit diagonal, which makes units and sizes of the coordinates nothing and
   the condition number nearly the least that scaling can (van der Sluis 1969): x replaces b, a is destroyed, scale
   is n numbers of work. Rows are not exchanged: a positive definite matrix does not need it, and of any other a pivot
   is not positive. VM_SINGULAR where an entry on the diagonal is not positive or a pivot is below 4 n eps. */
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
/* base/zero.h - a zero of a function between two bounds */
#ifndef VARMASS_BASE_ZERO_H
#define VARMASS_BASE_ZERO_H

/* The zero of f in [a, b], where it has the values fa, fb of opposite signs: regula falsi whose standing end is
   halved (Illinois), a bisection wherever that does not halve the interval in three steps; to the resolution of x
   */
VM_API vm_real vmi_find_zero(vm_real (*f)(vm_real x, void *ctx), void *ctx, vm_real a, vm_real b, vm_real fa,
                             vm_real fb)
{
    vm_real width = VM_FABS(b - a);
    int i, side = 0;
    if (fa == 0 || fb == 0) return fa == 0 ? a : b;
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
    return VM_FABS(fa) < VM_FABS(fb) ? a : b;
}

#endif
/* base/hypot.h - the length of a plane vector without overflow */
#ifndef VARMASS_BASE_HYPOT_H
#define VARMASS_BASE_HYPOT_H

/* sqrt(x^2 + y^2), within 2 ulp, where the squares overflow too */
VM_API vm_real vmi_hypot(vm_real x, vm_real y)
{
    const vm_real a = VM_FABS(x), b = VM_FABS(y), most = a > b ? a : b, least = a > b ? b : a;
    const vm_real q = most > 0 ? least / most : 0;
    return x == x && y == y ? most * VM_SQRT(1 + q * q) : VM_NAN;
}

#endif
/* base/complex.h - complex numbers */
#ifndef VARMASS_BASE_COMPLEX_H
#define VARMASS_BASE_COMPLEX_H

typedef struct VM_TAG(vm_complex) {
    vm_real re, im;
} vm_complex;

VM_API vm_complex vmi_complex(vm_real re, vm_real im)
{
    vm_complex z;
    z.re = re;
    z.im = im;
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

VM_API vm_real vmi_c_modulus(vm_complex z) { return vmi_hypot(z.re, z.im); }

/* a/b by Smith's method, where b.re^2 + b.im^2 may underflow */
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
/* base/polynomial.h - all roots of a polynomial */
#ifndef VARMASS_BASE_POLYNOMIAL_H
#define VARMASS_BASE_POLYNOMIAL_H

/* The step of z = (re[i], im[i]) towards a root of c[0] z^n + ... + c[n], which the other approximations repel:
   p/p' of p over the product of the z - z_j (Ehrlich, Aberth). 0 where p is within its rounding errors of 0. */
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

VM_API void vmi_poly_swap(vm_real *re, vm_real *im, int i, int j)
{
    const vm_real x = re[i], y = im[i];
    re[i] = re[j];
    im[i] = im[j];
    re[j] = x;
    im[j] = y;
}

/* Makes what rounding left of an imaginary part 0, and conjugate the others by twos: im > 0, then im < 0; by rising
   |im|, real ones by falling re */
VM_API void vmi_poly_order(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const vm_real tolerance = 16 * VM_SQRT(VM_EPSILON); /* a double real root comes out as two this far apart */
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

/* The roots of c[0] z^n + ... + c[n], c[0] != 0, simple ones each to a few n eps times its condition number */
VM_API void vmi_poly_roots(int n, const vm_real *c, vm_real *re, vm_real *im)
{
    const int most_sweeps = 100;
    int i, sweep, moving = 1, m = n;
    while (m > 0 && c[m] == 0) {
        m--;
        re[m] = im[m] = 0;
    }
    for (i = 0; i < m; i++) /* not symmetric about the real axis, which no step would then leave */
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
/* base/scalars.h - expm1, log1p, checked powers and quotients that tend to 0/0 */
#ifndef VARMASS_BASE_SCALARS_H
#define VARMASS_BASE_SCALARS_H

/* x^y for x >= 0, within 0.6 ulp, with the limits of pow at 0 and infinity; NaN for x < 0 */
VM_API vm_real vmi_pow_checked(vm_real x, vm_real y)
{
    if (x != x || y != y || x < 0) return VM_NAN;
    if (y == 0 || x == 1) return 1;
    if (x == 0 || x > VM_MAX) return (y > 0) == (x > 0) ? VM_INFINITY : 0;
    if (!VM_IS_FINITE(y)) return (y > 0) == (x > 1) ? VM_INFINITY : 0;
    return vmi_pow_two(vmi_two(x, 0), vmi_two(y, 0));
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

/* ln(1 + x) in two words, for -1 < x < 1e299 (float 1e34; NaN beyond): relative error below 2^-(p+7), p the type's
   digits. 1 + x = y (1 + t) with y one word: ln y has it, and t is below an ulp of 1 */
VM_API vm_two vmi_log1p(vm_two x)
{
    const vm_two sum = vmi_two_sum(1, x.hi), low = vmi_two_sum(sum.lo, x.lo);
    const vm_two y = vmi_two_sum(sum.hi, low.hi);
    const vm_two t = vmi_two_over(vmi_two_sum(y.lo, low.lo), vmi_two(y.hi, 0));
    return vmi_two_plus(vmi_log(y.hi), vmi_two(t.hi, t.lo - t.hi * t.hi / 2));
}

/* (e^x - 1)/x and ln(1 + x)/x, 1 at x = 0, within 2 eps */
VM_API vm_real vmi_exp_ratio(vm_real x)
{
    if (x > VM_MAX) return x;
    return x == 0 ? 1 : vmi_expm1(vmi_two(x, 0)).hi / x;
}

VM_API vm_real vmi_log_ratio(vm_real x)
{
    if (!(x > -1) || !VM_IS_FINITE(x)) return VM_NAN;
    return x == 0 ? 1 : vmi_log1p(vmi_two(x, 0)).hi / x;
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
    if (!(VM_FABS(x.hi) < VM_C(0.25))) return vmi_two_over(vmi_two_over(vmi_two_plus(x, vmi_minus(y)), x), x);
    for (n = degree; n >= 0; n--) P = P * (u * u) + 1 / (vm_real)(2 * n + 3);
    return vmi_two((1 - u) / 2 * (1 - u * (1 - u) * P), 0);
}

#endif
/* base/lambert.h - Lambert's function W */
#ifndef VARMASS_BASE_LAMBERT_H
#define VARMASS_BASE_LAMBERT_H

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
        const vm_two z = vmi_two_plus(vmi_two_plus(l, vmi_minus(ln)), vmi_two(-w, 0));
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
                                    : vmi_two_plus(x, vmi_minus(ln));
        z = vmi_two_plus(z, vmi_minus(s));
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
    const vm_two ln = vmi_log1p(vmi_minus(q));
    return vmi_minus(ln);
}

/* Start of W_0 for -1/4 <= x < 1: within 0.02 */
VM_API vm_real vmi_lambert_pade(vm_real x) { return x * (3 + 4 * x) / (3 + x * (7 + x * VM_C(2.5))); }

/* and above, from L = ln(1 + x) (Winitzki) */
VM_API vm_real vmi_lambert_winitzki(vm_real L) { return L * (1 - vmi_log(1 + L).hi / (2 + L)); }

/* Lambert's W, w e^w = x: the branches W_0 >= -1 for x >= -1/e, and W_-1 <= -1 for -1/e <= x < 0. The number next to
   -1/e, a little below it, counts as -1/e and gives -1; W_-1(0) = -infinity. Within 1 ulp, x taken as exact. */
VM_API vm_real vm_lambert_w0(vm_real x)
{
    if (x == 0 || x != x) return x;
    if (!VM_IS_FINITE(x)) return VM_NAN;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 0);
    return vmi_lambert_far(vmi_log(VM_FABS(x)),
                           x < 1 ? vmi_lambert_pade(x) : vmi_lambert_winitzki(vmi_log(1 + x).hi));
}

/* Documented with vm_lambert_w0. */
VM_API vm_real vm_lambert_wm1(vm_real x)
{
    vm_two ln;
    if (!(x <= 0) || !VM_IS_FINITE(x)) return VM_NAN;
    if (x == 0) return -VM_INFINITY;
    if (x < VM_C(-0.25)) return vmi_lambert_near(vmi_lambert_depth(x), 1);
    ln = vmi_log(-x);
    return vmi_lambert_near(vmi_two_plus(vmi_two(-1, 0), vmi_minus(ln)), 1);
}

#define VMI_LAMBERT_TINY (-(VM_MANT_DIG + 2) * VM_C(0.7)) /* W_0(x) = x for ln|x| below */

/* The same from the logarithm of the argument, which itself may be too large or too small to be a number:
   W_0(e^l) for all l (Wright's omega), W_0(-e^l) and W_-1(-e^l) for l <= -1 */
VM_API vm_real vm_wright_omega(vm_real l)
{
    if (!VM_IS_FINITE(l)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return vmi_exp(l, 0);
    return vmi_lambert_far(vmi_two(l, 0), l < 0    ? vmi_lambert_pade(vmi_exp(l, 0))
                                          : l < 40 ? vmi_lambert_winitzki(vmi_log(1 + vmi_exp(l, 0)).hi)
                                                   : vmi_lambert_winitzki(l));
}

/* Documented with vm_wright_omega. */
VM_API vm_real vm_lambert_w0_neg_exp(vm_real l)
{
    if (!(l <= -1) || !VM_IS_FINITE(l)) return VM_NAN;
    if (l < VMI_LAMBERT_TINY) return -vmi_exp(l, 0);
    if (l > VM_C(-1.375)) return vmi_lambert_near(vmi_two(-1 - l, 0), 0);
    return vmi_lambert_far(vmi_two(l, 0), vmi_lambert_pade(-vmi_exp(l, 0)));
}

/* Documented with vm_wright_omega. */
VM_API vm_real vm_lambert_wm1_neg_exp(vm_real l)
{
    if (!(l <= -1) || !VM_IS_FINITE(l)) return VM_NAN;
    if (l < -1 / VM_EPSILON) return vmi_lambert_far(vmi_two(l, 0), l);
    return vmi_lambert_near(vmi_two_sum(-1, -l), 1);
}

#endif
/* mechanics/vectors.h - vectors, quaternions, rotations */
#ifndef VARMASS_MECHANICS_VECTORS_H
#define VARMASS_MECHANICS_VECTORS_H

typedef struct VM_TAG(vm_vec3) {
    vm_real x, y, z;
} vm_vec3;

typedef struct VM_TAG(vm_quat) {
    vm_real w, x, y, z;
} vm_quat;

typedef struct VM_TAG(vmi_mat3) {
    vm_vec3 x, y, z;
} vmi_mat3; /* columns: the images of the axes */

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

VM_API vm_vec3 vmi_cross(vm_vec3 a, vm_vec3 b)
{
    return vmi_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

VM_API vm_vec3 vmi_abs(vm_vec3 a) { return vmi_vec3(VM_FABS(a.x), VM_FABS(a.y), VM_FABS(a.z)); }
VM_API vm_real vmi_norm1(vm_vec3 a) { return VM_FABS(a.x) + VM_FABS(a.y) + VM_FABS(a.z); }

VM_API vm_real vmi_norm_max(vm_vec3 a)
{
    const vm_vec3 b = vmi_abs(a);
    const vm_real c = b.x > b.y ? b.x : b.y;
    return c > b.z ? c : b.z;
}

VM_API vm_real vmi_norm2(vm_vec3 a) { return vmi_hypot(vmi_hypot(a.x, a.y), a.z); }
VM_API int vmi_vec3_finite(vm_vec3 a) { return VM_IS_FINITE(a.x) && VM_IS_FINITE(a.y) && VM_IS_FINITE(a.z); }

VM_API vm_vec3 vmi_times(const vmi_mat3 *m, vm_vec3 a) /* m a */
{
    return vmi_add(vmi_scale(a.x, m->x), vmi_add(vmi_scale(a.y, m->y), vmi_scale(a.z, m->z)));
}

VM_API vm_vec3 vmi_times_transposed(const vmi_mat3 *m, vm_vec3 a) /* m^T a */
{
    return vmi_vec3(vmi_dot(m->x, a), vmi_dot(m->y, a), vmi_dot(m->z, a));
}

/* None given, which reads as the identity */
VM_API int vmi_quat_is_none(vm_quat q) { return q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0; }

/* With 1 as the size of the largest part, so that squares neither over- nor underflow; the identity for all zero */
VM_API vm_quat vmi_quat_scaled(vm_quat q)
{
    vm_real largest = VM_FABS(q.w);
    if (VM_FABS(q.x) > largest) largest = VM_FABS(q.x);
    if (VM_FABS(q.y) > largest) largest = VM_FABS(q.y);
    if (VM_FABS(q.z) > largest) largest = VM_FABS(q.z);
    if (largest == 0) q.w = largest = 1;
    q.w /= largest;
    q.x /= largest;
    q.y /= largest;
    q.z /= largest;
    return q;
}

/* The rotation of a quaternion of any length; exactly the identity for (w, 0, 0, 0) and for all zero */
VM_API vmi_mat3 vmi_rotation(vm_quat q)
{
    vm_real s;
    vmi_mat3 m;
    q = vmi_quat_scaled(q);
    s = 2 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
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

VM_API vm_vec3 vmi_get3(const vm_real *y) { return vmi_vec3(y[0], y[1], y[2]); }

VM_API void vmi_set3(vm_real *y, vm_vec3 a) {
y[0] = a.x;
y[1] = a.y;
y[2] = a.z; }

VM_API vm_quat vmi_get_quat(const vm_real *y)
{
    vm_quat q;
    q.w = y[0];
    q.x = y[1];
    q.y = y[2];
    q.z = y[3];
    return q;
}

/* The rotation of a quaternion whose length is nowhere near the ends of the type's range */
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

/* Of length 1; the identity for all zero */
VM_API vm_quat vmi_unit_quat(vm_quat q)
{
    vm_real length;
    q = vmi_quat_scaled(q);
    length = VM_SQRT(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    q.w /= length;
    q.x /= length;
    q.y /= length;
    q.z /= length;
    return q;
}

#endif
/* mechanics/inertia.h - tensors of inertia */
#ifndef VARMASS_MECHANICS_INERTIA_H
#define VARMASS_MECHANICS_INERTIA_H

typedef struct VM_TAG(vm_inertia) {
    vm_real xx, yy, zz, xy, xz, yz;
} vm_inertia; /* kg m^2, entries of the tensor */

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
    t.xx = vmi_dot(m->x, x);
    t.yy = vmi_dot(m->y, y);
    t.zz = vmi_dot(m->z, z);
    t.xy = vmi_dot(m->x, y);
    t.xz = vmi_dot(m->x, z);
    t.yz = vmi_dot(m->y, z);
    return t;
}

/* a + c b */
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

/* P(d) = |d|^2 E - d d^T: the inertia of a unit mass at d */
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
    x = a[k][p];
    y = a[k][q];
    a[k][p] = a[p][k] = c * x - s * y;
    a[k][q] = a[q][k] = s * x + c * y;
    for (k = 0; k < 3; k++) {
        x = v[k][p];
        y = v[k][q];
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

/* Moments of a body: none larger than the two others together, to within slack (kg m^2) */
VM_API int vmi_inertia_is_possible(const vmi_principal *p, vm_real slack)
{
    vm_real a = p->moment[0], b = p->moment[1], c = p->moment[2];
    return a <= b + c + slack && b <= a + c + slack && c <= a + b + slack; /* so none is below -slack */
}

/* Moments that a body can have exactly, of a tensor that is possible within slack. A moment lost in the rounding
   errors of terms of these sizes becomes 0, one above the sum of the others that sum. 1 where anything changed */
VM_API int vmi_clamp_moments(vmi_principal *p, const vm_inertia *sizes)
{
    int k, changed = 0;
    for (k = 0; k < 3; k++) {
        vm_vec3 e = vmi_abs(p->axis[k]);
        if (p->moment[k] > 8 * VM_EPSILON * vmi_dot(e, vmi_inertia_times(sizes, e)) || p->moment[k] == 0) continue;
        p->moment[k] = 0;
        changed = 1;
    }
    for (k = 0; k < 3; k++) {
        vm_real others = p->moment[(k + 1) % 3] + p->moment[(k + 2) % 3];
        if (p->moment[k] <= others) continue;
        p->moment[k] = others;
        changed = 1;
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
        i.xx += m.x * e.x;
        i.yy += m.y * e.y;
        i.zz += m.z * e.z;
        i.xy += m.x * e.y;
        i.xz += m.x * e.z;
        i.yz += m.y * e.z;
    }
    return i;
}

VM_API vm_real vmi_trace(const vm_inertia *i) { return VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz); }

/* What rounding may do to an inertia whose entries come from sums of the size of i */
VM_API vm_real vmi_slack(const vm_inertia *i) { return 32 * VM_EPSILON * vmi_trace(i); }

VM_API int vmi_inertia_finite(const vm_inertia *i)
{
    return vmi_vec3_finite(vmi_vec3(i->xx, i->yy, i->zz)) && vmi_vec3_finite(vmi_vec3(i->xy, i->xz, i->yz));
}

/* A body can have the inertia i where tr(i)/2 E - i, the second moments integral of r r^T dm, has no eigenvalue below
   zero. By elimination, with a slack added against which the rounding errors, some eps of the trace, are small */
VM_API int vmi_inertia_within(const vm_inertia *i, vm_real slack)
{
    vm_real half, x, y, z, yz;
    half = (i->xx + i->yy + i->zz + slack) / 2;
    if (half == 0) return i->xx == 0 && i->yy == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    x = half - i->xx;
    if (!(x > 0)) return 0;
    y = half - i->yy - i->xy / x * i->xy;
    if (!(y > 0)) return 0;
    yz = i->yz + i->xy / x * i->xz;
    z = half - i->zz - i->xz / x * i->xz;
    return z - yz / y * yz > 0;
}

/* 1 where a body can have this inertia: no principal moment negative or larger than the two others together, by more
   than 32 eps of the trace; rods and points are bodies. 0 otherwise, and for NaN and a null pointer. */
VM_API int vm_inertia_possible(const vm_inertia *inertia)
{
    return inertia && vmi_inertia_finite(inertia) && vmi_inertia_within(inertia, vmi_slack(inertia));
}

/* Inertia about a point d away from the mass centre, same axes, of a body whose own is given (40); with -mass the
   way back. */
VM_API vm_inertia vm_parallel_axes(const vm_inertia *own, vm_real mass, vm_vec3 d)
{
    const vm_inertia none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    return vmi_inertia_plus(own ? *own : none, mass, vmi_inertia_of_point(d));
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

/* Entries of the size of the terms that those of m^T i m are sums of */
VM_API vm_inertia vmi_inertia_sizes(const vm_inertia *i, const vmi_mat3 *m)
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

/* L D L^T of an inertia; 0 where a pivot is lost in its own rounding errors, or is not positive */
typedef struct VM_TAG(vmi_inertia_ldl) {
    vm_real xy, xz, yz, x, y, z; /* of L; of 1/D */
} vmi_inertia_ldl;

VM_INLINE int vmi_inertia_factor(const vm_inertia *i, vmi_inertia_ldl *f)
{
    const vm_real lost = 8 * VM_EPSILON;
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
    return i->xx > 0 && y > lost * i->yy && z > lost * i->zz;
}

/* Whether a body can have the inertia i, whose moments are positive, at some time of a run. The inertia of a flat
   body keeps to the bound of the triangle inequality but for the roundings of all steps, so that the slack has room
   for 1e7 (float 3000) of them. */
VMI_APART int vmi_thin_inertia_is_possible(const vm_inertia *i)
{
    const vm_real slack = VM_MANT_DIG > 24 ? VM_C(1.5e-8) : VM_C(3.5e-4); /* sqrt(eps), of the trace */
    return vmi_inertia_finite(i) && vmi_inertia_within(i, slack * (i->xx + i->yy + i->zz));
}

/* First a test that is cheap and enough for most bodies: tr(i)/2 E - i is positive definite where its least diagonal
   entry is larger than the others in its row can be. */
VM_INLINE int vmi_running_inertia_is_possible(const vm_inertia *i)
{
    const vm_real half = (i->xx + i->yy + i->zz) / 2;
    const vm_real least = half - (VM_FABS(i->xy) + VM_FABS(i->xz) + VM_FABS(i->yz));
    return (least > i->xx && least > i->yy && least > i->zz) || vmi_thin_inertia_is_possible(i);
}

/* The same, with the factors that a body needs to be accelerated */
VM_INLINE int vmi_inertia_factor_if_possible(const vm_inertia *i, vmi_inertia_ldl *f)
{
    return vmi_inertia_factor(i, f) && vmi_running_inertia_is_possible(i);
}

VM_INLINE vm_vec3 vmi_inertia_solve(const vmi_inertia_ldl *f, vm_vec3 h)
{
    vm_vec3 w;
    w.y = h.y - f->xy * h.x;
    w.z = (h.z - f->xz * h.x - f->yz * w.y) * f->z;
    w.y = w.y * f->y - f->yz * w.z;
    w.x = h.x * f->x - f->xy * w.y - f->xz * w.z;
    return w;
}

#endif
/* mechanics/bodies.h - bodies, their momentum, angular momentum and kinetic energy */
#ifndef VARMASS_MECHANICS_BODIES_H
#define VARMASS_MECHANICS_BODIES_H

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
    /* sum of all tr(I) |omega| + (|r| + |r - about|) M |v|, and the same for the impulse. It contains |r| because a
       position is rounded by eps |r|, which changes the angular momentum by eps |r| M |v|, wherever the point is */
    vm_real angular_momentum_scale;
    vm_real energy;                 /* kinetic energy after - before, J: (94) - (93) */
} vm_balance;

VM_API vm_vec3 vmi_spin_momentum(const vm_body *body) /* I omega, inertial axes */
{
    vmi_mat3 m = vmi_rotation(body->q);
    return vmi_times(&m, vmi_inertia_times(&body->inertia, vmi_times_transposed(&m, body->omega)));
}

/* Momentum M v (1)-(3), N s; angular momentum I omega + (r - about) x M v (7)-(9), N m s, about any point; kinetic
   energy (93), (97), J. Not checked: NaN in, NaN out; NaN for a null pointer. */
VM_API vm_vec3 vm_momentum(const vm_body *body)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_scale(body->mass, body->v);
}

/* Documented with vm_momentum. */
VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_add(vmi_spin_momentum(body), vmi_cross(vmi_sub(body->r, about), vm_momentum(body)));
}

/* Documented with vm_momentum. */
VM_API vm_real vm_kinetic_energy(const vm_body *body)
{
    if (!body) return VM_NAN;
    return (body->mass * vmi_dot(body->v, body->v) + vmi_dot(body->omega, vmi_spin_momentum(body))) / 2;
}

/* The plane's body with inertia.zz alone, which is all that motion in the plane asks for */
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

VM_API vm_vec3 vmi_impulse_moment(const vm_impulse *j, vm_vec3 about)
{
    return vmi_add(j->couple, vmi_cross(vmi_sub(j->at, about), j->linear));
}

VM_API int vmi_impulse_finite(const vm_impulse *j)
{
    return vmi_vec3_finite(j->linear) && vmi_vec3_finite(j->couple) && vmi_vec3_finite(j->at);
}

/* Add sign times the body's momenta and energy */
VM_API void vmi_balance_add(vm_balance *sum, vm_real sign, const vm_body *body, vm_vec3 about)
{
    vm_vec3 momentum = vm_momentum(body);
    vm_real size = vmi_norm2(momentum);
    sum->momentum = vmi_add(sum->momentum, vmi_scale(sign, momentum));
    sum->angular_momentum = vmi_add(sum->angular_momentum, vmi_scale(sign, vm_angular_momentum(body, about)));
    sum->momentum_scale += size;
    sum->angular_momentum_scale += vmi_trace(&body->inertia) * vmi_norm2(body->omega) +
                                   (vmi_norm2(body->r) + vmi_norm2(vmi_sub(body->r, about))) * size;
    sum->energy += sign * vm_kinetic_energy(body);
}

/* What is left of the balances of momentum and, about any point, of angular momentum between some bodies before and
   after an instant in which external, where not NULL, acted (4)-(6), (10)-(12): zero but for rounding errors, a few
   eps of the scales, where nothing was lost. Any number of bodies, none included, on either side.
   VM_BAD_ARGUMENT, VM_NOT_FINITE. */
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
        sum.momentum_scale += vmi_norm2(j->linear);
        sum.angular_momentum_scale +=
            vmi_norm1(j->couple) + (vmi_norm1(j->at) + vmi_norm1(vmi_sub(j->at, about))) * vmi_norm1(j->linear);
    }
    if (!VM_IS_FINITE(sum.energy) || !VM_IS_FINITE(sum.momentum_scale) ||
        !VM_IS_FINITE(sum.angular_momentum_scale) || !vmi_vec3_finite(sum.momentum) ||
        !vmi_vec3_finite(sum.angular_momentum))
        return VM_NOT_FINITE;
    *balance = sum;
    return VM_OK;
}

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
    const vm_body lifted = vmi_body_to_space(b);
    if (!vmi_body_finite(&lifted) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return b->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* Bodies of space or of the plane, whichever pointer is not NULL */
typedef struct VM_TAG(vmi_bodies) {
    int n;
    const vm_body *in_space;
    const vm_body2 *in_plane;
} vmi_bodies;

VM_API vm_body vmi_list_body(const vmi_bodies *list, int i)
{
    return list->in_plane ? vmi_body_to_space(list->in_plane + i) : list->in_space[i];
}

VM_API int vmi_check_bodies(const vmi_bodies *list)
{
    int i, status = VM_OK;
    if (list->n < 0 || (list->n > 0 && !list->in_space && !list->in_plane)) return VM_BAD_ARGUMENT;
    for (i = 0; i < list->n && !status; i++)
        status = list->in_plane ? vmi_check_body2(list->in_plane + i) : vmi_check_body(list->in_space + i);
    return status;
}

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

#endif
/* mechanics/bodies2.h - bodies that move in a plane */
#ifndef VARMASS_MECHANICS_BODIES2_H
#define VARMASS_MECHANICS_BODIES2_H

/* Documented with vm_momentum. */
VM_API vm_real vm_angular_momentum2(const vm_body2 *body, vm_real x, vm_real y)
{
    if (!body) return VM_NAN;
    return body->inertia * body->omega + body->mass * ((body->x - x) * body->vy - (body->y - y) * body->vx);
}

/* Documented with vm_momentum. */
VM_API vm_real vm_kinetic_energy2(const vm_body2 *body)
{
    if (!body) return VM_NAN;
    return (body->mass * (body->vx * body->vx + body->vy * body->vy) + body->inertia * body->omega * body->omega) /
           2;
}

/* The plane's body as a lamina in the plane z = 0 of space, which moves as it does. NaN for a null pointer. */
VM_API vm_body vm_body_from_body2(const vm_body2 *body)
{
    const vm_body2 none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    vm_body b = vmi_body_to_space(body ? body : &none);
    b.inertia.xx = b.inertia.yy = b.inertia.zz / 2;
    vmi_sincos((body ? body : &none)->angle / 2, &b.q.z, &b.q.w);
    return b;
}

#endif
/* mechanics/jumps.h - parts separate from a body or are attached to it */
#ifndef VARMASS_MECHANICS_JUMPS_H
#define VARMASS_MECHANICS_JUMPS_H

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
typedef struct VM_TAG(vmi_lump) {
    vm_real mass;
    vm_vec3 r, v;              /* from the frame's */
    vm_vec3 h;                 /* I (omega - Omega) */
    vm_inertia inertia, sizes; /* and the sizes of the terms that its entries are sums of */
    vm_real noise;             /* h is right to some eps of this */
} vmi_lump;

VM_API vmi_lump vmi_lump_of(const vmi_frame *frame, const vm_body *body)
{
    vmi_mat3 turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, own = vmi_rotation(body->q);
    const vm_quat p = body->q, q = frame->q;
    vm_vec3 spin = vmi_sub(body->omega, frame->omega);
    vmi_lump load;
    if (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z) { /* equal attitudes cost no digits */
        turn.x = vmi_times_transposed(&own, frame->turn.x);
        turn.y = vmi_times_transposed(&own, frame->turn.y);
        turn.z = vmi_times_transposed(&own, frame->turn.z);
    }
    load.mass = body->mass;
    load.r = vmi_sub(body->r, frame->r);
    load.v = vmi_sub(body->v, frame->v);
    load.h = vmi_times(&own, vmi_inertia_times(&body->inertia, vmi_times_transposed(&own, spin)));
    load.inertia = vmi_inertia_along(&body->inertia, &turn);
    load.sizes = vmi_inertia_sizes(&body->inertia, &turn);
    load.noise = vmi_trace(&body->inertia) * (vmi_norm1(body->omega) + vmi_norm1(frame->omega));
    return load;
}

/* P(d) in the frame's axes, and the sizes of its terms when d has the rounding errors of positions of size reach */
VM_API vm_inertia vmi_moved_inertia(const vmi_frame *frame, vm_vec3 d, vm_vec3 reach, vm_inertia *sizes)
{
    vmi_mat3 turn;
    vm_vec3 size;
    turn.x = vmi_abs(frame->turn.x);
    turn.y = vmi_abs(frame->turn.y);
    turn.z = vmi_abs(frame->turn.z);
    size = vmi_times_transposed(&turn, vmi_abs(d));
    reach = vmi_times_transposed(&turn, reach);
    *sizes = vmi_inertia_of_point(vmi_add(size, reach)); /* d^2 and 2 d reach */
    *sizes = vmi_inertia_plus(*sizes, -1, vmi_inertia_of_point(reach));
    sizes->xy = VM_FABS(sizes->xy);
    sizes->xz = VM_FABS(sizes->xz);
    sizes->yz = VM_FABS(sizes->yz);
    return vmi_inertia_of_point(vmi_times_transposed(&frame->turn, d));
}

/* a + sign b */
VM_API int vmi_join(const vmi_frame *frame, vmi_lump *a, vm_real sign, const vmi_lump *b)
{
    const vm_real mass = a->mass + sign * b->mass, share = sign * (b->mass / mass), reduced = a->mass * share;
    vm_vec3 origin = vmi_abs(frame->r), d = vmi_sub(b->r, a->r), v = vmi_sub(b->v, a->v);
    vm_vec3 reach = vmi_add(vmi_add(vmi_abs(a->r), vmi_abs(b->r)), vmi_add(origin, origin));
    vm_vec3 u = vmi_sub(v, vmi_cross(frame->omega, d));
    vm_real speeds = vmi_norm1(a->v) + vmi_norm1(b->v) + 2 * vmi_norm1(frame->v), turning = vmi_norm1(frame->omega);
    vm_inertia sizes, moved = vmi_moved_inertia(frame, d, reach, &sizes);
    if (!(mass > 0)) return VM_BAD_MASS;
    a->inertia = vmi_inertia_plus(vmi_inertia_plus(a->inertia, sign, b->inertia), reduced, moved);
    a->sizes = vmi_inertia_plus(vmi_inertia_plus(a->sizes, 1, b->sizes), VM_FABS(reduced), sizes);
    a->h = vmi_add(a->h, vmi_add(vmi_scale(sign, b->h), vmi_scale(reduced, vmi_cross(d, u))));
    a->noise += b->noise + VM_FABS(reduced) * vmi_norm1(d) * speeds +
                (sign < 0 ? b->mass : reduced) * vmi_norm1(reach) * (vmi_norm1(d) * turning + vmi_norm1(u));
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

VM_API void vmi_apply_impulse(const vmi_frame *frame, vmi_lump *a, const vm_impulse *external)
{
    vm_vec3 at = vmi_sub(vmi_sub(external->at, frame->r), a->r), j = external->linear;
    a->v = vmi_add(a->v, vmi_vec3(j.x / a->mass, j.y / a->mass, j.z / a->mass));
    a->h = vmi_add(a->h, vmi_add(external->couple, vmi_cross(at, j)));
    a->noise += vmi_norm1(external->couple) + (vmi_norm1(at) + vmi_norm1(frame->r)) * vmi_norm1(j);
}

VM_API vmi_frame vmi_frame_of(const vm_body *body, const vmi_bodies *others, vm_real sign)
{
    vm_real mass = body->mass;
    vmi_frame frame;
    int i;
    frame.q = body->q;
    frame.turn = vmi_rotation(body->q);
    frame.r = body->r;
    frame.v = body->v;
    frame.omega = sign < 0 || others->n == 0 ? body->omega : vmi_vec3(0, 0, 0);
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

/* The body with the others joined (sign = 1) or without them (-1), struck by the impulse */
VM_API int vmi_jump_total(const vmi_frame *frame, const vm_body *body, vm_real sign, const vmi_bodies *others,
                          const vm_impulse *external, vmi_lump *total)
{
    vmi_lump sum = vmi_lump_of(frame, body);
    int i, status = VM_OK;
    *total = sum;
    for (i = 0; i < others->n && !status; i++) {
        const vm_body other = vmi_list_body(others, i);
        const vmi_lump load = vmi_lump_of(frame, &other);
        if (i == 0) sum = load;
        else status = vmi_join(frame, &sum, 1, &load);
    }
    if (others->n > 0 && !status) status = vmi_join(frame, total, sign, &sum);
    if (status || !external) return status;
    if (!vmi_impulse_finite(external)) return VM_NOT_FINITE;
    vmi_apply_impulse(frame, total, external);
    return VM_OK;
}

/* The angular velocity, relative to the frame, of a load whose inertia has been settled */
VM_API int vmi_lump_spin(const vmi_frame *frame, const vmi_lump *load, const vmi_principal *p, vm_vec3 before,
                         vm_vec3 *omega)
{
    const vm_real noise = 2 * VM_EPSILON * (load->noise + vmi_norm1(load->h));
    int left = vmi_solve_spin(&load->inertia, p, vmi_times_transposed(&frame->turn, load->h), noise,
                              vmi_times_transposed(&frame->turn, before), omega);
    *omega = vmi_times(&frame->turn, *omega);
    return left;
}

VM_API int vmi_lump_clamp_moments(vmi_lump *load, vmi_principal *p)
{
    if (!vmi_inertia_finite(&load->inertia)) return VM_NOT_FINITE;
    *p = vmi_principal_axes(&load->inertia);
    if (!vmi_inertia_is_possible(p, vmi_slack(&load->sizes))) return VM_BAD_INERTIA;
    if (vmi_clamp_moments(p, &load->sizes)) load->inertia = vmi_inertia_from(p);
    return VM_OK;
}

VM_API int vmi_jump(const vm_body *body, int n, const vm_body *others, vm_real sign, const vm_impulse *external,
                    vm_body *result)
{
    vmi_bodies list;
    vmi_frame frame;
    vmi_lump load;
    vmi_principal p;
    vm_body b;
    int status;
    if (!body || !result) return VM_BAD_ARGUMENT;
    list.n = n;
    list.in_space = others;
    list.in_plane = NULL;
    status = vmi_check_body(body);
    if (!status) status = vmi_check_bodies(&list);
    if (status) return status;
    frame = vmi_frame_of(body, &list, sign);
    status = vmi_jump_total(&frame, body, sign, &list, external, &load);
    if (!status) status = vmi_lump_clamp_moments(&load, &p);
    if (status) return status;
    b.mass = load.mass;
    b.inertia = load.inertia;
    b.q = body->q;
    b.r = vmi_add(frame.r, load.r);
    b.v = vmi_add(frame.v, load.v);
    if (vmi_lump_spin(&frame, &load, &p, vmi_sub(body->omega, frame.omega), &b.omega)) status = VM_NULL_AXIS;
    b.omega = vmi_add(frame.omega, b.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* A part, which moved as given the instant after, has left the whole: rest gets mass, mass centre (15), inertia by
   the parallel axes, velocity (24) and angular velocity (34) of what remains; its attitude is the whole's.
   external, where not NULL, acted during the instant. Exact in space: momentum and angular momentum of rest and
   part are those of the whole plus the impulse. Where the rest is a rod or a point the spin about its null axis
   stays the whole's; VM_NULL_AXIS says that there was angular momentum left which that axis cannot carry.

   A part that moves on as before leaves the rest's motion as it was, however little of the inertia is left: only
   motions relative to the whole are added up, so that neither its speed nor a place far from the origin costs digits
   of omega. The rest's inertia is right to 8 eps of the whole's, far from the origin to what an eps of the positions
   changes; a moment below that counts as none.
   VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS (a part as heavy as the whole, for one), VM_BAD_INERTIA (a part that
   cannot have been in the whole, for one). */
VM_API int vm_separate(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL, vm_body *rest)
{
    return vmi_jump(whole, 1, part, -1, external_or_NULL, rest);
}

/* Two bodies, moving as given the instant before, have become one (which is plastic impact) (24), (33): its attitude
   is body's, and so is the spin about a null axis. */
VM_API int vm_attach(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL, vm_body *whole)
{
    return vmi_jump(body, 1, added, 1, external_or_NULL, whole);
}

/* n parts at once, n >= 0: but for rounding errors what comes of one after another. n = 0 is a blow on the body. */
VM_API int vm_separate_all(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                           vm_body *rest)
{
    return vmi_jump(whole, n, parts, -1, external_or_NULL, rest);
}

/* Documented with vm_separate_all. */
VM_API int vm_attach_all(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                         vm_body *whole)
{
    return vmi_jump(body, n, added, 1, external_or_NULL, whole);
}

VM_API vm_body vmi_body_at_rest(vm_real mass, const vm_inertia *inertia, vm_vec3 r)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = mass;
    b.inertia = *inertia;
    b.r = r;
    return b;
}

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

/* Inertia, about its own mass centre, of a and b together, and of what is left of the whole without the part
   (13)-(15), (40). d leads from the mass centre of the first to that of the second, *centre from that of the first to
   the result's: SS2 and SS1 of (15). One set of axes. Accuracy and errors are those of vm_attach and vm_separate. */
VM_API int vm_combine_inertia(vm_real mass_a, const vm_inertia *a, vm_real mass_b, const vm_inertia *b, vm_vec3 d,
                              vm_inertia *whole, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass_a, a, 1, mass_b, b, d, whole, centre);
}

/* Documented with vm_combine_inertia. */
VM_API int vm_split_inertia(vm_real mass, const vm_inertia *whole, vm_real part_mass, const vm_inertia *part,
                            vm_vec3 d, vm_inertia *rest, vm_vec3 *centre)
{
    return vmi_joined_inertia(mass, whole, -1, part_mass, part, d, rest, centre);
}

#endif
/* mechanics/jumps2.h - parts separate or are attached in a plane */
#ifndef VARMASS_MECHANICS_JUMPS2_H
#define VARMASS_MECHANICS_JUMPS2_H

VM_API vm_impulse vmi_impulse_to_space(const vm_impulse2 *j)
{
    vm_impulse lifted;
    lifted.linear = vmi_vec3(j->jx, j->jy, 0);
    lifted.couple = vmi_vec3(0, 0, j->couple);
    lifted.at = vmi_vec3(j->x, j->y, 0);
    return lifted;
}

/* (44) and its like: a load's spin relative to the frame, which without inertia is the one before */
VM_API int vmi_lump_spin2(const vmi_lump *load, vm_real before, vm_real *omega)
{
    *omega = load->inertia.zz > 0 ? load->h.z / load->inertia.zz : before;
    return !(load->inertia.zz > 0) && VM_FABS(load->h.z) > 2 * VM_EPSILON * (load->noise + VM_FABS(load->h.z));
}

VM_API int vmi_lump_clamp_moments2(vmi_lump *load)
{
    if (!VM_IS_FINITE(load->inertia.zz)) return VM_NOT_FINITE;
    if (load->inertia.zz < -32 * VM_EPSILON * load->sizes.zz) return VM_BAD_INERTIA;
    if (load->inertia.zz <= 8 * VM_EPSILON * load->sizes.zz) load->inertia.zz = 0;
    return VM_OK;
}

/* Checks, and the total of vmi_jump_total for bodies of the plane */
VM_API int vmi_jump_total2(const vm_body2 *body, const vmi_bodies *others, vm_real sign,
                           const vm_impulse2 *external, vmi_frame *frame, vmi_lump *load)
{
    vm_impulse blow;
    vm_body lifted;
    int status = vmi_check_body2(body);
    if (!status) status = vmi_check_bodies(others);
    if (status) return status;
    lifted = vmi_body_to_space(body);
    if (external) blow = vmi_impulse_to_space(external);
    *frame = vmi_frame_of(&lifted, others, sign);
    status = vmi_jump_total(frame, &lifted, sign, others, external ? &blow : NULL, load);
    return status ? status : vmi_lump_clamp_moments2(load);
}

VM_API int vmi_jump2(const vm_body2 *body, int n, const vm_body2 *others, vm_real sign, const vm_impulse2 *external,
                     vm_body2 *result)
{
    vmi_bodies list;
    vmi_frame frame;
    vmi_lump load;
    vm_body2 b;
    int status;
    if (!body || !result || (n > 0 && !others)) return VM_BAD_ARGUMENT;
    list.n = n;
    list.in_space = NULL;
    list.in_plane = others;
    status = vmi_jump_total2(body, &list, sign, external, &frame, &load);
    if (status) return status;
    b.mass = load.mass;
    b.inertia = load.inertia.zz;
    b.angle = body->angle;
    b.x = frame.r.x + load.r.x;
    b.y = frame.r.y + load.r.y;
    b.vx = frame.v.x + load.v.x;
    b.vy = frame.v.y + load.v.y;
    if (vmi_lump_spin2(&load, body->omega - frame.omega.z, &b.omega)) status = VM_NULL_AXIS;
    b.omega += frame.omega.z;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *result = b;
    return status;
}

/* The same in the plane (35)-(39); *_all2 as above */
VM_API int vm_separate2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                        vm_body2 *rest)
{
    return vmi_jump2(whole, 1, part, -1, external_or_NULL, rest);
}

/* Documented with vm_separate2. */
VM_API int vm_attach2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                      vm_body2 *whole)
{
    return vmi_jump2(body, 1, added, 1, external_or_NULL, whole);
}

/* Documented with vm_separate2. */
VM_API int vm_separate_all2(const vm_body2 *whole, int n, const vm_body2 *parts,
                            const vm_impulse2 *external_or_NULL, vm_body2 *rest)
{
    return vmi_jump2(whole, n, parts, -1, external_or_NULL, rest);
}

/* Documented with vm_separate2. */
VM_API int vm_attach_all2(const vm_body2 *body, int n, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                          vm_body2 *whole)
{
    return vmi_jump2(body, n, added, 1, external_or_NULL, whole);
}

#endif
/* mechanics/relative.h - motion relative to a moving body */
#ifndef VARMASS_MECHANICS_RELATIVE_H
#define VARMASS_MECHANICS_RELATIVE_H

/* Velocity of the point r of what moves on rigidly with a body: the dragging velocity of (25) */
VM_API vm_vec3 vmi_velocity_at(const vm_body *by, vm_vec3 r)
{
    return vmi_add(by->v, vmi_cross(by->omega, vmi_sub(r, by->r)));
}

/* Motion relative to what moves on rigidly with a body: v_r = v - v_S - Omega x (r - r_S) (25), (26), (98), (101) and
   Omega_r = omega - Omega (41), (99), (102) in v and omega; and back. All else is copied. VM_BAD_ARGUMENT. */
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

/* Documented with vm_to_relative. */
VM_API int vm_to_absolute(const vm_body *to, const vm_body *relative, vm_body *absolute)
{
    vm_body b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    b = *relative;
    b.v = vmi_add(vmi_velocity_at(to, b.r), b.v);
    b.omega = vmi_add(to->omega, b.omega);
    *absolute = b;
    return VM_OK;
}

/* Documented with vm_to_relative. */
VM_API int vm_to_relative2(const vm_body2 *to, const vm_body2 *absolute, vm_body2 *relative)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_body_to_space(absolute);
    vm_to_relative(&whole, &b, &b);
    *relative = vmi_body_to_plane(&b, absolute->angle);
    return VM_OK;
}

/* Documented with vm_to_relative. */
VM_API int vm_to_absolute2(const vm_body2 *to, const vm_body2 *relative, vm_body2 *absolute)
{
    vm_body whole, b;
    if (!to || !absolute || !relative) return VM_BAD_ARGUMENT;
    whole = vmi_body_to_space(to);
    b = vmi_body_to_space(relative);
    vm_to_absolute(&whole, &b, &b);
    *absolute = vmi_body_to_plane(&b, relative->angle);
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

/* The jump in relative motions, (28)-(31), (42)-(44): those of the part given and of the rest returned are relative
   to the whole, those of the body added and of the whole relative to the body; what the first body itself does does
   not matter. */
VM_API int vm_separate_relative(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                                vm_body *rest)
{
    return vmi_jump_relative(whole, part, -1, external_or_NULL, rest);
}

/* Documented with vm_separate_relative. */
VM_API int vm_attach_relative(const vm_body *body, const vm_body *added, const vm_impulse *external_or_NULL,
                              vm_body *whole)
{
    return vmi_jump_relative(body, added, 1, external_or_NULL, whole);
}

/* Documented with vm_separate_relative. */
VM_API int vm_separate_relative2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_body2 *rest)
{
    return vmi_jump_relative2(whole, part, -1, external_or_NULL, rest);
}

/* Documented with vm_separate_relative. */
VM_API int vm_attach_relative2(const vm_body2 *body, const vm_body2 *added, const vm_impulse2 *external_or_NULL,
                               vm_body2 *whole)
{
    return vmi_jump_relative2(body, added, 1, external_or_NULL, whole);
}

#endif
/* mechanics/inverse.h - how a part must leave for the rest to move as wanted */
#ifndef VARMASS_MECHANICS_INVERSE_H
#define VARMASS_MECHANICS_INVERSE_H

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
VM_API vm_vec3 vmi_part_spin_momentum(const vmi_frame *frame, const vmi_lump *rest, vm_vec3 rest_omega)
{
    vm_vec3 turning = vmi_times_transposed(&frame->turn, vmi_sub(rest_omega, frame->omega));
    return vmi_sub(rest->h, vmi_times(&frame->turn, vmi_inertia_times(&rest->inertia, turning)));
}

/* The load that the rest would be, with the part leaving at b's velocity but turning with the whole */
VM_API int vmi_unturned_rest(const vm_body *whole, const vm_body *b, const vm_impulse *external, vmi_frame *frame,
                             vmi_lump *rest)
{
    vm_body unturned = *b;
    vmi_bodies list;
    vmi_principal p;
    int status = vmi_check_body(whole);
    list.n = 1;
    list.in_space = &unturned;
    list.in_plane = NULL;
    if (!status) status = vmi_check_bodies(&list);
    if (status) return status;
    unturned.omega = whole->omega;
    *frame = vmi_frame_of(whole, &list, -1);
    status = vmi_jump_total(frame, whole, -1, &list, external, rest);
    return status ? status : vmi_lump_clamp_moments(rest, &p);
}

/* The inverse question: how must the part leave for the rest to move as wanted? *moving is the part with the velocity
   that gives the rest the velocity *rest_v, and then the angular velocity that gives it *rest_omega; what is not
   asked for (NULL) stays the part's. *rest_omega = 0: no rotation (Table 2, 5 and 7; Table 4, 2); *rest_v = 0 too: at
   rest (Table 3, 6 and 8); the whole's own motion: unchanged (Table 3, 7).
   VM_NULL_AXIS where the part would have to spin about an axis without inertia; errors as vm_separate. */
VM_API int vm_separation_for_rest(const vm_body *whole, const vm_body *part, const vm_impulse *external_or_NULL,
                           const vm_vec3 *rest_v_or_NULL, const vm_vec3 *rest_omega_or_NULL, vm_body *moving)
{
    vmi_frame frame, own;
    vmi_lump rest, load;
    vmi_principal p;
    vm_body b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    status = vmi_check_body(part); /* before the division by its mass */
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) b.v = vmi_part_velocity(whole, part, external_or_NULL, *rest_v_or_NULL);
    status = vmi_unturned_rest(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) {
        own = frame;
        own.q = b.q;
        own.turn = vmi_rotation(b.q); /* along the part's axes */
        load = vmi_lump_of(&own, &b);
        load.h = vmi_part_spin_momentum(&frame, &rest, *rest_omega_or_NULL);
        load.noise = rest.noise +
                     vmi_trace(&rest.inertia) * (vmi_norm1(*rest_omega_or_NULL) + vmi_norm1(frame.omega));
        status = vmi_lump_clamp_moments(&load, &p);
        if (status) return status;
        if (vmi_lump_spin(&own, &load, &p, vmi_sub(b.omega, own.omega), &b.omega)) status = VM_NULL_AXIS;
        b.omega = vmi_add(own.omega, b.omega);
    }
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* The same as vmi_unturned_rest */
VM_API int vmi_unturned_rest2(const vm_body2 *whole, const vm_body2 *b, const vm_impulse2 *external,
                              vmi_frame *frame, vmi_lump *rest)
{
    vm_body2 unturned = *b;
    vmi_bodies list;
    int status = vmi_check_body2(b);
    if (status) return status;
    unturned.omega = whole->omega;
    list.n = 1;
    list.in_space = NULL;
    list.in_plane = &unturned;
    return vmi_jump_total2(whole, &list, -1, external, frame, rest);
}

/* The same in the plane; *rest_v is vx, vy */
VM_API int vm_separation_for_rest2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                            const vm_real *rest_v_or_NULL, const vm_real *rest_omega_or_NULL, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_lump rest, load;
    vm_body2 b;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    status = vmi_check_body2(part);
    if (status) return status;
    b = *part;
    if (rest_v_or_NULL) {
        const vm_body from = vmi_body_to_space(whole), leaving = vmi_body_to_space(part);
        vm_impulse blow;
        vm_vec3 v;
        if (external_or_NULL) blow = vmi_impulse_to_space(external_or_NULL);
        v = vmi_part_velocity(&from, &leaving, external_or_NULL ? &blow : NULL,
                              vmi_vec3(rest_v_or_NULL[0], rest_v_or_NULL[1], 0));
        b.vx = v.x;
        b.vy = v.y;
    }
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (rest_omega_or_NULL) {
        load = rest;
        load.inertia.zz = b.inertia;
        load.h = vmi_part_spin_momentum(&frame, &rest, vmi_vec3(0, 0, *rest_omega_or_NULL));
        load.noise += rest.inertia.zz * (VM_FABS(*rest_omega_or_NULL) + VM_FABS(whole->omega));
        if (vmi_lump_spin2(&load, b.omega - whole->omega, &b.omega)) status = VM_NULL_AXIS;
        b.omega += whole->omega;
    }
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return status;
}

/* The part keeps its spin: which velocity gives the rest the angular velocity rest_omega? Of those that do, the one
   with the least v_r, which is orthogonal to SS2; any v_r along SS2 may be added (Table 3, 7, asked for v_r).
   VM_SINGULAR where SS2 = 0; errors as vm_separate2. */
/* What is left of h - I1 (rest_omega - Omega) must be m M/M1 SS2 x v_r, with v_r = c k x SS2 */
VM_API int vm_separation_for_spin2(const vm_body2 *whole, const vm_body2 *part, const vm_impulse2 *external_or_NULL,
                                 vm_real rest_omega, vm_body2 *moving)
{
    vmi_frame frame;
    vmi_lump rest;
    vm_body2 b;
    vm_real dx, dy, h, c;
    int status;
    if (!whole || !part || !moving) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(rest_omega)) return VM_NOT_FINITE;
    b = *part;
    dx = b.x - whole->x;
    dy = b.y - whole->y;
    b.vx = whole->vx - whole->omega * dy;
    b.vy = whole->vy + whole->omega * dx;
    status = vmi_unturned_rest2(whole, &b, external_or_NULL, &frame, &rest);
    if (status) return status;
    if (dx == 0 && dy == 0) return VM_SINGULAR;
    h = rest.h.z - b.inertia * (b.omega - whole->omega) - rest.inertia.zz * (rest_omega - whole->omega);
    c = h * rest.mass / (b.mass * whole->mass * (dx * dx + dy * dy));
    b.vx -= c * dy;
    b.vy += c * dx;
    if (vmi_check_body2(&b)) return VM_NOT_FINITE;
    *moving = b;
    return VM_OK;
}

#endif
/* mechanics/jump_energy.h - the energy that a jump sets free or takes */
#ifndef VARMASS_MECHANICS_JUMP_ENERGY_H
#define VARMASS_MECHANICS_JUMP_ENERGY_H

/* Kinetic energy of the motions relative to the whole of n bodies and one more; the impulse's work on the whole */
VM_API vm_real vmi_relative_energy(const vm_body *whole, int n, const vm_body *bodies, const vm_body *one_more,
                                   const vm_impulse *external, vm_real *work)
{
    vm_real sum = 0;
    vm_body b;
    int i;
    if (!whole || !one_more || n < 0 || (n > 0 && !bodies)) return VM_NAN;
    for (i = 0; i <= n; i++) {
        b = i < n ? bodies[i] : *one_more;
        vm_to_relative(whole, &b, &b);
        sum += vm_kinetic_energy(&b);
    }
    *work = 0;
    if (external)
        *work = vmi_dot(whole->v, external->linear) + vmi_dot(whole->omega, vmi_impulse_moment(external, whole->r));
    return sum;
}

/* Kinetic energy that the n parts and the rest have more than the whole had, J, as the theorem (113), (118) has it:
   the sum of the kinetic energies of their motions relative to the whole, exact in space, and the impulse's work
   v_S.linear + Omega.moment about S. At high speed it has digits that the difference of the energies has lost. NaN
   for a null pointer and n < 0. */
VM_API vm_real vm_energy_gain(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                              const vm_body *rest)
{
    vm_real work = 0, sum = vmi_relative_energy(whole, n, parts, rest, external_or_NULL, &work);
    return sum + work;
}

/* What body and the n added have more than the whole has, J: Carnot's loss, the kinetic energies of their motions
   relative to the whole, less the work of the impulse on it. */
VM_API vm_real vm_energy_loss(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                              const vm_body *whole)
{
    vm_real work = 0, sum = vmi_relative_energy(whole, n, added, body, external_or_NULL, &work);
    return sum - work;
}

#endif
/* mechanics/broken_rotor.h - a rotor from which a piece breaks off */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_H

#include <string.h>

/* A disc on an elastic shaft without mass, turned by a torque against viscous damping, in the plane. The shaft goes
   through the mass centre of the whole (s = 0) and passes the remainder's at distance s: at r + s (cos psi, sin psi).
   Its state is y[6] = {x, y, psi, x', y', psi'} as rk45 takes it: mass centre from where the shaft is at rest (m),
   angle (rad), rates. In the notation of (67): omega^2 = stiffness/mass, p^2 = mass/inertia,
   k* = damping/inertia, M* = torque/inertia. */
typedef struct VM_TAG(vm_broken_rotor) {
    vm_real mass;      /* kg, > 0 */
    vm_real inertia;   /* about the own mass centre, kg m^2, > 0 */
    vm_real stiffness; /* c of the shaft, N/m, >= 0 */
    vm_real damping;   /* k, N m s */
    vm_real torque;    /* N m */
    vm_real s;         /* m */
} vm_broken_rotor;

/* The break, (52)-(64) corrected: the whole touches the stator at A and loses a piece, of which A keeps its velocity
   while S2 loses that across S2A (57). This is an assumption of [1]; everything else follows by momenta. */
typedef struct VM_TAG(vm_broken_rotor_piece) {
    vm_real mass, inertia; /* m; I_S2 about the own mass centre S2, >= 0 */
    vm_real distance;      /* SS2, m */
    vm_real alpha;         /* angle from SS2 to SA, counterclockwise (Fig. 17: S2 at -alpha from SA) */
    vm_real radius;        /* SA, m */
    vm_real contact;       /* direction angle of SA in inertial axes */
} vm_broken_rotor_piece;

typedef struct VM_TAG(vm_broken_rotor_break) {
    vm_broken_rotor rest;      /* the remainder: I_S1 by the parallel axes, s = m SS2/(M - m); the rest is the whole's */
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
} vm_broken_rotor_break;

VM_API int vmi_check_rotor(const vm_broken_rotor *r)
{
    if (!VM_IS_FINITE(r->mass) || !VM_IS_FINITE(r->inertia) || !VM_IS_FINITE(r->stiffness) ||
        !VM_IS_FINITE(r->damping) || !VM_IS_FINITE(r->torque) || !VM_IS_FINITE(r->s))
        return VM_NOT_FINITE;
    if (!(r->mass > 0)) return VM_BAD_MASS;
    if (!(r->inertia > 0)) return VM_BAD_INERTIA;
    return r->stiffness >= 0 ? VM_OK : VM_DOMAIN;
}

/* (65), (66), (68), and (46) for s = 0, as an ode_rhs for n = 6; rotor points at a vm_broken_rotor */
VM_API int vm_broken_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    vm_real sine, cosine, fx, fy;
    (void)t;
    vmi_sincos(y[2], &sine, &cosine);
    fx = -r->stiffness * (y[0] + r->s * cosine);
    fy = -r->stiffness * (y[1] + r->s * sine); /* (66) */
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = fx / r->mass;
    dydt[4] = fy / r->mass;
    dydt[5] = (r->torque - r->damping * y[5] + r->s * (cosine * fy - sine * fx)) / r->inertia;
    return 0;
}

/* (67), and the coupling s p^2 omega^2 of (69) */
typedef struct VM_TAG(vmi_broken_rotor_linear) {
    vm_real omega, k, torque, s, coupling;
} vmi_broken_rotor_linear;

VM_API vmi_broken_rotor_linear vmi_broken_rotor_reduced(const vm_broken_rotor *r, int coupled)
{
    vmi_broken_rotor_linear a;
    a.omega = VM_SQRT(r->stiffness / r->mass);
    a.k = r->damping / r->inertia;
    a.torque = r->torque / r->inertia;
    a.s = r->s;
    a.coupling = coupled ? r->s * (r->stiffness / r->inertia) : 0;
    return a;
}

/* What z = y, psi, y', psi' of (69) changes by within h, by the series in t, for |h| times vmi_broken_rotor_rate at most
   1: the n-th terms of y and of s psi are then below 1/n! of the first ones */
VM_API void vmi_broken_rotor_series(const vmi_broken_rotor_linear *a, vm_real h, const vm_real *z, vm_real *change)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    const vm_real omega_h2 = (a->omega * h) * (a->omega * h), k_h = a->k * h, coupling_h2 = a->coupling * h * h;
    vm_real y0 = z[0], psi0 = z[1], y1 = z[2] * h, psi1 = z[3] * h, drive = a->torque * h * h;
    int n;
    change[0] = y1;
    change[1] = psi1;
    change[2] = change[3] = 0;
    for (n = 2; n < terms && h != 0; n++) {
        const vm_real share = 1 / (vm_real)(n * (n - 1)), y2 = -omega_h2 * (y0 + a->s * psi0) * share;
        const vm_real psi2 = (drive - k_h * (vm_real)(n - 1) * psi1 - coupling_h2 * y0) * share;
        change[0] += y2;
        change[1] += psi2;
        change[2] += (vm_real)n * y2 / h;
        change[3] += (vm_real)n * psi2 / h;
        y0 = y1;
        psi0 = psi1;
        y1 = y2;
        psi1 = psi2;
        drive = 0;
    }
}

VM_API vm_real vmi_broken_rotor_rate(const vmi_broken_rotor_linear *a)
{
    return VM_FABS(a->k) + VM_C(1.5) * a->omega + VM_SQRT(VM_FABS(a->s * a->coupling));
}

/* (e^z - 1)/z and (e^z - 1 - z)/z^2, to a few eps */
VM_API void vmi_broken_rotor_exp_quotients(vm_real z, vm_real *phi1, vm_real *phi2)
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
VM_API vm_real vmi_broken_rotor_less_sine(vm_real w, vm_real sine)
{
    const int terms = VM_MANT_DIG > 24 ? 19 : 11;
    vm_real sum = 0;
    int n;
    if (VM_FABS(w) > 1) return w - sine;
    for (n = terms; n >= 3; n -= 2) sum = w * w * (1 - sum) / (vm_real)(n * (n - 1));
    return w * sum;
}

/* cos wt, 1 - cos wt, w sin wt, sin wt/w, t - sin wt/w */
typedef struct VM_TAG(vmi_broken_rotor_swing) {
    vm_real c, c1, w_s, s_w, late;
} vmi_broken_rotor_swing;

VM_API vmi_broken_rotor_swing vmi_broken_rotor_swing_at(vm_real t, vm_real w)
{
    vmi_broken_rotor_swing g;
    vm_real half, sine;
    vmi_sincos(w * t / 2, &half, &g.c);
    vmi_sincos(w * t, &sine, &g.c);
    g.c1 = 2 * half * half;
    g.w_s = w * sine;
    g.s_w = w > 0 ? sine / w : t;
    g.late = w > 0 ? vmi_broken_rotor_less_sine(w * t, sine) / w : 0;
    return g;
}

/* (71), (72) with M* in the place of k* Omega, for z = y, psi, y', psi' and |t| times the rate of 1 and more. y
   answers to -s psi, and psi = psi0 + psi0' E1 + M* E2, E1 = (1 - e^(-kt))/k, E2 = (t - E1)/k. g0, g1, g2 solve g''
   + w^2 g = w^2 E1', w^2 E1, w^2 E2 from rest, so that g2' = g1 and g1' = g0. */
VM_API void vmi_broken_rotor_follow(vm_real t, const vmi_broken_rotor_linear *a, const vmi_broken_rotor_swing *g, vm_real *z)
{
    const vm_real w2 = a->omega * a->omega, sum = w2 + a->k * a->k;
    const vm_real y0 = z[0], psi0 = z[1], v0 = z[2], rate0 = z[3];
    vm_real E0, E1, E2, g0, g1, g2;
    vmi_broken_rotor_exp_quotients(-a->k * t, &E1, &E2);
    E0 = vmi_exp(-a->k * t, 0);
    E1 *= t;
    E2 *= t * t;
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
VM_API void vmi_broken_rotor_double(vm_real t, const vmi_broken_rotor_linear *a, vm_real *z)
{
    vm_real m[5][4], old[5][4], unit[4], h = t; /* m[j]: of the unit state j, of the torque for j = 4 */
    vmi_broken_rotor_linear driven = *a;
    int doublings = 0, i, j, k;
    for (; VM_FABS(h) * vmi_broken_rotor_rate(a) > 1; h /= 2) doublings++;
    if (doublings == 0) {
        vmi_broken_rotor_series(a, h, z, unit);
        for (i = 0; i < 4; i++) z[i] += unit[i];
        return;
    }
    for (j = 0; j < 5; j++) {
        for (i = 0; i < 4; i++) unit[i] = i == j;
        driven.torque = j < 4 ? 0 : a->torque;
        vmi_broken_rotor_series(&driven, h, unit, m[j]);
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

VM_API int vmi_broken_rotor_linearised(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, int coupled, vm_real *end)
{
    vm_real y[6], z[4];
    vmi_broken_rotor_linear a;
    vmi_broken_rotor_swing g;
    int status;
    if (!rotor || !start || !end) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_all_finite(6, start)) return VM_NOT_FINITE;
    status = vmi_check_rotor(rotor);
    if (status) return status;
    a = vmi_broken_rotor_reduced(rotor, coupled);
    g = vmi_broken_rotor_swing_at(t, a.omega);
    z[0] = start[1];
    z[1] = start[2];
    z[2] = start[4];
    z[3] = start[5];
    if (coupled || VM_FABS(t) * vmi_broken_rotor_rate(&a) <= 1) vmi_broken_rotor_double(t, &a, z);
    else vmi_broken_rotor_follow(t, &a, &g, z);
    y[0] = start[0] * g.c + (start[3] * g.s_w - a.s * g.c1); /* (70) */
    y[3] = start[3] * g.c - g.w_s * (start[0] + a.s);
    y[1] = z[0];
    y[2] = z[1];
    y[4] = z[2];
    y[5] = z[3];
    return vmi_copy_if_finite(6, y, end);
}

/* The remainder for short times, |psi| << 1, linearised: (69) complete; and without its term -s y omega^2 p^2,
   which (70)-(72) leave out, though it is of the order of the others. Both for any k*, omega, s, zero included, and
   accurate as vm_broken_rotor_free_motion is (the first to twice that). All of (69) grows exponentially: VM_NOT_FINITE where it
   overflows. */
VM_API int vm_broken_rotor_linear(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(t, rotor, start, 1, end);
}

/* Documented with vm_broken_rotor_linear. */
VM_API int vm_broken_rotor_linear_uncoupled(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(t, rotor, start, 0, end);
}

/* State at t after start by (46)-(51), exact; VM_DOMAIN unless s = 0. damping and stiffness may be 0; end may be
   start, here and below. Error: no more than the rounding of every input, t included, would do. */
/* With s = 0 the uncoupled equations are (46) itself. */
VM_API int vm_broken_rotor_free_motion(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, vm_real *end)
{
    if (rotor && rotor->s != 0) return rotor->s - rotor->s == 0 ? VM_DOMAIN : VM_NOT_FINITE;
    return vmi_broken_rotor_linearised(t, rotor, start, 0, end);
}

/* A0, B0, C0, D0 (51), m, of x + i y = (A0 + i B0) exp(i w t) + (C0 + i D0) exp(-i w t) (50), w^2 = stiffness/mass,
   not 0. The orbit's half axes are | |A0 + i B0| +- |C0 + i D0| |. The speed at t, wrong after (52), is
     w sqrt(A0^2 + B0^2 + C0^2 + D0^2 - 2 (A0 C0 + B0 D0) cos 2 w t + 2 (B0 C0 - A0 D0) sin 2 w t) */
VM_API int vm_broken_rotor_orbit(const vm_broken_rotor *rotor, const vm_real *start, vm_real *abcd)
{
    vm_real w, vx, vy, c[4];
    int status;
    if (!rotor || !start || !abcd) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, start)) return VM_NOT_FINITE;
    status = vmi_check_rotor(rotor);
    if (!status && rotor->stiffness == 0) status = VM_DOMAIN;
    if (status) return status;
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    vx = start[3] / w;
    vy = start[4] / w;
    c[0] = (start[0] + vy) / 2;
    c[1] = (start[1] - vx) / 2;
    c[2] = (start[0] - vy) / 2;
    c[3] = (start[1] + vx) / 2;
    return vmi_copy_if_finite(4, c, abcd);
}

/* -- The break, in axes along SA and counterclockwise across it -- */
VM_API int vmi_check_piece(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p)
{
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->inertia) || !VM_IS_FINITE(p->distance) ||
        !VM_IS_FINITE(p->alpha) || !VM_IS_FINITE(p->radius) || !VM_IS_FINITE(p->contact))
        return VM_NOT_FINITE;
    if (!(p->mass > 0 && p->mass < whole->mass)) return VM_BAD_MASS;
    return p->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* (x, y) turned by the angle whose sine and cosine are given */
VM_API void vmi_broken_rotor_turn(vm_real sine, vm_real cosine, vm_real *x, vm_real *y)
{
    const vm_real x0 = *x;
    *x = cosine * x0 - sine * *y;
    *y = sine * x0 + cosine * *y;
}

/* State of a body whose mass centre is at d from S, at angle psi, moving relative to the whole by (ux, uy), spin */
VM_API void vmi_broken_rotor_moved(const vm_real *before, vm_real psi, vm_real dx, vm_real dy, vm_real ux, vm_real uy,
                            vm_real spin, vm_real *state)
{
    state[0] = before[0] + dx;
    state[1] = before[1] + dy;
    state[2] = psi;
    state[3] = before[3] - before[5] * dy + ux;
    state[4] = before[4] + before[5] * dx + uy;
    state[5] = before[5] + spin;
}

/* Mass, inertia and eccentricity of the rest */
VM_API int vmi_broken_rotor_rest(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_broken_rotor *rest)
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
VM_API vm_real vmi_broken_rotor_contact(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_real spin, const vm_real *d,
                                 const vm_real *v, vm_real *e, vm_broken_rotor_break *b)
{
    const vm_real ux = v[0] - spin * d[1], uy = v[1] + spin * d[0], reduced = p->mass / b->rest.mass * whole->mass;
    const vm_real reach_x = p->radius - d[0], reach_y = -d[1], reach = vmi_hypot(reach_x, reach_y);
    vm_real moment; /* SS2 x v_T */
    e[0] = reach_x / reach;
    e[1] = reach_y / reach;
    b->dragging = vmi_hypot(ux, uy);
    b->gamma = vmi_atan2(uy, ux);
    b->beta = vmi_atan2(reach_y, reach_x);
    b->normal = ux * e[0] + uy * e[1];
    b->tangential = uy * e[0] - ux * e[1];
    moment = b->tangential * (d[0] * e[0] + d[1] * e[1]);
    b->spin_piece = b->tangential / reach;
    b->spin_rest = (reduced * moment - p->inertia * b->spin_piece) / b->rest.inertia;
    b->stop_inertia = (whole->inertia * spin + reduced * (moment - p->distance * p->distance * spin)) /
                      (spin + b->spin_piece);
    return reach;
}

/* The remainder's spin, state[5], is Omega_b + Omega_r1  [(59), (64) corrected]. Refuses m not in (0, M), an I_S1
   that is negative or lost in rounding errors (VM_BAD_INERTIA), a whole with s != 0 and S2 at A (VM_DOMAIN). */
VM_API int vm_broken_rotor_break_off(const vm_broken_rotor *whole, const vm_real *before, const vm_broken_rotor_piece *piece,
                              vm_broken_rotor_break *result)
{
    vm_broken_rotor_break b;
    vm_real sine, cosine, d[2], v[2], e[2], share, T;
    int status;
    if (!whole || !before || !piece || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_rotor(whole);
    if (!status) status = vmi_all_finite(6, before) ? vmi_check_piece(whole, piece) : VM_NOT_FINITE;
    if (!status && whole->s != 0) status = VM_DOMAIN;
    if (!status) status = vmi_broken_rotor_rest(whole, piece, &b.rest);
    if (status) return status;

    vmi_sincos(piece->alpha, &sine, &cosine);
    d[0] = piece->distance * cosine;
    d[1] = -piece->distance * sine;
    vmi_sincos(piece->contact, &sine, &cosine);
    v[0] = before[3];
    v[1] = before[4];
    vmi_broken_rotor_turn(-sine, cosine, &v[0], &v[1]);
    if (!(vmi_broken_rotor_contact(whole, piece, before[5], d, v, e, &b) > 0)) return VM_DOMAIN;

    vmi_broken_rotor_turn(sine, cosine, &d[0], &d[1]);
    vmi_broken_rotor_turn(sine, cosine, &e[0], &e[1]);
    share = piece->mass / b.rest.mass;
    T = b.tangential;
    vmi_broken_rotor_moved(before, piece->contact - piece->alpha, d[0], d[1], T * e[1], -T * e[0], b.spin_piece, b.piece);
    vmi_broken_rotor_moved(before, piece->contact - piece->alpha, -share * d[0], -share * d[1], -share * T * e[1],
                    share * T * e[0], b.spin_rest, b.state);
    if (!vmi_all_finite(6, b.state) || !vmi_all_finite(6, b.piece)) return VM_NOT_FINITE;
    *result = b;
    return VM_OK;
}

/* Polar form (75), y[6] = {r, phi, psi, r', phi', psi'}; stops the run with VM_DOMAIN at r = 0. The conversions
   refuse r = 0 and r < 0. */
/* -- Polar form -- */
VM_API int vm_broken_rotor_polar_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    const vm_real w2 = r->stiffness / r->mass;
    vm_real sine, cosine;
    (void)t;
    if (!(y[0] > 0)) return VM_DOMAIN;
    vmi_sincos(y[1] - y[2], &sine, &cosine);
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = y[0] * (y[4] * y[4]) - w2 * (y[0] + r->s * cosine);
    dydt[4] = (r->s * w2 * sine - 2 * y[3] * y[4]) / y[0];
    dydt[5] = (r->torque - r->damping * y[5] - r->s * r->stiffness * y[0] * sine) / r->inertia;
    return 0;
}

/* Documented with vm_broken_rotor_polar_rhs. */
VM_API int vm_broken_rotor_to_polar(const vm_real *y, vm_real *polar)
{
    vm_real p[6], c, s;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, y)) return VM_NOT_FINITE;
    p[0] = vmi_hypot(y[0], y[1]);
    if (!(p[0] > 0)) return VM_DOMAIN;
    c = y[0] / p[0];
    s = y[1] / p[0];
    p[1] = vmi_atan2(y[1], y[0]);
    p[2] = y[2];
    p[3] = c * y[3] + s * y[4];
    p[4] = (c * y[4] - s * y[3]) / p[0];
    p[5] = y[5];
    return vmi_copy_if_finite(6, p, polar);
}

/* Documented with vm_broken_rotor_polar_rhs. */
VM_API int vm_broken_rotor_from_polar(const vm_real *polar, vm_real *y)
{
    vm_real z[6], c, s, across;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, polar)) return VM_NOT_FINITE;
    if (!(polar[0] > 0)) return VM_DOMAIN;
    vmi_sincos(polar[1], &s, &c);
    across = polar[0] * polar[4];
    z[0] = polar[0] * c;
    z[1] = polar[0] * s;
    z[2] = polar[2];
    z[3] = polar[3] * c - across * s;
    z[4] = polar[3] * s + across * c;
    z[5] = polar[5];
    return vmi_copy_if_finite(6, z, y);
}

/* -- The steady motion and its stability -- */
/* (omega^2 - Omega^2) mass, whose sign is right and whose relative error is an eps however near resonance is */
VM_API vm_real vmi_broken_rotor_detuning(const vm_broken_rotor *r, vm_real Omega)
{
    const vm_two load = vmi_two_times(vmi_two_product(r->mass, Omega), vmi_two(-Omega, 0));
    const vm_two left = vmi_two_plus(vmi_two(r->stiffness, 0), load);
    return left.hi + left.lo;
}

/* Steady motion at psi' = Omega, which needs torque = damping Omega (47). r_SS = s omega^2/(omega^2 - Omega^2), m:
   positive as in (77), phi = psi + pi, where Omega^2 < omega^2; negative as in (76), phi = psi. Infinite at resonance
   (NaN for s = 0). Within 2 eps however near resonance is. */
VM_API vm_real vm_broken_rotor_steady_radius(const vm_broken_rotor *rotor, vm_real Omega)
{
    vm_real detuning, share;
    if (!rotor || vmi_check_rotor(rotor) || !VM_IS_FINITE(Omega)) return VM_NAN;
    detuning = vmi_broken_rotor_detuning(rotor, Omega);
    if (VM_IS_FINITE(detuning)) return rotor->s * (rotor->stiffness / detuning);
    share = rotor->stiffness / (rotor->mass * Omega) / Omega; /* omega^2/Omega^2 < 1: mass Omega^2 overflows */
    return -rotor->s * (share / (1 - share));
}

/* w^2, O^2, k*, D and G of (81) */
typedef struct VM_TAG(vmi_broken_rotor_steady) {
    vm_real w2, O2, k, D, G;
} vmi_broken_rotor_steady;

VM_API int vmi_broken_rotor_about_steady(const vm_broken_rotor *r, vm_real Omega, vmi_broken_rotor_steady *a)
{
    int status;
    vm_real detuning;
    if (!r) return VM_BAD_ARGUMENT;
    status = VM_IS_FINITE(Omega) ? vmi_check_rotor(r) : VM_NOT_FINITE;
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

/* Small motions about it, exp(lambda t). (81) corrected (its last term lacks lambda^2) is lambda times the polynomial
     l^5 + k* l^4 + (2 (w^2 + O^2) + G) l^3 + 2 k* (w^2 + O^2) l^2 + (D^2 + G (w^2 + 3 O^2)) l + k* D^2,
   D = w^2 - O^2, G = s^2 p^2 w^4/D: c[6], highest power first. lambda = 0 is the freedom of the phase. */
VM_API int vm_broken_rotor_characteristic(const vm_broken_rotor *rotor, vm_real Omega, vm_real *c)
{
    vmi_broken_rotor_steady a;
    vm_real p[6];
    int status = c ? vmi_broken_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = 2 * (a.w2 + a.O2) + a.G;
    p[3] = 2 * a.k * (a.w2 + a.O2);
    p[4] = a.D * a.D + a.G * (a.w2 + 3 * a.O2);
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(6, p, c);
}

/* Routh's first column 1, k*, G, k* D, 4 G Omega^2, k* D^2 */
VM_API int vm_broken_rotor_routh(const vm_broken_rotor *rotor, vm_real Omega, vm_real *column)
{
    vmi_broken_rotor_steady a;
    vm_real p[6];
    int status = column ? vmi_broken_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = a.G;
    p[3] = a.k * a.D;
    p[4] = 4 * a.G * a.O2;
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(6, p, column);
}

/* 1 where the steady motion is asymptotically stable, exactly Omega^2 < omega^2 (82) with k* > 0, s != 0, Omega != 0;
   else 0 (for k*, s or Omega = 0 some motions neither grow nor fade) */
VM_API int vm_broken_rotor_is_stable(const vm_broken_rotor *rotor, vm_real Omega)
{
    if (!rotor || vmi_check_rotor(rotor) || !VM_IS_FINITE(Omega)) return 0;
    return rotor->damping > 0 && rotor->s != 0 && Omega != 0 && vmi_broken_rotor_detuning(rotor, Omega) > 0;
}

/* Its five roots, by rising |imaginary part|, pairs as (+, -): each within twice what an eps of every coefficient
   would do, the smallest too, which near resonance is many orders below the largest. VM_DOMAIN at resonance. */
/* lambda is measured in size = |Omega| + omega + k* + sqrt|G|, so that no coefficient is above 10. */
VM_API int vm_broken_rotor_eigenvalues(const vm_broken_rotor *rotor, vm_real Omega, vm_real *re, vm_real *im)
{
    vmi_broken_rotor_steady a;
    vm_real c[6], x[5], y[5], size, power;
    int i, status = re && im ? vmi_broken_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (!status) status = vm_broken_rotor_characteristic(rotor, Omega, c);
    if (status) return status;
    size = VM_FABS(Omega) + VM_SQRT(a.w2) + VM_FABS(a.k) + VM_SQRT(VM_FABS(a.G));
    for (i = 1, power = 1 / size; i < 6; i++, power /= size) c[i] *= power;
    if (!vmi_all_finite(6, c)) return VM_NOT_FINITE;
    vmi_poly_roots(5, c, x, y);
    for (i = 0; i < 5; i++) {
        x[i] *= size;
        y[i] *= size;
    }
    if (!vmi_all_finite(5, x)) return VM_NOT_FINITE;
    status = vmi_copy_if_finite(5, y, im);
    if (!status) memcpy(re, x, sizeof x);
    return status;
}

/* ln(1 + x) - x + x^2/2, x >= 0, to a few eps: x^3/3 - x^4/4 ..., by powers of w = x/(2 + x), all terms positive */
VM_API vm_real vmi_broken_rotor_growth_time(vm_real x)
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

/* r(t) after a start from rest where Omega = torque/damping is not below omega: psi' is caught at omega, and what the
   torque has left goes into the orbit. r = |s|/4 + R with R R' = k* (Omega - omega)/(2 p^2 omega) + k* |s|/(4 p^2 R),
   R(0) = 0, which changes over from one law to the other,
     R = (3 k* |s| t/(4 p^2))^(1/3) at resonance,  R -> (k* (Omega - omega) t/(p^2 omega))^(1/2) above it.
   s/4 is the next order. Not in it: terms of s^2/r and the time of the capture (Fig. 18 at t = 400: 0.001 of 3.473
   and 0.093 of 12.437 too little and too much). NaN below resonance, for t < 0, k* < 0 and omega = 0. */
VM_API vm_real vm_broken_rotor_resonance_radius(vm_real t, const vm_broken_rotor *rotor, vm_real Omega)
{
    vm_real over, w, A, B, R, z;
    if (!rotor || vmi_check_rotor(rotor) || !(t >= 0) || !VM_IS_FINITE(t) || !VM_IS_FINITE(Omega)) return VM_NAN;
    over = -vmi_broken_rotor_detuning(rotor, Omega);
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    if (!(over >= 0) || !(w > 0) || !(rotor->damping >= 0)) return VM_NAN;
    A = rotor->damping * (over / rotor->mass / (VM_FABS(Omega) + w)) / (2 * rotor->mass * w);
    B = rotor->damping * VM_FABS(rotor->s) / (4 * rotor->mass);
    R = vmi_pow_checked(3 * B * t, VM_C(1.) / 3);
    if (A == 0 || t == 0) return VM_FABS(rotor->s) / 4 + R;
    z = A * R / B;
    if (!(z < 1 / VM_EPSILON)) R = VM_SQRT(2 * A * t); /* B = 0 among it */
    else if (z > VM_EPSILON) R = vmi_broken_rotor_growth_root(z * z * z / 3) * B / A;
    return VM_FABS(rotor->s) / 4 + R;
}

#endif
/* mechanics/generalized_force.h - generalised forces */
#ifndef VARMASS_MECHANICS_GENERALIZED_FORCE_H
#define VARMASS_MECHANICS_GENERALIZED_FORCE_H

/* Q_i += force dr/dq_i + moment domega/dq'_i, i < n (235): of outer loads F, M; of streams M' u at the point where
   they cross, and M' kappa omega2. dr or domega may be null: no part of it. */
VM_API void vm_lagrange_add_force(int n, vm_vec3 force, const vm_vec3 *dr, vm_vec3 moment, const vm_vec3 *domega, vm_real *Q)
{
    if (!Q) return;
    int k;
    for (k = 0; k < n; k++) Q[k] += (dr ? vmi_dot(force, dr[k]) : 0) + (domega ? vmi_dot(moment, domega[k]) : 0);
}

#endif
/* mechanics/lagrange_jump.h - Lagrange's equations across a jump */
#ifndef VARMASS_MECHANICS_LAGRANGE_JUMP_H
#define VARMASS_MECHANICS_LAGRANGE_JUMP_H

#include <string.h>

/* (96): d(T2 - T1)/dqdot = impulse, where the part's velocity relative to the body is held while differentiating, so
   that d(T of the part)/dqdot is its generalized momentum part:
     after qdot_after = before qdot - part + impulse    separation
     after qdot_after = before qdot + part + impulse    attachment
   Mass matrices n by n; part and impulse may be null (zero); qdot_after may be qdot. A part of little mass changes
   qdot by little, and that to a few eps of the change. VM_SINGULAR where a coordinate, or several together, move no
   mass, or a negative one: an entry on after's diagonal is not positive, or a pivot below 4 n eps once that is scaled
   to 1. */
#define VM_LAGRANGE_WORK(n) ((n) * ((n) + 2))

/* Generalized coordinates q_i, i < n (or velocities qdot_i that are no derivatives, as those about the axes). A body
   enters by dr[i] = dv/dqdot_i of its mass centre and turn[i] = d omega/dqdot_i, in inertial axes (87)-(90). With
   these each function adds to its last argument: a body's share of the mass matrix (n by n, T = qdot^T matrix
   qdot/2), the generalized momentum of a body (as it moves), the generalized impulse (95) of what acts on a body
   whose mass centre is at r; its moment is that about r, as (23a) should have said. dr or turn may be null: no part
   of it. With another null pointer nothing is added. */
VM_API void vm_lagrange_mass(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *matrix)
{
    if (!body || !matrix) return;
    const vm_vec3 none = {0, 0, 0};
    int i, j;
    for (j = 0; j < n; j++) {
        vm_body moved = *body;
        vm_vec3 spin;
        moved.omega = turn ? turn[j] : none;
        spin = vmi_spin_momentum(&moved);
        for (i = 0; i < n; i++)
            matrix[i * n + j] +=
                (dr ? body->mass * vmi_dot(dr[i], dr[j]) : 0) + (turn ? vmi_dot(turn[i], spin) : 0);
    }
}

/* Documented with vm_lagrange_mass. */
VM_API void vm_lagrange_momentum(int n, const vm_body *body, const vm_vec3 *dr, const vm_vec3 *turn, vm_real *p)
{
    if (!body || !p) return;
    vm_lagrange_add_force(n, vm_momentum(body), dr, vmi_spin_momentum(body), turn, p);
}

/* Documented with vm_lagrange_mass. */
VM_API void vm_lagrange_impulse(int n, const vm_impulse *impulse, vm_vec3 r, const vm_vec3 *dr, const vm_vec3 *turn,
                                vm_real *p)
{
    if (!impulse || !p) return;
    const vm_vec3 moment = vmi_add(impulse->couple, vmi_cross(vmi_sub(impulse->at, r), impulse->linear));
    vm_lagrange_add_force(n, impulse->linear, dr, moment, turn, p);
}

/* matrix (qdot_after - qdot) = b, of which work has b behind room for the matrix */
VM_API int vmi_lagrange_solve(int n, const vm_real *matrix, const vm_real *qdot, vm_real *qdot_after, vm_real *work)
{
    vm_real *a = work, *b = a + n * n, *scale = b + n;
    int i;
    if (!vmi_all_finite(n * n, matrix) || !vmi_all_finite(n, qdot) || !vmi_all_finite(n, b)) return VM_NOT_FINITE;
    memcpy(a, matrix, (size_t)(n * n) * sizeof *a);
    if (vmi_solve_mass(n, a, b, scale)) return VM_SINGULAR;
    for (i = 0; i < n; i++) b[i] += qdot[i];
    return vmi_copy_if_finite(n, b, qdot_after);
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

/* matrix (qdot_after - qdot) = impulse: no mass changes. Also a separation, free of cancellation for m -> M, where
   matrix is that of the rest and -impulse the momentum of the part's motion relative to the body. */
VM_API int vm_lagrange_impact(int n, const vm_real *matrix, const vm_real *qdot, const vm_real *impulse,
                           vm_real *qdot_after, vm_real *work)
{
    if (!impulse) return VM_BAD_ARGUMENT;
    return vmi_lagrange_jump(n, matrix, matrix, qdot, NULL, 0, impulse, qdot_after, work);
}

#endif
/* mechanics/pendulum.h - a pendulum from which a part is cut */
#ifndef VARMASS_MECHANICS_PENDULUM_H
#define VARMASS_MECHANICS_PENDULUM_H

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

VM_API int vmi_check_pendulum(const vm_pendulum *p, vm_real part)
{
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->length) || !VM_IS_FINITE(p->angle) || !VM_IS_FINITE(p->rate) ||
        !VM_IS_FINITE(part))
        return VM_NOT_FINITE;
    if (!(p->mass > 0)) return VM_BAD_MASS;
    if (p->axes != VM_AXES_COS_SIN && p->axes != VM_AXES_SIN_COS) return VM_DOMAIN;
    return part > 0 && part < p->length ? VM_OK : VM_DOMAIN;
}

/* part is l, 0 < l < L; u in the axes of the pendulum. phi1' = phi' - l/(L - l)^3 (l^2 Omega/4 + 3 s (x u_y - y
   u_x)), s = 1 for (cos, sin), -1 for (sin, cos): (125), (132) corrected, with what cancels cancelled */
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
    if (pendulum->axes == VM_AXES_COS_SIN) {
        vmi_sincos(pendulum->angle, &ey, &ex);
        fx = -ey;
        fy = ex;
    } else {
        vmi_sincos(pendulum->angle, &ex, &ey);
        fx = ey;
        fy = -ex;
    }
    rho = pendulum->length - part / 2;
    left = pendulum->length - part;
    across = ux * fx + uy * fy;
    change = -part * (part * part * Omega / 4 + 3 * rho * across) / (left * left * left);

    c.rest = *pendulum;
    c.rest.mass = rest_mass = pendulum->mass * (left / pendulum->length);
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
    c.pivot_x = rest_mass * left / 2 * change * fx + c.mass * ux; /* momentum after less before */
    c.pivot_y = rest_mass * left / 2 * change * fy + c.mass * uy;
    if (!VM_IS_FINITE(c.rest.rate) || !VM_IS_FINITE(c.vx) || !VM_IS_FINITE(c.vy) || !VM_IS_FINITE(c.T1) ||
        !VM_IS_FINITE(c.L1) || !VM_IS_FINITE(c.L2) || !VM_IS_FINITE(c.T_S1) || !VM_IS_FINITE(c.T_S2) ||
        !VM_IS_FINITE(c.pivot_x) || !VM_IS_FINITE(c.pivot_y))
        return VM_NOT_FINITE;
    *cut = c;
    return VM_OK;
}

#endif
/* mechanics/torque_free.h - exact rotation of a body without torque */
#ifndef VARMASS_MECHANICS_TORQUE_FREE_H
#define VARMASS_MECHANICS_TORQUE_FREE_H

#include <string.h>

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
   Cost: a time 17 to 19 times the C library's sin, preparing a motion 10 to 20 times that, 40 with products of
   inertia. */
typedef struct VM_TAG(vm_torque_free) {
    vm_body body; /* at t0 */
    vm_real t0;
    vmi_mat3 axes;               /* 1, 2, 3: principal, right-handed; in body axes */
    vm_quat start;               /* turns the axes in which angular momentum is along 3, or -3, into inertial ones */
    vm_real spin[3];             /* omega = spin[0] cn, spin[1] sn, spin[2] dn along 1, 2, 3, rad/s */
    vm_real lean[3];             /* the same of angular momentum over its size, as parts of a quaternion */
    vm_two phase, phase_rate, K; /* of u/(4K), K the quarter period; on the separatrix K is 0, and they are of u */
    vm_two turn_rate;            /* mean rate of half the angle about the angular momentum, turns/s */
    vm_real m1;                  /* 1 - m of sn, cn, dn */
    vmi_theta_form far_form;     /* of theirs far from 0 */
    vmi_doubled_theta theta;     /* what half that angle is beyond its mean */
} vm_torque_free;                /* plain data: it may be copied */

/* Along principal axes 1, 2, 3, where 2 has the middle moment and omega circles 3, with u of the constant rate wp,
     w1 = a1 cn u,  w2 = -sigma s a2 sn u,  w3 = s a3 dn u,  s = sign(w3), sigma = sign(I1 - I3);
   with M the shortest rotation that takes l = J omega/L to s e3 and L = |J omega|, the attitude is
     q(t) = start R(t),  R = (cos h + s e3 sin h) M,  h = kappa t + sigma arg theta(u)
   (Jacobi 1850; van Zon and Schofield, J. Comput. Phys. 225 (2007), have a theta series for 2h). The set-up is in
   two words, since the rates wp/(4K) and kappa are multiplied by long times; then all but their products is in
   one. */
/* A power of two within a factor of 2 of x > 0 */
VM_API vm_real vmi_torque_free_power(vm_real x)
{
    return x < VM_MIN ? VM_MIN : vmi_from_bits(vmi_to_bits(x) & ~(((vmi_bits)1 << VMI_STORED_DIG) - 1));
}

typedef struct VM_TAG(vmi_vec3_two) {
    vm_two x[3];
} vmi_vec3_two;

VM_API vmi_vec3_two vmi_torque_free_cross(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    vmi_vec3_two c;
    int k;
    for (k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.x[k] = vmi_two_minus(vmi_two_times(a->x[i], b->x[j]), vmi_two_times(a->x[j], b->x[i]));
    }
    return c;
}

VM_API vm_vec3 vmi_torque_free_high_words(const vmi_vec3_two *a) { return vmi_vec3(a->x[0].hi, a->x[1].hi, a->x[2].hi); }

VM_API vm_two vmi_torque_free_two_pi(void)
{
    const vmi_three half_pi = vmi_half_pi();
    return vmi_two(4 * half_pi.hi, 4 * half_pi.mid);
}

VM_API vm_two vmi_torque_free_dot(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    return vmi_two_plus(vmi_two_times(a->x[0], b->x[0]),
                        vmi_two_plus(vmi_two_times(a->x[1], b->x[1]), vmi_two_times(a->x[2], b->x[2])));
}

VM_API vmi_vec3_two vmi_torque_free_vector(vm_vec3 a, vm_real power) /* a/power */
{
    vmi_vec3_two v;
    v.x[0] = vmi_two(a.x / power, 0);
    v.x[1] = vmi_two(a.y / power, 0);
    v.x[2] = vmi_two(a.z / power, 0);
    return v;
}

/* x, or 0 where its square would be lost by underflow: for 2^-505 (float 2^-57) of the largest and less */
VM_API vm_two vmi_torque_free_squarable(vm_two x) { return VM_FABS(x.hi) < 64 * VM_SQRT(VM_MIN) ? vmi_two(0, 0) : x; }

/* What the rotation of q turns into a: a + 2 (v x (v x a) - w v x a)/|q|^2, for q = (w, v) of any length but 0 */
VM_API vmi_vec3_two vmi_torque_free_back(vm_quat q, const vmi_vec3_two *a)
{
    const vm_vec3 part = vmi_vec3(q.x, q.y, q.z);
    const vm_real longest = vmi_norm_max(part), w = VM_FABS(q.w);
    const vm_real power = vmi_torque_free_power(longest > w ? longest : w);
    const vmi_vec3_two v = vmi_torque_free_vector(part, power), b = vmi_torque_free_cross(&v, a), c = vmi_torque_free_cross(&v, &b);
    const vm_two real = vmi_two(q.w / power, 0);
    const vm_two size = vmi_two_plus(vmi_two_times(real, real), vmi_torque_free_dot(&v, &v));
    const vm_two factor = vmi_two_over(vmi_two(2, 0), size);
    vmi_vec3_two result;
    int k;
    for (k = 0; k < 3; k++)
        result.x[k] = vmi_two_plus(a->x[k],
                                   vmi_two_times(factor, vmi_two_minus(c.x[k], vmi_two_times(real, b.x[k]))));
    return result;
}

/* Moments, axes (columns in body axes) and omega along them */
typedef struct VM_TAG(vmi_torque_free_body) {
    vm_two moment[3];
    vmi_vec3_two axis[3], omega;
} vmi_torque_free_body;

/* vmi_jacobi_rotation in two words; a is scaled to 1, and what is below eps^3 is nothing */
VM_API void vmi_torque_free_annihilate(vm_two a[3][3], vmi_vec3_two *axis, int p, int q)
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
    x = a[k][p];
    y = a[k][q];
    a[k][p] = a[p][k] = vmi_two_minus(vmi_two_times(c, x), vmi_two_times(s, y));
    a[k][q] = a[q][k] = vmi_two_plus(vmi_two_times(s, x), vmi_two_times(c, y));
    for (k = 0; k < 3; k++) {
        x = axis[p].x[k];
        y = axis[q].x[k];
        axis[p].x[k] = vmi_two_minus(vmi_two_times(c, x), vmi_two_times(s, y));
        axis[q].x[k] = vmi_two_plus(vmi_two_times(s, x), vmi_two_times(c, y));
    }
}

/* Principal moments over a power of two, and axes, in two words; of a rod or a point exactly */
VM_API void vmi_torque_free_principal(const vm_inertia *i, vmi_torque_free_body *b)
{
    const vm_real power = vmi_torque_free_power(vmi_trace(i));
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
    for (sweep = 0; sweep < 12; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q].hi != 0) vmi_torque_free_annihilate(a, b->axis, p, q);
    for (k = 0; k < 3; k++) b->moment[k] = a[k][k];
}

/* A moment lost in the rounding errors of the tensor is that of a rod: 0, and the others are equal */
VM_API void vmi_torque_free_clamp_moments(const vm_inertia *i, vmi_torque_free_body *b)
{
    const vmi_mat3 same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const vm_inertia sizes = vmi_inertia_sizes(i, &same);
    const vm_real power = vmi_torque_free_power(vmi_trace(i));
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 size = vmi_abs(vmi_torque_free_high_words(&b->axis[k]));
        if (b->moment[k].hi * power > 8 * VM_EPSILON * vmi_dot(size, vmi_inertia_times(&sizes, size))) continue;
        b->moment[k] = vmi_two(0, 0);
        b->moment[(k + 1) % 3] = b->moment[(k + 2) % 3];
    }
}

/* All but equal: what two words cannot tell apart where they come from a tensor; stored moments differ by more */
VM_API int vmi_torque_free_equal(vm_two a, vm_two b)
{
    return VM_FABS(vmi_two_minus(a, b).hi) <= 64 * VM_EPSILON * VM_EPSILON * (a.hi + b.hi);
}

/* The body in axes 1, 2, 3 */
typedef struct VM_TAG(vmi_torque_free_axes) {
    vm_two I1, I2, I3, w1, w2, w3, d12, d23, d13;
    vm_two S; /* |2T I2 - L^2|, which is 0 on the separatrix */
    vm_real sigma, s;
    int symmetric; /* I1 = I2 */
    vmi_mat3 axes;
} vmi_torque_free_axes;

VM_API vmi_three vmi_torque_free_three(vm_two x) { return vmi_three_words(x.hi, x.lo, 0); }

/* J d w^2 in three words, in which stored numbers lose nothing that a difference could bring up */
VM_API vmi_three vmi_torque_free_excess(vm_two J, vm_two d, vm_two w)
{
    const vmi_three square = vmi_three_times(vmi_torque_free_three(w), vmi_torque_free_three(w));
    return vmi_three_times(vmi_three_times(vmi_torque_free_three(J), vmi_torque_free_three(d)), square);
}

/* J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2 = 2T J_b - L^2 */
VM_API vmi_three vmi_torque_free_separation(const vm_two *J, const vm_two *w, int a, int b, int c)
{
    const vmi_three smallest = vmi_torque_free_excess(J[c], vmi_two_minus(J[b], J[c]), w[c]);
    return vmi_three_plus(smallest, vmi_torque_free_excess(J[a], vmi_two_minus(J[b], J[a]), w[a]));
}

/* order[] by falling moments; 1 where it is an even permutation */
VM_API int vmi_torque_free_sort(const vm_two *J, int *order)
{
    int k, even = 1;
    for (k = 0; k < 3; k++) order[k] = k;
    for (k = 0; k < 3; k++) { /* the first two, the last two, the first two */
        const int i = k == 1, first = order[i];
        if (!(vmi_two_minus(J[order[i + 1]], J[first]).hi > 0)) continue;
        order[i] = order[i + 1];
        order[i + 1] = first;
        even = !even;
    }
    return even;
}

/* omega circles the smallest moment where the separation is positive, else the largest; of two equal moments, the
   third */
VM_API vmi_torque_free_axes vmi_torque_free_order(const vmi_torque_free_body *b)
{
    const vm_two *J = b->moment, *w = b->omega.x;
    int order[3], even = vmi_torque_free_sort(J, order), falling;
    const int first = order[0], middle = order[1], last = order[2];
    const vmi_three S = vmi_torque_free_separation(J, w, first, middle, last);
    vmi_torque_free_axes t;
    falling = vmi_torque_free_equal(J[first], J[middle]) || (!vmi_torque_free_equal(J[middle], J[last]) && S.hi >= 0);
    if (!falling) {
        order[0] = last;
        order[2] = first;
        even = !even;
    }
    t.sigma = falling ? 1 : -1;
    t.S = vmi_two_shifted(vmi_two(S.hi, S.mid), S.hi < 0 ? -1 : 1);
    t.I1 = J[order[0]];
    t.I2 = J[middle];
    t.I3 = J[order[2]];
    t.symmetric = vmi_torque_free_equal(t.I1, t.I2);
    if (t.symmetric) t.I2 = t.I1;
    t.w1 = w[order[0]];
    t.w2 = w[middle];
    t.w3 = vmi_two_shifted(w[order[2]], even ? 1 : -1);
    t.s = t.w3.hi < 0 ? -1 : 1;
    t.d12 = vmi_two_shifted(vmi_two_minus(t.I1, t.I2), t.sigma);
    t.d23 = vmi_two_shifted(vmi_two_minus(t.I2, t.I3), t.sigma);
    t.d13 = vmi_two_shifted(vmi_two_minus(t.I1, t.I3), t.sigma);
    t.axes.x = vmi_torque_free_high_words(&b->axis[order[0]]);
    t.axes.y = vmi_torque_free_high_words(&b->axis[middle]);
    t.axes.z = vmi_scale(even ? 1 : -1, vmi_torque_free_high_words(&b->axis[order[2]]));
    return t;
}

/* A sphere or a point, a principal axis, an equator: omega stays */
VM_API int vmi_torque_free_is_constant(const vmi_torque_free_axes *t)
{
    const int no1 = t->w1.hi == 0, no2 = t->w2.hi == 0, no3 = t->w3.hi == 0;
    return vmi_torque_free_equal(t->I1, t->I3) || (no1 && no2) || (no1 && no3) || (no3 && (no2 || t->symmetric));
}

/* Then axis 3 is that of omega, and sn = 0 */
VM_API void vmi_torque_free_constant(vm_torque_free *m, const vmi_torque_free_body *b)
{
    const vm_two size = vmi_two_root(vmi_torque_free_dot(&b->omega, &b->omega));
    int k;
    if (size.hi == 0) return;
    for (k = 0; k < 3; k++)
        m->axes.z = vmi_add(m->axes.z,
                            vmi_scale(vmi_two_over(b->omega.x[k], size).hi, vmi_torque_free_high_words(&b->axis[k])));
    m->spin[2] = size.hi;
    m->turn_rate = vmi_two_over(vmi_two_shifted(size, VM_C(0.5)), vmi_torque_free_two_pi());
}

/* The squares of a1, a2, a3, h1 = I1 a1, h3 = I3 a3 and L, and the parameters; no difference but S in them */
typedef struct VM_TAG(vmi_torque_free_squares) {
    vm_two a1, a2, a3, h1, h3, L, m1, m;
} vmi_torque_free_squares;

VM_API vmi_torque_free_squares vmi_torque_free_amplitudes(const vmi_torque_free_axes *t)
{
    const vm_two ratio = vmi_two_over(vmi_two_times(t->I2, t->d23), vmi_two_times(t->I1, t->d13));
    const vm_two ww2 = vmi_two_times(t->w2, t->w2);
    vmi_torque_free_squares q;
    vm_two x;
    q.a1 = vmi_two_plus(vmi_two_times(t->w1, t->w1), vmi_two_times(ratio, ww2));
    q.a2 = vmi_two_over(q.a1, ratio);
    q.a3 = vmi_two_times(t->w3, t->w3);
    q.m1 = vmi_two(1, 0);
    q.m = vmi_two(0, 0);
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
VM_API vm_two vmi_torque_free_rate(const vmi_torque_free_axes *t, const vmi_torque_free_squares *q, vm_two *mean)
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
VM_API vm_real vmi_torque_free_imaginary(const vmi_torque_free_axes *t, const vmi_torque_free_squares *q)
{
    const vm_two N = vmi_two_over(vmi_two_times(t->I3, t->d12), vmi_two_times(t->I1, t->d23));
    const vm_two cc = vmi_two_over(q->h3, q->L);
    return vmi_carlson_rf(N, vmi_two_over(N, cc), vmi_two_plus(N, vmi_two(1, 0))).hi;
}

/* u at t0, in turns where mean > 0; *sign is that of cn on the separatrix, else 1 */
VM_API vm_two vmi_torque_free_phase(const vmi_torque_free_axes *t, const vmi_torque_free_squares *q, vm_two mean, vm_real *sign)
{
    const vm_two ss = vmi_two_over(vmi_two_times(t->w2, t->w2), q->a2);
    const vm_two cc = vmi_two_over(vmi_two_times(t->w1, t->w1), q->a1);
    const vm_two middle = vmi_two_plus(cc, vmi_two_times(q->m1, ss));
    const vm_real forward = -t->sigma * t->s * t->w2.hi < 0 ? -1 : 1;
    vm_two F = vmi_two_times(vmi_two_root(ss), vmi_carlson_rf(cc, middle, vmi_two(1, 0)));
    *sign = 1;
    if (mean.hi > 0) {
        F = vmi_two_over(vmi_two_times(F, mean), vmi_torque_free_two_pi());
        if (t->w1.hi < 0) F = vmi_two_minus(vmi_two(VM_C(0.5), 0), F);
    } else if (t->w1.hi < 0) *sign = -1;
    return vmi_two_shifted(F, forward * *sign);
}

/* Rates and phase, per second of the scaled omega; returns the sign of cn on the separatrix */
VM_API vm_real vmi_torque_free_rates(vm_torque_free *m, const vmi_torque_free_axes *t, const vmi_torque_free_squares *q)
{
    const vm_two two_pi = vmi_torque_free_two_pi();
    vm_two mean, kappa = vmi_torque_free_rate(t, q, &mean), wp;
    vm_real sign;
    wp = vmi_two_over(vmi_two_times(q->a3, vmi_two_times(t->d13, t->d23)), vmi_two_times(t->I1, t->I2));
    wp = vmi_two_root(wp);
    m->turn_rate = vmi_two_over(vmi_two_shifted(kappa, t->s), two_pi);
    m->phase = vmi_torque_free_phase(t, q, mean, &sign);
    m->phase_rate = mean.hi > 0 ? vmi_two_over(vmi_two_times(wp, mean), two_pi) : wp;
    if (mean.hi > 0) m->K = vmi_two_over(vmi_two_shifted(two_pi, VM_C(0.25)), mean);
    return sign;
}

/* Parameter and y of the theta function; it stays 1 for m = 0 */
VM_API void vmi_torque_free_theta(vm_torque_free *m, const vmi_torque_free_axes *t, const vmi_torque_free_squares *q)
{
    const int periodic = m->K.hi > 0;
    vm_real K, Kc, y;
    int k;
    if (q->m.hi == 0) return;
    K = periodic ? m->K.hi : VM_INFINITY;
    Kc = periodic ? jacobi_K_m1(q->m.hi) : VM_PI / 2;
    y = vmi_torque_free_imaginary(t, q);
    m->theta = K > 2 * Kc ? vmi_doubled_dual(K, Kc, y) : vmi_doubled_direct(K, Kc, y);
    m->theta.shift *= t->sigma * t->s;
    for (k = 0; k < 4; k++) m->theta.im[k] *= t->sigma * t->s;
}

VM_API void vmi_torque_free_sizes(vm_torque_free *m, const vmi_torque_free_axes *t, const vmi_torque_free_squares *q, vm_real sign)
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

VM_API void vmi_torque_free_parameter(vm_torque_free *m, vm_two m1)
{
    m->m1 = m1.hi;
    vmi_far_prepare(&m->far_form, m1.hi, m1.lo);
}

/* All but the unit of time and the start */
VM_API void vmi_torque_free_prepare(vm_torque_free *m, const vmi_torque_free_body *b)
{
    const vmi_torque_free_axes t = vmi_torque_free_order(b);
    vmi_torque_free_squares q;
    int constant = vmi_torque_free_is_constant(&t);
    if (!constant) {
        q = vmi_torque_free_amplitudes(&t);
        constant = q.h1.hi <= vmi_fourth_power(VM_EPSILON) * q.h3.hi; /* nutation below eps^2 about a stable axis */
    }
    if (constant) {
        vmi_torque_free_constant(m, b);
        return;
    }
    vmi_torque_free_sizes(m, &t, &q, vmi_torque_free_rates(m, &t, &q));
    vmi_torque_free_theta(m, &t, &q);
    vmi_torque_free_parameter(m, q.m1);
}

/* rate t without whole turns, |..| <= 1; meaningless beyond 2^(2p - 4) turns */
VM_API vm_two vmi_torque_free_fraction(vm_two rate, vm_two t)
{
    const vm_two p = vmi_two_product(rate.hi, t.hi);
    vm_real low = p.lo + (rate.lo * t.hi + rate.hi * t.lo);
    if (VM_FABS(low) > VM_C(0.5)) low -= VM_FLOOR(low + VM_C(0.5));
    return vmi_two_sum(p.hi - VM_FLOOR(p.hi + VM_C(0.5)), low);
}

/* sn, cn, dn at t after t0, and u/(4K) without half turns (u on the separatrix) */
VM_API vm_real vmi_torque_free_functions(const vm_torque_free *m, vm_two t, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real longest = VM_MANT_DIG > 24 ? 700 : 80; /* where sech is next to the smallest number */
    vmi_thetas theta;
    vm_real x;
    int half = 0, j = 0;
    vm_two v;
    if (m->K.hi > 0) {
        v = vmi_two_plus(vmi_torque_free_fraction(m->phase_rate, t), m->phase);
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
    theta = v.hi * v.hi > VMI_NEAR ? vmi_theta_far(&m->far_form, 0, v) : vmi_theta_near(v.hi, m->m1); /* NaN: near */
    theta = vmi_theta_shift(theta, m->far_form.kp, (vmi_bits)((j + 2 * half) & 3));
    vmi_theta_ratios(theta, m->far_form.kp, sn, cn, dn);
    return x;
}

/* omega in body axes, and the rotation R */
VM_API void vmi_torque_free_at(const vm_torque_free *m, vm_two t, vm_vec3 *omega, vm_quat *turn)
{
    vm_real sn, cn, dn, re, im, sine, cosine, x, y, w, norm, c, s;
    const vm_real u = vmi_torque_free_functions(m, t, &sn, &cn, &dn);
    vm_vec3 part;
    vmi_doubled_at(&m->theta, u, &re, &im);
    vmi_sincos_turns(vmi_torque_free_fraction(m->turn_rate, t).hi + m->theta.shift * u, &sine, &cosine);
    w = 1 + m->lean[2] * dn;
    x = m->lean[1] * sn;
    y = m->lean[0] * cn;
    norm = 1 / VM_SQRT(2 * w * (re * re + im * im));
    c = norm * (cosine * re - sine * im);
    s = norm * (sine * re + cosine * im);
    part = vmi_times(&m->axes, vmi_vec3(c * x - s * y, c * y + s * x, s * w));
    turn->w = c * w;
    turn->x = part.x;
    turn->y = part.y;
    turn->z = part.z;
    *omega = vmi_times(&m->axes, vmi_vec3(m->spin[0] * cn, m->spin[1] * sn, m->spin[2] * dn));
}

/* From moments, axes, and omega over a power of two */
VM_API void vmi_torque_free_init(vm_torque_free *m, const vmi_torque_free_body *b, vm_real power)
{
    vm_quat q = m->body.q, turn;
    vm_vec3 omega;
    int k;
    vmi_torque_free_parameter(m, vmi_two(1, 0)); /* m = 0: sn = 0, cn = dn = 1 */
    m->theta.re[0] = 1;
    m->lean[2] = 1;
    vmi_torque_free_prepare(m, b);
    if (vmi_quat_is_none(q)) q.w = 1;
    vmi_torque_free_at(m, vmi_two(0, 0), &omega, &turn);
    turn.x = -turn.x;
    turn.y = -turn.y;
    turn.z = -turn.z;
    m->start = vmi_quat_times(q, turn);
    for (k = 0; k < 3; k++) m->spin[k] *= power;
    m->phase_rate = vmi_two_shifted(m->phase_rate, power);
    m->turn_rate = vmi_two_shifted(m->turn_rate, power);
}

/* omega along the inertial axes, or along the body's */
VM_API int vmi_torque_free_start(vm_torque_free *motion, const vm_body *body, int along_body, vm_real t0)
{
    vm_torque_free m;
    vmi_torque_free_body b;
    vmi_vec3_two omega;
    vm_real power;
    int status = vmi_check_body(body), k;
    if (!status && !VM_IS_FINITE(t0)) status = VM_NOT_FINITE;
    if (status) return status;
    memset(&m, 0, sizeof m);
    m.body = *body;
    m.t0 = t0;
    power = vmi_torque_free_power(vmi_norm_max(body->omega));
    omega = vmi_torque_free_vector(body->omega, power);
    if (!along_body && vmi_norm_max(vmi_vec3(body->q.x, body->q.y, body->q.z)) > 0)
        omega = vmi_torque_free_back(body->q, &omega);
    vmi_torque_free_principal(&body->inertia, &b);
    vmi_torque_free_clamp_moments(&body->inertia, &b);
    for (k = 0; k < 3; k++) b.omega.x[k] = vmi_torque_free_squarable(vmi_torque_free_dot(&b.axis[k], &omega));
    vmi_torque_free_init(&m, &b, power);
    *motion = m;
    return VM_OK;
}

/* Prepares the motion of a body that is as given at t0. VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS,
   VM_BAD_INERTIA: the motion stays as it was. */
VM_API int vm_torque_free_init(vm_torque_free *motion, const vm_body *body, vm_real t0)
{
    return motion && body ? vmi_torque_free_start(motion, body, 0, t0) : VM_BAD_ARGUMENT;
}

/* The same from principal moments (kg m^2), the body's axes being the principal ones, and omega (rad/s) along
   them; the body has mass 1 and rests at the origin. */
VM_API int vm_torque_free_init_principal(vm_torque_free *motion, vm_vec3 moments, vm_quat q, vm_vec3 omega, vm_real t0)
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

/* Attitude and omega alone, the latter along body axes. */
VM_API int vm_torque_free_attitude(const vm_torque_free *motion, vm_real t, vm_quat *q, vm_vec3 *omega)
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
    vmi_torque_free_at(motion, elapsed, &w, &turn);
    turn = vmi_quat_times(motion->start, turn);
    if (!vmi_vec3_finite(w) || !VM_IS_FINITE(turn.w) || !vmi_vec3_finite(vmi_vec3(turn.x, turn.y, turn.z)))
        return VM_NOT_FINITE;
    *q = turn;
    *omega = w;
    return VM_OK;
}

/* The body at time t (s), later than t0 or earlier. q is continuous and keeps the length that it had (1, if all
   zero). VM_NOT_FINITE: t is not, or what comes out is not, or t or the turns are beyond 1e290 (float 1e30); the
   body stays as it was. Beyond 1/eps^2 turns the result is finite and has the right momentum, nothing more. */
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
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* The body a time t (s) later, in one call. */
VM_API int vm_torque_free_rotation(const vm_body *body, vm_real t, vm_body *later)
{
    vm_torque_free motion;
    int status = vm_torque_free_init(&motion, body, 0);
    return status ? status : vm_torque_free_at(&motion, t, later);
}

#endif
/* mechanics/streams.h - streams of mass: reactive force and torque */
#ifndef VARMASS_MECHANICS_STREAMS_H
#define VARMASS_MECHANICS_STREAMS_H

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
    /* where the mass is taken from or put; null: where it crosses. Between the two it flows in a straight line, with
       what it has of momentum on the way */
    const vm_store *from;
} vm_stream;

/* Reactive loads at an instant, inertial axes but for inertia_rate. With d = SS2 from the mass centre to the crossing
   point, M' the rate, u the velocity, kappa the gyration, omega2 the angular velocity of each stream:
     force   sum M' (u - v)                             (156)
     moment  sum d x M' (u - v)                         (158)
     torque  sum M' kappa omega2 - I' omega             (157) corrected: printed I' (omega2 - omega), which is right
                                                        only for P(d) omega2 = 0
     drift   sum (M'/M) d:  dr/dt = v + drift           not in [1]
     inertia_rate  I' = sum M' (kappa + P(d)), body axes
   Then M v' = F + force (159) and I omega' + omega x I omega = M_S + moment + torque (160): v' is the rate of
   momentum/mass, which v is. */
typedef struct VM_TAG(vm_reactive) {
    vm_vec3 force, moment, torque, drift; /* N, N m, N m, m/s */
    vm_real mass_rate;                    /* kg/s */
    vm_inertia inertia_rate;              /* kg m^2/s */
} vm_reactive;

VM_INLINE int vmi_stream_motion_is_known(int motion) { return motion >= VM_RELATIVE && motion <= VM_AT_REST; }

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
    i.xx = rate * gyration->xx;
    i.yy = rate * gyration->yy;
    i.zz = rate * gyration->zz;
    i.xy = rate * gyration->xy;
    i.xz = rate * gyration->xz;
    i.yz = rate * gyration->yz;
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
    case VM_RELATIVE:
        carried = vmi_add(carried, s->velocity);
        *spin = vmi_add(b->omega, s->spin);
        break;
    case VM_ABSOLUTE:
        *push = vmi_scale(s->rate, vmi_times_transposed(b->turn, vmi_sub(s->velocity, b->v)));
        *spin = vmi_times_transposed(b->turn, s->spin);
        sum->absolute = vmi_add(sum->absolute, vmi_scale(s->rate, s->velocity));
        return 1;
    case VM_CARRIED: *spin = b->omega; break;
    case VM_AT_REST:
        *push = vmi_times_transposed(b->turn, vmi_scale(-s->rate, b->v));
        *spin = vmi_vec3(0, 0, 0);
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
        if (s->from) {
            stored = vmi_sub(s->from->at, b->centre);
            own = vmi_stream_own(s->rate, &s->from->gyration);
        }
        sum->stored = vmi_add(sum->stored, vmi_scale(s->rate, stored));
        /* as a whole, so that opposite streams cancel */
        own = vmi_inertia_plus(own, s->rate, vmi_inertia_of_point(stored));
        sum->inertia = vmi_inertia_plus(sum->inertia, 1, own);
    }
    return 1;
}

/* The loads of an instant */
/* VM_OK if i is finite and has no negative moment. Only the body has to satisfy the triangle inequality: in plane
   motion a tensor with zz alone is enough, as long as the body is not that flat itself */
VM_API int vmi_gyration_is_valid(const vm_inertia *i)
{
    if (!vmi_inertia_finite(i)) return VM_NOT_FINITE;
    return i->xx >= 0 && i->yy >= 0 && i->zz >= 0 ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_stream_is_valid(const vm_stream *s)
{
    int status;
    if (!vmi_stream_motion_is_known(s->motion)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(s->rate) || !vmi_vec3_finite(s->at) || !vmi_vec3_finite(s->velocity) ||
        !vmi_vec3_finite(s->spin))
        return VM_NOT_FINITE;
    status = vmi_gyration_is_valid(&s->gyration);
    if (status || !s->from) return status;
    return vmi_vec3_finite(s->from->at) ? vmi_gyration_is_valid(&s->from->gyration) : VM_NOT_FINITE;
}

VM_API int vmi_streams_are_valid(int n, const vm_stream *s)
{
    int k, status = n < 0 || (n > 0 && !s) ? VM_BAD_ARGUMENT : VM_OK;
    for (k = 0; !status && k < n; k++) status = vmi_stream_is_valid(s + k);
    return status;
}

/* centre: mass centre from the reference point, body axes. VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA,
   VM_BAD_ARGUMENT (a null pointer, an unknown motion, n < 0), VM_STORED_STREAM */
VM_API int vm_reactive_loads(const vm_body *body, vm_vec3 centre, int n, const vm_stream *streams,
                             vm_reactive *result)
{
    vmi_mat3 turn;
    vmi_stream_sum sum;
    vmi_stream_seen seen;
    vm_reactive r;
    int status, k;
    if (!body || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_streams_are_valid(n, streams);
    if (!status && !vmi_vec3_finite(centre)) status = VM_NOT_FINITE;
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
    if (!vmi_vec3_finite(r.force) || !vmi_vec3_finite(r.moment) || !vmi_vec3_finite(r.torque) ||
        !vmi_vec3_finite(r.drift) || !VM_IS_FINITE(r.mass_rate) || !vmi_inertia_finite(&r.inertia_rate))
        return VM_NOT_FINITE;
    *result = r;
    return VM_OK;
}

/* I^-1 (moment - omega x I omega), body axes */
VM_INLINE vm_vec3 vmi_stream_euler(const vm_inertia *i, const vmi_inertia_ldl *factors, vm_vec3 omega,
                                   vm_vec3 moment)
{
    return vmi_inertia_solve(factors, vmi_sub(moment, vmi_cross(omega, vmi_inertia_times(i, omega))));
}

/* v' (159) and omega' (160), inertial axes, under the resultant F of the outer loads and their moment M_S about the
   mass centre; VM_BAD_INERTIA where the inertia is singular */
VM_API int vm_accelerations(const vm_body *body, const vm_reactive *loads, vm_vec3 force, vm_vec3 moment,
                            vm_vec3 *acceleration, vm_vec3 *angular_acceleration)
{
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    vm_vec3 straight, turning;
    int status;
    if (!body || !loads || !acceleration || !angular_acceleration) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status && !vmi_inertia_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
    if (status) return status;
    turn = vmi_rotation(body->q);
    moment = vmi_add(moment, vmi_add(loads->moment, loads->torque));
    straight = vmi_scale(1 / body->mass, vmi_add(force, loads->force));
    turning = vmi_stream_euler(&body->inertia, &factors, vmi_times_transposed(&turn, body->omega),
                               vmi_times_transposed(&turn, moment));
    turning = vmi_times(&turn, turning);
    if (!vmi_vec3_finite(straight) || !vmi_vec3_finite(turning)) return VM_NOT_FINITE;
    *acceleration = straight;
    *angular_acceleration = turning;
    return VM_OK;
}

/* Closed forms, for mass and velocity or, about a fixed axle, for inertia and angular velocity. v when the mass has
   come from m0 to m: where what crosses has the absolute velocity u, impulse being that of the outer forces (151),
   (171), Levi-Civita's case for u = 0; where it has the relative velocity w and there is no outer force (175), (176),
   Tsiolkovsky's. Within 4 eps of the terms; NaN where a mass is not positive and for infinite arguments. */
VM_API vm_real vm_velocity_by_momentum(vm_real v0, vm_real m0, vm_real m, vm_real u, vm_real impulse)
{
    if (!(m0 > 0 && m > 0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(u) || !VM_IS_FINITE(impulse)) return VM_NAN;
    return v0 * (m0 / m) + ((m - m0) * u + impulse) / m;
}

#endif
/* mechanics/flow.h - a free body with streams of mass */
#ifndef VARMASS_MECHANICS_FLOW_H
#define VARMASS_MECHANICS_FLOW_H

/* The free body in space. A vm_flow is the ctx of the right-hand sides below:

       vm_flow flow;
       ode_event empty;
       rk45_options options = rk45_defaults(NULL);
       rk45 s;
       vm_real y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
       memset(&flow, 0, sizeof flow); // what is not set is zero: not there
       flow.n = 1;
       flow.streams = &nozzle;
       flow.least_mass = dry;
       memset(&empty, 0, sizeof empty);
       empty.g = vm_flow_mass_left;
       empty.ctx = &flow;
       empty.direction = -1;
       empty.action = ODE_STOP;
       options.events = &empty;
       options.n_events = 1;
       if (vm_flow_start(&flow, &body, y) == VM_OK &&
           rk45_init(&s, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, &options, work) >= 0 && rk45_solve(&s, 3) >= 0)
           vm_flow_body(&flow, VM_FLOW_STATES, s.y, &body);

   What depends on the state is set by flow.update: weight is flow->force = y[VM_Y_MASS] g. The reference point of at
   and of stores stays in the body: it is at r - R c, which flow.centre = 0 makes the first mass centre.
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
   In a trial step beyond the end, the mass may not be positive, or the inertia may be one that no body has (a
   moment that is not positive, or larger than the two others together). The derivatives are then NaN, so that the
   step is shortened, and flow.status says why. Use the events below to stop before that. */
enum {
    VM_Y_R = 0,
    VM_Y_Q = 3,
    VM_Y_P = 7,
    VM_Y_H = 10,
    VM_Y_MASS = 13,
    VM_Y_CENTRE = 14,
    VM_Y_INERTIA = 17,
    VM_Y_BALANCE = 23,
    VM_FLOW_GIVEN_STATES = 13,   /* numbers of states: mass, centre and inertia given by flow.update */
    VM_FLOW_STATES = 23,         /* or states */
    VM_FLOW_BALANCED_STATES = 30 /* and the account of momenta and energy */
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
    vm_real mass;                      /* vm_flow_given_rhs, vm_flow_carried_rhs: the laws M(t), */
    vm_vec3 centre;                    /* c(t) (vm_flow_start: where the mass centre is at first), */
    vm_inertia inertia;                /* I(t) */
    vm_vec3 drift;                     /* and c'(t), vm_flow_carried_rhs */
    vm_real least_mass, least_inertia; /* of the events */
    int status;                        /* 0, or why the last evaluations gave NaN or ended the run */
    /* 0, or how many numbers y has room for, VM_LENGTH(y); all functions here check it. vm_flow_start writes no
       more than that: VM_FLOW_GIVEN_STATES or VM_FLOW_STATES numbers, and if there is room for all VM_FLOW_BALANCED_STATES, also the zeros
       of the account */
    int y_size;
} vm_flow;

/* The free body */
/* Whether there are as many streams as there should be */
VM_INLINE int vmi_flow_has(int n, const void *streams) { return n == 0 || (n > 0 && streams); }

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
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_vec3 p = vmi_get3(y + VM_Y_P);
    const vm_real inverse = 1 / mass;
    vm_vec3 h;
    vmi_inertia_ldl factors;
    if (!(mass > 0)) return VM_BAD_MASS;
    if (!vmi_inertia_factor_if_possible(inertia, &factors)) return VM_BAD_INERTIA;
    *turn = vmi_rotation_of_square(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    h = vmi_times_transposed(turn, vmi_get3(y + VM_Y_H));
    vmi_stream_on_the_way(flow->n, flow->streams, centre, &seen->slip, &seen->omega);
    seen->turn = turn;
    seen->centre = centre;
    seen->v = vmi_scale(inverse, p);
    seen->slip = vmi_scale(-inverse, seen->slip);
    seen->omega = vmi_inertia_solve(&factors, vmi_sub(h, seen->omega));
    return VM_OK;
}

/* VM_Y_BALANCE on: momentum, angular momentum and energy carried off by streams less those brought by loads */
VM_INLINE void vmi_flow_balance(const vm_flow *flow, const vm_real *y, const vmi_stream_seen *seen,
                                const vmi_stream_sum *sum, vm_vec3 force, vm_vec3 moment, vm_real *dydt)
{
    const vm_vec3 omega = vmi_times(seen->turn, seen->omega), r = vmi_get3(y + VM_Y_R);
    const vm_vec3 drift = vmi_times(seen->turn, sum->crossing);
    vmi_set3(dydt, vmi_scale(-1, force));
    vmi_set3(dydt + 3, vmi_scale(-1, vmi_add(moment, vmi_add(vmi_cross(r, force), vmi_cross(drift, seen->v)))));
    dydt[6] = (sum->lost - sum->brought) / 2 - vmi_dot(flow->force, seen->v) - vmi_dot(flow->moment, omega);
}

VM_INLINE int vmi_flow_rates(vm_flow *flow, int n, vm_real t, const vm_real *y, vm_real *dydt)
{
    const int given = n == VM_FLOW_GIVEN_STATES;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    vm_real mass;
    vm_vec3 centre, force, moment;
    vm_inertia inertia;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    vmi_stream_sum sum;
    int status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return flow->status = VM_SHORT_ARRAY;
    mass = given ? flow->mass : y[VM_Y_MASS];
    centre = given ? flow->centre : vmi_get3(y + VM_Y_CENTRE);
    inertia = given ? flow->inertia : vmi_get_inertia(y + VM_Y_INERTIA);
    status = vmi_flow_motion(flow, y, mass, &inertia, centre, &turn, &seen);
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(n, dydt);
    seen.energy = n == VM_FLOW_BALANCED_STATES;
    if (!vmi_stream_sums(flow->n, flow->streams, &seen, &sum)) return flow->status = VM_BAD_ARGUMENT;
    force = vmi_add(vmi_times(&turn, sum.pushed), vmi_scale(sum.carried, seen.v));
    force = vmi_add(flow->force, vmi_add(sum.absolute, force));
    moment = vmi_add(flow->moment, vmi_times(&turn, vmi_add(sum.moment, sum.own)));
    vmi_set3(dydt + VM_Y_R, vmi_add(seen.v, vmi_times(&turn, vmi_scale(1 / mass, sum.crossing))));
    vmi_stream_turning(q, q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, seen.omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P, force);
    vmi_set3(dydt + VM_Y_H, moment);
    if (given) return 0;
    dydt[VM_Y_MASS] = sum.rate;
    vmi_set3(dydt + VM_Y_CENTRE, vmi_scale(1 / mass, sum.stored));
    vmi_set_inertia(dydt + VM_Y_INERTIA, &sum.inertia);
    if (seen.energy) vmi_flow_balance(flow, y, &seen, &sum, force, moment, dydt + VM_Y_BALANCE);
    return 0;
}

/* Documented with vm_flow_body. */
VM_API int vm_flow_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_STATES, t, y, dydt);
}

/* 13 states; flow.update sets mass, centre and inertia. With no streams this is (170): what joins or leaves does so
   at rest where the mass centre is */
VM_API int vm_flow_given_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_GIVEN_STATES, t, y, dydt);
}

/* vm_flow_rhs, and from y[VM_Y_BALANCE] on, zero at first, what streams have carried off less what outer loads have
   brought: of momentum 3, angular momentum about the origin 3, kinetic energy 1. With the body's own all seven stay
   constant (the energy but for streams with a store, where angular momentum is y[VM_Y_H] + r x p). The energy goes
   by the limit of (113), (118), for either sign of M':
     T' = F v + M_S omega + sum [M' u^2 + omega2 M' kappa omega2]/2 - sum [M' w^2 + omega_r M' kappa omega_r]/2,
     w = u - v - omega x d, omega_r = omega2 - omega:
   the first sum is what the streams bring, the second what engines give (M' < 0) or plastic impact takes (M' > 0). */
VM_API int vm_flow_balanced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    return vmi_flow_rates((vm_flow *)flow, VM_FLOW_BALANCED_STATES, t, y, dydt);
}

/* The same for what moves with the body (166). The states are r, q, v (not the momentum), omega in body axes (not the
   angular momentum); streams are not looked at: v' = F/M + R (omega x c'), r' = v + R c', I omega' + omega x I
   omega = M_S */
VM_API int vm_flow_carried_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow *flow = (vm_flow *)ctx;
    const vm_quat q = vmi_get_quat(y + VM_Y_Q);
    const vm_real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const vm_vec3 omega = vmi_get3(y + VM_Y_H);
    vmi_mat3 turn;
    vmi_inertia_ldl factors;
    int status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    if (flow->y_size && flow->y_size < VM_FLOW_GIVEN_STATES) return flow->status = VM_SHORT_ARRAY;
    if (!vmi_inertia_factor_if_possible(&flow->inertia, &factors)) status = VM_BAD_INERTIA;
    if (!(flow->mass > 0)) status = VM_BAD_MASS;
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(VM_FLOW_GIVEN_STATES, dydt);
    turn = vmi_rotation_of_square(q, square);
    vmi_set3(dydt + VM_Y_R, vmi_add(vmi_get3(y + VM_Y_P), vmi_times(&turn, flow->drift)));
    vmi_stream_turning(q, square, omega, dydt + VM_Y_Q);
    vmi_set3(dydt + VM_Y_P,
               vmi_add(vmi_scale(1 / flow->mass, flow->force), vmi_times(&turn, vmi_cross(omega, flow->drift))));
    vmi_set3(dydt + VM_Y_H,
               vmi_stream_euler(&flow->inertia, &factors, omega, vmi_times_transposed(&turn, flow->moment)));
    return 0;
}

/* How many numbers of the state vm_flow_start makes: as far as it is known that y has room */
VM_API int vmi_flow_size_at_start(const vm_flow *flow)
{
    if (flow->y_size && flow->y_size < VM_FLOW_STATES) return VM_FLOW_GIVEN_STATES;
    return flow->y_size < VM_FLOW_BALANCED_STATES ? VM_FLOW_STATES : VM_FLOW_BALANCED_STATES;
}

/* y: the VM_FLOW_STATES first states for body (fewer where y_size says so), streams being as they are at first;
   VM_BAD_ARGUMENT (a null pointer, an unknown motion), VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA (that of a rod
   or a point too) */
VM_API int vm_flow_start(vm_flow *flow, const vm_body *body, vm_real *y)
{
    vm_vec3 p, h;
    vm_quat q;
    vmi_inertia_ldl factors;
    vmi_mat3 turn;
    vm_real start[VM_FLOW_BALANCED_STATES];
    int status, k;
    if (!flow || !body || !y) return VM_BAD_ARGUMENT;
    status = vmi_check_body(body);
    if (!status) status = vmi_streams_are_valid(flow->n, flow->streams);
    if (!status &&
        !(vmi_vec3_finite(flow->centre) && vmi_vec3_finite(flow->force) && vmi_vec3_finite(flow->moment)))
        status = VM_NOT_FINITE;
    if (!status && !vmi_inertia_factor(&body->inertia, &factors)) status = VM_BAD_INERTIA;
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

/* The body of n states, with q of length 1: n = VM_FLOW_GIVEN_STATES takes mass, centre and inertia from flow, more from y.
   The states of vm_flow_carried_rhs are other ones: not for them. */
VM_API int vm_flow_body(const vm_flow *flow, int n, const vm_real *y, vm_body *body)
{
    const int given = n < VM_FLOW_STATES;
    vm_vec3 centre;
    vm_body b;
    vmi_mat3 turn;
    vmi_stream_seen seen;
    int status;
    if (!flow || !y || !body || n < VM_FLOW_GIVEN_STATES || !vmi_flow_has(flow->n, flow->streams)) return VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < n) return VM_SHORT_ARRAY;
    b.mass = given ? flow->mass : y[VM_Y_MASS];
    b.inertia = given ? flow->inertia : vmi_get_inertia(y + VM_Y_INERTIA);
    centre = given ? flow->centre : vmi_get3(y + VM_Y_CENTRE);
    status = vmi_flow_motion(flow, y, b.mass, &b.inertia, centre, &turn, &seen);
    if (status) return status;
    b.q = vmi_unit_quat(vmi_get_quat(y + VM_Y_Q));
    b.r = vmi_get3(y + VM_Y_R);
    b.v = seen.v;
    b.omega = vmi_times(&turn, seen.omega);
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* Event functions of vm_flow_rhs and vm_flow_balanced_rhs, ctx the flow: mass - least_mass; least pivot of I - least_inertia,
   0 where I is singular. They do not watch the triangle inequality, whose limit is near for thin bodies. */
VM_API vm_real vm_flow_mass_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    (void)t;
    return y[VM_Y_MASS] - ((const vm_flow *)flow)->least_mass;
}

/* Documented with vm_flow_mass_left. */
VM_API vm_real vm_flow_inertia_left(vm_real t, const vm_real *y, void *flow)
{
    if (!y || !flow) return VM_NAN;
    const vm_inertia i = vmi_get_inertia(y + VM_Y_INERTIA);
    vmi_inertia_ldl f;
    vm_real least = i.xx;
    (void)t;
    if (vmi_inertia_factor(&i, &f)) {
        if (1 / f.y < least) least = 1 / f.y;
        if (1 / f.z < least) least = 1 / f.z;
    } else least = 0;
    return least - ((const vm_flow *)flow)->least_inertia;
}

#endif
/* mechanics/flow2.h - a body in a plane with streams of mass */
#ifndef VARMASS_MECHANICS_FLOW2_H
#define VARMASS_MECHANICS_FLOW2_H

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

enum { VM_FLOW2_STATES = 10 };

/* sin and cos of x within 0.6 eps of 1: vmi_sincos, with a shorter reduction below 2^20 quarters (float 2^10). pi/2
   less its first piece, of 33 (14) bits, whose products are exact, is known to 2^-87 (2^-38); rounding j times it
   costs 2^-67 (2^-28) */
VM_INLINE void vmi_sincos_of_angle(vm_real x, vm_real *sine, vm_real *cosine)
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
    rest = x - (vm_real)j * first;
    tail = (vm_real)j * second;
    z.hi = rest - tail;
    z.lo = (rest - z.hi) - tail;
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
        ux = -omega * dy;
        uy = omega * dx;
        spin = omega;
        if (s->motion == VM_RELATIVE) {
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
        ux = -s->rate * bx;
        uy = -s->rate * by;
        if (s->motion == VM_ABSOLUTE) {
            const vm_real ax = s->rate * s->vx, ay = s->rate * s->vy;
            sum->fx += ax;
            sum->fy += ay;
            spin = s->spin;
            ux += cosine * ax + sine * ay;
            uy += cosine * ay - sine * ax;
        }
    }
    sum->rate += s->rate;
    sum->moment += dx * uy - dy * ux + s->rate * s->gyration * spin;
    sum->sx += s->rate * dx;
    sum->sy += s->rate * dy;
    sum->inertia += s->rate * (s->gyration + dx * dx + dy * dy);
}

VM_API int vm_flow2_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    if (!y || !dydt || !ctx) return VM_BAD_ARGUMENT;
    vm_flow2 *flow = (vm_flow2 *)ctx;
    vmi_stream_sum2 sum = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    vm_real sine, cosine, inverse, vx, vy, omega, sx, sy;
    int k, status = flow->update ? flow->update(t, y, flow) : 0;
    if (status) return status;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    status = !(y[6] > 0) ? VM_BAD_MASS : y[9] > 0 ? VM_OK : VM_BAD_INERTIA;
    if (vmi_flow_refused(&flow->status, status)) return vmi_flow_refuse(VM_FLOW2_STATES, dydt);
    sine = 0;
    cosine = 1;
    if (flow->n) vmi_sincos_of_angle(y[2], &sine, &cosine);
    inverse = 1 / y[6];
    vx = y[3] * inverse;
    vy = y[4] * inverse;
    omega = y[5] / y[9];
    sum.fx = flow->fx;
    sum.fy = flow->fy;
    sum.moment = flow->moment;
    for (k = 0; k < flow->n; k++) {
        if (!vmi_stream_motion_is_known(flow->streams[k].motion)) return flow->status = VM_BAD_ARGUMENT;
        vmi_stream_add2(flow->streams + k, flow->streams[k].x - y[7], flow->streams[k].y - y[8], omega,
                        cosine * vx + sine * vy, cosine * vy - sine * vx, sine, cosine, &sum);
    }
    sx = sum.sx * inverse;
    sy = sum.sy * inverse;
    dydt[0] = vx + cosine * sx - sine * sy;
    dydt[1] = vy + sine * sx + cosine * sy;
    dydt[2] = omega;
    dydt[3] = sum.fx + sum.carried * vx + cosine * sum.px - sine * sum.py;
    dydt[4] = sum.fy + sum.carried * vy + sine * sum.px + cosine * sum.py;
    dydt[5] = sum.moment;
    dydt[6] = sum.rate;
    dydt[7] = sx;
    dydt[8] = sy;
    dydt[9] = sum.inertia;
    return 0;
}

#endif
/* mechanics/flow1.h - translation, bodies on a line or an axle with streams of mass */
#ifndef VARMASS_MECHANICS_FLOW1_H
#define VARMASS_MECHANICS_FLOW1_H

/* Translation (172): 7 states r, momentum, mass; the flow's streams without at, spin and gyration, body axes along
   the inertial ones */
enum { VM_TRANSLATION_STATES = 7 };

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

enum { VM_FLOW1_STATES = 3 };

VM_INLINE int vmi_translation_rates(vm_flow *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real inverse = 1 / y[6];
    const vm_vec3 v = vmi_scale(inverse, vmi_get3(y + 3));
    vm_real rate = 0;
    vm_vec3 force = flow->force;
    int k;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (flow->y_size && flow->y_size < VM_TRANSLATION_STATES) return flow->status = VM_SHORT_ARRAY;
    if (vmi_flow_refused(&flow->status, y[6] > 0 ? VM_OK : VM_BAD_MASS))
        return vmi_flow_refuse(VM_TRANSLATION_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream *s = flow->streams + k;
        vm_vec3 u = vmi_add(v, s->velocity);
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        if (s->motion != VM_RELATIVE)
            u = s->motion == VM_ABSOLUTE ? s->velocity : s->motion == VM_CARRIED ? v : vmi_vec3(0, 0, 0);
        rate += s->rate;
        force = vmi_add(force, vmi_scale(s->rate, u));
    }
    vmi_set3(dydt, v);
    vmi_set3(dydt + 3, force);
    dydt[6] = rate;
    return 0;
}

VM_INLINE int vmi_rates1(vm_flow1 *flow, const vm_real *y, vm_real *dydt)
{
    const vm_real v = y[1] / y[2];
    vm_real force = flow->force, rate = 0;
    int k;
    if (!vmi_flow_has(flow->n, flow->streams)) return flow->status = VM_BAD_ARGUMENT;
    if (vmi_flow_refused(&flow->status, y[2] > 0 ? VM_OK : VM_BAD_MASS)) return vmi_flow_refuse(VM_FLOW1_STATES, dydt);
    for (k = 0; k < flow->n; k++) {
        const vm_stream1 *s = flow->streams + k;
        vm_real u = v + s->velocity;
        if (!vmi_stream_motion_is_known(s->motion)) return flow->status = VM_BAD_ARGUMENT;
        if (s->motion != VM_RELATIVE) u = s->motion == VM_ABSOLUTE ? s->velocity : s->motion == VM_CARRIED ? v : 0;
        rate += s->rate;
        force += s->rate * u;
    }
    dydt[0] = v;
    dydt[1] = force;
    dydt[2] = rate;
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

VM_API int vm_translation_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow)
{
    if (!y || !dydt || !flow) return VM_BAD_ARGUMENT;
    vm_flow *f = (vm_flow *)flow;
    return f->update ? vmi_translation_updated(t, y, dydt, f) : vmi_translation_rates(f, y, dydt);
}

VM_API int vm_flow1_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *flow1)
{
    if (!y || !dydt || !flow1) return VM_BAD_ARGUMENT;
    vm_flow1 *f = (vm_flow1 *)flow1;
    return f->update ? vmi_updated1(t, y, dydt, f) : vmi_rates1(f, y, dydt);
}

#endif
/* mechanics/rocket.h - closed forms: Tsiolkovsky's rocket, linear flow, jet damping */
#ifndef VARMASS_MECHANICS_ROCKET_H
#define VARMASS_MECHANICS_ROCKET_H

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

/* Closed forms */
/* ln(1 + x)/x and (x - ln(1 + x))/x^2 for -1 < x < 1e299 (float 1e34; NaN beyond), within 2 ulp */
VM_API void vmi_stream_log_means(vm_real x, vm_real *first, vm_real *second)
{
    const vm_two whole = vmi_two(x, 0), l = vmi_log1p(whole);
    *second = vmi_log1p_rest(whole, l).hi;
    *first = VM_FABS(x) < VM_EPSILON ? 1 - x / 2 : l.hi / x;
}

/* Documented with vm_velocity_by_momentum. */
VM_API vm_real vm_tsiolkovsky(vm_real v0, vm_real m0, vm_real m, vm_real w)
{
    vm_two l;
    if (!(m0 > 0 && m > 0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(w)) return VM_NAN;
    if (m < 2 * m0 && m0 < 2 * m) l = vmi_two_log(vmi_two_sum(1, (m - m0) / m0)); /* m - m0 is exact */
    else l = vmi_two_plus(vmi_log(m), vmi_minus(vmi_log(m0)));
    return v0 + w * l.hi;
}

/* Position and velocity after t under constant rate, force and velocity of the stream (VM_RELATIVE, VM_ABSOLUTE),
   through rate = 0 without loss: 8 eps of the terms; VM_BAD_MASS where m0 + rate t or m0 is not positive */
/* With tau = rate t/m0, L = ln(1 + tau)/tau, B = (tau - ln(1 + tau))/tau^2, constant force and u:
     v - v0 = (force + rate (u - v0)) t/m,        x = x0 + v0 t + (force + rate (u - v0)) t^2/m0 B
   as M (v - u) + const; and with constant w:
     v - v0 = (force + rate w) t/m0 L,            x = x0 + v0 t + (force + rate w) t^2/m0 (L - B) */
VM_API int vm_linear_flow(vm_real t, vm_real x0, vm_real v0, vm_real m0, vm_real force, const vm_stream1 *stream,
                          vm_real *x, vm_real *v)
{
    vm_real tau, first, second, less, pull, result[2];
    if (!stream || !x || !v || !vmi_stream_motion_is_known(stream->motion)) return VM_BAD_ARGUMENT;
    if (!(m0 > 0)) return VM_BAD_MASS;
    tau = stream->rate * t / m0;
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(stream->velocity)) return VM_NOT_FINITE;
    if (!(tau > -1)) return VM_BAD_MASS;
    vmi_stream_log_means(tau, &first, &second);
    less = tau < VM_C(-0.5) ? ((1 + tau) * first - 1) / tau : first - second; /* near -1 both are large */
    pull = stream->motion == VM_RELATIVE || stream->motion == VM_ABSOLUTE ? stream->velocity : 0;
    if (stream->motion == VM_RELATIVE || stream->motion == VM_CARRIED) {
        pull = (force + stream->rate * pull) / m0;
        result[1] = v0 + pull * t * first;
        result[0] = x0 + t * (v0 + pull * t * less);
    } else {
        pull = (force + stream->rate * (pull - v0)) / m0;
        result[1] = v0 + pull * t / (1 + tau);
        result[0] = x0 + t * (v0 + pull * t * second);
    }
    if (!vmi_all_finite(2, result)) return VM_NOT_FINITE;
    *x = result[0];
    *v = result[1];
    return VM_OK;
}

/* With tau = rate gyration t/A0 and c likewise: ln(A/A0) = tau L, integral (C/A - 1) dt = t (C0/A0 L - 1 + rate t
   gyration_axial/A0 B) */
VM_API int vm_jet_damping(vm_real t, const vm_jet *jet, vm_vec3 omega0, vm_vec3 *omega)
{
    vm_real change, tau, first, second, decay, sine, cosine;
    vm_vec3 later;
    if (!jet || !omega) return VM_BAD_ARGUMENT;
    if (!(jet->axial > 0 && jet->transverse > 0)) return VM_BAD_INERTIA;
    change = jet->rate * t / jet->transverse;
    tau = change * jet->gyration_transverse;
    decay = change * (jet->nozzle * jet->nozzle + jet->gyration_out - jet->gyration_transverse);
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(decay) || !VM_IS_FINITE(jet->axial) || !VM_IS_FINITE(jet->transverse))
        return VM_NOT_FINITE;
    if (!(tau > -1 && jet->axial + jet->rate * t * jet->gyration_axial > 0)) return VM_BAD_INERTIA;
    vmi_stream_log_means(tau, &first, &second);
    decay = vmi_exp(decay * first, 0);
    vmi_sincos(omega0.z * t * (jet->axial / jet->transverse * first - 1 + change * jet->gyration_axial * second),
               &sine, &cosine);
    later = vmi_vec3(decay * (omega0.x * cosine - omega0.y * sine), decay * (omega0.y * cosine + omega0.x * sine),
                     omega0.z);
    if (!vmi_vec3_finite(later)) return VM_NOT_FINITE;
    *omega = later;
    return VM_OK;
}

#endif
/* mechanics/drum.h - a band that winds up on a drum */
#ifndef VARMASS_MECHANICS_DRUM_H
#define VARMASS_MECHANICS_DRUM_H

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

typedef struct VM_TAG(vm_drum_geometry) {
    vm_real mass;         /* M (182), kg */
    vm_real arc_centre;   /* S S' (184), m */
    vm_real offset;       /* S S1 (185) corrected, m: S1 = S + offset (cos phi/2, sin phi/2) */
    vm_real axle_inertia; /* J_S (187), about the axle, kg m^2 */
    vm_real inertia;      /* J_S1 (188), about the mass centre, kg m^2 */
} vm_drum_geometry;

/* Right-hand sides for rk45, ctx a vm_drum, of y = {xS, yS, phi, xS', yS', phi'} (VM_DRUM_STATES values). The first
   is exact; it takes the place of (177) and (191), which lack the drift of the mass centre and turn the shaft's
   torque round. With q = mu R (sin phi, 1 - cos phi):
     M rS'' + phi'' k x q - phi'^2 q = -c rS + mu phi' ((0, v) - rS' - phi' k x (R, 0))
     J_S phi'' + q x rS'' = -D phi' + mu phi' R (v - yS' - R phi')
   The second is (192), (193), what is left of it for small mu, with the unbalance mu R phi'^2 (sin phi, -cos phi),
   of the same order as what (192) keeps. Both stop a run, by VM_BAD_MASS or VM_BAD_INERTIA, where a mass or inertia
   is not positive. */
#define VM_DRUM_STATES 6

/* The elastic shaft in the first approximation, for small mu/M0, j/J0, e/(J0 Omega_b):
     x'' + 2 delta x' + k^2 (1 - A phi) x = 0 (213), y with mu v/(M0 Omega_b) on the right (214), ' = d/dphi */
typedef struct VM_TAG(vm_drum_shaft) {
    vm_real k;     /* sqrt(c/M0)/Omega_b */
    vm_real delta; /* (mu/M0 + e/(J0 Omega_b) - j/J0)/2, corrected */
    vm_real A;     /* mu/M0 - 2 j/J0 + 2 e/(J0 Omega_b), corrected, 1/rad */
    vm_real shift; /* mu v/(M0 Omega_b k^2), m: y oscillates about shift/(1 - A phi) */
} vm_drum_shaft;

/* mu (181) */
VM_API vm_real vm_drum_band(vm_real radius, vm_real thickness, vm_real width, vm_real density)
{
    return radius * thickness * width * density;
}

/* M, J_S, and |q|^2/M = M (S S1)^2 at phi; s = sin(phi/2) */
VM_API int vmi_drum_inertia(vm_real phi, vm_real s, const vm_drum *d, vm_real *M, vm_real *J, vm_real *steiner)
{
    const vm_real q = 2 * d->band * d->radius * s;
    *M = d->mass + d->band * phi;
    *J = d->inertia + d->band * d->radius * d->radius * phi;
    *steiner = q / *M * q; /* q alone may be too small to be squared */
    if (!VM_IS_FINITE(*M) || !VM_IS_FINITE(*J)) return VM_NOT_FINITE;
    if (!(*M > 0)) return VM_BAD_MASS;
    return *J - *steiner > 0 ? VM_OK : VM_BAD_INERTIA;
}

/* The drum with its band at the angle phi >= 0. VM_BAD_MASS, VM_BAD_INERTIA where no drum is like that;
   VM_BAD_ARGUMENT (phi < 0, too), VM_NOT_FINITE */
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
    g->arc_centre = phi > VM_MIN ? d->radius * s / (phi / 2) : d->radius;
    g->offset = 2 * d->band * d->radius * s / M;
    g->axle_inertia = J;
    g->inertia = J - steiner;
    return VM_OK;
}

VM_API int vm_drum_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
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
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = (X + turn * qy) / M;
    dydt[4] = (Y - turn * qx) / M;
    dydt[5] = turn;
    return VM_OK;
}

VM_API int vm_drum_rhs_reduced(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real flow = d->band * y[5], unbalance = flow * d->radius * y[5];
    vm_real s, c, M, J, steiner;
    int status;
    (void)t;
    vmi_sincos(y[2], &s, &c);
    status = vmi_drum_inertia(y[2], 0, d, &M, &J, &steiner);
    if (status) return status;
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = (-d->stiffness * y[0] - flow * y[3] + unbalance * s) / M;
    dydt[4] = (-d->stiffness * y[1] + flow * (d->speed - y[4]) - unbalance * c) / M;
    dydt[5] = (-d->damping * y[5] + flow * d->radius * (d->speed - y[4] - d->radius * y[5])) / J;
    return VM_OK;
}

/* -- The rigid shaft, in two words, the drum's fields taken as exact -- */
VM_API int vmi_drum_turns(const vm_drum *d)
{
    return d && d->inertia > 0 && d->band >= 0 && d->omega > 0 && VM_IS_FINITE(d->inertia) &&
           VM_IS_FINITE(d->band) && VM_IS_FINITE(d->omega) && VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->speed) &&
           VM_IS_FINITE(d->damping);
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

/* The rigid shaft (194): angular velocity phi' (196), time t (197) at which the angle phi is reached, phi(t), and the
   angle J0 Omega_b/|e| that is never reached where e < 0 (else infinity). phi, t >= 0; NaN beyond the stop, for a
   null pointer, and for fields without the signs above. Within 4 ulp with the drum's fields taken as exact, through
   e = 0 and k1 = 1 - e/(j Omega_b) = 0, up to the stop, for data whose products in these formulas stay within the
   range of numbers. With x = e phi/(J0 Omega_b)
     t = phi/Omega_b [ln(1 + x)/x + (j phi/J0) (x - ln(1 + x))/x^2],
   and phi(t) is solved for by Newton's method: no Lambert W, no branches. */
VM_API vm_real vm_drum_rate(vm_real phi, const vm_drum *d)
{
    vm_two up, down;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    up = vmi_two_plus(vmi_two_product(d->inertia, d->omega), vmi_two_times(vmi_drum_e(d), vmi_two(phi, 0)));
    down = vmi_two_plus(vmi_two(d->inertia, 0), vmi_two_times(vmi_drum_j(d), vmi_two(phi, 0)));
    return up.hi >= 0 ? vmi_two_over(up, down).hi : VM_NAN;
}

/* (210), (211) of y = {x, y, dx/dphi, dy/dphi}, phi the independent variable, with phi'(phi) of the rigid shaft
   (196); VM_BAD_ARGUMENT where the drum does not get to phi */
VM_API int vm_drum_rhs_angle(vm_real phi, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real rate = vm_drum_rate(phi, d), j = d->band * d->radius * d->radius;
    const vm_real e = d->band * d->speed * d->radius - d->damping;
    vm_real M, J, steiner, slope, drag;
    int status = vmi_drum_inertia(phi, 0, d, &M, &J, &steiner);
    if (status) return status;
    if (!(rate > 0)) return VM_BAD_ARGUMENT;
    slope = (e - j * rate) / J; /* d phi'/d phi (195), phi'' = slope rate */
    drag = d->band / M + slope / rate;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = -drag * y[2] - d->stiffness * y[0] / (M * rate * rate);
    dydt[3] = -drag * y[3] + (d->band * d->speed * rate - d->stiffness * y[1]) / (M * rate * rate);
    return VM_OK;
}

/* a b/c */
VM_API vm_two vmi_drum_share(vm_two a, vm_real b, vm_two c)
{
    return vmi_two_over(vmi_two_times(a, vmi_two(b, 0)), c);
}

/* Documented with vm_drum_rate. */
VM_API vm_real vm_drum_stop(const vm_drum *d)
{
    vm_two e;
    if (!vmi_drum_turns(d)) return VM_NAN;
    e = vmi_drum_e(d);
    if (!(e.hi < 0)) return VM_INFINITY;
    return vmi_two_over(vmi_two_product(d->inertia, d->omega), vmi_minus(e)).hi;
}

/* Documented with vm_drum_rate. */
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

/* Documented with vm_drum_rate. */
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
        rest = vmi_two_plus(vmi_two_plus(vmi_two(1, 0), vmi_minus(p)), vmi_minus(rest));
        step = rest.hi / (1 + b.hi * f.hi);
        left = step / f.hi * (step / f.hi) * (1 + x.hi) * (x.hi > 0 ? 1 + x.hi : 1);
        p = vmi_two_plus(p, vmi_two(step, 0));
        f = vmi_two_plus(f, vmi_two(step * (1 + x.hi), 0));
    }
    return vmi_two_times(angle, f).hi;
}

/* phi(t) as published, (198)-(206) corrected: r - k1 ln r = f1, r = -k1 W(x), x = -exp(-f1/k1)/k1, by W_-1 for 0 < k1
   < 1 and W_0 for other k1. For comparison: it loses all digits next to e = 0, where r comes to the branch point; at
   e = 0 and k1 = 0 it is NaN. Next to k1 = 0 x is no number any more (1e-869 for k1 = 1e-3): ln |x| is used. */
VM_API vm_real vm_drum_angle_lambert(vm_real t, const vm_drum *d)
{
    vm_real j, e, k1, f1, l, w;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    j = vmi_drum_j(d).hi;
    e = vmi_drum_e(d).hi;
    k1 = 1 - e / (j * d->omega);
    if (k1 == 0 || e == 0) return VM_NAN;
    f1 = 1 + e * e * t / (d->inertia * j * d->omega);
    l = -vmi_log(VM_FABS(k1)).hi - f1 / k1; /* of the argument's size */
    if (l > -1 && k1 > 0) l = -1;           /* by rounding */
    /* e tells the branch: k1 may round to 1 */
    w = k1 < 0 ? vm_wright_omega(l) : e > 0 ? vm_lambert_wm1_neg_exp(l) : vm_lambert_w0_neg_exp(l);
    return (-k1 * w - 1) * d->inertia * d->omega / e;
}

/* VM_SINGULAR where c or Omega_b is not positive; VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA */
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
    if (!VM_IS_FINITE(d->inertia) || !VM_IS_FINITE(r.k) || !VM_IS_FINITE(r.delta) || !VM_IS_FINITE(r.A) ||
        !VM_IS_FINITE(r.shift))
        return VM_NOT_FINITE;
    *s = r;
    return VM_OK;
}

/* (224), (225) corrected: a (1 - A phi)^(-1/4) exp(-delta phi) cos(integral of k sqrt(1 - A phi) + alpha), plus
   particular/(1 - A phi): particular = 0 for x, s->shift for y. At phi = 0, to which a (m) and alpha (rad)
   belong, it is a cos alpha + particular. NaN where 1 - A phi <= 0 and for a null pointer. */
/* The phase (2k/3A)(1 - m^3), m^2 = 1 - A phi, is 2k/3 phi (1 + m + m^2)/(1 + m), which A = 0 does not trouble */
VM_API vm_real vm_drum_deflection(vm_real phi, const vm_drum_shaft *s, vm_real a, vm_real alpha, vm_real particular)
{
    const vm_real square = s ? 1 - s->A * phi : VM_NAN;
    vm_real m, sine, cosine;
    if (!(square > 0) || !VM_IS_FINITE(phi) || !VM_IS_FINITE(a) || !VM_IS_FINITE(particular)) return VM_NAN;
    m = VM_SQRT(square);
    vmi_sincos(2 * s->k / 3 * phi * ((1 + m + square) / (1 + m)) + alpha, &sine, &cosine);
    return a / VM_SQRT(m) * vmi_exp(-s->delta * phi, 0) * cosine + particular / square;
}

/* (226): is A < 1/(2 pi), so that the frequency stays real for the first layer? 0 for a null pointer. */
VM_API int vm_drum_shaft_valid(const vm_drum_shaft *s) { return s && s->A < 1 / (2 * VM_PI); }

#endif
/* mechanics/lagrange.h - Lagrange's equations with variable mass */
#ifndef VARMASS_MECHANICS_LAGRANGE_H
#define VARMASS_MECHANICS_LAGRANGE_H

/* (247) corrected: with T(t, q, q', masses) of the material velocities, r2 where a stream crosses,
     d/dt dT/dq'_i - (dT/dq_i, masses frozen) = Q_i + sum [M' u dr2/dq_i + M' kappa omega2 domega/dq'_i]
   A derivative that lets masses vary with q, as (244)-(247) may be read, is wrong. As first-order equations: states
   are q and the momenta pi = dT/dq', from which q' follows; neither rates of momenta nor of masses are needed.
     pi' = (dT/dq, masses frozen) + Q,   A q' = pi - b,   T = q'Aq'/2 + b q' + T0
   Q has what streams bring: a pendulum l long that leaks at its bob has -m g l sin q + m' l^2 q', where a leak that
   moves on with the bob takes its momentum along; without the last term it would leave at rest.
   A and b come from T itself by differences over unit rates, exact but for roundings of T there and at rest; dT/dq by
   central differences of order 6, within 2e-13 of the largest T (float 1e-5) over a scale on which T varies in q. */
typedef struct VM_TAG(vm_lagrange_system) {
    int n;        /* coordinates */
    int n_masses; /* masses, inertias, whatever is frozen */
    void (*masses)(vm_real t, const vm_real *q, vm_real *masses, void *ctx); /* null where n_masses is 0 */
    vm_real (*energy)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx);
    /* null, or adds the generalized forces to Q, vm_lagrange_add_force does; nonzero stops the run */
    int (*forces)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q, void *ctx);
    void *ctx;
    const vm_real *scales; /* of each q; null: 1 */
    vm_real *work;         /* VM_LAGRANGE_RHS_WORK(n, n_masses) numbers */
} vm_lagrange_system;

#define VM_LAGRANGE_RHS_WORK(n, n_masses) ((n) * (n) + 3 * (n) + (n_masses))

/* Parts of work: A, b and then a right-hand side, rates, a trial point, masses */
typedef struct VM_TAG(vmi_lagrange_parts) {
    vm_real *A, *b, *rates, *trial, *masses;
} vmi_lagrange_parts;

VM_API vmi_lagrange_parts vmi_lagrange_work(const vm_lagrange_system *l)
{
    vmi_lagrange_parts w;
    w.A = l->work;
    w.b = w.A + (ptrdiff_t)l->n * l->n;
    w.rates = w.b + l->n;
    w.trial = w.rates + l->n;
    w.masses = w.trial + l->n;
    return w;
}

/* T at rates x e_i + z e_j */
VM_API vm_real vmi_lagrange_energy(const vm_lagrange_system *l, vm_real t, const vm_real *q, int i, vm_real x, int j,
                                 vm_real z)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    int k;
    for (k = 0; k < l->n; k++) w.trial[k] = (k == i ? x : 0) + (k == j ? z : 0);
    return l->energy(t, q, w.trial, w.masses, l->ctx);
}

/* A and b from T; steps of the size of 1/sqrt(A_ii) keep the roundings of unlike coordinates apart */
VM_API void vmi_lagrange_quadratic(const vm_lagrange_system *l, vm_real t, const vm_real *q)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    const int n = l->n;
    const vm_real T0 = vmi_lagrange_energy(l, t, q, -1, 0, -1, 0);
    int i, j;
    for (i = 0; i < n; i++) {
        const vm_real plus = vmi_lagrange_energy(l, t, q, i, 1, -1, 0);
        const vm_real minus = vmi_lagrange_energy(l, t, q, i, -1, -1, 0);
        w.A[i * n + i] = (plus - T0) + (minus - T0);
        w.b[i] = (plus - minus) / 2;
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++) {
            const vm_real x = 1 / VM_SQRT(w.A[i * n + i]), z = 1 / VM_SQRT(w.A[j * n + j]);
            const vm_real same = vmi_lagrange_energy(l, t, q, i, x, j, z) + vmi_lagrange_energy(l, t, q, i, -x, j, -z);
            const vm_real apart = vmi_lagrange_energy(l, t, q, i, x, j, -z) + vmi_lagrange_energy(l, t, q, i, -x, j, z);
            w.A[i * n + j] = w.A[j * n + i] = (same - apart) / (4 * x * z);
        }
}

VM_API void vmi_lagrange_freeze(const vm_lagrange_system *l, vm_real t, const vm_real *q)
{
    if (l->masses) l->masses(t, q, vmi_lagrange_work(l).masses, l->ctx);
}

/* q' into the work */
VM_API int vmi_lagrange_solve_rates(const vm_lagrange_system *l, vm_real t, const vm_real *y)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    int k;
    vmi_lagrange_freeze(l, t, y);
    vmi_lagrange_quadratic(l, t, y);
    for (k = 0; k < l->n; k++) w.rates[k] = y[l->n + k] - w.b[k];
    return vmi_solve_mass(l->n, w.A, w.rates, w.trial);
}

/* h^6/140 of the seventh derivative against eps/h: h = 2^-7 for eps = 2^-52, 2^-3 for 2^-23 */
VM_API vm_real vmi_lagrange_derivative(const vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates, int i)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
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

VM_API int vmi_lagrange_is_valid(const vm_lagrange_system *l)
{
    return l && l->n > 0 && l->n_masses >= 0 && l->energy && l->work && (l->n_masses == 0 || l->masses);
}

/* An ode_rhs of 2 n states q, pi, ctx a vm_lagrange_system. Where A is singular, as in vm_lagrange_separate, or masses have
   become negative, VM_SINGULAR stops it: stop before, by an event */
VM_API int vm_lagrange_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *lagrange)
{
    const vm_lagrange_system *l = (const vm_lagrange_system *)lagrange;
    if (!y || !dydt || !vmi_lagrange_is_valid(l)) return VM_BAD_ARGUMENT;
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    int k, status = vmi_lagrange_solve_rates(l, t, y);
    if (status) return status;
    for (k = 0; k < l->n; k++) {
        dydt[k] = w.rates[k];
        dydt[l->n + k] = 0;
    }
    if (l->forces) status = l->forces(t, y, w.rates, w.masses, dydt + l->n, l->ctx);
    for (k = 0; k < l->n; k++) dydt[l->n + k] += vmi_lagrange_derivative(l, t, y, w.rates, k);
    return status;
}

/* y = q, pi from q and rates q', and rates from y; VM_BAD_ARGUMENT, VM_SINGULAR, VM_NOT_FINITE */
VM_API int vm_lagrange_start(vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates, vm_real *y)
{
    vmi_lagrange_parts w;
    int i, j;
    if (!vmi_lagrange_is_valid(l) || !q || !rates || !y) return VM_BAD_ARGUMENT;
    w = vmi_lagrange_work(l);
    vmi_lagrange_freeze(l, t, q);
    vmi_lagrange_quadratic(l, t, q);
    for (i = 0; i < l->n; i++)
        for (j = 0; j < l->n; j++) w.b[i] += w.A[i * l->n + j] * rates[j];
    if (!vmi_all_finite(l->n, w.b) || !vmi_all_finite(l->n, q)) return VM_NOT_FINITE;
    for (i = 0; i < l->n; i++) {
        y[i] = q[i];
        y[l->n + i] = w.b[i];
    }
    return VM_OK;
}

/* Documented with vm_lagrange_start. */
VM_API int vm_lagrange_rates(vm_lagrange_system *l, vm_real t, const vm_real *y, vm_real *rates)
{
    int status;
    if (!vmi_lagrange_is_valid(l) || !y || !rates) return VM_BAD_ARGUMENT;
    status = vmi_lagrange_solve_rates(l, t, y);
    return status ? status : vmi_copy_if_finite(l->n, vmi_lagrange_work(l).rates, rates);
}

/* dT/dq_i with the masses frozen at (t, q); NaN for i outside 0 .. n - 1 */
VM_API vm_real vm_lagrange_partial_q(vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates, int i)
{
    if (!vmi_lagrange_is_valid(l) || !q || !rates || i < 0 || i >= l->n) return VM_NAN;
    vmi_lagrange_freeze(l, t, q);
    return vmi_lagrange_derivative(l, t, q, rates, i);
}

#endif
/* mechanics/euler_angles.h - Euler's angles */
#ifndef VARMASS_MECHANICS_EULER_ANGLES_H
#define VARMASS_MECHANICS_EULER_ANGLES_H

/* Euler's angles psi, theta, phi (3-1-3: about z, the line of nodes, the body's z): the attitude, and domega/dq'_i in
   inertial and in body axes, omega = psi' axis[0] + theta' axis[1] + phi' axis[2]; rates of an omega in inertial
   axes, VM_SINGULAR where sin(theta) = 0, VM_NOT_FINITE. Within 4 eps for angles up to
   0.1/eps (4e14, float 8e5); from 2^(p-1) quarters on they hold no phase. */
VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi)
{
    vm_quat turn, tilt, spin;
    turn.x = turn.y = tilt.y = tilt.z = spin.x = spin.y = 0;
    vmi_sincos(psi / 2, &turn.z, &turn.w);
    vmi_sincos(theta / 2, &tilt.x, &tilt.w);
    vmi_sincos(phi / 2, &spin.z, &spin.w);
    return vmi_quat_times(vmi_quat_times(turn, tilt), spin);
}

/* Documented with vm_euler_313. */
VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3])
{
    if (!axis) return;
    vm_real s, c, sine, cosine;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(0, 0, 1);
    axis[1] = vmi_vec3(c, s, 0);
    axis[2] = vmi_vec3(sine * s, -sine * c, cosine);
}

/* Documented with vm_euler_313. */
VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3])
{
    if (!axis) return;
    vm_real s, c, sine, cosine;
    vmi_sincos(phi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(sine * s, sine * c, cosine);
    axis[1] = vmi_vec3(c, -s, 0);
    axis[2] = vmi_vec3(0, 0, 1);
}

/* Documented with vm_euler_313. */
VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3])
{
    vm_real s, c, sine, cosine, result[3];
    if (!rates) return VM_BAD_ARGUMENT;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    if (sine == 0) return VM_SINGULAR;
    result[2] = (s * omega.x - c * omega.y) / sine;
    result[1] = c * omega.x + s * omega.y;
    result[0] = omega.z - result[2] * cosine;
    return vmi_copy_if_finite(3, result, rates);
}

#endif
/* oscillators/waves.h - the wave forms of a strongly nonlinear oscillator: cosine, cn, ca */
#ifndef VARMASS_OSCILLATORS_WAVES_H
#define VARMASS_OSCILLATORS_WAVES_H

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
    w.method = method;
    w.alpha = alpha;
    w.ateb = ateb_or_NULL;
    w.turn = w.speed = w.gain_theta = 1;
    w.gain_A = 2 / (alpha + 1);
    w.m = 0;
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
        w.gain_A = 4 / ((alpha + 3) * bracket);
        w.gain_theta = 1 / bracket;
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
        c = VM_FABS(c - ca);
        s = VM_FABS(w->speed * s - sa);
        if (c > *x_error) *x_error = c;
        if (s > *v_error) *v_error = s;
    }
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

#endif
/* oscillators/constant_mass.h - the oscillator of constant mass */
#ifndef VARMASS_OSCILLATORS_CONSTANT_MASS_H
#define VARMASS_OSCILLATORS_CONSTANT_MASS_H

/* How good they are, criterion (268): their largest velocities over the exact one (267), that of cos (296) and that
   of cn, which for m > 1/2 is Omega_1/(2k) next to x = 0, not the k' Omega_1 of (306) at x = 0; and the largest
   errors of x over x0 and of v over vmax in a period. NaN outside alpha >= 0. */
typedef struct VM_TAG(vm_osc_errors) {
    vm_real trig_vmax, jacobi_vmax;
    vm_real trig_x, trig_v, jacobi_x, jacobi_v;
} vm_osc_errors;

/* ds/dt of the Ateb phase, sqrt((alpha+1)/2) omega0 |x0|^((alpha-1)/2); NaN outside the domain */
VM_API vm_real vmi_osc_rate(vm_real x0, vm_real omega0, vm_real alpha)
{
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x0) || !VM_IS_FINITE(omega0)) return VM_NAN;
    if (omega0 == 0) return 0; /* where the power may be infinite */
    return VM_SQRT((alpha + 1) / 2) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha - 1) / 2);
}

/* Started at rest, x(0) = x0, x'(0) = 0 (258), x0 of either sign: exact period (262), s, and largest velocity (267),
   m/s */
VM_API vm_real vm_osc_period(vm_real x0, vm_real omega0, vm_real alpha)
{
    return 2 * ateb_pi(alpha) / vmi_osc_rate(x0, omega0, alpha);
}

/* Documented with vm_osc_period. */
VM_API vm_real vm_osc_vmax(vm_real x0, vm_real omega0, vm_real alpha)
{
    vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (rate != rate) return rate;
    return VM_SQRT(2 / (alpha + 1)) * VM_FABS(omega0) * vmi_pow_checked(VM_FABS(x0), (alpha + 1) / 2);
}

/* x|x|^(alpha-1) */
VM_API vm_real vmi_osc_elastic(vm_real x, vm_real alpha)
{
    if (alpha == 1 || x == 0) return x;
    if (alpha == 3) return x * x * x;
    return VM_COPYSIGN(vmi_pow_checked(VM_FABS(x), alpha), x);
}

/* x and v at amplitude A, of either sign, and Ateb phase psi */
VM_API void vmi_osc_at_phase(vm_real A, vm_real psi, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    vm_real sa, ca;
    ateb_saca(psi, alpha, &sa, &ca);
    *x = A * ca;
    *v = -VM_COPYSIGN(vm_osc_vmax(A, omega0, alpha), A) * sa;
}

/* Exact motion, x(t) = x0 ca(alpha, 1, s) (282) and x'(t) (283), for x0 of either sign */
VM_API void vm_osc_exact(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vm_real rate = vmi_osc_rate(x0, omega0, alpha);
    if (x0 == 0 && rate == rate) rate = 0; /* at rest, where the rate may be infinite */
    vmi_osc_at_phase(x0, rate * t, omega0, alpha, x, v);
}

/* The approximations with the exact amplitude and period, started at rest: x0 cos(Omega t) (291), (295) with
   Omega_alpha (293), Omega = Omega_alpha omega0 |x0|^((alpha-1)/2); and x0 cn(Omega_1 t | m) (297), (302) with
   Omega_1* (300), m = k^2 (307), -1.8079 < m < 0.8062, which has the exact velocity at x = 0 also */
VM_API vm_real vm_osc_omega_trig(vm_real alpha) { return VM_PI * vmi_osc_rate(1, 1, alpha) / ateb_pi(alpha); }

/* Documented with vm_osc_omega_trig. */
VM_API vm_real vm_osc_jacobi_parameter(vm_real alpha) { return jacobi_solve_kpK(ateb_pi(alpha) / (alpha + 1)); }

/* Documented with vm_osc_omega_trig. */
/* (300) with K = Pi_alpha/((alpha + 1) k') from (307) */
VM_API vm_real vm_osc_omega_jacobi(vm_real alpha)
{
    return VM_SQRT(2 / ((alpha + 1) * jacobi_solve_kpK_m1(ateb_pi(alpha) / (alpha + 1))));
}

/* Energy by mass v^2/2 + omega0^2 |x|^(alpha+1)/(alpha+1) (259), m^2/s^2 */
VM_API vm_real vm_osc_energy(vm_real x, vm_real v, vm_real omega0, vm_real alpha)
{
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x) || !VM_IS_FINITE(v) || !VM_IS_FINITE(omega0))
        return VM_NAN;
    return v * v / 2 + omega0 * omega0 * vmi_pow_checked(VM_FABS(x), alpha + 1) / (alpha + 1);
}

/* Amplitude A > 0 (m) and phase psi in (-Pi, Pi] of any state: x = A ca(psi), v = -vmax(A) sa(psi) */
/* The amplitude that the velocity alone would give, A_v^((alpha+1)/2) = v/(sqrt(2/(alpha+1)) omega0), and |x| are put
   together as A^(alpha+1) = |x|^(alpha+1) + A_v^(alpha+1), scaled so that no power overflows that A does not. */
VM_API void vm_osc_amplitude_phase(vm_real x, vm_real v, vm_real omega0, vm_real alpha, vm_real *A, vm_real *psi)
{
    if (!A || !psi) return;
    const vm_real n = alpha + 1, s = v / (VM_SQRT(2 / n) * VM_FABS(omega0));
    vm_real a, b, larger;
    *A = *psi = VM_NAN;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(x) || !VM_IS_FINITE(s) || !VM_IS_FINITE(omega0))
        return;
    a = VM_FABS(x);
    b = vmi_pow_checked(VM_FABS(s), 2 / n);
    larger = a > b ? a : b;
    *A = larger == 0 || a == 0 || b == 0 ? larger
                                         : larger * vmi_pow_checked(1 + vmi_pow_checked((a > b ? b : a) / larger, n), 1 / n);
    *psi = ateb_phase(s == 0 ? 0 : -s, x, alpha);
}

/* Exact motion from any x(0) = x0, x'(0) = v0 */
VM_API void vm_osc_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real omega0, vm_real alpha, vm_real *x,
                              vm_real *v)
{
    if (!x || !v) return;
    vm_real A, psi, rate;
    vm_osc_amplitude_phase(x0, v0, omega0, alpha, &A, &psi);
    rate = A == 0 ? 0 : vmi_osc_rate(A, omega0, alpha);
    vmi_osc_at_phase(A, psi + rate * t, omega0, alpha, x, v);
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

/* Documented with vm_osc_omega_trig. */
VM_API void vm_osc_trig(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vmi_osc_constant(VM_ROUTE_TRIG, t, x0, omega0, alpha, x, v);
}

/* Documented with vm_osc_omega_trig. */
VM_API void vm_osc_jacobi(vm_real t, vm_real x0, vm_real omega0, vm_real alpha, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    vmi_osc_constant(VM_ROUTE_JACOBI, t, x0, omega0, alpha, x, v);
}

VM_API vm_osc_errors vm_osc_approximation_errors(vm_real alpha)
{
    const vm_real pi = ateb_pi(alpha);
    vm_osc_errors r = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
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

/* <ca^2> = B(3/(alpha+1), 1/2)/Pi_alpha; B(q, 1/2) is Pi of alpha = 1/q - 1, from q <= 1 upward by its recurrence */
VM_API vm_real vmi_osc_mean_ca2(vm_real alpha, vm_real pi)
{
    vm_real q = 3 / (alpha + 1), factor = 1;
    for (; q > 1; q -= 1) factor *= (q - 1) / (q - VM_C(0.5));
    return factor * ateb_pi(1 / q - 1) / pi;
}

#endif
/* oscillators/laws.h - laws of mass, stiffness and damping: numbers that depend on time */
#ifndef VARMASS_OSCILLATORS_LAWS_H
#define VARMASS_OSCILLATORS_LAWS_H

/* How a mass or a stiffness depends on time: positive between 0 and the times that are asked for. The value at t = 0
   is f0, but for tables and functions. A table is interpolated monotonically, by cubics with Fritsch and Butland's
   slopes; times rise, and t must lie between the first and the last.
   A function is evaluated at 20 points in each panel of time. A panel is at most |t|/32 long, and is halved where
   the function changes fast. So a bump exp(-(time/w)^2) is found if w > |t|/3000 (float |t|/2000). If the law
   changes in a shorter time, set change_time to that time, s: then no panel and no step of an integrator is longer.
   0 means unknown. */
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
    vm_real change_time; /* of a function: the shortest time, s, in which it changes; 0: unknown */
} vm_law;

/* -- Laws of mass and stiffness -- */
VM_API vm_law vmi_law_of(int kind, vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law;
    law.kind = kind;
    law.f0 = f0;
    law.f1 = f1;
    law.f2 = f2;
    law.n = 0;
    law.time = law.value = NULL;
    law.function = NULL;
    law.ctx = NULL;
    law.change_time = 0;
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
    law.n = n;
    law.time = time;
    law.value = value;
    return law;
}

VM_API vm_law vm_law_user(vm_law_function function, void *ctx)
{
    vm_law law = vmi_law_of(VM_LAW_FUNCTION, 0, 0, 0);
    law.function = function;
    law.ctx = ctx;
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
    h0 = t[j] - t[j - 1];
    h1 = t[j + 1] - t[j];
    d0 = (f[j] - f[j - 1]) / h0;
    d1 = (f[j + 1] - f[j]) / h1;
    if (!end) return d0 * d1 <= 0 ? 0 : 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    if (i == last) {
        slope = h0;
        h0 = h1;
        h1 = slope;
        slope = d0;
        d0 = d1;
        d1 = slope;
    }
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
    h = law->time[i + 1] - law->time[i];
    u = t - law->time[i];
    d = (law->value[i + 1] - law->value[i]) / h;
    s0 = vmi_law_slope(law, i);
    s1 = vmi_law_slope(law, i + 1);
    b = (3 * d - 2 * s0 - s1) / h;
    c = (s0 + s1 - 2 * d) / (h * h);
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
    case VM_LAW_LINEAR:
        f[0] = law->f0 + law->f1 * t;
        f[1] = law->f1;
        f[2] = 0;
        break;
    case VM_LAW_QUADRATIC:
        f[0] = law->f0 + t * (law->f1 + t * law->f2);
        f[1] = law->f1 + 2 * law->f2 * t;
        f[2] = 2 * law->f2;
        break;
    case VM_LAW_EXPONENTIAL:
        f[0] = law->f0 * vmi_exp(law->f1 * t, 0);
        f[1] = law->f1 * f[0];
        f[2] = law->f1 * f[1];
        break;
    case VM_LAW_POWER: {
        const vm_real base = 1 + law->f1 * t, c = law->f1 / base;
        f[0] = law->f0 * vmi_pow_checked(base, law->f2);
        f[1] = law->f2 * c * f[0];
        f[2] = (law->f2 - 1) * c * f[1];
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

/* f(t), its rate, and the integral from 0 to t of ds/f: closed forms within some 8 ulp, also where they tend to 0/0;
   of tables and functions by integration, to 1e-13 (float 1e-5) if no change is faster than said above. VM_BAD_MASS
   where f <= 0 at t (the integral: anywhere between), VM_BAD_ARGUMENT outside a table, where the function fails, or where
   change_time is negative or less than |t|/2^20. */
VM_API int vm_law_at(const vm_law *law, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real values[4];
    int status;
    if (!law || !f || !rate) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_derivatives(law, t, 1, 0, values);
    if (status) return status;
    *f = values[0];
    *rate = values[1];
    return VM_OK;
}

#define VMI_LAW_MOST_CHANGES VM_C(1048576.) /* change_times of a run: every call ends */

/* Is the law positive between 0 and t, as far as can be told without going there? Tables: all of it, and in order */
VM_API int vmi_law_check(const vm_law *law, vm_real t)
{
    vm_real f[4];
    int i, status = vmi_law_derivatives(law, 0, 1, 0, f);
    if (!status) status = vmi_law_derivatives(law, t, 1, 0, f);
    if (status) return status;
    if (law->kind == VM_LAW_FUNCTION) {
        if (!VM_IS_FINITE(law->change_time)) return VM_NOT_FINITE;
        if (law->change_time < 0 || VM_FABS(t) > law->change_time * VMI_LAW_MOST_CHANGES)
            return law->change_time == 0 ? VM_OK : VM_BAD_ARGUMENT;
    }
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
    case VM_LAW_POWER:
        *base = law->f1;
        *rate = law->f1 * law->f2;
        return 1;
    case VM_LAW_QUADRATIC: {
        const vm_real square = law->f1 * law->f1, rest = square - 4 * law->f0 * law->f2;
        *rate = law->f1 / law->f0;
        *base = *rate / 2;
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

/* The longest panel in which a law cannot hide a change */
VM_API vm_real vmi_law_longest_panel(const vm_law *law, vm_real whole)
{
    vm_real longest = whole / 32;
    if (law->kind != VM_LAW_FUNCTION) return whole;
    return law->change_time > 0 && law->change_time < longest ? law->change_time : longest;
}

#endif
/* oscillators/problem.h - an oscillator with slowly varying mass, and its plan */
#ifndef VARMASS_OSCILLATORS_PROBLEM_H
#define VARMASS_OSCILLATORS_PROBLEM_H

/* The problem. F, where there is one, is a further small force, N, of time, place and velocity. */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);

typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;          /* >= 0 */
    vm_law mass, stiffness; /* kg; N/m^alpha */
    vm_real reactive;       /* r: 1 with reactive force, 0 without (a leak) */
    vm_real damping;        /* b, kg/s (the dissertation's eps b); negative ones drive */
    vm_real x, v;           /* at t = 0, m and m/s */
    vm_osc_force force;     /* F or null */
    void *ctx;
} vm_osc_problem;

typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;
    vm_real amplitude; /* A, of the motion without the ripple of a period for the first four routes */
    vm_real error;     /* estimate of the largest of |error of x|/A and |error of v|/vmax(A), of whatever origin */
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
    r->m = m[0];
    r->k = k[0];
    ln_m = m[1] / m[0];
    ln_k = k[1] / k[0];
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
    p->q = r.q;
    p->h = r.h;
    p->h_rate = r.h_rate;
    p->ln_rho = p->shift = 0;
    if (p->A == 0 || (r.q == 0 && r.h == 0)) return VM_OK;
    vmi_osc_wave_at(&w, p->psi, &ca, &sa);
    g = sa * ca;
    c = ca * ca - M;
    Om_ratio = 1;
    for (i = 0; i < 3; i++) { /* Om at the mean amplitude, A0 rho^(-2/(alpha+3)) */
        e = scale / Om_ratio;
        rho = 1 + r.q * e / 2 * g +
              (r.q * e * r.q * e * (2 - p->gamma) * (g * g - M * n / (n + 6)) + n * c * r.h * e * e) / 8;
        if (!(rho > 0) || !VM_IS_FINITE(rho)) rho = 1; /* far from slow */
        Om_ratio = vmi_pow_checked(rho, -p->gamma);
    }
    p->ln_rho = vmi_log(rho).hi;
    p->shift = -r.q * scale / Om_ratio * n / (2 * (n + 2)) * c;
    return VM_OK;
}

/* All but the Ateb plan, which only pays where many values are wanted */
VM_API int vmi_osc_prepare(vm_osc_plan *p, const vm_osc_problem *problem)
{
    const vm_osc_problem *o = &p->problem;
    vm_real f[4], omega;
    int status;
    p->problem = *problem;
    p->has_ateb = 0;
    if (!(o->alpha >= 0) || !VM_IS_FINITE(o->alpha)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(o->x) || !VM_IS_FINITE(o->v) || !VM_IS_FINITE(o->reactive) || !VM_IS_FINITE(o->damping))
        return VM_NOT_FINITE;
    status = vmi_law_check(&o->mass, 0);
    if (!status) status = vmi_law_check(&o->stiffness, 0);
    if (status) return status;
    vmi_law_derivatives(&o->mass, 0, 1, 0, f);
    p->m0 = f[0];
    vmi_law_derivatives(&o->stiffness, 0, 1, 0, f);
    p->k0 = f[0];
    omega = VM_SQRT(p->k0 / p->m0);
    p->pi = ateb_pi(o->alpha);
    p->gamma = (o->alpha - 1) / (o->alpha + 3);
    p->mean_ca2 = vmi_osc_mean_ca2(o->alpha, p->pi);
    vm_osc_amplitude_phase(o->x, o->v, omega, o->alpha, &p->A, &p->psi);
    p->Om = p->A == 0 ? 0 : vmi_osc_rate(p->A, omega, o->alpha);
    if (!VM_IS_FINITE(p->A) || !VM_IS_FINITE(p->psi) || !VM_IS_FINITE(p->Om)) return VM_NOT_FINITE;
    vmi_osc_find_base(p);
    return VM_OK;
}

/* x(t), x'(t) at any t of either sign, by the route that is asked for, or by the cheapest whose error is estimated
   to be within the tolerance. Like error that is relative: for x within d metres ask for d/A. The laws cost one or
   two sa, ca and the integrals of the mass law, and disregard the tolerance. The integrators work to it (0 means
   1e-6, float 1e-3): each runs twice, the second time stricter, and error comes from what the two differ by; by the
   default tolerance that takes 400 (variation), 700 (rk87), 2200 (rk45) evaluations a period, alpha = 3. With F the
   averaged equations are integrated instead of closed forms, to the tolerance. Then error estimates the whole
   error: that of their integration, of averaging, and of cos and cn in place of the Ateb functions. Averaging
   leaves out the ripple within a period, its effect on phase and amplitude at the start, its square, and a force
   that changes within a period, as in a resonance. For this estimate F is called over a period at the start and at
   eight later times: a force that acts only for a short time between these is not seen. There is
   no second-order law with F, and vm_osc_within takes the variation of constants. So it
   does where no law is within the tolerance, but where alpha is odd: there rk87 is two to four times as fast.
   The error estimates of the first- and second-order laws include the fastest changes of mass and stiffness between
   0 and t: mass and stiffness are examined panel by panel (for functions see vm_law), tables from point to point. A
   change within a period makes the estimate large. vm_osc_within then integrates, in steps of at most a quarter of the
   shortest panel. Over random problems (alpha in [0, 8], q of 3e-3 to 0.1, to t = 3/q; tests/test_routes.c), of
   which some change only in a part of the run or have tables with a step, the true error is below 3 times error in
   99 % of the cases, and above 10 times (vm_osc_within: at most 10.3) in 1 of 1000; of 282 runs by the variation of
   constants one erred by 37 times error, at alpha = 1.5. In the median, error is 3 to 4 (first order), 7 (second
   order), 5 to 20 (integrators) and, with F, 5 to 10 (averaged) times the true error. With rk87 the true error is above 3 times error in 2 % of the cases, up to 20 times: if alpha is not an odd integer, its errors are
   not proportional to the tolerance. Above alpha = 8 the error of the laws of first order is estimated too large.
   VM_TOLERANCE_MISSED: x and v are computed, but error is larger than the tolerance (integrators only; with F
   only the error of integrating the averaged equations counts). Errors leave *motion
   untouched: VM_BAD_MASS (a mass or stiffness that is not positive between 0 and t), VM_BAD_ARGUMENT (alpha < 0, a
   negative tolerance, null pointers, t outside a table, a table out of order), VM_NOT_FINITE, VM_NO_LAW (second-order
   law with F; F on a body at rest at x = 0), VM_NOT_INTEGRATED (an integrator gave up, or would need 2^13 steps a
   period, four times what its longest step asks for, or 2^23 of the present periods: every call ends). */
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

/* The motion at the times of vmi_osc_check_time(t, .), by integration with one tolerance */
enum { VMI_OSC_CHECKS = 8 };

VM_API vm_real vmi_osc_check_time(vm_real t, int i)
{
    return i == VMI_OSC_CHECKS - 1 ? t : t * (vm_real)(4 + i) / (vm_real)(3 + VMI_OSC_CHECKS);
}

#endif
/* oscillators/walk.h - integrals along the mean motion */
#ifndef VARMASS_OSCILLATORS_WALK_H
#define VARMASS_OSCILLATORS_WALK_H

/* -- Integrals of the laws along the motion: int dt/m, int Om dt, int q^2/Om dt -- */
enum { VMI_WALK_ORDERS = 5 };

/* What the walk along the laws from 0 to t gathers. epsilon = q/Om is the small parameter, psi the mean phase. */
typedef struct VM_TAG(vmi_osc_walk) {
    const vm_law *mass, *stiffness;
    const vm_osc_plan *plan; /* null: only the first integral */
    int side;                /* the direction of time */
    vm_real y[3];            /* int dt/m, int Om/Om0 dt, int q^2 Om0/Om dt */
    vm_real fourth;          /* int epsilon^4 + (depsilon/dpsi)^2 dpsi */
    vm_real change[VMI_WALK_ORDERS]; /* int |d^k epsilon/dpsi^k| dpsi, but for jumps at points of tables */
    vm_real ln_A;            /* what jumps of q' have done to the mean amplitude */
    vm_real kicks;           /* the sum of their sizes */
    vm_real kick2, kick3;    /* sums of squares of the jumps of h/Om^2, and of (q h + h')/Om^3 */
    vm_real shortest;        /* panel that the laws took, s */
    vm_real error;           /* of the second integral (of the first, where plan is null) */
    int panels;
} vmi_osc_walk;

/* Gauss' rule of 20 points on [-1, 1], 0 <= i < 20 */
enum { VMI_GAUSS = 20 };

VM_API vm_real vmi_gauss_node(int i)
{
    VM_TABLE vm_real node[10] = {VM_C(0.99312859918509492479), VM_C(0.96397192727791379127),
                                 VM_C(0.91223442825132590587), VM_C(0.83911697182221882339),
                                 VM_C(0.74633190646015079261), VM_C(0.63605368072651502545),
                                 VM_C(0.510867001950827098),   VM_C(0.37370608871541956067),
                                 VM_C(0.22778585114164507808), VM_C(0.076526521133497333755)};
    return i % 2 ? VM_READ(node[i / 2]) : -VM_READ(node[i / 2]);
}

VM_API vm_real vmi_gauss_weight(int i)
{
    VM_TABLE vm_real weight[10] = {VM_C(0.017614007139152118312), VM_C(0.040601429800386941331),
                                   VM_C(0.06267204833410906357),  VM_C(0.083276741576704748725),
                                   VM_C(0.10193011981724043504),  VM_C(0.11819453196151841731),
                                   VM_C(0.1316886384491766269),   VM_C(0.14209610931838205133),
                                   VM_C(0.14917298647260374679),  VM_C(0.1527533871307258507)};
    return VM_READ(weight[i / 2]);
}

/* Coefficients a and b of the series of Legendre's polynomials through values at the points of Gauss' rule, of two
   functions at once, since the polynomials are what takes time */
VM_API void vmi_legendre_fit(const vm_real *values_a, const vm_real *values_b, vm_real *a, vm_real *b)
{
    int i, k;
    for (k = 0; k < VMI_GAUSS; k++) a[k] = b[k] = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real x = vmi_gauss_node(i), weight = vmi_gauss_weight(i);
        const vm_real share_a = weight * values_a[i], share_b = weight * values_b[i];
        vm_real before = 0, now = 1;
        for (k = 0; k < VMI_GAUSS; k++) {
            const vm_real next = ((vm_real)(2 * k + 1) * x * now - (vm_real)k * before) / (vm_real)(k + 1);
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

/* The integral of the series from -1 to x */
VM_API vm_real vmi_legendre_integral(const vm_real *coefficient, vm_real x)
{
    vm_real before = 1, now = x, sum = coefficient[0] * (1 + x);
    int k;
    for (k = 1; k < VMI_GAUSS; k++) {
        const vm_real next = ((vm_real)(2 * k + 1) * x * now - (vm_real)k * before) / (vm_real)(k + 1);
        sum += coefficient[k] * (next - before) / (vm_real)(2 * k + 1);
        before = now;
        now = next;
    }
    return sum;
}

/* The series' derivative, in place: d_k = (2k+1) (c_(k+1) + c_(k+3) + ...) */
VM_API void vmi_legendre_derive(vm_real *coefficient)
{
    vm_real sums[2] = {0, 0};
    int k;
    for (k = VMI_GAUSS - 1; k >= 0; k--) {
        const vm_real own = coefficient[k];
        coefficient[k] = (vm_real)(2 * k + 1) * sums[(k + 1) % 2];
        sums[k % 2] += own;
    }
}

/* The mean square on [-1, 1] */
VM_API vm_real vmi_legendre_square(const vm_real *coefficient)
{
    vm_real sum = 0;
    int k;
    for (k = 0; k < VMI_GAUSS; k++) sum += coefficient[k] * coefficient[k] / (vm_real)(2 * k + 1);
    return sum;
}

/* The largest of the last three coefficients: what the series leaves out is of this size */
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

/* A panel of the walk: the series of 1/m, Om/Om0 and epsilon on it, and its share of the integrals */
typedef struct VM_TAG(vmi_osc_panel) {
    vm_real edge; /* by how much the series of 1/m and of k miss the laws at the panel's ends, relative */
    vm_real inverse[VMI_GAUSS], ratio[VMI_GAUSS], epsilon[VMI_GAUSS];
    vm_real drift, fourth; /* int q^2 Om0/Om dt, int epsilon^4 dpsi */
} vmi_osc_panel;

/* Om/Om0 where k and m are these and int dt/m is y0 */
VM_API vm_real vmi_osc_walk_ratio(const vmi_osc_walk *w, vm_real m, vm_real k, vm_real y0)
{
    const vm_osc_plan *p = w->plan;
    vm_real ln_A, ln_Om;
    vmi_osc_adiabatic(p, vmi_log(m / p->m0).hi, vmi_log(k / p->k0).hi, p->problem.damping * y0, &ln_A, &ln_Om);
    return vmi_exp(ln_Om + (p->problem.alpha - 1) / 2 * w->ln_A, 0);
}

/* The relative difference between a law and its series (or that of its reciprocal) at the ends of the panel.
   Nothing else shows a kink that lies between an end and the next point of Gauss' rule. */
VM_API int vmi_osc_panel_edge(const vm_law *law, int reciprocal, int side, vm_real start, vm_real length,
                              const vm_real *series, vm_real *edge)
{
    vm_real f[4], sums[2];
    int i, k, status;
    sums[0] = sums[1] = 0;
    for (k = 0; k < VMI_GAUSS; k++) {
        sums[0] += k % 2 ? -series[k] : series[k];
        sums[1] += series[k];
    }
    for (i = 0; i < 2; i++) {
        vm_real miss;
        status = vmi_law_derivatives(law, start + (vm_real)i * length, i ? -side : side, 0, f);
        if (status) return status;
        miss = VM_FABS(sums[i] * (reciprocal ? f[0] : 1 / f[0]) - 1);
        if (!(miss <= *edge)) *edge = miss;
    }
    return VM_OK;
}

VM_API int vmi_osc_panel_of(const vmi_osc_walk *w, vm_real start, vm_real length, vmi_osc_panel *panel)
{
    const int damped = w->plan && w->plan->problem.damping != 0;
    vmi_osc_rates r[VMI_GAUSS];
    vm_real values[VMI_GAUSS], others[VMI_GAUSS], f[4];
    int i, status;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real t = start + length * ((1 + vmi_gauss_node(i)) / 2);
        if (w->plan) {
            status = vmi_osc_rates_at(w->plan, t, w->side, 0, r + i);
        } else {
            status = vmi_law_derivatives(w->mass, t, w->side, 0, f);
            r[i].m = r[i].k = f[0];
        }
        if (status) return status;
        values[i] = 1 / r[i].m;
        others[i] = r[i].k;
    }
    vmi_legendre_fit(values, others, panel->inverse, panel->ratio);
    panel->edge = 0;
    status = vmi_osc_panel_edge(w->mass, 1, w->side, start, length, panel->inverse, &panel->edge);
    if (status || !w->plan) return status;
    status = vmi_osc_panel_edge(w->stiffness, 0, w->side, start, length, panel->ratio, &panel->edge);
    if (status) return status;
    panel->drift = panel->fourth = 0;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real way = damped ? length / 2 * vmi_legendre_integral(panel->inverse, vmi_gauss_node(i)) : 0;
        const vm_real ratio = vmi_osc_walk_ratio(w, r[i].m, r[i].k, w->y[0] + way);
        const vm_real share = vmi_gauss_weight(i) / 2 * length, drift = r[i].q * r[i].q / ratio;
        const vm_real epsilon = r[i].q / (w->plan->Om * ratio);
        panel->drift += share * drift;
        panel->fourth += VM_FABS(share * drift) * epsilon * epsilon / w->plan->Om;
        values[i] = ratio;
        others[i] = epsilon;
    }
    vmi_legendre_fit(values, others, panel->ratio, panel->epsilon);
    return VM_OK;
}

/* Whether the panel is short enough for its series. Gauss' rule integrates twice as many terms, so that the error
   of the integrals is about the square of the tail. epsilon may be less accurate. If a law has a kink, no panel is
   short enough for that; what is left out must then not matter. whole is the walk's length. */
VM_API int vmi_osc_panel_resolved(const vmi_osc_walk *w, const vmi_osc_panel *panel, vm_real length, vm_real whole)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-9) : VM_C(1e-5), epsilon_enough = VM_C(1e-3);
    const vm_real matters = VM_EPSILON / 4 * whole / VM_FABS(length), phase_matters = 16 * VM_EPSILON;
    const vm_real limit = enough > matters ? enough : matters;
    const vm_real *series = w->plan ? panel->ratio : panel->inverse;
    const vm_real edge_enough = 16 * limit; /* where all coefficients left out add up */
    vm_real phase;
    if (!(panel->edge <= edge_enough)) return 0;
    if (!(vmi_legendre_tail(panel->inverse) <= limit * panel->inverse[0])) return 0;
    if (!(vmi_legendre_tail(series) <= limit * series[0])) return 0;
    if (!w->plan) return 1;
    phase = w->plan->Om * panel->ratio[0] * VM_FABS(length);
    return vmi_legendre_tail(panel->epsilon) <=
           epsilon_enough * VM_SQRT(vmi_legendre_square(panel->epsilon)) + phase_matters / phase;
}

/* The panel's share of all that the walk gathers */
VM_API void vmi_osc_walk_add(vmi_osc_walk *w, vmi_osc_panel *panel, vm_real length)
{
    const vm_real size = VM_FABS(length), noise = 1024 * VM_EPSILON;
    vm_real Om, rate, least;
    int k;
    w->panels++;
    w->y[0] += length * panel->inverse[0];
    if (!w->plan) {
        w->error += size * vmi_legendre_tail(panel->inverse) * vmi_legendre_tail(panel->inverse) / panel->inverse[0];
        return;
    }
    w->y[1] += length * panel->ratio[0];
    w->y[2] += panel->drift;
    Om = w->plan->Om * panel->ratio[0];
    rate = 1;
    least = noise * VM_SQRT(vmi_legendre_square(panel->epsilon));
    for (k = 0; k < VMI_GAUSS; k++)
        if (VM_FABS(panel->epsilon[k]) <= least) panel->epsilon[k] = 0;
    for (k = 0; k < VMI_WALK_ORDERS; k++) {
        const vm_real square = vmi_legendre_square(panel->epsilon) * rate * rate;
        w->change[k] += Om * size * VM_SQRT(square);
        if (k == 1) w->fourth += Om * size * square;
        vmi_legendre_derive(panel->epsilon);
        rate *= 2 / (size * Om);
    }
    w->fourth += panel->fourth;
}

/* At t, a point of a table, q' jumps. The motion does not jump, and so goes on with another mean amplitude. This
   holds for small jumps only: a larger one changes only the error estimate. */
VM_API int vmi_osc_knot(vmi_osc_walk *w, vm_real t)
{
    const vm_osc_plan *p = w->plan;
    const vm_real n = p->problem.alpha + 1, largest = VM_C(0.5);
    const vmi_osc_wave wave = vmi_osc_wave_of(VM_ROUTE_ATEB, n - 1, p->pi, p->has_ateb ? &p->ateb : NULL);
    vmi_osc_rates before, after;
    vm_real ca, sa, jump, kick, Om;
    int status = vmi_osc_rates_at(p, t, -w->side, 1, &before);
    if (!status) status = vmi_osc_rates_at(p, t, w->side, 1, &after);
    if (status || before.h == after.h) return status;
    Om = p->Om * vmi_osc_walk_ratio(w, after.m, after.k, w->y[0]);
    jump = (before.h - after.h) / (Om * Om);
    if (VM_FABS(jump) < largest) {
        vmi_osc_phase_from_mean(p, &wave, vmi_osc_mean_phase(p, w->y), after.q * n / (2 * (n + 2) * Om), &ca, &sa);
        kick = n / (4 * (n + 2)) * (ca * ca - p->mean_ca2) * jump;
        w->ln_A += kick;
        w->kicks += VM_FABS(kick);
    }
    w->kick2 += jump * jump;
    jump = jump * jump + (VM_FABS(jump * after.q) + VM_FABS(before.h_rate - after.h_rate) / (Om * Om)) / Om;
    w->kick3 += jump * jump;
    return VM_OK;
}

/* From start to end, between which no table has a point, by panels of at most longest */
VM_API int vmi_osc_walk_piece(vmi_osc_walk *w, vm_real start, vm_real end, vm_real longest, vm_real whole)
{
    const int most_panels = 4096; /* beyond, for laws with noise, panels are no longer halved */
    const vm_real least = whole / VM_C(1099511627776.); /* 2^40 */
    const vm_real side = (vm_real)w->side, most = longest < VM_FABS(end - start) ? longest : VM_FABS(end - start);
    vm_real t = start, size = most;
    int halved = 0;
    while (t != end) {
        vmi_osc_panel panel;
        const vm_real left = VM_FABS(end - t), step = left <= size * VM_C(1.0001) ? left : size;
        int status = vmi_osc_panel_of(w, t, side * step, &panel);
        if (status) return status;
        if (!vmi_osc_panel_resolved(w, &panel, step, whole)) {
            if (step > least && halved < most_panels && t + side * (step / 2) != t) {
                size = step / 2;
                halved++;
                continue;
            }
            if (w->plan) w->error += step * vmi_legendre_tail(panel.ratio);
            else w->error += step * vmi_legendre_tail(panel.inverse);
        }
        vmi_osc_walk_add(w, &panel, side * step);
        if (step < w->shortest && step < left) w->shortest = step;
        t = step == left ? end : t + side * step;
        size = 2 * step < most ? 2 * step : most;
    }
    return VM_OK;
}

/* The walk along the laws from 0 to t, from one point of a table to the next */
VM_API int vmi_osc_walk_to(vmi_osc_walk *w, vm_real t)
{
    const vm_real whole = VM_FABS(t);
    vm_real at = 0, longest = vmi_law_longest_panel(w->mass, whole), knot;
    int k, status = VM_OK;
    if (w->plan && vmi_law_longest_panel(w->stiffness, whole) < longest)
        longest = vmi_law_longest_panel(w->stiffness, whole);
    w->side = t < 0 ? -1 : 1;
    w->y[0] = w->y[1] = w->y[2] = w->fourth = 0;
    for (k = 0; k < VMI_WALK_ORDERS; k++) w->change[k] = 0;
    w->ln_A = w->kicks = w->kick2 = w->kick3 = w->error = 0;
    w->shortest = longest;
    w->panels = 0;
    if (w->plan && w->side < 0) status = vmi_osc_knot(w, 0); /* the plan starts with what is on the other side of 0 */
    while (!status && at != t) {
        knot = vmi_law_next_knot(w->mass, at, t);
        if (w->plan) knot = vmi_law_next_knot(w->stiffness, at, knot);
        status = vmi_osc_walk_piece(w, at, knot, longest, whole);
        at = knot;
        if (!status && w->plan && at != t) status = vmi_osc_knot(w, at);
    }
    return status;
}

/* Documented with vm_law_at. */
VM_API int vm_law_inverse_integral(const vm_law *law, vm_real t, vm_real *integral)
{
    vm_real base, rate, y[1];
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
        vmi_osc_walk w;
        w.mass = w.stiffness = law;
        w.plan = NULL;
        status = vmi_osc_walk_to(&w, t);
        y[0] = w.y[0];
    }
    return status ? status : vmi_copy_if_finite(1, y, integral);
}

/* -- The mean motion, by the laws -- */
typedef struct VM_TAG(vmi_osc_mean) {
    vmi_osc_rates now;
    vm_real y[3];         /* int dt/m, int Om/Om0 dt, int q^2 Om0/Om dt */
    vm_real fourth;       /* int epsilon^4 + (depsilon/dpsi)^2 dpsi */
    vm_real ln_A, ratio;  /* ln A/A0, Om/Om0 by the adiabatic law */
    vm_real kick2, kick3; /* of the points of tables, as above */
    vm_real fast;         /* ln of the action, up to which the laws' fastest part can change it */
    vm_real phase_error;  /* of y[1], times Om */
} vmi_osc_mean;

/* A bound of the change of ln J that the adiabatic law leaves out. The law ignores (ln J)' = epsilon w(psi), per
   radian of phase, with w = (1 - (n+2)/n sa^2)/2, whose mean is 0. The change is at most the integral of
   |epsilon w|. After k integrations by parts it is at most the integral of the kth derivative of epsilon times the
   kth integral of w; the terms at the ends are in the laws. The smallest of these bounds is taken: one with a high
   k for slow laws, the first for a change in less than a period. At points of tables the derivatives jump. The laws
   contain the effect (a kick) of the jumps of the first derivative, and kick3 that of the next. Where the first
   bounds are the smallest, the kicks in the laws are wrong, so these bounds include them. */
VM_API vm_real vmi_osc_fast(const vm_osc_plan *p, const vmi_osc_walk *w)
{
    const vm_real n = p->problem.alpha + 1, turn = p->pi / (2 * VM_PI);
    vm_real size[VMI_WALK_ORDERS], least = VM_INFINITY;
    int k;
    size[0] = n < 2 ? 1 / n : VM_C(0.5);
    size[1] = VM_C(0.25); /* sa ca/2 */
    size[2] = n / 8 * (p->mean_ca2 > VM_C(0.5) ? p->mean_ca2 : 1 - p->mean_ca2);
    for (k = 3; k < VMI_WALK_ORDERS; k++) size[k] = size[k - 1] * turn;
    for (k = 0; k < VMI_WALK_ORDERS; k++) {
        const vm_real bound = size[k] * w->change[k] + (k < 2 ? (n + 2) / 2 * w->kicks : 0);
        if (bound < least) least = bound;
    }
    return least;
}

/* The mean motion where the laws have to be walked along */
VM_API int vmi_osc_mean_by_walk(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean, vm_real *ln_Om)
{
    const vm_osc_problem *o = &p->problem;
    vmi_osc_walk w;
    int i, status;
    w.mass = &o->mass;
    w.stiffness = &o->stiffness;
    w.plan = p;
    status = vmi_osc_walk_to(&w, t);
    if (status) return status;
    vmi_osc_adiabatic(p, vmi_log(mean->now.m / p->m0).hi, vmi_log(mean->now.k / p->k0).hi, o->damping * w.y[0],
                      &mean->ln_A, ln_Om);
    mean->ln_A += w.ln_A;
    *ln_Om += (o->alpha - 1) / 2 * w.ln_A;
    for (i = 0; i < 3; i++) mean->y[i] = w.y[i];
    mean->fourth = w.fourth;
    mean->kick2 = w.kick2;
    mean->kick3 = w.kick3;
    mean->fast = vmi_osc_fast(p, &w);
    mean->phase_error = p->Om * w.error;
    return VM_OK;
}

VM_API int vmi_osc_mean_at(const vm_osc_plan *p, vm_real t, vmi_osc_mean *mean)
{
    vm_real ln_Om;
    int status = vmi_osc_rates_at(p, t, t < 0 ? 1 : -1, 1, &mean->now);
    mean->kick2 = mean->kick3 = mean->fast = mean->phase_error = 0;
    if (status) return status;
    if (p->closed) { /* epsilon goes as a power or an exponential: what is fastest is at one of the ends */
        const vm_real u = t * vmi_log_ratio(p->base * t), damping = p->problem.damping * u / p->m0, Q = p->q;
        const vm_real e = Q / p->Om, d = p->h / (p->Om * p->Om);
        vmi_osc_adiabatic(p, p->rate_m * u, p->rate_k * u, damping, &mean->ln_A, &ln_Om);
        mean->y[0] = u / p->m0;
        mean->y[1] = u * vmi_exp_ratio(p->base * u + ln_Om);
        mean->y[2] = Q * Q * u * vmi_exp_ratio(-p->base * u - ln_Om);
        mean->fourth = (e * e * e * e + d * d) * p->Om * VM_FABS(u * vmi_exp_ratio(-3 * (p->base * u + ln_Om)));
    } else {
        status = vmi_osc_mean_by_walk(p, t, mean, &ln_Om);
        if (status) return status;
    }
    mean->ratio = vmi_exp(ln_Om, 0);
    return VM_IS_FINITE(mean->y[1]) && VM_IS_FINITE(mean->ln_A) && VM_IS_FINITE(mean->ratio) ? VM_OK
                                                                                             : VM_NOT_FINITE;
}

#endif
/* oscillators/mean_laws.h - the mean motion by laws of first and second order, and their errors */
#ifndef VARMASS_OSCILLATORS_MEAN_LAWS_H
#define VARMASS_OSCILLATORS_MEAN_LAWS_H

/* -- Estimates, of the larger of |error of x|/A and |error of v|/vmax -- */
/* What roundings of the phase come to */
VM_API vm_real vmi_osc_rounding(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    return 4 * VM_EPSILON * (2 + VM_FABS(p->Om * mean->y[1])) + mean->phase_error;
}

/* What the laws miss on the way: changes that are not slow, which in the phase grow by the factor gamma Om t, and
   the roughness of tables */
VM_API vm_real vmi_osc_way_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real g = VM_FABS(p->gamma * p->Om * mean->y[1]);
    return (1 + g) * mean->fast + VM_C(0.2) * (VM_SQRT(mean->kick2) + g * VM_SQRT(mean->kick3));
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
    return phase + amplitude + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
}

/* The second-order law leaves out ripples of second order at the start and at t, the third order of ln rho, which the
   phase multiplies, and the fourth order of the mean phase. */
VM_API vm_real vmi_osc_second_error(const vm_osc_plan *p, const vmi_osc_mean *mean)
{
    const vm_real Om = p->Om * mean->ratio, e = VM_FABS(mean->now.q) / Om, e0 = VM_FABS(p->q) / p->Om;
    const vm_real d = VM_FABS(mean->now.h) / (Om * Om), d0 = VM_FABS(p->h) / (p->Om * p->Om);
    const vm_real third = VM_FABS(p->h_rate) / (p->Om * p->Om) / p->Om;
    const vm_real ripple = (e * e + d) + (e0 * e0 + d0), start = e0 * e0 * e0 + e0 * d0 + d0 * VM_SQRT(d0) + third;
    const vm_real g = VM_FABS(p->gamma * p->Om * mean->y[1]);
    return (VM_C(0.02) + VM_C(0.015) * p->problem.alpha) * ripple + VM_C(0.15) * g * start +
           VM_C(0.1) * mean->fourth + vmi_osc_way_error(p, mean) + vmi_osc_rounding(p, mean);
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

#endif
/* oscillators/averaging.h - averaged equations with a force, and their errors */
#ifndef VARMASS_OSCILLATORS_AVERAGING_H
#define VARMASS_OSCILLATORS_AVERAGING_H

/* -- Averaged equations with a force -- */
/* Means over a period of F s and F c at amplitude A and V = speed vmax: on each quarter 20 points of Gauss' rule as
   far as the velocity changes its sign like tanh psi, and 20 in the root of the distance from x = 0, where powers
   of it that are not whole may occur */
VM_API void vmi_osc_means(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real A, vm_real V, vm_real *Fs,
                          vm_real *Fc)
{
    const vm_real half = p->pi / 2, cut = half < 6 ? half / 2 : 3;
    int i, quarter;
    *Fs = *Fc = 0;
    for (i = 0; i < 40; i++) {
        const int k = i % 20, outer = i >= 20;
        const vm_real u = (1 + vmi_gauss_node(k)) / 2, length = outer ? half - cut : cut;
        const vm_real share = vmi_gauss_weight(k) / 8 * length / half * (outer ? 2 * u : 1);
        vm_real c, s;
        vmi_osc_wave_at(w, outer ? half - length * u * u : cut * u, &c, &s);
        for (quarter = 0; quarter < 4; quarter++) {
            const vm_real qc = quarter & 1 ? -c : c, qs = quarter & 2 ? -s : s;
            const vm_real F = p->problem.force(t, A * qc, -V * qs, p->problem.ctx);
            *Fs += share * F * qs;
            *Fc += share * F * qc;
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

/* Averaged equations at (t, A) with the force F of the problem: A', theta', psi' in the method's own angle (Ateb
   phase, radians, Jacobi argument), for VM_ROUTE_ATEB: (314), (315) averaged, with the term of omega' that they
   lack; VM_ROUTE_TRIG: (337)-(339) with alpha + 3 for 5 - alpha and 4 for the 2 of (338), (339); VM_ROUTE_JACOBI:
   (380)-(382) with theta' in the second of (382). Means by Gauss' rule on each quarter of the period, so that F may
   jump where x or x' = 0: to 1e-10 for cubic F and alpha <= 30 (float: roundings). 160 calls of F. */
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
    if (!VM_IS_FINITE(A * rate) || !VM_IS_FINITE(w.turn * Om + theta)) return VM_NOT_FINITE;
    *A_rate = A * rate;
    *theta_rate = theta;
    *psi_rate = w.turn * Om + theta;
    return VM_OK;
}

/* -- How good averaged equations with a force are -- */
/* What averaging leaves out at time t and amplitude A, all by ln A or by radians of the Ateb phase */
typedef struct VM_TAG(vmi_osc_averaging) {
    vm_real Om;
    vm_real start_A, start_psi; /* the ripple at the phase that is given */
    vm_real ripple;             /* the largest ripple of ln A plus the largest of psi */
    vm_real rate_A, rate_psi;   /* errors of the mean rates, per second */
    vm_real growth;             /* of a small change of ln A, per second */
} vmi_osc_averaging;

enum { VMI_AVERAGING_POINTS = 64 };

/* The rates of ln A and psi over the period before t on the way from 0 to t_end (over the first period, if t is not
   yet so far): with the force as it is at t if `frozen`, otherwise with the force as time goes on */
VM_API void vmi_osc_period_rates(const vm_osc_plan *p, const vmi_osc_rates *now, vm_real A, vm_real Om, vm_real psi,
                                 vm_real t, vm_real t_end, int frozen, vm_real *rate_A, vm_real *rate_psi)
{
    const vm_real n = p->problem.alpha + 1, V = 2 * A * Om / n, side = t_end < 0 ? (vm_real)-1 : (vm_real)1;
    const vmi_osc_wave w = vmi_osc_wave_of(VM_ROUTE_ATEB, n - 1, p->pi, p->has_ateb ? &p->ateb : NULL);
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) {
        const vm_real way = 2 * p->pi * (vm_real)i / (vm_real)VMI_AVERAGING_POINTS;
        vm_real ca, sa, F, time = t + side * (way - 2 * p->pi) / Om;
        if ((time < 0) != (t_end < 0)) time = side * way / Om; /* before the start: the first period instead */
        if (VM_FABS(time) > VM_FABS(t_end)) time = t_end;
        if (frozen) time = t;
        vmi_osc_wave_at(&w, psi + way, &ca, &sa);
        F = p->problem.force(time, A * ca, -V * sa, p->problem.ctx) / (now->m * V);
        rate_A[i] = -now->q / n * sa * sa - 2 / n * F * sa;
        rate_psi[i] = -now->q / 2 * sa * ca - F * ca;
    }
}

/* Takes the mean off values over a period, and returns it */
VM_API vm_real vmi_osc_take_mean(vm_real *values)
{
    vm_real mean = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) mean += values[i] / (vm_real)VMI_AVERAGING_POINTS;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) values[i] -= mean;
    return mean;
}

/* The integral over the phase, in steps of width, of values without mean, without mean */
VM_API void vmi_osc_integrate_ripple(const vm_real *values, vm_real width, vm_real *ripple)
{
    int i;
    ripple[0] = 0;
    for (i = 1; i < VMI_AVERAGING_POINTS; i++)
        ripple[i] = ripple[i - 1] + width * (values[i - 1] + values[i]) / 2;
    vmi_osc_take_mean(ripple);
}

VM_API vm_real vmi_osc_largest(const vm_real *values)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < VMI_AVERAGING_POINTS; i++)
        if (VM_FABS(values[i]) > largest) largest = VM_FABS(values[i]);
    return largest;
}

VM_API int vmi_osc_averaging_at(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t, vm_real t_end, vm_real A,
                                vm_real psi, vmi_osc_averaging *a)
{
    const vm_real second_order = VM_C(0.25); /* of rate times ripple: 1.6 times what Duffing's equation has */
    const vm_real change = VM_C(0.02);       /* of ln A, for the growth of a small change */
    const vm_real width = 2 * p->pi / (vm_real)VMI_AVERAGING_POINTS, bend = (w->alpha - 1) / 2;
    const vmi_osc_wave exact = vmi_osc_wave_of(VM_ROUTE_ATEB, w->alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    vm_real rate_A[VMI_AVERAGING_POINTS], rate_psi[VMI_AVERAGING_POINTS];
    vm_real ripple_A[VMI_AVERAGING_POINTS], ripple_psi[VMI_AVERAGING_POINTS];
    vm_real mean_A, mean_psi, own_A, own_psi, exact_A, exact_psi, more_A, more_psi, rates, second;
    vmi_osc_rates now;
    int i, status = vmi_osc_rates_at(p, t, t_end < 0 ? 1 : -1, 0, &now);
    if (status) return status;
    a->Om = vmi_osc_rate(A, VM_SQRT(now.k / now.m), w->alpha);
    vmi_osc_period_rates(p, &now, A, a->Om, psi, t, t_end, 1, rate_A, rate_psi);
    own_A = vmi_osc_take_mean(rate_A);
    own_psi = vmi_osc_take_mean(rate_psi);
    vmi_osc_period_rates(p, &now, A, a->Om, psi, t, t_end, 0, rate_A, rate_psi);
    rates = vmi_osc_largest(rate_A) + vmi_osc_largest(rate_psi);
    mean_A = vmi_osc_take_mean(rate_A);
    mean_psi = vmi_osc_take_mean(rate_psi);
    a->rate_A = VM_FABS(mean_A - own_A);
    a->rate_psi = VM_FABS(mean_psi - own_psi);
    vmi_osc_averaged_rates(p, w, &now, t, A, a->Om, &own_A, &own_psi);
    vmi_osc_averaged_rates(p, &exact, &now, t, A, a->Om, &exact_A, &exact_psi);
    a->rate_A += VM_FABS(own_A - exact_A);
    a->rate_psi += VM_FABS(own_psi / w->turn - exact_psi);
    vmi_osc_averaged_rates(p, w, &now, t, A * (1 + change), a->Om * (1 + bend * change), &more_A, &more_psi);
    a->growth = (more_A - own_A) / change;
    vmi_osc_integrate_ripple(rate_A, width / a->Om, ripple_A);
    for (i = 0; i < VMI_AVERAGING_POINTS; i++) rate_psi[i] += bend * a->Om * ripple_A[i];
    vmi_osc_take_mean(rate_psi);
    vmi_osc_integrate_ripple(rate_psi, width / a->Om, ripple_psi);
    a->start_A = VM_FABS(ripple_A[0]);
    a->start_psi = VM_FABS(ripple_psi[0]);
    a->ripple = vmi_osc_largest(ripple_A) + vmi_osc_largest(ripple_psi);
    second = second_order * rates * a->ripple;
    a->rate_A += second;
    a->rate_psi += second;
    return VM_OK;
}

/* Estimates the error of the averaged equations with a force at t, from the amplitudes at the times of
   vmi_osc_check_time. Errors arise from the ripple at the start, which is taken for a part of the mean, and from the
   errors of the rates. They grow as small changes of the motion do, and an error of the amplitude adds one of the
   phase. The ripple at t, the wave that is not ca and sa, and what is too fast in the laws of mass and stiffness
   are added at the end. */
VM_API int vmi_osc_averaging_error(const vm_osc_plan *p, const vmi_osc_wave *w, vm_real t,
                                   const vm_osc_motion *motion, vm_real *error)
{
    const vm_real bend = VM_FABS(w->alpha - 1) / 2;
    vmi_osc_averaging before, after;
    vmi_osc_mean mean;
    vm_real time = 0, in_A, in_psi;
    int i, status = vmi_osc_averaging_at(p, w, 0, t, p->A, p->psi, &before);
    if (!status) status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    in_A = before.start_A;
    in_psi = before.start_psi;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        const vm_real next = vmi_osc_check_time(t, i), step = VM_FABS(next - time);
        vm_real largest_A = in_A, growth;
        status = vmi_osc_averaging_at(p, w, next, t, motion[i].amplitude, 0, &after);
        if (status) return status;
        growth = (before.growth + after.growth) / 2 * (next - time);
        in_A = (in_A + (before.rate_A > after.rate_A ? before.rate_A : after.rate_A) * step) * vmi_exp(growth, 0);
        if (in_A > largest_A) largest_A = in_A;
        in_psi += ((before.rate_psi > after.rate_psi ? before.rate_psi : after.rate_psi) +
                   bend * (before.Om > after.Om ? before.Om : after.Om) * largest_A) *
                  step;
        before = after;
        time = next;
    }
    *error = in_A + in_psi + after.ripple + vmi_osc_wave_error(p, w) + vmi_osc_way_error(p, &mean);
    if (!(*error >= 0)) *error = VM_INFINITY; /* amplitude 0, or out of range: nothing is known */
    return VM_OK;
}

#endif
/* oscillators/integration.h - integration of the oscillator to a tolerance */
#ifndef VARMASS_OSCILLATORS_INTEGRATION_H
#define VARMASS_OSCILLATORS_INTEGRATION_H

/* -- Integration -- */
#define VMI_OSC_LONGEST VM_C(0.2) /* step of the loose run, in periods */

typedef struct VM_TAG(vmi_osc_run) {
    const vm_osc_plan *p;
    vmi_osc_wave wave;
    int route, direct, high, side, status;
    vm_real longest, share; /* step at most, in periods and by the way to the next stop */
    vm_real law_step;       /* step, s, in which no law of a function changes unseen, for VMI_OSC_LONGEST */
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
        dydt[0] -= 2 / n * F * sa;
        dydt[1] -= F * ca;
    }
    return 0;
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
    m = now.m / p->m0;
    weight = o->reactive == 1 ? m : o->reactive == 0 ? 1 : vmi_pow_checked(m, o->reactive);
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
    const vm_real most_periods = VM_C(8388608.); /* 2^23: in float more hold no phase, in double they take minutes */
    const vm_real most_steps = 8192; /* a period; 2600 were the most, by rk45 to 16 eps, alpha from 0 to 20 */
    const vm_real law_step = c->law_step * c->longest / VMI_OSC_LONGEST;
    vm_real stop, y[2], period, most, longest, steps;
    int status = VM_OK;
    while (status >= 0 && c->s.t != t) {
        period = vmi_osc_period_now(c);
        if (!(period > VM_FABS(t) / most_periods)) return c->status ? c->status : VM_NOT_INTEGRATED;
        stop = vmi_law_next_knot(&c->p->problem.mass, c->s.t, t);
        stop = vmi_law_next_knot(&c->p->problem.stiffness, c->s.t, stop);
        if (VM_FABS(stop - c->s.t) > 64 * period) stop = c->s.t + (vm_real)c->side * 64 * period;
        most = c->share * VM_FABS(stop - c->s.t) + 64 * VM_EPSILON * VM_FABS(t);
        longest = period * (c->p->pi < 10 ? c->longest : c->longest * 10 / c->p->pi);
        if (law_step < longest) longest = law_step;
        c->s.options.h_max = most < longest ? most : longest;
        steps = VM_FABS(stop - c->s.t) * (most_steps / period + 4 / c->s.options.h_max) + most_steps;
        c->s.options.max_steps = steps < VM_C(1e9) ? (long)steps : 1000000000L;
        status = c->high ? rk87_solve(&c->s, stop) : rk45_solve(&c->s, stop);
        if (status < 0) break;
        y[0] = c->s.y[0];
        y[1] = c->s.y[1];
        if (!c->direct) y[1] -= 2 * c->p->pi * VM_FLOOR(y[1] / (2 * c->p->pi));
        status = c->high ? rk87_restart(&c->s, c->s.t, y) : rk45_restart(&c->s, c->s.t, y);
    }
    return c->status ? c->status : status < 0 ? VM_NOT_INTEGRATED : VM_OK;
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
        A = p->A * vmi_exp(y[0], 0);
        Om = p->Om * vmi_osc_Om_ratio(p, &now, y[0]);
        vmi_osc_wave_at(&c->wave, y[1], &ca, &sa);
        return vmi_osc_motion_of(&c->wave, A, Om, ca, sa, 0, c->route, motion);
    }
    weight = vmi_pow_checked(now.m / p->m0, p->problem.reactive);
    motion->x = p->A * y[0];
    motion->v = 2 * p->A * p->Om / (p->problem.alpha + 1) * y[1] / weight;
    vm_osc_amplitude_phase(motion->x, motion->v, VM_SQRT(now.k / now.m), p->problem.alpha, &motion->amplitude, &Om);
    motion->route = c->route;
    return VM_IS_FINITE(motion->amplitude) ? VM_OK : VM_NOT_FINITE;
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
    c->side = t < 0 ? -1 : 1;
    c->status = VM_OK;
    options.rtol = c->direct ? tolerance : -1;
    options.atol = tolerance;
    vmi_osc_wave_at(&c->wave, p->psi, &ca, &sa);
    y[0] = c->direct ? ca : 0;
    y[1] = c->direct ? -sa : p->psi;
    status = c->high ? rk87_init(&c->s, f, c, 2, 0, y, &options, c->work)
                     : rk45_init(&c->s, f, c, 2, 0, y, &options, c->work);
    if (status < 0) return VM_NOT_INTEGRATED;
    for (i = 0; i < VMI_OSC_CHECKS; i++) {
        status = vmi_osc_solve(c, vmi_osc_check_time(t, i));
        if (!status) status = vmi_osc_motion_now(c, motion + i);
        if (status) return status;
    }
    c->evals += c->s.evals;
    return VM_OK;
}

/* The larger of the differences of x by A and of v by vmax, the largest at the times of vmi_osc_check_time: at one time
   two runs may agree by chance */
VM_API vm_real vmi_osc_difference(const vm_osc_plan *p, vm_real t, const vm_osc_motion *a, const vm_osc_motion *b)
{
    vmi_osc_rates now;
    vm_real d, largest = 0;
    int i;
    for (i = 0; i < VMI_OSC_CHECKS; i++, a++, b++) {
        if (a->amplitude == 0 || vmi_osc_rates_at(p, vmi_osc_check_time(t, i), t < 0 ? 1 : -1, 0, &now))
            return VM_INFINITY;
        d = VM_FABS(a->x - b->x) / a->amplitude;
        if (d > largest) largest = d;
        d = VM_FABS(a->v - b->v) / vm_osc_vmax(a->amplitude, VM_SQRT(now.k / now.m), p->problem.alpha);
        if (d > largest) largest = d;
    }
    return largest;
}

/* The longest step in which no law that is a function changes unseen: a part of the shortest panel in the walk
   along the laws. A jump of a law would make it 0, so it is at least a fixed part of the run. */
VM_API int vmi_osc_law_step(const vm_osc_plan *p, vm_real t, vm_real *step)
{
    const vm_law *laws[2];
    const vm_real panel_steps = 4, run_steps = 8192;
    vmi_osc_walk w;
    int i, status;
    laws[0] = w.mass = &p->problem.mass;
    laws[1] = w.stiffness = &p->problem.stiffness;
    w.plan = p;
    *step = VM_FABS(t);
    if (laws[0]->kind != VM_LAW_FUNCTION && laws[1]->kind != VM_LAW_FUNCTION) return VM_OK;
    status = vmi_osc_walk_to(&w, t);
    if (status) return status;
    *step = VM_FABS(t) / run_steps;
    if (w.shortest / panel_steps > *step) *step = w.shortest / panel_steps;
    for (i = 0; i < 2; i++)
        if (laws[i]->kind == VM_LAW_FUNCTION && laws[i]->change_time > 0 && laws[i]->change_time < *step)
            *step = laws[i]->change_time;
    return VM_OK;
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
    /* times the tolerance of the steps: two runs may agree this well by chance, since mostly their errors are far
       below that tolerance */
    const vm_real by_chance = route == VM_ROUTE_RK87 ? VM_C(1e-4) : VM_C(1e-3);
    vm_osc_plan with_ateb;
    vmi_osc_run c;
    vm_osc_motion loose[VMI_OSC_CHECKS], strict[VMI_OSC_CHECKS], *last = strict + VMI_OSC_CHECKS - 1;
    vm_real step_tolerance = tolerance < VM_C(0.008) ? tolerance / 8 : VM_C(1e-3), before = VM_INFINITY;
    vm_real longest = VMI_OSC_LONGEST, averaging = 0;
    int attempt, status = vmi_osc_law_step(plan, t, &c.law_step), stalled = 0;
    if (status) return status;
    c.p = plan;
    c.route = route;
    c.evals = 0;
    c.direct = route >= VM_ROUTE_RK45;
    c.high = route == VM_ROUTE_RK87;
    if (!plan->has_ateb) {
        with_ateb = *plan;
        c.p = &with_ateb;
        with_ateb.has_ateb = ateb_plan_init(&with_ateb.ateb, plan->problem.alpha) == 0;
    }
    c.wave = vmi_osc_wave_of(route <= VM_ROUTE_ATEB ? route : VM_ROUTE_ATEB, plan->problem.alpha, plan->pi,
                             c.p->has_ateb ? &c.p->ateb : NULL);
    for (attempt = 0; attempt < 6; attempt++) {
        if (step_tolerance < least) step_tolerance = least;
        c.longest = longest;
        c.share = 1;
        status = vmi_osc_integrated(&c, t, ratio * step_tolerance, loose);
        c.longest = longest / 2;
        c.share = VM_C(0.51);
        if (!status) status = vmi_osc_integrated(&c, t, step_tolerance, strict);
        if (status == VM_NOT_INTEGRATED && c.status == VM_OK && step_tolerance > least) {
            step_tolerance /= 2 * ratio; /* a loose run may leave the motion for good */
            continue;
        }
        if (status) return status;
        last->error = factor * vmi_osc_difference(plan, t, strict, loose) +
                      4 * VM_EPSILON * (2 + plan->Om * VM_FABS(t));
        if (last->error < by_chance * step_tolerance) last->error = by_chance * step_tolerance;
        if (last->error > before / 2) {
            /* roundings, chance, or longest is what counts */
            stalled++;
            longest /= 2;
        }
        if (last->error <= tolerance || step_tolerance == least || stalled == 3) break;
        before = last->error;
        step_tolerance *= tolerance / last->error > VM_C(1e-4) ? tolerance / last->error / 4 : VM_C(2e-5);
    }
    if (!status && route <= VM_ROUTE_ATEB) status = vmi_osc_averaging_error(c.p, &c.wave, t, strict, &averaging);
    if (status) return status;
    last->evals = c.evals;
    *motion = *last;
    status = last->error <= tolerance ? VM_OK : VM_TOLERANCE_MISSED;
    if (route <= VM_ROUTE_ATEB) motion->error += averaging;
    return status;
}

#endif
/* oscillators/routes.h - routes to x(t), and the cheapest within a tolerance */
#ifndef VARMASS_OSCILLATORS_ROUTES_H
#define VARMASS_OSCILLATORS_ROUTES_H

/* -- By a given route, and by the cheapest -- */
VM_API int vmi_osc_arguments(const vm_osc_plan *p, vm_real t, vm_real *tolerance, const vm_osc_motion *motion)
{
    int status;
    if (!p || !motion) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(*tolerance)) return VM_NOT_FINITE;
    if (*tolerance < 0) return VM_BAD_ARGUMENT;
    if (*tolerance == 0) *tolerance = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    status = vmi_law_check(&p->problem.mass, t);
    return status ? status : vmi_law_check(&p->problem.stiffness, t);
}

/* No motion, and nothing to start one */
VM_API int vmi_osc_at_rest(const vm_osc_plan *p, int route, vm_osc_motion *motion)
{
    if (p->problem.force) return VM_NO_LAW;
    motion->x = motion->v = motion->amplitude = motion->error = 0;
    motion->route = route;
    motion->evals = 0;
    return VM_OK;
}

/* Documented with vm_osc_plan_init. */
VM_API int vm_osc_plan_by_route(const vm_osc_plan *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vmi_osc_mean mean;
    vmi_osc_wave w;
    int status = vmi_osc_arguments(p, t, &tolerance, motion);
    if (status) return status;
    if (route < 0 || route > VM_ROUTE_RK87) return VM_BAD_ARGUMENT;
    if (p->problem.force && route == VM_ROUTE_SECOND) return VM_NO_LAW;
    if (p->A == 0) return vmi_osc_at_rest(p, route, motion);
    if (route > VM_ROUTE_SECOND || p->problem.force) return vmi_osc_integrate(p, route, t, tolerance, motion);
    status = vmi_osc_mean_at(p, t, &mean);
    if (status) return status;
    w = vmi_osc_wave_of(route == VM_ROUTE_SECOND ? VM_ROUTE_ATEB : route, p->problem.alpha, p->pi,
                        p->has_ateb ? &p->ateb : NULL);
    return route == VM_ROUTE_SECOND ? vmi_osc_second_order(p, &w, &mean, motion)
                                    : vmi_osc_first_order(p, &w, &mean, motion);
}

/* Where no law is good enough: rk87, three times as fast, where it holds its order, which is where alpha is odd, so
   that the force has all derivatives at x = 0 */
VM_API int vmi_osc_integrator(vm_real alpha)
{
    const vm_real half = (alpha - 1) / 2;
    return half == VM_FLOOR(half) ? VM_ROUTE_RK87 : VM_ROUTE_VARIATION;
}

/* Documented with vm_osc_plan_init. */
VM_API int vm_osc_plan_within(const vm_osc_plan *p, vm_real t, vm_real tolerance, vm_osc_motion *motion)
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
    for (method = VM_ROUTE_TRIG; first <= tolerance; method++) { /* the Ateb functions' wave has no error */
        w = vmi_osc_wave_of(method, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
        if (first + vmi_osc_wave_error(p, &w) <= tolerance) return vmi_osc_first_order(p, &w, &mean, motion);
    }
    if (!(vmi_osc_second_error(p, &mean) <= tolerance))
        return vmi_osc_integrate(p, vmi_osc_integrator(p->problem.alpha), t, tolerance, motion);
    w = vmi_osc_wave_of(VM_ROUTE_ATEB, p->problem.alpha, p->pi, p->has_ateb ? &p->ateb : NULL);
    return vmi_osc_second_order(p, &w, &mean, motion);
}

/* The plan of a problem that is asked once, without what only many values repay */
VM_API int vmi_osc_once(const vm_osc_problem *problem, vm_osc_plan *plan)
{
    int status = problem ? vmi_osc_prepare(plan, problem) : VM_BAD_ARGUMENT;
    return status ? status : vmi_osc_start(plan);
}

/* The same for a problem that is asked once */
VM_API int vm_osc_by_route(const vm_osc_problem *problem, int route, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_once(problem, &plan);
    return status ? status : vm_osc_plan_by_route(&plan, route, t, tolerance, motion);
}

/* Documented with vm_osc_by_route. */
VM_API int vm_osc_within(const vm_osc_problem *problem, vm_real t, vm_real tolerance, vm_osc_motion *motion)
{
    vm_osc_plan plan;
    int status = vmi_osc_once(problem, &plan);
    return status ? status : vm_osc_plan_within(&plan, t, tolerance, motion);
}

#endif
/* oscillators/slow.h - what oscillators with slowly varying mass share */
#ifndef VARMASS_OSCILLATORS_SLOW_H
#define VARMASS_OSCILLATORS_SLOW_H

/* A mass, and in this chapter's last sections all that depends on it, at time t: kg, and its rate in kg/s. Slow: it
   changes little in a period. vm_slow_mass_linear is one, whose ctx is a vm_linear_mass. */
typedef vm_real (*vm_slow_mass)(vm_real t, vm_real *rate, void *ctx);

typedef struct VM_TAG(vm_linear_mass) {
    vm_real mass, rate; /* mass + rate t */
} vm_linear_mass;

VM_API int vmi_osc_law_is_in_domain(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    return mass_ratio > 0 && alpha >= 0 && VM_IS_FINITE(mass_ratio) && VM_IS_FINITE(damping) &&
           VM_IS_FINITE(reactive) && VM_IS_FINITE(alpha);
}

/* Amplitude A/A0 and largest velocity over its first value when the mass has come to mass_ratio = m/m0 and
   damping = integral of b/m dt. reactive: r = 1 where what joins or leaves has no velocity, so that there is a
   reactive force; r = 0 where it has the body's, as what leaks out. To first order in m' and b:
     A/A0 = (m0/m)^((2r-1)/(alpha+3)) exp(-2 damping/(alpha+3))      [(325), (344), (367), (389) corrected]
   All three averaging methods give it, once (335)'s sign is mended. */
VM_API vm_real vm_osc_amplitude_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    if (!vmi_osc_law_is_in_domain(mass_ratio, damping, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (1 - 2 * reactive) / (alpha + 3)) * vmi_exp(-2 * damping / (alpha + 3), 0);
}

/* Documented with vm_osc_amplitude_law. */
/* xdot_max = sqrt(2 k A^(alpha+1)/((alpha+1) m)): (326), (364), (395) corrected */
VM_API vm_real vm_osc_velocity_law(vm_real mass_ratio, vm_real damping, vm_real reactive, vm_real alpha)
{
    vm_real share = (alpha + 1) / (alpha + 3);
    if (!vmi_osc_law_is_in_domain(mass_ratio, damping, reactive, alpha)) return VM_NAN;
    return vmi_pow_checked(mass_ratio, (share * (1 - 2 * reactive) - 1) / 2) * vmi_exp(-share * damping, 0);
}

VM_API vm_real vm_slow_mass_linear(vm_real t, vm_real *rate, void *linear_mass)
{
    if (!rate || !linear_mass) return VM_NAN;
    const vm_linear_mass *m = (const vm_linear_mass *)linear_mass;
    *rate = m->rate;
    return m->mass + m->rate * t;
}

/* The mass at t; VM_BAD_ARGUMENT where there is no law, VM_BAD_MASS, VM_NOT_FINITE */
VM_API int vmi_slow_mass(vm_slow_mass law, void *ctx, vm_real t, vm_real *mass, vm_real *rate)
{
    if (!law) return VM_BAD_ARGUMENT;
    *mass = law(t, rate, ctx);
    if (!VM_IS_FINITE(*mass) || !VM_IS_FINITE(*rate)) return VM_NOT_FINITE;
    return *mass > 0 ? VM_OK : VM_BAD_MASS;
}

/* ln(m/m0) and the integral of dt/m for the linear mass, smooth through m' = 0; 0 where a mass is not positive */
VM_API int vmi_slow_linear(vm_linear_mass m, vm_real t, vm_real *ln_ratio, vm_real *integral)
{
    const vm_real growth = m.rate * t / m.mass;
    vm_real mean;
    if (!(m.mass > 0) || !(growth > -1) || !VM_IS_FINITE(m.mass) || !VM_IS_FINITE(growth)) return 0;
    mean = vmi_log_ratio(growth); /* of m0/m */
    *ln_ratio = growth * mean;
    *integral = t / m.mass * mean;
    return 1;
}

/* Om, the rate of the Ateb phase; 0 at rest, where it may be infinite */
VM_API vm_real vmi_slow_rate(vm_real A, vm_real k, vm_real mass, vm_real alpha)
{
    return A == 0 && alpha < 1 ? 0 : vmi_osc_rate(A, VM_SQRT(k / mass), alpha);
}

/* x = A ca(psi), x' = -vmax(A) sa(psi), and back */
VM_API void vmi_slow_motion(vm_real A, vm_real psi, vm_real k, vm_real mass, vm_real alpha, vm_real *x, vm_real *v)
{
    vmi_osc_at_phase(A, psi, VM_SQRT(k / mass), alpha, x, v);
}

VM_API void vmi_slow_phase(vm_real x, vm_real v, vm_real k, vm_real mass, vm_real alpha, vm_real *A, vm_real *psi)
{
    vm_osc_amplitude_phase(x, v, VM_SQRT(k / mass), alpha, A, psi);
}

#endif
/* oscillators/van_der_pol.h - the Van der Pol oscillator with variable mass */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_H

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

VM_API int vm_vdp_init(vm_vdp *v)
{
    vm_real C2, C4, C6, m;
    if (!v || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(v->alpha) || !VM_IS_FINITE(v->k) || !VM_IS_FINITE(v->b) || !VM_IS_FINITE(v->c) ||
        !VM_IS_FINITE(v->reactive))
        return VM_NOT_FINITE;
    if (!(v->alpha >= 0) || !(v->k > 0)) return VM_DOMAIN;
    v->a1 = 1;
    v->a2 = 2 / (v->alpha + 3);
    if (v->method == VM_VDP_ATEB) v->a3 = 2 / (v->alpha + 1) * ateb_mean(v->alpha, 2, 2);
    if (v->method == VM_VDP_TRIGONOMETRIC) v->a3 = v->a2 / 4;
    if (v->method != VM_VDP_JACOBI) return VM_OK;
    m = vm_osc_jacobi_parameter(v->alpha);
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

/* Amplitude at t where it was first_A at t = 0 and the mass is m.mass + m.rate t > 0; m.rate may be 0: (422), (424),
   (427), (429), (431)-(435), (437) in one, as corrected, smooth through q = 0. Right to 1e-14 but for what is
   averaged. c < 0 may carry it to infinity in a finite time: NaN from there on. */
/* 1/A^2 = e^-F (1/first_A^2 + 2 c a3/a1 int e^F dt/m) (416). F = drive a2/a1 int dt/m is linear in int dt/m where m' is
   constant, so that the integral is phi(F) int dt/m. Written with e^-|F| and the larger of the two terms taken out.
   */
VM_API vm_real vm_vdp_amplitude(const vm_vdp *v, vm_real t, vm_real first_A, vm_linear_mass m)
{
    if (!v) return VM_NAN;
    vm_real ln_ratio, integral, F, damping, root, e, s, denominator;
    if (!VM_IS_FINITE(first_A) || !(v->a1 > 0) || !vmi_slow_linear(m, t, &ln_ratio, &integral)) return VM_NAN;
    F = vmi_vdp_drive(v, 0) * (v->a2 / v->a1) * integral - (2 * v->reactive - 1) * (v->a2 / v->a1) * ln_ratio;
    e = vmi_exp(-VM_FABS(F), 0);
    damping = 2 * v->c * (v->a3 / v->a1) * integral * vmi_exp_ratio(-VM_FABS(F));
    root = VM_SQRT(VM_FABS(damping));
    s = VM_FABS(first_A) * root; /* squared, and with damping's sign, beside 1 or e^-|F| */
    if (s > 1) {
        denominator = (F > 0 ? e / s : 1 / s) / s + VM_COPYSIGN(1, damping);
        first_A = VM_COPYSIGN(1 / root, first_A);
    } else {
        denominator = (F > 0 ? e : 1) + VM_COPYSIGN(s * s, damping);
    }
    return denominator < 0 ? VM_NAN : first_A * VM_SQRT((F > 0 ? 1 : e) / denominator);
}

/* The amplitude other than 0 that stays while the mass changes at mass_rate, (425), (430), (438); 0 where there is
   none. stable, where not null: whether the amplitudes around tend to the one returned. */
VM_API vm_real vm_vdp_limit_cycle(const vm_vdp *v, vm_real mass_rate, int *stable_or_NULL)
{
    if (!v) return VM_NAN;
    const vm_real drive = vmi_vdp_drive(v, mass_rate);
    const int exists = (drive > 0 && v->c > 0) || (drive < 0 && v->c < 0);
    if (!VM_IS_FINITE(drive) || !(v->a1 > 0)) return VM_NAN;
    if (stable_or_NULL) *stable_or_NULL = exists ? v->c > 0 : drive < 0 || (drive == 0 && v->c > 0);
    return exists ? VM_SQRT(drive / v->c * (v->a2 / (2 * v->a3))) : 0;
}

/* Equations for rk45 or rk87, ctx a vm_vdp: of motion, y = (x, x') (404); averaged, y = (A, psi), any mass (410),
   where x = A ca(psi). They return a status of this header, which stops the run, where the mass is not positive. */
VM_API int vm_vdp_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_slow_mass(v->mass, v->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[1];
    dydt[1] = ((v->b - v->c * y[0] * y[0] - v->reactive * rate) * y[1] - v->k * vmi_osc_elastic(y[0], v->alpha)) /
              mass;
    return VM_OK;
}

/* Documented with vm_vdp_rhs. */
VM_API int vm_vdp_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate;
    const int status = vmi_slow_mass(v->mass, v->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[0] / (v->a1 * mass) * (vmi_vdp_drive(v, rate) * v->a2 / 2 - v->c * y[0] * y[0] * v->a3);
    dydt[1] = vmi_slow_rate(y[0], v->k, mass, v->alpha);
    return VM_OK;
}

#endif
/* oscillators/jeffcott.h - the Jeffcott (Laval) rotor with variable mass */
#ifndef VARMASS_OSCILLATORS_JEFFCOTT_H
#define VARMASS_OSCILLATORS_JEFFCOTT_H

/* The disc's centre z = x + i y (451), with the shaft's stiffness F_e(rho)/rho, which [1] calls F_e', and the
   gyroscopic constant g = Omega_p g of the remark after (516):
     m z'' + z F_e(|z|)/|z| - 2 i g z' = F_z + r m' (u - z')
   A zero field means none; mass and stiffness must be there. */
/* F_e(rho)/rho, N/m, and its derivative, for rho >= 0. vm_jeffcott_power is k rho^(alpha-1), ctx a vm_power_force. */
typedef vm_real (*vm_jeffcott_stiffness)(vm_real rho, vm_real *slope, void *ctx);
typedef vm_complex (*vm_jeffcott_force)(vm_real t, vm_complex z, vm_complex v, void *ctx);

typedef struct VM_TAG(vm_power_force) {
    vm_real k, alpha;
} vm_power_force;

typedef struct VM_TAG(vm_jeffcott) {
    vm_slow_mass mass;
    void *mass_ctx;
    vm_jeffcott_stiffness stiffness;
    void *stiffness_ctx;
    vm_jeffcott_force force; /* F_z, N; small where averaged */
    void *force_ctx;
    vm_real gyro;     /* kg/s */
    vm_real reactive; /* r */
    vm_complex u;     /* absolute velocity of what joins or leaves, m/s */
    int samples;      /* of a period in an average; default 32, enough for polynomials of degree 15 */
} vm_jeffcott;

VM_API vm_real vm_jeffcott_power(vm_real rho, vm_real *slope, void *power_force)
{
    if (!slope || !power_force) return VM_NAN;
    const vm_power_force *p = (const vm_power_force *)power_force;
    *slope = p->alpha == 1 ? 0 : p->k * (p->alpha - 1) * vmi_pow_checked(rho, p->alpha - 2);
    return p->k * vmi_pow_checked(rho, p->alpha - 1);
}

/* rho and phi in (-pi, pi] (448) */
VM_API void vm_jeffcott_polar(vm_complex z, vm_real *rho, vm_real *phi)
{
    if (!rho || !phi) return;
    *rho = vmi_c_modulus(z);
    *phi = ateb_phase(z.im, z.re, 1);
}

/* Angular momentum Im(conj z m z') - g |z|^2, kg m^2/s: constant where r = 1, u = 0, F_z = 0 */
VM_API vm_real vm_jeffcott_momentum(const vm_jeffcott *r, vm_real mass, vm_complex z, vm_complex v)
{
    if (!r) return VM_NAN;
    return mass * (z.re * v.im - z.im * v.re) - r->gyro * (z.re * z.re + z.im * z.im);
}

/* F_e(rho)/rho, NaN where there is none */
VM_API vm_real vmi_jeffcott_stiffness(const vm_jeffcott *r, vm_real rho, vm_real *slope)
{
    *slope = VM_NAN;
    return r->stiffness ? r->stiffness(rho, slope, r->stiffness_ctx) : VM_NAN;
}

/* F_z + r m' u */
VM_API vm_complex vmi_jeffcott_drive(const vm_jeffcott *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    const vm_complex thrust = vmi_c_scale(r->reactive * rate, r->u);
    return r->force ? vmi_c_add(r->force(t, z, v, r->force_ctx), thrust) : thrust;
}

/* Equations of motion (449), (450) for rk45 or rk87, ctx a vm_jeffcott, y = (x, y, x', y') */
VM_API int vm_jeffcott_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    const vm_complex z = vmi_complex(y[0], y[1]), v = vmi_complex(y[2], y[3]);
    vm_real mass, rate, stiffness, slope;
    vm_complex force;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &mass, &rate);
    if (status) return status;
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    stiffness = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope);
    force = vmi_c_add(vmi_jeffcott_drive(r, t, rate, z, v), vmi_c_times_i(2 * r->gyro, v));
    dydt[0] = v.re;
    dydt[1] = v.im;
    dydt[2] = (force.re - r->reactive * rate * v.re - stiffness * z.re) / mass;
    dydt[3] = (force.im - r->reactive * rate * v.im - stiffness * z.im) / mass;
    return VM_OK;
}

typedef struct VM_TAG(vmi_jeffcott_state) {
    vm_real mass, rate, omega; /* omega of the small vibration */
} vmi_jeffcott_state;

VM_API int vmi_jeffcott_now(const vm_jeffcott *r, vm_real t, vmi_jeffcott_state *now)
{
    vm_real slope;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &now->mass, &now->rate);
    if (status) return status;
    now->omega = VM_SQRT(vmi_jeffcott_stiffness(r, 0, &slope) / now->mass);
    return now->omega > 0 && VM_IS_FINITE(now->omega) ? VM_OK : VM_DOMAIN;
}

/* Small nonlinearity: two circular motions (460), (461) of the frequency omega = sqrt(F_e'(0)/m),
     z = P e^(i phi) + N e^(-i phi),  z' = i omega (P e^(i phi) - N e^(-i phi)),
     P = A1 e^(i theta1),  N = A2 e^(-i theta2),
   y = (Re P, Im P, Re N, Im N, phi), phi' = omega, from and to y = (x, y, x', y') at time t. The equations
   (470)-(473) exactly, and averaged over phi while P and N stay: forward and backward motion are in 1:1 resonance,
   so that the average over psi1 and psi2 apart, (474)-(477), is wrong unless f turns with z. In P and N nothing is
   singular where A1 or A2 is 0. All that differs from m z'' + F_e'(0) z = 0 is perturbation: F_z, u, g, F_e'(rho) -
   F_e'(0). */
VM_API int vm_jeffcott_to_averaged(const vm_jeffcott *r, vm_real t, const vm_real *motion, vm_real phi, vm_real *y)
{
    if (!r || !motion || !y) return VM_BAD_ARGUMENT;
    const vm_complex z = vmi_complex(motion[0], motion[1]), back = vmi_c_turn(-phi);
    vmi_jeffcott_state now;
    vm_complex turned, P, N;
    vm_real found[5];
    const int status = vmi_jeffcott_now(r, t, &now);
    if (status) return status;
    turned = vmi_c_times_i(-1 / now.omega, vmi_complex(motion[2], motion[3])); /* z'/(i omega) */
    P = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_add(z, turned)), back);
    N = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_sub(z, turned)), vmi_c_conjugate(back));
    found[0] = P.re;
    found[1] = P.im;
    found[2] = N.re;
    found[3] = N.im;
    found[4] = phi;
    return vmi_copy_if_finite(5, found, y);
}

/* z and z' where phi is the angle of turn */
VM_API void vmi_jeffcott_motion(const vm_real *y, vm_complex turn, vm_real omega, vm_complex *z, vm_complex *v)
{
    const vm_complex P = vmi_c_times(vmi_complex(y[0], y[1]), turn);
    const vm_complex N = vmi_c_times(vmi_complex(y[2], y[3]), vmi_c_conjugate(turn));
    *z = vmi_c_add(P, N);
    *v = vmi_c_times_i(omega, vmi_c_sub(P, N));
}

/* Documented with vm_jeffcott_to_averaged. */
VM_API int vm_jeffcott_from_averaged(const vm_jeffcott *r, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!r || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_jeffcott_state now;
    vm_complex z, v;
    vm_real joined[4];
    const int status = vmi_jeffcott_now(r, t, &now);
    if (status) return status;
    vmi_jeffcott_motion(y, vmi_c_turn(y[4]), now.omega, &z, &v);
    joined[0] = z.re;
    joined[1] = z.im;
    joined[2] = v.re;
    joined[3] = v.im;
    return vmi_copy_if_finite(4, joined, motion);
}

/* P' and N' (470)-(473) at the fast phase phi:
     P' = -i e^(-i phi) f/(2 omega),  N' = i e^(i phi) f/(2 omega),
     m f = F + 2 i g z' - (F_e' - F_e'(0)) z - (r - 1/2) m' z'
   F with r m' u; the half that is missing from r comes from omega'. */
VM_API void vmi_jeffcott_rates(const vm_jeffcott *r, vm_real t, const vmi_jeffcott_state *now, const vm_real *y, vm_real phi,
                            vm_complex *dP, vm_complex *dN)
{
    const vm_complex turn = vmi_c_turn(phi);
    const vm_real push = 1 / (2 * now->omega * now->mass);
    vm_real slope, extra;
    vm_complex z, v, f;
    vmi_jeffcott_motion(y, turn, now->omega, &z, &v);
    extra = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope) - now->mass * now->omega * now->omega;
    f = vmi_c_add(vmi_jeffcott_drive(r, t, now->rate, z, v), vmi_c_times_i(2 * r->gyro, v));
    f = vmi_c_sub(f, vmi_c_add(vmi_c_scale(extra, z), vmi_c_scale((r->reactive - VM_C(0.5)) * now->rate, v)));
    *dP = vmi_c_times_i(-push, vmi_c_times(f, vmi_c_conjugate(turn)));
    *dN = vmi_c_times_i(push, vmi_c_times(f, turn));
}

VM_API int vmi_jeffcott_samples(const vm_jeffcott *r) { return r->samples > 0 ? r->samples : 32; }

/* The mean of so many samples in a period from y[4] on */
VM_API int vmi_jeffcott_mean(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int samples)
{
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    const vm_real share = 1 / (vm_real)samples;
    vm_complex P = {0, 0}, N = {0, 0}, dP, dN;
    vmi_jeffcott_state now;
    const int status = vmi_jeffcott_now(r, t, &now);
    int j;
    if (status) return status;
    for (j = 0; j < samples; j++) {
        vmi_jeffcott_rates(r, t, &now, y, y[4] + 2 * VM_PI * share * (vm_real)j, &dP, &dN);
        P = vmi_c_add(P, dP);
        N = vmi_c_add(N, dN);
    }
    dydt[0] = P.re * share;
    dydt[1] = P.im * share;
    dydt[2] = N.re * share;
    dydt[3] = N.im * share;
    dydt[4] = now.omega;
    return VM_OK;
}

/* Documented with vm_jeffcott_to_averaged. */
VM_API int vm_jeffcott_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_mean(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Documented with vm_jeffcott_to_averaged. */
VM_API int vm_jeffcott_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    return vmi_jeffcott_mean(t, y, dydt, r, vmi_jeffcott_samples(r));
}

/* W = (g +- S)/m, S^2 = g^2 + m F_e', without the difference of near numbers */
VM_API vm_real vmi_jeffcott_root(vm_real gyro, vm_real mass, vm_real stiffness, int sense)
{
    const vm_real forward = sense < 0 ? -1 : 1, g = forward * gyro, S = VM_SQRT(gyro * gyro + mass * stiffness);
    return forward * (g > 0 ? (g + S) / mass : stiffness / (S - g));
}

/* Strong nonlinearity: nearly circular motion z = A e^(i psi), z' = i W z, of the frequency W of m W^2 - 2 g W =
   F_e'(A), forward (sense >= 0) or backward. Averaged equations (506), (507) with g, y = (A, psi). A errs by the
   order of the loads over times of their inverse; the phase adds that up where F_e' is not constant: 0.005 were
   measured for loads that turn with z, order 1 for others. Not for a linear F_e with loads that do not turn with z:
   they send the motion off the circle. */
VM_API vm_real vm_jeffcott_frequency(const vm_jeffcott *r, vm_real A, vm_real mass, int sense)
{
    if (!r || !r->stiffness) return VM_NAN;
    vm_real slope;
    if (!(A >= 0) || !VM_IS_FINITE(A) || !(mass > 0) || !VM_IS_FINITE(mass)) return VM_NAN;
    return vmi_jeffcott_root(r->gyro, mass, vmi_jeffcott_stiffness(r, A, &slope), sense);
}

/* (504), (505) averaged. The torque gives (A^2 (m W - g))' = (1 - r) m' A^2 W + A <Im D>, the radial balance
   psi' - W = -<Re D>/(2 A (m W - g)), D = (F_z + r m' u) e^(-i psi); m W - g = +-S, S^2 = g^2 + m F_e'. */
VM_API int vmi_jeffcott_circular(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int sense)
{
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    const int samples = vmi_jeffcott_samples(r);
    vm_real mass, rate, stiffness, slope, W, S, growth;
    vm_complex sum = {0, 0};
    int j;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &mass, &rate);
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, y[0], &slope);
    W = vmi_jeffcott_root(r->gyro, mass, stiffness, sense);
    S = mass * W - r->gyro;
    if (!(S * S > 0)) return VM_DOMAIN;
    for (j = 0; j < samples; j++) {
        const vm_complex turn = vmi_c_turn(y[1] + 2 * VM_PI * (vm_real)j / (vm_real)samples),
                         z = vmi_c_scale(y[0], turn);
        const vm_complex D = vmi_jeffcott_drive(r, t, rate, z, vmi_c_times_i(W, z));
        sum = vmi_c_add(sum, vmi_c_times(D, vmi_c_conjugate(turn)));
    }
    sum = vmi_c_scale(1 / (vm_real)samples, sum);
    growth = ((1 - r->reactive) * rate * W + sum.im / y[0]) / S - rate * stiffness / (2 * S * S);
    dydt[0] = y[0] * growth / (2 + mass * slope * y[0] / (2 * S * S));
    dydt[1] = W - sum.re / (2 * y[0] * S);
    return VM_OK;
}

/* Documented with vm_jeffcott_frequency. */
VM_API int vm_jeffcott_forward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Documented with vm_jeffcott_frequency. */
VM_API int vm_jeffcott_backward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, -1);
}

/* ln of the invariant over its first value at the radius first_A e^x */
typedef struct VM_TAG(vmi_jeffcott_orbit) {
    const vm_jeffcott *r;
    vm_real first_A, mass, first; /* first: that of g^2 + m F_e' */
} vmi_jeffcott_orbit;

VM_API vm_real vmi_jeffcott_invariant(vm_real x, void *orbit)
{
    const vmi_jeffcott_orbit *o = (const vmi_jeffcott_orbit *)orbit;
    vm_real slope;
    const vm_real stiffness = vmi_jeffcott_stiffness(o->r, o->first_A * vmi_exp(x, 0), &slope);
    const vm_real ratio = (o->r->gyro * o->r->gyro + o->mass * stiffness) / o->first;
    return ratio > 0 && VM_IS_FINITE(ratio) ? 4 * x + vmi_log(ratio).hi : VM_NAN;
}

/* The same without F_z: the radius when the mass has gone from mass0, where it was first_A, to mass, of
     A^4 (g^2 + m F_e'(A)) = const, r = 1, which is A^2 (m W - g) = const;  A^4 F_e'(A) m^(2r-1) = const, g = 0 (509)
   NaN for g != 0 and r != 1, where the course of the mass matters, and where no radius is found going from
   first_A. For powers it is first_A vm_osc_amplitude_law(mass/mass0, 0, r, alpha). */
VM_API vm_real vm_jeffcott_amplitude(const vm_jeffcott *r, vm_real first_A, vm_real mass0, vm_real mass)
{
    if (!r || !r->stiffness) return VM_NAN;
    vmi_jeffcott_orbit o;
    vm_real slope, here, there, step = VM_C(0.0625), x = 0;
    int bounded = 0;
    if (!(first_A > 0) || !(mass0 > 0) || !(mass > 0) || !VM_IS_FINITE(first_A) || !VM_IS_FINITE(mass0) ||
        !VM_IS_FINITE(mass) || (r->gyro != 0 && r->reactive != 1))
        return VM_NAN;
    if (r->gyro == 0) {
        mass = vmi_pow_checked(mass / mass0, 2 * r->reactive - 1);
        mass0 = 1;
    }
    o.r = r;
    o.first_A = first_A;
    o.mass = mass;
    o.first = r->gyro * r->gyro + mass0 * vmi_jeffcott_stiffness(r, first_A, &slope);
    here = vmi_jeffcott_invariant(0, &o);
    if (here == 0 || here != here) return here == 0 ? first_A : VM_NAN;
    for (step = here > 0 ? -step : step;; step = bounded ? step : 2 * step) { /* outward to a change of sign */
        there = vmi_jeffcott_invariant(x + step, &o);
        while (there != there) { /* F_e' is no number there */
            step /= 2;
            bounded = 1;
            if (VM_FABS(step) < VM_EPSILON * (1 + VM_FABS(x))) return VM_NAN;
            there = vmi_jeffcott_invariant(x + step, &o);
        }
        if (there == 0 || (there > 0) != (here > 0)) break;
        x += step;
        here = there;
    }
    return first_A * vmi_exp(vmi_find_zero(vmi_jeffcott_invariant, &o, x, x + step, here, there), 0);
}

#endif
/* oscillators/pair.h - two bodies with a nonlinear connection */
#ifndef VARMASS_OSCILLATORS_PAIR_H
#define VARMASS_OSCILLATORS_PAIR_H

/* Equal masses m with k (x - y)|x - y|^(alpha-1) between them, and -r m' x', -r m' y' (517), (518). y = (x, y, x',
   y'). */
typedef struct VM_TAG(vm_pair) {
    vm_real alpha, k, reactive; /* alpha >= 0; k > 0 N/m^alpha; r */
    vm_slow_mass mass;          /* not needed by vm_pair_at */
    void *mass_ctx;
} vm_pair;

VM_API int vm_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    const vm_real force = p->k * vmi_osc_elastic(y[0] - y[1], p->alpha);
    vm_real mass, rate;
    const int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (status) return status;
    dydt[0] = y[2];
    dydt[1] = y[3];
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
    return p->alpha >= 0 && p->k > 0 ? VM_OK : VM_DOMAIN;
}

/* A over its mean at phase psi, (1 + q sa ca/(2 Om))^(2/(alpha+3)), q = (2r-1) m'/m, Om at the mean A */
VM_API vm_real vmi_pair_ripple(const vm_pair *p, vm_real mass, vm_real rate, vm_real A, vm_real psi)
{
    const vm_real q = (2 * p->reactive - 1) * rate / mass, Om = vmi_slow_rate(A, 2 * p->k, mass, p->alpha);
    vm_real sa, ca;
    ateb_saca(psi, p->alpha, &sa, &ca);
    return vmi_pow_checked(1 + q / (2 * Om) * sa * ca, 2 / (p->alpha + 3));
}

VM_API int vmi_pair_split(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *y, vm_real *modes)
{
    vm_real exact, A, found[4];
    int i;
    if (!vmi_all_finite(4, y)) return VM_NOT_FINITE;
    vmi_slow_phase(y[1] - y[0], y[3] - y[2], 2 * p->k, mass, p->alpha, &exact, &found[1]);
    A = exact;
    for (i = 0; i < 3 && exact > 0; i++) A = exact / vmi_pair_ripple(p, mass, rate, A, found[1]);
    if (exact > 0 && !(VM_FABS(A * vmi_pair_ripple(p, mass, rate, A, found[1]) - exact) <= exact / 8))
        return VM_DOMAIN; /* the ripple is as large as the motion: its equation is not solved */
    if (!(A >= 0) || !VM_IS_FINITE(A)) return VM_DOMAIN;
    found[0] = A;
    found[2] = y[0] + y[1];
    found[3] = y[2] + y[3];
    return vmi_copy_if_finite(4, found, modes);
}

VM_API int vmi_pair_join(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *modes, vm_real *y)
{
    const vm_real q = modes[2], dq = modes[3];
    vm_real A = modes[0], x, v, joined[4];
    if (!vmi_all_finite(4, modes)) return VM_NOT_FINITE;
    if (A > 0) A *= vmi_pair_ripple(p, mass, rate, A, modes[1]);
    if (!(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, modes[1], 2 * p->k, mass, p->alpha, &x, &v);
    joined[0] = (q - x) / 2;
    joined[1] = (q + x) / 2;
    joined[2] = (dq - v) / 2;
    joined[3] = (dq + v) / 2;
    return vmi_copy_if_finite(4, joined, y);
}

/* q = x + y drifts, p = y - x vibrates (520)-(522): modes = (A, psi, q, q') with A the mean amplitude of p, free of
   first ripple, so that any initial velocities do. VM_DOMAIN where the ripple is as large as the motion,
   |(2r - 1) m'/m| some 2 Omega, as it is where m -> 0. Averaged equations of the modes for any mass. */
VM_API int vm_pair_to_averaged(const vm_pair *p, vm_real t, const vm_real *y, vm_real *modes)
{
    if (!p || !y || !modes) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (!status) status = vmi_pair_check(p, mass, rate);
    return status ? status : vmi_pair_split(p, mass, rate, y, modes);
}

/* Documented with vm_pair_to_averaged. */
VM_API int vm_pair_from_averaged(const vm_pair *p, vm_real t, const vm_real *modes, vm_real *y)
{
    if (!p || !modes || !y) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    int status = vmi_slow_mass(p->mass, p->mass_ctx, t, &mass, &rate);
    if (!status) status = vmi_pair_check(p, mass, rate);
    return status ? status : vmi_pair_join(p, mass, rate, modes, y);
}

/* Documented with vm_pair_to_averaged. */
VM_API int vm_pair_averaged_rhs(vm_real t, const vm_real *modes, vm_real *dmodes, void *pair)
{
    if (!modes || !dmodes || !pair) return VM_BAD_ARGUMENT;
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

/* y at t where it was y0 at t = 0, for the mass m.mass + m.rate t, closed: (528), (529) with p0 = y0 - x0. Error of
   order m.rate over times of order 1/m.rate; VM_DOMAIN as above, at either end. y may be y0. */
/* Powers of m/m0 integrate to int (m/m0)^e dt = m0 phi((1 + e) ln(m/m0)) int dt/m */
VM_API int vm_pair_at(const vm_pair *p, vm_real t, const vm_real *y0, vm_linear_mass m, vm_real *y)
{
    if (!p || !y0 || !y) return VM_BAD_ARGUMENT;
    const vm_real drift = (2 * p->reactive - 1) / (p->alpha + 3);
    vm_real modes[4], ln_ratio, integral, rate0, exponent;
    int status = vmi_pair_check(p, m.mass, m.rate);
    if (!status) status = vmi_pair_split(p, m.mass, m.rate, y0, modes);
    if (status) return status;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!vmi_slow_linear(m, t, &ln_ratio, &integral)) return VM_BAD_MASS;
    rate0 = vmi_slow_rate(modes[0], 2 * p->k, m.mass, p->alpha);
    exponent = VM_C(0.5) - (p->alpha - 1) / 2 * drift;
    modes[1] += rate0 * m.mass * integral * vmi_exp_ratio(exponent * ln_ratio);
    modes[0] *= vmi_exp(-drift * ln_ratio, 0);
    modes[2] += modes[3] * m.mass * integral * vmi_exp_ratio((1 - p->reactive) * ln_ratio);
    modes[3] *= vmi_exp(-p->reactive * ln_ratio, 0);
    return vmi_pair_join(p, m.mass + m.rate * t, m.rate, modes, y);
}

#endif
/* oscillators/forced.h - harmonic excitation */
#ifndef VARMASS_OSCILLATORS_FORCED_H
#define VARMASS_OSCILLATORS_FORCED_H

/* m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + force cos theta, theta' = nu, where m, k, nu, force may drift slowly:
   now holds them at all times, or drift, where not null, gets it so and changes what drifts. vm_forced_init checks
   alpha, b, reactive and now at t = 0, and prepares what the averaged functions need: call it first, and again
   when alpha is another. now, b and reactive may change without. */
typedef struct VM_TAG(vm_forced_parameters) {
    vm_real mass, mass_rate; /* kg, kg/s */
    vm_real k, k_rate;       /* N/m^alpha, per s */
    vm_real nu, nu_rate;     /* rad/s, rad/s^2 */
    vm_real force;           /* N */
} vm_forced_parameters;

typedef struct VM_TAG(vm_forced) {
    vm_real alpha, b, reactive; /* alpha >= 0; kg/s; r */
    vm_forced_parameters now;
    void (*drift)(vm_real t, vm_forced_parameters *now, void *ctx);
    void *drift_ctx;
    vm_real pi, Om1, G; /* Pi_alpha, w = Om1 sqrt(k/m) A^((alpha-1)/2), the force's share; by vm_forced_init */
    vm_real c[5], s[5]; /* ca = sum c[j] cos((2j+1) pi psi/Pi), sa = sum s[j] sin(...), j = 0 .. */
} vm_forced;

VM_API vm_forced_parameters vmi_forced_at(const vm_forced *f, vm_real t)
{
    vm_forced_parameters now = f->now;
    if (f->drift) f->drift(t, &now, f->drift_ctx);
    return now;
}

VM_API int vmi_forced_check(const vm_forced_parameters *n)
{
    if (!VM_IS_FINITE(n->mass) || !VM_IS_FINITE(n->mass_rate) || !VM_IS_FINITE(n->k) || !VM_IS_FINITE(n->k_rate) ||
        !VM_IS_FINITE(n->nu) || !VM_IS_FINITE(n->nu_rate) || !VM_IS_FINITE(n->force))
        return VM_NOT_FINITE;
    if (!(n->mass > 0)) return VM_BAD_MASS;
    return n->k > 0 && n->nu > 0 ? VM_OK : VM_DOMAIN;
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
        before = c;
        twice = 2 * (c - sine) * (c + sine);
        total += weight;
        for (j = 0; j < 5; j++) {
            const vm_real next = twice * c - before;
            sum[j] += weight * ca * c;
            before = c;
            c = next;
        }
    }
    for (j = 0; j < 5; j++) {
        f->c[j] = 2 * sum[j] / total;
        f->s[j] = (f->alpha + 1) * (vm_real)(2 * j + 1) * VM_PI / (2 * f->pi) * f->c[j];
    }
}

VM_API int vm_forced_init(vm_forced *f)
{
    vm_forced_parameters now;
    int status;
    if (!f) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(f->alpha) || !VM_IS_FINITE(f->b) || !VM_IS_FINITE(f->reactive)) return VM_NOT_FINITE;
    if (!(f->alpha >= 0)) return VM_DOMAIN;
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
VM_API vm_real vmi_forced_q(const vm_forced *f, const vm_forced_parameters *n)
{
    return ((2 * f->reactive - 1) * n->mass_rate + 2 * f->b) / n->mass + n->k_rate / n->k;
}

VM_API vm_real vmi_forced_natural(const vm_forced *f, const vm_forced_parameters *n, vm_real A) /* w(A) */
{
    return f->Om1 * VM_SQRT(n->k / n->mass) * vmi_pow_checked(VM_FABS(A), (f->alpha - 1) / 2);
}

/* Equations for rk45 or rk87, ctx a vm_forced: of motion, y = (x, x', theta); the same in amplitude and Ateb phase,
   exactly, y = (A, psi, theta), singular at A = 0; averaged near the main resonance nu = w(A), y = (A, delta,
   theta), where delta is the phase before the force. The averaged ones err by the order of b, m' and force over
   times of their inverses, off the resonance by more. */
VM_API int vm_forced_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    vm_real sine, cosine;
    const int status = vmi_forced_check(&n);
    if (status) return status;
    vmi_sincos(y[2], &sine, &cosine);
    dydt[0] = y[1];
    dydt[1] = (n.force * cosine - (f->reactive * n.mass_rate + f->b) * y[1] -
               n.k * vmi_osc_elastic(y[0], f->alpha)) /
              n.mass;
    dydt[2] = n.nu;
    return VM_OK;
}

/* Documented with vm_forced_rhs. */
VM_API int vm_forced_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
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

/* Documented with vm_forced_rhs. */
VM_API int vm_forced_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *forced)
{
    if (!y || !dydt || !forced) return VM_BAD_ARGUMENT;
    const vm_forced *f = (const vm_forced *)forced;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
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

/* R, the first ripple of the exact amplitude about its mean A: psi the Ateb phase, phi = pi psi/Pi that in radians */
VM_API vm_real vmi_forced_ripple(const vm_forced *f, const vm_forced_parameters *n, vm_real A, vm_real phi, vm_real theta)
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

/* (x, x', theta) to the mean (A, delta, theta), and back, at time t. The ripple of the amplitude is taken out and put
   back: without that the error is of order 1 where alpha != 1. */
VM_API int vm_forced_to_averaged(const vm_forced *f, vm_real t, const vm_real *motion, vm_real *y)
{
    if (!f || !motion || !y) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    const vm_real theta = motion[2];
    vm_real exact, A, phi;
    int i;
    if (status) return status;
    if (!vmi_all_finite(3, motion)) return VM_NOT_FINITE;
    vmi_slow_phase(motion[0], motion[1], n.k, n.mass, f->alpha, &exact, &phi);
    phi *= VM_PI / f->pi;
    A = exact;
    for (i = 0; i < 3; i++) A = exact - vmi_forced_ripple(f, &n, A, phi, theta);
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_DOMAIN; /* the motion is smaller than its ripple */
    y[0] = A;
    y[1] = phi - theta;
    y[2] = theta;
    return VM_OK;
}

/* Documented with vm_forced_to_averaged. */
VM_API int vm_forced_from_averaged(const vm_forced *f, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!f || !y || !motion) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    const vm_real theta = y[2], phi = y[1] + theta;
    vm_real A, r[3];
    if (status) return status;
    if (!vmi_all_finite(3, y)) return VM_NOT_FINITE;
    A = y[0] + vmi_forced_ripple(f, &n, y[0], phi, theta);
    if (!(y[0] > 0) || !(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, phi * (f->pi / VM_PI), n.k, n.mass, f->alpha, &r[0], &r[1]);
    r[2] = theta;
    return vmi_copy_if_finite(3, r, motion);
}

#endif
/* oscillators/resonance.h - steady vibrations, resonance curves, passage through resonance */
#ifndef VARMASS_OSCILLATORS_RESONANCE_H
#define VARMASS_OSCILLATORS_RESONANCE_H

/* Steady vibrations, all quantities as they are at time t: at most three, their amplitudes growing. The number of
   them, or a negative status. A is the mean amplitude; the waveform, with its ripple, is vm_forced_from_averaged's. For the
   response at each frequency let now.nu run. Those far from w(A) = nu are labels only: the averaged equations hold
   near the resonance. */
typedef struct VM_TAG(vm_steady_state) {
    vm_real nu, A, delta;
    vm_real trace, det; /* of the averaged equations there: rates lambda^2 - trace lambda + det = 0 */
    int stable;         /* det > 0 and trace < 0; det < 0 is a saddle */
} vm_steady_state;

/* Passage through the resonance, all rates as they are at time t. The backbone's amplitude A at nu; torque: the
   drift of w - nu over the force's hold on it, below 1 the vibration may be captured and follow A, with the phase
   delta, above 1 it passes; jump: half the range of the relative change of A in a quick passage, torque >> 1, over
   all phases. For alpha = 1 A cannot be told from nu: it is the amplitude given. */
typedef struct VM_TAG(vm_passage) {
    vm_real A, torque, delta, jump; /* delta NaN where torque > 1 */
} vm_passage;

/* The resonance with all quantities frozen, p = q/(alpha+3) */
typedef struct VM_TAG(vmi_forced_frozen_state) {
    vm_real w1, exponent, nu, p, push; /* w = w1 A^exponent; push = force G/m, signed */
} vmi_forced_frozen_state;

VM_API vmi_forced_frozen_state vmi_forced_freeze(const vm_forced *f, const vm_forced_parameters *n)
{
    vmi_forced_frozen_state z;
    z.w1 = vmi_forced_natural(f, n, 1);
    z.exponent = (f->alpha - 1) / 2;
    z.nu = n->nu;
    z.p = vmi_forced_q(f, n) / (f->alpha + 3);
    z.push = n->force * f->G / n->mass;
    return z;
}

/* ln of A w sqrt((w - nu)^2 + p^2)/|push|, 0 at a steady amplitude A = e^x */
VM_API vm_real vmi_forced_excess(vm_real x, void *frozen)
{
    const vmi_forced_frozen_state *z = (const vmi_forced_frozen_state *)frozen;
    const vm_real w = z->w1 * vmi_exp(z->exponent * x, 0), detuning = vmi_c_modulus(vmi_complex(w - z->nu, z->p));
    if (!(detuning > 0)) return -VM_MAX;
    return (1 + z->exponent) * x + vmi_log(z->w1 / VM_FABS(z->push) * detuning).hi;
}

VM_API vm_steady_state vmi_forced_state(const vmi_forced_frozen_state *z, vm_real alpha, vm_real A)
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

/* The values of x = ln A between which the excess is monotonic: w of det = 0, which is 2 alpha w^2 - (3 alpha + 1)
   nu w + (alpha + 1)(nu^2 + p^2) = 0; their number */
VM_API int vmi_forced_turns(const vmi_forced_frozen_state *z, vm_real alpha, vm_real *x)
{
    const vm_real bend = (alpha - 1) * z->nu, square = bend * bend - 8 * alpha * (alpha + 1) * z->p * z->p;
    const vm_real half = (3 * alpha + 1) * z->nu + (square > 0 ? VM_SQRT(square) : 0);
    int n = 0;
    if (!(square > 0)) return 0; /* so for alpha = 1 */
    x[n++] = vmi_log(2 * (alpha + 1) * (z->nu * z->nu + z->p * z->p) / (half * z->w1)).hi / z->exponent;
    if (alpha > 0) x[n++] = vmi_log(half / (4 * alpha * z->w1)).hi / z->exponent;
    if (n == 2 && x[0] > x[1]) {
        x[2] = x[0];
        x[0] = x[1];
        x[1] = x[2];
    }
    return n;
}

/* The steady amplitudes of alpha != 1: one at most below, between and above the turns */
VM_API int vmi_forced_roots(vmi_forced_frozen_state *z, vm_real alpha, vm_real *A)
{
    const vm_real steep = VM_FABS(z->exponent) > 1 ? VM_FABS(z->exponent) : 1;
    const vm_real reach = -vmi_log(VM_MIN).hi / steep; /* A and w are numbers to there */
    vm_real ends[5], turns[3], left, right;
    int i, n = vmi_forced_turns(z, alpha, turns), found = 0;
    ends[0] = -reach;
    ends[n + 1] = reach;
    for (i = 0; i < n; i++) ends[i + 1] = turns[i] < -reach ? -reach : turns[i] > reach ? reach : turns[i];
    for (i = 0; i <= n; i++) {
        left = vmi_forced_excess(ends[i], z);
        right = vmi_forced_excess(ends[i + 1], z);
        if (!((left > 0) != (right > 0))) continue;
        A[found++] = vmi_exp(vmi_find_zero(vmi_forced_excess, z, ends[i], ends[i + 1], left, right), 0);
    }
    return found;
}

VM_API int vm_forced_steady_states(const vm_forced *f, vm_real t, vm_steady_state steady[3])
{
    if (!f || !steady) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    int i, found = 0;
    const int status = vmi_forced_check(&n);
    vm_real A[3];
    vmi_forced_frozen_state z;
    if (status) return status;
    z = vmi_forced_freeze(f, &n);
    if (z.push == 0) return 0;
    if (f->alpha == 1) {
        A[0] = VM_FABS(z.push) / (z.w1 * vmi_c_modulus(vmi_complex(z.w1 - z.nu, z.p)));
        found = VM_IS_FINITE(A[0]);
    } else found = vmi_forced_roots(&z, f->alpha, A);
    for (i = 0; i < found; i++) steady[i] = vmi_forced_state(&z, f->alpha, A[i]);
    return found;
}

/* The amplitude-frequency curve, traced by its amplitude: the steady vibrations of amplitude A at any nu > 0, the
   backbone w(A) in the middle between two. Their number, 0 where the force is too small for A, or a negative
   status. */
VM_API int vm_forced_curve(const vm_forced *f, vm_real t, vm_real A, vm_steady_state curve[2])
{
    if (!f || !curve) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vmi_forced_frozen_state z;
    vm_real w, hold, width, p;
    int found = 0;
    if (status) return status;
    if (!(A > 0) || !VM_IS_FINITE(A)) return VM_DOMAIN;
    z = vmi_forced_freeze(f, &n);
    w = vmi_forced_natural(f, &n, A);
    hold = VM_FABS(z.push) / (w * A);
    p = VM_FABS(z.p);
    if (!(hold >= p) || z.push == 0) return 0;
    width = VM_SQRT(hold - p) * VM_SQRT(hold + p);
    z.nu = w - width;
    if (z.nu > 0) curve[found++] = vmi_forced_state(&z, f->alpha, A);
    z.nu = w + width;
    if (width > 0) curve[found++] = vmi_forced_state(&z, f->alpha, A); /* NaN: overflow */
    return found;
}

/* The amplitude where the curve meets the backbone, its largest; infinite without damping */
VM_API vm_real vm_forced_peak(const vm_forced *f, vm_real t)
{
    if (!f) return VM_NAN;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    vmi_forced_frozen_state z;
    if (vmi_forced_check(&n)) return VM_NAN;
    z = vmi_forced_freeze(f, &n);
    return vmi_pow_checked(VM_FABS(z.push / z.p) / z.w1, 2 / (f->alpha + 1));
}

/* delta'' = -(gamma push/A) sin delta - nu D, a pendulum under a torque, gamma = (alpha - 1)/2, D the relative
   drift of w - nu; and for gamma = 0 the same jump */
VM_API int vm_forced_passage(const vm_forced *f, vm_real t, vm_real amplitude, vm_passage *passage)
{
    if (!f || !passage) return VM_BAD_ARGUMENT;
    const vm_forced_parameters n = vmi_forced_at(f, t);
    const int status = vmi_forced_check(&n);
    vmi_forced_frozen_state z;
    vm_passage r;
    vm_real D, sine;
    if (status) return status;
    z = vmi_forced_freeze(f, &n);
    r.A = z.exponent == 0 ? amplitude : vmi_pow_checked(z.nu / z.w1, 1 / z.exponent);
    if (!(r.A > 0) || !VM_IS_FINITE(r.A) || z.push == 0) return VM_DOMAIN;
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

#endif
/* oscillators/diagnostics.h - turning points, zero crossings, envelopes */
#ifndef VARMASS_OSCILLATORS_DIAGNOSTICS_H
#define VARMASS_OSCILLATORS_DIAGNOSTICS_H

/* Any trajectory, x(t) and x'(t): a route's, a law's, an integrator's dense output. */
typedef void (*vm_motion_function)(vm_real t, vm_real *x, vm_real *v, void *ctx);

typedef struct VM_TAG(vm_sample) {
    vm_real t, x, v;
} vm_sample;

enum {
    VM_TURNING_POINTS = 0, /* x' = 0 */
    VM_ZERO_CROSSINGS = 1  /* x = 0 */
};

typedef struct VM_TAG(vmi_sample_search) {
    vm_motion_function motion;
    void *ctx;
    int kind;
    vm_real x, v; /* where it was looked last */
} vmi_sample_search;

/* What vanishes at a point of the kind looked for */
VM_API vm_real vmi_sample_function(vm_real t, void *search)
{
    vmi_sample_search *s = (vmi_sample_search *)search;
    s->motion(t, &s->x, &s->v, s->ctx);
    return s->kind == VM_ZERO_CROSSINGS ? s->x : s->v;
}

/* The number of changes of sign in (t0, t1], looked for every step (or a little less; a small part of a period,
   negative where t1 < t0) and located to an eps of t; the first room of them are written. A negative status for a
   step of the wrong sign, or a trajectory that is not finite. */
VM_API long vm_find_samples(vm_motion_function motion, void *ctx, int kind, vm_real t0, vm_real t1, vm_real step, long room,
                           vm_sample *points)
{
    vmi_sample_search s;
    vm_real t = t0, here, there, intervals;
    long found = 0, i = 0, last;
    if (!motion || (room > 0 && !points) || (kind != VM_TURNING_POINTS && kind != VM_ZERO_CROSSINGS))
        return VM_BAD_ARGUMENT;
    intervals = -VM_FLOOR(-(t1 - t0) / step);
    if (!(intervals >= 0) || !(intervals < VM_C(2e9))) return VM_NOT_FINITE;
    last = (long)intervals;
    s.motion = motion;
    s.ctx = ctx;
    s.kind = kind;
    for (here = vmi_sample_function(t0, &s); i < last; here = there) {
        const vm_real before = t;
        i++;
        t = i == last ? t1 : t0 + (t1 - t0) * ((vm_real)i / intervals);
        there = vmi_sample_function(t, &s);
        if (!VM_IS_FINITE(there)) return VM_NOT_FINITE;
        if (here == 0 || !(there == 0 || (there > 0) != (here > 0))) continue;
        if (found < room) {
            points[found].t = vmi_find_zero(vmi_sample_function, &s, before, t, here, there);
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
    const int status = vmi_interpolate(m->s, t, m->buffer);
    *x = status ? VM_NAN : m->buffer[m->x];
    *v = status ? VM_NAN : m->buffer[m->v];
}

/* The same in the last step of an rk45 or rk87, for components x and v of its state; to be called after every step.
   buffer: room for a state. */
VM_API long vm_find_samples_of_step(rk45 *s, int x, int v, int kind, vm_real *buffer, long room, vm_sample *points)
{
    vmi_step_motion m;
    vm_real length;
    if (!s || !buffer || x < 0 || v < 0 || x >= s->n || v >= s->n) return VM_BAD_ARGUMENT;
    length = s->t - s->t_old;
    if (length == 0) return 0;
    m.s = s;
    m.x = x;
    m.v = v;
    m.buffer = buffer;
    return vm_find_samples(vmi_motion_of_step, &m, kind, s->t_old, s->t, length / 4, room, points);
}

/* Largest |law(t)/observed - 1|, observed |x| at turning points, |v| at zero crossings */
VM_API vm_real vm_envelope_error(int kind, long n, const vm_sample *points, vm_real (*law)(vm_real t, void *ctx),
                                 void *ctx)
{
    if (!points || !law || n < 0) return VM_NAN;
    vm_real worst = 0;
    long i;
    for (i = 0; i < n; i++) {
        const vm_real observed = kind == VM_TURNING_POINTS ? points[i].x : points[i].v;
        const vm_real error = VM_FABS(law(points[i].t, ctx) / VM_FABS(observed) - 1);
        if (!(error <= worst)) worst = error;
    }
    return worst;
}

/* q/Om, what averaging takes for small: q = ((2r-1) m' + 2b)/m + k'/k and the rate Om of the Ateb phase at
   amplitude A. The amplitude laws err by about (q/Om)^2, waveforms by q/Om over times of order 1/q. */
VM_API vm_real vm_adiabaticity(vm_real A, vm_real mass, vm_real mass_rate, vm_real k, vm_real k_rate, vm_real b,
                               vm_real reactive, vm_real alpha)
{
    const vm_real q = ((2 * reactive - 1) * mass_rate + 2 * b) / mass + k_rate / k;
    if (!(A > 0) || !(mass > 0) || !(k > 0) || !VM_IS_FINITE(mass) || !VM_IS_FINITE(k) || !VM_IS_FINITE(q))
        return VM_NAN;
    return q / vmi_slow_rate(A, k, mass, alpha);
}

#endif
/* scenes/scene.h - what a scene is: bodies, effects, events */
#ifndef VARMASS_SCENES_SCENE_H
#define VARMASS_SCENES_SCENE_H

/* -- Scenes --

   A scene is what a sketch shows: bodies, the effects that act on them, the events that change it. Its right-hand
   side goes through the effects that are listed, and nothing else; what is not listed is not linked either, since
   each constructor below binds the one function that it needs. All arrays are the caller's.

       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0)};                 // 2 kg, at x = 0.1 m, at rest
       vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 1),  // loses 10 g/s, which keeps its velocity
                              vm_effect_spring(0, 0, VM_GROUND, 0, 50, 3, 0)};
       vm_scene scene;
       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                          // 2 = vm_scene_size(&scene)
       vm_scene_fault culprit;
       int status;
       memset(&scene, 0, sizeof scene);                                      // what is not set is zero: not there
       scene.bodies = bodies;
       scene.n_bodies = 1;
       scene.effects = effects;
       scene.n_effects = 2;
       status = vm_scene_start(&scene, t, y, &culprit);                      // checks, and fills y
       if (status < 0) printf("%s %d: %s\n", culprit.kind, culprit.index, vm_strerror(status));
       else status = vm_scene_run(&scene, &t, 10, y, work, NULL);            // y[0] = x(10), y[1] = v(10)

   With events, scene.events and scene.located (as many) and scene.n_events are set as well, before the start. Bodies,
   effects and events are known by their index. A start begins everything anew, as the bodies, effects and events were
   made; a second vm_scene_run goes on where the first ended. From the start on all arrays stay where they are.
   Where scene.y_size = VM_LENGTH(y) and scene.work_size = VM_LENGTH(work) are set, a start and a run check that the
   arrays are long enough: VM_SHORT_ARRAY.
   An evaluation takes some 80 instructions a line body and 20 to 40 an effect, beyond what its force takes: 3 and 0.3
   times the C library's sin.

   The state has so many numbers a body: a line, an axle 2 (angle and angular velocity), the plane 6, a point 6, free
   in space 13; one more where the mass is itself a state. Positions come first, from bodies[i].at on:
     line   x, v                                     point  r (3), v (3)
     axle   angle, omega                             free   r (3), q (4), v (3), omega (3, in body axes)
     plane  x, y, angle, vx, vy, omega               then the mass; of a growing body the mass centre in its axes
   from where it was first, 2 in the plane or 3, and the inertia about it, 1 or 6 (xx, yy, zz, xy, xz, yz).
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
    /* only of growing bodies: of r' beyond v, m/s, inertial axes; of the mass centre in the body, of the inertia,
       body axes */
    vm_vec3 drift, centre_rate;
    vm_inertia inertia_rate;
    /* only where there is a book: */
    vm_real reactive[6], brought[6]; /* of force, what is reactive; momentum that streams bring, by the second */
    vm_real brought_energy, mixing;  /* their energy, and what is lost as they take on the body's velocity, W */
} vm_load;                           /* what acts on a body at the moment */

typedef struct VM_TAG(vm_scene_body) vm_scene_body;

struct VM_TAG(vm_scene_body) {
    int motion;                 /* VM_LINE, ... */
    int mass_is_state;          /* so that streams can change it */
    int grows;                  /* so are the mass centre in the body and the inertia */
    int absent;                 /* not there until an event brings it in */
    int positions, coordinates; /* numbers of the state that are positions, velocities */
    int at, mass_at; /* where its state begins, the mass in it; set by vm_scene_start, as all that follows */
    int away;        /* not there now */
    /* what the motion needs, so that others are not linked; begin, of growing bodies, before the effects */
    int (*accelerate)(const vm_scene_body *b, const vm_real *state, vm_real *rates);
    void (*begin)(vm_scene_body *b, const vm_real *state);
    vm_real mass; /* now, where neither a state nor a law says it */
    vm_load load; /* what acts on it now */
    void (*put)(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state);
    void (*get)(const vm_scene_body *b, const vm_real *state, vm_body *now);
    int (*check)(const vm_body *start); /* null, or of its inertia */
    vm_body start;  /* as it starts: of a line mass, r.x, v.x; of an axle mass (kg m^2), omega.z and angle */
    vm_real angle;  /* rad, of an axle or in the plane */
    vm_real jumped; /* what jumps, and switching it off and on, have added to the mass of a law */
    vm_inertia inertia, filled; /* now; the same with something about the null axes of a rod or a point */
    vmi_mat3 axes;              /* of a growing body, now */
    int acted;                  /* a mark of vm_scene_check */
    int status;                 /* VM_OK, or why its constructor could not make it */
    vm_real held;               /* its mass before an event, which switching effects must not change */
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
    int idle; /* now: 1 switched off, 2 since a body is not there, 3 both; of vm_scene_start, as x to other_load */
    int x, v, other_x, other_v;  /* y[x], y[v]: position and velocity on which it acts, and those against which */
    vm_load *load, *other_load;  /* of the bodies; null for the ground */
    int body, coordinate;        /* on what it acts */
    int other, other_coordinate; /* against what: another body or VM_GROUND */
    vm_real p[6];                /* parameters, in the order of the constructor's arguments */
    vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx);   /* of vm_effect_force, N or N m */
    vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx); /* of vm_effect_mass_law */
    vm_moving_point point;                                          /* of vm_effect_link */
    const vm_stream *stream;                                        /* of vm_effect_stream_mass and its like */
    void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx); /* null, or of vm_effect_varying */
    int (*check)(const vm_effect *effect);                                   /* null, or of the parameters */
    void *ctx;
    unsigned motions, other_motions; /* bit (1 << motion) for each motion that it can act on, against */
    int needs_mass_state;            /* streams do, some of them a growing body (2) */
    int order;                       /* 0 mass laws, 1 the others, 2 links, which are reactions to the others */
    int off;                         /* at the start it is switched off */
    int not_on_angle;                /* set where the angle of a body in the plane is no coordinate for it */
};

struct VM_TAG(vm_event) {
    vm_real (*when)(const vm_event *event, vm_real t, const vm_real *y); /* crosses zero; null: at time */
    int (*then)(vm_event *event, vm_real t, vm_real *y); /* a status; VM_STOPPED ends the run; null: only counted */
    vm_real time;                  /* s, where when is null; of a crossing when it was last, or the start */
    int direction;                 /* > 0 rising, < 0 falling, 0 both */
    int watches, body, coordinate; /* set where it watches a body: what passes */
    vm_real value;                 /* this value */
    int switches, effect, off;     /* set where it switches an effect on or off */
    /* null, or of a jump: what it is on a line, in the plane, or any, and on what motions; 1 where other separates
       from jump_body, -1 where it is attached to it */
    int (*check)(const vm_scene *scene, const vm_event *event);
    int (*jump)(const vm_event *event, const vm_body *body, vm_body *other, vm_body *result);
    unsigned motions;
    int jumps, jump_body, other;
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
    int status; /* VM_OK, or why a constructor could not make it */
};

/* What came in from outside, and whether it balances: vm_scene_keep_budget asks for it */
typedef struct VM_TAG(vm_budget) vm_budget;

struct VM_TAG(vm_budget) {
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
    void (*totals)(const vm_scene *scene, const vm_real *y, vm_budget *book);
};

struct VM_TAG(vm_scene) {
    vm_scene_body *bodies;
    int n_bodies;
    vm_effect *effects;
    int n_effects;
    vm_event *events;
    ode_event *located; /* n_events of them too, for the integrator */
    int n_events;
    vm_budget *book; /* of vm_scene_keep_budget: what was there at the start; VM_BUDGET numbers join the state */
    int (*output)(vm_real t, const vm_real *y, vm_scene *scene,
                  void *ctx); /* null, or called as a run starts and after each step; nonzero stops */
    const vm_real *times; /* null, or n_times increasing times: then output is called at them, not after steps */
    int n_times;
    void *output_ctx;
    int status, ode_status; /* of the right-hand side (an effect that cannot act sets it); of the integrator */
    int y_size, work_size;  /* 0, or how many numbers y and work have room for: then a start and a run check it */
    int size;               /* of the state when it was started, 0 before */
};

enum {
    VMI_SINGLE = 1 << VM_LINE | 1 << VM_AXLE,
    VMI_FLAT = 1 << VM_PLANE | 1 << VM_POINT,
    VMI_ALL_MOTIONS = VMI_SINGLE | VMI_FLAT | 1 << VM_FREE
};

VM_INLINE int vmi_scene_mass_at(const vm_scene_body *b) { return b->positions + b->coordinates; }

VM_INLINE int vmi_scene_body_size(const vm_scene_body *b)
{
    return vmi_scene_mass_at(b) + (b->mass_is_state != 0) + (b->grows ? b->motion == VM_PLANE ? 3 : 9 : 0);
}

/* Position and velocity on which an effect acts, relative to those against which; the ground's are 0 */
VM_INLINE vm_real vmi_effect_x(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->x] - y[e->other_x] : y[e->x];
}

VM_INLINE vm_real vmi_effect_v(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->v] - y[e->other_v] : y[e->v];
}

/* f on the body of e, -f on what it acts against */
VM_INLINE void vmi_effect_act(const vm_effect *e, vm_real f)
{
    e->load->force[e->coordinate] += f;
    if (e->other_load) e->other_load->force[e->other_coordinate] -= f;
}

#endif
/* scenes/motions.h - how each kind of body moves */
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

/* A line and an axle: one coordinate */
VM_API int vmi_single_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    rates[0] = state[1];
    rates[1] = b->load.force[0] / (b->load.mass + b->load.extra);
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

/* Bodies. m, m/s, rad, rad/s; of an axle the inertia is about it, in the plane about the mass centre, kg m^2. A free
   body may be a rod, whose spin about itself then stays. */
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

/* Documented with vm_scene_body_line. */
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

VM_API int vmi_plane_check(const vm_body *start) { return start->inertia.zz > 0 ? VM_OK : VM_BAD_INERTIA; }

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
    state[0] = now->r.x;
    state[1] = now->r.y;
    state[2] = angle;
    state[3] = now->v.x;
    state[4] = now->v.y;
    state[5] = now->omega.z;
}

VM_API void vmi_plane_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[0];
    now->r.y = state[1];
    now->v.x = state[3];
    now->v.y = state[4];
    vmi_sincos(state[2] / 2, &now->q.z, &now->q.w);
    now->omega.z = state[5];
    now->inertia.xx = now->inertia.yy = now->inertia.zz / 2; /* of a lamina: any that is possible will do */
}

/* Documented with vm_scene_body_line. */
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

VM_API int vmi_point_body_check(const vm_body *start)
{
    const vm_inertia *i = &start->inertia;
    const int none = i->xx == 0 && i->yy == 0 && i->zz == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    return none ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_point_body_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[b->positions + i];
    for (i = 0; i < 3; i++) rates[b->positions + i] = b->load.force[i] / b->load.mass;
    return VM_OK;
}

VM_API void vmi_point_body_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vm_real *v = state + b->positions;
    (void)angle;
    state[0] = now->r.x;
    state[1] = now->r.y;
    state[2] = now->r.z;
    v[0] = now->v.x;
    v[1] = now->v.y;
    v[2] = now->v.z;
}

VM_API void vmi_point_body_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    const vm_real *v = state + b->positions;
    now->r = vmi_vec3(state[0], state[1], state[2]);
    now->v = vmi_vec3(v[0], v[1], v[2]);
}

/* Documented with vm_scene_body_line. */
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

VM_API vm_quat vmi_free_quat(const vm_real *state)
{
    vm_quat q;
    q.w = state[3];
    q.x = state[4];
    q.y = state[5];
    q.z = state[6];
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
    spin.w = 0;
    spin.x = w.x / 2;
    spin.y = w.y / 2;
    spin.z = w.z / 2;
    turn = vmi_quat_times(q, spin);
    vmi_point_body_accelerate(b, state, rates);
    rates[3] = turn.w + pull * q.w;
    rates[4] = turn.x + pull * q.x;
    rates[5] = turn.y + pull * q.y;
    rates[6] = turn.z + pull * q.z;
    a[0] = i->xx;
    a[4] = i->yy;
    a[8] = i->zz;
    a[1] = a[3] = i->xy;
    a[2] = a[6] = i->xz;
    a[5] = a[7] = i->yz;
    rates[10] = h.x;
    rates[11] = h.y;
    rates[12] = h.z;
    return vmi_solve_linear(3, a, rates + 10) ? VM_BAD_INERTIA : VM_OK;
}

/* Euler's equations are solved with something about a null axis, too: it finds nothing to accelerate there */
VM_API vm_inertia vmi_free_filled(const vm_inertia *i)
{
    const vm_real trace = i->xx + i->yy + i->zz;
    vmi_principal p = vmi_principal_axes(i);
    int k, null_axes = 0;
    for (k = 0; k < 3; k++)
        if (!(p.moment[k] > vmi_slack(i))) {
            p.moment[k] = trace > 0 ? trace : 1;
            null_axes++;
        }
    return null_axes ? vmi_inertia_from(&p) : *i;
}

VM_API void vmi_free_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    const vmi_mat3 turn = vmi_rotation(now->q);
    const vm_vec3 omega = vmi_times_transposed(&turn, now->omega);
    b->filled = vmi_free_filled(&now->inertia);
    vmi_point_body_put(b, now, angle, state);
    state[3] = vmi_quat_is_none(now->q) ? 1 : now->q.w;
    state[4] = now->q.x;
    state[5] = now->q.y;
    state[6] = now->q.z;
    state[10] = omega.x;
    state[11] = omega.y;
    state[12] = omega.z;
}

VM_API void vmi_free_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    vmi_mat3 turn;
    vmi_point_body_get(b, state, now);
    now->q = vmi_free_quat(state);
    turn = vmi_rotation(now->q);
    now->omega = vmi_times(&turn, vmi_vec3(state[10], state[11], state[12]));
}

/* Documented with vm_scene_body_line. */
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

/* the same, its mass a state */
VM_API vm_scene_body vm_scene_body_with_mass_state(vm_scene_body body)
{
    body.mass_is_state = 1;
    return body;
}

/* the same, not yet there */
VM_API vm_scene_body vm_scene_body_absent(vm_scene_body body)
{
    body.absent = 1;
    return body;
}

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

/* The way back: a += these */
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
/* scenes/growing.h - bodies whose mass centre and inertia change */
#ifndef VARMASS_SCENES_GROWING_H
#define VARMASS_SCENES_GROWING_H

/* After the mass: where the mass centre is in the body, 2 or 3 numbers, then the inertia, 1 or 6 */
VM_INLINE int vmi_growth(const vm_scene_body *b) { return vmi_scene_mass_at(b) + 1; }

VM_API void vmi_growth_begin(vm_scene_body *b)
{
    const vm_inertia none = {0, 0, 0, 0, 0, 0};
    b->load.drift = b->load.centre_rate = vmi_vec3(0, 0, 0);
    b->load.inertia_rate = none;
}

VM_API vm_vec3 vmi_growth_centre(const vm_scene_body *b, const vm_real *state)
{
    const vm_real *c = state + vmi_growth(b);
    return vmi_vec3(c[0], c[1], b->motion == VM_PLANE ? 0 : c[2]);
}

VM_API void vmi_growth_put_centre(const vm_scene_body *b, vm_vec3 centre, vm_real *state)
{
    vm_real *c = state + vmi_growth(b);
    c[0] = centre.x;
    c[1] = centre.y;
    if (b->motion != VM_PLANE) c[2] = centre.z;
}

VM_API void vmi_plane_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vm_real s, c;
    vmi_growth_begin(b);
    vmi_sincos(state[2], &s, &c);
    b->axes.x = vmi_vec3(c, s, 0);
    b->axes.y = vmi_vec3(-s, c, 0);
    b->axes.z = vmi_vec3(0, 0, 1);
    b->inertia.zz = state[vmi_growth(b) + 2];
}

VM_API int vmi_plane_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    if (!(b->inertia.zz > 0)) return VM_BAD_INERTIA;
    vmi_plane_accelerate(b, state, rates);
    rates[0] += load->drift.x;
    rates[1] += load->drift.y;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    rates[vmi_growth(b) + 2] = load->inertia_rate.zz;
    return VM_OK;
}

VM_API void vmi_plane_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_plane_put(b, now, angle, state);
    state[vmi_growth(b) + 2] = now->inertia.zz;
}

VM_API void vmi_plane_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia.zz = state[vmi_growth(b) + 2];
    vmi_plane_get(b, state, now);
}

/* The same, its mass, the mass centre in the body and its inertia states: for streams that cross at points. A run
   ends with VM_BAD_INERTIA when they leave an inertia that no body can have. A rod or a point cannot grow. */
VM_API vm_scene_body vm_scene_body_growing_plane(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.begin = vmi_plane_growing_begin;
    body.accelerate = vmi_plane_growing_accelerate;
    body.put = body.motion == VM_PLANE ? vmi_plane_growing_put : NULL; /* NULL is refused by vm_scene_check */
    body.get = vmi_plane_growing_get;
    return body;
}

VM_API void vmi_free_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vmi_growth_begin(b);
    b->axes = vmi_rotation(vmi_free_quat(state));
    b->inertia = b->filled = vmi_get_inertia(state + vmi_growth(b) + 3);
}

VM_API int vmi_free_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    vmi_inertia_ldl factors; /* which Euler's equations below do not use */
    if (!vmi_inertia_factor_if_possible(&b->inertia, &factors)) return VM_BAD_INERTIA;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    vmi_set_inertia(rates + vmi_growth(b) + 3, &load->inertia_rate);
    if (vmi_free_accelerate(b, state, rates)) return VM_BAD_INERTIA;
    rates[0] += load->drift.x;
    rates[1] += load->drift.y;
    rates[2] += load->drift.z;
    return VM_OK;
}

VM_API void vmi_free_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_free_put(b, now, angle, state);
    vmi_set_inertia(state + vmi_growth(b) + 3, &now->inertia);
}

VM_API void vmi_free_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia = vmi_get_inertia(state + vmi_growth(b) + 3);
    vmi_free_get(b, state, now);
}

/* A rod or a point has no axis about which a stream could turn it */
VM_API int vmi_free_growing_check(const vm_body *start)
{
    vmi_inertia_ldl factors;
    const int status = vmi_check_body(start);
    if (status) return status;
    return vmi_inertia_factor_if_possible(&start->inertia, &factors) ? VM_OK : VM_BAD_INERTIA;
}

/* Documented with vm_scene_body_growing_plane. */
VM_API vm_scene_body vm_scene_body_growing_free(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.check = vmi_free_growing_check;
    body.begin = vmi_free_growing_begin;
    body.accelerate = vmi_free_growing_accelerate;
    body.put = body.motion == VM_FREE ? vmi_free_growing_put : NULL;
    body.get = vmi_free_growing_get;
    return body;
}

#endif
/* scenes/forces.h - forces as functions of numbers */
#ifndef VARMASS_SCENES_FORCES_H
#define VARMASS_SCENES_FORCES_H

/* Forces, N (torques, N m), for right-hand sides that are written by hand; the effects use them. x, v: extension, its
   rate. A spring's force (248), k in N/m^alpha, alpha >= 0; a damper's, b in N s/m; that of Van der Pol's (404), c in
   N s/m^3; a drive's, torque in N m, kappa in N m s; force cos(frequency t + phase), frequency in rad/s; the reactive
   force of a stream of rate kg/s whose own velocity is u + share v. Within some eps of the terms that are added. */
/* -k x |x|^(alpha-1) */
VM_INLINE vm_real vm_force_spring(vm_real k, vm_real alpha, vm_real x)
{
    if (alpha == 1) return -k * x;
    if (alpha == 3) return -(k * x) * (x * x);
    if (alpha == 2) return -k * (x * VM_FABS(x));
    return -VM_COPYSIGN(k, x) * vmi_pow_checked(VM_FABS(x), alpha) * (x != 0);
}

/* -b v */
VM_INLINE vm_real vm_force_damper(vm_real b, vm_real v) { return -b * v; }

/* (b - c x^2) v */
VM_INLINE vm_real vm_force_van_der_pol(vm_real b, vm_real c, vm_real x, vm_real v) { return (b - c * (x * x)) * v; }

/* torque - kappa omega */
VM_INLINE vm_real vm_force_motor(vm_real torque, vm_real kappa, vm_real omega) { return torque - kappa * omega; }

/* Documented with vm_force_spring. */
VM_INLINE vm_real vm_force_harmonic(vm_real force, vm_real frequency, vm_real phase, vm_real t)
{
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    return force * c;
}

/* rate (u + share v - v) */
VM_INLINE vm_real vm_force_stream(vm_real rate, vm_real u, vm_real share, vm_real v)
{
    return rate * (u + (share - 1) * v);
}

/* mass g */
VM_INLINE vm_real vm_force_gravity(vm_real mass, vm_real g) { return mass * g; }

/* Documented with vm_force_spring. */
VM_INLINE void vm_force_shaft(vm_real k, vm_real alpha, vm_real x, vm_real y, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real r = VM_SQRT(x * x + y * y), f = r > 0 ? vm_force_spring(k, alpha, r) / r : 0;
    *fx = f * x;
    *fy = f * y;
}

/* Documented with vm_force_spring. */
VM_INLINE void vm_force_unbalance(vm_real unbalance, vm_real frequency, vm_real phase, vm_real t, vm_real *fx,
                                  vm_real *fy)
{
    if (!fx || !fy) return;
    const vm_real size = unbalance * (frequency * frequency);
    vm_real s, c;
    vmi_sincos(frequency * t + phase, &s, &c);
    *fx = size * c;
    *fy = size * s;
}

/* Documented with vm_force_spring. */
VM_INLINE void vm_force_gyroscopic(vm_real coupling, vm_real vx, vm_real vy, vm_real *fx, vm_real *fy)
{
    if (!fx || !fy) return;
    *fx = -coupling * vy;
    *fy = coupling * vx;
}

#endif
/* scenes/effects.h - effects that act on coordinates */
#ifndef VARMASS_SCENES_EFFECTS_H
#define VARMASS_SCENES_EFFECTS_H

#include <string.h>

/* An effect on one coordinate, against another */
VM_API vm_effect vmi_effect(int body, int coordinate, int other, int other_coordinate, unsigned motions, vm_real p0,
                            vm_real p1, vm_real p2)
{
    vm_effect e;
    memset(&e, 0, sizeof e);
    e.body = body;
    e.coordinate = coordinate;
    e.other = other;
    e.other_coordinate = other_coordinate;
    e.motions = motions;
    e.other_motions = VMI_ALL_MOTIONS;
    e.order = 1;
    e.p[0] = p0;
    e.p[1] = p1;
    e.p[2] = p2;
    return e;
}

VM_API void vmi_apply_gravity(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)y;
    (void)s;
    e->load->force[e->coordinate] += vm_force_gravity(e->load->mass, e->p[0]);
}

/* Effects, the forces above on a coordinate of a body, x and v its position and velocity; where there is an other
   body, or VM_GROUND, x and v are relative to its coordinate, and it takes the reaction. A mass law of a body stands
   before what else acts on it. */
/* M g, along the coordinate: g = -9.81 where it points upwards; not on an angle */
VM_API vm_effect vm_effect_gravity(int body, int coordinate, vm_real g)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS & ~(1 << VM_AXLE), g, 0, 0);
    e.not_on_angle = 1;
    e.apply = vmi_apply_gravity;
    return e;
}

VM_API void vmi_apply_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_spring(e->p[0], e->p[1], vmi_effect_x(e, y) - e->p[2]));
}

VM_API int vmi_power_check(const vm_effect *e) { return e->p[1] >= 0 ? VM_OK : VM_DOMAIN; } /* alpha */

/* vm_force_spring of x - rest */
VM_API vm_effect vm_effect_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                  vm_real alpha, vm_real rest)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, k, alpha, rest);
    e.apply = vmi_apply_spring;
    e.check = vmi_power_check;
    return e;
}

VM_API void vmi_apply_linear_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, -e->p[0] * (vmi_effect_x(e, y) - e->p[2]));
}

/* the same with alpha = 1: no power is linked */
VM_API vm_effect vm_effect_linear_spring(int body, int coordinate, int other, int other_coordinate, vm_real k,
                                         vm_real rest)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, k, 1, rest);
    e.apply = vmi_apply_linear_spring;
    return e;
}

VM_API void vmi_apply_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_damper(e->p[0], vmi_effect_v(e, y)));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_damper(int body, int coordinate, int other, int other_coordinate, vm_real b)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, b, 0, 0);
    e.apply = vmi_apply_damper;
    return e;
}

VM_API void vmi_apply_rotational_damper(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    const vm_vec3 torque = vmi_scale(-e->p[0], vmi_scene_spin(b, y));
    (void)t;
    vmi_scene_add(b, e->load->force, vmi_vec3(0, 0, 0), torque);
}

/* -b omega: on an axle, in the plane, free */
VM_API vm_effect vm_effect_rotational_damper(int body, vm_real b)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, 1 << VM_AXLE | 1 << VM_PLANE | 1 << VM_FREE, b, 0, 0);
    e.apply = vmi_apply_rotational_damper;
    return e;
}

VM_API void vmi_apply_van_der_pol(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_van_der_pol(e->p[0], e->p[1], vmi_effect_x(e, y), vmi_effect_v(e, y)));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_van_der_pol(int body, int coordinate, vm_real b, vm_real c)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, b, c, 0);
    e.apply = vmi_apply_van_der_pol;
    return e;
}

VM_API void vmi_apply_drive(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    (void)s;
    vmi_effect_act(e, vm_force_motor(e->p[0], e->p[1], vmi_effect_v(e, y)));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_motor(int body, int coordinate, vm_real torque, vm_real kappa)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, torque, kappa, 0);
    e.apply = vmi_apply_drive;
    return e;
}

VM_API void vmi_apply_harmonic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)y;
    (void)s;
    vmi_effect_act(e, vm_force_harmonic(e->p[0], e->p[1], e->p[2], t));
}

/* Documented with vm_effect_spring. */
VM_API vm_effect vm_effect_harmonic(int body, int coordinate, vm_real force, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, coordinate, VM_GROUND, 0, VMI_ALL_MOTIONS, force, frequency, phase);
    e.apply = vmi_apply_harmonic;
    return e;
}

VM_API void vmi_apply_user(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)s;
    vmi_effect_act(e, e->force(t, vmi_effect_x(e, y), vmi_effect_v(e, y), e->ctx));
}

/* Documented with vm_effect_force. */
VM_API vm_effect vm_effect_force_between(int body, int coordinate, int other, int other_coordinate,
                                        vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    vm_effect e = vmi_effect(body, coordinate, other, other_coordinate, VMI_ALL_MOTIONS, 0, 0, 0);
    e.apply = force ? vmi_apply_user : NULL;
    e.force = force;
    e.ctx = ctx;
    return e;
}

/* a force of one's own, which depends on t and the coordinate, and on what ctx points to */
VM_API vm_effect vm_effect_force(int body, int coordinate,
                                vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx), void *ctx)
{
    return vm_effect_force_between(body, coordinate, VM_GROUND, 0, force, ctx);
}

/* an effect of one's own, which may depend on everything: apply adds to effect->load->force[coordinate], to
   load->mass_rate where the mass is a state, to load->mass where it is neither a state nor of a law; it may read
   load->mass, y[effect->x] and y[effect->v], the first coordinate's, y[scene->bodies[i].at] and what follows of body
   i, effect->p and effect->ctx, and load->force, which is what the effects before it in the list have made: a stop,
   listed last, can take from it what it holds. other, or VM_GROUND: a body without which it does not act either,
   effect->other_load and so on */
VM_API vm_effect vm_effect_custom(int body, int other,
                                    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y,
                                                  vm_scene *scene),
                                    void *ctx)
{
    vm_effect e = vmi_effect(body, 0, other, 0, VMI_ALL_MOTIONS, 0, 0, 0);
    e.apply = apply;
    e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_shaft(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_shaft(e->p[0], e->p[1], y[e->x], y[e->x + 1], &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* an elastic shaft: -k r |r|^(alpha-1) towards the origin, in coordinates 0 and 1 of a body in the plane, a point */
VM_API vm_effect vm_effect_shaft(int body, vm_real k, vm_real alpha)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, k, alpha, 0);
    e.apply = vmi_apply_shaft;
    e.check = vmi_power_check;
    return e;
}

VM_API void vmi_apply_unbalance(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)y;
    (void)s;
    vm_force_unbalance(e->p[0], e->p[1], e->p[2], t, &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* an unbalance m e (kg m) that turns with Omega = frequency: m e Omega^2 (cos, sin)(Omega t + phase) */
VM_API vm_effect vm_effect_unbalance(int body, vm_real unbalance, vm_real frequency, vm_real phase)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, unbalance, frequency, phase);
    e.apply = vmi_apply_unbalance;
    return e;
}

VM_API void vmi_apply_gyroscopic(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_real fx, fy;
    (void)t;
    (void)s;
    vm_force_gyroscopic(e->p[0], y[e->v], y[e->v + 1], &fx, &fy);
    e->load->force[0] += fx;
    e->load->force[1] += fy;
}

/* force coupling (-vy, vx) */
VM_API vm_effect vm_effect_gyroscopic(int body, vm_real coupling)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_FLAT, coupling, 0, 0);
    e.apply = vmi_apply_gyroscopic;
    return e;
}

#endif
/* scenes/mass.h - laws of mass */
#ifndef VARMASS_SCENES_MASS_H
#define VARMASS_SCENES_MASS_H

enum { VM_MASS_OF_T, VM_MASS_OF_X, VM_MASS_OF_V2 }; /* M0 + c t, M0 + c x, M0 + c v^2, M0 as the body was made */

/* rate (u + (share - 1) v) on each coordinate that moves the mass */
VM_INLINE void vmi_scene_reactive(const vm_effect *e, const vm_real *y, vm_scene *s, vm_real rate, const vm_real *u,
                                  vm_real share)
{
    vm_load *load = e->load;
    const vm_real *v = y + e->v;
    const int motion = s->bodies[e->body].motion, n = motion <= VM_AXLE ? 1 : motion == VM_PLANE ? 2 : 3;
    int i;
    for (i = 0; i < n; i++) {
        const vm_real own = u[i] + share * v[i], push = rate * (own - v[i]);
        load->force[i] += push;
        if (!s->book) continue;
        load->reactive[i] += push;
        load->brought[i] += rate * own;
        load->brought_energy += rate * own * own / 2;
        load->mixing += push * (own - v[i]) / 2;
    }
}

/* The mass is now that of the law; M' = by_t + by_x v + by_v v' */
VM_INLINE void vmi_scene_apply_law(const vm_effect *e, const vm_real *y, vm_scene *s, const vm_mass_now *now,
                                const vm_real *u, vm_real share)
{
    vm_load *load = e->load;
    const vm_real v = y[e->v];
    load->mass = now->mass + s->bodies[e->body].jumped;
    load->extra = now->by_v * ((1 - share) * v - u[0]);
    load->by_v = now->by_v;
    load->own = u[0] + share * v;
    vmi_scene_reactive(e, y, s, now->by_t + now->by_x * v, u, share);
}

VM_API void vmi_apply_mass_law(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_mass_now now = e->law(t, y[e->x], y[e->v], e->ctx);
    vmi_scene_apply_law(e, y, s, &now, e->p, e->p[3]);
}

/* A mass law: M(t, x, v), with the reactive force M' (u + share v - v). share = 1, u = 0: what joins or leaves has
   the body's velocity, no reactive force; 0: its own velocity is u, of which u.x counts on a line and, in rad/s, on
   an axle. x and v are those of a line or an axle (J(phi), J(omega)); of any other body the law is M(t). What jumps
   add comes on top of the law. If an event switches a law off, the mass stays as it is; if it switches a law on,
   the law goes on from the mass that is there: of M0 + c t then only c counts. So a switch never makes a mass
   jump. */
VM_API vm_effect vm_effect_mass_law(int body, vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx),
                                    void *ctx, vm_vec3 u, vm_real share)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_ALL_MOTIONS, u.x, u.y, u.z);
    e.p[3] = share;
    e.order = 0;
    e.apply = law ? vmi_apply_mass_law : NULL;
    e.law = law;
    e.ctx = ctx;
    return e;
}

VM_API void vmi_apply_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real x = y[e->x], v = y[e->v], c = e->p[4];
    vm_mass_now now = {0, 0, 0, 0};
    now.mass = s->bodies[e->body].start.mass;
    if (e->other_coordinate == VM_MASS_OF_T) {
        now.mass += c * t;
        now.by_t = c;
    } else if (e->other_coordinate == VM_MASS_OF_X) {
        now.mass += c * x;
        now.by_x = c;
    } else {
        now.mass += c * v * v;
        now.by_v = 2 * c * v;
    }
    vmi_scene_apply_law(e, y, s, &now, e->p, e->p[3]);
}

VM_API vm_effect vm_effect_mass(int body, int kind, vm_real c, vm_real u, vm_real share)
{
    const unsigned motions = kind == VM_MASS_OF_T ? VMI_ALL_MOTIONS : VMI_SINGLE;
    vm_effect e = vmi_effect(body, 0, VM_GROUND, kind, motions, u, 0, 0);
    e.p[3] = share;
    e.p[4] = c;
    e.order = 0;
    e.apply = kind >= VM_MASS_OF_T && kind <= VM_MASS_OF_V2 ? vmi_apply_mass : NULL;
    return e;
}

/* The same, of a stream that varies: vary writes what is otherwise than in effect.stream at t and y, the point of
   contact that moves in the body, the rate, the velocity */
VM_API vm_effect vm_effect_varying(vm_effect effect,
                                   void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx),
                                   void *ctx)
{
    effect.vary = vary;
    effect.ctx = ctx;
    if (!effect.stream || !vary) effect.apply = NULL; /* which vm_scene_check refuses */
    return effect;
}

#endif
/* scenes/streams.h - streams of mass onto and out of bodies of a scene */
#ifndef VARMASS_SCENES_STREAMS_H
#define VARMASS_SCENES_STREAMS_H

VM_API void vmi_apply_stream(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)t;
    e->load->mass_rate += e->p[4];
    vmi_scene_reactive(e, y, s, e->p[4], e->p, e->p[3]);
}

/* A stream, for a body whose mass is a state: rate kg/s (on an axle kg m^2/s), u and share as above; it crosses at
   the mass centre and leaves the inertia as it is */
VM_API vm_effect vm_effect_stream(int body, vm_real rate, vm_vec3 u, vm_real share)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_ALL_MOTIONS, u.x, u.y, u.z);
    e.p[3] = share;
    e.p[4] = rate;
    e.needs_mass_state = 1;
    e.apply = vmi_apply_stream;
    return e;
}

/* A stream at a point of a growing body: the body as the stream sees it, and what section 5 makes of it. The book
   has what the stream brings with the mass; as mixing, what of that does not go into the body's energy. */
typedef struct VM_TAG(vmi_crossing) {
    vmi_stream_seen seen;
    vmi_stream_sum sum;
} vmi_crossing;

VM_API void vmi_crossing_now(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s, vmi_crossing *c)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_stream stream = *e->stream;
    if (e->vary) {
        e->vary(t, y, &stream, e->ctx);
        stream.from = NULL;
    }
    c->seen.turn = &b->axes;
    c->seen.slip = vmi_vec3(0, 0, 0);
    c->seen.energy = s->book != NULL;
    c->seen.v = vmi_scene_moving(b, y + e->v);
    c->seen.omega = vmi_scene_turning(b, y + e->v);
    c->seen.centre = vmi_growth_centre(b, y + b->at);
    if (!vmi_stream_sums(1, &stream, &c->seen, &c->sum)) s->status = VM_BAD_ARGUMENT; /* an unknown motion */
}

/* A reactive force and a moment or torque, inertial axes */
VM_API void vmi_crossing_push(const vm_effect *e, vm_scene *s, const vmi_crossing *c, vm_vec3 force, vm_vec3 torque)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_scene_add(b, load->force, force, torque);
    if (!s->book) return;
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
    load->centre_rate = vmi_add(load->centre_rate, shift);
    load->inertia_rate = vmi_inertia_plus(load->inertia_rate, 1, c.sum.inertia);
    if (!s->book) return;
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

VM_API int vmi_crossing_check(const vm_effect *e)
{
    if (!e->stream) return VM_BAD_ARGUMENT;
    return e->stream->from ? (int)VM_STORED_STREAM : vmi_stream_is_valid(e->stream);
}

VM_API vm_effect vmi_effect_crossing(int body, const vm_stream *stream,
                                     void (*apply)(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s))
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, 1 << VM_PLANE | 1 << VM_FREE, 0, 0, 0);
    e.needs_mass_state = 2;
    e.stream = stream;
    e.check = vmi_crossing_check;
    e.apply = apply;
    return e;
}

/* A stream of chapter 5 that crosses at a point of a growing body and is put there (in body axes from where the mass
   centre was at first; a stream with a store is refused). Each of what it does is an effect, and each may be left
   out: mass (the mass M, its centre, the inertia; r' = v + (M'/M) d), reactive force M' (u - v) (156), moment
   d x M' (u - v) (158), torque M' kappa omega2 - I' omega (157). A book's mixing is that of streams whose effects are
   all listed. The stream is the caller's; what an event changes in it has changed. */
VM_API vm_effect vm_effect_stream_mass(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_mass);
}

/* Documented with vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_force(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_force);
}

/* Documented with vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_moment(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_moment);
}

/* Documented with vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_torque(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_torque);
}

#endif
/* scenes/band.h - a band that winds up */
#ifndef VARMASS_SCENES_BAND_H
#define VARMASS_SCENES_BAND_H

/* A band that is wound up on a drum on an axle, or unwound from it (chapter 5.2), layer upon layer. At the angle phi,
   0 where the drum, of the inertia with which the body was made, is bare, the band comes or goes at the radius
   R + h phi/(2 pi), a spiral, or where by_layer is set at R + h n, n turns being complete; its inertia grows by
   rho b h radius^3 a radian. Its own velocity is speed + share (radius omega): share = 1 and speed = 0 if it moves
   with the drum. By layers the torque has kinks at full turns. */
typedef struct VM_TAG(vm_band) {
    vm_real radius;           /* R of the bare drum, m */
    vm_real thickness, width; /* h, b, m */
    vm_real density;          /* rho, kg/m^3 */
    vm_real speed, share;     /* m/s */
    int by_layer;
} vm_band;

typedef struct VM_TAG(vm_band_now) {
    vm_real radius, rate, mass, inertia; /* m; kg/rad, mu (181) of this radius; of what is wound up, kg, kg m^2 */
} vm_band_now;

/* rho b h integral of radius^k over phi, k = 1 the mass, 3 the inertia; d: what has been added to R. With n layers
   complete sum (R + i h)^k, i < n, is by sum i, i^2, i^3 */
VM_API vm_band_now vmi_band_by_layer(vm_real phi, const vm_band *b, vm_real line)
{
    const vm_real n = VM_FLOOR(phi / (2 * VM_PI)), rest = phi - n * (2 * VM_PI), R = b->radius, h = b->thickness;
    const vm_real s1 = n * (n - 1) / 2, s2 = s1 * (2 * n - 1) / 3, r = R + n * h;
    vm_band_now now;
    now.radius = r;
    now.rate = line * r;
    now.mass = line * (2 * VM_PI * (n * R + h * s1) + r * rest);
    now.inertia = line * (2 * VM_PI * (n * R * R * R + 3 * R * h * (R * s1 + h * s2) + h * h * h * s1 * s1) +
                          r * r * r * rest);
    return now;
}

VM_API int vmi_band_is_valid(const vm_band *b)
{
    return b->radius > 0 && b->thickness >= 0 && b->width >= 0 && b->density >= 0;
}

VM_API vm_band_now vmi_no_band(void)
{
    vm_band_now none;
    none.radius = none.rate = none.mass = none.inertia = VM_NAN;
    return none;
}

/* phi < 0: the bare drum; NaN where phi is not finite, the radius not > 0, a size < 0. Some eps of each number */
VM_API vm_band_now vm_band_at(vm_real phi, const vm_band *band)
{
    if (!band) return vmi_no_band();
    const vm_real line = band->density * band->width * band->thickness, R = band->radius;
    const vm_real d = band->thickness * (phi / (2 * VM_PI)), r = R + d;
    const vm_real bare = VM_IS_FINITE(phi) && vmi_band_is_valid(band) ? 0 : VM_NAN;
    vm_band_now now;
    now.radius = R + bare;
    now.rate = now.mass = now.inertia = bare;
    if (!(phi >= 0 && bare == 0)) return now;
    if (band->by_layer) return vmi_band_by_layer(phi, band, line);
    now.radius = r;
    now.rate = line * r;
    now.mass = line * phi * (r + R) / 2;
    now.inertia = line * phi * ((r + R) * (r * r + R * R)) / 4;
    return now;
}

VM_API vm_band vmi_band_of(const vm_effect *e)
{
    vm_band b;
    b.radius = e->p[0];
    b.thickness = e->p[1];
    b.width = e->p[2];
    b.density = e->p[3];
    b.speed = e->p[4];
    b.share = e->p[5];
    b.by_layer = e->other_coordinate;
    return b;
}

VM_API void vmi_apply_band(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_band band = vmi_band_of(e);
    const vm_band_now wound = vm_band_at(y[e->x], &band);
    const vm_real u = band.speed / wound.radius;
    vm_mass_now now = {0, 0, 0, 0};
    (void)t;
    now.mass = s->bodies[e->body].start.mass + wound.inertia;
    now.by_x = wound.rate * wound.radius * wound.radius;
    vmi_scene_apply_law(e, y, s, &now, &u, band.share);
}

VM_API int vmi_band_check(const vm_effect *e)
{
    const vm_band band = vmi_band_of(e);
    return vmi_band_is_valid(&band) ? VM_OK : VM_DOMAIN;
}

/* Documented with vm_band_at. */
VM_API vm_effect vm_effect_band(int body, const vm_band *band)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, 1 << VM_AXLE, 0, 0, 0);
    e.order = 0;
    e.apply = band ? vmi_apply_band : NULL;
    e.check = vmi_band_check;
    if (!band) return e;
    e.p[0] = band->radius;
    e.p[1] = band->thickness;
    e.p[2] = band->width;
    e.p[3] = band->density;
    e.p[4] = band->speed;
    e.p[5] = band->share;
    e.other_coordinate = band->by_layer != 0;
    return e;
}

#endif
/* scenes/links.h - rigid links between bodies */
#ifndef VARMASS_SCENES_LINKS_H
#define VARMASS_SCENES_LINKS_H

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
        end->r[i] = i < n ? r[i] : 0;
        end->v[i] = i < n ? v[i] : 0;
        end->mobility[i] = i < n ? 1 / (b->load.mass + b->load.extra) : 0;
        end->a[i] = end->mobility[i] * b->load.force[i];
    }
}

VM_API void vmi_link_point(const vm_effect *e, vm_real t, vmi_link_end *end)
{
    vm_vec3 r = {0, 0, 0}, v = {0, 0, 0}, a = {0, 0, 0};
    int i;
    e->point(t, &r, &v, &a, e->ctx);
    end->r[0] = r.x;
    end->r[1] = r.y;
    end->r[2] = r.z;
    end->v[0] = v.x;
    end->v[1] = v.y;
    end->v[2] = v.z;
    end->a[0] = a.x;
    end->a[1] = a.y;
    end->a[2] = a.z;
    for (i = 0; i < 3; i++) end->mobility[i] = 0;
}

/* The link pulls with lambda d, d = r - far end: C = (d^2 - l^2)/2 obeys C'' + 2 rate C' + rate^2 C = 0, which gives
   lambda from what else acts on its ends. p = length, rate, cord */
VM_API void vmi_apply_link(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_scene_body *b = s->bodies + e->body;
    vm_real *force = b->load.force, *far_force = e->other >= 0 ? s->bodies[e->other].load.force : NULL;
    /* shorter by this, a cord does not pull: more than its length is uncertain by, or it would be taut by turns */
    const vm_real rate = e->p[1], loose = VM_C(1e-6) + 512 * VM_EPSILON;
    vmi_link_end here, there;
    vm_real d[3], dd = 0, dv = 0, vv = 0, da = 0, mobility = 0, C, lambda;
    int i;
    vmi_link_body(s, e->body, y, &here);
    if (far_force) vmi_link_body(s, e->other, y, &there);
    else vmi_link_point(e, t, &there);
    for (i = 0; i < 3; i++) {
        const vm_real v = here.v[i] - there.v[i];
        d[i] = here.r[i] - there.r[i];
        dd += d[i] * d[i];
        dv += d[i] * v;
        vv += v * v;
        da += d[i] * (here.a[i] - there.a[i]);
        mobility += d[i] * d[i] * (here.mobility[i] + there.mobility[i]);
    }
    if (!(mobility > 0)) { /* the ends are in one place, or cannot move along the link */
        s->status = mobility == 0 ? VM_SINGULAR : VM_NOT_FINITE;
        return;
    }
    C = (dd - e->p[0] * e->p[0]) / 2;
    lambda = -(da + vv + 2 * rate * dv + rate * rate * C) / mobility;
    if (e->p[2] != 0 && (lambda > 0 || C < -loose * dd)) return; /* slack */
    for (i = 0; i < 3; i++) {
        if (here.mobility[i] > 0) force[i] += lambda * d[i];
        if (far_force && there.mobility[i] > 0) far_force[i] -= lambda * d[i];
    }
}

VM_API int vmi_link_check(const vm_effect *e) { return e->p[0] > 0 && e->p[1] > 0 ? VM_OK : VM_DOMAIN; }

/* a rigid link, or where cord is set one that only pulls, of a length between a body (a point, or in the plane) and
   another (on a line, too) or, other = VM_GROUND, a point that moves as given, which may be above the plane. Links
   are the last of the effects on a body, one of them for a body. Where the ends of a link are in one place, or
   cannot move along it, the run ends with VM_SINGULAR. Deviations of the length (> 0, m) die out as exp(-rate t),
   rate > 0 in 1/s; a cord that becomes taut at a speed v is drawn out by v/(e rate) at most. In float a cord of 1
   m at 5 m/s asks for a rate of not more than 200/s. The link acts at the mass centres, of which a growing body's
   is refused: it wanders. */
VM_API vm_effect vm_effect_link(int body, int other, vm_moving_point point, void *ctx, vm_real length, int cord,
                                vm_real rate)
{
    vm_effect e = vmi_effect(body, 0, other, 0, VMI_FLAT, length, rate, (vm_real)(cord != 0));
    e.order = 2;
    e.other_motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.apply = point || other >= 0 ? vmi_apply_link : NULL;
    e.check = vmi_link_check;
    e.point = point;
    e.ctx = ctx;
    return e;
}

#endif
/* scenes/state.h - the state of a scene */
#ifndef VARMASS_SCENES_STATE_H
#define VARMASS_SCENES_STATE_H

enum { VM_BUDGET = 15 };
#define VM_SCENE_WORK(size) (RK45_WORK(size) + (size))

/* numbers in the state; VM_BAD_ARGUMENT for null pointers */
VM_API int vm_scene_size(const vm_scene *scene)
{
    int i, size = scene && scene->book ? VM_BUDGET : 0;
    if (!scene || (scene->n_bodies > 0 && !scene->bodies)) return VM_BAD_ARGUMENT;
    for (i = 0; i < scene->n_bodies; i++) size += vmi_scene_body_size(scene->bodies + i);
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

/* Body 0 <= body < n_bodies of a scene that has been started as it moves in state y; where its mass is of a law, that
   when the right-hand side was last evaluated. NaN where there is no such body, for null pointers and before a
   start */
VM_API void vm_scene_body_at(const vm_scene *scene, int body, const vm_real *y, vm_body *now)
{
    const vm_vec3 none = {VM_NAN, VM_NAN, VM_NAN};
    if (!now) return;
    if (scene && scene->size && y && body >= 0 && body < scene->n_bodies) {
        vmi_scene_body_now(scene, body, y, now);
        return;
    }
    now->mass = now->q.w = now->q.x = now->q.y = now->q.z = VM_NAN;
    now->inertia.xx = now->inertia.yy = now->inertia.zz = VM_NAN;
    now->inertia.xy = now->inertia.xz = now->inertia.yz = VM_NAN;
    now->r = now->v = now->omega = none;
}

/* The state of a body that moves as now; its angle is given apart, since a turn more or less does not show in now */
VM_API void vmi_scene_put(vm_scene *s, int body, const vm_body *now, vm_real angle, vm_real *y)
{
    vm_scene_body *b = s->bodies + body;
    b->mass = now->mass;
    b->inertia = now->inertia;
    if (b->mass_is_state) y[b->mass_at] = now->mass;
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

#endif
/* scenes/evaluate.h - the right-hand side of a scene */
#ifndef VARMASS_SCENES_EVALUATE_H
#define VARMASS_SCENES_EVALUATE_H

#include <string.h>

/* Before the effects of an evaluation */
VM_INLINE void vmi_scene_clear(vm_scene_body *b, const vm_real *y, int book)
{
    vm_load *load = &b->load;
    load->force[0] = 0;
    if (b->coordinates > 1) load->force[1] = load->force[2] = 0;
    if (b->coordinates > 3) load->force[3] = load->force[4] = load->force[5] = 0;
    load->mass = b->mass_is_state ? y[b->mass_at] : b->mass;
    load->extra = load->by_v = load->mass_rate = 0;
    if (b->begin) b->begin(b, y + b->at);
    if (book) {
        memset(load->reactive, 0, sizeof load->reactive);
        memset(load->brought, 0, sizeof load->brought);
        load->brought_energy = load->mixing = 0;
    }
}

/* What acts on each body now */
VM_INLINE void vmi_scene_evaluate(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) vmi_scene_clear(s->bodies + i, y, s->book != NULL);
    for (i = 0; i < s->n_effects; i++) {
        const vm_effect *e = s->effects + i;
        if (!e->idle) e->apply(e, t, y, s);
    }
}

/* Why a body with this load cannot be accelerated */
VM_API int vmi_scene_mass_status(const vm_load *load)
{
    if (!VM_IS_FINITE(load->mass) || !VM_IS_FINITE(load->extra)) return VM_NOT_FINITE;
    return load->mass > 0 ? VM_NO_EFFECTIVE_MASS : VM_BAD_MASS;
}

VM_INLINE int vmi_scene_accelerate(const vm_scene_body *b, const vm_real *y, vm_real *dydt)
{
    const vm_load *load = &b->load;
    const vm_real effective = load->mass + load->extra;
    if (!(load->mass > 0 && effective > 0 && effective <= VM_MAX)) return vmi_scene_mass_status(load);
    if (b->mass_is_state) {
        if (!(y[b->mass_at] > 0)) return VM_BAD_MASS; /* whatever an effect has added to it */
        dydt[b->mass_at] = load->mass_rate;
    }
    return b->accelerate(b, y + b->at, dydt + b->at);
}

/* An ode_rhs; ctx is the scene, which has been started. Returns 0; where a mass is not positive or a body cannot be
   accelerated a derivative is NaN and scene.status says why, so that an integrator tries a shorter step. */
VM_API int vm_scene_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    vm_scene *s = (vm_scene *)ctx;
    int i, before;
    if (!s || !y || !dydt) return VM_BAD_ARGUMENT;
    before = s->status;
    s->status = VM_OK;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        const vm_scene_body *b = s->bodies + i;
        int k;
        if (b->away) {
            for (k = 0; k < vmi_scene_body_size(b); k++) dydt[b->at + k] = 0;
            continue;
        }
        k = vmi_scene_accelerate(b, y, dydt);
        if (k && !s->status) s->status = k;
    }
    if (s->book) s->book->rates(s, y, dydt + vm_scene_size(s) - VM_BUDGET);
    if (s->status) {
        dydt[0] = VM_NAN; /* the integrator tries a shorter step */
        if (before) s->status = before; /* of several in a row the first: the others follow from its NaN */
    }
    return 0;
}

#endif
/* scenes/check.h - what can be wrong in a scene */
#ifndef VARMASS_SCENES_CHECK_H
#define VARMASS_SCENES_CHECK_H

typedef struct VM_TAG(vm_scene_fault) {
    const char *kind; /* "body", "effect", "event", "scene" */
    int index;        /* which one, -1 for the scene itself */
} vm_scene_fault;

VM_API int vmi_scene_check_body(const vm_scene_body *b)
{
    if (b->status) return b->status;
    if (b->motion < VM_LINE || b->motion > VM_FREE || !b->put) return VM_BAD_MOTION;
    if (!vmi_body_finite(&b->start) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->start.mass > 0)) return VM_BAD_MASS;
    return b->check ? (b->check)(&b->start) : (int)VM_OK;
}

VM_API int vmi_scene_check_coordinate(const vm_scene *s, int body, int coordinate)
{
    if (body < 0 || body >= s->n_bodies) return VM_NO_SUCH_BODY;
    if (coordinate < 0 || coordinate >= s->bodies[body].coordinates) return VM_NO_SUCH_COORDINATE;
    /* of a free body's rotation there is no coordinate */
    return s->bodies[body].motion == VM_FREE && coordinate > 2 ? VM_NO_SUCH_COORDINATE : VM_OK;
}

/* Mass laws (order 0) first, links (order 2) last, at most one of either kind for a body, which keeps as marks the
   orders of the effects so far */
VM_API int vmi_scene_check_order(vm_scene_body *b, int order)
{
    const int law = 1, others = 2, link = 4, so_far = b->acted;
    b->acted |= 1 << order;
    if (order == 0 && ((so_far & law) || b->mass_is_state)) return VM_TWO_MASS_LAWS;
    if (order == 2 && (so_far & link)) return VM_TWO_LINKS;
    if (order == 0 && (so_far & (others | link))) return VM_BAD_ORDER;
    return order == 1 && (so_far & link) ? VM_LINK_NOT_LAST : VM_OK;
}

VM_API int vmi_scene_check_effect(const vm_scene *s, const vm_effect *e)
{
    int k, status = vmi_scene_check_coordinate(s, e->body, e->coordinate);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_coordinate(s, e->other, e->other_coordinate);
    if (status) return status;
    if (!e->apply) return VM_BAD_ARGUMENT;
    if (!(e->motions >> s->bodies[e->body].motion & 1)) return VM_BAD_MOTION;
    if (e->not_on_angle && s->bodies[e->body].motion == VM_PLANE && e->coordinate == 2) return VM_NOT_ON_ANGLE;
    if (e->other != VM_GROUND && !(e->other_motions >> s->bodies[e->other].motion & 1)) return VM_BAD_MOTION;
    if (e->order == 2 && e->other == e->body) return VM_SAME_BODY;
    /* a link holds mass centres, which in a growing body wander */
    if (e->order == 2 && (s->bodies[e->body].grows || (e->other >= 0 && s->bodies[e->other].grows)))
        return VM_BAD_MOTION;
    for (k = 0; k < (int)(sizeof e->p / sizeof *e->p); k++)
        if (!VM_IS_FINITE(e->p[k])) return VM_NOT_FINITE;
    if (e->needs_mass_state && !s->bodies[e->body].mass_is_state) return VM_MASS_IS_NO_STATE;
    if (e->needs_mass_state > 1 && !s->bodies[e->body].grows) return VM_DOES_NOT_GROW;
    if (e->check && (status = (e->check)(e)) != 0) return status;
    status = vmi_scene_check_order(s->bodies + e->body, e->order);
    return status || e->other < 0 ? status : vmi_scene_check_order(s->bodies + e->other, e->order);
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
    if (!status && e->jump_body == e->other) status = VM_SAME_BODY;
    if (status) return status;
    if (!vmi_scene_can_jump(s->bodies[e->jump_body].motion, s->bodies[e->other].motion)) return VM_BAD_MOTION;
    if (!(e->motions >> s->bodies[e->jump_body].motion & 1)) return VM_BAD_MOTION;
    if (!vmi_vec3_finite(j->linear) || !vmi_vec3_finite(j->couple) || !vmi_vec3_finite(j->at)) return VM_NOT_FINITE;
    if (e->jumps < 0) return VM_OK;
    part = s->bodies[e->other];
    part.start = e->part;
    return vmi_scene_check_body(&part);
}

VM_API int vmi_scene_check_event(const vm_scene *s, const vm_event *e)
{
    int status = VM_OK;
    if (e->watches && (status = vmi_scene_check_coordinate(s, e->body, e->coordinate)) != 0) return status;
    if (e->status) return e->status;
    if (e->most < 0) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(e->time) || !VM_IS_FINITE(e->value)) return VM_NOT_FINITE;
    if (e->switches && (e->effect < 0 || e->effect >= s->n_effects)) return VM_NO_SUCH_EFFECT;
    return e->check ? (e->check)(s, e) : status;
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
        if (i > 0 && !(s->times[i] > s->times[i - 1])) return VM_BAD_TIMES;
    }
    return VM_OK;
}

/* Everything that can be wrong with a scene: VM_OK, or what it is, and in *culprit (may be null) where. One pass over
   bodies, effects, events; it marks the bodies. */
VM_API int vm_scene_check(const vm_scene *scene, vm_scene_fault *culprit)
{
    vm_scene_fault c = {"scene", -1};
    int i, status = vmi_scene_check_arrays(scene);
    if (culprit) *culprit = c;
    if (status) return status;
    for (i = 0; !status && i < scene->n_bodies; i++) {
        scene->bodies[i].acted = 0;
        if ((status = vmi_scene_check_body(scene->bodies + i)) != 0) {
            c.kind = "body";
            c.index = i;
        }
    }
    for (i = 0; !status && i < scene->n_effects; i++)
        if ((status = vmi_scene_check_effect(scene, scene->effects + i)) != 0) {
            c.kind = "effect";
            c.index = i;
        }
    for (i = 0; !status && i < scene->n_events; i++)
        if ((status = vmi_scene_check_event(scene, scene->events + i)) != 0) {
            c.kind = "event";
            c.index = i;
        }
    if (culprit) *culprit = c;
    return status;
}

#endif
/* scenes/start.h - how a scene starts */
#ifndef VARMASS_SCENES_START_H
#define VARMASS_SCENES_START_H

#include <string.h>

/* Whether bodies, effects and events are those of the last start, as far as can be seen: a book may be given up */
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
    /* what is only counted, and without end, need not end a step */
    located->action = s->events[i].then || s->events[i].most ? ODE_STOP : ODE_RECORD;
}

/* Where an effect finds what it needs, so that it need not look for it at each evaluation */
VM_API void vmi_scene_bind(vm_scene *s, vm_effect *e)
{
    vm_scene_body *b = s->bodies + e->body, *other = e->other >= 0 ? s->bodies + e->other : NULL;
    e->idle = e->off != 0;
    e->load = &b->load;
    e->other_load = NULL;
    e->x = b->at + e->coordinate;
    e->v = e->x + b->positions;
    e->other_x = e->x;
    e->other_v = e->v;
    if (!other) return; /* other_coordinate may be anything then */
    e->other_load = &other->load;
    e->other_x = other->at + e->other_coordinate;
    e->other_v = e->other_x + other->positions;
}

/* Checks the scene, and makes the state at the start: vm_scene_size numbers */
VM_API int vm_scene_start(vm_scene *scene, vm_real t, vm_real *y, vm_scene_fault *culprit)
{
    int i, k, at = 0, status = vm_scene_check(scene, culprit);
    if (status) return status;
    if (!y) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (scene->y_size && scene->y_size < vm_scene_size(scene)) return VM_SHORT_ARRAY;
    scene->size = vm_scene_size(scene);
    for (i = 0; i < scene->n_bodies; i++) {
        vm_scene_body *b = scene->bodies + i;
        b->at = at;
        b->mass_at = at + vmi_scene_mass_at(b);
        b->away = b->absent;
        b->jumped = 0;
        for (k = 0; k < vmi_scene_body_size(b); k++) y[at++] = 0;
        vmi_scene_put(scene, i, &b->start, b->angle, y);
    }
    for (i = 0; i < scene->n_effects; i++) vmi_scene_bind(scene, scene->effects + i);
    for (i = 0; i < scene->n_events; i++) {
        vm_event *e = scene->events + i;
        e->scene = scene;
        e->count = e->seen = 0;
        if (e->when) e->time = t;
        vmi_scene_locate(scene, i);
    }
    vmi_scene_presence(scene);
    vmi_scene_evaluate(scene, t, y);
    scene->status = VM_OK;
    if (scene->book) scene->book->open(scene, y, y + at);
    return VM_OK;
}

#endif
/* scenes/balance.h - the book of momentum, angular momentum and energy */
#ifndef VARMASS_SCENES_BALANCE_H
#define VARMASS_SCENES_BALANCE_H

#include <string.h>

VM_INLINE void vmi_add3(vm_vec3 a, vm_real *d) {
d[0] += a.x;
d[1] += a.y;
d[2] += a.z; }

/* What a body's load adds to the book by the second: impulse, angular impulse, momentum and angular momentum brought,
   work, energy brought, mixing */
VM_API void vmi_scene_enter_loads(const vm_scene_body *b, const vm_real *y, vm_real *d)
{
    const vm_load *load = &b->load;
    const vm_vec3 at = vmi_scene_moving(b, y + b->at);
    const vm_vec3 force = vmi_sub(vmi_scene_moving(b, load->force), vmi_scene_moving(b, load->reactive));
    const vm_vec3 torque = vmi_sub(vmi_scene_turning(b, load->force), vmi_scene_turning(b, load->reactive));
    const vm_vec3 brought = vmi_scene_moving(b, load->brought);
    vmi_add3(force, d);
    vmi_add3(vmi_add(torque, vmi_cross(at, force)), d + 3);
    vmi_add3(brought, d + 6);
    vmi_add3(vmi_add(vmi_scene_turning(b, load->brought), vmi_cross(at, brought)), d + 9);
    d[12] += vmi_dot(force, vmi_scene_moving(b, y + b->at + b->positions)) + vmi_dot(torque, vmi_scene_spin(b, y));
    d[13] += load->brought_energy;
    d[14] += load->mixing;
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
    for (i = 0; i < VM_BUDGET; i++) rates[i] = 0;
    for (i = 0; i < s->n_bodies; i++)
        if (!s->bodies[i].away) vmi_scene_enter(s->bodies + i, y, rates);
}

/* Momentum, angular momentum about the origin and kinetic energy of all bodies that are there */
VM_API void vmi_scene_totals(const vm_scene *s, const vm_real *y, vm_budget *book)
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
        vmi_scene_body_now(s, i, y, &now);
        if (b->motion == VM_AXLE) now.mass = 0;
        p = vmi_scale(now.mass, now.v);
        spin = vmi_spin_momentum(&now);
        book->momentum = vmi_add(book->momentum, p);
        book->angular_momentum = vmi_add(book->angular_momentum, vmi_add(spin, vmi_cross(now.r, p)));
        book->energy += (vmi_dot(p, now.v) + vmi_dot(spin, now.omega)) / 2;
    }
}

VM_API void vmi_scene_open_book(vm_scene *s, const vm_real *y, vm_real *sums)
{
    const vm_budget hooks = *s->book;
    int i;
    memset(s->book, 0, sizeof *s->book);
    s->book->open = hooks.open;
    s->book->rates = hooks.rates;
    s->book->totals = hooks.totals;
    vmi_scene_totals(s, y, s->book);
    for (i = 0; i < VM_BUDGET; i++) sums[i] = 0;
}

/* Before vm_scene_start: the scene keeps book of momentum, angular momentum and energy, in VM_BUDGET more numbers of
   the state; NULL: no longer */
VM_API void vm_scene_keep_budget(vm_scene *scene, vm_budget *book)
{
    if (!scene) return;
    scene->book = book;
    if (!book) return;
    memset(book, 0, sizeof *book);
    book->open = vmi_scene_open_book;
    book->rates = vmi_scene_rates;
    book->totals = vmi_scene_totals;
}

/* Momentum, angular momentum and energy in state y, what came in since the start, and the defects: what rounding and
   the integrator's errors leave, and what a constraint takes (a line, an axle, the plane hold their bodies).
   VM_BAD_ARGUMENT where there is no book. */
VM_API int vm_scene_budget_at(vm_scene *scene, vm_real t, const vm_real *y, vm_budget *book)
{
    const vm_budget *start = scene ? scene->book : NULL;
    const vm_real *d;
    vm_budget b;
    if (!start || !y || !book) return VM_BAD_ARGUMENT;
    if (!vmi_scene_is_started(scene)) return VM_NOT_STARTED;
    b = *start;
    d = y + vm_scene_size(scene) - VM_BUDGET;
    vmi_scene_evaluate(scene, t, y);
    vmi_scene_totals(scene, y, &b);
    b.impulse = vmi_add(start->impulse, vmi_vec3(d[0], d[1], d[2]));
    b.angular_impulse = vmi_add(start->angular_impulse, vmi_vec3(d[3], d[4], d[5]));
    b.brought = vmi_vec3(d[6], d[7], d[8]);
    b.brought_angular = vmi_vec3(d[9], d[10], d[11]);
    b.work = d[12];
    b.brought_energy = d[13];
    b.mixing = d[14];
    b.momentum_defect = vmi_sub(vmi_sub(b.momentum, start->momentum), vmi_add(b.impulse, b.brought));
    b.angular_defect = vmi_sub(vmi_sub(b.angular_momentum, start->angular_momentum),
                               vmi_add(b.angular_impulse, b.brought_angular));
    b.energy_defect = b.energy - start->energy - (b.work + b.brought_energy - b.mixing + b.jump_energy);
    *book = b;
    return VM_OK;
}

#endif
/* scenes/events.h - events of a scene and what they do */
#ifndef VARMASS_SCENES_EVENTS_H
#define VARMASS_SCENES_EVENTS_H

#include <string.h>

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

/* Events: one at a time happens once, a crossing (direction > 0 rising, < 0 falling, 0 both) as often as it may, or
   event.most times. A crossing is what motion does: what jumps over the value does not cross it. At one instant
   events happen in their order; where a jump comes within rounding of a crossing, either may come first. Nothing of a
   body that is not there crosses anything. If no vm_then_... says what happens, an event is only counted:
   event.count says how often it was, event.time when it was last, and the motion is what it would be without the
   event. Set scene.located[i].times (or states) and room after the start to get the times (or states) of all events
   of one run. */
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

/* passes value */
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

/* Documented with vm_event_at. */
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

/* > 0: a mass of 0 cannot be accelerated */
VM_API vm_event vm_event_mass(int body, vm_real value, int direction)
{
    vm_event e = vmi_event(body, 0, value, direction);
    e.when = vmi_when_mass;
    return e;
}

VM_API vm_real vmi_when_user(const vm_event *e, vm_real t, const vm_real *y) { return e->user_when(t, y, e->ctx); }

/* Documented with vm_event_at. */
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

/* ... and what happens then, one thing an event: vm_then_switch(vm_event_at(60), tap, 1). The run ends with
   VM_STOPPED; an effect goes off (1) or on (0); a part leaves body and becomes into, which was absent; added becomes
   a part of body and is no longer there; then is called, may change y, and returns a status (VM_STOPPED, < 0 end the
   run).
   A part is described as the instant after, in inertial axes; where relative is set, in the body's axes, r from its
   mass centre, q, v and omega relative to the body as it moves there. In the plane and on an axle into takes the
   body's angle, plus the angle with which it was made. event.external is an impulse from outside during the jump.
   A jump is between bodies of one motion, or between a body in the plane or free and a point. The run ends with
   VM_IS_THERE if `into` is there already, with VM_IS_AWAY if `body` or `added` is not there; the other errors are
   those of vm_separate.
   A point that takes up a body elsewhere than where it is loses the spin of the two: angular_defect has it. */
VM_API vm_event vm_then_stop(vm_event event)
{
    event.then = vmi_then_stop;
    return event;
}

/* Events switch effects on and off, also mass laws. A mass must not jump at that moment, since nothing would carry
   off the mass and its momentum. So the masses are noted before the event and restored after it: a law then goes on
   from the mass that is there. */
VM_API void vmi_scene_note_masses(vm_scene *s)
{
    int i;
    for (i = 0; i < s->n_bodies; i++) s->bodies[i].held = s->bodies[i].load.mass;
}

VM_API void vmi_scene_hold_masses(vm_scene *s, vm_real t, const vm_real *y)
{
    int i;
    vmi_scene_evaluate(s, t, y);
    for (i = 0; i < s->n_bodies; i++) {
        vm_scene_body *b = s->bodies + i;
        const vm_real more = b->held - b->load.mass;
        if (b->away || b->mass_is_state) continue;
        b->mass += more;
        b->jumped += more; /* a body uses only one of them: `jumped` if it has a mass law */
    }
    vmi_scene_evaluate(s, t, y);
}

VM_API int vmi_then_switch(vm_event *e, vm_real t, vm_real *y)
{
    vm_scene *s = e->scene;
    vm_effect *effect = s->effects + e->effect;
    vmi_scene_evaluate(s, t, y);
    vmi_scene_note_masses(s);
    effect->idle = (effect->idle & 2) | e->off;
    vmi_scene_hold_masses(s, t, y);
    return VM_OK;
}

/* Documented with vm_then_stop. */
VM_API vm_event vm_then_switch(vm_event event, int effect, int off)
{
    event.then = vmi_then_switch;
    event.effect = effect;
    event.off = off != 0;
    event.switches = 1;
    return event;
}

VM_API int vmi_then_user(vm_event *e, vm_real t, vm_real *y) { return e->user_then(t, y, e->then_ctx); }

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_user(vm_event event, int (*then)(vm_real t, vm_real *y, void *ctx), void *ctx)
{
    event.then = vmi_then_user;
    if (!then) event.status = VM_BAD_ARGUMENT;
    event.user_then = then;
    event.then_ctx = ctx;
    return event;
}

#endif
/* scenes/jumps.h - separation and attachment as events */
#ifndef VARMASS_SCENES_JUMPS_H
#define VARMASS_SCENES_JUMPS_H

/* The angle of a body in the plane or on an axle, which may be more than a turn */
VM_API vm_real vmi_scene_angle(const vm_scene *s, int body, const vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    return b->motion == VM_PLANE ? y[b->at + 2] : y[b->at];
}

/* (M v + m v2 + impulse)/(M + m), m < 0 for a part that separates, and m/(M + m) of the way to its mass centre */
VM_API int vmi_event_jump_single(const vm_event *e, const vm_body *body, const vm_body *other, vm_body *b)
{
    const vm_real m = e->jumps > 0 ? -other->mass : other->mass, mass = body->mass + m;
    *b = *body;
    if (!(mass > 0)) return VM_BAD_MASS;
    b->mass = mass;
    b->v.x = (body->mass * body->v.x + m * other->v.x + e->external.linear.x) / mass;
    b->omega.z = (body->mass * body->omega.z + m * other->omega.z + e->external.couple.z) / mass;
    b->r.x = body->r.x + m / mass * (other->r.x - body->r.x);
    return VM_OK;
}

/* On a line and on an axle, whose own numbers the other's formulas leave alone: they are 0 */
VM_API int vmi_event_jump_on_line(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    if (e->relative) {
        other->r.x += body->r.x;
        other->v.x += body->v.x;
        other->omega.z += body->omega.z;
    }
    return vmi_event_jump_single(e, body, other, b);
}

/* Where a part is whose motion is relative to the body */
VM_API void vmi_event_jump_place(const vm_body *body, vm_body *part)
{
    const vmi_mat3 turn = vmi_rotation(body->q);
    const vm_vec3 d = vmi_times(&turn, part->r);
    part->r = vmi_add(body->r, d);
    part->v = vmi_add(vmi_times(&turn, part->v), vmi_add(body->v, vmi_cross(body->omega, d)));
    part->omega = vmi_add(vmi_times(&turn, part->omega), body->omega);
    part->q = vmi_quat_is_none(part->q) ? body->q : vmi_quat_times(body->q, part->q);
}

VM_API vm_body2 vmi_scene_to_plane(const vm_body *b)
{
    vm_body2 flat;
    flat.mass = b->mass;
    flat.inertia = b->inertia.zz;
    flat.x = b->r.x;
    flat.y = b->r.y;
    flat.angle = 0;
    flat.vx = b->v.x;
    flat.vy = b->v.y;
    flat.omega = b->omega.z;
    return flat;
}

VM_API int vmi_event_jump_in_plane(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const vm_impulse *external = &e->external;
    vm_body2 one, two, flat;
    vm_impulse2 blow;
    int status;
    if (e->relative) vmi_event_jump_place(body, other);
    one = vmi_scene_to_plane(body);
    two = vmi_scene_to_plane(other);
    blow.jx = external->linear.x;
    blow.jy = external->linear.y;
    blow.couple = external->couple.z;
    blow.x = external->at.x;
    blow.y = external->at.y;
    status = e->jumps > 0 ? vm_separate2(&one, &two, &blow, &flat) : vm_attach2(&one, &two, &blow, &flat);
    if (status < 0) return status;
    *b = *body;
    b->mass = flat.mass;
    b->inertia.zz = flat.inertia;
    b->r.x = flat.x;
    b->r.y = flat.y;
    b->v.x = flat.vx;
    b->v.y = flat.vy;
    b->omega.z = flat.omega;
    return flat.inertia > 0 ? VM_OK : VM_BAD_INERTIA; /* a rest that is a point cannot move on as a body */
}

VM_API int vmi_event_jump_any(const vm_event *e, const vm_body *body, vm_body *other, vm_body *b)
{
    const int motion = e->scene->bodies[e->jump_body].motion;
    if (motion == VM_LINE || motion == VM_AXLE) return vmi_event_jump_on_line(e, body, other, b);
    if (motion == VM_PLANE) return vmi_event_jump_in_plane(e, body, other, b);
    if (e->relative) vmi_event_jump_place(body, other);
    return e->jumps > 0 ? vm_separate(body, other, &e->external, b) : vm_attach(body, other, &e->external, b);
}

/* The mass centre of a growing body, which a jump moves to r, moves in the body, too */
VM_API void vmi_scene_shift(const vm_scene *s, int body, vm_vec3 r, vm_real *y)
{
    const vm_scene_body *b = s->bodies + body;
    vm_real *state = y + b->at;
    vm_vec3 step;
    if (!b->grows) return;
    step = vmi_times_transposed(&b->axes, vmi_sub(r, vmi_scene_moving(b, state)));
    vmi_growth_put_centre(b, vmi_add(vmi_growth_centre(b, state), step), state);
}

VM_API void vmi_scene_jumped(vm_event *e, vm_real t, vm_real *y, int into_is_new, const vm_body *b,
                             const vm_body *other)
{
    vm_scene *s = e->scene;
    vm_budget before, after;
    const vm_real angle = vmi_scene_angle(s, e->jump_body, y);
    if (s->book) s->book->totals(s, y, &before);
    vmi_scene_note_masses(s);
    s->bodies[e->jump_body].held = b->mass;
    if (into_is_new) s->bodies[e->other].held = other->mass;
    s->bodies[e->other].away = !into_is_new;
    vmi_scene_shift(s, e->jump_body, b->r, y);
    if (into_is_new && s->bodies[e->other].grows)
        vmi_growth_put_centre(s->bodies + e->other, vmi_vec3(0, 0, 0), y + s->bodies[e->other].at);
    if (into_is_new) vmi_scene_put(s, e->other, other, angle + s->bodies[e->other].angle, y);
    vmi_scene_put(s, e->jump_body, b, angle, y);
    vmi_scene_presence(s);
    vmi_scene_hold_masses(s, t, y);
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
    if (e->scene->bodies[e->jump_body].away) return VM_IS_AWAY;
    if (!e->scene->bodies[e->other].away) return VM_IS_THERE;
    vmi_scene_evaluate(e->scene, t, y);
    vmi_scene_body_now(e->scene, e->jump_body, y, &body);
    status = e->jump(e, &body, &part, &rest);
    if (status < 0) return status;
    vmi_scene_jumped(e, t, y, 1, &rest, &part);
    return VM_OK;
}

/* The same, of bodies on a line or on an axle, or in the plane, which link no more than that (docs/scene-sizes.md) */
VM_API vm_event vm_then_separate_on_line(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event.then = vmi_then_separate;
    if (!part) event.status = VM_BAD_ARGUMENT;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_body = body;
    event.other = into;
    event.jumps = 1;
    event.relative = relative;
    if (part) event.part = *part;
    return event;
}

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_separate_in_plane(vm_event event, int body, int into, const vm_body *part, int relative)
{
    event = vm_then_separate_on_line(event, body, into, part, relative);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* Documented with vm_then_stop. */
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
    vmi_scene_jumped(e, t, y, 0, &whole, NULL);
    return VM_OK;
}

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_attach_on_line(vm_event event, int body, int added)
{
    event.then = vmi_then_attach;
    event.check = vmi_scene_check_jump;
    event.jump = vmi_event_jump_on_line;
    event.motions = VMI_SINGLE;
    event.jump_body = body;
    event.other = added;
    event.jumps = -1;
    event.relative = 0;
    return event;
}

/* Documented with vm_then_separate_on_line. */
VM_API vm_event vm_then_attach_in_plane(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_in_plane;
    event.motions = 1 << VM_PLANE;
    return event;
}

/* Documented with vm_then_stop. */
VM_API vm_event vm_then_attach(vm_event event, int body, int added)
{
    event = vm_then_attach_on_line(event, body, added);
    event.jump = vmi_event_jump_any;
    event.motions = VMI_ALL_MOTIONS;
    return event;
}

#endif
/* scenes/run.h - runs of a scene */
#ifndef VARMASS_SCENES_RUN_H
#define VARMASS_SCENES_RUN_H

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
VM_API int vmi_scene_fire_events(vm_scene *s, vm_real t, vm_real *y, vmi_scene_pace *pace)
{
    int i, status = VM_OK;
    for (i = 0; i < s->n_events && status >= 0; i++) {
        vm_event *e = s->events + i;
        const ode_event *found = s->located + i;
        const long times = found->count - e->seen; /* negative as a run begins, which counts anew */
        const int now = e->when ? times > 0 : e->count == 0 && e->time <= t;
        int result;
        if (e->when) e->seen = found->count;
        if (!now || (e->most && e->count >= e->most)) continue;
        if (e->when && found->action == ODE_RECORD) {
            e->count += times;
            e->time = found->t;
            continue;
        }
        if (e->when && e->count && t - e->time < pace->gap) pace->gap = t - e->time;
        if (e->when) e->time = t;
        e->count++;
        pace->happened++;
        result = e->then ? e->then(e, t, y) : (int)VM_OK;
        if (result < 0 || status == VM_OK) status = result;
    }
    return status;
}

/* All events of an instant, since events may cause events. Events that follow one another faster and faster, as the
   contacts of a ball that comes to rest, are the end of the run where the time no longer resolves them; until then
   the step after such an event is short enough to see the next. */
VM_API int vmi_scene_run_events(vm_scene *s, rk45 *r, vm_real span, vmi_scene_pace *pace)
{
    const long most = 10000; /* at one instant */
    const vm_real resolved = 256 * VM_EPSILON * span;
    int status = VM_OK;
    for (pace->happened = 0, pace->gap = VM_MAX; status == VM_OK;) {
        const long before = pace->happened;
        status = vmi_scene_fire_events(s, r->t, r->y, pace);
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
    vmi_scene_evaluate(s, t, y);
    return s->output(t, y, s, s->output_ctx) ? VM_STOPPED : VM_OK;
}

/* Whether a mass or an inertia would soon run out if the state went on at its present rates: tries longer and
   longer steps, up to a millionth of the time (float: a thousandth), and returns the first status that is not
   VM_OK. A mass or an inertia on its way to 0 makes the equations so stiff that no step gets beyond 0; and after a
   refused step shorter ones may have succeeded, so that s->status is VM_OK again. The run is over, so its work has
   room for a state and its rates. */
VM_API int vmi_scene_foresee(vm_scene *s, rk45 *r, vm_real t_end)
{
    const vm_real farthest = VM_MANT_DIG > 24 ? VM_C(1e-6) : VM_C(1e-3);
    const vm_real size = VM_FABS(r->t) > VM_FABS(t_end) ? VM_FABS(r->t) : VM_FABS(t_end);
    vm_real *z = vmi_part(r, VMI_Z), *rates = vmi_part(r, VMI_K), step;
    int i;
    for (step = 4 * VM_EPSILON * size; step < farthest * size; step *= 4) {
        vm_scene_rhs(r->t, r->y, rates, s);
        if (s->status) return s->status;
        for (i = 0; i < r->n; i++) z[i] = r->y[i] + step * rates[i];
        vm_scene_rhs(r->t + step, z, rates, s);
        if (s->status) return s->status;
    }
    return VM_OK;
}

/* Why a run ends: a body that cannot be accelerated, if there is one, or what the integrator says */
VM_API int vmi_scene_gave_up(vm_scene *s, rk45 *r, vm_real t_end, int ode)
{
    if (ode == ODE_MAX_STEPS) return VM_MAX_STEPS;
    if (!s->status) vmi_scene_foresee(s, r, t_end);
    if (s->status) return s->status;
    if (ode == ODE_NOT_FINITE) return VM_NOT_FINITE;
    return ode == ODE_STEP_TOO_SMALL ? VM_STEP_TOO_SMALL : VM_NOT_INTEGRATED;
}

/* One step, or up to the next time at which something is due */
VM_API int vmi_scene_step(vm_scene *s, rk45 *r, vm_real t_end, int next)
{
    const int output = s->output && s->times && next < s->n_times && s->times[next] < t_end;
    const vm_real stop = vmi_scene_due(s, output ? s->times[next] : t_end);
    const int ode = vmi_run(r, VMI_RK45, vm_scene_rhs, r->n, stop, 1);
    if (ode >= 0) return VM_OK;
    s->ode_status = ode;
    return vmi_scene_gave_up(s, r, t_end, ode);
}

/* rk45 on the scene. Each number of the state has its tolerance, the book none: it follows the bodies' steps. */
VM_API int vmi_scene_integrator(vm_scene *s, rk45 *r, vm_real t, const vm_real *y, vm_real *work,
                                const rk45_options *options_or_NULL)
{
    rk45_options o = rk45_defaults(options_or_NULL);
    const int n = vm_scene_size(s), booked = s->book ? VM_BUDGET : 0;
    vm_real *atol = work + RK45_WORK(n);
    int i;
    for (i = 0; i < n; i++) atol[i] = i >= n - booked ? VM_MAX : o.atol_each ? o.atol_each[i] : o.atol;
    o.atol_each = atol;
    o.events = s->located;
    o.n_events = s->n_events;
    if (!vmi_all_finite(n, y)) return VM_NOT_FINITE;
    s->ode_status = rk45_init(r, vm_scene_rhs, s, n, t, y, &o, work);
    r->attempts = o.max_steps;
    return s->ode_status < 0 ? (int)VM_BAD_OPTIONS : (int)VM_OK;
}

/* On from *t to t_end >= *t by rk45, events included: VM_OK, VM_STOPPED before t_end, or what went wrong; *t and y
   are where the run ended. work: VM_SCENE_WORK(vm_scene_size) numbers. The options' own events are not used. Events
   that do not end are VM_TOO_MANY_EVENTS: more than 10 000 at one instant, or four times in succession again after
   less than 256 eps of the time. VM_BAD_MASS or VM_BAD_INERTIA: a mass or an inertia ran out, even if the steps
   became too short just before that. VM_NOT_FINITE: an effect, a law or an event gave NaN or infinity.
   VM_STEP_TOO_SMALL, VM_MAX_STEPS and VM_BAD_OPTIONS come from the integrator, whose own status is in
   scene.ode_status. */
VM_API int vm_scene_run(vm_scene *scene, vm_real *t, vm_real t_end, vm_real *y, vm_real *work,
                        const rk45_options *options_or_NULL)
{
    vmi_scene_pace pace = {0, 0, 0};
    int next = 0, status;
    vm_real span;
    rk45 r;
    if (!scene || !t || !y || !work) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(*t) || !VM_IS_FINITE(t_end)) return VM_NOT_FINITE;
    if (t_end < *t) return VM_BAD_TIMES;
    if (!vmi_scene_is_started(scene)) return VM_NOT_STARTED;
    status = vm_scene_size(scene);
    if (scene->y_size && scene->y_size < status) return VM_SHORT_ARRAY;
    if (scene->work_size && scene->work_size < VM_SCENE_WORK(status)) return VM_SHORT_ARRAY;
    scene->status = VM_OK;
    status = vmi_scene_integrator(scene, &r, *t, y, work, options_or_NULL);
    if (status) return status;
    span = VM_FABS(*t) > VM_FABS(t_end) ? VM_FABS(*t) : VM_FABS(t_end);
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
