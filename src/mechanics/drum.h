/* mechanics/drum.h - a band that winds up on a drum

   A band that arrives at a constant velocity winds up on a drum. Therefore the total mass and inertia of drum and band
   grow (section 5.2 and Fig. 20 of the dissertation [1]). This chapter has
     - the geometry (181)-(188),
     - the exact equations of motion, and the reduced equations (192)-(193) of [1],
     - the motion on a rigid shaft in closed form (194)-(206),
     - the vibrations of an elastic shaft (210)-(226), with the unbalance that [1] leaves out, and the change of the
       angular velocity by these vibrations.

   The band moves at the velocity v along y and touches the drum first at the point S + (R, 0), where S is the centre of
   the shaft and R the radius of the drum. After the drum has turned by the angle phi, the band covers the arc from 0 to
   phi. The mass centre of this arc lies in the direction of the angle phi/2 from S. The radius R stays constant,
   because only the first layer of the band, 0 <= phi <= 2 pi, is considered.

   The letters of the formulas are explained at the fields of vm_drum. Two other letters are j = mu R^2 (186), the
   inertia of the band per radian of phi, and e = mu v R - D, the driving torque of the band minus the damping, both
   divided by phi'. If e > 0, the band drives the drum. If e < 0, the drum comes to rest.

       vm_drum drum = {VM_C(0.2), 50, 1, VM_C(0.05), 10, VM_C(0.02), VM_C(1e5), 40}; // in the order of the fields
       vm_real angle = vm_drum_angle(&drum, 1); // rad, after 1 s on a rigid shaft

   Tests: tests/test_drum.c, tests/test_drum_shaft.c. */
#ifndef VARMASS_MECHANICS_DRUM_H
#define VARMASS_MECHANICS_DRUM_H

#include "../base/elementary.h"
#include "../base/hypot.h"
#include "../base/lambert.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"

/* A drum, its shaft and the band */
typedef struct VM_TAG(vm_drum) {
    vm_real radius;    /* radius R of the drum, m */
    vm_real mass;      /* mass M0 > 0 of the empty drum, kg */
    vm_real inertia;   /* moment of inertia J0 > 0 of the empty drum about its axle, kg m^2 */
    vm_real band;      /* mass mu >= 0 of the band per radian of phi, kg/rad; vm_drum_band computes mu */
    vm_real speed;     /* velocity v of the band, m/s */
    vm_real damping;   /* damping D of the rotation, N m s */
    vm_real stiffness; /* stiffness c >= 0 of the shaft, N/m */
    vm_real omega;     /* initial angular velocity Omega_b > 0, at phi = 0, rad/s */
} vm_drum;

/* Geometry of the drum and of the band that is wound on it, after the drum has turned by the angle phi */
typedef struct VM_TAG(vm_drum_geometry) {
    vm_real mass;         /* mass M of drum and band (182), kg */
    vm_real arc_centre;   /* distance of the band's mass centre from the shaft's centre S (184), m */
    vm_real offset;       /* distance from the shaft's centre S to S1, the mass centre of drum and band, m.
                             S1 lies in the direction phi/2 from S [(185) corrected]. */
    vm_real axle_inertia; /* inertia J_S of drum and band about the axle (187), kg m^2 */
    vm_real inertia;      /* inertia J_S1 of drum and band about S1 (188), kg m^2 */
} vm_drum_geometry;

/* Indices of the states of vm_drum_rhs and vm_drum_rhs_reduced in y, and the number of states */
enum {
    VM_DRUM_X = 0,     /* deflection of the shaft: position x, y of its centre S, m */
    VM_DRUM_ANGLE = 2, /* angle phi of the drum, rad */
    VM_DRUM_V = 3,     /* velocity x', y' of the shaft's centre S, m/s */
    VM_DRUM_OMEGA = 5, /* angular velocity phi' of the drum, rad/s */
    VM_DRUM_STATES = 6
};

/* Indices of the states of vm_drum_rhs_angle and vm_drum_rhs_coupled in y, and the numbers of states */
enum {
    VM_DRUM_DEFLECTION = 0, /* deflection of the shaft: position x, y of its centre S, m */
    VM_DRUM_SLOPE = 2,      /* derivatives dx/dphi, dy/dphi of the deflection, m/rad */
    VM_DRUM_ANGLE_STATES = 4,
    VM_DRUM_RATE = 4, /* angular velocity phi' of the drum, rad/s, of vm_drum_rhs_coupled only */
    VM_DRUM_TIME = 5, /* time t, s, of vm_drum_rhs_coupled only */
    VM_DRUM_COUPLED_STATES = 6
};

/* The elastic shaft in the first approximation, for small mu/M0, j/J0 and e/(J0 Omega_b). The letters mu, v, M0, J0,
   Omega_b, c are explained at vm_drum; j = mu R^2 and e = mu v R - D. The deflection x, y of the shaft is a function
   of the angle phi. With x' = dx/dphi the deflection x satisfies
     x'' + 2 delta x' + k^2 (1 - A phi) x = 0 (213).
   The equation of y has mu v/(M0 Omega_b) on the right side instead of 0 (214). */
typedef struct VM_TAG(vm_drum_shaft) {
    vm_real k;     /* angular frequency sqrt(c/M0) of the shaft with the empty drum, divided by Omega_b */
    vm_real delta; /* damping, 1/rad: (mu/M0 + e/(J0 Omega_b) - j/J0)/2. The coefficient printed in (213) is wrong. */
    vm_real A;     /* relative decrease of the squared frequency per radian, 1/rad: mu/M0 - 2 j/J0 + 2 e/(J0 Omega_b).
                      The value in (213) is wrong. */
    vm_real shift; /* displacement mu v/(M0 Omega_b k^2), m. The deflection y oscillates about shift/(1 - A phi). */
} vm_drum_shaft;

/* The mass of the band per radian on a drum, mu = R h b rho (181), kg/rad.
   The radius R of the drum, the thickness h and the width b of the band are in m, and the density rho of the band is in
   kg/m^3. The arguments are not checked. If an argument is NaN, the result is NaN. */
VM_API vm_real vm_drum_band(vm_real radius, vm_real thickness, vm_real width, vm_real density)
{
    return radius * thickness * width * density;
}

/* Mass and inertia of drum and band at the angle phi, for the equations of motion */
typedef struct VM_TAG(vmi_drum_mass) {
    vm_real M;       /* mass of drum and band, kg */
    vm_real J;       /* inertia of drum and band about the axle, kg m^2 */
    vm_real steiner; /* M times the squared distance of the mass centre from the axle, kg m^2: the
                        inertia about the mass centre is J - steiner */
} vmi_drum_mass;

/* Sets *m for the angle phi of the drum. The argument s is sin(phi/2), or 0 to neglect the distance from the axle to
   the mass centre. Returns VM_NOT_FINITE if M or J is infinite or NaN; VM_BAD_MASS if M or the mass of the empty drum
   is not positive, or if the field `band` is negative; VM_BAD_STIFFNESS if the stiffness is negative; VM_BAD_INERTIA if
   J - steiner is not positive; else VM_OK. */
VM_API int vmi_drum_mass_at(const vm_drum *d, vm_real phi, vm_real s, vmi_drum_mass *m)
{
    const vm_real q = 2 * d->band * d->radius * s;
    m->M = d->mass + d->band * phi;
    m->J = d->inertia + d->band * d->radius * d->radius * phi;
    m->steiner = q / m->M * q; /* in this order, because q * q could underflow */
    if (!VM_IS_FINITE(m->M) || !VM_IS_FINITE(m->J)) return VM_NOT_FINITE;
    if (!(d->mass > 0) || d->band < 0 || !(m->M > 0)) return VM_BAD_MASS;
    if (d->stiffness < 0) return VM_BAD_STIFFNESS;
    if (!(m->J - m->steiner > 0)) return VM_BAD_INERTIA;
    return VM_OK;
}

VM_API int vmi_drum_finite(const vm_drum *d)
{
    return VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->mass) && VM_IS_FINITE(d->inertia) && VM_IS_FINITE(d->band) &&
           VM_IS_FINITE(d->speed) && VM_IS_FINITE(d->damping) && VM_IS_FINITE(d->stiffness) &&
           VM_IS_FINITE(d->omega);
}

/* Mass, mass centre and inertia of the drum with its band at the angle phi, (182)-(188).
   The angle phi >= 0 is in rad. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument or the result
   is infinite or NaN; VM_BAD_MASS if the field `mass` is not positive or `band` is negative; VM_BAD_STIFFNESS if the
   stiffness is negative; VM_BAD_INERTIA if the field `inertia` or the inertia J_S1 (188) is not positive; VM_DOMAIN if
   phi < 0; VM_OK otherwise. */
VM_API int vm_drum_at(const vm_drum *d, vm_real phi, vm_drum_geometry *g)
{
    vm_real s, c;
    vmi_drum_mass m;
    int status;
    if (!d || !g) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(phi) || !vmi_drum_finite(d)) return VM_NOT_FINITE;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->stiffness < 0) return VM_BAD_STIFFNESS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    if (phi < 0) return VM_DOMAIN;
    vmi_sincos(phi / 2, &s, &c);
    status = vmi_drum_mass_at(d, phi, s, &m);
    if (status) return status;
    g->mass = m.M;
    g->arc_centre = d->radius;
    if (phi > VM_MIN) g->arc_centre = d->radius * s / (phi / 2);
    g->offset = 2 * d->band * d->radius * s / m.M;
    g->axle_inertia = m.J;
    g->inertia = m.J - m.steiner;
    return VM_OK;
}

/* Right-hand side of the exact equations of motion of the drum on an elastic shaft.
   Its type is ode_rhs, so that integrators such as rk45 can call it. The state y has VM_DRUM_STATES numbers. `drum`
   must point to a vm_drum. The equations replace (177) and (191), which neglect that the mass centre moves inside the
   drum, and in which the torque of the shaft has the wrong sign. Let rS = (xS, yS) be the deflection of the shaft, k
   the unit vector along z, and q = mu R (sin phi, 1 - cos phi). With the cross product x and a prime ' for d/dt, the
   equations are
     M rS'' + phi'' k x q - phi'^2 q = -c rS + mu phi' ((0, v) - rS' - phi' k x (R, 0))
     J_S phi'' + q x rS'' = -D phi' + mu phi' R (v - yS' - R phi')
   M is the mass of drum and band, J_S their inertia about the axle; vm_drum explains c, D, mu, v, R. Returns VM_OK or
   an error, which ends the run: VM_BAD_ARGUMENT for a null pointer; VM_BAD_STIFFNESS if the stiffness is negative;
   VM_NOT_FINITE, VM_BAD_MASS or VM_BAD_INERTIA if the mass or the inertia at the angle phi is impossible. */
VM_API int vm_drum_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real phi = y[VM_DRUM_ANGLE], rate = y[VM_DRUM_OMEGA];
    const vm_real flow = d->band * rate, slip = d->speed - y[VM_DRUM_V + 1] - d->radius * rate;
    vm_real s, c, qx, qy, force_x, force_y, moment, turn; /* turn: the angular acceleration phi'' */
    vmi_drum_mass m;
    int status;
    (void)t;
    vmi_sincos(phi / 2, &s, &c);
    status = vmi_drum_mass_at(d, phi, s, &m);
    if (status) return status;
    qx = 2 * d->band * d->radius * s * c;
    qy = 2 * d->band * d->radius * s * s;
    force_x = -d->stiffness * y[VM_DRUM_X] - flow * y[VM_DRUM_V] + rate * rate * qx;
    force_y = -d->stiffness * y[VM_DRUM_X + 1] + flow * slip + rate * rate * qy;
    moment = -d->damping * rate + flow * d->radius * slip;
    turn = (moment - (qx * force_y - qy * force_x) / m.M) / (m.J - m.steiner);
    dydt[VM_DRUM_X] = y[VM_DRUM_V];
    dydt[VM_DRUM_X + 1] = y[VM_DRUM_V + 1];
    dydt[VM_DRUM_ANGLE] = rate;
    dydt[VM_DRUM_V] = (force_x + turn * qy) / m.M;
    dydt[VM_DRUM_V + 1] = (force_y - turn * qx) / m.M;
    dydt[VM_DRUM_OMEGA] = turn;
    return VM_OK;
}

/* Right-hand side of the equations of motion of the drum on an elastic shaft, for a light band, (192), (193).
   Its type is ode_rhs. The state y has VM_DRUM_STATES numbers. `drum` must point to a vm_drum. If the mass mu of the
   band per angle is small, the equations of vm_drum_rhs can be reduced to (192), (193). The unbalance of the band
   causes the force mu R phi'^2 (sin phi, -cos phi). (192) leaves out this force, but this function contains it,
   because it is of the same order as the terms that (192) keeps. The statuses are those of vm_drum_rhs. */
VM_API int vm_drum_rhs_reduced(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real rate = y[VM_DRUM_OMEGA], vx = y[VM_DRUM_V], vy = y[VM_DRUM_V + 1];
    const vm_real flow = d->band * rate, unbalance = flow * d->radius * rate;
    vm_real s, c;
    vmi_drum_mass m;
    int status;
    (void)t;
    vmi_sincos(y[VM_DRUM_ANGLE], &s, &c);
    status = vmi_drum_mass_at(d, y[VM_DRUM_ANGLE], 0, &m);
    if (status) return status;
    dydt[VM_DRUM_X] = vx;
    dydt[VM_DRUM_X + 1] = vy;
    dydt[VM_DRUM_ANGLE] = rate;
    dydt[VM_DRUM_V] = (-d->stiffness * y[VM_DRUM_X] - flow * vx + unbalance * s) / m.M;
    dydt[VM_DRUM_V + 1] = (-d->stiffness * y[VM_DRUM_X + 1] + flow * (d->speed - vy) - unbalance * c) / m.M;
    dydt[VM_DRUM_OMEGA] = (-d->damping * rate + flow * d->radius * (d->speed - vy - d->radius * rate)) / m.J;
    return VM_OK;
}

/* Returns 1 if the drum can turn on a rigid shaft: the fields that this motion needs are finite and have the signs that
   vm_drum demands. Returns 0 otherwise. */
VM_API int vmi_drum_turns(const vm_drum *d)
{
    return d && d->inertia > 0 && d->band >= 0 && d->omega > 0 && VM_IS_FINITE(d->inertia) &&
           VM_IS_FINITE(d->band) && VM_IS_FINITE(d->omega) && VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->speed) &&
           VM_IS_FINITE(d->damping);
}

/* The product j = mu R^2 in two words, that is, as the sum of two vm_reals */
VM_API vm_two vmi_drum_j(const vm_drum *d)
{
    return vmi_two_times(vmi_two_product(d->band, d->radius), vmi_two(d->radius, 0));
}

/* The drive e = mu v R - D in two words, that is, as the sum of two vm_reals. The function first computes e as the sum
   of three vm_reals, so that all digits are right even if mu v R and D nearly cancel. */
VM_API vm_two vmi_drum_e(const vm_drum *d)
{
    const vm_two band = vmi_two_product(d->band, d->radius);
    const vmi_three drive = vmi_three_times(vmi_three_words(band.hi, band.lo, 0), vmi_three_words(d->speed, 0, 0));
    const vmi_three e = vmi_three_plus(drive, vmi_three_words(-d->damping, 0, 0));
    return vmi_two(e.hi, e.mid);
}

/* The quotient a b/c in two words, that is, as the sum of two vm_reals */
VM_API vm_two vmi_drum_share(vm_two a, vm_real b, vm_two c)
{
    return vmi_two_over(vmi_two_times(a, vmi_two(b, 0)), c);
}

/* Angular velocity phi' on a rigid shaft at the angle phi >= 0, rad/s: (J0 Omega_b + e phi)/(J0 + j phi) (196). J0
   is the drum's inertia, Omega_b its initial angular velocity, e = mu v R - D and j = mu R^2 as at the top of
   mechanics/drum.h. The results of vm_drum_rate, vm_drum_time and vm_drum_angle have errors of at most 3 ulp if the
   drum's fields are taken as exact and products of the fields do not overflow or underflow. These bounds hold for
   all angles up to the stop, the angle at which the drum comes to rest (vm_drum_stop), but not for the last 16
   numbers before the stop. They hold for e = 0 and e = j Omega_b, too. Returns NaN beyond the stop, for phi < 0, for
   a null pointer, and if inertia or omega is not positive or band is negative. */
VM_API vm_real vm_drum_rate(const vm_drum *d, vm_real phi)
{
    vm_two up, down;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    up = vmi_two_plus(vmi_two_product(d->inertia, d->omega), vmi_two_times(vmi_drum_e(d), vmi_two(phi, 0)));
    down = vmi_two_plus(vmi_two(d->inertia, 0), vmi_two_times(vmi_drum_j(d), vmi_two(phi, 0)));
    if (!(up.hi >= 0)) return VM_NAN;
    return vmi_two_over(up, down).hi;
}

/* Right-hand side of the equations of the shaft's vibration as a function of the angle phi, (210), (211).
   Its type is ode_rhs. The state y has VM_DRUM_ANGLE_STATES numbers. `drum` must point to a vm_drum. The independent
   variable is the angle phi instead of time. The angular velocity phi' is taken from the drum on a rigid shaft (196).
   The unbalance of the band is left out, as in [1]; vm_drum_unbalance computes the deflection that it causes. Returns
   VM_BAD_ARGUMENT for a null pointer; VM_DOMAIN if the drum comes to rest before it reaches phi, if phi is negative, or
   if `omega` is not positive; VM_BAD_INERTIA if `inertia` is not positive; else a status of vm_drum_rhs. */
VM_API int vm_drum_rhs_angle(vm_real phi, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    if (!VM_IS_FINITE(phi) || !vmi_drum_finite(d)) return VM_NOT_FINITE;
    const vm_real rate = vm_drum_rate(d, phi), j = d->band * d->radius * d->radius;
    const vm_real e = d->band * d->speed * d->radius - d->damping;
    const vm_real slope_x = y[VM_DRUM_SLOPE], slope_y = y[VM_DRUM_SLOPE + 1];
    vm_real acceleration, drag, force_y;
    vmi_drum_mass m;
    int status = vmi_drum_mass_at(d, phi, 0, &m);
    if (status) return status;
    if (!(d->inertia > 0)) return VM_BAD_INERTIA;
    if (!(rate > 0)) return VM_DOMAIN;
    acceleration = (e - j * rate) / m.J; /* derivative of phi' with respect to phi (195) */
    drag = d->band / m.M + acceleration / rate;
    dydt[VM_DRUM_DEFLECTION] = slope_x;
    dydt[VM_DRUM_DEFLECTION + 1] = slope_y;
    force_y = d->band * d->speed * rate - d->stiffness * y[VM_DRUM_DEFLECTION + 1];
    dydt[VM_DRUM_SLOPE] = -drag * slope_x - d->stiffness * y[VM_DRUM_DEFLECTION] / (m.M * rate * rate);
    dydt[VM_DRUM_SLOPE + 1] = -drag * slope_y + force_y / (m.M * rate * rate);
    return VM_OK;
}

/* Right-hand side of the equations of the drum on an elastic shaft as a function of the angle phi, (210)-(212).
   Its type is ode_rhs. The state y has VM_DRUM_COUPLED_STATES numbers. `drum` must point to a vm_drum. The independent
   variable is the angle phi instead of time. Unlike vm_drum_rhs_angle, the function does not take the angular velocity
   u = dphi/dt from the rigid shaft, but integrates it together with the deflection x, y (m) and the time t (s). A prime
   ' means d/dphi. The equations are
     M u (u x')' = -c x - mu u^2 x' + mu R u^2 sin phi
     M u (u y')' = -c y + mu u (v - u y') - mu R u^2 cos phi
     J_S u' = e - j u - mu R u y',   t' = 1/u
   The letters are explained at vm_drum_rhs; e = mu v R - D and j = mu R^2. The terms with sin phi and cos phi come
   from the unbalance, which [1] leaves out. vm_drum_rhs_reduced gives the same motion. Returns VM_BAD_ARGUMENT for a
   null pointer; VM_DOMAIN if u is not positive; else a status of vm_drum_rhs. */
VM_API int vm_drum_rhs_coupled(vm_real phi, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    if (!VM_IS_FINITE(phi) || !VM_IS_FINITE(y[VM_DRUM_RATE]) || !vmi_drum_finite(d)) return VM_NOT_FINITE;
    const vm_real rate = y[VM_DRUM_RATE], slope_x = y[VM_DRUM_SLOPE], slope_y = y[VM_DRUM_SLOPE + 1];
    const vm_real unbalance = d->band * d->radius;
    vm_real turn, drag, force_x, force_y, s, c; /* turn: d(phi')/dphi */
    vmi_drum_mass m;
    const int status = vmi_drum_mass_at(d, phi, 0, &m);
    if (status) return status;
    if (!(rate > 0)) return VM_DOMAIN;
    vmi_sincos(phi, &s, &c);
    turn = (d->band * d->radius * (d->speed - rate * slope_y - d->radius * rate) - d->damping) / m.J;
    drag = d->band / m.M + turn / rate;
    force_x = unbalance * s - d->stiffness / rate * y[VM_DRUM_DEFLECTION] / rate;
    force_y = d->band * d->speed / rate - unbalance * c - d->stiffness / rate * y[VM_DRUM_DEFLECTION + 1] / rate;
    dydt[VM_DRUM_DEFLECTION] = slope_x;
    dydt[VM_DRUM_DEFLECTION + 1] = slope_y;
    dydt[VM_DRUM_SLOPE] = force_x / m.M - drag * slope_x;
    dydt[VM_DRUM_SLOPE + 1] = force_y / m.M - drag * slope_y;
    dydt[VM_DRUM_RATE] = turn;
    dydt[VM_DRUM_TIME] = 1 / rate;
    return VM_OK;
}

/* Angle at which the drum on a rigid shaft comes to rest, rad: J0 Omega_b/|e| if e = mu v R - D < 0.
   The drum approaches this angle as t grows, but never reaches it. Returns infinity for e >= 0, and NaN for a drum for
   which vm_drum_rate gives NaN. */
VM_API vm_real vm_drum_stop(const vm_drum *d)
{
    vm_two e;
    if (!vmi_drum_turns(d)) return VM_NAN;
    e = vmi_drum_e(d);
    if (!(e.hi < 0)) return VM_INFINITY;
    return vmi_two_over(vmi_two_product(d->inertia, d->omega), vmi_minus(e)).hi;
}

/* Time at which the drum on a rigid shaft reaches the angle phi >= 0, s (197).
   With x = e phi/(J0 Omega_b) and the letters explained at vm_drum_rate the time is
     t = phi/Omega_b [ln(1 + x)/x + (j phi/J0) (x - ln(1 + x))/x^2]
   for positive and negative e. The accuracy is that of vm_drum_rate. Returns infinity at exactly the angle at which the
   drum comes to rest. vm_drum_stop rounds this angle, so that the time at its result is usually a finite number or NaN.
   Returns NaN where vm_drum_rate gives NaN. */
VM_API vm_real vm_drum_time(const vm_drum *d, vm_real phi)
{
    vm_two x, y, s, sum, part = vmi_two(1, 0); /* y = ln(1 + x), s = j phi/J0, part = y/x */
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    x = vmi_drum_share(vmi_drum_e(d), phi, vmi_two_product(d->inertia, d->omega));
    s = vmi_drum_share(vmi_drum_j(d), phi, vmi_two(d->inertia, 0));
    sum = vmi_two_plus(vmi_two(1, 0), x);
    if (sum.hi == 0) return VM_INFINITY;
    if (!(sum.hi > 0)) return VM_NAN;
    y = vmi_log1p(x);
    if (VM_FABS(x.hi) > VM_EPSILON / 4) part = vmi_two_over(y, x);
    sum = vmi_two_plus(part, vmi_two_times(s, vmi_log1p_rest(x, y)));
    return vmi_drum_share(sum, phi, vmi_two(d->omega, 0)).hi;
}

/* Returns a start value of p for Newton's method in vm_drum_angle. The comment of vm_drum_angle has the equation for p
   and explains a, b, f, x, y. For a = 0 the term f^2 (x - y)/x^2 of this equation is p^2/2, and the equation has the
   solution p0 = 2/(1 + sqrt(1 + 2 b)), called p in the code. For a > 0 both p0 and ln(1 + a p0 + a^2/b)/a are larger
   than the solution, and the function takes the smaller of these two numbers. For a < 0 both p0 and |a|/(|a| + b) are
   smaller than the solution, and the function takes the larger of these two. */
VM_API vm_real vmi_drum_start(vm_real a, vm_real b)
{
    const vm_real p = 2 / (1 + VM_SQRT(1 + 2 * b));
    if (a < 0) return vmi_larger(p, a / (a - b));
    if (a * p > 1 && b > 0) return vmi_smaller((vmi_log(a).hi + vmi_log(1 / a + a / b + p).hi) / a, p);
    return p;
}

/* Angle of the drum on a rigid shaft after t >= 0 seconds, rad.
   This is the inverse of vm_drum_time, computed by Newton's method in two words. Unlike vm_drum_angle_lambert, the
   function need not choose a branch of Lambert's W.
   The comment of vm_drum_rate says how accurate the result is, when it is NaN, and what J0, Omega_b, e and j are. The
   result may also be NaN if j Omega_b t/J0 or e t/J0 is above VM_MAX/2^28 (in float VM_MAX/2^13), because such numbers
   overflow in two words. The method uses x = e phi/(J0 Omega_b), y = ln(1 + x), a = e t/J0, b = j Omega_b t/J0
   and f = phi/(Omega_b t). Its unknown is p = y/a, for which the equation of vm_drum_time becomes
     p + b f^2 (x - y)/x^2 = 1,   where x = exp(y) - 1 and f = p x/y.
   The left side is a convex function of p with the positive slope 1 + b f. Therefore the method converges from any
   start value. */
VM_API vm_real vm_drum_angle(const vm_drum *d, vm_real t)
{
    const vm_real precise = VM_EPSILON / 8; /* the relative error of phi that the last step may leave */
    const int most_steps = 40; /* quadratic convergence needs fewer steps */
    vm_two angle, a, b, p, x, y, f, rest;
    vm_real step, left = 1;
    int i;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    angle = vmi_two_product(d->omega, t);
    a = vmi_drum_share(vmi_drum_e(d), t, vmi_two(d->inertia, 0));
    b = vmi_two_over(vmi_two_times(vmi_drum_j(d), angle), vmi_two(d->inertia, 0));
    p = vmi_two(vmi_drum_start(a.hi, b.hi), 0);
    f = p;
    for (i = 0; i < most_steps && left > precise; i++) {
        y = vmi_two_times(a, p);
        x = vmi_expm1(y);
        f = p;
        if (VM_FABS(y.hi) > VM_EPSILON / 4) f = vmi_two_times(p, vmi_two_over(x, y));
        rest = vmi_two_times(vmi_two_times(vmi_two_times(b, f), f), vmi_log1p_rest(x, y));
        rest = vmi_two_plus(vmi_two_plus(vmi_two(1, 0), vmi_minus(p)), vmi_minus(rest));
        step = rest.hi / (1 + b.hi * f.hi);
        left = step / f.hi * (step / f.hi) * (1 + x.hi) * vmi_larger(1 + x.hi, 1);
        p = vmi_two_plus(p, vmi_two(step, 0));
        f = vmi_two_plus(f, vmi_two(step * (1 + x.hi), 0));
    }
    return vmi_two_times(angle, f).hi;
}

/* Angle of the drum, rad, on a rigid shaft by Lambert's W, (198)-(206) corrected.
   The letters J0, Omega_b, e, j are explained at vm_drum_rate. With r = 1 + e phi/(J0 Omega_b), k1 = 1 - e/(j Omega_b)
   and f1 = 1 + e^2 t/(J0 j Omega_b), the angle follows from r - k1 ln r = f1. The solution is r = -k1 W(x) with x =
   -exp(-f1/k1)/k1. W is the branch W_-1 for 0 < k1 < 1, and the branch W_0 for other k1. This function serves only for
   comparison, since vm_drum_angle is more accurate: near e = 0 the solution by W loses all digits, because x approaches
   the branch point of W. The code uses ln |x|, because x itself overflows or underflows for small k1 (for k1 = 1e-3 it
   may be 1e-868). Returns NaN for e = 0, for k1 = 0, for j = 0, and where vm_drum_rate returns NaN. */
VM_API vm_real vm_drum_angle_lambert(const vm_drum *d, vm_real t)
{
    vm_real j, e, k1, f1, l, w; /* l = ln |x|, w = W(x) */
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    j = vmi_drum_j(d).hi;
    e = vmi_drum_e(d).hi;
    k1 = 1 - e / (j * d->omega);
    if (k1 == 0 || e == 0) return VM_NAN;
    f1 = 1 + e * e * t / (d->inertia * j * d->omega);
    l = -vmi_log(VM_FABS(k1)).hi - f1 / k1;
    if (l > -1 && k1 > 0) l = -1; /* only rounding errors can make l larger than -1, the branch point of W */
    if (k1 < 0) w = vm_wright_omega(l);
    else if (e > 0) w = vm_lambert_wm1_neg_exp(l); /* e > 0 means k1 < 1, even if k1 has been rounded to 1 */
    else w = vm_lambert_w0_neg_exp(l);
    return (-k1 * w - 1) * d->inertia * d->omega / e;
}

/* Coefficients of the elastic shaft in the first approximation, (213), (214).
   Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if a field of *d or *s is infinite or NaN; VM_BAD_MASS if
   d->mass is not positive or d->band is negative; VM_BAD_STIFFNESS if d->stiffness is not positive; VM_BAD_INERTIA if
   d->inertia is not positive; VM_DOMAIN if d->omega is not positive; VM_OK otherwise. */
VM_API int vm_drum_shaft_init(vm_drum_shaft *s, const vm_drum *d)
{
    vm_drum_shaft r;
    vm_real j, drive, mass; /* the ratios j/J0, e/(J0 Omega_b), mu/M0 */
    if (!d || !s) return VM_BAD_ARGUMENT;
    if (!vmi_drum_finite(d)) return VM_NOT_FINITE;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->stiffness <= 0) return VM_BAD_STIFFNESS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    if (d->omega <= 0) return VM_DOMAIN;
    mass = d->band / d->mass;
    j = d->band * d->radius * d->radius / d->inertia;
    drive = vmi_drum_e(d).hi / (d->inertia * d->omega);
    r.k = VM_SQRT(d->stiffness / d->mass) / d->omega;
    r.delta = (mass + drive - j) / 2;
    r.A = mass + 2 * (drive - j);
    r.shift = mass * d->speed / (d->omega * r.k * r.k);
    if (!VM_IS_FINITE(r.k) || !VM_IS_FINITE(r.delta) || !VM_IS_FINITE(r.A) || !VM_IS_FINITE(r.shift))
        return VM_NOT_FINITE;
    *s = r;
    return VM_OK;
}

/* The oscillation in the closed form (224) at the angle phi: envelope * cosine is the deflection about the particular
   solution */
typedef struct VM_TAG(vmi_drum_wave) {
    vm_real square;       /* 1 - A phi */
    vm_real root;         /* the square root of 1 - A phi */
    vm_real envelope;     /* amplitude at this angle, m */
    vm_real sine, cosine; /* sine and cosine of the phase at this angle */
} vmi_drum_wave;

/* Sets *w for the angle phi, the amplitude a and the phase alpha at phi = 0. Returns 1, or 0 if 1 - A phi is not
   positive or a number is not finite. The letters are explained at vm_drum_deflection. */
VM_API int vmi_drum_wave_at(const vm_drum_shaft *s, vm_real phi, vm_real a, vm_real alpha, vmi_drum_wave *w)
{
    const vm_real square = 1 - s->A * phi, m = VM_SQRT(vmi_larger(square, 0));
    if (!(square > 0) || !VM_IS_FINITE(phi) || !VM_IS_FINITE(a)) return 0;
    w->square = square;
    w->root = m;
    w->envelope = a / VM_SQRT(m) * vmi_exp(-s->delta * phi, 0);
    vmi_sincos(2 * s->k / 3 * phi * ((1 + m + square) / (1 + m)) + alpha, &w->sine, &w->cosine);
    return 1;
}

/* Deflection x or y of the elastic shaft, m, at the angle phi, (224), (225) corrected.
   With the fields k, delta, A of *s the deflection is
     a (1 - A phi)^(-1/4) exp(-delta phi) cos(I + alpha) + particular/(1 - A phi),
   where I is the integral of k sqrt(1 - A phi) from 0 to phi. `particular` must be 0 for x and s->shift for y.
   vm_drum_deflection_start computes the amplitude a (m) and the phase alpha (rad) from the deflection and the slope at
   phi = 0, where the deflection is a cos alpha + particular. With m^2 = 1 - A phi the integral is
   I = 2k/(3A) (1 - m^3). It is computed as (2k/3) phi (1 + m + m^2)/(1 + m), which holds for A = 0, too. [1] leaves
   out the unbalance of the band; vm_drum_unbalance computes the deflection that the unbalance causes. Returns NaN for
   a null pointer and if 1 - A phi <= 0. */
VM_API vm_real vm_drum_deflection(const vm_drum_shaft *s, vm_real phi, vm_real a, vm_real alpha, vm_real particular)
{
    vmi_drum_wave w;
    if (!s || !VM_IS_FINITE(particular) || !vmi_drum_wave_at(s, phi, a, alpha, &w)) return VM_NAN;
    return w.envelope * w.cosine + particular / w.square;
}

/* Derivative of vm_drum_deflection with respect to the angle phi, m/rad: (218), (220) corrected.
   The deflection is a product of an amplitude and a cosine, plus a particular solution. Its derivative is
     amplitude [(A/(4 m^2) - delta) cos(I + alpha) - k m sin(I + alpha)] + A particular/m^4,   m^2 = 1 - A phi,
   with the letters of vm_drum_deflection. The dissertation [1] leaves out the term with A/4, and its last term is
   different. The derivative multiplied by the angular velocity phi' is the velocity of the shaft's centre. The
   absolute error is a few rounding errors of the product amplitude (k m + |delta|), plus the effect of the rounding
   error of the phase. Returns NaN where vm_drum_deflection does. */
VM_API vm_real vm_drum_deflection_slope(const vm_drum_shaft *s, vm_real phi, vm_real a, vm_real alpha,
                                        vm_real particular)
{
    vmi_drum_wave w;
    vm_real growth;
    if (!s || !VM_IS_FINITE(particular) || !vmi_drum_wave_at(s, phi, a, alpha, &w)) return VM_NAN;
    growth = s->A / (4 * w.square) - s->delta;
    return w.envelope * (growth * w.cosine - s->k * w.root * w.sine) + s->A * particular / w.square / w.square;
}

/* Amplitude and phase (223) of the elastic shaft from deflection and slope at phi = 0.
   `deflection` is x or y (m) when the winding begins, and `slope` is its derivative with respect to phi (m/rad). If you
   know a velocity in m/s, divide it by Omega_b to get the slope. `particular` must be 0 for x and s->shift for y. The
   function sets *a to the amplitude a >= 0 (m) and *alpha to the phase in [-pi, pi] (rad). Amplitude and phase follow
   from the equations
     a cos alpha = deflection - particular,   a k sin alpha = (A/4 - delta) a cos alpha + A particular - slope.
   The errors of a cos alpha and of a k sin alpha are a few rounding errors of the terms on the right-hand sides.
   Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument or the result is infinite or NaN; VM_DOMAIN
   if s->k is not positive; VM_OK otherwise. */
VM_API int vm_drum_deflection_start(const vm_drum_shaft *s, vm_real deflection, vm_real slope, vm_real particular,
                                    vm_real *a, vm_real *alpha)
{
    vm_real cosine, sine, size; /* a cos alpha, a sin alpha, a */
    if (!s || !a || !alpha) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(deflection) || !VM_IS_FINITE(slope) || !VM_IS_FINITE(particular) || !VM_IS_FINITE(s->k) ||
        !VM_IS_FINITE(s->A) || !VM_IS_FINITE(s->delta))
        return VM_NOT_FINITE;
    if (s->k <= 0) return VM_DOMAIN;
    cosine = deflection - particular;
    sine = ((s->A / 4 - s->delta) * cosine + (s->A * particular - slope)) / s->k;
    size = vmi_hypot(cosine, sine);
    if (!VM_IS_FINITE(size)) return VM_NOT_FINITE;
    *a = size;
    *alpha = 0;
    if (size > 0) *alpha = vmi_atan2(sine, cosine);
    return VM_OK;
}

/* Sets *sinc to sin(x)/x, which is 1 at x = 0, and *cosine to the cosine of x. */
VM_API void vmi_drum_sinc(vm_real x, vm_real *sinc, vm_real *cosine)
{
    vm_real sine;
    vmi_sincos(x, &sine, cosine);
    *sinc = 1;
    if (x != 0) *sinc = sine / x;
}

/* Deflection of the elastic shaft by the unbalance of the band, which (224), (225) leave out.
   The band's mass centre is not on the axis of the shaft. Therefore (213) needs the term U sin phi on its right side,
   and (214) the term -U cos phi, with U = mu R/M0. These terms are of the same order as the term mu v/(M0 Omega_b),
   which [1] keeps. Add deflection[0] (m) to the result of vm_drum_deflection for x, and deflection[1] to the result
   for y. Add slope[0] and slope[1] (m/rad) in the same way to the results of vm_drum_deflection_slope. All four
   numbers are 0 at phi = 0, so that vm_drum_deflection_start needs no change. With k, the field of vm_drum_shaft, the
   deflections are
     x = U (sin phi - sin(k phi)/k)/(k^2 - 1),   y = -U (cos phi - cos(k phi))/(k^2 - 1).
   At the resonance k = 1 the function computes the limits of these formulas, which grow with phi. phi >= 0 is in rad.
   Let h be the largest of mu/M0, j/J0, |e|/(J0 Omega_b) and the deflections divided by R. The error of the whole
   deflection is of the order of h^2. The rounding errors of y and of the slopes are a few eps times U phi (1 + phi),
   and those of x a few eps times U phi (1 + phi)/k. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an
   argument or the result is infinite or NaN; VM_DOMAIN if phi is negative; else a status of vm_drum_shaft_init. */
VM_API int vm_drum_unbalance(const vm_drum *d, vm_real phi, vm_real deflection[2], vm_real slope[2])
{
    vm_drum_shaft s;
    vm_real size, x, sine, cosine, half, result[4];
    vm_real sum, sum_cosine, gap, gap_cosine; /* sin(z)/z and cos z of z = (k + 1) phi/2 and of z = (k - 1) phi/2 */
    int status;
    if (!d || !deflection || !slope) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(phi)) return VM_NOT_FINITE;
    status = vm_drum_shaft_init(&s, d);
    if (status) return status;
    if (phi < 0) return VM_DOMAIN;
    half = phi / 2;
    size = d->band / d->mass * d->radius * half; /* U phi/2 */
    vmi_drum_sinc((s.k + 1) * half, &sum, &sum_cosine);
    vmi_drum_sinc((s.k - 1) * half, &gap, &gap_cosine);
    x = (sum * gap_cosine - sum_cosine * gap) / s.k;
    if (s.k < VM_C(0.5)) { /* far from the resonance this form has no division by k */
        vmi_drum_sinc(phi, &sine, &cosine);
        vmi_drum_sinc(s.k * phi, &x, &cosine);
        x = 2 * (x - sine) / ((1 - s.k) * (1 + s.k));
    }
    result[0] = size * x;
    result[1] = -size * phi * sum * gap;
    result[2] = size * phi * sum * gap;
    result[3] = -size * (sum * gap_cosine + sum_cosine * gap);
    if (!vmi_all_finite(4, result)) return VM_NOT_FINITE;
    deflection[0] = result[0];
    deflection[1] = result[1];
    slope[0] = result[2];
    slope[1] = result[3];
    return VM_OK;
}

/* Angular velocity phi' on an elastic shaft, rad/s: (196) corrected by the deflection (224).
   `rise` is the deflection y(phi) - y(0) in the band's direction since the winding began, m, for example by
   vm_drum_deflection and vm_drum_unbalance. If the drum rises in the direction of the band, the band moves more slowly
   relative to the drum, and therefore drives the drum less. To the first order in `rise`, (212) and (215) give
     phi' = vm_drum_rate [1 - mu R rise/(J0 + j phi)].
   mu is the mass of the band per angle, R the radius, J0 the drum's inertia and j = mu R^2. Let h be the largest of the
   four numbers mu R |rise|/J0, mu/M0, j/J0 and |e|/(J0 Omega_b). The error is of the order of h^2 Omega_b: if all four
   numbers are halved, the error is divided by four. Returns NaN where vm_drum_rate does, and for a rise that is not
   finite. */
VM_API vm_real vm_drum_rate_elastic(const vm_drum *d, vm_real phi, vm_real rise)
{
    const vm_real rate = vm_drum_rate(d, phi);
    if (rate != rate || !VM_IS_FINITE(rise)) return VM_NAN;
    return rate * (1 - d->band * d->radius * rise / (d->inertia + d->band * d->radius * d->radius * phi));
}

/* Tests whether the shaft's frequency k sqrt(1 - A phi) stays real until the first layer is complete (226).
   The first layer is complete at phi = 2 pi. Returns 1 if A < 1/(2 pi). Returns 0 otherwise, and for a null pointer. */
VM_API int vm_drum_shaft_valid(const vm_drum_shaft *s) { return s && s->A < 1 / (2 * VM_PI); }

#endif
