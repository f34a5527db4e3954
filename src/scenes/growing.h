/* scenes/growing.h - bodies whose mass centre and inertia change

   The mass, the mass centre in the body, and the inertia of a growing body are numbers of the state, so that streams
   can enter or leave at points of the body (streams.h). A growing body moves in the plane or in space. A point cannot
   grow, and neither can a rod, which has no moment of inertia about its axis.

       vm_vec3 zero = {0, 0, 0};
       vm_scene_body bodies[] = {vm_scene_body_growing_plane(vm_scene_body_plane(2, 1, zero, 0, zero, 0))};
       vm_effect effects[] = {vm_effect_stream_mass(0, &nozzle), vm_effect_stream_force(0, &nozzle)}; // a vm_stream

   Tests: tests/test_scene_streams.c. */
#ifndef VARMASS_SCENES_GROWING_H
#define VARMASS_SCENES_GROWING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/attitude.h"
#include "../mechanics/bodies.h"
#include "../mechanics/inertia.h"
#include "../mechanics/inertia_factors.h"
#include "../mechanics/vectors.h"
#include "motions.h"
#include "scene.h"

/* The index of the coordinates of the mass centre in the state of a growing body; these coordinates follow the mass */
VM_INLINE int vmi_growth_centre_at(const vm_scene_body *b) { return vmi_scene_mass_at(b) + 1; }

/* The index of the inertia in the state of a growing body; the inertia follows the 2 or 3 coordinates of the mass
   centre */
VM_INLINE int vmi_growth_inertia_at(const vm_scene_body *b)
{
    const int directions = b->motion == VM_PLANE ? 2 : 3;
    return vmi_growth_centre_at(b) + directions;
}

VM_API void vmi_growth_begin(vm_scene_body *b)
{
    const vm_inertia none = {0, 0, 0, 0, 0, 0};
    b->load.drift = b->load.centre_rate = vmi_vec3(0, 0, 0);
    b->load.inertia_rate = none;
}

VM_API vm_vec3 vmi_growth_centre(const vm_scene_body *b, const vm_real *state)
{
    const vm_real *c = state + vmi_growth_centre_at(b);
    return vmi_vec3(c[0], c[1], b->motion == VM_PLANE ? 0 : c[2]);
}

VM_API void vmi_growth_put_centre(const vm_scene_body *b, vm_vec3 centre, vm_real *state)
{
    vm_real *c = state + vmi_growth_centre_at(b);
    c[0] = centre.x;
    c[1] = centre.y;
    if (b->motion != VM_PLANE) c[2] = centre.z;
}

VM_API void vmi_plane_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vm_real s, c;
    vmi_growth_begin(b);
    vmi_sincos(state[VMI_PLANE_ANGLE], &s, &c);
    b->axes.x = vmi_vec3(c, s, 0);
    b->axes.y = vmi_vec3(-s, c, 0);
    b->axes.z = vmi_vec3(0, 0, 1);
    b->inertia.zz = state[vmi_growth_inertia_at(b)];
}

VM_API int vmi_plane_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    if (!(b->inertia.zz > 0)) return VM_BAD_INERTIA;
    vmi_plane_accelerate(b, state, rates);
    rates[VMI_PLANE_X] += load->drift.x;
    rates[VMI_PLANE_Y] += load->drift.y;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    rates[vmi_growth_inertia_at(b)] = load->inertia_rate.zz;
    return VM_OK;
}

VM_API void vmi_plane_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_plane_put(b, now, angle, state);
    state[vmi_growth_inertia_at(b)] = now->inertia.zz;
}

VM_API void vmi_plane_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia.zz = state[vmi_growth_inertia_at(b)];
    vmi_plane_get(b, state, now);
}

/* A growing body in the plane. The argument is a body made by vm_scene_body_plane; for any other body vm_scene_start
   returns VM_BAD_MOTION. A run ends with VM_BAD_INERTIA when the moment of inertia is no longer positive. */
VM_API vm_scene_body vm_scene_body_growing_plane(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.begin = vmi_plane_growing_begin;
    body.accelerate = vmi_plane_growing_accelerate;
    body.put = NULL; /* vm_scene_check then refuses the body */
    if (body.motion == VM_PLANE) body.put = vmi_plane_growing_put;
    body.get = vmi_plane_growing_get;
    return body;
}

VM_API void vmi_free_growing_begin(vm_scene_body *b, const vm_real *state)
{
    vmi_growth_begin(b);
    b->axes = vmi_rotation(vmi_get_quat(state + VMI_FREE_Q));
    b->inertia = b->invertible = vmi_get_inertia(state + vmi_growth_inertia_at(b));
}

VM_API int vmi_free_growing_accelerate(const vm_scene_body *b, const vm_real *state, vm_real *rates)
{
    const vm_load *load = &b->load;
    /* the factors are used only for this check: vmi_free_accelerate solves Euler's equations without them */
    vmi_inertia_ldl factors;
    if (!vmi_inertia_factor_if_possible(&b->inertia, &factors)) return VM_BAD_INERTIA;
    vmi_growth_put_centre(b, load->centre_rate, rates);
    vmi_set_inertia(rates + vmi_growth_inertia_at(b), &load->inertia_rate);
    if (vmi_free_accelerate(b, state, rates)) return VM_BAD_INERTIA;
    rates[VMI_FREE_R] += load->drift.x;
    rates[VMI_FREE_R + 1] += load->drift.y;
    rates[VMI_FREE_R + 2] += load->drift.z;
    return VM_OK;
}

VM_API void vmi_free_growing_put(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state)
{
    vmi_free_put(b, now, angle, state);
    vmi_set_inertia(state + vmi_growth_inertia_at(b), &now->inertia);
}

VM_API void vmi_free_growing_get(const vm_scene_body *b, const vm_real *state, vm_body *now)
{
    now->inertia = vmi_get_inertia(state + vmi_growth_inertia_at(b));
    vmi_free_get(b, state, now);
}

/* Checks the inertia of a growing body in space. A rod or a point is refused: it has no moment of inertia about at
   least one axis, so that the equations of motion could not be solved for the rotation about this axis. */
VM_API int vmi_free_growing_check(const vm_body *start)
{
    vmi_inertia_ldl factors;
    const int status = vmi_check_body(start);
    if (status) return status;
    if (!vmi_inertia_factor_if_possible(&start->inertia, &factors)) return VM_BAD_INERTIA;
    return VM_OK;
}

/* A growing body in space. The argument is a body made by vm_scene_body_free; for any other body vm_scene_start
   returns VM_BAD_MOTION, and for a rod or a point VM_BAD_INERTIA. A run ends with VM_BAD_INERTIA when the inertia
   becomes impossible for a body. */
VM_API vm_scene_body vm_scene_body_growing_free(vm_scene_body body)
{
    body.mass_is_state = body.grows = 1;
    body.check = vmi_free_growing_check;
    body.begin = vmi_free_growing_begin;
    body.accelerate = vmi_free_growing_accelerate;
    body.put = NULL; /* vm_scene_check then refuses the body */
    if (body.motion == VM_FREE) body.put = vmi_free_growing_put;
    body.get = vmi_free_growing_get;
    return body;
}

#endif
