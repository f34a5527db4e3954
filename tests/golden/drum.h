/* varmass.h, chapter 5.2: the drum on a rigid and on an elastic shaft; Lambert's W */

static void try_lambert(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real x = uniform(VM_C(-0.36), 3), l = uniform(-600, 600);
        fold(vm_lambert_w0(x));
        fold(vm_lambert_wm1(x < 0 ? x : -x / 9));
        fold(vm_wright_omega(l));
        fold(vm_lambert_w0_neg_exp(-1 - VM_FABS(l) / 32));
        fold(vm_lambert_wm1_neg_exp(-1 - l * l));
    }
    fold(vm_lambert_w0(-1)); /* outside the domain */
}

static vm_drum some_drum(void)
{
    vm_drum d;
    d.radius = uniform(VM_C(0.5), 1);
    d.mass = uniform(5, 10);
    d.inertia = uniform(2, 4);
    d.band = vm_drum_band(d.radius, VM_C(0.01), 1, 8);
    d.speed = uniform(-1, 4);
    d.damping = uniform(0, 1) / 16;
    d.stiffness = uniform(100, 400);
    d.omega = uniform(2, 4);
    return d;
}

static void try_drum(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_drum d = some_drum();
        const vm_real phi = uniform(0, 6), t = uniform(0, 2), a = uniform(-1, 1);
        vm_drum_geometry g;
        vm_drum_shaft s;
        CLEAR(g);
        CLEAR(s);
        fold_int(vm_drum_at(&d, phi, &g));
        fold(g.mass);
        fold(g.arc_centre);
        fold(g.offset);
        fold(g.axle_inertia);
        fold(g.inertia);
        fold(vm_drum_rate(&d, phi));
        fold(vm_drum_time(&d, phi));
        fold(vm_drum_angle(&d, t));
        fold(vm_drum_angle_lambert(&d, t));
        if (i % 8 == 0) fold(vm_drum_stop(&d)); /* infinite where it is driven */
        fold_int(vm_drum_at(&d, -1, &g));
        fold(g.mass); /* refused */
        fold_int(vm_drum_shaft_init(&s, &d));
        fold(s.k);
        fold(s.delta);
        fold(s.A);
        fold(s.shift);
        fold(vm_drum_deflection(&s, phi, a, t, s.shift));
        fold_int(vm_drum_shaft_valid(&s));
    }
}

static void drum_run(ode_rhs rhs, int n, vm_real end)
{
    vm_drum d = some_drum();
    vm_real y[VM_DRUM_STATES] = {VM_C(0.01), 0, 0, 0, VM_C(0.1), 0};
    y[5] = d.omega;
    integrate(rhs, &d, n, end, y);
}

static void try_drum_runs(void)
{
    drum_run(vm_drum_rhs, VM_DRUM_STATES, 1);
    drum_run(vm_drum_rhs_reduced, VM_DRUM_STATES, 1);
    drum_run(vm_drum_rhs_angle, 4, 5);
}

static void try_elastic_shaft(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_drum d = some_drum();
        const vm_real phi = uniform(0, 6), at_0 = uniform(-1, 1) / 64, slope = uniform(-1, 1) / 64;
        vm_real a = 0, alpha = 0, at[2] = {1, 2}, slopes[2] = {1, 2};
        vm_drum_shaft s;
        CLEAR(s);
        fold_int(vm_drum_shaft_init(&s, &d));
        fold_int(vm_drum_deflection_start(&s, at_0, slope, s.shift, &a, &alpha));
        fold(a);
        fold(alpha);
        fold(vm_drum_deflection_slope(&s, phi, a, alpha, s.shift));
        fold(vm_drum_rate_elastic(&d, phi, at_0));
        fold_int(vm_drum_unbalance(&d, phi, at, slopes));
        fold_all(2, at);
        fold_all(2, slopes);
    }
}

static void try_coupled_run(void)
{
    vm_drum d = some_drum();
    vm_real y[VM_DRUM_COUPLED_STATES] = {VM_C(0.01), 0, 0, 0, 0, 0};
    y[VM_DRUM_RATE] = d.omega;
    integrate(vm_drum_rhs_coupled, &d, VM_DRUM_COUPLED_STATES, 5, y);
}

static void golden_drum(void)
{
    try_lambert();
    try_drum();
    try_drum_runs();
    try_elastic_shaft();
    try_coupled_run();
}
