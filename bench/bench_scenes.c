/* varmass.h, scenes: what an effect costs. The right-hand side of a body on a line with none to five effects,
   written by hand, by the kit's inline functions, and as a scene; medians of ratios to the hand-written one and to
   the C library's sin in the same run; then steps of the whole run. Writes effects, ns of each to the CSV file. */
#include "timing.h"
#include <stdio.h>
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

static void sines(void)
{
    vm_real sum = 0, x = (vm_real)0.1;
    long i;
    for (i = 0; i < COUNT; i++) sum += VM_LIBM(sin)(x), x += (vm_real)1e-3;
    sink = sum;
}

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
    static const char *const names[] = {"-", "spring", "damper", "Van der Pol", "gravity", "drive"};
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    vm_real y[2];
    double before = 0;
    set_up();
    puts("scenes: a right-hand side of a line body, ns; inlined: ratio to hand-written; effect: added by it to the "
         "scene");
    printf("%-14s %10s %10s %8s %10s %14s\n", "effect added", "by hand", "inlined", "ratio", "scene",
           "effect x sin");
    if (csv) fprintf(csv, "effects,hand,inlined,scene\n");
    for (effects = 0; effects <= MOST; effects++) {
        timing h, in, s;
        scene.n_effects = effects;
        vm_scene_start(&scene, 0, y, NULL);
        h = time_beside(hand[effects], COUNT, sines, COUNT);
        in = time_beside(inlined[effects], COUNT, hand[effects], COUNT);
        s = time_beside(as_scene, COUNT, sines, COUNT);
        printf("%-14s %10.2f %10.2f %8.2f %10.2f", names[effects], h.ns, in.ns, in.ratio, s.ns);
        if (effects) printf(" %14.2f", s.ratio - before);
        puts("");
        if (csv) fprintf(csv, "%d,%.4g,%.4g,%.4g\n", effects, h.ns, in.ns, s.ns);
        before = s.ratio;
    }
    if (csv) fclose(csv);
    return 0;
}
