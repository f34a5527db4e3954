/* For Frama-C's EVA (tests/eva_varmass.c): oscillators, laws of mass and stiffness, rotors on a shaft, pairs of bodies */

void eva_oscillators(void)
{
    vm_real x, v;
    sink[0] = vm_osc_period(any, any, any) + vm_osc_vmax(any, any, any) + vm_osc_energy(any, any, any, any);
    vm_osc_amplitude_phase(any, any, any, any, &x, &v);
    sink[1] = x + v;
}

void eva_osc_exact(void)
{
    vm_real x, v;
    vm_osc_exact(any, any, any, any, &x, &v);
    vm_osc_exact_from(any, any, any, any, any, &x, &v);
    sink[0] = x + v;
}

vm_law any_law(void)
{
    if (any_int) return vm_law_linear(any, any);
    if (any_int) return vm_law_quadratic(any, any, any);
    if (any_int) return vm_law_power(any, any, any);
    return vm_law_exponential(any, any);
}

void eva_laws(void)
{
    const vm_law law = any_law();
    vm_real f = any, rate = any;
    if (vm_law_at(&law, any, &f, &rate) >= 0) sink[0] = f + rate;
}

void eva_osc_approximations(void)
{
    vm_real x = any, v = any;
    vm_osc_trig(any, any, any, any, &x, &v);
    vm_osc_jacobi(any, any, any, any, &x, &v);
    sink[0] = x + v + vm_osc_omega_trig(any);
    sink[1] = vm_osc_jacobi_parameter(any) + vm_osc_omega_jacobi(any);
    sink[2] = vm_osc_amplitude_law(any, any, any, any) + vm_osc_velocity_law(any, any, any, any);
}

void eva_law_integrals(void)
{
    const vm_law f = any_law(), g = any_law();
    vm_real integral = any;
    if (vm_law_inverse_integral(&f, any, &integral) >= 0) sink[0] = integral;
    if (vm_law_ratio_integral(&f, &g, any, &integral) >= 0) sink[1] = integral;
}

vm_osc_problem any_problem(void)
{
    vm_osc_problem o;
    o.alpha = any;
    o.mass = any_law();
    o.stiffness = any_law();
    o.reactive = any;
    o.damping = any;
    o.x = any;
    o.v = any;
    o.force = NULL;
    o.ctx = NULL;
    return o;
}

void eva_osc_closed(void)
{
    const vm_osc_problem o = any_problem();
    vm_osc_closed c;
    vm_real x = any, v = any;
    memset(&c, 0, sizeof c); /* EVA does not relate a status to what was written */
    if (vm_osc_closed_init(&c, &o, any_int, any) < 0) return;
    if (vm_osc_closed_at(&c, any, &x, &v) >= 0) sink[0] = x + v;
    if (vm_osc_closed_at_order2(&c, any, &x, &v) >= 0) sink[1] = x + v;
    if (vm_osc_closed_at_order3(&c, any, &x, &v) >= 0) sink[2] = x + v;
}

void eva_adiabaticity(void)
{
    const vm_osc_problem o = any_problem();
    sink[0] = vm_adiabaticity(&o, any, any);
}

void eva_duffing(void)
{
    vm_real x = any, v = any;
    sink[0] = vm_duffing_energy(any, any, any, any) + vm_duffing_period(any, any, any) + vm_duffing_action(any, any, any);
    vm_duffing_exact_from(any, any, any, any, any, &x, &v);
    sink[1] = x + v;
}

vm_vdp any_vdp(void)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = any;
    v.k = any;
    v.feed = any;
    v.c = any;
    v.reactive = any;
    v.method = any_int;
    v.mass = any_law();
    return v;
}

void eva_vdp(void)
{
    vm_vdp v = any_vdp();
    vm_real y[2] = {any, any}, rates[2] = {any, any};
    int stable = any_int;
    if (vm_vdp_init(&v) < 0) return;
    sink[0] = vm_vdp_amplitude(&v, any, any) + vm_vdp_limit_cycle(&v, any, &stable);
    if (vm_vdp_rhs(any, y, rates, &v) >= 0) sink[1] = rates[0];
    if (vm_vdp_averaged_rhs(any, y, rates, &v) >= 0) sink[2] = rates[0];
}

void eva_pair(void)
{
    vm_pair p;
    vm_real y[4] = {any, any, any, any}, found[4] = {any, any, any, any};
    p.alpha = any;
    p.k = any;
    p.reactive = any;
    p.mass = any_law();
    if (vm_pair_rhs(any, y, found, &p) >= 0) sink[0] = found[0];
    if (vm_pair_averaged_rhs(any, y, found, &p) >= 0) sink[1] = found[0];
    if (vm_pair_to_averaged(&p, any, y, found) >= 0) sink[2] = found[0];
    if (vm_pair_from_averaged(&p, any, y, found) >= 0) sink[3] = found[0];
    if (vm_pair_at(&p, any, y, found) >= 0) sink[4] = found[0];
}

void eva_coupled_pair(void)
{
    vm_connection c[2] = {{any, any}, {any, any}};
    vm_coupled_pair p;
    vm_osc_problem o = any_problem();
    vm_real y[4] = {any, any, any, any}, found[4] = {any, any, any, any};
    p.mass[0] = any_law();
    p.mass[1] = any_law();
    p.reactive = any;
    p.damping = any;
    p.n = any_int ? 1 : 2;
    p.connections = c;
    p.force = NULL;
    p.ctx = NULL;
    p.momentum = any;
    if (vm_coupled_pair_rhs(any, y, found, &p) >= 0) sink[0] = found[0];
    if (vm_coupled_pair_to_modes(&p, any, y, found) >= 0) sink[1] = found[0];
    if (vm_coupled_pair_from_modes(&p, any, y, found) >= 0) sink[2] = found[0];
    if (vm_coupled_pair_oscillator(&p, y, &o) >= 0) sink[3] = o.x;
}

vm_forced any_forced(void)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = any;
    f.damping = any;
    f.reactive = any;
    f.mass = any_law();
    f.stiffness = any_law();
    f.frequency = any_law();
    f.force = any_law();
    return f;
}

void eva_forced(void)
{
    vm_forced f = any_forced();
    vm_real y[3] = {any, any, any}, found[3] = {any, any, any};
    if (vm_forced_init(&f) < 0) return;
    if (vm_forced_rhs(any, y, found, &f) >= 0) sink[0] = found[0];
    if (vm_forced_exact_rhs(any, y, found, &f) >= 0) sink[1] = found[0];
    if (vm_forced_averaged_rhs(any, y, found, &f) >= 0) sink[2] = found[0];
    if (vm_forced_to_averaged(&f, any, y, found) >= 0) sink[3] = found[0];
    if (vm_forced_from_averaged(&f, any, y, found) >= 0) sink[4] = found[0];
}

void eva_resonance(void)
{
    vm_forced f = any_forced();
    vm_steady_state states[3];
    vm_passage passage;
    memset(states, 0, sizeof states);
    memset(&passage, 0, sizeof passage);
    if (vm_forced_init(&f) < 0) return;
    if (vm_forced_steady_states(&f, any, states) > 0) sink[0] = states[0].A;
    if (vm_forced_curve(&f, any, any, states) > 0) sink[1] = states[0].A;
    sink[2] = vm_forced_peak(&f, any);
    if (vm_forced_passage(&f, any, any, &passage) >= 0) sink[3] = passage.drift_ratio;
}

void eva_jeffcott(void)
{
    vm_power_force shaft;
    vm_jeffcott r;
    vm_real y[5] = {any, any, any, any, any}, found[5] = {any, any, any, any, any};
    memset(&r, 0, sizeof r);
    shaft.k = any;
    shaft.alpha = any;
    r.mass = any_law();
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = &shaft;
    r.gyro = any;
    r.reactive = any;
    r.u.re = any;
    r.u.im = any;
    r.nodes = 8;
    if (vm_jeffcott_rhs(any, y, found, &r) >= 0) sink[0] = found[0];
    if (vm_jeffcott_to_averaged(&r, any, y, any, found) >= 0) sink[1] = found[0];
    if (vm_jeffcott_from_averaged(&r, any, y, found) >= 0) sink[2] = found[0];
    if (vm_jeffcott_exact_rhs(any, y, found, &r) >= 0) sink[3] = found[0];
    if (vm_jeffcott_averaged_rhs(any, y, found, &r) >= 0) sink[4] = found[0];
    if (vm_jeffcott_forward_whirl_rhs(any, y, found, &r) >= 0) sink[5] = found[0];
    if (vm_jeffcott_backward_whirl_rhs(any, y, found, &r) >= 0) sink[6] = found[0];
    sink[7] = vm_jeffcott_frequency(&r, any, any, any_int);
}

vm_grounded_pair any_grounded_pair(void)
{
    vm_grounded_pair p;
    memset(&p, 0, sizeof p);
    p.oscillator[0] = any_forced();
    p.oscillator[1] = any_forced();
    p.spring = any;
    p.damper = any;
    p.vibrations[0] = any_int;
    p.vibrations[1] = any_int;
    return p;
}

void eva_grounded_pair(void)
{
    vm_grounded_pair p = any_grounded_pair();
    vm_real y[4] = {any, any, any, any}, found[4] = {any, any, any, any};
    if (vm_grounded_pair_init(&p) < 0) return;
    if (vm_grounded_pair_rhs(any, y, found, &p) >= 0) sink[0] = found[0];
    if (vm_grounded_pair_averaged_rhs(any, y, found, &p) >= 0) sink[1] = found[0];
    if (vm_grounded_pair_to_averaged(&p, any, y, found) >= 0) sink[2] = found[0];
    if (vm_grounded_pair_from_averaged(&p, any, y, found) >= 0) sink[3] = found[0];
}

vm_periodic any_periodic(void)
{
    vm_periodic p;
    int i;
    memset(&p, 0, sizeof p);
    p.oscillator = any_forced();
    for (i = 0; i <= VM_PERIODIC_HARMONICS; i++) {
        p.cosine[i] = any;
        p.sine[i] = any;
    }
    p.vibrations = any_int;
    p.periods = any_int;
    return p;
}

void eva_periodic_samples(void)
{
    vm_periodic p = any_periodic();
    const vm_real g[4] = {any, any, any, any};
    if (vm_periodic_from_samples(&p, 4, g) >= 0) sink[0] = p.cosine[0];
    sink[1] = vm_periodic_shape(&p, any);
}

void eva_periodic(void)
{
    vm_periodic p = any_periodic();
    vm_real y[3] = {any, any, any}, found[3] = {any, any, any};
    if (vm_periodic_init(&p) < 0) return;
    if (vm_periodic_rhs(any, y, found, &p) >= 0) sink[0] = found[0];
    if (vm_periodic_exact_rhs(any, y, found, &p) >= 0) sink[1] = found[0];
    if (vm_periodic_averaged_rhs(any, y, found, &p) >= 0) sink[2] = found[0];
    if (vm_periodic_to_averaged(&p, any, y, found) >= 0) sink[3] = found[0];
    if (vm_periodic_from_averaged(&p, any, y, found) >= 0) sink[4] = found[0];
}

void eva_periodic_steady(void)
{
    vm_periodic p = any_periodic();
    vm_steady_state states[9];
    memset(states, 0, sizeof states);
    if (vm_periodic_init(&p) < 0) return;
    if (vm_periodic_steady_states(&p, any, 9, states) > 0) sink[0] = states[0].A;
    if (vm_periodic_curve(&p, any, any, states) > 0) sink[1] = states[0].A;
}

void eva_jeffcott_motions(void)
{
    vm_power_force shaft;
    vm_jeffcott r;
    vm_jeffcott_whirl whirl;
    vm_complex z, v;
    vm_real y[4] = {any, any, any, any}, found[4] = {any, any, any, any}, rho = any, phi = any;
    memset(&r, 0, sizeof r);
    memset(&whirl, 0, sizeof whirl);
    shaft.k = any;
    shaft.alpha = any;
    r.mass = any_law();
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = &shaft;
    r.gyro = any;
    r.reactive = any;
    r.u.re = any;
    r.u.im = any;
    r.nodes = 8;
    z.re = any;
    z.im = any;
    v.re = any;
    v.im = any;
    sink[0] = vm_jeffcott_amplitude(&r, any, any, any) + vm_jeffcott_whirl_amplitude(&r, any, any, any, any_int);
    if (vm_jeffcott_linear_at(&r, y, any, found) >= 0) sink[1] = found[0];
    if (vm_jeffcott_whirl_at(&r, any, any, any_int, any, &whirl) >= 0) sink[2] = whirl.radius;
    sink[3] = vm_jeffcott_momentum(&r, any, z, v);
    vm_jeffcott_polar(z, &rho, &phi);
    sink[4] = rho + phi + vm_jeffcott_power(any, &rho, &shaft);
}

void eva_pair_by_method(void)
{
    vm_pair p;
    vm_real y[4] = {any, any, any, any}, found[4] = {any, any, any, any};
    p.alpha = any;
    p.k = any;
    p.reactive = any;
    p.mass = any_law();
    if (vm_pair_by_method(&p, any_int, any, y, found) >= 0) sink[0] = found[0];
}

/* ---- Laws by tables and functions ---- */

static int law_function(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    *f = any;
    *rate = any;
    return any_int;
}

void eva_law_table(void)
{
    const vm_real time[3] = {any, any, any}, value[3] = {any, any, any};
    const vm_law law = vm_law_table(3, time, value);
    vm_real f = any, rate = any;
    if (vm_law_at(&law, any, &f, &rate) >= 0) sink[0] = f + rate;
}

void eva_law_table_integral(void)
{
    const vm_real time[3] = {any, any, any}, value[3] = {any, any, any};
    const vm_law law = vm_law_table(3, time, value);
    vm_real integral = any;
    if (vm_law_inverse_integral(&law, any, &integral) >= 0) sink[0] = integral;
}

void eva_law_user(void)
{
    const vm_law law = vm_law_user(law_function, NULL);
    vm_real f = any, rate = any, integral = any;
    if (vm_law_at(&law, any, &f, &rate) >= 0) sink[0] = f + rate;
    if (vm_law_inverse_integral(&law, any, &integral) >= 0) sink[1] = integral;
}

static vm_real osc_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    sink[0] = t + x + v;
    return any;
}

void eva_osc_load(void)
{
    vm_osc_problem o = any_problem();
    vm_osc_load load;
    const vm_law u = any_law(), damping = any_law();
    memset(&load, 0, sizeof load);
    if (any_int) o.force = osc_force;
    if (vm_osc_load_init(&load, &o, any_int ? &u : NULL, any_int ? &damping : NULL) < 0) return;
    sink[1] = vm_osc_load_force(any, any, any, &load);
}

void eva_osc_plan(void)
{
    const vm_osc_problem o = any_problem();
    vm_osc_plan p;
    memset(&p, 0, sizeof p);
    if (vm_osc_plan_init(&p, &o) < 0) return;
    sink[0] = p.Om;
}

void eva_osc_averaged(void)
{
    const vm_osc_problem o = any_problem();
    vm_osc_plan p;
    vm_real a = any, b = any, c = any;
    memset(&p, 0, sizeof p);
    if (vm_osc_plan_init(&p, &o) < 0) return;
    if (vm_osc_averaged(&p, any_int, any, any, &a, &b, &c) >= 0) sink[0] = a + b + c;
}

static int odd_function(vm_real x, vm_real *f, void *ctx)
{
    (void)ctx;
    sink[0] = x;
    *f = any;
    return any_int;
}

void eva_odd_forces(void)
{
    const vm_law laws[2] = {any_law(), any_law()};
    vm_real x = any, v = any;
    vm_odd_force f = vm_duffing_force(any, any);
    sink[0] = vm_odd_action(&f, any) + vm_odd_period(&f, any);
    if (vm_odd_exact_from(&f, any, any, any, &x, &v) >= 0) sink[1] = x + v;
    f = vm_duffing_force_of_laws(laws);
    sink[2] = vm_odd_action(&f, any) + vm_odd_period(&f, any);
}

void eva_odd_user(void)
{
    vm_real x = any, v = any;
    const vm_odd_force f = vm_odd_force_user(odd_function, NULL);
    sink[0] = vm_odd_action(&f, any) + vm_odd_period(&f, any);
    if (vm_odd_exact_from(&f, any, any, any, &x, &v) >= 0) sink[1] = x + v;
}

vm_odd_problem any_odd_problem(void)
{
    vm_odd_problem o;
    o.force = vm_duffing_force(any, any);
    o.mass = any_law();
    o.stiffness = any_law();
    o.damping = any_law();
    o.reactive = any;
    o.x = any;
    o.v = any;
    return o;
}

void eva_odd_rhs(void)
{
    vm_odd_problem o = any_odd_problem();
    vm_real y[2] = {any, any}, rates[2] = {any, any};
    if (vm_odd_rhs(any, y, rates, &o) >= 0) sink[0] = rates[0];
}

void eva_vdp_cycle(void)
{
    vm_vdp v = any_vdp();
    vm_vdp_cycle cycle;
    memset(&cycle, 0, sizeof cycle);
    if (vm_vdp_init(&v) < 0) return;
    if (vm_vdp_cycle_of(&v, &cycle) >= 0) sink[0] = cycle.period;
}

static void motion_function(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    *x = any;
    *v = any;
}

static vm_real amplitude_law(vm_real t, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    return any;
}

void eva_samples(void)
{
    vm_sample samples[3];
    long n;
    memset(samples, 0, sizeof samples);
    n = vm_find_samples(motion_function, NULL, any_int, any, any, any, 3, samples);
    sink[0] = (vm_real)n;
    sink[1] = vm_envelope_error(any_int, 3, samples, amplitude_law, NULL);
}
