/* every_float.h - a function in float at every float of a period: the loop over the floats, a block of them at a time, and the
   worst errors of a block. For exhaustive_jacobi.c and exhaustive_ateb.c, which include check.h before. */
#ifndef EVERY_FLOAT_H
#define EVERY_FLOAT_H

enum { BLOCK = 1024 };

/* What a program tries: a parameter of its functions, and how the parameter is named in the output. */
typedef struct {
    const char *region;
    float parameter;
} float_case;

/* The errors of the results `got` at the arguments x, n <= BLOCK of them: at most 4 eps of the function's largest value, and at
   most `bound` ulp. The zeros of the function may be shifted by a share `shift` of x: the error in ulp does not count that. */
static inline void check_floats(const char *function, const float_case *c, int n, const float *x, const float *got,
                                const double *exact, double largest, double shift, double bound)
{
    double worst_eps = 0, worst_ulp = -HUGE_VAL;
    int at_eps = 0, at_ulp = 0, i;
    for (i = 0; i < n; i++) {
        const double error = fabs((double)got[i] - exact[i]);
        const double ulps = (error - shift * (double)x[i]) / ULP(exact[i]);
        if (!(error <= worst_eps)) {
            worst_eps = error;
            at_eps = i;
        }
        if (!(ulps <= worst_ulp)) {
            worst_ulp = ulps;
            at_ulp = i;
        }
    }
    check_error(function, c->region, "eps", worst_eps / (double)VM_EPSILON / largest, 4, (double)x[at_eps],
                (double)c->parameter);
    check_error(function, c->region, "ulp", worst_ulp, bound, (double)x[at_ulp], (double)c->parameter);
}

/* Call `check` for the floats from 0 to `last`, or for every stride-th of them: the bits of positive floats are in their order. */
static inline void for_every_float(const float_case *c, float last, unsigned long stride,
                                   void (*check)(const float_case *c, int n, const float *x))
{
    float x[BLOCK];
    vmi_bits bits;
    int n = 0;
    for (bits = 0; bits <= vmi_to_bits(last); bits += (vmi_bits)stride) {
        x[n++] = vmi_from_bits(bits);
        if (n == BLOCK) {
            check(c, n, x);
            n = 0;
        }
    }
    if (n) check(c, n, x);
}

#endif
