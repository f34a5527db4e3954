#!/bin/sh
# The same bits everywhere: build and run tests/golden.c on every target that can be had, and compare what it prints with
# the first. usage: cross.sh BUILD_FOLDER [REPORT], from the top of the project
build=$1/cross report=${2:-/dev/null}
passed=0 failed=0 skipped=0
rm -rf "$build" && mkdir -p "$build" || exit 1
c99="-std=c99 -ffp-contract=off"
cortex="-nostartfiles -T tests/cross/cortex_m.ld -ffunction-sections -Wl,--gc-sections -DGOLDEN_PUTS=golden_line tests/cross/cortex_m.c"
large="-Wl,--defsym=FLASH_SIZE=0x400000,--defsym=RAM_SIZE=0x400000"
small="-Wl,--defsym=FLASH_SIZE=0x40000,--defsym=RAM_SIZE=0x4000"
riscv="-mcmodel=medany -nostartfiles -T tests/cross/riscv.ld -Wl,--no-warn-rwx-segments -DGOLDEN_PUTS=golden_line tests/cross/riscv.c"
semihosting="-nographic -monitor none -serial none -semihosting-config enable=on,target=native"

# target NAME PACKAGES PRECISIONS COMPILE RUN: COMPILE makes $out of golden.c, with $flags; RUN prints its lines
target() {
    name=$1 packages=$2 precisions=$3 compile=$4 run=$5
    for precision in $precisions; do
        out=$build/golden flags=
        [ $precision = float ] && flags=-DVM_USE_FLOAT
        rm -f "$out"
        command -v "${compile%% *}" >/dev/null && command -v "${run%% *}" >/dev/null || sh tests/install.sh \
            "command -v ${compile%% *} && command -v ${run%% *}" $packages >/dev/null 2>&1
        if ! eval "$compile" >"$build/log" 2>&1; then
            skipped=$((skipped + 1))
            echo "skipped: $name, $precision: $(grep -m 1 -i error "$build/log" || tail -n 1 "$build/log")"
            continue
        fi
        eval "timeout 300 $run" 2>&1 </dev/null | tr -d '\r' | sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' | grep '^golden' >"$build/lines"
        [ -f "$build/$precision" ] || cp "$build/lines" "$build/$precision"
        if [ -s "$build/lines" ] && cmp -s "$build/lines" "$build/$precision"; then
            passed=$((passed + 1))
            echo "the same: $name, $precision"
        else
            failed=$((failed + 1))
            echo "FAILED: $name, $precision: $(diff "$build/lines" "$build/$precision" | awk '/^</ {printf "%s ", $4}')"
        fi
    done
}

both="double float"
host() { target "$1" "$2" "$both" "$3 tests/golden.c \$flags -o \$out -lm" "\$out"; }
arm() { # arm NAME FLAGS MEMORIES BOARD
    target "$1" "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm" "$both" \
        "arm-none-eabi-gcc $2 $c99 -Os $3 $cortex tests/golden.c \$flags -o \$out -lm" "qemu-system-arm -M $4 $semihosting -kernel \$out"
}
risc() { # risc NAME FLAGS QEMU
    target "$1" "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc" "$both" \
        "riscv64-unknown-elf-gcc $2 $c99 -Os --specs=picolibc.specs $riscv tests/golden.c \$flags -o \$out -lm" \
        "$3 -M virt -bios none $semihosting -kernel \$out"
}
user() { # user NAME PACKAGES COMPILER FLAGS QEMU
    target "$1" "$2 qemu-user" "$both" "$3 -static $c99 $4 tests/golden.c \$flags -o \$out -lm" "$5 \$out"
}
{
    for level in -O0 -O1 -O2 -O3 -Os; do
        host "x86-64 gcc $level" gcc "gcc $c99 $level"
        host "x86-64 clang $level" clang "clang $c99 $level"
    done
    host "x86-64 gcc -O3 -march=native" gcc "gcc $c99 -O3 -march=native"
    host "x86-64 g++ -std=c++11" g++ "g++ -x c++ -std=c++11 -ffp-contract=off -O2"
    target "x86-64 tcc" tcc double "tcc tests/golden.c \$flags -o \$out -lm" "\$out" # float: 0.9.27 passes structs of three floats wrongly
    host "x86-64 musl" musl-tools "musl-gcc -static $c99 -O2"
    host "i386 SSE2" gcc-12-multilib "gcc -m32 -msse2 -mfpmath=sse $c99 -O2"
    arm "Cortex-M0, larger memory" "-mcpu=cortex-m0 -mthumb" "$large" mps2-an385
    # 256 KB of flash hold one section at a time, as those of AVR; 16 KB of memory the scenes in float
    sections=$(awk '$2 == "float" {print $3}' tests/data/golden.txt | tr '\n' ' ')
    target "Cortex-M0, newlib" "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm" float \
        "arm-none-eabi-gcc --version && for i in $sections; do arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb $c99 -Os $small $cortex -DGOLDEN_SECTION=\$i tests/golden.c \
        \$flags -o \$out\$i -lm || break; done" \
        "sh -c 'for i in $sections; do qemu-system-arm -M microbit $semihosting -kernel \$0\$i; done' \$out"
    arm "Cortex-M3, newlib" "-mcpu=cortex-m3 -mthumb" "$large" mps2-an385
    arm "Cortex-M4F, newlib" "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16" "$large" mps2-an386
    arm "Cortex-M7, newlib" "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16" "$large" mps2-an500
    sh tests/install.sh "test -d /usr/lib/picolibc/arm-none-eabi" picolibc-arm-none-eabi >/dev/null 2>&1
    arm "Cortex-M4F, picolibc" "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 --specs=picolibc.specs" "$large" mps2-an386
    risc "RISC-V 32 imac" "-march=rv32imac -mabi=ilp32" qemu-system-riscv32
    risc "RISC-V 32 imafdc" "-march=rv32imafdc -mabi=ilp32d" qemu-system-riscv32
    risc "RISC-V 64 imafdc" "-march=rv64imafdc -mabi=lp64d" qemu-system-riscv64
    user "s390x, big-endian" "gcc-s390x-linux-gnu libc6-dev-s390x-cross" s390x-linux-gnu-gcc "-fexcess-precision=fast -O2" qemu-s390x
    user "MIPS 32, big-endian" "gcc-mips-linux-gnu libc6-dev-mips-cross" mips-linux-gnu-gcc -O2 qemu-mips
    user "AArch64" "gcc-aarch64-linux-gnu libc6-dev-arm64-cross" aarch64-linux-gnu-gcc -O2 qemu-aarch64
    avr="avr-gcc -mmcu=atmega1284p -DF_CPU=16000000UL -std=c99 -Os"
    target "AVR" "gcc-avr avr-libc simavr" float "avr-gcc --version && for i in $sections; do $avr -ffunction-sections -Dmain=golden_main \
        -DGOLDEN_PUTS=golden_line -DGOLDEN_SECTION=\$i -DVM_USE_FLOAT -c tests/golden.c -o \$out.o && \
        $avr -Wl,--gc-sections tests/cross/avr.c \$out.o -o \$out\$i -lm || break; done" \
        "sh -c 'for i in $sections; do simavr -m atmega1284p -f 16000000 \$0\$i; done' \$out"
    target "WebAssembly" "clang lld wasi-libc libclang-rt-14-dev-wasm32 nodejs" "$both" \
        "clang --target=wasm32-wasi --sysroot=/usr $c99 -O2 tests/golden.c \$flags -o \$out -lm" "node --no-warnings tests/cross/wasm.mjs \$out"
    if command -v wine64 >/dev/null; then
        target "Windows, mingw" "gcc-mingw-w64-x86-64-win32" "$both" \
            "x86_64-w64-mingw32-gcc $c99 -O2 tests/golden.c \$flags -o \$out.exe -lm" "wine64 \$out.exe"
    else
        echo "skipped: Windows, mingw: no wine64"
        skipped=$((skipped + 1))
    fi
    echo "cross: $passed passed, $failed failed, $skipped skipped"
} | tee "$build/report"
{
    printf '# The same bits everywhere\n\nWritten by `make test-cross`: tests/golden.c on each target; the numbers are those of the first.\n\n```\n'
    cat "$build/double" "$build/float" "$build/report"
    printf '```\n'
} >"$report"
tail -n 1 "$build/report" | grep -q ' 0 failed,'
