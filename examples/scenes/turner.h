/* A wagon turner (Fig. 4) and a tippler with counterweights (Fig. 5): a load m(phi) at the distance e from a fixed
   axle is poured out between the angles fa and fb. Each kilogram that leaves has the angular momentum lam rho^2 omega.

     (J + m rho^2) omega' = Q - (1 - lam) m'(phi) rho^2 omega^2,     Q = T - g (S0 + m e) sin(phi + phase) */
#include "stage.h"

enum turner_stage { FULL, POURING, EMPTY };

typedef struct turner_data {
    double J, rho2, e, S0, m0, fa, fb, fe, torque, phase;
    enum turner_stage stage; /* events change it, so that no step contains a kink of m(phi) */
} turner_data;

static const turner_data turner = {60000, 1.06, 0.4, 5000, 60000, 0.9, 2.5, 2.9, 300000, 0, FULL};
static const turner_data tippler = {99000, 1.14, 0.8, 12000, 40000, 0.8, 1.6, 1.9, 468290, 1.5707963267948966,
                                    FULL};

static inline double turner_load(const turner_data *a, double phi)
{
    if (a->stage == EMPTY) return 0;
    if (a->stage == FULL) return a->m0;
    return a->m0 * (a->fb - phi) / (a->fb - a->fa);
}

static inline int turner_next(vm_real t, vm_real *y, void *ctx)
{
    turner_data *a = (turner_data *)ctx;
    (void)t;
    (void)y;
    a->stage = a->stage == FULL ? POURING : EMPTY;
    return VM_OK;
}

static inline vm_mass_law_values turner_inertia(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const turner_data *a = (const turner_data *)ctx;
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    (void)omega;
    now.mass = REAL(a->J + turner_load(a, (double)phi) * a->rho2);
    now.by_x = a->stage == POURING ? REAL(-a->m0 / (a->fb - a->fa) * a->rho2) : 0;
    return now;
}

static inline vm_real turner_torque(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const turner_data *a = (const turner_data *)ctx;
    (void)t;
    (void)omega;
    return REAL(a->torque - gravity * (a->S0 + turner_load(a, (double)phi) * a->e) * sin((double)phi + a->phase));
}

static inline void turner_scene(stage *s, turner_data *a, double lam)
{
    int body;
    stage_clear(s, 10);
    body = stage_body(s, vm_scene_body_axle(REAL(a->J), 0, 0));
    stage_effect(s, vm_effect_mass_law(body, turner_inertia, a, stage_vec(0, 0, 0), REAL(1 - lam)));
    stage_effect(s, vm_effect_force(body, 0, turner_torque, a));
    stage_event(s, vm_then_user(vm_event_position(body, 0, REAL(a->fa), 1), turner_next, a));
    stage_event(s, vm_then_user(vm_event_position(body, 0, REAL(a->fb), 1), turner_next, a));
    stage_event(s, vm_then_stop(vm_event_position(body, 0, REAL(a->fe), 1)));
}
