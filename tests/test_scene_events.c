/* varmass.h, scenes: events. Events that only count, several at one instant, lists of actions, endless ones; and jumps of
   bodies of all motions, against closed forms, the jumps of chapter 3 and the balances of momentum and energy. */
#include "stage_check.h"

/* ---- Events that only count ---- */

static void oscillator(stage *s)
{
    stage_clear(s, 20);
    stage_body(s, vm_scene_body_line(1, 0, 1));
    stage_effect(s, vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1, 0));
}

static vm_real beyond_half(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] - REAL(0.5);
}

/* Events without an action count the zeros of x = sin t and of its velocity, and keep the time of the last one; where
   s.located[i] has room, the times of all. A second run goes on counting. */
static void check_counting(void)
{
    const double pi = acos(-1.0);
    vm_real times[4] = {0, 0, 0, 0};
    stage s;
    int k;
    oscillator(&s);
    vm_scene_keep_budget(&s.scene, NULL);
    stage_event(&s, vm_event_position(0, 0, 0, 0));
    stage_event(&s, vm_event_position(0, 0, 0, 1));
    stage_event(&s, vm_event_user(beyond_half, NULL, -1));
    stage_event(&s, vm_event_velocity(0, 0, 0, 0));
    begin(&s);
    s.located[0].times = times;
    s.located[0].room = 4;
    run(&s, 10, VM_OK);
    CHECK(s.events[0].count == 3 && s.events[1].count == 1 && s.events[2].count == 2 && s.events[3].count == 3);
    agrees("counting", "last", s.events[0].time, 3 * pi, 10, 1e-10);
    agrees("counting", "last beyond 1/2", s.events[2].time, 2 * pi + 5 * pi / 6, 10, 1e-10);
    for (k = 0; k < 3; k++) agrees("counting", "times", times[k], (k + 1) * pi, 10, 1e-10);
    run(&s, 20, VM_OK);
    CHECK(s.events[0].count == 6 && s.events[1].count == 3);
    agrees("counting", "last", s.events[0].time, 6 * pi, 20, 1e-10);
}

/* The motion has the same bits with events that only count as without them. */
static void check_counted_motion(void)
{
    vm_real without[STAGE_STATE];
    stage s;
    oscillator(&s);
    vm_scene_keep_budget(&s.scene, NULL);
    begin(&s);
    run(&s, 20, VM_OK);
    memcpy(without, s.y, sizeof without);
    oscillator(&s);
    vm_scene_keep_budget(&s.scene, NULL);
    stage_event(&s, vm_event_position(0, 0, 0, 0));
    stage_event(&s, vm_event_velocity(0, 0, 0, 0));
    begin(&s);
    run(&s, 20, VM_OK);
    CHECK(s.t == 20 && memcmp(without, s.y, sizeof without) == 0);
}

/* An event that may happen three times is counted three times. */
static void check_most(void)
{
    stage s;
    oscillator(&s);
    stage_event(&s, vm_event_position(0, 0, 0, 0));
    s.events[0].most = 3;
    stage_event(&s, vm_event_at(7));
    stage_event(&s, vm_then_stop(vm_event_at(REAL(18.5))));
    begin(&s);
    run(&s, 20, VM_STOPPED);
    CHECK(s.events[0].count == 3 && s.events[1].count == 1 && s.t == REAL(18.5));
    agrees("counting", "third", s.events[0].time, 3 * acos(-1.0), 10, 1e-10);
    balanced(&s, "counting", 1, 1);
}

/* ---- Several events at one instant ---- */

/* Each event that happens appends its number to *order, as a decimal digit. */
typedef struct note {
    int *order, number;
} note;

static int take_down(vm_real t, vm_real *y, void *ctx)
{
    const note *n = (const note *)ctx;
    (void)t;
    (void)y;
    *n->order = *n->order * 10 + n->number;
    return VM_OK;
}

static int take_down_and_stop(vm_real t, vm_real *y, void *ctx)
{
    take_down(t, y, ctx);
    return (int)VM_STOPPED;
}

/* A crossing at the instant of two events at a given time, one of which ends the run: all happen, in their order. */
static void check_same_instant(void)
{
    int order = 0;
    note one, two, three;
    stage s;
    one.order = two.order = three.order = &order;
    one.number = 1;
    two.number = 2;
    three.number = 3;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_line(1, -1, 1));
    stage_event(&s, vm_then_user(vm_event_at(1), take_down_and_stop, &one));
    stage_event(&s, vm_then_user(vm_event_position(0, 0, 0, 1), take_down, &two));
    stage_event(&s, vm_then_user(vm_event_at(1), take_down, &three));
    begin(&s);
    run(&s, 2, VM_STOPPED);
    CHECK(s.t == 1 && (order == 123 || order == 13));
    run(&s, 2, VM_OK); /* a crossing that rounding has put after t = 1 happens now, and none happens twice */
    CHECK(s.events[0].count == 1 && s.events[1].count == 1 && s.events[2].count == 1 && s.t == 2);
}

static vm_real at_094(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0] * y[0] - REAL(0.94) * REAL(0.94);
}

/* Two events have the same zero by different functions. The first switches a damper on, which ends the step; the
   second, which ends the run, must not be lost by that. */
static void check_stop_beside_switch(void)
{
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_line(1, 1, 0));
    stage_effect(&s, vm_effect_linear_spring(0, 0, VM_GROUND, 0, 4, 0));
    stage_effect(&s, vm_effect_damper(0, 0, VM_GROUND, 0, REAL(0.1)));
    s.effects[1].off = 1;
    stage_event(&s, vm_then_switch(vm_event_position(0, 0, REAL(0.94), -1), 1, 0));
    stage_event(&s, vm_then_stop(vm_event_user(at_094, NULL, -1)));
    begin(&s);
    CHECK(vm_scene_run(&s.scene, &s.t, REAL(1.2), s.y, s.work, NULL) == VM_STOPPED);
    CHECK(s.events[0].count == 1 && s.events[1].count == 1);
    agrees("stop beside switch", "t", s.t, acos(0.94) / 2, 1, 1e-5); /* the default tolerance's */
}

/* c (b x - d), in which p has the numbers b, c and d */
static vm_real scaled_height(vm_real t, const vm_real *y, void *ctx)
{
    const vm_real *p = (const vm_real *)ctx;
    (void)t;
    return p[1] * (p[0] * y[0] - p[2]);
}

/* Two events happen where x rises through d/b, one of which ends the run; the other only counts, or has an action that
   does nothing. Whichever of them rounding puts first, the next run does not find one of them again. */
static void check_not_found_again(void)
{
    int i;
    for (i = 0; i < 500; i++) {
        vm_real p[3];
        vm_event other, stops;
        stage s;
        p[0] = REAL(uniform(1, 10));
        p[1] = REAL(uniform(0.1, 10));
        p[2] = p[0] * REAL(uniform(0.05, 0.9));
        other = vm_event_user(scaled_height, p, 1);
        if (i & 1) other = vm_then_user(other, stage_kink, NULL);
        stops = vm_then_stop(vm_event_position(0, 0, p[2] / p[0], 1));
        oscillator(&s);
        vm_scene_keep_budget(&s.scene, NULL);
        stage_event(&s, i & 2 ? other : stops);
        stage_event(&s, i & 2 ? stops : other);
        begin(&s);
        run(&s, 2, VM_STOPPED);
        run(&s, 2, VM_OK);
        CHECK(s.events[0].count == 1 && s.events[1].count == 1);
    }
}

static int fails(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    return -100;
}

/* A crossing at 127/128 s that is only counted is counted although the step in which it is found ends with an error at
   1 s, before or after it in the list; the next run does not count it again. */
static void check_counted_before_error(void)
{
    int error;
    for (error = 0; error < 2; error++) {
        const int crossing = 1 - error;
        int runs;
        stage s;
        stage_clear(&s, 2);
        stage_body(&s, vm_scene_body_line(1, REAL(-127 / 128.), 1));
        if (error == 0) stage_event(&s, vm_then_user(vm_event_at(1), fails, NULL));
        stage_event(&s, vm_event_position(0, 0, 0, 1));
        if (error == 1) stage_event(&s, vm_then_user(vm_event_at(1), fails, NULL));
        begin(&s);
        for (runs = 0; runs < 2; runs++) {
            run(&s, 2, runs ? VM_OK : -100);
            CHECK(s.t == (runs ? 2 : 1) && s.events[error].count == 1 && s.events[crossing].count == 1);
            agrees("counted before error", "t", s.events[crossing].time, 127 / 128., 1, 1e-14);
        }
    }
}

/* ---- Events without end ---- */

/* A ball that leaves the ground with half of its speed each time: it comes to rest after infinitely many contacts. */
static int bounce(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    y[0] = 0;
    y[1] = -y[1] / 2;
    ++*(long *)ctx;
    return VM_OK;
}

/* An event that causes itself */
static int wake(vm_real t, vm_real *y, void *ctx)
{
    stage *s = (stage *)ctx;
    (void)y;
    s->events[0].time = t;
    s->events[0].count = 0;
    s->events[0].most = 0;
    return VM_OK;
}

static void check_endless(void)
{
    long contacts = 0;
    stage s;
    stage_clear(&s, 10);
    stage_body(&s, vm_scene_body_line(1, 1, 0));
    stage_effect(&s, vm_effect_gravity(0, 0, REAL(-gravity)));
    stage_event(&s, vm_then_user(vm_event_position(0, 0, 0, -1), bounce, &contacts));
    begin(&s);
    run(&s, 10, VM_TOO_MANY_EVENTS);
    CHECK(contacts >= (is_float ? 8 : 35) && contacts < 60 && s.y[0] == 0);
    agrees("bouncing", "comes to rest", s.t, 3 * sqrt(2 / gravity), 1, 1e-9); /* t0 (1 + 2 (1/2 + 1/4 + ...)) */
    contacts = 0; /* in a longer run, times have fewer digits: it ends after fewer contacts */
    begin(&s);
    run(&s, 1e6, VM_TOO_MANY_EVENTS);
    CHECK(contacts < (is_float ? 8 : 32));
    stage_clear(&s, 10);
    stage_body(&s, vm_scene_body_line(1, 1, 0));
    stage_event(&s, vm_then_user(vm_event_at(1), wake, &s));
    begin(&s);
    run(&s, 10, VM_TOO_MANY_EVENTS);
    CHECK(s.t == 1);
}

/* ---- Jumps ---- */

/* A body in space loses a part; the part catches a point, and the body then catches the part: no momentum is lost. */
static void check_jumps(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body body, part;
    vm_budget b;
    stage s;
    memset(&body, 0, sizeof body);
    body.mass = 5;
    body.inertia.xx = 2;
    body.inertia.yy = 3;
    body.inertia.zz = 4;
    body.inertia.xy = (vm_real)0.3;
    body.v = stage_vec(1, 2, 3);
    body.omega = stage_vec(0.3, -0.2, 1);
    part = body;
    part.mass = 1;
    part.r = stage_vec(0.4, 0.1, 0);
    part.v = stage_vec(0, 2, 0);
    part.omega = zero;
    part.inertia.xx = part.inertia.yy = part.inertia.zz = (vm_real)0.1;
    part.inertia.xy = 0;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_free(&body));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_free(&body)));
    stage_body(&s, vm_scene_body_point(2, stage_vec(1, 0, 0), stage_vec(0, 1, 1)));
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
    stage_event(&s, vm_then_attach(vm_event_at(2), 1, 2));
    stage_event(&s, vm_then_attach(vm_event_at(2), 0, 1));
    begin(&s);
    CHECK(vm_scene_size(&s.scene) == 13 + 13 + 6 + VM_BUDGET_STATES);
    run(&s, (double)(vm_real)1.5, VM_OK);
    CHECK(!s.bodies[1].away && s.bodies[0].mass == 4);
    vm_scene_budget_at(&s.scene, s.t, s.y, &b);
    balanced(&s, "separation", 10, 10);
    CHECK(VM_FABS(b.jump_energy) > (vm_real)0.1);
    run(&s, 3, VM_OK);
    CHECK(s.bodies[1].away && s.bodies[2].away);
    balanced(&s, "catch", 30, 30);
    agrees("catch", "mass", s.bodies[0].mass, 7, 7, 1e-15);
}

/* Two bodies become one, on a line, where an oblique blow hits them, and on an axle. */
static void check_sticking(void)
{
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_line(2, 0, 3));
    stage_body(&s, vm_scene_body_line(1, 0, 0));
    stage_body(&s, vm_scene_body_axle(2, 0, 3));
    stage_body(&s, vm_scene_body_axle(1, 0, 0));
    stage_event(&s, vm_then_attach(vm_event_at(1), 0, 1));
    stage_event(&s, vm_then_attach(vm_event_at(1), 2, 3));
    s.events[0].external.linear = stage_vec(3, 7, 0);
    s.events[0].external.at.y = 2;
    s.events[0].external.couple.z = 1;
    begin(&s);
    run(&s, 2, VM_OK);
    agrees("sticking", "line", s.y[1], 2 + 1, 1, 1e-15);
    agrees("sticking", "axle", s.y[5], 2, 1, 1e-15);
    agrees("sticking", "x", s.y[0], 2 + 3, 1, 1e-14); /* 3 m at t = 1, together at 2 m, 3 m/s on */
    balanced(&s, "sticking", 10, 10);
}

/* A rod in the plane loses the ball at its end, and catches it again while an impulse from outside acts. */
static void check_plane(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body part = part_of(0.5, 0);
    stage s;
    part.r.x = 1;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_plane(2, 1, zero, REAL(0.5), stage_vec(1, 2, 0), 3));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
    stage_event(&s, vm_then_attach(vm_event_at(2), 0, 1));
    s.events[1].external.linear = stage_vec(1, -1, 5); /* z is perpendicular to the plane, and does not act */
    s.events[1].external.at = stage_vec(2, 1, 4);
    s.events[1].external.couple = stage_vec(3, 2, 0.3);
    begin(&s);
    run(&s, 1.5, VM_OK);
    agrees("plane", "inertia", s.bodies[0].inertia.zz, 1 - 0.5 - 0.5 * 0.5 / 1.5, 1, 1e-14);
    agrees("plane", "omega", s.y[5], 3, 1, 1e-13); /* the part moves on as before */
    balanced(&s, "plane", 10, 10);
    run(&s, 3, VM_OK);
    balanced(&s, "plane, blow", 100, 100);
    CHECK(s.y[2] > REAL(6.3)); /* more than a turn */
    part.inertia.zz = REAL(0.1);
    s.bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, zero, REAL(0.25), zero, 0)); /* a part with an angle */
    s.events[0] = vm_then_separate(vm_event_at(0), 0, 1, &part, 1);
    s.events[1].most = 1;
    s.events[1].count = 0;
    begin(&s);
    run(&s, 0, VM_OK);
    agrees("plane", "part's angle", s.y[8], 0.75, 1, 1e-15);
}

/* A satellite sheds a panel. The attitude and the velocity of the panel are given in the axes of the satellite, which
   are turned by 90 degrees about z. */
static void check_satellite(void)
{
    const double half = sqrt(0.5);
    vm_body craft = part_of(500, 0), panel = part_of(20, 0), now, rest;
    stage s;
    craft.inertia.xx = 200;
    craft.inertia.yy = 250;
    craft.inertia.zz = 300;
    craft.q.w = craft.q.z = REAL(half); /* turned by 90 degrees about z */
    craft.v = stage_vec(1, 0, 0);
    craft.omega = stage_vec(0.1, 0.02, 0.3);
    panel.inertia.xx = 2;
    panel.inertia.yy = 5;
    panel.inertia.zz = 7;
    panel.r = stage_vec(1.5, 0, 0);
    panel.v = stage_vec(0.4, 0, 0); /* pushed off along the craft's x */
    stage_clear(&s, 100);
    stage_body(&s, vm_scene_body_free(&craft));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_free(&panel)));
    stage_event(&s, vm_then_separate(vm_event_at(0), 0, 1, &panel, 1));
    begin(&s);
    run(&s, 0, VM_OK);
    vm_scene_body_at(&s.scene, 1, s.y, &now);
    agrees("satellite", "panel's x", now.r.y, 1.5, 1, 1e-15);
    agrees("satellite", "panel's q", now.q.z, half, 1, 1e-15);
    agrees("satellite", "panel's v", now.v.y, 0.4 + 0 + 0.3 * 0, 1, 1e-15);
    agrees("satellite", "panel's v", now.v.x, 1 - 0.3 * 1.5, 1, 1e-15);
    CHECK(vm_separate(&craft, &now, NULL, &rest) == VM_OK && rest.mass == 480);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("satellite", "omega", now.omega.z, (double)rest.omega.z, 0.3, 1e-14);
    run(&s, 100, VM_OK);
    balanced(&s, "satellite", 3000, 3000);
    panel.q.w = panel.q.x = REAL(half);
    s.events[0].part = panel; /* and turned itself by 90 degrees about x */
    begin(&s);
    run(&s, 0, VM_OK);
    vm_scene_body_at(&s.scene, 1, s.y, &now);
    agrees("satellite", "q", now.q.w, 0.5, 1, 1e-15);
    agrees("satellite", "q", now.q.x, 0.5, 1, 1e-15);
    agrees("satellite", "q", now.q.y, 0.5, 1, 1e-15);
    agrees("satellite", "q", now.q.z, 0.5, 1, 1e-15);
}

/* A rod in space loses the ball at its end. The rod's spin about its own axis stays. */
static void check_rod(void)
{
    vm_body whole = part_of(3, 0), ball = part_of(1, 0), rod;
    const vm_vec3 zero = {0, 0, 0};
    stage s;
    /* the rod, 2 kg and 2 m along x: its inertia 2/3 about y and z; the ball 1 m from its middle, 2/3 m from the
       mass centre: 2/3 (1)^2 more */
    whole.inertia.yy = whole.inertia.zz = REAL(4. / 3);
    whole.omega = stage_vec(5, 0.3, 0.4);
    ball.r.x = REAL(2. / 3);
    ball.v.z = REAL(0.7);
    stage_clear(&s, 10);
    stage_body(&s, vm_scene_body_free(&whole));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &ball, 1));
    begin(&s);
    run(&s, 10, VM_OK);
    balanced(&s, "rod", 10, 10);
    vm_scene_body_at(&s.scene, 0, s.y, &rod);
    agrees("rod", "inertia", rod.inertia.zz, 2. / 3, 1, 1e-14);
    agrees("rod", "spin", s.y[10], 5, 5, 1e-10);
    CHECK(VM_FABS(rod.inertia.xx) < 100 * VM_EPSILON);
}

/* The jumps made for a line and for the plane, of which a program needs less code, give the bits of the general jump.
   */
static void check_special_jumps(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body part = part_of(0.5, 0);
    vm_real general[STAGE_STATE];
    int special, k;
    part.r = stage_vec(0.25, 0.125, 0);
    part.v.x = 1;
    part.omega.z = REAL(0.5);
    for (special = 0; special < 2; special++) {
        stage s;
        stage_clear(&s, 3);
        stage_body(&s, vm_scene_body_plane(2, 1, zero, REAL(0.5), stage_vec(1, 2, 0), 3));
        stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
        stage_body(&s, vm_scene_body_line(3, 1, 2));
        stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
        if (special) {
            stage_event(&s, vm_then_separate_in_plane(vm_event_at(1), 0, 1, &part, 1));
            stage_event(&s, vm_then_attach_in_plane(vm_event_at(2), 0, 1));
            stage_event(&s, vm_then_separate_on_line(vm_event_at(1), 2, 3, &part, 1));
            stage_event(&s, vm_then_attach_on_line(vm_event_at(2), 2, 3));
        } else {
            stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
            stage_event(&s, vm_then_attach(vm_event_at(2), 0, 1));
            stage_event(&s, vm_then_separate(vm_event_at(1), 2, 3, &part, 1));
            stage_event(&s, vm_then_attach(vm_event_at(2), 2, 3));
        }
        begin(&s);
        run(&s, 1.5, VM_OK);
        agrees("special jumps", "v", s.y[s.bodies[3].at + 1], 3, 3, 1e-14); /* 2 m/s, and 1 m/s relative to it */
        agrees("special jumps", "x", s.y[s.bodies[3].at], 1 + 2 + 0.25 + 0.5 * 3, 3, 1e-13);
        agrees("special jumps", "v of the rest", s.y[s.bodies[2].at + 1], (3 * 2 - 0.5 * 3) / 2.5, 2, 1e-14);
        balanced(&s, "special jumps", 10, 10);
        run(&s, 3, VM_OK);
        balanced(&s, "special jumps", 10, 10);
        for (k = 0; k < vm_scene_size(&s.scene); k++) {
            if (special) CHECK(s.y[k] == general[k]);
            else general[k] = s.y[k];
        }
    }
}

/* An axle loses half of its inertia, which turns 1 rad/s faster than the axle, and gets an impulsive torque of 0.25 N m
   s: 0.1 of a couple, and 0.15 of an impulse beside the axle. */
static void check_axle_jump(void)
{
    vm_body part = part_of(1, 0);
    stage s;
    part.omega.z = 1;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_axle(2, REAL(0.5), 3));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_axle(1, 0, 0)));
    stage_event(&s, vm_then_separate_on_line(vm_event_at(1), 0, 1, &part, 1));
    s.events[0].external.couple.z = REAL(0.1);
    s.events[0].external.linear = stage_vec(0.05, 0.25, 0);
    s.events[0].external.at = stage_vec(1, 2, 0);
    begin(&s);
    run(&s, 2, VM_OK);
    agrees("axle jump", "omega", s.y[1], 3 * 2 - 4 + 0.25, 1, 1e-14);
    agrees("axle jump", "omega", s.y[3], 4, 1, 1e-14);
    agrees("axle jump", "angle", s.y[0], 0.5 + 3 + 2.25, 1, 1e-13);
    agrees("axle jump", "angle", s.y[2], 0.5 + 3 + 4, 1, 1e-13);
    balanced(&s, "axle jump", 10, 10);
}

/* A part that is nearly the whole body and has its velocity leaves that of the rest as it is, bit by bit. Two bodies so
   fast that their momentum overflows become one with a finite velocity. */
static void check_extreme_jumps(void)
{
    const double share = 1 - (is_float ? 1e-4 : 1e-9), fast = is_float ? 1e33 : 1e300;
    const vm_body part = part_of(3 * share, 0);
    int k;
    stage s;
    for (k = 0; k < 20; k++) {
        const vm_real v = REAL(uniform(1, 2));
        stage_clear(&s, 1);
        stage_body(&s, vm_scene_body_line(3, 0, v));
        stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
        stage_body(&s, vm_scene_body_axle(3, 0, v));
        stage_body(&s, vm_scene_body_absent(vm_scene_body_axle(1, 0, 0)));
        stage_event(&s, vm_then_separate_on_line(vm_event_at(0), 0, 1, &part, 1));
        stage_event(&s, vm_then_separate_on_line(vm_event_at(0), 2, 3, &part, 1));
        begin(&s);
        run(&s, 0, VM_OK);
        CHECK(s.bodies[0].mass < REAL(1e-3) && s.y[1] == v && s.y[3] == v && s.y[5] == v && s.y[7] == v);
    }
    stage_clear(&s, 1);
    vm_scene_keep_budget(&s.scene, NULL);
    stage_body(&s, vm_scene_body_line(REAL(1e10), 0, REAL(fast)));
    stage_body(&s, vm_scene_body_line(1, 0, REAL(fast)));
    stage_event(&s, vm_then_attach_on_line(vm_event_at(0), 0, 1));
    begin(&s);
    run(&s, 0, VM_OK);
    CHECK(s.bodies[1].away && s.y[1] == REAL(fast));
}

/* ---- Lists of actions ---- */

/* A body between three springs throws off a part at 1 s; a damper is switched on and two springs are switched off at the
   same instant. With listed = 1 one event does all this, else four events do. */
static void staging(stage *s, int listed, vm_event *actions)
{
    vm_body part = part_of(0.5, 0);
    const vm_event now = vm_event_position(0, 0, REAL(0.5), 1);
    int i;
    part.v.x = -1;
    stage_clear(s, 3);
    stage_body(s, vm_scene_body_line(2, 0, 1));
    stage_body(s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    for (i = 1; i < 4; i++) stage_effect(s, vm_effect_linear_spring(0, 0, VM_GROUND, 0, (vm_real)i, REAL(0.25)));
    stage_effect(s, vm_effect_damper(0, 0, VM_GROUND, 0, 1));
    s->effects[3].off = 1;
    actions[0] = vm_then_switch_range(now, 1, 2, 1);
    actions[1] = vm_then_separate_on_line(now, 0, 1, &part, 1);
    actions[2] = vm_then_switch(now, 3, 0);
    if (listed) {
        stage_event(s, vm_then_all(now, actions, 3));
        return;
    }
    stage_event(s, vm_then_switch(now, 1, 1));
    stage_event(s, vm_then_switch(now, 2, 1));
    stage_event(s, actions[1]);
    stage_event(s, actions[2]);
}

/* A list of actions leaves the same bits as the events that do its actions one by one. A second start begins anew. */
static void check_list(void)
{
    vm_event actions[3];
    vm_real apart[STAGE_STATE];
    stage s;
    int again;
    staging(&s, 0, actions);
    begin(&s);
    run(&s, 3, VM_OK);
    memcpy(apart, s.y, sizeof apart);
    staging(&s, 1, actions);
    for (again = 0; again < 2; again++) {
        begin(&s);
        run(&s, 3, VM_OK);
        CHECK(s.events[0].count == 1 && memcmp(apart, s.y, (size_t)vm_scene_size(&s.scene) * sizeof *s.y) == 0);
        CHECK(s.effects[0].idle == 0 && s.effects[1].idle && s.effects[2].idle && s.effects[3].idle == 0);
        balanced(&s, "list", 1, 1);
    }
}

/* An action that stops the run lets the following ones happen; an error ends the list, and is what the run returns. */
static void check_list_ends(void)
{
    const vm_event now = vm_event_at(1);
    vm_event actions[4];
    int order = 0;
    note one, two;
    stage s;
    one.order = two.order = &order;
    one.number = 1;
    two.number = 2;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_line(1, -1, 1));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    actions[0] = vm_then_stop(now);
    actions[1] = vm_then_user(now, take_down, &one);
    actions[2] = vm_then_attach_on_line(now, 0, 1);
    actions[3] = vm_then_user(now, take_down, &two);
    stage_event(&s, vm_then_all(now, actions, 2));
    begin(&s);
    run(&s, 2, VM_STOPPED);
    CHECK(s.t == 1 && order == 1);
    run(&s, 2, VM_OK);
    s.events[0] = vm_then_all(now, actions, 4);
    begin(&s);
    run(&s, 2, VM_IS_AWAY);
    CHECK(s.t == 1 && order == 11);
    s.events[0] = vm_then_all(now, actions, 0); /* an empty list does nothing */
    begin(&s);
    run(&s, 2, VM_OK);
    CHECK(s.events[0].count == 1);
}

/* A landing takes its contact from its event, in a list, too: the body falls 1 m and stays on the ground. */
static void check_landing_in_list(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_contact ground = {{0, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 1e4, 100};
    vm_event touch, actions[2];
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_point(1, stage_vec(0, 1, 0), zero));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-9.81)));
    stage_effect(&s, vm_effect_contact(0, &ground));
    s.effects[1].off = 1;
    touch = vm_event_contact(0, &ground);
    actions[0] = vm_then_land(touch);
    actions[1] = vm_then_switch(touch, 1, 0);
    stage_event(&s, vm_then_all(touch, actions, 2));
    s.events[0].most = 1;
    begin(&s);
    run(&s, 3, VM_OK);
    agrees("landing", "time", s.events[0].time, sqrt(2 / 9.81), 1, 1e-10);
    agrees("landing", "depth", s.y[1], -9.81 / 1e4, 1, 1e-8);
    agrees("landing", "v", s.y[4], 0, 1, 1e-8);
    balanced(&s, "landing", 10, 10);
}

/* A landing in a list at a set time does nothing to a body that is not there, and ends the run. */
static void check_landing_of_absent_body(void)
{
    const vm_contact ground = {{0, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 0, 0};
    vm_event land = vm_then_land(vm_event_contact(1, &ground));
    vm_budget budget;
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(2, stage_vec(0, 1, 0), stage_vec(0, -3, 0))));
    stage_event(&s, vm_then_all(vm_event_at(1), &land, 1));
    begin(&s);
    run(&s, 2, VM_IS_AWAY);
    CHECK(s.t == 1 && s.y[6] == -3); /* the velocity along y of the point */
    CHECK(vm_scene_budget_at(&s.scene, s.t, s.y, &budget) == VM_OK);
    CHECK(size_of(budget.impulse) == 0 && size_of(budget.angular_impulse) == 0 && budget.jump_energy == 0);
}

/* ---- Landings ---- */

/* A bar that turns falls on a point beside its mass centre, which lands. Just after the landing rounding decides the sign
   of the height, but no further landing happens, and an event that only counts the contacts counts one, too. This holds
   for each tolerance: the smaller it is, the shorter are the steps just before the landing. */
static void check_one_landing(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_real least = is_float ? REAL(1e-6) : REAL(1e-12);
    const vm_contact end = {{REAL(0.2), REAL(0.1), 0}, REAL(0.1), {0, 0, 0}, {0, 1, 0}, 1000, 5};
    int turn;
    for (turn = 0; turn < 64; turn++) {
        rk45_options o = rk45_defaults(NULL);
        const vm_real omega = REAL(0.25 * (turn % 8) - 1), angle = REAL(0.7 * (turn / 8));
        for (o.rtol = REAL(1e-4); o.rtol > REAL(0.5) * least; o.rtol /= 10) {
            stage s;
            o.atol = o.rtol;
            stage_clear(&s, 0.6);
            stage_body(&s, vm_scene_body_plane(REAL(1.5), REAL(0.5), stage_vec(0, 1.3, 0), angle, zero, omega));
            stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
            stage_effect(&s, vm_effect_contact(0, &end));
            stage_event(&s, vm_then_land(vm_event_contact(0, &end)));
            stage_event(&s, vm_event_contact(0, &end));
            begin(&s);
            CHECK(vm_scene_run(&s.scene, &s.t, REAL(0.6), s.y, s.work, &o) == VM_OK);
            CHECK(s.events[0].count == 1 && s.events[1].count == 1);
        }
    }
}

/* Two points fall on floors of their own, one after the other. The landing of the first does not delay the second, nor
   an event of another contact of the first point. */
static void check_landings_of_two(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_contact floors[3] = {{{0, 0, 0}, 0, {0, 0, 0}, {0, 1, 0}, 1000, 50},
                                  {{0, 0, 0}, 0, {0, REAL(-1e-6), 0}, {0, 1, 0}, 1000, 50},
                                  {{0, 0, 0}, 0, {0, REAL(-1e-5), 0}, {0, 1, 0}, 0, 0}};
    stage s;
    int i;
    stage_clear(&s, 1);
    for (i = 0; i < 2; i++) {
        stage_body(&s, vm_scene_body_point(1, stage_vec(0, 1, 0), zero));
        stage_effect(&s, vm_effect_gravity(i, 1, REAL(-gravity)));
        stage_effect(&s, vm_effect_contact(i, &floors[i]));
        stage_event(&s, vm_then_land(vm_event_contact(i, &floors[i])));
    }
    stage_event(&s, vm_event_contact(0, &floors[2]));
    begin(&s);
    run(&s, 1, VM_OK);
    CHECK(s.events[0].count == 1 && s.events[1].count == 1 && s.events[2].count >= 1);
}

/* A point without weight flies to an oblique wall and slides along it. It lands once, although the run has many parts, at
   whose beginnings rounding decides the sign of the height. For a few walls in 2000 the rounding errors of the velocity
   have carried the point away from the wall and back. */
static void check_landing_in_parts(void)
{
    enum { WALLS = 20 };
    long landings = 0;
    int i, part;
    for (i = 0; i < WALLS; i++) {
        vm_contact wall = {{0, 0, 0}, 0, {0, 0, 0}, {1, 0, 0}, 0, 0};
        stage s;
        wall.normal.y = REAL(uniform(-0.3, 0.3));
        stage_clear(&s, 1);
        stage_body(&s, vm_scene_body_point(1, stage_vec(1, uniform(-1, 1), 0), stage_vec(-2, 0, 0)));
        stage_event(&s, vm_then_land(vm_event_contact(0, &wall)));
        begin(&s);
        for (part = 1; part <= 32; part++) run(&s, part / 32., VM_OK);
        landings += s.events[0].count;
    }
    CHECK(landings >= WALLS && landings <= WALLS + 2);
}

static int throw_up(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[4] += 2;
    return VM_OK;
}

/* A ball that rests on the ground after its landing is thrown up twice, and lands after each throw. */
static void check_later_landings(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_contact ground = {{0, 0, 0}, REAL(0.1), {0, 0, 0}, {0, 1, 0}, 20000, 200};
    stage s;
    stage_clear(&s, 4);
    stage_body(&s, vm_scene_body_point(2, stage_vec(0, 1.1, 0), zero));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_contact(0, &ground));
    stage_event(&s, vm_then_land(vm_event_contact(0, &ground)));
    stage_event(&s, vm_then_user(vm_event_at(2), throw_up, NULL));
    stage_event(&s, vm_then_user(vm_event_at(3), throw_up, NULL));
    begin(&s);
    run(&s, 1.9, VM_OK);
    CHECK(s.events[0].count == 1);
    run(&s, 2.9, VM_OK);
    CHECK(s.events[0].count == 2);
    agrees("later landing", "time", s.events[0].time, 2 + 4 / gravity, 1, 1e-3);
    run(&s, 4, VM_OK);
    CHECK(s.events[0].count == 3);
    agrees("later landing", "time", s.events[0].time, 3 + 4 / gravity, 1, 1e-3);
}

int main(void)
{
    check_one_landing();
    check_landings_of_two();
    check_landing_in_parts();
    check_later_landings();
    check_list();
    check_list_ends();
    check_landing_in_list();
    check_landing_of_absent_body();
    check_counting();
    check_counted_motion();
    check_most();
    check_same_instant();
    check_stop_beside_switch();
    check_not_found_again();
    check_counted_before_error();
    check_endless();
    check_jumps();
    check_sticking();
    check_plane();
    check_satellite();
    check_rod();
    check_special_jumps();
    check_axle_jump();
    check_extreme_jumps();
    return check_finish("scene events");
}
