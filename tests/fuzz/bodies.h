/* bodies.h - bodies, impulses and attitudes out of bytes, for the targets of varmass.h */
#ifndef FUZZ_BODIES_H
#define FUZZ_BODIES_H
#include "fuzz.h"

static vm_vec3 draw_vector(double size)
{
    vm_vec3 a;
    a.x = draw_in(-size, size), a.y = draw_in(-size, size), a.z = draw_in(-size, size);
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
    q.w = draw_in(-1, 1), q.x = draw_in(-1, 1), q.y = draw_in(-1, 1), q.z = draw_in(-1, 1);
    if (draw_byte() % 8 == 0) q.w = q.x = q.y = q.z = 0;
    return q;
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
    i.xx = R(m * (b + c)), i.yy = R(m * (c + a)), i.zz = R(m * (a + b));
    if (turned == 1) { /* about z */
        const double p = m * (b + c), q = m * (c + a);
        i.xx = R(k * k * p + s * s * q), i.yy = R(s * s * p + k * k * q), i.xy = R(k * s * (p - q));
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
    b.r = draw_vector(3), b.v = draw_vector(5), b.omega = draw_vector(4);
    return b;
}

static vm_body2 draw_body2(double size)
{
    vm_body2 b;
    b.mass = MOSTLY(draw_log(1e-2, 1e2));
    b.inertia = (is_finite(b.mass) ? b.mass : 1) * draw_in(0, size) * draw_in(0, size);
    b.x = draw_in(-3, 3), b.y = draw_in(-3, 3), b.angle = draw_in(-4, 4);
    b.vx = MOSTLY(draw_in(-5, 5)), b.vy = draw_in(-5, 5), b.omega = MOSTLY(draw_in(-4, 4));
    return b;
}

static vm_impulse draw_impulse(void)
{
    vm_impulse j;
    j.linear = draw_vector(3), j.couple = draw_vector(3), j.at = draw_vector(3);
    return j;
}

static vm_impulse2 draw_impulse2(void)
{
    vm_impulse2 j;
    j.jx = draw_in(-3, 3), j.jy = draw_in(-3, 3), j.couple = MOSTLY(draw_in(-3, 3)), j.x = draw_in(-3, 3),
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

static int same_body(const vm_body *a, const vm_body *b) { return memcmp(a, b, sizeof *a) == 0; }
static int finite_body(const vm_body *b)
{
    return is_finite(b->mass) && finite3(b->r) && finite3(b->v) && finite3(b->omega) && is_finite(b->inertia.xx) &&
           is_finite(b->inertia.yy) && is_finite(b->inertia.zz) && is_finite(b->inertia.xy) &&
           is_finite(b->inertia.xz) && is_finite(b->inertia.yz) && is_finite(b->q.w) && is_finite(b->q.x) &&
           is_finite(b->q.y) && is_finite(b->q.z);
}

#endif
