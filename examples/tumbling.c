/* A tumbling satellite sheds a panel: the jump in space by vm_separate, the balances of momentum, angular momentum and
   energy at the jump, and the free motion before it and of both pieces after it.

   usage: tumbling [file.csv]
   The file has three parts, with two empty lines between them:
     0  t; the hub's angular velocity in body axes; L_z about the origin for the hub, for the panel and for both
     1  the hub's edges at seven times: colour; x, y, z of one end; x, y, z of the other end
     2  the panel's edges, with the same columns */
#include "../varmass.h"
#include <stdio.h>

static vm_vec3 vec3(double x, double y, double z)
{
    vm_vec3 a = {x, y, z};
    return a;
}

static vm_vec3 plus(vm_vec3 a, double c, vm_vec3 b) { return vec3(a.x + c * b.x, a.y + c * b.y, a.z + c * b.z); }

/* A box with the given edges, whose inertia is about its middle */
static vm_body box(double mass, vm_vec3 edges, vm_vec3 at)
{
    const double k = mass / 12;
    vm_body body = {0, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    body.mass = mass;
    body.r = at;
    body.inertia.xx = k * (edges.y * edges.y + edges.z * edges.z);
    body.inertia.yy = k * (edges.x * edges.x + edges.z * edges.z);
    body.inertia.zz = k * (edges.x * edges.x + edges.y * edges.y);
    return body;
}

/* ---- free motion by rk45: y is the quaternion; ctx is the body, whose angular momentum is constant ---- */

typedef struct spinning {
    vm_body body;
    vm_vec3 L; /* about the mass centre, inertial axes */
    vmi_principal principal;
} spinning;

static vm_vec3 spin_at(const spinning *s, vm_quat q)
{
    const vmi_mat3 turn = vmi_rotation(q);
    return vmi_times(&turn, vmi_spin_of(&s->principal, vmi_times_transposed(&turn, s->L)));
}

static vm_quat quaternion(const vm_real *y)
{
    vm_quat q = {y[0], y[1], y[2], y[3]};
    return q;
}

static int turning(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_vec3 w = spin_at((const spinning *)ctx, quaternion(y));
    vm_quat half = {0, w.x / 2, w.y / 2, w.z / 2}, rate = vm_quat_times(half, quaternion(y));
    (void)t;
    dydt[0] = rate.w;
    dydt[1] = rate.x;
    dydt[2] = rate.y;
    dydt[3] = rate.z;
    return 0;
}

/* Computes the body after the time t of free motion; t may be negative. Returns 0 if there was no error. */
static int moved(const vm_body *from, double t, vm_body *to)
{
    spinning s;
    rk45_options o = rk45_defaults(NULL);
    rk45 run;
    vm_real y[4], work[RK45_WORK(4)];
    int status;
    s.body = *from;
    s.L = vm_angular_momentum(from, from->r);
    s.principal = vmi_principal_axes(&from->inertia);
    y[0] = from->q.w;
    y[1] = from->q.x;
    y[2] = from->q.y;
    y[3] = from->q.z;
    o.rtol = o.atol = 1e-11;
    status = rk45_init(&run, turning, &s, 4, 0, y, &o, work);
    if (!status) status = rk45_solve(&run, t);
    if (status) return status;
    *to = *from;
    to->q = quaternion(run.y);
    to->r = plus(from->r, t, from->v);
    to->omega = spin_at(&s, to->q);
    return 0;
}

/* ---- output: numbers and drawings ---- */

static void print_motion(const char *name, const vm_body *b)
{
    const vm_vec3 K = vm_momentum(b), L = vm_angular_momentum(b, vec3(0, 0, 0));
    printf("  %-14s%9.4f%9.4f%9.4f  %10.4f%10.4f%10.4f  %9.4f\n", name, K.x, K.y, K.z, L.x, L.y, L.z,
           vm_kinetic_energy(b));
}

/* Bits 0, 1, 2 of the number of a corner say on which side of the middle it is along x, y, z. */
static vm_vec3 corner_of(vm_vec3 edges, int corner)
{
    return vec3(edges.x * ((corner & 1) - 0.5), edges.y * ((corner >> 1 & 1) - 0.5),
                edges.z * ((corner >> 2 & 1) - 0.5));
}

/* Writes the twelve edges of a box, whose size and place are given in the axes of the body */
static void draw_box(FILE *csv, int colour, const vm_body *b, vm_vec3 place, vm_vec3 edges)
{
    const vmi_mat3 turn = vmi_rotation(b->q);
    int corner, axis;
    for (corner = 0; corner < 8; corner++) {
        for (axis = 0; axis < 3; axis++) {
            vm_vec3 from, to;
            if (corner >> axis & 1) continue; /* the edge was drawn from its other end */
            from = plus(b->r, 1, vmi_times(&turn, plus(place, 1, corner_of(edges, corner))));
            to = plus(b->r, 1, vmi_times(&turn, plus(place, 1, corner_of(edges, corner | 1 << axis))));
            fprintf(csv, "%d,%.5g,%.5g,%.5g,%.5g,%.5g,%.5g\n", colour, from.x, from.y, from.z, to.x, to.y, to.z);
        }
    }
}

/* Hub and panel: they are one body before t = 0, and two bodies after it */
typedef struct scene {
    vm_body whole, hub, panel;
    vm_vec3 hub_edges, panel_edges, hub_in_whole, panel_in_whole; /* places in the axes of the whole */
} scene;

static int draw_frames(const scene *s, FILE *csv, int panel)
{
    const double times[] = {-6, -4, -2, 0, 2, 4, 6};
    const vm_vec3 middle = {0, 0, 0};
    int i;
    for (i = 0; i < 7; i++) {
        const vm_body *from = panel ? &s->panel : &s->hub;
        vm_vec3 place = middle;
        int colour = panel ? 2 : 1;
        vm_body b;
        if (times[i] <= 0) { /* still a part of the whole */
            from = &s->whole;
            place = panel ? s->panel_in_whole : s->hub_in_whole;
            colour = 0;
        }
        if (moved(from, times[i], &b)) return 1;
        draw_box(csv, colour, &b, place, panel ? s->panel_edges : s->hub_edges);
    }
    return 0;
}

static int draw(const scene *s, const char *file)
{
    FILE *csv = fopen(file, "w");
    int i, failed = 0;
    if (!csv) return 1;
    for (i = -120; i <= 120 && !failed; i++) {
        const double t = i / 20.;
        vm_body a, b;
        vm_vec3 w;
        double hub, panel = 0;
        vmi_mat3 turn;
        failed = moved(t < 0 ? &s->whole : &s->hub, t, &a) || moved(&s->panel, t, &b);
        if (failed) break;
        turn = vmi_rotation(a.q);
        w = vmi_times_transposed(&turn, a.omega);
        hub = vm_angular_momentum(&a, vec3(0, 0, 0)).z;
        if (t >= 0) panel = vm_angular_momentum(&b, vec3(0, 0, 0)).z;
        fprintf(csv, "%g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", t, w.x, w.y, w.z, hub, panel, hub + panel);
    }
    fputs("\n\n", csv);
    failed = failed || draw_frames(s, csv, 0);
    fputs("\n\n", csv);
    failed = failed || draw_frames(s, csv, 1);
    return fclose(csv) != 0 || failed;
}

/* The angular velocity by (34), with the inertias I_S1 and I_S2 of (40), which are about S; those of Table 1 are about
   S1 and S2 */
static vm_vec3 with_inertias_about_S(const scene *s)
{
    const vm_vec3 d1 = plus(s->hub.r, -1, s->whole.r), d2 = plus(s->panel.r, -1, s->whole.r);
    vm_body hub = s->hub, panel = s->panel;
    vm_vec3 h;
    vmi_principal p;
    hub.inertia = vm_parallel_axes(&hub.inertia, hub.mass, d1);
    panel.inertia = vm_parallel_axes(&panel.inertia, panel.mass, d2);
    h = plus(vmi_spin_momentum(&s->whole), -1, vmi_spin_momentum(&panel));
    h = plus(h, panel.mass, vm_cross(d2, plus(hub.v, -1, panel.v)));
    p = vmi_principal_axes(&hub.inertia);
    return vmi_spin_of(&p, h); /* at the jump the body axes are parallel to the inertial axes */
}

int main(int argc, char **argv)
{
    scene s;
    vm_body relative, after[2];
    vm_balance balance;
    vm_vec3 wrong;
    s.hub_edges = vec3(1, 0.8, 0.6);
    s.panel_edges = vec3(1.6, 0.7, 0.05);
    s.hub = box(60, s.hub_edges, vec3(0, 0, 0));
    s.panel = box(12, s.panel_edges, vec3(1.3, 0, 0.2));
    s.hub.v = s.panel.v = vec3(1.2, 0, 0.2);
    if (vm_attach(&s.hub, &s.panel, NULL, &s.whole)) return 1;
    s.whole.omega = vec3(0.3, 0.25, 0.7);
    s.hub_in_whole = plus(s.hub.r, -1, s.whole.r);
    s.panel_in_whole = plus(s.panel.r, -1, s.whole.r);

    relative = s.panel; /* the panel leaves at 0.15 m/s outwards and rotates, (25), (41) */
    relative.v = vec3(0.15, 0, 0);
    relative.omega = vec3(0.4, -0.3, -1);
    if (vm_to_absolute(&s.whole, &relative, &s.panel) || vm_separate(&s.whole, &s.panel, NULL, &s.hub)) return 1;

    puts("A satellite of 72 kg sheds a panel of 12 kg: M v, N s; angular momentum about the origin, N m s; energy, "
         "J");
    print_motion("whole", &s.whole);
    print_motion("hub", &s.hub);
    print_motion("panel", &s.panel);
    after[0] = s.hub;
    after[1] = s.panel;
    if (vm_balance_between(1, &s.whole, 2, after, NULL, vec3(0, 0, 0), &balance)) return 1;
    printf("  after - before %8.1e %8.1e %8.1e   %8.1e  %8.1e  %8.1e  %9.4f\n", balance.momentum.x,
           balance.momentum.y, balance.momentum.z, balance.angular_momentum.x, balance.angular_momentum.y,
           balance.angular_momentum.z, balance.energy);
    printf("  energy gained by theorem (113), (118): %.15g J, by the bodies: %.15g J\n",
           vm_energy_gain(&s.whole, 1, &s.panel, NULL, &s.hub), balance.energy);
    wrong = with_inertias_about_S(&s);
    printf("  the hub's angular velocity: before %.4f %.4f %.4f, after %.4f %.4f %.4f rad/s\n", s.whole.omega.x,
           s.whole.omega.y, s.whole.omega.z, s.hub.omega.x, s.hub.omega.y, s.hub.omega.z);
    printf("  with (34) and the inertias as (40) defines them, about S: %.4f %.4f %.4f\n", wrong.x, wrong.y,
           wrong.z);
    if (argc > 1 && draw(&s, argv[1])) {
        fprintf(stderr, "tumbling: cannot write %s\n", argv[1]);
        return 1;
    }
    return 0;
}
