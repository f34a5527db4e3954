/* Attitudes and fixed axles: half turns, small angles, gimbal lock, parameters of long rotations; an axle on which
   nearly no inertia is left. */

/* Modified Rodrigues parameters (x0, x1, x2) of a rotation near a half turn: w of the quaternion */
static vm_real mrp_half_turn_ours(const vm_real *x) { return vm_quat_from_mrp(vmi_vec3(x[0], x[1], x[2])).w; }
static vm_real mrp_half_turn_naive(const vm_real *x)
{
    const vm_real square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    return (1 - square) / (1 + square);
}

/* Modified Rodrigues parameters (x0, 1, 0) of a rotation by nearly 2 pi, where they become infinite: x of the
   quaternion */
static vm_real mrp_full_turn_ours(const vm_real *x) { return vm_quat_from_mrp(vmi_vec3(x[0], 1, 0)).x; }
static vm_real mrp_full_turn_naive(const vm_real *x) { return 2 * x[0] / (1 + (x[0] * x[0] + 1)); }

/* The quaternion (x0, x1, 0, x2) of a rotation by nearly 2 pi: the first parameter. Naive: of the quaternion as it is,
   then of the shadow set */
static vm_real mrp_shadow_ours(const vm_real *x)
{
    const vm_quat q = {x[0], x[1], 0, x[2]};
    return vm_quat_to_mrp(q).x;
}
static vm_real mrp_shadow_naive(const vm_real *x)
{
    const vm_real length = SQRT(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const vm_real p = x[1] / (length + x[0]), r = x[2] / (length + x[0]);
    return -p / (p * p + r * r);
}

/* The rotation matrix of a turn about x, whose cosine and sine are x0 and x1: w of the quaternion, and its x. Naive:
   w from the trace; x from the angle whose cosine the trace gives */
static vm_quat quat_of_turn(const vm_real *x)
{
    const vm_real matrix[9] = {1, 0, 0, 0, x[0], -x[1], 0, x[1], x[0]};
    vm_quat q = {VM_NAN, 0, 0, 0};
    if (vm_quat_from_matrix(matrix, &q)) q.w = VM_NAN;
    return q;
}
static vm_real turn_w_ours(const vm_real *x) { return quat_of_turn(x).w; }
static vm_real turn_w_naive(const vm_real *x) { return SQRT(1 + (1 + 2 * x[0])) / 2; }
static vm_real turn_x_ours(const vm_real *x) { return quat_of_turn(x).x; }
static vm_real turn_x_naive(const vm_real *x) { return SIN(VM_LIBM(acos)(x[0]) / 2); }

/* Angles of the sequence 3-1-3 from the quaternion (x0, x1, x2, x3). Naive: from the entries of the rotation matrix */
static vm_real angle_313(const vm_real *x, int i)
{
    const vm_quat q = {x[0], x[1], x[2], x[3]};
    vm_real angles[3];
    return vm_euler_313_angles(q, angles) == VM_OK ? angles[i] : VM_NAN;
}
static vm_real tilt_313_ours(const vm_real *x) { return angle_313(x, 1); }
static vm_real tilt_313_naive(const vm_real *x)
{
    const vm_real turns = x[0] * x[0] + x[3] * x[3], tilts = x[1] * x[1] + x[2] * x[2];
    return VM_LIBM(acos)((turns - tilts) / (turns + tilts));
}
static vm_real first_313_ours(const vm_real *x) { return angle_313(x, 0); }
static vm_real first_313_naive(const vm_real *x)
{
    return ATAN2(2 * (x[1] * x[3] + x[0] * x[2]), -2 * (x[2] * x[3] - x[0] * x[1]));
}

/* Yaw, pitch, roll of the sequence 3-2-1 from the quaternion (x0, x1, x2, x3). Naive: from the entries of the rotation
   matrix */
static vm_real angle_321(const vm_real *x, int i)
{
    const vm_quat q = {x[0], x[1], x[2], x[3]};
    vm_real angles[3];
    return vm_euler_321_angles(q, angles) == VM_OK ? angles[i] : VM_NAN;
}
static vm_real yaw_ours(const vm_real *x) { return angle_321(x, 0); }
static vm_real yaw_naive(const vm_real *x)
{
    return ATAN2(2 * (x[1] * x[2] + x[0] * x[3]), x[0] * x[0] + x[1] * x[1] - x[2] * x[2] - x[3] * x[3]);
}
static vm_real pitch_ours(const vm_real *x) { return angle_321(x, 1); }
static vm_real pitch_naive(const vm_real *x)
{
    const vm_real square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
    return VM_LIBM(asin)(2 * (x[0] * x[2] - x[1] * x[3]) / square);
}
static vm_real roll_ours(const vm_real *x) { return angle_321(x, 2); }
static vm_real roll_naive(const vm_real *x)
{
    return ATAN2(2 * (x[2] * x[3] + x[0] * x[1]), x[0] * x[0] - x[1] * x[1] - x[2] * x[2] + x[3] * x[3]);
}

/* A body of 3 kg turns at 3.3 rad/s about an axle 1 m off its mass centre; its inertia about the axle is 4 kg m^2. A
   part of the mass x0 and the inertia x1 leaves from its mass centre with the motion of the body, but spins by x2
   faster: the rate of the rest. Naive: by the angular momenta about the axle */
static vm_real axle_rest_ours(const vm_real *x)
{
    const vm_axle axle = {{0, 0, 0}, {0, 0, 1}};
    vm_body whole = {3, {1, 1, 1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0}, {0, VM_C(3.3), 0}, {0, 0, VM_C(3.3)}};
    vm_body part = whole, rest;
    part.mass = x[0];
    part.inertia.xx = part.inertia.yy = part.inertia.zz = x[1];
    part.omega.z += x[2];
    return vm_separate_on_axle(&axle, &whole, 1, &part, NULL, &rest, NULL) == VM_OK ? rest.omega.z : VM_NAN;
}
static vm_real axle_rest_naive(const vm_real *x)
{
    return (4 * VM_C(3.3) - (x[0] * VM_C(3.3) + x[1] * (VM_C(3.3) + x[2]))) / (4 - (x[0] + x[1]));
}

/* A body of 3 kg and 8 kg m^2 rests on an axle at x0, which is its mass centre; a part of 1.25 kg at x1 leaves at the
   speed x2: the rate of the rest. Naive: by moments about the origin */
static vm_real far_axle_ours(const vm_real *x)
{
    vm_axle axle = {{0, 0, 0}, {0, 0, 1}};
    vm_body whole = {3, {8, 8, 8, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, part = whole, rest;
    axle.at.x = whole.r.x = x[0];
    part.mass = VM_C(1.25);
    part.inertia.xx = part.inertia.yy = part.inertia.zz = 0;
    part.r.x = x[1];
    part.v.y = x[2];
    return vm_separate_on_axle(&axle, &whole, 1, &part, NULL, &rest, NULL) == VM_OK ? rest.omega.z : VM_NAN;
}
static vm_real far_axle_naive(const vm_real *x)
{
    const vm_real inertia = 8 - VM_C(1.25) * (x[1] * x[1] - 2 * x[0] * x[1] + x[0] * x[0]);
    return VM_C(-1.25) * (x[1] * x[2] - x[0] * x[2]) / inertia;
}

static const hard_case attitudes_cases[] = {
    CASE(mrp_half_turn, 8, "w of a quaternion from Rodrigues parameters p next to a half turn: 1 - p^2 cancels", 0.6,
         0.8, R(1e-9, 1e-4)),
    CASE(mrp_half_turn, 8,
         "w of a quaternion from Rodrigues parameters p next to an oblique half turn: 1 - p^2 cancels", R(0.48, 0.48),
         0.6, R(0.6400000001, 0.64001)),
    CASE(mrp_full_turn, 8,
         "x of a quaternion from Rodrigues parameters next to a full turn: the square of the parameters overflows",
         R(1e200, 1e25)),
    CASE(mrp_shadow, 8, "Rodrigues parameters of a rotation by nearly 2 pi: 1 + w of the quaternion cancels",
         R(-0.99999999, -0.9999), R(3e-9, 2e-4), R(2e-9, 1e-4)),
    CASE(mrp_shadow, 8, "Rodrigues parameters of a rotation by even closer to 2 pi: no digit of 1 + w is left", -1,
         R(3e-12, 3e-6), R(-4e-12, -4e-6)),
    CASE(turn_w, 4, "w of a quaternion from the trace of a rotation matrix next to a half turn: the sum cancels", -1,
         R(1e-9, 1e-5)),
    CASE(turn_x, 4, "x of the quaternion of a small rotation from the cosine of its angle: the cosine rounds to 1", 1,
         R(1e-9, 1e-5)),
    CASE(tilt_313, 4, "small Euler angle theta from its cosine: the cosine rounds to 1", 1, R(1e-9, 1e-5),
         R(2e-9, 2e-5), 0.5),
    CASE(tilt_313, 4, "Euler angle theta next to pi from its cosine: the cosine rounds to -1", R(1e-9, 1e-5), 1, 0.5,
         R(2e-9, 2e-5)),
    CASE(first_313, 4, "Euler angle psi next to 0 from the rotation matrix: two products cancel", 0.1, 0.3, 0.3,
         R(-0.1000000001, -0.10001)),
    CASE(first_313, 4, "Euler angle psi next to 0 and to gimbal lock (theta next to 0): two products cancel", 0.1,
         R(3e-9, 3e-5), R(3e-9, 3e-5), R(-0.1000000001, -0.10001)),
    CASE(first_313, 4, "Euler angle psi in gimbal lock, theta = 0: only the sum psi + phi is determined", 3, 0, 0, 1),
    CASE(first_313, 4, "Euler angle psi in gimbal lock, theta = pi: only the difference psi - phi is determined", 0, 3,
         1, 0),
    CASE(pitch, 4, "pitch next to a right angle from its sine: the sine loses digits next to 1", 1, R(1e-9, 1e-5),
         R(1.000000001, 1.0001), R(2e-9, 2e-5)),
    CASE(yaw, 4, "yaw next to gimbal lock (pitch next to a right angle): squares nearly cancel", 1, R(3e-9, 3e-5), 1,
         R(1e-9, 1e-5)),
    CASE(yaw, 4, "yaw in gimbal lock: the formula is the arctangent of 0/0", 3, -1, 3, 1),
    CASE(roll, 4, "roll next to gimbal lock: squares nearly cancel", 1, R(3e-9, 3e-5), 1, R(1e-9, 1e-5)),
    CASE(roll, 4, "roll at a pitch next to minus a right angle: squares nearly cancel", R(1.000000003, 1.0003),
         R(2e-9, 2e-5), -1, R(7e-9, 7e-5)),
    CASE(axle_rest, 2,
         "spin of a rest with 1e-6 of the inertia about an axle, if the part moves on as before: differences cancel",
         R(2.9999995, 2.9995), R(0.9999995, 0.9995)),
    CASE(axle_rest, 2, "spin of a rest with 1e-12 of the inertia about an axle: differences of angular momenta cancel",
         R(2.9999999999995, 2.99999), R(0.9999999999995, 0.99999)),
    CASE(axle_rest, 8,
         "spin of a rest with little inertia about an axle, if the part spins a little faster: differences cancel",
         R(2.9999995, 2.9995), R(0.9999995, 0.9995), R(1e-9, 1e-5)),
    CASE(far_axle, 16, "spin of the rest on an axle far from the origin: Steiner's theorem loses digits",
         R(100000000.1, 10000.1), R(100000000.6, 10000.6), 3),
    CASE(far_axle, 16, "the same spin, if the part is close to the axle: Steiner's theorem loses digits",
         R(100000000.1, 10000.1), R(100000000.1000001, 10000.11), 3),
};
