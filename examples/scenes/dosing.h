/* A belt dosing device (Fig. 12): a lever has a belt on its arm. The load m of the belt turns the lever, which opens
   or closes the gate that feeds the belt.

     (J0 + m R^2) theta'' = g R (m - m_S) - k theta - b theta' + q_in (R w_i - R^2 theta'),    m' = q_in - nu m
     q_in = q* (1 - theta/theta_c), from 0 to 2 q*;  mass that leaves has the lever's velocity */
#include "stage.h"

static const double belt_R = 0.8, belt_nu = 0.25, belt_q = 5, belt_w = 1.5, belt_k = 800, belt_gate = 0.05;

/* An effect of this program on an axle whose moment of inertia J0 + m R^2 is a number of the state */
static inline void belt_feed(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const double R = belt_R, m = ((double)e->load->mass - 12) / (R * R), theta = (double)y[e->x];
    const double opening = fmin(fmax(1 - theta / belt_gate, 0), 2), q = belt_q * opening;
    const double omega = (double)y[e->v], balance = belt_q / belt_nu + belt_q * belt_w / gravity;
    (void)t;
    (void)scene;
    e->load->mass_rate += REAL(R * R * (q - belt_nu * m));
    e->load->force[0] += REAL(gravity * R * (m - balance) + q * (R * belt_w - R * R * omega));
}

static inline void dosing(stage *s, double damping)
{
    int lever;
    stage_clear(s, 10);
    lever = stage_body(s, vm_scene_body_with_mass_state(vm_scene_body_axle(REAL(12 + 18 * belt_R * belt_R), 0, 0)));
    stage_effect(s, vm_effect_custom(lever, VM_GROUND, belt_feed, NULL));
    stage_effect(s, vm_effect_spring(lever, 0, VM_GROUND, 0, REAL(belt_k), 1, 0));
    stage_effect(s, vm_effect_damper(lever, 0, VM_GROUND, 0, REAL(damping)));
    stage_event(s, vm_then_stop(vm_event_position(lever, 0, REAL(-belt_gate), -1)));
    stage_event(s, vm_then_stop(vm_event_position(lever, 0, REAL(belt_gate), 1)));
}
