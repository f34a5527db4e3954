/* bodies.h - random bodies and impulses for the tests of varmass.h, and bodies made of particles, whose momenta can
   be summed without any formula. */
#ifndef BODIES_H
#define BODIES_H

#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';
static const double eps = (double)VM_EPSILON;

static inline vm_vec3 vector(double x, double y, double z) { return vmi_vec3(R(x), R(y), R(z)); }
static inline vm_vec3 random_vector(double size)
{
    double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return vector(x, y, z);
}
static inline double size_of(vm_vec3 a) { return sqrt((double)vm_dot(a, a)); }

static inline vm_inertia inertia(double xx, double xy, double xz, double yy, double yz, double zz)
{
    vm_inertia i;
    i.xx = R(xx);
    i.yy = R(yy);
    i.zz = R(zz);
    i.xy = R(xy);
    i.xz = R(xz);
    i.yz = R(yz);
    return i;
}

static inline vm_quat random_attitude(void)
{
    vm_quat q;
    q.w = R(uniform(-1, 1));
    q.x = R(uniform(-1, 1));
    q.y = R(uniform(-1, 1));
    q.z = R(uniform(-1, 1));
    return q;
}

/* A body of a few random particles rigidly joined: its inertia is possible by construction. */
static inline vm_body random_body(double mass, double size)
{
    vm_vec3 at[6], centre = vector(0, 0, 0);
    vm_body b;
    int i;
    memset(&b, 0, sizeof b);
    for (i = 0; i < 6; i++) {
        at[i] = random_vector(size);
        centre = vm_add(centre, vm_scale(R(1. / 6), at[i]));
    }
    for (i = 0; i < 6; i++)
        b.inertia = vmi_inertia_plus(b.inertia, R(mass / 6), vmi_inertia_of_point(vm_sub(at[i], centre)));
    b.mass = R(mass);
    b.q = random_attitude();
    b.r = random_vector(3);
    b.v = random_vector(5);
    b.omega = random_vector(4);
    return b;
}

/* n points of equal mass on a line along axis, from its middle */
static inline vm_body rod(int n, vm_vec3 axis)
{
    vm_body b;
    int i;
    memset(&b, 0, sizeof b);
    b.mass = R(n);
    for (i = 0; i < n; i++)
        b.inertia = vmi_inertia_plus(b.inertia, 1, vmi_inertia_of_point(vm_scale(R(i - (n - 1) / 2.), axis)));
    return b;
}

static inline vm_impulse random_impulse(void)
{
    vm_impulse j;
    j.linear = random_vector(3);
    j.couple = random_vector(3);
    j.at = random_vector(3);
    return j;
}

static inline vm_impulse opposite(vm_impulse j)
{
    j.linear = vm_scale(-1, j.linear);
    j.couple = vm_scale(-1, j.couple);
    return j;
}

/* ---- particles, in double whatever the type tested ---- */

typedef struct particle {
    double m, r[3];
} particle;

typedef struct sums {
    double mass, K[3], L[3], T, K_size, L_size;
} sums; /* of particles, L about a point; and of the sizes of their momenta */

/* The body that n particles make, its axes turned by q */
static inline vm_body body_of(int n, const particle *p, vm_quat q)
{
    vm_body b;
    vmi_mat3 turn = vmi_rotation(q);
    double mass = 0, centre[3] = {0, 0, 0}, d[3];
    int i, k;
    memset(&b, 0, sizeof b);
    for (i = 0; i < n; i++) {
        mass += p[i].m;
        for (k = 0; k < 3; k++) centre[k] += p[i].m * p[i].r[k];
    }
    for (k = 0; k < 3; k++) centre[k] /= mass;
    for (i = 0; i < n; i++) {
        for (k = 0; k < 3; k++) d[k] = p[i].r[k] - centre[k];
        b.inertia = vmi_inertia_plus(b.inertia, R(p[i].m),
                                     vmi_inertia_of_point(vmi_times_transposed(&turn, vector(d[0], d[1], d[2]))));
    }
    b.mass = R(mass);
    b.q = q;
    b.r = vector(centre[0], centre[1], centre[2]);
    return b;
}

/* Add the momenta of n particles that move rigidly as the body does, sign times */
static inline void add_particles(sums *s, double sign, int n, const particle *p, const vm_body *b,
                                 const double *about)
{
    const double v[3] = {(double)b->v.x, (double)b->v.y, (double)b->v.z};
    const double w[3] = {(double)b->omega.x, (double)b->omega.y, (double)b->omega.z};
    const double c[3] = {(double)b->r.x, (double)b->r.y, (double)b->r.z};
    int i, k;
    for (i = 0; i < n; i++) {
        double u[3], arm2 = 0, u2 = 0;
        for (k = 0; k < 3; k++) {
            int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            u[k] = v[k] + w[k1] * (p[i].r[k2] - c[k2]) - w[k2] * (p[i].r[k1] - c[k1]);
            u2 += u[k] * u[k];
            arm2 += (p[i].r[k] - about[k]) * (p[i].r[k] - about[k]);
        }
        for (k = 0; k < 3; k++) {
            int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            s->K[k] += sign * p[i].m * u[k];
            s->L[k] += sign * p[i].m * ((p[i].r[k1] - about[k1]) * u[k2] - (p[i].r[k2] - about[k2]) * u[k1]);
        }
        s->mass += sign * p[i].m;
        s->T += sign * p[i].m * u2 / 2;
        s->K_size += p[i].m * sqrt(u2);
        s->L_size += p[i].m * sqrt(u2 * arm2);
    }
}

static inline double length3(const double *a) { return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

/* Start the generator elsewhere: program [seed] */
static inline void draw_anew(int argc, char **argv)
{
    long skip = 0;
    if (argc > 1 && sscanf(argv[1], "%ld", &skip) == 1)
        for (skip *= 1009; skip > 0; skip--) uniform(0, 1);
}

#endif
