/* mechanics/torque_free.h - exact rotation of a body without torque */
#ifndef VARMASS_MECHANICS_TORQUE_FREE_H
#define VARMASS_MECHANICS_TORQUE_FREE_H

#include <string.h>

#include "../base/bits.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "../jacobi/integrals.h"
#include "../jacobi/theta.h"
#include "../jacobi/third_kind.h"
#include "bodies.h"
#include "inertia.h"
#include "vectors.h"

/* A body on which no force acts, as after a jump: omega is made of sn, cn, dn of the time, the attitude of one
   theta function and a steady turn (Jacobi 1850), so that any time costs the same and errors do not grow with it.
   Nothing is integrated; the mass centre moves on a straight line. Triaxial, symmetric, spherical bodies, rods and
   points (spin about a null axis stays what it is), any axis, the middle one and the separatrix included, without
   a threshold to choose.

   Accuracy, measured, inputs taken as exact, to 1e6 turns: attitude within 8 eps (rad), omega within 5 eps
   |omega|, next to the separatrix (1 - m from 1e-2 to 1e-27) and for nearly equal moments too. An error of eps in
   an input means one of eps times the angle turned; next to the separatrix more, since every turn-over moves.
   Where products of inertia make the principal moments known to two words only, 5e-12 rad after 1e6 turns at 1 - m
   = 1e-16 (float: 4e-4 rad for needles, 8e-3 at 1e-6). Angular momentum stays within 10 eps tr(I) |omega|.
   Components of omega below 2^-505 (float 2^-57) of the largest count as 0.
   Cost: a time 17 to 19 times the C library's sin, preparing a motion 10 to 20 times that, 40 with products of
   inertia. */
typedef struct VM_TAG(vm_torque_free) {
    vm_body body; /* at t0 */
    vm_real t0;
    vmi_mat3 axes;               /* 1, 2, 3: principal, right-handed; in body axes */
    vm_quat start;               /* turns the axes in which angular momentum is along 3, or -3, into inertial ones */
    vm_real spin[3];             /* omega = spin[0] cn, spin[1] sn, spin[2] dn along 1, 2, 3, rad/s */
    vm_real lean[3];             /* the same of angular momentum over its size, as parts of a quaternion */
    vm_two phase, phase_rate, K; /* of u/(4K), K the quarter period; on the separatrix K is 0, and they are of u */
    vm_two turn_rate;            /* mean rate of half the angle about the angular momentum, turns/s */
    vm_real m1;                  /* 1 - m of sn, cn, dn */
    vmi_theta_form far_form;     /* of theirs far from 0 */
    vmi_doubled_theta theta;     /* what half that angle is beyond its mean */
} vm_torque_free;                /* plain data: it may be copied */

/* Along principal axes 1, 2, 3, where 2 has the middle moment and omega circles 3, with u of the constant rate wp,
     w1 = a1 cn u,  w2 = -sigma s a2 sn u,  w3 = s a3 dn u,  s = sign(w3), sigma = sign(I1 - I3);
   with M the shortest rotation that takes l = J omega/L to s e3 and L = |J omega|, the attitude is
     q(t) = start R(t),  R = (cos h + s e3 sin h) M,  h = kappa t + sigma arg theta(u)
   (Jacobi 1850; van Zon and Schofield, J. Comput. Phys. 225 (2007), have a theta series for 2h). The set-up is in
   two words, since the rates wp/(4K) and kappa are multiplied by long times; then all but their products is in
   one. */
/* A power of two within a factor of 2 of x > 0 */
VM_API vm_real vmi_torque_free_power(vm_real x)
{
    return x < VM_MIN ? VM_MIN : vmi_from_bits(vmi_to_bits(x) & ~(((vmi_bits)1 << VMI_STORED_DIG) - 1));
}

typedef struct VM_TAG(vmi_vec3_two) {
    vm_two x[3];
} vmi_vec3_two;

VM_API vmi_vec3_two vmi_torque_free_cross(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    vmi_vec3_two c;
    int k;
    for (k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.x[k] = vmi_two_minus(vmi_two_times(a->x[i], b->x[j]), vmi_two_times(a->x[j], b->x[i]));
    }
    return c;
}

VM_API vm_vec3 vmi_torque_free_high_words(const vmi_vec3_two *a) { return vmi_vec3(a->x[0].hi, a->x[1].hi, a->x[2].hi); }

VM_API vm_two vmi_torque_free_two_pi(void)
{
    const vmi_three half_pi = vmi_half_pi();
    return vmi_two(4 * half_pi.hi, 4 * half_pi.mid);
}

VM_API vm_two vmi_torque_free_dot(const vmi_vec3_two *a, const vmi_vec3_two *b)
{
    return vmi_two_plus(vmi_two_times(a->x[0], b->x[0]),
                        vmi_two_plus(vmi_two_times(a->x[1], b->x[1]), vmi_two_times(a->x[2], b->x[2])));
}

VM_API vmi_vec3_two vmi_torque_free_vector(vm_vec3 a, vm_real power) /* a/power */
{
    vmi_vec3_two v;
    v.x[0] = vmi_two(a.x / power, 0);
    v.x[1] = vmi_two(a.y / power, 0);
    v.x[2] = vmi_two(a.z / power, 0);
    return v;
}

/* x, or 0 where its square would be lost by underflow: for 2^-505 (float 2^-57) of the largest and less */
VM_API vm_two vmi_torque_free_squarable(vm_two x) { return VM_FABS(x.hi) < 64 * VM_SQRT(VM_MIN) ? vmi_two(0, 0) : x; }

/* What the rotation of q turns into a: a + 2 (v x (v x a) - w v x a)/|q|^2, for q = (w, v) of any length but 0 */
VM_API vmi_vec3_two vmi_torque_free_back(vm_quat q, const vmi_vec3_two *a)
{
    const vm_vec3 part = vmi_vec3(q.x, q.y, q.z);
    const vm_real longest = vmi_norm_max(part), w = VM_FABS(q.w);
    const vm_real power = vmi_torque_free_power(longest > w ? longest : w);
    const vmi_vec3_two v = vmi_torque_free_vector(part, power), b = vmi_torque_free_cross(&v, a), c = vmi_torque_free_cross(&v, &b);
    const vm_two real = vmi_two(q.w / power, 0);
    const vm_two size = vmi_two_plus(vmi_two_times(real, real), vmi_torque_free_dot(&v, &v));
    const vm_two factor = vmi_two_over(vmi_two(2, 0), size);
    vmi_vec3_two result;
    int k;
    for (k = 0; k < 3; k++)
        result.x[k] = vmi_two_plus(a->x[k],
                                   vmi_two_times(factor, vmi_two_minus(c.x[k], vmi_two_times(real, b.x[k]))));
    return result;
}

/* Moments, axes (columns in body axes) and omega along them */
typedef struct VM_TAG(vmi_torque_free_body) {
    vm_two moment[3];
    vmi_vec3_two axis[3], omega;
} vmi_torque_free_body;

/* vmi_jacobi_rotation in two words; a is scaled to 1, and what is below eps^3 is nothing */
VM_API void vmi_torque_free_annihilate(vm_two a[3][3], vmi_vec3_two *axis, int p, int q)
{
    const vm_two one = vmi_two(1, 0);
    vm_two theta, t, c, s, x, y;
    int k = 3 - p - q;
    if (VM_FABS(a[p][q].hi) < VM_EPSILON * VM_EPSILON * VM_EPSILON) {
        a[p][q] = a[q][p] = vmi_two(0, 0);
        return;
    }
    theta = vmi_two_over(vmi_two_minus(a[q][q], a[p][p]), vmi_two_shifted(a[p][q], 2));
    t = vmi_two_root(vmi_two_plus(vmi_two_times(theta, theta), one));
    t = vmi_two_over(one, theta.hi < 0 ? vmi_two_minus(theta, t) : vmi_two_plus(theta, t));
    c = vmi_two_over(one, vmi_two_root(vmi_two_plus(vmi_two_times(t, t), one)));
    s = vmi_two_times(t, c);
    x = vmi_two_times(t, a[p][q]);
    a[p][p] = vmi_two_minus(a[p][p], x);
    a[q][q] = vmi_two_plus(a[q][q], x);
    a[p][q] = a[q][p] = vmi_two(0, 0);
    x = a[k][p];
    y = a[k][q];
    a[k][p] = a[p][k] = vmi_two_minus(vmi_two_times(c, x), vmi_two_times(s, y));
    a[k][q] = a[q][k] = vmi_two_plus(vmi_two_times(s, x), vmi_two_times(c, y));
    for (k = 0; k < 3; k++) {
        x = axis[p].x[k];
        y = axis[q].x[k];
        axis[p].x[k] = vmi_two_minus(vmi_two_times(c, x), vmi_two_times(s, y));
        axis[q].x[k] = vmi_two_plus(vmi_two_times(s, x), vmi_two_times(c, y));
    }
}

/* Principal moments over a power of two, and axes, in two words; of a rod or a point exactly */
VM_API void vmi_torque_free_principal(const vm_inertia *i, vmi_torque_free_body *b)
{
    const vm_real power = vmi_torque_free_power(vmi_trace(i));
    vm_two a[3][3];
    int sweep, p, q, k;
    memset(b, 0, sizeof *b);
    memset(a, 0, sizeof a);
    a[0][0].hi = i->xx / power;
    a[1][1].hi = i->yy / power;
    a[2][2].hi = i->zz / power;
    a[0][1].hi = a[1][0].hi = i->xy / power;
    a[0][2].hi = a[2][0].hi = i->xz / power;
    a[1][2].hi = a[2][1].hi = i->yz / power;
    for (k = 0; k < 3; k++) b->axis[k].x[k].hi = 1;
    for (sweep = 0; sweep < 12; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++)
                if (a[p][q].hi != 0) vmi_torque_free_annihilate(a, b->axis, p, q);
    for (k = 0; k < 3; k++) b->moment[k] = a[k][k];
}

/* A moment lost in the rounding errors of the tensor is that of a rod: 0, and the others are equal */
VM_API void vmi_torque_free_clamp_moments(const vm_inertia *i, vmi_torque_free_body *b)
{
    const vmi_mat3 same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const vm_inertia sizes = vmi_inertia_sizes(i, &same);
    const vm_real power = vmi_torque_free_power(vmi_trace(i));
    int k;
    for (k = 0; k < 3; k++) {
        const vm_vec3 size = vmi_abs(vmi_torque_free_high_words(&b->axis[k]));
        if (b->moment[k].hi * power > 8 * VM_EPSILON * vmi_dot(size, vmi_inertia_times(&sizes, size))) continue;
        b->moment[k] = vmi_two(0, 0);
        b->moment[(k + 1) % 3] = b->moment[(k + 2) % 3];
    }
}

/* All but equal: what two words cannot tell apart where they come from a tensor; stored moments differ by more */
VM_API int vmi_torque_free_equal(vm_two a, vm_two b)
{
    return VM_FABS(vmi_two_minus(a, b).hi) <= 64 * VM_EPSILON * VM_EPSILON * (a.hi + b.hi);
}

/* The body in axes 1, 2, 3 */
typedef struct VM_TAG(vmi_torque_free_axes) {
    vm_two I1, I2, I3, w1, w2, w3, d12, d23, d13;
    vm_two S; /* |2T I2 - L^2|, which is 0 on the separatrix */
    vm_real sigma, s;
    int symmetric; /* I1 = I2 */
    vmi_mat3 axes;
} vmi_torque_free_axes;

VM_API vmi_three vmi_torque_free_three(vm_two x) { return vmi_three_words(x.hi, x.lo, 0); }

/* J d w^2 in three words, in which stored numbers lose nothing that a difference could bring up */
VM_API vmi_three vmi_torque_free_excess(vm_two J, vm_two d, vm_two w)
{
    const vmi_three square = vmi_three_times(vmi_torque_free_three(w), vmi_torque_free_three(w));
    return vmi_three_times(vmi_three_times(vmi_torque_free_three(J), vmi_torque_free_three(d)), square);
}

/* J_c (J_b - J_c) w_c^2 - J_a (J_a - J_b) w_a^2 = 2T J_b - L^2 */
VM_API vmi_three vmi_torque_free_separation(const vm_two *J, const vm_two *w, int a, int b, int c)
{
    const vmi_three smallest = vmi_torque_free_excess(J[c], vmi_two_minus(J[b], J[c]), w[c]);
    return vmi_three_plus(smallest, vmi_torque_free_excess(J[a], vmi_two_minus(J[b], J[a]), w[a]));
}

/* order[] by falling moments; 1 where it is an even permutation */
VM_API int vmi_torque_free_sort(const vm_two *J, int *order)
{
    int k, even = 1;
    for (k = 0; k < 3; k++) order[k] = k;
    for (k = 0; k < 3; k++) { /* the first two, the last two, the first two */
        const int i = k == 1, first = order[i];
        if (!(vmi_two_minus(J[order[i + 1]], J[first]).hi > 0)) continue;
        order[i] = order[i + 1];
        order[i + 1] = first;
        even = !even;
    }
    return even;
}

/* omega circles the smallest moment where the separation is positive, else the largest; of two equal moments, the
   third */
VM_API vmi_torque_free_axes vmi_torque_free_order(const vmi_torque_free_body *b)
{
    const vm_two *J = b->moment, *w = b->omega.x;
    int order[3], even = vmi_torque_free_sort(J, order), falling;
    const int first = order[0], middle = order[1], last = order[2];
    const vmi_three S = vmi_torque_free_separation(J, w, first, middle, last);
    vmi_torque_free_axes t;
    falling = vmi_torque_free_equal(J[first], J[middle]) || (!vmi_torque_free_equal(J[middle], J[last]) && S.hi >= 0);
    if (!falling) {
        order[0] = last;
        order[2] = first;
        even = !even;
    }
    t.sigma = falling ? 1 : -1;
    t.S = vmi_two_shifted(vmi_two(S.hi, S.mid), S.hi < 0 ? -1 : 1);
    t.I1 = J[order[0]];
    t.I2 = J[middle];
    t.I3 = J[order[2]];
    t.symmetric = vmi_torque_free_equal(t.I1, t.I2);
    if (t.symmetric) t.I2 = t.I1;
    t.w1 = w[order[0]];
    t.w2 = w[middle];
    t.w3 = vmi_two_shifted(w[order[2]], even ? 1 : -1);
    t.s = t.w3.hi < 0 ? -1 : 1;
    t.d12 = vmi_two_shifted(vmi_two_minus(t.I1, t.I2), t.sigma);
    t.d23 = vmi_two_shifted(vmi_two_minus(t.I2, t.I3), t.sigma);
    t.d13 = vmi_two_shifted(vmi_two_minus(t.I1, t.I3), t.sigma);
    t.axes.x = vmi_torque_free_high_words(&b->axis[order[0]]);
    t.axes.y = vmi_torque_free_high_words(&b->axis[middle]);
    t.axes.z = vmi_scale(even ? 1 : -1, vmi_torque_free_high_words(&b->axis[order[2]]));
    return t;
}

/* A sphere or a point, a principal axis, an equator: omega stays */
VM_API int vmi_torque_free_is_constant(const vmi_torque_free_axes *t)
{
    const int no1 = t->w1.hi == 0, no2 = t->w2.hi == 0, no3 = t->w3.hi == 0;
    return vmi_torque_free_equal(t->I1, t->I3) || (no1 && no2) || (no1 && no3) || (no3 && (no2 || t->symmetric));
}

/* Then axis 3 is that of omega, and sn = 0 */
VM_API void vmi_torque_free_constant(vm_torque_free *m, const vmi_torque_free_body *b)
{
    const vm_two size = vmi_two_root(vmi_torque_free_dot(&b->omega, &b->omega));
    int k;
    if (size.hi == 0) return;
    for (k = 0; k < 3; k++)
        m->axes.z = vmi_add(m->axes.z,
                            vmi_scale(vmi_two_over(b->omega.x[k], size).hi, vmi_torque_free_high_words(&b->axis[k])));
    m->spin[2] = size.hi;
    m->turn_rate = vmi_two_over(vmi_two_shifted(size, VM_C(0.5)), vmi_torque_free_two_pi());
}

/* The squares of a1, a2, a3, h1 = I1 a1, h3 = I3 a3 and L, and the parameters; no difference but S in them */
typedef struct VM_TAG(vmi_torque_free_squares) {
    vm_two a1, a2, a3, h1, h3, L, m1, m;
} vmi_torque_free_squares;

VM_API vmi_torque_free_squares vmi_torque_free_amplitudes(const vmi_torque_free_axes *t)
{
    const vm_two ratio = vmi_two_over(vmi_two_times(t->I2, t->d23), vmi_two_times(t->I1, t->d13));
    const vm_two ww2 = vmi_two_times(t->w2, t->w2);
    vmi_torque_free_squares q;
    vm_two x;
    q.a1 = vmi_two_plus(vmi_two_times(t->w1, t->w1), vmi_two_times(ratio, ww2));
    q.a2 = vmi_two_over(q.a1, ratio);
    q.a3 = vmi_two_times(t->w3, t->w3);
    q.m1 = vmi_two(1, 0);
    q.m = vmi_two(0, 0);
    if (!t->symmetric) {
        x = vmi_two_over(vmi_two_times(t->I2, t->d12), vmi_two_times(t->I3, t->d13));
        q.a3 = vmi_two_plus(q.a3, vmi_two_times(x, ww2));
        x = vmi_two_times(vmi_two_times(t->I3, t->d23), q.a3);
        q.m1 = vmi_two_over(t->S, x);
        q.m = vmi_two_over(vmi_two_times(vmi_two_times(t->I1, t->d12), q.a1), x);
    }
    q.h1 = vmi_two_times(vmi_two_times(t->I1, t->I1), q.a1);
    q.h3 = vmi_two_times(vmi_two_times(t->I3, t->I3), q.a3);
    q.L = vmi_two_plus(q.h1, q.h3);
    return q;
}

/* kappa, the mean rate of h, and agm(1, k') (0 on the separatrix), by Pi(-N | m) with N = I3 d12/(I1 d23):
     2 kappa = L/I1 + L d13/(I1 I3) (1 - Pi/K + c mean/sqrt(1 + N))   if I1 > I3,
     2 kappa = L/I3 + L d13/(I1 I3) (    Pi/K - c mean/sqrt(1 + N))   if not;  c = I3 a3/L */
VM_API vm_two vmi_torque_free_rate(const vmi_torque_free_axes *t, const vmi_torque_free_squares *q, vm_two *mean)
{
    const vm_two L = vmi_two_root(q->L), outer = vmi_two_times(t->I2, t->d13);
    const vm_two share = vmi_two_over(vmi_two_times(t->I3, t->d12), outer);
    const vm_two below = vmi_two_over(vmi_two_times(t->I1, t->d23), outer);
    vm_two rest, kappa;
    vmi_third_kind third;
    *mean = vmi_two(t->symmetric ? 1 : 0, 0);
    if (t->symmetric) {
        rest = vmi_two_times(vmi_two_root(q->a3), vmi_two_minus(t->I1, t->I3));
        kappa = vmi_two_over(vmi_two_plus(L, rest), t->I1);
    } else if (q->m1.hi == 0) kappa = vmi_two_over(L, t->I2);
    else {
        third = vmi_third_kind_ladder(q->m1, share, below);
        *mean = third.mean;
        rest = vmi_two_times(vmi_two_root(vmi_two_times(vmi_two_over(q->h3, q->L), below)), third.mean);
        rest = t->sigma > 0 ? vmi_two_plus(third.rest, rest) : vmi_two_minus(third.ratio, rest);
        rest = vmi_two_times(vmi_two_over(t->d13, vmi_two_times(t->I1, t->I3)), rest);
        rest = vmi_two_plus(rest, vmi_two_over(vmi_two(1, 0), t->sigma > 0 ? t->I1 : t->I3));
        kappa = vmi_two_times(L, rest);
    }
    return vmi_two_shifted(kappa, VM_C(0.5));
}

/* y of the theta function, cd(y | m1) = I3 a3/L */
VM_API vm_real vmi_torque_free_imaginary(const vmi_torque_free_axes *t, const vmi_torque_free_squares *q)
{
    const vm_two N = vmi_two_over(vmi_two_times(t->I3, t->d12), vmi_two_times(t->I1, t->d23));
    const vm_two cc = vmi_two_over(q->h3, q->L);
    return vmi_carlson_rf(N, vmi_two_over(N, cc), vmi_two_plus(N, vmi_two(1, 0))).hi;
}

/* u at t0, in turns where mean > 0; *sign is that of cn on the separatrix, else 1 */
VM_API vm_two vmi_torque_free_phase(const vmi_torque_free_axes *t, const vmi_torque_free_squares *q, vm_two mean, vm_real *sign)
{
    const vm_two ss = vmi_two_over(vmi_two_times(t->w2, t->w2), q->a2);
    const vm_two cc = vmi_two_over(vmi_two_times(t->w1, t->w1), q->a1);
    const vm_two middle = vmi_two_plus(cc, vmi_two_times(q->m1, ss));
    const vm_real forward = -t->sigma * t->s * t->w2.hi < 0 ? -1 : 1;
    vm_two F = vmi_two_times(vmi_two_root(ss), vmi_carlson_rf(cc, middle, vmi_two(1, 0)));
    *sign = 1;
    if (mean.hi > 0) {
        F = vmi_two_over(vmi_two_times(F, mean), vmi_torque_free_two_pi());
        if (t->w1.hi < 0) F = vmi_two_minus(vmi_two(VM_C(0.5), 0), F);
    } else if (t->w1.hi < 0) *sign = -1;
    return vmi_two_shifted(F, forward * *sign);
}

/* Rates and phase, per second of the scaled omega; returns the sign of cn on the separatrix */
VM_API vm_real vmi_torque_free_rates(vm_torque_free *m, const vmi_torque_free_axes *t, const vmi_torque_free_squares *q)
{
    const vm_two two_pi = vmi_torque_free_two_pi();
    vm_two mean, kappa = vmi_torque_free_rate(t, q, &mean), wp;
    vm_real sign;
    wp = vmi_two_over(vmi_two_times(q->a3, vmi_two_times(t->d13, t->d23)), vmi_two_times(t->I1, t->I2));
    wp = vmi_two_root(wp);
    m->turn_rate = vmi_two_over(vmi_two_shifted(kappa, t->s), two_pi);
    m->phase = vmi_torque_free_phase(t, q, mean, &sign);
    m->phase_rate = mean.hi > 0 ? vmi_two_over(vmi_two_times(wp, mean), two_pi) : wp;
    if (mean.hi > 0) m->K = vmi_two_over(vmi_two_shifted(two_pi, VM_C(0.25)), mean);
    return sign;
}

/* Parameter and y of the theta function; it stays 1 for m = 0 */
VM_API void vmi_torque_free_theta(vm_torque_free *m, const vmi_torque_free_axes *t, const vmi_torque_free_squares *q)
{
    const int periodic = m->K.hi > 0;
    vm_real K, Kc, y;
    int k;
    if (q->m.hi == 0) return;
    K = periodic ? m->K.hi : VM_INFINITY;
    Kc = periodic ? jacobi_K_m1(q->m.hi) : VM_PI / 2;
    y = vmi_torque_free_imaginary(t, q);
    m->theta = K > 2 * Kc ? vmi_doubled_dual(K, Kc, y) : vmi_doubled_direct(K, Kc, y);
    m->theta.shift *= t->sigma * t->s;
    for (k = 0; k < 4; k++) m->theta.im[k] *= t->sigma * t->s;
}

VM_API void vmi_torque_free_sizes(vm_torque_free *m, const vmi_torque_free_axes *t, const vmi_torque_free_squares *q, vm_real sign)
{
    const vm_real L = VM_SQRT(q->L.hi);
    m->axes = t->axes;
    m->spin[0] = sign * VM_SQRT(q->a1.hi);
    m->spin[1] = -t->sigma * t->s * sign * VM_SQRT(q->a2.hi);
    m->spin[2] = t->s * VM_SQRT(q->a3.hi);
    m->lean[0] = -t->s * t->I1.hi * m->spin[0] / L;
    m->lean[1] = t->s * t->I2.hi * m->spin[1] / L;
    m->lean[2] = t->s * t->I3.hi * m->spin[2] / L;
}

VM_API void vmi_torque_free_parameter(vm_torque_free *m, vm_two m1)
{
    m->m1 = m1.hi;
    vmi_far_prepare(&m->far_form, m1.hi, m1.lo);
}

/* All but the unit of time and the start */
VM_API void vmi_torque_free_prepare(vm_torque_free *m, const vmi_torque_free_body *b)
{
    const vmi_torque_free_axes t = vmi_torque_free_order(b);
    vmi_torque_free_squares q;
    int constant = vmi_torque_free_is_constant(&t);
    if (!constant) {
        q = vmi_torque_free_amplitudes(&t);
        constant = q.h1.hi <= vmi_fourth_power(VM_EPSILON) * q.h3.hi; /* nutation below eps^2 about a stable axis */
    }
    if (constant) {
        vmi_torque_free_constant(m, b);
        return;
    }
    vmi_torque_free_sizes(m, &t, &q, vmi_torque_free_rates(m, &t, &q));
    vmi_torque_free_theta(m, &t, &q);
    vmi_torque_free_parameter(m, q.m1);
}

/* rate t without whole turns, |..| <= 1; meaningless beyond 2^(2p - 4) turns */
VM_API vm_two vmi_torque_free_fraction(vm_two rate, vm_two t)
{
    const vm_two p = vmi_two_product(rate.hi, t.hi);
    vm_real low = p.lo + (rate.lo * t.hi + rate.hi * t.lo);
    if (VM_FABS(low) > VM_C(0.5)) low -= VM_FLOOR(low + VM_C(0.5));
    return vmi_two_sum(p.hi - VM_FLOOR(p.hi + VM_C(0.5)), low);
}

/* sn, cn, dn at t after t0, and u/(4K) without half turns (u on the separatrix) */
VM_API vm_real vmi_torque_free_functions(const vm_torque_free *m, vm_two t, vm_real *sn, vm_real *cn, vm_real *dn)
{
    const vm_real longest = VM_MANT_DIG > 24 ? 700 : 80; /* where sech is next to the smallest number */
    vmi_thetas theta;
    vm_real x;
    int half = 0, j = 0;
    vm_two v;
    if (m->K.hi > 0) {
        v = vmi_two_plus(vmi_torque_free_fraction(m->phase_rate, t), m->phase);
        half = vmi_nearest(2 * v.hi);
        v = vmi_two_sum(v.hi - (vm_real)half / 2, v.lo);
        x = v.hi;
        j = vmi_nearest(4 * x);
        v = vmi_two_times(vmi_two_sum(4 * x - (vm_real)j, 4 * v.lo), m->K);
    } else {
        v = vmi_two_plus(vmi_two_times(m->phase_rate, t), m->phase);
        if (VM_FABS(v.hi) > longest) v = vmi_two(VM_COPYSIGN(longest, v.hi), 0);
        x = v.hi;
    }
    theta = v.hi * v.hi > VMI_NEAR ? vmi_theta_far(&m->far_form, 0, v) : vmi_theta_near(v.hi, m->m1); /* NaN: near */
    theta = vmi_theta_shift(theta, m->far_form.kp, (vmi_bits)((j + 2 * half) & 3));
    vmi_theta_ratios(theta, m->far_form.kp, sn, cn, dn);
    return x;
}

/* omega in body axes, and the rotation R */
VM_API void vmi_torque_free_at(const vm_torque_free *m, vm_two t, vm_vec3 *omega, vm_quat *turn)
{
    vm_real sn, cn, dn, re, im, sine, cosine, x, y, w, norm, c, s;
    const vm_real u = vmi_torque_free_functions(m, t, &sn, &cn, &dn);
    vm_vec3 part;
    vmi_doubled_at(&m->theta, u, &re, &im);
    vmi_sincos_turns(vmi_torque_free_fraction(m->turn_rate, t).hi + m->theta.shift * u, &sine, &cosine);
    w = 1 + m->lean[2] * dn;
    x = m->lean[1] * sn;
    y = m->lean[0] * cn;
    norm = 1 / VM_SQRT(2 * w * (re * re + im * im));
    c = norm * (cosine * re - sine * im);
    s = norm * (sine * re + cosine * im);
    part = vmi_times(&m->axes, vmi_vec3(c * x - s * y, c * y + s * x, s * w));
    turn->w = c * w;
    turn->x = part.x;
    turn->y = part.y;
    turn->z = part.z;
    *omega = vmi_times(&m->axes, vmi_vec3(m->spin[0] * cn, m->spin[1] * sn, m->spin[2] * dn));
}

/* From moments, axes, and omega over a power of two */
VM_API void vmi_torque_free_init(vm_torque_free *m, const vmi_torque_free_body *b, vm_real power)
{
    vm_quat q = m->body.q, turn;
    vm_vec3 omega;
    int k;
    vmi_torque_free_parameter(m, vmi_two(1, 0)); /* m = 0: sn = 0, cn = dn = 1 */
    m->theta.re[0] = 1;
    m->lean[2] = 1;
    vmi_torque_free_prepare(m, b);
    if (vmi_quat_is_none(q)) q.w = 1;
    vmi_torque_free_at(m, vmi_two(0, 0), &omega, &turn);
    turn.x = -turn.x;
    turn.y = -turn.y;
    turn.z = -turn.z;
    m->start = vmi_quat_times(q, turn);
    for (k = 0; k < 3; k++) m->spin[k] *= power;
    m->phase_rate = vmi_two_shifted(m->phase_rate, power);
    m->turn_rate = vmi_two_shifted(m->turn_rate, power);
}

/* omega along the inertial axes, or along the body's */
VM_API int vmi_torque_free_start(vm_torque_free *motion, const vm_body *body, int along_body, vm_real t0)
{
    vm_torque_free m;
    vmi_torque_free_body b;
    vmi_vec3_two omega;
    vm_real power;
    int status = vmi_check_body(body), k;
    if (!status && !VM_IS_FINITE(t0)) status = VM_NOT_FINITE;
    if (status) return status;
    memset(&m, 0, sizeof m);
    m.body = *body;
    m.t0 = t0;
    power = vmi_torque_free_power(vmi_norm_max(body->omega));
    omega = vmi_torque_free_vector(body->omega, power);
    if (!along_body && vmi_norm_max(vmi_vec3(body->q.x, body->q.y, body->q.z)) > 0)
        omega = vmi_torque_free_back(body->q, &omega);
    vmi_torque_free_principal(&body->inertia, &b);
    vmi_torque_free_clamp_moments(&body->inertia, &b);
    for (k = 0; k < 3; k++) b.omega.x[k] = vmi_torque_free_squarable(vmi_torque_free_dot(&b.axis[k], &omega));
    vmi_torque_free_init(&m, &b, power);
    *motion = m;
    return VM_OK;
}

/* Prepares the motion of a body that is as given at t0. VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS,
   VM_BAD_INERTIA: the motion stays as it was. */
VM_API int vm_torque_free_init(vm_torque_free *motion, const vm_body *body, vm_real t0)
{
    return motion && body ? vmi_torque_free_start(motion, body, 0, t0) : VM_BAD_ARGUMENT;
}

/* The same from principal moments (kg m^2), the body's axes being the principal ones, and omega (rad/s) along
   them; the body has mass 1 and rests at the origin. */
VM_API int vm_torque_free_init_principal(vm_torque_free *motion, vm_vec3 moments, vm_quat q, vm_vec3 omega, vm_real t0)
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

/* Attitude and omega alone, the latter along body axes. */
VM_API int vm_torque_free_attitude(const vm_torque_free *motion, vm_real t, vm_quat *q, vm_vec3 *omega)
{
    vm_two elapsed;
    vm_real reach;
    vm_vec3 w;
    vm_quat turn;
    if (!motion || !q || !omega) return VM_BAD_ARGUMENT;
    elapsed = vmi_two_sum(t, -motion->t0);
    reach = VM_FABS(motion->phase_rate.hi) + VM_FABS(motion->turn_rate.hi);
    if (!((1 + reach) * (1 + VM_FABS(elapsed.hi)) < VM_MAX / VM_SPLIT))
        return VM_NOT_FINITE; /* products are split */
    vmi_torque_free_at(motion, elapsed, &w, &turn);
    turn = vmi_quat_times(motion->start, turn);
    if (!vmi_vec3_finite(w) || !VM_IS_FINITE(turn.w) || !vmi_vec3_finite(vmi_vec3(turn.x, turn.y, turn.z)))
        return VM_NOT_FINITE;
    *q = turn;
    *omega = w;
    return VM_OK;
}

/* The body at time t (s), later than t0 or earlier. q is continuous and keeps the length that it had (1, if all
   zero). VM_NOT_FINITE: t is not, or what comes out is not, or t or the turns are beyond 1e290 (float 1e30); the
   body stays as it was. Beyond 1/eps^2 turns the result is finite and has the right momentum, nothing more. */
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
    b.r = vmi_add(b.r, vmi_scale(t - motion->t0, b.v));
    if (!vmi_body_finite(&b)) return VM_NOT_FINITE;
    *body = b;
    return VM_OK;
}

/* The body a time t (s) later, in one call. */
VM_API int vm_torque_free_rotation(const vm_body *body, vm_real t, vm_body *later)
{
    vm_torque_free motion;
    int status = vm_torque_free_init(&motion, body, 0);
    return status ? status : vm_torque_free_at(&motion, t, later);
}

#endif
