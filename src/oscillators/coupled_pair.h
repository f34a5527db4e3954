/* oscillators/coupled_pair.h - two bodies of different, variable masses with nonlinear connections

   This file generalizes the pair of bodies (517), (518) of the dissertation. The masses m1(t) and m2(t) have laws of
   their own. Any number of springs and a damper join the bodies, and further forces f1, f2 may act. x and y are the
   positions of the bodies, p is y - x, and S(p) is the sum of k p|p|^(alpha-1) over all springs. The equations are
       m1 x'' =  S(p) + b p' - r m1' x' + f1,   m2 y'' = -S(p) - b p' - r m2' y' + f2
   b is the damping of the connection, r the share of the reactive force that acts. In the relative coordinate p, with
   the reduced mass mu = m1 m2/(m1 + m2) and the velocity V of the mass centre, the two equations become one, exactly
   and for all laws:
       mu p'' + S(p) + (r mu' + b) p' = -r mu (m2'/m2 - m1'/m1) V + mu (f2/m2 - f1/m1)
   It is the equation of one oscillator, so that the methods of oscillators/routes.h can compute p(t).

       vm_connection springs[2] = {{100, 1}, {2000, 3}}; // 100 N/m p + 2000 N/m^3 p^3
       vm_coupled_pair pair;
       pair.mass[0] = vm_law_linear(1, VM_C(0.01)); // mass of the body at x
       pair.mass[1] = vm_law_linear(3, 0);          // mass of the body at y
       pair.reactive = 1;
       pair.damping = 0;
       pair.n = 2;
       pair.connections = springs;
       pair.force = NULL; // then rk45_init(..., vm_coupled_pair_rhs, &pair, ...)

   Tests: tests/test_pair.c. */
#ifndef VARMASS_OSCILLATORS_COUPLED_PAIR_H
#define VARMASS_OSCILLATORS_COUPLED_PAIR_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/words.h"
#include "constant_mass.h"
#include "laws.h"
#include "problem.h"

/* A spring between two bodies, which pulls with the force k p|p|^(alpha-1), N. p is the distance of the bodies minus
   the length of the spring without load. */
typedef struct VM_TAG(vm_connection) {
    vm_real k;     /* stiffness, N/m^alpha, > 0 */
    vm_real alpha; /* exponent, >= 0 */
} vm_connection;

/* A user's function for further forces. The array y contains the positions and velocities (x, y, x', y') of the bodies.
   The function adds the forces on the bodies, N, to force[0] and force[1]. It returns 0 to go on, or any other number
   to end the run. */
typedef int (*vm_pair_force)(vm_real t, const vm_real *y, vm_real *force, void *ctx);

/* Two bodies, the connections between them, and further forces */
typedef struct VM_TAG(vm_coupled_pair) {
    vm_law mass[2];                   /* masses m1 and m2 of the bodies at x and y, kg, > 0 */
    vm_real reactive;                 /* r: 1 where mass that joins or leaves is at rest, 0 where it has the velocity of
                                         its body; numbers between are allowed */
    vm_real damping;                  /* damping b of the connection, kg/s; a positive b takes energy out */
    int n;                            /* number of connections, >= 0 */
    const vm_connection *connections; /* n connections; may be null if n is 0 */
    vm_pair_force force;              /* further forces, or NULL */
    void *ctx;                        /* the user's pointer, last argument of the function `force` */
    vm_real momentum;                 /* momentum m1 x' + m2 y' at t = 0, kg m/s; vm_coupled_pair_oscillator writes
                                         it */
} vm_coupled_pair;

/* Both masses and their rates at one time */
typedef struct VM_TAG(vmi_pair_masses) {
    vm_real m[2], rate[2];
} vmi_pair_masses;

/* Writes the masses and their rates at time t to *now, and checks them and the fields of the pair. */
VM_API int vmi_coupled_now(const vm_coupled_pair *p, vm_real t, vmi_pair_masses *now)
{
    int i, status;
    if (p->n < 0 || (p->n > 0 && !p->connections)) return VM_BAD_ARGUMENT;
    status = vmi_law_at(&p->mass[0], VM_BAD_MASS, t, &now->m[0], &now->rate[0]);
    status = vmi_first_error(status, vmi_law_at(&p->mass[1], VM_BAD_MASS, t, &now->m[1], &now->rate[1]));
    if (!VM_IS_FINITE(p->reactive) || !VM_IS_FINITE(p->damping)) status = vmi_first_error(status, VM_NOT_FINITE);
    for (i = 0; i < p->n; i++) {
        const vm_connection *c = &p->connections[i];
        if (!VM_IS_FINITE(c->k) || !VM_IS_FINITE(c->alpha)) status = vmi_first_error(status, VM_NOT_FINITE);
        if (c->k <= 0) status = vmi_first_error(status, VM_BAD_STIFFNESS);
        if (c->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    }
    return status;
}

/* Equations of motion of two bodies with different masses and several connections, for rk45 or rk87.
   The array y contains the positions (m) and velocities (m/s) of the bodies, (x, y, x', y'). pair points to a
   vm_coupled_pair. Returns VM_BAD_ARGUMENT for null pointers, for a negative number of connections, and for a mass law
   that no constructor made; VM_NOT_FINITE for t or a field that is infinite or NaN (y is not checked); VM_BAD_MASS for
   a mass that is not positive; VM_BAD_STIFFNESS for a stiffness that is not positive; VM_DOMAIN for an exponent < 0 and
   for a t at which a law has no value. If the function `force` returns a number other than 0, returns this number.
   These statuses stop the run. */
VM_API int vm_coupled_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_coupled_pair *p = (const vm_coupled_pair *)pair;
    vmi_pair_masses now;
    vm_real pull = p->damping * (y[3] - y[2]), force[2] = {0, 0};
    int i, status = vmi_coupled_now(p, t, &now);
    if (!status && p->force) status = p->force(t, y, force, p->ctx);
    if (status) return status;
    for (i = 0; i < p->n; i++) pull += p->connections[i].k * vmi_osc_elastic(y[1] - y[0], p->connections[i].alpha);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (pull - p->reactive * now.rate[0] * y[2] + force[0]) / now.m[0];
    dydt[3] = (-pull - p->reactive * now.rate[1] * y[3] + force[1]) / now.m[1];
    return VM_OK;
}

/* Converts a motion y = (x, y, x', y') of two bodies to the modes (p, p', X, V), m and m/s.
   p = y - x is the relative coordinate and X = (m1 x + m2 y)/(m1 + m2) the mass centre. V = (m1 x' + m2 y')/(m1 + m2)
   is the velocity of the mass centre, for the masses at time t. Returns VM_BAD_ARGUMENT for null pointers, otherwise
   the statuses of vm_coupled_pair_rhs; VM_NOT_FINITE also means that a number of y is infinite or NaN. modes and y may
   be the same array. */
VM_API int vm_coupled_pair_to_modes(const vm_coupled_pair *p, vm_real t, const vm_real *y, vm_real *modes)
{
    if (!p || !y || !modes) return VM_BAD_ARGUMENT;
    vmi_pair_masses now;
    vm_real share, found[4];
    int status = vmi_coupled_now(p, t, &now);
    if (status != VM_BAD_ARGUMENT && !vmi_all_finite(4, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    share = now.m[1] / (now.m[0] + now.m[1]);
    found[0] = y[1] - y[0];
    found[1] = y[3] - y[2];
    found[2] = y[0] + share * found[0];
    found[3] = y[2] + share * found[1];
    return vmi_copy_if_finite(4, found, modes);
}

/* Converts the modes (p, p', X, V) of two bodies to the motion y = (x, y, x', y').
   This is the inverse of vm_coupled_pair_to_modes, with its statuses, for `modes` in place of y. y and modes may be the
   same array. */
VM_API int vm_coupled_pair_from_modes(const vm_coupled_pair *p, vm_real t, const vm_real *modes, vm_real *y)
{
    if (!p || !modes || !y) return VM_BAD_ARGUMENT;
    vmi_pair_masses now;
    vm_real first, second, found[4];
    int status = vmi_coupled_now(p, t, &now);
    if (status != VM_BAD_ARGUMENT && !vmi_all_finite(4, modes)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    first = now.m[0] / (now.m[0] + now.m[1]);
    second = now.m[1] / (now.m[0] + now.m[1]);
    found[0] = modes[2] - second * modes[0];
    found[1] = modes[2] + first * modes[0];
    found[2] = modes[3] - second * modes[1];
    found[3] = modes[3] + first * modes[1];
    return vmi_copy_if_finite(4, found, y);
}

/* Writes the reduced mass mu = m1 m2/(m1 + m2) and its rate. The function is a vm_law_function; ctx points to a
   vm_coupled_pair. */
VM_API int vmi_coupled_reduced_mass(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    vmi_pair_masses now;
    vm_real first, second;
    const int status = vmi_coupled_now((const vm_coupled_pair *)ctx, t, &now);
    if (status) return status;
    first = now.m[0] / (now.m[0] + now.m[1]);
    second = now.m[1] / (now.m[0] + now.m[1]);
    *f = now.m[0] * second;
    *rate = now.rate[0] * second * second + now.rate[1] * first * first;
    return VM_OK;
}

/* The force -mu (m2'/m2 - m1'/m1) V on the relative coordinate p if `reactive` is 1; mu is the reduced mass. In this
   case the momentum stays constant, so that the velocity V of the mass centre follows from the masses. The function is
   a vm_osc_force. */
VM_API vm_real vmi_coupled_drift(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_coupled_pair *p = (const vm_coupled_pair *)ctx;
    vmi_pair_masses now;
    vm_real whole;
    (void)x;
    (void)v;
    if (vmi_coupled_now(p, t, &now)) return VM_NAN;
    whole = now.m[0] + now.m[1];
    return vmi_sum_of_products(now.rate[0], now.m[1], -now.rate[1], now.m[0]) / whole * (p->momentum / whole);
}

/* Writes the oscillator whose position is p = y - x, the relative coordinate of two bodies with one connection. The
   functions of oscillators/routes.h compute its motion. y0 = (x, y, x', y') is the motion at t = 0; pair must outlive
   *problem. The equation of the oscillator is exact. The small force -mu (m2'/m2 - m1'/m1) V also acts on the
   oscillator if `reactive` is 1, the mass centre moves, and m1'/m1 differs from m2'/m2. mu is the reduced mass, V the
   velocity of the mass centre. Returns the statuses of vm_coupled_pair_rhs at t = 0; VM_NOT_FINITE also means that a
   number of y0 is infinite or NaN. Returns VM_NO_LAW where there is not exactly one connection, where there are further
   forces, and where `reactive` is neither 0 nor 1, because then the motion of the mass centre depends on the vibration.
   In these three cases integrate vm_coupled_pair_rhs. The mass of the oscillator is a law of vm_law_user. If a mass of
   the pair is given by a table, the routes do not know the points of the table, and may miss changes within |t|/3000;
   set problem->mass.change_time for such a table. An error leaves *pair and *problem as they were. */
VM_API int vm_coupled_pair_oscillator(vm_coupled_pair *pair, const vm_real *y0, vm_osc_problem *problem)
{
    if (!pair || !y0 || !problem) return VM_BAD_ARGUMENT;
    vmi_pair_masses now;
    vm_osc_problem o;
    vm_real momentum;
    int i, status = vmi_coupled_now(pair, 0, &now);
    if (status != VM_BAD_ARGUMENT && !vmi_all_finite(4, y0)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    if (pair->n != 1 || pair->force || (pair->reactive != 0 && pair->reactive != 1)) return VM_NO_LAW;
    o.alpha = pair->connections[0].alpha;
    o.mass = vm_law_user(vmi_coupled_reduced_mass, pair);
    for (i = 0; i < 2; i++) { /* the reduced mass changes as fast as the faster of the two masses */
        const vm_real change_time = pair->mass[i].function ? pair->mass[i].change_time : 0;
        if (change_time > 0 && !(o.mass.change_time > 0 && o.mass.change_time < change_time))
            o.mass.change_time = change_time;
    }
    o.stiffness = vm_law_linear(pair->connections[0].k, 0);
    o.reactive = pair->reactive;
    o.damping = pair->damping;
    o.x = y0[1] - y0[0];
    o.v = y0[3] - y0[2];
    o.force = NULL;
    o.ctx = pair;
    momentum = now.m[0] * y0[2] + now.m[1] * y0[3];
    if (!VM_IS_FINITE(momentum) || !VM_IS_FINITE(o.x) || !VM_IS_FINITE(o.v)) return VM_NOT_FINITE;
    if (pair->reactive == 1 && momentum != 0) o.force = vmi_coupled_drift;
    pair->momentum = momentum;
    *problem = o;
    return VM_OK;
}

#endif
