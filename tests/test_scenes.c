/* varmass.h, scenes: the machines of the dissertation's chapter 1 as scenes, by reference numbers (36-digit
   integration or closed forms), balances and limits; what the check refuses. */
#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';
static const double g = 9.81;
enum { MOST = 64 };

static vm_vec3 vec(double x, double y, double z) { return vmi_vec3(R(x), R(y), R(z)); }

/* got against a reference, relative to scale; looser in float */
static void agrees(const char *machine, const char *what, double got, double wanted, double scale, double bound)
{
    check_error(machine, what, "rel", fabs(got - wanted) / scale, is_float ? 3e-4 : bound, wanted, got);
}

static rk45_options tight(void)
{
    rk45_options o;
    memset(&o, 0, sizeof o);
    o.rtol = is_float ? R(1e-6) : R(1e-11);
    o.atol = is_float ? R(1e-7) : R(1e-13);
    return o;
}

/* Runs scene on, and fails unless it ends as expected */
static void run(vm_scene *scene, vm_real *t, double t_end, vm_real *y, int expected)
{
    static vm_real work[VM_SCENE_WORK(MOST)];
    const rk45_options o = tight();
    const int status = vm_scene_run(scene, t, R(t_end), y, work, &o);
    if (status != expected) printf("%s instead of %s\n", vm_strerror(status), vm_strerror(expected));
    CHECK(status == expected);
}

static void start(vm_scene *scene, vm_real *y)
{
    int culprit;
    const int status = vm_scene_start(scene, 0, y, &culprit);
    if (status) printf("%s, %d\n", vm_strerror(status), culprit);
    CHECK(status == VM_OK);
    CHECK(vm_scene_size(scene) <= MOST);
}

static void balanced(const char *machine, vm_scene *scene, double t, const vm_real *y, double size)
{
    vm_book book;
    vm_scene_balance(scene, R(t), y, &book);
    agrees(machine, "momentum", (double)book.momentum_defect.x, 0, size, 1e-9);
    agrees(machine, "angular", (double)book.angular_defect.z, 0, size, 1e-9);
    agrees(machine, "energy", (double)book.energy_defect, 0, size * size, 1e-9);
}

/* ---- A wagon that fills, then empties while it moves (Fig. 6) ---- */

static void wagon(void)
{
    const double F = 15000, f = 0.005;
    vm_scene_body bodies[1];
    vm_effect effects[4];
    vm_event events[2];
    ode_event located[2];
    vm_book book;
    vm_scene scene = {bodies, 1, effects, 4, events, located, 2, &book, NULL, NULL, 0, NULL, 0, 0};
    vm_real y[3 + VM_BOOK], t = 0;
    bodies[0] = vm_scene_with_mass_state(vm_scene_line(20000, 0, 0));
    effects[0] = vm_effect_drive(0, 0, R(F), 0);
    effects[1] = vm_effect_gravity(0, 0, R(-f * g));
    effects[2] = vm_effect_stream(0, 400, vec(0, 0, 0), 0);  /* falls in without velocity */
    effects[3] = vm_effect_stream(0, -400, vec(0, 0, 0), 1); /* leaves with the wagon's */
    effects[3].off = 1;
    events[0] = vm_then_switch(vm_event_at(60), 2, 1);
    events[1] = vm_then_switch(vm_event_at(60), 3, 0);
    start(&scene, y);
    CHECK(vm_scene_size(&scene) == 3 + VM_BOOK);
    run(&scene, &t, 60, y, VM_OK);
    agrees("wagon", "v(60)", (double)y[1], 18.3141818181818182, 18, 1e-10);
    agrees("wagon", "x(60)", (double)y[0], 702.264741224327747, 702, 1e-10);
    run(&scene, &t, 120, y, VM_OK);
    agrees("wagon", "v(120)", (double)y[1], 44.9383328318419495, 45, 1e-10);
    agrees("wagon", "x(120)", (double)y[0], 2484.46809963223027, 2484, 1e-10);
    agrees("wagon", "M(120)", (double)y[2], 20000, 20000, 1e-12);
    balanced("wagon", &scene, 120, y, 1e6);
}

/* ---- Wagon turner and tippler (Figs 4, 5) ---- */

typedef struct machine {
    double J, rho2, m0, fa, fb, lam, torque, kappa, S0, e, phase; /* phase: of sin(phi + phase) */
} machine;

static double load_of(const machine *a, double phi)
{
    return phi <= a->fa ? a->m0 : phi < a->fb ? a->m0 * (a->fb - phi) / (a->fb - a->fa) : 0;
}

static vm_mass_now turner_inertia(vm_real t, vm_real phi, vm_real w, void *ctx)
{
    const machine *a = (const machine *)ctx;
    vm_mass_now now = {0, 0, 0, 0};
    (void)t, (void)w;
    now.mass = R(a->J + load_of(a, (double)phi) * a->rho2);
    now.by_x = (double)phi > a->fa && (double)phi < a->fb ? R(-a->m0 / (a->fb - a->fa) * a->rho2) : 0;
    return now;
}

static vm_real turner_weight(vm_real t, vm_real phi, vm_real w, void *ctx)
{
    const machine *a = (const machine *)ctx;
    (void)t, (void)w;
    return R(-g * (a->S0 + load_of(a, (double)phi) * a->e) * sin((double)phi + a->phase));
}

static int go_on(vm_real t, vm_real *y, void *ctx) /* past a kink the integrator begins anew */
{
    (void)t, (void)y, (void)ctx;
    return VM_OK;
}

static void turned(const char *name, machine a, double end, const double *wanted)
{
    vm_scene_body bodies[1];
    vm_effect effects[3];
    vm_event events[3];
    ode_event located[3];
    vm_scene scene = {bodies, 1, effects, 3, events, located, 3, NULL, NULL, NULL, 0, NULL, 0, 0};
    vm_real y[2], t = 0;
    bodies[0] = vm_scene_axle(R(a.J), 0, 0);
    effects[0] = vm_effect_mass_law(0, turner_inertia, &a, vec(0, 0, 0), R(a.lam));
    effects[1] = vm_effect_drive(0, 0, R(a.torque), R(a.kappa));
    effects[2] = vm_effect_user(0, 0, turner_weight, &a);
    events[0] = vm_then_user(vm_event_position(0, 0, R(a.fa), 1), go_on, NULL);
    events[1] = vm_then_user(vm_event_position(0, 0, R(a.fb), 1), go_on, NULL);
    events[2] = vm_then_stop(vm_event_position(0, 0, R(end), 1));
    start(&scene, y);
    run(&scene, &t, 100, y, VM_STOPPED);
    agrees(name, "t(fe)", (double)t, wanted[0], wanted[0], 1e-9);
    agrees(name, "omega(fe)", (double)y[1], wanted[1], wanted[1], 1e-9);
    CHECK(events[0].count == 1 && events[1].count == 1 && events[2].count == 1);
    agrees(name, "t(fa)", (double)located[0].t, wanted[2], wanted[2], 1e-9);
    agrees(name, "t(fb)", (double)located[1].t, wanted[3], wanted[3], 1e-9);
}

static void turner_and_tippler(void)
{
    static const double turner1[] = {1.84635466780631226, 3.49657701427779438, 0.935243640966713213, 1.72148286930201990};
    static const double turner0[] = {1.65266180857531229, 5.08838958676841132, 0.935243640966713213, 1.57096928895626423};
    static const double tippler1[] = {2.94061464196003694, 2.94501866090748102, 2.29797127153406406, 2.82799467054110647};
    static const double tippler0[] = {2.87481763951049489, 3.41954037098936233, 2.29797127153406406, 2.78060294422291351};
    machine a = {60000, 0.4 * 0.4 + 0.9, 60000, 0.9, 2.5, 1, 300000, 0, 5000, 0.4, 0};
    machine b = {90000 + 9000, 0.8 * 0.8 + 0.5, 40000, 0.8, 1.6, 1, 380000 + 9000 * 9.81, 0, 12000, 0.8, 1.5707963267948966};
    turned("turner", a, 2.9, turner1);
    a.lam = 0;
    turned("turner", a, 2.9, turner0);
    turned("tippler", b, 1.9, tippler1);
    b.lam = 0;
    turned("tippler", b, 1.9, tippler0);
}

/* ---- The mercury regulator, J(omega) (Fig. 9) ---- */

static void regulator(void)
{
    const double J0 = 0.1087304, cc = 0.000280630733944954128, h0 = 0.12, rate = 0.15 * 0.15 / (2 * g) * 0.5;
    const double off = sqrt((h0 - 0.02) / rate), on = sqrt((h0 - 0.05) / rate);
    vm_scene_body bodies[1];
    vm_effect effects[3];
    vm_event events[2];
    ode_event located[2];
    vm_scene scene = {bodies, 1, effects, 3, events, located, 2, NULL, NULL, NULL, 0, NULL, 0, 0};
    vm_real y[2], t = 0;
    bodies[0] = vm_scene_axle(R(J0), 0, 0);
    effects[0] = vm_effect_mass(0, VM_MASS_OF_V2, R(cc), 0, 0);
    effects[1] = vm_effect_drive(0, 0, 2, 0);
    effects[2] = vm_effect_drive(0, 0, R(-0.5), 0);
    events[0] = vm_then_switch(vm_event_velocity(0, 0, R(off), 1), 1, 1);
    events[1] = vm_then_switch(vm_event_velocity(0, 0, R(on), -1), 1, 0);
    start(&scene, y);
    run(&scene, &t, 10, y, VM_OK);
    CHECK(events[0].count >= 3 && (events[0].count == events[1].count || events[0].count == events[1].count + 1));
    agrees("regulator", "w_off", off, 13.2060592153753422, 13, 1e-13);
    agrees("regulator", "w_on", on, 11.0489818535465068, 11, 1e-13);
    {
        /* from rest at 1.5 net to w_off: J0 w + cc w^3 = 1.5 t; then periods of falling and rising, 4/3 of falling */
        const double first = (J0 * off + cc * off * off * off) / 1.5, falling = 1.00467869117620564;
        const long periods = events[0].count - 1;
        agrees("regulator", "t_off", first, 1.38815403402023141, 1, 1e-13);
        agrees("regulator", "last off", (double)located[0].t, first + 4. / 3 * falling * (double)periods, 10, 1e-9);
    }
}

/* ---- Mass laws in position or velocity, Cayley's heap ---- */

static void laws(void)
{
    vm_scene_body bodies[1];
    vm_effect effects[2];
    vm_event events[1];
    ode_event located[1];
    vm_scene scene = {bodies, 1, effects, 2, events, located, 1, NULL, NULL, NULL, 0, NULL, 0, 0};
    vm_real y[2], t = 0;
    bodies[0] = vm_scene_line(2, 0, 1);
    effects[0] = vm_effect_mass(0, VM_MASS_OF_X, R(0.5), 0, 0);
    effects[1] = vm_effect_drive(0, 0, 3, 0);
    events[0] = vm_then_stop(vm_event_position(0, 0, 4, 1));
    start(&scene, y);
    run(&scene, &t, 100, y, VM_STOPPED);
    agrees("M(x), u = 0", "v", (double)y[1], 2.17944947177033678, 2, 1e-10);
    agrees("M(x), u = 0", "t", (double)t, 2.23926596236044903, 2, 1e-10);
    effects[0] = vm_effect_mass(0, VM_MASS_OF_X, R(0.5), 0, 1);
    start(&scene, y), t = 0;
    run(&scene, &t, 100, y, VM_STOPPED);
    agrees("M(x), u = v", "v", (double)y[1], 3.05250162435982067, 3, 1e-10);
    agrees("M(x), u = v", "t", (double)t, 1.86340930588489411, 2, 1e-10);
    bodies[0] = vm_scene_line(1, 1, 0);
    effects[0] = vm_effect_mass(0, VM_MASS_OF_V2, R(0.5), 0, 0);
    effects[1] = vm_effect_spring(0, 0, VM_GROUND, 0, 4, 1, 0);
    events[0] = vm_then_stop(vm_event_position(0, 0, 0, -1));
    start(&scene, y), t = 0;
    run(&scene, &t, 100, y, VM_STOPPED);
    agrees("M(v)", "t", (double)t, 1.02853058341060403, 1, 1e-10);
    agrees("M(v)", "v", (double)y[1], -1.31796592658636647, 1, 1e-10);
    bodies[0] = vm_scene_line(1, 0, 0); /* M + M'(v) v = 0: stops there, where F t = (M0 - b v^2) v has its maximum */
    effects[0] = vm_effect_mass(0, VM_MASS_OF_V2, R(-0.5), 0, 0);
    effects[1] = vm_effect_drive(0, 0, 3, 0);
    start(&scene, y), t = 0;
    run(&scene, &t, 10, y, VM_SINGULAR);
    agrees("M(v) singular", "t", (double)t, 0.181443684650605785, 1, 1e-6);
    bodies[0] = vm_scene_line(R(0.1), R(0.1), 0); /* links of 1 kg/m taken up from rest by the part that hangs */
    effects[0] = vm_effect_mass(0, VM_MASS_OF_X, 1, 0, 0);
    bodies[0].start.mass = R(1e-30); /* M = x */
    effects[1] = vm_effect_gravity(0, 0, R(g));
    events[0] = vm_then_stop(vm_event_position(0, 0, 2, 1));
    start(&scene, y), t = 0;
    run(&scene, &t, 100, y, VM_STOPPED);
    agrees("Cayley", "t", (double)t, 0.921289371977640962, 1, 1e-10);
    agrees("Cayley", "v", (double)y[1], 3.61640221767435598, 3, 1e-10);
}

int main(void)
{
    wagon();
    turner_and_tippler();
    regulator();
    laws();
    return check_finish("scenes");
}
