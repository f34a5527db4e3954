/* varmass.h: Duffing's oscillator and other odd elastic forces, with constant and with slow mass */

static int golden_spring(vm_real x, vm_real *f, void *ctx)
{
    const vm_real *k = (const vm_real *)ctx;
    *f = x * (k[0] + k[1] * (x * x) + k[2] * x);
    return 0;
}

static void try_exact_duffing(void)
{
    int i;
    for (i = 0; i < 60; i++) {
        const vm_real c1 = uniform(-2, 2), c3 = uniform(-1, 2), x0 = uniform(-2, 2), v0 = uniform(-2, 2);
        const vm_real t = uniform(-20, 20);
        vm_real x = 7, v = 7;
        vm_duffing_exact_from(t, x0, v0, c1, c3, &x, &v);
        fold(x);
        fold(v);
        fold(vm_duffing_energy(x0, v0, c1, c3));
        fold(vm_duffing_period(x0, c1, c3));
        fold(vm_duffing_action(x0, c1, c3));
    }
}

static void try_exact_odd(void)
{
    int i;
    for (i = 0; i < 8; i++) {
        const vm_real t = uniform(-20, 20), x0 = uniform(-2, 2), v0 = uniform(-2, 2);
        vm_real k[3], x = 7, v = 7;
        vm_odd_force force;
        k[0] = uniform(0, 2);
        k[1] = uniform(0, 1);
        k[2] = uniform(0, 1);
        force = vm_odd_force_user(golden_spring, k);
        fold(vm_odd_period(&force, uniform(0, 2)));
        fold(vm_odd_action(&force, uniform(0, 2)));
        fold_int(vm_odd_exact_from(&force, t, x0, v0, &x, &v));
        fold(x);
        fold(v);
    }
}

static void fold_odd_motion(int status, const vm_odd_motion *motion)
{
    fold_int(status);
    fold(motion->x);
    fold(motion->v);
    fold(motion->amplitude);
    fold(motion->error);
    fold_int(motion->route);
    fold_int((int)motion->evals);
}

static void try_slow_odd(void)
{
    static vm_odd_plan plan;
    int i, route;
    for (i = 0; i < 4; i++) {
        vm_odd_problem o;
        vm_odd_motion motion;
        vm_real k[3], y[2], d[2] = {7, 7};
        memset(&motion, 0, sizeof motion);
        k[0] = 1;
        k[1] = uniform(0, 1);
        k[2] = 0;
        o.force = i % 2 ? vm_odd_force_user(golden_spring, k) : vm_duffing_force(1, uniform(-1, 1) / 8);
        o.mass = vm_law_linear(1, uniform(-1, 1) / 128);
        o.stiffness = vm_law_exponential(1, uniform(-1, 1) / 128);
        o.damping = vm_law_linear(uniform(0, 1) / 128, 0);
        o.reactive = 1;
        o.x = uniform(0, 1) + 1;
        o.v = uniform(-1, 1) / 2;
        fold_int(vm_odd_plan_init(&plan, &o, 20));
        for (route = VM_ODD_MEAN; route <= VM_ODD_RK87; route++)
            fold_odd_motion(vm_odd_plan_by_route(&plan, route, 15, VM_C(1e-4), &motion), &motion);
        fold_odd_motion(vm_odd_plan_within(&plan, 20, VM_C(0.05), &motion), &motion);
        fold_odd_motion(vm_odd_within(&o, 5, VM_C(0.01), &motion), &motion);
        y[0] = o.x;
        y[1] = o.v;
        fold_int(vm_odd_rhs(1, y, d, &o));
        fold(d[1]);
    }
}

static void try_duffing_of_laws(void)
{
    static vm_odd_plan plan;
    int i, route;
    for (i = 0; i < 4; i++) {
        vm_law laws[2];
        vm_odd_problem o;
        vm_odd_motion motion;
        vm_real y[2], d[2] = {7, 7};
        memset(&motion, 0, sizeof motion);
        laws[0] = vm_law_linear(i % 2 ? -1 : 1, uniform(-1, 1) / 128);
        laws[1] = vm_law_exponential(1, uniform(-1, 1) / 128);
        o.force = vm_duffing_force_of_laws(laws);
        o.mass = vm_law_linear(1, uniform(-1, 1) / 128);
        o.stiffness = vm_law_linear(1, 0);
        o.damping = vm_law_linear(uniform(0, 1) / 128, 0);
        o.reactive = 1;
        o.x = uniform(0, 1) + (i == 3 ? VM_C(0.875) : 2);
        o.v = uniform(-1, 1) / 8;
        fold_int(vm_odd_plan_init(&plan, &o, 20));
        for (route = VM_ODD_MEAN; route <= VM_ODD_RK87; route++)
            fold_odd_motion(vm_odd_plan_by_route(&plan, route, 15, VM_C(1e-4), &motion), &motion);
        y[0] = o.x;
        y[1] = o.v;
        fold_int(vm_odd_rhs(1, y, d, &o));
        fold(d[1]);
    }
}

static void golden_duffing(void)
{
    try_exact_duffing();
    try_exact_odd();
    try_slow_odd();
    try_duffing_of_laws();
}
