#!/bin/sh
# The page of examples/wasm/play.html: its program gives the bits of the native one, the page is one file of less than
# 300 kB, and where Chromium is installed it computes and draws, in a wide and in a narrow window, from the disk.
# usage: CC=compiler test_page.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/page
. tests/check.sh
skipped=0
if ! sh tests/install.sh -w "for the page in a browser" \
    "command -v clang && test -e /usr/lib/wasm32-wasi/libc.a && command -v node" clang lld wasi-libc libclang-rt-14-dev-wasm32 nodejs; then
    echo "page: 0 passed, 0 failed, 5 skipped"
    exit 0
fi
same_bits() {
    $cc -std=c99 -O2 -ffp-contract=off examples/wasm/play.c -o "$build/play" -lm && "$build/play" >"$build/native" &&
        node examples/wasm/play.mjs build/wasm/play.wasm >"$build/wasm" && [ "$(wc -l <"$build/native")" -gt 20 ] &&
        diff "$build/native" "$build/wasm"
}
size() { [ "$(wc -c <build/wasm/play.html)" -lt 300000 ]; }
browser() { # in a window of this width the page says by which route it computed x(60 s), and nothing stands out to the right
    rm -rf "$build/browser"
    timeout 120 node tests/page.mjs "file://$PWD/build/wasm/play.html" "$build/browser" "$1" >"$build/said" && [ "$(cat "$build/said")" = "$1 order 3 $1" ]
}
check "make wasm" make -s wasm
check "the bits of the native program" same_bits
check "one file of less than 300 kB" size
if command -v chromium >/dev/null; then
    check "in a wide window" browser 1100
    check "in a narrow window" browser 380
else
    skipped=2
fi
echo "page: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
