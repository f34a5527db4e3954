#!/bin/sh
# The same bits on a graphics processor: tests/golden.cu, a program for each section and precision, and examples/cuda. nvcc takes
# ten minutes for the fifty programs on two cores.
# usage: gpu.sh BUILD_FOLDER, from the top of the project, on a machine with nvcc and a GPU
build=$1/gpu
. tests/check.sh
sections=$(sed -n 's/^    RUN(\([a-z_]*\));$/\1/p' tests/golden.c)
options="-arch=native -fmad=false -diag-suppress 20011" # a product and a sum are not fused; no warning of __host__ functions that are not called

compile() { # compile PRECISION "OPTIONS": the programs of all sections
    printf '%s\n' $sections | xargs -P "$(nproc)" -I{} nvcc -std=c++17 -O1 $options $2 -DGOLDEN_SECTION={} tests/golden.cu -o "$build/$1.{}"
}
run() { # one program after the other, because each one asks for a large stack
    for precision in double float; do
        for section in $sections; do
            "$build/$precision.$section" || return 1
        done
    done
}
check "compiles in double" compile double ""
check "compiles in float" compile float -DVM_USE_FLOAT
run >"$build/lines"
check "the bits of tests/data/golden.txt" diff tests/data/golden.txt "$build/lines"
for precision in "" -DVM_USE_FLOAT; do
    check "examples/cuda compiles $precision" nvcc -std=c++14 -O3 $options $precision -I. examples/cuda/oscillators.cu -o "$build/oscillators"
    check "examples/cuda: the bits of the CPU $precision" "$build/oscillators"
    cat "$build/log" # its times
done
check_finish gpu
