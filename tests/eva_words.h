/* For Frama-C's EVA (tests/eva.sh): sum, product and quotient in two words, replaced by what is known of them. Intervals do
   not relate hi to lo, so that EVA would lose |lo| <= ulp(hi)/2, and with it every bound after a few operations.

   The theorems: a + b = hi + lo exactly in vmi_two_sum (Knuth); |lo| <= eps (|hi| + |b|) in vmi_fast_two_sum without any order
   of a and b; |lo| <= eps |hi| + the smallest normal number in vmi_two_product (Dekker, Veltkamp); the residual of a
   quotient is that of its product. Where something could overflow the words are any numbers. What is replaced has no
   statement but sums, products and quotients of numbers, which are defined for all arguments. */
#include <math.h>
#define VM_SQRT(x) VM_LIBM(sqrt)(x)
#define VM_FABS(x) VM_LIBM(fabs)(x)
#define VM_FLOOR(x) VM_LIBM(floor)(x)
#define VM_COPYSIGN(x, y) vmi_copysign(x, y) /* EVA knows the others */
#include EVA_HEADER

volatile vm_real any;
volatile int any_int;
vm_real sink[8];

int impossible(void) /* where EVA cannot see that it is */
{
    while (1)
        ;
    return 0;
}

#define NUMBER(x) ((x) == (x) || impossible())
#define LARGE (VM_MAX / VM_C(4e9))
#define ORDINARY(x) (-LARGE < (x) && (x) < LARGE && NUMBER(x))

/* hi and a low word of at most bound */
vm_two eva_words(vm_real hi, vm_real bound)
{
    vm_two x;
    x.hi = hi;
    x.lo = any;
    if (!(-bound <= x.lo && x.lo <= bound && NUMBER(x.lo))) x.lo = 0;
    return x;
}

vm_two eva_any_words(vm_real hi)
{
    vm_two x;
    x.hi = hi;
    x.lo = any;
    return x;
}

vm_two eva_two_sum(vm_real a, vm_real b)
{
    if (ORDINARY(a) && ORDINARY(b)) {
        const vm_real sum = a + b;
        return eva_words(sum, VM_EPSILON * VM_FABS(sum));
    }
    return eva_any_words(a + b);
}

vm_two eva_fast_two_sum(vm_real a, vm_real b)
{
    if (ORDINARY(a) && ORDINARY(b)) {
        const vm_real sum = a + b;
        return eva_words(sum, VM_EPSILON * (VM_FABS(sum) + VM_FABS(b)));
    }
    return eva_any_words(a + b);
}

vm_two eva_two_product(vm_real a, vm_real b)
{
    const vm_real product = a * b;
    if (ORDINARY(a) && ORDINARY(b) && ORDINARY(product))
        return eva_words(product, VM_EPSILON * VM_FABS(product) + VM_MIN);
    return eva_any_words(product);
}

vm_two eva_two_over(vm_two x, vm_two y)
{
    const vm_real z = x.hi / y.hi;
    if (ORDINARY(x.hi) && ORDINARY(y.hi) && ORDINARY(z)) {
        const vm_real rest = 2 * VM_EPSILON * VM_FABS(x.hi) + VM_FABS(x.lo) + VM_FABS(z * y.lo);
        return eva_two_sum(z, eva_words(0, 2 * (rest / VM_FABS(y.hi)) + VM_MIN).lo);
    }
    return eva_any_words(any);
}
