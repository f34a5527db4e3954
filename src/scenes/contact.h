/* scenes/contact.h - contact of bodies with the ground

   The ground is a plane through the point `on`, and `normal` points out of it. A point of a body, or a ball about this
   point, touches the ground while its height over the ground is negative; the height of a ball is that of its lowest
   point. `depth` is this height with the opposite sign. The ground then pushes along the normal with the force
   stiffness * depth - damping * (velocity along the normal). The ground never pulls and has no friction.

       vm_contact wheel = {{0, 0, 0}, 0.3, {0, 0, 0}, {0, 1, 0}, 1e5, 300}; // 0.3 m radius; y points up
       vm_effect effects[] = {vm_effect_gravity(0, 1, -9.81), vm_effect_contact(0, &wheel)};
       vm_event events[] = {vm_then_land(vm_event_contact(0, &wheel))};     // and it does not bounce

   vm_event_contact is an event that happens when the body comes down to the ground. With vm_then_land the body lands
   at this event without a bounce: an impulse takes away the velocity of the point along the normal. Afterwards the
   stiffness of the contact supports the body.

   Tests: tests/test_scene_joints.c. */
#ifndef VARMASS_SCENES_CONTACT_H
#define VARMASS_SCENES_CONTACT_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/attitude.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "events.h"
#include "points.h"
#include "scene.h"

/* A point of a body, or a ball about this point, and the ground on which the point or ball comes down */
typedef struct VM_TAG(vm_contact) {
    vm_vec3 at;        /* m, body axes: the point of the body */
    vm_real radius;    /* m: radius of a ball about the point, >= 0 */
    vm_vec3 on;        /* m: a point of the ground */
    vm_vec3 normal;    /* vector that points out of the ground; its length may be any number > 0 */
    vm_real stiffness; /* N/m, >= 0 */
    vm_real damping;   /* N s/m, >= 0 */
} vm_contact;

/* Height of the ball of a contact over the ground; it is negative while the ball touches the ground. *p is the point
   of the body, and *normal becomes the unit vector out of the ground. */
VM_API vm_real vmi_contact_height(const vm_contact *contact, const vmi_body_point *p, vm_vec3 *normal)
{
    *normal = vmi_unit_vector(contact->normal);
    return vm_dot(vm_sub(p->r, contact->on), *normal) - contact->radius;
}

VM_API void vmi_apply_contact(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_contact *contact = (const vm_contact *)e->parts;
    vmi_body_point p;
    vm_vec3 normal;
    vm_real height, force;
    (void)t;
    vmi_point_now(s, e->body, contact->at, y, &p);
    height = vmi_contact_height(contact, &p, &normal);
    if (height >= 0) return;
    force = -contact->stiffness * height - contact->damping * vm_dot(p.v, normal);
    if (force > 0) vmi_point_push(s->bodies + e->body, &p, vm_scale(force, normal));
    if (!VM_IS_FINITE(force)) s->status = VM_NOT_FINITE;
}

VM_API int vmi_contact_check_parts(const vm_scene *s, int body, const vm_contact *contact)
{
    int status = vmi_point_check(s, body, contact->at);
    if (!VM_IS_FINITE(contact->radius) || !VM_IS_FINITE(contact->stiffness) || !VM_IS_FINITE(contact->damping) ||
        !vmi_vec3_is_finite(contact->on) || !vmi_vec3_is_finite(contact->normal))
        status = vmi_first_error(status, VM_NOT_FINITE);
    if (contact->stiffness < 0) status = vmi_first_error(status, VM_BAD_STIFFNESS);
    if (contact->radius < 0 || contact->damping < 0 || vmi_norm_max(contact->normal) == 0)
        status = vmi_first_error(status, VM_DOMAIN);
    return status;
}

VM_API int vmi_contact_check(const vm_scene *s, const vm_effect *e)
{
    return vmi_contact_check_parts(s, e->body, (const vm_contact *)e->parts);
}

/* Contact of a body with the ground, by a stiffness and a damping that push but never pull. *contact is not copied: if
   an event changes it, the run continues with the change. vm_scene_start returns VM_BAD_ARGUMENT if contact is NULL,
   VM_NOT_FINITE if a number is infinite or NaN, VM_BAD_STIFFNESS if the stiffness is negative, VM_DOMAIN if radius or
   damping is negative or the normal is 0, and VM_BAD_POINT if the body cannot have the point (points.h). */
VM_API vm_effect vm_effect_contact(int body, const vm_contact *contact)
{
    vm_effect e = vmi_effect(body, 0, contact ? vmi_apply_contact : NULL);
    e.parts = contact;
    e.check_in_scene = vmi_contact_check;
    return e;
}

VM_API vm_real vmi_when_contact(const vm_event *e, vm_real t, const vm_real *y)
{
    const vm_contact *contact = (const vm_contact *)e->parts;
    vmi_body_point p;
    vm_vec3 normal;
    (void)t;
    vmi_point_now(e->scene, e->body, contact->at, y, &p);
    return vmi_contact_height(contact, &p, &normal);
}

VM_API int vmi_contact_check_event(const vm_scene *s, const vm_event *e)
{
    if (e->body < 0) return VM_NO_SUCH_BODY;
    return vmi_contact_check_parts(s, e->body, (const vm_contact *)e->parts);
}

/* An event when a body comes down to the ground. Only the fields at, radius, on and normal of *contact are used.
   *contact is not copied and must stay at its place in memory. vm_scene_start returns VM_BAD_ARGUMENT if contact is
   NULL, and otherwise the same errors as for vm_effect_contact. */
VM_API vm_event vm_event_contact(int body, const vm_contact *contact)
{
    vm_event e = vmi_event(body, 0, 0, -1);
    e.when = contact ? vmi_when_contact : NULL;
    e.parts = contact;
    e.check_when = vmi_contact_check_event;
    if (!contact) e.status = VM_BAD_ARGUMENT;
    return e;
}

/* A bound of the rounding errors of the height that vmi_contact_height computes */
VM_API vm_real vmi_contact_rounding(const vm_contact *contact, const vmi_body_point *p, vm_vec3 normal)
{
    const vm_vec3 positions = vm_add(vmi_abs(p->r), vmi_abs(contact->on));
    const vm_real along_normal = vm_dot(positions, vmi_abs(normal));
    return 8 * VM_EPSILON * (along_normal + vmi_norm_max(p->arm) + contact->radius);
}

/* After a landing, lets no event of this contact happen as long as rounding errors could decide the sign of the height.
   The landing leaves the point with almost no velocity along the normal. For some time the height is then smaller than
   its own rounding errors, which can bring it from above 0 to below 0 although the point does not come down. Usually
   the integrator ignores this sign while |height| <= `slack`, but only for the time `quiet`, a small part of a step,
   which may be too short here. Therefore this function sets `quiet` to VM_MAX, and increases `slack` to `rounding` if
   `slack` is smaller than that. The sign counts again as soon as |height| is larger than `slack`. */
VM_API void vmi_contact_rests(const vm_event *e, vm_real rounding)
{
    const vm_scene *s = e->scene;
    int i;
    for (i = 0; i < s->n_events; i++) {
        const vm_event *other = s->events + i;
        ode_event *located = s->located + i;
        if (other->when != vmi_when_contact || other->body != e->body || other->parts != e->parts) continue;
        located->quiet = VM_MAX;
        located->slack = vmi_larger(located->slack, rounding);
    }
}

/* Takes away the velocity of the contact's point along the normal by an impulse, and adds this impulse to the budget.
   The impulse is -v/mobility, where v is this velocity, and `mobility` is the change of this velocity that an impulse
   of 1 N s along the normal causes. */
VM_API int vmi_then_land(vm_event *e, vm_real t, vm_real *y)
{
    const vm_contact *contact = (const vm_contact *)e->parts;
    vm_scene *s = e->scene;
    vm_budget before, after;
    vmi_body_point p;
    vm_vec3 normal, impulse;
    vm_real mobility, v;
    int status;
    if (s->bodies[e->body].away) return VM_IS_AWAY;
    status = vmi_event_weigh(e, t, y);
    if (status) return status;
    vmi_point_now(s, e->body, contact->at, y, &p);
    vmi_contact_height(contact, &p, &normal);
    vmi_contact_rests(e, vmi_contact_rounding(contact, &p, normal));
    v = vm_dot(p.v, normal);
    mobility = vmi_point_mobility(s->bodies + e->body, &p, normal);
    if (v >= 0 || mobility == 0) return VM_OK;
    if (!VM_IS_FINITE(mobility)) return VM_NOT_FINITE;
    impulse = vm_scale(-v / mobility, normal);
    if (s->budget) s->budget->totals(s, y, &before);
    status = vmi_point_kick(s->bodies + e->body, &p, impulse, y);
    if (status || !s->budget) return status;
    s->budget->totals(s, y, &after);
    s->budget->jump_energy += after.energy - before.energy;
    s->budget->impulse = vm_add(s->budget->impulse, impulse);
    s->budget->angular_impulse = vm_add(s->budget->angular_impulse, vm_cross(p.r, impulse));
    return VM_OK;
}

/* Checks a landing: the body must not have a link or a joint, because link and joint would also give the body an
   impulse, which vmi_then_land does not compute */
VM_API int vmi_land_check(const vm_scene *s, const vm_event *e)
{
    if (s->bodies[e->body].listed_orders >> VMI_ORDER_LINK & 1) return VM_TWO_LINKS;
    return VM_OK;
}

/* Lets the body of a vm_event_contact land without a bounce: at the event an impulse takes away the velocity of the
   contact's point along the normal. The other velocities of the body change only by this impulse. Afterwards
   vm_effect_contact supports the body. The events of this contact can happen again after the contact's point has been
   above or below the ground by more than rounding errors. vm_scene_start returns VM_BAD_ARGUMENT if vm_event_contact
   has not made the event, and VM_TWO_LINKS if the body has a link or a joint, whose impulses the event does not
   compute. A run ends with VM_IS_AWAY if the body is not present. */
VM_API vm_event vm_then_land(vm_event event)
{
    event.then = vmi_then_land;
    event.check = vmi_land_check;
    if (!event.parts) event.status = VM_BAD_ARGUMENT;
    return event;
}

#endif
