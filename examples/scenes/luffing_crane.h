/* A luffing crane of four rigid bodies in the plane (Fig. 11): the undercarriage on elastic ground, the house on it,
   the jib on a hydraulic cylinder, and the hook block on a rope, which is a rod here. When the rope is vertical for
   the first time, the block picks up body 4, 1500 kg at rest, and then loses 40 kg/s. When the rope is vertical again,
   700 kg drop, and the loss stops. */
#include "stage.h"

static const double rods[][4] = {{1, 1.5, 1, 0.9}, {5.8, 3.5, 5, 7.5}}; /* m: ends of strut and rope */

static inline vm_real rope_swing(vm_real t, const vm_real *y, void *ctx) /* how far its lower end is to the right */
{
    (void)t;
    return stage_between((const stage *)ctx, 3, 2, rods[1], y).x;
}

static inline int heap_below_block(vm_real t, vm_real *y, void *ctx) /* moves body 4 to the place of the block */
{
    const stage *s = (const stage *)ctx;
    (void)t;
    memcpy(y + s->bodies[4].at, y + s->bodies[3].at, 2 * sizeof *y);
    return VM_OK;
}

static inline void luffing_crane(stage *s)
{
    static const double b[][4] = {{6000, 4000, 0, 0.5}, {4000, 5000, -0.4, 2}, {900, 3000, 3, 5},
                                  {200, 60, 5.8, 3}, {1500, 300, 5.8, 3}}; /* kg, kg m^2, x and y in m */
    static const double ends[][6] = {{-2, 0, -2, -1, 1e6, 2e4}, {2, 0, 2, -1, 1e6, 2e4}, {0, 0.2, -3, 0.2, 2e5, 1e4},
                                     {1.5, 1.5, 3, 5, 2e6, 2e4}}; /* m, N/m, N s/m */
    static const int between[][2] = {{0, -1}, {0, -1}, {0, -1}, {1, 2}};
    static vm_point_spring springs[4];
    static vm_event actions[5];
    static vm_joint list[4];
    static vm_real room[VM_JOINTS_WORK(4)];
    static const vm_joints joints = {list, 4, 10, room, VM_LENGTH(room)};
    const vm_event left = vm_event_user(rope_swing, s, -1), right = vm_event_user(rope_swing, s, 1);
    const vm_body part = {700, {0, 0, 140, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    int i, leak;
    stage_clear(s, 8);
    for (i = 0; i < 5; i++) stage_plane(s, b[i]);
    s->bodies[3] = vm_scene_body_with_mass_state(s->bodies[3]);
    for (i = 0; i < 4; i++) {
        springs[i] = stage_spring(s, between[i][0], between[i][1], ends[i]);
        stage_effect(s, vm_effect_gravity(i, 1, REAL(-gravity)));
        stage_effect(s, vm_effect_point_spring(between[i][0], between[i][1], springs + i));
    }
    s->effects[leak = stage_effect(s, vm_effect_stream(3, -40, stage_vec(0, 0, 0), 0))].off = 1;
    list[0] = stage_pin(s, 1, 0, 0, 1); /* the house stands on a pin and a rod */
    list[1] = stage_rod(s, 1, 0, rods[0]);
    list[2] = stage_pin(s, 2, 1, 1, 2.5);
    list[3] = stage_rod(s, 3, 2, rods[1]);
    stage_effect(s, vm_effect_joints(&joints));
    actions[0] = vm_then_user(left, heap_below_block, s);
    actions[1] = vm_then_attach_in_plane(left, 3, 4);
    actions[2] = vm_then_switch(left, leak, 0);
    actions[3] = vm_then_separate_in_plane(right, 3, 4, &part, 1);
    actions[4] = vm_then_switch(right, leak, 1);
    stage_event(s, vm_then_all(left, actions, 3));
    stage_event(s, vm_then_all(right, actions + 3, 2));
    s->events[0].most = s->events[1].most = 1;
}
