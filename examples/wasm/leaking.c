/* The leaking oscillator in a browser: computes x(t) of m x'' + k x |x|^(alpha-1) = -r m' x' with m = 1 + rate t by
   vm_osc_within, for the page index.html. The program calls only sqrt, floor, fabs and copysign, which WebAssembly has
   as instructions.

   Run make wasm; then serve the folder that contains leaking.wasm (python3 -m http.server) and open it in a browser.
   cc -O2 leaking.c -lm && ./a.out prints the same numbers as node leaking.mjs leaking.wasm, bit for bit. */
#include <stdio.h>
#include "../../varmass.h"

#ifdef __wasm__
#define EXPORT(name) __attribute__((export_name(#name))) name
#else
#define EXPORT(name) name
#endif

enum { MOST = 2000 };
static double points[2 * MOST]; /* x, amplitude, x, amplitude ... */

double *EXPORT(buffer)(void);
int EXPORT(motion)(double alpha, double rate, double reactive, double end, int n);

double *buffer(void) { return points; }

/* Computes n points for t from 0 to end. Returns how many of them are before the time at which no mass is left. */
int motion(double alpha, double rate, double reactive, double end, int n)
{
    vm_osc_problem problem;
    vm_osc_plan plan;
    vm_osc_motion now;
    int i;
    memset(&problem, 0, sizeof problem);
    problem.alpha = alpha;
    problem.mass = vm_law_linear(1, rate);
    problem.stiffness = vm_law_linear(1, 0);
    problem.reactive = reactive;
    problem.x = 1;
    if (n > MOST || vm_osc_plan_init(&plan, &problem) < 0) return 0;
    for (i = 0; i < n; i++) {
        if (vm_osc_plan_within(&plan, end * i / (n - 1), 1e-3, &now) < 0) return i;
        points[2 * i] = now.x;
        points[2 * i + 1] = now.amplitude;
    }
    return n;
}

#ifndef __wasm__
int main(void)
{
    const int n = motion(3, -0.01, 0, 60, 7);
    int i;
    for (i = 0; i < n; i++) printf("t = %2d  x = %.16e  amplitude %.16e\n", 10 * i, points[2 * i], points[2 * i + 1]);
    return 0;
}
#endif
