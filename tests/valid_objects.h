/* valid_objects.h - objects that all functions accept, for tests that spoil one of their numbers or pointers at a
 * time */
#ifndef VALID_OBJECTS_H
#define VALID_OBJECTS_H

#include "../varmass.h"
#include <string.h>

#define R(x) ((vm_real)(x))

static inline vm_body a_body(vm_real mass)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = mass;
    b.inertia.xx = b.inertia.yy = b.inertia.zz = R(0.25) * mass;
    b.q.w = 1;
    b.v.x = 1;
    b.omega.z = 2;
    return b;
}

static inline vm_body2 a_body2(vm_real mass)
{
    const vm_body2 b = {mass, R(0.25) * mass, 0, 0, 0, 1, 0, 2};
    return b;
}

/* ---- Lagrange's equations with a variable mass: two coordinates, one mass ---- */

static inline vm_real kinetic(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)ctx;
    return masses[0] * ((1 + q[0] * q[0]) * rates[0] * rates[0] + rates[1] * rates[1]) / 2;
}

static inline void one_mass(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)q;
    (void)ctx;
    masses[0] = 2 - t;
}

static vm_real lagrange_work[VM_LAGRANGE_RHS_WORK(2, 1)];

static inline vm_lagrange_system system_of_two(void)
{
    const vm_lagrange_system l = {2, 1, one_mass, kinetic, NULL, NULL, NULL, lagrange_work};
    return l;
}

/* ---- Oscillators ---- */

/* x'' = -x, for integrators */
static inline int oscillate(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0];
    return 0;
}

static const vm_power_force cubic = {2, 3};

/* A Van der Pol oscillator whose mass grows, not yet prepared */
static inline vm_vdp a_vdp(void)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = 3;
    v.k = 2;
    v.feed = R(0.1);
    v.c = R(0.2);
    v.reactive = 1;
    v.method = VM_VDP_ATEB;
    v.mass = vm_law_linear(2, R(0.01));
    return v;
}

/* Two bodies whose masses grow, on a cubic spring */
static inline vm_pair a_pair(void)
{
    vm_pair p;
    p.alpha = 3;
    p.k = 2;
    p.reactive = 1;
    p.mass = vm_law_linear(2, R(0.01));
    return p;
}

/* Two bodies of different masses with one connection */
static inline vm_coupled_pair a_coupled_pair(void)
{
    static vm_connection spring; /* not constant: mistakes are made in it */
    vm_coupled_pair p;
    spring.k = 2;
    spring.alpha = 3;
    p.mass[0] = vm_law_linear(2, R(0.01));
    p.mass[1] = vm_law_linear(3, R(0.01));
    p.reactive = 1;
    p.damping = R(0.01);
    p.n = 1;
    p.connections = &spring;
    p.force = NULL;
    p.ctx = NULL;
    p.momentum = 0;
    return p;
}

/* A rotor on a cubic shaft, whose mass grows */
static inline vm_jeffcott a_laval(void)
{
    vm_jeffcott r;
    memset(&r, 0, sizeof r);
    r.mass = vm_law_linear(2, R(0.01));
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = (void *)&cubic;
    r.reactive = 1;
    return r;
}

/* A cubic oscillator that is driven near its resonance, prepared by vm_forced_init */
static inline vm_forced a_forced(void)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = 3;
    f.damping = R(0.1);
    f.reactive = 1;
    f.mass = vm_law_linear(2, R(0.01));
    f.stiffness = vm_law_linear(3, R(0.01));
    f.frequency = vm_law_linear(2, R(0.01));
    f.force = vm_law_linear(R(0.5), 0);
    vm_forced_init(&f);
    return f;
}

/* The same oscillator under a force with two harmonics, prepared by vm_periodic_init */
static inline vm_periodic a_periodic(void)
{
    vm_periodic p;
    memset(&p, 0, sizeof p);
    p.oscillator = a_forced();
    p.cosine[1] = 1;
    p.sine[3] = R(0.5);
    p.vibrations = 1;
    p.periods = 1;
    vm_periodic_init(&p);
    return p;
}

/* Two such oscillators of nearly equal frequencies with a weak coupling, prepared by vm_grounded_pair_init */
static inline vm_grounded_pair a_grounded_pair(void)
{
    vm_grounded_pair p;
    memset(&p, 0, sizeof p);
    p.oscillator[0] = a_forced();
    p.oscillator[1] = a_forced();
    p.spring = R(0.001);
    p.damper = R(0.001);
    p.vibrations[0] = 1;
    p.vibrations[1] = 1;
    vm_grounded_pair_init(&p);
    return p;
}

#endif
