/* A rocket of two stages in space. Two motors, whose flow is a table and a law of time, empty their grains; the first one
   swivels for half a second. One event at the burn-out of the first motor does the whole staging. Drag acts at the
   centre of pressure, and after the apogee also at a parachute at the nose; both forces are computed by an effect of
   this program. At the end the empty second stage remains: inertia 2, 60, 60 kg m^2, mass centre 3.125 m before that
   of the start. */
#include "stage.h"

/* flow: kg/s; dry: kg, the mass of the rocket when the grain has burnt; swivel: rad, inclination of the jet until 0.5 s */
typedef struct motor { vm_supply grain; vm_law flow; double dry, swivel; vm_supply_left left; } motor;

static inline void two_stages_burn(vm_real t, const vm_real *y, vm_stream *nozzle, void *ctx)
{
    motor *m = (motor *)ctx;
    const double angle = t < REAL(0.5) ? m->swivel : 0;
    vm_real slope;
    vm_supply_at(&m->grain, y[13] - REAL(m->dry), &m->left); /* y[13]: the mass of the rocket */
    nozzle->from = &m->left.store;
    nozzle->velocity = stage_vec(-2400 * cos(angle), 0, -2400 * sin(angle));
    vm_law_at(&m->flow, t, &nozzle->rate, &slope);
}

/* Drag with the area c[1] m^2, which includes the drag coefficient. It acts c[0] m before the place of the mass centre
   at the start. */
static inline void two_stages_drag(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    const double *c = (const double *)e->ctx;
    vm_vec3 r, v;
    (void)t;
    vm_scene_point_at(scene, 0, stage_vec(c[0], 0, 0), y, &r, &v);
    v = vm_scale(-REAL(1.225 / 2 * exp(-(double)r.z / 8000) * c[1]) * vm_norm(v), v);
    vm_scene_push_at(scene, 0, stage_vec(c[0], 0, 0), y, v);
}

static inline void two_stages(stage *s)
{
    static const vm_real at[3] = {0, 10, 60}, flow[3] = {-15, -10, -10}; /* s, kg/s */
    static const vm_supply grains[2] = {{VM_GRAIN, {REAL(-2.9), 0, 0}, {1, 0, 0}, 3, REAL(0.2), REAL(0.06), 200},
                                        {VM_GRAIN, {REAL(1.15), 0, 0}, {1, 0, 0}, 1.5, REAL(0.15), REAL(0.05), 60}};
    static const vm_body rocket = {400, {REAL(10.11), REAL(1781.255), REAL(1781.255), 0, 0, 0}, {1, 0, -1, 0},
                                   {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; /* its x axis points up, along z */
    static const vm_body shell = {60, {3, 50, 50, 0, 0, 0}, {0, 0, 0, 0}, {REAL(-2.8), 0, 0}, {-1, 0, 0}, {0, 0, 0}};
    static double hull[2] = {-1, 0.05}, parachute[2] = {4, 20};
    static motor motors[2];
    static vm_stream nozzles[2];
    static vm_event staging[3];
    const vm_event burnt = vm_event_mass(0, 200, -1);
    int i;
    stage_clear(s, 40);
    for (i = 0; i < 2; i++) {
        motors[i].grain = grains[i];
        motors[i].flow = i ? vm_law_linear(-4, REAL(0.02)) : vm_law_table(3, at, flow);
        motors[i].dry = i ? 80 : 200;
        motors[i].swivel = i ? 0 : 0.002;
        nozzles[i].at = grains[i].at;
        stage_varying_stream(s, 0, nozzles + i, two_stages_burn, motors + i);
    }
    for (i = 4; i < 8; i++) s->effects[i].off = 1; /* the second motor */
    stage_body(s, vm_scene_body_growing_free(vm_scene_body_free(&rocket)));
    stage_body(s, vm_scene_body_absent(vm_scene_body_free(&shell)));
    stage_effect(s, vm_effect_custom(0, VM_GROUND, two_stages_drag, hull));
    i = stage_effect(s, vm_effect_custom(0, VM_GROUND, two_stages_drag, parachute));
    s->effects[i].off = 1;
    stage_effect(s, vm_effect_gravity(0, 2, REAL(-gravity)));
    staging[0] = vm_then_switch_range(burnt, 0, 4, 1);
    staging[1] = vm_then_separate(burnt, 0, 1, &shell, 1);
    staging[2] = vm_then_switch_range(burnt, 4, 4, 0);
    stage_event(s, vm_then_all(burnt, staging, 3));
    stage_event(s, vm_then_switch_range(vm_event_mass(0, 80, -1), 4, 4, 1)); /* burnt out */
    stage_event(s, vm_then_switch(vm_event_velocity(0, 2, 0, -1), i, 0));    /* apogee */
    stage_event(s, vm_then_stop(vm_event_position(0, 2, 0, -1)));            /* landing */
}
