#!/bin/sh
# The headers from other languages, where their compilers are: C++, CUDA (compiled, and run where a GPU is), WebAssembly with
# the bits of the native program, Python. usage: CC=compiler test_languages.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/languages
. tests/check.sh
skipped=0
skip() { skipped=$((skipped + $1)); echo "skipped: $2"; }

if command -v g++ >/dev/null; then
    check "C++: the consumer builds" g++ -std=c++11 -Wall -Wextra -Werror -x c++ -I. examples/package/consumer/main.c -o "$build/consumer"
    $cc -std=c99 -I. examples/package/consumer/main.c -o "$build/consumer_c" -lm
    check "C++: prints what C prints" sh -c '[ "$($1)" = "$($2)" ]' sh "$build/consumer" "$build/consumer_c"
else
    skip 2 "C++: no g++"
fi

same_bits() { # the browser's module and the native program
    "$build/leaking" | sed 's/e\([-+]\)0/e\1/g' >"$build/native" && node examples/wasm/leaking.mjs "$build/leaking.wasm" >"$build/wasm" &&
        [ -s "$build/wasm" ] && cmp "$build/native" "$build/wasm"
}
wasm="clang --target=wasm32-wasi --sysroot=/usr -std=c99 -ffp-contract=off -Oz -mexec-model=reactor -Wl,-s examples/wasm/leaking.c -lm"
if command -v node >/dev/null && $wasm -o "$build/leaking.wasm" 2>"$build/log"; then
    $cc -std=c99 -ffp-contract=off -O2 examples/wasm/leaking.c -o "$build/leaking" -lm
    check "WebAssembly: no imports, the same bits" same_bits
else
    skip 1 "WebAssembly: no clang for it, or no node"
fi

if command -v python3 >/dev/null; then
    export PYTHONDONTWRITEBYTECODE=1 CC="$cc"
    check "Python: examples/python/swing.py" python3 examples/python/swing.py
    check "Python: examples/python/cost.py" python3 examples/python/cost.py
    check "Python: the module's functions" python3 tests/python_module.py
else
    skip 3 "Python: not here"
fi

if command -v nvcc >/dev/null; then
    check "CUDA: builds" nvcc -std=c++14 -O3 -fmad=false -Werror all-warnings -I. examples/cuda/oscillators.cu -o "$build/oscillators"
    for header in jacobi ateb integrators varmass; do
        printf '#define VM_API static inline __host__ __device__\n#include "%s.h"\n' $header >"$build/$header.cu"
        check "CUDA: $header.h" nvcc -std=c++14 -I. -c "$build/$header.cu" -o "$build/$header.o"
    done
    if command -v nvidia-smi >/dev/null && nvidia-smi >/dev/null 2>&1; then
        check "CUDA: runs" "$build/oscillators"
    else
        skip 1 "CUDA: no GPU to run on"
    fi
else
    skip 6 "CUDA: no nvcc"
fi
echo "languages: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
