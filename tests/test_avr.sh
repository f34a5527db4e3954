#!/bin/sh
# Tables in the flash of an ATmega328P, which has 2 KB of RAM: tests/cross/tables.c prints the bits that a PC prints, under
# simavr. usage: CC=compiler test_avr.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/avr
. tests/check.sh
avr="avr-gcc -mmcu=atmega328p -DF_CPU=16000000UL -Os -Wall -Wextra -Werror"

sh tests/install.sh -w "for the tables in the flash of an AVR" "command -v avr-gcc && command -v simavr" gcc-avr avr-libc simavr || {
    echo "avr: 0 passed, 0 failed, 15 skipped"
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

for tables in ATEB RK45 RK87; do
    expected=$build/$tables.expected
    check "$tables: for this machine" $cc -std=c99 -ffp-contract=off -D$tables tests/cross/tables.c -o "$build/$tables" -lm
    "$build/$tables" >"$expected"
    check "$tables: in flash unless told otherwise" builds "$build/$tables.flash" -std=c99 -D$tables
    check "$tables: in flash unless told otherwise, bits" same_bits "$build/$tables.flash" "$expected"
    check "$tables: __flash" builds "$build/$tables.named" -std=gnu99 -D$tables \
        "-DVM_TABLE=static const __flash" "-DVM_READ(x)=(x)"
    check "$tables: __flash, bits" same_bits "$build/$tables.named" "$expected"
done
check_finish avr
