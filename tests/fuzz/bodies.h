/* bodies.h - bodies, impulses and attitudes out of bytes, for the targets of varmass.h */
#ifndef FUZZ_BODIES_H
#define FUZZ_BODIES_H
#include "fuzz.h"

static vm_vec3 draw_vector(double size)
{
    vm_vec3 a;
    a.x = draw_in(-size, size);
    a.y = draw_in(-size, size);
    a.z = draw_in(-size, size);
    if (draw_byte() % 32 == 0) a.x = draw_any();
    if (draw_byte() % 8 == 0) a.x = a.y = a.z = 0;
    return a;
}

static int finite3(vm_vec3 a) { return is_finite(a.x) && is_finite(a.y) && is_finite(a.z); }
static double size3(vm_vec3 a)
{
    return sqrt((double)a.x * (double)a.x + (double)a.y * (double)a.y + (double)a.z * (double)a.z);
}
static int is_nan3(vm_vec3 a) { return is_nan(a.x) && is_nan(a.y) && is_nan(a.z); }
static int within3(vm_vec3 a, vm_vec3 b, double tolerance)
{
    return within(a.x, b.x, tolerance) && within(a.y, b.y, tolerance) && within(a.z, b.z, tolerance);
}

static vm_quat draw_attitude(void)
{
    vm_quat q;
    q.w = draw_in(-1, 1);
    q.x = draw_in(-1, 1);
    q.y = draw_in(-1, 1);
    q.z = draw_in(-1, 1);
    if (draw_byte() % 8 == 0) q.w = q.x = q.y = q.z = 0;
    return q;
}

static double norm4(vm_quat q)
{
    return sqrt((double)q.w * (double)q.w + (double)q.x * (double)q.x + (double)q.y * (double)q.y +
                (double)q.z * (double)q.z);
}

/* Principal moments that a body of this mass and size can have, rods, plates and points among them; products of
   inertia by a turn about an axis. */
static vm_inertia draw_inertia(vm_real mass, double size)
{
    const double x = (double)draw_in(0, size), y = (double)draw_in(0, size), z = (double)draw_in(0, size);
    const int thin = draw_below(8), turned = draw_below(3);
    const double a = thin & 1 ? 0 : x * x, b = thin & 2 ? 0 : y * y, c = thin & 4 ? 0 : z * z, m = (double)mass;
    const double angle = (double)draw_in(-3, 3), k = cos(angle), s = sin(angle);
    vm_inertia i;
    memset(&i, 0, sizeof i);
    i.xx = R(m * (b + c));
    i.yy = R(m * (c + a));
    i.zz = R(m * (a + b));
    if (turned == 1) { /* about z */
        const double p = m * (b + c), q = m * (c + a);
        i.xx = R(k * k * p + s * s * q);
        i.yy = R(s * s * p + k * k * q);
        i.xy = R(k * s * (p - q));
    }
    return i;
}

static vm_body draw_body(double size)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = MOSTLY(draw_log(1e-2, 1e2));
    b.inertia = draw_inertia(is_finite(b.mass) ? b.mass : 1, size);
    if (draw_byte() % 32 == 0) b.inertia.xx = draw_any();
    b.q = draw_attitude();
    b.r = draw_vector(3);
    b.v = draw_vector(5);
    b.omega = draw_vector(4);
    return b;
}

static vm_body2 draw_body2(double size)
{
    vm_body2 b;
    b.mass = MOSTLY(draw_log(1e-2, 1e2));
    b.inertia = (is_finite(b.mass) ? b.mass : 1) * draw_in(0, size);
    b.inertia *= draw_in(0, size);
    b.x = draw_in(-3, 3);
    b.y = draw_in(-3, 3);
    b.angle = draw_in(-4, 4);
    b.vx = MOSTLY(draw_in(-5, 5));
    b.vy = draw_in(-5, 5);
    b.omega = MOSTLY(draw_in(-4, 4));
    return b;
}

static vm_impulse draw_impulse(void)
{
    vm_impulse j;
    j.linear = draw_vector(3);
    j.couple = draw_vector(3);
    j.at = draw_vector(3);
    return j;
}

static vm_impulse2 draw_impulse2(void)
{
    vm_impulse2 j;
    j.jx = draw_in(-3, 3);
    j.jy = draw_in(-3, 3);
    j.couple = MOSTLY(draw_in(-3, 3));
    j.x = draw_in(-3, 3);
    j.y = draw_in(-3, 3);
    return j;
}

/* No number so large that a square of what is made of it overflows: the bounds of accuracy are for these */
static int tame(vm_real x) { return VM_FABS(x) <= R(1e6) && (x == 0 || VM_FABS(x) > R(1e-8)); }
static int tame3(vm_vec3 a) { return tame(a.x) && tame(a.y) && tame(a.z); }
static int tame_body(const vm_body *b)
{
    return tame(b->mass) && tame3(b->r) && tame3(b->v) && tame3(b->omega) && tame(b->inertia.xx) &&
           tame(b->inertia.yy) && tame(b->inertia.zz);
}

/* Inertias in double, by nothing of the headers: xx, yy, zz, xy, xz, yz of a point's */
static void add_point_inertia(double *sum, double mass, double x, double y, double z)
{
    sum[0] += mass * (y * y + z * z);
    sum[1] += mass * (z * z + x * x);
    sum[2] += mass * (x * x + y * y);
    sum[3] -= mass * x * y;
    sum[4] -= mass * x * z;
    sum[5] -= mass * y * z;
}

static void add_inertia(double *sum, double factor, const vm_inertia *i)
{
    sum[0] += factor * (double)i->xx;
    sum[1] += factor * (double)i->yy;
    sum[2] += factor * (double)i->zz;
    sum[3] += factor * (double)i->xy;
    sum[4] += factor * (double)i->xz;
    sum[5] += factor * (double)i->yz;
}

static double trace_of(const vm_inertia *i) { return (double)i->xx + (double)i->yy + (double)i->zz; }

/* q v q* for |q| = 1, of which all zero is the identity */
static void turn3(vm_quat q, const double *v, double *turned)
{
    const double n = norm4(q);
    const double f = n > 0 ? 1 / n : 0, w = n > 0 ? (double)q.w * f : 1, x = (double)q.x * f, y = (double)q.y * f,
                 z = (double)q.z * f;
    const double a = y * v[2] - z * v[1], b = z * v[0] - x * v[2], c = x * v[1] - y * v[0];
    turned[0] = v[0] + 2 * (w * a + y * c - z * b);
    turned[1] = v[1] + 2 * (w * b + z * a - x * c);
    turned[2] = v[2] + 2 * (w * c + x * b - y * a);
}

/* Add a body's inertia about a point, in inertial axes, sign times. Returns the size of its rounding errors: the trace,
   m d^2, and m d |r|, which an eps of r moves. */
static double add_body_inertia(double *sum, double sign, const vm_body *b, vm_vec3 about)
{
    const vm_vec3 d = vm_sub(b->r, about);
    double own[6] = {0, 0, 0, 0, 0, 0}, axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, m[3][3];
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2}; /* of xx, yy, zz, xy, xz, yz */
    int i, j, k;
    add_inertia(own, 1, &b->inertia);
    m[0][0] = own[0];
    m[1][1] = own[1];
    m[2][2] = own[2];
    m[0][1] = m[1][0] = own[3];
    m[0][2] = m[2][0] = own[4];
    m[1][2] = m[2][1] = own[5];
    for (i = 0; i < 3; i++) turn3(b->q, axes[i], axes[i]);
    for (k = 0; k < 6; k++) /* sum of m_ij a_i a_j */
        for (i = 0; i < 3; i++)
            for (j = 0; j < 3; j++) sum[k] += sign * m[i][j] * axes[i][row[k]] * axes[j][column[k]];
    add_point_inertia(sum, sign * (double)b->mass, (double)d.x, (double)d.y, (double)d.z);
    return trace_of(&b->inertia) + (double)b->mass * size3(d) * (size3(d) + size3(b->r) + size3(about));
}

static int same_body(const vm_body *a, const vm_body *b) { return memcmp(a, b, sizeof *a) == 0; }
static int finite_body(const vm_body *b)
{
    return is_finite(b->mass) && finite3(b->r) && finite3(b->v) && finite3(b->omega) && is_finite(b->inertia.xx) &&
           is_finite(b->inertia.yy) && is_finite(b->inertia.zz) && is_finite(b->inertia.xy) &&
           is_finite(b->inertia.xz) && is_finite(b->inertia.yz) && is_finite(b->q.w) && is_finite(b->q.x) &&
           is_finite(b->q.y) && is_finite(b->q.z);
}

#endif
