/* oscillators/jeffcott.h - the Jeffcott (Laval) rotor with variable mass

   Numbers such as (451) are equations of the dissertation [1]. A disc of mass m(t) turns in the middle of a shaft
   without mass. z = x + i y is the position of the disc's centre (451), and F_e(rho) the elastic force of the shaft at
   the deflection rho = |z|. A circular motion of the centre is called a whirl; forward whirl has a positive angular
   velocity, backward whirl a negative one. The stiffness K_e(rho) is the quotient F_e(rho)/rho. The dissertation writes
   F_e'(rho) for this quotient, although it is no derivative. g is the gyroscopic constant of the remark after (516).
   Mass joins or leaves with the velocity u; r is the fraction of its full reactive force m' (u - z') that acts on the
   disc. F_z is an external force. The equation of motion is
       m z'' + z K_e(|z|) - 2 i g z' = F_z + r m' (u - z')
   This file has the equation of motion, averaged equations for a weak nonlinearity (460)-(473), averaged equations
   for nearly circular motion with any nonlinearity (491)-(507), and the law of the radius (509).

       vm_power_force cubic = {1, 3}; // F_e = rho^3
       vm_jeffcott rotor;
       memset(&rotor, 0, sizeof rotor); // what is not set below is absent
       rotor.stiffness = vm_jeffcott_power;
       rotor.stiffness_ctx = &cubic;
       rotor.mass = vm_law_linear(1, VM_C(0.01)); // 1 kg, and 0.01 kg/s joins
       rotor.reactive = 1;
       vm_real radius = vm_jeffcott_amplitude(&rotor, 1, 1, 2); // of the whirl, m, when the mass has doubled

   Tests: tests/test_jeffcott.c. */
#ifndef VARMASS_OSCILLATORS_JEFFCOTT_H
#define VARMASS_OSCILLATORS_JEFFCOTT_H

#include "../ateb/phase.h"
#include "../base/arrays.h"
#include "../base/complex.h"
#include "../base/elementary.h"
#include "../base/power_of_two.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/zero.h"
#include "force_terms.h"
#include "laws.h"
#include "slow.h"

/* Stiffness of the shaft, a user's function: returns K_e(rho) = F_e(rho)/rho, N/m, at the deflection rho >= 0, m, and
   writes its derivative with respect to rho, N/m^2, to *slope. ctx is the user's pointer. vm_jeffcott_power is such a
   function. */
typedef vm_real (*vm_jeffcott_stiffness)(vm_real rho, vm_real *slope, void *ctx);

/* External force, a user's function: returns F_z = F_x + i F_y, N, at time t, position z and velocity v of the disc.
   ctx is the user's pointer. */
typedef vm_complex (*vm_jeffcott_force)(vm_real t, vm_complex z, vm_complex v, void *ctx);

/* The elastic force k rho^alpha of a power law: k in N/m^alpha, and the pure number alpha */
typedef struct VM_TAG(vm_power_force) {
    vm_real k, alpha;
} vm_power_force;

/* A rotor. The fields mass and stiffness must be set; any other field may be zero. */
typedef struct VM_TAG(vm_jeffcott) {
    vm_law mass;                     /* mass m of the disc, kg, > 0 */
    vm_jeffcott_stiffness stiffness; /* stiffness of the shaft */
    void *stiffness_ctx;     /* the user's pointer, last argument of the function `stiffness` */
    vm_jeffcott_force force; /* external force F_z, or null; for the averaged equations it must be small */
    void *force_ctx;         /* the user's pointer, last argument of the function `force` */
    vm_real gyro;            /* g, kg/s: the gyroscopic force is 2 g times the velocity, turned by +90 degrees */
    vm_real reactive;        /* r: 1 where mass joins or leaves with velocity u, 0 where it has the disc's velocity */
    vm_complex u;            /* absolute velocity of mass that joins or leaves, m/s */
    int nodes;               /* number of phases at which forces are computed for a mean over a period; 0 means 32 */
} vm_jeffcott;

/* Indices of the state y of vm_jeffcott_exact_rhs and vm_jeffcott_averaged_rhs */
enum {
    VMI_JEFFCOTT_P = 0,   /* y[0] and y[1]: forward whirl P, a complex number */
    VMI_JEFFCOTT_N = 2,   /* y[2] and y[3]: backward whirl N, a complex number */
    VMI_JEFFCOTT_PHI = 4, /* y[4]: fast phase phi */
    VMI_JEFFCOTT_SIZE = 5
};

/* Stiffness K_e(rho) = F_e(rho)/rho = k rho^(alpha-1) of a power law, as a vm_jeffcott_stiffness. power_force points to
   a vm_power_force. Returns the stiffness, N/m, and writes its derivative with respect to rho, N/m^2, to *slope.
   Returns NaN for null pointers, for rho < 0, and for an alpha that is negative, infinite or NaN. k may have any sign
   here, because the functions of the rotor check the stiffness. */
VM_API vm_real vm_jeffcott_power(vm_real rho, vm_real *slope, void *power_force)
{
    if (!slope || !power_force) return VM_NAN;
    const vm_power_force *p = (const vm_power_force *)power_force;
    *slope = VM_NAN;
    if (!(p->alpha >= 0) || !VM_IS_FINITE(p->alpha)) return VM_NAN;
    *slope = 0;
    if (p->alpha != 1) *slope = p->k * (p->alpha - 1) * vmi_pow_checked(rho, p->alpha - 2);
    return p->k * vmi_pow_checked(rho, p->alpha - 1);
}

/* Polar coordinates (448) of the disc's centre: deflection rho = |z| and angle phi in [-pi, pi], -pi only for y = -0.
   The relative error of rho is at most 2 eps, and that of phi at most 4 eps. If a pointer is null, nothing is done. */
VM_API void vm_jeffcott_polar(vm_complex z, vm_real *rho, vm_real *phi)
{
    if (!rho || !phi) return;
    *rho = vmi_c_modulus(z);
    *phi = ateb_phase(z.im, z.re, 1);
}

/* Angular momentum of a rotor about its axis, kg m^2/s: m Im(conj(z) z') - g |z|^2, where conj(z) = x - i y. The term
   -g |z|^2 is due to the gyroscopic force. The sum stays constant where r = 1, u = 0 and F_z = 0. The argument v is z'.
   Returns NaN for a null pointer. */
VM_API vm_real vm_jeffcott_momentum(const vm_jeffcott *r, vm_real mass, vm_complex z, vm_complex v)
{
    if (!r) return VM_NAN;
    return mass * (z.re * v.im - z.im * v.re) - r->gyro * (z.re * z.re + z.im * z.im);
}

/* Returns the stiffness K_e(rho) and writes its derivative. Both are NaN where the rotor has no stiffness function. */
VM_API vm_real vmi_jeffcott_stiffness(const vm_jeffcott *r, vm_real rho, vm_real *slope)
{
    *slope = VM_NAN;
    if (!r->stiffness) return VM_NAN;
    return r->stiffness(rho, slope, r->stiffness_ctx);
}

/* Writes the mass and its rate at time t. Returns VM_BAD_ARGUMENT where the rotor has no stiffness function, else the
   status of the law of the mass. */
VM_API int vmi_jeffcott_mass_at(const vm_jeffcott *r, vm_real t, vm_real *mass, vm_real *rate)
{
    if (!r->stiffness) return VM_BAD_ARGUMENT;
    return vmi_law_at(&r->mass, VM_BAD_MASS, t, mass, rate);
}

/* F_z + r m' u, N: the external force plus the part of the reactive force r m' (u - z') that does not depend on z'.
   `rate` is m'. */
VM_API vm_complex vmi_jeffcott_drive(const vm_jeffcott *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    const vm_complex thrust = vmi_c_scale(r->reactive * rate, r->u);
    if (!r->force) return thrust;
    return vmi_c_add(r->force(t, z, v, r->force_ctx), thrust);
}

/* F_z + r m' u + 2 i g z', N: the result of vmi_jeffcott_drive plus the gyroscopic force, where `rate` is m' and v is
   z'. */
VM_API vm_complex vmi_jeffcott_loads(const vm_jeffcott *r, vm_real t, vm_real rate, vm_complex z, vm_complex v)
{
    return vmi_c_add(vmi_jeffcott_drive(r, t, rate, z, v), vmi_c_times_i(vmi_gyroscopic_coupling(r->gyro), v));
}

/* Equation of motion (449), (450) of a rotor, for rk45 or rk87.
   y = (x, y, x', y') is in m and m/s; rotor points to a vm_jeffcott. Returns VM_BAD_ARGUMENT for null pointers and for
   a rotor without mass or stiffness; VM_NOT_FINITE where t, the mass or its rate is infinite or NaN (other numbers are
   not checked); VM_BAD_MASS for a mass that is not positive; VM_DOMAIN for a t at which the law of the mass has no
   value. These statuses stop the run. */
VM_API int vm_jeffcott_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    const vm_complex z = vmi_complex(y[0], y[1]), v = vmi_complex(y[2], y[3]);
    vm_real mass, rate, stiffness, slope;
    vm_complex force;
    const int status = vmi_jeffcott_mass_at(r, t, &mass, &rate);
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope);
    if (z.re == 0 && z.im == 0) stiffness = 0; /* the force is 0 at z = 0, where K_e may be infinite */
    force = vmi_jeffcott_loads(r, t, rate, z, v);
    dydt[0] = v.re;
    dydt[1] = v.im;
    dydt[2] = (force.re - r->reactive * rate * v.re - stiffness * z.re) / mass;
    dydt[3] = (force.im - r->reactive * rate * v.im - stiffness * z.im) / mass;
    return VM_OK;
}

/* -- Weak nonlinearity: forward and backward whirl together -- */

/* A rotor at one time: its mass m, kg, the rate m' of the mass, kg/s, and the frequency of small vibrations omega =
   sqrt(K_e(0)/m), rad/s */
typedef struct VM_TAG(vmi_jeffcott_state) {
    vm_real mass, rate, omega;
} vmi_jeffcott_state;

/* Finds the rotor's mass and frequency at time t. Returns VM_BAD_STIFFNESS where small vibrations have no frequency, as
   for F_e = rho^3; VM_BAD_ARGUMENT for a rotor without mass or stiffness; VM_BAD_MASS for a mass that is not positive;
   VM_NOT_FINITE for a number that is infinite or NaN; VM_DOMAIN for a t at which the law of the mass has no value, and
   where the frequency underflows. */
VM_API int vmi_jeffcott_now(const vm_jeffcott *r, vm_real t, vmi_jeffcott_state *now)
{
    vm_real stiffness, slope;
    const int status = vmi_jeffcott_mass_at(r, t, &now->mass, &now->rate);
    now->omega = VM_NAN;
    if (status) return status;
    stiffness = vmi_jeffcott_stiffness(r, 0, &slope);
    if (stiffness <= 0) return VM_BAD_STIFFNESS;
    now->omega = VM_SQRT(stiffness / now->mass);
    if (!VM_IS_FINITE(now->omega)) return VM_NOT_FINITE;
    if (!(now->omega > 0)) return VM_DOMAIN; /* the frequency underflows */
    return VM_OK;
}

/* Converts the motion (x, y, x', y') of a rotor to forward and backward whirl, (456)-(461). The complex numbers P and
   N describe circular motions, P forward and N backward, of the frequency omega = sqrt(K_e(0)/m):
     z = P e^(i phi) + N e^(-i phi),  z' = i omega (P e^(i phi) - N e^(-i phi)),
     P = A1 e^(i theta1),  N = A2 e^(-i theta2) in the symbols of [1].
   phi is the fast phase at the start, for example 0. y receives (Re P, Im P, Re N, Im N, phi), the state of
   vm_jeffcott_exact_rhs and vm_jeffcott_averaged_rhs. Unlike theta1 and theta2, P and N have no singularity where A1 or
   A2 is 0. Returns VM_BAD_ARGUMENT for null pointers and for a rotor without mass or stiffness; VM_NOT_FINITE for a
   number that is infinite or NaN; VM_BAD_MASS for a mass that is not positive; VM_BAD_STIFFNESS where K_e(0) is not
   positive; VM_DOMAIN for a t at which the law of the mass has no value. y and motion may be the same array. */
VM_API int vm_jeffcott_to_averaged(const vm_jeffcott *r, vm_real t, const vm_real *motion, vm_real phi, vm_real *y)
{
    if (!r || !motion || !y) return VM_BAD_ARGUMENT;
    const vm_complex z = vmi_complex(motion[0], motion[1]), back = vmi_c_turn(-phi);
    vmi_jeffcott_state now;
    vm_complex turned, P, N;
    vm_real found[VMI_JEFFCOTT_SIZE];
    int status = vmi_jeffcott_now(r, t, &now);
    if (!VM_IS_FINITE(phi) || !vmi_all_finite(4, motion)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    turned = vmi_c_times_i(-1 / now.omega, vmi_complex(motion[2], motion[3])); /* z'/(i omega) */
    P = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_add(z, turned)), back);
    N = vmi_c_times(vmi_c_scale(VM_C(0.5), vmi_c_sub(z, turned)), vmi_c_conjugate(back));
    found[VMI_JEFFCOTT_P] = P.re;
    found[VMI_JEFFCOTT_P + 1] = P.im;
    found[VMI_JEFFCOTT_N] = N.re;
    found[VMI_JEFFCOTT_N + 1] = N.im;
    found[VMI_JEFFCOTT_PHI] = phi;
    return vmi_copy_if_finite(VMI_JEFFCOTT_SIZE, found, y);
}

/* Writes the disc's position z and velocity v = z' from the whirls P and N in y, where turn = e^(i phi). */
VM_API void vmi_jeffcott_motion(const vm_real *y, vm_complex turn, vm_real omega, vm_complex *z, vm_complex *v)
{
    const vm_complex P = vmi_c_times(vmi_complex(y[VMI_JEFFCOTT_P], y[VMI_JEFFCOTT_P + 1]), turn);
    const vm_complex N = vmi_c_times(vmi_complex(y[VMI_JEFFCOTT_N], y[VMI_JEFFCOTT_N + 1]), vmi_c_conjugate(turn));
    *z = vmi_c_add(P, N);
    *v = vmi_c_times_i(omega, vmi_c_sub(P, N));
}

/* Converts forward and backward whirl of a rotor to the motion (x, y, x', y'). This is the inverse of
   vm_jeffcott_to_averaged, with its statuses; y = (Re P, Im P, Re N, Im N, phi). motion and y may be the same array. */
VM_API int vm_jeffcott_from_averaged(const vm_jeffcott *r, vm_real t, const vm_real *y, vm_real *motion)
{
    if (!r || !y || !motion) return VM_BAD_ARGUMENT;
    vmi_jeffcott_state now;
    vm_complex z, v;
    vm_real joined[4];
    int status = vmi_jeffcott_now(r, t, &now);
    if (!vmi_all_finite(VMI_JEFFCOTT_SIZE, y)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (status) return status;
    vmi_jeffcott_motion(y, vmi_c_turn(y[VMI_JEFFCOTT_PHI]), now.omega, &z, &v);
    joined[0] = z.re;
    joined[1] = z.im;
    joined[2] = v.re;
    joined[3] = v.im;
    return vmi_copy_if_finite(4, joined, motion);
}

/* Writes the exact rates P' and N' (470)-(473) of the whirls to *dP and *dN. At the fast phase phi the disc is at z = P
   e^(i phi) + N e^(-i phi), with the forward whirl P and the backward whirl N in y. With the force f per unit mass, the
   rates are
     P' = -i e^(-i phi) f/(2 omega),  N' = i e^(i phi) f/(2 omega),
     m f = F_z + r m' u + 2 i g z' - (K_e(|z|) - K_e(0)) z - (r - 1/2) m' z'
   The last term has r - 1/2 in place of r, because the change of omega adds the term m' z'/2. */
VM_API void vmi_jeffcott_rates(const vm_jeffcott *r, vm_real t, const vmi_jeffcott_state *now, const vm_real *y,
                               vm_real phi, vm_complex *dP, vm_complex *dN)
{
    const vm_complex turn = vmi_c_turn(phi);
    const vm_real push = 1 / (2 * now->omega * now->mass), drag = vmi_slow_drag(r->reactive, now->rate, 0) / 2;
    vm_real slope, extra;
    vm_complex z, v, f;
    vmi_jeffcott_motion(y, turn, now->omega, &z, &v);
    extra = vmi_jeffcott_stiffness(r, vmi_c_modulus(z), &slope) - now->mass * now->omega * now->omega;
    f = vmi_jeffcott_loads(r, t, now->rate, z, v);
    f = vmi_c_sub(f, vmi_c_add(vmi_c_scale(extra, z), vmi_c_scale(drag, v)));
    *dP = vmi_c_times_i(-push, vmi_c_times(f, vmi_c_conjugate(turn)));
    *dN = vmi_c_times_i(push, vmi_c_times(f, turn));
}

/* The number of phases, evenly spaced in a period, at which the loads are computed for a mean over the period */
VM_API int vmi_jeffcott_nodes(const vm_jeffcott *r)
{
    const int usual = 32; /* 32 phases give exact means of forces that are polynomials of degree <= 15 in z and z' */
    if (r->nodes > 0) return r->nodes;
    return usual;
}

/* Writes the means of P' and N' over `nodes` evenly spaced phases of a period, beginning with the phase in y. */
VM_API int vmi_jeffcott_mean(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int nodes)
{
    const vm_real share = 1 / (vm_real)nodes;
    vm_complex P = {0, 0}, N = {0, 0}, dP, dN;
    vmi_jeffcott_state now;
    const int status = vmi_jeffcott_now(r, t, &now);
    int j;
    if (status) return status;
    for (j = 0; j < nodes; j++) {
        vmi_jeffcott_rates(r, t, &now, y, y[VMI_JEFFCOTT_PHI] + 2 * VM_PI * share * (vm_real)j, &dP, &dN);
        P = vmi_c_add(P, dP);
        N = vmi_c_add(N, dN);
    }
    dydt[VMI_JEFFCOTT_P] = P.re * share;
    dydt[VMI_JEFFCOTT_P + 1] = P.im * share;
    dydt[VMI_JEFFCOTT_N] = N.re * share;
    dydt[VMI_JEFFCOTT_N + 1] = N.im * share;
    dydt[VMI_JEFFCOTT_PHI] = now.omega;
    return VM_OK;
}

/* Exact equations (470)-(473) of forward and backward whirl, for rk45 or rk87. y = (Re P, Im P, Re N, Im N, phi), see
   vm_jeffcott_to_averaged; rotor points to a vm_jeffcott. The equations hold for any force. They are useful only where
   the external force F_z, the velocity u of joining mass, the gyroscopic constant g and the change K_e(rho) - K_e(0) of
   the stiffness are small. Returns VM_BAD_ARGUMENT for null pointers and for a rotor without mass or stiffness;
   VM_NOT_FINITE where t, the mass, its rate or K_e(0) is infinite or NaN (other numbers are not checked); VM_BAD_MASS
   for a mass that is not positive; VM_BAD_STIFFNESS where K_e(0) is not positive; VM_DOMAIN for t outside a table of
   the mass. */
VM_API int vm_jeffcott_exact_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_mean(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Averaged equations of forward and backward whirl, for rk45 or rk87. They are the equations of vm_jeffcott_exact_rhs,
   averaged over the fast phase phi while P and N stay constant. The dissertation [1] averages over the angles psi1 and
   psi2 of the two whirls separately, (474)-(477). Because both whirls have the same frequency, such separate averages
   are right only if the force turns with z. The error is of the order of the largest perturbation (F_z, u, g, K_e(rho)
   - K_e(0) or m'), up to times of the order of the inverse of this perturbation. State and statuses are those of
   vm_jeffcott_exact_rhs; VM_BAD_ARGUMENT also means that the field `nodes` is negative. Each call evaluates the forces
   at `nodes` phases. */
VM_API int vm_jeffcott_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_jeffcott *r = (const vm_jeffcott *)rotor;
    if (r->nodes < 0) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_mean(t, y, dydt, r, vmi_jeffcott_nodes(r));
}

/* -- Strong nonlinearity: nearly circular whirl -- */

/* A power of two near S = sqrt(g^2 + m K_e); the arguments are g (gyro), m (mass) and K_e (stiffness). The frequency
   and the growth of a whirl do not change if g, m, m', K_e, its slope and the loads are all divided by one number.
   After the division by this power of two, which is exact, g^2 + m K_e neither overflows nor underflows. */
VM_API vm_real vmi_jeffcott_unit(vm_real gyro, vm_real mass, vm_real stiffness)
{
    return vmi_power_below(vmi_larger(VM_SQRT(mass) * VM_SQRT(VM_FABS(stiffness)), VM_FABS(gyro)));
}

/* The frequency W = (g +- S)/m of circular whirl, where S = sqrt(g^2 + m K_e), and + is for forward whirl (sense >= 0).
   The arguments are g (gyro), m (mass) and K_e (stiffness). For K_e >= 0 no digits cancel, because nearly equal numbers
   are never subtracted. */
VM_API vm_real vmi_jeffcott_root(vm_real gyro, vm_real mass, vm_real stiffness, int sense)
{
    const vm_real unit = vmi_jeffcott_unit(gyro, mass, stiffness);
    vm_real direction = 1, S, g, speed;
    gyro /= unit;
    mass /= unit;
    stiffness /= unit;
    S = VM_SQRT(gyro * gyro + mass * stiffness);
    if (sense < 0) direction = -1;
    g = direction * gyro;
    if (g > 0) speed = (g + S) / mass;
    else speed = stiffness / (S - g);
    return direction * speed;
}

/* Frequency W of circular whirl of radius A, rad/s. By the corrected remark after (516), W solves m W^2 - 2 g W =
   K_e(A). If K_e(A) > 0, forward whirl (sense >= 0) has W > 0, and backward whirl (sense < 0) has W < 0. If K_e(A) < 0,
   both W have the sign of g. A >= 0 is in m, mass > 0 in kg. The relative error is at most 8 eps (eps is the machine
   epsilon), apart from the error of the stiffness. If K_e(A) < 0 and g^2 + m K_e(A) is nearly 0, the rounding errors of
   g^2 and m K_e(A) make a larger error. Returns NaN for null pointers, for a rotor without stiffness, for A
   < 0, for mass <= 0, where g^2 + m K_e(A) is negative, where g and K_e(A) are both 0, and for numbers that are
   infinite or NaN. */
VM_API vm_real vm_jeffcott_frequency(const vm_jeffcott *r, vm_real A, vm_real mass, int sense)
{
    if (!r || !r->stiffness) return VM_NAN;
    vm_real slope;
    if (!(A >= 0) || !VM_IS_FINITE(A) || !(mass > 0) || !VM_IS_FINITE(mass)) return VM_NAN;
    return vmi_jeffcott_root(r->gyro, mass, vmi_jeffcott_stiffness(r, A, &slope), sense);
}

/* The mean load, N, on a disc that moves on a circle of radius A at the frequency W. The load D = F_z + r m' u is
   multiplied by e^(-i angle), where `angle` is the angle of z, and averaged over one turn that begins at the angle psi.
   The real part of the mean is the radial load, the imaginary part the tangential load. `rate` is m'. */
VM_API vm_complex vmi_jeffcott_mean_load(const vm_jeffcott *r, vm_real t, vm_real rate, vm_real A, vm_real psi,
                                         vm_real W)
{
    const int nodes = vmi_jeffcott_nodes(r);
    vm_complex sum = {0, 0};
    int j;
    for (j = 0; j < nodes; j++) {
        const vm_complex turn = vmi_c_turn(psi + 2 * VM_PI * (vm_real)j / (vm_real)nodes);
        const vm_complex z = vmi_c_scale(A, turn);
        const vm_complex D = vmi_jeffcott_drive(r, t, rate, z, vmi_c_times_i(W, z));
        sum = vmi_c_add(sum, vmi_c_times(D, vmi_c_conjugate(turn)));
    }
    return vmi_c_scale(1 / (vm_real)nodes, sum);
}

/* Writes the averaged rates (504), (505) of the state y = (A, psi), the radius and the angle of a circular whirl. W is
   the whirl's frequency, L the result of vmi_jeffcott_mean_load, and S = m W - g = +-sqrt(g^2 + m K_e(A)), where + is
   for forward whirl. The equations are
     along the circle: (A^2 S)' = (1 - r) m' A^2 W + A Im L,
     across the circle: psi' = W - Re L/(2 A S) */
VM_API int vmi_jeffcott_circular(vm_real t, const vm_real *y, vm_real *dydt, const vm_jeffcott *r, int sense)
{
    vm_real mass = 0, rate = 0, stiffness, slope, unit, W, S, growth;
    vm_complex load;
    const int status = vmi_jeffcott_mass_at(r, t, &mass, &rate);
    const int is_number = VM_IS_FINITE(r->gyro) && y[0] == y[0];
    if (r->nodes < 0) return VM_BAD_ARGUMENT;
    if (status) return is_number ? status : vmi_first_error(status, VM_NOT_FINITE);
    if (!is_number) return VM_NOT_FINITE;
    stiffness = vmi_jeffcott_stiffness(r, y[0], &slope);
    unit = vmi_jeffcott_unit(r->gyro, mass, stiffness);
    W = vmi_jeffcott_root(r->gyro, mass, stiffness, sense);
    S = (mass * W - r->gyro) / unit;
    if (S != S && !VM_IS_FINITE(stiffness)) return VM_NOT_FINITE;
    if (!(S * S > 0)) return VM_BAD_STIFFNESS;
    load = vmi_c_scale(1 / unit, vmi_jeffcott_mean_load(r, t, rate, y[0], y[1], W));
    mass /= unit;
    rate /= unit;
    stiffness /= unit;
    slope /= unit;
    growth = ((1 - r->reactive) * rate * W + load.im / y[0]) / S - rate * stiffness / (2 * S * S);
    dydt[0] = y[0] * growth / (2 + mass * slope * y[0] / (2 * S * S));
    dydt[1] = W - load.re / (2 * y[0] * S);
    return VM_OK;
}

/* Averaged equations (506), (507) of forward whirl, for rk45 or rk87. The nonlinearity may be strong. The motion is
   nearly circular: z = A e^(i psi), z' = i W z with the frequency W of vm_jeffcott_frequency. y = (A, psi) is in m and
   rad; rotor points to a vm_jeffcott. The error of A is of the order of the largest load (by the force F_z, the
   velocity u or the mass rate m'), up to times of the order of the inverse of this load. Where K_e is not constant, the
   error of A causes an error of the phase psi that grows with time. For loads that turn with z, that is loads at a
   fixed angle to z, the error of psi is at most 0.015 in the tests, up to these times. For other loads the error of psi
   is of order 1. If F_e is linear and the loads do not turn with z, the disc does not stay on a circle, and the
   equations are not valid. Returns VM_BAD_ARGUMENT for null pointers, for a rotor without mass or stiffness, and for a
   negative field `nodes`; VM_NOT_FINITE where t, the mass, its rate, g or the stiffness is infinite or NaN, or A is NaN
   (other numbers are not checked); VM_BAD_MASS for a mass that is not positive; VM_BAD_STIFFNESS if g^2 + m K_e(A) is
   not positive; VM_DOMAIN for a t at which the law of the mass has no value. Each call evaluates the force at `nodes`
   phases. */
VM_API int vm_jeffcott_forward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, 1);
}

/* Averaged equations (506), (507) of backward whirl, for rk45 or rk87. State, error and statuses are as in
   vm_jeffcott_forward_whirl_rhs, except that the whirl's frequency W is negative. */
VM_API int vm_jeffcott_backward_whirl_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    return vmi_jeffcott_circular(t, y, dydt, (const vm_jeffcott *)rotor, -1);
}

/* The search for the radius A of circular whirl after a change of the mass. The product A^4 (g^2 + m K_e(A)), called
   the invariant, keeps its value during the change. */
typedef struct VM_TAG(vmi_jeffcott_orbit) {
    const vm_jeffcott *r;
    vm_real first_A; /* radius A before the change, m */
    vm_real unit;    /* vmi_jeffcott_unit before the change, by which g, mass and K_e are divided */
    vm_real gyro;    /* g */
    vm_real mass;    /* mass after the change, kg */
    vm_real first;   /* the factor g^2 + m K_e(A) of the invariant before the change */
} vmi_jeffcott_orbit;

/* Returns ln(Q/Q0), where Q is the invariant A^4 (g^2 + m K_e(A)) at the radius first_A e^x, and Q0 its value before
   the change of the mass. Returns NaN where K_e is NaN, and where K_e is so negative that Q is not positive. */
VM_API vm_real vmi_jeffcott_invariant(vm_real x, void *orbit)
{
    const vmi_jeffcott_orbit *o = (const vmi_jeffcott_orbit *)orbit;
    vm_real slope;
    const vm_real stiffness = vmi_jeffcott_stiffness(o->r, o->first_A * vmi_exp(x, 0), &slope) / o->unit;
    const vm_real ratio = (o->gyro * o->gyro + o->mass * stiffness) / o->first;
    if (!(ratio > 0) || !VM_IS_FINITE(ratio)) return VM_NAN;
    return 4 * x + vmi_log(ratio).hi;
}

/* An interval [a, b] of x = ln(A/first_A). The values at_a and at_b of vmi_jeffcott_invariant at its ends have opposite
   signs */
typedef struct VM_TAG(vmi_jeffcott_bracket) {
    vm_real a, b, at_a, at_b;
} vmi_jeffcott_bracket;

/* Returns the derivative of ln Q with respect to x = ln(A/first_A), where Q is the invariant A^4 (g^2 + m K_e(A)) and m
   the mass at which the slowly changing radius is A. It is 4 + (1 - g^2/S^2) d(ln K_e)/dx, where S^2 = g^2 + m K_e
   follows from Q = Q0, its value before the change. The radius follows the mass only as long as this derivative is not
   0. Where it is 0, the whirl ends: no radius near A belongs to the next mass. Returns 4 where the term after 4 is
   infinite, as where the slope of K_e overflows or K_e is 0, and NaN where it is NaN. */
VM_API vm_real vmi_jeffcott_rise(vm_real x, void *orbit)
{
    const vmi_jeffcott_orbit *o = (const vmi_jeffcott_orbit *)orbit;
    const vm_real A = o->first_A * vmi_exp(x, 0);
    vm_real slope, share = 1, growth;
    const vm_real stiffness = vmi_jeffcott_stiffness(o->r, A, &slope);
    if (o->gyro != 0) share -= o->gyro * o->gyro / o->first * vmi_exp(4 * x, 0);
    growth = share * (slope * A / stiffness);
    if (growth == growth && !VM_IS_FINITE(growth)) return 4;
    return 4 + growth;
}

/* Searches for a change of sign of vmi_jeffcott_invariant. The search starts at x = 0, where the value of this function
   is b->at_a, and goes in the direction in which the radius changes with the mass. Each step is twice as long as the
   step before it, until the steps have the length 0.25, which changes the radius by 28 % outwards or 22 % inwards. A
   step to an x where the function is NaN is halved, and from then on the steps do not grow. A step across a zero of
   vmi_jeffcott_rise is shortened to this zero, where the search ends. Returns 1 where a change of sign is found, with
   the interval in *b. Returns 0 otherwise, also where vmi_jeffcott_rise is NaN, or is 0 at the start. */
VM_API int vmi_jeffcott_find_bracket(vmi_jeffcott_orbit *o, vmi_jeffcott_bracket *b)
{
    const vm_real longest = VM_C(0.25);
    vm_real step = VM_C(0.0625); /* changes the radius by 6 % */
    vm_real rise_a = vmi_jeffcott_rise(0, o), rise_b;
    int bounded = 0, ends = 0;
    if (rise_a == 0 || rise_a != rise_a) return 0;
    if ((b->at_a > 0) == (rise_a > 0)) step = -step;
    b->a = 0;
    for (;;) {
        b->b = b->a + step;
        b->at_b = vmi_jeffcott_invariant(b->b, o);
        while (b->at_b != b->at_b) {
            step /= 2;
            bounded = 1;
            if (VM_FABS(step) < VM_EPSILON * (1 + VM_FABS(b->a))) return 0;
            b->b = b->a + step;
            b->at_b = vmi_jeffcott_invariant(b->b, o);
        }
        rise_b = vmi_jeffcott_rise(b->b, o);
        if (rise_b != rise_b) return 0;
        if ((rise_b > 0) != (rise_a > 0)) {
            b->b = vmi_find_zero(vmi_jeffcott_rise, o, b->a, b->b, rise_a, rise_b);
            if (b->b != b->b) return 0;
            b->at_b = vmi_jeffcott_invariant(b->b, o);
            ends = 1;
        }
        if (b->at_b != b->at_b) return 0;
        if (b->at_b == 0 || (b->at_b > 0) != (b->at_a > 0)) return 1;
        if (ends) return 0;
        b->a = b->b;
        b->at_a = b->at_b;
        rise_a = rise_b;
        if (!bounded && VM_FABS(step) < longest) step *= 2;
    }
}

/* Radius of circular whirl, m, after the mass has changed slowly.
   The radius was first_A when the mass was mass0; `mass` is the mass after the change. F_z and u must be 0. These
   products stay constant (509):
     A^4 (g^2 + m K_e(A)) for r = 1, which is the square of A^2 (m W - g);   A^4 K_e(A) m^(2r-1) for g = 0.
   For F_e = k rho^alpha and g = 0 the radius follows vm_osc_amplitude_law with the arguments mass/mass0 and decay =
   0; its relative error is then at most 3e-15 (float 3e-6) if the masses have a ratio between 1e-30 and 1e30 (float
   1e-9 and 1e9). Returns NaN for g != 0 with r != 1 (then use vm_jeffcott_whirl_amplitude, which finds the radius
   by integration); where g^2 + m K_e(A) is not positive at the start; where the whirl ends before the mass reaches
   `mass`: it ends at a radius A at which the product above, as a function of A with constant m, has an extremum;
   for a null pointer; for a rotor without stiffness; and for a radius or masses that are not positive and finite.
   Two extrema whose radii differ by less than 28 % may be overlooked. */
VM_API vm_real vm_jeffcott_amplitude(const vm_jeffcott *r, vm_real first_A, vm_real mass0, vm_real mass)
{
    if (!r || !r->stiffness) return VM_NAN;
    vmi_jeffcott_orbit o;
    vmi_jeffcott_bracket b;
    vm_real slope, stiffness, first_mass = mass0;
    if (!(first_A > 0) || !(mass0 > 0) || !(mass > 0) || !VM_IS_FINITE(first_A) || !VM_IS_FINITE(mass0) ||
        !VM_IS_FINITE(mass) || (r->gyro != 0 && r->reactive != 1))
        return VM_NAN;
    o.r = r;
    o.first_A = first_A;
    o.mass = mass;
    if (r->gyro == 0) { /* for g = 0 the invariant has m^(2r-1) in place of m (509) */
        o.mass = vmi_pow_checked(mass / mass0, 2 * r->reactive - 1);
        first_mass = 1;
    }
    stiffness = vmi_jeffcott_stiffness(r, first_A, &slope);
    o.unit = vmi_jeffcott_unit(r->gyro, first_mass, stiffness);
    o.gyro = r->gyro / o.unit;
    o.mass /= o.unit;
    o.first = o.gyro * o.gyro + first_mass / o.unit * (stiffness / o.unit);
    if (!(o.first > 0)) return VM_NAN;
    b.at_a = vmi_jeffcott_invariant(0, &o);
    if (b.at_a == 0) return first_A;
    if (b.at_a != b.at_a || !vmi_jeffcott_find_bracket(&o, &b)) return VM_NAN;
    return first_A * vmi_exp(vmi_find_zero(vmi_jeffcott_invariant, &o, b.a, b.b, b.at_a, b.at_b), 0);
}

#endif
