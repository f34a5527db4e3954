#!/bin/sh
# The same bits everywhere: build and run tests/golden.c on every target that can be had, and compare what it prints with
# the first; then the tests on those that have a console. Each TEST is tests/test_TEST.c; without any, only bits are compared.
# A test that passed on a target is kept in BUILD_FOLDER/cross_tests (tests/kept.sh), and is not run again there.
# usage: cross.sh BUILD_FOLDER REPORT [TEST...], from the top of the project
build=$1/cross kept=$1/cross_tests report=$2
shift 2
. tests/kept.sh
every=$*
# those that an emulator of a processor without double takes in double
few=$(for test in $every; do case $test in rk4 | pairs | adaptive | dense | events | bodies | constant_mass | dissertation | \
    drum | drum_shaft | lambert | lagrange_jump | pendulum | forces | scenes | scene_bodies | scene_events | scene_runs) echo $test ;;
    esac; done)
# seconds after which a program counts as failed. The slowest test takes a few minutes on an emulated processor, and
# several times as long where other work shares the machine.
limit=3600
passed=0 failed=0 skipped=0
rm -rf "$build" && mkdir -p "$build/declared" || exit 1
declare_headers "$build/declared"
c99="-std=c99 -ffp-contract=off"
cortex="-nostartfiles -T tests/cross/cortex_m.ld -ffunction-sections -Wl,--gc-sections \$boot"
large="-Wl,--defsym=FLASH_SIZE=0x400000,--defsym=RAM_SIZE=0x400000"
small="-Wl,--defsym=FLASH_SIZE=0x40000,--defsym=RAM_SIZE=0x4000"
riscv="-mcmodel=medany -nostartfiles -T tests/cross/riscv.ld -Wl,--no-warn-rwx-segments \$boot"
line=-DGOLDEN_PUTS=golden_line # the golden program's way without stdio
semihosting="-nographic -monitor none -serial none -semihosting-config enable=on,target=native"

all_but() { # all_but SECTION...: the other sections
    for section in $sections; do
        case " $* " in *" $section "*) ;; *) printf '%s ' "$section" ;; esac
    done
}
held= # the sections that a target with little memory can hold; empty: all
# target NAME PACKAGES PRECISIONS COMPILE RUN: COMPILE makes $out of $source, with $flags; RUN prints its lines
target() {
    name=$1 packages=$2 precisions=$3 compile=$4 run=$5
    for precision in $precisions; do
        out=$build/golden source=tests/golden.c flags=
        [ $precision = float ] && flags=-DVM_USE_FLOAT
        rm -f "$out"
        command -v "${compile%% *}" >/dev/null && command -v "${run%% *}" >/dev/null || sh tests/install.sh \
            "command -v ${compile%% *} && command -v ${run%% *}" $packages
        if ! eval "$compile" >"$build/log" 2>&1; then
            skipped=$((skipped + 1))
            echo "skipped: $name, $precision: $(grep -m 1 -i error "$build/log" || tail -n 1 "$build/log")"
            continue
        fi
        eval "timeout $limit $run" 2>&1 </dev/null | tr -d '\r' | sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' | grep '^golden' >"$build/lines"
        [ -f "$build/$precision" ] || cp "$build/lines" "$build/$precision"
        awk -v held=" $held " 'held == "  " || index(held, " " $3 " ")' "$build/$precision" >"$build/expected"
        if [ -s "$build/lines" ] && cmp -s "$build/lines" "$build/expected"; then
            passed=$((passed + 1))
            echo "the same: $name, $precision"
        else
            failed=$((failed + 1))
            echo "FAILED: $name, $precision: $(diff "$build/lines" "$build/expected" | awk '/^</ {printf "%s ", $4}')"
        fi
    done
}

# -DSAMPLE for emulated processors: tests with very many cases try one case in 19 (tests/check.h)
sample=
# tests NAME PRECISION COMPILE RUN TEST...: the same of the tests, the number of checks that passed in all. As in make test the
# headers are compiled once, and the tests are linked with this object.
tests() {
    name=$1 precision=$2 compile=$3 run=$4 checks=0 bad= flags=
    shift 4
    [ $precision = float ] && flags=-DVM_USE_FLOAT
    rm -f "$build/headers.$precision"*
    (boot= out=$build/headers.$precision source="-DVM_API= -x c -c varmass.h" && eval "$compile") >"$build/headers.log.$precision" 2>&1
    headers=$(echo "$build/headers.$precision"*)
    out=$build/test.$precision
    for test in "$@"; do
        if is_kept "$name.$precision" "$test"; then
            checks=$((checks + $(kept_word "$name.$precision" "$test")))
            continue
        fi
        source="-w $sample -include tests/linked.h $(declared "$build/declared" "$test") tests/test_$test.c $headers"
        if ! eval "$compile" >"$out.log" 2>&1; then
            bad="$bad; $test does not compile: $(grep -m 1 -i -E 'error|overflowed' "$out.log")"
            continue
        fi
        eval "timeout $limit $run" 2>&1 </dev/null | tr -d '\r' >"$out.log"
        last=$(grep -E ': [0-9]+ passed, 0 failed, [0-9]+ skipped$' "$out.log" | tail -n 1)
        if [ -n "$last" ]; then
            now=$(echo "$last" | sed 's/.*: \([0-9]*\) passed.*/\1/')
            checks=$((checks + now))
            keep "$name.$precision" "$test" "$now"
        else
            bad="$bad; $test: $(grep -m 1 FAILED "$out.log" || tail -n 1 "$out.log")"
        fi
    done
    if [ -z "$bad" ]; then echo "tests pass: $name, $precision: $# programs, $checks checks"
    else echo "tests FAILED: $name, $precision$bad"; fi
}
# tested NAME COMPILE RUN "TESTS OF DOUBLE" "TESTS OF FLOAT": both at once; those of a target that is not there are skipped
tested() {
    [ -n "$every" ] || return 0
    out=$build/empty source=$build/empty.c flags=
    echo 'int main(void) { return 0; }' >"$source"
    if ! eval "$2" >"$build/log" 2>&1; then
        skipped=$((skipped + 1))
        echo "skipped: tests on $1: $(tail -n 1 "$build/log")"
        return
    fi
    tests "$1" double "$2" "$3" $4 >"$build/tests.double" &
    tests "$1" float "$2" "$3" $5 >"$build/tests.float"
    wait
    for precision in $both; do
        cat "$build/tests.$precision"
        if grep -q '^tests pass' "$build/tests.$precision"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    done
}

both="double float"
host() { # host NAME PACKAGES COMPILER [TESTS]
    target "$1" "$2" "$both" "$3 \$flags \$source -o \$out -lm" "\$out"
    [ -z "$4" ] || tested "$1" "$3 \$flags \$source -o \$out -lm" "\$out" "$4" "$4"
}
arm() { # arm NAME FLAGS MEMORIES BOARD
    boot=tests/cross/cortex_m.c
    target "$1" "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm" "$both" \
        "arm-none-eabi-gcc $2 $c99 -Os $line $3 $cortex \$flags \$source -o \$out -lm" \
        "qemu-system-arm -M $4 $semihosting -kernel \$out"
}
difference() { # difference NAME FLAGS BOARD
    boot=tests/cross/cortex_m.c
    eval "arm-none-eabi-gcc $2 $c99 -Os $cortex tests/cross/subtraction.c -o $build/subtraction" 2>"$build/log" || return
    echo "1 - 3deee0f145d53f12 on $1: $(timeout 60 qemu-system-arm -M $3 $semihosting -kernel "$build/subtraction" 2>&1 </dev/null |
        tr -d '\r')"
}
# For Cortex-M3 and Cortex-M4 gcc's library (libgcc) rounds some sums in double wrongly (bench/cross.md). Its routines for
# Cortex-M0 round correctly, and run on these processors too: they are linked in place of the library's own.
arm_sums() { # arm_sums NAME FLAGS MEMORIES BOARD
    rm -f "$build/adddf3.o" "$build/subdf3.o"
    sh tests/install.sh "command -v arm-none-eabi-gcc && command -v qemu-system-arm" gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm
    command -v arm-none-eabi-gcc >/dev/null &&
        (cd "$build" && arm-none-eabi-ar x "$(arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -print-libgcc-file-name)" adddf3.o subdf3.o)
    sums="$build/adddf3.o $build/subdf3.o -Wl,--allow-multiple-definition,--no-warn-mismatch"
    difference "$1, its own sums" "$2 $3" "$4"
    difference "$1, sums for Cortex-M0" "$2 $3 $sums" "$4"
    arm "$1, sums for Cortex-M0" "$2" "$3 $sums" "$4"
}
arm_tests() { # arm_tests NAME FLAGS BOARD "TESTS OF DOUBLE": newlib's console by semihosting
    boot=tests/cross/cortex_m.c
    tested "$1" "arm-none-eabi-gcc $2 $c99 -O1 -DNEWLIB_CONSOLE --specs=rdimon.specs $large $cortex \$flags \$source -o \$out -lm" \
        "qemu-system-arm -M $3 $semihosting -kernel \$out" "$4" "$every"
}
risc() { # risc NAME FLAGS QEMU "TESTS OF DOUBLE"
    boot=tests/cross/riscv.c
    board="riscv64-unknown-elf-gcc $2 $c99 --specs=picolibc.specs $riscv \$flags \$source -o \$out -lm"
    emulator="$3 -M virt -bios none $semihosting -kernel \$out"
    target "$1" "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc" "$both" "$board -Os $line" "$emulator"
    tested "$1" "$board -O1 --oslib=semihost" "$emulator" "$4" "$every"
}
user() { # user NAME PACKAGES COMPILER FLAGS QEMU
    board="$3 -static $c99 $4 \$flags \$source -o \$out -lm"
    target "$1" "$2 qemu-user" "$both" "$board" "$5 \$out"
    tested "$1" "$board" "$5 \$out" "$every" "$every"
}
{
    for level in -O0 -O1 -O2 -O3 -Os; do
        host "x86-64 gcc $level" gcc "gcc $c99 $level"
        host "x86-64 clang $level" clang "clang $c99 $level"
    done
    # gcc 12's vectoriser contracts a b - c, a b + c side by side to one instruction, whatever -ffp-contract says
    host "x86-64 gcc -O3 -march=native -fno-tree-vectorize" gcc "gcc $c99 -O3 -march=native -fno-tree-vectorize"
    host "x86-64 clang -O3 -march=native" clang "clang $c99 -O3 -march=native"
    host "x86-64 g++ -std=c++11" g++ "g++ -x c++ -std=c++11 -ffp-contract=off -O2"
    # tcc 0.9.27 passes structs of three floats wrongly
    target "x86-64 tcc" tcc double "tcc \$flags \$source -o \$out -lm" "\$out"
    host "x86-64 musl" musl-tools "musl-gcc -static $c99 -O2" "$every"
    sh tests/install.sh "test -d /usr/lib/gcc/x86_64-linux-gnu/12/32" gcc-12-multilib
    host "i386 SSE2" gcc-12-multilib "gcc -m32 -msse2 -mfpmath=sse $c99 -O2" "$every"
    arm "Cortex-M0, larger memory" "-mcpu=cortex-m0 -mthumb" "$large" mps2-an385
    # 256 KB of flash hold one section at a time, as those of AVR; 16 KB of memory the scenes in float, but not three sections,
    # which need 24 KB
    sections=$(awk '$2 == "float" {print $3}' tests/data/golden.txt | tr '\n' ' ')
    left_out="duffing routes van_der_pol"
    held=$(all_but $left_out)
    target "Cortex-M0, newlib, all but $left_out" "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm" float \
        "arm-none-eabi-gcc --version && for i in $held; do arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb $c99 -Os $line $small $cortex \
        -DGOLDEN_SECTION=\$i \$flags \$source -o \$out\$i -lm || break; done" \
        "sh -c 'for i in $held; do qemu-system-arm -M microbit $semihosting -kernel \$0\$i; done' \$out"
    held=
    arm_sums "Cortex-M3, newlib" "-mcpu=cortex-m3 -mthumb" "$large" mps2-an385
    arm_sums "Cortex-M4F, newlib" "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16" "$large" mps2-an386
    arm "Cortex-M7, newlib" "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16" "$large" mps2-an500
    sh tests/install.sh "test -d /usr/lib/picolibc/arm-none-eabi" picolibc-arm-none-eabi
    arm_sums "Cortex-M4F, picolibc" "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 --specs=picolibc.specs" "$large" mps2-an386
    sample=-DSAMPLE
    arm_tests "Cortex-M0 code on an M3" "-mcpu=cortex-m0 -mthumb" mps2-an385 "$few" # the M0's board has too little memory
    arm_tests "Cortex-M3" "-mcpu=cortex-m3 -mthumb" mps2-an385 "$few"
    arm_tests "Cortex-M4F" "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16" mps2-an386 "$few"
    arm_tests "Cortex-M7" "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16" mps2-an500 "$every"
    risc "RISC-V 32 imac" "-march=rv32imac -mabi=ilp32" qemu-system-riscv32 "$few"
    risc "RISC-V 32 imafdc" "-march=rv32imafdc -mabi=ilp32d" qemu-system-riscv32 "$every"
    risc "RISC-V 64 imafdc" "-march=rv64imafdc -mabi=lp64d" qemu-system-riscv64 "$every"
    user "s390x, big-endian" "gcc-s390x-linux-gnu libc6-dev-s390x-cross" s390x-linux-gnu-gcc "-fexcess-precision=fast -O2" qemu-s390x
    user "MIPS 32, big-endian" "gcc-mips-linux-gnu libc6-dev-mips-cross" mips-linux-gnu-gcc -O2 qemu-mips
    user "AArch64" "gcc-aarch64-linux-gnu libc6-dev-arm64-cross" aarch64-linux-gnu-gcc -O2 qemu-aarch64
    sample=
    sh tests/install.sh "command -v simavr" gcc-avr avr-libc simavr
    avr="avr-gcc -mmcu=atmega1284p -DF_CPU=16000000UL -std=c99 -Os"
    left_out="duffing routes scenes_in_space slow van_der_pol" # more than 128 KB of flash each
    held=$(all_but $left_out)
    target "AVR, all but $left_out" "gcc-avr avr-libc simavr" float "avr-gcc --version && for i in $held; do $avr -ffunction-sections -Dmain=golden_main \
        $line -DGOLDEN_SECTION=\$i -DVM_USE_FLOAT -c \$source -o \$out.o && \
        $avr -Wl,--gc-sections tests/cross/avr.c \$out.o -o \$out\$i -lm || break; done" \
        "sh -c 'for i in $held; do simavr -m atmega1284p -f 16000000 \$0\$i; done' \$out"
    held=
    sh tests/install.sh "test -d /usr/lib/wasm32-wasi" clang lld wasi-libc libclang-rt-14-dev-wasm32 nodejs
    # 64 KB of stack, which are usual there, are too few: vm_odd_plan_init needs 34 KB, the program of the sums 31 KB
    wasm="clang --target=wasm32-wasi --sysroot=/usr -Wl,-z,stack-size=1048576 $c99 -O2 \$flags \$source -o \$out -lm"
    target "WebAssembly" "clang lld wasi-libc libclang-rt-14-dev-wasm32 nodejs" "$both" "$wasm" "node --no-warnings tests/cross/wasm.mjs \$out"
    tested "WebAssembly" "$wasm" "node --no-warnings tests/cross/wasm.mjs \$out" "$every" "$every"
    PATH=$PATH:/usr/lib/wine # where Debian keeps wine64
    windows="x86_64-w64-mingw32-gcc $c99 -O2 \$flags \$source -o \$out.exe -lm"
    wine="env WINEDEBUG=-all WINEPREFIX=$PWD/$build/wine wine64 \$out.exe"
    sh tests/install.sh "command -v x86_64-w64-mingw32-gcc && command -v wine64" gcc-mingw-w64-x86-64-win32 wine64
    target "Windows, mingw" "gcc-mingw-w64-x86-64-win32 wine64" "$both" "command -v wine64 && $windows" "$wine"
    tested "Windows, mingw" "command -v wine64 && $windows" "$wine" "$every" "$every"
    rm -rf "$build/wine" # 700 MB
    echo "cross: $passed passed, $failed failed, $skipped skipped"
} | tee "$build/report"
{
    cat bench/cross.md
    echo
    echo '```'
    cat "$build/double" "$build/float" "$build/report"
    [ -n "$every" ] || echo "tests: left out in this run"
    printf '```\n'
} >"$report"
tail -n 1 "$build/report" | grep -q ' 0 failed,'
