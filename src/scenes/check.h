/* scenes/check.h - checks that find what is wrong with a scene

   vm_scene_check examines bodies, effects and events once, before a run, and reports what is wrong and where.
   vm_scene_start calls vm_scene_check.

       vm_scene_fault fault;
       int status = vm_scene_check(&scene, &fault);
       if (status < 0) printf("%s %d: %s\n", fault.kind, fault.index, vm_strerror(status)); // effect 1: no body has ...

   Tests: tests/test_scene_runs.c, tests/test_scene_bodies.c, tests/test_refusals_scenes.c. */
#ifndef VARMASS_SCENES_CHECK_H
#define VARMASS_SCENES_CHECK_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/bodies.h"
#include "scene.h"

/* Says which part of a scene is wrong */
typedef struct VM_TAG(vm_scene_fault) {
    /* what is wrong: "body", "effect" or "event"; "scene" if an array of the scene is wrong or if nothing is wrong */
    const char *kind;
    int index;        /* index of the wrong body, effect or event; -1 for the scene itself */
} vm_scene_fault;

VM_API int vmi_scene_check_body(const vm_scene_body *b)
{
    if (b->status) return b->status;
    if (b->motion < VM_LINE || b->motion > VM_FREE || !b->put) return VM_BAD_MOTION;
    if (!vmi_body_is_finite(&b->start) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->start.mass > 0) && b->motion == VM_AXLE) return VM_BAD_INERTIA; /* on an axle `mass` is the inertia */
    if (!(b->start.mass > 0)) return VM_BAD_MASS;
    if (b->check) return (b->check)(&b->start);
    return VM_OK;
}

/* Checks that a body and its coordinate exist. A free body has six velocities, but an effect can only act on the three
   coordinates of its mass centre. */
VM_API int vmi_scene_check_coordinate(const vm_scene *s, int body, int coordinate)
{
    if (body < 0 || body >= s->n_bodies) return VM_NO_SUCH_BODY;
    if (coordinate < 0 || coordinate >= s->bodies[body].coordinates) return VM_NO_SUCH_COORDINATE;
    if (s->bodies[body].motion == VM_FREE && coordinate > 2) return VM_NO_SUCH_COORDINATE;
    return VM_OK;
}

/* Checks the place of an effect in the list, among the effects on a body: a mass law must be the first of them and a
   link the last, and a body has at most one mass law and one link. `order` is one of VMI_ORDER_..., and
   b->listed_orders has the bit (1 << order) for each effect on the body that stands earlier in the list. */
VM_API int vmi_scene_check_order(vm_scene_body *b, int order)
{
    const int law = 1 << VMI_ORDER_MASS_LAW, force = 1 << VMI_ORDER_FORCE, link = 1 << VMI_ORDER_LINK;
    const int before = b->listed_orders;
    b->listed_orders |= 1 << order;
    if (order == VMI_ORDER_MASS_LAW && ((before & law) || b->mass_is_state)) return VM_TWO_MASS_LAWS;
    if (order == VMI_ORDER_LINK && (before & link)) return VM_TWO_LINKS;
    if (order == VMI_ORDER_MASS_LAW && (before & (force | link))) return VM_BAD_ORDER;
    if (order == VMI_ORDER_FORCE && (before & link)) return VM_LINK_NOT_LAST;
    return VM_OK;
}

/* Checks that the bodies of an effect have kinds of motion on which the effect can act */
VM_API int vmi_scene_check_motions(const vm_scene *s, const vm_effect *e)
{
    const vm_scene_body *b = s->bodies + e->body, *other = e->other == VM_GROUND ? NULL : s->bodies + e->other;
    if (!(e->motions >> b->motion & 1)) return VM_BAD_MOTION;
    if (e->not_on_angle && b->motion == VM_PLANE && e->coordinate == 2) return VM_NOT_ON_ANGLE;
    if (other && !(e->other_motions >> other->motion & 1)) return VM_BAD_MOTION;
    if (e->check_in_scene) return e->check_in_scene(s, e);
    return VM_OK;
}

VM_API int vmi_scene_check_parameters(const vm_scene_body *b, const vm_effect *e)
{
    int k;
    for (k = 0; k < VM_LENGTH(e->p); k++)
        if (!VM_IS_FINITE(e->p[k])) return VM_NOT_FINITE;
    if (e->needs >= VMI_NEEDS_GROWING_BODY && !b->grows) return VM_DOES_NOT_GROW;
    if (e->needs >= VMI_NEEDS_MASS_STATE && !b->mass_is_state) return VM_MASS_IS_NO_STATE;
    if (e->check) return (e->check)(e);
    return VM_OK;
}

VM_API int vmi_scene_check_effect(const vm_scene *s, const vm_effect *e)
{
    int status = vmi_scene_check_coordinate(s, e->body, e->coordinate);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_coordinate(s, e->other, e->other_coordinate);
    if (!status && !e->apply) status = VM_BAD_ARGUMENT;
    if (!status) status = vmi_scene_check_motions(s, e);
    if (!status) status = vmi_scene_check_parameters(s->bodies + e->body, e);
    if (!status) status = vmi_scene_check_order(s->bodies + e->body, e->order);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_order(s->bodies + e->other, e->order);
    return status;
}

/* Returns 1 if a body of the kind `motion` (VM_LINE, VM_AXLE, ...) can take up or give off a body of the kind `other`,
   else 0. Both kinds must be the same, except that a body in the plane or in space can also take up or give off a
   point, which has no rotation. */
VM_API int vmi_scene_can_jump(int motion, int other)
{
    return motion == other || (other == VM_POINT && motion > VM_AXLE);
}

/* Checks a jump. A part that separates becomes a body of the scene that was absent. Therefore this function also
   checks that this body can have the mass, inertia and motion of the part. */
VM_API int vmi_scene_check_jump(const vm_scene *s, const vm_event *e)
{
    int status = vmi_scene_check_coordinate(s, e->jump_body, 0);
    vm_scene_body part;
    if (!status) status = vmi_scene_check_coordinate(s, e->other, 0);
    if (!status && e->jump_body == e->other) status = VM_SAME_BODY;
    if (status) return status;
    if (!vmi_scene_can_jump(s->bodies[e->jump_body].motion, s->bodies[e->other].motion)) return VM_BAD_MOTION;
    if (!(e->motions >> s->bodies[e->jump_body].motion & 1)) return VM_BAD_MOTION;
    if (!vmi_impulse_is_finite(&e->external)) return VM_NOT_FINITE;
    if (e->jump_kind == VMI_JUMP_ATTACHES) return VM_OK;
    part = s->bodies[e->other];
    part.start = e->part;
    return vmi_scene_check_body(&part);
}

VM_API int vmi_scene_check_event(const vm_scene *s, const vm_event *e)
{
    int status = e->status;
    if (!status && e->check_when) status = (e->check_when)(s, e);
    if (status) return status;
    if (e->most < 0) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(e->time) || !VM_IS_FINITE(e->value)) return VM_NOT_FINITE;
    if (e->check) return (e->check)(s, e);
    return VM_OK;
}

VM_API int vmi_scene_check_arrays(const vm_scene *s)
{
    int i;
    if (!s || s->n_bodies < 1 || !s->bodies) return VM_BAD_ARGUMENT;
    if (s->n_effects < 0 || (s->n_effects && !s->effects)) return VM_BAD_ARGUMENT;
    if (s->n_events < 0 || (s->n_events && (!s->events || !s->located))) return VM_BAD_ARGUMENT;
    if (!s->times) return VM_OK;
    if (s->n_times < 0) return VM_BAD_ARGUMENT;
    for (i = 0; i < s->n_times; i++) {
        if (!VM_IS_FINITE(s->times[i])) return VM_NOT_FINITE;
        if (i > 0 && !(s->times[i] > s->times[i - 1])) return VM_BAD_TIMES;
    }
    return VM_OK;
}

VM_API void vmi_scene_set_fault(vm_scene_fault *fault_or_NULL, const char *kind, int index)
{
    if (!fault_or_NULL) return;
    fault_or_NULL->kind = kind;
    fault_or_NULL->index = index;
}

/* Finds the first error in a scene. Returns the status of this error, or VM_OK if nothing is wrong, and writes to
   *fault_or_NULL which body, effect or event is wrong. The time of this check is proportional to the number of bodies,
   effects and events. The function returns the statuses that the comments of the constructors name, and
     VM_BAD_ARGUMENT        if a pointer is NULL, a count is negative, or a body or a function is missing;
     VM_NOT_FINITE          if a parameter, a time or a number of a body is infinite or NaN;
     VM_BAD_MASS, VM_BAD_INERTIA   if a body, or a part that separates, cannot have its mass or its inertia;
     VM_BAD_MOTION          if a body has a kind of motion that its effect, its jump or its constructor does not allow;
     VM_NO_SUCH_BODY, VM_NO_SUCH_COORDINATE, VM_NO_SUCH_EFFECT   if no body, coordinate or effect has the given index;
     VM_TWO_MASS_LAWS       if a body has two mass laws, or a mass law although its mass is a number of the state;
     VM_BAD_ORDER           if a mass law does not stand before the other effects on its body;
     VM_TWO_LINKS           if a body has two links, or a link and joints;
     VM_LINK_NOT_LAST       if another effect on a body follows its link or its joints;
     VM_BAD_POINT           if a spring, joint or contact acts at a point that the body cannot have (points.h);
     VM_NOT_JOINED          if the points of a joint do not fit at the start or move apart (joints.h);
     VM_BAD_TIMES           if the times of output do not increase. */
VM_API int vm_scene_check(const vm_scene *scene, vm_scene_fault *fault_or_NULL)
{
    int i, status = vmi_scene_check_arrays(scene);
    vmi_scene_set_fault(fault_or_NULL, "scene", -1);
    if (status) return status;
    for (i = 0; i < scene->n_bodies; i++) {
        scene->bodies[i].listed_orders = 0;
        status = vmi_scene_check_body(scene->bodies + i);
        if (!status) continue;
        vmi_scene_set_fault(fault_or_NULL, "body", i);
        return status;
    }
    for (i = 0; i < scene->n_effects; i++) {
        status = vmi_scene_check_effect(scene, scene->effects + i);
        if (!status) continue;
        vmi_scene_set_fault(fault_or_NULL, "effect", i);
        return status;
    }
    for (i = 0; i < scene->n_events; i++) {
        status = vmi_scene_check_event(scene, scene->events + i);
        if (!status) continue;
        vmi_scene_set_fault(fault_or_NULL, "event", i);
        return status;
    }
    return VM_OK;
}

#endif
