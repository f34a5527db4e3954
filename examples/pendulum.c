/* A pendulum loses its outer part: Fig. 19. The program computes the angular velocity of the remaining part,
   (119)-(132), as printed and as corrected, and also by Lagrange's equations for jumps (96). The program also compares
   the angular momenta before and after the jump.

   usage: pendulum [prefix] writes prefix_rate.csv (l/L, and phi1' corrected and as printed, for two ways in which the
   part is thrown off) and prefix_motion.csv: for each rod the ends x0, y0 and x1, y1, with y downwards, and a kind (0:
   before the cut, 1: the rest, 2: the part). */
#include <math.h>
#include <stdio.h>
#include "../varmass.h"
#include "csv.h"

static const double M = 3, L = 2, gravity = 9.81;

/* The angular velocity of the rest by (125) as printed, with the axes (sin, cos) of (123) */
static double printed_rate(double angle, double rate, double l, double Omega, double ux, double uy)
{
    double m = M * l / L, rho = L - l / 2, x = rho * sin(angle), y = rho * cos(angle), with = rate + Omega;
    return (M * L * L * rate - m * l * l / 4 * with - 3 * m * with * rho * rho + 3 * m * (ux * y - uy * x)) /
           ((M - m) * (L - l) * (L - l));
}

/* The angular velocity of the rest by (96) with n = 1: the mass matrices are M L^2/3 and (M - m)(L - l)^2/3 */
static double lagrange_rate(const vm_pendulum *p, const vm_pendulum_cut *c)
{
    vm_real before = p->mass * p->length * p->length / 3,
            after = c->rest.mass * c->rest.length * c->rest.length / 3;
    vm_real rate = p->rate, work[VM_LAGRANGE_WORK(1)];
    vm_lagrange_separate(1, &before, &after, &rate, &c->L2, NULL, &rate, work);
    return rate;
}

static void rates(const char *prefix)
{
    FILE *file = csv_open(prefix, "rate");
    const vm_pendulum p = {M, L, 0.7, 1.3, VM_AXES_SIN_COS};
    vm_pendulum_cut c;
    double share;
    puts("  l/L    u = (0.4, -0.25), Omega = 0.6: printed   corrected   (96)       L1 + L2 - L0");
    for (share = 0.05; share < 0.505; share += 0.05) {
        double l = share * L;
        if (vm_pendulum_separate(&p, l, 0.6, 0.4, -0.25, &c)) return;
        printf("  %4.2f   %39.5f %11.5f %11.5f   %8.1e\n", share, printed_rate(0.7, 1.3, l, 0.6, 0.4, -0.25),
               c.rest.rate, lagrange_rate(&p, &c), c.L1 + c.L2 - M * L * L * p.rate / 3);
    }
    for (share = 0.005; file && share < 0.5; share += 0.005) {
        double l = share * L, spun;
        vm_pendulum_separate(&p, l, 3, 0, 0, &c);
        spun = c.rest.rate;
        vm_pendulum_separate(&p, l, 0.6, 0.4, -0.25, &c);
        fprintf(file, "%g,%g,%g,%g,%g\n", share, c.rest.rate, printed_rate(0.7, 1.3, l, 0.6, 0.4, -0.25), spun,
                printed_rate(0.7, 1.3, l, 3, 0, 0));
    }
    csv_close(file);
}

/* ---- Fig. 19 in motion ---- */

/* The equation of motion phi'' = -(3 g/(2 L)) sin phi of a rod; ctx is its length L */
static int swing(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = y[1];
    dydt[1] = -1.5 * gravity / *(const vm_real *)ctx * sin(y[0]);
    return 0;
}

static void rod(FILE *file, double x, double y, double half, double angle, int kind)
{
    double dx = half * sin(angle), dy = half * cos(angle);
    if (file) fprintf(file, "%g,%g\n%g,%g\n%d\n\n", x - dx, y - dy, x + dx, y + dy, kind);
}

static void motion(const char *prefix)
{
    FILE *file = csv_open(prefix, "motion");
    const double start = -1.1, l = 0.8, cut_time = 0.75, step = 0.075;
    vm_real length = L, state[2] = {0, 0}, work[RK45_WORK(2)], t;
    vm_pendulum p = {M, L, 0, 0, VM_AXES_SIN_COS};
    vm_pendulum_cut c;
    rk45 s;
    int i;
    state[0] = start;
    rk45_init(&s, swing, &length, 2, 0, state, NULL, work);
    for (i = 0; i <= 10; i++) {
        rk45_solve(&s, i * step);
        rod(file, L / 2 * sin(s.y[0]), L / 2 * cos(s.y[0]), L / 2, s.y[0], 0);
    }
    p.angle = s.y[0];
    p.rate = s.y[1];
    if (vm_pendulum_separate(&p, l, 3, 1.5, -0.5, &c)) return;
    length = L - l;
    state[0] = p.angle;
    state[1] = c.rest.rate;
    rk45_restart(&s, cut_time, state);
    for (i = 1; i <= 8; i++) {
        t = i * step;
        rk45_solve(&s, cut_time + t);
        rod(file, (L - l) / 2 * sin(s.y[0]), (L - l) / 2 * cos(s.y[0]), (L - l) / 2, s.y[0], 1);
        rod(file, c.x + c.vx * t, c.y + c.vy * t + gravity * t * t / 2, l / 2, p.angle + c.rate * t, 2);
    }
    printf("Fig. 19: at %.2f s, phi = %.5f, phi' = %.5f, the outer %.1f m leave: phi1' printed %.5f, true %.5f\n",
           cut_time, p.angle, p.rate, l, printed_rate(p.angle, p.rate, l, 3, 1.5, -0.5), c.rest.rate);
    printf("  energy before %.4f J, after %.4f + %.4f J; impulse of the pivot (%.4f, %.4f) N s\n", c.T1, c.T_S1,
           c.T_S2, c.pivot_x, c.pivot_y);
    csv_close(file);
}

int main(int argc, char **argv)
{
    const char *prefix = argc > 1 ? argv[1] : NULL;
    puts("A pendulum loses its outer part, (119)-(132): M = 3 kg, L = 2 m, phi = 0.7, phi' = 1.3 rad/s");
    rates(prefix);
    motion(prefix);
    return 0;
}
