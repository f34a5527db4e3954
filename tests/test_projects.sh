#!/bin/sh
# The headers in other people's projects. Under their compilers' warnings, more than our own lint has, the headers are silent,
# and the project's own files are not silenced; our own warnings still see into the headers. Files in float and in double
# that would pass structs to each other do not link. Compilers of Windows, as far as clang can stand for Microsoft's.
# usage: CC=compiler test_projects.sh BUILD_FOLDER, from the top of the project
build=$1/projects
. tests/check.sh
skipped=0
has() { command -v "$1" >/dev/null || { skipped=$((skipped + 1)); echo "skipped: no $1"; false; }; }

# ---- warnings ----

# what gcc knows beyond -Wall -Wextra, for both languages, for C++ and for C; clang has -Weverything
both="-Wall -Wextra -Wpedantic -Wcast-align=strict -Wcast-qual -Wconversion -Wsign-conversion -Wdouble-promotion -Wfloat-conversion \
-Wfloat-equal -Wformat=2 -Wlogical-op -Wduplicated-cond -Wduplicated-branches -Wnull-dereference -Wshadow -Wswitch-default \
-Wswitch-enum -Wundef -Wredundant-decls -Wmissing-declarations -Wpadded -Wunused-macros -Wstrict-overflow=5"
of_cpp="-Wold-style-cast -Wuseless-cast -Wzero-as-null-pointer-constant -Wsign-promo -Weffc++ -Woverloaded-virtual -Wextra-semi"
of_c="-Wbad-function-cast -Wc++-compat -Wdeclaration-after-statement -Wmissing-prototypes -Wold-style-definition \
-Wstrict-prototypes -Wvla -Wwrite-strings"
silent_as_c() { # silent_as_c FILE FLAG...
    gcc -std=c99 $both $of_c -Werror -I. -x c "$@"
}
silent_as_cpp() { g++ -std=c++11 $both $of_cpp -Werror -I. -x c++ "$@"; }
silent_for_clang() { # silent_for_clang COMPILER STANDARD FILE FLAG... : C++98 is no aim
    compiler=$1 standard=$2
    shift 2
    $compiler -std="$standard" -Weverything -Wno-c++98-compat -Wno-c++98-compat-pedantic -Werror -I. -fsyntax-only "$@"
}
# what a project of this kind writes: constants, macros, statuses, arrays of work
cat >"$build/user.h" <<'END'
#include "varmass.h"
int project(const vm_body *whole, const vm_body *part, vm_real *result);
int project(const vm_body *whole, const vm_body *part, vm_real *result)
{
    vm_real work[RK45_WORK(2)], best = VM_INFINITY, none = VM_NAN, tenth = VM_C(0.1), circle = 2 * VM_PI;
    vm_body rest = *whole;
    int status = vm_separate(whole, part, VM_NOTHING, &rest);
    work[0] = VM_EPSILON;
    work[1] = VM_MAX;
    if (status == VM_OK) work[0] = rest.omega.z;
    *result = work[0] + work[1] + best + none + tenth + circle;
    return status;
}
END
printf '#include "varmass.h"\n' >"$build/varmass.x" # with the other three headers
sh src/part.sh "$build/part.h" mechanics/jumps oscillators/closed && printf '#include "part.h"\n' >"$build/part.x"
sed '1i #include <stddef.h>\n#define VM_NOTHING NULL' "$build/user.h" >"$build/user_c.x"
sed '1i #define VM_NOTHING nullptr' "$build/user.h" >"$build/user_cpp.x"
for precision in "" -DVM_USE_FLOAT; do
    for source in varmass part user_c; do
        has gcc && check "$source in C, all of gcc's warnings $precision" silent_as_c "$build/$source.x" -fsyntax-only $precision
        has clang && check "$source in C, all of clang's warnings $precision" silent_for_clang clang c99 -x c "$build/$source.x" $precision
    done
    for source in varmass part user_cpp; do
        has g++ && check "$source in C++, all of g++'s warnings $precision" silent_as_cpp "$build/$source.x" -fsyntax-only $precision
        has clang++ && for standard in c++11 c++20; do
            check "$source in C++, all of clang++'s warnings, $standard $precision" \
                silent_for_clang clang++ $standard -x c++ "$build/$source.x" $precision
        done
    done
done
has gcc && check "varmass in C: -Wunsuffixed-float-constants" silent_as_c "$build/varmass.x" -fsyntax-only -Wunsuffixed-float-constants
# some warnings come from the optimiser
has gcc && check "varmass in C, all of gcc's warnings, -O2" silent_as_c "$build/user_c.x" -O2 -c -o "$build/silent.o"
# what is silenced in the headers is silenced there only
for warning in old-style-cast:"int f(double x); int f(double x) { return (int)x; }" \
    float-equal:"bool g(double x); bool g(double x) { return x == 1; }"; do
    printf '#include "varmass.h"\n%s\n' "${warning#*:}" >"$build/after.x"
    for compiler in g++ clang++; do
        has $compiler && check "$compiler: -W${warning%%:*} still warns of the project's own files" fails \
            $compiler -std=c++11 -W${warning%%:*} -Werror -I. -fsyntax-only -x c++ "$build/after.x"
    done
done
# our own warnings see into the headers
awk '{print} /^VMI_QUIET_BEGIN/ {n++} n && /^#define VARMASS_JACOBI_INTEGRALS_H/ {print "static inline int vmi_planted(double x) { return x; }"}' \
    jacobi.h >"$build/planted.h"
printf '#include "planted.h"\n' >"$build/planted.x"
for compiler in gcc clang; do
    has $compiler && check "$compiler: the lint sees a conversion that is planted in a header" fails \
        $compiler -std=c99 -Wconversion -Werror -fsyntax-only -x c "$build/planted.x"
done

# ---- float and double ----

# half FILE PRECISION ROLE : a file of a program whose one half calls the other with a body
cat >"$build/half.x" <<'END'
#include "varmass.h"
void shared(vm_body *body);
#ifdef CALLER
int main(void)
{
    vm_body body = {5, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
    shared(&body);
    return body.mass < 0;
}
#else
void shared(vm_body *body) { body->mass = 1; }
#endif
END
links() { # links "COMPILER LANGUAGE FLAGS" CALLER_FLAGS CALLED_FLAGS
    $1 -I. -DCALLER $2 -c "$build/half.x" -o "$build/caller.o" && $1 -I. $3 -c "$build/half.x" -o "$build/called.o" || {
        echo "does not compile"
        return 2
    }
    ${1%% -x*} "$build/caller.o" "$build/called.o" -o "$build/halves" -lm
}
does_not_link() { # the same arguments; that a file does not compile is no success
    links "$@" >"$build/halves.log" 2>&1
    [ $? = 1 ] && grep -q -e varmass_in_float_and_in_double -e 'undefined.*shared' "$build/halves.log"
}
one_and_two() { # one_and_two NAME COMPILER_AND_FLAGS : files of one precision link, files of both do not
    check "$1: two files in double link" links "$2" "" ""
    check "$1: two files in float link" links "$2" -DVM_USE_FLOAT -DVM_USE_FLOAT
    check "$1: double that calls float does not link" does_not_link "$2" "" -DVM_USE_FLOAT
    check "$1: float that calls double does not link" does_not_link "$2" -DVM_USE_FLOAT ""
}
c="-x c -std=c99" cpp="-x c++ -std=c++11"
echo 'int main(void) { return 0; }' >"$build/linker.c"
if has gcc; then
    one_and_two "gcc" "gcc $c"
    one_and_two "gcc -flto" "gcc -flto -O2 $c"
    for linker in gold lld; do # where they are installed
        gcc -fuse-ld=$linker "$build/linker.c" -o "$build/linker" 2>/dev/null && one_and_two "gcc, $linker" "gcc -fuse-ld=$linker $c"
    done
    check "gcc: VM_MIXED_PRECISIONS links both" links "gcc $c" "" "-DVM_USE_FLOAT -DVM_MIXED_PRECISIONS"
fi
for compiler in g++ clang++; do
    has $compiler && one_and_two "$compiler" "$compiler $cpp" # structs of other precisions have other names in C++
done
has g++ && check "g++: a function is not taken for one in the other precision, not by VM_MIXED_PRECISIONS either" does_not_link \
    "g++ $cpp" "" "-DVM_USE_FLOAT -DVM_MIXED_PRECISIONS"
if clang -flto -fuse-ld=lld "$build/linker.c" -o "$build/linker" 2>/dev/null; then
    check "clang -flto links what is in one precision" links "clang -flto -fuse-ld=lld -O2 $c" "" ""
fi
has arm-none-eabi-gcc && one_and_two "Cortex-M4F" "arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 --specs=nosys.specs $c"
has avr-gcc && one_and_two "AVR" "avr-gcc -mmcu=atmega1284p -Os $c"
has x86_64-w64-mingw32-gcc && one_and_two "mingw" "x86_64-w64-mingw32-gcc $c"

# ---- Microsoft's compilers ----

# clang reads and compiles for Microsoft's targets; of Microsoft's own headers stand here the few lines that are needed
mkdir "$build/microsoft"
cat >"$build/microsoft/math.h" <<'END'
#ifdef __cplusplus
extern "C" {
#endif
#define INFINITY ((float)(1e300 * 1e300))
#define NAN (-(float)(INFINITY * 0.0F))
double sqrt(double), fabs(double), floor(double), copysign(double, double);
float sqrtf(float), fabsf(float), floorf(float), copysignf(float, float);
#ifdef __cplusplus
}
#endif
END
cat >"$build/microsoft/string.h" <<'END'
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif
void *memcpy(void *, const void *, size_t), *memmove(void *, const void *, size_t), *memset(void *, int, size_t);
int memcmp(const void *, const void *, size_t);
#ifdef __cplusplus
}
#endif
END
cat >"$build/library.x" <<'END'
#include <string.h>
int _fltused; /* the linker asks for it where numbers have a point */
void *memcpy(void *to, const void *from, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) ((char *)to)[i] = ((const char *)from)[i];
    return to;
}
END
microsoft="--target=x86_64-pc-windows-msvc -fms-compatibility -fms-extensions -nostdlibinc -isystem $build/microsoft"
reads_as_microsoft() { # reads_as_microsoft LANGUAGE STANDARD HEADER FLAG... : no extension of another compiler is used
    language=$1 standard=$2 header=$3
    shift 3
    clang $microsoft -x $language -std=$standard -Wall -Wextra -Wpedantic -Werror -I. "$@" -fsyntax-only "$build/$header.x"
}
links_as_microsoft() { # links_as_microsoft CALLER_FLAGS CALLED_FLAGS : with the little of a C library that is called
    clang $microsoft -x c -std=c11 -O1 -I. -DCALLER $1 -c "$build/half.x" -o "$build/caller.obj" &&
        clang $microsoft -x c -std=c11 -O1 -I. $2 -c "$build/half.x" -o "$build/called.obj" &&
        clang $microsoft -x c -std=c11 -ffreestanding -c "$build/library.x" -o "$build/library.obj" || return 2
    lld-link -nodefaultlib -entry:main -subsystem:console "-out:$build/halves.exe" "$build/caller.obj" "$build/called.obj" \
        "$build/library.obj"
}
microsoft_refuses() {
    links_as_microsoft "$@" >"$build/halves.log" 2>&1
    [ $? = 1 ] && grep -q 'varmass in float and in double' "$build/halves.log"
}
if has clang; then
    for header in varmass part; do
        for precision in "" -DVM_USE_FLOAT; do
            check "$header for Microsoft's C11 $precision" reads_as_microsoft c c11 $header $precision
            check "$header for Microsoft's C17, 32 bits $precision" reads_as_microsoft c c17 $header $precision --target=i686-pc-windows-msvc
            check "$header for Microsoft's C++14 $precision" reads_as_microsoft c++ c++14 $header $precision
            check "$header for Microsoft's C++20 $precision" reads_as_microsoft c++ c++20 $header $precision
        done
    done
    if has lld-link; then
        check "Microsoft: two files in float link" links_as_microsoft -DVM_USE_FLOAT -DVM_USE_FLOAT
        check "Microsoft: float and double do not link" microsoft_refuses -DVM_USE_FLOAT ""
        check "Microsoft: VM_MIXED_PRECISIONS links both" links_as_microsoft "" "-DVM_USE_FLOAT -DVM_MIXED_PRECISIONS"
    fi
fi
echo "projects: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
