/* A spinning body gathers dust, which is the opposite of jet damping: dust that is at rest before it lands brings no
   angular momentum, but the inertia of the body grows. In the first part dust settles on both ends of the body. Let C
   and A be the axial and the transverse moment of inertia, and C0 and A0 their values at the start. Then the spin falls
   as C0/C and the wobble as A0/A, and the angle between the axis and the angular momentum stays constant. The program
   computes spin and wobble by streams and by this closed form. In the second part the body flies sideways through the
   dust, and only one end catches dust. The dust turns the body by the moment -SS2 x v M', where SS2 is the vector from
   the mass centre to the dust that lands, v the velocity of the body and M' the rate of its mass. (168) and (169) of
   the dissertation have this moment with the other sign.

   usage: dust [file.csv]
   The columns of the file are t (min), spin and wobble by streams, spin and wobble by the closed form, the kinetic
   energy divided by its first value; then the angular velocity of the second body, corrected and as printed */
#include <stdio.h>
#include <string.h>
#include "../varmass.h"

static const double mass = 10, transverse = 2, axial = 1, half_length = 0.6, radius = 0.3,
                    gathered = 0.02; /* kg/s */
static const double end = 600;
enum { SAMPLES = 121 };

typedef struct sample {
    double spin, wobble, closed_spin, closed_wobble, energy, turning, printed;
} sample;

static vm_stream settling(double rate, double z)
{
    vm_stream s;
    memset(&s, 0, sizeof s);
    s.rate = rate;
    s.motion = VM_AT_REST;
    s.at.z = z; /* a layer on the whole end */
    s.gyration.xx = s.gyration.yy = radius * radius / 4;
    s.gyration.zz = radius * radius / 2;
    return s;
}

static vm_body start(void)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = mass;
    b.inertia.xx = b.inertia.yy = transverse;
    b.inertia.zz = axial;
    b.q.w = 1;
    return b;
}

/* Dust settles on both ends: A' = m' (r^2/4 + l^2) and C' = m' r^2/2, while the angular momentum I omega is
   constant */
static int spin_down(sample *samples)
{
    vm_stream ends[2];
    vm_flow flow;
    vm_body b = start();
    vm_vec3 before, after;
    double y[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)], energy, worst = 0;
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    int i;
    ends[0] = settling(gathered / 2, half_length);
    ends[1] = settling(gathered / 2, -half_length);
    memset(&flow, 0, sizeof flow);
    flow.n = 2;
    flow.streams = ends;
    b.omega.x = 0.2;
    b.omega.z = 2;
    before = vm_angular_momentum(&b, b.r);
    energy = vm_kinetic_energy(&b);
    options.rtol = 1e-10;
    if (vm_flow_start(&flow, &b, y) || rk45_init(&s, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, &options, work) < 0) return 1;
    for (i = 0; i < SAMPLES; i++) {
        sample *p = samples + i;
        const double t = end * i / (SAMPLES - 1), dust = gathered * t;
        vmi_mat3 turn;
        vm_vec3 omega;
        if (rk45_solve(&s, t) < 0 || vm_flow_body(&flow, VM_FLOW_STATES, s.y, &b)) return 1;
        turn = vmi_rotation(b.q);
        omega = vmi_times_transposed(&turn, b.omega);
        p->spin = omega.z;
        p->wobble = sqrt(omega.x * omega.x + omega.y * omega.y);
        p->closed_spin = vm_velocity_by_momentum(2, axial, axial + dust * radius * radius / 2, 0, 0);
        p->closed_wobble = vm_velocity_by_momentum(
            0.2, transverse, transverse + dust * (radius * radius / 4 + half_length * half_length), 0, 0);
        p->energy = vm_kinetic_energy(&b) / energy;
        if (fabs(p->spin - p->closed_spin) > worst) worst = fabs(p->spin - p->closed_spin);
        if (fabs(p->wobble - p->closed_wobble) > worst) worst = fabs(p->wobble - p->closed_wobble);
    }
    after = vm_angular_momentum(&b, b.r);
    printf("Dust on both ends: after %g min %g kg of %g; spin %.6f (closed form %.6f), wobble %.6f (%.6f) rad/s\n",
           end / 60, b.mass, mass, samples[SAMPLES - 1].spin, samples[SAMPLES - 1].closed_spin,
           samples[SAMPLES - 1].wobble, samples[SAMPLES - 1].closed_wobble);
    printf("  largest difference %.1g rad/s; angular momentum changed by %.1g of %.4g; energy left %.3f\n", worst,
           sqrt(vm_dot(vm_sub(after, before), vm_sub(after, before))), before.z, samples[SAMPLES - 1].energy);
    return 0;
}

/* Computes (168) as printed for a body that turns about x, I omega' = +SS2 x v M' - I' omega, in addition to
   vm_flow_rhs, whose mass, inertia, mass centre and attitude are used. */
static int with_printed(double t, const double *y, double *dydt, void *ctx)
{
    const vm_flow *flow = (const vm_flow *)ctx;
    const int status = vm_flow_rhs(t, y, dydt, ctx);
    vm_quat q;
    vmi_mat3 turn;
    vm_vec3 arm;
    q.w = y[VM_Y_Q];
    q.x = y[VM_Y_Q + 1];
    q.y = y[VM_Y_Q + 2];
    q.z = y[VM_Y_Q + 3];
    turn = vmi_rotation(q);
    arm = vm_scale(flow->streams[0].at.z - y[VM_Y_CENTRE + 2], turn.z);
    dydt[VM_FLOW_STATES] = (arm.y * y[VM_Y_P + 2] - arm.z * y[VM_Y_P + 1]) / y[VM_Y_MASS] *
                   flow->streams[0].rate; /* (I omega)' */
    return status;
}

/* The body flies along y at 2 m/s through dust that one end catches */
static int turned(sample *samples)
{
    vm_stream front = settling(gathered / 10, half_length);
    vm_flow flow;
    vm_body b = start();
    double y[VM_FLOW_STATES + 1] = {0}, work[RK45_WORK(VM_FLOW_STATES + 1)], expected;
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    int i;
    memset(&flow, 0, sizeof flow);
    flow.n = 1;
    flow.streams = &front;
    b.v.y = 2;
    options.rtol = 1e-10;
    if (vm_flow_start(&flow, &b, y) || rk45_init(&s, with_printed, &flow, VM_FLOW_STATES + 1, 0, y, &options, work) < 0)
        return 1;
    for (i = 0; i < SAMPLES; i++) {
        if (rk45_solve(&s, end / 10 * i / (SAMPLES - 1)) < 0 || vm_flow_body(&flow, VM_FLOW_STATES, s.y, &b)) return 1;
        samples[i].turning = b.omega.x;
        samples[i].printed = s.y[VM_FLOW_STATES] / s.y[VM_Y_INERTIA];
    }
    expected = vm_velocity_by_momentum(2, mass, b.mass, 0, 0);
    printf("Dust on one end, in flight: after %g s the speed is %.9f (Levi-Civita %.9f) m/s, turning at %.6f "
           "rad/s; as printed "
           "%.6f\n",
           end / 10, b.v.y, expected, b.omega.x, samples[SAMPLES - 1].printed);
    return 0;
}

int main(int argc, char **argv)
{
    static sample samples[SAMPLES];
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    int i;
    puts("A spinning body gathers dust");
    if (spin_down(samples) || turned(samples)) return 1;
    for (i = 0; csv && i < SAMPLES; i++)
        fprintf(csv, "%.5f,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", end / 60 * i / (SAMPLES - 1), samples[i].spin,
                samples[i].wobble, samples[i].closed_spin, samples[i].closed_wobble, samples[i].energy,
                samples[i].turning, samples[i].printed);
    if (csv) fclose(csv);
    return 0;
}
