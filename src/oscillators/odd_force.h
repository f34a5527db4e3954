/* oscillators/odd_force.h - vibration under an odd elastic force of any form, with constant mass

   The equation is x'' + F(x) = 0. F is the force per unit mass, and an odd function, that is F(-x) = -F(x): for example
   x + x^3, sin x, tanh x, or a function of the user. A vm_odd_force describes F. Its constructors, the functions that
   make a vm_odd_force, are vm_odd_force_user in this file, and vm_duffing_force and vm_duffing_force_of_laws in
   oscillators/duffing.h.
   For each amplitude A one numerical integration (a quadrature) gives the period, the action and x(t):
       vm_odd_force force = vm_odd_force_user(hard, NULL); // int hard(vm_real x, vm_real *f, void *ctx) writes *f
       vm_real T = vm_odd_period(&force, 2); // period of the motion from rest at x = 2 m
   Method: an angle theta replaces the time. With x = A cos(theta) the velocity is v = -A sin(theta) sqrt(g), and dt =
   dtheta/sqrt(g). Here g is the mean of F/x as a function of x^2, between the present x^2 and A^2. Gauss' rule
   integrates 1/sqrt(g) over theta, and converges fast because g is smooth and positive. An orbit is the motion at one
   amplitude. The phase of the orbit is 2 pi t/period. It is 0 at the turning point with the larger |x|; of the two
   turning points of an orbit around x = 0, it is the one with x > 0. The action j of the orbit is the integral of v dx
   over a period, divided by 2 pi. For mass, stiffness and damping that change slowly see oscillators/odd_motion.h.
   Tests: tests/test_odd_force.c. */
#ifndef VARMASS_OSCILLATORS_ODD_FORCE_H
#define VARMASS_OSCILLATORS_ODD_FORCE_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "legendre.h"

/* -- The force and its orbits -- */

/* A user's odd function: writes F(x) for x >= 0 to *f. It returns 0 on success, and any other number if it cannot
   compute F(x). F must be smooth for x >= 0; at x = 0 it may have a kink, as x|x| does. */
typedef int (*vm_odd_function)(vm_real x, vm_real *f, void *ctx);

typedef struct VM_TAG(vmi_orbit) vmi_orbit;
typedef struct VM_TAG(vmi_orbit_point) vmi_orbit_point;
typedef struct VM_TAG(vmi_orbit_ripple) vmi_orbit_ripple; /* oscillators/orbit_ripple.h */

/* An odd elastic force F(x). The constructors vm_odd_force_user and vm_duffing_force fill this struct. The struct
   contains the user's pointer ctx, and pointers to the user's function and to functions of this header. The user's
   function, and the data to which ctx points, must exist as long as the force is used. */
typedef struct VM_TAG(vm_odd_force) vm_odd_force;
struct VM_TAG(vm_law); /* oscillators/laws.h */
struct VM_TAG(vm_odd_force) {
    vm_real k1, k3;           /* coefficients of x and x^3 of Duffing's force; 0 for a user's function */
    const struct VM_TAG(vm_law) *laws; /* two laws of time for k1 and k3; null where they are constant */
    vm_odd_function function; /* the user's function for vm_odd_force_user; null for Duffing's force */
    void *ctx;                /* the user's pointer, last argument of `function` */
    /* Functions for this kind of force, which the constructor sets. Functions of type int return a status. */
    int (*at)(const vm_odd_force *force, vm_real x, vm_real *f); /* writes F(x) for any x to *f; null if no constructor
                                                                    filled the struct */
    /* Writes the fields `size` and `place` of the orbit that contains a given state (x, v), and `m1`. For Duffing's
       force with two wells m1 comes from the energy; for all others it is 1, which means that it is not known. */
    int (*orbit_through)(const vm_odd_force *force, vm_real x, vm_real v, vmi_orbit *orbit);
    /* Computes all other fields of an orbit from its fields `size` and `place`. It may keep the m1 that
       orbit_through has written if the size agrees with it. */
    int (*complete)(vmi_orbit *orbit);
    /* Three functions for an orbit all of whose fields are set: `point` writes the point at theta, `phase` the phase of
       the state (x, v), and `at_phase` the state at the phase phi. */
    void (*point)(const vmi_orbit *orbit, vm_real theta, vmi_orbit_point *point);
    int (*phase)(const vmi_orbit *orbit, vm_real x, vm_real v, vm_real *phi);
    int (*at_phase)(const vmi_orbit *orbit, vm_real phi, vm_real *x, vm_real *v);
    /* Writes the ripple of an orbit (oscillators/orbit_ripple.h); null where numerical integration has to find the
       ripple. */
    void (*ripple)(const vmi_orbit *orbit, vmi_orbit_ripple *ripple);
};

/* Where an orbit lies: around x = 0, or around another place of rest, to the right or to the left of x = 0 */
enum { VMI_ORBIT_AROUND_0 = 0, VMI_ORBIT_RIGHT = 1, VMI_ORBIT_LEFT = -1 };

/* VMI_ORBIT_PARTS is the largest number of equal parts into which the code divides the interval 0 <= theta <= pi/2, or
   the interval 0 <= x <= A, where A is the amplitude. VMI_ORBIT_NODES is the largest number of nodes of Gauss' rule on
   all these parts together. */
enum { VMI_ORBIT_PARTS = 8, VMI_ORBIT_NODES = VMI_ORBIT_PARTS * VMI_GAUSS };

/* An orbit, which is the motion x'' + F(x) = 0 at one amplitude. theta is the angle at the top of this file. */
struct VM_TAG(vmi_orbit) {
    const vm_odd_force *force;
    vm_real size;              /* amplitude, m, if the orbit lies around x = 0; else half the difference of the largest
                                  and the smallest x^2, m^2 */
    int place;                 /* where the orbit lies: around x = 0, or to the right or left of it; one of
                                  VMI_ORBIT_... */
    vm_real span;              /* by how much the phase grows between theta = 0 and theta = pi/2: pi/2 for an orbit
                                  around 0, else pi */
    vm_real w, j;              /* rate w of the phase, 1/s, and action j, m^2/s */
    vm_real energy_slope;      /* derivative of the energy with respect to `size` */
    vm_real swing, vmax;       /* half the distance of the turning points, m, and largest velocity, m/s */
    vm_real lambda, m1;        /* for Duffing's force: rate of the argument of Jacobi's functions, and 1 - k^2, where k
                                  is their modulus */
    vm_real C2, C4;            /* for Duffing's force: means of cn^2 and cn^4 over a period, for the modulus k */
    int pieces;                /* for a user's force: number of equal pieces of 0 ... `size`; a series gives F
                                  on each piece */
    vm_real series[VMI_ORBIT_PARTS][VMI_GAUSS]; /* for a user's force: Legendre series of F on each piece */
    vm_real above[VMI_ORBIT_PARTS];             /* for a user's force: integral of F from a piece's end to `size` */
};

/* The point of an orbit at an angle theta between 0 and pi/2. theta = 0 is the turning point with the largest |x|. The
   field x is positive; points with a negative x follow by symmetry. */
struct VM_TAG(vmi_orbit_point) {
    vm_real x, v;          /* position and velocity */
    vm_real slowness;      /* dt/dtheta */
    vm_real x_size;        /* derivative of x with respect to the field `size` of the orbit, at fixed theta */
    vm_real slowness_size; /* derivative of `slowness` with respect to the field `size` of the orbit, at fixed theta */
};

/* The largest |x|, m, on an orbit all of whose fields are set */
VM_API vm_real vmi_orbit_amplitude(const vmi_orbit *orbit)
{
    if (orbit->place == VMI_ORBIT_AROUND_0) return orbit->size;
    return orbit->size / (2 * orbit->swing) + orbit->swing; /* (A + B)/2 + (A - B)/2 = A, where A is the largest and B
                                                               the smallest |x|; size = (A^2 - B^2)/2 */
}

/* -- Integrals over theta -- */

/* A function of theta, as a Legendre series on each of `parts` equal parts of 0 ... pi/2, and its integral */
typedef struct VM_TAG(vmi_orbit_sum) {
    int parts;
    vm_real series[VMI_ORBIT_PARTS][VMI_GAUSS];
    vm_real start[VMI_ORBIT_PARTS + 1]; /* integral from 0 to the start of each part; in the last element from 0 to
                                           pi/2 */
} vmi_orbit_sum;

/* The angle theta of the node i, if the interval 0 ... pi/2 has `parts` equal parts with 20 nodes each */
VM_API vm_real vmi_orbit_node(int parts, int i)
{
    const vm_real in_part = (1 + vmi_gauss_node(i % VMI_GAUSS)) / 2;
    return VM_PI / 2 * (((vm_real)(i / VMI_GAUSS) + in_part) / (vm_real)parts);
}

/* Computes the Legendre series and the integrals of two functions of theta from their values at the nodes. */
VM_API void vmi_orbit_sums(int parts, const vm_real *values_a, const vm_real *values_b, vmi_orbit_sum *a,
                           vmi_orbit_sum *b)
{
    const vm_real width = VM_PI / 2 / (vm_real)parts;
    int i;
    a->parts = parts;
    b->parts = parts;
    a->start[0] = 0;
    b->start[0] = 0;
    for (i = 0; i < parts; i++) {
        vmi_legendre_fit(values_a + i * VMI_GAUSS, values_b + i * VMI_GAUSS, a->series[i], b->series[i]);
        a->start[i + 1] = a->start[i] + width * a->series[i][0];
        b->start[i + 1] = b->start[i] + width * b->series[i][0];
    }
}

/* The integral of the function from theta = 0 to pi/2 */
VM_API vm_real vmi_orbit_whole(const vmi_orbit_sum *sum) { return sum->start[sum->parts]; }

/* Returns the index of the part of 0 ... pi/2 that contains theta. Writes to *place where theta lies in this part, from
   -1 at its start to 1 at its end. */
VM_API int vmi_orbit_part(const vmi_orbit_sum *sum, vm_real theta, vm_real *place)
{
    const vm_real parts_before = theta / (VM_PI / 2) * (vm_real)sum->parts;
    int part = (int)VM_FLOOR(parts_before);
    if (part >= sum->parts) part = sum->parts - 1;
    if (part < 0) part = 0;
    *place = 2 * (parts_before - (vm_real)part) - 1;
    return part;
}

/* The integral of the function from 0 to theta, where 0 <= theta <= pi/2 */
VM_API vm_real vmi_orbit_sum_to(const vmi_orbit_sum *sum, vm_real theta)
{
    vm_real place;
    const int part = vmi_orbit_part(sum, theta, &place);
    const vm_real half = VM_PI / 4 / (vm_real)sum->parts;
    return sum->start[part] + half * vmi_legendre_integral(sum->series[part], place);
}

/* The value of the function at theta, where 0 <= theta <= pi/2 */
VM_API vm_real vmi_orbit_value(const vmi_orbit_sum *sum, vm_real theta)
{
    vm_real place;
    const int part = vmi_orbit_part(sum, theta, &place);
    return vmi_legendre_at(sum->series[part], place);
}

/* The size of the terms that the Legendre series leave out, on the part where it is largest, divided by the mean of the
   function */
VM_API vm_real vmi_orbit_tail(const vmi_orbit_sum *sum)
{
    vm_real largest = 0;
    int i;
    for (i = 0; i < sum->parts; i++) {
        const vm_real tail = vmi_legendre_tail(sum->series[i]);
        if (!(tail <= largest)) largest = tail;
    }
    return largest / (vmi_orbit_whole(sum) / (VM_PI / 2));
}

/* The theta for which the integral of a positive function from 0 to theta is `target`. target lies between 0 and the
   integral from 0 to pi/2. Newton's method finds theta; a step that leaves the interval with the solution is replaced
   by bisection. */
VM_API vm_real vmi_orbit_theta(const vmi_orbit_sum *sum, vm_real target)
{
    const int most = 64;
    vm_real low = 0, high = VM_PI / 2, theta = VM_PI / 2 * (target / vmi_orbit_whole(sum));
    int i;
    if (!(target > 0)) return 0;
    if (!(target < vmi_orbit_whole(sum))) return VM_PI / 2;
    for (i = 0; i < most; i++) {
        const vm_real rest = vmi_orbit_sum_to(sum, theta) - target;
        vm_real next = theta - rest / vmi_orbit_value(sum, theta);
        if (rest > 0) high = theta;
        else low = theta;
        if (!(next > low && next < high)) next = low + (high - low) / 2;
        if (VM_FABS(next - theta) <= VM_EPSILON * theta) return next;
        theta = next;
    }
    return theta;
}

/* -- A phase of any size, replaced by a phase between 0 and the orbit's span -- */

/* A phase on the part 0 ... span of an orbit, where span is the field of vmi_orbit. The rest of the orbit consists of
   mirror images of this part. */
typedef struct VM_TAG(vmi_orbit_folded) {
    vm_real phi;  /* between 0 and the orbit's span */
    vm_real sign; /* -1 where the original phase lies on a mirror image, on which odd functions of the phase have the
                     opposite sign; else 1 */
    vm_real side; /* -1 where the x at this phase and the x at phase 0 have opposite signs; else 1 */
} vmi_orbit_folded;

/* Replaces a phase of any size by the corresponding phase between 0 and orbit->span. */
VM_API vmi_orbit_folded vmi_orbit_fold(const vmi_orbit *orbit, vm_real phi)
{
    vmi_orbit_folded f;
    const vm_real turn = 2 * orbit->span, turns = VM_FLOOR(phi / turn + VM_C(0.5));
    const vm_real rest = phi - turn * turns;
    f.sign = rest < 0 ? -1 : 1;
    f.phi = vmi_smaller(VM_FABS(rest), orbit->span);
    f.side = 1;
    if (orbit->place == VMI_ORBIT_AROUND_0 && turns != 2 * VM_FLOOR(turns / 2)) f.side = -1;
    return f;
}

/* Computes Legendre series of dt/dtheta and of its derivative with respect to the field `size` of the orbit. It doubles
   the number of parts of 0 <= theta <= pi/2 until vmi_orbit_tail is at most `enough`, or until there are
   VMI_ORBIT_PARTS parts. */
VM_API void vmi_orbit_times(const vmi_orbit *orbit, vm_real enough, vmi_orbit_sum *time, vmi_orbit_sum *time_size)
{
    vm_real slowness[VMI_ORBIT_NODES], by_size[VMI_ORBIT_NODES];
    int i, parts;
    for (parts = 1; parts <= VMI_ORBIT_PARTS; parts *= 2) {
        for (i = 0; i < parts * VMI_GAUSS; i++) {
            vmi_orbit_point point;
            orbit->force->point(orbit, vmi_orbit_node(parts, i), &point);
            slowness[i] = point.slowness;
            by_size[i] = point.slowness_size;
        }
        vmi_orbit_sums(parts, slowness, by_size, time, time_size);
        if (vmi_orbit_tail(time) <= enough) break;
    }
}

/* -- Forces by a user's function -- */

/* Writes F(x) for any x to *f. Returns VM_DOMAIN where the user's function fails, VM_NOT_FINITE where F is not finite,
   and else VM_OK. */
VM_API int vmi_odd_user_at(const vm_odd_force *force, vm_real x, vm_real *f)
{
    *f = 0;
    if (x == 0) return VM_OK;
    if (force->function(VM_FABS(x), f, force->ctx)) return VM_DOMAIN;
    if (!VM_IS_FINITE(*f)) return VM_NOT_FINITE;
    if (x < 0) *f = -*f;
    return VM_OK;
}

/* The force F at one point x, and its mean and its mean slope between x and an end point. The end point is the
   amplitude A or the end of a piece of 0 ... A. */
typedef struct VM_TAG(vmi_odd_forces) {
    vm_real f;     /* F(x) */
    vm_real mean;  /* mean of F between x and the end point */
    vm_real slope; /* (F(end point) - F(x))/(end point - x) */
} vmi_odd_forces;

/* Evaluates the Legendre series of F on a piece at y between -1 and 1, where y = 1 is the end of the piece. `half` is
   half the length of the piece. The sums use D_k = (1 - P_k(y))/(1 - y) with Legendre's polynomials P_k, so that near y
   = 1 the code need not subtract nearly equal numbers. */
VM_API vmi_odd_forces vmi_odd_user_sums(const vm_real *series, vm_real y, vm_real half)
{
    vm_real before = 0, now = 1, D_before = 0, D = 0;
    vmi_odd_forces r = {0, 0, 0};
    int k;
    for (k = 0; k < VMI_GAUSS; k++) {
        const vm_real next = vmi_legendre_next(k, y, now, before);
        const vm_real D_next = ((vm_real)(2 * k + 1) * (1 + y * D) - (vm_real)k * D_before) / (vm_real)(k + 1);
        r.f += series[k] * now;
        r.mean += series[k] * (D_next - D_before) / (vm_real)(2 * k + 1);
        r.slope += series[k] * D;
        before = now;
        now = next;
        D_before = D;
        D = D_next;
    }
    r.slope /= half;
    return r;
}

/* The force F at x = share * A, and the mean and the mean slope of F between x and the amplitude A. `share` is between
   0 and 1. */
VM_API vmi_odd_forces vmi_odd_user_forces(const vmi_orbit *orbit, vm_real share)
{
    const vm_real A = orbit->size, half = A / (2 * (vm_real)orbit->pieces);
    int piece = (int)(share * (vm_real)orbit->pieces);
    vm_real y, rest;
    vmi_odd_forces r;
    if (piece >= orbit->pieces) piece = orbit->pieces - 1;
    y = 2 * (share * (vm_real)orbit->pieces - (vm_real)piece) - 1;
    r = vmi_odd_user_sums(orbit->series[piece], y, half);
    if (piece == orbit->pieces - 1) return r;
    rest = A * (1 - share);
    r.mean = (r.mean * (half * (1 - y)) + orbit->above[piece]) / rest;
    r.slope = (orbit->energy_slope - r.f) / rest;
    return r;
}

/* Writes the point of the orbit at the angle theta. The variable g follows from the mean of F between x and the
   amplitude A: this mean is g (A + x)/2. */
VM_API void vmi_odd_user_point(const vmi_orbit *orbit, vm_real theta, vmi_orbit_point *point)
{
    const vm_real A = orbit->size;
    vm_real sine, cosine, g, g_size;
    vmi_odd_forces r;
    vmi_sincos(theta, &sine, &cosine);
    r = vmi_odd_user_forces(orbit, vmi_larger(cosine, 0));
    g = 2 * r.mean / (A * (1 + cosine));
    g_size = (2 * (A * r.slope + r.f) / (A * (1 + cosine)) - 2 * g) / A;
    point->x = A * cosine;
    point->v = -A * sine * VM_SQRT(g);
    point->slowness = 1 / VM_SQRT(g);
    point->x_size = cosine;
    point->slowness_size = -point->slowness * (g_size / (2 * g));
}

/* Fits Legendre series to F on `pieces` equal pieces of the interval from 0 to the amplitude. Writes to *tail the size
   of the terms that the series leave out, divided by the root mean square of F. */
VM_API int vmi_odd_user_fit(vmi_orbit *orbit, int pieces, vm_real *tail)
{
    const vm_real length = orbit->size / (vm_real)pieces;
    vm_real values[VMI_GAUSS], same[VMI_GAUSS], square = 0, largest = 0;
    int i, k;
    orbit->pieces = pieces;
    orbit->above[pieces - 1] = 0;
    orbit->energy_slope = 0;
    for (k = pieces - 1; k >= 0; k--) {
        for (i = 0; i < VMI_GAUSS; i++) {
            const vm_real x = length * ((vm_real)k + (1 + vmi_gauss_node(i)) / 2);
            const int status = vmi_odd_user_at(orbit->force, x, &values[i]);
            if (status) return status;
        }
        vmi_legendre_fit(values, values, orbit->series[k], same);
        square += vmi_legendre_square(orbit->series[k]) / (vm_real)pieces;
        largest = vmi_larger(vmi_legendre_tail(orbit->series[k]), largest);
        if (k > 0) orbit->above[k - 1] = orbit->above[k] + length * orbit->series[k][0];
    }
    for (i = 0; i < VMI_GAUSS; i++) orbit->energy_slope += orbit->series[pieces - 1][i];
    *tail = largest / VM_SQRT(square);
    return VM_OK;
}

/* Fits Legendre series to F between 0 and the orbit's amplitude, on 1, 2, 4 or 8 equal pieces. It takes the smallest of
   these numbers for which the series are accurate enough. Returns VM_NO_LAW if 8 pieces are not enough, because F is
   not smooth. */
VM_API int vmi_odd_user_series(vmi_orbit *orbit)
{
    const vm_real enough = 64 * VM_EPSILON, accepted = VM_MANT_DIG > 24 ? VM_C(1e-11) : VM_C(1e-5);
    vm_real tail = 0;
    int pieces;
    for (pieces = 1; pieces <= VMI_ORBIT_PARTS; pieces *= 2) {
        const int status = vmi_odd_user_fit(orbit, pieces, &tail);
        if (status) return status;
        if (tail <= enough) break;
    }
    if (tail <= accepted) return VM_OK;
    return VM_NO_LAW;
}

/* Sets all other fields of an orbit whose amplitude is known. Returns VM_NO_LAW where there is no vibration of this
   amplitude, and where the numerical integration is not accurate: close to a separatrix (the border between two kinds
   of vibration), and for a force that is not smooth. */
VM_API int vmi_odd_user_complete(vmi_orbit *orbit)
{
    const vm_real enough = 16 * VM_EPSILON, accepted = VM_MANT_DIG > 24 ? VM_C(1e-10) : VM_C(1e-4);
    vmi_orbit_sum time, time_size;
    vm_real squares[VMI_ORBIT_NODES], largest = 0;
    int i, status = vmi_odd_user_series(orbit);
    if (status) return status;
    vmi_orbit_times(orbit, enough, &time, &time_size);
    if (!(vmi_orbit_tail(&time) <= accepted)) return VM_NO_LAW;
    for (i = 0; i < time.parts * VMI_GAUSS; i++) {
        vmi_orbit_point point;
        vmi_odd_user_point(orbit, vmi_orbit_node(time.parts, i), &point);
        squares[i] = point.v * point.v * point.slowness;
        largest = vmi_larger(-point.v, largest);
    }
    orbit->span = VM_PI / 2;
    orbit->w = orbit->span / vmi_orbit_whole(&time);
    vmi_orbit_sums(time.parts, squares, squares, &time, &time_size);
    orbit->j = vmi_orbit_whole(&time) / orbit->span;
    orbit->swing = orbit->size;
    orbit->vmax = largest;
    return VM_IS_FINITE(orbit->w) && orbit->w > 0 && orbit->energy_slope > 0 ? VM_OK : VM_NO_LAW;
}

/* A state (x, v) on an orbit whose amplitude is to be found */
typedef struct VM_TAG(vmi_odd_state) {
    const vm_odd_force *force;
    vm_real x, v; /* position >= 0 and velocity */
    int status;   /* status of the user's function */
} vmi_odd_state;

/* The potential energy at x + more, minus the potential energy at x, minus the kinetic energy v^2/2 of the state (x,
   v). The result is 0 where x + more is the amplitude. */
VM_API vm_real vmi_odd_user_missing(vm_real more, void *state)
{
    vmi_odd_state *s = (vmi_odd_state *)state;
    const vm_real length = more / (vm_real)VMI_ORBIT_PARTS;
    vm_real sum = 0, f;
    int i, k;
    for (k = 0; k < VMI_ORBIT_PARTS; k++) {
        for (i = 0; i < VMI_GAUSS; i++) {
            const vm_real x = s->x + length * ((vm_real)k + (1 + vmi_gauss_node(i)) / 2);
            const int status = vmi_odd_user_at(s->force, x, &f);
            if (status) s->status = status;
            sum += vmi_gauss_weight(i) / 2 * f;
        }
    }
    return sum * length - s->v * s->v / 2;
}

/* Finds the orbit through the state (x, v). `low` is the largest known value of (amplitude - |x|) that is too small. A
   step beyond `low` is halved if it leads to a place where the function fails, or where F is not positive and the
   energy is not yet reached. Otherwise it doubles `low`, until the true value lies between two trial values. Returns
   VM_NO_LAW where no amplitude belongs to the state. */
VM_API int vmi_odd_user_through(const vm_odd_force *force, vm_real x, vm_real v, vmi_orbit *orbit)
{
    const int most = 200;
    vmi_odd_state s;
    vm_real low = 0, step, missing = 0, before = -v * v / 2;
    int i, bounded = 0;
    s.force = force;
    s.x = VM_FABS(x);
    s.v = v;
    s.status = VM_OK;
    orbit->force = force;
    orbit->place = VMI_ORBIT_AROUND_0;
    orbit->m1 = 1; /* only Duffing's force has a modulus */
    orbit->size = s.x;
    if (v == 0) return VM_OK;
    step = s.x > 0 ? s.x : VM_FABS(v);
    for (i = 0; i < most && !(bounded && step < VM_EPSILON * (s.x + low)); i++) {
        vm_real f = 0;
        int is_too_far;
        s.status = VM_OK;
        missing = vmi_odd_user_missing(low + step, &s);
        if (!s.status) s.status = vmi_odd_user_at(force, s.x + (low + step), &f);
        if (missing > 0) is_too_far = low == 0;
        else is_too_far = f <= 0;
        if (s.status || is_too_far) {
            if (s.status || !(missing > 0)) bounded = 1;
            step /= 2;
            continue;
        }
        if (missing > 0) break;
        before = missing;
        low += step;
        if (!bounded) step = low;
    }
    if (s.status) return s.status;
    if (!(missing > 0)) return VM_NO_LAW;
    orbit->size = s.x + vmi_find_zero(vmi_odd_user_missing, &s, low, low + step, before, missing);
    return s.status;
}

/* Writes the phase of the state (x, v) on a complete orbit of amplitude A. The angle theta follows from x = A
   cos(theta) and v = -A sin(theta)/(dt/dtheta), and the phase from theta. */
VM_API int vmi_odd_user_phase(const vmi_orbit *orbit, vm_real x, vm_real v, vm_real *phi)
{
    const vm_real above = vmi_larger(orbit->size - VM_FABS(x), 0) * (orbit->size + VM_FABS(x));
    vmi_orbit_sum time, time_size;
    vmi_orbit_point point;
    vm_real theta;
    vmi_orbit_times(orbit, 16 * VM_EPSILON, &time, &time_size);
    vmi_odd_user_point(orbit, vmi_atan2(VM_SQRT(above), VM_FABS(x)), &point);
    theta = vmi_atan2(VM_FABS(v) * point.slowness, VM_FABS(x));
    *phi = orbit->w * vmi_orbit_sum_to(&time, theta);
    if (x < 0) *phi = VM_PI - *phi;
    if (v > 0) *phi = -*phi;
    return VM_OK;
}

/* Writes position x and velocity v of the orbit at the phase phi. */
VM_API int vmi_odd_user_at_phase(const vmi_orbit *orbit, vm_real phi, vm_real *x, vm_real *v)
{
    const vmi_orbit_folded f = vmi_orbit_fold(orbit, phi);
    vmi_orbit_sum time, time_size;
    vmi_orbit_point point;
    vmi_orbit_times(orbit, 16 * VM_EPSILON, &time, &time_size);
    vmi_odd_user_point(orbit, vmi_orbit_theta(&time, f.phi / orbit->w), &point);
    *x = f.side * point.x;
    *v = f.side * f.sign * point.v;
    return VM_OK;
}

/* Odd elastic force F(x) that a user's function computes. The function is called for x >= 0 only, also for some x above
   the amplitude A, where it may fail; its last argument is ctx. F must be positive for 0 < x <= A; it is enough that
   the integral of F from every such x to A is positive. Between 0 and A the force must be so smooth that polynomials of
   degree 19 represent it on at most 8 equal pieces. Otherwise vm_odd_exact_from and the averaged solutions return
   VM_NO_LAW. If `function` is null, all functions that use the force and return a status return VM_BAD_ARGUMENT. */
VM_API vm_odd_force vm_odd_force_user(vm_odd_function function, void *ctx)
{
    vm_odd_force force;
    force.k1 = 0;
    force.k3 = 0;
    force.laws = NULL;
    force.function = function;
    force.ctx = ctx;
    force.at = NULL;
    if (function) force.at = vmi_odd_user_at; /* if `at` stays null, the struct describes no force */
    force.orbit_through = vmi_odd_user_through;
    force.complete = vmi_odd_user_complete;
    force.point = vmi_odd_user_point;
    force.phase = vmi_odd_user_phase;
    force.at_phase = vmi_odd_user_at_phase;
    force.ripple = NULL;
    return force;
}

/* -- Motion with constant mass -- */

/* Computes all fields of the orbit through the state (x, v). If the body rests in equilibrium, the field `size` becomes
   0, and the other fields have no meaning. */
VM_API int vmi_orbit_of_state(const vm_odd_force *force, vm_real x, vm_real v, vmi_orbit *orbit)
{
    int status;
    if (!VM_IS_FINITE(x) || !VM_IS_FINITE(v)) return VM_NOT_FINITE;
    status = force->orbit_through(force, x, v, orbit);
    if (status || orbit->size == 0) return status;
    if (!VM_IS_FINITE(orbit->size)) return VM_NOT_FINITE;
    return force->complete(orbit);
}

/* Exact period, s, of x'' + F(x) = 0 from rest at x0 (m, either sign), for an odd force F per unit mass. Returns NaN
   for a null pointer, for a force that no constructor made, for x0 = 0 or infinite x0, and where there is no vibration.
   The relative error is at most 1e-13 (float 1e-5), for a Duffing force where the terms named at vm_duffing_period do
   not cancel. */
VM_API vm_real vm_odd_period(const vm_odd_force *force, vm_real x0)
{
    vmi_orbit orbit;
    if (!force || !force->at || vmi_orbit_of_state(force, x0, 0, &orbit) || orbit.size == 0) return VM_NAN;
    return 2 * VM_PI / orbit.w;
}

/* Action, m^2/s, of x'' + F(x) = 0 from rest at x0 (m, either sign), for an odd force F per unit mass. The action is
   the integral of v dx over a period, divided by 2 pi. It stays nearly constant while the force changes slowly. Returns
   NaN where vm_odd_period does, but 0 for x0 = 0 and for a body at rest in a well. The accuracy is that of
   vm_odd_period. */
VM_API vm_real vm_odd_action(const vm_odd_force *force, vm_real x0)
{
    vmi_orbit orbit;
    if (!force || !force->at || vmi_orbit_of_state(force, x0, 0, &orbit)) return VM_NAN;
    if (orbit.size == 0) return 0;
    return orbit.j;
}

/* Exact motion x(t), v(t) of x'' + F(x) = 0 from the position x0 (m) and the velocity v0 (m/s) at t = 0, for an odd
   force F per unit mass. The error of x, divided by the amplitude, and the error of v, divided by the largest velocity,
   are at most 1e-12 (float 1e-4) times 1 + t/period. Returns VM_BAD_ARGUMENT for null pointers and for a force that no
   constructor made, VM_NOT_FINITE for numbers or a force that are infinite or NaN, VM_DOMAIN where the user's function
   fails, and VM_NO_LAW where there is no vibration, on a separatrix (the border between two kinds of vibration), for
   a user's function also close to a separatrix, and for a force that is not smooth. Close to the separatrix of a
   Duffing force the errors are those of vm_duffing_exact_from. An error leaves *x and *v untouched. */
VM_API int vm_odd_exact_from(const vm_odd_force *force, vm_real t, vm_real x0, vm_real v0, vm_real *x, vm_real *v)
{
    vmi_orbit orbit;
    vm_real phi, now[2];
    int status;
    if (!force || !force->at || !x || !v) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(force->k1) || !VM_IS_FINITE(force->k3)) return VM_NOT_FINITE;
    status = vmi_orbit_of_state(force, x0, v0, &orbit);
    if (status) return status;
    now[0] = x0;
    now[1] = v0;
    if (orbit.size > 0) {
        status = force->phase(&orbit, x0, v0, &phi);
        if (!status) status = force->at_phase(&orbit, phi + orbit.w * t, &now[0], &now[1]);
        if (status) return status;
    }
    if (!VM_IS_FINITE(now[0]) || !VM_IS_FINITE(now[1])) return VM_NOT_FINITE;
    *x = now[0];
    *v = now[1];
    return VM_OK;
}

#endif
