/* mechanics/lagrange.h - Lagrange's equations with variable mass

   This chapter has the right-hand side for any system of n generalized coordinates whose kinetic energy T you can write
   down. The masses may depend on time and position, as in equation (247) of the dissertation [1]. You write functions
   for T, the masses and the generalized forces Q. The functions of this chapter compute the mass matrix A, the vector
   b and the derivatives of T from values of T. The states are the coordinates q and the momenta pi = dT/dq', with q' =
   dq/dt. Therefore you need no time derivatives of momenta or masses:
     pi' = (dT/dq, masses frozen) + Q,   A q' = pi - b,   T = q'Aq'/2 + b q' + T0,  T0 = T(q' = 0).

   These equations are the corrected form of (247). T must use the velocities of material points. If mass leaves, the
   mass centre also moves relative to the material of its body; this motion must not be counted in T. With streams of
   mass, Lagrange's equations are
     d/dt dT/dq'_i - (dT/dq_i, masses frozen) = Q_i + sum over streams [M' u dr2/dq_i + M' kappa omega2 domega/dq'_i].
   A stream has the mass rate M' and the velocity u at the point r2. Its mass has the angular velocity omega2 and, per
   unit mass, the inertia kappa. omega is the angular velocity of the body. "Masses frozen" means that the masses are
   held constant in the derivative dT/dq_i. The equations (244)-(247) do not say so clearly.

       #include "varmass.h"
       static void masses(vm_real t, const vm_real *q, vm_real *m, void *ctx)
       {
           (void)q;
           (void)ctx;
           m[0] = 3 - t / 10; // kg
       }
       static vm_real energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *m, void *ctx)
       {
           (void)t;
           (void)q;
           (void)ctx;
           return m[0] * rates[0] * rates[0] / 2;
       }
       int main(void)
       {
           vm_real q[1] = {0}, rates[1] = {2}, y[2], work[VM_LAGRANGE_RHS_WORK(1, 1)];
           vm_lagrange_system body = {1, 1, masses, energy, NULL, NULL, NULL, work};
           return vm_lagrange_start(&body, 0, q, rates, y); // y: initial state for rk45_init and vm_lagrange_rhs
       }

   Your Q must contain the terms of the streams, too. Example: a pendulum of length l and angle q has a bob that leaks
   mass, so that its mass m decreases. If the leaking mass leaves with the velocity of the bob, Q = -m g l sin q + m'
   l^2 q'. Without the last term the equation would describe mass that leaves at rest.

   vm_lagrange_needed_forces and vm_lagrange_drive_forces compute the forces that a given motion needs (inverse
   dynamics).

   Accuracy: A and b are computed as differences of values of T, so that they have no errors except rounding errors.
   dT/dq is a central difference of order 6 (its error is proportional to the sixth power of the step). The field
   `scales` must contain, for each coordinate, the change of the coordinate that changes T noticeably. The error of
   dT/dq is then below 2e-13 (float 1e-5) of the largest T, divided by the scale of the coordinate. Tests:
   tests/test_lagrange.c. */
#ifndef VARMASS_MECHANICS_LAGRANGE_H
#define VARMASS_MECHANICS_LAGRANGE_H

#include "../base/arrays.h"
#include "../base/linear.h"
#include "../base/real.h"
#include "../base/status.h"

/* A mechanical system. vm_lagrange_rhs gets a pointer to this struct as its last argument. */
typedef struct VM_TAG(vm_lagrange_system) {
    int n;        /* number of coordinates, > 0 */
    int n_masses; /* number of masses, inertias and other quantities that are held constant in dT/dq, >= 0 */
    /* Sets the n_masses masses at time t and coordinates q. The pointer is NULL if n_masses is 0. */
    void (*masses)(vm_real t, const vm_real *q, vm_real *masses, void *ctx);
    /* Returns the kinetic energy T (J), a polynomial of degree 2 in the n rates q'. */
    vm_real (*energy)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx);
    /* NULL, or a function that adds the n generalized forces to Q, for example with vm_lagrange_add_force. It returns 0
       to go on; any other number ends the run. */
    int (*forces)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q, void *ctx);
    void *ctx;             /* the argument ctx of the three functions above */
    const vm_real *scales; /* for each coordinate, the change of the coordinate that changes T noticeably; NULL means
                              that each of these changes is 1 */
    vm_real *work;         /* array of VM_LAGRANGE_RHS_WORK(n, n_masses) numbers, provided by the caller */
} vm_lagrange_system;

/* Length of the array `work` of a vm_lagrange_system */
#define VM_LAGRANGE_RHS_WORK(n, n_masses) ((n) * (n) + 4 * (n) + (n_masses))

/* The arrays into which the array `work` of a system is divided */
typedef struct VM_TAG(vmi_lagrange_parts) {
    vm_real *A;      /* the mass matrix A in T = q'Aq'/2 + b q' + T0, n rows of n numbers */
    vm_real *b;      /* the vector b in T, the coefficients of the terms that are linear in the rates q', n numbers */
    vm_real *rates;  /* first pi - b with the generalized momenta pi, later the rates q'; in inverse dynamics displaced
                        coordinates; n numbers */
    vm_real *trial;  /* rates or coordinates at which T is evaluated, n numbers */
    vm_real *forces; /* generalized forces of inverse dynamics, n numbers */
    vm_real *masses; /* the masses, which stay constant while T is differentiated, n_masses numbers */
} vmi_lagrange_parts;

VM_API vmi_lagrange_parts vmi_lagrange_work(const vm_lagrange_system *system)
{
    vmi_lagrange_parts w;
    w.A = system->work;
    w.b = w.A + (ptrdiff_t)system->n * system->n;
    w.rates = w.b + system->n;
    w.trial = w.rates + system->n;
    w.forces = w.trial + system->n;
    w.masses = w.forces + system->n;
    return w;
}

/* The kinetic energy T at time t, coordinates q and the rates x e_i + z e_j. e_i and e_j are the unit vectors of the
   coordinates i and j. If i is -1, the term with e_i is 0; if j is -1, the term with e_j is 0. The masses are those in
   the work array. */
VM_API vm_real vmi_lagrange_energy(const vm_lagrange_system *system, vm_real t, const vm_real *q, int i, vm_real x,
                                   int j, vm_real z)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    int k;
    for (k = 0; k < system->n; k++) w.trial[k] = 0;
    if (i >= 0) w.trial[i] = x;
    if (j >= 0) w.trial[j] += z;
    return system->energy(t, q, w.trial, w.masses, system->ctx);
}

/* Computes the mass matrix A and the vector b from values of T. For the entry A_ij off the diagonal, T is evaluated at
   the rates +-1/sqrt(A_ii) of coordinate i and +-1/sqrt(A_jj) of coordinate j. The kinetic energies of the two rates
   are then equal. If one of the two energies were much smaller, its digits would be lost in the sum. Returns
   VM_SINGULAR if an entry of the diagonal is zero or negative, so that A is not positive definite; else VM_OK. */
VM_API int vmi_lagrange_quadratic(const vm_lagrange_system *system, vm_real t, const vm_real *q)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    const int n = system->n;
    const vm_real T0 = vmi_lagrange_energy(system, t, q, -1, 0, -1, 0);
    int i, j, status = VM_OK;
    for (i = 0; i < n; i++) {
        const vm_real plus = vmi_lagrange_energy(system, t, q, i, 1, -1, 0);
        const vm_real minus = vmi_lagrange_energy(system, t, q, i, -1, -1, 0);
        w.A[i * n + i] = (plus - T0) + (minus - T0);
        w.b[i] = (plus - minus) / 2;
        if (w.A[i * n + i] <= 0 && VM_IS_FINITE(w.A[i * n + i])) status = VM_SINGULAR;
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++) {
            const vm_real x = 1 / VM_SQRT(w.A[i * n + i]), z = 1 / VM_SQRT(w.A[j * n + j]);
            const vm_real same = vmi_lagrange_energy(system, t, q, i, x, j, z) +
                                 vmi_lagrange_energy(system, t, q, i, -x, j, -z);
            const vm_real opposite = vmi_lagrange_energy(system, t, q, i, x, j, -z) +
                                     vmi_lagrange_energy(system, t, q, i, -x, j, z);
            w.A[i * n + j] = w.A[j * n + i] = (same - opposite) / (4 * x * z);
        }
    return status;
}

/* Writes the masses at time t and coordinates q into the work array, where the masses stay constant while T is
   differentiated. */
VM_API void vmi_lagrange_freeze(const vm_lagrange_system *system, vm_real t, const vm_real *q)
{
    if (system->masses) system->masses(t, q, vmi_lagrange_work(system).masses, system->ctx);
}

/* Writes the rates q' = A^-1 (pi - b) to the work array. y contains the coordinates q and the momenta pi. Returns
   VM_NOT_FINITE if t, y or A is not finite, VM_SINGULAR if A is not positive definite, and VM_OK otherwise. y is
   checked because A and b may not depend on each coordinate. */
VM_API int vmi_lagrange_solve_rates(const vm_lagrange_system *system, vm_real t, const vm_real *y)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    int k;
    if (!VM_IS_FINITE(t) || !vmi_all_finite(2 * system->n, y)) return VM_NOT_FINITE;
    vmi_lagrange_freeze(system, t, y);
    if (vmi_lagrange_quadratic(system, t, y)) return VM_SINGULAR;
    if (!vmi_all_finite(system->n * system->n, w.A)) return VM_NOT_FINITE;
    for (k = 0; k < system->n; k++) w.rates[k] = y[system->n + k] - w.b[k];
    return vmi_solve_mass(system->n, w.A, w.rates, w.trial);
}

/* The derivative dT/dq_i of the kinetic energy T, with the masses that are stored in the work array. The function
   computes it as a central difference of order 6, from the values of T at q_i plus and minus 1, 2 and 3 steps. A step
   h is 2^-7 (double precision, eps = 2^-52) or 2^-3 (single precision, eps = 2^-23) times the scale of q_i. If q_i is
   measured in units of its scale, the error is h^6/140 times the seventh derivative of T, plus a rounding error of T
   eps/h. Both errors are small for these values of h. */
VM_API vm_real vmi_lagrange_derivative(const vm_lagrange_system *system, vm_real t, const vm_real *q,
                                       const vm_real *rates, int i)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    const vm_real weights[3] = {VM_C(0.75), VM_C(-0.15), VM_C(1.0) / 60};
    vm_real h = VM_MANT_DIG > 24 ? VM_C(0.0078125) : VM_C(0.125), sum = 0;
    int k;
    if (system->scales) h *= system->scales[i];
    for (k = 0; k < system->n; k++) w.trial[k] = q[k];
    for (k = 3; k > 0; k--) {
        vm_real difference;
        w.trial[i] = q[i] + (vm_real)k * h;
        difference = system->energy(t, w.trial, rates, w.masses, system->ctx);
        w.trial[i] = q[i] - (vm_real)k * h;
        difference -= system->energy(t, w.trial, rates, w.masses, system->ctx);
        sum += weights[k - 1] * difference;
    }
    return sum / h;
}

/* Returns 1 if the system has all functions and arrays that it needs, else 0. */
VM_API int vmi_lagrange_is_valid(const vm_lagrange_system *system)
{
    return system && system->n > 0 && system->n_masses >= 0 && system->energy && system->work &&
           (system->n_masses == 0 || system->masses);
}

/* Right-hand side of Lagrange's equations with variable mass (247). Its type is ode_rhs, so that integrators such as
   rk45 can call it. The state y has 2 n numbers: n coordinates q, then n generalized momenta pi. `lagrange` must point
   to a vm_lagrange_system. Returns 0 or an error that ends the run. The errors are VM_BAD_ARGUMENT for a null pointer
   or an invalid system; VM_SINGULAR if the mass matrix is not positive definite; VM_NOT_FINITE if t, y or the mass
   matrix is infinite or NaN; or the number that system->forces returns (dydt is then overwritten). If only T at a
   neighbouring coordinate or a force is infinite or NaN, numbers of dydt are so, too. The mass matrix is not positive
   definite if, for example, a mass has become negative; use an event to stop the run before that. The number of calls
   of system->energy grows with n^2. */
VM_API int vm_lagrange_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *lagrange)
{
    const vm_lagrange_system *system = (const vm_lagrange_system *)lagrange;
    vmi_lagrange_parts w;
    int k, n, status;
    if (!y || !dydt || !vmi_lagrange_is_valid(system)) return VM_BAD_ARGUMENT;
    n = system->n;
    w = vmi_lagrange_work(system);
    status = vmi_lagrange_solve_rates(system, t, y);
    if (status) return status;
    for (k = 0; k < n; k++) {
        dydt[k] = w.rates[k];
        dydt[n + k] = 0;
    }
    if (system->forces) status = system->forces(t, y, w.rates, w.masses, dydt + n, system->ctx);
    for (k = 0; k < n; k++) dydt[n + k] += vmi_lagrange_derivative(system, t, y, w.rates, k);
    return status;
}

/* Initial state y of a system at time t, from its n coordinates q and n rates q'.
   y is an array of 2 n numbers: the n coordinates q followed by the n generalized momenta pi. Returns VM_BAD_ARGUMENT
   for a null pointer or an invalid system; VM_NOT_FINITE if a number of q, q' or pi is infinite or NaN; VM_SINGULAR if
   T does not grow with each of the rates; VM_OK otherwise. */
VM_API int vm_lagrange_start(vm_lagrange_system *system, vm_real t, const vm_real *q, const vm_real *rates, vm_real *y)
{
    vmi_lagrange_parts w;
    int i, j, n;
    if (!vmi_lagrange_is_valid(system) || !q || !rates || !y) return VM_BAD_ARGUMENT;
    n = system->n;
    w = vmi_lagrange_work(system);
    if (!vmi_all_finite(n, q) || !vmi_all_finite(n, rates)) return VM_NOT_FINITE;
    vmi_lagrange_freeze(system, t, q);
    if (vmi_lagrange_quadratic(system, t, q)) return VM_SINGULAR;
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) w.b[i] += w.A[i * n + j] * rates[j];
    if (!vmi_all_finite(n, w.b)) return VM_NOT_FINITE;
    for (i = 0; i < n; i++) {
        y[i] = q[i];
        y[n + i] = w.b[i];
    }
    return VM_OK;
}

/* Rates q' of a system at time t, from its state y.
   y has 2 n numbers: the n coordinates q followed by the n generalized momenta pi. rates has n numbers. Returns
   VM_BAD_ARGUMENT for a null pointer or an invalid system; VM_SINGULAR if the mass matrix is not positive definite;
   VM_NOT_FINITE if t, y, an energy or a rate is infinite or NaN; VM_OK otherwise. */
VM_API int vm_lagrange_rates(vm_lagrange_system *system, vm_real t, const vm_real *y, vm_real *rates)
{
    int status;
    if (!vmi_lagrange_is_valid(system) || !y || !rates) return VM_BAD_ARGUMENT;
    status = vmi_lagrange_solve_rates(system, t, y);
    if (status) return status;
    return vmi_copy_if_finite(system->n, vmi_lagrange_work(system).rates, rates);
}

/* Derivative dT/dq_i of the kinetic energy T, while the masses are held constant, J per unit of q_i.
   The masses are those at time t and coordinates q. q and rates have n numbers. Returns NaN for i outside 0 ... n - 1
   and for a null pointer. */
VM_API vm_real vm_lagrange_partial_q(vm_lagrange_system *system, vm_real t, const vm_real *q, const vm_real *rates,
                                     int i)
{
    if (!vmi_lagrange_is_valid(system) || !q || !rates || i < 0 || i >= system->n) return VM_NAN;
    vmi_lagrange_freeze(system, t, q);
    return vmi_lagrange_derivative(system, t, q, rates, i);
}

/* ---- Inverse dynamics ---- */

/* Adds `weight` times the generalized momenta dT/dq' = A q' + b, at time t and coordinates q, to the n numbers of p. */
VM_API void vmi_lagrange_add_momenta(const vm_lagrange_system *system, vm_real t, const vm_real *q,
                                     const vm_real *rates, vm_real weight, vm_real *p)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    const int n = system->n;
    int i, j;
    vmi_lagrange_freeze(system, t, q);
    vmi_lagrange_quadratic(system, t, q);
    for (i = 0; i < n; i++) {
        vm_real sum = w.b[i];
        for (j = 0; j < n; j++) sum += w.A[i * n + j] * rates[j];
        p[i] += weight * sum;
    }
}

/* Returns the step in time for the numerical derivative of the momenta along the motion. During one step no coordinate
   changes by more than h times its scale, and the time changes by at most h time_scale. h is the number explained at
   vmi_lagrange_derivative. The step is 0 if nothing changes. */
VM_API vm_real vmi_lagrange_time_step(const vm_lagrange_system *system, vm_real time_scale, const vm_real *rates)
{
    const vm_real h = VM_MANT_DIG > 24 ? VM_C(0.0078125) : VM_C(0.125);
    vm_real fastest = 0;
    int k;
    if (time_scale > 0) fastest = 1 / time_scale;
    for (k = 0; k < system->n; k++) {
        vm_real fast = VM_FABS(rates[k]);
        if (system->scales) fast /= VM_FABS(system->scales[k]);
        fastest = vmi_larger(fastest, fast);
    }
    if (fastest == 0) return 0;
    return h / fastest;
}

/* Adds to p the time derivatives that the momenta would have if coordinates and time changed, but the rates q' did
   not. The derivatives are computed as central differences of order 6. If time_scale is 0, the time stays constant,
   too. */
VM_API void vmi_lagrange_add_momentum_rates(const vm_lagrange_system *system, vm_real t, vm_real time_scale,
                                            const vm_real *q, const vm_real *rates, vm_real *p)
{
    const vm_real weights[3] = {VM_C(0.75), VM_C(-0.15), VM_C(1.0) / 60};
    const vm_real step = vmi_lagrange_time_step(system, time_scale, rates);
    const vmi_lagrange_parts w = vmi_lagrange_work(system);
    int i, k;
    if (step == 0) return;
    for (k = -3; k <= 3; k++) {
        const vm_real moved = (vm_real)k * step;
        vm_real weight, time = t;
        if (k == 0) continue;
        weight = weights[k > 0 ? k - 1 : -k - 1] / step;
        if (k < 0) weight = -weight;
        if (time_scale > 0) time = t + moved;
        for (i = 0; i < system->n; i++) w.rates[i] = q[i] + moved * rates[i];
        vmi_lagrange_add_momenta(system, time, w.rates, rates, weight, p);
    }
}

/* Checks the arguments of vm_lagrange_needed_forces, and writes the needed forces to the work array. Returns the
   status of vm_lagrange_needed_forces. */
VM_API int vmi_lagrange_inverse(const vm_lagrange_system *system, vm_real t, vm_real time_scale, const vm_real *q,
                                const vm_real *rates, const vm_real *accelerations)
{
    vmi_lagrange_parts w;
    int i, j, n;
    if (!vmi_lagrange_is_valid(system) || !q || !rates || !accelerations) return VM_BAD_ARGUMENT;
    n = system->n;
    w = vmi_lagrange_work(system);
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(time_scale)) return VM_NOT_FINITE;
    if (!vmi_all_finite(n, q) || !vmi_all_finite(n, rates) || !vmi_all_finite(n, accelerations)) return VM_NOT_FINITE;
    if (time_scale < 0) return VM_DOMAIN;
    for (i = 0; i < n; i++) w.forces[i] = 0;
    vmi_lagrange_add_momentum_rates(system, t, time_scale, q, rates, w.forces);
    vmi_lagrange_freeze(system, t, q);
    if (vmi_lagrange_quadratic(system, t, q)) return VM_SINGULAR;
    for (i = 0; i < n; i++) {
        for (j = 0; j < n; j++) w.forces[i] += w.A[i * n + j] * accelerations[j];
        w.forces[i] -= vmi_lagrange_derivative(system, t, q, rates, i);
    }
    return VM_OK;
}

/* Inverse dynamics: generalized forces Q that a given motion needs, the left side of (247).
   The forces are Q_i = d/dt dT/dq'_i - (dT/dq_i, masses held constant). Q is the sum of all generalized forces, and
   includes the forces of the streams of mass. q, rates and accelerations are the n coordinates q and their derivatives
   q' and q'' at time t; Q has n numbers. time_scale (s) is the time in which T or the masses change noticeably while q
   stays constant (the field `scales` contains the corresponding changes of the coordinates). Set it to 0 if T and the
   masses do not depend on time. Returns VM_BAD_ARGUMENT for a null pointer or an invalid system; VM_NOT_FINITE if an
   argument or the result is infinite or NaN; VM_DOMAIN for time_scale < 0; VM_SINGULAR if T does not grow with each of
   the rates; VM_OK otherwise. The error is below 2e-13 (float 1e-5) of the largest of three terms: the mass matrix A
   times q'', T divided by the scale of a coordinate, and dT/dq' divided by the time in which the system changes
   noticeably. T is evaluated at most 14 n^2 + 6 n + 7 times. */
VM_API int vm_lagrange_needed_forces(vm_lagrange_system *system, vm_real t, vm_real time_scale, const vm_real *q,
                                     const vm_real *rates, const vm_real *accelerations, vm_real *Q)
{
    int status;
    if (!Q) return VM_BAD_ARGUMENT;
    status = vmi_lagrange_inverse(system, t, time_scale, q, rates, accelerations);
    if (status) return status;
    return vmi_copy_if_finite(system->n, vmi_lagrange_work(system).forces, Q);
}

/* Inverse dynamics: generalized forces that drives must add to system->forces for a given motion.
   These forces are the results of vm_lagrange_needed_forces minus the forces that the function `forces` of the system
   computes. The arguments, the accuracy and the statuses are those of vm_lagrange_needed_forces. If system->forces
   returns a number other than 0, this number is the status. */
VM_API int vm_lagrange_drive_forces(vm_lagrange_system *system, vm_real t, vm_real time_scale, const vm_real *q,
                                    const vm_real *rates, const vm_real *accelerations, vm_real *Q)
{
    vmi_lagrange_parts w;
    int i, status;
    if (!Q) return VM_BAD_ARGUMENT;
    status = vmi_lagrange_inverse(system, t, time_scale, q, rates, accelerations);
    if (status) return status;
    w = vmi_lagrange_work(system);
    for (i = 0; i < system->n; i++) w.b[i] = 0;
    if (system->forces) status = system->forces(t, q, rates, w.masses, w.b, system->ctx);
    if (status) return status;
    for (i = 0; i < system->n; i++) w.forces[i] -= w.b[i];
    return vmi_copy_if_finite(system->n, w.forces, Q);
}

#endif
