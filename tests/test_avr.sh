#!/bin/sh
# Tables in the flash of an ATmega328P, which has 2 KB of RAM: tests/cross/tables.c prints the bits that a PC prints, under
# simavr. usage: CC=compiler test_avr.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/avr
. tests/check.sh
# Functions share the code that saves registers, and calls are as short as they can be: otherwise the two largest programs,
# the law of order 3 made on board and rk87, are up to 250 bytes too long.
avr="avr-gcc -mmcu=atmega328p -I$build -DF_CPU=16000000UL -Os -mcall-prologues -mrelax -Wall -Wextra -Werror"

sh tests/install.sh -w "for the tables in the flash of an AVR" "command -v avr-gcc && command -v simavr" gcc-avr avr-libc simavr || {
    echo "avr: 0 passed, 0 failed, 26 skipped"
    exit 0
}

builds() { # builds PROGRAM OPTION... : for the ATmega328P, of which no more is in RAM than a few texts
    program=$1
    shift
    $avr -ffp-contract=off "$@" -Wno-unused-function -ffunction-sections -c tests/cross/tables.c -o "$program.o" &&
        $avr -std=c99 -Wl,--gc-sections tests/cross/avr.c "$program.o" -o "$program" -lm &&
        [ "$(avr-size "$program" | awk 'NR == 2 {print $2}')" -lt 100 ]
}
same_bits() { # same_bits PROGRAM EXPECTED
    timeout 60 simavr -m atmega328p -f 16000000 "$1" 2>&1 </dev/null | tr -d '\r' | sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' |
        grep '^tables' >"$1.lines"
    [ "$(wc -l <"$1.lines")" -gt 30 ] && diff "$1.lines" "$2"
}

print_plan() { # the plan of a leaking oscillator, as a constant in flash
    $cc -std=c99 -DVM_USE_FLOAT examples/print_plan.c -o "$build/print_plan" -lm &&
        "$build/print_plan" closed 1.7 10 -0.1 100 0 1 0 0.1 0 5 30 "plan PROGMEM" >"$build/closed_plan.h"
}
check "the plan of an oscillator is printed" print_plan
for tables in ATEB "CLOSED=\"closed_plan.h\"" MADE=3 RK45 RK87; do
    expected=$build/${tables%%=*}.expected
    chapter=${tables%%=*}
    check "$chapter: for this machine" $cc -std=c99 -ffp-contract=off -D"$tables" -I"$build" tests/cross/tables.c -o "$build/$chapter" -lm
    "$build/$chapter" >"$expected"
    check "$chapter: in flash unless told otherwise" builds "$build/$chapter.flash" -std=c99 -D"$tables"
    check "$chapter: in flash unless told otherwise, bits" same_bits "$build/$chapter.flash" "$expected"
    check "$chapter: __flash" builds "$build/$chapter.named" -std=gnu99 -D"$tables" \
        "-DVM_TABLE=static const __flash" "-DVM_READ(x)=(x)"
    check "$chapter: __flash, bits" same_bits "$build/$chapter.named" "$expected"
done
check_finish avr
