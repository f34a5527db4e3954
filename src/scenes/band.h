/* scenes/band.h - a band that winds up */
#ifndef VARMASS_SCENES_BAND_H
#define VARMASS_SCENES_BAND_H

#include "../base/real.h"
#include "../base/status.h"
#include "effects.h"
#include "mass.h"
#include "scene.h"

/* A band that is wound up on a drum on an axle, or unwound from it (chapter 5.2), layer upon layer. At the angle phi,
   0 where the drum, of the inertia with which the body was made, is bare, the band comes or goes at the radius
   R + h phi/(2 pi), a spiral, or where by_layer is set at R + h n, n turns being complete; its inertia grows by
   rho b h radius^3 a radian. Its own velocity is speed + share (radius omega): share = 1 and speed = 0 if it moves
   with the drum. By layers the torque has kinks at full turns. */
typedef struct VM_TAG(vm_band) {
    vm_real radius;           /* R of the bare drum, m */
    vm_real thickness, width; /* h, b, m */
    vm_real density;          /* rho, kg/m^3 */
    vm_real speed, share;     /* m/s */
    int by_layer;
} vm_band;

typedef struct VM_TAG(vm_band_now) {
    vm_real radius, rate, mass, inertia; /* m; kg/rad, mu (181) of this radius; of what is wound up, kg, kg m^2 */
} vm_band_now;

/* rho b h integral of radius^k over phi, k = 1 the mass, 3 the inertia; d: what has been added to R. With n layers
   complete sum (R + i h)^k, i < n, is by sum i, i^2, i^3 */
VM_API vm_band_now vmi_band_by_layer(vm_real phi, const vm_band *b, vm_real line)
{
    const vm_real n = VM_FLOOR(phi / (2 * VM_PI)), rest = phi - n * (2 * VM_PI), R = b->radius, h = b->thickness;
    const vm_real s1 = n * (n - 1) / 2, s2 = s1 * (2 * n - 1) / 3, r = R + n * h;
    vm_band_now now;
    now.radius = r;
    now.rate = line * r;
    now.mass = line * (2 * VM_PI * (n * R + h * s1) + r * rest);
    now.inertia = line * (2 * VM_PI * (n * R * R * R + 3 * R * h * (R * s1 + h * s2) + h * h * h * s1 * s1) +
                          r * r * r * rest);
    return now;
}

VM_API int vmi_band_is_valid(const vm_band *b)
{
    return b->radius > 0 && b->thickness >= 0 && b->width >= 0 && b->density >= 0;
}

VM_API vm_band_now vmi_no_band(void)
{
    vm_band_now none;
    none.radius = none.rate = none.mass = none.inertia = VM_NAN;
    return none;
}

/* phi < 0: the bare drum; NaN where phi is not finite, the radius not > 0, a size < 0. Some eps of each number */
VM_API vm_band_now vm_band_at(vm_real phi, const vm_band *band)
{
    if (!band) return vmi_no_band();
    const vm_real line = band->density * band->width * band->thickness, R = band->radius;
    const vm_real d = band->thickness * (phi / (2 * VM_PI)), r = R + d;
    const vm_real bare = VM_IS_FINITE(phi) && vmi_band_is_valid(band) ? 0 : VM_NAN;
    vm_band_now now;
    now.radius = R + bare;
    now.rate = now.mass = now.inertia = bare;
    if (!(phi >= 0 && bare == 0)) return now;
    if (band->by_layer) return vmi_band_by_layer(phi, band, line);
    now.radius = r;
    now.rate = line * r;
    now.mass = line * phi * (r + R) / 2;
    now.inertia = line * phi * ((r + R) * (r * r + R * R)) / 4;
    return now;
}

VM_API vm_band vmi_band_of(const vm_effect *e)
{
    vm_band b;
    b.radius = e->p[0];
    b.thickness = e->p[1];
    b.width = e->p[2];
    b.density = e->p[3];
    b.speed = e->p[4];
    b.share = e->p[5];
    b.by_layer = e->other_coordinate;
    return b;
}

VM_API void vmi_apply_band(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_band band = vmi_band_of(e);
    const vm_band_now wound = vm_band_at(y[e->x], &band);
    const vm_real u = band.speed / wound.radius;
    vm_mass_now now = {0, 0, 0, 0};
    (void)t;
    now.mass = s->bodies[e->body].start.mass + wound.inertia;
    now.by_x = wound.rate * wound.radius * wound.radius;
    vmi_scene_apply_law(e, y, s, &now, &u, band.share);
}

VM_API int vmi_band_check(const vm_effect *e)
{
    const vm_band band = vmi_band_of(e);
    return vmi_band_is_valid(&band) ? VM_OK : VM_DOMAIN;
}

/* Documented with vm_band_at. */
VM_API vm_effect vm_effect_band(int body, const vm_band *band)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, 1 << VM_AXLE, 0, 0, 0);
    e.order = 0;
    e.apply = band ? vmi_apply_band : NULL;
    e.check = vmi_band_check;
    if (!band) return e;
    e.p[0] = band->radius;
    e.p[1] = band->thickness;
    e.p[2] = band->width;
    e.p[3] = band->density;
    e.p[4] = band->speed;
    e.p[5] = band->share;
    e.other_coordinate = band->by_layer != 0;
    return e;
}

#endif
