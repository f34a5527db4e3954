/* draws.h - what random evaluations draw, and how they compare. To be included after ../../varmass.h. */
#ifndef EVALUATIONS_DRAWS_H
#define EVALUATIONS_DRAWS_H

#include <math.h>

#define EPS VM_EPSILON
#define R(x) ((vm_real)(x))
enum { IS_FLOAT = VM_MANT_DIG == 24, BLOCK = 1 << 11, PHASES = 8 }; /* PHASES arguments for each parameter that is drawn */

typedef struct random_bits {
    uint64_t state;
} random_bits;

static uint64_t next_bits(random_bits *g) /* Steele's splitmix64 */
{
    uint64_t z = g->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static vm_real uniform(random_bits *g, double low, double high)
{
    return R(low + (high - low) * ((double)(next_bits(g) >> 11) / 9007199254740992.0));
}

/* A random number between 2^from and 2^to, in which all sizes are equally frequent */
static vm_real of_size(random_bits *g, int from, int to)
{
    const uint64_t bits = next_bits(g);
    const int k = from + (int)(bits % (uint64_t)(to - from));
    return vmi_ldexp(1 + R((double)(bits >> 12) / 4503599627370496.0), k);
}

/* A random parameter m. Half of these numbers lie between 0 and 1; the others are close to 1, or lie between -20 and 1 or
   between -2^300 (in float -2^60) and 0. */
static vm_real random_m(random_bits *g)
{
    switch (next_bits(g) & 7) {
    case 0: return 1 - of_size(g, IS_FLOAT ? -23 : -52, 0);
    case 1: return -of_size(g, -30, IS_FLOAT ? 60 : 300);
    case 2:
    case 3: return uniform(g, -20, 1);
    default: return uniform(g, 0, 1);
    }
}

static vm_real random_alpha(random_bits *g)
{
    switch (next_bits(g) & 3) {
    case 0: return R(next_bits(g) % 17) / 2;
    case 1: return of_size(g, -20, 20);
    default: return uniform(g, 0, 8);
    }
}

/* Mostly within some periods; now and then up to 1e9 and 1e9 quarters (float 1e4, 2^17), as far as bounds are promised */
static vm_real random_phase(random_bits *g, vm_real quarter)
{
    const vm_real far1 = IS_FLOAT ? R(1e4) : R(1e9), far2 = (IS_FLOAT ? R(131072.) : R(1e9)) * quarter;
    const vm_real far = far2 < far1 ? far2 : far1;
    if ((next_bits(g) & 7) == 0) return uniform(g, -1, 1) * far;
    if (!VM_IS_FINITE(quarter) || quarter > far / 8) quarter = far / 8;
    return uniform(g, -8, 8) * quarter;
}

static vm_real next_up(vm_real x) /* x > 0 finite */ { return vmi_from_bits(vmi_to_bits(x) + 1); }

typedef struct trial {
    vm_real x, y, z; /* what was drawn */
    int good;
} trial;

static trial result(vm_real x, vm_real y, vm_real z, int good)
{
    trial t;
    t.x = x;
    t.y = y;
    t.z = z;
    t.good = good;
    return t;
}

/* The number to which an error of x is compared: subnormal numbers have the spacing of the smallest normal one. */
static vm_real size_of(vm_real x) { return VM_FABS(x) > VM_MIN ? VM_FABS(x) : VM_MIN; }

/* Is the difference of a and b at most `epsilons` eps times the larger of the two? */
static int same_size(vm_real a, vm_real b, double epsilons)
{
    const vm_real size = size_of(VM_FABS(a) > VM_FABS(b) ? a : b);
    return VM_FABS(a - b) <= R(epsilons) * EPS * size;
}

/* A random complementary parameter m1 = 1 - m. Most of these numbers are so small that m is close to 1. */
static vm_real random_m1(random_bits *g) { return of_size(g, IS_FLOAT ? -100 : -1000, 1); }

#endif
