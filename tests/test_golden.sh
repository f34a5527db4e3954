#!/bin/sh
# The bits of tests/data/golden.txt from tests/golden.c, by each compiler that is there, without and with optimisation.
# After a change that is meant to change results: test_golden.sh BUILD_FOLDER write
# usage: CC=compiler test_golden.sh BUILD_FOLDER [quick|rest], from the top of the project
# With "quick", by one compiler without optimisation; with "rest", all but that.
cc=${CC:-cc} build=$1/golden
[ "$2" = quick ] && build=$1/golden_quick
. tests/check.sh

golden() { # golden COMPILER... : what tests/golden.c prints in both precisions
    for precision in "" -DVM_USE_FLOAT; do
        "$@" -std=c99 -ffp-contract=off $precision tests/golden.c -o "$build/golden" -lm && "$build/golden" || return 1
    done
}
same() { golden "$@" >"$build/lines" && diff tests/data/golden.txt "$build/lines"; }

check "every public function is called" sh tests/fuzz/called.sh tests/golden.c tests/golden/*.h
check "no call draws two arguments" awk -v draws='uniform|vector|some_[a-z]+' -f tests/golden/two_draws.awk tests/golden.c \
    tests/golden/*.h
[ "$2" = write ] && golden $cc >tests/data/golden.txt
[ "$2" = rest ] || check "the same bits: $cc -O0" same $cc -O0
[ "$2" = quick ] && { check_finish golden; exit; }
for level in -O0 -O2; do
    [ $level = -O0 ] || check "the same bits: $cc $level" same $cc $level
    command -v clang >/dev/null && check "the same bits: clang $level" same clang $level
done
echo 'int main(void) { return 0; }' >"$build/empty.c"
if gcc -m32 "$build/empty.c" -o "$build/empty" 2>"$build/log" && "$build/empty" 2>>"$build/log"; then
    check "the same bits: i386" same gcc -m32 -msse2 -mfpmath=sse -Os
fi
check_finish golden
