/* A wagon on a bar mechanism (Fig. 7) with the crank angle theta and the position x = r (1 - cos theta). On the way
   out mass that was at rest joins the wagon; on the way back mass leaves with the velocity of the wagon. With G = J +
   M x1^2, x1 = r sin theta and x2 = r cos theta:

     G omega' + (M x1 x2 + mu x1^3) omega^2 = T  out,     G omega' + M x1 x2 omega^2 = T  back */
#include "stage.h"

static const double crank_r = 0.5, crank_mass = 800, crank_mu = 600, crank_J = 300;

static inline vm_mass_law_values crank_inertia(vm_real t, vm_real theta, vm_real omega, void *ctx)
{
    const double x1 = crank_r * sin((double)theta), x = crank_r * (1 - cos((double)theta));
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    (void)omega;
    (void)ctx;
    now.mass = REAL(crank_J + (crank_mass + crank_mu * x) * x1 * x1); /* the effect of its change is in crank_torque */
    return now;
}

static inline vm_real crank_torque(vm_real t, vm_real theta, vm_real omega, void *ctx)
{
    const double x1 = crank_r * sin((double)theta), x2 = crank_r * cos((double)theta), w = (double)omega;
    const double M = crank_mass + crank_mu * crank_r * (1 - cos((double)theta));
    (void)t;
    (void)ctx;
    return REAL(900 - (M * x1 * x2 + (x1 > 0 ? crank_mu * x1 * x1 * x1 : 0)) * w * w);
}

static inline void mechanism(stage *s)
{
    int crank;
    stage_clear(s, 10);
    crank = stage_body(s, vm_scene_body_axle(REAL(crank_J), 0, 2));
    stage_effect(s, vm_effect_mass_law(crank, crank_inertia, NULL, stage_vec(0, 0, 0), 0));
    stage_effect(s, vm_effect_force(crank, 0, crank_torque, NULL));
    stage_event(s, vm_then_user(vm_event_position(crank, 0, REAL(3.14159265358979324), 1), stage_kink, NULL));
    stage_event(s, vm_then_stop(vm_event_position(crank, 0, REAL(6.28318530717958648), 1)));
}
