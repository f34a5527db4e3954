/* null_pointers.h - every public function of varmass.h that takes a pointer, with each of its pointers null in turn.
   A function with a status says VM_BAD_ARGUMENT, one with a number NaN; one with neither does nothing, or writes NaN
   to the outputs that it has. Pointers that may be null, named ..._or_NULL, are not in the table.
   tests/test_headers.sh sees to it that no function is forgotten. tests/test_null_pointers.c runs it. */
#ifndef NULL_POINTERS_H
#define NULL_POINTERS_H

#include "../varmass.h"
#include "check.h"
#include "valid_objects.h"

static int null_at; /* which pointer is null, -1 for none */
static int fault;   /* the call did not refuse, or did not work with good pointers */

static void *nulled(int k, void *pointer) { return k == null_at ? NULL : pointer; }
static const void *nulled_const(int k, const void *pointer) { return k == null_at ? NULL : pointer; }
#define IN(k, type, pointer) ((const type *)nulled_const(k, pointer))
#define IO(k, type, pointer) ((type *)nulled(k, pointer))
#define X(k, type) ((type *)nulled(k, null_output[k])) /* an output, of its own for each pointer */

enum { NULL_OUTPUTS = 8, NULL_ROOM = 512 }; /* numbers in each */
static vm_real null_output[NULL_OUTPUTS][NULL_ROOM];

static void null_clear(void)
{
    int i, k;
    for (i = 0; i < NULL_OUTPUTS; i++)
        for (k = 0; k < NULL_ROOM; k++) null_output[i][k] = 7;
}

static int null_untouched(void)
{
    int i, k;
    for (i = 0; i < NULL_OUTPUTS; i++)
        for (k = 0; k < NULL_ROOM; k++)
            if (null_output[i][k] != 7) return 0;
    return 1;
}

static void null_checked(const char *call)
{
    if (fault) printf("pointer %d: %s\n", null_at, call);
    CHECK(!fault);
}

/* A call that has so many pointers, each null in turn. With none of them null it has to work, since otherwise it would be
   refused for another reason. */
#define STATUS(count, call)                                               \
    do {                                                                  \
        for (null_at = -1; null_at < (count); null_at++) {                \
            long status_;                                                 \
            null_clear();                                                 \
            status_ = (long)(call);                                       \
            if (null_at < 0) fault = status_ < 0;                         \
            else fault = status_ != VM_BAD_ARGUMENT || !null_untouched(); \
            null_checked(#call);                                          \
        }                                                                 \
    } while (0)

#define NUMBER(count, call)                                \
    do {                                                   \
        for (null_at = -1; null_at < (count); null_at++) { \
            vm_real number_;                               \
            null_clear();                                  \
            number_ = (call);                              \
            if (null_at < 0) fault = number_ != number_;   \
            else fault = number_ == number_;               \
            null_checked(#call);                           \
        }                                                  \
    } while (0)

#define NOTHING(count, call)                                                                        \
    do {                                                                                            \
        for (null_at = -1; null_at < (count); null_at++) {                                          \
            int k_;                                                                                 \
            null_clear();                                                                           \
            call;                                                                                   \
            fault = null_at < 0 && null_untouched();                                                \
            for (k_ = 0; k_ < NULL_OUTPUTS && null_at >= 0; k_++)                                   \
                if (null_output[k_][0] == null_output[k_][0] && null_output[k_][0] != 7) fault = 1; \
            null_checked(#call);                                                                    \
        }                                                                                           \
    } while (0)
/* Functions that answer 0 or 1, and those that write to what they are given: no crash is all */
#define ANSWER(count, call)                                \
    do {                                                   \
        for (null_at = -1; null_at < (count); null_at++) { \
            fault = ((call) != 0) != (null_at < 0);        \
            null_checked(#call);                           \
        }                                                  \
    } while (0)

static void null_bodies(void)
{
    const vm_axle axle = {{0, 0, 0}, {0, 0, 1}};
    const vm_vec3 zero = {0, 0, 0};
    const vm_body whole = a_body(3), part = a_body(1);
    const vm_body2 whole2 = a_body2(3), part2 = a_body2(1);
    const vm_inertia i = whole.inertia, little = part.inertia;
    const vm_vec3 aside = {R(0.25), 0, 0};
    vm_body2 out_of_centre = part2;
    out_of_centre.x = R(0.25);
    NUMBER(1, vm_momentum(IN(0, vm_body, &whole)).x);
    NUMBER(1, vm_angular_momentum(IN(0, vm_body, &whole), zero).z);
    NUMBER(1, vm_kinetic_energy(IN(0, vm_body, &whole)));
    NUMBER(1, vm_angular_momentum2(IN(0, vm_body2, &whole2), 0, 0));
    NUMBER(1, vm_kinetic_energy2(IN(0, vm_body2, &whole2)));
    NUMBER(1, vm_body_from_body2(IN(0, vm_body2, &whole2)).mass);
    NUMBER(1, vm_parallel_axes(IN(0, vm_inertia, &i), 1, aside).zz);
    ANSWER(1, vm_inertia_is_possible(IN(0, vm_inertia, &i)));
    STATUS(3, vm_balance_between(1, IN(0, vm_body, &whole), 1, IN(1, vm_body, &part), NULL, zero, X(2, vm_balance)));
    STATUS(4, vm_combine_inertia(1, IN(0, vm_inertia, &i), 1, IN(1, vm_inertia, &little), aside, X(2, vm_inertia),
                                 X(3, vm_vec3)));
    STATUS(4, vm_split_inertia(3, IN(0, vm_inertia, &i), 1, IN(1, vm_inertia, &little), aside, X(2, vm_inertia),
                               X(3, vm_vec3)));
    STATUS(3, vm_separate(IN(0, vm_body, &whole), IN(1, vm_body, &part), NULL, X(2, vm_body)));
    STATUS(3, vm_attach(IN(0, vm_body, &whole), IN(1, vm_body, &part), NULL, X(2, vm_body)));
    STATUS(3, vm_separate_all(IN(0, vm_body, &whole), 1, IN(1, vm_body, &part), NULL, X(2, vm_body)));
    STATUS(3, vm_attach_all(IN(0, vm_body, &whole), 1, IN(1, vm_body, &part), NULL, X(2, vm_body)));
    STATUS(4, vm_separate_on_axle(IN(0, vm_axle, &axle), IN(1, vm_body, &whole), 1, IN(2, vm_body, &part), NULL,
                                  X(3, vm_body), NULL));
    STATUS(4, vm_attach_on_axle(IN(0, vm_axle, &axle), IN(1, vm_body, &whole), 1, IN(2, vm_body, &part), NULL,
                                X(3, vm_body), NULL));
    STATUS(3, vm_separate2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), NULL, X(2, vm_body2)));
    STATUS(3, vm_attach2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), NULL, X(2, vm_body2)));
    STATUS(3, vm_separate_all2(IN(0, vm_body2, &whole2), 1, IN(1, vm_body2, &part2), NULL, X(2, vm_body2)));
    STATUS(3, vm_attach_all2(IN(0, vm_body2, &whole2), 1, IN(1, vm_body2, &part2), NULL, X(2, vm_body2)));
    STATUS(3, vm_to_relative(IN(0, vm_body, &whole), IN(1, vm_body, &part), X(2, vm_body)));
    STATUS(3, vm_to_absolute(IN(0, vm_body, &whole), IN(1, vm_body, &part), X(2, vm_body)));
    STATUS(3, vm_to_relative2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), X(2, vm_body2)));
    STATUS(3, vm_to_absolute2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), X(2, vm_body2)));
    STATUS(3, vm_separate_relative(IN(0, vm_body, &whole), IN(1, vm_body, &part), NULL, X(2, vm_body)));
    STATUS(3, vm_attach_relative(IN(0, vm_body, &whole), IN(1, vm_body, &part), NULL, X(2, vm_body)));
    STATUS(3, vm_separate_relative2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), NULL, X(2, vm_body2)));
    STATUS(3, vm_attach_relative2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), NULL, X(2, vm_body2)));
    STATUS(3, vm_separation_for_rest(IN(0, vm_body, &whole), IN(1, vm_body, &part), NULL, NULL, NULL, X(2, vm_body)));
    STATUS(3, vm_separation_for_rest2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &part2), NULL, NULL, NULL, X(2, vm_body2)));
    STATUS(3,
           vm_separation_for_spin2(IN(0, vm_body2, &whole2), IN(1, vm_body2, &out_of_centre), NULL, 1, X(2, vm_body2)));
    NUMBER(3, vm_energy_gain(IN(0, vm_body, &whole), 1, IN(1, vm_body, &part), NULL, IN(2, vm_body, &part)));
    NUMBER(3, vm_energy_loss(IN(0, vm_body, &whole), 1, IN(1, vm_body, &part), NULL, IN(2, vm_body, &part)));
}

static void null_attitude(void)
{
    static const vm_real identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const vm_quat turned = {1, 0, 0, 1};
    STATUS(1, vm_quat_to_matrix(turned, X(0, vm_real)));
    STATUS(2, vm_quat_from_matrix(IN(0, vm_real, identity), X(1, vm_quat)));
    STATUS(1, vm_euler_313_angles(turned, X(0, vm_real)));
    STATUS(1, vm_euler_321_angles(turned, X(0, vm_real)));
}

static void null_torque_free(void)
{
    const vm_quat turned = {1, 0, 0, 0};
    const vm_vec3 aside = {R(0.25), 0, 0};
    const vm_body whole = a_body(3);
    vm_torque_free motion;
    STATUS(2, vm_torque_free_init(IO(0, vm_torque_free, &motion), IN(1, vm_body, &whole), 0));
    STATUS(1, vm_torque_free_init_principal(IO(0, vm_torque_free, &motion), vmi_vec3(1, 2, 2), turned, aside, 0));
    STATUS(2, vm_torque_free_at(IN(0, vm_torque_free, &motion), 1, X(1, vm_body)));
    STATUS(3, vm_torque_free_attitude(IN(0, vm_torque_free, &motion), 1, X(1, vm_quat), X(2, vm_vec3)));
    STATUS(2, vm_torque_free_rotation(IN(0, vm_body, &whole), 1, X(1, vm_body)));
}

static void null_rotor(void)
{
    static const vm_broken_rotor round = {2, 1, 9, R(0.5), 1, 0}, bent = {2, 1, 9, R(0.5), 1, R(0.1)};
    static const vm_real y[6] = {R(0.1), 0, 0, 0, R(0.2), 1};
    vm_broken_rotor rotor = bent;
    vm_broken_rotor_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.mass = R(0.1);
    piece.inertia = R(0.001);
    piece.distance = R(0.1);
    piece.radius = R(0.2);
    piece.alpha = R(0.1);
    STATUS(3, vm_broken_rotor_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_broken_rotor, &rotor)));
    STATUS(3, vm_broken_rotor_polar_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_broken_rotor, &rotor)));
    STATUS(3, vm_broken_rotor_free_motion(IN(0, vm_broken_rotor, &round), 1, IN(1, vm_real, y), X(2, vm_real)));
    STATUS(3, vm_broken_rotor_orbit(IN(0, vm_broken_rotor, &round), IN(1, vm_real, y), X(2, vm_real)));
    STATUS(4, vm_broken_rotor_break_off(IN(0, vm_broken_rotor, &round), IN(1, vm_real, y), IN(2, vm_broken_rotor_piece, &piece),
                                 X(3, vm_broken_rotor_break)));
    STATUS(3, vm_broken_rotor_linear(IN(0, vm_broken_rotor, &bent), 1, IN(1, vm_real, y), X(2, vm_real)));
    STATUS(3, vm_broken_rotor_linear_uncoupled(IN(0, vm_broken_rotor, &bent), 1, IN(1, vm_real, y), X(2, vm_real)));
    STATUS(2, vm_broken_rotor_to_polar(IN(0, vm_real, y), X(1, vm_real)));
    STATUS(2, vm_broken_rotor_from_polar(IN(0, vm_real, y), X(1, vm_real)));
    NUMBER(1, vm_broken_rotor_steady_radius(IN(0, vm_broken_rotor, &bent), 1));
    STATUS(2, vm_broken_rotor_characteristic(IN(0, vm_broken_rotor, &bent), 1, X(1, vm_real)));
    STATUS(3, vm_broken_rotor_eigenvalues(IN(0, vm_broken_rotor, &bent), 1, X(1, vm_real), X(2, vm_real)));
    STATUS(2, vm_broken_rotor_routh(IN(0, vm_broken_rotor, &bent), 1, X(1, vm_real)));
    ANSWER(1, vm_broken_rotor_is_stable(IN(0, vm_broken_rotor, &bent), 1));
    NUMBER(1, vm_broken_rotor_resonance_radius(IN(0, vm_broken_rotor, &bent), 1, 3));
}

static void null_lagrange(void)
{
    static const vm_vec3 along[1] = {{1, 0, 0}};
    static const vm_real two = 2, three = 3, q[2] = {R(0.1), R(0.2)}, y[4] = {R(0.1), R(0.2), R(0.3), R(0.4)};
    static const vm_impulse blow = {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const vm_pendulum pendulum = {1, 1, R(0.3), 1, VM_AXES_COS_SIN};
    const vm_compound_pendulum compound = {3, 4, 1, 0, 2};
    const vm_compound_part disc = {R(0.5), R(0.1), 1, 0, 1, 1, 1};
    const vm_body body = a_body(2);
    vm_real work[VM_LAGRANGE_WORK(1)], moment = 0, mass = 0;
    vm_lagrange_system l = system_of_two();
    NOTHING(2, vm_lagrange_mass(1, IN(0, vm_body, &body), along, NULL, X(1, vm_real)));
    NOTHING(2, vm_lagrange_mass(1, IN(0, vm_body, &body), NULL, along, X(1, vm_real)));
    NOTHING(2, vm_lagrange_momentum(1, IN(0, vm_body, &body), along, NULL, X(1, vm_real)));
    NOTHING(2, vm_lagrange_impulse(1, IN(0, vm_impulse, &blow), along[0], along, NULL, X(1, vm_real)));
    vm_lagrange_mass(1, &body, NULL, along, &moment);
    CHECK(moment == body.inertia.xx); /* no dr: no part of it */
    vm_lagrange_mass(1, &body, along, NULL, &mass);
    CHECK(mass == body.mass);
    STATUS(5, vm_lagrange_separate(1, IN(0, vm_real, &three), IN(1, vm_real, &two), IN(2, vm_real, &two), NULL, NULL,
                                   X(3, vm_real), IO(4, vm_real, work)));
    STATUS(5, vm_lagrange_attach(1, IN(0, vm_real, &two), IN(1, vm_real, &three), IN(2, vm_real, &two), NULL, NULL,
                                 X(3, vm_real), IO(4, vm_real, work)));
    STATUS(5, vm_lagrange_impact(1, IN(0, vm_real, &two), IN(1, vm_real, &two), IN(2, vm_real, &three), X(3, vm_real),
                              IO(4, vm_real, work)));
    STATUS(2, vm_pendulum_separate(IN(0, vm_pendulum, &pendulum), R(0.25), 1, 0, 0, X(1, vm_pendulum_cut)));
    STATUS(3, vm_compound_pendulum_separate(IN(0, vm_compound_pendulum, &compound), IN(1, vm_compound_part, &disc),
                                            X(2, vm_compound_cut)));
    STATUS(3, vm_lagrange_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_lagrange_system, &l)));
    STATUS(4, vm_lagrange_start(IO(0, vm_lagrange_system, &l), 0, IN(1, vm_real, q), IN(2, vm_real, y), X(3, vm_real)));
    STATUS(3, vm_lagrange_rates(IO(0, vm_lagrange_system, &l), 0, IN(1, vm_real, y), X(2, vm_real)));
    NUMBER(3, vm_lagrange_partial_q(IO(0, vm_lagrange_system, &l), 0, IN(1, vm_real, q), IN(2, vm_real, q), 0));
    STATUS(5, vm_lagrange_needed_forces(IO(0, vm_lagrange_system, &l), 0, 1, IN(1, vm_real, q), IN(2, vm_real, q),
                                        IN(3, vm_real, q), X(4, vm_real)));
    STATUS(5, vm_lagrange_drive_forces(IO(0, vm_lagrange_system, &l), 0, 1, IN(1, vm_real, q), IN(2, vm_real, q),
                                       IN(3, vm_real, q), X(4, vm_real)));
    NOTHING(1, vm_lagrange_add_force(1, along[0], along, along[0], NULL, X(0, vm_real)));
    NOTHING(1, vm_euler_313_axes(1, 1, X(0, vm_vec3)));
    NOTHING(1, vm_euler_313_body_axes(1, 1, X(0, vm_vec3)));
    STATUS(1, vm_euler_313_rates(1, 1, along[0], X(0, vm_real)));
}

static void null_streams(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_body body = a_body(3);
    const vm_stream1 line = {1, 0, VM_AT_REST};
    const vm_jet jet = {R(-0.1), 1, 1, R(0.1), R(0.1), R(0.1), 1};
    const vm_supply tank = {VM_TANK_OF_LIQUID, {0, 0, 0}, {0, 0, 1}, 1, 1, 0, 3};
    const vm_vec3 place = {1, 0, 0};
    vm_stream stream;
    vm_stream1 stream1 = line;
    vm_stream2 stream2;
    vm_reactive loads;
    vm_flow flow;
    vm_flow1 flow1;
    vm_flow2 flow2;
    vm_real y[VM_FLOW_BALANCED_STATES] = {0};
    memset(&stream, 0, sizeof stream);
    memset(&stream2, 0, sizeof stream2);
    memset(&flow, 0, sizeof flow);
    memset(&flow1, 0, sizeof flow1);
    memset(&flow2, 0, sizeof flow2);
    flow.n = flow1.n = flow2.n = 1;
    stream.rate = stream2.rate = -1;
    flow.streams = &stream;
    flow1.streams = &stream1;
    flow2.streams = &stream2;
    STATUS(3, vm_reactive_loads(IN(0, vm_body, &body), zero, 1, IN(1, vm_stream, &stream), X(2, vm_reactive)));
    CHECK(vm_reactive_loads(&body, zero, 1, &stream, &loads) == VM_OK);
    STATUS(4, vm_accelerations(IN(0, vm_body, &body), IN(1, vm_reactive, &loads), zero, zero, X(2, vm_vec3),
                               X(3, vm_vec3)));
    STATUS(3, vm_flow_start(IO(0, vm_flow, &flow), IN(1, vm_body, &body), X(2, vm_real)));
    CHECK(vm_flow_start(&flow, &body, y) == VM_OK);
    STATUS(3, vm_flow_body(IN(0, vm_flow, &flow), VM_FLOW_STATES, IN(1, vm_real, y), X(2, vm_body)));
    STATUS(3, vm_flow_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow, &flow)));
    STATUS(3, vm_flow_given_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow, &flow)));
    STATUS(3, vm_flow_carried_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow, &flow)));
    STATUS(3, vm_flow_balanced_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow, &flow)));
    NUMBER(2, vm_flow_mass_left(0, IN(0, vm_real, y), IO(1, vm_flow, &flow)));
    NUMBER(2, vm_flow_inertia_left(0, IN(0, vm_real, y), IO(1, vm_flow, &flow)));
    y[2] = y[6] = y[9] = 1;
    STATUS(3, vm_translation_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow, &flow)));
    STATUS(3, vm_flow1_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow1, &flow1)));
    STATUS(3, vm_flow2_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_flow2, &flow2)));
    flow.streams = NULL;
    flow1.streams = NULL;
    flow2.streams = NULL; /* one stream, which is not there */
    CHECK(vm_flow_start(&flow, &body, y) == VM_BAD_ARGUMENT);
    CHECK(vm_flow_rhs(0, y, null_output[0], &flow) == VM_BAD_ARGUMENT);
    CHECK(vm_flow_given_rhs(0, y, null_output[0], &flow) == VM_BAD_ARGUMENT);
    CHECK(vm_flow_balanced_rhs(0, y, null_output[0], &flow) == VM_BAD_ARGUMENT);
    CHECK(vm_translation_rhs(0, y, null_output[0], &flow) == VM_BAD_ARGUMENT);
    CHECK(vm_flow1_rhs(0, y, null_output[0], &flow1) == VM_BAD_ARGUMENT);
    CHECK(vm_flow2_rhs(0, y, null_output[0], &flow2) == VM_BAD_ARGUMENT);
    STATUS(3, vm_linear_flow(IN(0, vm_stream1, &line), 1, 0, 1, 2, 0, X(1, vm_real), X(2, vm_real)));
    STATUS(2, vm_supply_at(IN(0, vm_supply, &tank), 1, X(1, vm_supply_left)));
    STATUS(2, vm_orbit(1, 1, place, zero, X(0, vm_vec3), X(1, vm_vec3)));
    STATUS(2, vm_orbit_meshchersky(1, 1, R(0.1), place, zero, X(0, vm_vec3), X(1, vm_vec3)));
    STATUS(2, vm_jet_damping(IN(0, vm_jet, &jet), 1, zero, X(1, vm_vec3)));
}

static void null_drum(void)
{
    static const vm_real y[6] = {R(0.1), 0, 0, 0, R(0.2), 1}, y_coupled[6] = {R(0.1), 0, 0, 0, 3, 0};
    vm_drum d = {R(0.3), 20, R(0.9), R(0.45), R(0.9), R(0.05), 2000, 3};
    vm_drum_shaft shaft = {0};
    STATUS(2, vm_drum_at(IN(0, vm_drum, &d), 1, X(1, vm_drum_geometry)));
    STATUS(3, vm_drum_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_drum, &d)));
    STATUS(3, vm_drum_rhs_reduced(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_drum, &d)));
    STATUS(3, vm_drum_rhs_angle(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_drum, &d)));
    STATUS(3, vm_drum_rhs_coupled(0, IN(0, vm_real, y_coupled), X(1, vm_real), IO(2, vm_drum, &d)));
    NUMBER(1, vm_drum_rate(IN(0, vm_drum, &d), 1));
    NUMBER(1, vm_drum_rate_elastic(IN(0, vm_drum, &d), 1, R(0.01)));
    NUMBER(1, vm_drum_time(IN(0, vm_drum, &d), 1));
    NUMBER(1, vm_drum_angle(IN(0, vm_drum, &d), 1));
    NUMBER(1, vm_drum_stop(IN(0, vm_drum, &d)));
    NUMBER(1, vm_drum_angle_lambert(IN(0, vm_drum, &d), R(0.1)));
    STATUS(2, vm_drum_shaft_init(IO(1, vm_drum_shaft, &shaft), IN(0, vm_drum, &d)));
    CHECK(vm_drum_shaft_init(&shaft, &d) == VM_OK);
    STATUS(3, vm_drum_unbalance(IN(0, vm_drum, &d), 1, X(1, vm_real), X(2, vm_real)));
    NUMBER(1, vm_drum_deflection(IN(0, vm_drum_shaft, &shaft), 1, 1, 0, 0));
    NUMBER(1, vm_drum_deflection_slope(IN(0, vm_drum_shaft, &shaft), 1, 1, 0, 0));
    STATUS(3, vm_drum_deflection_start(IN(0, vm_drum_shaft, &shaft), 1, 0, 0, X(1, vm_real), X(2, vm_real)));
    ANSWER(1, vm_drum_shaft_valid(IN(0, vm_drum_shaft, &shaft)));
}

static void null_oscillators(void)
{
    const vm_law law = vm_law_linear(1, 0);
    vm_osc_problem o, with_load;
    vm_osc_plan p;
    vm_osc_load load;
    static vm_osc_closed c;
    memset(&o, 0, sizeof o);
    o.mass = law;
    o.stiffness = vm_law_linear(4, 0);
    o.x = 1;
    o.alpha = 1;
    with_load = o;
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
    CHECK(vm_osc_closed_init(&c, &o, 5, 1) == VM_OK);
    NOTHING(2, vm_osc_exact(1, 1, 2, 3, X(0, vm_real), X(1, vm_real)));
    NOTHING(2, vm_osc_trig(1, 1, 2, 3, X(0, vm_real), X(1, vm_real)));
    NOTHING(2, vm_osc_jacobi(1, 1, 2, 3, X(0, vm_real), X(1, vm_real)));
    NOTHING(2, vm_osc_amplitude_phase(1, 1, 2, 3, X(0, vm_real), X(1, vm_real)));
    NOTHING(2, vm_osc_exact_from(1, 1, 1, 2, 3, X(0, vm_real), X(1, vm_real)));
    STATUS(3, vm_law_at(IN(0, vm_law, &law), 1, X(1, vm_real), X(2, vm_real)));
    STATUS(2, vm_law_inverse_integral(IN(0, vm_law, &law), 1, X(1, vm_real)));
    STATUS(3, vm_law_ratio_integral(IN(0, vm_law, &law), IN(1, vm_law, &law), 1, X(2, vm_real)));
    CHECK(vm_osc_load_init(&load, &with_load, NULL, NULL) == VM_OK);
    NUMBER(1, vm_osc_load_force(0, 1, 1, IO(0, vm_osc_load, &load)));
    CHECK(vm_osc_load_init(NULL, &o, NULL, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_load_init(&load, NULL, NULL, NULL) == VM_BAD_ARGUMENT);
    NUMBER(1, vm_adiabaticity(IN(0, vm_osc_problem, &o), 0, 1));
    STATUS(2, vm_osc_plan_init(IO(0, vm_osc_plan, &p), IN(1, vm_osc_problem, &o)));
    STATUS(2, vm_osc_closed_init(IO(0, vm_osc_closed, &c), IN(1, vm_osc_problem, &o), 5, 1));
    STATUS(3, vm_osc_closed_at(IN(0, vm_osc_closed, &c), 1, X(1, vm_real), X(2, vm_real)));
    STATUS(3, vm_osc_closed_at_order2(IN(0, vm_osc_closed, &c), 1, X(1, vm_real), X(2, vm_real)));
    STATUS(3, vm_osc_closed_at_order3(IN(0, vm_osc_closed, &c), 1, X(1, vm_real), X(2, vm_real)));
    STATUS(2, vm_osc_plan_by_route(IN(0, vm_osc_plan, &p), VM_ROUTE_RK45, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_plan_within(IN(0, vm_osc_plan, &p), 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_RK45, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_within(IN(0, vm_osc_problem, &o), 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_TRIG, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_JACOBI, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_ATEB, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_ORDER2, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_ORDER3, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_ORDER4, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_ORDER5, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_COLLOCATION, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_RK45, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_osc_by_route(IN(0, vm_osc_problem, &o), VM_ROUTE_RK87, 1, 0, X(1, vm_osc_motion)));
    STATUS(4,
           vm_osc_averaged(IN(0, vm_osc_plan, &p), VM_ROUTE_ATEB, 1, 1, X(1, vm_real), X(2, vm_real), X(3, vm_real)));
    o.mass = vm_law_user(NULL, NULL);
    CHECK(vm_osc_plan_init(&p, &o) == VM_BAD_ARGUMENT);
    o.mass = vm_law_table(2, NULL, NULL);
    CHECK(vm_osc_plan_init(&p, &o) == VM_BAD_ARGUMENT);
}

/* A state for all right-hand sides of slow vibrations */
static const vm_real slow_y[5] = {R(0.1), R(0.2), R(0.3), R(0.4), R(0.5)};

static void null_odd_force(void)
{
    const vm_odd_force force = vm_duffing_force(1, 1);
    vm_odd_problem o;
    static vm_odd_plan p;
    o.force = force;
    o.mass = vm_law_linear(1, 0);
    o.stiffness = vm_law_linear(1, 0);
    o.damping = vm_law_linear(0, 0);
    o.reactive = 1;
    o.x = 1;
    o.v = 0;
    CHECK(vm_odd_plan_init(&p, &o, 2) == VM_OK);
    NUMBER(1, vm_odd_period(IN(0, vm_odd_force, &force), 1));
    NUMBER(1, vm_odd_action(IN(0, vm_odd_force, &force), 1));
    STATUS(3, vm_odd_exact_from(IN(0, vm_odd_force, &force), 1, 1, 0, X(1, vm_real), X(2, vm_real)));
    STATUS(2, vm_odd_plan_init(IO(0, vm_odd_plan, &p), IN(1, vm_odd_problem, &o), 2));
    STATUS(3, vm_odd_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_odd_problem, &o)));
    STATUS(2, vm_odd_plan_by_route(IN(0, vm_odd_plan, &p), VM_ODD_ORDER2, 1, 0, X(1, vm_odd_motion)));
    STATUS(2, vm_odd_plan_within(IN(0, vm_odd_plan, &p), 1, 0, X(1, vm_odd_motion)));
    STATUS(2, vm_odd_within(IN(0, vm_odd_problem, &o), 1, 0, X(1, vm_odd_motion)));
    NOTHING(2, vm_duffing_exact_from(1, 1, 0, 1, 1, X(0, vm_real), X(1, vm_real)));
    o.force = vm_odd_force_user(NULL, NULL);
    CHECK(vm_odd_plan_init(&p, &o, 2) == VM_BAD_ARGUMENT);
    o.force = vm_duffing_force_of_laws(NULL);
    CHECK(vm_odd_plan_init(&p, &o, 2) == VM_BAD_ARGUMENT);
}

static void null_van_der_pol(void)
{
    static vm_vdp_plan p;
    vm_vdp v = a_vdp();
    CHECK(vm_vdp_init(&v) == VM_OK);
    STATUS(1, vm_vdp_init(IO(0, vm_vdp, &v)));
    NUMBER(1, vm_vdp_amplitude(IN(0, vm_vdp, &v), 1, 1));
    NUMBER(1, vm_vdp_limit_cycle(IN(0, vm_vdp, &v), 0, NULL));
    STATUS(3, vm_vdp_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_vdp, &v)));
    STATUS(3, vm_vdp_averaged_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_vdp, &v)));
    CHECK(vm_vdp_plan_init(&p, &v, 1, 0) == VM_OK);
    STATUS(2, vm_vdp_plan_init(IO(0, vm_vdp_plan, &p), IN(1, vm_vdp, &v), 1, 0));
    STATUS(2, vm_vdp_plan_by_route(IN(0, vm_vdp_plan, &p), VM_ROUTE_ORDER3, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_vdp_plan_by_route(IN(0, vm_vdp_plan, &p), VM_ROUTE_RK87, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_vdp_plan_within(IN(0, vm_vdp_plan, &p), 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_vdp_within(IN(0, vm_vdp, &v), 1, 0, 1, 0, X(1, vm_osc_motion)));
    STATUS(2, vm_vdp_cycle_of(IN(0, vm_vdp, &v), X(1, vm_vdp_cycle)));
}

static void null_laval(void)
{
    const vm_power_force first = {3, 1};
    vm_power_force power = cubic;
    vm_jeffcott r = a_laval(), soft = a_laval();
    soft.stiffness_ctx = (void *)&first;
    NUMBER(2, vm_jeffcott_power(1, X(0, vm_real), IO(1, vm_power_force, &power)));
    NOTHING(2, vm_jeffcott_polar(vmi_complex(1, 2), X(0, vm_real), X(1, vm_real)));
    NUMBER(1, vm_jeffcott_momentum(IN(0, vm_jeffcott, &r), 1, vmi_complex(1, 2), vmi_complex(2, 3)));
    STATUS(3, vm_jeffcott_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_jeffcott, &r)));
    STATUS(3, vm_jeffcott_to_averaged(IN(0, vm_jeffcott, &soft), 0, IN(1, vm_real, slow_y), 0, X(2, vm_real)));
    STATUS(3, vm_jeffcott_from_averaged(IN(0, vm_jeffcott, &soft), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_jeffcott_exact_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_jeffcott, &soft)));
    STATUS(3, vm_jeffcott_averaged_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_jeffcott, &soft)));
    NUMBER(1, vm_jeffcott_frequency(IN(0, vm_jeffcott, &r), 1, 1, 1));
    STATUS(3, vm_jeffcott_forward_whirl_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_jeffcott, &r)));
    STATUS(3, vm_jeffcott_backward_whirl_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_jeffcott, &r)));
    NUMBER(1, vm_jeffcott_amplitude(IN(0, vm_jeffcott, &r), 1, 1, 2));
    NUMBER(1, vm_jeffcott_whirl_amplitude(IN(0, vm_jeffcott, &r), 1, 1, 2, 1));
    STATUS(2, vm_jeffcott_whirl_at(IN(0, vm_jeffcott, &r), 1, 0, 1, 1, X(1, vm_jeffcott_whirl)));
    STATUS(3, vm_jeffcott_linear_at(IN(0, vm_jeffcott, &soft), IN(1, vm_real, slow_y), 1, X(2, vm_real)));
    memset(&r.mass, 0, sizeof r.mass); /* no law */
    soft.mass = r.mass;
    CHECK(vm_jeffcott_rhs(0, slow_y, null_output[0], &r) == VM_BAD_ARGUMENT);
    CHECK(vm_jeffcott_to_averaged(&soft, 0, slow_y, 0, null_output[0]) == VM_BAD_ARGUMENT);
    r = a_laval();
    r.stiffness = NULL;
    CHECK(vm_jeffcott_rhs(0, slow_y, null_output[0], &r) == VM_BAD_ARGUMENT);
    CHECK(vm_jeffcott_forward_whirl_rhs(0, slow_y, null_output[0], &r) == VM_BAD_ARGUMENT);
    CHECK(isnan((double)vm_jeffcott_frequency(&r, 1, 1, 1)) && isnan((double)vm_jeffcott_amplitude(&r, 1, 1, 2)));
}

static void null_pair(void)
{
    vm_pair pair = a_pair();
    vm_coupled_pair coupled = a_coupled_pair();
    STATUS(3, vm_pair_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_pair, &pair)));
    STATUS(3, vm_pair_to_averaged(IN(0, vm_pair, &pair), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_pair_from_averaged(IN(0, vm_pair, &pair), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_pair_averaged_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_pair, &pair)));
    STATUS(3, vm_pair_at(IN(0, vm_pair, &pair), 1, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_pair_by_method(IN(0, vm_pair, &pair), VM_PAIR_TRIG, 1, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_coupled_pair_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_coupled_pair, &coupled)));
    STATUS(3, vm_coupled_pair_to_modes(IN(0, vm_coupled_pair, &coupled), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_coupled_pair_from_modes(IN(0, vm_coupled_pair, &coupled), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_coupled_pair_oscillator(IO(0, vm_coupled_pair, &coupled), IN(1, vm_real, slow_y),
                                         X(2, vm_osc_problem)));
    coupled.connections = NULL; /* one connection, which is not there */
    CHECK(vm_coupled_pair_rhs(0, slow_y, null_output[0], &coupled) == VM_BAD_ARGUMENT);
    memset(&pair.mass, 0, sizeof pair.mass); /* no law */
    CHECK(vm_pair_rhs(0, slow_y, null_output[0], &pair) == VM_BAD_ARGUMENT);
    CHECK(vm_pair_to_averaged(&pair, 0, slow_y, null_output[0]) == VM_BAD_ARGUMENT);
}

static void null_forced(void)
{
    vm_forced f = a_forced();
    STATUS(1, vm_forced_init(IO(0, vm_forced, &f)));
    STATUS(3, vm_forced_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_forced, &f)));
    STATUS(3, vm_forced_exact_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_forced, &f)));
    STATUS(3, vm_forced_averaged_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_forced, &f)));
    STATUS(3, vm_forced_to_averaged(IN(0, vm_forced, &f), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_forced_from_averaged(IN(0, vm_forced, &f), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(2, vm_forced_steady_states(IN(0, vm_forced, &f), 0, X(1, vm_steady_state)));
    STATUS(2, vm_forced_curve(IN(0, vm_forced, &f), 0, R(0.1), X(1, vm_steady_state)));
    NUMBER(1, vm_forced_peak(IN(0, vm_forced, &f), 0));
    STATUS(2, vm_forced_passage(IN(0, vm_forced, &f), 0, R(0.1), X(1, vm_passage)));
    memset(&f, 0, sizeof f);
    f.mass = f.stiffness = vm_law_linear(1, 0); /* not prepared */
    CHECK(vm_forced_to_averaged(&f, 0, slow_y, null_output[0]) < 0 &&
          vm_forced_averaged_rhs(0, slow_y, null_output[0], &f) < 0);
}

static void null_periodic(void)
{
    vm_periodic p = a_periodic();
    STATUS(1, vm_periodic_init(IO(0, vm_periodic, &p)));
    STATUS(2, vm_periodic_from_samples(IO(0, vm_periodic, &p), 4, IN(1, vm_real, slow_y)));
    NUMBER(1, vm_periodic_shape(IN(0, vm_periodic, &p), 1));
    STATUS(3, vm_periodic_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_periodic, &p)));
    STATUS(3, vm_periodic_exact_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_periodic, &p)));
    STATUS(3, vm_periodic_averaged_rhs(0, IN(0, vm_real, slow_y), X(1, vm_real), IO(2, vm_periodic, &p)));
    STATUS(3, vm_periodic_to_averaged(IN(0, vm_periodic, &p), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    STATUS(3, vm_periodic_from_averaged(IN(0, vm_periodic, &p), 0, IN(1, vm_real, slow_y), X(2, vm_real)));
    p = a_periodic();
    STATUS(2, vm_periodic_curve(IN(0, vm_periodic, &p), 0, R(-0.5), X(1, vm_steady_state)));
    STATUS(2, vm_periodic_steady_states(IN(0, vm_periodic, &p), 0, 1, X(1, vm_steady_state)));
}

static void null_grounded_pair(void)
{
    static const vm_real moving[4] = {1, R(0.9), R(0.1), R(0.2)};
    vm_grounded_pair p = a_grounded_pair();
    STATUS(1, vm_grounded_pair_init(IO(0, vm_grounded_pair, &p)));
    STATUS(3, vm_grounded_pair_rhs(0, IN(0, vm_real, moving), X(1, vm_real), IO(2, vm_grounded_pair, &p)));
    STATUS(3, vm_grounded_pair_averaged_rhs(0, IN(0, vm_real, moving), X(1, vm_real), IO(2, vm_grounded_pair, &p)));
    STATUS(3, vm_grounded_pair_to_averaged(IN(0, vm_grounded_pair, &p), 0, IN(1, vm_real, moving), X(2, vm_real)));
    STATUS(3, vm_grounded_pair_from_averaged(IN(0, vm_grounded_pair, &p), 0, IN(1, vm_real, moving), X(2, vm_real)));
}

static vm_real null_law(vm_real t, void *ctx)
{
    (void)ctx;
    return 1 + t;
}

static void null_motion(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    (void)ctx;
    *x = t - R(0.5);
    *v = 1;
}

static void null_diagnostics(void)
{
    static const vm_sample points[1] = {{1, 2, 0}};
    vm_real y[2] = {R(-0.1), 1}, work[RK45_WORK(2)], buffer[2];
    rk45 s;
    STATUS(1, vm_find_samples(null_motion, NULL, VM_ZERO_CROSSINGS, 0, 2, R(0.3), 4, X(0, vm_sample)));
    CHECK(vm_find_samples(NULL, NULL, VM_ZERO_CROSSINGS, 0, 2, R(0.3), 4, (vm_sample *)(void *)null_output) ==
          VM_BAD_ARGUMENT);
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, NULL, work) == ODE_OK && rk45_solve(&s, 1) == ODE_OK);
    STATUS(3, vm_find_samples_of_step(IO(0, rk45, &s), 0, 1, VM_ZERO_CROSSINGS, IO(1, vm_real, buffer), 4,
                                     X(2, vm_sample)));
    NUMBER(1, vm_envelope_error(VM_TURNING_POINTS, 1, IN(0, vm_sample, points), null_law, NULL));
    CHECK(isnan((double)vm_envelope_error(VM_TURNING_POINTS, 1, points, NULL, NULL)));
}

/* What a scene is made of: a constructor with a null pointer makes what the check refuses */
static vm_real null_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return t - x - v;
}

static vm_mass_law_values null_mass(vm_real t, vm_real x, vm_real v, void *ctx)
{
    const vm_mass_law_values now = {2, 0, 0, 0};
    (void)t;
    (void)x;
    (void)v;
    (void)ctx;
    return now;
}

static void null_apply(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    (void)e;
    (void)t;
    (void)y;
    (void)s;
}
static void null_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)t;
    (void)ctx;
    r->x = 2;
    v->x = 0;
    a->x = 0;
}
static void null_vary(vm_real t, const vm_real *y, vm_stream *stream, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    stream->rate = 1;
}

static vm_real null_when(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t - 1;
}

static int null_then(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    return VM_OK;
}

/* Whether a scene of these is refused: a line, an axle, a growing body in the plane and one in space */
static int null_in_scene(const vm_scene_body *body, const vm_effect *effect, const vm_event *event)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_body free_body = a_body(2);
    vm_scene_body bodies[6];
    vm_effect effects[1];
    vm_event events[1];
    ode_event located[1];
    vm_scene s;
    memset(&s, 0, sizeof s);
    bodies[0] = vm_scene_body_line(2, 0, 1);
    bodies[1] = vm_scene_body_axle(2, 0, 1);
    bodies[2] = vm_scene_body_plane(2, 1, zero, 0, zero, 0);
    bodies[3] = body ? *body : vm_scene_body_free(&free_body);
    bodies[4] = vm_scene_body_growing_free(vm_scene_body_free(&free_body));
    bodies[5] = vm_scene_body_absent(vm_scene_body_line(1, 0, 0));
    s.bodies = bodies;
    s.n_bodies = 6;
    s.effects = effects;
    s.n_effects = effect != NULL;
    s.events = events;
    s.n_events = event != NULL;
    s.located = located;
    if (effect) effects[0] = *effect;
    if (event) events[0] = *event;
    return vm_scene_check(&s, NULL);
}
static int body_in_scene(vm_scene_body body) { return null_in_scene(&body, NULL, NULL); }
static int effect_in_scene(vm_effect effect) { return null_in_scene(NULL, &effect, NULL); }
static int event_in_scene(vm_event event) { return null_in_scene(NULL, NULL, &event); }
#define CALLBACK(k, function) (null_at == (k) ? NULL : (function))

static void null_points_of_scenes(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_real room[VM_JOINTS_WORK(1)];
    vm_joint list[1];
    vm_point_spring spring;
    vm_contact contact;
    vm_joints joints;
    memset(&spring, 0, sizeof spring);
    memset(&contact, 0, sizeof contact);
    contact.normal.y = 1;
    list[0] = vm_joint_pin(2, zero, VM_GROUND, zero);
    joints.joints = list;
    joints.n_joints = 1;
    joints.rate = 1;
    joints.work = room;
    joints.work_size = VM_LENGTH(room);
    STATUS(1, effect_in_scene(vm_effect_point_spring(2, VM_GROUND, IN(0, vm_point_spring, &spring))));
    STATUS(1, effect_in_scene(vm_effect_contact(2, IN(0, vm_contact, &contact))));
    STATUS(1, effect_in_scene(vm_effect_joints(IN(0, vm_joints, &joints))));
    STATUS(1, event_in_scene(vm_event_contact(2, IN(0, vm_contact, &contact))));
}

static void null_parts_of_scenes(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_band band = {R(0.5), R(0.01), R(0.1), 7, 0, 1, 0};
    const vm_law growth = vm_law_linear(2, 1);
    vm_body body = a_body(2), part;
    vm_stream stream;
    vm_effect mass;
    vm_event action = vm_then_stop(vm_event_at(1));
    memset(&stream, 0, sizeof stream);
    memset(&part, 0, sizeof part);
    stream.rate = 1;
    part.mass = 1;
    mass = vm_effect_stream_mass(4, &stream);
    STATUS(1, body_in_scene(vm_scene_body_free(IN(0, vm_body, &body))));
    STATUS(1, body_in_scene(vm_scene_body_growing_free(vm_scene_body_free(IN(0, vm_body, &body)))));
    STATUS(1, effect_in_scene(vm_effect_force(0, 0, CALLBACK(0, null_force), NULL)));
    STATUS(1, effect_in_scene(vm_effect_force_between(0, 0, 3, 0, CALLBACK(0, null_force), NULL)));
    STATUS(1, effect_in_scene(vm_effect_custom(0, VM_GROUND, CALLBACK(0, null_apply), NULL)));
    STATUS(1, effect_in_scene(vm_effect_link(2, VM_GROUND, CALLBACK(0, null_point), NULL, 1, 0, 1)));
    STATUS(1, effect_in_scene(vm_effect_mass_law(0, CALLBACK(0, null_mass), NULL, zero, 1)));
    STATUS(1, effect_in_scene(vm_effect_mass_of_time(0, IN(0, vm_law, &growth), zero, 1)));
    STATUS(1, effect_in_scene(vm_effect_stream_mass(4, IN(0, vm_stream, &stream))));
    STATUS(1, effect_in_scene(vm_effect_stream_force(4, IN(0, vm_stream, &stream))));
    STATUS(1, effect_in_scene(vm_effect_stream_moment(4, IN(0, vm_stream, &stream))));
    STATUS(1, effect_in_scene(vm_effect_stream_torque(4, IN(0, vm_stream, &stream))));
    STATUS(1, effect_in_scene(vm_effect_varying(mass, CALLBACK(0, null_vary), NULL)));
    STATUS(1, effect_in_scene(vm_effect_band(1, IN(0, vm_band, &band))));
    null_points_of_scenes();
    NUMBER(1, vm_band_at(1, IN(0, vm_band, &band)).inertia);
    STATUS(1, event_in_scene(vm_then_stop(vm_event_user(CALLBACK(0, null_when), NULL, 0))));
    STATUS(1, event_in_scene(vm_then_user(vm_event_at(1), CALLBACK(0, null_then), NULL)));
    STATUS(1, event_in_scene(vm_then_all(vm_event_at(1), IO(0, vm_event, &action), 1)));
    STATUS(1, event_in_scene(vm_then_separate(vm_event_at(1), 0, 5, IN(0, vm_body, &part), 0)));
    STATUS(1, event_in_scene(vm_then_separate_on_line(vm_event_at(1), 0, 5, IN(0, vm_body, &part), 0)));
    part.inertia.zz = 1;
    CHECK(event_in_scene(vm_then_separate_in_plane(vm_event_at(1), 2, 3, NULL, 0)) == VM_BAD_ARGUMENT);
    NOTHING(2, vm_force_shaft(2, 3, 1, 1, X(0, vm_real), X(1, vm_real)));
    NOTHING(2, vm_force_unbalance(3, 1, 1, 2, X(0, vm_real), X(1, vm_real)));
    NOTHING(2, vm_force_gyroscopic(2, 3, 1, X(0, vm_real), X(1, vm_real)));
}

static int run_from_0(vm_scene *s, vm_real *t, vm_real *y, vm_real *work)
{
    if (t) *t = 0;
    return vm_scene_run(s, t, 1, y, work, NULL);
}

/* Whether vm_scene_push_at finds no fault; with a null pointer it must not crash */
static int push_works(vm_scene *scene, const vm_real *y)
{
    int works;
    vm_scene_push_at(scene, 0, vmi_vec3(1, 0, 0), y, vmi_vec3(0, 0, 1));
    if (!scene) return 0;
    works = scene->status == VM_OK;
    scene->status = VM_OK;
    return works;
}

static void null_scenes(void)
{
    vm_scene_body body = vm_scene_body_line(2, 0, 1);
    vm_real y[2 + VM_BUDGET_STATES] = {0}, z[2 + VM_BUDGET_STATES], work[VM_SCENE_WORK(2 + VM_BUDGET_STATES)], t;
    vm_scene_fault culprit;
    vm_budget book, totals;
    vm_scene s;
    memset(&s, 0, sizeof s);
    s.bodies = &body;
    s.n_bodies = 1;
    null_clear();
    vm_scene_keep_budget(NULL, (vm_budget *)(void *)null_output);
    CHECK(null_untouched());
    vm_scene_keep_budget(&s, &book);
    STATUS(1, vm_scene_check(IN(0, vm_scene, &s), &culprit));
    STATUS(1, vm_scene_size(IN(0, vm_scene, &s)));
    STATUS(2, vm_scene_start(IO(0, vm_scene, &s), 0, IO(1, vm_real, y), NULL));
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_OK);
    memcpy(z, y, sizeof z);
    STATUS(3, vm_scene_rhs(0, IN(0, vm_real, y), X(1, vm_real), IO(2, vm_scene, &s)));
    STATUS(4, run_from_0(IO(0, vm_scene, &s), IO(1, vm_real, &t), IO(2, vm_real, z), IO(3, vm_real, work)));
    STATUS(3, vm_scene_budget_at(IO(0, vm_scene, &s), 0, IN(1, vm_real, y), IO(2, vm_budget, &totals)));
    NOTHING(3, vm_scene_body_at(IN(0, vm_scene, &s), 0, IN(1, vm_real, y), X(2, vm_body)));
    NOTHING(4, vm_scene_point_at(IN(0, vm_scene, &s), 0, vmi_vec3(1, 0, 0), IN(1, vm_real, y), X(2, vm_vec3), X(3, vm_vec3)));
    ANSWER(2, push_works(IO(0, vm_scene, &s), IN(1, vm_real, y)));
    s.bodies = NULL;
    CHECK(vm_scene_size(&s) == VM_BAD_ARGUMENT && vm_scene_check(&s, NULL) == VM_BAD_ARGUMENT);
}

static void call_with_null_pointers(void)
{
    null_bodies();
    null_attitude();
    null_torque_free();
    null_rotor();
    null_lagrange();
    null_streams();
    null_drum();
    null_oscillators();
    null_odd_force();
    null_van_der_pol();
    null_laval();
    null_pair();
    null_forced();
    null_periodic();
    null_grounded_pair();
    null_diagnostics();
    null_parts_of_scenes();
    null_scenes();
}

#endif
