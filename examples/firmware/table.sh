#!/bin/sh
# Flash, stack and instructions of a call of each function on emulated Cortex-M0, M4F and M7, as a table (markdown) and as
# CSV. usage: table.sh BUILD_FOLDER, from the top of the project
build=$1/firmware
mkdir -p "$build"
common="-std=c99 -Os -fno-math-errno -ffp-contract=off -ffunction-sections -fdata-sections -nostartfiles -T tests/cross/cortex_m.ld -Wl,--gc-sections"
small="-Wl,--defsym=FLASH_SIZE=0x40000,--defsym=RAM_SIZE=0x4000"
large="-Wl,--defsym=FLASH_SIZE=0x40000,--defsym=RAM_SIZE=0x10000"

build_one() { # build_one TARGET FLAGS... : $build/call.elf
    case $1 in
    M0) cpu="-mcpu=cortex-m0 -mthumb $small" ;;
    M4F) cpu="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 $large" ;;
    M7) cpu="-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16 $large" ;;
    esac
    shift
    arm-none-eabi-gcc $cpu $common -I. "$@" tests/cross/cortex_m.c examples/firmware/call.c -o "$build/call.elf" -lm
}
flash() { arm-none-eabi-size "$build/call.elf" | awk 'NR == 2 {print $1 + $2}'; }
run() { # run TARGET : instructions and stack
    case $1 in M0) board=microbit ;; M4F) board=mps2-an386 ;; M7) board=mps2-an500 ;; esac
    qemu-system-arm -M $board -icount shift=10 -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$build/call.elf" 2>&1 </dev/null
}
row() { # row NAME HEADER CALL EXTRA_FLAG...
    name=$1 header=$2 call=$3
    shift 3
    printf '| `%s` |' "$name"
    for precision in float double; do
        flag=
        [ $precision = float ] && flag=-DVM_USE_FLOAT
        for target in M0 M4F M7; do
            build_one $target $flag "-DHEADER=\"$header\"" "-DCALL=a = u" || exit 1
            empty=$(flash)
            build_one $target $flag "-DHEADER=\"$header\"" "-DCALL=$call" "$@" || exit 1
            set_size=$(($(flash) - empty))
            result=$(run $target)
            instructions=${result% *} stack=${result#* }
            [ $target = M0 ] && instructions=- # this board has no such counter
            printf ' %s, %s, %s |' "$set_size" "$stack" "$instructions"
            echo "$name,$precision,$target,$set_size,$stack,$instructions" >>"$build/table.csv"
        done
    done
    printf '\n'
}
echo "function,precision,target,flash,stack,instructions" >"$build/table.csv"
cat <<'END'
# Flash, stack and instructions of a call

Written by `make firmware-table`: bytes of flash that a program grows by, tables and all that the function needs included,
bytes of stack, instructions of a call, on emulated boards; gcc -Os. M0: Cortex-M0, no floating-point unit (and an
emulated board without a counter); M4F: Cortex-M4F, single precision in hardware, so that double is emulated; M7:
Cortex-M7, both in hardware. The rows of plans include what makes the plan, which a `const` plan in flash does not need.

END
echo '| function | float: M0 | M4F | M7 | double: M0 | M4F | M7 |'
echo '|---|---|---|---|---|---|---|'
row "jacobi_K" jacobi.h "a = jacobi_K(m)"
row "jacobi_E" jacobi.h "a = jacobi_E(m)"
row "jacobi_sncndn" jacobi.h "jacobi_sncndn(u, m, &a, &b, &c)"
row "jacobi_plan_sncndn" jacobi.h "jacobi_plan_sncndn(&plan, u, &a, &b, &c)" -DPLAN=jacobi_plan "-DINIT=jacobi_plan_init(&plan, input[1])"
row "jacobi_am" jacobi.h "a = jacobi_am(u, m)"
row "jacobi_solve_kpK" jacobi.h "a = jacobi_solve_kpK(alpha)"
row "ateb_pi" ateb.h "a = ateb_pi(alpha)"
row "ateb_saca" ateb.h "ateb_saca(u, alpha, &a, &b)"
row "ateb_plan_saca, alpha = 3" ateb.h "ateb_plan_saca(&plan, u, &a, &b)" -DPLAN=ateb_plan "-DINIT=ateb_plan_init(&plan, 3)"
row "ateb_plan_saca, alpha = 1.7" ateb.h "ateb_plan_saca(&plan, u, &a, &b)" -DPLAN=ateb_plan "-DINIT=ateb_plan_init(&plan, (vm_real)1.7)"
row "ateb_phase" ateb.h "a = ateb_phase(m, u, alpha)"
row "ateb_beta_inc" ateb.h "a = ateb_beta_inc(u, m, alpha)"
row "vm_osc_period" varmass.h "a = vm_osc_period(u, m, alpha)"
row "vm_osc_amplitude_law" varmass.h "a = vm_osc_amplitude_law(u, m, 1, alpha)"
row "vm_lambert_w0" varmass.h "a = vm_lambert_w0(u)"
