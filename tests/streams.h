/* streams.h - what the tests of chapters 5 and 6 share: integration as accurate as the type allows, and three bodies
   with streams: case E1 (one instant), the tank (cases E2 and E3) and the scene (four streams, outer loads). */
#ifndef STREAMS_H
#define STREAMS_H

#include "bodies.h"

#define PICK(in_double, in_float) (is_float ? (in_float) : (in_double))

static inline double apart(vm_vec3 a, vm_vec3 b) { return size_of(vm_sub(a, b)); }

/* The three moments of inertia first, then the products; inertia() of bodies.h takes them row by row. */
static inline vm_inertia tensor(double xx, double yy, double zz, double xy, double xz, double yz)
{
    return inertia(xx, xy, xz, yy, yz, zz);
}

static inline vm_quat quaternion(double w, double x, double y, double z)
{
    vm_quat q;
    q.w = R(w);
    q.x = R(x);
    q.y = R(y);
    q.z = R(z);
    return q;
}

/* Integrates y from t to end, or to an event that stops the run, and gives the time reached in *stopped. Returns the
   integrator's status. The method is of order 8, in float of order 5, whose fewer operations round less. */
static inline int solve_events(ode_rhs f, void *ctx, int n, vm_real *y, double t, double end, ode_event *events,
                               int n_events, double *stopped)
{
    static vm_real work[RK87_WORK(40)];
    rk45_options o = rk45_defaults(NULL);
    rk45 s;
    int status, k;
    o.rtol = PICK(256, 16) * VM_EPSILON;
    o.atol = o.rtol / 100;
    o.events = events;
    o.n_events = n_events;
    status = is_float ? rk45_init(&s, f, ctx, n, R(t), y, &o, work) : rk87_init(&s, f, ctx, n, R(t), y, &o, work);
    if (status >= 0) status = is_float ? rk45_solve(&s, R(end)) : rk87_solve(&s, R(end));
    if (status == ODE_BAD_ARGUMENT) return status;
    for (k = 0; k < n; k++) y[k] = s.y[k];
    if (stopped) *stopped = (double)s.t;
    return status;
}

static inline int solve(ode_rhs f, void *ctx, int n, vm_real *y, double t, double end)
{
    return solve_events(f, ctx, n, y, t, end, NULL, 0, NULL);
}

/* A run that starts from ones, but for y[slot] = value (none if slot < 0), takes no step: it ends with an error, and
   the state stays as it was. */
static inline void check_no_step(ode_rhs f, void *ctx, int n, int slot, double value)
{
    vm_real y[VM_FLOW_STATES], kept[VM_FLOW_STATES];
    int i, status;
    for (i = 0; i < VM_FLOW_STATES; i++) y[i] = 1;
    if (slot >= 0) y[slot] = R(value);
    memcpy(kept, y, sizeof y);
    status = solve(f, ctx, n, y, 0, 1);
    CHECK(status < 0 && !memcmp(y, kept, sizeof(vm_real) * (size_t)n));
}

/* ---- Case E1: the loads of one stream on a body at one instant ---- */

static inline vm_body case_e1(void)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = 6;
    b.inertia = tensor(2, 1.5, 1.1, .1, -.2, .05);
    b.q.w = 1;
    b.v = vector(.1, .2, -.1);
    b.omega = vector(.3, -.4, .6);
    return b;
}

static inline vm_stream case_e1_stream(void)
{
    vm_stream s;
    memset(&s, 0, sizeof s);
    s.rate = R(-.5);
    s.motion = VM_ABSOLUTE;
    s.at = vector(.5, -.3, .4);
    s.velocity = vector(1, -.4, .3);
    s.spin = vector(.4, -.9, .2);
    s.gyration = tensor(.3, .5, .2, 0, 0, 0);
    return s;
}

/* ---- The tank: a tank off the mass centre drains ---- */

typedef struct tank {
    vm_flow flow;
    vm_stream stream;
    vm_body body;
    double empty, contents; /* masses */
} tank;

/* with_spin: case E3, whose contents have an inertia and leave with a spin of their own; otherwise case E2, whose
   contents are a point */
static inline void tank_init_as(tank *k, int with_spin)
{
    const vm_vec3 at = vector(.5, -.3, .4);
    const vm_inertia contents = with_spin ? tensor(.35, .55, .25, .05, .05, .05) : tensor(0, 0, 0, 0, 0, 0);
    memset(k, 0, sizeof *k);
    k->empty = 4;
    k->contents = 2;
    k->body = case_e1();
    k->body.mass = R(k->empty + k->contents);
    k->body.inertia = vmi_inertia_plus(vmi_inertia_plus(k->body.inertia, R(k->contents), contents),
                                       R(k->empty * k->contents / (k->empty + k->contents)),
                                       vmi_inertia_of_point(at));
    k->stream.rate = R(-.5);
    k->stream.at = at;
    k->stream.velocity = vector(.7, .2, -.5);
    if (with_spin) k->stream.spin = vector(.8, -.5, .3);
    k->stream.gyration = contents;
    k->flow.n = 1;
    k->flow.streams = &k->stream;
    k->flow.centre = vm_scale(R(k->contents / (k->empty + k->contents)), at);
}

static inline void tank_init(tank *k) { tank_init_as(k, 1); }

/* The masses of the contents and of the whole tank at time t */
static inline double tank_contents(const tank *k, double t) { return k->contents + (double)k->stream.rate * t; }
static inline double tank_mass(const tank *k, double t) { return k->empty + tank_contents(k, t); }

static inline vm_inertia tank_inertia(const tank *k, double t)
{
    const double contents = tank_contents(k, t);
    const vm_inertia about_centres = vmi_inertia_plus(case_e1().inertia, R(contents), k->stream.gyration);
    return vmi_inertia_plus(about_centres, R(k->empty * contents / tank_mass(k, t)),
                            vmi_inertia_of_point(k->stream.at));
}

/* The velocity of the mass centre relative to the tank */
static inline vm_vec3 tank_drift(const tank *k, double t)
{
    const double mass = tank_mass(k, t);
    return vm_scale(R((double)k->stream.rate * k->empty / mass / mass), k->stream.at);
}

/* flow->update of vm_flow_given_rhs: the tank's mass, mass centre, inertia and drift as known functions of time */
static inline int tank_law(vm_real t, const vm_real *y, vm_flow *flow)
{
    const tank *k = (const tank *)flow->ctx;
    const double mass = tank_mass(k, (double)t);
    (void)y;
    flow->mass = R(mass);
    flow->centre = vm_scale(R(tank_contents(k, (double)t) / mass), k->stream.at);
    flow->inertia = tank_inertia(k, (double)t);
    flow->drift = tank_drift(k, (double)t);
    return 0;
}

/* ---- The scene: a body with a stream of each kind of motion, in and out, and outer loads ---- */

enum { SCENE_STREAMS = 4 }; /* the index of a stream is its motion */

typedef struct scene {
    vm_flow flow;
    vm_stream streams[SCENE_STREAMS];
    vm_body body;
} scene;

static inline int scene_loads(vm_real t, const vm_real *y, vm_flow *flow)
{
    double s = sin((double)t), c = cos((double)t);
    flow->force = vm_add(vector(2 * s, c, -1), vm_scale(R(-.5), vmi_get3(y + VM_Y_P)));
    flow->moment = vector(.1 * c, .2, -.1 * s);
    return 0;
}

static inline void scene_init(scene *k)
{
    int i;
    memset(k, 0, sizeof *k);
    k->body = case_e1();
    k->body.q = quaternion(.5, -.4, .7, .2);
    k->body.r = vector(1, -2, .5);
    for (i = 0; i < SCENE_STREAMS; i++) {
        vm_stream *s = k->streams + i;
        s->motion = i;
        s->rate = R(i % 2 ? .3 + .1 * i : -.4 + .05 * i);
        s->at = vector(.5 - .2 * i, .1 * i - .3, .4 - .3 * i);
        s->velocity = vector(.7 * i - 1, .2 + i, .5 - .4 * i);
        s->spin = vector(.8 - i, .5, .3 * i);
        s->gyration = tensor(.1, .12 + .01 * i, .09, .005 * i, -.02, .015);
    }
    k->flow.n = SCENE_STREAMS;
    k->flow.streams = k->streams;
    k->flow.update = scene_loads;
    k->flow.centre = vector(.1, .05, -.1);
}

#endif
