/* varmass.h, chapters 7.2 to 7.4: exact motions and their approximations, laws of mass, routes to x(t), plans */

static void fold_two(vm_real a, vm_real b)
{
    fold(a);
    fold(b);
}

static void try_oscillators(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_real alpha = uniform(0, 6), t = uniform(0, 50), x0 = uniform(-2, 2), omega0 = uniform(VM_C(0.1), 3);
        const vm_real ratio = uniform(VM_C(0.1), 3), damping = uniform(-1, 1), v0 = uniform(-2, 2);
        vm_real x, v;
        fold(vm_osc_period(x0, omega0, alpha));
        fold(vm_osc_vmax(x0, omega0, alpha));
        vm_osc_exact(t, x0, omega0, alpha, &x, &v);
        fold_two(x, v);
        fold(vm_osc_energy(x, v, omega0, alpha));
        vm_osc_amplitude_phase(x0, v0, omega0, alpha, &x, &v);
        fold_two(x, v);
        vm_osc_exact_from(t, x0, v0, omega0, alpha, &x, &v);
        fold_two(x, v);
        vm_osc_trig(t, x0, omega0, alpha, &x, &v);
        fold_two(x, v);
        vm_osc_jacobi(t, x0, omega0, alpha, &x, &v);
        fold_two(x, v);
        fold(vm_osc_omega_trig(alpha));
        fold(vm_osc_jacobi_parameter(alpha));
        fold(vm_osc_omega_jacobi(alpha));
        fold(vm_osc_amplitude_law(ratio, damping, 1, alpha));
        fold(vm_osc_velocity_law(ratio, damping, 0, alpha));
    }
}

static void try_comparison(void)
{
    static const vm_real alphas[3] = {VM_C(0.5), 2, 5};
    int i;
    for (i = 0; i < 3; i++) {
        const vm_osc_errors c = vm_osc_approximation_errors(alphas[i]);
        fold(c.trig_vmax);
        fold(c.jacobi_vmax);
        fold(c.trig_x);
        fold(c.trig_v);
        fold(c.jacobi_x);
        fold(c.jacobi_v);
    }
}

static int rational(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const vm_real a = *(const vm_real *)ctx;
    *f = 1 + 1 / (1 + a * t * t);
    *rate = -2 * a * t * (*f - 1) * (*f - 1);
    return t > 50;
}

static vm_real rational_by = VM_C(0.0625);

static vm_law some_law(int kind)
{
    static const vm_real times[5] = {-1, 1, 2, 5, 20}, values[5] = {1, 2, VM_C(2.5), 2, VM_C(1.75)};
    const vm_real f0 = uniform(1, 2), f1 = uniform(-1, 1) / 64;
    switch (kind) {
    case 0: return vm_law_linear(f0, f1);
    case 1: return vm_law_quadratic(f0, f1, VM_C(0.0005));
    case 2: return vm_law_exponential(f0, f1);
    case 3: return vm_law_power(f0, f1, VM_C(1.5));
    case 4: return vm_law_table(5, times, values);
    default: {
        vm_law law = vm_law_user(rational, &rational_by);
        law.change_time = uniform(0, 1) < VM_C(0.5) ? 0 : 1;
        return law;
    }
    }
}

static void try_laws(void)
{
    int i;
    for (i = 0; i < 24; i++) {
        const vm_law law = some_law(i % 6);
        const vm_real t = uniform(0, 15);
        vm_real f = 1, rate = 2, integral = 3;
        fold_int(vm_law_at(&law, t, &f, &rate));
        fold_two(f, rate);
        fold_int(vm_law_inverse_integral(&law, t, &integral));
        fold(integral);
        fold_int(vm_law_at(&law, 20 * t, &f, &rate)); /* this refuses some */
        fold_two(f, rate);
    }
}

static vm_osc_problem some_problem(int mass, int stiffness)
{
    vm_osc_problem p;
    memset(&p, 0, sizeof p);
    p.alpha = uniform(1, 5);
    p.mass = some_law(mass);
    p.stiffness = some_law(stiffness);
    p.reactive = uniform(0, 1);
    p.damping = uniform(0, 1) / 64;
    p.x = uniform(-1, 1);
    p.v = uniform(1, 2);
    return p;
}

static void fold_motion(const vm_osc_motion *m)
{
    fold(m->x);
    fold(m->v);
    fold(m->amplitude);
    fold(m->error);
    fold_int(m->route);
    fold_int(m->evals);
}

static void try_ratio_integrals(void)
{
    int i;
    for (i = 0; i < 36; i++) {
        const vm_law f = some_law(i % 6), g = some_law(i / 6);
        vm_real integral = 3;
        fold_int(vm_law_ratio_integral(&f, &g, uniform(0, 15), &integral));
        fold(integral);
    }
}

static void try_osc_loads(void)
{
    const int routes[4] = {VM_ROUTE_TRIG, VM_ROUTE_ATEB, VM_ROUTE_COLLOCATION, VM_ROUTE_RK87};
    int i;
    for (i = 0; i < 8; i++) {
        const vm_law u = some_law(i % 4);
        const vm_real damping_rate = uniform(0, 1) / 1024;
        const vm_law damping = vm_law_linear(uniform(0, 1) / 64, damping_rate);
        vm_osc_problem p = some_problem(i % 3, 0);
        vm_osc_load load;
        vm_osc_motion motion;
        CLEAR(motion);
        fold_int(vm_osc_load_init(&load, &p, &u, &damping));
        fold(vm_osc_load_force(uniform(0, 5), p.x, p.v, &load));
        fold_int(vm_osc_by_route(&p, routes[i % 4], uniform(1, 5), VM_C(1e-5), &motion));
        fold_motion(&motion);
    }
}

static vm_real small_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return VM_C(0.01) * v * (1 - x * x) - VM_C(0.001) * t;
}

static void try_routes(void)
{
    int i, route;
    for (i = 0; i < 8; i++) {
        const vm_osc_problem p = some_problem(i % 6, i % 3);
        const vm_real t = uniform(1, 10);
        vm_osc_motion m;
        memset(&m, 0, sizeof m);
        fold_int(vm_osc_by_route(&p, VM_ROUTE_TRIG, t, 0, &m));
        fold_motion(&m);
        fold_int(vm_osc_by_route(&p, VM_ROUTE_JACOBI, t, 0, &m));
        fold_motion(&m);
        fold_int(vm_osc_by_route(&p, VM_ROUTE_ATEB, t, 0, &m));
        fold_motion(&m);
        for (route = VM_ROUTE_ORDER2; route <= VM_ROUTE_ORDER5; route++) {
            fold_int(vm_osc_by_route(&p, route, t, 0, &m));
            fold_motion(&m);
        }
        fold_int(vm_osc_within(&p, t, VM_C(0.1), &m));
        fold_motion(&m);
    }
    for (i = -1; i <= VM_ROUTE_RK87 + 1; i++) fold_text(vm_osc_route_name(i));
}

static void try_integrated_routes(void)
{
    const vm_osc_problem p = some_problem(0, 5);
    const vm_real tolerance = VM_C(0.001);
    vm_osc_motion m;
    memset(&m, 0, sizeof m);
    fold_int(vm_osc_by_route(&p, VM_ROUTE_COLLOCATION, 2, tolerance, &m));
    fold_motion(&m);
    fold_int(vm_osc_by_route(&p, VM_ROUTE_RK45, 2, tolerance, &m));
    fold_motion(&m);
    fold_int(vm_osc_by_route(&p, VM_ROUTE_RK87, 2, tolerance, &m));
    fold_motion(&m);
}

static void try_osc_plans(void)
{
    int i;
    for (i = 0; i < 4; i++) {
        vm_osc_problem p = some_problem(i, 0);
        vm_osc_motion m;
        vm_osc_plan plan;
        vm_real rates[3] = {1, 2, 3};
        memset(&m, 0, sizeof m);
        if (i % 2) p.force = small_force;
        fold_int(vm_osc_plan_init(&plan, &p));
        fold_int(vm_osc_plan_by_route(&plan, VM_ROUTE_ATEB, 3, 0, &m));
        fold_motion(&m);
        fold_int(vm_osc_plan_within(&plan, 1, VM_C(0.01), &m));
        fold_motion(&m);
        fold_int(vm_osc_by_route(&p, VM_ROUTE_ORDER5, 2, 0, &m)); /* this refuses a force */
        fold_motion(&m);
        fold_int(vm_osc_averaged(&plan, i % 3, 1, uniform(1, 2), rates, rates + 1, rates + 2));
        fold_all(3, rates);
    }
}

static void try_closed_laws(void)
{
    int order;
    for (order = 1; order <= 6; order++) { /* orders 1 and 6 are refused */
        vm_osc_problem p = some_problem(order, 0);
        vm_osc_closed c;
        vm_real x = 1, v = 2;
        memset(&c, 0, sizeof c);
        p.damping = 0;
        p.mass = order % 2 ? vm_law_linear(2, VM_C(0.0625)) : vm_law_exponential(2, VM_C(-0.0625));
        p.stiffness = order % 2 ? vm_law_power(3, VM_C(0.03125), VM_C(0.5)) : vm_law_linear(3, 0);
        fold_int(vm_osc_closed_init(&c, &p, order, 8));
        fold(c.error);
        fold_int(vm_osc_closed_at(&c, uniform(-4, 8), &x, &v));
        fold(x);
        fold(v);
        fold_int(vm_osc_closed_at_order2(&c, 3, &x, &v));
        fold(x);
        fold_int(vm_osc_closed_at_order3(&c, 3, &x, &v));
        fold(v);
    }
}

static void golden_oscillators(void)
{
    try_oscillators();
    try_comparison();
    try_laws();
}

static void golden_routes(void)
{
    try_routes();
    try_integrated_routes();
    try_osc_plans();
    try_closed_laws();
    try_ratio_integrals();
    try_osc_loads();
}
