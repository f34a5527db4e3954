/* Instructions of a call: every function count_X below makes CALLS calls with the same arguments in every run, for
   callgrind to count (bench/count.sh). The loop itself is count_nothing. Arguments: u, s in (-3, 3), p in (0, 1),
   m = 1.9 p - 0.95, alpha in (0.5, 3.5), a and b in (0.5, 3.5). */
#include <math.h>
#include <stdio.h>
#include "../varmass.h"

enum { CALLS = 200 };
static vm_real u[CALLS], p[CALLS], m[CALLS], alpha[CALLS], other[CALLS];
static volatile vm_real sink;

#ifdef __GNUC__
#define SEPARATE __attribute__((noinline))
#else
#define SEPARATE
#endif

#define COUNT(name, ...)                    \
    SEPARATE static void count_##name(void) \
    {                                       \
        vm_real a = 0, b = 0, c = 0;        \
        int i;                              \
        for (i = 0; i < CALLS; i++) {       \
            __VA_ARGS__;                    \
            sink = a;                       \
            sink = b;                       \
            sink = c;                       \
        }                                   \
    }

COUNT(nothing, (void)a)

/* sin of the C library, the yardstick of docs/cost.md; sinf in float */
COUNT(sin, a = sizeof a < sizeof(double) ? (vm_real)sinf((float)u[i]) : (vm_real)sin((double)u[i]))

/* ---- jacobi.h ---- */

static jacobi_plan m_plan;
COUNT(jacobi_K, a = jacobi_K(m[i]))
COUNT(jacobi_E, a = jacobi_E(m[i]))
COUNT(jacobi_sncndn, jacobi_sncndn(u[i], m[i], &a, &b, &c))
COUNT(jacobi_sn, a = jacobi_sn(u[i], m[i]))
COUNT(jacobi_cd, a = jacobi_cd(u[i], m[i]))
COUNT(jacobi_am, a = jacobi_am(u[i], m[i]))
COUNT(jacobi_plan_init, jacobi_plan_init(&m_plan, m[i]); a = m_plan.m1)
COUNT(jacobi_plan_sncndn, jacobi_plan_sncndn(&m_plan, u[i], &a, &b, &c))
COUNT(jacobi_kpK, a = jacobi_kpK(m[i]))
COUNT(jacobi_solve_kpK, a = jacobi_solve_kpK(3 * p[i]))
COUNT(jacobi_solve_K, a = jacobi_solve_K(3 * p[i]))
COUNT(jacobi_cn_means, jacobi_cn_means(m[i], &a, &b, &c))
COUNT(jacobi_agm_sncndn, jacobi_agm_sncndn(u[i], m[i], 4, &a, &b, &c))
COUNT(jacobi_agm_K, a = jacobi_agm_K(m[i]))

SEPARATE static void count_jacobi_plan_sncndn_array(void)
{
    static vm_real sn[CALLS], cn[CALLS], dn[CALLS];
    jacobi_plan_sncndn_array(&m_plan, CALLS, u, sn, cn, dn);
    sink = sn[0] + cn[0] + dn[0];
}

/* ---- ateb.h ---- */

static ateb_plan alpha_plan, rough_plan, power_plan;
COUNT(ateb_pi, a = ateb_pi(alpha[i]))
COUNT(ateb_saca, ateb_saca(u[i], alpha[i], &a, &b))
COUNT(ateb_sa, a = ateb_sa(u[i], alpha[i]))
COUNT(ateb_phase, a = ateb_phase(u[i], m[i], alpha[i]))
COUNT(ateb_integral_sa2, a = ateb_integral_sa2(u[i], alpha[i]))
COUNT(ateb_mean, a = ateb_mean(alpha[i], other[i], 1))
COUNT(ateb_mean_nm, a = ateb_mean_nm(alpha[i], other[i], 2, 1, 0))
COUNT(ateb_pi_nm, a = ateb_pi_nm(alpha[i], other[i]))
COUNT(ateb_saca_nm, ateb_saca_nm(u[i], alpha[i], other[i], &a, &b))
COUNT(ateb_beta, a = ateb_beta(alpha[i], other[i]))
COUNT(ateb_ln_beta, a = ateb_ln_beta(alpha[i], other[i]))
COUNT(ateb_ln_beta_inc, a = ateb_ln_beta_inc(p[i], alpha[i], other[i]))
COUNT(ateb_beta_inc, a = ateb_beta_inc(p[i], alpha[i], other[i]))
COUNT(ateb_beta_inc_inv, a = ateb_beta_inc_inv(p[i], alpha[i], other[i]))
COUNT(ateb_plan_init, ateb_plan_init(&alpha_plan, alpha[i]); a = alpha_plan.g)
COUNT(ateb_plan_saca_3, ateb_plan_saca(&alpha_plan, u[i], &a, &b))
COUNT(ateb_plan_saca_3_to_1e_4, ateb_plan_saca(&rough_plan, u[i], &a, &b))
COUNT(ateb_plan_saca_4_3, ateb_plan_saca(&power_plan, u[i], &a, &b))

/* ---- integrators.h: a step of x'' = -x^3 ---- */

static int cubic(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

static vm_real y_rk4[2] = {1, 0}, y_start[2] = {1, 0}, work[RK87_WORK(2)];
COUNT(rk4_step, rk4_step(cubic, NULL, 2, 0, VM_C(0.01), y_rk4, work); a = y_rk4[0])

static rk45 pair5, pair8;
static vm_real work5[RK45_WORK(2)], work8[RK87_WORK(2)];
COUNT(rk45_step, rk45_step(&pair5); a = pair5.t)
COUNT(rk87_step, rk87_step(&pair8); a = pair8.t)

/* ---- varmass.h ---- */

COUNT(vm_lambert_w0, a = vm_lambert_w0(p[i] * 5))
COUNT(vm_lambert_wm1, a = vm_lambert_wm1(p[i] * VM_C(-0.36)))

static const vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
static const vm_body piece = {
    1, {VM_C(0.1), VM_C(0.1), VM_C(0.1), 0, 0, 0}, {1, 0, 0, 0}, {VM_C(0.4), 0, 0}, {10, 2, 0}, {0, 0, 3}};
static vm_body rest;
static vm_body2 whole2, piece2, rest2;
static vm_torque_free motion;
COUNT(vm_separate, vm_separate(&whole, &piece, NULL, &rest); a = rest.v.x)
COUNT(vm_attach, vm_attach(&whole, &piece, NULL, &rest); a = rest.v.x)
COUNT(vm_separate2, vm_separate2(&whole2, &piece2, NULL, &rest2); a = rest2.vx)
COUNT(vm_torque_free_init, vm_torque_free_init(&motion, &whole, 0))
COUNT(vm_torque_free_at, vm_torque_free_at(&motion, 100 * p[i], &rest); a = rest.omega.x)

static vm_osc_problem problem;
static vm_osc_plan oscillator;
static vm_osc_motion now;
static vm_osc_closed closed; /* the law of order five for alpha = 4/3 */
COUNT(vm_osc_exact, vm_osc_exact(10 * p[i], 1, 1, alpha[i], &a, &b))
COUNT(vm_osc_period, a = vm_osc_period(1, 1, alpha[i]))
COUNT(vm_osc_amplitude_law, a = vm_osc_amplitude_law(1 + p[i], 0, 1, alpha[i]))
COUNT(vm_osc_at_to_1e_3, vm_osc_within(&problem, 10 + 300 * p[i], VM_C(1e-3), &now); a = now.x)
COUNT(vm_osc_plan_init, vm_osc_plan_init(&oscillator, &problem))
COUNT(vm_osc_plan_at_to_1e_3, vm_osc_plan_within(&oscillator, 10 + 300 * p[i], VM_C(1e-3), &now); a = now.x)
COUNT(vm_osc_closed_at_4_3, vm_osc_closed_at(&closed, 10 + 300 * p[i], &a, &b))

static vm_odd_problem duffing;
static vm_odd_plan duffing_plan;
static vm_odd_motion duffing_now;
COUNT(vm_duffing_exact_from, vm_duffing_exact_from(10 * p[i], 1, 0, 1, p[i], &a, &b))
COUNT(vm_odd_plan_init, vm_odd_plan_init(&duffing_plan, &duffing, 300); a = duffing_plan.reach)
COUNT(vm_odd_plan_mean, vm_odd_plan_by_route(&duffing_plan, VM_ODD_MEAN, 300 * p[i], 0, &duffing_now); a = duffing_now.x)
COUNT(vm_odd_plan_ripple, vm_odd_plan_by_route(&duffing_plan, VM_ODD_ORDER2, 300 * p[i], 0, &duffing_now);
      a = duffing_now.x)

static vm_vdp self_excited[2]; /* constant mass, a mass that grows */
static vm_vdp_plan vdp_plans[2];
COUNT(vm_vdp_plan_init, vm_vdp_plan_init(vdp_plans, self_excited, VM_C(0.5), 0); a = vdp_plans[0].start.psi)
COUNT(vm_vdp_order3_constant, vm_vdp_plan_by_route(vdp_plans, VM_ROUTE_ORDER3, 10 + 300 * p[i], 0, &now); a = now.x)
COUNT(vm_vdp_order3_growing, vm_vdp_plan_by_route(vdp_plans + 1, VM_ROUTE_ORDER3, 10 + 300 * p[i], 0, &now); a = now.x)

static vm_periodic periodic, sampled;
static vm_steady_state steady[4];
COUNT(vm_periodic_from_200_samples, vm_periodic_from_samples(&sampled, CALLS, u); a = sampled.cosine[1])
COUNT(vm_periodic_steady_states, a = (vm_real)vm_periodic_steady_states(&periodic, 0, 4, steady))

static vm_stream stream;
static vm_flow flow;
static vm_real y_flow[VM_FLOW_STATES], dy_flow[VM_FLOW_STATES];
COUNT(vm_flow_rhs_1_stream, vm_flow_rhs(0, y_flow, dy_flow, &flow); a = dy_flow[0])

static vm_scene_body body[1];
static vm_effect effect[3];
static vm_scene scene;
static vm_real y_scene[2], dy_scene[2];
COUNT(vm_scene_rhs_no_effect, scene.n_effects = 0; vm_scene_rhs(0, y_scene, dy_scene, &scene); a = dy_scene[1])
COUNT(vm_scene_rhs_3_effects, scene.n_effects = 3; vm_scene_rhs(0, y_scene, dy_scene, &scene); a = dy_scene[1])

/* ---- */

static void set_up(void)
{
    static const vm_scene no_scene;
    unsigned long state = 1;
    int i;
    for (i = 0; i < CALLS; i++) {
        state = (state * 1664525ul + 1013904223ul) & 0xfffffffful;
        p[i] = ((vm_real)(state >> 8) + VM_C(0.5)) / 16777216;
        u[i] = 6 * p[i] - 3;
        m[i] = VM_C(1.9) * p[i] - VM_C(0.95);
        state = (state * 1664525ul + 1013904223ul) & 0xfffffffful;
        alpha[i] = VM_C(0.5) + 3 * ((vm_real)(state >> 8) / 16777216);
        other[i] = 4 - alpha[i];
        if (i % 2) m[i] = -m[i];
    }
    rk45_init(&pair5, cubic, NULL, 2, 0, y_start, NULL, work5);
    rk87_init(&pair8, cubic, NULL, 2, 0, y_start, NULL, work8);
    whole2.mass = 5;
    whole2.inertia = 2;
    whole2.vx = 10;
    whole2.omega = 3;
    piece2.mass = 1;
    piece2.inertia = VM_C(0.1);
    piece2.x = VM_C(0.4);
    piece2.vx = 10;
    piece2.vy = 2;
    problem.alpha = VM_C(4.0) / 3;
    problem.mass = vm_law_linear(1, VM_C(0.01));
    problem.stiffness = vm_law_linear(1, 0);
    problem.reactive = 1;
    problem.x = 1;
    vm_osc_closed_init(&closed, &problem, 5, 400);
    problem.alpha = 3;
    duffing.force = vm_duffing_force(1, VM_C(0.5));
    duffing.mass = vm_law_linear(1, VM_C(0.002));
    duffing.stiffness = vm_law_linear(1, 0);
    duffing.damping = vm_law_linear(VM_C(0.005), 0);
    duffing.reactive = 1;
    duffing.x = VM_C(1.5);
    duffing.v = 0;
    for (i = 0; i < 2; i++) {
        self_excited[i].alpha = 1;
        self_excited[i].k = 1;
        self_excited[i].feed = VM_C(0.01);
        self_excited[i].c = VM_C(0.01);
        self_excited[i].reactive = 1;
        self_excited[i].mass = vm_law_linear(1, i ? VM_C(0.002) : 0);
        vm_vdp_plan_init(vdp_plans + i, self_excited + i, VM_C(0.5), 0);
    }
    periodic.oscillator.alpha = 3;
    periodic.oscillator.damping = VM_C(0.002);
    periodic.oscillator.reactive = 1;
    periodic.oscillator.mass = vm_law_linear(1, 0);
    periodic.oscillator.stiffness = vm_law_linear(1, 0);
    periodic.oscillator.frequency = vm_law_linear(VM_C(0.85), 0);
    periodic.oscillator.force = vm_law_linear(VM_C(0.01), 0);
    periodic.cosine[1] = 1;
    periodic.sine[3] = VM_C(0.5);
    periodic.vibrations = 1;
    periodic.periods = 1;
    vm_periodic_init(&periodic);
    flow.streams = &stream;
    flow.n = 1;
    stream.rate = 1;
    stream.velocity.x = 1;
    vm_flow_start(&flow, &whole, y_flow);
    body[0] = vm_scene_body_line(1, VM_C(0.3), VM_C(0.1));
    effect[0] = vm_effect_spring(0, 0, VM_GROUND, 0, 2, 3, 0);
    effect[1] = vm_effect_damper(0, 0, VM_GROUND, 0, VM_C(0.1));
    effect[2] = vm_effect_van_der_pol(0, 0, VM_C(0.1), VM_C(0.2));
    scene = no_scene;
    scene.bodies = body;
    scene.n_bodies = 1;
    scene.effects = effect;
    scene.n_effects = 3;
    vm_scene_start(&scene, 0, y_scene, NULL);
}

static void set_plans(void)
{
    jacobi_plan_init(&m_plan, VM_C(0.5));
    ateb_plan_init(&alpha_plan, 3);
    ateb_plan_init_to(&rough_plan, 3, VM_C(1e-4));
    ateb_plan_init(&power_plan, VM_C(4.) / 3);
}

int main(void)
{
    static void (*const counts[])(void) = {count_nothing,
                                           count_sin,
                                           count_jacobi_K,
                                           count_jacobi_E,
                                           count_jacobi_sncndn,
                                           count_jacobi_sn,
                                           count_jacobi_cd,
                                           count_jacobi_am,
                                           count_jacobi_plan_init,
                                           count_jacobi_kpK,
                                           count_jacobi_solve_kpK,
                                           count_jacobi_solve_K,
                                           count_jacobi_cn_means,
                                           count_jacobi_agm_sncndn,
                                           count_jacobi_agm_K,
                                           count_ateb_pi,
                                           count_ateb_saca,
                                           count_ateb_sa,
                                           count_ateb_phase,
                                           count_ateb_integral_sa2,
                                           count_ateb_mean,
                                           count_ateb_mean_nm,
                                           count_ateb_pi_nm,
                                           count_ateb_saca_nm,
                                           count_ateb_beta,
                                           count_ateb_ln_beta,
                                           count_ateb_ln_beta_inc,
                                           count_ateb_beta_inc,
                                           count_ateb_beta_inc_inv,
                                           count_ateb_plan_init,
                                           count_rk4_step,
                                           count_rk45_step,
                                           count_rk87_step,
                                           count_vm_lambert_w0,
                                           count_vm_lambert_wm1,
                                           count_vm_separate,
                                           count_vm_attach,
                                           count_vm_separate2,
                                           count_vm_torque_free_init,
                                           count_vm_torque_free_at,
                                           count_vm_osc_exact,
                                           count_vm_osc_period,
                                           count_vm_osc_amplitude_law,
                                           count_vm_osc_at_to_1e_3,
                                           count_vm_osc_plan_init,
                                           count_vm_osc_plan_at_to_1e_3,
                                           count_vm_osc_closed_at_4_3,
                                           count_vm_duffing_exact_from,
                                           count_vm_odd_plan_init,
                                           count_vm_odd_plan_mean,
                                           count_vm_odd_plan_ripple,
                                           count_vm_vdp_plan_init,
                                           count_vm_vdp_order3_constant,
                                           count_vm_vdp_order3_growing,
                                           count_vm_periodic_from_200_samples,
                                           count_vm_periodic_steady_states,
                                           count_vm_flow_rhs_1_stream,
                                           count_vm_scene_rhs_no_effect,
                                           count_vm_scene_rhs_3_effects};
    static void (*const of_plans[])(void) = {count_jacobi_plan_sncndn, count_jacobi_plan_sncndn_array,
                                             count_ateb_plan_saca_3, count_ateb_plan_saca_3_to_1e_4,
                                             count_ateb_plan_saca_4_3};
    size_t i;
    set_up();
    for (i = 0; i < sizeof counts / sizeof *counts; i++) counts[i]();
    set_plans();
    for (i = 0; i < sizeof of_plans / sizeof *of_plans; i++) of_plans[i]();
    printf("%d calls\n", CALLS);
    return 0;
}
