/* scenes/check.h - what can be wrong in a scene */
#ifndef VARMASS_SCENES_CHECK_H
#define VARMASS_SCENES_CHECK_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/bodies.h"
#include "../mechanics/vectors.h"
#include "scene.h"

typedef struct VM_TAG(vm_scene_fault) {
    const char *kind; /* "body", "effect", "event", "scene" */
    int index;        /* which one, -1 for the scene itself */
} vm_scene_fault;

VM_API int vmi_scene_check_body(const vm_scene_body *b)
{
    if (b->status) return b->status;
    if (b->motion < VM_LINE || b->motion > VM_FREE || !b->put) return VM_BAD_MOTION;
    if (!vmi_body_finite(&b->start) || !VM_IS_FINITE(b->angle)) return VM_NOT_FINITE;
    if (!(b->start.mass > 0)) return VM_BAD_MASS;
    return b->check ? (b->check)(&b->start) : (int)VM_OK;
}

VM_API int vmi_scene_check_coordinate(const vm_scene *s, int body, int coordinate)
{
    if (body < 0 || body >= s->n_bodies) return VM_NO_SUCH_BODY;
    if (coordinate < 0 || coordinate >= s->bodies[body].coordinates) return VM_NO_SUCH_COORDINATE;
    /* of a free body's rotation there is no coordinate */
    return s->bodies[body].motion == VM_FREE && coordinate > 2 ? VM_NO_SUCH_COORDINATE : VM_OK;
}

/* Mass laws (order 0) first, links (order 2) last, at most one of either kind for a body, which keeps as marks the
   orders of the effects so far */
VM_API int vmi_scene_check_order(vm_scene_body *b, int order)
{
    const int law = 1, others = 2, link = 4, so_far = b->acted;
    b->acted |= 1 << order;
    if (order == 0 && ((so_far & law) || b->mass_is_state)) return VM_TWO_MASS_LAWS;
    if (order == 2 && (so_far & link)) return VM_TWO_LINKS;
    if (order == 0 && (so_far & (others | link))) return VM_BAD_ORDER;
    return order == 1 && (so_far & link) ? VM_LINK_NOT_LAST : VM_OK;
}

VM_API int vmi_scene_check_effect(const vm_scene *s, const vm_effect *e)
{
    int k, status = vmi_scene_check_coordinate(s, e->body, e->coordinate);
    if (!status && e->other != VM_GROUND) status = vmi_scene_check_coordinate(s, e->other, e->other_coordinate);
    if (status) return status;
    if (!e->apply) return VM_BAD_ARGUMENT;
    if (!(e->motions >> s->bodies[e->body].motion & 1)) return VM_BAD_MOTION;
    if (e->not_on_angle && s->bodies[e->body].motion == VM_PLANE && e->coordinate == 2) return VM_NOT_ON_ANGLE;
    if (e->other != VM_GROUND && !(e->other_motions >> s->bodies[e->other].motion & 1)) return VM_BAD_MOTION;
    if (e->order == 2 && e->other == e->body) return VM_SAME_BODY;
    /* a link holds mass centres, which in a growing body wander */
    if (e->order == 2 && (s->bodies[e->body].grows || (e->other >= 0 && s->bodies[e->other].grows)))
        return VM_BAD_MOTION;
    for (k = 0; k < (int)(sizeof e->p / sizeof *e->p); k++)
        if (!VM_IS_FINITE(e->p[k])) return VM_NOT_FINITE;
    if (e->needs_mass_state && !s->bodies[e->body].mass_is_state) return VM_MASS_IS_NO_STATE;
    if (e->needs_mass_state > 1 && !s->bodies[e->body].grows) return VM_DOES_NOT_GROW;
    if (e->check && (status = (e->check)(e)) != 0) return status;
    status = vmi_scene_check_order(s->bodies + e->body, e->order);
    return status || e->other < 0 ? status : vmi_scene_check_order(s->bodies + e->other, e->order);
}

/* A body takes up only what it can move as: on a line or an axle its own kind, a point no spin */
VM_API int vmi_scene_can_jump(int motion, int other)
{
    return motion == other || (other == VM_POINT && motion > VM_AXLE);
}

/* Of what separates: that the body into which it goes can be it */
VM_API int vmi_scene_check_jump(const vm_scene *s, const vm_event *e)
{
    const vm_impulse *j = &e->external;
    int status = vmi_scene_check_coordinate(s, e->jump_body, 0);
    vm_scene_body part;
    if (!status) status = vmi_scene_check_coordinate(s, e->other, 0);
    if (!status && e->jump_body == e->other) status = VM_SAME_BODY;
    if (status) return status;
    if (!vmi_scene_can_jump(s->bodies[e->jump_body].motion, s->bodies[e->other].motion)) return VM_BAD_MOTION;
    if (!(e->motions >> s->bodies[e->jump_body].motion & 1)) return VM_BAD_MOTION;
    if (!vmi_vec3_finite(j->linear) || !vmi_vec3_finite(j->couple) || !vmi_vec3_finite(j->at)) return VM_NOT_FINITE;
    if (e->jumps < 0) return VM_OK;
    part = s->bodies[e->other];
    part.start = e->part;
    return vmi_scene_check_body(&part);
}

VM_API int vmi_scene_check_event(const vm_scene *s, const vm_event *e)
{
    int status = VM_OK;
    if (e->watches && (status = vmi_scene_check_coordinate(s, e->body, e->coordinate)) != 0) return status;
    if (e->status) return e->status;
    if (e->most < 0) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(e->time) || !VM_IS_FINITE(e->value)) return VM_NOT_FINITE;
    if (e->switches && (e->effect < 0 || e->effect >= s->n_effects)) return VM_NO_SUCH_EFFECT;
    return e->check ? (e->check)(s, e) : status;
}

VM_API int vmi_scene_check_arrays(const vm_scene *s)
{
    int i;
    if (!s || s->n_bodies < 1 || !s->bodies || s->n_effects < 0 || (s->n_effects && !s->effects))
        return VM_BAD_ARGUMENT;
    if (s->n_events < 0 || (s->n_events && (!s->events || !s->located))) return VM_BAD_ARGUMENT;
    if (s->times && s->n_times < 0) return VM_BAD_ARGUMENT;
    for (i = 0; s->times && i < s->n_times; i++) {
        if (!VM_IS_FINITE(s->times[i])) return VM_NOT_FINITE;
        if (i > 0 && !(s->times[i] > s->times[i - 1])) return VM_BAD_TIMES;
    }
    return VM_OK;
}

/* Everything that can be wrong with a scene: VM_OK, or what it is, and in *culprit (may be null) where. One pass over
   bodies, effects, events; it marks the bodies. */
VM_API int vm_scene_check(const vm_scene *scene, vm_scene_fault *culprit)
{
    vm_scene_fault c = {"scene", -1};
    int i, status = vmi_scene_check_arrays(scene);
    if (culprit) *culprit = c;
    if (status) return status;
    for (i = 0; !status && i < scene->n_bodies; i++) {
        scene->bodies[i].acted = 0;
        if ((status = vmi_scene_check_body(scene->bodies + i)) != 0) {
            c.kind = "body";
            c.index = i;
        }
    }
    for (i = 0; !status && i < scene->n_effects; i++)
        if ((status = vmi_scene_check_effect(scene, scene->effects + i)) != 0) {
            c.kind = "effect";
            c.index = i;
        }
    for (i = 0; !status && i < scene->n_events; i++)
        if ((status = vmi_scene_check_event(scene, scene->events + i)) != 0) {
            c.kind = "event";
            c.index = i;
        }
    if (culprit) *culprit = c;
    return status;
}

#endif
