/* rods.h - thin rods in the plane, for the tests of Lagrange's equations across a jump and of the pendulum. */
#ifndef RODS_H
#define RODS_H

#include "bodies.h"

/* The error of got in eps of scale. */
static inline void check_case(const char *what, const char *region, vm_real got, double expected, double scale,
                              double bound)
{
    check_error(what, region, "eps", ERROR_EPS(got, expected, 0, scale), bound, expected, 0);
}

/* A thin rod at rest; angle is from the x axis. */
static inline vm_body rod_at(double mass, double length, double angle, vm_vec3 middle)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = R(mass);
    b.r = middle;
    b.inertia = vmi_inertia_plus(b.inertia, R(mass * length * length / 12),
                                 vmi_inertia_of_point(vector(cos(angle), sin(angle), 0)));
    return b;
}

#endif
