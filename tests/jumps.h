/* jumps.h - what the tests of jumps share: how far the balances of momenta are off, how far two motions are apart,
   and random bodies in the plane. */
#ifndef JUMPS_H
#define JUMPS_H

#include "bodies.h"

/* What a balance leaves of momentum and of angular momentum, in eps of its scales, and of energy */
typedef struct defect {
    double K, L, energy;
} defect;

static inline defect defect_of(int n_before, const vm_body *before, int n_after, const vm_body *after,
                               const vm_impulse *j, vm_vec3 about)
{
    vm_balance b;
    defect d = {1e99, 1e99, 1e99};
    if (vm_balance_between(n_before, before, n_after, after, j, about, &b)) return d;
    d.K = size_of(b.momentum) / (eps * (double)b.momentum_scale);
    d.L = size_of(b.angular_momentum) / (eps * (double)b.angular_momentum_scale);
    d.energy = (double)b.energy;
    return d;
}

/* One body parts into the rest and the part. */
static inline defect parted(const vm_body *whole, const vm_body *rest, const vm_body *part, const vm_impulse *j,
                            vm_vec3 about)
{
    vm_body after[2];
    after[0] = *rest;
    after[1] = *part;
    return defect_of(1, whole, 2, after, j, about);
}

/* Two bodies join to a whole. */
static inline defect joined(const vm_body *a, const vm_body *b, const vm_body *whole, const vm_impulse *j,
                            vm_vec3 about)
{
    vm_body before[2];
    before[0] = *a;
    before[1] = *b;
    return defect_of(2, before, 1, whole, j, about);
}

/* The bounds that the manual promises */
static inline void check_defect(const char *what, const char *region, defect d, double x)
{
    check_error(what, region, "eps K", d.K, 3, x, 0);
    check_error(what, region, "eps L", d.L, 6, x, 0);
}

/* How far two motions are apart, in eps: the largest relative difference of velocity, spin, place and mass */
static inline double apart(const vm_body *a, const vm_body *b)
{
    double moved = size_of(vm_sub(a->v, b->v)) / (5 + size_of(b->v));
    double turned = size_of(vm_sub(a->omega, b->omega)) / (5 + size_of(b->omega));
    double shifted = size_of(vm_sub(a->r, b->r)) / (5 + size_of(b->r));
    return fmax(fmax(moved, turned), fmax(shifted, fabs((double)(a->mass / b->mass - 1)))) / eps;
}

/* A body with room for any part, and a part of it */
static inline vm_body whole_and_part(vm_body *part)
{
    vm_body whole = random_body(5, 1);
    whole.inertia.xx += 1;
    whole.inertia.yy += 1;
    whole.inertia.zz += 1;
    *part = whole;
    part->mass = 1;
    part->inertia =
        vmi_inertia_plus(vmi_inertia_of_point(vector(0, 0, 0)), R(0.01), vmi_inertia_of_point(vector(1, 1, 1)));
    part->r = vm_add(whole.r, vector(0.1, 0, 0));
    return whole;
}

/* ---- In the plane ---- */

static inline vm_body2 random_body2(double mass)
{
    vm_body2 b;
    b.mass = R(mass);
    b.inertia = R(mass * uniform(0.05, 0.5));
    b.angle = R(uniform(-3, 3));
    b.x = R(uniform(-2, 2));
    b.y = R(uniform(-2, 2));
    b.vx = R(uniform(-3, 3));
    b.vy = R(uniform(-3, 3));
    b.omega = R(uniform(-3, 3));
    return b;
}

static inline vm_impulse2 random_impulse2(void)
{
    vm_impulse2 j;
    j.jx = R(uniform(-3, 3));
    j.jy = R(uniform(-3, 3));
    j.couple = R(uniform(-3, 3));
    j.x = R(uniform(-3, 3));
    j.y = R(uniform(-3, 3));
    return j;
}

/* apart() of a body in the plane from a body in space that should be this lamina */
static inline double apart2(const vm_body2 *got, const vm_body *in_space)
{
    vm_body b = vm_body_from_body2(got);
    double of_inertia = fabs((double)(got->inertia / in_space->inertia.zz - 1)) / eps;
    return fmax(apart(&b, in_space), of_inertia);
}

static inline vm_impulse impulse_in_space(const vm_impulse2 *j)
{
    vm_impulse blow;
    blow.linear = vmi_vec3(j->jx, j->jy, 0);
    blow.couple = vmi_vec3(0, 0, j->couple);
    blow.at = vmi_vec3(j->x, j->y, 0);
    return blow;
}

#endif
