/* Fuzz target: varmass.h, chapters 2, 3 and 4.1. Parts separate and are attached, in space and in the plane: momentum
   and angular momentum balance, what was separated and is attached again is what it was, energies agree with the
   theorems, the inverse question answers itself, refusals change nothing. */
#include "bodies.h"

static int tame_impulse(const vm_impulse *j) { return !j || (tame3(j->linear) && tame3(j->couple) && tame3(j->at)); }

/* What roundings may do to the angular momentum of n bodies besides some eps of their angular momenta about a given point. A jump
   computes about the centre of the body that it changes. There fast bodies may have much angular momentum, even if they pass
   close to the given point; `momentum` is the sum of |m v|. Far from the origin positions are rounded: a moment of inertia that is
   lost in this rounding counts as none, and takes its angular momentum with it. */
static double noise_of_places(int n, const vm_body *bodies, vm_vec3 centre, double momentum)
{
    double far = 0, reach = 0, moments = 0, turning = 0;
    int i;
    for (i = 0; i < n; i++) {
        const double distance = size3(vm_sub(bodies[i].r, centre));
        far = larger(far, size3(bodies[i].r));
        reach = larger(reach, distance);
        moments += (double)bodies[i].mass * distance;
        turning += size3(bodies[i].omega);
    }
    return 16 * EPS * far * moments * turning + 4 * EPS * momentum * reach;
}

/* Momentum and angular momentum about a random point balance, to some eps of what is there for each part that joins.
   `untrue` is the error of an inertia that a body cannot have and that was made possible, times its angular velocity. */
static void check_balance(int n, const vm_body *before, int m, const vm_body *after, const vm_impulse *external,
                          int null_axis, double untrue)
{
    const vm_vec3 about = draw_vector(2);
    vm_balance b;
    int status;
    STAIN(b);
    status = vm_balance_between(n, before, m, after, external, about, &b);
    if (status < 0) {
        HOLDS(UNTOUCHED(b));
        return;
    }
    if (!tame3(about) || !tame_impulse(external)) return;
    HOLDS(size3(b.momentum) <= 16 * EPS * (double)b.momentum_scale);
    if (!null_axis)
        HOLDS(size3(b.angular_momentum) <= (n > 2 ? n - 1 : 1) * 64 * EPS * (double)b.angular_momentum_scale +
                                               noise_of_places(n, before, after->r, (double)b.momentum_scale) +
                                               noise_of_places(m, after, before->r, (double)b.momentum_scale) + untrue);
}

/* Inertias about one point and in one set of axes add up: what is before is what is after. A moment that is lost
   in 8 eps of what was added and subtracted counts as none; in a separation that is of m M/(M - m) at d. Returns the
   error that is allowed. */
static double check_parts(int n, const vm_body *before, int m, const vm_body *after, double growth)
{
    double sum[6] = {0, 0, 0, 0, 0, 0}, scale = 0;
    int i;
    for (i = 0; i < n; i++) scale += add_body_inertia(sum, 1, before + i, before->r);
    for (i = 0; i < m; i++) scale += add_body_inertia(sum, -1, after + i, before->r);
    for (i = 0; i < 6; i++) HOLDS(fabs(sum[i]) <= 64 * EPS * growth * scale);
    return 64 * EPS * growth * scale;
}

/* What an eps makes of the energies of n bodies about a point: of the velocities; of the positions, which moves
   moments of momentum, m |v| and m d omega, times omega; of the inertias and of what Steiner adds to them, which
   counts where one is nearly that of a rod and a small angular momentum about it spins it */
static double sway(int n, const vm_body *const *bodies, vm_vec3 about, double growth)
{
    double unused[6] = {0, 0, 0, 0, 0, 0}, turning = 0, inertia = 0, energy = 0;
    int i;
    for (i = 0; i < n; i++) {
        inertia += growth * add_body_inertia(unused, 1, bodies[i], about);
        turning += size3(bodies[i]->omega);
    }
    for (i = 0; i < n; i++) {
        const double v = size3(bodies[i]->v), reach = size3(bodies[i]->r) + size3(about);
        energy += (double)bodies[i]->mass * v * (v + turning * reach);
    }
    return energy + inertia * turning * turning;
}

static void check_kinetics(const vm_body *b)
{
    const vm_vec3 origin = {0, 0, 0}, p = vm_momentum(b), L = vm_angular_momentum(b, origin);
    const vm_real T = vm_kinetic_energy(b);
    if (!tame_body(b)) return;
    HOLDS(finite3(p) && finite3(L) && is_finite(T));
    if (b->mass > 0 && vm_inertia_is_possible(&b->inertia))
        HOLDS(T >= 0 || T >= -R(64) * VM_EPSILON * (b->inertia.xx + b->inertia.yy + b->inertia.zz) *
                                 R(size3(b->omega) * size3(b->omega)));
    HOLDS(is_nan(vm_kinetic_energy(NULL)) && is_nan3(vm_momentum(NULL)) &&
          is_nan3(vm_angular_momentum(NULL, origin)));
}

/* A part that sits where the whole is large enough for it */
static vm_body draw_part(const vm_body *whole)
{
    vm_body part = draw_body(0.3);
    part.mass = draw_byte() % 16 ? whole->mass * draw_in(0, 1) : draw_any();
    part.inertia = draw_inertia(is_finite(part.mass) ? part.mass : 1, 0.2);
    part.r = vm_add(whole->r, draw_vector(0.3));
    return part;
}

/* A part that moves on as it did: the rest does so too, and no energy comes or goes, whatever the inertias are. The
   roundings of the part's velocity count for the reduced mass m M/(M - m) at d; what they make of the energy beside
   the angular momentum times omega, and what they make of omega times its error, is of second order. */
static void check_quiet(const vm_body *whole, vm_body part)
{
    const vm_vec3 d = vm_sub(part.r, whole->r);
    const double turning = size3(whole->omega), speed = size3(whole->v) + turning * (size3(d) + size3(part.r));
    double share, noise, T, scale;
    const vm_body *all[3];
    vm_body rest, change;
    part.omega = whole->omega;
    part.v = vm_add(whole->v, vm_cross(whole->omega, d));
    if (vm_separate(whole, &part, NULL, &rest) < 0 || !tame_body(&rest) || !tame_body(&part)) return;
    share = (double)(part.mass / rest.mass);
    change = rest;
    change.omega = vm_sub(rest.omega, whole->omega);
    noise = share * (double)whole->mass * size3(d) * speed + trace_of(&rest.inertia) * turning;
    HOLDS(size3(vm_angular_momentum(&change, change.r)) <= 16 * EPS * noise);
    HOLDS(within3(rest.v, vm_add(whole->v, vm_cross(whole->omega, vm_sub(rest.r, whole->r))),
                  16 * EPS * (1 + share) * (speed + turning * size3(rest.r))));
    T = (double)vm_kinetic_energy(&rest) + (double)vm_kinetic_energy(&part) - (double)vm_kinetic_energy(whole);
    all[0] = whole;
    all[1] = &part;
    all[2] = &rest;
    scale = sway(3, all, whole->r, 1 + share);
    HOLDS(fabs(T) <= 16 * EPS * scale);
    HOLDS(fabs((double)vm_energy_gain(whole, 1, &part, NULL, &rest)) <= 16 * EPS * scale);
}

static void check_separate(void)
{
    const vm_body whole = draw_body(1), part = draw_part(&whole);
    const vm_impulse impulse = draw_impulse(), *external = draw_byte() & 1 ? &impulse : NULL;
    vm_body rest, both[2], again, same;
    double error;
    int status;
    STAIN(rest);
    status = vm_separate(&whole, &part, external, &rest);
    check_kinetics(&whole);
    if (status < 0) {
        HOLDS(UNTOUCHED(rest) && status >= VM_BAD_INERTIA);
        return;
    }
    HOLDS(finite_body(&rest) && rest.mass > 0 && vm_inertia_is_possible(&whole.inertia));
    same = whole;
    HOLDS(vm_separate(&same, &part, external, &same) == status && same_body(&same, &rest));
    HOLDS(vm_separate_all(&whole, 1, &part, external, &again) == status && same_body(&again, &rest));
    if (!tame_body(&whole) || !tame_body(&part) || !tame_body(&rest) || !tame_impulse(external)) return;
    both[0] = rest;
    both[1] = part;
    error = check_parts(1, &whole, 2, both, (double)(whole.mass / rest.mass));
    check_balance(1, &whole, 2, both, external, status == VM_NULL_AXIS, error * size3(whole.omega));
    check_quiet(&whole, part);
    if (status == VM_OK && !external) {
        const double gain = (double)vm_energy_gain(&whole, 1, &part, NULL, &rest);
        const double T = (double)vm_kinetic_energy(&rest) + (double)vm_kinetic_energy(&part);
        const vm_body *const all[3] = {&whole, &part, &rest};
        const double scale = sway(3, all, whole.r, (double)(whole.mass / rest.mass));
        HOLDS(gain >= -16 * EPS * scale && fabs(T - (double)vm_kinetic_energy(&whole) - gain) <= 16 * EPS * scale);
    }
    if (vm_attach(&rest, &part, NULL, &again) == VM_OK) { /* plastic impact: back again, but for the impulse */
        HOLDS(close_to(again.mass, whole.mass, 8));
        if (!external)
            HOLDS(within3(again.v, whole.v, 64 * EPS * (size3(whole.v) + size3(part.v) + size3(rest.v))));
        HOLDS(within3(again.r, whole.r, 64 * EPS * (size3(whole.r) + size3(part.r) + size3(rest.r))));
    }
}

/* Jumps on an axle: the body then turns about the axle, and momenta balance with the impulse of the axle. */
static void check_axle(void)
{
    const vm_body whole = draw_body(1), part = draw_part(&whole);
    const int attach = draw_byte() & 1;
    vm_body after[2], before[2];
    vm_impulse reaction;
    vm_axle axle;
    int status;
    axle.at = draw_vector(2);
    axle.axis = draw_vector(2);
    STAIN(after[0]);
    STAIN(reaction);
    if (attach) status = vm_attach_on_axle(&axle, &whole, 1, &part, NULL, &after[0], &reaction);
    else status = vm_separate_on_axle(&axle, &whole, 1, &part, NULL, &after[0], &reaction);
    if (status < 0) {
        HOLDS(UNTOUCHED(after[0]) && UNTOUCHED(reaction));
        return;
    }
    HOLDS(finite_body(&after[0]) && after[0].mass > 0 && (status == VM_OK || status == VM_NULL_AXIS));
    if (status || !tame_body(&whole) || !tame_body(&part) || !tame_body(&after[0]) || !tame_impulse(&reaction)) return;
    if (!tame3(axle.at) || !tame3(axle.axis) || size3(axle.axis) < 1e-3) return;
    before[0] = whole;
    before[1] = after[1] = part;
    if (attach) check_balance(2, before, 1, after, &reaction, 0, 0);
    else check_balance(1, before, 2, after, &reaction, 0, 0);
}

static void check_attach(void)
{
    const vm_body body = draw_body(1);
    const vm_impulse impulse = draw_impulse(), *external = draw_byte() & 1 ? &impulse : NULL;
    const int n = draw_below(4);
    vm_body added[3], before[4], whole;
    int status, i, tame_all = tame_body(&body);
    before[0] = body;
    for (i = 0; i < n; i++) {
        before[i + 1] = added[i] = draw_body(1);
        tame_all &= tame_body(&added[i]);
    }
    STAIN(whole);
    status = vm_attach_all(&body, n, added, external, &whole);
    if (status < 0) {
        HOLDS(UNTOUCHED(whole));
        return;
    }
    HOLDS(finite_body(&whole) && whole.mass >= body.mass);
    if (!tame_all || !tame_body(&whole)) return;
    HOLDS(vm_inertia_is_possible(&whole.inertia));
    check_balance(n + 1, before, 1, &whole, external, status == VM_NULL_AXIS, 0);
    check_parts(n + 1, before, 1, &whole, 1);
    if (!external && status == VM_OK) { /* Carnot's loss */
        const double loss = (double)vm_energy_loss(&body, n, added, NULL, &whole);
        double T = (double)vm_kinetic_energy(&body);
        const vm_body *all[5];
        double scale;
        for (i = 0; i < n; i++) T += (double)vm_kinetic_energy(&added[i]);
        for (i = 0; i <= n; i++) all[i] = before + i;
        all[n + 1] = &whole;
        scale = sway(n + 2, all, whole.r, 1);
        HOLDS(loss >= -16 * EPS * scale && fabs(T - (double)vm_kinetic_energy(&whole) - loss) <= 16 * EPS * scale);
    }
}

static void check_tensors(const vm_inertia *a, const vm_inertia *b, double tolerance)
{
    HOLDS(within(a->xx, b->xx, tolerance) && within(a->yy, b->yy, tolerance) && within(a->zz, b->zz, tolerance));
    HOLDS(within(a->xy, b->xy, tolerance) && within(a->xz, b->xz, tolerance) && within(a->yz, b->yz, tolerance));
}

static void check_inertia(void)
{
    const vm_real ma = MOSTLY(draw_log(1e-3, 1e3)), mb = MOSTLY(draw_log(1e-3, 1e3));
    const vm_inertia a = draw_inertia(is_finite(ma) ? ma : 1, 1), b = draw_inertia(is_finite(mb) ? mb : 1, 1);
    const vm_vec3 d = draw_vector(2);
    vm_inertia whole, part, moved = vm_parallel_axes(&a, ma, d), back = vm_parallel_axes(&moved, -ma, d);
    vm_vec3 centre, centre2;
    double sum[6] = {0, 0, 0, 0, 0, 0}, scale, reduced;
    int i;
    STAIN(whole);
    STAIN(centre);
    if (vm_combine_inertia(ma, &a, mb, &b, d, &whole, &centre) < 0) {
        HOLDS(UNTOUCHED(whole) && UNTOUCHED(centre));
        return;
    }
    HOLDS(ma > 0 && mb > 0 && vm_inertia_is_possible(&a) && vm_inertia_is_possible(&b));
    if (!tame(ma) || !tame(mb) || !tame3(d)) return;
    HOLDS(vm_inertia_is_possible(&whole) && size3(centre) <= size3(d) * (1 + 4 * EPS));
    scale = trace_of(&moved);
    check_tensors(&back, &a, 8 * EPS * scale);
    add_inertia(sum, 1, &a);
    add_point_inertia(sum, (double)ma, (double)d.x, (double)d.y, (double)d.z);
    add_inertia(sum, -1, &moved);
    for (i = 0; i < 6; i++) HOLDS(fabs(sum[i]) <= 8 * EPS * scale);
    reduced = (double)ma * (double)mb / ((double)ma + (double)mb);
    memset(sum, 0, sizeof sum);
    add_inertia(sum, 1, &a);
    add_inertia(sum, 1, &b);
    add_inertia(sum, -1, &whole);
    add_point_inertia(sum, reduced, (double)d.x, (double)d.y, (double)d.z);     /* Steiner's share of both */
    for (i = 0; i < 6; i++) HOLDS(fabs(sum[i]) <= 64 * EPS * trace_of(&whole)); /* as check_parts */
    STAIN(part);
    STAIN(centre2);
    if (vm_split_inertia(ma + mb, &whole, mb, &b, vm_sub(d, centre), &part, &centre2) < 0) HOLDS(UNTOUCHED(part));
    else check_tensors(&part, &a, 64 * EPS * trace_of(&whole) * (1 + (double)(mb / ma)));
}

static void check_relative(void)
{
    const vm_body to = draw_body(1), body = draw_part(&to);
    const vm_impulse impulse = draw_impulse(), *external = draw_byte() & 1 ? &impulse : NULL;
    vm_body relative, absolute, rest, rest_relative;
    int status;
    STAIN(relative);
    status = vm_to_relative(&to, &body, &relative);
    if (status < 0) {
        HOLDS(status == VM_NOT_FINITE && UNTOUCHED(relative));
        return;
    }
    status = vm_to_absolute(&to, &relative, &absolute);
    HOLDS(status == VM_OK || (status == VM_NOT_FINITE && !(tame_body(&to) && tame_body(&body))));
    if (status < 0 || !tame_body(&to) || !tame_body(&body)) return;
    HOLDS(within3(absolute.v, body.v,
                  16 * EPS * (size3(to.v) + size3(body.v) + size3(to.omega) * (size3(to.r) + size3(body.r)))));
    HOLDS(within3(absolute.omega, body.omega, 8 * EPS * (size3(to.omega) + size3(body.omega))));
    if (!tame_impulse(external)) return;
    STAIN(rest_relative);
    status = vm_separate_relative(&to, &relative, external, &rest_relative);
    if (status < 0) HOLDS(UNTOUCHED(rest_relative));
    else HOLDS((vm_separate(&to, &absolute, external, &rest) >= 0) && close_to(rest.mass, rest_relative.mass, 4));
    STAIN(rest_relative);
    status = vm_attach_relative(&to, &relative, external, &rest_relative);
    if (status < 0) HOLDS(UNTOUCHED(rest_relative));
    else HOLDS(vm_attach(&to, &absolute, external, &rest) >= 0 && close_to(rest.mass, rest_relative.mass, 4));
}

static void check_inverse(void)
{
    const vm_body whole = draw_body(1), part = draw_part(&whole);
    const vm_vec3 v = draw_vector(3), omega = draw_vector(3);
    const int asked = draw_below(4);
    vm_body moving, rest;
    int status;
    STAIN(moving);
    status = vm_separation_for_rest(&whole, &part, NULL, asked & 1 ? &v : NULL, asked & 2 ? &omega : NULL, &moving);
    if (status < 0) {
        HOLDS(UNTOUCHED(moving));
        return;
    }
    if (status != VM_OK || !tame_body(&whole) || !tame_body(&part) || !tame3(v) || !tame3(omega) ||
        !tame_body(&moving))
        return;
    HOLDS(vm_separate(&whole, &moving, NULL, &rest) >= 0);
    if (asked & 1)
        HOLDS(within3(rest.v, v,
                      64 * EPS * (double)(whole.mass / rest.mass) *
                          (size3(v) + size3(whole.v) + size3(moving.v) + size3(whole.omega))));
}

/* check_parts in the plane, about the mass centre of the one that is or becomes whole */
static void check_parts2(const vm_body2 *whole, const vm_body2 *a, const vm_body2 *b, double growth)
{
    const vm_body2 *parts[2];
    double sum = (double)whole->inertia, scale = sum;
    int i;
    parts[0] = a;
    parts[1] = b;
    for (i = 0; i < 2; i++) {
        const vm_body2 *p = parts[i];
        const double dx = (double)p->x - (double)whole->x, dy = (double)p->y - (double)whole->y, d = hypot(dx, dy);
        const double reach = fabs((double)p->x) + fabs((double)p->y) + fabs((double)whole->x) +
                             fabs((double)whole->y);
        if (!tame(p->mass) || !tame(p->inertia) || !tame(whole->mass) || !tame(whole->inertia) || reach > 1e6)
            return;
        sum -= (double)p->inertia + (double)p->mass * d * d;
        scale += (double)p->inertia + (double)p->mass * d * (d + reach);
    }
    HOLDS(fabs(sum) <= 64 * EPS * growth * scale);
}

/* A jump in the plane: the part sits where the whole is large enough for it. spin and v are asked of the rest. */
typedef struct jump2 {
    vm_body2 whole, part;
    vm_impulse2 impulse;
    const vm_impulse2 *external; /* the impulse, or null */
    vm_real spin, v[2];
} jump2;

static void draw_jump2(jump2 *j)
{
    j->whole = draw_body2(1);
    j->impulse = draw_impulse2();
    j->external = draw_byte() & 1 ? &j->impulse : NULL;
    j->part = draw_body2(0.3);
    j->spin = draw_in(-3, 3);
    j->v[0] = draw_in(-3, 3);
    j->v[1] = draw_in(-3, 3);
    if (draw_byte() % 8) {
        j->part.mass = j->whole.mass * draw_in(0, 1);
        j->part.inertia = j->part.mass * draw_in(0, 0.1);
    }
    j->part.x = j->whole.x + draw_in(-0.3, 0.3);
    j->part.y = j->whole.y + draw_in(-0.3, 0.3);
}

static int tame_motion2(const vm_body2 *b) { return tame(b->mass) && tame(b->vx) && tame(b->omega); }

/* What an eps makes of the angular momentum of a body in the plane */
static double sway2(const vm_body2 *b)
{
    return (double)(b->mass * (VM_FABS(b->vx) + VM_FABS(b->vy)) * 8 + b->inertia * VM_FABS(b->omega));
}

/* Angular momentum about the origin after less before is that of the impulse. */
static void check_momentum2(const jump2 *j, const vm_body2 *rest)
{
    const vm_impulse2 *external = j->external;
    const double before = (double)vm_angular_momentum2(&j->whole, 0, 0);
    const double after = (double)vm_angular_momentum2(rest, 0, 0) + (double)vm_angular_momentum2(&j->part, 0, 0);
    const double scale = sway2(&j->whole) + sway2(rest) + sway2(&j->part) + 40;
    const double reach = 1 + fabs((double)rest->x) + fabs((double)rest->y);
    double blow = 0;
    if (!tame_motion2(&j->whole) || !tame_motion2(&j->part) || !tame(rest->omega) || !tame(rest->mass)) return;
    if (external && !tame(external->couple)) return;
    if (external)
        blow = (double)external->couple + (double)(external->x * external->jy - external->y * external->jx);
    if (VM_FABS(rest->x) < 1000 && VM_FABS(rest->y) < 1000)
        HOLDS(fabs(after - before - blow) <= 64 * EPS * scale * reach);
    HOLDS(vm_kinetic_energy2(rest) >= 0);
}

static void check_separate2(const jump2 *j)
{
    vm_body2 rest, again;
    vm_body in_space;
    int status;
    STAIN(rest);
    status = vm_separate2(&j->whole, &j->part, j->external, &rest);
    if (status < 0) {
        HOLDS(UNTOUCHED(rest));
        return;
    }
    check_parts2(&j->whole, &rest, &j->part, (double)(j->whole.mass / rest.mass));
    HOLDS(is_finite(rest.vx) && is_finite(rest.omega) && rest.mass > 0 && rest.inertia >= 0);
    HOLDS(vm_separate_all2(&j->whole, 1, &j->part, j->external, &again) == status &&
          memcmp(&again, &rest, sizeof rest) == 0);
    if (status == VM_OK) check_momentum2(j, &rest);
    in_space = vm_body_from_body2(&rest);
    if (rest.inertia < R(0.49) * VM_MAX && /* twice the inertia, the trace, does not overflow */
        (rest.inertia == 0 || rest.inertia > VM_MIN / VM_EPSILON))
        HOLDS(vm_inertia_is_possible(&in_space.inertia));
}

static void check_attach2(const jump2 *j)
{
    vm_body2 whole, again;
    int status;
    STAIN(whole);
    status = vm_attach2(&j->whole, &j->part, j->external, &whole);
    if (status < 0) {
        HOLDS(UNTOUCHED(whole));
        return;
    }
    HOLDS(whole.mass >= j->whole.mass && vm_attach_all2(&j->whole, 1, &j->part, j->external, &again) == status &&
          memcmp(&again, &whole, sizeof whole) == 0);
    check_parts2(&whole, &j->whole, &j->part, 1);
}

static void check_relative2(const jump2 *j)
{
    vm_body2 relative, again;
    int status;
    STAIN(relative);
    status = vm_to_relative2(&j->whole, &j->part, &relative);
    if (status < 0) {
        HOLDS(status == VM_NOT_FINITE && UNTOUCHED(relative));
        return;
    }
    status = vm_to_absolute2(&j->whole, &relative, &again);
    HOLDS(status == VM_OK || status == VM_NOT_FINITE);
    if (status == VM_OK && tame(j->whole.omega) && tame(j->part.omega))
        HOLDS(within(again.omega, j->part.omega,
                     4 * EPS * (double)(VM_FABS(j->whole.omega) + VM_FABS(j->part.omega))));
    STAIN(again);
    if (vm_separate_relative2(&j->whole, &relative, j->external, &again) < 0) HOLDS(UNTOUCHED(again));
    STAIN(again);
    if (vm_attach_relative2(&j->whole, &relative, j->external, &again) < 0) HOLDS(UNTOUCHED(again));
}

/* The spin that the rest is asked for, where the rest has inertia enough */
static void check_spin2(const jump2 *j, const vm_body2 *moving)
{
    const vm_body2 *whole = &j->whole;
    double speeds, noise;
    vm_body2 rest;
    if (!tame_motion2(whole) || !tame(j->part.omega) || !tame(moving->vx) || !tame(moving->vy)) return;
    if (j->external && !tame(j->external->couple)) return;
    if (vm_separate2(whole, moving, j->external, &rest) != VM_OK || rest.inertia <= R(0.1) * whole->inertia) return;
    speeds = fabs((double)moving->vx) + fabs((double)moving->vy) + fabs((double)j->part.omega) +
             fabs((double)whole->vx) + fabs((double)whole->vy);
    if (j->external) speeds += 50 / (double)whole->mass;
    noise = 1 + fabs((double)whole->omega) + speeds * (double)(whole->mass / rest.inertia);
    HOLDS(within(rest.omega, j->spin, 4e3 * EPS * noise));
}

static void check_inverse2(const jump2 *j)
{
    vm_body2 moving;
    int status;
    STAIN(moving);
    status = vm_separation_for_rest2(&j->whole, &j->part, j->external, j->v, &j->spin, &moving);
    if (status < 0) HOLDS(UNTOUCHED(moving));
    STAIN(moving);
    status = vm_separation_for_spin2(&j->whole, &j->part, j->external, j->spin, &moving);
    if (status < 0) HOLDS(UNTOUCHED(moving));
    if (status == VM_OK) check_spin2(j, &moving);
}

static void check_plane(void)
{
    jump2 j;
    draw_jump2(&j);
    check_separate2(&j);
    check_attach2(&j);
    check_relative2(&j);
    check_inverse2(&j);
}

static void fuzz_jumps(void)
{
    switch (draw_below(7)) {
    case 0: check_inertia(); break;
    case 1: check_relative(); break;
    case 2: check_inverse(); break;
    case 3: check_plane(); break;
    case 4: check_attach(); break;
    default:
        check_separate();
        check_axle(); /* after it, so that stored inputs keep their meaning */
    }
    HOLDS(strcmp(vm_strerror(-draw_below(35)), "unknown status") != 0 &&
          strcmp(vm_strerror(-35 - draw_below(90)), "unknown status") == 0);
}
FUZZ_TARGET(jumps)
