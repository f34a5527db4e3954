/* scenes/band.h - a band that winds up on a drum or off it

   The drum is a body on an axle (chapter 5.2 of the dissertation). At the angle phi = 0 no band is on the drum. The
   constructor of the body receives the moment of inertia of the bare drum. The band comes onto the drum or leaves it
   at the radius
     R + h phi/(2 pi)   along a spiral, or
     R + h n            in layers, after n complete turns (the field by_layer is 1),
   and the moment of inertia grows by rho b h radius^3 per radian. R is the radius of the drum, h the thickness of the
   band, b its width and rho its density. If the band lies in layers, the mass of the band per radian jumps at each
   complete turn, and the reactive torque jumps with it. vm_band_at computes the part that is wound up at any angle;
   vm_effect_band is the mass law of the drum in a scene.

       vm_band band = {0.2, 0.01, 0.5, 800, 0, 0, 0}; // R, h, b, rho; the band moves with the drum; along a spiral
       vm_effect wind = vm_effect_band(0, &band);

   Tests: tests/test_scene_mass.c. */
#ifndef VARMASS_SCENES_BAND_H
#define VARMASS_SCENES_BAND_H

#include "../base/real.h"
#include "../base/status.h"
#include "effects.h"
#include "mass.h"
#include "scene.h"

/* A band. Its velocity is speed + (1 - reactive) (radius omega), where omega is the angular velocity of the drum. The
   band comes at the absolute velocity `speed` if reactive is 1, and moves with the drum if speed and reactive are 0. */
typedef struct VM_TAG(vm_band) {
    vm_real radius;    /* m: radius R of the bare drum, > 0 */
    vm_real thickness; /* m: thickness h, >= 0 */
    vm_real width;     /* m: width b, >= 0 */
    vm_real density;   /* kg/m^3: density rho, >= 0 */
    vm_real speed;     /* m/s: velocity of the band; the field `reactive` says whether it is absolute */
    vm_real reactive;     /* 1: the field `speed` is absolute; 0: it is relative to the drum */
    int by_layer;      /* 1: the band lies in layers; 0: it lies along a spiral */
} vm_band;

/* The part of a band that is on the drum at an angle phi of the drum */
typedef struct VM_TAG(vm_band_now) {
    vm_real radius;  /* m: radius at which the band comes onto the drum or leaves it */
    vm_real rate;    /* kg/rad: mass mu of the band per radian at this radius (181) */
    vm_real mass;    /* kg: mass of the part of the band that is on the drum */
    vm_real inertia; /* kg m^2: moment of inertia of the part of the band that is on the drum */
} vm_band_now;

/* The part of a band in layers that is on the drum at the angle phi. The argument `line` is density times width times
   thickness. The mass is `line` times the integral of the radius over phi, and the moment of inertia is `line` times
   the integral of the cube of the radius over phi. With R and h the radius of the drum and the thickness, and n the
   number of complete layers, the integrals over these layers are 2 pi times the sums of R + i h and of (R + i h)^3 for
   i = 0 ... n - 1. The sums of i, i^2 and i^3 are sum1, sum2 and sum1^2. */
VM_API vm_band_now vmi_band_by_layer(vm_real phi, const vm_band *b, vm_real line)
{
    const vm_real n = VM_FLOOR(phi / (2 * VM_PI)), rest = phi - n * (2 * VM_PI), R = b->radius, h = b->thickness;
    const vm_real sum1 = n * (n - 1) / 2, sum2 = sum1 * (2 * n - 1) / 3, r = R + n * h;
    vm_band_now now;
    now.radius = r;
    now.rate = line * r;
    now.mass = line * (2 * VM_PI * (n * R + h * sum1) + r * rest);
    now.inertia = line * (2 * VM_PI * (n * R * R * R + 3 * R * h * (R * sum1 + h * sum2) + h * h * h * sum1 * sum1) +
                          r * r * r * rest);
    return now;
}

VM_API int vmi_band_is_valid(const vm_band *b)
{
    return b->radius > 0 && b->thickness >= 0 && b->width >= 0 && b->density >= 0;
}

/* Returns a vm_band_now with this radius, whose rate, mass and inertia are all equal to `others`. For a bare drum
   `others` is 0. If the band or the angle is not valid, both arguments are NaN. */
VM_API vm_band_now vmi_band_none(vm_real radius, vm_real others)
{
    vm_band_now none;
    none.radius = radius;
    none.rate = others;
    none.mass = others;
    none.inertia = others;
    return none;
}

/* Radius, mass and moment of inertia of the part of a band that is on the drum at the angle phi. If phi < 0, the drum
   is bare. If the band winds in layers, an angle that is a number of complete turns, within rounding errors, may count
   as the beginning of the next layer.
   All results are NaN if phi is not finite, if the radius of the drum is not positive, if thickness, width or density
   is negative, or if band is NULL. In double the relative errors are at most 1e-13, tested up to 30 turns. */
VM_API vm_band_now vm_band_at(vm_real phi, const vm_band *band)
{
    if (!band || !VM_IS_FINITE(phi) || !vmi_band_is_valid(band)) return vmi_band_none(VM_NAN, VM_NAN);
    const vm_real line = band->density * band->width * band->thickness, R = band->radius;
    const vm_real r = R + band->thickness * (phi / (2 * VM_PI));
    vm_band_now now;
    if (!(phi >= 0)) return vmi_band_none(R, 0);
    if (band->by_layer) return vmi_band_by_layer(phi, band, line);
    now.radius = r;
    now.rate = line * r;
    now.mass = line * phi * (r + R) / 2;
    now.inertia = line * phi * ((r + R) * (r * r + R * R)) / 4;
    return now;
}

/* Indices of the parameters p of vm_effect_band; the field `variant` of the effect is the field by_layer of the
   band */
enum {
    VMI_BAND_RADIUS,
    VMI_BAND_THICKNESS,
    VMI_BAND_WIDTH,
    VMI_BAND_DENSITY,
    VMI_BAND_SPEED,
    VMI_BAND_REACTIVE
};

VM_API vm_band vmi_band_of(const vm_effect *e)
{
    vm_band b;
    b.radius = e->p[VMI_BAND_RADIUS];
    b.thickness = e->p[VMI_BAND_THICKNESS];
    b.width = e->p[VMI_BAND_WIDTH];
    b.density = e->p[VMI_BAND_DENSITY];
    b.speed = e->p[VMI_BAND_SPEED];
    b.reactive = e->p[VMI_BAND_REACTIVE];
    b.by_layer = e->variant;
    return b;
}

/* Sets the moment of inertia J(phi) of the drum, as a mass law sets a mass; on an axle the moment of inertia takes the
   place of the mass. The velocity u of the law is here the speed of the band divided by the radius at which the band
   comes, and thus an angular velocity about the axle. */
VM_API void vmi_apply_band(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_band band = vmi_band_of(e);
    const vm_band_now wound = vm_band_at(y[e->x], &band);
    const vm_real u = band.speed / wound.radius;
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    now.mass = s->bodies[e->body].start.mass + wound.inertia;
    now.by_x = wound.rate * wound.radius * wound.radius;
    vmi_scene_apply_law(e, y, s, &now, &u, band.reactive);
}

VM_API int vmi_band_check(const vm_effect *e)
{
    const vm_band band = vmi_band_of(e);
    return vmi_band_is_valid(&band) ? VM_OK : VM_DOMAIN;
}

/* A band that winds up on a drum or off it, with its reactive torque. The drum is a body on an axle. The effect is the
   mass law of this body (scenes/mass.h): it sets the moment of inertia of the drum together with the part of the band
   that is wound up. vm_scene_start returns VM_BAD_ARGUMENT if band is NULL, and VM_DOMAIN if the radius of the drum is
   not positive or if thickness, width or density is negative. */
VM_API vm_effect vm_effect_band(int body, const vm_band *band)
{
    vm_effect e = vmi_effect(body, 0, band ? vmi_apply_band : NULL);
    e.motions = 1 << VM_AXLE;
    e.order = VMI_ORDER_MASS_LAW;
    e.check = vmi_band_check;
    if (!band) return e;
    e.p[VMI_BAND_RADIUS] = band->radius;
    e.p[VMI_BAND_THICKNESS] = band->thickness;
    e.p[VMI_BAND_WIDTH] = band->width;
    e.p[VMI_BAND_DENSITY] = band->density;
    e.p[VMI_BAND_SPEED] = band->speed;
    e.p[VMI_BAND_REACTIVE] = band->reactive;
    e.variant = band->by_layer != 0;
    return e;
}

#endif
