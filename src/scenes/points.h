/* scenes/points.h - points of the bodies of a scene

   Springs, joints and contacts act at points of bodies. A point of a body is given by a vector in body axes. The
   vector leads from the place that the mass centre has in the body at the start to the point. The point moves and
   turns with the body. A body on an axle turns about the z axis. The vector of one of its points leads from the
   origin, through which the axle goes. In the plane the third component of the vector is a height above the plane. A
   point of the ground is given by its position. A body that is itself a point has only one point, which is given by
   the zero vector. A rod, which has no moment of inertia about its own axis, has only the points on this axis. For any
   other point of a rod or of a body that is a point the status is VM_BAD_POINT.

       vm_vec3 tip = {0.5, 0, 0}, r, v;
       vm_scene_point_at(&scene, 0, tip, y, &r, &v); // position and velocity of a point of body 0 in the state y

   If you write an effect of your own (vm_effect_custom), add a force at a point by vm_scene_push_at.

   Tests: tests/test_scene_joints.c. */
#ifndef VARMASS_SCENES_POINTS_H
#define VARMASS_SCENES_POINTS_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/attitude.h"
#include "../mechanics/inertia.h"
#include "../mechanics/vectors.h"
#include "check.h"
#include "growing.h"
#include "motions.h"
#include "scene.h"

/* Position and velocity of a point of a body or of the ground, and the rotation of the body */
typedef struct VM_TAG(vmi_body_point) {
    vm_vec3 arm;   /* m, inertial axes: vector from the mass centre (on an axle from the axle) to the point */
    vm_vec3 r;     /* m: position of the point */
    vm_vec3 v;     /* m/s: velocity of the point */
    vm_vec3 omega; /* rad/s, inertial axes: angular velocity of the body */
    vmi_mat3 axes; /* the body axes in inertial axes */
} vmi_body_point;

/* The body axes of a body in the given state, as unit vectors in inertial axes */
VM_API vmi_mat3 vmi_point_axes(const vm_scene_body *b, const vm_real *state)
{
    vmi_mat3 axes;
    vm_real s = 0, c = 1;
    if (b->motion == VM_FREE) return vmi_rotation(vmi_get_quat(state + VMI_FREE_Q));
    if (b->motion == VM_PLANE) vmi_sincos(state[VMI_PLANE_ANGLE], &s, &c);
    if (b->motion == VM_AXLE) vmi_sincos(state[0], &s, &c);
    axes.x = vmi_vec3(c, s, 0);
    axes.y = vmi_vec3(-s, c, 0);
    axes.z = vmi_vec3(0, 0, 1);
    return axes;
}

/* Computes the position and the velocity of the point `at` of a body. The velocity is that of the material at the
   point, except for a growing body of which a stream has a store. For a growing body the velocity v in the state is
   momentum/mass. If no stream has a store, v is the velocity of the material at the present mass centre. If a stream
   has one, v differs from this velocity by M' (at - store)/M (the field `slip` of vmi_stream_seen), which this function
   leaves out. */
VM_API void vmi_point_of_body(const vm_scene_body *b, vm_vec3 at, const vm_real *state, vmi_body_point *p)
{
    const vm_real *rates = state + b->positions;
    p->axes = vmi_point_axes(b, state);
    p->omega = vmi_scene_turning(b, rates);
    if (b->motion == VM_FREE) p->omega = vmi_times(&p->axes, p->omega);
    p->arm = vmi_times(&p->axes, vm_sub(at, b->grows ? vmi_growth_centre(b, state) : b->centre));
    p->r = vm_add(vmi_scene_moving(b, state), p->arm);
    p->v = vm_add(vmi_scene_moving(b, rates), vm_cross(p->omega, p->arm));
}

/* Computes a point of a body in the state y of the scene, or a point of the ground, which is at rest */
VM_API void vmi_point_now(const vm_scene *s, int body, vm_vec3 at, const vm_real *y, vmi_body_point *p)
{
    const vm_vec3 zero = {0, 0, 0};
    if (body >= 0) {
        vmi_point_of_body(s->bodies + body, at, y + s->bodies[body].at, p);
        return;
    }
    p->arm = p->v = p->omega = zero;
    p->r = at;
    p->axes.x = vmi_vec3(1, 0, 0);
    p->axes.y = vmi_vec3(0, 1, 0);
    p->axes.z = vmi_vec3(0, 0, 1);
}

/* Adds the force f at a point of a body to the load of the body */
VM_API void vmi_point_push(vm_scene_body *b, const vmi_body_point *p, vm_vec3 f)
{
    if (b->motion == VM_LINE) b->load.force[0] += f.x;
    else vmi_scene_add(b, b->load.force, f, vm_cross(p->arm, f));
}

/* The mass (on an axle the moment of inertia) that resists acceleration, with the extra_mass of a mass law M(v) */
VM_INLINE vm_real vmi_point_mass(const vm_scene_body *b)
{
    if (b->motion > VM_AXLE) return b->load.mass;
    return b->load.mass + b->load.extra_mass;
}

/* The acceleration of the mass centre that a force causes */
VM_API vm_vec3 vmi_point_move(const vm_scene_body *b, vm_vec3 force)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, 0);
    if (b->motion == VM_LINE) force.y = 0;
    if (b->motion == VM_LINE || b->motion == VM_PLANE) force.z = 0;
    return vmi_over(force, vmi_point_mass(b));
}

/* The angular acceleration I^-1 (torque - omega x I omega) of a body, in inertial axes. I is the inertia of the body;
   for a free body it is that of the last evaluation of the loads. */
VM_API vm_vec3 vmi_point_spin(const vm_scene_body *b, const vmi_mat3 *axes, vm_vec3 torque, vm_vec3 omega)
{
    vm_real rates[3];
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, torque.z / vmi_point_mass(b));
    if (b->motion == VM_PLANE) return vmi_vec3(0, 0, torque.z / b->inertia.zz);
    if (b->motion != VM_FREE) return vmi_vec3(0, 0, 0);
    if (vmi_free_euler(b, axes, torque, vmi_times_transposed(axes, omega), rates)) return vmi_vec3(VM_NAN, 0, 0);
    return vmi_times(axes, vmi_get3(rates));
}

/* Gives a body an impulse at a point: changes the velocities of the body in the state y of the scene. Returns
   VM_NOT_FINITE, and changes nothing, if a velocity would be infinite or NaN; VM_OK otherwise. */
VM_API int vmi_point_kick(const vm_scene_body *b, const vmi_body_point *p, vm_vec3 impulse, vm_real *y)
{
    const vm_vec3 zero = {0, 0, 0}, move = vmi_point_move(b, impulse);
    const size_t size = (size_t)b->coordinates * sizeof *y;
    vm_vec3 spin = vmi_point_spin(b, &p->axes, vm_cross(p->arm, impulse), zero);
    vm_real *velocities = y + b->at + b->positions, kicked[6];
    memcpy(kicked, velocities, size);
    if (b->motion == VM_FREE) spin = vmi_times_transposed(&p->axes, spin);
    if (b->motion == VM_LINE) kicked[0] += move.x;
    else vmi_scene_add(b, kicked, move, spin);
    if (!vmi_all_finite(b->coordinates, kicked)) return VM_NOT_FINITE;
    memcpy(velocities, kicked, size);
    return VM_OK;
}

/* Returns the acceleration of a point in the direction of the unit vector `along` if a force of 1 N in this direction
   acts on the point */
VM_API vm_real vmi_point_mobility(const vm_scene_body *b, const vmi_body_point *p, vm_vec3 along)
{
    const vm_vec3 zero = {0, 0, 0}, turn = vm_cross(p->arm, along);
    return vm_dot(along, vmi_point_move(b, along)) + vm_dot(turn, vmi_point_spin(b, &p->axes, turn, zero));
}

/* Returns 1 if the inertia of a body resists every force at the point `at`, else 0. A force at this point can turn the
   body about any axis normal to `at`. If the body is a rod or a point, it has no moment of inertia about k of its
   principal axes. `hollow` is the inertia that vmi_invertible_inertia adds: the same moment `dummy` about each of
   these k axes. The point is possible only if `at` is parallel to each of these axes: the components of `at` normal to
   them must be 0. The sum of the squares of these components is k at^2 - at (hollow at)/dummy, and must be 0 apart
   from rounding errors. */
VM_API int vmi_point_is_possible(const vm_scene_body *b, vm_vec3 at)
{
    const vm_real noise = 64 * VM_EPSILON;
    vm_inertia whole, hollow;
    vm_real trace, square;
    if (b->motion == VM_POINT) return at.x == 0 && at.y == 0 && at.z == 0;
    if (b->motion != VM_FREE) return 1;
    whole = vmi_invertible_inertia(&b->start.inertia);
    hollow = vmi_inertia_plus(whole, -1, b->start.inertia);
    trace = hollow.xx + hollow.yy + hollow.zz;
    square = vm_dot(at, at);
    return trace * square - vm_dot(at, vmi_inertia_times(&hollow, at)) <= noise * (trace * square);
}

/* Checks a point of a body or of the ground. The bodies must have been checked before. */
VM_API int vmi_point_check(const vm_scene *s, int body, vm_vec3 at)
{
    if (!vmi_vec3_is_finite(at)) return VM_NOT_FINITE;
    if (body == VM_GROUND) return VM_OK;
    if (vmi_scene_check_coordinate(s, body, 0)) return VM_NO_SUCH_BODY;
    return vmi_point_is_possible(s->bodies + body, at) ? VM_OK : VM_BAD_POINT;
}

/* The position and velocity of a point of a body in the state y, in inertial axes. `at` is a vector in body axes. It
   leads to the point from the place that the mass centre has in the body at the start; on an axle it leads from the
   origin. The scene must have been started. *r is in m and *v in m/s; both are NaN if no body has this index, if scene
   or y is NULL, or if the scene was not started. If r or v is NULL, nothing is written. *v is the velocity of the
   material at the point, except for a growing body of which a stream has a store. Inside such a body mass flows from
   the store to the point `at` of the stream; *v then lacks the velocity M' (at - store)/M, where M is the mass of the
   body and M' the rate of the stream. */
VM_API void vm_scene_point_at(const vm_scene *scene, int body, vm_vec3 at, const vm_real *y, vm_vec3 *r, vm_vec3 *v)
{
    vmi_body_point p;
    if (!r || !v) return;
    *r = *v = vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    if (!scene || !scene->bodies || !scene->size || !y || body < 0 || body >= scene->n_bodies) return;
    vmi_point_now(scene, body, at, y, &p);
    *r = p.r;
    *v = p.v;
}

/* Adds a force at a point of a body. Call this function from the function that you give to vm_effect_custom; drag,
   wind and thrusters then need only a few lines of code. vm_scene_push_at adds the force, in N and inertial axes, and
   its moment about the mass centre to the load of the body. The arguments `at` and y are those of vm_scene_point_at. A
   force on VM_GROUND changes nothing. If no body has this index, scene->status becomes VM_NO_SUCH_BODY, which ends the
   run; if y is NULL or the scene was not started, scene->status becomes VM_BAD_ARGUMENT. If scene is NULL, nothing is
   done. */
VM_API void vm_scene_push_at(vm_scene *scene, int body, vm_vec3 at, const vm_real *y, vm_vec3 force)
{
    vmi_body_point p;
    if (!scene || body == VM_GROUND) return;
    if (!scene->bodies || !scene->size || !y) scene->status = VM_BAD_ARGUMENT;
    else if (body < 0 || body >= scene->n_bodies) scene->status = VM_NO_SUCH_BODY;
    else {
        vmi_point_now(scene, body, at, y, &p);
        vmi_point_push(scene->bodies + body, &p, force);
    }
}

#endif
