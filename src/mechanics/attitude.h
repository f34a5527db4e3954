/* mechanics/attitude.h - attitudes: vectors in body axes and inertial axes, rotation matrices, Rodrigues parameters
   The attitude of a body is a quaternion q = w + x i + y j + z k that turns body axes into inertial axes. A vector
   with the components a along the body's axes has the components q a q* along inertial axes, for |q| = 1 and with the
   conjugate quaternion q* = w - x i - y j - z k. w is the cosine of half the angle of the rotation, and (x, y, z) is
   the unit vector along the axis of the rotation, times the sine of half the angle (Hamilton's quaternions,
   right-handed).
   q and -q are the same attitude. The length of q does not matter. If all four numbers of q are 0, body axes and
   inertial axes coincide (the identity). This chapter computes
     - the components of a vector along inertial axes from those along body axes, and back,
     - the rotation matrix of q, which consists of the direction cosines of the axes, and the quaternion of a matrix,
     - the modified Rodrigues parameters of q, and the quaternion of such parameters.
   Euler's angles are in the chapter mechanics/euler_angles.

       vm_quat q = {1, 0, 0, 1};                    // the body is turned by 90 degrees about z
       vm_vec3 forward = {1, 0, 0};                 // along the body's first axis
       vm_vec3 direction = vm_rotate(q, forward);   // (0, 1, 0), in inertial axes
       vm_vec3 back = vm_rotate_back(q, direction); // (1, 0, 0), in body axes

   Source: M. D. Shuster, A survey of attitude representations, J. Astronautical Sciences 41 (1993). In that survey q
   is the opposite rotation, from inertial to body axes. Tests: tests/test_attitude.c, tests/test_flow.c. */
#ifndef VARMASS_MECHANICS_ATTITUDE_H
#define VARMASS_MECHANICS_ATTITUDE_H

#include "../base/arrays.h"
#include "../base/power_of_two.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/words.h"
#include "vectors.h"

/* Reads a vector from three numbers of a state array. vmi_set3 writes a vector to a state array. */
VM_API vm_vec3 vmi_get3(const vm_real *y) { return vmi_vec3(y[0], y[1], y[2]); }

VM_API void vmi_set3(vm_real *y, vm_vec3 a)
{
    y[0] = a.x;
    y[1] = a.y;
    y[2] = a.z;
}

/* Reads a quaternion from four numbers of a state array, in the order w, x, y, z */
VM_API vm_quat vmi_get_quat(const vm_real *y) { return vmi_quat(y[0], vmi_get3(y + 1)); }

/* Returns the vector of length 1 in the direction of a. If the length of a is a normal number (at least VM_MIN), the
   relative error of each component that is a normal number is within 4 eps. Returns NaN if a component is infinite or
   if the length of a is 0, because a then has no direction. */
VM_API vm_vec3 vm_unit(vm_vec3 a)
{
    const vm_vec3 b = vmi_over(a, vmi_norm_max(a));
    return vmi_over(b, VM_SQRT(vm_dot(b, b)));
}

/* Returns the vector of length 1 in the direction of a, which must be finite and not 0, also where the length of a
   overflows or is subnormal. The division by a power of two is exact, so that the result has the bits of a/vm_norm(a)
   wherever length and result have only normal numbers and zeros. (The results of vm_unit have other last digits.) */
VM_API vm_vec3 vmi_unit_vector(vm_vec3 a)
{
    const vm_vec3 b = vmi_over(a, vmi_power_below(vmi_norm_max(a)));
    return vmi_over(b, vm_norm(b));
}

/* Writes the time derivatives of w, x, y, z of the quaternion q to the array `rates`. q is the attitude of a body with
   the angular velocity omega (rad/s, body axes). The formula is q' = q (0, omega)/2 + |omega| (1 - |q|^2) q/8, where
   (0, omega) is a quaternion whose w is 0. The argument `square` must be |q|^2. q should have length 1, but errors of
   an integration change its length. The second term of q' brings the length back to 1. This correction is slower than
   the rotation of the body. Therefore an integrator can take steps as long as without the correction. */
VM_INLINE void vmi_attitude_rates(vm_quat q, vm_real square, vm_vec3 omega, vm_real *rates)
{
    const vm_real back = VM_SQRT(vm_dot(omega, omega)) * (1 - square) / 8;
    const vm_real x = omega.x / 2, y = omega.y / 2, z = omega.z / 2;
    rates[0] = back * q.w - q.x * x - q.y * y - q.z * z;
    rates[1] = back * q.x + q.w * x + q.y * z - q.z * y;
    rates[2] = back * q.y + q.w * y + q.z * x - q.x * z;
    rates[3] = back * q.z + q.w * z + q.x * y - q.y * x;
}

/* The components along inertial axes of a vector whose components along body axes are a. The error is within 6 eps |a|.
   If a number of q or a is infinite or NaN, the result is NaN. */
VM_API vm_vec3 vm_rotate(vm_quat q, vm_vec3 a)
{
    const vmi_mat3 m = vmi_rotation(q);
    if (!vmi_quat_is_finite(q) || !vmi_vec3_is_finite(a)) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_times(&m, a);
}

/* The components along body axes of a vector whose components along inertial axes are a. The error is within 6 eps |a|.
   If a number of q or a is infinite or NaN, the result is NaN. */
VM_API vm_vec3 vm_rotate_back(vm_quat q, vm_vec3 a)
{
    const vmi_mat3 m = vmi_rotation(q);
    if (!vmi_quat_is_finite(q) || !vmi_vec3_is_finite(a)) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_times_transposed(&m, a);
}

/* Writes the rotation matrix c of the attitude q, row by row. c[3 i + j] is the cosine of the angle between inertial
   axis i and body axis j. c times the components of a vector along body axes gives its components along inertial axes.
   The error of an entry is within 6 eps. Some books define the inverse matrix, from inertial to body axes, which is the
   transpose of c.
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE if a number of q is infinite or NaN, and VM_OK
   otherwise. */
VM_API int vm_quat_to_matrix(vm_quat q, vm_real c[9])
{
    const vmi_mat3 m = vmi_rotation(q);
    if (!c) return VM_BAD_ARGUMENT;
    if (!vmi_quat_is_finite(q)) return VM_NOT_FINITE;
    vmi_set3(c, vmi_vec3(m.x.x, m.y.x, m.z.x));
    vmi_set3(c + 3, vmi_vec3(m.x.y, m.y.y, m.z.y));
    vmi_set3(c + 6, vmi_vec3(m.x.z, m.y.z, m.z.z));
    return VM_OK;
}

/* vmi_is_rotation tests conditions that every rotation matrix satisfies. This number is the tolerance of these tests.
   A rotation matrix whose entries are rounded to three digits is accepted. */
#define VMI_MATRIX_TOLERANCE VM_C(0.0078125)

/* Returns 1 if c is a rotation matrix, apart from small errors of its entries, and 0 otherwise. The columns x, y, z of
   a rotation matrix have length 1, and the cross product of x and y is z. */
VM_API int vmi_is_rotation(const vm_real *c)
{
    const vm_vec3 x = vmi_vec3(c[0], c[3], c[6]), y = vmi_vec3(c[1], c[4], c[7]), z = vmi_vec3(c[2], c[5], c[8]);
    const vm_vec3 lengths = vmi_vec3(vm_dot(x, x) - 1, vm_dot(y, y) - 1, vm_dot(z, z) - 1);
    const vm_vec3 turned = vm_sub(vm_cross(x, y), z);
    return vmi_norm_max(lengths) <= VMI_MATRIX_TOLERANCE && vmi_norm_max(turned) <= VMI_MATRIX_TOLERANCE;
}

/* The quaternion q of length 1, with w >= 0, that has the rotation matrix c. The comment of vm_quat_to_matrix describes
   c. The error is within 4 eps. For a rotation by a small angle that of x, y and z is within 4 eps times this angle.
   Rounding errors of c cause errors of the same size in q. There are four formulas for q, each with a division; the
   function uses the formula with the largest divisor, because its rounding errors are smallest (Shepperd 1978).
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE if an entry of c is infinite or NaN, VM_DOMAIN if c is not
   close to a rotation matrix (for example if c is a reflection), and VM_OK otherwise. */
VM_API int vm_quat_from_matrix(const vm_real c[9], vm_quat *q)
{
    vm_real v[4], trace; /* v: a multiple of the quaternion w, x, y, z */
    int i = 0, j, k;
    if (!c || !q) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(9, c)) return VM_NOT_FINITE;
    if (!vmi_is_rotation(c)) return VM_DOMAIN;
    trace = c[0] + c[4] + c[8];
    if (c[4] > c[0]) i = 1;
    if (c[8] > c[4 * i]) i = 2;
    j = (i + 1) % 3;
    k = (i + 2) % 3;
    if (trace > c[4 * i]) {
        v[0] = 1 + trace;
        v[1] = c[7] - c[5];
        v[2] = c[2] - c[6];
        v[3] = c[3] - c[1];
    } else {
        v[0] = c[3 * k + j] - c[3 * j + k];
        v[1 + i] = 1 + c[4 * i] - c[4 * j] - c[4 * k];
        v[1 + j] = c[3 * j + i] + c[3 * i + j];
        v[1 + k] = c[3 * k + i] + c[3 * i + k];
    }
    *q = vm_unit_quat(vmi_get_quat(v));
    if (q->w < 0) *q = vmi_quat(-q->w, vm_scale(-1, vmi_quat_vector(*q)));
    return VM_OK;
}

/* Modified Rodrigues parameters of an attitude. These three parameters are the components of the unit vector along the
   axis of the rotation, times the tangent of a quarter of the angle. q and -q are the same attitude; the function uses
   the quaternion whose w is >= 0. The angle is then at most pi, and the length of the parameters p is at most 1, apart
   from rounding. The other set of parameters of the same attitude (the shadow set) is -p/|p|^2. At an angle of pi,
   where w = 0, both sets have the same length; the result is then (x, y, z)/|q|. The relative error of each component
   is within 4 eps. If a number of q is infinite or NaN, the result is NaN. */
VM_API vm_vec3 vm_quat_to_mrp(vm_quat q)
{
    vm_real divisor;
    if (!vmi_quat_is_finite(q)) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    q = vmi_quat_scaled(q);
    divisor = VM_SQRT(vmi_quat_square(q)) + VM_FABS(q.w);
    if (q.w < 0) divisor = -divisor;
    return vmi_over(vmi_quat_vector(q), divisor);
}

/* The attitude, a quaternion of length 1, that belongs to the modified Rodrigues parameters p of any length. If the
   length |p| is above 1, the angle of the rotation is above pi, and w of the result is negative. The relative error of
   each component of the result is within 8 eps. This holds even for a small w, at an angle close to pi, because the
   function computes 1 - |p|^2 in three words. If a parameter is infinite or NaN, the result is NaN. */
VM_API vm_quat vm_quat_from_mrp(vm_vec3 p)
{
    vm_real scale = 1, x[3]; /* scale: a power of two that makes the components of a long p at most 2 */
    vmi_three w;
    int i;
    if (!vmi_vec3_is_finite(p)) return vmi_quat(VM_NAN, vmi_vec3(VM_NAN, VM_NAN, VM_NAN));
    if (vmi_norm_max(p) > 1) scale = 1 / vmi_power_below(vmi_norm_max(p));
    p = vm_scale(scale, p);
    vmi_set3(x, p);
    w = vmi_three_words(scale * scale, 0, 0);
    for (i = 0; i < 3; i++)
        w = vmi_three_plus(w, vmi_three_times(vmi_three_words(x[i], 0, 0), vmi_three_words(-x[i], 0, 0)));
    return vm_unit_quat(vmi_quat(w.hi + (w.mid + w.lo), vm_scale(2 * scale, p)));
}

#endif
