/* Chapter 3.3.2 of varmass.h: the broken rotor, (46)-(74): its motion before the break, the break, and the motion of
   the remainder.
   Oracles: arbitrary precision (the reference cases C1, C3-C5 and tests/data/rotor_linear.h), integration, the vector
   form by vm_separate, and balances of energy. The equations that the dissertation prints wrongly are evaluated as
   printed and must miss by a known amount. Steady rotation and stability are in
   tests/test_broken_rotor_stability.c. */
#include "broken_rotor.h"

/* ---- Before the break (46)-(51) ---- */

/* The equation after (52), |v_S| at t, corrected and as printed */
static double speed_from_orbit(const vm_real *abcd, double w, double t, int printed)
{
    const double A = (double)abcd[0], B = (double)abcd[1], C = (double)abcd[2], D = (double)abcd[3];
    if (printed) return w * sqrt(pow(C - A, 2) + pow(B - D, 2) - 2 * (C - A) * (B - D) * sin(2 * w * t));
    return w * sqrt(A * A + B * B + C * C + D * D - 2 * (A * C + B * D) * cos(2 * w * t) +
                    2 * (B * C - A * D) * sin(2 * w * t));
}

static void test_case_C1(void)
{
    const double w = 1.7, t = 0.8, c = cos(w * t), s = sin(w * t);
    const double x = 0.3503788357778127207376, y = 0.1882380556300258192127, v = 0.5731537279920264463668;
    const vm_broken_rotor r = rotor_of(w * w, 0, 1, 0, 0);
    vm_real start[6], end[6], abcd[4];
    double A, B, C, D;
    set_state(start, 0.3, -0.2, 0, 0.5, 0.4, 0);
    CHECK(vm_broken_rotor_orbit(&r, start, abcd) == VM_OK && vm_broken_rotor_free_motion(&r, R(t), start, end) == VM_OK);
    check_case("A0 (51)", "C1", abcd[0], 0.2676470588235294117647, 1, 1);
    check_case("B0 (51)", "C1", abcd[1], -0.2470588235294117647059, 1, 1);
    check_case("C0 (51)", "C1", abcd[2], 0.03235294117647058823529, 1, 1);
    check_case("D0 (51)", "C1", abcd[3], 0.04705882352941176470588, 1, 1);
    check_case("x (48)-(50)", "C1", end[0], x, 1, 3);
    check_case("y (48)-(50)", "C1", end[1], y, 1, 2);
    check_case("v_Sb (52)", "C1", R(hypot((double)end[3], (double)end[4])), v, 1, 2);
    check_case("v_Sb from A0..D0", "C1", R(speed_from_orbit(abcd, w, t, 0)), v, 1, 2);
    /* as printed it is 13 % off, and right at t1 = 0 only */
    ERRATUM("v_Sb (after (52))", fabs(speed_from_orbit(abcd, w, t, 1) - 0.4963006479) < 1e-5,
            check_holds("v_Sb from A0..D0"));
    CHECK(fabs(speed_from_orbit(abcd, w, 0, 1) - hypot(0.5, 0.4)) < 10 * eps);
    A = (double)abcd[0];
    B = (double)abcd[1];
    C = (double)abcd[2];
    D = (double)abcd[3];
    check_case("x (50)", "C1", R((A + C) * c + (D - B) * s), x, 1, 3);
    check_case("y (50)", "C1", R((B + D) * c + (A - C) * s), y, 1, 2);
}

/* (46) with spin, damping and torque against integration; the spin goes to (47). */
static void test_free_motion(void)
{
    int i;
    for (i = 0; i < 60; i++) {
        const double t = uniform(-2, 8);
        double p[5], final;
        vm_broken_rotor r = random_rotor(p);
        vm_real start[6], y[6], z[6];
        r.s = 0;
        if (i % 5 == 1) r.damping = 0;
        if (i % 5 == 2) r.stiffness = 0;
        if (i % 5 == 3) r.torque = 0;
        random_state(start, 1, 1);
        memcpy(z, start, sizeof z);
        CHECK(vm_broken_rotor_free_motion(&r, R(t), start, y) == VM_OK && integrate(vm_broken_rotor_rhs, &r, z, t) >= 0);
        check_error("(46)", "integrated", "tol", state_error(y, z), 10, i, t);
        if (!(r.damping > R(0.3) * r.inertia) || r.torque == 0) continue;
        CHECK(vm_broken_rotor_free_motion(&r, 400 * r.inertia / r.damping, start, y) == VM_OK);
        final = (double)(r.torque / r.damping);
        check_case("Omega_b (47)", "free", y[5], final, fabs(final), 4);
    }
}

/* ---- The break (52)-(64) ---- */

/* Case C3: radius R, SS2, Omega_b, v_Sb, M, m, I_S1, I_S2 */
static const double C3_R = 1, C3_d = 0.6, C3_spin = 2, C3_v = 0.9, C3_M = 5, C3_m = 0.8, C3_I1 = 1.3, C3_I2 = 0.12;

/* m/(M - m), and the part m M/(M - m) SS2^2 of the moment of inertia of the whole */
static double C3_share(void) { return C3_m / (C3_M - C3_m); }
static double C3_place_inertia(void) { return C3_share() * C3_M * C3_d * C3_d; }

/* Case C3 with other I_S1, I_S2 and alpha; v_Sb is along SA, which is the x axis. */
static int break_C3(double I1, double I2, double alpha, vm_broken_rotor_break *b)
{
    vm_broken_rotor whole = {5, 0, 7, R(0.4), R(0.8), 0};
    vm_broken_rotor_piece piece;
    vm_real before[6];
    memset(&piece, 0, sizeof piece);
    whole.inertia = R(I1 + I2 + C3_place_inertia());
    piece.mass = R(C3_m);
    piece.inertia = R(I2);
    piece.distance = R(C3_d);
    piece.radius = R(C3_R);
    piece.alpha = R(alpha);
    set_state(before, 0, 0, 0, C3_v, 0, C3_spin);
    return vm_broken_rotor_break_off(&whole, before, &piece, b);
}

static void test_case_C3(void)
{
    const double dragging = C3_spin * C3_d;
    vm_broken_rotor_break b;
    double printed, corrected, change;
    CHECK(break_C3(C3_I1, C3_I2, 0, &b) == VM_OK);
    check_case("I_S1", "C3", b.rest.inertia, 1.3, 1, 2);
    check_case("v_S2d (61)", "C3", b.dragging, 1.5, 1, 1);
    check_case("gamma (60)", "C3", b.gamma, 0.9272952180016122324285, 1, 2);
    check_case("sin gamma (60)", "C3", R(sin((double)b.gamma)), dragging / 1.5, 1, 1);
    check_case("beta (56)", "C3", b.beta, 0, 1, 0);
    check_case("N (54)", "C3", b.normal, 0.9, 1, 1);
    check_case("T (55)", "C3", b.tangential, 1.2, 1, 2);
    check_case("Omega_r (63)", "C3", b.spin_piece, 3, 3, 2);
    check_case("Omega_r (63)", "C3", b.spin_piece, C3_d / (1 - C3_d) * C3_spin, 3, 2);
    check_case("Omega_r1 (58)", "C3", b.spin_rest, 0.2505494505494505494505, 1, 2);
    check_case("Omega_1a (64)", "C3", b.state[5], 2.250549450549450549451, 1, 3);
    check_case("v_S1 (64)", "C3", b.state[3], 0.9, 1, 1);
    check_case("v_S1 (64)", "C3", b.state[4], 0, 1, 1);
    check_case("v_r (62)", "C3", b.piece[4] - R(dragging), -1.2, 1, 3); /* against the dragging velocity of S2 */
    check_case("v_r (62)", "C3", b.piece[3] - R(0.9), 0, 1, 1);
    check_case("s = SS1", "C3", b.rest.s, 0.8 * 0.6 / 4.2, 1, 1);
    /* (62) is printed with +Omega x SS2, which changes v_S1 = v_Sb + Omega x SS1 - m/(M - m) v_r */
    change = -C3_share() * dragging - C3_share() * dragging;
    ERRATUM("(62)", fabs(change + 0.457) < 1e-3, check_holds("v_r (62)") && check_holds("v_S1 (64)"));
    /* the second form of (64) is printed without the part of the place of S2 */
    printed = C3_spin * (1 - C3_I2 * C3_d / (C3_I1 * (1 - C3_d)));
    corrected = printed + C3_spin * C3_place_inertia() / C3_I1;
    check_case("(64) second form", "C3", b.state[5], corrected, 1, 3);
    ERRATUM("(64) 2nd form", fabs(printed - 1.72308) < 1e-5, check_holds("(64) second form"));
}

/* The text after (64) says that the spin jumps to a lower value. It jumps from 2 to 2.25 in case C3, stays where
   I_S2 (M - m) is m M SS2 (R - SS2), and falls only where I_S2 is larger than that. */
static void test_direction_of_jump(void)
{
    const double kept = C3_share() * C3_M * C3_d * (C3_R - C3_d);
    vm_broken_rotor_break b;
    CHECK(break_C3(C3_I1, C3_I2, 0, &b) == VM_OK);
    ERRATUM("text after (64)", (double)b.state[5] > C3_spin + 0.25, check_holds("Omega_1a (64)"));
    CHECK(break_C3(C3_I1, kept, 0, &b) == VM_OK);
    check_case("Omega_1a = Omega_b (64)", "C3", b.state[5], C3_spin, 1, 3);
    CHECK(break_C3(C3_I1, 1.1 * kept, 0, &b) == VM_OK && (double)b.state[5] < C3_spin - 0.01);
    CHECK(break_C3(C3_I1, 0.9 * kept, 0, &b) == VM_OK && (double)b.state[5] > C3_spin + 0.01);
}

/* The I_S2 for which the rest stops. As printed, I_S1 = I_S2 SS2/AS2, it does not. */
static void test_break_to_rest(void)
{
    const double I_S = 1.762857142857142857143, rest_I1 = I_S * 0.6 - C3_place_inertia();
    vm_broken_rotor_break b;
    CHECK(break_C3(C3_I1, C3_I2, 0, &b) == VM_OK);
    check_case("I_S2 of rest (64)", "C3", b.stop_inertia, I_S * 0.4, 1, 2);
    CHECK(break_C3(rest_I1, I_S * 0.4, 0, &b) == VM_OK);
    check_case("Omega_1a = 0 (64)", "C3", b.state[5], 0, 1, 30);
    CHECK(break_C3(1.3, 1.3 * 0.4 / 0.6, 0, &b) == VM_OK);
    ERRATUM("after (64)", fabs((double)b.state[5] - 0.527) < 1e-3, check_holds("Omega_1a = 0 (64)"));
}

/* Omega_r1 of (58), corrected and as printed without a factor M; and Omega_1a of (59) as printed with a wrong sign and
   without two factors M */
typedef struct rest_spin {
    double relative, relative_printed, printed;
} rest_spin;

static rest_spin rest_spin_of(double alpha)
{
    const double across = C3_d * sin(alpha), along = C3_R - C3_d * cos(alpha), share = C3_share();
    const double beta = atan2(across, along), reach = hypot(across, along);
    const double ux = C3_v + C3_spin * C3_d * sin(alpha), uy = C3_spin * C3_d * cos(alpha);
    const double v = hypot(ux, uy), gamma = atan2(uy, ux), T = v * sin(gamma - beta);
    const double moment = C3_d * T * cos(alpha + beta); /* SS2 x v_T */
    const double I_S = C3_I1 + C3_I2 + C3_place_inertia();
    rest_spin spin;
    spin.relative = (C3_M * share * moment - C3_I2 * T / reach) / C3_I1;
    spin.relative_printed = (share * moment - C3_I2 * T / reach) / C3_I1;
    spin.printed = (I_S * C3_spin - C3_I2 * (C3_spin + T / reach) + share * C3_d * C3_d * C3_spin + share * moment) /
                   C3_I1;
    return spin;
}

static void check_break_angle(double alpha)
{
    const double ux = 0.9 + 1.2 * sin(alpha), v = sqrt(0.81 + 1.44 + 2 * 0.9 * 1.2 * sin(alpha)); /* (52) */
    const double reach = sqrt(1 + 0.36 - 1.2 * cos(alpha));                                       /* (57) */
    const rest_spin spin = rest_spin_of(alpha);
    vm_broken_rotor_break b;
    CHECK(break_C3(C3_I1, C3_I2, alpha, &b) == VM_OK);
    check_case("v_S2d (52)", "alpha", b.dragging, v, 1, 5);
    check_case("gamma (52)", "alpha", R(v * sin((double)b.gamma)), 1.2 * cos(alpha), 1, 4);
    check_case("gamma (52)", "alpha", R(v * cos((double)b.gamma)), ux, 1, 4);
    check_case("(53)", "alpha", b.normal * b.normal + b.tangential * b.tangential, v * v, 1, 30);
    check_case("N (54)", "alpha", b.normal, v * cos((double)(b.beta - b.gamma)), 1, 5);
    check_case("T (55)", "alpha", b.tangential, v * sin((double)(b.gamma - b.beta)), 1, 5);
    check_case("tan beta (56)", "alpha", R(tan((double)b.beta) * (1 - 0.6 * cos(alpha))), 0.6 * sin(alpha), 1, 3);
    check_case("Omega_r (57)", "alpha", b.spin_piece * R(reach), (double)b.tangential, 1, 6);
    check_case("Omega_r1 (58)", "alpha", b.spin_rest, spin.relative, 1, 6);
    check_case("Omega_1a (59)", "alpha", b.state[5], 2 + spin.relative, 1, 7);
}

static void test_break_angles(void)
{
    const rest_spin spin = rest_spin_of(0.4);
    vm_broken_rotor_break b;
    double alpha, printed;
    for (alpha = -3; alpha < 3.1; alpha += 0.25) check_break_angle(alpha);
    ERRATUM("(58)", fabs(spin.relative_printed + 0.044022) < 1e-6,
            fabs(spin.relative - 0.033536) < 1e-6 && check_holds("Omega_r1 (58)"));
    ERRATUM("(59)", fabs(spin.printed - 2.588945) < 1e-6,
            fabs(2 + spin.relative - 2.033536) < 1e-6 && check_holds("Omega_1a (59)"));
    CHECK(break_C3(C3_I1, C3_I2, 1e-3, &b) == VM_OK);
    ERRATUM("(56)", fabs(atan(0.6 * sin(1e-3) / (1 - cos(1e-3))) - 1.569963) < 1e-6, /* no limit at alpha = 0 */
            fabs((double)b.beta - 0.0015) < 1e-6 && check_holds("tan beta (56)"));
    /* (55) as printed has the other sign of T, and by it (57) that of Omega_r */
    CHECK(break_C3(C3_I1, C3_I2, 0, &b) == VM_OK);
    printed = 1.5 * sin((double)(b.beta - b.gamma));
    ERRATUM("(53)-(55)", fabs(printed + 1.2) < 10 * eps,
            b.tangential > 0 && check_holds("(53)") && check_holds("T (55)"));
    ERRATUM("(57)", fabs(printed / 0.4 + 3) < 30 * eps, b.spin_piece > 0 && check_holds("Omega_r (57)"));
}

/* A flat disc in space: its moments of inertia about x and y are half of that about z. */
static vm_body disc(const vm_real *state, double mass, double moment)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = R(mass);
    b.inertia = inertia(moment / 2, 0, 0, moment / 2, 0, moment);
    b.r = vmi_vec3(state[0], state[1], 0);
    b.v = vmi_vec3(state[3], state[4], 0);
    b.omega.z = state[5];
    return b;
}

static vm_vec3 velocity_of_point(const vm_body *b, vm_vec3 point)
{
    return vm_add(b->v, vm_cross(b->omega, vm_sub(point, b->r)));
}

/* A random break. The rest must be the body that vm_separate leaves when this piece goes; the shaft must stay where it
   is; and by the closure (57) the point A of the piece must keep the velocity that it has in the whole. Returns 0 if
   the rest is one that no body in space has. */
static int check_random_break(int i)
{
    vm_broken_rotor whole = {0, 0, 3, R(0.4), R(0.8), 0};
    vm_broken_rotor_piece p;
    vm_broken_rotor_break b;
    vm_real before[6];
    vm_body body, part, rest;
    vm_vec3 A, change, shaft_shift;
    const double fraction = pow(10, uniform(-3, -0.3));
    double psi;
    memset(&b, 0, sizeof b);
    memset(&rest, 0, sizeof rest);
    whole.mass = R(uniform(1, 10));
    whole.inertia = whole.mass / 2;
    p.mass = R(fraction) * whole.mass;
    p.inertia = p.mass * R(uniform(0, 0.05));
    p.distance = R(uniform(0, 0.6));
    p.radius = 1;
    p.alpha = R(uniform(-3, 3));
    p.contact = R(uniform(-3, 3));
    random_state(before, 1, 3);
    before[5] *= 3;
    CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_OK);
    body = disc(before, (double)whole.mass, (double)whole.inertia);
    body.inertia.xx = 4 * whole.inertia; /* thick, so that the rest is possible in space */
    body.inertia.yy = 4 * whole.inertia;
    part = disc(b.piece, (double)p.mass, (double)p.inertia);
    if (vm_separate(&body, &part, NULL, &rest) < 0) return 0;
    check_error("(58), (59)", "vm_separate", "eps",
                fabs((double)(rest.omega.z - b.state[5])) / eps * (double)(b.rest.inertia / whole.inertia), 10, i,
                0);
    check_error("I_S1", "vm_separate", "eps",
                fabs((double)(rest.inertia.zz - b.rest.inertia)) / eps / (double)whole.inertia, 3, i, 0);
    check_error("v_S1 (59)", "vm_separate", "eps",
                size_of(vm_sub(rest.v, vmi_vec3(b.state[3], b.state[4], 0))) / eps, 5, i, 0);
    check_error("r_S1", "vm_separate", "eps", size_of(vm_sub(rest.r, vmi_vec3(b.state[0], b.state[1], 0))) / eps, 3,
                i, 0);
    psi = (double)b.state[2];
    shaft_shift = vector((double)(b.state[0] - before[0]) + (double)b.rest.s * cos(psi),
                         (double)(b.state[1] - before[1]) + (double)b.rest.s * sin(psi), 0);
    check_error("shaft", "in place", "eps", size_of(shaft_shift) / eps, 8, i, 0);
    A = vmi_vec3(before[0] + R(cos((double)p.contact)), before[1] + R(sin((double)p.contact)), 0);
    change = vm_sub(velocity_of_point(&part, A), velocity_of_point(&body, A));
    check_error("A keeps v (57)", "closure", "eps", size_of(change) / eps, 10, i, 0);
    return 1;
}

static void test_random_breaks(void)
{
    int i, possible = 0;
    for (i = 0; i < 500; i++) possible += check_random_break(i);
    CHECK(possible > 490);
}

/* ---- Limits of the break ---- */

/* m -> 0: the changes go with m M/(M - m), to a few eps of themselves. */
static void test_light_piece(void)
{
    const vm_broken_rotor whole = {5, 2, 7, R(0.4), R(0.8), 0};
    const double least = is_float ? 1e-30 : 1e-300;
    vm_broken_rotor_piece p = {1, 0, R(0.5), R(0.3), 1, R(0.2)};
    vm_broken_rotor_break b;
    vm_real before[6];
    double m, moment;
    set_state(before, 0.1, 0.2, 0.3, 0.9, -0.4, 2);
    p.mass = R(1e-6);
    CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_OK);
    moment = (double)(b.spin_rest * b.rest.inertia / p.mass * b.rest.mass);
    for (m = 1e-6; m > least; m /= 10) {
        double spin, offset;
        p.mass = R(m);
        CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_OK);
        spin = (double)(b.spin_rest * b.rest.inertia / p.mass * b.rest.mass);
        check_error("Omega_r1/m", "m -> 0", "eps", fabs(spin / moment - 1) / eps, 8, m, 0);
        offset = (double)(b.rest.s / p.mass * b.rest.mass / p.distance);
        check_error("s/m", "m -> 0", "eps", fabs(offset - 1) / eps, 4, m, 0);
    }
    CHECK(b.state[5] == before[5] && b.state[3] == before[3] && b.rest.inertia == whole.inertia);
}

/* m -> M from the middle: the rest is a ring that keeps its inertia. */
static void test_light_rest(void)
{
    const vm_broken_rotor whole = {5, 2, 7, R(0.4), R(0.8), 0};
    vm_broken_rotor_piece p = {1, 0, 0, R(0.3), 1, R(0.2)};
    vm_broken_rotor_break b, kept;
    vm_real before[6];
    double m;
    set_state(before, 0.1, 0.2, 0.3, 0.9, -0.4, 2);
    for (m = 1e-1; m > 4 * eps; m /= 8) {
        vm_real momentum;
        p.mass = whole.mass - R(m);
        CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_OK && b.rest.inertia == whole.inertia);
        momentum = p.mass * b.piece[3] + b.rest.mass * b.state[3];
        check_error("momentum", "m -> M", "eps",
                    fabs((double)(momentum - whole.mass * before[3])) / eps / (double)whole.mass, 3, m, 0);
    }
    kept = b;
    p.mass = whole.mass;
    CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_BAD_MASS);
    p.mass = 1;
    p.inertia = whole.inertia * (1 - 4 * VM_EPSILON); /* I_S1 is lost in rounding errors */
    CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_BAD_INERTIA);
    p.inertia = 0;
    p.distance = 1; /* S2 is in A */
    p.alpha = 0;
    CHECK(vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_DOMAIN);
    CHECK(memcmp(&kept, &b, sizeof b) == 0);
}

/* ---- The remainder (65)-(68) ---- */

/* (68) as written; ctx are omega^2, s, p^2, k*, M*. */
static int rhs_68(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const double *p = (const double *)ctx;
    const double x = (double)y[0], z = (double)y[1], c = cos((double)y[2]), s = sin((double)y[2]);
    (void)t;
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = R(-p[0] * x - p[1] * p[0] * c);
    dydt[4] = R(-p[0] * z - p[1] * p[0] * s);
    dydt[5] = R(-p[3] * (double)y[5] + p[4] + p[1] * p[2] * p[0] * (x * s - z * c));
    return 0;
}

/* (69); ctx as for (68), and p[5] is a factor of the last term: 1, or 0 without it. */
static int rhs_69(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const double *p = (const double *)ctx;
    (void)t;
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = R(-p[0] * (double)y[0] - p[1] * p[0]);
    dydt[4] = R(-p[0] * (double)y[1] - p[1] * p[0] * (double)y[2]);
    dydt[5] = R(-p[3] * (double)y[5] + p[4] - p[5] * p[1] * p[2] * p[0] * (double)y[1]);
    return 0;
}

/* Case C5: Fig. 18 at t = 10, for two torques */
static void test_case_C5(void)
{
    static const struct {
        double torque, x, y, psi, rate, r;
    } cases[2] = {{0.625, -0.1533745010129565912545, 0.7688162863359383865255, 4.849621465461194533551,
                   0.6037825839006644010631, 0.7839657005866755544996},
                  {1, -1.091259011650718279185, 0.3085364131674529190863, 6.162762858423204766815,
                   0.7016215230240906640867, 1.134037454742628731321}};
    int i;
    for (i = 0; i < 2; i++) {
        vm_broken_rotor r = rotor_of(1, 0.5, 4, 1, cases[i].torque);
        const double torque = cases[i].torque;
        vm_real y[6];
        set_state(y, 0, 0, 0.5, 0, 0, 0);
        CHECK(integrate(vm_broken_rotor_rhs, &r, y, 10) >= 0);
        check_error("x (68)", "C5", "tol", fabs((double)y[0] - cases[i].x) / TOLERANCE, 2, torque, 0);
        check_error("y (68)", "C5", "tol", fabs((double)y[1] - cases[i].y) / TOLERANCE, 2, torque, 0);
        check_error("psi (68)", "C5", "tol", fabs((double)y[2] - cases[i].psi) / TOLERANCE, 2, torque, 0);
        check_error("psi' (68)", "C5", "tol", fabs((double)y[5] - cases[i].rate) / TOLERANCE, 2, torque, 0);
        check_error("r (68)", "C5", "tol", fabs(hypot((double)y[0], (double)y[1]) - cases[i].r) / TOLERANCE, 2,
                    torque, 0);
    }
}

/* (65), (66) are (68). The shaft's moment about S1 is (shaft - S1) x force, and the energy changes by the power of
   torque and damping. */
static void test_remainder(void)
{
    int i, k;
    for (i = 0; i < 200; i++) {
        double p[5], power, m, stiffness, e, c, s, fx, fy, shaft_x, shaft_y, shaft_vx, shaft_vy;
        vm_broken_rotor r = random_rotor(p);
        vm_real y[6], a[6] = {0}, b[6];
        random_state(y, 2, 9);
        vm_broken_rotor_rhs(0, y, a, &r);
        rhs_68(0, y, b, p);
        for (k = 0; k < 6; k++) check_case("(65)-(68)", "rhs", a[k], (double)b[k], 10, 4);
        m = (double)r.mass;
        stiffness = (double)r.stiffness;
        e = (double)r.s;
        c = cos((double)y[2]);
        s = sin((double)y[2]);
        fx = m * (double)a[3];
        fy = m * (double)a[4];
        check_case("torque (65)", "rhs", r.inertia * a[5] + r.damping * y[5] - r.torque, e * (c * fy - s * fx), 10,
                   3);
        shaft_x = (double)y[0] + e * c;
        shaft_y = (double)y[1] + e * s;
        shaft_vx = (double)y[3] - e * s * (double)y[5];
        shaft_vy = (double)y[4] + e * c * (double)y[5];
        power = m * (double)(y[3] * a[3] + y[4] * a[4]) + (double)(r.inertia * y[5] * a[5]) +
                stiffness * (shaft_x * shaft_vx + shaft_y * shaft_vy);
        check_case("energy (65)", "rhs", (r.torque - r.damping * y[5]) * y[5], power, 40, 2);
    }
}

/* ---- The linear equations of the remainder (69)-(74) ---- */

static const struct {
    double rotor[6], t, start[6];
    int coupled;
    double end[6], condition[6];
} linear_cases[] = {
#include "data/rotor_linear.h"
};

typedef int linear_motion(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end);

/* The coupled form is all of (69). The uncoupled one is (70)-(72), without the last term of (69). */
static linear_motion *linear_form(int coupled)
{
    return coupled ? vm_broken_rotor_linear : vm_broken_rotor_linear_uncoupled;
}

/* Against 40 digits, with parameters over six decades and zero. The unit is the change by one rounding of the inputs. */
static void test_linear_reference(void)
{
    static const char *names[] = {"x (70)", "y (71)", "psi (72)", "x' (70)", "y' (71)", "psi' (72)"};
    size_t i;
    int k;
    for (i = 0; i < sizeof linear_cases / sizeof *linear_cases; i++) {
        const vm_broken_rotor r = rotor_from(linear_cases[i].rotor);
        const double *p = linear_cases[i].start, t = linear_cases[i].t;
        const int coupled = linear_cases[i].coupled;
        vm_real y[6];
        int beyond_range = 0, status;
        set_state(y, p[0], p[1], p[2], p[3], p[4], p[5]);
        for (k = 0; k < 6; k++)
            beyond_range = beyond_range || linear_cases[i].condition[k] > 0.01 * (double)VM_MAX;
        status = linear_form(coupled)(&r, R(t), y, y);
        if (beyond_range) continue;
        CHECK(status == VM_OK);
        for (k = 0; k < 6; k++) {
            const double expected = linear_cases[i].end[k], unit = linear_cases[i].condition[k] + fabs(expected);
            check_error(names[k], coupled ? "(69)" : "closed form", "cond", fabs((double)y[k] - expected) / eps / unit,
                        1, (double)i, t);
        }
    }
}

enum { STIFFNESS, DAMPING, TORQUE, OFFSET, PARAMETERS };

static void set_parameter(vm_broken_rotor *r, int which, double value)
{
    if (which == STIFFNESS) r->stiffness = R(value);
    if (which == DAMPING) r->damping = R(value);
    if (which == TORQUE) r->torque = R(value);
    if (which == OFFSET) r->s = R(value);
}

/* When a parameter goes to zero from one side, the motion changes by as much as the parameter does. */
static void check_through_zero(int which, int side, int coupled)
{
    static const char *names[PARAMETERS] = {"stiffness", "damping", "torque", "s"};
    vm_broken_rotor r = rotor_of(1.7, 0.3, 1, 0.6, 0.5), zero = r;
    vm_real start[6], y[6] = {0}, z[6] = {0};
    double size;
    int i;
    set_state(start, 0.1, -0.05, 0.15, 0.07, 0.11, 0.4);
    set_parameter(&zero, which, 0);
    CHECK(linear_form(coupled)(&zero, 3, start, z) == VM_OK);
    for (size = 1e-3; size > eps * eps; size /= 10) {
        set_parameter(&r, which, side * size);
        CHECK(linear_form(coupled)(&r, 3, start, y) == VM_OK);
        for (i = 0; i < 6; i++)
            check_error(names[which], "through zero", "shift", fabs((double)(y[i] - z[i])) / (size + 4 * eps), 8,
                        side * size, coupled);
    }
}

static void test_through_zero(void)
{
    int which, coupled;
    for (which = 0; which < PARAMETERS; which++) {
        for (coupled = 0; coupled < 2; coupled++) {
            if (which != STIFFNESS) check_through_zero(which, -1, coupled);
            check_through_zero(which, 1, coupled);
        }
    }
}

/* x, y and psi' by (70)-(72) as printed */
static void printed_linear(const double *p, const double *y0, double Omega, double t, double *x, double *y,
                           double *rate)
{
    const double w2 = p[0], w = sqrt(w2), s = p[1], k = p[3], sum = w2 + k * k, lack = Omega - y0[5];
    *x = (y0[0] + s) * cos(w * t) + y0[3] / w * sin(w * t) - s;
    *y = s / k * lack - s * y0[2] - s * Omega * t - s * w2 / (sum * k) * lack * exp(-k * t) +
         (y0[4] / w + s * w / sum * (y0[5] + Omega * k * k / w2)) * sin(w * t) +
         (y0[1] + s * y0[2] - lack * s * k / sum) * cos(w * t);
    *rate = Omega - lack * exp(-k * t);
}

static const double C4_start[6] = {0.1, -0.05, 0.15, 0.07, 0.11, 0.4};

static void start_C4(vm_real *start)
{
    const double *y0 = C4_start;
    set_state(start, y0[0], y0[1], y0[2], y0[3], y0[4], y0[5]);
}

static void test_case_C4(void)
{
    const vm_broken_rotor r = rotor_of(1.69, 0.2, 1, 0.35, 0.35 * 0.9);
    vm_real start[6], y[6];
    start_C4(start);
    CHECK(vm_broken_rotor_linear_uncoupled(&r, 2, start, y) == VM_OK);
    check_case("x (70)", "C4", y[0], -0.4293088598356822497793, 1, 2);
    check_case("y (71)", "C4", y[1], -0.1248708354566459698133, 1, 2);
    check_case("psi' (72)", "C4", y[5], 0.6517073481042952426476, 1, 2);
}

/* The linear motion against (70)-(72) as printed, which are right for the uncoupled equations, and against (69)
   integrated */
static void test_linear_motion(void)
{
    int i, k, coupled;
    for (i = 0; i < 40; i++) {
        vm_broken_rotor r;
        vm_real start[6], y[6], z[6];
        double p[6], x, y_71, rate, t, Omega;
        start_C4(start);
        for (k = 0; k < 6; k++) p[k] = uniform(0.2, 2);
        Omega = p[4];
        p[4] = p[3] * Omega;
        r = rotor_of(p[0], p[1], p[2], p[3], p[4]);
        t = uniform(0.1, 5);
        CHECK(vm_broken_rotor_linear_uncoupled(&r, R(t), start, y) == VM_OK);
        printed_linear(p, C4_start, Omega, t, &x, &y_71, &rate);
        check_case("x (70)", "printed", y[0], x, 1 + p[1], 4);
        check_case("y (71)", "printed", y[1], y_71, 10 / p[3], 4);
        check_case("psi' (72)", "printed", y[5], rate, 1 + Omega, 4);
        for (coupled = 0; coupled < 2; coupled++) {
            p[5] = coupled;
            memcpy(z, start, sizeof z);
            CHECK(integrate(rhs_69, p, z, t) >= 0);
            CHECK(linear_form(coupled)(&r, R(t), start, y) == VM_OK);
            check_error("(69)", coupled ? "coupled" : "uncoupled", "tol",
                        state_error(y, z) / (1 + fabs((double)z[1])), 4, t, i);
        }
    }
}

/* |t| (|k*| + 1.5 omega) is between 1 and 2. y and its condition number, the unit, are by the functions of
   tests/gen/rotor_reference.py with 60 digits. The first row is for double only. */
static void test_few_rates(void)
{
    static const struct {
        double rotor[6], t, psi, psi_rate, y, condition;
    } rows[] = {
        {{2.9774353303546763, .53636702098467881, 4.3670987473175591e-4, -.0026176872220472552, .018350567870972161,
          .18545633570384948},
         -49.036033483280761, -.23401851570216625, .14253772298817891, -.1333534435485845080448, 1.50975},
        {{3.046795606613159, .601671576499939, .0004532365419436246, -.0029078840743750334, .01533646509051323,
          .15200790762901306},
         -51.02419662475586, -.28797647356987, .13588958978652954, -.0820675080859911633253, 1.02522},
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const vm_broken_rotor r = rotor_from(rows[i].rotor);
        vm_real y[6];
        if (!representable(rows[i].t)) continue;
        set_state(y, 0, 0, rows[i].psi, 0, 0, rows[i].psi_rate);
        CHECK(vm_broken_rotor_linear_uncoupled(&r, R(rows[i].t), y, y) == VM_OK);
        check_error("y (71)", "few rates", "cond",
                    fabs((double)y[1] - rows[i].y) / eps / (rows[i].condition + fabs(rows[i].y)), 3, (double)i, 0);
    }
}

/* The result depends on a mode that is far slower than the vibration of the shaft or the decay of the spin: y, psi, y'
   and psi' with 100 digits, and their condition numbers, which are the units. The last row is for double only. */
static void test_slow_modes(void)
{
    static const char *names[] = {"y (71)", "psi (72)", "y' (71)", "psi' (72)"};
    static const int places[] = {1, 2, 4, 5};
    static const struct {
        double rotor[6], t, start[6], end[4], condition[4];
    } rows[] = {
        {{1, 1, 1e6, 1e4, 0, 0.0078125}, 3000, {0, 0, 0.0009765625, 0, 0, 0},
         {-683.36766145482193981, 87471.060669587174338, -4.1709425074068110401, 533.88065965690175533},
         {63930.8, 8.09568e+6, 412.109, 51547.6}},
        {{1, 1, 1e8, 1e6, 0, 0.0078125}, 5000, {0, 0, 0.0009765625, 0, 0, 0},
         {-136806197.1732088934, 17511193238.177261783, -834998.75694678859484, 106879840.88922667309},
         {2.11486e+10, 2.68951e+12, 1.32421e+8, 1.6843e+10}},
        {{1, 1, 1e10, 1e6, 0, 0.0009765625}, 5000, {0, 0, 0.0009765625, 0, 0, 0},
         {-487724466661871.43314, 499429853861760889.83, -4651302929025.307776, 4762934199321958.4812},
         {1.17258e+17, 1.19573e+20, 1.13686e+15, 1.15939e+18}},
        {{1, 1, 4, 64, 0, 0.0078125}, 1, {0, 0, 0, 0, 0, 1},
         {-0.00016935466079112590697, 0.015625029948468829362, -0.00022495192300183313019, 8.0955608050156306641e-8},
         {0.00111665, 0.0468753, 0.00113296, 7.785e-7}},
        {{2, 0.5, 64, 16, 1, 0.125}, 32, {0, 0.5, -0.25, 0, 0.25, 1},
         {-0.50885075062645124769, 4.7196871736979647149, 0.86986876683475509449, 0.33131366749144427706},
         {61.0607, 45.6789, 169.62, 32.4969}},
        {{0.012090815082263956, 0.09350907352520522, 0.54771477257108, 0.052110582763598964, 67.06401981034298,
          -0.02736621894427801},
         1950.1233992734387, {-31.1957298649864, 0.13771582853065972, 97.82302883517038, 65.73672179596578,
                              3.5902511971119324, -10.636425508706488},
         {16595886705.864326883, 606437769913.23389063, 128839734.10962287414, 4707990427.2187652337},
         {1.2252e+12, 4.41642e+13, 1.00203e+10, 3.61439e+11}},
    };
    size_t i;
    int k;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const vm_broken_rotor r = rotor_from(rows[i].rotor);
        const double *p = rows[i].start;
        vm_real y[6];
        if (!representable(rows[i].t)) continue;
        set_state(y, p[0], p[1], p[2], p[3], p[4], p[5]);
        CHECK(vm_broken_rotor_linear(&r, R(rows[i].t), y, y) == VM_OK);
        for (k = 0; k < 4; k++) {
            const double expected = rows[i].end[k], unit = rows[i].condition[k] + fabs(expected);
            check_error(names[k], "slow mode", "cond", fabs((double)y[places[k]] - expected) / eps / unit, 1,
                        (double)i, 0);
        }
    }
}

/* A motion that grows to nearly the largest number: in one time, and in two halves of it */
static void test_largest_motion(void)
{
    const vm_broken_rotor r = {1, 1, 1, 0, 0, R(.5)};
    const double t = is_float ? 190 : 1552; /* the motion grows as exp(0.4551 t) */
    vm_real once[6] = {0}, twice[6];
    int i;
    set_state(twice, 0, 0, 1, 0, 0, 0);
    CHECK(vm_broken_rotor_linear(&r, R(t), twice, once) == VM_OK);
    CHECK(vm_broken_rotor_linear(&r, R(t / 2), twice, twice) == VM_OK);
    CHECK(vm_broken_rotor_linear(&r, R(t / 2), twice, twice) == VM_OK);
    CHECK(fabs((double)once[2]) > 0.001 * (double)VM_MAX);
    for (i = 1; i < 6; i++)
        if (i != 3) check_case("(69)", "largest", once[i] / twice[i], 1, t, 4);
}

/* What overflows does not matter if its factor is 0: without spin and torque, only x moves. */
static void test_zero_times_overflow(void)
{
    const vm_broken_rotor centred = {1, 1, 1, 1, 0, 0}, rest = {1, 1, 1, R(.1), 0, R(.5)};
    const double t = is_float ? -100 : -720;
    vm_real start[6], y[6] = {0};
    set_state(start, 1, 0, 0, 0, 0, 0);
    CHECK(vm_broken_rotor_free_motion(&centred, R(t), start, y) == VM_OK);
    check_case("x (70)", "exp overflows", y[0], cos(t), -t, 1);
    CHECK(y[1] == 0 && y[2] == 0 && y[4] == 0 && y[5] == 0);
    CHECK(vm_broken_rotor_linear_uncoupled(&rest, R(10 * t), start, y) == VM_OK);
    check_case("x (70)", "exp overflows", y[0], 1.5 * cos(10 * t) - 0.5, -15 * t, 1);
    CHECK(y[1] == 0 && y[2] == 0 && y[4] == 0 && y[5] == 0);
    CHECK(vm_broken_rotor_linear(&rest, 5000, start, y) == VM_OK);
    check_case("x (70)", "exp overflows", y[0], 1.5 * cos(5000) - 0.5, 7500, 1);
    CHECK(y[1] == 0 && y[2] == 0 && y[4] == 0 && y[5] == 0);
}

/* Without coupling, damping alone changes psi', by the factor e^-30 here. */
static void test_decayed_rate(void)
{
    vm_broken_rotor r = {1, 1, 4, 0, 0, 0}, soft = {1, 1, 0, 0, 0, R(.3)};
    vm_real start[6], y[6] = {0}, z[6] = {0};
    double k;
    set_state(start, .1, -.2, .3, .4, -.5, 3);
    for (k = 1.875; k < 1000; k *= 2) {
        r.damping = soft.damping = R(k);
        CHECK(vm_broken_rotor_linear(&r, R(30 / k), start, y) == VM_OK);
        CHECK(vm_broken_rotor_linear(&soft, R(30 / k), start, z) == VM_OK);
        check_case("psi' (69)", "s = 0", y[5], 3 * exp(-30), 3 * exp(-30), 4);
        check_case("psi' (69)", "stiffness = 0", z[5], 3 * exp(-30), 3 * exp(-30), 4);
    }
}

/* The rotor of Fig. 18: what (71), (72) lack at t = 3 against all of (69); and x of (70) against (68), which it
   follows for short times only */
static void test_linear_range(void)
{
    vm_broken_rotor r = rotor_of(1, 0.5, 4, 1, 0.625);
    vm_real start[6], y[6], z[6];
    double error;
    set_state(start, 0, 0, 0.5, 0, 0, 0);
    CHECK(vm_broken_rotor_linear_uncoupled(&r, 3, start, y) == VM_OK && vm_broken_rotor_linear(&r, 3, start, z) == VM_OK);
    ERRATUM("(71),(72)",
            fabs((double)(y[1] - z[1]) - 0.14764) < 1e-4 && fabs((double)(y[5] - z[5]) + 1.20598) < 1e-4,
            check_holds("(69)"));
    memcpy(z, start, sizeof z);
    CHECK(vm_broken_rotor_linear(&r, R(0.5), start, y) == VM_OK && integrate(vm_broken_rotor_rhs, &r, z, 0.5) >= 0);
    error = fabs((double)(y[0] - z[0]));
    CHECK(error < 0.01 && error > 0.001);
    memcpy(z, start, sizeof z);
    CHECK(vm_broken_rotor_linear(&r, 3, start, y) == VM_OK && integrate(vm_broken_rotor_rhs, &r, z, 3) >= 0);
    CHECK(fabs((double)(y[0] - z[0])) > 0.1);
}

/* (73), (74) are (71), (72) with the spin by the second form of (64) as printed and SS2 = R - s: the algebra is right,
   the values in case C3 are wrong. */
static void test_transient_after_break(void)
{
    const double w2 = 1.69, s = 0.8 * 0.6 / 4.2, k = 0.35, Omega = 2, psi0 = 0.15, v = 0.11, t = 1.3;
    const double sum = w2 + k * k, w = sqrt(w2), ratio = C3_I2 / C3_I1, arm = C3_R - s;
    const double printed_spin = Omega * (1 - ratio * arm / s), true_spin = 2.250549450549450549451;
    const double p[6] = {w2, s, 1, k, 0, 0};
    double y0[6] = {0.1, -0.05, psi0, 0.07, v, printed_spin}, x, y, rate, y_73, rate_74;
    printed_linear(p, y0, Omega, t, &x, &y, &rate);
    y_73 = Omega / k * ratio * arm - s * psi0 - s * Omega * t -
           w2 * Omega / (sum * k) * ratio * arm * exp(-k * t) +
           (v / w + s * w * Omega / sum * (1 - ratio * arm / s + k * k / w2)) * sin(w * t) +
           (y0[1] + s * psi0 - Omega * ratio * k * arm / sum) * cos(w * t);
    rate_74 = Omega * (1 - ratio * arm / s * exp(-k * t));
    CHECK(fabs(y - y_73) < 1e-12 && fabs(rate - rate_74) < 1e-12);
    y0[5] = true_spin;
    printed_linear(p, y0, Omega, t, &x, &y, &rate);
    ERRATUM("(73),(74)", fabs(printed_spin - true_spin) > 1.6 && fabs(rate - rate_74) > 1 && fabs(y - y_73) > 0.02,
            check_holds("y (71)") && check_holds("psi' (72)") && check_holds("Omega_1a (64)"));
}

/* ---- Refusals ---- */

static const vm_broken_rotor good_rotor = {5, 2, 7, R(0.4), R(0.8), 0};
static const vm_broken_rotor_piece good_piece = {1, R(0.1), R(0.5), R(0.3), 1, R(0.2)};

static void good_start(vm_real *start) { set_state(start, 0.1, 0.2, 0.3, 0.9, -0.4, 2); }

/* Every function of the rotor refuses this rotor with this status, and nothing is written. */
static void check_rotor_refused(const vm_broken_rotor *r, int expected)
{
    const vm_real kept[6] = {7, 7, 7, 7, 7, 7};
    vm_real start[6], y[6] = {7, 7, 7, 7, 7, 7};
    vm_broken_rotor_break b, b_kept;
    memset(&b, 1, sizeof b);
    memset(&b_kept, 1, sizeof b_kept);
    good_start(start);
    CHECK(vm_broken_rotor_free_motion(r, 1, start, y) == expected && vm_broken_rotor_linear(r, 1, start, y) == expected);
    CHECK(vm_broken_rotor_linear_uncoupled(r, 1, start, y) == expected && vm_broken_rotor_orbit(r, start, y) == expected);
    CHECK(vm_broken_rotor_characteristic(r, 1, y) == expected && vm_broken_rotor_routh(r, 1, y) == expected);
    CHECK(vm_broken_rotor_eigenvalues(r, 1, y, y) == expected && vm_broken_rotor_is_stable(r, 0) == 0);
    CHECK(isnan(vm_broken_rotor_steady_radius(r, 1)) && isnan(vm_broken_rotor_resonance_radius(r, 1, 9)));
    CHECK(vm_broken_rotor_break_off(r, start, &good_piece, &b) == expected);
    CHECK(memcmp(y, kept, sizeof y) == 0 && memcmp(&b, &b_kept, sizeof b) == 0);
}

static void test_bad_rotors(void)
{
    const int expected[] = {VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE,
                            VM_NOT_FINITE, VM_BAD_MASS,   VM_BAD_INERTIA, VM_BAD_STIFFNESS};
    vm_broken_rotor bad[9];
    int i;
    for (i = 0; i < 9; i++) bad[i] = good_rotor;
    bad[0].mass = VM_NAN;
    bad[1].inertia = VM_INFINITY;
    bad[2].stiffness = VM_NAN;
    bad[3].damping = -VM_INFINITY;
    bad[4].torque = VM_NAN;
    bad[5].s = VM_NAN;
    bad[6].mass = 0;
    bad[7].inertia = 0;
    bad[8].stiffness = -1;
    for (i = 0; i < 9; i++) check_rotor_refused(&bad[i], expected[i]);
}

static void test_bad_pieces(void)
{
    const int expected[] = {VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE,  VM_NOT_FINITE,
                            VM_NOT_FINITE, VM_BAD_MASS,   VM_BAD_MASS,   VM_BAD_INERTIA, VM_BAD_INERTIA};
    vm_broken_rotor_piece bad[10];
    vm_broken_rotor_break b, kept;
    vm_real start[6];
    int i;
    memset(&b, 1, sizeof b);
    memset(&kept, 1, sizeof kept);
    good_start(start);
    for (i = 0; i < 10; i++) bad[i] = good_piece;
    bad[0].mass = VM_NAN;
    bad[1].inertia = VM_NAN;
    bad[2].distance = VM_INFINITY;
    bad[3].alpha = VM_INFINITY;
    bad[4].radius = VM_NAN;
    bad[5].contact = VM_NAN;
    bad[6].mass = 0;
    bad[7].mass = 5; /* that of the whole */
    bad[8].inertia = -1;
    bad[9].inertia = 2; /* that of the whole */
    for (i = 0; i < 10; i++) CHECK(vm_broken_rotor_break_off(&good_rotor, start, &bad[i], &b) == expected[i]);
    CHECK(vm_broken_rotor_break_off(NULL, start, &good_piece, &b) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_break_off(&good_rotor, start, NULL, &b) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_break_off(&good_rotor, start, &good_piece, NULL) == VM_BAD_ARGUMENT);
    start[3] = VM_NAN;
    CHECK(vm_broken_rotor_break_off(&good_rotor, start, &good_piece, &b) == VM_NOT_FINITE);
    bad[0] = good_piece;
    bad[0].mass = R(0.1);
    bad[0].alpha = 0;
    bad[0].radius = 2;
    bad[0].contact = 0;
    set_state(start, 0, 0, 0, 0, 0, 0);
    start[3] = start[4] = R(0.9) * VM_MAX; /* the motions are finite, the speed of the piece before the break is not */
    CHECK(vm_broken_rotor_break_off(&good_rotor, start, &bad[0], &b) == VM_NOT_FINITE);
    CHECK(memcmp(&b, &kept, sizeof b) == 0);
}

/* A shaft that misses the mass centre, no stiffness, and a motion that grows beyond the type's range */
static void test_domain(void)
{
    const vm_real kept[6] = {7, 7, 7, 7, 7, 7};
    vm_broken_rotor r = good_rotor;
    vm_real start[6], y[6] = {7, 7, 7, 7, 7, 7};
    vm_broken_rotor_break b;
    good_start(start);
    r.s = 1;
    CHECK(vm_broken_rotor_break_off(&r, start, &good_piece, &b) == VM_DOMAIN && vm_broken_rotor_free_motion(&r, 1, start, y) == VM_DOMAIN);
    r.s = VM_INFINITY;
    CHECK(vm_broken_rotor_free_motion(&r, 1, start, y) == VM_NOT_FINITE);
    r.s = 0;
    r.stiffness = 0;
    CHECK(vm_broken_rotor_orbit(&r, start, y) == VM_BAD_STIFFNESS);
    r.s = 1;
    r.stiffness = 1;
    r.inertia = R(1e-3); /* the motion grows as exp(21 t) */
    CHECK(vm_broken_rotor_linear(&r, 1000, start, y) == VM_NOT_FINITE);
    r.stiffness = is_float ? R(1e7) : R(1e10);
    r.inertia = is_float ? R(1e-32) : R(1e-300); /* s p^2 omega^2 overflows, and no other coefficient of (69) */
    r.damping = r.torque = 0;
    CHECK(vm_broken_rotor_linear(&r, 1, start, y) == VM_NOT_FINITE);
    CHECK(vm_broken_rotor_linear(&r, R(1e-9), start, y) == VM_NOT_FINITE);
    CHECK(memcmp(y, kept, sizeof y) == 0);
}

static void test_bad_arguments(void)
{
    const vm_broken_rotor *good = &good_rotor;
    const vm_real kept[6] = {7, 7, 7, 7, 7, 7};
    vm_real start[6], y[6] = {7, 7, 7, 7, 7, 7};
    good_start(start);
    CHECK(vm_broken_rotor_free_motion(good, VM_NAN, start, y) == VM_NOT_FINITE);
    CHECK(vm_broken_rotor_free_motion(NULL, 1, start, y) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_free_motion(good, 1, NULL, y) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_free_motion(good, 1, start, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_orbit(NULL, start, y) == VM_BAD_ARGUMENT && vm_broken_rotor_orbit(good, NULL, y) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_characteristic(good, VM_NAN, y) == VM_NOT_FINITE);
    CHECK(vm_broken_rotor_characteristic(NULL, 1, y) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_routh(good, 1, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_eigenvalues(good, 1, y, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_broken_rotor_to_polar(NULL, y) == VM_BAD_ARGUMENT && vm_broken_rotor_from_polar(y, NULL) == VM_BAD_ARGUMENT);
    start[3] = VM_NAN;
    CHECK(vm_broken_rotor_free_motion(good, 1, start, y) == VM_NOT_FINITE && vm_broken_rotor_orbit(good, start, y) == VM_NOT_FINITE);
    CHECK(vm_broken_rotor_to_polar(start, y) == VM_NOT_FINITE && vm_broken_rotor_from_polar(start, y) == VM_NOT_FINITE);
    CHECK(memcmp(y, kept, sizeof y) == 0);
    CHECK(strcmp(vm_strerror(VM_DOMAIN), vm_strerror(-99)) != 0);
}

/* ---- Hostile numbers ---- */

/* Zero, ones, the type's limits and numbers that are not finite, of either sign */
static vm_real hostile(void)
{
    const vm_real numbers[] = {0,      1,           R(0.3),         VM_EPSILON,
                               VM_MIN, VM_MIN / 4,  1 / VM_EPSILON, VM_SQRT(VM_MAX) / 3,
                               VM_MAX, VM_INFINITY, VM_NAN};
    const int count = (int)(sizeof numbers / sizeof *numbers), k = (int)uniform(0, 3 * count);
    const vm_real x = k < count ? numbers[k] : R(uniform(0, 3));
    return uniform(-1, 3) < 0 ? -x : x;
}

enum { OUTPUTS = 12 };
static const vm_real untouched[OUTPUTS] = {7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7};

static int all_finite(const vm_real *x, int n)
{
    int i;
    for (i = 0; i < n; i++)
        if (!VM_IS_FINITE(x[i])) return 0;
    return 1;
}

/* Either success and finite results, or a status and outputs untouched. The outputs are filled for the next call.
   Returns 1 for success. */
static int check_outcome(int status, vm_real *out, int n)
{
    if (status) CHECK(status < 0 && memcmp(out, untouched, (size_t)n * sizeof *out) == 0);
    else CHECK(all_finite(out, n));
    memcpy(out, untouched, sizeof untouched);
    return status == 0;
}

static void hostile_rotor(vm_broken_rotor *r, int centred)
{
    r->mass = hostile();
    r->inertia = hostile();
    r->stiffness = hostile();
    r->damping = hostile();
    r->torque = hostile();
    r->s = centred ? 0 : hostile();
}

/* Returns how many calls succeeded. */
static int check_hostile_motion(const vm_broken_rotor *r, const vm_real *start, vm_real t, vm_real Omega)
{
    vm_real y[OUTPUTS];
    int good = 0;
    memcpy(y, untouched, sizeof y);
    good += check_outcome(vm_broken_rotor_free_motion(r, t, start, y), y, 6);
    good += check_outcome(vm_broken_rotor_linear(r, t, start, y), y, 6);
    good += check_outcome(vm_broken_rotor_linear_uncoupled(r, t, start, y), y, 6);
    good += check_outcome(vm_broken_rotor_orbit(r, start, y), y, 4);
    good += check_outcome(vm_broken_rotor_to_polar(start, y), y, 6);
    good += check_outcome(vm_broken_rotor_from_polar(start, y), y, 6);
    good += check_outcome(vm_broken_rotor_characteristic(r, Omega, y), y, 6);
    good += check_outcome(vm_broken_rotor_routh(r, Omega, y), y, 6);
    good += check_outcome(vm_broken_rotor_eigenvalues(r, Omega, y, y + 5), y, 10);
    CHECK(!(vm_broken_rotor_resonance_radius(r, t, Omega) < 0));
    return good;
}

static int check_hostile_break(const vm_broken_rotor *r, const vm_real *start)
{
    vm_broken_rotor_piece p;
    vm_broken_rotor_break b, unbroken;
    p.mass = hostile();
    p.inertia = hostile();
    p.distance = hostile();
    p.alpha = hostile();
    p.radius = hostile();
    p.contact = hostile();
    memset(&b, 1, sizeof b);
    memset(&unbroken, 1, sizeof unbroken);
    if (vm_broken_rotor_break_off(r, start, &p, &b)) {
        CHECK(memcmp(&b, &unbroken, sizeof b) == 0);
        return 0;
    }
    CHECK(all_finite(b.state, 6));
    CHECK(all_finite(b.piece, 6));
    return 1;
}

static void test_hostile(void)
{
    long i, good = 0;
    for (i = 0; i < 20000; i++) {
        vm_broken_rotor r;
        vm_real start[6], t, Omega;
        int k;
        hostile_rotor(&r, i % 2 == 1);
        t = hostile();
        Omega = hostile();
        for (k = 0; k < 6; k++) start[k] = hostile();
        good += check_hostile_motion(&r, start, t, Omega);
        good += check_hostile_break(&r, start);
    }
    CHECK(good > 1000);
}

int main(void)
{
    test_case_C1();
    test_free_motion();
    test_case_C3();
    test_direction_of_jump();
    test_break_to_rest();
    test_break_angles();
    test_random_breaks();
    test_light_piece();
    test_light_rest();
    test_case_C5();
    test_remainder();
    test_linear_reference();
    test_through_zero();
    test_case_C4();
    test_linear_motion();
    test_few_rates();
    test_slow_modes();
    test_largest_motion();
    test_zero_times_overflow();
    test_decayed_rate();
    test_linear_range();
    test_transient_after_break();
    test_bad_rotors();
    test_bad_pieces();
    test_domain();
    test_bad_arguments();
    test_hostile();
    return check_finish("broken_rotor");
}
