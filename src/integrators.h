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

   METHODS, and when to take which method
     rk4    the classical method of order 4 with fixed steps, for control loops, where every step must take the same
            time. In rk4_solve_compensated the rounding errors of millions of steps do not add up.
     rk45   Tsitouras' pair of orders 5 and 4 [1] chooses the size of its steps so that the error stays within a
            tolerance. A step takes six evaluations of f; the solution inside a step takes no further evaluation. Begin
            with this method. It is also the best one in float, for an f that is not smooth, for loose tolerances, for
            many events and for output at many times.
     rk87   Verner's pair of orders 8 and 7 [4]. A step takes 13 evaluations of f, and seven more if the run has events
            or the caller asks for the solution inside the step. It is the fastest for a smooth f in double. Its
            rounding errors are larger than those of rk45: rtol is at least 256 eps (eps is 2.2e-16, in float 1.2e-7),
            which is too coarse for most uses in float.
     None of these methods is meant for stiff equations, in which stability and not accuracy limits the step size; these
     need an implicit method. rk45 and rk87 report an equation that looks stiff (ODE_STIFF). docs/cost.md has the time
     that each method needs for a given error.

   CONVENTIONS
     The right-hand side f gets t, the n numbers y, room for the n derivatives, and the caller's pointer ctx. It returns
     0, or any other number to stop the run. t may run backward. All times and steps have the unit of t.
     The caller owns the memory: work has RK4_WORK(n), RK45_WORK(n) or RK87_WORK(n) numbers and must live as long as the
     rk45 does. An rk45, its work and its events contain the whole state of a run. An rk87 is an rk45 that rk87_init
     made. The functions of rk45 refuse it, and those of rk87 refuse an rk45 that rk45_init made. Only rk45_restart and
     rk87_restart, which do the same, accept both.

   STEP SIZE CONTROL
     A step gives two results, one of each order of the pair. Their difference is the estimate of the error; the run
     goes on with the result of the higher order. A step is accepted when |error_i| <= atol + rtol max(|y_i|, |y_i after
     the step|) for every component i. The size of the next step is chosen by a proportional-integral (PI) control [2]
     from the errors of the last two steps. The step size stays the same after an error of 0.25 to 0.75 of the tolerance
     (rk87: 0.1 to 0.75).
     The tolerance is for each step; the error at the end of a run is larger, in proportion to the length of the run.
     A zero in rk45_options means the default. A negative rtol or atol counts as 0; a negative number in atol_each is an
     error. rk45_defaults() fills in the defaults.
     No step is shorter than h_min, or than 2 eps |t|, the resolution of t, except a step that ends at t_end or at an
     event. If even a step of this smallest size misses the tolerance, the run assumes a jump of f: it accepts the step,
     counts it in s.missed, and goes on after the jump. If another such step misses the tolerance before three steps
     have kept it, the run ends with ODE_STEP_TOO_SMALL: f is then singular there, or too stiff for the resolution of t.
     If the two steps follow each other directly, in one call of rk45_solve without events, both are dropped: s.t and
     s.y are then those before both steps.

   TIME
     A step ends at a time that is a number of the type, and its length is the difference of the times at its two ends,
     rounded to the type (exact for a step shorter than |t|/2). So s.t does not drift away from the motion, however far
     from 0 the run began and however many steps it takes. There are two exceptions: a step so short that rounding the
     time of its end would change its length by more than 1/64, and a step that ends at an event. Then y belongs to a
     time between two numbers of the type, s.t is the nearer of them, and the run stores the difference.

   EVENTS
     An event happens when g(t, y) reaches zero or changes its sign. The run finds the time of the event on the
     continuous extension, a polynomial that gives the state anywhere inside a step. It then records the event
     (ODE_RECORD), ends there (ODE_STOP), or restarts there (ODE_RESTART). Every event is found exactly once, even if
     several events lie in one step, at its end or at the same instant, and after rk45_restart too.
     Events whose times differ by no more than rounding errors happen together: all are counted, and their `change`
     functions are called in the order of the list, before the run stops or goes on. After a stop, g(s.t, s.y) of an
     event that happened alone is 0 or already has its new sign; of several that happened together, this is certain for
     one. If g stays 0 for a while, the event happens when g reaches 0, not when it leaves 0. If g jumps, the event
     happens at the jump. After an event the sign of g is ignored as long as rounding errors alone could cause it. So
     one contact of a body that bounces off the ground is one event.
     A run ends at each event with the action ODE_STOP. An event with stop_after > 0 is different: whatever its action
     is, it ends the run only when it has happened stop_after times, twice as many times, and so on. The t_end of such a
     run may be infinite. Set h_max in this case if the solution is so smooth that the steps would grow without end.
     Two zeros, or any even number of them, between two evaluations of g are not found. A larger `checks` or a smaller
     h_max makes evaluations more frequent.

   OUTPUT AND SAVED RUNS
     rk45_solve_at and rk87_solve_at fill a table with the states at listed times, without shortening the steps.
     rk45_save and rk87_save write a run to an array of bytes; rk45_resume and rk87_resume continue it. The results have
     the same bits as those of a run without interruption.

   RIGHT-HAND SIDES THAT ARE NOT SMOOTH
     The step size control finds the places where f is not smooth and takes some short steps there. No error estimate is
     right in a step in which f jumps: the error at the end may be thousands of tolerances, so run again with a tighter
     tolerance and compare. If f consists of smooth branches, such as those of a sign or of |x|, store the present
     branch in ctx and change it at an ODE_RESTART event: the run then needs far fewer evaluations, and its error is
     small again. For this, f must take the branch from ctx and must not choose it itself. docs/toronto.md has the
     errors and the numbers of evaluations of f for the Toronto test set of equations; the equations of its class F have
     jumps.

   STATUS
     0 (ODE_OK) is success; positive numbers are information, negative ones errors; ode_strerror() gives the text. After
     an error s.t and s.y are those of the last accepted step, also if f itself stopped the run (the value that f
     returned is in s.rhs_status). Where f or the state is not finite, the run tries shorter and shorter steps until
     they are too small. So it ends close to the last point at which f is finite. A call with wrong arguments changes
     nothing.

   SPEED
     The compiler inlines f and keeps the state in registers if f is static, n <= 8 is a constant, and one function
     calls rk45_init, tests its status, and calls rk45_solve. Where the compiler cannot see which f and n belong to s,
     call rk45_solve_with, which gets them as arguments once more. Otherwise f is called through a pointer, and the
     state is in work.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double (tests run both)
     VM_API               linkage of the functions; the default is static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If it is defined as VM_API,
                          the code is smaller and the results are the same.
     VM_FABS, VM_COPYSIGN the functions of the C library that are used; vm_self_check() also uses VM_SQRT and VM_FLOOR.
                          Define all four or none.
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. The defaults
                          are static const and (x); on AVR they are static const PROGMEM and pgm_read_float(&(x)), so
                          that tables take no RAM
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but the checks for NaN do not work
                          then
     VM_MIXED_PRECISIONS  allows a program in which some files define VM_USE_FLOAT and others do not. Without it gcc and
                          MSVC, and clang for Windows, refuse to link such a program.
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. But clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor treats subnormal numbers, the
     smallest of all, as zero. vm_self_check() returns 0 in these cases, and 1 where all is well; a program may call it
     once when it starts.

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

#include "base/real.h"

VMI_QUIET_BEGIN

#include "base/self_check.h"
#include "integrators/rk4.h"
#include "integrators/rk45.h"
#include "integrators/rk87.h"
#include "integrators/output.h"
#include "integrators/saved.h"

VMI_QUIET_END

#endif
