/* Fuzz target: varmass.h, chapters 7.2 to 7.4. The oscillator's exact motion keeps its energy, and its
   approximations keep their amplitude; laws of mass agree with their rates; every route to x(t) gives a finite
   motion or says why not, and gives the same by each of its calls. */
#include "bodies.h"

static void check_exact(void)
{
    const vm_real alpha = MOSTLY(draw_in(0, 9)), x0 = MOSTLY(draw_in(-2, 2)), omega0 = MOSTLY(draw_log(0.1, 10));
    const vm_real v0 = MOSTLY(draw_in(-2, 2)), t = MOSTLY(draw_in(-20, 20));
    vm_real x, v, A, psi, energy, period = vm_osc_period(x0, omega0, alpha), vmax = vm_osc_vmax(x0, omega0, alpha);
    const int valid = alpha >= 0 && tame(alpha) && tame(x0) && tame(omega0) && omega0 > 0 && tame(t) && alpha < 20 &&
                      is_finite(vm_osc_energy(x0, 0, omega0, alpha));
    vm_osc_exact(t, x0, omega0, alpha, &x, &v);
    if (!(alpha >= 0) || !is_finite(alpha) || !is_finite(t) || is_nan(x0)) HOLDS(is_nan(x) && is_nan(v));
    if (valid && VM_FABS(x0) > R(0.01)) {
        HOLDS(VM_FABS(x) <= VM_FABS(x0) * (1 + 4 * VM_EPSILON) && VM_FABS(v) <= vmax * (1 + 16 * VM_EPSILON) &&
              period > 0);
        energy = vm_osc_energy(x0, 0, omega0, alpha);
        HOLDS(within(vm_osc_energy(x, v, omega0, alpha), energy, 64 * EPS * (2 + (double)alpha) * (double)energy));
        vm_osc_trig(t, x0, omega0, alpha, &x, &v);
        HOLDS(VM_FABS(x) <= VM_FABS(x0) * (1 + 8 * VM_EPSILON) && is_finite(v));
        vm_osc_jacobi(t, x0, omega0, alpha, &x, &v);
        HOLDS(VM_FABS(x) <= VM_FABS(x0) * (1 + 8 * VM_EPSILON) && is_finite(v));
    }
    vm_osc_amplitude_phase(x0, v0, omega0, alpha, &A, &psi);
    vm_osc_exact_from(t, x0, v0, omega0, alpha, &x, &v);
    if (valid && tame(v0) && VM_FABS(x0) > R(0.01)) {
        HOLDS(A >= VM_FABS(x0) * (1 - 8 * VM_EPSILON) && VM_FABS(psi) <= ateb_pi(alpha) * (1 + 4 * VM_EPSILON));
        energy = vm_osc_energy(x0, v0, omega0, alpha);
        HOLDS(
            within(vm_osc_energy(x, v, omega0, alpha), energy, 256 * EPS * (2 + (double)alpha) * (double)energy));
        HOLDS(within(vm_osc_energy(A, 0, omega0, alpha), energy, 64 * EPS * (2 + (double)alpha) * (double)energy));
    }
}

static void check_constants(void)
{
    const vm_real alpha = MOSTLY(draw_byte() & 1 ? draw_in(0, 9) : draw_log(1e-6, 1e6)),
                  ratio = MOSTLY(draw_log(1e-3, 1e3));
    const vm_real trig = vm_osc_omega_trig(alpha), m = vm_osc_jacobi_parameter(alpha), jacobi = vm_osc_omega_jacobi(alpha);
    const vm_real r = MOSTLY(draw_in(0, 1)), law = vm_osc_amplitude_law(ratio, draw_in(-1, 1), r, alpha);
    const vm_real v_law = vm_osc_velocity_law(ratio, draw_in(-1, 1), r, alpha);
    const vm_osc_errors c = vm_osc_approximation_errors(alpha);
    if (!(alpha >= 0) || !is_finite(alpha)) {
        HOLDS(is_nan(trig) && is_nan(m) && is_nan(jacobi) && is_nan(law) && is_nan(c.trig_vmax) &&
              is_nan(c.jacobi_x) && is_nan(v_law));
        return;
    }
    if (alpha > R(1e6)) return;
    HOLDS(trig > 0 && jacobi > 0 && m > R(-1.8080) && m < R(0.8063));
    /* Rising, but for roundings: 4 ulp of each m, and an ulp of ateb_pi, which changes m by up to 7 ulp */
    HOLDS(vm_osc_jacobi_parameter(neighbour(alpha, 1)) >= m - 32 * VM_EPSILON);
    HOLDS(c.trig_vmax > 0 && c.jacobi_vmax > 0 && c.trig_x >= 0 && c.jacobi_x >= 0 && c.trig_v >= 0 &&
          c.jacobi_v >= 0);
    if (ratio > R(1e-4) && ratio < R(1e4) && r >= 0 && r <= 1) {
        HOLDS(law > 0 && v_law > 0 && is_finite(law) && is_finite(v_law));
        HOLDS(within(vm_osc_amplitude_law(1, 0, r, alpha), 1, 4 * EPS) &&
              vm_osc_amplitude_law(ratio, 1, r, alpha) <=
                  vm_osc_amplitude_law(ratio, 0, r, alpha) * (1 + 8 * VM_EPSILON));
    }
    if (!(ratio > 0)) HOLDS(is_nan(law) || ratio == 0);
}

enum { TABLE = 5 };
typedef struct table_of {
    vm_real time[TABLE], value[TABLE];
} table_of;

static int wave(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const vm_real *p = (const vm_real *)ctx;
    *f = p[0] + p[1] * VM_LIBM(sin)(t);
    *rate = p[1] * VM_LIBM(cos)(t);
    return p[2] > R(0.97);
}

static vm_law draw_law(table_of *table, vm_real *ctx)
{
    const vm_real f0 = MOSTLY(draw_log(0.1, 10)), f1 = MOSTLY(draw_in(-0.1, 0.1)),
                  f2 = MOSTLY(draw_in(-0.01, 0.01));
    vm_law law;
    int i;
    switch (draw_below(7)) {
    case 0: return vm_law_linear(f0, f1);
    case 1: return vm_law_quadratic(f0, f1, f2);
    case 2: return vm_law_exponential(f0, f1);
    case 3: return vm_law_power(f0, f1, draw_in(-3, 3));
    case 4:
        for (i = 0; i < TABLE; i++) {
            table->time[i] = R(4 * i) + (draw_byte() % 16 ? 0 : draw_in(-8, 8));
            table->value[i] = draw_byte() % 16 ? draw_in(0.5, 2) : 0;
        }
        return vm_law_table(draw_byte() % 8 ? TABLE : draw_below(TABLE), table->time, table->value);
    case 5:
        ctx[0] = draw_log(0.5, 5);
        ctx[1] = draw_in(-0.3, 0.3);
        ctx[2] = draw_in(0, 1);
        law = vm_law_user(wave, ctx);
        if (ctx[1] > R(0.2)) law.change_time = MOSTLY(draw_log(0.1, 10));
        return law;
    default: return vm_law_linear(f0, 0);
    }
}

/* Is the law so smooth at t that its rate is a difference of its values? */
static int has_smooth_rate(const vm_law *law, vm_real t)
{
    return !law->time && law->derivatives != vmi_law_power_derivatives && tame(law->f0) && tame(law->f1) &&
           VM_FABS(law->f1) < R(0.2) && tame(law->f2) && VM_FABS(law->f2) < R(0.5) && tame(t) && VM_FABS(t) < 30;
}

/* A body takes a law for that of its mass only where it is positive */
static void check_mass(const vm_law *law, vm_real t, vm_real f)
{
    const vm_real y[4] = {0, 1, 0, 1};
    vm_real dydt[4];
    vm_pair pair;
    pair.alpha = 3;
    pair.k = 1;
    pair.reactive = 1;
    pair.mass = *law;
    HOLDS(vm_pair_rhs(t, y, dydt, &pair) == (f > 0 ? VM_OK : VM_BAD_MASS));
}

static void check_laws(void)
{
    const vm_real h = R(IS_FLOAT ? 0.01 : 1e-5);
    table_of table;
    vm_real ctx[3], f, rate, integral, f_next, rate_next;
    const vm_law law = draw_law(&table, ctx);
    const vm_real t = MOSTLY(draw_in(-1, 20));
    int status;
    STAIN(f);
    STAIN(rate);
    STAIN(integral);
    status = vm_law_at(&law, t, &f, &rate);
    if (status) HOLDS(status < 0 && UNTOUCHED(f) && UNTOUCHED(rate));
    else {
        HOLDS(is_finite(f) && is_finite(rate));
        check_mass(&law, t, f);
        if (has_smooth_rate(&law, t) && vm_law_at(&law, t + h, &f_next, &rate_next) == 0)
            HOLDS(within((f_next - f) / h, rate, (IS_FLOAT ? 0.02 : 1e-4) * (1 + fabs((double)f))));
    }
    status = vm_law_inverse_integral(&law, t, &integral);
    if (status) HOLDS(status < 0 && UNTOUCHED(integral));
    else HOLDS(is_finite(integral) && (t >= 0 ? integral : -integral) >= 0);
}

static vm_real small_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    return *(const vm_real *)ctx * v * (1 - x * x);
}

static vm_osc_problem draw_problem(table_of *tables, vm_real (*ctx)[3])
{
    vm_osc_problem p;
    memset(&p, 0, sizeof p);
    p.alpha = MOSTLY(draw_byte() & 1 ? R(draw_below(8)) : draw_in(0, 8));
    if (p.alpha > 20 && is_finite(p.alpha)) p.alpha = 20; /* runs of minutes */
    p.mass = draw_law(tables, ctx[0]);
    p.stiffness = draw_law(tables + 1, ctx[1]);
    p.reactive = draw_in(0, 1);
    p.damping = draw_in(-0.02, 0.05);
    p.x = MOSTLY(draw_in(-1.5, 1.5));
    p.v = MOSTLY(draw_in(-1.5, 1.5));
    if (draw_byte() % 4 == 0) {
        ctx[2][0] = draw_in(-0.02, 0.02);
        p.force = small_force;
        p.ctx = ctx[2];
    }
    return p;
}

static int tame_law(const vm_law *law)
{
    return tame(law->f0) && tame(law->f1) && tame(law->f2) && VM_FABS(law->f1) < 1 && VM_FABS(law->f2) < 4;
}

static int route_is_law(int route) { return route < VM_ROUTE_COLLOCATION; }

static int tame_problem(const vm_osc_problem *p)
{
    return tame_law(&p->mass) && tame_law(&p->stiffness) && tame(p->x) && tame(p->v) && VM_FABS(p->x) < 4 &&
           VM_FABS(p->v) < 4;
}

/* Does the law change so fast that a motion until t takes more than ten thousand steps? A step is at most change_time long,
   and change_time may be as small as |t|/2^20. */
static int changes_fast(const vm_law *law, vm_real t)
{
    return law->change_time > 0 && VM_FABS(t) > R(1e4) * law->change_time;
}

/* The integrators give up after 2^23 periods of 2^13 steps each, which takes hours. Here a run has thousands of
   periods at most. */
static int takes_long(const vm_osc_plan *plan, vm_real t)
{
    const vm_osc_problem *p = &plan->problem;
    vmi_osc_rates at_end;
    if (changes_fast(&p->mass, t) || changes_fast(&p->stiffness, t)) return 1;
    if (p->force && VM_FABS(t) > 100 * plan->m0) return 1; /* small_force is not small for so small a mass */
    /* a motion that grows by more than e^30: where the mass falls nearly to 0, the damping becomes large at t only */
    if (vmi_osc_rates_at(p, t, -vmi_time_side(t), &at_end) == 0 && VM_FABS(at_end.p * t) > 30) return 1;
    return is_finite(t) && (!tame_problem(p) || VM_FABS(t) > 100 || plan->Om * VM_FABS(t) > R(1e4) ||
                            VM_FABS(plan->slow.p * t) > 3); /* it dies out, for alpha < 1 in ever shorter periods */
}

/* The motion by the function of the route's own name. Those of the laws take no tolerance, which matters where
   there is a force, since then they integrate. */
static int by_name(const vm_osc_problem *p, int route, vm_real t, vm_real tolerance, vm_osc_motion *m)
{
    switch (route) {
    case VM_ROUTE_TRIG: return vm_osc_by_route(p, VM_ROUTE_TRIG, t, 0, m);
    case VM_ROUTE_JACOBI: return vm_osc_by_route(p, VM_ROUTE_JACOBI, t, 0, m);
    case VM_ROUTE_ATEB: return vm_osc_by_route(p, VM_ROUTE_ATEB, t, 0, m);
    case VM_ROUTE_ORDER2: return vm_osc_by_route(p, VM_ROUTE_ORDER2, t, 0, m);
    case VM_ROUTE_ORDER3: return vm_osc_by_route(p, VM_ROUTE_ORDER3, t, 0, m);
    case VM_ROUTE_ORDER4: return vm_osc_by_route(p, VM_ROUTE_ORDER4, t, 0, m);
    case VM_ROUTE_ORDER5: return vm_osc_by_route(p, VM_ROUTE_ORDER5, t, 0, m);
    case VM_ROUTE_COLLOCATION: return vm_osc_by_route(p, VM_ROUTE_COLLOCATION, t, tolerance, m);
    case VM_ROUTE_RK45: return vm_osc_by_route(p, VM_ROUTE_RK45, t, tolerance, m);
    case VM_ROUTE_RK87: return vm_osc_by_route(p, VM_ROUTE_RK87, t, tolerance, m);
    default: return vm_osc_by_route(p, route, t, tolerance, m);
    }
}

/* Where the error of a law is estimated as more than a quarter of the amplitude, the mass is not slow: the terms of the law may
   be of any size, and so may be what they make of roundings. The law of order two, which a plan starts by order five, may then
   even overflow. */
static int law_fails(const vm_osc_motion *m) { return route_is_law(m->route) && !(m->error < R(0.25)); }

/* For alpha < 1 the force is not smooth at x = 0. The last bit of a plan may then change the steps of an integrator, so that two
   motions agree to their errors only. */
static int steps_may_move(const vm_osc_plan *plan, int route) { return !route_is_law(route) && plan->problem.alpha < 1; }

/* How far a motion by a plan may be from one by a call. A plan's Ateb functions err by 2 ulp and those without a plan by 3;
   all else is the same work, but the law of order two, which the plan starts by order five. The rate of the phase goes as
   the power (alpha-1)/2 of the amplitude, so that a difference at the start grows with the phase; and each step of an
   integration, of ten evaluations at least, adds a rounding. Amplitude and phase are found from x and v + p x, which makes
   differences larger where mass or stiffness change faster than the phase, by the factor p/W. */
static double plan_may_differ(const vm_osc_plan *plan, vm_real t, const vm_osc_motion *by_plan, const vm_osc_motion *by_call)
{
    const double amplitude = (double)by_call->amplitude, phase = (double)(plan->Om * VM_FABS(t));
    const double by_p = 1 + fabs((double)(plan->slow.p / plan->Om));
    if (by_plan->route == by_call->route && by_call->route != VM_ROUTE_ORDER2 && !steps_may_move(plan, by_call->route))
        return EPS * amplitude * by_p *
               (8 * (1 + (double)plan->problem.alpha) * (1 + phase) + (double)by_call->evals / 10);
    return 3 * ((double)by_plan->error + (double)by_call->error) * amplitude;
}

/* The integral of f/g: of 1/g by the other function, of g/g, and its sign; nothing is written where it is refused. */
static void check_ratio_integral(void)
{
    table_of tables[2];
    vm_real ctx[2][3], ratio, inverse;
    const vm_law f = draw_law(tables, ctx[0]), g = draw_law(tables + 1, ctx[1]), one = vm_law_linear(1, 0);
    const vm_real t = MOSTLY(draw_in(-1, 20));
    int status;
    STAIN(ratio);
    status = vm_law_ratio_integral(&f, &g, t, &ratio);
    if (status) HOLDS(status < 0 && UNTOUCHED(ratio));
    else HOLDS(is_finite(ratio));
    status = vm_law_inverse_integral(&g, t, &inverse);
    if (status || !tame_law(&g) || !tame(t)) return;
    if (g.function && VM_FABS(t) > 100) return; /* the panels may step over the waves: they are longer than |t|/3000 */
    HOLDS(vm_law_ratio_integral(&one, &g, t, &ratio) == 0 &&
          within(ratio, inverse, (IS_FLOAT ? 1e-4 : 1e-12) * fabs((double)inverse)));
    if (vm_law_ratio_integral(&g, &g, t, &ratio) == 0)
        HOLDS(within(ratio, t, (IS_FLOAT ? 1e-4 : 1e-12) * fabs((double)t)));
}

/* The force of a load is the sum of its terms, is linear in the velocity, and keeps the force that was there. */
static void check_load(void)
{
    table_of tables[4];
    vm_real ctx[3][3], law_ctx[2][3], b, rate, at_0, at_v;
    vm_osc_problem p = draw_problem(tables, ctx), before = p;
    const vm_law u = draw_law(tables + 2, law_ctx[0]), damping = draw_law(tables + 3, law_ctx[1]);
    const vm_real t = MOSTLY(draw_in(-1, 5)), x = MOSTLY(draw_in(-1, 1)), v = MOSTLY(draw_in(-1, 1));
    vm_osc_load load;
    int status;
    STAIN(load);
    status = vm_osc_load_init(&load, &p, draw_byte() & 1 ? &u : NULL, &damping);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(load) && p.force == before.force && p.ctx == before.ctx);
        return;
    }
    HOLDS(p.force == vm_osc_load_force && p.ctx == &load && load.force == before.force);
    at_0 = p.force(t, x, 0, p.ctx);
    at_v = p.force(t, x, v, p.ctx);
    if (vm_law_at(&damping, t, &b, &rate)) HOLDS(is_nan(at_v));
    else if (tame(b) && tame(v) && tame(x) && tame(t) && !is_nan(at_0) && is_finite(at_0) && !before.force)
        HOLDS(within(at_v, at_0 - b * v, 8 * EPS * (fabs((double)at_0) + fabs((double)(b * v)))));
}

static void check_routes(void)
{
    table_of tables[2];
    vm_real ctx[3][3];
    const vm_osc_problem p = draw_problem(tables, ctx);
    const vm_real t = MOSTLY(draw_in(-1, 5)), tolerance = draw_byte() & 1 ? 0 : draw_log(1e-5, 1e-1);
    const int route = draw_below(VM_ROUTE_RK87 + 3) - 1;
    vm_osc_motion m, n;
    vm_osc_plan plan;
    int status, planned, by;
    /* In an unusual run of an integrator a plan may move the steps. */
    const int same_work = !fuzz.wild || (route_is_law(route) && tame_law(&p.mass) && tame_law(&p.stiffness) &&
                                         !p.force && VM_FABS(t) <= 30);
    STAIN(plan);
    STAIN(m);
    planned = vm_osc_plan_init(&plan, &p);
    if (planned) HOLDS(planned < 0 && UNTOUCHED(plan));
    else if (takes_long(&plan, t)) return;
    status = vm_osc_by_route(&p, route, t, tolerance, &m);
    if (route < 0 || route > VM_ROUTE_RK87) HOLDS(status < 0);
    if (status < 0) HOLDS(UNTOUCHED(m));
    else {
        HOLDS(planned == 0 && route >= 0 && route <= VM_ROUTE_RK87 && is_finite(m.x) && is_finite(m.v) &&
              m.route == route);
        HOLDS((m.error >= 0 || !tame(p.x) || !tame(p.v)) && m.evals >= 0 &&
              strcmp(vm_osc_route_name(route), vm_osc_route_name(99)) != 0);
    }
    by = by_name(&p, route, t, tolerance, &n);
    if (tolerance == 0 || !route_is_law(route) || !p.force) { /* then both calls do the same */
        HOLDS(by == status);
        if (status >= 0) HOLDS(same_bits(n.x, m.x) && same_bits(n.v, m.v) && same_bits(n.error, m.error));
    }
    STAIN(n);
    if (planned == 0 && !(status >= 0 && law_fails(&m))) {
        by = vm_osc_plan_by_route(&plan, route, t, tolerance, &n);
        HOLDS((by == status || (by >= 0 && status >= 0 && steps_may_move(&plan, route))) && (by >= 0 || UNTOUCHED(n)));
        if (by >= 0 && same_work) HOLDS(within(n.x, m.x, plan_may_differ(&plan, t, &n, &m)));
    }
}

static void check_at(void)
{
    table_of tables[2];
    vm_real ctx[3][3];
    const vm_osc_problem p = draw_problem(tables, ctx);
    const vm_real t = draw_in(0, 5), tolerance = draw_byte() & 1 ? 0 : draw_log(1e-4, 1e-1);
    vm_osc_motion m, n;
    vm_osc_plan plan;
    int status, method, planned;
    vm_real rates[3];
    planned = vm_osc_plan_init(&plan, &p);
    if (planned == 0 && takes_long(&plan, t)) return;
    STAIN(m);
    status = vm_osc_within(&p, t, tolerance, &m);
    if (status < 0) HOLDS(UNTOUCHED(m));
    else HOLDS(is_finite(m.x) && is_finite(m.v) && m.route >= 0 && m.route <= VM_ROUTE_RK87);
    if (planned) return;
    planned = vm_osc_plan_within(&plan, t, tolerance, &n);
    HOLDS(planned == status || (planned >= 0 && status >= 0 && steps_may_move(&plan, m.route)));
    if (status >= 0 && route_is_law(m.route) && tame_law(&p.mass) && tame_law(&p.stiffness))
        HOLDS(within(n.x, m.x, plan_may_differ(&plan, t, &n, &m)));
    method = draw_below(8) - 1;
    STAIN(rates);
    status = vm_osc_averaged(&plan, method, t, MOSTLY(draw_in(0.1, 2)), rates, rates + 1, rates + 2);
    if (status < 0) HOLDS(UNTOUCHED(rates));
    else HOLDS(is_finite(rates[0]) && is_finite(rates[1]) && is_finite(rates[2]));
}

static void check_closed_law(void)
{
    table_of tables[2];
    vm_real ctx[3][3];
    const vm_osc_problem p = draw_problem(tables, ctx);
    const vm_real t = MOSTLY(draw_in(-5, 5)), t_end = MOSTLY(draw_in(-5, 5));
    const int order = 1 + draw_below(6);
    vm_osc_closed c, copy;
    vm_osc_plan plan;
    vm_osc_motion m;
    vm_real motion[2], again[2];
    int status;
    memset(&c, 0, sizeof c); /* order 2 leaves fields out */
    STAIN(c);
    status = vm_osc_closed_init(&c, &p, order, t_end);
    HOLDS(status <= 0 && (status == 0 || UNTOUCHED(c)));
    if (status) return;
    HOLDS(order >= 2 && order <= 5 && c.error >= 0);
    STAIN(motion);
    status = vm_osc_closed_at(&c, t, motion, motion + 1);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(motion));
        return;
    }
    HOLDS(is_finite(motion[0]) && is_finite(motion[1]));
    memcpy(&copy, &c, sizeof c); /* it is plain data */
    HOLDS(vm_osc_closed_at(&copy, t, again, again + 1) == 0 && same_bits(again[0], motion[0]) &&
          same_bits(again[1], motion[1]));
    if (order == 5 && vm_osc_plan_init(&plan, &p) == 0 && vm_osc_plan_by_route(&plan, VM_ROUTE_ORDER5, t, 0, &m) == 0)
        HOLDS(same_bits(m.x, motion[0]) && same_bits(m.v, motion[1]));
    status = order == 2 ? vm_osc_closed_at_order2(&c, t, again, again + 1) : vm_osc_closed_at_order3(&c, t, again, again + 1);
    if (order <= 3) HOLDS(status == 0 && same_bits(again[0], motion[0]) && same_bits(again[1], motion[1]));
}

static void fuzz_oscillators(void)
{
    switch (draw_below(7)) {
    case 6: check_closed_law(); break;
    case 0: check_constants(); break;
    case 1:
        check_laws();
        check_ratio_integral();
        check_load();
        break;
    case 2: check_routes(); break;
    case 3: check_at(); break;
    default: check_exact();
    }
}
FUZZ_TARGET(oscillators)
