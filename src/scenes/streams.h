/* scenes/streams.h - streams of mass onto and out of bodies of a scene */
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
    (void)t;
    e->load->mass_rate += e->p[4];
    vmi_scene_reactive(e, y, s, e->p[4], e->p, e->p[3]);
}

/* A stream, for a body whose mass is a state: rate kg/s (on an axle kg m^2/s), u and share as above; it crosses at
   the mass centre and leaves the inertia as it is */
VM_API vm_effect vm_effect_stream(int body, vm_real rate, vm_vec3 u, vm_real share)
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, VMI_ALL_MOTIONS, u.x, u.y, u.z);
    e.p[3] = share;
    e.p[4] = rate;
    e.needs_mass_state = 1;
    e.apply = vmi_apply_stream;
    return e;
}

/* A stream at a point of a growing body: the body as the stream sees it, and what section 5 makes of it. The book
   has what the stream brings with the mass; as mixing, what of that does not go into the body's energy. */
typedef struct VM_TAG(vmi_crossing) {
    vmi_stream_seen seen;
    vmi_stream_sum sum;
} vmi_crossing;

VM_API void vmi_crossing_now(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s, vmi_crossing *c)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_stream stream = *e->stream;
    if (e->vary) {
        e->vary(t, y, &stream, e->ctx);
        stream.from = NULL;
    }
    c->seen.turn = &b->axes;
    c->seen.slip = vmi_vec3(0, 0, 0);
    c->seen.energy = s->book != NULL;
    c->seen.v = vmi_scene_moving(b, y + e->v);
    c->seen.omega = vmi_scene_turning(b, y + e->v);
    c->seen.centre = vmi_growth_centre(b, y + b->at);
    if (!vmi_stream_sums(1, &stream, &c->seen, &c->sum)) s->status = VM_BAD_ARGUMENT; /* an unknown motion */
}

/* A reactive force and a moment or torque, inertial axes */
VM_API void vmi_crossing_push(const vm_effect *e, vm_scene *s, const vmi_crossing *c, vm_vec3 force, vm_vec3 torque)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_scene_add(b, load->force, force, torque);
    if (!s->book) return;
    vmi_scene_add(b, load->reactive, force, torque);
    vmi_scene_add(b, load->brought, force, torque);
    load->mixing -= vmi_dot(force, c->seen.v) + vmi_dot(torque, vmi_times(c->seen.turn, c->seen.omega));
}

VM_API void vmi_apply_stream_mass(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_scene_body *b = s->bodies + e->body;
    vm_load *load = e->load;
    vmi_crossing c;
    vm_vec3 shift, spin, turning;
    vmi_crossing_now(e, t, y, s, &c);
    shift = vmi_scale(1 / load->mass, c.sum.crossing);
    load->mass_rate += c.sum.rate;
    load->drift = vmi_add(load->drift, vmi_times(c.seen.turn, shift));
    load->centre_rate = vmi_add(load->centre_rate, shift);
    load->inertia_rate = vmi_inertia_plus(load->inertia_rate, 1, c.sum.inertia);
    if (!s->book) return;
    spin = vmi_inertia_times(&c.sum.inertia, c.seen.omega);
    turning = vmi_add(vmi_times(c.seen.turn, spin), vmi_cross(vmi_times(c.seen.turn, c.sum.crossing), c.seen.v));
    vmi_scene_add(b, load->brought, vmi_scale(c.sum.rate, c.seen.v), turning);
    load->brought_energy += c.sum.brought / 2;
    load->mixing += (c.sum.brought - c.sum.rate * vmi_dot(c.seen.v, c.seen.v) - vmi_dot(spin, c.seen.omega)) / 2;
}

VM_API void vmi_apply_stream_force(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_crossing c;
    vm_vec3 force;
    vmi_crossing_now(e, t, y, s, &c);
    force = vmi_sub(c.sum.absolute, vmi_scale(c.sum.rate - c.sum.carried, c.seen.v));
    vmi_crossing_push(e, s, &c, vmi_add(vmi_times(c.seen.turn, c.sum.pushed), force), vmi_vec3(0, 0, 0));
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
    torque = vmi_sub(c.sum.own, vmi_inertia_times(&c.sum.inertia, c.seen.omega));
    vmi_crossing_push(e, s, &c, vmi_vec3(0, 0, 0), vmi_times(c.seen.turn, torque));
}

VM_API int vmi_crossing_check(const vm_effect *e)
{
    if (!e->stream) return VM_BAD_ARGUMENT;
    return e->stream->from ? (int)VM_STORED_STREAM : vmi_stream_is_valid(e->stream);
}

VM_API vm_effect vmi_effect_crossing(int body, const vm_stream *stream,
                                     void (*apply)(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s))
{
    vm_effect e = vmi_effect(body, 0, VM_GROUND, 0, 1 << VM_PLANE | 1 << VM_FREE, 0, 0, 0);
    e.needs_mass_state = 2;
    e.stream = stream;
    e.check = vmi_crossing_check;
    e.apply = apply;
    return e;
}

/* A stream of chapter 5 that crosses at a point of a growing body and is put there (in body axes from where the mass
   centre was at first; a stream with a store is refused). Each of what it does is an effect, and each may be left
   out: mass (the mass M, its centre, the inertia; r' = v + (M'/M) d), reactive force M' (u - v) (156), moment
   d x M' (u - v) (158), torque M' kappa omega2 - I' omega (157). A book's mixing is that of streams whose effects are
   all listed. The stream is the caller's; what an event changes in it has changed. */
VM_API vm_effect vm_effect_stream_mass(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_mass);
}

/* Documented with vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_force(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_force);
}

/* Documented with vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_moment(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_moment);
}

/* Documented with vm_effect_stream_mass. */
VM_API vm_effect vm_effect_stream_torque(int body, const vm_stream *stream)
{
    return vmi_effect_crossing(body, stream, vmi_apply_stream_torque);
}

#endif
