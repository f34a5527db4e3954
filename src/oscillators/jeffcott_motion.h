/* oscillators/jeffcott_motion.h - the motion z(t) of the Jeffcott (Laval) rotor from its amplitude law and its phase

   Numbers in brackets are equations of the dissertation. In a circular whirl the centre of the disc moves on a circle:
   z = A e^(i psi) (497), with the velocity z' = i W z (498). The phase psi is the integral of the frequency W over time
   (499). Without an external force, and without a velocity u of the mass that joins or leaves, the radius A depends on
   the mass alone. Then W is a known function of time. The integral has a closed form if the force of the shaft is a
   power law, the law of the mass has an exponential form (oscillators/laws.h), and there are no gyroscopic moments. On
   a linear shaft every motion is the sum of a forward and a backward whirl. The functions of this file generalize
   (481), (482) to any start, reactive force and gyroscopic moment. oscillators/jeffcott.h explains the letters and the
   struct vm_jeffcott; g and r are its fields gyro and reactive. The shortest useful call:
       vm_power_force shaft = {4, 1}; // F_e = 4 N/m rho
       vm_jeffcott_whirl whirl;
       vm_jeffcott rotor;
       int status;
       memset(&rotor, 0, sizeof rotor);
       rotor.stiffness = vm_jeffcott_power;
       rotor.stiffness_ctx = &shaft;
       rotor.mass = vm_law_linear(1, VM_C(0.01)); // 1 kg, and 0.01 kg/s joins
       status = vm_jeffcott_whirl_at(&rotor, 1, 0, 1, 20, &whirl); // forward, radius 1 m and angle 0 at t = 0
   All these motions are solutions of averaged equations. The error of A is of first order in the relative change of the
   mass within a radian of the phase. The error of psi is of this order, too, up to times of the order of the inverse of
   this change.
   Tests: tests/test_jeffcott_motion.c. */
#ifndef VARMASS_OSCILLATORS_JEFFCOTT_MOTION_H
#define VARMASS_OSCILLATORS_JEFFCOTT_MOTION_H

#include "../base/arrays.h"
#include "../base/complex.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../integrators/rk45.h"
#include "../integrators/rk87.h"
#include "jeffcott.h"
#include "laws.h"
#include "panels.h"

/* A circular whirl at one time */
typedef struct VM_TAG(vm_jeffcott_whirl) {
    vm_real radius;    /* A, m */
    vm_real angle;     /* psi, rad; it counts all turns */
    vm_real frequency; /* W = psi', rad/s; if K_e > 0, it is negative for backward whirl */
    vm_complex z, v;   /* position A e^(i psi) and velocity i W z of the disc's centre, m and m/s */
} vm_jeffcott_whirl;

/* -- The radius as a function of the mass -- */

/* A change of mass along which the radius is integrated: the radius and the mass at its start, and the sense of the
   whirl, 1 forward or -1 backward */
typedef struct VM_TAG(vmi_jeffcott_change) {
    const vm_jeffcott *r;
    vm_real first_A, mass0;
    int sense;
} vmi_jeffcott_change;

/* The derivative of ln A with respect to s = ln(m/mass0), by (504) with m as the independent variable:
     (ln A)' (2 + m K_e' A/(2 S^2)) = (1 - r) (1 + g/S) - m K_e/(2 S^2),   S = m W - g,
   where K_e' is the derivative of the stiffness K_e with respect to the radius. The function is an ode_rhs; its only
   state is ln(A/first_A). */
VM_API int vmi_jeffcott_change_rhs(vm_real s, const vm_real *y, vm_real *dyds, void *change)
{
    const vmi_jeffcott_change *c = (const vmi_jeffcott_change *)change;
    const vm_real mass = c->mass0 * vmi_exp(s, 0), A = c->first_A * vmi_exp(y[0], 0);
    vm_real slope, S, share;
    const vm_real stiffness = vmi_jeffcott_stiffness(c->r, A, &slope);
    const vm_real unit = vmi_jeffcott_unit(c->r->gyro, mass, stiffness);
    const vm_real g = c->r->gyro / unit, m = mass / unit, K = stiffness / unit, square = g * g + m * K;
    if (!(square > 0)) return VM_BAD_STIFFNESS;
    S = VM_SQRT(square);
    share = m / (2 * square);
    if (c->sense < 0) S = -S;
    dyds[0] = ((1 - c->r->reactive) * (1 + g / S) - share * K) / (2 + share * (slope / unit) * A);
    return VM_OK;
}

/* Radius of circular whirl, m, after the mass has changed slowly, for any share of the reactive force.
   For g = 0 or r = 1 the result is that of vm_jeffcott_amplitude. For other rotors the relative growth of A^2 S,
   where S = m W - g, is (1 - r) (1 + g/S) times the relative change of the mass. The function integrates this relation
   over the mass by rk87; the relative error is at most 1e-13 (float 3e-6). The radius was first_A when the mass was
   mass0; `mass` is the mass after the change. sense >= 0 means forward, sense < 0 backward whirl. Returns NaN in the
   cases of vm_jeffcott_amplitude, except for g != 0 with r != 1, which is allowed here. Also returns NaN where g^2 + m
   K_e(A) is not positive for a mass m between mass0 and `mass`. */
VM_API vm_real vm_jeffcott_whirl_amplitude(const vm_jeffcott *r, vm_real first_A, vm_real mass0, vm_real mass,
                                           int sense)
{
    const vm_real tolerance = 16 * VM_EPSILON;
    vm_real work[RK87_WORK(1)], y = 0;
    rk87_options options = rk45_defaults(NULL);
    vmi_jeffcott_change change;
    rk87 run;
    if (!r || r->gyro == 0 || r->reactive == 1) return vm_jeffcott_amplitude(r, first_A, mass0, mass);
    if (!r->stiffness || !(first_A > 0) || !(mass0 > 0) || !(mass > 0) || !VM_IS_FINITE(first_A) ||
        !VM_IS_FINITE(mass0) || !VM_IS_FINITE(mass) || !VM_IS_FINITE(r->reactive) || !VM_IS_FINITE(r->gyro))
        return VM_NAN;
    change.r = r;
    change.first_A = first_A;
    change.mass0 = mass0;
    change.sense = sense;
    options.atol = tolerance;
    options.rtol = -1; /* no relative tolerance: atol limits the absolute error of ln A */
    if (rk87_init(&run, vmi_jeffcott_change_rhs, &change, 1, 0, &y, &options, work) < 0) return VM_NAN;
    if (rk87_solve(&run, vmi_log(mass / mass0).hi) < 0) return VM_NAN;
    return first_A * vmi_exp(run.y[0], 0);
}

/* -- The phase -- */

/* A circular whirl whose frequency is integrated over time */
typedef struct VM_TAG(vmi_jeffcott_phase) {
    const vm_jeffcott *r;
    vm_real first_A, mass0; /* radius and mass at t = 0 */
    int sense;
} vmi_jeffcott_phase;

/* Writes the radius A and the frequency W of the whirl at the time when the disc has the given mass. Returns
   VM_BAD_STIFFNESS where no circular whirl exists for this mass. */
VM_API int vmi_jeffcott_whirl_of_mass(const vmi_jeffcott_phase *p, vm_real mass, vm_real *A, vm_real *W)
{
    *A = vm_jeffcott_whirl_amplitude(p->r, p->first_A, p->mass0, mass, p->sense);
    *W = vm_jeffcott_frequency(p->r, *A, mass, p->sense);
    if (!VM_IS_FINITE(*W) || *W == 0) return VM_BAD_STIFFNESS;
    return VM_OK;
}

/* Writes the frequency W of the whirl at time t. The function is a vmi_integrand (oscillators/panels.h); phase points
   to a vmi_jeffcott_phase. */
VM_API int vmi_jeffcott_frequency_at(vm_real t, int side, vm_real *W, void *phase)
{
    const vmi_jeffcott_phase *p = (const vmi_jeffcott_phase *)phase;
    vm_real m[VMI_LAW_ORDERS], A;
    const int status = vmi_law_derivatives(&p->r->mass, VM_BAD_MASS, t, side, 0, m);
    if (status) return status;
    return vmi_jeffcott_whirl_of_mass(p, m[0], &A, W);
}

/* Computes the phase psi of the whirl at t in closed form and returns 1, or returns 0 if there is no closed form. W is
   the frequency of the whirl at t = 0. A closed form exists for F_e = k rho^alpha with g = 0, if the law of the mass
   has an exponential form (oscillators/laws.h). The frequency is then proportional to m^-q, with 2 q = 1 + (alpha - 1)
   (2 r - 1)/(alpha + 3). Equation (482) is the case alpha = 1, m = m0 (1 + c t)^2. */
VM_API int vmi_jeffcott_phase_closed(const vm_jeffcott *r, vm_real W, vm_real t, vm_real *psi)
{
    vm_real base, rate, q, u;
    const vm_power_force *p = (const vm_power_force *)r->stiffness_ctx;
    if (r->stiffness != vm_jeffcott_power || r->gyro != 0) return 0;
    if (!vmi_law_exponential_form(&r->mass, &base, &rate)) return 0;
    q = (1 + (p->alpha - 1) / (p->alpha + 3) * (2 * r->reactive - 1)) / 2;
    u = t * vmi_log_ratio(base * t);
    *psi = W * u * vmi_exp_ratio((base - q * rate) * u);
    return 1;
}

/* Computes the phase from 0 to t by numerical integration of the frequency. */
VM_API int vmi_jeffcott_phase_by_panels(vmi_jeffcott_phase *p, vm_real t, vm_real *psi)
{
    const vm_law *mass = &p->r->mass;
    vm_real at = 0;
    int status = VM_OK;
    *psi = 0;
    while (!status && at != t) {
        const vm_real next = vmi_law_next_knot(mass, at, t), whole = VM_FABS(t);
        status = vmi_add_integral(vmi_jeffcott_frequency_at, p, at, next, vmi_law_longest_panel(mass, whole), whole,
                                  psi);
        at = next;
    }
    return status;
}

/* Checks what the motions of this file need: a rotor without an external force and without a velocity u, and masses
   that are finite and positive from 0 to t. Writes the masses at 0 and at t. */
VM_API int vmi_jeffcott_check_motion(const vm_jeffcott *r, vm_real t, vm_real *mass0, vm_real *mass)
{
    vm_real rate;
    int status;
    if (!r->stiffness || !r->mass.derivatives) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(r->gyro) || !VM_IS_FINITE(r->reactive) || !VM_IS_FINITE(r->u.re) ||
        !VM_IS_FINITE(r->u.im))
        return VM_NOT_FINITE;
    status = vmi_law_check(&r->mass, VM_BAD_MASS, t);
    if (!status) status = vmi_jeffcott_mass_at(r, 0, mass0, &rate);
    if (!status) status = vmi_jeffcott_mass_at(r, t, mass, &rate);
    if (!status && (r->force || r->u.re != 0 || r->u.im != 0)) return VM_NO_LAW;
    return status;
}

/* Circular whirl of the rotor at time t, of either sign, from radius and angle at t = 0: (497)-(499). first_A > 0
   is the radius (m) and first_angle the angle (rad) at t = 0; sense >= 0 means forward, sense < 0 backward whirl.
   The radius is that of vm_jeffcott_whirl_amplitude. The phase, which is the angle of the whirl from 0 to t, has a
   closed form for a power law of the shaft (vm_jeffcott_power) with g = 0 and a mass that is constant, linear,
   exponential or a power; its relative error is then at most 8 eps, plus the change that a rounding error of the
   time t makes, which is large where the mass is nearly exhausted. Otherwise the time is divided into parts, and
   Gauss' rule integrates the frequency over each part from 20 points; the radius is computed at each point. For a
   smooth stiffness the relative error of the phase is then at most 1e-12 (float 1e-4). The small radial velocity is
   neglected: the velocity is i W z, where W is the frequency of the whirl. Returns VM_BAD_ARGUMENT for null pointers
   and a rotor without mass or stiffness; VM_NOT_FINITE for a number that is infinite or NaN; VM_BAD_MASS for a mass
   that is not positive; VM_BAD_STIFFNESS where there is no circular whirl or K_e is NaN; VM_DOMAIN for a radius that is
   not positive or a t at which the law of the mass has no value; VM_NO_LAW for a rotor with a force or a velocity u. */
VM_API int vm_jeffcott_whirl_at(const vm_jeffcott *r, vm_real first_A, vm_real first_angle, int sense, vm_real t,
                                vm_jeffcott_whirl *whirl)
{
    vmi_jeffcott_phase phase;
    vm_jeffcott_whirl w;
    vm_real mass, psi, first_W, unused;
    int status;
    if (!r || !whirl) return VM_BAD_ARGUMENT;
    status = vmi_jeffcott_check_motion(r, t, &phase.mass0, &mass);
    if (!VM_IS_FINITE(first_A) || !VM_IS_FINITE(first_angle)) status = vmi_first_error(status, VM_NOT_FINITE);
    else if (first_A <= 0) status = vmi_first_error(status, VM_DOMAIN);
    if (status) return status;
    phase.r = r;
    phase.first_A = first_A;
    phase.sense = sense;
    status = vmi_jeffcott_whirl_of_mass(&phase, phase.mass0, &unused, &first_W);
    if (!status) status = vmi_jeffcott_whirl_of_mass(&phase, mass, &w.radius, &w.frequency);
    if (status) return status;
    if (!vmi_jeffcott_phase_closed(r, first_W, t, &psi)) status = vmi_jeffcott_phase_by_panels(&phase, t, &psi);
    if (status) return status;
    w.angle = first_angle + psi;
    w.z = vmi_c_scale(w.radius, vmi_c_turn(w.angle));
    w.v = vmi_c_times_i(w.frequency, w.z);
    if (!VM_IS_FINITE(w.angle) || !VM_IS_FINITE(w.v.re) || !VM_IS_FINITE(w.v.im)) return VM_NOT_FINITE;
    *whirl = w;
    return VM_OK;
}

/* -- Any motion on a linear shaft -- */

/* Adds the position and velocity of a whirl at time t to the motion (x, y, x', y'). sense >= 0 means forward, sense < 0
   backward whirl. At t = 0 the whirl was at z = first; if first is 0, nothing is added. */
VM_API int vmi_jeffcott_add_whirl(const vm_jeffcott *r, vm_complex first, int sense, vm_real t, vm_real *motion)
{
    const vm_real A = vmi_c_modulus(first);
    vm_jeffcott_whirl w;
    int status;
    if (A == 0) return VM_OK;
    status = vm_jeffcott_whirl_at(r, A, vmi_atan2(first.im, first.re), sense, t, &w);
    if (status) return status;
    motion[0] += w.z.re;
    motion[1] += w.z.im;
    motion[2] += w.v.re;
    motion[3] += w.v.im;
    return VM_OK;
}

/* Motion of a rotor on a linear shaft at time t, of either sign, from its motion at t = 0: (480)-(482).
   start and motion are (x, y, x', y') in m and m/s; they may be the same array. The motion is the sum of a forward
   whirl P and a backward whirl N, which do not disturb each other: z = P + N, z' = i (W1 P + W2 N) with the frequencies
   W1 > 0 and W2 < 0 of vm_jeffcott_frequency. Each of the two whirls is computed by vm_jeffcott_whirl_at, with the
   gyroscopic constant g and any share r of the reactive force. Where P and conj(N) are equal, the rotor oscillates
   along a line (481). The statuses are those of vm_jeffcott_whirl_at; VM_BAD_STIFFNESS also means that K_e is not
   positive, and VM_NO_LAW also means that the slope dK_e/drho at the deflection |z| of the start is not 0. Only this
   slope is tested: if the shaft is not linear but has the slope 0 there, for example K_e = k + c rho^2 at z = 0, the
   result is wrong. */
VM_API int vm_jeffcott_linear_at(const vm_jeffcott *r, const vm_real *start, vm_real t, vm_real *motion)
{
    vm_real mass0 = 0, mass = 0, slope, stiffness, W1, W2, found[4] = {0, 0, 0, 0};
    vm_complex z, P;
    int status;
    if (!r || !start || !motion) return VM_BAD_ARGUMENT;
    status = vmi_jeffcott_check_motion(r, t, &mass0, &mass);
    if (!vmi_all_finite(4, start)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    z = vmi_complex(start[0], start[1]);
    stiffness = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope);
    if (!(stiffness > 0)) return VM_BAD_STIFFNESS;
    if (slope != 0) return VM_NO_LAW;
    W1 = vmi_jeffcott_root(r->gyro, mass0, stiffness, 1);
    W2 = vmi_jeffcott_root(r->gyro, mass0, stiffness, -1);
    if (!VM_IS_FINITE(W1) || !VM_IS_FINITE(W2) || !(W1 - W2 > 0)) return VM_NOT_FINITE;
    P = vmi_c_times_i(-1, vmi_complex(start[2], start[3])); /* z'/i */
    P = vmi_c_scale(1 / (W1 - W2), vmi_c_sub(P, vmi_c_scale(W2, z)));
    status = vmi_jeffcott_add_whirl(r, P, 1, t, found);
    if (!status) status = vmi_jeffcott_add_whirl(r, vmi_c_sub(z, P), -1, t, found);
    if (status) return status;
    return vmi_copy_if_finite(4, found, motion);
}

#endif
