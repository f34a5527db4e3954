/* varmass.h, scenes: what an effect costs. A right-hand side of a body on a line with none to five effects, written
   by hand, by the kit's inline functions, and as a scene, beside the hand-written one. */
#include "timing.h"
#include "../varmass.h"

enum { COUNT = 2000, MOST = 5 };
static volatile vm_real sink;
static volatile vm_real parameter[8] = {2,  (vm_real)0.1, (vm_real)0.2, (vm_real)0.3,
                                        -1, (vm_real)0.05}; /* not known to the compiler */
static int effects;

/* A right-hand side COUNT times; the state depends on the derivative before, as in an integrator */
#define LOOP(...)                                                                                           \
    vm_real y[2] = {(vm_real)0.3, (vm_real)0.1}, d[2] = {0, 0};                                             \
    const vm_real k = parameter[0], b = parameter[1], c = parameter[2], T = parameter[3], g = parameter[4]; \
    long i;                                                                                                 \
    (void)k, (void)b, (void)c, (void)T, (void)g;                                                            \
    for (i = 0; i < COUNT; i++) {                                                                           \
        __VA_ARGS__;                                                                                        \
        y[0] += (vm_real)1e-6 * d[0], y[1] += (vm_real)1e-6 * d[1];                                         \
    }                                                                                                       \
    sink = y[0] + y[1];

#define X y[0]
#define V y[1]
#define HAND(n, f) \
    static void hand_##n(void) { LOOP(d[0] = V; d[1] = (f)) }
HAND(0, 0)
HAND(1, -k *X *X *X)
HAND(2, -k *X *X *X - b * V)
HAND(3, -k *X *X *X - b * V + (b - c * X * X) * V)
HAND(4, -k *X *X *X - b * V + (b - c * X * X) * V + g)
HAND(5, -k *X *X *X - b * V + (b - c * X * X) * V + g + (T - c * V))

#define SPRING vm_force_spring(k, 3, X)
#define DAMPER vm_force_damper(b, V)
#define INLINE(n, f) \
    static void inline_##n(void) { LOOP(d[0] = V; d[1] = (f)) }
INLINE(0, 0)
INLINE(1, SPRING)
INLINE(2, SPRING + DAMPER)
INLINE(3, SPRING + DAMPER + vm_force_van_der_pol(b, c, X, V))
INLINE(4, SPRING + DAMPER + vm_force_van_der_pol(b, c, X, V) + g)
INLINE(5, SPRING + DAMPER + vm_force_van_der_pol(b, c, X, V) + g + vm_force_drive(T, c, V))

static vm_scene_body body[1];
static vm_effect effect[MOST];
static vm_scene scene;

static void as_scene(void) { LOOP(vm_scene_rhs(0, y, d, &scene)) }

static void set_up(void)
{
    body[0] = vm_scene_line(1, (vm_real)0.3, (vm_real)0.1);
    effect[0] = vm_effect_spring(0, 0, VM_GROUND, 0, parameter[0], 3, 0);
    effect[1] = vm_effect_damper(0, 0, VM_GROUND, 0, parameter[1]);
    effect[2] = vm_effect_van_der_pol(0, 0, parameter[1], parameter[2]);
    effect[3] = vm_effect_gravity(0, 0, parameter[4]);
    effect[4] = vm_effect_drive(0, 0, parameter[3], parameter[2]);
    scene.bodies = body, scene.n_bodies = 1, scene.effects = effect;
}

int main(int argc, char **argv)
{
    static void (*const hand[])(void) = {hand_0, hand_1, hand_2, hand_3, hand_4, hand_5};
    static void (*const inlined[])(void) = {inline_0, inline_1, inline_2, inline_3, inline_4, inline_5};
    static const char *const jobs[] = {"no effect",          "1: spring",      "2: and damper",
                                       "3: and Van der Pol", "4: and gravity", "5: and drive"};
    vm_real y[2];
    set_up();
    bench_start(argc, argv, "scenes, a right-hand side of a body on a line, beside one written by hand");
    for (effects = 0; effects <= MOST; effects++) {
        const char *job = jobs[effects];
        void (*by_hand)(void) = hand[effects];
        scene.n_effects = effects;
        vm_scene_start(&scene, 0, y, NULL);
        measure(job, "by hand", "", NO_ERROR, by_hand, COUNT, "by hand", by_hand, COUNT);
        measure(job, "inline functions", "", NO_ERROR, inlined[effects], COUNT, "by hand", by_hand, COUNT);
        measure(job, "scene", "", NO_ERROR, as_scene, COUNT, "by hand", by_hand, COUNT);
    }
    return bench_end();
}
