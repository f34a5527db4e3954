#!/bin/sh
# Abstract interpretation by Frama-C's EVA of the four headers: each function eva_... of tests/eva_HEADER.c is a program of
# its own, which calls public functions with any numbers. Those public functions of varmass.h that no program calls are in
# tests/eva_left_out.txt. What EVA cannot exclude is an alarm; those in tests/eva.txt are accepted, by program, function and
# kind, with their reason. Any other fails, as does a line there that nothing needs.
# usage: eva.sh BUILD_FOLDER [PROGRAM...], from the top of the project; PROGRAM like jacobi.am, none: all
build=$1/eva
headers='jacobi ateb integrators varmass'
shift
. tests/check.sh
sh tests/install.sh "command -v frama-c" frama-c-base || { echo "EVA: 0 passed, 0 failed, 1 skipped"; exit 0; }

# The header and what calls it, as Frama-C prints them: with sums and products in two words by their theorems
# (tests/eva_words.h), with conditions that exclude NaN (tests/eva.awk), and with two hints: the levels that vmi_agm reached
# are kept apart, and the loops that fill the series of a plan are unrolled.
words='two_sum\|fast_two_sum\|two_product\|two_over'
prepare() { # prepare HEADER
    frama-c -cpp-extra-args="-std=c99 -I. -U__GNUC__" -c11 "tests/eva_$1.c" -print -ocode "$build/printed.c" || return 1
    {
        echo 'int impossible(void);'
        sed "s/^__inline static vm_two vmi_\($words\)(\(.*\))\$/vm_two vmi_\1(\2); static vm_two as_written_\1(\2)/
             s/\<eva_\($words\)(/vmi_\1(/
             s/^ *l->n = n;\$/& \/*@ split n; *\//
             s/^ *while ([jk] < VMI_ATEB_TERMS/\/*@ loop unroll 60; *\/ &/" "$build/printed.c" | awk -f tests/eva.awk
    } >"$build/$1.c"
}

programs() { sed -n "s/^void eva_\([a-zA-Z0-9_]*\)(void)\$/$1.\1/p" "$build/$1.c"; }

public() { # public HEADER: the names of its public functions
    case $1 in
    jacobi) prefix=jacobi ;;
    ateb) prefix=ateb ;;
    integrators) prefix='\(rk4\|rk45\|rk87\|ode\)' ;;
    varmass) prefix=vm ;;
    esac
    sed -n "s/^VM_\(API\|INLINE\) [^(]*\<\(${prefix}_[a-zA-Z0-9_]*\)(.*/\2/p" "$1.h" | sort -u
}
complete() { # complete HEADER: every public function is called, or left out on purpose
    sed -n '/^vm_real volatile any;/,$p' "$build/$1.c" >"$build/calls"
    grep -v '^#' tests/eva_left_out.txt | grep . >"$build/left_out"
    for name in $(public "$1"); do
        called=$(grep -c "\<$name(" "$build/calls")
        grep -qx "$name" "$build/left_out" && left=1 || left=0
        [ "$called" -eq 0 ] || [ $left -eq 0 ] || { echo "$name is called, and in tests/eva_left_out.txt"; return 1; }
        [ "$called" -gt 0 ] || [ $left -eq 1 ] || { echo "$name is not called"; return 1; }
    done
}

options() { # options HEADER
    echo "-c11 -warn-special-float none -eva-domains cvalue,symbolic-locations -eva-subdivide-non-linear 20 -eva-plevel 100" \
        "-eva-auto-loop-unroll 40 -eva-interprocedural-splits -eva-split-return auto"
    case $1 in
    jacobi)
        echo "-eva-slevel 30 -eva-slevel-function vmi_agm:200,jacobi_agm_sncndn:500,vmi_descend:500" \
            "-eva-split-return-function vmi_plan_init:0,jacobi_plan_init:0,jacobi_plan_init_m1:0" ;;
    ateb)
        series="vmi_ateb_series:0,vmi_ateb_series_power:0,vmi_ateb_economise:0,vmi_remove_highest:0"
        echo "-eva-slevel 30 -eva-slevel-function ateb_plan_init_to:20,vmi_ateb_part_init:0,$series" \
            "-eva-subdivide-non-linear-function $series -eva-split-return-function ateb_plan_init_to:0" ;;
    integrators)
        echo "-eva-slevel-function vmi_init:20,vmi_ode_init:20,rk45_init:20,rk87_init:20" \
            "-eva-slevel-function $(for i in rk45 rk87; do for j in "" _event _saved _at; do printf "eva_%s%s:20," $i $j; done; done | sed "s|,\$||")" \
            "-eva-split-return-function vmi_init:0,vmi_ode_init:0,rk45_init:0,rk87_init:0" ;;
    varmass) echo "-eva-slevel 10" ;;
    esac
}

command_for() { # command_for PROGRAM, which leaves a table when it comes to its end
    echo "frama-c -eva $(options ${1%%.*} | paste -s -d ' ') -main eva_${1#*.} $build/${1%%.*}.c -then -report-csv $build/$1.csv" \
        ">$build/$1.log 2>&1"
}

# Of this table program, function, kind and property of what is not proved; clauses are those of Frama-C's own library
alarms() { # alarms PROGRAM
    awk -F '\t' -v OFS='\t' -v program="$1" '
        NR > 1 && $6 ~ /Unknown|[Ii]nvalid/ && $5 !~ / clause$/ { print program, $4, $5, $7 }' "$build/$1.csv"
}

# The alarms that no line of tests/eva.txt accepts, or, for LEFT=lines, its lines that accept none
left() { # left LEFT
    awk -F '\t' -v left="$1" '
        FNR == NR { if ($0 !~ /^#/) { line[++n] = $0; program[n] = "^(" $1 ")$"; what[n] = $2 "\t" $3 } next }
        {
            accepted = 0
            for (i = 1; i <= n; i++)
                if ($1 ~ program[i] && $2 "\t" $3 == what[i]) accepted = used[i] = 1
            if (!accepted && left == "alarms") print
        }
        END { if (left == "lines") for (i = 1; i <= n; i++) if (!used[i]) print line[i] }' tests/eva.txt "$build/alarms" >"$build/left"
    cat "$build/left"
    test ! -s "$build/left"
}

# How many of the header's functions its programs reach; those that tests/eva_words.h replaces do not count
analysed() { # analysed HEADER
    sed -n '/);$/d; s/^VMI*_[A-Z]* [^(]*\<\([a-z][a-zA-Z0-9_]*\)(.*/\1/p' "$1.h" | sort -u >"$build/functions"
    sed -n 's/.*Values at end of function \(.*\):$/\1/p' "$build/$1".*.log | grep -vx "vmi_\($words\)" | sort -u >"$build/reached"
    echo "$1.h: $(comm -12 "$build/functions" "$build/reached" | wc -l) of $(wc -l <"$build/functions") functions analysed"
}

for header in $headers; do
    check "EVA: $header.h is understood" prepare $header
    check "EVA: every public function of $header.h is called" complete $header
done
: >"$build/alarms"
some=${*:-$(for header in $headers; do programs $header; done)}
for program in $some; do command_for $program; done | xargs -P "$(nproc 2>/dev/null || echo 2)" -I{} sh -c '{}'
for program in $some; do
    check "EVA: $program to its end" alarms $program
    cat "$build/log" >>"$build/alarms"
done
for header in $headers; do
    echo "$header.h: $(cut -f1,2,3 "$build/alarms" | grep "^$header\." | cut -f2,3 | sort -u | wc -l) kinds of alarms, in" \
        "$(grep "^$header\." "$build/alarms" | cut -f2 | sort -u | wc -l) functions"
    analysed $header
done
check "EVA: alarms are accepted" left alarms
[ $# -gt 0 ] || check "EVA: what is accepted occurs" left lines
check_finish EVA
