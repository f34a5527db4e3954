#include "snippets.h"
int piece(void);
int piece(void)
{
vm_scene_body bodies[] = {vm_scene_line(2, 0.1, 0)};                 // 2 kg, at x = 0.1 m, at rest
vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 1),  // loses 10 g/s, which keeps its velocity
                       vm_effect_spring(0, 0, VM_GROUND, 0, 50, 3, 0)};
vm_scene scene;
vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                          // 2 = vm_scene_size(&scene)
vm_culprit culprit;
int status;
memset(&scene, 0, sizeof scene);                                      // what is not set is zero: not there
scene.bodies = bodies;
scene.n_bodies = 1;
scene.effects = effects;
scene.n_effects = 2;
status = vm_scene_start(&scene, t, y, &culprit);                      // checks, and fills y
if (status < 0) printf("%s %d: %s\n", culprit.kind, culprit.index, vm_strerror(status));
else status = vm_scene_run(&scene, &t, 10, y, work, NULL);            // y[0] = x(10), y[1] = v(10)
    return 0;
}
