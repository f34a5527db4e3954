/* The same bits everywhere: a fixed program of calls of all headers, each section's results folded into one number.
   Prints 'golden float|double SECTION HASH' lines, which tests/cross.sh compares between targets, compilers and
   flags. Needs neither stdio nor a heap: on bare metal GOLDEN_PUTS writes a line. */
#include "../varmass.h"

#ifdef GOLDEN_PUTS
void GOLDEN_PUTS(const char *line);
#else
#include <stdio.h>
#define GOLDEN_PUTS puts
#endif

static uint32_t hash, random_state;

/* FNV-1a over the bits, most significant byte first, so that byte order does not matter; every NaN is one */
static void fold(vm_real x)
{
    const vmi_bits bits = x == x ? vmi_to_bits(x) : 0;
    int shift;
    for (shift = 8 * (int)sizeof bits - 8; shift >= 0; shift -= 8)
        hash = (hash ^ (uint32_t)((bits >> shift) & 255)) * 16777619u;
}

static vm_real uniform(vm_real low, vm_real high) /* 20 bits: exact but for one rounding */
{
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * ((vm_real)(random_state >> 12) / 1048576);
}

static void begin(void) { hash = 2166136261u, random_state = 1; }

static void end(const char *section)
{
    static const char digits[] = "0123456789abcdef";
    char line[64], *p = line;
    const char *words[2];
    int i;
    words[0] = VM_MANT_DIG > 24 ? "golden double " : "golden float ", words[1] = section;
    for (i = 0; i < 2; i++)
        while (*words[i]) *p++ = *words[i]++;
    *p++ = ' ';
    for (i = 28; i >= 0; i -= 4) *p++ = digits[hash >> i & 15];
    *p = 0;
    GOLDEN_PUTS(line);
}

enum { COUNT = 200 };

static void section_elementary(void)
{
    int i;
    begin();
    for (i = 0; i < COUNT; i++) {
        const vm_real x = uniform(0, 20), y = uniform(-20, 20);
        const vm_two l = vmi_log(x + VM_C(0.001));
        vm_real s, c;
        vmi_sincos(y * 100, &s, &c);
        fold(l.hi), fold(l.lo), fold(vmi_exp(y, 0)), fold(vmi_raised(x, y)), fold(s), fold(c);
    }
    end("elementary");
}

static void section_jacobi(void)
{
    int i;
    begin();
    for (i = 0; i < COUNT; i++) {
        const vm_real m = i % 3 ? uniform(-2, 1) : -uniform(0, 1000), u = uniform(-30, 30);
        vm_real s, c, d;
        jacobi_plan p;
        jacobi_sncndn(u, m, &s, &c, &d);
        fold(s), fold(c), fold(d);
        jacobi_sncndn_m1(u, uniform(0, VM_C(1e-6)), &s, &c, &d);
        fold(s), fold(c), fold(d);
        jacobi_plan_init(&p, m);
        jacobi_plan_sncndn(&p, u, &s, &c, &d);
        fold(s), fold(c), fold(d);
        fold(jacobi_K(m)), fold(jacobi_E(m)), fold(jacobi_am(u, m)), fold(jacobi_solve_kpK(uniform(0, 10)));
        jacobi_cn_means(m, &s, &c, &d);
        fold(s), fold(c), fold(d);
    }
    end("jacobi");
}

static void section_ateb(void)
{
    int i;
    begin();
    for (i = 0; i < COUNT; i++) {
        const vm_real alpha = i % 4 ? uniform(0, 8) : uniform(0, 1000), s = uniform(-100, 100);
        vm_real sa, ca;
        ateb_saca(s, alpha, &sa, &ca);
        fold(sa), fold(ca), fold(ateb_pi(alpha)), fold(ateb_phase(sa, ca, alpha));
        if (i % 20) continue;
        {
            ateb_plan p;
            ateb_plan_init(&p, alpha);
            ateb_plan_saca(&p, s, &sa, &ca);
            fold(sa), fold(ca);
        }
        fold(ateb_beta(alpha + VM_C(0.1), VM_C(0.5)));
        fold(ateb_beta_inc(uniform(0, 1), VM_C(0.5), alpha + VM_C(0.1)));
        fold(ateb_beta_inc_inv(uniform(0, 1), VM_C(0.5), alpha + VM_C(0.1))), fold(ateb_mean(alpha, 2, 1));
    }
    end("ateb");
}

static int duffing(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[1], dydt[1] = -y[0] * y[0] * y[0] - VM_C(0.01) * y[1];
    return 0;
}

static void section_integrators(void)
{
    vm_real y[2] = {1, 0}, work[RK87_WORK(2)], t = 0;
    rk45_options o;
    rk45 s;
    memset(&o, 0, sizeof o);
    begin();
    rk4_solve(duffing, NULL, 2, &t, 10, 200, y, work);
    fold(y[0]), fold(y[1]);
    rk45_init(&s, duffing, NULL, 2, 0, y, &o, work);
    rk45_solve(&s, 20);
    fold(s.y[0]), fold(s.y[1]), fold((vm_real)s.evals);
    rk87_init(&s, duffing, NULL, 2, 0, y, &o, work);
    rk87_solve(&s, 20);
    fold(s.y[0]), fold(s.y[1]), fold((vm_real)s.evals);
    end("integrators");
}

static vm_vec3 vector(vm_real size) /* one after the other: the order in which arguments are evaluated is open */
{
    vm_vec3 a;
    a.x = uniform(-size, size);
    a.y = uniform(-size, size);
    a.z = uniform(-size, size);
    return a;
}

static void section_jumps(void)
{
    int i;
    begin();
    for (i = 0; i < COUNT / 4; i++) {
        vm_body body, part, rest;
        memset(&body, 0, sizeof body);
        body.mass = uniform(1, 5);
        body.inertia.xx = uniform(3, 4), body.inertia.yy = uniform(3, 4), body.inertia.zz = uniform(3, 4);
        body.inertia.xy = uniform(-1, 1), body.inertia.yz = uniform(-1, 1);
        body.q.w = 1, body.q.x = uniform(-1, 1), body.q.y = uniform(-1, 1);
        body.r = vector(1), body.v = vector(3), body.omega = vector(2);
        part = body;
        part.mass = VM_C(0.25), part.r.x += VM_C(0.25), part.v = vector(3);
        part.inertia = vmi_inertia_plus(part.inertia, -1 + VM_C(0.0625), part.inertia);
        fold((vm_real)vm_separate(&body, &part, NULL, &rest));
        fold(rest.r.x), fold(rest.v.y), fold(rest.omega.x), fold(rest.omega.y), fold(rest.omega.z);
        fold(vm_kinetic_energy(&rest)), fold(rest.inertia.xx), fold(rest.inertia.xy);
    }
    end("jumps");
}

static void section_oscillators(void)
{
    int i;
    begin();
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real alpha = uniform(0, 6), t = uniform(0, 50), x0 = uniform(-2, 2), omega0 = uniform(0, 3);
        const vm_real ratio = uniform(0, 3), damping = uniform(-1, 1);
        vm_real x, v;
        vm_osc_exact(t, x0, omega0, alpha, &x, &v);
        fold(x), fold(v), fold(vm_osc_omega_trig(alpha)), fold(vm_osc_m_jacobi(alpha));
        fold(vm_osc_amplitude_law(ratio, damping, 1, alpha));
    }
    end("oscillators");
}

static void section_drum(void)
{
    int i;
    begin();
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real x = uniform(VM_C(-0.36), 3), l = uniform(-600, 600);
        fold(vm_lambert_w0(x)), fold(vm_lambert_wm1(x < 0 ? x : -x / 9)), fold(vm_lambert_w0_exp(l));
        fold(vm_lambert_wm1_mexp(-1 - l * l));
    }
    end("drum");
}

/* A body on a line sheds mass, another in the plane is attached to a third; an event switches a drive off */
static void section_scenes(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_vec3 at = {1, 0, 0};
    vm_scene_body bodies[3];
    vm_effect effects[5];
    vm_event events[2];
    ode_event located[2];
    vm_scene scene;
    vm_real y[2 + 6 + 6], work[VM_SCENE_WORK(2 + 6 + 6)], t = 0;
    int i;
    memset(&scene, 0, sizeof scene);
    bodies[0] = vm_scene_line(2, 1, 0);
    bodies[1] = vm_scene_plane(1, VM_C(0.5), zero, 0, at, 1);
    bodies[2] = vm_scene_point(1, at, zero);
    effects[0] = vm_effect_mass(0, VM_MASS_OF_T, VM_C(-0.125), 0, 1);
    effects[1] = vm_effect_spring(0, 0, VM_GROUND, 0, 3, VM_C(1.5), 0);
    effects[2] = vm_effect_drive(0, 0, VM_C(0.25), 0);
    effects[3] = vm_effect_harmonic(1, 1, 1, 2, VM_C(0.5));
    effects[4] = vm_effect_spring(1, 0, 0, 0, 1, 1, 0);
    events[0] = vm_then_switch(vm_event_position(0, 0, 0, -1), 2, 1);
    events[1] = vm_then_attach(vm_event_at(2), 1, 2);
    scene.bodies = bodies, scene.n_bodies = 3, scene.effects = effects, scene.n_effects = 5;
    scene.events = events, scene.located = located, scene.n_events = 2;
    begin();
    fold((vm_real)vm_scene_start(&scene, 0, y, NULL));
    fold((vm_real)vm_scene_run(&scene, &t, 5, y, work, NULL));
    for (i = 0; i < 2 + 6 + 6; i++) fold(y[i]);
    fold(located[0].t);
    end("scenes");
}

#ifndef GOLDEN_SECTION /* only this one, where flash is small: 1, 2, ... */
#define GOLDEN_SECTION 0
#endif
#define RUN(number, section) \
    if (GOLDEN_SECTION == 0 || GOLDEN_SECTION == number) section()

int main(void)
{
    RUN(1, section_elementary);
    RUN(2, section_jacobi);
    RUN(3, section_ateb);
    RUN(4, section_integrators);
    RUN(5, section_jumps);
    RUN(6, section_oscillators);
    RUN(7, section_drum);
    RUN(8, section_scenes);
    return 0;
}
