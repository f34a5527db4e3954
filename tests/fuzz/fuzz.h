/* fuzz.h - what the fuzz targets share: numbers out of bytes, the check of a property, the entry points.

   A target is a function of the bytes in fuzz: it draws arguments from them, calls, and says by HOLDS what must be
   true. Built by clang -fsanitize=fuzzer it is a libFuzzer target (make test-fuzz); tests/fuzz/replay.c runs all
   targets on the stored inputs and on pseudo-random ones with any compiler (make test). */
#ifndef FUZZ_H
#define FUZZ_H

#ifndef HEADERS_ELSEWHERE /* tests/fuzz/planted.sh puts changed copies first */
#include "../../varmass.h"
#else
#include "varmass.h"
#endif
#include <stdio.h>
#include <stdlib.h>

#define R(x) ((vm_real)(x))
#define EPS ((double)VM_EPSILON)
enum { IS_FLOAT = VM_MANT_DIG == 24, FUZZ_DRAWN = 48 };

static struct {
    const unsigned char *at, *end; /* the bytes that are left; beyond them come zeros */
    const char *target;
    double drawn[FUZZ_DRAWN]; /* the numbers of this run, for the report of a violation */
    int n_drawn, wild;        /* draw_any drew a number whose powers or quotients may overflow */
    long violations, checks;
} fuzz;

static void fuzz_begin(const char *target, const unsigned char *bytes, size_t size)
{
    fuzz.target = target;
    fuzz.at = bytes;
    fuzz.end = bytes + size;
    fuzz.n_drawn = fuzz.wild = 0;
}

/* A property is violated: says which, and what was drawn; libFuzzer takes the abort and keeps the input. */
static void fuzz_violated(const char *file, int line, const char *property)
{
    int i;
    printf("VIOLATED %s (%s), %s:%d: %s; drawn:", fuzz.target, IS_FLOAT ? "float" : "double", file, line, property);
    for (i = 0; i < fuzz.n_drawn && i < FUZZ_DRAWN; i++) printf(" %.17g", fuzz.drawn[i]);
    printf("\n");
    fuzz.violations++;
#ifndef REPLAY
    fflush(stdout);
    abort();
#endif
}
#define HOLDS(property) (fuzz.checks++, (property) ? (void)0 : fuzz_violated(__FILE__, __LINE__, #property))

/* ---- numbers ---- */

static unsigned draw_byte(void) { return fuzz.at < fuzz.end ? *fuzz.at++ : 0; }
static int draw_below(int n) { return (int)(draw_byte() % (unsigned)n); }

static uint64_t draw_bits(int bytes)
{
    uint64_t bits = 0;
    while (bytes-- > 0) bits = bits << 8 | draw_byte();
    return bits;
}

static vm_real drawn(double x)
{
    if (fuzz.n_drawn < FUZZ_DRAWN) fuzz.drawn[fuzz.n_drawn++] = (double)R(x);
    return R(x);
}

/* in [0, 1], the ends included */
static double draw_unit(void)
{
    const uint64_t bits = draw_bits(6);
    return (double)(bits + (draw_byte() & 1)) / 281474976710656.0;
}

static vm_real draw_in(double low, double high)
{
    double x = low + (high - low) * draw_unit();
    return drawn(x < low ? low : x > high ? high : x);
}

/* uniform in the logarithm; exp and log of the C library would make inputs depend on it */
static vm_real draw_log(double low, double high)
{
    int from, to, k;
    double x;
    frexp(low, &from);
    frexp(high, &to);
    k = from + (int)(draw_bits(2) % (uint64_t)(to - from + 1));
    x = ldexp(0.5 + draw_unit() / 2, k);
    return drawn(x < low ? low : x > high ? high : x);
}

#define SMALLEST (VM_MIN * VM_EPSILON) /* the smallest positive number, and the distance of subnormal numbers */

static vm_real neighbour(vm_real x, int steps)
{
    for (; steps > 0; steps--) x = VM_LIBM(nextafter)(x, VM_INFINITY);
    for (; steps < 0; steps++) x = VM_LIBM(nextafter)(x, -VM_INFINITY);
    return x;
}

static vm_real special(void)
{
    static const double values[] = {
        0, 0.5, 1, 1.5, 2, 3, 5, 7, 1e10, 1e30, 3.141592653589793, 1e-10, 1e-30, 0.69314718055994531};
    const int n = (int)(sizeof values / sizeof *values), i = draw_below(n + 6);
    if (i < n) return R(values[i]);
    if (i == n) return VM_EPSILON;
    if (i == n + 1) return VM_MIN;
    if (i == n + 2) return SMALLEST;
    if (i == n + 3) return VM_MAX;
    return i == n + 4 ? VM_INFINITY : VM_NAN;
}

static vm_real draw_of_kind(int kind)
{
    vm_real x;
    if (kind == 0) {
        vmi_bits bits = (vmi_bits)draw_bits((int)sizeof bits);
        memcpy(&x, &bits, sizeof x);
        return drawn((double)x);
    }
    if (kind == 1) return drawn((double)(draw_byte() & 1 ? -special() : special()));
    if (kind == 2) {
        x = draw_byte() & 1 ? -special() : special();
        return drawn((double)neighbour(x, draw_below(7) - 3));
    }
    if (kind == 3) return drawn((double)((int)draw_byte() - 128) / 8);
    if (kind == 4) return draw_in(-4, 4);
    x = kind == 5 ? draw_log((double)VM_MIN, (double)VM_MAX) : draw_log(1e-6, 1e6);
    return draw_byte() & 1 ? -x : x;
}

/* any number of the type: bit patterns, special values and their neighbours, sizes of all kinds */
static vm_real draw_any(void)
{
    const vm_real x = draw_of_kind(draw_below(8));
    if (!(x == 0 || (VM_FABS(x) >= R(1e-6) && VM_FABS(x) <= 16))) fuzz.wild = 1;
    return x;
}

/* Draws must not share an expression: C leaves open which is made first, and a stored input must mean the same with
   every compiler. */

/* x, or one of its four neighbours on either side */
static vm_real draw_beside(vm_real x) { return drawn((double)neighbour(x, draw_below(9) - 4)); }

/* a number of either sign, at least 1e-12 in size */
static vm_real draw_signed(double largest)
{
    const int sign = draw_byte() & 1 ? -1 : 1;
    return drawn(sign * (double)draw_log(1e-12, largest));
}

/* mostly the first function of the two, now and then any number: the branches that refuse are short */
#define MOSTLY(usual) (draw_byte() % 16 ? (usual) : draw_any())

static int is_nan(vm_real x) { return x != x; }
static int is_finite(vm_real x) { return VM_IS_FINITE(x); }
static double larger(double a, double b) { return a > b ? a : b; }
/* what is below the normal numbers counts as 0 */
static int within(vm_real a, vm_real b, double tolerance)
{
    return a == b || fabs((double)a - (double)b) <= tolerance + (double)VM_MIN;
}

/* a and b agree to so many eps of the larger, below the normal numbers to so many of their spacing */
static int close_to(vm_real a, vm_real b, double epsilons)
{
    return within(a, b, epsilons * EPS * larger(larger(fabs((double)a), fabs((double)b)), (double)VM_MIN));
}

static int same_bits(vm_real a, vm_real b) { return a == b || (a != a && b != b); }

/* what must stay untouched on errors: STAINED(x) before the call, UNTOUCHED(x) after it */
static void fuzz_stain(void *x, size_t size) { memset(x, 0x5a, size); }
static int fuzz_stained(const void *x, size_t size)
{
    const unsigned char *byte = (const unsigned char *)x;
    while (size-- > 0)
        if (*byte++ != 0x5a) return 0;
    return 1;
}
#define STAIN(x) fuzz_stain(&(x), sizeof(x))
#define UNTOUCHED(x) fuzz_stained(&(x), sizeof(x))

/* ---- entry points ---- */

#ifdef REPLAY
#define FUZZ_TARGET(name)
#else
int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size);
#define FUZZ_TARGET(name)                                               \
    int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size) \
    {                                                                   \
        fuzz_begin(#name, bytes, size);                                 \
        fuzz_##name();                                                  \
        return 0;                                                       \
    }
#endif

#endif
