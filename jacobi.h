/* jacobi.h - complete elliptic integrals and Jacobi's elliptic functions by the arithmetic-geometric mean

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

   ERRORS
     m > 1, m1 < 0, c < 0, NaN and infinite arguments give NaN; m = 1 gives the limits: K infinite, E = 1,
     sn = tanh, cn = dn = sech. Nothing else can fail. No allocation, no state; errno says nothing.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_SQRT, VM_SIN ...  the functions of the C library that are used (all of them, if any)
     VM_ALLOW_FAST_MATH   compile under -ffast-math, where no bound below holds
   Names that begin with vmi_ or VMI_ are internal.

   ACCURACY AND COST, measured (make test, scan, bench; docs/measurements.md), inputs taken as exact
     sn, cn, dn   absolute error <= 7 eps max(1, k') for |u| <= 1e9 (float 1e4) and |u| < K/eps; beyond that u holds
                  no phase, and sn = 0, cn = dn = 1. Relative error for |u| <= 100 K, with K' = K max(1, k') which grows
                  towards m = 1 and m = -infinity: <= 16 ulp where K' < 4, else <= 5 K' ulp.
     the zeros    lie where K in two words puts them, to a relative error of 2^-101 (float 2^-43). This times |u| and
                  the slope comes on top of the relative error; it is felt where u is within an ulp of the zero.
     K, k'K; E    <= 5 ulp; <= 6 ulp. solve_kpK: m to 8 eps max(1, |m|), m1 to 8 ulp.
     Time         in units of the C library's sin (float: sinf), which vary by up to 2 on one machine: K 3 (3), E 5.5
                  (6.5), sn+cn+dn 13 (12) for |u| < K/2 and 19 (25) beyond, solve_kpK 58 (70).

   REFERENCES
     [1] DLMF, chapters 19 and 22, dlmf.nist.gov: 19.8 (AGM), 22.20 (sn, cn, dn by descending transformation).
     [2] R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions, Numer. Math. 7 (1965) 78-90.
     [3] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [4] L. Cveticanin, Dynamics of Mass Variable System, dissertation; equation numbers like (307) are its. */
#ifndef VARMASS_JACOBI_H
#define VARMASS_JACOBI_H

/* ---- Shared block: the same, word for word, in the four headers; tests/test_headers.sh keeps it so ---------- */
#ifndef VM_SHARED
#define VM_SHARED

#include <float.h>
#include <math.h>
#include <stddef.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#define VM_NO_NAN
#endif
#if (defined(__FAST_MATH__) || defined(VM_NO_NAN)) && !defined(VM_ALLOW_FAST_MATH)
#error "-ffast-math breaks two-word arithmetic and the checks for NaN; VM_ALLOW_FAST_MATH compiles anyway"
#endif

#ifndef VM_API
#define VM_API static inline /* linkage of every function, e.g. static inline __host__ __device__ */
#endif
#ifndef VM_TABLE
#define VM_TABLE static const /* storage of every table */
#endif

#ifdef VM_USE_FLOAT
typedef float vm_real;
#define VM_C(x) x##f            /* a constant */
#define VM_LIBM(name) name##f   /* a function of the C library */
#define VM_TAG(tag) tag##_float /* a struct tag: a C++ program that mixes precisions has no tag twice */
#define VM_EPSILON FLT_EPSILON
#define VM_MAX FLT_MAX
#define VM_MANT_DIG FLT_MANT_DIG
#ifdef FP_FAST_FMAF
#define VM_FAST_FMA
#endif
#else
typedef double vm_real;
#define VM_C(x) x
#define VM_LIBM(name) name
#define VM_TAG(tag) tag
#define VM_EPSILON DBL_EPSILON
#define VM_MAX DBL_MAX
#define VM_MANT_DIG DBL_MANT_DIG /* 24 where double is a float, as on AVR: table lengths follow it */
#ifdef FP_FAST_FMA
#define VM_FAST_FMA
#endif
#endif

#ifndef VM_SQRT /* define all of these to use another library */
#define VM_SQRT(x) VM_LIBM(sqrt)(x)
#define VM_FABS(x) VM_LIBM(fabs)(x)
#define VM_FLOOR(x) VM_LIBM(floor)(x)
#define VM_COPYSIGN(x, y) VM_LIBM(copysign)(x, y)
#define VM_SIN(x) VM_LIBM(sin)(x)
#define VM_COS(x) VM_LIBM(cos)(x)
#define VM_EXP(x) VM_LIBM(exp)(x)
#define VM_LOG(x) VM_LIBM(log)(x)
#define VM_POW(x, y) VM_LIBM(pow)(x, y)
#endif

#define VM_NAN ((vm_real)NAN)
#define VM_INFINITY ((vm_real)INFINITY)
#define VM_IS_FINITE(x) ((x) - (x) == 0)
#define VM_PI VM_C(3.141592653589793238463)

typedef struct VM_TAG(vm_two) {
    vm_real hi, lo;
} vm_two; /* hi + lo, |lo| <= ulp(hi)/2 */

/* a + b exactly (Knuth) */
VM_API vm_two vmi_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    vm_real b_part;
    s.hi = a + b;
    b_part = s.hi - a;
    s.lo = (a - (s.hi - b_part)) + (b - b_part);
    return s;
}

/* a b exactly, for |a|, |b| < VM_MAX/VM_SPLIT whose product neither over- nor underflows: by a fused multiply-add
   where that is an instruction, else by Dekker's and Veltkamp's splitting, with the same result. "+ 0" makes a
   product a sum, so that a compiler that contracts cannot put the unrounded product into a later sum; the variables
   shed excess precision. */
#if VM_MANT_DIG > 24
#define VM_SPLIT VM_C(134217729.0)
#else
#define VM_SPLIT VM_C(4097.0)
#endif
VM_API vm_two vmi_two_product(vm_real a, vm_real b)
{
    vm_two p;
#ifdef VM_FAST_FMA
    p.hi = a * b + 0;
    p.lo = VM_LIBM(fma)(a, b, -p.hi);
#else
    vm_real ta = VM_SPLIT * a + 0, a_rest = ta - a, ah = ta - a_rest, al = a - ah;
    vm_real tb = VM_SPLIT * b + 0, b_rest = tb - b, bh = tb - b_rest, bl = b - bh;
    p.hi = a * b + 0;
    p.lo = ((ah * bh - p.hi) + ah * bl + al * bh) + al * bl;
#endif
    return p;
}

/* x = 4k quarters + *quarter quarters + rest, where the quarter period is q.hi + q.lo > 0 and x >= 0: returns the
   rest, |rest| <= q/2 but for a rounding, accurate to an ulp of itself plus 2^-(2p) x. From 2^(p-1) quarters on
   the argument holds no phase: rest 0, quarter 0. */
VM_API vm_real vmi_reduce(vm_real x, vm_two q, int *quarter)
{
    vm_real scale, j = VM_FLOOR(x / q.hi + VM_C(0.5));
    vm_two p;
    *quarter = 0;
    if (j == 0) return x;
    if (!(j < 1 / VM_EPSILON)) return 0;
    *quarter = (int)(j - 4 * VM_FLOOR(j / 4));
    scale = q.hi > VM_MAX * VM_EPSILON ? VM_EPSILON : 1; /* room for the splitting */
    p = vmi_two_product(j, q.hi * scale);
    return ((x * scale - p.hi) - (p.lo + j * (q.lo * scale))) / scale;
}

#endif
/* ---- End of the shared block -------------------------------------------------------------------------------- */

/* ---- Table of contents -------------------------------------------------------------------------------------- */

/* Complete elliptic integrals of the first and second kind, K(m) and E(m), m <= 1. */
VM_API vm_real jacobi_K(vm_real m);
VM_API vm_real jacobi_E(vm_real m);
VM_API vm_real jacobi_K_m1(vm_real m1);
VM_API vm_real jacobi_E_m1(vm_real m1);

/* sn, cn, dn (u | m) for any real u and m <= 1. |sn|, |cn| <= 1, dn between 1 and sqrt(1 - m); sn is odd, cn and dn
   are even in u, to the bit. u is reduced with K in two words. */
VM_API void jacobi_sncndn(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn);
VM_API void jacobi_sncndn_m1(vm_real u, vm_real m1, vm_real *sn, vm_real *cn, vm_real *dn);

/* k'K(k^2) = sqrt(1 - m) K(m), the left side of (307): falls from infinity (m -> -infinity) to 0 (m = 1). */
VM_API vm_real jacobi_kpK(vm_real m);

/* The modulus solver: the one m (or m1) with k'K(k^2) = c, for any c >= 0; m < 0 for c > pi/2. */
VM_API vm_real jacobi_solve_kpK(vm_real c);
VM_API vm_real jacobi_solve_kpK_m1(vm_real c);

/* ---- The AGM ladder [1, 2] ---------------------------------------------------------------------------------- */

#define VMI_LADDER 16 /* levels; 13 are needed at m1 = 5e-324 */

typedef struct VM_TAG(vmi_ladder) {
    int n;                                /* last level */
    vm_real a[VMI_LADDER], b[VMI_LADDER]; /* a_0 = 1, b_0 = k'; a_(n+1) = (a_n + b_n)/2, b_(n+1) = sqrt(a_n b_n) */
    vm_real c;                            /* c_n = (a_(n-1) - b_(n-1))/2 of the last level: c_n^2 <= eps/4 a_n^2 */
} vmi_ladder;

/* agm(1, b0) climbed until k_n^2 = (c_n/a_n)^2 <= eps/4: there sn differs from sin by at most eps/60, and a_n from
   its limit by c_n^2/(4 a_n) <= eps/16 a_n. b0 > 0, finite. */
VM_API void vmi_agm(vmi_ladder *l, vm_real b0)
{
    int n = 0;
    l->a[0] = 1;
    l->b[0] = b0;
    do {
        vm_real a = l->a[n], b = l->b[n];
        l->c = (a - b) / 2;
        n++;
        l->a[n] = (a + b) / 2;
        l->b[n] = VM_SQRT(a * b);
    } while (4 * l->c * l->c > VM_EPSILON * l->a[n] * l->a[n] && n + 1 < VMI_LADDER);
    l->n = n;
}

/* sum 2^(n-1) c_n^2 over n >= 1, all of one sign; with c_0^2 = 1 - b0^2 it makes E = K (1 - c_0^2/2 - sum) */
VM_API vm_real vmi_agm_sum(const vmi_ladder *l)
{
    vm_real sum = 0, power = 1;
    int n;
    for (n = 0; n < l->n; n++, power *= 2) {
        vm_real c = (l->a[n] - l->b[n]) / 2;
        sum += power * c * c;
    }
    return sum;
}

/* The limit of the a_n in two words from a ladder in one: the rounding errors of every step, known exactly, are
   carried up the ladder to first order. m1_lo is the low word of m1 = b_0^2. Relative error < 2^-(2p - 5). */
VM_API vm_two vmi_agm_two_words(const vmi_ladder *l, vm_real m1, vm_real m1_lo)
{
    const vm_real large = 1 / (VM_EPSILON * VM_EPSILON), small = VM_EPSILON * VM_EPSILON;
    const vm_real unit = m1 < small ? large : m1 > large ? small : 1; /* keeps b_0^2 from under- and overflow */
    const vm_real b0 = unit * l->b[0];
    vm_two p = vmi_two_product(b0, b0);
    vm_real al = 0, bl = ((m1 * unit * unit - p.hi) - p.lo + m1_lo * unit * unit) / (2 * b0) / unit, c = l->c;
    int n;
    for (n = 0; n < l->n; n++) {
        vm_real a = l->a[n], b = l->b[n], root = l->b[n + 1];
        vm_two s = vmi_two_sum(a, b), q = vmi_two_product(root, root);
        vm_real a_lo = (al + bl) / 2 + s.lo / 2;
        c = (a - b) / 2 + (al - bl) / 2;
        p = vmi_two_product(a, b);
        bl = (((p.hi - q.hi) + (p.lo - q.lo)) + (a * bl + b * al)) / (2 * root);
        al = a_lo;
    }
    return vmi_two_sum(l->a[l->n], al - c * c / (4 * l->a[l->n]));
}

/* K = pi/2 over that limit */
VM_API vm_two vmi_K_two_words(vm_two a)
{
    const vm_real half_pi = VM_C(1.570796326794896619231);
#if VM_MANT_DIG > 24
    const vm_real half_pi_lo = VM_C(6.123233995736766035869e-17);
#else
    const vm_real half_pi_lo = VM_C(-4.371139000186241438058e-8);
#endif
    vm_two p, K;
    K.hi = half_pi / a.hi;
    p = vmi_two_product(K.hi, a.hi);
    K.lo = (((half_pi - p.hi) - p.lo) + (half_pi_lo - K.hi * a.lo)) / a.hi;
    return K;
}

/* ---- Complete integrals ------------------------------------------------------------------------------------- */

VM_API vm_real jacobi_K_m1(vm_real m1)
{
    vmi_ladder l;
    if (!(m1 >= 0) || !VM_IS_FINITE(m1)) return VM_NAN;
    if (m1 == 0) return VM_INFINITY;
    vmi_agm(&l, VM_SQRT(m1));
    return VM_PI / 2 / l.a[l.n];
}

VM_API vm_real jacobi_K(vm_real m) { return jacobi_K_m1(1 - m); }

/* For m > 1/2 the difference E = K (1 - ...) would cancel; Legendre's relation makes it a sum of positive terms,
   E = agm(1, k) + K (m1/2 + sum 2^(n-1) c_n^2), with the c_n of agm(1, k). For m < 0 E(m) = k' E(m/(m - 1)). */
VM_API vm_real jacobi_E_m1(vm_real m1)
{
    vmi_ladder l;
    vm_real K, scale = 1;
    if (!(m1 >= 0) || !VM_IS_FINITE(m1)) return VM_NAN;
    if (m1 == 0) return 1;
    if (m1 > 1) {
        scale = VM_SQRT(m1);
        m1 = 1 / m1;
    }
    K = jacobi_K_m1(m1);
    vmi_agm(&l, m1 < VM_C(0.5) ? VM_SQRT(1 - m1) : VM_SQRT(m1));
    if (m1 < VM_C(0.5)) return scale * (l.a[l.n] + K * (m1 / 2 + vmi_agm_sum(&l)));
    return scale * K * ((1 + m1) / 2 - vmi_agm_sum(&l));
}

VM_API vm_real jacobi_E(vm_real m) { return jacobi_E_m1(1 - m); }

/* ---- sn, cn, dn --------------------------------------------------------------------------------------------- */

/* Down the ladder by Gauss' transformation in homogeneous form, sn : cn : dn : 1 = s : c : d : q,
     s' = (a/a+) s q,  c' = c d,  d' = c^2 + (b/a+) s^2,  q' = c^2 + (a/a+) s^2     (a+ = a_(n+1))
   No difference occurs, for m < 0 neither, so that every value keeps its relative accuracy. phi = a u, |u| <= K/2. */
VM_API void vmi_descend(const vmi_ladder *l, vm_two phi, vm_real *s, vm_real *c, vm_real *d, vm_real *q)
{
    vm_real sine = VM_SIN(phi.hi), cosine = VM_COS(phi.hi);
    int n;
    *s = sine + cosine * phi.lo;
    *c = cosine - sine * phi.lo;
    *d = *q = 1;
    for (n = l->n - 1; n >= 0; n--) {
        vm_real ra = l->a[n] / l->a[n + 1], rb = l->b[n] / l->a[n + 1];
        vm_real ss = *s * *s, cc = *c * *c;
        *s *= ra * *q;
        *c *= *d;
        *d = cc + rb * ss;
        *q = cc + ra * ss;
    }
}

VM_API vm_real vmi_clamp(vm_real x, vm_real low, vm_real high) { return x < low ? low : x > high ? high : x; }

/* tanh v and sech v, v >= 0: by exp(-v), or for v <= 1/2 by Lambert's continued fraction v/(1 + v^2/(3 + ...)), whose
   ninth convergent is off by 1e-20 there */
VM_API void vmi_hyperbolic(vm_real v, vm_real *tanh_v, vm_real *sech_v)
{
    vm_real vv = v * v, fraction = 17, e = VM_EXP(-v), sum = 1 + e * e;
    int odd;
    *tanh_v = (1 - e * e) / sum;
    *sech_v = 2 * e / sum;
    if (v > VM_C(0.5)) return;
    for (odd = 15; odd > 0; odd -= 2) fraction = (vm_real)odd + vv / fraction;
    *tanh_v = v / fraction;
}

/* sn, cn, dn for 1 - m = m1 + m1_lo: u = j K + v with |v| <= K/2, v down the ladder, quarter periods by
   sn(v + K) = cn/dn, cn(v + K) = -k' sn/dn, dn(v + K) = k'/dn. K and the phase a v in two words where j > 0. */
VM_API void vmi_sncndn(vm_real u, vm_real m1, vm_real m1_lo, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real limit = 1; /* of |sn| and |cn|; dn lies between 1 and k' */
    vm_real s, c, d, q, kp, v = VM_FABS(u);
    vmi_ladder l;
    vm_two phi;
    int quarter = 0;
    if (!(m1 >= 0) || !VM_IS_FINITE(m1) || !VM_IS_FINITE(u)) {
        *sn = *cn = *dn = VM_NAN;
        return;
    }
    if (m1 == 0) {
        vmi_hyperbolic(v, sn, cn);
        *sn = VM_COPYSIGN(*sn, u);
        *dn = *cn;
        return;
    }
    kp = VM_SQRT(m1);
    vmi_agm(&l, kp);
    phi.hi = l.a[l.n] * v;
    phi.lo = 0;
    if (phi.hi > VM_PI / 4) {
        vm_two a = vmi_agm_two_words(&l, m1, m1_lo);
        v = vmi_reduce(v, vmi_K_two_words(a), &quarter);
        phi = vmi_two_product(a.hi, v);
        phi.lo += a.lo * v;
    }
    vmi_descend(&l, phi, &s, &c, &d, &q);
    if (quarter & 1) {
        *sn = c / d;
        *cn = -kp * s / d;
        *dn = kp * q / d;
    } else {
        *sn = s / q;
        *cn = c / q;
        *dn = d / q;
    }
    if (quarter & 2) {
        *sn = -*sn;
        *cn = -*cn;
    }
    *sn = vmi_clamp(*sn, -limit, limit);
    *cn = vmi_clamp(*cn, -limit, limit);
    *dn = kp < 1 ? vmi_clamp(*dn, kp, limit) : vmi_clamp(*dn, limit, kp);
    if (VM_COPYSIGN(limit, u) < 0) *sn = -*sn;
}

VM_API void jacobi_sncndn(vm_real u, vm_real m, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vm_real m1 = 1 - m;
    vmi_sncndn(u, m1, vmi_two_sum(1, -m).lo, sn, cn, dn);
}

VM_API void jacobi_sncndn_m1(vm_real u, vm_real m1, vm_real *sn, vm_real *cn, vm_real *dn)
{
    vmi_sncndn(u, m1, 0, sn, cn, dn);
}

/* ---- The modulus solver ------------------------------------------------------------------------------------- */

VM_API vm_real jacobi_kpK(vm_real m)
{
    vm_real kp;
    vmi_ladder l;
    if (!(m <= 1) || !VM_IS_FINITE(m)) return VM_NAN;
    if (m == 1) return 0;
    kp = VM_SQRT(1 - m);
    vmi_agm(&l, kp);
    return kp * (VM_PI / 2 / l.a[l.n]);
}

/* sigma = -d ln K1/d ln y for K1(y) = pi/(2 agm(1, y)): (E - m1 K)/(m K) with m = 1 - y^2, written without the 0/0
   at y = 1; between 0 (y -> 0) and 1 (y -> infinity) */
VM_API vm_real vmi_K_slope(const vmi_ladder *l)
{
    vm_real y = l->b[0], term = (1 - y) / (4 * (1 + y)), sum = term, power = 1; /* 2^(n-1) c_n^2/m */
    int n;
    for (n = 1; n < l->n; n++) {
        vm_real ratio = (l->a[n - 1] - l->b[n - 1]) / (8 * l->a[n + 1]); /* c_(n+1) = c_n^2/(4 a_(n+1)) */
        power *= 2;
        term *= ratio * ratio;
        sum += power * term;
    }
    return VM_C(0.5) - sum;
}

/* Newton's step in ln y for K1(y) = c, or for y K1(y) = c, K1 in two words */
VM_API vm_real vmi_solve_step(vm_real y, vm_real c, int negative)
{
    vmi_ladder l;
    vm_two K1, p;
    vm_real sigma;
    vmi_agm(&l, y);
    p = vmi_two_product(y, y);
    K1 = vmi_K_two_words(vmi_agm_two_words(&l, p.hi, p.lo));
    sigma = vmi_K_slope(&l);
    if (negative) return ((K1.hi - c) + K1.lo) / (K1.hi * sigma);
    p = vmi_two_product(y, K1.hi);
    return (((c - p.hi) - p.lo) - y * K1.lo) / (p.hi * (1 - sigma));
}

/* k' with k' K = c, c > 0: for c >= pi/2 (m <= 0) the unknown is y = 1/k' and K1(y) = c, else y = k' and
   y K1(y) = c. Either function is monotone and convex enough in ln y: from these starts one to four steps do. */
VM_API vm_real vmi_solve_kp(vm_real c)
{
    const vm_real ln8 = VM_C(2.079441541679835928252), small = VM_SQRT(VM_EPSILON) / 16;
    const int negative = c >= VM_PI / 2;
    int most_steps = 8;
    vm_real y;
    if (negative) y = 4 * VM_EXP(-c);                         /* K1 = ln(4/y) + O(y^2 ln y) */
    else y = c / (VM_LOG(4 * (ln8 - VM_LOG(c))) - VM_LOG(c)); /* y = c/ln(4/y), twice */
    if (negative && y < small) return 1 / y;
    while (y > 0 && most_steps-- > 0) { /* a subnormal y may not be able to move by its step */
        vm_real step = vmi_solve_step(y, c, negative);
        y *= VM_EXP(step);
        if (VM_FABS(step) <= small) break;
    }
    return negative ? 1 / y : y;
}

VM_API vm_real jacobi_solve_kpK_m1(vm_real c)
{
    vm_real kp;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    kp = vmi_solve_kp(c);
    return kp * kp;
}

VM_API vm_real jacobi_solve_kpK(vm_real c)
{
    vm_real kp;
    if (!(c >= 0) || !VM_IS_FINITE(c)) return VM_NAN;
    kp = vmi_solve_kp(c);
    return (1 - kp) * (1 + kp);
}

#endif
