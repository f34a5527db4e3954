/* base/words.h - products, quotients and roots with two and three times the digits

   Where the difference of nearly equal numbers loses digits (they cancel), one vm_real is not enough. A number in two
   words (vm_two, hi + lo) has twice the digits, and a number in three words (vmi_three, hi + mid + lo) has three times
   the digits. p is the number of binary digits of a vm_real, 53 or 24. Errors of products, quotients and roots are
   given relative to the result, errors of sums relative to the larger term.

       vm_two third = vmi_two_over(vmi_two(1, 0), vmi_two(3, 0)); // 1/3 with 2p digits

   Source: Dekker, Numer. Math. 18 (1971). Tests: tests/test_jacobi.c, tests/test_ateb.c. */
#ifndef VARMASS_BASE_WORDS_H
#define VARMASS_BASE_WORDS_H

#include "bits.h"
#include "real.h"
#include "sums.h"

/* The factor of Veltkamp's method, which splits a vm_real into two halves of p/2 digits each */
#if VM_MANT_DIG > 24
#define VM_SPLIT VM_C(134217729.0)
#else
#define VM_SPLIT VM_C(4097.0)
#endif

/* Returns the exact product a b as a pair, for |a|, |b| < VM_MAX/VM_SPLIT, if the product neither overflows nor
   underflows. A fused multiply-add is used where the processor has one; elsewhere both factors are split into halves,
   with the same result. Each "+ 0" makes a product a sum: a compiler that fuses operations then cannot use the
   unrounded product in a later sum. */
VM_API vm_two vmi_two_product(vm_real a, vm_real b)
{
    vm_two p;
#ifdef VM_FAST_FMA
    p.hi = a * b + 0;
    p.lo = VM_LIBM(fma)(a, b, -p.hi);
#else
    vm_real ta = vmi_rounded(VM_SPLIT * a + 0), a_rest = vmi_rounded(ta - a), ah = ta - a_rest, al = a - ah;
    vm_real tb = vmi_rounded(VM_SPLIT * b + 0), b_rest = vmi_rounded(tb - b), bh = tb - b_rest, bl = b - bh;
    p.hi = vmi_rounded(a * b + 0);
    p.lo = vmi_rounded(((ah * bh - p.hi) + ah * bl + al * bh) + al * bl);
#endif
    return p;
}

/* Reduces x >= 0 by the quarter period q > 0. Let j q be the multiple of q that is nearest to x. Returns x - j q, which
   lies between -q/2 and q/2 (or slightly outside by rounding), with an error below x 2^-(2p - 2), and writes j modulo 4
   to *quarter; p is the number of bits of vm_real. For one x the error is larger: if q.hi is a power of two and x is
   the number just below q.hi/2, the result is -q.hi/2 with an error of x 2^-p. For x above 2^(p-1) q the digits of x do
   not determine x - j q, and both results are 0. */
VM_API vm_two vmi_reduce(vm_real x, vm_two q, int *quarter)
{
    vm_real j = VM_FLOOR(x / q.hi + VM_C(0.5));
    const vm_real scale = q.hi > VM_MAX * VM_EPSILON ? VM_EPSILON : 1; /* keeps the product from overflowing */
    const vm_real hi = q.hi * scale, lo = q.lo * scale;
    vm_two p;
    *quarter = 0;
    if (j == 0) return vmi_two(x, 0);
    if (!(j < 1 / VM_EPSILON)) return vmi_two(0, 0);
    p = vmi_two_product(j, hi);
    p = vmi_two_sum(x * scale - p.hi, -p.lo); /* x scale - p.hi is exact, except for the x named above */
    p = vmi_fast_two_sum(p.hi, p.lo - j * lo);
    if (VM_FABS(p.hi) > VM_C(0.501) * hi) { /* for x > q/(1000 eps), where the rounding of the quotient changes j */
        const vm_real further = VM_FLOOR(p.hi / hi + VM_C(0.5));
        p = vmi_two_sum(p.hi - further * hi, p.lo - further * lo);
        j += further;
    }
    *quarter = (int)(j - 4 * VM_FLOOR(j / 4));
    return vmi_two(p.hi / scale, p.lo / scale);
}

/* Returns x with the second half of its digits set to zero. */
VM_API vm_real vmi_head(vm_real x)
{
    const vmi_bits above = (vmi_bits)1 << ((VM_MANT_DIG + 1) / 2);
    return vmi_from_bits(vmi_to_bits(x) & ~(above - 1));
}

/* The product x y of numbers in two words; the relative error is below 2^-(2p - 4), where p is the number of binary
   digits of vm_real. */
VM_API vm_two vmi_two_times(vm_two x, vm_two y)
{
    vm_two p = vmi_two_product(x.hi, y.hi);
    return vmi_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* The sum x + y of numbers in two words; the error is below 2^-(2p - 4) of the larger term, where p is the number of
   binary digits of vm_real. */
VM_API vm_two vmi_two_plus(vm_two x, vm_two y)
{
    vm_two s = vmi_two_sum(x.hi, y.hi);
    return vmi_two_sum(s.hi, s.lo + (x.lo + y.lo));
}

/* The quotient x / y of numbers in two words; the relative error is below 2^-(2p - 4), where p is the number of binary
   digits of vm_real. */
VM_API vm_two vmi_two_over(vm_two x, vm_two y)
{
    vm_real z = vmi_rounded(x.hi / y.hi);
    vm_two p = vmi_two_product(z, y.hi);
    return vmi_two_sum(z, (((x.hi - p.hi) - p.lo) + (x.lo - z * y.lo)) / y.hi);
}

/* The number hi + mid + lo, where mid is below an ulp of hi, and lo below an ulp of mid. Each operation on these
   numbers has a relative error below 2^-(3p - 4); p is 53 or 24. */
typedef struct VM_TAG(vmi_three) {
    vm_real hi, mid, lo;
} vmi_three;

/* Returns a + b + c as a number in three words. |a| >= |b| >= |c| must hold at least approximately. */
VM_API vmi_three vmi_three_words(vm_real a, vm_real b, vm_real c)
{
    const vm_two low = vmi_two_sum(b, c), high = vmi_two_sum(a, low.hi), rest = vmi_two_sum(high.lo, low.lo);
    vmi_three x;
    x.hi = high.hi;
    x.mid = rest.hi;
    x.lo = rest.lo;
    return x;
}

/* Returns the sum x + y of numbers in three words. */
VM_API vmi_three vmi_three_plus(vmi_three x, vmi_three y)
{
    const vm_two high = vmi_two_sum(x.hi, y.hi), mid = vmi_two_sum(x.mid, y.mid);
    const vm_two sum = vmi_two_sum(high.lo, mid.hi);
    return vmi_three_words(high.hi, sum.hi, sum.lo + mid.lo + (x.lo + y.lo));
}

/* Returns the product x y of numbers in three words. */
VM_API vmi_three vmi_three_times(vmi_three x, vmi_three y)
{
    const vm_two p = vmi_two_product(x.hi, y.hi), a = vmi_two_product(x.hi, y.mid);
    const vm_two b = vmi_two_product(x.mid, y.hi);
    const vm_two sum = vmi_two_sum(a.hi, b.hi), mid = vmi_two_sum(p.lo, sum.hi);
    return vmi_three_words(p.hi, mid.hi,
                           mid.lo + sum.lo + (a.lo + b.lo) + (x.hi * y.lo + x.mid * y.mid + x.lo * y.hi));
}

/* Returns the quotient x / y of numbers in three words, by long division: each of three steps gives a word of the
   quotient. */
VM_API vmi_three vmi_three_over(vmi_three x, vmi_three y)
{
    vm_real quotient[3];
    int i;
    for (i = 0; i < 3; i++) {
        quotient[i] = vmi_rounded(x.hi / y.hi);
        x = vmi_three_plus(x, vmi_three_times(y, vmi_three_words(-quotient[i], 0, 0)));
    }
    return vmi_three_words(quotient[0], quotient[1], quotient[2]);
}

/* Returns the fourth power of x. */
VM_API vm_real vmi_fourth_power(vm_real x) { return (x * x) * (x * x); }

/* Returns the product of x and a power of two, which is exact. */
VM_API vmi_three vmi_three_scaled(vmi_three x, vm_real power)
{
    return vmi_three_words(x.hi * power, x.mid * power, x.lo * power);
}

/* Returns the square root of a. The start value is the root of the first word. Each of two steps of Newton's method
   adds a word. */
VM_API vmi_three vmi_three_sqrt(vmi_three a)
{
    const vm_real root = VM_SQRT(a.hi);
    vmi_three x = vmi_three_words(root, 0, 0);
    int i;
    for (i = 0; i < 2; i++) {
        const vmi_three rest = vmi_three_plus(a, vmi_three_scaled(vmi_three_times(x, x), -1));
        x = vmi_three_plus(x, vmi_three_words((rest.hi + (rest.mid + rest.lo)) / (2 * root), 0, 0));
    }
    return x;
}

/* Returns the number pi/2 in three words. */
VM_API vmi_three vmi_half_pi(void)
{
#if VM_MANT_DIG > 24
    return vmi_three_words(VM_C(1.570796326794896557999), VM_C(6.123233995736766035869e-17),
                           VM_C(-1.497384904859169832944e-33));
#else
    return vmi_three_words(VM_C(1.570796370506286621094), VM_C(-4.371138828673792886548e-8),
                           VM_C(-1.715124510005881872804e-15));
#endif
}

/* Returns a - root^2 without loss of digits. The argument `root` must be the rounded square root of a. */
VM_API vm_real vmi_root_residual(vm_real a, vm_real root)
{
    const vm_real head = vmi_head(root), tail = root - head;
    return ((a - head * head) - 2 * head * tail) - tail * tail;
}

/* Returns the square root of a + a_lo in two words, where a_lo is below an ulp of a. */
VM_API vm_two vmi_root(vm_real a, vm_real a_lo)
{
    const vm_real root = vmi_rounded(VM_SQRT(a));
    return vmi_two(root, (vmi_root_residual(a, root) + a_lo) / (2 * root));
}

/* Returns x if it lies between low and high, else the nearer of these bounds. A NaN stays NaN. */
VM_INLINE vm_real vmi_clamp(vm_real x, vm_real low, vm_real high)
{
    if (x > high) x = high;
    if (x < low) x = low;
    return x;
}

/* Returns the product of x and a power of two, which is exact. */
VM_API vm_two vmi_two_shifted(vm_two x, vm_real power) { return vmi_two(x.hi * power, x.lo * power); }

/* Returns the difference x - y of numbers in two words. */
VM_API vm_two vmi_two_minus(vm_two x, vm_two y) { return vmi_two_plus(x, vmi_two(-y.hi, -y.lo)); }

/* Returns the square root of x >= 0. For x below 2^-500 (float 2^-80) the low word of the result is not reliable. */
VM_API vm_two vmi_two_root(vm_two x)
{
    if (x.hi > 0) return vmi_root(x.hi, x.lo);
    return vmi_two(0, 0);
}

/* Returns the number -x. */
VM_API vm_two vmi_minus(vm_two x)
{
    x.hi = -x.hi;
    x.lo = -x.lo;
    return x;
}

/* Returns the number x / 2. */
VM_API vm_two vmi_half(vm_two x)
{
    x.hi /= 2;
    x.lo /= 2;
    return x;
}

/* Returns the product of x and a factor of one word. */
VM_API vm_two vmi_two_scaled(vm_two x, vm_real factor)
{
    vm_two p = vmi_two_product(x.hi, factor);
    return vmi_fast_two_sum(p.hi, p.lo + x.lo * factor);
}

/* Returns the sum a b + c d of two products, with a relative error of at most 2 eps, even where the products nearly
   cancel each other. No product may underflow. */
VM_API vm_real vmi_sum_of_products(vm_real a, vm_real b, vm_real c, vm_real d)
{
    const vm_two ab = vmi_two_product(a, b), cd = vmi_two_product(c, d);
    const vm_two high = vmi_two_sum(ab.hi, cd.hi), low = vmi_two_sum(ab.lo, cd.lo);
    const vm_two sum = vmi_two_sum(high.hi, low.hi);
    return sum.hi + (sum.lo + (high.lo + low.lo));
}

#endif
