/* Relative motions (3.2): the way to them and back, and the jumps in them. The oracles are the way back and the same
   jump in absolute motions, which test_jumps.c and test_jumps2.c test.

   usage: relative [seed], which draws other bodies */
#include "jumps.h"

/* In space: there and back; and the jump in relative motions is the jump in absolute ones, for either sign. */
static void test_relative(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body a = random_body(4, 1), b = random_body(1.5, 0.5), whole, rest, part, relative, back;
        vm_impulse impulse = random_impulse(), *j = i % 2 ? &impulse : NULL;
        b.r = vm_add(a.r, random_vector(1));
        CHECK(vm_attach(&a, &b, j, &whole) == VM_OK);
        CHECK(vm_to_relative(&a, &b, &relative) == VM_OK && vm_to_absolute(&a, &relative, &back) == VM_OK);
        check_error("relative", "there and back", "eps", apart(&back, &b), 4, i, 0);
        CHECK(vm_attach_relative(&a, &relative, j, &rest) == VM_OK && vm_to_absolute(&a, &rest, &rest) == VM_OK);
        check_error("attach_relative", "space", "eps", apart(&rest, &whole), 12, i, 0);

        part = b;
        part.v = random_vector(5);
        part.omega = random_vector(3);
        CHECK(vm_separate(&whole, &part, j, &rest) == VM_OK && vm_to_relative(&whole, &part, &relative) == VM_OK);
        CHECK(vm_separate_relative(&whole, &relative, j, &back) == VM_OK);
        CHECK(vm_to_absolute(&whole, &back, &back) == VM_OK);
        check_error("separate_relative", "space", "eps", apart(&back, &rest), 12, i, 0);
    }
}

/* In the plane: there and back, and the jump in relative motions is that of the laminas in space */
static void test_relative2(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        const vm_body2 a = random_body2(uniform(1, 5)), b = random_body2(uniform(0.5, 3));
        const vm_body a_in_space = vm_body_from_body2(&a), b_in_space = vm_body_from_body2(&b);
        const vm_impulse2 impulse = random_impulse2(), *j = i % 2 ? &impulse : NULL;
        const vm_impulse blow = impulse_in_space(&impulse), *blow_or_null = i % 2 ? &blow : NULL;
        vm_body2 relative, back = a, moving = b;
        vm_body joined_in_space;
        CHECK(vm_attach(&a_in_space, &b_in_space, blow_or_null, &joined_in_space) == VM_OK);
        CHECK(vm_to_relative2(&a, &b, &relative) == VM_OK && vm_to_absolute2(&a, &relative, &back) == VM_OK);
        check_error("relative2", "there and back", "eps", apart2(&back, &b_in_space), 4, i, 0);
        CHECK(vm_attach_relative2(&a, &relative, j, &moving) == VM_OK);
        CHECK(vm_to_absolute2(&a, &moving, &back) == VM_OK);
        check_error("attach_relative2", "as in space", "eps", apart2(&back, &joined_in_space), 12, i, 0);
    }
}

/* An input may be the output. */
static void test_outputs_as_inputs(void)
{
    vm_body part, whole = whole_and_part(&part), x = whole, y = part, relative;
    CHECK(vm_to_relative(&whole, &part, &relative) == VM_OK && vm_to_relative(&x, &y, &x) == VM_OK);
    CHECK(memcmp(&x, &relative, sizeof x) == 0 && vm_to_relative(&whole, &y, &y) == VM_OK);
    CHECK(memcmp(&y, &relative, sizeof y) == 0);
}

int main(int argc, char **argv)
{
    draw_anew(argc, argv);
    test_relative();
    test_relative2();
    test_outputs_as_inputs();
    return check_finish("relative");
}
