/* scenes/motions.h - the bodies of a scene, and how each of them moves

   A body moves along a line, about an axle, in the plane, as a point in space, or free in space, with rotation. The
   arguments of its constructor are its motion at the start, in SI units. Each kind of motion has up to five functions:
   `put` writes the motion of a body into the state, `get` reads it from the state, `accelerate` computes the
   derivatives of the state from the load, `shift` adds to the field `centre` the step by which a jump has moved the
   mass centre, so that the points of the body stay where they are, and `check` refuses an inertia that the body cannot
   have. A line has no function `check`, an axle neither `check` nor `shift`.

       vm_vec3 zero = {0, 0, 0};
       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0),                              // 2 kg at x = 0.1 m
                                 vm_scene_body_axle(0.5, 0, 30),                             // 0.5 kg m^2 at 30 rad/s
                                 vm_scene_body_absent(vm_scene_body_point(1, zero, zero))};  // an event brings it in

   The constructors only check whether a pointer is NULL. Other errors are found by vm_scene_check and vm_scene_start:
   they return VM_BAD_MASS if a mass is not positive, VM_BAD_INERTIA if the body cannot have its inertia, and
   VM_NOT_FINITE if a number is not finite.

   Tests: tests/test_scene_bodies.c. */
#ifndef VARMASS_SCENES_MOTIONS_H
#define VARMASS_SCENES_MOTIONS_H

#include <string.h>

#include "../base/elementary.h"
#include "../base/linear.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/attitude.h"
#include "../mechanics/bodies.h"
#include "../mechanics/inertia.h"
#include "../mechanics/vectors.h"
#include "scene.h"

VM_API vm_scene_body vmi_scene_body(int motion, int positions, int coordinates)
{
    vm_scene_body b;
    memset(&b, 0, sizeof b);
    b.motion = motion;
    b.positions = positions;
    b.coordinates = coordinates;
    return b;
}

/* -- One coordinate: a line and an axle -- */

/* Computes the acceleration x'' = force/(mass + extra_mass) along the only coordinate of the body */
VM_API int vmi_single_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    rates[0] = state[1];
    rates[1] = b->load.force[0] / (b->load.mass + b->load.extra_mass);
    return VM_OK;
}

VM_API void vmi_line_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    (void)angle;
    state[0] = now->r.x;
    state[1] = now->v.x;
}

VM_API void vmi_line_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[0];
    now->v.x = state[1];
}

VM_API void vmi_line_shift(vm_scene_body *b, vm_vec3 step, const vm_real *state)
{
    (void)state;
    b->centre = vm_add(b->centre, step);
}

/* A body on a line. mass is in kg, the position x in m, the velocity v in m/s. */
VM_API vm_scene_body vm_scene_body_line(vm_real mass, vm_real x, vm_real v)
{
    vm_scene_body b = vmi_scene_body(VM_LINE, 1, 1);
    b.start.mass = mass;
    b.start.r.x = x;
    b.start.v.x = v;
    b.put = vmi_line_put;
    b.get = vmi_line_get;
    b.shift = vmi_line_shift;
    b.accelerate = vmi_single_accelerate;
    return b;
}

VM_API void vmi_axle_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[0] = angle;
    state[1] = now->omega.z;
}

VM_API void vmi_axle_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->omega.z = state[1];
    now->inertia.zz = now->mass;
}

/* A body on a fixed axle. inertia is the moment of inertia about the axle in kg m^2; angle is in rad, omega in
   rad/s. */
VM_API vm_scene_body vm_scene_body_axle(vm_real inertia, vm_real angle, vm_real omega)
{
    vm_scene_body b = vmi_scene_body(VM_AXLE, 1, 1);
    b.start.mass = inertia;
    b.start.omega.z = omega;
    b.angle = angle;
    b.put = vmi_axle_put;
    b.get = vmi_axle_get;
    b.accelerate = vmi_single_accelerate;
    return b;
}

/* -- The plane -- */

enum { VMI_PLANE_X, VMI_PLANE_Y, VMI_PLANE_ANGLE, VMI_PLANE_VX, VMI_PLANE_VY, VMI_PLANE_OMEGA }; /* indices in state */

VM_API int vmi_plane_check(const vm_body *start) { return start->inertia.zz > 0 ? VM_OK : VM_BAD_INERTIA; }

VM_API int vmi_plane_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[3 + i];
    rates[VMI_PLANE_VX] = b->load.force[0] / b->load.mass;
    rates[VMI_PLANE_VY] = b->load.force[1] / b->load.mass;
    rates[VMI_PLANE_OMEGA] = b->load.force[2] / b->inertia.zz;
    return VM_OK;
}

VM_API void vmi_plane_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[VMI_PLANE_X] = now->r.x;
    state[VMI_PLANE_Y] = now->r.y;
    state[VMI_PLANE_ANGLE] = angle;
    state[VMI_PLANE_VX] = now->v.x;
    state[VMI_PLANE_VY] = now->v.y;
    state[VMI_PLANE_OMEGA] = now->omega.z;
}

/* Reads the motion of a body in the plane. This motion does not depend on the moments of inertia about x and y. Both
   are set to zz/2, as for a thin plate, so that a body with this inertia can exist. */
VM_API void vmi_plane_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[VMI_PLANE_X];
    now->r.y = state[VMI_PLANE_Y];
    now->v.x = state[VMI_PLANE_VX];
    now->v.y = state[VMI_PLANE_VY];
    vmi_sincos(state[VMI_PLANE_ANGLE] / 2, &now->q.z, &now->q.w);
    now->omega.z = state[VMI_PLANE_OMEGA];
    now->inertia.xx = now->inertia.yy = now->inertia.zz / 2;
}

VM_API void vmi_plane_shift(vm_scene_body *b, vm_vec3 step, const vm_real *state)
{
    vm_real s, c;
    vmi_sincos(state[VMI_PLANE_ANGLE], &s, &c);
    b->centre.x += c * step.x + s * step.y;
    b->centre.y += c * step.y - s * step.x;
}

/* A body in the plane. mass is in kg, the moment of inertia about the mass centre in kg m^2 (> 0), the position r in m,
   the angle in rad (anticlockwise), the velocity v in m/s, omega in rad/s. r.z and v.z have no effect. */
VM_API vm_scene_body vm_scene_body_plane(vm_real mass, vm_real inertia, vm_vec3 r, vm_real angle, vm_vec3 v,
                                    vm_real omega)
{
    vm_scene_body b = vmi_scene_body(VM_PLANE, 3, 3);
    b.start.mass = mass;
    b.start.inertia.zz = inertia;
    b.start.r = r;
    b.start.v = v;
    b.start.omega.z = omega;
    b.angle = angle;
    b.start.r.z = b.start.v.z = 0;
    b.put = vmi_plane_put;
    b.get = vmi_plane_get;
    b.shift = vmi_plane_shift;
    b.accelerate = vmi_plane_accelerate;
    b.check = vmi_plane_check;
    return b;
}

/* -- A point in space -- */

VM_API int vmi_point_body_check(const vm_body *start)
{
    const vm_inertia *i = &start->inertia;
    const int none = i->xx == 0 && i->yy == 0 && i->zz == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    if (none) return VM_OK;
    return VM_BAD_INERTIA;
}

/* Computes the rates of position r and velocity v of a point or of a free body. The state of a point is {r, v}. The
   state of a free body is {r, q, v, ...} with the quaternion q, whose rate vmi_free_accelerate computes. */
VM_API int vmi_point_body_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[b->positions + i];
    for (i = 0; i < 3; i++) rates[b->positions + i] = b->load.force[i] / b->load.mass;
    return VM_OK;
}

VM_API void vmi_point_body_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)angle;
    vmi_set3(state, now->r);
    vmi_set3(state + b->positions, now->v);
}

VM_API void vmi_point_body_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->r = vmi_get3(state);
    now->v = vmi_get3(state + b->positions);
}

/* A point in space. mass is in kg, the position r in m, the velocity v in m/s. */
VM_API vm_scene_body vm_scene_body_point(vm_real mass, vm_vec3 r, vm_vec3 v)
{
    vm_scene_body b = vmi_scene_body(VM_POINT, 3, 3);
    b.start.mass = mass;
    b.start.r = r;
    b.start.v = v;
    b.put = vmi_point_body_put;
    b.get = vmi_point_body_get;
    b.shift = vmi_line_shift;
    b.accelerate = vmi_point_body_accelerate;
    b.check = vmi_point_body_check;
    return b;
}

/* -- A free body in space -- */

enum { VMI_FREE_R = 0, VMI_FREE_Q = 3, VMI_FREE_V = 7, VMI_FREE_OMEGA = 10 }; /* indices in state; omega: body axes */

/* Solves Euler's equations I omega' = torque - omega x I omega for omega', where I is the inertia of the body. omega
   and omega' (`rates`) are in body axes, torque in inertial axes. The matrix of these linear equations is
   b->invertible. For a rod it includes a dummy moment about the axis of the rod (vmi_invertible_inertia), so that the
   equations can be solved. The spin of a rod about its own axis stays constant if no effect exerts a torque about this
   axis. Such a torque (of vm_effect_rotational_damper or vm_effect_custom) acts on the dummy moment, so that the change
   of the spin has no physical meaning. */
VM_API int vmi_free_euler(const vm_scene_body *b, const vmi_mat3 *axes, vm_vec3 torque, vm_vec3 omega, vm_real *rates)
{
    const vm_inertia *i = &b->invertible;
    const vm_vec3 own = vmi_times_transposed(axes, torque);
    vm_real a[9];
    vmi_set3(rates, vm_sub(own, vm_cross(omega, vmi_inertia_times(&b->inertia, omega))));
    a[0] = i->xx;
    a[4] = i->yy;
    a[8] = i->zz;
    a[1] = a[3] = i->xy;
    a[2] = a[6] = i->xz;
    a[5] = a[7] = i->yz;
    if (vmi_solve_linear(3, a, rates)) return VM_BAD_INERTIA;
    return VM_OK;
}

VM_API int vmi_free_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_quat q = vmi_get_quat(state + VMI_FREE_Q);
    const vm_vec3 omega = vmi_get3(state + VMI_FREE_OMEGA);
    const vmi_mat3 axes = vmi_rotation(q);
    vmi_point_body_accelerate(b, state, rates);
    vmi_attitude_rates(q, vmi_quat_square(q), omega, rates + VMI_FREE_Q);
    return vmi_free_euler(b, &axes, vmi_get3(b->load.force + 3), omega, rates + VMI_FREE_OMEGA);
}

/* Returns the inertia with a dummy moment (an arbitrary number > 0) about each principal axis without moment of
   inertia, so that the matrix can be inverted. If no torque acts about such an axis, the dummy moment has no effect on
   the motion. */
VM_API vm_inertia vmi_invertible_inertia(const vm_inertia *i)
{
    const vm_real trace = i->xx + i->yy + i->zz, dummy = trace > 0 ? trace : 1;
    vmi_principal p = vmi_principal_axes(i);
    int k, null_axes = 0;
    for (k = 0; k < 3; k++)
        if (!(p.moment[k] > vmi_inertia_slack(i))) {
            p.moment[k] = dummy;
            null_axes++;
        }
    if (null_axes > 0) return vmi_inertia_from(&p);
    return *i;
}

/* Writes the motion of a free body into the state. The quaternion gets the length 1, because its errors are judged by
   the absolute tolerance of the integrator. */
VM_API void vmi_free_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    const vmi_mat3 axes = vmi_rotation(now->q);
    const vm_quat q = vm_unit_quat(now->q);
    b->invertible = vmi_invertible_inertia(&now->inertia);
    vmi_point_body_put(b, now, angle, state);
    state[VMI_FREE_Q] = q.w;
    state[VMI_FREE_Q + 1] = q.x;
    state[VMI_FREE_Q + 2] = q.y;
    state[VMI_FREE_Q + 3] = q.z;
    vmi_set3(state + VMI_FREE_OMEGA, vmi_times_transposed(&axes, now->omega));
}

VM_API void vmi_free_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    vmi_mat3 axes;
    vmi_point_body_get(b, state, now);
    now->q = vmi_get_quat(state + VMI_FREE_Q);
    axes = vmi_rotation(now->q);
    now->omega = vmi_times(&axes, vmi_get3(state + VMI_FREE_OMEGA));
}

VM_API void vmi_free_shift(vm_scene_body *b, vm_vec3 step, const vm_real *state)
{
    const vmi_mat3 axes = vmi_rotation(vmi_get_quat(state + VMI_FREE_Q));
    b->centre = vm_add(b->centre, vmi_times_transposed(&axes, step));
}

/* A body that moves and turns freely in space. *start is its motion at the start. The body may be a rod; its spin about
   its own axis then stays constant. (Only vm_effect_rotational_damper and vm_effect_custom can exert a torque about
   this axis; a rod has no inertia about it, and the spin that they cause has no physical meaning.) vm_scene_start
   returns VM_BAD_ARGUMENT if start is NULL. */
VM_API vm_scene_body vm_scene_body_free(const vm_body *start)
{
    vm_scene_body b = vmi_scene_body(VM_FREE, 7, 6);
    b.status = start ? VM_OK : VM_BAD_ARGUMENT;
    if (!start) return b;
    b.start = *start;
    b.put = vmi_free_put;
    b.get = vmi_free_get;
    b.shift = vmi_free_shift;
    b.accelerate = vmi_free_accelerate;
    b.check = vmi_check_body;
    return b;
}

/* -- Any body -- */

/* Returns a body like `body`, but with a mass that is a number of the state, so that streams can change the mass. */
VM_API vm_scene_body vm_scene_body_with_mass_state(vm_scene_body body)
{
    body.mass_is_state = 1;
    return body;
}

/* Returns a body like `body` that is not present until an event brings it into the scene. Effects on the body do not
   act before this event. When a part separates and becomes this body, the body has the mass of the part; the mass of
   the argument `body` is then not used, but must be positive. */
VM_API vm_scene_body vm_scene_body_absent(vm_scene_body body)
{
    body.absent = 1;
    return body;
}

/* The number of coordinates along which the mass resists acceleration: those of the mass centre. On an axle the number
   is 1, because the moment of inertia resists the acceleration of the angle. */
VM_INLINE int vmi_scene_directions(int motion)
{
    if (motion <= VM_AXLE) return 1;
    return motion == VM_PLANE ? 2 : 3;
}

/* The array a has a number for each coordinate, for example its velocity or the force on it. Returns the numbers that
   belong to the mass centre, as a vector in inertial axes. */
VM_API vm_vec3 vmi_scene_moving(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, 0);
    if (b->motion == VM_LINE) return vmi_vec3(a[0], 0, 0);
    if (b->motion == VM_PLANE) return vmi_vec3(a[0], a[1], 0);
    return vmi_get3(a);
}

/* The array a has a number for each coordinate, for example its velocity or the torque on it. Returns the numbers that
   belong to the rotation of the body, as a vector in the same axes as in the array. */
VM_API vm_vec3 vmi_scene_turning(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, a[0]);
    if (b->motion == VM_PLANE) return vmi_vec3(0, 0, a[2]);
    if (b->motion == VM_FREE) return vmi_get3(a + 3);
    return vmi_vec3(0, 0, 0);
}

/* The angular velocity of a body in inertial axes */
VM_API vm_vec3 vmi_scene_spin(const vm_scene_body *b, const vm_real *y)
{
    const vm_vec3 omega = vmi_scene_turning(b, y + b->at + b->positions);
    vmi_mat3 axes;
    if (b->motion != VM_FREE) return omega;
    axes = vmi_rotation(vmi_get_quat(y + b->at + VMI_FREE_Q));
    return vmi_times(&axes, omega);
}

/* The array a has a number for each coordinate. Adds the vector `moving` to the numbers that belong to the mass
   centre, and the vector `turning` to the numbers that belong to the rotation. vmi_scene_moving and vmi_scene_turning
   read these numbers. */
VM_API void vmi_scene_add(const vm_scene_body *b, vm_real *a, vm_vec3 moving, vm_vec3 turning)
{
    if (b->motion == VM_AXLE) {
        a[0] += turning.z;
        return;
    }
    a[0] += moving.x;
    a[1] += moving.y;
    a[2] += b->motion == VM_PLANE ? turning.z : moving.z;
    if (b->motion == VM_FREE) {
        a[3] += turning.x;
        a[4] += turning.y;
        a[5] += turning.z;
    }
}

#endif
