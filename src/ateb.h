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

   CONVENTIONS
     The variable comes first, then the parameter alpha, any real number >= 0; results come last. All arguments are
     pure numbers. Names are those of the dissertation [1], and numbers like (275) are its equations: sa always means
     sa(1, alpha, s), and ca always means ca(alpha, 1, s). Both have the period 2 Pi_alpha. An oscillator m x'' + k
     x|x|^(alpha-1) = 0 with amplitude A moves by x = A ca and x' = -sqrt(2/(alpha+1)) omega A^((alpha+1)/2) sa, where
     omega = sqrt(k/m).

   WHAT THE FUNCTIONS ARE
     v = sa and u = ca solve v' = u|u|^(alpha-1), u' = -2 v/(alpha+1) with v(0) = 0 and u(0) = 1 (275), where ' is the
     derivative with respect to s. So v^2 + |u|^(alpha+1) = 1 (279), and in the first quarter, 0 <= s <= Pi_alpha/2, v^2
     is an inverse incomplete beta function of s: s = (1/2) B_(v^2)(1/2, 1/(alpha+1)).
     alpha = 0              sa is a triangular wave, ca consists of arcs of parabolas
     alpha = 1              sa = sin, ca = cos
     alpha = 3              sa = sqrt(2) sn dn and ca = cn of the argument s/sqrt(2) and the parameter 1/2
     alpha to infinity      sa tends to tanh s; as a function of s/Pi_alpha it tends to a square wave
     With the generalised sine sin_(p,q) of other authors, and p = (alpha+1)/alpha,
     sa = sin_(p,2)(s) and ca = sin_(2,alpha+1)((Pi_alpha - 2s)/(alpha+1)).

   WHAT TO CALL
     ateb_saca             sa and ca for one s and one alpha; ateb_sa and ateb_ca return one of them
     ateb_pi               Pi_alpha, half the period
     ateb_plan_init        prepares a plan for one alpha; then call ateb_plan_saca for one s, or ateb_plan_saca_array
                           for many s. ateb_plan_init_to makes a shorter and quicker plan of less accuracy. A plan is
                           plain data and may be a constant in flash; examples/print_plan prints one. On AVR copy it
                           from there to RAM, by memcpy_P, before it is used.
     ateb_phase            s from sa and ca, as atan2 computes an angle from its sine and cosine
     ateb_mean             the mean of |sa|^p |ca|^q over a period (316); ateb_mean_nm takes two indices and the signs
                           of sa and ca into account
     ateb_integral_...     integrals of sa^2 and of |ca|^(alpha+1) from 0 to s
     ateb_saca_nm          sa(n, m, s) and ca(m, n, s) with any two indices
     ateb_beta...          beta function, incomplete beta function and its inverse
     ateb_ln_beta...       logarithms of the beta functions, where these overflow or underflow

   ERRORS
     alpha < 0, NaN and infinite arguments give NaN; so do probabilities outside [0, 1], parameters of beta functions
     outside 1e-4 to 1e5 (for ateb_ln_beta outside 1e-30 to 1e30; but the parameters 0 and infinity give limits), and
     all arguments outside the domain that the comment of a function gives. For a bad alpha ateb_plan_init returns -1
     and leaves the plan as it was. Nothing else can fail. The functions allocate no memory and keep no state; errno
     says nothing about their errors.

   METHOD
     First s is reduced to the first quarter of the period, which needs Pi_alpha. Pi_alpha comes from a table of
     polynomials. Where s is large or close to a zero, Pi_alpha needs more digits: it comes from one polynomial in two
     or three words (a word is one number of the type; a sum of three words has three times the digits). In the first
     quarter the incomplete beta function is inverted. An approximation of sa is taken as exact, and the s that belongs
     to it is computed by a continued fraction of 12 levels (float 6) and one power. A Taylor series then corrects sa
     and ca for the difference from the given s.
     A plan has polynomials for two parts of a quarter: Taylor series that solve (275), shortened to the accuracy that
     is wanted.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double; the tests run both
     VM_API               linkage of every function; the default is static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If it is defined as VM_API,
                          the code is smaller and the results are the same.
     VM_SQRT, VM_FABS, VM_FLOOR, VM_COPYSIGN
                          the functions of the C library that are used; define all four or none. Where the compiler says
                          that fma is fast (FP_FAST_FMA, in float FP_FAST_FMAF), fma is used, too. All these functions
                          round correctly, so that results are the same on every machine, unless the compiler fuses
                          products and sums.
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; define both or none. The defaults
                          are static const and (x); on AVR they are static const PROGMEM and pgm_read_float(&(x)), so
                          that tables take no RAM
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but none of the bounds below holds
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
     once when it starts. On x87 units gcc in its gnu modes (gcc -m32, no -std=c99) computes with more digits than the
     type has (excess precision). Then the bounds below do not hold, and odd and even functions may lose their symmetry
     in the last bit. The options -fexcess-precision=standard, or -msse2 -mfpmath=sse, prevent this.

   ACCURACY: bounds of the error, which the tests check; docs/measurements.md has the errors found.
     eps, ulp               eps is 2.2e-16 (float 1.2e-7). An ulp is the distance between two neighbouring numbers of
                            the type, next to the true value. The bounds take the inputs as exact.
     sa, ca                 absolute error <= 4 eps for |s| <= 1e9 (float 1e4), relative error <= 8 ulp for
                            |s| <= 100 Pi_alpha, for alpha = 0 and alpha from 1e-300 to 1e30. Between their extremes sa
                            and ca only rise or only fall, apart from errors of 2 ulp. sa^2 + |ca|^(alpha+1) is 1 to
                            within 1.5 eps (2 sa^2 + (alpha+1) |ca|^(alpha+1)).
     the zeros              of sa and ca have a relative error <= 2^-125 (float 2^-58); for alpha above 5e8 (float 2e4)
                            and for plans in float, it is <= 2^-100 (float 2^-42). This error, times |s| and the slope
                            of sa or ca, comes in addition to the errors above. It matters only where s is within an
                            ulp of a zero.
     Pi_alpha               <= 1 ulp
     sa, ca by a plan       <= 2 ulp for |s| <= 100 Pi_alpha and alpha up to 1e6, or the absolute error that the plan
                            was made for
     phase                  <= 8 ulp plus the change of s that 6 ulp of sa and of ca make, where sa and ca come from
                            ateb_saca
     beta, mean, Pi(n, m)   <= 1 ulp, 2 ulp and 1 ulp, in this order
     beta_inc               <= 30 ulp of p = I_x(a, b) and of q = 1 - p
     beta_inc_inv           <= 16 ulp of x and of y = 1 - x, plus the change that one ulp of the smaller of p and q
                            makes
     sa(n, m), ca(m, n)     <= 8 ulp plus the change that an error of 2^-102 |s| (float 2^-44 |s|) in s makes
     integrals              the integrals of sa^2 and |ca|^(alpha+1) add up to s within 3 eps (1 + |s|)

   COST
     docs/cost.md has the times of the functions that are used most, docs/counts.md the number of instructions of a call
     of nearly all. An ateb_plan has 560 [ateb_plan_bytes] bytes, in float 184 [ateb_plan_bytes_float]; the name in
     brackets is that of the row of docs/numbers.md with this number. On processors with wide vector registers
     ateb_plan_saca_array needs 4 to 6 kB of stack (float 2 to 3 kB); the stack frame of any other function is below 2
     kB.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation; numbers like (277) are its equations. Where [1]
         has a misprint, this file uses the corrected equation: in [1], (278) and (280) mix up the indices and have a
         wrong sign, and (279) lacks the bars of |u|.
     [2] R. M. Rosenberg, The Ateb(h)-functions and their properties, Q. Appl. Math. 21 (1963) 37-47.
     [3] DLMF, dlmf.nist.gov: 8.17 (incomplete beta functions), 15.7 (continued fractions), 15.8(iii) (quadratic
         transformations).
     [4] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [5] C. Lanczos, Applied Analysis, Prentice-Hall 1956: economisation of power series.
     [6] A. R. Didonato, A. H. Morris, Algorithm 708, ACM Trans. Math. Softw. 18 (1992) 360-373.

   INDEX
@INDEX@ */
#ifndef VARMASS_ATEB_H
#define VARMASS_ATEB_H

#include "base/real.h"

VMI_QUIET_BEGIN

#include "base/self_check.h"
#include "ateb/period.h"
#include "ateb/functions.h"
#include "ateb/phase.h"
#include "ateb/integrals.h"
#include "ateb/plans.h"
#include "ateb/beta.h"
#include "ateb/beta_inverse.h"
#include "ateb/two_indices.h"

VMI_QUIET_END

#endif
