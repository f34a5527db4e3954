/* Under- and overflow: the value is a number, what the textbook computes on the way is not. */

/* ca^(alpha+1) underflows, as does the argument of the inverse beta function: ln x for I_x(x1, x2) = x0 */
static vm_real ln_beta_inverse_ours(const vm_real *x)
{
    vm_real z, y, ln_z;
    ateb_beta_inc_inv_both(x[0], 1 - x[0], x[1], x[2], &z, &y, &ln_z);
    return ln_z;
}
static vm_real ln_beta_inverse_naive(const vm_real *x) { return LOG(ateb_beta_inc_inv(x[0], x[1], x[2])); }

/* Amplitude and phase of the state (x0, x1), alpha = x2, by the energy */
static vm_real amplitude_ours(const vm_real *x)
{
    vm_real A, psi;
    vm_osc_amplitude_phase(x[0], x[1], 1, x[2], &A, &psi);
    return A;
}
static vm_real amplitude_naive(const vm_real *x)
{
    const vm_real n = x[2] + 1;
    return POW(POW(FABS(x[0]), n) + n / 2 * x[1] * x[1], 1 / n);
}
static vm_real phase_ours(const vm_real *x)
{
    vm_real A, psi;
    vm_osc_amplitude_phase(x[0], x[1], 1, x[2], &A, &psi);
    return psi;
}
static vm_real phase_naive(const vm_real *x)
{
    const vm_real n = x[2] + 1, E = POW(FABS(x[0]), n) + n / 2 * x[1] * x[1];
    return ateb_phase(-SQRT(n / 2) * x[1] / SQRT(E), x[0] / POW(E, 1 / n), x[2]);
}
/* Period (262) and largest velocity (267) for the amplitude x0, alpha = x1 */
static vm_real period_ours(const vm_real *x) { return vm_osc_period(x[0], 1, x[1]); }
static vm_real period_naive(const vm_real *x)
{
    return 2 * ateb_pi(x[1]) / SQRT((x[1] + 1) / 2 * POW(x[0], x[1] - 1));
}
static vm_real vmax_ours(const vm_real *x) { return vm_osc_vmax(x[0], 1, x[1]); }
static vm_real vmax_naive(const vm_real *x) { return SQRT(2 / (x[1] + 1) * POW(x[0], x[1] + 1)); }
/* x(t), t = x0, from x1, alpha = x2 */
static vm_real motion_ours(const vm_real *x)
{
    vm_real place, v;
    vm_osc_exact(x[0], x[1], 1, x[2], &place, &v);
    return place;
}
static vm_real motion_naive(const vm_real *x)
{
    return x[1] * ateb_ca(x[0] * SQRT((x[2] + 1) / 2 * POW(x[1], x[2] - 1)), x[2]);
}

/* For m < 0 the textbook goes to m/(m - 1), which rounds to 1 */
static vm_real K_ours(const vm_real *x) { return jacobi_K(x[0]); }
static vm_real K_naive(const vm_real *x) { return jacobi_K(x[0] / (x[0] - 1)) / SQRT(1 - x[0]); }
static vm_real E_ours(const vm_real *x) { return jacobi_E(x[0]); }
static vm_real E_naive(const vm_real *x) /* K (1 - sum of 2^(n-1) c_n^2) */
{
    vm_real a = 1, b = SQRT(1 - x[0]), sum = x[0] / 2, power = 1;
    int n;
    for (n = 1; n < 12; n++, power *= 2) {
        const vm_real mean = (a + b) / 2;
        sum += power * (a * a - 2 * a * b + b * b) / 4;
        b = SQRT(a * b), a = mean;
    }
    return VM_PI / (2 * a) * (1 - sum);
}
static vm_real cn_far_m_ours(const vm_real *x) { return jacobi_cn(x[0], x[1]); }
static vm_real cn_far_m_naive(const vm_real *x) { return jacobi_cd(x[0] * SQRT(1 - x[1]), x[1] / (x[1] - 1)); }
static vm_real modulus_ours(const vm_real *x) { return jacobi_solve_kpK(x[0]); }
static vm_real modulus_naive(const vm_real *x) /* Newton's method, f' = (E - K)/(2 m k') */
{
    vm_real m = -1;
    int i;
    for (i = 0; i < 60; i++)
        m -= (SQRT(1 - m) * jacobi_K(m) - x[0]) * 2 * m * SQRT(1 - m) / (jacobi_E(m) - jacobi_K(m));
    return m;
}

/* Lambert's W where its argument is no number: of e^x0, and of -e^x0 */
static vm_real w0_exp_ours(const vm_real *x) { return vm_wright_omega(x[0]); }
static vm_real w0_exp_naive(const vm_real *x) { return vm_lambert_w0(EXP(x[0])); }
static vm_real wm1_mexp_ours(const vm_real *x) { return vm_lambert_wm1_neg_exp(x[0]); }
static vm_real wm1_mexp_naive(const vm_real *x) { return vm_lambert_wm1(-EXP(x[0])); }

/* Radius of steady motion for stiffness x0, s = 1, mass 1, damping 0, Omega = x1 */
static vm_real steady_ours(const vm_real *x)
{
    vm_broken_rotor rotor = {1, 1, 0, 0, 0, 1};
    rotor.stiffness = x[0];
    return vm_broken_rotor_steady_radius(&rotor, x[1]);
}
static vm_real steady_naive(const vm_real *x)
{
    const vm_real w2 = x[0] * x[0], O2 = x[1] * x[1] * x[1] * x[1];
    return SQRT(w2) * (SQRT(w2) + SQRT(O2)) / (w2 - O2);
}

/* Two bodies of masses x0, x1, 2 m apart: inertia together, of points, by m1 m2/(m1 + m2) */
static vm_real pair_inertia_ours(const vm_real *x)
{
    const vm_inertia point = {0, 0, 0, 0, 0, 0};
    vm_inertia whole;
    vm_vec3 d = {2, 0, 0}, centre;
    return vm_combine_inertia(x[0], &point, x[1], &point, d, &whole, &centre) == VM_OK ? whole.yy : VM_NAN;
}
static vm_real pair_inertia_naive(const vm_real *x) { return x[0] * x[1] / (x[0] + x[1]) * 4; }
/* Velocity of the rest of a mass x0, at the speed x1, of which half has left at the speed 2 x1 */
static vm_real heavy_separation_ours(const vm_real *x)
{
    vm_body2 whole = {0, 0, 0, 0, 0, 0, 0, 0}, part = {0, 0, 0, 0, 0, 0, 0, 0}, rest;
    whole.mass = x[0], part.mass = x[0] / 2, whole.vx = x[1], part.vx = x[1] * VM_C(1.5);
    return vm_separate2(&whole, &part, NULL, &rest) >= 0 ? rest.vx : VM_NAN;
}
static vm_real heavy_separation_naive(const vm_real *x)
{
    return (x[0] * x[1] - x[0] / 2 * (x[1] * VM_C(1.5))) / (x[0] / 2);
}
/* Distance of (x0, x1) */
static vm_real distance_ours(const vm_real *x)
{
    vm_complex z;
    vm_real rho, phi;
    z.re = x[0], z.im = x[1];
    vm_jeffcott_polar(z, &rho, &phi);
    return rho;
}
static vm_real distance_naive(const vm_real *x) { return SQRT(x[0] * x[0] + x[1] * x[1]); }
/* Angular momentum, x, of a body whose attitude is x0 (3, 0, 0, 1) and which spins about x */
static vm_real scaled_attitude_ours(const vm_real *x)
{
    vm_body b = {1, {2, 5, 6, 0, 0, 0}, {3, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    const vm_vec3 origin = {0, 0, 0};
    b.q.w *= x[0], b.q.z *= x[0];
    return vm_angular_momentum(&b, origin).x;
}
static vm_real scaled_attitude_naive(const vm_real *x)
{
    const vm_real w = 3 * x[0], z = x[0], norm = w * w + z * z, c = (w * w - z * z) / norm, s = 2 * w * z / norm;
    return 2 * c * c + 5 * s * s;
}
static vm_real rocket_speed_ours(const vm_real *x) { return vm_tsiolkovsky(0, x[0], x[1], 3); }
static vm_real rocket_speed_naive(const vm_real *x) { return 3 * LOG(x[1] / x[0]); }
static vm_real levi_civita_ours(const vm_real *x) { return vm_velocity_by_momentum(x[0], x[1], x[2], 2, 0); }
static vm_real levi_civita_naive(const vm_real *x) { return (x[1] * x[0] + (x[2] - x[1]) * 2) / x[2]; }
/* Two coordinates, mass matrix x0 (3 1; 1 2), hit by x0 (1, 0), from rest, by determinants */
static vm_real hit_ours(const vm_real *x)
{
    const vm_real rest[2] = {0, 0};
    vm_real matrix[4], impulse[2], after[2], work[VM_LAGRANGE_WORK(2)];
    matrix[0] = 3 * x[0], matrix[1] = matrix[2] = x[0], matrix[3] = 2 * x[0], impulse[0] = x[0], impulse[1] = 0;
    return vm_lagrange_impact(2, matrix, rest, impulse, after, work) == VM_OK ? after[0] : VM_NAN;
}
static vm_real hit_naive(const vm_real *x) { return x[0] * (2 * x[0]) / ((3 * x[0]) * (2 * x[0]) - x[0] * x[0]); }
static vm_real beta_ours(const vm_real *x) { return ateb_beta(x[0], x[1]); }
static vm_real beta_naive(const vm_real *x) { return GAMMA(x[0]) * GAMMA(x[1]) / GAMMA(x[0] + x[1]); }
static vm_real mean_ours(const vm_real *x) { return ateb_mean(x[0], x[1], x[2]); }
static vm_real mean_naive(const vm_real *x)
{
    const vm_real a = (x[1] + 1) / 2, b = (x[2] + 1) / (x[0] + 1);
    return GAMMA(a) * GAMMA(b) / GAMMA(a + b) / ateb_pi(x[0]);
}

static const hard_case range_cases[] = {
    CASE(ca, 8, "ca = 0.38 for alpha = 1000, computed from sa: ca^(alpha+1) underflows, and 1 - sa^2 is 0", 503.6,
         1000),
    CASE(ca, 8, "ca for alpha = 1e6, computed from sa: ca^(alpha+1) underflows, and 1 - sa^2 is 0", R(499990, 49990),
         R(1e6, 1e5)),
    CASE(ca, 8, "ca for alpha = 1e9, computed from sa: sa rounds to 1 over most of the period, and 1 - sa^2 is 0",
         R(5e8, 5e3), R(1e9, 1e4)),
    CASE(sa, 8, "sa for a very small s, computed from ca: ca rounds to 1, and 1 - ca^(alpha+1) is 0", R(1e-300, 1e-35),
         1.5),
    CASE(ln_beta_inverse, 4, "ln x for the solution x of I_x(a, b) = p: x is of the order 1e-3000 and underflows", 1e-3,
         1e-3, 0.5),
    CASE(ln_beta_inverse, 4, "ln x for the solution x of I_x(a, b) = p with a and b for alpha = 999: x underflows",
         1e-10, 1e-3, 2),
    CASE(amplitude, 8, "amplitude of a state (position x, velocity) with x = 1e150: the energy, about 1e600, overflows",
         R(1e150, 1e15), R(1e300, 1e30), 3),
    CASE(amplitude, 8, "amplitude of a state with x = 1e-150: the energy underflows", R(1e-150, 1e-15),
         R(1e-300, 1e-30), 3),
    CASE(amplitude, 8, "amplitude of a state with x = 10 for alpha = 1000: 10^1001 overflows", 10, 3, 1000),
    CASE(phase, 16, "phase of a state whose energy overflows", R(1e150, 1e15), R(-1e300, -1e30), 3),
    CASE(phase, 16, "phase of a state whose energy underflows", R(1e-150, 1e-15), R(-1e-300, -1e-30), 3),
    CASE(period, 8, "period of a motion with the amplitude 1e-200: A^(alpha-1) underflows", R(1e-200, 1e-25), 3),
    CASE(period, 8, "period of a motion with the amplitude 1e200: A^(alpha-1) overflows", R(1e200, 1e25), 3),
    CASE(vmax, 8, "largest velocity of a motion with the amplitude 1e100: A^(alpha+1) overflows", R(1e100, 1e12), 3),
    CASE(motion, 16, "position in a motion with the amplitude 1e160: powers of the amplitude overflow",
         R(1e-160, 1e-21), R(1e160, 1e21), 3),
    CASE(K, 2, "K for m = -1e300: m/(m - 1) in the formula rounds to 1", R(-1e300, -1e30)),
    CASE(E, 2, "E at m = -1e308: the terms of the arithmetic-geometric mean cancel, and nearly overflow",
         R(-1.7e308, -3.3e38)),
    CASE(cn_far_m, 8, "cn for m = -1e300: m/(m - 1) in the formula rounds to 1", R(3.46e-148, 3.5e-14),
         R(-1e300, -1e30)),
    CASE(K_near_1, 2, "K for the smallest 1 - m, computed from m: m rounds to 1", R(5e-324, 1.5e-45)),
    CASE(modulus_rest, 12, "1 - m for which k'K = 1e-140, computed from m: m rounds to 1", R(1e-140, 1e-15)),
    CASE(modulus, 8, "m for which k'K = 340, by Newton's method: 60 steps do not reach m, about -1e294", R(340, 40)),
    CASE(w0_exp, 2, "W_0(e^2000): the argument overflows", 2000),
    CASE(wm1_mexp, 2, "W_-1(-e^-2000): the argument underflows", -2000),
    CASE(wm1_mexp, 2, "W_-1(-e^-1e30): the argument underflows", -1e30),
    CASE(steady, 8, "radius of a steadily turning rotor, if w^2 = 1e240 (w: frequency of its shaft): w^4 overflows",
         R(1e240, 1e30), R(5e119, 5e14)),
    CASE(steady, 8, "radius of a steadily turning rotor, if it turns at Omega = 1e160: Omega^2 overflows",
         R(1e300, 1e30), R(1e160, 1e22)),
    CASE(steady, 8, "radius of a steadily turning rotor, if w^2 = 1e-240: w^4 underflows", R(1e-240, 1e-30),
         R(5e-121, 5e-16)),
    CASE(free_body, 16,
         "omega_1 of a free body with moments of inertia of 1e-200: L^2 underflows (L: angular momentum)",
         R(1e-200, 1e-25), R(0.75e-200, 0.75e-25), R(0.5e-200, 0.5e-25), 0.25, 2, 1.5),
    CASE(free_body, 16, "omega_1 of a free body with moments of inertia of 1e200: L^2 overflows", R(1e200, 1e25),
         R(0.75e200, 0.75e25), R(0.5e200, 0.5e25), 0.25, 2, 1.5),
    CASE(free_body, 16, "omega_1 of a free body that turns at 1e200 rad/s: L^2 overflows", 1, 0.75, 0.5,
         R(0.25e200, 0.25e25), R(2e200, 2e25), R(1e-200, 1e-25)),
    CASE(pair_inertia, 4, "inertia of two points by m1 m2/(m1 + m2): the product of large masses overflows",
         R(1e200, 1e25), R(3e200, 3e25)),
    CASE(pair_inertia, 4, "inertia of two points by m1 m2/(m1 + m2): the product of small masses underflows",
         R(1e-200, 1e-25), R(3e-200, 3e-25)),
    CASE(heavy_separation, 4, "velocity of the rest after a separation: the momentum overflows, but not the velocity",
         R(1e300, 1e30), R(1e200, 1e25)),
    CASE(distance, 2, "length of a deflection of 1e200: its square overflows", R(1e200, 1e25), R(3e200, 3e25)),
    CASE(distance, 2, "length of a deflection of 1e-200: its square underflows", R(1e-200, 1e-25), R(3e-200, 3e-25)),
    CASE(scaled_attitude, 4,
         "angular momentum, if the attitude quaternion has the length 1e-170: the square of 1e-170 underflows",
         R(1e-170, 1e-30)),
    CASE(scaled_attitude, 4,
         "angular momentum, if the attitude quaternion has the length 1e160: the square of 1e160 overflows",
         R(1e160, 1e25)),
    CASE(rocket_speed, 4, "speed of a rocket by the logarithm of a quotient of masses: the quotient overflows",
         R(1e-200, 1e-25), R(1e200, 1e25)),
    CASE(levi_civita, 4, "velocity after a change of mass from the momentum: the momentum overflows", R(1e200, 1e25),
         R(1e150, 1e18), R(1e151, 1e19)),
    CASE(hit, 4, "velocity after an impact by determinants of a small mass matrix: they underflow", R(1e-200, 1e-25)),
    CASE(hit, 4, "velocity after an impact by determinants of a large mass matrix: they overflow", R(1e200, 1e25)),
    CASE(beta, 4, "beta function from gamma functions, which overflow", R(300, 40), R(300, 30)),
    CASE(mean, 4, "mean of a 1000th power of sa by gamma functions: they overflow", 3, 1000, 2),
    CASE(vdp, 16, "amplitude of a Van der Pol oscillator close to the limit cycle: e^F overflows", R(300, 40), 0.125,
         10),
};
