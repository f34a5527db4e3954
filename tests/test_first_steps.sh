#!/bin/sh
# The first steps of examples/: less than 60 lines, and they print what docs/first-steps.md says, which `make first-steps` has
# written from programs that the compiler optimised; here it does not, which shall change no digit. That they compile without
# a warning is checked by make lint.
# usage: CC=compiler test_first_steps.sh BUILD_FOLDER, from the top of the project
build=$1/first_steps_test
. tests/check.sh
export CC
short() { [ "$(wc -l <"$1")" -lt 60 ]; }
for source in examples/first_steps/*.c; do
    check "$source: short" short "$source"
done
check "they print what docs/first-steps.md says" env LEVEL=-O0 sh examples/first_steps/steps.sh "$build"
check_finish first_steps
