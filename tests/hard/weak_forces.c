/* Oscillators under weak forces: Van der Pol's oscillator with next to no feed, or that starts on its limit cycle;
   small vibrations and small differences of two bodies; a periodic force with next to no damping or detuning. */

/* Van der Pol's oscillator of the exponent 1, mass, stiffness 1, feed = c = x0: x at the time x3, from x1 and x' = x2.
   Naive: A cos psi, with the amplitude of first order and psi = t, in the usual formula */
static vm_real feeding_ours(const vm_real *x)
{
    vm_osc_motion motion;
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = v.k = v.reactive = 1;
    v.feed = v.c = x[0];
    v.mass = vm_law_linear(1, 0);
    return vm_vdp_within(&v, x[1], x[2], x[3], R(VM_C(1e-13), VM_C(1e-5)), &motion) >= 0 ? motion.x : VM_NAN;
}
static vm_real feeding_naive(const vm_real *x)
{
    const vm_real A0 = SQRT(x[1] * x[1] + x[2] * x[2]), psi = ATAN2(-x[2], x[1]);
    const vm_real grown = EXP(x[0] * x[3]);
    const vm_real A = 2 / SQRT(1 + (4 / (A0 * A0) - 1) / grown);
    return A * COS(psi + x[3]);
}

/* Two bodies of the masses x0, x2 and of the rates x1, x3 of mass, joined by a spring, whose mass centre moves at
   1 m/s: the force that the drift exerts on their relative motion */
static int drifting_pair(const vm_real *x, vm_coupled_pair *pair, vm_osc_problem *problem)
{
    static const vm_connection spring = {1, 3};
    const vm_real y[4] = {0, 0, 1, 1};
    memset(pair, 0, sizeof *pair);
    pair->mass[0] = vm_law_linear(x[0], x[1]);
    pair->mass[1] = vm_law_linear(x[2], x[3]);
    pair->reactive = 1;
    pair->n = 1;
    pair->connections = &spring;
    return vm_coupled_pair_oscillator(pair, y, problem);
}
static vm_real pair_drift_ours(const vm_real *x)
{
    vm_coupled_pair pair;
    vm_osc_problem problem;
    if (drifting_pair(x, &pair, &problem) || !problem.force) return VM_NAN;
    return problem.force(0, 0, 0, problem.ctx);
}
static vm_real pair_drift_naive(const vm_real *x)
{
    const vm_real reduced = x[0] * x[2] / (x[0] + x[2]);
    return -reduced * (x[3] / x[2] - x[1] / x[0]);
}
/* The rate of their reduced mass. Naive: the derivative of a quotient */
static vm_real reduced_rate_ours(const vm_real *x)
{
    vm_coupled_pair pair;
    vm_osc_problem problem;
    vm_real mass, rate;
    if (drifting_pair(x, &pair, &problem) || vm_law_at(&problem.mass, 0, &mass, &rate)) return VM_NAN;
    return rate;
}
static vm_real reduced_rate_naive(const vm_real *x)
{
    const vm_real whole = x[0] + x[2];
    return (x[1] * x[2] + x[0] * x[3]) / whole - x[0] * x[2] / (whole * whole) * (x[1] + x[3]);
}
/* Their mass centre, where the bodies are at 3 and 5. Naive: by the moments of the masses */
static vm_real pair_centre_ours(const vm_real *x)
{
    const vm_real y[4] = {x[4], x[5], 0, 0};
    vm_coupled_pair pair;
    vm_osc_problem problem;
    vm_real modes[4];
    if (drifting_pair(x, &pair, &problem) || vm_coupled_pair_to_modes(&pair, 0, y, modes)) return VM_NAN;
    return modes[2];
}
static vm_real pair_centre_naive(const vm_real *x) { return (x[0] * x[4] + x[2] * x[5]) / (x[0] + x[2]); }

/* Two linear oscillators, m = k = 1, of the amplitudes x0 and x1, coupled by the spring x2, in phase: the rate of the
   first phase. Naive: from the work of the coupling and the energy of the first */
static vm_real coupled_rate_ours(const vm_real *x)
{
    vm_real y[4] = {x[0], 0, x[1], 0}, rates[4];
    vm_grounded_pair p;
    memset(&p, 0, sizeof p);
    p.oscillator[0].alpha = p.oscillator[1].alpha = 1;
    p.oscillator[0].mass = p.oscillator[1].mass = vm_law_linear(1, 0);
    p.oscillator[0].stiffness = p.oscillator[1].stiffness = vm_law_linear(1, 0);
    p.spring = x[2];
    p.vibrations[0] = p.vibrations[1] = 1;
    if (vm_grounded_pair_init(&p) || vm_grounded_pair_averaged_rhs(0, y, rates, &p)) return VM_NAN;
    return rates[1];
}
static vm_real coupled_rate_naive(const vm_real *x)
{
    return 1 + x[2] / 2 * (1 - x[0] * x[1] / (x[0] * x[0]));
}

/* Steady amplitude of a linear oscillator, m = k = 1, damping x0, under the force x1 cos theta of the frequency x2, by
   averaging. Naive: the square of the detuning is multiplied out */
static vm_real lightly_damped_ours(const vm_real *x)
{
    vm_steady_state steady[4];
    vm_periodic p;
    memset(&p, 0, sizeof p);
    p.oscillator.alpha = 1;
    p.oscillator.damping = x[0];
    p.oscillator.mass = p.oscillator.stiffness = vm_law_linear(1, 0);
    p.oscillator.force = vm_law_linear(x[1], 0);
    p.oscillator.frequency = vm_law_linear(x[2], 0);
    p.cosine[1] = 1;
    p.vibrations = p.periods = 1;
    if (vm_periodic_init(&p)) return VM_NAN;
    return vm_periodic_steady_states(&p, 0, 4, steady) > 0 ? steady[0].A : VM_NAN;
}
static vm_real lightly_damped_naive(const vm_real *x)
{
    return x[1] / 2 / SQRT(1 - 2 * x[2] + x[2] * x[2] + x[0] * x[0] / 4);
}

static const hard_case weak_forces_cases[] = {
    CASE(feeding, R(100, 60),
         "position of a Van der Pol oscillator with nearly no feed, from rest: averaging is inexact", R(1e-9, 1e-3),
         0.5, 0, 30),
    CASE(feeding, R(200, 100),
         "position of a Van der Pol oscillator with nearly no feed, from x = 0: averaging is inexact", R(1e-9, 1e-2), 0,
         0.5, 60),
    CASE(feeding, R(200, 100),
         "position of a Van der Pol oscillator from rest next to its limit cycle: averaging is inexact", R(1e-3, 1e-2),
         R(2.0000001, 2.001), 0, 30),
    CASE(feeding, R(200, 100),
         "position of a Van der Pol oscillator from x = 0 next to its limit cycle: averaging is inexact", R(1e-3, 1e-2),
         0, R(2.0000001, 2.001), 30),
    CASE(feeding, R(200, 100),
         "position of a Van der Pol oscillator from rest at x = 2, its cycle of first order: averaging is inexact",
         R(1e-3, 1e-2), 2, 0, 30),
    CASE(pair_drift, 8,
         "force on a relative motion, if two masses grow at nearly the same relative rate: the rates cancel", 0.3, 0.1,
         0.6, R(0.2000000001, 0.20001)),
    CASE(pair_drift, 8,
         "force on a relative motion, if nearly equal masses grow at the same rate: relative rates cancel", 0.7, 0.1,
         R(0.70000000003, 0.70003), 0.1),
    CASE(reduced_rate, 8,
         "rate of the reduced mass m1 m2/(m1 + m2), if one body is far heavier: the difference cancels", R(1e9, 1e5),
         R(1e7, 1e4), 1, R(1e-10, 1e-4)),
    CASE(pair_centre, 4, "mass centre of very heavy bodies: the products of mass and position overflow",
         R(1e200, 1e25), 0, R(3e200, 3e25), 0, R(3e150, 3e20), R(5e150, 5e20)),
    CASE(coupled_rate, 8,
         "rate of the phase of a coupled oscillator, if amplitudes are very small: their squares underflow",
         R(3e-170, 3e-25), R(1e-170, 1e-25), 0.125),
    CASE(coupled_rate, 8,
         "rate of the phase of a coupled oscillator, if amplitudes are very large: their squares overflow",
         R(3e170, 3e25), R(1e170, 1e25), 0.125),
    CASE(lightly_damped, 16,
         "steady amplitude in resonance with nearly no damping and detuning: 1 - 2 nu + nu^2 cancels", R(1e-9, 1e-4),
         1e-3, R(1.000000003, 1.0003)),
    CASE(lightly_damped, 16,
         "steady amplitude slightly below resonance with nearly no damping: 1 - 2 nu + nu^2 cancels", R(1e-9, 1e-4),
         1e-3, R(0.999999998, 0.9998)),
    CASE(lightly_damped, 16,
         "steady amplitude with much less damping than detuning, above resonance: 1 - 2 nu + nu^2 cancels",
         R(1e-9, 1e-6), 1e-3, R(1.0001, 1.001)),
    CASE(lightly_damped, 16,
         "steady amplitude with much less damping than detuning, below resonance: 1 - 2 nu + nu^2 cancels",
         R(1e-9, 1e-6), 1e-3, R(0.9999, 0.999)),
};
