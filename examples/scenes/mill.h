/* A rolling mill (Fig. 8): drum 1 unwinds a strip of the thickness h1, and drum 3 winds it up with the thickness h2 <=
   h1. The length s1 that has left drum 1 moves with the speed v1 as a body on a line, whose mass is G = J1/r1^2 + kap
   J3/r3^2 + m1 + kap m2 with kap = h1/h2. Mass that joins or leaves a drum has the velocity of the drum, but the radii
   change:

     G v1' = T3/r3 - T_b/r1 + F_r - rho b h1 (kap - 1) v1^2 + kap^2 h2 J3 v1^2/(2 pi r3^4) - h1 J1 v1^2/(2 pi r1^4) */
#include "stage.h"

typedef struct mill_data {
    double h1, h2, T3, Tb, Fr; /* m, N m, N */
} mill_data;

static const mill_data mill_free = {0.002, 0.002, 0, 0, 0}, mill_driven = {0.002, 0.0015, 9000, 6000, 8000};

typedef struct mill_now {
    double r1, r3, J1, J3, G;
} mill_now;

static inline mill_now mill_at(const mill_data *a, double s1)
{
    const double pi = 3.14159265358979324, rho = 7800, core = 0.25, strip = rho * a->h1 * 4, kap = a->h1 / a->h2;
    mill_now m;
    m.r1 = sqrt(0.75 * 0.75 - a->h1 * s1 / pi);
    m.r3 = sqrt(0.25 * 0.25 + a->h1 * s1 / pi);
    m.J1 = 25 + pi / 2 * rho * (pow(m.r1, 4) - pow(core, 4));
    m.J3 = 25 + pi / 2 * rho * (pow(m.r3, 4) - pow(core, 4));
    m.G = m.J1 / (m.r1 * m.r1) + kap * m.J3 / (m.r3 * m.r3) + strip + kap * (rho * a->h2 * 4);
    return m;
}

static inline vm_mass_law_values mill_mass(vm_real t, vm_real s1, vm_real v1, void *ctx)
{
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    (void)v1;
    now.mass = REAL(mill_at((const mill_data *)ctx, (double)s1).G);
    return now;
}

static inline vm_real mill_force(vm_real t, vm_real s1, vm_real v1, void *ctx)
{
    const double two_pi = 6.28318530717958648, v = (double)v1;
    const mill_data *a = (const mill_data *)ctx;
    const mill_now m = mill_at(a, (double)s1);
    const double kap = a->h1 / a->h2;
    (void)t;
    return REAL(a->T3 / m.r3 - a->Tb / m.r1 + a->Fr -
                v * v *
                    (7800 * a->h1 * (kap - 1) - kap * kap * a->h2 * m.J3 / (two_pi * pow(m.r3, 4)) +
                     a->h1 * m.J1 / (two_pi * pow(m.r1, 4))));
}

static inline void mill(stage *s, const mill_data *a, double v0, double length)
{
    int strip;
    stage_clear(s, 100);
    strip = stage_body(s, vm_scene_body_line(1, 0, REAL(v0)));
    stage_effect(s, vm_effect_mass_law(strip, mill_mass, (void *)a, stage_vec(0, 0, 0), 0));
    stage_effect(s, vm_effect_force(strip, 0, mill_force, (void *)a));
    stage_event(s, vm_then_stop(vm_event_position(strip, 0, REAL(length), 1)));
}
