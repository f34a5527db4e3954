/* varmass.h, chapters 7.6 to 8 and the diagnostics: Van der Pol, Laval's rotor, two bodies, harmonic excitation */

static vm_law some_mass(void)
{
    const vm_real mass = uniform(1, 2);
    return vm_law_linear(mass, uniform(-1, 1) / 64);
}

/* The integration starts from y, which it leaves alone. */
static void integrate_from(const vm_real *y, ode_rhs rhs, void *ctx, int n, vm_real end)
{
    vm_real state[5];
    memcpy(state, y, (size_t)n * sizeof *y);
    integrate(rhs, ctx, n, end, state);
}

static void try_van_der_pol(void)
{
    int i;
    for (i = 0; i < 12; i++) {
        const vm_real start[2] = {1, VM_C(0.5)};
        const vm_law m = some_mass();
        vm_vdp v;
        vm_real mass = 0, rate = 0;
        int stable = 7;
        memset(&v, 0, sizeof v);
        v.alpha = uniform(0, 5);
        v.k = uniform(1, 2);
        v.feed = uniform(1, 2) / 16;
        v.c = uniform(1, 2) / 16;
        v.reactive = uniform(0, 1);
        v.method = i % 3;
        v.mass = m;
        fold_int(vm_vdp_init(&v));
        fold(v.a1);
        fold(v.a2);
        fold(v.a3);
        fold(vm_vdp_amplitude(&v, 5, 1));
        fold(vm_vdp_limit_cycle(&v, m.f1, &stable));
        fold_int(stable);
        vm_law_at(&m, 3, &mass, &rate);
        fold(mass);
        fold(rate);
        if (i % 4) continue;
        integrate_from(start, vm_vdp_rhs, &v, 2, 5);
        integrate_from(start, vm_vdp_averaged_rhs, &v, 2, 5);
    }
}

static vm_complex turning_load(vm_real t, vm_complex z, vm_complex v, void *ctx)
{
    vm_complex f;
    (void)t;
    (void)ctx;
    f.re = -z.im / 32 - v.re / 64;
    f.im = z.re / 32 - v.im / 64;
    return f;
}

static void try_laval(void)
{
    int i;
    for (i = 0; i < 4; i++) {
        const vm_law m = some_mass();
        vm_power_force spring;
        vm_jeffcott r;
        vm_complex z, v;
        vm_real y[4], state[5], back[4], rho, phi, slope;
        memset(&r, 0, sizeof r);
        spring.k = uniform(1, 2);
        spring.alpha = i % 2 ? 1 : uniform(1, 4);
        r.mass = m;
        r.stiffness = vm_jeffcott_power;
        r.stiffness_ctx = &spring;
        r.force = turning_load;
        r.gyro = uniform(-1, 1) / 8;
        r.reactive = uniform(0, 1);
        r.nodes = 8;
        draw_all(4, -1, 1, y);
        z.re = y[0];
        z.im = y[1];
        v.re = y[2];
        v.im = y[3];
        vm_jeffcott_polar(z, &rho, &phi);
        fold(rho);
        fold(phi);
        fold(vm_jeffcott_power(rho, &slope, &spring));
        fold(slope);
        fold(vm_jeffcott_momentum(&r, m.f0, z, v));
        integrate_from(y, vm_jeffcott_rhs, &r, 4, 2);
        fold(vm_jeffcott_frequency(&r, rho, m.f0, 1));
        fold(vm_jeffcott_frequency(&r, rho, m.f0, -1));
        back[0] = rho;
        back[1] = phi;
        integrate_from(back, vm_jeffcott_forward_whirl_rhs, &r, 2, 2);
        integrate_from(back, vm_jeffcott_backward_whirl_rhs, &r, 2, 2);
        if (i % 2) {
            fold_int(vm_jeffcott_to_averaged(&r, 0, y, 1, state));
            fold_all(5, state);
            fold_int(vm_jeffcott_from_averaged(&r, 0, state, back));
            fold_all(4, back);
            integrate_from(state, vm_jeffcott_exact_rhs, &r, 5, 1);
            integrate_from(state, vm_jeffcott_averaged_rhs, &r, 5, 1);
        }
        r.reactive = 1;
        fold(vm_jeffcott_amplitude(&r, rho, m.f0, m.f0 / 2));
    }
}

static void try_laval_motions(void)
{
    int i, sense;
    for (i = 0; i < 8; i++) {
        vm_power_force spring;
        vm_jeffcott_whirl w;
        vm_jeffcott r;
        vm_real motion[4], t;
        memset(&r, 0, sizeof r);
        spring.k = uniform(1, 2);
        spring.alpha = i % 2 ? 1 : uniform(1, 4);
        r.mass = some_mass();
        r.stiffness = vm_jeffcott_power;
        r.stiffness_ctx = &spring;
        if (i % 4 > 1) r.gyro = uniform(-1, 1) / 8;
        r.reactive = uniform(0, 1);
        for (sense = -1; sense < 2; sense += 2) {
            CLEAR(w);
            fold(vm_jeffcott_whirl_amplitude(&r, 1, 2, uniform(1, 3), sense));
            t = uniform(0, 2);
            fold_int(vm_jeffcott_whirl_at(&r, uniform(0, 1), 1, sense, t, &w));
            fold(w.radius);
            fold(w.angle);
            fold(w.frequency);
            fold_two(w.z.re, w.z.im);
            fold_two(w.v.re, w.v.im);
        }
        draw_all(4, -1, 1, motion);
        fold_int(vm_jeffcott_linear_at(&r, motion, uniform(0, 2), motion));
        fold_all(4, motion);
    }
}

static void try_pair(void)
{
    int i;
    for (i = 0; i < 6; i++) {
        const vm_law m = some_mass();
        vm_real y[4], modes[4] = {1, 2, 3, 4}, back[4] = {1, 2, 3, 4};
        vm_pair p;
        memset(&p, 0, sizeof p);
        p.alpha = uniform(0, 5);
        p.k = uniform(1, 2);
        p.reactive = uniform(0, 1);
        p.mass = m;
        draw_all(4, -1, 1, y);
        fold_int(vm_pair_to_averaged(&p, 1, y, modes));
        fold_all(4, modes);
        fold_int(vm_pair_from_averaged(&p, 1, modes, back));
        fold_all(4, back);
        fold_int(vm_pair_at(&p, 4, y, back));
        fold_all(4, back);
        fold_int(vm_pair_by_method(&p, i % 3, 4, y, back));
        fold_all(4, back);
        if (i % 2) {
            integrate_from(y, vm_pair_rhs, &p, 4, 3);
            integrate_from(modes, vm_pair_averaged_rhs, &p, 4, 3);
        }
    }
}

static int push_pair(vm_real t, const vm_real *y, vm_real *force, void *ctx)
{
    (void)ctx;
    force[0] += t / 8;
    force[1] -= y[3] / 16;
    return 0;
}

static void try_coupled_pair(void)
{
    int i;
    for (i = 0; i < 6; i++) {
        vm_connection springs[2];
        vm_coupled_pair p;
        vm_osc_problem o;
        vm_real y[4], modes[4] = {1, 2, 3, 4}, back[4] = {1, 2, 3, 4}, f, rate;
        memset(&p, 0, sizeof p);
        memset(&o, 0, sizeof o);
        springs[0].k = uniform(1, 2);
        springs[0].alpha = uniform(1, 4);
        springs[1].k = uniform(1, 2);
        springs[1].alpha = 1;
        p.mass[0] = some_mass();
        p.mass[1] = some_mass();
        p.reactive = i % 2;
        p.damping = uniform(0, 1) / 8;
        p.n = 1 + i % 2;
        p.connections = springs;
        draw_all(4, -1, 1, y);
        fold_int(vm_coupled_pair_to_modes(&p, 1, y, modes));
        fold_all(4, modes);
        fold_int(vm_coupled_pair_from_modes(&p, 2, modes, back));
        fold_all(4, back);
        fold_int(vm_coupled_pair_oscillator(&p, y, &o));
        if (p.n == 1) {
            fold_int(vm_law_at(&o.mass, 2, &f, &rate));
            fold(f);
            fold(rate);
        }
        fold(p.momentum);
        p.force = i % 3 ? NULL : push_pair;
        integrate_from(y, vm_coupled_pair_rhs, &p, 4, 3);
    }
}

static vm_forced some_oscillator(void)
{
    vm_forced f;
    vm_real k;
    memset(&f, 0, sizeof f);
    f.alpha = uniform(1, 4);
    f.damping = uniform(1, 2) / 64;
    f.reactive = uniform(0, 1);
    f.mass = some_mass();
    k = uniform(1, 2);
    f.stiffness = vm_law_linear(k, 0);
    return f;
}

static void try_grounded_pair(void)
{
    static const int ratios[3][2] = {{1, 1}, {0, 0}, {1, 3}};
    int i;
    for (i = 0; i < 6; i++) {
        vm_real y[4], modes[4] = {1, 2, 3, 4}, back[4] = {1, 2, 3, 4};
        vm_grounded_pair p;
        memset(&p, 0, sizeof p);
        p.oscillator[0] = some_oscillator();
        p.oscillator[1] = some_oscillator();
        p.spring = uniform(-1, 1) / 64;
        p.damper = uniform(0, 1) / 64;
        p.vibrations[0] = ratios[i % 3][0];
        p.vibrations[1] = ratios[i % 3][1];
        fold_int(vm_grounded_pair_init(&p));
        fold_two(p.mean[0], p.mean[1]);
        draw_all(4, VM_C(0.5), 1, y);
        fold_int(vm_grounded_pair_to_averaged(&p, 1, y, modes));
        fold_all(4, modes);
        fold_int(vm_grounded_pair_from_averaged(&p, 1, modes, back));
        fold_all(4, back);
        integrate_from(y, vm_grounded_pair_rhs, &p, 4, 2);
        integrate_from(modes, vm_grounded_pair_averaged_rhs, &p, 4, 2);
    }
}

static vm_forced some_forced(void)
{
    vm_forced f;
    vm_real mass, k, nu, force;
    memset(&f, 0, sizeof f);
    f.alpha = uniform(1, 4);
    f.damping = uniform(1, 2) / 32;
    f.reactive = uniform(0, 1);
    mass = uniform(1, 2);
    k = uniform(1, 2);
    nu = uniform(VM_C(0.75), VM_C(1.5));
    force = uniform(1, 2) / 8;
    f.mass = vm_law_linear(mass, uniform(-1, 1) / 256);
    f.stiffness = vm_law_linear(k, 0);
    f.frequency = vm_law_linear(nu, 0);
    f.force = vm_law_linear(force, 0);
    return f;
}

static void fold_steady(const vm_steady_state *s)
{
    fold(s->nu);
    fold(s->A);
    fold(s->delta);
    fold(s->trace);
    fold(s->det);
    fold_int(s->stable);
}

static void try_forced(void)
{
    int i;
    for (i = 0; i < 6; i++) {
        const vm_real motion[3] = {1, VM_C(0.5), VM_C(0.25)};
        vm_forced f = some_forced();
        vm_real y[3] = {1, 2, 3}, back[3] = {1, 2, 3};
        fold_int(vm_forced_init(&f));
        fold(f.pi);
        fold(f.Om1);
        fold(f.G);
        fold_all(5, f.c);
        fold_all(5, f.s);
        if (i % 2) f.frequency = vm_law_linear(f.frequency.f0, VM_C(0.01));
        fold_int(vm_forced_to_averaged(&f, 1, motion, y));
        fold_all(3, y);
        fold_int(vm_forced_from_averaged(&f, 1, y, back));
        fold_all(3, back);
        integrate_from(motion, vm_forced_rhs, &f, 3, 3);
        integrate_from(motion, vm_forced_exact_rhs, &f, 3, 2);
        integrate_from(y, vm_forced_averaged_rhs, &f, 3, 3);
        f.alpha = -1; /* this is refused, and leaves f alone */
        fold_int(vm_forced_init(&f));
        fold(f.G);
    }
}

static void try_steady(void)
{
    int i, k, n;
    for (i = 0; i < 6; i++) {
        vm_forced f = some_forced();
        vm_steady_state steady[3];
        vm_passage passage;
        memset(&passage, 0, sizeof passage);
        fold_int(vm_forced_init(&f));
        f.frequency = vm_law_linear(f.frequency.f0, VM_C(0.001));
        n = vm_forced_steady_states(&f, 1, steady);
        fold_int(n);
        for (k = 0; k < n; k++) fold_steady(steady + k);
        n = vm_forced_curve(&f, 1, uniform(VM_C(0.5), 1), steady);
        fold_int(n);
        for (k = 0; k < n; k++) fold_steady(steady + k);
        fold(vm_forced_peak(&f, 1));
        fold_int(vm_forced_passage(&f, 1, 1, &passage));
        fold(passage.A);
        fold(passage.drift_ratio);
        fold(passage.amplitude_jump);
    }
}

/* A periodic force that is not harmonic, at the resonances 1:1, 3:1 and 1:3 */
static void try_periodic(void)
{
    static const int ratios[3][2] = {{1, 1}, {3, 1}, {1, 3}};
    int i, k, n;
    for (i = 0; i < 6; i++) {
        const vm_real motion[3] = {1, VM_C(0.5), VM_C(0.25)};
        vm_real g[12], y[3] = {1, 2, 3}, back[3] = {1, 2, 3};
        vm_steady_state steady[8], point;
        vm_periodic p;
        memset(&p, 0, sizeof p);
        memset(&point, 0, sizeof point);
        p.oscillator = some_forced();
        p.vibrations = ratios[i % 3][0];
        p.periods = ratios[i % 3][1];
        draw_all(12, -1, 1, g);
        fold_int(vm_periodic_from_samples(&p, 8 + i % 5, g));
        fold_all(VM_PERIODIC_HARMONICS + 1, p.cosine);
        fold_all(VM_PERIODIC_HARMONICS + 1, p.sine);
        fold_int(vm_periodic_init(&p));
        fold(p.oscillator.G);
        fold(vm_periodic_shape(&p, uniform(-9, 9)));
        fold_int(vm_periodic_to_averaged(&p, 1, motion, y));
        fold_all(3, y);
        fold_int(vm_periodic_from_averaged(&p, 1, y, back));
        fold_all(3, back);
        integrate_from(motion, vm_periodic_rhs, &p, 3, 2);
        integrate_from(motion, vm_periodic_exact_rhs, &p, 3, 1);
        integrate_from(y, vm_periodic_averaged_rhs, &p, 3, 2);
        fold_int(vm_periodic_curve(&p, 1, uniform(-3, 3), &point));
        fold_steady(&point);
        if (i > 2) continue; /* the search takes long on an emulator */
        n = vm_periodic_steady_states(&p, 1, 8, steady);
        fold_int(n);
        for (k = 0; k < n && k < 8; k++) fold_steady(steady + k);
    }
}

static void exact_motion(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    const vm_real omega0 = *(const vm_real *)ctx;
    vm_osc_exact(t, 1, omega0, 3, x, v);
}

static vm_real falling(vm_real t, void *ctx)
{
    (void)ctx;
    return 1 - t / 64;
}

static void fold_points(long n, const vm_sample *points)
{
    long i;
    fold_int(n);
    for (i = 0; i < n && i < 8; i++) {
        fold(points[i].t);
        fold(points[i].x);
        fold(points[i].v);
    }
}

static void try_diagnostics(void)
{
    const vm_real y0[2] = {1, 0};
    vm_real omega0 = 2, work[RK45_WORK(2)], buffer[2];
    vm_sample points[8];
    rk45 s;
    long n;
    int i, kind;
    for (kind = VM_TURNING_POINTS; kind <= VM_ZERO_CROSSINGS; kind++) {
        n = vm_find_samples(exact_motion, &omega0, kind, 0, 8, VM_C(0.125), 8, points);
        fold_points(n, points);
        fold(vm_envelope_error(kind, n < 8 ? n : 8, points, falling, NULL));
        fold_int(rk45_init(&s, duffing, NULL, 2, 0, y0, NULL, work));
        for (i = 0; i < 30; i++) {
            fold_int(rk45_step(&s));
            n = vm_find_samples_of_step(&s, 0, 1, kind, buffer, 8, points);
            fold_points(n, points);
        }
    }
    for (i = 0; i < 8; i++) {
        vm_osc_problem o;
        const vm_real A = uniform(1, 2);
        memset(&o, 0, sizeof o);
        o.alpha = uniform(0, 5);
        o.mass = vm_law_linear(2, VM_C(0.01));
        o.stiffness = vm_law_linear(3, VM_C(-0.02));
        o.damping = VM_C(0.05);
        o.reactive = 1;
        fold(vm_adiabaticity(&o, 0, A));
    }
}

static void golden_slow(void)
{
    try_van_der_pol();
    try_laval();
    try_pair();
    try_laval_motions();
    try_coupled_pair();
}

/* The law of order three: its orders, both integrations, the choice of a route, the limit cycle */
static void golden_van_der_pol(void)
{
    static const int routes[] = {VM_ROUTE_ATEB, VM_ROUTE_ORDER2, VM_ROUTE_ORDER3, VM_ROUTE_COLLOCATION, VM_ROUTE_RK87};
    int i, k;
    for (i = 0; i < 6; i++) {
        const vm_real t = uniform(-10, 30), x = uniform(-1, 1);
        vm_real mass[3];
        vm_osc_motion m;
        vm_vdp_cycle cycle;
        vm_vdp_plan plan;
        vm_vdp v;
        memset(&v, 0, sizeof v);
        memset(&m, 0, sizeof m);
        memset(&cycle, 0, sizeof cycle);
        v.alpha = uniform(0, 4);
        v.k = uniform(1, 2);
        v.feed = uniform(-1, 1) / 64;
        v.c = uniform(0, 1) / 64;
        v.reactive = uniform(0, 1);
        draw_all(3, 1, 2, mass);
        v.mass = i % 2 ? vm_law_linear(mass[0], mass[1] / 128) : vm_law_exponential(mass[0], mass[2] / 128);
        if (i == 3) v.alpha = 1;
        if (i == 3) v.mass = vm_law_linear(mass[0], 0); /* closed form */
        if (i == 4) v.stiffness = vm_law_exponential(mass[1], mass[0] / 256);
        fold_int(vm_vdp_plan_init(&plan, &v, x, uniform(-1, 1)));
        for (k = 0; k < 5; k++) {
            if (i > 1 && routes[k] == VM_ROUTE_RK87) continue; /* it takes long on an emulator */
            fold_int(vm_vdp_plan_by_route(&plan, routes[k], t, VM_C(0.001), &m));
            fold_motion(&m);
        }
        fold_int(vm_vdp_plan_within(&plan, t, VM_C(0.001), &m));
        fold_motion(&m);
        fold_int(vm_vdp_within(&v, x, 0, t, VM_C(0.01), &m));
        fold_motion(&m);
        fold_int(vm_vdp_cycle_of(&v, &cycle));
        fold(cycle.largest_x);
        fold(cycle.period);
        fold(cycle.epsilon);
        fold_int(cycle.stable);
    }
}

static void golden_resonance(void)
{
    try_forced();
    try_steady();
    try_diagnostics();
    try_periodic();
    try_grounded_pair();
}
