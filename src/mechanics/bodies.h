/* mechanics/bodies.h - bodies, their momentum, angular momentum and kinetic energy */
#ifndef VARMASS_MECHANICS_BODIES_H
#define VARMASS_MECHANICS_BODIES_H

#include "../base/real.h"
#include "../base/status.h"
#include "inertia.h"
#include "vectors.h"

typedef struct VM_TAG(vm_body) {
    vm_real mass;       /* kg */
    vm_inertia inertia; /* about the own mass centre, in body axes */
    vm_quat q;          /* turns body axes into inertial ones */
    vm_vec3 r, v;       /* mass centre (m) and momentum/mass (m/s), inertial axes */
    vm_vec3 omega;      /* rad/s, inertial axes */
} vm_body;

typedef struct VM_TAG(vm_impulse) {
    vm_vec3 linear; /* N s */
    vm_vec3 couple; /* N m s */
    vm_vec3 at;     /* the point at which linear acts, inertial axes */
} vm_impulse;

/* A body that moves in a plane */
typedef struct VM_TAG(vm_body2) {
    vm_real mass;    /* kg */
    vm_real inertia; /* kg m^2, about the axis through the own mass centre; 0 for a point */
    vm_real x, y;    /* mass centre, m */
    vm_real angle;   /* rad, anticlockwise */
    vm_real vx, vy;  /* momentum/mass, m/s */
    vm_real omega;   /* rad/s, anticlockwise */
} vm_body2;

typedef struct VM_TAG(vm_impulse2) {
    vm_real jx, jy; /* N s */
    vm_real couple; /* N m s, anticlockwise */
    vm_real x, y;   /* the point at which jx, jy act */
} vm_impulse2;

typedef struct VM_TAG(vm_balance) {
    vm_vec3 momentum;               /* after - before - impulse, N s: (6) with (20), (21) */
    vm_vec3 angular_momentum;       /* the same about the point, N m s: (12), (17) with (22) */
    vm_real momentum_scale;         /* sum of all M |v| and the impulse */
    /* sum of all tr(I) |omega| + (|r| + |r - about|) M |v|, and the same for the impulse. It contains |r| because a
       position is rounded by eps |r|, which changes the angular momentum by eps |r| M |v|, wherever the point is */
    vm_real angular_momentum_scale;
    vm_real energy;                 /* kinetic energy after - before, J: (94) - (93) */
} vm_balance;

VM_API vm_vec3 vmi_spin_momentum(const vm_body *body) /* I omega, inertial axes */
{
    vmi_mat3 m = vmi_rotation(body->q);
    return vmi_times(&m, vmi_inertia_times(&body->inertia, vmi_times_transposed(&m, body->omega)));
}

/* Momentum M v (1)-(3), N s; angular momentum I omega + (r - about) x M v (7)-(9), N m s, about any point; kinetic
   energy (93), (97), J. Not checked: NaN in, NaN out; NaN for a null pointer. */
VM_API vm_vec3 vm_momentum(const vm_body *body)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_scale(body->mass, body->v);
}

/* Documented with vm_momentum. */
VM_API vm_vec3 vm_angular_momentum(const vm_body *body, vm_vec3 about)
{
    if (!body) return vmi_vec3(VM_NAN, VM_NAN, VM_NAN);
    return vmi_add(vmi_spin_momentum(body), vmi_cross(vmi_sub(body->r, about), vm_momentum(body)));
}

/* Documented with vm_momentum. */
VM_API vm_real vm_kinetic_energy(const vm_body *body)
{
    if (!body) return VM_NAN;
    return (body->mass * vmi_dot(body->v, body->v) + vmi_dot(body->omega, vmi_spin_momentum(body))) / 2;
}

/* The plane's body with inertia.zz alone, which is all that motion in the plane asks for */
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

VM_API vm_vec3 vmi_impulse_moment(const vm_impulse *j, vm_vec3 about)
{
    return vmi_add(j->couple, vmi_cross(vmi_sub(j->at, about), j->linear));
}

VM_API int vmi_impulse_finite(const vm_impulse *j)
{
    return vmi_vec3_finite(j->linear) && vmi_vec3_finite(j->couple) && vmi_vec3_finite(j->at);
}

/* Add sign times the body's momenta and energy */
VM_API void vmi_balance_add(vm_balance *sum, vm_real sign, const vm_body *body, vm_vec3 about)
{
    vm_vec3 momentum = vm_momentum(body);
    vm_real size = vmi_norm2(momentum);
    sum->momentum = vmi_add(sum->momentum, vmi_scale(sign, momentum));
    sum->angular_momentum = vmi_add(sum->angular_momentum, vmi_scale(sign, vm_angular_momentum(body, about)));
    sum->momentum_scale += size;
    sum->angular_momentum_scale += vmi_trace(&body->inertia) * vmi_norm2(body->omega) +
                                   (vmi_norm2(body->r) + vmi_norm2(vmi_sub(body->r, about))) * size;
    sum->energy += sign * vm_kinetic_energy(body);
}

/* What is left of the balances of momentum and, about any point, of angular momentum between some bodies before and
   after an instant in which external, where not NULL, acted (4)-(6), (10)-(12): zero but for rounding errors, a few
   eps of the scales, where nothing was lost. Any number of bodies, none included, on either side.
   VM_BAD_ARGUMENT, VM_NOT_FINITE. */
VM_API int vm_balance_between(int n_before, const vm_body *before, int n_after, const vm_body *after,
                              const vm_impulse *external_or_NULL, vm_vec3 about, vm_balance *balance)
{
    vm_balance sum = {{0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    const vm_impulse *j = external_or_NULL;
    int i;
    if (!balance || n_before < 0 || n_after < 0 || (n_before > 0 && !before) || (n_after > 0 && !after))
        return VM_BAD_ARGUMENT;
    for (i = 0; i < n_before; i++) vmi_balance_add(&sum, -1, before + i, about);
    for (i = 0; i < n_after; i++) vmi_balance_add(&sum, 1, after + i, about);
    if (j) {
        vm_vec3 moment = vmi_impulse_moment(j, about);
        sum.momentum = vmi_sub(sum.momentum, j->linear);
        sum.angular_momentum = vmi_sub(sum.angular_momentum, moment);
        sum.momentum_scale += vmi_norm2(j->linear);
        sum.angular_momentum_scale +=
            vmi_norm1(j->couple) + (vmi_norm1(j->at) + vmi_norm1(vmi_sub(j->at, about))) * vmi_norm1(j->linear);
    }
    if (!VM_IS_FINITE(sum.energy) || !VM_IS_FINITE(sum.momentum_scale) ||
        !VM_IS_FINITE(sum.angular_momentum_scale) || !vmi_vec3_finite(sum.momentum) ||
        !vmi_vec3_finite(sum.angular_momentum))
        return VM_NOT_FINITE;
    *balance = sum;
    return VM_OK;
}

VM_API int vmi_body_finite(const vm_body *b)
{
    return VM_IS_FINITE(b->mass) && vmi_vec3_finite(b->r) && vmi_vec3_finite(b->v) && vmi_vec3_finite(b->omega) &&
           vmi_inertia_finite(&b->inertia) && VM_IS_FINITE(b->q.w) &&
           vmi_vec3_finite(vmi_vec3(b->q.x, b->q.y, b->q.z));
}

VM_API int vmi_check_body(const vm_body *b)
{
    if (!vmi_body_finite(b)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return vm_inertia_possible(&b->inertia) ? VM_OK : VM_BAD_INERTIA;
}

VM_API int vmi_check_body2(const vm_body2 *b)
{
    const vm_body lifted = vmi_body_to_space(b);
    if (!vmi_body_finite(&lifted) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->mass > 0)) return VM_BAD_MASS;
    return b->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* Bodies of space or of the plane, whichever pointer is not NULL */
typedef struct VM_TAG(vmi_bodies) {
    int n;
    const vm_body *in_space;
    const vm_body2 *in_plane;
} vmi_bodies;

VM_API vm_body vmi_list_body(const vmi_bodies *list, int i)
{
    return list->in_plane ? vmi_body_to_space(list->in_plane + i) : list->in_space[i];
}

VM_API int vmi_check_bodies(const vmi_bodies *list)
{
    int i, status = VM_OK;
    if (list->n < 0 || (list->n > 0 && !list->in_space && !list->in_plane)) return VM_BAD_ARGUMENT;
    for (i = 0; i < list->n && !status; i++)
        status = list->in_plane ? vmi_check_body2(list->in_plane + i) : vmi_check_body(list->in_space + i);
    return status;
}

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

#endif
