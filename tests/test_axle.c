/* Chapter of varmass.h on jumps of bodies on a fixed axle: vm_separate_on_axle, vm_attach_on_axle.
   Oracles: conservation of momentum and angular momentum together with the impulse of the axle, the reference case D2
   of the pendulum in 22 digits, the free jump where the axle goes through the mass centre along a principal axis, and
   the way back. */
#include "rods.h"

/* A random axle, a body that turns about it, and a part that was in the body and has another motion */
typedef struct axle_case {
    vm_axle axle;
    vm_vec3 e;
    double rate;
    vm_body rest, part, whole;
} axle_case;

/* Gives a body the motion about the axle. */
static void turn(const axle_case *a, vm_body *b)
{
    b->omega = vm_scale(R(a->rate), a->e);
    b->v = vm_cross(b->omega, vm_sub(b->r, a->axle.at));
}

static axle_case random_case(void)
{
    axle_case a;
    memset(&a, 0, sizeof a);
    a.axle.at = random_vector(2);
    a.axle.axis = random_vector(3);
    a.e = vm_scale(1 / vm_norm(a.axle.axis), a.axle.axis);
    a.rate = uniform(-3, 3);
    a.rest = random_body(uniform(1, 3), 1);
    a.part = random_body(uniform(0.2, 1), 0.5);
    turn(&a, &a.rest);
    turn(&a, &a.part);
    CHECK(vm_attach(&a.rest, &a.part, NULL, &a.whole) == VM_OK);
    turn(&a, &a.whole);
    return a;
}

/* The impulse of the axle and the external one as one impulse at the axle */
static vm_impulse together(const vm_impulse *reaction, const vm_impulse *external)
{
    vm_impulse sum = *reaction;
    if (!external) return sum;
    sum.linear = vm_add(sum.linear, external->linear);
    sum.couple = vm_add(sum.couple, vm_add(external->couple,
                                           vm_cross(vm_sub(external->at, reaction->at), external->linear)));
    return sum;
}

/* The body turns about the axle, and momentum and angular momentum balance. */
static void check_guided(const char *what, const axle_case *a, const vm_body *b, const vm_balance *balance)
{
    const double size = size_of(b->omega) + 1;
    check_error(what, "omega along the axle", "eps", size_of(vm_cross(b->omega, a->e)) / size / eps, 4, 0, 0);
    check_error(what, "v = omega x d", "eps",
                size_of(vm_sub(b->v, vm_cross(b->omega, vm_sub(b->r, a->axle.at)))) / size / eps, 32, 0, 0);
    check_error(what, "momentum", "eps", size_of(balance->momentum) / (double)balance->momentum_scale / eps, 16, 0, 0);
    check_error(what, "angular momentum", "eps",
                size_of(balance->angular_momentum) / (double)balance->angular_momentum_scale / eps, 16, 0, 0);
}

static void test_balance(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        axle_case a = random_case();
        vm_impulse blow, reaction, all;
        const vm_impulse *external = i % 2 ? &blow : NULL;
        vm_body after[2], back;
        vm_balance balance;
        memset(&balance, 0, sizeof balance);
        memset(&reaction, 0, sizeof reaction);
        blow.linear = random_vector(4);
        blow.couple = random_vector(2);
        blow.at = random_vector(3);
        a.part.v = vm_add(a.part.v, random_vector(3));
        a.part.omega = vm_add(a.part.omega, random_vector(3));
        after[0] = after[1] = a.part;
        CHECK(vm_separate_on_axle(&a.axle, &a.whole, 1, &a.part, external, &after[0], &reaction) == VM_OK);
        all = together(&reaction, external);
        CHECK(vm_balance_between(1, &a.whole, 2, after, &all, a.axle.at, &balance) == VM_OK);
        check_guided("separation", &a, &after[0], &balance);
        check_error("separation", "free about the axle", "eps",
                    fabs((double)vm_dot(reaction.couple, a.e)) / (1 + size_of(reaction.couple)) / eps, 16, 0, 0);
        back = after[0];
        CHECK(vm_attach_on_axle(&a.axle, &after[0], 1, &a.part, NULL, &back, &reaction) == VM_OK);
        CHECK(vm_balance_between(2, after, 1, &back, &reaction, a.axle.at, &balance) == VM_OK);
        check_guided("attachment", &a, &back, &balance);
        if (!external) {
            const double defect = (double)vm_dot(back.omega, a.e) - a.rate;
            check_error("there and back", "rate", "eps", fabs(defect) / (5 + size_of(after[0].omega)) / eps, 256, i, 0);
        }
    }
}

/* The trace of the body's inertia plus its mass times the squared distance from the axle's point */
static double whole_size(const axle_case *a, const vm_body *b)
{
    const double d = size_of(vm_sub(b->r, a->axle.at));
    return (double)vmi_inertia_trace(&b->inertia) + (double)b->mass * d * d;
}

/* The inertia of the body about the axle */
static double about_axle(const axle_case *a, const vm_body *b)
{
    const double d = size_of(vm_cross(a->e, vm_sub(b->r, a->axle.at)));
    return (double)vm_dot(a->e, vmi_spin_momentum_at(b, a->e)) + (double)b->mass * d * d;
}

/* A rest with little inertia about the axle: it is a small difference of large numbers. */
static void test_small_rest(void)
{
    int i;
    for (i = 0; i < 2000; i++) {
        axle_case a = random_case();
        const double small = pow(10, uniform(is_float ? -2 : -8, 0));
        vm_body rest;
        vm_vec3 slip, spin, momentum;
        double inertia_left, change, fastest, H, error;
        a.rest.mass = R(small) * a.rest.mass;
        a.rest.inertia = vmi_inertia_plus(inertia(0, 0, 0, 0, 0, 0), R(small), a.rest.inertia);
        if (i % 2) a.rest.r = a.part.r = a.axle.at;
        turn(&a, &a.rest);
        turn(&a, &a.part);
        CHECK(vm_attach(&a.rest, &a.part, NULL, &a.whole) == VM_OK);
        turn(&a, &a.whole);
        slip = random_vector(3);
        spin = random_vector(3);
        a.part.v = vm_add(a.part.v, slip);
        a.part.omega = vm_add(a.part.omega, spin);
        rest = a.whole;
        CHECK(vm_separate_on_axle(&a.axle, &a.whole, 1, &a.part, NULL, &rest, NULL) == VM_OK);
        momentum = vm_add(vmi_spin_momentum_at(&a.part, spin),
                          vm_scale(a.part.mass, vm_cross(vm_sub(a.part.r, a.axle.at), slip)));
        inertia_left = about_axle(&a, &a.rest);
        change = -(double)vm_dot(a.e, momentum) / inertia_left;
        fastest = fmax(size_of(rest.omega), fmax(size_of(a.whole.omega), size_of(a.part.omega)));
        H = fastest * (whole_size(&a, &a.whole) + whole_size(&a, &a.part) + whole_size(&a, &rest)) +
            (double)a.part.mass * size_of(vm_sub(a.part.r, a.axle.at)) * size_of(a.part.v);
        error = size_of(vm_sub(rest.omega, vm_scale(R(a.rate + change), a.e)));
        check_error("small rest", "omega", "eps", error / eps / (H / inertia_left), 4, small, i);
    }
}

/* Where the part goes on as the whole did, nothing changes and the axle gives nothing. */
static void test_unchanged(void)
{
    int i;
    for (i = 0; i < 300; i++) {
        axle_case a = random_case();
        vm_body rest = a.whole;
        vm_impulse reaction;
        memset(&reaction, 0, sizeof reaction);
        CHECK(vm_separate_on_axle(&a.axle, &a.whole, 1, &a.part, NULL, &rest, &reaction) == VM_OK);
        check_error("unchanged", "omega", "eps", size_of(vm_sub(rest.omega, a.rest.omega)) / eps, 64, i, 0);
        check_error("unchanged", "reaction", "eps",
                    (size_of(reaction.linear) + size_of(reaction.couple)) / (1 + fabs(a.rate)) / eps, 512, i, 0);
    }
}

/* The pendulum of case D2 about the z axis */
static void test_pendulum(void)
{
    const vm_axle axle = {{0, 0, 0}, {0, 0, 2}};
    const vm_vec3 along = vector(cos(0.7), sin(0.7), 0), across = vector(-sin(0.7), cos(0.7), 0);
    const vm_pendulum p = {3, 2, R(0.7), R(1.3), VM_AXES_COS_SIN};
    vm_body whole = rod_at(3, 2, 0.7, along), part = rod_at(0.75, 0.5, 0.7, vm_scale(R(1.75), along)), rest = part;
    vm_impulse reaction;
    vm_pendulum_cut cut;
    memset(&reaction, 0, sizeof reaction);
    memset(&cut, 0, sizeof cut);
    whole.omega.z = R(1.3);
    whole.v = vm_scale(R(1.3), across);
    part.omega.z = R(1.9);
    part.v = vm_add(vm_scale(R(1.3 * 1.75), across), vector(0.4, -0.25, 0));
    CHECK(vm_separate_on_axle(&axle, &whole, 1, &part, NULL, &rest, &reaction) == VM_OK);
    CHECK(vm_pendulum_separate(&p, R(0.5), R(0.6), R(0.4), R(-0.25), &cut) == VM_OK);
    check_case("phi1' (125)", "D2", rest.omega.z, 1.643587039112598855137, 4, 8);
    check_case("impulse of the pivot", "D2", reaction.linear.x, (double)cut.pivot_x, 4, 8);
    check_case("impulse of the pivot", "D2", reaction.linear.y, (double)cut.pivot_y, 4, 8);
    check_case("couple of the pivot", "D2", R(size_of(reaction.couple)), 0, 4, 8);
}

/* A body that flies is caught by an axle: n = 0. About an axle through its mass centre it keeps the angular momentum
   about it, and the axle takes its momentum. */
static void test_caught(void)
{
    const vm_inertia own = {2, 3, 4, 0, 0, 0};
    const vm_axle axle = {{1, 2, 3}, {0, 1, 0}};
    vm_body b = random_body(2, 1), caught;
    vm_impulse reaction;
    memset(&reaction, 0, sizeof reaction);
    b.inertia = own;
    b.q = vmi_quat(1, vector(0, 0, 0));
    b.r = axle.at;
    b.v = vector(1, 2, 3);
    b.omega = vector(5, 6, 7);
    caught = b;
    CHECK(vm_attach_on_axle(&axle, &b, 0, NULL, NULL, &caught, &reaction) == VM_OK);
    CHECK(caught.omega.x == 0 && caught.omega.y == 6 && caught.omega.z == 0 && size_of(caught.v) == 0);
    CHECK(reaction.linear.x == -2 && reaction.linear.y == -4 && reaction.linear.z == -6);
    CHECK(reaction.couple.x == -10 && reaction.couple.y == 0 && reaction.couple.z == -28);
}

/* A rod along the axle and a point on it have no inertia about the axle, whatever rounding errors leave. A couple
   cannot turn the rod, and the point is caught without a spin. */
static void test_no_inertia(void)
{
    int i;
    for (i = 0; i < 200; i++) {
        const vm_quat q = random_attitude();
        vm_axle axle;
        vm_body b, point, after;
        vm_impulse blow;
        memset(&blow, 0, sizeof blow);
        axle.at = random_vector(2);
        axle.axis = random_vector(3);
        b = rod(3, vm_rotate_back(q, vm_unit(axle.axis)));
        b.q = q;
        b.r = vm_add(axle.at, vm_scale(R(uniform(-2, 2)), axle.axis));
        blow.couple = axle.axis;
        after = b;
        CHECK(vm_separate_on_axle(&axle, &b, 0, NULL, &blow, &after, NULL) == VM_NULL_AXIS);
        CHECK(size_of(after.omega) == 0 && size_of(after.v) == 0);
        point = rod(1, axle.axis);
        point.r = b.r;
        point.v = random_vector(5);
        CHECK(vm_attach_on_axle(&axle, &point, 0, NULL, NULL, &after, NULL) == VM_OK);
        CHECK(size_of(after.omega) == 0 && size_of(after.v) == 0);
    }
}

/* The length of the axis does not matter, from the smallest subnormal number to the largest number. */
static void test_length_of_axis(void)
{
    const vm_impulse none = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const vm_body spinning = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 3}};
    const vm_axle longest = {{0, 0, 0}, {VM_MAX, VM_MAX, VM_MAX}};
    const axle_case a = random_case();
    vm_axle axle = a.axle;
    vm_body usual = a.rest, rest = a.rest;
    vm_impulse reaction = none, usual_reaction = none;
    vm_real length;
    CHECK(vm_separate_on_axle(&longest, &spinning, 0, NULL, NULL, &rest, NULL) == VM_OK);
    check_case("omega", "longest axis", rest.omega.x, 0.6, 1, 8);
    check_case("omega", "longest axis", rest.omega.y, 0.6, 1, 8);
    check_case("omega", "longest axis", rest.omega.z, 0.6, 1, 8);
    axle.axis = vector(1, -1, 1);
    CHECK(vm_separate_on_axle(&axle, &a.whole, 1, &a.part, NULL, &usual, &usual_reaction) == VM_OK);
    for (length = VM_MIN * VM_EPSILON; length < VM_MAX; length *= 2) {
        axle.axis = vm_scale(length, vector(1, -1, 1));
        CHECK(vm_separate_on_axle(&axle, &a.whole, 1, &a.part, NULL, &rest, &reaction) == VM_OK);
        CHECK(memcmp(&rest, &usual, sizeof rest) == 0 && memcmp(&reaction, &usual_reaction, sizeof reaction) == 0);
    }
}

static void test_refusals(void)
{
    const vm_axle axle = {{0, 0, 0}, {0, 0, 1}}, none = {{0, 0, 0}, {0, 0, 0}}, nowhere = {{VM_NAN, 0, 0}, {1, 0, 0}};
    vm_body whole = rod_at(3, 2, 0, vector(1, 0, 0)), part = rod_at(1, 0, 0, vector(1, 0, 0)), rest = whole;
    vm_impulse reaction;
    reaction.linear = vector(7, 7, 7);
    whole.mass = 3;
    CHECK(vm_separate_on_axle(NULL, &whole, 1, &part, NULL, &rest, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_separate_on_axle(&axle, NULL, 1, &part, NULL, &rest, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_separate_on_axle(&axle, &whole, 1, NULL, NULL, &rest, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_separate_on_axle(&axle, &whole, 1, &part, NULL, NULL, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_attach_on_axle(&axle, &whole, -1, &part, NULL, &rest, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_attach_on_axle(&none, &whole, 1, &part, NULL, &rest, &reaction) == VM_DOMAIN);
    CHECK(vm_attach_on_axle(&nowhere, &whole, 1, &part, NULL, &rest, &reaction) == VM_NOT_FINITE);
    CHECK(memcmp(&rest, &whole, sizeof rest) == 0 && reaction.linear.x == 7);
    part.mass = 3;
    CHECK(vm_separate_on_axle(&axle, &whole, 1, &part, NULL, &rest, &reaction) == VM_BAD_MASS);
    part = rod_at(1, 0, 0, vector(0, 0, 0)); /* a point on the axle, which an impulse tries to turn */
    reaction.linear = vector(0, 0, 0);
    reaction.at = reaction.linear;
    reaction.couple = vector(0, 0, 1);
    CHECK(vm_separate_on_axle(&axle, &part, 0, NULL, &reaction, &rest, NULL) == VM_NULL_AXIS);
    CHECK(size_of(rest.omega) == 0);
    reaction.couple = vector(0, 1, 0); /* the axle takes it */
    CHECK(vm_separate_on_axle(&axle, &part, 0, NULL, &reaction, &rest, &reaction) == VM_OK && reaction.couple.y == -1);
}

int main(void)
{
    test_balance();
    test_small_rest();
    test_unchanged();
    test_pendulum();
    test_caught();
    test_no_inertia();
    test_length_of_axis();
    test_refusals();
    return check_finish("axle");
}
