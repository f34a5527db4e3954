/* Cancellation: differences of nearly equal numbers in the textbook's formula. */

/* ca and sa, each from the other, s = x0, alpha = x1 */
static vm_real ca_ours(const vm_real *x) { return ateb_ca(x[0], x[1]); }
static vm_real ca_naive(const vm_real *x)
{
    const vm_real sa = ateb_sa(x[0], x[1]);
    return POW((1 - sa) * (1 + sa), 1 / (x[1] + 1));
}
static vm_real sa_ours(const vm_real *x) { return ateb_sa(x[0], x[1]); }
static vm_real sa_naive(const vm_real *x) { return SQRT(1 - POW(ateb_ca(x[0], x[1]), x[1] + 1)); }

/* 1 - I_x(x1, x2) at x = 1 - x0, and the 1 - x to which 1 - x0 belongs */
static vm_real beta_rest_ours(const vm_real *x)
{
    vm_real p, q;
    ateb_beta_inc_both(1 - x[0], x[0], x[1], x[2], &p, &q);
    return q;
}
static vm_real beta_rest_naive(const vm_real *x) { return 1 - ateb_beta_inc(1 - x[0], x[1], x[2]); }
static vm_real beta_inverse_rest_ours(const vm_real *x)
{
    vm_real z, y, ln_z;
    ateb_beta_inc_inv_both(1 - x[0], x[0], x[1], x[2], &z, &y, &ln_z);
    return y;
}
static vm_real beta_inverse_rest_naive(const vm_real *x) { return 1 - ateb_beta_inc_inv(1 - x[0], x[1], x[2]); }

/* At m = 1 - x0 */
static vm_real K_near_1_ours(const vm_real *x) { return jacobi_K_m1(x[0]); }
static vm_real K_near_1_naive(const vm_real *x) { return jacobi_K(1 - x[0]); }
static vm_real E_near_1_ours(const vm_real *x) { return jacobi_E_m1(x[0]); }
static vm_real E_near_1_naive(const vm_real *x) /* K (1 - sum of 2^(n-1) c_n^2), c_0^2 = m */
{
    vm_real a = 1, b = SQRT(x[0]), sum = (1 - x[0]) / 2, power = 1;
    int n;
    for (n = 1; n < 12; n++, power *= 2) {
        const vm_real c = (a - b) / 2, mean = (a + b) / 2;
        b = SQRT(a * b), a = mean;
        sum += power * c * c;
    }
    return VM_PI / (2 * a) * (1 - sum);
}
static vm_real modulus_rest_ours(const vm_real *x) { return jacobi_solve_kpK_m1(x[0]); }
static vm_real modulus_rest_naive(const vm_real *x) { return 1 - jacobi_solve_kpK(x[0]); }
static vm_real modulus_of_K_rest_ours(const vm_real *x) { return jacobi_solve_K_m1(x[0]); }
static vm_real modulus_of_K_rest_naive(const vm_real *x) { return 1 - jacobi_solve_K(x[0]); }

/* F(phi | m), phi = x0, m1 = x1; the naive form is Legendre's in terms of s = sin phi */
static vm_real F_incomplete_ours(const vm_real *x) { return jacobi_F_m1(x[0], x[1]); }
static vm_real F_incomplete_naive(const vm_real *x)
{
    const vm_real s = SIN(x[0]);
    return s * jacobi_RF(1 - s * s, 1 - (1 - x[1]) * s * s, 1);
}

/* Pi(n; phi | m), phi = x0, n = x1, m = x2 */
static vm_real Pi_incomplete_ours(const vm_real *x) { return jacobi_Pi_incomplete(x[0], x[1], x[2]); }
static vm_real Pi_incomplete_naive(const vm_real *x)
{
    const vm_real s = SIN(x[0]), c = COS(x[0]), d = 1 - x[2] * s * s;
    return s * (jacobi_RF(c * c, d, 1) + x[1] * s * s / 3 * jacobi_RJ(c * c, d, 1, 1 - x[1] * s * s));
}

/* sn(u | m) for m > 1, u = x0, m = x1 */
static vm_real rotating_ours(const vm_real *x)
{
    vm_real sn, cn, dn;
    jacobi_sncndn_any(x[0], x[1], &sn, &cn, &dn);
    return sn;
}
static vm_real rotating_naive(const vm_real *x)
{
    const vm_real k = SQRT(x[1]);
    return jacobi_sn(k * x[0], 1 / x[1]) / k;
}

/* u = x0, m = x1, or m1 = x1 */
static vm_real cn_ours(const vm_real *x) { return jacobi_cn(x[0], x[1]); }
static vm_real cn_naive(const vm_real *x)
{
    const vm_real sn = jacobi_sn(x[0], x[1]);
    return SQRT(1 - sn * sn);
}
static vm_real sn_ours(const vm_real *x) { return jacobi_sn(x[0], x[1]); }
static vm_real sn_naive(const vm_real *x)
{
    const vm_real cn = jacobi_cn(x[0], x[1]);
    return SQRT(1 - cn * cn);
}
static vm_real cn_m1_ours(const vm_real *x)
{
    vm_real sn, cn, dn;
    jacobi_sncndn_m1(x[0], x[1], &sn, &cn, &dn);
    return cn;
}
static vm_real cn_m1_naive(const vm_real *x) { return jacobi_cn(x[0], 1 - x[1]); }
static vm_real dn_m1_ours(const vm_real *x)
{
    vm_real sn, cn, dn;
    jacobi_sncndn_m1(x[0], x[1], &sn, &cn, &dn);
    return dn;
}
static vm_real dn_m1_naive(const vm_real *x)
{
    const vm_real sn = jacobi_sn(x[0], 1 - x[1]);
    return SQRT(1 - (1 - x[1]) * sn * sn);
}
/* dn = cos(phi_0)/cos(phi_1 - phi_0) of the descending ladder of amplitudes */
static vm_real dn_ours(const vm_real *x) { return jacobi_dn(x[0], x[1]); }
static vm_real dn_naive(const vm_real *x)
{
    vm_real a = 1, b = SQRT(1 - x[1]), ratio[8], phi = x[0], above = 0;
    int n;
    for (n = 0; n < 8; n++) {
        const vm_real mean = (a + b) / 2;
        ratio[n] = (a - b) / (2 * mean), b = SQRT(a * b), a = mean, phi *= 2;
    }
    for (phi *= a; n > 0; n--) above = phi, phi = (phi + VM_LIBM(asin)(ratio[n - 1] * SIN(phi))) / 2;
    return COS(phi) / COS(above - phi);
}

/* Energy that a part of 1 kg of 5 kg has brought by leaving at 0.5 m/s, or lost by joining, at the speed x0 */
static vm_body moving_body(vm_real mass, vm_real v)
{
    vm_body b = {1, {1, 1, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = mass, b.v.x = v;
    return b;
}
static vm_real energy_gain_ours(const vm_real *x)
{
    vm_body whole = moving_body(5, x[0]), part = moving_body(1, x[0] + VM_C(0.5)), rest;
    part.inertia.xx = part.inertia.yy = part.inertia.zz = VM_C(0.25);
    if (vm_separate(&whole, &part, NULL, &rest)) return VM_NAN;
    return vm_energy_gain(&whole, 1, &part, NULL, &rest);
}
static vm_real energy_gain_naive(const vm_real *x)
{
    const vm_real u = x[0] + VM_C(0.5), v = (5 * x[0] - u) / 4;
    return 4 * v * v / 2 + u * u / 2 - 5 * x[0] * x[0] / 2;
}
static vm_real energy_loss_ours(const vm_real *x)
{
    const vm_body body = moving_body(3, x[0]), added = moving_body(1, x[0] + VM_C(0.5));
    vm_body whole;
    if (vm_attach(&body, &added, NULL, &whole)) return VM_NAN;
    return vm_energy_loss(&body, 1, &added, NULL, &whole);
}
static vm_real energy_loss_naive(const vm_real *x)
{
    const vm_real u = x[0] + VM_C(0.5), v = (3 * x[0] + u) / 4;
    return 3 * x[0] * x[0] / 2 + u * u / 2 - 4 * v * v / 2;
}

/* Spin of the rest of a lamina at the distance x0 from the origin, by the angular momentum about the origin */
static vm_real far_spin_ours(const vm_real *x)
{
    vm_body2 whole = {5, 2, 0, 0, 0, 10, 3, 3}, part = {1, VM_C(0.125), 0, 0, 0, 8, 5, 1}, rest;
    whole.x = x[0], part.x = x[1];
    return vm_separate2(&whole, &part, NULL, &rest) == VM_OK ? rest.omega : VM_NAN;
}
static vm_real far_spin_naive(const vm_real *x)
{
    const vm_real X = x[0], X2 = x[1], X1 = (5 * X - X2) / 4, v1 = (5 * VM_C(3.) - 5) / 4;
    const vm_real whole = 2 + 5 * X * X, I1 = whole - (VM_C(0.125) + X2 * X2) - 4 * X1 * X1;
    return (2 * VM_C(3.) + X * 5 * 3 - VM_C(0.125) - X2 * 5 - X1 * 4 * v1) / I1;
}
/* Angular momentum about a point that is x0 away from the origin, and near the body */
static vm_real about_far_point_ours(const vm_real *x)
{
    vm_body2 b = {3, 2, 0, VM_C(0.5), 0, 0, 7, VM_C(0.25)};
    b.x = x[1];
    return vm_angular_momentum2(&b, x[0], 0);
}
static vm_real about_far_point_naive(const vm_real *x) { return VM_C(0.5) + x[1] * 3 * 7 - x[0] * 3 * 7; }
/* v_r, y, against a whole that spins at 3 rad/s, x0 from the origin, (98) */
static vm_real far_relative_ours(const vm_real *x)
{
    vm_body2 whole = {5, 2, 0, 0, 0, 10, 3, 3}, part = {1, 1, 0, 0, 0, 8, VM_C(4.5), 1}, relative;
    whole.x = x[0], part.x = x[1];
    return vm_to_relative2(&whole, &part, &relative) == VM_OK ? relative.vy : VM_NAN;
}
static vm_real far_relative_naive(const vm_real *x) { return (VM_C(4.5) - 3 * x[1]) - (3 - 3 * x[0]); }
/* yy of the rest by Steiner's theorem about an origin that is x0 away */
static vm_real split_inertia_ours(const vm_real *x)
{
    const vm_inertia whole = {2, 2, 3, 0, 0, 0};
    vm_inertia part = {VM_C(0.125), VM_C(0.125), VM_C(0.125), 0, 0, 0}, rest;
    vm_vec3 d = {VM_C(0.375), 0, 0}, centre;
    (void)x;
    return vm_split_inertia(5, &whole, 1, &part, d, &rest, &centre) == VM_OK ? rest.yy : VM_NAN;
}
static vm_real split_inertia_naive(const vm_real *x)
{
    const vm_real X2 = x[0] + VM_C(0.375), X1 = (5 * x[0] - X2) / 4;
    return (2 + 5 * x[0] * x[0]) - (VM_C(0.125) + X2 * X2) - 4 * X1 * X1;
}

/* e = mu v R - D next to 0, mu = x0, v = x1, D = x2: the angle at which the drum stops; omega just before */
static vm_drum drum_driven(const vm_real *x)
{
    vm_drum d = {VM_C(0.5), 3, 1, 0, 0, 0, 0, 2};
    d.band = x[0], d.speed = x[1], d.damping = x[2];
    return d;
}
static vm_real drum_stop_ours(const vm_real *x)
{
    const vm_drum d = drum_driven(x);
    return vm_drum_stop(&d);
}
static vm_real drum_stop_naive(const vm_real *x) { return 2 / (x[2] - x[0] * x[1] / 2); }
static vm_real drum_rate_ours(const vm_real *x)
{
    const vm_drum d = drum_driven(x);
    return vm_drum_rate(&d, x[3]);
}
static vm_real drum_rate_naive(const vm_real *x)
{
    return (2 + (x[0] * x[1] / 2 - x[2]) * x[3]) / (1 + x[0] / 4 * x[3]);
}
/* The same on an elastic shaft whose centre has risen by x4 */
static vm_real drum_rate_elastic_ours(const vm_real *x)
{
    const vm_drum d = drum_driven(x);
    return vm_drum_rate_elastic(&d, x[3], x[4]);
}
static vm_real drum_rate_elastic_naive(const vm_real *x)
{
    return drum_rate_naive(x) * (1 - x[0] / 2 * x[4] / (1 + x[0] / 4 * x[3]));
}

/* Velocity at t = x0 after a start at rest from 1, alpha = x1, by the energy */
static vm_real start_velocity_ours(const vm_real *x)
{
    vm_real place, v;
    vm_osc_exact(x[0], 1, 1, x[1], &place, &v);
    return v;
}
static vm_real start_velocity_naive(const vm_real *x)
{
    vm_real place, v;
    vm_osc_exact(x[0], 1, 1, x[1], &place, &v);
    return -SQRT(2 / (x[1] + 1) * (1 - POW(FABS(place), x[1] + 1)));
}

/* (71): y of a broken rotor a short time x0 after, -s psi (1 - cos w t) */
static vm_real broken_rotor_ours(const vm_real *x)
{
    const vm_real start[6] = {0, 0, 1, 0, 0, 0};
    vm_broken_rotor rotor = {1, 1, 4, 1, 0, VM_C(0.125)};
    vm_real end[6];
    return vm_broken_rotor_linear_uncoupled(&rotor, x[0], start, end) == VM_OK ? end[1] : VM_NAN;
}
static vm_real broken_rotor_naive(const vm_real *x) { return -VM_C(0.125) * (1 - COS(2 * x[0])); }

/* Bore of a grain of 40 kg, radius x1 and length x2 that was solid, when x0 kg are left */
static vm_real grain_bore_ours(const vm_real *x)
{
    vm_supply grain = {VM_GRAIN, {0, 0, 0}, {0, 0, 1}, 1, 1, 0, 40};
    vm_supply_left left;
    grain.radius = x[1];
    grain.length = x[2];
    return vm_supply_at(&grain, x[0], &left) == VM_OK ? left.size : VM_NAN;
}
static vm_real grain_bore_naive(const vm_real *x)
{
    const vm_real density = 40 / (VM_PI * x[1] * x[1] * x[2]);
    return SQRT(x[1] * x[1] - x[0] / (VM_PI * density * x[2]));
}

/* x at the time x0 of a body that leaves the pericentre (1, 0) with the speed x1; mu = 1 */
static vm_real slim_orbit_ours(const vm_real *x)
{
    vm_vec3 r = {1, 0, 0}, v = {0, 0, 0};
    v.y = x[1];
    return vm_orbit(x[0], 1, r, v, &r, &v) == VM_OK ? r.x : VM_NAN;
}
static vm_real slim_orbit_naive(const vm_real *x)
{
    const vm_real a = 1 / (2 - x[1] * x[1]), e = 1 - 1 / a, M = x[0] / (a * SQRT(a));
    vm_real E = POW(6 * M, VM_C(1.) / 3);
    int i;
    for (i = 0; i < 60; i++) E -= (E - e * SIN(E) - M) / (1 - e * COS(E));
    return a * (COS(E) - e);
}

static const hard_case cancellation_cases[] = {
    CASE(ca, 8, "ca from 1 - sa^2 next to a zero of ca: the difference cancels", R(2.622057, 2.6219), 3),
    CASE(ca, 8, "ca for alpha < 1 from 1 - sa^2 next to a zero of ca: the difference cancels", R(1.37, 1.36), 0.25),
    CASE(sa, 8, "sa from 1 - ca^(alpha+1) next to a zero of sa: the difference cancels", R(1e-6, 1e-2), 3),
    CASE(sa, 8, "sa for alpha = 1000 from 1 - ca^(alpha+1): ca stays close to 1 for long, and the difference cancels",
         R(1e-5, 1e-2), 1000),
    CASE(beta_rest, 30, "1 - I_x(a, b) as a difference (I_x: incomplete beta function) for x -> 1: no digit is left",
         R(1e-20, 1e-9), 0.25, 2),
    CASE(beta_rest, 30, "1 - I_x(a, b) as a difference for x close to 1: many digits cancel", R(1e-7, 1e-3), 0.5, 2),
    CASE(beta_inverse_rest, 32, "1 - w, w being the solution of I_w(a, b) = p, for w next to 1: the difference cancels",
         R(1e-12, 1e-5), 0.25, 0.5),
    CASE(beta_inverse_rest, 32,
         "1 - w, w being the solution of I_w(a, b) = p, for p next to 1: p has few digits of 1 - p", R(1e-9, 1e-4),
         0.0625, 0.5),
    CASE(K_near_1, 2, "K for m close to 1, computed from m: the rounded m has few digits of 1 - m", R(3e-13, 3e-6)),
    CASE(K_near_1, 2, "K for m closer to 1, computed from m: m rounds to 1, and K becomes infinite", R(1e-20, 1e-12)),
    CASE(F_incomplete, 8,
         "integral F(phi, m) for phi close to pi/2 and m close to 1: 1 - sin^2 phi loses digits of phi",
         R(1.5707963, 1.5703125), R(1e-16, 1e-8)),
    CASE(Pi_incomplete, 8,
         "integral Pi(n; phi, m) for a large negative n, as F and a term with n: nearly all of F is subtracted", 1.25,
         R(-1e8, -1e6), 0.5),
    CASE(rotating, 4, "sn(u) for m > 1 (a rotating pendulum) at u = 1e7: the product k u in the formula is rounded",
         R(1e7, 3000.25), 2.5),
    CASE(E_near_1, 2, "E as K (1 - sum) for m close to 1: K is large, E is nearly 1, and 1 - sum cancels",
         R(1e-250, 1e-35)),
    CASE(modulus_rest, 12, "1 - m for a given small k'K: m is next to 1 and has few digits of 1 - m", R(1e-4, 1e-2)),
    CASE(modulus_of_K_rest, 4,
         "1 - m for a given large K: 1 - m is of the order e^(-2K), and m has few digits of 1 - m", R(15, 7)),
    CASE(cn, 8, "cn from 1 - sn^2 close to a quarter period: the difference cancels", R(2.2805, 2.28), 0.81),
    CASE(cn, 8, "cn for m < 0 from 1 - sn^2 close to a quarter period: the difference cancels", R(0.9555, 0.955), -5),
    CASE(sn, 8, "sn from 1 - cn^2 for a small u: the difference cancels", R(1e-7, 1e-3), 0.5),
    CASE(dn, 8, "dn as cos(phi_0)/cos(phi_1 - phi_0), by the arithmetic-geometric mean: 0/0 at the quarter period",
         R(2.2805491, 2.280549), 0.81),
    CASE(dn, 8, "dn as cos(phi_0)/cos(phi_1 - phi_0) close to the quarter period: both cosines are small",
         R(2.2805, 2.2803), 0.81),
    CASE(cn_m1, 8, "cn far from u = 0 for m -> 1: the period depends on 1 - m, and m has few digits of 1 - m",
         R(20, 10), R(1e-15, 1e-6)),
    CASE(dn_m1, 8, "dn as sqrt(1 - m sn^2) for m -> 1: the difference cancels", R(18, 9), R(1e-14, 1e-6)),
    CASE(free_body, 32,
         "omega_1 of a free body that turns nearly about its middle axis: L^2 - 2 T I2, needed for 1 - m, cancels", 3,
         2, 1, 1, R(1.7320508, 1.73206), R(9, 6)),
    CASE(free_body, 64,
         "omega_1 of another free body that turns nearly about its middle axis, later: L^2 - 2 T I2 cancels", 2.5, 2,
         1.25, 0.75, R(0.86602541, 0.8661), R(40, 16)),
    CASE(energy_gain, 4,
         "energy gained in a separation at high speed, as a difference of kinetic energies: no digit is left",
         R(123456789, 12345)),
    CASE(energy_gain, 4, "energy gained in a separation at a higher speed, as such a difference: no digit is left",
         R(9876543210, 987654)),
    CASE(energy_loss, 4,
         "energy lost in an attachment at high speed, as a difference of kinetic energies: no digit is left",
         R(987654321, 98765)),
    CASE(far_spin, 16, "spin of the rest after a separation, by angular momenta about a far origin: they nearly cancel",
         R(100000.1, 300.1), R(100000.5, 300.5)),
    CASE(far_spin, 16, "spin of the rest, about a farther origin: Steiner's theorem loses the inertia of the rest",
         R(1000000000.1, 10000.1), R(1000000000.5, 10000.5)),
    CASE(about_far_point, 4,
         "angular momentum about a point a far from the origin, as r x p - a x p: the difference cancels",
         R(100000000.1, 10000.1), R(100000000.4, 10000.4)),
    CASE(far_relative, 8,
         "relative velocity far from the origin by velocities of a rotating frame at two points: they cancel",
         R(1000000000.1, 100000.1), R(1000000000.3, 100000.3)),
    CASE(split_inertia, 8, "inertia of the rest by Steiner's theorem to a far origin and back: large terms cancel",
         R(31234567.3, 1234.3)),
    CASE(drum_stop, 4, "angle at which a drum stops, if drive and damping nearly cancel: their difference loses digits",
         0.3, 0.7, R(0.1050000001, 0.10501)),
    CASE(drum_rate, 8, "angular velocity of a drum just before it stops, as a difference that cancels", 0.3, 0.7, 0.205,
         R(19.9999999, 19.999)),
    CASE(drum_rate_elastic, 8,
         "angular velocity of a drum on an elastic shaft just before it stops, as a difference that cancels", 0.3, 0.7,
         0.205, R(19.9999999, 19.999), 0.05),
    CASE(start_velocity, 16, "velocity next to a turning point from the energy: 1 - x^(alpha+1) cancels", R(1e-5, 1e-2),
         3),
    CASE(start_velocity, 16, "velocity for alpha < 1 next to a turning point from the energy: 1 - x^(alpha+1) cancels",
         R(1e-6, 1e-3), 0.5),
    CASE(broken_rotor, 4, "deflection of a rotor just after it has broken, by 1 - cos(w t): the difference cancels",
         R(1e-6, 1e-3)),
    CASE(grain_bore, 4,
         "bore radius of a propellant grain that has just begun to burn: a difference of volumes cancels",
         R(39.9999999999, 39.999), 0.7, 1.3),
    CASE(slim_orbit, 8, "position on a long ellipse next to its pericentre by Kepler's equation: E - e sin E cancels",
         1.5, R(1.414213561, 1.41421)),
    CASE(slim_orbit, 8, "position on a long ellipse at a later time by Kepler's equation: E - e sin E cancels", 30,
         R(1.414213561, 1.41421)),
};
