#!/bin/sh
# What users get who do not copy four headers: the installed files are found by pkg-config and by CMake, and the one-file
# header does what the four do. usage: CC=compiler test_package.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$PWD/$1/package
. tests/check.sh
skipped=0
PKG_CONFIG_PATH=$build/installed/share/pkgconfig
export PKG_CONFIG_PATH

says() { [ "$("$@")" = "$wanted" ]; }
with_pkg_config() {
    $cc -std=c99 $(pkg-config --cflags varmass) examples/package/consumer/main.c -o "$build/by_pkg_config" $(pkg-config --libs varmass) &&
        says "$build/by_pkg_config"
}
with_cmake() {
    cmake -S examples/package/consumer -B "$build/cmake" -DCMAKE_PREFIX_PATH="$build/installed" -DCMAKE_C_COMPILER="$cc" &&
        cmake --build "$build/cmake" && says "$build/cmake/consumer"
}
other_version() { # the project asks for a version that is not there
    mkdir "$build/newer" && sed 's/varmass 0.1/varmass 99.0/' examples/package/consumer/CMakeLists.txt >"$build/newer/CMakeLists.txt" &&
        cp examples/package/consumer/main.c "$build/newer" || return 0
    cmake -S "$build/newer" -B "$build/newer/build" -DCMAKE_PREFIX_PATH="$build/installed" -DCMAKE_C_COMPILER="$cc"
}
# a project with a target named m, which has nothing to do with the C library's; it calls sin, so that libm is needed
with_target_m() { # with_target_m FOLDER LINES-THAT-FIND-AND-LINK
    mkdir "$1" && cat >"$1/CMakeLists.txt" <<END || return 1
cmake_minimum_required(VERSION 3.10)
project(consumer C)
set(CMAKE_C_STANDARD 99)
add_library(m STATIC library.c)
add_executable(consumer main.c)
$2
END
    echo 'int unrelated(void); int unrelated(void) { return 1; }' >"$1/library.c"
    cat >"$1/main.c" <<'END'
#include "varmass.h"
#include <stdio.h>
int main(int count, char **argument) { return (void)argument, printf("%.3f\n", sin(count) + vm_osc_period(1, 1, 3)) < 0; }
END
    cmake -S "$1" -B "$1/build" -DCMAKE_PREFIX_PATH="$build/installed" -DCMAKE_C_COMPILER="$cc" &&
        cmake --build "$1/build" --target consumer && "$1/build/consumer" && [ ! -e "$1/build/libm.a" ]
}
find_package="find_package(varmass REQUIRED)
target_link_libraries(consumer varmass::varmass)"
find_pkg_config="find_package(PkgConfig REQUIRED)
pkg_check_modules(varmass REQUIRED IMPORTED_TARGET varmass)
target_link_libraries(consumer PkgConfig::varmass)"

check "the consumer builds in the source tree" $cc -std=c99 -I. examples/package/consumer/main.c -o "$build/plain" -lm
wanted=$("$build/plain")
check "make install" make -s install PREFIX="$build/installed"
if command -v pkg-config >/dev/null; then check "pkg-config finds it" with_pkg_config; else skipped=$((skipped + 1)); fi
if command -v cmake >/dev/null; then
    check "CMake finds it" with_cmake
    check "CMake refuses another version" fails other_version
    check "CMake: a project with a target named m" with_target_m "$build/with_m" "$find_package"
else
    skipped=$((skipped + 3))
fi
if command -v cmake >/dev/null && command -v pkg-config >/dev/null; then
    check "CMake by pkg-config: a project with a target named m" with_target_m "$build/pkg_with_m" "$find_pkg_config"
else
    skipped=$((skipped + 1))
fi
check "make uninstall" make -s uninstall PREFIX="$build/installed"
check "nothing is left" fails grep -r varmass "$build/installed"

check "make amalgamation" make -s amalgamation
mkdir -p "$build/one" && cp build/amalgamation/varmass.h "$build/one"
check "one file: holds no other" fails grep -n '^#include "' "$build/one/varmass.h"
check "one file: the same answer" $cc -std=c99 -I"$build/one" examples/package/consumer/main.c -o "$build/one/plain" -lm
check "one file: the same numbers" says "$build/one/plain"
for flags in "" -DVM_USE_FLOAT; do
    check "one file: strict warnings $flags" $cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror $flags -x c -c \
        "$build/one/varmass.h" -o "$build/one/varmass.o"
done
mkdir "$build/one/tests" &&
    cp tests/check.h tests/precision.h tests/oscillator_*.h tests/test_constant_mass.c "$build/one/tests"
check "one file: its test builds" $cc -std=c99 -O2 "$build/one/tests/test_constant_mass.c" -o "$build/one/test" -lm
check "one file: its test passes" "$build/one/test"
echo "package: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
