/* varmass.h, chapters 2, 3 and 4.1: momenta, inertia, jumps in space and in the plane by every form, energies */

/* A body that is large enough for the part that some_part() takes from it */
static vm_body some_body(void)
{
    vm_body b;
    b.mass = uniform(1, 5);
    b.inertia.xx = uniform(3, 4);
    b.inertia.yy = uniform(3, 4);
    b.inertia.zz = uniform(3, 4);
    b.inertia.xy = uniform(-1, 1);
    b.inertia.xz = uniform(-1, 1) / 4;
    b.inertia.yz = uniform(-1, 1);
    b.q.w = 1;
    b.q.x = uniform(-1, 1);
    b.q.y = uniform(-1, 1);
    b.q.z = uniform(-1, 1);
    b.r = vector(1);
    b.v = vector(3);
    b.omega = vector(2);
    return b;
}

static vm_body some_part(const vm_body *whole)
{
    vm_body part = *whole;
    part.mass = VM_C(0.25);
    part.r.x += VM_C(0.25);
    part.v = vector(3);
    part.omega = vector(2);
    part.inertia = vmi_inertia_plus(part.inertia, -1 + VM_C(0.0625), part.inertia);
    return part;
}

static vm_impulse some_impulse(void)
{
    vm_impulse j;
    j.linear = vector(1);
    j.couple = vector(1);
    j.at = vector(2);
    return j;
}

static void fold_balance(const vm_balance *b)
{
    fold3(b->momentum);
    fold3(b->angular_momentum);
    fold(b->momentum_scale);
    fold(b->angular_momentum_scale);
    fold(b->energy);
}

static void try_bodies(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_body a = some_body(), b = some_part(&a);
        const vm_vec3 d = vector(1);
        vm_inertia sum, rest;
        vm_vec3 centre;
        vm_body moved = b;
        CLEAR(sum);
        CLEAR(rest);
        CLEAR(centre);
        fold3(vm_momentum(&a));
        fold3(vm_angular_momentum(&a, d));
        fold(vm_kinetic_energy(&a));
        fold_int(vm_inertia_is_possible(&a.inertia));
        fold_inertia(vm_parallel_axes(&a.inertia, a.mass, d));
        fold_int(vm_combine_inertia(a.mass, &a.inertia, b.mass, &b.inertia, d, &sum, &centre));
        fold_inertia(sum);
        fold3(centre);
        fold_int(vm_split_inertia(a.mass + b.mass, &sum, b.mass, &b.inertia, vm_sub(d, centre), &rest, &centre));
        fold_inertia(rest);
        fold3(centre);
        fold_int(vm_to_relative(&a, &b, &moved));
        fold3(moved.v);
        fold3(moved.omega);
        fold_int(vm_to_absolute(&a, &moved, &moved));
        fold3(moved.v);
        fold3(moved.omega);
    }
}

static void try_jumps(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_body body = some_body(), part = some_part(&body);
        const vm_impulse impulse = some_impulse();
        const vm_vec3 v = vector(2), omega = vector(2), about = vector(1);
        vm_body after[2], relative;
        vm_balance balance;
        after[0] = body;
        after[1] = part;
        CLEAR(balance);
        fold_int(vm_separate(&body, &part, &impulse, after));
        fold_body(after);
        fold_int(vm_balance_between(1, &body, 2, after, &impulse, about, &balance));
        fold_balance(&balance);
        fold(vm_energy_gain(&body, 1, &part, &impulse, after));
        fold_int(vm_separate(&part, &body, NULL, after));
        fold_body(after); /* refused: heavier than the whole */
        fold_int(vm_attach(&body, &part, NULL, after));
        fold_body(after);
        fold(vm_energy_loss(&body, 1, &part, NULL, after));
        fold_int(vm_separation_for_rest(&body, &part, NULL, &v, &omega, after));
        fold_body(after);
        relative = part;
        relative.v = v;
        relative.omega = omega;
        fold_int(vm_separate_relative(&body, &relative, NULL, after));
        fold_body(after);
        fold_int(vm_attach_relative(&body, &relative, &impulse, after));
        fold_body(after);
    }
}

static void try_jumps_of_several(void)
{
    int i;
    for (i = 0; i < COUNT / 16; i++) {
        const vm_body body = some_body();
        const vm_impulse impulse = some_impulse();
        const vm_axle axle = {{1, 2, -1}, {VM_C(0.5), -1, 1}};
        vm_body parts[3], result;
        vm_impulse reaction = impulse;
        parts[0] = some_part(&body);
        parts[1] = some_part(&body);
        parts[2] = some_body();
        result = body;
        fold_int(vm_separate_all(&body, 2, parts, &impulse, &result));
        fold_body(&result);
        fold_int(vm_separate_all(&body, 0, NULL, &impulse, &result));
        fold_body(&result); /* a blow */
        fold_int(vm_attach_all(&body, 3, parts, NULL, &result));
        fold_body(&result);
        fold_int(vm_separate_on_axle(&axle, &body, 2, parts, &impulse, &result, &reaction));
        fold_body(&result);
        fold3(reaction.linear);
        fold3(reaction.couple);
        fold_int(vm_attach_on_axle(&axle, &body, 3, parts, NULL, &result, &reaction));
        fold_body(&result);
        fold3(reaction.linear);
        fold3(reaction.couple);
    }
}

static vm_body2 some_body2(vm_real mass)
{
    vm_body2 b;
    b.mass = uniform(mass / 2, mass);
    b.inertia = b.mass * uniform(VM_C(0.5), 1);
    b.angle = uniform(-3, 3);
    b.x = uniform(-1, 1) / 4;
    b.y = uniform(-1, 1) / 4;
    b.vx = uniform(-3, 3);
    b.vy = uniform(-3, 3);
    b.omega = uniform(-2, 2);
    return b;
}

static vm_impulse2 some_impulse2(void)
{
    vm_impulse2 j;
    j.jx = uniform(-1, 1);
    j.jy = uniform(-1, 1);
    j.couple = uniform(-1, 1);
    j.x = uniform(-2, 2);
    j.y = uniform(-2, 2);
    return j;
}

static void try_jumps_in_the_plane(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_body2 body = some_body2(5);
        const vm_impulse2 impulse = some_impulse2();
        const vm_real v[2] = {VM_C(0.5), -1}, omega = uniform(-2, 2);
        vm_body2 parts[2], result, relative;
        vm_body lamina;
        parts[0] = some_body2(VM_C(0.25));
        parts[1] = some_body2(VM_C(0.25));
        result = relative = body;
        fold(vm_angular_momentum2(&body, 1, omega));
        fold(vm_kinetic_energy2(&body));
        lamina = vm_body_from_body2(&body);
        fold_body(&lamina);
        fold_int(vm_separate2(&body, parts, &impulse, &result));
        fold_body2(&result);
        fold_int(vm_attach2(&body, parts, NULL, &result));
        fold_body2(&result);
        fold_int(vm_separate_all2(&body, 2, parts, NULL, &result));
        fold_body2(&result);
        fold_int(vm_attach_all2(&body, 2, parts, &impulse, &result));
        fold_body2(&result);
        fold_int(vm_to_relative2(&body, parts, &relative));
        fold_body2(&relative);
        fold_int(vm_separate_relative2(&body, &relative, &impulse, &result));
        fold_body2(&result);
        fold_int(vm_attach_relative2(&body, &relative, NULL, &result));
        fold_body2(&result);
        fold_int(vm_to_absolute2(&body, &relative, &result));
        fold_body2(&result);
        fold_int(vm_separation_for_rest2(&body, parts, &impulse, v, &omega, &result));
        fold_body2(&result);
        fold_int(vm_separation_for_spin2(&body, parts, NULL, omega, &result));
        fold_body2(&result);
    }
}

static void golden_jumps(void)
{
    try_bodies();
    try_jumps();
    try_jumps_of_several();
    try_jumps_in_the_plane();
}
