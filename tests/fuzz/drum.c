/* Fuzz target: varmass.h, chapter 5.2, the drum and Lambert's W. Inverses, monotony, ranges, the two ways to
   phi(t). */
#include "bodies.h"

static void check_lambert(void)
{
    const vm_real x = MOSTLY(draw_in(-0.37, 3)), l = MOSTLY(draw_in(-700, 700));
    const double least = -0.36787944117144233;
    const vm_real w0 = vm_lambert_w0(x), wm1 = vm_lambert_wm1(x), w = vm_wright_omega(l);
    if (is_nan(x) || (double)x < least * (1 + 4 * EPS)) HOLDS(is_nan(w0) && is_nan(wm1));
    if ((double)x > least && is_finite(x)) {
        HOLDS(w0 >= -1 && (x >= 0) == (w0 >= 0));
        if (x < R(1e30) && (VM_FABS(x) > VM_MIN || x == 0))
            HOLDS(fabs((double)w0 * exp((double)w0) - (double)x) <=
                  4 * EPS * fabs((double)x) * (2 + fabs((double)w0)));
        if (x < VM_MAX) HOLDS(vm_lambert_w0(neighbour(x, 1)) >= w0 - 2 * VM_EPSILON * VM_FABS(w0));
    }
    if (x > 0) HOLDS(is_nan(wm1));
    if ((double)x > least && x < -VM_MIN / VM_EPSILON) {
        HOLDS(wm1 <= -1);
        HOLDS(fabs((double)wm1 * exp((double)wm1) - (double)x) <=
              4 * EPS * fabs((double)x) * (2 + fabs((double)wm1)));
    }
    HOLDS(is_nan(l) == is_nan(w));
    if (is_finite(l)) {
        HOLDS(w >= 0 && !is_nan(w));
        if (VM_FABS(l) < 80)
            HOLDS(fabs((double)w + log((double)w) - (double)l) <= 4 * EPS * (2 + fabs((double)l) + (double)w));
    }
    if (l <= -1 && is_finite(l)) {
        const vm_real a = vm_lambert_w0_neg_exp(l), b = vm_lambert_wm1_neg_exp(l);
        HOLDS(a <= 0 && a >= -1 && b <= -1 && is_finite(b));
    } else if (l <= -1) HOLDS(vm_lambert_w0_neg_exp(l) == 0 && vm_lambert_wm1_neg_exp(l) == l);
    else HOLDS(is_nan(vm_lambert_w0_neg_exp(l)) && is_nan(vm_lambert_wm1_neg_exp(l)));
}

static vm_drum draw_drum(void)
{
    vm_drum d;
    d.radius = MOSTLY(draw_log(0.1, 2));
    d.mass = MOSTLY(draw_log(0.1, 100));
    d.inertia = MOSTLY(draw_log(0.1, 100));
    d.band = MOSTLY(draw_byte() % 8 ? draw_log(1e-3, 1) : 0);
    d.speed = MOSTLY(draw_in(-3, 3));
    d.damping = MOSTLY(draw_in(0, 1));
    d.stiffness = MOSTLY(draw_log(1, 1e4));
    d.omega = MOSTLY(draw_log(0.1, 30));
    return d;
}

static int tame_drum(const vm_drum *d)
{
    return tame(d->radius) && tame(d->mass) && tame(d->inertia) && tame(d->band) && tame(d->speed) &&
           tame(d->damping) && tame(d->stiffness) && tame(d->omega) && d->mass > 0 && d->inertia > 0 &&
           d->omega > 0 && d->radius > 0 && d->band >= 0;
}

/* r = 1 + e phi/(J0 Omega_b) = -k1 W(x), l = ln|x| = -ln|k1| - f1/k1: an error dl of l, roundings and what an eps of
   k1 = 1 - e/(j Omega_b) makes, moves r by r k1/(k1 - r) dl, without bound at the branch point r = k1 */
static void check_published(const vm_drum *d, vm_real t)
{
    const double e = (double)d->band * (double)d->speed * (double)d->radius - (double)d->damping;
    const double j_omega = (double)d->band * (double)d->radius * (double)d->radius * (double)d->omega;
    const double phi = (double)vm_drum_angle(d, t), spin = (double)d->inertia * (double)d->omega;
    const double r = 1 + e * phi / spin, k1 = 1 - e / j_omega, f1 = r - k1 * log(r);
    const double of_k1 = (1 + fabs(e / j_omega)) / fabs(k1), l = fabs(log(fabs(k1))) + fabs(f1 / k1);
    const double dl = 1 + l + (1 + fabs(f1 / k1)) * of_k1, dr = r * (1 + of_k1) + fabs(r * k1 / (k1 - r)) * dl;
    if (!(j_omega > 0) || e == 0 || !(fabs(k1) > 1e3 * EPS * (1 + fabs(e / j_omega))) || !(r > 0)) return;
    HOLDS(within(vm_drum_angle_lambert(d, t), R(phi), 32 * EPS * (phi + spin / fabs(e) * dr)));
}

/* The band lies at the radius R, so that J - J0 = (M - M0) R^2; Steiner from the axle to the mass centre, which is
   that of the band's arc, M0 being at the axle */
static void check_geometry(const vm_drum *d, vm_real phi, const vm_drum_geometry *g)
{
    const double M = (double)g->mass, wound = (double)d->band * (double)phi, R_ = (double)d->radius;
    const double J = (double)g->axle_inertia, offset = (double)g->offset;
    HOLDS(within(g->mass, R((double)d->mass + wound), 4 * EPS * M));
    HOLDS(fabs(J - (double)d->inertia - wound * R_ * R_) <= 8 * EPS * J);
    HOLDS(fabs(J - (double)g->inertia - M * offset * offset) <= 16 * EPS * J);
    HOLDS(fabs(M * offset - wound * (double)g->arc_centre) <= 16 * EPS * wound * R_ * (1 + (double)phi));
    HOLDS(fabs((double)g->arc_centre) <= R_ * (1 + 4 * EPS));
}

/* Is j Omega_b t/J0 or e t/J0 so large that vm_drum_angle is NaN? The comment of the function has the bound. */
static int two_words_overflow(const vm_drum *d, vm_real t)
{
    const double most = (double)VM_MAX / (IS_FLOAT ? 8192 : 268435456), per_inertia = (double)t / (double)d->inertia;
    const double j = (double)d->band * (double)d->radius * (double)d->radius;
    const double e = (double)d->band * (double)d->radius * (double)d->speed - (double)d->damping;
    return !(j * (double)d->omega * per_inertia < most && fabs(e) * per_inertia < most);
}

static void check_rigid(void)
{
    const vm_drum d = draw_drum();
    const vm_real phi = MOSTLY(draw_in(0, 6.2)), stop = vm_drum_stop(&d), rate = vm_drum_rate(&d, phi),
                  t = vm_drum_time(&d, phi);
    vm_drum_geometry g;
    int status;
    HOLDS(is_nan(stop) || stop >= 0);
    STAIN(g);
    status = vm_drum_at(&d, phi, &g);
    if (status) HOLDS(UNTOUCHED(g));
    else {
        HOLDS(g.mass > 0 && g.inertia > 0 && (!tame_drum(&d) || g.mass >= d.mass));
        if (tame_drum(&d) && tame(phi)) check_geometry(&d, phi, &g);
    }
    HOLDS(is_nan(vm_drum_rate(NULL, phi)) && is_nan(vm_drum_angle(NULL, 1)) && is_nan(vm_drum_time(NULL, 1)) &&
          is_nan(vm_drum_stop(NULL)));
    if (!tame_drum(&d) || !is_finite(phi)) return;
    if (phi < 0 || phi > stop) {
        HOLDS(is_nan(rate) && is_nan(t));
        return;
    }
    if (!(phi < R(0.9) * stop) || phi > 7) return;
    HOLDS(rate > 0 && t >= 0);
    HOLDS(vm_drum_time(&d, neighbour(phi, 1)) >= t * (1 - 8 * VM_EPSILON) - 2 * SMALLEST);
    if (two_words_overflow(&d, t)) return;
    HOLDS(within(vm_drum_angle(&d, t), phi, 16 * EPS * ((double)phi + (double)rate * (double)t)));
    check_published(&d, t);
}

/* The wave that a start begins begins so, to a few roundings of the terms, of which a and k make the sizes. */
static void check_drum_start(const vm_drum_shaft *s)
{
    const vm_real at_0 = MOSTLY(draw_in(-1, 1)), slope = MOSTLY(draw_in(-1, 1)), particular = MOSTLY(draw_in(-1, 1));
    vm_real a = 7, alpha = 7;
    const int status = vm_drum_deflection_start(s, at_0, slope, particular, &a, &alpha);
    double terms;
    if (status) {
        HOLDS(a == 7 && alpha == 7);
        return;
    }
    HOLDS(a >= 0 && is_finite(a) && VM_FABS(alpha) <= VM_PI);
    if (!tame(at_0) || !tame(slope) || !tame(particular) || !tame(s->A) || !tame(s->delta) || !tame(s->k)) return;
    terms = (1 + fabs((double)s->A) + fabs((double)s->delta)) * (fabs((double)at_0) + fabs((double)particular));
    terms = (terms + fabs((double)slope)) * (1 + 1 / (double)s->k) * (1 + (double)s->k);
    HOLDS(within(vm_drum_deflection(s, 0, a, alpha, particular), at_0, 32 * EPS * terms));
    HOLDS(within(vm_drum_deflection_slope(s, 0, a, alpha, particular), slope,
                 32 * EPS * terms * (1 + fabs((double)s->A) + fabs((double)s->delta))));
}

/* The motion over the angle with the angular velocity among its states; the correction of this velocity */
static void check_drum_coupled(void)
{
    vm_drum d = draw_drum();
    vm_real y[VM_DRUM_COUPLED_STATES], dydt[VM_DRUM_COUPLED_STATES], at[2], slope[2];
    const vm_real phi = MOSTLY(draw_in(0, 6)), rise = MOSTLY(draw_in(-0.1, 0.1));
    const vm_real rate = vm_drum_rate(&d, phi), elastic = vm_drum_rate_elastic(&d, phi, rise);
    int i, status;
    for (i = 0; i < VM_DRUM_COUPLED_STATES; i++) y[i] = MOSTLY(draw_in(-1, 1));
    STAIN(dydt);
    status = vm_drum_rhs_coupled(phi, y, dydt, &d);
    if (status) HOLDS(UNTOUCHED(dydt));
    else HOLDS(y[VM_DRUM_RATE] > 0 && dydt[VM_DRUM_TIME] > 0);
    STAIN(at);
    status = vm_drum_unbalance(&d, phi, at, slope);
    if (status) HOLDS(UNTOUCHED(at) && status < 0);
    else HOLDS(phi >= 0 && vmi_all_finite(2, at) && vmi_all_finite(2, slope) && slope[0] == -at[1]);
    if (is_nan(rate) || !is_finite(rise)) HOLDS(is_nan(elastic));
    else if (tame_drum(&d) && tame(phi) && tame(rise) && d.band > 0)
        HOLDS(elastic == rate || (elastic < rate) == (rise > 0 && rate > 0));
}

static void check_shaft(void)
{
    vm_drum d = draw_drum();
    vm_real y[6], dydt[6], phi = MOSTLY(draw_in(0, 6)), x;
    vm_drum_shaft s;
    int i;
    for (i = 0; i < 6; i++) y[i] = draw_in(-1, 1);
    y[2] = phi;
    if (tame_drum(&d) && phi >= 0 && phi < 7) {
        if (vm_drum_rhs(0, y, dydt, &d) == 0) HOLDS(vmi_all_finite(6, dydt));
        if (vm_drum_rhs_reduced(0, y, dydt, &d) == 0) HOLDS(vmi_all_finite(6, dydt));
        if (vm_drum_rhs_angle(phi, y, dydt, &d) == 0 && vm_drum_rate(&d, phi) > R(1e-3))
            HOLDS(vmi_all_finite(4, dydt));
    } else {
        vm_drum_rhs(0, y, dydt, &d);
        vm_drum_rhs_reduced(0, y, dydt, &d);
        vm_drum_rhs_angle(phi, y, dydt, &d);
    }
    STAIN(s);
    if (vm_drum_shaft_init(&s, &d)) {
        HOLDS(UNTOUCHED(s));
        return;
    }
    check_drum_start(&s);
    x = vm_drum_deflection(&s, phi, 1, 0, 0);
    if (tame_drum(&d) && phi >= 0 && phi < 7) {
        HOLDS(is_nan(x) == !(1 - s.A * phi > 0));
        if (vm_drum_shaft_valid(&s) && s.delta >= 0 && s.A <= 0) HOLDS(VM_FABS(x) <= 1 + 64 * VM_EPSILON);
        HOLDS(within(vm_drum_deflection(&s, 0, 1, 0, 0), 1, 4 * EPS));
    }
    HOLDS(vm_drum_shaft_valid(NULL) == 0 && is_nan(vm_drum_deflection(NULL, phi, 1, 0, 0)));
    HOLDS(vm_drum_band(2, 1, 1, 1) == 2);
}

static void fuzz_drum(void)
{
    switch (draw_below(4)) {
    case 0:
        check_shaft();
        check_drum_coupled();
        break;
    case 1: check_lambert(); break;
    default: check_rigid();
    }
}
FUZZ_TARGET(drum)
