/* The broken rotor whose remainder meets the stator (3.3.2, (68)): S1 = (x, y), shaft centre W = S1 + s (cos psi,
   sin psi).

     x'' + w2 x = -s w2 cos psi,  y'' + w2 y = -s w2 sin psi,  psi'' + k psi' = M + s p2 w2 (x sin psi - y cos psi) */
#ifndef STATOR_H
#define STATOR_H
#include "stage.h"

typedef struct stator_data {
    double omega, gap; /* omega is M*; the rim touches the stator if |W| = gap */
} stator_data;

static const double stator_s = 0.5, stator_p2 = 4;

/* The shaft pulls the point W towards the origin; this force also has a moment about S1 */
static inline void stator_shaft(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_real *r = y + e->x, k = e->load->mass;
    vm_real sine, cosine;
    (void)t;
    (void)scene;
    vmi_sincos(r[2], &sine, &cosine);
    e->load->force[0] -= k * (r[0] + REAL(stator_s) * cosine);
    e->load->force[1] -= k * (r[1] + REAL(stator_s) * sine);
    e->load->force[2] += k * REAL(stator_s) * (r[0] * sine - r[1] * cosine);
}

static inline vm_real stator_gap(vm_real t, const vm_real *y, void *ctx)
{
    const double x = (double)y[0] + stator_s * cos((double)y[2]), z = (double)y[1] + stator_s * sin((double)y[2]);
    (void)t;
    return REAL(sqrt(x * x + z * z) - ((const stator_data *)ctx)->gap);
}

static inline void stator(stage *s, const stator_data *a)
{
    const vm_vec3 zero = {0, 0, 0};
    int rotor;
    stage_clear(s, 40);
    rotor = stage_body(s, vm_scene_body_plane(1, REAL(1 / stator_p2), zero, REAL(0.5), zero, 0));
    stage_effect(s, vm_effect_motor(rotor, 2, REAL(a->omega / stator_p2), REAL(1 / stator_p2)));
    stage_effect(s, vm_effect_custom(rotor, VM_GROUND, stator_shaft, NULL));
    stage_event(s, vm_then_stop(vm_event_user(stator_gap, (void *)a, 1)));
}

#endif
