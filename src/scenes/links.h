/* scenes/links.h - rigid links between bodies */
#ifndef VARMASS_SCENES_LINKS_H
#define VARMASS_SCENES_LINKS_H

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "scene.h"

/* The far end of a link: a point that moves as given, or another body, which can accelerate */
typedef struct VM_TAG(vmi_link_end) {
    vm_real r[3], v[3], a[3]; /* a: without the link */
    vm_real mobility[3];      /* acceleration by force, of each coordinate */
} vmi_link_end;

VM_API void vmi_link_body(const vm_scene *s, int body, const vm_real *y, vmi_link_end *end)
{
    const vm_scene_body *b = s->bodies + body;
    const vm_real *r = y + b->at, *v = r + b->positions;
    const int n = b->motion == VM_LINE ? 1 : b->motion == VM_PLANE ? 2 : 3;
    int i;
    for (i = 0; i < 3; i++) {
        end->r[i] = i < n ? r[i] : 0;
        end->v[i] = i < n ? v[i] : 0;
        end->mobility[i] = i < n ? 1 / (b->load.mass + b->load.extra) : 0;
        end->a[i] = end->mobility[i] * b->load.force[i];
    }
}

VM_API void vmi_link_point(const vm_effect *e, vm_real t, vmi_link_end *end)
{
    vm_vec3 r = {0, 0, 0}, v = {0, 0, 0}, a = {0, 0, 0};
    int i;
    e->point(t, &r, &v, &a, e->ctx);
    end->r[0] = r.x;
    end->r[1] = r.y;
    end->r[2] = r.z;
    end->v[0] = v.x;
    end->v[1] = v.y;
    end->v[2] = v.z;
    end->a[0] = a.x;
    end->a[1] = a.y;
    end->a[2] = a.z;
    for (i = 0; i < 3; i++) end->mobility[i] = 0;
}

/* The link pulls with lambda d, d = r - far end: C = (d^2 - l^2)/2 obeys C'' + 2 rate C' + rate^2 C = 0, which gives
   lambda from what else acts on its ends. p = length, rate, cord */
VM_API void vmi_apply_link(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vm_scene_body *b = s->bodies + e->body;
    vm_real *force = b->load.force, *far_force = e->other >= 0 ? s->bodies[e->other].load.force : NULL;
    /* shorter by this, a cord does not pull: more than its length is uncertain by, or it would be taut by turns */
    const vm_real rate = e->p[1], loose = VM_C(1e-6) + 512 * VM_EPSILON;
    vmi_link_end here, there;
    vm_real d[3], dd = 0, dv = 0, vv = 0, da = 0, mobility = 0, C, lambda;
    int i;
    vmi_link_body(s, e->body, y, &here);
    if (far_force) vmi_link_body(s, e->other, y, &there);
    else vmi_link_point(e, t, &there);
    for (i = 0; i < 3; i++) {
        const vm_real v = here.v[i] - there.v[i];
        d[i] = here.r[i] - there.r[i];
        dd += d[i] * d[i];
        dv += d[i] * v;
        vv += v * v;
        da += d[i] * (here.a[i] - there.a[i]);
        mobility += d[i] * d[i] * (here.mobility[i] + there.mobility[i]);
    }
    if (!(mobility > 0)) { /* the ends are in one place, or cannot move along the link */
        s->status = mobility == 0 ? VM_SINGULAR : VM_NOT_FINITE;
        return;
    }
    C = (dd - e->p[0] * e->p[0]) / 2;
    lambda = -(da + vv + 2 * rate * dv + rate * rate * C) / mobility;
    if (e->p[2] != 0 && (lambda > 0 || C < -loose * dd)) return; /* slack */
    for (i = 0; i < 3; i++) {
        if (here.mobility[i] > 0) force[i] += lambda * d[i];
        if (far_force && there.mobility[i] > 0) far_force[i] -= lambda * d[i];
    }
}

VM_API int vmi_link_check(const vm_effect *e) { return e->p[0] > 0 && e->p[1] > 0 ? VM_OK : VM_DOMAIN; }

/* a rigid link, or where cord is set one that only pulls, of a length between a body (a point, or in the plane) and
   another (on a line, too) or, other = VM_GROUND, a point that moves as given, which may be above the plane. Links
   are the last of the effects on a body, one of them for a body. Where the ends of a link are in one place, or
   cannot move along it, the run ends with VM_SINGULAR. Deviations of the length (> 0, m) die out as exp(-rate t),
   rate > 0 in 1/s; a cord that becomes taut at a speed v is drawn out by v/(e rate) at most. In float a cord of 1
   m at 5 m/s asks for a rate of not more than 200/s. The link acts at the mass centres, of which a growing body's
   is refused: it wanders. */
VM_API vm_effect vm_effect_link(int body, int other, vm_moving_point point, void *ctx, vm_real length, int cord,
                                vm_real rate)
{
    vm_effect e = vmi_effect(body, 0, other, 0, VMI_FLAT, length, rate, (vm_real)(cord != 0));
    e.order = 2;
    e.other_motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.apply = point || other >= 0 ? vmi_apply_link : NULL;
    e.check = vmi_link_check;
    e.point = point;
    e.ctx = ctx;
    return e;
}

#endif
