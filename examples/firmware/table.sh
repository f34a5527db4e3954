#!/bin/sh
# Flash, stack and instructions of a call of each function on emulated microcontrollers, as tables (markdown) and as CSV.
# usage: table.sh BUILD_FOLDER, from the top of the project
build=$1/firmware
mkdir -p "$build"
common="-std=c99 -Os -fno-math-errno -ffp-contract=off -ffunction-sections -fdata-sections -nostartfiles -Wl,--gc-sections -I."
cortex="-T tests/cross/cortex_m.ld -Wl,--defsym=FLASH_SIZE=0x40000 tests/cross/cortex_m.c"
riscv="--specs=picolibc.specs -mcmodel=medany -T tests/cross/riscv.ld -Wl,--no-warn-rwx-segments tests/cross/riscv.c"
targets=${TARGETS:-M0 M4F M7 RV32IMAC RV32IMAFDC}

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
measure() { # measure PRECISION NAME HEADER CALL DRAW HARD EXTRA_FLAG... : a row. Flash is beyond a program with the same arguments
    precision=$1 name=$2 header=$3 call=$4 draw=$5 hard=${6:+-DHARD=$6} flag=-DIN_DOUBLE
    shift 6
    [ $precision = float ] && flag=-DVM_USE_FLOAT
    printf '| `%s` |' "$name"
    for target in $targets; do
        build_one $target $flag "-DHEADER=\"$header\"" "-DCALL=a = u" -DTRIALS=1 "-DDRAW=$draw" ${hard:+"$hard"} || exit 1
        empty=$(flash $target)
        build_one $target $flag "-DHEADER=\"$header\"" "-DCALL=$call" -DTRIALS=$trials "-DDRAW=$draw" ${hard:+"$hard"} "$@" || exit 1
        grown=$(($(flash $target) - empty))
        result=$(run $target)
        case $result in *[!0-9\ ]* | "") echo "table.sh: $name, $target: $result" >&2; exit 1 ;; esac
        instructions=${result% *} stack=${result#* }
        printf ' %s, %s, %s |' "$grown" "$stack" "$instructions"
        echo "$name,$precision,$target,$grown,$stack,$instructions" >>"$build/table.csv"
    done
    printf '\n'
}
print_plan() { # print_plan PRECISION ORDER : the plan of an oscillator with growing mass as a constant, $build/closed.h
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
    # for float |u| goes to 1e4, for double to 1e9, as the bounds of docs/measurements.md do
    largest=1e9
    [ $1 = float ] && largest=1e4
    of_m="m = 1 - 11 * between(0, 1)" hard_m="{0,0,0},{0,(vm_real)0.9999999,0},{0,-1000000,0},{0,1,0}"
    of_u_m="u = between(-100, 100); $of_m"
    hard_u_m="{VM_C($largest),VM_C(0.3),0},{VM_C($largest),VM_C(0.9999),0},{VM_C($largest),-10,0},{30,1,0},{1000,VM_C(0.9999999),0},{0,0,0}"
    of_alpha="alpha = between(0, 10)" hard_alpha="{0,0,0},{0,0,VM_C(1e-3)},{0,0,VM_C(1e3)},{0,0,1},{0,0,3}"
    of_s="u = between(-100, 100); $of_alpha"
    hard_s="{VM_C($largest),0,VM_C(1.7)},{VM_C($largest),0,VM_C(0.01)},{VM_C($largest),0,100},{0,0,1},{3,0,0}"
    of_times="u = between(0, 30)" hard_times="{0,0,0},{30,0,0}"
    trials=300
    measure $1 "jacobi_K" jacobi.h "a = jacobi_K(m)" "$of_m" "$hard_m"
    measure $1 "jacobi_E" jacobi.h "a = jacobi_E(m)" "$of_m" "$hard_m"
    measure $1 "jacobi_sncndn" jacobi.h "jacobi_sncndn(u, m, &a, &b, &c)" "$of_u_m" "$hard_u_m"
    measure $1 "jacobi_plan_sncndn" jacobi.h "jacobi_plan_sncndn(&plan, u, &a, &b, &c)" "$of_u_m" "$hard_u_m" \
        -DPLAN=jacobi_plan "-DINIT=jacobi_plan_init(&plan, VM_C(0.3))"
    measure $1 "jacobi_am" jacobi.h "a = jacobi_am(u, m)" "$of_u_m" "$hard_u_m"
    measure $1 "jacobi_solve_kpK" jacobi.h "a = jacobi_solve_kpK(u)" "u = between(0, 4)" "{VM_C(1e-3),0,0},{VM_C(1.5707),0,0},{100,0,0},{10,0,0}"
    measure $1 "ateb_pi" ateb.h "a = ateb_pi(alpha)" "$of_alpha" "$hard_alpha"
    measure $1 "ateb_saca" ateb.h "ateb_saca(u, alpha, &a, &b)" "$of_s" "$hard_s"
    measure $1 "ateb_plan_saca (alpha = 3)" ateb.h "ateb_plan_saca(&plan, u, &a, &b)" "$of_s" "$hard_s" \
        -DPLAN=ateb_plan "-DINIT=ateb_plan_init(&plan, 3)"
    measure $1 "ateb_plan_saca (alpha = 1.7)" ateb.h "ateb_plan_saca(&plan, u, &a, &b)" "$of_s" "$hard_s" \
        -DPLAN=ateb_plan "-DINIT=ateb_plan_init(&plan, VM_C(1.7))"
    measure $1 "ateb_phase" ateb.h "a = ateb_phase(u, m, alpha)" "u = between(-1, 1); m = between(-1, 1); $of_alpha" "{0,1,1},{1,0,1},{VM_C(1e-6),1,5}"
    measure $1 "ateb_beta_inc" ateb.h "a = ateb_beta_inc(u, m, alpha)" \
        "u = between(0, 1); m = between(VM_C(0.01), 100); alpha = between(VM_C(0.01), 100)" "{VM_C(0.5),100,100},{VM_C(0.5),1000,1000},{VM_C(0.999),5,VM_C(0.01)}"
    measure $1 "vm_osc_period" varmass.h "a = vm_osc_period(u, m, alpha)" "u = between(VM_C(0.1), 10); m = between(VM_C(0.1), 10); $of_alpha" ""
    measure $1 "vm_osc_exact" varmass.h "vm_osc_exact(u, m, 1, alpha, &a, &b)" "u = between(-100, 100); m = between(VM_C(0.1), 10); $of_alpha" ""
    for order in 2 3 5; do
        at=vm_osc_closed_at name="vm_osc_closed_at (order 5)"
        [ $order -lt 5 ] && at=vm_osc_closed_at_order$order name=vm_osc_closed_at_order$order
        print_plan $1 $order
        trials=300
        measure $1 "$name" varmass.h "$at(&plan, u, &a, &b)" "$of_times" "$hard_times" "-DCONSTANT_PLAN=\"$build/closed.h\""
        trials=10 # of some million instructions each
        measure $1 "vm_osc_closed_init (order $order)" varmass.h "a = vm_osc_closed_init(&made, &problem, $order, 30)" "draw_problem()" ""
    done
    trials=300
    measure $1 "vm_osc_amplitude_law" varmass.h "a = vm_osc_amplitude_law(u, m, 1, alpha)" \
        "u = between(VM_C(0.1), 10); m = between(0, 1); $of_alpha" ""
    measure $1 "vm_lambert_w0" varmass.h "a = vm_lambert_w0(u)" "u = between(VM_C(-0.367), 10)" "{VM_C(1e9),0,0},{VM_C(-0.36787),0,0},{0,0,0}"
    measure $1 "vm_separate2" varmass.h "a = vm_separate2(&whole2, &part2, NULL, &rest2)" "draw_bodies2()" ""
    measure $1 "vm_attach2" varmass.h "a = vm_attach2(&whole2, &part2, NULL, &rest2)" "draw_bodies2()" ""
    measure $1 "vm_separate" varmass.h "a = vm_separate(&whole, &part, NULL, &rest)" "draw_bodies()" ""
    measure $1 "vm_attach" varmass.h "a = vm_attach(&whole, &part, NULL, &rest)" "draw_bodies()" ""
    measure $1 "vm_torque_free_init" varmass.h "a = vm_torque_free_init(&motion, &whole, 0)" "draw_rotation()" ""
    measure $1 "vm_torque_free_attitude" varmass.h "a = vm_torque_free_attitude(&motion, u, &attitude, &spin)" \
        "draw_rotation(); vm_torque_free_init(&motion, &whole, 0)" ""
    measure $1 "vm_scene_rhs (3 effects)" varmass.h "a = vm_scene_rhs(0, y, y + 3, &scene)" "draw_scene()" ""
    measure $1 "rk4_step of the scene" varmass.h "a = rk4_step(vm_scene_rhs, &scene, vm_scene_size(&scene), 0, VM_C(0.01), y, scene_work)" "draw_scene()" ""
    measure $1 "rk4_step" integrators.h "a = rk4_step(oscillate, NULL, 2, 0, m, y, work)" "m = between(0, VM_C(0.1)); y[0] = between(-1, 1); y[1] = between(-1, 1)" ""
    measure $1 "rk45_step" integrators.h "a = rk45_step(&run)" "y[0] = between(-1, 1); y[1] = between(-1, 1); rk45_init(&run, oscillate, NULL, 2, 0, y, NULL, work)" ""
}
avr_flash() { # avr_flash ORDER FLAG... : flash of a program that makes a plan of this order on an ATmega328P and uses it
    order=$1
    shift
    avr-gcc -mmcu=atmega328p -DF_CPU=16000000UL -std=c99 -Os -ffp-contract=off -ffunction-sections -Wno-unused-function "$@" \
        -Wl,--gc-sections -Wl,--defsym=__TEXT_REGION_LENGTH__=64K -DMADE=$order tests/cross/avr.c tests/cross/tables.c \
        -o "$build/made.elf" -lm && avr-size "$build/made.elf" | awk 'NR == 2 {print $1 + $2}'
}
avr_table() {
    sh tests/install.sh -w "for the flash of programs on an ATmega328P" "command -v avr-gcc" gcc-avr avr-libc binutils-avr ||
        return 1
    printf '\n## ATmega328P\n\n'
    printf 'The ATmega328P is a processor with 32768 bytes of flash. The table shows how many bytes of flash the program tests/cross/tables.c\n'
    printf 'needs. This program is written for the ATmega328P and computes in float: it makes the plan of an oscillator that loses mass,\n'
    printf 'computes the motion at 16 times from this plan, and prints the results. Each row of the table is for one order of the law (the\n'
    printf 'approximate formula) by which the program computes the motion. If a number in the table is larger than 32768, the program does not\n'
    printf 'fit into the flash. If the plan is made on a PC and stored as a constant, the program needs less flash, because it does not\n'
    printf 'contain the code that makes the plan. The second and third column are for two sets of options of the compiler avr-gcc, which the\n'
    printf 'headings of the columns name.\n'
    printf '\n| order of the law | -Os | -Os -mcall-prologues -mrelax |\n|---|---|---|\n'
    for order in 2 3 5; do
        printf '| %s | %s | %s |\n' $order "$(avr_flash $order)" "$(avr_flash $order -mcall-prologues -mrelax)"
    done
}
echo "function,precision,target,flash,stack,instructions" >"$build/table.csv"
cat <<'END'
# Flash, stack and instructions of a call

This page says how much memory a call of a function of the kit needs on microcontrollers, and how many instructions the call
executes. The command `make firmware-table` writes this page. The functions are compiled by gcc with the options
`-Os -fno-math-errno -ffp-contract=off`.

In the tables for float and double, each cell has three numbers, which describe a call of one function: flash, stack and
instructions. Flash is the memory that stores the program. The number for flash says by how many bytes a program grows when the
call is added to it, with all functions and tables of constants that the call needs. The number for the stack says how many bytes
of the stack the call needs. The number of instructions says how many machine instructions the processor executes during the call.
Stack and instructions were measured in many calls on emulated boards (boards that a PC imitates). In the tables, each of these
two numbers is the largest of all calls. The next table lists the processors for which the functions were compiled. The short
names in its first column are the headings of the columns in the tables for float and double.

| target | processor |
|---|---|
| M0 | Cortex-M0, without floating-point unit |
| M4F | Cortex-M4F, with float in hardware; double is emulated |
| M7 | Cortex-M7, with float and double in hardware |
| RV32IMAC | RISC-V without floating-point unit |
| RV32IMAFDC | RISC-V with float and double in hardware |

Each function was called with 300 random sets of arguments (only `vm_osc_closed_init` with 10), and then with some difficult
arguments. Jacobi's elliptic functions (`jacobi_sncndn`) have the argument u and the parameter m, and the integrals `jacobi_K` and
`jacobi_E` have only m. The Ateb functions (`ateb_saca`), which describe nonlinear vibrations, have the argument s and the
exponent alpha. In most rows with these arguments, the random numbers are m from -10 to 1, u and s from -100 to 100, and alpha
from 0 to 10. Difficult arguments are the ends of the intervals of allowed arguments, the large arguments u = 1e9 and s = 1e9 (in
float 1e4), and values of m that are next to 1. The script examples/firmware/table.sh lists all difficult arguments. The functions
`vm_separate`, `vm_attach`, `vm_torque_free_init` and `vm_torque_free_attitude` are for bodies in space; in their calls, the
bodies have three different moments of inertia, a random attitude and a random motion. With other arguments than these, a call may
need a larger stack or more instructions than the tables say.

A plan is a struct of numbers that are computed once and then used in many calls. In the rows of `jacobi_plan_sncndn` and
`ateb_plan_saca` the number for flash includes the code that computes the plan. A program does not need this code if its plan was
computed on a PC and is a constant in flash. The following list explains some other functions in the first column of the tables
for float and double:

- `vm_osc_closed_at` computes the motion of an oscillator whose mass grows; the exponent alpha of its spring force is 1.7. The
  function uses an approximate formula (law) of order two, three or five; the first column names the order. The plan of this
  oscillator is a constant in flash, and the number for flash includes the plan.
- `vm_osc_closed_init` computes a plan for `vm_osc_closed_at` on the board. The mass of the oscillator is a linear function of
  time.
- `vm_osc_exact` computes the motion of an oscillator with constant mass.
- `vm_torque_free_attitude` computes the attitude of a rotating body without torque, at times from -1000 s to 1000 s. The function
  `vm_torque_free_init`, which must be called once before, has a row of its own. The code that both functions use is counted only
  in the flash of the row of `vm_torque_free_init`.
- The rows `vm_scene_rhs (3 effects)` and `rk4_step of the scene` are for the motion of a scene, which is a list of bodies, forces
  and events. The function `rk4_step` makes one step of the integrator rk4. The scene of these two rows is a tray that loses its
  load; a damper and a spring act on the tray. The force of the spring is proportional to a power of its extension, whose exponent
  is a random number from 1 to 4. A call of `vm_scene_rhs` evaluates the equation of motion of the tray once, and a call of
  `rk4_step` evaluates it four times. The flash of the function `vm_scene_start`, which must be called once before, is not counted
  in these two rows. [scene-sizes.md](scene-sizes.md) says how much flash whole programs with scenes need.
- The rows `rk4_step` and `rk45_step` compute one step of the motion of an oscillator with the equation x'' = -x^3. For
  `rk45_step`, the step is the first step of an integration. The first step usually takes more instructions than a later step,
  because `rk45_step` must first choose the length of the step.

![instructions of a call](figures/firmware.svg)
END
rows float
rows double
avr_table
