/* The numerical examples of the dissertation as scenes: the rest of a broken rotor (Fig. 18), an oscillator that
   loses mass and is damped (Fig. 21), Examples 1 and 2, Van der Pol's oscillator (Figs 26 to 29), Laval's rotor
   (Fig. 30), two bodies and a spring (Fig. 32).

     (m x')' + k x |x|^(alpha-1) = all other forces, where mass that joins or leaves has no velocity */
#include "stage.h"
#include "stator.h"

static inline int oscillator(stage *s, double m0, double mass_rate, double alpha, double x0)
{
    int body;
    stage_clear(s, 100);
    body = stage_body(s, vm_scene_body_line(REAL(m0), REAL(x0), 0));
    stage_effect(s, vm_effect_mass(body, VM_MASS_OF_T, REAL(mass_rate), 0, 1));
    stage_effect(s, vm_effect_spring(body, 0, VM_GROUND, 0, 1, REAL(alpha), 0));
    return body;
}

static inline void figure18(stage *s, double omega) /* (68) */
{
    const stator_data no_stator = {omega, 1e9};
    stator(s, &no_stator);
    s->scene.n_events = 0;
}

static inline void figure21(stage *s, double b) /* (355), corrected */
{
    const int body = oscillator(s, 1, -0.01, 4. / 3, 0.1);
    stage_effect(s, vm_effect_damper(body, 0, VM_GROUND, 0, REAL(0.01 * b)));
}

static inline void example1(stage *s) { oscillator(s, 1, 0.1, 3, 1); } /* (398) */

static inline vm_mass_law_values squared(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_real c = REAL(0.1), root = 1 + c * t;
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)x;
    (void)v;
    (void)ctx;
    now.mass = root * root;
    now.by_t = 2 * c * root;
    return now;
}

static inline void example2(stage *s) /* (402) */
{
    const int body = oscillator(s, 1, 0, 1.5, 1);
    s->effects[0] = vm_effect_mass_law(body, squared, NULL, stage_vec(0, 0, 0), 1);
}

static inline void figure27(stage *s, double m0, double x0) /* (440) */
{
    const int body = oscillator(s, m0, 0.01 * m0, 5. / 3, x0);
    stage_effect(s, vm_effect_van_der_pol(body, 0, REAL(0.01), REAL(0.01)));
}

static inline void figure30(stage *s) /* (514) to (516) */
{
    const double r = sqrt(0.5);
    int rotor;
    stage_clear(s, 500);
    rotor = stage_body(s, vm_scene_body_point(1, stage_vec(r, r, 0), stage_vec(-r, r, 0)));
    stage_effect(s, vm_effect_mass(rotor, VM_MASS_OF_T, REAL(0.01), 0, 1));
    stage_effect(s, vm_effect_shaft(rotor, 1, 3));
}

static inline void figure32(stage *s) /* (530) to (532) */
{
    int x, y;
    x = oscillator(s, 1, 0.01, 3, 1);
    y = stage_body(s, vm_scene_body_line(1, 3, 0));
    s->effects[1] = vm_effect_mass(y, VM_MASS_OF_T, REAL(0.01), 0, 1);
    stage_effect(s, vm_effect_spring(x, 0, y, 0, 1, 3, 0));
}
