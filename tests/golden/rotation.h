/* varmass.h: torque-free rotation, also after many turns, and Euler's angles */

static void try_rotation(void)
{
    int i;
    for (i = 0; i < COUNT / 8; i++) {
        const vm_body body = some_body();
        const vm_real t = uniform(-2, 2), far = i % 3 ? 100 : 100000;
        vm_torque_free motion;
        vm_body later;
        vm_quat q;
        vm_vec3 omega;
        fold_int(vm_torque_free_init(&motion, &body, 1));
        fold_int(vm_torque_free_at(&motion, t, &later));
        fold_body(&later);
        fold_int(vm_torque_free_at(&motion, far * t, &later));
        fold_body(&later);
        fold_int(vm_torque_free_attitude(&motion, far + t, &q, &omega));
        fold_quat(q);
        fold3(omega);
        if (i % 4 == 0) {
            fold_int(vm_torque_free_rotation(&body, t, &later));
            fold_body(&later);
        }
    }
}

/* Principal moments and spins: triaxial, symmetric, spherical, a rod, and next to the separatrix */
static void try_principal_rotation(void)
{
    static const vm_real kinds[5][6] = {
        {3, 2, 1, 1, 1, 1}, {2, 2, 1, 1, -1, 2}, {2, 2, 2, -1, 2, 1}, {2, 2, 0, 1, 1, 0}, {3, 2, 1, VM_C(0.0001), 2, 0}};
    int i, k;
    for (i = 0; i < 5; i++) {
        const vm_vec3 moments = {kinds[i][0], kinds[i][1], kinds[i][2]};
        const vm_vec3 spin = {kinds[i][3], kinds[i][4], kinds[i][5]};
        const vm_quat straight = {1, 0, 0, 0};
        vm_torque_free motion;
        fold_int(vm_torque_free_init_principal(&motion, moments, straight, spin, 0));
        for (k = 1; k < 8; k++) {
            vm_quat q;
            vm_vec3 omega;
            fold_int(vm_torque_free_attitude(&motion, (vm_real)(k * k * k), &q, &omega));
            fold_quat(q);
            fold3(omega);
        }
    }
}

static void try_euler(void)
{
    int i, k;
    for (i = 0; i < COUNT / 4; i++) {
        const vm_real psi = uniform(-10, 10), theta = uniform(-4, 4), phi = uniform(-10, 10);
        const vm_vec3 omega = vector(3);
        vm_vec3 axis[3];
        vm_real rates[3];
        fold_quat(vm_euler_313(psi, theta, phi));
        vm_euler_313_axes(psi, theta, axis);
        for (k = 0; k < 3; k++) fold3(axis[k]);
        vm_euler_313_body_axes(theta, phi, axis);
        for (k = 0; k < 3; k++) fold3(axis[k]);
        fold_int(vm_euler_313_rates(psi, theta, omega, rates));
        fold_all(3, rates);
    }
    {
        vm_real rates[3] = {1, 2, 3};
        const vm_vec3 omega = {1, 2, 3};
        fold_int(vm_euler_313_rates(1, 0, omega, rates));
        fold_all(3, rates); /* refused: sin theta = 0 */
    }
}

static void golden_rotation(void)
{
    try_rotation();
    try_principal_rotation();
    try_euler();
}
