/* Fuzz target: varmass.h, Lagrange's equations, chapters 4 and 6. A jump in the six coordinates of a free body is
   vm_separate's, the cut pendulum balances, momenta and rates are each other's inverse. */
#include "bodies.h"

/* The derivatives of v and omega of a free body by the rates of its six coordinates */
static void free_coordinates(vm_vec3 *dr, vm_vec3 *turn)
{
    memset(dr, 0, 6 * sizeof *dr);
    memset(turn, 0, 6 * sizeof *turn);
    dr[0].x = 1;
    dr[1].y = 1;
    dr[2].z = 1;
    turn[3].x = 1;
    turn[4].y = 1;
    turn[5].z = 1;
}

/* The mass matrix gives the momenta p = matrix q', of which the last three are the angular momentum, and the energy
   q' matrix q'/2. */
static void check_quadratic(const vm_body *body, const vm_real *matrix, const vm_real *rates, const vm_real *p)
{
    const vm_vec3 L = vm_angular_momentum(body, body->r);
    const double v = size3(body->v), turning = size3(body->omega), trace = trace_of(&body->inertia);
    const double T = (double)vm_kinetic_energy(body);
    const double T_scale = (double)body->mass * v * v + trace * turning * turning;
    double sum[6], energy = 0;
    int i, j;
    for (i = 0; i < 6; i++) {
        sum[i] = 0;
        for (j = 0; j < 6; j++) sum[i] += (double)matrix[6 * i + j] * (double)rates[j];
        energy += sum[i] * (double)rates[i] / 2;
        HOLDS(fabs(sum[i] - (double)p[i]) <= 32 * EPS * (i < 3 ? (double)body->mass * v : trace * turning));
    }
    HOLDS(fabs(energy - T) <= 32 * EPS * T_scale);
    HOLDS(within(p[3], L.x, 32 * EPS * trace * turning) && within(p[4], L.y, 32 * EPS * trace * turning) &&
          within(p[5], L.z, 32 * EPS * trace * turning));
}

static void check_hit(void)
{
    const vm_body body = draw_body(1);
    vm_impulse impulse = draw_impulse();
    vm_vec3 dr[6], turn[6];
    vm_real matrix[36], p[6], Q[6], rates[6], after[6], work[VM_LAGRANGE_WORK(6)], other[6];
    const vm_real null[6] = {0, 0, 0, 0, 0, 0};
    int i, status;
    free_coordinates(dr, turn);
    memset(matrix, 0, sizeof matrix);
    memset(p, 0, sizeof p);
    memset(Q, 0, sizeof Q);
    vm_lagrange_mass(6, &body, dr, turn, matrix);
    vm_lagrange_momentum(6, &body, dr, turn, p);
    vm_lagrange_impulse(6, &impulse, body.r, dr, turn, Q);
    vmi_set3(rates, body.v);
    vmi_set3(rates + 3, body.omega);
    if (tame_body(&body) && body.mass > 0 && vm_inertia_is_possible(&body.inertia))
        check_quadratic(&body, matrix, rates, p);
    STAIN(after);
    status = vm_lagrange_impact(6, matrix, rates, Q, after, work);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(after));
        return;
    }
    HOLDS(vmi_all_finite(6, after));
    STAIN(other);
    status = vm_lagrange_attach(6, matrix, matrix, rates, NULL, Q, other, work);
    if (status) HOLDS(UNTOUCHED(other));
    if (!tame_body(&body) || !tame3(impulse.linear) || !tame3(impulse.couple) || !tame3(impulse.at)) return;
    for (i = 0; i < 3; i++) /* the mass centre takes the linear impulse */
        HOLDS(within(after[i], rates[i] + Q[i] / body.mass,
                     64 * EPS * (double)(VM_FABS(rates[i]) + VM_FABS(Q[i] / body.mass))));
    if (status == 0)
        for (i = 0; i < 3; i++)
            HOLDS(within(other[i], after[i], 64 * EPS * (double)(VM_FABS(rates[i]) + VM_FABS(Q[i] / body.mass))));
    HOLDS(vm_lagrange_impact(6, matrix, rates, null, after, work) == 0 && close_to(after[0], rates[0], 4));
}

static void check_singular(void)
{
    vm_real before[4], after[4], qdot[2], part[2], out[2], work[VM_LAGRANGE_WORK(2)];
    const int n = draw_below(3);
    int i, status;
    for (i = 0; i < 4; i++) {
        before[i] = draw_in(-1, 1);
        after[i] = MOSTLY(draw_in(-1, 1));
    }
    before[2] = before[1];
    after[2] = after[1];
    for (i = 0; i < 2; i++) {
        qdot[i] = MOSTLY(draw_in(-3, 3));
        part[i] = MOSTLY(draw_in(-3, 3));
    }
    STAIN(out);
    status = vm_lagrange_separate(n, before, after, qdot, draw_byte() & 1 ? part : NULL, NULL, out, work);
    if (status) HOLDS(status < 0 && UNTOUCHED(out));
    else HOLDS(n > 0 && vmi_all_finite(n, out) && after[0] > 0);
}

/* The angular momentum about the pivot stays, and energies are not negative. */
static void check_cut(const vm_pendulum *p, const vm_pendulum_cut *cut, vm_real ux, vm_real uy)
{
    const double before = (double)(p->mass * p->length * p->length / 3 * p->rate), L1 = (double)cut->L1,
                 L2 = (double)cut->L2;
    const double kick = (double)(p->mass * p->length * (VM_FABS(ux) + VM_FABS(uy)));
    HOLDS(fabs(L1 + L2 - before) <= 64 * EPS * (fabs(L1) + fabs(L2) + fabs(before) + kick));
    HOLDS(cut->T1 >= 0 && cut->T_S1 >= 0 && cut->T_S2 >= 0);
}

static void check_pendulum(void)
{
    vm_pendulum p;
    vm_pendulum_cut cut;
    const vm_real Omega = MOSTLY(draw_in(-3, 3)), ux = MOSTLY(draw_in(-3, 3)), uy = MOSTLY(draw_in(-3, 3));
    vm_real part;
    int status;
    p.mass = MOSTLY(draw_log(0.1, 10));
    p.length = MOSTLY(draw_log(0.1, 10));
    p.angle = MOSTLY(draw_in(-4, 4));
    p.rate = MOSTLY(draw_in(-5, 5));
    p.axes = draw_byte() % 32 ? draw_below(2) : 5;
    part = draw_byte() % 8 ? p.length * draw_in(0, 1) : draw_any();
    STAIN(cut);
    status = vm_pendulum_separate(&p, part, Omega, ux, uy, &cut);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(cut));
        return;
    }
    HOLDS(part > 0 && part < p.length && p.mass > 0 && is_finite(cut.rest.rate) && cut.rest.mass >= 0 &&
          cut.mass >= 0);
    if (!tame(p.mass) || !tame(p.length) || !tame(p.angle) || !tame(p.rate) || !tame(Omega) || !tame(ux) ||
        !tame(uy) || !tame(part))
        return;
    HOLDS(close_to(cut.rest.mass + cut.mass, p.mass, 8) && close_to(cut.rest.length + part, p.length, 8));
    check_cut(&p, &cut, ux, uy);
    HOLDS(vm_pendulum_separate(&p, part, 0, 0, 0, &cut) == VM_OK); /* without relative velocities nothing changes */
    HOLDS(cut.rest.rate == p.rate && cut.rate == p.rate);
    HOLDS(close_to(cut.T_S1 + cut.T_S2, cut.T1, 32) &&
          close_to(cut.L1 + cut.L2, p.mass * p.length * p.length / 3 * p.rate, 32));
}

/* The angular momentum about the pivot stays, and without relative velocities nothing changes. */
static void check_compound(void)
{
    vm_compound_pendulum p;
    vm_compound_part part;
    vm_compound_cut cut;
    int status, all_tame;
    p.mass = MOSTLY(draw_log(0.5, 10));
    p.x = MOSTLY(draw_in(-1, 1));
    p.y = MOSTLY(draw_in(-1, 1));
    p.inertia = MOSTLY(draw_in(0, 20));
    p.rate = MOSTLY(draw_in(-5, 5));
    part.mass = MOSTLY(draw_log(0.1, 1));
    part.inertia = MOSTLY(draw_in(0, 1));
    part.x = MOSTLY(draw_in(-1, 1));
    part.y = MOSTLY(draw_in(-1, 1));
    part.ux = MOSTLY(draw_in(-3, 3));
    part.uy = MOSTLY(draw_in(-3, 3));
    part.Omega = MOSTLY(draw_in(-3, 3));
    STAIN(cut);
    status = vm_compound_pendulum_separate(&p, &part, &cut);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(cut));
        return;
    }
    HOLDS(cut.rest.mass > 0 && cut.rest.inertia > 0 && is_finite(cut.rest.rate) && cut.T1 >= 0 && cut.T_S2 >= 0);
    all_tame = tame(p.mass) && tame(p.x) && tame(p.y) && tame(p.inertia) && tame(p.rate) && tame(part.ux) &&
               tame(part.uy) && tame(part.Omega) && tame(part.x) && tame(part.y) && tame(part.mass) &&
               tame(part.inertia);
    if (!all_tame) return;
    HOLDS(fabs((double)(cut.L1 + cut.L2) - (double)(p.inertia * p.rate)) <=
          64 * EPS * (fabs((double)cut.L1) + fabs((double)cut.L2) + fabs((double)(p.inertia * p.rate)) +
                      (double)(part.mass * (VM_FABS(part.x * part.uy) + VM_FABS(part.y * part.ux)))));
    part.ux = part.uy = part.Omega = 0;
    HOLDS(vm_compound_pendulum_separate(&p, &part, &cut) == VM_OK && cut.rest.rate == p.rate && cut.rate == p.rate);
}

/* A double pendulum of drawn lengths; the mass of its bob falls with time. */
static void masses_of(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    const vm_real *p = (const vm_real *)ctx;
    (void)q;
    masses[0] = p[0];
    masses[1] = p[1] - p[2] * t;
}

static vm_real energy_of(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    const vm_real *p = (const vm_real *)ctx, a = p[3], b = p[4];
    (void)t;
    return (masses[0] + masses[1]) * a * a * rates[0] * rates[0] / 2 + masses[1] * b * b * rates[1] * rates[1] / 2 +
           masses[1] * a * b * rates[0] * rates[1] * VM_LIBM(cos)(q[0] - q[1]);
}

static int forces_of(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                     void *ctx)
{
    const vm_real *p = (const vm_real *)ctx;
    vm_vec3 weight = {0, 0, 0}, none = {0, 0, 0}, dr[2];
    (void)t;
    (void)rates;
    memset(dr, 0, sizeof dr);
    weight.y = -VM_C(9.81) * masses[1];
    dr[0].y = p[3] * VM_LIBM(sin)(q[0]);
    dr[1].y = p[4] * VM_LIBM(sin)(q[1]);
    vm_lagrange_add_force(2, weight, dr, none, NULL, Q);
    return p[5] > R(0.99) ? 3 : 0;
}

/* The drive's forces and those of forces_of are together what the motion needs. */
static void check_needed_forces(vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates,
                                int all_tame)
{
    const vm_real time_scale = draw_byte() % 4 ? draw_in(0, 9) : draw_any();
    vm_real accelerations[2], needed[2], drive[2], masses[2], forces[2] = {0, 0};
    int i, status;
    for (i = 0; i < 2; i++) accelerations[i] = MOSTLY(draw_in(-3, 3));
    STAIN(needed);
    status = vm_lagrange_needed_forces(l, t, time_scale, q, rates, accelerations, needed);
    if (status) HOLDS(status < 0 && UNTOUCHED(needed));
    else HOLDS(vmi_all_finite(2, needed) && time_scale >= 0);
    STAIN(drive);
    status = vm_lagrange_drive_forces(l, t, time_scale, q, rates, accelerations, drive);
    if (status) HOLDS(UNTOUCHED(drive));
    else HOLDS(vmi_all_finite(2, drive));
    if (status || !all_tame || !tame(accelerations[0]) || !tame(accelerations[1])) return;
    masses_of(t, q, masses, l->ctx);
    forces_of(t, q, rates, masses, forces, l->ctx);
    for (i = 0; i < 2; i++)
        HOLDS(within(drive[i] + forces[i], needed[i],
                     8 * EPS * (fabs((double)needed[i]) + fabs((double)forces[i]))));
}

static void check_equations(void)
{
    vm_real p[6], work[VM_LAGRANGE_RHS_WORK(2, 2)], q[2], rates[2], y[4], back[2], dydt[4], derivative;
    const vm_real t = MOSTLY(draw_in(0, 2));
    vm_lagrange_system l;
    volatile int outside = 2 + draw_below(9); /* volatile, or gcc warns of an index that is never used */
    int i, status, all_tame = tame(t);
    memset(&l, 0, sizeof l);
    p[0] = MOSTLY(draw_log(0.1, 10));
    p[1] = MOSTLY(draw_log(0.1, 10));
    p[2] = draw_in(0, 0.04);
    p[3] = draw_log(0.1, 3);
    p[4] = draw_log(0.1, 3);
    p[5] = draw_in(0, 1);
    l.n = 2;
    l.n_masses = 2;
    l.masses = masses_of;
    l.energy = energy_of;
    l.forces = forces_of;
    l.ctx = p;
    l.work = work;
    for (i = 0; i < 2; i++) {
        q[i] = MOSTLY(draw_in(-3, 3));
        rates[i] = MOSTLY(draw_in(-3, 3));
        /* a mass ratio beyond 1/eps makes the mass matrix singular */
        all_tame = all_tame && tame(q[i]) && tame(rates[i]) && tame(p[i]) && p[i] > R(0.09) && p[i] < 20;
    }
    STAIN(y);
    status = vm_lagrange_start(&l, t, q, rates, y);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(y));
        return;
    }
    HOLDS(vmi_all_finite(4, y));
    STAIN(back);
    status = vm_lagrange_rates(&l, t, y, back);
    if (status) HOLDS(UNTOUCHED(back));
    all_tame = all_tame && VM_FABS(t) <= 2;
    if (all_tame) {
        const double condition = 1e4 * (1 + fabs((double)rates[0]) + fabs((double)rates[1])) *
                                 (1 + (double)(p[0] / p[1]) + (double)(p[1] / p[0])) *
                                 (1 + (double)(p[3] / p[4]) + (double)(p[4] / p[3]));
        HOLDS(status == 0 && within(back[0], rates[0], condition * EPS * 4) &&
              within(back[1], rates[1], condition * EPS * 4));
        status = vm_lagrange_rhs(t, y, dydt, &l);
        HOLDS(status == 3 ? p[5] > R(0.99) : status == 0 && vmi_all_finite(4, dydt));
    }
    check_needed_forces(&l, t, q, rates, all_tame);
    derivative = vm_lagrange_partial_q(&l, t, q, rates, draw_below(2));
    if (all_tame) HOLDS(is_finite(derivative));
    HOLDS(is_nan(vm_lagrange_partial_q(&l, t, q, rates, outside)) &&
          is_nan(vm_lagrange_partial_q(&l, t, q, rates, -1 - outside)));
}

static void fuzz_lagrange(void)
{
    switch (draw_below(6)) {
    case 0: check_singular(); break;
    case 1: check_pendulum(); break;
    case 2: check_hit(); break;
    case 3: check_compound(); break;
    default: check_equations();
    }
}
FUZZ_TARGET(lagrange)
