/* validation_motions.h - motions that others have integrated: rockets and orbits

   Tests: tests/test_validation.c. */
#ifndef VALIDATION_MOTIONS_H
#define VALIDATION_MOTIONS_H

#include "validation.h"

enum { VALIDATION_LARGEST = 28 }; /* unknowns of the largest system, the Pleiades */

/* Solves y' = f from t0 to t_end by rk87 with the relative tolerance rtol and the absolute one atol, with a number of
   events. rk87 raises rtol to 256 eps where it is smaller. y becomes the state at the end. Returns the time of the end,
   and NaN if the run failed. */
static vm_real validation_run(ode_rhs f, void *ctx, int n, double t0, double t_end, vm_real *y, double rtol,
                              double atol, ode_event *events, int n_events)
{
    vm_real work[RK87_WORK(VALIDATION_LARGEST)];
    rk45_options o;
    rk45 s;
    int i, status;
    memset(&o, 0, sizeof o);
    o.rtol = (vm_real)rtol;
    o.atol = (vm_real)atol;
    o.events = events;
    o.n_events = n_events;
    status = rk87_init(&s, f, ctx, n, (vm_real)t0, y, &o, work);
    if (status >= 0) status = rk87_solve(&s, (vm_real)t_end);
    if (status < 0) return VM_NAN;
    for (i = 0; i < n; i++) y[i] = s.y[i];
    return s.t;
}

/* ---- the rocket of CVODE's example ---- */

/* Height y[0], ft, and velocity y[1], ft/s; ctx is the thrust, lbf */
static int cv_rocket_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real thrust = *(const vm_real *)ctx, mass = 11 - t / 10;
    dydt[0] = y[1];
    dydt[1] = thrust / mass - VM_C(0.3) * y[1] - 32;
    return 0;
}

static vm_real cv_rocket_height(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] - 4000;
}

static void cv_rocket_cutoff(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    *(vm_real *)ctx = 0;
}

static vm_real cv_rocket_velocity(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1];
}

typedef struct cv_rocket_flight {
    double cutoff, cutoff_velocity, apogee, height, later_velocity; /* later: t = 69 s */
} cv_rocket_flight;

static cv_rocket_flight cv_rocket_fly(void)
{
    vm_real thrust = 2200, y[2] = {0, 0}, at_cutoff[2], at_apogee[2];
    ode_event events[2];
    cv_rocket_flight flight;
    memset(events, 0, sizeof events);
    events[0].g = cv_rocket_height;
    events[0].direction = 1;
    events[0].action = ODE_RESTART;
    events[0].ctx = &thrust;
    events[0].change = cv_rocket_cutoff;
    events[0].room = 1;
    events[0].states = at_cutoff;
    events[1].g = cv_rocket_velocity;
    events[1].direction = -1;
    events[1].action = ODE_RECORD;
    events[1].room = 1;
    events[1].states = at_apogee;
    validation_run(cv_rocket_rhs, &thrust, 2, 0, 69, y, 1e-13, 1e-13, events, 2);
    flight.cutoff = (double)events[0].t;
    flight.cutoff_velocity = (double)at_cutoff[1];
    flight.apogee = (double)events[1].t;
    flight.height = (double)at_apogee[0];
    flight.later_velocity = (double)y[1];
    return flight;
}

static void validate_cv_rocket(void)
{
    static const validation_group printed = {
        "CVODE's rocket, as printed",
        "the file examples/cvode/serial/cvRocket_dns.out of LLNL/sundials 7.5.0",
        "This example of the integrator CVODE computes the flight of a rocket. We compute the same flight by "
        "`rk87_solve`, an integrator of varmass, which also finds two events, that is, two special moments of the "
        "flight. The first event happens at the height of 4000 ft: the engine stops, and the integration starts again "
        "from this point (`ODE_RESTART`). The second event is the apogee, the highest point of the flight, where the "
        "velocity is 0. The tolerance of `rk87_solve` is 1e-13.",
        "CVODE ran with a relative tolerance of 1e-5 and absolute tolerances of 0.01 ft and 0.1 ft/s in each step, and "
        "the errors of all steps add up. The differences in the table are errors of CVODE: our numbers are more "
        "accurate, as the section \"CVODE's rocket, exactly\" shows.",
        3e-4, 3e-4};
    static const validation_group exact = {
        "CVODE's rocket, exactly",
        "the exact flight of CVODE's rocket, by a formula with an exponential integral, which the Python library "
        "mpmath evaluated to 40 digits",
        "Our numbers are the same as in the previous table, from the same run of `rk87_solve`. Now they are compared "
        "with the exact flight instead of CVODE's numbers: in this table, the column \"published\" has exact numbers, "
        "which we have computed by the formula. If CVODE's numbers are compared with the exact flight, too, the "
        "relative errors of CVODE are found. These errors are 3e-5 in the time of the cutoff (at which the engine "
        "stops), 7e-5 in the time of the apogee and 1.2e-4 in the height of the apogee.",
        "Our run of `rk87_solve` has the tolerance 1e-13 for each step, and the errors of all steps add up.",
        1e-12, 1e-5};
    const cv_rocket_flight flight = cv_rocket_fly();
    validation_begin(&printed);
    validation_row("time of the cutoff, s", "9.9994", flight.cutoff);
    validation_row("velocity at the cutoff, ft/s", "576.7744", flight.cutoff_velocity);
    validation_row("time of the apogee, s", "16.190", flight.apogee);
    validation_row("height of the apogee, ft", "5261.547", flight.height);
    validation_row("velocity at 69 s, ft/s", "-106.6693", flight.later_velocity);
    validation_begin(&exact);
    validation_row("time of the cutoff, s", "9.9997264685447150301", flight.cutoff);
    validation_row("velocity at the cutoff, ft/s", "576.77253186385459927", flight.cutoff_velocity);
    validation_row("time of the apogee, s", "16.191156431937730119", flight.apogee);
    validation_row("height of the apogee, ft", "5262.1559101175937215", flight.height);
    validation_row("velocity at 69 s, ft/s", "-106.66665261745627005", flight.later_velocity);
}

/* ---- Arenstorf's orbit, the Pleiades ---- */

static int arenstorf_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real moon = VM_C(0.012277471), earth = 1 - moon;
    const vm_real to_earth = y[0] + moon, to_moon = y[0] - earth;
    const vm_real d1 = to_earth * to_earth + y[1] * y[1], d2 = to_moon * to_moon + y[1] * y[1];
    const vm_real pull1 = earth / (d1 * VM_SQRT(d1)), pull2 = moon / (d2 * VM_SQRT(d2));
    (void)t;
    (void)ctx;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = y[0] + 2 * y[3] - pull1 * to_earth - pull2 * to_moon;
    dydt[3] = y[1] - 2 * y[2] - pull1 * y[1] - pull2 * y[1];
    return 0;
}

static vm_real arenstorf_height(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1];
}

static void validate_arenstorf(void)
{
    static const validation_group group = {
        "Arenstorf's orbit",
        "equations (0.1) and (0.2) in section II.0 of Hairer, Norsett and Wanner, Solving Ordinary Differential "
        "Equations I, 2nd edition",
        "Arenstorf's orbit is a periodic orbit of a light body that is attracted by two heavy ones. The coordinates of "
        "the light body are y1 and y2; it starts at (y1, y2) = (0.994, 0). We compute the orbit by `rk87_solve` with "
        "the tolerance 6e-14. In a first run, an event finds the end of the period, when y2 changes from positive to "
        "negative. A second run ends after the published period. At the end of this second run the light body must be "
        "back at its start.",
        "The orbit is unstable: an error at the start becomes 14 000 times as large in one period. So an error of "
        "6e-14 at the start becomes almost 1e-9.",
        1e-9, 0};
    vm_real y[4] = {VM_C(0.994), 0, 0, VM_C(-2.00158510637908252240537862224)};
    ode_event back;
    memset(&back, 0, sizeof back);
    back.g = arenstorf_height;
    back.direction = -1;
    validation_run(arenstorf_rhs, NULL, 4, 0, 17.07, y, 6e-14, 1e-15, &back, 1);
    validation_begin(&group);
    validation_row("period", "17.0652165601579625588917206249", (double)back.t);
    y[0] = VM_C(0.994);
    y[1] = y[2] = 0;
    y[3] = VM_C(-2.00158510637908252240537862224);
    validation_run(arenstorf_rhs, NULL, 4, 0, 17.0652165601579625588917206249, y, 6e-14, 1e-15, NULL, 0);
    validation_row("y1 after a period", "0.994", (double)y[0]);
}

/* y holds the 7 x, then the 7 y, then the velocities; star i has the mass i + 1. */
static int pleiades_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    int i, j;
    (void)t;
    (void)ctx;
    for (i = 0; i < 14; i++) {
        dydt[i] = y[14 + i];
        dydt[14 + i] = 0;
    }
    for (i = 0; i < 7; i++)
        for (j = 0; j < 7; j++) {
            const vm_real x = y[j] - y[i], z = y[7 + j] - y[7 + i], square = x * x + z * z;
            const vm_real pull = (vm_real)(j + 1) / (square * VM_SQRT(square));
            if (i == j) continue;
            dydt[14 + i] += pull * x;
            dydt[21 + i] += pull * z;
        }
    return 0;
}

static void validate_pleiades(void)
{
    static const validation_group group = {
        "The Pleiades, seven stars in a plane",
        "the problem plei of the Test Set for IVP Solvers, release 2.4 (Mazzia and Magherini, Bari 2008), reference "
        "solution at t = 3",
        "We compute the motion of the seven stars by `rk87_solve` with the tolerance 6e-14 for all 28 unknowns, which "
        "are coordinates and velocities. The table has the 14 coordinates of the stars, but not their velocities.",
        "Stars 1 and 7 pass each other at a distance of only 0.034, and this enlarges errors: for example, an error of "
        "the coordinate x1 at the start becomes 31 times as large until the end of the motion. The tolerance allows "
        "the integrator an error of 6e-14 in each step; these errors are enlarged, too, and add up. The published "
        "solution has 16 digits, so that its rounding is not important here.",
        1e-10, 0};
    static const char *const published[14] = {
        "0.3706139143970502", "3.237284092057233",  "-3.222559032418324", "0.6597091455775310", "0.3425581707156584",
        "1.562172101400631",  "-0.7003092922212495", "-3.943437585517392", "-3.271380973972550", "5.225081843456543",
        "-2.590612434977470", "1.198213693392275",  "-0.2429682344935824", "1.091449240428980"};
    vm_real y[28] = {3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4, 0, 0, 0, 0, 0, VM_C(1.75), VM_C(-1.5),
                     0, 0, 0, VM_C(-1.25), 1, 0, 0};
    char what[8];
    int i;
    validation_begin(&group);
    validation_run(pleiades_rhs, NULL, 28, 0, 3, y, 6e-14, 6e-14, NULL, 0);
    for (i = 0; i < 14; i++) {
        what[0] = i < 7 ? 'x' : 'y';
        what[1] = (char)('1' + i % 7);
        what[2] = 0;
        validation_row(what, published[i], (double)y[i]);
    }
}

/* ---- Orekit's burn of constant thrust, and Tsiolkovsky ---- */

typedef struct orekit_burn {
    vm_real mu;        /* m^3/s^2 */
    vm_vec3 thrust;    /* N, inertial axes; 0 when the engine is off */
    vm_real mass_rate; /* kg/s */
} orekit_burn;

/* Position, velocity and mass of a spacecraft */
static int orekit_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const orekit_burn *burn = (const orekit_burn *)ctx;
    const vm_real square = y[0] * y[0] + y[1] * y[1] + y[2] * y[2], pull = burn->mu / (square * VM_SQRT(square));
    (void)t;
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = burn->thrust.x / y[6] - pull * y[0];
    dydt[4] = burn->thrust.y / y[6] - pull * y[1];
    dydt[5] = burn->thrust.z / y[6] - pull * y[2];
    dydt[6] = burn->mass_rate;
    return 0;
}

/* The perigee of Orekit's test: a = 24396159 m, e = 0.72831215, i = 7, argument 180 and node 261 degrees; 2500 kg */
static void orekit_start(double mu, vm_real *y)
{
    const double degree = acos(-1) / 180, a = 24396159, e = 0.72831215;
    const double node = 261 * degree, incline = 7 * degree;
    const double r = a * (1 - e), v = sqrt(mu / a * (1 + e) / (1 - e));
    y[0] = (vm_real)(-r * cos(node)); /* the argument of 180 degrees turns the perigee away from the node */
    y[1] = (vm_real)(-r * sin(node));
    y[2] = 0;
    y[3] = (vm_real)(v * sin(node) * cos(incline));
    y[4] = (vm_real)(-v * cos(node) * cos(incline));
    y[5] = (vm_real)(-v * sin(incline));
    y[6] = 2500;
}

/* The state after a coast, the burn and another coast, from 2004-01-01 23:30 to 3800 s after ignition */
static void orekit_fly(double mu, vm_real *y)
{
    const double degree = acos(-1) / 180, alpha = 351 * degree, delta = -7.4978 * degree;
    orekit_burn burn;
    memset(&burn, 0, sizeof burn);
    burn.mu = (vm_real)mu;
    orekit_start(mu, y);
    validation_run(orekit_rhs, &burn, 7, 0, 17134.08, y, 1e-13, 1e-9, NULL, 0);
    burn.thrust.x = (vm_real)(420 * cos(delta) * cos(alpha));
    burn.thrust.y = (vm_real)(420 * cos(delta) * sin(alpha));
    burn.thrust.z = (vm_real)(420 * sin(delta));
    burn.mass_rate = (vm_real)(-420 / (318 * 9.80665));
    validation_run(orekit_rhs, &burn, 7, 0, 3653.99, y, 1e-13, 1e-9, NULL, 0);
    memset(&burn.thrust, 0, sizeof burn.thrust);
    burn.mass_rate = 0;
    validation_run(orekit_rhs, &burn, 7, 3653.99, 3800, y, 1e-13, 1e-9, NULL, 0);
}

static void validate_orekit(void)
{
    static const validation_group group = {
        "Orekit's burn of constant thrust, the mass",
        "the repository CS-SI/Orekit, commit 0104345c (2020), test testRoughBehaviour in "
        "ConstantThrustManeuverTest.java",
        "In this test of Orekit, a library for space flight, an engine changes the orbit of a spacecraft. We compute "
        "the flight by `rk87_solve` in three parts. First the spacecraft flies without thrust for 17134.08 s. Then the "
        "engine burns for 3653.99 s with a thrust of 420 N and a specific impulse of 318 s. After this the spacecraft "
        "flies without thrust again, until 3800 s after ignition. The exhaust velocity is the specific impulse times "
        "g0 = 9.80665 m/s^2.",
        "Orekit prints 16 digits, but the last of them are not exact: Orekit's integrator and ours compute the mass "
        "step by step, and the rounding errors of all steps add up.",
        1e-13, 3e-5};
    static const validation_group orbit = {
        "Orekit's burn of constant thrust, the orbit",
        "the same commit and test of Orekit as in the previous table",
        "Our numbers are from the same run of `rk87_solve` as the mass in the previous table. Before the burn the "
        "orbit has the semi-major axis a = 24396159 m, the eccentricity e = 0.72831215 and an inclination of 7 "
        "degrees. The direction of the thrust has the right ascension 351 degrees and the declination -7.4978 degrees.",
        "Orekit prints the inclination after the burn, 2.6872 degrees, to 1e-4 degrees, and the semi-major axis, "
        "28970 km, to 1 km. In both cases a unit of the last digit is about 4e-5 of the value.",
        4e-5, 4e-5};
    const double degree = acos(-1) / 180, mu = 3.9860047e14;
    vm_real y[7];
    double r, v2, hx, hy, hz;
    orekit_fly(mu, y);
    r = sqrt((double)(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]));
    v2 = (double)(y[3] * y[3] + y[4] * y[4] + y[5] * y[5]);
    hx = (double)(y[1] * y[5] - y[2] * y[4]);
    hy = (double)(y[2] * y[3] - y[0] * y[5]);
    hz = (double)(y[0] * y[4] - y[1] * y[3]);
    validation_begin(&group);
    validation_row("mass after the burn, kg", "2007.8824544261233", (double)y[6]);
    validation_begin(&orbit);
    validation_row("inclination, degrees", "2.6872", acos(hz / sqrt(hx * hx + hy * hy + hz * hz)) / degree);
    validation_row("semi-major axis, km", "28970", 1e-3 / (2 / r - v2 / mu));
}

static void validate_tsiolkovsky(void)
{
    static const validation_group group = {
        "Tsiolkovsky's rocket",
        "Wikipedia, Tsiolkovsky rocket equation, section Examples (read in 2026)",
        "We call `vm_tsiolkovsky(0, 1, m, -4500)`. Its arguments are the velocity at the start, 0; the mass at the "
        "start, which is taken as 1; the mass m at the end; and the velocity of the exhaust relative to the rocket, "
        "which is 4500 m/s backward and therefore negative. The propellant is the part 1 - m of the mass. The first "
        "row of the table is for a rocket that reaches an orbit with one stage. The other two rows are for the two "
        "stages of a second rocket.",
        "The published fractions of propellant, such as 0.884 in the first row, have three decimals. So the fraction m "
        "= 1 - 0.884 = 0.116 has a relative error of up to 0.4 %. The velocity is proportional to ln(1/m). Therefore "
        "the relative error of the velocity is smaller: it is 0.4 % divided by 2.2, the value of ln(1/0.116), and so "
        "it is 0.2 %.",
        2e-3, 2e-3};
    validation_begin(&group);
    validation_row("velocity with 88.4 % of propellant, m/s", "9700", (double)vm_tsiolkovsky(0, 1, VM_C(0.116), -4500));
    validation_row("velocity with 67.1 % of propellant, m/s", "5000", (double)vm_tsiolkovsky(0, 1, VM_C(0.329), -4500));
    validation_row("velocity with 64.8 % of propellant, m/s", "4700", (double)vm_tsiolkovsky(0, 1, VM_C(0.352), -4500));
}

static void validate_motions(void)
{
    validate_tsiolkovsky();
    validate_cv_rocket();
    validate_orekit();
    validate_arenstorf();
    validate_pleiades();
}

#endif
