/* A rocket whose nozzle is 0.1 mm off its axis and whose tank drains. The propellant is taken from the falling surface
   in the tank and flows to the nozzle. Therefore mass, mass centre and inertia follow from the streams alone, and jet
   damping follows from the momentum of the flowing propellant. The rocket flies once without spin, and once with one
   turn per second. Without spin, the tilt is also computed by (155) and (157) as printed, with I'(Omega_2 - Omega) =
   0, and without any jet damping.

   usage: rocket [file.csv]
   The columns of the file are t; then for the rocket without spin the tilt (deg) by vm_flow_rhs, as printed and
   without damping, and the path x, z (km); then tilt, x and z with spin */
#include <stdio.h>
#include <string.h>
#include "../varmass.h"

/* SI units. The moments of inertia are those of the dry rocket about its own mass centre, which is the reference
   point. */
static const double dry_mass = 80, dry_transverse = 60, dry_axial = 1.5, gravity = 9.81;
static const double tank_radius = 0.2, tank_bottom = -1.2, propellant = 120, density = 955;
static const double nozzle = -1.8, nozzle_radius = 0.05, off_axis = 1e-4, exhaust = 2200, burning = 12;
static const double pi = 3.14159265358979323846;

enum { PRINTED = VM_FLOW_BALANCED_STATES, UNDAMPED = PRINTED + 2, STATES = UNDAMPED + 2 };

typedef struct rocket {
    vm_flow flow;
    vm_stream jet;
    vm_store surface;
} rocket;

static double level(double contents) { return tank_bottom + contents / (density * pi * tank_radius * tank_radius); }

/* Is called before each evaluation: sets the weight and the place of the surface */
static int fly(double t, const double *y, vm_flow *flow)
{
    rocket *r = (rocket *)flow->ctx;
    (void)t;
    flow->force.z = -gravity * y[VM_Y_MASS];
    r->surface.at.z = level(y[VM_Y_MASS] - dry_mass);
    return 0;
}

static void burnt_out(double t, double *y, void *flow)
{
    (void)t;
    (void)y;
    ((vm_flow *)flow)->streams[0].rate = 0;
}

/* Computes I theta'' = moment of the thrust - mu D theta', with D = l_e^2 as printed or D = 0, in addition to the
   states of vm_flow_rhs, whose inertia I is used */
static int with_others(double t, const double *y, double *dydt, void *ctx)
{
    const vm_flow *flow = (const vm_flow *)ctx;
    const double rate = -flow->streams[0].rate, lever = nozzle - y[VM_Y_CENTRE + 2], inertia = y[VM_Y_INERTIA];
    const int status = vm_flow_balanced_rhs(t, y, dydt, ctx);
    int k;
    for (k = PRINTED; k <= UNDAMPED; k += 2) {
        dydt[k] = y[k + 1];
        dydt[k + 1] = rate * (exhaust * off_axis - (k == PRINTED ? lever * lever : 0) * y[k + 1]) / inertia;
    }
    return status;
}

/* Mass, mass centre and inertia of the rocket with `contents` kg of propellant, computed from its shape */
static vm_body assemble(double contents, double *centre)
{
    const double length = level(contents) - tank_bottom, middle = tank_bottom + length / 2;
    const double transverse = contents * (tank_radius * tank_radius / 4 + length * length / 12);
    vm_body b = {0, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    b.mass = dry_mass + contents;
    *centre = contents * middle / b.mass;
    b.inertia.xx = dry_transverse + transverse + dry_mass * contents / b.mass * middle * middle;
    b.inertia.yy = b.inertia.xx;
    b.inertia.zz = dry_axial + contents * tank_radius * tank_radius / 2;
    return b;
}

static double tilt(const vm_quat q)
{
    return 360 / pi * atan2(sqrt(q.x * q.x + q.y * q.y), sqrt(q.w * q.w + q.z * q.z));
}

typedef struct sample {
    double tilt, printed, undamped, x, z;
} sample;

enum { SAMPLES = 201 };
static const double end = 20;

/* Prepares the rocket with a full tank: its jet, the surface from which the propellant is taken, and the vm_flow of
   both */
static void fill_tank(rocket *r, double centre)
{
    memset(r, 0, sizeof *r);
    r->jet.rate = -burning;
    r->jet.velocity.z = -exhaust;
    r->jet.at.x = off_axis;
    r->jet.at.z = nozzle;
    r->jet.from = &r->surface;
    r->jet.gyration.xx = r->jet.gyration.yy = nozzle_radius * nozzle_radius / 4;
    r->jet.gyration.zz = nozzle_radius * nozzle_radius / 2;
    r->surface.gyration.xx = r->surface.gyration.yy = tank_radius * tank_radius / 4;
    r->surface.gyration.zz = tank_radius * tank_radius / 2;
    r->surface.at.z = level(propellant);
    r->flow.n = 1;
    r->flow.streams = &r->jet;
    r->flow.update = fly;
    r->flow.ctx = r;
    r->flow.centre.z = centre;
    r->flow.least_mass = dry_mass;
}

/* The event that happens when the tank is empty */
static ode_event run_dry(rocket *r)
{
    ode_event dry;
    memset(&dry, 0, sizeof dry);
    dry.g = vm_flow_mass_left;
    dry.ctx = &r->flow;
    dry.direction = -1;
    dry.action = ODE_RESTART;
    dry.change = burnt_out;
    return dry;
}

/* Compares mass, mass centre and inertia at the end with those of the empty rocket that are computed from its shape */
static void print_empty(const vm_body *b, const double *y)
{
    double centre;
    const vm_body empty = assemble(0, &centre);
    printf("  empty, by the streams less by its shape: mass %.1g kg, centre %.1g m, inertia %.1g, %.1g kg m^2\n",
           b->mass - empty.mass, y[VM_Y_CENTRE + 2] - centre, b->inertia.xx - empty.inertia.xx,
           b->inertia.zz - empty.inertia.zz);
}

/* Prints momentum and angular momentum about the origin: their values at the launch, less those of the rocket and of
   all expelled mass */
static void print_balance(const vm_body *start, vm_vec3 angular, const vm_body *b, const double *y)
{
    const vm_vec3 origin = {0, 0, 0};
    const vm_vec3 now = vm_add(vm_momentum(b), vmi_get3(y + VM_Y_BALANCE));
    const vm_vec3 angular_now = vm_add(vm_angular_momentum(b, origin), vmi_get3(y + VM_Y_BALANCE + 3));
    printf("  balance with all that was shed: %.1g N s of %.2g, %.1g N m s of %.2g\n",
           vmi_norm1(vm_sub(vm_momentum(start), now)), propellant * exhaust, vmi_norm1(vm_sub(angular, angular_now)),
           propellant * exhaust * sqrt(vm_dot(b->r, b->r)));
}

static void print_tilts(const sample *samples)
{
    int t;
    for (t = 2; t <= 10; t += 2) {
        const sample *p = samples + (SAMPLES - 1) / 20 * t;
        printf("  t = %2d s: tilt %8.3f degrees, as printed %8.3f, without jet damping %8.3f\n", t, p->tilt, p->printed,
               p->undamped);
    }
}

static int launch(double spin, sample *samples)
{
    rocket r;
    double y[STATES] = {0}, work[RK45_WORK(STATES)], centre;
    vm_body start = assemble(propellant, &centre), b;
    ode_event dry = run_dry(&r);
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    int i;
    fill_tank(&r, centre);
    start.omega.z = spin;
    options.rtol = 1e-11;
    options.events = &dry;
    options.n_events = 1;
    if (vm_flow_start(&r.flow, &start, y)) return 1;
    if (rk45_init(&s, with_others, &r.flow, STATES, 0, y, &options, work) < 0) return 1;
    b = start;
    for (i = 0; i < SAMPLES; i++) {
        if (rk45_solve(&s, end * i / (SAMPLES - 1)) < 0 || vm_flow_body(&r.flow, VM_FLOW_STATES, s.y, &b)) return 1;
        samples[i].tilt = tilt(b.q);
        samples[i].x = b.r.x;
        samples[i].z = b.r.z;
        samples[i].printed = s.y[PRINTED] * 180 / pi;
        samples[i].undamped = s.y[UNDAMPED] * 180 / pi;
    }
    printf("spin %4.2f turns/s: burnt out at %.12g s; after %g s %.4g km high, %.3g km aside, tilted by %.4g "
           "degrees\n",
           spin / (2 * pi), dry.t, end, b.r.z / 1e3, sqrt(b.r.x * b.r.x + b.r.y * b.r.y) / 1e3, tilt(b.q));
    print_empty(&b, s.y);
    print_balance(&start, vmi_get3(y + VM_Y_H), &b, s.y);
    if (spin == 0) print_tilts(samples);
    return 0;
}

int main(int argc, char **argv)
{
    static sample still[SAMPLES], spinning[SAMPLES];
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    int i;
    puts("A rocket with its nozzle 0.1 mm off the axis and a tank that drains");
    if (launch(0, still) || launch(2 * pi, spinning)) return 1;
    for (i = 0; csv && i < SAMPLES; i++)
        fprintf(csv, "%.3f,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", end * i / (SAMPLES - 1), still[i].tilt,
                still[i].printed, still[i].undamped, still[i].x / 1e3, still[i].z / 1e3, spinning[i].tilt,
                spinning[i].x / 1e3, spinning[i].z / 1e3);
    if (csv) fclose(csv);
    return 0;
}
