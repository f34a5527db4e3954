#!/bin/sh
# Flash, stack and instructions of a call of each function on emulated microcontrollers, as tables (markdown) and as CSV.
# usage: table.sh BUILD_FOLDER, from the top of the project
build=$1/firmware
mkdir -p "$build"
common="-std=c99 -Os -fno-math-errno -ffp-contract=off -ffunction-sections -fdata-sections -nostartfiles -Wl,--gc-sections -I."
cortex="-T tests/cross/cortex_m.ld -Wl,--defsym=FLASH_SIZE=0x40000 tests/cross/cortex_m.c"
riscv="--specs=picolibc.specs -mcmodel=medany -T tests/cross/riscv.ld -Wl,--no-warn-rwx-segments tests/cross/riscv.c"
targets="M0 M4F M7 RV32IMAC RV32IMAFDC"

build_one() { # build_one TARGET FLAGS... : $build/call.elf
    compiler="arm-none-eabi-gcc -mthumb -Wl,--defsym=RAM_SIZE=0x10000" startup=$cortex
    case $1 in
    M0) compiler="arm-none-eabi-gcc -mthumb -Wl,--defsym=RAM_SIZE=0x4000 -mcpu=cortex-m0" ;;
    M4F) compiler="$compiler -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16" ;;
    M7) compiler="$compiler -mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16" ;;
    RV32IMAC) compiler="riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32" startup=$riscv ;;
    RV32IMAFDC) compiler="riscv64-unknown-elf-gcc -march=rv32imafdc -mabi=ilp32d" startup=$riscv ;;
    esac
    shift
    $compiler $common $startup "$@" examples/firmware/call.c -o "$build/call.elf" -lm
}
flash() { # text, data and tables: what lies in flash
    case $1 in RV*) riscv64-unknown-elf-size "$build/call.elf" ;; *) arm-none-eabi-size "$build/call.elf" ;; esac |
        awk 'NR == 2 {print $1 + $2}'
}
run() { # run TARGET : instructions and stack. The code for Cortex-M0 runs on a board with an M3, which has a counter
    case $1 in
    M0) board="qemu-system-arm -M mps2-an385 -icount shift=10" ;;
    M4F) board="qemu-system-arm -M mps2-an386 -icount shift=10" ;;
    M7) board="qemu-system-arm -M mps2-an500 -icount shift=10" ;;
    RV*) board="qemu-system-riscv32 -M virt -bios none -icount shift=0" ;;
    esac
    $board -nographic -monitor none -serial none -semihosting-config enable=on,target=native -kernel "$build/call.elf" 2>&1 </dev/null
}
measure() { # measure PRECISION NAME HEADER CALL EXTRA_FLAG... : a row
    precision=$1 name=$2 header=$3 call=$4 flag=
    shift 4
    [ $precision = float ] && flag=-DVM_USE_FLOAT
    printf '| `%s` |' "$name"
    for target in $targets; do
        build_one $target $flag "-DHEADER=\"$header\"" "-DCALL=a = u" || exit 1
        empty=$(flash $target)
        build_one $target $flag "-DHEADER=\"$header\"" "-DCALL=$call" "$@" || exit 1
        grown=$(($(flash $target) - empty))
        result=$(run $target)
        instructions=${result% *} stack=${result#* }
        printf ' %s, %s, %s |' "$grown" "$stack" "$instructions"
        echo "$name,$precision,$target,$grown,$stack,$instructions" >>"$build/table.csv"
    done
    printf '\n'
}
print_plan() { # print_plan PRECISION ORDER : the plan of a leaking oscillator as a constant, $build/closed.h
    flag=
    [ $1 = float ] && flag=-DVM_USE_FLOAT
    ${CC:-cc} -std=c99 $flag examples/print_plan.c -o "$build/print_plan" -lm &&
        "$build/print_plan" closed 1.7 10 0.03 100 0 1 0 0.1 0 $2 30 >"$build/closed.h" || exit 1
}
rows() { # rows PRECISION
    printf '\n## %s\n\n| function |' "$1"
    for target in $targets; do printf ' %s |' $target; done
    printf '\n|---|'
    for target in $targets; do printf -- '---|'; done
    printf '\n'
    measure $1 "jacobi_K" jacobi.h "a = jacobi_K(m)"
    measure $1 "jacobi_E" jacobi.h "a = jacobi_E(m)"
    measure $1 "jacobi_sncndn" jacobi.h "jacobi_sncndn(u, m, &a, &b, &c)"
    measure $1 "jacobi_plan_sncndn" jacobi.h "jacobi_plan_sncndn(&plan, u, &a, &b, &c)" -DPLAN=jacobi_plan "-DINIT=jacobi_plan_init(&plan, input[1])"
    measure $1 "jacobi_am" jacobi.h "a = jacobi_am(u, m)"
    measure $1 "jacobi_solve_kpK" jacobi.h "a = jacobi_solve_kpK(alpha)"
    measure $1 "ateb_pi" ateb.h "a = ateb_pi(alpha)"
    measure $1 "ateb_saca" ateb.h "ateb_saca(u, alpha, &a, &b)"
    measure $1 "ateb_plan_saca (alpha = 3)" ateb.h "ateb_plan_saca(&plan, u, &a, &b)" -DPLAN=ateb_plan "-DINIT=ateb_plan_init(&plan, 3)"
    measure $1 "ateb_plan_saca (alpha = 1.7)" ateb.h "ateb_plan_saca(&plan, u, &a, &b)" -DPLAN=ateb_plan "-DINIT=ateb_plan_init(&plan, (vm_real)1.7)"
    measure $1 "ateb_phase" ateb.h "a = ateb_phase(m, u, alpha)"
    measure $1 "ateb_beta_inc" ateb.h "a = ateb_beta_inc(u, m, alpha)"
    measure $1 "vm_osc_period" varmass.h "a = vm_osc_period(u, m, alpha)"
    for order in 2 3 5; do
        at=vm_osc_closed_at name="vm_osc_closed_at (order 5)"
        [ $order -lt 5 ] && at=vm_osc_closed_at_order$order name=vm_osc_closed_at_order$order
        print_plan $1 $order
        measure $1 "$name" varmass.h "$at(&plan, u, &a, &b)" \
            "-DCONSTANT_PLAN=\"$build/closed.h\"" -DTIMES=200
        measure $1 "vm_osc_closed_init (order $order)" varmass.h "set_problem(m), a = vm_osc_closed_init(&made, &problem, $order, 30)" -DPROBLEM
    done
    measure $1 "vm_osc_amplitude_law" varmass.h "a = vm_osc_amplitude_law(u, m, 1, alpha)"
    measure $1 "vm_lambert_w0" varmass.h "a = vm_lambert_w0(u)"
    measure $1 "vm_separate2" varmass.h "part.vx = m, vm_separate2(&whole, &part, NULL, &rest), a = rest.omega"
    measure $1 "rk4_step" integrators.h "rk4_step(oscillate, NULL, 2, 0, m, y, work), a = y[0]"
    measure $1 "rk45_step" integrators.h "rk45_step(&run), a = run.y[0]" "-DINIT=rk45_init(&run, oscillate, NULL, 2, 0, y, NULL, work)"
}
avr_flash() { # avr_flash ORDER FLAG... : flash of a program that makes a plan of this order on an ATmega328P and uses it
    order=$1
    shift
    avr-gcc -mmcu=atmega328p -DF_CPU=16000000UL -std=c99 -Os -ffp-contract=off -ffunction-sections -Wno-unused-function "$@" \
        -Wl,--gc-sections -Wl,--defsym=__TEXT_REGION_LENGTH__=64K -DMADE=$order tests/cross/avr.c tests/cross/tables.c \
        -o "$build/made.elf" -lm && avr-size "$build/made.elf" | awk 'NR == 2 {print $1 + $2}'
}
avr_table() {
    printf '\n## ATmega328P\n\nBytes of flash of a whole program in float that makes the plan of a leaking oscillator on the board, evaluates\n'
    printf 'it at 16 times and prints the results (tests/cross/tables.c). The ATmega328P has 32768. A plan that is made on a\n'
    printf 'PC is a constant and needs none of the code that makes it.\n\n| order of the law | -Os | -Os -mcall-prologues -mrelax |\n|---|---|---|\n'
    for order in 2 3 5; do
        printf '| %s | %s | %s |\n' $order "$(avr_flash $order)" "$(avr_flash $order -mcall-prologues -mrelax)"
    done
}
echo "function,precision,target,flash,stack,instructions" >"$build/table.csv"
cat <<'END'
# Flash, stack and instructions of a call

Written by `make firmware-table`, with gcc -Os. "Flash" is the number of bytes by which a program grows, with all tables and functions
that the call needs. "Stack" is in bytes. "Instructions" are those of one call, counted on emulated boards.

| target | processor |
|---|---|
| M0 | Cortex-M0, without floating-point unit |
| M4F | Cortex-M4F, with float in hardware; double is emulated |
| M7 | Cortex-M7, with float and double in hardware |
| RV32IMAC | RISC-V without floating-point unit |
| RV32IMAFDC | RISC-V with float and double in hardware |

The rows of plans include the code that makes the plan; a `const` plan in flash does not need it. `vm_osc_closed_at` is the motion of a
leaking oscillator by the law of order two, three and five, from such a constant plan. Its flash contains the plan, and its
instructions are the most at 200 times. `vm_osc_closed_init` makes such a plan on the board, for a linear law of mass. `rk4_step` and
`rk45_step` are steps of a cubic oscillator, with their four and six evaluations of the right-hand side.

![instructions of a call](figures/firmware.svg)
END
rows float
rows double
avr_table
