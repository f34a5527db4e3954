/* A vessel is tipped and pours: a hook turns it about its lip (Fig. 1), or a motor turns it about a trunnion (Figs 2,
   3). The vessel is a rectangular ladle a x h x b with the tilt phi. The surface of the metal is level with the lip,
   and L(phi) is the length of this surface. If the vessel turns about the lip, dI/dphi = -rho b L^4/4; metal that
   leaves at the lip takes no angular momentum away.

     lip A ___________        from A, x along the vessel's top and y downwards are negative
          |~~~~~~~~~~|  h     P: the trunnion, (px, py) from the lip
          |___a______| B      B: the hook pulls here, vertically */
#include "stage.h"

static const double vessel_a = 1.2, vessel_h = 1.5, vessel_rho_b = 7000, vessel_mass = 3000, vessel_x = -0.6,
                    vessel_y = -0.8, trunnion_x = -0.6, trunnion_y = -0.7;

typedef struct metal {
    double m, Sx, Sy, inertia, L; /* mass, static moments and inertia about the lip, length of the surface */
} metal;

static inline metal metal_at(double phi)
{
    const double a = vessel_a, h = vessel_h, rb = vessel_rho_b, k = tan(phi);
    metal f;
    if (phi <= atan(h / a)) {
        f.L = a / cos(phi);
        f.m = rb * (a * h - a * a * k / 2);
        f.Sx = -rb * (a * a * h / 2 - a * a * a * k / 3);
        f.Sy = -rb * (a * h * h / 2 - a * a * a * k * k / 6);
        f.inertia = rb * (a * h * (a * a + h * h) / 3 - a * a * a * a / 4 * (k + k * k * k / 3));
    } else {
        f.L = h / sin(phi);
        f.m = rb * h * h / k / 2;
        f.Sx = -rb * h * h * h / (k * k) / 6;
        f.Sy = -rb * h * h * h / k / 3;
        f.inertia = rb * h * h * h * h / 4 * (1 / k + 1 / (k * k * k) / 3);
    }
    return f;
}

/* The torque of the weight about the point (px, py) of the vessel */
static inline double vessel_weight(double phi, double px, double py)
{
    const metal f = metal_at(phi);
    const double x = f.Sx - f.m * px + vessel_mass * (vessel_x - px);
    const double y = f.Sy - f.m * py + vessel_mass * (vessel_y - py);
    return gravity * (x * cos(phi) + y * sin(phi));
}

/* ---- By a hook about the lip: with the force F_B(t), tan phi = t/4, the vessel pours uniformly ---- */

static inline vm_mass_law_values vessel_inertia(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const metal f = metal_at((double)phi);
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    (void)omega;
    (void)ctx;
    now.mass = REAL(5000 + f.inertia);
    now.by_x = REAL(-vessel_rho_b * f.L * f.L * f.L * f.L / 4);
    return now;
}

/* The force of the hook that makes phi follow tan phi = t/4, or cot phi = (10 - t) (0.16 a^2/h^2) when the surface has
   reached the bottom */
static inline double hook_force(double t)
{
    const double q = 1260, a = vessel_a, h = vessel_h, rb = vessel_rho_b, t1 = rb * a * h / (2 * q);
    const double phi = t <= t1 ? atan(2 * q * t / (rb * a * a)) : atan(rb * h * h / (2 * (rb * a * h - q * t)));
    const metal f = metal_at(phi);
    const double rate = 2 * q / (rb * f.L * f.L),
                 slope = t <= t1 ? a * sin(phi) / (cos(phi) * cos(phi)) : -h * cos(phi) / (sin(phi) * sin(phi));
    const double turning = -2 * rate * rate * slope / f.L; /* phi'' */
    const double L4 = f.L * f.L * f.L * f.L;
    return ((5000 + f.inertia) * turning - vessel_weight(phi, 0, 0) - rb * L4 / 4 * rate * rate) /
           (a * cos(phi) + h * sin(phi));
}

static inline vm_real hook_torque(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const double arm = vessel_a * cos((double)phi) + vessel_h * sin((double)phi);
    (void)omega;
    (void)ctx;
    return REAL(vessel_weight((double)phi, 0, 0) + hook_force((double)t) * arm);
}

static inline void vessel_on_hook(stage *s)
{
    int body;
    /* After 5 s the surface is at the bottom, and this tipping is unstable: errors grow by the factor 1e6. */
    stage_clear(s, 5);
    body = stage_body(s, vm_scene_body_axle(5000, 0, REAL(0.25)));
    stage_effect(s, vm_effect_mass_law(body, vessel_inertia, NULL, stage_vec(0, 0, 0), 1));
    stage_effect(s, vm_effect_force(body, 0, hook_torque, NULL));
}

/* The tilt and its rate at time t for the constant rate of pouring, 1260 kg/s */
static inline double pouring_tilt(double t, double *rate)
{
    const double q = 1260, a = vessel_a, h = vessel_h, rb = vessel_rho_b, t1 = rb * a * h / (2 * q);
    const double phi = t <= t1 ? atan(2 * q * t / (rb * a * a)) : atan2(rb * h * h, 2 * (rb * a * h - q * t));
    const metal f = metal_at(phi);
    *rate = 2 * q / (rb * f.L * f.L);
    return phi;
}

/* The hook regulates its velocity: it adds 2e5 N m for each rad/s by which the vessel turns too slowly. */
static inline vm_real regulated_torque(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    double wanted;
    pouring_tilt((double)t, &wanted);
    return hook_torque(t, phi, omega, ctx) + REAL(2e5 * (wanted - (double)omega));
}

/* The motion of Fig. 1 until the vessel is empty after 10 s. With the regulated torque the tipping is stable after
   5 s, too. */
static inline void vessel_on_regulated_hook(stage *s)
{
    int body;
    stage_clear(s, 10);
    body = stage_body(s, vm_scene_body_axle(5000, 0, REAL(0.25)));
    stage_effect(s, vm_effect_mass_law(body, vessel_inertia, NULL, stage_vec(0, 0, 0), 1));
    stage_effect(s, vm_effect_force(body, 0, regulated_torque, NULL));
    stage_event(s, vm_then_user(vm_event_at(5), stage_kink, NULL));
}

/* ---- By a motor about the trunnion: T0 - kappa phi'; metal that leaves has the velocity of the lip ---- */

static inline vm_mass_law_values trunnion_inertia(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const metal f = metal_at((double)phi);
    const double px = trunnion_x, py = trunnion_y, pp = px * px + py * py, L = f.L;
    const double ep = -px * cos((double)phi) - py * sin((double)phi);
    vm_mass_law_values now = {0, 0, 0, 0};
    (void)t;
    (void)omega;
    (void)ctx;
    now.mass = REAL(2030 + f.inertia - 2 * (px * f.Sx + py * f.Sy) + pp * f.m);
    now.by_x = REAL(-vessel_rho_b * (L * L * L * L / 4 - L * L * L * ep * 2 / 3 + pp * L * L / 2));
    return now;
}

static inline vm_real trunnion_torque(vm_real t, vm_real phi, vm_real omega, void *ctx)
{
    const metal f = metal_at((double)phi);
    const double pp = trunnion_x * trunnion_x + trunnion_y * trunnion_y;
    const double poured = vessel_rho_b * f.L * f.L / 2 * (double)omega; /* kg/s */
    (void)t;
    (void)ctx;
    return REAL(vessel_weight((double)phi, trunnion_x, trunnion_y) - poured * pp * (double)omega);
}

static inline void vessel_by_motor(stage *s)
{
    int body;
    stage_clear(s, 10);
    body = stage_body(s, vm_scene_body_axle(2030, 0, 0));
    stage_effect(s, vm_effect_mass_law(body, trunnion_inertia, NULL, stage_vec(0, 0, 0), 1));
    stage_effect(s, vm_effect_motor(body, 0, 14000, 20000));
    stage_effect(s, vm_effect_force(body, 0, trunnion_torque, NULL));
    /* The surface reaches the bottom at the angle atan(h/a). */
    stage_event(s, vm_then_user(vm_event_position(body, 0, REAL(0.89605538457134395), 1), stage_kink, NULL));
    stage_event(s, vm_then_stop(vm_event_position(body, 0, REAL(1.4), 1)));
    stage_event(s, vm_then_stop(vm_event_velocity(body, 0, 0, -1))); /* the vessel stops: no more metal leaves */
}
