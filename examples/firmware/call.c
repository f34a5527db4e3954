/* Measures what one call costs on a microcontroller. CALL is an expression with the variables below that calls a
   function of HEADER. It is evaluated TRIALS times with arguments that DRAW sets, most of them at random, and then
   with the arguments listed in HARD. The program prints the largest number of instructions of a call, and the largest
   depth of the stack in all calls. The flash of a call is the size of this program less the size of the program with
   CALL = (a = u). */
#include HEADER
#include "board.h"

volatile vm_real output;
static vm_real u, m, alpha; /* the arguments of CALL */
static uint32_t state = 1;

/* A random number between low and high */
static vm_real between(vm_real low, vm_real high)
{
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * ((vm_real)(state >> 8) / 16777216);
}

#ifdef PLAN
static PLAN plan;
#endif
#ifdef VARMASS_INTEGRATORS_H
static vm_real y[6] = {1, 0}, work[RK87_WORK(2)];
static rk45 run;

static int oscillate(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}
#endif
#ifdef CONSTANT_PLAN
#include CONSTANT_PLAN
#endif
#ifdef VARMASS_H
static vm_osc_problem problem;
static vm_osc_closed made;
static vm_body2 whole2, part2, rest2;
static vm_body whole, part, rest;
static vm_torque_free motion;
static vm_quat attitude;
static vm_vec3 spin;
static vm_scene_body scene_body;
static vm_effect effects[3];
static vm_scene scene;
static vm_real scene_work[RK4_WORK(6)];

static void draw_problem(void)
{
    alpha = between(VM_C(0.5), 5);
    problem.alpha = alpha;
    problem.mass = vm_law_linear(10, between(VM_C(-0.03), VM_C(0.03)));
    problem.stiffness = vm_law_linear(100, 0);
    problem.reactive = between(0, 1);
    problem.damping = between(0, VM_C(0.02));
    problem.x = between(VM_C(-0.2), VM_C(0.2));
    problem.v = between(-1, 1);
}

static void draw_bodies2(void)
{
    whole2.mass = between(1, 10);
    whole2.inertia = whole2.mass * between(1, 2);
    whole2.vx = between(-10, 10);
    whole2.omega = between(-10, 10);
    part2.mass = whole2.mass * between(0, VM_C(0.5)) + VM_C(0.001);
    part2.inertia = part2.mass * VM_C(0.1);
    part2.x = between(VM_C(-0.5), VM_C(0.5));
    part2.vy = between(-10, 10);
    part2.omega = between(-10, 10);
}

static vm_vec3 draw_vector(vm_real largest)
{
    vm_vec3 a;
    a.x = between(-largest, largest);
    a.y = between(-largest, largest);
    a.z = between(-largest, largest);
    return a;
}

/* A body of the given mass with three different moments of inertia, a random attitude and a random motion */
static vm_body draw_body(vm_real mass, vm_real size)
{
    vm_body b;
    const vm_real xx = between(1, 2), yy = between(1, 2), all = mass * size * size;
    b.mass = mass;
    b.inertia.xx = all * xx;
    b.inertia.yy = all * yy;
    b.inertia.zz = all * between(VM_C(1.2), VM_C(1.8));
    b.inertia.xy = all * between(VM_C(-0.1), VM_C(0.1));
    b.inertia.xz = all * between(VM_C(-0.1), VM_C(0.1));
    b.inertia.yz = all * between(VM_C(-0.1), VM_C(0.1));
    b.r = draw_vector(size);
    b.v = draw_vector(10);
    b.omega = draw_vector(10);
    b.q.w = between(VM_C(0.1), 1); /* of any length */
    b.q.x = between(-1, 1);
    b.q.y = between(-1, 1);
    b.q.z = between(-1, 1);
    return b;
}

static void draw_bodies(void)
{
    const vm_real mass = between(1, 10), share = between(VM_C(0.001), VM_C(0.5));
    whole = draw_body(mass, 1);
    part = draw_body(mass * share, VM_C(0.1));
}

/* Draws a free body, and a time at which its attitude is computed */
static void draw_rotation(void)
{
    whole = draw_body(between(1, 10), 1);
    u = between(-1000, 1000);
}

/* Draws a scene: a tray on a spring of any power, with a damper, that loses its load */
static void draw_scene(void)
{
    const vm_real rate = between(VM_C(-0.05), 0);
    scene_body = vm_scene_body_line(between(1, 10), between(-1, 1), between(-1, 1));
    effects[0] = vm_effect_mass(0, VM_MASS_OF_T, rate, 0, 1);
    effects[1] = vm_effect_spring(0, 0, VM_GROUND, 0, between(1, 100), between(1, 4), 0);
    effects[2] = vm_effect_damper(0, 0, VM_GROUND, 0, between(0, 1));
    scene.bodies = &scene_body;
    scene.n_bodies = 1;
    scene.effects = effects;
    scene.n_effects = 3;
    if (vm_scene_start(&scene, 0, y, NULL) != VM_OK) board_print("FAILED ");
}
#endif

static int __attribute__((noinline, noclone)) call(void)
{
    vm_real a = 0, b = 0, c = 0;
    CALL;
    output = a + b + c;
    return 0;
}

enum { DEPTH = 2600 }; /* words of stack filled with a pattern before a call, to count later how many it has used */
static uint32_t most, deepest;

static void __attribute__((noinline)) count_call(void)
{
    const uint32_t paint = 0xdeadbeefu;
    volatile uint32_t *low, here = 0;
    uint32_t before, start, end, used;
    for (low = &here - DEPTH; low < &here - 16; low++) *low = paint;
    before = board_counter();
    start = board_counter();
    call();
    end = board_counter();
    used = board_instructions(start, end) - board_instructions(before, start); /* less those of a reading */
    if (used > most) most = used;
    for (low = &here - DEPTH; *low == paint && low < &here; low++) {}
    used = (uint32_t)(&here - low) * 4;
    if (used > deepest) deepest = used;
}

static void __attribute__((noinline)) draw(void) { DRAW; }

#ifdef HARD
static const vm_real hard[][3] = {HARD};
enum { HARD_ONES = sizeof hard / sizeof *hard };
#else
static const vm_real hard[1][3];
enum { HARD_ONES = 0 };
#endif

static void count_calls(void)
{
    int i;
    for (i = 0; i < TRIALS + HARD_ONES; i++) {
        draw();
        if (i >= TRIALS) {
            u = hard[i - TRIALS][0];
            m = hard[i - TRIALS][1];
            alpha = hard[i - TRIALS][2];
        }
        count_call();
    }
}

int main(void)
{
#ifdef INIT
    INIT;
#endif
    count_calls();
    board_print_number((int32_t)most, 1);
    board_print(" ");
    board_print_number((int32_t)deepest, 1);
    board_print("\n");
    return 0;
}
