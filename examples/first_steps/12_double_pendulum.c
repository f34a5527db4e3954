/* A double pendulum on a damped spring. Two bars hang on pins, one below the other, and a damped spring connects the end of the
   lower bar with the ground. The kit computes the forces in both pins together, by the method of Lagrange's multipliers. Only the
   work of the weights and of the damped spring changes the kinetic energy of the bars. The function vm_scene_keep_budget makes
   the kit add up this work in a balance of energy, called the budget. In the output, the "energy that is not accounted for" is
   the difference between this work and the change of the kinetic energy. If the motion were exact, this difference would be 0.

   cc -O2 12_double_pendulum.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_vec3 zero = {0, 0, 0}, upper = {0.5, 0, 0}, lower = {1.5, 0, 0}, left = {-0.5, 0, 0}, right = {0.5, 0, 0};
    const vm_point_spring spring = {{0.5, 0, 0}, {0, -2, 0}, 20, 0.5, 1}; /* 20 N/m, 0.5 N s/m, 1 m long */
    vm_joint list[2];
    vm_real room[VM_JOINTS_WORK(2)], y[12 + VM_BUDGET_STATES], work[VM_SCENE_WORK(12 + VM_BUDGET_STATES)], t = 0;
    vm_joints joints = {list, 2, 10, room, VM_LENGTH(room)};
    vm_scene_body bodies[2];
    vm_effect effects[4];
    vm_scene scene;
    vm_budget budget;
    vm_vec3 r, v;
    int i, status;
    memset(&scene, 0, sizeof scene);
    bodies[0] = vm_scene_body_plane(2, 0.17, upper, 0, zero, 0); /* both lie along x at first */
    bodies[1] = vm_scene_body_plane(1, 0.08, lower, 0, zero, 0);
    list[0] = vm_joint_pin(0, left, VM_GROUND, zero);
    list[1] = vm_joint_pin(1, left, 0, right);
    effects[0] = vm_effect_gravity(0, 1, -9.81);
    effects[1] = vm_effect_gravity(1, 1, -9.81);
    effects[2] = vm_effect_point_spring(1, VM_GROUND, &spring);
    effects[3] = vm_effect_joints(&joints); /* joints stand last */
    scene.bodies = bodies;
    scene.n_bodies = 2;
    scene.effects = effects;
    scene.n_effects = 4;
    vm_scene_keep_budget(&scene, &budget);
    status = vm_scene_start(&scene, t, y, NULL);
    if (csv) fprintf(csv, "t (s),\"upper bar (rad)\",\"lower bar (rad)\"\n");
    for (i = 1; i <= 100 && status >= 0; i++) {
        status = vm_scene_run(&scene, &t, 0.02 * i, y, work, NULL);
        if (csv) fprintf(csv, "%g,%.9f,%.9f\n", t, y[2], y[8]);
    }
    vm_scene_point_at(&scene, 1, right, y, &r, &v);
    vm_scene_budget_at(&scene, t, y, &budget);
    printf("%s: after %g s the end is at (%.4f, %.4f) m\n", vm_strerror(status), t, r.x, r.y);
    printf("the upper pin pulls with (%.3f, %.3f) N\n", list[0].force.x, list[0].force.y);
    printf("energy that is not accounted for is below 1e-4 J: %s\n",
           VM_FABS(budget.energy_defect) < 1e-4 ? "yes" : "no");
    if (csv) fclose(csv);
    return status < 0;
}
