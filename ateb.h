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
     alpha < 0, NaN and infinite arguments give NaN. Nothing else can fail. No allocation, no state; errno says
     nothing.

   MACROS, to be defined before the include
     VM_USE_FLOAT         float instead of double (tests run both)
     VM_API               linkage of the functions, default static inline
     VM_TABLE             storage of the tables, default static const
     VM_SQRT, VM_EXP ...  the functions of the C library that are used (all of them, if any)
     VM_ALLOW_FAST_MATH   compile under -ffast-math, where no bound below holds
   Names that begin with vmi_ or VMI_ are internal.

   METHOD
     Pi_alpha from a polynomial in two words, so that phases of any size reduce accurately. Below s = 0.55, and at
     the same distance from every zero of sa, sa is found from the series of B_w in w = sa^2; beyond it
     ln |ca|^(alpha+1) from that of the complement, whose argument (1 - sa)/2 is at most 0.24. A step of Halley's
     method needs one series, a logarithm and an exponential; one or two do.

   ACCURACY AND COST, measured (make test, scan, bench; docs/measurements.md), inputs taken as exact
     sa, ca       absolute error <= 4 eps for |s| <= 1e9 (float 1e4); relative error <= 8 ulp for |s| <= 100
                  Pi_alpha, for alpha = 0 and 1e-300 to 1e30. The largest found is 4 ulp.
     the zeros    lie where Pi_alpha in two words puts them, to a relative error of 2^-102 (float 2^-44). This times
                  |s| and the slope comes on top of the relative error; it is felt where s is within an ulp of the
                  zero.
     Pi_alpha     <= 1 ulp.
     Time         in units of the C library's sin (float: sinf), which vary by up to 2 on one machine: Pi_alpha 21 (29),
                  sa+ca 40 to 50 (45 to 62), Pi_alpha included.

   REFERENCES
     [1] L. Cveticanin, Dynamics of Mass Variable System, dissertation; equation numbers like (277) are its, in
         corrected form where they are misprinted: (278), (280) mix up the indices and a sign, (279) lacks the bars.
     [2] R. M. Rosenberg, The Ateb(h)-functions and their properties, Q. Appl. Math. 21 (1963) 37-47.
     [3] DLMF, dlmf.nist.gov: 8.17 (incomplete beta functions), 15.8(iii) (quadratic transformations).
     [4] T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).
     [5] N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., SIAM 2002, 1.14.1. */
#ifndef VARMASS_ATEB_H
#define VARMASS_ATEB_H

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

/* ---- Elementary kernels: the same, word for word, in jacobi.h and ateb.h ------------------------------------ */
#ifndef VM_ELEMENTARY
#define VM_ELEMENTARY

#include <stdint.h>
#include <string.h>

/* Logarithm, exponential and power with a low word. No branch but where a result is subnormal, no function of the C
   library, so that they are the same everywhere and loops over them vectorise. Tables: tests/gen/elementary.py. */
#if VM_MANT_DIG > 24
typedef uint64_t vmi_bits;
#define VMI_STORED_DIG 52 /* of the mantissa */
#define VMI_BIAS 1023     /* of the exponent */
#define VMI_MIN VM_C(2.2250738585072014e-308)
#else
typedef uint32_t vmi_bits;
#define VMI_STORED_DIG 23
#define VMI_BIAS 127
#define VMI_MIN VM_C(1.1754943508e-38)
#endif

VM_API vmi_bits vmi_to_bits(vm_real x)
{
    vmi_bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

VM_API vm_real vmi_from_bits(vmi_bits bits)
{
    vm_real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* x 2^k, rounded at most once, for |x| from 2^-2 to 4 or 0; for any x, if x 2^(k/2) is a normal number */
VM_API vm_real vmi_ldexp(vm_real x, int k)
{
    const int limit = 2 * VMI_BIAS - 2;
    const int bounded = k > limit ? limit : k < -limit ? -limit : k, half = bounded / 2, rest = bounded - half;
    return x * vmi_from_bits((vmi_bits)(VMI_BIAS + half) << VMI_STORED_DIG) *
           vmi_from_bits((vmi_bits)(VMI_BIAS + rest) << VMI_STORED_DIG);
}

/* a + b exactly, for |a| >= |b| (Dekker) */
VM_API vm_two vmi_fast_two_sum(vm_real a, vm_real b)
{
    vm_two s;
    s.hi = a + b;
    s.lo = (a - s.hi) + b;
    return s;
}

/* ln x for finite x > 0; relative error below 2^-64.8 (float 2^-32). x = 2^k z, ln z = ln c + ln(1 + r), r = z/c - 1.
   1/c is short, so that with z cut in two the square of the head of r is exact. c = 1 where z is within 0.01 of 1. */
VM_API vm_two vmi_log(vm_real x)
{
#if VM_MANT_DIG > 24
    const vmi_bits least_z = UINT64_C(0x3fe6aaaaaaaaaaab), half_tail = UINT64_C(0x40000000);
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
    VM_TABLE vm_real table[32][3] = {
        /* 1/c, ln c: the high words are multiples of 2^-42, as ln2_hi */
        {VM_C(1.4189453125), VM_C(-0.34991385797093244037), VM_C(1.0263080618141573753e-13)},
        {VM_C(1.375), VM_C(-0.31845373111855224124), VM_C(1.7625431312172662057e-14)},
        {VM_C(1.3330078125), VM_C(-0.28743790201951924246), VM_C(-8.7770524478057945722e-14)},
        {VM_C(1.2939453125), VM_C(-0.25769593282097957854), VM_C(1.1008936326855972656e-13)},
        {VM_C(1.2568359375), VM_C(-0.22859740199669431604), VM_C(2.0747306192914545005e-14)},
        {VM_C(1.22265625), VM_C(-0.20102574606062262319), VM_C(3.1881849375437737022e-14)},
        {VM_C(1.189453125), VM_C(-0.1734936426703370671), VM_C(-5.2171826698845917966e-14)},
        {VM_C(1.158203125), VM_C(-0.14686977395831490867), VM_C(9.7240876868206596417e-14)},
        {VM_C(1.1279296875), VM_C(-0.12038381735646908055), VM_C(2.8259559616440998507e-14)},
        {VM_C(1.099609375), VM_C(-0.09495500310026727675), VM_C(8.4679504198281513406e-14)},
        {VM_C(1.0732421875), VM_C(-0.070684148804275537259), VM_C(1.0726890146864022217e-13)},
        {VM_C(1.0478515625), VM_C(-0.046741937031356428633), VM_C(1.1105125439752240142e-13)},
        {VM_C(1.0234375), VM_C(-0.023167059281604451826), VM_C(7.0073597043100356586e-14)},
        {VM_C(1.0), VM_C(0.0), VM_C(0.0)},
        {VM_C(0.9775390625), VM_C(0.022717026284226449206), VM_C(6.0597450660084316691e-15)},
        {VM_C(0.9560546875), VM_C(0.044940163068986294093), VM_C(-4.3582300048382453133e-14)},
        {VM_C(0.9365234375), VM_C(0.065580730715964818955), VM_C(5.0054796379247145689e-14)},
        {VM_C(0.9169921875), VM_C(0.086656326391221227823), VM_C(-3.1041724514644213313e-14)},
        {VM_C(0.8984375), VM_C(0.1070981355562707904), VM_C(9.6310110335192174531e-14)},
        {VM_C(0.8798828125), VM_C(0.12796654799103635014), VM_C(7.8829637969380855345e-14)},
        {VM_C(0.8623046875), VM_C(0.14814660499541787431), VM_C(7.5206341283980230625e-14)},
        {VM_C(0.845703125), VM_C(0.16758689703692652984), VM_C(9.1408198894914123398e-14)},
        {VM_C(0.830078125), VM_C(0.18623545611512781761), VM_C(-3.6862307174239401374e-14)},
        {VM_C(0.814453125), VM_C(0.2052384032406280312), VM_C(7.8304972192271964422e-14)},
        {VM_C(0.7998046875), VM_C(0.22338772174634868861), VM_C(3.4981611229820216869e-14)},
        {VM_C(0.7861328125), VM_C(0.24062952818098892749), VM_C(-9.9203828758961551027e-14)},
        {VM_C(0.771484375), VM_C(0.25943886013828887371), VM_C(9.7042267920673565155e-14)},
        {VM_C(0.7587890625), VM_C(0.27603145523175953713), VM_C(4.6116175827277368694e-14)},
        {VM_C(0.74609375), VM_C(0.29290401643288532796), VM_C(4.7274529405144062921e-14)},
        {VM_C(0.7333984375), VM_C(0.31006615383535063302), VM_C(-3.2283099979657674925e-14)},
        {VM_C(0.7216796875), VM_C(0.32617388465132535202), VM_C(-7.4032069124645893097e-14)},
        {VM_C(0.7099609375), VM_C(0.34254532806585302751), VM_C(8.0700749411504883334e-14)}};
#else
    const vmi_bits least_z = UINT32_C(0x3f355556), half_tail = UINT32_C(0x4000);
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
    VM_TABLE vm_real table[32][3] = {/* 1/c, ln c: the high words are multiples of 2^-16, as ln2_hi */
                                     {VM_C(1.41796875), VM_C(-0.349227905273), VM_C(2.51548817687e-6)},
                                     {VM_C(1.375), VM_C(-0.318450927734), VM_C(-2.80338417724e-6)},
                                     {VM_C(1.33203125), VM_C(-0.286712646484), VM_C(7.61368028179e-6)},
                                     {VM_C(1.29296875), VM_C(-0.256942749023), VM_C(1.81812595201e-6)},
                                     {VM_C(1.2578125), VM_C(-0.229370117188), VM_C(-3.98387737732e-6)},
                                     {VM_C(1.22265625), VM_C(-0.201019287109), VM_C(-6.45895124762e-6)},
                                     {VM_C(1.1875), VM_C(-0.171844482422), VM_C(-5.77450464334e-6)},
                                     {VM_C(1.15625), VM_C(-0.14518737793), VM_C(5.36808511242e-6)},
                                     {VM_C(1.12890625), VM_C(-0.121246337891), VM_C(-2.90574234896e-6)},
                                     {VM_C(1.1015625), VM_C(-0.0967254638672), VM_C(-4.16259126723e-6)},
                                     {VM_C(1.07421875), VM_C(-0.0715942382813), VM_C(5.85094255712e-7)},
                                     {VM_C(1.046875), VM_C(-0.0458068847656), VM_C(-2.6512657314e-6)},
                                     {VM_C(1.0234375), VM_C(-0.0231628417969), VM_C(-4.21748472945e-6)},
                                     {VM_C(1.0), VM_C(0.0), VM_C(0.0)},
                                     {VM_C(0.9765625), VM_C(0.0237121582031), VM_C(4.36841401097e-6)},
                                     {VM_C(0.95703125), VM_C(0.0439147949219), VM_C(4.43901308245e-6)},
                                     {VM_C(0.9375), VM_C(0.0645446777344), VM_C(-6.15659700998e-6)},
                                     {VM_C(0.91796875), VM_C(0.0855865478516), VM_C(5.38248377779e-6)},
                                     {VM_C(0.8984375), VM_C(0.10710144043), VM_C(-3.30487341671e-6)},
                                     {VM_C(0.87890625), VM_C(0.12907409668), VM_C(2.94559549729e-6)},
                                     {VM_C(0.86328125), VM_C(0.147018432617), VM_C(-3.68965538655e-6)},
                                     {VM_C(0.84765625), VM_C(0.165283203125), VM_C(-3.11218582283e-6)},
                                     {VM_C(0.83203125), VM_C(0.183883666992), VM_C(1.61177797509e-6)},
                                     {VM_C(0.81640625), VM_C(0.202850341797), VM_C(-7.14928228263e-6)},
                                     {VM_C(0.80078125), VM_C(0.22216796875), VM_C(-5.03408841723e-7)},
                                     {VM_C(0.78515625), VM_C(0.24186706543), VM_C(5.47099079995e-6)},
                                     {VM_C(0.7734375), VM_C(0.256912231445), VM_C(-1.81766029073e-6)},
                                     {VM_C(0.7578125), VM_C(0.277313232422), VM_C(6.05299419476e-6)},
                                     {VM_C(0.74609375), VM_C(0.292907714844), VM_C(-3.69841086467e-6)},
                                     {VM_C(0.734375), VM_C(0.308731079102), VM_C(4.40254825662e-6)},
                                     {VM_C(0.72265625), VM_C(0.324829101563), VM_C(-7.4821614362e-6)},
                                     {VM_C(0.7109375), VM_C(0.341171264648), VM_C(-5.0724565881e-7)}};
#endif
    const int subnormal = x < VMI_MIN;
    const vmi_bits one = (vmi_bits)1 << VMI_STORED_DIG;
    const vmi_bits above = vmi_to_bits(subnormal ? x * (4 / VM_EPSILON) : x) - least_z;
    const int k = (int)((above + (VMI_BIAS + 1) * one) >> VMI_STORED_DIG) - (VMI_BIAS + 1);
    const vm_real k_real = (vm_real)(k - (subnormal ? VMI_STORED_DIG + 2 : 0));
    const vmi_bits z_bits = (above & (one - 1)) + least_z;
    const vm_real z = vmi_from_bits(z_bits), z_head = vmi_from_bits((z_bits + half_tail) & ~(2 * half_tail - 1));
    const vm_real *row = table[(int)(44 * z - VM_C(30.5))];
    const vm_real r_head = z_head * row[0] - 1, r_tail = (z - z_head) * row[0]; /* exact, half of the digits each */
    const vm_two r = vmi_fast_two_sum(r_head, r_tail);                          /* |r| < 0.0162 */
    const vm_two sum = vmi_fast_two_sum(k_real * ln2_hi + row[1], r.hi);
    const vm_two high = vmi_fast_two_sum(sum.hi, -(r_head * r_head) / 2);
    const vm_real rr = r.hi * r.hi;
#if VM_MANT_DIG > 24
    const vm_real L01 = VM_C(0.33333333333333331483) - r.hi * VM_C(0.25);
    const vm_real L23 = VM_C(0.20000000000035858538) - r.hi * VM_C(0.1666666666669953667);
    const vm_real L45 = VM_C(0.1428571357080885007) - r.hi * VM_C(0.12499999344666766488);
    const vm_real L67 = VM_C(0.11115671970945563418) - r.hi * VM_C(0.10004180804025793183);
    const vm_real L = L01 + rr * (L23 + rr * (L45 + rr * L67)); /* ln(1 + r) = r - r^2/2 + r^3 L(r) */
#else
    const vm_real L01 = VM_C(0.333333343267) - r.hi * VM_C(0.25);
    const vm_real L = L01 + rr * (VM_C(0.20003709197) - r.hi * VM_C(0.166699126363));
#endif
    const vm_real low = sum.lo + high.lo + (k_real * ln2_lo + row[2]) + (r.lo - r_tail * (r.hi + r_head) / 2);
    return vmi_fast_two_sum(high.hi, low + r.hi * rr * L);
}

/* e^(x + x_lo) = 2^k (1 + p + p_lo), |p| < 0.42, for |x| <= 1500 (float 200), |x_lo| <= ulp(x); k = 0 where |x| < 0.34,
   and there p alone is within 0.6 ulp; 1 + p + p_lo within 2^-58 (float 2^-29). x = k ln 2 + r, e^r = 1 + r + r^2/2 +
   r^3 E(r) with the square of the head of r exact. */
VM_API vm_real vmi_exp_core(vm_real x, vm_real x_lo, int *k, vm_real *p_lo)
{
    const vm_real one_over_ln2 = VM_C(1.442695040888963407360);
#if VM_MANT_DIG > 24
    const vm_real ln2_hi = VM_C(0.69314718055989033019), ln2_lo = VM_C(5.4979230187083711552e-14);
#else
    const vm_real ln2_hi = VM_C(0.693145751953125), ln2_lo = VM_C(1.42860676533e-6);
#endif
    const vm_real t = x * one_over_ln2;
    const int n = (int)(t + VM_COPYSIGN(VM_C(0.5), t));
    const vm_two r = vmi_fast_two_sum(x - (vm_real)n * ln2_hi, x_lo - (vm_real)n * ln2_lo);
    const vm_real split = VM_SPLIT * r.hi + 0, excess = split - r.hi, head = split - excess, tail = r.hi - head;
    const vm_two p = vmi_fast_two_sum(r.hi, head * head / 2);
    const vm_real rr = r.hi * r.hi;
#if VM_MANT_DIG > 24
    const vm_real E01 = VM_C(0.16666666666666668517) + r.hi * VM_C(0.041666666666666664354);
    const vm_real E23 = VM_C(0.0083333333333300649987) + r.hi * VM_C(0.0013888888888886554047);
    const vm_real E45 = VM_C(1.9841269863040544982e-4) + r.hi * VM_C(2.4801587317135163907e-5);
    const vm_real E67 = VM_C(2.75572684803100238e-6) + r.hi * VM_C(2.7557282984055877379e-7);
    const vm_real E89 = VM_C(2.510037583256123403e-8) + r.hi * VM_C(2.091122972975856191e-9);
    const vm_real E = (E01 + rr * E23) + rr * rr * (E45 + rr * (E67 + rr * E89));
#else
    const vm_real E01 = VM_C(0.166666671634) + r.hi * VM_C(0.0416666679084);
    const vm_real E23 = VM_C(0.00833331048489) + r.hi * VM_C(0.00138888659421);
    const vm_real E45 = VM_C(1.98909809114e-4) + r.hi * VM_C(2.48512878898e-5);
    const vm_real E = E01 + rr * (E23 + rr * E45);
#endif
    const vm_real low = p.lo + tail * (r.hi + head) / 2 + (r.lo + r.lo * p.hi);
    const vm_two sum = vmi_fast_two_sum(p.hi, low + r.hi * rr * E);
    *k = n;
    *p_lo = sum.lo;
    return sum.hi;
}

/* (y + y_lo) 2^k, rounded once also where it is subnormal, for y from 1/2 to 2 */
VM_API vm_real vmi_ldexp_two(vm_real y, vm_real y_lo, int k)
{
    if (k < 1 - VMI_BIAS || (k == 1 - VMI_BIAS && y < 1)) { /* added to a larger number, y loses the same digits */
        const vm_real large = vmi_ldexp(1, k < -VMI_BIAS - VM_MANT_DIG ? VM_MANT_DIG + 1 : 1 - VMI_BIAS - k);
        const vm_two sum = vmi_fast_two_sum(large, y);
        y = (sum.hi + (sum.lo + y_lo)) - large;
        y_lo = 0;
    }
    return vmi_ldexp(y + y_lo, k);
}

/* e^(x + x_lo), |x_lo| <= ulp(x): within 0.53 ulp, subnormal results included */
VM_API vm_real vmi_exp(vm_real x, vm_real x_lo)
{
    const vm_real largest = VM_C(0.6931471805599453094) * (VMI_BIAS + 2);
    const vm_real least = VM_C(-0.6931471805599453094) * (VMI_BIAS + VM_MANT_DIG + 2);
    const vm_real inside = x > least ? x < largest ? x : largest : least; /* of NaN too */
    vm_real p_lo, p;
    vm_two y;
    int k;
    p = vmi_exp_core(inside, x == inside ? x_lo : 0, &k, &p_lo);
    y = vmi_fast_two_sum(1, p);
    return x == x ? vmi_ldexp_two(y.hi, y.lo + p_lo, k) : x;
}

/* x^y for x > 0: within 0.6 ulp, if x.lo is 0 or |ln x| > 100 eps */
VM_API vm_real vmi_pow(vm_two x, vm_two y)
{
    const vm_real t = x.lo / x.hi;
    vm_two l = vmi_log(x.hi), p;
    l = vmi_fast_two_sum(l.hi, l.lo + (t - t * t / 2));
    p = vmi_two_product(l.hi, y.hi);
    p = vmi_fast_two_sum(p.hi, p.lo + (l.hi * y.lo + l.lo * y.hi));
    return vmi_exp(p.hi, p.lo);
}

#endif
/* ---- End of the elementary kernels -------------------------------------------------------------------------- */

/* ---- Table of contents -------------------------------------------------------------------------------------- */

/* Pi_alpha = B(1/(alpha + 1), 1/2) (277), alpha >= 0: 2 at alpha = 0, pi at 1, alpha + 1 + 2 ln 2 for large ones.
   sa and ca have the period 2 Pi_alpha. */
VM_API vm_real ateb_pi(vm_real alpha);

/* sa(1, alpha, s) and ca(alpha, 1, s) for any real s and alpha >= 0 (276). |sa|, |ca| <= 1; sa is odd, ca is even, to
   the bit. s is reduced with Pi_alpha in two words. */
VM_API void ateb_saca(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca);
VM_API vm_real ateb_sa(vm_real s, vm_real alpha);
VM_API vm_real ateb_ca(vm_real s, vm_real alpha);

/* ---- Two words ---------------------------------------------------------------------------------------------- */

VM_API vm_two vmi_two_times(vm_two x, vm_two y)
{
    vm_two p = vmi_two_product(x.hi, y.hi);
    return vmi_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

VM_API vm_two vmi_two_plus(vm_two x, vm_two y)
{
    vm_two s = vmi_two_sum(x.hi, y.hi);
    return vmi_two_sum(s.hi, s.lo + (x.lo + y.lo));
}

VM_API vm_two vmi_two_over(vm_two x, vm_two y)
{
    vm_real z = x.hi / y.hi;
    vm_two p = vmi_two_product(z, y.hi);
    return vmi_two_sum(z, (((x.hi - p.hi) - p.lo) + (x.lo - z * y.lo)) / y.hi);
}

/* ---- ln(1 + x) and exp(x) - 1 by Kahan's quotients [5]: the rounding of 1 + x and of exp x cancels ----------- */

VM_API vm_real vmi_log1p(vm_real x)
{
    vm_real y = 1 + x;
    return y == 1 ? x : VM_LOG(y) * x / (y - 1);
}

VM_API vm_real vmi_expm1(vm_real x) /* x > -80 */
{
    vm_real y = VM_EXP(x);
    return y == 1 ? x : (y - 1) * x / VM_LOG(y);
}

/* ---- The quarter period ------------------------------------------------------------------------------------- */

/* f(q) = sqrt(pi) Gamma(1 + q)/Gamma(q + 1/2) = q Pi_alpha for q = 1/(alpha + 1) in (0, 1], from 1 to 2: a
   polynomial in t = 2 q - 1 for (1 + q)(2 + q)(3 + q) f, Chebyshev interpolation, whose coefficients fall by 18
   each (tests/gen/ateb_coefficients.py). Relative error below 2^-102, in float below 2^-44. */
VM_API vm_two vmi_ateb_gamma_ratio(vm_two q)
{
#if VM_MANT_DIG > 24
    enum { DEGREE = 25, TWO_WORDS = 17 };
    VM_TABLE vm_real high[DEGREE + 1] = {
        VM_C(2.0616701789183018434e+1),   VM_C(2.0267110471870335431e+1),   VM_C(6.3635705553078754093),
        VM_C(7.3329082227506181546e-1),   VM_C(1.9708227491367229928e-2),   VM_C(-4.0000651288112700496e-4),
        VM_C(1.9327295440373642315e-5),   VM_C(-1.2789187658911751561e-6),  VM_C(9.9916872651209047445e-8),
        VM_C(-8.6358235237752655812e-9),  VM_C(7.9763568164635870373e-10),  VM_C(-7.7130262679616766506e-11),
        VM_C(7.7070743924402230205e-12),  VM_C(-7.8886573293379077004e-13), VM_C(8.2211271034895712443e-14),
        VM_C(-8.6854809710180107013e-15), VM_C(9.27294616281023221e-16),    VM_C(-9.9811924519810123905e-17),
        VM_C(1.0812291934654296984e-17),  VM_C(-1.1771628647553698434e-18), VM_C(1.2868008689981210128e-19),
        VM_C(-1.4110321016644041613e-20), VM_C(1.5465183583149213185e-21),  VM_C(-1.7035575068015575255e-22),
        VM_C(2.0418335586878164583e-23),  VM_C(-2.2561930898876324744e-24)};
    VM_TABLE vm_real low[TWO_WORDS] = {
        VM_C(-3.0654856268470599668e-16), VM_C(1.210856509558633265e-15),   VM_C(3.0240525334513689539e-16),
        VM_C(-2.7717839450231262886e-19), VM_C(5.466600190677016022e-19),   VM_C(-9.4064218124938560387e-21),
        VM_C(-1.1974095141559232778e-21), VM_C(-6.1448694947683434448e-23), VM_C(9.143761539069345421e-25),
        VM_C(-6.345488103238373782e-26),  VM_C(3.8720113087801535445e-26),  VM_C(-3.525313710286337803e-27),
        VM_C(5.4289120049674930893e-28),  VM_C(4.4446375097164756405e-29),  VM_C(-2.9053450205411567762e-31),
        VM_C(-2.8420161922516542678e-31), VM_C(-7.4733218002958145216e-32)};
#else
    enum { DEGREE = 14, TWO_WORDS = 8 };
    VM_TABLE vm_real high[DEGREE + 1] = {
        VM_C(2.06167011261e+1),  VM_C(2.02671108246e+1),   VM_C(6.36357069016),     VM_C(7.33290851116e-1),
        VM_C(1.97082273662e-2),  VM_C(-4.00006509153e-4),  VM_C(1.93272953766e-5),  VM_C(-1.27891871671e-6),
        VM_C(9.99168676685e-8),  VM_C(-8.63586269162e-9),  VM_C(7.97639843064e-10), VM_C(-7.7079689853e-11),
        VM_C(7.70167263298e-12), VM_C(-8.22296224168e-13), VM_C(8.57817980602e-14)};
    VM_TABLE vm_real low[TWO_WORDS] = {VM_C(6.63084392727e-7),  VM_C(-3.52714636165e-7), VM_C(-1.34847155664e-7),
                                       VM_C(-2.88411179383e-8), VM_C(1.25158161612e-10), VM_C(-3.73129912384e-12),
                                       VM_C(6.41609703735e-14), VM_C(-3.32791655561e-14)};
#endif
    vm_two t, sum, c, divisor;
    vm_real tail = high[DEGREE];
    int i;
    t.hi = 2 * q.hi, t.lo = 2 * q.lo;
    c.hi = -1, c.lo = 0;
    t = vmi_two_plus(c, t);
    for (i = DEGREE - 1; i >= TWO_WORDS; i--) tail = high[i] + tail * t.hi;
    sum.hi = tail, sum.lo = 0;
    /* each coefficient exceeds what follows, so that the high words take two operations a step */
    for (i = TWO_WORDS - 1; i >= 0; i--) {
        vm_two p = vmi_two_product(sum.hi, t.hi);
        vm_real hi = high[i] + p.hi;
        sum.lo = (p.hi - (hi - high[i])) + (p.lo + (sum.hi * t.lo + sum.lo * t.hi) + low[i]);
        sum.hi = hi;
    }
    c.hi = 1, c.lo = 0;
    divisor = q = vmi_two_plus(c, q);
    for (i = 2; i <= 3; i++) {
        q = vmi_two_plus(c, q);
        divisor = vmi_two_times(divisor, q);
    }
    return vmi_two_over(sum, divisor);
}

typedef struct VM_TAG(vmi_ateb) {
    vm_real n, q;   /* alpha + 1 and 1/(alpha + 1) */
    vm_real g;      /* (q Pi - 1)/q, from 1 (alpha = 0) to 2 ln 2 */
    vm_two quarter; /* Pi/2 */
} vmi_ateb;

/* g(q) = (f(q) - 1)/q for small q, by its Taylor series; off by q^3/2 */
VM_API vm_two vmi_ateb_g(vm_real q)
{
    const vm_real two_ln2 = VM_C(1.386294361119890618835);
#if VM_MANT_DIG > 24
    const vm_real two_ln2_lo = VM_C(4.638093627692599231e-17);
#else
    const vm_real two_ln2_lo = VM_C(-3.80930859992e-9);
#endif
    return vmi_two_sum(two_ln2, two_ln2_lo + q * (VM_C(-0.6840280390118235871) + q * VM_C(0.5677838543520556957)));
}

/* Pi = (alpha + 1) f(q) = (alpha + 1) + g exactly. Where q is small g is known better than f, and so, as an error
   of Pi is one of phase however large Pi is, Pi. */
VM_API void vmi_ateb_constants(vmi_ateb *c, vm_real alpha)
{
    vm_two n = vmi_two_sum(alpha, 1), one = {1, 0}, x;
    c->n = n.hi;
    c->q = 1 / n.hi;
    if (8 * c->q < VM_SQRT(VM_EPSILON)) {
        x = vmi_ateb_g(c->q);
        c->g = x.hi;
        c->quarter = vmi_two_plus(n, x);
    } else {
        x = vmi_ateb_gamma_ratio(vmi_two_over(one, n));
        c->g = ((x.hi - 1) + x.lo) / c->q;
        c->quarter = vmi_two_times(n, x);
    }
    c->quarter.hi /= 2;
    c->quarter.lo /= 2;
}

VM_API vm_real ateb_pi(vm_real alpha)
{
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha)) return VM_NAN;
    vmi_ateb_constants(&c, alpha);
    return 2 * c.quarter.hi;
}

/* ---- Inversion of the incomplete beta function ---------------------------------------------------------------

   With w = sa^2, x = 1 - w = |ca|^(alpha+1), r the distance of s from the zero of sa and d from that of ca,
     r = B_w(1/2, q)/2 = sa (1 + sum_(n>=1) (1-q)_n/n! w^n/(2n+1))                    dr/dsa = (1-w)^(q-1)
     2 q d = q B_x(q, 1/2) = |ca| (1 + q T),  1 + q T = 2F1(1, 2q; 1+q; p),           p = (1 - sa)/2
   the second by the quadratic transformation of 2F1(1/2, q; 1+q; x). At the change-over, r = 0.55, w <= 0.3 and
   p <= 0.24, so that either series gains two bits or so a term. */

VM_API vm_real vmi_ateb_tail_w(vm_real w, vm_real kappa)
{
    vm_real power = 1, term, sum = 0;
    int n = 0;
    do {
        power *= w * ((kappa + (vm_real)n) / (vm_real)(n + 1));
        n++;
        term = power / (vm_real)(2 * n + 1);
        sum += term;
    } while (term > VM_EPSILON / 8);
    return sum;
}

VM_API vm_real vmi_ateb_tail_p(vm_real p, vm_real q)
{
    vm_real term = 2 * p / (1 + q), sum = term;
    int n = 1;
    do {
        term *= p * ((2 * q + (vm_real)n) / (1 + q + (vm_real)n));
        sum += term;
        n++;
    } while (term > VM_EPSILON / 8);
    return sum;
}

/* Halley's step leaves 0.3 step^3 or less: after a step of 2^-18 (float 2^-8.3) that is below eps/4 */
#if VM_MANT_DIG > 24
#define VMI_ATEB_LAST_STEP VM_C(3.8e-6)
#else
#define VMI_ATEB_LAST_STEP VM_C(3.1e-3)
#endif

/* sa, ca for 0 <= r <= 0.55: start from the Taylor series of the inverse to r^9 (1e-5), one step, at times two */
VM_API void vmi_ateb_near_sa_zero(vm_real r, vm_real q, vm_real *sa, vm_real *ca)
{
    const vm_real k = 1 - q, rr = r * r;
    const vm_real c1 = -1 / VM_C(3.0);
    const vm_real c2 = (7 * k - 3) / 30;
    const vm_real c3 = ((-127 * k + 123) * k - 30) / 630;
    const vm_real c4 = (((4369 * k - 6822) * k + 3579) * k - 630) / 22680;
    vm_real v = r * (1 + k * rr * (c1 + rr * (c2 + rr * (c3 + rr * c4)))), w, step;
    do {
        w = v * v;
        step = ((r - v) - v * vmi_ateb_tail_w(w, k)) * VM_EXP(k * VM_LOG(1 - w));
        step /= 1 + step * k * v / (1 - w);
        v += step;
    } while (VM_FABS(step) > VMI_ATEB_LAST_STEP);
    *sa = v;
    *ca = VM_EXP(q * VM_LOG(1 - v * v));
}

/* First guess of x from X = (2 q d)^(1/q), the value for T = 0: the (1, 1) Pade approximant of x/X = 1 - e1 X +
   e2 X^2 - ..., 1 to 2 % off at the change-over */
VM_API vm_real vmi_ateb_guess_x(vm_real X, vm_real q)
{
    vm_real e1 = 1 / (2 * (1 + q));
    vm_real e2 = VM_C(1.5) * e1 * e1 - 3 / (8 * (2 + q)) + q * e1 * e1 / 2;
    vm_real b = e2 / e1;
    return X * (1 + (b - e1) * X) / (1 + b * X);
}

/* sa, ca for r >= 0.55: Halley's steps for ln x, which neither underflows nor loses digits for large alpha. The
   residual E = (2 q d - ca (1 + q T))/q, whose slope is that of 2 d, ca/sa, is taken from r or from d, whichever is
   smaller. ca follows from d, with T moved along to the last x. */
VM_API void vmi_ateb_near_ca_zero(vm_real r, vm_real d, const vmi_ateb *c, vm_real *sa, vm_real *ca)
{
    const vm_real negligible = -(vm_real)(VM_MANT_DIG + 2) * VM_C(0.6931471805599453); /* ln(eps/8) */
    const vm_real q = c->q;
    const vm_real z = 2 * r - c->g; /* 2 q d = 1 - q z */
    const int from_r = r < d;
    const vm_real y = from_r ? 1 - q * z : 2 * q * d;
    const vm_real ln_X = (from_r ? vmi_log1p(-q * z) : VM_LOG(y)) * c->n;
    vm_real x, T, T1, T2, step;
    if (ln_X < negligible) {
        *sa = 1;
        *ca = y;
        return;
    }
    x = vmi_ateb_guess_x(VM_EXP(ln_X), q);
    do {
        vm_real ln_x = VM_LOG(x), u = VM_EXP(q * ln_x), v = VM_SQRT(1 - x), E;
        T = vmi_ateb_tail_p(x / (2 * (1 + v)), q);
        E = from_r ? (-vmi_expm1(q * ln_x) * c->n - z) - u * T : 2 * d - u * (c->n + T);
        step = v * E / u;
        step /= 1 + step * (q + x / (2 * v * v)) / 2;
        T1 = 1 / v - 1 - q * T; /* dT/dlnx and its derivative */
        T2 = x / (2 * v * v * v) - q * T1;
        T += step * (T1 + step * T2 / 2);
        x *= VM_EXP(step);
    } while (VM_FABS(step) > VMI_ATEB_LAST_STEP);
    *sa = VM_SQRT(1 - x);
    *ca = y / (1 + q * T);
}

/* ---- sa, ca ------------------------------------------------------------------------------------------------- */

VM_API void ateb_saca(vm_real s, vm_real alpha, vm_real *sa, vm_real *ca)
{
    const vm_real change_over = VM_C(0.55);
    vm_real r, d, rest, sa1, ca1;
    int quarter;
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha) || !VM_IS_FINITE(s)) {
        *sa = *ca = VM_NAN;
        return;
    }
    vmi_ateb_constants(&c, alpha);
    rest = vmi_reduce(VM_FABS(s), c.quarter, &quarter);
    r = VM_FABS(rest);
    d = c.quarter.hi - r;
    if (quarter & 1) {
        d = r;
        r = c.quarter.hi - d;
    }
    if (r <= change_over) vmi_ateb_near_sa_zero(r, c.q, &sa1, &ca1);
    else vmi_ateb_near_ca_zero(r, d, &c, &sa1, &ca1);
    if (quarter & 1) ca1 = VM_COPYSIGN(ca1, -rest);
    else sa1 = VM_COPYSIGN(sa1, rest);
    if (quarter & 2) {
        sa1 = -sa1;
        ca1 = -ca1;
    }
    *sa = VM_COPYSIGN(1, s) < 0 ? -sa1 : sa1;
    *ca = ca1;
}

VM_API vm_real ateb_sa(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return sa;
}

VM_API vm_real ateb_ca(vm_real s, vm_real alpha)
{
    vm_real sa, ca;
    ateb_saca(s, alpha, &sa, &ca);
    return ca;
}

#endif
