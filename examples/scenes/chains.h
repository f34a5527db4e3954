/* Cayley's chains. First, a chain falls from a heap at the edge of a table, so that its links are taken up from rest:
   (M v)' = M g with M = mu x. Second, a mass that hangs over a drum pulls a chain along a plane; the chain is straight
   or comes from a heap. Third, a chain with a mass at its end winds on a fixed drum. */
#include "stage.h"

static inline void chain_heap(stage *s)
{
    int chain;
    stage_clear(s, 10);
    chain = stage_body(s, vm_scene_body_line(REAL(1e-30), REAL(0.1), 0)); /* the mass is 1 kg/m times x */
    stage_effect(s, vm_effect_mass(chain, VM_MASS_OF_X, 1, 0, 1));
    stage_effect(s, vm_effect_gravity(chain, 0, REAL(gravity)));
    stage_event(s, vm_then_stop(vm_event_position(chain, 0, 2, 1)));
}

/* The weight N g of the hanging mass N = M + mu x. If the chain is straight, all of it moves: (M + mu l + J/R^2) x'' =
   N g, where J/R^2 belongs to the drum. */
static inline vm_real hanging(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    (void)v;
    (void)ctx;
    return REAL((2 + 1.5 * (double)x) * gravity);
}

static inline void chain_over_drum(stage *s, int heaped)
{
    int chain;
    stage_clear(s, 10);
    chain = stage_body(s, vm_scene_body_line(REAL(heaped ? 2 + 0.5 : 2 + 1.5 * 3 + 0.5), REAL(0.2), 0));
    if (heaped) stage_effect(s, vm_effect_mass(chain, VM_MASS_OF_X, REAL(1.5), 0, 1));
    stage_effect(s, vm_effect_force(chain, 0, hanging, NULL));
    stage_event(s, vm_then_stop(vm_event_position(chain, 0, 2, 1)));
}

/* The moment of inertia G = M l^2 + mu l^3/3 with the free length l = 3 - R phi. Links that reach the drum stop
   without impact, so that G omega^2 is constant. */
static inline vm_mass_law_values winding_inertia(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const double l = 3 - 0.3 * (double)phi;
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    (void)omega;
    (void)ctx;
    now.mass = REAL(2 * l * l + 0.5 * l * l * l);
    now.by_x = REAL(-0.3 * (4 * l + 1.5 * l * l));
    return now;
}

static inline void chain_winding(stage *s)
{
    int chain;
    stage_clear(s, 10);
    chain = stage_body(s, vm_scene_body_axle(1, 0, 1));
    stage_effect(s, vm_effect_mass_law(chain, winding_inertia, NULL, stage_vec(0, 0, 0), REAL(0.5)));
    stage_event(s, vm_then_stop(vm_event_position(chain, 0, REAL(2 / 0.3), 1)));
}
