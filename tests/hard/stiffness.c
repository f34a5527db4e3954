/* Stiffness: the mass, or another inertia, goes to 0, or friction is large. Naive: a fixed number of steps of rk4. */

/* Speed, and way, of a rocket of mass 1 - t at t = x0, relative velocity 3 */
static void rocket_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)x;
    dydt[0] = y[1], dydt[1] = -3 / (1 - t);
}
static vm_real burnt_out(const vm_real *x, int which)
{
    const vm_stream1 stream = {-1, 3, VM_RELATIVE};
    vm_real y[2];
    return vm_linear_flow(&stream, x[0], 0, 0, 1, 0, y, y + 1) == VM_OK ? y[which] : VM_NAN;
}
static vm_real burnt_out_naive(const vm_real *x, int which)
{
    vm_real y[2] = {0, 0};
    naive_rk4(rocket_equations, x, 2, y, x[0], 1000);
    return y[which];
}
static vm_real burnt_speed_ours(const vm_real *x) { return burnt_out(x, 1); }
static vm_real burnt_speed_naive(const vm_real *x) { return burnt_out_naive(x, 1); }
static vm_real burnt_way_ours(const vm_real *x) { return burnt_out(x, 0); }
static vm_real burnt_way_naive(const vm_real *x) { return burnt_out_naive(x, 0); }
static vm_real burnt_mass_ours(const vm_real *x) { return vm_tsiolkovsky(0, 1, x[0], 3); }
static vm_real burnt_mass_naive(const vm_real *x)
{
    vm_real y[2] = {0, 0};
    naive_rk4(rocket_equations, x, 2, y, 1 - x[0], 1000);
    return y[1];
}

/* Speed of a wagon of mass 1 - t at t = x0 under a force of 2, what falls off being put to rest */
static void wagon_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)x;
    dydt[0] = (2 + y[0]) / (1 - t);
}
static vm_real empty_wagon_ours(const vm_real *x)
{
    const vm_stream1 stream = {-1, 0, VM_AT_REST};
    vm_real way, v;
    return vm_linear_flow(&stream, x[0], 0, 1, 1, 2, &way, &v) == VM_OK ? v : VM_NAN;
}
static vm_real empty_wagon_naive(const vm_real *x)
{
    vm_real v = 1;
    naive_rk4(wagon_equations, x, 1, &v, x[0], 1000);
    return v;
}
/* The same without the force, when x0 of the mass is left (171) */
static void unforced_wagon(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)x;
    dydt[0] = y[0] / (1 - t);
}
static vm_real last_mass_ours(const vm_real *x) { return vm_velocity_by_momentum(1, 1, x[0], 0, 0); }
static vm_real last_mass_naive(const vm_real *x)
{
    vm_real v = 1;
    naive_rk4(unforced_wagon, x, 1, &v, 1 - x[0], 1000);
    return v;
}
/* Transverse omega of a body that burns until its transverse moment has come from 4 to 4 - t, t = x0, omega_z = x1 */
static vm_real jet_end_ours(const vm_real *x)
{
    const vm_jet jet = {-1, 1, 4, VM_C(0.25), 1, VM_C(0.5), 1};
    vm_vec3 omega = {1, 0, 0};
    omega.z = x[1];
    return vm_jet_damping(&jet, x[0], omega, &omega) == VM_OK ? SQRT(omega.x * omega.x + omega.y * omega.y)
                                                              : VM_NAN;
}
static void jet_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real A = 4 - t, C = 1 - t / 4, turn = (C / A - 1) * x[1], fade = VM_C(-0.5) / A;
    dydt[0] = fade * y[0] - turn * y[1], dydt[1] = fade * y[1] + turn * y[0];
}
static vm_real jet_end_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0};
    naive_rk4(jet_equations, x, 2, y, x[0], 1000);
    return SQRT(y[0] * y[0] + y[1] * y[1]);
}

/* Angle of a shaft, inertia 1, damping x0, torque 1, at t = x1: 1000 steps are unstable */
static vm_real braked_shaft_ours(const vm_real *x) { return spin_up_ours(x); }
static void braked_shaft(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)t;
    dydt[0] = y[1], dydt[1] = 1 - x[0] * y[1];
}
static vm_real braked_shaft_naive(const vm_real *x)
{
    vm_real y[2] = {0, 0};
    naive_rk4(braked_shaft, x, 2, y, x[1], 1000);
    return y[0];
}

/* y' = -x0 (y - cos t), y(0) = 0, at t = 1 */
static void relaxing(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    dydt[0] = x[0] * (COS(t) - y[0]);
}
static int relaxing_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    relaxing(t, y, dydt, (const vm_real *)ctx);
    return 0;
}
static vm_real relaxing_ours(const vm_real *x)
{
    const vm_real y = 0;
    vm_real work[RK45_WORK(1)], rate = x[0];
    rk45 s;
    if (rk45_init(&s, relaxing_rhs, &rate, 1, 0, &y, NULL, work) < 0 || rk45_solve(&s, 1) < 0) return VM_NAN;
    return s.y[0];
}
static vm_real relaxing_naive(const vm_real *x)
{
    vm_real y = 0;
    naive_rk4(relaxing, x, 1, &y, 1, 300);
    return y;
}

/* m = 1/k = 1 - t: x at t = x0, alpha = x1 */
static vm_real vanishing_mass_ours(const vm_real *x)
{
    vm_real point[3];
    point[0] = x[0], point[1] = -1, point[2] = x[1];
    return adiabatic_late_ours(point);
}
static vm_real vanishing_mass_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0}, point[3];
    point[0] = x[0], point[1] = -1, point[2] = x[1];
    naive_rk4(adiabatic_equations, point, 2, y, x[0], 1000);
    return y[0];
}
/* Van der Pol, alpha = 3, b = x0, m = 1 - t: amplitude at t = x1 */
static vm_real vdp_end_ours(const vm_real *x)
{
    vm_real point[3];
    point[0] = x[0], point[1] = -1, point[2] = x[1];
    return vdp_ours(point);
}
static void vdp_averaged(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    dydt[0] = ((2 * x[0] + 1) / 6 - ateb_mean(3, 2, 2) / 2 * y[0] * y[0]) * y[0] / (1 - t);
}
static vm_real vdp_end_naive(const vm_real *x)
{
    vm_real A = VM_C(0.5);
    naive_rk4(vdp_averaged, x, 1, &A, x[1], 100);
    return A;
}
/* Time until a drum that is braked has turned by x3 */
static vm_real drum_end_ours(const vm_real *x)
{
    const vm_drum d = drum_driven(x);
    return vm_drum_time(&d, x[3]);
}
static void drum_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)y;
    dydt[0] = (1 + x[0] / 4 * t) / (2 + (x[0] * x[1] / 2 - x[2]) * t);
}
static vm_real drum_end_naive(const vm_real *x)
{
    vm_real t = 0;
    naive_rk4(drum_equations, x, 1, &t, x[3], 1000);
    return t;
}
/* x at t = 1 of a mass of x0^-2, alpha = x1 */
static vm_real light_mass_ours(const vm_real *x)
{
    vm_real place, v;
    vm_osc_exact(1, 1, x[0], x[1], &place, &v);
    return place;
}
static void light_mass(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    (void)t;
    dydt[0] = y[1], dydt[1] = y[0] == 0 ? 0 : -x[0] * x[0] * VM_COPYSIGN(POW(FABS(y[0]), x[1]), y[0]);
}
static vm_real light_mass_naive(const vm_real *x)
{
    vm_real y[2] = {1, 0};
    naive_rk4(light_mass, x, 2, y, 1, 1000);
    return y[0];
}

static const hard_case stiffness_cases[] = {
    CASE(burnt_mass, 4, "speed of a rocket when 1e-6 of its mass is left, by fixed steps: too long at the end", 1e-6),
    CASE(burnt_mass, 4,
         "speed of a rocket when 1e-30 of its mass is left, by fixed steps: the last step goes to the mass 0", 1e-30),
    CASE(burnt_speed, 4, "speed of a rocket shortly before its mass is 0, by fixed steps: too long at the end",
         R(0.9999999999, 0.999999)),
    CASE(burnt_speed, 4, "speed of a rocket one eps before its mass is 0, by fixed steps: too long at the end",
         R(0.9999999999999998, 0.9999999)),
    CASE(burnt_way, 8, "distance of a rocket shortly before its mass is 0, by fixed steps: too long at the end",
         R(0.9999999999, 0.999999)),
    CASE(burnt_way, 8, "distance of a rocket one eps before its mass is 0, by fixed steps: too long at the end",
         R(0.9999999999999998, 0.9999999)),
    CASE(empty_wagon, 4, "speed of a wagon shortly before its mass is 0, by fixed steps: the speed tends to infinity",
         R(0.99999999, 0.99999)),
    CASE(empty_wagon, 4, "speed of a wagon one eps before its mass is 0, by fixed steps: the speed tends to infinity",
         R(0.9999999999999998, 0.9999999)),
    CASE(last_mass, 2,
         "speed of a body with 1e-6 of its mass and all its momentum left, by fixed steps: too long at the end", 1e-6),
    CASE(last_mass, 2,
         "speed of a body with 1e-30 of its mass and all its momentum left, by fixed steps: too long at the end",
         1e-30),
    CASE(jet_end, 16, "transverse omega of a burning body whose transverse inertia goes to 0: fixed steps are too long",
         R(3.9999999, 3.9999), 0),
    CASE(jet_end, 16, "the same transverse omega, if the body also spins about its axis: fixed steps are too long",
         R(3.9999999, 3.9999), 3),
    CASE(braked_shaft, 4, "angle of a shaft with the damping 1e4/s: 1000 steps of rk4 are unstable", 1e4, 1),
    CASE(braked_shaft, 4, "angle of a shaft with the damping 1e6/s: 1000 steps of rk4 are unstable", 1e6, 1),
    CASE(braked_shaft, 4, "angle of a shaft with the damping 1e12/s: 1000 steps of rk4 are unstable", 1e12, 1),
    CASE(relaxing, R(1e10, 2000), "y(1) for y' = -2e3 (y - cos t), a fast relaxation: 300 steps of rk4 are unstable",
         2e3),
    CASE(relaxing, R(1e10, 2000), "y(1) for y' = -2e4 (y - cos t): 300 steps of rk4 are unstable", 2e4),
    CASE(relaxing, R(1e10, 2000),
         "y(1) for y' = -1e5 (y - cos t): rk4 is unstable; rk45 takes 3e4 short steps, returns ODE_STIFF", 1e5),
    CASE(vanishing_mass, 32, "position of an oscillator whose mass goes to 0, by rk4: the frequency tends to infinity",
         R(0.99999, 0.9999), 3),
    CASE(vanishing_mass, 32,
         "position of an oscillator with alpha = 1 whose mass goes to 0: the frequency tends to infinity",
         R(0.9999999, 0.9999), 1),
    CASE(vanishing_mass, 32,
         "position of an oscillator with alpha = 1/2 whose mass goes to 0: the frequency tends to infinity",
         R(0.9999999, 0.9999), 0.5),
    CASE(vdp_end, 16, "amplitude of a Van der Pol oscillator whose mass goes to 0: 100 steps of rk4 are too long", 0.25,
         R(0.9999999, 0.9999)),
    CASE(vdp_end, 16,
         "amplitude of a Van der Pol oscillator with a large feed whose mass goes to 0: steps are too long", 4,
         R(0.9999999, 0.9999)),
    CASE(drum_end, 8, "time until a drum has nearly stopped, by fixed steps: too long at the end", 0.3, 0.7, 0.205,
         R(19.9999999, 19.999)),
    CASE(drum_end, 8, "time until a drum is even closer to its stop, by fixed steps: too long at the end", 0.25, 0.5,
         0.3125, R(7.9999999999, 7.99999)),
    CASE(light_mass, 8, "position of a mass of 1e-6 on a spring by 1000 steps of rk4: 6 steps a period are too few",
         1000, 3),
    CASE(light_mass, 8, "position of a mass of 1e-10 on a spring by 1000 steps of rk4: a step is longer than a period",
         1e5, 3),
    CASE(light_mass, 8, "position of a mass of 1e-8 on a spring with alpha = 1/2: the steps of rk4 are too long", 1e4,
         0.5),
};
