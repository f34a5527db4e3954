#!/bin/sh
# A run saved on one machine and resumed on another one, with the same bits: it goes from x86-64 to a Cortex-M4F to a
# s390x, whose bytes lie in the other order, and back. Machines that are not there are left out.
# usage: test_resumed.sh BUILD_FOLDER, from the top of the project
build=$1/resumed
mkdir -p "$build" && rm -f "$build"/* || exit 1
passed=0 failed=0 skipped=0
c99="-std=c99 -ffp-contract=off"
cortex="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -DNEWLIB_CONSOLE --specs=rdimon.specs -nostartfiles \
    -T tests/cross/cortex_m.ld -ffunction-sections -Wl,--gc-sections tests/cross/cortex_m.c \
    -Wl,--defsym=FLASH_SIZE=0x400000,--defsym=RAM_SIZE=0x400000"
qemu="qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none -semihosting-config enable=on,target=native -kernel"

# leg NAME COMPILE RUN: the run goes on in this machine, from the bytes that the last one has left
leg() {
    name=$1 compile=$2 run=$3 from=
    if ! command -v "${compile%% *}" >/dev/null || ! command -v "${run%% *}" >/dev/null; then
        skipped=$((skipped + 1))
        echo "skipped: $name, $precision: no ${compile%% *} or ${run%% *}"
        return
    fi
    [ -s "$build/bytes" ] && from="-DRESUMED=\"$PWD/$build/bytes\""
    $compile $c99 $flags ${from:+"$from"} tests/cross/resumed.c -o "$build/program" -lm || exit 1
    timeout 60 $run "$build/program" </dev/null | tr -d '\r' >"$build/lines"
    sed -n 's/^saved //p' "$build/lines" >"$build/bytes"
    grep '^end' "$build/lines" >"$build/end"
    [ -f "$build/wanted" ] || cp "$build/end" "$build/wanted"
    if [ -s "$build/end" ] && cmp -s "$build/end" "$build/wanted"; then passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $name, $precision: $(cat "$build/end") instead of $(cat "$build/wanted")"
    fi
}
for precision in double float; do
    flags=
    [ $precision = float ] && flags=-DVM_USE_FLOAT
    rm -f "$build"/*
    leg "x86-64" "gcc -O2" env
    leg "Cortex-M4F" "arm-none-eabi-gcc -O1 $cortex" "$qemu"
    leg "s390x" "s390x-linux-gnu-gcc -static -O2 -fexcess-precision=fast" qemu-s390x
    leg "x86-64, clang" "clang -O1" env
done
echo "resumed: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
