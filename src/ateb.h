/* ateb.h - Ateb functions: sine and cosine of the oscillator x'' + x|x|^(alpha-1) = 0

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include <stdio.h>
       #include "ateb.h"
       int main(void)
       {
           double sa, ca;
           ateb_saca(0.7, 1.5, &sa, &ca);
           printf("sa = %.16g, ca = %.16g, period %.16g\n", sa, ca, 2 * ateb_pi(1.5));
           return 0;
       }

   WHAT THEY ARE
     v = sa(1, alpha, s) and u = ca(alpha, 1, s) solve v' = u|u|^(alpha-1), u' = -2 v/(alpha + 1), v(0) = 0,
     u(0) = 1 (275). So v^2 + |u|^(alpha+1) = 1 (279), and v^2 is an inverse incomplete beta function of s:
     s = (1/2) B_(v^2)(1/2, 1/(alpha+1)) for 0 <= s <= Pi_alpha/2.
     alpha = 1 gives sin and cos; alpha = 3 gives ca = cn(s/sqrt 2 | 1/2) and sa = sqrt 2 sn dn; alpha = 0 gives
     sa a triangular wave and ca arcs of parabolas; for alpha to infinity sa tends to tanh s, on the scale of the
     period to a square wave. In terms of the generalised sine, with p = (alpha+1)/alpha:
     sa(1, alpha, s) = sin_(p,2)(s), ca(alpha, 1, s) = sin_(2,alpha+1)((Pi_alpha - 2 s)/(alpha+1)).

   CONVENTIONS
     The variable comes first, then the real parameter alpha >= 0. Names and arguments are the dissertation's [1]:
     sa here is always sa(1, alpha, .), ca always ca(alpha, 1, .), the pair that makes up x and x' of one
     oscillator, x = A ca, x' = -sqrt(2/(alpha+1)) omega A^((alpha+1)/2) sa. All arguments are pure numbers.

   ERRORS
     alpha < 0, NaN and infinite arguments give NaN, as do parameters of beta functions that are not positive and
     probabilities outside [0, 1]. Making a plan for such an alpha returns -1 and leaves the plan as it was. Nothing
     else can fail. No allocation, no state; errno says nothing.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; both or none. Default: static const
                          and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables take no RAM
     VM_SQRT, VM_FABS, VM_FLOOR, VM_COPYSIGN   the functions of the C library that are used; they are exact, so that
                          results are the same everywhere where products and sums are not contracted
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, where no bound below holds
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for zero.
     vm_self_check() returns 0 there, and 1 where all is well; a program may call it once when it starts.

   METHOD
     Pi_alpha - (alpha + 1) from a table of polynomials, to 2^-66 (float 2^-36), or, where s is large or near to a
     zero, Pi_alpha from one polynomial in two or three words. Below s = 0.55, and at the same distance from every
     zero of sa, an approximation of sa is taken as exact and its s found; beyond it one of (1 - sa)/2, whose phase
     is compared in logarithms. From there Taylor's series leads to s. So one inversion of the incomplete beta
     function takes a continued fraction of 12 levels (float 6) and a power, (1 - sa^2)^(1/(alpha+1)), near the zeros
     of ca three logarithms instead. What does not wait for Pi_alpha is made beside it.
     A plan holds polynomials for two parts of a quarter, series from (275) economised to the accuracy that is wanted.

   ACCURACY, measured (make test, points, scan), inputs taken as exact
     sa, ca       absolute error <= 4 eps for |s| <= 1e9 (float 1e4); relative error <= 8 ulp for |s| <= 100
                  Pi_alpha, for alpha = 0 and 1e-300 to 1e30. The largest found is 2.8 ulp. From one s to the next sa
                  and ca step back by 2 ulp at most, by more than 1 in 20 of a million; sa^2 + |ca|^(alpha+1) - 1 is
                  within 1.2 eps (2 sa^2 + (alpha+1) |ca|^(alpha+1)).
     the zeros    lie where Pi_alpha in three words puts them, to a relative error of 2^-125 (float 2^-58), for alpha
                  beyond 5e8 (float 2e4) and for plans in two, 2^-102 (float 2^-44). This times |s| and the slope
                  comes on top of the relative error; it is felt where s is within an ulp of the zero.
     Pi_alpha     <= 1 ulp, 0.5 found.
     plan         <= 2 ulp, 1.93 found (float 1.97), for all of these s and alpha to 1e6; or the accuracy that was
                  asked for
     phase        within 4 ulp and what an ulp of sa and of ca moves it
     beta, mean, Pi(n, m)   <= 1, 2, 1 ulp
     beta_inc     <= 30 ulp, typically 2, of p and of q
     beta_inc_inv <= 16 ulp of x and of y, and what an ulp of the smaller of p and q moves them, 3 found typically
     sa(n, m), ca(m, n)     <= 8 ulp, 2.2 found, but for an error of phase of 2^-102 |s| (float 2^-44)
     integrals    some 10 ulp

   COST, in units of the C library's sin (float: sinf) for |s| < 10, gcc 12 on two Xeons and an EPYC, where sin takes
   7 to 9 ns and has fused multiply-adds whatever the flags; make bench shows it by alpha, docs/cost.md one of the runs
                                              -O2         -O3 -march=native, contracted   float, -O2
     Pi_alpha                                 1.2 to 1.7  0.9 to 1.2    1.1           2.2 to 2.4
     sa+ca, any alpha, Pi_alpha included      8 to 14     7.5 to 12.5   8.3 to 11     15 to 24
       for |s| < 1/2, times of sin there      7.5         6.4
       the same for |s| > 128 Pi_alpha        27
       on a zero of sa or ca, to an ulp       250
     plan, alpha = 0, 1/2, 1, ..., 7          1.2 to 3.2  1 to 2.8      1 to 1.9      2.4 to 4.8
       to 1e-4                                1.1 to 2.3  0.9 to 2.1    1 to 1.5      2.2 to 4.3
       in arrays (with -fno-math-errno)       the same    0.23 to 1.1   0.6 to 0.8    the same
     plan, any other alpha                    3.3 to 7.2  3 to 5.6      2.6 to 4      5.1 to 9.2
     ateb_plan is 552 bytes (float 184), made in 15 us; stack up to 0.6 kB (float 0.4), 1.6 kB (0.6) while it is made.
     ateb_phase 10 x sin, ateb_beta 0.7 us, ateb_beta_inc 1 us, its inverse 8 us, 35 us where a and b are some 1e4,
     ateb_saca_nm 19 us.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation; equation numbers like (277) are its, in
         corrected form where they are misprinted: (278), (280) mix up the indices and a sign, (279) lacks the bars.
     [2] R. M. Rosenberg, The Ateb(h)-functions and their properties, Q. Appl. Math. 21 (1963) 37-47.
     [3] DLMF, dlmf.nist.gov: 8.17 (incomplete beta functions), 15.8(iii) (quadratic transformations).
     [4] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [5] C. Lanczos, Applied Analysis, Prentice-Hall 1956: economisation of power series.
     [6] A. R. Didonato, A. H. Morris, Algorithm 708, ACM Trans. Math. Softw. 18 (1992) 360-373.

   INDEX
@INDEX@ */
#ifndef VARMASS_ATEB_H
#define VARMASS_ATEB_H

#include "base/self_check.h"
#include "ateb/period.h"
#include "ateb/functions.h"
#include "ateb/phase.h"
#include "ateb/integrals.h"
#include "ateb/plans.h"
#include "ateb/beta.h"
#include "ateb/two_indices.h"

#endif
