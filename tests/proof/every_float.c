/* The bounds of vmi_log and vmi_exp in float, proved by trying every float.

   There are 2^31 positive floats. For each of them vmi_log is compared with the C library's logl, and for each float of
   either sign vmi_exp(x, 0) with expl; long double has at least 29 digits more than float, so that its own error does
   not count. x_lo is 0 here; tests/proof/exponential.py proves the bound of vmi_exp for all x_lo.

   usage: every_float quick|full LOG_BOUND EXP_BOUND
   LOG_BOUND is the relative error allowed, EXP_BOUND the error in ulps. "quick" tries the floats from 1/2 to 2, where
   the logarithm is least accurate, and for the exponential every 1009th float. */
#define VM_USE_FLOAT
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../jacobi.h"

typedef struct worst_error {
    double error;
    float x;
} worst_error;

static void keep_worst(worst_error *worst, double error, float x)
{
    if (worst->error != worst->error || error <= worst->error) return; /* a NaN is kept */
    worst->error = error;
    worst->x = x;
}

/* The relative error of the logarithm for all floats whose bits lie between `first` and `last` */
static worst_error worst_logarithm(uint32_t first, uint32_t last)
{
    worst_error worst = {0, 0};
    uint32_t bits;
    for (bits = first; bits <= last; bits++) {
        const float x = vmi_from_bits(bits);
        const vm_two l = vmi_log(x);
        const long double right = logl((long double)x);
        if (right != 0)
            keep_worst(&worst, (double)(fabsl(((long double)l.hi - right) + (long double)l.lo) / fabsl(right)), x);
        else if (l.hi != 0 || l.lo != 0) keep_worst(&worst, HUGE_VAL, x);
    }
    return worst;
}

/* An ulp of a float with this value; below the least normal number all ulps are equal */
static long double ulp(long double value)
{
    int exponent;
    frexpl(value, &exponent);
    if (exponent < FLT_MIN_EXP) exponent = FLT_MIN_EXP;
    return ldexpl(1, exponent - FLT_MANT_DIG);
}

/* The error of the exponential in ulps for every `step`-th float; results that overflow are left out */
static worst_error worst_exponential(uint32_t step)
{
    worst_error worst = {0, 0};
    const long double largest = logl((long double)FLT_MAX);
    uint32_t bits;
    for (bits = 0; bits < UINT32_C(0x7f800000); bits += step) {
        const float size = vmi_from_bits(bits);
        int sign;
        for (sign = -1; sign <= 1; sign += 2) {
            const float x = (float)sign * size;
            const long double right = expl((long double)x);
            if ((long double)x > largest) continue;
            keep_worst(&worst, (double)(fabsl((long double)vmi_exp(x, 0) - right) / ulp(right)), x);
        }
    }
    return worst;
}

static int judge(const char *name, const char *unit, worst_error worst, double bound)
{
    const int kept = worst.error <= bound;
    printf("%-15s float  %-12.5g %s: worst %.5g%s at %a\n", name, bound, kept ? "kept" : "FAILED", worst.error, unit,
           (double)worst.x);
    return kept;
}

int main(int count, char **argument)
{
    uint32_t first = UINT32_C(0x3f000000), last = UINT32_C(0x3fffffff), step = 1009;
    int kept;
    if (count != 4) return 2;
    if (strcmp(argument[1], "full") == 0) {
        first = 1;
        last = UINT32_C(0x7f7fffff);
        step = 1;
    }
    kept = judge("log_floats", "", worst_logarithm(first, last), strtod(argument[2], NULL));
    kept += judge("exp_floats", " ulp", worst_exponential(step), strtod(argument[3], NULL));
    return kept != 2;
}
