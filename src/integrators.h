/* integrators.h - ordinary differential equations y' = f(t, y) by explicit Runge-Kutta methods

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include "integrators.h"
       static int spring(double t, const double *y, double *dydt, void *ctx)
       {
           (void)t;   // which this spring does not need
           (void)ctx;
           dydt[0] = y[1];
           dydt[1] = -y[0] * y[0] * y[0];
           return 0;
       }
       int main(void)
       {
           double y0[2] = {1, 0}, work[RK45_WORK(2)];
           rk45 s;
           rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work);
           return rk45_solve(&s, 10.0) < 0; // the result is in s.y, at s.t
       }

   METHODS, and which one when (times: bench/bench_integrators, x'' = -x^3 to t = 100, gcc -O2, one machine)
     rk4    the classical method of order 4, fixed step: where every step must cost the same, as in a control loop.
            rk4_solve_compensated keeps the roundings of millions of steps from adding up, for 10 % more time.
     rk45   Tsitouras' pair of orders 5 and 4 [1]: 7 stages of which the last is the next step's first, PI step size
            control [2], continuous extension of order 4 for nothing. The default: for float, for f that is not
            smooth at loose tolerances, for many events or much dense output.
     rk87   Verner's pair of orders 8 and 7 [4]: 13 stages, continuous extension of order 8 for 7 more evaluations.
            The fastest for a smooth f in double; its roundings are larger: rtol >= 256 eps, no use in float.
     microseconds to an error of   1e-4   1e-6   1e-8   1e-10
       rk4                           29     79    235    720
       rk45                          26     56    126    299
       rk87                          16     25     38     61
     Stiff equations want an implicit method, which is not here; the adaptive runs say so (ODE_STIFF).

   CONVENTIONS
     f gets t, the n values y, room for the n derivatives and the caller's ctx; it returns 0, or anything else to stop
     the run. t may run backward. Lengths of time are in whatever unit t has.
     Memory is the caller's: work has RK4_WORK(n), RK45_WORK(n) or RK87_WORK(n) numbers and must live as long as the
     rk45 does. An rk45, its work and its events are all the state there is. An rk87 is an rk45 that rk87_init made;
     the functions of the other method refuse it.

   STEP SIZE CONTROL
     A step is accepted when |error_i| <= atol + rtol max(|y_i|, |y_i after the step|) for every component, error
     being the difference of the two orders (the higher one is kept). The next step is chosen by PI control; one whose
     error was within 0.25 .. 0.75 of the tolerance (rk87: 0.1 .. 0.75) is followed by one of the same size. Options:
     an rk45_options whose zero fields mean the defaults, a negative tolerance none; rk45_defaults() shows what they
     come to. The tolerance is for each step: at the end of a long run the error is larger, in proportion to it.
     No step is shorter than h_min, or than 2 eps |t|, which is what t can resolve. If even a step of this smallest
     size misses the tolerance, the cause is taken to be a jump of f: the step is accepted, s.missed counts it, and
     the run goes on behind the jump. If another such step misses before three steps have kept the tolerance, f is
     singular there, or too stiff for t, and the run ends with ODE_STEP_TOO_SMALL. If the two steps follow each
     other directly, in one call of rk45_solve without events, both are dropped, so that s.t and s.y are where the
     trouble begins.

   TIME
     A step ends at a time that the type can hold, and its length is exactly the difference of the two times. So s.t
     does not drift away from the motion, however far from 0 the run began and however many steps it takes. If a
     step is so short that this would change its length by more than 1/64, or if it ends at an event, y belongs to a
     time between two numbers of the type: s.t is then the nearest number, and the run carries the difference along.

   EVENTS
     An event happens when g(t, y) reaches zero or changes its sign. It is located on the continuous extension, and
     is recorded, ends the run, or restarts it there. Every event happens once, also if several lie in one step, at
     its end or at the same instant, and after rk45_restart. Events whose times rounding cannot tell apart happen
     together: all are counted, and their `change` functions are called in the order of the list, before the run
     stops or goes on. At a stop s.y is on the far side of the zero (or on it). If g stays 0 for a while, the event
     happens when g reaches 0, not when it leaves 0; if g jumps, the event happens at the jump. After an event the
     sign of g counts again once rounding cannot have caused it, so that a motion that is reversed on contact does
     not touch twice. An even number of zeros between two looks at g is not seen: set `checks` to look more often,
     or a smaller h_max.

   RIGHT-HAND SIDES THAT ARE NOT SMOOTH (x'' = -x|x|^(alpha-1), ten periods; bench/bench_integrators)
     The step size control finds the bad points and takes some short steps there: at alpha = 0.5 and tolerance 1e-7,
     rk45 takes 4976 evaluations, against 2102 at alpha = 1, and rk87 takes 7321, against 1146. No error estimate is
     right in a step in which f jumps: the error at the end is up to 3e4 tolerances with rk45 and rk87, whatever
     the tolerance is, so run again with a tighter one and compare. If f has smooth branches (a sign,
     x|x|), keep the branch in ctx and change it at an ODE_RESTART event: rk45 at alpha = 0 then takes 160
     evaluations instead of 5102, and the error at the end is 3e-4 tolerances, not 6800. A restart does not pay if f
     still chooses its branch itself. docs/toronto.md has the errors and evaluations of both methods on the Toronto
     test set, whose class F has jumps.

   STATUS
     0 (ODE_OK) success, positive numbers information, negative ones errors; ode_strerror() names them. After an error
     s.t and s.y are the last accepted step's, for f's own refusal too (its value is in s.rhs_status). Where f or the
     state is not finite the step is shortened until it is too small; so a run ends next to where f ceases to exist.
     A call that refuses its arguments changes nothing.

   SPEED
     With f static and n <= 8 a constant, and rk45_init's status looked at before rk45_solve in the same function, f
     is inlined and the state is in registers; where the compiler cannot see that s still has that f and n, say
     rk45_solve_with. Otherwise f is called through a pointer, and the state is in work. gcc -O2, against hand-written
     loops: rk4 0.61 to 0.95 times the loop; rk45 0.57 to 0.66 times a Dormand-Prince loop's time to an error of 1e-6,
     1/3.1 to 1/3.5 of GSL's rkf45; rk87 0.37 to 0.45 times GSL's rk8pd to 1e-10 (Arenstorf's orbit: 0.49, 1e-8).

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_INLINE            linkage of what has to be inlined for speed; VM_API makes smaller code with the same results
     VM_SQRT, VM_FABS     the functions of the C library that are used (all of the shared block's, if any)
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; both or none. Default: static const
                          and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables take no RAM
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, where the checks for NaN do not work
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for zero.
     vm_self_check() returns 0 there, and 1 where all is well; a program may call it once when it starts.

   REFERENCES
     [1] Ch. Tsitouras, Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption,
         Computers & Mathematics with Applications 62 (2011) 770-775.
     [2] E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993:
         II.4 (first step, step size control), II.6 (continuous extensions); E. Hairer, G. Wanner, volume II, 1996:
         IV.2 (PI control, stiffness).
     [3] E. Hairer, R. I. McLachlan, A. Razakarivony, Achieving Brouwer's law with implicit Runge-Kutta methods,
         BIT 48 (2008) 231-243 (compensated summation).
     [4] J. H. Verner, Numerically optimal Runge-Kutta pairs with interpolants, Numerical Algorithms 53 (2010)
         383-396: the "most efficient" pair of orders 8 and 7. tests/gen/order_conditions.py checks every order
         condition of all coefficients here.

   INDEX
@INDEX@ */
#ifndef VARMASS_INTEGRATORS_H
#define VARMASS_INTEGRATORS_H

#include "base/self_check.h"
#include "integrators/rk4.h"
#include "integrators/adaptive.h"

#endif
