#!/bin/sh
# The first steps of examples/: less than 60 lines, no warning, and they print what docs/first-steps.md says.
# usage: CC=compiler test_first_steps.sh BUILD_FOLDER, from the top of the project
build=$1/first_steps_test cc=${CC:-cc}
. tests/check.sh
export CC
short() { [ "$(wc -l <"$1")" -lt 60 ]; }
for source in examples/first_steps/*.c; do
    check "$source: short" short "$source"
    check "$source: no warning" $cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c "$source" -o "$build/object.o"
done
check "they print what docs/first-steps.md says" sh examples/first_steps/steps.sh "$build"
check_finish first_steps
