/* mechanics/torque_free_axes.h - principal axes of a rotating body in two words, numbered as in torque_free.h
   This chapter is the first step of the preparation in torque_free.h. It finds the principal moments of inertia J_a >=
   J_b >= J_c, the principal axes a, b, c and the components w_a, w_b, w_c of the angular velocity omega along these
   axes. Each of these numbers is stored in two words, as the sum of two vm_reals, because the rates that follow from
   these numbers are multiplied by long times. Then this chapter numbers the axes 1, 2, 3. Axis 2 is b, the axis of the
   middle moment. Axis 3 is the axis around which the vector omega moves in the body. Axis 3 is a or c, depending on
   the sign of
     2T J_b - L^2 = J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2,
   where T is the kinetic energy and L the size of the angular momentum. If this number is positive or 0, axis 3 is c,
   the axis of the smallest moment; else axis 3 is a. If the number is 0, the direction of omega tends to that of axis
   2 as time grows. The set of these motions is called the separatrix. All functions of this chapter are internal:

       vmi_torque_free_body b; // whole is a vm_body
       vmi_torque_free_axes axes;
       vmi_torque_free_principal(&whole.inertia, &b); // sets b.moment and b.axis; set b.omega, too
       axes = vmi_torque_free_order(&b);

   Tests: tests/test_torque_free.c. */
#ifndef VARMASS_MECHANICS_TORQUE_FREE_AXES_H
#define VARMASS_MECHANICS_TORQUE_FREE_AXES_H

#include <string.h>

#include "../base/power_of_two.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "inertia.h"
#include "vectors.h"

/* ---- vectors in two words ---- */

/* A vector whose three components are stored in two words, that is, each as the sum of two vm_reals */
typedef struct VM_TAG(vmi_vec3_two) {
    vm_two x[3];
} vmi_vec3_two;

/* The vector a/power in two words, which is exact if power is a power of two */
VM_API vmi_vec3_two vmi_vec3_two_over(vm_vec3 a, vm_real power)
{
    vmi_vec3_two v;
    v.x[0] = vmi_two(a.x / power, 0);
    v.x[1] = vmi_two(a.y / power, 0);
    v.x[2] = vmi_two(a.z / power, 0);
    return v;
}

VM_API vm_vec3 vmi_vec3_two_high_words(const vmi_vec3_two *a) { return vmi_vec3(a->x[0].hi, a->x[1].hi, a->x[2].hi); }

VM_API vm_two vmi_vec3_two_dot(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    return vmi_two_plus(vmi_two_times(a->x[0], b->x[0]),
                        vmi_two_plus(vmi_two_times(a->x[1], b->x[1]), vmi_two_times(a->x[2], b->x[2])));
}

VM_API vmi_vec3_two vmi_vec3_two_cross(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    vmi_vec3_two c;
    int k;
    for (k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.x[k] = vmi_two_minus(vmi_two_times(a->x[i], b->x[j]), vmi_two_times(a->x[j], b->x[i]));
    }
    return c;
}

/* Returns the vector that the rotation q turns into a. It is a + 2 (v x (v x a) - w v x a)/|q|^2, where w is the real
   part and v the vector part of q. q may have any length except 0. */
VM_API vmi_vec3_two vmi_vec3_two_turned_back(vm_quat q, const vmi_vec3_two *a)
{
    const vm_vec3 xyz = vmi_quat_vector(q);
    const vm_real longest = vmi_norm_max(xyz), size = VM_FABS(q.w);
    const vm_real power = vmi_power_below(longest > size ? longest : size);
    const vmi_vec3_two v = vmi_vec3_two_over(xyz, power);
    const vmi_vec3_two va = vmi_vec3_two_cross(&v, a), vva = vmi_vec3_two_cross(&v, &va);
    const vm_two w = vmi_two(q.w / power, 0);
    const vm_two square = vmi_two_plus(vmi_two_times(w, w), vmi_vec3_two_dot(&v, &v));
    const vm_two factor = vmi_two_over(vmi_two(2, 0), square);
    vmi_vec3_two result;
    int k;
    for (k = 0; k < 3; k++) {
        const vm_two change = vmi_two_minus(vva.x[k], vmi_two_times(w, va.x[k]));
        result.x[k] = vmi_two_plus(a->x[k], vmi_two_times(factor, change));
    }
    return result;
}

/* ---- principal moments and axes ---- */

/* The rotation of a body in its principal axes. `moment` contains the principal moments, divided by a power of two.
   `axis` contains the unit vectors of the principal axes, along body axes. `omega` contains the components of omega
   along the principal axes, divided by another power of two. */
typedef struct VM_TAG(vmi_torque_free_body) {
    vm_two moment[3];
    vmi_vec3_two axis[3], omega;
} vmi_torque_free_body;

/* Turns the plane vector (*x, *y) by the angle whose cosine is c and whose sine is s */
VM_API void vmi_two_turn(vm_two c, vm_two s, vm_two *x, vm_two *y)
{
    const vm_two x0 = *x, y0 = *y;
    *x = vmi_two_minus(vmi_two_times(c, x0), vmi_two_times(s, y0));
    *y = vmi_two_plus(vmi_two_times(s, x0), vmi_two_times(c, y0));
}

/* Makes one rotation of Jacobi's eigenvalue method in two words: it turns the axes number p and q in their plane so
   that the entry a[p][q] of the tensor becomes 0. The tensor a must be scaled so that its entries are about 1. An entry
   below eps^3 is set to 0 without a rotation. */
VM_API void vmi_torque_free_jacobi_rotation(vm_two a[3][3], vmi_vec3_two *axis, int p, int q)
{
    const vm_two one = vmi_two(1, 0), entry = a[p][q];
    const int other = 3 - p - q;
    vm_two theta, root, t, c, s, moved;
    int k;
    a[p][q] = a[q][p] = vmi_two(0, 0);
    if (VM_FABS(entry.hi) < VM_EPSILON * VM_EPSILON * VM_EPSILON) return;
    theta = vmi_two_over(vmi_two_minus(a[q][q], a[p][p]), vmi_two_shifted(entry, 2));
    root = vmi_two_root(vmi_two_plus(vmi_two_times(theta, theta), one));
    if (theta.hi < 0) root = vmi_minus(root);
    t = vmi_two_over(one, vmi_two_plus(theta, root));
    c = vmi_two_over(one, vmi_two_root(vmi_two_plus(vmi_two_times(t, t), one)));
    s = vmi_two_times(t, c);
    moved = vmi_two_times(t, entry);
    a[p][p] = vmi_two_minus(a[p][p], moved);
    a[q][q] = vmi_two_plus(a[q][q], moved);
    vmi_two_turn(c, s, &a[other][p], &a[other][q]);
    a[p][other] = a[other][p];
    a[q][other] = a[other][q];
    for (k = 0; k < 3; k++) vmi_two_turn(c, s, &axis[p].x[k], &axis[q].x[k]);
}

/* Sets b->axis to the principal axes, and b->moment to the principal moments divided by vmi_power_below(trace), where
   `trace` is the trace of the tensor *i. Sets b->omega to 0. If the tensor has no products of inertia, the moments are
   exactly the scaled diagonal entries of the tensor, and the axes are exactly the body axes. */
VM_API void vmi_torque_free_principal(const vm_inertia *i, vmi_torque_free_body *b)
{
    const int most_sweeps = 12; /* more than enough, since the rotations converge quadratically */
    const vm_real power = vmi_power_below(vmi_inertia_trace(i));
    vm_two a[3][3];
    int sweep, p, q, k;
    memset(b, 0, sizeof *b);
    memset(a, 0, sizeof a);
    a[0][0].hi = i->xx / power;
    a[1][1].hi = i->yy / power;
    a[2][2].hi = i->zz / power;
    a[0][1].hi = a[1][0].hi = i->xy / power;
    a[0][2].hi = a[2][0].hi = i->xz / power;
    a[1][2].hi = a[2][1].hi = i->yz / power;
    for (k = 0; k < 3; k++) b->axis[k].x[k].hi = 1;
    for (sweep = 0; sweep < most_sweeps; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q].hi != 0) vmi_torque_free_jacobi_rotation(a, b->axis, p, q);
    for (k = 0; k < 3; k++) b->moment[k] = a[k][k];
}

/* Sets a principal moment to 0 if it is not larger than the rounding errors of the tensor *i. The body is then a rod or
   a point. The function therefore makes the other two moments equal. */
VM_API void vmi_torque_free_clamp_moments(const vm_inertia *i, vmi_torque_free_body *b)
{
    const vmi_mat3 same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const vm_inertia sizes = vmi_inertia_sizes(i, &same);
    const vm_real power = vmi_power_below(vmi_inertia_trace(i));
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 axis = vmi_vec3_two_high_words(&b->axis[k]);
        if (!vmi_moment_is_lost(b->moment[k].hi * power, axis, &sizes)) continue;
        b->moment[k] = vmi_two(0, 0);
        b->moment[(k + 1) % 3] = b->moment[(k + 2) % 3];
    }
}

/* ---- the order of the axes ---- */

/* Returns 1 if two moments differ by no more than the errors of their computation in two words, else 0. If a tensor
   has no products of inertia, its moments have no such errors: two moments are then exactly equal, or they differ by
   more than these errors. */
VM_API int vmi_torque_free_are_equal(vm_two a, vm_two b)
{
    const vm_real few = 64 * VM_EPSILON * VM_EPSILON;
    return VM_FABS(vmi_two_minus(a, b).hi) <= few * (a.hi + b.hi);
}

/* The moments of inertia and omega of a body in its axes 1, 2, 3, which are right-handed */
typedef struct VM_TAG(vmi_torque_free_axes) {
    vm_two I1, I2, I3;    /* the principal moments */
    vm_two d12, d23, d13; /* the differences |I1 - I2|, |I2 - I3|, |I1 - I3| of the moments */
    vm_two w1, w2, w3;    /* the components of omega along the axes */
    vm_two S;             /* |2T I2 - L^2| with the kinetic energy T and the angular momentum L; 0 on the separatrix */
    vm_real sigma;        /* the sign of I1 - I3 */
    vm_real s;            /* the sign of w3 */
    int symmetric;        /* 1 if I1 = I2, else 0 */
    vmi_mat3 matrix;      /* columns: the axes 1, 2, 3 in body axes */
} vmi_torque_free_axes;

/* Returns the product J d w^2 of a moment J, a difference d of two moments and the square of a component w of omega.
   The product has three words, so that the difference of two such products is accurate even if they nearly cancel. */
VM_API vmi_three vmi_torque_free_excess(vm_two J, vm_two d, vm_two w)
{
    const vmi_three J3 = vmi_three_words(J.hi, J.lo, 0), d3 = vmi_three_words(d.hi, d.lo, 0);
    const vmi_three w3 = vmi_three_words(w.hi, w.lo, 0);
    return vmi_three_times(vmi_three_times(J3, d3), vmi_three_times(w3, w3));
}

/* Returns J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2 = 2T J_b - L^2. The sign of this number decides which axis is
   axis 3. The axes a, b, c have the indices order[0], order[1], order[2]; a has the largest moment and c the
   smallest. */
VM_API vmi_three vmi_torque_free_separation(const vm_two *J, const vm_two *w, const int *order)
{
    const int a = order[0], b = order[1], c = order[2];
    const vmi_three of_smallest = vmi_torque_free_excess(J[c], vmi_two_minus(J[b], J[c]), w[c]);
    return vmi_three_plus(of_smallest, vmi_torque_free_excess(J[a], vmi_two_minus(J[b], J[a]), w[a]));
}

/* Sets order[] to the indices 0, 1, 2 of the axes, sorted so that the largest moment comes first. Returns 1 if order[]
   is an even permutation of 0, 1, 2, else 0. */
VM_API int vmi_torque_free_sort(const vm_two *J, int *order)
{
    int k, even = 1;
    for (k = 0; k < 3; k++) order[k] = k;
    for (k = 0; k < 3; k++) { /* compare the first two, the last two, the first two */
        const int i = k == 1, first = order[i];
        if (!(vmi_two_minus(J[order[i + 1]], J[first]).hi > 0)) continue;
        order[i] = order[i + 1];
        order[i + 1] = first;
        even = !even;
    }
    return even;
}

/* Returns 1 if axis 3 is order[2], the axis of the smallest moment, and 0 if axis 3 is order[0], the axis of the
   largest moment. If two moments are equal, axis 3 is the axis of the third moment. `separation` is the result of
   vmi_torque_free_separation. */
VM_API int vmi_torque_free_is_about_smallest(const vm_two *J, const int *order, vmi_three separation)
{
    if (vmi_torque_free_are_equal(J[order[0]], J[order[1]])) return 1;
    if (vmi_torque_free_are_equal(J[order[1]], J[order[2]])) return 0;
    return separation.hi >= 0;
}

/* Returns the moments of inertia and omega of a body in its axes 1, 2, 3. Axis 3 is reversed if the axes would
   otherwise be left-handed. */
VM_API vmi_torque_free_axes vmi_torque_free_order(const vmi_torque_free_body *b)
{
    const vm_two *J = b->moment, *w = b->omega.x;
    int order[3], even = vmi_torque_free_sort(J, order), first, middle, last;
    const vmi_three separation = vmi_torque_free_separation(J, w, order);
    vm_real hand;
    vmi_torque_free_axes axes;
    axes.sigma = 1;
    if (!vmi_torque_free_is_about_smallest(J, order, separation)) {
        const int largest = order[0];
        order[0] = order[2];
        order[2] = largest;
        even = !even;
        axes.sigma = -1;
    }
    first = order[0];
    middle = order[1];
    last = order[2];
    hand = even ? 1 : -1;
    axes.S = vmi_two_shifted(vmi_two(separation.hi, separation.mid), separation.hi < 0 ? -1 : 1);
    axes.I1 = J[first];
    axes.I2 = J[middle];
    axes.I3 = J[last];
    axes.symmetric = vmi_torque_free_are_equal(axes.I1, axes.I2);
    if (axes.symmetric) axes.I2 = axes.I1;
    axes.w1 = w[first];
    axes.w2 = w[middle];
    axes.w3 = vmi_two_shifted(w[last], hand);
    axes.s = axes.w3.hi < 0 ? -1 : 1;
    axes.d12 = vmi_two_shifted(vmi_two_minus(axes.I1, axes.I2), axes.sigma);
    axes.d23 = vmi_two_shifted(vmi_two_minus(axes.I2, axes.I3), axes.sigma);
    axes.d13 = vmi_two_shifted(vmi_two_minus(axes.I1, axes.I3), axes.sigma);
    axes.matrix.x = vmi_vec3_two_high_words(&b->axis[first]);
    axes.matrix.y = vmi_vec3_two_high_words(&b->axis[middle]);
    axes.matrix.z = vm_scale(hand, vmi_vec3_two_high_words(&b->axis[last]));
    return axes;
}

/* Returns 1 if omega stays constant: for a sphere or a point, a rotation about a principal axis, and a rotation about
   an axis in the equatorial plane of a symmetric body. */
VM_API int vmi_torque_free_is_constant(const vmi_torque_free_axes *axes)
{
    const int no1 = axes->w1.hi == 0, no2 = axes->w2.hi == 0, no3 = axes->w3.hi == 0;
    if (vmi_torque_free_are_equal(axes->I1, axes->I3)) return 1;
    return (no1 && no2) || (no1 && no3) || (no3 && (no2 || axes->symmetric));
}

#endif
