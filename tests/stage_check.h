/* stage_check.h - what the tests of scenes share: a stage is started, run and compared with a reference; its balances
   of momentum and energy are checked; a scene is refused with the status and the culprit that are expected. */
#ifndef STAGE_CHECK_H
#define STAGE_CHECK_H
#include "../examples/scenes/stage.h"
#include "check.h"

static const int is_float = PRECISION[0] == 'f';

static inline vm_real size_of(vm_vec3 a) { return VM_SQRT(vm_dot(a, a)); }

/* The error of got is relative to scale. The bound in float is what 1000 steps of 2e-6 add up to. */
static inline void agrees(const char *machine, const char *what, vm_real got, double wanted, double scale,
                          double bound)
{
    check_error(machine, what, "rel", fabs((double)got - wanted) / fabs(scale), is_float ? 5e-4 : bound, wanted,
                (double)got);
}

/* ---- Bodies and parts ---- */

static inline vm_inertia inertia_of(double xx, double yy, double zz, double xy, double xz, double yz)
{
    vm_inertia i;
    i.xx = REAL(xx);
    i.yy = REAL(yy);
    i.zz = REAL(zz);
    i.xy = REAL(xy);
    i.xz = REAL(xz);
    i.yz = REAL(yz);
    return i;
}

/* A part with the same moment of inertia about each axis, at rest in the origin */
static inline vm_body part_of(double mass, double inertia)
{
    vm_body part;
    memset(&part, 0, sizeof part);
    part.mass = REAL(mass);
    part.inertia = inertia_of(inertia, inertia, inertia, 0, 0, 0);
    return part;
}

/* A free body without any symmetry, which moves and turns; its inertia stays one that a body can have when the
   streams of the tests take some of it away. */
static inline vm_body probe(void)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = 6;
    b.inertia = inertia_of(4, 3.5, 3.1, 0.1, -0.2, 0.05);
    b.q.w = REAL(0.8);
    b.q.x = REAL(0.36);
    b.q.y = REAL(-0.48);
    b.r = stage_vec(1, -2, 0.5);
    b.v = stage_vec(0.1, 0.2, -0.1);
    b.omega = stage_vec(0.3, -0.4, 0.6);
    return b;
}

/* ---- Runs ---- */

static inline void begin(stage *s)
{
    vm_scene_fault culprit;
    CHECK(vm_scene_check(&s->scene, &culprit) == VM_OK && culprit.index == -1);
    CHECK(vm_scene_size(&s->scene) <= STAGE_STATE);
    CHECK(stage_start(s) == VM_OK);
}

static inline void run(stage *s, double t_end, int expected)
{
    const int status = stage_run(s, t_end);
    if (status != expected) printf("%s, not %s\n", vm_strerror(status), vm_strerror(expected));
    CHECK(status == expected);
}

/* The scales are a momentum and an energy to which the defects of the book are compared. */
static inline void balanced(stage *s, const char *machine, double momentum, double energy)
{
    vm_budget b;
    memset(&b, 0, sizeof b);
    CHECK(vm_scene_budget_at(&s->scene, s->t, s->y, &b) == VM_OK);
    agrees(machine, "momentum", size_of(b.momentum_defect), 0, momentum, 1e-9);
    agrees(machine, "angular", size_of(b.angular_defect), 0, momentum, 1e-9);
    agrees(machine, "energy", b.energy_defect, 0, energy, 1e-9);
}

/* ---- What is refused ---- */

/* The check names the culprit, "body", "effect", "event" or "scene" and its index; a start is refused with the same
   status and leaves the state as it is. */
static inline void refused(stage *s, int status, const char *kind, int index)
{
    vm_scene_fault found = {NULL, -2};
    vm_real y[STAGE_STATE] = {7};
    CHECK(vm_scene_check(&s->scene, &found) == status && found.index == index && !strcmp(found.kind, kind));
    CHECK(vm_scene_start(&s->scene, 0, y, NULL) == status && y[0] == 7);
    CHECK(strcmp(vm_strerror(status), "unknown status") != 0);
}

#endif
