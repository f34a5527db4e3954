/* scenes/streams.h - streams of mass into and out of the bodies of a scene

   A stream brings mass into a body or takes mass out of it. The mass of the body must be a number of the state
   (vm_scene_body_with_mass_state). vm_effect_stream is a stream that enters or leaves at the mass centre: it changes
   the mass and exerts a reactive force. Four further effects are for a vm_stream of mechanics/streams.h that enters or
   leaves at a point of a growing body. Each of these four effects is one action of the stream; a scene may have only
   some of them:
     vm_effect_stream_mass    changes mass, mass centre and inertia; the mass centre then moves with r' = v + (M'/M) d
     vm_effect_stream_force   exerts the reactive force M' (u - v) (156)
     vm_effect_stream_moment  exerts the moment d x M' (u - v) about the mass centre (158)
     vm_effect_stream_torque  exerts the torque M' kappa omega2 - I' omega (157)
   Here M is the mass of the body, M' its rate by the stream, u the velocity of the stream's mass, v that of the body,
   and d leads from the mass centre to the point of the stream; mechanics/streams.h explains all symbols.

       vm_scene_body bodies[] = {vm_scene_body_with_mass_state(vm_scene_body_line(20, 0, 3))}; // a wagon in the rain
       vm_vec3 falls = {0, -8, 0};                               // 8 m/s downwards, no velocity along the line
       vm_effect effects[] = {vm_effect_stream(0, 5, falls, 1)}; // 5 kg/s

   Tests: tests/test_scene_streams.c. */
#ifndef VARMASS_SCENES_STREAMS_H
#define VARMASS_SCENES_STREAMS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/inertia.h"
#include "../mechanics/streams.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "growing.h"
#include "mass.h"
#include "motions.h"
#include "scene.h"

VM_API void vmi_apply_stream(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_real rate = e->p[VMI_MASS_RATE];
    (void)t;
    e->load->mass_rate += rate;
    vmi_scene_reactive(e, y, s, rate, e->p + VMI_MASS_U, e->p[VMI_MASS_REACTIVE]);
}

/* A stream that enters or leaves at the mass centre, with its reactive force. rate in kg/s (on an axle kg m^2/s) is
   negative for mass that leaves. The velocity of this mass is u + (1 - reactive) v, where v is the velocity of the
   body: u is absolute if reactive is 1, and relative to the body if reactive is 0; reactive may be any number. The
   components of u are along inertial axes: they do not turn with the body. For a thrust that turns with the body use
   vm_effect_stream_force or vm_effect_custom. The moments of inertia of the body do not change, except on an axle.
   vm_scene_start returns VM_MASS_IS_NO_STATE if the mass of the body is not a number of the state. */
VM_API vm_effect vm_effect_stream(int body, vm_real rate, vm_vec3 u, vm_real reactive)
{
    vm_effect e = vmi_effect(body, 0, vmi_apply_stream);
    e.p[VMI_MASS_U] = u.x;
    e.p[VMI_MASS_U + 1] = u.y;
    e.p[VMI_MASS_U + 2] = u.z;
    e.p[VMI_MASS_REACTIVE] = reactive;
    e.p[VMI_MASS_RATE] = rate;
    e.needs = VMI_NEEDS_MASS_STATE;
    return e;
}

/* A stream at a point of a growing body. The field `seen` has the motion of the body, in the form that vmi_stream_sums
   needs; the field `sum` has the sums that vmi_stream_sums computes */
typedef struct VM_TAG(vmi_crossing) {
    vmi_stream_seen seen;
    vmi_stream_sum sum;
} vmi_crossing;

/* Fills *c with the sums of the stream of an effect. If the caller's function `vary` has written an unknown `motion`
   to the stream, the scene gets the status VM_BAD_ARGUMENT, which ends the run. */
VM_API void vmi_crossing_now(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s, vmi_crossing *c)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_stream stream = *e->stream;
    if (e->vary) e->vary(t, y, &stream, e->ctx);
    c->seen.turn = &b->axes;
    c->seen.slip = vmi_vec3(0, 0, 0);
    if (stream.from) c->seen.slip = vm_scale(stream.rate / e->load->mass, vm_sub(stream.at, stream.from->at));
    c->seen.energy = s->budget != NULL;
    c->seen.v = vmi_scene_moving(b, y + e->v);
    c->seen.omega = vmi_scene_turning(b, y + e->v);
    c->seen.centre = vmi_growth_centre(b, y + b->at);
    if (!vmi_stream_sums(1, &stream, &c->seen, &c->sum)) s->status = VM_BAD_ARGUMENT;
}

/* Adds a reactive force and a moment or torque, in inertial axes, to the load and to the budget.
   vmi_apply_stream_mass adds to the budget the energy of the stream's mass, and the momentum that this mass would have
   at the velocity of the body. This function adds the force and the torque to the momentum and the angular momentum
   that the stream brings per second, and subtracts their power from the field `mixing` of the load. */
VM_API void vmi_crossing_push(const vm_effect *e, vm_scene *s, const vmi_crossing *c, vm_vec3 force, vm_vec3 torque)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_scene_add(b, load->force, force, torque);
    if (!s->budget) return;
    vmi_scene_add(b, load->reactive, force, torque);
    vmi_scene_add(b, load->brought, force, torque);
    load->mixing -= vm_dot(force, c->seen.v) + vm_dot(torque, vmi_times(c->seen.turn, c->seen.omega));
}

VM_API void vmi_apply_stream_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_crossing c;
    vm_vec3 shift, spin, turning;
    vmi_crossing_now(e, t, y, s, &c);
    shift = vm_scale(1 / load->mass, c.sum.crossing);
    load->mass_rate += c.sum.rate;
    load->drift = vm_add(load->drift, vmi_times(c.seen.turn, shift));
    load->centre_rate = vm_add(load->centre_rate, vm_scale(1 / load->mass, c.sum.stored));
    load->inertia_rate = vmi_inertia_plus(load->inertia_rate, 1, c.sum.inertia);
    if (!s->budget) return;
    spin = vmi_inertia_times(&c.sum.inertia, c.seen.omega);
    turning = vm_add(vmi_times(c.seen.turn, spin), vm_cross(vmi_times(c.seen.turn, c.sum.crossing), c.seen.v));
    vmi_scene_add(b, load->brought, vm_scale(c.sum.rate, c.seen.v), turning);
    load->brought_energy += c.sum.brought / 2;
    load->mixing += (c.sum.brought - c.sum.rate * vm_dot(c.seen.v, c.seen.v) - vm_dot(spin, c.seen.omega)) / 2;
}

VM_API void vmi_apply_stream_force(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vm_vec3 force;
    vmi_crossing_now(e, t, y, s, &c);
    force = vm_sub(c.sum.absolute, vm_scale(c.sum.rate - c.sum.carried, c.seen.v));
    vmi_crossing_push(e, s, &c, vm_add(vmi_times(c.seen.turn, c.sum.pushed), force), vmi_vec3(0, 0, 0));
}

VM_API void vmi_apply_stream_moment(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vmi_crossing_now(e, t, y, s, &c);
    vmi_crossing_push(e, s, &c, vmi_vec3(0, 0, 0), vmi_times(c.seen.turn, c.sum.moment));
}

VM_API void vmi_apply_stream_torque(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vm_vec3 torque;
    vmi_crossing_now(e, t, y, s, &c);
    torque = vm_sub(c.sum.own, vmi_inertia_times(&c.sum.inertia, c.seen.omega));
    vmi_crossing_push(e, s, &c, vmi_vec3(0, 0, 0), vmi_times(c.seen.turn, torque));
}

/* Checks a stream by vmi_check_stream. If the stream has a store in the body (stream->from), the store must also lie
   on the line through the point of the stream and the mass centre at the start, which is the origin of body axes. The
   reason is that a scene neglects the angular momentum of the mass that flows from the store to the point; only on
   such a line is this angular momentum 0. */
VM_API int vmi_crossing_check(const vm_effect *e)
{
    const vm_stream *stream = e->stream;
    vm_real moment;
    int status;
    if (!stream) return VM_BAD_ARGUMENT;
    status = vmi_check_stream(stream);
    if (status || !stream->from) return status;
    moment = vmi_norm_max(vm_cross(stream->at, stream->from->at));
    if (moment <= 32 * VM_EPSILON * vmi_norm1(stream->at) * vmi_norm1(stream->from->at)) return VM_OK;
    return VM_STORED_STREAM;
}

VM_API vm_effect vmi_effect_crossing(int body, const vm_stream *stream,
                                     void (*apply)(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s))
{
    vm_effect e = vmi_effect(body, 0, apply);
    e.motions = 1 << VM_PLANE | 1 << VM_FREE;
    e.needs = VMI_NEEDS_GROWING_BODY;
    e.stream = stream;
    e.check = vmi_crossing_check;
    return e;
}

/* Changes mass, mass centre and inertia of a growing body by a stream. *stream is not copied: if an event changes it,
   the run continues with the change. stream->at is a vector in body axes, from the place that the mass centre has in
   the body at the start to the point of the stream. The field `mixing` of the budget is right only if the effects for
   mass, force, moment and torque of the stream are all listed, and if the stream has no store. A stream may have a
   store on the line through the point of the stream and the mass centre; for example, the tank and the nozzle of a
   rocket lie on the rocket's axis. If no other stream of the body has a store, vm_flow_rhs gives the same motion.
   vm_scene_start returns VM_BAD_ARGUMENT if stream is NULL or stream->motion is unknown, VM_BAD_INERTIA if a moment of
   a gyration is negative, VM_STORED_STREAM if the store does not lie on the line through the point of the stream and
   the mass centre, and VM_DOES_NOT_GROW if the body is not a growing body. */
VM_API vm_effect vm_effect_stream_mass(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_mass);
}

/* Reactive force M' (u - v) of a stream at a point of a growing body (156). M' is the rate of the mass, u the velocity
   of the stream's mass and v that of the body. Conditions and errors are those of vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_force(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_force);
}

/* Moment d x M' (u - v) of a stream on a growing body (158). It is the moment about the mass centre of the reactive
   force M' (u - v) of vm_effect_stream_force. The vector d leads from the mass centre to the point of the stream.
   Conditions and errors are those of vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_moment(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_moment);
}

/* Torque M' kappa omega2 - I' omega of a stream on a growing body (157). M' is the rate of the mass, kappa the inertia
   of the stream's mass per kg, and omega2 the angular velocity of this mass. I' is the rate of the inertia of the
   body, and omega the angular velocity of the body. Conditions and errors are those of vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_torque(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_torque);
}

/* An effect of a stream that varies in time. The argument `effect` comes from vm_effect_stream_mass, _force, _moment
   or _torque. At each evaluation the function `vary` receives a copy of the stream, and writes those fields of this
   copy that vary with the time t or the state y. These may be the point, which may move in the body, the rate, the
   velocity or the store (vm_supply_at computes the store of a tank). vm_scene_start returns VM_BAD_ARGUMENT if vary is
   NULL or the effect has no stream. */
VM_API vm_effect vm_effect_varying(vm_effect effect,
                                   void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx),
                                   void *ctx)
{
    effect.vary = vary;
    effect.ctx = ctx;
    if (!effect.stream || !vary) effect.apply = NULL;
    return effect;
}

#endif
