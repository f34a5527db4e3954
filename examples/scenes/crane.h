/* A crane and its load on a cord (Fig. 11). The crane of 8 t stands on elastic ground, and the load of 200 kg hangs on
   a link of 6 m. When the link is vertical for the first time, the load picks up 1500 kg that are at rest, and then
   loses 40 kg/s. When the link is vertical again, 700 kg drop, and the loss stops. */
#include "stage.h"

/* x of the load less x of the crane */
static inline vm_real crane_swing(vm_real t, const vm_real *y, void *ctx)
{
    const stage *s = (const stage *)ctx;
    (void)t;
    return y[s->bodies[1].at] - y[s->bodies[0].at];
}

/* Moves the heap that is picked up to the place of the load. */
static inline int crane_over_heap(vm_real t, vm_real *y, void *ctx)
{
    stage *s = (stage *)ctx;
    int i;
    (void)t;
    for (i = 0; i < 3; i++) y[s->bodies[2].at + i] = y[s->bodies[1].at + i];
    return VM_OK;
}

static inline void crane(stage *s)
{
    const vm_vec3 zero = {0, 0, 0};
    int carriage, load, heap, leak;
    vm_body part;
    stage_clear(s, 12);
    carriage = stage_body(s, vm_scene_body_line(8000, 0, 0));
    load = stage_body(
        s, vm_scene_body_with_mass_state(vm_scene_body_point(200, stage_vec(6 * sin(0.3), -6 * cos(0.3), 0), zero)));
    heap = stage_body(s, vm_scene_body_point(1500, stage_vec(0, -6, 0), zero)); /* on the ground: no effect acts on it */
    stage_effect(s, vm_effect_spring(carriage, 0, VM_GROUND, 0, 200000, 1, 0));
    stage_effect(s, vm_effect_gravity(load, 1, REAL(-gravity)));
    leak = stage_effect(s, vm_effect_stream(load, -40, zero, 0));
    s->effects[leak].off = 1;
    stage_effect(s, vm_effect_link(load, carriage, NULL, NULL, 6, 0, 1));
    memset(&part, 0, sizeof part);
    part.mass = 700;
    stage_event(s, vm_then_user(vm_event_user(crane_swing, s, -1), crane_over_heap, s));
    stage_event(s, vm_then_attach(vm_event_user(crane_swing, s, -1), load, heap));
    stage_event(s, vm_then_switch(vm_event_user(crane_swing, s, -1), leak, 0));
    stage_event(s, vm_then_separate(vm_event_user(crane_swing, s, 1), load, heap, &part, 1));
    stage_event(s, vm_then_switch(vm_event_user(crane_swing, s, 1), leak, 1));
    for (leak = 0; leak < 5; leak++) s->events[leak].most = 1;
}
