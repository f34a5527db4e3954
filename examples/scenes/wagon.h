/* A wagon is filled and then emptied while it moves (Fig. 6): first (M v)' = F - f M g, then M v' = F - f M g

        | for 60 s, q = 400 kg/s fall in without velocity; then 400 kg/s leave with the wagon's velocity
      __v__
     |_____| --> F            M(0) = 20 t, F = 15 kN, rolling resistance f M g */
#include "stage.h"

static inline void wagon(stage *s)
{
    int filling, emptying, body;
    stage_clear(s, 120);
    body = stage_body(s, vm_scene_body_with_mass_state(vm_scene_body_line(20000, 0, 0)));
    stage_effect(s, vm_effect_motor(body, 0, 15000, 0));
    stage_effect(s, vm_effect_gravity(body, 0, REAL(-0.005 * gravity)));
    filling = stage_effect(s, vm_effect_stream(body, 400, stage_vec(0, 0, 0), 1));
    emptying = stage_effect(s, vm_effect_stream(body, -400, stage_vec(0, 0, 0), 0));
    s->effects[emptying].off = 1;
    stage_event(s, vm_then_switch(vm_event_at(60), filling, 1));
    stage_event(s, vm_then_switch(vm_event_at(60), emptying, 0));
}
