/* mechanics/supply.h - tanks and solid propellants: mass centre and inertia of the mass that is left

   A supply is a round cylinder of stored mass inside a body. There are three kinds: a tank of liquid, whose level
   falls, a tank of gas, whose density falls, and a hollow cylinder of solid propellant (a grain), which burns radially
   outwards. The mass that is left determines its mass centre, its inertia and their rates, and also the store
   (vm_store) from which a stream takes the next mass. If a stream has this store, the moments that the stream causes
   are right. These moments include the jet damping, the moment by which a jet slows the rotation of a body.

       vm_supply tank = {VM_TANK_OF_LIQUID, {0, 0, -2}, {0, 0, 1}, 3, 0.5, 0, 800}; // 3 m long, radius 0.5 m, 800 kg
       vm_supply_left left;
       if (vm_supply_at(&tank, 200, &left) == VM_OK) printf("level %g m\n", left.size); // 0.75 m: a quarter is left

   The equations. Let m be the mass that is left, m1 that of the full supply, L the length, R the radius, e the unit
   vector along the axis from the lower end to the upper one, E the unit matrix, and b the lower end of the axis. The
   inertia about the mass centre c is m [k_a e e^T + k_t (E - e e^T)]. The part by which the supply shrinks next lies at
   the point s. In a tank of liquid this point is at the surface, although the outlet is at the lower end. The inertia
   of this part per unit mass is q_a e e^T + q_t (E - e e^T).
     liquid  level h = L m/m1, c = b + e h/2, k_a = R^2/2, k_t = R^2/4 + h^2/12; s = b + e h, q_a = R^2/2, q_t = R^2/4
     gas     c = s = b + e L/2, k_a = q_a = R^2/2, k_t = q_t = R^2/4 + L^2/12
     grain   bore r, r^2 = (m r0^2 + (m1 - m) R^2)/m1 with the bore r0 of the full grain, c = s = b + e L/2,
             k_a = (R^2 + r^2)/2, k_t = (R^2 + r^2)/4 + L^2/12, q_a = r^2, q_t = r^2/2 + L^2/12
   These formulas follow from the volumes. The first and second moments of the mass about a fixed point give the
   identities d(m c)/dm = s and dI/dm = Q + P(s - c), where I is the inertia about c, Q the inertia per unit mass of the
   part by which the supply shrinks next, and P(d) = |d|^2 E - d d^T.
   Tests: tests/test_supply.c. */
#ifndef VARMASS_MECHANICS_SUPPLY_H
#define VARMASS_MECHANICS_SUPPLY_H

#include "../base/real.h"
#include "../base/status.h"
#include "attitude.h"
#include "inertia.h"
#include "streams.h"
#include "vectors.h"

/* The kinds of supplies */
enum {
    VM_TANK_OF_LIQUID = 0, /* constant density; the outlet is at the lower end. The surface of the liquid stays normal
                              to the axis, and the liquid turns with the tank */
    VM_TANK_OF_GAS = 1,    /* constant volume; the density is the same everywhere, and falls as gas leaves */
    VM_GRAIN = 2           /* constant density; a hollow cylinder that burns from its bore outwards, not at its ends */
};

/* A supply of mass inside a body */
typedef struct VM_TAG(vm_supply) {
    int kind;       /* VM_TANK_OF_LIQUID, VM_TANK_OF_GAS or VM_GRAIN */
    vm_vec3 at;     /* centre of the lower end, from the body's reference point, m, body axes */
    vm_vec3 axis;   /* direction from the lower end to the upper end, of any length but 0, body axes */
    vm_real length; /* distance between the ends, m; of a tank of liquid: the level when it is full */
    vm_real radius; /* outer radius, m */
    vm_real bore;   /* inner radius of the full grain, m, 0 <= bore < radius; not used by the tanks */
    vm_real full;   /* mass of the full supply, kg */
} vm_supply;

/* What is left of a supply. The fields centre_by_mass and inertia_by_mass are derivatives with respect to the mass that
   is left. Multiply them by the rate of this mass in kg/s (< 0 while the supply empties) to get derivatives with
   respect to time. */
typedef struct VM_TAG(vm_supply_left) {
    vm_real mass;               /* mass that is left, kg */
    vm_real size;               /* level of the liquid, length of the tank of gas, or bore of the grain, m */
    vm_vec3 centre;             /* mass centre, from the body's reference point, m, body axes */
    vm_inertia inertia;         /* inertia about this mass centre, kg m^2, body axes */
    vm_vec3 centre_by_mass;     /* derivative of `centre` with respect to the mass, m/kg */
    vm_inertia inertia_by_mass; /* derivative of `inertia` with respect to the mass, m^2 */
    vm_store store;             /* position and gyration of the part by which the supply shrinks next, for the field
                                   `from` of a vm_stream */
} vm_supply_left;

/* The tensor axial e e^T + transverse (E - e e^T) for a unit vector e and the unit matrix E. The diagonal entries are
   sums of positive terms. */
VM_API vm_inertia vmi_inertia_of_revolution(vm_vec3 e, vm_real axial, vm_real transverse)
{
    const vm_real difference = axial - transverse;
    vm_inertia i;
    i.xx = axial * (e.x * e.x) + transverse * (e.y * e.y + e.z * e.z);
    i.yy = axial * (e.y * e.y) + transverse * (e.x * e.x + e.z * e.z);
    i.zz = axial * (e.z * e.z) + transverse * (e.x * e.x + e.y * e.y);
    i.xy = difference * (e.x * e.y);
    i.xz = difference * (e.x * e.z);
    i.yz = difference * (e.y * e.z);
    return i;
}

VM_API int vmi_supply_check(const vm_supply *s, vm_real mass)
{
    if (s->kind < VM_TANK_OF_LIQUID || s->kind > VM_GRAIN) return VM_BAD_ARGUMENT;
    if (!vmi_vec3_is_finite(s->at) || !vmi_vec3_is_finite(s->axis) || !VM_IS_FINITE(s->length)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(s->radius) || !VM_IS_FINITE(s->bore) || !VM_IS_FINITE(s->full)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(mass)) return VM_NOT_FINITE;
    if (!(s->full > 0)) return VM_BAD_MASS;
    if (!(s->length > 0 && s->radius > 0) || vmi_norm_max(s->axis) == 0) return VM_DOMAIN;
    if (s->kind == VM_GRAIN && !(s->bore >= 0 && s->bore < s->radius)) return VM_DOMAIN;
    return VM_OK;
}

/* Writes to *left what is left of a tank of liquid. left->mass must be set; e is the unit vector along the axis. */
VM_API void vmi_supply_liquid(const vm_supply *s, vm_vec3 e, vm_supply_left *left)
{
    const vm_real m = left->mass, level = s->length * (m / s->full), disc = s->radius * s->radius / 4;
    const vm_real slope = s->length / s->full / 2;
    left->size = level;
    left->centre = vm_add(s->at, vm_scale(level / 2, e));
    left->centre_by_mass = vm_scale(slope, e);
    left->inertia = vmi_inertia_of_revolution(e, m * (2 * disc), m * (disc + level * level / 12));
    left->inertia_by_mass = vmi_inertia_of_revolution(e, 2 * disc, disc + level * level / 4);
    left->store.at = vm_add(s->at, vm_scale(level, e));
    left->store.gyration = vmi_inertia_of_revolution(e, 2 * disc, disc);
}

/* Writes to *left what is left of a tank of gas or of a grain. left->mass must be set; e is the unit vector along the
   axis. The square of the bore is r^2 of the equations at the top of mechanics/supply.h; it is 0 for gas, whose density
   is the same everywhere. */
VM_API void vmi_supply_hollow(const vm_supply *s, vm_vec3 e, vm_supply_left *left)
{
    const vm_real m = left->mass, square = s->radius * s->radius, rod = s->length * s->length / 12;
    vm_real bore = 0, axial = square / 2, transverse = square / 4;
    left->size = s->length;
    if (s->kind == VM_GRAIN) {
        bore = (m * (s->bore * s->bore) + (s->full - m) * square) / s->full;
        left->size = bore > 0 ? VM_SQRT(bore) : 0;
        axial = bore;
        transverse = bore / 2;
    }
    left->centre = left->store.at = vm_add(s->at, vm_scale(s->length / 2, e));
    left->centre_by_mass = vmi_vec3(0, 0, 0);
    left->inertia = vmi_inertia_of_revolution(e, m * ((square + bore) / 2), m * ((square + bore) / 4 + rod));
    left->inertia_by_mass = left->store.gyration = vmi_inertia_of_revolution(e, axial, transverse + rod);
}

VM_API int vmi_supply_left_is_finite(const vm_supply_left *left)
{
    return VM_IS_FINITE(left->size) && vmi_vec3_is_finite(left->centre) && vmi_vec3_is_finite(left->centre_by_mass) &&
           vmi_inertia_is_finite(&left->inertia) && vmi_inertia_is_finite(&left->inertia_by_mass) &&
           vmi_vec3_is_finite(left->store.at) && vmi_inertia_is_finite(&left->store.gyration);
}

/* What is left of a tank or grain when its mass is `mass`: mass centre, inertia, their derivatives, and the store of
   the mass that leaves next.
   mass is in kg and lies between 0 and supply.full. For a mass below 0 or above supply.full the function uses the same
   formulas. The results then describe no body, but, apart from the bore of a grain (0 where its square would be
   negative), they change smoothly with the mass. An integrator needs this, because its trial steps may go beyond these
   limits. The errors are at most 8 eps of a scale: |at| + length for a position, the largest entry for a tensor, and
   the length of the vector for centre_by_mass. These bounds hold for a nearly empty or nearly full supply, too. Returns
   VM_BAD_ARGUMENT for a null pointer or an unknown kind; VM_NOT_FINITE if an argument or the result is infinite or NaN;
   VM_BAD_MASS if supply.full is not positive; VM_DOMAIN if the length or the radius is not positive, if the axis is 0,
   or if the bore of a grain is not between 0 and the radius; VM_OK otherwise. */
VM_API int vm_supply_at(const vm_supply *supply, vm_real mass, vm_supply_left *left)
{
    vm_supply_left result;
    vm_vec3 e;
    int status;
    if (!supply || !left) return VM_BAD_ARGUMENT;
    status = vmi_supply_check(supply, mass);
    if (status) return status;
    e = vm_unit(supply->axis);
    result.mass = mass;
    if (supply->kind == VM_TANK_OF_LIQUID) vmi_supply_liquid(supply, e, &result);
    else vmi_supply_hollow(supply, e, &result);
    if (!vmi_supply_left_is_finite(&result)) return VM_NOT_FINITE;
    *left = result;
    return VM_OK;
}

#endif
