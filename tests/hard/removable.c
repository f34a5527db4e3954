/* Removable singularities: 0/0, or what is next to it, where the function itself is smooth. */

/* Means of cn^2, cn^4, cn^6, (383), (384), (408) */
static vm_real mean_of(int which, vm_real m)
{
    vm_real C[3];
    jacobi_cn_means(m, C, C + 1, C + 2);
    return C[which];
}
static vm_real C2_ours(const vm_real *x) { return mean_of(0, x[0]); }
static vm_real C4_ours(const vm_real *x) { return mean_of(1, x[0]); }
static vm_real C6_ours(const vm_real *x) { return mean_of(2, x[0]); }
static vm_real C2_naive(const vm_real *x) { return (jacobi_E(x[0]) / jacobi_K(x[0]) - 1 + x[0]) / x[0]; }
static vm_real C4_naive(const vm_real *x) { return (2 * (2 * x[0] - 1) * C2_naive(x) + (1 - x[0])) / (3 * x[0]); }
static vm_real C6_naive(const vm_real *x)
{
    return (4 * (2 * x[0] - 1) * C4_naive(x) + 3 * (1 - x[0]) * C2_naive(x)) / (5 * x[0]);
}

/* The integral of ds/f from 0 to t */
static vm_real inverse_integral(vm_law law, vm_real t)
{
    vm_real integral;
    return vm_law_inverse_integral(&law, t, &integral) == VM_OK ? integral : VM_NAN;
}
/* f = (1 + x0 t)^x1, t = x2 */
static vm_real power_law_ours(const vm_real *x) { return inverse_integral(vm_law_power(1, x[0], x[1]), x[2]); }
static vm_real power_law_naive(const vm_real *x)
{
    return (POW(1 + x[0] * x[2], 1 - x[1]) - 1) / (x[0] * (1 - x[1]));
}
static vm_real exponential_law_ours(const vm_real *x)
{
    return inverse_integral(vm_law_exponential(1, x[0]), x[1]);
}
static vm_real exponential_law_naive(const vm_real *x) { return (1 - EXP(-x[0] * x[1])) / x[0]; }
static vm_real linear_law_ours(const vm_real *x) { return inverse_integral(vm_law_linear(1, x[0]), x[1]); }
static vm_real linear_law_naive(const vm_real *x) { return LOG(1 + x[0] * x[1]) / x[0]; }
/* f = 1 + x0 t + x1 t^2 by the integral tables' arctangents and logarithms */
static vm_real quadratic_law_ours(const vm_real *x)
{
    return inverse_integral(vm_law_quadratic(1, x[0], x[1]), x[2]);
}
static vm_real quadratic_law_naive(const vm_real *x)
{
    const vm_real D = 4 * x[1] - x[0] * x[0], root = SQRT(FABS(D)), late = 2 * x[1] * x[2] + x[0];
    if (D > 0) return 2 / root * (ATAN2(late, root) - ATAN2(x[0], root));
    return LOG((late - root) * (x[0] + root) / ((late + root) * (x[0] - root))) / root;
}
/* Angle of a rotor on a linear shaft, m = (1 + x0 t)^x1, t = x2: (482) is x1 = 2 */
static vm_real whirl_angle_ours(const vm_real *x)
{
    vm_power_force shaft = {4, 1};
    vm_jeffcott r;
    vm_jeffcott_whirl w;
    memset(&r, 0, sizeof r);
    r.mass = vm_law_power(1, x[0], x[1]);
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = &shaft;
    r.reactive = 1;
    return vm_jeffcott_whirl_at(&r, 1, 0, 1, x[2], &w) == VM_OK ? w.angle : VM_NAN;
}
static vm_real whirl_angle_naive(const vm_real *x)
{
    return 2 * (POW(1 + x[0] * x[2], 1 - x[1] / 2) - 1) / (x[0] * (1 - x[1] / 2));
}

/* exp(x0 t) over exp(x1 t), t = x2 */
static vm_real ratio_laws_ours(const vm_real *x)
{
    const vm_law f = vm_law_exponential(1, x[0]), g = vm_law_exponential(1, x[1]);
    vm_real integral;
    return vm_law_ratio_integral(&f, &g, x[2], &integral) == VM_OK ? integral : VM_NAN;
}
static vm_real ratio_laws_naive(const vm_real *x) { return (EXP((x[0] - x[1]) * x[2]) - 1) / (x[0] - x[1]); }

/* Way in t = x0 of a body of mass 1 that takes up mass at the rate x1, the relative velocity being 3 */
static vm_real rocket_way_ours(const vm_real *x)
{
    vm_stream1 stream = {0, 3, VM_RELATIVE};
    vm_real way, v;
    stream.rate = x[1];
    return vm_linear_flow(&stream, x[0], 0, 0, 1, 0, &way, &v) == VM_OK ? way : VM_NAN;
}
static vm_real rocket_way_naive(const vm_real *x)
{
    const vm_real m = 1 + x[1] * x[0];
    return 3 * (m / x[1] * LOG(m) - x[0]);
}
/* The same under a force of 2, what joins being at rest */
static vm_real wagon_way_ours(const vm_real *x)
{
    vm_stream1 stream = {0, 0, VM_AT_REST};
    vm_real way, v;
    stream.rate = x[1];
    return vm_linear_flow(&stream, x[0], 0, 0, 1, 2, &way, &v) == VM_OK ? way : VM_NAN;
}
static vm_real wagon_way_naive(const vm_real *x) { return 2 / x[1] * (x[0] - LOG(1 + x[1] * x[0]) / x[1]); }
static vm_real tsiolkovsky_ours(const vm_real *x) { return vm_tsiolkovsky(0, x[0], x[1], 1000); }
static vm_real tsiolkovsky_naive(const vm_real *x) { return 1000 * LOG(x[1] / x[0]); }

/* Transverse omega of a body whose mass changes at the rate x0, at t = x1 */
static vm_real jet_ours(const vm_real *x)
{
    vm_jet jet = {0, 1, 3, VM_C(0.5), VM_C(0.75), VM_C(0.5), 1};
    vm_vec3 omega = {1, 0, 4};
    jet.rate = x[0];
    return vm_jet_damping(&jet, x[1], omega, &omega) == VM_OK ? omega.y : VM_NAN;
}
static vm_real jet_naive(const vm_real *x)
{
    const vm_real C1 = x[0] * VM_C(0.5), A1 = x[0] * VM_C(0.75), ln = LOG((3 + A1 * x[1]) / 3);
    const vm_real phase = 4 * (C1 / A1 * x[1] + (1 - 3 * C1 / A1) / A1 * ln - x[1]);
    return EXP((VM_C(1.5) / VM_C(0.75) - 1) * ln) * SIN(phase);
}

/* A drum, of which phi or t = x0, and e = mu v R - D by D = x1 */
static vm_drum drum_of(const vm_real *x)
{
    vm_drum d = {VM_C(0.5), 3, 1, VM_C(0.5), 4, 0, 0, 2};
    d.damping = x[1];
    return d;
}
static vm_real drum_time_ours(const vm_real *x)
{
    const vm_drum d = drum_of(x);
    return vm_drum_time(&d, x[0]);
}
static vm_real drum_time_naive(const vm_real *x)
{
    const vm_real e = 1 - x[1], z = e * x[0] / 2, s = x[0] / 8, ln = LOG(1 + z);
    return x[0] / 2 * (ln / z + s * (z - ln) / (z * z));
}

/* Deflection x by the unbalance of a drum whose shaft has the ratio of frequencies k = sqrt(x1), at the angle x0, over
   mu R/M0 */
static vm_real drum_unbalance_ours(const vm_real *x)
{
    vm_drum d = {1, 1, 1, 1, 0, 0, 1, 1};
    vm_real at[2] = {0, 0}, slope[2];
    d.stiffness = x[1];
    return vm_drum_unbalance(&d, x[0], at, slope) == VM_OK ? at[0] : VM_NAN;
}
static vm_real drum_unbalance_naive(const vm_real *x)
{
    const vm_real k = SQRT(x[1]);
    return (SIN(x[0]) - SIN(k * x[0]) / k) / (x[1] - 1);
}

static vm_real drum_angle_ours(const vm_real *x)
{
    const vm_drum d = drum_of(x);
    return vm_drum_angle(&d, x[0]);
}
static vm_real drum_angle_naive(const vm_real *x) /* (198)-(206) */
{
    const vm_real e = 1 - x[1], jO = VM_C(0.25), k1 = 1 - e / jO, f1 = 1 + e * e * x[0] / jO;
    const vm_real z = -EXP(-f1 / k1) / k1;
    return (-k1 * (k1 > 0 && k1 < 1 ? vm_lambert_wm1(z) : vm_lambert_w0(z)) - 1) * 2 / e;
}

/* Van der Pol, alpha = 3: feed = x0, mass 1 + x1 t, t = x2 */
static vm_real vdp_ours(const vm_real *x)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = 3;
    v.k = v.c = v.reactive = 1;
    v.feed = x[0];
    v.mass = vm_law_linear(1, x[1]);
    if (vm_vdp_init(&v)) return VM_NAN;
    return vm_vdp_amplitude(&v, x[2], VM_C(0.5));
}
static vm_real vdp_naive(const vm_real *x) /* (422) corrected */
{
    const vm_real ln = LOG(1 + x[1] * x[2]), F = (2 * x[0] - x[1]) / x[1] * ln / 3, a3 = ateb_mean(3, 2, 2) / 2;
    return SQRT(EXP(F) / (4 + 2 * a3 * 3 / (2 * x[0] - x[1]) * (EXP(F) - 1)));
}

/* Angle of a shaft of inertia 1, damping x0, torque 1 after t = x1, (49) */
static vm_real spin_up_ours(const vm_real *x)
{
    const vm_real start[6] = {0, 0, 0, 0, 0, 0};
    vm_broken_rotor rotor = {1, 1, 1, 0, 1, 0};
    vm_real end[6];
    rotor.damping = x[0];
    return vm_broken_rotor_free_motion(&rotor, x[1], start, end) == VM_OK ? end[2] : VM_NAN;
}
static vm_real spin_up_naive(const vm_real *x) { return x[1] / x[0] - (1 - EXP(-x[0] * x[1])) / (x[0] * x[0]); }
/* Place after t = x1 on a shaft of stiffness x0, from the velocity 1 */
static vm_real free_shaft_ours(const vm_real *x)
{
    const vm_real start[6] = {0, 0, 0, 1, 0, 0};
    vm_broken_rotor rotor = {1, 1, 0, 1, 1, 0};
    vm_real end[6];
    rotor.stiffness = x[0];
    return vm_broken_rotor_free_motion(&rotor, x[1], start, end) == VM_OK ? end[0] : VM_NAN;
}
static vm_real free_shaft_naive(const vm_real *x) { return SIN(SQRT(x[0]) * x[1]) / SQRT(x[0]); }

/* A free body of moments x0 > x1 > x2, or x0 < x1 < x2, from omega = (x3, 0, x4), closer to the axis of x2: omega_1
   at t = x5. The textbook has it from the energy and the angular momentum. */
static vm_real free_body_ours(const vm_real *x)
{
    vm_torque_free motion;
    vm_vec3 moments, omega;
    vm_quat q = {1, 0, 0, 0};
    moments.x = x[0], moments.y = x[1], moments.z = x[2];
    omega.x = x[3], omega.y = 0, omega.z = x[4];
    if (vm_torque_free_init_principal(&motion, moments, q, omega, 0)) return VM_NAN;
    return vm_torque_free_attitude(&motion, x[5], &q, &omega) == VM_OK ? omega.x : VM_NAN;
}
static vm_real free_body_naive(const vm_real *x)
{
    const vm_real T2 = x[0] * x[3] * x[3] + x[2] * x[4] * x[4];
    const vm_real L2 = x[0] * x[0] * x[3] * x[3] + x[2] * x[2] * x[4] * x[4];
    const vm_real m = (x[1] - x[0]) * (T2 * x[2] - L2) / ((x[2] - x[1]) * (L2 - T2 * x[0]));
    const vm_real u = x[5] * SQRT((x[2] - x[1]) * (L2 - T2 * x[0]) / (x[0] * x[1] * x[2]));
    return SQRT((T2 * x[2] - L2) / (x[0] * (x[2] - x[0]))) * jacobi_cn(u, m);
}

/* Lambert's W next to its branch point, by Halley's iteration from w = -1 +- sqrt(2 (e x + 1)) */
static vm_real halley(vm_real x, vm_real sign)
{
    vm_real w = -1 + sign * SQRT(2 * (VM_C(2.71828182845904523536) * x + 1));
    int i;
    for (i = 0; i < 30; i++) {
        const vm_real e = EXP(w), f = w * e - x;
        w -= f / (e * (w + 1) - (w + 2) * f / (2 * w + 2));
    }
    return w;
}
static vm_real lambert_w0_ours(const vm_real *x) { return vm_lambert_w0(x[0]); }
static vm_real lambert_w0_naive(const vm_real *x) { return halley(x[0], 1); }
static vm_real lambert_wm1_ours(const vm_real *x) { return vm_lambert_wm1(x[0]); }
static vm_real lambert_wm1_naive(const vm_real *x) { return halley(x[0], -1); }

/* Integral of sa^2 from 0 to s = x0, alpha = x1 */
static vm_real integral_sa2_ours(const vm_real *x) { return ateb_integral_sa2(x[0], x[1]); }
static vm_real integral_sa2_naive(const vm_real *x)
{
    return (x[0] - ateb_sa(x[0], x[1]) * ateb_ca(x[0], x[1])) * (x[1] + 1) / (x[1] + 3);
}

/* A/A0 when the mass has grown by x0 without a reactive force, alpha = x1, and as (337) prints it */
static vm_real amplitude_law_ours(const vm_real *x) { return vm_osc_amplitude_law(x[0], 0, 0, x[1]); }
static vm_real amplitude_law_naive(const vm_real *x) { return POW(x[0], 1 / (5 - x[1])); }

/* x(t) and its period, m and k constant by a law of no rate: vm_osc_within's phase, t = x0, rate of both x1 */
static vm_real frozen_motion_ours(const vm_real *x)
{
    vm_osc_problem p;
    vm_osc_motion motion;
    memset(&p, 0, sizeof p);
    p.alpha = 3;
    p.mass = vm_law_linear(1, x[1]);
    p.stiffness = vm_law_power(1, x[1], -1);
    p.reactive = 1;
    p.x = 1;
    return vm_osc_by_route(&p, VM_ROUTE_ORDER5, x[0], 0, &motion) == VM_OK ? motion.x : VM_NAN;
}
static vm_real frozen_motion_naive(const vm_real *x)
{
    return ateb_ca(SQRT(VM_C(2.)) * (LOG(1 + x[1] * x[0]) / x[1]), 3);
}

/* Mean motion of first order, m = 1 + x2 t, k = 1, t = x3, alpha = x0, r = x1: its phase is the integral of m^(-p) */
static vm_real mean_phase_ours(const vm_real *x)
{
    vm_osc_problem p;
    vm_osc_motion motion;
    memset(&p, 0, sizeof p);
    p.alpha = x[0], p.reactive = x[1], p.x = 1;
    p.mass = vm_law_linear(1, x[2]), p.stiffness = vm_law_linear(1, 0);
    return vm_osc_by_route(&p, VM_ROUTE_ATEB, x[3], 0, &motion) == VM_OK ? motion.x : VM_NAN;
}
static vm_real mean_phase_naive(const vm_real *x)
{
    const vm_real share = (2 * x[1] - 1) / (x[0] + 3), left = VM_C(0.5) - (x[0] - 1) / 2 * share, m = 1 + x[2] * x[3];
    const vm_real psi = SQRT((x[0] + 1) / 2) * (POW(m, left) - 1) / (x[2] * left);
    return POW(m, -share) * ateb_ca(psi, x[0]);
}
static const hard_case removable_cases[] = {
    CASE(C2, 8, "mean of cn^2 for a small m by (E/K - 1 + m)/m: the formula tends to 0/0", 3e-5),
    CASE(C2, 8, "mean of cn^2 for a small negative m by (E/K - 1 + m)/m: the formula tends to 0/0", -7e-7),
    CASE(C2, 8, "mean of cn^2 for an m so small that E/K rounds to 1", R(1e-18, 1e-9)),
    CASE(C2, 8, "mean of cn^2 for m = 0: the formula is 0/0", 0),
    CASE(C4, 8, "mean of cn^4 for a small m: the formula divides small differences by m twice", 3e-4),
    CASE(C4, 8, "mean of cn^4 for a small negative m: the formula divides by m twice", -1e-5),
    CASE(C6, 8, "mean of cn^6 for a small m: the formula divides by m three times", 7e-3),
    CASE(C6, 8, "mean of cn^6 for a smaller m: no digit of the formula is right", 1e-5),
    CASE(power_law, 8, "integral of 1/m^p, m = 1 + q t, by (m^(1-p) - 1)/(q (1 - p)) for p next to 1: tends to 0/0",
         0.25, R(0.9999999, 0.999), 3),
    CASE(power_law, 8, "integral of 1/m^p for p = 1: the formula is 0/0, and the limit is a logarithm", 0.25, 1, 3),
    CASE(power_law, 8, "integral of (1 + q t)^-p for a rate q next to 0: the power in the formula rounds to 1",
         R(1e-14, 1e-6), 2.5, 3),
    CASE(exponential_law, 8, "integral of e^(-q t) by (1 - e^(-q t))/q for a small rate q: the formula tends to 0/0",
         R(3e-12, 3e-6), 2),
    CASE(exponential_law, 8, "integral of e^(-q t) by (1 - e^(-q t))/q for q = 0: the formula is 0/0", 0, 2),
    CASE(linear_law, 8, "integral of 1/(1 + q t) by ln(1 + q t)/q for a small rate q: 1 + q t loses digits of q t",
         R(7e-13, 7e-6), 2),
    CASE(linear_law, 8, "integral of 1/(1 + q t) for a small negative rate q: 1 + q t loses digits of q t",
         R(-7e-10, -7e-5), 3),
    CASE(whirl_angle, 8,
         "angle of a whirling rotor by (482), if the mass is nearly the square of a linear law: tends to 0/0", 0.02,
         R(2.00000001, 2.001), 30),
    CASE(whirl_angle, 8,
         "angle of a whirling rotor by (482), if the mass is the square of a linear law: 0/0, a logarithm", 0.02, 2,
         30),
    CASE(whirl_angle, 8, "angle of a whirling rotor by (482), if the mass hardly changes: the formula tends to 0/0",
         R(1e-12, 1e-5), 1, 30),
    CASE(ratio_laws, 4, "integral of damping/mass, if both grow exponentially at nearly the same rate: tends to 0/0",
         0.3, R(0.3000000001, 0.30001), 3),
    CASE(quadratic_law, 16,
         "integral of 1/(1 + a t + b t^2) next to a double root of this polynomial: the formula tends to 0/0", 2,
         R(1.00000001, 1.0001), 1),
    CASE(quadratic_law, 16,
         "integral of 1/(1 + a t + b t^2), if this polynomial has a double root: division by the discriminant 0", 2, 1,
         3),
    CASE(quadratic_law, 16, "integral of 1/(1 + a t + b t^2) for a tiny b: one root of the polynomial goes to infinity",
         0.3, R(1e-13, 1e-6), 1),
    CASE(rocket_way, 16,
         "distance of a rocket by (m ln m)/q - t for a small rate q of the mass m: the difference cancels", 2,
         R(1e-9, 1e-4)),
    CASE(rocket_way, 16,
         "distance of a rocket by (m ln m)/q - t, if the mass falls at a small rate: the difference cancels", 5,
         R(-3e-6, -3e-3)),
    CASE(wagon_way, 16, "distance under a force, if mass at rest joins at a small rate q: the formula contains 1/q^2",
         2, R(1e-7, 1e-3)),
    CASE(tsiolkovsky, 8, "speed of a rocket by ln(m0/m) for nearly equal masses: m0/m loses the digits of m0 - m", 0.7,
         R(0.7000000003, 0.70007)),
    CASE(jet, 16, "omega_y under jet damping, if the transverse moment of inertia hardly changes: tends to 0/0",
         R(1e-9, 1e-4), 2),
    CASE(drum_time, 8, "time t(phi) of a drum by (197), if e = drive - damping is small: the formula contains 1/e^2", 3,
         R(0.999999, 0.999)),
    CASE(drum_time, 8, "time t(phi) of a drum by (197), if drive and damping cancel (e = 0): the formula is 0/0", 3, 1),
    CASE(drum_unbalance, 16,
         "deflection of a drum by its band's unbalance, (sin phi - sin(k phi)/k)/(k^2 - 1): 0/0 for k -> 1", 2,
         R(1.0000000001, 1.0001)),
    CASE(drum_unbalance, 16,
         "deflection of a drum by its band's unbalance next to resonance, k < 1: the formula tends to 0/0", 5,
         R(0.99999999999, 0.9999)),
    CASE(drum_unbalance, 16, "deflection of a drum by its band's unbalance at resonance, k = 1: the formula is 0/0", 2,
         1),
    CASE(drum_angle, 8,
         "angle of a drum by Lambert's function (206) for a small e: the argument is next to a branch point", 3,
         R(0.9999999, 0.999)),
    CASE(drum_angle, 8, "angle of a drum by (206) for a small k1: the argument -exp(-f1/k1)/k1 underflows", 3,
         R(0.7501, 0.7502)),
    CASE(drum_angle, 8, "angle of a drum by (206) for k1 = 0: the formula divides by 0", 3, 0.75),
    CASE(vdp, 16, "amplitude of a Van der Pol oscillator by (422) for a small rate q of the mass: division by q", 0.75,
         R(1e-11, 1e-5), 3),
    CASE(vdp, 16, "the same amplitude, if the feed b and the reactive force nearly cancel: division by 2b - q",
         R(0.0500000001, 0.0501), 0.1, 3),
    CASE(spin_up, 8, "angle of a shaft by (49), t/k - (1 - e^(-kt))/k^2, for a small damping k: large terms cancel",
         R(1e-6, 1e-3), 3),
    CASE(free_shaft, 4, "deflection sin(w t)/w of a shaft without stiffness (w = 0): the formula is 0/0", 0, 3),
    CASE(free_body, 16,
         "omega_1 of a nearly spherical free body: m is a quotient of small differences of moments of inertia",
         R(1.0000002, 1.002), R(1.0000001, 1.001), 1, 1, 1.5, 2),
    CASE(free_body, 16, "omega_1 of a sphere by the formulas for any free body: m is 0/0", 2, 2, 2, 1, 1.5, 2),
    CASE(free_body, 16, "omega_1 of an axisymmetric free body (m = 0): differences of the angular momentum cancel", 2,
         2, 1, 0.001, 1.5, 2),
    CASE(lambert_w0, 2, "Lambert's W_0 next to -1/e by iteration: the slope of w e^w is 0 there",
         R(-0.36787944117, -0.367879)),
    CASE(lambert_wm1, 2, "Lambert's W_-1 next to -1/e by iteration: the slope of w e^w is 0 there",
         R(-0.36787944117, -0.3678793)),
    CASE(integral_sa2, 24, "integral of sa^2 from 0 to a small s: the difference s - sa ca cancels", R(1e-6, 1e-3),
         0.5),
    CASE(integral_sa2, 24, "integral of sa^2 from 0 to a small s for alpha = 1000: the difference s - sa ca cancels",
         R(1e-4, 1e-2), 1000),
    CASE(amplitude_law, 4, "amplitude by (337) as printed, for alpha next to 5: the exponent is 1/(5 - alpha)", 1.5,
         4.9375),
    CASE(amplitude_law, 4, "amplitude by (337) as printed, for alpha = 5: the exponent 1/(5 - alpha) is infinite", 1.5,
         5),
    CASE(mean_phase, 16,
         "vibration for alpha = 5, reactive = 3/2: its phase is the integral of m^-p, whose formula is 0/0", 5, 1.5,
         0.03125, 16),
    CASE(mean_phase, 16, "vibration for alpha next to 5, reactive = 3/2: the formula for the phase tends to 0/0",
         R(4.99999999, 4.9999), 1.5, 0.03125, 16),
    CASE(mean_phase, 16, "vibration for alpha = 3, reactive = 2: the formula for the phase is 0/0", 3, 2, 0.03125, 16),
    CASE(mean_phase, 16, "vibration for alpha next to 3, reactive = 2: the formula for the phase tends to 0/0",
         R(3.00000001, 3.0001), 2, 0.03125, 16),
    CASE(frozen_motion, 16, "vibration of a mass that hardly changes: the phase ln(1 + q t)/q loses the digits of q t",
         2, R(1e-13, 1e-6)),
};
