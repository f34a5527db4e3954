/* jacobi.h - Jacobi's elliptic functions, elliptic integrals, and the modulus from its quarter period

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
     The functions sn(u | m), cn(u | m) and dn(u | m) are defined by an angle phi, the amplitude: u is the integral of
     dx/sqrt(1 - m sin^2 x) from 0 to phi, and sn = sin phi, cn = cos phi, dn = sqrt(1 - m sin^2 phi). K(m) is the same
     integral from 0 to pi/2. sn and cn have the period 4 K(m), dn has the period 2 K(m); K is the quarter period.
     The variable is the first argument, then comes the parameter; the results come last. The parameter is m = k^2, not
     the modulus k: jacobi_K(0.25) is K for k = 1/2. In SciPy, Mathematica and GSL's elljac the argument is m, too; in
     Boost, C++17 and GSL's Kcomp the argument is k. Any m <= 1 is allowed, also a negative m. The complementary
     parameter is m1 = 1 - m, the complementary modulus k' = sqrt(m1). The functions with the suffix _m1 take or return
     m1. Use them where m is close to 1: m1 then has all its digits, while a computed difference 1 - m has only a few.
     All arguments are pure numbers; angles are in radians.

   WHAT TO CALL
     jacobi_sncndn        sn, cn and dn for one u and one m; the twelve quotients and the amplitude have functions of
                          their own
     jacobi_sncndn_any    sn, cn and dn for m > 1 too, as a rotating pendulum needs them
     jacobi_K, jacobi_E, jacobi_Pi, jacobi_D
                          complete elliptic integrals of the first, second and third kind; D is (K - E)/m
     jacobi_F, jacobi_E_incomplete, jacobi_Pi_incomplete, jacobi_D_incomplete
                          incomplete elliptic integrals from 0 to any angle phi; F is the inverse function of the
                          amplitude. For m > 1 these integrals have values up to phi = arcsin(1/sqrt(m)).
     jacobi_inverse_sn    u from sn(u | m); jacobi_inverse_cn and jacobi_inverse_dn do the same for cn and dn
     jacobi_RF            Carlson's integrals R_F, R_C, R_D, R_J, R_G; all other elliptic integrals are sums of these
     jacobi_plan_init     prepares a plan, the numbers that depend only on m; then call jacobi_plan_sncndn for one u, or
                          jacobi_plan_sncndn_array for many u. A plan is plain data and may be a constant in flash;
                          examples/print_plan prints such a constant. On AVR a plan in flash must be copied to RAM, by
                          memcpy_P, before the plan is used.
     jacobi_solve_kpK     m from the value of k'K(m); jacobi_solve_K returns m from the value of K(m)
     jacobi_cn_means      mean values of cn^2, cn^4 and cn^6 over a period
     jacobi_agm_...       sn, cn, dn and K by the classical method, the arithmetic-geometric mean (see METHOD);
                          jacobi_agm_sncndn takes the number of its steps as an argument

   ERRORS
     These arguments give NaN: m > 1, or m1 < 0 in functions that take m1 = 1 - m (jacobi_sncndn_any and the incomplete
     integrals allow both); c < 0 in the functions jacobi_solve_...; arguments outside the domain that the comment of a
     function gives; NaN; and infinite numbers, with two exceptions. The first exception: jacobi_K, jacobi_E, jacobi_D,
     jacobi_Pi, the incomplete integrals, the inverses of sn and cn, and Carlson's integrals return the limit at an
     infinite argument, and NaN where there is no limit. The second: m = 1 gives the limits, for u = +-infinity too: K
     is infinite, E is 1, sn is tanh u, cn and dn are 1/cosh u. But jacobi_agm_sncndn gives NaN for m = 1.
     A quotient such as sn/cn is infinite at its poles, where the denominator is 0. For m > 1 and for an infinite or NaN
     m, jacobi_plan_init returns -1 and leaves the plan as it was. No other error is possible. The functions allocate no
     memory and keep no state; errno says nothing about their errors.

   METHOD
     Where u^2 max(1, 1 - m) is small, (cn/sn)^2 at u/4 is computed by its power series (a Laurent series, whose first
     term is a multiple of 1/u^2). Then two duplications, each of which doubles the argument, lead from u/4 to u [1, 5].
     This method needs one square root, but not K.
     If |u| is above about K/2, a multiple of the quarter period K is subtracted from u first. The closer u is to a zero
     of sn or cn, the more digits of K are needed. K comes from a table, from two steps of the arithmetic-geometric mean
     and a series, or from more steps in two or three words. A step of this mean replaces two numbers by their
     arithmetic and their geometric mean. A word is one number of the type; a sum of two or three words has two or three
     times the digits.
     For m near 1 or below about -21, u^2 max(1, 1 - m) may still be large after this subtraction. Then theta functions
     of an imaginary argument are used [1]. They are series in powers of the nome of 1 - m or of 1/(1 - m), where the
     nome of m is the number exp(-pi K(1 - m)/K(m)). The nome is here at most 0.003, so that few terms are enough.
     The incomplete integrals and the inverses use Carlson's duplication, which brings the arguments of an integral
     closer together, and then a power series up to the terms of degree 10 (float 4). For the incomplete integrals a
     multiple of pi is subtracted from the angle first. Where jacobi_sncndn uses the Laurent series, a plan has
     polynomials in the square of the reduced u. No subtraction loses digits, not even for m = 1.

   MACROS, to be defined before the include
     VM_USE_FLOAT         all numbers are float instead of double; the tests run both
     VM_API               linkage of every function; the default is static inline
     VM_INLINE            linkage of the functions that are fast only if they are inlined. If VM_INLINE is defined as
                          VM_API, the code is smaller and the results are the same.
     VM_SQRT, VM_FABS, VM_FLOOR, VM_COPYSIGN
                          the functions of the C library that are used; define all four or none. Where the compiler
                          says that fma is fast (FP_FAST_FMA, in float FP_FAST_FMAF), fma is used, too. All these
                          functions round correctly, so that results are the same on every machine, unless the compiler
                          fuses products and sums.
     VM_TABLE, VM_READ    VM_TABLE is the storage of the tables, and VM_READ(x) reads x, an element of a table; define
                          both or none. The defaults are static const and (x); on AVR they are static const PROGMEM and
                          pgm_read_float(&(x)), so that tables take no RAM
     VM_ALLOW_FAST_MATH   lets the headers compile under -ffast-math or a part of it, but none of the bounds below holds
                          then
     VM_MIXED_PRECISIONS  allows a program in which some files define VM_USE_FLOAT and others do not. Without this macro
                          gcc and MSVC, and clang for Windows, refuse to link such a program.
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
     eps, ulp     eps is 2.2e-16 (float 1.2e-7). An ulp is the distance between two neighbouring numbers of the type,
                  next to the true value. The bounds take the inputs as exact.
     sn, cn, dn   absolute error <= 4 eps max(1, k') for |u| <= 1e9 and |u| <= 2^40 K (float 1e4 and 2^17 K). Relative
                  error <= 9 ulp for |u| <= 100 K, at the zeros and next to them too (in float, except where u is
                  within a millionth of an ulp of a zero). A plan is as accurate. For |u| >= K/eps the digits of u do
                  not tell at which point of a period u lies: then sn = 0 and cn = dn = 1.
     K, E         <= 2 ulp
     k'K          <= 5 ulp
     means        <= 8 ulp, for the means of cn^2, cn^4 and cn^6
     quotients    <= 8 ulp, for sn/cn and the other quotients; the amplitude has the same bound
     F, E, D, Pi  <= 8 ulp for |phi| <= 1e9 (float 1e4) and n <= 1; the comment of jacobi_Pi_incomplete has the bound
                  for n > 1
     inverses of sn, cn and dn, Carlson's integrals   <= 8 ulp; R_G <= 10 ulp; the comment of jacobi_RJ has the bound of
                  R_J
     m > 1        the absolute bounds of sn, cn, dn hold with k u in place of u; the comment of jacobi_sncndn_any has
                  the relative bound
     solvers      <= 4 ulp of m and of m1, plus the change of m or m1 that one ulp of the argument c of
                  jacobi_solve_... makes

   COST
     docs/cost.md has the times of the functions that are used most, docs/peers.md those of the incomplete integrals and
     of R_F and R_J, docs/counts.md the number of instructions of a call of many functions. A jacobi_plan has 312
     [jacobi_plan_bytes] bytes, in float 116 [jacobi_plan_bytes_float]; the name in brackets is that of the row of
     docs/numbers.md with this number. The largest stack frame is about 1 kB; that of jacobi_plan_sncndn_array has up to
     3 kB where the compiler vectorises its loop for wide registers.

   REFERENCES
     [1] DLMF, chapters 19, 20 and 22, dlmf.nist.gov: 19.8 (AGM), 20.2, 20.7, 22.2 (theta functions), 22.20.
     [2] R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions, Numer. Math. 7 (1965) 78-90.
     [3] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [4] L. Cveticanin, Dynamics of Mass Variable System, dissertation; numbers like (307) are its equations.
     [5] DLMF, 23.9 (Laurent series of Weierstrass' function), 22.6 (duplication).
     [6] B. C. Carlson, Numerical computation of real or complex elliptic integrals, Numer. Algorithms 10 (1995) 13-26.

   INDEX
@INDEX@ */
#ifndef VARMASS_JACOBI_H
#define VARMASS_JACOBI_H

#include "base/real.h"

VMI_QUIET_BEGIN

#include "base/self_check.h"
#include "jacobi/integrals.h"
#include "jacobi/functions.h"
#include "jacobi/amplitude.h"
#include "jacobi/plans.h"
#include "jacobi/modulus.h"
#include "jacobi/means.h"
#include "jacobi/descending.h"
#include "jacobi/third_kind.h"
#include "jacobi/carlson.h"
#include "jacobi/above_one.h"
#include "jacobi/incomplete.h"
#include "jacobi/inverse.h"
#include "jacobi/reciprocal.h"

VMI_QUIET_END

#endif
