/* mechanics/euler_angles.h - Euler's angles

   The angles psi, theta, phi of the sequence 3-1-3 give the attitude of a body. The body turns by psi about the z
   axis, then by theta about its own x axis (the line of nodes), then by phi about its own z axis. The angles of the
   sequence 3-2-1 are yaw, pitch and roll: the body turns by yaw about the z axis, then by pitch about its own y axis,
   then by roll about its own x axis. This chapter computes
     - for both sequences, the quaternion of three angles and the three angles of a quaternion,
     - for 3-1-3, the axes about which the angles turn the body. These axes are the derivatives of the angular velocity
       omega with respect to psi', theta', phi', which Lagrange's equations need,
     - for 3-1-3, the time derivatives psi', theta', phi' of the angles from an angular velocity.

       vm_quat q = vm_euler_321(VM_C(0.1), VM_C(0.2), VM_C(0.3)); // yaw, pitch, roll
       vm_real angles[3];
       int status = vm_euler_321_angles(q, angles); // 0.1, 0.2, 0.3

   Angles are in rad. Errors are within 8 eps for angles up to 1e9 (float 1e4); those of vm_euler_313_rates are a few
   eps of |omega|/|sin(theta)|. Beyond 2^(p-1) quarter turns, where p is the number of binary digits of vm_real, a
   result has no meaning, because adjacent floating-point numbers differ by 1 rad or more.
   Tests: tests/test_attitude.c, tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_EULER_ANGLES_H
#define VARMASS_MECHANICS_EULER_ANGLES_H

#include "../base/elementary.h"
#include "../base/hypot.h"
#include "../base/power_of_two.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "vectors.h"

/* Computes the attitude of a body from Euler's angles psi, theta, phi (sequence 3-1-3). The result is a quaternion of
   length 1, which converts vectors from body axes to inertial axes. If an angle is infinite or NaN, the result is
   NaN. */
VM_API vm_quat vm_euler_313(vm_real psi, vm_real theta, vm_real phi)
{
    vm_quat turn = {1, 0, 0, 0}, tilt = {1, 0, 0, 0}, spin = {1, 0, 0, 0};
    vmi_sincos(psi / 2, &turn.z, &turn.w);
    vmi_sincos(theta / 2, &tilt.x, &tilt.w);
    vmi_sincos(phi / 2, &spin.z, &spin.w);
    return vm_quat_times(vm_quat_times(turn, tilt), spin);
}

/* Computes the attitude of a body from yaw, pitch and roll (sequence 3-2-1).
   The result is a quaternion of length 1, which converts vectors from body axes to inertial axes. If an angle is
   infinite or NaN, the result is NaN. */
VM_API vm_quat vm_euler_321(vm_real yaw, vm_real pitch, vm_real roll)
{
    vm_quat about_z = {1, 0, 0, 0}, about_y = {1, 0, 0, 0}, about_x = {1, 0, 0, 0};
    vmi_sincos(yaw / 2, &about_z.z, &about_z.w);
    vmi_sincos(pitch / 2, &about_y.y, &about_y.w);
    vmi_sincos(roll / 2, &about_x.x, &about_x.w);
    return vm_quat_times(vm_quat_times(about_z, about_y), about_x);
}

/* A complex number re + i im. Each part is stored in two words, as the sum of two vm_reals. The quaternion of a
   sequence of three angles is equivalent to two complex numbers, p and r. A complex number has a length and an angle.
   The angle of p is half the sum of the first and the third angle, and the angle of r is half their difference. The
   lengths of p and r depend on the middle angle alone. */
typedef struct VM_TAG(vmi_euler_part) {
    vm_two re, im;
} vmi_euler_part;

VM_API int vmi_euler_is_none(const vmi_euler_part *p) { return p->re.hi == 0 && p->im.hi == 0; }

/* Multiplies the complex number p by a power of two that makes the larger of |re| and |im| about 1, so that no product
   underflows. Returns the power. */
VM_API vm_real vmi_euler_scale(vmi_euler_part *p)
{
    const vm_real largest = vmi_larger(VM_FABS(p->re.hi), VM_FABS(p->im.hi)), power = 1 / vmi_power_below(largest);
    p->re = vmi_two_shifted(p->re, power);
    p->im = vmi_two_shifted(p->im, power);
    return power;
}

/* The real part of the product p r if sign is 1, or of the product of p and the conjugate of r if sign is -1. */
VM_API vm_real vmi_euler_real(const vmi_euler_part *p, const vmi_euler_part *r, vm_real sign)
{
    const vm_two re = vmi_two_times(p->re, r->re), im = vmi_two_times(p->im, r->im);
    return vmi_two_minus(re, vmi_two_shifted(im, sign)).hi;
}

/* Writes the first and the third angle, both from -pi to pi. The first angle is that of the complex number p r, and the
   third angle is that of p times the conjugate of r. `sum` and `difference` are the imaginary parts of these two
   numbers. The caller computes the imaginary parts, because they would lose digits if this function computed them from
   p and r. If p or r is 0 (gimbal lock), only the sum or the difference of the two angles is determined; the third
   angle is then 0. */
VM_API void vmi_euler_first_and_third(vmi_euler_part p, vmi_euler_part r, vm_real sum, vm_real difference,
                                      vm_real *angles)
{
    vm_real power;
    if (vmi_euler_is_none(&p) || vmi_euler_is_none(&r)) {
        const vmi_euler_part *other = vmi_euler_is_none(&p) ? &r : &p;
        angles[0] = vmi_atan2(2 * other->re.hi * other->im.hi + 0, vmi_euler_real(other, other, 1));
        angles[2] = 0;
        return;
    }
    power = vmi_euler_scale(&p);
    sum *= power;
    difference *= power;
    power = vmi_euler_scale(&r);
    sum *= power;
    difference *= power;
    angles[0] = vmi_atan2(sum + 0, vmi_euler_real(&p, &r, 1));
    angles[2] = vmi_atan2(difference + 0, vmi_euler_real(&p, &r, -1));
}

/* Multiplies q by a power of two, without rounding, so that its largest component is about 1. If q consists of four
   zeros, the result is the identity (1, 0, 0, 0). */
VM_API vm_quat vmi_euler_normal_size(vm_quat q)
{
    const vm_real most = vmi_larger(VM_FABS(q.w), vmi_norm_max(vmi_quat_vector(q)));
    const vm_real power = 1 / vmi_power_below(most);
    if (most == 0) return vmi_quat(1, vmi_vec3(0, 0, 0));
    return vmi_quat(q.w * power, vm_scale(power, vmi_quat_vector(q)));
}

/* Euler's angles psi, theta, phi of the sequence 3-1-3 from an attitude q of any length.
   psi and phi are between -pi and pi, theta between 0 and pi. If theta is exactly 0 or pi, the line of nodes is not
   determined (gimbal lock), and phi is 0. If q is taken as exact, the relative error of each angle is within 4 eps,
   even close to gimbal lock. The rotation by the three angles differs from the rotation by q by at most 8 eps.
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE if a number of q is infinite or NaN, and VM_OK
   otherwise. */
VM_API int vm_euler_313_angles(vm_quat q, vm_real angles[3])
{
    vmi_euler_part p, r;
    if (!angles) return VM_BAD_ARGUMENT;
    if (!vmi_quat_is_finite(q)) return VM_NOT_FINITE;
    q = vmi_euler_normal_size(q);
    p.re = vmi_two(q.w, 0);
    p.im = vmi_two(q.z, 0);
    r.re = vmi_two(q.x, 0);
    r.im = vmi_two(q.y, 0);
    if (!vmi_euler_is_none(&p)) vmi_euler_scale(&p); /* so that no product below loses digits to underflow */
    if (!vmi_euler_is_none(&r)) vmi_euler_scale(&r);
    vmi_euler_first_and_third(p, r, vmi_sum_of_products(p.re.hi, r.im.hi, r.re.hi, p.im.hi),
                              vmi_sum_of_products(r.re.hi, p.im.hi, -p.re.hi, r.im.hi), angles);
    angles[1] = 2 * vmi_atan2(vmi_hypot(q.x, q.y), vmi_hypot(q.w, q.z));
    return VM_OK;
}

/* Yaw, pitch and roll of the sequence 3-2-1 from an attitude q of any length, in this order.
   Yaw and roll are between -pi and pi, pitch between -pi/2 and pi/2. If pitch is exactly pi/2 or -pi/2 (gimbal lock),
   roll is 0. If q is taken as exact, the relative error of each angle is within 4 eps, even close to gimbal lock. The
   rotation by the three angles differs from the rotation by q by at most 8 eps.
   Returns VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE if a number of q is infinite or NaN, and VM_OK
   otherwise. */
VM_API int vm_euler_321_angles(vm_quat q, vm_real angles[3])
{
    vmi_euler_part p, r;
    vm_real sine, cosine; /* sine and cosine of the pitch, times |q|^2 */
    if (!angles) return VM_BAD_ARGUMENT;
    if (!vmi_quat_is_finite(q)) return VM_NOT_FINITE;
    q = vmi_euler_normal_size(q);
    p.re = vmi_two_sum(q.w, -q.y);
    p.im = vmi_two_sum(q.x, q.z);
    r.re = vmi_two_sum(q.w, q.y);
    r.im = vmi_two_sum(q.z, -q.x);
    vmi_euler_first_and_third(p, r, 2 * vmi_sum_of_products(q.w, q.z, q.x, q.y),
                              2 * vmi_sum_of_products(q.w, q.x, q.y, q.z), angles);
    sine = 2 * vmi_sum_of_products(q.w, q.y, -q.x, q.z);
    cosine = vmi_hypot(p.re.hi, p.im.hi) * vmi_hypot(r.re.hi, r.im.hi);
    angles[1] = vmi_atan2(sine, cosine);
    return VM_OK;
}

/* Unit vectors of the axes about which Euler's angles turn the body, along inertial axes. The angular velocity is
   omega = psi' axis[0] + theta' axis[1] + phi' axis[2]. Therefore axis[i] is domega/dq'_i if q'_0, q'_1, q'_2 are the
   rates psi', theta', phi'. A call with a null pointer does nothing. */
VM_API void vm_euler_313_axes(vm_real psi, vm_real theta, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine; /* s, c: sine and cosine of psi; sine, cosine: those of theta */
    if (!axis) return;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(0, 0, 1);
    axis[1] = vmi_vec3(c, s, 0);
    axis[2] = vmi_vec3(sine * s, -sine * c, cosine);
}

/* Unit vectors of the axes about which Euler's angles turn the body, along body axes. The angular velocity is
   omega = psi' axis[0] + theta' axis[1] + phi' axis[2]. A call with a null pointer does nothing. */
VM_API void vm_euler_313_body_axes(vm_real theta, vm_real phi, vm_vec3 axis[3])
{
    vm_real s, c, sine, cosine; /* s, c: sine and cosine of phi; sine, cosine: those of theta */
    if (!axis) return;
    vmi_sincos(phi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    axis[0] = vmi_vec3(sine * s, sine * c, cosine);
    axis[1] = vmi_vec3(c, -s, 0);
    axis[2] = vmi_vec3(0, 0, 1);
}

/* Rates psi', theta', phi' of Euler's angles from an angular velocity in inertial axes, rad/s. Returns VM_BAD_ARGUMENT
   for a null pointer; VM_NOT_FINITE if an argument or a rate is infinite or NaN; VM_SINGULAR if sin(theta) is 0; VM_OK
   otherwise. For sin(theta) = 0 the angles psi and phi turn the body about the same axis, so that their rates are not
   unique. */
VM_API int vm_euler_313_rates(vm_real psi, vm_real theta, vm_vec3 omega, vm_real rates[3])
{
    vm_real s, c, sine, cosine, result[3]; /* s, c: sine and cosine of psi; sine, cosine: those of theta */
    if (!rates) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(psi) || !VM_IS_FINITE(theta) || !vmi_vec3_is_finite(omega)) return VM_NOT_FINITE;
    vmi_sincos(psi, &s, &c);
    vmi_sincos(theta, &sine, &cosine);
    if (sine == 0) return VM_SINGULAR;
    result[2] = (s * omega.x - c * omega.y) / sine;
    result[1] = c * omega.x + s * omega.y;
    result[0] = omega.z - result[2] * cosine;
    return vmi_copy_if_finite(3, result, rates);
}

#endif
