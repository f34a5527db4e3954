/* mechanics/broken_rotor.h - a rotor from which a piece breaks off: equations of motion and the break

   The rotor is a disc on a massless elastic shaft and moves in a plane. A torque drives it, and its rotation is damped
   viscously (section 3.3.2 of the dissertation [1]). Before the break the shaft passes through the rotor's mass centre
   (s = 0). After the break the shaft's centre is at the distance s from the mass centre of the remainder. This chapter
   has the equations of motion (46), (65)-(68) of [1], their polar form (75), and the equations of the break (52)-(64),
   corrected as in docs/errata.md. The motion in closed form is in mechanics/broken_rotor_motion.h, and the stability
   of the remainder's steady motion is in mechanics/broken_rotor_stability.h.

       vm_broken_rotor whole = {2, 1, 20, 1, 3, 0}; // the fields in their order below
       vm_broken_rotor_piece piece = {VM_C(0.1), VM_C(0.001), VM_C(0.5), 0, VM_C(0.6), 0};
       vm_broken_rotor_break result;
       vm_real y[VM_BROKEN_ROTOR_STATES] = {VM_C(0.01), 0, 0, 0, 0, 3};
       int status = vm_broken_rotor_break_off(&whole, y, &piece, &result); // result.rest starts from result.state

   Tests: tests/test_broken_rotor.c. */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_H

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/hypot.h"
#include "../base/real.h"
#include "../base/status.h"

/* The rotor. The formulas use these abbreviations (67) of its fields: omega^2 = stiffness/mass, p^2 = mass/inertia,
   k* = damping/inertia, M* = torque/inertia. A prime ' means the derivative with respect to time: psi' = dpsi/dt. */
typedef struct VM_TAG(vm_broken_rotor) {
    vm_real mass;      /* mass M > 0, kg */
    vm_real inertia;   /* inertia I > 0 about the rotor's own mass centre, kg m^2 */
    vm_real stiffness; /* stiffness c >= 0 of the shaft, N/m */
    vm_real damping;   /* damping k, N m s: at the angular velocity psi' the torque -k psi' acts on the rotor */
    vm_real torque;    /* driving torque, N m */
    vm_real s;         /* distance from the mass centre to the shaft's centre, m. The vector from the mass centre to
                          the shaft's centre points in the direction of the rotor's angle psi. */
} vm_broken_rotor;

/* Indices of the states of a rotor in the array y, and the number of states */
enum {
    VM_BROKEN_ROTOR_X = 0,     /* position x, y of the mass centre, measured from the shaft's rest position, m */
    VM_BROKEN_ROTOR_ANGLE = 2, /* angle psi of the rotor, counterclockwise from the x axis, rad */
    VM_BROKEN_ROTOR_V = 3,     /* velocity x', y' of the mass centre, m/s */
    VM_BROKEN_ROTOR_OMEGA = 5, /* angular velocity psi', rad/s */
    VM_BROKEN_ROTOR_STATES = 6
};

/* Indices of the states in polar form. The angle psi and its rate psi' have the indices VM_BROKEN_ROTOR_ANGLE and
   VM_BROKEN_ROTOR_OMEGA in this form, too. */
enum {
    VM_BROKEN_ROTOR_RADIUS = 0,        /* distance r > 0 from the shaft's rest position to the mass centre, m */
    VM_BROKEN_ROTOR_DIRECTION = 1,     /* angle phi of the vector from this position to the mass centre, rad */
    VM_BROKEN_ROTOR_RADIUS_RATE = 3,   /* rate r' of the distance, m/s */
    VM_BROKEN_ROTOR_DIRECTION_RATE = 4 /* rate phi' of the angle phi, rad/s */
};

/* The piece that breaks off. S is the mass centre of the whole rotor, S2 the mass centre of the piece, and A the point
   at which the whole rotor touches the stator. SS2 is the vector from S to S2, and SA the vector from S to A. */
typedef struct VM_TAG(vm_broken_rotor_piece) {
    vm_real mass;     /* mass m of the piece, kg; 0 < m < M, where M is the mass of the whole */
    vm_real inertia;  /* inertia I_S2 >= 0 of the piece about its mass centre S2, kg m^2 */
    vm_real distance; /* length of SS2, m */
    vm_real alpha;    /* angle from SS2 counterclockwise to SA, rad (Fig. 17) */
    vm_real radius;   /* length of SA, called R in the formulas, m */
    vm_real contact;  /* angle from the inertial x axis counterclockwise to SA, rad */
} vm_broken_rotor_piece;

/* The result of the break, (52)-(64) as corrected in docs/errata.md. S, S2 and A are the points of
   vm_broken_rotor_piece, and S1 is the mass centre of the remainder. M and I_S are the mass and the inertia of the
   whole, m and I_S2 those of the piece, and I_S1 is the inertia of the remainder. The dissertation [1] assumes in (57)
   that the point A of the piece keeps its velocity, and that the component of S2's velocity perpendicular to S2A
   becomes zero. Everything else follows from the conservation of momentum and angular momentum. */
typedef struct VM_TAG(vm_broken_rotor_break) {
    vm_broken_rotor rest; /* the remainder, with its own mass, inertia and s = m SS2/(M - m); its stiffness, damping
                             and torque are those of the whole */
    /* The state of the remainder just after the break. The remainder's angle psi is the angle of SS2, because the line
       from S1 to the shaft's centre is parallel to SS2. The remainder's angular velocity is spin_rest plus the angular
       velocity Omega_b of the whole before the break [(59), (64) corrected]. */
    vm_real state[VM_BROKEN_ROTOR_STATES];
    vm_real piece[VM_BROKEN_ROTOR_STATES]; /* state of the piece; its angle psi is that of the remainder */
    vm_real dragging;                      /* speed v_S2d of S2, the piece's mass centre, before the break (52), m/s */
    vm_real gamma;                         /* angle from SA to the velocity of S2 before the break (52), (60), rad. This
                                              velocity is the velocity of S plus Omega_b x SS2. */
    vm_real beta;                          /* angle from SA to S2A, rad [(56) corrected], with
                                              tan beta = SS2 sin alpha/(R - SS2 cos alpha), where
                                              SS2 and R are the lengths `distance` and `radius` */
    vm_real normal;                        /* component N along S2A of the velocity of S2 before the break (54), m/s */
    vm_real tangential;                    /* component T = v_S2d sin(gamma - beta), perpendicular to S2A, of the
                                              velocity of S2 before the break, m/s. T > 0 means counterclockwise; (55)
                                              has the opposite sign. */
    vm_real spin_piece;                    /* Omega_r = T/AS2 (57), (63), the angular velocity of the piece after the
                                              break minus that of the whole before the break, rad/s; AS2 is the
                                              distance of A from S2 */
    vm_real spin_rest;                     /* Omega_r1, the angular velocity of the remainder after the break minus
                                              that of the whole before the break, rad/s. I_S1 Omega_r1 is m M/(M - m)
                                              times the cross product SS2 x v_T, minus I_S2 Omega_r. v_T is the part of
                                              the velocity of S2 perpendicular to S2A [(58) corrected]. */
    vm_real stop_inertia;                  /* If the piece had this inertia I_S2, kg m^2, the remainder would not turn
                                              after the break. If the value is < 0 or not finite, no such inertia
                                              exists; nor if it is so large that the remainder would have no positive
                                              inertia. If alpha = 0 and the velocity of S is along SA or 0, the value
                                              is I_S (R - SS2)/R [after (64), corrected]. */
} vm_broken_rotor_break;

/* Returns VM_OK if all fields of the rotor are finite and have the signs that vm_broken_rotor demands, else the
   error. */
VM_API int vmi_check_broken_rotor(const vm_broken_rotor *r)
{
    if (!VM_IS_FINITE(r->mass) || !VM_IS_FINITE(r->inertia) || !VM_IS_FINITE(r->stiffness) ||
        !VM_IS_FINITE(r->damping) || !VM_IS_FINITE(r->torque) || !VM_IS_FINITE(r->s))
        return VM_NOT_FINITE;
    if (!(r->mass > 0)) return VM_BAD_MASS;
    if (!(r->stiffness >= 0)) return VM_BAD_STIFFNESS;
    if (!(r->inertia > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Right-hand side of the rotor's equations of motion, (65), (66), (68), (46).
   Its type is ode_rhs, so that integrators such as rk45 can call it. The state y has VM_BROKEN_ROTOR_STATES numbers.
   `rotor` must point to a vm_broken_rotor. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if a field of the
   rotor is infinite or NaN; VM_BAD_MASS or VM_BAD_INERTIA if the mass or the inertia of the rotor is not positive;
   VM_BAD_STIFFNESS if the stiffness is negative; else 0. */
VM_API int vm_broken_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    const vm_real omega = y[VM_BROKEN_ROTOR_OMEGA];
    const int status = vmi_check_broken_rotor(r);
    vm_real sine, cosine, fx, fy; /* fx, fy: the force (66) of the shaft on the rotor, N */
    (void)t;
    if (status) return status;
    vmi_sincos(y[VM_BROKEN_ROTOR_ANGLE], &sine, &cosine);
    fx = -r->stiffness * (y[VM_BROKEN_ROTOR_X] + r->s * cosine);
    fy = -r->stiffness * (y[VM_BROKEN_ROTOR_X + 1] + r->s * sine);
    dydt[VM_BROKEN_ROTOR_X] = y[VM_BROKEN_ROTOR_V];
    dydt[VM_BROKEN_ROTOR_X + 1] = y[VM_BROKEN_ROTOR_V + 1];
    dydt[VM_BROKEN_ROTOR_ANGLE] = omega;
    dydt[VM_BROKEN_ROTOR_V] = fx / r->mass;
    dydt[VM_BROKEN_ROTOR_V + 1] = fy / r->mass;
    dydt[VM_BROKEN_ROTOR_OMEGA] = (r->torque - r->damping * omega + r->s * (cosine * fy - sine * fx)) / r->inertia;
    return 0;
}

/* Right-hand side of the rotor's equations of motion in polar form (75).
   Its type is ode_rhs. The state y has the VM_BROKEN_ROTOR_STATES numbers {r, phi, psi, r', phi', psi'}. `rotor` must
   point to a vm_broken_rotor. Returns VM_NOT_FINITE if r is NaN; VM_DOMAIN, which ends the run, if r is not positive;
   else a status of vm_broken_rotor_rhs. */
VM_API int vm_broken_rotor_polar_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    const vm_real w2 = r->stiffness / r->mass, radius = y[VM_BROKEN_ROTOR_RADIUS], omega = y[VM_BROKEN_ROTOR_OMEGA];
    const vm_real radius_rate = y[VM_BROKEN_ROTOR_RADIUS_RATE], rate = y[VM_BROKEN_ROTOR_DIRECTION_RATE];
    const int status = vmi_check_broken_rotor(r);
    vm_real sine, cosine;
    (void)t;
    if (radius != radius) return VM_NOT_FINITE;
    if (status) return status;
    if (!(radius > 0)) return VM_DOMAIN;
    vmi_sincos(y[VM_BROKEN_ROTOR_DIRECTION] - y[VM_BROKEN_ROTOR_ANGLE], &sine, &cosine);
    dydt[VM_BROKEN_ROTOR_RADIUS] = radius_rate;
    dydt[VM_BROKEN_ROTOR_DIRECTION] = rate;
    dydt[VM_BROKEN_ROTOR_ANGLE] = omega;
    dydt[VM_BROKEN_ROTOR_RADIUS_RATE] = radius * (rate * rate) - w2 * (radius + r->s * cosine);
    dydt[VM_BROKEN_ROTOR_DIRECTION_RATE] = (r->s * w2 * sine - 2 * radius_rate * rate) / radius;
    dydt[VM_BROKEN_ROTOR_OMEGA] =
        (r->torque - r->damping * omega - r->s * r->stiffness * radius * sine) / r->inertia;
    return 0;
}

/* Converts the state {x, y, psi, x', y', psi'} of a rotor to its polar state.
   The polar state is {r, phi, psi, r', phi', psi'}. `y` and `polar` may be the same array. Returns VM_BAD_ARGUMENT for
   a null pointer; VM_NOT_FINITE if a number of y or of the result is infinite or NaN; VM_DOMAIN if r is 0; VM_OK
   otherwise. */
VM_API int vm_broken_rotor_to_polar(const vm_real *y, vm_real *polar)
{
    vm_real p[VM_BROKEN_ROTOR_STATES], x0, y0, vx, vy, radius, c, s;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, y)) return VM_NOT_FINITE;
    x0 = y[VM_BROKEN_ROTOR_X];
    y0 = y[VM_BROKEN_ROTOR_X + 1];
    vx = y[VM_BROKEN_ROTOR_V];
    vy = y[VM_BROKEN_ROTOR_V + 1];
    radius = vmi_hypot(x0, y0);
    if (!(radius > 0)) return VM_DOMAIN;
    c = x0 / radius;
    s = y0 / radius;
    p[VM_BROKEN_ROTOR_RADIUS] = radius;
    p[VM_BROKEN_ROTOR_DIRECTION] = vmi_atan2(y0, x0);
    p[VM_BROKEN_ROTOR_ANGLE] = y[VM_BROKEN_ROTOR_ANGLE];
    p[VM_BROKEN_ROTOR_RADIUS_RATE] = c * vx + s * vy;
    p[VM_BROKEN_ROTOR_DIRECTION_RATE] = (c * vy - s * vx) / radius;
    p[VM_BROKEN_ROTOR_OMEGA] = y[VM_BROKEN_ROTOR_OMEGA];
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_STATES, p, polar);
}

/* Converts the polar state {r, phi, psi, r', phi', psi'} of a rotor to {x, y, psi, x', y', psi'}.
   `y` and `polar` may be the same array. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if a number of
   `polar` or of the result is infinite or NaN; VM_DOMAIN if r is not positive; VM_OK otherwise. */
VM_API int vm_broken_rotor_from_polar(const vm_real *polar, vm_real *y)
{
    vm_real z[VM_BROKEN_ROTOR_STATES], radius, along, across, c, s; /* along, across: the velocities r' and r phi' */
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, polar)) return VM_NOT_FINITE;
    radius = polar[VM_BROKEN_ROTOR_RADIUS];
    if (!(radius > 0)) return VM_DOMAIN;
    vmi_sincos(polar[VM_BROKEN_ROTOR_DIRECTION], &s, &c);
    along = polar[VM_BROKEN_ROTOR_RADIUS_RATE];
    across = radius * polar[VM_BROKEN_ROTOR_DIRECTION_RATE];
    z[VM_BROKEN_ROTOR_X] = radius * c;
    z[VM_BROKEN_ROTOR_X + 1] = radius * s;
    z[VM_BROKEN_ROTOR_ANGLE] = polar[VM_BROKEN_ROTOR_ANGLE];
    z[VM_BROKEN_ROTOR_V] = along * c - across * s;
    z[VM_BROKEN_ROTOR_V + 1] = along * s + across * c;
    z[VM_BROKEN_ROTOR_OMEGA] = polar[VM_BROKEN_ROTOR_OMEGA];
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_STATES, z, y);
}

VM_API int vmi_broken_rotor_piece_finite(const vm_broken_rotor_piece *p)
{
    return VM_IS_FINITE(p->mass) && VM_IS_FINITE(p->inertia) && VM_IS_FINITE(p->distance) &&
           VM_IS_FINITE(p->alpha) && VM_IS_FINITE(p->radius) && VM_IS_FINITE(p->contact);
}

/* Returns VM_OK if the arguments of vm_broken_rotor_break_off are valid, else the error. */
VM_API int vmi_broken_rotor_check_break(const vm_broken_rotor *whole, const vm_real *before,
                                        const vm_broken_rotor_piece *p)
{
    int status = vmi_check_broken_rotor(whole);
    if (status == VM_NOT_FINITE) return status;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, before) || !vmi_broken_rotor_piece_finite(p)) return VM_NOT_FINITE;
    if (!(p->mass > 0 && p->mass < whole->mass)) return VM_BAD_MASS;
    if (status) return status;
    if (!(p->inertia >= 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* A vector of the plane */
typedef struct VM_TAG(vmi_broken_rotor_vector) {
    vm_real x, y;
} vmi_broken_rotor_vector;

/* The vector a, turned by the angle whose sine and cosine are the first two arguments */
VM_API vmi_broken_rotor_vector vmi_broken_rotor_turned(vm_real sine, vm_real cosine, vmi_broken_rotor_vector a)
{
    vmi_broken_rotor_vector b;
    b.x = cosine * a.x - sine * a.y;
    b.y = sine * a.x + cosine * a.y;
    return b;
}

/* Sets `state` to the state of the piece, or of the remainder, just after the break. The state of the whole before the
   break is `before`. The body (piece or remainder) has the angle psi, and the vector from S, the mass centre of the
   whole, to the body's mass centre is (dx, dy). The break changes the velocity of the body's mass centre by (ux, uy)
   and the angular velocity by `spin`. */
VM_API void vmi_broken_rotor_moved(const vm_real *before, vm_real psi, vm_real dx, vm_real dy, vm_real ux, vm_real uy,
                                   vm_real spin, vm_real *state)
{
    const vm_real omega = before[VM_BROKEN_ROTOR_OMEGA];
    state[VM_BROKEN_ROTOR_X] = before[VM_BROKEN_ROTOR_X] + dx;
    state[VM_BROKEN_ROTOR_X + 1] = before[VM_BROKEN_ROTOR_X + 1] + dy;
    state[VM_BROKEN_ROTOR_ANGLE] = psi;
    state[VM_BROKEN_ROTOR_V] = before[VM_BROKEN_ROTOR_V] - omega * dy + ux;
    state[VM_BROKEN_ROTOR_V + 1] = before[VM_BROKEN_ROTOR_V + 1] + omega * dx + uy;
    state[VM_BROKEN_ROTOR_OMEGA] = omega + spin;
}

/* Sets the fields of the remainder *rest, among them mass, inertia and s. Returns VM_BAD_INERTIA if the inertia of the
   remainder is negative or not larger than rounding errors, else VM_OK. */
VM_API int vmi_broken_rotor_rest(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_broken_rotor *rest)
{
    const vm_real lost = 8 * VM_EPSILON, left = whole->mass - p->mass, share = p->mass / left;
    *rest = *whole;
    rest->mass = left;
    rest->inertia = (whole->inertia - p->inertia) - share * whole->mass * (p->distance * p->distance);
    rest->s = share * p->distance;
    if (!(rest->inertia > lost * whole->inertia)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Sets the fields of *b from `dragging` to `stop_inertia`, (52)-(58), and *e, the unit vector along S2A. Returns the
   distance AS2. The points S, S2 and A are explained at vm_broken_rotor_piece. The arguments are d, the vector SS2; v,
   the velocity of S before the break; and `spin`, the angular velocity of the whole before the break. All vectors have
   an x axis along SA and a y axis 90 degrees counterclockwise from it. */
VM_API vm_real vmi_broken_rotor_contact(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_real spin,
                                        vmi_broken_rotor_vector d, vmi_broken_rotor_vector v,
                                        vmi_broken_rotor_vector *e, vm_broken_rotor_break *b)
{
    const vm_real ux = v.x - spin * d.y, uy = v.y + spin * d.x; /* velocity of S2 before the break */
    const vm_real reduced = p->mass / b->rest.mass * whole->mass; /* m M/(M - m) in (58) */
    const vm_real reach_x = p->radius - d.x, reach_y = -d.y, reach = vmi_hypot(reach_x, reach_y);
    vm_real moment; /* cross product SS2 x v_T, where v_T is the part of S2's velocity perpendicular to S2A */
    e->x = reach_x / reach;
    e->y = reach_y / reach;
    b->dragging = vmi_hypot(ux, uy);
    b->gamma = vmi_atan2(uy, ux);
    b->beta = vmi_atan2(reach_y, reach_x);
    b->normal = ux * e->x + uy * e->y;
    b->tangential = uy * e->x - ux * e->y;
    moment = b->tangential * (d.x * e->x + d.y * e->y);
    b->spin_piece = b->tangential / reach;
    b->spin_rest = (reduced * moment - p->inertia * b->spin_piece) / b->rest.inertia;
    b->stop_inertia = (whole->inertia * spin + reduced * (moment - p->distance * p->distance * spin)) /
                      (spin + b->spin_piece);
    return reach;
}

/* Remainder and piece of a rotor after the break, with their motions, (52)-(64) corrected.
   `before` is the state of the whole just before the break. Returns
   - VM_BAD_ARGUMENT for a null pointer;
   - VM_NOT_FINITE if an argument, or a field of *result other than stop_inertia, is infinite or NaN;
   - VM_BAD_MASS if the mass of the piece is not between 0 and the mass of the whole;
   - VM_BAD_STIFFNESS if the stiffness is negative;
   - VM_BAD_INERTIA if the inertia of the whole is not positive, if the inertia of the piece is negative, or if the
     inertia of the remainder is negative or not larger than rounding errors;
   - VM_DOMAIN if the whole has s != 0, or if the piece's mass centre is at the point of contact A;
   - VM_OK otherwise. */
VM_API int vm_broken_rotor_break_off(const vm_broken_rotor *whole, const vm_real *before,
                                     const vm_broken_rotor_piece *piece, vm_broken_rotor_break *result)
{
    vm_broken_rotor_break b;
    vmi_broken_rotor_vector d, v, e;
    vm_real sine, cosine, share, T, psi;
    int status;
    if (!whole || !before || !piece || !result) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_check_break(whole, before, piece);
    if (!status) status = vmi_broken_rotor_rest(whole, piece, &b.rest);
    if (!status && whole->s != 0) status = VM_DOMAIN;
    if (status) return status;

    vmi_sincos(piece->alpha, &sine, &cosine);
    d.x = piece->distance * cosine;
    d.y = -piece->distance * sine;
    vmi_sincos(piece->contact, &sine, &cosine);
    v.x = before[VM_BROKEN_ROTOR_V];
    v.y = before[VM_BROKEN_ROTOR_V + 1];
    v = vmi_broken_rotor_turned(-sine, cosine, v);
    if (!(vmi_broken_rotor_contact(whole, piece, before[VM_BROKEN_ROTOR_OMEGA], d, v, &e, &b) > 0)) return VM_DOMAIN;

    d = vmi_broken_rotor_turned(sine, cosine, d);
    e = vmi_broken_rotor_turned(sine, cosine, e);
    share = piece->mass / b.rest.mass;
    T = b.tangential;
    psi = piece->contact - piece->alpha;
    vmi_broken_rotor_moved(before, psi, d.x, d.y, T * e.y, -T * e.x, b.spin_piece, b.piece);
    vmi_broken_rotor_moved(before, psi, -share * d.x, -share * d.y, -share * T * e.y, share * T * e.x, b.spin_rest,
                           b.state);
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, b.state) || !vmi_all_finite(VM_BROKEN_ROTOR_STATES, b.piece))
        return VM_NOT_FINITE;
    if (!VM_IS_FINITE(b.dragging) || !VM_IS_FINITE(b.normal)) return VM_NOT_FINITE; /* these may be infinite although
                                                                                       the states are finite */
    *result = b;
    return VM_OK;
}

#endif
