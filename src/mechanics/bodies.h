/* mechanics/bodies.h - bodies in space and in the plane, their momenta and energy before and after a jump
   A vm_body is a body at an instant: mass, inertia, attitude, position and motion. A vm_body2 is a body that moves in
   the plane. The equations (1)-(3), (7)-(9), (93), (97) of the dissertation [1] give momentum, angular momentum and
   kinetic energy, and (4)-(6), (10)-(12) compare them before and after a jump. bodies2.h has the plane's functions.

       vm_body wheel = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
       vm_vec3 origin = {0, 0, 0}, L = vm_angular_momentum(&wheel, origin); // L.z = 3 N m s

   Tests: tests/test_bodies.c. */
#ifndef VARMASS_MECHANICS_BODIES_H
#define VARMASS_MECHANICS_BODIES_H

#include "../base/real.h"
#include "../base/status.h"
#include "inertia.h"
#include "vectors.h"

/* A body at an instant */
typedef struct VM_TAG(vm_body) {
    vm_real mass;       /* mass > 0, kg */
    vm_inertia inertia; /* inertia about the body's own mass centre, kg m^2, body axes; all zero for a point */
    vm_quat q;          /* attitude: converts vectors from body to inertial axes; any length; all zero: identity */
    vm_vec3 r;          /* position of the mass centre, m, inertial axes */
    vm_vec3 v;          /* velocity, which is momentum/mass, m/s, inertial axes */
    vm_vec3 omega;      /* angular velocity, rad/s, inertial axes */
} vm_body;

/* An impulse that acts on a body at an instant. All vectors are in inertial axes. */
typedef struct VM_TAG(vm_impulse) {
    vm_vec3 linear; /* the impulse of forces, N s */
    vm_vec3 couple; /* an impulsive couple in addition to the moment of `linear`, N m s */
    vm_vec3 at;     /* the point at which `linear` acts, m */
} vm_impulse;

/* A body that moves in the plane, at an instant */
typedef struct VM_TAG(vm_body2) {
    vm_real mass;    /* mass > 0, kg */
    vm_real inertia; /* moment of inertia about the body's own mass centre, kg m^2; 0 for a point */
    vm_real x, y;    /* position of the mass centre, m */
    vm_real angle;   /* attitude, rad, anticlockwise */
    vm_real vx, vy;  /* velocity, which is momentum/mass, m/s */
    vm_real omega;   /* angular velocity, rad/s, anticlockwise */
} vm_body2;

/* An impulse that acts at an instant on a body that moves in the plane */
typedef struct VM_TAG(vm_impulse2) {
    vm_real jx, jy; /* the impulse of forces, N s */
    vm_real couple; /* an impulsive couple in addition to the moment of jx, jy, N m s, anticlockwise */
    vm_real x, y;   /* the point at which jx, jy act, m */
} vm_impulse2;

/* The balance of a jump: the total momentum, angular momentum and energy of the bodies after the jump, minus the
   totals of the bodies before the jump. The external impulse and its moment are also subtracted. Therefore the changes
   of momentum and angular momentum are zero, except for rounding errors, if the bodies obey the laws of mechanics. */
typedef struct VM_TAG(vm_balance) {
    vm_vec3 momentum;               /* change of momentum, N s: (6), (20), (21) */
    vm_vec3 angular_momentum;       /* change of angular momentum about a point, N m s: (12), (17), (22) */
    vm_real momentum_scale;         /* the sum of mass times speed over all bodies, plus the impulse's size, N s */
    /* The rounding error of angular_momentum is a few eps times this scale, N m s. The scale is the sum over all bodies
       of tr(I) |omega| + (|r| + |r - about|) M |v|, plus a term for the impulse. A body has the inertia I (trace
       tr(I)), the mass M, the position r, the velocity v and the angular velocity omega; `about` is the point of the
       moments. The term |r| M |v| belongs to the scale because r has the rounding error eps |r|. */
    vm_real angular_momentum_scale;
    vm_real energy;                 /* kinetic energy after minus before, J: (94) - (93) */
} vm_balance;

/* ---- momentum, angular momentum and kinetic energy ---- */

/* The angular momentum about its own mass centre, in inertial axes, that a body has if its angular velocity is omega */
VM_API vm_vec3 vmi_spin_momentum_at(const vm_body *body, vm_vec3 omega)
{
    const vmi_mat3 m = vmi_rotation(body->q);
    return vmi_times(&m, vmi_inertia_times(&body->inertia, vmi_times_transposed(&m, omega)));
}
VM_API vm_vec3 vmi_spin_momentum(const vm_body *body) { return vmi_spin_momentum_at(body, body->omega); }

/* Momentum of a body, mass times velocity, (1)-(3), N s. The body is not checked. The result is NaN for a null pointer,
   and if a field that the function uses is NaN. */
VM_API vm_vec3 vm_momentum(const vm_body *body)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vm_scale(body->mass, body->v);
}

/* Angular momentum of a body about the point `about` (7)-(9), N m s. It is I omega + (r - about) x M v in inertial
   axes, with the inertia I, the mass M and the cross product x. The body is not checked. The result is NaN for a null
   pointer, and if a field that the function uses is NaN. */
VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vm_add(vmi_spin_momentum(body), vm_cross(vm_sub(body->r, about), vm_momentum(body)));
}

/* Kinetic energy of a body (93), (97), J. It is (M v.v + omega.(I omega))/2, with the mass M and the inertia I. The
   body is not checked. The result is NaN for a null pointer, and if a field that the function uses is NaN. */
VM_API vm_real vm_kinetic_energy(const vm_body *body)
{
    if (!body) return VM_NAN;
    return (body->mass * vm_dot(body->v, body->v) + vm_dot(body->omega, vmi_spin_momentum(body))) / 2;
}

/* ---- conversion of bodies between the plane and space ---- */

/* Converts a body that moves in the plane to a body in space. The body axes of the result are parallel to the inertial
   axes. Only the entry zz of its inertia is set, because motion in the plane needs no other entry. */
VM_API vm_body vmi_body_to_space(const vm_body2 *body)
{
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = body->mass;
    b.inertia.zz = body->inertia;
    b.r = vmi_vec3(body->x, body->y, 0);
    b.v = vmi_vec3(body->vx, body->vy, 0);
    b.omega = vmi_vec3(0, 0, body->omega);
    return b;
}

/* Converts a body in space to a body in the plane with the given angle. Motion out of the plane is ignored. */
VM_API vm_body2 vmi_body_to_plane(const vm_body *b, vm_real angle)
{
    vm_body2 flat;
    flat.mass = b->mass;
    flat.inertia = b->inertia.zz;
    flat.angle = angle;
    flat.x = b->r.x;
    flat.y = b->r.y;
    flat.vx = b->v.x;
    flat.vy = b->v.y;
    flat.omega = b->omega.z;
    return flat;
}

/* ---- checks ---- */

VM_API int vmi_body_is_finite(const vm_body *b)
{
    return VM_IS_FINITE(b->mass) && vmi_vec3_is_finite(b->r) && vmi_vec3_is_finite(b->v) &&
           vmi_vec3_is_finite(b->omega) &&
           vmi_inertia_is_finite(&b->inertia) && vmi_quat_is_finite(b->q);
}

VM_API int vmi_body2_is_finite(const vm_body2 *b)
{
    return VM_IS_FINITE(b->mass) && VM_IS_FINITE(b->inertia) && vmi_vec3_is_finite(vmi_vec3(b->x, b->y, b->angle)) &&
           vmi_vec3_is_finite(vmi_vec3(b->vx, b->vy, b->omega));
}

VM_API int vmi_impulse_is_finite(const vm_impulse *j)
{
    return vmi_vec3_is_finite(j->linear) && vmi_vec3_is_finite(j->couple) && vmi_vec3_is_finite(j->at);
}

/* Checks a body in space. Returns VM_NOT_FINITE if a field is infinite or NaN; VM_BAD_MASS if the mass is not positive;
   VM_BAD_INERTIA if no body can have the inertia; else VM_OK. */
VM_API int vmi_check_body(const vm_body *b)
{
    if (!vmi_body_is_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return vm_inertia_is_possible(&b->inertia) ? VM_OK : VM_BAD_INERTIA;
}

/* Checks a body that moves in the plane. Returns VM_NOT_FINITE if a field is infinite or NaN; VM_BAD_MASS if the mass
   is not positive; VM_BAD_INERTIA if the inertia is negative; else VM_OK. */
VM_API int vmi_check_body2(const vm_body2 *b)
{
    if (!vmi_body2_is_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return b->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* An array of n bodies, which are either all in space or all in the plane. The other of the two pointers is NULL. */
typedef struct VM_TAG(vmi_bodies) {
    int n;
    const vm_body *in_space;
    const vm_body2 *in_plane;
} vmi_bodies;

VM_API vmi_bodies vmi_bodies_in_space(int n, const vm_body *bodies)
{
    vmi_bodies list;
    list.n = n;
    list.in_space = bodies;
    list.in_plane = NULL;
    return list;
}

VM_API vmi_bodies vmi_bodies_in_plane(int n, const vm_body2 *bodies)
{
    vmi_bodies list;
    list.n = n;
    list.in_space = NULL;
    list.in_plane = bodies;
    return list;
}

/* Body number i of the list, as a body in space */
VM_API vm_body vmi_list_body(const vmi_bodies *list, int i)
{
    if (list->in_plane) return vmi_body_to_space(list->in_plane + i);
    return list->in_space[i];
}

/* Returns VM_OK if all bodies of the list are valid, else the error of one of them (vmi_first_error). Returns
   VM_BAD_ARGUMENT if n, the number of bodies, is negative, and if n > 0 while both pointers are NULL. */
VM_API int vmi_check_bodies(const vmi_bodies *list)
{
    int i, status = VM_OK;
    if (list->n < 0 || (list->n > 0 && !list->in_space && !list->in_plane)) return VM_BAD_ARGUMENT;
    for (i = 0; i < list->n; i++) {
        if (list->in_plane) status = vmi_first_error(status, vmi_check_body2(list->in_plane + i));
        else status = vmi_first_error(status, vmi_check_body(list->in_space + i));
    }
    return status;
}

/* ---- balances ---- */

/* The moment of an impulse about the point `about`, N m s */
VM_API vm_vec3 vmi_impulse_moment(const vm_impulse *j, vm_vec3 about)
{
    return vm_add(j->couple, vm_cross(vm_sub(j->at, about), j->linear));
}

/* Adds a body to a balance (sign 1) or subtracts it (sign -1). Adds the sizes of its momenta to the two scales. */
VM_API void vmi_balance_add(vm_balance *sum, vm_real sign, const vm_body *body, vm_vec3 about)
{
    const vm_vec3 momentum = vm_momentum(body);
    const vm_real size = vm_norm(momentum);
    sum->momentum = vm_add(sum->momentum, vm_scale(sign, momentum));
    sum->angular_momentum = vm_add(sum->angular_momentum, vm_scale(sign, vm_angular_momentum(body, about)));
    sum->momentum_scale += size;
    sum->angular_momentum_scale += vmi_inertia_trace(&body->inertia) * vm_norm(body->omega) +
                                   (vm_norm(body->r) + vm_norm(vm_sub(body->r, about))) * size;
    sum->energy += sign * vm_kinetic_energy(body);
}

/* Subtracts an impulse and its moment from a balance. Adds their absolute values to the two scales. */
VM_API void vmi_balance_take_impulse(vm_balance *sum, const vm_impulse *j, vm_vec3 about)
{
    sum->momentum = vm_sub(sum->momentum, j->linear);
    sum->angular_momentum = vm_sub(sum->angular_momentum, vmi_impulse_moment(j, about));
    sum->momentum_scale += vm_norm(j->linear);
    sum->angular_momentum_scale +=
        vmi_norm1(j->couple) + (vmi_norm1(j->at) + vmi_norm1(vm_sub(j->at, about))) * vmi_norm1(j->linear);
}

VM_API int vmi_balance_is_finite(const vm_balance *b)
{
    return VM_IS_FINITE(b->energy) && VM_IS_FINITE(b->momentum_scale) && VM_IS_FINITE(b->angular_momentum_scale) &&
           vmi_vec3_is_finite(b->momentum) && vmi_vec3_is_finite(b->angular_momentum);
}

/* Balance of momentum, angular momentum and energy before and after a jump. *balance gets the sums over the n_after
   bodies after the jump, minus the sums over the n_before bodies before the jump, minus the impulse, (4)-(6),
   (10)-(12). If the motions obey the laws of mechanics, the changes of momentum and of angular momentum about any
   point are zero except for rounding errors, which are a few eps times momentum_scale and angular_momentum_scale.
   Either number of bodies may be 0. The bodies are not checked. Returns VM_BAD_ARGUMENT for a null pointer or a
   negative number of bodies, VM_NOT_FINITE if a sum is not finite, and VM_OK otherwise. */
VM_API int vm_balance_between(int n_before, const vm_body *before, int n_after, const vm_body *after,
                              const vm_impulse *external_or_NULL, vm_vec3 about, vm_balance *balance)
{
    vm_balance sum = {{0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    int i;
    if (!balance || n_before < 0 || n_after < 0 || (n_before > 0 && !before) || (n_after > 0 && !after))
        return VM_BAD_ARGUMENT;
    for (i = 0; i < n_before; i++) vmi_balance_add(&sum, -1, before + i, about);
    for (i = 0; i < n_after; i++) vmi_balance_add(&sum, 1, after + i, about);
    if (external_or_NULL) vmi_balance_take_impulse(&sum, external_or_NULL, about);
    if (!vmi_balance_is_finite(&sum)) return VM_NOT_FINITE;
    *balance = sum;
    return VM_OK;
}

#endif
