/* Ill-posed jumps: what is left has next to no inertia or mass, or cannot exist; and matrices that do not solve. */

/* A lamina spins at 3.3 rad/s; a part at its centre, of the inertia x0 of 2.1, moves on as before: the rest's spin */
static vm_real thin_rest_ours(const vm_real *x)
{
    vm_body2 whole = {5, VM_C(2.1), 0, 0, 0, 0, 0, VM_C(3.3)}, part = {1, 0, 0, 0, 0, 0, 0, VM_C(3.3)}, rest;
    part.inertia = x[0];
    return vm_separate2(&whole, &part, NULL, &rest) == VM_OK ? rest.omega : VM_NAN;
}
static vm_real thin_rest_naive(const vm_real *x)
{
    return (VM_C(2.1) * VM_C(3.3) - x[0] * VM_C(3.3)) / (VM_C(2.1) - x[0]);
}

/* The same in space: the whole of moments 2, 2, 1 tilted by 1 rad about y, the part 1, 1, x0: omega_x of the rest.
   Naive: by Cramer's rule in inertial axes */
static vm_real det3(const vm_real *a) /* symmetric, xx yy zz xy xz yz */
{
    return a[0] * (a[1] * a[2] - a[5] * a[5]) - a[3] * (a[3] * a[2] - a[5] * a[4]) +
           a[4] * (a[3] * a[5] - a[1] * a[4]);
}
static vm_real tilted_rest_ours(const vm_real *x)
{
    vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {2, 0, 1, 0}, {0, 0, 0}, {1, 2, 3}, {VM_C(0.7), VM_C(0.3), VM_C(1.9)}};
    vm_body part = whole, rest;
    part.mass = 1, part.inertia.xx = part.inertia.yy = 1, part.inertia.zz = x[0];
    return vm_separate(&whole, &part, NULL, &rest) >= 0 ? rest.omega.x : VM_NAN;
}
static vm_real tilted_rest_naive(const vm_real *x)
{
    const vm_real c = VM_C(0.6), s = VM_C(0.8), w[3] = {VM_C(0.7), VM_C(0.3), VM_C(1.9)}; /* z axis: (s, 0, c) */
    vm_real rest[6], h[3];
    int k;
    for (k = 0; k < 2; k++) { /* the whole's, less the part's, tensor and angular momentum */
        const vm_real A = k ? 1 : 2, C = k ? x[0] : 1, sign = k ? -1 : 1;
        const vm_real xx = A * c * c + C * s * s, zz = A * s * s + C * c * c, xz = (C - A) * s * c;
        if (k == 0) memset(rest, 0, sizeof rest), memset(h, 0, sizeof h);
        rest[0] += sign * xx, rest[1] += sign * A, rest[2] += sign * zz, rest[4] += sign * xz;
        h[0] += sign * (xx * w[0] + xz * w[2]), h[1] += sign * A * w[1], h[2] += sign * (xz * w[0] + zz * w[2]);
    }
    return (h[0] * rest[2] - rest[4] * h[2]) * rest[1] / det3(rest);
}

/* The rest is a rod along z, which spun at 3 rad/s: its spin cannot have changed. zz of whole and part: x0, x1. */
static vm_real rod_rest_ours(const vm_real *x)
{
    vm_body whole = {5, {2, 2, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 3}}, part = whole, rest;
    whole.inertia.zz = x[0];
    part.mass = 1, part.inertia.xx = part.inertia.yy = VM_C(0.5), part.inertia.zz = x[1], part.omega.z = VM_C(2.5);
    return vm_separate(&whole, &part, NULL, &rest) == VM_NULL_AXIS ? rest.omega.z : VM_NAN;
}
static vm_real rod_rest_naive(const vm_real *x) { return (x[0] * 3 - x[1] * VM_C(2.5)) / (x[0] - x[1]); }
/* Two points of the masses x0, 1 become a rod along (1, 2, 0); omega before: (3, 1, 4) of the first: omega_x */
static vm_real rod_of_points_ours(const vm_real *x)
{
    vm_body a = {1, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {3, 1, 4}}, b = a, whole;
    a.mass = x[0], b.r.x = 1, b.r.y = 2;
    return vm_attach(&a, &b, NULL, &whole) >= 0 ? whole.omega.x : VM_NAN;
}
static vm_real rod_of_points_naive(const vm_real *x)
{
    const vm_real mu = x[0] / (x[0] + 1);
    const vm_real I[6] = {4 * mu, mu, 5 * mu, -2 * mu, 0, 0};
    return (0 * I[1] * I[2]) / det3(I); /* no angular momentum: Cramer's rule */
}

/* A part of x1 of the mass x0 leaves at the speed x3, the whole having had x2: the speed of what little is left */
static vm_real light_rest_ours(const vm_real *x)
{
    vm_body2 whole = {0, 0, 0, 0, 0, 0, 0, 0}, part = {0, 0, 0, 0, 0, 0, 0, 0}, rest;
    whole.mass = x[0], part.mass = x[1], whole.vx = x[2], part.vx = x[3];
    return vm_separate2(&whole, &part, NULL, &rest) >= 0 ? rest.vx : VM_NAN;
}
static vm_real light_rest_naive(const vm_real *x) { return (x[0] * x[2] - x[1] * x[3]) / (x[0] - x[1]); }

/* A part 3/8 m off the centre moves on nearly as before, at the speed x1 beside x0, spin 3: the rest's spin, by
   angular momenta */
static vm_real fast_spin_ours(const vm_real *x)
{
    vm_body2 whole = {5, 2, 0, 0, 0, 0, 0, 3}, part = {1, VM_C(0.125), VM_C(0.375), 0, 0, 0, 0, 3}, rest;
    whole.vy = x[0], part.vy = x[1];
    return vm_separate2(&whole, &part, NULL, &rest) == VM_OK ? rest.omega : VM_NAN;
}
static vm_real fast_spin_naive(const vm_real *x)
{
    const vm_real d = VM_C(0.375), d1 = -d / 4, v2 = x[1], v1 = (5 * x[0] - v2) / 4;
    return (6 - VM_C(0.375) - d * v2 - 4 * d1 * v1) / (2 - VM_C(0.125) - d * d - 4 * d1 * d1);
}

/* The part's spin for which the rest goes on spinning at 1.7, as the whole did; the part has the inertia x0 of 2 */
static vm_real wanted_spin_ours(const vm_real *x)
{
    vm_body2 whole = {5, 2, 0, 0, 0, 0, 0, VM_C(1.7)}, part = {1, 0, 0, 0, 0, 0, 0, 0}, moving;
    part.inertia = x[0];
    return vm_separation_for_rest2(&whole, &part, NULL, NULL, &whole.omega, &moving) == VM_OK ? moving.omega : VM_NAN;
}
static vm_real wanted_spin_naive(const vm_real *x) { return (2 * VM_C(1.7) - (2 - x[0]) * VM_C(1.7)) / x[0]; }

/* A rod that swings at 1.7 rad/s is cut x0 from its pivot end's 1 m, the part moves on as before but for Omega = x1:
   the rest's rate, by angular momenta (125) */
static vm_real short_pendulum_ours(const vm_real *x)
{
    const vm_pendulum pendulum = {3, 1, VM_C(0.25), VM_C(1.7), VM_AXES_COS_SIN};
    vm_pendulum_cut cut;
    return vm_pendulum_separate(&pendulum, x[0], x[1], 0, 0, &cut) == VM_OK ? cut.rest.rate : VM_NAN;
}
static vm_real short_pendulum_naive(const vm_real *x)
{
    const vm_real l = x[0], left = 1 - l, m = 3 * l, O2 = m * (1 - l + l * l / 3);
    return (VM_C(1.7) - O2 * VM_C(1.7) - m * l * l / 12 * x[1]) / ((3 - m) * left * left / 3);
}

/* Statuses: what vm_separate says of a part of mass x0, moments x1, x2, x3, at the distance x4, against a whole of
   mass 5 and moments 2, 2, 3. Naive: no objection */
static vm_real refused_ours(const vm_real *x)
{
    vm_body whole = {5, {2, 2, 3, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}}, part = whole, rest;
    part.mass = x[0], part.inertia.xx = x[1], part.inertia.yy = x[2], part.inertia.zz = x[3], part.r.x = x[4];
    return (vm_real)vm_separate(&whole, &part, NULL, &rest);
}
static vm_real refused_naive(const vm_real *x)
{
    (void)x;
    return VM_OK;
}
/* The rest's angular velocity for which no part's velocity does: the part is at the centre */
static vm_real no_lever_ours(const vm_real *x)
{
    vm_body2 whole = {5, 2, 0, 0, 0, 0, 0, 1}, part = {1, VM_C(0.125), 0, 0, 0, 0, 0, 1}, moving;
    part.x = x[0];
    return (vm_real)vm_separation_for_spin2(&whole, &part, NULL, 2, &moving);
}
static vm_real no_lever_naive(const vm_real *x)
{
    (void)x;
    return VM_OK;
}
/* qdot_1 of two coordinates hit by (1, 0), the mass matrix (x0 x1; x1 x2); -5, VM_SINGULAR, where it is none */
static vm_real hit_or_not_ours(const vm_real *x)
{
    const vm_real impulse[2] = {1, 0}, rest[2] = {0, 0};
    vm_real matrix[4], after[2], work[VM_LAGRANGE_WORK(2)];
    int status;
    matrix[0] = x[0], matrix[1] = matrix[2] = x[1], matrix[3] = x[2];
    status = vm_lagrange_impact(2, matrix, rest, impulse, after, work);
    return status ? (vm_real)status : after[0];
}
static vm_real hit_or_not_naive(const vm_real *x) { return x[2] / (x[0] * x[2] - x[1] * x[1]); }

/* Two laminas at x0, and x1, from the origin become one: omega, by the angular momentum about the origin */
static vm_real far_attach_ours(const vm_real *x)
{
    vm_body2 a = {4, 1, 0, 0, 0, 0, 3, 1}, b = {1, VM_C(0.25), 0, 0, 0, 0, 5, 1}, whole;
    a.x = x[0], b.x = x[1];
    return vm_attach2(&a, &b, NULL, &whole) == VM_OK ? whole.omega : VM_NAN;
}
static vm_real far_attach_naive(const vm_real *x)
{
    const vm_real X = (4 * x[0] + x[1]) / 5, v = VM_C(17.) / 5;
    return (1 + 4 * 3 * x[0] + VM_C(0.25) + 5 * x[1] - 5 * X * v) /
           (1 + 4 * x[0] * x[0] + VM_C(0.25) + x[1] * x[1] - 5 * X * X);
}

static const hard_case jumps_cases[] = {
    CASE(thin_rest, 2, "spin of a rest with the inertia 1e-3, if the part moves on as before: differences cancel",
         2.0990003),
    CASE(thin_rest, 2, "spin of a rest with the inertia 4e-9, if the part moves on as before: differences cancel",
         R(2.0999999957, 2.09997)),
    CASE(thin_rest, 2, "spin of a rest with the inertia 2e-13, if the part moves on as before: differences cancel",
         R(2.0999999999998, 2.099995)),
    CASE(tilted_rest, 8,
         "spin of a rest with the inertia 1e-5 about a tilted axis, by Cramer's rule: determinants cancel",
         R(0.99999, 0.9999)),
    CASE(tilted_rest, 8,
         "spin of a rest with the inertia 1e-9 about a tilted axis, by Cramer's rule: determinants cancel",
         R(0.9999999987, 0.99997)),
    CASE(tilted_rest, 8,
         "spin of a rest with the inertia 2e-13 about a tilted axis, by Cramer's rule: determinants cancel",
         R(0.9999999999998, 0.999995)),
    CASE(rod_rest, 2, "spin of a rest that is a thin rod, about its axis: the formula divides by 0", 0.5, 0.5),
    CASE(rod_rest, 2, "spin of a rest that is a rod but for rounding errors: the formula divides by a rounding error",
         R(0.30000000000000004, 0.3), R(0.3, 0.29999998)),
    CASE(rod_of_points, 4, "spin of two points that become a rod: no inertia about its axis, so the formula is 0/0", 3),
    CASE(rod_of_points, 4, "spin of two points of the masses 1 and 1e4 that become a rod: the formula is 0/0", 10000),
    CASE(light_rest, 4,
         "speed of the rest after 0.9999999 of the mass has left, from a difference of momenta that cancels", 1,
         R(0.9999999, 0.9999), 1000.1, 1000.1),
    CASE(light_rest, 4, "speed of the rest after all but 1e-12 of the mass has left: the difference of momenta cancels",
         1, R(0.999999999999, 0.99999), 1000.1, 1000.1),
    CASE(light_rest, 4, "speed of the rest after nearly all mass has left slowly: the difference of momenta cancels", 3,
         R(2.99999999, 2.9999), 1000.1, R(1000.10000001, 1000.2)),
    CASE(fast_spin, 8, "spin of the rest at 1e9 m/s, by angular momenta: the large moments of the momenta cancel",
         R(1000000000.1, 10000.1), R(1000000001.2, 10001.2)),
    CASE(fast_spin, 8, "spin of the rest at 1e12 m/s, by angular momenta: the large moments of the momenta cancel",
         R(1e12, 100000.1), R(1000000000001.1, 100001.2)),
    CASE(wanted_spin, 4,
         "spin of a part with 1e-7 of the inertia for which the rest keeps its spin: a difference cancels",
         R(1e-7, 1e-4)),
    CASE(wanted_spin, 4,
         "spin of a part with 1e-14 of the inertia for which the rest keeps its spin: a difference cancels",
         R(1e-14, 1e-6)),
    CASE(short_pendulum, 4, "spin of a pendulum that is cut close to its pivot: differences of angular momenta cancel",
         R(0.999, 0.99), 0),
    CASE(short_pendulum, 4,
         "spin of a pendulum of which 1e-6 of the length is left: differences of angular momenta cancel",
         R(0.999999, 0.999), 0),
    CASE(short_pendulum, 8,
         "spin of a pendulum cut close to its pivot, if the part spins a little faster: differences cancel",
         R(0.9999, 0.99), R(1e-9, 1e-5)),
    CASE(refused, 0.1, "status for a part as heavy as the whole: must be an error; the formula would divide by 0", 5, 1,
         1, 1, 0),
    CASE(refused, 0.1, "status for a part with more inertia than the whole: must be an error, no formula notices it", 1,
         1, 2.5, 3, 0),
    CASE(refused, 0.1,
         "status for a part too far away to have been in the whole: must be an error, no formula notices it", 1, 0.1,
         0.1, 0.1, 2),
    CASE(refused, 0.1, "status for a rest whose moments violate the triangle inequality: must be an error", 1, 1.5, 1.5,
         0.5, 0),
    CASE(no_lever, 0.1, "status for a part at the mass centre whose velocity shall spin the rest: must be an error", 0),
    CASE(hit_or_not, 0.1, "velocity after an impact, mass matrix indefinite with a positive diagonal: must be refused",
         1, 2, 1),
    CASE(hit_or_not, 0.1,
         "velocity after an impact, two coordinates of one mass: to be refused, determinant is a rounding error", 0.1,
         0.3, R(0.9, 0.90000004)),
    CASE(hit_or_not, 0.1, "velocity after an impact, a coordinate moves no mass: must be refused", 1, 0, 0),
    CASE(far_attach, 16,
         "spin after an attachment far from the origin, by angular momenta about the origin: they cancel",
         R(100000.1, 300.1), R(100000.6, 300.6)),
    CASE(far_attach, 16, "spin after an attachment farther from the origin, by such angular momenta: they cancel",
         R(100000000.1, 10000.1), R(100000000.6, 10000.6)),
};
