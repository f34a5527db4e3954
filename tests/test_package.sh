#!/bin/sh
# What users get who do not copy four headers: the installed files are found by pkg-config and by CMake; the project is a
# part of other CMake and Meson projects; the one-file header does what the four do; the packages for Arduino and of a
# release hold what they should. usage: CC=compiler test_package.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$PWD/$1/package
arduino=/usr/share/arduino/hardware/arduino/avr
. tests/check.sh
skipped=0
wanted_for="to try the packages"
sh tests/install.sh -w "$wanted_for" "command -v cmake && command -v pkg-config" cmake pkg-config
sh tests/install.sh -w "$wanted_for" "command -v meson && command -v ninja" meson ninja-build
sh tests/install.sh -w "$wanted_for" "command -v avr-g++ && test -e $arduino/cores/arduino/Arduino.h" gcc-avr avr-libc arduino-core-avr
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
    mkdir "$build/newer" && sed 's/varmass 0.2/varmass 99.0/' examples/package/consumer/CMakeLists.txt >"$build/newer/CMakeLists.txt" &&
        cp examples/package/consumer/main.c "$build/newer" || return 0
    cmake -S "$build/newer" -B "$build/newer/build" -DCMAKE_PREFIX_PATH="$build/installed" -DCMAKE_C_COMPILER="$cc"
}
# CMake: the project as a folder of another one, fetched from a clone, and installed without make
within_cmake() { # within_cmake FOLDER LINES-THAT-MAKE-THE-TARGET
    mkdir "$1" && { printf 'cmake_minimum_required(VERSION 3.14)\nproject(consumer C)\n%s\n' "$2"
        echo "add_executable(consumer $PWD/examples/package/consumer/main.c)"
        echo 'target_link_libraries(consumer PRIVATE varmass::varmass)'; } >"$1/CMakeLists.txt" &&
        cmake -S "$1" -B "$1/build" -DCMAKE_C_COMPILER="$cc" && cmake --build "$1/build" && says "$1/build/consumer"
}
by_subdirectory() { within_cmake "$build/subdirectory" "add_subdirectory($PWD varmass)"; }
by_fetching() {
    within_cmake "$build/fetched" "include(FetchContent)
FetchContent_Declare(varmass URL $PWD/build/packages/varmass-$version.tar.xz)
FetchContent_MakeAvailable(varmass)"
}
cmake_installs() { # the same files as make install, with the same content
    cmake -S . -B "$build/top" -DCMAKE_INSTALL_PREFIX="$build/installed_by_cmake" && cmake --install "$build/top" &&
        make -s install PREFIX="$build/installed" && sed -i "s|_by_cmake||" "$build/installed_by_cmake/share/pkgconfig/varmass.pc" &&
        diff -r "$build/installed" "$build/installed_by_cmake"
}
# Meson: the project as a subproject, and installed
with_meson() {
    mkdir -p "$build/meson/subprojects/varmass" && cp ./*.h meson.build "$build/meson/subprojects/varmass" &&
        cp examples/package/consumer/main.c "$build/meson" && cat >"$build/meson/meson.build" <<'END' &&
project('consumer', 'c', default_options: ['c_std=c99'])
executable('consumer', 'main.c', dependencies: dependency('varmass', version: '>=0.2', fallback: ['varmass', 'varmass']))
END
        CC="$cc" meson setup "$build/meson/build" "$build/meson" && ninja -C "$build/meson/build" && says "$build/meson/build/consumer"
}
meson_installs() {
    CC="$cc" meson setup "$build/meson_top" . --prefix="$build/installed_by_meson" && meson install -C "$build/meson_top" &&
        PKG_CONFIG_PATH=$build/installed_by_meson/share/pkgconfig with_pkg_config
}
# The release: the checksum is right, the headers and one part of what was unpacked do what they do here
release_is_whole() {
    (cd build/packages && sha256sum -c "varmass-$version.tar.xz.sha256" && tar -xJf "varmass-$version.tar.xz" -C "$build") &&
        for header in varmass ateb jacobi integrators; do cmp $header.h "$build/varmass-$version/$header.h" || return 1; done &&
        $cc -std=c99 -I"$build/varmass-$version" examples/package/consumer/main.c -o "$build/by_release" -lm &&
        says "$build/by_release" && $cc -std=c99 -Wall -Wextra -Werror -x c -c "$build/varmass-$version/parts/mechanics_jumps.h" \
        -o "$build/part.o"
}
# Arduino: the sketches, with Debian's core, for the ATmega328P of an Uno, whose boot loader leaves 32256 bytes
board="-mmcu=atmega328p -DF_CPU=16000000L -DARDUINO=10807 -DDECIMAL_DIG=__DECIMAL_DIG__ -Os -ffunction-sections -fdata-sections
    -I$arduino/cores/arduino -I$arduino/variants/standard"
arduino_core() {
    mkdir "$build/core" && for file in "$arduino"/cores/arduino/*.c; do
        avr-gcc $board -w -std=gnu11 -c "$file" -o "$build/core/${file##*/}.o" || return 1
    done && for file in "$arduino"/cores/arduino/*.cpp; do
        avr-g++ $board -w -std=gnu++11 -fno-exceptions -fno-threadsafe-statics -c "$file" -o "$build/core/${file##*/}.o" || return 1
    done
}
sketch_for_uno() {
    library=build/packages/varmass
    echo '#include <Arduino.h>' | cat - "$library/examples/$1/$1.ino" >"$build/$1.cpp" &&
        avr-g++ $board -Wall -Wextra -Werror -std=gnu++11 -fno-exceptions -fno-threadsafe-statics -I"$library/src" \
            -I"$library/examples/$1" -c "$build/$1.cpp" -o "$build/$1.o" &&
        avr-gcc -mmcu=atmega328p -Os -Wl,--gc-sections "$build/$1.o" "$build"/core/*.o -o "$build/$1.elf" -lm &&
        [ "$(avr-size "$build/$1.elf" | awk 'NR == 2 {print $1 + $2}')" -le 32256 ]
}
# A Cortex-M0+: Debian has no core for it, so that a stand-in declares what the sketches call, and nothing is linked
sketch_for_m0() {
    arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb -Os -Wall -Wextra -Werror -std=gnu++11 -I"$build/stand_in" \
        -Ibuild/packages/varmass/src -I"build/packages/varmass/examples/$1" -c "$build/$1.cpp" -o "$build/$1.m0.o"
}
stand_in() {
    mkdir "$build/stand_in" && cat >"$build/stand_in/Arduino.h" <<'END'
#include <stddef.h>
struct serial {
    void begin(long);
    void print(const char *);
    void print(char);
    void print(double, int = 2);
    void println(const char *);
    void println(double, int = 2);
};
extern serial Serial;
unsigned long millis();
void delay(unsigned long);
END
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
version=$(awk '/define VARMASS_VERSION/ {gsub("\"", "", $3); print $3}' jacobi.h)
check "Meson has the version of the headers" grep -q "version: '$version'" meson.build
check "make packages" make -s packages
if command -v xz >/dev/null; then check "the release is whole" release_is_whole; else skipped=$((skipped + 1)); fi
if command -v cmake >/dev/null; then
    check "CMake: a folder of another project" by_subdirectory
    check "CMake: a release that is fetched" by_fetching
    check "CMake installs what make does" cmake_installs
else
    skipped=$((skipped + 3))
fi
if command -v meson >/dev/null && command -v ninja >/dev/null && command -v pkg-config >/dev/null; then
    check "Meson: a subproject" with_meson
    check "Meson installs" meson_installs
else
    skipped=$((skipped + 2))
fi
if command -v avr-g++ >/dev/null && [ -e "$arduino/cores/arduino/Arduino.h" ]; then
    check "Arduino: Debian's core" arduino_core
    check "Arduino: the sketch split fits an Uno" sketch_for_uno split
    check "Arduino: the sketch leak fits an Uno" sketch_for_uno leak
    if command -v arm-none-eabi-g++ >/dev/null; then
        stand_in
        check "Arduino: split compiles for a Cortex-M0+" sketch_for_m0 split
        check "Arduino: leak compiles for a Cortex-M0+" sketch_for_m0 leak
    else
        skipped=$((skipped + 2))
    fi
else
    skipped=$((skipped + 5))
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
