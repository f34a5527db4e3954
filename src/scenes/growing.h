/* scenes/growing.h - bodies whose mass centre and inertia change */
#ifndef VARMASS_SCENES_GROWING_H
#define VARMASS_SCENES_GROWING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/bodies.h"
#include "../mechanics/inertia.h"
#include "../mechanics/vectors.h"
#include "motions.h"
#include "scene.h"

/* After the mass: where the mass centre is in the body, 2 or 3 numbers, then the inertia, 1 or 6 */
VM_INLINE int vmi_growth(const vm_scene_body *b) { return vmi_scene_mass_at(b) + 1; }

VM_API void vmi_growth_begin(vm_scene_body *b)
{
    const vm_inertia none = {0, 0, 0, 0, 0, 0};
    b->load.drift = b->load.centre_rate = vmi_vec3(0, 0, 0);
    b->load.inertia_rate = none;
}

VM_API vm_vec3 vmi_growth_centre(const vm_scene_body *b, const vm_real *state)
{
    const vm_real *c = state + vmi_growth(b);
    return vmi_vec3(c[0], c[1], b->motion == VM_PLANE ? 0 : c[2]);
}

VM_API void vmi_growth_put_centre(const vm_scene_body *b, vm_vec3 centre, vm_real *state)
{
    vm_real *c = state + vmi_growth(b);
    c[0] = centre.x;
    c[1] = centre.y;
    if (b->motion != VM_PLANE) c[2] = centre.z;
}

VM_API void vmi_plane_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vm_real s, c;
    vmi_growth_begin(b);
    vmi_sincos(state[2], &s, &c);
    b->axes.x = vmi_vec3(c, s, 0);
    b->axes.y = vmi_vec3(-s, c, 0);
    b->axes.z = vmi_vec3(0, 0, 1);
    b->inertia.zz = state[vmi_growth(b) + 2];
}

VM_API int vmi_plane_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    if (!(b->inertia.zz > 0)) return VM_BAD_INERTIA;
    vmi_plane_accelerate(b, state, rates);
    rates[0] += load->drift.x;
    rates[1] += load->drift.y;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    rates[vmi_growth(b) + 2] = load->inertia_rate.zz;
    return VM_OK;
}

VM_API void vmi_plane_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_plane_put(b, now, angle, state);
    state[vmi_growth(b) + 2] = now->inertia.zz;
}

VM_API void vmi_plane_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia.zz = state[vmi_growth(b) + 2];
    vmi_plane_get(b, state, now);
}

/* The same, its mass, the mass centre in the body and its inertia states: for streams that cross at points. A run
   ends with VM_BAD_INERTIA when they leave an inertia that no body can have. A rod or a point cannot grow. */
VM_API vm_scene_body vm_scene_body_growing_plane(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.begin = vmi_plane_growing_begin;
    body.accelerate = vmi_plane_growing_accelerate;
    body.put = body.motion == VM_PLANE ? vmi_plane_growing_put : NULL; /* NULL is refused by vm_scene_check */
    body.get = vmi_plane_growing_get;
    return body;
}

VM_API void vmi_free_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vmi_growth_begin(b);
    b->axes = vmi_rotation(vmi_free_quat(state));
    b->inertia = b->filled = vmi_get_inertia(state + vmi_growth(b) + 3);
}

VM_API int vmi_free_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    vmi_inertia_ldl factors; /* which Euler's equations below do not use */
    if (!vmi_inertia_factor_if_possible(&b->inertia, &factors)) return VM_BAD_INERTIA;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    vmi_set_inertia(rates + vmi_growth(b) + 3, &load->inertia_rate);
    if (vmi_free_accelerate(b, state, rates)) return VM_BAD_INERTIA;
    rates[0] += load->drift.x;
    rates[1] += load->drift.y;
    rates[2] += load->drift.z;
    return VM_OK;
}

VM_API void vmi_free_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_free_put(b, now, angle, state);
    vmi_set_inertia(state + vmi_growth(b) + 3, &now->inertia);
}

VM_API void vmi_free_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia = vmi_get_inertia(state + vmi_growth(b) + 3);
    vmi_free_get(b, state, now);
}

/* A rod or a point has no axis about which a stream could turn it */
VM_API int vmi_free_growing_check(const vm_body *start)
{
    vmi_inertia_ldl factors;
    const int status = vmi_check_body(start);
    if (status) return status;
    return vmi_inertia_factor_if_possible(&start->inertia, &factors) ? VM_OK : VM_BAD_INERTIA;
}

/* Documented with vm_scene_body_growing_plane. */
VM_API vm_scene_body vm_scene_body_growing_free(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.check = vmi_free_growing_check;
    body.begin = vmi_free_growing_begin;
    body.accelerate = vmi_free_growing_accelerate;
    body.put = body.motion == VM_FREE ? vmi_free_growing_put : NULL;
    body.get = vmi_free_growing_get;
    return body;
}

#endif
