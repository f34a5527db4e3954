/* varmass.h, scenes: what an effect costs, and what a body. The right-hand side of a body on a line with a damper, or
   with a damper and one effect more, written by hand, by the kit's inline functions, and as a scene made at run time;
   what the effect adds to the scene less what it adds by hand, over the C library's sin in the same run. Then chains
   of bodies between springs. Writes effect, ns of each to the CSV file. */
#include "timing.h"
#include <stdio.h>
#include "../varmass.h"

enum { COUNT = 2000, CHAINED = 20, LONGEST = 1000 };
static volatile vm_real sink;
static volatile vm_real parameter[6] = {2,         VM_C(0.1), VM_C(0.2),
                                        VM_C(0.3), -1,        VM_C(1.5)}; /* not known to the compiler */

/* A right-hand side COUNT times; the state depends on the derivative before, as in an integrator */
#define LOOP(...)                                                                                           \
    vm_real y[2] = {VM_C(0.3), VM_C(0.1)}, d[2] = {0, 0}, t = 0;                                            \
    const vm_real k = parameter[0], b = parameter[1], c = parameter[2], T = parameter[3], g = parameter[4]; \
    const vm_real a = parameter[5];                                                                         \
    long i;                                                                                                 \
    (void)k, (void)b, (void)c, (void)T, (void)g, (void)a;                                                   \
    for (i = 0; i < COUNT; i++) {                                                                           \
        __VA_ARGS__;                                                                                        \
        y[0] += VM_C(1e-6) * d[0], y[1] += VM_C(1e-6) * d[1], t += VM_C(1e-6);                              \
    }                                                                                                       \
    sink = y[0] + y[1];

static vm_real own_force(vm_real t, vm_real x, vm_real v, void *ctx) { return (void)t, (void)ctx, -x - v; }

#define X y[0]
#define V y[1]
#define EFFECT(name, by_hand, by_function)                             \
    static void hand_##name(void) { LOOP(d[0] = V; d[1] = (by_hand)) } \
    static void inline_##name(void) { LOOP(d[0] = V; d[1] = (by_function)) }
#define DAMPER vm_force_damper(b, V)
EFFECT(damper, -b *V, DAMPER)
EFFECT(linear, -b *V - k * X, DAMPER + vm_force_spring(k, 1, X))
EFFECT(cubic, -b *V - k * X * X * X, DAMPER + vm_force_spring(k, 3, X))
EFFECT(power, -b *V - k * VM_LIBM(pow)(X, a), DAMPER + vm_force_spring(k, a, X))
EFFECT(second, -b *V - c * V, DAMPER + vm_force_damper(c, V))
EFFECT(van_der_pol, -b *V + (b - c * X * X) * V, DAMPER + vm_force_van_der_pol(b, c, X, V))
EFFECT(gravity, -b *V + g, DAMPER + vm_force_gravity(1, g))
EFFECT(drive, -b *V + (T - c * V), DAMPER + vm_force_drive(T, c, V))
EFFECT(harmonic, -b *V + T * VM_LIBM(cos)(c * t + b), DAMPER + vm_force_harmonic(T, c, b, t))
EFFECT(user, -b *V + (-X - V), DAMPER + own_force(t, X, V, NULL))
EFFECT(mass, (-b * V - c * V) / (1 + c * t), (DAMPER + vm_force_stream(c, 0, 0, V)) / (1 + c * t))

static vm_scene_body body[LONGEST];
static vm_effect effect[LONGEST + 1];
static vm_real state[2 * LONGEST], rates[2 * LONGEST];
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
    for (i = 0; i < COUNT; i++) sum += VM_LIBM(sin)(x), x += VM_C(1e-3);
    sink = sum;
}

/* ns of a call: the least of repeats, since differences are wanted, for which medians on a busy machine do not do */
static double least_ns(void (*function)(void), double calls)
{
    double least = call_ns(function, calls);
    int i;
    for (i = 1; i < REPEATS; i++) {
        const double ns = call_ns(function, calls);
        if (ns < least) least = ns;
    }
    return least;
}

static double sine_ns, base_hand, base_scene; /* the latter with the damper alone */

static void measure(FILE *csv, const char *name, void (*hand)(void), void (*inlined)(void), vm_effect added)
{
    const int more = hand != hand_damper, law = added.order == 0;
    double h, in, s;
    scene.n_effects = 1 + more;
    effect[0] = effect[1] = vm_effect_damper(0, 0, VM_GROUND, 0, parameter[1]);
    if (more) effect[!law] = added; /* a mass law stands first */
    vm_scene_start(&scene, 0, state, NULL);
    h = least_ns(hand, COUNT), in = least_ns(inlined, COUNT), s = least_ns(as_scene, COUNT);
    if (!more) base_hand = h, base_scene = s;
    printf("%-18s %8.2f %8.2f %10.2f", name, h, in / h, s);
    if (more) printf(" %10.2f %12.2f", (s - base_scene) / sine_ns, (s - base_scene - (h - base_hand)) / sine_ns);
    puts("");
    if (csv) fprintf(csv, "%s,%.4g,%.4g,%.4g\n", name, h, in, s);
}

static void chain(int n)
{
    double s;
    int i;
    for (i = 0; i < n; i++) body[i] = vm_scene_line(1, 0, i == 0);
    for (i = 0; i <= n; i++)
        effect[i] = vm_effect_linear_spring(i < n ? i : n - 1, 0, i < n ? i - 1 : VM_GROUND, 0, parameter[0], 0);
    scene.n_bodies = n, scene.n_effects = n + 1;
    vm_scene_start(&scene, 0, state, NULL);
    s = least_ns(as_chain, CHAINED);
    printf("%-18d %8.0f %8.2f %10.2f\n", n, s, s / n, s / n / sine_ns);
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    const vm_real k = parameter[0], b = parameter[1], c = parameter[2], T = parameter[3], g = parameter[4];
    int n;
    memset(&scene, 0, sizeof scene);
    body[0] = vm_scene_line(1, VM_C(0.3), VM_C(0.1));
    scene.bodies = body, scene.n_bodies = 1, scene.effects = effect;
    (void)time_beside;
    sine_ns = least_ns(sines, COUNT);
    puts("scenes: a right-hand side of a line body, ns; inlined: ratio to hand-written; added by the effect, x "
         "sin: to\n"
         "the scene; to the scene less by hand");
    printf("%-18s %8s %8s %10s %10s %12s\n", "effect added", "by hand", "inlined", "scene", "adds", "beyond hand");
    if (csv) fprintf(csv, "effect,hand,inlined,scene\n");
#define GROUND VM_GROUND, 0
    measure(csv, "damper alone", hand_damper, inline_damper, vm_effect_damper(0, 0, GROUND, b));
    measure(csv, "linear spring", hand_linear, inline_linear, vm_effect_linear_spring(0, 0, GROUND, k, 0));
    measure(csv, "cubic spring", hand_cubic, inline_cubic, vm_effect_spring(0, 0, GROUND, k, 3, 0));
    measure(csv, "spring, power 1.5", hand_power, inline_power, vm_effect_spring(0, 0, GROUND, k, parameter[5], 0));
    measure(csv, "second damper", hand_second, inline_second, vm_effect_damper(0, 0, GROUND, c));
    measure(csv, "Van der Pol", hand_van_der_pol, inline_van_der_pol, vm_effect_van_der_pol(0, 0, b, c));
    measure(csv, "gravity", hand_gravity, inline_gravity, vm_effect_gravity(0, 0, g));
    measure(csv, "drive", hand_drive, inline_drive, vm_effect_drive(0, 0, T, c));
    measure(csv, "harmonic", hand_harmonic, inline_harmonic, vm_effect_harmonic(0, 0, T, c, b));
    measure(csv, "own force", hand_user, inline_user, vm_effect_user(0, 0, own_force, NULL));
    measure(csv, "mass of time", hand_mass, inline_mass, vm_effect_mass(0, VM_MASS_OF_T, c, 0, 0));
    puts("a chain of bodies between springs, ns of a right-hand side");
    printf("%-18s %8s %8s %10s\n", "bodies", "all", "a body", "x sin");
    for (n = 1; n <= LONGEST; n *= 10) chain(n);
    if (csv) fclose(csv);
    return 0;
}
