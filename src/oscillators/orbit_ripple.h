/* oscillators/orbit_ripple.h - how a slow change disturbs the motion on an orbit within a period

   An orbit is the motion under an odd force F(x) at one amplitude (oscillators/odd_force.h). Let m be the mass, k the
   factor of the force, b the damping and r the share of the reactive force. If ds = sqrt(k/m) dt defines a new time s,
   then all slow changes together act as one damping h:
       x'' + F(x) = -2 h x',   2 h = d ln(mu sqrt(k/m))/ds,   mu' = (r m' + b) mu/m
   The last equation defines the function mu(t). Then J = j mu sqrt(k/m) stays constant on average, where j is the
   action of the orbit. J and the phase phi are canonical variables, that is they obey Hamilton's equations. The
   Hamiltonian is (H + 2 h a) mu sqrt(k/m), where H is the Hamiltonian for constant mass, and a is the function
       a(phi) = (integral of v dx from phase 0) - j phi
   of period pi (2 pi in a well, which is a place of rest beside x = 0) and mean 0. Let B be the integral of a over the
   phase, with mean 0. To second order in h the mean action and the mean phase are
       j_mean = j + 2h a/w - (B/w)(2h' + 4h^2)/w + 4h^2 j (B/w)_j/w - 2h^2 (a^2 - M) w_j/w^3 + 2h^2 (M/w^2)_j
       phi_mean = phi - 2h (B/w)_j,   phi_mean' = w(j_mean) - 2h^2 (M/w)_jj
   where w is the rate of the phase, M the mean of a^2, _j the derivative with respect to j at fixed phase, and h' =
   dh/ds.
       vmi_orbit_ripple ripple;
       vmi_orbit_ripple_values now;
       vmi_orbit_ripple_init(&ripple, &orbit); // orbit is a complete vmi_orbit
       vmi_orbit_ripple_at(&ripple, &orbit, 1, &now); // at the phase 1
   Source: the averaging of canonical equations by Lie series, to second order; docs/duffing.md.
   Tests: tests/test_odd_force.c. */
#ifndef VARMASS_OSCILLATORS_ORBIT_RIPPLE_H
#define VARMASS_OSCILLATORS_ORBIT_RIPPLE_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "odd_force.h"

/* The largest number of terms of a Fourier series in vmi_orbit_ripple */
enum { VMI_RIPPLE_HARMONICS = 96 };

/* The functions a and B of the top of this file on one orbit. These functions give the ripple, the swing of action and
   phase within a period. A name with _size is the derivative with respect to the field `size` of the orbit, at fixed
   phase. If the Fourier coefficients of the function a have closed forms, a is a sum of terms in sin(n zeta), with zeta
   = 2 phi for an orbit around 0 and zeta = phi in a well. Otherwise a is an integral over theta. */
struct VM_TAG(vmi_orbit_ripple) {
    vm_real M, M_size;     /* mean of a^2, and the derivative of this mean with respect to size */
    vm_real X, X_size;     /* mean of x^2, and the derivative of this mean with respect to size; for Duffing's force
                              only, else 0 */
    vm_real w_size, j_size; /* derivatives of the phase rate w and of the action j with respect to size */
    vm_real largest_a;     /* largest |a|/j, or for a Fourier series a bound of it */
    vm_real largest_B;     /* largest w |(B/w)_j|, or for a Fourier series a bound of it */
    int harmonics;         /* number of terms of the Fourier series; 0 where there is no such series: then the fields
                              from `time` on are used */
    vm_real a[VMI_RIPPLE_HARMONICS + 1], a_size[VMI_RIPPLE_HARMONICS + 1]; /* n >= 1: factor of sin(n zeta) in a, and
                                                                              its derivative with respect to size */
    vm_real b[VMI_RIPPLE_HARMONICS + 1];                                   /* factor of cos(n zeta) in (B/w)_j */
    vmi_orbit_sum time, time_size; /* time since theta = 0, and its derivative with respect to size at fixed theta */
    vmi_orbit_sum squares;         /* integral of v^2 over time */
    vmi_orbit_sum B, B_size;       /* integrals over the phase: of the function a, and of its derivative with respect to
                                      size */
    vm_real B_mean, B_size_mean;   /* the means of the integrals B and B_size */
};

/* The functions of the ripple at one phase */
typedef struct VM_TAG(vmi_orbit_ripple_values) {
    vm_real a, B; /* the functions a and B of the top of this file */
    vm_real B_j;  /* (B/w)_j */
} vmi_orbit_ripple_values;

/* Values at the nodes, the values of theta from which series and integrals are computed */
typedef struct VM_TAG(vmi_orbit_nodes) {
    int n;
    vmi_orbit_point point[VMI_ORBIT_NODES];
    vm_real a[VMI_ORBIT_NODES], a_size[VMI_ORBIT_NODES]; /* the function a, and its derivative with respect to size at
                                                            fixed phase */
    vm_real phase_rate[VMI_ORBIT_NODES];                 /* dphi/dtheta */
} vmi_orbit_nodes;

/* Computes the function a and its derivative with respect to the orbit's size at the nodes. At fixed phase the
   derivative of a is v times the derivative of x. */
VM_API void vmi_orbit_ripple_nodes(const vmi_orbit *orbit, vmi_orbit_ripple *r, vmi_orbit_nodes *nodes)
{
    vm_real squares[VMI_ORBIT_NODES];
    const int parts = r->time.parts;
    int i;
    nodes->n = parts * VMI_GAUSS;
    squares[0] = 0; /* compilers would warn of an array without values, although there is at least one node */
    for (i = 0; i < nodes->n; i++) {
        vmi_orbit_point *p = nodes->point + i;
        orbit->force->point(orbit, vmi_orbit_node(parts, i), p);
        squares[i] = p->v * p->v * p->slowness;
    }
    vmi_orbit_sums(parts, squares, squares, &r->squares, &r->B);
    for (i = 0; i < nodes->n; i++) {
        const vmi_orbit_point *p = nodes->point + i;
        const vm_real theta = vmi_orbit_node(parts, i), time = vmi_orbit_sum_to(&r->time, theta);
        const vm_real phi_size = r->w_size * time + orbit->w * vmi_orbit_sum_to(&r->time_size, theta);
        nodes->a[i] = vmi_orbit_sum_to(&r->squares, theta) - orbit->j * (orbit->w * time);
        nodes->a_size[i] = p->v * (p->x_size - p->v * phi_size / orbit->w);
        nodes->phase_rate[i] = orbit->w * p->slowness;
    }
}

/* The mean over the phase of a function whose values at the nodes are in `values` */
VM_API vm_real vmi_orbit_mean(const vmi_orbit *orbit, const vmi_orbit_nodes *nodes, const vm_real *values)
{
    vm_real sum = 0;
    int i;
    for (i = 0; i < nodes->n; i++) sum += vmi_gauss_weight(i % VMI_GAUSS) * values[i] * nodes->phase_rate[i];
    return sum * (VM_PI / 4 / ((vm_real)(nodes->n / VMI_GAUSS) * orbit->span));
}

/* The derivative of B/w with respect to the action j, where w is the rate of the phase. B_size is the derivative of B
   with respect to the orbit's size. */
VM_API vm_real vmi_orbit_B_j(const vmi_orbit *orbit, const vmi_orbit_ripple *r, vm_real B, vm_real B_size)
{
    return (B_size - B * (r->w_size / orbit->w)) / (orbit->w * r->j_size);
}

/* Computes the function B, the means and the largest values from the values at the nodes. */
VM_API void vmi_orbit_ripple_means(const vmi_orbit *orbit, const vmi_orbit_nodes *nodes, vmi_orbit_ripple *r)
{
    const int parts = r->time.parts;
    vm_real first[VMI_ORBIT_NODES], second[VMI_ORBIT_NODES];
    int i;
    first[0] = 0; /* as in vmi_orbit_ripple_nodes: there is at least one node */
    second[0] = 0;
    for (i = 0; i < nodes->n; i++) {
        first[i] = nodes->a[i] * nodes->phase_rate[i];
        second[i] = nodes->a_size[i] * nodes->phase_rate[i];
    }
    vmi_orbit_sums(parts, first, second, &r->B, &r->B_size);
    for (i = 0; i < nodes->n; i++) {
        first[i] = nodes->a[i] * nodes->a[i];
        second[i] = 2 * nodes->a[i] * nodes->a_size[i];
    }
    r->M = vmi_orbit_mean(orbit, nodes, first);
    r->M_size = vmi_orbit_mean(orbit, nodes, second);
    for (i = 0; i < nodes->n; i++) {
        const vm_real theta = vmi_orbit_node(parts, i);
        first[i] = vmi_orbit_sum_to(&r->B, theta);
        second[i] = vmi_orbit_sum_to(&r->B_size, theta);
    }
    r->B_mean = vmi_orbit_mean(orbit, nodes, first);
    r->B_size_mean = vmi_orbit_mean(orbit, nodes, second);
    r->largest_a = 0;
    r->largest_B = 0;
    for (i = 0; i < nodes->n; i++) {
        const vm_real B_j = vmi_orbit_B_j(orbit, r, first[i] - r->B_mean, second[i] - r->B_size_mean);
        r->largest_a = vmi_larger(VM_FABS(nodes->a[i]) / orbit->j, r->largest_a);
        r->largest_B = vmi_larger(VM_FABS(B_j) * orbit->w, r->largest_B);
    }
}

/* Computes the means, the largest values and the coefficients b of a ripple from its Fourier series. The fields
   harmonics, a, a_size, w_size and j_size must be set before. */
VM_API void vmi_orbit_ripple_of_harmonics(const vmi_orbit *orbit, vmi_orbit_ripple *r)
{
    const vm_real turn = VM_PI / orbit->span; /* zeta/phi */
    int n;
    r->M = 0;
    r->M_size = 0;
    r->largest_a = 0;
    r->largest_B = 0;
    for (n = 1; n <= r->harmonics; n++) {
        const vm_real integral = -1 / ((vm_real)n * turn);
        r->b[n] = vmi_orbit_B_j(orbit, r, integral * r->a[n], integral * r->a_size[n]);
        r->M += r->a[n] * r->a[n] / 2;
        r->M_size += r->a[n] * r->a_size[n];
        r->largest_a += VM_FABS(r->a[n]) / orbit->j;
        r->largest_B += VM_FABS(r->b[n]) * orbit->w;
    }
}

/* Computes the ripple of an orbit whose fields are all set. The terms of the ripple are small, so that 8 digits are
   enough for them. */
VM_API void vmi_orbit_ripple_init(vmi_orbit_ripple *r, const vmi_orbit *orbit)
{
    const vm_real enough = VM_MANT_DIG > 24 ? VM_C(1e-8) : VM_C(1e-5);
    vmi_orbit_nodes nodes;
    if (orbit->force->ripple) {
        orbit->force->ripple(orbit, r);
        return;
    }
    r->harmonics = 0;
    r->X = 0;
    r->X_size = 0;
    vmi_orbit_times(orbit, enough, &r->time, &r->time_size);
    r->w_size = -orbit->w * (vmi_orbit_whole(&r->time_size) / vmi_orbit_whole(&r->time));
    r->j_size = orbit->energy_slope / orbit->w;
    vmi_orbit_ripple_nodes(orbit, r, &nodes);
    vmi_orbit_ripple_means(orbit, &nodes, r);
}

/* Writes the ripple at the phase phi by the Fourier series, which Clenshaw's recurrence adds up from the last term to
   the first. */
VM_API void vmi_orbit_ripple_by_harmonics(const vmi_orbit_ripple *r, const vmi_orbit *orbit, vm_real phi,
                                          vmi_orbit_ripple_values *now)
{
    const vm_real turn = VM_PI / orbit->span;
    vm_real sine, cosine, a = 0, a_next = 0, B = 0, B_next = 0, b = 0, b_next = 0;
    int n;
    vmi_sincos(turn * phi, &sine, &cosine);
    for (n = r->harmonics; n >= 1; n--) {
        const vm_real a_now = r->a[n] + 2 * cosine * a - a_next, b_now = r->b[n] + 2 * cosine * b - b_next;
        const vm_real B_now = -r->a[n] / ((vm_real)n * turn) + 2 * cosine * B - B_next;
        a_next = a;
        a = a_now;
        b_next = b;
        b = b_now;
        B_next = B;
        B = B_now;
    }
    now->a = sine * a;
    now->B = cosine * B - B_next;
    now->B_j = cosine * b - b_next;
}

/* Writes the ripple at a phase phi of any size. */
VM_API void vmi_orbit_ripple_at(const vmi_orbit_ripple *r, const vmi_orbit *orbit, vm_real phi,
                                vmi_orbit_ripple_values *now)
{
    vmi_orbit_folded f;
    vm_real time, theta, B_size;
    if (r->harmonics > 0) {
        vmi_orbit_ripple_by_harmonics(r, orbit, phi, now);
        return;
    }
    f = vmi_orbit_fold(orbit, phi);
    time = f.phi / orbit->w;
    theta = vmi_orbit_theta(&r->time, time);
    B_size = vmi_orbit_sum_to(&r->B_size, theta) - r->B_size_mean;
    now->a = f.sign * (vmi_orbit_sum_to(&r->squares, theta) - orbit->j * f.phi);
    now->B = vmi_orbit_sum_to(&r->B, theta) - r->B_mean;
    now->B_j = vmi_orbit_B_j(orbit, r, now->B, B_size);
}

/* The relative change of the phase rate w, divided by the relative change of the action j that causes it */
VM_API vm_real vmi_orbit_gamma(const vmi_orbit_ripple *r, const vmi_orbit *orbit)
{
    return orbit->j * r->w_size / (r->j_size * orbit->w);
}

/* (M/w)_j, the derivative of M/w with respect to the action. M is the mean of a^2, w the rate of the phase. The mean
   rate of the phase depends on this derivative. */
VM_API vm_real vmi_orbit_M_j(const vmi_orbit_ripple *r, const vmi_orbit *orbit)
{
    return (r->M_size - r->M * (r->w_size / orbit->w)) / (orbit->w * r->j_size);
}

/* The mean action that belongs to the action j of an orbit at the phase of `now`. h is the damping that the top of this
   file defines, and h_rate = dh/ds. */
VM_API vm_real vmi_orbit_mean_action(const vmi_orbit_ripple *r, const vmi_orbit *orbit,
                                     const vmi_orbit_ripple_values *now, vm_real h, vm_real h_rate)
{
    const vm_real w = orbit->w, w_j = r->w_size / r->j_size, first = 2 * h * now->a / w;
    const vm_real M2_j = (vmi_orbit_M_j(r, orbit) - r->M * w_j / (w * w)) / w; /* (M/w^2)_j */
    vm_real second = -(2 * h_rate + 4 * h * h) * now->B / (w * w) + 4 * h * h * orbit->j * now->B_j / w;
    second += 2 * h * h * (M2_j - (now->a * now->a - r->M) * w_j / (w * w * w));
    return orbit->j + first + second;
}

/* The part of the difference (mean action) - (action) that a weak linear spring of stiffness 1 causes. The spring acts
   in addition to the force F; x is the position on the orbit. */
VM_API vm_real vmi_orbit_spring_action(const vmi_orbit_ripple *r, const vmi_orbit *orbit, vm_real x)
{
    return (x * x - r->X) / (2 * orbit->w);
}

#endif
