/* particles.h - bodies made of particles, before and after a jump. Their momenta and energies are sums over the
   particles, which need no formula of rigid bodies: the judge of the tests of momenta and of jumps. */
#ifndef PARTICLES_H
#define PARTICLES_H

#include "bodies.h"

enum { PARTICLES = 14, PIECES = 4 };

/* A whole body and the pieces into which it breaks, or from which it is put together */
typedef struct shot {
    particle p[PARTICLES];
    int first[PIECES + 1]; /* piece i has the particles first[i] to first[i + 1] - 1; piece 0 is the rest */
    vm_body whole, piece[PIECES];
    vm_impulse impulse;
    double about[3]; /* the point about which angular momenta are taken */
} shot;

static const sums no_sums = {0, {0, 0, 0}, {0, 0, 0}, 0, 0, 0};

/* Random motions, impulse and point. If unequal, the rest is up to 100 times as heavy or as light as the pieces.
   The point is near, since a mass centre at r is right to eps |r|. */
static inline void draw_shot(shot *s, int unequal)
{
    static const int first[PIECES + 1] = {0, 5, 8, 10, PARTICLES};
    const double rest_weight = unequal ? pow(10, uniform(is_float ? -1 : -2, 2)) : 1;
    const double size = pow(10, uniform(-1, 1));
    const vm_vec3 place = random_vector(2 * size), about = random_vector(5);
    int i, k;
    memcpy(s->first, first, sizeof first);
    for (i = 0; i < PARTICLES; i++) {
        s->p[i].m = uniform(0.3, 1) * (i < s->first[1] ? rest_weight : 1);
        s->p[i].r[0] = (double)place.x + uniform(-size, size);
        s->p[i].r[1] = (double)place.y + uniform(-size, size);
        s->p[i].r[2] = (double)place.z + uniform(-size, size);
    }
    s->whole = body_of(PARTICLES, s->p, random_attitude());
    s->whole.v = random_vector(5);
    s->whole.omega = random_vector(3);
    for (k = 0; k < PIECES; k++) {
        s->piece[k] = body_of(s->first[k + 1] - s->first[k], s->p + s->first[k], random_attitude());
        s->piece[k].v = random_vector(5);
        s->piece[k].omega = random_vector(3);
    }
    s->impulse = random_impulse();
    s->about[0] = (double)about.x;
    s->about[1] = (double)about.y;
    s->about[2] = (double)about.z;
}

/* Add, sign times, the momenta of the particles of one piece, or of all, that move as the body `motion` does */
static inline void add_piece(sums *sum, double sign, const shot *s, int piece, const vm_body *motion)
{
    add_particles(sum, sign, s->first[piece + 1] - s->first[piece], s->p + s->first[piece], motion, s->about);
}
static inline void add_whole(sums *sum, double sign, const shot *s, const vm_body *motion)
{
    add_particles(sum, sign, PARTICLES, s->p, motion, s->about);
}

#endif
