/* scenes/springs.h - springs and dampers between points of bodies

   A spring and a damper, side by side, act along the straight line between a point of a body and a point of another
   body or of the ground, in the plane and in space. They push or pull with the same force at both points, so that the
   bodies also turn about their mass centres. points.h explains how a point is given.

       vm_point_spring strut = {{0.5, 0, 0}, {2, 1, 0}, 1000, 5, 0.3};          // 1000 N/m, 5 N s/m, 0.3 m long
       vm_effect effects[] = {vm_effect_point_spring(0, VM_GROUND, &strut)};    // from a point of body 0 to (2, 1, 0)

   The field `work` of the scene's budget includes the work of the force, which is the energy that the spring gives
   back less the energy that the damper takes out. The spring stores the energy k (l - rest)^2/2, where k is its
   stiffness, l its present length, and `rest` its length without force.

   Tests: tests/test_scene_joints.c. */
#ifndef VARMASS_SCENES_SPRINGS_H
#define VARMASS_SCENES_SPRINGS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "points.h"
#include "scene.h"

/* A spring and a damper between two points */
typedef struct VM_TAG(vm_point_spring) {
    vm_vec3 at;        /* m, body axes: the point of the body */
    vm_vec3 other_at;  /* m: the point of the other body, in the axes of this body, or the point of the ground */
    vm_real stiffness; /* N/m: stiffness k, of either sign */
    vm_real damping;   /* N s/m: damping; a damping > 0 takes energy out */
    vm_real rest;      /* m: length of the spring if no force acts on it, >= 0 */
} vm_point_spring;

/* Computes the force on the first point; d and v are its position and velocity relative to the second point. If the
   points coincide, a spring whose length `rest` is 0 or whose stiffness is 0 exerts no force, and the damper acts
   against the velocity v. For any other spring the force has no direction if the points coincide, and the function
   returns VM_SINGULAR. In all other cases it returns VM_OK. */
VM_API int vmi_point_spring_force(const vm_point_spring *spring, vm_vec3 d, vm_vec3 v, vm_vec3 *f)
{
    const vm_real length = vm_norm(d);
    vm_vec3 along;
    vm_real pull;
    *f = vm_scale(-spring->damping, v);
    if (length == 0 && (spring->rest == 0 || spring->stiffness == 0)) return VM_OK;
    if (length == 0) return VM_SINGULAR;
    along = vmi_over(d, length);
    pull = spring->stiffness * (length - spring->rest) + spring->damping * vm_dot(along, v);
    *f = vm_scale(-pull, along);
    return VM_OK;
}

VM_API void vmi_apply_point_spring(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_point_spring *spring = (const vm_point_spring *)e->parts;
    vmi_body_point here, there;
    vm_vec3 f;
    (void)t;
    vmi_point_now(s, e->body, spring->at, y, &here);
    vmi_point_now(s, e->other, spring->other_at, y, &there);
    if (vmi_point_spring_force(spring, vm_sub(here.r, there.r), vm_sub(here.v, there.v), &f)) s->status = VM_SINGULAR;
    vmi_point_push(s->bodies + e->body, &here, f);
    if (e->other >= 0) vmi_point_push(s->bodies + e->other, &there, vm_scale(-1, f));
}

VM_API int vmi_point_spring_check(const vm_scene *s, const vm_effect *e)
{
    const vm_point_spring *spring = (const vm_point_spring *)e->parts;
    int status = vmi_point_check(s, e->body, spring->at);
    status = vmi_first_error(status, vmi_point_check(s, e->other, spring->other_at));
    if (!VM_IS_FINITE(spring->stiffness) || !VM_IS_FINITE(spring->damping) || !VM_IS_FINITE(spring->rest))
        status = vmi_first_error(status, VM_NOT_FINITE);
    if (spring->rest < 0) status = vmi_first_error(status, VM_DOMAIN);
    if (e->body == e->other) status = vmi_first_error(status, VM_SAME_BODY);
    return status;
}

/* A spring and a damper between a point of a body and a point of the body `other`, or of the ground. *spring is not
   copied: if an event changes it, the run continues with the change. The force that pulls the points together is
   stiffness (l - rest) + damping l', where l is the present length of the spring and l' the rate of this length.
   vm_scene_start returns VM_BAD_ARGUMENT if spring is NULL, VM_NOT_FINITE if a number is infinite or NaN, VM_DOMAIN if
   rest < 0, VM_SAME_BODY if the spring connects a body with itself, and VM_BAD_POINT if a body cannot have its point
   of the spring (points.h). A run ends with VM_SINGULAR if the points coincide, unless rest or stiffness is 0. */
VM_API vm_effect vm_effect_point_spring(int body, int other, const vm_point_spring *spring)
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, spring ? vmi_apply_point_spring : NULL);
    e.parts = spring;
    e.check_in_scene = vmi_point_spring_check;
    return e;
}

#endif
