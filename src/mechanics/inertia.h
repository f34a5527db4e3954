/* mechanics/inertia.h - inertia tensors, parallel axes, principal axes
   A vm_inertia holds the entries of a body's tensor of inertia, about some point and along some axes. This chapter
   tests whether a body can have a given tensor, moves it to parallel axes (40), and finds principal moments and axes.

       vm_inertia disc = {1, 1, 2, 0, 0, 0}; // xx, yy, zz, xy, xz, yz, kg m^2
       vm_vec3 d = {0.5, 0, 0};              // m
       if (vm_inertia_is_possible(&disc)) disc = vm_parallel_axes(&disc, 4, d); // 4 kg, now about a point 0.5 m away

   The other functions are internal: they turn, add and invert tensors for the chapters on jumps, streams and scenes.
   Tests: tests/test_bodies.c, tests/test_jumps.c. */
#ifndef VARMASS_MECHANICS_INERTIA_H
#define VARMASS_MECHANICS_INERTIA_H

#include "../base/real.h"
#include "vectors.h"

/* A tensor of inertia, given by its entries, in kg m^2. The products of inertia include the minus sign of the tensor:
   xy = -integral of x y dm. */
typedef struct VM_TAG(vm_inertia) {
    vm_real xx, yy, zz, xy, xz, yz;
} vm_inertia;

VM_API int vmi_inertia_is_finite(const vm_inertia *i)
{
    return vmi_vec3_is_finite(vmi_vec3(i->xx, i->yy, i->zz)) && vmi_vec3_is_finite(vmi_vec3(i->xy, i->xz, i->yz));
}

/* The product of the tensor i and the vector a */
VM_API vm_vec3 vmi_inertia_times(const vm_inertia *i, vm_vec3 a)
{
    return vmi_vec3(i->xx * a.x + i->xy * a.y + i->xz * a.z, i->xy * a.x + i->yy * a.y + i->yz * a.z,
                    i->xz * a.x + i->yz * a.y + i->zz * a.z);
}

/* The tensor a + c b, where a, b are tensors and c is a number */
VM_API vm_inertia vmi_inertia_plus(vm_inertia a, vm_real c, vm_inertia b)
{
    a.xx += c * b.xx;
    a.yy += c * b.yy;
    a.zz += c * b.zz;
    a.xy += c * b.xy;
    a.xz += c * b.xz;
    a.yz += c * b.yz;
    return a;
}

/* P(d) = |d|^2 E - d d^T, where E is the unit matrix: the inertia about the origin of a point mass of 1 kg at d. */
VM_API vm_inertia vmi_inertia_of_point(vm_vec3 d)
{
    vm_inertia p;
    p.xx = d.y * d.y + d.z * d.z;
    p.yy = d.x * d.x + d.z * d.z;
    p.zz = d.x * d.x + d.y * d.y;
    p.xy = -d.x * d.y;
    p.xz = -d.x * d.z;
    p.yz = -d.y * d.z;
    return p;
}

/* The tensor m^T i m. It has the entries of the tensor i along new axes, which are the columns of the matrix m. */
VM_INLINE vm_inertia vmi_inertia_along(const vm_inertia *i, const vmi_mat3 *m)
{
    const vm_vec3 x = vmi_inertia_times(i, m->x), y = vmi_inertia_times(i, m->y), z = vmi_inertia_times(i, m->z);
    vm_inertia t;
    t.xx = vm_dot(m->x, x);
    t.yy = vm_dot(m->y, y);
    t.zz = vm_dot(m->z, z);
    t.xy = vm_dot(m->x, y);
    t.xz = vm_dot(m->x, z);
    t.yz = vm_dot(m->y, z);
    return t;
}

/* Returns, for each entry of the tensor m^T i m, the sum of the absolute values of the entry's terms. The rounding
   error of an entry is a few eps times its sum. */
VM_INLINE vm_inertia vmi_inertia_sizes(const vm_inertia *i, const vmi_mat3 *m)
{
    vm_inertia a;
    vmi_mat3 b;
    a.xx = VM_FABS(i->xx);
    a.yy = VM_FABS(i->yy);
    a.zz = VM_FABS(i->zz);
    a.xy = VM_FABS(i->xy);
    a.xz = VM_FABS(i->xz);
    a.yz = VM_FABS(i->yz);
    b.x = vmi_abs(m->x);
    b.y = vmi_abs(m->y);
    b.z = vmi_abs(m->z);
    return vmi_inertia_along(&a, &b);
}

/* The sum |xx| + |yy| + |zz|. It equals the trace if i is the inertia of a body. */
VM_API vm_real vmi_inertia_trace(const vm_inertia *i) { return VM_FABS(i->xx) + VM_FABS(i->yy) + VM_FABS(i->zz); }

/* The tolerance, in kg m^2, for the rounding errors of a tensor. Usually i is this tensor. If its entries were computed
   as sums, each entry of i may instead be the sum of the terms' absolute values (vmi_inertia_sizes). */
VM_API vm_real vmi_inertia_slack(const vm_inertia *i) { return 32 * VM_EPSILON * vmi_inertia_trace(i); }

/* Returns 1 if a body can have the inertia i, within the tolerance slack (kg m^2). For a body, the matrix tr(i)/2 E - i
   (trace tr, unit matrix E) has no negative eigenvalue. The function adds `slack` to the trace, so that rounding errors
   do not change the answer. It then tests whether Gaussian elimination gives positive pivots only. */
VM_API int vmi_inertia_is_within(const vm_inertia *i, vm_real slack)
{
    const vm_real half = (i->xx + i->yy + i->zz + slack) / 2;
    vm_real x, y, z, yz; /* x, y, z: the pivots; yz: minus the matrix entry yz after the first elimination */
    if (!VM_IS_FINITE(half)) return 0;
    if (half == 0) return i->xx == 0 && i->yy == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    x = half - i->xx;
    if (!(x > 0)) return 0;
    y = half - i->yy - i->xy / x * i->xy;
    if (!(y > 0)) return 0;
    yz = i->yz + i->xy / x * i->xz;
    z = half - i->zz - i->xz / x * i->xz;
    return z - yz / y * yz > 0;
}

/* Returns 1 if a body can have this inertia. Returns 0 if not, and also if the trace overflows, for NaN and for a null
   pointer. The principal moments of a body are not negative, and none is larger than the sum of the other two. A
   violation of these rules by up to 32 eps of the trace counts as a rounding error. Rods and points count as bodies. */
VM_API int vm_inertia_is_possible(const vm_inertia *inertia)
{
    return inertia && vmi_inertia_is_finite(inertia) && vmi_inertia_is_within(inertia, vmi_inertia_slack(inertia));
}

/* Inertia about a point at d from the mass centre, along parallel axes, (40). It is own + mass P(d), where own (kg m^2)
   is the inertia about the mass centre and P(d) = |d|^2 E - d d^T (d in m, unit matrix E). A call with -mass computes
   the opposite: the inertia about the mass centre from the inertia about such a point. Returns NaN for a null pointer.
   A NaN in an argument makes every entry that depends on it NaN. */
VM_API vm_inertia vm_parallel_axes(const vm_inertia *own, vm_real mass, vm_vec3 d)
{
    const vm_inertia none = {VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN, VM_NAN};
    return vmi_inertia_plus(own ? *own : none, mass, vmi_inertia_of_point(d));
}

/* ---- principal axes ---- */

/* Principal moments, in kg m^2, and unit vectors along the principal axes */
typedef struct VM_TAG(vmi_principal) {
    vm_real moment[3];
    vm_vec3 axis[3];
} vmi_principal;

/* Applies one Jacobi rotation, in the plane of the axes p and q, to the symmetric matrix a, so that a[p][q] becomes 0.
   The columns of v are the axes; the function turns these columns by the same angle. t, c and s are the tangent,
   cosine and sine of this angle. Two angles are possible, of which the function uses the smaller one. */
VM_API void vmi_jacobi_rotation(vm_real a[3][3], vm_real v[3][3], int p, int q)
{
    const vm_real theta = (a[q][q] - a[p][p]) / (2 * a[p][q]), root = VM_SQRT(theta * theta + 1);
    const vm_real t = VM_COPYSIGN(1, theta) / (VM_FABS(theta) + root), c = 1 / VM_SQRT(t * t + 1), s = t * c;
    const int other = 3 - p - q;
    vm_real x = a[other][p], y = a[other][q];
    int k;
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = 0;
    a[other][p] = a[p][other] = c * x - s * y;
    a[other][q] = a[q][other] = s * x + c * y;
    for (k = 0; k < 3; k++) {
        x = v[k][p];
        y = v[k][q];
        v[k][p] = c * x - s * y;
        v[k][q] = s * x + c * y;
    }
}

/* Principal moments and axes of the tensor i, found by Jacobi rotations, which converge quadratically. */
VM_API vmi_principal vmi_principal_axes(const vm_inertia *i)
{
    const int most_sweeps = 12; /* more than enough, because convergence is quadratic */
    vm_real a[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vmi_principal result;
    int sweep, p, q;
    a[0][0] = i->xx;
    a[1][1] = i->yy;
    a[2][2] = i->zz;
    a[0][1] = a[1][0] = i->xy;
    a[0][2] = a[2][0] = i->xz;
    a[1][2] = a[2][1] = i->yz;
    for (sweep = 0; sweep < most_sweeps; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q] != 0) vmi_jacobi_rotation(a, v, p, q);
    for (p = 0; p < 3; p++) {
        result.moment[p] = a[p][p];
        result.axis[p] = vmi_vec3(v[0][p], v[1][p], v[2][p]);
    }
    return result;
}

/* The tensor that has the principal moments and axes *p */
VM_API vm_inertia vmi_inertia_from(const vmi_principal *p)
{
    vm_inertia i = {0, 0, 0, 0, 0, 0};
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 e = p->axis[k], m = vm_scale(p->moment[k], e);
        i.xx += m.x * e.x;
        i.yy += m.y * e.y;
        i.zz += m.z * e.z;
        i.xy += m.x * e.y;
        i.xz += m.x * e.z;
        i.yz += m.y * e.z;
    }
    return i;
}

/* Returns 1 if a body can have the principal moments *p: no moment is larger than the sum of the other two plus
   `slack`, in kg m^2. It follows that no moment is below -slack. */
VM_API int vmi_moments_are_possible(const vmi_principal *p, vm_real slack)
{
    const vm_real a = p->moment[0], b = p->moment[1], c = p->moment[2];
    return a <= b + c + slack && b <= a + c + slack && c <= a + b + slack;
}

/* A sum counts as a mere rounding error if it is below this share of the sum of its terms' absolute values. */
#define VMI_LOST_SHARE (8 * VM_EPSILON)

/* Returns 1 if `moment`, the moment of inertia about `axis`, is smaller than its rounding error, negative or NaN. The
   entries of the tensor are sums. The entries of *sizes are the sums of the absolute values of the same terms. */
VM_API int vmi_moment_is_lost(vm_real moment, vm_vec3 axis, const vm_inertia *sizes)
{
    const vm_vec3 e = vmi_abs(axis);
    return !(moment > VMI_LOST_SHARE * vm_dot(e, vmi_inertia_times(sizes, e)));
}

/* Changes moments that are possible within rounding errors into moments that a body can have exactly. A moment that is
   smaller than its rounding error becomes 0. A moment that is larger than the sum of the other two becomes equal to
   this sum. Returns 1 if a moment changed. */
VM_API int vmi_clamp_moments(vmi_principal *p, const vm_inertia *sizes)
{
    int k, changed = 0;
    for (k = 0; k < 3; k++) {
        if (p->moment[k] == 0 || !vmi_moment_is_lost(p->moment[k], p->axis[k], sizes)) continue;
        p->moment[k] = 0;
        changed = 1;
    }
    for (k = 0; k < 3; k++) {
        const vm_real others = p->moment[(k + 1) % 3] + p->moment[(k + 2) % 3];
        if (p->moment[k] <= others) continue;
        p->moment[k] = others;
        changed = 1;
    }
    return changed;
}

/* The angular velocity of a body with the angular momentum h. Axes with a zero moment of inertia are left out. */
VM_API vm_vec3 vmi_spin_of(const vmi_principal *p, vm_vec3 h)
{
    vm_vec3 omega = vmi_vec3(0, 0, 0);
    int k;
    for (k = 0; k < 3; k++)
        if (p->moment[k] > 0) omega = vm_add(omega, vm_scale(vm_dot(p->axis[k], h) / p->moment[k], p->axis[k]));
    return omega;
}

/* Solves i omega = h for the angular velocity *omega, with the inertia i, its principal axes *p and the angular
   momentum h. A rod or a point has an axis with zero moment, about which no body can have angular momentum. The
   component of *omega along this axis is that of `before`. Returns 1 if the component of h along such an axis exceeds
   the argument `noise`, else 0. */
VM_API int vmi_solve_spin(const vm_inertia *i, const vmi_principal *p, vm_vec3 h, vm_real noise, vm_vec3 before,
                          vm_vec3 *omega)
{
    vm_vec3 w = vmi_vec3(0, 0, 0);
    int k, left = 0;
    for (k = 0; k < 3; k++) {
        if (p->moment[k] > 0) continue;
        w = vm_add(w, vm_scale(vm_dot(p->axis[k], before), p->axis[k]));
        left = left || VM_FABS(vm_dot(p->axis[k], h)) > noise;
    }
    for (k = 0; k < 2; k++) w = vm_add(w, vmi_spin_of(p, vm_sub(h, vmi_inertia_times(i, w))));
    *omega = w;
    return left;
}

#endif
