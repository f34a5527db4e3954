/* integrators.h: fixed and adaptive steps, dense output, events of every kind, restarts, what is refused */

static int duffing(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0] - VM_C(0.01) * y[1];
    return 0;
}

static int leaves_its_domain(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = -1 / y[0];
    return y[0] < VM_C(0.25) ? 5 : 0;
}

static void try_rk4(void)
{
    vm_real y[2] = {1, 0}, low[2] = {0, 0}, work[RK4_WORK(2)], t = 0;
    fold_int(rk4_step(duffing, NULL, 2, 0, VM_C(0.125), y, work));
    fold_all(2, y);
    fold_int(rk4_solve(duffing, NULL, 2, &t, 10, 200, y, work));
    fold(t);
    fold_all(2, y);
    fold_int(rk4_solve_compensated(duffing, NULL, 2, &t, 20, 400, y, low, work));
    fold_all(2, y);
    fold_all(2, low);
    fold_int(rk4_step(NULL, NULL, 2, 0, 1, y, work));
    fold_all(2, y);
    fold_int(rk4_solve(leaves_its_domain, NULL, 1, &t, 30, 100, y, work));
    fold(t);
    fold(y[0]);
}

static vm_real first_component(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    return y[0] - *(const vm_real *)ctx;
}

static void reflected(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[1] = -y[1] * VM_C(0.875);
}

/* Crossings that are recorded, that reflect the motion, and a level that ends the run. */
typedef struct watched {
    vm_real levels[3], times[8], states[16];
    ode_event events[3];
} watched;

static void watch(watched *w, rk45_options *o)
{
    int i;
    memset(w, 0, sizeof *w);
    memset(o, 0, sizeof *o);
    w->levels[0] = 0;
    w->levels[1] = VM_C(0.5);
    w->levels[2] = VM_C(-0.75);
    for (i = 0; i < 3; i++) {
        w->events[i].g = first_component;
        w->events[i].ctx = &w->levels[i];
    }
    w->events[0].room = 8;
    w->events[0].times = w->times;
    w->events[0].states = w->states;
    w->events[1].action = ODE_RESTART;
    w->events[1].direction = 1;
    w->events[1].change = reflected;
    w->events[2].action = ODE_STOP;
    w->events[2].direction = -1;
    w->events[2].checks = 7;
    o->events = w->events;
    o->n_events = 3;
}

static void fold_watched(const watched *w)
{
    int i;
    for (i = 0; i < 3; i++) {
        fold_int(w->events[i].count);
        fold(w->events[i].t);
    }
    for (i = 0; i < 8 && i < w->events[0].count; i++) {
        fold(w->times[i]);
        fold_all(2, w->states + 2 * i);
    }
}

static void fold_run(const rk45 *s)
{
    fold(s->t);
    fold_all(s->n, s->y);
    fold(s->h);
    fold_int(s->steps);
    fold_int(s->rejected);
    fold_int(s->evals);
    fold_int(s->event);
    fold_int(s->rhs_status);
    fold_int(s->stiff);
}

/* y' = rhs from 0 to the end, by rk45 with its defaults: y becomes y(end) */
enum { LARGEST_SYSTEM = VM_FLOW_BALANCED_STATES };
static void integrate(ode_rhs rhs, void *ctx, int n, vm_real end, vm_real *y)
{
    vm_real work[RK45_WORK(LARGEST_SYSTEM)];
    rk45 s;
    fold_int(rk45_init(&s, rhs, ctx, n, 0, y, NULL, work));
    fold_int(rk45_solve(&s, end));
    fold_run(&s);
    memcpy(y, s.y, (size_t)n * sizeof *y);
}

static vm_real within_last_step(const rk45 *s) { return s->t_old + (s->t - s->t_old) * VM_C(0.375); }

static void try_rk45(void)
{
    const vm_real y0[2] = {1, 0}, again[2] = {VM_C(0.25), 1}, small[1] = {1};
    vm_real work[RK45_WORK(2)], y[2] = {7, 8};
    rk45_options o = rk45_defaults(NULL);
    watched w;
    rk45 s;
    int i;
    fold(o.rtol);
    fold(o.atol);
    fold_int(o.max_steps);
    fold_int(rk45_init(&s, duffing, NULL, 2, 0, y0, NULL, work));
    fold_int(rk45_solve(&s, 20));
    fold_run(&s);
    fold_int(rk45_solve_with(&s, duffing, 2, -3));
    fold_run(&s);
    fold_int(rk45_restart(&s, 1, again));
    fold_int(rk45_step(&s));
    fold_run(&s);
    fold_int(rk45_interpolate(&s, within_last_step(&s), y));
    fold_all(2, y);
    fold_int(rk45_interpolate(&s, s.t + 1, y));
    fold_all(2, y); /* refused */
    fold_int(rk87_step(&s));
    fold_run(&s); /* refused: the other method's */
    watch(&w, &o);
    o.rtol = VM_C(1e-5);
    o.h_max = VM_C(0.5);
    fold_int(rk45_init(&s, duffing, NULL, 2, 0, y0, &o, work));
    for (i = 0; i < 4; i++) {
        fold_int(rk45_solve(&s, 30));
        fold_run(&s);
    }
    fold_watched(&w);
    fold_int(rk45_init(&s, leaves_its_domain, NULL, 1, 0, small, NULL, work));
    fold_int(rk45_solve(&s, 3));
    fold_run(&s);
}

static void try_rk87(void)
{
    const vm_real y0[2] = {1, 0}, again[2] = {VM_C(0.25), 1};
    vm_real work[RK87_WORK(2)], y[2] = {7, 8};
    rk87_options o;
    watched w;
    rk87 s;
    int i;
    fold_int(rk87_init(&s, duffing, NULL, 2, 0, y0, NULL, work));
    fold_int(rk87_solve(&s, 20));
    fold_run(&s);
    fold_int(rk87_solve_with(&s, duffing, 2, -3));
    fold_run(&s);
    fold_int(rk87_restart(&s, 1, again));
    fold_int(rk87_step(&s));
    fold_run(&s);
    fold_int(rk87_interpolate(&s, within_last_step(&s), y));
    fold_all(2, y);
    watch(&w, &o);
    fold_int(rk87_init(&s, duffing, NULL, 2, 0, y0, &o, work));
    for (i = 0; i < 4; i++) {
        fold_int(rk87_solve(&s, 30));
        fold_run(&s);
    }
    fold_watched(&w);
}

static void golden_integrators(void)
{
    try_rk4();
    try_rk45();
    try_rk87();
}

/* Output at listed times up to a stop, then saved, and resumed in another run */
static void try_output(int high)
{
    static const vm_real y0[2] = {1, 0};
    vm_real work[RK87_WORK(2)], other_work[RK87_WORK(2)], times[12], rows[24];
    unsigned char bytes[RK87_SAVED(2, 3)];
    rk45_options o;
    watched w, v;
    rk45 s, other;
    int i, done = 0, more = 0;
    watch(&w, &o);
    w.events[0].stop_after = 3;
    for (i = 0; i < 12; i++) times[i] = VM_C(1.5) * (vm_real)i;
    for (i = 0; i < 24; i++) rows[i] = 0;
    fold_int(high ? rk87_init(&s, duffing, NULL, 2, 0, y0, &o, work) : rk45_init(&s, duffing, NULL, 2, 0, y0, &o, work));
    fold_int(high ? rk87_solve_at(&s, 12, times, rows, &done) : rk45_solve_at(&s, 12, times, rows, &done));
    fold_int(done);
    fold_all(24, rows);
    fold_run(&s);
    fold_int(high ? rk87_save(&s, (long)sizeof bytes, bytes) : rk45_save(&s, (long)sizeof bytes, bytes));
    watch(&v, &o);
    v.events[0].stop_after = 3;
    if (high) {
        fold_int(rk87_init(&other, duffing, NULL, 2, 0, y0, &o, other_work));
        fold_int(rk87_resume(&other, (long)sizeof bytes, bytes));
        fold_int(rk87_solve_at(&other, 12 - done, times + done, rows, &more));
    } else {
        fold_int(rk45_init(&other, duffing, NULL, 2, 0, y0, &o, other_work));
        fold_int(rk45_resume(&other, (long)sizeof bytes, bytes));
        fold_int(rk45_solve_at(&other, 12 - done, times + done, rows, &more));
    }
    fold_int(more);
    fold_all(24, rows);
    fold_run(&other);
}

static void golden_output(void)
{
    try_output(0);
    try_output(1);
}
