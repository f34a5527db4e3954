/* Automatic weighing of a liquid (Fig. 13): a vessel on one arm of a bar is filled, and a weight pulls on the other
   arm. The bar rests on a stop until the weight of the liquid turns it. When it has turned by theta_s, the tap shuts
   at once.

     (J0 + m R^2) theta'' = g (m R - D) cos theta - g e sin theta + q (w cos theta - R theta') R,    m' = q */
#include "stage.h"

static const double scale_J0 = 4, scale_R = 0.6, scale_D = 12, scale_q = 2, scale_w = 2, scale_e = 3,
                    scale_shut = 0.02;

static inline void scale_weight(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const double theta = (double)y[e->x], m = ((double)e->load->mass - scale_J0) / (scale_R * scale_R);
    (void)t;
    (void)scene;
    e->load->force[0] += REAL(gravity * ((m * scale_R - scale_D) * cos(theta) - scale_e * sin(theta)));
}

static inline vm_real scale_jet(vm_real t, vm_real theta, vm_real omega, void *ctx) /* torque of the falling liquid */
{
    (void)t;
    (void)omega;
    (void)ctx;
    return REAL(scale_q * scale_w * scale_R * cos((double)theta));
}

static inline void weighing(stage *s)
{
    const double filled = scale_D / scale_R - scale_q * scale_w / gravity; /* kg: then the bar moves */
    int bar, tap, jet;
    stage_clear(s, 20);
    bar = stage_body(s, vm_scene_body_with_mass_state(vm_scene_body_axle(REAL(scale_J0 + filled * scale_R * scale_R), 0, 0)));
    stage_effect(s, vm_effect_custom(bar, VM_GROUND, scale_weight, NULL));
    tap = stage_effect(s, vm_effect_stream(bar, REAL(scale_q * scale_R * scale_R), stage_vec(0, 0, 0), 1));
    jet = stage_effect(s, vm_effect_force(bar, 0, scale_jet, NULL));
    stage_event(s, vm_then_switch(vm_event_position(bar, 0, REAL(scale_shut), 1), tap, 1));
    stage_event(s, vm_then_switch(vm_event_position(bar, 0, REAL(scale_shut), 1), jet, 1));
    stage_event(s, vm_then_stop(vm_event_velocity(bar, 0, 0, -1)));
    s->events[0].most = s->events[1].most = 1;
}
