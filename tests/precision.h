/* precision.h - the type that a test program is compiled for: its numbers, its epsilon, and bounds that depend on
   it. Include it after ../varmass.h and check.h. */
#ifndef PRECISION_H
#define PRECISION_H

#define R(x) ((vm_real)(x))

static const double pi = 3.14159265358979323846;
static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

/* A bound, tolerance or size that differs between the two types */
static inline double by_precision(double in_double, double in_float) { return is_float ? in_float : in_double; }

#endif
