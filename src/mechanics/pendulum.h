/* mechanics/pendulum.h - a pendulum from which a part is cut

   This is the example of the equations (119)-(132) of the dissertation [1], corrected as in docs/errata.md. A uniform
   rod of mass M and length L swings about its end O. A part at its free end, of length l and mass m = M l/L, is cut
   off. The part leaves with a given velocity and angular velocity relative to the rod. The results are the motions,
   energies and momenta of the part and of the remaining rod, and the impulse of the pivot.

       vm_pendulum rod = {3, 1, VM_C(0.5), 2, VM_AXES_COS_SIN}; // 3 kg, 1 m, 0.5 rad, 2 rad/s
       vm_pendulum_cut cut;
       int status = vm_pendulum_separate(&rod, VM_C(0.25), 0, 0, 1, &cut); // 0.25 m leaves at 1 m/s along y

   vm_compound_pendulum_separate computes these results for a pendulum of any shape. The functions of axle.h compute
   them for a body on any axle in space.
   Tests: tests/test_pendulum.c. */
#ifndef VARMASS_MECHANICS_PENDULUM_H
#define VARMASS_MECHANICS_PENDULUM_H

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"

/* How the angle of a pendulum is measured */
enum {
    VM_AXES_COS_SIN = 0, /* the rod lies along (cos phi, sin phi), so that its angle phi is counted counterclockwise
                            from the x axis; the formulas (122), (125), (132) need this choice */
    VM_AXES_SIN_COS = 1  /* the rod lies along (sin phi, cos phi) (123): phi is counted clockwise from the y axis */
};

/* A uniform rod that swings about its end O, the origin */
typedef struct VM_TAG(vm_pendulum) {
    vm_real mass;   /* mass M > 0, kg */
    vm_real length; /* length L > 0, m */
    vm_real angle;  /* angle phi, rad */
    vm_real rate;   /* angular velocity phi', rad/s */
    int axes;       /* VM_AXES_COS_SIN or VM_AXES_SIN_COS */
} vm_pendulum;

/* The pendulum and the part after the cut. S1 and S2 are the mass centres of the remaining rod (the field `rest`) and
   of the part. */
typedef struct VM_TAG(vm_pendulum_cut) {
    vm_pendulum rest; /* the remaining rod; rest.rate is its angular velocity phi1' after the cut (125) */
    vm_real mass;     /* mass m of the part, kg */
    vm_real x, y;     /* position of the part's mass centre S2 (123), m */
    vm_real vx, vy;   /* velocity of the part's mass centre S2 (121), m/s */
    vm_real rate;     /* angular velocity of the part: phi' of the rod before the cut plus Omega, rad/s */
    vm_real T1;       /* kinetic energy of the whole rod before the cut (119), J */
    vm_real T_S1;     /* kinetic energy of the remaining rod after the cut (124), J */
    vm_real T_S2;     /* kinetic energy of the part after the cut, J [(122) corrected] */
    /* The angular momenta L1 and L2 are positive in the direction in which the angle phi grows. */
    vm_real L1;       /* angular momentum of the remaining rod about its end O after the cut (130), kg m^2/s */
    vm_real L2;       /* angular momentum of the part about the same point O, kg m^2/s [(128) corrected] */
    vm_real pivot_x;  /* impulse of the pivot on the remaining rod during the cut, along x, N s */
    vm_real pivot_y;  /* impulse of the pivot on the remaining rod during the cut, along y, N s */
} vm_pendulum_cut;

VM_API int vmi_check_pendulum(const vm_pendulum *p, vm_real part)
{
    if (p->axes != VM_AXES_COS_SIN && p->axes != VM_AXES_SIN_COS) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->length) || !VM_IS_FINITE(p->angle) || !VM_IS_FINITE(p->rate) ||
        !VM_IS_FINITE(part))
        return VM_NOT_FINITE;
    if (!(p->mass > 0)) return VM_BAD_MASS;
    if (!(part > 0 && part < p->length)) return VM_DOMAIN;
    return VM_OK;
}

/* Unit vectors of a pendulum: e = (ex, ey) points from O along the rod. f = (fx, fy) is orthogonal to e and points in
   the direction in which the angle grows. */
VM_API void vmi_pendulum_directions(const vm_pendulum *p, vm_real *ex, vm_real *ey, vm_real *fx, vm_real *fy)
{
    if (p->axes == VM_AXES_COS_SIN) {
        vmi_sincos(p->angle, ey, ex);
        *fx = -*ey;
        *fy = *ex;
    } else {
        vmi_sincos(p->angle, ex, ey);
        *fx = *ey;
        *fy = -*ex;
    }
}

VM_API int vmi_pendulum_cut_finite(const vm_pendulum_cut *c)
{
    return VM_IS_FINITE(c->rest.rate) && VM_IS_FINITE(c->vx) && VM_IS_FINITE(c->vy) && VM_IS_FINITE(c->T1) &&
           VM_IS_FINITE(c->L1) && VM_IS_FINITE(c->L2) && VM_IS_FINITE(c->T_S1) && VM_IS_FINITE(c->T_S2) &&
           VM_IS_FINITE(c->pivot_x) && VM_IS_FINITE(c->pivot_y);
}

/* Motion of a pendulum, and of the part that is cut off from it, after the cut, (119)-(132).
   `part` is the length l of the part (m), 0 < l < L. Omega (rad/s) is the angular velocity of the part relative to the
   rod, positive in the direction in which the pendulum's angle phi grows. (ux, uy) (m/s) is the velocity of the part's
   mass centre S2 relative to the rod, along the axes x and y. Let rho = L - l/2 be the distance from O to S2. Let
   `across` be the component of (ux, uy) that is orthogonal to the rod, positive in the direction in which phi grows.
   The angular velocities phi' of the rod before the cut and phi1' of the remaining rod after the cut obey
     phi1' = phi' - l/(L - l)^3 (l^2 Omega/4 + 3 rho across).
   This formula is the corrected form of (125) and (132), rearranged so that digits cancel only if Omega and `across`
   have opposite signs. Returns VM_BAD_ARGUMENT for a null pointer and for an unknown value of the field `axes`;
   VM_NOT_FINITE if an argument or the result is infinite or NaN; VM_BAD_MASS if the mass is not positive; VM_DOMAIN if
   l is not between 0 and L; VM_OK otherwise. */
VM_API int vm_pendulum_separate(const vm_pendulum *pendulum, vm_real part, vm_real Omega, vm_real ux, vm_real uy,
                                vm_pendulum_cut *cut)
{
    vm_pendulum_cut c;
    vm_real ex, ey, fx, fy, rho, left, ratio, rest_mass, across, change;
    int status;
    if (!pendulum || !cut) return VM_BAD_ARGUMENT;
    status = vmi_check_pendulum(pendulum, part);
    if (!VM_IS_FINITE(Omega) || !VM_IS_FINITE(ux) || !VM_IS_FINITE(uy)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    vmi_pendulum_directions(pendulum, &ex, &ey, &fx, &fy);
    rho = pendulum->length - part / 2; /* distance from O to the part's mass centre S2 */
    left = pendulum->length - part;
    rest_mass = pendulum->mass * (left / pendulum->length);
    across = ux * fx + uy * fy; /* component of the relative velocity orthogonal to the rod */
    ratio = part / left; /* with it no power of a length is computed, which could underflow */
    change = -ratio * (ratio * part * Omega / 4 + 3 * (rho / left) * across) / left;

    c.rest = *pendulum;
    c.rest.mass = rest_mass;
    c.rest.length = left;
    c.rest.rate = pendulum->rate + change;
    c.mass = pendulum->mass * (part / pendulum->length);
    c.x = rho * ex;
    c.y = rho * ey;
    c.vx = pendulum->rate * rho * fx + ux;
    c.vy = pendulum->rate * rho * fy + uy;
    c.rate = pendulum->rate + Omega;
    c.L1 = rest_mass * left * c.rest.rate * left / 3;
    c.L2 = c.mass * (part * (part * c.rate) / 12 + rho * (rho * pendulum->rate + across));
    c.T1 = pendulum->mass * (pendulum->length * pendulum->rate) * (pendulum->length * pendulum->rate) / 6;
    c.T_S1 = c.L1 * c.rest.rate / 2;
    c.T_S2 = c.mass * ((c.vx * c.vx + c.vy * c.vy) / 2 + part * c.rate * (part * c.rate) / 24);
    c.pivot_x = rest_mass * left / 2 * change * fx + c.mass * ux; /* total momentum after the cut minus before it */
    c.pivot_y = rest_mass * left / 2 * change * fy + c.mass * uy;
    if (!vmi_pendulum_cut_finite(&c)) return VM_NOT_FINITE;
    *cut = c;
    return VM_OK;
}

/* ---- A pendulum that is not uniform ---- */

/* A body of any shape that swings in the plane about the fixed point O, the origin: a compound pendulum */
typedef struct VM_TAG(vm_compound_pendulum) {
    vm_real mass;    /* mass M > 0, kg */
    vm_real inertia; /* moment of inertia about O, kg m^2, >= M times the square of the distance from O to S */
    vm_real x, y;    /* position of the mass centre S, m */
    vm_real rate;    /* angular velocity phi', rad/s, anticlockwise */
} vm_compound_pendulum;

/* The part that is cut off from a compound pendulum */
typedef struct VM_TAG(vm_compound_part) {
    vm_real mass;    /* mass m > 0, kg */
    vm_real inertia; /* moment of inertia about the part's own mass centre S2, kg m^2, >= 0 */
    vm_real x, y;    /* position of S2, m */
    vm_real ux, uy;  /* velocity of S2 relative to the pendulum, m/s */
    vm_real Omega;   /* angular velocity of the part relative to the pendulum, rad/s, anticlockwise */
} vm_compound_part;

/* The compound pendulum and the part after the cut */
typedef struct VM_TAG(vm_compound_cut) {
    vm_compound_pendulum rest; /* what remains; rest.rate is its angular velocity after the cut, rest.inertia is about
                                  O */
    vm_real vx, vy;            /* velocity of the part's mass centre, m/s */
    vm_real rate;              /* angular velocity of the part, rad/s */
    vm_real T1, T_S1, T_S2;    /* T1: kinetic energy of the whole before the cut; T_S1, T_S2: those of the rest and of
                                  the part after the cut, J */
    vm_real L1, L2;            /* angular momentum of the rest and of the part about O after the cut, kg m^2/s */
    vm_real pivot_x, pivot_y;  /* impulse of the pivot on the rest during the cut, N s */
} vm_compound_cut;

/* Checks the fields of a compound pendulum and of its part. Returns VM_NOT_FINITE if a field is infinite or NaN;
   VM_BAD_MASS if a mass, that of the rest included, is not positive; VM_BAD_INERTIA if the inertia of the part is
   negative, or if that of the pendulum is smaller than its mass times the square of the distance from O to its mass
   centre; else VM_OK. */
VM_API int vmi_check_compound(const vm_compound_pendulum *p, const vm_compound_part *part)
{
    const vm_real numbers[12] = {p->mass,       p->inertia,    p->x,     p->y,     p->rate, part->mass,
                                 part->inertia, part->x,       part->y,  part->ux, part->uy, part->Omega};
    if (!vmi_all_finite(12, numbers)) return VM_NOT_FINITE;
    if (!(p->mass > 0 && part->mass > 0 && part->mass < p->mass)) return VM_BAD_MASS;
    if (part->inertia < 0) return VM_BAD_INERTIA;
    if (p->inertia * (1 + 8 * VM_EPSILON) < p->mass * (p->x * p->x + p->y * p->y)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* Computes mass, mass centre and inertia of what remains of a compound pendulum. Returns VM_NOT_FINITE if a result is
   infinite or NaN; VM_BAD_INERTIA if the resulting inertia about O is 0, or is one that no body can have, because the
   part cannot have been in the pendulum; else VM_OK. */
VM_API int vmi_compound_rest(const vm_compound_pendulum *p, const vm_compound_part *part, vm_compound_pendulum *rest)
{
    const vm_real share = part->mass / (p->mass - part->mass);
    const vm_real about_O = part->inertia + part->mass * (part->x * part->x + part->y * part->y);
    const vm_real noise = 32 * VM_EPSILON * p->inertia;
    vm_real least;
    rest->mass = p->mass - part->mass;
    rest->x = p->x + share * (p->x - part->x);
    rest->y = p->y + share * (p->y - part->y);
    rest->inertia = p->inertia - about_O;
    rest->rate = p->rate;
    least = rest->mass * (rest->x * rest->x + rest->y * rest->y);
    if (!VM_IS_FINITE(least) || !VM_IS_FINITE(rest->inertia)) return VM_NOT_FINITE;
    if (rest->inertia < least - noise || !(rest->inertia > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

VM_API int vmi_compound_cut_finite(const vm_compound_cut *c)
{
    const vm_real numbers[11] = {c->rest.rate, c->vx, c->vy, c->rate,    c->T1,     c->T_S1,
                                 c->T_S2,      c->L1, c->L2, c->pivot_x, c->pivot_y};
    return vmi_all_finite(11, numbers);
}

/* Motion of a pendulum of any shape, and of the part that is cut off from it, after the cut, (119)-(132).
   The pendulum need not be uniform, and the part may have any position and inertia. Let I1 be the moment of inertia of
   the rest about O. Let m be the mass of the part, I2 its inertia about its mass centre S2, and r2 the vector from O to
   S2. Relative to the pendulum the part has the velocity u and the angular velocity Omega. Then the angular velocity of
   the pendulum changes by
     phi1' - phi' = -(I2 Omega + m (r2 x u))/I1.
   In this form digits cancel only in I1, the difference of the moments of inertia of the whole pendulum and of the part
   about O, and where the terms of the numerator have opposite signs. For axles in space see vm_separate_on_axle.
   Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument or the result is infinite or NaN;
   VM_BAD_MASS if a mass, that of the rest included, is not positive; VM_BAD_INERTIA if an inertia, that of the rest
   included, is one that no body can have, or if that of the rest is 0; VM_OK otherwise. */
VM_API int vm_compound_pendulum_separate(const vm_compound_pendulum *pendulum, const vm_compound_part *part,
                                         vm_compound_cut *cut)
{
    vm_compound_cut c;
    vm_real moment, change;
    int status;
    if (!pendulum || !part || !cut) return VM_BAD_ARGUMENT;
    status = vmi_check_compound(pendulum, part);
    if (!status) status = vmi_compound_rest(pendulum, part, &c.rest);
    if (status) return status;
    moment = part->inertia * part->Omega + part->mass * (part->x * part->uy - part->y * part->ux);
    change = -moment / c.rest.inertia;
    c.rest.rate = pendulum->rate + change;
    c.vx = part->ux - pendulum->rate * part->y;
    c.vy = part->uy + pendulum->rate * part->x;
    c.rate = pendulum->rate + part->Omega;
    c.L1 = c.rest.inertia * c.rest.rate;
    c.L2 = moment + (part->inertia + part->mass * (part->x * part->x + part->y * part->y)) * pendulum->rate;
    c.T1 = pendulum->inertia * pendulum->rate * pendulum->rate / 2;
    c.T_S1 = c.L1 * c.rest.rate / 2;
    c.T_S2 = (part->mass * (c.vx * c.vx + c.vy * c.vy) + part->inertia * c.rate * c.rate) / 2;
    c.pivot_x = part->mass * part->ux - c.rest.mass * change * c.rest.y; /* momentum after the cut minus before it */
    c.pivot_y = part->mass * part->uy + c.rest.mass * change * c.rest.x;
    if (!vmi_compound_cut_finite(&c)) return VM_NOT_FINITE;
    *cut = c;
    return VM_OK;
}

#endif
