#!/bin/sh
# Flash of scenes on Cortex-M0 and M4F in float, as a table (markdown): each row is what an image grows by, beyond one
# that does nothing. Then the link map of a scene of two effects: no function of another effect or motion is in it.
# usage: scene_sizes.sh BUILD_FOLDER, from the top of the project
build=$1/scene_sizes
mkdir -p "$build"
flags="-std=c99 -Os -DVM_USE_FLOAT -fno-math-errno -ffp-contract=off -ffunction-sections -fdata-sections -nostartfiles -T tests/cross/cortex_m.ld -Wl,--gc-sections -Wl,--defsym=FLASH_SIZE=0x40000"

# image TARGET BODIES EFFECTS EVENTS CALL : $build/scene.elf and its map
image() {
    case $1 in
    M0) cpu="-mcpu=cortex-m0 -mthumb -Wl,--defsym=RAM_SIZE=0x4000" ;;
    M4F) cpu="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Wl,--defsym=RAM_SIZE=0x10000" ;;
    esac
    cat >"$build/scene.c" <<END
#include "varmass.h"
volatile vm_real sink;
static vm_vec3 zero;
static vm_body part;
static vm_stream stream;
static vm_band band = {1, 1, 1, 1, 1, 1, 0};
static vm_budget book;
static vm_scene_body bodies[2];
static vm_effect effects[5];
static vm_event events[1];
static ode_event located[1];
static vm_scene scene;
static vm_real t, y[40], d[40], work[VM_SCENE_WORK(40)];
static volatile int none; /* so that the compiler leaves out nothing because a scene lists nothing */
int main(void)
{
    vm_scene_body *b = bodies;
    vm_effect *e = effects;
    vm_event *v = events;
    (void)zero, (void)part, (void)stream, (void)band, (void)book, (void)t, (void)y, (void)d, (void)work;
    (void)b, (void)e, (void)v;
    part.mass = 1;
    $2
    $3
    $4
    scene.bodies = bodies, scene.n_bodies = (int)(b - bodies) + none, scene.effects = effects;
    scene.n_effects = (int)(e - effects) + none;
    scene.events = events, scene.located = located, scene.n_events = (int)(v - events) + none;
    $5
    return (int)(sink = d[0] + y[0]);
}
END
    arm-none-eabi-gcc $cpu $flags -Wl,-Map="$build/scene.map" -I. tests/cross/cortex_m.c "$build/scene.c" -o "$build/scene.elf" -lm
}
flash() { arm-none-eabi-size "$build/scene.elf" | awk 'NR == 2 {print $1 + $2}'; }

row() { # row NAME BODIES EFFECTS EVENTS CALL
    printf '| %s |' "$1"
    for target in M0 M4F; do
        image $target "" "" "" "" || exit 1
        nothing=$(flash)
        image $target "$2" "$3" "$4" "$5" || exit 1
        printf ' %s |' $(($(flash) - nothing))
    done
    printf '\n'
}
evaluate="vm_scene_start(\&scene, 0, y, NULL), vm_scene_rhs(0, y, d, \&scene);"
evaluate=$(echo "$evaluate" | tr -d '\\')
simulate=$(echo "$evaluate" | sed 's/vm_scene_rhs.*/vm_scene_run(\&scene, \&t, 1, y, work, NULL);/')
line="*b++ = vm_scene_body_line(1, 0, 0);"
moving="*b++ = vm_scene_body_with_mass_state(vm_scene_body_line(1, 0, 0));"
spring="*e++ = vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1, 0);"
damper="*e++ = vm_effect_damper(0, 0, VM_GROUND, 0, 1);"
drop="*b++ = vm_scene_body_absent(vm_scene_body_line(1, 0, 0));"
plane="*b++ = vm_scene_body_plane(1, 1, zero, 0, zero, 0);"
growing="*b++ = vm_scene_body_growing_plane(vm_scene_body_plane(1, 1, zero, 0, zero, 0));"

cat <<'END'
# Flash of scenes

This page is written by `make scene-sizes`.

A scene is a list of bodies, of forces on them and of events, from which the kit computes a motion. The tables show by how many
bytes of flash (the memory that stores the program) a program grows when a scene is added to it, with all functions and constants
that the scene needs. The programs compute in float and are compiled by gcc -Os. The column M0 is for the processor Cortex-M0,
which has no floating-point unit; the numbers in this column include the code that emulates floating-point arithmetic. The column
M4F is for the processor Cortex-M4F, which has a floating-point unit.

| a scene with vm_scene_start and vm_scene_rhs | M0 | M4F |
|---|---|---|
END
row "a body on a line, nothing acts" "$line" "" "" "$evaluate"
row "a linear spring" "$line" "$spring" "" "$evaluate"
row "a linear spring and a damper" "$line" "$spring $damper" "" "$evaluate"
row "a linear spring, a damper and a stream; the mass is a state" "$moving" "$spring $damper *e++ = vm_effect_stream(0, 1, zero, 1);" "" "$evaluate"
row "a spring of any power" "$line" "*e++ = vm_effect_spring(0, 0, VM_GROUND, 0, 1, 3, 0);" "" "$evaluate"
row "Van der Pol's damper" "$line" "*e++ = vm_effect_van_der_pol(0, 0, 1, 1);" "" "$evaluate"
row "a motor" "$line" "*e++ = vm_effect_motor(0, 0, 1, 1);" "" "$evaluate"
row "harmonic excitation" "$line" "*e++ = vm_effect_harmonic(0, 0, 1, 1, 0);" "" "$evaluate"
row "a mass law" "$line" "*e++ = vm_effect_mass(0, VM_MASS_OF_T, 1, 0, 1);" "" "$evaluate"
row "an axle with a band in layers" "*b++ = vm_scene_body_axle(1, 0, 1);" "*e++ = vm_effect_band(0, &band);" "" "$evaluate"
row "a point, nothing acts" "*b++ = vm_scene_body_point(1, zero, zero);" "" "" "$evaluate"
row "a pendulum: a point, gravity, a link" "*b++ = vm_scene_body_point(1, zero, zero); *b++ = vm_scene_body_line(1, 0, 0);" "*e++ = vm_effect_gravity(0, 1, -9.81f); *e++ = vm_effect_link(0, 1, NULL, NULL, 1, 0, 1);" "" "$evaluate"
row "a body in the plane, nothing acts" "$plane" "" "" "$evaluate"
row "a growing body in the plane, with the mass and force of a stream" "$growing" "*e++ = vm_effect_stream_mass(0, &stream); *e++ = vm_effect_stream_force(0, &stream);" "" "$evaluate"
row "the same body with the stream's moment and torque, too" "$growing" "*e++ = vm_effect_stream_mass(0, &stream); *e++ = vm_effect_stream_force(0, &stream); *e++ = vm_effect_stream_moment(0, &stream); *e++ = vm_effect_stream_torque(0, &stream);" "" "$evaluate"
row "a body free in space, nothing acts" "*b++ = vm_scene_body_free(&part);" "" "" "$evaluate"
cat <<'END'

| a body on a line with spring and damper | M0 | M4F |
|---|---|---|
END
row "run by vm_scene_run" "$line" "$spring $damper" "" "$simulate"
row "run with an event that stops it" "$line" "$spring $damper" "*v++ = vm_then_stop(vm_event_position(0, 0, 1, 1));" "$simulate"
row "run with an event that switches the spring off" "$line" "$spring $damper" "*v++ = vm_then_switch(vm_event_position(0, 0, 1, 1), 0, 1);" "$simulate"
row "run with an event that separates a part, by the function for a line" "$line $drop" "$spring $damper" "*v++ = vm_then_separate_on_line(vm_event_at(1), 0, 1, &part, 1);" "$simulate"
row "the same event, by the function for all kinds of bodies" "$line $drop" "$spring $damper" "*v++ = vm_then_separate(vm_event_at(1), 0, 1, &part, 1);" "$simulate"
row "run with an event that attaches a body, by the function for a line" "$line $line" "$spring $damper" "*v++ = vm_then_attach_on_line(vm_event_at(1), 0, 1);" "$simulate"
row "run with a budget of momentum and energy, no event" "$line" "$spring $damper" "vm_scene_keep_budget(&scene, &book);" "$simulate vm_scene_budget_at(&scene, t, y, &book);"

image M4F "$line" "$spring $damper" "" "$evaluate"
# the map's sections .text.NAME that were kept have an address that is not 0
awk '/^ \.text\.vm/ {name = $1} name && /0x/ {for (i = 1; i <= NF; i++) if ($i ~ /^0x/) {if ($i !~ /^0x0*$/) print name; break} name = ""}' \
    "$build/scene.map" | sed 's/^\.text\.//; s/\..*//' | sort -u >"$build/linked"
others=$(grep -E '^vmi_(apply|plane|point|free|axle|then|jump|when|growth|crossing|band|link)|^vmi_scene_(totals|rates|happen)' "$build/linked" |
    grep -vE '^vmi_apply_(linear_spring|damper)$')
[ -n "$others" ] && echo "It should not contain: $others" && exit 1
printf '\nIf the scene of a program is a body on a line with a spring and a damper, the program contains no function of the kit for another\n'
printf 'force, for another kind of body or for an event. It contains only the following functions of the kit, apart from those that the\n'
printf 'compiler has inserted into other functions:\n\n'
sed 's/^/- `/; s/$/`/' "$build/linked"
