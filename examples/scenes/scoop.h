/* An excavator's scoop (Fig. 10) on an arm of 3 m. From phi = -0.6 to 0.6 it cuts soil that was at rest, with the mass
   m = m1 (phi + 0.6). Then it carries the soil, and at phi = 1.6 its bottom opens: the soil separates with the
   velocity of the scoop.

     (J_a + m L^2) omega' = T - T_c - g (S_a + m L) sin phi - m1 L^2 omega^2 */
#include "stage.h"

static const double scoop_L = 3, scoop_m1 = 750;

static inline double soil(double phi) { return scoop_m1 * ((phi < 0.6 ? phi : 0.6) + 0.6); }

static inline vm_mass_law_values scoop_inertia(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    vm_mass_law_values now = {0, 0, 0, 0};
    const int full = *(const int *)ctx;
    (void)t;
    (void)omega;
    now.mass = REAL(6000 + (full ? soil((double)phi) * scoop_L * scoop_L : 0));
    now.by_x = full && (double)phi < 0.6 ? REAL(scoop_m1 * scoop_L * scoop_L) : 0;
    return now;
}

static inline vm_real scoop_torque(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const int full = *(const int *)ctx;
    (void)t;
    (void)omega;
    return REAL(30000 - (full && (double)phi < 0.6 ? 8000 : 0) -
                gravity * (1500 + (full ? soil((double)phi) : 0) * scoop_L) * sin((double)phi));
}

static inline int scoop_opens(vm_real t, vm_real *y, void *ctx) /* the velocity does not jump */
{
    (void)t;
    (void)y;
    *(int *)ctx = 0;
    return VM_OK;
}

static inline void scoop(stage *s, int *full)
{
    int arm;
    *full = 1;
    stage_clear(s, 2);
    arm = stage_body(s, vm_scene_body_axle(6000, REAL(-0.6), 0));
    stage_effect(s, vm_effect_mass_law(arm, scoop_inertia, full, stage_vec(0, 0, 0), 1));
    stage_effect(s, vm_effect_force(arm, 0, scoop_torque, full));
    stage_event(s, vm_then_user(vm_event_position(arm, 0, REAL(0.6), 1), stage_kink, NULL));
    stage_event(s, vm_then_user(vm_event_position(arm, 0, REAL(1.6), 1), scoop_opens, full));
}
