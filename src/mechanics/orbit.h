/* mechanics/orbit.h - two bodies that attract each other, with constant masses and with masses that change

   The vector r from one body to the other obeys r'' = -mu r/|r|^3 with mu = G (M1 + M2). G is the constant of
   gravitation; M1, M2 are the masses of the bodies. The equation holds if mass that leaves or joins has the velocity
   of its body (in a scene: the field `reactive` is 0). vm_orbit solves this equation for constant mu (Kepler's
   problem). It works for ellipses, parabolas, hyperbolas and straight lines. vm_orbit_meshchersky solves the equation
   for Meshchersky's law: mu/(1 + c t) replaces mu. This is one of the problems of variable mass (Gylden's problem)
   that have a closed form. A scene with vm_effect_gravitation computes the motion for any law of mass.

       vm_vec3 r = {7e6, 0, 0}, v = {0, 7.6e3, 0}; // m, m/s
       vm_orbit(3600, 3.986004418e14, r, v, &r, &v); // an hour later; the results may be the inputs

   The equations. Lengths are in units of |r0|, times in units of sqrt(|r0|^3/mu), where r0 and v0 are the vector r and
   the velocity v at t = 0. Let sigma = r0 v0 (the dot product) and beta = 2 - v0^2. Stumpff's functions of a variable s
   are, in the form used here,
     G1 = s - beta s^3/3! + ..., G2 = s^2/2! - beta s^4/4! + ..., G3 = s^3/3! - beta s^5/5! + ...
   The functions G1, G2, G3 consist of sines and cosines of sqrt(beta) s for beta > 0, and of hyperbolic functions for
   beta < 0. The time is t = s + sigma G2 + (1 - beta) G3. Its derivative dt/ds = 1 + sigma G1 + (1 - beta) G2 is the
   distance R = |r|. Then
     r = (1 - G2) r0 + (t - G3) v0,  v = -G1/R r0 + (1 - G2/R) v0.

   On a fast hyperbola that passes close to the centre, these sums lose all digits after the passage: their terms grow
   to about v0^4 times their sum. There s is counted from the pericentre, the point closest to the centre. Let
   h = |r0 x v0| be the angular momentum, q = sqrt(-beta), and e = sqrt(1 + q^2 h^2) the eccentricity. The body is at
   the pericentre at the time
     T = (|sigma| - ln((1 + q^2 + |sigma| q)/e)/q)/q^2.
   In the equations that count s from the pericentre, lengths are in units of |r0|/q^2, and times in units of
   sqrt(|r0|^3/mu)/q^3; T, h and sigma keep the units from above. Then beta = -1, and the distance of the pericentre is
   D = e - 1 = q^2 h^2/(1 + e). The time since T is D s + e G3, and R = D + e G2. No terms of these sums cancel. Let P
   be the unit vector towards the pericentre, and K the velocity there times D. With w = v0 - sigma r0,
     P = ((h^2 - 1) r0 - sigma w)/e,  K = q (h^2 sigma r0 + (h^2 - 1) w)/e,
     q^2 r = (D - G2) P + G1 K,  v/q = ((1 + G2) K - G1 P)/R.
   h and w are computed from the cross product of r0 and v0. On a straight line this product is exactly 0, and then
   e = 1, D = 0, P = -r0 and K = 0.

   For Meshchersky's law let f = 1 + c t, r = f xi and tau = t/f. Then xi, as a function of the time tau, obeys the
   equation for constant mu.

   This chapter has no function for Meshchersky's second law, mu/sqrt(1 + c t). With f = sqrt(1 + c t), r = f xi, tau =
   ln(1 + c t)/c and, here, a prime ' for d/dtau, the equation of motion becomes
     xi'' = (c^2/4) xi - mu xi/|xi|^3.
   Therefore |xi'|^2/2 - mu/|xi| - c^2 |xi|^2/8 and the cross product xi x xi' (the angular momentum) are constant. If s
   is defined by d tau = |xi| ds, the distance |xi| is an elliptic function of s. But tau and the angle are elliptic
   integrals of the third kind, whose parameters are the roots of a polynomial of degree 4. These parameters are complex
   for most orbits, and there are three kinds of parameters. The function tau(s) must be inverted by iteration. Digits
   cancel where two roots are close: next to a circle, and for small mu or c. Integration of the equation in t or in tau
   by rk87 avoids all these difficulties (tests/test_orbit.c, test_second_law).

   Tests: tests/test_orbit.c. */
#ifndef VARMASS_MECHANICS_ORBIT_H
#define VARMASS_MECHANICS_ORBIT_H

#include "../base/elementary.h"
#include "../base/power_of_two.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/words.h"
#include "vectors.h"

/* The functions G1, G2, G3 of the equations at the top of mechanics/orbit.h */
typedef struct VM_TAG(vmi_stumpff) {
    vm_real g1, g2, g3;
} vmi_stumpff;

/* Computes G1, G2, G3 by their series, for |beta| s^2 <= 4. The first omitted term of each series is then below 1e-18
   of its sum. */
VM_API vmi_stumpff vmi_stumpff_series(vm_real beta, vm_real s)
{
    const vm_real x = beta * s * s;
    vm_real c2 = 1, c3 = 1;
    vmi_stumpff g;
    int k;
    for (k = 11; k > 0; k--) {
        c2 = 1 - x * c2 / (vm_real)((2 * k + 1) * (2 * k + 2));
        c3 = 1 - x * c3 / (vm_real)((2 * k + 2) * (2 * k + 3));
    }
    c2 /= 2;
    c3 /= 6;
    g.g1 = s * (1 - x * c3);
    g.g2 = s * s * c2;
    g.g3 = s * s * s * c3;
    return g;
}

/* Returns x/root^3, also where root^3 overflows. */
VM_API vm_real vmi_over_cube(vm_real x, vm_real root)
{
    const vm_real cube = root * root * root;
    if (cube > VM_MAX) return x / root / root / root;
    return x / cube;
}

/* Computes G1, G2, G3 for any beta and s >= 0. The results are infinite where e^(sqrt(-beta) s) overflows. */
VM_API vmi_stumpff vmi_stumpff_at(vm_real beta, vm_real s)
{
    const vm_real root = VM_SQRT(VM_FABS(beta)), z = root * s;
    vm_real sine, cosine, half;
    vmi_stumpff g;
    if (z <= 2) return vmi_stumpff_series(beta, s);
    if (beta > 0) {
        vmi_sincos(z / 2, &half, &cosine);
        vmi_sincos(z, &sine, &cosine);
        g.g3 = (z - sine) / (root * root * root);
    } else {
        const vm_real growing = vmi_exp(z / 2, 0);
        half = (growing - 1 / growing) / 2;
        sine = half * (growing + 1 / growing);
        g.g3 = vmi_over_cube(sine - z, root);
    }
    g.g1 = sine / root;
    g.g2 = 2 * (half / root) * (half / root);
    return g;
}

/* Kepler's problem in the units of the equations at the top of mechanics/orbit.h. The variable s is 0 at the start, or
   at the pericentre. */
typedef struct VM_TAG(vmi_kepler) {
    vm_real distance; /* |r| at s = 0: 1 at the start */
    vm_real sigma;    /* the dot product r v at s = 0 */
    vm_real beta;     /* 2 - v0^2 for the start, -1 for the pericentre; the energy per unit mass is -beta/2 */
    vm_real rest;     /* 1 - beta distance: 1 - beta for the start, the eccentricity e for the pericentre */
} vmi_kepler;

/* The time and the distance that belong to a value of the variable s of the equations at the top of
   mechanics/orbit.h */
typedef struct VM_TAG(vmi_kepler_point) {
    vmi_stumpff g;
    vm_real time, distance;
    vm_real noise; /* sum of the absolute values of the terms of `time`, times 4 VM_EPSILON */
} vmi_kepler_point;

VM_API vmi_kepler_point vmi_kepler_at(const vmi_kepler *o, vm_real s)
{
    vmi_kepler_point p;
    vm_real first, second;
    p.g = vmi_stumpff_at(o->beta, s);
    first = o->sigma * p.g.g2;
    second = o->rest * p.g.g3;
    p.time = o->distance * s + (first + second);
    p.noise = 4 * VM_EPSILON * (o->distance * s + VM_FABS(first) + VM_FABS(second));
    p.distance = o->distance + (o->sigma * p.g.g1 + o->rest * p.g.g2);
    return p;
}

/* Finds the variable s >= 0 at the time t >= 0, and returns the distance and the functions G1, G2, G3 for this s. The
   time is a rising function of s. Therefore the function keeps a lower and an upper bound of s, and brings them closer
   in each step of Newton's method. If a step leaves these bounds, or is longer than half the previous step, s is
   doubled or the interval is halved instead. On a fast hyperbola the time rises exponentially with s, so that Newton's
   method alone would need too many steps. There the first s is so small that the time does not overflow. */
VM_API vmi_kepler_point vmi_kepler_solve(const vmi_kepler *o, vm_real t)
{
    const int most = 3 * VM_MANT_DIG; /* halving alone needs VM_MANT_DIG steps; Newton's method needs fewer */
    const vm_real largest_exponent = VM_MANT_DIG > 24 ? 700 : 80; /* e^x is finite up to this x */
    const vm_real longest = o->beta < 0 ? largest_exponent / VM_SQRT(-o->beta) : 1;
    vm_real low = 0, high = VM_INFINITY, s = vmi_smaller(vmi_smaller(t, 1), longest), before = VM_INFINITY;
    vmi_kepler_point p = vmi_kepler_at(o, s);
    int i;
    for (i = 0; i < most; i++) {
        const vm_real late = p.time - t, step = late / p.distance;
        vm_real next = s - step;
        if (VM_FABS(late) <= vmi_smaller(p.noise, t)) break;
        if (VM_FABS(step) <= VM_EPSILON * s && VM_IS_FINITE(p.distance)) break; /* the distance may overflow alone */
        if (late < 0) low = s;
        else high = s; /* also where the time is infinite or NaN */
        if (!(next > low && next < high && 2 * VM_FABS(step) <= before)) {
            next = (low + high) / 2;
            if (high == VM_INFINITY) next = 2 * s;
        }
        if (high == VM_INFINITY) next = vmi_smaller(next, 16 * s); /* before the time overflows */
        if (next == s) break;
        before = VM_FABS(next - s);
        s = next;
        p = vmi_kepler_at(o, s);
    }
    return p;
}

/* Returns the time t minus a whole number of periods if the orbit is an ellipse (beta > 0), else t. The result for an
   ellipse is at most about one period before or after 0. It is 0 if |t| is above period/eps, because the digits of t
   then do not tell where on the ellipse the body is. */
VM_API vm_real vmi_kepler_reduce(vm_real beta, vm_real t)
{
    vm_real period;
    if (!(beta > 0)) return t;
    period = 2 * VM_PI / (beta * VM_SQRT(beta));
    if (!(VM_FABS(t) > period / 2 && period > 0)) return t;
    if (VM_FABS(t) > period / VM_EPSILON) return 0;
    return t - period * VM_FLOOR(t / period + VM_C(0.5));
}

/* The pericentre of a hyperbola, with the letters of the equations at the top of mechanics/orbit.h */
typedef struct VM_TAG(vmi_pericentre) {
    vmi_kepler orbit;  /* with s counted from the pericentre, in the units |r0|/q^2 and sqrt(|r0|^3/mu)/q^3 */
    vm_real time;      /* T */
    vm_real q;         /* sqrt(-beta) */
    vm_vec3 direction; /* P */
    vm_vec3 moment;    /* K */
} vmi_pericentre;

/* Returns the cross product of the vectors r0 and v0 of the equations, which are r/distance and v/speed here. Each
   component has only a relative error of a few eps, even where the difference of its two products cancels. For parallel
   vectors the result is exactly 0. The divisions by powers of two are exact and keep the products from overflowing. */
VM_API vm_vec3 vmi_spin(vm_vec3 r, vm_vec3 v, vm_real distance, vm_real speed)
{
    const vm_real length = vmi_power_below(distance), rate = vmi_power_below(speed);
    const vm_vec3 a = vmi_over(r, length), b = vmi_over(v, rate);
    const vm_vec3 product = vmi_vec3(vmi_sum_of_products(a.y, b.z, -a.z, b.y), vmi_sum_of_products(a.z, b.x, -a.x, b.z),
                                     vmi_sum_of_products(a.x, b.y, -a.y, b.x));
    return vm_scale(length / distance * (rate / speed), product);
}

/* Computes the pericentre of a hyperbola (o->beta < 0) on which the body comes closer (o->sigma < 0). `start` is the
   unit vector r0, and `spin` the cross product of r0 and v0. */
VM_API vmi_pericentre vmi_pericentre_of(const vmi_kepler *o, vm_vec3 start, vm_vec3 spin)
{
    const vm_real q = VM_SQRT(-o->beta), h = vm_norm(spin), e = vmi_hypot(1, q * h);
    const vm_real cosine = (h * h - 1) / e, sine = h * o->sigma / e; /* of the angle between K and w */
    const vm_vec3 w = vm_cross(spin, start);
    vmi_pericentre c;
    c.orbit.distance = q * h * (q * h / (1 + e));
    c.orbit.sigma = 0;
    c.orbit.beta = -1;
    c.orbit.rest = e;
    c.time = (-o->sigma - vmi_log((1 + q * (q - o->sigma)) / e).hi / q) / (q * q);
    c.q = q;
    c.direction = vm_sub(vm_scale(cosine, start), vm_scale(o->sigma / e, w));
    c.moment = vm_add(vm_scale(q * h * sine, start), vm_scale(q * cosine, w));
    return c;
}

/* Computes the position and the velocity at the time t >= 0 with s counted from the start. `start` and `rate` are the
   vectors r0 and v0. */
VM_API void vmi_move_from_start(const vmi_kepler *o, vm_vec3 start, vm_vec3 rate, vm_real t, vm_vec3 *r, vm_vec3 *v)
{
    const vmi_kepler_point p = vmi_kepler_solve(o, t);
    *r = vm_add(vm_scale(1 - p.g.g2, start), vm_scale(t - p.g.g3, rate));
    *v = vm_sub(vm_scale(1 - p.g.g2 / p.distance, rate), vm_scale(p.g.g1 / p.distance, start));
}

/* Computes the position and the velocity at the time t >= 0 with s counted from the pericentre. For a time before the
   passage, the function computes the point that is as long after it, and then changes the sign of G1. The last step of
   Newton's method may be too small to change s, because s is rounded. It is therefore applied to G1 and G2. At s = 40,
   for example, the next larger value of s would change them by 32 eps of themselves. */
VM_API void vmi_move_from_pericentre(const vmi_pericentre *c, vm_real t, vm_vec3 *r, vm_vec3 *v)
{
    const vm_real passed = (t - c->time) * c->q * (c->q * c->q), since = VM_FABS(passed);
    const vmi_kepler_point p = vmi_kepler_solve(&c->orbit, since);
    const vm_real step = (since - p.time) / p.distance;
    const vm_real g1 = VM_COPYSIGN(p.g.g1 + step * (1 + p.g.g2), passed), g2 = p.g.g2 + step * p.g.g1;
    const vm_real per_distance = c->q / (c->orbit.distance + c->orbit.rest * g2);
    const vm_vec3 position = vm_add(vm_scale(c->orbit.distance - g2, c->direction), vm_scale(g1, c->moment));
    const vm_vec3 velocity = vm_sub(vm_scale(1 + g2, c->moment), vm_scale(g1, c->direction));
    *r = vmi_over(position, c->q * c->q);
    *v = vm_scale(per_distance, velocity);
}

/* Position and velocity after t seconds on an orbit about a centre with the attraction mu/r^2 (Kepler's problem).
   r0 (m) is the position relative to the centre and v0 (m/s) the velocity at t = 0; mu (m^3/s^2) is G times the mass in
   the centre, or G (M1 + M2) if r0 and v0 are the position and velocity of one body relative to another. t may be
   negative. The orbit may be an ellipse, a parabola, a hyperbola or a straight line; on a straight line the body turns
   back at the centre. Errors of a few eps in t, r0, v0 and mu would change the result; the error of the function is as
   large as this change, and grows with the number of revolutions. There is one exception: the error can be 100 times as
   large after a body with |r0| |v0|^2/mu < 100 has passed close to the centre.
   A call takes about as long as 50 calls of sin. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an
   argument or the result is infinite or NaN (on a straight line, for example, the velocity at the centre), or if
   |r0| |v0|^2/mu overflows; VM_DOMAIN for mu <= 0 or r0 = 0; VM_OK otherwise. */
VM_API int vm_orbit(vm_real t, vm_real mu, vm_vec3 r0, vm_vec3 v0, vm_vec3 *r, vm_vec3 *v)
{
    vm_real distance0, speed, unit, time, sign = 1;
    vm_vec3 start, rate, position, velocity;
    vmi_pericentre centre;
    vmi_kepler o;
    int near_centre;
    if (!r || !v) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(mu)) return VM_NOT_FINITE;
    if (!vmi_vec3_is_finite(r0) || !vmi_vec3_is_finite(v0)) return VM_NOT_FINITE;
    distance0 = vm_norm(r0);
    if (!(mu > 0 && distance0 > 0)) return VM_DOMAIN;
    speed = VM_SQRT(mu / distance0);
    unit = distance0 / speed;
    start = vmi_over(r0, distance0);
    rate = vmi_over(v0, speed);
    o.sigma = vm_dot(start, rate);
    o.beta = 2 - vm_dot(rate, rate);
    o.distance = 1;
    o.rest = 1 - o.beta;
    time = vmi_kepler_reduce(o.beta, t / unit);
    if (!VM_IS_FINITE(time) || !VM_IS_FINITE(o.beta)) return VM_NOT_FINITE;
    if (time < 0) {
        sign = -1;
        time = -time;
        o.sigma = -o.sigma;
        rate = vm_scale(-1, rate);
    }
    /* With s counted from the start, the error after the passage grows with the square of (1 - beta)/e, where e >= 1.
       Before the body has come about half the way to the centre, it has not grown yet. */
    near_centre = -o.sigma * time > VM_C(0.5) && o.rest > 4;
    if (near_centre) {
        centre = vmi_pericentre_of(&o, start, vm_scale(sign, vmi_spin(r0, v0, distance0, speed)));
        near_centre = o.rest > 4 * centre.orbit.rest;
    }
    if (near_centre) vmi_move_from_pericentre(&centre, time, &position, &velocity);
    else vmi_move_from_start(&o, start, rate, time, &position, &velocity);
    position = vm_scale(distance0, position);
    velocity = vm_scale(sign * speed, velocity);
    if (!vmi_vec3_is_finite(position) || !vmi_vec3_is_finite(velocity)) return VM_NOT_FINITE;
    *r = position;
    *v = velocity;
    return VM_OK;
}

/* Position and velocity after t seconds, while the attraction changes by Meshchersky's law mu/(1 + rate t).
   The two bodies lose mass (rate > 0, per second) or gain it (rate < 0) in the same proportion, and the mass that
   leaves or joins has the velocity of its body. The equation is that of Gylden and Meshchersky,
   r'' = -mu/(1 + rate t) r/|r|^3. The other arguments and the accuracy are those of vm_orbit, but the
   error of the velocity also contains a few eps |rate r0|. Returns VM_BAD_MASS if 1 + rate t is not positive, else a
   status of vm_orbit. */
VM_API int vm_orbit_meshchersky(vm_real t, vm_real mu, vm_real rate, vm_vec3 r0, vm_vec3 v0, vm_vec3 *r, vm_vec3 *v)
{
    vm_vec3 position, velocity;
    vm_real f;
    int status;
    if (!r || !v) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(rate)) return VM_NOT_FINITE;
    if (!VM_IS_FINITE(mu) || !vmi_vec3_is_finite(r0) || !vmi_vec3_is_finite(v0)) return VM_NOT_FINITE;
    f = 1 + rate * t;
    if (!VM_IS_FINITE(f)) return VM_NOT_FINITE;
    if (!(f > 0)) return VM_BAD_MASS;
    status = vm_orbit(t / f, mu, r0, vm_sub(v0, vm_scale(rate, r0)), &position, &velocity);
    if (status) return status;
    velocity = vm_add(vmi_over(velocity, f), vm_scale(rate, position));
    position = vm_scale(f, position);
    if (!vmi_vec3_is_finite(position) || !vmi_vec3_is_finite(velocity)) return VM_NOT_FINITE;
    *r = position;
    *v = velocity;
    return VM_OK;
}

#endif
