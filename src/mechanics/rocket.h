/* mechanics/rocket.h - closed forms: Tsiolkovsky's rocket, linear flow, jet damping */
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

/* Jet damping of an axisymmetric body without outer loads: omega after t, body axes, z the axis of symmetry. Mass
   is taken from around the mass centre, which stays, and leaves through a nozzle on the axis (or the other way
   round); A, C are the transverse and the axial moment of inertia, A' = rate gyration_transverse, C' = rate
   gyration_axial:
     |omega_t| = |omega_t0| (A/A0)^((nozzle^2 + gyration_out)/gyration_transverse - 1),
     omega_z constant, phase of omega_t: omega_z integral (C/A - 1) dt
   Within 8 eps of what an eps in the inputs makes; VM_BAD_INERTIA where A or C is not positive, VM_NOT_FINITE */
typedef struct VM_TAG(vm_jet) {
    vm_real rate;                /* kg/s, < 0: leaves */
    vm_real axial, transverse;   /* C0, A0, kg m^2 */
    vm_real gyration_axial;      /* m^2, of what is stored and, alike, of what crosses */
    vm_real gyration_transverse; /* m^2, of what is stored, */
    vm_real gyration_out;        /* and of what crosses */
    vm_real nozzle;              /* m, from the mass centre */
} vm_jet;

/* Closed forms */
/* ln(1 + x)/x and (x - ln(1 + x))/x^2 for -1 < x < 1e299 (float 1e34; NaN beyond), within 2 ulp */
VM_API void vmi_stream_log_means(vm_real x, vm_real *first, vm_real *second)
{
    const vm_two whole = vmi_two(x, 0), l = vmi_log1p(whole);
    *second = vmi_log1p_rest(whole, l).hi;
    *first = VM_FABS(x) < VM_EPSILON ? 1 - x / 2 : l.hi / x;
}

/* Documented with vm_velocity_by_momentum. */
VM_API vm_real vm_tsiolkovsky(vm_real v0, vm_real m0, vm_real m, vm_real w)
{
    vm_two l;
    if (!(m0 > 0 && m > 0) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(m)) return VM_NAN;
    if (!VM_IS_FINITE(v0) || !VM_IS_FINITE(w)) return VM_NAN;
    if (m < 2 * m0 && m0 < 2 * m) l = vmi_two_log(vmi_two_sum(1, (m - m0) / m0)); /* m - m0 is exact */
    else l = vmi_two_plus(vmi_log(m), vmi_minus(vmi_log(m0)));
    return v0 + w * l.hi;
}

/* Position and velocity after t under constant rate, force and velocity of the stream (VM_RELATIVE, VM_ABSOLUTE),
   through rate = 0 without loss: 8 eps of the terms; VM_BAD_MASS where m0 + rate t or m0 is not positive */
/* With tau = rate t/m0, L = ln(1 + tau)/tau, B = (tau - ln(1 + tau))/tau^2, constant force and u:
     v - v0 = (force + rate (u - v0)) t/m,        x = x0 + v0 t + (force + rate (u - v0)) t^2/m0 B
   as M (v - u) + const; and with constant w:
     v - v0 = (force + rate w) t/m0 L,            x = x0 + v0 t + (force + rate w) t^2/m0 (L - B) */
VM_API int vm_linear_flow(vm_real t, vm_real x0, vm_real v0, vm_real m0, vm_real force, const vm_stream1 *stream,
                          vm_real *x, vm_real *v)
{
    vm_real tau, first, second, less, pull, result[2];
    if (!stream || !x || !v || !vmi_stream_motion_is_known(stream->motion)) return VM_BAD_ARGUMENT;
    if (!(m0 > 0)) return VM_BAD_MASS;
    tau = stream->rate * t / m0;
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(m0) || !VM_IS_FINITE(stream->velocity)) return VM_NOT_FINITE;
    if (!(tau > -1)) return VM_BAD_MASS;
    vmi_stream_log_means(tau, &first, &second);
    less = tau < VM_C(-0.5) ? ((1 + tau) * first - 1) / tau : first - second; /* near -1 both are large */
    pull = stream->motion == VM_RELATIVE || stream->motion == VM_ABSOLUTE ? stream->velocity : 0;
    if (stream->motion == VM_RELATIVE || stream->motion == VM_CARRIED) {
        pull = (force + stream->rate * pull) / m0;
        result[1] = v0 + pull * t * first;
        result[0] = x0 + t * (v0 + pull * t * less);
    } else {
        pull = (force + stream->rate * (pull - v0)) / m0;
        result[1] = v0 + pull * t / (1 + tau);
        result[0] = x0 + t * (v0 + pull * t * second);
    }
    if (!vmi_all_finite(2, result)) return VM_NOT_FINITE;
    *x = result[0];
    *v = result[1];
    return VM_OK;
}

/* With tau = rate gyration t/A0 and c likewise: ln(A/A0) = tau L, integral (C/A - 1) dt = t (C0/A0 L - 1 + rate t
   gyration_axial/A0 B) */
VM_API int vm_jet_damping(vm_real t, const vm_jet *jet, vm_vec3 omega0, vm_vec3 *omega)
{
    vm_real change, tau, first, second, decay, sine, cosine;
    vm_vec3 later;
    if (!jet || !omega) return VM_BAD_ARGUMENT;
    if (!(jet->axial > 0 && jet->transverse > 0)) return VM_BAD_INERTIA;
    change = jet->rate * t / jet->transverse;
    tau = change * jet->gyration_transverse;
    decay = change * (jet->nozzle * jet->nozzle + jet->gyration_out - jet->gyration_transverse);
    if (!VM_IS_FINITE(tau) || !VM_IS_FINITE(decay) || !VM_IS_FINITE(jet->axial) || !VM_IS_FINITE(jet->transverse))
        return VM_NOT_FINITE;
    if (!(tau > -1 && jet->axial + jet->rate * t * jet->gyration_axial > 0)) return VM_BAD_INERTIA;
    vmi_stream_log_means(tau, &first, &second);
    decay = vmi_exp(decay * first, 0);
    vmi_sincos(omega0.z * t * (jet->axial / jet->transverse * first - 1 + change * jet->gyration_axial * second),
               &sine, &cosine);
    later = vmi_vec3(decay * (omega0.x * cosine - omega0.y * sine), decay * (omega0.y * cosine + omega0.x * sine),
                     omega0.z);
    if (!vmi_vec3_finite(later)) return VM_NOT_FINITE;
    *omega = later;
    return VM_OK;
}

#endif
