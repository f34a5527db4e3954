/* A band is wound up on a drum (chapter 5.2). It comes with the speed v, and the drum turns freely. The radius r grows
   by h at each full turn (layers), or continuously (spiral).

       v --> ____________        (J0 + J(phi)) omega' = mu r (v - r omega) omega,  mu = rho b h r
     J omega = J0 omega0 + rho b h v (integral of r^2 over phi): the drum receives the angular momentum of the band */
#include "stage.h"

static inline vm_band reel_band(int by_layer, double speed, double reactive)
{
    vm_band b;
    b.radius = REAL(0.2);
    b.thickness = REAL(0.01);
    b.width = REAL(0.5);
    b.density = 800;
    b.speed = REAL(speed);
    b.reactive = REAL(reactive);
    b.by_layer = by_layer;
    return b;
}

static inline void reel(stage *s, int by_layer, double turned)
{
    const vm_band band = reel_band(by_layer, 1.5, 1);
    int drum;
    stage_clear(s, 20);
    drum = stage_body(s, vm_scene_body_axle(REAL(0.8), 0, 9));
    stage_effect(s, vm_effect_band(drum, &band));
    stage_event(s, vm_then_stop(vm_event_position(drum, 0, REAL(turned), 1)));
}
