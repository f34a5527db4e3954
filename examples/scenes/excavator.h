/* An excavator of five rigid bodies in the plane (Fig. 10): the base on the ground, the house on it, jib, arm and
   scoop. Pins join them, hydraulic cylinders, which are springs with dampers, hold them, and the ground is elastic.
   From 1 s to 3 s the scoop takes up 400 kg of soil per second, which was at rest. At the end all bodies are at rest.
   Their heights follow from statics: the potential energy of weights and springs is then smallest. */
#include "stage.h"

static inline void excavator(stage *s)
{
    static const double bodies[][4] = {{4000, 3000, 0, 0.5}, {6000, 8000, -0.5, 1.8}, {1500, 3000, 2.5, 3.2},
                                       {800, 600, 4.6, 3.2}, {500, 150, 5, 1.2}}; /* kg, kg m^2, x and y in m */
    static const int between[][2] = {{0, -1}, {0, -1}, {0, -1}, {1, 2}, {2, 3}, {3, 4}};
    static const double ends[][6] = {{-1.5, 0, -1.5, -1, 1e6, 1e5}, {1.5, 0, 1.5, -1, 1e6, 1e5},
                                     {0, 0.2, -3, 0.2, 1e6, 1e5}, {1.2, 1.4, 2.5, 2.9, 2e6, 3e5},
                                     {3, 4.3, 4.5, 4.7, 2e6, 3e5}, {4.9, 3.5, 5.4, 1.4, 2e6, 3e5}}; /* m, N/m, N s/m */
    static vm_point_spring springs[6];
    static vm_joint list[5];
    static vm_real room[VM_JOINTS_WORK(5)];
    static const vm_joints joints = {list, 5, 10, room, VM_LENGTH(room)};
    const vm_vec3 zero = {0, 0, 0};
    int i, soil_comes;
    stage_clear(s, 40);
    for (i = 0; i < 5; i++) {
        stage_plane(s, bodies[i]);
        stage_effect(s, vm_effect_gravity(i, 1, REAL(-gravity)));
    }
    s->bodies[4] = vm_scene_body_with_mass_state(s->bodies[4]);
    for (i = 0; i < 6; i++) {
        springs[i] = stage_spring(s, between[i][0], between[i][1], ends[i]);
        stage_effect(s, vm_effect_point_spring(between[i][0], between[i][1], springs + i));
    }
    soil_comes = stage_effect(s, vm_effect_stream(4, 400, zero, 1));
    s->effects[soil_comes].off = 1;
    list[0] = stage_pin(s, 1, 0, 0, 1); /* the house stands on a pin and a rod */
    list[1] = vm_joint_rod(1, stage_point(s, 1, 1, 1.5), 0, stage_point(s, 0, 1, 0.9), REAL(0.6));
    list[2] = stage_pin(s, 2, 1, 1, 2);
    list[3] = stage_pin(s, 3, 2, 4.4, 4.2);
    list[4] = stage_pin(s, 4, 3, 4.9, 2);
    stage_effect(s, vm_effect_joints(&joints));
    stage_event(s, vm_then_switch(vm_event_at(1), soil_comes, 0));
    stage_event(s, vm_then_switch(vm_event_at(3), soil_comes, 1));
}
