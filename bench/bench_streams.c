/* varmass.h, streams: the time of a right-hand side of chapter 5, for each level and number of streams, beside one
   written by hand for that level: the same states and equations in scalars, but streams of relative velocity only, no
   laws, no stores, and no checks but those of the mass and the pivots. */
#include "timing.h"
#include "../varmass.h"

enum { COUNT = 256, MOST = 4, STATES = VM_FLOW_STATES };
static double state[COUNT][VM_FLOW_BALANCED_STATES];
static int sink;
static vm_stream streams[MOST];
static vm_stream2 streams2[MOST];
static vm_stream1 streams1[MOST];
static vm_flow flow;
static vm_flow1 flow1;
static vm_flow2 flow2;

/* ---- By hand ---- */

static int hand1(double t, const double *y, double *dy, void *ctx)
{
    const vm_flow1 *f = (const vm_flow1 *)ctx;
    const double v = y[1] / y[2];
    double rate = 0, force = f->force;
    int k;
    (void)t;
    if (!(y[2] > 0)) return -1;
    for (k = 0; k < f->n; k++) {
        rate += f->streams[k].rate;
        force += f->streams[k].rate * (v + f->streams[k].velocity);
    }
    dy[0] = v;
    dy[1] = force;
    dy[2] = rate;
    return 0;
}

static int hand_translation(double t, const double *y, double *dy, void *ctx)
{
    const vm_flow *f = (const vm_flow *)ctx;
    const double inverse = 1 / y[6], vx = y[3] * inverse, vy = y[4] * inverse, vz = y[5] * inverse;
    double rate = 0, fx = f->force.x, fy = f->force.y, fz = f->force.z;
    int k;
    (void)t;
    if (!(y[6] > 0)) return -1;
    for (k = 0; k < f->n; k++) {
        const vm_stream *s = f->streams + k;
        rate += s->rate;
        fx += s->rate * (vx + s->velocity.x);
        fy += s->rate * (vy + s->velocity.y);
        fz += s->rate * (vz + s->velocity.z);
    }
    dy[0] = vx;
    dy[1] = vy;
    dy[2] = vz;
    dy[3] = fx;
    dy[4] = fy;
    dy[5] = fz;
    dy[6] = rate;
    return 0;
}

static int hand2(double t, const double *y, double *dy, void *ctx)
{
    const vm_flow2 *f = (const vm_flow2 *)ctx;
    const double inverse = 1 / y[6], vx = y[3] * inverse, vy = y[4] * inverse, w = y[5] / y[9], s = sin(y[2]),
                 c = cos(y[2]);
    double rate = 0, px = 0, py = 0, moment = f->moment, sx = 0, sy = 0, inertia = 0;
    int k;
    (void)t;
    if (!(y[6] > 0) || !(y[9] > 0)) return -1;
    for (k = 0; k < f->n; k++) {
        const vm_stream2 *p = f->streams + k;
        const double dx = p->x - y[7], dy_ = p->y - y[8];
        const double ux = p->rate * (p->vx - w * dy_), uy = p->rate * (p->vy + w * dx);
        rate += p->rate;
        px += ux;
        py += uy;
        moment += dx * uy - dy_ * ux + p->rate * p->gyration * (w + p->spin);
        sx += p->rate * dx;
        sy += p->rate * dy_;
        inertia += p->rate * (p->gyration + dx * dx + dy_ * dy_);
    }
    sx *= inverse;
    sy *= inverse;
    dy[0] = vx + c * sx - s * sy;
    dy[1] = vy + s * sx + c * sy;
    dy[2] = w;
    dy[3] = f->fx + rate * vx + c * px - s * py;
    dy[4] = f->fy + rate * vy + s * px + c * py;
    dy[5] = moment;
    dy[6] = rate;
    dy[7] = sx;
    dy[8] = sy;
    dy[9] = inertia;
    return 0;
}

/* Sums over the streams, in body axes: rates of mass, momentum, moment, static moment and inertia */
typedef struct stream_sums {
    double rate, px, py, pz, mx, my, mz, sx, sy, sz, ixx, iyy, izz, ixy, ixz, iyz;
} stream_sums;

static inline void add_stream(stream_sums *sum, const vm_stream *p, const double *centre, double wx, double wy,
                              double wz)
{
    const double a = p->rate, dx = p->at.x - centre[0], dy = p->at.y - centre[1], dz = p->at.z - centre[2];
    const double ux = a * (p->velocity.x + wy * dz - wz * dy), uy = a * (p->velocity.y + wz * dx - wx * dz);
    const double uz = a * (p->velocity.z + wx * dy - wy * dx);
    const double ox = wx + p->spin.x, oy = wy + p->spin.y, oz = wz + p->spin.z;
    const double kxx = a * p->gyration.xx, kyy = a * p->gyration.yy, kzz = a * p->gyration.zz;
    const double kxy = a * p->gyration.xy, kxz = a * p->gyration.xz, kyz = a * p->gyration.yz;
    sum->rate += a;
    sum->px += ux;
    sum->py += uy;
    sum->pz += uz;
    sum->mx += dy * uz - dz * uy + kxx * ox + kxy * oy + kxz * oz;
    sum->my += dz * ux - dx * uz + kxy * ox + kyy * oy + kyz * oz;
    sum->mz += dx * uy - dy * ux + kxz * ox + kyz * oy + kzz * oz;
    sum->sx += a * dx;
    sum->sy += a * dy;
    sum->sz += a * dz;
    sum->ixx += kxx + a * (dy * dy + dz * dz);
    sum->iyy += kyy + a * (dx * dx + dz * dz);
    sum->izz += kzz + a * (dx * dx + dy * dy);
    sum->ixy += kxy - a * dx * dy;
    sum->ixz += kxz - a * dx * dz;
    sum->iyz += kyz - a * dy * dz;
}

static int hand3(double t, const double *y, double *dy, void *ctx)
{
    const vm_flow *f = (const vm_flow *)ctx;
    const double qw = y[3], qx = y[4], qy = y[5], qz = y[6], square = qw * qw + qx * qx + qy * qy + qz * qz;
    const double s = 2 / square, x = s * qx, yy_ = s * qy, z = s * qz;
    const double m11 = 1 - (yy_ * qy + z * qz), m22 = 1 - (x * qx + z * qz), m33 = 1 - (x * qx + yy_ * qy);
    const double m12 = x * qy - z * qw, m21 = x * qy + z * qw, m13 = x * qz + yy_ * qw, m31 = x * qz - yy_ * qw;
    const double m23 = yy_ * qz - x * qw, m32 = yy_ * qz + x * qw;
    const double inverse = 1 / y[13], vx = y[7] * inverse, vy = y[8] * inverse, vz = y[9] * inverse;
    const double h1 = m11 * y[10] + m21 * y[11] + m31 * y[12], h2 = m12 * y[10] + m22 * y[11] + m32 * y[12];
    const double h3 = m13 * y[10] + m23 * y[11] + m33 * y[12];
    const double xx = y[17], yy = y[18], zz = y[19], xy = y[20], xz = y[21], yz = y[22];
    const double d1 = 1 / xx, l21 = xy * d1, l31 = xz * d1;
    const double pivot2 = yy - l21 * xy, r = yz - l31 * xy, d2 = 1 / pivot2;
    const double l32 = r * d2, pivot3 = zz - l31 * xz - l32 * r, d3 = 1 / pivot3;
    const double g2 = h2 - l21 * h1, wz = (h3 - l31 * h1 - l32 * g2) * d3, wy = g2 * d2 - l32 * wz;
    const double wx = h1 * d1 - l21 * wy - l31 * wz, back = sqrt(wx * wx + wy * wy + wz * wz) * (1 - square) / 8;
    stream_sums sum = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    int k;
    (void)t;
    if (!(y[13] > 0) || !(xx > 0) || !(pivot2 > 2e-15 * yy) || !(pivot3 > 2e-15 * zz)) return -1;
    for (k = 0; k < f->n; k++) add_stream(&sum, f->streams + k, y + 14, wx, wy, wz);
    sum.sx *= inverse;
    sum.sy *= inverse;
    sum.sz *= inverse;
    dy[0] = vx + m11 * sum.sx + m12 * sum.sy + m13 * sum.sz;
    dy[1] = vy + m21 * sum.sx + m22 * sum.sy + m23 * sum.sz;
    dy[2] = vz + m31 * sum.sx + m32 * sum.sy + m33 * sum.sz;
    dy[3] = back * qw - (qx * wx + qy * wy + qz * wz) / 2;
    dy[4] = back * qx + (qw * wx + qy * wz - qz * wy) / 2;
    dy[5] = back * qy + (qw * wy + qz * wx - qx * wz) / 2;
    dy[6] = back * qz + (qw * wz + qx * wy - qy * wx) / 2;
    dy[7] = f->force.x + sum.rate * vx + m11 * sum.px + m12 * sum.py + m13 * sum.pz;
    dy[8] = f->force.y + sum.rate * vy + m21 * sum.px + m22 * sum.py + m23 * sum.pz;
    dy[9] = f->force.z + sum.rate * vz + m31 * sum.px + m32 * sum.py + m33 * sum.pz;
    dy[10] = f->moment.x + m11 * sum.mx + m12 * sum.my + m13 * sum.mz;
    dy[11] = f->moment.y + m21 * sum.mx + m22 * sum.my + m23 * sum.mz;
    dy[12] = f->moment.z + m31 * sum.mx + m32 * sum.my + m33 * sum.mz;
    dy[13] = sum.rate;
    dy[14] = sum.sx;
    dy[15] = sum.sy;
    dy[16] = sum.sz;
    dy[17] = sum.ixx;
    dy[18] = sum.iyy;
    dy[19] = sum.izz;
    dy[20] = sum.ixy;
    dy[21] = sum.ixz;
    dy[22] = sum.iyz;
    return 0;
}

/* ---- Runs ---- */

static double derivative[COUNT][VM_FLOW_BALANCED_STATES]; /* all of it is written */
static volatile ode_rhs hidden;

/* Called through a pointer, as a caller's own right-hand side would be */
#define RUN(name, rhs, ctx)                                                          \
    static void name(void)                                                           \
    {                                                                                \
        ode_rhs f;                                                                   \
        int i, status = 0;                                                           \
        hidden = rhs;                                                                \
        f = hidden;                                                                  \
        for (i = 0; i < COUNT; i++) status += f(0, state[i], derivative[i], &(ctx)); \
        sink = status;                                                               \
    }
RUN(count_1, vm_flow1_rhs, flow1)
RUN(count_1_hand, hand1, flow1)
RUN(count_translation, vm_translation_rhs, flow)
RUN(count_translation_hand, hand_translation, flow)
RUN(count_2, vm_flow2_rhs, flow2)
RUN(count_2_hand, hand2, flow2)
RUN(count_3, vm_flow_rhs, flow)
RUN(count_3_hand, hand3, flow)
RUN(count_given, vm_flow_given_rhs, flow)
RUN(count_carried, vm_flow_carried_rhs, flow)
RUN(count_balanced, vm_flow_balanced_rhs, flow)

static const struct level {
    const char *name, *route;
    void (*kit)(void), (*hand)(void);
} levels[] = {
    {"one degree of freedom, fixed axle", "vm_flow1_rhs", count_1, count_1_hand},
    {"translation", "vm_translation_rhs", count_translation, count_translation_hand},
    {"plane", "vm_flow2_rhs", count_2, count_2_hand},
    {"space", "vm_flow_rhs", count_3, count_3_hand},
    {"space, laws given", "vm_flow_given_rhs", count_given, count_3_hand},
    {"space, all carried, laws given", "vm_flow_carried_rhs", count_carried, count_3_hand},
};

static double between(double low, double high)
{
    static unsigned long random = 1;
    random = (random * 1664525ul + 1013904223ul) & 0xfffffffful;
    return low + (high - low) * ((double)(random >> 8) / 16777216);
}

static void set_up(void)
{
    int i, k;
    for (i = 0; i < COUNT; i++)
        for (k = 0; k < STATES; k++)
            state[i][k] = k == 2 || k == 6 || k == 9 || (k > 12 && k < 17) ? between(1, 3) : between(-.2, .2);
    for (i = 0; i < COUNT; i++)
        for (k = 17; k < 20; k++) state[i][k] = between(2, 3);
    for (k = 0; k < MOST; k++) {
        streams[k].rate = streams1[k].rate = streams2[k].rate = between(-1, 1);
        streams[k].at = vmi_vec3(between(-1, 1), between(-1, 1), between(-1, 1));
        streams[k].velocity = streams[k].spin = streams[k].at;
        streams[k].gyration.xx = streams[k].gyration.yy = streams[k].gyration.zz = between(0, 1);
        streams1[k].velocity = streams2[k].vx = streams2[k].x = between(-1, 1);
        streams2[k].vy = streams2[k].y = streams2[k].gyration = between(0, 1);
    }
    flow.streams = streams;
    flow1.streams = streams1;
    flow2.streams = streams2;
    flow.mass = 3;
    flow.inertia.xx = flow.inertia.yy = flow.inertia.zz = 2;
}

static void set_streams(int n) { flow.n = flow1.n = flow2.n = n; }

int main(int argc, char **argv)
{
    static const int numbers[] = {0, 1, 4};
    char knob[16];
    size_t i, k;
    set_up();
    bench_start(argc, argv, "a right-hand side of chapter 5, streams as the knob, beside one written by hand");
    for (i = 0; i < sizeof levels / sizeof *levels; i++)
        for (k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            set_streams(numbers[k]);
            snprintf(knob, sizeof knob, "%d", numbers[k]);
            measure(levels[i].name, levels[i].route, knob, NO_ERROR, levels[i].kit, COUNT, "by hand",
                    levels[i].hand, COUNT);
        }
    set_streams(1);
    measure("space, with the account", "vm_flow_balanced_rhs", "1", NO_ERROR, count_balanced, COUNT, "vm_flow_rhs", count_3,
            COUNT);
    return bench_end() || sink != 0;
}
