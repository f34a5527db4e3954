/* varmass.h: tanks and grains, two bodies with constant and variable mass */

static void try_supplies(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        vm_supply s;
        vm_supply_left left;
        CLEAR(left);
        s.kind = i % 4; /* the last does not exist */
        s.at = vector(1);
        s.axis = vector(1);
        s.length = uniform(1, 3);
        s.radius = uniform(1, 2);
        s.bore = uniform(0, 1);
        s.full = uniform(3, 4);
        fold_int(vm_supply_at(&s, uniform(0, 3), &left));
        fold(left.size);
        fold3(left.centre);
        fold3(left.centre_by_mass);
        fold3(left.store.at);
        fold_inertia(left.inertia);
        fold_inertia(left.inertia_by_mass);
        fold_inertia(left.store.gyration);
    }
}

static void try_orbits(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_vec3 r0 = vector(2), v0 = vector(i % 2 ? 1 : 4);
        const vm_real mu = uniform(1, 3), t = uniform(-9, 9);
        vm_vec3 r = r0, v = v0;
        fold_int(vm_orbit(t, mu, r0, v0, &r, &v));
        fold3(r);
        fold3(v);
        fold_int(vm_orbit_meshchersky(t, mu, VM_C(0.0625), r0, v0, &r, &v));
        fold3(r);
        fold3(v);
    }
}

/* Two bodies that attract each other, in the field of a centre */
static void try_gravitation(void)
{
    const vm_vec3 r = vector(2), v = vector(1), zero = {0, 0, 0};
    vm_scene_body bodies[2];
    vm_effect effects[3];
    vm_scene scene;
    vm_real y[12], dydt[12];
    int i;
    bodies[0] = vm_scene_body_point(2, r, v);
    bodies[1] = vm_scene_body_plane(3, 1, v, 1, r, 2);
    effects[0] = vm_effect_gravitation(0, 1, VM_C(0.5));
    effects[1] = vm_effect_central_gravity(0, zero, 2);
    effects[2] = vm_effect_central_gravity(1, zero, 2);
    memset(&scene, 0, sizeof scene);
    scene.bodies = bodies;
    scene.n_bodies = 2;
    scene.effects = effects;
    scene.n_effects = 3;
    fold_int(vm_scene_start(&scene, 0, y, NULL));
    fold_int(vm_scene_rhs(0, y, dydt, &scene));
    for (i = 0; i < 12; i++) fold(dydt[i]);
}

static void golden_orbit(void)
{
    try_supplies();
    try_orbits();
    try_gravitation();
}
