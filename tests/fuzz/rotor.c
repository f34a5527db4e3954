/* Fuzz target: varmass.h, chapter 3.3.2, the broken rotor. Free motion keeps energy and composes; the break balances;
   eigenvalues are roots; right-hand sides agree in both coordinates. */
#include "bodies.h"

static vm_broken_rotor draw_rotor(void)
{
    vm_broken_rotor r;
    r.mass = MOSTLY(draw_log(1e-2, 1e2));
    r.inertia = MOSTLY(draw_log(1e-2, 1e2));
    r.stiffness = MOSTLY(draw_byte() % 8 ? draw_log(1e-2, 1e3) : 0);
    r.damping = MOSTLY(draw_byte() % 4 ? draw_log(1e-3, 10) : 0);
    r.torque = MOSTLY(draw_in(-5, 5));
    r.s = MOSTLY(draw_byte() % 2 ? draw_in(0, 1) : 0);
    return r;
}

static int tame_rotor(const vm_broken_rotor *r)
{
    return tame(r->mass) && tame(r->inertia) && tame(r->stiffness) && tame(r->damping) && tame(r->torque) &&
           tame(r->s) && r->mass > R(1e-3) && r->inertia > R(1e-3) && r->stiffness >= 0 && r->damping >= 0 &&
           VM_FABS(r->s) <= 10;
}

static void draw_state(vm_real *y)
{
    int i;
    for (i = 0; i < 6; i++) y[i] = draw_byte() % 64 ? draw_in(-2, 2) : draw_any();
}

static int all_tame(int n, const vm_real *y)
{
    while (n-- > 0)
        if (!tame(y[n]) || VM_FABS(y[n]) > 100) return 0;
    return 1;
}

static double energy_of_rotor(const vm_broken_rotor *r, const vm_real *y)
{
    return ((double)r->mass * ((double)y[3] * (double)y[3] + (double)y[4] * (double)y[4]) +
            (double)r->stiffness * ((double)y[0] * (double)y[0] + (double)y[1] * (double)y[1])) /
           2;
}

static void check_rotor_free(void)
{
    vm_broken_rotor r = draw_rotor();
    const vm_real t = MOSTLY(draw_in(-10, 10));
    vm_real start[6], end[6], abcd[4], back[6];
    int status;
    draw_state(start);
    STAIN(end);
    status = vm_broken_rotor_free_motion(&r, t, start, end);
    HOLDS(status <= 0 && (status == 0 || UNTOUCHED(end)));
    if (r.s != 0) HOLDS(status < 0);
    STAIN(abcd);
    if (vm_broken_rotor_orbit(&r, start, abcd) < 0) HOLDS(UNTOUCHED(abcd));
    if (status || !tame_rotor(&r) || !all_tame(6, start) || !tame(t)) return;
    HOLDS(vmi_all_finite(6, end));
    HOLDS(fabs(energy_of_rotor(&r, end) - energy_of_rotor(&r, start)) <=
          64 * EPS * energy_of_rotor(&r, start) * (1 + fabs((double)t) * sqrt((double)(r.stiffness / r.mass))) +
              1e-30);
    if (r.damping == 0 && vm_broken_rotor_free_motion(&r, -t, end, back) == 0)
        HOLDS(within(back[0], start[0],
                     256 * EPS * (1 + fabs((double)t)) * (1 + sqrt((double)(r.stiffness / r.mass))) *
                         (4 + fabs((double)end[0]) + 2 * fabs((double)end[3]) * (1 + fabs((double)t)))));
}

static void check_linear(void)
{
    const vm_broken_rotor r = draw_rotor();
    const vm_real t = MOSTLY(draw_in(-3, 3));
    vm_real start[6], end[6], at_start[6];
    int k, status;
    draw_state(start);
    for (k = 0; k < 2; k++) {
        STAIN(end);
        status = k ? vm_broken_rotor_linear(&r, t, start, end) : vm_broken_rotor_linear_uncoupled(&r, t, start, end);
        HOLDS(status <= 0 && (status == 0 ? vmi_all_finite(6, end) : UNTOUCHED(end)));
        if (status) continue;
        status = k ? vm_broken_rotor_linear(&r, 0, start, at_start) : vm_broken_rotor_linear_uncoupled(&r, 0, start, at_start);
        if (!tame_rotor(&r) || !all_tame(6, start)) continue;
        HOLDS(status == 0 && within(at_start[0], start[0], 8 * EPS * (1 + fabs((double)start[0]))));
        HOLDS(within(at_start[3], start[3], 64 * EPS * (1 + fabs((double)start[3]))));
    }
}

static double moment_about(const vm_real *state, const vm_real *origin, double mass, double *size)
{
    const double x = (double)state[0] - (double)origin[0], y = (double)state[1] - (double)origin[1],
                 vx = (double)state[3] - (double)origin[3], vy = (double)state[4] - (double)origin[4];
    const double reach = fabs((double)state[0]) + fabs((double)state[1]) + fabs((double)origin[0]) +
                         fabs((double)origin[1]);
    const double speed = fabs((double)state[3]) + fabs((double)state[4]) + fabs((double)origin[3]) +
                         fabs((double)origin[4]);
    *size += mass * ((fabs(x) + fabs(y)) * speed + reach * (fabs(vx) + fabs(vy)));
    return mass * (x * vy - y * vx);
}

/* Inertias about the whole's mass centre add up, and so do angular momenta about it, relative to its motion */
static void check_break_turning(const vm_broken_rotor *whole, const vm_real *before, const vm_broken_rotor_piece *piece,
                                const vm_broken_rotor_break *b)
{
    const double d = fabs((double)piece->distance), s = fabs((double)b->rest.s), m = (double)piece->mass,
                 M = (double)whole->mass, m1 = (double)b->rest.mass, J1 = (double)b->rest.inertia,
                 J2 = (double)piece->inertia;
    const double growth = M / m1, inertias = (double)whole->inertia + J2 + m * growth * d * d;
    double spin1 = (double)b->state[5], spin2 = (double)b->piece[5], scale = 0, L;
    HOLDS(fabs(m1 * s - m * d) <= 8 * EPS * growth * m * d);
    HOLDS(fabs(J1 + m1 * s * s + J2 + m * d * d - (double)whole->inertia) <= 16 * EPS * growth * inertias);
    L = moment_about(b->state, before, m1, &scale) + moment_about(b->piece, before, m, &scale);
    L += J1 * spin1 + J2 * spin2 - (double)whole->inertia * (double)before[5];
    scale += J1 * fabs(spin1) + J2 * fabs(spin2) + inertias * fabs((double)before[5]);
    HOLDS(fabs(L) <= 64 * EPS * growth * scale + inertias * (double)VM_MIN); /* subnormal spins have fewer digits */
}

static void check_break(void)
{
    const vm_broken_rotor whole = draw_rotor();
    vm_broken_rotor_piece piece;
    vm_broken_rotor_break result;
    vm_real before[6];
    int status;
    draw_state(before);
    piece.mass = draw_byte() % 8 ? whole.mass * draw_in(0, 1) : draw_any();
    piece.inertia = MOSTLY(draw_in(0, 0.1));
    piece.distance = MOSTLY(draw_in(0, 0.5));
    piece.alpha = MOSTLY(draw_in(-3, 3));
    piece.radius = MOSTLY(draw_in(0.5, 2));
    piece.contact = MOSTLY(draw_in(-4, 4));
    STAIN(result);
    status = vm_broken_rotor_break_off(&whole, before, &piece, &result);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(result));
        return;
    }
    HOLDS(vmi_all_finite(6, result.state) && vmi_all_finite(6, result.piece));
    HOLDS(is_finite(result.dragging) && is_finite(result.normal) && is_finite(result.tangential));
    HOLDS(is_finite(result.spin_piece) && is_finite(result.spin_rest));
    HOLDS(result.rest.mass > 0 && result.rest.inertia > 0 && piece.mass > 0 && piece.mass < whole.mass);
    if (tame_rotor(&whole) && all_tame(6, before) && tame(piece.mass) && tame(piece.inertia) &&
        tame(piece.distance))
        check_break_turning(&whole, before, &piece, &result);
    if (tame_rotor(&whole) && all_tame(6, before) && tame(piece.mass)) { /* momentum along x and y */
        int i;
        for (i = 3; i < 5; i++) {
            const double part = (double)piece.mass * (double)result.piece[i],
                         rest = (double)result.rest.mass * (double)result.state[i];
            if (fabs(part) < 1e6 && whole.s == 0)
                HOLDS(fabs(part + rest - (double)whole.mass * (double)before[i]) <=
                      64 * EPS *
                          (fabs(part) + fabs(rest) +
                           (double)whole.mass *
                               (fabs((double)before[3]) + fabs((double)before[4]) + 4 * fabs((double)before[5]))));
        }
    }
}

static void check_motion(void)
{
    vm_broken_rotor r = draw_rotor();
    vm_real y[6], dydt[6], polar[6], dpolar[6], back[6];
    int status, i;
    draw_state(y);
    status = vm_broken_rotor_rhs(0, y, dydt, &r);
    STAIN(polar);
    if (vm_broken_rotor_to_polar(y, polar)) {
        const vm_real radius = vmi_hypot(y[0], y[1]), v = VM_FABS(y[3]) + VM_FABS(y[4]);
        HOLDS(UNTOUCHED(polar) && (!vmi_all_finite(6, y) || radius == 0 || v / radius > VM_MAX / 2 ||
                                   v > VM_MAX / 2 || radius > VM_MAX / 2));
        return;
    }
    HOLDS(polar[0] > 0 && VM_FABS(polar[1]) <= VM_PI);
    STAIN(back);
    if (vm_broken_rotor_from_polar(polar, back)) {
        HOLDS(UNTOUCHED(back));
        return;
    }
    if (!tame_rotor(&r) || !all_tame(6, y)) return;
    HOLDS(status == 0 && vmi_all_finite(6, dydt));
    for (i = 0; i < 6; i++)
        HOLDS(within(back[i], y[i],
                     32 * EPS * (1 + fabs((double)y[3]) + fabs((double)y[4]) + fabs((double)y[i]) + (i < 2 ? (double)polar[0] : 0))));
    if (polar[0] < R(1e-3)) return;
    status = vm_broken_rotor_polar_rhs(0, polar, dpolar, &r); /* psi'' is the same */
    HOLDS(
        status == 0 &&
        within(dpolar[5], dydt[5],
               1e3 * EPS *
                   (1 + (double)((r.stiffness * VM_FABS(r.s) * 4 + r.damping * VM_FABS(y[5]) + VM_FABS(r.torque)) /
                                 r.inertia))));
    polar[0] = 0;
    HOLDS(vm_broken_rotor_polar_rhs(0, polar, dpolar, &r) == VM_DOMAIN);
}

/* a root of the polynomial but for so many eps of each of its terms, of whatever multiplicity it is */
static void check_root(const vm_real *c, double x, double y)
{
    const double size = hypot(x, y);
    double re = (double)c[0], im = 0, terms = fabs(re);
    int i;
    for (i = 1; i < 6; i++) {
        const double next = re * x - im * y + (double)c[i];
        im = re * y + im * x;
        re = next;
        terms = terms * size + fabs((double)c[i]);
    }
    HOLDS(hypot(re, im) <= 32 * EPS * terms + (double)VM_MIN);
}

/* The sum of the eigenvalues is -k*, they come in pairs, and they are roots of the polynomial c. A multiple root moves
   by the root of eps of its multiplicity, which is 3 at the most, as D, G > 0 and k* do not come together. */
static void check_eigenvalues(const vm_real *c, const vm_real *re, const vm_real *im, int stable)
{
    const double moved = 8 * cbrt(EPS);
    double sum = 0, scale = 0, others = 0;
    int i;
    for (i = 0; i < 5; i++) {
        sum += (double)re[i];
        others += (double)im[i];
        scale += fabs((double)re[i]) + fabs((double)im[i]);
    }
    HOLDS(fabs(sum + (double)c[1]) <= moved * (scale + (double)c[1]) && fabs(others) <= moved * scale);
    for (i = 0; i < 5 && !fuzz.wild; i++) check_root(c, (double)re[i], (double)im[i]);
    if (!stable) return;
    for (i = 0; i < 5; i++) HOLDS((double)re[i] <= moved * scale);
}

static void check_steady(void)
{
    const vm_broken_rotor r = draw_rotor();
    const vm_real Omega = MOSTLY(draw_in(-30, 30)), steady = vm_broken_rotor_steady_radius(&r, Omega);
    const int stable = vm_broken_rotor_is_stable(&r, Omega);
    vm_real c[6], re[5], im[5], column[6], growth;
    int i, status;
    STAIN(c);
    STAIN(re);
    STAIN(im);
    STAIN(column);
    if (vm_broken_rotor_characteristic(&r, Omega, c)) HOLDS(UNTOUCHED(c));
    status = vm_broken_rotor_eigenvalues(&r, Omega, re, im);
    if (vm_broken_rotor_routh(&r, Omega, column)) HOLDS(UNTOUCHED(column));
    if (status) {
        HOLDS(UNTOUCHED(re) && UNTOUCHED(im) && !(stable && tame_rotor(&r) && tame(Omega)));
    } else {
        HOLDS(vmi_all_finite(5, re) && vmi_all_finite(5, im));
        for (i = 0; i < 5; i++) { /* in order, but for multiple roots */
            const double before = i > 0 ? fabs((double)im[i - 1]) : 0;
            HOLDS(i == 0 || fuzz.wild || fabs((double)im[i]) >= before * (1 - 8 * cbrt(EPS)));
        }
        if (tame_rotor(&r) && VM_FABS(Omega) < R(1e3)) check_eigenvalues(c, re, im, stable);
    }
    if (r.s == 0 && tame_rotor(&r) && Omega * Omega * r.mass != r.stiffness && is_finite(Omega))
        HOLDS(steady == 0 || is_nan(steady));
    growth = vm_broken_rotor_resonance_radius(&r, MOSTLY(draw_in(0, 100)), Omega);
    HOLDS(is_nan(growth) || growth >= 0);
}

static void fuzz_rotor(void)
{
    switch (draw_below(5)) {
    case 0: check_rotor_free(); break;
    case 1: check_linear(); break;
    case 2: check_break(); break;
    case 3: check_motion(); break;
    default: check_steady();
    }
}
FUZZ_TARGET(rotor)
