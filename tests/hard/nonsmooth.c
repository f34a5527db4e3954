/* Forces that are not smooth: x|x|^(alpha-1) for alpha < 1 and between the odd numbers, walls, friction, bounces. */

/* ca and sa at s = x0, alpha = x1; naive: 400 steps of rk4 */
static vm_real ca_path_ours(const vm_real *x) { return ateb_ca(x[0], x[1]); }
static vm_real sa_path_ours(const vm_real *x) { return ateb_sa(x[0], x[1]); }
static vm_real ca_path_naive(const vm_real *x)
{
    vm_real y[2] = {0, 1};
    naive_rk4(ateb_equations, x, 2, y, x[0], 400);
    return y[1];
}
static vm_real sa_path_naive(const vm_real *x)
{
    vm_real y[2] = {0, 1};
    naive_rk4(ateb_equations, x, 2, y, x[0], 400);
    return y[0];
}

/* Force of a spring, alpha = x1, at x0 */
static vm_real spring_ours(const vm_real *x) { return vm_force_spring(x[0], 2, x[1]); }
static vm_real spring_naive(const vm_real *x) { return -2 * x[0] * POW(FABS(x[0]), x[1] - 1); }

/* Period by the integral of dx/sqrt(1 - x^(alpha+1)), midpoint rule, alpha = x0 */
static vm_real period_path_ours(const vm_real *x) { return vm_osc_period(1, 1, x[0]); }
static vm_real period_path_naive(const vm_real *x)
{
    vm_real sum = 0;
    int i;
    for (i = 0; i < 1000; i++) sum += 1 / SQRT(1 - POW(((vm_real)i + VM_C(0.5)) / 1000, x[0] + 1));
    return 4 * SQRT((x[0] + 1) / 2) * sum / 1000;
}
/* Mean of |sa|^x1 |ca|^x2, alpha = x0, by 1000 points of a quarter */
static vm_real mean_path_ours(const vm_real *x) { return ateb_mean(x[0], x[1], x[2]); }
static vm_real mean_path_naive(const vm_real *x)
{
    vm_real sum = 0, sa, ca;
    int i;
    for (i = 0; i < 1000; i++) {
        ateb_saca(((vm_real)i + VM_C(0.5)) / 2000 * ateb_pi(x[0]), x[0], &sa, &ca);
        sum += POW(sa, x[1]) * POW(ca, x[2]);
    }
    return sum / 1000;
}

/* A' of dry friction 1, alpha = x0, m = k = A = 1, averaged; naive: 64 points of a period */
static vm_real friction(vm_real t, vm_real place, vm_real v, void *ctx)
{
    (void)t, (void)place, (void)ctx;
    return v > 0 ? -1 : v < 0 ? 1 : 0;
}
static vm_real friction_ours(const vm_real *x)
{
    vm_osc_problem p;
    vm_osc_plan plan;
    vm_real A_rate, theta_rate, psi_rate;
    memset(&p, 0, sizeof p);
    p.alpha = x[0], p.mass = p.stiffness = vm_law_linear(1, 0), p.x = 1, p.force = friction;
    if (vm_osc_plan_init(&plan, &p)) return VM_NAN;
    if (vm_osc_averaged(&plan, VM_ROUTE_ATEB, 0, 1, &A_rate, &theta_rate, &psi_rate)) return VM_NAN;
    return A_rate;
}
static vm_real friction_naive(const vm_real *x)
{
    vm_real sum = 0;
    int i;
    for (i = 0; i < 64; i++) sum += FABS(ateb_sa((vm_real)i / 32 * ateb_pi(x[0]), x[0]));
    return -SQRT(2 / (x[0] + 1)) * sum / 64;
}

/* x(t), t = x0, of x'' = -x|x|^(alpha-1), alpha = 0 or 2 (x1), by rk45: the branch kept and changed at x = 0 */
typedef struct branch {
    vm_real sign, alpha;
} branch;
static int branched(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const branch *b = (const branch *)ctx;
    (void)t;
    dydt[0] = y[1], dydt[1] = -b->sign * (b->alpha > 1 ? y[0] * y[0] : 1);
    return 0;
}
static vm_real branch_side(vm_real t, const vm_real *y, void *ctx)
{
    (void)t, (void)ctx;
    return y[0];
}
static void other_branch(vm_real t, vm_real *y, void *ctx)
{
    branch *b = (branch *)ctx;
    (void)t;
    b->sign = y[1] > 0 ? 1 : -1;
}
static vm_real branches_ours(const vm_real *x)
{
    vm_real y[2] = {1, 0}, work[RK45_WORK(2)];
    branch b = {1, 0};
    rk45 s;
    ode_event side;
    rk45_options o;
    memset(&side, 0, sizeof side), memset(&o, 0, sizeof o);
    side.g = branch_side, side.ctx = &b, side.action = ODE_RESTART, side.change = other_branch;
    b.alpha = x[1], o.rtol = R(VM_C(1e-11), VM_C(3e-6)), o.events = &side, o.n_events = 1;
    if (rk45_init(&s, branched, &b, 2, 0, y, &o, work) < 0 || rk45_solve(&s, x[0]) < 0) return VM_NAN;
    return s.y[0];
}
static void unbranched(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)t;
    dydt[0] = y[1], dydt[1] = y[0] == 0 ? 0 : -VM_COPYSIGN(POW(FABS(y[0]), x[1]), y[0]);
}
static vm_real branches_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0};
    naive_rk4(unbranched, x, 2, y, x[0], 200);
    return y[0];
}

/* Height at t = x0 of a ball that falls from 1 under g = 2 and keeps x1 of its speed in a bounce */
static int falling(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[1], dydt[1] = -2;
    return 0;
}
static void bounce(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    y[0] = 0, y[1] = -y[1] * *(const vm_real *)ctx;
}
static vm_real bounces_ours(const vm_real *x)
{
    vm_real y[2] = {1, 0}, work[RK45_WORK(2)], keeps = x[1];
    rk45 s;
    ode_event floor_event;
    rk45_options o;
    memset(&floor_event, 0, sizeof floor_event), memset(&o, 0, sizeof o);
    floor_event.g = branch_side, floor_event.ctx = &keeps, floor_event.direction = -1;
    floor_event.action = ODE_RESTART, floor_event.change = bounce;
    o.events = &floor_event, o.n_events = 1;
    if (rk45_init(&s, falling, NULL, 2, 0, y, &o, work) < 0 || rk45_solve(&s, x[0]) < 0) return VM_NAN;
    return s.y[0];
}
static vm_real bounces_naive(const vm_real *x)
{
    vm_real y = 1, v = 0;
    const vm_real h = x[0] / 2000;
    int i;
    for (i = 0; i < 2000; i++) {
        y += v * h - h * h, v -= 2 * h;
        if (y < 0) y = 0, v = -v * x[1];
    }
    return y;
}

/* Fourier coefficients c_1 + x0 c_3 of ca for alpha = 0, by 16 points of a period */
static vm_real arcs_ours(const vm_real *x)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.mass = f.stiffness = f.frequency = vm_law_linear(1, 0);
    f.force = vm_law_linear(0, 0);
    return vm_forced_init(&f) == VM_OK ? f.c[0] + x[0] * f.c[1] : VM_NAN;
}
static vm_real arcs_naive(const vm_real *x)
{
    vm_real sum = 0;
    int i;
    for (i = 0; i < 16; i++) {
        const vm_real angle = VM_PI / 8 * (vm_real)i;
        sum += ateb_ca((vm_real)i / 4, 0) * (COS(angle) + x[0] * COS(3 * angle));
    }
    return sum / 8;
}

/* The problem of m = 1/k = 1 + x1 t by collocation, which has no power of x in it; t = x0, alpha = x2 */
static vm_real rough_spring_ours(const vm_real *x)
{
    const vm_osc_problem p = adiabatic_problem(x);
    vm_osc_motion motion;
    return vm_osc_by_route(&p, VM_ROUTE_COLLOCATION, x[0], R(VM_C(1e-11), VM_C(1e-4)), &motion) >= 0 ? motion.x : VM_NAN;
}
static vm_real rough_spring_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0};
    naive_rk4(adiabatic_equations, x, 2, y, x[0], (long)(x[0] * 16));
    return y[0];
}

static const hard_case nonsmooth_cases[] = {
    CASE(ca_path, 4, "ca for alpha = 0 by rk4: the force jumps at every zero of x", 9.3, 0),
    CASE(sa_path, 4, "sa for alpha = 0 by rk4: the velocity has corners", 9.3, 0),
    CASE(ca_path, 4, "ca for alpha = 1/1024 by rk4: the force nearly jumps at x = 0", 9.3, 0.0009765625),
    CASE(ca_path, 4, "ca for alpha = 1/8 by rk4: the slope of the force is infinite at x = 0", 9.3, 0.125),
    CASE(sa_path, 4, "sa for alpha = 1/4 by rk4: the slope of the force is infinite at x = 0", 9.3, 0.25),
    CASE(ca_path, 4, "ca for alpha = 1/2 by rk4: the force is a square root", 9.3, 0.5),
    CASE(ca_path, 4, "ca for alpha = 3/4 by rk4: the slope of the force is infinite at x = 0", 19.3, 0.75),
    CASE(sa_path, 4, "sa for alpha = 3/2 by rk4: the second derivative of the force is infinite at x = 0", 99.3, 1.5),
    CASE(ca_path, 4, "ca for alpha = 2 by rk4: the second derivative of the force jumps at x = 0", 199.3, 2),
    CASE(ca_path, 4, "ca for alpha = 5/2 by rk4: the third derivative of the force is infinite at x = 0", 199.3, 2.5),
    CASE(ca_path, 4, "ca for alpha = 33.3 by rk4: the motion reverses in a short time", 100.3, 33.3),
    CASE(sa_path, 4, "sa for alpha = 100 by rk4: the force rises as steeply as that of a soft wall", 310.3, 100),
    CASE(ca_path, 4, "ca for alpha = 1000 by rk4: the force rises as steeply as that of a wall", 2510.7, 1000),
    CASE(sa_path, 4, "sa for alpha = 1000 by rk4: the velocity nearly jumps", 2000.7, 1000),
    CASE(spring, 2, "force as x abs(x)^(alpha-1) at x = 0 for alpha = 1/2: the power is infinite", 0, 0.5),
    CASE(spring, 2, "force as x abs(x)^(alpha-1) at x = 0 for alpha = 0: the power is infinite", 0, 0),
    CASE(period_path, 4,
         "period for alpha = 3 as an integral by the midpoint rule: the integrand is infinite at the end", 3),
    CASE(period_path, 4,
         "period for alpha < 1 as an integral by the midpoint rule: the integrand is infinite at the end", 0.3),
    CASE(period_path, 4, "period for alpha = 1000 by the midpoint rule: the integrand changes only close to the end",
         1000),
    CASE(mean_path, 4, "mean of abs(sa)^-0.9: the integrand is infinite at sa = 0", 3, -0.9, 0),
    CASE(mean_path, 4, "mean of abs(ca)^-0.5 for alpha = 100: the integrand is infinite at ca = 0", 100, 0, -0.5),
    CASE(friction, 64,
         "decay of the amplitude by dry friction, averaged over 64 points of a period: the friction jumps", 3),
    CASE(friction, 64, "the same decay for alpha = 1/2, averaged over 64 points of a period: the friction jumps", 0.5),
    CASE(branches, R(1e6, 4000), "position for alpha = 0 by rk4: its steps go across the jumps of the force", 40, 0),
    CASE(branches, R(1e6, 1000),
         "position for alpha = 2 by rk4: its steps go across x = 0, where the force is not smooth", 40, 2),
    CASE(bounces, R(1e3, 100), "height of a bouncing ball by fixed steps: each bounce is late by a part of a step", 4,
         0.75),
    CASE(bounces, R(2e5, 2e4),
         "height of a ball that bounces without loss, by fixed steps: the delays of the bounces add up", 17.5, 1),
    CASE(arcs, 16, "first Fourier coefficient of ca for alpha = 0 from 16 points: higher coefficients spoil the result",
         0),
    CASE(arcs, 16, "sum of the first and third Fourier coefficient of ca for alpha = 0: higher coefficients spoil it",
         1),
    CASE(rough_spring, R(1e4, 300),
         "position for alpha = 1/4 with varying mass, by rk4: the slope of the force is infinite at x = 0", 64, 0.03125,
         0.25),
    CASE(rough_spring, R(1e4, 100),
         "position for alpha = 30 with varying mass, by rk4: the motion reverses in a short time", 64, 0.03125, 30),
};
