/* mechanics/lagrange.h - Lagrange's equations with variable mass */
#ifndef VARMASS_MECHANICS_LAGRANGE_H
#define VARMASS_MECHANICS_LAGRANGE_H

#include "../base/arrays.h"
#include "../base/linear.h"
#include "../base/real.h"
#include "../base/status.h"

/* (247) corrected: with T(t, q, q', masses) of the material velocities, r2 where a stream crosses,
     d/dt dT/dq'_i - (dT/dq_i, masses frozen) = Q_i + sum [M' u dr2/dq_i + M' kappa omega2 domega/dq'_i]
   A derivative that lets masses vary with q, as (244)-(247) may be read, is wrong. As first-order equations: states
   are q and the momenta pi = dT/dq', from which q' follows; neither rates of momenta nor of masses are needed.
     pi' = (dT/dq, masses frozen) + Q,   A q' = pi - b,   T = q'Aq'/2 + b q' + T0
   Q has what streams bring: a pendulum l long that leaks at its bob has -m g l sin q + m' l^2 q', where a leak that
   moves on with the bob takes its momentum along; without the last term it would leave at rest.
   A and b come from T itself by differences over unit rates, exact but for roundings of T there and at rest; dT/dq by
   central differences of order 6, within 2e-13 of the largest T (float 1e-5) over a scale on which T varies in q. */
typedef struct VM_TAG(vm_lagrange_system) {
    int n;        /* coordinates */
    int n_masses; /* masses, inertias, whatever is frozen */
    void (*masses)(vm_real t, const vm_real *q, vm_real *masses, void *ctx); /* null where n_masses is 0 */
    vm_real (*energy)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx);
    /* null, or adds the generalized forces to Q, vm_lagrange_add_force does; nonzero stops the run */
    int (*forces)(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q, void *ctx);
    void *ctx;
    const vm_real *scales; /* of each q; null: 1 */
    vm_real *work;         /* VM_LAGRANGE_RHS_WORK(n, n_masses) numbers */
} vm_lagrange_system;

#define VM_LAGRANGE_RHS_WORK(n, n_masses) ((n) * (n) + 3 * (n) + (n_masses))

/* Parts of work: A, b and then a right-hand side, rates, a trial point, masses */
typedef struct VM_TAG(vmi_lagrange_parts) {
    vm_real *A, *b, *rates, *trial, *masses;
} vmi_lagrange_parts;

VM_API vmi_lagrange_parts vmi_lagrange_work(const vm_lagrange_system *l)
{
    vmi_lagrange_parts w;
    w.A = l->work;
    w.b = w.A + (ptrdiff_t)l->n * l->n;
    w.rates = w.b + l->n;
    w.trial = w.rates + l->n;
    w.masses = w.trial + l->n;
    return w;
}

/* T at rates x e_i + z e_j */
VM_API vm_real vmi_lagrange_energy(const vm_lagrange_system *l, vm_real t, const vm_real *q, int i, vm_real x, int j,
                                 vm_real z)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    int k;
    for (k = 0; k < l->n; k++) w.trial[k] = (k == i ? x : 0) + (k == j ? z : 0);
    return l->energy(t, q, w.trial, w.masses, l->ctx);
}

/* A and b from T; steps of the size of 1/sqrt(A_ii) keep the roundings of unlike coordinates apart */
VM_API void vmi_lagrange_quadratic(const vm_lagrange_system *l, vm_real t, const vm_real *q)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    const int n = l->n;
    const vm_real T0 = vmi_lagrange_energy(l, t, q, -1, 0, -1, 0);
    int i, j;
    for (i = 0; i < n; i++) {
        const vm_real plus = vmi_lagrange_energy(l, t, q, i, 1, -1, 0);
        const vm_real minus = vmi_lagrange_energy(l, t, q, i, -1, -1, 0);
        w.A[i * n + i] = (plus - T0) + (minus - T0);
        w.b[i] = (plus - minus) / 2;
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++) {
            const vm_real x = 1 / VM_SQRT(w.A[i * n + i]), z = 1 / VM_SQRT(w.A[j * n + j]);
            const vm_real same = vmi_lagrange_energy(l, t, q, i, x, j, z) + vmi_lagrange_energy(l, t, q, i, -x, j, -z);
            const vm_real apart = vmi_lagrange_energy(l, t, q, i, x, j, -z) + vmi_lagrange_energy(l, t, q, i, -x, j, z);
            w.A[i * n + j] = w.A[j * n + i] = (same - apart) / (4 * x * z);
        }
}

VM_API void vmi_lagrange_freeze(const vm_lagrange_system *l, vm_real t, const vm_real *q)
{
    if (l->masses) l->masses(t, q, vmi_lagrange_work(l).masses, l->ctx);
}

/* q' into the work */
VM_API int vmi_lagrange_solve_rates(const vm_lagrange_system *l, vm_real t, const vm_real *y)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    int k;
    vmi_lagrange_freeze(l, t, y);
    vmi_lagrange_quadratic(l, t, y);
    for (k = 0; k < l->n; k++) w.rates[k] = y[l->n + k] - w.b[k];
    return vmi_solve_mass(l->n, w.A, w.rates, w.trial);
}

/* h^6/140 of the seventh derivative against eps/h: h = 2^-7 for eps = 2^-52, 2^-3 for 2^-23 */
VM_API vm_real vmi_lagrange_derivative(const vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates, int i)
{
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    const vm_real h = (VM_MANT_DIG > 24 ? VM_C(0.0078125) : VM_C(0.125)) * (l->scales ? l->scales[i] : 1);
    const vm_real weights[3] = {VM_C(0.75), VM_C(-0.15), VM_C(1.0) / 60};
    vm_real sum = 0;
    int k;
    for (k = 0; k < l->n; k++) w.trial[k] = q[k];
    for (k = 3; k > 0; k--) {
        vm_real difference;
        w.trial[i] = q[i] + (vm_real)k * h;
        difference = l->energy(t, w.trial, rates, w.masses, l->ctx);
        w.trial[i] = q[i] - (vm_real)k * h;
        difference -= l->energy(t, w.trial, rates, w.masses, l->ctx);
        sum += weights[k - 1] * difference;
    }
    return sum / h;
}

VM_API int vmi_lagrange_is_valid(const vm_lagrange_system *l)
{
    return l && l->n > 0 && l->n_masses >= 0 && l->energy && l->work && (l->n_masses == 0 || l->masses);
}

/* An ode_rhs of 2 n states q, pi, ctx a vm_lagrange_system. Where A is singular, as in vm_lagrange_separate, or masses have
   become negative, VM_SINGULAR stops it: stop before, by an event */
VM_API int vm_lagrange_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *lagrange)
{
    const vm_lagrange_system *l = (const vm_lagrange_system *)lagrange;
    if (!y || !dydt || !vmi_lagrange_is_valid(l)) return VM_BAD_ARGUMENT;
    const vmi_lagrange_parts w = vmi_lagrange_work(l);
    int k, status = vmi_lagrange_solve_rates(l, t, y);
    if (status) return status;
    for (k = 0; k < l->n; k++) {
        dydt[k] = w.rates[k];
        dydt[l->n + k] = 0;
    }
    if (l->forces) status = l->forces(t, y, w.rates, w.masses, dydt + l->n, l->ctx);
    for (k = 0; k < l->n; k++) dydt[l->n + k] += vmi_lagrange_derivative(l, t, y, w.rates, k);
    return status;
}

/* y = q, pi from q and rates q', and rates from y; VM_BAD_ARGUMENT, VM_SINGULAR, VM_NOT_FINITE */
VM_API int vm_lagrange_start(vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates, vm_real *y)
{
    vmi_lagrange_parts w;
    int i, j;
    if (!vmi_lagrange_is_valid(l) || !q || !rates || !y) return VM_BAD_ARGUMENT;
    w = vmi_lagrange_work(l);
    vmi_lagrange_freeze(l, t, q);
    vmi_lagrange_quadratic(l, t, q);
    for (i = 0; i < l->n; i++)
        for (j = 0; j < l->n; j++) w.b[i] += w.A[i * l->n + j] * rates[j];
    if (!vmi_all_finite(l->n, w.b) || !vmi_all_finite(l->n, q)) return VM_NOT_FINITE;
    for (i = 0; i < l->n; i++) {
        y[i] = q[i];
        y[l->n + i] = w.b[i];
    }
    return VM_OK;
}

/* Documented with vm_lagrange_start. */
VM_API int vm_lagrange_rates(vm_lagrange_system *l, vm_real t, const vm_real *y, vm_real *rates)
{
    int status;
    if (!vmi_lagrange_is_valid(l) || !y || !rates) return VM_BAD_ARGUMENT;
    status = vmi_lagrange_solve_rates(l, t, y);
    return status ? status : vmi_copy_if_finite(l->n, vmi_lagrange_work(l).rates, rates);
}

/* dT/dq_i with the masses frozen at (t, q); NaN for i outside 0 .. n - 1 */
VM_API vm_real vm_lagrange_partial_q(vm_lagrange_system *l, vm_real t, const vm_real *q, const vm_real *rates, int i)
{
    if (!vmi_lagrange_is_valid(l) || !q || !rates || i < 0 || i >= l->n) return VM_NAN;
    vmi_lagrange_freeze(l, t, q);
    return vmi_lagrange_derivative(l, t, q, rates, i);
}

#endif
