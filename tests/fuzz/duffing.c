/* Fuzz target: varmass.h, Duffing's oscillator and other odd elastic forces. Exact motions keep their energy, motions
   with slow laws are finite or say why not, and their estimates are not negative. */
#include "bodies.h"

static int fuzz_spring(vm_real x, vm_real *f, void *ctx)
{
    const vm_real *k = (const vm_real *)ctx;
    *f = x * (k[0] + k[1] * x);
    return 0;
}

static void check_exact_duffing(void)
{
    const vm_real c1 = MOSTLY(draw_in(-2, 2)), c3 = MOSTLY(draw_in(-2, 2)), x0 = MOSTLY(draw_in(-2, 2));
    const vm_real v0 = MOSTLY(draw_in(-2, 2)), t = MOSTLY(draw_in(-30, 30));
    const vm_real before = vm_duffing_energy(x0, v0, c1, c3), period = vm_duffing_period(x0, c1, c3);
    const vm_real action = vm_duffing_action(x0, c1, c3);
    vm_real x = 7, v = 7, after;
    vm_duffing_exact_from(t, x0, v0, c1, c3, &x, &v);
    HOLDS(is_nan(x) == is_nan(v));
    HOLDS(is_nan(period) || period > 0);
    HOLDS(is_nan(action) || action >= 0);
    if (fuzz.wild || is_nan(x) || !tame(c1) || !tame(c3) || !tame(x0) || !tame(v0) || !tame(t)) return;
    if (c3 < 0 || c1 < 0 || c1 > 2 || c3 > 2 || VM_FABS(x0) > 2 || VM_FABS(v0) > 2 || VM_FABS(t) > 30) return;
    after = vm_duffing_energy(x, v, c1, c3);
    HOLDS(within(after, before, 128 * EPS * (double)before));
}

/* A user's force against itself: the period and the action are positive, and the motion is back after a period. */
static void check_exact_odd(void)
{
    const vm_real x0 = MOSTLY(draw_in(-2, 2));
    vm_real k[2], x = 7, v = 7, period;
    vm_odd_force force;
    int status;
    k[0] = MOSTLY(draw_in(0.1, 2));
    k[1] = MOSTLY(draw_in(0, 1));
    force = vm_odd_force_user(fuzz_spring, k);
    period = vm_odd_period(&force, x0);
    HOLDS(is_nan(period) || period > 0);
    status = vm_odd_exact_from(&force, period, x0, 0, &x, &v);
    HOLDS(status <= 0);
    if (status) HOLDS(x == 7 && v == 7);
    if (status || fuzz.wild || !tame(k[0]) || !tame(k[1]) || !tame(x0) || k[0] < R(0.1) || k[0] > 2) return;
    if (k[1] < 0 || k[1] > 1 || VM_FABS(x0) > 2) return;
    HOLDS(within(x, x0, R(0.001) * (double)VM_FABS(x0)) && vm_odd_action(&force, x0) >= 0);
}

static void check_slow_duffing(void)
{
    static vm_odd_plan plan;
    const vm_real t_end = MOSTLY(draw_in(-12, 12)), share = draw_in(0, 1);
    vm_real k[2], k_state[2], k_rate[2], at_0, rate;
    vm_odd_problem o;
    vm_odd_motion motion;
    vm_law laws[2];
    int route = draw_byte() % 16 ? draw_below(3) : 9, kind, status;
    k[0] = MOSTLY(draw_in(0.1, 2));
    k[1] = MOSTLY(draw_in(-0.2, 1));
    kind = (int)draw_byte();
    o.force = kind & 1 ? vm_duffing_force(k[0], k[1]) : vm_odd_force_user(fuzz_spring, k);
    if ((kind & 7) == 7) {
        laws[0] = vm_law_linear(k[0], k[1] / 16);
        laws[1] = vm_law_exponential(k[1], k[0] / 16);
        o.force = vm_duffing_force_of_laws(laws);
    }
    at_0 = MOSTLY(draw_log(0.5, 2));
    rate = MOSTLY(draw_in(-0.03, 0.03));
    o.mass = vm_law_linear(at_0, rate);
    at_0 = MOSTLY(draw_log(0.5, 2));
    rate = MOSTLY(draw_in(-0.03, 0.03));
    o.stiffness = vm_law_exponential(at_0, rate);
    o.damping = vm_law_linear(MOSTLY(draw_in(-0.02, 0.03)), 0);
    o.reactive = MOSTLY(draw_in(0, 1));
    o.x = MOSTLY(draw_in(-2, 2));
    o.v = MOSTLY(draw_in(-1, 1));
    if (fuzz.wild && route == VM_ODD_RK87) route = VM_ODD_MEAN; /* wild numbers would integrate for minutes */
    k_state[0] = o.x;
    k_state[1] = o.v;
    STAIN(k_rate);
    status = vm_odd_rhs(0, k_state, k_rate, &o);
    if (status) HOLDS(status < 0 && UNTOUCHED(k_rate));
    else HOLDS(is_finite(k_rate[1]) && k_rate[0] == o.v);
    if (!fuzz.wild && VM_FABS(t_end) < 3 && tame(o.x) && tame(o.v))
        HOLDS(vm_odd_within(&o, t_end, 1, &motion) != VM_NO_LAW);
    status = vm_odd_plan_init(&plan, &o, t_end);
    HOLDS(status <= 0);
    if (status) return;
    HOLDS(VM_FABS(plan.reach) <= VM_FABS(t_end) && plan.n >= 0 && plan.n <= VMI_ODD_PANELS);
    STAIN(motion);
    if (!fuzz.wild && draw_byte() % 8 == 0) {
        status = vm_odd_plan_within(&plan, share * t_end, VM_C(1e-2), &motion);
        HOLDS(status != VM_NO_LAW);
        STAIN(motion);
    }
    status = vm_odd_plan_by_route(&plan, route, share * t_end, VM_C(1e-3), &motion);
    if (status < 0) {
        HOLDS(UNTOUCHED(motion));
        return;
    }
    HOLDS(is_finite(motion.x) && is_finite(motion.v) && motion.error >= 0 && motion.route == route);
}

static void fuzz_duffing(void)
{
    switch (draw_below(4)) {
    case 0: check_slow_duffing(); break;
    case 1: check_exact_odd(); break;
    default: check_exact_duffing();
    }
}
FUZZ_TARGET(duffing)
