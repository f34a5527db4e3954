/* Oscillators with slow mass: what cancels in the law of order five. The motions are solved exactly (docs/law.md,
   section 7), because the number G_0, which disturbs the slow motion, vanishes. The phase at t is 20 to 130, and its
   rounding by a few units in the last place makes an error of x of up to 96 eps. */

/* A leak without reactive force, m = (1 + x1 t)^(alpha+3), alpha = x0, at t = x2, from the place x3 and the velocity
   x4. The motion is x = A el ca(psi + W t/el) with el = 1 + x1 t. A and psi belong to the place and to the velocity
   V = v - x1 x, and W is the rate of the phase at t = 0. */
static vm_osc_problem leak_problem(const vm_real *x)
{
    vm_osc_problem p;
    memset(&p, 0, sizeof p);
    p.alpha = x[0];
    p.mass = vm_law_power(1, x[1], x[0] + 3);
    p.stiffness = vm_law_linear(1, 0);
    p.x = x[3];
    p.v = x[4];
    return p;
}
static vm_real leak_ours(const vm_real *x)
{
    const vm_osc_problem p = leak_problem(x);
    vm_osc_closed motion;
    vm_real place = VM_NAN, v;
    if (vm_osc_closed_init(&motion, &p, 5, x[2]) != VM_OK) return VM_NAN;
    return vm_osc_closed_at(&motion, x[2], &place, &v) == VM_OK ? place : VM_NAN;
}
/* The rate of the phase at the amplitude A, for m = k = 1 */
static vm_real rate_of_phase(vm_real A, vm_real alpha) { return SQRT((alpha + 1) / 2) * POW(A, (alpha - 1) / 2); }
/* x of the solved motion, from sa and ca at t = 0 and the integral of the rate of the phase by W */
static vm_real leak_from(const vm_real *x, vm_real A, vm_real sa, vm_real ca, vm_real way)
{
    return A * (1 + x[1] * x[2]) * ateb_ca(ateb_phase(sa, ca, x[0]) + rate_of_phase(A, x[0]) * way, x[0]);
}
static vm_real leak_amplitude(const vm_real *x, vm_real V)
{
    return POW(POW(FABS(x[3]), x[0] + 1) + (x[0] + 1) / 2 * V * V, 1 / (x[0] + 1));
}
static vm_real leak_sa(const vm_real *x, vm_real A, vm_real V)
{
    return -SQRT((x[0] + 1) / 2) * V / POW(A, (x[0] + 1) / 2);
}
/* As averaging of first order has it, by the velocity v in the place of V */
static vm_real leak_naive(const vm_real *x)
{
    const vm_real A = leak_amplitude(x, x[4]);
    return leak_from(x, A, leak_sa(x, A, x[4]), x[3] / A, x[2] / (1 + x[1] * x[2]));
}
/* The integral of 1/el^2 by its antiderivative */
static vm_real slow_leak_ours(const vm_real *x) { return leak_ours(x); }
static vm_real slow_leak_naive(const vm_real *x)
{
    const vm_real V = x[4] - x[1] * x[3], A = leak_amplitude(x, V);
    return leak_from(x, A, leak_sa(x, A, V), x[3] / A, (1 - 1 / (1 + x[1] * x[2])) / x[1]);
}
/* The phase from the place alone, |sa| = sqrt(1 - |ca|^(alpha+1)) */
static vm_real turning_leak_ours(const vm_real *x) { return leak_ours(x); }
static vm_real turning_leak_naive(const vm_real *x)
{
    const vm_real V = x[4] - x[1] * x[3], A = leak_amplitude(x, V), ca = x[3] / A;
    const vm_real sa = -VM_COPYSIGN(SQRT(FABS(1 - POW(FABS(ca), x[0] + 1))), V);
    return leak_from(x, A, sa, ca, x[2] / (1 + x[1] * x[2]));
}
/* The phase from the velocity alone, |ca| = (1 - sa^2)^(1/(alpha+1)) */
static vm_real crossing_leak_ours(const vm_real *x) { return leak_ours(x); }
static vm_real crossing_leak_naive(const vm_real *x)
{
    const vm_real V = x[4] - x[1] * x[3], A = leak_amplitude(x, V), sa = leak_sa(x, A, V);
    const vm_real ca = VM_COPYSIGN(POW(FABS(1 - sa * sa), 1 / (x[0] + 1)), x[3]);
    return leak_from(x, A, sa, ca, x[2] / (1 + x[1] * x[2]));
}
/* rk4 with eight steps in a second */
static vm_real wall_leak_ours(const vm_real *x) { return leak_ours(x); }
static void leak_equations(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real m = POW(1 + x[1] * t, x[0] + 3);
    dydt[0] = y[1];
    dydt[1] = y[0] == 0 ? 0 : -VM_COPYSIGN(POW(FABS(y[0]), x[0]), y[0]) / m;
}
static vm_real wall_leak_naive(const vm_real *x)
{
    vm_real y[2];
    y[0] = x[3];
    y[1] = x[4];
    naive_rk4(leak_equations, x, 2, y, x[2], (long)(x[2] * 8));
    return y[0];
}

/* The amplitude of the same motion. The textbook has it from the frequency, A = (W/sqrt(k/m))^(2/(alpha-1)) but for a
   factor. */
static vm_real leak_width_ours(const vm_real *x)
{
    const vm_osc_problem p = leak_problem(x);
    vm_osc_motion motion;
    return vm_osc_by_route(&p, VM_ROUTE_ORDER5, x[2], 0, &motion) == VM_OK ? motion.amplitude : VM_NAN;
}
static vm_real leak_width_naive(const vm_real *x)
{
    const vm_real el = 1 + x[1] * x[2], W = rate_of_phase(leak_amplitude(x, x[4] - x[1] * x[3]), x[0]) / (el * el);
    return POW(W / SQRT((x[0] + 1) / 2 * POW(el, -x[0] - 3)), 2 / (x[0] - 1));
}

/* Without a reactive force, alpha = 1, m = (1 + x1 t)^(4 + x0), from rest at x = 1, at t = x2: Bessel functions. G_0 is
   small, but not 0. Naive: the solved motion's formula with v in the place of V */
static vm_real nearly_solved_ours(const vm_real *x)
{
    vm_osc_problem p;
    vm_osc_motion motion;
    memset(&p, 0, sizeof p);
    p.alpha = 1;
    p.mass = vm_law_power(1, x[1], 4 + x[0]);
    p.stiffness = vm_law_linear(1, 0);
    p.x = 1;
    return vm_osc_by_route(&p, VM_ROUTE_ORDER5, x[2], 0, &motion) == VM_OK ? motion.x : VM_NAN;
}
static vm_real nearly_solved_naive(const vm_real *x)
{
    const vm_real el = 1 + x[1] * x[2];
    return el * COS(x[2] / el);
}

/* Half of the reactive force: with any law of mass A is constant, and the phase is the integral of W sqrt(1/m). From
   rest at x = 1, alpha = x0 */
static vm_real half_reactive(vm_real alpha, vm_law mass, vm_real t)
{
    vm_osc_problem p;
    vm_osc_motion motion;
    memset(&p, 0, sizeof p);
    p.alpha = alpha;
    p.mass = mass;
    p.stiffness = vm_law_linear(1, 0);
    p.reactive = VM_C(0.5);
    p.x = 1;
    return vm_osc_by_route(&p, VM_ROUTE_ORDER5, t, 0, &motion) == VM_OK ? motion.x : VM_NAN;
}
/* m = 1 + x1 t + x2 t^2, t = x3; naive: the logarithm of the integral tables */
static vm_real half_quadratic_ours(const vm_real *x)
{
    return half_reactive(x[0], vm_law_quadratic(1, x[1], x[2]), x[3]);
}
static vm_real half_quadratic_naive(const vm_real *x)
{
    const vm_real m = 1 + x[1] * x[3] + x[2] * x[3] * x[3], root = SQRT(x[2]);
    const vm_real ln = LOG((2 * root * SQRT(m) + 2 * x[2] * x[3] + x[1]) / (2 * root + x[1]));
    return ateb_ca(SQRT((x[0] + 1) / 2) * ln / root, x[0]);
}
/* A table of six points, t = x1; naive: the trapezoidal rule with two steps from point to point */
enum { TABLE_POINTS = 6 };
static const vm_real half_times[TABLE_POINTS] = {0, 20, 40, 60, 80, 100};
static const vm_real half_masses[TABLE_POINTS] = {1, VM_C(1.125), VM_C(1.5), VM_C(1.75), VM_C(2.5), VM_C(2.75)};
static vm_real half_table_ours(const vm_real *x)
{
    return half_reactive(x[0], vm_law_table(TABLE_POINTS, half_times, half_masses), x[1]);
}
static vm_real half_table_naive(const vm_real *x)
{
    const vm_law law = vm_law_table(TABLE_POINTS, half_times, half_masses);
    const int steps = (int)(x[1] / 10) + 1;
    vm_real sum = 0, m = 1, rate;
    int i;
    for (i = 0; i <= steps; i++) {
        const vm_real weight = i == 0 || i == steps ? VM_C(0.5) : 1;
        if (vm_law_at(&law, x[1] * (vm_real)i / (vm_real)steps, &m, &rate)) return VM_NAN;
        sum += weight / SQRT(m);
    }
    return ateb_ca(SQRT((x[0] + 1) / 2) * sum * x[1] / (vm_real)steps, x[0]);
}

static const hard_case slow_oscillators_cases[] = {
    CASE(leak, 96, "position if G_0 = 0, so that an exact solution exists: averaging has an error of first order", 3,
         0.0078125, 128, 0.8125, -0.375),
    CASE(leak, 96, "position if G_0 = 0 and alpha = 1/2: averaging has an error of first order", 0.5, 0.0078125, 128,
         0.8125, -0.375),
    CASE(leak, 96, "position if G_0 = 0, backward in time: averaging has an error of first order", 3, 0.0078125, -64,
         0.8125, -0.375),
    CASE(leak, 96, "position if G_0 = 0 and alpha = 1, a linear oscillator: averaging has an error of first order", 1,
         0.0078125, 128, 0.8125, -0.375),
    CASE(leak, 96, "position if G_0 = 0 and alpha is next to 1: averaging has an error of first order",
         R(1.0000000001, 1.0001), 0.0078125, 128, 0.8125, -0.375),
    CASE(slow_leak, 96,
         "position for a small rate q: the integral of 1/(1 + q t)^2, a difference divided by q, cancels", 3,
         R(1e-13, 1e-6), 40, 0.8125, -0.375),
    CASE(slow_leak, 96, "position for a small negative rate q: the difference in this integral cancels", 1.5,
         R(-1e-10, -1e-6), 40, 0.8125, -0.375),
    CASE(slow_leak, 96, "position for the rate q = 0: the formula for the integral of 1/(1 + q t)^2 is 0/0", 3, 0, 40,
         0.8125, -0.375),
    CASE(turning_leak, 96,
         "position after a start next to a turning point (sa -> 0): sa from x/A loses the digits of the velocity", 3,
         0.0078125, 120, 0.8125, R(0.00634765725, 0.0062)),
    CASE(turning_leak, 96,
         "position after such a start with x < 0, alpha = 1/2: sa from x/A loses the digits of the velocity", 0.5,
         0.0078125, 128, -0.8125, R(-0.00634765525, -0.0062)),
    CASE(crossing_leak, 96, "position after a start next to x = 0 (ca -> 0): ca from 1 - sa^2 loses the digits of x", 3,
         0.0078125, 128, 1e-9, 0.75),
    CASE(crossing_leak, 96, "position after a start next to x = 0, alpha = 2: ca from 1 - sa^2 loses the digits of x",
         2, 0.0078125, 128, R(-1e-6, -1e-3), -0.75),
    CASE(wall_leak, 96, "position for alpha = 0 by rk4: the force k sign(x) jumps at each zero of x", 0, 0.0078125, 128,
         0.8125, -0.375),
    CASE(wall_leak, 96, "position for a small alpha by rk4: the force nearly jumps at each zero of x", R(1e-12, 1e-5),
         0.0078125, 128, 0.8125, -0.375),
    CASE(wall_leak, 96, "position for alpha = 1/8 by rk4: the force has no derivative at x = 0", 0.125, 0.0078125, 128,
         0.8125, -0.375),
    CASE(leak_width, 32, "amplitude from the frequency for alpha next to 1: the exponent 2/(alpha - 1) is large",
         R(1.000000001, 1.001), 0.0078125, 128, 0.8125, -0.375),
    CASE(leak_width, 32, "amplitude from the frequency for alpha = 1: the formula is 1 to the power of infinity", 1,
         0.0078125, 128, 0.8125, -0.375),
    CASE(nearly_solved, 96,
         "position for a small G_0, a difference that cancels: averaging has an error of first order", R(1e-9, 1e-4),
         0.0078125, 128),
    CASE(nearly_solved, 96, "position for a small negative G_0: averaging has an error of first order",
         R(-1e-12, -1e-6), 0.015625, 128),
    CASE(half_quadratic, 96, "position for the mass 1 + b t + c t^2, c small: the phase ln(...)/sqrt(c) tends to 0/0",
         3, 0.03125, R(1e-13, 1e-8), 64),
    CASE(half_quadratic, 96, "position for the mass 1 + b t + c t^2 with c = 0: the formula for the phase is 0/0", 1.5,
         0.03125, 0, 64),
    CASE(half_table, 96, "position for a mass from a table, at a point of the table: the trapezoidal rule is inexact",
         3, 40),
    CASE(half_table, 96, "position for a mass from a table, shortly after a point: the trapezoidal rule is inexact", 3,
         R(60.000000001, 60.0001)),
    CASE(half_table, 96,
         "position for a mass from a table, at its last point, alpha = 1/2: the trapezoidal rule is inexact", 0.5, 100),
};
