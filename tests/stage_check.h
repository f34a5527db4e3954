/* stage_check.h - what the tests of scenes share */
#ifndef STAGE_CHECK_H
#define STAGE_CHECK_H
#include "../examples/scenes/stage.h"
#include "check.h"

static const int is_float = PRECISION[0] == 'f';

/* got against a reference, relative to scale. The bound in float: what 1000 steps of 2e-6 add up to */
static inline void agrees(const char *machine, const char *what, vm_real got, double wanted, double scale,
                          double bound)
{
    check_error(machine, what, "rel", fabs((double)got - wanted) / fabs(scale), is_float ? 5e-4 : bound, wanted,
                (double)got);
}

static inline void run(stage *s, double t_end, int expected)
{
    const int status = stage_run(s, t_end);
    if (status != expected) printf("%s, not %s\n", vm_strerror(status), vm_strerror(expected));
    CHECK(status == expected);
}

static inline void begin(stage *s)
{
    vm_scene_fault culprit;
    CHECK(vm_scene_check(&s->scene, &culprit) == VM_OK && culprit.index == -1);
    CHECK(vm_scene_size(&s->scene) <= STAGE_STATE);
    CHECK(stage_start(s) == VM_OK);
}

static inline vm_real size_of(vm_vec3 a) { return VM_SQRT(vmi_dot(a, a)); }

static inline void balanced(stage *s, const char *machine, double momentum, double energy)
{
    vm_budget b;
    memset(&b, 0, sizeof b);
    CHECK(vm_scene_budget_at(&s->scene, s->t, s->y, &b) == VM_OK);
    agrees(machine, "momentum", size_of(b.momentum_defect), 0, momentum, 1e-9);
    agrees(machine, "angular", size_of(b.angular_defect), 0, momentum, 1e-9);
    agrees(machine, "energy", b.energy_defect, 0, energy, 1e-9);
}

#endif
