/* varmass.h, chapters 4 and 6: Lagrange's equations across a jump, the cut pendulum, mechanisms whose masses vary */

/* The derivatives of v and omega by the rates of the six coordinates of a free body */
static void free_coordinates(vm_vec3 *dr, vm_vec3 *turn)
{
    memset(dr, 0, 6 * sizeof *dr);
    memset(turn, 0, 6 * sizeof *turn);
    dr[0].x = 1;
    dr[1].y = 1;
    dr[2].z = 1;
    turn[3].x = 1;
    turn[4].y = 1;
    turn[5].z = 1;
}

static void try_lagrange_jumps(void)
{
    vm_real before[36], after[36], part[6], blow[6], rates[6], result[6], work[VM_LAGRANGE_WORK(6)];
    vm_vec3 dr[6], turn[6];
    int i;
    free_coordinates(dr, turn);
    for (i = 0; i < COUNT / 16; i++) {
        const vm_body body = some_body(), piece = some_part(&body);
        const vm_impulse impulse = some_impulse();
        memset(before, 0, sizeof before);
        memset(part, 0, sizeof part);
        memset(blow, 0, sizeof blow);
        vm_lagrange_mass(6, &body, dr, turn, before);
        fold_all(36, before);
        memcpy(after, before, sizeof after);
        vm_lagrange_mass(6, &piece, dr, turn, after);
        vm_lagrange_momentum(6, &piece, dr, turn, part);
        fold_all(6, part);
        vm_lagrange_impulse(6, &impulse, body.r, dr, turn, blow);
        fold_all(6, blow);
        draw_all(6, -2, 2, rates);
        fold_int(vm_lagrange_attach(6, before, after, rates, part, blow, result, work));
        fold_all(6, result);
        fold_int(vm_lagrange_separate(6, after, before, rates, part, NULL, result, work));
        fold_all(6, result);
        fold_int(vm_lagrange_impact(6, before, rates, blow, result, work));
        fold_all(6, result);
        memset(before, 0, sizeof before);
        fold_int(vm_lagrange_impact(6, before, rates, blow, result, work));
        fold_all(6, result); /* singular */
    }
}

static void try_pendulum(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        vm_pendulum p;
        vm_pendulum_cut c;
        vm_real u[3];
        CLEAR(c);
        p.mass = uniform(1, 3);
        p.length = uniform(1, 2);
        p.angle = uniform(-3, 3);
        p.rate = uniform(-4, 4);
        p.axes = i % 2;
        draw_all(3, -2, 2, u);
        fold_int(vm_pendulum_separate(&p, p.length / 4, u[0], u[1], u[2], &c));
        fold(c.rest.rate);
        fold(c.rest.mass);
        fold(c.rest.length);
        fold(c.mass);
        fold(c.x);
        fold(c.y);
        fold(c.vx);
        fold(c.vy);
        fold(c.rate);
        fold(c.T1);
        fold(c.T_S1);
        fold(c.T_S2);
        fold(c.L1);
        fold(c.L2);
        fold(c.pivot_x);
        fold(c.pivot_y);
    }
}

static void try_compound(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        vm_compound_pendulum p;
        vm_compound_part part;
        vm_compound_cut c;
        CLEAR(c);
        p.mass = uniform(2, 3);
        p.x = uniform(-1, 1);
        p.y = uniform(-1, 1);
        p.inertia = p.mass * (p.x * p.x + p.y * p.y) + uniform(1, 2);
        p.rate = uniform(-4, 4);
        part.mass = uniform(0, 1);
        part.inertia = uniform(0, 1);
        part.x = uniform(-1, 1);
        part.y = uniform(-1, 1);
        part.ux = uniform(-1, 1);
        part.uy = uniform(-1, 1);
        part.Omega = uniform(-1, 1);
        fold_int(vm_compound_pendulum_separate(&p, &part, &c));
        fold(c.rest.mass);
        fold(c.rest.inertia);
        fold(c.rest.x);
        fold(c.rest.y);
        fold(c.rest.rate);
        fold(c.vx);
        fold(c.vy);
        fold(c.rate);
        fold(c.T1);
        fold(c.T_S1);
        fold(c.T_S2);
        fold(c.L1);
        fold(c.L2);
        fold(c.pivot_x);
        fold(c.pivot_y);
    }
}

/* A carriage on a spring carries a pendulum that leaks. The height of its bob is q1^2/2, so that no sine of the C
   library is needed. */
static void leaking(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)q;
    (void)ctx;
    masses[0] = 2;
    masses[1] = 1 - VM_C(0.0625) * t;
}

static vm_real energy_of_two(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real v = rates[0] + rates[1], w = q[1] * rates[1];
    (void)t;
    (void)ctx;
    return masses[0] * rates[0] * rates[0] / 2 + masses[1] * (v * v + w * w) / 2;
}

static int forces_on_two(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                         void *ctx)
{
    vm_vec3 weight = {0, 0, 0}, none = {0, 0, 0}, dr[2];
    (void)t;
    (void)rates;
    (void)ctx;
    memset(dr, 0, sizeof dr);
    weight.y = VM_C(-9.81) * masses[1];
    dr[1].y = q[1];
    vm_lagrange_add_force(2, weight, dr, none, NULL, Q);
    Q[0] -= 5 * q[0];
    return 0;
}

static void try_mechanism(void)
{
    const vm_real q[2] = {VM_C(0.5), VM_C(0.25)}, rates[2] = {-1, 2};
    vm_real y[4], back[2] = {1, 2}, work[VM_LAGRANGE_RHS_WORK(2, 2)];
    vm_lagrange_system l;
    memset(&l, 0, sizeof l);
    l.n = 2;
    l.n_masses = 2;
    l.masses = leaking;
    l.energy = energy_of_two;
    l.forces = forces_on_two;
    l.work = work;
    fold_int(vm_lagrange_start(&l, 0, q, rates, y));
    fold_all(4, y);
    fold(vm_lagrange_partial_q(&l, 0, q, rates, 1));
    fold_int(vm_lagrange_needed_forces(&l, 1, 4, q, rates, q, back));
    fold_all(2, back);
    fold_int(vm_lagrange_drive_forces(&l, 1, 0, q, rates, q, back));
    fold_all(2, back);
    integrate(vm_lagrange_rhs, &l, 4, 3, y);
    fold_int(vm_lagrange_rates(&l, 3, y, back));
    fold_all(2, back);
}

static void golden_lagrange(void)
{
    try_lagrange_jumps();
    try_pendulum();
    try_compound();
    try_mechanism();
}
