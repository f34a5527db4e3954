/* nearly_exhausted.h - an oscillator whose mass is nearly exhausted, and its exact motion. m = m0 + m' t falls to a small share of
   m0, and half of the reactive force acts: m x'' + m' x'/2 + k x = 0. In the time 2 (sqrt(m) - sqrt(m0))/m' the motion is
   harmonic. The rounding error of m' t changes mass and phase rate by many rounding errors; the estimates of errors once left
   this out, and the true error was up to 10^8 times the estimate. Include it after ../varmass.h. */
#ifndef NEARLY_EXHAUSTED_H
#define NEARLY_EXHAUSTED_H

#include <math.h>

typedef struct {
    vm_law mass;
    vm_real stiffness, t; /* the motion starts at x = x' = 1 */
    double x, v;          /* at t */
    double A, vmax;       /* amplitude and largest velocity at t */
} exhausted_motion;

/* The motion at the time when the share `left` of the mass is left */
static inline exhausted_motion nearly_exhausted(double left)
{
    const vm_real m0 = (vm_real)1.75, rate = (vm_real)-0.023975;
    exhausted_motion e;
    double m, start, w, s;
    e.stiffness = (vm_real)6.28;
    e.mass = vm_law_linear(m0, rate);
    e.t = (vm_real)((1 - left) * (double)m0 / -(double)rate);
    m = fma((double)rate, (double)e.t, (double)m0);
    start = sqrt((double)m0);
    w = sqrt((double)e.stiffness);
    s = 2 * (sqrt(m) - start) / (double)rate;
    e.x = cos(w * s) + start / w * sin(w * s);
    e.v = (start * cos(w * s) - w * sin(w * s)) / sqrt(m);
    e.A = hypot(1, start / w);
    e.vmax = e.A * w / sqrt(m);
    return e;
}

/* The larger of |error of x|/A and |error of v|/vmax, divided by the estimated error */
static inline double exhausted_ratio(const exhausted_motion *e, vm_real x, vm_real v, vm_real error)
{
    return fmax(fabs((double)x - e->x) / e->A, fabs((double)v - e->v) / e->vmax) / (double)error;
}

#endif
