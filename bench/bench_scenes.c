/* varmass.h, scenes: the time that an effect takes, and a body. A right-hand side of a body on a line is written by
   hand, by the kit's inline functions, and made as a scene at run time: with none to five effects one after another,
   and with a damper and one more effect, which shows what that effect adds. Then there are chains of bodies between
   springs. */
#include "timing.h"
#include "../varmass.h"

enum { COUNT = 2000, MOST = 5, CHAINED = 20, LONGEST_CHAIN = 1000 };
static volatile vm_real sink;
/* k, b, c, T, g and the exponent a of LOOP, which the compiler does not know */
static volatile vm_real parameter[6] = {2, VM_C(0.1), VM_C(0.2), VM_C(0.3), -1, VM_C(1.5)};

/* A right-hand side COUNT times; the state depends on the derivative before, as in an integrator */
#define LOOP(...)                                                                                           \
    vm_real y[2] = {VM_C(0.3), VM_C(0.1)}, d[2] = {0, 0}, t = 0;                                            \
    const vm_real k = parameter[0], b = parameter[1], c = parameter[2], T = parameter[3], g = parameter[4]; \
    const vm_real a = parameter[5];                                                                         \
    long i;                                                                                                 \
    (void)k;                                                                                                \
    (void)b;                                                                                                \
    (void)c;                                                                                                \
    (void)T;                                                                                                \
    (void)g;                                                                                                \
    (void)a;                                                                                                \
    (void)t;                                                                                                \
    for (i = 0; i < COUNT; i++) {                                                                           \
        __VA_ARGS__;                                                                                        \
        y[0] += VM_C(1e-6) * d[0];                                                                          \
        y[1] += VM_C(1e-6) * d[1];                                                                          \
        t += VM_C(1e-6);                                                                                    \
    }                                                                                                       \
    sink = y[0] + y[1];

static vm_real own_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    (void)ctx;
    return -x - v;
}

#define X y[0]
#define V y[1]
#define FORCES(name, by_hand, by_function)                             \
    static void hand_##name(void) { LOOP(d[0] = V; d[1] = (by_hand)) } \
    static void inline_##name(void) { LOOP(d[0] = V; d[1] = (by_function)) }
#define SPRING vm_force_spring(X, k, 3)
#define DAMPER vm_force_damper(V, b)
FORCES(0, 0, 0)
FORCES(1, -k *X *X *X, SPRING)
FORCES(2, -k *X *X *X - b * V, SPRING + DAMPER)
FORCES(3, -k *X *X *X - b * V + (b - c * X * X) * V, SPRING + DAMPER + vm_force_van_der_pol(X, V, b, c))
FORCES(4, -k *X *X *X - b * V + (b - c * X * X) * V + g,
       SPRING + DAMPER + vm_force_van_der_pol(X, V, b, c) + vm_force_gravity(1, g))
FORCES(5, -k *X *X *X - b * V + (b - c * X * X) * V + g + (T - c * V),
       SPRING + DAMPER + vm_force_van_der_pol(X, V, b, c) + vm_force_gravity(1, g) + vm_force_motor(V, T, c))

FORCES(damper, -b *V, DAMPER)
FORCES(linear, -b *V - k * X, DAMPER + vm_force_spring(X, k, 1))
FORCES(cubic, -b *V - k * X * X * X, DAMPER + SPRING)
FORCES(power, -b *V - k * VM_LIBM(pow)(X, a), DAMPER + vm_force_spring(X, k, a))
FORCES(second, -b *V - c * V, DAMPER + vm_force_damper(V, c))
FORCES(van_der_pol, -b *V + (b - c * X * X) * V, DAMPER + vm_force_van_der_pol(X, V, b, c))
FORCES(gravity, -b *V + g, DAMPER + vm_force_gravity(1, g))
FORCES(drive, -b *V + (T - c * V), DAMPER + vm_force_motor(V, T, c))
FORCES(harmonic, -b *V + T * VM_LIBM(cos)(c * t + b), DAMPER + vm_force_harmonic(t, T, c, b))
FORCES(user, -b *V + (-X - V), DAMPER + own_force(t, X, V, NULL))
FORCES(mass, (-b * V - c * V) / (1 + c * t), (DAMPER + vm_force_stream(V, c, 0, 1)) / (1 + c * t))

static vm_scene_body body[LONGEST_CHAIN];
static vm_effect effect[LONGEST_CHAIN + 1];
static vm_real state[2 * LONGEST_CHAIN], rates[2 * LONGEST_CHAIN];
static vm_scene scene;

static void as_scene(void) { LOOP(vm_scene_rhs(t, y, d, &scene)) }

static void as_chain(void)
{
    int i;
    for (i = 0; i < CHAINED; i++) {
        vm_scene_rhs(0, state, rates, &scene);
        state[0] += VM_C(1e-6) * rates[1];
    }
    sink = state[0];
}

static void sines(void)
{
    vm_real sum = 0, x = VM_C(0.1);
    long i;
    for (i = 0; i < COUNT; i++) {
        sum += VM_LIBM(sin)(x);
        x += VM_C(1e-3);
    }
    sink = sum;
}

/* The scene that has been listed, beside what is written by hand and by inline functions */
static timing three_ways(const char *job, void (*hand)(void), void (*inlined)(void))
{
    vm_scene_start(&scene, 0, state, NULL);
    measure(job, "by hand", "", NO_ERROR, hand, COUNT, "by hand", hand, COUNT);
    measure(job, "inline functions", "", NO_ERROR, inlined, COUNT, "by hand", hand, COUNT);
    return measure(job, "scene", "", NO_ERROR, as_scene, COUNT, "by hand", hand, COUNT);
}

static void one_after_another(void)
{
    static void (*const hand[])(void) = {hand_0, hand_1, hand_2, hand_3, hand_4, hand_5};
    static void (*const inlined[])(void) = {inline_0, inline_1, inline_2, inline_3, inline_4, inline_5};
    static const char *const jobs[] = {"no effect",          "1: spring",      "2: and damper",
                                       "3: and Van der Pol", "4: and gravity", "5: and motor"};
    int n;
    effect[0] = vm_effect_spring(0, 0, VM_GROUND, 0, parameter[0], 3, 0);
    effect[1] = vm_effect_damper(0, 0, VM_GROUND, 0, parameter[1]);
    effect[2] = vm_effect_van_der_pol(0, 0, parameter[1], parameter[2]);
    effect[3] = vm_effect_gravity(0, 0, parameter[4]);
    effect[4] = vm_effect_motor(0, 0, parameter[3], parameter[2]);
    for (n = 0; n <= MOST; n++) {
        scene.n_effects = n;
        three_ways(jobs[n], hand[n], inlined[n]);
    }
}

static timing damper_alone, damper_by_hand;

/* What an effect beside a damper adds: to the scene, and to the scene less what it adds by hand, in sines */
static void adds(const char *name, void (*hand)(void), void (*inlined)(void), vm_effect added)
{
    const int law = added.order == 0; /* a mass law stands first */
    char job[40];
    timing by_hand, in_scene, extra;
    double sine;
    snprintf(job, sizeof job, "damper and %s", name);
    effect[0] = effect[1] = vm_effect_damper(0, 0, VM_GROUND, 0, parameter[1]);
    effect[!law] = added;
    scene.n_effects = 2;
    in_scene = three_ways(job, hand, inlined);
    by_hand = time_beside(hand, COUNT, sines, COUNT);
    sine = by_hand.ns / by_hand.ratio;
    extra.ns = in_scene.ns - damper_alone.ns;
    extra.ratio = extra.ns / sine;
    extra.spread = in_scene.spread;
    bench_row(name, "adds to a scene", "", NO_ERROR, extra, "sin");
    extra.ns -= by_hand.ns - damper_by_hand.ns;
    extra.ratio = extra.ns / sine;
    bench_row(name, "adds beyond its arithmetic", "", NO_ERROR, extra, "sin");
}

static void each_alone(void)
{
    const vm_real k = parameter[0], b = parameter[1], c = parameter[2], T = parameter[3], g = parameter[4];
#define GROUND VM_GROUND, 0
    effect[0] = vm_effect_damper(0, 0, GROUND, b);
    scene.n_effects = 1;
    damper_alone = three_ways("damper", hand_damper, inline_damper);
    damper_by_hand = time_beside(hand_damper, COUNT, sines, COUNT);
    adds("linear spring", hand_linear, inline_linear, vm_effect_linear_spring(0, 0, GROUND, k, 0));
    adds("cubic spring", hand_cubic, inline_cubic, vm_effect_spring(0, 0, GROUND, k, 3, 0));
    adds("spring, power 1.5", hand_power, inline_power, vm_effect_spring(0, 0, GROUND, k, parameter[5], 0));
    adds("second damper", hand_second, inline_second, vm_effect_damper(0, 0, GROUND, c));
    adds("Van der Pol", hand_van_der_pol, inline_van_der_pol, vm_effect_van_der_pol(0, 0, b, c));
    adds("gravity", hand_gravity, inline_gravity, vm_effect_gravity(0, 0, g));
    adds("motor", hand_drive, inline_drive, vm_effect_motor(0, 0, T, c));
    adds("harmonic", hand_harmonic, inline_harmonic, vm_effect_harmonic(0, 0, T, c, b));
    adds("own force", hand_user, inline_user, vm_effect_force(0, 0, own_force, NULL));
    adds("mass of time", hand_mass, inline_mass, vm_effect_mass(0, VM_MASS_OF_T, c, 0, 1));
}

static void chain(int n)
{
    char job[40];
    int i;
    for (i = 0; i < n; i++) body[i] = vm_scene_body_line(1, 0, i == 0);
    for (i = 0; i <= n; i++)
        effect[i] = vm_effect_linear_spring(i < n ? i : n - 1, 0, i < n ? i - 1 : VM_GROUND, 0, parameter[0], 0);
    scene.n_bodies = n;
    scene.n_effects = n + 1;
    vm_scene_start(&scene, 0, state, NULL);
    snprintf(job, sizeof job, "a body of a chain of %d", n);
    measure(job, "scene", "", NO_ERROR, as_chain, (double)CHAINED * n, "sin", sines, COUNT);
}

int main(int argc, char **argv)
{
    int n;
    bench_start(argc, argv, "scenes, a right-hand side of a body on a line, beside one written by hand");
    body[0] = vm_scene_body_line(1, VM_C(0.3), VM_C(0.1));
    scene.bodies = body;
    scene.n_bodies = 1;
    scene.effects = effect;
    one_after_another();
    each_alone();
    for (n = 1; n <= LONGEST_CHAIN; n *= 10) chain(n);
    return bench_end();
}
