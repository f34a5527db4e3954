/* mechanics/broken_rotor.h - a rotor from which a piece breaks off */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/hypot.h"
#include "../base/polynomial.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"

/* A disc on an elastic shaft without mass, turned by a torque against viscous damping, in the plane. The shaft goes
   through the mass centre of the whole (s = 0) and passes the remainder's at distance s: at r + s (cos psi, sin psi).
   Its state is y[6] = {x, y, psi, x', y', psi'} as rk45 takes it: mass centre from where the shaft is at rest (m),
   angle (rad), rates. In the notation of (67): omega^2 = stiffness/mass, p^2 = mass/inertia,
   k* = damping/inertia, M* = torque/inertia. */
typedef struct VM_TAG(vm_broken_rotor) {
    vm_real mass;      /* kg, > 0 */
    vm_real inertia;   /* about the own mass centre, kg m^2, > 0 */
    vm_real stiffness; /* c of the shaft, N/m, >= 0 */
    vm_real damping;   /* k, N m s */
    vm_real torque;    /* N m */
    vm_real s;         /* m */
} vm_broken_rotor;

/* The break, (52)-(64) corrected: the whole touches the stator at A and loses a piece, of which A keeps its velocity
   while S2 loses that across S2A (57). This is an assumption of [1]; everything else follows by momenta. */
typedef struct VM_TAG(vm_broken_rotor_piece) {
    vm_real mass, inertia; /* m; I_S2 about the own mass centre S2, >= 0 */
    vm_real distance;      /* SS2, m */
    vm_real alpha;         /* angle from SS2 to SA, counterclockwise (Fig. 17: S2 at -alpha from SA) */
    vm_real radius;        /* SA, m */
    vm_real contact;       /* direction angle of SA in inertial axes */
} vm_broken_rotor_piece;

typedef struct VM_TAG(vm_broken_rotor_break) {
    vm_broken_rotor rest;      /* the remainder: I_S1 by the parallel axes, s = m SS2/(M - m); the rest is the whole's */
    vm_real state[6];   /* its state, psi being the direction from S1 to the shaft, which is that of SS2 */
    vm_real piece[6];   /* the piece's state, psi likewise */
    vm_real dragging;   /* v_S2d (52), (61): speed of S2 before, and */
    vm_real gamma;      /* its angle from SA (52), (60); both for v_S in any direction */
    vm_real beta;       /* angle of S2A from SA, tan beta = SS2 sin alpha/(R - SS2 cos alpha)  [(56) corrected] */
    vm_real normal;     /* N (54), m/s, along S2A, */
    vm_real tangential; /* T = v_S2d sin(gamma - beta) across it, counterclockwise  [(55) with the other sign] */
    vm_real spin_piece; /* Omega_r = T/AS2 (57), (63) */
    vm_real spin_rest;  /* Omega_r1, from I_S1 Omega_r1 = -I_S2 Omega_r + m M/(M - m) SS2 x v_T  [(58) corrected] */
    vm_real stop_inertia; /* the I_S2 that would stop the rest, where there is one: I_S (R - SS2)/R for alpha = 0
                             [after (64), corrected] */
} vm_broken_rotor_break;

VM_API int vmi_check_rotor(const vm_broken_rotor *r)
{
    if (!VM_IS_FINITE(r->mass) || !VM_IS_FINITE(r->inertia) || !VM_IS_FINITE(r->stiffness) ||
        !VM_IS_FINITE(r->damping) || !VM_IS_FINITE(r->torque) || !VM_IS_FINITE(r->s))
        return VM_NOT_FINITE;
    if (!(r->mass > 0)) return VM_BAD_MASS;
    if (!(r->inertia > 0)) return VM_BAD_INERTIA;
    return r->stiffness >= 0 ? VM_OK : VM_DOMAIN;
}

/* (65), (66), (68), and (46) for s = 0, as an ode_rhs for n = 6; rotor points at a vm_broken_rotor */
VM_API int vm_broken_rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    vm_real sine, cosine, fx, fy;
    (void)t;
    vmi_sincos(y[2], &sine, &cosine);
    fx = -r->stiffness * (y[0] + r->s * cosine);
    fy = -r->stiffness * (y[1] + r->s * sine); /* (66) */
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = fx / r->mass;
    dydt[4] = fy / r->mass;
    dydt[5] = (r->torque - r->damping * y[5] + r->s * (cosine * fy - sine * fx)) / r->inertia;
    return 0;
}

/* (67), and the coupling s p^2 omega^2 of (69) */
typedef struct VM_TAG(vmi_broken_rotor_linear) {
    vm_real omega, k, torque, s, coupling;
} vmi_broken_rotor_linear;

VM_API vmi_broken_rotor_linear vmi_broken_rotor_reduced(const vm_broken_rotor *r, int coupled)
{
    vmi_broken_rotor_linear a;
    a.omega = VM_SQRT(r->stiffness / r->mass);
    a.k = r->damping / r->inertia;
    a.torque = r->torque / r->inertia;
    a.s = r->s;
    a.coupling = coupled ? r->s * (r->stiffness / r->inertia) : 0;
    return a;
}

/* What z = y, psi, y', psi' of (69) changes by within h, by the series in t, for |h| times vmi_broken_rotor_rate at most
   1: the n-th terms of y and of s psi are then below 1/n! of the first ones */
VM_API void vmi_broken_rotor_series(const vmi_broken_rotor_linear *a, vm_real h, const vm_real *z, vm_real *change)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    const vm_real omega_h2 = (a->omega * h) * (a->omega * h), k_h = a->k * h, coupling_h2 = a->coupling * h * h;
    vm_real y0 = z[0], psi0 = z[1], y1 = z[2] * h, psi1 = z[3] * h, drive = a->torque * h * h;
    int n;
    change[0] = y1;
    change[1] = psi1;
    change[2] = change[3] = 0;
    for (n = 2; n < terms && h != 0; n++) {
        const vm_real share = 1 / (vm_real)(n * (n - 1)), y2 = -omega_h2 * (y0 + a->s * psi0) * share;
        const vm_real psi2 = (drive - k_h * (vm_real)(n - 1) * psi1 - coupling_h2 * y0) * share;
        change[0] += y2;
        change[1] += psi2;
        change[2] += (vm_real)n * y2 / h;
        change[3] += (vm_real)n * psi2 / h;
        y0 = y1;
        psi0 = psi1;
        y1 = y2;
        psi1 = psi2;
        drive = 0;
    }
}

VM_API vm_real vmi_broken_rotor_rate(const vmi_broken_rotor_linear *a)
{
    return VM_FABS(a->k) + VM_C(1.5) * a->omega + VM_SQRT(VM_FABS(a->s * a->coupling));
}

/* (e^z - 1)/z and (e^z - 1 - z)/z^2, to a few eps */
VM_API void vmi_broken_rotor_exp_quotients(vm_real z, vm_real *phi1, vm_real *phi2)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    int n;
    if (VM_FABS(z) > 1) {
        *phi1 = (vmi_exp(z, 0) - 1) / z;
        *phi2 = (*phi1 - 1) / z;
        return;
    }
    *phi2 = 0;
    for (n = terms; n >= 2; n--) *phi2 = (1 + z * *phi2) / (vm_real)n;
    *phi1 = 1 + z * *phi2;
}

/* w - sin w, given sin w */
VM_API vm_real vmi_broken_rotor_less_sine(vm_real w, vm_real sine)
{
    const int terms = VM_MANT_DIG > 24 ? 19 : 11;
    vm_real sum = 0;
    int n;
    if (VM_FABS(w) > 1) return w - sine;
    for (n = terms; n >= 3; n -= 2) sum = w * w * (1 - sum) / (vm_real)(n * (n - 1));
    return w * sum;
}

/* cos wt, 1 - cos wt, w sin wt, sin wt/w, t - sin wt/w */
typedef struct VM_TAG(vmi_broken_rotor_swing) {
    vm_real c, c1, w_s, s_w, late;
} vmi_broken_rotor_swing;

VM_API vmi_broken_rotor_swing vmi_broken_rotor_swing_at(vm_real t, vm_real w)
{
    vmi_broken_rotor_swing g;
    vm_real half, sine;
    vmi_sincos(w * t / 2, &half, &g.c);
    vmi_sincos(w * t, &sine, &g.c);
    g.c1 = 2 * half * half;
    g.w_s = w * sine;
    g.s_w = w > 0 ? sine / w : t;
    g.late = w > 0 ? vmi_broken_rotor_less_sine(w * t, sine) / w : 0;
    return g;
}

/* (71), (72) with M* in the place of k* Omega, for z = y, psi, y', psi' and |t| times the rate of 1 and more. y
   answers to -s psi, and psi = psi0 + psi0' E1 + M* E2, E1 = (1 - e^(-kt))/k, E2 = (t - E1)/k. g0, g1, g2 solve g''
   + w^2 g = w^2 E1', w^2 E1, w^2 E2 from rest, so that g2' = g1 and g1' = g0. */
VM_API void vmi_broken_rotor_follow(vm_real t, const vmi_broken_rotor_linear *a, const vmi_broken_rotor_swing *g, vm_real *z)
{
    const vm_real w2 = a->omega * a->omega, sum = w2 + a->k * a->k;
    const vm_real y0 = z[0], psi0 = z[1], v0 = z[2], rate0 = z[3];
    vm_real E0, E1, E2, g0, g1, g2;
    vmi_broken_rotor_exp_quotients(-a->k * t, &E1, &E2);
    E0 = vmi_exp(-a->k * t, 0);
    E1 *= t;
    E2 *= t * t;
    g0 = w2 * ((E0 - g->c) + a->k * g->s_w) / sum;
    g1 = (w2 * (E1 - g->s_w) + a->k * g->c1) / sum;
    g2 = (w2 * E2 + (a->k * g->late - g->c1)) / sum;
    z[0] = y0 * g->c + v0 * g->s_w - a->s * (psi0 * g->c1 + (rate0 * g1 + a->torque * g2));
    z[1] = psi0 + (rate0 * E1 + a->torque * E2);
    z[2] = v0 * g->c - y0 * g->w_s - a->s * (psi0 * g->w_s + (rate0 * g0 + a->torque * g1));
    z[3] = rate0 * E0 + a->torque * E1;
}

/* z changes by M (z, 1), M = [exp(A t) - E | answer to the torque]: doubled from where the series holds, by
   2 M + M M, which keeps the digits that E would swallow */
VM_API void vmi_broken_rotor_double(vm_real t, const vmi_broken_rotor_linear *a, vm_real *z)
{
    vm_real m[5][4], old[5][4], unit[4], h = t; /* m[j]: of the unit state j, of the torque for j = 4 */
    vmi_broken_rotor_linear driven = *a;
    int doublings = 0, i, j, k;
    for (; VM_FABS(h) * vmi_broken_rotor_rate(a) > 1; h /= 2) doublings++;
    if (doublings == 0) {
        vmi_broken_rotor_series(a, h, z, unit);
        for (i = 0; i < 4; i++) z[i] += unit[i];
        return;
    }
    for (j = 0; j < 5; j++) {
        for (i = 0; i < 4; i++) unit[i] = i == j;
        driven.torque = j < 4 ? 0 : a->torque;
        vmi_broken_rotor_series(&driven, h, unit, m[j]);
    }
    for (; doublings > 0; doublings--) {
        memcpy(old, m, sizeof m);
        for (j = 0; j < 5; j++)
            for (i = 0; i < 4; i++)
                for (m[j][i] *= 2, k = 0; k < 4; k++) m[j][i] += old[k][i] * old[j][k];
    }
    memcpy(unit, z, sizeof unit);
    for (i = 0; i < 4; i++) {
        vm_real change = m[4][i];
        for (j = 0; j < 4; j++) change += m[j][i] * unit[j];
        z[i] += change;
    }
}

VM_API int vmi_broken_rotor_linearised(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, int coupled, vm_real *end)
{
    vm_real y[6], z[4];
    vmi_broken_rotor_linear a;
    vmi_broken_rotor_swing g;
    int status;
    if (!rotor || !start || !end) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_all_finite(6, start)) return VM_NOT_FINITE;
    status = vmi_check_rotor(rotor);
    if (status) return status;
    a = vmi_broken_rotor_reduced(rotor, coupled);
    g = vmi_broken_rotor_swing_at(t, a.omega);
    z[0] = start[1];
    z[1] = start[2];
    z[2] = start[4];
    z[3] = start[5];
    if (coupled || VM_FABS(t) * vmi_broken_rotor_rate(&a) <= 1) vmi_broken_rotor_double(t, &a, z);
    else vmi_broken_rotor_follow(t, &a, &g, z);
    y[0] = start[0] * g.c + (start[3] * g.s_w - a.s * g.c1); /* (70) */
    y[3] = start[3] * g.c - g.w_s * (start[0] + a.s);
    y[1] = z[0];
    y[2] = z[1];
    y[4] = z[2];
    y[5] = z[3];
    return vmi_copy_if_finite(6, y, end);
}

/* The remainder for short times, |psi| << 1, linearised: (69) complete; and without its term -s y omega^2 p^2,
   which (70)-(72) leave out, though it is of the order of the others. Both for any k*, omega, s, zero included, and
   accurate as vm_broken_rotor_free_motion is (the first to twice that). All of (69) grows exponentially: VM_NOT_FINITE where it
   overflows. */
VM_API int vm_broken_rotor_linear(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(t, rotor, start, 1, end);
}

/* Documented with vm_broken_rotor_linear. */
VM_API int vm_broken_rotor_linear_uncoupled(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(t, rotor, start, 0, end);
}

/* State at t after start by (46)-(51), exact; VM_DOMAIN unless s = 0. damping and stiffness may be 0; end may be
   start, here and below. Error: no more than the rounding of every input, t included, would do. */
/* With s = 0 the uncoupled equations are (46) itself. */
VM_API int vm_broken_rotor_free_motion(vm_real t, const vm_broken_rotor *rotor, const vm_real *start, vm_real *end)
{
    if (rotor && rotor->s != 0) return rotor->s - rotor->s == 0 ? VM_DOMAIN : VM_NOT_FINITE;
    return vmi_broken_rotor_linearised(t, rotor, start, 0, end);
}

/* A0, B0, C0, D0 (51), m, of x + i y = (A0 + i B0) exp(i w t) + (C0 + i D0) exp(-i w t) (50), w^2 = stiffness/mass,
   not 0. The orbit's half axes are | |A0 + i B0| +- |C0 + i D0| |. The speed at t, wrong after (52), is
     w sqrt(A0^2 + B0^2 + C0^2 + D0^2 - 2 (A0 C0 + B0 D0) cos 2 w t + 2 (B0 C0 - A0 D0) sin 2 w t) */
VM_API int vm_broken_rotor_orbit(const vm_broken_rotor *rotor, const vm_real *start, vm_real *abcd)
{
    vm_real w, vx, vy, c[4];
    int status;
    if (!rotor || !start || !abcd) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, start)) return VM_NOT_FINITE;
    status = vmi_check_rotor(rotor);
    if (!status && rotor->stiffness == 0) status = VM_DOMAIN;
    if (status) return status;
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    vx = start[3] / w;
    vy = start[4] / w;
    c[0] = (start[0] + vy) / 2;
    c[1] = (start[1] - vx) / 2;
    c[2] = (start[0] - vy) / 2;
    c[3] = (start[1] + vx) / 2;
    return vmi_copy_if_finite(4, c, abcd);
}

/* -- The break, in axes along SA and counterclockwise across it -- */
VM_API int vmi_check_piece(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p)
{
    if (!VM_IS_FINITE(p->mass) || !VM_IS_FINITE(p->inertia) || !VM_IS_FINITE(p->distance) ||
        !VM_IS_FINITE(p->alpha) || !VM_IS_FINITE(p->radius) || !VM_IS_FINITE(p->contact))
        return VM_NOT_FINITE;
    if (!(p->mass > 0 && p->mass < whole->mass)) return VM_BAD_MASS;
    return p->inertia >= 0 ? VM_OK : VM_BAD_INERTIA;
}

/* (x, y) turned by the angle whose sine and cosine are given */
VM_API void vmi_broken_rotor_turn(vm_real sine, vm_real cosine, vm_real *x, vm_real *y)
{
    const vm_real x0 = *x;
    *x = cosine * x0 - sine * *y;
    *y = sine * x0 + cosine * *y;
}

/* State of a body whose mass centre is at d from S, at angle psi, moving relative to the whole by (ux, uy), spin */
VM_API void vmi_broken_rotor_moved(const vm_real *before, vm_real psi, vm_real dx, vm_real dy, vm_real ux, vm_real uy,
                            vm_real spin, vm_real *state)
{
    state[0] = before[0] + dx;
    state[1] = before[1] + dy;
    state[2] = psi;
    state[3] = before[3] - before[5] * dy + ux;
    state[4] = before[4] + before[5] * dx + uy;
    state[5] = before[5] + spin;
}

/* Mass, inertia and eccentricity of the rest */
VM_API int vmi_broken_rotor_rest(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_broken_rotor *rest)
{
    const vm_real left = whole->mass - p->mass, share = p->mass / left;
    *rest = *whole;
    rest->mass = left;
    rest->inertia = (whole->inertia - p->inertia) - share * whole->mass * (p->distance * p->distance);
    rest->s = share * p->distance;
    return rest->inertia > 8 * VM_EPSILON * whole->inertia ? VM_OK : VM_BAD_INERTIA;
}

/* (52)-(58), all but rest, state and piece, from SS2 and v_S in axes along SA and counterclockwise across it; e is
   the direction of S2A. Returns AS2. */
VM_API vm_real vmi_broken_rotor_contact(const vm_broken_rotor *whole, const vm_broken_rotor_piece *p, vm_real spin, const vm_real *d,
                                 const vm_real *v, vm_real *e, vm_broken_rotor_break *b)
{
    const vm_real ux = v[0] - spin * d[1], uy = v[1] + spin * d[0], reduced = p->mass / b->rest.mass * whole->mass;
    const vm_real reach_x = p->radius - d[0], reach_y = -d[1], reach = vmi_hypot(reach_x, reach_y);
    vm_real moment; /* SS2 x v_T */
    e[0] = reach_x / reach;
    e[1] = reach_y / reach;
    b->dragging = vmi_hypot(ux, uy);
    b->gamma = vmi_atan2(uy, ux);
    b->beta = vmi_atan2(reach_y, reach_x);
    b->normal = ux * e[0] + uy * e[1];
    b->tangential = uy * e[0] - ux * e[1];
    moment = b->tangential * (d[0] * e[0] + d[1] * e[1]);
    b->spin_piece = b->tangential / reach;
    b->spin_rest = (reduced * moment - p->inertia * b->spin_piece) / b->rest.inertia;
    b->stop_inertia = (whole->inertia * spin + reduced * (moment - p->distance * p->distance * spin)) /
                      (spin + b->spin_piece);
    return reach;
}

/* The remainder's spin, state[5], is Omega_b + Omega_r1  [(59), (64) corrected]. Refuses m not in (0, M), an I_S1
   that is negative or lost in rounding errors (VM_BAD_INERTIA), a whole with s != 0 and S2 at A (VM_DOMAIN). */
VM_API int vm_broken_rotor_break_off(const vm_broken_rotor *whole, const vm_real *before, const vm_broken_rotor_piece *piece,
                              vm_broken_rotor_break *result)
{
    vm_broken_rotor_break b;
    vm_real sine, cosine, d[2], v[2], e[2], share, T;
    int status;
    if (!whole || !before || !piece || !result) return VM_BAD_ARGUMENT;
    status = vmi_check_rotor(whole);
    if (!status) status = vmi_all_finite(6, before) ? vmi_check_piece(whole, piece) : VM_NOT_FINITE;
    if (!status && whole->s != 0) status = VM_DOMAIN;
    if (!status) status = vmi_broken_rotor_rest(whole, piece, &b.rest);
    if (status) return status;

    vmi_sincos(piece->alpha, &sine, &cosine);
    d[0] = piece->distance * cosine;
    d[1] = -piece->distance * sine;
    vmi_sincos(piece->contact, &sine, &cosine);
    v[0] = before[3];
    v[1] = before[4];
    vmi_broken_rotor_turn(-sine, cosine, &v[0], &v[1]);
    if (!(vmi_broken_rotor_contact(whole, piece, before[5], d, v, e, &b) > 0)) return VM_DOMAIN;

    vmi_broken_rotor_turn(sine, cosine, &d[0], &d[1]);
    vmi_broken_rotor_turn(sine, cosine, &e[0], &e[1]);
    share = piece->mass / b.rest.mass;
    T = b.tangential;
    vmi_broken_rotor_moved(before, piece->contact - piece->alpha, d[0], d[1], T * e[1], -T * e[0], b.spin_piece, b.piece);
    vmi_broken_rotor_moved(before, piece->contact - piece->alpha, -share * d[0], -share * d[1], -share * T * e[1],
                    share * T * e[0], b.spin_rest, b.state);
    if (!vmi_all_finite(6, b.state) || !vmi_all_finite(6, b.piece)) return VM_NOT_FINITE;
    *result = b;
    return VM_OK;
}

/* Polar form (75), y[6] = {r, phi, psi, r', phi', psi'}; stops the run with VM_DOMAIN at r = 0. The conversions
   refuse r = 0 and r < 0. */
/* -- Polar form -- */
VM_API int vm_broken_rotor_polar_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *rotor)
{
    if (!y || !dydt || !rotor) return VM_BAD_ARGUMENT;
    const vm_broken_rotor *r = (const vm_broken_rotor *)rotor;
    const vm_real w2 = r->stiffness / r->mass;
    vm_real sine, cosine;
    (void)t;
    if (!(y[0] > 0)) return VM_DOMAIN;
    vmi_sincos(y[1] - y[2], &sine, &cosine);
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = y[0] * (y[4] * y[4]) - w2 * (y[0] + r->s * cosine);
    dydt[4] = (r->s * w2 * sine - 2 * y[3] * y[4]) / y[0];
    dydt[5] = (r->torque - r->damping * y[5] - r->s * r->stiffness * y[0] * sine) / r->inertia;
    return 0;
}

/* Documented with vm_broken_rotor_polar_rhs. */
VM_API int vm_broken_rotor_to_polar(const vm_real *y, vm_real *polar)
{
    vm_real p[6], c, s;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, y)) return VM_NOT_FINITE;
    p[0] = vmi_hypot(y[0], y[1]);
    if (!(p[0] > 0)) return VM_DOMAIN;
    c = y[0] / p[0];
    s = y[1] / p[0];
    p[1] = vmi_atan2(y[1], y[0]);
    p[2] = y[2];
    p[3] = c * y[3] + s * y[4];
    p[4] = (c * y[4] - s * y[3]) / p[0];
    p[5] = y[5];
    return vmi_copy_if_finite(6, p, polar);
}

/* Documented with vm_broken_rotor_polar_rhs. */
VM_API int vm_broken_rotor_from_polar(const vm_real *polar, vm_real *y)
{
    vm_real z[6], c, s, across;
    if (!y || !polar) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(6, polar)) return VM_NOT_FINITE;
    if (!(polar[0] > 0)) return VM_DOMAIN;
    vmi_sincos(polar[1], &s, &c);
    across = polar[0] * polar[4];
    z[0] = polar[0] * c;
    z[1] = polar[0] * s;
    z[2] = polar[2];
    z[3] = polar[3] * c - across * s;
    z[4] = polar[3] * s + across * c;
    z[5] = polar[5];
    return vmi_copy_if_finite(6, z, y);
}

/* -- The steady motion and its stability -- */
/* (omega^2 - Omega^2) mass, whose sign is right and whose relative error is an eps however near resonance is */
VM_API vm_real vmi_broken_rotor_detuning(const vm_broken_rotor *r, vm_real Omega)
{
    const vm_two load = vmi_two_times(vmi_two_product(r->mass, Omega), vmi_two(-Omega, 0));
    const vm_two left = vmi_two_plus(vmi_two(r->stiffness, 0), load);
    return left.hi + left.lo;
}

/* Steady motion at psi' = Omega, which needs torque = damping Omega (47). r_SS = s omega^2/(omega^2 - Omega^2), m:
   positive as in (77), phi = psi + pi, where Omega^2 < omega^2; negative as in (76), phi = psi. Infinite at resonance
   (NaN for s = 0). Within 2 eps however near resonance is. */
VM_API vm_real vm_broken_rotor_steady_radius(const vm_broken_rotor *rotor, vm_real Omega)
{
    vm_real detuning, share;
    if (!rotor || vmi_check_rotor(rotor) || !VM_IS_FINITE(Omega)) return VM_NAN;
    detuning = vmi_broken_rotor_detuning(rotor, Omega);
    if (VM_IS_FINITE(detuning)) return rotor->s * (rotor->stiffness / detuning);
    share = rotor->stiffness / (rotor->mass * Omega) / Omega; /* omega^2/Omega^2 < 1: mass Omega^2 overflows */
    return -rotor->s * (share / (1 - share));
}

/* w^2, O^2, k*, D and G of (81) */
typedef struct VM_TAG(vmi_broken_rotor_steady) {
    vm_real w2, O2, k, D, G;
} vmi_broken_rotor_steady;

VM_API int vmi_broken_rotor_about_steady(const vm_broken_rotor *r, vm_real Omega, vmi_broken_rotor_steady *a)
{
    int status;
    vm_real detuning;
    if (!r) return VM_BAD_ARGUMENT;
    status = VM_IS_FINITE(Omega) ? vmi_check_rotor(r) : VM_NOT_FINITE;
    if (status) return status;
    detuning = vmi_broken_rotor_detuning(r, Omega);
    if (detuning == 0) return VM_DOMAIN;
    a->w2 = r->stiffness / r->mass;
    a->O2 = Omega * Omega;
    a->k = r->damping / r->inertia;
    a->D = detuning / r->mass;
    a->G = r->s * (r->stiffness / detuning) * (r->s * r->stiffness / r->inertia);
    return VM_OK;
}

/* Small motions about it, exp(lambda t). (81) corrected (its last term lacks lambda^2) is lambda times the polynomial
     l^5 + k* l^4 + (2 (w^2 + O^2) + G) l^3 + 2 k* (w^2 + O^2) l^2 + (D^2 + G (w^2 + 3 O^2)) l + k* D^2,
   D = w^2 - O^2, G = s^2 p^2 w^4/D: c[6], highest power first. lambda = 0 is the freedom of the phase. */
VM_API int vm_broken_rotor_characteristic(const vm_broken_rotor *rotor, vm_real Omega, vm_real *c)
{
    vmi_broken_rotor_steady a;
    vm_real p[6];
    int status = c ? vmi_broken_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = 2 * (a.w2 + a.O2) + a.G;
    p[3] = 2 * a.k * (a.w2 + a.O2);
    p[4] = a.D * a.D + a.G * (a.w2 + 3 * a.O2);
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(6, p, c);
}

/* Routh's first column 1, k*, G, k* D, 4 G Omega^2, k* D^2 */
VM_API int vm_broken_rotor_routh(const vm_broken_rotor *rotor, vm_real Omega, vm_real *column)
{
    vmi_broken_rotor_steady a;
    vm_real p[6];
    int status = column ? vmi_broken_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = a.G;
    p[3] = a.k * a.D;
    p[4] = 4 * a.G * a.O2;
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(6, p, column);
}

/* 1 where the steady motion is asymptotically stable, exactly Omega^2 < omega^2 (82) with k* > 0, s != 0, Omega != 0;
   else 0 (for k*, s or Omega = 0 some motions neither grow nor fade) */
VM_API int vm_broken_rotor_is_stable(const vm_broken_rotor *rotor, vm_real Omega)
{
    if (!rotor || vmi_check_rotor(rotor) || !VM_IS_FINITE(Omega)) return 0;
    return rotor->damping > 0 && rotor->s != 0 && Omega != 0 && vmi_broken_rotor_detuning(rotor, Omega) > 0;
}

/* Its five roots, by rising |imaginary part|, pairs as (+, -): each within twice what an eps of every coefficient
   would do, the smallest too, which near resonance is many orders below the largest. VM_DOMAIN at resonance. */
/* lambda is measured in size = |Omega| + omega + k* + sqrt|G|, so that no coefficient is above 10. */
VM_API int vm_broken_rotor_eigenvalues(const vm_broken_rotor *rotor, vm_real Omega, vm_real *re, vm_real *im)
{
    vmi_broken_rotor_steady a;
    vm_real c[6], x[5], y[5], size, power;
    int i, status = re && im ? vmi_broken_rotor_about_steady(rotor, Omega, &a) : VM_BAD_ARGUMENT;
    if (!status) status = vm_broken_rotor_characteristic(rotor, Omega, c);
    if (status) return status;
    size = VM_FABS(Omega) + VM_SQRT(a.w2) + VM_FABS(a.k) + VM_SQRT(VM_FABS(a.G));
    for (i = 1, power = 1 / size; i < 6; i++, power /= size) c[i] *= power;
    if (!vmi_all_finite(6, c)) return VM_NOT_FINITE;
    vmi_poly_roots(5, c, x, y);
    for (i = 0; i < 5; i++) {
        x[i] *= size;
        y[i] *= size;
    }
    if (!vmi_all_finite(5, x)) return VM_NOT_FINITE;
    status = vmi_copy_if_finite(5, y, im);
    if (!status) memcpy(re, x, sizeof x);
    return status;
}

/* ln(1 + x) - x + x^2/2, x >= 0, to a few eps: x^3/3 - x^4/4 ..., by powers of w = x/(2 + x), all terms positive */
VM_API vm_real vmi_broken_rotor_growth_time(vm_real x)
{
    const int terms = VM_MANT_DIG > 24 ? 45 : 21; /* w <= 1/3 */
    const vm_real w = x / (2 + x);
    vm_real sum = 0;
    vm_two l;
    int n;
    if (x > 1) {
        l = vmi_log(1 + x);
        return (l.hi - x) + x * x / 2;
    }
    for (n = terms; n >= 3; n--) sum = w * sum + ((vm_real)(n - 2) + (n & 1 ? 1 / (vm_real)n : 0));
    return 2 * w * w * w * sum;
}

/* r r' = A + B/r gives tau = t A^3/B^2 = ln(1 + x) - x + x^2/2 with x = A r/B: convex, so that Newton's method
   falls to the root from (3 tau)^(1/3) + (2 tau)^(1/2), which is above it. */
VM_API vm_real vmi_broken_rotor_growth_root(vm_real tau)
{
    const int most_steps = 60;
    vm_real x = vmi_pow_checked(3 * tau, VM_C(1.) / 3) + VM_SQRT(2 * tau), fall;
    int i;
    for (i = 0; i < most_steps; i++) {
        fall = (vmi_broken_rotor_growth_time(x) - tau) * (1 + x) / (x * x);
        if (!(fall > 0)) break;
        x -= fall;
    }
    return x;
}

/* r(t) after a start from rest where Omega = torque/damping is not below omega: psi' is caught at omega, and what the
   torque has left goes into the orbit. r = |s|/4 + R with R R' = k* (Omega - omega)/(2 p^2 omega) + k* |s|/(4 p^2 R),
   R(0) = 0, which changes over from one law to the other,
     R = (3 k* |s| t/(4 p^2))^(1/3) at resonance,  R -> (k* (Omega - omega) t/(p^2 omega))^(1/2) above it.
   s/4 is the next order. Not in it: terms of s^2/r and the time of the capture (Fig. 18 at t = 400: 0.001 of 3.473
   and 0.093 of 12.437 too little and too much). NaN below resonance, for t < 0, k* < 0 and omega = 0. */
VM_API vm_real vm_broken_rotor_resonance_radius(vm_real t, const vm_broken_rotor *rotor, vm_real Omega)
{
    vm_real over, w, A, B, R, z;
    if (!rotor || vmi_check_rotor(rotor) || !(t >= 0) || !VM_IS_FINITE(t) || !VM_IS_FINITE(Omega)) return VM_NAN;
    over = -vmi_broken_rotor_detuning(rotor, Omega);
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    if (!(over >= 0) || !(w > 0) || !(rotor->damping >= 0)) return VM_NAN;
    A = rotor->damping * (over / rotor->mass / (VM_FABS(Omega) + w)) / (2 * rotor->mass * w);
    B = rotor->damping * VM_FABS(rotor->s) / (4 * rotor->mass);
    R = vmi_pow_checked(3 * B * t, VM_C(1.) / 3);
    if (A == 0 || t == 0) return VM_FABS(rotor->s) / 4 + R;
    z = A * R / B;
    if (!(z < 1 / VM_EPSILON)) R = VM_SQRT(2 * A * t); /* B = 0 among it */
    else if (z > VM_EPSILON) R = vmi_broken_rotor_growth_root(z * z * z / 3) * B / A;
    return VM_FABS(rotor->s) / 4 + R;
}

#endif
