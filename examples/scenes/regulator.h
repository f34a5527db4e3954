/* A centrifugal mercury regulator (Fig. 9), with mercury in a central tube and in four outer tubes. In the
   quasi-static model the moment of inertia is J = J0 + c omega^2, and (J omega)' = T. The motor is switched off when
   the mercury leaves a contact, and on when it touches the contact again. In the full model z is the rise of the
   mercury in the outer tubes: mu z'' + b z' + 2 rho g nA z = rho nA R^2 omega^2/2, ((J0 + rho nA R^2 z) omega)' = T */
#include "stage.h"

static const double mercury_nA = 13595 * 4 * 4e-4, mercury_R = 0.15, mercury_H = 0.12; /* rho n A, kg/m */

static inline double regulator_speed(double level) /* rad/s: omega for this level in the central tube */
{
    return sqrt((mercury_H - level) * 4 * gravity) / mercury_R;
}

static inline void regulator(stage *s)
{
    const double J0 = 0.05 + mercury_nA * mercury_R * mercury_R * mercury_H;
    const double c = mercury_nA * pow(mercury_R, 4) / (4 * gravity);
    int shaft, motor;
    stage_clear(s, 10);
    shaft = stage_body(s, vm_scene_body_axle(REAL(J0), 0, 0));
    stage_effect(s, vm_effect_mass(shaft, VM_MASS_OF_V2, REAL(c), 0, 1));
    stage_effect(s, vm_effect_motor(shaft, 0, REAL(-0.5), 0)); /* the load */
    motor = stage_effect(s, vm_effect_motor(shaft, 0, 2, 0));
    stage_event(s, vm_then_switch(vm_event_velocity(shaft, 0, REAL(regulator_speed(0.02)), 1), motor, 1));
    stage_event(s, vm_then_switch(vm_event_velocity(shaft, 0, REAL(regulator_speed(0.05)), -1), motor, 0));
}

/* The shaft is body 0, and the mercury is body 1. This effect depends on the motion of both bodies and loads both. */
static inline void mercury_coupling(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const vm_real w = y[e->v], k = REAL(mercury_nA * mercury_R * mercury_R);
    (void)t;
    (void)scene;
    e->load->mass += k * y[e->other_x];
    e->load->force[0] -= k * y[e->other_v] * w;
    e->other_load->force[0] += k * w * w / 2;
}

static inline void regulator_full(stage *s)
{
    int shaft, mercury;
    stage_clear(s, 10);
    shaft = stage_body(s, vm_scene_body_axle(REAL(0.05 + mercury_nA * mercury_R * mercury_R * mercury_H), 0, 0));
    mercury = stage_body(s, vm_scene_body_line(REAL(mercury_nA * (2 * mercury_H + mercury_R)), 0, 0));
    stage_effect(s, vm_effect_custom(shaft, mercury, mercury_coupling, NULL));
    stage_effect(s, vm_effect_motor(shaft, 0, REAL(1.5), 0));
    stage_effect(s, vm_effect_spring(mercury, 0, VM_GROUND, 0, REAL(2 * gravity * mercury_nA), 1, 0));
    stage_effect(s, vm_effect_damper(mercury, 0, VM_GROUND, 0, 2));
    stage_event(s, vm_then_stop(vm_event_position(mercury, 0, REAL(0.1), 1)));
}
