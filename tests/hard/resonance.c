/* Resonance: next to it, caught by it, and at the border of being caught. */

/* Steady radius of a rotor of mass x0, stiffness x1, s = 1/8, at Omega = x2 (76) */
static vm_broken_rotor resonant_rotor(const vm_real *x)
{
    vm_broken_rotor rotor = {1, 2, 1, VM_C(0.5), 1, VM_C(0.125)};
    rotor.mass = x[0], rotor.stiffness = x[1];
    return rotor;
}
static vm_real near_resonance_ours(const vm_real *x)
{
    const vm_broken_rotor rotor = resonant_rotor(x);
    return vm_broken_rotor_steady_radius(&rotor, x[2]);
}
static vm_real near_resonance_naive(const vm_real *x)
{
    const vm_real w = SQRT(x[1] / x[0]);
    return VM_C(0.125) * w * w / (w * w - x[2] * x[2]);
}
/* The slowest rate of what is left of a disturbance, by Newton's method from 0 on (81) */
static vm_real slowest_rate_ours(const vm_real *x)
{
    const vm_broken_rotor rotor = resonant_rotor(x);
    vm_real re[5], im[5];
    return vm_broken_rotor_eigenvalues(&rotor, x[2], re, im) == VM_OK ? re[0] : VM_NAN;
}
static vm_real slowest_rate_naive(const vm_real *x)
{
    const vm_real w2 = x[1] / x[0], O2 = x[2] * x[2], D = w2 - O2, k = VM_C(0.25);
    const vm_real G = x[0] / 2 * w2 * w2 / (64 * D);
    const vm_real c[6] = {1, k, 2 * (w2 + O2) + G, 2 * k * (w2 + O2), D * D + G * (w2 + 3 * O2), k * D * D};
    vm_real l = 0;
    int i, j;
    for (i = 0; i < 50; i++) {
        vm_real p = 0, slope = 0;
        for (j = 0; j < 6; j++) slope = slope * l + p, p = p * l + c[j];
        l -= p / slope;
    }
    return l;
}
/* The last entry of Routh's column, k* D^2 */
static vm_real routh_ours(const vm_real *x)
{
    const vm_broken_rotor rotor = resonant_rotor(x);
    vm_real column[6];
    return vm_broken_rotor_routh(&rotor, x[2], column) == VM_OK ? column[5] : VM_NAN;
}
static vm_real routh_naive(const vm_real *x)
{
    const vm_real D = x[1] / x[0] - x[2] * x[2];
    return D * D / 4;
}
/* Stable or not: 1 for Omega < omega */
static vm_real stable_ours(const vm_real *x)
{
    const vm_broken_rotor rotor = resonant_rotor(x);
    return (vm_real)vm_broken_rotor_is_stable(&rotor, x[2]);
}
static vm_real stable_naive(const vm_real *x) { return x[2] < SQRT(x[1] / x[0]) ? 1 : 0; }

/* Radius at t = x0 of a rotor caught by its resonance, of mass 1, stiffness x1, s = 1/8, that is driven to x2: by the
   closed form R^2/(2A) - B R/A^2 + (B^2/A^3) ln(1 + A R/B) = t, solved by Newton's method */
static vm_real caught_ours(const vm_real *x)
{
    vm_real point[2];
    vm_broken_rotor rotor;
    point[0] = 1, point[1] = x[1];
    rotor = resonant_rotor(point);
    return vm_broken_rotor_resonance_radius(&rotor, x[0], x[2]);
}
static vm_real caught_naive(const vm_real *x)
{
    const vm_real w = SQRT(x[1]), A = VM_C(0.5) * (x[2] - w) / (2 * w), B = VM_C(0.5) / 32;
    vm_real r = SQRT(2 * A * x[0]) + 1;
    int i;
    for (i = 0; i < 40; i++) {
        const vm_real f = r * r / (2 * A) - B * r / (A * A) + B * B / (A * A * A) * LOG(1 + A * r / B) - x[0];
        r -= f * (A + B / r) / r;
    }
    return VM_C(0.03125) + r;
}
/* The rotor itself, stiffness 1, torque x0, from rest to t = x1: x. Naive: rk4, 20 steps per radian of the shaft */
static vm_real caught_path_ours(const vm_real *x)
{
    const vm_real y[6] = {0, 0, 0, 0, 0, 0};
    vm_broken_rotor rotor = {1, 2, 1, VM_C(0.5), 1, VM_C(0.125)};
    vm_real work[RK87_WORK(6)];
    rk87_options o;
    rk87 s;
    memset(&o, 0, sizeof o);
    o.rtol = R(VM_C(1e-13), VM_C(4e-5)), rotor.torque = x[0];
    if (rk87_init(&s, vm_broken_rotor_rhs, &rotor, 6, 0, y, &o, work) < 0 || rk87_solve(&s, x[1]) < 0) return VM_NAN;
    return s.y[0];
}
static void caught_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real c = COS(y[2]), s = SIN(y[2]), fx = -(y[0] + c / 8), fy = -(y[1] + s / 8);
    (void)t;
    dydt[0] = y[3], dydt[1] = y[4], dydt[2] = y[5], dydt[3] = fx, dydt[4] = fy;
    dydt[5] = (x[0] - y[5] / 2 + (c * fy - s * fx) / 8) / 2;
}
static vm_real caught_path_naive(const vm_real *x)
{
    vm_real y[6] = {0, 0, 0, 0, 0, 0};
    naive_rk4(caught_equations, x, 6, y, x[1], (long)(x[1] * 2));
    return y[0];
}

/* Steady amplitude number x2, alpha = 3, m = k = 1, b = 1/64, force x0, frequency x1. Naive: A by fixed-point
   iteration from the backbone */
static vm_forced hard_spring(vm_real force, vm_real nu)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = 3;
    f.damping = VM_C(0.015625);
    f.mass = f.stiffness = vm_law_linear(1, 0);
    f.force = vm_law_linear(force, 0);
    f.frequency = vm_law_linear(nu, 0);
    return f;
}
static vm_real folded_ours(const vm_real *x)
{
    vm_forced f = hard_spring(x[0], x[1]);
    vm_steady_state steady[3];
    if (vm_forced_init(&f)) return VM_NAN;
    return vm_forced_steady_states(&f, 0, steady) > (int)x[2] ? steady[(int)x[2]].A : VM_NAN;
}
static vm_real folded_naive(const vm_real *x)
{
    vm_forced f = hard_spring(x[0], x[1]);
    vm_real A = x[2] == 0 ? 0 : x[1] / SQRT(f.stiffness.f0), w, off;
    int i;
    if (vm_forced_init(&f)) return VM_NAN;
    A /= f.Om1;
    for (i = 0; i < 200; i++) {
        w = f.Om1 * A, off = w - x[1];
        A = SQRT(x[0] * f.G / (SQRT(off * off + f.damping * f.damping / 9) * f.Om1));
    }
    return A;
}

/* Passage through a resonance: m = k = 1, alpha = x0, damping x1, force x2, frequency 1/2 + x3 t, at rest at t = 0; x
   at t = x4. Naive: rk4, 6 steps a period */
static vm_real passage_ours(const vm_real *x)
{
    const vm_real y[3] = {0, 0, 0};
    vm_real work[RK87_WORK(3)];
    vm_forced f;
    rk87_options o;
    rk87 s;
    memset(&f, 0, sizeof f);
    memset(&o, 0, sizeof o);
    f.alpha = x[0];
    f.damping = x[1];
    f.mass = f.stiffness = vm_law_linear(1, 0);
    f.frequency = vm_law_linear(VM_C(0.5), x[3]);
    f.force = vm_law_linear(x[2], 0);
    o.rtol = R(VM_C(1e-13), VM_C(4e-5));
    if (vm_forced_init(&f)) return VM_NAN;
    if (rk87_init(&s, vm_forced_rhs, &f, 3, 0, y, &o, work) < 0 || rk87_solve(&s, x[4]) < 0) return VM_NAN;
    return s.y[0];
}
static void swept(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real theta = t / 2 + x[3] / 2 * t * t;
    dydt[0] = y[1], dydt[1] = x[2] * COS(theta) - x[1] * y[1] - (x[0] == 1 ? y[0] : y[0] * y[0] * y[0]);
}
static vm_real passage_naive(const vm_real *x)
{
    vm_real y[2] = {0, 0};
    naive_rk4(swept, x, 2, y, x[4], (long)x[4]);
    return y[0];
}

static const hard_case resonance_cases[] = {
    CASE(near_resonance, 4, "radius of a steadily turning rotor just below resonance: omega^2 - Omega^2 cancels", 0.3,
         0.7, R(1.52752523, 1.5275)),
    CASE(near_resonance, 4, "radius of a steadily turning rotor closer below resonance: omega^2 - Omega^2 cancels", 0.3,
         0.7, R(1.527525231651, 1.527525)),
    CASE(near_resonance, 4, "radius of a steadily turning rotor just above resonance: the sign is lost, too", 0.3, 0.7,
         R(1.527525231653, 1.5275255)),
    CASE(slowest_rate, 16,
         "slowest decay of a rotor's disturbance next to resonance: lost in the rounding of coefficients", 0.3, 0.7,
         R(1.5275, 1.527)),
    CASE(slowest_rate, 16,
         "slowest decay of a rotor's disturbance closer to resonance: lost in the rounding of coefficients", 0.3, 0.7,
         R(1.5275252, 1.52751)),
    CASE(routh, 8, "last entry of Routh's column of a rotor next to resonance: omega^2 - Omega^2 cancels", 0.3, 0.7,
         R(1.52752523, 1.5275)),
    CASE(routh, 8, "last entry of Routh's column of a rotor closer to resonance: omega^2 - Omega^2 cancels", 0.3, 0.7,
         R(1.527525231651, 1.527525)),
    CASE(stable, 0.1,
         "stability (0 or 1) of a rotor that is stable by less than an eps: the rounding of sqrt(c/m) decides", 1, 3,
         R(1.7320508075688772, 1.7320508)),
    CASE(stable, 0.1,
         "stability of another rotor that is stable by less than an eps: the rounding of sqrt(c/m) decides", 1, R(6, 7),
         R(2.449489742783178, 2.64575123787)),
    CASE(caught, 8,
         "radius of a rotor that stays in resonance, driven a little above it: terms with 1/A^3, A small, cancel", 100,
         1, R(1.000001, 1.001)),
    CASE(caught, 8, "radius of a rotor that stays in resonance, driven exactly at it (A = 0): the formula is 0/0", 100,
         1, 1),
    CASE(caught, 8, "radius of a rotor that stays in resonance, soon after the start: terms with 1/A^3 cancel",
         R(1e-9, 1e-4), 1, 1.25),
    CASE(caught_path, R(3e4, 2000), "position of a rotor that stays below resonance, by rk4: the steps are too long",
         0.4375, 60),
    CASE(caught_path, R(3e4, 2000), "position of a rotor that comes into resonance, by rk4: the steps are too long",
         0.5, 60),
    CASE(caught_path, R(3e4, 2000),
         "position of a rotor that the resonance keeps from speeding up, by rk4: the steps are too long", 0.75, 60),
    CASE(folded, 16,
         "largest of three steady amplitudes at one frequency, by iteration: the iteration does not find it", 0.0625,
         1.0625, 2),
    CASE(folded, 16, "unstable one of three steady amplitudes at one frequency: the iteration moves away from it",
         0.0625, 1.0625, 1),
    CASE(folded, 16, "unstable one of three steady amplitudes at another frequency: the iteration moves away from it",
         0.125, 1.75, 1),
    CASE(passage, R(1e5, 2e4),
         "position of a linear oscillator swept through resonance, by rk4: 6 steps a period are too few", 1, 0, 0.125,
         0.0078125, 128),
    CASE(passage, R(1e5, 2e4),
         "position of a damped linear oscillator swept through resonance, by rk4: too few steps a period", 1, 0.03125,
         0.125, 0.015625, 100),
    CASE(passage, R(1e5, 4e4),
         "position on a hard spring that follows a rising frequency in resonance, by rk4: too few steps", 3, 0, 0.25,
         0.0078125, 100),
    /* float: the roundings of a run, 6e4; they fall otherwise with every other step size */
    CASE(passage, R(1e5, 1e5),
         "position on a hard spring that follows a rising frequency and then leaves it, by rk4: too few steps", 3,
         0.0625, 0.25, 0.015625, 100),
    CASE(passage, R(1e5, 3e5),
         "position on a hard spring, if the frequency rises fast through resonance, by rk4: too few steps", 3, 0, 0.25,
         0.0625, 60),
    CASE(passage, R(1e5, 4e4),
         "position on a hard spring at the limit between following and leaving, by rk4: too few steps", 3, 0, 0.125,
         0.0078125, 100),
};
