/* oscillators/jeffcott.h - the Jeffcott (Laval) rotor with variable mass */
#ifndef VARMASS_OSCILLATORS_JEFFCOTT_H
#define VARMASS_OSCILLATORS_JEFFCOTT_H

#include "../ateb/phase.h"
#include "../base/complex.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "slow.h"

/* The disc's centre z = x + i y (451), with the shaft's stiffness F_e(rho)/rho, which [1] calls F_e', and the
   gyroscopic constant g = Omega_p g of the remark after (516):
     m z'' + z F_e(|z|)/|z| - 2 i g z' = F_z + r m' (u - z')
   A zero field means none; mass and stiffness must be there. */
/* F_e(rho)/rho, N/m, and its derivative, for rho >= 0. vm_jeffcott_power is k rho^(alpha-1), ctx a vm_power_force. */
typedef vm_real (*vm_jeffcott_stiffness)(vm_real rho, vm_real *slope, void *ctx);
typedef vm_complex (*vm_jeffcott_force)(vm_real t, vm_complex z, vm_complex v, void *ctx);

typedef struct VM_TAG(vm_power_force) {
    vm_real k, alpha;
} vm_power_force;

typedef struct VM_TAG(vm_jeffcott) {
    vm_slow_mass mass;
    void *mass_ctx;
    vm_jeffcott_stiffness stiffness;
    void *stiffness_ctx;
    vm_jeffcott_force force; /* F_z, N; small where averaged */
    void *force_ctx;
    vm_real gyro;     /* kg/s */
    vm_real reactive; /* r */
    vm_complex u;     /* absolute velocity of what joins or leaves, m/s */
    int samples;      /* of a period in an average; default 32, enough for polynomials of degree 15 */
} vm_jeffcott;

VM_API vm_real vm_jeffcott_power(vm_real rho, vm_real *slope, void *power_force)
{
    if (!slope || !power_force) return VM_NAN;
    const vm_power_force *p = (const vm_power_force *)power_force;
    *slope = p->alpha == 1 ? 0 : p->k * (p->alpha - 1) * vmi_pow_checked(rho, p->alpha - 2);
    return p->k * vmi_pow_checked(rho, p->alpha - 1);
}

/* rho and phi in (-pi, pi] (448) */
VM_API void vm_jeffcott_polar(vm_complex z, vm_real *rho, vm_real *phi)
{
    if (!rho || !phi) return;
    *rho = vmi_c_modulus(z);
    *phi = ateb_phase(z.im, z.re, 1);
}

/* Angular momentum Im(conj z m z') - g |z|^2, kg m^2/s: constant where r = 1, u = 0, F_z = 0 */
VM_API vm_real vm_jeffcott_momentum(const vm_jeffcott *r, vm_real mass, vm_complex z, vm_complex v)
{
    if (!r) return VM_NAN;
    return mass * (z.re * v.im - z.im * v.re) - r->gyro * (z.re * z.re + z.im * z.im);
}

/* F_e(rho)/rho, NaN where there is none */
VM_API vm_real vmi_jeffcott_stiffness(const vm_jeffcott *r, vm_real rho, vm_real *slope)
{
    *slope = VM_NAN;
    return r->stiffness ? r->stiffness(rho, slope, r->stiffness_ctx) : VM_NAN;
}

/* F_z + r m' u */
VM_API vm_complex vmi_jeffcott_drive(const vm_jeffcott *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    const vm_complex thrust = vmi_c_scale(r->reactive * rate, r->u);
    return r->force ? vmi_c_add(r->force(t, z, v, r->force_ctx), thrust) : thrust;
}

/* Equations of motion (449), (450) for rk45 or rk87, ctx a vm_jeffcott, y = (x, y, x', y') */
VM_API int vm_jeffcott_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    const vm_complex z = vmi_complex(y[0], y[1]), v = vmi_complex(y[2], y[3]);
    vm_real mass, rate, stiffness, slope;
    vm_complex force;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &mass, &rate);
    if (status) return status;
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    stiffness = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope);
    force = vmi_c_add(vmi_jeffcott_drive(r, t, rate, z, v), vmi_c_times_i(2 * r->gyro, v));
    dydt[0] = v.re;
    dydt[1] = v.im;
    dydt[2] = (force.re - r->reactive * rate * v.re - stiffness * z.re) / mass;
    dydt[3] = (force.im - r->reactive * rate * v.im - stiffness * z.im) / mass;
    return VM_OK;
}

typedef struct VM_TAG(vmi_jeffcott_state) {
    vm_real mass, rate, omega; /* omega of the small vibration */
} vmi_jeffcott_state;

VM_API int vmi_jeffcott_now(const vm_jeffcott *r, vm_real t, vmi_jeffcott_state *now)
{
    vm_real slope;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &now->mass, &now->rate);
    if (status) return status;
    now->omega = VM_SQRT(vmi_jeffcott_stiffness(r, 0, &slope) / now->mass);
    return now->omega > 0 && VM_IS_FINITE(now->omega) ? VM_OK : VM_DOMAIN;
}

/* Small nonlinearity: two circular motions (460), (461) of the frequency omega = sqrt(F_e'(0)/m),
     z = P e^(i phi) + N e^(-i phi),  z' = i omega (P e^(i phi) - N e^(-i phi)),
     P = A1 e^(i theta1),  N = A2 e^(-i theta2),
   y = (Re P, Im P, Re N, Im N, phi), phi' = omega, from and to y = (x, y, x', y') at time t. The equations
   (470)-(473) exactly, and averaged over phi while P and N stay: forward and backward motion are in 1:1 resonance,
   so that the average over psi1 and psi2 apart, (474)-(477), is wrong unless f turns with z. In P and N nothing is
   singular where A1 or A2 is 0. All that differs from m z'' + F_e'(0) z = 0 is perturbation: F_z, u, g, F_e'(rho) -
   F_e'(0). */
VM_API int vm_jeffcott_to_averaged(const vm_jeffcott *r, vm_real t, const vm_real *motion, vm_real phi, vm_real *y)
{
    if (!r || !motion || !y) return VM_BAD_ARGUMENT;
    const vm_complex z = vmi_complex(motion[0], motion[1]), back = vmi_c_turn(-phi);
    vmi_jeffcott_state now;
    vm_complex turned, P, N;
    vm_real found[5];
    const int status = vmi_jeffcott_now(r, t, &now);
    if (status) return status;
    turned = vmi_c_times_i(-1 / now.omega, vmi_complex(motion[2], motion[3])); /* z'/(i omega) */
    P = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_add(z, turned)), back);
    N = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_sub(z, turned)), vmi_c_conjugate(back));
    found[0] = P.re;
    found[1] = P.im;
    found[2] = N.re;
    found[3] = N.im;
    found[4] = phi;
    return vmi_copy_if_finite(5, found, y);
}

/* z and z' where phi is the angle of turn */
VM_API void vmi_jeffcott_motion(const vm_real *y, vm_complex turn, vm_real omega, vm_complex *z, vm_complex *v)
{
    const vm_complex P = vmi_c_times(vmi_complex(y[0], y[1]), turn);
    const vm_complex N = vmi_c_times(vmi_complex(y[2], y[3]), vmi_c_conjugate(turn));
    *z = vmi_c_add(P, N);
    *v = vmi_c_times_i(omega, vmi_c_sub(P, N));
}

/* Documented with vm_jeffcott_to_averaged. */
VM_API int vm_jeffcott_from_averaged(const vm_jeffcott *r, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!r || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_jeffcott_state now;
    vm_complex z, v;
    vm_real joined[4];
    const int status = vmi_jeffcott_now(r, t, &now);
    if (status) return status;
    vmi_jeffcott_motion(y, vmi_c_turn(y[4]), now.omega, &z, &v);
    joined[0] = z.re;
    joined[1] = z.im;
    joined[2] = v.re;
    joined[3] = v.im;
    return vmi_copy_if_finite(4, joined, motion);
}

/* P' and N' (470)-(473) at the fast phase phi:
     P' = -i e^(-i phi) f/(2 omega),  N' = i e^(i phi) f/(2 omega),
     m f = F + 2 i g z' - (F_e' - F_e'(0)) z - (r - 1/2) m' z'
   F with r m' u; the half that is missing from r comes from omega'. */
VM_API void vmi_jeffcott_rates(const vm_jeffcott *r, vm_real t, const vmi_jeffcott_state *now, const vm_real *y, vm_real phi,
                            vm_complex *dP, vm_complex *dN)
{
    const vm_complex turn = vmi_c_turn(phi);
    const vm_real push = 1 / (2 * now->omega * now->mass);
    vm_real slope, extra;
    vm_complex z, v, f;
    vmi_jeffcott_motion(y, turn, now->omega, &z, &v);
    extra = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope) - now->mass * now->omega * now->omega;
    f = vmi_c_add(vmi_jeffcott_drive(r, t, now->rate, z, v), vmi_c_times_i(2 * r->gyro, v));
    f = vmi_c_sub(f, vmi_c_add(vmi_c_scale(extra, z), vmi_c_scale((r->reactive - VM_C(0.5)) * now->rate, v)));
    *dP = vmi_c_times_i(-push, vmi_c_times(f, vmi_c_conjugate(turn)));
    *dN = vmi_c_times_i(push, vmi_c_times(f, turn));
}

VM_API int vmi_jeffcott_samples(const vm_jeffcott *r) { return r->samples > 0 ? r->samples : 32; }

/* The mean of so many samples in a period from y[4] on */
VM_API int vmi_jeffcott_mean(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int samples)
{
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    const vm_real share = 1 / (vm_real)samples;
    vm_complex P = {0, 0}, N = {0, 0}, dP, dN;
    vmi_jeffcott_state now;
    const int status = vmi_jeffcott_now(r, t, &now);
    int j;
    if (status) return status;
    for (j = 0; j < samples; j++) {
        vmi_jeffcott_rates(r, t, &now, y, y[4] + 2 * VM_PI * share * (vm_real)j, &dP, &dN);
        P = vmi_c_add(P, dP);
        N = vmi_c_add(N, dN);
    }
    dydt[0] = P.re * share;
    dydt[1] = P.im * share;
    dydt[2] = N.re * share;
    dydt[3] = N.im * share;
    dydt[4] = now.omega;
    return VM_OK;
}

/* Documented with vm_jeffcott_to_averaged. */
VM_API int vm_jeffcott_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_mean(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Documented with vm_jeffcott_to_averaged. */
VM_API int vm_jeffcott_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    return vmi_jeffcott_mean(t, y, dydt, r, vmi_jeffcott_samples(r));
}

/* W = (g +- S)/m, S^2 = g^2 + m F_e', without the difference of near numbers */
VM_API vm_real vmi_jeffcott_root(vm_real gyro, vm_real mass, vm_real stiffness, int sense)
{
    const vm_real forward = sense < 0 ? -1 : 1, g = forward * gyro, S = VM_SQRT(gyro * gyro + mass * stiffness);
    return forward * (g > 0 ? (g + S) / mass : stiffness / (S - g));
}

/* Strong nonlinearity: nearly circular motion z = A e^(i psi), z' = i W z, of the frequency W of m W^2 - 2 g W =
   F_e'(A), forward (sense >= 0) or backward. Averaged equations (506), (507) with g, y = (A, psi). A errs by the
   order of the loads over times of their inverse; the phase adds that up where F_e' is not constant: 0.005 were
   measured for loads that turn with z, order 1 for others. Not for a linear F_e with loads that do not turn with z:
   they send the motion off the circle. */
VM_API vm_real vm_jeffcott_frequency(const vm_jeffcott *r, vm_real A, vm_real mass, int sense)
{
    if (!r || !r->stiffness) return VM_NAN;
    vm_real slope;
    if (!(A >= 0) || !VM_IS_FINITE(A) || !(mass > 0) || !VM_IS_FINITE(mass)) return VM_NAN;
    return vmi_jeffcott_root(r->gyro, mass, vmi_jeffcott_stiffness(r, A, &slope), sense);
}

/* (504), (505) averaged. The torque gives (A^2 (m W - g))' = (1 - r) m' A^2 W + A <Im D>, the radial balance
   psi' - W = -<Re D>/(2 A (m W - g)), D = (F_z + r m' u) e^(-i psi); m W - g = +-S, S^2 = g^2 + m F_e'. */
VM_API int vmi_jeffcott_circular(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int sense)
{
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    const int samples = vmi_jeffcott_samples(r);
    vm_real mass, rate, stiffness, slope, W, S, growth;
    vm_complex sum = {0, 0};
    int j;
    const int status = vmi_slow_mass(r->mass, r->mass_ctx, t, &mass, &rate);
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, y[0], &slope);
    W = vmi_jeffcott_root(r->gyro, mass, stiffness, sense);
    S = mass * W - r->gyro;
    if (!(S * S > 0)) return VM_DOMAIN;
    for (j = 0; j < samples; j++) {
        const vm_complex turn = vmi_c_turn(y[1] + 2 * VM_PI * (vm_real)j / (vm_real)samples),
                         z = vmi_c_scale(y[0], turn);
        const vm_complex D = vmi_jeffcott_drive(r, t, rate, z, vmi_c_times_i(W, z));
        sum = vmi_c_add(sum, vmi_c_times(D, vmi_c_conjugate(turn)));
    }
    sum = vmi_c_scale(1 / (vm_real)samples, sum);
    growth = ((1 - r->reactive) * rate * W + sum.im / y[0]) / S - rate * stiffness / (2 * S * S);
    dydt[0] = y[0] * growth / (2 + mass * slope * y[0] / (2 * S * S));
    dydt[1] = W - sum.re / (2 * y[0] * S);
    return VM_OK;
}

/* Documented with vm_jeffcott_frequency. */
VM_API int vm_jeffcott_forward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Documented with vm_jeffcott_frequency. */
VM_API int vm_jeffcott_backward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, -1);
}

/* ln of the invariant over its first value at the radius first_A e^x */
typedef struct VM_TAG(vmi_jeffcott_orbit) {
    const vm_jeffcott *r;
    vm_real first_A, mass, first; /* first: that of g^2 + m F_e' */
} vmi_jeffcott_orbit;

VM_API vm_real vmi_jeffcott_invariant(vm_real x, void *orbit)
{
    const vmi_jeffcott_orbit *o = (const vmi_jeffcott_orbit *)orbit;
    vm_real slope;
    const vm_real stiffness = vmi_jeffcott_stiffness(o->r, o->first_A * vmi_exp(x, 0), &slope);
    const vm_real ratio = (o->r->gyro * o->r->gyro + o->mass * stiffness) / o->first;
    return ratio > 0 && VM_IS_FINITE(ratio) ? 4 * x + vmi_log(ratio).hi : VM_NAN;
}

/* The same without F_z: the radius when the mass has gone from mass0, where it was first_A, to mass, of
     A^4 (g^2 + m F_e'(A)) = const, r = 1, which is A^2 (m W - g) = const;  A^4 F_e'(A) m^(2r-1) = const, g = 0 (509)
   NaN for g != 0 and r != 1, where the course of the mass matters, and where no radius is found going from
   first_A. For powers it is first_A vm_osc_amplitude_law(mass/mass0, 0, r, alpha). */
VM_API vm_real vm_jeffcott_amplitude(const vm_jeffcott *r, vm_real first_A, vm_real mass0, vm_real mass)
{
    if (!r || !r->stiffness) return VM_NAN;
    vmi_jeffcott_orbit o;
    vm_real slope, here, there, step = VM_C(0.0625), x = 0;
    int bounded = 0;
    if (!(first_A > 0) || !(mass0 > 0) || !(mass > 0) || !VM_IS_FINITE(first_A) || !VM_IS_FINITE(mass0) ||
        !VM_IS_FINITE(mass) || (r->gyro != 0 && r->reactive != 1))
        return VM_NAN;
    if (r->gyro == 0) {
        mass = vmi_pow_checked(mass / mass0, 2 * r->reactive - 1);
        mass0 = 1;
    }
    o.r = r;
    o.first_A = first_A;
    o.mass = mass;
    o.first = r->gyro * r->gyro + mass0 * vmi_jeffcott_stiffness(r, first_A, &slope);
    here = vmi_jeffcott_invariant(0, &o);
    if (here == 0 || here != here) return here == 0 ? first_A : VM_NAN;
    for (step = here > 0 ? -step : step;; step = bounded ? step : 2 * step) { /* outward to a change of sign */
        there = vmi_jeffcott_invariant(x + step, &o);
        while (there != there) { /* F_e' is no number there */
            step /= 2;
            bounded = 1;
            if (VM_FABS(step) < VM_EPSILON * (1 + VM_FABS(x))) return VM_NAN;
            there = vmi_jeffcott_invariant(x + step, &o);
        }
        if (there == 0 || (there > 0) != (here > 0)) break;
        x += step;
        here = there;
    }
    return first_A * vmi_exp(vmi_find_zero(vmi_jeffcott_invariant, &o, x, x + step, here, there), 0);
}

#endif
