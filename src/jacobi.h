/* jacobi.h - Jacobi's elliptic functions, complete elliptic integrals, and the modulus from its quarter period

   Part of varmass (MIT licence), usable alone: copy this one file, include it, link with -lm.

       #include <stdio.h>
       #include "jacobi.h"
       int main(void)
       {
           double sn, cn, dn;
           jacobi_sncndn(1.2, 0.3, &sn, &cn, &dn);
           printf("K(0.3) = %.16g, cn(1.2 | 0.3) = %.16g\n", jacobi_K(0.3), cn);
           return 0;
       }

   CONVENTIONS
     The second argument is the parameter m = k^2, not the modulus k: jacobi_K(0.25) is K for k = 1/2 (Boost and
     C++17 take k, GSL's Kcomp too, GSL's elljac, SciPy and Mathematica m). Any m <= 1 is allowed, negative ones
     included. m1 = 1 - m is the complementary parameter, k' = sqrt(m1) the complementary modulus; the forms with
     suffix _m1 take or return m1 where m would have lost its digits (m towards 1).
     The period of sn and cn is 4 K(m), that of dn 2 K(m). All arguments are pure numbers.

   WHAT TO CALL
     jacobi_sncndn        the three functions for one u and one m; twelve quotients and the amplitude singly
     jacobi_plan_init     where m stays: the plan is prepared once, then jacobi_plan_sncndn, or .._array for many u.
                          A plan is plain data and may be a constant in flash; examples/jacobi_plan prints one. On
                          AVR copy it from there to RAM, by memcpy_P, before it is used.
     jacobi_solve_kpK     m from k'K(k^2), jacobi_solve_K m from K
     jacobi_agm_...       the same functions by the arithmetic-geometric mean, with its steps counted

   ERRORS
     m > 1, m1 < 0, c < 0, NaN and infinite arguments give NaN; m = 1 gives the limits: K infinite, E = 1,
     sn = tanh, cn = dn = sech, at u = +-infinity too. A quotient at a pole is infinite. A plan refuses a bad m
     with -1 and stays as it was. Nothing else can fail. No allocation, no state; errno says nothing.

   METHOD
     Where u^2 max(1, 1 - m) is small, cs^2(u/4 | m) by its Laurent series and two duplications [1, 5], which need
     neither K nor roots but one; u beyond about K/2 is reduced before, with the quarter period in as many words as
     its distance from a zero asks for: two steps of the AGM and a series, the AGM in two words, in three. Far from 0
     for m near 1 or below -20 theta functions of an imaginary phase [1], with the nome of 1 - m or 1/(1 - m), which
     is then at most 0.003. A plan has polynomials in u^2 in place of the series. Nothing cancels, at m = 1 neither.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API, VM_INLINE    linkage of the functions, default static inline (forced where loops must vectorise)
     VM_SQRT, VM_FLOOR .. the functions of the C library that are used (all of them, if any)
     VM_TABLE, VM_READ    storage of the tables, and how an element of one is read; both or none. Default: static const
                          and (x); on AVR static const PROGMEM and pgm_read_float(&(x)), so that tables take no RAM
     VM_ALLOW_FAST_MATH   compile under -ffast-math or a part of it, where no bound below holds
   On x87 units gcc in its gnu modes (gcc -m32, no -std=c99) keeps excess precision, with which neither the bounds
   below nor symmetry to the bit hold: -fexcess-precision=standard, or -msse2 -mfpmath=sse, mends it.
   Names that begin with vmi_ or VMI_ are internal.

   OPTIONS THAT CHANGE VALUES
     -ffast-math, its parts (-funsafe-math-optimizations, -fassociative-math, -freciprocal-math, -ffinite-math-only,
     -fno-signed-zeros), /fp:fast and -fsingle-precision-constant make results wrong. The headers do not compile where
     the compiler's macros show such an option. clang's macros show only -ffast-math and -ffinite-math-only, and no
     macro shows "#pragma float_control", another rounding mode, or that the processor takes subnormal numbers for zero.
     vm_self_check() returns 0 there, and 1 where all is well; a program may call it once when it starts.

   ACCURACY AND COST, measured (make test, scan, bench; docs/measurements.md, cost.md), inputs taken as exact
     sn, cn, dn   absolute error <= 4 eps max(1, k') for |u| <= 1e9 and 2^40 K (float 1e4, 2^17 K); from K/eps on u
                  holds no phase, and sn = 0, cn = dn = 1. Relative error <= 8 ulp for |u| <= 100 K, at and
                  next to the zeros too (float: but for u within 1/2000 ulp of one, where K's words end at 2^-55). A
                  plan is as accurate.
     others       K and E <= 2 ulp, k'K <= 4 ulp, means of cn^2, cn^4, cn^6 <= 8 ulp, quotients and am 8 ulp;
                  solvers: m and m1 within 4 ulp and what one ulp of c moves them.
     Time         in units of the C library's sin in a row of independent calls (in a chain, where each waits for the
                  one before), gcc -O2, without fused multiply-adds: K 1.3 (1.5), E 1.5 (1.4); sn+cn+dn for |u| < K/2
                  2.5 to 2.8 (2), for |u| < 2K 6.3 to 6.9 (3.6), to 1e9 13 to 15 (6); by a plan 2.5 (1.6), for
                  m > 0.955 and m < -21.5 5.2 (3.1); in an array 0.6, or there 1.1, by gcc -O3 -march=native, 1.2
                  or 5.7 by -O2; solve_kpK 4.4 to 43; preparing a plan about 180.
     Size         a plan has 304 bytes (float 112); the largest stack frame is about 1 kB.

   REFERENCES
     [1] DLMF, chapters 19, 20 and 22, dlmf.nist.gov: 19.8 (AGM), 20.2, 20.7, 22.2 (theta functions), 22.20.
     [2] R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions, Numer. Math. 7 (1965) 78-90.
     [3] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [4] L. Cveticanin, Dynamics of Mass Variable System, dissertation; equation numbers like (307) are its.
     [5] DLMF, 23.9 (Laurent series of Weierstrass' function), 22.6 (duplication).

   INDEX
@INDEX@ */
#ifndef VARMASS_JACOBI_H
#define VARMASS_JACOBI_H

#include "base/self_check.h"
#include "jacobi/integrals.h"
#include "jacobi/functions.h"
#include "jacobi/amplitude.h"
#include "jacobi/plans.h"
#include "jacobi/modulus.h"
#include "jacobi/means.h"
#include "jacobi/descending.h"
#include "jacobi/third_kind.h"

#endif
