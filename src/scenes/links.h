/* scenes/links.h - rigid links and cords between bodies

   A link keeps the distance between two mass centres constant, or the distance between a mass centre and a point whose
   motion is given. A cord is a link that can pull but not push. The force of a link is the reaction to all other
   forces on its ends. Therefore a link must stand last in the list among the effects on a body, and a body has at most
   one link.

       vm_effect pendulum = vm_effect_link(0, VM_GROUND, pivot, NULL, 1, 0, 10); // 1 m long, hung up at pivot(t)

   Tests: tests/test_scene_links.c. */
#ifndef VARMASS_SCENES_LINKS_H
#define VARMASS_SCENES_LINKS_H

#include <string.h>

#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/attitude.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "motions.h"
#include "scene.h"

/* An end of a link: a body, which can accelerate, or a point whose motion is given */
typedef struct VM_TAG(vmi_link_end) {
    vm_real r[3], v[3];
    vm_real a[3];        /* acceleration without the link, m/s^2 */
    vm_real mobility[3]; /* acceleration by a force of 1 N along each coordinate: 1/mass, or 0 if the end cannot move */
} vmi_link_end;

/* Writes to *end an end of a link that is a body. Numbers of *end for directions in which the body cannot move stay
   0. */
VM_API void vmi_link_to_body(const vm_scene *s, int body, const vm_real *y, vmi_link_end *end)
{
    const vm_scene_body *b = s->bodies + body;
    const vm_real *r = y + b->at, *v = r + b->positions;
    const vm_real mobility = 1 / (b->load.mass + b->load.extra_mass);
    const int n = vmi_scene_directions(b->motion);
    int i;
    for (i = 0; i < n; i++) {
        end->r[i] = r[i];
        end->v[i] = v[i];
        end->mobility[i] = mobility;
        end->a[i] = mobility * b->load.force[i];
    }
}

/* Writes to *end an end of a link that is a point with a given motion. No force accelerates this point: its mobility
   stays 0. */
VM_API void vmi_link_to_point(const vm_effect *e, vm_real t, vmi_link_end *end)
{
    vm_vec3 r = {0, 0, 0}, v = {0, 0, 0}, a = {0, 0, 0};
    e->point(t, &r, &v, &a, e->ctx);
    vmi_set3(end->r, r);
    vmi_set3(end->v, v);
    vmi_set3(end->a, a);
}

/* indices of the parameters of a link in p; the field `variant` of a link is 1 for a cord */
enum { VMI_LINK_LENGTH, VMI_LINK_RATE };

/* Computes the factor lambda of the force lambda d that the link exerts on its end `here`; the vector d leads from the
   end `there` to the end `here`. The deviation of the link is C = (d^2 - l^2)/2, where l is the length of the link.
   lambda follows from the condition C'' + 2 rate C' + rate^2 C = 0. In this equation C' = d v and C'' = d a + v^2,
   where v and a are the velocity and acceleration of `here` relative to `there`. The force of the link changes d a by
   lambda S. S is a sum over both ends and all coordinates; each term is the mobility of the end along the coordinate,
   times the square of this coordinate of d. lambda is 0 for a slack cord. Returns VM_SINGULAR if the ends are at one
   place or cannot move along the link, VM_NOT_FINITE if S is NaN or negative, and else VM_OK. */
VM_API int vmi_link_lambda(const vm_effect *e, const vmi_link_end *here, const vmi_link_end *there, vm_real *lambda)
{
    /* A cord does not pull while the distance of its ends is shorter than its length by more than this fraction. The
       fraction is larger than the error of the computed distance, so that the cord does not alternate between taut and
       slack. */
    const vm_real loose = VM_C(1e-6) + 512 * VM_EPSILON;
    const vm_real length = e->p[VMI_LINK_LENGTH], rate = e->p[VMI_LINK_RATE];
    vm_real dd = 0, dv = 0, vv = 0, da = 0, mobility = 0, C; /* scalar products; the sum S; C */
    int i;
    for (i = 0; i < 3; i++) {
        const vm_real v = here->v[i] - there->v[i], d = here->r[i] - there->r[i];
        dd += d * d;
        dv += d * v;
        vv += v * v;
        da += d * (here->a[i] - there->a[i]);
        mobility += d * d * (here->mobility[i] + there->mobility[i]);
    }
    if (mobility == 0) return VM_SINGULAR;
    if (!(mobility > 0)) return VM_NOT_FINITE;
    C = (dd - length * length) / 2;
    *lambda = -(da + vv + 2 * rate * dv + rate * rate * C) / mobility;
    if (e->variant && (*lambda > 0 || C < -loose * dd)) *lambda = 0;
    return VM_OK;
}

VM_API void vmi_apply_link(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    vmi_link_end here, there;
    vm_real lambda = 0;
    int i, status;
    memset(&here, 0, sizeof here);
    memset(&there, 0, sizeof there);
    vmi_link_to_body(s, e->body, y, &here);
    if (e->other_load) vmi_link_to_body(s, e->other, y, &there);
    else vmi_link_to_point(e, t, &there);
    status = vmi_link_lambda(e, &here, &there, &lambda);
    if (status) s->status = status;
    if (lambda == 0) return;
    for (i = 0; i < 3; i++) {
        const vm_real d = here.r[i] - there.r[i];
        if (here.mobility[i] > 0) e->load->force[i] += lambda * d;
        if (e->other_load && there.mobility[i] > 0) e->other_load->force[i] -= lambda * d;
    }
}

VM_API int vmi_link_check(const vm_effect *e)
{
    if (e->p[VMI_LINK_LENGTH] > 0 && e->p[VMI_LINK_RATE] > 0) return VM_OK;
    return VM_DOMAIN;
}

/* Checks the ends of a link. A link acts at mass centres; therefore it cannot act on a growing body, whose mass centre
   moves in the body. */
VM_API int vmi_link_check_ends(const vm_scene *s, const vm_effect *e)
{
    if (e->other == e->body) return VM_SAME_BODY;
    if (s->bodies[e->body].grows) return VM_BAD_MOTION;
    if (e->other >= 0 && s->bodies[e->other].grows) return VM_BAD_MOTION;
    return VM_OK;
}

/* A rigid link of a given length, or a cord, which can only pull. The link keeps the mass centre of `body`, which is a
   point or a body in the plane, at the distance `length` (m) from another mass centre or from a moving point. The other
   mass centre is that of the body `other`, which must not be on an axle; `point_or_NULL` is then NULL. If other is
   VM_GROUND, the function `point_or_NULL` gives the motion of the moving point, which may lie above the plane. If
   `cord` is 1, the link is a cord. Deviations from the length decrease as exp(-rate t) with the time t; rate > 0 is in
   1/s. A cord that becomes taut at the speed v is stretched by about v/(e rate), where e = 2.718. A high rate makes the
   equations of motion stiff, so that the steps become short: in float a rate of 100/s is tested for a cord of 1 m at 6
   m/s. vm_scene_start returns VM_DOMAIN if length or rate is not positive; VM_BAD_MOTION if a body has a kind of motion
   that is not allowed here or is a growing body, whose mass centre moves in the body; VM_TWO_LINKS if a body has a
   second link; VM_LINK_NOT_LAST if another effect on the body follows the link; and VM_SAME_BODY if the link connects a
   body with itself. A run ends with VM_SINGULAR if the ends of the link are at one place, or cannot move along the
   link. */
VM_API vm_effect vm_effect_link(int body, int other, vm_moving_point point_or_NULL, void *ctx, vm_real length, int cord,
                                vm_real rate)
{
    vm_effect e = vmi_effect_between(body, 0, other, 0, point_or_NULL || other >= 0 ? vmi_apply_link : NULL);
    e.p[VMI_LINK_LENGTH] = length;
    e.p[VMI_LINK_RATE] = rate;
    e.variant = cord != 0;
    e.motions = VMI_FLAT;
    e.other_motions = VMI_ALL_MOTIONS & ~(1 << VM_AXLE);
    e.order = VMI_ORDER_LINK;
    e.check = vmi_link_check;
    e.check_in_scene = vmi_link_check_ends;
    e.point = point_or_NULL;
    e.ctx = ctx;
    return e;
}

#endif
