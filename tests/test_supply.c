/* Chapter 5 of varmass.h: tanks and grains whose mass centre and inertia follow from the mass that is left.
   Oracles: sums over particles, the identities of moments about a fixed point, differences of the cubic polynomials,
   the body that vm_flow_rhs integrates, vm_flow_rhs itself for a scene. */
#include "streams.h"
#include "data/supply_table.h"

static vm_supply some_supply(int kind)
{
    vm_supply s;
    s.kind = kind;
    s.at = vector(.3, -.2, -1.5);
    s.axis = vector(.2, -.4, 1.7);
    s.length = R(2.5);
    s.radius = R(.75);
    s.bore = R(.25);
    s.full = 40;
    return s;
}

/* ---- Sums over particles ---- */

static vm_vec3 unit(vm_vec3 a) { return vm_scale(R(1 / size_of(a)), a); }

/* Sets *centre and *inertia to those of a hollow cylinder of particles: rings of equal mass, each of 8 particles */
static void particles(const vm_supply *s, double length, double bore, double mass, vm_vec3 *centre, vm_inertia *inertia)
{
    enum { RINGS = 20, LAYERS = 200, ROUND = 8 };
    const vm_vec3 e = unit(s->axis), x = unit(vm_cross(e, vector(1, 0, 0))), y = vm_cross(e, x);
    const double m = mass / (RINGS * LAYERS * ROUND), R2 = (double)(s->radius * s->radius), r2 = bore * bore;
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
    int i, j, k;
    *centre = vm_add(s->at, vm_scale(R(length / 2), e));
    for (i = 0; i < RINGS; i++)
        for (j = 0; j < LAYERS; j++)
            for (k = 0; k < ROUND; k++) {
                const double r = sqrt(r2 + (R2 - r2) * (i + .5) / RINGS), z = length * ((j + .5) / LAYERS - .5);
                const double a = 2 * 3.14159265358979324 * k / ROUND;
                const vm_vec3 d = vm_add(vm_scale(R(z), e),
                                          vm_add(vm_scale(R(r * cos(a)), x), vm_scale(R(r * sin(a)), y)));
                xx += m * (double)(d.y * d.y + d.z * d.z);
                yy += m * (double)(d.x * d.x + d.z * d.z);
                zz += m * (double)(d.x * d.x + d.y * d.y);
                xy -= m * (double)(d.x * d.y);
                xz -= m * (double)(d.x * d.z);
                yz -= m * (double)(d.y * d.z);
            }
    *inertia = tensor(xx, yy, zz, xy, xz, yz);
}

static double tensors_apart(const vm_inertia *a, const vm_inertia *b)
{
    const vm_inertia d = vmi_inertia_plus(*a, -1, *b);
    return (double)(vmi_inertia_trace(&d) + VM_FABS(d.xy) + VM_FABS(d.xz) + VM_FABS(d.yz));
}

static void test_particles(int kind)
{
    const vm_supply s = some_supply(kind);
    int i;
    for (i = 1; i <= 8; i++) {
        const double m = 5.0 * i, R2 = .75 * .75, r0 = .25 * .25;
        double length = 2.5, bore = 0;
        vm_supply_left left;
        vm_vec3 centre;
        vm_inertia inertia;
        if (kind == VM_TANK_OF_LIQUID) length *= m / 40;
        if (kind == VM_GRAIN) bore = sqrt(R2 - (R2 - r0) * m / 40); /* its volume is that of the mass */
        memset(&left, 0, sizeof left);
        CHECK(vm_supply_at(&s, R(m), &left) == VM_OK && left.mass == R(m));
        particles(&s, length, bore, m, &centre, &inertia);
        check_error("particles", "centre", "abs", apart(left.centre, centre), PICK(1e-14, 1e-6), kind, m);
        check_error("particles", "inertia", "rel", tensors_apart(&left.inertia, &inertia) / m, 5e-5, kind, m);
        if (kind == VM_TANK_OF_LIQUID)
            check_error("particles", "level", "eps", fabs((double)left.size - length) / eps, 4, m, 0);
        if (kind == VM_GRAIN)
            check_error("particles", "bore", "eps", fabs((double)left.size - bore) / eps, 4, m, 0);
    }
}

/* ---- Identities ---- */

/* d(m c)/dm = s and dI/dm = Q + P(s - c), and the rates by differences, which are exact for polynomials of the third
   degree */
static void test_identities(int kind)
{
    vm_supply s = some_supply(kind);
    int i;
    for (i = 0; i <= 20; i++) {
        const vm_real m = 2 * (vm_real)i, h = 4;
        vm_supply_left left, a, b, c, d;
        vm_vec3 by_mass, store;
        vm_inertia rate, growth;
        memset(&left, 0, sizeof left);
        a = b = c = d = left;
        CHECK(!vm_supply_at(&s, m, &left) && !vm_supply_at(&s, m + h, &a) && !vm_supply_at(&s, m - h, &b));
        CHECK(!vm_supply_at(&s, m + 2 * h, &c) && !vm_supply_at(&s, m - 2 * h, &d));
        by_mass = vm_scale(1 / (2 * h), vm_sub(a.centre, b.centre));
        check_error("differences", "centre", "eps", apart(by_mass, left.centre_by_mass) / eps, 2, kind, i);
        rate = vmi_inertia_plus(vmi_inertia_plus(a.inertia, -1, b.inertia), R(-.125),
                                vmi_inertia_plus(c.inertia, -1, d.inertia));
        memset(&growth, 0, sizeof growth);
        rate = vmi_inertia_plus(growth, 2 / (3 * h), rate);
        check_error("differences", "inertia", "eps", tensors_apart(&rate, &left.inertia_by_mass) / eps, 64, kind, i);
        store = vm_add(left.centre, vm_scale(m, left.centre_by_mass));
        check_error("identity", "d(m c)/dm = s", "eps", apart(store, left.store.at) / eps, 8, kind, i);
        growth = vmi_inertia_plus(left.store.gyration, 1,
                                  vmi_inertia_of_point(vm_sub(left.store.at, left.centre)));
        check_error("identity", "dI/dm = Q + P", "eps", tensors_apart(&growth, &left.inertia_by_mass) / eps, 32, kind,
                    i);
    }
}

/* Full and empty, where the textbook's differences of volumes cancel */
static void test_ends(void)
{
    vm_supply s = some_supply(VM_GRAIN);
    vm_supply_left left;
    memset(&left, 0, sizeof left);
    s.bore = 0;
    CHECK(vm_supply_at(&s, 40, &left) == VM_OK && left.size == 0);
    CHECK(vm_supply_at(&s, 40 * (1 - 4 * VM_EPSILON), &left) == VM_OK); /* the mass is exact */
    check_error("ends", "bore of a full grain", "eps", fabs((double)left.size / (1.5 * sqrt(eps)) - 1) / eps, 4, 0, 0);
    CHECK(vm_supply_at(&s, 0, &left) == VM_OK && left.size == s.radius && vmi_inertia_trace(&left.inertia) == 0);
    s.kind = VM_TANK_OF_LIQUID;
    CHECK(vm_supply_at(&s, 0, &left) == VM_OK && left.size == 0 && vmi_inertia_trace(&left.inertia) == 0);
    CHECK(apart(left.centre, s.at) == 0 && apart(left.store.at, s.at) == 0);
    CHECK(vm_supply_at(&s, 40, &left) == VM_OK && left.size == s.length);
    CHECK(vm_inertia_is_possible(&left.inertia));
}

/* ---- In motion ---- */

/* A body that an engine empties: the structure of mass 10 in the origin, and the supply */
typedef struct emptied {
    vm_supply supply;
    vm_store store;
    vm_stream stream;
    vm_body dry, whole;
    vm_vec3 origin; /* the reference point of the body's axes, from that of the supply */
    int mass_at;    /* index of the mass in the state */
} emptied;

static vm_body with_supply(const emptied *k, vm_real mass)
{
    vm_supply_left left;
    vm_body content = k->dry, whole = k->dry;
    memset(&left, 0, sizeof left);
    CHECK(vm_supply_at(&k->supply, mass, &left) == VM_OK);
    content.mass = mass;
    content.r = left.centre;
    content.inertia = left.inertia;
    if (mass > 0) CHECK(vm_attach(&k->dry, &content, NULL, &whole) == VM_OK);
    return whole;
}

static void emptied_init(emptied *k, int kind, int on_axis)
{
    memset(k, 0, sizeof *k);
    k->supply = some_supply(kind);
    k->dry = case_e1();
    k->dry.mass = 10;
    k->dry.inertia = tensor(6, 6, 2, 0, 0, 0);
    k->dry.q = quaternion(1, 0, 0, 0);
    k->dry.r = k->dry.v = k->dry.omega = vector(0, 0, 0);
    if (on_axis) {
        k->supply.at = vector(0, 0, -1.5);
        k->supply.axis = vector(0, 0, 1);
    }
    k->whole = with_supply(k, k->supply.full);
    k->stream.rate = -10;
    k->stream.at = vector(0, 0, -3);
    k->stream.velocity = vector(0, 0, -50);
    k->stream.gyration = tensor(.01, .01, .02, 0, 0, 0);
    k->stream.from = &k->store;
}

static int follow(vm_real t, const vm_real *y, vm_flow *flow)
{
    emptied *k = (emptied *)flow->ctx;
    vm_supply_left left;
    (void)t;
    if (vm_supply_at(&k->supply, y[VM_Y_MASS] - 10, &left)) return 1;
    k->store = left.store;
    return 0;
}

/* Mass centre and inertia, integrated from the stores, are those of the structure with what is left. */
static void test_flow_of_supply(int kind)
{
    emptied k;
    vm_flow flow;
    vm_body later, wanted;
    vm_real y[VM_FLOW_STATES];
    emptied_init(&k, kind, 0);
    memset(&flow, 0, sizeof flow);
    flow.n = 1;
    flow.streams = &k.stream;
    flow.update = follow;
    flow.ctx = &k;
    flow.centre = k.whole.r;
    later = k.whole;
    k.whole.omega = vector(.3, .2, 1);
    memset(y, 0, sizeof y);
    y[VM_Y_MASS] = k.whole.mass;
    follow(0, y, &flow);
    CHECK(!vm_flow_start(&flow, &k.whole, y) && solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 3) >= 0);
    CHECK(!vm_flow_body(&flow, VM_FLOW_STATES, y, &later));
    wanted = with_supply(&k, 10);
    check_error("vm_flow_rhs", "mass centre", "abs", apart(vmi_get3(y + VM_Y_CENTRE), wanted.r),
                PICK(1e-12, 1e-5), kind, 0);
    check_error("vm_flow_rhs", "inertia", "abs", tensors_apart(&later.inertia, &wanted.inertia),
                PICK(1e-10, 1e-3), kind, 0);
}

static void vary_store(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    emptied *k = (emptied *)ctx;
    vm_supply_left left;
    (void)t;
    if (vm_supply_at(&k->supply, y[k->mass_at] - 10, &left)) return;
    k->store = left.store;
    k->store.at = vm_sub(left.store.at, k->origin);
    stream->from = &k->store;
}

/* A scene with the supply on the axis of the engine moves as vm_flow_rhs does. */
static void test_scene_of_supply(int kind)
{
    emptied k;
    vm_flow flow;
    vm_body wanted, got;
    vm_real y[VM_FLOW_STATES], z[23], work[VM_SCENE_WORK(23)], t = 0;
    vm_scene_body bodies[1];
    vm_effect effects[4];
    vm_scene stage;
    rk45_options options = rk45_defaults(NULL);
    int i;
    emptied_init(&k, kind, 1);
    k.whole.omega = vector(.3, .2, 1);
    memset(&flow, 0, sizeof flow);
    flow.n = 1;
    flow.streams = &k.stream;
    flow.update = follow;
    flow.ctx = &k;
    flow.centre = k.whole.r;
    memset(y, 0, sizeof y);
    y[VM_Y_MASS] = k.whole.mass;
    follow(0, y, &flow);
    wanted = got = k.whole;
    CHECK(!vm_flow_start(&flow, &k.whole, y) && solve(vm_flow_rhs, &flow, VM_FLOW_STATES, y, 0, 3) >= 0);
    CHECK(!vm_flow_body(&flow, VM_FLOW_STATES, y, &wanted));
    k.origin = k.whole.r;
    k.mass_at = 13;
    k.stream.at = vm_sub(k.stream.at, k.origin);
    memset(z, 0, sizeof z);
    z[13] = k.whole.mass;
    vary_store(0, z, &k.stream, &k);
    memset(&stage, 0, sizeof stage);
    bodies[0] = vm_scene_body_growing_free(vm_scene_body_free(&k.whole));
    effects[0] = vm_effect_stream_mass(0, &k.stream);
    effects[1] = vm_effect_stream_force(0, &k.stream);
    effects[2] = vm_effect_stream_moment(0, &k.stream);
    effects[3] = vm_effect_stream_torque(0, &k.stream);
    for (i = 0; i < 4; i++) effects[i] = vm_effect_varying(effects[i], vary_store, &k);
    stage.bodies = bodies;
    stage.n_bodies = 1;
    stage.effects = effects;
    stage.n_effects = 4;
    options.rtol = R(PICK(1e-11, 1e-5));
    options.atol = R(PICK(1e-11, 1e-5));
    CHECK(vm_scene_start(&stage, t, z, NULL) == VM_OK);
    CHECK(vm_scene_run(&stage, &t, 3, z, work, &options) == VM_OK);
    vm_scene_body_at(&stage, 0, z, &got);
    check_error("scene", "r", "abs", apart(got.r, wanted.r), PICK(1e-8, 2e-3), kind, 0);
    check_error("scene", "v", "abs", apart(got.v, wanted.v), PICK(1e-8, 2e-3), kind, 0);
    check_error("scene", "omega", "abs", apart(got.omega, wanted.omega), PICK(1e-9, 2e-4), kind, 0);
    check_error("scene", "inertia", "abs", tensors_apart(&got.inertia, &wanted.inertia), PICK(1e-8, 2e-3), kind, 0);
    k.store.at.x += 1; /* now a flow off the axis, whose angular momentum a scene would neglect */
    k.stream.from = &k.store;
    CHECK(vm_scene_check(&stage, NULL) == VM_STORED_STREAM);
}

/* ---- Refusals ---- */

static void refuse(vm_supply s, vm_real mass, int status)
{
    vm_supply_left left;
    memset(&left, 7, sizeof left);
    CHECK(vm_supply_at(&s, mass, &left) == status);
    CHECK(*(unsigned char *)&left == 7);
}

static void test_refusals(void)
{
    const vm_supply good = some_supply(VM_GRAIN);
    vm_supply s;
    vm_supply_left left;
    CHECK(vm_supply_at(NULL, 1, &left) == VM_BAD_ARGUMENT && vm_supply_at(&good, 1, NULL) == VM_BAD_ARGUMENT);
    refuse(good, VM_NAN, VM_NOT_FINITE);
    s = good;
    s.kind = 3;
    refuse(s, 1, VM_BAD_ARGUMENT);
    s.kind = -1;
    refuse(s, 1, VM_BAD_ARGUMENT);
    s = good;
    s.full = 0;
    refuse(s, 1, VM_BAD_MASS);
    s = good;
    s.axis = vector(0, 0, 0);
    refuse(s, 1, VM_DOMAIN);
    s = good;
    s.bore = s.radius;
    refuse(s, 1, VM_DOMAIN);
    s.bore = -1;
    refuse(s, 1, VM_DOMAIN);
    s.kind = VM_TANK_OF_GAS;
    CHECK(vm_supply_at(&s, 1, &left) == VM_OK); /* the bore is not used */
    s = good;
    s.length = 0;
    refuse(s, 1, VM_DOMAIN);
    s = good;
    s.radius = -1;
    refuse(s, 1, VM_DOMAIN);
    s = good;
    s.radius = VM_MAX;
    refuse(s, 1, VM_NOT_FINITE);
}

/* The largest of n errors, in eps of `scale`; the references are in 20 digits */
static double worst_of(int n, const vm_real *got, const double *wanted, double scale)
{
    double worst = 0;
    int i;
    for (i = 0; i < n; i++) worst = fmax(worst, fabs((double)got[i] - wanted[i]) / (scale * (double)VM_EPSILON));
    return worst;
}

/* Fills got[6] with the entries of a tensor, and returns the largest of those that are wanted. */
static double entries(const vm_inertia *i, const double *wanted, vm_real *got)
{
    double largest = 0;
    int k;
    got[0] = i->xx;
    got[1] = i->yy;
    got[2] = i->zz;
    got[3] = i->xy;
    got[4] = i->xz;
    got[5] = i->yz;
    for (k = 0; k < 6; k++) largest = fmax(largest, fabs(wanted[k]));
    return largest;
}

/* Errors against 40 digits, from 2^-20 of the full mass to 1 - 2^-20 of it: at most 8 eps of |at| + length, of the
   largest entry of a tensor, and of the rate. */
static void test_against_digits(void)
{
    int k;
    for (k = 0; k < VM_LENGTH(supply_table); k++) {
        const double *in = supply_table[k].in, *out = supply_table[k].out;
        const double rate = sqrt(out[4] * out[4] + out[5] * out[5] + out[6] * out[6]);
        const double size = fabs(in[0]) + fabs(in[1]) + fabs(in[2]) + in[6];
        vm_supply s;
        vm_supply_left left;
        vm_real got[6];
        double largest;
        s.kind = supply_table[k].kind;
        s.at = vector(in[0], in[1], in[2]);
        s.axis = vector(in[3], in[4], in[5]);
        s.length = R(in[6]);
        s.radius = R(in[7]);
        s.bore = R(in[8]);
        s.full = R(in[9]);
        CHECK(vm_supply_at(&s, R(in[10]), &left) == VM_OK);
        check_error("digits", "size", "eps", worst_of(1, &left.size, out, out[0]), 8, s.kind, in[10]);
        vmi_set3(got, left.centre);
        check_error("digits", "centre", "eps", worst_of(3, got, out + 1, size), 8, s.kind, in[10]);
        vmi_set3(got, left.centre_by_mass);
        check_error("digits", "centre by mass", "eps", worst_of(3, got, out + 4, rate > 0 ? rate : 1), 8, s.kind, in[10]);
        largest = entries(&left.inertia, out + 7, got);
        check_error("digits", "inertia", "eps", worst_of(6, got, out + 7, largest), 8, s.kind, in[10]);
        largest = entries(&left.inertia_by_mass, out + 13, got);
        check_error("digits", "inertia by mass", "eps", worst_of(6, got, out + 13, largest), 8, s.kind, in[10]);
        vmi_set3(got, left.store.at);
        check_error("digits", "store", "eps", worst_of(3, got, out + 19, size), 8, s.kind, in[10]);
        largest = entries(&left.store.gyration, out + 22, got);
        check_error("digits", "gyration", "eps", worst_of(6, got, out + 22, largest), 8, s.kind, in[10]);
    }
}

int main(void)
{
    test_against_digits();
    int kind;
    for (kind = VM_TANK_OF_LIQUID; kind <= VM_GRAIN; kind++) {
        test_particles(kind);
        test_identities(kind);
        test_flow_of_supply(kind);
        test_scene_of_supply(kind);
    }
    test_ends();
    test_refusals();
    return check_finish("supply");
}
