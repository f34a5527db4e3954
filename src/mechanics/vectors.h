/* mechanics/vectors.h - vectors, quaternions and rotations in space
   The two types, vm_vec3 and vm_quat, are plain data. A quaternion describes the attitude of a body: it converts
   components of vectors along body axes into components along inertial axes. The length of the quaternion does not
   matter, and a quaternion of four zeros stands for the identity (no rotation).

       vm_vec3 omega = {0, 0, 3};                 // x, y, z
       vm_quat quarter_turn = {0.7071068, 0, 0, 0.7071068}; // w, x, y, z: 90 degrees about z

   The functions whose names begin with vm_ are for users. They compute sum, difference, multiple, dot product, cross
   product and length of vectors, and product and normalisation of quaternions. The internal functions (vmi_) compute
   norms and rotation matrices. No function here checks its arguments; infinite and NaN numbers are computed with like
   any others. Tests: tests/test_attitude.c, tests/test_jumps.c, tests/test_torque_free.c. */
#ifndef VARMASS_MECHANICS_VECTORS_H
#define VARMASS_MECHANICS_VECTORS_H

#include "../base/hypot.h"
#include "../base/real.h"

/* A vector, given by its components */
typedef struct VM_TAG(vm_vec3) {
    vm_real x, y, z;
} vm_vec3;

/* An attitude: w + x i + y j + z k converts vectors from body axes to inertial axes. Its length does not matter. */
typedef struct VM_TAG(vm_quat) {
    vm_real w, x, y, z;
} vm_quat;

/* A 3 by 3 matrix with the columns x, y, z. For a rotation matrix these are the turned unit vectors. */
typedef struct VM_TAG(vmi_mat3) {
    vm_vec3 x, y, z;
} vmi_mat3;

VM_API vm_vec3 vmi_vec3(vm_real x, vm_real y, vm_real z)
{
    vm_vec3 a;
    a.x = x;
    a.y = y;
    a.z = z;
    return a;
}

/* The sum a + b of two vectors */
VM_API vm_vec3 vm_add(vm_vec3 a, vm_vec3 b) { return vmi_vec3(a.x + b.x, a.y + b.y, a.z + b.z); }

/* The difference a - b of two vectors */
VM_API vm_vec3 vm_sub(vm_vec3 a, vm_vec3 b) { return vmi_vec3(a.x - b.x, a.y - b.y, a.z - b.z); }

/* The multiple c a of a vector, for a number c */
VM_API vm_vec3 vm_scale(vm_real c, vm_vec3 a) { return vmi_vec3(c * a.x, c * a.y, c * a.z); }

/* The dot product a.x b.x + a.y b.y + a.z b.z of two vectors. Its error is within 2 eps |a| |b|. */
VM_API vm_real vm_dot(vm_vec3 a, vm_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* The vector a/c. Each component is rounded only once; multiplication by 1/c would round it twice. */
VM_API vm_vec3 vmi_over(vm_vec3 a, vm_real c) { return vmi_vec3(a.x / c, a.y / c, a.z / c); }

/* The cross product a x b of two vectors, by the right-hand rule. The error of a component is within 2 eps |a| |b|. */
VM_API vm_vec3 vm_cross(vm_vec3 a, vm_vec3 b)
{
    return vmi_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

VM_API vm_vec3 vmi_abs(vm_vec3 a) { return vmi_vec3(VM_FABS(a.x), VM_FABS(a.y), VM_FABS(a.z)); }

/* The sum |x| + |y| + |z| of the absolute values of a's components */
VM_API vm_real vmi_norm1(vm_vec3 a) { return VM_FABS(a.x) + VM_FABS(a.y) + VM_FABS(a.z); }

/* The length of the vector a, within 4 eps of itself if it is a normal number. Its square may overflow. */
VM_API vm_real vm_norm(vm_vec3 a) { return vmi_hypot(vmi_hypot(a.x, a.y), a.z); }

/* The largest of |x|, |y| and |z|, where x, y, z are the components of a */
VM_API vm_real vmi_norm_max(vm_vec3 a)
{
    const vm_vec3 b = vmi_abs(a);
    const vm_real c = b.x > b.y ? b.x : b.y;
    return c > b.z ? c : b.z;
}

VM_API int vmi_vec3_is_finite(vm_vec3 a) { return VM_IS_FINITE(a.x) && VM_IS_FINITE(a.y) && VM_IS_FINITE(a.z); }

/* The product m a of the matrix m and the vector a */
VM_API vm_vec3 vmi_times(const vmi_mat3 *m, vm_vec3 a)
{
    return vm_add(vm_scale(a.x, m->x), vm_add(vm_scale(a.y, m->y), vm_scale(a.z, m->z)));
}

/* The product of the transposed matrix m^T and the vector a. If m is a rotation matrix, m^T undoes the rotation. */
VM_API vm_vec3 vmi_times_transposed(const vmi_mat3 *m, vm_vec3 a)
{
    return vmi_vec3(vm_dot(m->x, a), vm_dot(m->y, a), vm_dot(m->z, a));
}

VM_API vm_quat vmi_quat(vm_real w, vm_vec3 xyz)
{
    vm_quat q;
    q.w = w;
    q.x = xyz.x;
    q.y = xyz.y;
    q.z = xyz.z;
    return q;
}

/* The vector that consists of the components x, y, z of q */
VM_API vm_vec3 vmi_quat_vector(vm_quat q) { return vmi_vec3(q.x, q.y, q.z); }

VM_API int vmi_quat_is_finite(vm_quat q) { return VM_IS_FINITE(q.w) && vmi_vec3_is_finite(vmi_quat_vector(q)); }

/* Returns 1 if all four numbers of q are 0. Such a quaternion stands for the identity. */
VM_API int vmi_quat_is_none(vm_quat q) { return q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0; }

/* The square of the length of q */
VM_API vm_real vmi_quat_square(vm_quat q) { return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z; }

/* The product p q of two quaternions: the rotation by q followed by the rotation by p. If q turns the axes of a part
   into the axes of a body, and p turns the axes of the body into inertial axes, then p q turns the axes of the part
   into inertial axes. Here four zeros do not stand for coinciding axes: their product with any q is four zeros. */
VM_API vm_quat vm_quat_times(vm_quat p, vm_quat q)
{
    vm_quat r;
    r.w = p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z;
    r.x = p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y;
    r.y = p.w * q.y + p.y * q.w + p.z * q.x - p.x * q.z;
    r.z = p.w * q.z + p.z * q.w + p.x * q.y - p.y * q.x;
    return r;
}

VM_API vm_quat vmi_quat_over(vm_quat q, vm_real c)
{
    q.w /= c;
    q.x /= c;
    q.y /= c;
    q.z /= c;
    return q;
}

/* Divides q by the absolute value of its largest component, so that the square of its length neither overflows nor
   underflows. Four zeros become the identity. */
VM_API vm_quat vmi_quat_scaled(vm_quat q)
{
    vm_real largest = VM_FABS(q.w);
    if (VM_FABS(q.x) > largest) largest = VM_FABS(q.x);
    if (VM_FABS(q.y) > largest) largest = VM_FABS(q.y);
    if (VM_FABS(q.z) > largest) largest = VM_FABS(q.z);
    if (largest == 0) {
        q.w = 1;
        largest = 1;
    }
    return vmi_quat_over(q, largest);
}

/* The quaternion of length 1 for the same rotation as q. Four zeros give the identity. */
VM_API vm_quat vm_unit_quat(vm_quat q)
{
    q = vmi_quat_scaled(q);
    return vmi_quat_over(q, VM_SQRT(vmi_quat_square(q)));
}

/* The rotation matrix of q. `square`, the square of q's length, must be neither 0 nor subnormal, infinite or NaN. */
VM_INLINE vmi_mat3 vmi_rotation_of_square(vm_quat q, vm_real square)
{
    const vm_real s = 2 / square, x = s * q.x, y = s * q.y, z = s * q.z;
    const vm_real xx = x * q.x, yy = y * q.y, zz = z * q.z, xy = x * q.y, xz = x * q.z, yz = y * q.z;
    const vm_real wx = x * q.w, wy = y * q.w, wz = z * q.w;
    vmi_mat3 m;
    m.x = vmi_vec3(1 - (yy + zz), xy + wz, xz - wy);
    m.y = vmi_vec3(xy - wz, 1 - (xx + zz), yz + wx);
    m.z = vmi_vec3(xz + wy, yz - wx, 1 - (xx + yy));
    return m;
}

/* The rotation matrix of q, of any length. It is exactly the identity for (w, 0, 0, 0) and for four zeros. */
VM_API vmi_mat3 vmi_rotation(vm_quat q)
{
    q = vmi_quat_scaled(q);
    return vmi_rotation_of_square(q, vmi_quat_square(q));
}

#endif
