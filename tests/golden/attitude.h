/* varmass.h: vectors, and attitudes in all their forms */

static vm_quat some_quaternion(void)
{
    vm_quat q;
    q.w = uniform(-1, 1);
    q.x = uniform(-1, 1);
    q.y = uniform(-1, 1);
    q.z = uniform(-1, 1);
    return q;
}

static void try_vectors(void)
{
    int i;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_vec3 a = vector(3), b = vector(2);
        fold3(vm_add(a, b));
        fold3(vm_sub(a, b));
        fold3(vm_scale(VM_C(0.3), a));
        fold3(vm_cross(a, b));
        fold3(vm_unit(a));
        fold(vm_dot(a, b));
        fold(vm_norm(a));
    }
}

static void try_attitude(vm_quat q)
{
    const vm_vec3 a = vector(3), p = vector(2);
    vm_real angles[3] = {0, 0, 0}, c[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    vm_quat back = {0, 0, 0, 0};
    fold3(vm_rotate(q, a));
    fold3(vm_rotate_back(q, a));
    fold_int(vm_quat_to_matrix(q, c));
    fold_all(9, c);
    fold_int(vm_quat_from_matrix(c, &back));
    fold_quat(back);
    fold_quat(vm_unit_quat(q));
    fold_quat(vm_quat_times(q, back));
    fold3(vm_quat_to_mrp(q));
    fold_quat(vm_quat_from_mrp(p));
    fold_int(vm_euler_313_angles(q, angles));
    fold_all(3, angles);
    fold_int(vm_euler_321_angles(q, angles));
    fold_all(3, angles);
    fold_quat(vm_euler_321(angles[0], angles[1], angles[2]));
}

static void golden_attitude(void)
{
    int i;
    try_vectors();
    for (i = 0; i < COUNT / 2; i++) {
        vm_quat q = some_quaternion();
        if (i % 4 == 1) q.z = -q.x;
        if (i % 8 == 1) q.y = q.w; /* gimbal lock of 3-2-1 */
        if (i % 4 == 2) q.x = q.y = 0; /* and of 3-1-3 */
        if (i % 8 == 3) q.w = 0;
        try_attitude(q);
    }
}
