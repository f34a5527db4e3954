/* varmass.h, chapter 3.3.2: the rotor before and after it breaks */

static vm_broken_rotor some_rotor(vm_real s)
{
    vm_broken_rotor r;
    r.mass = uniform(1, 5);
    r.inertia = uniform(1, 3);
    r.stiffness = uniform(10, 40);
    r.damping = uniform(VM_C(0.1), 1);
    r.torque = uniform(1, 5);
    r.s = s;
    return r;
}

static void fold_break(const vm_broken_rotor_break *b)
{
    fold_all(6, b->state);
    fold_all(6, b->piece);
    fold(b->rest.inertia);
    fold(b->stop_inertia);
    fold(b->dragging);
    fold(b->gamma);
    fold(b->beta);
    fold(b->normal);
    fold(b->tangential);
    fold(b->spin_piece);
    fold(b->spin_rest);
}

static void try_rotor(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_broken_rotor whole = some_rotor(0), rest = some_rotor(VM_C(0.125));
        const vm_real t = uniform(0, 3), Omega = uniform(0, 6);
        vm_broken_rotor_piece piece;
        vm_broken_rotor_break broken;
        vm_real y[6], z[6], im[6];
        piece.mass = whole.mass / 8;
        piece.inertia = uniform(0, VM_C(0.1));
        piece.distance = VM_C(0.25);
        piece.alpha = uniform(-1, 1);
        piece.radius = 1;
        piece.contact = uniform(-3, 3);
        draw_all(6, -1, 1, y);
        CLEAR(z);
        CLEAR(im);
        fold_int(vm_broken_rotor_free_motion(&whole, t, y, z));
        fold_all(6, z);
        fold_int(vm_broken_rotor_orbit(&whole, y, z));
        fold_all(4, z);
        fold_int(vm_broken_rotor_linear(&rest, t / 4, y, z));
        fold_all(6, z);
        fold_int(vm_broken_rotor_linear_uncoupled(&rest, t, y, z));
        fold_all(6, z);
        fold_int(vm_broken_rotor_to_polar(y, z));
        fold_all(6, z);
        fold_int(vm_broken_rotor_from_polar(z, z));
        fold_all(6, z);
        fold_int(vm_broken_rotor_characteristic(&rest, Omega, z));
        fold_all(6, z);
        fold_int(vm_broken_rotor_eigenvalues(&rest, Omega, z, im));
        fold_all(5, z);
        fold_all(5, im);
        fold_int(vm_broken_rotor_routh(&rest, Omega, z));
        fold_all(6, z);
        fold(vm_broken_rotor_steady_radius(&rest, Omega));
        fold_int(vm_broken_rotor_is_stable(&rest, Omega));
        fold(vm_broken_rotor_resonance_radius(&rest, 10 * t, Omega + 7));
        fold_int(vm_broken_rotor_free_motion(&rest, t, y, z));
        fold_all(6, z); /* refused, because s is not 0 */
        CLEAR(broken);
        fold_int(vm_broken_rotor_break_off(&whole, y, &piece, &broken));
        fold_break(&broken);
    }
}

static void try_rotor_runs(void)
{
    vm_broken_rotor r = some_rotor(VM_C(0.125));
    vm_real y[6] = {VM_C(0.25), 0, 0, 0, VM_C(0.5), 3}, polar[6];
    fold_int(vm_broken_rotor_to_polar(y, polar));
    integrate(vm_broken_rotor_rhs, &r, 6, 4, y);
    integrate(vm_broken_rotor_polar_rhs, &r, 6, 2, polar);
}

static void golden_rotor(void)
{
    try_rotor();
    try_rotor_runs();
}
