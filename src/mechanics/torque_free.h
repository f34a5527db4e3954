/* mechanics/torque_free.h - exact rotation of a body on which no torque acts
   The rotation of a free body, for example after a part has separated from it, has a closed form (Jacobi 1850). The
   angular velocity omega follows from the elliptic functions sn, cn, dn of the time, and the attitude follows from one
   theta function and a rotation at a constant rate. Nothing is integrated. Therefore an evaluation costs the same at
   any time, and errors do not accumulate from evaluation to evaluation. The mass centre moves on a straight line.

       vm_torque_free motion;
       vm_body later; // body is a vm_body
       if (vm_torque_free_init(&motion, &body, 0) == VM_OK) vm_torque_free_at(&motion, 1e6, &later); // after 1e6 s

   The functions work for all bodies: for bodies with three different principal moments of inertia, with two equal ones
   and with three equal ones, and for rods and points. The spin of a rod or a point about an axis without moment of
   inertia stays constant. The functions also work for all rotations. Examples are a rotation about the axis of the
   middle moment of inertia, and the rotations on the separatrix. The separatrix is the set of all rotations that tend
   to a rotation about this axis as time grows. The user need not know which of these cases a motion belongs to. Tests:
   tests/test_torque_free.c. */
#ifndef VARMASS_MECHANICS_TORQUE_FREE_H
#define VARMASS_MECHANICS_TORQUE_FREE_H

#include <string.h>

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "../jacobi/integrals.h"
#include "../jacobi/theta.h"
#include "../jacobi/third_kind.h"
#include "bodies.h"
#include "torque_free_axes.h"
#include "vectors.h"

/* A motion prepared by vm_torque_free_init. The struct contains no pointers and may be copied. Read its fields, but do
   not change them.
   The next comment has the equations (A) and (B).

   Accuracy, for inputs taken as exact and up to 1e6 turns: the error of the attitude is at most 8 eps (rad) and that
   of omega at most 5 eps |omega|. This holds also close to the separatrix (1 - m from 1e-2 to 1e-27, where m is the
   parameter of sn, cn, dn), for nearly equal moments, and with products of inertia. An error of eps in an input changes
   the attitude by eps times the angle through which the body has turned. Close to the separatrix an input error
   changes the attitude by more, because it shifts the time of every flip of the body. (Close to the separatrix a body
   turns nearly uniformly about the axis of the middle moment for a long time and then flips over.) If a tensor has
   products of inertia, the principal moments are computed in two words (as sums of two vm_reals). The errors of these
   two words limit the accuracy after many turns close to the separatrix. A component of omega below 2^-505 (float
   2^-57) times the largest component is taken as 0. */
typedef struct VM_TAG(vm_torque_free) {
    vm_body body;                /* the body at the time t0; after vm_torque_free_init_principal the components of its
                                    omega are along the body axes */
    vm_real t0;                  /* the time at which the body has the state `body`, s */
    vmi_mat3 axes;               /* columns: the principal axes 1, 2, 3, right-handed, in body axes */
    vm_quat start;               /* rotation to inertial axes from axes whose axis 3 is along the angular momentum, or
                                    opposite to it if the component w3 of omega along axis 3 is negative */
    vm_real spin[3];             /* the components of omega along the axes 1, 2, 3 are spin[0] cn, spin[1] sn and
                                    spin[2] dn, rad/s */
    vm_real lean[3];             /* the quaternion M of equation (B) below is (w, x, y, 0)/sqrt(2 w), with
                                    w = 1 + lean[2] dn, x = lean[1] sn, y = lean[0] cn */
    vm_two phase;                /* u/(4K) at t0, where u is the argument of sn, cn, dn; u itself on the separatrix */
    vm_two phase_rate;           /* rate of the phase, 1/s */
    vm_two K;                    /* quarter period of sn as a function of u; 0 on the separatrix and if omega is
                                    constant */
    vm_two turn_rate;            /* mean rate, turns/s, of the angle s h in equation (B) below; s h is half the angle
                                    through which the body has turned about the angular momentum */
    vm_real m1;                  /* 1 - m, where m is the parameter of sn, cn, dn */
    vmi_theta_form far_form;     /* constants for sn, cn, dn at arguments far from 0; for m1 > 0.05 only k' */
    vmi_doubled_theta theta;     /* the theta function of equation (B) below, or its complex conjugate if sigma s < 0;
                                    its argument (angle) is s (h - kappa t) */
} vm_torque_free;

/* The solution. Let 1, 2, 3 be the principal axes of the body: axis 2 has the middle moment of inertia, and the vector
   omega moves around axis 3 in the body (torque_free_axes.h). Let I1, I2, I3 be the moments of inertia, T the kinetic
   energy and L the size of the angular momentum. Let d12 = |I1 - I2|, d23 = |I2 - I3|, d13 = |I1 - I3|,
   sigma = sign(I1 - I3) and s = sign(w3). The components w1, w2, w3 of omega along these axes are
     w1 = a1 cn u,  w2 = -sigma s a2 sn u,  w3 = s a3 dn u,  u = u0 + wp t,                                     (A)
     a1^2 = w1^2 + I2 d23/(I1 d13) w2^2,  a2^2 = a1^2 I1 d13/(I2 d23),  a3^2 = w3^2 + I2 d12/(I3 d13) w2^2,
     wp^2 = a3^2 d13 d23/(I1 I2),  m = I1 d12 a1^2/(I3 d23 a3^2),  1 - m = |2T I2 - L^2|/(I3 d23 a3^2),
   where w1, w2, w3 on the right-hand sides are the values at t0, t is the time since t0, and u0 is the value of u at
   t0. m is the parameter of sn, cn, dn. Let J be the tensor of inertia, l = J omega/L the unit vector along the angular
   momentum, l1, l2, l3 its components along the axes 1, 2, 3, and e3 the unit vector of axis 3. The attitude is the
   product of three quaternions:
     q(t) = start (cos h + s e3 sin h) M,  h = kappa t + sigma arg theta(u),                                    (B)
     M = (1 + |l3|, s l2, -s l1, 0)/sqrt(2 (1 + |l3|)).
   M is the rotation by the smallest angle that turns l into s e3. kappa is a constant that follows from an elliptic
   integral of the third kind. theta is a theta function of u + i y, where y follows from cd(y | 1 - m) = I3 a3/L. (B)
   was found by Jacobi; van Zon and Schofield, J. Comput. Phys. 225 (2007), give a theta series for 2h.

   The preparation computes in this order: the axes; the squares of the amplitudes a1, a2, a3, and m; kappa; the phase
   and the rates; the theta function; and `start`, for which q(t0) is the given attitude. The preparation computes in
   two words (sums of two vm_reals), because the rates wp/(4K) and kappa are multiplied by long times. An evaluation at
   a given time uses two words only for the products of rates and time. Moments and omega are divided by powers of two
   so that their values are about 1, which prevents overflow. */

/* ---- amplitudes and parameter ---- */

/* The fields a1, a2, a3 and L are the squares of the amplitudes a1, a2, a3 of equation (A) above and of L. The fields
   h1 and h3 are the squares of I1 a1 and I3 a3. m is the parameter of sn, cn, dn, and m1 = 1 - m. The formulas contain
   only one subtraction, in S = |2T I2 - L^2| (torque_free_axes.h), which is computed in three words (as a sum of three
   vm_reals). */
typedef struct VM_TAG(vmi_torque_free_squares) {
    vm_two a1, a2, a3, h1, h3, L, m1, m;
} vmi_torque_free_squares;

VM_API vmi_torque_free_squares vmi_torque_free_amplitudes(const vmi_torque_free_axes *axes)
{
    const vm_two ratio = vmi_two_over(vmi_two_times(axes->I2, axes->d23), vmi_two_times(axes->I1, axes->d13));
    const vm_two w2_square = vmi_two_times(axes->w2, axes->w2);
    vmi_torque_free_squares square;
    square.a1 = vmi_two_plus(vmi_two_times(axes->w1, axes->w1), vmi_two_times(ratio, w2_square));
    square.a2 = vmi_two_over(square.a1, ratio);
    square.a3 = vmi_two_times(axes->w3, axes->w3);
    square.m1 = vmi_two(1, 0);
    square.m = vmi_two(0, 0);
    if (!axes->symmetric) {
        const vm_two share = vmi_two_over(vmi_two_times(axes->I2, axes->d12), vmi_two_times(axes->I3, axes->d13));
        vm_two below;
        square.a3 = vmi_two_plus(square.a3, vmi_two_times(share, w2_square));
        below = vmi_two_times(vmi_two_times(axes->I3, axes->d23), square.a3);
        square.m1 = vmi_two_over(axes->S, below);
        square.m = vmi_two_over(vmi_two_times(vmi_two_times(axes->I1, axes->d12), square.a1), below);
    }
    square.h1 = vmi_two_times(vmi_two_times(axes->I1, axes->I1), square.a1);
    square.h3 = vmi_two_times(vmi_two_times(axes->I3, axes->I3), square.a3);
    square.L = vmi_two_plus(square.h1, square.h3);
    return square;
}

/* Stores m1 = 1 - m in *motion and prepares the functions sn, cn, dn for their parameter m. If m1 > 0.05, arguments up
   to K/2 are not far from 0 (VMI_NEAR); then far_form needs only k'. */
VM_API void vmi_torque_free_parameter(vm_torque_free *motion, vm_two m1)
{
    motion->m1 = m1.hi;
    motion->far_form.kp = VM_SQRT(m1.hi);
    if (m1.hi <= VM_C(0.05)) vmi_far_prepare(&motion->far_form, m1.hi, m1.lo);
}

/* Sets the fields `axes`, `spin` (the amplitudes of omega) and `lean` (the amplitudes of the quaternion M in equation
   (B) above). `sign` is a result of vmi_torque_free_phase: the sign of w1 on the separatrix, and 1 elsewhere. */
VM_API void vmi_torque_free_sizes(vm_torque_free *motion, const vmi_torque_free_axes *axes,
                                  const vmi_torque_free_squares *square, vm_real sign)
{
    const vm_real L = VM_SQRT(square->L.hi);
    motion->axes = axes->matrix;
    motion->spin[0] = sign * VM_SQRT(square->a1.hi);
    motion->spin[1] = -axes->sigma * axes->s * sign * VM_SQRT(square->a2.hi);
    motion->spin[2] = axes->s * VM_SQRT(square->a3.hi);
    motion->lean[0] = -axes->s * axes->I1.hi * motion->spin[0] / L;
    motion->lean[1] = axes->s * axes->I2.hi * motion->spin[1] / L;
    motion->lean[2] = axes->s * axes->I3.hi * motion->spin[2] / L;
}

/* ---- rates and phase ---- */

/* Returns 2 pi in two words, that is, as the sum of two vm_reals. */
VM_API vm_two vmi_torque_free_two_pi(void)
{
    const vmi_three half_pi = vmi_half_pi();
    return vmi_two(4 * half_pi.hi, 4 * half_pi.mid);
}

/* Returns 2 kappa for m < 1 and I1 != I2. Sets *mean to the arithmetic-geometric mean agm(1, k'), with k'^2 = 1 - m.
   Let Pi = Pi(-N | m) be the complete elliptic integral of the third kind with N = I3 d12/(I1 d23), K the complete
   integral of the first kind, and c = I3 a3/L. The other letters are explained at equation (A) above:
     2 kappa = L/I1 + L d13/(I1 I3) (1 - Pi/K + c mean/sqrt(1 + N))  if I1 > I3,
     2 kappa = L/I3 + L d13/(I1 I3) (    Pi/K - c mean/sqrt(1 + N))  if I1 < I3. */
VM_API vm_two vmi_torque_free_triaxial_rate(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square,
                                            vm_two *mean)
{
    const vm_two outer = vmi_two_times(axes->I2, axes->d13);
    const vm_two share = vmi_two_over(vmi_two_times(axes->I3, axes->d12), outer); /* N/(1 + N) */
    const vm_two below = vmi_two_over(vmi_two_times(axes->I1, axes->d23), outer); /* 1/(1 + N) */
    const vmi_third_kind third = vmi_third_kind_ladder(square->m1, share, below);
    const vm_two c_square = vmi_two_over(square->h3, square->L);
    const vm_two drift = vmi_two_times(vmi_two_root(vmi_two_times(c_square, below)), third.mean);
    vm_two bracket, first = axes->I3;
    if (axes->sigma > 0) {
        bracket = vmi_two_plus(third.rest, drift);
        first = axes->I1;
    } else bracket = vmi_two_minus(third.ratio, drift);
    bracket = vmi_two_times(vmi_two_over(axes->d13, vmi_two_times(axes->I1, axes->I3)), bracket);
    bracket = vmi_two_plus(bracket, vmi_two_over(vmi_two(1, 0), first));
    *mean = third.mean;
    return vmi_two_times(vmi_two_root(square->L), bracket);
}

/* Returns kappa, the mean rate of the angle h in equation (B) above. Sets *mean to the arithmetic-geometric mean
   agm(1, k') with k'^2 = 1 - m, which is 0 on the separatrix. */
VM_API vm_two vmi_torque_free_kappa(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square,
                                    vm_two *mean)
{
    const vm_two L = vmi_two_root(square->L);
    vm_two twice;
    if (axes->symmetric) { /* I1 = I2: k' = 1 and 2 kappa = (L + |w3| (I1 - I3))/I1 */
        *mean = vmi_two(1, 0);
        twice = vmi_two_times(vmi_two_root(square->a3), vmi_two_minus(axes->I1, axes->I3));
        twice = vmi_two_over(vmi_two_plus(L, twice), axes->I1);
    } else if (square->m1.hi == 0) { /* the motion tends to the rotation about axis 2 */
        *mean = vmi_two(0, 0);
        twice = vmi_two_over(L, axes->I2);
    } else twice = vmi_torque_free_triaxial_rate(axes, square, mean);
    return vmi_two_shifted(twice, VM_C(0.5));
}

/* Computes the argument u of equation (A) above at t0 from sn^2 = (w2/a2)^2 and cn^2 = (w1/a1)^2. Returns u/(4K), or u
   on the separatrix, where mean = 0. On the separatrix w1 can have either sign, but cn u is always positive. Therefore
   *sign is the sign of w1 on the separatrix, and 1 elsewhere. */
VM_API vm_two vmi_torque_free_phase(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square,
                                    vm_two mean, vm_real *sign)
{
    const vm_two sn_square = vmi_two_over(vmi_two_times(axes->w2, axes->w2), square->a2);
    const vm_two cn_square = vmi_two_over(vmi_two_times(axes->w1, axes->w1), square->a1);
    const vm_two dn_square = vmi_two_plus(cn_square, vmi_two_times(square->m1, sn_square));
    const vm_real forward = -axes->sigma * axes->s * axes->w2.hi < 0 ? -1 : 1; /* the sign of sn */
    vm_two F = vmi_two_times(vmi_two_root(sn_square), vmi_carlson_rf(cn_square, dn_square, vmi_two(1, 0)));
    *sign = 1;
    if (mean.hi > 0) {
        F = vmi_two_over(vmi_two_times(F, mean), vmi_torque_free_two_pi());
        if (axes->w1.hi < 0) F = vmi_two_minus(vmi_two(VM_C(0.5), 0), F); /* cn < 0: u/(4K) is 1/2 - F */
    } else if (axes->w1.hi < 0) *sign = -1;
    return vmi_two_shifted(F, forward * *sign);
}

/* Sets the fields K, phase, phase_rate and turn_rate. The two rates belong to the scaled omega, that is, to omega
   divided by a power of two. Returns the sign of w1 on the separatrix, and 1 elsewhere. */
VM_API vm_real vmi_torque_free_rates(vm_torque_free *motion, const vmi_torque_free_axes *axes,
                                     const vmi_torque_free_squares *square)
{
    const vm_two two_pi = vmi_torque_free_two_pi();
    const vm_two above = vmi_two_times(square->a3, vmi_two_times(axes->d13, axes->d23));
    const vm_two wp = vmi_two_root(vmi_two_over(above, vmi_two_times(axes->I1, axes->I2)));
    vm_two mean;
    const vm_two kappa = vmi_torque_free_kappa(axes, square, &mean);
    vm_real sign;
    motion->turn_rate = vmi_two_over(vmi_two_shifted(kappa, axes->s), two_pi);
    motion->phase = vmi_torque_free_phase(axes, square, mean, &sign);
    motion->phase_rate = wp;
    if (mean.hi > 0) { /* 4K = 2 pi/mean */
        motion->phase_rate = vmi_two_over(vmi_two_times(wp, mean), two_pi);
        motion->K = vmi_two_over(vmi_two_shifted(two_pi, VM_C(0.25)), mean);
    }
    return sign;
}

/* ---- the theta function ---- */

/* Returns y, the constant imaginary part of the argument u + i y of the theta function in equation (B) above. y solves
   cd(y | 1 - m) = c with c = I3 a3/L. The solution is y = R_F(N, N/c^2, N + 1), where N = I3 d12/(I1 d23) and R_F is
   Carlson's elliptic integral of the first kind. */
VM_API vm_real vmi_torque_free_imaginary(const vmi_torque_free_axes *axes, const vmi_torque_free_squares *square)
{
    const vm_two N = vmi_two_over(vmi_two_times(axes->I3, axes->d12), vmi_two_times(axes->I1, axes->d23));
    const vm_two c_square = vmi_two_over(square->h3, square->L);
    return vmi_carlson_rf(N, vmi_two_over(N, c_square), vmi_two_plus(N, vmi_two(1, 0))).hi;
}

/* Sets the theta function of equation (B) above, or its complex conjugate if sigma s < 0. For m = 0 the theta function
   stays 1. K and Kc are the quarter periods for the parameters m and 1 - m. The series of the theta function is used
   directly for K <= 2 Kc, and after Jacobi's transformation for K > 2 Kc, where it converges faster. */
VM_API void vmi_torque_free_theta(vm_torque_free *motion, const vmi_torque_free_axes *axes,
                                  const vmi_torque_free_squares *square)
{
    const vm_real sign = axes->sigma * axes->s;
    vm_real K = VM_INFINITY, Kc = VM_PI / 2, y;
    int k;
    if (square->m.hi == 0) return;
    if (motion->K.hi > 0) {
        K = motion->K.hi;
        Kc = jacobi_K_m1(square->m.hi);
    }
    y = vmi_torque_free_imaginary(axes, square);
    motion->theta = K > 2 * Kc ? vmi_doubled_dual(K, Kc, y) : vmi_doubled_direct(K, Kc, y);
    motion->theta.shift *= sign;
    for (k = 0; k < 4; k++) motion->theta.im[k] *= sign;
}

/* ---- the motion as a whole ---- */

/* Sets the fields of *motion for a rotation with constant omega. Axis 3 is along omega, and the elliptic function sn
   stays 0. If omega is 0, no field is set. */
VM_API void vmi_torque_free_constant(vm_torque_free *motion, const vmi_torque_free_body *b)
{
    const vm_two size = vmi_two_root(vmi_vec3_two_dot(&b->omega, &b->omega));
    int k;
    if (size.hi == 0) return;
    for (k = 0; k < 3; k++) {
        const vm_real cosine = vmi_two_over(b->omega.x[k], size).hi;
        motion->axes.z = vm_add(motion->axes.z, vm_scale(cosine, vmi_vec3_two_high_words(&b->axis[k])));
    }
    motion->spin[2] = size.hi;
    motion->turn_rate = vmi_two_over(vmi_two_shifted(size, VM_C(0.5)), vmi_torque_free_two_pi());
}

/* Sets all fields except body, t0 and `start`. The fields spin, phase_rate and turn_rate belong to the scaled omega,
   that is, to omega divided by a power of two. */
VM_API void vmi_torque_free_prepare(vm_torque_free *motion, const vmi_torque_free_body *b)
{
    const vm_real least_nutation = vmi_fourth_power(VM_EPSILON); /* square of the angle eps^2, a negligible nutation */
    const vmi_torque_free_axes axes = vmi_torque_free_order(b);
    vmi_torque_free_squares square;
    int constant = vmi_torque_free_is_constant(&axes);
    if (!constant) {
        square = vmi_torque_free_amplitudes(&axes);
        constant = square.h1.hi <= least_nutation * square.h3.hi;
    }
    if (constant) {
        vmi_torque_free_constant(motion, b);
        return;
    }
    vmi_torque_free_sizes(motion, &axes, &square, vmi_torque_free_rates(motion, &axes, &square));
    vmi_torque_free_theta(motion, &axes, &square);
    vmi_torque_free_parameter(motion, square.m1);
}

/* ---- at a time ---- */

/* Returns the product rate t, in turns, minus a whole number of turns. The result lies between -1 and 1. The result has
   no meaning beyond 2^(2p - 4) turns, where p is the number of binary digits of the type vm_real. */
VM_API vm_two vmi_torque_free_fraction(vm_two rate, vm_two t)
{
    const vm_two p = vmi_two_product(rate.hi, t.hi);
    vm_real low = p.lo + (rate.lo * t.hi + rate.hi * t.lo);
    if (VM_FABS(low) > VM_C(0.5)) low -= VM_FLOOR(low + VM_C(0.5));
    return vmi_two_sum(p.hi - VM_FLOOR(p.hi + VM_C(0.5)), low);
}

/* Computes the elliptic functions sn, cn, dn at the time t after t0. Let u be their argument. Returns u/(4K) minus the
   nearest multiple of 1/2; on the separatrix it returns u. */
VM_API vm_real vmi_torque_free_functions(const vm_torque_free *motion, vm_two t, vm_real *sn, vm_real *cn,
                                         vm_real *dn)
{
    const vm_real longest = VM_MANT_DIG > 24 ? 700 : 80; /* sech(longest) is close to the smallest number of the type */
    vmi_thetas theta;
    vm_real turns;
    int half_turns = 0, quarters = 0;
    vm_two v; /* first u/(4K), then the argument u of sn, cn, dn minus the nearest multiple of K */
    if (motion->K.hi > 0) {
        v = vmi_two_plus(vmi_torque_free_fraction(motion->phase_rate, t), motion->phase);
        half_turns = vmi_nearest(2 * v.hi);
        v = vmi_two_sum(v.hi - (vm_real)half_turns / 2, v.lo);
        turns = v.hi;
        quarters = vmi_nearest(4 * turns);
        v = vmi_two_times(vmi_two_sum(4 * turns - (vm_real)quarters, 4 * v.lo), motion->K);
    } else {
        v = vmi_two_plus(vmi_two_times(motion->phase_rate, t), motion->phase);
        if (VM_FABS(v.hi) > longest) v = vmi_two(VM_COPYSIGN(longest, v.hi), 0);
        turns = v.hi;
    }
    if (v.hi * v.hi > VMI_NEAR) theta = vmi_theta_far(&motion->far_form, 0, v);
    else theta = vmi_theta_near(v.hi, motion->m1); /* also for NaN */
    theta = vmi_theta_shift(theta, motion->far_form.kp, (vmi_bits)((quarters + 2 * half_turns) & 3));
    vmi_theta_ratios(theta, motion->far_form.kp, sn, cn, dn);
    return turns;
}

/* Evaluates equations (A) and (B) above at the time t after t0. Sets *omega to the angular velocity in body axes, and
   *turn to the factor (cos h + s e3 sin h) M of the attitude. */
VM_API void vmi_torque_free_at(const vm_torque_free *motion, vm_two t, vm_vec3 *omega, vm_quat *turn)
{
    vm_real sn, cn, dn, re, im, sine, cosine, w, x, y, over, c, s;
    const vm_real turns = vmi_torque_free_functions(motion, t, &sn, &cn, &dn);
    vmi_doubled_at(&motion->theta, turns, &re, &im);
    vmi_sincos_turns(vmi_torque_free_fraction(motion->turn_rate, t).hi + motion->theta.shift * turns, &sine, &cosine);
    w = 1 + motion->lean[2] * dn; /* the quaternion M of (B) is (w, x, y, 0)/sqrt(2 w) */
    x = motion->lean[1] * sn;
    y = motion->lean[0] * cn;
    over = 1 / VM_SQRT(2 * w * (re * re + im * im));
    c = over * (cosine * re - sine * im); /* cos(s h) and sin(s h), with the s of (B), divided by sqrt(2 w) */
    s = over * (sine * re + cosine * im);
    *turn = vmi_quat(c * w, vmi_times(&motion->axes, vmi_vec3(c * x - s * y, c * y + s * x, s * w)));
    *omega = vmi_times(&motion->axes, vmi_vec3(motion->spin[0] * cn, motion->spin[1] * sn, motion->spin[2] * dn));
}

/* ---- setting up ---- */

/* Returns the attitude q, or a unit quaternion for it if the length of q is within 64 eps of 1. Each call of
   vm_torque_free_rotation changes the length by up to 0.4 eps. Without this correction the changes would add up if
   each call starts from the result of the previous call. If the length differs from 1 by at most 4 eps, q is returned
   without any change. */
VM_API vm_quat vmi_torque_free_attitude_at_start(vm_quat q)
{
    const vm_real excess = VM_FABS(vmi_quat_square(q) - 1); /* twice the length's difference from 1 */
    if (vmi_quat_is_none(q)) q.w = 1;
    else if (excess > 8 * VM_EPSILON && excess < 128 * VM_EPSILON) q = vm_unit_quat(q);
    return q;
}

/* Sets all fields that vm_torque_free_at needs. *b must contain the principal moments, the principal axes, and omega
   divided by `power`, which is a power of two. */
VM_API void vmi_torque_free_solve(vm_torque_free *motion, const vmi_torque_free_body *b, vm_real power)
{
    const vm_quat q = vmi_torque_free_attitude_at_start(motion->body.q);
    vm_quat turn;
    vm_vec3 omega;
    int k;
    vmi_torque_free_parameter(motion, vmi_two(1, 0)); /* m = 0 and u = 0: sn = 0, cn = dn = 1 */
    motion->theta.re[0] = 1;
    motion->lean[2] = 1;
    vmi_torque_free_prepare(motion, b);
    vmi_torque_free_at(motion, vmi_two(0, 0), &omega, &turn);
    turn = vmi_quat(turn.w, vm_scale(-1, vmi_quat_vector(turn)));
    motion->start = vm_quat_times(q, turn);
    for (k = 0; k < 3; k++) motion->spin[k] *= power;
    motion->phase_rate = vmi_two_shifted(motion->phase_rate, power);
    motion->turn_rate = vmi_two_shifted(motion->turn_rate, power);
}

/* Returns x, a component of the scaled omega (omega divided by a power of two). If |x| is below 2^-505 (float 2^-57),
   the square of x would underflow, and the function returns 0 instead. */
VM_API vm_two vmi_torque_free_squarable(vm_two x)
{
    return VM_FABS(x.hi) < 64 * VM_SQRT(VM_MIN) ? vmi_two(0, 0) : x;
}

/* Prepares the motion of a body whose omega is given in body axes if along_body = 1, and in inertial axes if
   along_body = 0. Returns a status of vm_torque_free_init. */
VM_API int vmi_torque_free_start(vm_torque_free *motion, const vm_body *body, int along_body, vm_real t0)
{
    const vm_real power = vmi_power_below(vmi_norm_max(body->omega));
    vm_torque_free m;
    vmi_torque_free_body b;
    vmi_vec3_two omega;
    int status, k;
    if (!VM_IS_FINITE(t0)) return VM_NOT_FINITE;
    status = vmi_check_body(body);
    if (status) return status;
    memset(&m, 0, sizeof m);
    m.body = *body;
    m.t0 = t0;
    omega = vmi_vec3_two_over(body->omega, power);
    if (!along_body && vmi_norm_max(vmi_quat_vector(body->q)) > 0) omega = vmi_vec3_two_turned_back(body->q, &omega);
    vmi_torque_free_principal(&body->inertia, &b);
    vmi_torque_free_clamp_moments(&body->inertia, &b);
    for (k = 0; k < 3; k++) b.omega.x[k] = vmi_torque_free_squarable(vmi_vec3_two_dot(&b.axis[k], &omega));
    vmi_torque_free_solve(&m, &b, power);
    *motion = m;
    return VM_OK;
}

/* Prepares the exact torque-free motion of a body. *body is the body at the time t0 (s). vm_torque_free_at then gives
   the body at any time. The accuracy is described at vm_torque_free. Returns VM_BAD_ARGUMENT for a null pointer;
   VM_NOT_FINITE if t0 or a number of *body is infinite or NaN; VM_BAD_MASS if the mass is not positive; VM_BAD_INERTIA
   if no body can have the inertia; VM_OK otherwise. After an error *motion is unchanged. */
VM_API int vm_torque_free_init(vm_torque_free *motion, const vm_body *body, vm_real t0)
{
    if (!motion || !body) return VM_BAD_ARGUMENT;
    return vmi_torque_free_start(motion, body, 0, t0);
}

/* Prepares the exact torque-free motion of a body with the principal moments `moments` (kg m^2). The body axes are the
   principal axes. The components of omega (rad/s) are along the body axes, not along the inertial axes. q is the
   attitude at t0 (s). The body has the mass 1 kg, and its mass centre rests at the origin. The statuses are those of
   vm_torque_free_init. */
VM_API int vm_torque_free_init_principal(vm_torque_free *motion, vm_vec3 moments, vm_quat q, vm_vec3 omega,
                                         vm_real t0)
{
    vm_body body;
    if (!motion) return VM_BAD_ARGUMENT;
    memset(&body, 0, sizeof body);
    body.mass = 1;
    body.inertia.xx = moments.x;
    body.inertia.yy = moments.y;
    body.inertia.zz = moments.z;
    body.q = q;
    body.omega = omega;
    return vmi_torque_free_start(motion, &body, 1, t0);
}

/* Attitude and angular velocity of a torque-free body at the time t (s). t may be later or earlier than t0. *omega has
   the components along the body axes, rad/s. *q is continuous in t and keeps the length that the quaternion had at t0.
   If the quaternion at t0 was all zero, or if its length was within 64 eps of 1, the length of *q is 1. Returns
   VM_BAD_ARGUMENT for a null pointer, VM_NOT_FINITE if t or the result is not finite or if t, the number of turns or
   the number of turns per second is above about 1e300 (float 8e34), and VM_OK otherwise. After an error *q and *omega
   are unchanged. Beyond 1/eps^2 turns the result is finite and has the right angular momentum, but the angle through
   which the body has turned has no correct digits. */
VM_API int vm_torque_free_attitude(const vm_torque_free *motion, vm_real t, vm_quat *q, vm_vec3 *omega)
{
    const vm_real largest_factor = VM_MAX / VM_SPLIT; /* products in two words split their factors */
    vm_two elapsed;
    vm_real reach;
    vm_vec3 w;
    vm_quat turn;
    if (!motion || !q || !omega) return VM_BAD_ARGUMENT;
    elapsed = vmi_two_sum(t, -motion->t0);
    reach = VM_FABS(motion->phase_rate.hi) + VM_FABS(motion->turn_rate.hi);
    if (!((1 + reach) * (1 + VM_FABS(elapsed.hi)) < largest_factor)) return VM_NOT_FINITE;
    vmi_torque_free_at(motion, elapsed, &w, &turn);
    turn = vm_quat_times(motion->start, turn);
    if (!vmi_vec3_is_finite(w) || !vmi_quat_is_finite(turn)) return VM_NOT_FINITE;
    *q = turn;
    *omega = w;
    return VM_OK;
}

/* Sets *body to the body of *motion at the time t (s). t may be later or earlier than t0. The attitude and omega are
   those of vm_torque_free_attitude, but here omega has its components along the inertial axes. The mass centre has
   moved on a straight line at constant velocity. The statuses are those of vm_torque_free_attitude; after an error
   *body is unchanged. */
VM_API int vm_torque_free_at(const vm_torque_free *motion, vm_real t, vm_body *body)
{
    vm_body b;
    vmi_mat3 turn;
    int status;
    if (!motion || !body) return VM_BAD_ARGUMENT;
    b = motion->body;
    status = vm_torque_free_attitude(motion, t, &b.q, &b.omega);
    if (status) return status;
    turn = vmi_rotation(b.q);
    b.omega = vmi_times(&turn, b.omega);
    b.r = vm_add(b.r, vm_scale(t - motion->t0, b.v));
    if (!vmi_body_is_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* Sets *later to the torque-free body *body after the time t (s). The function calls vm_torque_free_init, then
   vm_torque_free_at, and returns their statuses. The pointers `later` and `body` may be equal. */
VM_API int vm_torque_free_rotation(const vm_body *body, vm_real t, vm_body *later)
{
    vm_torque_free motion;
    int status;
    if (!body || !later) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vm_torque_free_init(&motion, body, 0);
    return status ? status : vm_torque_free_at(&motion, t, later);
}

#endif
