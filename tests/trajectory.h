/* trajectory.h - the motion of an oscillator by direct integration of its equation of motion, with its turning
   points and zero crossings, and what is measured on them. Include it after oscillator_checks.h. */
#ifndef TRAJECTORY_H
#define TRAJECTORY_H

/* m x'' = -k x|x|^(alpha-1) - (r m' + b) x' + F */
static inline int motion_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_osc_problem *o = (const vm_osc_problem *)ctx;
    vm_real m = 1, m_rate = 0, k = 1, k_rate = 0, force = 0;
    if (vm_law_at(&o->mass, t, &m, &m_rate) || vm_law_at(&o->stiffness, t, &k, &k_rate)) return 1;
    if (o->force) force = o->force(t, y[0], y[1], o->ctx);
    dydt[0] = y[1];
    dydt[1] =
        -(k * R(signed_power((double)y[0], (double)o->alpha)) + (o->reactive * m_rate + o->damping) * y[1]) / m +
        force / m;
    return 0;
}

static inline vm_real zero_x(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static inline vm_real zero_v(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1];
}

enum { ROOM = 400 };
typedef struct trajectory {
    vm_osc_problem o;
    ode_event events[2]; /* turning points, zero crossings */
    vm_real turn_t[ROOM], turn[2 * ROOM], cross_t[ROOM], cross[2 * ROOM];
    rk45 s;
    vm_real work[RK87_WORK(2)];
} trajectory;

static inline void record(ode_event *event, ode_event_function g, vm_real *times, vm_real *states)
{
    event->g = g;
    event->times = times;
    event->states = states;
    event->room = ROOM;
    event->action = ODE_RECORD;
}

/* The motion of this problem from 0 to t, which goes on by rk45_solve */
static inline void follow(trajectory *j, const vm_osc_problem *o, double t)
{
    rk45_options options = {0};
    vm_real y[2];
    memset(j, 0, sizeof *j);
    j->o = *o;
    y[0] = o->x;
    y[1] = o->v;
    record(&j->events[0], zero_v, j->turn_t, j->turn);
    record(&j->events[1], zero_x, j->cross_t, j->cross);
    options.rtol = options.atol = R(by_precision(1e-11, 3e-6));
    options.events = j->events;
    options.n_events = 2;
    options.max_steps = -1;
    CHECK(rk45_init(&j->s, motion_rhs, &j->o, 2, 0, y, &options, j->work) >= 0);
    if (t > 0) CHECK(rk45_solve(&j->s, R(t)) >= 0);
}

static inline double mass_at(const vm_osc_problem *o, vm_real t)
{
    vm_real m = 1, rate = 0;
    CHECK(vm_law_at(&o->mass, t, &m, &rate) == VM_OK);
    return (double)m;
}

/* The amplitude |x| at turning point i, and the speed |x'| at zero crossing i */
static inline double amplitude_at(const trajectory *j, long i) { return fabs((double)j->turn[2 * i]); }
static inline double speed_at(const trajectory *j, long i) { return fabs((double)j->cross[2 * i + 1]); }

/* The amplitude at the last turning point */
static inline double last_amplitude(const trajectory *j) { return amplitude_at(j, j->events[0].count - 1); }

/* The laws A = A0 (m/m0)^-a of the amplitude and x'max = V0 (m/m0)^-v of the largest speed */
typedef struct power_laws {
    double A0, a, V0, v;
} power_laws;

/* Their largest relative errors along the trajectory, up to time t. Turning points lie on either side in turn,
   and zero crossings go either way in turn. */
typedef struct envelope_errors {
    double amplitude, speed;
} envelope_errors;

static inline envelope_errors errors_of_laws(const trajectory *j, double t, power_laws laws)
{
    const double m0 = mass_at(&j->o, 0);
    envelope_errors e = {0, 0};
    long i;
    for (i = 0; i < j->events[0].count && (double)j->turn_t[i] <= t; i++) {
        const double A = laws.A0 * pow(mass_at(&j->o, j->turn_t[i]) / m0, -laws.a);
        if (i > 0) CHECK((j->turn[2 * i] > 0) != (j->turn[2 * i - 2] > 0));
        e.amplitude = fmax(e.amplitude, fabs(A / amplitude_at(j, i) - 1));
    }
    for (i = 0; i < j->events[1].count && (double)j->cross_t[i] <= t; i++) {
        const double V = laws.V0 * pow(mass_at(&j->o, j->cross_t[i]) / m0, -laws.v);
        if (i > 0) CHECK((j->cross[2 * i + 1] > 0) != (j->cross[2 * i - 1] > 0));
        e.speed = fmax(e.speed, fabs(V / speed_at(j, i) - 1));
    }
    return e;
}

/* The slopes of ln |amplitude| and ln |speed| against ln m, from the first point to the last */
static inline double amplitude_exponent(const trajectory *j)
{
    const long n = j->events[0].count - 1;
    const double first = mass_at(&j->o, j->turn_t[0]), last = mass_at(&j->o, j->turn_t[n]);
    return log(amplitude_at(j, n) / amplitude_at(j, 0)) / log(last / first);
}

static inline double speed_exponent(const trajectory *j)
{
    const long n = j->events[1].count - 1;
    const double first = mass_at(&j->o, j->cross_t[0]), last = mass_at(&j->o, j->cross_t[n]);
    return log(speed_at(j, n) / speed_at(j, 0)) / log(last / first);
}

#endif
