#!/bin/sh
# Write the packages of a release under BUILD/packages: `varmass`, one folder that is a library for the Arduino IDE and for
# PlatformIO, and varmass-VERSION.tar.xz, the headers with all their parts, with its SHA-256 checksum beside it.
# usage: CC=compiler packages.sh BUILD VERSION, from the top of the project, after `make headers amalgamation`
set -e
cc=${CC:-cc} packages=$1/packages version=$2 from=examples/package/arduino
library=$packages/varmass release=$packages/varmass-$version
rm -rf "$packages"
mkdir -p "$library/src" "$library/examples" "$release"

# The library has the one header that holds all four, since the Arduino IDE shows one line to include.
cp "$1/amalgamation/varmass.h" "$library/src"
cp LICENSE "$library"
cp -r $from/split $from/leak "$library/examples"
for file in library.properties library.json; do
    sed "s|@VERSION@|$version|" "$from/$file.in" >"$library/$file"
done
# The words that the editor colours: types of the public interface, then its functions, as the headers' index has them.
{
    grep -ho '^} [a-z]*_[a-z0-9_]*;$' varmass.h ateb.h jacobi.h integrators.h | tr -d '}; ' | grep -v '^vmi_' | sort -u |
        sed 's/$/\tKEYWORD1/'
    grep -ho '^VM_API .*[ *]\(vm\|ateb\|jacobi\|rk4\|rk45\|rk87\|ode\)_[a-z0-9_]*(' varmass.h ateb.h jacobi.h integrators.h |
        sed 's/.*[ *]\([a-z0-9_]*\)($/\1/' | sort -u | sed 's/$/\tKEYWORD2/'
} >"$library/keywords.txt"
$cc -std=c99 -DVM_USE_FLOAT examples/print_plan.c -o "$packages/print_plan" -lm
"$packages/print_plan" closed 3 10 -0.1 100 0 1 0 0.1 0 3 30 >"$library/examples/leak/plan.h"
rm "$packages/print_plan"

cp varmass.h ateb.h jacobi.h integrators.h LICENSE README.md docs/changes.md CMakeLists.txt meson.build "$release"
mkdir "$release/one" "$release/examples"
cp -r examples/package "$release/examples" # what CMakeLists.txt installs
cp "$1/amalgamation/varmass.h" "$release/one"
for chapter in src/*/*.h; do
    part=${chapter#src/}
    part=${part%.h}
    sh src/part.sh "$packages/parts/$(echo "$part" | tr / _).h" "$part"
done >/dev/null
mv "$packages/parts" "$release"
# The same files give the same archive, byte for byte.
(cd "$packages" && tar --sort=name --mtime=2000-01-01 --owner=0 --group=0 --numeric-owner -cf - "varmass-$version" |
    xz -T1 >"varmass-$version.tar.xz" && sha256sum "varmass-$version.tar.xz" >"varmass-$version.tar.xz.sha256")
rm -r "$release"
echo "$packages: varmass (Arduino, PlatformIO), varmass-$version.tar.xz"
