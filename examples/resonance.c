/* Harmonic excitation, which the dissertation leaves to future work (chapter 8), of the cubic oscillator
     m x'' + x^3 = -(r m' + b) x' + force cos(theta),  theta' = nu.
   Here m is the mass, b the damping, r the share of the reactive force, and nu the frequency of the force. The program
   first computes the amplitude-frequency curve with its unstable part. Direct integration while nu rises or falls shows
   that the amplitude jumps at the folds of this curve. Then the oscillator passes through the resonance while its mass
   grows: a strong force keeps the vibration near the resonance for some time, a weak force does not. At last the
   program computes the curve of the force 0.08 (cos theta + cos(2 theta)/2): the second harmonic of the force causes a
   second peak, where the oscillator vibrates twice in a period of the force.

   usage: resonance [prefix]
   The program writes blocks of rows to three files.
   prefix_curve.csv: nu, A, stable for each of the two branches; then nu, |x| at turning points, for nu up and down.
   prefix_passage.csv: for each force t, averaged A, backbone; then t, |x| at turning points.
   prefix_periodic.csv: for each peak nu, A, stable; then nu, A of the backbone; then nu, A while nu rises. */
#include <math.h>
#include <stdio.h>
#include "../varmass.h"
#include "csv.h"

typedef struct drifts {
    double nu0, nu_rate, mass_rate;
} drifts;

static vm_forced cubic(double b, double force, const drifts *d)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = 3;
    f.damping = b;
    f.reactive = 1;
    f.mass = vm_law_linear(1, d->mass_rate);
    f.stiffness = vm_law_linear(1, 0);
    f.frequency = vm_law_linear(d->nu0, d->nu_rate);
    f.force = vm_law_linear(force, 0);
    vm_forced_init(&f);
    return f;
}

/* Integrates the motion to t_end and writes its turning points as (nu or t, |x|). Returns the nu at which the
   amplitude last passed the value `level`. */
static double write_turning_points(vm_forced *f, const drifts *d, vm_real *y, double t_end, int by_nu, double level,
                                   FILE *csv)
{
    vm_real work[RK45_WORK(3)], buffer[3];
    vm_sample p;
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    double last = 0, passed = VM_NAN, nu;
    int status;
    options.rtol = options.atol = 1e-8;
    status = rk45_init(&s, vm_forced_rhs, f, 3, 0, y, &options, work);
    while (status >= 0 && s.t < t_end) {
        status = rk45_step(&s);
        if (vm_find_samples_of_step(&s, 0, 1, VM_TURNING_POINTS, buffer, 1, &p) < 1 || p.t > t_end) continue;
        nu = d->nu0 + d->nu_rate * p.t;
        if (csv) fprintf(csv, "%.6g,%.6g\n", by_nu ? nu : p.t, fabs(p.x));
        if (last > 0 && (last > level) != (fabs(p.x) > level)) passed = nu;
        last = fabs(p.x);
    }
    if (csv) fputs("\n\n", csv);
    return passed;
}

/* Writes one branch of the curve; fold[0] and fold[1] become the smallest and the largest frequency at which the
   stability of the branch changes */
static void write_branch(const vm_forced *f, int upper, double fold[2], FILE *csv)
{
    const double peak = vm_forced_peak(f, 0);
    vm_steady_state curve[2];
    int i, was_stable = -1;
    for (i = 1; i <= 2000; i++) {
        const int found = vm_forced_curve(f, 0, peak * i / 2000, curve);
        const vm_steady_state *s = found == 2 ? curve + upper : curve;
        if (found == 0 || (found == 1 && !upper)) continue;
        if (was_stable >= 0 && s->stable != was_stable) {
            fold[0] = fmin(fold[0], s->nu);
            fold[1] = fmax(fold[1], s->nu);
        }
        was_stable = s->stable;
        if (csv) fprintf(csv, "%.6g,%.6g,%d\n", s->nu, s->A, s->stable);
    }
    if (csv) fputs("\n\n", csv);
}

static void resonance(FILE *csv)
{
    const double Om1 = vm_osc_omega_trig(3), b = 0.04, force = 0.08, rate = 1e-4;
    drifts d = {Om1, 0, 0};
    const vm_forced still = cubic(b, force, &d);
    drifts up = {0.5 * Om1, rate, 0}, down = {1.9 * Om1, -rate, 0};
    vm_forced f;
    vm_real y[3] = {0.3, 0, 0};
    double fold[2] = {VM_INFINITY, 0}, nu;
    write_branch(&still, 0, fold, csv);
    write_branch(&still, 1, fold, csv);
    printf("Resonance curve of m x'' + x^3 = -%g x' + %g cos(nu t): A_peak = %.4f\n", b, force,
           (double)vm_forced_peak(&still, 0));
    f = cubic(b, force, &up);
    nu = write_turning_points(&f, &up, y, 1.4 * Om1 / rate, 1, 0.6, csv);
    printf("  nu up:   falls off the upper branch at nu = %.3f, its fold is at %.3f\n", nu, fold[1]);
    y[0] = 0;
    y[1] = 0;
    y[2] = 0;
    f = cubic(b, force, &down);
    nu = write_turning_points(&f, &down, y, 1.4 * Om1 / rate, 1, 0.6, csv);
    printf("  nu down: leaves the lower branch at nu = %.3f, its fold is at %.3f\n", nu, fold[0]);
}

/* Writes the averaged and the integrated motion. At m = 1 the motion starts at the equilibrium on the backbone; with a
   weak force there is no equilibrium, and it starts with the amplitude of the backbone. */
static void passage(double force, double t_end, FILE *csv)
{
    const double Om1 = vm_osc_omega_trig(3);
    drifts d = {Om1, 0, 0.003};
    vm_forced f = cubic(0, force, &d);
    vm_passage at;
    vm_real slow[3] = {1, 0, 0}, y[3], work[RK45_WORK(3)];
    rk45 s;
    double t;
    vm_forced_passage(&f, 0, 0, &at);
    slow[0] = at.A;
    if (at.drift_ratio <= 1) slow[1] = at.delta;
    if (vm_forced_from_averaged(&f, 0, slow, y)) return;
    rk45_init(&s, vm_forced_averaged_rhs, &f, 3, 0, slow, NULL, work);
    for (t = 0; t <= t_end; t += t_end / 2000) {
        vm_passage now;
        if (rk45_solve(&s, t) < 0 || vm_forced_passage(&f, t, 0, &now)) break;
        if (csv) fprintf(csv, "%.6g,%.6g,%.6g\n", t, s.y[0], now.A);
    }
    if (csv) fputs("\n\n", csv);
    write_turning_points(&f, &d, y, t_end, 0, 1, csv);
    printf("  force %.4f: drift ratio at the start %.3f, %s; at m = %.2f the averaged amplitude is %.3f, the backbone "
           "%.3f\n",
           force, at.drift_ratio, at.drift_ratio < 1 ? "captured" : "passes", 1 + d.mass_rate * t_end, s.y[0],
           sqrt(1 + d.mass_rate * t_end));
}

/* ---- A force with a second harmonic ---- */

/* The cubic oscillator under the force 0.08 N (cos theta + cos(2 theta)/2), near the peak where it makes `vibrations`
   vibrations in a period of the force */
static vm_periodic two_harmonics(int vibrations, const drifts *d)
{
    vm_periodic p;
    memset(&p, 0, sizeof p);
    p.oscillator = cubic(0.04, 0.08, d);
    p.cosine[1] = 1;
    p.cosine[2] = 0.5;
    p.vibrations = vibrations;
    p.periods = 1;
    vm_periodic_init(&p);
    return p;
}

/* Writes the steady vibrations of all phases, and the backbone, on which the frequency of the free vibration is
   `vibrations` times that of the force. Returns the steady vibration with the largest amplitude. */
static vm_steady_state write_peak(const vm_periodic *p, FILE *csv)
{
    vm_steady_state peak, s;
    int i;
    memset(&peak, 0, sizeof peak);
    for (i = -2000; i < 2000; i++) {
        if (vm_periodic_curve(p, 0, VM_PI * i / 2000, &s)) continue;
        if (s.A > peak.A) peak = s;
        if (csv) fprintf(csv, "%.6g,%.6g,%d\n", s.nu, s.A, s.stable);
    }
    if (csv) fprintf(csv, "\n\n0,0\n%.6g,%.6g\n\n\n", 1.2 * peak.nu, 1.2 * peak.A);
    return peak;
}

/* Writes the amplitude in each period of the force while nu rises, by integration. The amplitude is the harmonic of x
   that has the frequency of the resonance, divided by the same harmonic of ca. Therefore it does not include other
   vibrations that the force causes. The motion starts as the largest steady vibration. Returns the largest
   amplitude. */
static vm_steady_state write_sweep(vm_periodic *p, const drifts *d, double nu_end, FILE *csv)
{
    vm_real y[3] = {0, 0, 0}, work[RK45_WORK(3)];
    rk45_options options = rk45_defaults(NULL);
    vm_steady_state steady[8], peak;
    rk45 s;
    double t = 0, nu = d->nu0;
    const int n = vm_periodic_steady_states(p, 0, 8, steady);
    memset(&peak, 0, sizeof peak);
    if (n < 1 || n > 8) return peak;
    y[0] = steady[n - 1].A;
    y[1] = steady[n - 1].delta;
    if (vm_periodic_from_averaged(p, 0, y, y)) return peak;
    options.rtol = options.atol = 1e-8;
    rk45_init(&s, vm_periodic_rhs, p, 3, 0, y, &options, work);
    while (nu < nu_end) {
        double along = 0, across = 0, A;
        int i;
        for (i = 0; i < 64; i++) {
            t += 2 * VM_PI / 64 / nu;
            if (rk45_solve(&s, t) < 0) return peak;
            along += s.y[0] * cos(p->vibrations * s.y[2]) / 32;
            across += s.y[0] * sin(p->vibrations * s.y[2]) / 32;
        }
        nu = d->nu0 + d->nu_rate * t;
        A = hypot(along, across) / p->oscillator.c[0];
        if (A > peak.A) {
            peak.A = A;
            peak.nu = nu;
        }
        if (csv) fprintf(csv, "%.6g,%.6g\n", nu, A);
    }
    if (csv) fputs("\n\n", csv);
    return peak;
}

static void second_harmonic(FILE *csv)
{
    static const double range[2][2] = {{0.75, 1.6}, {0.33, 0.6}}; /* rad/s: first and last nu, per peak */
    int i;
    puts("Resonance curve of m x'' + x^3 = -0.04 x' + 0.08 (cos(nu t) + cos(2 nu t)/2)");
    for (i = 0; i < 2; i++) {
        const drifts up = {range[i][0], 1e-4, 0};
        vm_periodic p = two_harmonics(i + 1, &up);
        const vm_steady_state peak = write_peak(&p, csv), swept = write_sweep(&p, &up, range[i][1], csv);
        printf("  nu times %d: A_peak = %.3f at nu = %.3f; a sweep up reaches %.3f at %.3f\n",
               i + 1, peak.A, peak.nu, swept.A, swept.nu);
    }
}

int main(int argc, char **argv)
{
    const char *prefix = argc > 1 ? argv[1] : NULL;
    FILE *csv = csv_open(prefix, "curve");
    resonance(csv);
    csv_close(csv);
    csv = csv_open(prefix, "passage");
    puts("Passage through the resonance, m = 1 + 0.003 t");
    passage(0.01, 2000, csv);
    passage(0.002, 2000, csv);
    csv_close(csv);
    csv = csv_open(prefix, "periodic");
    second_harmonic(csv);
    csv_close(csv);
    return 0;
}
