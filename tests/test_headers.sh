#!/bin/sh
# What the headers are as files: each compiles alone, both precisions fit into one program, nothing but a few functions
# of the C library is needed, nothing is writable, the examples run, no function's null pointers are forgotten.
# usage: CC=compiler test_headers.sh BUILD_FOLDER [quick|rest], from the top of the project
# With "quick", what takes long is left out: what compiles all functions of a header once more (the objects of make test have
# those of varmass.h, and so of all), and the examples among hostile words. With "rest", only that is done.
cc=${CC:-cc} folder=$1 build=$1/headers
[ "$2" = quick ] && build=$1/headers_quick
. tests/check.sh

needs_little() { # needs_little OBJECT : only the libm functions named here, and memory copies of the compiler
    undefined=$(nm -u "$1" | awk '{print $2}' | grep -vE '^(sqrt|floor|fabs|copysign)f?$' |
        grep -vE '^(memcpy|memset|memmove|_GLOBAL_OFFSET_TABLE_)$')
    writable=$(nm "$1" | awk '$2 ~ /^[BbDdC]$/')
    echo "undefined: $undefined; writable: $writable"
    [ -z "$undefined$writable" ]
}
imports() { # imports HEADER double|float [OPTION] : an object of all functions, of varmass.h that of make test
    object=$build/import.o
    if [ "$1" = varmass ]; then
        object=$folder/tests/$2/headers.o
        make -s CC="$cc" "$object" || return 1
    else
        $cc -std=c99 -O2 $3 -DVM_API= -x c -c "$1.h" -o "$object" || return 1
    fi
    needs_little "$object"
}

# the example in a header's manual, and one of those in the README
manual_example() { awk '/^       #include/ {on = 1} on && !/^       / {exit} on {print substr($0, 8)}' "$1"; }
readme_example() { awk -v which="$1" '/^```c$/ {on = ++block == which; next} /^```$/ {on = 0} on' README.md; }

printf '#include "varmass.h"\n' >"$build/shared.c"
single_precision() { # in float no warning, and nothing is computed in double, for which a Cortex-M4F has no unit
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -O2 -Wall -Wextra -Werror \
        -DVM_USE_FLOAT -DVM_API= -I. -c "$build/shared.c" -o "$build/cortex.o" || return 1
    ! arm-none-eabi-nm -u "$build/cortex.o" | grep -E '__aeabi_(d|f2d|i2d|ui2d|l2d|ul2d)|__(add|sub|mul|div)df3'
}
has_tables() { # has_tables LEVEL VALUE : whether the section of the tables is there if VM_READ(x) is VALUE
    $cc -std=c99 $1 '-DVM_TABLE=static const __attribute__((section("vm_tables")))' "-DVM_READ(x)=$2" -DVM_API= -I. \
        -c "$build/shared.c" -o "$build/tables.o" && objdump -h "$build/tables.o" | grep vm_tables
}
all_functions() { # what compiles all functions of varmass.h
    if command -v arm-none-eabi-gcc >/dev/null; then
        check "float on a Cortex-M4F: no warning, no double arithmetic" single_precision
    else
        echo "no arm-none-eabi-gcc here: whether float computes in double on a Cortex-M4F is not checked"
    fi
    check "a shared library of all functions builds without a warning" $cc -std=c99 -O2 -Wall -Wextra -Werror -shared -fPIC \
        -DVM_API= -I. "$build/shared.c" -o "$build/libvarmass.so" -lm
    check "VM_TABLE places the tables" has_tables -O0 "(x)"
    # only an optimiser leaves out tables that nothing reads
    check "every table is read by VM_READ" fails has_tables "-O1 -fno-inline" "((vm_real)1)"
}
# hostile HEADER... : #include lines for standard headers, then every word of tests/hostile_words.txt as a syntax error
hostile_words() {
    for header in assert float limits math stddef stdint stdio stdlib string time; do echo "#include <$header.h>"; done
    sed 's/#.*//' tests/hostile_words.txt | tr ' ' '\n' | awk '
        function define(word) {
            if (sub(/\(\)$/, "", word)) word = word "(...)"
            name = word
            sub(/\(.*/, "", name)
            print "#undef " name "\n#define " word " @ " name " is a macro of another header @"
        }
        function binary(digits, count) {
            if (digits != "") define("B" digits)
            if (count < 8) { binary(digits "0", count + 1); binary(digits "1", count + 1) }
        }
        NF { define($1) }
        END { binary("", 0) }'
}
hostile_words >"$build/hostile.h"
survives() { # survives COMPILER... SOURCE: compiles where all hostile words are macros
    "$@" -include "$build/hostile.h" -I. -fsyntax-only
}
objects() { # objects HEADER... : what their objects import and hold
    for header in "$@"; do
        check "$header.h, double: imports and data" imports $header double
        check "$header.h, float: imports and data" imports $header float -DVM_USE_FLOAT
    done
}
what_takes_long() {
    objects jacobi ateb integrators
    for example in examples/*.c examples/first_steps/*.c examples/wasm/*.c examples/package/consumer/*.c; do
        check "$example among hostile words" survives $cc -std=c99 $example
    done
    all_functions
}
[ "$2" = quick ] || what_takes_long
[ "$2" = rest ] && { check_finish headers; exit; }

objects varmass
for header in jacobi ateb integrators; do
    mkdir "$build/$header"
    cp $header.h "$build/$header"
    printf '#include "%s.h"\nint main(void) { return 0; }\n' $header >"$build/$header/alone.c"
    check "$header.h compiles alone" $cc -std=c99 -c "$build/$header/alone.c" -o "$build/$header/alone.o"
done
for header in jacobi ateb integrators varmass; do
    printf '#include "%s.h"\n' $header >"$build/fast.c"
    check "$header.h refuses -ffast-math" fails $cc -std=c99 -ffast-math -I. -c "$build/fast.c" -o "$build/fast.o"
    check "$header.h: VM_ALLOW_FAST_MATH" $cc -std=c99 -ffast-math -DVM_ALLOW_FAST_MATH -I. -c "$build/fast.c" -o "$build/fast.o"
done
tells_standard() { # C89 has no inline functions: an error that says what to do comes first
    ! $cc -std=c89 -I. -fsyntax-only "$build/standard.c" 2>"$build/c89" && grep error "$build/c89" | head -n 1 | grep -q -e '-std=c99'
}
for header in jacobi ateb integrators varmass; do
    printf '#include "%s.h"\n' $header >"$build/standard.c"
    check "$header.h: -std=c89 is told to be too old" tells_standard
    if command -v g++ >/dev/null; then
        check "$header.h: C++20" g++ -x c++ -std=c++20 -Wall -Wextra -Wpedantic -Werror -I. -fsyntax-only "$build/standard.c"
    fi
done
# tables that a plain read does not find, such as those of PROGMEM on AVR, need to be read in their own way
check "VM_TABLE without VM_READ is refused" fails $cc -std=c99 "-DVM_TABLE=static const" -I. -c "$build/shared.c" -o "$build/shared.o"
check "VM_READ without VM_TABLE is refused" fails $cc -std=c99 "-DVM_READ(x)=(x)" -I. -c "$build/shared.c" -o "$build/shared.o"
check "VM_TABLE and VM_READ" $cc -std=c99 "-DVM_TABLE=static const" "-DVM_READ(x)=(x)" -I. -c "$build/shared.c" -o "$build/shared.o"
check "float and double in one program: builds" $cc -std=c99 -O2 tests/mixed_double.c tests/mixed_float.c -o "$build/mixed" -lm
check "float and double in one program: agrees" "$build/mixed"
for header in jacobi ateb integrators varmass; do
    manual_example $header.h >"$build/$header.c"
    check "$header.h: the manual's example builds" $cc -std=c99 -I. "$build/$header.c" -o "$build/$header.example" -lm
    check "$header.h: the manual's example runs" "$build/$header.example"
done
check "the hostile words are found" test "$(grep -c define "$build/hostile.h")" -gt 700
check "the hostile words are hostile" fails $cc -std=c99 -include "$build/hostile.h" -DVM_NAME=near -x c -c - -o "$build/hostile.o" <<'END'
int VM_NAME;
END
for header in jacobi ateb integrators varmass; do
    printf '#include "%s.h"\n' $header >"$build/words.c"
    for options in "-std=c99" "-std=gnu99" "-std=c99 -DVM_USE_FLOAT"; do
        check "$header.h among hostile words, $options" survives $cc $options "$build/words.c"
    done
done
if command -v x86_64-w64-mingw32-gcc >/dev/null; then
    for header in jacobi ateb integrators varmass; do
        printf '#include <windows.h>\n#include "%s.h"\n' $header >"$build/windows.c"
        check "$header.h after <windows.h>" x86_64-w64-mingw32-gcc -std=c99 -I. -c "$build/windows.c" -o "$build/windows.o"
    done
fi
inlined() { # the right-hand side of the integrators is in the loop: no call of it is left
    cat >"$build/inlined.c" <<'END'
#include "integrators.h"
static int right_hand_side(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[1], dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}
vm_real run(int method, vm_real *y)
{
    vm_real work[RK87_WORK(2)], t = 0;
    rk45 s;
    if (method == 4) return rk4_solve(right_hand_side, NULL, 2, &t, 10, 100, y, work) ? 0 : y[0];
    if ((method == 5 ? rk45_init : rk87_init)(&s, right_hand_side, NULL, 2, 0, y, NULL, work) < 0) return 0;
    return (method == 5 ? rk45_solve_with(&s, right_hand_side, 2, 10) : rk87_solve_with(&s, right_hand_side, 2, 10)) ? 0 : s.y[0];
}
END
    $cc -std=c99 -O2 -I. -S "$build/inlined.c" -o "$build/inlined.s" || return 1
    ! grep -E '(call|bl|jmp)[a-z]*[[:space:]]+_?right_hand_side' "$build/inlined.s"
}
check "integrators.h: the right-hand side is inlined" inlined
rooms_of_three=$(for room in real self_check sums bits words arrays elementary chebyshev; do echo src/base/$room.h; done
    echo src/jacobi/*.h src/ateb/*.h src/integrators/*.h)
bounded() { # every loop has its entry in tests/loops.txt, and no entry is left over
    awk -f tests/loops.awk $rooms_of_three >"$build/loops"
    [ "$(wc -l <"$build/loops")" -gt 50 ] && grep -v '^#' tests/loops.txt | cut -f1-3 | diff "$build/loops" - &&
        ! grep -v '^#' tests/loops.txt | grep -vE '^([^	]+	){3}[^	]+$'
}
check "every loop has a known bound" bounded

lines_are_there() { # lines_are_there LIST: has each header the lines that LIST names?
    awk -F '\t' '
        FNR == 1 && FILENAME ~ /\.h$/ {header = FILENAME; sub(/\.h$/, "", header)}
        FILENAME ~ /\.h$/ {sub(/^ +/, ""); has[header, $0] = 1; next}
        !/^#/ && !(($1, $2) in has) {print $1 ".h has no such line: " $2; missing = 1}
        END {exit missing}' varmass.h ateb.h jacobi.h integrators.h "$1"
}
check "the lines of tests/mutants.txt are in the headers" lines_are_there tests/mutants.txt
printf 'jacobi\tno such line;\n' >"$build/mutants"
check "a line that is not in its header is found" fails lines_are_there "$build/mutants"

# No function of the headers calls itself, directly or by others: the graph of calls has no loop, which tsort would report.
# Calls by pointers are not in it.
calls() { # calls FLAG...: pairs of a function and one that it calls
    printf '#include "varmass.h"\n' | $cc -std=c99 -w -O0 -fkeep-static-functions -fkeep-inline-functions "$@" -I. -x c - -S -o - |
        awk '/^[A-Za-z_][A-Za-z_0-9]*:/ { name = $1; sub(/:.*/, "", name) } $1 ~ /^(call|bl$|jal|brasl)/ { sub(/@.*/, "", $2); print name, $2 }'
}
without_loop() { # a loop of one function is a pair of twice the same, which tsort would take for a node
    awk '$1 == $2 { print $1 " calls itself"; found = 1 } END { exit found }' "$build/calls" && tsort "$build/calls" >/dev/null
}
calls_end() {
    calls >"$build/calls" && [ "$(wc -l <"$build/calls")" -gt 1000 ] && without_loop
}
check "no function calls itself" calls_end
printf 'a b\nb c\nc a\n' >"$build/calls"
check "functions that call each other are found" fails without_loop
printf 'a b\nb b\n' >"$build/calls"
check "a function that calls itself is found" fails without_loop
with_null_pointers() { # each function of varmass.h that takes a pointer is called with null ones in tests/null_pointers.h
    sed 's|/\*.*\*/||; /\/\*/,/\*\//d' varmass.h |
        awk '/^VM_(API|INLINE) / {on = 1; text = ""} on {text = text $0} on && /[;{]/ {sub(/{.*/, "", text); print text; on = 0}' |
        sed -nE 's/^VM_(API|INLINE) ([a-z_0-9]+ )+\*?(vm_[a-zA-Z0-9_]+)\((.*)\).*/\3 \4/p' |
        awk '/[*[]|vm_motion_function|vm_law_function|vm_moving_point/ {print $1}' | sort -u >"$build/with_pointers"
    [ "$(wc -l <"$build/with_pointers")" -gt 150 ] || return 1
    missing=0
    while read -r name; do grep -qw "$name" tests/null_pointers.h || { echo "$name"; missing=1; }; done <"$build/with_pointers"
    [ $missing = 0 ]
}
check "every function is called with null pointers" with_null_pointers
in_readme() { [ "$(wc -l <"$1")" -gt 0 ] && [ "$(grep -cxFf "$1" README.md)" = "$(wc -l <"$1")" ]; }
for which in 1 2; do
    readme_example $which >"$build/readme.c"
    check "the README's example $which builds" $cc -std=c99 -I. "$build/readme.c" -o "$build/readme.example" -lm
    "$build/readme.example" | sed 's/^/    /' >"$build/readme.output"
    check "the README's example $which prints what it says" in_readme "$build/readme.output"
done
check_finish headers
