/* scenes/motions.h - how each kind of body moves */
#ifndef VARMASS_SCENES_MOTIONS_H
#define VARMASS_SCENES_MOTIONS_H

#include <string.h>

#include "../base/elementary.h"
#include "../base/linear.h"
#include "../base/real.h"
#include "../base/status.h"
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

/* A line and an axle: one coordinate */
VM_API int vmi_single_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    rates[0] = state[1];
    rates[1] = b->load.force[0] / (b->load.mass + b->load.extra);
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

/* Bodies. m, m/s, rad, rad/s; of an axle the inertia is about it, in the plane about the mass centre, kg m^2. A free
   body may be a rod, whose spin about itself then stays. */
VM_API vm_scene_body vm_scene_body_line(vm_real mass, vm_real x, vm_real v)
{
    vm_scene_body b = vmi_scene_body(VM_LINE, 1, 1);
    b.start.mass = mass;
    b.start.r.x = x;
    b.start.v.x = v;
    b.put = vmi_line_put;
    b.get = vmi_line_get;
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

/* Documented with vm_scene_body_line. */
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

VM_API int vmi_plane_check(const vm_body *start) { return start->inertia.zz > 0 ? VM_OK : VM_BAD_INERTIA; }

VM_API int vmi_plane_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[3 + i];
    for (i = 0; i < 2; i++) rates[3 + i] = b->load.force[i] / b->load.mass;
    rates[5] = b->load.force[2] / b->inertia.zz;
    return VM_OK;
}

VM_API void vmi_plane_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    (void)b;
    state[0] = now->r.x;
    state[1] = now->r.y;
    state[2] = angle;
    state[3] = now->v.x;
    state[4] = now->v.y;
    state[5] = now->omega.z;
}

VM_API void vmi_plane_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    (void)b;
    now->r.x = state[0];
    now->r.y = state[1];
    now->v.x = state[3];
    now->v.y = state[4];
    vmi_sincos(state[2] / 2, &now->q.z, &now->q.w);
    now->omega.z = state[5];
    now->inertia.xx = now->inertia.yy = now->inertia.zz / 2; /* of a lamina: any that is possible will do */
}

/* Documented with vm_scene_body_line. */
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
    b.accelerate = vmi_plane_accelerate;
    b.check = vmi_plane_check;
    return b;
}

VM_API int vmi_point_body_check(const vm_body *start)
{
    const vm_inertia *i = &start->inertia;
    const int none = i->xx == 0 && i->yy == 0 && i->zz == 0 && i->xy == 0 && i->xz == 0 && i->yz == 0;
    return none ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_point_body_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    int i;
    for (i = 0; i < 3; i++) rates[i] = state[b->positions + i];
    for (i = 0; i < 3; i++) rates[b->positions + i] = b->load.force[i] / b->load.mass;
    return VM_OK;
}

VM_API void vmi_point_body_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vm_real *v = state + b->positions;
    (void)angle;
    state[0] = now->r.x;
    state[1] = now->r.y;
    state[2] = now->r.z;
    v[0] = now->v.x;
    v[1] = now->v.y;
    v[2] = now->v.z;
}

VM_API void vmi_point_body_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    const vm_real *v = state + b->positions;
    now->r = vmi_vec3(state[0], state[1], state[2]);
    now->v = vmi_vec3(v[0], v[1], v[2]);
}

/* Documented with vm_scene_body_line. */
VM_API vm_scene_body vm_scene_body_point(vm_real mass, vm_vec3 r, vm_vec3 v)
{
    vm_scene_body b = vmi_scene_body(VM_POINT, 3, 3);
    b.start.mass = mass;
    b.start.r = r;
    b.start.v = v;
    b.put = vmi_point_body_put;
    b.get = vmi_point_body_get;
    b.accelerate = vmi_point_body_accelerate;
    b.check = vmi_point_body_check;
    return b;
}

VM_API vm_quat vmi_free_quat(const vm_real *state)
{
    vm_quat q;
    q.w = state[3];
    q.x = state[4];
    q.y = state[5];
    q.z = state[6];
    return q;
}

/* Euler's equations in body axes, and the quaternion's, whose length is drawn to 1 (as exp(-t)). About the null axis
   of a rod, which no load turns, the spin stays. */
VM_API int vmi_free_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_inertia *i = &b->filled;
    const vm_vec3 w = vmi_vec3(state[10], state[11], state[12]);
    const vm_quat q = vmi_free_quat(state);
    const vm_real *f = b->load.force, pull = (1 - (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)) / 2;
    const vmi_mat3 axes = vmi_rotation(q);
    const vm_vec3 torque = vmi_times_transposed(&axes, vmi_vec3(f[3], f[4], f[5]));
    const vm_vec3 h = vmi_sub(torque, vmi_cross(w, vmi_inertia_times(&b->inertia, w)));
    vm_quat spin, turn;
    vm_real a[9];
    spin.w = 0;
    spin.x = w.x / 2;
    spin.y = w.y / 2;
    spin.z = w.z / 2;
    turn = vmi_quat_times(q, spin);
    vmi_point_body_accelerate(b, state, rates);
    rates[3] = turn.w + pull * q.w;
    rates[4] = turn.x + pull * q.x;
    rates[5] = turn.y + pull * q.y;
    rates[6] = turn.z + pull * q.z;
    a[0] = i->xx;
    a[4] = i->yy;
    a[8] = i->zz;
    a[1] = a[3] = i->xy;
    a[2] = a[6] = i->xz;
    a[5] = a[7] = i->yz;
    rates[10] = h.x;
    rates[11] = h.y;
    rates[12] = h.z;
    return vmi_solve_linear(3, a, rates + 10) ? VM_BAD_INERTIA : VM_OK;
}

/* Euler's equations are solved with something about a null axis, too: it finds nothing to accelerate there */
VM_API vm_inertia vmi_free_filled(const vm_inertia *i)
{
    const vm_real trace = i->xx + i->yy + i->zz;
    vmi_principal p = vmi_principal_axes(i);
    int k, null_axes = 0;
    for (k = 0; k < 3; k++)
        if (!(p.moment[k] > vmi_slack(i))) {
            p.moment[k] = trace > 0 ? trace : 1;
            null_axes++;
        }
    return null_axes ? vmi_inertia_from(&p) : *i;
}

VM_API void vmi_free_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    const vmi_mat3 turn = vmi_rotation(now->q);
    const vm_vec3 omega = vmi_times_transposed(&turn, now->omega);
    b->filled = vmi_free_filled(&now->inertia);
    vmi_point_body_put(b, now, angle, state);
    state[3] = vmi_quat_is_none(now->q) ? 1 : now->q.w;
    state[4] = now->q.x;
    state[5] = now->q.y;
    state[6] = now->q.z;
    state[10] = omega.x;
    state[11] = omega.y;
    state[12] = omega.z;
}

VM_API void vmi_free_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    vmi_mat3 turn;
    vmi_point_body_get(b, state, now);
    now->q = vmi_free_quat(state);
    turn = vmi_rotation(now->q);
    now->omega = vmi_times(&turn, vmi_vec3(state[10], state[11], state[12]));
}

/* Documented with vm_scene_body_line. */
VM_API vm_scene_body vm_scene_body_free(const vm_body *start)
{
    vm_scene_body b = vmi_scene_body(VM_FREE, 7, 6);
    b.status = start ? VM_OK : VM_BAD_ARGUMENT;
    if (!start) return b;
    b.start = *start;
    b.put = vmi_free_put;
    b.get = vmi_free_get;
    b.accelerate = vmi_free_accelerate;
    b.check = vmi_check_body;
    return b;
}

/* the same, its mass a state */
VM_API vm_scene_body vm_scene_body_with_mass_state(vm_scene_body body)
{
    body.mass_is_state = 1;
    return body;
}

/* the same, not yet there */
VM_API vm_scene_body vm_scene_body_absent(vm_scene_body body)
{
    body.absent = 1;
    return body;
}

/* Numbers by coordinate as vectors: the part that moves the mass centre, the part that turns, inertial axes */
VM_API vm_vec3 vmi_scene_moving(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, 0);
    if (b->motion == VM_LINE) return vmi_vec3(a[0], 0, 0);
    return vmi_vec3(a[0], a[1], b->motion == VM_PLANE ? 0 : a[2]);
}

VM_API vm_vec3 vmi_scene_turning(const vm_scene_body *b, const vm_real *a)
{
    if (b->motion == VM_AXLE) return vmi_vec3(0, 0, a[0]);
    if (b->motion == VM_PLANE) return vmi_vec3(0, 0, a[2]);
    return b->motion == VM_FREE ? vmi_vec3(a[3], a[4], a[5]) : vmi_vec3(0, 0, 0);
}

VM_API vm_vec3 vmi_scene_spin(const vm_scene_body *b, const vm_real *y)
{
    const vm_vec3 w = vmi_scene_turning(b, y + b->at + b->positions);
    vmi_mat3 axes;
    if (b->motion != VM_FREE) return w;
    axes = vmi_rotation(vmi_free_quat(y + b->at));
    return vmi_times(&axes, w);
}

/* The way back: a += these */
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
