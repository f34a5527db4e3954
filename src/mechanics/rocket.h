/* mechanics/rocket.h - closed forms: velocity by momentum, Tsiolkovsky's rocket, linear flow, jet damping

   This chapter has closed formulas for motions with streams of mass, so that no integrator is needed. The first two
   functions give the velocity of a body as a function of its mass, by the equations (151), (171), (175), (176) of the
   dissertation [1]. The others give the motion along a line while the mass changes at a constant rate, and the angular
   velocity of a spinning rocket whose rotation the jet damps. The formulas stay accurate as the rate of the mass tends
   to zero.

       vm_real v = vm_tsiolkovsky(0, 100, 40, -2500); // m/s: from 100 kg to 40 kg, jet at 2500 m/s backwards

   Tests: tests/test_flow1.c. */
#ifndef VARMASS_MECHANICS_ROCKET_H
#define VARMASS_MECHANICS_ROCKET_H

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "flow1.h"
#include "streams.h"
#include "vectors.h"

/* A spinning axisymmetric body. The body axis z is the axis of symmetry. Mass leaves through a nozzle on this axis
   (rate < 0) or enters through it (rate > 0). In the body the stored mass lies around the mass centre of the body, so
   that this mass centre does not move in the body when mass leaves or enters. A transverse axis goes through the mass
   centre and is perpendicular to z; "inertia" means moment of inertia. */
typedef struct VM_TAG(vm_jet) {
    vm_real rate;                /* mass per time, kg/s; < 0: mass leaves */
    vm_real axial;               /* inertia C0 of the body about the z axis at t = 0, kg m^2 */
    vm_real transverse;          /* inertia A0 of the body about a transverse axis at t = 0, kg m^2 */
    vm_real gyration_axial;      /* inertia about z of the mass that flows, per unit mass, m^2; the same value in the
                                    body and in the nozzle */
    vm_real gyration_transverse; /* inertia about a transverse axis of the mass that flows, per unit mass, while it is
                                    in the body, m^2 */
    vm_real gyration_out;        /* inertia of the mass in the nozzle about a transverse axis through the nozzle, per
                                    unit mass, m^2 */
    vm_real nozzle;              /* distance of the nozzle from the mass centre, m */
} vm_jet;

VM_API int vmi_masses_are_good(vm_real m0, vm_real m)
{
    return m0 > 0 && m > 0 && VM_IS_FINITE(m0) && VM_IS_FINITE(m);
}

/* Velocity of a body after a stream with the absolute velocity u has changed its mass from m0 to m (151), (171).
   v0 (m/s) is the velocity at the mass m0 (kg), u is in m/s, and `impulse` (N s) is the integral of the outer forces
   over the time of the change. u = 0 is Levi-Civita's case, in which the mass that joins or leaves is at rest. With
   moments of inertia instead of masses the function gives the angular velocity about a fixed axle. Returns NaN if a
   mass is not positive or if an argument is infinite or NaN. */
VM_API vm_real vm_velocity_by_momentum(vm_real v0, vm_real m0, vm_real m, vm_real u, vm_real impulse)
{
    if (!vmi_masses_are_good(m0, m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(u) || !VM_IS_FINITE(impulse)) return VM_NAN;
    if (m < m0) return v0 + ((m0 - m) * (v0 - u) + impulse) / m; /* v0 m0/m and u (m - m0)/m may nearly cancel */
    return v0 * (m0 / m) + (u * ((m - m0) / m) + impulse / m);
}

/* Velocity of Tsiolkovsky's rocket after its mass changes from m0 to m: v0 + w ln(m/m0), (175), (176).
   v0 (m/s) is the velocity at the mass m0 (kg), and w (m/s) is the velocity, relative to the body, of the mass that
   joins or leaves. There is no outer force. With moments of inertia instead of masses the function gives the angular
   velocity about a fixed axle. The error is at most 4 eps (|v0| + |w ln(m/m0)|). Returns NaN if a mass is not positive
   or if an argument is infinite or NaN. */
VM_API vm_real vm_tsiolkovsky(vm_real v0, vm_real m0, vm_real m, vm_real w)
{
    vm_two l;
    if (!vmi_masses_are_good(m0, m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(w)) return VM_NAN;
    if (m < 2 * m0 && m0 < 2 * m) l = vmi_two_log(vmi_two_sum(1, (m - m0) / m0)); /* m - m0 is exact here */
    else l = vmi_two_plus(vmi_log(m), vmi_minus(vmi_log(m0)));
    return v0 + w * l.hi;
}

/* Sets *first = ln(1 + x)/x and *second = (x - ln(1 + x))/x^2 for -1 < x < 1e299 (float 1e34), and both to NaN for
   other x. The two results are means over the time of a flow at constant rate. Let s grow from 0 at the start of this
   time to 1 at its end, and let m = 1 + x s be the mass divided by its initial value. Then *first is the mean of 1/m
   over s, and *second is the mean of s/m over s. */
VM_API void vmi_stream_log_means(vm_real x, vm_real *first, vm_real *second)
{
    const vm_two whole = vmi_two(x, 0), l = vmi_log1p(whole);
    *second = vmi_log1p_rest(whole, l).hi;
    if (VM_FABS(x) < VM_EPSILON) *first = 1 - x / 2;
    else *first = l.hi / x;
}

/* Position and velocity of a body on a line after t seconds, with a stream of constant rate.
   The position x0 (m), the velocity v0 (m/s) and the mass m0 (kg) belong to t = 0. The outer force (N) and the rate and
   the velocity of the stream are constant. t may be negative. Let m = m0 + rate t be the mass at the time t,
   tau = rate t/m0, L = ln(1 + tau)/tau and B = (tau - ln(1 + tau))/tau^2. If the stream has the absolute velocity u:
     v = v0 + (force + rate (u - v0)) t/m,        x = x0 + v0 t + (force + rate (u - v0)) B t^2/m0.
   If the stream has the velocity w relative to the body:
     v = v0 + (force + rate w) L t/m0,            x = x0 + v0 t + (force + rate w) (L - B) t^2/m0.
   If rate t >= 0, the errors of x and v are at most 8 eps times the sum of the absolute values of all terms. If the
   mass decreases, this bound grows with m0/m, because the rounding error of the product rate t becomes large compared
   with m. Returns VM_BAD_ARGUMENT for a null pointer and for an unknown `motion` of the stream; VM_NOT_FINITE if an
   argument or the result is infinite or NaN; VM_BAD_MASS if m0 or m is not positive; VM_OK otherwise. */
VM_API int vm_linear_flow(const vm_stream1 *stream, vm_real t, vm_real x0, vm_real v0, vm_real m0, vm_real force,
                          vm_real *x, vm_real *v)
{
    vm_real tau, first, second, difference, given = 0, acceleration, result[2];
    if (!stream || !x || !v || !vmi_stream_motion_is_known(stream->motion)) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(stream->rate) || !VM_IS_FINITE(stream->velocity) || !VM_IS_FINITE(t)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(x0) || !VM_IS_FINITE(v0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(force)) return VM_NOT_FINITE;
    if (!(m0 > 0)) return VM_BAD_MASS;
    tau = stream->rate * t / m0;
    if (!VM_IS_FINITE(tau)) return VM_NOT_FINITE;
    if (!(tau > -1)) return VM_BAD_MASS;
    vmi_stream_log_means(tau, &first, &second);
    if (vmi_stream_velocity_is_given(stream->motion)) given = stream->velocity;
    if (vmi_stream_moves_with_body(stream->motion)) {
        difference = first - second;
        if (tau < VM_C(-0.5)) difference = ((1 + tau) * first - 1) / tau; /* first - second would lose digits */
        acceleration = (force + stream->rate * given) / m0;
        result[0] = x0 + t * (v0 + acceleration * t * difference);
        result[1] = v0 + acceleration * t * first;
    } else {
        acceleration = (force + stream->rate * (given - v0)) / m0;
        result[0] = x0 + t * (v0 + acceleration * t * second);
        result[1] = v0 + acceleration * t / (1 + tau);
    }
    if (!vmi_all_finite(2, result)) return VM_NOT_FINITE;
    *x = result[0];
    *v = result[1];
    return VM_OK;
}

VM_API int vmi_jet_finite(const vm_jet *jet)
{
    return VM_IS_FINITE(jet->rate) && VM_IS_FINITE(jet->axial) && VM_IS_FINITE(jet->transverse) &&
           VM_IS_FINITE(jet->gyration_axial) && VM_IS_FINITE(jet->gyration_transverse) &&
           VM_IS_FINITE(jet->gyration_out) && VM_IS_FINITE(jet->nozzle);
}

/* Angular velocity of a spinning rocket whose jet damps it, after t seconds, rad/s, body axes.
   There are no outer loads. At the time t the body has the inertia A = A0 + rate gyration_transverse t about a
   transverse axis and C = C0 + rate gyration_axial t about the z axis. The part omega_t of the angular velocity that is
   perpendicular to z has the length
     |omega_t| = |omega_t0| (A/A0)^((nozzle^2 + gyration_out)/gyration_transverse - 1),
   where omega_t0 is omega_t at t = 0. The part omega_z along z stays constant, and omega_t turns about z by the angle
   omega_z times the integral of (C/A - 1) over time. Let L and B be the functions of tau explained at vm_linear_flow,
   here with tau = rate gyration_transverse t/A0. Then ln(A/A0) is tau L, and the integral is
   t (L C0/A0 - 1 + B rate t gyration_axial/A0). A relative error of eps in the inputs changes the result; the error of
   the function is at most 8 times this change. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument
   or the result is infinite or NaN; VM_BAD_INERTIA if A0, C0, A or C is not positive; VM_OK otherwise. */
VM_API int vm_jet_damping(const vm_jet *jet, vm_real t, vm_vec3 omega0, vm_vec3 *omega)
{
    vm_real change, tau, first, second, exponent, share, rest = 1, angle, sine, cosine;
    vm_vec3 later;
    if (!jet || !omega) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_vec3_is_finite(omega0) || !vmi_jet_finite(jet)) return VM_NOT_FINITE;
    if (!(jet->axial > 0 && jet->transverse > 0)) return VM_BAD_INERTIA;
    change = jet->rate * t / jet->transverse;
    tau = change * jet->gyration_transverse;
    exponent = change * (jet->nozzle * jet->nozzle + jet->gyration_out - jet->gyration_transverse);
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(exponent)) return VM_NOT_FINITE;
    if (!(tau > -1 && jet->axial + jet->rate * t * jet->gyration_axial > 0)) return VM_BAD_INERTIA;
    vmi_stream_log_means(tau, &first, &second);
    share = vmi_exp(exponent * first, 0);
    if (!(share >= VM_MIN && share <= VM_MAX)) {
        share = vmi_exp(exponent * first / 2, 0); /* the square root, because the whole is beyond the type's range */
        rest = share;
    }
    if (omega0.x == 0 && omega0.y == 0) share = rest = 0; /* where the exponential overflows, too */
    angle = omega0.z * t * (jet->axial / jet->transverse * first - 1 + change * jet->gyration_axial * second);
    vmi_sincos(angle, &sine, &cosine);
    later = vmi_vec3(share * (omega0.x * cosine - omega0.y * sine) * rest,
                     share * (omega0.y * cosine + omega0.x * sine) * rest, omega0.z);
    if (!vmi_vec3_is_finite(later)) return VM_NOT_FINITE;
    *omega = later;
    return VM_OK;
}

#endif
