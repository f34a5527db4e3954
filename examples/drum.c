/* A band winds up on a drum (Fig. 20): the equations that the dissertation prints in chapter 5.2, compared with the
   right ones.

   phi is the angle of the drum. For a rigid shaft the program computes phi(t) by (197)-(206) and by integration of
   (194). The number e is mu v R - D, with the mass mu of the band per radian, its speed v, the radius R of the drum and
   the damping D: the drum is driven for e > 0, coasts for e = 0 and comes to rest for e < 0. For an elastic shaft the
   program computes the motion of the mass centre by the exact equations and by (191) as printed. The program also
   computes the deflection as a function of the angle by (224), as printed and corrected, and by integration of (211).

   usage: drum [file.csv]
   The file has three tables. The first table has the columns phi, then for each e phi'(phi), t(phi), and t(phi) by
   (199) as printed. The second table has the columns t, then the position x_S1, y_S1 of the mass centre, exact and as
   printed. The third table has the columns phi, then the deflection y by integration, by (224) corrected, and by (224)
   as printed. */
#include <stdio.h>
#include <string.h>
#include "../varmass.h"

static const double drives[] = {-0.4, 0, 0.3, 0.6, 0.9};
enum { DRIVES = sizeof drives / sizeof *drives };

/* A drum with J0 = 1, j = 0.2, Omega_b = 3, whose band moves at the speed of the rim. The damping D follows from e =
   mu v R - D. */
static vm_drum rigid(double e)
{
    vm_drum d = {1, 1, 1, 0.2, 3, 0, 1, 3};
    d.damping = 0.6 - e;
    return d;
}

static int rigid_rhs(double t, const double *y, double *dydt, void *ctx) /* (194), y = {phi, phi'} */
{
    const vm_drum *d = (const vm_drum *)ctx;
    const double j = d->band * d->radius * d->radius;
    (void)t;
    dydt[0] = y[1];
    dydt[1] = (-d->damping * y[1] - j * y[1] * y[1] + d->band * y[1] * d->speed * d->radius) /
              (d->inertia + j * y[0]);
    return 0;
}

/* The equations (191) as printed; y = {x_S1, y_S1, phi, and the rates of these three} */
static int printed_rhs(double t, const double *y, double *dydt, void *ctx)
{
    const vm_drum *d = (const vm_drum *)ctx;
    const double R = d->radius, mu = d->band, c = d->stiffness, flow = mu * y[5], half = y[2] / 2;
    double slope, offset, cx, cy;
    vm_drum_geometry g;
    int status = vm_drum_at(d, y[2], &g);
    (void)t;
    if (status) return status;
    offset = g.offset;
    cx = offset * cos(half);
    cy = offset * sin(half);
    slope = mu * R * R + mu * offset * offset - 2 * mu * R * offset * cos(half); /* dJ_S1/dphi */
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = (-c * (y[0] - cx) - flow * y[3]) / g.mass;
    dydt[4] = (-c * (y[1] - cy) + flow * (d->speed - y[4])) / g.mass;
    dydt[5] = -slope * y[5] * y[5] - d->damping * y[5] + c * (y[0] * cy - y[1] * cx);
    dydt[5] = (dydt[5] + flow * ((d->speed - y[4]) * (R - cx) - y[3] * cy)) / g.inertia;
    return 0;
}

/* The time t at which the angle is phi by (199) as printed, r + D/(j Omega_b) ln r = f1 */
static double printed_time(const vm_drum *d, double phi)
{
    const double j = d->band * d->radius * d->radius, e = d->band * d->speed * d->radius - d->damping;
    const double r = 1 + e * phi / (d->inertia * d->omega);
    return (r + d->damping / (j * d->omega) * log(r) - 1) * d->inertia * j * d->omega / (e * e);
}

static int advance(ode_rhs f, void *ctx, int n, double from, double to, double *y)
{
    double work[RK87_WORK(VM_DRUM_STATES)];
    rk87_options options;
    rk87 s;
    int status;
    memset(&options, 0, sizeof options);
    options.rtol = 1e-12;
    options.atol = 1e-15;
    status = rk87_init(&s, f, ctx, n, from, y, &options, work);
    if (status >= 0) status = rk87_solve(&s, to);
    if (status >= 0) memcpy(y, s.y, (size_t)n * sizeof *y);
    return status;
}

/* Prints a number, or the word "none" if x is infinite or NaN */
static void column(double x)
{
    if (x - x == 0) printf("%-18.15g ", x);
    else printf("%-18s ", "none");
}

static void rigid_shaft(FILE *file)
{
    double phi;
    int i;
    puts("Rigid shaft, J0 = 1, j = 0.2, Omega_b = 3: phi after 2 s");
    puts("    e    (194) integrated   vm_drum_angle      by Lambert W       (203) as printed   stops at");
    for (i = 0; i < DRIVES; i++) {
        vm_drum d = rigid(drives[i]);
        const double k1 = d.damping / 0.6, f1 = 1 + drives[i] * drives[i] * 2 / 0.6;
        const double w = k1 > 0 ? vm_wright_omega(-log(k1) - f1 / k1) : vm_lambert_w0(exp(-f1 / k1) / k1);
        double y[2] = {0, 3};
        if (advance(rigid_rhs, &d, 2, 0, 2, y) < 0) puts("integration failed");
        printf("%6.1f  ", drives[i]);
        column(y[0]);
        column(vm_drum_angle(&d, 2));
        column(vm_drum_angle_lambert(&d, 2));
        column((-k1 * w - 1) * 3 / drives[i]);
        column(drives[i] < 0 ? vm_drum_stop(&d) : VM_INFINITY);
        puts(i == 1 ? "(e is 5.6e-17, rounded)" : "");
    }
    for (phi = 0; file && phi < 7.4995; phi += phi < 7.49 ? 0.01 : 0.001) {
        fprintf(file, "%g", phi);
        for (i = 0; i < DRIVES; i++) {
            const vm_drum d = rigid(drives[i]);
            fprintf(file, ",%.10g,%.10g,%.10g", vm_drum_rate(&d, phi), vm_drum_time(&d, phi),
                    printed_time(&d, phi));
        }
        fprintf(file, "\n");
    }
}

static void elastic_shaft(FILE *file)
{
    vm_drum d = {0.3, 2, 0.08, 0.45, 0.9, 0.03, 200, 3};
    double y[6] = {0.02, -0.015, 0, 0.1, 0.05, 3}, z[6], worst = 0, t;
    memcpy(z, y, sizeof z);
    z[3] += 3 * 0.45 * 0.3 / 2; /* at first S1 is at the place of S, but its velocity relative to S is phi' mu R/M0 */
    for (t = 0; t < 2.5; t += 0.01) {
        const double M = d.mass + d.band * y[2], q = d.band * d.radius;
        const double x1 = y[0] + q * sin(y[2]) / M, y1 = y[1] + q * (1 - cos(y[2])) / M;
        worst = fmax(worst, hypot(x1 - z[0], y1 - z[1]));
        if (file) fprintf(file, "%g,%.10g,%.10g,%.10g,%.10g\n", t, x1, y1, z[0], z[1]);
        if (advance(vm_drum_rhs, &d, 6, t, t + 0.01, y) < 0 || advance(printed_rhs, &d, 6, t, t + 0.01, z) < 0)
            puts("integration failed");
    }
    printf("Elastic shaft, R = 0.3, M0 = 2, mu = 0.45: (191) as printed is up to %.1f mm off in S1 within 2.5 s\n",
           1e3 * worst);
}

static void deflection(FILE *file)
{
    vm_drum d = {0.3, 20, 0.9, 0.2, 0.9, 0.05, 2000, 3};
    const double a0 = 0.01, alpha0 = 0.3, h = 1e-4, k = 10. / 3, R = 0.3, mu_M0 = 0.01, j_J0 = 0.02;
    const double D_J0 = 0.05 / 2.7, delta = (2 * mu_M0 - j_J0 - D_J0) / 2, A = 3 * mu_M0 - 2 * j_J0 - D_J0;
    double z[4] = {0, 0, 0, 0}, phi, worst = 0, worst_printed = 0;
    vm_drum_shaft s;
    if (vm_drum_shaft_init(&s, &d)) return;
    z[1] = vm_drum_deflection(&s, 0, a0, alpha0, s.shift);
    z[3] = (vm_drum_deflection(&s, h, a0, alpha0, s.shift) - vm_drum_deflection(&s, -h, a0, alpha0, s.shift)) /
           (2 * h);
    for (phi = 0; phi < 6.28; phi += 0.02) {
        const double m = sqrt(1 - A * phi), closed = vm_drum_deflection(&s, phi, a0, alpha0, s.shift);
        const double printed = a0 / sqrt(m) * exp(-delta * phi) * cos(k * m + alpha0) + R / (k * k) * mu_M0;
        worst = fmax(worst, fabs(closed - z[1]));
        worst_printed = fmax(worst_printed, fabs(printed - z[1]));
        if (file) fprintf(file, "%g,%.10g,%.10g,%.10g\n", phi, z[1], closed, printed);
        if (advance(vm_drum_rhs_angle, &d, 4, phi, phi + 0.02, z) < 0) puts("integration failed");
    }
    printf("(224) over the first layer, amplitude 10 mm: within %.3f mm, as printed %.1f mm\n", 1e3 * worst,
           1e3 * worst_printed);
}

int main(int argc, char **argv)
{
    FILE *file = argc > 1 ? fopen(argv[1], "w") : NULL;
    if (argc > 1 && !file) {
        perror(argv[1]);
        return 1;
    }
    rigid_shaft(file);
    if (file) fputs("\n\n", file);
    elastic_shaft(file);
    if (file) fputs("\n\n", file);
    deflection(file);
    return file && fclose(file) ? 1 : 0;
}
