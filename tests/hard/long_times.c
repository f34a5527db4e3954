/* Long times: errors that grow with the argument, or with the number of steps. Errors in eps of the largest value. */

/* u = x0, m = x1; the plan of m. Naive: u less whole periods, by the period in one word */
static vm_real cn_late_ours(const vm_real *x) { return jacobi_cn(x[0], x[1]); }
static vm_real cn_late_naive(const vm_real *x) { return jacobi_cn(FMOD(x[0], 4 * jacobi_K(x[1])), x[1]); }
static vm_real sn_late_ours(const vm_real *x)
{
    jacobi_plan p;
    vm_real sn, cn, dn;
    if (jacobi_plan_init(&p, x[1])) return VM_NAN;
    jacobi_plan_sncndn(&p, x[0], &sn, &cn, &dn);
    return sn;
}
static vm_real sn_late_naive(const vm_real *x) { return jacobi_sn(FMOD(x[0], 4 * jacobi_K(x[1])), x[1]); }
/* s = x0, alpha = x1 */
static vm_real ca_late_ours(const vm_real *x) { return ateb_ca(x[0], x[1]); }
static vm_real ca_late_naive(const vm_real *x) { return ateb_ca(FMOD(x[0], 2 * ateb_pi(x[1])), x[1]); }
static vm_real sa_late_ours(const vm_real *x)
{
    ateb_plan p;
    vm_real sa, ca;
    if (ateb_plan_init(&p, x[1])) return VM_NAN;
    ateb_plan_saca(&p, x[0], &sa, &ca);
    return sa;
}
static vm_real sa_late_naive(const vm_real *x) { return ateb_sa(FMOD(x[0], 2 * ateb_pi(x[1])), x[1]); }
static vm_real euler_late_ours(const vm_real *x) { return vm_euler_313(x[0], 0, 0).w; }
static vm_real euler_late_naive(const vm_real *x) { return COS(FMOD(x[0], 4 * VM_PI) / 2); }

/* omega_1 of a free body after many turns: the textbook's phase is rounded once */
static vm_real free_body_late_ours(const vm_real *x) { return free_body_ours(x); }
static vm_real free_body_late_naive(const vm_real *x) { return free_body_naive(x); }
/* Where the axis of a body of moments x0, x0, x1 points, z, after its precession from omega = (x2, 0, x3) for
   t = x4 */
static vm_real precession_ours(const vm_real *x)
{
    vm_torque_free motion;
    vm_vec3 moments, omega;
    vm_quat q = {1, 0, 0, 0};
    moments.x = moments.y = x[0], moments.z = x[1];
    omega.x = x[2], omega.y = 0, omega.z = x[3];
    if (vm_torque_free_init_principal(&motion, moments, q, omega, 0)) return VM_NAN;
    if (vm_torque_free_attitude(&motion, x[4], &q, &omega)) return VM_NAN;
    return 1 - 2 * (q.x * q.x + q.y * q.y);
}
static vm_real precession_naive(const vm_real *x)
{
    const vm_real across = x[0] * x[2], along = x[1] * x[3], L2 = across * across + along * along;
    return (along * along + across * across * COS(SQRT(L2) / x[0] * x[4])) / L2;
}

/* Length of a quaternion after the time x1 in x0 steps of rk4, spin 2 rad/s */
static int coasting(vm_real t, const vm_real *y, vm_flow *flow)
{
    (void)t, (void)y, (void)flow;
    return 0;
}
static vm_real attitude_length_ours(const vm_real *x)
{
    vm_body body = {1, {1, 1, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 2}};
    vm_flow flow;
    vm_real y[VM_FLOW_STATES], work[RK4_WORK(VM_FLOW_STATES)], t = 0, *q = y + VM_Y_Q;
    memset(&flow, 0, sizeof flow);
    flow.update = coasting;
    if (vm_flow_start(&flow, &body, y)) return VM_NAN;
    flow.mass = 1, flow.inertia = body.inertia;
    if (rk4_solve(vm_flow_given_rhs, &flow, VM_FLOW_GIVEN_STATES, &t, x[1], (long)x[0], y, work)) return VM_NAN;
    return SQRT(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}
static void turning(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)t, (void)x;
    dydt[0] = -y[1], dydt[1] = y[0];
}
static vm_real attitude_length_naive(const vm_real *x)
{
    vm_real q[2] = {1, 0};
    naive_rk4(turning, x, 2, q, x[1], (long)x[0]);
    return SQRT(q[0] * q[0] + q[1] * q[1]);
}
/* x0 steps of rk4 of size x1: y' = y; y'' = -y */
static int growing(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[0];
    return 0;
}
static int circling(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[1], dydt[1] = -y[0];
    return 0;
}
static vm_real steps_growing_ours(const vm_real *x)
{
    vm_real y = 1, low = 0, t = 0, work[RK4_WORK(1)];
    return rk4_solve_compensated(growing, NULL, 1, &t, x[0] * x[1], (long)x[0], &y, &low, work) ? VM_NAN : y;
}
static vm_real steps_growing_naive(const vm_real *x)
{
    vm_real y = 1, t = 0, work[RK4_WORK(1)];
    return rk4_solve(growing, NULL, 1, &t, x[0] * x[1], (long)x[0], &y, work) ? VM_NAN : y;
}
static vm_real steps_circling_ours(const vm_real *x)
{
    vm_real y[2] = {1, 0}, low[2] = {0, 0}, t = 0, work[RK4_WORK(2)];
    return rk4_solve_compensated(circling, NULL, 2, &t, x[0] * x[1], (long)x[0], y, low, work) ? VM_NAN : y[0];
}
static vm_real steps_circling_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0}, t = 0, work[RK4_WORK(2)];
    return rk4_solve(circling, NULL, 2, &t, x[0] * x[1], (long)x[0], y, work) ? VM_NAN : y[0];
}
/* Time after x0 steps of size x1, by y' = 1 with a clock that adds them up */
static int clock_time(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)y, (void)ctx;
    dydt[0] = 2 * t;
    return 0;
}
static vm_real steps_clock_ours(const vm_real *x)
{
    vm_real y = 0, low = 0, t = 0, work[RK4_WORK(1)];
    return rk4_solve_compensated(clock_time, NULL, 1, &t, x[1], (long)x[0], &y, &low, work) ? VM_NAN : y;
}
static void naive_clock(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)y, (void)x;
    dydt[0] = 2 * t;
}
static vm_real steps_clock_naive(const vm_real *x)
{
    vm_real y = 0;
    naive_rk4(naive_clock, x, 1, &y, x[1], (long)x[0]);
    return y;
}

/* The oscillator v' = u|u|^(alpha-1), u' = -2v/(alpha+1) of sa and ca, alpha = x1 */
static void ateb_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)t;
    dydt[0] = y[1] == 0 ? 0 : VM_COPYSIGN(POW(FABS(y[1]), x[1]), y[1]);
    dydt[1] = -2 / (x[1] + 1) * y[0];
}
/* Energy at t = x0 of what started from 1, alpha = x1: 1/(alpha + 1); 50 steps of rk4 a period */
static vm_real energy_late_ours(const vm_real *x)
{
    vm_real place, v;
    vm_osc_exact(x[0], 1, 1, x[1], &place, &v);
    return vm_osc_energy(place, v, 1, x[1]);
}
static vm_real energy_late_naive(const vm_real *x)
{
    vm_real y[2] = {0, 1}, s = SQRT((x[1] + 1) / 2) * x[0];
    naive_rk4(ateb_equations, x, 2, y, s, (long)(s / ateb_pi(x[1]) * 25));
    return (y[0] * y[0] + POW(FABS(y[1]), x[1] + 1)) / (x[1] + 1);
}

/* x at t = x0 where m = 1/k = 1 + x1 t, which is solved exactly: its action stays and its clock is ln(1 + x1 t)/x1.
   alpha = x2. Naive: rk4, 50 steps a period */
static vm_osc_problem adiabatic_problem(const vm_real *x)
{
    vm_osc_problem p;
    memset(&p, 0, sizeof p);
    p.mass = vm_law_linear(1, x[1]), p.stiffness = vm_law_power(1, x[1], -1);
    p.alpha = x[2], p.reactive = 1, p.x = 1;
    return p;
}
static vm_real adiabatic_late_ours(const vm_real *x)
{
    const vm_osc_problem p = adiabatic_problem(x);
    vm_osc_motion motion;
    return vm_osc_by_route(&p, VM_ROUTE_ORDER5, x[0], 0, &motion) == VM_OK ? motion.x : VM_NAN;
}
static void adiabatic_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real m = 1 + x[1] * t;
    dydt[0] = y[1] / m;
    dydt[1] = y[0] == 0 ? 0 : -VM_COPYSIGN(POW(FABS(y[0]), x[2]), y[0]) / m;
}
static vm_real adiabatic_late_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0};
    naive_rk4(adiabatic_equations, x, 2, y, x[0], (long)(x[0] * 8));
    return y[0];
}
/* The same for alpha = 1, k = 1, m = 1 + x1 t: Bessel functions. By an integrator; naive: first-order averaging */
static vm_osc_problem bessel_problem(const vm_real *x)
{
    vm_osc_problem p;
    memset(&p, 0, sizeof p);
    p.mass = vm_law_linear(1, x[1]), p.stiffness = vm_law_linear(1, 0);
    p.alpha = 1, p.reactive = 1, p.x = 1;
    return p;
}
static vm_real bessel_ours(const vm_real *x)
{
    const vm_osc_problem p = bessel_problem(x);
    vm_osc_motion motion;
    return vm_osc_by_route(&p, VM_ROUTE_RK87, x[0], R(VM_C(1e-13), VM_C(1e-5)), &motion) >= 0 ? motion.x : VM_NAN;
}
static vm_real bessel_naive(const vm_real *x)
{
    const vm_osc_problem p = bessel_problem(x);
    vm_osc_motion motion;
    return vm_osc_by_route(&p, VM_ROUTE_TRIG, x[0], 0, &motion) == VM_OK ? motion.x : VM_NAN;
}

static const hard_case long_times_cases[] = {
    CASE(cn_late, 4, "cn at u = 1e9: the error of the rounded period is multiplied by the number of periods",
         R(987654321.3, 9876.543), 0.3),
    CASE(cn_late, 4, "cn at u = 1e9 for m < 0: errors of the rounded period add up", R(987654321.3, 9876.543), -5),
    CASE(cn_late, 4, "cn at u = 1e9 for m = -1e4: errors of the rounded period add up", R(987654321.3, 9876.543),
         R(-1e4, -50)),
    CASE(cn_late, 4, "cn at u = 1e9 for m next to 1: errors of the rounded period add up", R(987654321.3, 9876.543),
         R(0.999999, 0.9999)),
    CASE(sn_late, 4, "sn at u = 1e8 by a plan for m = 0.5: errors of the rounded period add up",
         R(123456789.1, 7654.321), 0.5),
    CASE(sn_late, 4, "sn at u = 1e8 by a plan for m = 0.99: errors of the rounded period add up",
         R(123456789.1, 7654.321), 0.99),
    CASE(ca_late, 4, "ca at s = 1e9 for alpha = 3: errors of the rounded period add up", R(987654321.3, 9876.543), 3),
    CASE(ca_late, 4, "ca at s = 1e9 for alpha = 1/16: errors of the rounded period add up", R(987654321.3, 9876.543),
         0.0625),
    CASE(ca_late, 4, "ca at s = 1e9 for alpha = 5/16: errors of the rounded period add up", R(987654321.3, 9876.543),
         0.3125),
    CASE(sa_late, 4, "sa at s = 1e9 for alpha = 100: errors of the rounded period add up", R(987654243.5125, 9931.125),
         100),
    CASE(sa_late, 4, "sa at s = 1e9 by a plan for alpha = 3: errors of the rounded period add up",
         R(987654321.3, 9876.543), 3),
    CASE(sa_late, 4, "sa at s = 1e9 by a plan for alpha = 1.3125: errors of the rounded period add up",
         R(987654321.3, 9876.543), 1.3125),
    CASE(euler_late, 4, "attitude after a rotation by 1e9 rad: the error of the rounded 4 pi adds up",
         R(987654321.3, 9876.543)),
    CASE(free_body_late, 8,
         "omega_1 of a free body after 1e6 turns: the rounding error of the phase's rate grows with the time", 3, 2,
         1.5, 0.5, 2, R(3000000.7, 3000.7)),
    CASE(free_body_late, 8,
         "omega_1 of a free body after it has turned over many times: the error of the phase's rate adds up", 3, 2, 1.5,
         0.5, R(1.0000001, 1.001), R(1000000.3, 1000.3)),
    CASE(free_body_late, 8,
         "omega_1 of a nearly axisymmetric free body after 1e6 turns: the error of the phase's rate adds up",
         R(2.000001, 2.001), 2, 1, 0.5, 2, R(2000000.1, 2000.1)),
    CASE(precession, 16, "axis of an axisymmetric body after 1e6 turns of precession: the error of the rate adds up", 2,
         1, 1, 3, R(4000000.3, 4000.3)),
    CASE(precession, 6, "axis of a disc after 1e6 turns of precession: the error of the rate adds up", 1, 2, 0.25, 1,
         R(3000000.3, 30000.3)),
    CASE(attitude_length, R(1e10, 40),
         "length of an attitude quaternion after 1e4 steps of rk4: the length drifts away from 1", 10000, 1000),
    CASE(attitude_length, R(1e11, 400),
         "length of an attitude quaternion after 1e3 larger steps of rk4: the length drifts away from 1", 1000, 200),
    CASE(steps_growing, 4, "exponential growth by 2^20 steps of rk4: their roundings add up", R(1048576, 65536),
         R(0.00000095367431640625, 0.0000152587890625)),
    CASE(steps_circling, 4, "motion on a circle by 2^20 steps of rk4: their roundings add up", R(1048576, 1048576),
         R(0.00000762939453125, 0.00000762939453125)),
    CASE(steps_clock, 4,
         "integral of 2 t by 1e6 steps of rk4, with t as a sum of steps: the rounding errors of t add up",
         R(1000000, 100000), 10),
    CASE(energy_late, 8, "energy of a cubic oscillator after 100 periods by rk4: the energy drifts", 500, 3),
    CASE(energy_late, 8, "energy of an oscillator with alpha = 2 after 1000 periods by rk4: the energy drifts", 5000,
         2),
    CASE(adiabatic_late, R(2000, 2000),
         "position of an oscillator whose mass doubles in 100 periods, by rk4: the error of the phase grows", 1024,
         R(0.0009765625, 0.0009765625), 3),
    CASE(adiabatic_late, R(2000, 2000),
         "position of such an oscillator with alpha = 1.5, by rk4: the error of the phase grows", 1024,
         R(0.0009765625, 0.0009765625), 1.5),
    CASE(bessel, R(4e3, 1000),
         "position of a linear oscillator whose mass triples, by averaging: the phase is only approximate", 64,
         0.03125),
};
