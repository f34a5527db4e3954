#!/bin/sh
# The fuzz targets without a fuzzer: every public function is called by one, the stored inputs that once went wrong and
# some pseudo-random ones violate no property, in double and float.
# usage: CC=compiler test_fuzz.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/fuzz_replay
. tests/check.sh

replay() { "$1" -n 4000 tests/fuzz/corpus/*.hex; }

check "every public function is called" sh tests/fuzz/called.sh tests/fuzz/*.c tests/fuzz/*.h
check "no call draws two arguments" awk -v draws='draw_[a-z0-9]+|MOSTLY|special' -f tests/golden/two_draws.awk tests/fuzz/*.[ch]
check "every deliberate error still changes a header" sh tests/fuzz/planted.sh "$build" 0
for precision in double float; do
    flags=
    [ $precision = float ] && flags=-DVM_USE_FLOAT
    check "compiles in $precision" $cc -std=c99 -O1 $flags tests/fuzz/replay.c -o "$build/replay" -lm
    check "no property violated in $precision" replay "$build/replay"
done
check_finish fuzz
