/* A rotor vibrates on its shaft, touches the stator and loses a piece: Figs 16-18. The program computes the motion
   before the break by (46)-(51), the break by (52)-(64), the transient motion of the remainder by (68)-(74) and its
   final motion by (76)-(82), each as printed and as corrected.

   usage: rotor [prefix]
   The program writes prefix_orbit.csv (t, x, y, speed, speed as printed), prefix_vectors.csv (the break, Fig. 17: x,
   y, dx, dy), prefix_spin.csv (alpha, Omega_1a corrected and printed), prefix_transient.csv (t, then y and psi' by
   (68), by all terms of (69), by (71)-(72) and by (73)-(74)) and prefix_fig18.csv (t, the radius r for the three
   values of Omega, and r by its three laws). */
#include <math.h>
#include <stdio.h>
#include "../varmass.h"
#include "csv.h"

static const vm_broken_rotor whole = {5, 1.762857142857142857, 14.45, 0.455, 0.6825, 0};
static const double radius = 1, piece_mass = 0.8, piece_inertia = 0.12, SS2 = 0.6, alpha = 0.4, break_time = 0.8;

/* ---- before the break ---- */

/* Writes the state at the start. It is turned so that the vector SS2 has the direction of x when v_S points to the
   point A. */
static void start_state(vm_real *y)
{
    const vm_real first[6] = {0.3, -0.2, 0, 0.5, 0.4, 1.5};
    vm_real at[6];
    double turn, c, s;
    int i;
    vm_broken_rotor_free_motion(&whole, break_time, first, at);
    turn = alpha - atan2(at[4], at[3]);
    c = cos(turn);
    s = sin(turn);
    for (i = 0; i < 6; i++) y[i] = first[i];
    for (i = 0; i < 6; i += 3) {
        y[i] = c * first[i] - s * first[i + 1];
        y[i + 1] = s * first[i] + c * first[i + 1];
    }
}

/* The speed |v_S| by the printed formula after (52) */
static double printed_speed(const vm_real *abcd, double w, double t)
{
    double ca = abcd[2] - abcd[0], bd = abcd[1] - abcd[3];
    return w * sqrt(ca * ca + bd * bd - 2 * ca * bd * sin(2 * w * t));
}

static void free_motion(const vm_real *start, const char *prefix)
{
    FILE *file = csv_open(prefix, "orbit");
    const double w = sqrt(whole.stiffness / whole.mass);
    vm_real abcd[4] = {0, 0, 0, 0}, y[6];
    int i;
    vm_broken_rotor_orbit(&whole, start, abcd);
    for (i = 0; i <= 200; i++) {
        double t = i * break_time / 40;
        vm_broken_rotor_free_motion(&whole, t, start, y);
        if (file) fprintf(file, "%g,%g,%g,%g,%g\n", t, y[0], y[1], hypot(y[3], y[4]), printed_speed(abcd, w, t));
        if (i == 40)
            printf("  speed of S at the break       printed %8.5f   true %8.5f m/s\n", printed_speed(abcd, w, t),
                   hypot(y[3], y[4]));
    }
    csv_close(file);
}

/* ---- the break ---- */

static vm_broken_rotor_piece piece_at(double angle)
{
    vm_broken_rotor_piece p = {0, 0, 0, 0, 0, 0};
    p.mass = piece_mass;
    p.inertia = piece_inertia;
    p.distance = SS2;
    p.radius = radius;
    p.alpha = angle;
    p.contact = alpha;
    return p;
}

/* The angular velocity after the break by (59) as printed */
static double printed_spin(const vm_broken_rotor_break *b, double spin, double angle)
{
    double share = piece_mass / (whole.mass - piece_mass), moment = SS2 * b->tangential * cos(angle + b->beta);
    return (whole.inertia * spin - piece_inertia * (spin + b->spin_piece) + share * SS2 * SS2 * spin +
            share * moment) /
           b->rest.inertia;
}

static void arrow(FILE *file, double x, double y, double vx, double vy)
{
    if (file) fprintf(file, "%g,%g,%g,%g\n", x, y, vx, vy);
}

static void draw_break(const vm_real *before, const vm_broken_rotor_break *b, const char *prefix)
{
    FILE *file = csv_open(prefix, "vectors");
    const double *rest = b->state, *piece = b->piece, scale = 0.5;
    double dx = piece[0] - before[0], dy = piece[1] - before[1], direction = alpha + b->beta;
        /* the velocities of S and S2 before the break; N and T; the velocity of S1 after the break; the point A */
    arrow(file, before[0], before[1], scale * before[3], scale * before[4]);
    arrow(file, piece[0], piece[1], scale * (before[3] - before[5] * dy), scale * (before[4] + before[5] * dx));
    arrow(file, piece[0], piece[1], scale * b->normal * cos(direction), scale * b->normal * sin(direction));
    arrow(file, piece[0], piece[1], -scale * b->tangential * sin(direction),
          scale * b->tangential * cos(direction));
    arrow(file, rest[0], rest[1], scale * rest[3], scale * rest[4]);
    arrow(file, before[0] + radius * cos(alpha), before[1] + radius * sin(alpha), 0, 0);
    csv_close(file);
}

static void spins(const vm_real *before, const char *prefix)
{
    FILE *file = csv_open(prefix, "spin");
    double angle;
    for (angle = -3; angle < 3.005; angle += 0.02) {
        vm_broken_rotor_piece p = piece_at(angle);
        vm_broken_rotor_break b;
        if (vm_broken_rotor_break_off(&whole, before, &p, &b) == VM_OK && file)
            fprintf(file, "%g,%g,%g\n", angle, b.state[5], printed_spin(&b, before[5], angle));
    }
    csv_close(file);
}

/* ---- after it ---- */

static double printed_74(const vm_broken_rotor *r, double t)
{
    double Omega = r->torque / r->damping, s = r->s, k = r->damping / r->inertia;
    return Omega * (1 - piece_inertia / r->inertia * (radius - s) / s * exp(-k * t));
}

static double printed_73(const vm_broken_rotor *r, const vm_real *y, double t)
{
    double Omega = r->torque / r->damping, s = r->s, k = r->damping / r->inertia, w2 = r->stiffness / r->mass;
    double w = sqrt(w2), sum = w2 + k * k, q = piece_inertia / r->inertia * (radius - s);
    return Omega / k * q - s * y[2] - s * Omega * t - w2 * Omega / (sum * k) * q * exp(-k * t) +
           (y[4] / w + s * w * Omega / sum * (1 - q / s + k * k / w2)) * sin(w * t) +
           (y[1] + s * y[2] - Omega * q * k / sum) * cos(w * t);
}

static void transient(const vm_broken_rotor_break *b, const char *prefix)
{
    FILE *file = csv_open(prefix, "transient");
    vm_broken_rotor rotor = b->rest;
    vm_real work[RK45_WORK(6)], coupled[6], closed[6];
    rk45 s;
    int i;
    rk45_init(&s, vm_broken_rotor_rhs, &rotor, 6, 0, b->state, NULL, work);
    for (i = 0; i <= 150; i++) {
        double t = 0.02 * i;
        rk45_solve(&s, t);
        vm_broken_rotor_linear(&rotor, t, b->state, coupled);
        vm_broken_rotor_linear_uncoupled(&rotor, t, b->state, closed);
        if (file)
            fprintf(file, "%g,%g,%g,%g,%g,%g,%g,%g,%g\n", t, s.y[1], s.y[5], coupled[1], coupled[5], closed[1],
                    closed[5], printed_73(&rotor, b->state, t), printed_74(&rotor, t));
        if (i == 25)
            printf("  y and psi' after 0.5 s        (68) %8.5f %8.5f   (69) %8.5f %8.5f   (71), (72) %8.5f %8.5f\n",
                   s.y[1], s.y[5], coupled[1], coupled[5], closed[1], closed[5]);
    }
    csv_close(file);
}

/* ---- Fig. 18 ---- */

static void fig18(const char *prefix)
{
    const double Omega[3] = {0.625, 1, 2.5}, printed[3] = {0.82051, 0, 0};
    FILE *file = csv_open(prefix, "fig18");
    vm_broken_rotor r[3] = {{1, 0.25, 1, 0.25, 0, 0.5}, {1, 0.25, 1, 0.25, 0, 0.5}, {1, 0.25, 1, 0.25, 0, 0.5}};
    vm_real work[3][RK45_WORK(6)], start[6] = {0, 0, 0.5, 0, 0, 0};
    rk45 s[3];
    int i, k;
    for (k = 0; k < 3; k++) {
        r[k].torque = r[k].damping * Omega[k];
        rk45_init(&s[k], vm_broken_rotor_rhs, &r[k], 6, 0, start, NULL, work[k]);
    }
    for (i = 0; i <= 4000; i++) {
        double t = 0.1 * i;
        for (k = 0; k < 3; k++) rk45_solve(&s[k], t);
        if (file)
            fprintf(file, "%g,%g,%g,%g,%g,%g\n", t, hypot(s[0].y[0], s[0].y[1]), hypot(s[1].y[0], s[1].y[1]),
                    hypot(s[2].y[0], s[2].y[1]), vm_broken_rotor_resonance_radius(&r[1], t, 1), vm_broken_rotor_resonance_radius(&r[2], t, 2.5));
    }
    csv_close(file);
    puts("Fig. 18, k* = 1, at t = 400:");
    for (k = 0; k < 3; k++) {
        double law = k ? vm_broken_rotor_resonance_radius(&r[k], 400, Omega[k]) : vm_broken_rotor_steady_radius(&r[k], Omega[k]);
        printf("  Omega = %5.3f   r by rk45 %9.5f   %s %9.5f", Omega[k], hypot(s[k].y[0], s[k].y[1]),
               k ? "law of growth" : "r_SS (77)    ", law);
        if (k == 0) printf("   printed %.5f", printed[0]);
        puts(vm_broken_rotor_is_stable(&r[k], Omega[k]) ? "   stable" : "   not stable");
    }
}

int main(int argc, char **argv)
{
    const char *prefix = argc > 1 ? argv[1] : NULL;
    vm_broken_rotor_piece piece = piece_at(alpha);
    vm_broken_rotor_break b;
    vm_real start[6], y[6];
    int status;
    puts("A rotor loses a piece, (46)-(82): M = 5 kg, m = 0.8 kg, SS2 = 0.6 m, Omega_b = 1.5 rad/s");
    start_state(start);
    free_motion(start, prefix);
    vm_broken_rotor_free_motion(&whole, break_time, start, y);
    status = vm_broken_rotor_break_off(&whole, y, &piece, &b);
    if (status) {
        puts(vm_strerror(status));
        return 1;
    }
    printf("  angle of S2A, beta (56)       printed %8.5f   true %8.5f rad\n",
           atan(SS2 / radius * sin(alpha) / (1 - cos(alpha))), b.beta);
    printf("  spin of the remainder (59)    printed %8.5f   true %8.5f rad/s\n", printed_spin(&b, y[5], alpha),
           b.state[5]);
    printf("  the same by (74) at t = 0     printed %8.5f\n", printed_74(&b.rest, 0));
    printf("  I_S2 that would stop it       true %8.5f kg m^2\n", b.stop_inertia);
    draw_break(y, &b, prefix);
    spins(y, prefix);
    transient(&b, prefix);
    fig18(prefix);
    return 0;
}
