/* hard.h - what the catalogue of hard cases shares: how a case is written, and the naive formulas' common tools.

   A kernel is a pair of functions of up to six numbers: NAME_ours, by the headers, and NAME_naive, the textbook's or
   [1]'s formula evaluated in the same precision. A case is a kernel at one point: the text says what would go wrong,
   the bound is on the error of ours, in eps of the value (of a scale, where the generator gives one). The true values
   are tests/data/hard.h, made by tests/gen/hard_reference.py, which reads the cases from these files: to add one,
   write its line, and the kernel's function in the generator, and run the generator. In float the points are rounded
   to float, and the true values are those of the rounded points. */
#ifndef HARD_H
#define HARD_H

#include "../../varmass.h"
#include "../check.h"

enum { HARD_INPUTS = 6 };
typedef struct hard_case {
    const char *kernel;
    vm_real (*ours)(const vm_real *x), (*naive)(const vm_real *x);
    double bound;
    const char *text;
    double x[HARD_INPUTS];
} hard_case;

#ifdef VM_USE_FLOAT
#define R(in_double, in_float) in_float
#else
#define R(in_double, in_float) in_double
#endif
/* clang-format off */
#define CASE(kernel, bound, text, ...) {#kernel, kernel##_ours, kernel##_naive, bound, text, {__VA_ARGS__}}
/* clang-format on */

#define SIN(x) VM_LIBM(sin)(x)
#define COS(x) VM_LIBM(cos)(x)
#define EXP(x) VM_LIBM(exp)(x)
#define LOG(x) VM_LIBM(log)(x)
#define POW(x, y) VM_LIBM(pow)(x, y)
#define SQRT(x) VM_LIBM(sqrt)(x)
#define FABS(x) VM_LIBM(fabs)(x)
#define FMOD(x, y) VM_LIBM(fmod)(x, y)
#define ATAN2(y, x) VM_LIBM(atan2)(y, x)
#define GAMMA(x) VM_LIBM(tgamma)(x)

/* a fixed number of steps of the classical method, written as every textbook does */
static inline void naive_rk4(void (*f)(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x),
                             const vm_real *x, int n, vm_real *y, vm_real t_end, long steps)
{
    vm_real k1[6], k2[6], k3[6], k4[6], z[6], t = 0;
    const vm_real h = t_end / (vm_real)steps;
    long step;
    int i;
    for (step = 0; step < steps; step++) {
        f(t, y, k1, x);
        for (i = 0; i < n; i++) z[i] = y[i] + h / 2 * k1[i];
        f(t + h / 2, z, k2, x);
        for (i = 0; i < n; i++) z[i] = y[i] + h / 2 * k2[i];
        f(t + h / 2, z, k3, x);
        for (i = 0; i < n; i++) z[i] = y[i] + h * k3[i];
        f(t + h, z, k4, x);
        for (i = 0; i < n; i++) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        t += h;
    }
}

#endif
