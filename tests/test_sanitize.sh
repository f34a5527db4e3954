#!/bin/sh
# The quick part of tests/sanitize.sh: what refuses and what computes, in double under AddressSanitizer and
# UndefinedBehaviorSanitizer; skipped, loudly, where the compiler has none.
# usage: CC=compiler test_sanitize.sh BUILD_FOLDER, from the top of the project
refusals="refusals_numerics refusals_bodies refusals_streams refusals_oscillators refusals_slow refusals_scenes"
tests="$refusals null_pointers jacobi ateb rk4 pairs adaptive dense constant_mass"
mkdir -p "$1"
echo 'int main(void) { return 0; }' >"$1/empty.c"
for compiler in "${CC:-cc}" gcc clang; do
    if $compiler -fsanitize=address,undefined,float-cast-overflow "$1/empty.c" -o "$1/empty" 2>/dev/null && "$1/empty"; then
        CC=$compiler exec sh tests/sanitize.sh "$1" quick $tests
    fi
done
echo "NOT CHECKED: no compiler here has AddressSanitizer and UndefinedBehaviorSanitizer"
echo "sanitize: 0 passed, 0 failed, $(echo $tests | wc -w) skipped"
